"""The last frame of a results file (VTKHDF, unstructured grid), and integrals over faces of its tetrahedra."""

import h5py
import numpy as np

TET4, TET10 = 10, 24
CORNERS = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]
# Middle node of each edge of a ten-node tetrahedron.
MIDDLE = {(0, 1): 4, (1, 2): 5, (0, 2): 6, (0, 3): 7, (1, 3): 8, (2, 3): 9}


class Frame:
    """Points [L], cells by VTK type and point fields of the last frame of a file."""

    def __init__(self, path):
        with h5py.File(path) as file:
            root = file["VTKHDF"]
            count = int(root["NumberOfPoints"][-1])
            self.points = root["Points"][-count:]
            self.cells = cells_by_type(root)
            self.fields = {name: last_rows(root, name, count) for name in root["PointData"]}

    def field(self, name):
        """A point field; undefined values (NaN) read as zero."""
        if name not in self.fields:
            raise SystemExit(f"no field {name} in the file; it holds {', '.join(self.fields)}")
        return np.nan_to_num(self.fields[name])

    def corners(self):
        """Which points are corners of tetrahedra (not in the middle of an edge)."""
        found = np.zeros(len(self.points), bool)
        for kind in (TET4, TET10):
            found[self.cells.get(kind, np.empty((0, 10), int))[:, :4]] = True
        return found

    def outer_faces(self, chosen):
        """Faces that belong to one tetrahedron only and whose corners are all chosen, shape (n, 3) or (n, 6);
        `chosen` says it of each point."""
        found = {}
        for kind, corners in ((kind, corners) for kind in (TET4, TET10) for corners in CORNERS):
            cells = self.cells.get(kind, np.empty((0, 10), int))
            local = list(corners)
            if kind == TET10:
                local += [MIDDLE[tuple(sorted((corners[i], corners[(i + 1) % 3])))] for i in range(3)]
            for face in cells[chosen[cells[:, corners]].all(axis=1)][:, local]:
                key = tuple(sorted(face))
                found[key] = None if key in found else face
        return np.array([face for face in found.values() if face is not None])


def last_rows(root, name, count):
    """Rows of a point field that belong to the last frame."""
    start = 0
    if "Steps" in root and f"PointDataOffsets/{name}" in root["Steps"]:
        start = int(np.ravel(root["Steps"][f"PointDataOffsets/{name}"])[int(root["Steps"].attrs["NSteps"]) - 1])
    return root["PointData"][name][start : start + count]


def cells_by_type(root):
    """Connectivity of the last part, shape (cells, nodes of a cell), by VTK's number of the type."""
    count = int(root["NumberOfCells"][-1])
    offsets = root["Offsets"][-count - 1 :]
    connectivity = root["Connectivity"][-int(root["NumberOfConnectivityIds"][-1]) :]
    types = root["Types"][-count:]
    cells = {}
    for kind in np.unique(types):
        chosen = np.flatnonzero(types == kind)
        nodes = offsets[chosen[0] + 1] - offsets[chosen[0]]
        cells[int(kind)] = connectivity[offsets[chosen][:, None] + np.arange(nodes)]
    return cells


def integral(points, faces, function):
    """∫ f dA over three- or six-node triangles. f takes one position a face, shape (faces, 3), and the shares of the
    three corners in it."""
    total = 0.0
    for weight, r, s in radon():
        t = 1.0 - r - s
        if faces.shape[1] == 3:
            shape = [t, r, s]
            derivatives = [[-1.0, 1.0, 0.0], [-1.0, 0.0, 1.0]]
        else:
            shape = [t * (2 * t - 1), r * (2 * r - 1), s * (2 * s - 1), 4 * t * r, 4 * r * s, 4 * s * t]
            derivatives = [
                [1.0 - 4.0 * t, 4.0 * r - 1.0, 0.0, 4.0 * (t - r), 4.0 * s, -4.0 * s],
                [1.0 - 4.0 * t, 0.0, 4.0 * s - 1.0, -4.0 * r, 4.0 * r, 4.0 * (t - s)],
            ]
        tangents = np.einsum("dn,fnx->fdx", np.array(derivatives), points[faces])
        areas = weight * np.linalg.norm(np.cross(tangents[:, 0], tangents[:, 1]), axis=1)
        total += (areas * function(np.einsum("n,fnx->fx", shape, points[faces]), np.array([t, r, s]))).sum()
    return total


def radon():
    """Weight (sum ½) and coordinates of the points of the rule of degree five on the unit triangle (Radon 1948)."""
    root = np.sqrt(15.0)
    points = [(9.0 / 80.0, 1.0 / 3.0, 1.0 / 3.0)]
    for c, weight in (((6.0 - root) / 21.0, (155.0 - root) / 2400.0), ((6.0 + root) / 21.0, (155.0 + root) / 2400.0)):
        points += [(weight, c, c), (weight, 1.0 - 2.0 * c, c), (weight, c, 1.0 - 2.0 * c)]
    return points

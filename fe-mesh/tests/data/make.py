"""Makes the meshes of this folder with gmsh 4.15: `python make.py`, in this folder."""

import gmsh

ENCODINGS = {"41": (4.1, 0), "41b": (4.1, 1), "22": (2.2, 0), "22b": (2.2, 1)}


def save(name, encodings=tuple(ENCODINGS)):
    for encoding in encodings:
        version, binary = ENCODINGS[encoding]
        gmsh.option.setNumber("Mesh.MshFileVersion", version)
        gmsh.option.setNumber("Mesh.Binary", binary)
        gmsh.write(f"{name}_{encoding}.msh")


def box_faces(volume, axis, value):
    """Tags of the faces of a volume in the plane axis = value."""
    found = []
    for _, face in gmsh.model.getBoundary([(3, volume)], oriented=False):
        box = gmsh.model.getBoundingBox(2, face)
        if abs(box[axis] - value) < 1e-6 and abs(box[axis + 3] - value) < 1e-6:
            found.append(face)
    return found


def two_blocks(hexahedra, order, incomplete=0):
    """Two boxes on each other with a common face; the upper one is a little oblique, so that no coordinate is round."""
    gmsh.clear()
    occ = gmsh.model.occ
    occ.addBox(0, 0, 0, 1, 1, 1)
    occ.addBox(0, 0, 1, 1, 1, 1)
    occ.fragment([(3, 1)], [(3, 2)])
    occ.synchronize()
    lower, upper = 1, 2
    (interface,) = box_faces(lower, 2, 1)
    (bottom,), (top,) = box_faces(lower, 2, 0), box_faces(upper, 2, 2)
    sides = [f for v in (lower, upper) for x in (0, 1) for f in box_faces(v, 0, x)]
    group = gmsh.model.addPhysicalGroup
    group(3, [lower], 1, "Lower block")
    group(3, [upper], 2, "Upper")
    group(3, [lower, upper], 7, "All")
    group(2, [bottom], 1, "Bottom face")
    group(2, [top], 2, "Top")
    group(2, [interface], 3, "Interface")
    group(2, sides + [bottom], 5)
    group(1, [gmsh.model.getBoundary([(2, top)], oriented=False)[0][1]], 4, "Edge")
    group(0, [gmsh.model.getBoundary([(1, 1)])[0][1]], 9, "Corner")
    gmsh.option.setNumber("Mesh.MeshSizeMin", 2)
    gmsh.option.setNumber("Mesh.MeshSizeMax", 2)
    if hexahedra:
        for _, curve in gmsh.model.getEntities(1):
            gmsh.model.mesh.setTransfiniteCurve(curve, 3)
        for _, face in gmsh.model.getEntities(2):
            gmsh.model.mesh.setTransfiniteSurface(face)
            gmsh.model.mesh.setRecombine(2, face)
        for _, volume in gmsh.model.getEntities(3):
            gmsh.model.mesh.setTransfiniteVolume(volume)
    gmsh.option.setNumber("Mesh.SecondOrderIncomplete", incomplete)
    gmsh.model.mesh.generate(3)
    gmsh.model.mesh.setOrder(order)
    turn = [1, 0.1, 0.03, 0, 0.07, 0.9, 1 / 7, 0, 0.01, -1 / 3, 1.1, 0]
    gmsh.model.mesh.affineTransform(turn)


def plane():
    """A plate, triangles on the left and quadrangles on the right."""
    gmsh.clear()
    occ = gmsh.model.occ
    occ.addRectangle(0, 0, 0, 1, 1)
    occ.addRectangle(1, 0, 0, 1, 1)
    occ.fragment([(2, 1)], [(2, 2)])
    occ.synchronize()
    for _, curve in gmsh.model.getEntities(1):
        gmsh.model.mesh.setTransfiniteCurve(curve, 4)
    gmsh.model.mesh.setTransfiniteSurface(1)
    gmsh.model.mesh.setTransfiniteSurface(2)
    gmsh.model.mesh.setRecombine(2, 2)
    left = [c for _, c in gmsh.model.getBoundary([(2, 1)], oriented=False)]
    right = [c for _, c in gmsh.model.getBoundary([(2, 2)], oriented=False)]
    common = [c for c in left if c in right]
    gmsh.model.addPhysicalGroup(2, [1], 1, "left")
    gmsh.model.addPhysicalGroup(2, [2], 2, "right")
    gmsh.model.addPhysicalGroup(1, common, 1, "seam")
    gmsh.model.addPhysicalGroup(1, [c for c in left + right if c not in common], 2, "rim")
    gmsh.option.setNumber("Mesh.SecondOrderIncomplete", 0)
    gmsh.model.mesh.generate(2)


def every_kind():
    """One element of every kind that is read, at gmsh's own reference coordinates, each shifted by 4 in x."""
    gmsh.clear()
    node, element = 1, 1
    # Numbers follow the entities, as those of format 2.2 do.
    kinds = sorted((gmsh.model.mesh.getElementProperties(number)[1], number) for number in range(1, 20))
    for dimension, number in kinds:
        _, _, _, nodes, local, _ = gmsh.model.mesh.getElementProperties(number)
        entity = gmsh.model.addDiscreteEntity(dimension, number)
        tags = list(range(node, node + nodes))
        coordinates = []
        for i in range(nodes):
            point = list(local[dimension * i : dimension * (i + 1)]) + [0.0] * (3 - dimension)
            coordinates += [point[0] + 4.0 * number, point[1], point[2]]
        gmsh.model.mesh.addNodes(dimension, entity, tags, coordinates)
        gmsh.model.mesh.addElements(dimension, entity, [number], [[element]], [tags])
        gmsh.model.addPhysicalGroup(dimension, [entity], number, f"type {number}")
        node, element = node + nodes, element + 1


gmsh.initialize()
gmsh.option.setNumber("General.Verbosity", 2)
two_blocks(False, 1)
save("tetrahedra")
gmsh.model.mesh.partition(2)
save("partitioned")
two_blocks(False, 2)
save("tetrahedra_2")
two_blocks(True, 1)
save("hexahedra")
two_blocks(True, 2, incomplete=1)
save("hexahedra_2")
plane()
save("plane")
# Tags far apart: renumbered by hand.
tags = gmsh.model.mesh.getNodes()[0]
gmsh.model.mesh.renumberNodes(list(tags), [int(1000003 * t + 5) for t in tags])
save("sparse", ("41", "41b"))
every_kind()
save("every_kind")
gmsh.finalize()

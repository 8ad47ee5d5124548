"""Writes the deck of the poured balls: rubber balls that fall over a block into a box, under general contact.

    balls.py OUT.inp [--layers 8] [--size 3.0] [--time 0.12]

Units mm, t, s, N. One ball is meshed with gmsh (C3D4) and copied, each copy turned by an angle of its own and set off the
lattice by a little; the box is made of rigid facets, the block on its floor of C3D8R. The sequence of numbers is fixed: the same deck each time.
"""

import argparse

import gmsh
import numpy as np

RADIUS = 10.0
# Half width of the box and its height.
HALF, HEIGHT = 58.0, 130.0
# Half width of the block and its height.
FOOT, TIP = 24.0, 24.0


def ball(size):
    """Nodes and tetrahedra of a ball around the origin, with edges of about `size`."""
    gmsh.initialize()
    gmsh.option.setNumber("General.Verbosity", 1)
    gmsh.option.setNumber("General.NumThreads", 1)
    gmsh.option.setNumber("Mesh.MeshSizeMin", size)
    gmsh.option.setNumber("Mesh.MeshSizeMax", size)
    gmsh.option.setNumber("Mesh.OptimizeNetgen", 1)
    gmsh.model.occ.addSphere(0.0, 0.0, 0.0, RADIUS)
    gmsh.model.occ.synchronize()
    gmsh.model.mesh.generate(3)
    tags, points, _ = gmsh.model.mesh.getNodes()
    kinds, _, nodes = gmsh.model.mesh.getElements(3)
    cells = np.array(nodes[list(kinds).index(4)], int).reshape(-1, 4)
    gmsh.finalize()
    used = np.unique(cells)
    place = {tag: i for i, tag in enumerate(tags)}
    new = {tag: i for i, tag in enumerate(used)}
    points = points.reshape(-1, 3)[[place[tag] for tag in used]]
    return points, np.vectorize(new.get)(cells)


def rotation(random):
    """A rotation, all being alike."""
    q, r = np.linalg.qr(random.normal(size=(3, 3)))
    q = q * np.sign(np.diag(r))
    return q if np.linalg.det(q) > 0 else -q


def walls():
    """Corners and facets of the box, normals inwards."""
    h, t = HALF, HEIGHT
    corners = [(-h, -h, 0), (h, -h, 0), (h, h, 0), (-h, h, 0), (-h, -h, t), (h, -h, t), (h, h, t), (-h, h, t)]
    four = [(0, 1, 2, 3), (0, 4, 5, 1), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 4, 0)]
    return np.array(corners, float), four


def block(put, first, element):
    """Writes the block, eight by eight by four bricks on the floor; the next labels of nodes and elements."""
    n, m = 8, 4
    label = lambda i, j, k: first + i + (n + 1) * (j + (n + 1) * k)
    for k in range(m + 1):
        put("*NODE, NSET=" + ("BASE" if k == 0 else "BLOCK"))
        for j in range(n + 1):
            for i in range(n + 1):
                x, y, z = (2 * i / n - 1) * FOOT, (2 * j / n - 1) * FOOT, k / m * TIP
                put(f"{label(i, j, k)}, {x:.6f}, {y:.6f}, {z + 0.01:.6f}")
    put("*ELEMENT, TYPE=C3D8R, ELSET=BLOCK")
    for k in range(m):
        for j in range(n):
            for i in range(n):
                corners = [label(i + a, j + b, k + c) for c in (0, 1) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
                put(f"{element}, " + ", ".join(str(corner) for corner in corners))
                element += 1
    return label(n, n, m) + 1, element


def centres(layers, random):
    """Centres of the balls: layers of four by four above the block, each layer turned against the one below."""
    for layer in range(layers):
        turn = np.pi / 4 * (layer % 2) + 0.1 * random.normal()
        c, s = np.cos(turn), np.sin(turn)
        for i in range(4):
            for j in range(4):
                x, y = (i - 1.5) * 21.5, (j - 1.5) * 21.5
                yield np.array([c * x - s * y, s * x + c * y, TIP + 12.0 + 22.5 * layer]) + 0.3 * random.uniform(-1, 1, 3)


def main():
    words = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    words.add_argument("out")
    words.add_argument("--layers", type=int, default=8)
    words.add_argument("--size", type=float, default=3.0)
    words.add_argument("--time", type=float, default=0.12)
    given = words.parse_args()
    random = np.random.default_rng(7)
    points, cells = ball(given.size)
    corners, four = walls()
    with open(given.out, "w") as out:
        put = lambda line: out.write(line + "\n")
        put("*HEADING\nRubber balls poured over a pyramid into a box: general contact with friction (mm, t, s, N)")
        put("*NODE, NSET=WALLNODES")
        for i, x in enumerate(corners):
            put(f"{i + 1}, " + ", ".join(f"{v:.6f}" for v in x))
        reference = len(corners) + 1
        put(f"*NODE, NSET=REF\n{reference}, 0., 0., -10.")
        put("*ELEMENT, TYPE=R3D4, ELSET=BOX")
        for e, facet in enumerate(four):
            put(f"{e + 1}, " + ", ".join(str(i + 1) for i in facet))
        put(f"*RIGID BODY, REF NODE={reference}, ELSET=BOX")
        first, element, count = reference + 1, len(four) + 1, 0
        first, element = block(put, first, element)
        for centre in centres(given.layers, random):
            placed = points @ rotation(random).T + centre
            put("*NODE, NSET=BALLS")
            for i, x in enumerate(placed):
                put(f"{first + i}, " + ", ".join(f"{v:.6f}" for v in x))
            put("*ELEMENT, TYPE=C3D4, ELSET=BALLS")
            for i, cell in enumerate(cells):
                put(f"{element + i}, " + ", ".join(str(first + n) for n in cell))
            first, element, count = first + len(points), element + len(cells), count + 1
        put("*MATERIAL, NAME=RUBBER\n*ELASTIC\n1.0, 0.4\n*DENSITY\n1.0e-9")
        put("*SOLID SECTION, ELSET=BALLS, MATERIAL=RUBBER\n*SOLID SECTION, ELSET=BLOCK, MATERIAL=RUBBER")
        put("*SURFACE INTERACTION, NAME=RUBBING\n*FRICTION\n0.4")
        put("*CONTACT DAMPING, DEFINITION=CRITICAL DAMPING FRACTION\n0.1")
        put("*BOUNDARY\nREF, 1, 6\nBASE, 1, 3")
        put("*INITIAL CONDITIONS, TYPE=VELOCITY\nBALLS, 3, -500.")
        put("*STEP")
        put(f"*DYNAMIC, EXPLICIT\n, {given.time}\n*BULK VISCOSITY\n0.06, 1.2")
        put("*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n*CONTACT PROPERTY ASSIGNMENT\n, , RUBBING")
        put("*DLOAD\nBALLS, GRAV, 9810., 0., 0., -1.")
        put("*OUTPUT, FIELD, NUMBER INTERVAL=30\n*NODE OUTPUT\nU\n*ELEMENT OUTPUT\nMISES")
        put("*END STEP")
    print(f"{count} balls of {len(cells)} tetrahedra: {count * len(cells)} elements, {count * len(points)} nodes")


if __name__ == "__main__":
    main()

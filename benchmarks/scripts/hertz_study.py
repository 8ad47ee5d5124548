"""Runs the ball on the block (apps/fe/examples/hertz_sphere) on a sequence of meshes and prints the errors against
Hertz as a table.

    hertz_study.py --fe target/release/fe --folder STUDY [--edges 4 6 8 11]

`--edges` counts the element edges along the contact radius; the meshes are made with gmsh (`pip install gmsh`).
Meshes, decks and results stay in the folder. Without `--fe`, only meshes and decks are made.
"""

import argparse
import pathlib
import re
import subprocess
import time

import gmsh
import hertz

EXAMPLE = pathlib.Path(__file__).resolve().parents[2] / "apps/fe/examples/hertz_sphere"


def make_mesh(edges, path):
    """Meshes the example's geometry."""
    gmsh.initialize(["gmsh", "-setnumber", "n", str(edges), "-nt", "1", "-v", "2"])
    gmsh.open(str(EXAMPLE / "hertz_sphere.geo"))
    gmsh.model.mesh.generate(3)
    gmsh.write(str(path))
    gmsh.finalize()


def make_deck(mesh, path):
    """The example's deck on another mesh."""
    path.write_text((EXAMPLE / "hertz_sphere.inp").read_text().replace("hertz_sphere.msh", mesh.name))


def run(program, deck):
    """Runs a deck: iterations of all increments, and wall-clock time [s] of the whole process."""
    start = time.perf_counter()
    command = [program, "run", deck.name]
    ran = subprocess.run(command, cwd=deck.parent, check=True, stdout=subprocess.PIPE, text=True)
    return iterations(ran.stdout), time.perf_counter() - start


def iterations(printed):
    """Sum over the increment table: its columns 4 and 5 count iterations with and without changes of status."""
    lines = [line.split() for line in printed.splitlines() if re.match(r"\s*\d+\s+\d+\s+\d+\s+\d+\s+\d+\s", line)]
    return sum(int(line[3]) + int(line[4]) for line in lines)


def row(edges, work, results):
    """One line of the table."""
    nodes, table = hertz.evaluate(str(results), hertz.parser().parse_args([str(results)]))
    force, *errors = [computed / theory - 1.0 for theory, computed in table.values()]
    percent = " | ".join(f"{100 * error:+.2f} %" for error in errors)
    return f"| {edges} | {nodes} | {force:+.0e} | {percent} | {work[0]} | {work[1]:.1f} |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--fe", type=pathlib.Path, help="the program fe")
    parser.add_argument("--folder", type=pathlib.Path, required=True, help="where meshes, decks and results go")
    parser.add_argument("--edges", type=float, nargs="+", default=[4, 6, 8, 11], help="edges along the contact radius")
    given = parser.parse_args()
    given.folder.mkdir(parents=True, exist_ok=True)
    print("| a/h | nodes | contact force | peak pressure, fit | peak pressure, node | contact radius | iterations | seconds |")
    print("|---|---|---|---|---|---|---|---|")
    for edges in given.edges:
        deck = given.folder / f"hertz_{edges:g}.inp"
        mesh = deck.with_suffix(".msh")
        make_mesh(edges, mesh)
        make_deck(mesh, deck)
        if given.fe:
            work = run(given.fe.resolve(), deck)
            print(row(f"{edges:g}", work, deck.with_suffix(".vtkhdf")), flush=True)


if __name__ == "__main__":
    main()

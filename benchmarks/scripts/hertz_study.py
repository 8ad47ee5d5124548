"""Runs the ball on the block (apps/fe/examples/hertz_sphere) on a sequence of meshes and prints the errors against
Hertz as a table.

    hertz_study.py --fe target/release/fe --folder STUDY [--edges 4 5.66 8 11.3]

`--edges` counts the element edges along the contact radius; the meshes are made with gmsh (`pip install gmsh`).
Meshes, decks and results stay in the folder. Without `--fe`, only meshes and decks are made.
"""

import argparse
import pathlib
import re
import resource
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
    """Runs a deck: unknowns, iterations of all increments, and the process's seconds by the clock and of the CPU."""
    start, before = time.perf_counter(), resource.getrusage(resource.RUSAGE_CHILDREN)
    command = [program, "run", deck.name]
    ran = subprocess.run(command, cwd=deck.parent, check=True, stdout=subprocess.PIPE, text=True)
    clock, after = time.perf_counter() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    cpu = after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime
    unknowns, iterations = (int(re.search(rf"(\d+) {word}", ran.stdout).group(1)) for word in ("unknowns", "iterations"))
    return [unknowns, iterations, f"{clock:.1f}", f"{cpu:.1f}"]


COLUMNS = ["a/h", "nodes", "contact force", "p₀, fit", "p₀, node", "a, fit", "a, moment", "pressure, L2"]
COLUMNS += ["unknowns", "iterations", "seconds", "CPU seconds"]


def row(edges, results):
    """Errors of one run, for the first columns of the table."""
    nodes, table, spread = hertz.evaluate(str(results), hertz.parser().parse_args([str(results)]))
    force, *errors = [computed / theory - 1.0 for theory, computed in table.values()]
    return [edges, nodes, f"{force:+.0e}"] + [f"{100 * error:+.2f} %" for error in errors] + [f"{100 * spread:.1f} %"]


def line(entries):
    """A line of a table in Markdown."""
    return "| " + " | ".join(str(entry) for entry in entries) + " |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--fe", type=pathlib.Path, help="the program fe")
    parser.add_argument("--folder", type=pathlib.Path, required=True, help="where meshes, decks and results go")
    parser.add_argument("--edges", type=float, nargs="+", default=[4, 5.66, 8, 11.3], help="edges along the contact radius")
    given = parser.parse_args()
    given.folder.mkdir(parents=True, exist_ok=True)
    print(line(COLUMNS), line(["---"] * len(COLUMNS)), sep="\n")
    for edges in given.edges:
        deck = given.folder / f"hertz_{edges:g}.inp"
        mesh = deck.with_suffix(".msh")
        make_mesh(edges, mesh)
        make_deck(mesh, deck)
        if given.fe:
            work = run(given.fe.resolve(), deck)
            print(line(row(f"{edges:g}", deck.with_suffix(".vtkhdf")) + work), flush=True)


if __name__ == "__main__":
    main()

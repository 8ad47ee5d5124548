"""Seconds that gmsh's own reader takes for a file, on one thread.

Without a file: gmsh's version. With one: wall seconds, processor seconds, nodes and hexahedra read.
"""

import sys
import time

import gmsh

gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
gmsh.option.setNumber("General.NumThreads", 1)
if len(sys.argv) == 1:
    print(gmsh.option.getString("General.Version"))
else:
    wall, cpu = time.perf_counter(), time.process_time()
    gmsh.open(sys.argv[1])
    wall, cpu = time.perf_counter() - wall, time.process_time() - cpu
    counts = [int(gmsh.option.getNumber(f"Mesh.Nb{what}")) for what in ("Nodes", "Hexahedra")]
    print(wall, cpu, *counts)
gmsh.finalize()

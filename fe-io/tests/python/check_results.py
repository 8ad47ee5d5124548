#!/usr/bin/env python3
"""Reads a results file of the Rust tests with h5py and with VTK's vtkHDFReader and compares every number.

    check_results.py FILE HEXES FRAMES

The scene is that of `results_scene/mod.rs`: a row of HEXES hexahedra, five tetrahedra and one quadrilateral.
"""
import sys

import h5py
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkIOHDF import vtkHDFReader

# name, components, group: in the order of `results::fields::FIELDS`
FIELDS = [("U", 3, "Point"), ("V", 3, "Point"), ("RF", 3, "Point"), ("S", 6, "Point"), ("E", 6, "Point"), ("MISES", 1, "Point"),
          ("CPRESS", 1, "Point"), ("CPRESS_LENGTH", 1, "Point"), ("CPRESS_FORCE", 1, "Point"), ("CSHEAR1", 1, "Point"),
          ("CSHEAR2", 1, "Point"), ("COPEN", 1, "Point"), ("CSLIP1", 1, "Point"), ("CSLIP2", 1, "Point"),
          ("CNAREA", 1, "Point"), ("CSTATUS", 1, "Point"), ("CNORMF", 3, "Point"), ("CSHEARF", 3, "Point"),
          ("S", 6, "Cell"), ("E", 6, "Cell"), ("MISES", 1, "Cell"), ("PEEQ", 1, "Cell"), ("SF", 3, "Cell"), ("SM", 3, "Cell")]


def expected(frame, index, rows):
    name, width, _ = FIELDS[index]
    row, component = np.arange(rows)[:, None], np.arange(width)[None, :]
    values = frame * 1e6 + index * 1e4 + row + component / 8.0
    if name.startswith("C"):
        values[np.arange(rows) % 3 == 1] = np.nan
    return values if width > 1 else values[:, 0]


def same(found, wanted, what):
    assert found.shape == wanted.shape, f"{what}: shape {found.shape}, not {wanted.shape}"
    assert np.array_equal(found, wanted, equal_nan=True), f"{what} differs"


def with_h5py(path, points, cells, frames):
    with h5py.File(path, "r") as file:
        grid, steps = file["VTKHDF"], file["VTKHDF/Steps"]
        assert steps.attrs["NSteps"] == frames
        same(steps["Values"][:], np.arange(frames) / 16.0, "times")
        assert grid.attrs["Type"] == b"UnstructuredGrid" and list(grid.attrs["Version"]) == [2, 0]
        assert grid["Types"].dtype == np.uint8 and grid["Points"].dtype == np.float64
        for frame in range(frames):
            for index, (name, _, where) in enumerate(FIELDS):
                rows = points if where == "Point" else cells
                first = steps[f"{where}DataOffsets/{name}"][frame]
                same(grid[f"{where}Data/{name}"][first:first + rows], expected(frame, index, rows), name)
        for name, _, where in FIELDS:
            array = grid[f"{where}Data/{name}"]
            assert array.attrs["unit"] and array.attrs["meaning"]
        certificate = file["Signorini/Certificate"]
        assert list(certificate.attrs["columns"]) == ["time", "step", "increment", "residual", "overclosure"]
        assert len(certificate) >= frames
        assert file["Signorini"].attrs["heading"] == "Cubes in a row, größer"


def with_vtk(path, points, cells, frames):
    reader = vtkHDFReader()
    reader.SetFileName(path)
    reader.UpdateInformation()
    assert reader.GetNumberOfSteps() == frames, f"VTK sees {reader.GetNumberOfSteps()} frames of {frames}"
    # a file of one frame has no times in VTK
    times = reader.GetOutputInformation(0).Get(vtkStreamingDemandDrivenPipeline.TIME_STEPS()) or (0.0,)
    same(np.array(times), np.arange(frames) / 16.0, "VTK's times")
    for frame, time in enumerate(times):
        reader.UpdateTimeStep(time)
        grid = reader.GetOutputDataObject(0)
        assert (grid.GetNumberOfPoints(), grid.GetNumberOfCells()) == (points, cells)
        data = {"Point": grid.GetPointData(), "Cell": grid.GetCellData()}
        for index, (name, _, where) in enumerate(FIELDS):
            rows = points if where == "Point" else cells
            if rows:
                same(vtk_to_numpy(data[where].GetArray(name)), expected(frame, index, rows), f"VTK's {name}")
        labels = vtk_to_numpy(data["Point"].GetArray("NodeLabel"))
        same(labels, 10 + 3 * np.arange(points), "VTK's node labels")
    if cells:
        hexes = cells - 6
        same(vtk_to_numpy(data["Cell"].GetArray("Body")), (np.arange(cells) >= hexes).astype(np.int64), "bodies")
        assert [grid.GetCellType(i) for i in range(cells)] == [12] * hexes + [10] * 5 + [9]
        assert grid.GetCell(hexes).GetNumberOfPoints() == 4
        volume = sum(abs(np.linalg.det([np.subtract(grid.GetPoint(c.GetPointId(k)), grid.GetPoint(c.GetPointId(0)))
                                        for k in (1, 2, 3)])) / 6 for c in map(grid.GetCell, range(hexes, hexes + 5)))
        assert abs(volume - 1.0) < 1e-12, f"the five tetrahedra fill {volume} of a unit cube"


def main():
    path, hexes, frames = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    points, cells = 4 * (hexes + 2), hexes + 6
    with_h5py(path, points, cells, frames)
    with_vtk(path, points, cells, frames)


if __name__ == "__main__":
    main()

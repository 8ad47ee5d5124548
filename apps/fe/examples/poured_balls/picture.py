"""Draws the poured balls at three moments: each ball in a colour of its own, in true scale.

    picture.py RESULTS.vtkhdf OUT.png [--at 0.35 0.65 1.0]

The moments are parts of the frames of the file.
"""

import argparse
import colorsys

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

SIZE = (1650, 900)


def frames(path, parts):
    """Grids of some frames, moved by their displacements, with their times."""
    reader = vtk.vtkHDFReader()
    reader.SetFileName(path)
    reader.Update()
    count = reader.GetNumberOfSteps()
    for part in parts:
        reader.SetStep(min(int(round(part * (count - 1))), count - 1))
        reader.Update()
        grid = vtk.vtkUnstructuredGrid()
        grid.DeepCopy(reader.GetOutputDataObject(0))
        moved = vtk_to_numpy(grid.GetPoints().GetData()) + vtk_to_numpy(grid.GetPointData().GetArray("U"))
        grid.GetPoints().SetData(numpy_to_vtk(moved.astype(np.float64), deep=True))
        yield reader.GetTimeValue(), grid


def parts_of(grid):
    """Surfaces of the balls and of the walls, each of its cells with the number of its body."""
    bodies = vtk.vtkConnectivityFilter()
    bodies.SetInputData(grid)
    bodies.SetExtractionModeToAllRegions()
    bodies.ColorRegionsOn()
    bodies.Update()
    whole = bodies.GetOutput()
    kinds = vtk_to_numpy(whole.GetCellTypes() if hasattr(whole, "GetCellTypes") else whole.GetCellTypesArray())
    for solid in (True, False):
        chosen = vtk.vtkExtractCells()
        chosen.SetInputData(whole)
        ids = vtk.vtkIdList()
        for cell in np.nonzero((kinds == vtk.VTK_TETRA) == solid)[0]:
            ids.InsertNextId(int(cell))
        chosen.SetCellList(ids)
        faces = vtk.vtkDataSetSurfaceFilter()
        faces.SetInputConnection(chosen.GetOutputPort())
        smooth = vtk.vtkPolyDataNormals()
        smooth.SetInputConnection(faces.GetOutputPort())
        smooth.SetFeatureAngle(60.0 if solid else 1.0)
        smooth.Update()
        yield smooth.GetOutput()


def table(count):
    """Colours that lie apart from one ball to the next."""
    colours = vtk.vtkLookupTable()
    colours.SetNumberOfTableValues(count)
    for i in range(count):
        shade = colorsys.hsv_to_rgb((0.07 + 0.61803398875 * i) % 1.0, 0.55 + 0.25 * (i % 3) / 2, 0.95 - 0.2 * (i % 2))
        colours.SetTableValue(i, *shade)
    colours.SetTableRange(0, count - 1)
    return colours


def actor(data):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(data)
    made = vtk.vtkActor()
    made.SetMapper(mapper)
    return made, mapper


def main():
    words = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    words.add_argument("results")
    words.add_argument("out")
    words.add_argument("--at", type=float, nargs=3, default=[0.35, 0.65, 1.0])
    given = words.parse_args()
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(*SIZE)
    window.SetMultiSamples(8)
    for place, (time, grid) in enumerate(frames(given.results, given.at)):
        view = vtk.vtkRenderer()
        view.SetViewport(place / 3, 0.0, (place + 1) / 3, 1.0)
        view.SetBackground(1.0, 1.0, 1.0)
        balls, walls = parts_of(grid)
        ball, mapper = actor(balls)
        count = int(vtk_to_numpy(balls.GetCellData().GetArray("RegionId")).max()) + 1
        mapper.SetScalarModeToUseCellFieldData()
        mapper.SelectColorArray("RegionId")
        mapper.SetLookupTable(table(count))
        mapper.UseLookupTableScalarRangeOn()
        ball.GetProperty().SetAmbient(0.25)
        ball.GetProperty().SetDiffuse(0.75)
        ball.GetProperty().SetSpecular(0.25)
        ball.GetProperty().SetSpecularPower(30.0)
        wall, mapper = actor(walls)
        mapper.ScalarVisibilityOff()
        wall.GetProperty().SetColor(0.55, 0.60, 0.66)
        wall.GetProperty().SetOpacity(0.25)
        wall.GetProperty().EdgeVisibilityOn()
        wall.GetProperty().SetEdgeColor(0.25, 0.28, 0.32)
        view.AddActor(ball)
        view.AddActor(wall)
        text = vtk.vtkTextActor()
        text.SetInput(f"t = {time:.3f} s")
        text.GetTextProperty().SetFontSize(26)
        text.GetTextProperty().SetColor(0.12, 0.13, 0.15)
        text.SetPosition(24, 20)
        view.AddViewProp(text)
        camera = view.GetActiveCamera()
        camera.SetFocalPoint(0.0, 0.0, 95.0)
        camera.SetPosition(330.0, -480.0, 300.0)
        camera.SetViewUp(0.0, 0.0, 1.0)
        camera.SetViewAngle(27.0)
        view.ResetCameraClippingRange()
        window.AddRenderer(view)
    window.Render()
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(given.out)
    writer.SetInputConnection(grab.GetOutputPort())
    writer.Write()


if __name__ == "__main__":
    main()

"""Draws the ball on the block: both bodies, the contact cut open, and the pressure on the ball.

    picture.py RESULTS.vtkhdf OUT.png

Displacements are drawn in true scale. The quarter that is modelled is mirrored.
"""

import sys

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

SIZE = (1200, 800)
INK = (0.12, 0.13, 0.15)
STRESS_MAP = ["#f4f1ea", "#cfe1e8", "#8fbfd6", "#4a8fbd", "#2b5f9e", "#4a2f7f", "#8a1f6d", "#c92a4b", "#f07f3c", "#fde27a"]
PRESSURE_MAP = ["#ffffff", "#fdf3c8", "#fbd27a", "#f59a4a", "#e15a3a", "#b4233f", "#6d1140"]


def last_frame(path):
    """The grid of the last frame, moved by its displacement."""
    reader = vtk.vtkHDFReader()
    reader.SetFileName(path)
    reader.Update()
    if reader.GetNumberOfSteps() > 1:
        reader.SetStep(reader.GetNumberOfSteps() - 1)
        reader.Update()
    grid = vtk.vtkUnstructuredGrid()
    grid.DeepCopy(reader.GetOutputDataObject(0))
    moved = vtk_to_numpy(grid.GetPoints().GetData()) + vtk_to_numpy(grid.GetPointData().GetArray("U"))
    grid.GetPoints().SetData(numpy_to_vtk(moved.astype(np.float64), deep=True))
    return grid


def surface(grid, subdivisions):
    """Outer surface without the faces in the plane x = 0, which the mirror image hides; each face of a quadratic
    cell is cut into 4^subdivisions triangles."""
    faces = vtk.vtkDataSetSurfaceFilter()
    faces.SetInputData(grid)
    faces.SetNonlinearSubdivisionLevel(subdivisions)
    plane = vtk.vtkPlane()
    plane.SetOrigin(1e-6 * grid.GetLength(), 0.0, 0.0)
    plane.SetNormal(-1.0, 0.0, 0.0)
    seen = vtk.vtkExtractPolyDataGeometry()
    seen.SetInputConnection(faces.GetOutputPort())
    seen.SetImplicitFunction(plane)
    seen.ExtractBoundaryCellsOn()
    seen.Update()
    return seen.GetOutput()


def mirrored(data, *axes):
    """The data with its images in the planes x = 0 (axis 0) or y = 0 (axis 1)."""
    for axis in axes:
        transform = vtk.vtkTransform()
        transform.Scale(*(-1.0 if i == axis else 1.0 for i in range(3)))
        image = vtk.vtkTransformFilter()
        image.SetTransform(transform)
        image.SetInputData(data)
        both = vtk.vtkAppendPolyData()
        both.AddInputData(data)
        both.AddInputConnection(image.GetOutputPort())
        both.Update()
        data = both.GetOutput()
    return data


def round_up(value):
    """The next number above whose quarter has one digit or so."""
    step = 10.0 ** np.floor(np.log10(value / 4.0))
    return 4.0 * step * np.ceil(value / 4.0 / step)


def colours(anchors, high):
    """Twenty bands of colour from 0 to `high`, taken from a smooth map through the given colours."""
    table = vtk.vtkDiscretizableColorTransferFunction()
    table.DiscretizeOn()
    table.SetNumberOfValues(20)
    for place, code in zip(np.linspace(0.0, high, len(anchors)), anchors):
        table.AddRGBPoint(place, *(int(code[i : i + 2], 16) / 255.0 for i in (1, 3, 5)))
    table.Build()
    return table


def coloured(data, field, table):
    """An actor that shows a point field."""
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray(field)
    mapper.SetLookupTable(table)
    mapper.SetInterpolateScalarsBeforeMapping(True)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetAmbient(0.7)
    actor.GetProperty().SetDiffuse(0.3)
    return actor


def lines(data, width, opacity):
    """An actor that shows the edges of a surface, or a line."""
    edges = vtk.vtkExtractEdges()
    edges.SetInputData(data)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(edges.GetOutputPort())
    mapper.ScalarVisibilityOff()
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    mapper.SetRelativeCoincidentTopologyLineOffsetParameters(0.0, -300.0)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(INK)
    actor.GetProperty().SetLineWidth(width)
    actor.GetProperty().SetOpacity(opacity)
    actor.GetProperty().LightingOff()
    return actor


def panel(window, viewport, caption):
    """A part of the window with a caption in its upper left corner."""
    renderer = vtk.vtkRenderer()
    renderer.SetViewport(*viewport)
    renderer.SetBackground(1.0, 1.0, 1.0)
    text = vtk.vtkTextActor()
    text.SetInput(caption)
    style(text.GetTextProperty(), 19)
    text.GetTextProperty().SetVerticalJustificationToTop()
    text.GetTextProperty().SetBackgroundColor(1.0, 1.0, 1.0)
    text.GetTextProperty().SetBackgroundOpacity(0.85)
    text.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    text.SetPosition(0.03, 0.97)
    renderer.AddViewProp(text)
    window.AddRenderer(renderer)
    return renderer


def style(text, size):
    """Plain dark letters."""
    text.SetFontFamilyToArial()
    text.SetFontSize(size)
    text.SetColor(INK)
    text.BoldOff()
    text.ItalicOff()
    text.ShadowOff()


def scale(table, at):
    """A vertical colour bar at (left, bottom, width, height) of its panel."""
    bar = vtk.vtkScalarBarActor()
    bar.SetLookupTable(table)
    bar.SetNumberOfLabels(5)
    bar.SetLabelFormat("{:.0f}")
    bar.SetMaximumNumberOfColors(256)
    bar.UnconstrainedFontSizeOn()
    style(bar.GetLabelTextProperty(), 17)
    bar.DrawBackgroundOn()
    bar.GetBackgroundProperty().SetColor(1.0, 1.0, 1.0)
    bar.GetBackgroundProperty().SetOpacity(0.85)
    bar.SetPosition(at[0], at[1])
    bar.SetWidth(at[2])
    bar.SetHeight(at[3])
    return bar


def look(renderer, focus, direction, up, height):
    """A parallel view of `height` [L] from `direction`."""
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(*focus)
    camera.SetPosition(*(np.array(focus) + 100.0 * np.array(direction)))
    camera.SetViewUp(*up)
    camera.SetParallelScale(0.5 * height)
    renderer.ResetCameraClippingRange()


def main(results, out):
    grid = last_frame(results)
    pressure = vtk_to_numpy(grid.GetPointData().GetArray("CPRESS"))
    np.nan_to_num(pressure, copy=False)
    mises = vtk_to_numpy(grid.GetPointData().GetArray("MISES"))
    points = vtk_to_numpy(grid.GetPoints().GetData())
    touching = pressure > 0.0
    reach = np.hypot(points[touching, 0], points[touching, 1]).max()

    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(4)
    window.SetSize(*SIZE)
    stress = colours(STRESS_MAP, round_up(mises.max()))
    press = colours(PRESSURE_MAP, round_up(pressure.max()))
    smooth, corners = surface(grid, 2), surface(grid, 0)

    whole = panel(window, (0.0, 0.0, 0.56, 1.0), "Ball on block, half of it, Mises stress [MPa]")
    whole.AddActor(coloured(mirrored(smooth, 0), "MISES", stress))
    whole.AddActor(lines(mirrored(corners, 0), 1.0, 0.55))
    look(whole, (0.0, 4.0, -1.0), (0.25, -1.0, 0.35), (0.0, 0.0, 1.0), 42.0)

    cut = panel(window, (0.56, 0.5, 1.0, 1.0), "The contact, Mises stress [MPa]")
    cut.AddActor(coloured(mirrored(smooth, 0), "MISES", stress))
    cut.AddActor(lines(mirrored(corners, 0), 1.0, 0.35))
    cut.AddViewProp(scale(stress, (0.84, 0.08, 0.1, 0.75)))
    look(cut, (0.45 * reach, 0.0, 0.0), (0.0, -1.0, 0.0), (0.0, 0.0, 1.0), 4.4 * reach)

    below = panel(window, (0.56, 0.0, 1.0, 0.5), "Contact pressure on the ball, from below [MPa]")
    ball = above_block(smooth), above_block(corners)
    below.AddActor(coloured(mirrored(ball[0], 0, 1), "CPRESS", press))
    below.AddActor(lines(mirrored(ball[1], 0, 1), 1.0, 0.35))
    below.AddViewProp(scale(press, (0.84, 0.08, 0.1, 0.75)))
    look(below, (-0.45 * reach, 0.0, 0.0), (0.0, 0.0, -1.0), (0.0, 1.0, 0.0), 3.2 * reach)

    save(window, out)


def above_block(data):
    """The connected part of a surface that reaches highest."""
    parts = vtk.vtkPolyDataConnectivityFilter()
    parts.SetInputData(data)
    parts.SetExtractionModeToClosestPointRegion()
    parts.SetClosestPoint(0.0, 0.0, data.GetBounds()[5])
    parts.Update()
    return parts.GetOutput()


def save(window, out):
    """Renders and writes a png."""
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetCompressionLevel(9)
    writer.SetFileName(out)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


if __name__ == "__main__":
    if len(sys.argv) != 3:
        raise SystemExit(__doc__)
    main(*sys.argv[1:])

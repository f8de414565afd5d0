"""Marching cubes of a dense field, beside scikit-image, VTK's Flying Edges and, if installed, PyMCubes.

pointloom, scikit-image and PyMCubes return the mesh as arrays; VTK's stays in its own cells, without normals and
gradients. On the GPU the field is uploaded beforehand and the mesh stays there; the baselines run on the CPU.
"""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
import scenes
from contest import POINTLOOM, Contestant, Operation, Trial, thread_count, timed, waiting

# Triangle counts on which scikit-image, PyMCubes and Flying Edges agree.
TRIANGLE_COUNTS = {128: 76_460, 256: 308_236, 384: 695_564}


def prepare_pointloom(field: np.ndarray, device: str) -> Any:
    import pointloom as loom

    if not device.startswith("cuda"):
        return lambda: loom.meshing.marching_cubes(field)
    import warp as wp

    resident = wp.array(field, dtype=wp.float32, device=device)
    return waiting(lambda: loom.meshing.marching_cubes(resident), device, "warp")


def prepare_scikit_image(field: np.ndarray, device: str) -> Any:
    from skimage import measure

    return lambda: measure.marching_cubes(field, 0.0)[:2]


def prepare_vtk(field: np.ndarray, device: str) -> Any:
    import vtk
    from vtk.util.numpy_support import numpy_to_vtk

    vtk.vtkSMPTools.SetBackend("STDThread")
    vtk.vtkSMPTools.Initialize(thread_count())
    values = numpy_to_vtk(field.ravel(), deep=False)
    values._field = field  # VTK does not own the memory that it refers to

    def make() -> Any:
        image = vtk.vtkImageData()
        image.SetDimensions(*field.shape[::-1])
        image.GetPointData().SetScalars(values)
        edges = vtk.vtkFlyingEdges3D()
        edges.SetInputData(image)
        edges.SetValue(0, 0.0)
        edges.ComputeNormalsOff()
        edges.ComputeGradientsOff()
        edges.ComputeScalarsOff()
        return edges

    def extract(edges: Any) -> Any:
        edges.Update()
        return edges.GetOutput()

    return Trial(extract, setup=make)


def prepare_pymcubes(field: np.ndarray, device: str) -> Any:
    import mcubes

    return lambda: mcubes.marching_cubes(field, 0.0)


def array_facts(mesh: tuple[np.ndarray, np.ndarray]) -> tuple[int, np.ndarray]:
    return len(mesh[1]), _sample(mesh[0])


def vtk_facts(mesh: Any) -> tuple[int, np.ndarray]:
    from vtk.util.numpy_support import vtk_to_numpy

    return mesh.GetNumberOfCells(), _sample(vtk_to_numpy(mesh.GetPoints().GetData())[:, ::-1])


def _sample(vertices: np.ndarray) -> np.ndarray:
    """Mean, spread and bounds of the vertices, independent of their order."""
    vertices = np.asarray(vertices, np.float64)
    return np.stack([vertices.mean(axis=0), vertices.std(axis=0), vertices.min(axis=0), vertices.max(axis=0)])


def check(actual: tuple[int, np.ndarray], reference: tuple[int, np.ndarray], peer: str) -> None:
    """Check for the same number of triangles, and similar vertex statistics (PyMCubes repeats some vertices)."""
    assert actual[0] == reference[0], f"{actual[0]} triangles, {peer} {reference[0]}"
    np.testing.assert_allclose(actual[1], reference[1], atol=0.1 if peer.startswith("PyMCubes") else 0.01)


MARCHING_CUBES = Operation(
    name="marching_cubes",
    scenes={f"{n}^3": partial(scenes.wavy_ball, n) for n in TRIANGLE_COUNTS},
    quick={"64^3": partial(scenes.wavy_ball, 64)},
    contestants=(
        Contestant(
            POINTLOOM, prepare_pointloom, lambda mesh: (len(mesh.triangles), _sample(mesh.vertices)), ("cpu", "cuda")
        ),
        Contestant("scikit-image", prepare_scikit_image, array_facts),
        Contestant("vtk", prepare_vtk, vtk_facts),
        Contestant("PyMCubes", prepare_pymcubes, array_facts),
    ),
    check=check,
    memory_size="256^3",
    targets={"128^3": 1.2, "256^3": 1},
)
OPERATIONS = (MARCHING_CUBES,)


@timed(MARCHING_CUBES)
def test_marching_cubes(time_lap) -> None:
    time_lap()

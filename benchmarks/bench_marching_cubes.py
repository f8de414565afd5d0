"""Marching cubes beside scikit-image and VTK's Flying Edges (2 threads), on one field in one process.

    python -m pytest benchmarks/bench_marching_cubes.py -o python_files="bench_*.py" --benchmark-columns=min,median

The first call of ours compiles or loads the kernels, and is outside the timed rounds. Ours and scikit-image's include
the mesh as arrays; VTK's leaves it in VTK's own cells, without normals and gradients.
"""

from __future__ import annotations

import os

import numpy as np
import pytest

from pointloom import marching_cubes

COUNTS = {128: 76_460, 256: 308_236, 384: 695_564}


@pytest.fixture(scope="module", params=COUNTS)
def field(request) -> np.ndarray:
    x = np.linspace(-1, 1, request.param, dtype=np.float32)
    x, y, z = np.meshgrid(x, x, x, indexing="ij", sparse=True)
    waves = np.float32(0.05) * np.sin(9 * x) * np.sin(8 * y) * np.sin(7 * z)
    return (np.sqrt(x * x + y * y + z * z) - np.float32(0.7) + waves).astype(np.float32)


def record(benchmark, field, name, triangle_count) -> None:
    benchmark.group = f"marching cubes {len(field)}^3"
    benchmark.extra_info.update(library=name, triangles=triangle_count, cores=os.cpu_count())
    assert triangle_count == COUNTS[len(field)]


def test_pointloom(benchmark, field):
    marching_cubes(field)
    mesh = benchmark.pedantic(lambda: marching_cubes(field), rounds=9)
    record(benchmark, field, "pointloom", len(mesh))


def test_scikit_image(benchmark, field):
    measure = pytest.importorskip("skimage.measure")
    _, triangles, _, _ = benchmark.pedantic(lambda: measure.marching_cubes(field, 0.0), rounds=3)
    record(benchmark, field, "scikit-image", len(triangles))


def test_vtk_flying_edges(benchmark, field):
    vtk = pytest.importorskip("vtk")
    from vtk.util.numpy_support import numpy_to_vtk

    vtk.vtkSMPTools.Initialize(2)
    image = vtk.vtkImageData()
    image.SetDimensions(*field.shape[::-1])
    values = numpy_to_vtk(field.ravel(), deep=False)
    image.GetPointData().SetScalars(values)

    def extract():
        edges = vtk.vtkFlyingEdges3D()
        edges.SetInputData(image)
        edges.SetValue(0, 0.0)
        edges.ComputeNormalsOff()
        edges.ComputeGradientsOff()
        edges.ComputeScalarsOff()
        edges.Update()
        return edges.GetOutput()

    output = benchmark.pedantic(extract, rounds=9, warmup_rounds=1)
    benchmark.group = f"marching cubes {len(field)}^3"
    benchmark.extra_info.update(library="vtk", triangles=output.GetNumberOfCells())

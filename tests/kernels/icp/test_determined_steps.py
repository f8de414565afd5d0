"""The step of a system: NumPy's where all motions are determined, and the same bits from lanes as from one thread."""

import numpy as np
import pytest

from pointloom.kernels.algebra.rigid_solve import triangle, vec6d
from pointloom.kernels.icp.determined_steps import constrained_step
from pointloom.kernels.icp.job_states import free_directions
from pointloom.kernels.icp.step import job_of, leads
from pointloom.kernels.lang import WARP, array, float64, int32, kernel, launch, tid, vec3d
from pointloom.kernels.memory import download, upload, zeros

MIN_EIGENVALUE = 1e-6
JOBS = 40


@kernel
def solve_systems_kernel(
    h: array(dtype=triangle), g: array(dtype=vec6d), centers: array(dtype=vec3d), sizes: array(dtype=float64),
    steps: array(dtype=vec6d), counts: array(dtype=int32), free_ones: array(dtype=free_directions),
):  # fmt: skip
    i = tid()
    job = job_of(i)
    limit = float64(MIN_EIGENVALUE)
    step = constrained_step(h[job], g[job], h[job], centers[job], sizes[job], limit, job, counts, free_ones)
    if leads() == 1:
        steps[job] = step


def systems(unit: float):
    """Full matrices, right sides, middles and sizes; every other matrix leaves two motions free."""
    rng = np.random.default_rng(4)
    sizes, centers = unit * rng.uniform(0.5, 20.0, JOBS), unit * rng.normal(size=(JOBS, 3)) * 5
    rows = rng.normal(size=(JOBS, 60, 6))
    normals = rows[..., 3:]
    normals[1::2, :, 2] = 0.0  # no row pulls along z
    points = centers[:, None] + sizes[:, None, None] * rng.normal(size=(JOBS, 60, 3))
    points[1::4, :, 2] = centers[1::4, None, 2]
    rows[..., :3] = np.cross(points, normals)
    return rows.transpose(0, 2, 1) @ rows, rng.normal(size=(JOBS, 6)), centers, sizes


def solve_on(device, unit: float):
    h, g, centers, sizes = systems(unit)
    upper = h[:, *np.triu_indices(6)]
    steps, counts, free = zeros(JOBS, vec6d, device), zeros(JOBS, int32, device), zeros(JOBS, free_directions, device)
    given = ((upper, triangle), (g, vec6d), (centers, vec3d), (sizes, float64))
    threads = JOBS * (WARP if steps.device.is_cuda else 1)
    launch(solve_systems_kernel, threads, [*(upload(x, t, device) for x, t in given), steps, counts, free])
    return download(steps), download(counts), download(free)


@pytest.mark.parametrize("unit", [1.0, 1e-3, 3e4])
def test_determined_systems_are_solved_and_free_motions_left_out(device, unit):
    h, g, centers, _ = systems(unit)
    steps, counts, _ = solve_on(device, unit)
    assert (counts[::2] == 0).all() and (counts[1::2] > 0).all()
    np.testing.assert_allclose(steps[::2], np.linalg.solve(h[::2], -g[::2, :, None])[..., 0], rtol=1e-7)
    shifts = steps[:, 3:] + np.cross(steps[:, :3], centers)  # of the middle
    assert np.abs(shifts[1::2, 2]).max() < 1e-9 * np.abs(shifts[1::2]).max()


@pytest.mark.parametrize("unit", [1.0, 1e-3, 3e4])
def test_all_devices_are_bitwise_identical(device, unit):
    for result, expected in zip(solve_on(device, unit), solve_on("cpu", unit), strict=True):
        np.testing.assert_array_equal(result, expected)

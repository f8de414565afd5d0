"""Iterations of the color map: normal equations, accepted steps, and views with an outlying color."""

import numpy as np
import pytest

from pointloom.kernels.arrays.concatenation import concatenate_rows
from pointloom.kernels.lang import float64, int32, launch, mat44d, reduce_segments, uint8, vec2d, vec3
from pointloom.kernels.memory import copy, download, empty, upload, zeros
from pointloom.kernels.textures import color_outliers as outliers
from pointloom.kernels.textures import color_steps as steps
from pointloom.kernels.textures.color_steps import SQUARES_COLUMN, ColorSearch, sum_pair_rows
from pointloom.kernels.textures.face_views import FaceViews
from pointloom.kernels.textures.stacked_images import StackedImages, Warps, smooth_brightness
from pointloom.kernels.textures.vertex_views import Sightings
from pointloom.kernels.textures.warp_steps import WarpSearch


def judge(state, squares, warp_device, counts=(10.0, 10.0)):
    sums = np.zeros((2, 29))
    sums[:, steps.SQUARES_COLUMN], sums[:, steps.COUNT_COLUMN] = squares, counts
    given = upload(sums, steps.pose_sums, warp_device)
    launch(steps.judge_iteration_kernel, 1, [given, zeros(2, float64, warp_device), state])
    return given, download(state.error).copy(), int(download(state.running)[0]), int(download(state.outcome)[0])


def test_an_iteration_that_increases_the_residual_is_reverted(device):
    state = steps.SearchState(10, device)
    good, *_ = judge(state, (1.0, 2.0), device)
    poses, best = upload(np.tile(np.eye(4), (2, 1, 1)), mat44d, device), empty(2, mat44d, device)
    best_sums = zeros(2, steps.pose_sums, device)
    launch(steps.keep_best_kernel, 2, [state, good, poses, best_sums, best])
    worse, error, running, outcome = judge(state, (3.0, 2.0), device)
    moved = upload(np.tile(2 * np.eye(4), (2, 1, 1)), mat44d, device)
    launch(steps.keep_best_kernel, 2, [state, worse, moved, best_sums, best])
    assert outcome == 0 and running == 1 and error[1] == pytest.approx(0.15) and error[3] == pytest.approx(0.25)
    assert error[2] > steps.FIRST_DAMPING
    assert (download(moved)[:, 0, 0] == 1).all() and (download(best_sums)[:, steps.SQUARES_COLUMN] == (1, 2)).all()


@pytest.mark.parametrize(
    ("all_squares", "counts", "ends"),
    [
        (((3.0, 2.0), (1.0, 1.0)), (10.0, 10.0), False),
        (((3.0, 2.0), (2.9999999, 2.0)), (10.0, 10.0), True),  # nearly nothing won
        (((3.0, 2.0), (1.0, 1.0), (0.5, 0.5)), (10.0, 10.0), True),  # out of iterations
        (((0.0, 0.0),), (0.0, 0.0), True),  # no pairs
    ],
)
def test_the_search_ends_where_nothing_is_won_or_left(device, all_squares, counts, ends):
    state = steps.SearchState(2, device)
    for squares in all_squares:
        _, _, running, _ = judge(state, squares, device, counts)
    assert (running == 0) == ends


def test_damping_without_end_ends_the_search(device):
    state = steps.SearchState(1000, device)
    judge(state, (1.0, 1.0), device)
    iterations = 0
    while judge(state, (2.0, 2.0), device)[2]:
        iterations += 1
    assert iterations < 20


def likely(colors):
    """The mask of one triangle's colors, and the number of Gaussians fitted until convergence."""
    if len(colors) < outliers.MIN_VIEWS:
        return np.ones(len(colors), bool), 0
    gaps = np.linalg.norm(colors[:, None] - colors, axis=2)
    middle = gaps[gaps.sum(axis=1).argmin()]
    keep = middle <= max(
        outliers.INITIAL_MEDIAN_DISTANCES * np.sort(middle)[(len(colors) - 1) // 2], outliers.MIN_DISTANCE
    )
    for iteration in range(outliers.MAX_ITERATIONS):
        if keep.sum() < outliers.MIN_VIEWS:
            return np.ones(len(colors), bool), iteration
        off = colors - colors[keep].mean(axis=0)
        inverse = np.linalg.inv(np.cov(colors[keep].T, bias=True) + outliers.NOISE_VARIANCE * np.eye(3))
        before, keep = keep, np.einsum("ni,ij,nj->n", off, inverse, off) <= outliers.MAX_SQUARED_DEVIATION
        if (keep == before).all():
            break
    return keep, iteration


def test_likely_views_belong_to_a_gaussian_fitted_until_convergence(device, rng):
    faces = [np.zeros((0, 3)), rng.random((3, 3)), rng.random((4, 3))]
    for count in rng.integers(4, 20, 60):
        spread = rng.choice([0.01, 0.05], count)[:, None]
        far = (rng.random(count) < 0.25)[:, None] * rng.uniform(0, 0.6, (count, 1))
        faces.append(rng.uniform(0.2, 0.6, 3) + spread * rng.normal(size=(count, 3)) + far)
    faces.append(np.vstack([np.zeros((2, 3)), np.eye(3)]))  # only the two equal ones are near: all stay
    faces = [face.astype(np.float32) for face in faces]
    starts = np.cumsum([0, *map(len, faces)])
    count = int(starts[-1])
    numbers = np.zeros(count)
    arrays = (upload(starts, int32, device), upload(numbers, int32, device), upload(numbers, float64, device))
    mask = download(outliers.keep_likely(FaceViews(*arrays, upload(np.vstack(faces), vec3, device))))
    expected = [likely(face.astype(float)) for face in faces]
    np.testing.assert_array_equal(mask, np.concatenate([keep for keep, _ in expected]))
    assert max(iterations for _, iterations in expected) > 0 and 0.5 < mask[: -len(faces[-1])].mean() < 0.99
    assert mask[-len(faces[-1]) :].all()


SIZES = ((48, 36), (40, 30))


def make_images(warp_device, rng, paint=None):
    pixels, layout, first = [], [], 0
    for width, height in SIZES:
        v, u = np.mgrid[:height, :width]
        values = rng.integers(0, 255, (height, width, 3)) if paint is None else np.stack([paint(u, v)] * 3, -1)
        pixels.append(upload(values.reshape(-1, 3).astype(np.uint8), uint8, warp_device))
        layout.append((width, height, first))
        first += width * height
    layout, every = np.array(layout), concatenate_rows(pixels)
    lenses = np.array([(50.0, 51.0, 23.2, 17.1), (42.0, 41.0, 19.6, 14.7)])
    poses = np.tile(np.eye(4), (2, 1, 1))
    poses[1, :3, 3] = 0.02, -0.01, 0.03
    return StackedImages(layout, lenses, poses, every, smooth_brightness(every, layout), 1)


def make_vertices(warp_device, rng, count=400):
    points = rng.uniform((-0.35, -0.25, 0.95), (0.35, 0.25, 1.3), (count, 3)).astype(np.float32)
    rows = [np.arange(count), np.flatnonzero(rng.random(count) < 0.7)]
    return upload(points, vec3, warp_device), Sightings([upload(r, int32, warp_device) for r in rows], count)


def dense_system(search, image):
    """The matrix and the right side of one image's anchors and pose, from its pairs' rows one after the other."""
    system, warps = search.system, search.warps
    columns, rows, first = warps.layout[image].tolist()
    count, cells = 2 * columns * rows, download(system.cells)
    pairs, shifts = download(system.rows).astype(float), download(warps.shifts)[first : first + columns * rows]
    A, b = np.zeros((count + 6, count + 6)), np.zeros(count + 6)
    for cell in range(columns * rows):
        for gx, gy, p, q, r, *pose in pairs[cells[first + cell] : cells[first + cell + 1]]:
            J = np.zeros(count + 6)
            for k, w in ((0, (1 - p) * (1 - q)), (1, (1 - p) * q), (rows, p * (1 - q)), (rows + 1, p * q)):
                J[2 * (cell + k)], J[2 * (cell + k) + 1] = w * gx, w * gy
            J[count:] = pose
            A += np.outer(J, J)
            b -= J * r
    tie = download(system.ties)[image]
    A[range(count), range(count)] += tie
    b[:count] -= tie * shifts.reshape(-1)
    return A, b


@pytest.mark.parametrize("anchors", [2, 3, 5])
def test_a_step_is_the_solution_of_the_dense_system(device, rng, anchors):
    stack, (vertices, sightings) = make_images(device, rng), make_vertices(device, rng)
    warps = Warps(stack.layout, anchors, device)
    start = rng.normal(0, 0.3, (warps.count, 2))
    copy(warps.shifts, upload(start, vec2d, device), count=warps.count)
    search = WarpSearch(vertices, sightings, stack, warps, 1, 0.9)
    poses = download(stack.poses).copy()
    assert search.iterate()
    damping = 1 + 1e-6  # FIRST_DAMPING
    shifts = download(warps.shifts).copy()
    moved = download(stack.poses)
    copy(warps.shifts, upload(start, vec2d, device), count=warps.count)  # the ties are about the start
    for image in range(2):
        A, b = dense_system(search, image)
        A[range(len(A)), range(len(A))] *= damping
        x = np.linalg.solve(A, b)
        columns, rows, first = warps.layout[image].tolist()
        step = (shifts - start)[first : first + columns * rows].reshape(-1)
        # pairs' rows are float32 where the pose's own block is summed in float64
        assert np.abs(step - x[:-6]).max() < 1e-4 * np.abs(x[:-6]).max()
        motion = moved[image] @ np.linalg.inv(poses[image])
        assert np.abs(motion[:3, 3] - x[-3:]).max() < 1e-3 * np.abs(x[-6:]).max()


def test_slopes_are_those_of_the_residuals(device, rng):
    """Of an image whose brightness rises evenly, where bilinear values and Sobel's slopes are exact."""
    stack = make_images(device, rng, lambda u, v: 3 * u + 2 * v)
    vertices, sightings = make_vertices(device, rng, 200)
    warps = Warps(stack.layout, 3, device)
    copy(warps.shifts, upload(rng.normal(0, 0.2, (warps.count, 2)), vec2d, device), count=warps.count)
    search = ColorSearch(vertices, sightings, stack, warps, 0)
    search.measure()
    sums = download(search.sums).copy()
    proxies = search.proxies
    poses, h = download(stack.poses).copy(), 1e-5
    for unknown in range(6):
        errors = []
        for sign in (1, -1):
            motion = np.eye(4)
            if unknown < 3:
                a, b = [(1, 2), (2, 0), (0, 1)][unknown]
                motion[a, b], motion[b, a] = -sign * h, sign * h
            else:
                motion[unknown - 3, 3] = sign * h
            tried = ColorSearch(vertices, sightings, stack, warps, 0)
            copy(stack.poses, upload(motion @ poses, stack.poses.dtype, device), count=2)
            tried.measure()
            copy(tried.proxies, proxies, count=vertices.size)  # held
            given = [tried.vertices, tried.sightings, tried.proxies, tried.samples, tried.images, tried.warps]
            reduce_segments(sum_pair_rows, tried.blocks, tried.live, given, tried.partials, tried.sums)
            errors.append(download(tried.sums)[:, SQUARES_COLUMN].copy())
        copy(stack.poses, upload(poses, stack.poses.dtype, device), count=2)
        slope = (errors[0] - errors[1]) / (4 * h)  # of half the squares
        scale = np.abs(sums[:, 21:27]).max()
        # brightness is float32 in 0..1: 6e-8 over 2 h
        assert np.abs(slope - sums[:, 21 + unknown]).max() < 2e-2 * scale

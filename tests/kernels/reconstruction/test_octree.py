"""The octree of samples: cells, density, levels, and the Poisson system, compared with brute force and SciPy."""

from functools import cache

import numpy as np
import pytest
from scipy import sparse
from scipy.sparse.linalg import spsolve

from pointloom.kernels.lang import vec2d, vec3
from pointloom.kernels.memory import download, upload
from pointloom.kernels.reconstruction import poisson
from pointloom.kernels.reconstruction.poisson import grow_tree, mean_at_samples, solve
from pointloom.kernels.reconstruction.poisson_system import constraints
from pointloom.kernels.reconstruction.sample_cells import Cube, gather_samples, sample_rows
from pointloom.kernels.reconstruction.sample_density import TREE_CONTINUES, TREE_ENDED_ABOVE, TREE_ENDS

SIDE, CORNER = 2.2, np.array([-1.1, -1.1, -1.1])


@cache
def ball_samples(count: int, fraction: float = 1.0):
    rng = np.random.default_rng(0)
    points = rng.normal(size=(count, 3))
    points /= np.linalg.norm(points, axis=1, keepdims=True)
    return points[rng.random(count) < np.where(points[:, 2] > 0.6, 1, fraction)].astype(np.float32)


def tree_of(points, depth, device, normals=None, samples_per_cell=1.5):
    """A DensityPyramid over points, by default of the unit sphere, in a cube of edge 2.2."""
    points, normals = (upload(a, vec3, device) for a in (points, points if normals is None else normals))
    rows = sample_rows(points, normals)
    cells = gather_samples(points, normals, rows, Cube(CORNER, SIDE), depth)
    return grow_tree(cells, rows.size, depth, max(1, depth - 2), samples_per_cell)


def slot_cells(level):
    """int [8 blocks, 3]."""
    corners = np.stack([np.arange(8) >> axis & 1 for axis in range(3)], axis=1)
    return (2 * download(level.positions).reshape(-1, 1, 3) + corners).reshape(-1, 3)


def is_cell(level):
    return np.repeat(download(level.has_cells), 8) == 1


def leaves_of(pyramid):
    cells, depths = [], []
    for level in pyramid.levels[1:]:
        chosen = is_cell(level) & (download(level.divided) == 0)
        cells.append(slot_cells(level)[chosen])
        depths.append(np.full(chosen.sum(), level.depth))
    return np.concatenate(cells), np.concatenate(depths)


def code_cells(codes):
    codes = codes[:, None].astype(np.int64)
    bits = np.arange(21)
    return np.stack([((codes >> (3 * bits + axis) & 1) << bits).sum(axis=1) for axis in range(3)], axis=1)


def spline(t):
    t = np.abs(t)
    return np.where(t < 0.5, 0.75 - t**2, np.where(t < 1.5, 0.5 * (1.5 - t) ** 2, 0))


@pytest.mark.parametrize("by_length", [False, True])
def test_cells_contain_the_sums_of_their_points(device, by_length):
    rng = np.random.default_rng(1)
    points = ball_samples(500)
    normals = (points * rng.uniform(0.5, 2, (500, 1))).astype(np.float32)
    points = points.copy()
    points[7], normals[8], normals[9] = np.nan, np.inf, 0
    arrays = [upload(a, vec3, device) for a in (points, normals)]
    rows = sample_rows(*arrays)
    np.testing.assert_array_equal(download(rows), np.delete(np.arange(500), [7, 8, 9]))
    positions = (points.astype(float)[download(rows)] - CORNER) / SIDE
    sizes = np.linalg.norm(normals.astype(float)[download(rows)], axis=1, keepdims=True)
    weights = sizes if by_length else np.ones_like(sizes)
    units = normals.astype(float)[download(rows)] / sizes * weights
    levels = gather_samples(*arrays, rows, Cube(CORNER, SIDE), 4, by_length)
    assert len(levels) == 5 and levels[0].count == 1
    for depth, cells in enumerate(levels):
        expected, member = np.unique(np.floor(positions * 2**depth).astype(int), axis=0, return_inverse=True)
        cell_indices = code_cells(download(cells.codes))
        order = np.lexsort(cell_indices.T[::-1])
        np.testing.assert_array_equal(cell_indices[order], expected)
        sums = [np.zeros((len(expected), k)) for k in (1, 3, 3, 1)]
        for total, values in zip(sums, (np.ones_like(sizes), positions, units, weights), strict=True):
            np.add.at(total, member.ravel(), values)
        count, mean, normal, weight = sums
        np.testing.assert_array_equal(download(cells.counts)[order], count[:, 0])
        np.testing.assert_allclose(download(cells.means)[order], mean / count, atol=2e-7)
        np.testing.assert_allclose(download(cells.sums)[order], normal, atol=2e-4)
        np.testing.assert_allclose(download(cells.weights)[order], weight[:, 0], rtol=1e-6)


def test_the_density_is_that_of_splines_by_brute_force(device):
    pyramid = tree_of(ball_samples(600), 4, device)
    assert len(pyramid.densities) == 3  # evaluated up to two levels above the finest
    above = np.full(1, 600 / 1.5)
    for depth in (1, 2):
        cells, nodes, n = pyramid.cells[depth], pyramid.nodes[depth], 1 << depth
        at = download(cells.means).astype(float) * n
        centers = np.stack(np.meshgrid(*[np.arange(n) + 0.5] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
        weights = spline(at[:, None] - centers).prod(axis=2)  # [cells of samples, cells]
        w = weights @ (download(cells.counts) @ weights) / (1.5 * 0.59375)
        np.testing.assert_allclose(download(nodes.densities), w, rtol=1e-5)
        parents = download(cells.parents)
        between = depth - 1 + np.log(np.maximum(above[parents], 1)) / np.log(np.maximum(above[parents], 1) / w)
        local = np.where(w < 1, between, depth + (np.log(np.maximum(w, 1)) / np.log(4) if depth == 2 else 1))
        np.testing.assert_allclose(download(nodes.depths), local, atol=1e-5)
        np.testing.assert_array_equal(download(nodes.states), np.where(local > depth, TREE_CONTINUES, TREE_ENDS))
        above = w


TREES = [(3, 400, 1.0), (8, 4000, 0.002)]
STEPS = np.array(list(np.ndindex(3, 3, 3))) - 1  # to a cell's neighbors


@pytest.fixture(params=TREES, ids=["full", "clustered"])
def pyramid(request, device):
    depth, count, fraction = request.param
    return tree_of(ball_samples(count, fraction), depth, device)


def test_leaves_fill_the_cube_once(pyramid):
    cells, depths = leaves_of(pyramid)
    last = int(depths.max())
    assert (8.0 ** (last - depths)).sum() == 8**last
    size = (1 << (last - depths))[:, None]
    assert (cells >= 0).all() and ((cells + 1) * size <= 2**last).all()
    for level in pyramid.levels[1:]:
        assert len(np.unique(slot_cells(level), axis=0)) == 8 * level.count


def test_leaves_that_touch_differ_by_one_level(pyramid):
    cells, depths = leaves_of(pyramid)
    last = int(depths.max())
    assert last - depths.min() >= (0 if last == 3 else 2)
    for fine in range(int(depths.min()) + 2, last + 1):
        neighbors = (cells[depths == fine][:, None] + STEPS).reshape(-1, 3)
        for coarse in range(1, fine - 1):
            leaves = cells[depths == coarse]
            assert not np.isin(keys_of(neighbors >> (fine - coarse)), keys_of(leaves)).any()


def keys_of(cells):
    """One number a place; -1 beside the cube is none of its cells."""
    return ((cells + 1).astype(np.int64) * [1 << 42, 1 << 21, 1]).sum(axis=1)


def test_cells_around_a_divided_cell_exist(pyramid):
    for level in pyramid.levels[1:]:
        cells = {tuple(p) for p in slot_cells(level)[is_cell(level)]}
        divided = slot_cells(level)[download(level.divided) == 1]
        for step in STEPS:
            neighbors = divided + step
            neighbors = neighbors[((neighbors >= 0) & (neighbors < 1 << level.depth)).all(axis=1)]
            assert {tuple(p) for p in neighbors} <= cells


def test_neighbors_of_a_block_match_its_positions(pyramid):
    for level in pyramid.levels[1:]:
        positions = download(level.positions).reshape(-1, 3)
        at = {tuple(p): i for i, p in enumerate(positions)}
        expected = [[at.get(tuple(p), -1) for p in position + STEPS] for position in positions]
        np.testing.assert_array_equal(download(level.around).reshape(-1, 27), expected)


def test_each_sample_cell_has_the_slot_of_its_position(pyramid):
    reached = 0
    parts = (pyramid.cells, pyramid.nodes, pyramid.cells_at, pyramid.levels)
    for cells, nodes, at, level in zip(*(part[1:] for part in parts), strict=False):
        slots = download(nodes.slots)
        exists = slots >= 0
        positions = slot_cells(level)
        np.testing.assert_array_equal(positions[slots[exists]], code_cells(download(cells.codes))[exists])
        assert is_cell(level)[slots[exists & (download(nodes.states) != TREE_ENDED_ABOVE)]].all()
        expected = np.full(8 * level.count, -1)
        expected[slots[exists]] = np.flatnonzero(exists)
        np.testing.assert_array_equal(download(at), expected)
        missing = {tuple(p) for p in code_cells(download(cells.codes))[~exists]}
        assert not missing & {tuple(p) for p in positions[is_cell(level)]}
        reached += exists.sum()
    assert reached > 200


DEPTH = 3  # all cells of all levels exist, so arrays [n, n, n] represent them


def one_face(device):
    """Samples for one face of the cube, which give a known pull."""
    return upload(np.ones((1, 2)), vec2d, device)


def scene(device):
    """A tree whose samples end on two levels, some within a cell of the cube's sides."""
    points = ball_samples(150)
    normals = np.random.default_rng(2).normal(size=points.shape).astype(np.float32)
    return tree_of(points, DEPTH, device, normals)


def spread_samples(pyramid, depth):
    """(positions in cells, fluxes) of the samples that are spread on a level: area times normal."""
    flux = np.zeros((pyramid.cells[depth].count, 3))
    for k in (depth, depth + 1):
        if k > DEPTH:
            continue
        cells, nodes = pyramid.cells[k], pyramid.nodes[k]
        local = download(nodes.depths).astype(float)
        fraction = np.clip(1 - (k - local), 0, 1) if k > 1 else np.ones_like(local)
        fraction = fraction if k == depth else 1 - fraction
        fraction[download(nodes.states) != TREE_ENDS] = 0
        values = download(cells.sums) * (fraction * 4.0 ** (depth - local) / 1.5)[:, None]
        into = np.arange(cells.count) if k == depth else download(cells.parents)
        np.add.at(flux, into, values)
    return download(pyramid.cells[depth].means).astype(float) * (1 << depth), flux


def coefficients(pyramid, depth):
    """V h of each cell's spline, and of one cell more on each side: [n + 2, n + 2, n + 2, 3], images as in a mirror."""
    n = 1 << depth
    positions, flux = spread_samples(pyramid, depth)
    weights = [spline(positions[:, axis, None] - (np.arange(-1, n + 1) + 0.5)) for axis in range(3)]
    raw = np.einsum("px,py,pz,pc->xyzc", *weights, flux)
    for axis in range(3):
        raw = np.moveaxis(raw, axis, 0)
        raw[1] += raw[0]
        raw[-2] += raw[-1]
        raw[0], raw[-1] = raw[1], raw[-2]
        raw = np.moveaxis(raw, 0, axis)
    return raw


def spline_field(pyramid, depth, positions):
    """V h of a level's splines at positions x, y, z (each [m], in cells of the level): [m, m, m, 3]."""
    n = 1 << depth
    weights = [spline(axis[:, None] - (np.arange(-1, n + 1) + 0.5)) for axis in positions]
    return np.einsum("ax,by,cz,xyzk->abck", *weights, coefficients(pyramid, depth))


def hats(n, positions):
    """Values of the corners' functions of a level at positions in cells: [m, n + 1]."""
    return np.maximum(1 - np.abs(positions[:, None] - np.arange(n + 1)), 0)


def gauss(n):
    """(positions in the cube, weights): three Gauss points in each of n cells, exact for degree five."""
    at = np.array([-np.sqrt(0.6), 0, np.sqrt(0.6)]) / 2 + 0.5
    return ((np.arange(n)[:, None] + at) / n).ravel(), np.tile(np.array([5, 8, 5]) / 18 / n, n)


def as_grid(values, level):
    """Corner values of a level [n + 1, n + 1, n + 1]."""
    n = 1 << level.depth
    positions, values = slot_cells(level), np.asarray(values)
    inside = (positions <= n).all(axis=1)
    grid = np.full((n + 1, n + 1, n + 1), np.nan)
    grid[tuple(positions[inside].T)] = values[inside]
    assert not np.isnan(grid).any()
    return grid


@pytest.mark.slow
@pytest.mark.parametrize("depth", [1, 3])
def test_right_hand_sides_are_integrals_over_the_cube(device, tolerances, depth):
    """Of V against each function's gradient; V of coarser levels goes from corner to corner of the next in a line."""
    pyramid = scene(device)
    assert len({k for k in (1, 2, 3) if np.abs(spread_samples(pyramid, k)[1]).max() > 0}) >= 2
    n = 1 << depth
    x, weight = gauss(1 << DEPTH)
    field = np.zeros((len(x),) * 3 + (3,))
    for k in range(1, DEPTH + 1):
        if k >= depth:
            own = spline_field(pyramid, k, [x * 2**k] * 3) * 2.0**k
        else:
            corners = np.arange(2 ** (k + 1) + 1) / 2
            lines = hats(2 ** (k + 1), x * 2 ** (k + 1))
            at_corners = spline_field(pyramid, k, [corners] * 3) * 2.0**k
            own = np.einsum("ai,bj,ck,ijkd->abcd", lines, lines, lines, at_corners)
        field += own  # V itself, in cubes
    away = x[:, None] * n - np.arange(n + 1)
    slopes = np.where(np.abs(away) < 1, -np.sign(away), 0)
    values, derivatives = hats(n, x * n) * weight[:, None], slopes * n * weight[:, None]
    expected = sum(
        np.einsum("ai,bj,ck,abc->ijk", *[derivatives if a == axis else values for a in range(3)], field[..., axis])
        for axis in range(3)
    )
    tested = as_grid(download(constraints(pyramid)[depth]), pyramid.levels[depth])
    np.testing.assert_allclose(tested, expected * n, atol=tolerances.spline_integral * np.abs(expected * n).max())


def test_a_converged_solution_matches_a_sparse_solver(device, tolerances, monkeypatch):
    monkeypatch.setattr(poisson, "COARSE_SWEEPS", 150)
    pyramid, weight = scene(device), 0.05
    tests = constraints(pyramid)
    solutions = solve(pyramid, tests, weight, one_face(device))
    for depth in range(1, DEPTH + 1):
        n = 1 << depth
        mass, stiff = (
            sparse.diags([np.full(n, side), np.r_[end, np.full(n - 1, 2 * end), end], np.full(n, side)], [-1, 0, 1])
            for side, end in ((1 / 6, 1 / 3), (-1.0, 1.0))
        )
        products = ((stiff, mass, mass), (mass, stiff, mass), (mass, mass, stiff))
        system = sum(sparse.kron(sparse.kron(x, y), z) for x, y, z in products)
        cells = pyramid.cells[depth]
        lines = [hats(n, download(cells.means)[:, axis].astype(float) * n) for axis in range(3)]
        pulls = sparse.diags(weight * 4.0**depth * download(cells.weights))
        rows = sparse.csr_matrix(np.einsum("px,py,pz->pxyz", *lines).reshape(cells.count, -1))
        system = sparse.csc_matrix(system + rows.T @ pulls @ rows)
        expected = spsolve(system, as_grid(download(tests[depth]), pyramid.levels[depth]).ravel())
        solution = as_grid(download(solutions[depth]), pyramid.levels[depth]).ravel()
        np.testing.assert_allclose(solution, expected, atol=tolerances.poisson_solution * np.abs(expected).max())


def test_the_value_on_the_surface_is_the_mean_at_the_samples_where_levels_differ(device):
    """Each sample's value is that of the finest cell around it; a slot without a cell may lack corners."""
    pyramid = tree_of(ball_samples(4000, 0.002), 8, device)
    solutions = solve(pyramid, constraints(pyramid), 0.01, one_face(device))
    grids = [None]
    for level, solution in zip(pyramid.levels[1:], solutions[1:], strict=True):
        grids.append({tuple(p): v for p, v in zip(slot_cells(level).tolist(), download(solution), strict=True)})
    total, below, missed = np.zeros(2), set(), 0
    for depth in range(len(pyramid.levels) - 1, 0, -1):
        n, cells, level = 1 << depth, pyramid.cells[depth], pyramid.levels[depth]
        existing = {tuple(p) for p in slot_cells(level)[is_cell(level)].tolist()}
        cell_indices = code_cells(download(cells.codes)).tolist()
        fractions = download(cells.means).astype(float) * n - cell_indices
        for position, fraction, weight in zip(cell_indices, fractions, download(cells.weights), strict=True):
            if tuple(position) not in existing:
                missed += 1
                continue
            if tuple(position) in below:
                continue
            value = 0.0
            for k in range(8):
                step = np.array([k & 1, k >> 1 & 1, k >> 2 & 1])
                value += np.where(step, fraction, 1 - fraction).prod() * grids[depth][tuple((position + step).tolist())]
            total += weight * np.array([value, 1])
        below |= {tuple(c // 2 for c in position) for position in existing}
    assert missed > 100
    sums = download(mean_at_samples(pyramid, solutions))[0]
    assert abs(sums[0] / sums[1] - total[0] / total[1]) < 1e-5 * abs(total[0] / total[1])

"""The Poisson system of a level: right-hand sides by integration, solutions by scipy's sparse solver, in float64."""

import numpy as np
import pytest
from scipy import sparse
from scipy.sparse.linalg import spsolve

from pointloom.kernels.lang import vec2d
from pointloom.kernels.memory import download, upload
from pointloom.kernels.reconstruction import poisson
from pointloom.kernels.reconstruction.poisson import mean_at_samples, solve
from pointloom.kernels.reconstruction.poisson_system import constraints
from pointloom.kernels.reconstruction.sample_density import ENDS

from .octree_trees import ball_samples, code_cells, is_cell, slot_cells, tree_of
from .test_sample_cells import spline

DEPTH = 3  # all cells of all levels exist, so arrays [n, n, n] represent them


def one_face(device):
    """Samples for one face of the cube, which give a known pull."""
    return upload(np.ones((1, 2)), vec2d, device)


def mean_of(pyramid, solutions):
    total, weight = download(mean_at_samples(pyramid, solutions))[0]
    return total / weight


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
        share = np.clip(1 - (k - local), 0, 1) if k > 1 else np.ones_like(local)
        share = share if k == depth else 1 - share
        share[download(nodes.states) != ENDS] = 0
        values = download(cells.sums) * (share * 4.0 ** (depth - local) / 1.5)[:, None]
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


def slopes(n, positions):
    away = positions[:, None] - np.arange(n + 1)
    return np.where(np.abs(away) < 1, -np.sign(away), 0)


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
    values, derivatives = hats(n, x * n) * weight[:, None], slopes(n, x * n) * n * weight[:, None]
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


def test_the_value_on_the_surface_is_the_mean_at_the_samples(device):
    pyramid = scene(device)
    solutions = solve(pyramid, constraints(pyramid), 0.05, one_face(device))
    total, below = np.zeros(2), set()
    for depth in range(DEPTH, 0, -1):
        n, cells = 1 << depth, pyramid.cells[depth]
        cell_indices = code_cells(download(cells.codes))
        chosen = np.array([tuple(p) not in below for p in cell_indices])
        grid = as_grid(download(solutions[depth]), pyramid.levels[depth])
        lines = [hats(n, download(cells.means)[:, axis].astype(float) * n) for axis in range(3)]
        values = np.einsum("px,py,pz,xyz->p", *lines, grid)
        total += (download(cells.weights) * chosen * [values, np.ones_like(values)]).sum(axis=1)
        below = {tuple(p) for p in cell_indices // 2}
    assert abs(mean_of(pyramid, solutions) - total[0] / total[1]) < 1e-6 * np.abs(values).max()


def test_fine_corners_without_a_cell_have_the_coarse_values(device):
    pyramid = tree_of(ball_samples(4000, 0.002), 8, device)
    solutions = solve(pyramid, constraints(pyramid), 0.01, one_face(device))
    assert len(pyramid.levels) > 6
    for depth in range(6, len(pyramid.levels)):
        above, level = pyramid.levels[depth - 1], pyramid.levels[depth]
        cells = {tuple(p) for p in slot_cells(level)[np.repeat(download(level.has_cells), 8) == 1]}
        coarse = {tuple(p): v for p, v in zip(slot_cells(above), download(solutions[depth - 1]), strict=True)}
        fine, checked = download(solutions[depth]), 0
        for position, value in zip(slot_cells(level)[::7], fine[::7], strict=True):
            around = [tuple(position - [k & 1, k >> 1 & 1, k >> 2 & 1]) for k in range(8)]
            inside = [c for c in around if min(c) >= 0 and max(c) < 1 << depth]
            if max(position) > 1 << depth or all(c in cells for c in inside):
                continue
            corners = [position // 2 + (position & 1) * [k & 1, k >> 1 & 1, k >> 2 & 1] for k in range(8)]
            assert abs(value - np.mean([coarse[tuple(c)] for c in corners])) < 1e-6
            checked += 1
        assert checked > 50


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
        shares = download(cells.means).astype(float) * n - cell_indices
        for position, share, weight in zip(cell_indices, shares, download(cells.weights), strict=True):
            if tuple(position) not in existing:
                missed += 1
                continue
            if tuple(position) in below:
                continue
            value = 0.0
            for k in range(8):
                step = np.array([k & 1, k >> 1 & 1, k >> 2 & 1])
                value += np.where(step, share, 1 - share).prod() * grids[depth][tuple((position + step).tolist())]
            total += weight * np.array([value, 1])
        below |= {tuple(c // 2 for c in position) for position in existing}
    assert missed > 100
    assert abs(mean_of(pyramid, solutions) - total[0] / total[1]) < 1e-5 * abs(total[0] / total[1])

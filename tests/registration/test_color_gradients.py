"""Color gradients along a surface are the least squares over the neighbors, for colored ICP."""

import numpy as np
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

import pointloom as loom

from .color_surfaces import gradients_of, paint, wavy


def lists_within(points, radius, max_nn):
    """The hybrid search in float64: each point's nearest neighbors within the radius, itself included."""
    sqdists, rows = cKDTree(points).query(points, min(max_nn, len(points)))
    sqdists, rows = sqdists.reshape(len(points), -1), rows.reshape(len(points), -1)
    return [near[squared_distances < radius] for near, squared_distances in zip(rows, sqdists, strict=True)]


def reference_gradients(points, normals, intensities, radius, max_nn):
    """The minimum-norm least squares in float64 over the neighbors, projected onto the tangent plane."""
    points, normals = np.asarray(points, np.float64), np.asarray(normals, np.float64)
    gradients = np.zeros((len(points), 3))
    for row, near in enumerate(lists_within(points, radius, max_nn)):
        if len(near) >= 4 and normals[row].any():
            n = normals[row] / np.linalg.norm(normals[row])
            ways = points[near] - points[row]
            ways = ways - np.outer(ways @ n, n)
            gradients[row] = np.linalg.lstsq(ways, intensities[near] - intensities[row], rcond=1e-3)[0]
    return gradients


def test_gradients_in_the_fragment_match_least_squares(device, scan_set, fragment, tolerances):
    part = {"shipped": np.s_[:4000], "real": np.s_[40000:44000]}[scan_set]
    points, normals, colors = (a[part].astype(np.float32) for a in (fragment.points, fragment.normals, fragment.colors))
    intensities, gradients = gradients_of(points, normals, colors, 0.06, 30, device)
    expected = reference_gradients(points, normals, intensities.astype(np.float64), 0.06, 30)
    size = np.abs(expected).max(axis=1)
    error = np.abs(gradients - expected).max(axis=1) / np.maximum(size, size.max() / 100)
    assert size.max() > 1
    assert (error < tolerances.gradient).mean() >= tolerances.gradient_share
    np.testing.assert_allclose(intensities, colors.mean(axis=1), atol=2e-7)
    lengths = np.linalg.norm(gradients, axis=1) * np.linalg.norm(normals, axis=1)
    assert (np.abs((gradients * normals).sum(axis=1)) <= 1e-6 * lengths).all(), "a gradient lies in the plane"


def test_gradients_do_not_depend_on_the_unit_of_length(device, rng):
    """Open3D's do, as its neighbors are not projected onto the plane."""
    points = wavy(rng, 800)
    normals = loom.PointCloud(points).estimate_normals(max_nn=12).normals
    one, other = (
        gradients_of(points * np.float32(unit), normals, paint(points), 0.3 * unit, 30, device)[1] * unit
        for unit in (1.0, 128.0)
    )
    np.testing.assert_allclose(one, other, atol=1e-6 * np.abs(one).max())


def test_the_gradient_of_a_linear_color_is_exact(device, rng):
    """On planes of any pose, for any neighbors, and with normals of any length."""
    R = Rotation.from_rotvec([0.4, -1.1, 0.3]).as_matrix()
    plane = np.column_stack([rng.uniform(-1, 1, (600, 2)), np.zeros(600)])
    true = R @ [0.3, -0.2, 0.0]
    points = (plane @ R.T + [3.0, -2.0, 1.0]).astype(np.float32)
    colors = np.repeat((0.5 + plane @ [0.3, -0.2, 0.0])[:, None], 3, axis=1)
    normals = np.outer(rng.uniform(0.1, 9.0, 600), R[:, 2]) * rng.choice([-1, 1], 600)[:, None]
    _, gradients = gradients_of(points, normals, colors, 0.5, 30, device)
    np.testing.assert_allclose(gradients, np.tile(true, (600, 1)), atol=2e-5)


def test_points_without_neighbors_or_extent_have_no_gradient(device, rng):
    colors = rng.random((50, 3))
    up = np.tile([0, 0, 1.0], (50, 1))
    assert not gradients_of(np.full((50, 3), 0.3), up, colors, 1.0, 30, device)[1].any(), "all at one place"
    assert not gradients_of(np.outer(np.arange(50), [0, 0, 1]), up, colors, 10.0, 30, device)[1].any(), (
        "along the normal"
    )
    assert not gradients_of(rng.random((50, 3)), up, colors, 1e-6, 30, device)[1].any(), "nobody near"
    assert not gradients_of(rng.random((50, 3)), up * 0, colors, 1.0, 30, device)[1].any(), "zero normals"


def test_non_finite_points_contribute_nothing(device, rng):
    points, normals = wavy(rng, 900), np.tile([0, 0, 1.0], (900, 1))
    colors, bad = paint(points), rng.permutation(900)[:90]
    spoiled, dark = points.copy(), colors.copy()
    spoiled[bad[:30]], spoiled[bad[30:40]], dark[bad[40:]] = np.nan, [np.inf, 0, 0], np.nan
    intensities, gradients = gradients_of(spoiled, normals, dark, 0.3, 900, device)
    good = np.setdiff1d(np.arange(900), bad)
    _, expected = gradients_of(points[good], normals[good], colors[good], 0.3, 900, device)
    np.testing.assert_allclose(gradients[good], expected, atol=1e-6)
    assert not gradients[bad].any() and np.isnan(intensities[bad[40:]]).all()
    normals[good[:7]] = [np.nan, 0, 1]
    _, lopsided = gradients_of(spoiled, normals, dark, 0.3, 900, device)
    assert not lopsided[good[:7]].any()
    np.testing.assert_array_equal(lopsided[good[7:]], gradients[good[7:]], "a neighbor's normal has no say")


lattice = st.lists(st.tuples(*[st.integers(-2, 2)] * 3, st.integers(0, 9)), min_size=1, max_size=40)


@settings(max_examples=25, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(rows=lattice, radius=st.sampled_from([0.9, 1.2, 2.1, 50.0]), normal=st.sampled_from([(0, 0, 1), (1, 2, -1)]))
def test_gradients_of_lattices_match_least_squares(device, rows, radius, normal):
    """Few points, duplicates, lines and planes; no distance equals the radius and no count cuts a tie."""
    table = np.array(rows, np.float64)
    points, colors = table[:, :3], table[:, 3:].repeat(3, axis=1) / 9
    normals = np.tile(np.array(normal, float), (len(points), 1))
    intensities, gradients = gradients_of(points, normals, colors, radius, 64, device)
    expected = reference_gradients(points, normals, intensities.astype(np.float64), radius, 64)
    np.testing.assert_allclose(gradients, expected, atol=1e-5)

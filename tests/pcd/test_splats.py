"""Gaussian splats: transformation of centers, axes and colors, and selection."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import pointloom as loom
from pointloom.pcd.harmonics import degree_of, harmonics_at, rotation_of_harmonics, signs_of_flip

UTM = np.array([500_000.0, 4_000_000.0, 100.0])


def made(count=200, degree=3, *, at=(0, 0, 0), device="cpu", seed=0) -> loom.GaussianSplats:
    rng = np.random.default_rng(seed)
    return loom.GaussianSplats(
        rng.normal(size=(count, 3)) + at,
        np.exp(rng.normal(-2, 1, (count, 3))),
        rng.normal(size=(count, 4)),
        rng.uniform(0.01, 0.99, count),
        rng.normal(0, 0.3, (count, (degree + 1) ** 2, 3)),
        device=device,
    )


def colors_from(splats: loom.GaussianSplats, directions) -> np.ndarray:
    return np.einsum("mk,nkc->nmc", harmonics_at(directions, splats.degree), splats.harmonics.astype(np.float64))


@pytest.fixture(scope="module")
def directions():
    rng = np.random.default_rng(1)
    vectors = rng.normal(size=(12, 3))
    return vectors / np.linalg.norm(vectors, axis=1, keepdims=True)


@pytest.mark.parametrize("at", [np.zeros(3), UTM], ids=["near", "utm"])
def test_a_similarity_moves_centers_axes_and_colors(at, directions, device):
    splats = made(at=at, device=device)
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = 2.5 * Rotation.from_rotvec([0.4, -1.1, 2.0]).as_matrix(), [1, 2, 3]
    moved = splats.transform(T)
    R = T[:3, :3] / 2.5
    np.testing.assert_allclose(moved.centers, splats.centers @ T[:3, :3].T + T[:3, 3], atol=2e-6)
    expected = 2.5**2 * R @ splats.covariances() @ R.T
    np.testing.assert_allclose(moved.covariances(), expected, atol=2e-6 * np.abs(expected).max())
    np.testing.assert_allclose(colors_from(moved, directions), colors_from(splats, directions @ R), atol=1e-6)
    np.testing.assert_array_equal(moved.opacities, splats.opacities)


def test_a_translation_leaves_every_bit_of_the_rest():
    splats = made()
    moved = splats.translate([1, 2, 3])
    for name in ("f_dc", "f_rest", "opacity", "scale", "rot"):
        np.testing.assert_array_equal(moved.cloud[name], splats.cloud[name])


@pytest.mark.parametrize("degree", range(5))
def test_harmonics_rotate_exactly(degree, directions):
    R = Rotation.from_rotvec([1.0, 0.3, -0.7]).as_matrix()
    rotation = rotation_of_harmonics(R, degree)
    np.testing.assert_allclose(rotation @ rotation.T, np.eye(len(rotation)), atol=1e-13)
    before, after = harmonics_at(directions @ R, degree)[:, 1:], harmonics_at(directions, degree)[:, 1:]
    np.testing.assert_allclose(after @ rotation, before, atol=1e-13)


def test_harmonics_basis_follows_the_paper(directions):
    x, y, z = directions.T
    one = np.sqrt(3 / (4 * np.pi))
    two = np.sqrt(15 / (4 * np.pi))
    by_hand = [-one * y, one * z, -one * x, two * x * y, -two * y * z]
    np.testing.assert_allclose(harmonics_at(directions, 2)[:, 1:6].T, by_hand, atol=1e-14)
    np.testing.assert_array_equal(signs_of_flip((1, -1, -1), 1), [-1, -1, 1])
    assert [degree_of(count) for count in (1, 4, 9, 16, 25, 5, 36, 0)] == [0, 1, 2, 3, 4, None, None, None]


def test_cleaning_keeps_visible_splats_within_size_limits(device):
    splats = made(2000, 0, device=device)
    cleaned = splats.clean(min_opacity=0.3, min_scale=0.1, max_scale=0.5)
    largest = splats.scales.max(axis=1)
    expected = (splats.opacities >= 0.3) & (largest >= 0.1) & (largest <= 0.5)
    assert 0 < expected.sum() < 2000
    np.testing.assert_array_equal(cleaned.centers, splats.centers[expected])
    assert len(splats.clean()) == 2000


def test_cleaning_removes_invalid_splats(device):
    cloud = made(6, 0, device=device).cloud.copy()
    scale, rot, opacity = (cloud[name].copy() for name in ("scale", "rot", "opacity"))
    scale[0, 1], scale[1, 0], rot[2], opacity[3] = np.nan, np.inf, 0, np.nan
    opacity[4], scale[4, 2] = np.inf, -np.inf  # fully opaque and flat: valid
    cloud["scale"], cloud["rot"], cloud["opacity"] = scale, rot, opacity
    splats = loom.GaussianSplats.from_cloud(cloud)
    np.testing.assert_array_equal(splats.clean().centers, cloud.points[4:])


def test_choosing_and_joining_keep_all_columns():
    splats, others = made(50, 3), made(30, 1, seed=2)
    box = loom.AxisAlignedBoundingBox([-1, -1, -1], [0.5, 1, 1])
    inside = (np.abs(splats.centers) <= 1).all(axis=1) & (splats.centers[:, 0] <= 0.5)
    np.testing.assert_array_equal(splats.crop(box).harmonics, splats.harmonics[inside])
    np.testing.assert_array_equal(splats.select_by_mask(inside).rotations, splats.rotations[inside])
    joined = loom.GaussianSplats.concatenate([splats, others])
    assert (len(joined), joined.degree) == (80, 3)
    np.testing.assert_array_equal(joined.harmonics[50:, :4], others.harmonics)
    assert not joined.harmonics[50:, 4:].any()


def test_a_cloud_of_the_centers_has_colors_and_shortest_axes():
    flat = loom.GaussianSplats([[1, 2, 3]], [[1, 1, 0.1]], [[np.sqrt(0.5), np.sqrt(0.5), 0, 0]], [0.25], [[1.0, 0, -9]])
    cloud = flat.to_point_cloud()
    np.testing.assert_allclose(np.abs(cloud.normals), [[0, 1, 0]], atol=1e-6)  # z rotated by 90 degrees about x
    np.testing.assert_allclose(cloud.colors, [[0.5 + 0.28209479, 0.5, 0]], atol=1e-6)
    np.testing.assert_allclose(cloud["opacity"], [0.25], atol=1e-6)

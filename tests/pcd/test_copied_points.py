"""Clouds with copies of positions have the results of the distinct positions where copies would fill neighborhoods."""

import numpy as np
import pytest

import pointloom as loom

from ..products import few_quick

reg = loom.registration


def bumps(rng, count: int = 600) -> loom.PointCloud:
    x, y = rng.uniform(-1, 1, (2, count))
    points = np.float32(np.column_stack([x, y, 0.3 * np.sin(3 * x) * np.cos(2 * y)])).astype(float)
    normals = rng.normal([0, 0, 1], 0.1, (count, 3))
    normals[::3] *= -1  # some are opposed
    return loom.PointCloud(points, normals=normals, colors=rng.random((count, 3)))


def copied(cloud: loom.PointCloud, copies: int, device, *, interleaved: bool) -> loom.PointCloud:
    rows = np.arange(len(cloud) * copies)
    rows = rows % len(cloud) if interleaved else rows // copies
    return cloud.select_by_index(rows).to(device)


def moved_by(method):
    """The pose that registers the cloud with itself, moved."""

    def pose(cloud):
        T = np.eye(4)
        T[:3, 3] = 0.03, 0.02, -0.02
        target = cloud.transform(T).estimate_normals(max_nn=30)
        return method(cloud.estimate_normals(max_nn=30), target).transformation

    return pose


def icp(estimation):
    return moved_by(lambda a, b: reg.registration_icp(a, b, 0.2, estimation_method=estimation()))


PER_POINT = {
    "estimate_normals": lambda c: c.estimate_normals(max_nn=30).normals,
    "estimate_normals within": lambda c: c.estimate_normals(radius=0.3, max_nn=30).normals,
    "estimate_covariances": lambda c: c.estimate_covariances(max_nn=20).covariances,
    "compute_eigen_features": lambda c: loom.compute_eigen_features(c, max_nn=20)["eigenvalues"],
    "estimate_curvature": lambda c: loom.estimate_curvature(c, max_nn=20)["curvature"],
    "compute_fpfh_feature": lambda c: loom.compute_fpfh_feature(c, max_nn=40),
    "compute_fpfh_feature of rows": lambda c: loom.compute_fpfh_feature(c, max_nn=40, indices=np.arange(len(c))),
    "smooth_mls": lambda c: c.smooth_mls(radius=0.3, max_nn=20).points,
    "smooth_bilateral": lambda c: c.smooth_bilateral(radius=0.3, max_nn=20).points,
    "smooth_laplacian": lambda c: c.smooth_laplacian(3).points,
    "smooth_laplacian, fixed": lambda c: c.smooth_laplacian(3, use_fixed_neighborhoods=True).points,
    "region_growing": lambda c: c.estimate_normals().region_growing(10.0, min_cluster_size=1),
}
OF_ALL = {
    "normal_disagreement": lambda c: c.normal_disagreement(),
    "detect_planar_patches": lambda c: [len(c.estimate_normals().detect_planar_patches())],
    "remove_statistical_outlier": lambda c: np.unique(c.remove_statistical_outlier(20, 1.0)[0].points, axis=0),
    "compute_iss_keypoints": lambda c: np.unique(loom.compute_iss_keypoints(c).points, axis=0),
    "create_surface, ball": lambda c: [
        loom.meshing.create_surface(c, "ball", new_normals=True).mesh.get_surface_area()
    ],
    "create_surface, alpha": lambda c: [loom.meshing.create_surface(c, "alpha").support.bent],
    "registration_icp, generalized": icp(reg.TransformationEstimationForGeneralizedICP),
    "registration_icp, colored": icp(reg.TransformationEstimationForColoredICP),
    "registration_icp, planes": icp(reg.TransformationEstimationPointToPlane),
    "registration_icp, symmetric": icp(reg.TransformationEstimationSymmetric),
}


NAMES = [*PER_POINT, *OF_ALL]


@few_quick(
    len(NAMES),
    ("name", "interleaved"),
    [(name, (k + late) % 2 == 0) for late in (0, 1) for k, name in enumerate(NAMES)],
)
def test_copies_do_not_fill_neighborhoods(device, rng, name, interleaved):
    cloud, measure = bumps(rng), (PER_POINT | OF_ALL)[name]
    expected = np.asarray(measure(cloud.to(device)))
    result = np.asarray(measure(copied(cloud, 35, device, interleaved=interleaved)))
    if name in PER_POINT:
        expected = (
            np.tile(expected, (35, *[1] * (expected.ndim - 1))) if interleaved else np.repeat(expected, 35, axis=0)
        )
    np.testing.assert_allclose(result, expected, rtol=1e-6, atol=1e-6)


def test_only_neighborhoods_that_copies_fill_change(device, rng):
    """A pile of invalid returns at one position has no effect beyond the neighborhoods that contain it."""
    cloud = bumps(rng)
    pile = loom.PointCloud(np.concatenate([cloud.points, np.full((500, 3), [0.0, 0.0, 5.0])]), device=device)
    alone = cloud.to(device).without("normals").estimate_normals(max_nn=20).normals
    np.testing.assert_array_equal(pile.estimate_normals(max_nn=20).normals[: len(cloud)], alone)


def test_a_radius_without_other_positions_is_reported(device, rng):
    copies = copied(bumps(rng), 4, device, interleaved=False)
    for call in (
        copies.estimate_normals,
        copies.estimate_covariances,
        lambda **r: loom.compute_fpfh_feature(copies, **r),
    ):
        with pytest.warns(loom.UnitWarning, match="radius: most points have fewer than"):
            call(radius=1e-5)

"""Registration without a starting pose: by correspondences of which nearly all are wrong, and by the clouds alone."""

from __future__ import annotations

import os
import subprocess
import sys

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

import pointloom as loom
from pointloom.kernels.lang import cpu_compiler
from pointloom.registration import robust_global
from pointloom.registration.robust_global import rate_support

from .poses import moved

reg = loom.registration


def pose(rotation, translation):
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = rotation.as_matrix(), translation
    return T


def random_pose(rng, size=1.0):
    return pose(Rotation.random(random_state=int(rng.integers(2**31))), size * rng.normal(size=3))


def misplacement(found, T, points):
    """The angle [degrees] between two poses, and how far apart [m] they bring the middle of some points."""
    angle = np.degrees(Rotation.from_matrix(found[:3, :3] @ T[:3, :3].T).magnitude())
    middle = points.mean(axis=0)
    return angle, np.linalg.norm(moved(middle, found) - moved(middle, T))


def rough_pair(rng, count=1000, right=30, noise=0.003):
    """Random points in a unit cube, moved, of whose `count` correspondences `right` are right."""
    p = rng.random((count, 3))
    T = random_pose(rng)
    q = moved(p, T) + rng.normal(0, noise, p.shape)
    pairs = np.column_stack([np.arange(count), np.arange(count)])
    pairs[right:, 1] = rng.integers(0, count, count - right)
    return p, q, pairs[rng.permutation(count)], T


def hills(rng, count, extent=2.0):
    """Points of a surface with hills, no part of which is like another."""
    xy = rng.uniform(-extent, extent, (count, 2))
    z = 0.15 * np.sin(3 * xy[:, 0]) * np.cos(2 * xy[:, 1])
    places = np.random.default_rng(3).uniform(-extent, extent, (40, 3))
    for x, y, height in places:
        z += 0.2 * height / extent * np.exp(-((xy[:, 0] - x) ** 2 + (xy[:, 1] - y) ** 2) / 0.08)
    return np.column_stack([xy, z + rng.normal(0, 0.002, count)])


@pytest.fixture(scope="module")
def hilly_pair():
    """Two samplings of a hilly surface that share 60 %, and the pose between them: 75 degrees."""
    rng = np.random.default_rng(4)
    target, source = hills(rng, 25000), hills(rng, 25000)
    T = pose(Rotation.from_rotvec(np.radians(75) * np.array([0.3, 0.2, 0.93]) / 1.0), [1, 2, 3])
    target, source = target[target[:, 0] < 0.5], source[source[:, 0] > -0.5]
    return moved(source, np.linalg.inv(T)), target, T


# ------------------------------------------------------------------------------------------------ correspondences


@pytest.mark.parametrize(("count", "right"), [(300, 30), (1000, 30), (2000, 25), (3000, 30)])
def test_the_pose_is_found_among_wrong_correspondences(device, rng, tolerances, count, right):
    p, q, pairs, T = rough_pair(rng, count, right)
    source, target = loom.PointCloud(p, device=device), loom.PointCloud(q, device=device)
    result = reg.registration_robust_based_on_correspondence(source, target, pairs, 0.015)
    angle, distance = misplacement(result.transformation, T, p)
    assert angle < tolerances.robust_degrees and distance < tolerances.robust_distance
    assert result.score > 0.8 and result.converged and result.reason == "converged"


def test_one_right_correspondence_in_a_hundred_is_enough_in_ten_thousand(device, rng, tolerances):
    p, q, pairs, T = rough_pair(rng, 10000, 100, noise=0.002)
    source, target = loom.PointCloud(p, device=device), loom.PointCloud(q, device=device)
    result = reg.registration_robust_based_on_correspondence(source, target, pairs, 0.01)
    angle, distance = misplacement(result.transformation, T, p)
    assert angle < tolerances.robust_degrees and distance < tolerances.robust_distance and result.score > 0.9


def test_wrong_correspondences_alone_are_not_believed(device, rng):
    for count in (20, 200, 1500):
        p, q, pairs, _ = rough_pair(rng, count, 0)
        result = reg.registration_robust_based_on_correspondence(
            loom.PointCloud(p, device=device), loom.PointCloud(q, device=device), pairs, 0.015
        )
        assert result.score < 0.3 and not result.converged


def test_two_motions_with_as_many_correspondences_leave_doubt(device, rng):
    p = rng.random((200, 3))
    q = np.vstack([moved(p[:100], random_pose(rng)), moved(p[100:], random_pose(rng))])
    pairs = np.column_stack([np.arange(200)] * 2)
    source, target = loom.PointCloud(p, device=device), loom.PointCloud(q, device=device)
    even = reg.registration_robust_based_on_correspondence(source, target, pairs, 0.01)
    most = reg.registration_robust_based_on_correspondence(source, target, pairs[:125], 0.01)
    assert even.score < 0.1 and not even.converged and "another pose" in even.reason
    assert most.score > 0.8 and most.converged


@settings(max_examples=15, deadline=None)
@given(st.integers(0, 2**31 - 1), st.integers(8, 40), st.sampled_from(["taichi", "warp"]))
def test_exact_correspondences_give_the_exact_pose(seed, count, compiler):
    rng = np.random.default_rng(seed)
    T, p = random_pose(rng, 10.0), rng.random((count, 3))
    pairs = np.column_stack([np.arange(count)] * 2)
    with cpu_compiler(compiler):
        result = reg.registration_robust_based_on_correspondence(
            loom.PointCloud(p), loom.PointCloud(moved(p, T)), pairs, 0.02
        )
    np.testing.assert_allclose(result.transformation, T, atol=1e-5 * (1 + np.abs(T).max()))
    assert result.fitness == 1.0


def test_coordinates_far_from_zero_cost_nothing(device, rng, tolerances):
    p, q, pairs, T = rough_pair(rng, 600, 40)
    far = np.array([5e5, 5.4e6, 300.0])
    T_far = T.copy()
    T_far[:3, 3] += far - T[:3, :3] @ far
    source, target = loom.PointCloud(p + far, device=device), loom.PointCloud(q + far, device=device)
    assert source.origin.any()
    result = reg.registration_robust_based_on_correspondence(source, target, pairs, 0.015)
    angle, distance = misplacement(result.transformation, T_far, p + far)
    assert angle < tolerances.robust_degrees and distance < tolerances.robust_distance and result.score > 0.8


def test_points_that_are_not_finite_and_duplicates_change_nothing(device, rng, tolerances):
    p, q, pairs, T = rough_pair(rng, 500, 40)
    p[7], q[9, 1] = np.nan, np.inf
    wrong = pairs[pairs[:, 0] != pairs[:, 1]]
    pairs = np.vstack([pairs, np.repeat(wrong[:1], 300, axis=0)])  # one wrong correspondence, 300 times
    source, target = loom.PointCloud(p, device=device), loom.PointCloud(q, device=device)
    result = reg.registration_robust_based_on_correspondence(source, target, pairs, 0.015)
    angle, distance = misplacement(result.transformation, T, p[np.isfinite(p).all(axis=1)])
    assert angle < tolerances.robust_degrees and distance < tolerances.robust_distance


@pytest.mark.parametrize("count", [0, 1, 2])
def test_too_few_correspondences_are_a_reason(device, count):
    cloud = loom.PointCloud(np.eye(3), device=device)
    pairs = np.column_stack([np.arange(count)] * 2)
    result = reg.registration_robust_based_on_correspondence(cloud, cloud, pairs, 0.1)
    assert (result.transformation == np.eye(4)).all() and result.fitness == 0 and result.score == 0
    assert not result.converged and f"of {count} correspondences" in result.reason


def test_three_correspondences_give_a_pose_that_is_not_believed(device):
    cloud = loom.PointCloud(np.eye(3), device=device)
    result = reg.registration_robust_based_on_correspondence(cloud, cloud, [[0, 0], [1, 1], [2, 2]], 0.1)
    np.testing.assert_allclose(result.transformation, np.eye(4), atol=1e-6)
    assert result.score < 0.1


def test_the_seed_chooses_where_correspondences_are_too_many(device, rng, tolerances, monkeypatch):
    monkeypatch.setattr(robust_global, "MOST_PAIRS", 300)
    p, q, pairs, T = rough_pair(rng, 1000, 400)
    source, target = loom.PointCloud(p, device=device), loom.PointCloud(q, device=device)
    found = [
        reg.registration_robust_based_on_correspondence(source, target, pairs, 0.015, seed=seed).transformation
        for seed in (0, 0, 1)
    ]
    assert (found[0] == found[1]).all() and (found[0] != found[2]).any()
    for transformation in found:
        angle, distance = misplacement(transformation, T, p)
        assert angle < tolerances.robust_degrees and distance < tolerances.robust_distance


def test_score_grows_with_the_lead_over_the_next():
    assert rate_support(np.array([])) == 0.0
    assert rate_support(np.array([3.0])) < 0.1
    assert rate_support(np.array([22.0, 10.0])) == pytest.approx(0.5)
    scores = [rate_support(np.array([k, 10.0])) for k in (10, 15, 22, 40, 100)]
    assert np.all(np.diff(scores) > 0) and scores[-1] > 0.99


def test_features_find_the_pose_and_the_clouds_rate_it(device, hilly_pair, angle_between):
    source, target, T = hilly_pair
    clouds = []
    for points in (source, target):
        thinned = loom.PointCloud(points, device=device).voxel_down_sample(0.05)
        thinned = thinned.estimate_normals(radius=0.15, max_nn=None)
        clouds.append(thinned.orient_normals_towards_camera_location(thinned.points.mean(axis=0)))
    features = [loom.compute_fpfh_feature(cloud, radius=0.25, max_nn=None) for cloud in clouds]
    result = reg.registration_robust_based_on_feature_matching(*clouds, *features, 0.075)
    assert angle_between(result.transformation, T) < 1.5 and result.score > 0.5
    one_way = reg.registration_robust_based_on_feature_matching(*clouds, *features, 0.075, mutual_filter=False)
    assert angle_between(one_way.transformation, T) < 1.5


def test_wrong_arguments_are_named(device):
    cloud = loom.PointCloud(np.eye(3), device=device)
    robust = reg.registration_robust_based_on_correspondence
    with pytest.raises(ValueError, match="noise_bound: expected a finite number > 0, got 0"):
        robust(cloud, cloud, [[0, 0]], 0)
    with pytest.raises(IndexError, match="corres: target indices"):
        robust(cloud, cloud, [[0, 3]], 1.0)
    with pytest.raises(ValueError, match=r"corres: expected shape \[n, 2\]"):
        robust(cloud, cloud, [[0, 3, 1]], 1.0)
    with pytest.raises(TypeError, match="source: expected a PointCloud"):
        robust(np.eye(3), cloud, [[0, 0]], 1.0)
    with pytest.raises(ValueError, match="seed"):
        robust(cloud, cloud, [[0, 0]], 1.0, seed=-1)
    with pytest.raises(ValueError, match="voxel_size: expected a finite number > 0, got nan"):
        reg.register_globally(cloud, cloud, voxel_size=np.nan)
    with pytest.raises(TypeError, match="target: expected a PointCloud"):
        reg.register_globally(cloud, np.eye(3), voxel_size=1.0)
    with pytest.raises(ValueError, match=r"source_feature: expected shape \[3, d\]"):
        reg.registration_robust_based_on_feature_matching(cloud, cloud, np.zeros((2, 5)), np.zeros((3, 5)), 1.0)


# ------------------------------------------------------------------------------------------------ clouds


def test_surfaces_come_together_from_any_pose(device, hilly_pair, tolerances):
    source, target, T = hilly_pair
    result = reg.register_globally(
        loom.PointCloud(source, device=device), loom.PointCloud(target, device=device), voxel_size=0.08
    )
    angle, distance = misplacement(result.transformation, T, source)
    assert angle < tolerances.global_surface_degrees and distance < tolerances.global_surface_distance
    assert result.score > 0.9 and result.converged and result.reason == "converged"
    pairs = result.correspondence_set
    apart = np.linalg.norm(moved(source, result.transformation)[pairs[:, 0]] - target[pairs[:, 1]], axis=1)
    assert len(pairs) > 0.4 * len(source) and apart.max() <= 0.12


def test_without_refinement_the_pose_is_that_of_the_correspondences(device, hilly_pair):
    source, target, T = hilly_pair
    clouds = [loom.PointCloud(points, device=device) for points in (source, target)]
    result = reg.register_globally(*clouds, voxel_size=0.08, refine=False)
    angle, distance = misplacement(result.transformation, T, source)
    assert angle < 2 and distance < 0.05 and result.iterations == 0


def test_attributes_origins_and_stray_points_change_nothing(device, hilly_pair, tolerances):
    source, target, T = hilly_pair
    plain = reg.register_globally(
        loom.PointCloud(source, device=device), loom.PointCloud(target, device=device), voxel_size=0.08
    )
    far = np.array([5e5, 5.4e6, 300.0])
    strays = np.array([[np.nan, 0, 0], [np.inf, 1, 2]])
    rows = np.r_[source, strays]
    moved_source = loom.PointCloud(rows, normals=np.full(rows.shape, 0.5), label=np.arange(len(rows)), device=device)
    result = reg.register_globally(moved_source, loom.PointCloud(target + far, device=device), voxel_size=0.08)
    T_far = T.copy()
    T_far[:3, 3] += far
    angle, distance = misplacement(result.transformation, T_far, source)
    assert angle < tolerances.global_surface_degrees and distance < tolerances.global_surface_distance
    assert result.score > 0.9 and abs(result.score - plain.score) < 0.05


def scan(data, name):
    return loom.read_point_cloud(data / "reg-bunny-scans" / "data" / f"{name}.ply").points


def scan_poses(data):
    poses = {}
    for line in (data / "reg-bunny-scans" / "data" / "bun.conf").read_text().splitlines():
        words = line.split()
        if words and words[0] == "bmesh":
            numbers = np.array(words[2:], float)
            poses[words[1].removesuffix(".ply")] = pose(Rotation.from_quat(numbers[3:] * [-1, -1, -1, 1]), numbers[:3])
    return poses


@pytest.mark.parametrize(
    ("left", "right", "limit"),
    [("bun000", "bun045", 0.6), ("bun000", "bun090", 1.0), ("bun180", "bun270", 1.0), ("bun270", "top2", 1.5)],
)
def test_range_scans_of_an_object_come_together(device, data, rng, left, right, limit):
    poses = scan_poses(data)
    start = random_pose(rng, 0.2)
    points = scan(data, left)[::2]
    source = loom.PointCloud(moved(points, start), device=device)
    target = loom.PointCloud(scan(data, right)[::2], device=device)
    T = np.linalg.inv(poses[right]) @ poses[left] @ np.linalg.inv(start)
    result = reg.register_globally(source, target, voxel_size=0.003)
    angle, distance = misplacement(result.transformation, T, moved(points, start))
    assert angle < limit and distance < 0.001 and result.score > 0.8


def test_scans_that_hardly_overlap_are_not_believed(device, data):
    for left, right in (("bun000", "bun180"), ("bun180", "top3"), ("bun090", "bun270")):
        clouds = [loom.PointCloud(scan(data, name)[::2], device=device) for name in (left, right)]
        result = reg.register_globally(*clouds, voxel_size=0.003)
        assert result.score < 0.5 and not result.converged and result.reason != "converged"


def test_a_few_hundred_points_are_enough(device, data, rng):
    poses, folder = scan_poses(data), data / "pcl-tests" / "test"
    start = random_pose(rng, 0.2)
    points = loom.read_point_cloud(folder / "bun0.pcd").points
    source = loom.PointCloud(moved(points, start), device=device)
    target = loom.read_point_cloud(folder / "bun4.pcd").to(device)
    T = np.linalg.inv(poses["bun045"]) @ poses["bun000"] @ np.linalg.inv(start)
    result = reg.register_globally(source, target, voxel_size=0.006)
    angle, distance = misplacement(result.transformation, T, moved(points, start))
    assert angle < 1.5 and distance < 0.002 and result.score > 0.9


@pytest.mark.parametrize("seed", range(4))
def test_rooms_come_together_from_any_pose(device, kitchen_pair, tolerances, seed):
    rng = np.random.default_rng(seed)
    start = random_pose(rng, 2.0)
    step = 8  # of 313,395 and 258,342 points, still several a voxel
    source = moved(kitchen_pair.source[::step], start)
    clouds = [loom.PointCloud(points, device=device) for points in (source, kitchen_pair.target[::step])]
    T = kitchen_pair.T @ np.linalg.inv(start)
    result = reg.register_globally(*clouds, voxel_size=0.05, seed=seed)
    angle, distance = misplacement(result.transformation, T, source)
    assert angle < tolerances.global_kitchen_degrees and distance < tolerances.global_kitchen_distance
    assert result.score > 0.8
    # ICP from the true pose comes to rest as far from it: the fragments are not rigid copies of each other.
    target = clouds[1].estimate_normals(radius=0.1, max_nn=30)
    plane = reg.TransformationEstimationPointToPlane()
    rests = [reg.registration_icp(clouds[0], target, 0.05, M, plane).transformation for M in (result.transformation, T)]
    angle, distance = misplacement(*rests, source)
    assert angle < tolerances.global_rest_degrees and distance < tolerances.global_rest_distance


def test_lidar_scans_come_together(device, kitti_pair, tolerances):
    start = pose(Rotation.from_rotvec([0.1, -0.2, 2.5]), [10, -20, 3])
    source = moved(kitti_pair.source[::2], start)
    clouds = [loom.PointCloud(points, device=device) for points in (source, kitti_pair.target[::2])]
    result = reg.register_globally(*clouds, voxel_size=0.5)
    angle, distance = misplacement(result.transformation, kitti_pair.T @ np.linalg.inv(start), source)
    assert angle < tolerances.global_lidar_degrees and distance < tolerances.global_lidar_distance
    assert result.score > 0.9


def test_an_object_is_found_in_its_scene(device, data):
    folder = data / "pcl-tests" / "test"
    milk = loom.read_point_cloud(folder / "milk_color.pcd").remove_non_finite_points()
    scene = loom.read_point_cloud(folder / "milk_cartoon_all_small_clorox.pcd").remove_non_finite_points()
    near = (scene.points > [-0.6, -0.5, 0.5]).all(axis=1) & (scene.points < [0.6, 0.3, 1.4]).all(axis=1)
    scene = scene.select_by_mask(near)
    result = reg.register_globally(milk.to(device), scene.to(device), voxel_size=0.006)
    assert result.score > 0.9 and result.fitness > 0.9


# ------------------------------------------------------------------------------------------------ hopeless cases


def empty(rng):
    return np.empty((0, 3)), np.empty((0, 3))


def one_point(rng):
    return np.zeros((1, 3)), rng.random((500, 3))


def nowhere(rng):
    return np.full((100, 3), np.nan), rng.random((500, 3))


def at_one_place(rng):
    return np.ones((500, 3)), np.ones((500, 3))


def on_a_line(rng):
    p = np.linspace(0, 1, 3000)[:, None] * [1, 0, 0]
    return p, p


def planes(rng):
    p = rng.uniform(-1, 1, (2, 8000, 3))
    p[:, :, 2] = rng.normal(0, 0.004, (2, 8000))
    return p[0], p[1]


def spheres(rng):
    p = rng.normal(size=(2, 8000, 3))
    p *= (1 + rng.normal(0, 0.004, (2, 8000, 1))) / np.linalg.norm(p, axis=2, keepdims=True)
    return p[0], p[1]


def tubes(rng):
    turn, along = rng.uniform(0, 2 * np.pi, (2, 8000)), rng.uniform(-1, 1, (2, 8000))
    p = np.stack([0.5 * np.cos(turn), 0.5 * np.sin(turn), along], axis=2) + rng.normal(0, 0.004, (2, 8000, 3))
    return p[0], p[1]


def clouds_without_surface(rng):
    return rng.random((3000, 3)), rng.random((3000, 3))


def too_large(rng):
    return hills(rng, 6000), 1000 * hills(rng, 6000)


def too_small(rng):
    return hills(rng, 6000) / 1000, hills(rng, 6000)


HOPELESS = [
    empty, one_point, nowhere, at_one_place, on_a_line, planes, spheres, tubes, clouds_without_surface, too_large,
    too_small,
]  # fmt: skip


@pytest.mark.parametrize("make", HOPELESS, ids=lambda make: make.__name__)
def test_the_hopeless_ends_with_a_reason(device, rng, make):
    source, target = (loom.PointCloud(points, device=device) for points in make(rng))
    result = reg.register_globally(source, target, voxel_size=0.1)
    assert 0 <= result.score < 0.5 and not result.converged
    assert result.reason and result.reason != "converged"
    assert np.isfinite(result.transformation).all() and len(result.correspondence_set) <= len(source)


def test_a_box_has_more_than_one_pose(device, rng):
    def box():
        p = rng.uniform(-1, 1, (12000, 3))
        p[np.arange(12000), rng.integers(0, 3, 12000)] = rng.choice([-1, 1], 12000)
        return loom.PointCloud(p + rng.normal(0, 0.003, p.shape), device=device)

    result = reg.register_globally(box(), box(), voxel_size=0.1)
    assert result.score <= 0.5 and "poses fit alike" in result.reason


# ------------------------------------------------------------------------------------------------ repeatability


def test_two_runs_give_the_same_bits(device, hilly_pair):
    source, target, _ = hilly_pair
    clouds = [loom.PointCloud(points, device=device) for points in (source, target)]
    results = [reg.register_globally(*clouds, voxel_size=0.1, seed=3) for _ in range(2)]
    assert (results[0].transformation == results[1].transformation).all()
    assert results[0].score == results[1].score and results[0].fitness == results[1].fitness


def test_bits_do_not_depend_on_the_number_of_threads():
    program = (
        "import numpy as np, pointloom as loom\n"
        "rng = np.random.default_rng(0)\n"
        "p = rng.uniform(-1, 1, (8000, 3))\n"
        "p[:, 2] = 0.2 * np.sin(3 * p[:, 0]) * np.cos(4 * p[:, 1]) + 0.1 * np.sin(7 * p[:, 1] + p[:, 0])\n"
        "source, target = loom.PointCloud(p[:5000] + 3), loom.PointCloud(p[3000:])\n"
        "result = loom.registration.register_globally(source, target, voxel_size=0.06)\n"
        "print(result.transformation.tobytes().hex(), result.score, result.fitness)\n"
        "q = rng.random((1500, 3))\n"
        "pairs = np.column_stack([np.arange(1500), np.r_[np.arange(60), rng.integers(0, 1500, 1440)]])\n"
        "cloud = loom.PointCloud(q)\n"
        "result = loom.registration.registration_robust_based_on_correspondence(cloud, cloud, pairs, 0.02)\n"
        "print(result.transformation.tobytes().hex(), result.score)\n"
    )
    runs = []
    for threads in ("1", "2"):  # side by side: most of it is starting up
        environment = os.environ | {"POINTLOOM_CPU": "taichi", "POINTLOOM_CPU_THREADS": threads}
        pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
        runs.append(subprocess.Popen([sys.executable, "-c", program], env=environment, **pipes))
    outputs = [run.communicate() for run in runs]
    assert [run.returncode for run in runs] == [0, 0], outputs
    printed = [output for output, _ in outputs]
    assert printed[0] == printed[1] and len(printed[0]) > 200

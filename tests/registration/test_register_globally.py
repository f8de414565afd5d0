"""Global registration from any pose, or a result with the reason of failure; bitwise reproducible."""

import re

import numpy as np
import pytest

import pointloom as loom
from pointloom.kernels.lang import int32
from pointloom.kernels.memory import upload
from pointloom.kernels.surface.hollow_side import Surface
from pointloom.registration.assessment_constants import CHANCE_FEATURES
from pointloom.registration.evidence import Evidence, Witness
from pointloom.registration.globally.pair import _feature_ratio
from pointloom.registration.globally.pose_selection import PoseSelection, is_equal
from pointloom.registration.result import Registered
from pointloom.registration.rigid import to_local

from ..products import few_quick
from .hilly_clouds import hills, misplacement, uneven_ground
from .poses import moved, random_pose
from .room_corners import ONE, OTHER, corner

reg = loom.registration


def test_surfaces_are_registered_from_any_pose(device, hilly_pair, tolerances):
    source, target, T = hilly_pair
    clouds = [loom.PointCloud(points, device=device) for points in (source, target)]
    result = reg.register_globally(*clouds, voxel_size=0.08)
    angle, distance = misplacement(result.transformation, T, source)
    assert angle < tolerances.global_surface_degrees and distance < tolerances.global_surface_distance
    assert result.score > 0.9 and result.converged and result.reliable
    pairs = result.correspondence_set
    apart = np.linalg.norm(moved(source, result.transformation)[pairs[:, 0]] - target[pairs[:, 1]], axis=1)
    assert len(pairs) > 0.4 * len(source) and apart.max() <= 0.12
    rough = reg.register_globally(*clouds, voxel_size=0.08, refine=False)  # the pose from the correspondences
    angle, distance = misplacement(rough.transformation, T, source)
    assert angle < 2 and distance < 0.05 and rough.iterations == 0


def test_attributes_origins_and_stray_points_change_nothing(device, hilly_pair, tolerances):
    source, target, T = hilly_pair
    clouds = [loom.PointCloud(points, device=device) for points in (source, target)]
    plain = reg.register_globally(*clouds, voxel_size=0.08)
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


@few_quick(3, "seed", range(4))
def test_rooms_are_registered_from_any_pose(device, room_pair, tolerances, seed):
    rng = np.random.default_rng(seed)
    start = random_pose(rng, 2.0)
    source = moved(room_pair.source[::8], start)  # of 313,395 and 258,342 points, still several a voxel
    clouds = [loom.PointCloud(points, device=device) for points in (source, room_pair.target[::8])]
    T = room_pair.T @ np.linalg.inv(start)
    result = reg.register_globally(*clouds, voxel_size=0.05, seed=seed)
    angle, distance = misplacement(result.transformation, T, source)
    assert angle < tolerances.global_kitchen_degrees and distance < tolerances.global_kitchen_distance
    assert result.score > 0.8
    # ICP from the true pose converges equally far away: the fragments are not rigid copies of each other.
    target = clouds[1].estimate_normals(radius=0.1, max_nn=30)
    plane = reg.TransformationEstimationPointToPlane()
    rests = [reg.registration_icp(clouds[0], target, 0.05, M, plane).transformation for M in (result.transformation, T)]
    angle, distance = misplacement(*rests, source)
    assert angle < tolerances.global_rest_degrees and distance < tolerances.global_rest_distance


def planes(rng):
    p = rng.uniform(-1, 1, (2, 8000, 3))
    p[:, :, 2] = rng.normal(0, 0.004, (2, 8000))
    return p


def spheres(rng):
    p = rng.normal(size=(2, 8000, 3))
    p *= (1 + rng.normal(0, 0.004, (2, 8000, 1))) / np.linalg.norm(p, axis=2, keepdims=True)
    return p


def tubes(rng):
    angle, along = rng.uniform(0, 2 * np.pi, (2, 8000)), rng.uniform(-1, 1, (2, 8000))
    return np.stack([0.5 * np.cos(angle), 0.5 * np.sin(angle), along], axis=2) + rng.normal(0, 0.004, (2, 8000, 3))


HOPELESS = {
    "empty": lambda rng: np.empty((2, 0, 3)),
    "one_point": lambda rng: (np.zeros((1, 3)), rng.random((500, 3))),
    "non_finite": lambda rng: (np.full((100, 3), np.nan), rng.random((500, 3))),
    "coincident": lambda rng: np.ones((2, 500, 3)),
    "on_a_line": lambda rng: 2 * (np.linspace(0, 1, 3000)[:, None] * [1, 0, 0],),
    **{"planes": planes, "spheres": spheres, "tubes": tubes},
    "clouds_without_surface": lambda rng: rng.random((2, 3000, 3)),
    "too_large": lambda rng: (hills(rng, 6000), 1000 * hills(rng, 6000)),
    "too_small": lambda rng: (hills(rng, 6000) / 1000, hills(rng, 6000)),
}


@pytest.mark.parametrize("name", HOPELESS)
def test_impossible_registrations_fail_with_a_reason(device, rng, name):
    source, target = (loom.PointCloud(points, device=device) for points in HOPELESS[name](rng))
    result = reg.register_globally(source, target, voxel_size=0.1)
    assert 0 <= result.score < 0.5 and not result.converged
    assert result.warnings and not result.reliable
    assert np.isfinite(result.transformation).all() and len(result.correspondence_set) <= len(source)


def test_rooms_that_share_nothing_but_walls_are_rejected(device, rng):
    source, target = corner(rng, ONE), corner(rng, OTHER)
    start = random_pose(rng)
    clouds = [loom.PointCloud(points, device=device) for points in (moved(source, start), target)]
    result = reg.register_globally(*clouds, voxel_size=0.06)
    assert result.score < 0.5 and not result.converged
    assert "three planes" in result.warnings[0]


@few_quick(1, "pairs", [[(6, 14, 0.6), (16, 0, 0.6), (17, 4, 0.75)], [(1, 23, 0.6), (2, 20, 0.6)]])
def test_chance_fits_of_few_voxels_are_rejected(device, pairs):
    """Each of these was 84 to 177 degrees off: with so few voxels, some pose of a search fits by chance."""
    frames = loom.datasets.room_frames(1 + max(max(pair[:2]) for pair in pairs))
    for i, j, voxel in pairs:
        given = ((frames[k].depth, frames[k].intrinsic) for k in (i, j))
        pair = (loom.PointCloud.create_from_depth_image(*frame, device=device) for frame in given)
        result = reg.register_globally(*pair, voxel_size=voxel)
        assert result.score <= 0.5 and not result.converged
        assert re.search("so few voxels match|hardly", result.warnings[0]), result.warnings


def test_a_rejected_pose_causes_no_ambiguity():
    best = Evidence(0.6, 0.03, 1000, rest=0.5)
    assert is_equal(Evidence(0.62, 0.03, 1000, rest=0.45), best)
    assert not is_equal(Evidence(0.62, 0.03, 1000, rest=0.45, blocked=0.1), best)
    assert not is_equal(Evidence(0.62, 0.03, 1000, rest=0.1), best)
    assert not is_equal(Evidence(0.62, 0.03, 1000, rest=0.3), best)
    corner_alone = Evidence(0.6, 0.03, 1000, rest=0.0)
    assert is_equal(corner_alone, corner_alone) and not is_equal(Evidence(0.4, 0.03, 1000), corner_alone)


STEP = np.array([0.3, 0, 0.18])  # [m]


def staircase(rng, first, count):
    """Points of some equal steps beside a wall, 3 mm noise."""
    faces = [((0, 0, -0.18), STEP * count, (0, 0, 1.2))]
    for k in range(count):
        faces += [(STEP * k, (0.3, 0, 0), (0, 1.2, 0)), (STEP * k - [0, 0, 0.18], (0, 1.2, 0), (0, 0, 0.18))]
    start, a, b = np.array([[*map(np.asarray, face)] for face in faces], float).swapaxes(0, 1)
    areas = np.linalg.norm(np.cross(a, b), axis=1)
    face = rng.choice(len(areas), 30000, p=areas / areas.sum())
    u, v = rng.random((2, 30000, 1))
    return start[face] + u * a[face] + v * b[face] + STEP * first + rng.normal(0, 0.003, (30000, 3))


@pytest.mark.slow
def test_a_staircase_moved_by_a_step_is_an_alternative(device, rng):
    clouds = [loom.PointCloud(staircase(rng, *steps), device=device) for steps in ((0, 4), (-1, 6))]
    result = reg.register_globally(*clouds, voxel_size=0.05)
    shifts = np.array([pose[:3, 3] for pose in (result.transformation, *result.alternatives)])
    assert len(shifts) > 1 and np.abs(shifts - np.round(shifts @ STEP / (STEP @ STEP))[:, None] * STEP).max() < 0.03
    assert not result.reliable and f"{len(shifts) - 1} other pose" in result.warnings[0].replace("another", "1 other")
    pair = reg.register_pair(*clouds, voxel_size=0.05)
    assert not pair.reliable and len(pair.to_dict()["alternatives"]) == len(shifts) - 1


@few_quick(1, "heights_of", [2, 3])
def test_a_pose_on_gently_uneven_ground_is_refined_along_the_ground(device, heights_of):
    """The slopes determine it weakly. Poses 0.12 m off were returned, one with a second pose as an alternative."""
    rng = np.random.default_rng(heights_of)
    source, target = (uneven_ground(rng, heights_of, *ends, 20000) * [1, 1, 0.5] for ends in ((-2, 1), (-1, 2)))
    noise = rng.normal(0, 0.006, (2, *source.shape))
    start = random_pose(rng)
    source = moved(source + noise[0], start)
    clouds = [loom.PointCloud(points, device=device) for points in (source, target + noise[1])]
    result = reg.register_globally(*clouds, voxel_size=0.05)
    angle, distance = misplacement(result.transformation, np.linalg.inv(start), source)
    assert angle < 0.5 and distance < 0.015
    assert result.reliable and not result.alternatives


def test_a_box_has_more_than_one_pose(device, rng):
    def box():
        p = rng.uniform(-1, 1, (12000, 3))
        p[np.arange(12000), rng.integers(0, 3, 12000)] = rng.choice([-1, 1], 12000)
        return loom.PointCloud(p + rng.normal(0, 0.003, p.shape), device=device)

    result = reg.register_globally(box(), box(), voxel_size=0.1)
    assert result.score <= 0.5 and "poses fit equally well" in result.warnings[0]
    assert 1 <= len(result.alternatives) == len(result.to_dict()["alternatives"])
    for pose in result.alternatives:  # rotations of the box, which differ from the result
        assert np.abs(pose[:3, 3]).max() < 0.1 and np.abs(pose - result.transformation).max() > 0.9


def test_features_are_compared_with_the_best_distinct_pose(device, rng):
    points = rng.uniform(-1, 1, (60, 3)).astype(np.float32)
    shifts = np.repeat([0.0, 1.0, 3.0], (40, 16, 4))  # [m]
    clouds = [loom.PointCloud(points + np.outer(k * shifts, [1, 0, 0]), device=device) for k in (0, 1)]
    surfaces = [Surface(cloud.arrays["points"], cloud.arrays["points"]) for cloud in clouds]
    middles = [cloud.origin for cloud in clouds]
    pairs = upload(np.column_stack([np.arange(60)] * 2), int32, surfaces[0].device)
    same, near, far = np.eye(4), np.eye(4), np.eye(4)
    near[0, 3], far[0, 3] = 0.05, 1.0  # the first is no distinct pose
    same, near, far = (to_local(T, *middles) for T in (same, near, far))
    selection = PoseSelection(*(Witness(surface, 0.1) for surface in surfaces), 0.1, refine=True, free=None)
    ratios = [selection.compare_features(pairs, T, np.array([same, near, far])) for T in (same, far)]
    assert ratios == [40 / 16, 16 / 40]
    alone = selection.compare_features(pairs, same, np.array([near]))  # no rival
    assert alone == 40 / CHANCE_FEATURES


def test_a_pose_that_left_the_searched_one_loses_its_features(device, rng):
    cloud = loom.PointCloud(rng.uniform(-1, 1, (100, 3)), device=device)
    searched = loom.registration.RegistrationResult(
        np.eye(4), 1.0, 0.0, np.empty((0, 2), np.int32), clouds=Registered(cloud, cloud, 0.1, feature_ratio=3.0)
    )
    moved = np.eye(4)
    moved[0, 3] = 0.25
    assert [_feature_ratio(searched, T, 0.1) for T in (np.eye(4), moved)] == [3.0, 0.0]
    assert _feature_ratio(None, np.eye(4), 0.1) == 0.0
    assert searched.assessment.evidence.feature_ratio == 3.0

"""`reliable` of refined poses: wrong poses, open motions and collapsed scales are rejected, correct poses are not."""

import copy
import pickle

import numpy as np
import pytest

import pointloom as loom
from pointloom.registration import result as result_module
from pointloom.registration.unobservable_motions import describe_motions

from .icp_clouds import KINDS, PLANE, wavy
from .poses import as_pose
from .test_icp import degenerate

reg = loom.registration
AWAY = as_pose([0.6, -0.8, 0.7], [0.3, 0.1, 0])
RULES = reg.ICPConvergenceCriteria(1e-3, 1e-4, 200)
NDT = reg.NormalDistributionsTransformOption(voxel_size=0.3, max_iteration=200)


def icp(**options):
    return lambda source, target, start: reg.registration_icp(source, target, 0.3, start, PLANE, RULES, **options)


def batch(source, target, start):
    return reg.registration_icp_batch(source, target, 0.3, np.array([start, start]), PLANE, RULES)[1]


METHODS = {
    name: lambda source, target, start, method=method: reg.registration_icp(source, target, 0.3, start, method, RULES)
    for name, method in KINDS.items()
    if name != "doppler"  # needs velocities
} | {
    "trimmed": icp(overlap=0.7),
    "estimated overlap": icp(overlap=None),
    "normals": icp(max_normal_angle=0.8),
    "batch": batch,
    "two scales": lambda s, t, start: reg.multi_scale_icp(s, t, [0.1, -1], [RULES, RULES], [0.4, 0.3], start, PLANE),
    "NDT": lambda source, target, start: reg.registration_ndt(source, target, NDT, start),
    "evaluation": lambda source, target, start: reg.evaluate_registration(source, target, 0.3, start),
}
CONSTRAINED = {
    "level": icp(constraint=reg.Constraint(("x", "y", "z", "yaw"))),
    "prior": icp(constraint=reg.Constraint(prior=reg.Prior(np.eye(4), sigma_translation=0.1, sigma_rotation=0.1))),
}


def torus(rng, count):
    """A torus with a waist of another radius along y."""
    a, b = rng.uniform(0, 2 * np.pi, (2, count))
    r = 1 + 0.3 * np.cos(b)
    return np.column_stack([r * np.cos(a), 1.2 * r * np.sin(a), 0.3 * np.sin(b)])


def box(rng, count, size=(2.0, 1.0, 0.5)):
    points, axes = rng.uniform(-0.5, 0.5, (count, 3)), rng.integers(0, 3, count)
    points[np.arange(count), axes] = rng.choice([-0.5, 0.5], count)
    return points * size


def corner(rng, count):
    """Three planes, which any corner of a room has."""
    points = rng.uniform(0, 2, (count, 3))
    points[np.arange(count), np.arange(count) % 3] = 0
    return points


def terrain(rng, count):
    return 1.5 * wavy(rng, count)


def cloud_of(points, device, rng=None):
    noise = 0.0 if rng is None else 0.002 * rng.normal(size=points.shape)
    colors = (points - points.min(0)) / np.maximum(np.ptp(points, axis=0), 1e-9)
    return loom.PointCloud(points + noise, colors=colors, device=device).estimate_normals(max_nn=20)


@pytest.mark.parametrize("name", [*METHODS, *CONSTRAINED])
def test_clouds_that_share_nothing_have_no_reliable_pose(device, rng, name):
    target = cloud_of(box(rng, 3000, (2, 1, 3)), device)
    for shape in (torus, terrain):
        result = (METHODS | CONSTRAINED)[name](cloud_of(shape(rng, 3000), device), target, np.eye(4))
        assert not result.reliable and result.to_dict()["warnings"] == [*result.warnings]
        assert result.converged or name in ("evaluation", "NDT", "normals"), result


def scattered(rng, count, device, noise=0.0):
    """Targets, tree stems or landmarks, without surfaces, and the same with noise at another pose."""
    points = rng.uniform(0, 1, (count, 3)) * [3, 3, 0.4]
    T = as_pose([0.01, -0.01, 0.02], [0.004, -0.006, 0.003])
    noisy = points @ T[:3, :3].T + T[:3, 3] + noise * rng.normal(size=points.shape)
    return loom.PointCloud(points, device=device), loom.PointCloud(noisy, device=device), T


@pytest.mark.parametrize("name", [name for name in [*METHODS, *CONSTRAINED] if name != "NDT"])
@pytest.mark.parametrize("count", [1, 3, 6, 12, 29, 60, 100])
def test_few_unrelated_points_have_no_reliable_pose(device, rng, name, count):
    for flat in (1, 0.4, 0.05):
        source, target = (cloud_of(rng.uniform(0, 3, (count, 3)) * [1, 1, flat], device) for _ in range(2))
        result = (METHODS | CONSTRAINED)[name](source, target, np.eye(4))
        assert not result.reliable, (flat, result)


@pytest.mark.parametrize("count", [2, 3, 5, 10])
def test_many_points_onto_few_are_not_reliable(device, rng, count):
    source = loom.PointCloud(box(rng, 2000), device=device)
    few = source.select_by_index(np.arange(count))
    rules = {"max_correspondence_distance": 0.5, "criteria": RULES}
    for pair in ((source, few), (few, source)):
        for result in (
            reg.registration_icp(*pair, init=AWAY, **rules),
            reg.registration_icp_batch(*pair, inits=AWAY, **rules)[0],
        ):
            assert not result.reliable or np.allclose(result.transformation, np.eye(4), atol=1e-6)


@pytest.mark.parametrize("count", [4, 6, 12, 20, 29])
def test_few_targets_that_match_accurately_are_reliable(device, rng, count):
    """The noise is a thousandth of the width, as of survey targets. Four targets must be more accurate."""
    for _ in range(4):
        source, target, T = scattered(rng, count, device, noise=0.0005 if count == 4 else 0.003)
        scaled = reg.TransformationEstimationPointToPoint(with_scaling=True)
        for method in (None, scaled):
            result = reg.registration_icp(source, target, 0.5, np.eye(4), method, RULES)
            assert np.abs(result.transformation - T).max() < 0.05 and result.warnings == ()


@pytest.mark.parametrize("count", [50, 100])
def test_accurate_targets_on_a_wall_are_reliable(device, rng, count):
    """Their surfaces may slide, but the points may not. A regular grid that is off by half of its spacing may."""
    points = np.c_[rng.uniform(0, 3, (count, 2)), np.zeros(count)]
    source, target = (
        loom.PointCloud(p, device=device) for p in (points, points + 0.004 * rng.normal(size=points.shape))
    )
    assert reg.registration_icp(source, target, 0.5, criteria=RULES).warnings == ()
    grid = np.c_[np.stack(np.meshgrid(range(10), range(count // 10)), -1).reshape(-1, 2), np.zeros(count)]
    off = [loom.PointCloud(p, device=device) for p in (grid, np.add(grid, [0.4, 0.3, 0]))]
    assert not reg.evaluate_registration(*off, 1.0).reliable


def test_the_noise_decides_whether_few_targets_match_by_chance(device, rng):
    for noise, is_reliable in ((0.001, True), (0.15, False)):
        source, target, _ = scattered(rng, 6, device, noise)
        result = reg.registration_icp(source, target, 1.0, criteria=RULES)
        assert result.reliable == is_reliable
        assert is_reliable or "too few points to decide" in result.warnings[0]


def test_repeated_points_are_no_more_evidence(device, rng):
    """200 points in each of 4 places that do not match accurately."""
    places = rng.uniform(0, 3, (2, 4, 3))
    clouds = [loom.PointCloud(np.repeat(p, 200, 0) + 1e-3 * rng.normal(size=(800, 3)), device=device) for p in places]
    assert not reg.registration_icp(*clouds, 3.0, criteria=RULES).reliable


def test_a_common_outlier_is_no_evidence(device, rng):
    source, target = (rng.uniform(0, 3, (20, 3)) for _ in range(2))
    for far in (30, 3000):
        clouds = [loom.PointCloud(np.vstack([p, [[far, 0, 0]]]), device=device) for p in (source, target)]
        assert not reg.registration_icp(*clouds, 1.0, criteria=RULES).reliable


def test_clouds_that_cannot_be_compared_are_reported(device, rng):
    points = np.vstack([box(rng, 2000), [[1e15, 0, 0]]])
    result = reg.evaluate_registration(
        loom.PointCloud(points, device=device), loom.PointCloud(points, device=device), 1
    )
    assert "the clouds could not be compared" in result.warnings[0]


@pytest.mark.parametrize("name", [*METHODS, *CONSTRAINED])
def test_correct_poses_stay_reliable(device, rng, name):
    """Also on three planes, which a search without a start must reject."""
    start = as_pose([0.01, -0.01, 0.02], [0.03, 0.02, -0.02]) if name != "evaluation" else np.eye(4)
    for shape in (terrain, corner):
        source, target = (cloud_of(shape(rng, 4000), device, rng) for _ in range(2))
        result = (METHODS | CONSTRAINED)[name](source, target, start)
        assert np.abs(result.transformation - np.eye(4)).max() < 0.06 and result.warnings == ()


@pytest.mark.parametrize("name", [name for name in METHODS if name != "colored"])
@pytest.mark.parametrize("shape", ["corridor", "wall"])
def test_undetermined_motions_are_named(device, rng, name, shape):
    if shape == "wall":
        clouds = [cloud_of(rng.uniform(-2, 2, (3000, 3)) * [1, 1, 0], device, rng) for _ in range(2)]
    else:
        clouds = [cloud_of(degenerate("corridor", rng, 4000)[0], device, rng) for _ in range(2)]
    result = METHODS[name](*clouds, as_pose([0, 0, 0], [0.1, 0.1, 0.01]))
    assert not result.reliable
    if len(result.degenerate_directions) or result.converged:
        assert "the source may slide" in result.warnings[-1]


@pytest.mark.parametrize("name", ["free", "prior"])
def test_a_motion_that_is_fixed_or_has_a_prior_is_no_warning(device, rng, name):
    clouds = [cloud_of(degenerate("corridor", rng, 4000)[0], device, rng) for _ in range(2)]
    options = {
        "free": {"free": ("x", "z", "roll", "pitch", "yaw")},
        "prior": {"prior": reg.Prior(np.eye(4), sigma_translation=0.05, sigma_rotation=0.05)},
    }
    result = icp(constraint=reg.Constraint(**options[name]))(*clouds, as_pose([0, 0, 0.01], [0.02, 0, 0.01]))
    assert result.converged and result.warnings == ()


def test_colors_and_copies_determine_motions_along_surfaces(device, rng):
    """A flat pattern by its colors, and a copy of a sphere by its points."""
    flat = []
    for _ in range(2):
        points = rng.uniform(-1, 1, (6000, 3)) * [1, 1, 0]
        colors = np.sin(points @ [[9, 2, 3], [4, 8, 7], [0, 0, 0]]) / 2 + 0.5
        flat.append(loom.PointCloud(points, colors=colors, device=device).estimate_normals(max_nn=20))
    result = METHODS["colored"](*flat, as_pose([0, 0, 0.01], [0.02, 0.02, 0.01]))
    assert np.abs(result.transformation - np.eye(4)).max() < 0.01 and result.warnings == ()
    ball = rng.normal(size=(3000, 3))
    sphere = cloud_of(ball / np.linalg.norm(ball, axis=1)[:, None], device)
    result = METHODS["point"](sphere, sphere, as_pose([0.01, 0.01, 0.01], [0.002, 0, 0]))
    assert np.abs(result.transformation - np.eye(4)).max() < 1e-6 and result.warnings == ()


def test_a_pair_from_a_given_start_names_motions_that_gentle_slopes_do_not_determine(device, rng):
    x, y = rng.uniform(-3, 3, (2, 20000))
    points = np.column_stack([x, y, 0.05 * np.sin(2 * x + 0.3) * np.cos(1.7 * y)])
    source, target = (loom.PointCloud(p, device=device) for p in (points[:12000], points[8000:]))
    pair = reg.register_pair(source, target, init=as_pose([0, 0, 0], [0.15, 0.15, 0]))
    assert pair.score > 0.5 and not pair.reliable and "may slide" in pair.warnings[0]


@pytest.mark.parametrize("match", [1.0, 3.0])
def test_a_source_that_shrinks_into_a_corner_is_not_reliable(device, match):
    method, collapsed = reg.TransformationEstimationPointToPoint(with_scaling=True), 0
    for seed in range(8):
        rng = np.random.default_rng(seed)
        source, target = (loom.PointCloud(box(rng, count), device=device) for count in (1500, 2500))
        way = rng.normal(size=3)
        target = target.translate(way * rng.uniform(1.0, 2.5) / np.linalg.norm(way))
        result = reg.registration_icp(source, target, match, None, method, RULES)
        scale = np.cbrt(np.linalg.det(result.transformation[:3, :3]))
        assert 0.7 < scale < 1.4 or not result.reliable
        collapsed += result.converged and scale < 0.7 and result.fitness > 0.95
    assert collapsed


def test_a_low_fitness_is_a_warning(device, rng):
    points = terrain(rng, 6000)
    part = points[points[:, 0] > 1.4]
    away = np.concatenate([part, np.add(points, [0, 0, 50])])
    result = reg.registration_icp(cloud_of(away, device), cloud_of(points, device), 0.1, None, PLANE, RULES)
    assert 0 < result.fitness < 0.1 and "has a correspondence, less than 10%" in result.warnings[0]


def test_the_surfaces_are_compared_once_on_access(device, rng, monkeypatch):
    calls = []
    find = result_module.find_problem
    monkeypatch.setattr(
        result_module, "find_problem", lambda *given, **options: calls.append(1) or find(*given, **options)
    )
    source, target = (cloud_of(shape(rng, 2000), device) for shape in (torus, terrain))
    result = icp()(source, target, np.eye(4))
    assert result.converged and repr(result) and not calls
    lazy = copy.copy(result)
    assert not calls
    assert not result.reliable and not result.reliable and len(calls) == 1
    result.transformation[:3, 3] += 1e3  # for instance into another frame: the warnings are those of the registration
    for again in (lazy, pickle.loads(pickle.dumps(result)), copy.deepcopy(result)):
        assert again.warnings == result.warnings
    assert len(pickle.dumps(result)) < result.correspondence_set.nbytes + 4000  # without clouds


@pytest.mark.parametrize(
    ("motions", "words"),
    [
        ([[0, 0, 0, 1, 0, 0]], "slide along x"),
        ([[0, 0, 0, 1, 0, 0], [0, 0, 0, 0, 1, 0]], "slide along any direction perpendicular to z"),
        ([[0, 0, 1, 0, 0, 0], [0, 0, 0, 0.8, 0.6, 0]], "slide along (0.80, 0.60, 0.00) and rotate about z"),
        (np.eye(6), "slide along any direction and rotate about any direction"),
        ([[0, 0, 0.7, 0, 0, 0.7]], "slide and rotate together"),
    ],
)
def test_motions_in_words(motions, words):
    assert describe_motions(np.array(motions, float)) == words

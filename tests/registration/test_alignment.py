"""Assessments measure displacements with their uncertainty, report undetermined motions, and agree with each other."""

import numpy as np
import pytest
from scipy.linalg import subspace_angles

import pointloom as loom

from ..products import few_quick
from .poses import as_pose
from .test_icp import FREE, degenerate

reg = loom.registration
assess = reg.assess_registration
UTM = np.array([455_000.25, 5_420_000.5, 312.0])
NOISE = 0.004


def room(rng, count=12_000):
    """Points of a floor, two walls, a box and a pillar, with noise [m]."""
    u, v = rng.random((2, count))
    side = np.arange(count) % 6
    angle = 2 * np.pi * u
    faces = [
        np.column_stack([4 * u, 3 * v, 0 * u]),
        np.column_stack([4 * u, 0 * u, 2.5 * v]),
        np.column_stack([0 * u, 3 * u, 2.5 * v]),
        np.column_stack([2 + 0.8 * u, 0.5 + 0.6 * v, 0.7 + 0 * u]),
        np.column_stack([2 + 0.8 * u, 1.1 + 0 * u, 0.7 * v]),
        np.column_stack([3.2 + 0.25 * np.cos(angle), 2.2 + 0.25 * np.sin(angle), 1.6 * v]),
    ]
    return np.choose(side[:, None], faces) + NOISE * rng.normal(size=(count, 3))


def pair(rng, device="cpu", corner=(0.0, 0.0, 0.0)):
    return [loom.PointCloud(room(rng) + corner, device=device) for _ in range(2)]


def flat_pair(rng, device="cpu"):
    points = (np.column_stack([*rng.uniform(-1, 1, (2, 8000)), NOISE * rng.normal(size=8000)]) for _ in range(2))
    return [loom.PointCloud(plane, device=device) for plane in points]


def about(corner, pose):
    return as_pose([0, 0, 0], corner) @ pose @ as_pose([0, 0, 0], -np.asarray(corner))


@few_quick(1, "corner", [np.zeros(3), UTM], ids=["zero", "UTM"])
def test_a_displacement_is_measured_and_its_correction_undoes_it(device, corner, rng):
    source, target = pair(rng, device, corner)
    for rotation, translation in (([0, 0, 0], [0.03, 0, 0.04]), ([0, 0.01, 0.02], [0, 0.02, 0])):
        wrong = about(corner, as_pose(rotation, translation))
        check = assess(source, target, wrong, 0.15).alignment
        moved = np.linalg.norm((source.transform(wrong).points - source.points), axis=1)
        assert check.displacement == pytest.approx(np.sqrt((moved**2).mean()), rel=0.15)
        assert not check.aligned and not check.reliable and "off by" in check.warnings[0]
        again = assess(source, target, check.correction @ wrong, 0.15).alignment
        assert again.aligned and again.displacement < 0.15 * check.displacement


@pytest.mark.slow
def test_the_covariance_covers_the_errors_of_samplings(rng):
    """At the true pose the distance has about the distribution of six deviations, and it grows with a displacement."""
    distances = [assess(*pair(rng), np.eye(4), 0.15).alignment.distance for _ in range(12)]
    assert np.mean(np.array(distances) <= 3.55) >= 0.9 and np.median(distances) > 0.3
    source, target = pair(rng)
    by_shift = [assess(source, target, as_pose([0, 0, 0], [d, 0, 0]), 0.15).alignment for d in (0, 0.01, 0.02, 0.04)]
    assert (np.diff([check.distance for check in by_shift[1:]]) > 0).all()
    assert not any(check.aligned for check in by_shift[2:])
    sigmas = [check.sigma for check in by_shift]
    assert max(sigmas) < 2 * min(sigmas)


def test_a_motion_that_planes_do_not_determine_has_a_large_variance(device, rng):
    clouds = flat_pair(rng, device)
    deviations = assess(*clouds, np.eye(4), 0.1).covariance.sigmas
    assert deviations[[2, 3, 4]].min() > 30 * deviations[[0, 1, 5]].max()
    check = assess(*clouds, as_pose([0, 0, 0], [0, 0, 0.03]), 0.1).alignment
    assert check.distance > 3.55 and check.correction[2, 3] == pytest.approx(-0.03, abs=0.003)


def test_clouds_without_a_common_surface_are_not_aligned(rng):
    source, target = pair(rng)
    far = assess(source, target, as_pose([0, 0, 0], [50, 0, 0]), 0.15).alignment
    assert not far.aligned and far.matches == 0 and np.isinf(far.sigma) and far.to_dict()["sigma"] is None
    for translation in ([0, 0, 0.5], [0.4, 0.4, 0]):
        assert not assess(source, target, as_pose([0, 0, 0], translation), 0.15).alignment.aligned
    assert not assess(loom.PointCloud(), target, np.eye(4), 0.15).alignment.aligned


@pytest.mark.slow
def test_the_default_distance_is_chosen_from_the_clouds(rng):
    source, target = pair(rng)
    assert assess(source, target, np.eye(4)).alignment.aligned
    assert not assess(source, target, as_pose([0, 0, 0], [0.05, 0.05, 0.05])).alignment.aligned


@pytest.mark.slow
def test_the_result_is_the_same_on_each_run_and_either_way(device, rng):
    source, target = pair(rng, device)
    wrong = as_pose([0.005, 0, 0], [0.02, 0.01, 0])
    found = [assess(source, target, wrong, 0.15) for _ in range(2)]
    assert found[0].to_dict() == found[1].to_dict()
    back = assess(target, source, np.linalg.inv(wrong), 0.15).alignment
    assert back.displacement == pytest.approx(found[0].alignment.displacement, rel=0.1)


def scans(shape, rng, *, noise=0.0, corner=(0.0, 0.0, 0.0), device="cpu", change=None):
    clouds = []
    for _ in range(2):
        points = degenerate(shape, rng, 12_000)[0]
        if change is not None:
            points = change(points)
        clouds.append(loom.PointCloud(points + noise * rng.normal(size=points.shape) + corner, device=device))
    return clouds


@pytest.mark.parametrize("shape", list(FREE))
def test_free_motions_match_the_shape_at_any_noise(device, shape, rng):
    for noise in (0.0, 0.02):
        result = assess(*scans(shape, rng, noise=noise, corner=UTM, device=device), np.eye(4), 0.25).localizability
        assert len(result.open_motions) == len(FREE[shape]), (noise, str(result))
        assert (result.reliable) == (not len(FREE[shape]))
        if len(FREE[shape]):
            assert np.degrees(subspace_angles(result.open_motions.T, FREE[shape].T)).max() < 6
        np.testing.assert_allclose(result.motions @ result.motions.T, np.eye(6), atol=1e-9)
        assert np.abs(result.middle - UTM).max() < 0.5


def test_a_corridor_constrained_by_its_end_is_partially_localizable(rng):
    def with_end(points):
        points = points.copy()
        points[::60] = np.column_stack([rng.uniform(-0.5, 0.5, 200), np.full(200, 3.0), rng.uniform(-0.5, 0.5, 200)])
        return points

    result = assess(*scans("corridor", rng, noise=0.005, change=with_end), np.eye(4), 0.25).localizability
    assert result.kinds == ("partial", *("full",) * 5) and result.reliable
    assert abs(result.motions[0, 4]) > 0.99


def test_a_prior_constrains_only_free_motions(rng):
    """Along the corridor the source follows odometry, across it the walls."""
    truth = as_pose([0.0, 0.0, 0.01], [0.02, 0.15, 0.0])
    source, target = scans("corridor", rng, noise=0.005)
    source = source.transform(np.linalg.inv(truth)).estimate_normals(max_nn=20)
    target = target.estimate_normals(max_nn=20)
    first = reg.registration_icp(source, target, 0.25, None, reg.TransformationEstimationPointToPlane())
    actual = assess(source, target, first.transformation, 0.25).localizability
    assert actual.translations == pytest.approx(np.array([[0.0, 1.0, 0.0]]), abs=0.02)
    odometry = as_pose([0.0, 0.0, 0.03], [0.1, 0.15, 0.05])  # correct along the corridor, wrong across it
    result = reg.registration_icp(
        source, target, 0.25, first.transformation, reg.TransformationEstimationPointToPlane(),
        constraint=reg.Constraint(prior=reg.Prior(odometry, information=actual.information(0.01)), pivot=actual.middle),
        degeneracy=0,
    )  # fmt: skip
    off = np.abs(result.transformation - truth)
    assert off[1, 3] < 0.02 and off[[0, 2], 3].max() < 0.01 and off[:3, :3].max() < 0.005
    assert abs(first.transformation[1, 3] - 0.15) > 0.1
    surface = assess(*scans("surface", rng), np.eye(4), 0.2).localizability
    with pytest.raises(ValueError, match=r"^information:"):
        surface.information(0.1)


def test_disjoint_clouds_constrain_nothing():
    cube = loom.PointCloud(np.random.default_rng(0).uniform(size=(3000, 3)))
    far = assess(cube, cube.translate([50, 0, 0]), np.eye(4), 0.1).localizability
    assert far.kinds == ("none",) * 6 and "no surface" in str(far.warnings)
    empty = assess(loom.PointCloud(), cube, np.eye(4), 0.1).localizability
    assert empty.kinds == ("none",) * 6

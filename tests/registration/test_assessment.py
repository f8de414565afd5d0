"""One assessment of a pose: its parts agree, its surfaces are computed once, and results compute it on access."""

import json
import pickle
import threading
import typing

import numpy as np
import pytest

import pointloom as loom
from pointloom.registration import assessment_constants as constants
from pointloom.registration.globally import rating

from ..products import few_quick
from .icp_clouds import PLANE
from .poses import as_pose
from .test_alignment import UTM, about, assess, pair
from .test_rating import hills

reg = loom.registration


def street(rng):
    """Ground, fronts and roofs of 30 m along x, two equal porches 3.3 m apart, and the side of a house."""
    faces = [
        ((0, -6, 0), (30, 0, 0), (0, 12, 0)),
        *(((0, y, 0), (30, 0, 0), (0, 0, 6)) for y in (-6, 6)),
        *(((0, y, 6), (30, 0, 0), (0, y / 3, 2)) for y in (-6, 6)),
        *(((x, -6, 0), (0, 1.8, 0), (0, 0, 3)) for x in (10, 13.3)),
        ((24, 6, 0), (0, -4, 0), (0, 0, 6)),
    ]
    parts = []
    for corner, a, b in np.array(faces, float):
        u, v = rng.random((2, int(20 * np.linalg.norm(np.cross(a, b))), 1))
        parts.append(corner + u * a + v * b)
    points = np.concatenate(parts)
    return points + rng.normal(0, 0.01, points.shape)


@few_quick(1, "slide", [3.3, -3.3])
def test_a_pose_that_slid_along_a_street_is_not_reliable(device, rng, slide):
    """Its score and displacement are accepted: the surfaces match, and along the street none is measured."""
    source, target = (loom.PointCloud(street(rng), device=device) for _ in range(2))
    assert assess(source, target, np.eye(4), 0.6).reliable
    slid = assess(source, target, as_pose([0, 0, 0], [slide, 0, 0]), 0.6)
    assert slid.score > 0.5 and slid.alignment.aligned and slid.alignment.sigma < 0.03
    assert not slid.reliable and slid.localizability.translations == pytest.approx(np.array([[1, 0, 0]]), abs=0.02)
    assert slid.covariance.sigmas[3] > 3.3 > 0.1 > slid.covariance.sigmas[4:].max()
    (warning,) = slid.warnings
    assert "the source may slide along x" in warning and "add a prior" in warning


def test_each_failed_check_has_a_warning_with_a_remedy(rng):
    source, target = pair(rng)
    assert assess(source, target, np.eye(4), 0.15).warnings == ()
    displaced = assess(source, target, as_pose([0, 0, 0], [0.03, 0, 0.04]), 0.15)
    assert [("off by" in text, "registration_icp" in text) for text in displaced.warnings] == [(True, True)]
    far = assess(source, target, as_pose([0, 0, 0], [50, 0, 0]), 0.15)
    assert far.fitness == far.inlier_rmse == far.score == 0 and not far.reliable and len(far.warnings) == 3
    for text, start in zip(
        far.warnings, ("the score is 0.00", "the surfaces do not match", "the clouds share no"), strict=True
    ):
        assert text.startswith(start) and "register_globally" in text
    bare = assess(loom.PointCloud(), target, np.eye(4), 0.15)
    assert not bare.reliable and bare.localizability.kinds == ("none",) * 6 and np.isinf(bare.covariance.sigmas).all()


def test_a_small_displacement_is_a_note(device, rng):
    """Below a tenth of a voxel it is the error of a registration, not a wrong pose."""
    source, target = (loom.PointCloud(hills(rng, 20000), device=device) for _ in range(2))
    small = assess(source, target, as_pose([0, 0, 0], [0, 0, 0.008]), 0.15)
    assert not small.alignment.aligned and small.reliable and "off by" in small.notes[0]
    large = assess(source, target, as_pose([0, 0, 0], [0, 0, 0.02]), 0.15)
    assert not large.reliable and large.notes == ()


def test_fitness_and_rmse_are_those_of_the_evaluation(device, rng):
    source, target = pair(rng, device)
    found, expected = assess(source, target, np.eye(4), 0.1), reg.evaluate_registration(source, target, 0.1)
    assert (found.fitness, found.inlier_rmse) == (expected.fitness, expected.inlier_rmse)
    assert found.max_correspondence_distance == 0.1 and (found.transformation == np.eye(4)).all()


def test_surfaces_are_computed_once(device, rng, monkeypatch):
    calls, thin = [], loom.PointCloud.average_voxels
    monkeypatch.setattr(
        loom.PointCloud, "average_voxels", lambda self, *given: calls.append(given[0]) or thin(self, *given)
    )
    assess(*pair(rng, device), np.eye(4), 0.15)
    assert sorted(calls) == pytest.approx([0.04, 0.05, 0.08, 0.1])


def test_a_scaled_source_is_assessed(device, rng):
    points, other = hills(rng, 20000), hills(rng, 20000)
    source, target = loom.PointCloud(points / 2, device=device), loom.PointCloud(other, device=device)
    found = assess(source, target, np.diag([2.0, 2, 2, 1]), 0.1)
    assert found.reliable and found.covariance.sigmas.max() < 0.01
    assert not assess(source, target, np.eye(4), 0.1).reliable


def test_points_that_are_not_finite_are_ignored(device, rng):
    points, other, bad = hills(rng, 12000), hills(rng, 12000), np.full((40, 3), np.nan)
    bad[::2] = [np.inf, 0, 0]
    target = loom.PointCloud(other, device=device)
    plain, found = (
        assess(loom.PointCloud(p, device=device), target, np.eye(4), 0.15) for p in (points, np.r_[points, bad])
    )
    assert found.to_dict() == plain.to_dict()
    with pytest.raises(ValueError, match=r"^source: expected finite points"):
        assess(loom.PointCloud(bad, device=device), target, np.eye(4))


def test_the_report_has_the_parts_in_json_and_in_text(rng):
    source, target = pair(rng)
    found = assess(source, target, as_pose([0, 0, 0], [0.5, 0, 0]), 0.15)
    report = json.loads(json.dumps(found.to_dict(), allow_nan=False))
    assert report["reliable"] is found.reliable is False and report["warnings"] == [*found.warnings]
    assert report["score"] == found.score and np.shape(report["covariance"]["matrix"]) == (6, 6)
    assert [*report["features"]] == ["agreement", "number", "beside_planes", "details", "free_space"]
    assert report["alignment"]["displacement"] == found.alignment.displacement
    assert "score" in str(found) and found.warnings[0] in str(found) and "<td>" in found._repr_html_()


@pytest.mark.slow
@pytest.mark.parametrize("corner", [np.zeros(3), UTM], ids=["zero", "UTM"])
def test_results_hold_it_and_compute_it_once(device, rng, corner, monkeypatch):
    calls, compute = [], reg.assess_registration
    monkeypatch.setattr(reg, "assess_registration", lambda *given: calls.append(1) or compute(*given), raising=False)
    source, target = (cloud.estimate_normals(max_nn=20) for cloud in pair(rng, device, corner))
    result = reg.registration_icp(source, target, 0.15, about(corner, as_pose([0, 0, 0], [0.01, 0, 0])), PLANE)
    assert result.to_dict() and not calls and "assessment" not in result.to_dict()
    found = []
    threads = [threading.Thread(target=lambda: found.append(result.assessment)) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(calls) == 1 and all(one is found[0] for one in found) and found[0].reliable
    expected = compute(source, target, result.transformation, 0.15)
    assert found[0].to_dict() == expected.to_dict() and (result.covariance.matrix == expected.covariance.matrix).all()
    copied = pickle.loads(pickle.dumps(result))
    with pytest.raises(
        ValueError, match=r"^assessment: expected a result with its clouds, .* Call assess_registration"
    ):
        _ = copied.assessment


def test_results_of_searches_hold_it_too(rng):
    source, target = (loom.PointCloud(hills(rng, 12000)) for _ in range(2))
    result = reg.register_globally(source, target, voxel_size=0.1)
    assert result.assessment.score > 0.5 and result.assessment.max_correspondence_distance == pytest.approx(0.15)
    found = reg.register_pair(source, target, init=np.eye(4), voxel_size=0.1)
    assert found.assessment.reliable and found.assessment.score == found.score
    with pytest.raises(ValueError, match=r"^assessment: "):
        _ = pickle.loads(pickle.dumps(found)).assessment
    with pytest.raises(ValueError, match=r"^assessment: "):
        _ = reg.register_globally(loom.PointCloud(), target, voxel_size=0.1).assessment


def test_the_score_alone_equals_that_of_the_assessment(device, rng):
    source, target = (loom.PointCloud(hills(rng, 12000), device=device) for _ in range(2))
    T = as_pose([0, 0, 0.01], [0.02, 0, 0.02])
    assert rating.score_registration(source, target, 0.1, T) == assess(source, target, T, 0.1).score


def test_every_constant_has_a_quantity_and_a_source():
    hints = typing.get_type_hints(constants, include_extras=True)
    names = {name for name, value in vars(constants).items() if isinstance(value, int | float)}
    assert names == set(hints) and all(
        about.__metadata__[0].quantity and about.__metadata__[0].source for about in hints.values()
    )
    assert all(isinstance(getattr(constants, name), about.__origin__) for name, about in hints.items())

"""Units of length: names, text and warnings, and lengths in another unit that leave no points."""

import copy
import pickle
import warnings

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.units import (
    DEGREE,
    FOOT,
    KNOWN,
    METRE,
    US_FOOT,
    LengthUnit,
    common_unit,
    symbol_of,
    text_of,
    unit_by_length,
    unit_by_name,
    unit_of_text,
)

LINK = LengthUnit("Gunter's link", "li", 0.201168)


@pytest.mark.parametrize(
    ("name", "unit"),
    [
        ("metre", METRE), ("Meter", METRE), ("m", METRE), ("foot", FOOT), ("FEET", FOOT), ("ft", FOOT),
        ("US survey foot", US_FOOT), ("Foot_US", US_FOOT), ("foot_survey_us", US_FOOT), ("US ft", US_FOOT),
        ("us-ft", US_FOOT), ("International Foot", FOOT), ("deg", DEGREE), ("furlong", None), ("", None),
    ],
)  # fmt: skip
def test_units_go_by_the_names_that_are_in_use(name, unit):
    assert unit_by_name(name) is unit


@pytest.mark.parametrize(
    ("name", "meters", "unit"),
    [
        ("metre", 1.0, METRE),
        ("foot", 0.3048, FOOT),
        ("foot", 0.30480060960121924, US_FOOT),  # many files call the survey foot so; its length is what counts
        ("US survey foot", 0.304801, US_FOOT),  # of few digits
        ("whatever", 0.3048, FOOT),
        ("metre", 0.3048, None),  # the two contradict each other
        ("foot", 1.0, None),
        ("degree", 0.0174532925199433, None),
        ("metre", float("nan"), None),
        ("metre", 0.0, None),
    ],
)
def test_a_unit_is_defined_by_its_length_unless_its_name_differs(name, meters, unit):
    assert unit_by_length(name, meters) is unit


def test_an_unknown_name_with_a_length_is_a_unit_of_its_own():
    unit = unit_by_length("Clarke's link", 0.201166195164)
    assert (unit.name, unit.symbol, unit.meters) == ("Clarke's link", "Clarke's link", 0.201166195164)
    assert unit_by_length("pied\u00e9", 0.3249).name == "unit of 0.3249 m"  # not representable in an ASCII header


@pytest.mark.parametrize(
    ("unit", "words"),
    [(METRE, "metre"), (FOOT, "foot (0.3048 m)"), (DEGREE, "degree, of longitude and latitude")],
    ids=["metre", "foot", "degree"],
)
def test_a_unit_is_described_by_its_length_and_reported_by_its_name(unit, words):
    assert (unit.in_words(), unit.json_value) == (words, words.split(" ")[0].rstrip(","))


@pytest.mark.parametrize("unit", [*KNOWN, LINK], ids=str)
def test_a_unit_survives_text_pickles_and_copies(unit):
    for back in (unit_of_text(text_of(unit)), pickle.loads(pickle.dumps(unit)), copy.deepcopy(unit)):
        assert back == unit and hash(back) == hash(unit) and back.meters == unit.meters
    assert unit == unit.name and unit != "ell" and unit != 3


@pytest.mark.parametrize("text", ["feet", "mm", "metre = 0.3048 m", "x = 1 ft", "x = m", "x = nan m", "of a scan", ""])
def test_other_text_is_no_unit(text):
    assert unit_of_text(text) is None


def test_one_unit_is_common_and_two_are_a_warning_at_the_users_line():
    with warnings.catch_warnings(action="error"):
        assert common_unit("clouds", [None, FOOT, None, FOOT]) is FOOT
        assert common_unit("clouds", [None, None]) is None
    with pytest.warns(loom.UnitWarning, match=r"^clouds:.*to_unit") as caught:
        assert common_unit("clouds", [METRE, None, FOOT]) is None
    assert caught[0].filename == __file__
    with pytest.warns(loom.UnitWarning, match="project_to_utm"):
        common_unit("clouds", [METRE, DEGREE])
    with pytest.warns(loom.UnitWarning, match=r"^clouds:"):  # 2e-6 apart: 1.3 m at a state plane's 2,000,000 ft
        common_unit("clouds", [US_FOOT, FOOT])


def test_lengths_in_unknown_units_are_reported_in_meters():
    assert [symbol_of(unit) for unit in (None, METRE, US_FOOT, LINK)] == ["m", "m", "US ft", "li"]


@pytest.fixture
def ball(rng, device):
    points = rng.normal(size=(800, 3))
    points /= np.linalg.norm(points, axis=1, keepdims=True)
    return loom.PointCloud(points, normals=points, device=device)


def test_a_radius_without_neighbors_warns(ball):
    copies = loom.PointCloud(np.repeat(ball.points, 3, axis=0), device=ball.device)
    for cloud in (ball, copies):  # copies of a position are no neighbors of it
        with pytest.warns(loom.UnitWarning, match=r"^radius: .* within 0\.0001 m, .* within 0\.093 m") as caught:
            result = cloud.estimate_normals(radius=1e-4)
        assert caught[0].filename == __file__ and (result.normals[:, 2] ** 2 == 1).all()
    with warnings.catch_warnings(action="error"):
        assert ball.estimate_normals(radius=0.2).has_normals
        assert loom.PointCloud([[0, 0, 0], [1, 0, 0]], device=ball.device).estimate_normals(radius=1e-4).has_normals


@pytest.mark.parametrize(
    ("depth", "options", "message"),
    [
        (np.full((48, 64), 1500, np.uint16), {"depth_scale": 1.0}, "3,072 of uint16 .* read as 1 units per meter"),
        (np.full((48, 64), 1500.0, np.float32), {}, "read as meters, are beyond 3 m"),
        (np.full((48, 64), 1.5, np.float32), {"depth_scale": 1000.0}, "within 0.05 m: .* 1.5..1.5, divided by 1000"),
        (
            np.full((48, 64), 1500, np.uint16),
            {"depth_trunc": 1.0},
            "beyond 1 m; for TUM images, .*=5000. .* a larger depth_trunc",
        ),
    ],
)
def test_a_depth_scale_that_removes_all_points_warns(depth, options, message):
    color = np.zeros((48, 64, 3), np.uint8)
    with pytest.warns(loom.UnitWarning, match=message) as caught:
        loom.RGBDImage.create_from_color_and_depth(color, depth, **options)
    assert caught[0].filename == __file__
    depth[5, 5] = 1 if depth.min() > 100 else 100  # a pixel that the first look does not see
    with warnings.catch_warnings(action="error"):
        loom.RGBDImage.create_from_color_and_depth(color, depth, **options)
        loom.RGBDImage.create_from_color_and_depth(color, 0 * depth, **options)


def test_ball_radii_and_alphas_without_faces_warn(ball):
    with pytest.warns(loom.UnitWarning, match=r"^radii:.*1e-06.*0\.0") as caught:
        assert len(loom.TriangleMesh.create_from_point_cloud_ball_pivoting(ball, [1e-6])) == 0
    assert caught[0].filename == __file__
    with pytest.warns(loom.UnitWarning, match=r"^alpha:.*1e-06.*0") as caught:
        assert len(loom.TriangleMesh.create_from_point_cloud_alpha_shape(ball, 1e-6)) == 0
    assert caught[0].filename == __file__
    flat = loom.PointCloud(ball.points * [1, 1, 0], normals=np.tile([0.0, 0, 1], (800, 1)), device=ball.device)
    with pytest.warns(UserWarning, match=r"^cloud:") as caught:
        assert len(loom.TriangleMesh.create_from_point_cloud_alpha_shape(flat, 2.0)) == 0
    assert [each.category for each in caught] == [UserWarning]  # no unit gives a plane a volume
    assert caught[0].filename == __file__


def test_icp_without_correspondences_reports_both_positions(ball):
    far = loom.PointCloud(ball.points * 1000, device=ball.device)
    with pytest.warns(loom.UnitWarning, match="no correspondences:") as caught:
        result = loom.registration.registration_icp(far, ball, 0.05)
    assert caught[0].filename == __file__
    assert result.warnings[0].startswith("no correspondences: the source spans")
    assert "no correspondences: the source spans 2e+03 x " in repr(result) and "the target spans 2 x " in repr(result)
    assert repr(result).endswith("within 0.05 m; in another unit?)")
    with pytest.warns(loom.UnitWarning, match=r"no correspondences:.*100.*0\.05"):
        moved = loom.registration.registration_icp(ball.translate([100, 0, 0]), ball, 0.05)
    assert "their centers 100 m apart, within 0.05 m)" in repr(moved)
    assert loom.registration.registration_icp(ball, ball, 0.05).warnings == ()
    result = loom.registration.registration_icp(loom.PointCloud(device=ball.device), ball, 0.05)
    assert result.warnings == ("no correspondences: the source has no points",)


def test_lengths_that_suit_few_points_do_not_warn(ball):
    """A voxel around a small cluster, a loose cloud, a coarse level of a registration, an empty tile."""
    few = ball.select_by_index(range(60))
    loose = loom.PointCloud(ball.points * [40, 40, 0.1], device=ball.device)
    tile = loom.AxisAlignedBoundingBox([900, 0, 0], [910, 10, 10])
    with warnings.catch_warnings(action="error"):
        assert len(few.voxel_down_sample(9.0)) <= 8 and set(few.cluster_dbscan(9.0, 5)) == {0}
        assert len(few.segment_plane(9.0)[1]) == 60
        assert len(ball.crop(tile)) == 0
        assert loom.registration.registration_icp(ball.translate([3.0, 0, 0]), ball, 0.05).fitness == 0
        small = ball.scale(0.01)
        assert loom.registration.registration_icp(small, loom.PointCloud(ball.points[:1]), 9.0).fitness == 1
        loom.registration.registration_icp_batch(ball.translate([100, 0, 0]), ball, 0.05)
    with pytest.warns(loom.UnitWarning, match="all points are noise"):
        assert set(loose.cluster_dbscan(3.0, 200)) == {-1}
    with pytest.warns(loom.UnitWarning, match="they are removed"):
        assert len(loose.remove_radius_outlier(200, 3.0)[0]) == 0

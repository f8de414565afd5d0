"""Ground control and scale bars: files, georeferenced models with residuals, and named errors."""

import json
import re
from dataclasses import replace

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.photogrammetry.video.control_files import read_ground_control
from pointloom.photogrammetry.video.control_systems import to_geodetic, utm_code
from pointloom.photogrammetry.video.ground_control import ControlMark, GroundControl, ScaleBar
from pointloom.photogrammetry.video.job import check_marks
from pointloom.photogrammetry.video.units import VideoUnits, fit_units

from ...products import few_quick
from .made_flights import FRAME, errors, gps_of, hidden, nadir, oblique

LENS = loom.CameraModel("OPENCV", 640, 480, [480, 482, 322, 238, -0.08, 0.03, 0.001, -0.0005])
GROUND = np.array([
    [2.0, 3.0, 0.3], [41.0, 4.0, 1.8], [39.0, 44.0, 0.0], [4.0, 45.0, 2.4], [22.0, 24.0, 0.9], [30.0, 12.0, 1.1],
    [12.0, 30.0, 2.0],
])  # fmt: skip
NAMES = ("A", "B", "C", "D", "E", "F", "G")
SIGMA = 0.01


def model_of(poses):
    """The model in an arbitrary frame and unit, with the lens of this module."""
    model, _ = hidden(poses)
    return loom.SfmModel(model.names, [LENS] * len(model), model.T_camera_world)


def marks_of(poses, points=GROUND, names=NAMES, noise=0.0, max_count=8, seed=0):
    """Marks of the points in the images, in the order of the images."""
    rng = np.random.default_rng(seed)
    marks = []
    for name, point in zip(names, points, strict=True):
        seen = 0
        for k, T in enumerate(np.linalg.inv(poses)):
            pixel = LENS.project((T[:3, :3] @ point + T[:3, 3])[None])[0]
            if np.isfinite(pixel).all() and (pixel > 0).all() and (pixel < (639, 479)).all() and seen < max_count:
                pixel = pixel + rng.normal(size=2) * noise
                marks.append(ControlMark(name, f"IMG_{k:04d}.JPG", pixel))
                seen += 1
    return marks


def control_of(
    poses, points=GROUND, names=NAMES, *, marks=None, noise=0.0, crs="EPSG:32632", wrong=(), checks=(), bars=(), seed=0
):
    """Ground control in UTM, or in local east, north and up; `wrong` are (name, meters [3])."""
    rng = np.random.default_rng(seed + 100)
    known = FRAME.to_utm(points, int(crs[5:])) if crs else points.copy()
    known = known + rng.normal(size=known.shape) * (SIGMA if noise else 0.0)
    for name, off in wrong:
        known[names.index(name)] += off
    marks = marks_of(poses, points, names, noise, seed=seed) if marks is None else marks
    rows = [loom.registration.ControlPoint(name, position, SIGMA) for name, position in zip(names, known, strict=True)]
    return GroundControl(rows, marks, bars, crs, checks)


POSES = oblique()
POINTS = GROUND - (22, 24, 0)  # about the middle of the round
MODEL = model_of(POSES)


def fit_control(gps=None, bars=(), align=None, **made):
    return fit_units(VideoUnits(control=control_of(POSES, POINTS, bars=bars, **made), places=gps, align=align), MODEL)


def row(fit, name):
    return next(point for point in fit.control.points if point.name == name)


@pytest.mark.parametrize("poses", [nadir(), oblique()])
def test_exact_marks_through_a_lens_with_distortion_give_utm_coordinates_exactly(poses):
    points = GROUND if poses[0, 2, 3] > 30 else POINTS
    control = control_of(poses, points, checks=("E",))
    model = model_of(poses)
    fit = fit_units(VideoUnits(control=control), model)
    assert (fit.units, fit.by, fit.reliable, fit.notes, fit.is_upright) == ("meters", "control", True, (), True)
    scale, tilt, off = errors(fit, model, poses)
    assert abs(scale) < 1e-9 and off < 1e-6 and tilt < 1e-3  # up, some 33 m away, is rotated by 0.0003 degrees
    centers = fit.frame.to_utm(model.transform(fit.T_world_model).centers, 32632)
    np.testing.assert_allclose(centers, FRAME.to_utm(poses[:, :3, 3]), atol=1e-6)
    assert fit.control.rms("control") < 1e-6 and fit.control.rms("check") < 1e-6


@pytest.mark.parametrize(
    ("positions", "reason"),
    [
        ([[0, 0, 0], [9, 0, 0]], "^2 control points: 3 or more"),
        ([[0, 0, 0], [9, 3, 1], [18, 6, 2], [36, 12, 4]], "A, B, C, D are collinear"),
        ([[0, 0, 0], [9, 0, 0], [0, 9, 0]], "^$"),
    ],
)
def test_three_control_points_that_are_not_collinear_determine_a_similarity(positions, reason):
    rows = [loom.registration.ControlPoint(name, at) for name, at in zip("ABCD", positions, strict=False)]
    assert re.search(reason, GroundControl(rows, []).why_open())


def test_maps_require_control_with_a_coordinate_system():
    control = control_of(POSES, POINTS)
    assert VideoUnits(control=control).may_place
    assert not VideoUnits(control=replace(control, crs="")).may_place


@pytest.mark.slow
def test_errors_of_noisy_marks_agree_with_the_reported_accuracy():
    off, expected = [], []
    for seed in range(2):
        fit = fit_control(noise=0.5, checks=("E", "G"), seed=seed)
        assert fit.reliable and not [p for p in fit.control.points if p.use == "unused"]
        scale, tilt, far = errors(fit, MODEL, POSES)
        assert abs(scale) < 3.5 * fit.control.scale_sigma < 0.01
        assert tilt < 3.5 * fit.control.tilt_sigma < 0.5 and far < 0.3
        assert 0.2 < fit.control.residual_ratio < 2
        off += [row(fit, name).residual / row(fit, name).sigma for name in ("E", "G")]
        expected += [row(fit, name).residual for name in "ABCDF"]
    assert 0.3 < np.std(off) < 1.5  # errors of check points agree with their sigma
    assert 0.005 < np.std(expected) < 0.1


def test_a_check_point_does_not_move_the_model():
    before = fit_control(checks=("E",))
    after = fit_control(checks=("E",), wrong=[("E", (0.0, 0.0, 5.0))])
    np.testing.assert_array_equal(before.T_world_model, after.T_world_model)
    assert before.reliable and "check points contradict the model, E by 5 m" in str(after.warnings)
    assert after.to_dict()["control"]["reliable"] is False
    np.testing.assert_allclose(row(after, "E").residual, (0, 0, -5), atol=1e-3)
    assert "standard deviations off" in row(after, "E").warnings[0]


@few_quick(1, ("wrong", "meters"), [("A", (1.0, 0.0, 0.0)), ("F", (0.0, 0.0, 1.0))])
def test_a_blunder_is_excluded_and_named(wrong, meters):
    fit = fit_control(noise=0.3, wrong=[(wrong, meters)], seed=2)
    assert [point.name for point in fit.control.points if point.use == "unused"] == [wrong]
    assert f"excluded, {wrong} by " in str(fit.warnings) and "check their coordinates and marks" in str(fit.warnings)
    np.testing.assert_allclose(row(fit, wrong).residual, -np.array(meters), atol=0.15)
    assert errors(fit, MODEL, POSES)[2] < 0.2


@pytest.mark.slow
def test_two_blunders_among_seven_points_do_not_hide_each_other():
    fit = fit_control(noise=0.3, wrong=[("A", (2.0, 0, 0)), ("B", (0.0, 2.5, 0))])
    assert [point.name for point in fit.control.points if point.use == "unused"] == ["A", "B"]
    assert errors(fit, MODEL, POSES)[2] < 0.3


def test_contradictions_of_four_points_are_reported_without_excluding_one():
    control = control_of(POSES, POINTS[:4], NAMES[:4], wrong=[("B", (3.0, 0, 0))])
    fit = fit_units(VideoUnits(control=control), MODEL)
    assert {point.use for point in fit.control.points} == {"control"}
    words = str(fit.warnings)
    assert "times the stated accuracy" in words and "with 5 or more points the wrong one" in words


def test_points_less_accurate_than_stated_are_reported():
    fit = fit_control(noise=0.1, wrong=[(n, 0.12 * np.sin(k + np.arange(3))) for k, n in enumerate(NAMES)])
    assert fit.reliable and 2 < fit.control.residual_ratio < 5
    assert "times the stated accuracy" in str(fit)


@pytest.mark.slow
def test_a_wrong_mark_is_excluded_and_named():
    marks = marks_of(POSES, POINTS, noise=0.2)
    k = next(k for k, mark in enumerate(marks) if mark.point == "B")
    marks[k] = ControlMark("B", marks[k].image, np.add(marks[k].pixel, (60, -40)))
    fit = fit_control(marks=marks)
    assert marks[k].image.lower() in row(fit, "B").warnings[0].lower() and row(fit, "B").use == "control"
    assert fit.reliable and np.linalg.norm(row(fit, "B").residual) < 0.1


def test_a_point_in_one_image_is_unused_with_a_reason():
    marks = [m for m in marks_of(POSES, POINTS) if m.point != "D" or m.image == "IMG_0003.JPG"]
    marks += [] if any(m.point == "D" for m in marks) else marks_of(POSES, POINTS[3:4], ("D",), max_count=1)
    fit = fit_control(marks=marks)
    assert row(fit, "D").use == "unused"
    assert "1 image of the model has a mark of it; mark it in two" in row(fit, "D").warnings[0]
    assert fit.reliable


@pytest.mark.parametrize(
    ("points", "names", "reason"),
    [
        (POINTS[:2], NAMES[:2], "2 control points: 3 or more that are not collinear"),
        (np.outer(np.arange(1, 5), (4.0, 3.0, 0.0)), NAMES[:4], "A, B, C, D are collinear"),
    ],
)
def test_insufficient_points_are_rejected_early(points, names, reason):
    with pytest.raises(ValueError, match=reason):
        VideoUnits(control=control_of(POSES, points, names))


def test_gps_is_used_with_a_warning_if_control_points_are_unusable():
    marks = [m for m in marks_of(POSES, POINTS) if m.point in "AB"]
    fit = fit_control(gps_of(POSES), marks=marks)
    assert (fit.by, fit.control) == ("exif", None)
    words = "2 of 7 control points can be used (C: no image has a mark of it; mark it in two or more; D:"
    assert words in str(fit.warnings)
    assert fit_control(marks=marks).units == "arbitrary"


def test_control_is_preferred_to_gps_and_its_deviations_are_reported():
    gps = gps_of(POSES, 0.5)
    fit = fit_control(gps)
    assert (fit.by, fit.reliable, fit.gps) == ("control", True, None)
    assert errors(fit, MODEL, POSES)[2] < 1e-6
    assert len(fit.control.gps.names) == len(POSES)
    assert 0.4 < fit.control.gps.horizontal_rms < 1.1  # 0.71 is expected
    assert "GPS of 24 images, not used" in str(fit)


def test_another_zone_than_that_of_gps_is_reported():
    positions = FRAME.to_utm(POINTS, 32632)
    rows = [loom.registration.ControlPoint(n, p, SIGMA) for n, p in zip(NAMES, positions, strict=True)]
    control = GroundControl(rows, marks_of(POSES, POINTS), crs="EPSG:32633")
    fit = fit_units(VideoUnits(control=control, places=gps_of(POSES)), MODEL)
    assert "km from the GPS positions" in str(fit.warnings) and "EPSG:32633" in str(fit.warnings)


@pytest.mark.parametrize(
    ("crs", "position", "reason"),
    [
        ("EPSG:32632", (8.25, 47.5, 400.0), "x is 8.25, and EPSG:32632 has 100000"),
        ("EPSG:32632", (5260000.0, 443500.0, 400.0), "x is the easting"),
        ("EPSG:4326", (470.5, 8.25, 400.0), "x the longitude and y the latitude"),
        ("EPSG:999999", (443500.0, 5260000.0, 400.0), "expected a coordinate system"),
        ("EPSG:4978", (4.2e6, 6e5, 400.0), "expected meters of a map"),
        ("EPSG:2263", (9.8e5, 2e5, 40.0), "US survey foot"),
    ],
)
def test_coordinates_outside_their_system_are_rejected(crs, position, reason):
    if crs not in ("EPSG:32632", "EPSG:4326"):
        pytest.importorskip("pyproj")
    with pytest.raises(ValueError, match=reason):
        GroundControl([loom.registration.ControlPoint("A", position)], [], crs=crs)


def test_a_reported_origin_is_subtracted_from_large_local_coordinates():
    far = np.add(POINTS, (612000.0, 204000.0, 430.0))
    control = control_of(POSES, POINTS, crs="")
    rows = [loom.registration.ControlPoint(n, p, SIGMA) for n, p in zip(NAMES, far, strict=True)]
    fit = fit_units(VideoUnits(control=GroundControl(rows, control.marks)), MODEL)
    assert fit.frame is None and fit.control.origin.tolist() == [612000.0, 204000.0, 400.0]
    centers = MODEL.transform(fit.T_world_model).centers + fit.control.origin
    np.testing.assert_allclose(centers, POSES[:, :3, 3] + (612000, 204000, 430), atol=1e-6)
    assert "origin 612000 204000 400" in fit.comments


def bar(a, b, off=0.0, sigma=0.002):
    return ScaleBar(a, b, float(np.linalg.norm(POINTS[NAMES.index(a)] - POINTS[NAMES.index(b)])) + off, sigma)


@pytest.mark.parametrize("ends", [("A", "A"), ("", "B"), ("A", "")])
def test_a_scale_bar_has_two_named_ends(ends):
    with pytest.raises(ValueError, match="b: expected the names of two points"):
        ScaleBar(*ends, 1.5)


def bars_alone(*bars, noise=0.0, align="none"):
    control = GroundControl([], marks_of(POSES, POINTS, noise=noise), bars)
    return fit_units(VideoUnits(control=control, align=align), MODEL)


def test_scale_bars_alone_set_the_scale_and_nothing_else():
    fit = bars_alone(bar("A", "B"), bar("C", "E"))
    assert (fit.units, fit.by, fit.reliable, fit.frame, fit.is_upright) == ("meters", "scale_bars", True, None, False)
    np.testing.assert_allclose(fit.T_world_model, np.diag([fit.scale] * 3 + [1]))
    assert abs(errors(fit, MODEL, POSES)[0]) < 1e-9
    assert max(abs(each.error) for each in fit.control.bars) < 1e-6
    assert bars_alone(bar("A", "B"), align=None).up.direction is not None  # cameras still make it upright


@pytest.mark.slow
def test_one_wrong_bar_of_three_is_excluded_and_two_contradicting_ones_are_reported():
    fit = bars_alone(bar("A", "B"), bar("C", "E", 3.0), bar("D", "F"), noise=0.2)
    assert [each.use for each in fit.control.bars] == ["control", "unused", "control"]
    assert "contradict the others and were excluded, C to E is" in str(fit.warnings)
    assert abs(errors(fit, MODEL, POSES)[0]) < 0.005
    fit = bars_alone(bar("A", "B"), bar("C", "E", 3.0))
    assert "scale bars contradict each other" in str(fit.warnings)
    assert {each.use for each in fit.control.bars} == {"control"}


@pytest.mark.slow
def test_bars_beside_points_sharpen_the_scale_and_a_wrong_one_is_named():
    bars = [bar("A", "C", sigma=1e-4), bar("B", "D", sigma=1e-4)]
    plain, sharp = fit_control(noise=0.5), fit_control(noise=0.5, bars=bars)
    assert sharp.control.scale_sigma < plain.control.scale_sigma
    wrong = fit_control(noise=0.3, bars=[bar("A", "C", 2.0)])
    assert wrong.control.bars[0].use == "unused" and "A to C is" in str(wrong.warnings)
    assert errors(wrong, MODEL, POSES)[2] < 0.3
    check = fit_control(bars=[bar("A", "E")], checks=("E",))
    assert check.control.bars[0].use == "check" and abs(check.control.bars[0].error) < 1e-6 and check.reliable
    wrong = fit_control(bars=[bar("A", "E", 2.0)], checks=("E",))
    assert "scale bars of check points contradict the model, A to E is" in str(wrong.warnings)


def test_too_few_points_beside_bars_are_ignored_with_a_note():
    control = control_of(POSES, POINTS[:2], NAMES[:2], bars=[bar("A", "B")])
    fit = fit_units(VideoUnits(control=control), MODEL)
    assert fit.by == "scale_bars" and fit.reliable and "the points are not used: 2 control points" in str(fit)


def test_the_report_has_residual_sigma_and_use_of_each_point_and_bar():
    fit = fit_control(gps_of(POSES, altitudes=False), [bar("A", "B")], noise=0.3, checks=("E",))
    report = json.loads(json.dumps(fit.to_dict(), allow_nan=False))["control"]
    assert (report["epsg"], report["crs"], len(report["points"]), len(report["bars"])) == (32632, "EPSG:32632", 7, 1)
    assert {point["name"]: point["use"] for point in report["points"]}["E"] == "check"
    assert all(len(point["residual_m"]) == 3 and min(point["sigma_m"]) >= 0 for point in report["points"])
    assert report["bars"][0]["sigma_m"] > 0.002 and abs(report["bars"][0]["error_m"]) < 0.1
    assert report["gps"]["shift_m"][2] is None


def test_marks_of_unused_images_are_ignored():
    mark = ControlMark("A", "IMG_0009.jpg", (3, 4))
    check_marks(GroundControl([], [mark]), ["IMG_0001.jpg"], {}, ["IMG_0001.jpg", "IMG_0009.jpg"])


@pytest.mark.parametrize("where", ["", "marks.csv (line 3)"])
def test_errors_name_the_origin_of_a_mark_or_the_file_of_the_control(where):
    control = GroundControl([], [ControlMark("A", "none.jpg", (3, 4), where=where)], path="gcp.txt")
    with pytest.raises(FileError) as caught:
        check_marks(control, ["IMG_0001.jpg"], {})
    assert str(caught.value.path) == ("marks.csv" if where else "gcp.txt")
    assert ("line 3" in str(caught.value)) == bool(where)


ODM = """WGS84 UTM 32N
447000.0 5260000.0 410.0 320 240 a.jpg A
447000.0 5260000.0 410.0 100 240.5 b.jpg A
# a comment

447040.0 5260010.0 411.5 12 14 a.jpg CHK-1
447040.0 5260010.0 411.5 13 15 b.jpg CHK-1
bar A CHK-1 41.2 0.01
"""
CSV = """# crs: EPSG:25832
name,x,y,z,sigma,sigma_z,use,image,column,row
"A",447000.0,5260000.0,410.0,0.01,0.03,,a.jpg,320,240
A,,,,,,,b.jpg,100,240.5
Mill 2,447040.0,5260010.0,411.5,,,check,"a, b.jpg",12,14
bar,A,Mill 2,41.2
"""


@pytest.fixture
def written(tmp_path):
    def write(text, name="gcp.txt"):
        (tmp_path / name).write_text(text)
        return tmp_path / name

    return write


def test_the_list_of_odm_is_read(written):
    control = read_ground_control(written(ODM))
    assert repr(control) == "GroundControl(2 points, 4 marks, 1 scale bar, WGS84 UTM 32N)"
    assert (control.checks, [point.name for point in control.fitted]) == (("CHK-1",), ["A"])
    # Files count from the corner, pointloom from the center of the first pixel.
    assert control.marks[1].pixel.tolist() == [99.5, 240.0]
    assert control.marks[1].where.endswith("gcp.txt (line 3)")
    assert control.positions.tolist() == [[447000.0, 5260000.0, 410.0], [447040.0, 5260010.0, 411.5]]
    assert (control.bars[0].meters, control.bars[0].sigma) == (41.2, 0.01)


def test_a_csv_is_read_with_sigma_and_use(written):
    control = read_ground_control(written("\ufeff" + CSV, "gcp.csv"))
    assert (control.crs, control.checks, control.marks[2].image) == ("EPSG:25832", ("Mill 2",), "a, b.jpg")
    assert np.asarray(control.points[0].sigma).tolist() == [0.01, 0.01, 0.03]
    assert control.bars == (ScaleBar("A", "Mill 2", 41.2),)


def test_points_without_names_are_merged_by_position(written):
    lines = "local\n1 2 3 4 5 a.jpg\n1 2 3 6 7 b.jpg\n1 2 4 6 7 b.jpg\n"
    control = read_ground_control(written(lines))
    assert ([p.name for p in control.points], len(control.marks), control.crs) == (["point 1", "point 2"], 3, "")


def test_scale_bars_are_read_from_a_separate_file_with_additional_marks(written):
    bars = written("mark P a.jpg 5 6\nmark P b.jpg 7 8\nbar P A 1.5\n", "bars.txt")
    control = read_ground_control(written(ODM), scale_bars=bars)
    assert (len(control.bars), len(control.marks), control.crs) == (2, 6, "WGS84 UTM 32N")
    alone = "name,image,column,row\nP,a.jpg,5,6\nP,b.jpg,6,7\nQ,a.jpg,5,6\nQ,b.jpg,7,7\nbar,P,Q,1.5\n"
    assert VideoUnits(scale_bars=written(alone, "bars.csv")).ground.bars[0].meters == 1.5
    assert VideoUnits(control=written(ODM), scale_bars=bars).ground.bars == control.bars
    with pytest.raises(ValueError, match="scale_bars: scale is also given"):
        VideoUnits(scale=2.0, scale_bars=bars)
    with pytest.raises(FileError, match=r"gcp2\.txt"):
        read_ground_control(None, scale_bars=written(ODM.replace("bar A", "# "), "gcp2.txt"))


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("", "contains no lines"),
        ("EPSG:32632\n", "contains no marks of points in images"),
        (ODM.split("\n", 1)[1], r"\(line 1\): is a mark, but no line before it contains the coordinate system"),
        (ODM.replace(" 12 14 a.jpg CHK-1", " 12 14"), r"line 6\): expected 6 words or more, got 5"),
        (ODM.replace("447000.0 5260000.0 410.0 100", "1.0 2.0 3.0 100"), r"line 3\): the point 'A' has two positions"),
        (ODM.replace("b.jpg A", "a.jpg A"), r"line 3\): 'A' is marked twice in a\.jpg"),
        (ODM.replace("240.5", "x"), r"line 3\): expected column and row"),
        (ODM.replace("240.5", "nan"), r"line 3\): expected column and row"),
        (ODM.replace("410.0", "inf"), r"line 2\): expected x, y and z"),
        (ODM.replace("bar A CHK-1 41.2", "bar A B 41.2"), "bars: A to B: no image has a mark of 'B'"),
        (ODM.replace("41.2", "-41.2"), r"line 8\): meters: expected a finite number > 0"),
        (ODM.replace("bar A CHK-1", "bar A A"), r"line 8\): b: expected the names of two points"),
        (ODM.replace("bar A CHK-1 41.2 0.01", "bar A 41.2"), r"line 8\): expected `bar A B meters"),
        (ODM.replace("447040.0 5260010.0", "5260010.0 447040.0"), "x is the easting and y the northing"),
        (CSV.replace("name,x", "code,x"), "no coordinate system|line"),
        (CSV.replace("image,column,row", "image,row"), r"line 2\): the header lacks column"),
        (CSV.replace("0.01,0.03", "0,0.03"), r"line 3\): expected standard deviations of 1e-06"),
        (CSV.replace("check", "chek"), r"line 5\): expected control or check as the use, got 'chek'"),
        (CSV.replace(",,,,,,,b.jpg", ",1,,,,,,b.jpg"), r"line 4\): expected x, y and z"),
        (CSV.replace("\nA,", "\n,"), r"line 4\): expected 10 fields and a name"),
    ],
)
def test_invalid_files_are_rejected_with_their_line(written, text, reason):
    with pytest.raises(FileError, match=reason):
        read_ground_control(written(text))


def test_no_file_no_text_and_too_few_points_are_refused(written, tmp_path):
    with pytest.raises(FileError, match=r"/none\.txt:"):
        VideoUnits(control=tmp_path / "none.txt")
    (tmp_path / "gcp.bin").write_bytes(b"\xff\xfe\x00\x01")
    with pytest.raises(FileError, match=r"/gcp\.bin:.*UTF-8"):
        VideoUnits(control=tmp_path / "gcp.bin")
    path = written(ODM.replace("bar A", "# "))
    with pytest.raises(FileError, match=r"gcp\.txt"):
        VideoUnits(control=path)
    with pytest.raises(ValueError, match="control:"):
        VideoUnits(control=path, scale=2.0)
    with pytest.raises(ValueError, match=r"^path:"):
        read_ground_control(None)


ZONES = {"WGS84 UTM 32N": 32632, "EPSG:25832": 32632, "wgs84 utm zone 19s": 32719, "EPSG:31467": None}
ZONES |= {"WGS84 UTM 61N": None, "+proj=utm +zone=23 +south +ellps=GRS80 +units=m +no_defs": 32723}


@pytest.mark.parametrize(("crs", "code"), ZONES.items())
def test_zones_of_utm_need_no_pyproj(crs, code):
    assert utm_code(crs) == code


def test_other_grids_are_converted_by_pyproj():
    pyproj = pytest.importorskip("pyproj")
    x, y = pyproj.Transformer.from_crs("EPSG:4326", "EPSG:2056", always_xy=True).transform(8.25, 47.5)
    np.testing.assert_allclose(to_geodetic(np.array([[x, y, 430.0]]), "EPSG:2056", "f"), [[47.5, 8.25, 430]], atol=1e-7)


def test_records_know_another_control(written):
    before = read_ground_control(written(ODM)).digest()
    assert before == read_ground_control(written(ODM, "other.txt")).digest()
    changed = [ODM.replace("240.5", "241"), ODM.replace("411.5", "411.6"), ODM.replace("41.2", "41.3"), CSV]
    assert len({before, *(read_ground_control(written(text)).digest() for text in changed)}) == 5


@pytest.mark.parametrize("row", ["B" * 140_000 + ",1,2,3,a.jpg,1,2", '"' + "x" * 140_000])
def test_a_field_beyond_the_limit_of_the_csv_module_is_a_file_error(tmp_path, row):
    path = tmp_path / "gcp.csv"
    path.write_text(f"name,x,y,z,image,column,row\n{row}\nA,447000,5260000,410,a.jpg,320,240\n")
    with pytest.raises(loom.FileError, match=r"gcp\.csv \(line 2\): is not a row of a table"):
        read_ground_control(path)

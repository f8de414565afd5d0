"""The unit of a model, and its position and up direction by GPS, known positions or level cameras."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.photogrammetry.sfm.image_positions import ImagePositions
from pointloom.photogrammetry.video.units import VideoUnits, fit_units
from pointloom.registration.rigid import make_pose

from .made_flights import FRAME, attitudes_of, errors, gps_of, hidden, nadir, oblique, street

NAMES = tuple(f"frame_{number:06d}.png" for number in (0, 7, 12, 30, 41))
CENTERS = np.array([[0, 0, 0], [1, 0, 0], [1, 2, 0], [0, 2, 1], [3, 1, 2]], float)
R = np.array([[0, 0, 1], [1, 0, 0], [0, 1, 0]], float)
TRUE = make_pose(2.5 * R, np.array([10.0, -4.0, 500_000.0]))
POSITIONS = CENTERS @ TRUE[:3, :3].T + TRUE[:3, 3]


def model_of(names=NAMES, centers=CENTERS):
    poses = np.tile(np.eye(4), (len(names), 1, 1))
    poses[:, :3, 3] = -np.asarray(centers)
    return loom.SfmModel(names, [loom.CameraModel("PINHOLE", 64, 48, [60, 60, 32, 24])] * len(names), poses)


def write_positions(path, names=NAMES, positions=POSITIONS):
    rows = zip(names, positions.tolist(), strict=True)
    path.write_text("# name x y z\n" + "".join(f"{name} {x!r} {y!r} {z!r}\n" for name, (x, y, z) in rows))
    return path


@pytest.mark.parametrize(
    ("scale", "expected"),
    [(None, {"units": "arbitrary", "scale": 1.0, "by": None}), (2.5, {"units": "meters", "scale": 2.5, "by": "scale"})],
)
def test_a_factor_gives_meters_and_without_one_the_unit_is_arbitrary(scale, expected):
    fit = fit_units(VideoUnits(scale=scale), model_of())
    assert fit.to_dict() == expected | {"reliable": True, "warnings": []}
    np.testing.assert_array_equal(fit.T_world_model, np.diag([scale or 1.0] * 3 + [1]))


@pytest.mark.parametrize(
    "names", [("frame_000007.png", "frame_000041"), ("7", "41"), (7, 41), ("000007", "frame_000041")]
)
def test_the_distance_of_two_cameras_gives_meters(names):
    fit = fit_units(VideoUnits(known=(*names, 6.0)), model_of())
    assert fit.units == "meters"
    assert fit.scale == pytest.approx(2.0, rel=1e-12)  # they are 3 apart


@pytest.mark.parametrize("called", ["{}", "{stem}", "{number}", "{number:06d}"])
def test_known_positions_transform_the_model(tmp_path, called):
    names = [called.format(n, stem=n[:-4], number=int(n[6:12])) for n in NAMES]
    fit = fit_units(VideoUnits(align=write_positions(tmp_path / "places.txt", names)), model_of())
    assert (fit.known_positions.count, fit.by, fit.reliable) == (5, "align", True)
    assert fit.scale == pytest.approx(2.5, rel=1e-9)
    assert fit.known_positions.rms_m < 1e-8
    np.testing.assert_allclose(fit.T_world_model, TRUE, atol=1e-8)


@pytest.mark.parametrize("form", ["log", "tum"])
def test_poses_of_some_images_are_known_positions(tmp_path, form):
    numbers = np.array([[0], [12], [30], [41], [99]])
    poses = np.array([make_pose(np.eye(3), position) for position in [*POSITIONS[[0, 2, 3, 4]], POSITIONS[0] + 100]])
    ids, path = np.hstack([numbers, numbers, numbers + 1]), tmp_path / ("poses.log" if form == "log" else "poses.txt")
    numbering = {"ids": ids} if form == "log" else {"timestamps": numbers[:, 0] * 1.0}
    loom.write_trajectory(path, loom.Trajectory(poses, **numbering), format=form)
    fit = fit_units(VideoUnits(align=path), model_of())
    assert fit.known_positions.count == 4
    np.testing.assert_allclose(fit.T_world_model, TRUE, atol=1e-6)


def test_a_contradicting_position_is_excluded_and_named(tmp_path):
    wrong = POSITIONS.copy()
    wrong[2] += 5
    fit = fit_units(VideoUnits(align=write_positions(tmp_path / "places.txt", positions=wrong)), model_of())
    assert fit.reliable
    assert fit.known_positions.left_out == (NAMES[2],)
    np.testing.assert_allclose(fit.T_world_model, TRUE, atol=1e-8)


def test_positions_that_contradict_the_model_are_reported(tmp_path):
    wrong = POSITIONS + 3 * np.random.default_rng(0).normal(size=POSITIONS.shape)
    fit = fit_units(VideoUnits(align=write_positions(tmp_path / "places.txt", positions=wrong)), model_of())
    assert not fit.reliable
    assert "differ by" in str(fit.warnings)


def test_two_cameras_at_one_position_have_no_distance():
    with pytest.raises(ValueError, match=r"^known:"):
        fit_units(VideoUnits(known=("0", "7", 1.0)), model_of(centers=np.zeros((5, 3))))
    for second in ("frame_000007", "13"):
        with pytest.raises(ValueError, match=r"^known:"):
            VideoUnits(known=("7", second, 1.0)).check_names(NAMES)
    with pytest.raises(ValueError, match="matches 2 images"):
        VideoUnits(known=("7", "12", 1.0)).check_names([*NAMES, "other_7.png"])


@pytest.mark.parametrize(
    ("given", "error"),
    [
        ({"known": ("0", "7", -1.0)}, ValueError),
        ({"known": ("0", "7")}, TypeError),
        ({"known": (None, "7", 1.0)}, TypeError),
        ({"known": ("0", "7", 1.0), "scale": 1.0}, ValueError),
        ({"align": "nowhere.txt"}, FileError),
    ],
)
def test_invalid_units_are_rejected(given, error):
    with pytest.raises(error, match=f"{next(iter(given))}|nowhere"):
        VideoUnits(**given)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("0 1 2 3\n7 1 2\n", "line 2.*name x y z"),
        ("0 1 2 3\n7 1 2 nan\n", "line 2.*finite"),
        ("0 1 2 3\n0 1 2 4\n7 1 1 1\n", "'frame_000000.png' is duplicated"),
        ("0 1 2 3\n7 3 2 1\n", "the positions of 2 images in the model; 3 or more"),
        ("x 1 2 3\ny 2 2 3\nz 3 4 5\n", "contains no name of an image of the model"),
        ("0 1 2 3\n7 2 4 6\n12 3 6 9\n", "on a line"),
    ],
)
def test_a_file_of_insufficient_positions_is_an_error(tmp_path, text, message):
    path = tmp_path / "places.txt"
    path.write_text(text)
    with pytest.raises(FileError, match=message):
        fit_units(VideoUnits(align=path), model_of())


def test_images_of_a_folder_keep_their_original_names():
    names = ["0000_IMG_9.jpg", "0001_IMG_10.jpg", "0002_porch.jpg"]
    for known in (("IMG_9", "porch", 1.0), ("IMG_9.JPG", "porch.jpeg", 1.0), ("0000_IMG_9", "0002_porch.jpg", 1.0)):
        fit = fit_units(VideoUnits(known=known), model_of(names, [[0, 0, 0], [9, 9, 9], [0, 0, 2.0]]))
        assert fit.scale == pytest.approx(0.5)


def fit_gps(poses, gps, align=None, **known):
    model, _ = hidden(poses)
    return fit_units(VideoUnits(align=align, places=gps, **known), model), model


@pytest.mark.parametrize(("flight", "wild"), [(nadir, ()), (oblique, (3,))])
def test_exact_gps_gives_the_true_position(flight, wild):
    poses = flight()
    fit, model = fit_gps(poses, gps_of(poses, wild=wild))
    assert (fit.units, fit.by, fit.reliable, fit.notes) == ("meters", "exif", True, ())
    assert fit.gps.left_out == tuple(f"IMG_{k:04d}.jpg" for k in wild)
    scale, tilt, off = errors(fit, model, poses)
    assert abs(scale) < 1e-8 and off < 1e-5
    assert tilt < 1e-3  # up at the median position, 50 m away, is rotated by 0.0005 degrees


@pytest.mark.parametrize(
    ("flight", "noise", "wild"), [(nadir, 0.5, ()), (nadir, 2.0, (3, 11)), (oblique, 0.5, (3, 11)), (oblique, 2.0, ())]
)
def test_errors_of_noisy_gps_agree_with_the_reported_accuracy(flight, noise, wild):
    poses = flight()
    for seed in range(3):
        fit, model = fit_gps(poses, gps_of(poses, noise, wild, seed=seed))
        assert set(fit.gps.left_out) >= {f"IMG_{k:04d}.jpg" for k in wild} and len(fit.gps.left_out) <= len(wild) + 1
        scale, tilt, off = errors(fit, model, poses)
        assert abs(scale) < 3.5 * fit.gps.scale_sigma < 0.18
        assert tilt < 3.5 * fit.gps.tilt_sigma
        assert off < 3.5 * noise
        assert 0.7 * noise < fit.gps.horizontal_rms < 2.1 * noise  # 1.41 is expected, less the part absorbed by the fit
        assert 0.8 * noise < fit.gps.vertical_rms < 3.2 * noise  # twice that is expected


def test_the_gimbal_gives_up_of_a_nadir_flight_ten_times_better_than_heights():
    poses = nadir()
    tilts = []
    for attitudes in (None, attitudes_of(poses)):
        fit, model = fit_gps(poses, gps_of(poses, 2.0, attitudes=attitudes, seed=1))
        tilts.append(errors(fit, model, poses)[1])
    assert fit.up.by == "attitudes"
    assert tilts[1] < 0.1 * tilts[0] and tilts[1] < 0.3


def test_a_straight_path_requires_level_cameras():
    poses = street()
    fit, model = fit_gps(poses, gps_of(poses, 0.2, sigma=0.2))
    scale, tilt, off = errors(fit, model, poses)
    assert fit.by == "exif" and abs(scale) < 0.02 and tilt < 0.5 and off < 1.0
    alike = np.array([poses[0]] * len(poses))
    alike[:, :3, 3] = poses[:, :3, 3]
    fit, _ = fit_gps(alike, gps_of(poses, 0.2, sigma=0.2))
    assert (fit.units, fit.by, fit.reliable) == ("arbitrary", None, True)
    assert "GPS of the images is not used" in fit.notes[0] and "on a line" in fit.notes[0]


def test_gps_without_altitudes_is_fitted_horizontally():
    poses = oblique()
    fit, model = fit_gps(poses, gps_of(poses, 0.5, altitudes=False))
    assert fit.by == "exif" and np.isnan(fit.gps.vertical_rms)
    scale, tilt, _ = errors(fit, model, poses)
    assert abs(scale) < 0.02 and tilt < 0.5
    assert fit.to_dict()["gps"]["vertical_rms_m"] is None


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        (lambda p: gps_of(p * 0 + p[:1], 0.5), "cover"),  # one position
        (lambda p: gps_of(p, sigma=50.0), "the GPS positions cover only 8"),  # not farther apart than their accuracy
        (lambda p: gps_of(p[np.random.default_rng(0).permutation(len(p))], 0.5), "determine|differ|agree"),
    ],
)
def test_insufficient_gps_is_reported_and_unreliable_if_requested(change, reason):
    poses = oblique()
    gps = change(poses)
    fit, _ = fit_gps(poses, gps)
    assert (fit.units, fit.reliable) == ("arbitrary", True)
    assert fit.is_upright
    assert reason.split("|")[0] in fit.notes[-1] or any(each in fit.notes[-1] for each in reason.split("|"))
    requested, _ = fit_gps(poses, gps, "exif")
    assert not requested.reliable


def test_gps_is_ignored_with_other_units_or_none():
    poses = oblique()
    gps = gps_of(poses)
    fit, _ = fit_gps(poses, gps, scale=2.0)
    assert (fit.by, fit.scale, fit.gps, fit.is_upright) == ("scale", 2.0, None, True)
    fit, _ = fit_gps(poses, gps, "none")
    np.testing.assert_array_equal(fit.T_world_model, np.eye(4))
    assert (fit.units, fit.up) == ("arbitrary", None)


def test_requested_gps_with_too_few_positions_is_rejected_early():
    few = ImagePositions(gps_of(oblique()).places[:2], {}, {"c.jpg": "its latitude is 97 degrees"}, 3)
    with pytest.raises(ValueError, match=r"^align:.*2.*3.*c\.jpg.*97"):
        VideoUnits(align="exif", places=few).check_names(["IMG_0000.jpg", "IMG_0001.jpg", "c.jpg"])
    with pytest.raises(ValueError, match=r"^align:"):
        VideoUnits(align="exif").check_names(["frame_000000.png"])


def test_the_report_has_origin_zone_and_the_residual_of_each_image():
    poses = nadir()
    fit, _ = fit_gps(poses, gps_of(poses, 0.5, (3,)))
    report = fit.to_dict()["gps"]
    assert report["epsg"] == 32632 and len(report["residuals_m"]) == 24
    assert abs(report["origin"]["latitude"] - FRAME.latitude) < 1e-3
    assert np.hypot(*report["residuals_m"]["IMG_0003.jpg"][:2]) > 45
    assert "EPSG:32632" in str(fit) and "without IMG_0003.jpg" in str(fit)


@pytest.mark.parametrize("poses", [oblique(), street()])
def test_without_gps_level_cameras_make_the_model_upright(poses):
    fit, model = fit_gps(poses, None)
    assert (fit.units, fit.up.by) == ("arbitrary", "cameras")
    assert errors(fit, model, poses)[1] < 0.5
    assert "upright" in str(fit)


def test_a_few_cameras_on_their_side_do_not_change_up():
    poses = oblique(30)
    poses[::10, :3, :3] = poses[::10, :3, :3] @ np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])
    fit, model = fit_gps(poses, None)
    assert errors(fit, model, poses)[1] < 0.1


def test_up_is_undetermined_without_level_cameras():
    flight = nadir()
    fit, _ = fit_gps(flight, None)
    assert fit.up.direction is None and "have one orientation" in fit.up.warnings[0]
    np.testing.assert_array_equal(fit.T_world_model, np.eye(4))
    rng = np.random.default_rng(0)
    tumbling = oblique()
    for T in tumbling:
        q = np.linalg.qr(rng.normal(size=(3, 3)))[0]
        T[:3, :3] = q * np.sign(np.linalg.det(q))
    fit, _ = fit_gps(tumbling, None)
    assert fit.up.direction is None and "not held level" in fit.up.warnings[0]


def test_attitudes_that_contradict_the_model_are_rejected():
    poses = oblique()
    rng = np.random.default_rng(0)
    wrong = {name: (0.0, *rng.uniform(-90, 90, 2)) for name in attitudes_of(poses)}
    fit, model = fit_gps(poses, ImagePositions((), wrong, {}, len(poses)))
    assert fit.up.by == "cameras"
    assert errors(fit, model, poses)[1] < 0.5


def test_attitudes_make_a_nadir_flight_upright_without_gps():
    poses = nadir()
    fit, model = fit_gps(poses, ImagePositions((), attitudes_of(poses), {}, len(poses)))
    assert fit.up.by == "attitudes"
    assert errors(fit, model, poses)[1] < 0.01

"""The unit of a model: arbitrary, by a factor, by the distance of two cameras, or by known positions."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.photogrammetry.video.units import Units, fit_units
from pointloom.registration.rigid import make_pose

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
    fit = fit_units(Units(scale=scale), model_of())
    assert fit.to_dict() == expected
    np.testing.assert_array_equal(fit.T_world_model, np.diag([scale or 1.0] * 3 + [1]))


@pytest.mark.parametrize(
    "names", [("frame_000007.png", "frame_000041"), ("7", "41"), (7, 41), ("000007", "frame_000041")]
)
def test_the_distance_of_two_cameras_gives_meters(names):
    fit = fit_units(Units(known=(*names, 6.0)), model_of())
    assert fit.units == "meters"
    assert fit.scale == pytest.approx(2.0, rel=1e-12)  # they are 3 apart


@pytest.mark.parametrize("called", ["{}", "{stem}", "{number}", "{number:06d}"])
def test_known_positions_transform_the_model(tmp_path, called):
    names = [called.format(n, stem=n[:-4], number=int(n[6:12])) for n in NAMES]
    fit = fit_units(Units(align=write_positions(tmp_path / "places.txt", names)), model_of())
    assert (fit.known_positions.count, fit.by, fit.reliable) == (5, "align", True)
    assert fit.scale == pytest.approx(2.5, rel=1e-9)
    assert fit.known_positions.rms_m < 1e-8
    np.testing.assert_allclose(fit.T_world_model, TRUE, atol=1e-8)


@pytest.mark.parametrize("form", ["log", "tum"])
def test_poses_of_some_pictures_are_known_positions(tmp_path, form):
    numbers = np.array([[0], [12], [30], [41], [99]])
    poses = np.array([make_pose(np.eye(3), position) for position in [*POSITIONS[[0, 2, 3, 4]], POSITIONS[0] + 100]])
    ids, path = np.hstack([numbers, numbers, numbers + 1]), tmp_path / ("poses.log" if form == "log" else "poses.txt")
    numbering = {"ids": ids} if form == "log" else {"timestamps": numbers[:, 0] * 1.0}
    loom.write_trajectory(path, loom.Trajectory(poses, **numbering), format=form)
    fit = fit_units(Units(align=path), model_of())
    assert fit.known_positions.count == 4
    np.testing.assert_allclose(fit.T_world_model, TRUE, atol=1e-6)


def test_a_contradicting_position_is_excluded_and_named(tmp_path):
    wrong = POSITIONS.copy()
    wrong[2] += 5
    fit = fit_units(Units(align=write_positions(tmp_path / "places.txt", positions=wrong)), model_of())
    assert fit.reliable
    assert fit.known_positions.left_out == (NAMES[2],)
    np.testing.assert_allclose(fit.T_world_model, TRUE, atol=1e-8)


def test_positions_that_contradict_the_model_are_reported(tmp_path):
    wrong = POSITIONS + 3 * np.random.default_rng(0).normal(size=POSITIONS.shape)
    fit = fit_units(Units(align=write_positions(tmp_path / "places.txt", positions=wrong)), model_of())
    assert not fit.reliable
    assert "differ by" in str(fit.warnings)


def test_two_cameras_at_one_position_have_no_distance():
    with pytest.raises(ValueError, match=r"^known:"):
        fit_units(Units(known=("0", "7", 1.0)), model_of(centers=np.zeros((5, 3))))
    with pytest.raises(ValueError, match=r"^known:"):
        Units(known=("7", "frame_000007", 1.0)).check_names(NAMES)
    with pytest.raises(ValueError, match=r"^known:"):
        Units(known=("7", "13", 1.0)).check_names(NAMES)
    with pytest.raises(ValueError, match="matches 2 images"):
        Units(known=("7", "12", 1.0)).check_names([*NAMES, "other_7.png"])


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
        Units(**given)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("0 1 2 3\n7 1 2\n", "line 2.*a name and three numbers"),
        ("0 1 2 3\n7 1 2 nan\n", "line 2.*finite"),
        ("0 1 2 3\n0 1 2 4\n7 1 1 1\n", "'frame_000000.png' is duplicated"),
        ("0 1 2 3\n7 3 2 1\n", "the positions of 2 images in the model; 3 or more"),
        ("x 1 2 3\ny 2 2 3\nz 3 4 5\n", "contains no name of a picture of the model"),
        ("0 1 2 3\n7 2 4 6\n12 3 6 9\n", "on a line"),
    ],
)
def test_a_file_of_insufficient_positions_is_an_error(tmp_path, text, message):
    path = tmp_path / "places.txt"
    path.write_text(text)
    with pytest.raises(FileError, match=message):
        fit_units(Units(align=path), model_of())


def test_pictures_of_a_folder_keep_their_original_names():
    names = ["0000_IMG_9.jpg", "0001_IMG_10.jpg", "0002_porch.jpg"]
    for known in (("IMG_9", "porch", 1.0), ("IMG_9.JPG", "porch.jpeg", 1.0), ("0000_IMG_9", "0002_porch.jpg", 1.0)):
        fit = fit_units(Units(known=known), model_of(names, [[0, 0, 0], [9, 9, 9], [0, 0, 2.0]]))
        assert fit.scale == pytest.approx(0.5)

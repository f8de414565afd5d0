"""Positions from EXIF and XMP are read strictly, and invalid values are named."""

import numpy as np
import pytest
from PIL import Image
from PIL.TiffImagePlugin import IFDRational

import pointloom as loom

GOOD = {1: "N", 2: (47.0, 30.0, 36.0), 3: "E", 4: (8.0, 15.0, 0.0), 5: b"\0", 6: 430.5, 31: 2.5}
DJI = (
    b'<x:xmpmeta><rdf:Description drone-dji:AbsoluteAltitude="+431.20" drone-dji:RelativeAltitude="+50.10" '
    b'drone-dji:GimbalYawDegree="+12.30" drone-dji:GimbalPitchDegree="-89.90" drone-dji:GimbalRollDegree="+0.50" '
    b'drone-dji:FlightYawDegree="14.0" drone-dji:RtkFlag="50" drone-dji:RtkStdLon="0.012" drone-dji:RtkStdLat="0.015" '
    b'drone-dji:RtkStdHgt="0.03"/></x:xmpmeta>'
)
PIX4D = b"<Camera:Yaw>10</Camera:Yaw><Camera:Pitch>5.5</Camera:Pitch><Camera:Roll>-1</Camera:Roll>"


def write(path, gps=None, xmp=None, orientation=None):
    exif = Image.Exif()
    if gps:
        exif.get_ifd(0x8825).update(gps)
    if orientation:
        exif[0x0112] = orientation
    pixels = np.random.default_rng(0).integers(0, 256, (32, 48, 3), np.uint8)
    Image.fromarray(pixels).save(path, exif=exif, **({"xmp": xmp} if xmp else {}))
    return path


def position_of(path, *args, **kwargs):
    (position,) = loom.sfm.read_picture_places([write(path, *args, **kwargs)]).places
    return position


def test_position_and_accuracy_are_read_from_exif(tmp_path):
    position = position_of(tmp_path / "a.jpg", GOOD)
    assert (position.latitude, position.longitude, position.altitude) == (47.51, 8.25, 430.5)
    assert (position.horizontal_sigma, position.vertical_sigma, position.attitude) == (2.5, None, None)


def test_the_other_hemispheres_and_below_the_sea(tmp_path):
    position = position_of(tmp_path / "a.jpg", GOOD | {1: "S", 3: "W", 5: b"\1"})
    assert (position.latitude, position.longitude, position.altitude) == (-47.51, -8.25, -430.5)


def test_heights_rtk_and_attitude_are_read_from_drone_xmp(tmp_path):
    position = position_of(tmp_path / "a.jpg", {k: v for k, v in GOOD.items() if k != 6}, DJI)
    assert (position.altitude, position.relative_altitude) == (431.2, 50.1)
    assert (position.rtk, position.heading) == ("fixed", 14.0)
    assert (position.horizontal_sigma, position.vertical_sigma) == (0.015, 0.03)
    assert position.attitude == (12.3, -89.9, 0.5)


def test_pitch_zero_of_pix4d_looks_down(tmp_path):
    assert position_of(tmp_path / "a.jpg", GOOD, PIX4D).attitude == (10.0, -84.5, -1.0)


def test_attitudes_of_rotated_pictures_are_excluded(tmp_path):
    positions = loom.sfm.read_picture_places([write(tmp_path / "a.jpg", GOOD, DJI, orientation=6)])
    assert (positions.places[0].attitude, positions.attitudes) == (None, {})


@pytest.mark.parametrize(
    ("changed", "reason"),
    [
        ({2: (0.0, 0.0, 0.0), 4: (0.0, 0.0, 0.0)}, "its position is 0, 0, as written without a fix"),
        ({2: (97.0, 0.0, 0.0)}, "its latitude is 97 degrees"),
        ({4: (181.0, 0.0, 0.0)}, "its longitude is 181 degrees"),
        ({2: (47.0, 75.0, 0.0)}, "its latitude has invalid degrees, minutes, seconds: 47 75 0"),
        ({2: (4751.0, 0.0, 0.0)}, "its latitude is 4751 degrees"),  # degrees and minutes in one number
        ({1: ""}, "its latitude lacks N or S"),
        ({3: "N"}, "its longitude lacks E or W"),
        ({9: "V"}, "no fix"),
        ({2: (IFDRational(0, 0), 0.0, 0.0)}, "its latitude is not a number"),
        ({4: (IFDRational(8, 0), 15.0, 0.0)}, "its longitude is not a number"),
        ({4: (1e30, 0.0, 0.0)}, "its longitude is"),
        ({2: (47.0,) * 5}, "its latitude is not a number"),
    ],
)
def test_invalid_positions_are_rejected_with_a_reason(tmp_path, changed, reason):
    positions = loom.sfm.read_picture_places([write(tmp_path / "a.jpg", GOOD | changed)])
    assert len(positions) == 0
    assert reason in positions.refused["a.jpg"]
    assert positions.notes() == [f"GPS of 1 image is rejected: a.jpg ({positions.refused['a.jpg']})"]


def test_pictures_without_gps_are_neither_reported_nor_rejected(tmp_path):
    write(tmp_path / "a.png")
    write(tmp_path / "b.jpg", {6: 430.0})
    (tmp_path / "c.jpg").write_bytes(b"no picture")
    positions = loom.sfm.read_picture_places(tmp_path)
    assert (len(positions), positions.refused, positions.picture_count) == (0, {}, 3)
    with pytest.raises(ValueError, match=r"^places:"):
        _ = positions.frame


def test_a_position_on_the_other_side_of_the_earth_is_reported(tmp_path):
    for k in range(4):
        write(tmp_path / f"{k}.jpg", GOOD | {2: (47.0, 30.0, k * 0.5)})
    write(tmp_path / "wild.jpg", GOOD | {1: "S"})
    positions = loom.sfm.read_picture_places(tmp_path)
    assert len(positions) == 4
    assert "km from the median of the others" in positions.refused["wild.jpg"]


def test_positions_across_the_180th_meridian_are_centered_there(tmp_path):
    for k, (sign, minutes) in enumerate([("E", 59.999), ("E", 59.998), ("W", 59.999), ("W", 59.998)]):
        write(tmp_path / f"{k}.jpg", GOOD | {3: sign, 4: (179.0, minutes, 0.0)})
    positions = loom.sfm.read_picture_places(tmp_path)
    assert not positions.refused
    assert abs(positions.frame.longitude) > 179.99


def test_copied_pictures_keep_their_position(tmp_path):
    (tmp_path / "in").mkdir()
    for k, orientation in enumerate((1, 6)):
        write(tmp_path / "in" / f"{k}.jpg", GOOD, orientation=orientation)
    loom.sfm.choose_frames(tmp_path / "in", tmp_path / "out", kind="jpg")
    before, after = (loom.sfm.read_picture_places(tmp_path / name).places for name in ("in", "out"))
    assert before == after and len(after) == 2

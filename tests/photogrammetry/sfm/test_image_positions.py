"""What photographs tell of their place: EXIF and XMP are read strictly, and what makes no sense is named."""

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


def place_of(path, *args, **kwargs):
    (place,) = loom.sfm.read_picture_places([write(path, *args, **kwargs)]).places
    return place


def test_exif_tells_the_place_and_how_sure_it_is(tmp_path):
    place = place_of(tmp_path / "a.jpg", GOOD)
    assert (place.latitude, place.longitude, place.altitude) == (47.51, 8.25, 430.5)
    assert (place.horizontal_sigma, place.vertical_sigma, place.attitude) == (2.5, None, None)


def test_the_other_hemispheres_and_below_the_sea(tmp_path):
    place = place_of(tmp_path / "a.jpg", GOOD | {1: "S", 3: "W", 5: b"\1"})
    assert (place.latitude, place.longitude, place.altitude) == (-47.51, -8.25, -430.5)


def test_xmp_of_a_drone_tells_heights_rtk_and_how_the_camera_hung(tmp_path):
    place = place_of(tmp_path / "a.jpg", {k: v for k, v in GOOD.items() if k != 6}, DJI)
    assert (place.altitude, place.relative_altitude, place.rtk, place.heading) == (431.2, 50.1, "fixed", 14.0)
    assert (place.horizontal_sigma, place.vertical_sigma) == (0.015, 0.03)
    assert place.attitude == (12.3, -89.9, 0.5)


def test_pitch_zero_of_pix4d_looks_down(tmp_path):
    assert place_of(tmp_path / "a.jpg", GOOD, PIX4D).attitude == (10.0, -84.5, -1.0)


def test_attitudes_of_pictures_that_lie_on_their_side_are_left_out(tmp_path):
    places = loom.sfm.read_picture_places([write(tmp_path / "a.jpg", GOOD, DJI, orientation=6)])
    assert (places.places[0].attitude, places.attitudes) == (None, {})


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
def test_what_makes_no_sense_is_refused_with_the_reason(tmp_path, changed, reason):
    places = loom.sfm.read_picture_places([write(tmp_path / "a.jpg", GOOD | changed)])
    assert len(places) == 0
    assert reason in places.refused["a.jpg"]
    assert places.notes() == [f"GPS of 1 image is rejected: a.jpg ({places.refused['a.jpg']})"]


def test_pictures_that_tell_nothing_are_neither_told_nor_refused(tmp_path):
    write(tmp_path / "a.png")
    write(tmp_path / "b.jpg", {6: 430.0})
    (tmp_path / "c.jpg").write_bytes(b"no picture")
    places = loom.sfm.read_picture_places(tmp_path)
    assert (len(places), places.refused, places.picture_count) == (0, {}, 3)
    with pytest.raises(ValueError, match=r"^places:"):
        _ = places.frame


def test_a_place_on_the_other_side_of_the_earth_is_told(tmp_path):
    for k in range(4):
        write(tmp_path / f"{k}.jpg", GOOD | {2: (47.0, 30.0, k * 0.5)})
    write(tmp_path / "wild.jpg", GOOD | {1: "S"})
    places = loom.sfm.read_picture_places(tmp_path)
    assert len(places) == 4
    assert "km from the median of the others" in places.refused["wild.jpg"]


def test_a_set_over_the_180th_meridian_has_its_middle_there(tmp_path):
    for k, (sign, minutes) in enumerate([("E", 59.999), ("E", 59.998), ("W", 59.999), ("W", 59.998)]):
        write(tmp_path / f"{k}.jpg", GOOD | {3: sign, 4: (179.0, minutes, 0.0)})
    places = loom.sfm.read_picture_places(tmp_path)
    assert not places.refused
    assert abs(places.frame.longitude) > 179.99


def test_the_place_survives_the_copying_of_pictures(tmp_path):
    (tmp_path / "in").mkdir()
    for k, orientation in enumerate((1, 6)):
        write(tmp_path / "in" / f"{k}.jpg", GOOD, orientation=orientation)
    loom.sfm.choose_frames(tmp_path / "in", tmp_path / "out", kind="jpg")
    before, after = (loom.sfm.read_picture_places(tmp_path / name).places for name in ("in", "out"))
    assert before == after and len(after) == 2

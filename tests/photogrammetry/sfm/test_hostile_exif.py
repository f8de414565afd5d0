"""EXIF and XMP: positions, attitudes and focal lengths; invalid values are reported or ignored."""

import math
import sqlite3
import zlib

import numpy as np
import pytest
from PIL import Image
from PIL.TiffImagePlugin import IFDRational

import pointloom as loom
from pointloom.photogrammetry.sfm.exif_checks import focal_problem
from pointloom.photogrammetry.sfm.features import find_features
from pointloom.photogrammetry.sfm.image_folder import read_orientation
from pointloom.photogrammetry.sfm.image_positions import Xmp, parse_xmp
from pointloom.photogrammetry.sfm.settings import SfmSettings

from .conftest import has_pycolmap

SIZE = (96, 64)
INNER, GPS = 0x8769, 0x8825
FOCAL, FILM, ACROSS, UNIT, WIDTH, HEIGHT, ZOOM = 0x920A, 0xA405, 0xA20E, 0xA210, 0xA002, 0xA003, 0xA404
GPS_TAGS = {1: "N", 2: (47.0, 30.0, 36.0), 3: "E", 4: (8.0, 15.0, 0.0), 5: b"\0", 6: 430.5}
GOOD = {FOCAL: 4.25, FILM: 26, ACROSS: IFDRational(17136, 1), UNIT: 2, WIDTH: 4000, HEIGHT: 3000}  # 5.93 mm across


def shot(path, inner=None, gps=None, size=SIZE, seed=0, **more):
    """An image with these EXIF tags; `more` are those of the first table and options of Pillow."""
    path.parent.mkdir(exist_ok=True)
    exif = Image.Exif()
    exif[0x010F], exif[0x0110] = "Maker", "Phone 1"
    for tag, value in more.pop("tags", {}).items():
        exif[tag] = value
    exif.get_ifd(INNER).update(inner or {})
    exif.get_ifd(GPS).update(gps or {})
    pixels = np.random.default_rng(seed).integers(0, 256, (size[1], size[0], 3), np.uint8)
    Image.fromarray(pixels).save(path, exif=exif, quality=95, **more)
    return path


PLANE = {FOCAL: 4.25, ACROSS: 17136.0, UNIT: 2, WIDTH: 4000}
FOCAL_LENGTHS = [
    ("all of it fits", GOOD, None),
    ("no focal length", {}, None),
    ("zero", {FOCAL: 0.0, FILM: 0}, None),
    ("over zero", {FOCAL: IFDRational(425, 0)}, None),
    ("not a number", {FOCAL: IFDRational(0, 0), ACROSS: IFDRational(0, 0), WIDTH: 4000}, None),
    ("negative", {FOCAL: IFDRational(-425, 100)}, None),
    ("film alone", {FILM: 26}, None),
    ("a telephoto", {FOCAL: 300.0, FILM: 300}, None),
    ("a tenth of a meter for a millimeter", {FOCAL: 425.0, FILM: 2600}, "35 mm equivalent of 2600 mm is"),
    ("the focal length for that on film", {FOCAL: 4.25, FILM: 4}, "35 mm equivalent of 4 mm is 11 px"),
    ("film of ten times the sensor's", GOOD | {FILM: 260}, "equivalent is 693 px, but by the sensor size it is 69"),
    ("film of a whole crop too little", GOOD | {FILM: 13}, "equivalent is 35 px, but by the sensor size it is 69 px"),
    ("digital zoom", GOOD | {FILM: 78, ZOOM: 3.0}, None),
    ("centimeters for inches", PLANE | {UNIT: 5}, "the sensor would be 0.000233 mm wide"),
    ("inches for micrometers", PLANE | {ACROSS: 0.67}, "the sensor would be 1.52e+05 mm wide"),
    ("inches for centimeters beside film", GOOD | {UNIT: 3}, "equivalent is 69 px, but by the sensor size it is 175"),
    ("a sensor that is none beside film", GOOD | {UNIT: 4}, None),
    ("a unit that there is not", PLANE | {UNIT: 77}, None),
    ("no width", GOOD | {WIDTH: 0, HEIGHT: 0}, None),
    ("no width and no film", PLANE | {WIDTH: 0}, None),
    ("meters of focal length", PLANE | {FOCAL: 4250.0}, "4250 mm over a sensor of 5.93 mm"),
]


@pytest.mark.parametrize(("tags", "expected"), [case[1:] for case in FOCAL_LENGTHS], ids=[c[0] for c in FOCAL_LENGTHS])
def test_a_focal_length_that_contradicts_itself_is_rejected(tmp_path, tags, expected):
    problem = focal_problem(shot(tmp_path / "a.jpg", tags), SIZE)
    assert problem is None if expected is None else problem is not None and expected in problem


@pytest.mark.slow
@pytest.mark.skipif(not has_pycolmap(), reason="pycolmap is not installed")
def test_mapping_begins_with_no_rejected_focal_length(tmp_path):
    for k, (_, tags, _) in enumerate(FOCAL_LENGTHS):  # each has a different size, and thus its own camera
        shot(tmp_path / "in" / f"{k:02d}.jpg", tags, size=(96 + 2 * k, 64), seed=k)
    features = find_features(tmp_path / "in", tmp_path / "f.db", SfmSettings(max_features=64))
    with sqlite3.connect(tmp_path / "f.db") as database:
        query = "SELECT name, params, width, prior_focal_length FROM images JOIN cameras USING (camera_id) ORDER BY 1"
        rows = database.execute(query).fetchall()
    assert len(rows) == len(FOCAL_LENGTHS)
    for (_, tags, problem), (name, params, width, prior) in zip(FOCAL_LENGTHS, rows, strict=True):
        fraction = float(np.frombuffer(params)[0]) / width
        assert math.isfinite(fraction) and 0.2 <= fraction <= 10, (name, tags, fraction)
        if not prior:
            assert fraction == pytest.approx(0.85), (name, tags)
        assert not (prior and problem), (name, tags)
    rejected = [remark.split(":")[0] for remark in features.notes]
    problems = [k for k, (_, _, problem) in enumerate(FOCAL_LENGTHS) if problem is not None]
    assert rejected == [f"EXIF's focal length of {k:02d}.jpg is rejected" for k in problems]
    assert features.to_dict()["notes"] == list(features.notes)


@pytest.mark.parametrize("meters", [-4e8, 20_001.0])
def test_an_impossible_altitude_is_reported_and_the_position_used_without_it(tmp_path, meters):
    sign = b"\1" if meters < 0 else b"\0"
    positions = loom.photogrammetry.read_image_positions(
        [shot(tmp_path / "a.jpg", gps=GPS_TAGS | {5: sign, 6: abs(meters)})]
    )
    assert positions.places[0].altitude is None and positions.altitudes_refused == {"a.jpg": meters}
    assert positions.notes() == [f"the altitude of 1 image is rejected: a.jpg ({meters:g} m)"]
    assert positions.to_dict()["altitudes_refused"] == {"a.jpg": meters}


@pytest.mark.parametrize("value", [0, 9, b"\0\2", b"\1\1"])
def test_an_invalid_orientation_is_ignored_and_reported(tmp_path, value):
    source = tmp_path / "in"
    path = shot(source / "a.jpg", tags={0x0112: 6 if isinstance(value, bytes) else value})
    if isinstance(value, bytes):  # the type of the tag: text, bytes, a fraction, an invalid one
        data, entry = path.read_bytes(), b"\x01\x12\0\3\0\0\0\1"
        assert data.count(entry) == 1
        path.write_bytes(data.replace(entry, b"\x01\x12" + value + b"\0\0\0\1"))
    choice = loom.photogrammetry.choose_frames(source, tmp_path / "out")
    assert choice.sizes == {SIZE: 1} and read_orientation(path) == 1
    warned = any("an invalid orientation, so they are used as stored: a.jpg" in remark for remark in choice.notes)
    assert warned == (value in (9, b"\0\2"))  # Pillow does not report the others


def test_a_tag_that_points_out_of_the_file_is_a_named_error_of_the_image(tmp_path):
    source = tmp_path / "in"
    shot(source / "b.jpg")
    data = shot(source / "a.jpg", tags={0x0112: 6}).read_bytes()
    (source / "a.jpg").write_bytes(data.replace(b"\x01\x12\0\3\0\0\0\1", b"\x01\x12\0\5\0\0\0\1"))
    choice = loom.photogrammetry.choose_frames(source, tmp_path / "out")
    assert choice.names == ("b.jpg",) and choice.left_out["a.jpg"].startswith("damaged image")


def test_an_orientation_contradicting_the_exif_size_is_reported(tmp_path):
    source = tmp_path / "in"
    shot(source / "a.jpg", {WIDTH: SIZE[1], HEIGHT: SIZE[0]}, tags={0x0112: 6})  # rotated without removing the tag
    shot(source / "b.jpg", {WIDTH: SIZE[0], HEIGHT: SIZE[1]}, tags={0x0112: 6})
    xmp = b'<x:xmpmeta><rdf:Description tiff:Orientation="1"/></x:xmpmeta>'
    shot(source / "c.jpg", tags={0x0112: 6}, xmp=xmp)  # EXIF has priority
    choice = loom.photogrammetry.choose_frames(source, tmp_path / "out")
    assert choice.sizes == {SIZE[::-1]: 3}
    (remark,) = [remark for remark in choice.notes if "rotated before" in remark]
    assert remark.endswith(": a.jpg")


def test_exif_too_long_for_a_jpeg_is_left_out_and_the_image_is_not(tmp_path):
    source = tmp_path / "in"
    shot(source / "a.png", {0x927C: b"m" * 200_000}, tags={0x0112: 6})
    assert loom.photogrammetry.choose_frames(source, tmp_path / "out").names == ("a.jpg",)


XMPS = {
    "cut off": b'<x:xmpmeta><rdf:Description drone-dji:AbsoluteAltitude="+431.2" drone-dji:GimbalYawDegree="+1',
    "entities": b'<!DOCTYPE x [<!ENTITY a "9"><!ENTITY b "&a;&a;&a;">]><x drone-dji:RelativeAltitude="&b;"/>',
    "zeros": b"\0" * 1000,
    "no text": bytes(range(256)) * 4,
    "infinite": b'<x drone-dji:AbsoluteAltitude="1e999" drone-dji:RelativeAltitude="nan"/>',
    "degrees": b'<x Camera:Yaw="1e9" Camera:Pitch="0" Camera:Roll="0"/>',
}


@pytest.mark.parametrize("name", XMPS)
def test_invalid_xmp_is_ignored(tmp_path, name):
    path = shot(tmp_path / "a.jpg", gps={k: v for k, v in GPS_TAGS.items() if k != 6}, xmp=XMPS[name])
    positions = loom.photogrammetry.read_image_positions([path])
    assert len(positions) == 1 and not positions.refused and positions.attitudes == {}
    assert positions.places[0].altitude == (431.2 if name == "cut off" else None)


def test_xmp_of_megabytes_is_parsed():
    """A search that is quadratic in a megabyte takes hours."""
    for filler in (b"Camera:" + b"a" * 50, b"drone-dji:A    ", b'Camera:Yaw="', b"<" * 20):
        assert parse_xmp(filler * (30_000_000 // len(filler))).attitude is None
    assert parse_xmp(b"drone-dji:" + b"a" * 20_000_000) == Xmp()


def test_a_decompression_bomb_in_xmp_is_never_unpacked_completely(tmp_path):
    """A PNG whose XMP unpacks to 64 MB."""
    source = tmp_path / "in"
    shot(source / "b.png")
    data = shot(source / "a.png").read_bytes()
    squeezer = zlib.compressobj(9)
    bomb = b"".join(squeezer.compress(bytes(1 << 20)) for _ in range(64)) + squeezer.flush()
    body = b"XML:com.adobe.xmp\0\1\0\0\0" + bomb
    chunk = len(body).to_bytes(4, "big") + b"iTXt" + body + zlib.crc32(b"iTXt" + body).to_bytes(4, "big")
    (source / "a.png").write_bytes(data[:33] + chunk + data[33:])
    positions = loom.photogrammetry.read_image_positions(source)
    assert len(positions) == 0 and positions.image_count == 2
    choice = loom.photogrammetry.choose_frames(source, tmp_path / "out")
    assert "b.png" in choice.names and (("a.png" in choice.names) != ("a.png" in choice.left_out))


POSITION_TAGS = GPS_TAGS | {31: 2.5}
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
    (position,) = loom.photogrammetry.read_image_positions([write(path, *args, **kwargs)]).places
    return position


def test_position_and_accuracy_are_read_from_exif(tmp_path):
    position = position_of(tmp_path / "a.jpg", POSITION_TAGS)
    assert (position.latitude, position.longitude, position.altitude) == (47.51, 8.25, 430.5)
    assert (position.horizontal_sigma, position.vertical_sigma, position.attitude) == (2.5, None, None)
    position = position_of(tmp_path / "b.jpg", POSITION_TAGS | {1: "S", 3: "W", 5: b"\1"})
    assert (position.latitude, position.longitude, position.altitude) == (-47.51, -8.25, -430.5)


def test_heights_rtk_and_attitude_are_read_from_drone_xmp(tmp_path):
    position = position_of(tmp_path / "a.jpg", {k: v for k, v in POSITION_TAGS.items() if k != 6}, DJI)
    assert (position.altitude, position.relative_altitude) == (431.2, 50.1)
    assert (position.rtk, position.heading) == ("fixed", 14.0)
    assert (position.horizontal_sigma, position.vertical_sigma) == (0.015, 0.03)
    assert position.attitude == (12.3, -89.9, 0.5)
    assert position_of(tmp_path / "b.jpg", POSITION_TAGS, PIX4D).attitude == (10.0, -84.5, -1.0)  # pitch 0 looks down


def test_attitudes_of_rotated_images_are_excluded(tmp_path):
    positions = loom.photogrammetry.read_image_positions([write(tmp_path / "a.jpg", POSITION_TAGS, DJI, orientation=6)])
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
    positions = loom.photogrammetry.read_image_positions([write(tmp_path / "a.jpg", POSITION_TAGS | changed)])
    assert len(positions) == 0
    assert reason in positions.refused["a.jpg"]
    assert positions.notes() == [f"GPS of 1 image is rejected: a.jpg ({positions.refused['a.jpg']})"]


def test_images_without_gps_are_neither_reported_nor_rejected(tmp_path):
    write(tmp_path / "a.png")
    write(tmp_path / "b.jpg", {6: 430.0})
    (tmp_path / "c.jpg").write_bytes(b"no image")
    positions = loom.photogrammetry.read_image_positions(tmp_path)
    assert (len(positions), positions.refused, positions.image_count) == (0, {}, 3)
    with pytest.raises(ValueError, match=r"^places:"):
        _ = positions.frame


def test_a_position_on_the_other_side_of_the_earth_is_reported(tmp_path):
    for k in range(4):
        write(tmp_path / f"{k}.jpg", POSITION_TAGS | {2: (47.0, 30.0, k * 0.5)})
    write(tmp_path / "wild.jpg", POSITION_TAGS | {1: "S"})
    positions = loom.photogrammetry.read_image_positions(tmp_path)
    assert len(positions) == 4
    assert "km from the median of the others" in positions.refused["wild.jpg"]


def test_positions_across_the_180th_meridian_are_centered_there(tmp_path):
    for k, (sign, minutes) in enumerate([("E", 59.999), ("E", 59.998), ("W", 59.999), ("W", 59.998)]):
        write(tmp_path / f"{k}.jpg", POSITION_TAGS | {3: sign, 4: (179.0, minutes, 0.0)})
    positions = loom.photogrammetry.read_image_positions(tmp_path)
    assert not positions.refused
    assert abs(positions.frame.longitude) > 179.99


def test_copied_images_keep_their_position(tmp_path):
    (tmp_path / "in").mkdir()
    for k, orientation in enumerate((1, 6)):
        write(tmp_path / "in" / f"{k}.jpg", POSITION_TAGS, orientation=orientation)
    loom.photogrammetry.choose_frames(tmp_path / "in", tmp_path / "out", kind="jpg")
    before, after = (loom.photogrammetry.read_image_positions(tmp_path / name).places for name in ("in", "out"))
    assert before == after and len(after) == 2

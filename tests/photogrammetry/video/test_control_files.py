"""Files of ground control: ODM's list, CSV, scale bars; invalid contents are rejected with their line."""

import numpy as np
import pytest

from pointloom.core.errors import FileError
from pointloom.photogrammetry.video.control_files import read_ground_control
from pointloom.photogrammetry.video.control_systems import to_geodetic, utm_code
from pointloom.photogrammetry.video.ground_control import ScaleBar
from pointloom.photogrammetry.video.units import Units

ODM = """WGS84 UTM 32N
447000.0 5260000.0 410.0 320 240 a.jpg A
447000.0 5260000.0 410.0 100 240.5 b.jpg A
# a comment

447040.0 5260010.0 411.5 12 14 a.jpg CHK-1
447040.0 5260010.0 411.5 13 15 b.jpg CHK-1
bar A CHK-1 41.2 0.01
"""
CSV = """# crs: EPSG:25832
name,x,y,z,sigma,sigma_z,use,picture,column,row
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
    assert (control.crs, control.checks, control.marks[2].picture) == ("EPSG:25832", ("Mill 2",), "a, b.jpg")
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
    alone = "name,picture,column,row\nP,a.jpg,5,6\nP,b.jpg,6,7\nQ,a.jpg,5,6\nQ,b.jpg,7,7\nbar,P,Q,1.5\n"
    assert Units(scale_bars=written(alone, "bars.csv")).ground.bars[0].meters == 1.5
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
        (CSV.replace("name,x", "point,x"), "no coordinate system|line"),
        (CSV.replace("picture,column,row", "picture,row"), r"line 2\): the header lacks column"),
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
        Units(control=tmp_path / "none.txt")
    (tmp_path / "gcp.bin").write_bytes(b"\xff\xfe\x00\x01")
    with pytest.raises(FileError, match=r"/gcp\.bin:.*UTF-8"):
        Units(control=tmp_path / "gcp.bin")
    path = written(ODM.replace("bar A", "# "))
    with pytest.raises(FileError, match=r"gcp\.txt"):
        Units(control=path)
    with pytest.raises(ValueError, match="control:"):
        Units(control=path, scale=2.0)
    with pytest.raises(ValueError, match=r"^path:"):
        read_ground_control(None)


ZONES = {
    "WGS84 UTM 32N": 32632,
    "EPSG:25832": 32632,
    "wgs84 utm zone 19s": 32719,
    "+proj=utm +zone=23 +south +ellps=GRS80 +units=m +no_defs": 32723,
    "EPSG:31467": None,
    "WGS84 UTM 61N": None,
}


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

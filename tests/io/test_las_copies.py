"""LAS to LAS: missing values, extra dimensions, records and the identification of a file are preserved."""

import struct
from datetime import date

import laspy
import numpy as np
import pytest

import pointloom as loom
from pointloom.io.meshes.tables import read_table, write_cloud_table
from pointloom.io.points.las import open_las

from .las_files import edited

NAN = np.nan
# Name, type, other fields of the record, stored numbers, their meaning and its type.
DIMENSIONS = [
    ("height", "i2", {"scales": [0.01], "offsets": [1.0], "no_data": [-9999]}, [100, -9999], [2.0, NAN], "f8"),
    ("pulse", "u1", {"no_data": [255]}, [255, 3], [NAN, 3], "f4"),
    ("wide", "i4", {"no_data": [0]}, [0, 2**31 - 1], [NAN, 2**31 - 1], "f8"),
    ("echo", "f4", {"no_data": [-99.99]}, [-99.99, 0.5], [NAN, 0.5], "f4"),
    ("plain", "u2", {"description": "counts"}, [0, 65535], [0, 65535], "u2"),
    ("triple", "3i2", {"no_data": [0, 1, 2]}, [[0, 1, 2], [5, 6, 7]], [[NAN] * 3, [5, 6, 7]], "f4"),
]
FIELDS = ("data_type", "options", "no_data", "min", "max", "scale", "offset", "description")


def header_of(version="1.4", point_format=6):
    header = laspy.LasHeader(point_format=point_format, version=version)
    header.scales = [0.001] * 3
    return header


def described(path):
    """The record of extra bytes by name, its numbers as lists."""
    structs = laspy.read(path).vlrs.get("ExtraBytesVlr")[0].extra_bytes_structs
    return {s.format_name(): [_plain(getattr(s, field)) for field in FIELDS] for s in structs}


def _plain(value):
    return value if value is None or isinstance(value, (int, bytes)) else [*np.asarray(value).tolist()]


def write_dimensions(path, dimensions=DIMENSIONS):
    header = header_of()
    header.add_extra_dims([laspy.ExtraBytesParams(name, kind, **more) for name, kind, more, *_ in dimensions])
    las = laspy.LasData(header)
    las.x = las.y = las.z = np.arange(2.0)
    for name, _, _, stored, *_ in dimensions:
        las.points.array[name] = stored
    las.write(path)


@pytest.mark.parametrize("suffix", [".las", ".laz"])
def test_a_stored_no_data_value_is_read_as_nan(suffix, tmp_path):
    write_dimensions(tmp_path / f"a{suffix}")
    cloud = loom.read_point_cloud(tmp_path / f"a{suffix}")
    (part,) = loom.read_las_chunks(tmp_path / f"a{suffix}")
    for name, _, _, _, values, kind in DIMENSIONS:
        np.testing.assert_array_equal(cloud[name], np.array(values, kind), err_msg=name)
        assert cloud[name].dtype == part[name].dtype == kind
        np.testing.assert_array_equal(part[name], cloud[name])


def test_unrepresentable_no_data_value_stays_with_a_warning(tmp_path):
    write_dimensions(tmp_path / "a.las", [("id", "i8", {"no_data": [-7]}, [-7, 2**60 + 1])])
    with pytest.warns(UserWarning, match=r"/a\.las:.*7"):
        cloud = loom.read_point_cloud(tmp_path / "a.las")
    assert cloud["id"].tolist() == [-7, 2**60 + 1]


@pytest.mark.parametrize("name", ["b.las", "b.laz", "b.copc.laz"])
def test_a_copy_stores_extra_dimensions_as_its_source(name, tmp_path):
    write_dimensions(tmp_path / "a.las", DIMENSIONS[:-1])
    cloud = loom.read_point_cloud(tmp_path / "a.las")
    loom.write_point_cloud(tmp_path / name, cloud, like=tmp_path / "a.las")
    before, after = laspy.read(tmp_path / "a.las").points.array, laspy.read(tmp_path / name).points.array
    for dimension, *_ in DIMENSIONS[:-1]:
        assert before[dimension].tolist() == after[dimension].tolist()
    dimensions = described(tmp_path / name)
    assert dimensions["height"] == [4, 31, [-9999], [2.0], [2.0], [0.01], [1.0], b""]
    assert dimensions["pulse"] == [1, 7, [255], [3], [3], None, None, b""]
    assert dimensions["plain"] == [3, 6, None, [0], [65535], None, None, b"counts"]
    copied = loom.read_point_cloud(tmp_path / name)
    for dimension, *_ in DIMENSIONS[:-1]:
        np.testing.assert_array_equal(copied[dimension], cloud[dimension])


def test_values_that_the_source_s_form_would_change_are_stored_in_their_own_type(tmp_path):
    for name, values in (
        ("height", [2.005, NAN]),  # between two steps
        ("height", [1e9, NAN]),  # beyond 16 bits
        ("height", [-98.99, NAN]),  # the step that represents a missing value
        ("pulse", np.array([255, 3], np.uint8)),  # now a valid value
        ("plain", [NAN, 3]),  # missing, but the source defines no value for it
    ):
        write_dimensions(tmp_path / "a.las")
        cloud = loom.read_point_cloud(tmp_path / "a.las")
        cloud[name] = np.asarray(values)
        loom.write_point_cloud(tmp_path / "b.las", cloud, like=tmp_path / "a.las")
        np.testing.assert_array_equal(loom.read_point_cloud(tmp_path / "b.las")[name], values)


def test_ranges_cover_all_points(tmp_path):
    cloud = loom.PointCloud(np.zeros((4, 3)), a=np.array([3.0, NAN, -2.0, 5.0]), b=np.full(4, NAN))
    for name in ("a.las", "a.copc.laz"):
        loom.write_point_cloud(tmp_path / name, cloud)
        assert described(tmp_path / name)["a"][3:5] == [[-2.0], [5.0]]
        assert described(tmp_path / name)["b"][3:5] == [None, None]


def test_dimensions_of_untyped_bytes_metashapes_normals_and_names_in_latin_1_are_read(tmp_path):
    normals = [(f"normal {axis}", "f4", {}, [0, axis == "z"]) for axis in "xyz"]
    write_dimensions(tmp_path / "a.las", [("above", "9u1", {}, [range(9), range(9, 18)]), *normals])
    begin = 375 + 54
    edited(tmp_path / "a.las", (begin + 4, "32s", "H\xf6he".encode("latin-1")), (begin + 160, "32s", b"\xfcber Grund"))
    cloud = loom.read_point_cloud(tmp_path / "a.las")
    assert cloud["Höhe"].tolist() == [[*range(9)], [*range(9, 18)]] and cloud.normals.tolist() == [[0, 0, 0], [0, 0, 1]]


def write_identified(path, *, version="1.4", point_format=6):
    header = header_of(version, point_format)
    header.file_source_id, header.system_identifier, header.generating_software = 77, "SENSOR X", "FLIGHT 3"
    header.creation_date = date(2019, 12, 31)
    header.global_encoding.value |= 1 | 8
    header.vlrs.append(laspy.VLR("mine", 7, "calibration", b"abc"))
    las = laspy.LasData(header)
    las.x = las.y = las.z = np.arange(3.0)
    if version == "1.4":
        las.evlrs = laspy.vlrs.vlrlist.VLRList([laspy.VLR("mine2", 8, "log", bytes(70_000))])
    las.write(path)


@pytest.mark.parametrize("version", ["1.2", "1.4"])
@pytest.mark.parametrize("name", ["b.las", "b.laz", "b.copc.laz"])
def test_a_copy_keeps_records_and_identification(name, version, tmp_path):
    write_identified(tmp_path / "a.las", version=version, point_format=6 if version == "1.4" else 1)
    assert write_cloud_table(tmp_path / name, read_table(tmp_path / "a.las"), source=tmp_path / "a.las") == []
    las = laspy.read(tmp_path / name)
    header = las.header
    identification = (header.file_source_id, header.system_identifier, header.generating_software, header.creation_date)
    assert identification == (77, "SENSOR X", "FLIGHT 3", date(2019, 12, 31)) and header.global_encoding.value & 9 == 9
    (record,) = las.vlrs.get_by_id("mine")
    assert (record.record_id, record.description, record.record_data) == (7, "calibration", b"abc")
    extended = [(r.user_id, r.description, len(r.record_data)) for r in las.evlrs or [] if r.user_id == "mine2"]
    assert extended == ([("mine2", "log", 70_000)] if version == "1.4" else [])


def test_points_of_another_file_take_the_system_alone(tmp_path):
    write_identified(tmp_path / "a.las")
    write_cloud_table(tmp_path / "b.las", read_table(tmp_path / "a.las"), source=tmp_path / "a.las", system_only=True)
    header = open_las(tmp_path / "b.las").header
    assert (header.source_id, header.system == "SENSOR X", header.find("mine", 7)) == (0, False, None)
    assert header.scales == (0.001, 0.001, 0.001)


def test_waveforms_and_spatial_indexes_are_left_out_with_a_warning(tmp_path):
    write_identified(tmp_path / "a.las")
    size = (tmp_path / "a.las").stat().st_size
    for user, number, text in ((b"LASF_Spec", 65535, "waveforms"), (b"LAStools", 30, "LAStools 30")):
        record = struct.pack("<H16sHQ32s", 0, user, number, 4, b"") + b"abcd"
        (tmp_path / "b.las").write_bytes((tmp_path / "a.las").read_bytes() + record)
        edited(tmp_path / "b.las", (235, "<QI", size, 1))
        with pytest.warns(UserWarning, match=text):
            cloud = loom.read_point_cloud(tmp_path / "b.las")
            loom.write_point_cloud(tmp_path / "c.las", cloud, like=tmp_path / "b.las")
        assert open_las(tmp_path / "c.las").header.find(user.decode(), number) is None


def test_full_32_bit_range_is_copied(tmp_path):
    las = laspy.LasData(header_of())
    las.points.array.resize(2)
    for axis, name in enumerate("XYZ"):
        las.points.array[name] = [-(2**31), 2**31 - 1 - axis]
    las.write(tmp_path / "a.las")
    write_cloud_table(tmp_path / "b.las", read_table(tmp_path / "a.las"), source=tmp_path / "a.las")
    before, after = laspy.read(tmp_path / "a.las").points.array, laspy.read(tmp_path / "b.las").points.array
    assert [before[name].tolist() for name in "XYZ"] == [after[name].tolist() for name in "XYZ"]
    cloud = loom.read_point_cloud(tmp_path / "a.las")  # in float32, which rounds to 0.25 m here
    loom.write_point_cloud(tmp_path / "b.las", cloud, like=tmp_path / "a.las")
    np.testing.assert_allclose(laspy.read(tmp_path / "b.las").xyz, cloud.points, rtol=0, atol=0.25)

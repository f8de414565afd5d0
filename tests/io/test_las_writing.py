"""Writing LAS, LAZ and COPC: attributes, systems, octrees, and copies that preserve what their source stores."""

import struct
from contextlib import nullcontext
from datetime import date

import laspy
import lazrs
import numpy as np
import pyproj
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from laspy.copc import Bounds, CopcReader

import pointloom as loom
from pointloom.cli.jobs.info import describe
from pointloom.io.meshes.tables import read_table, write_cloud_table
from pointloom.io.points import copc_writer
from pointloom.io.points.copc import COPC_ENTRY, COPC_HIERARCHY, open_copc
from pointloom.io.points.copc_writer import write_copc
from pointloom.io.points.las import open_las, read_las
from pointloom.io.points.las_crs import crs_name, find_keys, find_text
from pointloom.io.points.las_units import units_of
from pointloom.io.points.las_wkt import LostSystemWarning
from pointloom.io.points.las_writer import write_las
from pointloom.io.table import PointTable

from .las_files import edited, make

OF_ALL_INTEGERS = pytest.mark.filterwarnings("ignore:.*rounded to float32:pointloom.core.units.UnitWarning")


@st.composite
def tables(draw):
    count = draw(st.integers(0, 9))
    rng = np.random.default_rng(draw(st.integers(0, 2**32)))
    middle = np.array(draw(st.sampled_from([(0, 0, 0), (5e5, 5.4e6, -20), (-3.25, 1e7, 0)])))
    points = rng.normal(size=(count, 3)) * draw(st.sampled_from([0, 1, 1e4])) + middle
    attributes = {
        "intensity": rng.integers(0, 65536, count).astype(np.uint16),
        "classification": rng.integers(0, 256, count).astype(np.uint8),
        "withheld": rng.integers(0, 2, count).astype(np.uint8),
        "scan_angle": rng.integers(-30_000, 30_001, count).astype(np.int16),
        "gps_time": rng.normal(size=count) * 1e8,
        "label": rng.integers(-(2**62), 2**62, count),
        "reflectance": rng.normal(size=count).astype(np.float32),
    }
    chosen = draw(st.sets(st.sampled_from(sorted(attributes))))
    colors = rng.integers(0, 65536, (count, 3)) / 65535 if draw(st.booleans()) else None
    normals = rng.normal(size=(count, 3)).astype(np.float32) if draw(st.booleans()) else None
    return PointTable(points, normals, colors, {name: attributes[name] for name in sorted(chosen)})


@pytest.mark.parametrize("suffix", [".las", ".laz"])
@settings(max_examples=25, derandomize=True, deadline=None, database=None)
@given(table=tables())
def test_round_trip(suffix, tmp_path_factory, table):
    path = tmp_path_factory.getbasetemp() / f"round{suffix}"
    write_las(path, table)
    result = read_las(path)
    np.testing.assert_allclose(result.points, table.points, rtol=0, atol=0.0005 * (1 + 1e-5))
    for name, values in table.attributes.items():
        assert result.attributes[name].dtype == values.dtype
        np.testing.assert_array_equal(result.attributes[name], values)
    assert (result.normals is None) == (table.normals is None)
    if table.normals is not None:
        np.testing.assert_array_equal(result.normals, table.normals)
    if table.colors is not None and table.colors.max(initial=1) > 255 / 65535:
        np.testing.assert_allclose(result.colors, table.colors, rtol=0, atol=1e-7)


def test_written_file_is_valid_for_laspy(tmp_path, rng):
    points, colors = rng.random((100, 3)) * 50 + [5e5, 5.4e6, 200], rng.random((100, 3))
    cloud = loom.PointCloud(points, colors=colors, classification=np.full(100, 6), ring=np.arange(100, dtype=np.uint16))
    for name in ("a.las", "a.laz"):
        loom.write_point_cloud(tmp_path / name, cloud, scale=0.01)
        las = laspy.read(tmp_path / name)
        assert str(las.header.version) == "1.4" and las.header.point_format.id == 7
        np.testing.assert_array_equal(las.header.offsets, cloud.origin)
        np.testing.assert_allclose(las.xyz, points, rtol=0, atol=0.0051)
        np.testing.assert_allclose(las.header.mins, las.xyz.min(axis=0), rtol=0, atol=1e-9)
        np.testing.assert_allclose(las.red, colors[:, 0] * 65535, rtol=0, atol=0.6)
        assert (np.asarray(las.classification) == 6).all()
        np.testing.assert_array_equal(las["ring"], np.arange(100))


@pytest.mark.parametrize("suffix", [".las", ".laz"])
def test_a_file_without_points_survives(suffix, tmp_path):
    loom.write_point_cloud(tmp_path / f"a{suffix}", loom.PointCloud(colors=np.empty((0, 3))))
    result = loom.read_point_cloud(tmp_path / f"a{suffix}")
    assert len(result) == 0 and result.has_colors and list(loom.read_las_chunks(tmp_path / f"a{suffix}")) == []


def test_attribute_unsupported_by_las_is_named(tmp_path):
    for attribute, reason in (
        ({"classification": np.array([-1, 0])}, "contains -1"),
        ({"intensity": np.zeros((2, 2))}, "2 components"),
        ({"half": np.zeros(2, np.float16)}, "type float16"),
        ({"n" * 33: np.zeros(2)}, "32 bytes"),
        ({"a": np.zeros((2, 2)), "a_1": np.zeros(2)}, "something else"),
    ):
        with pytest.raises(loom.FileError, match=f"attribute '{next(iter(attribute))[0]}.*{reason}"):
            write_las(tmp_path / "a.las", PointTable(np.zeros((2, 3)), attributes=attribute))
    assert list(tmp_path.iterdir()) == []


def test_integers_of_any_type_go_to_the_standard_dimensions(tmp_path):
    attributes = {"intensity": np.array([1.0, 65535.0]), "withheld": np.array([True, False])}
    write_las(tmp_path / "a.las", PointTable(np.zeros((2, 3)), attributes=attributes))
    result = read_las(tmp_path / "a.las").attributes
    assert result["intensity"].tolist() == [1, 65535] and result["withheld"].tolist() == [1, 0]


def test_coordinates_beyond_32_bits_are_an_error_that_names_a_scale(tmp_path):
    table = PointTable(np.array([[0.0, 0, 0], [1e7, 0, 0]]))
    with pytest.raises(loom.FileError, match=r"/a\.las:.*2.*31.*0\.01") as caught:
        write_las(tmp_path / "a.las", table)
    assert list(tmp_path.iterdir()) == [] and "offset" in str(caught.value)
    write_las(tmp_path / "a.las", table, scale=0.01)
    np.testing.assert_allclose(read_las(tmp_path / "a.las").points, table.points, rtol=0, atol=0.005)


def test_clouds_unsupported_by_las_are_rejected(tmp_path):
    with pytest.raises(loom.FileError, match=r"/a\.las:.*1"):
        loom.write_point_cloud(tmp_path / "a.las", loom.PointCloud([[0, 0, 0], [np.nan, 0, 0]]))
    for scale in (0, -1, np.nan, [1, 2]):
        with pytest.raises(ValueError, match="scale"):
            write_las(tmp_path / "a.las", PointTable(np.zeros((2, 3))), scale=scale)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("standard", [True, False])
def test_file_written_like_another_has_its_gps_time_type(tmp_path, rng, standard):
    """Bit 0 of the global encoding: GPS time less 1e9 s, or seconds of the week."""
    kind = laspy.header.GpsTimeType.STANDARD if standard else laspy.header.GpsTimeType.WEEK_TIME
    for point_format in (1, 6):
        make(tmp_path / "a.las", point_format, 3, rng)
        encoding = open_las(tmp_path / "a.las").header.encoding
        edited(tmp_path / "a.las", (6, "<H", encoding & ~1 | standard))
        write_las(tmp_path / "b.las", read_las(tmp_path / "a.las"), like=open_las(tmp_path / "a.las").header)
        with laspy.open(tmp_path / "b.las") as written:
            assert written.header.global_encoding.gps_time_type == kind
        (tmp_path / "b.las").unlink()


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
    with pytest.warns(loom.UnitWarning, match=r"a\.las: points far from .* in steps of up to 0\.25"):
        cloud = loom.read_point_cloud(tmp_path / "a.las")
    with pytest.warns(loom.UnitWarning, match=r"b\.las: points far from .* in steps of up to 0\.25"):
        loom.write_point_cloud(tmp_path / "b.las", cloud, like=tmp_path / "a.las")
    np.testing.assert_allclose(laspy.read(tmp_path / "b.las").xyz, cloud.points, rtol=0, atol=0.25)


def with_keys(path, *keys, version="1.2"):
    """A file whose coordinate system is defined by GeoTIFF keys (key, value)."""
    header = laspy.LasHeader(point_format=1, version=version)
    header.scales, header.offsets = [0.01] * 3, [500_000, 4_000_000, 0]
    numbers = [1, 1, 0, len(keys), *(number for key, value in keys for number in (key, 0, 1, value))]
    header.vlrs.append(laspy.VLR("LASF_Projection", 34735, "", struct.pack(f"<{len(numbers)}H", *numbers)))
    las = laspy.LasData(header)
    las.x, las.y, las.z = (np.random.default_rng(0).random((300, 3)) * 40 + header.offsets).T
    las.write(path)
    return path


@pytest.mark.parametrize(
    ("keys", "code"),
    [
        ([(1024, 1), (3072, 26910), (3076, 9001)], 26910),
        ([(1024, 1), (3072, 25832)], 25832),
        ([(1024, 1), (3072, 2994), (3076, 9002)], 2994),
        ([(1024, 1), (3072, 25832), (4096, 5783)], 25832),
    ],
)
@pytest.mark.parametrize("name", ["b.copc.laz", "b.laz"])
def test_systems_of_the_register_become_text(tmp_path, keys, code, name):
    path = with_keys(tmp_path / "a.laz", *keys)
    if name == "b.copc.laz":
        loom.write_point_cloud(tmp_path / name, loom.read_point_cloud(path), like=path)
    else:
        loom.tiling.plan_tiles(path, [{"step": "thin", "spacing": 0.1}], tmp_path / "job")
        loom.tiling.run_tiles(tmp_path / "job")
        loom.tiling.finish_tiles(tmp_path / "job", tmp_path / name)
    header = open_las(tmp_path / name).header
    system = pyproj.CRS.from_wkt(find_text(header))
    parts = system.sub_crs_list or [system]
    assert pyproj.CRS.from_epsg(code).equals(parts[0], ignore_axis_order=True)
    assert header.encoding & 16 and not find_keys(header)
    assert units_of(open_las(path).header).plane in (None, units_of(header).plane)
    assert (len(parts) == 2) == (keys[-1][0] == 4096)


@pytest.mark.filterwarnings("ignore::pointloom.UnitWarning")
@pytest.mark.parametrize(
    ("keys", "reason"),
    [
        ([(1024, 1), (3072, 32767), (2048, 4326)], "the EPSG register does not name"),
        ([(1024, 1), (3072, 30000)], "pyproj does not contain EPSG:30000"),
        ([(1024, 1), (3072, 25832), (3076, 9002)], "its keys declare foot, but EPSG:25832 uses metre"),
        ([(1024, 1), (3072, 26910), (4096, 5703), (4099, 9003)], "heights in US survey foot, but EPSG:5703"),
        ([(1024, 1), (3072, 26910), (3076, 9001), (4099, 9003)], "without a height system"),
        ([(1024, 1), (3072, 26910), (4096, 32767)], "heights that the EPSG register does not name"),
        ([(1024, 1), (3072, 26910), (4096, 5103)], "EPSG:5103"),
    ],
)
def test_system_without_text_warns_and_keeps_its_keys(tmp_path, keys, reason):
    path = with_keys(tmp_path / "a.laz", *keys)
    cloud = loom.read_point_cloud(path)
    with pytest.warns(LostSystemWarning, match=reason):
        loom.write_point_cloud(tmp_path / "b.copc.laz", cloud, like=path)
    assert find_keys(open_las(tmp_path / "b.copc.laz").header) == find_keys(open_las(path).header)


def test_old_formats_keep_keys(tmp_path):
    path = with_keys(tmp_path / "a.laz", (1024, 1), (3072, 25832))
    loom.write_point_cloud(tmp_path / "b.laz", loom.read_point_cloud(path), like=path)
    header = open_las(tmp_path / "b.laz").header
    assert header.point_format < 6 and crs_name(header) == "EPSG:25832" and not find_text(header)


INFO_AT = 375 + 54  # the first record's bytes according to the specification


def survey(rng, count=12_000, at=(6.3e5, 8.5e6, 120.0)):
    """A hilly surface with all attributes of a scanner."""
    xy = rng.random((count, 2)) ** 3 * (400, 250)  # denser toward a corner, where the octree is deep
    z = 8 * np.sin(xy[:, 0] / 40) + rng.normal(size=count)
    points = np.column_stack([xy, z]) + at
    attributes = {
        "intensity": rng.integers(0, 65536, count).astype(np.uint16),
        "gps_time": np.sort(rng.random(count)) * 1e3 + 2e8,
        "return_number": rng.integers(1, 4, count).astype(np.uint8),
        "number_of_returns": np.full(count, 3, np.uint8),
        "height": rng.random(count).astype(np.float32),
    }
    return PointTable(points, None, (rng.integers(0, 65536, (count, 3)) / 65535).astype(np.float32), attributes)


@pytest.fixture(scope="module")
def table():
    return survey(np.random.default_rng(5))


@pytest.fixture
def small_nodes(monkeypatch):
    monkeypatch.setattr(copc_writer, "_MIN_NODE_POINTS", 200)


@pytest.fixture
def path(table, tmp_path, small_nodes):
    write_copc(tmp_path / "a.copc.laz", table)
    return tmp_path / "a.copc.laz"


def in_order(table):
    """Rows of all columns of a table, independent of the order of its points."""
    columns = [table.points, table.colors, *(table.attributes[name] for name in sorted(table.attributes))]
    rows = np.column_stack([np.asarray(column, np.float64).reshape(len(table.points), -1) for column in columns])
    return rows[np.lexsort(rows.T)]


def selected_rows(table, keep):
    attributes = {name: values[keep] for name, values in table.attributes.items()}
    return PointTable(table.points[keep], None, table.colors[keep], attributes)


def entries_of(path):
    with laspy.open(path) as file:
        (hierarchy,) = (record for record in file.evlrs if record.user_id == COPC_HIERARCHY[0])
    entries = np.frombuffer(hierarchy.bytes, COPC_ENTRY)
    return entries[entries["count"] >= 0]


def test_laspy_reads_all_points_windows_and_levels(table, path):
    low, high = np.array([6.30005e5, 8.500002e6, 0]), np.array([6.3002e5, 8.50009e6, 500])
    stored = read_las(path).points
    with CopcReader.open(str(path)) as reader:
        assert reader.header.point_count == len(reader.query()) == len(table.points)
        inside = ((stored >= low) & (stored <= high)).all(axis=1).sum()
        assert 0 < len(reader.query(bounds=Bounds(low, high))) == inside < len(stored)
        for level in range(4):
            points = reader.query(level=range(level + 1))
            spacing = reader.copc_info.spacing / 2**level
            assert len(points) == len(loom.read_copc(path, spacing=spacing))


def test_window_equals_a_crop_of_the_full_cloud(path, device):
    low, high = np.array([6.301e5, 8.50005e6, 0]), np.array([6.302e5, 8.5e7, 500])
    full = read_las(path)
    inside = ((full.points >= low) & (full.points <= high)).all(axis=1)
    np.testing.assert_array_equal(in_order(open_copc(path).read(low, high)), in_order(selected_rows(full, inside)))
    cloud = loom.read_copc(path, within=loom.AxisAlignedBoundingBox(low, high), device=device)
    assert 0 < len(cloud) == inside.sum() < len(inside) and cloud.device == device


def test_window_decompresses_only_intersecting_chunks(path, monkeypatch):
    read, unpack = [], lazrs.decompress_points_with_chunk_table

    def record_call(chunks, record, out, chunk_table):
        read.append(chunk_table)
        unpack(chunks, record, out, chunk_table)

    monkeypatch.setattr(lazrs, "decompress_points_with_chunk_table", record_call)
    file = open_copc(path)
    read.clear()
    file.read(file.corner, file.corner + np.array([10, 10, 1e3]))
    assert 0 < len(read[0]) < len(file.nodes) / 2


def test_coarse_levels_have_the_requested_spacing(path):
    file = open_copc(path)
    for level in range(4):
        spacing = file.spacing / 2**level
        clouds = file.read(spacing=spacing), file.read()
        cells = [(cloud.points - file.corner) // spacing for cloud in clouds]
        occupied, every = (np.unique(np.minimum(cell, 2.0 ** (7 + level) - 1), axis=0) for cell in cells)
        assert len(occupied) == len(every) and file.nodes["level"][file.nodes_within(spacing=spacing)].max() == level
    assert len(file.read(spacing=1e9).points) == file.nodes["count"][file.nodes["level"] == 0].sum()


def test_octree_follows_the_specification(table, path):
    """COPC 1.0: the octree's record is the first, formats 6 to 8, each point is in its node's cube, all ancestors of a
    node are listed, counts and chunks add up.
    """
    raw, file = path.read_bytes(), open_copc(path)
    assert raw[377:393].rstrip(b"\0") == b"copc" and struct.unpack_from("<H", raw, 393) == (1,)
    assert open_las(path).header.point_format in (6, 7, 8) and open_las(path).header.encoding & 16
    assert file.times == (table.attributes["gps_time"].min(), table.attributes["gps_time"].max())
    entries = entries_of(path)
    keys = {(level, *cell) for level, cell in entries[["level", "cell"]].tolist()}
    assert len(keys) == len(entries) and (0, 0, 0, 0) in keys
    assert all((level - 1, x >> 1, y >> 1, z >> 1) in keys for level, x, y, z in keys if level)
    assert entries["count"].sum() == len(table.points) and len(file.nodes) == (entries["count"] > 0).sum()
    row = file.file.layout.dtype()
    for k, node in enumerate(file.nodes):
        points = file.file.decode(np.frombuffer(file.unpack(np.array([k])), row))["points"]
        width = file.side / 2.0 ** node["level"]
        low = file.corner + node["cell"] * width
        assert len(points) == node["count"] and (points >= low - 1e-9).all() and (points <= low + width + 1e-9).all()
    assert file.nodes["level"].max() >= 3 and describe(path).facts.version == "LAS 1.4, COPC"


def test_branches_of_a_large_octree_have_pages_of_their_own(table, tmp_path, monkeypatch, small_nodes):
    monkeypatch.setattr(copc_writer, "_ENTRIES_PER_PAGE", 10)
    monkeypatch.setattr(copc_writer, "_PAGE_DEPTH", 1)
    write_copc(tmp_path / "pages.copc.laz", table)
    file = open_copc(tmp_path / "pages.copc.laz")
    with CopcReader.open(str(file.path)) as reader:
        assert len(reader.query()) == len(table.points) == file.nodes["count"].sum()
        assert reader.copc_info.hierarchy_root_size < len(entries_of(file.path)) * COPC_ENTRY.itemsize


def test_the_file_is_the_same_on_every_device_and_from_run_to_run(table, path, tmp_path, device):
    write_copc(tmp_path / "again.copc.laz", table, device=device)
    assert (tmp_path / "again.copc.laz").read_bytes() == path.read_bytes()


def test_few_and_coincident_points_form_one_node(rng, tmp_path):
    for count in (0, 1, 2):
        write_copc(tmp_path / "few.copc.laz", survey(rng, count))
        file = open_copc(tmp_path / "few.copc.laz")
        assert len(file.read().points) == len(loom.read_point_cloud(file.path)) == count
        with CopcReader.open(str(file.path)) as reader:
            assert reader.header.point_count == count
    points = np.repeat([[5e5, 6e6, 3.0], [5e5, 6e6, 4.0]], 4000, axis=0)
    write_copc(tmp_path / "one.copc.laz", PointTable(points))
    with CopcReader.open(str(tmp_path / "one.copc.laz")) as reader:
        np.testing.assert_array_equal(np.sort(reader.query().z), np.sort(points[:, 2]))


@OF_ALL_INTEGERS
def test_old_scan_angles_are_converted_to_the_new_formats(rng, tmp_path):
    make(tmp_path / "old.las", 3, 500, rng)
    cloud = loom.read_point_cloud(tmp_path / "old.las")
    loom.write_point_cloud(tmp_path / "new.copc.laz", cloud, like=tmp_path / "old.las")
    angles = loom.read_point_cloud(tmp_path / "new.copc.laz")["scan_angle"]
    np.testing.assert_array_equal(np.sort(np.rint(angles * 0.006)), np.sort(cloud["scan_angle_rank"]))


@OF_ALL_INTEGERS
@pytest.mark.parametrize("suffix", [".las", ".laz", ".copc.laz"])
@pytest.mark.parametrize(
    ("formats", "lost"), [((1, 6), ""), ((8, 3), "nir"), ((5, 10), "nir"), ((0, 7), "colors and gps_time")]
)
def test_clouds_of_old_and_new_point_formats_keep_common_dimensions(rng, tmp_path, formats, lost, suffix):
    clouds, records = [], []
    for k, number in enumerate(formats):
        records.append(make(tmp_path / f"{k}.las", number, 50, rng))
        clouds.append(loom.read_point_cloud(tmp_path / f"{k}.las"))
        clouds[-1]["row"] = np.arange(50 * k, 50 * k + 50)
    with pytest.warns(UserWarning, match=f"^clouds: the {lost} are dropped") if lost else nullcontext():
        both = clouds[0] + clouds[1]
    loom.write_point_cloud(tmp_path / f"both{suffix}", both, scale=0.1)
    las = laspy.read(tmp_path / f"both{suffix}")
    las.points = las.points[np.argsort(las["row"])]
    for name in ("return_number", "number_of_returns", "classification", "synthetic", "key_point", "withheld"):
        np.testing.assert_array_equal(las[name], np.concatenate([record[name] for record in records]))
    old = [number < 6 for number in formats]
    angles = [r["scan_angle_rank"] if o else r["scan_angle"] * 0.006 for r, o in zip(records, old, strict=True)]
    overlap = [r["classification"] == 12 if o else r["overlap"] for r, o in zip(records, old, strict=True)]
    channel = [np.zeros(50) if o else r["scanner_channel"] for r, o in zip(records, old, strict=True)]
    np.testing.assert_allclose(np.asarray(las["scan_angle"]) * 0.006, np.concatenate(angles), rtol=0, atol=0.0031)
    np.testing.assert_array_equal(las["overlap"], np.concatenate(overlap))
    np.testing.assert_array_equal(las["scanner_channel"], np.concatenate(channel))


@OF_ALL_INTEGERS
def test_scan_angles_of_attributes_that_only_new_formats_store_are_converted(rng, tmp_path):
    make(tmp_path / "old.las", 1, 20, rng)
    cloud = loom.read_point_cloud(tmp_path / "old.las")
    cloud["classification"] = np.full(20, 64, np.uint8)
    loom.write_point_cloud(tmp_path / "new.las", cloud, scale=0.1)
    las = laspy.read(tmp_path / "new.las")
    assert [*las.point_format.extra_dimension_names] == []
    np.testing.assert_array_equal(np.rint(np.asarray(las["scan_angle"]) * 0.006), cloud["scan_angle_rank"])


def test_a_real_tile_keeps_all_of_its_points(scan_file, tmp_path):
    source = scan_file("lidar-pdal/laz/autzen_trim.laz")
    table = read_las(source)
    write_copc(tmp_path / "t.copc.laz", table, like=open_las(source).header)
    del table.attributes["scan_angle_rank"]
    again = open_copc(tmp_path / "t.copc.laz").read()
    again.attributes = {name: again.attributes[name] for name in table.attributes}
    np.testing.assert_array_equal(in_order(again), in_order(table))


@pytest.mark.parametrize(
    ("edit", "reason"),
    [
        ((INFO_AT, "<d", np.nan), "octree has the middle"),
        ((INFO_AT + 24, "<d", 0.0), "octree has the middle"),
        ((INFO_AT + 32, "<d", np.inf), "octree has the middle"),
        ((INFO_AT + 40, "<Q", 1 << 60), "page of the octree"),
        ((INFO_AT + 48, "<Q", 1 << 60), "page of the octree"),
        ((INFO_AT + 48, "<Q", 32), "which are not the"),
        ((104, "B", 0x80 | 3), "(?s)."),
        # after the beginning of the page
        ((-0, "<i", -1), "level or count"),
        ((-4, "<i", 1), "outside its cube"),
        ((-24, "<i", 1 << 30), "which are not the"),
        ((-28, "<i", -1), "page of the octree|a cycle"),
        ((-16, "<Qii", "page", "size", -1), "a cycle"),
    ],
)
def test_invalid_records_and_entries_are_errors(edit, reason, path):
    page, size = struct.unpack_from("<QQ", path.read_bytes(), INFO_AT + 40)
    at, form, *values = edit
    values = [{"page": page, "size": size}.get(value, value) for value in values]
    with pytest.raises(loom.FileError, match=reason) as caught:
        loom.read_copc(edited(path, (page - at if at <= 0 else at, form, *values)))
    assert str(path) in str(caught.value)


def test_any_wrong_byte_of_the_octree_is_an_error_or_harmless(path, rng):
    """An error or identical points: entries are checked against the chunks."""
    expected, raw = in_order(read_las(path)), path.read_bytes()
    begin = len(raw) - len(entries_of(path)) * COPC_ENTRY.itemsize
    for _ in range(60):
        at = int(rng.choice([rng.integers(begin, len(raw)), rng.integers(INFO_AT + 40, INFO_AT + 56)]))
        path.write_bytes(raw[:at] + bytes([raw[at] ^ (1 << int(rng.integers(8)))]) + raw[at + 1 :])
        try:
            result = in_order(open_copc(path).read())
        except loom.FileError:
            continue
        np.testing.assert_array_equal(result, expected)

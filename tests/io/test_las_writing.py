"""Writing LAS and LAZ: written files are read back, and unsupported values are rejected by name."""

import laspy
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointloom as loom
from pointloom.io.points.las import open_las, read_las
from pointloom.io.points.las_writer import write_las
from pointloom.io.table import PointTable

from .las_files import edited, make


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

"""info, convert, downsample and normals on LAS, LAZ and E57 files."""

import sys

import laspy
import numpy as np
import pytest

import pointloom as loom

from ..io.las_files import write_raw
from .commands import answer, run


@pytest.fixture
def autzen(scan_file):
    """110,000 compressed points in feet; every 22nd point in tests/data."""
    return scan_file("lidar-pdal/laz/autzen_trim.laz")


def test_info_reports_the_header(autzen, shipped_file):
    header = laspy.read(autzen).header
    count, low, high = header.point_count, header.mins, header.maxs
    small = shipped_file("lidar-pdal/autzen/autzen-utm.las")
    first, second = answer("info", autzen, small)["files"]
    assert (first["kind"], first["points"], first["point_format"]) == ("point cloud", count, 3)
    assert first["version"] == "LAS 1.2, compressed" and first["scale"] == [0.01, 0.01, 0.01]
    assert first["offset"] == [0, 0, 0] and first["coordinate_system"] == "NAD_1983_HARN_Lambert_Conformal_Conic"
    assert first["bounds"]["min"] == pytest.approx(low) and first["bounds"]["max"] == pytest.approx(high)
    assert (first["unit"], second["unit"]) == ("foot", "metre") and first["attributes"]["gps_time"] == "float64"
    assert first["attributes"]["colors"] == "float32 x 3" and second["version"] == "LAS 1.2"
    printed = run("info", autzen).stdout
    assert f"[{low[0]:.4f}, {low[1]:.4f}, {low[2]:.4f}] to" in printed and "[0.01, 0.01, 0.01]" in printed
    assert "  foot (0.3048 m)\n" in printed and f"{count:,}" in printed and count >= 5000


def test_info_lists_the_scans_of_an_e57_file(tmp_path, rng):
    cloud = loom.PointCloud(rng.random((9, 3)), scan_index=np.arange(9) % 2)
    loom.write_point_cloud(tmp_path / "a.e57", cloud)
    (report,) = answer("info", tmp_path / "a.e57")["files"]
    assert report["points"] == 9
    assert report["scans"] == [f"Scan 0: 5 points, at {[0.0] * 3}".replace("0.0", "0.0000"), report["scans"][1]]
    assert "Scan 1: 4 points" in run("info", tmp_path / "a.e57").stdout


@pytest.mark.parametrize("suffix", [".las", ".laz"])
def test_convert_between_las_files_keeps_integers_scale_and_coordinate_system(autzen, tmp_path, suffix):
    output = tmp_path / f"out{suffix}"
    assert answer("convert", autzen, output)["left_out"] == []
    before, after = laspy.read(autzen), laspy.read(output)
    for name in before.point_format.dimension_names:
        if name not in ("red", "green", "blue"):
            np.testing.assert_array_equal(np.asarray(before[name]), np.asarray(after[name]))
    reports = answer("info", autzen, output)["files"]
    for name in ("points", "point_format", "scale", "offset", "coordinate_system", "attributes"):
        assert reports[0][name] == reports[1][name]
    for corner in ("min", "max"):
        assert reports[0]["bounds"][corner] == pytest.approx(reports[1]["bounds"][corner], rel=1e-14)


def test_convert_preserves_las_attributes_in_other_formats(autzen, tmp_path):
    source = tmp_path / "in.las"
    las = laspy.read(autzen)
    las.points = las.points[:500]
    las.write(source)
    for name in ("a.ply", "a.npz", "a.pcd"):
        assert answer("convert", source, tmp_path / name)["left_out"] == []
        assert answer("convert", tmp_path / name, tmp_path / f"{name}.laz")["left_out"] == []
        result = laspy.read(tmp_path / f"{name}.laz")
        np.testing.assert_allclose(result.xyz, las.xyz, rtol=0, atol=1e-6)
        for field in ("intensity", "classification", "return_number", "gps_time", "scan_angle_rank"):
            np.testing.assert_array_equal(np.asarray(result[field]), np.asarray(las[field]))


@pytest.mark.filterwarnings("always::UserWarning")
def test_convert_reports_attributes_that_las_and_e57_do_not_support(tmp_path, rng):
    cloud = loom.PointCloud(rng.random((5, 3)), intensity=rng.random(5), label=np.arange(5), flag=np.ones(5, bool))
    loom.write_point_cloud(tmp_path / "a.npz", cloud)
    assert answer("convert", tmp_path / "a.npz", tmp_path / "a.las")["left_out"] == ["flag"]
    assert "'intensity' as 'intensity_value'" in run("convert", tmp_path / "a.npz", tmp_path / "b.laz").stderr
    result = laspy.read(tmp_path / "a.las")
    np.testing.assert_array_equal(result["label"], np.arange(5))
    np.testing.assert_array_equal(result["intensity_value"], cloud["intensity"])
    assert answer("convert", tmp_path / "a.npz", tmp_path / "a.e57")["left_out"] == ["label", "flag"]
    np.testing.assert_array_equal(loom.read_point_cloud(tmp_path / "a.e57")["intensity"], cloud["intensity"])


def test_damaged_files_and_missing_packages_are_one_line_errors(autzen, tmp_path, monkeypatch):
    broken = tmp_path / "broken.laz"
    broken.write_bytes(autzen.read_bytes()[: autzen.stat().st_size * 5 // 6])
    for command in (["info", broken], ["convert", broken, tmp_path / "out.ply"]):
        result = run(*command)
        assert result.exit_code == 1 and result.stderr.startswith(f"error: {broken}")
        assert "truncated or damaged: the table of chunks" in result.stderr and "Traceback" not in result.stderr
    monkeypatch.setitem(sys.modules, "laspy", None)
    result = run("info", autzen)
    assert result.exit_code == 1 and 'pip install "pointloom[las]"' in result.stderr


@pytest.mark.filterwarnings("always::pointloom.io.points.las_crs.GeographicWarning")
def test_a_file_in_degrees_causes_a_warning_and_keeps_its_rows(tmp_path, rng):
    degrees, raw = tmp_path / "degrees.las", rng.integers(0, 10_000, (200, 3))
    records = {2112: 'GEOGCS["WGS 84",UNIT["degree",0.01745]]'}
    write_raw(degrees, raw, records, scales=[1e-7, 1e-7, 0.001], offsets=[-123, 44, 0])
    result = run("downsample", degrees, tmp_path / "some.laz", "--farthest", 50)
    assert result.exit_code == 0 and "degrees.las: x and y are degrees" in result.stderr
    stored, selected = ({*map(tuple, laspy.read(path).xyz.tolist())} for path in (degrees, tmp_path / "some.laz"))
    assert len(selected) == 50 and selected <= stored


@pytest.mark.filterwarnings("always::UserWarning")
@pytest.mark.parametrize(("suffix", "is_rounded"), [(".ply", True), (".pcd", True), (".e57", True), (".laz", False)])
def test_convert_warns_about_rounded_colors(tmp_path, suffix, is_rounded):
    for red, is_finer in ((1000, True), (257, False)):
        colors = np.array([[red, 0, 65535], [0, 0, 0]]) / 65535
        loom.write_point_cloud(tmp_path / "a.las", loom.PointCloud(np.eye(3)[:2], colors=colors))
        messages = run("convert", tmp_path / "a.las", tmp_path / f"out{suffix}", "--force").stderr
        assert ("rounded to the 8 bits" in messages) == (is_rounded and is_finer)

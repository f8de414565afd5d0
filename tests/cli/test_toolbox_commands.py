"""clean, cluster, plane, crop and downsample: common behavior."""

import json

import numpy as np
import pytest

import pointloom as loom

from .commands import answer, chosen_device, names_in, refusal, run, unreliable

# every command, with options that work on `scene`
CALLS = {
    "clean": [],
    "cluster": ["--radius", "0.2"],
    "plane": ["--distance", "0.01"],
    "crop": ["--box", "0", "0", "0", "1", "1", "1"],
    "downsample": ["--every", "2"],
}
each_command = pytest.mark.parametrize("command", CALLS)


@each_command
def test_attributes_are_written_unchanged(scene, points, tmp_path, device, command):
    output = tmp_path / "out.npz"
    report = answer(command, scene, output, *CALLS[command], "--device", device)
    assert (report["command"], report["points_in"], report["left_out"]) == (command, len(points), [])
    assert report["files"] == [str(output)]
    with np.load(output) as written:
        rows = written["row"]
        assert len(rows) == report["points"] > 0 and written["points"].dtype == np.float64
        np.testing.assert_array_equal(written["points"], points[rows])  # float32 would round them
        np.testing.assert_array_equal(written["time"], rows / 3)
        np.testing.assert_array_equal(written["colors"], np.full((len(rows), 3), 0.25))
        assert written["normals"].shape == (len(rows), 3)


@each_command
def test_the_summary_lists_omitted_attributes(scene, tmp_path, command):
    options = [*CALLS[command], *(["--largest", "1"] if command == "cluster" else [])]
    result = run(command, scene, tmp_path / "out.xyz", *options)
    assert result.exit_code == 0, result.stderr
    assert "left out" in result.stdout
    for word in ("normals, colors", "time", "seconds", f"on {chosen_device()}", "out.xyz"):
        assert word in result.stdout
    assert result.stderr == ""


@each_command
def test_the_output_is_checked_before_the_input_is_read(tmp_path, command):
    words = command, tmp_path / "missing.ply", *CALLS[command]
    assert "not written to .docx" in refusal(*words, "-o", tmp_path / "out.docx")
    assert "Leave out --ascii" in refusal(*words, "-o", tmp_path / "out.npz", "--ascii")


@each_command
def test_a_broken_file_is_an_error_and_nothing_is_written(cloud, tmp_path, command):
    cloud.write_bytes(cloud.read_bytes()[:-1])
    assert refusal(command, cloud, tmp_path / "out.ply", *CALLS[command]).startswith(f"error: {cloud}")
    assert names_in(tmp_path) == ["cloud.ply"]


@each_command
def test_a_cloud_without_finite_points_is_unreliable(tmp_path, command):
    loom.write_point_cloud(tmp_path / "a.ply", loom.PointCloud(np.full((4, 3), np.nan)))
    options = ["--voxel", "1"] if command == "downsample" else CALLS[command]
    extra = ["--largest", "1"] if command == "cluster" else []
    report = unreliable(command, tmp_path / "a.ply", tmp_path / "b.ply", *options, *extra)
    assert (report["points_in"], report["points"], report["files"]) == (4, 0, [])
    assert "nothing was written" in str(report["warnings"])
    assert command != "downsample" or "none of 4 points is left" in str(report["warnings"])
    loom.write_point_cloud(tmp_path / "a.ply", loom.PointCloud(), overwrite=True)
    assert unreliable(command, tmp_path / "a.ply", tmp_path / "b.ply", *CALLS[command], *extra)["files"] == []
    assert names_in(tmp_path) == ["a.ply"]


@each_command
def test_commands_accept_the_vertices_of_a_mesh(mesh, tmp_path, command):
    options = ["--radius", "2", "--neighbors", "5", "--largest", "1"] if command == "cluster" else CALLS[command]
    result = run(command, mesh, tmp_path / "out.ply", *options, "--json")
    report = json.loads(result.stdout)
    assert report["points_in"] == 4 and report["left_out"] == ["triangles"]


def test_a_chain_of_commands_works_on_a_lidar_tile(scan_file, tmp_path):
    laspy = pytest.importorskip("laspy")
    source, last = scan_file("lidar-pdal/laz/autzen_trim.laz"), tmp_path / "0.laz"
    steps = (
        ["downsample", "--every", "20"],
        ["clean", "--duplicates", "--neighbors", "8"],
        ["cluster", "--radius", "60"],
        ["plane", "--distance", "3", "--planes", "2"],
        ["crop", "--box", "636000", "848900", "-inf", "637000", "849500", "inf"],
    )
    for number, (command, *options) in enumerate(steps):
        last = tmp_path / f"{number}.laz"
        previous = tmp_path / f"{number - 1}.laz" if number else source
        assert answer(command, previous, last, *options)["left_out"] == []
    before, after = laspy.read(source), laspy.read(last)
    assert 0 < len(after.x) < 5500 and after.header.scales.tolist() == before.header.scales.tolist()
    assert len({report["coordinate_system"] for report in answer("info", source, last)["files"]}) == 1
    stamps = {time: row for row, time in enumerate(zip(before.X, before.Y, before.Z, before.gps_time, strict=True))}
    rows = [stamps[key] for key in zip(after.X, after.Y, after.Z, after.gps_time, strict=True)]  # exact integers
    np.testing.assert_array_equal(after.intensity, before.intensity[rows])
    assert {"label", "plane"} <= {*after.point_format.extra_dimension_names}

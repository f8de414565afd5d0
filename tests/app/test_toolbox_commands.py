"""clean, cluster, plane, crop and sample: what holds for all of them."""

import json

import numpy as np
import pytest

import pointloom as loom

from .commands import answer, chosen_device, names_in, poor_answer, run

# every command, with options that work on `scene`
CALLS = {
    "clean": [],
    "cluster": ["--radius", "0.2"],
    "plane": ["--distance", "0.01"],
    "crop": ["--box", "0", "0", "0", "1", "1", "1"],
    "sample": ["--every", "2"],
}
each_command = pytest.mark.parametrize("command", CALLS)


@each_command
def test_rows_are_written_as_the_file_has_them(scene, points, tmp_path, device, command):
    output = tmp_path / "out.npz"
    report = answer(command, scene, output, *CALLS[command], "--device", device)
    assert (report["command"], report["points_in"], report["left_out"]) == (command, len(points), [])
    assert report["files"] == [str(output)]
    with np.load(output) as written:
        rows = written["row"]
        assert len(rows) == report["points"] > 0
        assert written["points"].dtype == np.float64
        np.testing.assert_array_equal(written["points"], points[rows])  # float32 would round them
        np.testing.assert_array_equal(written["time"], rows / 3)
        np.testing.assert_array_equal(written["colors"], np.full((len(rows), 3), 0.25))
        assert written["normals"].shape == (len(rows), 3)


@each_command
def test_a_summary_says_what_was_left_out(scene, tmp_path, command):
    options = [*CALLS[command], *(["--largest", "1"] if command == "cluster" else [])]
    shown = run(command, scene, tmp_path / "out.xyz", *options)
    assert shown.exit_code == 0, shown.stderr
    assert "left out" in shown.stdout
    for word in ("normals, colors", "time", "seconds", f"on {chosen_device()}", "out.xyz"):
        assert word in shown.stdout
    assert shown.stderr == ""


@each_command
def test_an_output_that_exists_is_kept_unless_forced(scene, tmp_path, command):
    output = tmp_path / "out.ply"
    output.write_bytes(b"kept")
    refused = run(command, scene, output, *CALLS[command])
    assert refused.exit_code == 1
    assert "out.ply: exists already" in refused.stderr
    assert output.read_bytes() == b"kept"
    assert run(command, scene, output, *CALLS[command], "--force").exit_code == 0
    assert output.read_bytes().startswith(b"ply")


@each_command
def test_the_output_is_checked_before_the_input_is_read(tmp_path, command):
    result = run(command, tmp_path / "missing.ply", tmp_path / "out.docx", *CALLS[command])
    assert result.exit_code == 1
    assert "not written to .docx" in result.stderr
    result = run(command, tmp_path / "missing.ply", tmp_path / "out.npz", *CALLS[command], "--ascii")
    assert "Leave out --ascii" in result.stderr


@each_command
def test_a_broken_file_is_an_error_and_nothing_is_written(cloud, tmp_path, command):
    cloud.write_bytes(cloud.read_bytes()[:-1])
    result = run(command, cloud, tmp_path / "out.ply", *CALLS[command])
    assert result.exit_code == 1
    assert result.stderr.startswith(f"error: {cloud}")
    assert names_in(tmp_path) == ["cloud.ply"]


@each_command
def test_a_cloud_without_finite_points_is_a_poor_result(tmp_path, command):
    loom.write_point_cloud(tmp_path / "a.ply", loom.PointCloud(np.full((4, 3), np.nan)))
    options = ["--voxel", "1"] if command == "sample" else CALLS[command]
    extra = ["--largest", "1"] if command == "cluster" else []
    report = poor_answer(command, tmp_path / "a.ply", tmp_path / "b.ply", *options, *extra)
    assert (report["points_in"], report["points"], report["files"]) == (4, 0, [])
    assert "nothing was written" in report["poor"]
    assert names_in(tmp_path) == ["a.ply"]


@each_command
def test_an_empty_cloud_is_a_poor_result(tmp_path, command):
    loom.write_point_cloud(tmp_path / "a.ply", loom.PointCloud())
    extra = ["--largest", "1"] if command == "cluster" else []
    assert poor_answer(command, tmp_path / "a.ply", tmp_path / "b.ply", *CALLS[command], *extra)["files"] == []
    assert names_in(tmp_path) == ["a.ply"]


@each_command
def test_the_vertices_of_a_mesh_count(mesh, tmp_path, command):
    options = ["--radius", "2", "--neighbors", "5", "--largest", "1"] if command == "cluster" else CALLS[command]
    result = run(command, mesh, tmp_path / "out.ply", *options, "--json")
    report = json.loads(result.stdout)
    assert report["points_in"] == 4
    assert report["left_out"] == ["triangles"]


@pytest.mark.parametrize(
    ("words", "hint"),
    [
        ("clean a.ply", "missing argument"),
        ("clean a.ply b.ply --radius 1", "--radius needs --min-neighbors"),
        ("clean a.ply b.ply --min-neighbors 4", "--min-neighbors needs --radius"),
        ("clean a.ply b.ply --deviations 0", "'--deviations': expected a finite number above 0, got '0'"),
        ("clean a.ply b.ply --deviations inf", "--deviations"),
        ("clean a.ply b.ply --neighbors 2.5", "'--neighbors': expected a whole number from 1 to"),
        ("clean a.ply b.ply --neighbors 2147483647", "--neighbors"),
        ("clean a.ply b.ply --removed ./b.ply", "--removed is OUT itself"),
        ("cluster a.ply b.ply", "missing option '--radius'"),
        ("cluster a.ply b.ply --radius nan", "'--radius'"),
        ("cluster a.ply b.ply --radius 1 --neighbors 0", "--neighbors"),
        ("cluster a.ply b.ply --radius 1 --largest 0", "--largest"),
        ("plane a.ply b.ply", "missing option '--distance'"),
        ("plane a.ply b.ply --distance -1", "--distance"),
        ("plane a.ply b.ply --distance 1 --planes 2 --invert", "--invert chooses points, --planes labels"),
        ("plane a.ply b.ply --distance 1 --min-points 9", "--min-points goes with --planes"),
        ("plane a.ply b.ply --distance 1 --seed 2147483648", "'--seed': expected a whole number from 0"),
        ("plane a.ply b.ply --distance 1 --iterations x", "--iterations"),
        ("crop a.ply b.ply", "one of --box and --polygon"),
        ("crop a.ply b.ply --box 0 0 0 1 1 1 --polygon c.json", "one of --box and --polygon"),
        ("crop a.ply b.ply --box 0 0 0 1 1", "--box"),
        ("crop a.ply b.ply --box 0 0 0 1 nan 1", "'--box': expected a coordinate"),
        ("crop a.ply b.ply --box 0 2 0 1 1 1", "--box: expected Y0 <= Y1, got 2 and 1"),
        ("sample a.ply b.ply", "one of --every, --ratio, --farthest and --voxel, got none"),
        ("sample a.ply b.ply --every 2 --voxel 1", "got every and voxel"),
        ("sample a.ply b.ply --ratio 1.5", "'--ratio': expected a share above 0 and up to 1"),
        ("sample a.ply b.ply --every 0", "--every"),
        ("sample a.ply b.ply --farthest 1e3", "--farthest"),
        ("sample a.ply b.ply --every 2 --nearest", "--nearest goes with --voxel"),
        ("sample a.ply b.ply --voxel 2 --seed 1", "--seed goes with --ratio"),
    ],
)
def test_a_wrong_call_exits_with_2_and_names_the_option(words, hint):
    result = run(*words.split())
    assert result.exit_code == 2
    assert result.stdout == ""
    first, *others = result.stderr.splitlines()
    assert first.startswith("error: ")
    assert hint in first
    assert others in ([], [f"See 'pointloom {words.split()[0]} --help'."])


def test_the_whole_chain_works_on_a_lidar_tile(scan_file, tmp_path):
    laspy = pytest.importorskip("laspy")
    source, last = scan_file("lidar-pdal/laz/autzen_trim.laz"), tmp_path / "0.laz"
    steps = (
        ["sample", "--every", "20"],
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
    assert 0 < len(after.x) < 5500
    assert after.header.scales.tolist() == before.header.scales.tolist()
    assert len({report["coordinate_system"] for report in answer("info", source, last)["files"]}) == 1
    stamps = {time: row for row, time in enumerate(zip(before.X, before.Y, before.Z, before.gps_time, strict=True))}
    rows = [stamps[key] for key in zip(after.X, after.Y, after.Z, after.gps_time, strict=True)]  # the very integers
    np.testing.assert_array_equal(after.intensity, before.intensity[rows])
    assert {"label", "plane"} <= {*after.point_format.extra_dimension_names}

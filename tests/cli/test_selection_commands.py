"""clean, cluster, crop, plane, downsample, change: results, common behavior, units and errors."""

import json
import re
from pathlib import Path

import numpy as np
import pytest

import pointloom as loom
from pointloom.cli.jobs.cluster import TAB20_PALETTE

from .commands import answer, chosen_device, names_in, refusal, run, unreliable


def rows_of(path: Path) -> list[int]:
    return loom.read_point_cloud(path)["row"].tolist()


FLOOR, FIRST_BLOB, SECOND_BLOB = range(600), range(600, 750), range(750, 850)
STRAY, REPEATED, NOT_FINITE = 850, 851, 852


def test_clean_removes_non_finite_points_and_statistical_outliers(scene, tmp_path, points, device):
    report = answer("clean", scene, tmp_path / "out.npz", "--device", device)
    finite = loom.PointCloud(points, device=device).remove_non_finite_points()
    _, expected = finite.remove_statistical_outlier(20, 2.0)
    assert rows_of(tmp_path / "out.npz") == expected.tolist()  # the non-finite point is the last one
    removed = len(finite) - len(expected)
    statistical = {"removed": removed, "neighbors": 20, "ratio": 2.0}
    assert report["filters"] == {"non_finite": {"removed": 1}, "statistical": statistical} and STRAY not in expected
    assert removed >= 1


def test_clean_runs_the_requested_filters(scene, points, tmp_path):
    all_filters = {"non_finite": 1, "duplicate": 1, "statistical": 1, "radius": 0}
    radius = ["--radius", 0.3, "--min-neighbors", 1]
    for options, filters, removed_rows in (
        (["--non-finite"], {"non_finite": 1}, {NOT_FINITE}),
        (["--duplicates"], {"non_finite": 1, "duplicate": 1}, {NOT_FINITE, REPEATED}),
        (radius, {"non_finite": 1, "radius": 1}, {NOT_FINITE, STRAY}),
        (["--duplicates", *radius, "--deviations", 20], all_filters, {NOT_FINITE, REPEATED, STRAY}),
    ):
        output, removed_file = tmp_path / "out.npz", tmp_path / "removed.npz"
        report = answer("clean", scene, output, *options, "--removed", removed_file, "--force")
        assert {name: figures["removed"] for name, figures in report["filters"].items()} == filters
        assert rows_of(output) == [row for row in range(len(points)) if row not in removed_rows]
        assert rows_of(removed_file) == sorted(removed_rows) and report["files"] == [str(removed_file), str(output)]
        printed = run("clean", scene, output, *options, "--force").stdout
        assert "1 non-finite" in printed and ("(radius 0.3, min neighbors 1)" in printed) == ("radius" in filters)


def test_clean_checks_the_file_of_removed_points_first_and_writes_none_that_is_empty(cloud, tmp_path):
    words = ["clean", cloud, tmp_path / "out.ply", "--non-finite", "--removed", tmp_path / "gone.ply"]
    assert answer(*words)["files"] == [str(tmp_path / "out.ply")] and names_in(tmp_path) == ["cloud.ply", "out.ply"]
    (tmp_path / "out.ply").rename(tmp_path / "gone.ply")
    assert "gone.ply: exists already" in refusal(*words) and names_in(tmp_path) == ["cloud.ply", "gone.ply"]


def test_a_radius_that_removes_too_many_points_is_unreliable(cloud, tmp_path):
    words = ["clean", cloud, tmp_path / "out.ply", "--min-neighbors", "3", "--radius"]
    report = unreliable(*words, "0.05")
    assert "have fewer than 4 points within 0.05 m" in str(report["warnings"])
    better = "; ".join(report["warnings"]).split("that many within ")[1].split(" m")[0]
    assert answer(*words, better, "--force")["points"] >= 250
    report = unreliable(*words, "0.0001", "--force")
    assert (report["points"], report["files"]) == (0, []) and "nothing was written" in str(report["warnings"])


def test_cluster_labels_match_the_library(scene, points, tmp_path, device):
    output = tmp_path / "out.npz"
    report = answer("cluster", scene, output, "--radius", "0.2", "--device", device)
    labels = loom.read_point_cloud(output)["label"]
    assert labels.dtype == np.int32
    np.testing.assert_array_equal(labels, loom.PointCloud(points).cluster_dbscan(0.2, 10))
    assert [np.unique(labels[part]).tolist() for part in (FLOOR, FIRST_BLOB, SECOND_BLOB)] == [[0], [1], [2]]
    assert (report["clusters"], report["noise"], report["replaced"]) == (3, 2, [])
    assert [(cluster["label"], cluster["points"]) for cluster in report["largest"]] == [(0, 601), (1, 150), (2, 100)]
    printed = run("cluster", scene, output, "--radius", "0.2", "--force").stdout
    assert "601 (label 0), 150 (label 1), 100 (label 2)" in printed and "2 of 853 points, 0.2%" in printed


def test_cluster_keeps_the_largest_under_their_own_labels(scene, tmp_path):
    assert answer("cluster", scene, tmp_path / "out.npz", "--radius", "0.2", "--largest", "2")["points"] == 751
    clusters = loom.read_point_cloud(tmp_path / "out.npz")
    assert np.unique(clusters["label"]).tolist() == [0, 1]
    assert clusters["row"].tolist() == [*FLOOR, *FIRST_BLOB, REPEATED]
    # the largest clusters have the most points, regardless of their labels
    words = ["cluster", tmp_path / "out.npz", tmp_path / "b.npz", "--radius", 0.2, "--neighbors", 1, "--largest", 1]
    assert answer("crop", scene, tmp_path / "out.npz", "--force", "--box", 0, 0, 0.1, 1, 1, 9)["points"] == 250
    blobs = loom.read_point_cloud(tmp_path / "out.npz")
    loom.write_point_cloud(tmp_path / "out.npz", blobs.select_by_index(range(249, -1, -1)))
    assert answer(*words)["largest"][0] == {"label": 1, "points": 150}
    assert sorted(rows_of(tmp_path / "b.npz")) == [*FIRST_BLOB]


def test_cluster_paints_labels_and_noise(scene, tmp_path):
    assert answer("cluster", scene, tmp_path / "out.npz", "--radius", "0.2", "--paint")["replaced"] == ["colors"]
    painted = loom.read_point_cloud(tmp_path / "out.npz")
    expected = np.vstack([TAB20_PALETTE / 255, np.zeros(3)]).astype(np.float32)[painted["label"]]
    np.testing.assert_array_equal(painted.colors, expected)
    assert not painted.colors[STRAY].any() and len(np.unique(TAB20_PALETTE, axis=0)) == 20
    printed = run("cluster", tmp_path / "out.npz", tmp_path / "b.xyzrgb", "--radius", "0.2", "--paint").stdout
    assert "colors, label of the input" in printed and len(loom.read_point_cloud(tmp_path / "b.xyzrgb")) == 853
    for suffix, options, reason in ((".xyzrgb", [], "labels are not"), (".xyz", ["--paint"], "labels or colors")):
        assert reason in refusal("cluster", scene, tmp_path / f"c{suffix}", "--radius", "0.2", *options)


def test_cluster_proposes_an_eps_if_all_is_noise(scene, tmp_path):
    words = ["cluster", scene, tmp_path / "out.npz", "--radius"]
    report = unreliable(*words, "0.0001")
    assert (report["clusters"], report["noise"], report["points"]) == (0, 853, 853)
    better = "; ".join(report["warnings"]).split("that many within ")[1].split(" m")[0]
    report = answer(*words, better, "--force")
    assert report["noise"] < 427  # then half of the points are core points
    report = unreliable(*words, "0.0001", "--largest", "1", "--force")
    assert (report["points"], report["files"]) == (0, [])
    assert "fewer neighbors" in str(unreliable(*words, "0.2", "--neighbors", "900", "--force")["warnings"])


def test_cluster_is_unreliable_if_the_radius_exceeds_the_extent(scene, tmp_path):
    words = ["cluster", scene, tmp_path / "out.npz", "--radius"]
    report = unreliable(*words, "100")
    assert report["files"] == [str(tmp_path / "out.npz")]
    assert "--radius: 100 m exceeds the extent" in str(report["warnings"])


def test_crop_selects_the_points_in_the_box(scene, tmp_path, device):
    words = ["crop", scene, tmp_path / "out.npz", "--force", "--device", device, "--box"]
    answer(*words, 0, 0, 0.1, 0.5, 0.5, 1)
    assert rows_of(tmp_path / "out.npz") == [*FIRST_BLOB]
    answer(*words, "-inf", "-inf", 0.1, "inf", "inf", "inf")
    assert rows_of(tmp_path / "out.npz") == [*FIRST_BLOB, *SECOND_BLOB, STRAY]
    answer(*words, "-inf", "-inf", 0.1, "inf", "inf", "inf", "--invert")
    assert rows_of(tmp_path / "out.npz") == [*FLOOR, REPEATED, NOT_FINITE]


def test_crop_accepts_a_polygon_of_open3d(scene, points, tmp_path, device):
    corners = [[0.5, 0.5, 0], [1, 0.5, 0], [1, 1, 0], [0.5, 1, 0]]
    volume = loom.SelectionPolygonVolume(corners, "Z", axis_min=0.1, axis_max=1)
    volume.to_json(tmp_path / "volume.json")
    words = ["crop", scene, tmp_path / "out.npz", "--polygon", tmp_path / "volume.json", "--device", device, "--force"]
    answer(*words)
    assert rows_of(tmp_path / "out.npz") == [*SECOND_BLOB] and answer(*words, "--invert")["points"] == len(points) - 100
    (tmp_path / "volume.json").write_text("{}")
    assert refusal(*words).startswith(f"error: {tmp_path / 'volume.json'}")


def test_an_empty_crop_is_unreliable(scene, tmp_path):
    report = unreliable("crop", scene, tmp_path / "out.npz", "--box", 20, 20, 20, 30, 30, 30)
    assert report["files"] == []
    assert "to [9.0000, 9.0000, 9.0000]" in str(report["warnings"])  # where the points are
    assert names_in(tmp_path) == ["scene.npz"]


def test_plane_writes_its_inliers(scene, points, tmp_path, device):
    words = ["plane", scene, tmp_path / "out.npz", "--distance", "0.01", "--device", device]
    report = answer(*words)
    (plane,) = report["planes"]
    model, inliers = loom.PointCloud(points, device=device).segment_plane(0.01, num_iterations=1000)
    assert rows_of(tmp_path / "out.npz") == inliers.tolist() == [*FLOOR, REPEATED]
    np.testing.assert_array_equal(plane["model"], model)
    np.testing.assert_allclose(model, [0, 0, 1, 0], atol=1e-12)
    assert (report["points"], plane["points"], plane["fraction"]) == (601, 601, 601 / 852)
    answer(*words, "--invert", "--force")
    assert rows_of(tmp_path / "out.npz") == [*FIRST_BLOB, *SECOND_BLOB, STRAY, NOT_FINITE]
    assert "0.000000000 0.000000000 1.000000000 0.000000: 601 points, 70.5%" in run(*words, "--force").stdout


def test_plane_labels_several_planes(tmp_path, rng):
    floor = np.column_stack([rng.random((500, 2)), np.zeros(500)])
    wall = np.column_stack([np.zeros(300), rng.random((300, 2)) + 0.1])
    points = np.vstack([floor, wall, rng.random((40, 3)) + 0.2]) + np.array([5e5, 5e6, 100])
    loom.write_point_cloud(tmp_path / "a.ply", loom.PointCloud(points, plane=np.ones(840)))
    words = ["plane", tmp_path / "a.ply", tmp_path / "b.ply", "--distance", "0.005", "--planes", "5"]
    report = answer(*words)
    labels = loom.read_point_cloud(tmp_path / "b.ply")["plane"]
    assert labels.dtype == np.int32
    assert [(labels == label).sum() >= count for label, count in ((0, 500), (1, 300), (-1, 30))] == [True] * 3
    assert report["replaced"] == ["plane"] and report["on_none"] == (labels == -1).sum()
    assert [plane["points"] for plane in report["planes"]] == np.bincount(labels[labels >= 0]).tolist()
    for plane, part in zip(report["planes"], (points[:500], points[500:800]), strict=True):
        a, b, c, d = plane["model"]
        assert np.abs(part @ [a, b, c] + d).max() < 0.005  # in the coordinates of the file
    assert len(answer(*words, "--min-points", "400", "--force")["planes"]) == 1
    assert len(answer(*words[:-1], "1", "--force")["planes"]) == 1
    printed = run(*words, "--force").stdout
    assert f"840, {report['on_none']} of them not on a plane" in printed and "plane of the input" in printed


def test_the_seed_of_planes_determines_the_samples(cloud, tmp_path):
    words = ["plane", cloud, tmp_path / "out.ply", "--distance", "0.02", "--iterations", "20", "--force"]
    models = [answer(*words, "--seed", seed)["planes"][0]["model"] for seed in (1, 1, 2)]
    assert models[0] == models[1] != models[2]


def test_a_cloud_without_a_plane_is_unreliable(cloud, tmp_path):
    report = unreliable("plane", cloud, tmp_path / "out.ply", "--distance", "1e-6")
    assert "the largest one has only" in str(report["warnings"])
    assert report["points"] == len(loom.read_point_cloud(tmp_path / "out.ply"))
    report = unreliable("plane", cloud, tmp_path / "out.ply", "--distance", "1e-6", "--planes", "2", "--force")
    assert "plane: none has 100 points within 1e-06 m" in str(report["warnings"])
    assert (loom.read_point_cloud(tmp_path / "out.ply")["plane"] == -1).all()
    report = unreliable("plane", cloud, tmp_path / "b.ply", "--distance", "9", "--invert")
    assert "all points are on the plane" in str(report["warnings"])
    line = np.column_stack([np.arange(50), np.zeros((50, 2))])
    loom.write_point_cloud(tmp_path / "line.ply", loom.PointCloud(line))
    report = unreliable("plane", tmp_path / "line.ply", tmp_path / "b.ply", "--distance", "1")
    assert "samples are collinear" in str(report["warnings"]) and "b.ply" not in names_in(tmp_path)


def test_downsample_matches_the_library(scene, points, tmp_path, device):
    for options, choose in (
        (["--every", "7"], lambda cloud: cloud.uniform_down_sample(7)),
        (["--ratio", "0.25"], lambda cloud: cloud.random_down_sample(0.25)),
        (["--ratio", "0.25", "--seed", "5"], lambda cloud: cloud.random_down_sample(0.25, seed=5)),
        (["--farthest", "20"], lambda cloud: cloud.farthest_point_down_sample(20)),
        (["--voxel", "0.3", "--nearest"], lambda cloud: cloud.voxel_down_sample(0.3, "nearest")),
    ):
        report = answer("downsample", scene, tmp_path / "out.npz", *options, "--device", device, "--force")
        expected = choose(loom.PointCloud(points, device=device, row=np.arange(len(points))))["row"].tolist()
        assert rows_of(tmp_path / "out.npz") == expected and report["points"] == len(expected)


def test_downsample_writes_the_means_of_voxels(scene, tmp_path, device):
    report = answer("downsample", scene, tmp_path / "out.npz", "--voxel", "0.3", "--device", device)
    expected = loom.read_point_cloud(scene, device=device).voxel_down_sample(0.3)
    result = loom.read_point_cloud(tmp_path / "out.npz")
    assert report["points"] == len(expected)
    for name in ("points", "colors", "normals", "time"):
        np.testing.assert_array_equal(result[name], expected[name])


def test_downsample_reports_its_method(scene, tmp_path):
    for options, way in (
        ("--every 2", "427 of 853, one in 2"),
        ("--ratio 0.5 --seed 3", "426 of 853, a fraction of 0.5 at random, seed 3"),
        ("--farthest 5", "5 of 853, the farthest from each other"),
        ("--voxel 90", "1 of 853, one a voxel of 90 m, the mean"),
        ("--voxel 90 --nearest", "1 of 853, one a voxel of 90 m, the nearest to the mean"),
    ):
        assert way in run("downsample", scene, tmp_path / "out.ply", *options.split(), "--force").stdout


def test_farthest_points_start_at_a_finite_point_and_a_ratio_below_one_point_is_unreliable(tmp_path):
    points = [[np.nan, 0, 0], [0, 0, 0], [1, 0, 0], [5, 0, 0]]
    loom.write_point_cloud(tmp_path / "a.ply", loom.PointCloud(points, row=np.arange(4, dtype=np.int32)))
    words = ["downsample", tmp_path / "a.ply", tmp_path / "b.ply", "--force", "--farthest"]
    answer(*words, 2)
    assert rows_of(tmp_path / "b.ply") == [1, 3] and answer(*words, 3)["points"] == 3
    assert "a.ply: expected at least 4 finite points, got 3" in refusal(*words, 4)
    assert unreliable("downsample", tmp_path / "a.ply", tmp_path / "c.ply", "--ratio", "1e-6")["files"] == []
    assert names_in(tmp_path) == ["a.ply", "b.ply"]


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
def test_the_output_is_checked_first_and_a_broken_file_is_an_error(cloud, tmp_path, command):
    words = command, tmp_path / "missing.ply", *CALLS[command]
    assert "not written to .docx" in refusal(*words, "-o", tmp_path / "out.docx")
    assert "Leave out --ascii" in refusal(*words, "-o", tmp_path / "out.npz", "--ascii")
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
    report = json.loads(run(command, mesh, tmp_path / "out.ply", *options, "--json").stdout)
    assert report["points_in"] == 4 and report["left_out"] == ["triangles"]


@pytest.fixture
def feet(tmp_path, rng):
    path = tmp_path / "feet.ply"
    points = np.column_stack([rng.random((2000, 2)) * 10, 0.001 * rng.normal(size=2000)])
    loom.write_point_cloud(path, loom.PointCloud(points, unit="foot"))
    return path


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["downsample", "--voxel", 1], "one a voxel of 1 ft"),
        (["cluster", "--radius", 0.001], "eps 0.001 ft"),
        (["cluster", "--radius", 0.001], "fewer than 10 points within 0.001 ft"),
        (["normals", "--radius", 0.001], r"within 0.001 ft, .* within \S+ ft:"),
        (["clean", "--radius", 0.001, "--min-neighbors", 5], r"6 points within 0.001 ft, .* within \S+ ft:"),
        (["mesh", "--method", "alpha", "--alpha", 1], "ft^2"),
    ],
)
def test_lengths_are_printed_in_the_unit_of_the_file(words, message, feet, tmp_path):
    result = run(words[0], feet, tmp_path / "out.ply", *words[1:], "--device", "cpu")
    assert re.search(message.replace("^", r"\^"), result.stdout + result.stderr), result.stdout + result.stderr
    note = f"note: the unit of {feet} is foot (0.3048 m): all lengths, input and output, are in this unit\n"
    assert note in result.stderr
    if (tmp_path / "out.ply").exists():
        (report,) = answer("info", tmp_path / "out.ply")["files"]
        assert report["unit"] == "foot"


def test_json_contains_the_unit_and_meters_or_an_unknown_unit_are_reported_as_meters(feet, tmp_path):
    result = run("downsample", feet, tmp_path / "out.npz", "--voxel", 1, "--json", "--device", "cpu")
    assert result.stderr == "" and json.loads(result.stdout)["unit"] == "foot"
    for unit in (None, "metre"):
        loom.write_point_cloud(tmp_path / "a.npz", loom.PointCloud(np.eye(3), unit=unit))
        result = run("downsample", tmp_path / "a.npz", tmp_path / "b.ply", "--voxel", 1, "--force", "--device", "cpu")
        assert "one a voxel of 1 m, the mean\n" in result.stdout and "note" not in result.stderr
        (report,) = answer("info", tmp_path / "a.npz")["files"]
        assert report.get("unit") == unit


@pytest.mark.filterwarnings("always::pointloom.UnitWarning")
def test_files_in_different_units_cause_a_warning(feet, tmp_path):
    other = tmp_path / "meters.ply"
    loom.write_point_cloud(other, loom.read_point_cloud(feet).to_unit("metre"))
    result = run("register", feet, other, "--init", "identity", "--voxel", 1, "--device", "cpu")
    assert "warning: source, target: expected one unit of length, got foot and metre" in result.stderr
    result = run("register", feet, feet, "--init", "identity", "--voxel", 1, "--device", "cpu")
    assert "warning" not in result.stderr
    assert "one per voxel of 1 ft" in result.stdout and " ft at the middle of the source" in result.stdout


def test_meshes_are_compared_in_their_unit(tmp_path):
    for name, size in (("a.ply", 1.0), ("b.ply", 1.1)):
        mesh = loom.TriangleMesh.create_box(size, size, size)
        mesh.unit = "US survey foot"
        loom.write_triangle_mesh(tmp_path / name, mesh)
    result = run("compare-meshes", tmp_path / "a.ply", tmp_path / "b.ply", "--samples", 500, "--device", "cpu")
    assert re.search(r"chamfer +0\.\d+ US ft\n", result.stdout) and " US ft from A to B" in result.stdout


UTM = np.array([447_000.0, 5_411_000.0, 300.0])


def survey(lift=0.0, pit=0.0, seed=0, count=6000):
    """A slope of 20 x 20 m with 1 cm of noise and a lowered corner of 6 x 6 m."""
    rng = np.random.default_rng(seed)
    x, y = rng.random((2, count)) * 20
    z = 0.2 * x + 0.01 * rng.normal(size=count) + lift - np.where((x < 6) & (y < 6), pit, 0)
    return loom.PointCloud(np.column_stack([x, y, z]) + UTM, intensity=np.arange(count, dtype=np.uint16))


@pytest.fixture
def files(tmp_path):
    clouds = {"before": survey(), "after": survey(pit=0.3, seed=1), "lifted": survey(lift=0.5, seed=2)}
    for name, cloud in clouds.items():
        loom.write_point_cloud(tmp_path / f"{name}.npz", cloud)
    return tmp_path


def test_two_clouds_are_compared_by_m3c2(files, device):
    sizes = {"normal_radii": [1, 2], "cylinder_radius": 0.8, "max_distance": 2, "registration_error": 0.005}
    words = ["--normals", "1,2", "--cylinder", 0.8, "--max-distance", 2, "--registration-error", 0.005]
    words += ["-o", files / "out.npz", "--device", device]
    report = answer("change", files / "before.npz", files / "after.npz", *words)
    before, after = (loom.read_point_cloud(files / f"{name}.npz") for name in ("before", "after"))
    expected = loom.m3c2(before, after, **sizes)
    cloud = loom.read_point_cloud(files / "out.npz")
    np.testing.assert_array_equal(cloud["distance"], expected.distances.astype(np.float32))
    np.testing.assert_array_equal(cloud["significant"] != 0, expected.is_significant)
    np.testing.assert_array_equal(cloud["intensity"], before["intensity"])
    np.testing.assert_array_equal(cloud["points_after"], expected.counts[:, 1])
    known = np.isfinite(expected.distances).sum()
    assert (report["method"], report["cores"], report["known"]) == ("m3c2", 6000, known)
    assert report["significant"] == expected.is_significant.sum() and report["reliable"]
    assert -0.31 < report["median"] < -0.2
    sunk = (cloud.points[:, 0] - UTM[0] < 5) & (cloud.points[:, 1] - UTM[1] < 5)
    assert (cloud["significant"] != 0)[sunk].all() and (cloud["significant"] != 0)[~sunk].mean() < 0.2


def test_default_lengths_are_derived_from_the_points(files):
    words = ["--cores", "1", "--painted", files / "p.ply", "--picture", files / "c.png", "--report", files / "c.html"]
    report = answer("change", files / "before.npz", files / "after.npz", *words)
    page = (files / "c.html").read_text()
    assert f"{report['significant']:,} of {report['known']:,} points" in page and page.count("<img") == 1
    radius = report["lengths"]["cylinder_radius"]
    assert 2 * np.median(survey().compute_nearest_neighbor_distance()) < radius < 1
    assert report["lengths"]["normal_radii"] == pytest.approx([radius, 2 * radius, 4 * radius])
    painted = loom.read_point_cloud(files / "p.ply")
    assert len(painted) == report["cores"] and 400 <= len(painted) < 500
    colors = painted.colors.astype(float)
    gray = np.ptp(colors, axis=1) < 0.05
    assert 0.7 < gray.mean() < 0.95 and (colors[~gray, 2] > colors[~gray, 0]).mean() > 0.8  # blue: below
    assert loom.read_color(files / "c.png").shape == (960, 1280, 3)


def test_a_cloud_is_compared_with_a_mesh(files):
    corners = np.array([[0, 0, 0], [20, 0, 4], [20, 20, 4], [0, 20, 0.0]]) + UTM
    loom.write_triangle_mesh(files / "design.ply", loom.TriangleMesh(corners, [[0, 1, 2], [0, 2, 3]]))
    words = ["--cylinder", "0.8", "-o", files / "out.npz"]
    report = answer("change", files / "design.ply", files / "after.npz", *words)
    assert report["method"] == "cloud to mesh" and report["lengths"] == {"radius": 0.8}
    cloud = loom.read_point_cloud(files / "out.npz")
    sunk = (cloud.points[:, 0] - UTM[0] < 5) & (cloud.points[:, 1] - UTM[1] < 5)
    np.testing.assert_allclose(cloud["distance"][sunk], -0.3 / np.sqrt(1.04), atol=0.01)
    assert (cloud["significant"] != 0)[sunk].mean() > 0.95
    assert "Pass the mesh first" in refusal("change", files / "after.npz", files / "design.ply")


def test_unregistered_or_separate_epochs_are_unreliable(files):
    report = unreliable("change", files / "before.npz", files / "lifted.npz")
    (warning,) = report["warnings"]
    assert "moved forward, by 0.49" in warning and "register the epochs first" in warning
    assert answer("change", files / "before.npz", files / "lifted.npz", "--registration-error", "0.4")["reliable"]
    loom.write_point_cloud(files / "far.npz", survey().translate([0, 0, 50.0]))
    report = unreliable("change", files / "before.npz", files / "far.npz", "-o", files / "out.npz")
    assert (
        report["known"] == 0 and "core points have a distance" in str(report["warnings"]) and report["median"] is None
    )
    assert np.isnan(loom.read_point_cloud(files / "out.npz")["distance"]).all()


def test_clouds_that_cannot_be_compared_are_an_error(files, tmp_path):
    loom.write_point_cloud(files / "one.npz", loom.PointCloud(np.tile(UTM, (30, 1))))
    assert "Pass --cylinder" in refusal("change", files / "one.npz", files / "after.npz")
    loom.write_point_cloud(files / "none.npz", loom.PointCloud(np.full((3, 3), np.nan)))
    assert "no finite point" in refusal("change", files / "before.npz", files / "none.npz")
    assert "out.xyz" in refusal("change", files / "before.npz", files / "after.npz", "-o", files / "out.xyz")
    laspy, pyproj = pytest.importorskip("laspy"), pytest.importorskip("pyproj")
    paths = []
    for number, code in enumerate((25832, 25833)):
        paths.append(tmp_path / f"{number}.laz")
        loom.write_point_cloud(paths[-1], survey(count=500))
        content = laspy.read(paths[-1])
        content.header.add_crs(pyproj.CRS.from_epsg(code))
        content.write(paths[-1])
    assert "and ETRS89 / UTM zone 33N" in refusal("change", *paths)

"""register, multiway, odometry and evaluate: what they find, what they write, what they tell, and what they refuse."""

import io
import json
import sys
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner, Result
from PIL import Image

import pointloom as loom
from pointloom.app import console
from pointloom.app.cli import cli
from pointloom.app.odometry import odometry_of_folder
from pointloom.app.register import METHODS, choose_voxel_size, register_files
from pointloom.pcd.io.trajectory import Trajectory, read_trajectory, write_trajectory

reg = loom.registration

COMMANDS = ("register", "multiway", "odometry", "evaluate")


def run(*words: object) -> Result:
    return CliRunner().invoke(cli, [str(word) for word in words])


def answer(*words: object) -> dict:
    """The one JSON object of a command that succeeds."""
    result = run(*words, "--json")
    assert result.exit_code == 0, result.stderr
    return json.loads(result.stdout)


def poor_answer(*words: object) -> dict:
    """The one JSON object of a command that is done with a poor result, which stderr tells too."""
    result = run(*words, "--json")
    assert result.exit_code == 3, result.stderr
    report = json.loads(result.stdout)
    assert result.stderr == f"poor result: {report['poor']}\n"
    return report


def refusal(*words: object) -> str:
    """What a command says on stderr that ends with an error."""
    result = run(*words)
    assert result.exit_code == 1, result.stdout
    assert result.stdout == ""
    return result.stderr


def names_in(folder: Path) -> list[str]:
    return sorted(entry.name for entry in folder.iterdir())


def turned(angle: float, *shift: float) -> np.ndarray:
    """The pose that turns about z [degrees] and shifts [m]."""
    T, (c, s) = np.eye(4), (np.cos(np.radians(angle)), np.sin(np.radians(angle)))
    T[:2, :2], T[:3, 3] = [[c, -s], [s, c]], shift
    return T


def moved(points: np.ndarray, T: np.ndarray) -> np.ndarray:
    return points @ T[:3, :3].T + T[:3, 3]


def bumpy(rng: np.random.Generator, count: int = 8000) -> np.ndarray:
    """Points on a 2 x 2 m surface that fixes all six motions and looks like itself nowhere else."""
    x, y = rng.uniform(-1, 1, (2, count))
    return np.column_stack([x, y, 0.2 * np.sin(3 * x) * np.cos(4 * y) + 0.1 * np.sin(7 * y + x)])


def colors_at(points: np.ndarray) -> np.ndarray:
    return 0.5 + 0.4 * np.sin(points * [3, 4, 0] + 1)


POSE = turned(90, 5, 0, 0)  # of the target from the source: far beyond what ICP finds by itself
NEAR = turned(2, 0.02, -0.03, 0.01)
VOXEL = ["--voxel", 0.06]


@pytest.fixture
def pair(tmp_path, rng) -> tuple[Path, Path]:
    """Two thirds of a surface that overlap by one third, the first of them under POSE's inverse, with attributes."""
    points = bumpy(rng)
    target, source = points[points[:, 0] < 0.4], points[points[:, 0] > -0.4]
    paths = tmp_path / "a.ply", tmp_path / "b.ply"
    attributes = {"time": np.arange(len(source)) / 3}
    colors = colors_at(source)
    cloud = loom.PointCloud(moved(source, np.linalg.inv(POSE)), colors=colors, **attributes)
    loom.write_point_cloud(paths[0], cloud)
    loom.write_point_cloud(paths[1], loom.PointCloud(target, colors=colors_at(target)))
    return paths


@pytest.fixture
def near(tmp_path, rng) -> tuple[Path, Path]:
    """A surface sampled twice, the second 2 degrees and 4 cm off, with colours."""
    paths = tmp_path / "a.ply", tmp_path / "b.ply"
    for path, points, T in zip(paths, (bumpy(rng), bumpy(rng)), (np.linalg.inv(NEAR), np.eye(4)), strict=True):
        loom.write_point_cloud(path, loom.PointCloud(moved(points, T), colors=colors_at(points)))
    return paths


# ------------------------------------------------------------------------------------------------ register


def test_register_finds_the_pose_from_anywhere(pair, tmp_path, device):
    pose, aligned = tmp_path / "T.txt", tmp_path / "moved.ply"
    report = answer("register", *pair, *VOXEL, "-o", pose, "--aligned", aligned, "--device", device)
    T = np.loadtxt(pose)
    np.testing.assert_array_equal(T, report["transformation"])  # all digits
    np.testing.assert_allclose(T, POSE, atol=0.01)
    assert report["files"] == [str(pose), str(aligned)]
    assert (report["init"], report["method"], report["voxel_size"]) == ("global", "point-to-plane", 0.06)
    assert report["score"] > 0.5
    assert 0.4 < report["fitness"] < 0.8  # the half that overlaps, and what lies within 2 voxels of it
    assert abs(report["rotation_deg"] - 90) < 0.5
    source, found = loom.read_point_cloud(pair[0]), loom.read_point_cloud(aligned)
    np.testing.assert_allclose(found.points, moved(source.points, T), atol=1e-5)
    np.testing.assert_array_equal(found["time"], source["time"])
    np.testing.assert_array_equal(found.colors, source.colors)


def test_the_same_pose_comes_out_of_every_run(pair):
    poses = [answer("register", *pair, *VOXEL)["transformation"] for _ in range(2)]
    assert poses[0] == poses[1]


def test_a_pose_file_starts_another_run(pair, tmp_path):
    np.savetxt(tmp_path / "T.txt", POSE @ NEAR, fmt="%.4f")
    report = answer("register", *pair, *VOXEL, "--init", tmp_path / "T.txt", "-o", tmp_path / "T.txt", "--force")
    np.testing.assert_allclose(np.loadtxt(tmp_path / "T.txt"), POSE, atol=0.01)
    assert "search" not in report["seconds"]
    assert report["iterations"] > 3
    assert run("info", tmp_path / "T.txt").exit_code == 0


@pytest.mark.parametrize(
    ("method", "estimated"),
    [
        ("point-to-point", []),
        ("point-to-plane", ["target"]),
        ("symmetric", ["source", "target"]),
        ("generalized", []),
        ("colored", ["target"]),
    ],
)
def test_each_method_refines_a_start_nearby(near, method, estimated):
    assert method in METHODS
    report = answer("register", *near, *VOXEL, "--init", "identity", "--method", method)
    np.testing.assert_allclose(report["transformation"], NEAR, atol=0.01)
    assert report["normals_estimated"] == estimated
    assert (report["normal_radius"] is None) == (not estimated)
    assert report["distance"] == 0.12


def test_normals_of_the_file_are_used(near, tmp_path):
    with_normals = tmp_path / "n.ply"
    assert run("normals", near[1], with_normals).exit_code == 0
    report = answer("register", near[0], with_normals, *VOXEL, "--init", "identity")
    assert report["normals_estimated"] == []
    np.testing.assert_allclose(report["transformation"], NEAR, atol=0.01)


def test_a_distance_that_is_given_is_the_only_one(near):
    report = answer("register", *near, *VOXEL, "--init", "identity", "--distance", "0.2")
    clouds = [loom.read_point_cloud(path).voxel_down_sample(0.06) for path in near]
    normals = clouds[1].estimate_normals(radius=3 * 0.06, max_nn=30)
    expected = reg.registration_icp(
        clouds[0], normals, 0.2, estimation_method=reg.TransformationEstimationPointToPlane()
    )
    np.testing.assert_array_equal(report["transformation"], expected.transformation)
    assert report["iterations"] == expected.iterations


def test_a_start_that_was_given_is_refined_from_coarse_to_fine(near, tmp_path):
    np.savetxt(tmp_path / "T.txt", turned(5, 0.1, 0, 0.35) @ NEAR)
    words = ["register", *near, *VOXEL, "--init", tmp_path / "T.txt", "--method", "point-to-plane"]
    np.testing.assert_allclose(answer(*words)["transformation"], NEAR, atol=0.01)
    result = run(*words, "--distance", "0.12", "--json")  # at once, it does not get there
    assert np.abs(np.array(json.loads(result.stdout)["transformation"]) - NEAR).max() > 0.02


def test_the_voxel_size_is_chosen_from_the_clouds_and_told(near, rng):
    clouds = [loom.read_point_cloud(path) for path in near]
    size = choose_voxel_size(*clouds)
    assert 0.02 < size < 0.05  # three quarters of the points lie within a metre of the middle
    report = answer("register", *near, "--init", "identity")
    assert (report["voxel_size"], report["voxel_size_given"]) == (size, False)
    large = loom.PointCloud(clouds[0].points * 100)
    alone = [choose_voxel_size(cloud) for cloud in clouds]
    assert size == min(alone)
    assert choose_voxel_size(large) == pytest.approx(100 * alone[0], rel=0.1)
    assert choose_voxel_size(*clouds, large) == max(alone)  # the median
    sparse = loom.PointCloud(rng.random((60, 3)))
    spacing = np.linalg.norm(sparse.points[:, None] - sparse.points, axis=2)
    np.fill_diagonal(spacing, np.inf)
    assert choose_voxel_size(sparse) >= np.median(spacing.min(axis=1))


def test_a_summary_tells_how_the_pose_came_about(near, tmp_path):
    words = ["register", *near, "--init", "identity", "--picture", tmp_path / "a.png", "-o", tmp_path / "T.txt"]
    shown = run(*words)
    assert shown.exit_code == 0, shown.stderr
    assert shown.stderr == ""
    rows = np.loadtxt(tmp_path / "T.txt")
    for words in (
        "8,000 onto 8,000",
        "chosen from the clouds",
        "start    identity",
        "normals of the target estimated, radius 0.",
        "converged",
        f"{rows[0][0]:.9f}",
        f"{rows[1][3]:.9f}",
        "on cpu",
        "T.txt, ",
    ):
        assert words in shown.stdout


def test_the_picture_shows_both_clouds_before_and_after(near, tmp_path):
    far = tmp_path / "far.ply"
    cloud = loom.read_point_cloud(near[0])
    loom.write_point_cloud(far, cloud.transform(turned(0, 0, 0, 1)))
    answer("register", far, near[1], *VOXEL, "--picture", tmp_path / "a.png")
    image = np.asarray(Image.open(tmp_path / "a.png")).astype(int)
    assert image.shape == (960, 1928, 3)
    sides = []
    for half in (image[:, :960], image[:, 968:]):
        is_orange, is_blue = half[..., 0] - half[..., 2] > 100, half[..., 2] - half[..., 0] > 100
        assert min(is_orange.sum(), is_blue.sum()) > 5000
        sides.append(abs(np.argwhere(is_orange).mean(axis=0) - np.argwhere(is_blue).mean(axis=0)).max())
    assert sides[0] > 60 > 20 > sides[1]  # [px] apart before, together after


def test_coordinates_of_maps_do_no_harm(near, tmp_path):
    place = np.array([5e5, 5.4e6, 300])
    for path in near:
        cloud = loom.read_point_cloud(path)
        loom.write_point_cloud(path, loom.PointCloud(cloud.points + place), overwrite=True)
    expected = turned(0, *place) @ NEAR @ turned(0, *-place)
    report = answer("register", *near, *VOXEL, "--init", "identity", "--aligned", tmp_path / "c.ply")
    T = np.array(report["transformation"])
    np.testing.assert_allclose(moved(place, T), moved(place, expected), atol=0.01)
    assert report["shift_m"] < 0.1  # where the cloud is, not at zero
    found, source = loom.read_point_cloud(tmp_path / "c.ply").points, loom.read_point_cloud(near[0]).points
    np.testing.assert_allclose(found, moved(source, T), atol=1e-5)


def test_the_vertices_of_a_mesh_count(near, tmp_path):
    vertices = loom.read_point_cloud(near[0]).points
    loom.write_triangle_mesh(tmp_path / "m.ply", loom.TriangleMesh(vertices, [[0, 1, 2]]))
    report = answer("register", tmp_path / "m.ply", near[1], *VOXEL, "--init", "identity")
    np.testing.assert_allclose(report["transformation"], NEAR, atol=0.01)


def test_scans_of_kitti_are_clouds_too(near, tmp_path):
    points = loom.read_point_cloud(near[0]).points
    np.column_stack([points, np.arange(len(points))]).astype(np.float32).tofile(tmp_path / "a.bin")
    words = ["register", tmp_path / "a.bin", near[1], *VOXEL, "--init", "identity", "--aligned", tmp_path / "c.ply"]
    np.testing.assert_allclose(answer(*words)["transformation"], NEAR, atol=0.01)
    assert loom.read_point_cloud(tmp_path / "c.ply")["intensity"].tolist() == list(range(len(points)))


def test_a_cloud_lies_on_itself(near):
    report = answer("register", near[0], near[0], *VOXEL, "--init", "identity")
    np.testing.assert_allclose(report["transformation"], np.eye(4), atol=1e-6)
    assert report["fitness"] == 1


def test_surfaces_that_do_not_meet_are_a_poor_result_that_is_written(pair, tmp_path):
    np.savetxt(tmp_path / "T.txt", turned(120, 0.3, 0.3, 0) @ POSE)
    report = poor_answer("register", *pair, *VOXEL, "--init", tmp_path / "T.txt", "-o", tmp_path / "out.txt")
    assert "below 0.5: the surfaces hardly lie on each other; try --init global" in report["poor"]
    assert report["score"] < 0.5
    np.testing.assert_array_equal(np.loadtxt(tmp_path / "out.txt"), report["transformation"])


def test_clouds_of_different_scenes_are_a_poor_result(pair, tmp_path, rng):
    loom.write_point_cloud(tmp_path / "c.ply", loom.PointCloud(rng.random((6000, 3))))
    report = poor_answer("register", tmp_path / "c.ply", pair[1], *VOXEL)
    assert "try another --voxel" in report["poor"]


def test_without_a_correspondence_nothing_is_written(pair, tmp_path):
    outputs = ["-o", tmp_path / "T.txt", "--aligned", tmp_path / "c.ply", "--picture", tmp_path / "p.png"]
    report = poor_answer("register", *pair, *VOXEL, "--init", "identity", *outputs)
    assert report["files"] == []
    assert "no point of the source has a correspondence; nothing was written" in report["poor"]
    assert names_in(tmp_path) == ["a.ply", "b.ply"]


def test_a_small_share_of_correspondences_is_a_poor_result(near, tmp_path):
    target = loom.read_point_cloud(near[1]).points
    far = moved(target, turned(0, 0, 0, 50))
    loom.write_point_cloud(tmp_path / "c.ply", loom.PointCloud(np.vstack([target[:80], far])))
    report = poor_answer("register", tmp_path / "c.ply", near[1], *VOXEL, "--init", "identity")
    assert 0 < report["fitness"] < 0.1
    assert "of the source, less than 10%, has a correspondence" in report["poor"]


def test_register_tells_its_stages(near):
    stages = []
    report = register_files(*near, voxel_size=0.1, progress=lambda stage, done, total: stages.append(stage))
    assert stages == ["read", "search", "refine", "write"]
    assert list(report["seconds"]) == ["read", "voxels", "search", "refine", "rate", "write"]


@pytest.mark.parametrize(
    ("option", "name", "why"),
    [
        ("-o", "T.log", "poses are not written to .log"),
        ("--aligned", "c.docx", "clouds are not written to .docx"),
        ("--picture", "p.jpg", "pictures are written as .png"),
        ("-o", "none/T.txt", "the folder"),
    ],
)
def test_outputs_are_checked_before_the_clouds_are_read(tmp_path, option, name, why):
    assert why in refusal("register", tmp_path / "no.ply", tmp_path / "no.ply", option, tmp_path / name)


@pytest.mark.parametrize(("option", "name"), [("-o", "T.txt"), ("--aligned", "c.ply"), ("--picture", "p.png")])
def test_outputs_that_exist_are_kept_unless_forced(near, tmp_path, option, name):
    (tmp_path / name).write_bytes(b"kept")
    words = ["register", *near, *VOXEL, "--init", "identity", option, tmp_path / name]
    assert f"{name}: exists already" in refusal(*words)
    assert (tmp_path / name).read_bytes() == b"kept"
    answer(*words, "--force")
    assert (tmp_path / name).read_bytes() != b"kept"


def test_clouds_that_cannot_be_registered_are_named(near, tmp_path):
    write, bad = loom.write_point_cloud, tmp_path / "bad.ply"
    for points, why in (
        (np.empty((0, 3)), "bad.ply: holds no point, so"),
        (np.full((4, 3), np.nan), "bad.ply: holds 4 points, none of them finite"),
        (np.eye(3), "bad.ply: has points in 3 voxels of 0.06 m, and 10 are needed. Take a smaller --voxel"),
        (np.ones((50, 3)), "bad.ply: has points in 1 voxel of 0.06 m"),
    ):
        write(bad, loom.PointCloud(points), overwrite=True)
        assert why in refusal("register", near[0], bad, *VOXEL)
        assert why in refusal("register", bad, near[0], *VOXEL)
    assert "has points in 1 voxel of 1 m" in refusal("register", bad, bad)
    write(bad, loom.PointCloud(loom.read_point_cloud(near[0]).points), overwrite=True)
    assert "bad.ply: has no colours, which --method colored needs" in refusal(
        "register", near[0], bad, "--method", "colored"
    )
    bad.write_bytes(near[0].read_bytes()[:-1])
    assert refusal("register", near[0], bad, "-o", tmp_path / "T.txt").startswith(f"error: {bad}")
    assert names_in(tmp_path) == ["a.ply", "b.ply", "bad.ply"]


def test_a_start_that_is_no_pose_is_an_error(near, tmp_path):
    start = tmp_path / "T.txt"
    for text, why in (
        ("1 0 0 0\n" * 3, "expected 4 rows of a pose, got 3"),
        ("1 0 0 0\n" * 4, "expected a rigid motion"),
        ("1 0 0\n" * 4, "expected 4 numbers"),
        ("1 0 0 x\n" * 4, "not a number"),
    ):
        start.write_text(text)
        assert why in refusal("register", *near, "--init", start)


# ------------------------------------------------------------------------------------------------ all of them


@pytest.mark.parametrize("command", COMMANDS)
def test_every_command_explains_itself_with_an_example(command):
    shown = run(command, "-h").stdout
    assert f"\n  pointloom {command} " in shown
    assert "--json" in shown
    assert shown.isascii()
    assert f"  {command} " in run("-h").stdout


@pytest.mark.parametrize(
    ("words", "hint"),
    [
        ("register a.ply", "missing argument 'B'"),
        ("register a.ply b.ply --init globl", "--init: expected global, identity or a file of a pose, got 'globl'"),
        ("register a.ply b.ply --method icp", "'--method'"),
        ("register a.ply b.ply --voxel 0", "'--voxel': expected a length in metres above 0, got '0'"),
        ("register a.ply b.ply --distance nan", "'--distance'"),
        ("register a.ply b.ply --aligned c.png --picture ./c.png", "--picture is the file of --aligned, c.png"),
        ("multiway scans", "missing option '-o'"),
        ("multiway scans -o a.log --loops 0", "'--loops': expected a whole number from 1"),
        ("odometry scans", "missing option '-o'"),
        ("odometry scans -o a.txt --format log", "'--format'"),
        ("odometry scans -o a.txt --min-range -1", "'--min-range': expected a distance in metres, 0 or above"),
        ("odometry scans -o a.txt --min-range inf", "'--min-range'"),
        ("odometry scans -o a.txt --max-range 3", "--min-range 5 leaves nothing within --max-range 3"),
        ("evaluate a.txt", "missing argument 'TRUTH'"),
        ("evaluate a.txt b.txt --align umeyama", "'--align'"),
    ],
)
def test_a_wrong_call_exits_with_2_and_names_the_option(words, hint):
    result = run(*words.split())
    assert result.exit_code == 2
    assert result.stdout == ""
    first, *others = result.stderr.splitlines()
    assert first.startswith("error: ")
    assert hint in first
    assert others == [f"See 'pointloom {words.split()[0]} --help'."]


# ------------------------------------------------------------------------------------------------ odometry


def path_of(count: int) -> np.ndarray:
    """The poses of a scanner that turns and moves on."""
    return np.array([turned(2 * i, 0.1 * i, 0.02 * i * i, 0) for i in range(count)])


@pytest.fixture
def drive(tmp_path, rng) -> Path:
    """A folder of 5 scans of a room, .bin as KITTI has them, whose names have numbers without leading zeros."""
    room = rng.uniform(-8, 8, (5000, 3)) * [1, 1, 0.3]
    room[np.arange(5000), np.arange(5000) % 3] = np.where(rng.random(5000) < 0.5, -1, 1) * 8.0
    folder = tmp_path / "drive"
    folder.mkdir()
    for number, T in zip((8, 9, 10, 11, 100), path_of(5), strict=True):
        points = moved(room, np.linalg.inv(T))
        np.column_stack([points, np.ones(len(points))]).astype(np.float32).tofile(folder / f"scan{number}.bin")
    return folder


INDOORS = ["--max-range", 30, "--min-range", 0.5]


def test_odometry_writes_the_path_and_its_errors(drive, tmp_path, device):
    poses, truth = tmp_path / "poses.txt", tmp_path / "truth.tum"
    write_trajectory(truth, Trajectory(path_of(5)))
    report = answer("odometry", drive, "-o", poses, *INDOORS, "--truth", truth, "--device", device)
    found = read_trajectory(poses)
    np.testing.assert_allclose(found.poses, path_of(5), atol=0.02)
    expected = reg.run_odometry(drive, max_range=30, min_range=0.5)
    np.testing.assert_allclose(found.poses, expected.poses, atol=1e-5)
    assert (report["scans"], report["points"], report["predicted"]) == (5, 25000, [])
    assert report["errors"]["absolute"]["m"]["rmse"] < 0.01
    error = reg.evaluate_trajectory(found, Trajectory(path_of(5)))
    assert report["errors"]["relative"]["m"]["rmse"] == pytest.approx(error.relative_translation.rmse, rel=1e-6)
    assert report["files"] == [str(poses)]


def test_odometry_writes_tum_too_and_sums_up(drive, tmp_path):
    poses = tmp_path / "poses.txt"
    shown = run("odometry", drive, "-o", poses, "--format", "tum", *INDOORS)
    assert shown.exit_code == 0, shown.stderr
    assert read_trajectory(poses).timestamps.tolist() == [0, 1, 2, 3, 4]
    assert "5, 25,000 points, " in shown.stdout
    assert "scans/s" in shown.stdout
    assert "ATE" not in shown.stdout
    kitti = tmp_path / "poses.kitti"
    assert answer("odometry", drive, "-o", kitti, *INDOORS)["format"] == "kitti"
    np.testing.assert_allclose(read_trajectory(poses).poses, read_trajectory(kitti).poses, atol=1e-12)


def test_a_scan_that_does_not_overlap_is_a_poor_result(drive, tmp_path, rng):
    stray = np.column_stack([rng.uniform(20, 25, (500, 3)), np.ones(500)]).astype(np.float32)
    stray.tofile(drive / "scan10.bin")
    report = poor_answer("odometry", drive, "-o", tmp_path / "poses.txt", "--max-range", 50, "--min-range", 0.5)
    assert report["predicted"] == [2]
    assert "1 of 5 scans" in report["poor"]
    assert "torn at scan 2" in report["poor"]
    assert len(read_trajectory(tmp_path / "poses.txt")) == 5
    shown = run("odometry", drive, "-o", tmp_path / "b.txt", "--max-range", 50, "--min-range", 0.5)
    assert "predicted  1: scan 2" in shown.stdout


def test_scans_out_of_range_write_nothing(drive, tmp_path):
    truth = tmp_path / "truth.txt"
    write_trajectory(truth, Trajectory(path_of(5)), format="kitti")
    report = poor_answer("odometry", drive, "-o", tmp_path / "a.txt", "--min-range", 90, "--truth", truth)
    assert "no scan has points from 90 to 100 m of the scanner; nothing was written" in report["poor"]
    assert (report["files"], report["errors"]) == ([], None)
    assert not (tmp_path / "a.txt").exists()


def test_odometry_refuses_what_cannot_be_done_before_the_work(drive, tmp_path):
    poses, truth = tmp_path / "poses.txt", tmp_path / "truth.txt"
    assert "poses as kitti are not written to .log" in refusal("odometry", drive, "-o", tmp_path / "a.log")
    assert "poses as tum are not written to .kitti" in refusal(
        "odometry", drive, "-o", tmp_path / "a.kitti", "--format", "tum"
    )
    assert "does not exist" in refusal("odometry", tmp_path / "none", "-o", poses)
    write_trajectory(truth, Trajectory(path_of(4)), format="kitti")
    assert "has 4 poses, and " in refusal("odometry", drive, "-o", poses, "--truth", truth)
    poses.write_text("kept")
    assert "exists already" in refusal("odometry", drive, "-o", poses)
    for path in sorted(drive.iterdir())[1:]:
        path.unlink()
    assert "holds one scan, scan10.bin; odometry needs two" in refusal("odometry", drive, "-o", tmp_path / "a.txt")
    (drive / "scan9.bin").write_bytes(b"12345")
    assert "scan9.bin (byte 0): 5 bytes" in refusal("odometry", drive, "-o", tmp_path / "a.txt")
    assert names_in(tmp_path) == ["drive", "poses.txt", "truth.txt"]


def test_odometry_tells_each_scan(drive, tmp_path):
    told = []
    odometry_of_folder(
        drive, tmp_path / "a.txt", max_range=30, min_range=0.5, progress=lambda *words: told.append(words)
    )
    assert told == [("scans", done, 5) for done in range(6)]


def test_progress_tells_the_rate(monkeypatch, capsys):
    monkeypatch.setattr(console, "LINE_INTERVAL", 0.0)
    with console.Progress(rates=True) as progress:
        progress("scans", 3, 10)
    assert "scans: 3 of 10 " in (line := capsys.readouterr().err)
    assert line.endswith(" scans/s\n")

    class Terminal(io.StringIO):
        def isatty(self) -> bool:
            return True

    monkeypatch.setattr(sys, "stderr", screen := Terminal())
    monkeypatch.setenv("TERM", "xterm")
    with console.Progress(rates=True) as progress:
        progress("scans", 3, 10)
        progress("scans", 10, 10)
    assert "10/10" in screen.getvalue()
    assert " scans/s" in screen.getvalue()


# ------------------------------------------------------------------------------------------------ evaluate


@pytest.fixture
def paths(tmp_path) -> tuple[Path, Path]:
    """A path of 40 poses, 4 % too long and turned away, and the true one."""
    truth = path_of(40)
    estimate = turned(30, 1, 2, 3) @ truth
    estimate[:, :3, 3] = 1.04 * (estimate[:, :3, 3] - estimate[0, :3, 3]) + estimate[0, :3, 3]
    files = tmp_path / "poses.txt", tmp_path / "truth.log"
    write_trajectory(files[0], Trajectory(estimate), format="kitti")
    write_trajectory(files[1], Trajectory(truth))
    return files


@pytest.mark.parametrize(
    ("align", "options"),
    [
        ("none", {"align": None}),
        ("first", {"align": "first"}),
        ("se3", {}),
        ("sim3", {"with_scale": True}),
    ],
)
def test_evaluate_prints_what_the_library_finds(paths, align, options):
    report = answer("evaluate", *paths, "--align", align)
    expected = reg.evaluate_trajectory(read_trajectory(paths[0]), read_trajectory(paths[1]), **options)
    assert (report["align"], report["compared"], report["scale"]) == (align, 40, expected.scale)
    assert report["absolute"]["m"]["rmse"] == expected.absolute_translation.rmse
    assert report["absolute"]["deg"]["max"] == expected.absolute_rotation.max
    assert report["relative"]["m"]["median"] == expected.relative_translation.median
    np.testing.assert_array_equal(report["transformation"], expected.transformation)
    shown = run("evaluate", *paths, "--align", align).stdout
    assert f"40 poses, aligned by {align}" in shown
    assert f"ATE       {expected.absolute_translation.rmse:.4g} m rmse" in shown
    assert ("scale 0.961538" in shown) == (align == "sim3")


def test_segments_are_shown_for_lengths_that_the_path_has(tmp_path):
    poses = np.array([turned(0, 2 * i, 0, 0) for i in range(120)])
    write_trajectory(tmp_path / "b.txt", Trajectory(poses.copy()), format="kitti")
    poses[:, 0, 3] *= 1.01
    write_trajectory(tmp_path / "a.txt", Trajectory(poses), format="kitti")
    report = answer("evaluate", tmp_path / "a.txt", tmp_path / "b.txt")
    assert [segment["length_m"] for segment in report["segments"]] == [100, 200]
    assert report["segment_percent"] == pytest.approx(1.02, abs=0.02)  # of the first pose beyond each length
    assert "over 100, 200 m" in run("evaluate", tmp_path / "a.txt", tmp_path / "b.txt").stdout


def test_one_pose_has_no_relative_error(tmp_path):
    write_trajectory(tmp_path / "a.log", Trajectory(np.eye(4)[None]))
    assert answer("evaluate", tmp_path / "a.log", tmp_path / "a.log")["relative"]["m"]["rmse"] is None
    assert "RPE       none: too few poses" in run("evaluate", tmp_path / "a.log", tmp_path / "a.log").stdout


def test_trajectories_that_do_not_belong_together_are_an_error(paths, tmp_path):
    write_trajectory(tmp_path / "c.txt", Trajectory(path_of(7)), format="kitti")
    assert f"poses.txt: has 40 poses, and {tmp_path / 'c.txt'} has 7" in refusal(
        "evaluate", paths[0], tmp_path / "c.txt"
    )
    for name, start in (("a.tum", 0.0), ("b.tum", 1e6)):
        write_trajectory(tmp_path / name, Trajectory(path_of(7), timestamps=start + np.arange(7.0)))
    assert "cannot be compared with" in refusal("evaluate", tmp_path / "a.tum", tmp_path / "b.tum")
    assert "cannot be read" in refusal("evaluate", paths[0], tmp_path / "none.txt")


# ------------------------------------------------------------------------------------------------ multiway

PLACES = (turned(0, 0, 0, 0), turned(120, 3, 0, 1), turned(-70, -2, 5, 0))  # T_scene_cloud


@pytest.fixture
def views(tmp_path, rng) -> Path:
    """A folder of 3 clouds, each two thirds of one surface from another place, in names whose order is by number."""
    folder, points = tmp_path / "views", bumpy(rng)
    folder.mkdir()
    parts = (points[points[:, 0] < 0.4], points[points[:, 0] > -0.4], points[abs(points[:, 1]) < 0.7])
    for number, part, T in zip((2, 9, 10), parts, PLACES, strict=True):
        cloud = loom.PointCloud(moved(part, np.linalg.inv(T)), ring=np.full(len(part), number, np.uint8))
        if number == 9:
            cloud["time"] = np.zeros(len(part))
        loom.write_point_cloud(folder / f"view{number}.ply", cloud)
    return folder


def test_multiway_brings_all_clouds_into_one_frame(views, tmp_path):
    outputs = tmp_path / "poses.log", tmp_path / "graph.json", tmp_path / "all.ply"
    words = ["multiway", views, *VOXEL, "-o", outputs[0], "--graph", outputs[1], "--merged", outputs[2]]
    report = answer(*words)
    assert report["clouds"] == ["view2.ply", "view9.ply", "view10.ply"]
    assert (report["reference"], report["not_placed"], report["left_out"]) == ("view2.ply", [], ["time"])
    assert report["files"] == [str(path) for path in outputs]
    found = read_trajectory(outputs[0])
    assert found.ids is not None
    assert found.ids.tolist() == [[0, 0, 3], [1, 1, 3], [2, 2, 3]]
    for pose, T in zip(found.poses, PLACES, strict=True):
        np.testing.assert_allclose(pose, T, atol=0.02)
    graph = reg.read_pose_graph(outputs[1])
    assert (len(graph.nodes), len(graph.edges)) == (3, report["edges"])
    merged = loom.read_point_cloud(outputs[2])
    assert [(merged["ring"] == number).sum() for number in (2, 9, 10)] == [
        len(loom.read_point_cloud(views / name)) for name in report["clouds"]
    ]
    x, y, z = merged.points.T
    np.testing.assert_allclose(z, 0.2 * np.sin(3 * x) * np.cos(4 * y) + 0.1 * np.sin(7 * y + x), atol=0.03)
    shown = run(*words, "--force").stdout
    assert "3 of 3 placed" in shown
    assert "that of view2.ply" in shown
    assert "left out  time" in shown


def test_a_cloud_that_cannot_be_placed_is_a_poor_result(views, tmp_path, rng):
    loom.write_point_cloud(views / "view5.ply", loom.PointCloud(rng.random((4000, 3))))
    report = poor_answer("multiway", views, *VOXEL, "-o", tmp_path / "poses.log", "--loops", 3)
    assert report["not_placed"] == ["view5.ply"]
    assert "1 of 4 clouds could not be placed: view5.ply; try another --voxel" in report["poor"]
    assert [T is None for T in report["poses"]] == [False, True, False, False]
    ids = read_trajectory(tmp_path / "poses.log").ids
    assert ids is not None
    assert ids[:, 0].tolist() == [0, 2, 3]


def test_clouds_that_have_nothing_in_common_write_nothing(views, tmp_path, rng):
    for path in sorted(views.iterdir())[:2]:
        loom.write_point_cloud(path, loom.PointCloud(rng.random((4000, 3))))
    report = poor_answer("multiway", views, *VOXEL, "-o", tmp_path / "poses.log", "--merged", tmp_path / "all.ply")
    assert "no two of the 3 clouds lie on each other; nothing was written" in report["poor"]
    assert report["files"] == []
    assert names_in(tmp_path) == ["views"]


def test_multiway_refuses_what_cannot_be_done_before_the_work(views, tmp_path):
    output = tmp_path / "poses.log"
    assert "poses are not written to .txt" in refusal("multiway", views, "-o", tmp_path / "poses.txt")
    assert "where the next run would take it for one of the clouds" in refusal(
        "multiway", views, "-o", output, "--merged", views / "all.ply"
    )
    assert "pose graphs are not written to .txt" in refusal("multiway", views, "-o", output, "--graph", "g.txt")
    loom.write_point_cloud(views / "view3.ply", loom.PointCloud())
    assert "view3.ply: holds no point" in refusal("multiway", views, "-o", output)
    loom.write_point_cloud(views / "view3.pcd", loom.PointCloud())
    assert "holds files of several kinds: .pcd, .ply" in refusal("multiway", views, "-o", output)
    for path in [path for path in views.iterdir() if path.name != "view2.ply"]:
        path.unlink()
    assert "holds one cloud, view2.ply; two are needed" in refusal("multiway", views, "-o", output)
    assert names_in(tmp_path) == ["views"]

"""register, multiway, odometry, evaluate, stations and --record: poses, outputs, reports and errors."""

import dataclasses
import io
import json
import re
import sys
from pathlib import Path

import numpy as np
import pye57
import pytest
from PIL import Image

import pointloom as loom
from pointloom.cameras.trajectory import Trajectory, read_trajectory, write_trajectory
from pointloom.cli.shell import console
from pointloom.io.images.image_files import read_color
from pointloom.io.points.scan_files import list_scans
from pointloom.registration import LidarOdometry
from pointloom.registration.globally import pair as pair_module
from pointloom.registration.globally.pair import METHODS
from pointloom.registration.voxel_size import choose_voxel_size
from pointloom.visualization.render.plots import trajectory_plot

from ..products import few_quick
from ..registration.station_scenes import BOXES, COURT, scan_all
from .commands import answer, chosen_device, names_in, output_of, refusal, run, unreliable
from .surface_poses import NEAR, POSE, VOXEL, bumpy, colors_at, moved, path_of, yaw_pose


@pytest.fixture
def pair(tmp_path, rng) -> tuple[Path, Path]:
    """Two parts of a surface that overlap by one third; the first is moved by POSE's inverse and has attributes."""
    points = bumpy(rng)
    target, source = points[points[:, 0] < 0.4], points[points[:, 0] > -0.4]
    paths, times = (tmp_path / "a.ply", tmp_path / "b.ply"), np.arange(len(source)) / 3
    cloud = loom.PointCloud(moved(source, np.linalg.inv(POSE)), colors=colors_at(source), time=times)
    loom.write_point_cloud(paths[0], cloud)
    loom.write_point_cloud(paths[1], loom.PointCloud(target, colors=colors_at(target)))
    return paths


def test_register_finds_the_pose_from_anywhere(pair, tmp_path, device):
    pose, aligned = tmp_path / "T.txt", tmp_path / "moved.ply"
    report = answer("register", *pair, *VOXEL, "-o", pose, "--aligned", aligned, "--device", device)
    T = np.loadtxt(pose)
    np.testing.assert_array_equal(T, report["transformation"])  # all digits
    np.testing.assert_allclose(T, POSE, atol=0.01)
    assert report["files"] == [str(pose), str(aligned)]
    assert (report["init"], report["method"], report["voxel_size"]) == ("global", "point-to-plane", 0.06)
    assert report["score"] > 0.5 and abs(report["rotation_deg"] - 90) < 0.5
    assert 0.4 < report["fitness"] < 0.8  # the overlapping half and points within 2 voxels of it
    source, cloud = loom.read_point_cloud(pair[0]), loom.read_point_cloud(aligned)
    np.testing.assert_allclose(cloud.points, moved(source.points, T), atol=1e-5)
    np.testing.assert_array_equal(cloud["time"], source["time"])
    np.testing.assert_array_equal(cloud.colors, source.colors)


def test_a_pose_file_starts_another_run(pair, tmp_path):
    np.savetxt(tmp_path / "T.txt", POSE @ NEAR, fmt="%.4f")
    report = answer("register", *pair, *VOXEL, "--init", tmp_path / "T.txt", "-o", tmp_path / "T.txt", "--force")
    np.testing.assert_allclose(np.loadtxt(tmp_path / "T.txt"), POSE, atol=0.01)
    assert "search" not in report["seconds"] and report["iterations"] > 3
    assert run("info", tmp_path / "T.txt").exit_code == 0


def test_register_accepts_meshes_and_kitti_scans(near, tmp_path):
    source, target = (loom.read_point_cloud(path).points for path in near)
    np.column_stack([source, np.arange(len(source))]).astype(np.float32).tofile(tmp_path / "a.bin")
    loom.write_triangle_mesh(tmp_path / "m.ply", loom.TriangleMesh(target, [[0, 1, 2]]))
    words = ["register", tmp_path / "a.bin", tmp_path / "m.ply", *VOXEL, "--init", "identity"]
    np.testing.assert_allclose(answer(*words, "--aligned", tmp_path / "c.ply")["transformation"], NEAR, atol=0.01)
    assert loom.read_point_cloud(tmp_path / "c.ply")["intensity"].tolist() == list(range(len(source)))


@pytest.mark.parametrize("method", ["point-to-point", "symmetric", "colored"])
def test_each_method_refines_a_nearby_initial_pose(near, method):
    estimated = {"symmetric": ["source", "target"], "colored": ["target"]}.get(method, [])
    assert method in METHODS
    report = answer("register", *near, *VOXEL, "--init", "identity", "--method", method)
    np.testing.assert_allclose(report["transformation"], NEAR, atol=0.01)
    assert report["normals_estimated"] == estimated and (report["normal_radius"] is None) == (not estimated)
    assert report["max_correspondence_distance"] == 0.12


def test_a_given_distance_is_used_for_a_single_scale(near):
    report = answer("register", *near, *VOXEL, "--init", "identity", "--distance", "0.2")
    clouds = [loom.read_point_cloud(path, device="auto").voxel_down_sample(0.06) for path in near]
    normals = clouds[1].estimate_normals(radius=3 * 0.06, max_nn=30)
    estimation_method = loom.registration.TransformationEstimationPointToPlane()
    expected = loom.registration.registration_icp(clouds[0], normals, 0.2, estimation_method=estimation_method)
    np.testing.assert_array_equal(report["transformation"], expected.transformation)
    assert report["iterations"] == expected.iterations


def test_the_voxel_size_is_chosen_from_the_clouds_and_reported(near, rng):
    clouds = [loom.read_point_cloud(path) for path in near]
    size = choose_voxel_size(*clouds)
    assert 0.02 < size < 0.05  # three quarters of the points are within 1 m of the center
    report = answer("register", *near, "--init", "identity")
    assert (report["voxel_size"], report["voxel_size_given"]) == (size, False)
    large = loom.PointCloud(clouds[0].points * 100)
    alone = [choose_voxel_size(cloud) for cloud in clouds]
    assert size == min(alone) and choose_voxel_size(large) == pytest.approx(100 * alone[0], rel=0.1)
    assert choose_voxel_size(*clouds, large) == max(alone)  # the median
    sparse = loom.PointCloud(rng.random((60, 3)))
    spacing = np.linalg.norm(sparse.points[:, None] - sparse.points, axis=2)
    np.fill_diagonal(spacing, np.inf)
    assert choose_voxel_size(sparse) >= np.median(spacing.min(axis=1))


def test_the_summary_describes_the_registration(near, tmp_path):
    result = run("register", *near, "--init", "identity", "-o", tmp_path / "T.txt")
    assert (result.exit_code, result.stderr) == (0, "")
    rows = np.loadtxt(tmp_path / "T.txt")
    words = ["5,000 onto 5,000", "chosen from the clouds", "identity", "normals of the target estimated, radius 0."]
    words += ["converged", f"{rows[0][0]:.9f}", f"{rows[1][3]:.9f}", f"on {chosen_device()}", "T.txt"]
    assert [word for word in words if word not in result.stdout] == []


@pytest.mark.slow
def test_the_picture_shows_both_clouds_before_and_after(near, tmp_path):
    far = tmp_path / "far.ply"
    loom.write_point_cloud(far, loom.read_point_cloud(near[0]).transform(yaw_pose(0, 0, 0, 1)))
    answer("register", far, near[1], *VOXEL, "--picture", tmp_path / "a.png")
    image = np.asarray(Image.open(tmp_path / "a.png")).astype(int)
    assert image.shape == (960, 1928, 3)
    sides = []
    for half in (image[:, :960], image[:, 968:]):
        is_orange, is_blue = half[..., 0] - half[..., 2] > 100, half[..., 2] - half[..., 0] > 100
        assert min(is_orange.sum(), is_blue.sum()) > 5000
        sides.append(abs(np.argwhere(is_orange).mean(axis=0) - np.argwhere(is_blue).mean(axis=0)).max())
    assert sides[0] > 60 > 20 > sides[1]  # [px] apart before, together after


def test_surfaces_that_do_not_overlap_are_unreliable_and_written(pair, tmp_path):
    np.savetxt(tmp_path / "T.txt", yaw_pose(120, 0.3, 0.3, 0) @ POSE)
    report = unreliable("register", *pair, *VOXEL, "--init", tmp_path / "T.txt", "-o", tmp_path / "out.txt")
    assert "not above 0.5: the surfaces hardly overlap; try --init global" in str(report["warnings"])
    assert report["score"] < 0.5
    np.testing.assert_array_equal(np.loadtxt(tmp_path / "out.txt"), report["transformation"])


def test_without_a_correspondence_nothing_is_written(pair, tmp_path):
    outputs = ["-o", tmp_path / "T.txt", "--aligned", tmp_path / "c.ply", "--picture", tmp_path / "p.png"]
    report = unreliable("register", *pair, *VOXEL, "--init", "identity", *outputs)
    assert report["files"] == []
    assert "no point of the source has a correspondence; nothing was written" in str(report["warnings"])
    assert names_in(tmp_path) == ["a.ply", "b.ply"]


def test_a_small_share_of_correspondences_or_a_score_of_a_half_is_unreliable(near, tmp_path, monkeypatch):
    target = loom.read_point_cloud(near[1]).points
    far = moved(target, yaw_pose(0, 0, 0, 50))
    loom.write_point_cloud(tmp_path / "c.ply", loom.PointCloud(np.vstack([target[:80], far])))
    report = unreliable("register", tmp_path / "c.ply", near[1], *VOXEL, "--init", "identity")
    assert 0 < report["fitness"] < 0.1
    assert "of the source, less than 10%, has a correspondence" in str(report["warnings"])
    monkeypatch.setattr(pair_module, "score_registration", lambda *_: 0.5)
    assert unreliable("register", *near, *VOXEL, "--init", "identity")["score"] == 0.5


def test_outputs_are_checked_before_the_clouds_are_read(tmp_path):
    for option, name, why in (
        ("-o", "T.log", "poses are not written to .log"),
        ("--aligned", "c.docx", "clouds are not written to .docx"),
        ("--picture", "p.jpg", "expected .png or .webp"),
        ("-o", "none/T.txt", "the folder"),
    ):
        assert why in refusal("register", tmp_path / "no.ply", tmp_path / "no.ply", option, tmp_path / name)


def test_existing_outputs_are_not_overwritten_without_force(near, tmp_path):
    for option, name in (("-o", "T.txt"), ("--aligned", "c.ply")):
        (tmp_path / name).write_bytes(b"kept")
        words = ["register", *near, *VOXEL, "--init", "identity", option, tmp_path / name]
        assert f"{name}: exists already" in refusal(*words) and (tmp_path / name).read_bytes() == b"kept"
        answer(*words, "--force")
        assert (tmp_path / name).read_bytes() != b"kept"


def test_clouds_that_cannot_be_registered_are_named(near, tmp_path):
    write, bad = loom.write_point_cloud, tmp_path / "bad.ply"
    for points, why in (
        (np.empty((0, 3)), "bad.ply: expected finite points, got no points"),
        (np.full((4, 3), np.nan), "bad.ply: expected finite points, got 4 points, all of them not finite"),
        (np.eye(3), "bad.ply: has points in 3 voxels of 0.06 m, and 10 are needed. Use a smaller --voxel"),
        (np.ones((50, 3)), "bad.ply: has points in 1 voxel of 0.06 m"),
    ):
        write(bad, loom.PointCloud(points), overwrite=True)
        assert why in refusal("register", near[0], bad, *VOXEL) and why in refusal("register", bad, near[0], *VOXEL)
    assert "has points in 1 voxel of 1 m" in refusal("register", bad, bad)
    write(bad, loom.PointCloud(loom.read_point_cloud(near[0]).points), overwrite=True)
    refused = refusal("register", near[0], bad, "--method", "colored")
    assert "bad.ply: has no colors, which --method colored needs" in refused
    bad.write_bytes(near[0].read_bytes()[:-1])
    assert refusal("register", near[0], bad, "-o", tmp_path / "T.txt").startswith(f"error: {bad}")
    assert names_in(tmp_path) == ["a.ply", "b.ply", "bad.ply"]


def test_an_invalid_initial_pose_is_an_error(near, tmp_path):
    start = tmp_path / "T.txt"
    for rows, why in ((3, "expected 4 rows of a pose, got 3"), (4, "expected a rigid motion")):
        start.write_text("1 0 0 0\n" * rows)
        assert why in refusal("register", *near, "--init", start)


def test_fixed_degrees_of_freedom_keep_their_initial_values(near, tmp_path):
    np.savetxt(tmp_path / "start.txt", np.eye(4))
    report = answer("register", *near, *VOXEL, "--init", tmp_path / "start.txt", "--free", "x,y,z,yaw")
    T = np.array(report["transformation"])
    assert (T[2, :3] == [0, 0, 1]).all() and set(report["free"]) == {"x", "y", "z", "yaw"}
    np.testing.assert_allclose(T, NEAR, atol=0.06)
    assert answer("register", *near, *VOXEL, "--init", "identity")["free"] is None
    assert np.array(answer("register", *near, *VOXEL, "--free", "x, y, z, yaw")["transformation"])[2, 2] == 1


def test_a_prior_pose_constrains_a_plane(tmp_path, rng):
    floor = np.column_stack([rng.uniform(-2, 2, (4000, 2)), rng.normal(0, 1e-3, 4000)])
    paths = tmp_path / "a.ply", tmp_path / "b.ply"
    for path, shift in zip(paths, (0.1, 0.0), strict=True):
        loom.write_point_cloud(path, loom.PointCloud(floor - [shift, 0, 0]))
    np.savetxt(tmp_path / "gnss.txt", yaw_pose(0, 0.1, 0, 0))
    prior = "--prior", tmp_path / "gnss.txt", "--prior-sigma", "0.05", "1"
    report = unreliable("register", *paths, "--voxel", 0.1, "--init", "identity", *prior)  # planes are no evidence
    assert len(report["prior_directions"]) == 3
    np.testing.assert_allclose(np.array(report["transformation"])[:3, 3], [0.1, 0, 0], atol=0.01)


POSES = (yaw_pose(0, 0, 0, 0), yaw_pose(120, 3, 0, 1), yaw_pose(-70, -2, 5, 0))  # T_scene_cloud


@pytest.fixture
def views(tmp_path, rng) -> Path:
    """A folder of 3 clouds, each two thirds of a surface from another pose; their names sort by number."""
    folder, points = tmp_path / "views", bumpy(rng)
    folder.mkdir()
    parts = (points[points[:, 0] < 0.4], points[points[:, 0] > -0.4], points[abs(points[:, 1]) < 0.7])
    for number, part, T in zip((2, 9, 10), parts, POSES, strict=True):
        cloud = loom.PointCloud(moved(part, np.linalg.inv(T)), ring=np.full(len(part), number, np.uint8))
        if number == 9:
            cloud["time"] = np.zeros(len(part))
        loom.write_point_cloud(folder / f"view{number}.ply", cloud)
    return folder


def test_multiway_registers_all_clouds_into_one_frame(views, tmp_path):
    outputs = tmp_path / "poses.log", tmp_path / "graph.json", tmp_path / "all.ply"
    words = ["multiway", views, *VOXEL, "-o", outputs[0], "--graph", outputs[1], "--merged", outputs[2]]
    report = answer(*words)
    assert report["clouds"] == ["view2.ply", "view9.ply", "view10.ply"]
    assert (report["reference"], report["not_placed"], report["left_out"]) == ("view2.ply", [], ["time"])
    assert report["files"] == [str(path) for path in outputs]
    trajectory = read_trajectory(outputs[0])
    assert trajectory.ids is not None and trajectory.ids.tolist() == [[0, 0, 3], [1, 1, 3], [2, 2, 3]]
    for pose, T in zip(trajectory.poses, POSES, strict=True):
        np.testing.assert_allclose(pose, T, atol=0.02)
    graph = loom.registration.read_pose_graph(outputs[1])
    assert (len(graph.nodes), len(graph.edges)) == (3, report["edges"])
    merged = loom.read_point_cloud(outputs[2])
    counts = [len(loom.read_point_cloud(views / name)) for name in report["clouds"]]
    assert [(merged["ring"] == number).sum() for number in (2, 9, 10)] == counts
    x, y, z = merged.points.T
    np.testing.assert_allclose(z, 0.2 * np.sin(3 * x) * np.cos(4 * y) + 0.1 * np.sin(7 * y + x), atol=0.03)
    printed = run(*words, "--force").stdout
    assert "3 of 3 placed" in printed and "that of view2.ply" in printed and "left out  time" in printed


@pytest.mark.slow
def test_clouds_that_cannot_be_registered_are_unreliable(views, tmp_path, rng):
    loom.write_point_cloud(views / "view5.ply", loom.PointCloud(rng.random((4000, 3))))
    report = unreliable("multiway", views, *VOXEL, "-o", tmp_path / "poses.log", "--loops", 3)
    assert report["not_placed"] == ["view5.ply"]
    assert "1 of 4 clouds could not be registered: view5.ply; try another --voxel" in str(report["warnings"])
    assert [T is None for T in report["poses"]] == [False, True, False, False]
    ids = read_trajectory(tmp_path / "poses.log").ids
    assert ids is not None and ids[:, 0].tolist() == [0, 2, 3]
    for path in sorted(views.iterdir())[:3]:
        loom.write_point_cloud(path, loom.PointCloud(rng.random((4000, 3))))
    (tmp_path / "poses.log").unlink()
    report = unreliable("multiway", views, *VOXEL, "-o", tmp_path / "poses.log", "--merged", tmp_path / "all.ply")
    assert "no two of the 4 clouds overlap; nothing was written" in str(report["warnings"]) and report["files"] == []
    assert names_in(tmp_path) == ["views"]


def test_multiway_rejects_invalid_calls_first(views, tmp_path):
    output = tmp_path / "poses.log"
    assert "poses are not written to .csv" in refusal("multiway", views, "-o", tmp_path / "poses.csv")
    refused = refusal("multiway", views, "-o", output, "--merged", views / "all.ply")
    assert "the next run would read it as one of the clouds" in refused
    assert "pose graphs are not written to .txt" in refusal("multiway", views, "-o", output, "--graph", "g.txt")
    loom.write_point_cloud(views / "view3.ply", loom.PointCloud())
    assert "view3.ply: expected finite points, got no points" in refusal("multiway", views, "-o", output)
    loom.write_point_cloud(views / "view3.pcd", loom.PointCloud())
    assert "contains files of several types: .pcd, .ply" in refusal("multiway", views, "-o", output)
    for path in [path for path in views.iterdir() if path.name != "view2.ply"]:
        path.unlink()
    assert "expected at least two clouds, got view2.ply only" in refusal("multiway", views, "-o", output)
    assert names_in(tmp_path) == ["views"]


@pytest.mark.slow
def test_a_job_gives_the_poses_of_one_process_and_the_status_of_each_pair(views, tmp_path, rng):
    loom.write_point_cloud(views / "view20.ply", loom.PointCloud(rng.random((4000, 3))))
    initial = loom.Trajectory(np.array(POSES), ids=np.array([[k, k, 3] for k in range(3)]))
    loom.write_trajectory(tmp_path / "places.log", initial, format="log")
    how = ["multiway", views, *VOXEL, "--force", "-o"]
    unreliable(*how, tmp_path / "memory.log")
    by_job = [*how, tmp_path / "job.log", "--job", tmp_path / "job", "--device", "cpu"]
    report = unreliable(*by_job, "--places", tmp_path / "places.log", "--place-error", 0.1)
    assert (tmp_path / "job.log").read_bytes() == (tmp_path / "memory.log").read_bytes()
    assert report["not_placed"] == ["view20.ply"] and "could not be registered: view20.ply" in str(report["warnings"])
    statuses = {(pair["target"], pair["source"]): (pair["by"], pair["status"]) for pair in report["tried"]}
    assert len(statuses) == 6 and statuses["view2.ply", "view9.ply"] == ("place", "kept")
    by, status = statuses["view2.ply", "view20.ply"]
    assert by == "look" and status not in ("kept", "dropped", "apart", "")
    written = (tmp_path / "job.log").stat().st_mtime_ns
    assert unreliable(*by_job, "--places", tmp_path / "places.log", "--place-error", 0.1)["tried"] == report["tried"]
    assert (tmp_path / "job.log").stat().st_mtime_ns > written
    assert "--voxel 0.2" in refusal(*how, tmp_path / "other.log", "--job", tmp_path / "job", "--voxel", 0.2)


def test_an_unreadable_scan_stops_a_job_that_the_same_command_resumes(views, tmp_path):
    words = ["multiway", views, *VOXEL, "-o", tmp_path / "poses.log", "--job", tmp_path / "job", "--device", "cpu"]
    content = (views / "view9.ply").read_bytes()
    (views / "view9.ply").write_bytes(content[:5000])
    message = refusal(*words)
    assert "2 of 3 tasks done" in message and "view9.ply" in message and "run the same command again" in message
    (views / "view9.ply").write_bytes(content)
    assert answer(*words)["not_placed"] == []


def test_initial_poses_of_other_scans_are_rejected(views, tmp_path):
    words = ["multiway", views, *VOXEL, "-o", tmp_path / "poses.log", "--job", tmp_path / "job", "--places"]
    for name, numbers in (("high.log", [0, 3]), ("twice.log", [1, 1])):
        trajectory = loom.Trajectory(np.array(POSES[:2]), ids=np.array([[k, k, 3] for k in numbers]))
        loom.write_trajectory(tmp_path / name, trajectory, format="log")
        expected = f"{name}: expected poses with different numbers from 0 to 2, one per scan, got 2 poses"
        assert expected in refusal(*words, tmp_path / name)
    loom.write_trajectory(tmp_path / "few.kitti", loom.Trajectory(np.array(POSES[:2])), format="kitti")
    assert "few.kitti: expected poses" in refusal(*words, tmp_path / "few.kitti") and not (tmp_path / "job").exists()


INDOORS = ["--max-range", 30, "--min-range", 0.5]


def test_odometry_writes_the_trajectory_and_its_errors(drive, tmp_path, device):
    poses, truth = tmp_path / "poses.txt", tmp_path / "truth.tum"
    write_trajectory(truth, Trajectory(path_of(5)))
    report = unreliable("odometry", drive, "-o", poses, *INDOORS, "--truth", truth, "--device", device)
    assert "so few poses (5)" in str(report["warnings"])
    trajectory = read_trajectory(poses)
    np.testing.assert_allclose(trajectory.poses, path_of(5), atol=0.02)
    expected = loom.registration.run_odometry(drive, max_range=30, min_range=0.5)
    np.testing.assert_allclose(trajectory.poses, expected.poses, atol=1e-5)
    assert (report["scans"], report["points"], report["predicted"]) == (5, 25000, [])
    assert report["errors"]["absolute"]["m"]["rmse"] < 0.01
    error = loom.registration.evaluate_trajectory(trajectory, Trajectory(path_of(5)))
    assert report["errors"]["relative"]["m"]["rmse"] == pytest.approx(error.relative_translation.rmse, rel=1e-6)
    assert report["files"] == [str(poses)]


@pytest.mark.slow
def test_odometry_writes_each_format_and_a_summary(drive, tmp_path):
    shown = output_of("odometry", drive, "-o", tmp_path / "poses.txt", *INDOORS)
    assert "5, 25,000 points, " in shown and "scans/s" in shown and "ATE" not in shown
    tum = read_trajectory(tmp_path / "poses.txt")
    assert tum.timestamps.tolist() == [0, 1, 2, 3, 4]
    words = ["odometry", drive, *INDOORS, "-o"]
    for name, form in (("poses.kitti", "kitti"), ("00.txt", "kitti"), ("a.log", "log")):
        more = ["--format", "kitti"] if name == "00.txt" else []
        assert answer(*words, tmp_path / name, *more)["format"] == form
    assert (tmp_path / "00.txt").read_bytes() == (tmp_path / "poses.kitti").read_bytes()
    for name in ("poses.kitti", "a.log"):
        np.testing.assert_allclose(read_trajectory(tmp_path / name).poses, tum.poses, atol=1e-12)


def test_a_scan_that_does_not_overlap_is_unreliable(drive, tmp_path, rng):
    np.column_stack([rng.uniform(20, 25, (500, 3)), np.ones(500)]).astype(np.float32).tofile(drive / "scan10.bin")
    report = unreliable("odometry", drive, "-o", tmp_path / "poses.txt", "--max-range", 50, "--min-range", 0.5)
    assert report["predicted"] == [2] and "1 of 5 scans" in str(report["warnings"])
    assert "broken at scan 2" in str(report["warnings"]) and len(read_trajectory(tmp_path / "poses.txt")) == 5
    result = run("odometry", drive, "-o", tmp_path / "b.txt", "--max-range", 50, "--min-range", 0.5)
    assert "predicted  1: scan 2" in result.stdout


def test_map_writes_the_cloud_the_path_and_a_picture(drive, tmp_path):
    cloud, poses, picture = (tmp_path / name for name in ("map.laz", "path.tum", "map.png"))
    report = answer("map", drive, "-o", cloud, "--trajectory", poses, "--picture", picture, *INDOORS)
    np.testing.assert_allclose(read_trajectory(poses).poses, path_of(5), atol=0.02)
    assert len(loom.read_point_cloud(cloud)) == report["map_points"] > 1000
    assert read_color(picture).shape[2] == 3 and report["files"] == [str(cloud), str(poses), str(picture)]
    assert (report["scans"], report["submaps"], report["loops"], report["reliable"]) == (5, 1, [], True)
    assert "0 of 0 compared pairs" in output_of("map", drive, "-o", tmp_path / "b.ply", *INDOORS)


def test_sequences_of_kitti_have_the_scans_of_velodyne_and_the_times_of_their_file(drive, tmp_path):
    sequence = tmp_path / "00"
    sequence.mkdir()
    scans = list_scans(drive)
    drive.rename(sequence / "velodyne")
    for k, scan in enumerate(scans):  # the second is missing
        (sequence / "velodyne" / scan.name).rename(sequence / "velodyne" / f"{k + (k > 0):06d}.bin")
    (sequence / "calib.txt").write_text("P0: 1 2 3\n")
    times = sequence / "times.txt"
    times.write_text("".join(f"{0.1 * k:e}\n" for k in range(len(scans) + 1)))
    expected = [0.0, *(0.1 * k for k in range(2, len(scans) + 1))]
    for words in (("odometry", "-o"), ("map", "-o", tmp_path / "map.ply", "--trajectory")):
        output_of(words[0], sequence, *words[1:], tmp_path / f"{words[0]}.tum", *INDOORS)
        np.testing.assert_allclose(loom.read_trajectory(tmp_path / f"{words[0]}.tum").timestamps, expected)
    facts = answer("info", sequence)["files"][0]
    assert len(facts["files"]) == len(scans) and facts["duration_s"] == pytest.approx(expected[-1])
    for text, reason in (
        ("0\n0.1\n", r"times\.txt: has 2 times, and none for 000005\.bin"),
        (
            "".join(f"{-k}\n" for k in range(len(scans) + 1)),
            r"times\.txt: the time of 000002\.bin is -2 s, after -?0 s",
        ),
    ):
        times.write_text(text)
        assert re.search(reason, refusal("odometry", sequence, "-o", tmp_path / "p.tum", *INDOORS))


def test_map_shows_its_page_until_it_is_closed(drive, tmp_path, monkeypatch):
    shown = []

    def wait(viewer):
        shown.append((list(viewer.items), (tmp_path / "map.ply").exists()))

    monkeypatch.setattr("pointloom.visualization.viewer.draw.wait_for_pages", wait)
    result = run("map", drive, "-o", tmp_path / "map.ply", "--show", *INDOORS)
    assert shown == [(["map/0", "path"], True)] and "viewer: http://127.0.0.1" in result.stderr


@pytest.mark.slow
def test_map_takes_positions_and_continues_a_map(drive, tmp_path):
    submaps, positions, cloud = tmp_path / "submaps", tmp_path / "gnss.csv", tmp_path / "map.ply"
    rows = [(k, 100 + T[0, 3], 200 + T[1, 3], 5 + T[2, 3], 0.01) for k, T in enumerate(path_of(5))]
    positions.write_text("time,x,y,z,sigma\n" + "\n".join(",".join(map(str, row)) for row in rows))
    words = ["map", drive, "-o", cloud, "--submap-length", 0.1, *INDOORS, "--submaps", submaps]
    report = answer(*words, "--positions", positions)
    assert report["positions"]["used"] >= 4 and report["joined"] and str(submaps) in report["files"]
    T = np.array(report["T_reference_world"])
    np.testing.assert_allclose(T[:3, 3], [100, 200, 5], atol=0.05)
    local, trajectory = loom.read_point_cloud(cloud), tmp_path / "path.tum"
    words = ["map", drive, "-o", cloud, "--submap-length", 0.1, *INDOORS, "--force"]
    placed = answer(*words, "--positions", positions, "--crs", "EPSG:25832", "--trajectory", trajectory)
    there = loom.read_point_cloud(cloud)
    np.testing.assert_allclose(there.points, local.transform(T).points, atol=1e-4)
    assert there.crs == 25832 and placed["T_reference_world"] == report["T_reference_world"]
    np.testing.assert_allclose(loom.read_trajectory(trajectory).poses[0], T, atol=1e-6)
    assert "--crs is the coordinate system of --positions" in run(*words, "--crs", "EPSG:25832").stderr
    assert "--crs" in refusal(*words, "--positions", positions, "--crs", "nothing")
    words = ["map", drive, "-o", cloud, "--submap-length", 0.1, *INDOORS, "--submaps", submaps]
    result = run("map", drive, "-o", cloud, "--continue", submaps, "--force", "--positions", positions)
    assert "session" in result.stdout and "2, joined" in result.stdout and "the first scan is at" in result.stdout
    assert (result.exit_code, report["sessions"]) == (0, 1)
    assert "has a map already" in refusal(*words, "--force")
    wrong = run(*words[:4], "--force", "--continue", submaps, *INDOORS)
    assert wrong.exit_code == 2 and "--max-range is that of the map" in wrong.stderr
    (submaps / "map.npz").write_bytes(b"damaged")
    assert "map.npz" in refusal(*words[:4], "--force", "--continue", submaps)
    positions.write_text("1,2")
    assert "gnss.csv" in refusal("map", drive, "-o", tmp_path / "b.ply", "--positions", positions)
    late = tmp_path / "late.txt"
    late.write_text("900 0 0 0\n901 1 0 0\n")
    report = unreliable("map", drive, "-o", tmp_path / "b.ply", *INDOORS, "--positions", late)
    assert "the positions are from 900 to 901 s, the scans from " in str(report["warnings"])


def test_map_rejects_invalid_calls_first(drive, tmp_path):
    cloud = tmp_path / "map.ply"
    assert "poses are not written to .json" in refusal("map", drive, "-o", cloud, "--trajectory", tmp_path / "a.json")
    assert "clouds are not written to .png" in refusal("map", drive, "-o", tmp_path / "a.png")
    assert "does not exist" in refusal("map", tmp_path / "none", "-o", cloud)
    cloud.write_text("kept")
    assert "exists already" in refusal("map", drive, "-o", cloud)
    report = unreliable("map", drive, "-o", tmp_path / "b.ply", "--min-range", 90)
    assert report["files"] == [] and not (tmp_path / "b.ply").exists()


@pytest.mark.slow
def test_lost_odometry_is_unreliable_and_names_the_scans(real_file, tmp_path):
    folder = tmp_path / "submaps"
    folder.mkdir()
    for number in range(5):  # submaps of a drive, 3 to 12 m apart
        points = np.fromfile(real_file(f"reg-gtsam-points/kitti_07_dump/{number:06}/points.bin"), "<f4")
        loom.write_point_cloud(folder / f"{number}.ply", loom.PointCloud(points.reshape(-1, 3)[::3]))
    report = unreliable("odometry", folder, "-o", tmp_path / "a.txt", "--device", "cpu")
    assert report["strayed"][0] == 3  # the first two are rotated by 32 and 49 degrees, and registered
    assert "scans do not match the map of earlier scans (scan 3" in str(report["warnings"])
    assert "probably lost from scan 3 on" in str(report["warnings"])


def test_scans_that_do_not_converge_are_named(drive, tmp_path, monkeypatch):
    steps = iter([False, True, True, False, True, True])

    def not_converged(self, *args, **kwargs):
        step = match(self, *args, **kwargs)
        return dataclasses.replace(step, status="max_iteration", converged=False) if next(steps) else step

    match = LidarOdometry._match
    monkeypatch.setattr(LidarOdometry, "_match", not_converged)
    report = unreliable("odometry", drive, "-o", tmp_path / "a.txt", *INDOORS)
    assert report["unsettled"] == [1, 2, 4]
    assert report["warnings"] == ["3 of 5 scans did not converge on the map (scan 1-2, 4)"]
    steps = iter([False, False, True, False, False])
    assert run("odometry", drive, "-o", tmp_path / "b.txt", *INDOORS).exit_code == 3  # a quarter of four


def test_scans_out_of_range_write_nothing(drive, tmp_path):
    truth = tmp_path / "truth.txt"
    write_trajectory(truth, Trajectory(path_of(5)), format="kitti")
    report = unreliable("odometry", drive, "-o", tmp_path / "a.txt", "--min-range", 90, "--truth", truth)
    assert "no scan has points in range" in str(report["warnings"])
    assert (report["files"], report["errors"]) == ([], None) and not (tmp_path / "a.txt").exists()


def test_odometry_rejects_invalid_calls_first(drive, tmp_path):
    poses, truth = tmp_path / "poses.txt", tmp_path / "truth.txt"
    assert "poses are not written to .json" in refusal("odometry", drive, "-o", tmp_path / "a.json")
    refused = refusal("odometry", drive, "-o", tmp_path / "a.kitti", "--format", "tum")
    assert "poses as tum are not written to .kitti" in refused
    assert "does not exist" in refusal("odometry", tmp_path / "none", "-o", poses)
    write_trajectory(truth, Trajectory(path_of(4)), format="kitti")
    assert "expected 5 poses, one per scan of " in refusal("odometry", drive, "-o", poses, "--truth", truth)
    poses.write_text("kept")
    assert "exists already" in refusal("odometry", drive, "-o", poses)
    for path in sorted(drive.iterdir())[1:]:
        path.unlink()
    assert "expected at least two scans, got scan10.bin only" in refusal("odometry", drive, "-o", tmp_path / "a.txt")
    (drive / "scan9.bin").write_bytes(b"12345")
    assert "scan9.bin (byte 0): 5 bytes" in refusal("odometry", drive, "-o", tmp_path / "a.txt")
    assert names_in(tmp_path) == ["drive", "poses.txt", "truth.txt"]


def test_progress_reports_the_rate(monkeypatch, capsys):
    monkeypatch.setattr(console, "LINE_INTERVAL", 0.0)
    with console.Progress(rates=True) as progress:
        progress("scans", 3, 10)
    assert "scans: 3 of 10 " in (line := capsys.readouterr().err) and line.endswith(" scans/s\n")
    screen = io.StringIO()
    screen.isatty = lambda: True
    monkeypatch.setattr(sys, "stderr", screen)
    monkeypatch.setenv("TERM", "xterm")
    with console.Progress(rates=True) as progress:
        progress("scans", 3, 10)
        progress("scans", 10, 10)
    assert "10/10" in screen.getvalue() and " scans/s" in screen.getvalue()


FAR = np.array([456_000.0, 5_400_000.0, 300.0])
TARGETS = {"A": [2, -3, 0.5], "B": [9, 4, 1.5], "C": [16, 2, 2], "D": [5, 12, 1]}


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    """Three scans with approximate poses, a table of their targets, and the same with two names exchanged."""
    folder = tmp_path_factory.mktemp("stations")
    clouds, truth = scan_all(BOXES, COURT[:3], 1, columns=120, rows=40)
    truth[:, :3, 3] += FAR
    rough = truth.copy()
    rough[:, :3, 3] += np.random.default_rng(0).normal(0, 0.2, (3, 3))
    loom.write_stations(folder / "scans.e57", clouds, rough, names=["north", "mid", "east"])
    for file, swapped in (("right.csv", {}), ("wrong.csv", {"A": "B", "B": "A"})):
        rows = ["station;name;x;y;z;sigma"]
        for i, T in enumerate(truth):
            for name, position in TARGETS.items():
                x, y, z = T[:3, :3].T @ (np.array(position) + FAR - T[:3, 3])
                rows.append(f"{i};{swapped.get(name, name) if i == 1 else name};{x:.5f};{y:.5f};{z:.5f};0.002")
        (folder / file).write_text("\n".join(rows) + "\n")
    control = [f"{name} {x} {y} {z}" for name, (x, y, z) in ((n, np.array(p) + FAR) for n, p in TARGETS.items())]
    (folder / "control.csv").write_text("# a comment\n" + "\n".join(control))
    np.save(folder / "truth.npy", truth)
    return folder


@pytest.mark.slow
def test_scans_are_written_with_their_poses_and_a_report(files):
    words = ["--targets", files / "right.csv", "--control", files / "control.csv", "--voxel", 0.3, "--force"]
    words += ["-o", files / "out.e57", "--report", files / "report"]
    report = answer("stations", files / "scans.e57", *words)
    assert report["reliable"] and [s["name"] for s in report["stations"]] == ["north", "mid", "east"]
    before, after = loom.read_stations(files / "scans.e57"), loom.read_stations(files / "out.e57")
    assert np.abs(after.poses - np.load(files / "truth.npy"))[:, :3, 3].max() < 3e-3
    assert after.names == ("north", "mid", "east")
    for a, b in zip(before.clouds, after.clouds, strict=True):
        assert np.array_equal(a.points, b.points)
    with pye57.E57(str(files / "out.e57")) as file:  # as another library reads it
        assert np.abs(file.get_header(1).translation - after.poses[1][:3, 3]).max() < 1e-9
    assert "STATIONS" in (files / "report" / "report.txt").read_text()
    assert json.loads((files / "report" / "report.json").read_text())["redundancy"] == report["redundancy"]
    assert read_color(files / "report" / "plan.png").shape[:2] == (960, 1280)
    page = (files / "report" / "report.html").read_text()
    assert "STATIONS" in page and page.count("<img") == 1
    refused = run("stations", files / "scans.e57", "-o", files / "new.e57", "--report", files / "report")
    assert "--force" in refused.stderr


@pytest.mark.slow
def test_exchanged_names_cause_exit_code_3(files):
    words = ("--targets", files / "wrong.csv", "--control", files / "control.csv", "--voxel", 0.3, "--force")
    report = unreliable("stations", files / "scans.e57", "-o", files / "wrong.e57", *words)
    assert "look exchanged" in str(report["warnings"])
    assert {(o["name"], o["exchanged"]) for o in report["outliers"]} == {("A from mid", "B"), ("B from mid", "A")}


def test_invalid_calls_are_rejected(files):
    assert "--free" in run("stations", files / "scans.e57", "-o", files / "x.e57", "--free", "x,up").stderr
    assert "scans" in run("stations", files / "scans.e57", "-o", files / "scans.e57", "--force").stderr
    assert ".e57" in run("stations", files / "right.csv", "-o", files / "x.e57").stderr


@pytest.mark.slow
def test_register_records_every_iteration_and_finds_the_same_pose(near, tmp_path):
    file = tmp_path / "icp.gif"
    words = ["register", *near, *VOXEL, "--init", "identity"]
    alone = answer(*words)
    report = answer(*words, "--record", file, "-o", tmp_path / "T.txt")
    assert report["transformation"] == alone["transformation"]
    assert report["files"] == [str(tmp_path / "T.txt"), str(file)]
    with Image.open(file) as image:
        assert image.n_frames == report["iterations"] + 3  # three scales, each with its start


def test_register_records_a_search_as_a_start_and_a_result(near, tmp_path):
    file = tmp_path / "icp.html"
    assert str(file) in output_of("register", *near, *VOXEL, "--record", file)
    text = file.read_text()
    assert "initial poses" in text and "registered: converged" in text and "ICP, voxels of 0.06 m, iteration 1" in text


@pytest.mark.slow
def test_an_unreliable_result_is_recorded_too(tmp_path, rng):
    for k, offset in enumerate((0, 50)):
        loom.write_point_cloud(tmp_path / f"{k}.ply", loom.PointCloud(bumpy(rng) + np.array([offset, 0, 0])))
    words = [tmp_path / "0.ply", tmp_path / "1.ply", *VOXEL, "--init", "identity", "--record", tmp_path / "r.html"]
    assert unreliable("register", *words)["files"] == [str(tmp_path / "r.html")]


def test_odometry_records_scan_by_scan(drive, tmp_path):
    file, poses = tmp_path / "drive.html", tmp_path / "poses.txt"
    assert answer("odometry", drive, "-o", poses, *INDOORS, "--record", file)["files"] == [str(poses), str(file)]
    assert all(f'"label":"{one}' in file.read_text() for one in ("scan 0", "scan 1", "scan 4", "the map of 5 scans"))


@pytest.mark.slow
@pytest.mark.parametrize("command", ["fuse", "track", "reconstruct"])
def test_commands_of_frames_record_the_camera_and_the_surface(frames, tmp_path, command):
    file, output = tmp_path / "r.html", tmp_path / ("poses.txt" if command == "track" else "mesh.ply")
    result = run(command, frames, "-o", output, "--voxel", 0.08, "--record", file)
    assert result.exit_code in (0, 3), result.stderr
    assert str(file) in result.stdout
    text = file.read_text()
    assert '"camera"' in text and "the surface of" in text


def test_an_unwritable_recording_is_rejected_first_and_a_failure_before_the_first_frame_leaves_none(near, tmp_path):
    loom.write_point_cloud(tmp_path / "empty.ply", loom.PointCloud())
    refusal("register", tmp_path / "empty.ply", tmp_path / "empty.ply", "--record", tmp_path / "r.html")
    assert names_in(tmp_path) == ["a.ply", "b.ply", "empty.ply"]
    assert "does not exist" in refusal("register", *near, "--record", tmp_path / "no" / "r.gif")
    (tmp_path / "r.gif").write_bytes(b"keep")
    assert "exists already" in refusal("register", *near, "--record", tmp_path / "r.gif")
    assert (tmp_path / "r.gif").read_bytes() == b"keep"


@pytest.fixture
def paths(tmp_path) -> tuple[Path, Path]:
    """A trajectory of 40 poses, 4% too long and rotated, and the true one."""
    truth = path_of(40)
    estimate = yaw_pose(30, 1, 2, 3) @ truth
    estimate[:, :3, 3] = 1.04 * (estimate[:, :3, 3] - estimate[0, :3, 3]) + estimate[0, :3, 3]
    files = tmp_path / "poses.txt", tmp_path / "truth.log"
    write_trajectory(files[0], Trajectory(estimate), format="kitti")
    write_trajectory(files[1], Trajectory(truth))
    return files


ALIGNMENTS = {"none": {"align": None}, "first": {"align": "first"}, "se3": {}, "sim3": {"with_scale": True}}


@pytest.mark.parametrize("align", ALIGNMENTS)
def test_evaluate_matches_the_library(paths, align):
    options = ALIGNMENTS[align]
    report = answer("evaluate", *paths, "--alignment", align)
    expected = loom.registration.evaluate_trajectory(read_trajectory(paths[0]), read_trajectory(paths[1]), **options)
    assert (report["align"], report["compared"], report["scale"]) == (align, 40, expected.scale)
    assert report["absolute"]["m"]["rmse"] == expected.absolute_translation.rmse
    assert report["absolute"]["deg"]["max"] == expected.absolute_rotation.max
    assert report["relative"]["m"]["median"] == expected.relative_translation.median
    np.testing.assert_array_equal(report["transformation"], expected.transformation)
    printed = run("evaluate", *paths, "--alignment", align).stdout
    assert f"40 poses, aligned by {align}" in printed
    assert f"ATE       {expected.absolute_translation.rmse:.4g} m rmse" in printed
    assert ("scale 0.961538" in printed) == (align == "sim3")


def test_segments_and_relative_errors_are_printed_if_the_trajectory_is_long_enough(tmp_path):
    poses = np.array([yaw_pose(0, 2 * i, 0, 0) for i in range(120)])
    write_trajectory(tmp_path / "b.txt", Trajectory(poses.copy()), format="kitti")
    poses[:, 0, 3] *= 1.01
    write_trajectory(tmp_path / "a.txt", Trajectory(poses), format="kitti")
    report = answer("evaluate", tmp_path / "a.txt", tmp_path / "b.txt")
    assert [segment["length_m"] for segment in report["segments"]] == [100, 200]
    assert report["segment_percent"] == pytest.approx(1.02, abs=0.02)  # of the first pose beyond each length
    assert "over 100, 200 m" in run("evaluate", tmp_path / "a.txt", tmp_path / "b.txt").stdout
    write_trajectory(tmp_path / "a.log", Trajectory(np.eye(4)[None]))
    assert unreliable("evaluate", tmp_path / "a.log", tmp_path / "a.log")["relative"]["m"]["rmse"] is None
    assert "RPE       none: too few poses" in run("evaluate", tmp_path / "a.log", tmp_path / "a.log").stdout


@pytest.mark.slow
def test_a_picture_shows_the_aligned_estimate(paths, tmp_path):
    answer("evaluate", *paths, "--alignment", "sim3", "--picture", tmp_path / "path.png")
    estimate, truth = map(read_trajectory, paths)
    result = loom.registration.evaluate_trajectory(estimate, truth, with_scale=True)
    aligned = estimate.poses[:, :3, 3] @ result.transformation[:3, :3].T + result.transformation[:3, 3]
    title = "poses.txt against truth.log, aligned by sim3"
    expected = trajectory_plot(aligned, truth.poses[:, :3, 3], times=None, title=title)
    np.testing.assert_array_equal(read_color(tmp_path / "path.png"), expected)
    poses = path_of(20)
    write_trajectory(tmp_path / "truth.tum", Trajectory(poses, timestamps=np.arange(20.0)))
    write_trajectory(tmp_path / "part.tum", Trajectory(poses[5:16], timestamps=np.arange(5.0, 16.0)))
    report = answer("evaluate", tmp_path / "part.tum", tmp_path / "truth.tum", "--picture", tmp_path / "part.png")
    assert (report["compared"], report["truth_poses"]) == (11, 20) and read_color(tmp_path / "part.png").shape == (
        960,
        1280,
        3,
    )


def test_unrelated_trajectories_and_an_unwritable_picture_are_errors_before_the_inputs_are_read(paths, tmp_path):
    write_trajectory(tmp_path / "c.txt", Trajectory(path_of(7)), format="kitti")
    refused = refusal("evaluate", paths[0], tmp_path / "c.txt")
    assert f"poses.txt: has 40 poses, and {tmp_path / 'c.txt'} has 7" in refused
    for name, start in (("a.tum", 0.0), ("b.tum", 1e6)):
        write_trajectory(tmp_path / name, Trajectory(path_of(7), timestamps=start + np.arange(7.0)))
    assert "cannot be compared with" in refusal("evaluate", tmp_path / "a.tum", tmp_path / "b.tum")
    missing = tmp_path / "none.txt"  # is read after the picture is checked
    assert "cannot be read" in refusal("evaluate", paths[0], missing)
    assert "expected .png or .webp" in refusal("evaluate", missing, paths[1], "--picture", tmp_path / "a.jpg")
    assert "folder" in refusal("evaluate", missing, paths[1], "--picture", tmp_path / "nowhere" / "a.png")
    (tmp_path / "mine.png").write_text("mine")
    assert "--force" in refusal("evaluate", *paths, "--picture", tmp_path / "mine.png")
    assert (tmp_path / "mine.png").read_text() == "mine"


KITTI_TR = np.array([[0, -1, 0, 0.02], [0, 0, -1, -0.07], [1, 0, 0, -0.27], [0, 0, 0, 1.0]])


def steered(count=400, step=1.0, seed=0, noise=0.0):
    """The trajectory of a steering car, with optional noise on its motions."""
    rng = np.random.default_rng(seed)
    poses = [np.eye(4)]
    for i in range(count - 1):
        move = yaw_pose(np.degrees(0.004 * np.sin(i / 30)), step, 0, 0)
        move[:3, 3] += rng.normal(0, noise, 3)
        poses.append(poses[-1] @ move)
    return np.array(poses)


@pytest.mark.parametrize("Tr", [KITTI_TR, np.linalg.inv(KITTI_TR), yaw_pose(30, 0, 0, 0)])
@pytest.mark.parametrize("noise", [0.0, 0.02])
def test_trajectories_of_two_sensors_are_detected_and_compared_with_their_offset(Tr, noise):
    lidar = steered(noise=noise)
    camera = Trajectory(Tr @ steered() @ np.linalg.inv(Tr))
    error = loom.registration.evaluate_trajectory(Trajectory(lidar), camera)
    assert "--extrinsic" not in str(error.warnings) and "two sensors" in str(error.warnings)
    for extrinsic in (Tr, error.sensor_offset):
        better = loom.registration.evaluate_trajectory(Trajectory(lidar), camera, extrinsic=extrinsic)
        assert better.reliable and better.sensor_offset is None
        assert better.relative_translation.rmse < max(2 * noise, 0.01) < error.relative_translation.rmse


@pytest.mark.parametrize(
    "distort",
    [
        lambda poses: poses,
        lambda poses: yaw_pose(40, 5, 6, 7) @ poses,
        lambda poses: poses @ yaw_pose(0, 0, 0, 0),
        lambda poses: np.array([*poses[:200], *(yaw_pose(20, 3, 0, 0) @ poses[200:])]),
        lambda poses: np.where(np.arange(16).reshape(4, 4) % 4 == 3, poses * [[1.2], [1.2], [1.2], [1]], poses),
        lambda poses: steered(seed=3, noise=0.3),
        lambda poses: np.tile(np.eye(4), (len(poses), 1, 1)),
    ],
    ids=["same", "moved", "itself", "jump", "too long", "noise", "resting"],
)
def test_other_errors_are_not_reported_as_a_second_sensor(distort):
    truth = steered()
    assert loom.registration.evaluate_trajectory(Trajectory(distort(truth)), Trajectory(truth)).reliable


@few_quick(1, "key", ["Tr:", "Tr_velo_to_cam:", None])
def test_evaluate_accepts_the_extrinsic_of_kitti(tmp_path, key):
    lidar = steered(120)
    files = tmp_path / "lidar.kitti", tmp_path / "camera.kitti"
    for path, poses in zip(files, (lidar, KITTI_TR @ lidar @ np.linalg.inv(KITTI_TR)), strict=True):
        write_trajectory(path, Trajectory(poses))
    warning = unreliable("evaluate", *files)["warnings"][0]
    assert "two sensors" in warning and "extrinsic" in warning
    calib = tmp_path / "calib.txt"
    if key is None:
        np.savetxt(calib, KITTI_TR)
    else:
        row = " ".join(map(str, KITTI_TR[:3].ravel()))
        calib.write_text(f"P0: 1 0 0 0 0 1 0 0 0 0 1 0\n{key} {row}\n")
    report = answer("evaluate", *files, "--extrinsic", calib, "--picture", tmp_path / "a.png")
    assert report["segment_percent"] == pytest.approx(0, abs=1e-6) and report["reliable"]

"""multiway: registration of many clouds into one frame."""

from pathlib import Path

import numpy as np
import pytest

import pointloom as loom
from pointloom.cameras.trajectory import read_trajectory

from .commands import answer, names_in, refusal, run, unreliable
from .surface_poses import VOXEL, bumpy, moved, yaw_pose

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
    message = refusal(*how, tmp_path / "other.log", "--job", tmp_path / "job", "--voxel", 0.2)
    assert "voxel_size 0.2" in message


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

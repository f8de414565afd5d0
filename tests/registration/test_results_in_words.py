"""Text and JSON reports of results match the output of the commands."""

import json

import numpy as np
import pytest

import pointloom as loom
from pointloom.cameras.trajectory import Trajectory, write_trajectory
from pointloom.cli.jobs.evaluate import ALIGNMENTS
from pointloom.core.wording import json_text
from pointloom.registration.lidar.lidar_runs import iterate_odometry
from pointloom.registration.lidar.lidar_steps import summarize_steps
from pointloom.registration.pose_graphs.multiway import FragmentsResult

from ..cli.commands import answer, run
from ..cli.surface_poses import yaw_pose

reg = loom.registration


@pytest.fixture
def paths() -> tuple[Trajectory, Trajectory]:
    """A path of 120 poses, 1 % too long and rotated, and the true one."""
    truth = np.array([yaw_pose(0, 2 * i, 0, 0) for i in range(120)])
    estimate = yaw_pose(30, 1, 2, 3) @ truth
    estimate[:, :3, 3] *= 1.01
    return Trajectory(estimate), Trajectory(truth)


@pytest.mark.parametrize("align", ALIGNMENTS)
def test_trajectory_errors_match_the_evaluate_command(paths, tmp_path, align):
    files = tmp_path / "poses.txt", tmp_path / "truth.txt"
    for path, file in zip(paths, files, strict=True):
        write_trajectory(file, path, format="kitti")
    result = reg.evaluate_trajectory(*paths, **ALIGNMENTS[align])
    assert result.aligned_by == align
    assert f"{files[0]} against {files[1]}\n{result}\n" == run("evaluate", *files, "--alignment", align).stdout
    report = answer("evaluate", *files, "--alignment", align)
    assert {name: report[name] for name in result.to_dict()} == result.to_dict()


def test_errors_are_valid_json(paths):
    for count in (1, 2, 120):
        result = reg.evaluate_trajectory(*(Trajectory(path.poses[:count]) for path in paths))
        read = json.loads(json_text({"errors": result}))["errors"]
        assert read == result.to_dict() and len(read["segments"]) == len(result.segments)
        assert read["absolute"]["m"]["rmse"] == result.absolute_translation.rmse  # every digit
    single = reg.evaluate_trajectory(*(Trajectory(path.poses[:1]) for path in paths))
    assert single.fields()[2] == ("RPE", "none: too few poses")


def test_a_drive_without_overlap_reports_its_gaps():
    wall = loom.PointCloud([[10, 0.5 * i, 0.5 * j] for i in range(-20, 20) for j in range(20)])
    result = summarize_steps(list(iterate_odometry([wall, loom.PointCloud(), wall])))
    assert (result.empty, result.has_seen) == ((1,), True)
    torn, open_ways = result.warnings
    assert torn == (
        "1 of 3 scans do not overlap earlier scans, or have no points in range, so the path may be broken at scan 1"
    )
    assert open_ways.startswith("1 of 3 scans do not determine the motion along")  # of a single wall
    assert ("predicted", "1: scan 1") in result.fields()
    assert result.to_dict()["predicted"] == [1]
    nothing = summarize_steps(list(iterate_odometry([loom.PointCloud()] * 2)))
    assert (nothing.warnings, nothing.to_dict()["mean_fitness"]) == (("no scan has points in range",), None)
    assert [label for label, _ in nothing.fields()] == ["scans", "path", "predicted"]


@pytest.fixture
def partly_registered(rng) -> tuple[list[loom.PointCloud], FragmentsResult]:
    """Two parts of a surface, a cloud of noise between them, and their registration."""
    x, y = rng.uniform(-1, 1, (2, 6000))
    points = np.column_stack([x, y, 0.2 * np.sin(5 * x) * np.cos(4 * y) + 0.1 * np.sin(9 * y + x)])
    parts = points[x < 0.6], rng.random((900, 3)), points[x > -0.6] + [1, 2, 3]
    clouds = [loom.PointCloud(part, k=np.full(len(part), k, np.int32)) for k, part in enumerate(parts)]
    clouds[0]["more"] = np.zeros(len(parts[0]), np.float32)
    return clouds, reg.register_fragments(clouds, voxel_size=0.08)


def test_registered_clouds_are_merged(partly_registered):
    clouds, result = partly_registered
    assert result.placed.tolist() == [True, False, True]
    merged = result.merge(clouds)
    assert set(merged["k"].tolist()) == {0, 2} and list(merged.attributes) == ["k"]
    last = clouds[2].transform(result.poses[2]).points
    np.testing.assert_allclose(merged.points[merged["k"] == 2], last, atol=1e-6)
    np.testing.assert_array_equal(result.trajectory.poses, result.poses[result.placed])
    assert result.trajectory.ids is not None and result.trajectory.ids[:, 0].tolist() == [0, 2]
    for wrong, kind, message in (
        (clouds[:2], ValueError, "clouds: expected 3, as many as were registered, got 2"),
        ([*clouds[:2], 3], TypeError, r"clouds\[2\]: expected a PointCloud"),
        (None, TypeError, "clouds"),
    ):
        for method in (result.merge, result.pose_covariances):
            with pytest.raises(kind, match=message):
                method(wrong)


def test_clouds_are_called_by_number_or_by_name(partly_registered):
    result = partly_registered[1]
    assert "2 of 3 placed" in str(result) and "that of 0" in str(result)
    report = result.to_dict()
    assert (report["clouds"], report["not_placed"], report["reference"]) == ([0, 1, 2], [1], 0)
    named = result.to_dict(["a.ply", "b.ply", "c.ply"])
    assert (named["not_placed"], named["reference"], named["poses"][1]) == (["b.ply"], "a.ply", None)
    assert named["registered"][0]["target"] == "a.ply"

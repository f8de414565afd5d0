"""What results say of themselves, to people and to programs: the same as the commands print."""

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
from ..cli.surface_poses import turned

reg = loom.registration


@pytest.fixture
def paths() -> tuple[Trajectory, Trajectory]:
    """A path of 120 poses, 1 % too long and turned away, and the true one."""
    truth = np.array([turned(0, 2 * i, 0, 0) for i in range(120)])
    estimate = turned(30, 1, 2, 3) @ truth
    estimate[:, :3, 3] *= 1.01
    return Trajectory(estimate), Trajectory(truth)


@pytest.mark.parametrize("align", ALIGNMENTS)
def test_errors_of_a_path_are_what_evaluate_prints(paths, tmp_path, align):
    files = tmp_path / "poses.txt", tmp_path / "truth.txt"
    for path, file in zip(paths, files, strict=True):
        write_trajectory(file, path, format="kitti")
    found = reg.evaluate_trajectory(*paths, **ALIGNMENTS[align])
    assert found.aligned_by == align
    assert f"{files[0]} against {files[1]}\n{found}\n" == run("evaluate", *files, "--alignment", align).stdout
    report = answer("evaluate", *files, "--alignment", align)
    assert {name: report[name] for name in found.to_dict()} == found.to_dict()


def test_errors_survive_as_json(paths):
    for count in (1, 2, 120):
        found = reg.evaluate_trajectory(*(Trajectory(path.poses[:count]) for path in paths))
        read = json.loads(json_text({"errors": found}))["errors"]
        assert read == found.to_dict() and len(read["segments"]) == len(found.segments)
        assert read["absolute"]["m"]["rmse"] == found.absolute_translation.rmse  # every digit
    assert reg.evaluate_trajectory(*(Trajectory(path.poses[:1]) for path in paths)).fields()[2] == (
        "RPE",
        "none: too few poses",
    )


def test_a_drive_without_overlap_says_where_it_is_torn():
    wall = loom.PointCloud([[10, 0.5 * i, 0.5 * j] for i in range(-20, 20) for j in range(20)])
    found = summarize_steps(list(iterate_odometry([wall, loom.PointCloud(), wall])))
    assert (found.empty, found.has_seen) == ((1,), True)
    torn, open_ways = found.warnings
    assert torn == (
        "1 of 3 scans do not overlap earlier scans, or have no points in range, so the path may be broken at scan 1"
    )
    assert open_ways.startswith("1 of 3 scans do not determine the motion along")  # of a wall alone
    assert ("predicted", "1: scan 1") in found.fields()
    assert found.to_dict()["predicted"] == [1]
    nothing = summarize_steps(list(iterate_odometry([loom.PointCloud()] * 2)))
    assert (nothing.warnings, nothing.to_dict()["mean_fitness"]) == (("no scan has points in range",), None)
    assert [label for label, _ in nothing.fields()] == ["scans", "path", "predicted"]


@pytest.fixture
def placed(rng) -> tuple[list[loom.PointCloud], FragmentsResult]:
    """Two parts of a surface, a cloud of noise between them, and where they lie."""
    x, y = rng.uniform(-1, 1, (2, 6000))
    points = np.column_stack([x, y, 0.2 * np.sin(5 * x) * np.cos(4 * y) + 0.1 * np.sin(9 * y + x)])
    parts = points[x < 0.6], rng.random((900, 3)), points[x > -0.6] + [1, 2, 3]
    clouds = [loom.PointCloud(part, k=np.full(len(part), k, np.int32)) for k, part in enumerate(parts)]
    clouds[0]["more"] = np.zeros(len(parts[0]), np.float32)
    return clouds, reg.register_fragments(clouds, voxel_size=0.08)


def test_clouds_that_were_placed_come_as_one(placed):
    clouds, found = placed
    assert found.placed.tolist() == [True, False, True]
    merged = found.merge(clouds)
    assert set(merged["k"].tolist()) == {0, 2} and list(merged.attributes) == ["k"]
    last = clouds[2].transform(found.poses[2]).points
    np.testing.assert_allclose(merged.points[merged["k"] == 2], last, atol=1e-6)
    np.testing.assert_array_equal(found.trajectory.poses, found.poses[found.placed])
    assert found.trajectory.ids is not None and found.trajectory.ids[:, 0].tolist() == [0, 2]
    for wrong, kind, message in (
        (clouds[:2], ValueError, "clouds: expected 3, as many as were registered, got 2"),
        ([*clouds[:2], 3], TypeError, r"clouds\[2\]: expected a PointCloud"),
        (None, TypeError, "clouds"),
    ):
        with pytest.raises(kind, match=message):
            found.merge(wrong)


def test_clouds_are_called_by_number_or_by_name(placed):
    found = placed[1]
    assert "2 of 3 placed" in str(found) and "that of 0" in str(found)
    report = found.to_dict()
    assert (report["clouds"], report["not_placed"], report["reference"]) == ([0, 1, 2], [1], 0)
    named = found.to_dict(["a.ply", "b.ply", "c.ply"])
    assert (named["not_placed"], named["reference"], named["poses"][1]) == (["b.ply"], "a.ply", None)
    assert named["registered"][0]["target"] == "a.ply"

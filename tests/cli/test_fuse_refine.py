"""fuse --refine: given poses are refined on the model or left unchanged, and both are reported."""

from pathlib import Path

import numpy as np
import pytest

from pointloom.cameras.trajectory import read_trajectory
from pointloom.rgbd.fusion.refine import PoseRefinement

from .commands import answer, refusal, run, unreliable

COARSE = ["--voxel", 0.05]


def true_poses(folder: Path) -> np.ndarray:
    return np.array([np.loadtxt(path) for path in sorted(folder.glob("*.pose.txt"))])


def shift_poses(folder: Path, shifts) -> None:
    for path, shift in zip(sorted(folder.glob("*.pose.txt")), shifts, strict=True):
        T = np.loadtxt(path)
        T[:3, 3] += shift
        np.savetxt(path, T, fmt="%.17g")


def shifts_from(truth: np.ndarray, path: Path) -> np.ndarray:
    return np.linalg.norm(read_trajectory(path).poses[:, :3, 3] - truth[:, :3, 3], axis=1)


def test_inaccurate_poses_are_corrected(sequence_folder, tmp_path, rng, device):
    truth = true_poses(sequence_folder)
    shift_poses(sequence_folder, np.vstack([np.zeros(3), rng.normal(0, 0.015, (7, 3))]))
    given = np.linalg.norm(true_poses(sequence_folder)[1:, :3, 3] - truth[1:, :3, 3], axis=1)
    words = ["--refine", "--trajectory", tmp_path / "poses.log", "--device", device]
    report = answer("fuse", sequence_folder, "-o", tmp_path / "mesh.ply", "--voxel", 0.03, *words)
    refined = shifts_from(truth, tmp_path / "poses.log")
    assert refined[0] == 0 and np.median(refined[1:]) < 0.3 * np.median(given)
    figures = report["refinement"]
    assert (figures["refined"], figures["kept"]) == (7, [])
    assert figures["moved_m"] == pytest.approx(np.median(given), rel=0.5)
    assert report["files"] == [str(tmp_path / "mesh.ply"), str(tmp_path / "poses.log")]


def test_a_pose_that_does_not_fit_is_left_unchanged_and_counted(sequence_folder, tmp_path):
    shift_poses(sequence_folder, [[0, 0, 1.5] if i == 4 else [0, 0, 0] for i in range(8)])
    given = true_poses(sequence_folder)
    words = ["--refine", "--trajectory", tmp_path / "poses.txt"]
    report = answer("fuse", sequence_folder, "-o", tmp_path / "mesh.ply", *COARSE, *words)
    assert [entry["frame"] for entry in report["refinement"]["kept"]] == [4]
    np.testing.assert_allclose(read_trajectory(tmp_path / "poses.txt").poses[4], given[4], atol=1e-9)
    result = run("fuse", sequence_folder, "-o", tmp_path / "again.ply", *COARSE, "--refine", "--every", 2)
    assert result.exit_code == 0 and "2 refined, by " in result.stdout and "1 unchanged: frame " in result.stdout


def test_poses_that_all_disagree_are_unreliable(sequence_folder, tmp_path):
    shift_poses(sequence_folder, [[0, 0, 2.0 * i] for i in range(8)])
    report = unreliable("fuse", sequence_folder, "-o", tmp_path / "mesh.ply", *COARSE, "--refine")
    assert "7 of 8 poses could not be refined" in str(report["warnings"]) and report["triangles"] > 0


def test_without_refine_poses_are_unchanged_and_missing_poses_are_an_error(sequence_folder, tmp_path):
    words = ["-o", tmp_path / "mesh.ply", "--trajectory", tmp_path / "poses.log"]
    report = answer("fuse", sequence_folder, *COARSE, *words)
    assert report["refinement"] is None
    np.testing.assert_array_equal(read_trajectory(tmp_path / "poses.log").poses, true_poses(sequence_folder))
    for path in sequence_folder.glob("*.pose.txt"):
        path.unlink()
    assert "pointloom reconstruct" in refusal("fuse", sequence_folder, "-o", tmp_path / "a.ply", *COARSE)


@pytest.mark.parametrize(("unchanged", "is_unreliable"), [(0, False), (5, False), (6, True), (9, True)])
def test_more_than_half_of_the_poses_unchanged_is_unreliable(unchanged, is_unreliable):
    refined = (0.0,) * (10 - unchanged)
    refinement = PoseRefinement({i + 1: "r" for i in range(unchanged)}, refined, refined)
    assert refinement.frame_count == 11 and (not refinement.reliable) == is_unreliable

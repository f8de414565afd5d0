"""Reconstruction of a few real frames, some of which cannot be joined."""

import numpy as np
import pytest

import pointloom as loom

run_system = loom.reconstruction.run_system
Config = loom.reconstruction.ReconstructionConfig


def test_frames_of_redwood_give_a_model(tmp_path, scan_set, scan_file):
    frames = loom.open_frames(scan_file("rgbd-cupoch-redwood5"))
    report = run_system(frames, Config(tsdf_voxel_size=0.02), tmp_path)
    assert len(frames) == {"shipped": 3, "real": 5}[scan_set]
    assert (report.used, report.warnings) == (len(frames), ())
    assert report.trajectory_error["rmse"] < 0.005  # accuracy of the given poses


@pytest.mark.slow
def test_frames_of_3dmatch_far_apart_are_joined_or_listed(tmp_path, real_file):
    """Frames 0, 1, 2, 116 and 422: three follow each other, the fourth shares half with the third, the last nothing."""
    frames = loom.open_frames(real_file("rgbd-nvblox-3dmatch/seq-01"))
    report = run_system(frames, Config(tsdf_voxel_size=0.02, depth_max=4.0), tmp_path)
    assert [run.first for run in report.lost] in (["frame-000422"], ["frame-000116", "frame-000422"])
    path = loom.read_trajectory(tmp_path / "scene" / "trajectory.log").poses
    truth = np.array([frames.read(i).T_world_camera for i in range(3)])
    steps, true = (np.linalg.inv(poses[:2]) @ poses[1:3] for poses in (path, truth))
    assert np.abs(steps - true)[:, :3, 3].max() < 0.02  # the given poses are off by a centimeter


def test_a_pair_without_poses_gives_a_model(tmp_path, real_file):
    """The pair of slambook: two color images and two depth images in one folder, nothing else."""
    camera = loom.PinholeCameraIntrinsic(640, 480, 481.2, 480.0, 319.5, 239.5)
    frames = loom.open_frames(real_file("rgbd-slambook-ch7"), intrinsic=camera, depth_scale=5000.0)
    report = run_system(frames, Config(tsdf_voxel_size=0.02), tmp_path)
    assert (report.used, report.trajectory_error) == (2, None)
    assert report.mesh["vertices"] > 5000


@pytest.mark.slow
def test_every_sixth_frame_of_the_kitchen_is_registered(tmp_path, real_file):
    frames = loom.open_dataset(real_file("rgbd-7scenes-redkitchen"), every=6)
    names = {"n_frames_per_fragment": 25, "tsdf_voxel_size": 0.02}
    report = run_system(frames, Config(**names), tmp_path)
    assert (report.used, report.frames) == (50, 50)
    assert report.trajectory_error["rmse"] < 0.06  # the true poses are accurate to centimeters

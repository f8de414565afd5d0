"""The furnished room: exact depth, texture, the noise models, and the dataset on disk."""

from types import SimpleNamespace

import numpy as np
import pytest

from benchmarks.room_loops import room_loop_sequence
from pointloom import PinholeCameraIntrinsic
from pointloom.core.errors import FileError
from pointloom.datasets.scenes.furniture import LAMP_POSITION, ROOM_SIZE, SolidBuilder, furnished_room
from pointloom.datasets.scenes.room import film_pose, room_pose, room_sequence, surface_errors, write_room_sequence
from pointloom.io.frames.datasets import open_dataset
from pointloom.kernels.memory import download
from pointloom.kernels.scenes.depth_noise import measure_depth
from pointloom.kernels.scenes.room import Room

SMALL = {"width": 160, "height": 120}


def back_project(frame, depth):
    """World points [n, 3] of the pixels with depth [m]."""
    v, u = np.nonzero(depth)
    z = depth[v, u].astype(np.float64)
    camera = frame.intrinsic
    points = np.column_stack([(u - camera.cx) / camera.fx * z, (v - camera.cy) / camera.fy * z, z])
    return points @ frame.T_world_camera[:3, :3].T + frame.T_world_camera[:3, 3]


@pytest.mark.parametrize(
    ("argument", "wrong"),
    [
        ("frame_count", 0), ("width", 0), ("height", 1.5), ("seed", -1), ("texture", 1.5), ("texture", "much"),
        ("color_noise", 256), ("color_noise", -1.0), ("color_noise", "much"),
    ],
)  # fmt: skip
def test_a_wrong_argument_of_a_sequence_is_rejected_by_name(argument, wrong):
    with pytest.raises((TypeError, ValueError), match=f"^{argument}: expected"):
        room_sequence(**{argument: wrong})


@pytest.mark.slow
def test_noise_follows_its_model(device):
    noisy, exact = room_sequence(6, device=device), room_sequence(6, noise=False, device=device)
    scaled = []
    for i in range(6):
        depth, true = noisy.read(i).depth, exact.read(i).depth.astype(np.float64)
        assert depth.dtype == np.uint16
        valid = depth > 0
        assert 0.85 < valid.mean() < 1.0
        sigma = 0.0012 + 0.0019 * (true - 0.4) ** 2
        rounding = 0.001**2 / 12
        scaled.append(((depth / 1000.0 - true) / np.sqrt(sigma**2 + rounding))[valid])
    scaled = np.concatenate(scaled)
    assert abs(scaled.mean()) < 0.01 and abs(scaled.std() - 1) < 0.01 and np.abs(scaled).max() < 6.5


def test_grazing_surfaces_and_edges_lose_their_depth(device):
    noisy, exact = (room_sequence(12, **SMALL, noise=noise, device=device).read(4) for noise in (True, False))
    true = exact.depth
    jump = np.zeros_like(true)
    for axis in (0, 1):
        for shift in (-1, 1):
            jump = np.maximum(jump, np.abs(np.roll(true, shift, axis) - true))
    beside_edge = jump[1:-1, 1:-1] > 0.05 * true[1:-1, 1:-1]
    is_missing = noisy.depth[1:-1, 1:-1] == 0
    assert is_missing[beside_edge].mean() > 0.6 and is_missing[~beside_edge].mean() < 0.1


@pytest.mark.parametrize("view", [0.1, 0.4, 0.7, "down", "up", "away"])  # along the path, or from the center
def test_a_room_of_coarse_light_has_the_exact_depth_and_measured_depth_follows_the_noise_model(device, view):
    parts, camera = furnished_room(), PinholeCameraIntrinsic(40, 30, 35.0, 35.0, 19.5, 14.5)
    solids, margins = parts.solids(device), np.full(3, 0.35)
    box = {"lamp": LAMP_POSITION, "low": -margins, "high": ROOM_SIZE + margins, "step": 0.5}
    room = Room(solids, np.array(parts.paints), np.array(parts.patterns), **box)
    pose = np.eye(4) if isinstance(view, str) else room_pose(view)
    if isinstance(view, str):
        pose[:3, 3] = 2.5, 2.0, 4.0 if view == "away" else 1.2
        pose[1:3, 1:3] *= -1 if view == "down" else 1
    depth, incidence, colors = room.render(camera, pose)
    true = download(depth).reshape(30, 40).astype(float)
    if view == "away":
        assert (true == 0).all() and (download(colors) == 0).all() and (download(incidence) == 0).all()
        return
    frame = SimpleNamespace(intrinsic=camera, T_world_camera=pose)
    assert true.min() > 0.1 and surface_errors(back_project(frame, true), device=device).max() < 2e-6
    measured = download(measure_depth(depth, incidence, 40, 30, seed=0, frame=1)).reshape(30, 40)[1:-1, 1:-1]
    jumps = [np.abs(np.roll(true, shift, axis) - true) for axis in (0, 1) for shift in (-1, 1)]
    beside_edge, true = (np.max(jumps, axis=0) > 0.05 * true)[1:-1, 1:-1], true[1:-1, 1:-1]
    sigma = 0.0012 + 0.0019 * (true - 0.4) ** 2
    assert (measured == 0)[beside_edge].mean() > 0.6
    assert (np.abs(measured - true) < 6.5 * sigma + 0.001)[measured > 0].all() and (measured > 0).any()


def test_a_beam_is_drawn_over_its_full_length(device):
    builder, camera = SolidBuilder(), PinholeCameraIntrinsic(64, 48, 35.0, 35.0, 31.5, 23.5)
    builder.box((0, 0, 2), (2.4, 0.2, 0.2), (0.5, 0.5, 0.5))
    box = {"lamp": (0, 0, 1), "low": (-2, -2, -1), "high": (2, 2, 3), "step": 1.0}
    room = Room(builder.solids(device), np.array(builder.paints), np.array(builder.patterns), **box)
    depth = download(room.render(camera, np.eye(4))[0]).reshape(48, 64)
    v, u = np.mgrid[:48, :64]
    on_front = (np.abs(u - 31.5) * 1.9 / 35 <= 1.2) & (np.abs(v - 23.5) * 1.9 / 35 <= 0.1)
    np.testing.assert_allclose(depth, np.where(on_front, 1.9, 0.0), rtol=1e-5)


def test_the_camera_keeps_clear_of_the_furniture_and_moves_smoothly():
    poses = np.array([room_pose(i / 120) for i in range(121)])
    assert surface_errors(poses[:, :3, 3]).min() > 0.35
    assert np.linalg.norm(np.diff(poses[:, :3, 3], axis=0), axis=1).max() < 0.35
    rotations = np.einsum("nji,njk->nik", poses[:-1, :3, :3], poses[1:, :3, :3])
    angles = np.degrees(np.arccos(np.clip((np.trace(rotations, axis1=1, axis2=2) - 1) / 2, -1, 1)))
    assert angles.max() < 16 and np.allclose(np.linalg.det(poses[:, :3, :3]), 1)


def test_film_trajectory_is_one_smooth_revolution():
    poses = np.array([film_pose(k / 240) for k in range(240)])
    forward, eyes = poses[:, :3, 2], poses[:, :3, 3]
    angles = np.degrees(np.arccos((forward[1:] * forward[:-1]).sum(axis=1)))
    assert angles.min() > 0.8 and angles.max() < 2.2
    assert 0.02 < np.linalg.norm(np.diff(eyes, axis=0), axis=1).max() < 0.06 and surface_errors(eyes).min() > 0.35
    yaw = np.unwrap(np.arctan2(forward[:, 1], forward[:, 0]))
    assert np.degrees(yaw[-1] - yaw[0]) == pytest.approx(358.5, abs=0.5)


def test_the_written_folder_is_a_data_set(tmp_path):
    folder = tmp_path / "room"
    write_room_sequence(folder, frame_count=3, **SMALL)
    dataset, sequence = open_dataset(folder), room_sequence(3, **SMALL)
    assert (dataset.layout, len(dataset), dataset.depth_scale) == ("7scenes", 3, sequence.depth_scale)
    assert dataset.intrinsic == sequence.intrinsic
    for read, made in zip(dataset, sequence, strict=True):
        assert np.array_equal(read.depth, made.depth) and np.array_equal(read.color, made.color)
        assert np.array_equal(read.T_world_camera, made.T_world_camera)
    assert [path.name for path in tmp_path.iterdir()] == ["room"]


def test_options_out_of_range_and_existing_folders_are_refused(tmp_path):
    for name, value in (("width", 0), ("frame_count", 0), ("seed", -1)):
        with pytest.raises(ValueError, match=name):
            room_sequence(**{name: value})
    with pytest.raises(IndexError):
        room_sequence(2, **SMALL).read(2)
    for path, message in ((tmp_path, "exists already"), (tmp_path / "a" / "b", "/b:")):
        with pytest.raises(FileError, match=message):
            write_room_sequence(path, frame_count=1, **SMALL)


def local_contrast(image):
    """Fraction of 8 x 8 px blocks in which brightness varies by more than 3 %."""
    gray = image.astype(float).mean(axis=2)
    blocks = gray.reshape(gray.shape[0] // 8, 8, -1, 8).swapaxes(1, 2).reshape(-1, 64)
    return (blocks.std(axis=1) > 0.03 * 255).mean()


def test_texture_changes_colors_and_no_depth(device):
    plain, textured = (room_sequence(40, **SMALL, noise=False, texture=t, device=device).read(0) for t in (False, True))
    assert np.array_equal(plain.depth, textured.depth) and (plain.color != textured.color).mean() > 0.9
    assert abs(textured.color.astype(float).mean() / plain.color.astype(float).mean() - 1) < 0.05
    assert local_contrast(textured.color) > 0.95 > 0.5 > local_contrast(plain.color)


def test_texture_is_fixed_to_the_surface_not_the_view(device):
    sequence = room_sequence(400, width=320, height=240, noise=False, texture=True, color_noise=0, device=device)
    first, second = sequence.read(0), sequence.read(1)
    v, u = np.mgrid[:240, :320].reshape(2, -1)
    camera, z = first.intrinsic, first.depth.reshape(-1).astype(float)
    points = np.stack([(u - camera.cx) / camera.fx * z, (v - camera.cy) / camera.fy * z, z, np.ones(z.shape)])
    x, y, away, _ = np.linalg.inv(second.T_world_camera) @ first.T_world_camera @ points
    parts = (camera.fx, x, camera.cx), (camera.fy, y, camera.cy)
    column, row = (np.rint(f * a / away + c).astype(int) for f, a, c in parts)
    visible = (column >= 0) & (column < 320) & (row >= 0) & (row < 240)
    visible[visible] = np.abs(second.depth[row[visible], column[visible]] - away[visible]) < 0.01
    one = first.color[v[visible], u[visible]].astype(float)
    other = second.color[row[visible], column[visible]].astype(float)
    assert visible.mean() > 0.5
    assert np.corrcoef(one.mean(axis=1), other.mean(axis=1))[0, 1] > 0.98  # up to half a pixel


def test_noise_of_colors_has_the_requested_deviation_two_with_texture_and_none_without():
    textured, noisy, clean = (
        room_sequence(40, **SMALL, texture=True, color_noise=n).read(3).color.astype(float) for n in (None, 4, 0)
    )
    assert 1.5 < (textured - clean).std() < 2.1
    assert abs((noisy - clean)[(clean > 20) & (clean < 235)].std() - 4) < 0.1
    plain, clean = (room_sequence(40, **SMALL, color_noise=n).read(3).color for n in (None, 0))
    assert np.array_equal(plain, clean)


def test_a_loop_has_texture_too_and_blur_takes_it_away(device):
    same = SMALL | {"texture": True, "color_noise": 0, "device": device}
    sharp, blurred = (room_loop_sequence(300, **same, blur=blur).read(10).color for blur in (0.0, 4.0))
    detail = [np.abs(np.diff(color.astype(float), axis=1)).mean() for color in (sharp, blurred)]
    assert detail[1] < 0.6 * detail[0]


def test_a_covered_lens_still_has_the_sensors_noise_whose_range_is_checked():
    frame = room_loop_sequence(9, **SMALL, texture=True, covered=(2, 4)).read(2)
    assert 0 < frame.color.max() < 20
    for make in (room_sequence, room_loop_sequence):
        for value in (-1, 256, np.nan):
            with pytest.raises(ValueError, match="color_noise"):
                make(9, **SMALL, color_noise=value)

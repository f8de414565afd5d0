"""Fusion of posed frames into a mesh: accuracy, order, color, and errors for invalid arguments."""

import dataclasses
import threading

import numpy as np
import pytest

import pointloom as loom
from benchmarks.room_loops import room_loop_sequence
from pointloom.core.errors import FileError
from pointloom.core.up_axis import rotation_between
from pointloom.datasets.scenes.room import look_along, prime_sense_camera, room_sequence, room_views, surface_errors
from pointloom.io.frames.frames import READ_AHEAD, measured_fractions
from pointloom.meshing.volume.surface_weights import FRAME_THRESHOLDS
from pointloom.registration.trajectories.up_direction import up_of_poses
from pointloom.rgbd.fusion.pose_check import MAX_DISPLACED, MAX_FRAMES, PoseCheck

from ...products import few_quick
from .walls import Wall

VOXEL = 0.05


@pytest.fixture(scope="module")
def sequence():
    """12 small frames of the room."""
    return room_sequence(12, width=160, height=120)


class Broken(Wall):
    """A wall whose third frame is changed by `replace`."""

    def __init__(self, **replace):
        super().__init__(40)
        self.replace = replace

    def read(self, index):
        frame = super().read(index)
        if index == 2:
            if not self.replace:
                raise FileError("frame-2.png", "damaged")
            return dataclasses.replace(frame, **self.replace)
        return frame


def test_exact_frames_of_the_room_fuse_to_its_surface(device):
    frames = room_sequence(12, width=200, height=150, noise=False, device=device)
    mesh = loom.rgbd.fuse(frames, voxel_size=VOXEL, device=device, read_ahead=0).mesh
    errors = surface_errors(mesh.vertices, device=device)
    assert np.median(errors) < 0.05 * VOXEL and np.mean(errors < VOXEL / 2) > 0.9


class Posed:
    """Frames with other poses."""

    def __init__(self, frames, poses):
        self.intrinsic, self.depth_scale, self.frames, self.poses = frames.intrinsic, 1000.0, frames, poses

    def __len__(self):
        return len(self.poses)

    def read(self, index):
        return dataclasses.replace(self.frames.read(index), T_world_camera=self.poses[index])


@pytest.mark.slow
def test_only_contradictory_poses_are_reported(sequence):
    right = np.array([sequence.read(k).T_world_camera for k in range(12)])
    shaken = right.copy()
    shaken[:, :3, 3] += np.random.default_rng(0).normal(0, 0.15, (12, 3))
    cases = {"right": right, "inverse": np.linalg.inv(right), "others": np.roll(right, 5, axis=0), "shaken": shaken}
    for name, poses in cases.items():
        result = loom.rgbd.fuse(Posed(sequence, poses), voxel_size=VOXEL)
        assert (result.reliable) == (name == "right"), name
        assert name == "right" or "of the measured depth is off the fused surface" in str(result.warnings)
        assert result.to_dict()["fraction_off"] == result.fraction_off
    assert loom.rgbd.fuse(Wall(1), voxel_size=VOXEL).fraction_off is None  # one frame cannot contradict another


class Turning(Posed):
    """Frames of a tight loop through the room, with another depth unit or focal length."""

    def __init__(self, unit=1.0, focal=1.0):
        sequence = room_loop_sequence(120, width=80, height=60)
        super().__init__(sequence, sequence.poses[:10])
        K = self.intrinsic
        self.depth_scale *= unit
        self.intrinsic = dataclasses.replace(K, fx=focal * K.fx, fy=focal * K.fy)


@few_quick(2, ("unit", "factor"), [(1.0, 1.0), (0.5, 0.5), (0.8, 0.8), (1.25, 1.25), (2.0, 2.0)])
def test_a_wrong_depth_scale_is_reported_with_a_better_factor(unit, factor):
    result = loom.rgbd.fuse(Turning(unit=unit), voxel_size=VOXEL, depth_max=8.0)
    assert result.depth_factor == pytest.approx(factor, rel=0.02)
    assert (factor == 1.0) == result.reliable and result.to_dict()["depth_factor"] == result.depth_factor
    if factor != 1.0:
        assert f"the depth is multiplied by about {result.depth_factor:.3g} (sigma 0." in str(result.warnings)


def test_poses_in_millimeters_are_reported():
    frames = Turning()
    frames.poses = frames.poses.copy()
    frames.poses[:, :3, 3] *= 1000
    assert loom.rgbd.fuse(frames, voxel_size=VOXEL).depth_factor == pytest.approx(1000, rel=0.02)


@pytest.mark.slow
def test_refined_frames_in_a_wrong_unit_are_compared_with_the_given_poses():
    result = loom.rgbd.fuse(Turning(unit=1.25), voxel_size=VOXEL, refine=True)
    assert result.depth_factor == pytest.approx(1.25, rel=0.02) and not result.reliable


@pytest.mark.slow
def test_noise_of_poses_is_no_depth_scale():
    for seed in range(3):
        frames = Turning()
        frames.poses = frames.poses.copy()
        frames.poses[:, :3, 3] += np.random.default_rng(seed).normal(0, 0.05, (10, 3))
        result = loom.rgbd.fuse(frames, voxel_size=VOXEL)
        assert result.depth_factor == 1.0 and (result.camera is None or result.camera.reliable)


@pytest.mark.slow
def test_frames_off_the_refined_surface_are_reported():
    frames = Turning()
    assert loom.rgbd.fuse(frames, voxel_size=VOXEL, refine=True).reliable
    frames.poses = frames.poses.copy()
    frames.poses[[4, 8], :3, 3] += 0.6  # [m], beyond a refinement
    result = loom.rgbd.fuse(frames, voxel_size=VOXEL, refine=True)
    assert result.warnings == ("2 of 10 sampled frames are off the fused surface: their poses are wrong",)


def test_frames_that_cannot_be_refined_are_correct_on_the_surface():
    """A wall does not determine the motion along it."""
    frames = Wall(6)
    poses = np.tile(np.eye(4), (6, 1, 1))
    poses[:, 0, 3] = 0.01 * np.arange(6)  # [m] along the wall
    result = loom.rgbd.fuse(Posed(frames, poses), voxel_size=VOXEL, refine=True)
    assert not result.refinement.reliable and result.reliable
    poses[1::2, 2, 3] = 0.3  # [m] toward the wall
    result = loom.rgbd.fuse(Posed(frames, poses), voxel_size=VOXEL, refine=True)
    assert any("poses could not be refined" in warning for warning in result.warnings)


@few_quick(1, "focal", [0.9, 1.1])
def test_a_wrong_focal_length_of_posed_frames_is_reported(focal):
    camera = loom.rgbd.fuse(Turning(focal=focal), voxel_size=VOXEL).camera
    assert camera.factor * focal == pytest.approx(1.0, abs=0.04) and not camera.reliable


class Loop(Posed):
    """Frames of a loop through the room, with another camera or depth unit."""

    def __init__(self, sequence, numbers, fx=1.0, fy=1.0, center=(0.0, 0.0), unit=1.0):
        super().__init__(sequence, sequence.poses[numbers])
        self.numbers, K = numbers, self.intrinsic
        self.depth_scale *= unit
        shift = center[0] * K.width, center[1] * K.width
        self.intrinsic = dataclasses.replace(K, fx=fx * K.fx, fy=fy * K.fy, cx=K.cx + shift[0], cy=K.cy + shift[1])

    def read(self, index):
        return dataclasses.replace(self.frames.read(int(self.numbers[index])), T_world_camera=self.poses[index])


RIGHT_CAMERA = {"fx": 1.0, "fy": 1.0, "u": 0.0, "v": 0.0, "depth": 1.0}
PIXELS = 80 * 30 / 640  # 30 px of VGA


@pytest.mark.parametrize(
    ("change", "better"),
    [
        ({}, {}),
        ({"fx": 1.1, "fy": 1.1}, {"fx": 1 / 1.1, "fy": 1 / 1.1}),
        ({"fx": 0.9, "fy": 0.9}, {"fx": 1 / 0.9, "fy": 1 / 0.9}),
        ({"fx": 1.1}, {"fx": 1 / 1.1}),
        ({"center": (30 / 640, 0.0)}, {"u": -PIXELS}),
        ({"center": (0.0, -30 / 640)}, {"v": PIXELS}),
        ({"unit": 1.05}, {"depth": 1.05}),
        ({"unit": 0.95}, {"depth": 0.95}),
    ],
    ids=["right", "f x 1.1", "f x 0.9", "fx x 1.1", "cx + 30", "cy - 30", "unit x 1.05", "unit x 0.95"],
)
def test_a_slightly_wrong_camera_or_unit_is_reported_with_the_better_one(device, change, better):
    frames = Loop(room_loop_sequence(120, width=80, height=60), np.arange(0, 60, 3), **change)
    result = loom.rgbd.fuse(frames, voxel_size=VOXEL, device=device)
    check = result.camera
    fx, fy = check.factor * check.aspect**0.5, check.factor / check.aspect**0.5
    found = dict(zip(RIGHT_CAMERA, (fx, fy, *check.center, result.depth_factor), strict=True))
    assert found == pytest.approx(RIGHT_CAMERA | better, rel=0.02, abs=0.02 * PIXELS)
    assert result.reliable == (not change) and len(result.warnings) == bool(change)
    assert ("sigma" in str(result.warnings)) == bool(change)


def test_a_wrong_camera_is_not_hidden_by_refined_poses():
    frames = Loop(room_loop_sequence(120, width=80, height=60), np.arange(0, 60, 3), fx=1.1, fy=1.1)
    result = loom.rgbd.fuse(frames, voxel_size=VOXEL, refine=True)
    assert result.camera.factor * 1.1 == pytest.approx(1.0, abs=0.03) and not result.camera.reliable


class Translating(Posed):
    """Frames of a camera that moves through the room without rotation, with another focal length or depth unit."""

    def __init__(self, step, direction, focal=1.0, unit=1.0):
        poses = [look_along(np.array([1.2, 1.2, 1.3]) + k * np.array(step), direction) for k in range(12)]
        super().__init__(room_views(poses, prime_sense_camera(80, 60), noise=True, texture=False), np.array(poses))
        K = self.intrinsic
        self.depth_scale *= unit
        self.intrinsic = dataclasses.replace(K, fx=focal * K.fx, fy=focal * K.fy)


@pytest.mark.parametrize(("focal", "unit"), [(1.0, 1.0), (0.9, 1.0), (1.1, 1.0), (1.0, 1.05), (1.0, 0.95)])
@pytest.mark.parametrize(
    ("step", "direction"), [((0, 0.08, 0), (1, 0.3, -0.3)), ((0.05, 0.05, 0.02), (0.2, 1, -0.5))], ids=["y", "diagonal"]
)
def test_a_camera_that_only_translates_is_checked(device, step, direction, focal, unit):
    """All values together are hardly determined, each alone is."""
    result = loom.rgbd.fuse(Translating(step, direction, focal, unit), voxel_size=VOXEL, device=device)
    assert result.reliable == (focal == unit == 1.0)
    assert result.camera.factor * focal == pytest.approx(1.0, abs=0.02)
    assert result.depth_factor == pytest.approx(unit, abs=0.02)


@pytest.mark.parametrize("size", [0.02, 0.08])
def test_values_that_the_frames_do_not_determine_are_noted(size):
    """Translations of 0.2 and 0.9 m: the surface of a wrong unit is displaced by up to 3 cm and more."""
    result = loom.rgbd.fuse(Translating((0, size, 0), (1, 0.3, -0.3)), voxel_size=VOXEL)
    (note,) = result.notes
    limit = float(note.rpartition("the depth unit up to ")[2].rstrip("%")) / 100
    assert (limit > 0.06) == (size == 0.02) and result.reliable
    assert note.startswith("not determined by the frames and poses") and result.to_dict()["notes"] == [note]
    assert loom.rgbd.fuse(Wall(2), voxel_size=VOXEL).notes == (
        "the camera and the depth unit are not checked: too few sampled frames overlap at the given poses",
    )


@pytest.mark.parametrize("count", [1, 15, 16, 17, 40, 163])
def test_a_known_number_of_frames_gives_the_same_sample(count):
    known, unknown = (PoseCheck(Wall(1).intrinsic, 1000.0, 4.0, number) for number in (count, 0))
    for k in range(count):
        for check in (known, unknown):
            check.add(np.full((24, 32), k, np.uint16), None, np.eye(4), np.eye(4))
    assert list(known._samples) == list(unknown._samples) and len(known._samples) == min(count, MAX_FRAMES)


@pytest.mark.parametrize("kind", [np.uint16, np.int32, np.float32])
@pytest.mark.parametrize("farthest", [1000.0, 1999.5, np.inf])
def test_fractions_of_measured_depth_are_those_of_all_pixels(kind, farthest):
    depth = np.random.default_rng(0).integers(0, 3000, (60, 80)).astype(kind)
    depth[:20] = 0
    if depth.dtype.kind == "f":
        depth[0, :40], depth[1] = np.nan, np.inf
    measured = depth > 0
    assert measured_fractions(depth, farthest) == (np.mean(measured), np.mean(measured & (depth <= farthest)))


def test_short_windows_of_noisy_poses_determine_no_camera_and_are_accepted(device):
    """Poses that drift by 4 mm: a factor of up to 1.1 of translations of 5 cm."""
    sequence = room_loop_sequence(900, width=80, height=60)
    for start, count in [(0, 4), (200, 8), (400, 12), (600, 20)]:
        frames = Loop(sequence, np.arange(start, start + count))
        frames.poses = frames.poses.copy()
        frames.poses[:, :3, 3] += np.linspace(0, 0.004, count)[:, None] * [1, -1, 1]
        result = loom.rgbd.fuse(frames, voxel_size=VOXEL, device=device)
        assert result.reliable and result.depth_factor == 1.0, (start, count, result.warnings)


@pytest.mark.parametrize(
    ("count", "every", "degrees"), [(12, 2, 3.0), (40, 2, 3.0), (40, 2, -6.0), (40, 4, 6.0), (40, 3, 4.0), (40, 2, 0.0)]
)
def test_poses_of_which_a_part_is_rotated_are_reported(device, count, every, degrees):
    """The mean surface is between both parts, and sampling every second frame shows one of them."""
    frames = Loop(room_loop_sequence(240, width=80, height=60), np.arange(0, 2 * count, 2))
    frames.poses, c, s = frames.poses.copy(), np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    frames.poses[::every, :3, :3] = frames.poses[::every, :3, :3] @ np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
    result = loom.rgbd.fuse(frames, voxel_size=VOXEL, device=device)
    assert result.reliable == (degrees == 0.0), result.warnings
    assert (result.fraction_displaced > MAX_DISPLACED) == (degrees != 0.0)
    assert result.to_dict()["fraction_displaced"] == result.fraction_displaced


@pytest.mark.parametrize("noise", [0.005, 0.01, 0.02])
def test_noise_of_poses_is_no_other_camera(device, noise):
    sequence = room_loop_sequence(120, width=80, height=60)
    for seed in range(3):
        frames = Loop(sequence, np.arange(0, 30, 3))
        frames.poses = frames.poses.copy()
        frames.poses[:, :3, 3] += np.random.default_rng(seed).normal(0, noise, (10, 3))
        result = loom.rgbd.fuse(frames, voxel_size=VOXEL, device=device)
        assert result.depth_factor == 1.0 and (result.camera is None or result.camera.reliable), result.warnings


@pytest.mark.parametrize(("depth", "fraction"), [(1000, 0), (1250, 1), (750, 1)])
def test_depth_beyond_noise_is_off_the_surface(depth, fraction):
    wall, volume = Wall(1), loom.TSDFVolume(voxel_size=VOXEL)
    volume.integrate(wall.read(0).depth, wall.intrinsic, np.eye(4))
    check = PoseCheck(wall.intrinsic, 1000.0, 4.0)
    for _ in range(2):
        check.add(Wall(1, depth=depth).read(0).depth, None, np.eye(4), np.eye(4))
    assert check.fractions_off(volume) == (fraction, fraction)


def test_frames_spread_over_a_long_sequence_are_checked_against_the_surface(sequence):
    check = PoseCheck(sequence.intrinsic, 1000.0, 4.0)
    for k in range(200):
        check.add(np.full((120, 160), k, np.uint16), None, np.eye(4), np.eye(4))
    numbers = [int(sample.depth[0, 0]) for sample in check._samples.values()]
    assert len(numbers) == MAX_FRAMES and numbers == list(check._samples)
    assert np.diff([0, *numbers, 200]).max() <= 21 and np.diff(numbers).min() >= 5
    for period in (2, 3, 4):  # errors with a period are in some sampled frames
        counts = np.bincount(np.array(numbers) % period, minlength=period)
        assert counts.min() > 1
    assert check._samples[0].depth.shape == (60, 80)


def test_reading_ahead_changes_no_bit(device, sequence):
    meshes = [loom.rgbd.fuse(sequence, voxel_size=VOXEL, device=device, read_ahead=n).mesh for n in (0, READ_AHEAD)]
    for name in ("vertices", "triangles", "vertex_colors"):
        left, right = (getattr(mesh, name) for mesh in meshes)
        np.testing.assert_array_equal(left, right)
    assert len(meshes[0]) > 1000


def test_the_wall_keeps_its_position_and_color(device):
    mesh = loom.rgbd.fuse(Wall(), voxel_size=0.02, device=device).mesh
    np.testing.assert_allclose(mesh.vertices[:, 2], 1.0, atol=1e-4)
    np.testing.assert_allclose(mesh.vertex_colors, np.tile([1, 128 / 255, 0], (len(mesh.vertices), 1)), atol=0.005)


@pytest.mark.parametrize("tilt", [0.0, 30.0, 60.0])
@pytest.mark.parametrize("up", [(0, 0, 1), (0, 1, 0), (0, -1, 0), (-1, 0, 0), (0.6, 0.0, -0.8)])
def test_the_up_axis_is_that_of_level_cameras_that_look_down(up, tilt):
    angles, down = np.radians(np.arange(0, 200, 20)), np.radians(tilt)
    right = np.stack([-np.sin(angles), np.cos(angles), 0 * angles], axis=1)
    ahead = np.stack([np.cos(angles) * np.cos(down), np.sin(angles) * np.cos(down), 0 * angles - np.sin(down)], axis=1)
    poses = np.tile(np.eye(4), (len(angles), 1, 1))
    poses[:, :3, :3] = np.stack([-right, np.cross(ahead, -right), ahead], axis=2)
    assert np.allclose(np.linalg.det(poses[:, :3, :3]), 1)
    poses[:, :3, :3] = rotation_between((0.0, 0.0, 1.0), up) @ poses[:, :3, :3]
    np.testing.assert_allclose(up_of_poses(poses), up, atol=1e-9)


def test_frames_without_color_give_a_mesh_without():
    result = loom.rgbd.fuse(Wall(color=False), voxel_size=0.02)
    assert len(result.mesh) > 0 and result.mesh.vertex_colors is None


@pytest.mark.parametrize(("frame_count", "threshold"), [(1, 0), (10, 1), (30, 3)])
def test_the_more_frames_the_more_often_a_voxel_must_be_seen(frame_count, threshold):
    result = loom.rgbd.fuse(Wall(frame_count), voxel_size=0.05)
    assert result.weight_threshold == threshold and result.frame_count == frame_count and len(result.mesh) > 0
    assert [frames for frames, _ in FRAME_THRESHOLDS] == sorted(
        (frames for frames, _ in FRAME_THRESHOLDS), reverse=True
    )


def test_shares_distinguish_missing_depth_from_depth_out_of_range():
    far = loom.rgbd.fuse(Wall(depth=3000), voxel_size=0.05, depth_max=2.0)
    assert "raise depth_max" in str(far.warnings) and "--" not in str(far.warnings)
    assert (far.depth_fraction, far.used_fraction) == (1.0, 0.0)
    none = loom.rgbd.fuse(Wall(depth=0), voxel_size=0.05)
    assert "have a depth" in str(none.warnings) and "pointloom info" not in str(none.warnings)
    assert (none.depth_fraction, none.used_fraction) == (0.0, 0.0) and len(far.mesh) == len(none.mesh) == 0


@pytest.mark.parametrize(
    ("voxel_size", "message"),
    [(20.0, "20 m is larger than the scene (1 m)"), (0.2, "0.2 m is more than a twentieth of")],
)
def test_a_voxel_too_large_for_the_scene_is_reported(voxel_size, message):
    result = loom.rgbd.fuse(Wall(), voxel_size=voxel_size)
    assert f"voxel_size: {message}" in str(result.warnings) and "--" not in str(result.warnings)
    assert str(result).splitlines()[-1].split(maxsplit=1) == ["warning", result.warnings[0]]
    fine = loom.rgbd.fuse(Wall(), voxel_size=0.02)
    assert fine.reliable and "poor" not in str(fine) and fine.seen_extent == pytest.approx(31 / 30)


@pytest.mark.parametrize("read_ahead", [0, READ_AHEAD])
def test_a_damaged_frame_ends_the_reading(read_ahead):
    source = Broken()
    with pytest.raises(FileError, match=r"frame-2\.png"):
        loom.rgbd.fuse(source, voxel_size=0.05, read_ahead=read_ahead)
    assert max(source.read_indices) <= 2 + read_ahead
    assert not [thread for thread in threading.enumerate() if thread.name.startswith("pointloom-read")]


@pytest.mark.parametrize(
    ("part", "reason"),
    [
        ({"T_world_camera": np.diag([2.0, 2, 2, 1])}, "rigid"),
        ({"depth": np.ones((24, 31), np.uint16)}, "31 x 24"),
        ({"color": np.zeros((12, 16, 3), np.uint8)}, "16 x 12"),
    ],
)
def test_a_frame_that_does_not_fit_is_named(part, reason):
    with pytest.raises(ValueError, match=f"frame frame-2: .*{reason}"):
        loom.rgbd.fuse(Broken(**part), voxel_size=0.05)


@pytest.mark.parametrize(
    ("options", "name"),
    [
        ({"voxel_size": 0.0}, "voxel_size"),
        ({"voxel_size": 0.1, "truncation": 0.01}, "truncation"),
        ({"depth_max": -1.0}, "depth_max"),
        ({"read_ahead": -1}, "read_ahead"),
        ({"weight_threshold": -1.0}, "weight_threshold"),
    ],
)
def test_options_out_of_range_are_named(options, name):
    with pytest.raises(ValueError, match=name):
        loom.rgbd.fuse(Wall(), **options)


@pytest.mark.parametrize(("depth_max", "used"), [(0.999, 0.0), (1.0, 1.0), (1.001, 1.0)])
def test_a_depth_at_the_limit_counts_as_used_and_is_fused(depth_max, used):
    result = loom.rgbd.fuse(Wall(depth=1000), voxel_size=0.05, depth_max=depth_max)
    assert (result.depth_fraction, result.used_fraction) == (1.0, used) and (len(result.mesh) > 0) == bool(used)

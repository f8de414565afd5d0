"""Volumes fused with poses, and the mesh of Gaussian splats."""

import itertools

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import pointloom as loom

from ..registration.poses import as_pose
from . import tsdf_scenes as scenes
from .tsdf_scenes import RADIUS, SMALL, TRUNCATION, VOXEL, fingerprint, fuse, fused_sphere, sphere_frames, voxels_of


def colored_volume(device, *, count=3, seed=0, center=(0.0, 0.0, 0.0), voxel_size=0.05):
    volume = loom.TSDFVolume(voxel_size=voxel_size, truncation=0.1, device=device)
    for depth, T, color in scenes.small_frames(np.random.default_rng(seed), count):
        T = T.copy()
        T[:3, 3] += center
        volume.integrate(depth, SMALL, np.linalg.inv(T), color=color)
    return volume


def seen_of(volume):
    blocks, distances, weights, colors = voxels_of(volume)
    is_used = weights.reshape(len(weights), -1).any(axis=1)
    seen = weights[is_used] > 0
    values = [blocks[is_used], np.where(seen, distances[is_used], 0), weights[is_used]]
    if colors is not None:
        values.append(np.where(seen[..., None], colors[is_used], 0))
    return b"".join(v.tobytes() for v in values)


@pytest.mark.parametrize("center", [(0, 0, 0), (500_000.0, 5_400_000.0, 300.0)])
def test_an_unmoved_volume_is_bitwise_unchanged(device, center):
    volume = colored_volume(device, center=center)
    fused = loom.meshing.fuse_volumes([volume], [np.eye(4)])
    assert seen_of(fused) == seen_of(volume)
    assert (fused.origin == volume.origin).all() and fused.frame_count == volume.frame_count
    assert (fused.voxel_size, fused.truncation) == (volume.voxel_size, volume.truncation)


def test_a_volume_shifted_by_integer_voxels_is_bitwise_identical(device):
    volume = colored_volume(device)
    there = as_pose(shift=np.array([8, -16, 24]) * volume.voxel_size)
    moved = loom.meshing.fuse_volumes([volume], [there])
    assert [len(v) for v in voxels_of(moved)[:1]] == [len(np.unique(voxels_of(moved)[0], axis=0))]
    assert seen_of(loom.meshing.fuse_volumes([moved], [np.linalg.inv(there)])) == seen_of(volume)
    a, b = voxels_of(moved), voxels_of(volume)
    is_used = b[2].reshape(len(b[2]), -1).any(axis=1)
    assert (a[0] == b[0][is_used] + [1, -2, 3]).all() and (a[2] == b[2][is_used]).all()
    seen = a[2] > 0
    assert (a[1][seen] == b[1][is_used][seen]).all() and (a[3][seen] == b[3][is_used][seen]).all()


def test_a_rotated_volume_fills_every_voxel_between_seen_ones(device):
    """By brute force: the voxels whose 8 surrounding voxels in the volume are all seen."""

    def seen_voxels(volume):
        blocks, _, weights, _ = voxels_of(volume)
        return np.concatenate([8 * block + np.argwhere(one) for block, one in zip(blocks, weights > 0, strict=True)])

    volume, T = colored_volume(device, count=1, voxel_size=0.08), as_pose([0.3, -0.4, 0.6], [0.01, 0.03, 0.007])
    inside = np.zeros((100,) * 3, bool)
    inside[tuple((seen_voxels(volume) + 50).T)] = True
    grid, back = np.argwhere(np.ones((44,) * 3)) - 22, np.linalg.inv(T)
    below = np.floor(grid @ back[:3, :3].T + back[:3, 3] / volume.voxel_size).astype(int) + 50
    full = np.all([inside[tuple((below + corner).T)] for corner in itertools.product((0, 1), repeat=3)], axis=0)
    fused = seen_voxels(loom.meshing.fuse_volumes([volume], [T]))
    assert full.sum() > 200 and set(map(tuple, fused)) == set(map(tuple, grid[full]))


def test_the_order_of_volumes_does_not_matter(device):
    volumes = [colored_volume(device, count=1 + i, seed=i) for i in range(3)]
    poses = [as_pose((0.02 * i, 0.1 * i, 0), (0.03 * i, 0, 0.01)) for i in range(3)]
    orders = itertools.permutations(zip(volumes, poses, strict=True))
    assert len({fingerprint(loom.meshing.fuse_volumes(*map(list, zip(*order, strict=True)))) for order in orders}) == 1


def test_volumes_of_frame_subsets_give_the_full_volume(device):
    """On one grid: the mean of means equals the mean within rounding."""
    frames = list(sphere_frames())
    full, parts = fuse(frames, device), [fuse(frames[i::2], device) for i in range(2)]
    fused = loom.meshing.fuse_volumes(parts, [np.eye(4)] * 2)
    a, b = voxels_of(full), voxels_of(fused)
    is_used = a[2].reshape(len(a[2]), -1).any(axis=1)
    # a frame updates voxels of blocks added by other frames only in a shared volume
    assert (a[0][is_used] == b[0]).all()
    same = a[2][is_used] == b[2]
    assert same.mean() > 0.97 and np.abs(a[1][is_used] - b[1])[same].max() < 1e-6


def test_volumes_in_different_frames_are_aligned_by_their_poses(device):
    """Half of the frames each, in camera coordinates; pose errors of two voxels are visible."""
    frames = list(sphere_frames())
    parts, poses = [], []
    for half in (frames[0::2], frames[1::2]):
        T_world_part = half[0][1]
        back = np.linalg.inv(T_world_part)
        parts.append(fuse([(depth, back @ T) for depth, T in half], device))
        poses.append(T_world_part)

    def off(poses):
        mesh = loom.meshing.fuse_volumes(parts, poses).extract_triangle_mesh(0)
        return np.abs(np.linalg.norm(mesh.vertices, axis=1) - RADIUS)

    direct = np.abs(np.linalg.norm(fuse(frames, device).extract_triangle_mesh(0).vertices, axis=1) - RADIUS)
    drifted = [poses[0], as_pose(shift=(2 * VOXEL, 0, VOXEL)) @ poses[1]]
    right = off(poses)
    assert np.median(right) < np.median(direct) + 0.1 * VOXEL and np.median(off(drifted)) > 2 * np.median(right)


def test_volumes_are_aligned_far_from_the_origin(device):
    far = np.array([500_000.0, 5_400_000.0, 300.0])
    frames = list(sphere_frames(center=far))
    parts = [fuse(frames[i::2], device) for i in range(2)]
    fused = loom.meshing.fuse_volumes(parts, [np.eye(4)] * 2)
    off = np.linalg.norm(fused.extract_triangle_mesh(0).vertices - far, axis=1) - RADIUS
    assert np.abs(off).max() < VOXEL and np.median(np.abs(off)) < 0.15 * VOXEL
    local = fuse(sphere_frames(), device)
    moved = loom.meshing.fuse_volumes([local], [as_pose((0, 0, 1.0), far)])
    off = np.linalg.norm(moved.extract_triangle_mesh(0).vertices - far, axis=1) - RADIUS
    assert np.abs(off).max() < VOXEL and np.abs(moved.origin - far).max() < 1


def test_coarser_voxels_represent_the_same_surface(device):
    volume = fused_sphere(device, voxel_size=0.01, truncation=TRUNCATION)
    fused = loom.meshing.fuse_volumes([volume], [np.eye(4)], voxel_size=0.02, truncation=0.06)
    assert (fused.voxel_size, fused.truncation) == (0.02, 0.06)
    off = np.linalg.norm(fused.extract_triangle_mesh(0).vertices, axis=1) - RADIUS
    assert np.median(np.abs(off)) < 0.15 * VOXEL
    distances, weights = voxels_of(fused)[1:3]
    assert np.abs(distances).max() <= 1 and (distances[weights > 0] < 1).mean() > 0.3


def test_empty_volumes_add_nothing(device):
    empty = loom.TSDFVolume(voxel_size=0.05, truncation=0.1, device=device)
    assert loom.meshing.fuse_volumes([empty, empty], [np.eye(4)] * 2).block_count == 0
    volume = colored_volume(device)
    assert seen_of(loom.meshing.fuse_volumes([empty, volume], [np.eye(4)] * 2)) == seen_of(volume)


def test_weights_saturate_at_their_limit(device):
    volume = fuse([next(iter(sphere_frames(SMALL)))], device, camera=SMALL, voxel_size=0.05)
    for _ in range(17):
        volume = loom.meshing.fuse_volumes([volume, volume], [np.eye(4)] * 2)
    assert voxels_of(volume)[2].max() == 65535 and volume.frame_count == 2**17


def test_colors_are_weighted_means(device):
    depth, T = np.full((SMALL.height, SMALL.width), 1.0), np.eye(4)
    parts = []
    for shade, count in ((40, 1), (200, 3)):
        volume = loom.TSDFVolume(voxel_size=0.05, truncation=0.1, device=device)
        for _ in range(count):
            volume.integrate(depth, SMALL, T, color=np.full((SMALL.height, SMALL.width, 3), shade, np.uint8))
        parts.append(volume)
    fused = loom.meshing.fuse_volumes(parts, [T, T])
    weights, colors = voxels_of(fused)[2:]
    assert set(np.unique(weights)) == {0, 4} and np.abs(colors[weights == 4] / 257.0 - 160).max() < 0.01
    plain = loom.meshing.fuse_volumes(parts, [T, T], color=False)
    assert not plain.has_color and (voxels_of(plain)[2] == weights).all()


UTM = np.array([500_000.0, 4_000_000.0, 100.0])


def splats_of(mesh, count, color=(0.8, 0.3, 0.1), *, thickness=0.1, at=(0, 0, 0), device="cpu"):
    cloud = mesh.sample_points_uniformly(count, use_triangle_normal=True, seed=0)
    normals = cloud.normals.astype(float)
    axes = np.cross([0.0, 0.0, 1.0], normals)
    angles = np.arctan2(np.linalg.norm(axes, axis=1), normals[:, 2])
    axes /= np.maximum(np.linalg.norm(axes, axis=1, keepdims=True), 1e-12)
    rotations = np.roll(Rotation.from_rotvec(axes * angles[:, None]).as_quat(), 1, axis=1)
    size = 0.8 * np.sqrt(mesh.get_surface_area() / count)
    harmonics = np.tile((np.array(color) - 0.5) / 0.28209479177387814, (count, 1))
    scales = np.tile([size, size, thickness * size], (count, 1))
    return loom.GaussianSplats(cloud.points + at, scales, rotations, np.full(count, 0.95), harmonics, device=device)


def test_a_ball_is_reconstructed_with_its_color(device, at=UTM):
    splats = splats_of(loom.TriangleMesh.create_sphere(1.0, 40), 2000, at=at, device=device)
    mesh = loom.meshing.fuse_splats(splats, voxel_size=0.08)
    apart = np.linalg.norm(mesh.vertices - at, axis=1) - 1
    assert np.abs(apart).max() < 0.06 and np.abs(apart).mean() < 0.02
    assert abs(mesh.get_surface_area() / (4 * np.pi) - 1) < 0.05 and mesh.is_watertight()
    np.testing.assert_allclose(np.median(mesh.vertex_colors, axis=0), [0.8, 0.3, 0.1], atol=0.01)


def test_given_views_show_the_inside_of_a_room(device):
    room = loom.TriangleMesh.create_box(4, 3, 2.5).translate([-2, -1.5, -1.2])
    splats = splats_of(room, 8000, device=device)
    camera = loom.PinholeCameraIntrinsic(80, 60, 45.0, 45.0, 39.5, 29.5)
    poses = []
    for k in range(24):
        T = np.eye(4)
        rotation = Rotation.from_euler("yx", [30 * k, 35 * (-1) ** k], degrees=True)
        T[:3, :3] = (rotation.inv() * Rotation.from_euler("x", 90, degrees=True)).as_matrix()
        poses.append(T)
    mesh = loom.meshing.fuse_splats(splats, camera, poses, voxel_size=0.1, weight_threshold=1)
    v = mesh.vertices
    apart = np.min(np.abs(np.abs(v - [0, 0, 0.05]) - [2, 1.5, 1.25]), axis=1)
    assert len(v) > 5000 and np.median(apart) < 0.003 and np.quantile(apart, 0.95) < 0.02


def test_splats_beyond_the_largest_depth_are_not_fused():
    """Two balls, 2 m and 5 m before the camera."""
    ball = loom.TriangleMesh.create_sphere(0.5, 12)
    splats = loom.GaussianSplats.concatenate([splats_of(ball.translate([0, 0.3 * z - 1, z]), 1500) for z in (2, 5)])
    camera, events = loom.PinholeCameraIntrinsic(80, 60, 60.0, 60.0, 39.5, 29.5), []
    for limit, farthest in ((9.0, 5), (3.0, 2)):
        mesh = loom.meshing.fuse_splats(splats, camera, [np.eye(4)] * 2, voxel_size=0.08, depth_max=limit,
                                        weight_threshold=1, progress=lambda *event: events.append(event))  # fmt: skip
        assert farthest - 0.6 < mesh.vertices[:, 2].max() < farthest
    assert events[:2] == [("fuse splats", 0, 2), ("fuse splats", 1, 2)]

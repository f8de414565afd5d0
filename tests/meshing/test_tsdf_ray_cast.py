"""Ray casting a TSDFVolume: correct depth, points and normals, and no ray passes a wall."""

import numpy as np
import pytest
from scipy.spatial import cKDTree

import pointloom as loom
from pointloom.kernels.volumes.tsdf_blocks import SIDE, block_box

from .tsdf_scenes import (
    CAMERA,
    FINE,
    RADIUS,
    TRUNCATION,
    VOXEL,
    fuse,
    fused_sphere,
    look_at,
    plane_depth,
    rays_of,
    set_voxels,
    sphere_depth,
    sphere_frames,
    triangle_normals,
    view_from,
)

MEDIUM = loom.PinholeCameraIntrinsic(320, 240, 262.0, 266.0, 158.4, 119.7)


def angles_between(a, b):
    return np.degrees(np.arccos(np.clip(np.einsum("...i,...i->...", a, b), -1, 1)))


def test_a_ray_cast_sphere_has_exact_depth_and_points(device):
    """From new positions. Means of distances along z are off by 0.12 voxel rms, see the mesh."""
    volume = fused_sphere(device)
    for eye in ((1.0, 0.5, 0.4), (-0.3, 1.2, 0.2), (0.7, 0.2, -0.3)):
        T = look_at(eye)
        view, truth = view_from(volume, T), sphere_depth(CAMERA, T)
        sight = rays_of(CAMERA, T)
        outward = (sight * truth[..., None] + T[:3, 3]) / RADIUS
        facing = -(outward * sight).sum(-1) / np.linalg.norm(sight, axis=-1)
        inner = (truth > 0) & (facing > 0.5)
        assert inner.sum() > 3000
        assert (view.depth[inner] > 0).all(), "no pixel passes the surface"
        error = np.abs(view.depth - truth)[inner]
        assert np.quantile(error, 0.99) < 0.5 * VOXEL and error.max() < VOXEL
        assert np.quantile(angles_between(view.normals[inner], outward[inner]), 0.9) < 13
        assert np.abs(view.points - (sight * view.depth[..., None] + T[:3, 3]))[inner].max() < 1e-5
        empty = (truth == 0) & (view.depth == 0)
        assert np.isnan(view.points[empty]).all() and np.isnan(view.normals[empty]).all()
        assert empty.sum() > 0.9 * (truth == 0).sum()


@pytest.mark.parametrize(("truncation", "tilt"), [(1, 0), (2, 75), (4, 60), (24, 75)])
def test_no_ray_passes_a_wall(device, truncation, tilt):
    """Fused from a camera at a grazing angle, where the truncation is thin, then viewed frontally."""
    angle = np.radians(tilt)
    normal, offset = np.array([0.0, 0.0, -1.0]), -0.0137
    T = look_at((1.2 * np.sin(angle), 0.02, -1.2 * np.cos(angle)))
    volume = fuse([(plane_depth(FINE, T, normal, offset), T)], device, camera=FINE, truncation=truncation * VOXEL)
    mesh = volume.extract_triangle_mesh(0)
    centers = cKDTree(triangle_normals(mesh)[1])
    for eye in ((0.0, 0.0, -0.8), (0.02, 0.3, -0.5), (0.6 * np.sin(angle), 0, -0.6 * np.cos(angle) - 0.05)):
        V = look_at(eye)
        view, truth = view_from(volume, V, MEDIUM), plane_depth(MEDIUM, V, normal, offset)
        checked = view.depth == 0  # all misses, and a quarter of the rest
        checked[::2, ::2] = True
        checked &= truth > 0
        wall = (rays_of(MEDIUM, V) * truth[..., None] + V[:3, 3])[checked]
        covered = centers.query(wall, 8)[0][:, 7] < 1.1 * VOXEL  # four cells with triangles around it
        depth, points = view.depth[checked][covered], view.points[checked][covered]
        assert len(depth) > 1000
        assert (depth == 0).sum() == 0
        assert centers.query(points)[0].max() < 1.2 * VOXEL, "hits lie on the mesh"


def test_no_ray_passes_a_plate_of_two_voxels(device):
    """Seen from both sides: its inside is so thin that a long step would pass it."""
    poses = [look_at((0.7, 0.1, -0.9)), look_at((0.6, -0.1, 0.9)), look_at((-0.7, 0, -0.9)), look_at((-0.7, 0.05, 0.9))]
    sides = [-0.021 if T[2, 3] < 0 else 0.021 for T in poses]
    frames = [(plane_depth(FINE, T, np.array([0, 0, 1.0]), z), T) for T, z in zip(poses, sides, strict=True)]
    volume = fuse(frames, device, camera=FINE)
    for sign in (-1, 1):
        view = view_from(volume, look_at((0.05, 0.02, sign * 0.6)), CAMERA)
        middle = np.s_[20:100, 30:130]
        assert (view.depth[middle] > 0).all()
        assert np.abs(view.points[middle][..., 2] - sign * 0.021).max() < 1.5 * VOXEL


def test_the_image_does_not_depend_on_the_unit_of_length(device):
    scale, large, T = 0.002, fused_sphere(device), look_at((1.0, 0.5, 0.4))
    small = fuse(sphere_frames(scale=scale), device, voxel_size=VOXEL * scale, truncation=TRUNCATION * scale)
    S = T.copy()
    S[:3, 3] *= scale
    a, b = view_from(large, T), view_from(small, S, depth_min=0.1 * scale, depth_max=3.0 * scale)
    same = (a.depth > 0) & (b.depth > 0)
    assert ((a.depth > 0) ^ (b.depth > 0)).mean() < 0.002
    assert np.quantile(np.abs(a.depth - b.depth / scale)[same], 0.99) < 0.05 * VOXEL


def test_depth_limits_cut_the_image(device):
    volume = fuse([(np.full((120, 160), 1.2345), np.eye(4))], device)
    inner = np.s_[20:100, 20:140]
    assert (view_from(volume, np.eye(4)).depth[inner] > 0).all()
    assert (view_from(volume, np.eye(4), depth_min=1.1, depth_max=1.3).depth[inner] > 0).all()
    assert not view_from(volume, np.eye(4), depth_max=1.2).depth.any()
    assert not view_from(volume, np.eye(4), depth_min=1.3).depth.any()
    assert not view_from(volume, look_at((0, 0, 5), (0, 0, 9))).depth.any(), "behind the camera"


def test_a_far_camera_sees_surfaces_within_its_depth(device):
    """The ray enters the bounding box of the blocks at once and does not end in the empty space before it."""
    volume = fused_sphere(device)
    tele = loom.PinholeCameraIntrinsic(32, 24, 31_000.0, 31_000.0, 15.5, 11.5)
    T = look_at((900.0, 200.0, 100.0))
    view, truth = view_from(volume, T, tele, depth_max=2000.0), sphere_depth(tele, T)
    assert (truth > 0).sum() > 300
    inner = (truth > 0) & (np.roll(truth, 2, 0) > 0) & (np.roll(truth, -2, 0) > 0) & (np.roll(truth, 2, 1) > 0)
    assert np.abs(view.depth - truth)[inner].max() < VOXEL
    assert view_from(volume, T, tele, depth_max=900.0).depth.max() == 0


def test_a_camera_beyond_the_limit_is_rejected(device):
    volume = fused_sphere(device)
    with pytest.raises(ValueError, match="extrinsic:"):
        view_from(volume, look_at((1e6, 0, 0)))


def partly_seen_plane(device, normal, offset, is_seen):
    """A plane with exact distances, seen from below where `is_seen(x, z)` [voxels]."""
    volume = fuse([(plane_depth(FINE, T, normal, offset), T) for T in [look_at((0, 0, -1.2))]], device, camera=FINE)
    count, cells = volume.block_count, volume.block_count * SIDE**3
    blocks = block_box(volume._blocks.keys.numpy()[:count])
    x, y, z = (blocks[:, :, None] * SIDE).T.reshape(3, -1, 1) + np.indices([SIDE] * 3).reshape(3, 1, -1)
    inward = (np.stack([x, y, z], axis=-1) @ normal * VOXEL - offset).reshape(-1) / TRUNCATION
    distances, weights = (getattr(volume._blocks, name).numpy().copy() for name in ("distances", "weights"))
    distances[:cells] = np.clip(inward, -1, 1)
    weights[:cells] = (np.abs(inward) < 1) & is_seen(x, z).reshape(-1)
    set_voxels(volume, "distances", distances)
    set_voxels(volume, "weights", weights)
    return volume


def test_a_ray_past_an_unseen_voxel_hits_the_surface(device):
    """It enters a cell beside a voxel before the surface, passes the unseen voxel, and leaves beside one behind."""
    volume = partly_seen_plane(device, np.array([0, 0, -1.0]), -VOXEL / 2, lambda x, z: (z != 0) | (x % 2 == 0))
    entry, camera = np.array([0.1, 0.3, 0]) * VOXEL, loom.PinholeCameraIntrinsic(2, 2, 1000, 1000, 0.5, 0.5)
    view = view_from(volume, look_at(entry - [0.4, 0, 0.4], entry), camera)
    assert (view.depth > 0).all() and np.abs(view.points - entry).max() < VOXEL


@pytest.mark.parametrize("side", [1, -1])
def test_normals_beside_unseen_voxels_match_the_surface(device, side):
    """A tilted plane, half of it unseen: the last hits have a gradient on one side only."""
    normal = np.array([-0.5, 0, -np.sqrt(0.75)])
    view = view_from(partly_seen_plane(device, normal, 0.013, lambda x, z: side * x <= 0), look_at((0, 0, -0.9)), FINE)
    hit = view.depth > 0
    beside = hit & (side * view.points[..., 0] > -0.45 * VOXEL)
    known = np.isfinite(view.normals).all(axis=-1)  # a hit in a corner between unseen voxels has no normal
    assert (hit & known).sum() > 10_000 and (beside & known).sum() > 500
    assert angles_between(view.normals[hit & known], normal).max() < 0.2

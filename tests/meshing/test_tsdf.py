"""TSDFVolume: frames follow the rule of the docstring to the voxel, and the surface is the one that was seen."""

import hashlib
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial import cKDTree

import pointloom as loom
from pointloom.kernels.images.depth import largest_depth
from pointloom.kernels.lang import uint16
from pointloom.kernels.memory import upload
from pointloom.kernels.volumes import tsdf_blocks
from pointloom.kernels.volumes.tsdf_blocks import SIDE, block_box, touched_blocks
from pointloom.pcd.errors import DeviceError
from pointloom.pcd.images import upload_depth

VOXEL, TRUNCATION = 0.02, 0.08
RADIUS = 0.4
CAMERA = loom.PinholeCameraIntrinsic(160, 120, 131.0, 133.0, 79.2, 59.9)
FINE = loom.PinholeCameraIntrinsic(640, 480, 524.0, 532.0, 317.3, 239.9)  # where the stair of nearest pixels would show
SMALL = loom.PinholeCameraIntrinsic(32, 24, 31.0, 29.0, 15.3, 11.7)


def look_at(eye, target=(0, 0, 0), up=(0.1, 0.2, 1.0)):
    """Camera to world."""
    forward = np.subtract(target, eye) / np.linalg.norm(np.subtract(target, eye))
    right = np.cross(forward, up)
    right /= np.linalg.norm(right)
    T = np.eye(4)
    T[:3, 0], T[:3, 1], T[:3, 2], T[:3, 3] = right, np.cross(forward, right), forward, eye
    return T


def rays_of(camera, T):
    """Directions [h, w, 3] in the world whose parameter is depth along z."""
    v, u = np.mgrid[: camera.height, : camera.width]
    local = np.stack([(u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, np.ones(u.shape)], axis=-1)
    return local @ T[:3, :3].T


def plane_depth(camera, T, normal, offset):
    """Depth of the plane normal . x = offset; 0 where it is behind the camera."""
    with np.errstate(divide="ignore"):
        d = (offset - T[:3, 3] @ normal) / (rays_of(camera, T) @ normal)
    return np.where((d > 0) & np.isfinite(d), d, 0)


def sphere_depth(camera, T, radius=RADIUS, center=(0, 0, 0)):
    rays, eye = rays_of(camera, T), T[:3, 3] - center
    a, b, c = (rays**2).sum(-1), rays @ eye, eye @ eye - radius**2
    root = b * b - a * c
    return np.where(root >= 0, (-b - np.sqrt(np.maximum(root, 0))) / a, 0)


def directions_around():
    """The 14 directions to the faces and corners of a cube."""
    faces = [s * e for e in np.eye(3) for s in (-1.0, 1.0)]
    corners = [np.array([x, y, z]) / 3**0.5 for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
    return [*faces, *corners]


def sphere_frames(camera=CAMERA, distance=1.3, scale=1.0, center=(0, 0, 0)):
    for direction in directions_around():
        T = look_at(np.add(direction * (distance * scale), center), center)
        yield sphere_depth(camera, T, RADIUS * scale, center), T


def fuse(frames, device, *, camera=CAMERA, voxel_size=VOXEL, truncation=TRUNCATION, depth_max=3.0):
    volume = loom.TSDFVolume(voxel_size=voxel_size, truncation=truncation, color=False, device=device)
    for depth, T in frames:
        volume.integrate(depth, camera, np.linalg.inv(T), depth_max=depth_max)
    return volume


def fused_sphere(device, **options):
    return fuse(sphere_frames(), device, **options)


def voxels_of(volume):
    """(blocks [m, 3], distances, weights, colors or None), all of shape [m, 8, 8, 8, ...], sorted by block."""
    blocks, keys = volume._blocks, volume._blocks.keys.numpy()[: volume.block_count]
    order, used = np.argsort(keys), volume.block_count * SIDE**3
    shape = (-1, SIDE, SIDE, SIDE)
    distances, weights = (v.numpy()[:used].reshape(shape)[order] for v in (blocks.distances, blocks.weights))
    colors = blocks.colors.numpy()[:used].reshape(*shape, 3)[order] if volume.has_color else None
    return block_box(keys[order]), distances, weights, colors


def set_voxels(volume, name, values):
    """Overwrite one of the volume's voxel arrays."""
    setattr(volume._blocks, name, upload(values, getattr(volume._blocks, name).dtype, volume.device))


def fingerprint(volume):
    """All bits that a volume holds, by block."""
    return b"".join(a.tobytes() for a in voxels_of(volume) if a is not None)


def dense_field(volume, threshold):
    """(field, low voxel): the distances in one array, NaN where weights do not exceed the threshold."""
    blocks, distances, weights, _ = voxels_of(volume)
    low = blocks.min(axis=0)
    size = (blocks.max(axis=0) + 1 - low) * SIDE
    field = np.full(size, np.nan, np.float32)
    for block, d, w in zip((blocks - low) * SIDE, distances, weights, strict=True):
        field[block[0] : block[0] + 8, block[1] : block[1] + 8, block[2] : block[2] + 8] = np.where(
            w > threshold, d, np.nan
        )
    return field, low * SIDE


class Reference:
    """The rule in float64 and plain NumPy, for the blocks that each frame touches."""

    def __init__(self, voxel_size, truncation):
        self.voxel_size, self.truncation, self.blocks = voxel_size, truncation, {}

    def integrate(self, depth, camera, T, color=None):
        metric, largest, height, width = upload_depth(depth, 1000.0, 3.0, None)
        keys = touched_blocks(metric, largest_depth(largest), camera, T, self.truncation, self.voxel_size)
        grid = np.moveaxis(np.mgrid[:8, :8, :8], 0, -1)
        for key, block in zip(keys.numpy().tolist(), block_box(keys.numpy()), strict=True):
            shape = (8, 8, 8)
            fresh = (np.zeros(shape), np.zeros(shape, int), np.zeros((*shape, 3)), np.ones(shape, bool))
            mean, weight, shade, clear = self.blocks.setdefault(key, fresh)
            p = (block * 8 + grid) * self.voxel_size @ np.linalg.inv(T)[:3, :3].T + np.linalg.inv(T)[:3, 3]
            z = p[..., 2]
            front = np.where(z > 0, z, 1)
            u, v = p[..., 0] / front * camera.fx + camera.cx + 0.5, p[..., 1] / front * camera.fy + camera.cy + 0.5
            clear &= (np.abs(u - np.round(u)) > 1e-3) & (np.abs(v - np.round(v)) > 1e-3) & (np.abs(z) > 1e-5)
            inside = (z > 0) & (u >= 0) & (v >= 0) & (u < width) & (v < height)
            row, column = (np.where(inside, np.floor(c), 0).astype(int) for c in (v, u))
            d = metric.numpy().reshape(height, width)[row, column].astype(np.float64)
            sdf = d - z
            clear &= np.abs(sdf + self.truncation) > 1e-5
            seen = inside & (d > 0) & (sdf >= -self.truncation)
            value = np.minimum(1, sdf / self.truncation)
            w = weight[seen]
            mean[seen] = (mean[seen] * w + value[seen]) / (w + 1)
            if color is not None:
                shade[seen] = (shade[seen] * w[:, None] + color[row, column][seen] * 257.0) / (w + 1)[:, None]
            weight[seen] = np.minimum(w + 1, 65535)

    def arrays(self):
        return [np.stack([self.blocks[key][i] for key in sorted(self.blocks)]) for i in range(4)]


# ------------------------------------------------------------------------------------------------ integration


def small_frames(rng, count):
    """Rough depth with holes, seen from random places."""
    for _ in range(count):
        T = look_at(rng.uniform(-0.3, 0.3, 3), rng.uniform((-0.4, -0.4, 1.5), (0.4, 0.4, 2)))
        depth = 1.2 + 0.3 * rng.random((SMALL.height, SMALL.width)) * (rng.random() < 0.5)
        depth[rng.random(depth.shape) < 0.1] = 0
        yield depth, T, rng.integers(0, 256, (*depth.shape, 3), dtype=np.uint8)


@pytest.mark.parametrize(("voxel_size", "truncation"), [(0.02, 0.08), (0.05, 0.05), (0.03, 0.4)])
def test_voxels_follow_the_rule_in_float64(device, rng, voxel_size, truncation):
    volume = loom.TSDFVolume(voxel_size=voxel_size, truncation=truncation, device=device)
    reference = Reference(voxel_size, truncation)
    for depth, T, color in small_frames(rng, 6):
        volume.integrate(depth, SMALL, np.linalg.inv(T), color=color)
        reference.integrate(depth, SMALL, T, color)
    blocks, distances, weights, colors = voxels_of(volume)
    mean, weight, shade, clear = reference.arrays()
    assert len(blocks) == len(mean)
    assert clear.mean() > 0.97, "voxels left out for lying within 0.001 pixel of another pixel"
    np.testing.assert_array_equal(weights[clear], weight[clear])
    assert weight.max() >= 3
    assert np.abs(distances - mean)[clear].max() < 1e-5  # p in float32: 3 m x 6e-8 over the least truncation of 0.05 m
    assert np.abs(colors.astype(float) - shade)[clear].max() <= 3  # half a step of 1/65535 a frame


def test_a_voxel_that_no_frame_sees_is_zero(device, rng):
    volume = loom.TSDFVolume(voxel_size=VOXEL, truncation=TRUNCATION, device=device)
    depth, T, color = next(small_frames(rng, 1))
    volume.integrate(depth, SMALL, np.linalg.inv(T), color=color)
    _, distances, weights, colors = voxels_of(volume)
    assert 0 < (weights == 0).mean() < 1
    assert not distances[weights == 0].any() and not colors[weights == 0].any()


def test_the_same_frame_again_adds_weight_and_changes_no_value(device, rng):
    depth, T, color = next(small_frames(rng, 1))
    once, twice = (loom.TSDFVolume(voxel_size=VOXEL, truncation=TRUNCATION, device=device) for _ in range(2))
    for volume, times in ((once, 1), (twice, 2)):
        for _ in range(times):
            volume.integrate(depth, SMALL, np.linalg.inv(T), color=color)
    a, b = voxels_of(once), voxels_of(twice)
    assert a[1].tobytes() == b[1].tobytes()
    np.testing.assert_array_equal(2 * a[2], b[2])
    np.testing.assert_array_equal(a[3], b[3])


def test_weights_stop_at_65535_and_values_go_on_as_a_running_mean(device):
    volume = loom.TSDFVolume(voxel_size=VOXEL, truncation=TRUNCATION, color=False, device=device)
    depth = np.full((SMALL.height, SMALL.width), 1.005)
    volume.integrate(depth, SMALL, np.eye(4))
    weights = volume._blocks.weights.numpy()
    set_voxels(volume, "weights", np.where(weights > 0, 65534, 0).astype(np.uint16))
    for expected in (65535, 65535):
        volume.integrate(depth + 0.02, SMALL, np.eye(4))
        now = volume._blocks.weights.numpy()
        assert now.max() == expected and now.dtype == np.uint16
        assert (now[weights > 0] >= 65534).all(), "no weight wraps around"
    mesh = volume.extract_triangle_mesh(weight_threshold=65534)
    assert len(mesh) > 0 and np.abs(mesh.vertices[:, 2] - 1.005).max() < 1e-4
    assert len(volume.extract_triangle_mesh(weight_threshold=65535)) == 0


@pytest.mark.parametrize("bad", [0.0, np.nan, np.inf, -np.inf, -1.0, 3.5])
def test_pixels_without_a_measurement_are_as_if_zero(device, rng, bad):
    depth, T, _ = next(small_frames(rng, 1))
    holes = rng.random(depth.shape) < 0.3
    volumes = []
    for value in (0.0, bad):
        frame = np.where(holes, value, depth)
        volumes.append(fuse([(frame, T)], device, camera=SMALL))
    assert fingerprint(volumes[0]) == fingerprint(volumes[1])
    if bad != 3.5:
        assert fingerprint(
            fuse([(np.where(holes, bad, depth), T)], device, camera=SMALL, depth_max=np.inf)
        ) == fingerprint(volumes[0])


def test_integers_with_a_scale_are_floats_in_metres(device, rng):
    depth, T, _ = next(small_frames(rng, 1))
    raw = np.round(depth * 5000).astype(np.uint16)
    a, b, c = (loom.TSDFVolume(voxel_size=VOXEL, truncation=TRUNCATION, color=False, device=device) for _ in range(3))
    a.integrate(raw, SMALL, np.linalg.inv(T), depth_scale=5000.0)
    b.integrate(raw.astype(np.float32) / np.float32(5000), SMALL, np.linalg.inv(T), depth_scale=123.0)
    c.integrate(raw.astype(np.int64), SMALL, np.linalg.inv(T), depth_scale=5000.0)
    assert fingerprint(a) == fingerprint(b) == fingerprint(c)
    assert a.block_count > 10


def test_colour_is_for_every_frame_or_for_none(device, rng):
    """A colour without a weight of its own cannot skip frames: mixing is refused, not averaged with black."""
    depth, T, color = next(small_frames(rng, 1))
    E = np.linalg.inv(T)
    volume = loom.TSDFVolume(voxel_size=VOXEL, truncation=TRUNCATION, device=device)
    volume.integrate(depth, SMALL, E, color=color)
    before = fingerprint(volume)
    with pytest.raises(ValueError, match="color: the frames so far came with colour"):
        volume.integrate(depth, SMALL, E)
    assert fingerprint(volume) == before and volume.frame_count == 1
    plain = loom.TSDFVolume(voxel_size=VOXEL, truncation=TRUNCATION, device=device)
    plain.integrate(depth, SMALL, E)
    with pytest.raises(ValueError, match="color: the frames so far came without"):
        plain.integrate(depth, SMALL, E, color=color)
    assert plain.extract_triangle_mesh(0).vertex_colors is None
    assert not plain.extract_point_cloud(0).has_colors
    assert plain.ray_cast(SMALL, E, weight_threshold=0).colors is None


def test_grey_pictures_and_colours_reach_the_surface(device):
    depth, E = np.full((SMALL.height, SMALL.width), 1.01), np.eye(4)
    volume = loom.TSDFVolume(voxel_size=VOXEL, truncation=TRUNCATION, device=device)
    shade = np.empty((SMALL.height, SMALL.width, 3), np.uint8)
    shade[:] = (250, 120, 3)
    for _ in range(5):
        volume.integrate(depth, SMALL, E, color=shade)
    expected = np.array([250, 120, 3]) / 255
    mesh, view = volume.extract_triangle_mesh(3), volume.ray_cast(SMALL, E)
    assert np.abs(mesh.vertex_colors - expected).max() < 2e-5
    assert np.abs(view.colors[view.depth > 0] - expected).max() < 2e-5
    grey = loom.TSDFVolume(voxel_size=VOXEL, truncation=TRUNCATION, device=device)
    grey.integrate(depth, SMALL, E, color=shade[:, :, 1])
    assert np.abs(grey.extract_triangle_mesh(0).vertex_colors - 120 / 255).max() < 2e-5


def test_growth_keeps_the_bits_of_old_blocks(device, rng):
    volume = loom.TSDFVolume(voxel_size=VOXEL, truncation=TRUNCATION, device=device)
    capacities, old = set(), {}
    for step in range(6):
        T = look_at((10.0 * step, 0, 0), (10.0 * step, 0.3, 5))  # frames that share no block
        color = rng.integers(0, 256, (SMALL.height, SMALL.width, 3), dtype=np.uint8)
        volume.integrate(rng.uniform(0.5, 2.5, (SMALL.height, SMALL.width)), SMALL, np.linalg.inv(T), color=color)
        capacities.add(volume._blocks.keys.size)
        blocks, *values = voxels_of(volume)
        now = {tuple(b): b"".join(v[i].tobytes() for v in values) for i, b in enumerate(blocks)}
        assert old.items() <= now.items()
        assert len(now) > len(old)
        old = now
    assert len(capacities) >= 3
    assert volume.block_count == len(old)


def test_a_frame_without_depth_counts_and_touches_nothing(device):
    volume = loom.TSDFVolume(voxel_size=VOXEL, truncation=TRUNCATION, device=device)
    assert volume.integrate(np.zeros((SMALL.height, SMALL.width), np.uint16), SMALL, np.eye(4)) == 0
    assert (volume.frame_count, volume.block_count) == (1, 0)
    assert len(volume.extract_triangle_mesh(0)) == 0


def test_both_ways_to_find_blocks_give_the_same_volume(device, monkeypatch):
    first = fingerprint(fused_sphere(device))
    monkeypatch.setattr(tsdf_blocks, "MAX_GRID", 0)
    assert fingerprint(fused_sphere(device)) == first


# ------------------------------------------------------------------------------------------------ surface


def boundary_edges(mesh):
    """Vertex numbers [k, 2] of the edges with one triangle; edges with more than two fail."""
    t = mesh.triangles.astype(np.int64)
    sides = np.concatenate([t[:, [0, 1]], t[:, [1, 2]], t[:, [2, 0]]])
    edges, count = np.unique(np.sort(sides, axis=1), axis=0, return_counts=True)
    assert count.max() <= 2
    directed = len(np.unique(sides, axis=0))
    assert directed == len(sides), "neighbours turn the same way"
    return edges[count == 1]


def assert_tidy(mesh):
    assert np.isfinite(mesh.vertices).all()
    assert np.array_equal(np.unique(mesh.triangles), np.arange(len(mesh.vertices))), "no vertex without a triangle"
    assert len(np.unique(mesh.vertices.astype(np.float32), axis=0)) == len(mesh.vertices), "no two at one place"


def triangle_normals(mesh):
    a, b, c = mesh.vertices[mesh.triangles].transpose(1, 0, 2)
    n = np.cross(b - a, c - a)
    return n / np.linalg.norm(n, axis=1, keepdims=True), (a + b + c) / 3


def test_a_frontal_plane_is_exact(device):
    mesh = fuse([(np.full((120, 160), 1.2345), np.eye(4))], device).extract_triangle_mesh(0)
    assert np.abs(mesh.vertices[:, 2] - 1.2345).max() < 1e-5
    assert (triangle_normals(mesh)[0][:, 2] < -0.999).all(), "towards the camera"
    assert_tidy(mesh)


def test_a_tilted_plane_seen_from_two_sides_is_whole_and_flat(device):
    normal = np.array([0.3, -0.4, -np.sqrt(0.75)])
    poses = [look_at((0, 0, -1.4), (0.1, 0, 0)), look_at((-0.4, 0.5, -1.3), (0, 0, 0))]
    frames = [(plane_depth(FINE, T, normal, 0.013), T) for T in poses]
    # A cell needs its corners within the truncation: 3^0.5 voxels behind a plane seen at 76 degrees are 7.2 along z.
    volume = fuse(frames, device, camera=FINE, truncation=8 * VOXEL)
    mesh = volume.extract_triangle_mesh(1)
    assert_tidy(mesh)
    distance = mesh.vertices @ normal - 0.013
    assert np.sqrt(np.mean(distance**2)) < 0.05 * VOXEL
    assert (triangle_normals(mesh)[0] @ normal).min() > 0.5
    border = np.unique(boundary_edges(mesh))
    assert len(border) > 0
    for T in poses:  # a boundary only where one of the two pictures or its depth ends
        p = (mesh.vertices - T[:3, 3]) @ T[:3, :3]
        u, v = p[:, 0] / p[:, 2] * FINE.fx + FINE.cx, p[:, 1] / p[:, 2] * FINE.fy + FINE.cy
        margin = np.minimum(np.minimum(u, FINE.width - 1 - u), np.minimum(v, FINE.height - 1 - v))
        inner = (margin > 3 * VOXEL / p[:, 2] * FINE.fx) & (p[:, 2] < 3.0 - 8 * VOXEL)
        border = border[inner[border]]
    assert len(border) == 0


def test_a_sphere_seen_from_all_sides_is_closed_and_round(device):
    mesh = fused_sphere(device).extract_triangle_mesh(0)
    assert_tidy(mesh)
    assert len(boundary_edges(mesh)) == 0 and mesh.is_watertight()
    error = np.linalg.norm(mesh.vertices, axis=1) - RADIUS
    assert np.sqrt(np.mean(error**2)) < 0.3 * VOXEL
    normals, centers = triangle_normals(mesh)
    assert (np.einsum("ij,ij->i", normals, centers) > 0).all(), "outward, towards the cameras"
    assert mesh.get_volume() == pytest.approx(4 / 3 * np.pi * RADIUS**3, rel=0.03)


def test_the_surface_is_that_of_marching_cubes_on_a_dense_copy(device, rng):
    volume = fuse([(d, T) for d, T, _ in small_frames(rng, 5)], device, camera=SMALL)
    for threshold in (0, 1):
        mesh = volume.extract_triangle_mesh(threshold)
        field, low = dense_field(volume, threshold)
        dense = loom.marching_cubes(field, spacing=[VOXEL] * 3, origin=low * VOXEL, device=device)
        assert len(mesh) == len(dense) > 100
        assert len(mesh.vertices) == len(dense.vertices)
        distance, twin = cKDTree(dense.vertices).query(mesh.vertices)
        assert distance.max() < 2e-6  # float32 at 4 m, and the product by the voxel
        corners = []
        for triangles in (twin[mesh.triangles], dense.triangles):
            first = triangles.argmin(axis=1)[:, None]
            turned = np.take_along_axis(triangles, (first + np.arange(3)) % 3, axis=1)
            corners.append(turned[np.lexsort(turned.T)])
        np.testing.assert_array_equal(*corners)


def test_a_surface_of_random_values_is_that_of_the_dense_copy(device, rng):
    """Every case of the table, across block borders, with voxels unseen at random."""
    volume = fused_sphere(device)
    count = volume._blocks.distances.size
    set_voxels(volume, "distances", rng.uniform(-1, 1, count).astype(np.float32))
    set_voxels(volume, "weights", rng.integers(0, 30, count).astype(np.uint16))
    mesh = volume.extract_triangle_mesh(1)
    field, low = dense_field(volume, 1)
    dense = loom.marching_cubes(field, spacing=[VOXEL] * 3, origin=low * VOXEL, device=device)
    assert len(mesh) == len(dense) > 10_000
    assert len(mesh.vertices) == len(dense.vertices)
    a, b = (np.sort(triangle_normals(m)[1].round(4), axis=0) for m in (mesh, dense))
    assert np.abs(a - b).max() < 2e-4
    assert cKDTree(dense.vertices).query(mesh.vertices)[0].max() < 2e-6


def test_a_voxel_counts_where_more_frames_than_the_threshold_saw_it(device):
    frame = (np.full((120, 160), 1.2345), np.eye(4))
    volume = fuse([frame] * 3, device)
    sizes = [len(volume.extract_triangle_mesh(t)) for t in (0, 2, 2.5, 3, 4)]
    assert sizes[0] == sizes[1] == sizes[2] > 0 and sizes[3:] == [0, 0]
    assert [len(volume.extract_point_cloud(t)) > 0 for t in (2, 3)] == [True, False]
    assert [(volume.ray_cast(CAMERA, np.eye(4), weight_threshold=t).depth > 0).any() for t in (2, 3)] == [True, False]


def test_points_lie_on_the_sphere_with_outward_normals(device):
    volume = fused_sphere(device)
    cloud, mesh = volume.extract_point_cloud(0), volume.extract_triangle_mesh(0)
    radii = np.linalg.norm(cloud.points, axis=1)
    assert np.sqrt(np.mean((radii - RADIUS) ** 2)) < 0.3 * VOXEL
    assert np.abs(np.linalg.norm(cloud.normals, axis=1) - 1).max() < 1e-5
    cosines = np.einsum("ij,ij->i", cloud.normals, cloud.points / radii[:, None])
    # means of clipped distances from many sides tilt the gradient; 13.8 degrees were measured
    assert cosines.min() > 0.8 and np.quantile(cosines, 0.05) > np.cos(np.radians(15))
    points = set(map(tuple, cloud.points.astype(np.float32).tolist()))
    assert set(map(tuple, mesh.vertices.astype(np.float32).tolist())) <= points, "each vertex is a point"


def test_an_empty_volume_gives_empty_results(device):
    volume = loom.TSDFVolume(voxel_size=VOXEL, device=device)
    mesh, cloud, view = volume.extract_triangle_mesh(), volume.extract_point_cloud(), volume.ray_cast(SMALL, np.eye(4))
    assert (len(mesh), len(mesh.vertices), len(cloud)) == (0, 0, 0)
    assert view.depth.shape == (24, 32) and not view.depth.any()
    assert np.isnan(view.points).all() and np.isnan(view.normals).all()
    assert volume.truncation == 4 * VOXEL


# ------------------------------------------------------------------------------------------------ ray casting


def view_from(volume, T, camera=CAMERA, **options):
    options.setdefault("weight_threshold", 0)
    return volume.ray_cast(camera, np.linalg.inv(T), **options)


def angles_between(a, b):
    return np.degrees(np.arccos(np.clip(np.einsum("...i,...i->...", a, b), -1, 1)))


def test_a_cast_sphere_has_its_true_depth_and_points(device):
    """From places where no camera stood. Means of distances along z are off by 0.12 voxel rms, see the mesh."""
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


def test_a_sphere_cast_from_where_it_was_seen_has_true_depth_and_normals(device):
    T = look_at((1.0, 0.5, 0.4))
    volume = fuse([(sphere_depth(FINE, T), T)], device, camera=FINE)
    view, truth = view_from(volume, T), sphere_depth(CAMERA, T)
    outward = (rays_of(CAMERA, T) * truth[..., None] + T[:3, 3]) / RADIUS
    inner = (truth > 0) & (outward @ look_at((1.0, 0.5, 0.4))[:3, 2] < -0.8)
    assert np.abs(view.depth - truth)[inner].max() < 0.1 * VOXEL
    angles = angles_between(view.normals[inner], outward[inner])
    assert np.quantile(angles, 0.99) < 2 and angles.max() < 4


@pytest.mark.parametrize("tilt", [0, 15, 30])
def test_a_cast_plane_has_its_true_depth_and_normals(device, tilt):
    angle = np.radians(tilt)
    normal = np.array([np.sin(angle), 0.0, -np.cos(angle)])
    poses = [look_at(e) for e in ((0, 0, -1.2), (0.2, 0.1, -1.1), (-0.15, 0.1, -1.25), (0.1, -0.2, -1.2))]
    volume = fuse([(plane_depth(FINE, T, normal, 0.013), T) for T in poses], device, camera=FINE)
    T = look_at((0.05, -0.1, -1.0))
    view, truth = view_from(volume, T, weight_threshold=3), plane_depth(CAMERA, T, normal, 0.013)
    hit = view.depth > 0
    inner = hit.copy()
    for shift in (-6, 6):
        inner &= np.roll(hit, shift, axis=0) & np.roll(hit, shift, axis=1)
    inner[[*range(6), *range(-6, 0)]], inner[:, [*range(6), *range(-6, 0)]] = False, False
    assert hit[50:70, 60:100].all() and inner.sum() > 8000
    assert np.abs(view.depth - truth)[inner].max() < 0.1 * VOXEL
    assert angles_between(view.normals[inner], normal).max() < 2


@pytest.mark.parametrize("truncation", [1, 2, 4, 24])
@pytest.mark.parametrize("tilt", [0, 60, 75])
def test_no_ray_passes_a_wall(device, truncation, tilt):
    """Fused from a camera that sees it at a grazing angle, where its truncation is thin, then looked at straight."""
    angle = np.radians(tilt)
    normal, offset = np.array([0.0, 0.0, -1.0]), -0.0137
    T = look_at((1.2 * np.sin(angle), 0.02, -1.2 * np.cos(angle)))
    volume = fuse([(plane_depth(FINE, T, normal, offset), T)], device, camera=FINE, truncation=truncation * VOXEL)
    mesh = volume.extract_triangle_mesh(0)
    centers = cKDTree(triangle_normals(mesh)[1])
    for eye in ((0.0, 0.0, -0.8), (0.02, 0.3, -0.5), (0.6 * np.sin(angle), 0, -0.6 * np.cos(angle) - 0.05)):
        V = look_at(eye)
        view, truth = view_from(volume, V, FINE), plane_depth(FINE, V, normal, offset)
        asked = view.depth == 0  # all misses, and a sixteenth of the rest
        asked[::4, ::4] = True
        asked &= truth > 0
        wall = (rays_of(FINE, V) * truth[..., None] + V[:3, 3])[asked]
        covered = centers.query(wall, 8)[0][:, 7] < 1.1 * VOXEL  # four cells with triangles around
        depth, points = view.depth[asked][covered], view.points[asked][covered]
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


@pytest.mark.parametrize("scale", [0.05, 0.002])
def test_the_picture_does_not_depend_on_the_unit_of_length(device, scale):
    large, T = fused_sphere(device), look_at((1.0, 0.5, 0.4))
    small = fuse(sphere_frames(scale=scale), device, voxel_size=VOXEL * scale, truncation=TRUNCATION * scale)
    S = T.copy()
    S[:3, 3] *= scale
    a, b = view_from(large, T), view_from(small, S, depth_min=0.1 * scale, depth_max=3.0 * scale)
    same = (a.depth > 0) & (b.depth > 0)
    assert ((a.depth > 0) ^ (b.depth > 0)).mean() < 0.002
    assert np.quantile(np.abs(a.depth - b.depth / scale)[same], 0.99) < 0.05 * VOXEL


def test_a_camera_inside_unseen_space_sees_no_front(device):
    volume = fused_sphere(device)
    view = view_from(volume, look_at((0.0, 0.0, 0.0), (1, 0, 0)))
    assert not view.depth.any(), "from inside there are only backs"


def test_depth_limits_cut_the_picture(device):
    volume = fuse([(np.full((120, 160), 1.2345), np.eye(4))], device)
    inner = np.s_[20:100, 20:140]
    assert (view_from(volume, np.eye(4)).depth[inner] > 0).all()
    assert (view_from(volume, np.eye(4), depth_min=1.1, depth_max=1.3).depth[inner] > 0).all()
    assert not view_from(volume, np.eye(4), depth_max=1.2).depth.any()
    assert not view_from(volume, np.eye(4), depth_min=1.3).depth.any()
    assert not view_from(volume, look_at((0, 0, 5), (0, 0, 9))).depth.any(), "behind the camera"


def test_a_far_camera_sees_what_lies_within_its_depth(device):
    """The box of the blocks is entered at once: no ray ends in the empty space before it."""
    volume = fused_sphere(device)
    tele = loom.PinholeCameraIntrinsic(32, 24, 31_000.0, 31_000.0, 15.5, 11.5)
    T = look_at((900.0, 200.0, 100.0))
    view, truth = view_from(volume, T, tele, depth_max=2000.0), sphere_depth(tele, T)
    assert (truth > 0).sum() > 300
    inner = (truth > 0) & (np.roll(truth, 2, 0) > 0) & (np.roll(truth, -2, 0) > 0) & (np.roll(truth, 2, 1) > 0)
    assert np.abs(view.depth - truth)[inner].max() < VOXEL
    assert view_from(volume, T, tele, depth_max=900.0).depth.max() == 0


def test_a_camera_beyond_the_limit_is_refused(device):
    volume = fused_sphere(device)
    with pytest.raises(ValueError, match="extrinsic: the camera is 1000000 m"):
        view_from(volume, look_at((1e6, 0, 0)))


# ------------------------------------------------------------------------------------------------ far from zero


def test_a_volume_at_utm_coordinates_is_the_one_at_the_origin(device):
    """The origin is the first camera's place in whole metres: (-1, 0, 0) from the sphere, so are the lattices."""
    near, center = np.array([1.0, 0.0, 0.0]), np.array([500_000.0, 5_400_000.0, 300.0])
    here, there = (fuse(sphere_frames(center=c), device) for c in (near, center))
    np.testing.assert_array_equal(there.origin - center, here.origin - near)
    a, b = here.extract_triangle_mesh(0), there.extract_triangle_mesh(0)
    assert len(a) == len(b)
    assert np.abs(a.vertices - near - (b.vertices - center)).max() < 1e-4
    eye = np.array([1.0, 0.5, 0.4])
    T = look_at(near + eye, near)
    left, right = view_from(here, T), view_from(there, look_at(center + eye, center))
    assert np.quantile(np.abs(left.depth - right.depth), 0.999) < 1e-4
    hit = right.depth > 0
    radii = np.linalg.norm(right.points[hit] - center, axis=1)
    assert np.median(np.abs(radii - RADIUS)) < 0.3 * VOXEL
    cloud = there.extract_point_cloud(0)
    assert np.median(np.abs(np.linalg.norm(cloud.points - center, axis=1) - RADIUS)) < 0.3 * VOXEL


# ------------------------------------------------------------------------------------------------ the same bits

RUN = """
import hashlib, sys
sys.path.insert(0, {tests!r})
import test_tsdf
print(test_tsdf.all_bits("cpu"))
"""


def all_bits(device):
    """A digest of all that a fused sphere gives."""
    volume = fused_sphere(device)
    mesh, cloud = volume.extract_triangle_mesh(0), volume.extract_point_cloud(0)
    view = view_from(volume, look_at((1.0, 0.5, 0.4)))
    arrays = [
        volume._blocks.keys.numpy()[: volume.block_count],
        mesh.vertices,
        mesh.triangles,
        cloud.points,
        cloud.normals,
    ]
    arrays += [view.depth, np.nan_to_num(view.points), np.nan_to_num(view.normals)]
    return hashlib.sha256(fingerprint(volume) + b"".join(a.tobytes() for a in arrays)).hexdigest()


def test_two_runs_give_the_same_bits(device):
    assert all_bits(device) == all_bits(device)


def test_one_and_two_threads_give_the_same_bits():
    pytest.importorskip("taichi")
    tests, digests = Path(__file__).parent, set()
    for threads in ("1", "2"):
        environment = os.environ | {"POINTLOOM_CPU": "taichi", "POINTLOOM_CPU_THREADS": threads}
        environment["PYTHONPATH"] = str(tests.parents[1] / "src")
        run = subprocess.run(
            [sys.executable, "-c", RUN.format(tests=str(tests))],
            env=environment,
            capture_output=True,
            text=True,
            check=False,
        )
        assert run.returncode == 0, run.stderr
        digests.add(run.stdout.strip().splitlines()[-1])
    assert len(digests) == 1 and len(digests.pop()) == 64


# ------------------------------------------------------------------------------------------------ bad input

DEPTH, E = np.full((24, 32), 1.0), np.eye(4)
MIRROR, SCALED, BROKEN = np.diag([-1.0, 1, 1, 1]), np.diag([2.0, 2, 2, 1]), np.full((4, 4), np.nan)
OTHER = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
COLOR = np.zeros((24, 32, 3), np.uint8)
FAR = np.eye(4)
FAR[0, 3] = 1e9


@pytest.mark.parametrize(
    ("arguments", "options", "error", "name"),
    [
        ((DEPTH[0], SMALL, E), {}, ValueError, "depth"),
        ((DEPTH[None], SMALL, E), {}, ValueError, "depth"),
        ((DEPTH[:0], SMALL, E), {}, ValueError, "depth"),
        ((DEPTH.astype(complex), SMALL, E), {}, TypeError, "depth"),
        ((DEPTH > 0, SMALL, E), {}, TypeError, "depth"),
        ((np.full((24, 32), -5), SMALL, E), {}, ValueError, "depth"),
        ((np.full((24, 32), 70_000), SMALL, E), {}, ValueError, "depth"),
        ((DEPTH, OTHER, E), {}, ValueError, "intrinsic"),
        ((DEPTH, "prime sense", E), {}, TypeError, "intrinsic"),
        ((DEPTH, SMALL.matrix, E), {}, TypeError, "intrinsic"),
        ((DEPTH, SMALL, np.eye(3)), {}, ValueError, "extrinsic"),
        ((DEPTH, SMALL, MIRROR), {}, ValueError, "extrinsic"),
        ((DEPTH, SMALL, SCALED), {}, ValueError, "extrinsic"),
        ((DEPTH, SMALL, BROKEN), {}, ValueError, "extrinsic"),
        ((DEPTH, SMALL, "pose"), {}, TypeError, "extrinsic"),
        ((DEPTH, SMALL, FAR, COLOR), {}, ValueError, "extrinsic"),
        ((DEPTH, SMALL, E, COLOR[:12]), {}, ValueError, "color"),
        ((DEPTH, SMALL, E, COLOR / 255), {}, TypeError, "color"),
        ((DEPTH, SMALL, E, COLOR[..., :2]), {}, ValueError, "color"),
        ((DEPTH, SMALL, E, COLOR), {"depth_max": 0}, ValueError, "depth_max"),
        ((DEPTH, SMALL, E, COLOR), {"depth_max": -1}, ValueError, "depth_max"),
        ((DEPTH, SMALL, E, COLOR), {"depth_max": np.nan}, ValueError, "depth_max"),
        ((DEPTH, SMALL, E, COLOR), {"depth_scale": 0}, ValueError, "depth_scale"),
        ((DEPTH, SMALL, E, COLOR), {"depth_scale": "mm"}, TypeError, "depth_scale"),
    ],
)
def test_a_frame_that_is_refused_leaves_the_volume_as_it_was(device, arguments, options, error, name):
    volume = loom.TSDFVolume(voxel_size=VOXEL, truncation=TRUNCATION, device=device)
    for filled in (False, True):
        before = fingerprint(volume) if filled else b""
        state = (volume.frame_count, volume.block_count, volume.origin.tolist(), volume.memory_bytes)
        if arguments[2] is not FAR or filled:  # the first camera sets the origin, wherever it is
            with pytest.raises(error, match=rf"(^|\b){name}\b.*:"):
                volume.integrate(*arguments, **options)
            assert state == (volume.frame_count, volume.block_count, volume.origin.tolist(), volume.memory_bytes)
            assert not filled or fingerprint(volume) == before
        if not filled:
            volume.integrate(DEPTH, SMALL, E, color=COLOR)


def test_colour_for_a_volume_without_is_refused(device):
    volume = loom.TSDFVolume(voxel_size=VOXEL, color=False, device=device)
    with pytest.raises(ValueError, match="color: the volume was made with color=False"):
        volume.integrate(DEPTH, SMALL, E, color=COLOR)
    assert volume.frame_count == 0


@pytest.mark.parametrize(
    ("options", "error", "name"),
    [
        ({"voxel_size": 0}, ValueError, "voxel_size"),
        ({"voxel_size": -0.01}, ValueError, "voxel_size"),
        ({"voxel_size": np.nan}, ValueError, "voxel_size"),
        ({"voxel_size": np.inf}, ValueError, "voxel_size"),
        ({"voxel_size": "2 cm"}, TypeError, "voxel_size"),
        ({"voxel_size": 0.02, "truncation": 0.019}, ValueError, "truncation"),
        ({"voxel_size": 0.02, "truncation": 0}, ValueError, "truncation"),
        ({"voxel_size": 0.02, "truncation": np.nan}, ValueError, "truncation"),
        ({"voxel_size": 0.02, "device": "cuda:99"}, DeviceError, "device"),
        ({"voxel_size": 0.02, "device": "abacus"}, DeviceError, "device"),
        ({"voxel_size": 0.02, "device": 3.5}, DeviceError, "device"),
    ],
)
def test_a_volume_of_impossible_sizes_is_refused(options, error, name):
    with pytest.raises(error, match=f"^{name}: "):
        loom.TSDFVolume(**options)


@pytest.mark.parametrize(
    ("options", "error", "name"),
    [
        ({"depth_min": 0}, ValueError, "depth_min"),
        ({"depth_max": 0}, ValueError, "depth_max"),
        ({"depth_min": 2, "depth_max": 1}, ValueError, "depth_min"),
        ({"depth_max": np.nan}, ValueError, "depth_max"),
        ({"weight_threshold": -1}, ValueError, "weight_threshold"),
        ({"weight_threshold": np.nan}, ValueError, "weight_threshold"),
        ({"weight_threshold": "all"}, TypeError, "weight_threshold"),
        ({"extrinsic": SCALED}, ValueError, "extrinsic"),
        ({"extrinsic": np.eye(3)}, ValueError, "extrinsic"),
        ({"intrinsic": "prime sense"}, TypeError, "intrinsic"),
        ({"intrinsic": None}, TypeError, "intrinsic"),
    ],
)
def test_a_view_that_makes_no_sense_is_refused(options, error, name):
    volume = loom.TSDFVolume(voxel_size=VOXEL)
    with pytest.raises(error, match=f"^{name}: "):
        volume.ray_cast(**({"intrinsic": SMALL, "extrinsic": E} | options))


@pytest.mark.parametrize("threshold", [-1, np.nan, "all"])
def test_a_threshold_that_makes_no_sense_is_refused(threshold):
    volume = loom.TSDFVolume(voxel_size=VOXEL)
    for extract in (volume.extract_triangle_mesh, volume.extract_point_cloud):
        with pytest.raises((ValueError, TypeError), match=r"^weight_threshold: "):
            extract(threshold)


@settings(deadline=None, derandomize=True, max_examples=15)
@given(
    st.lists(
        st.sampled_from([0.0, -1.0, np.nan, np.inf, 1e-30, 0.3, 0.31, 1.0, 2.999, 3.0, 1e30]), min_size=4, max_size=4
    ),
    st.floats(0.01, 0.2),
)
def test_any_depth_gives_finite_voxels_within_one(values, voxel_size):
    volume = loom.TSDFVolume(voxel_size=voxel_size, color=False)
    depth = np.resize(np.array(values, np.float32), (24, 32))
    volume.integrate(depth, SMALL, E)
    _, distances, weights, _ = voxels_of(volume)
    assert (np.abs(distances) <= 1).all() and weights.max(initial=0) <= 1
    assert np.isfinite(volume.extract_triangle_mesh(0).vertices).all()
    assert uint16 == volume._blocks.weights.dtype

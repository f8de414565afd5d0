"""Integrated voxels follow the rule in the docstring of TSDFVolume."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.cameras.images import upload_raw_depth
from pointloom.kernels.images.depth import largest_depth, metric_depth
from pointloom.kernels.volumes.tsdf_blocks import block_box, touched_blocks

from .tsdf_scenes import SMALL, TRUNCATION, VOXEL, fingerprint, fuse, look_at, set_voxels, small_frames, voxels_of


class Reference:
    """The rule in float64 NumPy, for the blocks that each frame touches."""

    def __init__(self, voxel_size, truncation):
        self.voxel_size, self.truncation, self.blocks = voxel_size, truncation, {}

    def integrate(self, depth, camera, T, color=None):
        raw, scale, farthest, height, width = upload_raw_depth(depth, None, 3.0, None)
        metric, largest = metric_depth(raw, scale, farthest)
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
    assert np.abs(distances - mean)[clear].max() < 1e-5  # p in float32: 3 m x 6e-8 over the smallest truncation, 0.05 m
    assert np.abs(colors.astype(float) - shade)[clear].max() <= 3  # half a step of 1/65535 a frame


def test_weights_saturate_at_65535_and_values_continue_as_a_running_mean(device):
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


@pytest.mark.parametrize("bad", [0.0, np.nan, np.inf, -np.inf, -1.0, 3.5, 3e38])
def test_invalid_pixels_are_treated_as_zero(device, rng, bad):
    depth, T, _ = next(small_frames(rng, 1))
    holes = rng.random(depth.shape) < 0.3
    volumes = []
    for value in (0.0, bad):
        frame = np.where(holes, value, depth)
        volumes.append(fuse([(frame, T)], device, camera=SMALL))
    assert fingerprint(volumes[0]) == fingerprint(volumes[1]) and volumes[0].memory_bytes == volumes[1].memory_bytes
    if not 3 < bad < np.inf:
        volumes.append(fuse([(np.where(holes, bad, depth), T)], device, camera=SMALL, depth_max=np.inf))
        assert fingerprint(volumes[2]) == fingerprint(volumes[0])


def test_scaled_integers_equal_floats_in_meters(device, rng):
    depth, T, _ = next(small_frames(rng, 1))
    raw = np.round(depth * 5000).astype(np.uint16)
    a, b, c = (loom.TSDFVolume(voxel_size=VOXEL, truncation=TRUNCATION, color=False, device=device) for _ in range(3))
    a.integrate(raw, SMALL, np.linalg.inv(T), depth_scale=5000.0)
    b.integrate(raw.astype(np.float32) / np.float32(5000), SMALL, np.linalg.inv(T))
    c.integrate(raw.astype(np.int64), SMALL, np.linalg.inv(T), depth_scale=5000.0)
    assert fingerprint(a) == fingerprint(b) == fingerprint(c)
    assert a.block_count > 10


def test_color_is_required_for_all_frames_or_none(device, rng):
    """Color without its own weight cannot skip frames: mixing is rejected, not averaged with black."""
    depth, T, color = next(small_frames(rng, 1))
    E = np.linalg.inv(T)
    volume = loom.TSDFVolume(voxel_size=VOXEL, truncation=TRUNCATION, device=device)
    volume.integrate(depth, SMALL, E, color=color)
    before = fingerprint(volume)
    with pytest.raises(ValueError, match="color:"):
        volume.integrate(depth, SMALL, E)
    assert fingerprint(volume) == before and volume.frame_count == 1
    plain = loom.TSDFVolume(voxel_size=VOXEL, truncation=TRUNCATION, device=device)
    plain.integrate(depth, SMALL, E)
    with pytest.raises(ValueError, match="color:"):
        plain.integrate(depth, SMALL, E, color=color)
    assert plain.extract_triangle_mesh(0).vertex_colors is None
    assert not plain.extract_point_cloud(0).has_colors
    assert plain.ray_cast(SMALL, E, weight_threshold=0).colors is None


def test_gray_images_and_colors_are_integrated(device):
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
    gray = loom.TSDFVolume(voxel_size=VOXEL, truncation=TRUNCATION, device=device)
    gray.integrate(depth, SMALL, E, color=shade[:, :, 1])
    assert np.abs(gray.extract_triangle_mesh(0).vertex_colors - 120 / 255).max() < 2e-5


def test_growth_preserves_old_blocks_bitwise(device, rng):
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


def test_a_frame_without_depth_is_counted_and_changes_nothing(device):
    volume = loom.TSDFVolume(voxel_size=VOXEL, truncation=TRUNCATION, device=device)
    assert volume.integrate(np.zeros((SMALL.height, SMALL.width), np.uint16), SMALL, np.eye(4)) == 0
    assert (volume.frame_count, volume.block_count) == (1, 0)
    assert len(volume.extract_triangle_mesh(0)) == 0


def test_mean_colors_are_rounded_to_nearest(device, rng):
    """Truncation would darken a surface over hundreds of frames."""
    volume = loom.TSDFVolume(voxel_size=VOXEL, truncation=TRUNCATION, device=device)
    depth = np.full((SMALL.height, SMALL.width), 1.005)
    volume.integrate(depth, SMALL, np.eye(4), color=np.zeros((*depth.shape, 3), np.uint8))
    seen = volume._blocks.weights.numpy() == 1
    weights = np.where(seen, rng.integers(1, 200, seen.shape), 0)
    colors = np.where(seen[:, None], rng.integers(0, 65536, (len(seen), 3)), 0)
    set_voxels(volume, "weights", weights.astype(np.uint16))
    set_voxels(volume, "colors", colors.astype(np.uint16))
    volume.integrate(depth, SMALL, np.eye(4), color=np.full((*depth.shape, 3), 77, np.uint8))
    mean = (colors * weights[:, None] + 77 * 257.0) / (weights[:, None] + 1)
    again = volume._blocks.weights.numpy() == weights + 1
    assert again.sum() == seen.sum() > 1000
    error = (volume._blocks.colors.numpy() - mean)[again]
    assert np.abs(error).max() < 0.51  # half a step, and the rounding of float32 sums of up to 1.3e7

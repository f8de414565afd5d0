"""TSDFVolume against Open3D's VoxelBlockGrid on real scans, and against the ground truth of the furnished room."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.cameras.images import upload_raw_depth
from pointloom.io.frames.datasets import open_dataset
from pointloom.kernels.images.depth import largest_depth, metric_depth
from pointloom.kernels.volumes.tsdf_blocks import BLOCK_SIDE, block_box, touched_blocks

from .tsdf_scenes import SMALL, TRUNCATION, VOXEL, small_frames

DEPTH_MAX = 3.0


def open3d_voxels(o3d, frames, camera, depth_scale, stride=1):
    """(keys, distances, weights, colors) of all or some voxels of the blocks that frames touch.

    Half a pixel is added to the principal point, as Open3D truncates pixel coordinates that pointloom rounds.
    """
    tensor, types = o3d.core.Tensor, (o3d.core.float32,) * 3
    given = ("tsdf", "weight", "color"), types, ((1), (1), (3)), VOXEL, BLOCK_SIDE, 20_000, o3d.core.Device("CPU:0")
    grid = o3d.t.geometry.VoxelBlockGrid(*given)
    K = camera.matrix
    K[:2, 2] += 0.5
    for depth, color, T in frames:
        images = (o3d.t.geometry.Image(tensor(np.ascontiguousarray(image))) for image in (depth, color))
        metric, largest = metric_depth(*upload_raw_depth(depth, depth_scale, DEPTH_MAX, None)[:3])
        blocks = block_box(touched_blocks(metric, largest_depth(largest), camera, T, TRUNCATION, VOXEL).numpy())
        E = tensor(np.ascontiguousarray(np.linalg.inv(T)))
        sizes = depth_scale, DEPTH_MAX, TRUNCATION / VOXEL
        grid.integrate(tensor(blocks.astype(np.int32)), *images, tensor(K), E, *sizes)
    coordinates, at = grid.voxel_coordinates_and_flattened_indices()
    values = [grid.attribute(n).reshape((-1, c))[at].numpy() for n, c in (("tsdf", 1), ("weight", 1), ("color", 3))]
    keys = flat_key(np.rint(coordinates.numpy() / VOXEL).astype(np.int64))
    order = np.argsort(keys)[::stride]
    return keys[order], values[0][order, 0], values[1][order, 0], values[2][order]


def assert_voxels_are(volume, theirs, stride=1):
    keys, distances, weights, colors = theirs
    used, blocks = volume.block_count * BLOCK_SIDE**3, volume.blocks
    corners = block_box(blocks.keys.numpy()[: volume.block_count])[:, None] * BLOCK_SIDE
    inner = np.stack(np.meshgrid(*[np.arange(BLOCK_SIDE)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    our_keys = flat_key((corners + inner).reshape(-1, 3))
    order = np.argsort(our_keys)[::stride]
    result = [values.numpy()[:used][order] for values in (blocks.distances, blocks.weights, blocks.colors)]
    np.testing.assert_array_equal(our_keys[order], keys)
    same = result[1] == weights
    assert same.mean() > 0.999  # the rest is within rounding of another pixel, or in Open3D's last row or column
    seen = same & (weights > 0)
    assert seen.sum() > 10_000 / stride and (np.abs(result[0] - distances)[seen] < 1e-4).mean() > 0.999
    assert np.quantile(np.abs(result[2] / 257.0 - colors).max(axis=1)[seen], 0.999) < 0.5


def fuse(frames, device, camera, depth_scale):
    volume = loom.TSDFVolume(voxel_size=VOXEL, truncation=TRUNCATION, device=device)
    for depth, color, T in frames:
        volume.integrate(depth, camera, np.linalg.inv(T), color, depth_scale, DEPTH_MAX)
    return volume


def frames_of(dataset, count):
    return [(frame.depth, frame.color, frame.T_world_camera) for frame in map(dataset.read, range(count))]


def flat_key(voxels):
    return (voxels + (1 << 20)) @ np.array([1 << 42, 1 << 21, 1])


def test_voxels_of_synthetic_frames_match_open3d(device, oracle, rng):
    made = [((1000 * depth).astype(np.uint16), color, T) for depth, T, color in small_frames(rng, 4)]
    for depth, _, _ in made:
        depth[-1], depth[:, -1] = 0, 0  # Open3D excludes them
    theirs = oracle("meshing/tsdf/voxels", open3d_voxels, made, SMALL, 1000.0, 40)
    assert_voxels_are(fuse(made, device, SMALL, 1000.0), theirs, 40)


@pytest.mark.parametrize(("name", "every"), [("rgbd-7scenes-redkitchen", 60), ("rgbd-cupoch-redwood5", 1)])
def test_voxels_of_real_frames_match_open3d(device, o3d, real_file, name, every):
    dataset = open_dataset(real_file(name), every=every)
    given = frames_of(dataset, 4), dataset.intrinsic, dataset.depth_scale
    assert_voxels_are(fuse(given[0], device, *given[1:]), open3d_voxels(o3d, *given))


def test_a_ray_cast_view_matches_the_depth_of_a_frame(device, real_file):
    dataset = open_dataset(real_file("rgbd-7scenes-redkitchen"), every=20)
    frames, frame = frames_of(dataset, len(dataset)), dataset.read(3)
    volume = fuse(frames, device, dataset.intrinsic, dataset.depth_scale)
    view = volume.ray_cast(dataset.intrinsic, np.linalg.inv(frame.T_world_camera), weight_threshold=0)
    truth = frame.depth / dataset.depth_scale
    both = (view.depth > 0) & (truth > 0) & (truth < DEPTH_MAX)
    assert both.sum() > 0.9 * ((truth > 0) & (truth < DEPTH_MAX)).sum()
    assert np.median(np.abs(view.depth - truth)[both]) < VOXEL
    assert np.abs(view.colors[both] - frame.color[both] / 255.0).mean() < 0.1

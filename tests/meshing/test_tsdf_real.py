"""TSDFVolume beside Open3D's VoxelBlockGrid on real scans, and against the truth of the furnished room."""

import numpy as np
import pytest
from scipy.spatial import cKDTree

import pointloom as loom
from pointloom.cameras.images import upload_depth
from pointloom.data.scenes.room import room_sequence, surface_errors
from pointloom.files.frames.datasets import open_dataset
from pointloom.kernels.images.depth import largest_depth
from pointloom.kernels.volumes.tsdf_blocks import SIDE, block_box, touched_blocks

from ..scan_cases import on_sets

VOXEL, TRUNCATION, DEPTH_MAX = 0.02, 0.08, 3.0


def open3d():
    return pytest.importorskip("open3d", exc_type=ImportError)


def tensor(values):
    return open3d().core.Tensor(np.ascontiguousarray(values))


def oracle_grid(resolution, block_count=20_000):
    o3d = open3d()
    types = (o3d.core.float32,) * 3
    return o3d.t.geometry.VoxelBlockGrid(
        ("tsdf", "weight", "color"), types, ((1), (1), (3)), VOXEL, resolution, block_count, o3d.core.Device("CPU:0")
    )


def oracle_integrate(grid, frame, intrinsic, depth_scale, *, shift=0.0, blocks=None):
    """One frame; `shift` [px] moves the principal point, as Open3D cuts off what we round."""
    depth, color = (open3d().t.geometry.Image(tensor(image)) for image in (frame.depth, frame.color))
    K = intrinsic.matrix
    K[:2, 2] += shift
    K, E = tensor(K), tensor(np.linalg.inv(frame.T_world_camera))
    multiplier = TRUNCATION / VOXEL
    if blocks is None:
        blocks = grid.compute_unique_block_coordinates(depth, K, E, depth_scale, DEPTH_MAX, multiplier)
    else:
        blocks = tensor(blocks.astype(np.int32))
    grid.integrate(blocks, depth, color, K, E, depth_scale, DEPTH_MAX, multiplier)


def frames_of(dataset, count=None):
    for i in range(len(dataset) if count is None else count):
        yield dataset.read(i)


def fuse(dataset, device, count=None):
    volume = loom.TSDFVolume(voxel_size=VOXEL, truncation=TRUNCATION, device=device)
    for frame in frames_of(dataset, count):
        E = np.linalg.inv(frame.T_world_camera)
        volume.integrate(frame.depth, dataset.intrinsic, E, frame.color, dataset.depth_scale, DEPTH_MAX)
    return volume


def block_coordinates(frame, dataset):
    """The blocks that this frame touches here, so that the oracle updates the same voxels."""
    metric, largest, *_ = upload_depth(frame.depth, dataset.depth_scale, DEPTH_MAX, None)
    T, sizes = frame.T_world_camera, (TRUNCATION, VOXEL)
    return block_box(touched_blocks(metric, largest_depth(largest), dataset.intrinsic, T, *sizes).numpy())


def voxel_rows(keys, *values):
    """Voxel coordinates [n, 3] as one sortable number, and the values in its order."""
    order = np.argsort(keys)
    return keys[order], *(v[order] for v in values)


def flat_key(voxels):
    return (voxels + (1 << 20)) @ np.array([1 << 42, 1 << 21, 1])


@pytest.mark.parametrize(("name", "every"), [("rgbd-7scenes-redkitchen", 60), ("rgbd-cupoch-redwood5", 1)])
def test_voxels_have_the_oracle_s_values_weights_and_colours(device, real_file, name, every):
    """The same blocks and, by half a pixel's shift of the oracle's camera, the same pixels."""
    dataset = open_dataset(real_file(name), every=every)
    volume, grid = fuse(dataset, device, 4), oracle_grid(SIDE)
    for frame in frames_of(dataset, 4):
        blocks = block_coordinates(frame, dataset)
        oracle_integrate(grid, frame, dataset.intrinsic, dataset.depth_scale, shift=0.5, blocks=blocks)
    places, at = grid.voxel_coordinates_and_flattened_indices()
    theirs = [grid.attribute(n).reshape((-1, c))[at].numpy() for n, c in (("tsdf", 1), ("weight", 1), ("color", 3))]
    key, tsdf, weight, color = voxel_rows(flat_key(np.rint(places.numpy() / VOXEL).astype(np.int64)), *theirs)
    used, blocks = volume.block_count * SIDE**3, volume._blocks
    corners = block_box(volume._blocks.keys.numpy()[: volume.block_count])[:, None] * SIDE
    inner = np.stack(np.meshgrid(*[np.arange(SIDE)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    ours = [v.numpy()[:used] for v in (blocks.distances, blocks.weights, blocks.colors)]
    our_key, our_tsdf, our_weight, our_color = voxel_rows(flat_key((corners + inner).reshape(-1, 3)), *ours)
    np.testing.assert_array_equal(our_key, key)
    same = our_weight == weight[:, 0]
    assert same.mean() > 0.999  # the rest lies within a rounding of another pixel, or in Open3D's last row or column
    seen = same & (our_weight > 0)
    assert seen.sum() > 100_000 and our_weight.max() == 4
    near = np.abs(our_tsdf - tsdf[:, 0])[seen] < 1e-4
    assert near.mean() > 0.999
    shades = np.abs(our_color / 257.0 - color).max(axis=1)[seen]
    assert np.quantile(shades, 0.999) < 0.5


def two_way(a, b):
    """Median distances between two meshes' vertices and the other's surface, sampled densely."""
    result = []
    for left, right in ((a, b), (b, a)):
        corners = right[0][right[1]]
        surface = np.concatenate([right[0], corners.mean(axis=1), (corners[:, 0] + corners[:, 1]) / 2])
        result.append(np.median(cKDTree(surface).query(left[0])[0]))
    return result


@pytest.mark.slow
@on_sets(
    "name every threshold",
    shipped=[("rgbd-cupoch-redwood5", 1, 1)],
    real=[("rgbd-cupoch-redwood5", 1, 1), ("rgbd-7scenes-redkitchen", 20, 3)],
)
def test_the_mesh_is_within_half_a_voxel_of_the_oracle_s(device, scan_file, name, every, threshold):
    dataset = open_dataset(scan_file(name), every=every)
    mesh, grid = fuse(dataset, device).extract_triangle_mesh(threshold), oracle_grid(16)
    for frame in frames_of(dataset):
        oracle_integrate(grid, frame, dataset.intrinsic, dataset.depth_scale)
    theirs = grid.extract_triangle_mesh(threshold)
    vertices = theirs.vertex.positions.numpy().astype(np.float64)
    triangles = theirs.triangle.indices.numpy()
    assert len(mesh.vertices) > 15_000
    assert abs(len(mesh.vertices) / len(vertices) - 1) < 0.03
    forth, back = two_way((mesh.vertices, mesh.triangles), (vertices, triangles))
    assert forth < VOXEL / 2 and back < VOXEL / 2
    # and much nearer once the oracle looks at the pixels that we do
    grid = oracle_grid(16)
    for frame in frames_of(dataset):
        oracle_integrate(grid, frame, dataset.intrinsic, dataset.depth_scale, shift=0.5)
    vertices = grid.extract_triangle_mesh(threshold).vertex.positions.numpy().astype(np.float64)
    assert np.median(cKDTree(vertices).query(mesh.vertices)[0]) < VOXEL / 1000


def test_a_cast_view_shows_the_depth_of_a_frame(device, real_file):
    dataset = open_dataset(real_file("rgbd-7scenes-redkitchen"), every=20)
    volume, frame = fuse(dataset, device), dataset.read(3)
    view = volume.ray_cast(dataset.intrinsic, np.linalg.inv(frame.T_world_camera), weight_threshold=0)
    truth = frame.depth / dataset.depth_scale
    both = (view.depth > 0) & (truth > 0) & (truth < DEPTH_MAX)
    assert both.sum() > 0.9 * ((truth > 0) & (truth < DEPTH_MAX)).sum()
    assert np.median(np.abs(view.depth - truth)[both]) < VOXEL
    assert np.abs(view.colors[both] - frame.color[both] / 255.0).mean() < 0.1


@pytest.mark.slow
@pytest.mark.parametrize(("voxel_size", "limit"), [(0.03, 0.3), (0.02, 0.3)])
def test_the_room_without_noise_is_met_within_a_third_of_a_voxel(device, voxel_size, limit):
    sequence = room_sequence(60, width=320, height=240, noise=False, device=device)
    volume = loom.TSDFVolume(voxel_size=voxel_size, device=device)
    for frame in sequence:
        volume.integrate(
            frame.depth, frame.intrinsic, np.linalg.inv(frame.T_world_camera), color=frame.color, depth_max=5.0
        )
    mesh = volume.extract_triangle_mesh(3)
    errors = surface_errors(mesh.vertices, device=device)
    assert len(errors) > 50_000
    assert np.sqrt(np.mean(errors**2)) < limit * voxel_size
    # what the room's cameras would see of it: no ray passes a wall
    frame = sequence.read(7)
    view = volume.ray_cast(frame.intrinsic, np.linalg.inv(frame.T_world_camera), depth_max=5.0, weight_threshold=0)
    seen = frame.depth < 4.9
    assert (view.depth[seen] > 0).mean() > 0.99
    assert np.median(np.abs(view.depth - frame.depth)[seen]) < 0.3 * voxel_size

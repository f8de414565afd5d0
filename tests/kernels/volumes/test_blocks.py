"""Blocks that a depth frame touches, and signs and neighbors of blocks, equal to recomputed ones."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import pointloom as loom
from pointloom.kernels.algebra.camera import Camera
from pointloom.kernels.arrays.block_keys import CELL_BIAS
from pointloom.kernels.lang import float32
from pointloom.kernels.memory import upload
from pointloom.kernels.volumes import tsdf_blocks
from pointloom.kernels.volumes.block_rows import BlockNeighbors, neighbors_of
from pointloom.kernels.volumes.block_signs import signs_of
from pointloom.kernels.volumes.tsdf_blocks import BLOCK_SIDE, block_box, touched_blocks

from ...meshing import tsdf_scenes as scenes

CAMERA = (40.0, 42.0, 15.5, 11.5)
WIDTH, HEIGHT = 32, 24
SLACK = 1e-9  # [blocks] a ray this near to a face may or may not count as touching the block behind it


def random_pose(rng, extent=3.0):
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = Rotation.random(None, rng).as_matrix(), rng.uniform(-extent, extent, 3)
    return T


def touched(depth, T, truncation, voxel_size, device, camera=CAMERA):
    """Block coordinates [m, 3], in the order that they come in."""
    depth = np.asarray(depth, np.float32)
    height, width = depth.shape
    farthest = float(depth.max())
    flat = upload(depth.reshape(-1), float32, device)
    keys = touched_blocks(flat, farthest, Camera(width, height, *camera), T, truncation, voxel_size).numpy()
    assert keys.dtype == np.int64
    assert (np.diff(keys) > 0).all(), "ascending, each once"
    return block_box(keys)


def segments(depth, T, truncation, voxel_size, camera=CAMERA):
    """Both ends of the piece of each ray around its depth, in blocks, float64 [n, 3] each."""
    v, u = np.nonzero(depth > 0)
    d = np.asarray(depth, np.float32)[v, u].astype(np.float64)
    rays = np.column_stack([(u - camera[2]) / camera[0], (v - camera[3]) / camera[1], np.ones(len(u))])
    near = np.maximum(d - truncation, 0)
    ends = [(rays * k[:, None]) @ T[:3, :3].T + T[:3, 3] for k in (near, d + truncation)]
    return [e / (BLOCK_SIDE * voxel_size) for e in ends]


def sampled_blocks(a, b, count=2000):
    """The blocks at densely sampled points of the segments; points next to a face are left out."""
    blocks = set()
    for s in np.linspace(0, 1, count):
        p = a + (b - a) * s
        clear = np.abs(p - np.round(p)).min(axis=1) > SLACK
        blocks |= set(map(tuple, np.unique(np.floor(p[clear]).astype(int), axis=0)))
    return blocks


def distance_between(a, b, blocks):
    """How much [blocks] each block would have to grow to be met by one of the segments, 0 for most."""
    result = np.full(len(blocks), np.inf)
    direction = b - a
    for grow in (0.0, SLACK, 1e-6):
        low, high = blocks[:, None] - grow, blocks[:, None] + 1 + grow
        with np.errstate(divide="ignore", invalid="ignore"):
            t0, t1 = (low - a) / direction, (high - a) / direction
        enter = np.fmax(np.fmin(t0, t1).max(axis=2), 0)
        leave = np.fmin(np.fmax(t0, t1).min(axis=2), 1)
        met = (enter <= leave).any(axis=1)
        result = np.where(met, np.minimum(result, grow), result)
    return result


@pytest.mark.slow
@pytest.mark.parametrize("truncation", [0.08, 0.02, 0.5])
def test_blocks_are_those_that_the_rays_visit(device, rng, truncation):
    """Against sampled rays in float64 (none left out) and against the slabs of each block (none too many)."""
    voxel_size = 0.02
    for _ in range(4):
        T = random_pose(rng)
        depth = rng.uniform(0.3, 3.0, (HEIGHT, WIDTH)) * (rng.random((HEIGHT, WIDTH)) < 0.15)
        a, b = segments(depth, T, truncation, voxel_size)
        blocks = touched(depth, T, truncation, voxel_size, device)
        assert sampled_blocks(a, b) <= set(map(tuple, blocks)) and (distance_between(a, b, blocks) <= SLACK).all()


@pytest.mark.parametrize("kind", ["noise", "wall"])
def test_the_dense_grid_and_the_sorted_list_give_the_same_keys(device, rng, monkeypatch, kind):
    for _ in range(3):
        T = random_pose(rng)
        depth = rng.uniform(0.3, 3.0, (HEIGHT, WIDTH)) if kind == "noise" else np.full((HEIGHT, WIDTH), 1.3)
        depth[rng.random(depth.shape) < 0.3] = 0
        monkeypatch.setattr(tsdf_blocks, "MAX_GRID", 1 << 24)
        dense = touched(depth, T, 0.08, 0.02, device)
        monkeypatch.setattr(tsdf_blocks, "MAX_GRID", 0)
        listed = touched(depth, T, 0.08, 0.02, device)
        np.testing.assert_array_equal(dense, listed)
        assert len(dense) > 50


def test_a_box_too_large_for_the_grid_is_sorted(device, rng):
    T = random_pose(rng)
    depth = np.zeros((HEIGHT, WIDTH))
    depth[3, 4], depth[20, 30] = 40.0, 0.5
    a, b = segments(depth, T, 0.04, 0.01)
    blocks = touched(depth, T, 0.04, 0.01, device)
    assert sampled_blocks(a, b) <= set(map(tuple, blocks))
    assert (distance_between(a, b, blocks) <= SLACK).all()


@pytest.mark.parametrize("pixel", [(0, 0), (0, 5), (7, 0), (23, 31), (23, 2), (9, 31), (22, 30)])
@pytest.mark.parametrize("path", [1 << 24, 0])
def test_depth_at_the_border_of_the_image_is_used(device, monkeypatch, pixel, path):
    """An image fine enough for a stride of 4; only single pixels away from the border may be passed over."""
    monkeypatch.setattr(tsdf_blocks, "MAX_GRID", path)
    camera, T = (400.0, 400.0, 15.5, 11.5), np.eye(4)
    depth = np.zeros((HEIGHT, WIDTH))
    row, column = pixel
    depth[max(row - 3, 0) : row + 1 if row else 4, max(column - 3, 0) : column + 1 if column else 4] = 1.0
    assert len(touched(depth, T, 0.08, 0.02, device, camera)) > 0
    if row in (0, 23) and column in (0, 31):
        depth[:] = 0
        depth[pixel] = 1.0
        assert len(touched(depth, T, 0.08, 0.02, device, camera)) > 0


@pytest.mark.parametrize("distance", [0.4, 1.0, 2.7])
@pytest.mark.parametrize("focal", [75.0, 200.0, 525.0])
def test_neighboring_rays_are_less_than_half_a_block_apart(device, distance, focal):
    """A wall that fills the image: each block that it crosses by at least half its width is touched."""
    voxel_size, width, height = 0.01, 160, 120
    camera = (focal, focal, 79.5, 59.5)
    blocks = touched(np.full((height, width), distance), np.eye(4), 0.04, voxel_size, device, camera)
    block = BLOCK_SIDE * voxel_size
    assert distance / focal < block / 2, "the claim is about cameras whose pixels are finer than half a block"
    half_width, half_height = 79.5 * distance / focal, 59.5 * distance / focal
    columns = np.arange(np.ceil(-half_width / block - 0.5), np.floor(half_width / block - 0.5) + 1).astype(int)
    rows = np.arange(np.ceil(-half_height / block - 0.5), np.floor(half_height / block - 0.5) + 1).astype(int)
    wall = int(np.floor(distance / block))
    expected = {(x, y, wall) for x in columns for y in rows}
    assert expected <= set(map(tuple, blocks))


def test_a_frame_without_depth_touches_nothing(device, monkeypatch):
    for path in (1 << 24, 0):
        monkeypatch.setattr(tsdf_blocks, "MAX_GRID", path)
        assert len(touched(np.zeros((HEIGHT, WIDTH)), np.eye(4), 0.08, 0.02, device)) == 0


@pytest.mark.parametrize("shape", [(1, 1), (1, 7), (9, 1)])
def test_images_of_one_row_or_column_work(device, shape):
    depth = np.full(shape, 0.9)
    a, b = segments(depth, np.eye(4), 0.08, 0.02)
    blocks = touched(depth, np.eye(4), 0.08, 0.02, device)
    assert sampled_blocks(a, b) == set(map(tuple, blocks))


def test_rays_begin_at_the_camera_if_the_truncation_extends_behind_it(device):
    blocks = touched(np.full((HEIGHT, WIDTH), 0.05), np.eye(4), 0.5, 0.02, device)
    assert blocks[:, 2].min() == 0


def test_a_frame_beyond_the_limit_is_refused_with_figures(device):
    depth, voxel_size = np.full((HEIGHT, WIDTH), 1.0), 0.001
    limit = CELL_BIAS * BLOCK_SIDE * voxel_size
    for axis in range(3):
        for sign in (-1, 1):
            T = np.eye(4)
            T[axis, 3] = sign * limit
            with pytest.raises(ValueError, match="extrinsic:"):
                touched(depth, T, 0.01, voxel_size, device)
            T[axis, 3] = sign * (limit - 2)
            assert np.abs(touched(depth, T, 0.01, voxel_size, device)).max() > CELL_BIAS * 0.999


def volumes_of_frames(device, rng, count=5):
    volume = loom.TSDFVolume(voxel_size=scenes.VOXEL, truncation=scenes.TRUNCATION, color=False, device=device)
    for depth, T, _ in scenes.small_frames(rng, count):
        volume.integrate(depth, scenes.SMALL, np.linalg.inv(T))
        yield volume


def dense(volume, values, fill):
    """Values of voxels in an array over the box of the blocks, one voxel more on the high sides."""
    count = volume.block_count
    blocks = block_box(volume.blocks.keys.numpy()[:count])
    low = blocks.min(0)
    grid = np.full((blocks.max(0) - low + 1) * BLOCK_SIDE + 1, fill)
    for block, cube in zip(
        (blocks - low) * BLOCK_SIDE,
        values[: count * BLOCK_SIDE**3].reshape(-1, BLOCK_SIDE, BLOCK_SIDE, BLOCK_SIDE),
        strict=True,
    ):
        x, y, z = block
        grid[x : x + BLOCK_SIDE, y : y + BLOCK_SIDE, z : z + BLOCK_SIDE] = cube
    return grid, (blocks - low) * BLOCK_SIDE


def cells_behind(volume):
    """By block, the cells with a corner that was seen and is not in front of a surface: bool [blocks, 8, 8, 8]."""
    voxels = volume.blocks
    behind = (voxels.distances.numpy() <= 0) & (voxels.weights.numpy() > 0)
    grid, corners = dense(volume, behind, False)
    sides = [slice(None, -1), slice(1, None)]
    cells = np.any([grid[a, b, c] for a in sides for b in sides for c in sides], axis=0)
    return np.stack([cells[x : x + BLOCK_SIDE, y : y + BLOCK_SIDE, z : z + BLOCK_SIDE] for x, y, z in corners])


def bits_of(words, count):
    words = words.numpy()[: count * BLOCK_SIDE].view(np.uint64).reshape(-1, BLOCK_SIDE, 1)
    return (
        ((words >> np.arange(64, dtype=np.uint64)) & np.uint64(1))
        .astype(bool)
        .reshape(-1, BLOCK_SIDE, BLOCK_SIDE, BLOCK_SIDE)
    )


def test_cells_are_those_with_a_corner_behind_a_surface(device, rng):
    for k, volume in enumerate(volumes_of_frames(device, rng)):
        if k in (1, 2):
            continue  # signs of several frames are updated at once
        signs, count = signs_of(volume.blocks), volume.block_count
        expected = cells_behind(volume)
        np.testing.assert_array_equal(bits_of(signs.cells, count), expected)
        parts = expected.reshape(-1, 2, 4, 2, 4, 2, 4).any(axis=(2, 4, 6)).reshape(-1, 8) @ (1 << np.arange(8))
        np.testing.assert_array_equal(signs.parts.numpy()[:count], parts)
        assert 0 < (parts > 0).mean() < 1


def test_updated_neighbors_equal_recomputed_ones(device, rng):
    counts = []
    for volume in volumes_of_frames(device, rng):
        blocks = volume.blocks
        rebuilt = BlockNeighbors(blocks.changes, blocks.device).update(blocks)
        used = 27 * blocks.count
        np.testing.assert_array_equal(neighbors_of(blocks).numpy()[:used], rebuilt.numpy()[:used])
        counts.append(blocks.count)
    assert len(set(counts)) > 2, "the volume grew"


def test_signs_follow_voxels_that_are_put_in_by_other_means(device, rng):
    *_, volume = volumes_of_frames(device, rng, 2)
    signs_of(volume.blocks)
    negated = -volume.blocks.distances.numpy()
    scenes.set_voxels(volume, "distances", negated)
    signs = signs_of(volume.blocks)
    np.testing.assert_array_equal(bits_of(signs.cells, volume.block_count), cells_behind(volume))


def test_signs_of_an_empty_volume_are_none(device):
    volume = loom.TSDFVolume(voxel_size=scenes.VOXEL, device=device)
    signs_of(volume.blocks)
    assert not scenes.view_from(volume, np.eye(4)).depth.any()


@pytest.mark.parametrize("other", ["copied", "loaded"])
def test_an_image_does_not_depend_on_earlier_rays(device, tmp_path, other):
    watched = loom.TSDFVolume(voxel_size=scenes.VOXEL, truncation=scenes.TRUNCATION, color=False, device=device)
    T = scenes.look_at((1.0, 0.5, 0.4))
    for k, (depth, pose) in enumerate(scenes.sphere_frames()):
        watched.integrate(depth, scenes.CAMERA, np.linalg.inv(pose))
        if k % 4 != 2:
            scenes.view_from(watched, T)
    if other == "copied":
        fresh = watched.copy()
    else:
        watched.save(tmp_path / "volume.npz")
        fresh = loom.TSDFVolume.load(tmp_path / "volume.npz", device=device)
    a, b = scenes.view_from(watched, T), scenes.view_from(fresh, T)
    assert (a.depth > 0).sum() > 3000
    np.testing.assert_array_equal(a.depth, b.depth)
    np.testing.assert_array_equal(a.normals, b.normals)

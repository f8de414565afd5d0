"""What is kept beside a volume's blocks, and taken further frame by frame, is what would be found anew."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.kernels.volumes.block_rows import BlockNeighbors, neighbors_of
from pointloom.kernels.volumes.block_signs import BlockSigns, signs_of
from pointloom.kernels.volumes.tsdf_blocks import SIDE, block_box

from ...meshing import tsdf_scenes as scenes


def volumes_of_frames(device, rng, count=5):
    volume = loom.TSDFVolume(voxel_size=scenes.VOXEL, truncation=scenes.TRUNCATION, color=False, device=device)
    for depth, T, _ in scenes.small_frames(rng, count):
        volume.integrate(depth, scenes.SMALL, np.linalg.inv(T))
        yield volume


def dense(volume, values, fill):
    """Values of voxels in an array over the box of the blocks, one voxel more on the high sides."""
    count = volume.block_count
    blocks = block_box(volume._blocks.keys.numpy()[:count])
    low = blocks.min(0)
    grid = np.full((blocks.max(0) - low + 1) * SIDE + 1, fill)
    for block, cube in zip((blocks - low) * SIDE, values[: count * SIDE**3].reshape(-1, SIDE, SIDE, SIDE), strict=True):
        x, y, z = block
        grid[x : x + SIDE, y : y + SIDE, z : z + SIDE] = cube
    return grid, (blocks - low) * SIDE


def cells_behind(volume):
    """By block, the cells with a corner that was seen and is not in front of a surface: bool [blocks, 8, 8, 8]."""
    voxels = volume._blocks
    behind = (voxels.distances.numpy() <= 0) & (voxels.weights.numpy() > 0)
    grid, corners = dense(volume, behind, False)
    sides = [slice(None, -1), slice(1, None)]
    cells = np.any([grid[a, b, c] for a in sides for b in sides for c in sides], axis=0)
    return np.stack([cells[x : x + SIDE, y : y + SIDE, z : z + SIDE] for x, y, z in corners])


def bits_of(words, count):
    words = words.numpy()[: count * SIDE].view(np.uint64).reshape(-1, SIDE, 1)
    return ((words >> np.arange(64, dtype=np.uint64)) & np.uint64(1)).astype(bool).reshape(-1, SIDE, SIDE, SIDE)


def test_cells_are_those_with_a_corner_behind_a_surface(device, rng):
    for volume in volumes_of_frames(device, rng):
        signs, count = signs_of(volume._blocks), volume.block_count
        expected = cells_behind(volume)
        np.testing.assert_array_equal(bits_of(signs.cells, count), expected)
        parts = expected.reshape(-1, 2, 4, 2, 4, 2, 4).any(axis=(2, 4, 6)).reshape(-1, 8) @ (1 << np.arange(8))
        np.testing.assert_array_equal(signs.parts.numpy()[:count], parts)
        assert 0 < (parts > 0).mean() < 1


def test_updated_neighbors_equal_recomputed_ones(device, rng):
    counts = []
    for volume in volumes_of_frames(device, rng):
        blocks = volume._blocks
        rebuilt = BlockNeighbors(blocks.changes, blocks.device).update(blocks)
        used = 27 * blocks.count
        np.testing.assert_array_equal(neighbors_of(blocks).numpy()[:used], rebuilt.numpy()[:used])
        counts.append(blocks.count)
    assert len(set(counts)) > 2, "the volume grew"


def test_signs_follow_voxels_that_are_put_in_by_other_means(device, rng):
    *_, volume = volumes_of_frames(device, rng, 2)
    signs_of(volume._blocks)
    negated = -volume._blocks.distances.numpy()
    scenes.set_voxels(volume, "distances", negated)
    signs = signs_of(volume._blocks)
    np.testing.assert_array_equal(bits_of(signs.cells, volume.block_count), cells_behind(volume))


def test_signs_after_several_frames_equal_recomputed_ones(device, rng):
    for k, volume in enumerate(volumes_of_frames(device, rng)):
        if k in (0, 3, 4):
            blocks = volume._blocks
            updated = signs_of(blocks)
            rebuilt = BlockSigns(blocks.changes, blocks.device)
            rebuilt.update(blocks)
            for name, each in (("signs", SIDE), ("cells", SIDE), ("parts", 1)):
                a, b = (getattr(s, name).numpy()[: blocks.count * each] for s in (updated, rebuilt))
                np.testing.assert_array_equal(a, b)


def test_signs_of_an_empty_volume_are_none(device):
    volume = loom.TSDFVolume(voxel_size=scenes.VOXEL, device=device)
    signs_of(volume._blocks)
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

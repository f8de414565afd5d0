"""Surfaces from LiDAR scans: a float64 reference, carving of removed objects, atomic integration."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.kernels.memory import download
from pointloom.kernels.volumes.tsdf_blocks import BLOCK_SIDE, block_box
from pointloom.meshing.volume.shift_scores import score_shifts

from .tsdf_scenes import assert_complete_or_absent, fingerprint

VOXEL, TRUNCATION = 0.1, 0.3
UTM = np.array([500_000.0, 5_400_000.0, 100.0])
FILES = (
    "meshing/volume/tsdf_scans.py", "meshing/volume/tsdf.py", "kernels/volumes/voxel_blocks.py",
    "kernels/volumes/scan_fusion.py", "kernels/volumes/scan_rays.py", "kernels/arrays/atomic_changes.py",
)  # fmt: skip


def volume_on(device="cpu", color=False):
    return loom.TSDFVolume(voxel_size=VOXEL, truncation=TRUNCATION, color=color, device=device)


def wall(x, count=25, seed=0):
    rng = np.random.default_rng(seed)
    side = np.linspace(-1.0137, 0.9871, count)  # no point on a cell boundary, where rounding decides
    y, z = np.repeat(side, count), np.tile(side, count)
    return np.stack([x + rng.normal(0, 0.01, y.size), y, z], axis=1)


def voxels_of(volume):
    """(value, weight) of each observed voxel, by its integer coordinates."""
    keys = download(volume.blocks.keys)[: volume.block_count]
    weights = download(volume.blocks.weights)[: 512 * len(keys)]
    values = download(volume.blocks.distances)[: 512 * len(keys)]
    seen = np.flatnonzero(weights)
    inner = np.stack(np.unravel_index(seen % 512, (8, 8, 8)), axis=1)
    coordinates = block_box(keys)[seen // 512] * BLOCK_SIDE + inner
    return {tuple(p): (v, w) for p, v, w in zip(coordinates.tolist(), values[seen], weights[seen], strict=True)}


def cells_between(a, b):
    """The cells crossed by the segment from a to b, from its sorted crossings of cell faces."""
    along, cuts = b - a, [0.0, 1.0]
    for k in range(3):
        low, high = sorted((a[k], b[k]))
        cuts += [(wall - a[k]) / along[k] for wall in range(int(np.ceil(low)), int(np.floor(high)) + 1) if along[k]]
    cuts = np.sort(cuts)
    middles = a + np.outer((cuts[1:] + cuts[:-1])[np.diff(cuts) > 1e-12] / 2, along)
    return dict.fromkeys(map(tuple, np.floor(middles).astype(int).tolist()))


def reference(scans, carve):
    """The voxels and blocks of scans, each (points, scanner), in float64."""
    voxels, blocks = {}, set()
    for points, scanner in scans:
        rays = []
        for p in points:
            distance = np.linalg.norm(p - scanner)
            d = (p - scanner) / distance
            a, b = ((scanner + d * r) / VOXEL + 0.5 for r in (distance - TRUNCATION, distance + TRUNCATION))
            ends = cells_between(a, b)
            blocks |= {tuple(c // BLOCK_SIDE for c in cell) for cell in ends}
            rays.append((distance, d, ends | (cells_between(scanner / VOXEL + 0.5, a) if carve else {})))
        samples = {}
        for distance, d, cells in rays:
            for cell in cells:
                value = (distance - (np.array(cell) * VOXEL - scanner) @ d) / TRUNCATION
                if value > -1 and tuple(c // BLOCK_SIDE for c in cell) in blocks:
                    samples.setdefault(cell, []).append(min(value, 1.0))
        for cell, values in samples.items():
            old, w = voxels.get(cell, (0.0, 0))
            voxels[cell] = ((old * w + np.mean(values)) / (w + 1), w + 1)
    return voxels, blocks


@pytest.mark.parametrize("carve", [True, False])
def test_voxels_match_a_float64_reference(device, carve):
    scans = [(wall(2.03, 9), np.array([0.02, 0.013, 0.017])), (wall(2.01, 9, 1), np.array([0.31, -0.22, 0.07]))]
    across = np.array([1, 0.23, 0.19])
    scans.append((wall(2.05, 7, 2) * across, np.array([0.113, 0.041, -0.017])))  # rays begin to count where others pass
    volume = volume_on(device)
    for points, scanner in scans:
        volume.integrate_points(points, scanner, carve=carve)
    expected, blocks = reference(scans, carve)
    result = voxels_of(volume)
    assert volume.block_count == len(blocks) and result.keys() == expected.keys()
    worst = max(abs(result[cell][0] - value) for cell, (value, _) in expected.items())
    assert worst < 1e-6 and all(result[cell][1] == w for cell, (_, w) in expected.items())


def test_point_order_and_form_of_scanner_positions_change_no_bit(device):
    points, origin = wall(3.0), np.array([0.1, 0.2, 0.3])
    cloud = loom.PointCloud(points, colors=np.abs(points) / 4, device=device)
    order = np.random.default_rng(1).permutation(len(points))
    mixed = loom.PointCloud(points[order], colors=np.abs(points[order]) / 4, device=device)
    prints = set()
    for scan, start in ((cloud, origin), (mixed, origin), (cloud, np.tile(origin, (len(points), 1)))):
        volume = volume_on(device, color=True)
        volume.integrate_points(scan, start)
        prints.add(fingerprint(volume))
    assert len(prints) == 1
    mesh = volume.extract_triangle_mesh(0)
    assert np.abs(mesh.vertex_colors - np.abs(mesh.vertices) / 4).max() < 0.05


def test_moved_objects_are_carved_and_empty_space_gets_no_blocks(device):
    uncarved, carved = volume_on(device), volume_on(device)
    for volume, carve in ((uncarved, False), (carved, True)):
        volume.integrate_points(wall(2.0), [0, 0, 0], carve=carve)
        for seed in range(3):
            volume.integrate_points(wall(4.0, 51, seed) * [1, 2, 2], [0, 0, 0], carve=carve)
    assert carved.block_count == uncarved.block_count
    assert (uncarved.extract_triangle_mesh(0).vertices[:, 0] < 3).any()
    assert not (carved.extract_triangle_mesh(0).vertices[:, 0] < 3).any()


def test_a_scan_at_utm_coordinates_is_equally_exact(device):
    here, there = volume_on(device), volume_on(device)
    scanner = np.array([0.02, 0.013, 0.027])  # off the diagonals, where a ray would cross two cell boundaries at once
    here.integrate_points(wall(2.0), scanner)
    there.integrate_points(wall(2.0) + UTM, scanner + UTM)
    near, far = here.extract_triangle_mesh(0), there.extract_triangle_mesh(0)
    assert np.array_equal(near.triangles, far.triangles)
    assert np.abs(near.vertices - (far.vertices - UTM)).max() < 1e-6
    assert np.abs(near.vertices[:, 0] - 2).max() < 0.05


@pytest.mark.parametrize("carve", [True, False])
def test_outlier_points_create_no_blocks(device, carve):
    points, options = wall(2.0), {"min_range": 0.5, "max_range": 50.0, "carve": carve}
    wild = np.array([[1e7, 3e6, 1e5], [1e30, 3e29, 1e29], [65.0, 21, 9], [np.nan, 0, 0], [0, 0, 0], [0.2, 0, 0]])
    volumes = volume_on(device), volume_on(device)
    for volume, scan in zip(volumes, (points, np.vstack([points, wild])), strict=True):
        volume.integrate_points(scan, np.zeros(3), **options)
    keys = [volume.downloaded()["keys"].tobytes() for volume in volumes]
    assert keys[0] == keys[1] and volumes[0].memory_bytes == volumes[1].memory_bytes
    assert carve or fingerprint(volumes[0]) == fingerprint(volumes[1])


def test_scans_with_invalid_poses_are_rejected_and_leave_the_volume(device):
    volume, points = volume_on(device), wall(2.0)
    volume.integrate_points(points, np.zeros(3))
    before = fingerprint(volume)
    for wrong, origin, words in (
        (points, None, "origin: expected the scanner position"),
        (points, np.zeros((3, 3)), r"origin: expected shape \[3\], or \[625, 3\]"),
        (np.vstack([points, [np.inf, 0, 0]]), np.zeros(3), "point 625 is infinite"),
        (np.vstack([points, [2e6, 0, 0]]), np.zeros(3), "point 625 or its scanner is beyond"),
    ):
        with pytest.raises(ValueError, match=words):
            volume.integrate_points(wrong, origin)
    with pytest.raises(ValueError, match="max_range:"):
        volume.integrate_points(points, np.zeros(3), min_range=2.0, max_range=1.0)
    assert (volume.frame_count, fingerprint(volume)) == (1, before)
    assert volume.integrate_points(np.zeros((0, 3)), np.zeros(3)) == 0


@pytest.mark.slow
def test_a_scan_is_integrated_completely_or_not_at_all_after_any_interruption(device):
    def begun():
        volume = volume_on(device)
        volume.integrate_points(wall(2.0), np.zeros(3))
        return volume

    def add(volume):
        volume.integrate_points(wall(3.0, seed=2), np.zeros(3))

    assert_complete_or_absent(begun, add, FILES)


SMALL_VOXEL, SMALL_TRUNCATION = 0.05, 0.2
CAMERA = loom.PinholeCameraIntrinsic(40, 30, 35.0, 35.0, 19.5, 14.5)


def seen_wall(device):
    """A volume of a seen_wall 1 m in front of the camera, seen once, and points on the seen_wall."""
    volume = loom.TSDFVolume(voxel_size=SMALL_VOXEL, truncation=SMALL_TRUNCATION, color=False, device=device)
    volume.integrate(np.ones((30, 40), np.float32), CAMERA, np.eye(4), depth_scale=1.0)
    x, y = np.random.default_rng(0).uniform(-0.25, 0.25, (2, 60))
    return volume, np.column_stack([x, y, np.ones(60)])


def test_a_score_is_the_closeness_of_the_observed_points(device):
    volume, points = seen_wall(device)
    offsets = np.array([0.0, 0.05, 0.1, -0.1, -0.15, 0.6])
    shifts = np.vstack([np.outer(offsets, [0, 0, 1]), [[30, 0, 0]]])
    scores = score_shifts(volume, points, shifts, weight_threshold=0.0, min_score=0.0)
    expected = np.append(np.maximum(1 - np.abs(offsets) / SMALL_TRUNCATION, 0), 0)
    np.testing.assert_allclose(scores, expected, rtol=0, atol=1e-3)
    assert (score_shifts(volume, points, shifts, weight_threshold=1.0, min_score=0.0) == 0).all()
    coarse = score_shifts(volume, points, shifts, weight_threshold=1.0, min_score=0.0, is_coarse=True)
    assert coarse[0] == 1 and coarse[-1] == 0


def test_a_shift_with_low_initial_scores_is_abandoned(device):
    volume, points = seen_wall(device)
    points[:24, 2] = 0.85
    scores = [score_shifts(volume, points, np.zeros((1, 3)), weight_threshold=0.0, min_score=x)[0] for x in (0.0, 0.5)]
    np.testing.assert_allclose(scores, [(24 * 0.25 + 36) / 60, 0.25], rtol=0, atol=1e-3)

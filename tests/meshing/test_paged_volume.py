"""A volume with blocks on disk is bitwise identical to one in memory, and saved data survives the process."""

import copy
import itertools
import os
import pickle
import shutil

import numpy as np
import pytest

import pointloom as loom
from pointloom.kernels.memory import download
from pointloom.meshing.volume import page_files

CAMERA = loom.PinholeCameraIntrinsic(40, 30, 40.0, 40.0, 19.5, 14.5)
SIZES = {"voxel_size": 0.025, "truncation": 0.075}


def frame(k):
    """Depth [m], colors and T_camera_world of a camera that moves along a wall and returns."""
    random = np.random.default_rng(k)
    x = 0.8 * (k if k < 6 else 11 - k)
    pose = np.eye(4)
    pose[:3, 3] = -x, 0.02 * k, 0.0
    depth = (1.0 + 0.2 * np.sin(np.arange(40) / 5 + x) + random.normal(0, 0.004, (30, 40))).astype(np.float32)
    return depth, random.integers(0, 255, (30, 40, 3)).astype(np.uint8), pose


def integrate_frames(volume, frames=range(12), color=True):
    for k in frames:
        depth, shades, pose = frame(k)
        volume.integrate(depth, CAMERA, pose, color=shades if color else None)
    return volume


def paged(folder, device, max_blocks=190, **more):
    return loom.PagedTSDFVolume(folder, **SIZES, max_blocks=max_blocks, page_blocks=3, device=device, **more)


def bits_of(volume):
    return {name: np.array(values) for name, values in volume.downloaded().items()}


def assert_same_bits(one, other):
    one, other = bits_of(one), bits_of(other)
    assert one.keys() == other.keys()
    for name, values in one.items():
        np.testing.assert_array_equal(values, other[name], err_msg=name)


@pytest.mark.parametrize("color", [True, pytest.param(False, marks=pytest.mark.slow)])
def test_a_paged_volume_is_bitwise_identical_to_one_in_memory(device, tmp_path, color):
    reference = integrate_frames(loom.TSDFVolume(**SIZES, color=color, device=device), color=color)
    with integrate_frames(paged(tmp_path / "v", device, color=color), color=color) as volume:
        assert volume.block_count == reference.block_count > 2 * volume.max_blocks
        assert volume.resident_block_count <= volume.max_blocks and volume.frame_count == 12
        assert len([*(tmp_path / "v").iterdir()]) > 3
        assert_same_bits(volume.to_volume(), reference)
        for name in ("extract_triangle_mesh", "extract_point_cloud"):
            actual, theirs = (getattr(each, name)(1) for each in (volume, reference))
            assert actual.arrays.keys() == theirs.arrays.keys()
            for name in theirs.arrays:
                one, other = download(actual.arrays[name]), download(theirs.arrays[name])
                np.testing.assert_array_equal(one, other, err_msg=name)
        mesh = reference.extract_triangle_mesh(1)
        assert len(mesh) > 1000
        parts = [*volume.extract_parts(1)]
        assert len(parts) > 3 and sum(map(len, parts)) == len(mesh)
        corners = np.sort(np.concatenate([part.vertices[part.triangles].reshape(-1, 9) for part in parts]), axis=0)
        np.testing.assert_array_equal(corners, np.sort(mesh.vertices[mesh.triangles].reshape(-1, 9), axis=0))


@pytest.mark.parametrize("color", [True, False])
def test_frames_in_groups_give_the_volume_of_single_calls(device, tmp_path, color):
    depths, colors, poses = map(np.stack, zip(*map(frame, range(12)), strict=True))
    reference, counts = loom.TSDFVolume(**SIZES, color=color, device=device), []
    expected = [reference.integrate(depths[k], CAMERA, poses[k], colors[k] if color else None) for k in range(12)]
    with paged(tmp_path / "v", device, color=color) as volume:
        for rows in (slice(0, 5), slice(5, 6), slice(6, 12)):
            counts += volume.integrate_frames(depths[rows], CAMERA, poses[rows], colors[rows] if color else None)
        assert counts == expected and volume.frame_count == 12 and volume.block_count > 2 * volume.max_blocks
        assert_same_bits(volume.to_volume(), reference)


def test_frames_before_one_that_exceeds_the_capacity_stay(device, tmp_path):
    depths, colors, poses = map(np.stack, zip(*map(frame, range(3)), strict=True))
    cameras = [CAMERA, CAMERA, loom.PinholeCameraIntrinsic(40, 30, 4.0, 4.0, 19.5, 14.5)]  # the last sees too much
    with paged(tmp_path / "v", device) as volume:
        with pytest.raises(ValueError, match=r"the frame needs .* blocks at once, .* 190; increase max_blocks"):
            volume.integrate_frames(depths, cameras, poses, colors)
        assert volume.frame_count == 2
        assert_same_bits(volume.to_volume(), integrate_frames(loom.TSDFVolume(**SIZES, device=device), range(2)))


@pytest.mark.slow
def test_scan_rays_carve_voxels_on_disk(device, tmp_path):
    side = np.linspace(-0.6, 0.6, 31)
    wall = np.stack([np.repeat(side, 31), np.tile(side, 31)], axis=1)
    reference = loom.TSDFVolume(**SIZES, color=False, device=device)
    with paged(tmp_path / "v", device, 200, color=False) as volume:
        for far in (1.0, 1.8):  # a wall on each of four sides, then one behind each
            for quarter in range(4):
                rotation = np.linalg.matrix_power([[0, -1, 0], [1, 0, 0], [0, 0, 1]], quarter)
                points = np.column_stack([np.full(961, far), wall]) @ rotation.T
                position = rotation @ [0.3, 0.0, 0.0]
                count = volume.integrate_points(points, position)
                assert count == reference.integrate_points(points, position)
        assert volume.block_count > 1.5 * volume.max_blocks
        assert_same_bits(volume.to_volume(), reference)
        weights = bits_of(reference)["weights"]
        assert (weights == 2).sum() > 1000  # voxels of the near walls that the second round passed
        with pytest.raises(ValueError, match=r"the space that rays cross needs .* increase max_blocks, set max_range"):
            around = np.concatenate([points, -points, points @ rotation, -points @ rotation])
            volume.integrate_points(around, [0.0, 0.0, 0.0])
        assert_same_bits(volume.to_volume(), reference)


def test_a_view_loads_the_blocks_in_front_of_the_camera(device, tmp_path):
    reference = integrate_frames(loom.TSDFVolume(**SIZES, device=device))
    with integrate_frames(paged(tmp_path / "v", device, 250)) as volume:
        for k in (0, 5):
            view = {"depth_max": 1.3, "weight_threshold": 0}
            result = volume.ray_cast(CAMERA, frame(k)[2], **view)
            theirs = reference.ray_cast(CAMERA, frame(k)[2], **view)
            assert (theirs.depth > 0).sum() > 500
            np.testing.assert_array_equal(result.depth, theirs.depth)
            np.testing.assert_array_equal(result.normals, theirs.normals)
        with pytest.raises(ValueError, match=r"the view needs .* 250; increase max_blocks or reduce"):
            volume.ray_cast(CAMERA, frame(3)[2], depth_max=40.0)
        assert_same_bits(volume.to_volume(), reference)


def test_work_continues_from_the_last_save(device, tmp_path):
    reference = integrate_frames(loom.TSDFVolume(**SIZES, device=device))
    with integrate_frames(paged(tmp_path / "v", device), range(7)) as volume:
        volume.save()
        integrate_frames(volume, range(7, 12))  # not saved
    with loom.PagedTSDFVolume.load(tmp_path / "v", max_blocks=190, device=device) as volume:
        assert volume.frame_count == 7 and volume.resident_block_count == 0
        assert_same_bits(integrate_frames(volume, range(7, 12)).to_volume(), reference)
        volume.save()
        listed = len([*(tmp_path / "v").glob("0*.npz")])
    with loom.PagedTSDFVolume.load(tmp_path / "v", device=device) as volume:
        assert listed == len(volume._volume.cubes)  # leftovers of the first run are removed
        assert_same_bits(volume.to_volume(), reference)
        meshes = [one.extract_triangle_mesh(1) for one in (volume, reference)]
        np.testing.assert_array_equal(meshes[0].vertices, meshes[1].vertices)


def test_a_frame_that_exceeds_the_capacity_is_rejected(device, tmp_path):
    with paged(tmp_path / "v", device, 40) as volume:
        with pytest.raises(ValueError, match=r"the frame needs .* blocks at once, .* 40; increase max_blocks"):
            integrate_frames(volume, [0])
        assert volume.block_count == 0 and volume.frame_count == 0


def test_a_failed_page_write_leaves_the_volume_unchanged(device, tmp_path, monkeypatch):
    with integrate_frames(paged(tmp_path / "v", device), range(3)) as volume:
        before = bits_of(volume.to_volume())

        def refuse(*_, **__):
            raise loom.FileError("page", "cannot be written: no space left")

        with monkeypatch.context() as patch:
            patch.setattr(volume._volume.folder, "write", refuse)
            with pytest.raises(loom.FileError, match="no space"):
                integrate_frames(volume, range(3, 12))
        done = volume.frame_count
        assert 3 <= done < 12 and before["keys"].size
        reference = integrate_frames(loom.TSDFVolume(**SIZES, device=device))
        assert_same_bits(integrate_frames(volume, range(done, 12)).to_volume(), reference)


def test_errors_name_damaged_pages_and_lists(device, tmp_path):
    with integrate_frames(paged(tmp_path / "v", device)) as volume:
        volume.save()
    page = sorted((tmp_path / "v").glob("0*.npz"))[0]
    data = page.read_bytes()
    middle = len(data) // 2
    page.write_bytes(data[:middle] + bytes([data[middle] ^ 1]) + data[middle + 1 :])
    with loom.PagedTSDFVolume.load(tmp_path / "v", device=device) as volume:
        with pytest.raises(loom.FileError, match=page.name):
            volume.to_volume()
        page.unlink()
        with pytest.raises(loom.FileError, match=r"/00000023\.npz:"):
            volume.extract_triangle_mesh()
    other = sorted((tmp_path / "v").glob("0*.npz"))[0]
    page.write_bytes(other.read_bytes())
    volume = loom.PagedTSDFVolume.load(tmp_path / "v", device=device)
    with volume, pytest.raises(loom.FileError, match=r"/00000023\.npz:.*volume\.npz"):
        volume.to_volume()
    listing = tmp_path / "v" / "volume.npz"
    listing.write_bytes(listing.read_bytes()[:-30])
    with pytest.raises(loom.FileError, match=r"volume\.npz"):
        loom.PagedTSDFVolume.load(tmp_path / "v")


def test_an_error_names_a_page_without_colors(device, tmp_path):
    with integrate_frames(paged(tmp_path / "v", device)) as volume:
        volume.save()
    page = sorted((tmp_path / "v").glob("0*.npz"))[1]
    with np.load(page) as file:
        np.savez(page, **{name: file[name] for name in file.files if name != "colors"})
    volume = loom.PagedTSDFVolume.load(tmp_path / "v", device=device)
    for call in (volume.to_volume, volume.extract_triangle_mesh):
        with pytest.raises(loom.FileError, match=rf"{page.name}:"):
            call()
    volume.close()


def test_folders_are_preserved(device, tmp_path):
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "note.txt").write_text("mine")
    with pytest.raises(loom.FileError, match="/mine:"):
        paged(tmp_path / "mine", device, overwrite=True)
    with pytest.raises(loom.FileError, match=r"/v: the folder .*/no does not exist"):
        paged(tmp_path / "no" / "v", device)
    with pytest.raises(loom.FileError, match="/mine:"):
        loom.PagedTSDFVolume.load(tmp_path / "mine")
    with integrate_frames(paged(tmp_path / "v", device), range(3)) as volume:
        volume.save()
        with pytest.raises(loom.FileError, match="/v:"):
            loom.PagedTSDFVolume.load(tmp_path / "v")
    with pytest.raises(loom.FileError, match="/v:"):
        paged(tmp_path / "v", device)
    assert [path.name for path in (tmp_path / "mine").iterdir()] == ["note.txt"]
    with paged(tmp_path / "v", device, overwrite=True) as volume:
        assert volume.block_count == 0 and len([*(tmp_path / "v").iterdir()]) == 1
        for make in (copy.copy, copy.deepcopy, pickle.dumps):
            with pytest.raises(TypeError, match=r"^PagedTSDFVolume:"):
                make(volume)


@pytest.mark.slow
@pytest.mark.parametrize("at", [3, 17, 40, 64])
def test_a_killed_process_leaves_its_last_save(tmp_path, monkeypatch, at):
    """The files at some change of a file: `load` finds the frames of the last `save`, and the rest can be repeated."""
    changes, saved, volume = itertools.count(1), [0], paged(tmp_path / "v", "cpu")

    def counting(function):
        def call(*arguments, **more):
            if next(changes) == at:
                shutil.copytree(tmp_path / "v", tmp_path / "killed")
                saved.append(saved[0])
            return function(*arguments, **more)

        return call

    with monkeypatch.context() as patch:
        for owner, name in ((os, "replace"), (os, "link"), (page_files.Path, "unlink")):
            patch.setattr(owner, name, counting(getattr(owner, name)))
        for k in range(12):
            integrate_frames(volume, [k])
            if k % 2:
                volume.save()
                saved[0] = k + 1
    volume.close()
    with loom.PagedTSDFVolume.load(tmp_path / "killed", max_blocks=190) as volume:
        assert volume.frame_count in (saved[1], saved[1] + 2)
        assert_same_bits(volume.to_volume(), integrate_frames(loom.TSDFVolume(**SIZES), range(volume.frame_count)))
        integrate_frames(volume, range(volume.frame_count, 12))
        assert_same_bits(volume.to_volume(), integrate_frames(loom.TSDFVolume(**SIZES)))
        volume.save()
        left = {file.name for file in (tmp_path / "killed").iterdir()}
        assert len(left) == 1 + len(volume._volume.cubes)  # no leftovers of the killed process

"""Volumes on disk: bitwise round trip, atomic writes, and a named error for every damaged file."""

import io
import tracemalloc
import zipfile
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.kernels.arrays.block_keys import CELL_BIAS

CAMERA = loom.PinholeCameraIntrinsic(32, 24, 31.0, 29.0, 15.3, 11.7)


def frame(seed):
    rng = np.random.default_rng(seed)
    depth, T = 0.6 + 0.1 * rng.random((24, 32)), np.eye(4)
    T[:3, 3] = rng.uniform(-0.2, 0.2, 3)
    return depth, T, rng.integers(0, 256, (24, 32, 3), dtype=np.uint8)


def add(volume, seeds, colored):
    for seed in seeds:
        depth, T, color = frame(seed)
        volume.integrate(depth, CAMERA, T, color=color if colored else None)
    return volume


def make(device, *, color=True, colored=None, seeds=(0, 1), voxel_size=0.03):
    volume = loom.TSDFVolume(voxel_size=voxel_size, truncation=3 * voxel_size, color=color, device=device)
    return add(volume, seeds, color if colored is None else colored)


def bits(volume):
    count = volume.block_count
    keys = volume.blocks.keys.numpy()[:count].tobytes()
    names = ("distances", "weights", "colors")[: 3 if volume.has_color else 2]
    voxels = [getattr(volume.blocks, name).numpy()[: count * 512].tobytes() for name in names]
    numbers = (volume.voxel_size, volume.truncation, volume.frame_count, volume.has_color, volume.origin.tolist())
    return keys, voxels, numbers


@pytest.mark.parametrize(("color", "colored"), [(True, True), (True, False), (False, False)])
def test_a_volume_round_trips_bitwise_and_continues_identically(device, tmp_path, color, colored):
    volume = make(device, color=color, colored=colored)
    volume.save(tmp_path / "room.npz")
    again = loom.TSDFVolume.load(tmp_path / "room.npz", device=device)
    assert bits(again) == bits(volume) and again.device == volume.device
    for v in (volume, again):
        add(v, range(2, 6), colored)
    assert bits(again) == bits(volume)
    a, b = volume.extract_triangle_mesh(1), again.extract_triangle_mesh(1)
    assert len(a) > 0 and a.vertices.tobytes() == b.vertices.tobytes()
    assert a.triangles.tobytes() == b.triangles.tobytes()
    assert (a.vertex_colors is None) == (b.vertex_colors is None) == (not colored)
    views = [v.ray_cast(CAMERA, np.eye(4), weight_threshold=1) for v in (volume, again)]
    assert views[0].depth.max() > 0 and views[0].depth.tobytes() == views[1].depth.tobytes()


def test_a_volume_far_from_zero_keeps_its_origin(tmp_path):
    volume = loom.TSDFVolume(voxel_size=0.03)
    depth, T, color = frame(0)
    T[:3, 3] = (-5e5, -5.4e6, 0)
    volume.integrate(depth, CAMERA, T, color=color)
    volume.save(tmp_path / "a.npz")
    again = loom.TSDFVolume.load(tmp_path / "a.npz")
    assert again.origin.tolist() == [5e5, 5.4e6, 0] and bits(again) == bits(volume)


def test_an_existing_file_is_not_replaced_without_permission(tmp_path):
    path = tmp_path / "room.npz"
    path.write_bytes(b"something else")
    with pytest.raises(FileError, match="exists already"):
        make("cpu").save(path, overwrite=False)
    assert path.read_bytes() == b"something else"
    make("cpu").save(path)
    assert loom.TSDFVolume.load(path).frame_count == 2
    assert [p.name for p in tmp_path.iterdir()] == ["room.npz"], "no temporary file is left"


@pytest.fixture(scope="module")
def saved(tmp_path_factory):
    """The bytes of a small file, and a folder for more."""
    folder = tmp_path_factory.mktemp("volumes")
    make("cpu", voxel_size=0.08).save(folder / "a.npz")
    return (folder / "a.npz").read_bytes(), folder


def arrays_of(content):
    with np.load(io.BytesIO(content)) as archive:
        return {name: archive[name] for name in archive.files}


def write(path, arrays):
    with Path(path).open("wb") as file:
        np.savez_compressed(file, **arrays)


def test_pickled_code_is_not_executed(saved, tmp_path):
    class Harm:
        def __reduce__(self):
            return Path.touch, (tmp_path / "harm",)

    arrays = arrays_of(saved[0]) | {"keys": np.array([Harm()], dtype=object)}
    with (tmp_path / "a.npz").open("wb") as file:
        np.savez(file, **arrays)
    with pytest.raises(FileError):
        loom.TSDFVolume.load(tmp_path / "a.npz")
    assert not (tmp_path / "harm").exists()


def test_other_contents_truncations_and_bytes_around_the_archive_are_rejected(saved, tmp_path):
    content, path = saved[0], tmp_path / "a.npz"
    others = [b"garbage" * 100, b"PK\5\6" + bytes(18), content + b"x", b"#!/bin/sh\n" + content, content[:-1]]
    for wrong in (*others, *(content[:length] for length in range(0, len(content), max(1, len(content) // 60)))):
        path.write_bytes(wrong)
        with pytest.raises(FileError, match=r"/a\.npz"):
            loom.TSDFVolume.load(path)


def value(array, index, number):
    array = array.copy()
    array[index] = number
    return array


EDITS = {
    "sizes: NaN": lambda a: {"sizes": value(a["sizes"], 0, np.nan)},
    "sizes: infinite": lambda a: {"sizes": value(a["sizes"], 1, np.inf)},
    "sizes: truncation below a voxel": lambda a: {"sizes": a["sizes"][::-1].copy()},
    "origin: NaN": lambda a: {"origin": value(a["origin"], 0, np.nan)},
    "frame_count: none": lambda a: {"frame_count": np.array(0)},
    "frame_count: float": lambda a: {"frame_count": np.array(2.0)},
    "has_color: lost": lambda a: {"has_color": np.array([True, False])},
    "has_color: no room": lambda a: {"has_color": np.array([False, True])},
    "keys: negative": lambda a: {"keys": value(a["keys"], 0, -1)},
    "keys: repeated": lambda a: {"keys": value(a["keys"], 0, a["keys"][1])},
    "keys: the sentinel": lambda a: {"keys": value(a["keys"], 0, (1 << 63) - 1)},
    "keys: beyond the limit": lambda a: {"keys": value(a["keys"], 0, (2 * CELL_BIAS - 1) << 42)},
    "keys: one less": lambda a: {"keys": a["keys"][1:]},
    "keys: big-endian garbage": lambda a: {"keys": a["keys"].view(">i8")},
    "distances: NaN": lambda a: {"distances": value(a["distances"], 7, np.nan)},
    "distances: beyond 1": lambda a: {"distances": value(a["distances"], 7, 1.5)},
    "distances: some less": lambda a: {"distances": a["distances"][:-512]},
    "weights: more than frames": lambda a: {"weights": value(a["weights"], 7, 3)},
    "weights: signed": lambda a: {"weights": a["weights"].astype(np.int16)},
    "colors: 8 bits": lambda a: {"colors": a["colors"].astype(np.uint8)},
    "colors: a voxel less": lambda a: {"colors": a["colors"][1:]},
    "format: another": lambda a: {"format": np.frombuffer(b"pointloom TSDF volume 2", np.uint8)},
    "mystery: unknown": lambda a: {"mystery": np.zeros(3)},
} | {f"{name}: missing": lambda a, name=name: {name: None} for name in ("format", "sizes", "keys", "colors")}


@pytest.mark.parametrize("edit", EDITS)
def test_an_edited_file_is_rejected_with_the_array_name(saved, tmp_path, edit):
    arrays = arrays_of(saved[0])
    write(tmp_path / "same.npz", arrays)
    assert loom.TSDFVolume.load(tmp_path / "same.npz").block_count > 1
    edited = arrays | EDITS[edit](arrays)
    write(tmp_path / "a.npz", {name: array for name, array in edited.items() if array is not None})
    with pytest.raises(FileError) as caught:
        loom.TSDFVolume.load(tmp_path / "a.npz")
    name = edit.split(":")[0]
    # if the count of blocks or the presence of color was edited, the error names another array
    other = {"keys": "distances|keys", "has_color": "colors|has_color", "format": "format|TSDF volume"}.get(name, name)
    assert any(word in str(caught.value) for word in other.split("|")), str(caught.value)


def archive_with(path, content, name, member, *, claimed_size=None):
    """The archive with one member replaced by raw bytes, or with a wrong size in the directory."""
    arrays = arrays_of(content)
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for key, values in arrays.items():
            buffer = io.BytesIO()
            np.lib.format.write_array(buffer, values)
            archive.writestr(f"{key}.npy", member if key == name else buffer.getvalue())
        if claimed_size is not None:
            archive.getinfo(f"{name}.npy").file_size = claimed_size


def npy(shape, body=b""):
    """A file of int64 numbers, with a header of any shape."""
    buffer = io.BytesIO()
    np.lib.format.write_array_header_1_0(buffer, {"descr": "<i8", "fortran_order": False, "shape": shape})
    return buffer.getvalue() + body


@pytest.mark.parametrize(
    ("name", "shape", "claimed_size"),
    [
        *(("keys", (10**10,), None), ("distances", (2**62,), None), ("format", (10**6, 10**6), None)),
        *(("keys", (-1,), None), ("keys", (8,), 10**10), ("keys", (8,), 200), ("keys", (8,), 184), ("keys", (8,), 3)),
    ],
)
def test_an_array_with_a_wrong_size_is_rejected_before_allocation(saved, tmp_path, name, shape, claimed_size):
    path = tmp_path / "a.npz"
    archive_with(path, saved[0], name, npy(shape, bytes(64)), claimed_size=claimed_size)
    tracemalloc.start()
    try:
        with pytest.raises(FileError):
            loom.TSDFVolume.load(path)
        assert tracemalloc.get_traced_memory()[1] < 20e6
    finally:
        tracemalloc.stop()


def test_out_of_memory_errors_name_the_file(saved, tmp_path, monkeypatch):
    path = tmp_path / "a.npz"
    path.write_bytes(saved[0])

    def refuse(*args, **kwargs):
        raise MemoryError

    monkeypatch.setattr("zipfile.ZipExtFile.read", refuse)
    with pytest.raises(MemoryError, match=r"a\.npz"):
        loom.TSDFVolume.load(path)


def test_a_duplicate_member_is_rejected(saved, tmp_path):
    path = tmp_path / "a.npz"
    path.write_bytes(saved[0])
    with zipfile.ZipFile(path, "a") as archive, pytest.warns(UserWarning, match="Duplicate"):
        archive.writestr("keys.npy", npy((0,)))
    with pytest.raises(FileError, match="duplicated"):
        loom.TSDFVolume.load(path)


@settings(deadline=None, derandomize=True, max_examples=50)
@given(st.data())
def test_a_file_with_changed_bytes_is_rejected_or_a_valid_volume(saved, data):
    """zip's checksums cover the arrays but not the directory: an accepted file must be complete and usable."""
    content, folder = saved
    changed = bytearray(content)
    spans = [(0, 200), (len(content) - 900, len(content)), (0, len(content))]
    for _ in range(data.draw(st.integers(1, 4))):
        low, high = data.draw(st.sampled_from(spans))
        offset = data.draw(st.integers(low, high - 1))
        kind = data.draw(st.sampled_from(["set", "cut", "insert"]))
        if kind == "set" or offset >= len(changed):
            changed[min(offset, len(changed) - 1)] = data.draw(st.integers(0, 255))
        elif kind == "cut":
            del changed[offset : offset + data.draw(st.integers(1, 50))]
        else:
            changed[offset:offset] = data.draw(st.binary(min_size=1, max_size=20))
    path = folder / "changed.npz"
    path.write_bytes(changed)
    try:
        volume = loom.TSDFVolume.load(path)
    except FileError as error:
        assert str(path) in str(error)
    else:
        (folder / "whole.npz").write_bytes(content)
        assert bits(volume) == bits(loom.TSDFVolume.load(folder / "whole.npz"))


@settings(deadline=None, derandomize=True, max_examples=25)
@given(st.data())
def test_any_numbers_in_the_arrays_give_an_error_or_a_usable_volume(saved, data):
    """Edits with valid checksums."""
    content, folder = saved
    arrays = arrays_of(content)
    for _ in range(data.draw(st.integers(1, 3))):
        name = data.draw(st.sampled_from(sorted(arrays)))
        raw = bytearray(arrays[name].tobytes())
        if raw:
            offset = data.draw(st.integers(0, len(raw) - 1))
            raw[offset] = data.draw(st.integers(0, 255))
        if name == "has_color":
            raw = bytearray(b & 1 for b in raw)
        arrays[name] = np.frombuffer(bytes(raw), arrays[name].dtype).reshape(arrays[name].shape)
    path = folder / "edited.npz"
    write(path, arrays)
    try:
        volume = loom.TSDFVolume.load(path)
    except FileError:
        return
    mesh = volume.extract_triangle_mesh(0)
    assert np.isfinite(mesh.vertices).all()
    volume.ray_cast(CAMERA, np.eye(4), weight_threshold=0)

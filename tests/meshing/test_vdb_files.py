"""Files of OpenVDB say what volumes hold: to a reader of their tree written here, and to OpenVDB where there is one."""

import json
import struct
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import pointloom as loom

CAMERA = loom.PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
SYSTEM_PYTHON = Path("/usr/bin/python3")  # Debian's python3-openvdb is of this one
ORACLE = """
import json, sys, pyopenvdb
grids, meta = pyopenvdb.readAll(sys.argv[1])
told = {}
for grid in grids:
    voxels = {}
    for item in grid.citerOnValues():
        assert item.depth == 3, "a tile"
        value = item.value
        voxels[str(list(item.min))] = list(value) if isinstance(value, tuple) else value
    background = grid.background
    told[grid.name] = {"place": grid.transform.indexToWorld((0, 0, 0)), "next": grid.transform.indexToWorld((1, 0, 0)),
        "class": grid.gridClass, "background": background if isinstance(background, float) else list(background),
        "voxels": voxels}
json.dump(told, sys.stdout)
"""


class Reader:
    """A .vdb file by its definition: every byte of it is looked at once."""

    def __init__(self, data):
        self.data, self.at = data, 0
        assert self.take("<qII") == (0x56444220, 224, 10)
        self.take("<I?36s")
        self.metadata()
        self.grids = dict(self.grid() for _ in range(self.take("<i")[0]))
        assert self.at == len(data)

    def take(self, form):
        found = struct.unpack_from(form, self.data, self.at)
        self.at += struct.calcsize(form)
        return found

    def text(self):
        return self.take(f"<{self.take('<I')[0]}s")[0].decode()

    def metadata(self):
        return {self.text(): (self.text(), self.text_bytes()) for _ in range(self.take("<i")[0])}

    def text_bytes(self):
        return self.take(f"<{self.take('<I')[0]}s")[0]

    def mask(self, bits):
        self.at += bits // 8
        return np.unpackbits(np.frombuffer(self.data[self.at - bits // 8 : self.at], np.uint8), bitorder="little") > 0

    def grid(self):
        name, form, parent = self.text(), self.text(), self.text()
        width = {"Tree_float_5_4_3": 1, "Tree_vec3s_5_4_3": 3}[form]
        begin, blocks, end = self.take("<qqq")
        assert (parent, begin) == ("", self.at)
        assert self.take("<I") == (2,)
        told = self.metadata()
        assert self.text() == "UniformScaleTranslateMap"
        numbers = np.array(self.take("<18d")).reshape(6, 3)
        assert self.take("<i") == (1,)
        background = self.take(f"<{width}f")
        leaves = self.topology()
        assert self.at == blocks
        voxels = {}
        for corner, mask in leaves:
            assert (self.mask(512) == mask).all() and self.take("<b") == (0,)
            values = np.array(self.take(f"<{width * mask.sum()}f"), np.float32).reshape(-1, width)
            for place, value in zip(np.flatnonzero(mask), values, strict=True):
                cell = corner + np.array(np.unravel_index(place, (8, 8, 8)))
                voxels[tuple(cell.tolist())] = value
        assert self.at == end
        return name, {"told": told, "place": numbers[0], "size": numbers[1], "background": background, "voxels": voxels}

    def topology(self):
        leaves = []
        tiles, children = self.take("<II")
        assert tiles == 0
        for _ in range(children):
            root = np.array(self.take("<iii"))
            for upper in self.node(32):
                for lower in self.node(16):
                    leaves.append((root + upper * 128 + lower * 8, self.mask(512)))
        return leaves

    def node(self, side):
        children = self.mask(side**3)
        assert not self.mask(side**3).any() and self.take("<b") == (0,)
        return [np.array(np.unravel_index(k, (side,) * 3)) for k in np.flatnonzero(children)]


def read(path):
    return Reader(path.read_bytes()).grids


def fused(device, place=(0.0, 0.0, 0.0), color=True):
    random = np.random.default_rng(0)
    volume = loom.TSDFVolume(voxel_size=0.05, color=color, device=device)
    pose = np.eye(4)
    pose[:3, 3] = -np.array(place)
    shades = random.integers(0, 255, (48, 64, 3)).astype(np.uint8) if color else None
    volume.integrate(random.integers(900, 1100, (48, 64)).astype(np.uint16), CAMERA, pose, color=shades)
    return volume


def voxels_of(volume):
    """{voxel: (distance [m], weight, colour)} of what was seen, from what `save` writes."""
    arrays = volume._downloaded()
    keys, axis = arrays["keys"], (1 << 21) - 1
    blocks = np.stack([keys >> 42, (keys >> 21) & axis, keys & axis], axis=1) - (1 << 20)
    found = {}
    for block, at in zip(*np.nonzero(arrays["weights"].reshape(-1, 512)), strict=True):
        cell = blocks[block] * 8 + np.array(np.unravel_index(at, (8, 8, 8)))
        row = block * 512 + at
        distance = arrays["distances"][row] * np.float32(volume.truncation)
        color = arrays["colors"][row] / np.float32(65535) if "colors" in arrays else None
        found[tuple(cell.tolist())] = distance, arrays["weights"][row], color
    return found


def test_a_volume_is_written_voxel_by_voxel(device, tmp_path):
    volume = fused(device)
    loom.write_vdb(tmp_path / "a.vdb", volume)
    grids, expected = read(tmp_path / "a.vdb"), voxels_of(volume)
    assert list(grids) == ["distance", "weight", "color"] and len(expected) > 1000
    assert min(min(cell) for cell in expected) < 0  # on both sides of a root's child
    for k, name in enumerate(grids):
        voxels = grids[name]["voxels"]
        assert voxels.keys() == expected.keys()
        assert all((voxels[cell] == expected[cell][k]).all() for cell in expected)
    assert grids["distance"]["told"]["class"] == ("string", b"level set")
    assert grids["distance"]["background"] == (np.float32(0.2),)
    assert (grids["distance"]["size"] == 0.05).all() and (grids["distance"]["place"] == 0).all()


def test_voxels_stand_at_their_places_in_the_world(device, tmp_path):
    volume = fused(device, (500_000.0, 5_400_000.0, 300.0), color=False)
    loom.write_vdb(tmp_path / "a.vdb", volume)
    grids = read(tmp_path / "a.vdb")
    assert list(grids) == ["distance", "weight"] and (grids["distance"]["place"] == volume.origin).all()
    field = loom.DistanceField.from_voxels([[0, 0, 0]], 0.5, 1.0, origin=[1e6, 2e6, 30.0], device=device)
    loom.write_vdb(tmp_path / "b.vdb", field)
    assert read(tmp_path / "b.vdb")["distance"]["place"].tolist() == [1e6 + 0.25, 2e6 + 0.25, 30.25]


@pytest.mark.parametrize("signed", [False, True])
def test_a_dense_field_has_its_array_s_voxels_and_no_more(device, tmp_path, signed):
    occupied = np.random.default_rng(1).random((21, 9, 7)) < 0.02
    field = loom.DistanceField.from_array(occupied, 0.1, signed=signed, device=device)
    loom.write_vdb(tmp_path / "a.vdb", field)
    grid = read(tmp_path / "a.vdb")["distance"]
    found = np.full(occupied.shape, np.nan, np.float32)
    for cell, value in grid["voxels"].items():
        found[cell] = value[0]
    assert len(grid["voxels"]) == occupied.size and (found == field.to_array()).all()
    assert grid["background"] == (np.inf,)


def test_a_field_up_to_a_distance_leaves_out_what_is_not_known(device, tmp_path):
    field = loom.DistanceField.from_voxels([[-3, 0, 0], [900, 5, -4000]], 0.1, 0.45, device=device)
    loom.write_vdb(tmp_path / "a.vdb", field)
    grid = read(tmp_path / "a.vdb")["distance"]
    around = np.stack(np.meshgrid(*[np.arange(-4, 5)] * 3), axis=-1).reshape(-1, 3)
    ball = around[(around**2).sum(axis=1) <= 20]  # 4.5^2
    places = np.concatenate([np.add(ball, [-3, 0, 0]), np.add(ball, [900, 5, -4000])]).tolist()
    assert grid["voxels"].keys() == {tuple(place) for place in places}
    assert grid["background"] == (np.float32(0.45),)


def test_occupancy_is_written_as_probabilities(device, tmp_path):
    grid = loom.OccupancyGrid(0.5, device=device)
    grid.insert_scan([[2.2, 0.2, 0.2], [-3.0, 4.0, 1.0]], origin=[0.2, 0.2, 0.2])
    loom.write_vdb(tmp_path / "a.vdb", grid)
    voxels = read(tmp_path / "a.vdb")["probability"]["voxels"]
    places = (np.array(list(voxels)) + 0.5) * 0.5
    expected = grid.probabilities(places).astype(np.float32)
    assert len(voxels) == np.isfinite(grid.to_array()).sum() == 20
    assert np.array_equal(np.concatenate(list(voxels.values())), expected)


def test_nothing_is_a_file_too(device, tmp_path):
    loom.write_vdb(tmp_path / "a.vdb", loom.TSDFVolume(voxel_size=0.1, device=device))
    assert read(tmp_path / "a.vdb")["distance"]["voxels"] == {}


def test_the_same_volume_is_the_same_bytes(device, tmp_path):
    for name in ("a.vdb", "b.vdb"):
        loom.write_vdb(tmp_path / name, fused(device))
    assert (tmp_path / "a.vdb").read_bytes() == (tmp_path / "b.vdb").read_bytes()


def test_a_file_is_kept_where_it_may_not_be_replaced(device, tmp_path):
    (tmp_path / "a.vdb").write_bytes(b"mine")
    with pytest.raises(loom.FileError, match="exists already"):
        loom.write_vdb(tmp_path / "a.vdb", fused(device), overwrite=False)
    assert (tmp_path / "a.vdb").read_bytes() == b"mine"
    with pytest.raises(TypeError, match="volume: expected a TSDFVolume, a DistanceField or an OccupancyGrid, got list"):
        loom.write_vdb(tmp_path / "b.vdb", [1])
    assert [path.name for path in tmp_path.iterdir()] == ["a.vdb"]


def has_openvdb():
    command = [SYSTEM_PYTHON, "-c", "import pyopenvdb"]
    return SYSTEM_PYTHON.exists() and subprocess.run(command, capture_output=True).returncode == 0


@pytest.mark.skipif(not has_openvdb(), reason="python3-openvdb is not installed")
def test_openvdb_reads_what_was_written(tmp_path):
    volume = fused("cpu")
    loom.write_vdb(tmp_path / "a.vdb", volume)
    command = [SYSTEM_PYTHON, "-c", ORACLE, str(tmp_path / "a.vdb")]
    told = json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
    expected = voxels_of(volume)
    assert sys.byteorder == "little" and sorted(told) == ["color", "distance", "weight"]
    for k, name in enumerate(("distance", "weight", "color")):
        voxels = {tuple(json.loads(cell)): np.float32(value) for cell, value in told[name]["voxels"].items()}
        assert voxels.keys() == expected.keys()
        assert all((voxels[cell] == expected[cell][k]).all() for cell in expected)
    grid = told["distance"]
    assert (grid["class"], np.float32(grid["background"])) == ("level set", np.float32(0.2))
    assert np.allclose([grid["place"], grid["next"]], [[0, 0, 0], [0.05, 0, 0]], atol=0)

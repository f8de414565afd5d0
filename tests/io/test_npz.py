"""NPZ: round trips, and invalid headers."""

import io
import re
import zipfile

import numpy as np
import pytest

from pointloom.core.errors import FileError
from pointloom.io.points.npz import read_npz, write_npz
from pointloom.io.table import PointTable

from .point_tables import assert_same_table, table_of


def cloud(count=40, dtype=np.float32, grid=None):
    rng = np.random.default_rng(8)
    attributes = {code: rng.integers(0, 2, count).astype(code) for code in ("?", "i1", "u2", "i4", "u8", "f2", "f8")}
    return table_of(count, dtype, grid, features=rng.random((count, 33)), file=np.arange(count), **attributes)


def array_bytes(array, **changes):
    stream = io.BytesIO()
    np.save(stream, array)
    data = stream.getvalue()
    for old, new in changes.items():
        head, body = data[:128], data[128:]
        old, new = old.encode(), new.encode()
        assert old in head
        data = head.replace(old, new)[:127].ljust(127) + b"\n" + body
    return data


def write_members(path, **members):
    with zipfile.ZipFile(path, "w") as archive:
        for name, data in members.items():
            archive.writestr(f"{name}.npy", data)


@pytest.fixture
def path(tmp_path):
    return tmp_path / "cloud.npz"


@pytest.mark.parametrize(("count", "grid", "dtype"), [(0, None, "f4"), (1, None, "f8"), (40, (5, 8), "f4")])
def test_every_array_survives_a_round_trip_to_the_bit(path, dtype, count, grid):
    table = cloud(count, dtype, grid)
    write_npz(path, table)
    assert_same_table(read_npz(path), table)
    assert list(read_npz(path).attributes) == list(table.attributes)


def test_numpy_reads_written_files_and_their_bytes_are_reproducible(path, tmp_path):
    table = cloud()
    write_npz(path, table)
    with np.load(path) as archive:
        np.testing.assert_array_equal(archive["points"], table.points)
    write_npz(tmp_path / "again.npz", table)
    assert path.read_bytes() == (tmp_path / "again.npz").read_bytes()


@pytest.mark.parametrize("save", [np.savez, np.savez_compressed])
def test_archives_of_numpy_are_read_in_any_layout(path, save):
    points = np.arange(12, dtype=">f8").reshape(3, 4).T
    save(path, points=points, colors=np.full((4, 3), 51, np.uint8), ring=np.arange(8)[::2])
    read = read_npz(path)
    assert read.points.dtype == np.float64 and read.points.flags.c_contiguous
    np.testing.assert_array_equal(read.points, points)
    np.testing.assert_array_equal(read.colors, np.full((4, 3), 0.2, np.float32))
    np.testing.assert_array_equal(read.attributes["ring"], [0, 2, 4, 6])


@pytest.mark.parametrize(
    ("arrays", "reason"),
    [
        ({"xyz": np.zeros((2, 3))}, "no array 'points' (the archive contains: xyz)"),
        ({"points": np.zeros((3, 2))}, "points: expected numbers of shape [n, 3], got float64 [3, 2]"),
        ({"points": np.zeros(3)}, "points: expected numbers of shape [n, 3], got float64 [3]"),
        ({"points": np.zeros((2, 3), bool)}, "points: expected numbers"),
        ({"points": np.zeros((2, 3)), "normals": np.zeros((3, 3))}, "normals: expected numbers of shape [2, 3]"),
        ({"points": np.zeros((2, 3)), "colors": np.full((2, 3), 2.0)}, "a color is outside 0..1"),
        ({"points": np.zeros((2, 3)), "ring": np.zeros((2, 2, 2))}, "ring: expected shape [2] or [2, c], got [2, 2"),
        ({"points": np.zeros((2, 3)), "name": np.array(["a", "b"])}, "name: expected real numbers"),
        ({"points": np.zeros((2, 3)), "grid": np.array([3, 3])}, "grid: expected height and width"),
        ({"points": np.zeros((2, 3)), "evil": np.array([print, None], object)}, "evil:"),  # never unpickled
    ],
)
def test_an_archive_that_is_no_cloud_is_refused(path, arrays, reason):
    np.savez(path, **arrays)
    with pytest.raises(FileError, match=re.escape(reason)):
        read_npz(path)


SHAPES = f"({10**18}, 3)", "(-2, -3)", "(3, 3)", "(1, 3)", "(2, 3, 1)", "()", "(True, 6)", "(2.0, 3)"


@pytest.mark.parametrize("shape", SHAPES)
def test_header_with_a_wrong_shape_is_rejected_before_allocation(path, shape):
    write_members(path, points=array_bytes(np.zeros((2, 3)), **{"(2, 3)": shape}))
    with pytest.raises(FileError, match="points:"):
        read_npz(path)


@pytest.mark.parametrize("size", [10**9, 2**32 - 2])
def test_directory_with_a_wrong_size_is_rejected(path, size):
    write_members(path, points=array_bytes(np.zeros((2, 3))))
    data = bytearray(path.read_bytes())
    entry = data.rindex(b"PK\1\2")
    data[entry + 24 : entry + 28] = size.to_bytes(4, "little")
    path.write_bytes(data)
    with pytest.raises(FileError, match=f"claims {size} bytes from 176 stored ones"):
        read_npz(path)


def test_a_damaged_archive_is_refused(path):
    for change, reason in (
        (lambda data: b"", "is empty"),
        (lambda data: data[:-1], "truncated"),
        (lambda data: data + b"\0", "bytes follow its end"),
        (lambda data: b"junk" + data, "4 bytes precede the archive"),
        (lambda data: data.replace(b"ring__.npy", b"points.npy"), "is duplicated"),
        (lambda data: data.replace(b"\x93NUMPY\1", b"\x93NUMPY\7"), "Bad CRC-32"),
    ):
        np.savez(path, points=np.zeros((2, 3)), ring__=np.zeros(2))
        path.write_bytes(change(path.read_bytes()))
        with pytest.raises(FileError, match=reason):
            read_npz(path)


@pytest.mark.parametrize("name", ["points", "grid", "", "a/b", "..\\b", "new\nline"])
def test_attribute_name_unsupported_as_member_is_rejected(path, name):
    with pytest.raises(FileError, match=r"/cloud\.npz:"):
        write_npz(path, PointTable(np.zeros((2, 3)), attributes={name: np.zeros(2)}))
    assert not list(path.parent.iterdir())


def test_out_of_memory_error_names_the_file(path, monkeypatch):
    np.savez(path, points=np.zeros((2, 3)))

    def refuse(*args, **kwargs):
        raise MemoryError

    for target in ("zipfile.ZipExtFile.read", "numpy.lib.format.read_array_header_1_0", "numpy.frombuffer"):
        with monkeypatch.context() as patch:
            patch.setattr(target, refuse)
            with pytest.raises(MemoryError, match=re.escape(f"{path}: not enough memory")):
                read_npz(path)


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        (r"{'descr': '\z', 'fortran_order': False, 'shape': (3,), }", "header is damaged"),  # Python warns of both
        ("{'descr': '<f8', 'fortran_order': False, 'shape': (1or 3,), }", "header is damaged"),
        ("(" * 5000, "header is damaged"),
        ("{'descr': '<f8'}", "header is damaged"),
        (b"\x94NUMPY\1\0v\0", "header is damaged"),
        (b"\x93NUMPY\7\0v\0", "unknown version"),
    ],
    ids=range(6),
)
def test_a_damaged_header_is_an_error_and_no_warning(path, text, reason):
    header = text if isinstance(text, bytes) else b"\x93NUMPY\1\0" + (len(text) + 2).to_bytes(2, "little")
    write_members(path, points=header + (b"" if isinstance(text, bytes) else text.encode() + b" \n") + bytes(200))
    with pytest.raises(FileError, match=reason):
        read_npz(path)

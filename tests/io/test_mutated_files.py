"""Damaged files: a reader returns a consistent table or raises FileError."""

import contextlib
import json
import struct
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pointloom.cameras.camera import PinholeCameraIntrinsic
from pointloom.cameras.image_names import number_of
from pointloom.cameras.trajectory import Trajectory, read_trajectory, write_trajectory
from pointloom.core.errors import FileError
from pointloom.io import obj_statements
from pointloom.io.bags.mcap import read_mcap
from pointloom.io.images.image_files import read_color
from pointloom.io.meshes.glb import read_glb
from pointloom.io.meshes.glb_writer import write_glb
from pointloom.io.meshes.obj import read_obj, write_obj
from pointloom.io.meshes.off import read_off, write_off
from pointloom.io.meshes.stl import read_stl, write_stl
from pointloom.io.models import colmap_binary, colmap_text
from pointloom.io.models.metashape import read_metashape_cameras
from pointloom.io.points import text_table as tables
from pointloom.io.points.e57 import read_e57
from pointloom.io.points.e57_writer import write_e57
from pointloom.io.points.las import read_las
from pointloom.io.points.las_writer import write_las
from pointloom.io.points.npz import read_npz, write_npz
from pointloom.io.points.pcd import read_pcd, write_pcd
from pointloom.io.points.ply import read_ply, read_ply_mesh, write_ply, write_ply_mesh
from pointloom.io.points.ptx import read_ptx
from pointloom.io.points.text import read_text, write_text
from pointloom.io.points.text_table import read_text_table
from pointloom.io.splats.splat_files import read_splats, write_splats
from pointloom.io.splats.splat_ply import read_splat_ply
from pointloom.io.table import MeshTable, PointTable
from pointloom.registration.trajectories.similarity import read_positions

from ..interruptions import PACKAGE, run_lines
from ..pcd.test_splats import made
from .point_tables import table_of
from .test_camera_files import TRANSFORM, camera, document
from .test_splat_files import CHUNK, compressed, packed
from .test_text import scan
from .textured_meshes import square, textured


def quads_and_triangles(path, byte_order):
    """Faces of varying length after vertices with a list of varying length."""
    word = {"<": "binary_little_endian", ">": "binary_big_endian"}[byte_order]
    header = (
        f"ply\nformat {word} 1.0\nelement vertex 4\nproperty float x\nproperty list uchar short tags\n"
        "property float y\nproperty float z\nelement face 2\nproperty list uchar int vertex_indices\n"
        "property uchar flag\nend_header\n"
    )
    f4, i2, i4 = (np.dtype(code).newbyteorder(byte_order) for code in ("f4", "i2", "i4"))
    body = b""
    for k in range(4):
        tags = np.arange(k, dtype=i2)
        body += np.array(k, f4).tobytes() + bytes([k]) + tags.tobytes() + np.array([k, k], f4).tobytes()
    for face in ([0, 1, 2], [0, 1, 2, 3]):
        body += bytes([len(face)]) + np.array(face, i4).tobytes() + b"\1"
    path.write_bytes(header.encode() + body)


def text_table(suffix):
    table = table_of(7)
    normals = table.normals if suffix == ".xyzn" else None
    return PointTable(table.points, normals, table.colors if suffix in (".xyzrgb", ".pts") else None)


def scanned():
    table = table_of(7)
    return PointTable(table.points, None, table.colors, {"intensity": np.arange(7, dtype=np.uint16)})


def mesh():
    table = table_of(4)
    return MeshTable(table.points, np.array([[0, 1, 2], [1, 2, 3]]), table.normals, table.colors)


def write_text_stl(path):
    corners = "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1.5 0\n"
    path.write_text(f"solid\nfacet normal 0 0 1\nouter loop\n{corners}endloop\nendfacet\nendsolid\n")


def write_path(path):
    camera = PinholeCameraIntrinsic.prime_sense_default()
    write_trajectory(path, Trajectory(np.tile(np.eye(4), (2, 1, 1))), intrinsic=camera)


def write_cameras(path):
    path.write_text(document(camera() + camera("b", number=1), more=TRANSFORM))


MAKERS = {
    "binary.ply": (lambda path: write_ply(path, table_of(7)), read_ply),
    "ascii.ply": (lambda path: write_ply(path, table_of(7), ascii=True), read_ply),
    "big.ply": (lambda path: quads_and_triangles(path, ">"), read_ply_mesh),
    "little.ply": (lambda path: quads_and_triangles(path, "<"), read_ply_mesh),
    "mesh.ply": (lambda path: write_ply_mesh(path, mesh()), read_ply_mesh),
    "ascii_mesh.ply": (lambda path: write_ply_mesh(path, mesh(), ascii=True), read_ply_mesh),
    "binary.pcd": (lambda path: write_pcd(path, table_of(7)), read_pcd),
    "ascii.pcd": (lambda path: write_pcd(path, table_of(7), encoding="ascii"), read_pcd),
    "compressed.pcd": (lambda path: write_pcd(path, table_of(40), encoding="binary_compressed"), read_pcd),
    "cloud.xyz": (lambda path: write_text(path, text_table(".xyz")), read_text),
    "cloud.xyzn": (lambda path: write_text(path, text_table(".xyzn")), read_text),
    "cloud.xyzrgb": (lambda path: write_text(path, text_table(".xyzrgb")), read_text),
    "cloud.pts": (lambda path: write_text(path, text_table(".pts")), read_text),
    "cloud.csv": (lambda path: path.write_text("x,y,z,r,g,b,t\n1,2,3,0,1,255,7\n4,5,6,9,8,7,0\n"), read_text_table),
    "plain.txt": (lambda path: path.write_text("# x y z\n1 2 3\n4.5 5e1 -6\n"), read_text_table),
    "scans.ptx": (lambda path: path.write_text(scan()), read_ptx),
    "splats.ply": (lambda path: compressed(path, [packed()] * 3, CHUNK, sh=[[1] * 9] * 3), read_splat_ply),
    "splats.spz": (lambda path: write_splats(path, made(3, 0)), read_splats),
    "mesh.obj": (lambda path: write_obj(path, mesh()), read_obj),
    "mesh.stl": (lambda path: write_stl(path, MeshTable(mesh().vertices, mesh().triangles)), read_stl),
    "text.stl": (write_text_stl, read_stl),
    "mesh.off": (lambda path: write_off(path, mesh()), read_off),
    "mesh.glb": (lambda path: write_glb(path, square()), read_glb),
    "square.obj": (lambda path: write_obj(path, square()), read_obj),
    "textured.ply": (lambda path: write_ply_mesh(path, textured()), read_ply_mesh),
    "square_ascii.ply": (lambda path: write_ply_mesh(path, square(), ascii=True), read_ply_mesh),
    "cloud.las": (lambda path: write_las(path, scanned()), read_las),
    "cloud.laz": (lambda path: write_las(path, scanned()), read_las),
    "cloud.e57": (lambda path: write_e57(path, scanned()), read_e57),
    "cloud.npz": (lambda path: write_npz(path, table_of(7)), read_npz),
    "cameras.xml": (write_cameras, read_metashape_cameras),
    **{f"path.{suffix}": (write_path, read_trajectory) for suffix in ("log", "tum", "kitti", "json")},
}


@pytest.fixture(scope="module")
def valid_files():
    with tempfile.TemporaryDirectory() as folder:
        files = {}
        for name, (write, _) in MAKERS.items():
            path = Path(folder) / name
            write(path)
            files[name] = path.read_bytes()
        yield Path(folder), files


TEXT = ("path", "ascii", "cloud.xyz", "cloud.pts", "cloud.csv", "plain", "scans", "mesh.o", "text.stl", "square")
UNBOUNDED = ("cloud.xyz", "plain", "cloud.la", "splats.spz")  # formats that allow bytes behind the points
COUNTED = ["ascii.ply", "ascii_mesh.ply", "ascii.pcd", "cloud.pts", "scans.ptx", "text.stl", "mesh.off", "path.json"]

pytestmark = [
    pytest.mark.filterwarnings("ignore:.*(are|is) (dropped|ignored)"),
    pytest.mark.filterwarnings("ignore:.*(clamped|divided by 255|defined twice|before any newmtl)"),
    pytest.mark.filterwarnings("ignore:.*white is used"),
    pytest.mark.filterwarnings("ignore:.*triangulated as fans"),
    pytest.mark.filterwarnings("ignore:.*(fewer than 3 corners|zeros or white space|no complete triangle)"),
    pytest.mark.filterwarnings("ignore:.*(no number of points in its first line|GPS times have an offset)"),
    pytest.mark.filterwarnings("ignore:.*WIDTH x HEIGHT is 0"),
    pytest.mark.filterwarnings("ignore:.*The matrix is used"),
]


@st.composite
def damages(draw):
    """A list of edits, each at a relative position in the file."""
    edits = st.tuples(
        st.sampled_from(["set", "cut", "insert", "delete", "repeat"]),
        st.floats(0, 1, exclude_max=True),
        st.binary(min_size=1, max_size=6)
        | st.sampled_from([b"-1", b"99999999999", b"nan", b"\n", b" ", b"list", b"\xff" * 8]),
        st.integers(1, 40),
    )
    return draw(st.lists(edits, min_size=1, max_size=4)), draw(st.floats(0, 1))


def damage(valid, edits, fraction):
    """Apply the edits; a fraction below 0.6 limits them to the header, where they have the largest effect."""
    data = bytearray(valid)
    for kind, position, payload, length in edits:
        extent = min(len(data), 400) if fraction < 0.6 else len(data)
        at = int(position * extent)
        if kind == "set":
            data[at : at + len(payload)] = payload[: len(data) - at]
        elif kind == "cut":
            del data[at:]
        elif kind == "insert":
            data[at:at] = payload
        elif kind == "delete":
            del data[at : at + length]
        else:
            data[at:at] = data[at : at + length]
    return bytes(data)


def check_consistent(table):
    if not isinstance(table, (MeshTable, PointTable)):
        assert len(table) and np.isfinite(table.poses if isinstance(table, Trajectory) else table.centers).all()
        return
    points = table.vertices if isinstance(table, MeshTable) else table.points
    count = len(points)
    assert points.shape == (count, 3) and points.dtype in (np.float32, np.float64)
    if isinstance(table, MeshTable):
        triples = (table.vertex_normals, table.vertex_colors)
        assert table.triangles.ndim == 2 and table.triangles.shape[1] == 3
        assert not table.triangles.size or 0 <= table.triangles.min() <= table.triangles.max() < count
        uvs, ids = table.triangle_uvs, table.triangle_material_ids
        assert uvs is None or uvs.shape == (3 * len(table.triangles), 2)
        assert ids is None or ids.shape == (len(table.triangles),)
        assert ids is None or 0 <= ids.min() <= ids.max() < len(table.textures)
    else:
        triples = (table.normals, table.colors)
        assert table.grid is None or table.grid[0] * table.grid[1] == count
    for array in triples:
        assert array is None or (array.shape == (count, 3) and array.dtype == np.float32)
    for array in table.attributes.values():
        assert len(array) == count and array.dtype.kind in "biuf"


@pytest.mark.parametrize("name", MAKERS)
@settings(max_examples=25, derandomize=True, deadline=None, database=None)
@given(damages())
def test_damaged_bytes_give_a_consistent_table_or_a_file_error(name, valid_files, damaged):
    folder, files = valid_files
    path = folder / f"damaged_{name}"
    path.write_bytes(damage(files[name], *damaged))
    try:
        table = MAKERS[name][1](path)
    except FileError as error:
        assert str(path) in str(error) and error.reason
    else:
        check_consistent(table)


@pytest.mark.parametrize("name", [name for name in MAKERS if not name.startswith(TEXT)] + COUNTED)
def test_a_truncated_file_that_lost_a_value_is_an_error(name, valid_files):
    folder, files = valid_files
    path, content = folder / f"short_{name}", files[name]
    total = len(content.rstrip()) - len(content.split()[-1]) if name in COUNTED else len(content)
    for size in sorted({*range(0, total, max(1, total // 50)), *range(total - 9, total)}):
        path.write_bytes(content[:size])
        with pytest.raises(FileError):
            MAKERS[name][1](path)


@pytest.mark.parametrize("name", [name for name in MAKERS if not name.startswith(UNBOUNDED)])
def test_bytes_behind_the_payload_are_an_error(name, valid_files):
    folder, files = valid_files
    path = folder / f"long_{name}"
    path.write_bytes(files[name] + b"\n1 2 3\n")
    with pytest.raises(FileError):
        MAKERS[name][1](path)


@pytest.mark.parametrize("name", MAKERS)
def test_random_bytes_are_a_file_error(name, valid_files):
    path, rng = valid_files[0] / f"garbage_{name}", np.random.default_rng(0)
    for size in (0, 1, 7, 50, 200):
        path.write_bytes(b"\0" + rng.bytes(size))
        with pytest.raises(FileError):
            MAKERS[name][1](path)


RUNS = {
    "digits.xyz": (lambda run: b"1 2 3\n" + b"1" * run + b"x 2 3\n", read_text),
    "ones.jpg": (lambda run: SCAN + b"\xff" * run + b"\0", read_color),
}
SCAN = b"\xff\xd8\xff\xc0\0\x0b\x08\0\x08\0\x08\x01\x01\x11\0\xff\xda\0\x08\x01\x01\0\0\x3f\0"  # one of 8 x 8 pixels


@pytest.mark.parametrize("name", RUNS)
def test_a_long_run_takes_linear_time(tmp_path, name):
    """A quadratic search would take an hour."""
    content, read = RUNS[name]
    (tmp_path / name).write_bytes(content(1_000_000))
    with pytest.raises(FileError, match=name):
        read(tmp_path / name)
    assert number_of("1" * 1_000_000 + "x") is None


class Name(str):
    """A name that counts its comparisons."""

    compared = 0

    def __eq__(self, other: object) -> bool:
        Name.compared += 1
        return str(self) == str(other)

    __hash__ = str.__hash__


class Line(bytes):
    """Bytes that count what concatenations copy. Their parts are of the same class."""

    copied = 0

    def partition(self, mark: Any) -> Any:
        return tuple(map(Line, super().partition(mark)))

    def rstrip(self, *signs: Any) -> "Line":
        return Line(super().rstrip(*signs))

    def __getitem__(self, part: Any) -> Any:
        return Line(super().__getitem__(part))

    def __add__(self, other: Any) -> "Line":
        Line.copied += len(self) + len(other)
        return Line(super().__add__(other))

    def __radd__(self, other: Any) -> "Line":
        return Line(other) + self


def _comparisons(folder: Path, count: int, patch: pytest.MonkeyPatch) -> int:
    """The comparisons of column names for a file with this number of columns, of which two have one name."""
    canonical = tables._canonical
    patch.setattr(tables, "_canonical", lambda name: Name(canonical(name)))
    names = [*"xyz", *(f"c{k}" for k in range(count)), "x"]
    (folder / "columns.csv").write_text(",".join(names) + "\n" + ",".join("1" * len(names)) + "\n")
    Name.compared = 0
    with pytest.raises(FileError, match="two columns are named x"):
        read_text_table(folder / "columns.csv")
    return Name.compared


def _copies(folder: Path, count: int, patch: pytest.MonkeyPatch) -> int:
    """The bytes that are copied to join this number of continued lines."""
    joined = obj_statements._joined
    patch.setattr(obj_statements, "_joined", lambda path, lines: joined(path, [*map(Line, lines)]))
    (folder / "continued.obj").write_bytes(OBJ + b"f 1 2 3" + b" \\\n" * count + b"\n")
    Line.copied = 0
    assert len(read_obj(folder / "continued.obj").triangles) == 1
    return Line.copied


@pytest.mark.parametrize("operations", [_comparisons, _copies])
def test_names_are_compared_and_lines_copied_in_proportion_to_their_number(tmp_path, operations):
    counts = []
    for count in (100, 400):
        with pytest.MonkeyPatch.context() as patch:
            counts.append(operations(tmp_path, count, patch))
    assert counts[1] <= 5 * counts[0] + 100


XYZ = b"property float x\nproperty float y\nproperty float z\n"


def _ply(declarations: bytes, row: bytes) -> bytes:
    return b"ply\nformat ascii 1.0\nelement vertex 1\n" + XYZ + declarations + b"end_header\n0 0 0" + row + b"\n"


def _gltf(n: int, **parts: object) -> bytes:
    mesh = {"primitives": [{"attributes": {"POSITION": 0}}]}
    position = {"componentType": 5126, "count": 3, "type": "VEC3", "bufferView": 0}
    content = {
        "asset": {"version": "2.0"},
        "buffers": [{"byteLength": 36, "uri": "data:;base64," + "A" * 48}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "accessors": [position],
        "meshes": [mesh],
        "nodes": [{"mesh": 0}] * n,
    }
    return json.dumps(content | parts).encode()


def _record(kind: int, content: bytes) -> bytes:
    return struct.pack("<BQ", kind, len(content)) + content


def _chunks(n: int) -> bytes:
    """An MCAP file of this number of chunks of one message each, with their indexes."""
    text = struct.Struct("<I").pack
    channel = struct.pack("<HH", 1, 0) + text(2) + b"/a" + text(3) + b"cdr" + text(0)
    parts = [b"\x89MCAP0\r\n", _record(4, channel)]
    for time in range(n):
        message = _record(5, struct.pack("<HIQQ", 1, 0, time, time))
        head = struct.pack("<QQQI", time, time, len(message), 0) + text(0) + struct.pack("<Q", len(message))
        parts += [_record(6, head + message), _record(7, struct.pack("<HIQQ", 1, 16, time, 0))]
    return b"".join([*parts, _record(15, bytes(4)), _record(2, bytes(20)), parts[0]])


def _images(n: int) -> bytes:
    parts = [struct.pack("<I7dI", k, 1, *[0] * 6, 1) + b"%d.png\0" % k + bytes(8) for k in range(n)]
    return struct.pack("<Q", n) + b"".join(parts)


def _names(path: Path) -> None:
    read_positions(path, [f"{line.split()[0]}.jpg" for line in path.read_text().splitlines()])


OBJ = b"v 0 0 0\nv 1 0 0\nv 0 1 0\n"
FILES = tuple(
    str(file.relative_to(PACKAGE))
    for folder in ("io", "registration", "cameras")
    for file in (PACKAGE / folder).rglob("*.py")
)
REPEATED: dict[str, tuple[Callable[[int], bytes], Callable[[Path], object]]] = {
    "properties.ply": (lambda n: _ply(b"".join(b"property int p%d\n" % k for k in range(n)), b" 1" * n), read_ply),
    "elements.ply": (lambda n: _ply(b"".join(b"element e%d 0\n" % k for k in range(n)), b""), read_ply),
    "nodes.gltf": (_gltf, read_glb),
    "targets.gltf": (
        lambda n: _gltf(n, meshes=[{"primitives": [{"attributes": {"POSITION": 0}, "targets": [{}] * n}]}]),
        read_glb,
    ),
    "libraries.obj": (lambda n: b"mtllib libraries.obj\n" * n + OBJ + b"usemtl a\nf 1 2 3\n", read_obj),
    "chunks.mcap": (_chunks, read_mcap),
    "images.bin": (_images, colmap_binary.read_images),
    "images.txt": (
        lambda n: b"".join(b"%d 1 0 0 0 0 0 0 1 %d.png\n\n" % (k, k) for k in range(n)), colmap_text.read_images
    ),
    "frames.txt": (
        lambda n: b"".join(b"%d 1 1 0 0 0 0 0 0 1 CAMERA 1 %d\n" % (k, k) for k in range(n)), colmap_text.read_frames
    ),
    "names.txt": (lambda n: b"".join(b"%d %d 0 0\n" % (k, k) for k in range(n)), _names),
}  # fmt: skip


@pytest.mark.filterwarnings("ignore")  # about dropped content
@pytest.mark.parametrize("name", REPEATED)
def test_the_lines_that_a_reader_runs_grow_in_proportion_to_the_parts_of_a_file(tmp_path, name):
    content, read = REPEATED[name]
    path = tmp_path / name

    def read_parts() -> None:
        with contextlib.suppress(FileError):
            read(path)

    def lines(count: int) -> int:
        path.write_bytes(content(count))
        return run_lines(read_parts, FILES)

    lines(10)  # imports
    few, many = lines(100), lines(400)
    assert many < 5 * few

"""The table of fuzz cases: for each reader complete seed files, how they are damaged, and an oracle.

`seeds` creates the bytes of complete files, `mutate` damages one (mutations.py), `read` is the reader, and `oracle`
describes a difference between the result and the file (oracles.py), or returns None.
"""

from __future__ import annotations

import random
import struct
import tempfile
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import folder_cases
import job_cases
import media_cases
import mutations
import numpy as np
import open3d_cases
import oracles
import other_cases
import ply_oracle
import public_cases
import stage_cases

from pointloom.io.meshes.obj import read_obj, write_obj
from pointloom.io.meshes.off import read_off, write_off
from pointloom.io.meshes.stl import read_stl, write_stl
from pointloom.io.points.pcd import read_pcd, write_pcd
from pointloom.io.points.ply import read_ply_mesh, write_ply_mesh
from pointloom.io.table import MeshTable, PointTable


@dataclass(frozen=True)
class Case:
    """How one reader is fuzzed.

    Attributes:
        name: Name in the table.
        suffix: Suffix of its files.
        seeds: Creates complete files.
        mutate: Damages one.
        read: Reads it through the public API.
        oracle: Describes a difference between the result and the file; raises for a file that must be rejected.
    """

    name: str
    suffix: str
    seeds: Callable[[], list[bytes]]
    mutate: mutations.Mutation
    read: Callable[[Path], Any]
    oracle: Callable[[Path, Any], str | None]


def _mesh(*, normals: bool = False, colors: bool = False, uvs: bool = False, faces: bool = False) -> MeshTable:
    rng = np.random.default_rng(3)
    vertices = (
        np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0.5, 0.5, 1], [2, 2, 2]])
        + rng.normal(size=(6, 3)) * 0.01
    )
    triangles = np.array([[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4], [0, 2, 1], [0, 3, 2]])
    mesh = MeshTable(vertices, triangles)
    if normals:
        mesh.vertex_normals = rng.normal(size=(6, 3)).astype(np.float32)
    if colors:
        mesh.vertex_colors = rng.integers(0, 256, (6, 3)).astype(np.float32) / np.float32(255)
    if uvs:
        mesh.triangle_uvs = rng.random((18, 2)).astype(np.float32)
    if faces:
        mesh.triangle_attributes = {"colors": rng.integers(0, 256, (6, 4)) / 255, "label": np.arange(6, dtype=np.int16)}
        mesh.attributes = {"quality": rng.random(6)}
    return mesh


def _written(write: Callable[..., None], *objects: Any, **options: Any) -> list[bytes]:
    contents = []
    with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for value in objects:
            write(Path(folder) / "x", value, **options)
            contents.append((Path(folder) / "x").read_bytes())
    return contents


_OBJ = b"""# a square and what stands on it
o a
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0.5 0.5 2
vt 0 0
vt 1 0
vt 1 1
vn 0 0 1
vn 1 0 0
vn 0 1 0
s 1
f 1/1/1 2/2/1 3/3/1 4/1/1
f -5 -4 -1
f 2//1 3//1 5//1
f 3/3 \\
 4/2 5/1
"""
_POLYGONS = b"""v 0 0 0
v 4 0 0
v 4 4 0
v 2 1 0
v 0 4 0
v 0 0 2
f 3 4 5 1 2
f 6 1 2
f 4 5 3 2
"""


def _obj() -> list[bytes]:
    return [
        _OBJ,
        _POLYGONS,
        *_written(write_obj, _mesh(), _mesh(normals=True, colors=True), _mesh(normals=True, uvs=True)),
    ]


def _off() -> list[bytes]:
    vertices = b"0 0 0\n4 0 0\n4 4 0\n2 1 0\n0 4 0\n"
    by_hand = b"OFF\n# c\n5 3 0\n" + vertices + b"5 2 3 4 0 1 255 0 0\n3 0 1 4 0 9 0\n4 4 0 1 3 7 0 1\n"
    textured = (
        b"STCNOFF 3 1 0\n"
        + b"0 0 0 0 0 1 0.5 0 1 1 0.25 0.75\n1 0 0 0 0 1 1 0 0 0.5 0 0\n0 1 0 1 0 0 0 0 0 1 1 1\n3 0 1 2\n"
    )
    return [by_hand, textured, *_written(write_off, _mesh(), _mesh(normals=True, colors=True))]


def _stl() -> list[bytes]:
    facet = b"facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 %d.5 0\n endloop\nendfacet\n"
    text = b"solid a b\n" + b"".join(facet % k for k in range(3)) + b"endsolid a b\n"
    return [text, *_written(write_stl, _mesh())]


_PLY = b"""ply
format ascii 1.0
comment by hand
element vertex 5
property float x
property list uchar short tags
property float y
property float z
property uchar red
property uchar green
property uchar blue
property uchar alpha
element face 3
property list uchar int vertex_indices
property uchar red
property uchar green
property uchar blue
property float quality
element tristrips 2
property list int int vertex_indices
end_header
0 0 0 0 255 0 0 255
4 1 7 0 0 0 255 0 9
4 2 8 9 4 0 0 0 255 0
2 0 1 0 9 9 9 9
0 0 4 0 1 2 3 4
5 2 3 4 0 1 255 0 0 0.5
3 0 1 4 0 9 0 nan
4 4 0 1 3 7 0 1 -1e3
7 0 1 3 2 -1 4 2
4 4 0 0 1
"""


def _ply_text() -> list[bytes]:
    return [
        _PLY,
        *_written(write_ply_mesh, _mesh(), _mesh(normals=True, colors=True, uvs=True, faces=True), ascii=True),
    ]


def _ply_binary() -> list[bytes]:
    files = _written(write_ply_mesh, _mesh(colors=True), _mesh(normals=True, uvs=True, faces=True))
    for order, word in (("<", b"binary_little_endian"), (">", b"binary_big_endian")):
        head = _PLY[: _PLY.index(b"end_header\n")].replace(b"ascii", word) + b"end_header\n"
        body = b""
        for k in range(5):
            body += struct.pack(f"{order}fB{k}h2f4B", k, k, *range(k), 2 * k % 3, k % 2, 9, 8, 7, 255)
        for face in ([2, 3, 4, 0, 1], [0, 1, 4], [4, 0, 1, 3]):
            body += struct.pack(f"{order}B{len(face)}i3Bf", len(face), *face, 1, 2, 3, 0.5)
        for strip in ([0, 1, 3, 2, -1, 4, 2], [4, 0, 0, 1]):
            body += struct.pack(f"{order}i{len(strip)}i", len(strip), *strip)
        files.append(head + body)
    return files


def _pcd() -> list[bytes]:
    rng = np.random.default_rng(5)
    cloud = PointTable(
        rng.normal(size=(6, 3)).astype(np.float32),
        rng.normal(size=(6, 3)).astype(np.float32),
        rng.integers(0, 256, (6, 3)) / 255,
        {"ring": np.arange(6, dtype=np.uint16), "f": rng.random((6, 4))},
        (2, 3),
    )
    return [
        data for form in ("ascii", "binary", "binary_compressed") for data in _written(write_pcd, cloud, encoding=form)
    ]


def _some_corners(rng: random.Random, data: bytes) -> bytes:
    return mutations.corners(rng, data) if rng.random() < 0.8 else mutations.text(rng, mutations.corners(rng, data))


CASES = [
    *(
        Case(*other)
        for other in (
            *other_cases.OTHERS,
            *job_cases.JOBS,
            *public_cases.PUBLIC,
            *folder_cases.FOLDERS,
            *stage_cases.STAGES,
            *media_cases.MEDIA,
            *open3d_cases.OPEN3D,
        )
    ),
    Case("OBJ", ".obj", _obj, mutations.text, read_obj, oracles.obj),
    Case("OBJ corners", ".obj", _obj, _some_corners, read_obj, oracles.obj),
    Case("OFF", ".off", _off, mutations.text, read_off, oracles.off),
    Case("STL", ".stl", _stl, mutations.binary, read_stl, oracles.stl),
    Case("PLY mesh, text", ".ply", _ply_text, mutations.text, read_ply_mesh, ply_oracle.ply),
    Case("PLY mesh, binary", ".ply", _ply_binary, mutations.binary, read_ply_mesh, ply_oracle.ply),
    Case("PCD", ".pcd", _pcd, mutations.binary, read_pcd, oracles.pcd),
]

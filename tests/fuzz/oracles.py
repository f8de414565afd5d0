"""Slow parsers of the formats, independent of the readers. They return the file's contents or raise RefusedError.

An oracle takes the file and the reader's result, and describes the difference. RefusedError means that there was
nothing
valid to read. In both cases the reader invented data. Data that a reader skips with a warning is no difference.
"""

from __future__ import annotations

import math
import re
import struct
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np

from pointloom.io.table import MeshTable, PointTable


class RefusedError(Exception):
    """The file is damaged: readers must reject it."""


def require(condition: bool, reason: str) -> None:
    if not condition:
        raise RefusedError(reason)


_REAL = re.compile(rb"[+-]?(\d+\.?\d*(e[+-]?\d+)?|\.\d+(e[+-]?\d+)?|inf(inity)?|nan(\(\w*\))?)", re.I)


def real(word: bytes) -> float:
    require(_REAL.fullmatch(word) is not None, f"no number: {word[:40]!r}")
    value = math.nan if b"nan" in word.lower() else float(word)
    require(not math.isinf(value) or b"n" in word.lower(), "beyond float64")
    return value


def integer(word: bytes, low: int, high: int) -> int:
    value = real(word)
    require(value == value and not math.isinf(value) and value == int(value), f"not an integer: {word[:40]!r}")
    require(low <= value <= high, f"{value} is not in {low}..{high}")
    return int(value)


def unix(data: bytes) -> bytes:
    return data.replace(b"\r\n", b"\n").replace(b"\r", b"\n")


def same(actual: Any, expected: Any) -> bool:
    actual, expected = np.asarray(actual), np.asarray(expected)
    return actual.shape == expected.shape and np.array_equal(actual, expected, equal_nan=actual.dtype.kind == "f")


def differing_faces(mesh: MeshTable, faces: list[list[int]]) -> str | None:
    """Describe how the triangles differ from the faces: n - 2 triangles each, with the face's corners and border
    edges.
    """
    at = 0
    require(any(len(face) > 2 for face in faces), "no face of three corners")
    for number, face in enumerate(faces):
        if len(face) < 3:  # skipped with a warning
            continue
        rows = mesh.triangles[at : at + len(face) - 2].tolist()
        at += len(rows)
        border: Counter[tuple[int, int]] = Counter()
        for corners, sign in [(face, -1), *((row, 1) for row in rows)]:
            for k, b in enumerate(corners):
                a = corners[k - 1]
                border[min(a, b), max(a, b)] += 0 if a == b else sign if a < b else -sign
        if len(rows) != len(face) - 2 or any(border.values()):
            return f"face {number}: {face} became {rows}"
    return None if at == len(mesh.triangles) else f"{len(mesh.triangles)} triangles, the faces have {at}"


# ------------------------------------------------------------------------------------------------ OBJ


def obj(path: Path, mesh: MeshTable) -> str | None:
    data = path.read_bytes()
    if data[:2] in (b"\xff\xfe", b"\xfe\xff"):
        data = data.decode("utf-16").encode("utf-8", "surrogatepass")
    text = re.sub(rb"#[^\n]*", b"", unix(data.removeprefix(b"\xef\xbb\xbf")))
    text = re.sub(rb"\\[ \t\v\f]*\n", b" ", text)
    rows: dict[bytes, list[list[float]]] = {b"v": [], b"vt": [], b"vn": []}
    faces: list[list[list[int | None]]] = []
    for line in text.split(b"\n"):
        words = line.split()
        if words and words[0] in rows:
            is_needed = words[0] != b"vt" or mesh.triangle_uvs is not None
            rows[words[0]].append([real(word) for word in words[1:]] if is_needed else [])
            width = len(rows[words[0]][-1])
            allowed = {b"v": (3, 4, 6), b"vt": (1, 2, 3), b"vn": (3,)}[words[0]]
            require(width in allowed or not is_needed, f"{width} values")
            require(words[0] != b"v" or width != 4 or rows[b"v"][-1][3] == 1, "a weight")
        elif words and words[0] == b"f":
            faces.append([_corner(word, [len(values) for values in rows.values()]) for word in words[1:]])
    counts = [len(values) for values in rows.values()]
    for corner in (corner for face in faces for corner in face):
        require(corner[0] is not None and 0 <= corner[0] < counts[0], f"no vertex {corner[0]}")
    vertices = [row[:3] for row in rows[b"v"]]
    if not same(mesh.vertices, np.array(vertices)):
        return "the vertices differ"
    colors = mesh.vertex_colors
    if colors is not None and not _are_colors(colors, np.array([row[3:] for row in rows[b"v"]])):
        return "the colors differ"
    wrong = differing_faces(mesh, [[corner[0] or 0 for corner in face] for face in faces])
    return wrong or _differing_corners(mesh, faces, rows)


def _corner(word: bytes, before: list[int]) -> list[int | None]:
    parts = word.split(b"/")
    require(
        len(parts) <= 3 and all(re.fullmatch(rb"-?\d+", part) for part in parts if part), f"no corner: {word[:40]!r}"
    )
    require(bool(parts[0]), "a corner without a vertex")
    indices: list[int | None] = [None, None, None]
    for k, part in enumerate(parts):
        if part:
            number = int(re.sub(rb"^(-?)0+(?=\d)", rb"\1", part)[:40])
            indices[k] = before[k] + number if number < 0 else number - 1
    return indices


def _differing_corners(mesh: MeshTable, faces: Any, rows: dict[bytes, list[list[float]]]) -> str | None:
    at = 0
    for face in faces:
        uvs: dict[int, set[tuple[float, ...]]] = {}
        for v, vt, vn in face:
            pair = (0.0, 0.0)
            if mesh.triangle_uvs is not None and vt is not None:
                require(0 <= vt < len(rows[b"vt"]), f"no texture coordinate {vt}")
                pair = tuple(np.array([*rows[b"vt"][vt], 0.0][:2], np.float32).tolist())
            uvs.setdefault(v, set()).add(pair)
            if mesh.vertex_normals is not None:
                require(vn is not None and 0 <= vn < len(rows[b"vn"]), f"no normal {vn}")
                if not same(mesh.vertex_normals[v], np.array(rows[b"vn"][vn], np.float32)):
                    return f"the normal of vertex {v} differs"
        triangle_count = max(len(face) - 2, 0)
        if mesh.triangle_uvs is not None:
            for k, v in enumerate(mesh.triangles[at : at + triangle_count].reshape(-1).tolist()):
                pair = tuple(mesh.triangle_uvs[3 * at + k].tolist())
                if pair not in uvs[v] and not any(map(math.isnan, pair)):
                    return f"the texture coordinates {pair} of vertex {v} differ"
        at += triangle_count
    return None


# ------------------------------------------------------------------------------------------------ OFF


def off(path: Path, mesh: MeshTable) -> str | None:
    text = re.sub(rb"#[^\n]*", b"", unix(path.read_bytes()))
    head = re.match(rb"\s*(ST)?(C)?(N)?OFF", text)
    require(head is not None, "no OFF")
    assert head is not None
    lines = [line.split() for line in text[head.end() :].split(b"\n")]
    lines = [line for line in lines if line]
    counts = [integer(word, 0, 2**32) for word in lines[0][:2]]
    vertices, faces = lines[1 : 1 + counts[0]], lines[1 + counts[0] :]
    require(len(vertices) == counts[0] and len(faces) == counts[1] > 0, "another number of lines")
    table = np.array([[real(word) for word in line] for line in vertices]).reshape(counts[0], -1)
    if not same(mesh.vertices, table[:, :3]):
        return "the vertices differ"
    at = 3
    if head.group(3):
        if mesh.vertex_normals is None or not same(mesh.vertex_normals, table[:, 3:6].astype(np.float32)):
            return "the normals differ"
        at = 6
    if mesh.vertex_colors is not None and not _are_colors(mesh.vertex_colors, table[:, at : at + 3]):
        return "the colors differ"
    corners, colors = [], []
    for line in faces:
        size = integer(line[0], 0, len(line) - 1)
        corners.append([integer(word, 0, counts[0] - 1) for word in line[1 : 1 + size]])
        colors.append([real(word) for word in line[1 + size :]])
        require(len(colors[-1]) in (0, 1, 3, 4), "more values than colors have")
    actual = mesh.triangle_attributes.get("colors")
    if actual is not None:
        expected = np.repeat(np.array(colors), [max(len(face) - 2, 0) for face in corners], axis=0)
        if not _are_colors(actual, expected):
            return "the colors of faces differ"
    return differing_faces(mesh, corners)


def color_scale(values: Any) -> int:
    """The value of a full channel of floating-point colors."""
    are_integers = bool((np.floor(values) == values).all())
    return 255 if (values > 2).any() or (are_integers and (values > 1).any()) else 1


def _are_colors(colors: Any, values: Any) -> bool:
    full = color_scale(values[:, :3])
    return bool((np.abs(colors - np.clip(values / full, 0, 1)) < 2e-7).all())


# ------------------------------------------------------------------------------------------------ STL


def stl(path: Path, mesh: MeshTable) -> str | None:
    data = path.read_bytes()
    count = int.from_bytes(data[80:84], "little")
    if len(data) > 84 and len(data) >= 84 + 50 * count and not data[84 + 50 * count :].strip(b"\0 \t\r\n"):
        facets = [struct.unpack_from("<9f", data, 96 + 50 * k) for k in range(count)]
    else:
        words = [line.split() for line in unix(data).split(b"\n")]
        loops: list[list[list[float]]] = []
        for line in filter(None, words):
            if line[0].lower() == b"outer":
                loops.append([])
            elif line[0].lower() == b"vertex":
                loops[-1].append([real(word) for word in line[1:]])
        require(all(len(row) == 3 for loop in loops for row in loop), "corners that are not three numbers")
        require(all(len(loop) <= 3 for loop in loops), "a facet of more corners")
        facets = [tuple(loop[0] + loop[1] + loop[2]) for loop in loops if len(loop) == 3]  # others are skipped
    require(bool(facets), "no facet")
    corners = np.array(facets).reshape(-1, 3)
    require(bool(np.isfinite(corners).all()), "a corner that is not finite")
    return None if same(mesh.vertices[mesh.triangles].reshape(-1, 3), corners) else "the corners differ"


# ------------------------------------------------------------------------------------------------ PCD


def pcd(path: Path, table: PointTable) -> str | None:
    """Check positions of text and uncompressed binary files; for compressed files only the count."""
    data, at, head = path.read_bytes(), 0, {}
    while "DATA" not in head:
        end = data.find(b"\n", at)
        end = len(data) if end < 0 else end
        words = data[at:end].decode().split()
        require(bool(words) or end < len(data), "no DATA")
        if words and not words[0].startswith("#"):
            require(words[0] not in head, "a line twice")
            head["FIELDS" if words[0] == "COLUMNS" else words[0]] = words[1:]
        at = end + 1
    names, sizes = head["FIELDS"], [int(size) for size in head["SIZE"]]
    counts = [int(count) for count in head.get("COUNT", ["1"] * len(names))]
    grid = int(head["WIDTH"][0]) * int(head.get("HEIGHT", ["1"])[0]) if "WIDTH" in head else None
    points = int(head["POINTS"][0]) if "POINTS" in head else grid
    require(points is not None and grid in (None, 0, points), "the counts are inconsistent")
    assert points is not None
    if len(table.points) != points:
        return f"{len(table.points)} points, the file has {points}"
    types = [
        {"F": "<f", "I": "<i", "U": "<u"}[kind] + str(size) for kind, size in zip(head["TYPE"], sizes, strict=True)
    ]
    first = [sum(counts[: names.index(axis)]) for axis in "xyz"]
    if head["DATA"] == ["ascii"]:
        rows = [line.split() for line in unix(data[at:]).split(b"\n")]
        rows = [row for row in rows if row]
        require(len(rows) == points and all(len(row) == sum(counts) for row in rows), "another number of values")
        expected = np.array([[real(row[k]) for k in first] for row in rows]).reshape(-1, 3)
    elif head["DATA"] == ["binary"]:
        row = np.dtype(
            [
                (f"{k}{name}", code, (count,))
                for k, (name, code, count) in enumerate(zip(names, types, counts, strict=True))
            ]
        )
        require(len(data) - at == points * row.itemsize, "another size")
        values = np.frombuffer(data, row, points, at)
        expected = np.stack([values[f"{names.index(axis)}{axis}"].reshape(points) for axis in "xyz"], axis=1)
    else:
        return None
    with np.errstate(all="ignore"):
        return None if same(table.points, expected.astype(table.points.dtype)) else "the points differ"

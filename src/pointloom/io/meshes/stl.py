"""STL, binary and text: unshared triangles in float32; written as binary. Equal corners are merged, normals recomputed.

Facet colors are the triangle attribute `colors`: 5 bits per channel in the attribute bytes (VisCAM, SolidView, flag
0x8000; or Materialize Magics with a "COLOR=" header and reversed order), or "color r g b [a]" lines in text. 3D
Systems, "StereoLithography Interface Specification" (1989). Wikipedia, "STL (file format)", for colors.
"""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.atomic import atomic_write, check_writable
from ...core.errors import FileError, FilePath
from ...core.escaped_text import escaped
from ..ascii_rows import CHUNK_ROWS, AsciiRows, unix_lines
from ..columns import check_extent, colors_or_loss, warn_left_out, warn_of_loss
from ..source import SourceFile, check_end, open_source
from ..table import MeshTable

_FACET_TYPE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute_bytes", "<u2")])

# Must not begin with "solid", by which readers recognize the text form.
_STL_HEADER = b"binary STL written by pointloom".ljust(80)
_HEADER_BYTES = 84
_COLOR_FLAG = 0x8000
_DEFAULT_COLOR = b"COLOR="

# The lines of a text facet: leading words and the number of values.
_FACET_LINES = (
    (b"facet normal", 3), (b"outer loop", 0),
    (b"vertex", 3), (b"vertex", 3), (b"vertex", 3),
    (b"endloop", 0), (b"endfacet", 0),
)  # fmt: skip
_END_OF_LOOP = 5


def read_stl(path: FilePath, *, with_normals: bool = False) -> MeshTable:
    """Read a triangle mesh from STL. Vertices are float32 (binary) or float64 (text), in order of first use.
    Degenerate facets are kept. `triangle_attributes` has "colors" if any facet has a color, and "normals" as stored, if
    requested."""
    path = Path(path)
    source = open_source(path)
    count = int.from_bytes(source[80:_HEADER_BYTES], "little")
    end = _HEADER_BYTES + count * _FACET_TYPE.itemsize
    is_text = source[:80].lstrip()[:5].lower() == b"solid"
    if len(source) == end or (_HEADER_BYTES < end < len(source) and not is_text):
        check_end(path, source, end)
        facets = source.array(_FACET_TYPE, count, _HEADER_BYTES)
        corners, normals = facets["corners"].reshape(-1, 3).astype(np.float32), facets["normal"]
        colors = _colors_of_bytes(path, bytes(source[:80]), facets["attribute_bytes"])
    elif is_text:  # some binary files start the same way, but have the right size
        corners, normals, colors = _read_text(path, source)
    else:
        raise _wrong_size(path, source, count)
    wild = np.flatnonzero(~np.isfinite(corners).all(axis=1))
    if len(wild):
        raise FileError(path, "a corner is not finite", where=f"triangle {int(wild[0]) // 3}")
    if not len(corners):
        raise FileError(path, "contains no facets")
    check_extent(path, corners)
    vertices, triangles = _merge(corners)
    values = {} if colors is None else {"colors": colors}
    values |= {"normals": normals.astype(np.float32)} if with_normals else {}
    return MeshTable(vertices, triangles.reshape(-1, 3), triangle_attributes=values).checked()


def _colors_of_bytes(path: Path, header: bytes, values: NDArray[np.uint16]) -> NDArray[np.float32] | None:
    """Facet colors from attribute bytes, float32 (t, 3 or 4), or None."""
    fives = (values[:, None] >> np.array([10, 5, 0], np.uint16)) & 31
    colors, flagged = fives.astype(np.float32) / np.float32(31), (values & _COLOR_FLAG) != 0
    begin = header.find(_DEFAULT_COLOR)
    if begin >= 0 and begin + 10 <= len(header):
        default = np.frombuffer(header, np.uint8, 4, begin + 6) / np.float32(255)
        rgba = np.hstack([colors[:, ::-1], np.full((len(values), 1), default[3])])
        rgba[flagged] = default
        return rgba if default[3] < 1 else np.ascontiguousarray(rgba[:, :3])
    if not flagged.any():
        if values.any():
            warn_of_loss(path, "attribute bytes of facets", "they are not colors", stacklevel=4)
        return None
    return _with_white(path, colors, flagged)


def _with_white(path: Path, colors: NDArray[np.float32], has_color: NDArray[np.bool_]) -> NDArray[np.float32]:
    if not has_color.all():
        lacking = int(np.count_nonzero(~has_color))
        message = f"{path}: {lacking} of {len(colors)} facets have no color; white is used"
        warnings.warn(escaped(message), UserWarning, stacklevel=5)
        colors = np.where(has_color[:, None], colors, np.float32(1))
    return colors


def _wrong_size(path: Path, source: SourceFile, count: int) -> FileError:
    if len(source) < _HEADER_BYTES:
        reason = "is not an STL file: it neither begins with solid nor is long enough for the binary format"
        return FileError(path, reason, where=f"byte {len(source)}")
    expected = _HEADER_BYTES + count * _FACET_TYPE.itemsize
    reason = f"{len(source)} bytes, but the {count} facets that it declares take {expected}"
    return FileError(path, reason, where=f"byte {min(len(source), expected)}", remedy="The file may be cut off")


def _read_text(
    path: Path, source: SourceFile
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float32] | None]:
    """Corners of the text form, shape (3 t, 3), facet normals, and facet colors (t, 3 or 4) or None."""
    body = bytes(source[:])
    lines = unix_lines(body).split(b"\n")
    numbers, step, is_open = [b""] * len(lines), 0, False
    current, colors = b"", {}  # by facet
    count = first = skipped = 0
    is_small = False
    for k, line in enumerate(lines):
        words = line.split()
        if not words:
            continue
        if [w.lower() for w in words[:2]] == [b"end", b"solid"]:  # two words, as some programs write
            words = [b"endsolid", *words[2:]]
        word = words[0].lower()
        if is_open and word == b"color":
            if step:
                colors[count] = b" ".join(words[1:])
            else:
                current = b" ".join(words[1:])
            continue
        if step == 0 and word in (b"solid", b"endsolid") and is_open == (word == b"endsolid"):
            is_open, current = not is_open, b""
            continue
        if word == b"endloop" and 2 <= step < _END_OF_LOOP:  # a facet of fewer than three corners
            numbers[first:k], step = [b""] * (k - first), _END_OF_LOOP
            is_small = True
        begin, width = _FACET_LINES[step]
        named = begin.split()
        right = is_open and [w.lower() for w in words[: len(named)]] == named and len(words) == len(named) + width
        if not right:
            expected = begin.decode() + " and three numbers" * (width > 0) if is_open else "solid"
            shown = line.strip()[:40].decode("ascii", "backslashreplace")
            raise FileError(path, f"expected {expected}, got {shown!r}", where=f"line {k + 1}")
        numbers[k] = b" ".join(words[len(named) :])
        if not step:
            first = k
            if current:
                colors[count] = current
        step = (step + 1) % len(_FACET_LINES)
        if not step and is_small:
            colors.pop(count, None)
            is_small, skipped = False, skipped + 1
        elif not step:
            count += 1
    if is_open:
        raise FileError(path, "truncated: ends without endsolid", where=f"line {len(lines)}")
    if skipped:
        message = f"{path}: {skipped} of {skipped + count} facets are skipped, as they have fewer than 3 corners"
        warnings.warn(escaped(message), UserWarning, stacklevel=4)
    rows = AsciiRows(path, b"\n".join(numbers), 1)
    facets = rows.numbers().reshape(-1, 4, 3)
    corners = np.ascontiguousarray(facets[:, 1:].reshape(-1, 3))
    return corners, facets[:, 0], _colors_of_lines(path, colors, count) if colors else None


def _colors_of_lines(path: Path, lines: dict[int, bytes], count: int) -> NDArray[np.float32] | None:
    """Facet colors from color lines by facet number. None, with a warning, if some are invalid."""
    values, width = np.ones((count, 4)), 4
    for facet, line in lines.items():
        try:
            numbers = [float(word) for word in line.split()]
        except ValueError:
            numbers = []
        if len(numbers) not in (3, 4):
            shown = line[:40].decode("ascii", "backslashreplace")
            warn_of_loss(path, "colors", f"a color is three or four numbers, got {shown!r}", stacklevel=5)
            return None
        values[facet, : len(numbers)], width = numbers, min(width, len(numbers))
    stacked = colors_or_loss(path, [values[[*lines], k] for k in range(width)], stacklevel=5)
    if stacked is None:
        return None
    colors, has_color = np.ones((count, width), np.float32), np.zeros(count, bool)
    colors[[*lines]], has_color[[*lines]] = stacked, True
    return _with_white(path, colors, has_color)


def _merge(corners: NDArray[np.floating]) -> tuple[NDArray[np.floating], NDArray[np.int64]]:
    corners = corners + 0.0  # minus zero is zero
    order = np.lexsort(corners.T)
    ordered = corners[order]
    is_first = np.ones(len(corners), bool)
    is_first[1:] = (ordered[1:] != ordered[:-1]).any(axis=1)
    group = np.empty(len(corners), np.int64)
    group[order] = np.cumsum(is_first) - 1
    firsts = order[is_first]  # lexsort is stable: the first corner of each position
    rank = np.empty(len(firsts), np.int64)
    by_first = np.argsort(firsts)
    rank[by_first] = np.arange(len(firsts))
    return corners[firsts[by_first]], rank[group]


def storable_in_stl(mesh: MeshTable) -> tuple[MeshTable, list[str]]:
    optional = {"normals": mesh.vertex_normals, "colors": mesh.vertex_colors, "textures": mesh.triangle_uvs}
    names = [name for name, values in optional.items() if values is not None]
    colors = mesh.triangle_attributes.get("colors")
    storable = {}
    if colors is not None and _is_colors(colors):
        storable = {"colors": colors[:, :3]}
        names += ["opacity of triangle colors"] if (colors[:, 3:] < 1).any() else []
    names += [*mesh.attributes, *(f"triangle {name}" for name in mesh.triangle_attributes if name not in storable)]
    return MeshTable(mesh.vertices, mesh.triangles, triangle_attributes=storable), names


def _is_colors(values: NDArray[Any]) -> bool:
    """True if a triangle attribute is rows of 3 or 4 in 0..1."""
    is_float = values.ndim == 2 and values.shape[1] in (3, 4) and values.dtype.kind == "f"
    return is_float and bool(((values >= 0) & (values <= 1)).all())


def write_stl(path: FilePath, mesh: MeshTable, *, overwrite: bool = True) -> None:
    """Write a triangle mesh as binary STL atomically. Degenerate triangles get the normal (0, 0, 0)."""
    path = check_writable(path, overwrite=overwrite)
    mesh, lost = storable_in_stl(mesh.checked())
    if len(mesh.triangles) >= 2**32:
        raise FileError(path, f"STL cannot store {len(mesh.triangles)} triangles", remedy="Write .ply")
    with np.errstate(over="ignore"):
        single = mesh.vertices.astype(np.float32)
    bad = ~np.isfinite(single[mesh.triangles]).all(axis=(1, 2))
    if bad.any():
        raise FileError(path, "a corner is not finite in float32", where=f"triangle {int(np.flatnonzero(bad)[0])}")
    warn_left_out(path, "STL", [name for name in lost if name != "normals"])
    colors = mesh.triangle_attributes.get("colors")
    with atomic_write(path, overwrite=overwrite) as file:
        file.write(_STL_HEADER + np.uint32(len(mesh.triangles)).astype("<u4").tobytes())
        for begin in range(0, len(mesh.triangles), CHUNK_ROWS):
            rows = mesh.triangles[begin : begin + CHUNK_ROWS]
            corners = mesh.vertices[rows].astype(np.float64)
            normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
            lengths = np.linalg.norm(normals, axis=1, keepdims=True)
            facets = np.zeros(len(rows), _FACET_TYPE)
            facets["normal"] = np.divide(normals, lengths, out=np.zeros_like(normals), where=lengths > 0)
            facets["corners"] = single[rows]
            if colors is not None:
                fives = np.round(colors[begin : begin + CHUNK_ROWS] * 31).astype(np.uint16)
                facets["attribute_bytes"] = _COLOR_FLAG | fives[:, 0] << 10 | fives[:, 1] << 5 | fives[:, 2]
            file.write(facets.tobytes())

"""Statements of Wavefront OBJ files, and their vertices with colors."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ..core.errors import FileError
from .ascii_rows import AsciiRows, unix_lines
from .columns import colors_or_loss, warn_of_loss
from .source import open_source

_KINDS = (b"v", b"vt", b"vn")
_PASSED_OVER = frozenset(b"vp s mg usemap maplib lod bevel c_interp d_interp shadow_obj trace_obj".split())


@dataclass
class Statements:
    """The parsed statements of a file. `lines` has the values of each line for each of `_KINDS`, b"" elsewhere.
    `counts` are the numbers of v, vt and vn, `before` those before each face; `materials` are -1 for none."""

    path: Path
    lines: tuple[list[bytes], list[bytes], list[bytes]]
    counts: tuple[int, int, int] = (0, 0, 0)
    faces: list[bytes] = field(default_factory=list)
    face_lines: list[int] = field(default_factory=list)
    before: list[tuple[int, int, int]] = field(default_factory=list)
    materials: list[int] = field(default_factory=list)
    material_names: dict[str, int] = field(default_factory=dict)
    libraries: list[str] = field(default_factory=list)
    names: dict[str, dict[str, None]] = field(default_factory=lambda: {"objects": {}, "groups": {}})
    has_lines: bool = False

    def rows(self, kind: int) -> AsciiRows:
        """The values of all v, vt or vn. Raises `FileError` if a line has none, which would shift the indices."""
        rows = AsciiRows(self.path, b"\n".join(self.lines[kind]), 1)
        if rows.row_count != self.counts[kind]:
            blank = next(k for k, line in enumerate(self.lines[kind], 1) if line and max(line) <= 32)
            raise FileError(self.path, f"a {_KINDS[kind].decode()} has no values", where=f"line {blank}")
        return rows


def _text_of(path: Path) -> bytes:
    """The bytes of a file with LF line ends and blanks, converted from UTF-16 to UTF-8 if needed."""
    body = bytes(open_source(path)[:])
    if body[:2] in (b"\xff\xfe", b"\xfe\xff"):
        try:
            body = body.decode("utf-16").encode("utf-8", "surrogatepass")
        except UnicodeDecodeError as error:
            raise FileError(path, "is damaged UTF-16", where=f"byte {error.start}") from error
    body = unix_lines(body.removeprefix(b"\xef\xbb\xbf"))
    return body.replace(b"\t", b" ") if b"\t" in body else body


def _joined(path: Path, lines: list[bytes]) -> Iterator[tuple[int, bytes]]:
    """Each statement with its line number, without comments and with continuation lines joined."""
    pending: list[bytes] = []
    first = 0
    for number, line in enumerate(lines, 1):
        text = line.partition(b"#")[0]
        if text.rstrip().endswith(b"\\"):  # continues in the next line
            pending.append(text.rstrip()[:-1])
            first = first or number
            continue
        if first:
            yield first, b" ".join([*pending, text])
            pending, first = [], 0
        else:
            yield number, text
    if first:
        raise FileError(path, "ends in a line with a continuation mark", where=f"line {len(lines)}")


def read_statements(path: Path) -> Statements:
    body = _text_of(path)
    lines = body.split(b"\n")
    statements = Statements(path, ([b""] * len(lines), [b""] * len(lines), [b""] * len(lines)))
    is_plain = b"#" not in body and b"\\" not in body
    counts = [0, 0, 0]
    at_face, material = (0, 0, 0), -1
    for number, text in enumerate(lines, 1) if is_plain else _joined(path, lines):
        kind, _, rest = text.strip().partition(b" ")
        if kind == b"f":
            statements.faces.append(rest)
            statements.face_lines.append(number)
            statements.before.append(at_face)
            statements.materials.append(material)
        elif kind in _KINDS:
            column = _KINDS.index(kind)
            statements.lines[column][number - 1] = rest or b" "
            counts[column] += 1
            at_face = (counts[0], counts[1], counts[2])
        elif kind == b"usemtl":
            name = rest.strip().decode("utf-8", "surrogateescape")
            material = statements.material_names.setdefault(name, len(statements.material_names))
        elif kind == b"mtllib":
            statements.libraries.append(rest.strip().decode("utf-8", "surrogateescape"))
        elif kind in (b"o", b"g"):
            name = rest.strip().decode("utf-8", "backslashreplace")
            statements.names["objects" if kind == b"o" else "groups"][name] = None
        elif kind in (b"p", b"l"):
            statements.has_lines = True
        elif kind and kind not in _PASSED_OVER and not kind.startswith(b"$"):
            shown = kind[:40].decode("ascii", "backslashreplace")
            reason = f"the statement {shown!r} is not supported"
            remedy = "Supported are v, vt, vn and f; convert free-form surfaces to faces first"
            raise FileError(path, reason, where=f"line {number}", remedy=remedy)
    statements.counts = at_face
    return statements


def vertices_of(path: Path, rows: AsciiRows) -> tuple[NDArray[np.float64], NDArray[np.float32] | None]:
    """Positions and, if all lines have six values, colors."""
    if not rows.row_count:
        raise FileError(path, "contains no vertices")
    widths, first, values = rows.widths(), rows.first[:-1], rows.numbers()
    wrong = np.flatnonzero((widths != 3) & (widths != 4) & (widths != 6))
    if len(wrong):
        row = int(wrong[0])
        raise FileError(path, f"a vertex has 3, 4 or 6 values, got {widths[row]}", where=rows.where(row))
    weighted = np.flatnonzero(widths == 4)
    rational = weighted[values[first[weighted] + 3] != 1]
    if len(rational):
        row = int(rational[0])
        reason = f"a vertex has the weight {values[first[row] + 3]:g}; rational vertices are not supported"
        raise FileError(path, reason, where=rows.where(row))
    colored, colors = int((widths == 6).sum()), None
    if 0 < colored < len(widths):
        warn_of_loss(path, "colors", f"only {colored} of {len(widths)} vertices have one", stacklevel=4)
    elif colored:
        colors = colors_or_loss(path, [values[k::6] for k in (3, 4, 5)], stacklevel=4)
    if (widths == widths[0]).all():
        return np.ascontiguousarray(values.reshape(len(widths), -1)[:, :3]), colors
    return values[first[:, None] + np.arange(3)], colors

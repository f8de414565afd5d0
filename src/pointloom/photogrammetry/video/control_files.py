"""Files of ground control and scale bars.

Either ODM's `gcp_list.txt`: coordinate system ("local" for none), then `x y z column row image [name]` lines; or CSV
with `name,x,y,z,image,column,row` and optional `sigma`, `sigma_z` [m] and `use` (control, check), `# crs EPSG:25832`.
The header of the CSV names its columns in any order. Longitude and latitude are x and y of degrees.
Both allow `bar A B meters [sigma]` and `mark NAME image column row`. Points named "check" or "CHK" are check points.
Columns and rows start at the upper left corner: the center of the first pixel is 0.5, 0.5.
"""

from __future__ import annotations

import math
import re
from pathlib import Path
from typing import Any

from ...core.errors import FileError, FilePath
from ...core.paths import path_of
from ...io.number_tables import DecimalMarks, Header, TableForm, fields_of, table_lines, titles_of
from ...registration.stations.observations import ControlPoint
from ..sfm.image_folder import check_path
from .control_systems import is_degrees
from .ground_control import ControlMark, GroundControl, ScaleBar

CONTROL_SIGMA = 0.02  # [m] default
SIGMA_RANGE = (1e-6, 1e3)  # [m] valid range
HALF_PIXEL = 0.5
LOCAL = ("", "local", "none")

_CHECK = re.compile(r"(check|chk)(?![a-z])", re.IGNORECASE)
_COLUMNS = ("name", "image", "column", "row")
_NUMBERS = ("x", "y", "z", "longitude", "latitude", "sigma", "sigma_z", "column", "row")
_SYNONYMS = {"image": "image image_name file filename file_name photo", "column": "column col px pixel_x"}
_SYNONYMS |= {"row": "row py pixel_y", "longitude": "longitude lon lng long", "latitude": "latitude lat"}
_ORDER = "name x y z sigma sigma_z use image column row longitude latitude"
_TABLE = TableForm((_ORDER,), _SYNONYMS, needed=_COLUMNS)
_FORM = "Write lines `x y z column row image [name]` after a first line with the coordinate system, such as EPSG:32632"


def read_ground_control(path: FilePath | None, *, scale_bars: FilePath | None = None) -> GroundControl:
    """Read known points, their image observations, and known lengths.

    Args:
        path: ODM's `gcp_list.txt`, or a CSV with name, x, y, z, image, column, row (docs/video.md); or None.
        scale_bars: File of lengths, `bar A B meters [sigma]`, and marks of their ends.

    Raises:
        TypeError, ValueError: Not a path, or neither is given.
        FileError: Unreadable, a malformed line, a point with two positions or two marks in an image, a bar to an
            unmarked point, or an invalid coordinate system or position.

    Example:
        >>> from pathlib import Path
        >>> from pointloom.photogrammetry.video.control_files import read_ground_control
        >>> lines = ["EPSG:32632", "447000 5260000 410 320 240 a.jpg A", "447000 5260000 410 100 240 b.jpg A"]
        >>> _ = Path("gcp.txt").write_text("\\n".join(lines))
        >>> read_ground_control("gcp.txt")
        GroundControl(1 point, 2 marks, EPSG:32632)
    """
    if path is None and scale_bars is None:
        raise ValueError("path: expected a file of control points or of scale bars, got None")
    parser = _Parser()
    for each, is_bars in ((path, False), (scale_bars, True)):
        if each is not None:
            parser.path = path_of(each)
            _read(parser, is_bars=is_bars)
    return parser.control()


def ground_of(control: Any, scale_bars: Any) -> GroundControl | None:
    if control is None and scale_bars is None:
        return None
    if isinstance(control, GroundControl):
        if scale_bars is not None:
            raise ValueError("scale_bars: expected None with a GroundControl, which contains its own bars")
        ground, path = control, None
    else:
        for name, value in (("control", control), ("scale_bars", scale_bars)):
            if value is not None:
                check_path(name, value)
        ground, path = read_ground_control(control, scale_bars=scale_bars), control
    if not ground.bars and (why := ground.why_open()):
        raise ValueError(f"control: {why}") if path is None else FileError(path, f"holds {why}")
    return ground


def _read(parser: _Parser, *, is_bars: bool) -> None:
    lines = [(number, line.strip(" ")) for number, line in enumerate(table_lines(parser.path), start=1)]
    lines = [(number, line if line.strip() else "") for number, line in lines]
    content = [(number, line) for number, line in lines if line and not line.startswith("#")]
    if not content:
        raise FileError(parser.path, "contains no lines", remedy=_FORM)
    head = {_TABLE.canonical(title)[0] for title in titles_of(parser.path, content[0][1], content[0][0])}
    before = len(parser.bars)
    if head >= {"name", "image"}:
        _parse_csv(parser, lines)
    else:
        _parse_words(parser, content)
    if is_bars and len(parser.bars) == before:
        raise FileError(parser.path, "contains no scale bar", remedy="Write lines `bar A B meters [sigma]`")


class _Parser:
    path: Path

    def __init__(self):
        self.crs: str | None = None
        self.positions: dict[str, tuple[float, ...]] = {}
        self.sigmas: dict[str, tuple[float, float, float]] = {}
        self.checks: dict[str, bool] = {}
        self.marks: dict[tuple[str, str], ControlMark] = {}
        self.bars: list[ScaleBar] = []
        self.degrees_line: int | None = None  # of a header with latitude

    def fail(self, line: int, reason: str, remedy: str = "") -> FileError:
        return FileError(self.path, reason, where=f"line {line}", remedy=remedy)

    def numbers(self, line: int, words: list[str], what: str, remedy: str = "") -> list[float]:
        try:
            values = [float(word) for word in words]
        except ValueError:
            values = [math.nan]
        if not all(math.isfinite(value) and abs(value) < 1e9 for value in values):
            raise self.fail(line, f"expected {what}, got {' '.join(words)[:60]!r}", remedy)
        return values

    def add_position(self, line: int, name: str, words: list[str], remedy: str = "") -> None:
        position = tuple(self.numbers(line, words, "x, y and z", remedy))
        if self.positions.setdefault(name, position) != position:
            raise self.fail(line, f"the point {name!r} has two positions", "Give each point a unique name")

    def add_sigma(self, line: int, name: str, plan: str, height: str) -> None:
        values = self.numbers(line, [plan or height, height or plan], "standard deviations [m]")
        if not all(SIGMA_RANGE[0] <= value <= SIGMA_RANGE[1] for value in values):
            raise self.fail(
                line, f"expected standard deviations of {SIGMA_RANGE[0]:g}..{SIGMA_RANGE[1]:g} m, got {values}"
            )
        self.sigmas[name] = values[0], values[0], values[1]

    def add_use(self, line: int, name: str, use: str) -> None:
        if use.lower() not in ("control", "check"):
            raise self.fail(line, f"expected control or check as the use, got {use!r}")
        self.checks[name] = use.lower() == "check"

    def add_mark(self, line: int, name: str, image: str, words: list[str]) -> None:
        column, row = self.numbers(line, words, "column and row [px]")
        if (name, image) in self.marks:
            raise self.fail(line, f"{name!r} is marked twice in {image}", "Keep one of the marks")
        if max(abs(column), abs(row)) >= 1e6 or not image:
            raise self.fail(line, f"expected an image, column and row [px], got {image!r}, {column:g}, {row:g}")
        pixel = column - HALF_PIXEL, row - HALF_PIXEL
        where = f"{self.path} (line {line})"
        self.marks[name, image] = ControlMark(name, image, pixel, where)  # pyright: ignore[reportArgumentType]

    def add_word_line(self, line: int, words: list[str]) -> bool:
        """Parse `bar` and `mark` lines. True if it was one."""
        word = words[0].lower()
        if word == "bar":
            if len(words) not in (4, 5):
                raise self.fail(line, f"expected `bar A B meters [sigma]`, got {len(words)} words")
            values = self.numbers(line, words[3:], "a length [m]")
            try:
                self.bars.append(ScaleBar(words[1], words[2], *values))
            except ValueError as error:
                raise self.fail(line, str(error)) from None
        elif word == "mark":
            if len(words) != 5:
                raise self.fail(line, f"expected `mark NAME image column row`, got {len(words)} words")
            self.add_mark(line, words[1], words[2], words[3:])
        return word in ("bar", "mark")

    def control(self) -> GroundControl:
        if not self.marks:
            raise FileError(self.path, "contains no marks of points in images", remedy=_FORM)
        points = [
            ControlPoint(name, position, self.sigmas.get(name, (CONTROL_SIGMA,) * 3))
            for name, position in self.positions.items()
        ]
        checks = [name for name in self.positions if self.checks.get(name, bool(_CHECK.match(name)))]
        crs = self.crs or ""
        if self.degrees_line is not None and not is_degrees(crs):
            reason = f"expected a coordinate system in degrees for latitude and longitude, got {crs or 'none'}"
            raise self.fail(self.degrees_line, reason, "Add the line `# crs EPSG:4326`, or name the columns x and y")
        try:
            crs = "" if crs.lower() in LOCAL else crs
            return GroundControl(points, list(self.marks.values()), self.bars, crs, checks, str(self.path))  # pyright: ignore[reportArgumentType]
        except FileError:
            raise
        except ValueError as error:
            raise FileError(self.path, str(error)) from None


def _parse_words(parser: _Parser, lines: list[tuple[int, str]]) -> None:
    crs = None
    names: dict[tuple[str, ...], str] = {}
    for number, line in lines:
        words = line.split()
        if parser.add_word_line(number, words):
            continue
        if crs is None:
            if len(words) >= 6 and _are_numbers(words[:5]):
                raise parser.fail(number, "is a mark, but no line before it contains the coordinate system", _FORM)
            crs = line
            parser.crs = crs
            continue
        if len(words) < 6:
            raise parser.fail(number, f"expected 6 words or more, got {len(words)}", _FORM)
        name = words[6] if len(words) > 6 else names.setdefault(tuple(words[:3]), f"point {len(names) + 1}")
        parser.add_position(number, name, words[:3], _FORM)
        parser.add_mark(number, name, words[5], words[3:5])


def _are_numbers(words: list[str]) -> bool:
    return all(re.fullmatch(r"[-+.\deE]+", word) for word in words)


def _parse_csv(parser: _Parser, lines: list[tuple[int, str]]) -> None:
    head: list[str | None] = []
    marks = DecimalMarks(parser.path)
    for number, line in lines:
        if match := re.match(r"#\s*crs\b[\s:=]*(.*)", line, re.IGNORECASE):
            parser.crs = match[1].strip()
        if not line or line.startswith("#"):
            continue
        if not head:
            head = _head_of(parser, number, line)
            continue
        words = fields_of(parser.path, line, number)[0]
        parts = [word for word in words if word] if len(words) > 1 else line.split()
        if parts and parts[0].lower() in ("bar", "mark"):
            parts[3:] = [marks.plain(part, number) for part in parts[3:]]
            parser.add_word_line(number, parts)
            continue
        row = {name: word for name, word in zip(head, words, strict=False) if name}
        for column, name in enumerate(head, 1):
            if name in _NUMBERS and name in row:
                row[name] = marks.plain(row[name], number, column)
        name = row.get("name", "")
        if len(words) != len(head) or not name:
            raise parser.fail(
                number, f"expected {len(head)} fields and a name among them, got {len(words)}: {line[:60]!r}"
            )
        _add_row(parser, number, name, row)


def _head_of(parser: _Parser, line: int, text: str) -> list[str | None]:
    titles = titles_of(parser.path, text, line)
    known = {_TABLE.canonical(title)[0] for title in titles}
    if missing := [name for name in _COLUMNS if name not in known]:
        raise parser.fail(line, f"the header lacks {', '.join(missing)}")
    names = Header(parser.path, _TABLE, titles, line).names
    axes = known & {"x", "y", "z", "longitude", "latitude"}
    if axes not in (set(), {"x", "y", "z"}, {"longitude", "latitude", "z"}):
        reason = f"expected the columns x, y, z or longitude, latitude, z, got {', '.join(titles)[:200]}"
        raise parser.fail(line, reason, "Correct the header")
    parser.degrees_line = line if "latitude" in axes else None
    return [{"longitude": "x", "latitude": "y"}.get(name or "", name) for name in names]


def _add_row(parser: _Parser, number: int, name: str, row: dict[str, str]) -> None:
    if any(row.get(axis) for axis in "xyz"):
        parser.add_position(number, name, [row.get(axis, "") for axis in "xyz"])
    if row.get("sigma") or row.get("sigma_z"):
        parser.add_sigma(number, name, row.get("sigma", ""), row.get("sigma_z", ""))
    if row.get("use"):
        parser.add_use(number, name, row["use"])
    if row.get("image"):
        parser.add_mark(number, name, row["image"], [row.get("column", ""), row.get("row", "")])

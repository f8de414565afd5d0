"""Tables of observed targets and of control points: `read_targets`, `read_control_points`."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from pathlib import Path

from ...core.checks import check_list, check_name
from ...core.errors import FileError, FilePath
from ...core.paths import input_path, path_of
from ...core.wording import few_of
from ...io.ascii_rows import check_decimal_points, is_float
from .observations import ControlPoint, TargetObservation

_SEPARATOR = re.compile(r"[;,\t]")
MAX_BYTES = 1 << 26  # a table of 500,000 points


def read_targets(path: FilePath, names: Sequence[str]) -> list[TargetObservation]:
    """Read targets that stations observed, from a table.

    Args:
        path: Rows of station, target name, x, y, z and optionally a standard deviation [m]. A station is a name or a
            number from 0. Columns are separated by commas, semicolons, tabs or spaces; numbers have decimal points.
            Lines with # and a header are skipped.
        names: Names of the stations, as of `loom.read_stations`.

    Returns:
        The observations in the order of the rows, for `register_stations`.

    Raises:
        FileError: The file cannot be read, a row is invalid, or its station is unknown. Its line is named.
        TypeError: `names` is not a list of strings.

    Example:
        >>> import pathlib, pointloom as loom
        >>> _ = pathlib.Path("targets.csv").write_text("hall,T1,1.5,2,0.25\\n1,T1,-3,2,0.25,0.001\\n")
        >>> [(t.station, t.name, t.sigma) for t in loom.registration.read_targets("targets.csv", ["hall", "yard"])]
        [(0, 'T1', 0.002), (1, 'T1', 0.001)]
    """
    path = path_of(path)
    stations = [check_name(f"names[{i}]", name) for i, name in enumerate(check_list("names", names, "names"))]
    targets = []
    numbers = {name: i for i, name in enumerate(stations)}
    numbers |= {str(i): i for i in range(len(stations)) if str(i) not in numbers}
    for line, fields in _rows(path, words=2, numbers=(3, 4)):
        if fields[0] not in numbers:
            known = few_of(stations, 5)
            raise FileError(path, f"expected one of the stations {known}, got {fields[0]!r}", where=f"line {line}")
        x, y, z, *sigma = _numbers(path, line, fields[2:])
        options = {"sigma": sigma[0]} if sigma else {}
        try:
            targets.append(TargetObservation(numbers[fields[0]], fields[1], [x, y, z], **options))
        except (TypeError, ValueError) as error:
            raise FileError(path, str(error), where=f"line {line}") from None
    return targets


def read_control_points(path: FilePath) -> list[ControlPoint]:
    """Read targets with known survey coordinates, from a table.

    Args:
        path: Rows of target name, x, y, z and optionally one or three standard deviations [m], as of `read_targets`.

    Returns:
        The points in the order of the rows, for `register_stations`.

    Raises:
        FileError: The file cannot be read, or a row is invalid. Its line is named.

    Example:
        >>> import pathlib, pointloom as loom
        >>> _ = pathlib.Path("control.csv").write_text("T1;4471.5;5261.25;410\\n")
        >>> loom.registration.read_control_points("control.csv")[0].position.tolist()
        [4471.5, 5261.25, 410.0]
    """
    points = []
    for line, fields in _rows(path, words=1, numbers=(3, 4, 6)):
        x, y, z, *sigma = _numbers(path, line, fields[1:])
        options = {"sigma": sigma if len(sigma) == 3 else sigma[0]} if sigma else {}
        try:
            points.append(ControlPoint(fields[0], [x, y, z], **options))
        except (TypeError, ValueError) as error:
            raise FileError(path, str(error), where=f"line {line}") from None
    return points


def _rows(path: FilePath, words: int, numbers: tuple[int, ...]) -> Iterator[tuple[int, list[str]]]:
    """Line numbers and words of the rows of a table, without a header."""
    try:
        if input_path(path).stat().st_size > MAX_BYTES:
            raise FileError(path, f"expected a table of at most {MAX_BYTES >> 20} MiB")
        text = Path(path).read_text(encoding="utf-8-sig")
    except OSError as error:
        raise FileError(path, error.strerror or "cannot be read") from None
    except UnicodeDecodeError:
        raise FileError(path, "is not UTF-8 text", remedy="Save the table as text") from None
    is_first, empty = True, True
    for line, row in enumerate(text.splitlines(), start=1):
        if not row.strip() or row.lstrip().startswith("#"):
            continue
        check_decimal_points(path, line, row)
        fields = [field.strip() for field in (_SEPARATOR.split(row) if _SEPARATOR.search(row) else row.split())]
        while fields and not fields[-1]:
            fields.pop()
        if len(fields) - words not in numbers:
            expected = " or ".join(str(words + n) for n in numbers)
            raise FileError(path, f"expected {expected} fields, got {len(fields)}", where=f"line {line}")
        if is_first and not any(is_float(field) for field in fields[words:]):
            is_first = False
            continue
        is_first, empty = False, False
        yield line, fields
    if empty:
        raise FileError(path, "contains no rows", remedy="Write one row per target")


def _numbers(path: FilePath, line: int, fields: Sequence[str]) -> list[float]:
    for field in fields:
        if not is_float(field):
            raise FileError(path, f"expected a number, got {field!r}", where=f"line {line}")
    return [float(field) for field in fields]

"""Tables of targets and of control points: rows of text, separated by commas, semicolons, tabs or spaces.

Targets: station, name, x, y, z and, if known, a standard deviation [m]; the station is a scan's name or its number,
from 0. Control: name, x, y, z and, if known, one standard deviation or three. Lines that begin with # are left out, and
a first line whose coordinates are words is a head.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Sequence
from pathlib import Path

from ...core.errors import FileError, FilePath
from ...core.wording import few_of
from ...registration.stations.observations import ControlPoint, TargetObservation

_APART = re.compile(r"[;,\t]")
MOST_BYTES = 1 << 26  # a table of half a million points


def read_targets(path: FilePath, stations: Sequence[str]) -> list[TargetObservation]:
    """The targets that stations saw.

    Raises:
        FileError: Missing, no such table, or a station that there is not; names the line.
    """
    found = []
    numbers = {name: i for i, name in enumerate(stations)}
    numbers |= {str(i): i for i in range(len(stations)) if str(i) not in numbers}
    for line, fields in _rows(path, words=2, numbers=(3, 4)):
        if fields[0] not in numbers:
            known = few_of(stations, 5)
            raise FileError(path, f"there is no station {fields[0]!r}; there are {known}", where=f"line {line}")
        x, y, z, *sigma = _numbers(path, line, fields[2:])
        options = {"sigma": sigma[0]} if sigma else {}
        try:
            found.append(TargetObservation(numbers[fields[0]], fields[1], [x, y, z], **options))
        except (TypeError, ValueError) as error:
            raise FileError(path, str(error), where=f"line {line}") from None
    return found


def read_control(path: FilePath) -> list[ControlPoint]:
    """The control points.

    Raises:
        FileError: Missing, or no such table; names the line.
    """
    found = []
    for line, fields in _rows(path, words=1, numbers=(3, 4, 6)):
        x, y, z, *sigma = _numbers(path, line, fields[1:])
        options = {"sigma": sigma if len(sigma) == 3 else sigma[0]} if sigma else {}
        try:
            found.append(ControlPoint(fields[0], [x, y, z], **options))
        except (TypeError, ValueError) as error:
            raise FileError(path, str(error), where=f"line {line}") from None
    return found


def _rows(path: FilePath, words: int, numbers: tuple[int, ...]) -> Iterator[tuple[int, list[str]]]:
    """The lines with something on them, as so many words and numbers; without a head."""
    try:
        if Path(path).stat().st_size > MOST_BYTES:
            raise FileError(path, f"is larger than {MOST_BYTES >> 20} MiB, which no table of targets is")
        text = Path(path).read_text(encoding="utf-8-sig")
    except OSError as error:
        raise FileError(path, error.strerror or "cannot be read") from None
    except UnicodeDecodeError:
        raise FileError(path, "is no text in UTF-8", remedy="Save the table as text") from None
    is_first, empty = True, True
    for line, row in enumerate(text.splitlines(), start=1):
        if not row.strip() or row.lstrip().startswith("#"):
            continue
        fields = [field.strip() for field in (_APART.split(row) if _APART.search(row) else row.split())]
        while fields and not fields[-1]:
            fields.pop()
        if len(fields) - words not in numbers:
            expected = " or ".join(str(words + n) for n in numbers)
            raise FileError(path, f"expected {expected} fields, got {len(fields)}", where=f"line {line}")
        if is_first and not any(_is_number(field) for field in fields[words:]):
            is_first = False
            continue
        is_first, empty = False, False
        yield line, fields
    if empty:
        raise FileError(path, f"{os.fspath(path)} has no row", remedy="Give one row for each")


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True


def _numbers(path: FilePath, line: int, fields: Sequence[str]) -> list[float]:
    for field in fields:
        if not _is_number(field):
            raise FileError(path, f"expected a number, got {field!r}", where=f"line {line}")
    return [float(field) for field in fields]

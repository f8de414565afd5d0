"""Tables of observed targets and of control points: `read_targets`, `read_control_points`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ...core.checks import check_list, check_name
from ...core.errors import FileError, FilePath
from ...core.paths import path_of
from ...core.wording import few_of
from ...io.number_tables import Row, TableForm, read_number_table
from .observations import ControlPoint, TargetObservation

TARGETS = TableForm(("station name x y z", "station name x y z sigma"))
CONTROL = TableForm(("name x y z", "name x y z sigma", "name x y z sigma_x sigma_y sigma_z"))


def read_targets(path: FilePath, names: Sequence[str]) -> list[TargetObservation]:
    """Read targets that stations observed, from a table.

    Args:
        path: Rows of station, target name, x, y, z and optionally a standard deviation [m]. A station is a name or a
            number from 0. Columns are separated by commas, semicolons, tabs or spaces. A header names them in any
            order: station, name, x or easting, y or northing, z or height, sigma. Unknown columns are ignored with a
            warning. Numbers may have decimal commas if semicolons, tabs or quotes separate them. Lines with # are
            skipped.
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
    for row in read_number_table(path, TARGETS):
        station, where = row.words["station"], f"line {row.line}"
        if station not in numbers:
            known = few_of(stations, 5)
            raise FileError(path, f"expected one of the stations {known}, got {station!r}", where=where)
        try:
            targets.append(TargetObservation(numbers[station], row.words["name"], _position(row), **_sigma(row)))
        except (TypeError, ValueError) as error:
            raise FileError(path, str(error), where=where) from None
    return targets


def read_control_points(path: FilePath) -> list[ControlPoint]:
    """Read targets with known survey coordinates, from a table.

    Args:
        path: Rows of target name, x, y, z and optionally one or three standard deviations [m], as of `read_targets`. In
            a header, the three are sigma_x, sigma_y and sigma_z.

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
    for row in read_number_table(path, CONTROL):
        try:
            points.append(ControlPoint(row.words["name"], _position(row), **_sigma(row)))
        except (TypeError, ValueError) as error:
            raise FileError(path, str(error), where=f"line {row.line}") from None
    return points


def _position(row: Row) -> list[float]:
    return [row.numbers[axis] for axis in "xyz"]


def _sigma(row: Row) -> dict[str, Any]:
    values = [value for name, value in row.numbers.items() if name == "sigma"]
    values = values or [row.numbers[f"sigma_{axis}"] for axis in "xyz" if f"sigma_{axis}" in row.numbers]
    return {"sigma": values[0] if len(values) == 1 else values} if values else {}

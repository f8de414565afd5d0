"""Files of contour lines for maps: GeoPackage, GeoJSON and DXF, written by GDAL (pyogrio)."""

from __future__ import annotations

import contextlib
import importlib
import sqlite3
import struct
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..core.atomic import atomic_path, check_writable
from ..core.errors import FileError, FilePath
from ..core.paths import CONTOURS
from .line_set import LineSet

LAYER = "contours"
LINE_STRING_Z = 1002  # of well-known binary
DECIMALS = 9  # of GeoJSON's degrees: 0.1 mm
DATE = "1970-01-01T00:00:00.000Z"  # of a GeoPackage, so that files of equal lines are equal
CHANGE_COUNTERS = (24, 92)  # [B] in the header of SQLite: the counter, and that of the stored size of the file
NO_SYSTEM = 'LOCAL_CS["Undefined Cartesian SRS",UNIT["metre",1]]'


def check_contour_file(path: FilePath, *, overwrite: bool) -> tuple[Path, Any]:
    """Check that contour lines can be written, before any work. Returns the path and pyogrio. Raises FileError."""
    checked = check_writable(path, overwrite=overwrite)
    if checked.suffix.lower() not in CONTOURS:
        reason = f"unknown format of contour lines: expected {', '.join(CONTOURS)}"
        raise FileError(checked, reason, remedy="Use a file name that ends in .gpkg")
    try:
        return checked, importlib.import_module("pyogrio")
    except ImportError as error:
        reason = f"{checked.suffix.lower()} needs the package pyogrio"
        raise FileError(checked, reason, remedy='pip install "pointloom[geo]"') from error


def write_contour_file(
    path: FilePath, polylines: Sequence[NDArray[np.float64]], crs: str | None, *, overwrite: bool
) -> Path:
    """Write contours, (n, 3) each, with their height as attribute `elevation` and as z."""
    path, pyogrio = check_contour_file(path, overwrite=overwrite)
    driver = CONTOURS[path.suffix.lower()]
    fields: dict[str, NDArray[Any]] = {"elevation": np.array([line[0, 2] for line in polylines], np.float64)}
    options: dict[str, Any] = {}
    if driver == "DXF":
        fields = {"Layer": np.full(len(polylines), LAYER, object)}  # its only attribute; heights are in the lines
    elif driver == "GeoJSON" and crs is not None:
        options = {"RFC7946": "YES", "COORDINATE_PRECISION": DECIMALS}  # the standard: degrees of WGS84
    try:
        with atomic_path(path, overwrite=overwrite) as part:
            work = part.with_suffix(path.suffix)  # GDAL warns of other names
            try:
                pyogrio.raw.write(
                    str(work), np.array([_binary(line) for line in polylines], object), [*fields.values()], [*fields],
                    layer=None if driver == "DXF" else LAYER, driver=driver, geometry_type="LineString Z",
                    crs=crs or NO_SYSTEM, encoding="UTF-8", **options,
                )  # fmt: skip
                if driver == "GPKG":
                    _make_reproducible(work)
                work.replace(part)
            finally:
                work.unlink(missing_ok=True)
    except pyogrio.errors.CRSError as error:
        raise FileError(path, f"crs: {str(crs)[:80]!r} is unknown: {error}") from error
    except (pyogrio.errors.DataSourceError, pyogrio.errors.DataLayerError, OSError, RuntimeError) as error:
        if isinstance(error, FileError):
            raise
        raise FileError(path, f"cannot be written: {error}") from error
    return path


def _make_reproducible(path: Path) -> None:
    """Set the date of a GeoPackage, and the counters of its transactions, whose number in GDAL depends on time."""
    with contextlib.closing(sqlite3.connect(path)) as database, database:
        database.execute("UPDATE gpkg_contents SET last_change = ?", (DATE,))
    with path.open("r+b") as file:
        for position in CHANGE_COUNTERS:
            file.seek(position)
            file.write(struct.pack(">I", 1))


def _binary(line: NDArray[np.float64]) -> bytes:
    return struct.pack("<BII", 1, LINE_STRING_Z, len(line)) + np.ascontiguousarray(line, "<f8").tobytes()


def joined_lines(lines: LineSet) -> list[NDArray[np.float64]]:
    """Positions of polylines that contain each segment once: open ones first, then rings, whose ends are equal.

    A polyline ends at points that have not two segments.

    Example:
        >>> import pointloom as loom
        >>> [len(line) for line in joined_lines(loom.LineSet([[0, 0, 0], [1, 0, 0], [2, 0, 0]], [[1, 2], [0, 1]]))]
        [3]
    """
    segments, count = lines.lines, len(lines.points)
    at_point = np.argsort(segments.ravel(), kind="stable") // 2  # segments by point
    degrees = np.bincount(segments.ravel(), minlength=count)
    starts = np.concatenate([[0], np.cumsum(degrees)]).tolist()
    nodes = np.flatnonzero((degrees > 0) & (degrees != 2)).tolist()
    ends, near, is_through = segments.tolist(), at_point.tolist(), (degrees == 2).tolist()
    is_left = bytearray(b"\1") * len(ends)

    def walk(point: int) -> list[int]:
        chain = [point]
        while True:
            segment = next((s for s in near[starts[point] : starts[point + 1]] if is_left[s]), None)
            if segment is None:
                return chain
            is_left[segment] = 0
            a, b = ends[segment]
            point = b if a == point else a
            chain.append(point)
            if not is_through[point]:
                return chain

    chains = [walk(point) for point in nodes for _ in range(starts[point], starts[point + 1])]
    chains += [walk(a) for a, _ in ends]
    return [lines.points[chain] for chain in chains if len(chain) > 1]

"""Convert PLY, PCD, text, E57 and PTX files to LAZ for tiling.

The first pass finds common bounds and types, the second writes LAZ files with a common offset and scale. Binary PLY and
PCD and text are read in parts, E57 and PTX by scan. Text PLY, rows with lists and compressed PCD at once.
"""

from __future__ import annotations

import math
import shutil
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..core.atomic import atomic_write
from ..core.errors import FileError
from ..core.joined_parts import common_names
from ..core.progress import ReportProgress
from ..core.units import LengthUnit
from ..io.attribute_names import new_names
from ..io.optional_imports import foreign_errors
from ..io.points.by_extension import read_points
from ..io.points.e57 import SCAN_INDEX, describe_e57, read_e57
from ..io.points.formats import CLOUD_FORMATS, WITH_SCANS, WRITTEN
from ..io.points.in_parts import open_in_parts
from ..io.points.las_writer import lay_out, name_rules, open_writer, unstorable_in_las, with_scan_angle
from ..io.points.ptx import iterate_world_scans
from ..io.points.text_parts import TextInParts
from ..io.table import PointTable

_OF_TEXT = tuple(each for each in WRITTEN if CLOUD_FORMATS[each].encoding == "text")
SUFFIXES = (".ply", ".pcd", *_OF_TEXT, *WITH_SCANS)
FOLDER, MAKING = "sources", "sources.part"
ROWS_PER_PART = 1 << 18  # at a time
MAX_COORDINATE_SCALE = 1e-4  # scale of the coordinates [their unit]; finer for points within 100 units
_COORDINATE_STEPS = 2.0**30  # across all points
Parts = Callable[[], Iterator[PointTable]]


@dataclass
class CommonProperties:
    """Result of the first pass over all files. `normals` and `colors` are True if all points have them; `types` are
    those of common attributes; `names` are those of all parts; `renamed` maps names that LAS cannot store
    (attribute_names.py); `unit` is None if no file has one."""

    low: NDArray[np.float64] = field(default_factory=lambda: np.full(3, np.inf))
    high: NDArray[np.float64] = field(default_factory=lambda: np.full(3, -np.inf))
    unit: LengthUnit | None = None
    normals: bool = True
    colors: bool = True
    types: dict[str, Any] | None = None
    renamed: dict[str, str] = field(default_factory=dict)
    names: dict[str, None] = field(default_factory=dict)
    counts: list[int] = field(default_factory=list)

    def add(self, path: Path, table: PointTable, *, is_first: bool) -> None:
        """Add a part. FileError if it has a point that is not finite."""
        table = with_scan_angle(table)
        count = len(table.points)
        if is_first:
            if self.counts and _metres(self.unit) != _metres(table.unit):
                wanted, got = self.unit or "unknown", table.unit or "unknown"
                reason = f"expected the unit {wanted} as in the previous files, got {got}"
                raise FileError(
                    path, reason, remedy="Convert the files to the same unit first, it is not converted automatically"
                )
            self.unit = table.unit
            self.counts.append(0)
        beside = ~np.isfinite(table.points).all(axis=1)
        if beside.any():
            row = self.counts[-1] + int(np.flatnonzero(beside)[0])
            remedy = "Remove such points first with remove_non_finite_points()"
            raise FileError(path, "a point is not finite", where=f"point {row}", remedy=remedy)
        self.counts[-1] += count
        if not count:
            return
        self.low = np.minimum(self.low, table.points.min(axis=0))
        self.high = np.maximum(self.high, table.points.max(axis=0))
        self.names |= dict.fromkeys(table.columns())
        self.normals &= table.normals is not None
        self.colors &= table.colors is not None
        types = {name: (values.dtype, values.shape[1:]) for name, values in table.attributes.items()}
        self.renamed = _names_in_las(path, table) | self.renamed
        if self.types is None:
            self.types = types
        self.types = {
            name: (np.promote_types(known[0], types[name][0]), known[1])
            for name, known in self.types.items()
            if name in types and types[name][1] == known[1]
        }

    def shaped(self, table: PointTable) -> PointTable:
        """Part with the common attributes, in types and names that LAS supports."""
        table = with_scan_angle(table)
        attributes = {
            self.renamed.get(name, name): table.attributes[name].astype(dtype)
            for name, (dtype, _) in (self.types or {}).items()
        }
        normals, colors = (table.normals if self.normals else None), (table.colors if self.colors else None)
        return PointTable(table.points, normals, colors, attributes, unit=self.unit)

    @property
    def scale(self) -> float:
        """Scale of the coordinates, a power of ten."""
        extent = float((self.high - self.low).max())
        return (
            min(MAX_COORDINATE_SCALE, 10.0 ** math.ceil(math.log10(max(extent, 1e-9) / _COORDINATE_STEPS)))
            if extent < 1e5
            else MAX_COORDINATE_SCALE
        )

    @property
    def offset(self) -> NDArray[np.float64]:
        """Offset of the coordinates, a multiple of 100 steps."""
        hundred = 100 * self.scale
        return np.round(np.round((self.low + self.high) / 2 / hundred) * hundred, 9)


def _names_in_las(path: Path, table: PointTable) -> dict[str, str]:
    """Attributes that LAS stores under another name only. FileError without a LAS type."""
    renamed = new_names(table.attributes, name_rules(path, table))
    under = {renamed.get(name, name): values for name, values in table.attributes.items()}
    for name, reason in unstorable_in_las(path, PointTable(table.points, attributes=under)).items():
        remedy = "Change or remove it, or write the file as .laz"
        raise FileError(path, f"attribute {name!r} {reason}", remedy=remedy)
    return {name: new for name, new in renamed.items() if name in table.attributes}


def _metres(unit: LengthUnit | None) -> float | None:
    return None if unit is None else unit.meters


def is_made(path: Path) -> bool:
    """True if a path in a job's folder has the name of a converted file."""
    return path.name.split("-")[0] == FOLDER


@contextmanager
def converted_files(
    paths: list[Path], folder: Path, report: ReportProgress, name: str = FOLDER
) -> Iterator[dict[Path, Path]]:
    """Convert files to LAZ in a subfolder and yield their new paths. They are kept only if the block succeeds."""
    making = folder / MAKING
    for old in (making, folder / name):  # of an interrupted plan
        shutil.rmtree(old, ignore_errors=True)
    try:
        making.mkdir(parents=True)
        properties, files = look_at(paths, report)
        made = {}
        for number, (path, parts) in enumerate(zip(paths, files, strict=True)):
            made[path] = making / f"{number:06d}.laz"
            _write(path, parts, made[path], properties, properties.counts[number])
            report("converting", number + 1, len(paths))
        yield made
        making.rename(folder / name)
    except BaseException:
        shutil.rmtree(making, ignore_errors=True)
        raise


def look_at(paths: list[Path], report: ReportProgress) -> tuple[CommonProperties, list[Parts]]:
    """First pass: common properties, and the opened files."""
    properties, files = CommonProperties(), []
    for number, path in enumerate(paths):
        files.append(opened(path))
        for k, table in enumerate(files[-1]()):
            properties.add(path, table, is_first=not k)
        report("counting", number + 1, len(paths))
        if not properties.counts[number]:
            raise FileError(path, "contains no points")
    kept = [*(name for name in ("normals", "colors") if getattr(properties, name)), *(properties.types or {})]
    common_names(paths[0], [properties.names, kept], "scans and files")
    extent = float((properties.high - properties.low).max())
    if extent / MAX_COORDINATE_SCALE > 2**31:
        reason = f"expected an extent of at most 2^31 steps of {MAX_COORDINATE_SCALE:g}, got {extent:g} units"
        raise FileError(paths[0], reason, remedy="Remove outlying points, or write .laz with a larger scale")
    return properties, files


def opened(path: Path) -> Parts:
    """Reader of a file's points in parts, repeatable. At least one part, possibly empty."""
    suffix = path.suffix.lower()
    by_suffix = {".e57": _scans_of, ".ptx": iterate_world_scans, ".ply": _rows_of, ".pcd": _rows_of}
    return partial(by_suffix[suffix], path) if suffix in by_suffix else partial(TextInParts(path).parts, ROWS_PER_PART)


def _scans_of(path: Path) -> Iterator[PointTable]:
    for number in range(len(describe_e57(path))):
        table = read_e57(path, scan=number)
        table.attributes[SCAN_INDEX] = np.full(len(table.points), number, np.int32)
        yield table


def _rows_of(path: Path) -> Iterator[PointTable]:
    file = open_in_parts(path)
    yield from [read_points(path)] if file is None else file.parts(ROWS_PER_PART)


def _write(path: Path, parts: Parts, target: Path, properties: CommonProperties, count: int) -> None:
    written, writer, layout = 0, None, None
    with atomic_write(target) as stream, foreign_errors(target, "cannot be written"):
        try:
            for table in parts():
                if not len(table.points):
                    continue
                layout = lay_out(
                    target, properties.shaped(table), properties.scale, properties.offset, None, is_part=True
                )
                if writer is None:
                    writer = open_writer(layout.laspy, stream, layout.header, compress=True)
                for begin in range(0, len(table.points), ROWS_PER_PART):
                    writer.write_points(layout.pack(slice(begin, begin + ROWS_PER_PART)))
                written += len(table.points)
        finally:
            if writer is not None:
                writer.close()
    if written != count:
        raise FileError(path, f"expected {count} points as in the first pass, got {written}")

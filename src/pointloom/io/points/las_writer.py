"""Write LAS and LAZ: formats 6 to 8 (LAS 1.4), or 0 to 3 (LAS 1.2) for tables with `scan_angle_rank`.

Coordinates are 32-bit multiples of a scale plus an offset. Attributes go to standard dimensions if name and range fit,
else to extra dimensions (shape (n, c) as a_0 .. a_{c-1}). ASPRS, LAS Specification 1.4-R15.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.atomic import atomic_write, check_writable
from ...core.checks import check_finite, check_numeric, check_positive, check_shape
from ...core.coordinates import finite_box, quiet, warn_if_rounded
from ...core.errors import FileError, FilePath
from ...core.units import DEGREE
from ...pcd.las_attributes import with_scan_angles
from ..attribute_names import NameRules, split_columns
from ..columns import stack_colors
from ..optional_imports import foreign_errors, import_for
from ..table import PointTable
from .las import COLORS, NORMALS, layout_of
from .las_crs import WKT_BIT
from .las_extra import EXTRA_BYTES, TITLE, TYPES, ExtraColumn, record_of, store_extra
from .las_header import LasHeader
from .las_records import needs_1_4, system_record, take_over
from .las_units import units_of

# Default scale: a millimeter for meters, below what scanners measure; finer for an axis along
# which the points are within 1000 units, so that objects keep a millionth of their extent.
_COARSEST_SCALE = 0.001
# Default scale of degrees: 1 cm, as usual in LAS; finer by the same rule within 0.001 degrees (about 100 m).
_DEGREE_SCALE, _MIN_DEGREES = 1e-7, 1e-3
_STEPS_ACROSS = 1.0e6
_SAMPLE_POINTS = 1 << 16  # sample size of the extent, without 1 % at either end: robust to outliers

_POINTS_PER_BLOCK = 1 << 18  # points packed at a time
_MAX_STEPS = 2**31 - 1
_MAX_NAME_BYTES = 32
RENAMED = "_value"  # suffix for values outside the range of a LAS dimension

# Names that LAS uses with another meaning than an attribute of a cloud.
_TAKEN = {"X", "Y", "Z", *COLORS, *NORMALS, "ExtraBytes", "bit_fields", "raw_classification", "classification_flags"}

_NEW_FORMAT_ONLY = {"scan_angle", "overlap", "scanner_channel", "nir"}


def write_las(
    path: FilePath,
    table: PointTable,
    *,
    scale: ArrayLike | None = None,
    offset: ArrayLike | None = None,
    like: LasHeader | None = None,
    overwrite: bool = True,
) -> None:
    """Write points as LAS, or as LAZ if the extension is .laz, atomically.
    A `scale` of None is 0.001, or finer on axes where most points are within 1,000 units. For degrees it is 1e-7, or
    finer within 0.001 degrees. An `offset` of None is the center of the points in whole units. Records, identification,
    GPS time type and missing scale and offset are copied from `like`."""
    path = check_writable(path, overwrite=overwrite)
    layout = lay_out(path, table, scale, offset, like)
    compress = path.suffix.lower() == ".laz"
    with (
        atomic_write(path, overwrite=overwrite) as file,
        foreign_errors(path, "cannot be written"),
        quiet(),
        open_writer(layout.laspy, file, layout.header, compress=compress) as writer,
    ):
        for begin in range(0, len(layout.table.points), _POINTS_PER_BLOCK):
            writer.write_points(layout.pack(slice(begin, begin + _POINTS_PER_BLOCK)))
        if layout.extended:
            writer.write_evlrs(layout.extended)


def open_writer(laspy: ModuleType, file: Any, header: Any, *, compress: bool) -> Any:
    """laspy's writer to an open file. Attribute names may contain ":", which laspy's own way to the bytes rejects."""
    writer = laspy.LasWriter(file, header, do_compress=compress, closefd=False)
    if not compress:
        writer.point_writer.write_points = lambda points: file.write(np.ascontiguousarray(points.array).view(np.uint8))
    return writer


@dataclass(frozen=True)
class LasLayout:
    """The storage layout of a table: laspy's `header`, `extra` dimensions by name, and `extended` records."""

    laspy: Any
    table: PointTable
    header: Any
    extra: dict[str, ExtraColumn]
    extended: Any

    @quiet()
    def pack(self, part: Any) -> Any:
        """Some points (slice or indices) as laspy's record."""
        points = self.table.points[part].astype(np.float64, copy=False)
        rows: Any = np.zeros(len(points), self.header.point_format.dtype())
        record = self.laspy.PackedPointRecord(rows, self.header.point_format)
        for axis, name in enumerate("XYZ"):
            steps = np.rint((points[:, axis] - self.header.offsets[axis]) / self.header.scales[axis])
            rows[name] = np.clip(steps, -_MAX_STEPS - 1, _MAX_STEPS)  # within the rounding of the points' type
        if self.table.colors is not None:
            for axis, name in enumerate(COLORS):
                rows[name] = np.rint(self.table.colors[part, axis] * np.float32(65535))
        for name, column in self.extra.items():
            rows[name] = column.values[part]
        for dimension in self.header.point_format.standard_dimensions:
            if dimension.name in self.table.attributes and dimension.name not in _TAKEN:
                record[dimension.name][:] = self.table.attributes[dimension.name][part]
        return record


def lay_out(
    path: FilePath, table: PointTable, scale: Any, offset: Any, like: LasHeader | None, *, is_part: bool = False
) -> LasLayout:
    """The storage layout for `write_las`. Without ranges of extra dimensions if the table is a part of the points."""
    table, laspy = table.checked(), import_for(path, "laspy", "las")
    if _is_new(table):  # formats that have no whole degrees
        table = with_scan_angle(table)
    lost = unstorable_in_las(path, table)
    if lost:
        reasons = "; ".join(f"attribute {name!r} {reason}" for name, reason in lost.items())
        raise FileError(path, reasons, remedy="Change, rename or drop it, or pass drop_unsupported=True")
    if table.colors is not None:
        table.colors = stack_colors(path, [*table.colors.T])  # raises outside 0..1
    scales, offsets = _scaling(path, table, scale, offset, like)
    if table.origin is not None:
        warn_if_rounded(path, table.points, table.origin, scales, table.unit_lengths)
    system_vlr = system_record(laspy, path, table, like)
    version = "1.4" if _is_new(table) or system_vlr or (like is not None and needs_1_4(like)) else "1.2"
    header = laspy.LasHeader(point_format=_point_format(table), version=version)
    columns = _extra_columns(table, {*header.point_format.dimension_names})
    extra = store_extra(columns, None if like is None else layout_of(path, like))
    header.scales, header.offsets = scales, offsets
    if extra:
        header.add_extra_dims([laspy.ExtraBytesParams(name, column.values.dtype) for name, column in extra.items()])
        header.vlrs.extract("ExtraBytesVlr")  # laspy would write ranges of single points
        header.vlrs.append(laspy.VLR(*EXTRA_BYTES, TITLE, record_of(extra, with_ranges=not is_part)))
    extended = take_over(laspy, path, header, like) if like is not None else []
    if system_vlr:
        header.global_encoding.value |= WKT_BIT
        header.vlrs.append(system_vlr)
    return LasLayout(laspy, table, header, extra, extended)


def unstorable_in_las(path: FilePath, table: PointTable) -> dict[str, str]:
    layout = import_for(path, "laspy", "las").PointFormat(_point_format(table))
    standard = {dimension.name: dimension for dimension in layout.dimensions}
    lost, used_names = {}, {*standard, *_TAKEN}
    for name, values in table.attributes.items():
        if name in standard and name not in _TAKEN:
            reason = _why_unfit(values, standard[name])
        else:
            reason = _why_no_extra(name, values, used_names)
            used_names |= {*split_columns(name, values)}
        if reason:
            lost[name] = reason
    return lost


def name_rules(path: FilePath, table: PointTable) -> NameRules:
    """Allowed names of dimensions. Standard names only if the values fit."""
    layout = import_for(path, "laspy", "las").PointFormat(_point_format(table))
    standard = {dimension.name: dimension for dimension in layout.dimensions if dimension.name not in _TAKEN}
    standard_values = {name: values for name, values in table.attributes.items() if name in standard}
    unfit = {name: name + RENAMED for name, values in standard_values.items() if _why_unfit(values, standard[name])}
    used = {*_TAKEN, *standard} - {*standard_values} | {*unfit}
    return NameRules(str.isprintable, used, max_bytes=_MAX_NAME_BYTES, instead=unfit)


def _why_unfit(values: NDArray[Any], dimension: Any) -> str:
    if values.ndim != 1:
        return f"has {values.shape[1]} components, but LAS's dimension of that name has one"
    with np.errstate(invalid="ignore", over="ignore"):
        if dimension.name == "gps_time":
            same = values.astype(np.float64).astype(values.dtype) == values
            return "" if (same | (values != values)).all() else "does not fit into 64-bit floating point"
        fits = (values >= dimension.min) & (values <= dimension.max) & (np.trunc(values) == values)
    if fits.all():
        return ""
    return f"contains {values[~fits][0]}, but LAS stores integers {dimension.min}..{dimension.max} there"


def _why_no_extra(name: str, values: NDArray[Any], used_names: set[str]) -> str:
    if f"{values.dtype.kind}{values.dtype.itemsize}" not in TYPES:
        return f"is of type {values.dtype}, which LAS does not have"
    if values.ndim == 2 and not values.shape[1]:
        return "has no components"
    for part in split_columns(name, values):
        if part in used_names:
            return f"cannot be stored: LAS uses the name {part!r} for something else"
        if not part.isprintable() or not 0 < len(part.encode()) <= _MAX_NAME_BYTES:
            return f"cannot be named in LAS, which takes {_MAX_NAME_BYTES} bytes of printable characters"
    return ""


def _is_new(table: PointTable) -> bool:
    names, limits = table.attributes, {"return_number": 7, "number_of_returns": 7, "classification": 31}
    if "scan_angle_rank" not in names or not _NEW_FORMAT_ONLY.isdisjoint(names):
        return True
    return any(name in names and names[name].max(initial=0) > limit for name, limit in limits.items())


def _point_format(table: PointTable) -> int:
    has_colors = table.colors is not None
    if not _is_new(table):
        return ("gps_time" in table.attributes) + 2 * has_colors
    return 8 if "nir" in table.attributes else 7 if has_colors else 6


def _extra_columns(table: PointTable, standard: set[str]) -> dict[str, NDArray[Any]]:
    columns: dict[str, NDArray[Any]] = {}
    if table.normals is not None:
        columns |= dict(zip(NORMALS, table.normals.T, strict=True))
    for name, values in table.attributes.items():
        if name not in standard:
            columns |= split_columns(name, values)
    return columns


@quiet()
def _scaling(
    path: FilePath, table: PointTable, scale: Any, offset: Any, like: LasHeader | None
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Scales and offsets so that every coordinate fits into 32 bits. The offset of `like` is used if it fits.
    Degrees do not take the scale of a file in lengths."""
    points, in_degrees = table.points, table.in_degrees
    low, high = finite_box(points)
    if like is not None and not (in_degrees and units_of(like).plane not in (None, DEGREE)):
        is_near = scale is not None or fits_steps(low, high, np.array(like.scales), np.array(like.offsets))
        offset = like.offsets if offset is None and is_near else offset
        scale = like.scales if scale is None else scale
    middle = np.round(low / 2 + high / 2)
    offsets = middle if offset is None else check_finite("offset", check_shape("offset", offset, (3,)))
    if len(points) and not np.isfinite(points).all():
        row = int(np.flatnonzero(~np.isfinite(points).all(axis=1))[0])
        raise FileError(
            path, f"point {row} is not finite, which LAS cannot store", remedy="Call remove_non_finite_points() first"
        )
    extents = np.maximum(high - offsets, offsets - low)
    if scale is None:
        scale = _fitting_scales(points, extents, in_degrees)
    steps = check_numeric("scale", scale)
    scales = check_shape("scale", steps if steps.ndim else np.full(3, check_positive("scale", scale)), (3,))
    if not (np.isfinite(scales).all() and (scales > 0).all()):
        raise ValueError(f"scale: expected finite numbers > 0, got {scale}")
    slack = np.spacing(np.maximum(np.abs(low), np.abs(high)).astype(points.dtype))  # rounding of the points' type
    if not fits_steps(low + slack, high - slack, scales, offsets):
        needed = 10.0 ** math.ceil(math.log10((extents / _MAX_STEPS).max()))
        reason = f"coordinates {extents.max():.6g} from the offset take more than 2^31 steps of {scales.tolist()}"
        raise FileError(path, reason, remedy=f"Give a larger scale, such as scale={needed:g}, or a nearer offset")
    return scales, offsets


@quiet()
def fits_steps(low: Any, high: Any, scales: Any, offsets: Any) -> bool:
    first, last = (np.rint((np.asarray(end) - offsets) / np.asarray(scales)) for end in (low, high))
    return bool((first >= -(2**31)).all() and (last < 2**31).all())


def default_steps(in_degrees: bool) -> list[float]:
    """The coarsest default scale per axis."""
    return [_DEGREE_SCALE, _DEGREE_SCALE, _COARSEST_SCALE] if in_degrees else [_COARSEST_SCALE] * 3


@quiet()
def _fitting_scales(points: NDArray[Any], extents: NDArray[np.float64], in_degrees: bool) -> list[float]:
    """A power of ten per axis, not finer than 32 bits and the points' type can resolve."""
    coarsest = default_steps(in_degrees)
    if not len(points):
        return coarsest
    sample = points[:: len(points) // _SAMPLE_POINTS | 1]
    low, high = np.quantile(sample, (0.01, 0.99), axis=0)
    resolution = np.spacing(np.abs(sample).max(axis=0)).astype(np.float64)
    scales = []
    for axis in range(3):
        finest, extent = max(extents[axis] / _MAX_STEPS, resolution[axis], 1e-12), float(high[axis]) - float(low[axis])
        is_wide = in_degrees and axis < 2 and extent >= _MIN_DEGREES
        if is_wide or max(finest, extent / _STEPS_ACROSS) >= coarsest[axis]:
            scales.append(coarsest[axis])
            continue
        step = math.ceil(math.log10(finest))
        if extent > 0:
            step = max(step, math.floor(math.log10(extent / _STEPS_ACROSS)))
        scales.append(min(coarsest[axis], float(f"1e{step}")))
    return scales


def with_scan_angle(table: PointTable) -> PointTable:
    """Convert whole degrees of angle to LAS 1.4 steps."""
    return replace(table, attributes=with_scan_angles(table.attributes))

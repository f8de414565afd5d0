"""Convert between file columns and table arrays: vectors, colors, supported types."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..core.coordinates import choose_origin, quiet
from ..core.errors import FileError, FilePath
from ..core.escaped_text import escaped

# Rounding errors of colors up to this are clipped. Larger ones are errors.
COLOR_SLACK = 1e-3


@quiet()
def stack_points(columns: Sequence[NDArray[Any]], out: NDArray[Any] | None = None) -> NDArray[Any]:
    """Three columns as positions (n, 3): float32 if all are, else float64. Here and below `out` receives the result."""
    single = all(column.dtype.kind == "f" and column.dtype.itemsize == 4 for column in columns)
    return _stack(columns, np.float32 if single else np.float64, out)


def stack_normals(
    path: FilePath, columns: Sequence[NDArray[Any]], out: NDArray[Any] | None = None
) -> NDArray[np.float32]:
    """Three columns as normals, float32 (n, 3). Raises `FileError` beyond float32."""
    with quiet():
        normals = _stack(columns, np.float32, out)
    for axis, column in enumerate(columns):
        if column.dtype.itemsize > 4:
            bad = np.isinf(normals[:, axis]) & np.isfinite(column)
            if bad.any():
                raise FileError(path, "a normal is beyond the range of float32", where=f"row {np.flatnonzero(bad)[0]}")
    return normals


def stack_colors(
    path: FilePath, columns: Sequence[NDArray[Any]], out: NDArray[Any] | None = None
) -> NDArray[np.float32]:
    """Columns as colors in 0..1, float32 (n, 3 or 4).
    uint16 is divided by 65535, other integers by 255, floats are unchanged; out of range raises `FileError`."""
    kinds = {(column.dtype.kind, column.dtype.itemsize) for column in columns}
    if len(kinds) > 1:
        raise FileError(path, "the three color channels have different types")
    kind, size = kinds.pop()
    if kind == "f":
        with quiet():
            colors = _stack(columns, np.float32, out)
        _refuse_colors(path, _outside(colors), "0..1")
        return np.clip(colors, 0, 1, out=colors)
    full = 65535 if (kind, size) == ("u", 2) else 255
    if (size > 1 and full == 255) or kind == "i":
        bad = np.logical_or.reduce([(column < 0) | (column > full) for column in columns])
        _refuse_colors(path, bad, f"0..{full}")
    colors = _stack(columns, np.float32, out)
    colors /= np.float32(full)
    return colors


def colors_or_loss(
    path: FilePath,
    columns: Sequence[NDArray[Any]],
    *,
    what: str = "colors",
    stacklevel: int = 3,
    out: NDArray[Any] | None = None,
) -> NDArray[np.float32] | None:
    """Color channels of a mesh, float32 (n, 3) in 0..1, or None.
    Out-of-range colors are scaled or clamped. NaN, infinity or mixed types drop all colors. Both with a warning."""
    try:
        return stack_colors(path, columns, out)
    except FileError as error:
        if len({(column.dtype.kind, column.dtype.itemsize) for column in columns}) > 1:
            warn_of_loss(path, what, error.reason, stacklevel=stacklevel + 1)
            return None
    full = color_scale(columns)
    colors, note = fit_colors(columns, full)
    if colors is None:
        warn_of_loss(path, what, note, stacklevel=stacklevel + 1)
        return None
    if full > 1 and columns[0].dtype.kind == "f":
        note = f"they are floating-point numbers above 1 and were divided by {full}" + f"; {note}" * bool(note)
    warnings.warn(escaped(f"{path}: {what}: {note}"), UserWarning, stacklevel=stacklevel)
    return colors


def color_scale(columns: Sequence[NDArray[Any]]) -> int:
    """Maximum channel value: 65535 for uint16, 255 for other integers.
    Floats: 255 if one is above 2, or one is above 1 and all are integers. Else 1."""
    if columns[0].dtype.kind != "f":
        return 65535 if columns[0].dtype.kind == "u" and columns[0].dtype.itemsize == 2 else 255
    high = max((float(column.max()) for column in columns if len(column)), default=0.0)
    return 255 if high > 2 or (high > 1 and all(bool((np.floor(column) == column).all()) for column in columns)) else 1


def fit_colors(columns: Sequence[NDArray[Any]], full: int) -> tuple[NDArray[np.float32] | None, str]:
    """Divide channels by `full` and clamp to 0..1: float32 (n, c) and a note, or None and the reason if not finite."""
    with quiet():
        values = np.stack([column.astype(np.float64) for column in columns], axis=1) / full
    wild = ~np.isfinite(values).all(axis=1)
    if wild.any():
        return None, f"a color is NaN or infinite (row {int(np.argmax(wild))})"
    outside = ((values < -COLOR_SLACK) | (values > 1 + COLOR_SLACK)).any(axis=1)
    note = f"{int(outside.sum())} of {len(values)} are outside 0..{full} and were clamped" if outside.any() else ""
    return np.clip(values, 0, 1).astype(np.float32), note


def roles_in_lower_case(names: Sequence[str], roles: Sequence[tuple[str, ...]]) -> dict[str, str]:
    """New names of columns such as X, Y, Z that have the role of x, y, z except for their case.

    None for a role whose names are all present, and if two columns differ in their case only.
    """
    renamed: dict[str, str] = {}
    for role in roles:
        matches = [[name for name in names if name.lower() == part] for part in role]
        if not all(part in names for part in role) and all(len(match) == 1 for match in matches):
            renamed |= {match[0]: part for match, part in zip(matches, role, strict=True) if match[0] != part}
    return renamed


def warn_of_loss(path: FilePath, what: str, reason: str, *, stacklevel: int = 3) -> None:
    """Warn that content of a file is dropped, by default at the reader's caller."""
    message = f"{path}: the {what} are dropped, because {reason}"
    warnings.warn(escaped(message), UserWarning, stacklevel=stacklevel + 1)


def warn_left_out(path: FilePath, format: str, names: Sequence[str], *, stacklevel: int = 3) -> None:
    """Warn at the writer's caller of content that the format cannot store. No-op without names."""
    if names:
        others = ".ply stores everything but large 64-bit integers, float16 and booleans, which .vtp stores"
        message = f"{path}: {', '.join(names)} left out, because {format} cannot store them; {others}"
        warnings.warn(escaped(message), UserWarning, stacklevel=stacklevel + 1)


def check_extent(path: FilePath, points: NDArray[Any]) -> None:
    """Raise `FileError` if mesh vertices are too far apart for float32."""
    try:
        choose_origin(points)
    except ValueError as error:
        with quiet():
            sizes = np.where(np.isfinite(points), np.abs(points), 0).max(axis=1)
        reason = str(error).removeprefix("points: ")
        remedy = "Remove the distant vertices"
        raise FileError(path, f"vertices: {reason}", where=f"vertex {int(sizes.argmax())}", remedy=remedy) from error


def colors_to_bytes(path: FilePath, colors: NDArray[Any]) -> NDArray[np.uint8]:
    """Round colors in 0..1 to 8 bits, shape (n, 3). Raises `FileError` if out of range."""
    _refuse_colors(path, _outside(colors), "0..1")
    return np.rint(np.clip(colors, 0, 1) * np.float32(255)).astype(np.uint8)


def own(column: NDArray[Any], out: NDArray[Any] | None = None) -> NDArray[Any]:
    """A copy of a column in native byte order that does not reference the file."""
    if out is not None:
        out[...] = column
        return out
    return column.astype(column.dtype.newbyteorder("="), order="C", copy=True)


def has_type(values: NDArray[Any], allowed: str) -> bool:
    """True if a format has the type; `allowed` are NumPy type codes separated by blanks."""
    return f"{values.dtype.kind}{values.dtype.itemsize}" in allowed.split() and values.shape[1:] != (0,)


def check_types(path: FilePath, attributes: dict[str, NDArray[Any]], allowed: str, remedy: str) -> None:
    """Raise `FileError` with all attributes that a format cannot store."""
    lost = {name: values for name, values in attributes.items() if not has_type(values, allowed)}
    if lost:
        reasons = [
            f"attribute {name!r} has no components"
            if values.shape[1:] == (0,)
            else f"attribute {name!r}: the format has no type for {values.dtype}"
            for name, values in lost.items()
        ]
        raise FileError(path, "; ".join(reasons), remedy=remedy)


def narrow_attributes(attributes: dict[str, NDArray[Any]]) -> dict[str, NDArray[Any]]:
    """The attributes with 64-bit integers in smaller types where this is lossless."""
    narrow = {name: (values, narrow_integers(values)) for name, values in attributes.items()}
    return {name: values if narrowed is None else narrowed for name, (values, narrowed) in narrow.items()}


def narrow_integers(values: NDArray[Any]) -> NDArray[Any] | None:
    """64-bit integers as 32 bits or float64 if lossless, else None. Other values unchanged."""
    if values.dtype.kind not in "iu" or values.dtype.itemsize < 8:
        return values
    low, high = (int(values.min()), int(values.max())) if len(values) else (0, 0)
    for kind in (np.int32, np.uint32):
        if np.iinfo(kind).min <= low and high <= np.iinfo(kind).max:
            return values.astype(kind)
    return values.astype(np.float64) if low >= -(2**53) and high <= 2**53 else None


def check_name(path: FilePath, name: str) -> None:
    if not name or not name.isascii() or not name.isprintable() or " " in name:
        raise FileError(
            path, f"attribute {name!r} cannot be named in this format", remedy="Use printable ASCII without blanks"
        )


def _outside(colors: NDArray[Any]) -> NDArray[np.bool_]:
    """Mask (n,) of rows with a channel that is NaN or outside 0..1."""
    with np.errstate(invalid="ignore"):
        inside = (colors >= -COLOR_SLACK) & (colors <= 1 + COLOR_SLACK)
    return np.logical_or.reduce(~inside.T)


def _refuse_colors(path: FilePath, bad: NDArray[np.bool_], span: str) -> None:
    if bad.any():
        raise FileError(
            path,
            f"a color is outside {span}",
            where=f"row {int(np.flatnonzero(bad)[0])}",
            remedy=f"Colors are {span} in every channel",
        )


def _stack(columns: Sequence[NDArray[Any]], dtype: Any, out: NDArray[Any] | None) -> NDArray[Any]:
    """Stack columns. Columns that are already adjacent in the file are copied in one pass."""
    rows = np.empty((len(columns[0]), len(columns)), dtype) if out is None else out
    first = columns[0]
    step = first.dtype.itemsize
    addresses = [column.__array_interface__["data"][0] for column in columns]
    beside = all(
        column.dtype == first.dtype and column.strides == first.strides and address == addresses[0] + k * step
        for k, (column, address) in enumerate(zip(columns, addresses, strict=True))
    )
    if beside and len(first):
        shape, strides = rows.shape, (*first.strides, step)
        rows[...] = np.lib.stride_tricks.as_strided(first, shape, strides, writeable=False)
    else:
        for k, column in enumerate(columns):
            rows[:, k] = column
    return rows

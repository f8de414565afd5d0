"""Read and write clouds as NumPy tables by extension."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from ...core.errors import FileError, FilePath
from ...core.escaped_text import escaped
from ...core.units import warn_of_units
from ..attribute_names import rename
from ..table import PointTable
from .codecs import WriteOptions
from .formats import CLOUD_FORMATS, WITH_NAMED_COLUMNS, WRITTEN
from .text_table import check_columns

COLOR_SAMPLES = 4096  # whose bits are examined
COLOR_ROUNDING = 1.2e-7  # of float32 colors, two roundings


def columns_of(paths: Sequence[FilePath], columns: Sequence[str] | None) -> list[Sequence[str] | None]:
    """The column names for each file: `columns` if its format supports them, else None. Raises if none does."""
    takes = [Path(path).suffix.lower() in WITH_NAMED_COLUMNS for path in paths]
    if columns is not None and not any(takes):
        raise _columns_error(", ".join(dict.fromkeys(Path(path).suffix for path in paths)))
    return [columns if is_taken else None for is_taken in takes]


def read_points(path: FilePath, columns: Sequence[str] | None = None) -> PointTable:
    suffix = Path(path).suffix.lower()
    if suffix in CLOUD_FORMATS and columns is None:
        return CLOUD_FORMATS[suffix].codec.read(path)
    if suffix not in WITH_NAMED_COLUMNS or columns is None:
        raise _columns_error(Path(path).suffix)
    codec = CLOUD_FORMATS[suffix].codec
    return (codec.read_columns or codec.read)(path, check_columns(columns))


def _columns_error(suffixes: str) -> ValueError:
    return ValueError(f"columns: only {', '.join(WITH_NAMED_COLUMNS)} take them, got {escaped(suffixes)}")


def write_table(path: FilePath, table: PointTable, options: WriteOptions) -> None:
    """Write a table by extension (one of WRITTEN), renaming attributes with a warning (attribute_names.py)."""
    suffix = Path(path).suffix.lower()
    codec = CLOUD_FORMATS[suffix].codec
    if codec.write is None:
        raise FileError(path, f"clouds are not written to {suffix}", remedy=f"Use one of {' '.join(WRITTEN)}")
    if options.drop_unsupported and codec.storable is not None:
        table, _ = codec.storable(path, table)
    table = _with_fitting_names(path, table)
    _warn_of_rounded_colors(path, table)
    codec.write(path, table, options)


def _warn_of_rounded_colors(path: FilePath, table: PointTable) -> None:
    """Warn if colors of 16 bits, as of LAS and E57, are written with 8. Others, such as means, are rounded anyway."""
    suffix = Path(path).suffix.lower()
    if table.colors is None or not CLOUD_FORMATS[suffix].has_8_bit_colors:
        return
    colors = table.colors[:: max(1, len(table.colors) // COLOR_SAMPLES)].astype(np.float64)
    off8, off16 = (np.abs(colors * most - np.rint(colors * most)) / most for most in (2**8 - 1, 2**16 - 1))
    if off8.max(initial=0) > COLOR_ROUNDING and off16.max(initial=0) <= COLOR_ROUNDING:
        reason = f"colors of 16 bits a channel are rounded to the 8 bits of {suffix}; .laz and .npz keep 16"
        warn_of_units(f"{path}: {reason}", UserWarning)


def _with_fitting_names(path: FilePath, table: PointTable) -> PointTable:
    """The table with attribute names that the format supports. Warns of changes."""
    format = CLOUD_FORMATS[Path(path).suffix.lower()]
    if format.codec.name_rules is None:
        return table
    rules = format.codec.name_rules(path, table)
    return replace(table, attributes=rename(path, format.name, table.attributes, rules, stacklevel=4))

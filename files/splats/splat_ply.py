"""Splats in PLY files, as the training code of Kerbl et al. 2023 and all that follow it write them.

Vertices have x y z, f_dc_0..2, opacity (a logit), scale_0..2 (logarithms), rot_0..3 (w, x, y, z), and 9, 24, 45 or 72
numbers f_rest_i: all coefficients of red, then of green, then of blue. Normals, which are zeros, are left behind.
Compressed splats are read by compressed_ply.py.
"""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.errors import FileError
from ...pcd.harmonics import degree_of
from ..columns import own, stack_points
from ..points.ply import vertex_columns
from ..points.ply_header import read_header
from ..source import open_source
from ..table import PointTable
from .compressed_ply import is_compressed, read_compressed_ply

_GROUPS = {"f_dc": 3, "scale": 3, "rot": 4}
_NUMBERED = re.compile(r"(f_dc|f_rest|scale|rot)_(\d+)")
_KNOWN = {"x", "y", "z", "nx", "ny", "nz"}


def read_splat_ply(path: str | os.PathLike[str]) -> PointTable:
    """Read splats as columns `f_dc`, `f_rest`, `opacity`, `scale`, `rot`, and further ones by their names.

    Raises:
        FileError: As `read_ply`; also columns that are missing, or of another number than splats have.
    """
    path = Path(path)
    source = open_source(path)
    header = read_header(path, source)
    if is_compressed(header):
        return read_compressed_ply(path, source, header)
    columns = vertex_columns(path, source)
    missing = [name for name in ("x", "y", "z", "opacity", "f_dc_0", "scale_0", "rot_0") if name not in columns]
    if missing:
        reason = f"holds no Gaussian splats: vertices have no {', '.join(missing)}"
        raise FileError(path, reason, remedy="read_point_cloud reads points")
    counts: dict[str, int] = {}
    for name in columns:
        if found := _NUMBERED.fullmatch(name):
            counts[found[1]] = counts.get(found[1], 0) + 1
    for group, count in _GROUPS.items():
        if counts[group] != count:
            flat = "; splats of 2D Gaussian Splatting have 2" if (group, counts[group]) == ("scale", 2) else ""
            raise FileError(path, f"expected {count} columns {group}_i, found {counts[group]}{flat}")
    rest = counts.get("f_rest", 0)
    if rest % 3 or degree_of(rest // 3 + 1) is None:
        raise FileError(path, f"expected 0, 9, 24, 45 or 72 columns f_rest_i, found {rest}")
    attributes = {group: _stacked(path, columns, group, count) for group, count in (_GROUPS | {"f_rest": rest}).items()}
    attributes["opacity"] = own(columns["opacity"]).astype(np.float32)
    if not rest:
        del attributes["f_rest"]
    for name, column in columns.items():
        if name not in _KNOWN | {"opacity"} and not _NUMBERED.fullmatch(name):
            attributes[name] = own(column)
    return PointTable(stack_points([columns[axis] for axis in "xyz"]), attributes=attributes)


def _stacked(path: Path, columns: dict[str, NDArray[Any]], group: str, count: int) -> NDArray[np.float32]:
    names = [f"{group}_{i}" for i in range(count)]
    for name in names:
        if name not in columns:
            raise FileError(path, f"vertices have no {name}, but {count} columns {group}_i")
    out = np.empty((len(columns["x"]), count), np.float32)
    for i, name in enumerate(names):
        out[:, i] = columns[name]
    return out

"""3D Gaussian splats from and to files, by extension."""

from __future__ import annotations

import os
import warnings
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.errors import FileError
from ...core.escaped_text import escaped
from ...core.paths import path_of
from ...pcd.splats import GaussianSplats
from ..points.point_cloud import cloud_of, table_of, write_point_cloud
from ..source import netted
from ..table import PointTable
from .splat_ply import read_splat_ply
from .splat_rows import read_splat, write_splat
from .spz import read_spz
from .spz_writer import write_spz

_READERS = {".ply": netted(read_splat_ply), ".splat": netted(read_splat), ".spz": netted(read_spz)}

EXTENSIONS = tuple(_READERS)


def read_splats(path: str | os.PathLike[str], *, drop_invalid: bool = False, device: Any = None) -> GaussianSplats:
    """Read 3D Gaussian splats: .ply as training or SuperSplat (compressed) writes it, .splat, .spz of versions 2 to 4.

    Numbers are taken as the file has them; nothing is filled in, sorted or scaled. Further columns of a PLY file become
    attributes of `splats.cloud`.

    Coordinates are those of PLY files (right, down, forward by custom). SPZ is right, up, back by its specification, so
    its y and z are turned round, with rotations and harmonics. (Open3D writes and reads SPZ without turning.)

    Args:
        path: The file.
        drop_invalid: Whether splats that are not finite or have a rotation of no length are left out, with a warning
            that counts them.
        device: Where the splats go.

    Raises:
        FileError: The file cannot be read, or is no splats; a splat has a NaN or an infinite number (which one, how
            many) and `drop_invalid` is not set; version 4 of SPZ without `pip install "pointloom[splats]"`.
        DeviceError: No such device.

    Notes:
        Memory: the file is mapped (SPZ: decompressed) and its columns are copied once: about twice the result.
        Source: Kerbl et al. 2023 and their PLY; antimatter15/splat; nianticlabs/spz.

    Example:
        >>> import pointloom as loom
        >>> splats = loom.GaussianSplats([[0, 0, 1]], [[0.1, 0.1, 0.01]], [[1, 0, 0, 0]], [0.9], [[1, 0, 0]])
        >>> loom.write_splats("one.ply", splats)
        >>> loom.read_splats("one.ply").centers.tolist()
        [[0.0, 0.0, 1.0]]
    """
    table = _READERS[_extension(path)](path)
    table = _only_sound(path, table, drop_invalid)
    return GaussianSplats.from_cloud(cloud_of(table, path, device=device))


def write_splats(path: str | os.PathLike[str], splats: GaussianSplats, *, overwrite: bool = True) -> None:
    """Write 3D Gaussian splats, whole or not at all; the extension gives the format.

    .ply holds everything, bit for bit (coordinates of a moved origin as doubles). .splat holds 32 B a splat: float32
    centres and scales, 8 bits for colours, opacities and each part of a quaternion, no harmonics beyond the first. .spz
    (version 3, gzip) holds about 9 to 25 B: centres in 24 bits, scales in steps of 6 %, harmonics in 4 or 5 bits.

    Args:
        path: The file: .ply .splat .spz.
        splats: The splats.
        overwrite: Whether an existing file may be replaced.

    Raises:
        FileError: The file cannot be made; splats so far out that the format would round their centres by more than
            2 mm; splats that are not finite.
        TypeError: No splats.

    Warns:
        UserWarning: Harmonics or attributes that the format has no place for.

    Example:
        >>> import pointloom as loom
        >>> splats = loom.GaussianSplats([[0, 0, 1]], [[0.1, 0.1, 0.01]], [[1, 0, 0, 0]], [0.9], [[1, 0, 0]])
        >>> loom.write_splats("one.spz", splats)
        >>> loom.read_splats("one.spz")
        GaussianSplats(1 splats of degree 0, cpu)
    """
    extension = _extension(path)
    if not isinstance(splats, GaussianSplats):
        raise TypeError(f"splats: expected GaussianSplats, got {type(splats).__name__}")
    if extension == ".ply":
        write_point_cloud(path, splats.cloud, overwrite=overwrite)
        return
    table = _only_sound(path, table_of(splats.cloud), False)
    (write_splat if extension == ".splat" else write_spz)(path, table, overwrite=overwrite)


def _extension(path: str | os.PathLike[str]) -> str:
    extension = path_of(path).suffix.lower()
    if extension not in _READERS:
        remedy = f"Splats are {', '.join(EXTENSIONS)}"
        raise FileError(path, f"unknown format {Path(path).suffix or 'without extension'}", remedy=remedy)
    return extension


def _only_sound(path: Any, table: PointTable, drop: bool) -> PointTable:
    """The table without splats that cannot be drawn; refused where there are such and they are not to be dropped."""
    sound = sound_rows(table)
    count = len(sound) - int(np.count_nonzero(sound))
    if not count:
        return table
    first = int(np.argmin(sound))
    told = f"{count:,} of {len(sound):,} splats have a NaN, an infinite number or a rotation of no length"
    if not drop:
        raise FileError(path, told, where=f"splat {first}", remedy="drop_invalid=True of read_splats leaves them out")
    warnings.warn(escaped(f"{path}: {told}, the first is splat {first}; they are left out"), UserWarning, stacklevel=3)
    attributes = {name: values[sound] for name, values in table.attributes.items()}
    return PointTable(table.points[sound], attributes=attributes)


def sound_rows(table: PointTable) -> NDArray[np.bool_]:
    """Which splats can be drawn. An opacity of 0 or 1 is an infinite logit, a flat axis an infinite logarithm."""
    columns = table.attributes
    sound = np.isfinite(table.points).all(axis=1)
    for name in ("f_dc", "f_rest"):
        if name in columns:
            sound &= np.isfinite(columns[name]).all(axis=1)
    sound &= ~np.isnan(columns["opacity"])
    sound &= (columns["scale"] <= np.finfo(np.float32).max).all(axis=1)  # not of NaN
    with np.errstate(over="ignore", invalid="ignore"):
        length = np.square(columns["rot"]).sum(axis=1)
    return sound & (length > 0) & np.isfinite(length)

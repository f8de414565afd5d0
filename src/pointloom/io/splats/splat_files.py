"""Read and write 3D Gaussian splats. The extension selects the format."""

from __future__ import annotations

import warnings
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ...core.array_libraries import library_for
from ...core.devices import DeviceLike
from ...core.errors import FileError, FilePath
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


def read_splats(
    path: FilePath, *, drop_invalid: bool = False, device: DeviceLike = None, arrays: str | None = None
) -> GaussianSplats:
    """Read 3D Gaussian splats: .ply (from training or SuperSplat, compressed), .splat, .spz versions 2 to 4.

    Values are unchanged. Other PLY columns become attributes of `splats.cloud`. Coordinates are those of PLY files
    (right, down, forward by convention). SPZ is right, up, back, so its y and z axes are flipped, with rotations and
    harmonics (Open3D does not).

    Args:
        path: The file.
        drop_invalid: Drop splats that are not finite or have a zero rotation, with a warning.
        device: Device of the splats.
        arrays: Library of returned arrays, as of `PointCloud`. If None: "numpy".

    Raises:
        FileError: Unreadable, no splats, non-finite splats without `drop_invalid`, or SPZ version 4 without `pip
            install "pointloom[splats]"`.
        DeviceError: No such device.

    Notes:
        Memory: about twice the result. Kerbl et al., "3D Gaussian splatting for real-time radiance field rendering",
        SIGGRAPH 2023; antimatter15/splat; nianticlabs/spz.

    Example:
        >>> import pointloom as loom
        >>> splats = loom.GaussianSplats([[0, 0, 1]], [[0.1, 0.1, 0.01]], [[1, 0, 0, 0]], [0.9], [[1, 0, 0]])
        >>> loom.write_splats("one.ply", splats)
        >>> loom.read_splats("one.ply").centers.tolist()
        [[0.0, 0.0, 1.0]]
    """
    library = library_for(arrays)
    table = _READERS[_extension(path)](path)
    table = _only_sound(path, table, drop_invalid)
    return GaussianSplats.from_cloud(cloud_of(table, path, device=device, arrays=library))


def write_splats(path: FilePath, splats: GaussianSplats, *, overwrite: bool = True) -> None:
    """Write 3D Gaussian splats atomically. The extension selects the format.

    .ply is lossless (with a moved origin, coordinates are doubles). .splat has 32 B per splat: float32 centers and
    scales, 8 bits for colors, opacities and quaternions, no higher harmonics. .spz (version 3, gzip) has about 9 to 25
    B: 24-bit centers, scales in steps of 6 %, harmonics in 4 or 5 bits.

    Args:
        path: The file: .ply .splat .spz.
        splats: The splats.
        overwrite: Replace an existing file.

    Raises:
        FileError: The file cannot be written, centers would be rounded by more than 2 mm, or splats are not finite.
        TypeError: No splats.

    Warns:
        UserWarning: Harmonics or attributes that the format cannot store.

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


def _extension(path: FilePath) -> str:
    extension = path_of(path).suffix.lower()
    if extension not in _READERS:
        remedy = f"Splats are {', '.join(EXTENSIONS)}"
        raise FileError(path, f"unknown format {Path(path).suffix or 'without extension'}", remedy=remedy)
    return extension


def _only_sound(path: FilePath, table: PointTable, drop: bool) -> PointTable:
    sound = sound_rows(table)
    count = len(sound) - int(np.count_nonzero(sound))
    if not count:
        return table
    first = int(np.argmin(sound))
    problem = f"{count:,} of {len(sound):,} splats have a NaN, an infinite number or a rotation of zero length"
    if not drop:
        raise FileError(
            path, problem, where=f"splat {first}", remedy="Pass drop_invalid=True to read_splats to leave them out"
        )
    warnings.warn(
        escaped(f"{path}: {problem}, the first is splat {first}; they are left out"), UserWarning, stacklevel=3
    )
    attributes = {name: values[sound] for name, values in table.attributes.items()}
    return PointTable(table.points[sound], attributes=attributes)


def sound_rows(table: PointTable) -> NDArray[np.bool_]:
    """Mask of valid splats. Infinite logits (opacity 0 or 1) and log scales of flat axes are valid."""
    columns = table.attributes
    sound = np.isfinite(table.points).all(axis=1)
    for name in ("f_dc", "f_rest"):
        if name in columns:
            sound &= np.isfinite(columns[name]).all(axis=1)
    sound &= ~np.isnan(columns["opacity"])
    sound &= (columns["scale"] <= np.finfo(np.float32).max).all(axis=1)  # false for NaN
    with np.errstate(over="ignore", invalid="ignore"):
        length = np.square(columns["rot"]).sum(axis=1)
    return sound & (length > 0) & np.isfinite(length)

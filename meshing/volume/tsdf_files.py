"""Files of TSDF volumes: NPZ archives whose arrays are checked against each other before one is used.

Members: format, sizes (voxel size, truncation), origin, frame_count, has_color (room for colour, colours given), keys
int64 [m], distances float32 [512 m], weights uint16 [512 m], and colors uint16 [512 m, 3] where frames had colour.
"""

from __future__ import annotations

import os
import zipfile
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from ...core.atomic import atomic_write
from ...core.errors import FileError
from ...core.paths import path_of
from ...files.points.npz import read_member
from ...kernels.arrays.block_keys import BIAS
from ...kernels.volumes.tsdf_blocks import BLOCK_VOXELS, MAX_BLOCKS, block_box

FORMAT = b"pointloom TSDF volume 1"
VOXEL_ARRAYS = ("keys", "distances", "weights", "colors")


def write_volume_arrays(path: str | os.PathLike[str], arrays: dict[str, NDArray[Any]], *, overwrite: bool) -> None:
    """Write the arrays of a volume, whole or not at all."""
    members: dict[str, Any] = {"format": np.frombuffer(FORMAT, np.uint8)} | arrays
    with atomic_write(path, overwrite=overwrite) as file:
        np.savez_compressed(file, **members)


def _read_members(path: str | os.PathLike[str]) -> dict[str, NDArray[Any]]:
    """The arrays of an NPZ archive, none of which is allocated before its sizes are known to be true."""
    try:
        arrays = {}
        with path_of(path).open("rb") as file, zipfile.ZipFile(file) as archive:
            if min((info.header_offset for info in archive.infolist()), default=0) or not _ends_archive(file):
                raise FileError(path, "bytes stand before or behind the archive", remedy="Copy the file again")
            for info in archive.infolist():
                name = info.filename.removesuffix(".npy")
                if name in arrays:
                    raise FileError(path, f"member {name!r} is there twice")
                arrays[name] = read_member(path, archive, info, name)
        return arrays
    except FileError:
        raise
    except FileNotFoundError as error:
        raise FileError(path, "no such file") from error
    except MemoryError as error:
        raise MemoryError(f"{path}: the memory does not hold the volume") from error
    except Exception as error:  # zipfile raises some ten types on damaged archives, not all of them documented
        raise FileError(path, f"cannot be read as a volume: {error}", remedy="The file may be truncated") from error


def _ends_archive(file: IO[bytes]) -> bool:
    """Whether the last bytes are the record that ends a ZIP archive without a comment, which NumPy never writes."""
    file.seek(-22, os.SEEK_END)
    return file.read(4) == b"PK\5\6"


def read_volume_arrays(path: str | os.PathLike[str]) -> dict[str, NDArray[Any]]:
    """The arrays of a saved volume, checked against each other."""
    arrays = _read_members(path)
    if arrays.get("format", np.zeros(0)).tobytes() != FORMAT:
        raise FileError(path, f"is no {FORMAT.decode()} file", remedy="Write one with TSDFVolume.save")
    blocks = len(arrays["keys"]) if "keys" in arrays and arrays["keys"].ndim else 0
    voxels = blocks * BLOCK_VOXELS
    expected: dict[str, tuple[Any, tuple[int, ...]]] = {
        "format": (np.uint8, (len(FORMAT),)),
        "sizes": (np.float64, (2,)),
        "origin": (np.float64, (3,)),
        "frame_count": (np.int64, ()),
        "has_color": (np.bool_, (2,)),
        "keys": (np.int64, (blocks,)),
        "distances": (np.float32, (voxels,)),
        "weights": (np.uint16, (voxels,)),
    }
    if "has_color" in arrays and arrays["has_color"].all():
        expected["colors"] = (np.uint16, (voxels, 3))
    if arrays.keys() != expected.keys():
        missing, extra = sorted(expected.keys() - arrays.keys()), sorted(arrays.keys() - expected.keys())
        raise FileError(path, f"lacks {', '.join(missing)}" if missing else f"holds unknown arrays {', '.join(extra)}")
    for name, (dtype, shape) in expected.items():
        found = arrays[name]
        if found.dtype != dtype or found.shape != shape:
            got = f"{found.dtype} {list(found.shape)}"
            raise FileError(path, f"{name}: expected {np.dtype(dtype)} {list(shape)}, got {got}")
    reason = _find_fault(arrays, blocks)
    if reason:
        raise FileError(path, reason, remedy="The file was changed after it was saved")
    return arrays


def _find_fault(arrays: dict[str, NDArray[Any]], blocks: int) -> str:
    """What no saved volume holds, or nothing."""
    voxel_size, truncation = arrays["sizes"].tolist()
    has_color, colored = arrays["has_color"].tolist()
    frames = int(arrays["frame_count"])
    if not (0 < voxel_size <= truncation < np.inf):
        return f"sizes: expected 0 < voxel size <= truncation, got {voxel_size} and {truncation}"
    if not np.isfinite(arrays["origin"]).all():
        return "origin: not finite"
    if frames < 0 or (frames == 0 and (blocks or colored or arrays["origin"].any())):
        return f"frame_count: {frames}"
    if colored and not has_color:
        return "has_color: colours without room for them"
    if blocks > MAX_BLOCKS:
        return f"keys: {blocks:,} blocks, more than {MAX_BLOCKS:,}"
    keys = arrays["keys"]
    if blocks and (keys.min() < 0 or np.abs(block_box(keys)).max() > BIAS - 2 or len(np.unique(keys)) != blocks):
        return "keys: blocks out of range or repeated"
    if not (np.abs(arrays["distances"]) <= 1).all():
        return "distances: not all in -1..1"
    if arrays["weights"].max(initial=0) > frames:
        return f"weights: more than {frames} frames"
    return ""

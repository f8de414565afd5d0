"""Files of OpenVDB: sparse grids of numbers in blocks of 8^3 voxels.

A tree of depth 4: a root, nodes of 32^3 and 16^3 children, and leaves, which are the blocks. Nodes say by masks which
children there are, leaves which voxels are active; the numbers of active voxels alone are kept, as float32, not packed.
Source: OpenVDB's io/Archive.cc, io/Compression.h and tree/*.h, file version 224.
"""

from __future__ import annotations

import hashlib
import os
import struct
import uuid
from collections.abc import Iterator, Sequence
from typing import IO, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...core.atomic import atomic_write

MAGIC, FILE_VERSION, LIBRARY = 0x56444220, 224, (10, 0)
ACTIVE_MASK = 2  # of the flags of compression: inactive voxels are left out
SIDE, VOXELS = 8, 512  # of a block, which is a leaf: voxel (x, y, z) at (x * 8 + y) * 8 + z
_ROOT, _UPPER, _LOWER = 9, 5, 4  # bits of a block's coordinates below a root's child; of those, each node's
_ALL_BACKGROUND = b"\0"  # what inactive values are


class VdbGrid(NamedTuple):
    """A grid of a .vdb file.

    Attributes:
        name: As programs list it.
        blocks: Whole numbers [m, 3], none twice, within 2^28.
        values: float32 [m, 512], or [m, 512, 3] of vectors.
        active: bool [m, 512]: the voxels that hold one.
        background: What all others are.
        place: Where voxel (0, 0, 0) has its value [m], float64 [3].
        voxel_size: [m].
        kind: "level set", "fog volume" or "unknown".
    """

    name: str
    blocks: NDArray[Any]
    values: NDArray[Any]
    active: NDArray[np.bool_]
    background: float
    place: NDArray[np.float64]
    voxel_size: float
    kind: str = "unknown"


def write_vdb_grids(path: str | os.PathLike[str], grids: Sequence[VdbGrid], *, overwrite: bool) -> None:
    """Write grids, whole or not at all; the same bytes of the same grids.

    Raises:
        FileError: The place cannot be written, or the file exists and may not be replaced.
    """
    ordered = [_in_order(grid) for grid in grids]
    with atomic_write(path, overwrite=overwrite) as file:
        file.write(struct.pack("<qIII?", MAGIC, FILE_VERSION, *LIBRARY, True) + _name_of(ordered))
        file.write(_metadata({"creator": _string("pointloom")}) + struct.pack("<i", len(ordered)))
        for grid in ordered:
            _write_grid(file, grid)


def _in_order(grid: VdbGrid) -> VdbGrid:
    """Blocks with an active voxel, in the order of the tree."""
    kept = np.flatnonzero(grid.active.any(axis=1))
    blocks = np.asarray(grid.blocks, np.int64)[kept]
    upper, lower = _places(blocks)
    order = np.lexsort((lower, upper, *(blocks >> _ROOT).T[::-1]))
    dense = np.ascontiguousarray(grid.values[kept[order]], np.float32)
    return grid._replace(blocks=blocks[order], values=dense, active=grid.active[kept[order]])


def _places(blocks: NDArray[np.int64]) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Where blocks stand in the upper node, and in the lower one."""
    found = []
    for shift, bits in ((_LOWER, _UPPER), (0, _LOWER)):
        x, y, z = ((blocks >> shift) & ((1 << bits) - 1)).T
        found.append((x << 2 * bits) | (y << bits) | z)
    return found[0], found[1]


def _write_grid(file: IO[bytes], grid: VdbGrid) -> None:
    form = "vec3s" if grid.values.ndim == 3 else "float"
    file.write(_text(grid.name) + _text(f"Tree_{form}_5_4_3") + _text(""))
    offsets = file.tell()
    file.write(bytes(24))
    places = [file.tell()]
    file.write(struct.pack("<I", ACTIVE_MASK) + _metadata(_told_of(grid)) + _transform(grid))
    width = 3 if form == "vec3s" else 1
    file.write(struct.pack("<i", 1) + struct.pack("<f", grid.background) * width)
    bits = np.packbits(grid.active, axis=1, bitorder="little")
    for piece in _topology(grid.blocks, bits):
        file.write(piece)
    places.append(file.tell())
    for mask, chosen, values in zip(bits, grid.active, grid.values, strict=True):
        file.write(mask.tobytes() + _ALL_BACKGROUND + values[chosen].astype("<f4").tobytes())
    places.append(file.tell())
    file.seek(offsets)
    file.write(struct.pack("<qqq", *places))
    file.seek(places[-1])


def _topology(blocks: NDArray[np.int64], bits: NDArray[np.uint8]) -> Iterator[bytes]:
    """The root, then each node with its children behind it, down to the masks of leaves."""
    roots = _runs(blocks >> _ROOT)
    yield struct.pack("<II", 0, len(roots))
    upper, lower = _places(blocks)
    for first, last in roots:
        yield ((blocks[first] >> _ROOT << _ROOT) * SIDE).astype("<i4").tobytes()
        nodes = _runs(upper[first:last, None])
        yield _node([upper[first + begin] for begin, _ in nodes], _UPPER)
        for begin, end in nodes:
            rows = slice(first + begin, first + end)
            yield _node(lower[rows], _LOWER)
            yield bits[rows].tobytes()


def _runs(rows: NDArray[np.int64]) -> list[tuple[int, int]]:
    """Where runs of equal rows begin and end."""
    if not len(rows):
        return []
    cuts = np.flatnonzero((rows[1:] != rows[:-1]).any(axis=1)) + 1
    return list(zip([0, *cuts.tolist()], [*cuts.tolist(), len(rows)], strict=True))


def _node(children: Any, bits: int) -> bytes:
    """A node without values of its own: which children there are, that no value is active, and what the rest are."""
    mask = np.zeros(1 << 3 * bits, np.uint8)
    mask[np.asarray(children)] = 1
    return np.packbits(mask, bitorder="little").tobytes() + bytes(len(mask) // 8) + _ALL_BACKGROUND


def _told_of(grid: VdbGrid) -> dict[str, tuple[str, bytes]]:
    """What a grid says of itself."""
    told = {"class": _string(grid.kind), "name": _string(grid.name), "is_saved_as_half_float": ("bool", b"\0")}
    told["file_voxel_count"] = ("int64", struct.pack("<q", int(grid.active.sum())))
    if len(grid.blocks):
        voxels = np.stack(np.unravel_index(np.arange(VOXELS), (SIDE,) * 3), axis=1)
        at, within = np.nonzero(grid.active)
        active = grid.blocks[at] * SIDE + voxels[within]
        told["file_bbox_min"] = ("vec3i", active.min(axis=0).astype("<i4").tobytes())
        told["file_bbox_max"] = ("vec3i", active.max(axis=0).astype("<i4").tobytes())
    return told


def _transform(grid: VdbGrid) -> bytes:
    """From voxels to metres."""
    size = grid.voxel_size
    scales = [size, size, 1 / size, 1 / size**2, 0.5 / size]
    numbers = [*grid.place.tolist(), *(scale for scale in scales for _ in range(3))]
    return _text("UniformScaleTranslateMap") + struct.pack("<18d", *numbers)


def _name_of(grids: Sequence[VdbGrid]) -> bytes:
    """A UUID of what a file holds."""
    digest = hashlib.sha256()
    for grid in grids:
        digest.update(repr((grid.name, grid.kind, grid.background, grid.place.tolist(), grid.voxel_size)).encode())
        for array in (grid.blocks, grid.active, grid.values):
            digest.update(np.ascontiguousarray(array).tobytes())
    return str(uuid.UUID(bytes=digest.digest()[:16], version=4)).encode()


def _metadata(told: dict[str, tuple[str, bytes]]) -> bytes:
    """Values with their names and types."""
    items = (_text(name) + _text(kind) + struct.pack("<I", len(value)) + value for name, (kind, value) in told.items())
    return struct.pack("<i", len(told)) + b"".join(items)


def _string(text: str) -> tuple[str, bytes]:
    return "string", text.encode()


def _text(text: str) -> bytes:
    data = text.encode()
    return struct.pack("<I", len(data)) + data

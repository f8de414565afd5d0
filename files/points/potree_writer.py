"""Writing Potree 2.0: the nodes of an octree in one file, what they are in two more, as Potree's viewer streams them.

Positions are the whole steps of the LAS files, each further dimension is an attribute in its own type under Potree's
name, the flags of LAS 1.4 as the one byte that they share. Encoding DEFAULT: nothing is packed.

Source: Schütz et al. 2020, "Fast Out-of-Core Octree Generation for Massive Point Clouds"; PotreeConverter 2's files.
"""

from __future__ import annotations

import json
import math
import struct
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...kernels.sampling.detail_levels import NODE_BITS
from .las import COLORS, LasFile

MARKER = "metadata.json"
_ENTRY = struct.Struct("<BBIQQ")
_INNER, _LEAF, _PROXY = 0, 1, 2
_STEP = 4  # levels of a part of the hierarchy
_NAMES = {
    "return_number": "return number",
    "number_of_returns": "number of returns",
    "classification_flags": "classification flags",
    "scan_angle": "scan angle",
    "user_data": "user data",
    "point_source_id": "point source id",
    "gps_time": "gps-time",
}
_BY_BITS = ("return_number", "number_of_returns")  # of one byte of a row
_TYPES = {"i": "int", "u": "uint", "f": "float"}
Key = tuple[int, int, int, int]


class PotreeWriter:
    """Nodes of an octree to a folder, in any order.

    Args:
        folder: An empty folder.
        file: A file with the rows' layout, scale and offset.
        corner: Low corner of the octree's cube.
        side: Of that cube.
        name: Of the cloud.
        projection: Of its coordinates, as text that pyproj and proj4js read; empty where none is known.
    """

    def __init__(
        self, folder: Path, file: LasFile, corner: NDArray[np.float64], side: float, name: str, projection: str
    ):
        import laspy

        self._folder, self._file, self._corner, self._side = folder, file, corner, side
        self._told, self._record = {"name": name, "projection": projection}, laspy.PackedPointRecord
        dimensions = {dimension.name: dimension for dimension in file.layout.dimensions}
        self._columns: list[tuple[str, list[str], np.dtype[Any]]] = []
        for field in file.layout.dtype().names:
            names = [*_BY_BITS] if field == "bit_fields" else [] if field in ("X", "Y", "Z", *COLORS) else [field]
            for each in names:
                scaled = each in dimensions and not dimensions[each].is_standard and dimensions[each].is_scaled
                one = file.layout.dtype()[field]
                self._columns.append((_NAMES.get(each, each), [each], np.dtype("<f8") if scaled else one))
        if COLORS[0] in file.layout.dtype().names:
            self._columns.append(("rgb", [*COLORS], np.dtype(("<u2", (3,)))))
        self._row = np.dtype([("position", "<i4", (3,)), *((name, kind) for name, _, kind in self._columns)])
        self._lows: dict[str, NDArray[np.float64]] = {}
        self._highs: dict[str, NDArray[np.float64]] = {}
        self._nodes: dict[Key, tuple[int, int, int]] = {}  # points, first byte, bytes
        self._points = (folder / "octree.bin").open("wb")

    def add(self, level: int, cell: tuple[int, int, int], rows: NDArray[Any]) -> None:
        """Add a node."""
        record, out = self._record(rows, self._file.layout), np.empty(len(rows), self._row)
        for axis, name in enumerate("XYZ"):
            out["position"][:, axis] = rows[name]
        for name, fields, _ in self._columns:
            if len(fields) > 1:
                out[name] = np.column_stack([rows[field] for field in fields])
            else:
                out[name] = np.asarray(record[fields[0]]) if fields[0] in _BY_BITS else rows[fields[0]]
                out[name] = self._unscaled(fields[0], out[name])
        for name in self._row.names or ():
            values = out[name].reshape(len(out), -1)
            low, high = (end.reduce(values).astype(np.float64) for end in (np.fmin, np.fmax))  # of what is not NaN
            if name in self._lows:
                low, high = np.fmin(self._lows[name], low), np.fmax(self._highs[name], high)
            self._lows[name], self._highs[name] = low, high
        self._nodes[(level, *cell)] = (len(rows), self._points.tell(), out.nbytes)
        self._points.write(out.tobytes())

    def _unscaled(self, name: str, values: NDArray[Any]) -> NDArray[Any]:
        for dimension in self._file.layout.extra_dimensions:
            if dimension.name == name and dimension.is_scaled:
                return values * dimension.scales + dimension.offsets
        return values

    def close(self) -> None:
        """Close the file of points."""
        self._points.close()

    def finish(self) -> None:
        """Write the hierarchy and what the cloud is."""
        self.close()
        nodes = self._nodes
        masks: dict[Key, int] = {}
        for level, x, y, z in nodes:
            masks.setdefault((level, x, y, z), 0)
            while level:
                bit = 1 << ((x & 1) << 2 | (y & 1) << 1 | (z & 1))
                level, x, y, z = level - 1, x >> 1, y >> 1, z >> 1
                known = masks.get((level, x, y, z), 0)
                masks[(level, x, y, z)] = known | bit
                if known & bit:
                    break
        parts, first_size = _hierarchy(nodes, masks)
        (self._folder / "hierarchy.bin").write_bytes(parts)
        header = self._file.header
        low, high = self._corner.tolist(), (self._corner + self._side).tolist()
        told = {
            "version": "2.0",
            "description": "",
            **self._told,
            "points": sum(count for count, _, _ in nodes.values()),
            "hierarchy": {
                "firstChunkSize": first_size,
                "stepSize": _STEP,
                "depth": max(level for level, *_ in nodes) + 1,
            },
            "offset": [*header.offsets],
            "scale": [*header.scales],
            "spacing": self._side / 2**NODE_BITS,
            "boundingBox": {"min": low, "max": high},
            "encoding": "DEFAULT",
            "attributes": [self._attribute(name) for name in self._row.names or ()],
        }
        (self._folder / MARKER).write_text(json.dumps(told, indent=1, allow_nan=False))

    def _attribute(self, name: str) -> dict[str, Any]:
        kind, shape = self._row[name].base, self._row[name].shape
        count = math.prod(shape) if shape else 1
        type_name = {"f4": "float", "f8": "double"}.get(kind.str[1:], f"{_TYPES[kind.kind]}{8 * kind.itemsize}")
        low, high = self._lows[name], self._highs[name]
        if name == "position":
            scales, offsets = np.array(self._file.header.scales), np.array(self._file.header.offsets)
            low, high = low * scales + offsets, high * scales + offsets
        return {
            "name": name,
            "description": "",
            "size": count * kind.itemsize,
            "numElements": count,
            "elementSize": kind.itemsize,
            "type": type_name,
            "min": np.nan_to_num(low).tolist(),
            "max": np.nan_to_num(high).tolist(),
        }


def _hierarchy(nodes: dict[Key, tuple[int, int, int]], masks: dict[Key, int]) -> tuple[bytes, int]:
    """All parts, each breadth first below its node, and the bytes of the first one."""
    parts: list[list[Key]] = []
    roots = [(0, 0, 0, 0)]
    proxies: dict[Key, int] = {}
    for root in roots:  # grows
        part, at = [root], 0
        while at < len(part):
            key = part[at]
            at += 1
            if key[0] == root[0] + _STEP and masks[key]:
                proxies[key] = len(roots)
                roots.append(key)
                continue
            part += [_child(key, octant) for octant in range(8) if masks[key] >> octant & 1]
        parts.append(part)
    begins = np.concatenate([[0], np.cumsum([len(part) for part in parts])]) * _ENTRY.size
    out = bytearray()
    for number, part in enumerate(parts):
        for place, key in enumerate(part):
            count, begin, size = nodes.get(key, (0, 0, 0))
            if key in proxies and place:
                below = proxies[key]
                out += _ENTRY.pack(_PROXY, masks[key], count, int(begins[below]), len(parts[below]) * _ENTRY.size)
            else:
                out += _ENTRY.pack(_INNER if masks[key] else _LEAF, masks[key], count, begin, size)
        assert len(out) == begins[number + 1]
    return bytes(out), len(parts[0]) * _ENTRY.size


def _child(key: Key, octant: int) -> Key:
    level, x, y, z = key
    return level + 1, x * 2 + (octant >> 2 & 1), y * 2 + (octant >> 1 & 1), z * 2 + (octant & 1)

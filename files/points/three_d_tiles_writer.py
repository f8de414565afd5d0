"""Writing 3D Tiles 1.1: each node of an octree as points in a GLB file, the tree as JSON.

Where the coordinate system is known each point is brought to the globe by itself, so that neither the curve of the
Earth nor the scale of the map shows; elsewhere points keep their coordinates. Positions are float32 about the middle of
their node, which stands in the GLB as a translation, with y up as glTF wants it. Colors are the upper 8 bits of those
of LAS, converted from sRGB to linear light of 16 bits, since glTF stores linear light and 8 bits of it would merge dark
colors. Intensity and classification are the attributes _INTENSITY and _CLASSIFICATION. A node adds to the coarser ones
(refine: ADD); what is drawn without the finer ones is off by the spacing of its level. Large trees are JSON files of
some levels each.

Source: OGC 22-025r4, "3D Tiles Specification 1.1"; Khronos, "glTF 2.0 Specification".
"""

from __future__ import annotations

import json
import struct
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...kernels.sampling.detail_levels import NODE_BITS
from ..color_space import srgb_to_linear
from .geodetic import Geodesy
from .las import COLORS, LasFile
from .las_units import units_of

MARKER = "tileset.json"
_POINTS = 0
_TYPES = {np.dtype(np.float32): 5126, np.dtype(np.uint16): 5123}
_LINEAR = np.rint(srgb_to_linear(np.arange(256) / 255) * 65535).astype(np.uint16)  # of each 8-bit channel
_ARRAY_BUFFER = 34962
_STEP = 5  # levels of one JSON file
_MOST = 4096  # nodes that are one JSON file whatever their levels
_VALUES = {"_INTENSITY": "intensity", "_CLASSIFICATION": "classification"}
Key = tuple[int, int, int, int]
Box = tuple[NDArray[np.float64], NDArray[np.float64]]


class ThreeDTilesWriter:
    """Nodes of an octree to a folder, in any order.

    Args:
        folder: An empty folder.
        file: A file with the rows' layout, scale, offset and coordinate system.
        side: Of the octree's cube.

    Raises:
        FileError: The coordinate system cannot be read, or pyproj is missing.
    """

    def __init__(self, folder: Path, file: LasFile, side: float):
        import laspy

        self._folder, self._file, self._record = folder, file, laspy.PackedPointRecord
        self._globe = Geodesy(file.path, file.header)
        unit = units_of(file.header).plane
        metres = unit.metres if unit is not None and unit.metres else 1.0
        self._spacing = side / 2**NODE_BITS * (metres if self._globe.system is not None else 1.0)
        if self._globe.system is not None and self._globe.system.is_geographic:
            self._spacing *= 111_320.0  # metres a degree of latitude
        self._boxes: dict[Key, Box] = {}

    def add(self, level: int, cell: tuple[int, int, int], rows: NDArray[Any]) -> None:
        """Add a node."""
        scales, offsets = self._file.header.scales, self._file.header.offsets
        points = np.column_stack([rows[name] * scales[k] + offsets[k] for k, name in enumerate("XYZ")])
        if self._globe.system is not None:
            points = self._globe.to_geocentric(points)
        low, high = points.min(axis=0), points.max(axis=0)
        middle = np.round((low + high) / 2)
        # the stored float32 decide what the box must hold
        near = (points - middle).astype(np.float32)
        self._boxes[(level, *cell)] = near.min(axis=0) + middle, near.max(axis=0) + middle
        record = self._record(rows, self._file.layout)
        columns = {"POSITION": np.column_stack([near[:, 0], near[:, 2], -near[:, 1]])}
        if COLORS[0] in (rows.dtype.names or ()):
            colors = [_LINEAR[rows[name] >> 8] for name in COLORS]
            columns["COLOR_0"] = np.column_stack([*colors, np.full(len(rows), 65535, np.uint16)])
        columns |= {name: np.asarray(record[field], np.float32) for name, field in _VALUES.items()}
        x, y, z = middle.tolist()
        (self._folder / f"{_name((level, *cell))}.glb").write_bytes(_glb(columns, [x, z, -y]))

    def close(self) -> None:
        """Nothing is open."""

    def finish(self) -> None:
        """Write the tree."""
        boxes, children = dict(self._boxes), {}
        for key in sorted(self._boxes, reverse=True):
            low, high = boxes[key]
            level, x, y, z = key
            while level:
                above = (level - 1, x >> 1, y >> 1, z >> 1)
                children.setdefault(above, set()).add((level, x, y, z))
                if above in boxes:
                    low, high = np.minimum(low, boxes[above][0]), np.maximum(high, boxes[above][1])
                boxes[above] = low, high
                level, x, y, z = above
        for root in [(0, 0, 0, 0), *(key for key in children if self._is_apart(key))]:
            name = MARKER if not root[0] else f"{_name(root)}.json"
            told = {
                "asset": {"version": "1.1", "generator": "pointloom"},
                "geometricError": self._error(root[0] - 1),
                "root": self._tile(root, root, boxes, children),
            }
            (self._folder / name).write_text(json.dumps(told, allow_nan=False))

    def _is_apart(self, key: Key) -> bool:
        return len(self._boxes) > _MOST and key[0] > 0 and key[0] % _STEP == 0

    def _error(self, level: int) -> float:
        return self._spacing / 2.0**level

    def _tile(self, key: Key, root: Key, boxes: dict[Key, Box], children: dict[Key, set[Key]]) -> dict[str, Any]:
        low, high = boxes[key]
        half = np.maximum((high - low) / 2, 1e-6) * (1 + 1e-9)
        volume = [*((low + high) / 2).tolist(), half[0], 0, 0, 0, half[1], 0, 0, 0, half[2]]
        tile: dict[str, Any] = {
            "boundingVolume": {"box": [float(value) for value in volume]},
            "geometricError": self._error(key[0]) if key in children else 0.0,
        }
        if key != root and key in children and self._is_apart(key):
            tile["content"] = {"uri": f"{_name(key)}.json"}
            return tile
        if key == root:
            tile["refine"] = "ADD"
        if key in self._boxes:
            tile["content"] = {"uri": f"{_name(key)}.glb"}
        if key in children:
            tile["children"] = [self._tile(child, root, boxes, children) for child in sorted(children[key])]
        return tile


def _name(key: Key) -> str:
    return "-".join(map(str, key))


def _glb(columns: dict[str, NDArray[Any]], translation: list[float]) -> bytes:
    """Points as one binary glTF; each value takes whole groups of four bytes."""
    views, accessors, attributes, data = [], [], {}, b""
    for name, values in columns.items():
        width = values.shape[1] if values.ndim > 1 else 1
        accessor: dict[str, Any] = {
            "bufferView": len(views),
            "componentType": _TYPES[values.dtype],
            "count": len(values),
            "type": "SCALAR" if width == 1 else f"VEC{width}",
        }
        if name == "POSITION":
            accessor |= {"min": values.min(axis=0).tolist(), "max": values.max(axis=0).tolist()}
        if name == "COLOR_0":
            accessor["normalized"] = True
        attributes[name] = len(accessors)
        accessors.append(accessor)
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": values.nbytes, "target": _ARRAY_BUFFER})
        data += values.tobytes()
    told = {
        "asset": {"version": "2.0", "generator": "pointloom"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "translation": translation}],
        "meshes": [{"primitives": [{"attributes": attributes, "mode": _POINTS}]}],
        "buffers": [{"byteLength": len(data)}],
        "bufferViews": views,
        "accessors": accessors,
    }
    text = json.dumps(told, allow_nan=False).encode()
    text += b" " * (-len(text) % 4)
    head = struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(data))
    return head + struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN\0") + data

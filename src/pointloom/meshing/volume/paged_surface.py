"""Surface of a paged volume, cube by cube, bitwise as from one volume in memory.

Needs one layer of blocks around a cube. Vertices and triangles are sorted by block and position in the block.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...kernels.lru_cache import LruCache
from ...kernels.memory import download
from ...kernels.volumes.block_rows import SeenBlocks
from ...kernels.volumes.block_surface import EDGES_PER_BLOCK, BlockSurface
from ...kernels.volumes.tsdf_blocks import BLOCK_ROWS, block_box, box_keys
from .page_files import cubes_of
from .paged_blocks import PagedBlocks, blocks_of

Rows = NDArray[np.int64]
_CUBE_OFFSETS = np.array([[x, y, z] for x in (-1, 0, 1) for y in (-1, 0, 1) for z in (-1, 0, 1)])


class CubeSurface(NamedTuple):
    """Surface in a cube; `edges` (n,) and `owners` (t,) are the sort keys of vertices and triangles, int64."""

    vertices: NDArray[np.float32]
    colors: NDArray[np.float32] | None
    normals: NDArray[np.float32] | None
    edges: Rows
    triangles: NDArray[np.int32]
    owners: Rows


class CubeReader:
    """Surface of each cube of an unchanged volume; `as_points` gives points with normals instead of triangles."""

    def __init__(self, volume: PagedBlocks, threshold: float, *, as_points: bool):
        self._volume, self._threshold, self._as_points = volume, threshold, as_points
        self._here = volume.arrays()
        self._cubes_here = cubes_of(self._here["keys"], volume.side)
        self._pages: LruCache[dict[str, NDArray[Any]]] = LruCache(volume.max_blocks)
        self._all = set(volume.cubes)

    def __iter__(self) -> Iterator[CubeSurface]:
        for cube in self._volume.cubes:
            yield self._surface_of(cube)

    def _surface_of(self, cube: int) -> CubeSurface:
        volume = self._volume
        low = block_box(np.array([cube]))[0] * volume.side
        high = low + volume.side
        arrays = self._around(cube, low, high)
        surface = BlockSurface(
            SeenBlocks(blocks_of(arrays, volume.blocks), self._threshold),
            not self._as_points,
            None if self._as_points else (low, high),
        )
        positions, shades, slopes = surface.vertices(volume.has_frame_colors, self._as_points)
        keys, at = (download(array) for array in surface.vertex_edges())
        order = np.argsort(arrays["keys"])
        ranks = arrays["ranks"][order[np.searchsorted(arrays["keys"], keys, sorter=order)]]
        attributes = [None if rows is None else download(rows).reshape(-1, 3) for rows in (shades, slopes)]
        vertices, edges = download(positions).reshape(-1, 3), ranks * EDGES_PER_BLOCK + at
        if self._as_points:
            is_own = cubes_of(keys, volume.side) == cube
            attributes, none = (
                [None if rows is None else rows[is_own] for rows in attributes],
                np.zeros((0, 3), np.int32),
            )
            return CubeSurface(
                vertices[is_own], attributes[0], attributes[1], edges[is_own], none, np.zeros(0, np.int64)
            )
        firsts = download(surface.offsets)[surface.rows :][::BLOCK_ROWS]
        owners = np.repeat(arrays["ranks"], np.diff(firsts))
        triangles = download(surface.triangles()).reshape(-1, 3)
        return CubeSurface(vertices, attributes[0], attributes[1], edges, triangles, owners)

    def _around(self, cube: int, low: Rows, high: Rows) -> dict[str, NDArray[Any]]:
        """Blocks of a cube and the layer around it, in insertion order."""
        first = low - 1 if self._as_points else low
        parts = []
        for beside in _CUBE_OFFSETS if self._as_points else _CUBE_OFFSETS[(_CUBE_OFFSETS >= 0).all(axis=1)]:
            x, y, z = low // self._volume.side + beside
            key = int(box_keys(x, y, z))
            if key not in self._all:
                continue
            arrays = self._blocks_of(key)
            blocks = block_box(arrays["keys"])
            rows = np.flatnonzero(((blocks >= first) & (blocks <= high)).all(axis=1))
            parts.append({name: values[rows] for name, values in arrays.items()})
        together = {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}
        order = np.argsort(together["ranks"])
        return {name: values[order] for name, values in together.items()}

    def _blocks_of(self, cube: int) -> dict[str, NDArray[Any]]:
        if not self._volume.is_away(cube):
            rows = np.flatnonzero(self._cubes_here == cube)
            return {name: values[rows] for name, values in self._here.items()}
        page = self._pages.find(cube)
        if page is None:
            page = self._volume.page(cube)
            self._pages.put(cube, page, len(page["keys"]))
        return page


def joined(surfaces: Iterator[CubeSurface]) -> CubeSurface:
    """Merge the surfaces, each vertex once, in the order of one volume in memory."""
    parts = list(surfaces)
    if not parts:
        none = np.zeros((0, 3), np.float32)
        return CubeSurface(none, none, none, np.zeros(0, np.int64), none.astype(np.int32), np.zeros(0, np.int64))
    edges, first, numbers = np.unique(
        np.concatenate([part.edges for part in parts]), return_index=True, return_inverse=True
    )
    starts = np.cumsum([0, *(len(part.edges) for part in parts)])[:-1]
    triangles = np.concatenate([part.triangles + start for part, start in zip(parts, starts, strict=True)])
    owners = np.concatenate([part.owners for part in parts])
    order = np.argsort(owners, kind="stable")
    triangles = numbers.reshape(-1)[triangles[order]].astype(np.int32)

    def rows(name: str) -> Any:
        if getattr(parts[0], name) is None:
            return None
        return np.concatenate([getattr(part, name) for part in parts])[first]

    return CubeSurface(rows("vertices"), rows("colors"), rows("normals"), edges, triangles, owners[order])

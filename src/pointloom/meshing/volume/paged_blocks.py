"""Device-resident blocks of a paged volume, and the exchange of cubes with the disk."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...kernels.array_types import AnyArray
from ...kernels.lang import int64
from ...kernels.memory import download, upload
from ...kernels.volumes.scan_rays import ScanRays, passed_blocks
from ...kernels.volumes.tsdf_blocks import BLOCK_VOXELS, block_box
from ...kernels.volumes.voxel_blocks import VoxelBlocks
from .page_files import Keys, Page, PageFolder, Saved, cubes_of
from .tsdf import FrameState, TSDFVolume

FREED_DIVISOR = 4  # a quarter of `max_blocks` is freed at once, so that not each frame pages


@dataclass
class _PagingState:
    """State of the resident blocks, replaced as a unit so that interruptions are safe. The first blocks have the
    numbers `ranks` in insertion order, later ones count from `total`, the volume's blocks then. `away` are cubes only
    on disk, `clean` those unchanged since their page, `index` the blocks of `away`."""

    blocks: VoxelBlocks
    ranks: Keys
    total: int
    away: dict[int, Page]
    clean: dict[int, Page]
    index: VoxelBlocks | None = field(default=None)


class PagedBlocks(TSDFVolume):
    """A TSDFVolume with up to `max_blocks` on the device and unneeded cubes on disk. Cubes are loaded completely before
    a frame is integrated. The least recently used leave, into a new page if changed."""

    _state: _PagingState

    def __init__(self, folder: PageFolder, side: int, max_blocks: int, **sizes: Any):
        self.folder, self.side, self.max_blocks = folder, side, max_blocks
        self._last_access: dict[int, int] = {}
        self._access_count = 0
        super().__init__(**sizes)

    def adopt(self, saved: Saved) -> None:
        """Load a saved state. All of it is on disk."""
        count = int(saved.header["frame_count"])
        self._frames = FrameState(count, saved.header["origin"] if count else None, bool(saved.header["has_color"][1]))
        total = sum(len(page.keys) for page in saved.pages.values())
        self._state = _PagingState(self._state.blocks, np.zeros(0, np.int64), total, dict(saved.pages), {})

    def _keep(self, blocks: VoxelBlocks) -> None:
        self._device_frames = None
        self._state = _PagingState(blocks, np.zeros(0, np.int64), 0, {}, {})

    @property
    def blocks(self) -> VoxelBlocks:  # type: ignore[override]
        return self._state.blocks

    @property
    def total(self) -> int:
        return self._state.blocks.count + sum(len(page.keys) for page in self._state.away.values())

    @property
    def cubes(self) -> list[int]:
        return sorted({*self._state.away, *np.unique(self._cubes_here()).tolist()})

    def arrays(self) -> dict[str, NDArray[Any]]:
        state = self._state
        count = state.blocks.count
        new = state.total + np.arange(count - len(state.ranks))
        result: dict[str, NDArray[Any]] = {
            "keys": self._keys_here(),
            "ranks": np.concatenate([state.ranks, new]),
            "distances": download(state.blocks.distances)[: count * BLOCK_VOXELS].reshape(count, BLOCK_VOXELS),
            "weights": download(state.blocks.weights)[: count * BLOCK_VOXELS].reshape(count, BLOCK_VOXELS),
        }
        if self.has_color and self._frames.colored:
            colors = download(state.blocks.colors)[: count * BLOCK_VOXELS]
            result["colors"] = colors.reshape(count, BLOCK_VOXELS, 3)
        return result

    def all_arrays(self) -> dict[str, NDArray[Any]]:
        """All blocks in insertion order."""
        parts = [self.arrays(), *map(self.page, self._state.away)]
        together = {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}
        return _rows(together, np.argsort(together["ranks"]))

    def bring_box(self, low: NDArray[Any], high: NDArray[Any]) -> None:
        """Load all blocks in a box. ValueError if there are more than `max_blocks`."""
        keys = np.concatenate([self._keys_here(), *(page.keys for page in self._state.away.values())])
        blocks = block_box(keys)
        inside = ((blocks >= low) & (blocks <= high)).all(axis=1)
        self.bring(keys[inside], changing=False, what="the view", remedy="increase max_blocks or reduce depth_max")

    def page(self, cube: int) -> dict[str, NDArray[Any]]:
        return self._read(self._state.away[cube])

    def _read(self, page: Page) -> dict[str, NDArray[Any]]:
        return self.folder.read(page, has_colors=self.has_color and self._frames.colored)

    def is_away(self, cube: int) -> bool:
        return cube in self._state.away

    def save_pages(self) -> None:
        arrays, state = self.arrays(), self._state
        cubes = cubes_of(arrays["keys"], self.side)
        for cube in np.unique(cubes).tolist():
            if cube not in state.clean:
                state.clean[cube] = self.folder.write(_rows(arrays, np.flatnonzero(cubes == cube)))
        header = {
            "sizes": np.array([self.voxel_size, self.truncation]),
            "origin": self.origin,
            "frame_count": np.array(self.frame_count),
            "has_color": np.array([self.has_color, self._current_frames.colored]),
        }
        self.folder.save(header, self.side, state.away | state.clean)

    def bring(self, keys: Keys, *, changing: bool, what: str, remedy: str) -> None:
        """Load the cubes of blocks and, if `changing`, reserve room for new ones. ValueError above `max_blocks`."""
        state, here = self._state, self._keys_here()
        wanted = np.unique(cubes_of(keys, self.side))
        coming = [cube for cube in wanted.tolist() if cube in state.away]
        inside = np.isin(cubes_of(here, self.side), wanted)
        known = [here[inside], *(state.away[cube].keys for cube in coming)]
        needed = sum(map(len, known))
        if changing:
            needed += int((~np.isin(keys, np.concatenate(known))).sum())
        if needed > self.max_blocks:
            reason = f"{what} needs {needed:,} blocks at once, more than max_blocks, {self.max_blocks:,}"
            raise ValueError(f"{reason}; {remedy}")
        self._access_count += 1
        self._last_access |= dict.fromkeys(wanted.tolist(), self._access_count)
        others = len(here) - int(inside.sum())
        if coming or needed + others > self.max_blocks:
            self._exchange(coming, self._leaving(wanted, needed))
        if changing:
            for cube in wanted.tolist():
                self._state.clean.pop(cube, None)
            room = self._state.blocks
            if needed + others > room.keys.size and 2 * room.keys.size > self.max_blocks:
                room.make_room(self.max_blocks)

    def _leaving(self, wanted: Keys, needed: int) -> list[int]:
        """Least recently used cubes that must leave."""
        cubes, counts = np.unique(self._cubes_here(), return_counts=True)
        others = {c: n for c, n in zip(cubes.tolist(), counts.tolist(), strict=True) if c not in set(wanted.tolist())}
        left, leaving = sum(others.values()), []
        if needed + left <= self.max_blocks:
            return []
        for cube in sorted(others, key=lambda cube: (self._last_access.get(cube, 0), cube)):
            if needed + left <= self.max_blocks - self.max_blocks // FREED_DIVISOR:
                break
            leaving.append(cube)
            left -= others[cube]
        return leaving

    def _exchange(self, coming: list[int], leaving: list[int]) -> None:
        """Rebuild the device blocks with other cubes."""
        arrays, state = self.arrays(), self._state
        cubes, away, clean = cubes_of(arrays["keys"], self.side), dict(state.away), dict(state.clean)
        total = state.total + len(cubes) - len(state.ranks)
        for cube in leaving:
            page = clean.pop(cube, None)
            away[cube] = page or self.folder.write(_rows(arrays, np.flatnonzero(cubes == cube)))
        parts = [_rows(arrays, np.flatnonzero(~np.isin(cubes, leaving)))]
        for cube in coming:
            clean[cube] = away.pop(cube)
            parts.append(self._read(clean[cube]))
        together = {name: np.concatenate([part[name] for part in parts]) for name in arrays}
        blocks = blocks_of(together, self._state.blocks, self.max_blocks)
        self._state = _PagingState(blocks, together["ranks"], total, away, clean)
        if self._next is not None:
            self._next = (blocks.frame_count + 1, self._next[1])

    def _keys_here(self) -> Keys:
        blocks = self._state.blocks
        return np.array(download(blocks.keys)[: blocks.count])

    def _cubes_here(self) -> Keys:
        return cubes_of(self._keys_here(), self.side)

    def _filter_keys(self, keys: AnyArray) -> Any:
        if keys.size:
            remedy = "increase max_blocks, reduce depth_max, or use larger voxels"
            self.bring(np.array(download(keys)), changing=True, what="the frame", remedy=remedy)  # sync
        return keys

    def _fold_scan(self, rays: ScanRays, carve: bool) -> int:
        state = self._state
        if carve and rays.points.size and state.away:
            if state.index is None:
                known = np.sort(np.concatenate([page.keys for page in state.away.values()]))
                state.index = state.blocks.without_voxels(upload(known, int64, self.device))
            passed = [np.array(download(passed_blocks(rays, blocks))) for blocks in (state.blocks, state.index)]
            remedy = "increase max_blocks, set max_range, or use carve=False"
            self.bring(np.concatenate(passed), changing=False, what="the space that rays cross", remedy=remedy)
        return super()._fold_scan(rays, carve)


def blocks_of(arrays: dict[str, NDArray[Any]], like: VoxelBlocks, room: int = 0) -> VoxelBlocks:
    """Device blocks from arrays with one row per block, with spare room."""
    blocks = VoxelBlocks(like.voxel_size, like.truncation, like.has_color, like.device)
    blocks.make_room(room)
    blocks.fill({name: _flat(name, values) for name, values in arrays.items() if name != "ranks"})
    return blocks


def _flat(name: str, values: NDArray[Any]) -> NDArray[Any]:
    shape = (-1, 3) if name == "colors" else (-1,)
    return np.ascontiguousarray(values).reshape(shape)


def _rows(arrays: dict[str, NDArray[Any]], rows: NDArray[np.int64]) -> dict[str, NDArray[Any]]:
    return {name: values[rows] for name, values in arrays.items()}

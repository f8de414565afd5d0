"""Folder of a paged volume: immutable pages, and the list of the saved ones.

A page is an NPZ archive of one cube's blocks; `volume.npz`, replaced atomically, lists the pages of the last save.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...core.atomic import atomic_write
from ...core.errors import FileError, FilePath
from ...core.paths import is_file
from ...core.work_folder import RunFolder
from ...io.points.archives import Arrays, Expected, has_format, read_archive, rows_of, write_archive
from ...kernels.arrays.block_keys import CELL_BIAS
from ...kernels.volumes.tsdf_blocks import BLOCK_VOXELS, block_box, box_keys
from .tsdf_files import find_fault_of_sizes

LIST = "volume.npz"
FORMAT, PAGE_FORMAT = b"pointloom paged TSDF volume 1", b"pointloom TSDF page 1"
_PAGE_NAME = re.compile(r"[0-9]{8,18}\.npz")
MAX_SIDE = 1024  # blocks along a cube

Keys = NDArray[np.int64]


class Page(NamedTuple):
    """A page on disk: number of its file, and keys of its blocks."""

    number: int
    keys: Keys


class Saved(NamedTuple):
    """Content of a list: arrays of the volume, blocks along a cube, pages by cube."""

    header: Arrays
    side: int
    pages: dict[int, Page]


def cubes_of(keys: Keys, side: int) -> Keys:
    """Cube of each block, as a key."""
    x, y, z = np.floor_divide(block_box(keys), side).T
    return box_keys(x, y, z)


class PageFolder:
    """Pages of a volume on disk, for one process. FileError if the folder contains other data or is in use."""

    def __init__(self, path: FilePath, *, is_new: bool, overwrite: bool = False):
        remedy = "Continue with PagedTSDFVolume.load, or pass overwrite=True to start over"
        self._run = RunFolder(path, LIST, partial(has_format, form=FORMAT), name="path", remedy=remedy)
        self.path = self._run.path
        if is_new:
            self._run.check(resume=False, overwrite=overwrite)
        elif not is_file(self.path / LIST):
            raise FileError(path, f"contains no paged volume: {LIST} is missing")
        self._run.hold(self)
        self._last = max(self._numbers(), default=0)

    def close(self) -> None:
        self._run.release()

    def _numbers(self) -> list[int]:
        """Numbers of the files that have the name of a page."""
        return [int(file.stem) for file in self.path.iterdir() if _PAGE_NAME.fullmatch(file.name)]

    def _path_of(self, number: int) -> Path:
        return self._run.file(f"{number:08d}.npz")

    def write(self, arrays: Mapping[str, NDArray[Any]]) -> Page:
        number = self._last + 1
        with atomic_write(self._path_of(number), overwrite=False) as file:
            np.savez(file, format=np.frombuffer(PAGE_FORMAT, np.uint8), **arrays)  # type: ignore[arg-type]
        self._last = number
        return Page(number, np.array(arrays["keys"]))

    def read(self, page: Page, *, has_colors: bool) -> Arrays:
        """Arrays of a page. FileError if missing, damaged or of another volume."""
        path = self._path_of(page.number)
        expected = partial(_page_arrays, has_colors)
        arrays = read_archive(path, PAGE_FORMAT, "page of a volume", "PagedTSDFVolume", expected, _fault_of_page)
        if not np.array_equal(arrays["keys"], page.keys):
            raise FileError(path, f"contains other blocks than {LIST} lists", remedy="The file was changed")
        del arrays["format"]
        return arrays

    def save(self, header: Arrays, side: int, pages: Mapping[int, Page]) -> None:
        """Write the list of pages, then remove all other pages."""
        listed = sorted(pages.items())
        none = np.zeros(0, np.int64)
        arrays = {
            "side": np.array(side),
            "cubes": np.array([cube for cube, _ in listed], np.int64),
            "numbers": np.array([page.number for _, page in listed], np.int64),
            "counts": np.array([len(page.keys) for _, page in listed], np.int64),
            "keys": np.concatenate([none, *(page.keys for _, page in listed)]),
        }
        write_archive(self._run.file(LIST), FORMAT, header | arrays, overwrite=True)
        unused = set(self._numbers()) - {page.number for page in pages.values()}
        for path in map(self._path_of, unused):
            if has_format(path, PAGE_FORMAT):
                path.unlink(missing_ok=True)
        for part in self.path.glob(".*.npz.*.part"):
            part.unlink(missing_ok=True)

    def saved(self) -> Saved:
        """Last saved state. FileError if the list is damaged."""
        arrays = read_archive(
            self.path / LIST, FORMAT, "list of pages", "PagedTSDFVolume.save", _listed, _fault_of_list
        )
        ends = np.cumsum(arrays["counts"])[:-1]
        keys = np.split(arrays["keys"], ends) if len(arrays["cubes"]) else []
        rows = zip(arrays["cubes"].tolist(), arrays["numbers"].tolist(), keys, strict=True)
        header = {name: arrays[name] for name in ("sizes", "origin", "frame_count", "has_color")}
        return Saved(header, int(arrays["side"]), {cube: Page(number, blocks) for cube, number, blocks in rows})


def _page_arrays(has_colors: bool, arrays: Arrays) -> Expected:
    blocks = rows_of(arrays, "keys")
    expected: dict[str, tuple[Any, tuple[int, ...]]] = {
        "keys": (np.int64, (blocks,)),
        "ranks": (np.int64, (blocks,)),
        "distances": (np.float32, (blocks, BLOCK_VOXELS)),
        "weights": (np.uint16, (blocks, BLOCK_VOXELS)),
    }
    if has_colors:
        expected["colors"] = (np.uint16, (blocks, BLOCK_VOXELS, 3))
    return expected


def _fault_of_page(arrays: Arrays) -> str:
    return "" if (np.abs(arrays["distances"]) <= 1).all() else "distances: not all in -1..1"


def _listed(arrays: Arrays) -> Expected:
    pages = rows_of(arrays, "cubes")
    return {
        "sizes": (np.float64, (2,)),
        "origin": (np.float64, (3,)),
        "frame_count": (np.int64, ()),
        "has_color": (np.bool_, (2,)),
        "side": (np.int64, ()),
        "cubes": (np.int64, (pages,)),
        "numbers": (np.int64, (pages,)),
        "counts": (np.int64, (pages,)),
        "keys": (np.int64, (rows_of(arrays, "keys"),)),
    }


def _fault_of_list(arrays: Arrays) -> str:
    voxel_size, truncation = arrays["sizes"].tolist()
    keys, counts, side = arrays["keys"], arrays["counts"], int(arrays["side"])
    if fault := find_fault_of_sizes(voxel_size, truncation):
        return fault
    if not np.isfinite(arrays["origin"]).all() or int(arrays["frame_count"]) < 0:
        return "origin, frame_count: not finite, or negative"
    if not 1 <= side <= MAX_SIDE or (counts < 1).any() or counts.sum() != len(keys):
        return "side, counts: out of range"
    if len(np.unique(arrays["numbers"])) != len(counts) or (arrays["numbers"] < 1).any():
        return "numbers: repeated, or below 1"
    if len(keys) and (
        keys.min() < 0 or np.abs(block_box(keys)).max() > CELL_BIAS - 2 or len(np.unique(keys)) != len(keys)
    ):
        return "keys: blocks out of range or repeated"
    if not np.array_equal(np.repeat(arrays["cubes"], counts), cubes_of(keys, side)):
        return "cubes: do not match the blocks"
    return ""

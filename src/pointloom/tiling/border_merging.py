"""Border data that tiles leave for a joined step, and the join.

Files and the join's folder appear atomically and reproducibly. The join reads parts of the files when it uses them.
"""

from __future__ import annotations

import json
import shutil
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..core.atomic import atomic_write, part_folder
from ..core.checks import MAX_COUNT
from ..core.errors import FileError
from ..core.json_files import check_keys, json_count, read_json_object
from ..core.paths import job_file
from ..io.fixed_rows import StoredArray
from ..io.points.npz import read_npy
from ..io.source import open_source

LEFT, JOINED = "left", "joined"
SUMMARY = "whole.json"


@dataclass(frozen=True)
class Joined:
    """Result of a join: the global count."""

    count: int


def write_border_data(folder: Path, step: int, tile: int, arrays: dict[str, NDArray[Any]]) -> None:
    """Write a tile's border data. FileError if the file cannot be written."""
    with atomic_write(job_file(folder / LEFT / str(step) / f"{tile}.npy")) as file:
        np.lib.format.write_array(file, np.array([*arrays], dtype="U32"))
        for values in arrays.values():
            np.lib.format.write_array(file, np.ascontiguousarray(values))


class BorderData:
    """Border data of all tiles for the join of a step; `counts` has the items of each tile's file."""

    def __init__(self, folder: Path, step: int, counts: dict[int, int]):
        self.path, self._counts = folder / LEFT / str(step), counts
        self.tiles = sorted(counts)
        self._open = lru_cache(maxsize=64)(self._read)

    def __contains__(self, tile: int) -> bool:
        return tile in self._counts

    def __getitem__(self, tile: int) -> dict[str, StoredArray]:
        """Arrays of a tile. FileError if missing, damaged or not as in the manifest."""
        return self._open(tile)

    def __iter__(self) -> Iterator[tuple[int, dict[str, StoredArray]]]:
        for tile in self.tiles:
            yield tile, self._open(tile)

    def _read(self, tile: int) -> dict[str, StoredArray]:
        path = self.path / f"{tile}.npy"
        remedy = "Plan it again in another folder"
        try:
            source = open_source(path)
            names = StoredArray(source, kinds="U")
            arrays, end = dict[str, StoredArray](), names.end
            for name in names[:].reshape(-1).tolist():
                arrays[name] = StoredArray(source, end)
                end = arrays[name].end
        except FileError as error:
            raise FileError(path, error.reason, where=error.where, remedy=remedy) from error
        if "count" not in arrays or arrays["count"][:].tolist() != [self._counts[tile]]:
            raise FileError(path, f"is not the border data that tile {tile} wrote for the join", remedy=remedy)
        return arrays


def join_step(folder: Path, number: int, step: Any, left: BorderData, owner: str) -> Joined:
    """Join the border data of a step and remove unfinished joins. FileError if data is damaged or the disk full."""
    done = folder / JOINED / str(number)
    part = done.with_name(f"{done.name}.{owner}.part")
    for old in (done, *done.parent.glob(f"{done.name}.*.part")):
        shutil.rmtree(old, ignore_errors=True)
    with part_folder(part):
        count = step.join(left, part)
        (part / SUMMARY).write_text(json.dumps({"count": count}), encoding="utf-8")
        part.rename(done)
    return Joined(count)


def read_joined(folder: Path, number: int, tile: int) -> tuple[int, NDArray[Any] | None]:
    """Global count of a join, and its result for a tile or None. FileError if unreadable."""
    join_folder = folder / JOINED / str(number)
    summary, path = join_folder / SUMMARY, join_folder / f"{tile}.npy"
    content = read_json_object(summary)
    check_keys(summary, content, required={"count"})
    count = json_count(summary, content["count"], MAX_COUNT, where="key count")
    if not path.exists():
        return count, None
    labels = read_npy(path)
    if labels.ndim != 1 or labels.dtype.kind not in "iu":
        raise FileError(path, f"expected integers of shape [n], got {labels.dtype} {list(labels.shape)}")
    return count, labels

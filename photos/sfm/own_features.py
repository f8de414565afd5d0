"""Features and matches of a folder of pictures by kernels of our own, as files that COLMAP's process writes down."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.devices import resolve_device
from ...core.errors import FileError
from ...core.progress import ReportProgress
from ...core.timing import Clock
from ...core.wording import format_bytes
from ...files.pictures.image_files import read_color
from ...kernels.keypoints.sift import BYTES_A_PIXEL
from .colmap_jobs import open_database
from .feature_rays import DESCRIPTOR, table_of
from .frames import check_option
from .keypoints import KeypointFinder, Keypoints, match_descriptors
from .limited_process import free_memory
from .masks import read_mask
from .picture_folder import scaled_size

FINDERS = ("colmap", "pointloom")

_PAIRS_AT_ONCE = 64
_MOST_AT_ONCE = 2**20  # features in the first pictures of the pairs that are matched at once


def device_of(finder: Any, device: Any, kind: str) -> Any:
    """Where our own kernels find or match features of a kind; None where COLMAP does.

    Raises:
        TypeError, ValueError: No such finder; features that are not SIFT's.
        DeviceError: No such device.
    """
    if check_option("finder", finder, FINDERS) != "pointloom":
        return None
    if kind != "sift":
        raise ValueError(f"finder: pointloom finds and matches SIFT features, not {kind}")
    return resolve_device(device)


def find_own(
    folder: Path,
    groups: Mapping[tuple[tuple[int, int], Any], list[str]],
    place: Path,
    *,
    max_size: int,
    max_features: int,
    masks: Mapping[str, Path],
    device: Any,
    limits: dict[str, Any],
    progress: ReportProgress,
) -> None:
    """Find the features of pictures, and keep them as one file of arrays each.

    Args:
        folder: Of the pictures.
        groups: Their names by size (width, height) and lens.
        place: A new folder for the files.
        max_size: The longer side at which features are found [px].
        max_features: Of a picture.
        masks: By the names of pictures; no features where they are black.
        device: Where to compute.
        limits: `max_seconds` and `max_memory`.
        progress: Called with "features", how many pictures are done, and how many there are.

    Raises:
        FileError: A damaged picture, or a limit is passed.
    """
    place.mkdir()
    count, done, clock = sum(map(len, groups.values())), 0, Clock()
    finders: dict[tuple[int, int], KeypointFinder] = {}
    for (size, _), names in groups.items():
        scaled = scaled_size(size, max_size)
        if scaled not in finders:
            _check_memory(folder, scaled, limits["max_memory"])
            finders = {scaled: KeypointFinder(scaled, device)}  # the arrays of another size are given back
        for name in names:
            mask = read_mask(masks[name], size) if name in masks else None
            found = finders[scaled].find(read_color(folder / name), mask, max_features)
            np.savez(place / f"{done:08d}.npz", shapes=_shapes_of(found), descriptors=found.descriptors)
            done += 1
            progress("features", done, count)
            _check_time(folder, clock, limits["max_seconds"], "finding features")


def match_own(
    database: Path,
    numbers: NDArray[np.int64],
    place: Path,
    *,
    device: Any,
    max_seconds: float,
    progress: ReportProgress,
) -> None:
    """Match the features of pairs of pictures of a database, and keep the matches as files of arrays.

    Args:
        database: COLMAP's, with features.
        numbers: Of the first and second picture of each pair, [p, 2].
        place: A new folder for the files.
        device: Where to compute.
        max_seconds: It is given up after this time [s].
        progress: Called with "pairs", how many are done, and how many there are.

    Raises:
        FileError: The database holds other features than SIFT's, or the time is over.
    """
    place.mkdir()
    clock, done = Clock(), 0
    with open_database(database) as connection:
        while done < len(numbers):
            some = numbers[done : done + _PAIRS_AT_ONCE]
            pictures, rows = np.unique(some, return_inverse=True)
            kinds = [_descriptors_of(connection, int(number), database) for number in pictures]
            matches = match_descriptors(kinds, rows.reshape(-1, 2), device)
            firsts = np.concatenate([[0], np.cumsum([len(each) for each in matches])])
            arrays = {"pairs": some, "firsts": firsts, "matches": np.concatenate(matches)}
            np.savez(place / f"{done:08d}.npz", **arrays)
            done += len(some)
            progress("pairs", done, len(numbers))
            _check_time(database, clock, max_seconds, "matching")


def pairs_of(database: Path, pairs: str, overlap: int) -> NDArray[np.int64]:
    """Numbers of the pictures of all pairs, or of those that are 1, 2, 4, ... apart in the order of names: [p, 2]."""
    with open_database(database) as connection:
        rows = connection.execute("SELECT image_id FROM images ORDER BY name").fetchall()
    numbers = np.array([number for (number,) in rows], np.int64)
    first, second = np.triu_indices(len(numbers), 1)
    if pairs == "sequential":
        near = np.isin(second - first, 1 << np.arange(overlap))
        first, second = first[near], second[near]
    return np.sort(np.stack([numbers[first], numbers[second]], axis=1), axis=1)


def _descriptors_of(connection: Any, number: int, database: Path) -> NDArray[np.uint8]:
    """The descriptors of a picture."""
    table = table_of(connection, "descriptors", number, np.uint8, database)
    if len(table) and table.shape[1] != DESCRIPTOR:
        raise FileError(database, "holds features that are not SIFT's", remedy="sfm.find_features makes one")
    return np.ascontiguousarray(table.reshape(-1, DESCRIPTOR))


def _shapes_of(keypoints: Keypoints) -> NDArray[np.float32]:
    """Keypoints as COLMAP has them: its first pixel's middle is (0.5, 0.5), and a matrix turns and scales."""
    along = keypoints.scales * np.cos(keypoints.orientations)
    across = keypoints.scales * np.sin(keypoints.orientations)
    return np.column_stack([keypoints.positions + np.float32(0.5), along, -across, across, along])


def _check_time(place: Path, clock: Clock, max_seconds: float, noun: str) -> None:
    clock.stop(noun)
    if clock.seconds[noun] > max_seconds:
        remedy = "Give it more time, or fewer or smaller pictures"
        raise FileError(place, f"{noun} took more than {max_seconds:g} s", remedy=remedy)


def _check_memory(folder: Path, size: tuple[int, int], max_memory: int | None) -> None:
    need = BYTES_A_PIXEL * size[0] * size[1]
    if need > (max_memory or free_memory()):
        reason = f"finding features at {size[0]} x {size[1]} pixels takes {format_bytes(need)}, more than there may be"
        raise FileError(folder, reason, remedy="Give it more memory, or a smaller max_size")

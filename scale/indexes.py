"""Virtual point clouds (.vpc: STAC items): the files that they list, held to what they say of them."""

from __future__ import annotations

from pathlib import Path
from typing import Any
from urllib.parse import unquote

import numpy as np

from ..core.checks import shown
from ..core.errors import FileError
from ..core.json_files import read_json_object
from ..files.points.las import open_las

SUFFIXES = (".las", ".laz")
INDEX = ".vpc"


def files_of_index(path: Path) -> list[Path]:
    """The files that a virtual point cloud (.vpc: STAC items) lists, in its order.

    Raises:
        FileError: It cannot be read, is none, lists what is not there or no LAS file, or says of one what is not so.
    """
    try:
        items = read_json_object(path)["features"]
        hrefs = [_data_of(item["assets"])["href"] for item in items]
    except FileError:
        raise
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        reason = f"is no virtual point cloud: {type(error).__name__}: {error}"
        raise FileError(path, reason, remedy="A .vpc has features, each with an asset of points") from error
    files = []
    for number, href in enumerate(hrefs):
        where = f"item {number}"
        if not isinstance(href, str) or "://" in href or "\0" in href:
            remedy = "Download it, and make the index anew"
            raise FileError(path, f"lists {href!r}, which is no file on this machine", where=where, remedy=remedy)
        try:
            file = (path.parent / href).resolve()
            if not file.is_file():
                file = (path.parent / unquote(href)).resolve()
            is_there = file.is_file()
        except (OSError, ValueError) as error:  # a name that is too long, or has NUL once it is unquoted
            raise FileError(path, f"lists {shown(href)}: {error}", where=where) from error
        if file.suffix.lower() not in SUFFIXES:
            raise FileError(path, f"lists {href}, which is neither .las nor .laz", where=where)
        if not is_there:
            raise FileError(path, f"lists {href}, which is not there", where=where, remedy=f"It should be at {file}")
        _check_item(path, items[number], file, where)
        files.append(file)
    if not files:
        raise FileError(path, "lists no file")
    return files


def _data_of(assets: dict[str, Any]) -> dict[str, Any]:
    """The asset of an item that holds its points: the one called so, or the only one with that role or such a name."""
    if "data" in assets:
        return assets["data"]
    told = [asset for asset in assets.values() if "data" in asset.get("roles", ())]
    told = told or [asset for asset in assets.values() if asset["href"].lower().endswith(SUFFIXES)]
    if len(told) != 1:
        raise ValueError(f"of the assets {', '.join(map(repr, assets)) or '(none)'} not one is that of the points")
    return told[0]


def _check_item(path: Path, item: dict[str, Any], file: Path, where: str) -> None:
    """Hold that what an item says of a file is so: its number of points, and its bounds to a step of its coordinates.

    Raises:
        FileError: It is not.
    """
    header, told = open_las(file).header, item.get("properties") or {}
    if not isinstance(told, dict):
        raise FileError(path, f"expected an object of properties, got {shown(told)}", where=where)
    count, box, remedy = told.get("pc:count"), told.get("proj:bbox"), "Make the index anew"
    if count is not None and count != header.point_count:
        reason = f"says that {file} holds {shown(count)} points, it holds {header.point_count}"
        raise FileError(path, reason, where=where, remedy=remedy)
    if box is None or not header.point_count:
        return
    low, high = np.array(header.bounds, np.float64)
    try:
        ends = np.array(box, np.float64).reshape(2, -1)
        (plane,) = {ends.shape[1]} & {2, 3}
    except (ValueError, TypeError, OverflowError) as error:
        reason = f"says bounds of {file} that are none: {shown(box)}"
        raise FileError(path, reason, where=where, remedy=remedy) from error
    beside = np.abs(ends - np.array([low, high])[:, :plane])
    if not (beside <= 2 * np.array(header.scales)[:plane]).all():
        reason = f"says that {file} reaches over {ends.tolist()}, its header {[low.tolist(), high.tolist()]}"
        raise FileError(path, reason, where=where, remedy=remedy)

"""Files of a job: their description in the plan, and the points of a window in canonical order.

Points are ordered by file and row for every tile. COPC files are read by windows, other LAS and LAZ files from buckets
(buckets.py), all others through a LAZ conversion (unindexed_files.py).
"""

from __future__ import annotations

import os
from functools import lru_cache
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import numpy as np
from numpy.typing import NDArray

from ..core.atomic import restore_folder
from ..core.checks import check_list, shown
from ..core.errors import FileError
from ..core.json_files import read_json_object
from ..core.paths import path_of
from ..core.progress import ReportProgress
from ..core.units import text_of
from ..io.columns import warn_of_loss
from ..io.points.copc import CopcFile, is_copc, octree_of
from ..io.points.formats import CLOUD_FORMATS
from ..io.points.las import LasFile, attribute_types, open_las, scale_by, table_of
from ..io.points.las_crs import NO_NAME, crs_name, find_text, is_geographic
from ..io.points.las_records import left_out_of, own_records
from ..io.points.las_units import units_of
from ..io.table import PointTable
from .buckets import Window, check_size, inside, positions_of, read_buckets
from .manifest import NAME, UNSORTED_COLOR, read_plan
from .plan_check import TilePlan
from .unindexed_files import FOLDER as MADE
from .unindexed_files import SUFFIXES as LOOSE
from .unindexed_files import converted_files

IN_FOLDERS = tuple(suffix for suffix in LOOSE if not CLOUD_FORMATS[suffix].may_be_other)  # these may be notes
ROW_BITS = 40  # bits of a point's key for its row. The rest is the file number


def list_files(sources: Any) -> list[Path]:
    """Absolute unique paths of the files given by files, folders (LAS and LAZ, else other point files) and indexes."""
    given = [sources] if isinstance(sources, str | os.PathLike) else check_list("sources", sources, "paths")
    files: dict[Path, None] = {}
    for path in map(path_of, given):
        if "\0" in str(path):
            raise FileError(path, "is not a path: it contains NUL")
        restore_folder(path)
        try:
            names = sorted(path.iterdir()) if path.is_dir() else None
        except OSError as error:
            raise FileError(path, f"cannot be read: {error.strerror or error}") from error
        suffix = path.suffix.lower()
        if names is not None:
            kinds = ([name for name in names if name.suffix.lower() in kind] for kind in (SUFFIXES, IN_FOLDERS))
            chosen = next(filter(None, kinds), None)
            if chosen is None:
                raise FileError(path, f"the folder contains no {', '.join(SUFFIXES)} or {', '.join(IN_FOLDERS)} file")
            files |= dict.fromkeys(child.resolve() for child in chosen)
        elif suffix == INDEX:
            files |= dict.fromkeys(files_of_index(path))
        elif suffix in SUFFIXES or suffix in LOOSE:
            files[path.resolve()] = None
        else:
            known = ", ".join((*SUFFIXES, INDEX, *LOOSE))
            raise FileError(path, f"expected one of {known}", remedy="Convert it to .laz first")
    if not files:
        raise ValueError("sources: expected at least one file")
    return [*files]


def describe_all(
    paths: list[Path], folder: Path, report: ReportProgress, epoch: int | None = None
) -> list[dict[str, Any]]:
    """Descriptions of files for the plan; converts files that are not LAS, in the job's folder. Descriptions of
    unchanged files are taken from an existing plan. `epoch` is None for the survey itself."""
    loose = [path for path in paths if path.suffix.lower() in LOOSE]
    if not loose:
        return [describe(path) for path in paths]
    states = {path: _state_on_disk(path) for path in loose}
    if (folder / NAME).exists():
        plan = read_plan(folder)
        described = [{"sources": plan["sources"]}] if epoch is None else plan["epochs"][epoch : epoch + 1]
        listed = [source for survey in described for source in survey["sources"]]
        known = {source["original"]["path"]: source for source in listed if "original" in source}
        changed = [path for path in loose if known.get(str(path), {}).get("original") != states[path]]
        if changed:
            reason = f"contains the tiles of another plan: {changed[0]} is new or has changed"
            raise FileError(folder, reason, remedy="Give another folder")
        for path in loose:
            check_unchanged(known[str(path)])
        return [known[str(path)] if path in states else describe(path) for path in paths]
    name = MADE if epoch is None else f"{MADE}-{epoch + 1}"
    with converted_files(loose, folder, report, name) as made:
        described = {path: describe(laz_path) for path, laz_path in made.items()}
    for path, source in described.items():
        source |= {"path": str((folder / name / Path(source["path"]).name).resolve()), "original": states[path]}
    return [described[path] if path in states else describe(path) for path in paths]


def _state_on_disk(path: Path) -> dict[str, Any]:
    try:
        stat = path.stat()
    except OSError as error:
        raise FileError(path, f"cannot be read: {error.strerror or error}") from error
    return {"path": str(path), "size": stat.st_size, "mtime_ns": stat.st_mtime_ns}


def describe(path: Path) -> dict[str, Any]:
    """Description of a LAS file in JSON's types. FileError if damaged or in degrees."""
    file = open_las(path)
    header = file.header
    if is_geographic(header):
        remedy = "Project it first, for example to meters with project_to_utm(cloud)"
        raise FileError(path, "x and y are degrees of longitude and latitude, not lengths", remedy=remedy)
    kind = "copc" if is_copc(file) else "rows"
    if kind == "copc":
        octree_of(file)  # validates it against the chunks
    units = units_of(header)
    low, high = header.bounds
    return {
        **_state_on_disk(path),
        "kind": kind,
        "points": header.point_count,
        "low": [*map(float, low)],
        "high": [*map(float, high)],
        "scales": [*header.scales],
        "offsets": [*header.offsets],
        "crs": find_text(header) if crs_name(header) == NO_NAME else crs_name(header),
        "unit": None if units.plane is None else text_of(units.plane),
        "format": header.point_format,
        "attributes": attribute_types(file),
    }


def check_compatible(sources: list[dict[str, Any]]) -> None:
    """Raise FileError if files differ in coordinate system, unit, scale or attributes."""
    first = sources[0]
    for other in sources[1:]:
        for key, what in (
            ("crs", "coordinate system"),
            ("unit", "unit"),
            ("scales", "scale"),
            ("attributes", "attributes"),
        ):
            if other[key] != first[key]:
                wanted, got = _value_text(first[key]), _value_text(other[key])
                reason = f"expected the {what} {wanted} as in {original_path(first)}, got {got}"
                raise FileError(
                    original_path(other),
                    reason,
                    remedy=f"Convert the files to the same {what} first, it is not converted automatically",
                )


def warn_of_lost_records(sources: list[dict[str, Any]]) -> None:
    """Warn about waveforms, or records of several files, which tiles do not keep."""
    header = file_of(sources[0]).header
    if lost := left_out_of(header):
        warn_of_loss(original_path(sources[0]), " and the ".join(lost), "tiles contain points only")
    if len(sources) > 1 and (names := own_records(header)):
        reason = "tiles contain points of several files. Tiles of a single file keep them"
        warn_of_loss(original_path(sources[0]), f"records {', '.join(names)}", reason)


def original_path(source: dict[str, Any]) -> str:
    """Path of the file as given by the user, not of its LAZ conversion."""
    return source.get("original", source)["path"]


def _value_text(value: object) -> str:
    if isinstance(value, dict):
        return ", ".join(f"{name} ({kind})" for name, kind in value.items()) or "none"
    return "unknown" if value is None else str(value)


def check_unchanged(source: dict[str, Any]) -> None:
    """Raise FileError if a file is missing, or its size or time changed."""
    if "original" in source:
        check_unchanged(source["original"])
    path = Path(source["path"])
    try:
        stat = path.stat()
    except OSError as error:
        made = f", which was converted from {original_path(source)}" if "original" in source else ""
        remedy = "Plan the tiles again in another folder" if made else ""
        raise FileError(path, f"cannot be read: {error.strerror or error}{made}", remedy=remedy) from error
    if (stat.st_size, stat.st_mtime_ns) != (source["size"], source["mtime_ns"]):
        what = f"{source['size']} bytes" + ("" if stat.st_size == source["size"] else f", now {stat.st_size}")
        remedy = "Plan the tiles again in another folder"
        raise FileError(path, f"has changed since the tiles were planned ({what})", remedy=remedy)


def file_of(source: dict[str, Any]) -> LasFile:
    return _opened(*_state_of(source))


def _state_of(source: dict[str, Any]) -> tuple[str, int, int]:
    return source["path"], source["size"], source["mtime_ns"]


@lru_cache(maxsize=8)
def _opened(path: str, size: int, mtime_ns: int) -> LasFile:
    return open_las(path)


@lru_cache(maxsize=8)
def _opened_copc(path: str, size: int, mtime_ns: int) -> tuple[CopcFile, NDArray[np.int64]]:
    """A COPC file and the first row of each node."""
    copc = octree_of(_opened(path, size, mtime_ns))
    in_file = np.argsort(copc.nodes["begin"], kind="stable")
    counts = copc.nodes["count"][in_file].astype(np.int64)
    firsts = np.empty(len(counts), np.int64)
    firsts[in_file] = np.cumsum(counts) - counts
    return copc, firsts


class UnsortedFileError(Exception):
    """A tile needs a file that was far from all tiles during planning. The argument is its number."""


def read_window(
    plan: TilePlan, folder: Path, fulls: dict[int, int], window: Window, epoch: int | None = None
) -> PointTable:
    return read_rows(plan, folder, fulls, window, epoch)[0]


def read_rows(
    plan: TilePlan, folder: Path, fulls: dict[int, int], window: Window, epoch: int | None = None
) -> tuple[PointTable, NDArray[np.int64]]:
    """Points of all files in a window in canonical order, and ascending keys made of file number and row."""
    tables, keys, listed = [], [], plan.numbered(epoch)
    for number, source in listed:
        if not _meets(source, window, plan.slack):
            continue
        check_unchanged(source)
        if source["kind"] == "copc":
            copc, firsts = _opened_copc(*_state_of(source))
            rows, numbers = _rows_of_copc(copc, firsts, window, plan)
            file, full = copc.file, copc.full
        else:
            file, full = file_of(source), fulls[number]
            if full == UNSORTED_COLOR:
                raise UnsortedFileError(number)
            rows, numbers = read_buckets(plan, folder, number, file, window)
        if len(rows):
            tables.append(_decoded(file, rows, full))
            keys.append(numbers + (np.int64(number) << ROW_BITS))
        check_unchanged(source)  # not modified during reading
        check_size(plan, sum(len(table.points) for table in tables))
    if not tables:
        file = file_of(listed[0][1])
        return _decoded(file, np.empty(0, file.layout.dtype()), 65535), np.empty(0, np.int64)
    return _joined(tables), np.concatenate(keys)


def _meets(source: dict[str, Any], window: Window, slack: float) -> bool:
    low, high = source["low"], source["high"]
    return all(high[k] + slack >= window[k] and low[k] - slack <= window[k + 2] for k in range(2))


def _rows_of_copc(
    copc: CopcFile, firsts: NDArray[np.int64], window: Window, plan: TilePlan
) -> tuple[NDArray[Any], NDArray[np.int64]]:
    low, high = np.array([*window[:2], -np.inf]), np.array([*window[2:], np.inf])
    which = copc.nodes_within(low, high)
    check_size(plan, int(copc.nodes["count"][which].sum()) // 4)  # many of them may be outside
    which = which[np.argsort(copc.nodes["begin"][which], kind="stable")]
    rows = np.frombuffer(copc.unpack(which), copc.file.layout.dtype())
    _check_nodes(copc, which, rows, plan)
    counts = copc.nodes["count"][which].astype(np.int64)
    begins = np.repeat(firsts[which] - (np.cumsum(counts) - counts), counts)
    keep = inside(positions_of(copc.file, rows), window)
    return rows[keep], (begins + np.arange(len(rows)))[keep]


def _check_nodes(copc: CopcFile, which: NDArray[np.int64], rows: NDArray[Any], plan: TilePlan) -> None:
    """Raise FileError if points are outside the cubes of their nodes, where a window would miss them."""
    nodes = copc.nodes[which]
    widths = copc.side / 2.0 ** nodes["level"]
    lows = copc.corner + nodes["cell"] * widths[:, None]
    slack = plan.slack + np.array(copc.file.header.scales)
    owners = np.repeat(np.arange(len(nodes)), nodes["count"])
    positions = positions_of(copc.file, rows, "XYZ")
    beyond = ((positions < (lows - slack)[owners]) | (positions > (lows + widths[:, None] + slack)[owners])).any(axis=1)
    if beyond.any():
        row = int(np.flatnonzero(beyond)[0])
        where = f"the chunk at byte {int(nodes['begin'][owners[row]])}"
        reason = f"is damaged: the point at {positions[row].tolist()} is outside the cube of its node"
        raise FileError(copc.path, reason, where=where)


def _decoded(file: LasFile, rows: Any, full: int) -> PointTable:
    columns = file.decode(rows)
    if "colors" in columns:
        scale_by(full, columns["colors"], file.path, "Convert it to .las first, which is read completely once")
    return table_of(file, columns)


def _joined(tables: list[PointTable]) -> PointTable:
    if len(tables) == 1:
        return tables[0]
    first = tables[0]
    for name in ("normals", "colors"):
        values = [getattr(table, name) for table in tables]
        setattr(first, name, None if values[0] is None else np.concatenate(values))
    first.attributes = {name: np.concatenate([table.attributes[name] for table in tables]) for name in first.attributes}
    first.points = np.concatenate([table.points for table in tables])
    return first


SUFFIXES = (".las", ".laz")
INDEX = ".vpc"


def files_of_index(path: Path) -> list[Path]:
    """Files listed in a virtual point cloud (.vpc: STAC items). FileError if an entry is wrong."""
    try:
        items = read_json_object(path)["features"]
        hrefs = [_data_of(item["assets"])["href"] for item in items]
    except FileError:
        raise
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        reason = f"is not a virtual point cloud: {type(error).__name__}: {error}"
        raise FileError(path, reason, remedy="A .vpc has features, each with an asset of points") from error
    files = []
    for number, href in enumerate(hrefs):
        where = f"item {number}"
        if not isinstance(href, str) or "://" in href or "\0" in href:
            remedy = "Download it, and create the index again"
            raise FileError(path, f"lists {href!r}, which is not a file on this machine", where=where, remedy=remedy)
        try:
            file = (path.parent / href).resolve()
            if not file.is_file():
                file = (path.parent / unquote(href)).resolve()
            is_there = file.is_file()
        except (OSError, ValueError) as error:  # name too long, or with NUL after unquoting
            raise FileError(path, f"lists {shown(href)}: {error}", where=where) from error
        if file.suffix.lower() not in SUFFIXES:
            raise FileError(path, f"lists {href}, which is neither .las nor .laz", where=where)
        if not is_there:
            raise FileError(
                path, f"lists {href}, which does not exist", where=where, remedy=f"The expected path is {file}"
            )
        _check_item(path, items[number], file, where)
        files.append(file)
    if not files:
        raise FileError(path, "lists no file")
    return files


def _data_of(assets: dict[str, Any]) -> dict[str, Any]:
    """Asset with the points of an item: the one named "data", or the only one with that role or extension."""
    if "data" in assets:
        return assets["data"]
    candidates = [asset for asset in assets.values() if "data" in asset.get("roles", ())]
    candidates = candidates or [asset for asset in assets.values() if asset["href"].lower().endswith(SUFFIXES)]
    if len(candidates) != 1:
        raise ValueError(f"expected one asset with points, got {', '.join(map(repr, assets)) or '(none)'}")
    return candidates[0]


def _check_item(path: Path, item: dict[str, Any], file: Path, where: str) -> None:
    """Raise FileError if an item's point count or bounds disagree with its file."""
    header, properties = open_las(file).header, item.get("properties") or {}
    if not isinstance(properties, dict):
        raise FileError(path, f"expected an object of properties, got {shown(properties)}", where=where)
    count, box, remedy = properties.get("pc:count"), properties.get("proj:bbox"), "Create the index again"
    if count is not None and count != header.point_count:
        reason = f"lists {shown(count)} points of {file}, which contains {header.point_count}"
        raise FileError(path, reason, where=where, remedy=remedy)
    if box is None or not header.point_count:
        return
    low, high = np.array(header.bounds, np.float64)
    try:
        ends = np.array(box, np.float64).reshape(2, -1)
        (plane,) = {ends.shape[1]} & {2, 3}
    except (ValueError, TypeError, OverflowError) as error:
        reason = f"lists invalid bounds of {file}: {shown(box)}"
        raise FileError(path, reason, where=where, remedy=remedy) from error
    beside = np.abs(ends - np.array([low, high])[:, :plane])
    if not (beside <= 2 * np.array(header.scales)[:plane]).all():
        reason = f"lists the bounds {ends.tolist()} of {file}, its header {[low.tolist(), high.tolist()]}"
        raise FileError(path, reason, where=where, remedy=remedy)

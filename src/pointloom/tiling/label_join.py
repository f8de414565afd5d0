"""Join clusters of tiles: a point in two clusters merges them.

Clusters seen by one tile are complete. Halo points of the others are listed with their home tile, and each point common
to clusters of two tiles is a link. Memory: 40 B per such cluster, 30 B per link, 20 B per cluster of one tile. Clusters
are numbered by (major, minor) keys, sizes and first points, in bounded parts of that order. Each part appends the
numbers of complete clusters to a file per tile, since their list has the same order.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..core.errors import FileError
from ..io.source import changed_error, open_source
from .border_merging import BorderData

MAX_RANKED = 1 << 22  # approximate number of clusters sorted at a time
MAX_INT32 = 2**31 - 1  # maximum clusters of 32-bit labels
NEVER = np.iinfo(np.int64).max  # first point of a cluster without points in the tile
_Keys = tuple[NDArray[np.int64], NDArray[np.int64]]  # (major, minor), sorted


def border_data(
    labels: NDArray[np.int32], count: int, part: Any, sight: Any, bounds: tuple[int, int], by_size: bool
) -> dict[str, NDArray[Any]]:
    """Border data of a tile's clusters; `labels` are those of cores, else negative, `bounds` the allowed sizes."""
    is_core = labels >= 0
    own = sight.own & is_core
    firsts, sizes = np.full(count, NEVER), np.bincount(labels[own], minlength=count)
    np.minimum.at(firsts, labels[own], part.keys[own])
    shared, borrowed = own & sight.shared, sight.seen & is_core & ~sight.own
    on_edge = np.zeros(count, bool)
    on_edge[labels[shared | borrowed]] = True
    edge = np.flatnonzero(on_edge)
    closed = np.flatnonzero(~on_edge & (sizes >= max(bounds[0], 1)) & (sizes <= bounds[1]))
    majors = -sizes[closed] if by_size else np.zeros(len(closed), np.int64)
    order = np.lexsort((firsts[closed], majors))
    shared, borrowed = np.flatnonzero(shared), np.flatnonzero(borrowed)
    shared = shared[np.argsort(part.keys[shared])]
    borrowed = borrowed[np.lexsort((part.keys[borrowed], sight.owners[borrowed]))]
    slots = np.zeros(count, np.int32)
    slots[edge] = np.arange(len(edge))
    return {
        "count": np.array([count]),
        "closed": closed[order].astype(np.int32),
        "majors": majors[order],
        "minors": firsts[closed][order],
        "edge": edge.astype(np.int32),
        "edge_firsts": firsts[edge],
        "edge_sizes": sizes[edge].astype(np.int64),
        "lent_keys": part.keys[shared],
        "lent": slots[labels[shared]],
        "borrowed_tiles": sight.owners[borrowed],
        "borrowed_keys": part.keys[borrowed],
        "borrowed": slots[labels[borrowed]],
    }


def join_labels(left: BorderData, folder: Path, bounds: tuple[int, int], by_size: bool) -> int:
    """Number all clusters, largest first if `by_size`, and write the labels of each tile, -1 for dropped ones."""
    ends = np.cumsum([0, *(len(arrays["edge"]) for _, arrays in left)])
    begins = dict(zip(left.tiles, ends[:-1].tolist(), strict=True))
    sets = _united(int(ends[-1]), _links(left, begins))
    group_count = int(sets.max(initial=-1)) + 1
    firsts, sizes = np.full(group_count, NEVER), np.zeros(group_count, np.int64)
    for tile, arrays in left:
        mine = sets[begins[tile] : begins[tile] + len(arrays["edge"])]
        np.minimum.at(firsts, mine, arrays["edge_firsts"][:])
        np.add.at(sizes, mine, arrays["edge_sizes"][:])
    selected = np.flatnonzero((firsts != NEVER) & (sizes >= bounds[0]) & (sizes <= bounds[1]))
    majors = -sizes[selected] if by_size else np.zeros(len(selected), np.int64)
    order = np.lexsort((firsts[selected], majors))
    selected, groups = selected[order], (majors[order], firsts[selected][order])
    total = len(selected) + sum(len(arrays["closed"]) for _, arrays in left)
    kind = np.int32 if total <= MAX_INT32 else np.int64
    names = np.full(group_count, -1, kind)
    begin = 0
    for stretch in _stretches(left, groups, total):
        begin = _rank_stretch(left, folder, groups, (selected, names), stretch, begin)
    for tile, arrays in left:
        if count := int(arrays["count"][0]):
            labels = np.full(count, -1, kind)
            labels[arrays["closed"][:]] = _read_ranks(_rank_file(folder, tile), kind, len(arrays["closed"]))
            labels[arrays["edge"][:]] = names[sets[begins[tile] : begins[tile] + len(arrays["edge"])]]
            np.save(folder / f"{tile}.npy", labels)
            _rank_file(folder, tile).unlink(missing_ok=True)
    return total


def _links(left: BorderData, begins: dict[int, int]) -> NDArray[np.int64]:
    """Pairs of border clusters with a common point, (2, n)."""
    links = [np.empty((2, 0), np.int64)]
    for tile, arrays in left:
        owners = arrays["borrowed_tiles"][:]
        homes, cuts = np.unique(owners, return_index=True)
        for home, begin, end in zip(homes.tolist(), cuts.tolist(), [*cuts[1:].tolist(), len(owners)], strict=False):
            if home not in left:
                raise _disagreement(left, tile, home)
            other, keys = left[home], arrays["borrowed_keys"][begin:end]
            lent_keys = other["lent_keys"][:]
            at = np.searchsorted(lent_keys, keys)
            there = at < len(lent_keys)
            if not (there.all() and np.array_equal(lent_keys[at], keys)):
                raise _disagreement(left, tile, home)
            pairs = np.stack([arrays["borrowed"][begin:end] + begins[tile], other["lent"][:][at] + begins[home]])
            links.append(np.unique(pairs, axis=1))
    return np.concatenate(links, axis=1)


def _disagreement(left: BorderData, tile: int, home: int) -> FileError:
    reason = f"tiles {tile} and {home} differ at a common point: the files or the steps are not reproducible"
    return FileError(left.path, reason, remedy="Plan it again in another folder")


def _united(count: int, links: NDArray[np.int64]) -> NDArray[np.int32]:
    """Set index of each item. Linked items are in one set."""
    from scipy.sparse import coo_array  # slow import
    from scipy.sparse.csgraph import connected_components

    if not count:
        return np.empty(0, np.int32)
    graph = coo_array((np.ones(links.shape[1], np.int8), (links[0], links[1])), shape=(count, count))
    return connected_components(graph, directed=False)[1]


def _stretches(left: BorderData, groups: _Keys, total: int) -> list[tuple[Any, Any]]:
    """Parts of the key order of limited size, as (low, high), None at the ends."""
    if total <= MAX_RANKED:
        return [(None, None)]
    step = max(1, MAX_RANKED // (len(left.tiles) + 1))
    samples = [np.stack(groups)[:, ::step]]
    samples += [np.stack([arrays["majors"][::step], arrays["minors"][::step]]) for _, arrays in left]
    joined = np.concatenate(samples, axis=1)
    joined = joined[:, np.lexsort((joined[1], joined[0]))]
    cuts = [*map(tuple, joined.T[MAX_RANKED // step :: max(1, MAX_RANKED // step)].tolist())]
    return [*zip([None, *cuts], [*cuts, None], strict=True)]


def _count_before(keys: tuple[Any, Any], cut: tuple[int, int] | None, otherwise: int) -> int:
    """Number of keys before a cut."""
    if cut is None:
        return otherwise
    low, high = bisect_left(keys[0], cut[0]), bisect_right(keys[0], cut[0])
    return bisect_left(keys[1], cut[1], low, high)


def _rank_stretch(
    left: BorderData, folder: Path, groups: _Keys, named: tuple[Any, Any], stretch: tuple[Any, Any], begin: int
) -> int:
    """Number the clusters of a part from `begin` on, and append to `_rank_file`s. Returns the next number."""
    selected, names = named
    owners, lows, pieces = [], [], []
    for tile, keys in [(None, groups), *((tile, (arrays["majors"], arrays["minors"])) for tile, arrays in left)]:
        low, high = _count_before(keys, stretch[0], 0), _count_before(keys, stretch[1], len(keys[0]))
        if low < high:
            owners.append(tile)
            lows.append(low)
            pieces.append(np.stack([keys[0][low:high], keys[1][low:high]]))
    if not pieces:
        return begin
    joined = np.concatenate(pieces, axis=1)
    ranks = np.empty(joined.shape[1], np.int64)
    ranks[np.lexsort((joined[1], joined[0]))] = np.arange(begin, begin + len(ranks))
    at = 0
    for tile, low, piece in zip(owners, lows, pieces, strict=True):
        mine = slice(low, low + piece.shape[1])
        labels, at = ranks[at : at + piece.shape[1]], at + piece.shape[1]
        if tile is None:
            names[selected[mine]] = labels
        else:
            with _rank_file(folder, tile).open("ab") as file:
                file.write(labels.astype(names.dtype).tobytes())
    return begin + len(ranks)


def _rank_file(folder: Path, tile: int) -> Path:
    """The file with the numbers of a tile's complete clusters, in the order of their list."""
    return folder / f"{tile}.ranks"


def _read_ranks(path: Path, kind: Any, count: int) -> NDArray[Any]:
    if not count:
        return np.empty(0, kind)
    source, expected = open_source(path), count * np.dtype(kind).itemsize
    if len(source) != expected:
        raise changed_error(path, expected, len(source))
    return source.array(kind, count)

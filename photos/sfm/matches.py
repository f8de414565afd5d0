"""Which pictures see the same: features matched in pairs, and held against one motion of the camera, by COLMAP.

Which pictures look alike: by how their features fall around words learnt from the set itself (VLAD). Words are the
centres of k-means over a sample of the descriptors. A picture is described by the sum of what its descriptors are off
their nearest word, for each word (Jegou et al. 2010), with the square root of each number, its sign kept, and each
word's part brought to length one (Arandjelovic and Zisserman 2013).

All that is summed are whole numbers below 2^24 in float32, or 2^53 in float64, so that products of matrices are exact:
the same bits from run to run, for any number of threads and any BLAS.
"""

from __future__ import annotations

import contextlib
import dataclasses
import os
import shutil
import sqlite3
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.atomic import check_writable
from ...core.checks import check_count, check_progress, check_seed
from ...core.errors import FilePath
from ...core.progress import ReportProgress
from ...core.timing import Clock
from .colmap_jobs import MAX_SECONDS, count_rows, database_in_the_making, open_database, run_job
from .features import check_use_gpu, usable_cores
from .frames import check_option
from .limited_process import check_limits
from .picture_folder import check_place

Descriptors = NDArray[np.uint8]
WORDS = 64
NEIGHBOURS = 10  # pictures that each is matched to
LENGTH = 128  # of a SIFT descriptor
TURNS = 12  # of k-means: words move by less than a step of a byte after
SAMPLE = 30_000  # descriptors that words are learnt of, over all pictures
AT_ONCE = 1 << 15  # descriptors whose distances are held at a time
FINE = 4095  # steps of a number of a picture's description


def read_descriptors(database: Path) -> dict[int, Descriptors]:
    """The descriptors of the pictures of a database, uint8 [n, 128], by the pictures' numbers.

    Raises:
        FileError: No such database.
    """
    query = "SELECT image_id, rows, data FROM images LEFT JOIN descriptors USING (image_id) ORDER BY image_id"
    with open_database(database) as connection:
        rows = connection.execute(query).fetchall()
    return {
        number: np.frombuffer(data or b"", np.uint8).reshape(count or 0, -1 if count else LENGTH)
        for number, count, data in rows
    }


def nearest_words(descriptors: Descriptors, words: Descriptors) -> NDArray[np.int64]:
    """The nearest word of each descriptor, the first of several; exact."""
    w = words.astype(np.float32)
    lengths = (w * w).sum(axis=1, dtype=np.float32)
    found = [
        np.argmin(lengths - 2 * (descriptors[first : first + AT_ONCE].astype(np.float32) @ w.T), axis=1)
        for first in range(0, len(descriptors), AT_ONCE)
    ]
    return np.concatenate(found) if found else np.zeros(0, np.int64)


def learn_words(sets: Sequence[Descriptors], count: int, seed: int) -> Descriptors:
    """Centres of k-means (Lloyd 1982) over a sample of descriptors, rounded to bytes: uint8 [up to count, length].

    Example:
        >>> import numpy as np
        >>> two = np.repeat([[10] * 4, [200] * 4], 50, axis=0).astype(np.uint8)
        >>> sorted(learn_words([two], 2, seed=0)[:, 0].tolist())
        [10, 200]
    """
    rng = np.random.default_rng(seed)
    share = max(1, SAMPLE // max(len(sets), 1))
    taken = [each[np.sort(rng.permutation(len(each))[:share])] for each in sets]
    sample = np.concatenate(taken)
    different = np.unique(sample, axis=0)
    words = different[np.sort(rng.permutation(len(different))[:count])]
    for _ in range(TURNS if len(words) else 0):
        mine = nearest_words(sample, words)
        sums = _sums(sample, mine, len(words))
        sizes = np.bincount(mine, minlength=len(words))
        means = (2 * sums + sizes[:, None]) // np.maximum(2 * sizes[:, None], 1)
        words = np.where(sizes[:, None] > 0, means, words).astype(np.uint8)
    return words


def describe(descriptors: Descriptors, words: Descriptors) -> NDArray[np.float64]:
    """A picture's description as whole numbers, float64 [words * length]; zero of a picture without features."""
    mine = nearest_words(descriptors, words)
    off = _sums(descriptors, mine, len(words)) - np.bincount(mine, minlength=len(words))[:, None] * words.astype(int)
    rooted = np.sign(off) * np.sqrt(np.abs(off).astype(np.float64))
    # of a word's whole numbers the sum is exact, and so the rounding below is of the same number everywhere
    lengths = np.sqrt(np.abs(off).sum(axis=1).astype(np.float64))[:, None]
    return np.rint(FINE * rooted / np.maximum(lengths, 1.0)).ravel()


def alike_pictures(sets: Sequence[Descriptors], neighbours: int, *, seed: int, words: int = WORDS) -> list[list[int]]:
    """For each picture the others that look most like it, the most alike first.

    Args:
        sets: The descriptors of each picture, uint8 [n, length]; a picture without any has no others.
        neighbours: How many others, at most.
        seed: Of the words.
        words: How many are learnt.
    """
    learnt = learn_words(sets, words, seed)
    if not len(learnt):
        return [[] for _ in sets]
    table = np.stack([describe(each, learnt) for each in sets])
    alike = table @ table.T
    np.fill_diagonal(alike, -np.inf)
    empty = np.array([not len(each) for each in sets])
    alike[:, empty] = -np.inf
    order = np.argsort(-alike, axis=1, kind="stable")[:, :neighbours]
    return [[] if empty[i] else [int(j) for j in row if np.isfinite(alike[i, j])] for i, row in enumerate(order)]


def pairs_that_look_alike(database: Path, neighbours: int, *, seed: int) -> list[tuple[int, int]]:
    """Pairs of pictures of which one is among the most alike of the other, by their numbers, each once.

    Raises:
        FileError: No such database.
    """
    found = read_descriptors(database)
    numbers = list(found)
    alike = alike_pictures(list(found.values()), neighbours, seed=seed)
    both = [(numbers[i], numbers[j]) for i, row in enumerate(alike) for j in row]
    return sorted({(min(pair), max(pair)) for pair in both})


def _sums(values: Descriptors, groups: NDArray[np.int64], count: int) -> NDArray[np.int64]:
    order = np.argsort(groups, kind="stable")
    starts = np.searchsorted(groups[order], np.arange(count + 1))
    sums = np.zeros((count, values.shape[1]), np.int64)
    for k in range(count):
        sums[k] = values[order[starts[k] : starts[k + 1]]].sum(axis=0, dtype=np.int64)
    return sums


PAIRS = ("auto", "sequential", "exhaustive", "retrieval")
MIXED = "sequential and retrieval"
OVERLAP = 10
FEW_PICTURES = 40  # of which all 780 pairs are matched: less work than 150 pictures in a row

_PAIR = 2147483647  # COLMAP numbers the pair (a, b) as _PAIR a + b
_SIFT = 0  # COLMAP's number of that kind
_MOST_NEIGHBOURS = 10_000
_MOST_OVERLAP = 30  # powers of two


@dataclasses.dataclass(frozen=True)
class MatchReport:
    """Which pairs of pictures see the same.

    Args:
        database: Where it lies.
        pairs: "sequential", "exhaustive", "retrieval", or "sequential and retrieval".
        pair_count: Pairs that were tried.
        verified_count: Pairs of which one motion of the camera explains the matches.
        match_count: Matches of these.
        isolated: Names of pictures that are in none of them.
        seconds: Time it took [s].
        peak_bytes: The most memory that COLMAP was seen to hold [B].
    """

    database: str
    pairs: str
    pair_count: int
    verified_count: int
    match_count: int
    isolated: tuple[str, ...]
    seconds: float
    peak_bytes: int

    def to_dict(self) -> dict[str, Any]:
        """The same in JSON's types."""
        return dataclasses.asdict(self) | {"isolated": list(self.isolated)}


def match(
    database: FilePath,
    matches: FilePath,
    *,
    pairs: str = "auto",
    overlap: int = OVERLAP,
    neighbours: int = NEIGHBOURS,
    use_gpu: bool | None = None,
    seed: int = 0,
    max_seconds: float | None = MAX_SECONDS,
    max_memory: int | None = None,
    progress: ReportProgress | None = None,
) -> MatchReport:
    """Match the features of pairs of pictures, and keep what one motion of the camera explains.

    Args:
        database: Of `find_features`; it is not changed.
        matches: The file to write: the same database, with matches. One that is there is replaced.
        pairs: "sequential" for pictures in the order in which they were taken, as those of a video: each with some
            later ones; "exhaustive" for all pairs; "retrieval" for each with those that look most like it, whatever the
            order; "auto" for all pairs of up to 40 pictures, else sequential and by retrieval.
        overlap: Sequential: each picture is matched to so many later ones, those that are 1, 2, 4, 8, ... further on.
        neighbours: Retrieval: each picture is matched to so many that look most like it.
        use_gpu: As of `find_features`.
        seed: Of random numbers.
        max_seconds: It is given up after this time [s]; None for no limit.
        max_memory: Of COLMAP's process [B]; None for nine tenths of what is free.
        progress: Called with "pairs", how many are done, and how many there are.

    Returns:
        How many pairs see the same, and which pictures are in none.

    Raises:
        FileError: No such database; pycolmap is missing; COLMAP failed or passed a limit; a full disk.
        TypeError, ValueError: An argument out of range.

    Notes:
        The same matches from run to run, with any number of cores. Loops (a video that comes back to where it was)
        are found through the pictures of powers of two, and by looks: words are learnt from the features of the set
        itself (VLAD, Jegou et al. 2010), so that nothing has to be fetched.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.photos.sfm.matches import match
        >>> match("features.db", "matches.db")
        Traceback (most recent call last):
        pointloom.core.errors.FileError: features.db: does not exist. sfm.find_features makes one
    """
    clock, say = Clock(), check_progress(progress)
    check_option("pairs", pairs, PAIRS)
    check_count("overlap", overlap, maximum=_MOST_OVERLAP, because='pairs="exhaustive" takes all')
    check_count("neighbours", neighbours, maximum=_MOST_NEIGHBOURS, because='pairs="exhaustive" takes all')
    check_use_gpu(use_gpu)
    check_seed(seed)
    limits = check_limits(max_seconds, max_memory)
    source, target = check_place("database", database), check_writable(check_place("matches", matches))
    with open_database(source) as connection:
        (count,) = connection.execute("SELECT count(*) FROM images").fetchone()
    kind = _kind_of(source)
    pairs = _settled(pairs, kind, count)
    job: dict[str, Any] = {"stage": "matches", "pairs": pairs, "overlap": int(overlap), "seed": int(seed)}
    job |= {"threads": usable_cores(), "gpu": use_gpu, "kind": kind}
    with database_in_the_making(target) as part:
        shutil.copyfile(source, part)
        listed = _listed_pairs(source, pairs, overlap, neighbours, seed)
        if pairs in ("retrieval", MIXED):
            job |= {"list": os.fspath(part.with_name("pairs.txt"))}
            Path(job["list"]).write_text("".join(f"{a} {b}\n" for a, b in listed), encoding="ascii")
        pair_count = len(listed)
        say("pairs", 0, pair_count)
        poll = lambda: say("pairs", min(count_rows(part, "two_view_geometries"), pair_count), pair_count)  # noqa: E731
        with _named_by_numbers(part) if "list" in job else contextlib.nullcontext():
            _, peak = run_job(job | {"database": os.fspath(part)}, source, poll=poll, **limits)
        verified, match_count, isolated = _verified_pairs(part)
    say("pairs", pair_count, pair_count)
    clock.stop("pairs")
    seconds = clock.seconds["pairs"]
    return MatchReport(os.fspath(target), pairs, pair_count, verified, match_count, isolated, seconds, peak)


def _settled(pairs: str, kind: str, count: int) -> str:
    """Which pairs "auto" means; words are learnt of SIFT's bytes, so that retrieval goes by these alone.

    Raises:
        ValueError: Retrieval by other features.
    """
    if pairs == "auto" and count <= FEW_PICTURES:
        return "exhaustive"
    if pairs == "auto":
        return MIXED if kind == "sift" else "sequential"
    if pairs == "retrieval" and kind != "sift":
        raise ValueError(f"pairs: retrieval goes by SIFT features, and these are {kind}; take sequential or exhaustive")
    return pairs


def _kind_of(database: Path) -> str:
    with open_database(database) as connection:
        columns = {row[1] for row in connection.execute("PRAGMA table_info(descriptors)")}
        if "type" not in columns:
            return "sift"
        types = {row[0] for row in connection.execute("SELECT DISTINCT type FROM descriptors")}
    return "aliked" if types - {_SIFT, None} else "sift"


def _listed_pairs(database: Path, pairs: str, overlap: int, neighbours: int, seed: int) -> NDArray[np.int64]:
    """The numbers of the pictures of all pairs, [p, 2]."""
    if pairs not in ("retrieval", MIXED):
        return pairs_of(database, pairs, overlap)
    chosen = set(pairs_that_look_alike(database, neighbours, seed=seed))
    if pairs == MIXED:
        chosen |= {(int(a), int(b)) for a, b in pairs_of(database, "sequential", overlap)}
    return np.array(sorted(chosen), np.int64).reshape(-1, 2)


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


@contextlib.contextmanager
def _named_by_numbers(database: Path) -> Iterator[None]:
    """Pictures are called by their numbers while COLMAP reads a list of pairs, which cannot hold names with blanks."""
    with contextlib.closing(sqlite3.connect(database)) as connection:
        names = connection.execute("SELECT name, image_id FROM images").fetchall()
        connection.execute("UPDATE images SET name = image_id")
        connection.commit()
    yield
    with contextlib.closing(sqlite3.connect(database)) as connection:
        connection.executemany("UPDATE images SET name = ? WHERE image_id = ?", names)
        connection.commit()


def _verified_pairs(database: Path) -> tuple[int, int, tuple[str, ...]]:
    """How many pairs have matches that agree, how many those are, and the pictures that are in no such pair."""
    with open_database(database) as connection:
        rows = connection.execute("SELECT pair_id, rows FROM two_view_geometries WHERE rows > 0").fetchall()
        names = dict(connection.execute("SELECT image_id, name FROM images ORDER BY image_id").fetchall())
    paired = {number for pair, _ in rows for number in divmod(pair, _PAIR)}
    isolated = tuple(name for number, name in names.items() if number not in paired)
    return len(rows), sum(count for _, count in rows), isolated

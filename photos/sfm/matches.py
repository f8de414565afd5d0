"""Which pictures see the same: features matched in pairs, and held against one motion of the camera, by COLMAP."""

from __future__ import annotations

import contextlib
import dataclasses
import os
import shutil
import sqlite3
from collections.abc import Iterator
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
from .retrieval import NEIGHBOURS, pairs_that_look_alike

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
    """What the features of a database are."""
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

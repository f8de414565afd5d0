"""Which pictures see the same: features matched in pairs, and held against one motion of the camera, by COLMAP."""

from __future__ import annotations

import dataclasses
import os
import shutil
from pathlib import Path
from typing import Any

from ...core.atomic import check_writable
from ...core.checks import check_count, check_progress, check_seed
from ...core.devices import resolve_device
from ...core.errors import FilePath
from ...core.progress import ReportProgress
from ...core.timing import Clock
from .colmap_jobs import MAX_SECONDS, count_rows, database_in_the_making, open_database, run_job
from .features import usable_cores
from .frames import check_option
from .limited_process import check_limits
from .own_features import FINDERS, match_own, pairs_of
from .picture_folder import check_place

PAIRS = ("auto", "sequential", "exhaustive")
OVERLAP = 10
FEW_PICTURES = 40  # of which all 780 pairs are matched: less work than 150 pictures in a row

_PAIR = 2147483647  # COLMAP numbers the pair (a, b) as _PAIR a + b
_MOST_OVERLAP = 30  # powers of two


@dataclasses.dataclass(frozen=True)
class MatchReport:
    """Which pairs of pictures see the same.

    Args:
        database: Where it lies.
        pairs: "sequential" or "exhaustive".
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

    def to_json(self) -> dict[str, Any]:
        """The same in JSON's types."""
        return dataclasses.asdict(self) | {"isolated": list(self.isolated)}


def match(
    database: FilePath,
    matches: FilePath,
    *,
    pairs: str = "auto",
    overlap: int = OVERLAP,
    finder: str = "colmap",
    device: Any = None,
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
            later ones; "exhaustive" for all pairs; "auto" for all pairs of up to 40 pictures, else sequential.
        overlap: Sequential: each picture is matched to so many later ones, those that are 1, 2, 4, 8, ... further on.
        finder: Who finds the matches: "colmap", approximately, or "pointloom", our own kernels, which compare all. In
            either case COLMAP holds them against one motion of the camera.
        device: Where our own kernels compute; None for the CPU.
        seed: Of random numbers.
        max_seconds: It is given up after this time [s]; None for no limit.
        max_memory: Of COLMAP's process [B]; None for nine tenths of what is free.
        progress: Called with "pairs", how many are done, and how many there are.

    Returns:
        How many pairs see the same, and which pictures are in none.

    Raises:
        FileError: No such database; pycolmap is missing; COLMAP failed or passed a limit; a full disk.
        TypeError, ValueError: An argument out of range.
        DeviceError: No such device.

    Notes:
        The same matches from run to run, with any number of cores. Loops (a video that comes back to where it was)
        are found through the pictures of powers of two and through all pairs, not by looks: COLMAP's vocabulary for
        that would have to be fetched from the network.

    Example:
        >>> import pointloom as loom
        >>> loom.sfm.match("features.db", "matches.db")
        Traceback (most recent call last):
        pointloom.core.errors.FileError: features.db: does not exist. sfm.find_features makes one
    """
    clock, say = Clock(), check_progress(progress)
    check_option("pairs", pairs, PAIRS)
    check_count("overlap", overlap, maximum=_MOST_OVERLAP, because='pairs="exhaustive" takes all')
    check_seed(seed)
    target_device = resolve_device(device) if check_option("finder", finder, FINDERS) == "pointloom" else None
    limits = check_limits(max_seconds, max_memory)
    source, target = check_place("database", database), check_writable(check_place("matches", matches))
    with open_database(source) as connection:
        (count,) = connection.execute("SELECT count(*) FROM images").fetchone()
    if pairs == "auto":
        pairs = "exhaustive" if count <= FEW_PICTURES else "sequential"
    pair_count = count * (count - 1) // 2 if pairs == "exhaustive" else _sequential_pairs(count, overlap)
    job: dict[str, Any] = {
        "stage": "matches",
        "pairs": pairs,
        "overlap": int(overlap),
        "seed": int(seed),
        "threads": usable_cores(),
    }
    with database_in_the_making(target) as part:
        shutil.copyfile(source, part)
        say("pairs", 0, pair_count)
        if target_device is not None:
            job["found"] = os.fspath(part.parent / "found")
            common = {"device": target_device, "max_seconds": limits["max_seconds"], "progress": say}
            match_own(source, pairs_of(source, pairs, overlap), Path(job["found"]), **common)
        poll = lambda: say("pairs", min(count_rows(part, "two_view_geometries"), pair_count), pair_count)  # noqa: E731
        _, peak = run_job(job | {"database": os.fspath(part)}, source, poll=poll, **limits)
        verified, match_count, isolated = _verified_pairs(part)
    say("pairs", pair_count, pair_count)
    clock.stop("pairs")
    seconds = clock.seconds["pairs"]
    return MatchReport(os.fspath(target), pairs, pair_count, verified, match_count, isolated, seconds, peak)


def _sequential_pairs(count: int, overlap: int) -> int:
    """Pairs of pictures that are 1, 2, 4, ... apart."""
    return sum(max(count - (1 << power), 0) for power in range(overlap))


def _verified_pairs(database: Path) -> tuple[int, int, tuple[str, ...]]:
    """How many pairs have matches that agree, how many those are, and the pictures that are in no such pair."""
    with open_database(database) as connection:
        rows = connection.execute("SELECT pair_id, rows FROM two_view_geometries WHERE rows > 0").fetchall()
        names = dict(connection.execute("SELECT image_id, name FROM images ORDER BY image_id").fetchall())
    paired = {number for pair, _ in rows for number in divmod(pair, _PAIR)}
    isolated = tuple(name for number, name in names.items() if number not in paired)
    return len(rows), sum(count for _, count in rows), isolated

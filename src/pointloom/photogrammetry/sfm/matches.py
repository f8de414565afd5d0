"""Feature matching of image pairs with geometric verification by COLMAP, and image retrieval.

Retrieval uses VLAD (Jegou et al. 2010) with words learned from the images, and the normalization of Arandjelovic and
Zisserman 2013. All sums are integers below 2^24 in float32 or 2^53 in float64, hence exact and bitwise reproducible.
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
from ...core.checks import check_progress
from ...core.errors import FileError, FilePath
from ...core.escaped_text import escaped
from ...core.progress import ReportProgress
from ...core.reports import Assessed, quality
from ...core.timing import Clock
from .colmap_jobs import count_rows, database_in_the_making, names_by_number, open_database, run_job
from .features import usable_cores
from .image_folder import check_path
from .image_writing import some_of
from .limited_process import check_limits
from .settings import SfmSettings, check_settings

Descriptors = NDArray[np.uint8]
VOCABULARY_SIZE = 64
DESCRIPTOR_LENGTH = 128  # length of a SIFT descriptor
MAX_ITERATIONS = 12  # k-means iterations: words then move by less than one integer step
MAX_CLUSTERED_DESCRIPTORS = 30_000  # descriptors for k-means over all images
AT_ONCE = 1 << 15  # descriptors per distance block
QUANTIZATION_STEPS = 4095  # quantization steps of a description


def read_descriptors(database: Path) -> dict[int, Descriptors]:
    query = "SELECT image_id, rows, data FROM images LEFT JOIN descriptors USING (image_id) ORDER BY image_id"
    descriptors = {}
    with open_database(database) as connection:
        for number, count, data in connection.execute(query):
            values = np.frombuffer(data or b"", np.uint8)
            if len(values) != DESCRIPTOR_LENGTH * (count or 0):
                reason = f"is damaged: expected {count} descriptors of image {number}, got {len(values)} bytes"
                raise FileError(database, reason, remedy="photogrammetry.find_features creates one")
            descriptors[int(number)] = values.reshape(-1, DESCRIPTOR_LENGTH)
    return descriptors


def nearest_words(descriptors: Descriptors, words: Descriptors) -> NDArray[np.int64]:
    """The nearest word of each descriptor, the first of ties. Exact."""
    w = words.astype(np.float32)
    lengths = (w * w).sum(axis=1, dtype=np.float32)
    indices = [
        np.argmin(lengths - 2 * (descriptors[first : first + AT_ONCE].astype(np.float32) @ w.T), axis=1)
        for first in range(0, len(descriptors), AT_ONCE)
    ]
    return np.concatenate(indices) if indices else np.zeros(0, np.int64)


def learn_words(sets: Sequence[Descriptors], count: int, seed: int) -> Descriptors:
    """k-means centers (Lloyd 1982) of a sample of descriptors, rounded to uint8 [up to count, length]."""
    rng = np.random.default_rng(seed)
    fraction = max(1, MAX_CLUSTERED_DESCRIPTORS // max(len(sets), 1))
    taken = [each[np.sort(rng.permutation(len(each))[:fraction])] for each in sets]
    sample = np.concatenate(taken)
    different = np.unique(sample, axis=0)
    words = different[np.sort(rng.permutation(len(different))[:count])]
    for _ in range(MAX_ITERATIONS if len(words) else 0):
        mine = nearest_words(sample, words)
        sums = _sums(sample, mine, len(words))
        sizes = np.bincount(mine, minlength=len(words))
        means = (2 * sums + sizes[:, None]) // np.maximum(2 * sizes[:, None], 1)
        words = np.where(sizes[:, None] > 0, means, words).astype(np.uint8)
    return words


def describe(descriptors: Descriptors, words: Descriptors) -> NDArray[np.float64]:
    """VLAD description of an image as integers, float64 [words * length]. Zero without features."""
    mine = nearest_words(descriptors, words)
    off = _sums(descriptors, mine, len(words)) - np.bincount(mine, minlength=len(words))[:, None] * words.astype(int)
    rooted = np.sign(off) * np.sqrt(np.abs(off).astype(np.float64))
    # integer sums per word are exact, so the rounding below is the same everywhere
    lengths = np.sqrt(np.abs(off).sum(axis=1).astype(np.float64))[:, None]
    return np.rint(QUANTIZATION_STEPS * rooted / np.maximum(lengths, 1.0)).ravel()


def alike_images(
    sets: Sequence[Descriptors], neighbors: int, *, seed: int, words: int = VOCABULARY_SIZE
) -> list[list[int]]:
    """Up to `neighbors` most similar other images for each, by descriptors uint8 [n, length], the best first."""
    if not sets:
        return []
    learned = learn_words(sets, words, seed)
    if not len(learned):
        return [[] for _ in sets]
    table = np.stack([describe(each, learned) for each in sets])
    alike = table @ table.T
    np.fill_diagonal(alike, -np.inf)
    empty = np.array([not len(each) for each in sets])
    alike[:, empty] = -np.inf
    order = np.argsort(-alike, axis=1, kind="stable")[:, :neighbors]
    return [[] if empty[i] else [int(j) for j in row if np.isfinite(alike[i, j])] for i, row in enumerate(order)]


def pairs_that_look_alike(database: Path, neighbors: int, *, seed: int) -> list[tuple[int, int]]:
    descriptors = read_descriptors(database)
    numbers = list(descriptors)
    alike = alike_images(list(descriptors.values()), neighbors, seed=seed)
    both = [(numbers[i], numbers[j]) for i, row in enumerate(alike) for j in row]
    return sorted({(min(pair), max(pair)) for pair in both})


def _sums(values: Descriptors, groups: NDArray[np.int64], count: int) -> NDArray[np.int64]:
    order = np.argsort(groups, kind="stable")
    starts = np.searchsorted(groups[order], np.arange(count + 1))
    sums = np.zeros((count, values.shape[1]), np.int64)
    for k in range(count):
        sums[k] = values[order[starts[k] : starts[k + 1]]].sum(axis=0, dtype=np.int64)
    return sums


MIXED = "sequential and retrieval"
FEW_IMAGES = 40  # maximum for exhaustive matching (780 pairs): less work than 150 sequential images

PAIR_ID_FACTOR = 2147483647  # COLMAP's id of the pair (a, b) is PAIR_ID_FACTOR a + b
_SIFT_TYPE = 0  # COLMAP's id of the feature type


@dataclasses.dataclass(frozen=True)
class MatchReport(Assessed):
    """Result of `match_features`.

    Args:
        database: Path of the database.
        pairs: "sequential", "exhaustive", "retrieval", or "sequential and retrieval".
        pair_count: Number of pairs tried.
        verified_count: Pairs with geometrically verified matches.
        match_count: Verified matches.
        isolated: Names of images without a verified pair.
        seconds: Run time [s].
        peak_bytes: Peak memory of COLMAP [B].
        image_count: Number of images. 0 if unknown.
    """

    database: str
    pairs: str
    pair_count: int
    verified_count: int
    match_count: int
    isolated: tuple[str, ...]
    seconds: float
    peak_bytes: int
    image_count: int = 0

    @property
    def warnings(self) -> tuple[str, ...]:
        """Failed quality checks. Empty if the result is reliable."""
        if not self.isolated:
            return ()
        count = f"{len(self.isolated)} of {self.image_count}" if self.image_count else f"{len(self.isolated)}"
        return (
            f"{count} images have no verified matches ({escaped(some_of(list(self.isolated)))}), so they cannot get a "
            "pose: take images that overlap by two thirds, or use pairs='exhaustive'",
        )

    def to_dict(self) -> dict[str, Any]:
        return dataclasses.asdict(self) | {"isolated": list(self.isolated), **quality(self)}


def match_features(
    database: FilePath,
    matches: FilePath,
    settings: SfmSettings | None = None,
    *,
    progress: ReportProgress | None = None,
) -> MatchReport:
    """Match the features of image pairs, with geometric verification.

    Args:
        database: Of `find_features`. Not modified.
        matches: Output file: the database with matches; replaced if it exists.
        settings: Pairs and limits; None: the defaults.
        progress: Called with ("pairs", done, all).

    Returns:
        The number of verified pairs, and the images without any, which make it unreliable.

    Raises:
        FileError: No such database, pycolmap is missing, COLMAP failed or passed a limit, or the disk is full.
        TypeError, ValueError: An argument is out of range.

    Notes:
        Reproducible for any number of cores. Loops of a video are found through the distant images and by retrieval
        (VLAD, Jegou et al. 2010), whose words are learned from the images, so nothing is downloaded.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.photogrammetry.sfm.matches import match_features
        >>> match_features("features.db", "matches.db")
        Traceback (most recent call last):
        pointloom.core.errors.FileError: features.db: does not exist. photogrammetry.find_features creates one
    """
    clock, report, settings = Clock(), check_progress(progress), check_settings(settings)
    source, target = check_path("database", database), check_writable(check_path("matches", matches))
    with open_database(source) as connection:
        count = len(names_by_number(connection, source))
    kind = _kind_of(source)
    pairs, seed = _resolved_pairs(settings.pairs, kind, count), int(settings.seed)
    job: dict[str, Any] = {"stage": "matches", "pairs": pairs, "overlap": int(settings.overlap), "seed": seed}
    job |= {"threads": usable_cores(), "gpu": settings.use_gpu, "kind": kind}
    limits = check_limits(settings.max_seconds, settings.max_memory)
    with database_in_the_making(target) as part:
        shutil.copyfile(source, part)
        listed = _listed_pairs(source, pairs, settings)
        if pairs in ("retrieval", MIXED):
            job |= {"list": os.fspath(part.with_name("pairs.txt"))}
            Path(job["list"]).write_text("".join(f"{a} {b}\n" for a, b in listed), encoding="ascii")
        pair_count = len(listed)
        report("pairs", 0, pair_count)
        poll = lambda: report("pairs", min(count_rows(part, "two_view_geometries"), pair_count), pair_count)  # noqa: E731
        with _named_by_numbers(part) if "list" in job else contextlib.nullcontext():
            _, peak = run_job(job | {"database": os.fspath(part)}, source, poll=poll, **limits)
        verified, match_count, isolated = _verified_pairs(part)
    report("pairs", pair_count, pair_count)
    clock.stop("pairs")
    seconds = clock.seconds["pairs"]
    return MatchReport(os.fspath(target), pairs, pair_count, verified, match_count, isolated, seconds, peak, count)


def _resolved_pairs(pairs: str, kind: str, count: int) -> str:
    if pairs == "auto" and count <= FEW_IMAGES:
        return "exhaustive"
    if pairs == "auto":
        return MIXED if kind == "sift" else "sequential"
    if pairs == "retrieval" and kind != "sift":
        raise ValueError(f"pairs: retrieval requires SIFT features, got {kind}; use sequential or exhaustive")
    return pairs


def _kind_of(database: Path) -> str:
    with open_database(database) as connection:
        columns = {row[1] for row in connection.execute("PRAGMA table_info(descriptors)")}
        if "type" not in columns:
            return "sift"
        types = {row[0] for row in connection.execute("SELECT DISTINCT type FROM descriptors")}
    return "aliked" if types - {_SIFT_TYPE, None} else "sift"


def _listed_pairs(database: Path, pairs: str, settings: SfmSettings) -> NDArray[np.int64]:
    if pairs not in ("retrieval", MIXED):
        return pairs_of(database, pairs, settings.overlap)
    chosen = set(pairs_that_look_alike(database, settings.neighbors, seed=settings.seed))
    if pairs == MIXED:
        chosen |= {(int(a), int(b)) for a, b in pairs_of(database, "sequential", settings.overlap)}
    return np.array(sorted(chosen), np.int64).reshape(-1, 2)


def pairs_of(database: Path, pairs: str, overlap: int) -> NDArray[np.int64]:
    """Image numbers of all pairs, or of those 1, 2, 4, ... apart in the order of names: [p, 2]."""
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
    """Rename images to numbers while COLMAP reads a pair list, which does not support names with blanks."""
    with contextlib.closing(sqlite3.connect(database)) as connection:
        names = connection.execute("SELECT name, image_id FROM images").fetchall()
        connection.execute("UPDATE images SET name = image_id")
        connection.commit()
    yield
    with contextlib.closing(sqlite3.connect(database)) as connection:
        connection.executemany("UPDATE images SET name = ? WHERE image_id = ?", names)
        connection.commit()


def _verified_pairs(database: Path) -> tuple[int, int, tuple[str, ...]]:
    with open_database(database) as connection:
        rows = connection.execute("SELECT pair_id, rows FROM two_view_geometries WHERE rows > 0").fetchall()
        names = names_by_number(connection, database)
        paired = {number for pair, _ in rows for number in divmod(pair, PAIR_ID_FACTOR)}
        match_count = sum(count for _, count in rows)
    isolated = tuple(name for number, name in names.items() if number not in paired)
    return len(rows), match_count, isolated

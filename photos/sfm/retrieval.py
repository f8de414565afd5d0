"""Which pictures look alike: by how their features fall around words learnt from the set itself (VLAD).

Words are the centres of k-means over a sample of the descriptors. A picture is described by the sum of what its
descriptors are off their nearest word, for each word (Jegou et al. 2010), with the square root of each number, its sign
kept, and each word's part brought to length one (Arandjelovic and Zisserman 2013).

All that is summed are whole numbers below 2^24 in float32, or 2^53 in float64, so that products of matrices are exact:
the same bits from run to run, for any number of threads and any BLAS.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from .colmap_jobs import open_database

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

"""The names that a user means: names of the same words, with more words, or with a misspelled letter.

Words with the same meaning are rows of `common.words` in common_names.toml.
"""

from __future__ import annotations

import functools
import re
from collections.abc import Iterable

from .open3d_names import COMMON, sections

LETTERS_PER_ERROR = 10  # [1] a longer name may differ by two letters, a shorter one by one: see `_is_misspelled`
MIN_PREFIX = 5  # letters of a shortened name
MIN_STEM = 3  # letters
ENDINGS = r"(?<=iz)ations?$|(?:ation|ion|ing|ed|e|s)$"
MIN_MISSPELLED = 3  # letters
MAX_NAMES = 3  # in a message


def same_names(name: str, known: Iterable[str]) -> list[str]:
    """The known names of the same words in any order and spelling, the most similar first.

    `computeCentroid` is `get_center`.
    """
    words, letters = words_of(name), joined(name)
    same = [other for other in known if words_of(other) == words or joined(other) == letters]
    return sorted(same, key=lambda other: -_ratio(name, other))


def near_names(name: str, known: Iterable[str]) -> list[str]:
    """At most three known names of the same words, else with more words, misspelled, or with fewer words.

    The most similar is first. Names that only share letters are not proposed: such hints were often wrong.
    """
    known = [other for other in known if not other.startswith("_")]
    groups = (
        [other for other in known if joined(other).rstrip("s") == joined(name).rstrip("s")],
        same_names(name, known),
        [other for other in known if _is_shortened(name, other)],
        [other for other in known if _is_misspelled(name, other)],
        [other for other in known if _is_lengthened(name, other)],
    )
    found = next((group for group in groups if group), [])
    return sorted(found, key=lambda other: (-_ratio(name, other), other))[:MAX_NAMES]


def row_of_words(name: str, among: Iterable[str]) -> str | None:
    """As `row_of`, for a name with the words of a row: `curvatures`, `DBScan`."""
    for section in among:
        for patterns, row in sections().get(section, {}).items():
            if same_names(name, (pattern for pattern in patterns.split(", ") if "*" not in pattern)):
                return row
    return None


@functools.lru_cache(4096)
def words_of(name: str) -> tuple[str, ...]:
    """Sorted stems of the words of a name, one stem for each meaning, without words like `compute` or `from`."""
    plain = [_stem(part.lower()) for part in re.findall(r"\d[dD](?![a-z])|[A-Z]+(?![a-z])|[A-Z]?[a-z]+|\d+", name)]
    words = [word for part in plain for word in _vocabulary().get(part, part).split()]
    return tuple(sorted(words or plain))


@functools.lru_cache(4096)
def joined(name: str) -> str:
    return re.sub(r"[\W_]", "", name).lower()


@functools.lru_cache(4096)
def _stem(word: str) -> str:
    """A word without endings: `segmentation` and `segments` are `segment`."""
    word = re.sub(r"ies$", "y", word)
    while (match := re.search(ENDINGS, word)) and match.start() >= MIN_STEM and not word.endswith("ss"):
        word = word[: match.start()]
    return word


@functools.cache
def _vocabulary() -> dict[str, str]:
    rows = sections()[f"{COMMON}.words"].items()
    return {_stem(word): " ".join(map(_stem, row.split())) for words, row in rows for word in words.split(", ")}


def _is_shortened(name: str, other: str) -> bool:
    """True if a name has at least half of the words of another, and no other word, or is its beginning."""
    words, others = set(words_of(name)), set(words_of(other))
    is_long = 2 * len(joined(name)) >= max(len(joined(other)), 2 * MIN_PREFIX)
    is_start = other.startswith(f"{name}_") or (is_long and joined(other).startswith(joined(name)))
    return (bool(words) and words <= others and 2 * len(words) >= len(others)) or is_start


def _is_lengthened(name: str, other: str) -> bool:
    """True if at least two words of another name are two thirds of the words, and both are functions or classes."""
    words, others = set(words_of(name)), set(words_of(other))
    is_kind = name[:1].isupper() == other[:1].isupper()
    return is_kind and len(others) >= 2 and others < words and 3 * len(others) >= 2 * len(words)


def _is_misspelled(name: str, other: str) -> bool:
    """True if a letter after the first is wrong, missing, additional or exchanged, or two of a long name."""
    first, second = joined(name), joined(other)
    if min(len(first), len(second)) < MIN_MISSPELLED or first[0] != second[0]:
        return False
    limit = 1 + (min(len(first), len(second)) >= LETTERS_PER_ERROR)
    return abs(len(first) - len(second)) <= limit and _edits(first, second) <= limit


def _edits(first: str, second: str) -> int:
    """Number of wrong, missing, additional and exchanged letters (optimal string alignment)."""
    rows = [list(range(len(second) + 1))]
    for i, a in enumerate(first, 1):
        row = [i]
        for j, b in enumerate(second, 1):
            row.append(min(rows[-1][j] + 1, row[-1] + 1, rows[-1][j - 1] + (a != b)))
            if i > 1 and j > 1 and a == second[j - 2] and first[i - 2] == b:
                row[j] = min(row[j], rows[-2][j - 2] + 1)
        rows.append(row)
    return rows[-1][-1]


def _ratio(name: str, other: str) -> float:
    from difflib import SequenceMatcher  # imported only for errors

    return SequenceMatcher(None, joined(name), joined(other)).ratio()

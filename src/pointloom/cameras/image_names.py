"""Resolve references to images: by file name, with or without folder and extension, or by number."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any


def number_of(name: str) -> int | None:
    """The number at the end of an image name, without extension.

    Example:
        >>> number_of("left/frame_000012.png"), number_of("porch.jpg")
        (12, None)
    """
    match = re.search(r"(?<!\d)(\d++)$", Path(name).stem)
    return int(match[1]) if match else None


def _own_stem(name: str) -> str:
    """Without the number that `choose_frames` prepends to photographs ("0003_garden.jpg")."""
    return re.sub(r"^\d{4,}_(?=.)", "", Path(name).stem)


# From strict to loose. The first rule with a match wins.
_WAYS: tuple[Callable[[str], str], ...] = (
    str,
    lambda name: str(Path(name).with_suffix("")) if name else name,
    lambda name: Path(name).name,
    lambda name: Path(name).stem,
    _own_stem,
)


class ImageNames:
    """Names of images, to be found by other names of them or by numbers.

    Example:
        >>> names = ImageNames(["0000_IMG_9.jpg", "0001_porch.jpg", "left/0002_porch.png"])
        >>> names.matching("IMG_9"), names.matching("IMG_9.JPG"), names.matching("porch")
        ([0], [0], [1, 2])
    """

    def __init__(self, names: Sequence[str]):
        self._names = names
        self._indices: dict[Callable[[str], Any], dict[Any, list[int]]] = {}  # by rule and its result

    def matching(self, query: str) -> list[int]:
        """Indices of the images that match a name or number. Several if ambiguous."""
        for way in _WAYS:
            if matches := self._find(way, query):
                return matches
        if query and (matches := self._find(_own_stem, Path(query).stem)):
            return matches
        return self._find(number_of, int(query)) if re.fullmatch(r"\d+", query) else []

    def _find(self, way: Callable[[str], Any], key: str | int) -> list[int]:
        if way not in self._indices:
            self._indices[way] = {}
            for k, name in enumerate(self._names):
                self._indices[way].setdefault(way(name), []).append(k)
        return self._indices[way].get(key, [])


def matching_images(query: str, names: Sequence[str]) -> list[int]:
    """Indices of the images that match one query. Use `ImageNames` for several."""
    return ImageNames(names).matching(query)

"""Resolve references to images: by file name, with or without folder and extension, or by number."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from pathlib import Path


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


def matching_pictures(query: str, names: Sequence[str]) -> list[int]:
    """Indices of the images that match a name or number. Several if ambiguous.

    Example:
        >>> names = ["0000_IMG_9.jpg", "0001_porch.jpg", "left/0002_porch.png"]
        >>> matching_pictures("IMG_9", names), matching_pictures("IMG_9.JPG", names), matching_pictures("porch", names)
        ([0], [0], [1, 2])
    """
    for way in _WAYS:
        if matches := [k for k, name in enumerate(names) if way(name) == query]:
            return matches
    if matches := [k for k, name in enumerate(names) if query and _own_stem(name) == Path(query).stem]:
        return matches
    if re.fullmatch(r"\d+", query):
        return [k for k, name in enumerate(names) if number_of(name) == int(query)]
    return []

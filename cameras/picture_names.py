"""How people call pictures: by the file's name, with or without its folder and ending, or by the number in it."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from pathlib import Path


def number_of(name: str) -> int | None:
    """The number at the end of a picture's name, without the ending.

    Example:
        >>> number_of("left/frame_000012.png"), number_of("porch.jpg")
        (12, None)
    """
    match = re.search(r"(?<!\d)(\d++)$", Path(name).stem)
    return int(match[1]) if match else None


def _own_stem(name: str) -> str:
    """Without the number that `choose_frames` sets before the names of photographs ("0003_garden.jpg")."""
    return re.sub(r"^\d{4,}_(?=.)", "", Path(name).stem)


# From the strictest to the loosest: what is meant by one of them is not looked for by the next.
_WAYS: tuple[Callable[[str], str], ...] = (
    str,
    lambda name: str(Path(name).with_suffix("")) if name else name,
    lambda name: Path(name).name,
    lambda name: Path(name).stem,
    _own_stem,
)


def meant_pictures(said: str, names: Sequence[str]) -> list[int]:
    """The places of the pictures that may be meant by what somebody says.

    Args:
        said: A name, with or without folders and ending, the name that a photograph came with, or a number.
        names: Of the pictures.

    Returns:
        None, one, or several where it is not clear.

    Example:
        >>> names = ["0000_IMG_9.jpg", "0001_porch.jpg", "left/0002_porch.png"]
        >>> meant_pictures("IMG_9", names), meant_pictures("IMG_9.JPG", names), meant_pictures("porch", names)
        ([0], [0], [1, 2])
    """
    for way in _WAYS:
        if found := [k for k, name in enumerate(names) if way(name) == said]:
            return found
    if found := [k for k, name in enumerate(names) if said and _own_stem(name) == Path(said).stem]:
        return found
    if re.fullmatch(r"\d+", said):
        return [k for k, name in enumerate(names) if number_of(name) == int(said)]
    return []

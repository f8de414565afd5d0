"""The letters of pictures: `Lettering`, a table of their coverage drawn beforehand (glyphs.npz, glyphs.md).

A picture with text is then the same bits on every machine: no font is asked for when it is made.
"""

from __future__ import annotations

import functools
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...kernels.lang import uint8
from ...kernels.memory import upload

UNKNOWN = "\ufffd"  # the letter for what the table does not hold: a box
_FILE = Path(__file__).with_name("glyphs.npz")


class Lettering:
    """Letters in some sizes: those of ASCII, degree, micro, times, plus-minus, squares, dashes and dots."""

    def __init__(self, path: Path = _FILE):
        with np.load(path) as table:
            self.coverage, self._glyphs = table["coverage"], table["glyphs"]
            self.sizes = table["sizes"]
            self._places = {chr(code): place for place, code in enumerate(table["codes"].tolist())}
        self._on_devices: dict[str, Any] = {}

    def atlas(self, device: Any) -> Any:
        """The coverage of all letters on a device."""
        key = str(device)
        if key not in self._on_devices:
            self._on_devices[key] = upload(self.coverage, uint8, device)
        return self._on_devices[key]

    def width(self, text: str, size: float) -> int:
        """How wide a text is [px]."""
        return int(self._rows(text, size)[:, 5].sum())

    def cap_height(self, size: float) -> int:
        """How high a capital letter is [px]."""
        return -int(self._rows("H", size)[0, 4])

    def set(self, text: str, size: float) -> NDArray[np.int32]:
        """Where letters come to stand: rows (place in the atlas, width, height, column, row) from the pen on.

        Rows are counted from the baseline, downwards; blanks have no row.
        """
        glyphs = self._rows(text, size)
        pens = np.cumsum(glyphs[:, 5]) - glyphs[:, 5]
        placed = np.column_stack([glyphs[:, :3], glyphs[:, 3] + pens, glyphs[:, 4]])
        return placed[glyphs[:, 1] > 0].astype(np.int32)

    def _rows(self, text: str, size: float) -> NDArray[np.int32]:
        table = self._glyphs[int(np.abs(self.sizes - size).argmin())]
        unknown = self._places[UNKNOWN]
        return table[[self._places.get(character, unknown) for character in " ".join(text.split("\n"))]]


@functools.cache
def lettering() -> Lettering:
    """The letters, read once."""
    return Lettering()

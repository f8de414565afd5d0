"""Letters on images: `Lettering`, a pre-rendered coverage table (glyphs.npz, glyphs.md).

No system font is used, so images with text are bitwise identical on every machine.
"""

from __future__ import annotations

import functools
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...kernels.lang import uint8
from ...kernels.memory import upload

UNKNOWN = "\ufffd"  # drawn as a box for missing letters
_FILE = Path(__file__).with_name("glyphs.npz")


class Lettering:
    """Letters in several sizes: ASCII, degree, micro, times, plus-minus, squares, dashes and dots."""

    def __init__(self, path: Path = _FILE):
        with np.load(path) as table:
            self.coverage, self._glyphs = table["coverage"], table["glyphs"]
            self.sizes = table["sizes"]
            self._indices = {chr(code): index for index, code in enumerate(table["codes"].tolist())}
        self._on_devices: dict[str, Any] = {}

    def atlas(self, device: Any) -> Any:
        """Coverage of all letters on a device."""
        key = str(device)
        if key not in self._on_devices:
            self._on_devices[key] = upload(self.coverage, uint8, device)
        return self._on_devices[key]

    def width(self, text: str, size: float) -> int:
        return int(self._rows(text, size)[:, 5].sum())

    def cap_height(self, size: float) -> int:
        return -int(self._rows("H", size)[0, 4])

    def set(self, text: str, size: float) -> NDArray[np.int32]:
        """Positions of letters: rows (atlas index, width, height, column, row) relative to the pen.

        Rows count downwards from the baseline. Blanks have no entry.
        """
        glyphs = self._rows(text, size)
        pens = np.cumsum(glyphs[:, 5]) - glyphs[:, 5]
        glyph_rows = np.column_stack([glyphs[:, :3], glyphs[:, 3] + pens, glyphs[:, 4]])
        return glyph_rows[glyphs[:, 1] > 0].astype(np.int32)

    def _rows(self, text: str, size: float) -> NDArray[np.int32]:
        table = self._glyphs[int(np.abs(self.sizes - size).argmin())]
        unknown = self._indices[UNKNOWN]
        return table[[self._indices.get(character, unknown) for character in " ".join(text.split("\n"))]]


@functools.cache
def lettering() -> Lettering:
    return Lettering()

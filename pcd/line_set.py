"""Straight segments between points: `LineSet`."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .checks import check_rows


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class LineSet:
    """Segments that join points, for pictures and the viewer.

    Args:
        points: Shape [n, 3] [m], finite.
        lines: Indices of two points each, shape [m, 2].
        colors: One a line, shape [m, 3], 0 to 1; None leaves the choice to what draws them.

    Raises:
        ValueError: Other shapes, points that are not finite, or lines between points that do not exist.

    Example:
        >>> import pointloom as loom
        >>> loom.LineSet([[0, 0, 0], [1, 0, 0], [1, 1, 0]], [[0, 1], [1, 2]])
        LineSet(3 points, 2 lines)
    """

    points: NDArray[np.float64]
    lines: NDArray[np.int32]
    colors: NDArray[np.float64] | None = None

    def __post_init__(self):
        points = check_rows("points", self.points, 3, dtype=np.float64)
        if not np.isfinite(points).all():
            raise ValueError(
                f"points: expected finite coordinates, got {(~np.isfinite(points)).any(axis=1).sum()} without"
            )
        lines = check_rows("lines", self.lines, 2)
        if lines.size and (lines.dtype.kind not in "iu" or lines.min() < 0 or lines.max() >= len(points)):
            raise ValueError(f"lines: expected indices of {len(points)} points, got {lines.min()} to {lines.max()}")
        object.__setattr__(self, "points", points)
        object.__setattr__(self, "lines", lines.astype(np.int32))
        if self.colors is not None:
            colors = check_rows("colors", self.colors, 3, rows=len(lines), dtype=np.float64)
            object.__setattr__(self, "colors", colors)

    def __repr__(self) -> str:
        return f"LineSet({len(self.points)} points, {len(self.lines)} lines)"

    def __len__(self) -> int:
        return len(self.lines)

    def paint_uniform_color(self, color: Any) -> LineSet:
        """The same segments, all of one colour (red, green and blue, 0 to 1)."""
        colors = np.tile(np.asarray(color, np.float64).reshape(1, 3), (len(self.lines), 1))
        return dataclasses.replace(self, colors=colors)

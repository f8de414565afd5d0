"""Number of blocks, still being counted by a GPU."""

from __future__ import annotations

import functools
import numbers
from typing import Any

from ...kernels.volumes.frame_record import FrameCounts, TouchesOfFrame


@functools.total_ordering
class BlockCount:
    """Number of touched blocks that waits for the device on first use."""

    def __init__(self, counts: FrameCounts | TouchesOfFrame):
        self._counts = counts

    def __index__(self) -> int:
        return self._counts.touched

    __int__ = __hash__ = __index__  # type: ignore[assignment]

    def __bool__(self) -> bool:
        return int(self) != 0

    def __float__(self) -> float:
        return float(int(self))

    def __eq__(self, other: object) -> bool:
        return int(self) == other

    def __lt__(self, other: Any) -> bool:
        return int(self) < other

    def __add__(self, other: Any) -> Any:
        return int(self) + other

    def __sub__(self, other: Any) -> Any:
        return int(self) - other

    def __mul__(self, other: Any) -> Any:
        return int(self) * other

    def __truediv__(self, other: Any) -> Any:
        return int(self) / other

    def __rsub__(self, other: Any) -> Any:
        return other - int(self)

    def __rtruediv__(self, other: Any) -> Any:
        return other / int(self)

    __radd__, __rmul__ = __add__, __mul__

    def __repr__(self) -> str:
        return repr(int(self))

    def __format__(self, spec: str) -> str:
        return format(int(self), spec)

    def __reduce__(self) -> tuple[Any, ...]:
        return int, (int(self),)


numbers.Number.register(BlockCount)

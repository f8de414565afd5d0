"""Shapes of tensors."""

from __future__ import annotations

import operator
from collections.abc import Iterable
from typing import Any

import numpy as np

from .errors import TensorError


class SizeVector(list[int]):
    """Sizes or numbers of axes: a list of integers, equal to a tuple of the same numbers."""

    def __init__(self, values: int | Iterable[int] = ()):
        try:
            flat: Any = values if isinstance(values, Iterable) else [values]
            super().__init__(map(operator.index, flat if np.size(flat) else ()))
        except TypeError as error:
            raise TensorError(f"shape: expected an integer or a list of integers, got {values!r}") from error

    def __eq__(self, other: object) -> bool:
        return list(self) == list(other) if isinstance(other, list | tuple) else NotImplemented

    def __ne__(self, other: object) -> bool:
        return not self == other

    __hash__ = None  # type: ignore[assignment]  # a list

    def __getitem__(self, index: Any) -> Any:
        part = super().__getitem__(index)
        return SizeVector(part) if isinstance(index, slice) else part

    def __repr__(self) -> str:
        return f"SizeVector[{', '.join(map(str, self))}]"

    __str__ = __repr__

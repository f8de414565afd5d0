"""Members of clouds and meshes that concern their device arrays."""

from __future__ import annotations

from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from ..core.attribute_hints import KnownNames
from ..core.dropped_results import returns_new
from .units import InUnit


class StoredArrays(InUnit, KnownNames):
    """An object with device arrays about an origin. Base of clouds and meshes."""

    arrays: Any  # ArrayStore, for the modules of this package
    _internal = ("arrays", "from_device_arrays", "with_arrays")

    @property
    def device(self) -> Any:
        """Device of the arrays."""
        return self.arrays.device

    @property
    def origin(self) -> NDArray[np.float64]:
        """Origin of the device positions [m], float64 (3,)."""
        return read_only(self.arrays.origin.copy())

    @property
    def array_library(self) -> str:
        """Library of the arrays that operations return: that of the arrays the object was made from."""
        return self.arrays.library

    @returns_new
    def clear(self) -> Self:
        """Empty object on the same device: `cloud = cloud.clear()`."""
        kind: Any = type(self)
        return kind(device=self.device)

    @returns_new
    def copy(self) -> Self:
        """Copy that shares arrays. Assignments to one do not affect the other."""
        raise NotImplementedError

    def __copy__(self) -> Self:
        return self.copy()


def read_only(array: NDArray[Any]) -> NDArray[Any]:
    array.flags.writeable = False
    return array

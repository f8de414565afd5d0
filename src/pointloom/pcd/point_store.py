"""Device arrays of a cloud with their origin and search tree, for the modules of this package."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import warp as wp
from numpy.typing import DTypeLike, NDArray

from ..core.array_libraries import NUMPY, hand_out_copy
from ..core.coordinates import SPREAD_SAMPLE, quiet, split_origin
from ..core.escaped_text import escaped
from ..kernels.arrays.bounds import bound_points
from ..kernels.lang import vec3
from ..kernels.memory import contiguous, download, upload
from .cached_tree import CachedTree


def sample_about(points: wp.array, origin: NDArray[np.float64]) -> NDArray[np.float64]:
    """World coordinates of about 128 of the points (vec3) about an origin, float64 (m, 3)."""
    if not points.size:  # Warp cannot slice it
        return np.zeros((0, 3))
    with quiet():
        return download(contiguous(points[:: points.size // SPREAD_SAMPLE | 1])).reshape(-1, 3) + origin


class ArrayStore(dict[str, wp.array]):
    """Device arrays by name, for reading.

    Attributes:
        origin: Origin of the positions [m], float64 (3,).
        library: Library of returned arrays, see core/array_libraries.py.
    """

    __slots__ = ("library", "origin")
    origin: NDArray[np.float64]
    library: str

    @property
    def device(self) -> wp.Device:
        return next(iter(self.values())).device

    def hand_out(self, array: wp.array, *, dtype: DTypeLike | None = None) -> Any:
        """Convert a result to `library`. NumPy arrays share no memory with the CPU's device arrays."""
        return hand_out_copy(array, self.library, dtype)


class PointStore(ArrayStore):
    """Arrays of a cloud: `points` is vec3 (n,) relative to `origin`. `cloud.arrays` is one.

    Unlike `cloud.array(name)`, reading `cloud.arrays[name]` keeps the cached search tree.

    Attributes:
        tree: The points and their search tree, built on demand.
    """

    __slots__ = ("tree",)

    def __init__(
        self,
        arrays: Mapping[str, wp.array],
        origin: NDArray[np.float64],
        library: str = NUMPY,
        *,
        tree: CachedTree | None = None,
    ):
        super().__init__(arrays)
        self.origin, self.library = origin, library
        self.tree = CachedTree(arrays["points"]) if tree is None else tree

    def __missing__(self, name: str) -> wp.array:
        return self.required(name, f"the cloud has {', '.join(self)}")

    def required(self, name: str, remedy: str) -> wp.array:
        """The array `name`. If there is none, the ValueError ends with `remedy`."""
        if name not in self:
            raise ValueError(escaped(f"the cloud has no {name}: {remedy}"))
        return self[name]

    def positions(self) -> NDArray[np.float64]:
        """World coordinates [m], float64 (n, 3)."""
        with quiet():
            return download(self["points"]).astype(np.float64) + self.origin

    def bounds(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Lowest and highest corner of the finite points [m], (3,) each; zeros if there are none."""
        low, high, finite = bound_points(self["points"])
        if not finite:
            return np.zeros(3), np.zeros(3)
        return low.astype(np.float64) + self.origin, high.astype(np.float64) + self.origin

    def about(self, origin: NDArray[np.float64]) -> wp.array:
        """Points relative to another origin, a device array of vec3."""
        if (self.origin == origin).all():
            return self["points"]
        return upload(split_origin(self.positions(), origin)[0], vec3, self.device)

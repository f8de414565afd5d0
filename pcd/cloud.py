"""PointCloud: points with named attributes, as a structure of arrays on one device.

The operations are in one module per topic; PointCloud inherits them.
"""

from __future__ import annotations

import os
from typing import Any

from numpy.typing import ArrayLike

from ..core.array_libraries import library_of
from ..core.checks import check_finite, check_shape, is_on_gpu, shown
from ..core.devices import resolve_device
from ..core.told_arguments import told_arguments
from ..core.units import LengthUnit, check_unit
from ..kernels.memory import move
from .bounds import Bounds
from .conversion import Conversion
from .kept_tree import KeptTree
from .normals import Normals
from .segmentation import Segmentation


class PointCloud(Normals, Bounds, Segmentation, Conversion):
    """Points in space with attributes, on one device.

    Operations return a new cloud and leave this one as it is: `cloud = cloud.estimate_normals()`.

    Positions are float32 relative to a float64 `origin`, which moves by itself where coordinates exceed 1e4, so kernels
    stay exact at UTM coordinates. Reading `points`, `normals`, `colors` gives NumPy arrays that cannot be written to
    (change a `.copy()` and assign that); `array(name)` gives the device array without a copy. What an operation returns
    shares what it did not change, and carries all attributes along. The tree that searches need is built once and kept
    with the points (20 B a point), for all clouds that share them. Points that are not finite are kept and never
    counted: they are nobody's neighbour.

    Arrays come back as they came (docs/arrays.md): operations of a cloud made of NumPy arrays or lists return NumPy
    arrays on every device, those of a cloud made of torch, cupy, jax or Warp arrays return such, where the cloud is.
    NumPy arrays are copied; the arrays of those libraries are shared where type and layout allow, so what is written to
    them changes the cloud (see `from_dlpack`).

    Args:
        points: Shape [n, 3] [m].
        normals: Shape [n, 3].
        colors: Shape [n, 3], 0..1; uint8 is divided by 255.
        device: "cpu", "cuda:0", "auto"; None for the GPU that the points lie on, else the CPU.
        origin: Where the float32 coordinates start [m], shape [3]; chosen where not given.
        unit: Of the coordinates, such as "foot"; None for an unknown one, which counts as metres.
        **attributes: Further arrays of shape [n] or [n, c], such as intensity, ring, label.

    Raises:
        ValueError: Wrong shapes or lengths, colours out of range, a unit that is not known.
        TypeError: Not numeric.
        DeviceError: No such device.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> cloud = loom.PointCloud(np.random.default_rng(0).random((1000, 3)), intensity=np.arange(1000))
        >>> small = cloud.voxel_down_sample(0.5).estimate_normals(radius=1.0, max_nn=30)
        >>> len(small), small.normals.shape, list(small.attributes)
        (27, (27, 3), ['intensity'])
    """

    @told_arguments
    def __init__(
        self,
        points: ArrayLike = (),
        *,
        normals: ArrayLike | None = None,
        colors: ArrayLike | None = None,
        device: Any = None,
        origin: ArrayLike | None = None,
        unit: str | LengthUnit | None = None,
        **attributes: ArrayLike,
    ):
        if isinstance(points, PointCloud):
            raise TypeError("points: expected an array, got a PointCloud; cloud.copy() is another one of its arrays")
        if isinstance(points, str | os.PathLike):
            raise TypeError(
                f"points: expected real numbers, got {shown(points)}; loom.read_point_cloud(path) reads a file"
            )
        where = resolve_device(device)
        start = None if origin is None else check_finite("origin", check_shape("origin", origin, (3,)))
        self._arrays, self._library, self.grid, self._unit = {}, library_of(points), None, check_unit("unit", unit)
        self._place(points, start, None if is_on_gpu(points) else where)
        if normals is not None:
            self._set("normals", normals)
        if colors is not None:
            self._set("colors", colors)
        for name, values in attributes.items():
            self._set(name, values)
        if device is not None and where != self.device:  # arrays that lay on a GPU
            self._arrays = {name: move(values, where) for name, values in self._arrays.items()}
            self._kept = KeptTree(self._arrays["points"])

"""PointCloud: points with named attributes, as a structure of arrays on one device.

What a cloud can do lies in one file a subject; PointCloud brings them together.
"""

from __future__ import annotations

from typing import Any

from numpy.typing import ArrayLike

from ..kernels.lang import vec3
from ..kernels.memory import upload
from .checks import check_finite, check_rows, check_shape
from .clusters import Clusters
from .coordinates import split_origin
from .depth_clouds import DepthClouds
from .devices import resolve_device
from .distances import Distances
from .hulls import Hulls
from .interop import Interop
from .kept_tree import KeptTree
from .motion import Motion
from .normals import Normals
from .outliers import Outliers
from .planes import Planes
from .sampling import Sampling
from .smoothing import Smoothing


class PointCloud(
    Sampling, Normals, Motion, Distances, Outliers, Clusters, Planes, Hulls, Smoothing, DepthClouds, Interop
):
    """Points in space with attributes, on one device.

    Operations return a new cloud and leave this one as it is: `cloud = cloud.estimate_normals()`.

    Positions are float32 relative to a float64 `origin`, which moves by itself where coordinates exceed 1e4, so kernels
    stay exact at UTM coordinates. Reading `points`, `normals`, `colors` gives NumPy arrays that cannot be written to
    (change a `.copy()` and assign that); `array(name)` gives the device array without a copy. What an operation returns
    shares what it did not change, and carries all attributes along. The tree that searches need is built once and kept
    with the points (20 B a point), for all clouds that share them. Points that are not finite are kept and never
    counted: they are nobody's neighbour.

    Args:
        points: Shape [n, 3] [m].
        normals: Shape [n, 3].
        colors: Shape [n, 3], 0..1; uint8 is divided by 255.
        device: "cpu", "cuda:0", "auto"; None for the CPU.
        origin: Where the float32 coordinates start [m], shape [3]; chosen where not given.
        **attributes: Further arrays of shape [n] or [n, c], such as intensity, ring, label.

    Raises:
        ValueError: Wrong shapes or lengths, colours out of range.
        TypeError: Not numeric.
        DeviceError: No such device.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> cloud = loom.PointCloud(np.random.default_rng(0).random((1000, 3)), intensity=np.arange(1000))
        >>> small = cloud.voxel_down_sample(0.5).estimate_normals(radius=1.0, max_nn=30)
        >>> len(small), small.normals.shape, list(small.attributes)
        (27, (27, 3), ['intensity'])
    """

    def __init__(
        self,
        points: ArrayLike = (),
        *,
        normals: ArrayLike | None = None,
        colors: ArrayLike | None = None,
        device: Any = None,
        origin: ArrayLike | None = None,
        **attributes: ArrayLike,
    ):
        where = resolve_device(device)
        positions = check_rows("points", points, 3)
        start = None if origin is None else check_finite("origin", check_shape("origin", origin, (3,)))
        local, self._origin = split_origin(positions, start)
        self._arrays = {"points": upload(local, vec3, where)}
        self._kept = KeptTree(self._arrays["points"])
        self.grid = None
        if normals is not None:
            self._set("normals", normals)
        if colors is not None:
            self._set("colors", colors)
        for name, values in attributes.items():
            self._set(name, values)

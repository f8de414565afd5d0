"""PointCloud: points with named attributes on one device. Operations are inherited from one module per topic."""

from __future__ import annotations

import os

from numpy.typing import ArrayLike

from ..core.argument_errors import explain_argument_errors
from ..core.array_libraries import library_for
from ..core.checks import check_finite, check_shape, is_on_gpu, shown
from ..core.coordinate_systems import CoordinateSystem, check_crs, is_in_degrees
from ..core.devices import DeviceLike, resolve_device
from ..core.escaped_text import escaped
from ..core.units import LengthUnit, check_unit
from ..kernels.memory import move
from .bounds import Bounds
from .cached_tree import CachedTree
from .conversion import Conversion, cloud_arguments
from .extent_text import reference_text
from .normals import Normals
from .point_arrays import place_points
from .point_store import PointStore
from .segmentation import Segmentation


class PointCloud(Normals, Bounds, Segmentation, Conversion):
    """Points with attributes on one device. Operations return a new cloud: `cloud = cloud.estimate_normals()`.

    Positions are float32 about a float64 `origin`, chosen automatically for coordinates beyond 1e4 and for degrees.
    `points`, `normals` and `colors` are read-only NumPy copies; `array(name)` is the device array. Results share
    unchanged arrays, keep all attributes, and cache the search tree with the points (20 B per point). Non-finite points
    are kept, but ignored.

    Operations return arrays of the library that the cloud was made from (docs/arrays.md). NumPy arrays are copied;
    torch, cupy, jax and Warp arrays are shared if type and layout allow, see `from_dlpack`.

    Args:
        points: Shape (n, 3) [m]. Or a cloud of Open3D, trimesh, PyVista, VTK or meshio, see `from_any`.
        normals: Shape (n, 3).
        colors: Shape (n, 3), 0..1; uint8 is divided by 255.
        device: "cpu", "cuda:0" or "auto". If None: the points' GPU, or the CPU.
        origin: Origin of the float32 coordinates [m], shape (3,). If None: chosen.
        unit: Unit of the coordinates, such as "foot". If None: unknown, treated as meters.
        crs: Coordinate reference system: "EPSG:25832", 25832 or well-known text. None if unknown.
        frozen: Promise that `points` and `array("points")` are never written, see `from_dlpack`.
        arrays: Library of returned arrays: "numpy", "warp", "torch", "cupy" or "jax". If None: that of the points.
        **attributes: Other arrays of shape (n,) or (n, c), such as intensity or label.

    Raises:
        ValueError: If a shape or length is wrong, colors are out of range, or the unit is unknown.
        TypeError, DeviceError: If an array is not numeric, or if the device does not exist.
        ImportError: If the library of `arrays` is not installed.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> cloud = loom.PointCloud(np.random.default_rng(0).random((1000, 3)), intensity=np.arange(1000))
        >>> small = cloud.voxel_down_sample(0.5).estimate_normals(radius=1.0, max_nn=30)
        >>> len(small), small.normals.shape, list(small.attributes)
        (27, (27, 3), ['intensity'])
    """

    @explain_argument_errors
    def __init__(
        self,
        points: ArrayLike = (),
        *,
        normals: ArrayLike | None = None,
        colors: ArrayLike | None = None,
        device: DeviceLike = None,
        origin: ArrayLike | None = None,
        unit: str | LengthUnit | None = None,
        crs: str | int | CoordinateSystem | None = None,
        frozen: bool = False,
        arrays: str | None = None,
        **attributes: ArrayLike,
    ):
        if isinstance(points, PointCloud):
            raise TypeError("points: expected an array, got a PointCloud. Use cloud.copy() to copy a cloud")
        if isinstance(points, str | os.PathLike):
            raise TypeError(
                f"points: expected real numbers, got {shown(points)}. Read a file with loom.read_point_cloud(path)"
            )
        if (given := cloud_arguments("points", points)) is not None:
            points, device = given.points, given.device if device is None else device
            normals, colors = given.normals if normals is None else normals, given.colors if colors is None else colors
            unit, crs, attributes = unit or given.unit, crs or given.crs, {**given.attributes, **attributes}
        where = resolve_device(device)
        start = None if origin is None else check_finite("origin", check_shape("origin", origin, (3,)))
        library, length_unit = library_for(arrays, points), None if unit is None else check_unit("unit", unit)
        system = None if crs is None else check_crs("crs", crs)
        placed, start, tree = place_points(
            points, start, None if is_on_gpu(points) else where, frozen=frozen,
            in_degrees=is_in_degrees(length_unit, system),
        )  # fmt: skip
        vars(self).update(
            arrays=PointStore({"points": placed}, start, library, tree=tree), grid=None, _unit=length_unit, _crs=system
        )
        if normals is not None:
            self._set("normals", normals)
        if colors is not None:
            self._set("colors", colors)
        for name, values in attributes.items():
            self._set(name, values)
        if device is not None and where != self.device:  # arrays were on a GPU
            moved = {name: move(values, where) for name, values in self.arrays.items()}
            tree = CachedTree(moved["points"], frozen=frozen)
            vars(self)["arrays"] = PointStore(moved, self.arrays.origin, library, tree=tree)

    def __repr__(self) -> str:
        names = escaped(", ".join(name for name in self.arrays if name != "points")) or "no attributes"
        is_referenced = self.unit is not None or self.crs is not None  # bounds wait for the device
        reference = reference_text(self, self.get_min_bound(), self.get_max_bound()) if is_referenced else ""
        parts = [f"{len(self):,} points", names, *([reference] if reference else []), str(self.device)]
        return f"{type(self).__name__}({', '.join(parts)})"

    def _ipython_key_completions_(self) -> list[str]:
        return list(self.arrays)

"""Arrays of a cloud: positions about a float64 origin and named attributes, on one device."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, MutableMapping
from typing import Any, Self

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, DTypeLike, NDArray

from ..core.array_libraries import NUMPY, check_library, library_of, owned, shared_view
from ..core.callable_bool import CallableBool
from ..core.checks import check_colors, check_list, check_name, check_rows, is_on_gpu
from ..core.coordinates import split_origin, warn_if_coarse
from ..core.devices import DeviceLike, resolve_device
from ..core.dropped_results import returns_new
from ..core.escaped_text import escaped
from ..core.exchange import plain_device
from ..core.gpu_arrays import take_colors, take_points, take_vectors
from ..core.html_tables import array_type, html_table
from ..kernels.lang import vec3
from ..kernels.language.device_lock import lock_for
from ..kernels.memory import clone, host_view, move, upload
from ..kernels.search.point_tree import PointTree
from .attribute_columns import upload_column
from .cached_tree import CachedTree
from .point_store import PointStore
from .stored_arrays import StoredArrays, read_only

VECTORS = ("points", "normals", "colors")
COVARIANCES = "covariances"  # of neighborhoods: (n, 9), valid for the present points only


class Attributes(MutableMapping[str, NDArray[Any]]):
    """Read-only NumPy attributes of shape (n,) or (n, c) by name, without points, normals and colors."""

    def __init__(self, cloud: PointArrays):
        self._cloud = cloud

    def __getitem__(self, name: str) -> NDArray[Any]:
        if name in VECTORS or name not in self._cloud:
            raise KeyError(name)
        return self._cloud[name]

    def __setitem__(self, name: str, values: ArrayLike) -> None:
        if name in VECTORS:
            raise KeyError(escaped(f"{name}: assign cloud.{name}"))
        self._cloud[name] = values

    def __delitem__(self, name: str) -> None:
        if name in VECTORS or name not in self._cloud:
            raise KeyError(name)
        del self._cloud.arrays[name]

    def __iter__(self) -> Iterator[str]:
        return iter([name for name in self._cloud.arrays if name not in VECTORS])

    def __len__(self) -> int:
        return sum(name not in VECTORS for name in self._cloud.arrays)

    def __repr__(self) -> str:
        return "{" + ", ".join(f"{name!r}: {values.dtype} {list(values.shape)}" for name, values in self.items()) + "}"


class PointArrays(StoredArrays):
    """Points and attributes of a cloud, validated on assignment. Base of PointCloud.

    Arrays that are read are read-only copies: modify a `.copy()` and assign it.

    Attributes:
        grid: Rows and columns if the points are image pixels, row by row. Else None.
    """

    arrays: PointStore  # device arrays for the modules of this package
    _internal = ("with_points",)
    _how_to_add = "Add an attribute of the points with cloud[{name!r}] = values"
    grid: tuple[int, int] | None

    def __len__(self) -> int:
        return self.arrays["points"].size

    @property
    def has_points(self) -> CallableBool:
        """True if there are points. Also callable."""
        return CallableBool(len(self))

    @property
    def has_normals(self) -> CallableBool:
        """True if there are normals. Also callable."""
        return CallableBool("normals" in self.arrays)

    @property
    def has_colors(self) -> CallableBool:
        """True if there are colors. Also callable."""
        return CallableBool("colors" in self.arrays)

    @property
    def has_covariances(self) -> CallableBool:
        """True if there are covariances. Also callable."""
        return CallableBool("covariances" in self.arrays)

    @property
    def is_empty(self) -> CallableBool:
        """True if there are no points. Also callable."""
        return CallableBool(len(self) == 0)

    def __repr__(self) -> str:
        names = escaped(", ".join(n for n in self.arrays if n != "points"))
        system = "" if self._crs is None else f", {escaped(self._crs.name)}"
        return f"{type(self).__name__}({len(self):,} points, {names or 'no attributes'}{system}, {self.device})"

    def _repr_html_(self) -> str:
        return html_table(repr(self), ((name, array_type(values)) for name, values in self.arrays.items()))

    @property
    def points(self) -> NDArray[np.float64]:
        """World coordinates [m], float64 (n, 3). Assigning drops covariances, which belong to the old positions."""
        return read_only(self.arrays.positions())

    @points.setter
    def points(self, values: ArrayLike) -> None:
        points, origin, tree = place_points(values, None, self.device, rows=len(self), in_degrees=self._in_degrees)
        self.arrays["points"], self.arrays.origin, self.arrays.tree = points, origin, tree
        self.arrays.pop(COVARIANCES, None)

    @property
    def normals(self) -> NDArray[np.float32]:
        """Unit normals, float32 (n, 3).

        Raises:
            ValueError: If the cloud has none.
        """
        return read_only(owned(self.arrays.required("normals", "call cloud = cloud.estimate_normals()")))

    @normals.setter
    def normals(self, values: ArrayLike) -> None:
        self._set("normals", values)

    @normals.deleter
    def normals(self) -> None:
        self.arrays.pop("normals", None)

    @property
    def colors(self) -> NDArray[np.float32]:
        """Colors in 0..1, float32 (n, 3).

        Raises:
            ValueError: If the cloud has none.
        """
        return read_only(owned(self.arrays.required("colors", "assign cloud.colors")))

    @colors.setter
    def colors(self, values: ArrayLike) -> None:
        self._set("colors", values)

    @colors.deleter
    def colors(self) -> None:
        self.arrays.pop("colors", None)

    @property
    def attributes(self) -> Attributes:
        """Other attributes, a mutable mapping of NumPy arrays of shape (n,) or (n, c)."""
        return Attributes(self)

    def __getitem__(self, name: str) -> NDArray[Any]:
        """Attribute as NumPy array, including `points`, `normals` and `colors`."""
        if name in VECTORS:
            return getattr(self, name)
        return read_only(owned(self.arrays[name]))

    __array_ufunc__ = None  # arithmetic of arrays with clouds raises an error, in either order

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> NDArray[Any]:
        """Points for `np.asarray(cloud)`, float64 (n, 3) [m]: a read-only copy, or writable with `copy=True`.

        Raises:
            ValueError: If `copy=False`. Positions are stored as float32 about an origin.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> np.asarray(loom.PointCloud([[1, 2, 3]]))
            array([[1., 2., 3.]])
        """
        if copy is False:
            raise ValueError(
                "a cloud stores float32 relative to an origin, so its points are copied; see array('points')"
            )
        points = self.points if dtype is None else self.points.astype(dtype)
        return points.copy() if copy and not points.flags.writeable else points

    def __setitem__(self, name: str, values: ArrayLike) -> None:
        if name == "points":
            self.points = values
        else:
            self._set(name, values)

    def __contains__(self, name: str) -> bool:
        return name in self.arrays

    def __iter__(self) -> Iterator[Any]:
        raise TypeError("a PointCloud is not a sequence; iterate over cloud.points")

    def array(self, name: str) -> Any:
        """Get an array by name without a copy, in the library of the cloud (`array_library`) and on its device.

        Writes affect all clouds that share the array. The next operation detects changed points and rebuilds the search
        tree. Points of a `frozen` cloud are not checked.

        Args:
            name: "points" (relative to `origin`), "normals" or "colors", each (n, 3), or another attribute.

        Returns:
            A NumPy array, a torch tensor, and so on. Warp's arrays of points are vec3 (n,). A cloud of NumPy on a GPU
            returns Warp's array, which `torch.from_dlpack` and similar functions accept.

        Raises:
            ValueError: If the cloud has no such array.

        Example:
            >>> import pointloom as loom
            >>> loom.PointCloud([[0, 0, 0], [1, 0, 0]]).array("points").shape
            (2, 3)
        """
        is_points = check_name("name", name) == "points"
        return shared_view(self.arrays.tree.share() if is_points else self.arrays[name], self.arrays.library)

    @returns_new
    def to(self, device: DeviceLike, *, arrays: str | None = None) -> Self:
        """Copy the cloud to another device. Returns the cloud itself if it is already there.

        Args:
            device: "cpu", "cuda:0" or "auto".
            arrays: Library of returned arrays: "numpy", "warp", "torch", "cupy" or "jax". If None: unchanged.

        Raises:
            DeviceError: If the device does not exist.
            ValueError, ImportError: If the library is unknown or not installed.

        Example:
            >>> import pointloom as loom
            >>> cloud = loom.PointCloud([[0, 0, 0], [0, 0, 1]]).to("cpu", arrays="warp")
            >>> type(cloud.compute_nearest_neighbor_distance()).__name__
            'array'
        """
        where = resolve_device(device)
        library = self.arrays.library if arrays is None else check_library("arrays", arrays)
        if where == self.device and library == self.arrays.library:
            return self
        cloud = self.with_arrays({name: move(values, where) for name, values in self.arrays.items()}, grid=self.grid)
        cloud.arrays.library = library
        return cloud

    def __dlpack_device__(self) -> tuple[int, int]:
        return self.arrays["points"].__dlpack_device__()

    def __dlpack__(
        self,
        *,
        stream: int | None = None,
        max_version: tuple[int, int] | None = None,
        dl_device: tuple[int, int] | None = None,
        copy: bool | None = None,
    ) -> Any:
        """Points for `from_dlpack` of another library: float32 (n, 3) about `origin`, without a copy unless `copy`.

        Raises:
            BufferError: If the origin is not zero (add `origin` to `array("points")` in float64 instead), or if
                another device is requested.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> np.from_dlpack(loom.PointCloud([[1, 2, 3]])).tolist()
            [[1.0, 2.0, 3.0]]
        """
        if self.arrays.origin.any():
            raise BufferError(
                f"the points are relative to the origin {self.origin.tolist()}. Share cloud.array('points') and add "
                "cloud.origin to it, in float64"
            )
        if dl_device is not None and plain_device(dl_device) != plain_device(self.__dlpack_device__()):
            raise BufferError(f"the points are on {self.device}. Use cloud.to(device) to copy them to another device")
        points = clone(self.arrays["points"]) if copy else self.arrays.tree.share()
        if points.device.is_cpu:  # as in array_libraries.hand_out
            return host_view(points).__dlpack__()
        with lock_for(self.device):
            return points.__dlpack__(stream=stream)

    @returns_new
    def without(self, *names: str) -> Self:
        """Remove attributes, including "normals" and "colors".

        Raises:
            ValueError: If the cloud has no such attribute, or it is the points.

        Example:
            >>> import pointloom as loom
            >>> cloud = loom.PointCloud([[0, 0, 0]], colors=[[1, 0, 0]], label=[3])
            >>> cloud.without("colors", "label")
            PointCloud(1 points, no attributes, cpu)
        """
        if "points" in names:
            raise ValueError("points: cannot be removed. Create an empty cloud with PointCloud()")
        for name in names:
            self.arrays[name]  # raises if the cloud has none
        return self.with_arrays({n: a for n, a in self.arrays.items() if n not in names}, grid=self.grid)

    @returns_new
    def copy(self) -> Self:
        """Copy that shares arrays. Assignments to one do not affect the other."""
        return self.with_arrays(self.arrays, grid=self.grid)

    @classmethod
    def from_device_arrays(
        cls, arrays: Mapping[str, wp.array], origin: NDArray[np.float64], library: str = NUMPY
    ) -> Self:
        """Create a cloud from device arrays without copies or checks; `points` is vec3 (n,) relative to `origin`."""
        cloud = cls.__new__(cls)
        vars(cloud).update(arrays=PointStore(arrays, origin, library), grid=None, _unit=None)  # without checks
        return cloud

    def with_arrays(self, arrays: Mapping[str, wp.array], *, grid: tuple[int, int] | None = None) -> Self:
        """Cloud with other device arrays about the same origin. Keeps the search tree if the points are the same."""
        own = self.arrays
        tree = own.tree if arrays["points"] is own["points"] else None
        cloud = type(self).__new__(type(self))
        store = PointStore(arrays, own.origin, own.library, tree=tree)
        vars(cloud).update(arrays=store, grid=grid, _unit=self._unit, _crs=self._crs)  # without checks
        return cloud

    def with_points(
        self, points: wp.array, normals: wp.array | None = None, *, grid: tuple[int, int] | None = None
    ) -> Self:
        """Cloud with moved points about the same origin, and perhaps other normals. Covariances, which belong to the
        old positions, are dropped."""
        arrays = {name: values for name, values in self.arrays.items() if name != COVARIANCES} | {"points": points}
        return self.with_arrays(arrays if normals is None else arrays | {"normals": normals}, grid=grid)

    def search_tree(self) -> PointTree:
        """Search tree of the points, built at the first call and cached: 20 B per point."""
        return self.arrays.tree.tree()

    def _set(self, name: str, values: ArrayLike) -> None:
        if isinstance(values, PointArrays):  # its `array` would be its points
            raise TypeError(
                f"{escaped(name)}: expected an array, got a PointCloud. Pass one of its arrays: other[{name!r}]"
            )
        if name not in VECTORS:
            self.arrays[name] = upload_column(name, values, len(self), self.device)
        elif is_on_gpu(values):
            take = take_vectors if name == "normals" else take_colors
            self.arrays[name] = take(name, values, self.device, rows=len(self))
        else:
            is_copied = library_of(values) == NUMPY
            rows = check_rows(name, values, 3, rows=len(self), dtype=np.float32 if name == "normals" else None)
            rows = rows if name == "normals" else check_colors(name, rows)
            self.arrays[name] = upload(rows, vec3, self.device, copied=is_copied)


def place_points(
    values: ArrayLike,
    origin: NDArray[np.float64] | None,
    device: Any,
    *,
    rows: int | None = None,
    frozen: bool = False,
    in_degrees: bool = False,
) -> tuple[wp.array, NDArray[np.float64], CachedTree]:
    """(points on their GPU or on `device`, their origin, their search tree). The caller never writes to `frozen`
    points."""
    if is_on_gpu(values):
        points, start = take_points("points", values, origin, device, rows=rows, in_degrees=in_degrees)
        return points, start, CachedTree(points, is_shared=points._ref is not None, frozen=frozen)
    is_copied = type(values) is np.ndarray or library_of(values) == NUMPY
    positions = check_rows("points", values, 3, rows=rows)
    local, start = split_origin(positions, origin, in_degrees=in_degrees)
    if origin is None:
        warn_if_coarse("points", positions, start, in_degrees=in_degrees)
    points: Any = upload(local, vec3, device, copied=is_copied)
    is_shared = not is_copied and points.device.is_cpu and np.may_share_memory(local, positions)
    return points, start, CachedTree(points, is_shared=is_shared, frozen=frozen)


def check_cloud(name: str, cloud: object) -> None:
    if not isinstance(cloud, PointArrays):
        raise TypeError(f"{name}: expected a PointCloud, got {type(cloud).__name__}; {_remedy_of(cloud)}")


def list_clouds(name: str, clouds: Any, of: str = "point clouds") -> list[Any]:
    """The items of a list of clouds, which are not checked. Raises `TypeError` for other objects, also one mesh."""
    if hasattr(clouds, "sample_points_uniformly"):
        check_cloud(name, clouds)
    return check_list(name, clouds, of)


def _remedy_of(value: object) -> str:
    """Hint how to create a cloud from a value of another type."""
    if isinstance(value, tuple) and value and isinstance(value[0], PointArrays):
        return "unpack the pair: cloud, rows = ..."
    if isinstance(value, str | os.PathLike):
        return "read a file with loom.read_point_cloud(path), or use loom.PointCloud(array) for an array"
    if hasattr(value, "sample_points_uniformly"):
        vertices = "or use its vertices: loom.PointCloud(mesh.vertices)"
        return f"sample a mesh with mesh.sample_points_uniformly(100_000), {vertices}"
    return "use loom.PointCloud(array), or loom.PointCloud.from_open3d(cloud) for an Open3D cloud"

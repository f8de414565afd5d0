"""What a mesh holds: vertices about a float64 origin, triangles, and what belongs to vertices, on one device."""

from __future__ import annotations

from typing import Any, Self

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ..kernels.lang import vec3, vec3i
from ..kernels.memory import clone, download, move, upload
from ..pcd.checks import check_name, check_rows
from ..pcd.devices import check_same_device, resolve_device
from ..pcd.known_names import KnownNames
from ..pcd.pickled_arrays import device_like, pickled, unpickled
from ..pcd.point_arrays import read_only

OPTIONAL = ("vertex_normals", "vertex_colors")


class MeshArrays(KnownNames):
    """The arrays of a mesh by name, checked where they are assigned; TriangleMesh adds the operations."""

    _device: Any
    _origin: NDArray[np.float64]
    _arrays: dict[str, wp.array]

    @classmethod
    def _from_arrays(
        cls,
        vertices: wp.array,
        triangles: wp.array,
        *,
        vertex_normals: wp.array | None = None,
        vertex_colors: wp.array | None = None,
        origin: Any = None,
    ) -> Self:
        """A mesh around device arrays, for kernels: nothing is copied or checked but types, lengths and devices.

        Args:
            vertices: vec3 [m], relative to `origin`.
            triangles: vec3i [t], or int32 [3 t] or [t, 3] (contiguous), whose memory is then shared.
            vertex_normals: vec3 [m].
            vertex_colors: vec3 [m], in 0..1.
            origin: float64 [3]; None for zero.
        """
        arrays = {"vertices": vertices, "triangles": _as_triples(triangles)}
        for name, values in (("vertex_normals", vertex_normals), ("vertex_colors", vertex_colors)):
            if values is not None:
                arrays[name] = values
        for name, values in arrays.items():
            check_same_device(name, vertices.device, values.device)
            if name != "triangles" and (values.dtype != vec3 or values.shape != vertices.shape):
                raise ValueError(f"{name}: expected vec3 [{vertices.size}], got {values}")
        mesh = cls.__new__(cls)
        mesh._device, mesh._arrays = vertices.device, arrays
        mesh._origin = np.zeros(3) if origin is None else np.array(origin, np.float64)
        return mesh

    def _with(self, *, origin: NDArray[np.float64] | None = None, **arrays: wp.array | None) -> Self:
        """The same mesh with some arrays replaced, or dropped where None."""
        merged = self._arrays | arrays
        kept = {name: values for name, values in merged.items() if values is not None}
        return self._from_arrays(**kept, origin=self._origin if origin is None else origin)

    def _assign(self, name: str, values: Any) -> None:
        rows, count = check_rows(name, values, 3, dtype=np.float32), self._arrays["vertices"].size
        if len(rows) != count:
            raise ValueError(f"{name}: expected shape [{count}, 3], one row a vertex, got {list(rows.shape)}")
        self._arrays[name] = upload(rows, vec3, self._device)

    # -------------------------------------------------------------------------------------------- data

    def __len__(self) -> int:
        return self._arrays["triangles"].size

    def __repr__(self) -> str:
        extras = "".join(f", {name}" for name in OPTIONAL if name in self._arrays)
        sizes = f"{self._arrays['vertices'].size} vertices, {len(self)} triangles"
        return f"{type(self).__name__}({sizes}{extras}, {self._device})"

    @property
    def device(self) -> Any:
        """The device that holds the arrays."""
        return self._device

    @property
    def origin(self) -> NDArray[np.float64]:
        """The point [m] that vertices are stored relative to, float64 [3]."""
        return read_only(self._origin.copy())

    @property
    def vertices(self) -> NDArray[np.float64]:
        """Positions [m], a float64 copy of shape [m, 3] with the origin added."""
        return read_only(download(self._arrays["vertices"]).astype(np.float64).reshape(-1, 3) + self._origin)

    @property
    def triangles(self) -> NDArray[np.int32]:
        """Vertex numbers, an int32 copy of shape [t, 3]."""
        return read_only(download(self._arrays["triangles"]).reshape(-1, 3).copy())

    @property
    def vertex_normals(self) -> NDArray[np.float32] | None:
        """Normals, a float32 copy of shape [m, 3], or None; assigning takes any array-like."""
        return self._read("vertex_normals")

    @vertex_normals.setter
    def vertex_normals(self, values: Any) -> None:
        self._assign("vertex_normals", values)

    @property
    def vertex_colors(self) -> NDArray[np.float32] | None:
        """Colours in 0..1, a float32 copy of shape [m, 3], or None; assigning takes any array-like."""
        return self._read("vertex_colors")

    @vertex_colors.setter
    def vertex_colors(self, values: Any) -> None:
        self._assign("vertex_colors", values)

    def _read(self, name: str) -> NDArray[np.float32] | None:
        return read_only(download(self._arrays[name]).reshape(-1, 3).copy()) if name in self._arrays else None

    def array(self, name: str) -> wp.array:
        """A device array by name, shared without a copy (DLPack, `__cuda_array_interface__`).

        Args:
            name: "vertices" (vec3 [m], relative to `origin`), "triangles" (vec3i [t]), "vertex_normals" or
                "vertex_colors" (vec3 [m]).

        Raises:
            KeyError: The mesh has no such array.
        """
        if check_name("name", name) not in self._arrays:
            raise KeyError(f"{name}: this mesh has {', '.join(self._arrays)}")
        return self._arrays[name]

    def to(self, device: Any) -> Self:
        """The mesh on another device; itself where it is there already."""
        target = resolve_device(device)
        if target == self._device:
            return self
        arrays: dict[str, Any] = {name: move(values, target) for name, values in self._arrays.items()}
        return self._with(**arrays)

    def copy(self) -> Self:
        """Another mesh over the same arrays: what is assigned to one does not reach the other."""
        return self._with()

    def __copy__(self) -> Self:
        return self.copy()

    def __deepcopy__(self, memo: dict[int, Any]) -> Self:
        arrays: dict[str, Any] = {name: clone(array) for name, array in self._arrays.items()}
        return self._with(**arrays)

    def __getstate__(self) -> dict[str, Any]:
        """The mesh as NumPy arrays and the name of its device, for pickle."""
        return {"arrays": pickled(self._arrays), "origin": self._origin, "device": str(self._device)}

    def __setstate__(self, state: dict[str, Any]) -> None:
        """The mesh on the device that it was on; on the first GPU where there is another number of them.

        Raises:
            DeviceError: It was on a GPU, and here is none.
        """
        self._device, self._origin = device_like("mesh", state["device"]), state["origin"]
        self._arrays = unpickled(state["arrays"], self._device)


def _as_triples(triangles: wp.array) -> wp.array:
    """Triangles as vec3i [t], over the same memory."""
    if triangles.dtype == vec3i and triangles.ndim == 1:
        return triangles
    is_table = triangles.ndim == 2 and triangles.shape[1] == 3
    is_flat = triangles.ndim == 1 and triangles.size % 3 == 0
    if triangles.dtype != wp.int32 or not (is_table or is_flat) or not triangles.is_contiguous:
        raise ValueError(f"triangles: expected vec3i [t], or int32 [3 t] or [t, 3] without gaps, got {triangles}")
    count = triangles.size // 3
    view = wp.array(ptr=triangles.ptr, dtype=vec3i, shape=(count,), device=triangles.device, copy=False)
    view._ref = triangles  # keeps the memory alive
    return view

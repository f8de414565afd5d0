"""What a mesh holds: vertices about a float64 origin, triangles, and what belongs to either, on one device."""

from __future__ import annotations

from typing import Any, Self

import numpy as np
import warp as wp
from numpy.typing import DTypeLike, NDArray

from ...core.array_libraries import NUMPY, check_library, hand_out, library_of
from ...core.checks import check_name, check_numeric, check_rows, check_textures, is_on_gpu
from ...core.devices import check_same_device, resolve_device
from ...core.gpu_arrays import take_vectors
from ...core.known_names import KnownNames
from ...core.pickled_arrays import device_like, pickled, unpickled
from ...kernels.arrays.select import gather_rows
from ...kernels.lang import int32, vec2, vec3, vec3i
from ...kernels.memory import clone, download, move, upload
from ...kernels.meshes.mesh_edits import gather_corners, gather_triangles
from ...pcd.point_arrays import read_only
from ...pcd.units import InUnit

PER_VERTEX = {"vertices": vec3, "vertex_normals": vec3, "vertex_colors": vec3}
PER_TRIANGLE = {"triangles": vec3i, "triangle_uvs": vec2, "triangle_material_ids": int32}
TEXTURE = ("triangle_uvs", "triangle_material_ids")
CORNERS = ("triangle_uvs",)  # three rows a triangle


class MeshArrays(InUnit, KnownNames):
    """The arrays of a mesh by name, checked where they are assigned; TriangleMesh adds the operations."""

    _device: Any
    _origin: NDArray[np.float64]
    _arrays: dict[str, wp.array]
    _textures: tuple[NDArray[np.uint8], ...]
    _library: str = NUMPY  # whose arrays operations return, see core/array_libraries.py

    @classmethod
    def from_device_arrays(
        cls,
        vertices: wp.array,
        triangles: wp.array,
        *,
        vertex_normals: wp.array | None = None,
        vertex_colors: wp.array | None = None,
        triangle_uvs: wp.array | None = None,
        triangle_material_ids: wp.array | None = None,
        textures: tuple[NDArray[np.uint8], ...] = (),
        origin: Any = None,
        library: str = NUMPY,
    ) -> Self:
        """A mesh around device arrays, for kernels: nothing is copied or checked but types, lengths and devices.

        Args:
            vertices: vec3 [m], relative to `origin`.
            triangles: vec3i [t], or int32 [3 t] or [t, 3] (contiguous), whose memory is then shared.
            vertex_normals: vec3 [m].
            vertex_colors: vec3 [m], in 0..1.
            triangle_uvs: vec2 [3 t], three corners a triangle.
            triangle_material_ids: int32 [t].
            textures: uint8 pictures on the host.
            origin: float64 [3]; None for zero.
            library: Whose arrays its operations return.
        """
        given = {
            "vertices": vertices,
            "triangles": _as_triples(triangles),
            "vertex_normals": vertex_normals,
            "vertex_colors": vertex_colors,
            "triangle_uvs": triangle_uvs,
            "triangle_material_ids": triangle_material_ids,
        }
        arrays = {name: values for name, values in given.items() if values is not None}
        counts = {"vertices": vertices.size, "triangles": arrays["triangles"].size}
        for name, values in arrays.items():
            check_same_device(name, vertices.device, values.device)
            kind, count = _kind_and_count(name, counts)
            if values.dtype != kind or values.shape != (count,):
                raise ValueError(f"{name}: expected {kind.__name__} [{count}], got {values}")
        mesh = cls.__new__(cls)
        mesh._device, mesh._arrays, mesh._textures = vertices.device, arrays, tuple(textures)
        mesh._origin = np.zeros(3) if origin is None else np.array(origin, np.float64)
        mesh._library = library
        return mesh

    def with_arrays(self, *, origin: NDArray[np.float64] | None = None, **arrays: wp.array | None) -> Self:
        """The same mesh with some device arrays replaced, or dropped where None.

        Other triangles than before bring what belongs to them along: `triangles_at` gives it.
        """
        merged = self._arrays | arrays
        kept: dict[str, Any] = {name: values for name, values in merged.items() if values is not None}
        place = self._origin if origin is None else origin
        textures = self._textures if "triangle_uvs" in kept else ()
        mesh = self.from_device_arrays(**kept, textures=textures, origin=place, library=self._library)
        mesh._unit = self._unit
        return mesh

    @property
    def device_arrays(self) -> dict[str, wp.array]:
        """The device arrays by name, as `array` gives them one by one: for code that reads them."""
        return dict(self._arrays)

    @property
    def array_library(self) -> str:
        """The library whose arrays operations return: that of the arrays which the mesh was made of."""
        return self._library

    def handed_out(self, array: wp.array, *, dtype: DTypeLike | None = None) -> Any:
        """A result as an array of the library that the mesh was made of; see `hand_out`. NumPy's own their memory."""
        found = hand_out(array, self._library, dtype=dtype)
        return found.copy() if self._library == NUMPY and not found.flags.owndata else found

    def _per_vertex(self) -> dict[str, Any]:
        """What has one row a vertex, by name."""
        return {name: values for name, values in self._arrays.items() if name in PER_VERTEX}

    def triangles_at(self, rows: wp.array) -> dict[str, Any]:
        """What belongs to triangles, by name, at some of them: int32 device array, each in 0..t-1, repeats allowed."""
        taken: dict[str, Any] = {"triangles": gather_triangles(self._arrays["triangles"], rows)}
        if "triangle_uvs" in self._arrays:
            taken["triangle_uvs"] = gather_corners(self._arrays["triangle_uvs"], rows)
        if "triangle_material_ids" in self._arrays:
            taken["triangle_material_ids"] = gather_rows(self._arrays["triangle_material_ids"], rows)
        return taken

    def _assign(self, name: str, values: Any) -> None:
        count = self._arrays["vertices"].size
        if is_on_gpu(values):
            given = take_vectors(name, values, self._device)
            found = [given.size, 3]
        else:
            rows = check_rows(name, values, 3, dtype=np.float32)
            found = list(rows.shape)
            given = upload(rows, vec3, self._device, copied=library_of(values) == NUMPY)
        if given.size != count:
            raise ValueError(f"{name}: expected shape [{count}, 3], one row a vertex, got {found}")
        self._arrays[name] = given

    def _assign_uvs(self, values: Any) -> None:
        rows, count = check_rows("triangle_uvs", values, 2, dtype=np.float32), 3 * len(self)
        if len(rows) != count:
            raise ValueError(
                f"triangle_uvs: expected shape [{count}, 2], three rows a triangle, got {list(rows.shape)}"
            )
        self._arrays["triangle_uvs"] = upload(rows, vec2, self._device)

    def _assign_material_ids(self, values: Any) -> None:
        ids = check_numeric("triangle_material_ids", values)
        if ids.size and ids.dtype.kind not in "iu":
            raise TypeError(f"triangle_material_ids: expected whole numbers, got {ids.dtype}")
        if ids.shape != (len(self),):
            raise ValueError(f"triangle_material_ids: expected shape [{len(self)}], got {list(ids.shape)}")
        if ids.size and (ids.min() < 0 or ids.max() >= 2**31):
            raise ValueError(f"triangle_material_ids: expected 0 and up, got {ids.min()}..{ids.max()}")
        self._arrays["triangle_material_ids"] = upload(ids.astype(np.int32), int32, self._device)

    # -------------------------------------------------------------------------------------------- data

    def __len__(self) -> int:
        return self._arrays["triangles"].size

    def __repr__(self) -> str:
        extras = "".join(f", {name}" for name in self._arrays if name not in ("vertices", "triangles"))
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

    @property
    def triangle_uvs(self) -> NDArray[np.float32] | None:
        """Texture coordinates of corners, a float32 copy of shape [3 t, 2], or None; (0, 0) is the lower left corner.

        Three rows a triangle, so that a texture may have seams: corners at one vertex need not agree. Assigning takes
        any array-like, or None, which drops the textures and material numbers as well.
        """
        return self._read("triangle_uvs", 2)

    @triangle_uvs.setter
    def triangle_uvs(self, values: Any) -> None:
        if values is not None:
            self._assign_uvs(values)
            return
        for name in TEXTURE:
            self._arrays.pop(name, None)
        self._textures = ()

    @property
    def triangle_material_ids(self) -> NDArray[np.int32] | None:
        """Which of `textures` each triangle has, an int32 copy of shape [t], or None where all have the first."""
        ids = self._arrays.get("triangle_material_ids")
        return None if ids is None else read_only(download(ids).copy())

    @triangle_material_ids.setter
    def triangle_material_ids(self, values: Any) -> None:
        self._assign_material_ids(values)

    @property
    def textures(self) -> tuple[NDArray[np.uint8], ...]:
        """The pictures that `triangle_uvs` point into, uint8 [height, width, 3 or 4] each, top row first; on the host.

        Assigning takes a list of such pictures.
        """
        return self._textures

    @textures.setter
    def textures(self, values: Any) -> None:
        self._textures = check_textures("textures", values)

    def _read(self, name: str, width: int = 3) -> NDArray[np.float32] | None:
        return read_only(download(self._arrays[name]).reshape(-1, width).copy()) if name in self._arrays else None

    def array(self, name: str) -> wp.array:
        """A device array by name, shared without a copy (DLPack, `__cuda_array_interface__`).

        Args:
            name: "vertices" (vec3 [m], relative to `origin`), "triangles" (vec3i [t]), "vertex_normals" or
                "vertex_colors" (vec3 [m]), "triangle_uvs" (vec2 [3 t]), "triangle_material_ids" (int32 [t]).

        Raises:
            KeyError: The mesh has no such array.
        """
        if check_name("name", name) not in self._arrays:
            raise KeyError(f"{name}: this mesh has {', '.join(self._arrays)}")
        return self._arrays[name]

    def to(self, device: Any, *, arrays: str | None = None) -> Self:
        """The mesh on another device; itself where it is there already.

        Args:
            device: "cpu", "cuda:0", "auto".
            arrays: The library whose arrays its operations return, as of `PointCloud.to`.

        Raises:
            DeviceError: No such device.
            ValueError: No such library.
            ImportError: It is not installed.
        """
        target = resolve_device(device)
        library = self._library if arrays is None else check_library("arrays", arrays)
        if target == self._device and library == self._library:
            return self
        moved: dict[str, Any] = {name: move(values, target) for name, values in self._arrays.items()}
        mesh = self.with_arrays(**moved)
        mesh._library = library
        return mesh

    def copy(self) -> Self:
        """Another mesh over the same arrays: what is assigned to one does not reach the other."""
        return self.with_arrays()

    def __copy__(self) -> Self:
        return self.copy()

    def __deepcopy__(self, memo: dict[int, Any]) -> Self:
        arrays: dict[str, Any] = {name: clone(array) for name, array in self._arrays.items()}
        return self.with_arrays(**arrays)

    def __getstate__(self) -> dict[str, Any]:
        """The mesh as NumPy arrays and the name of its device, for pickle."""
        state = {"arrays": pickled(self._arrays), "origin": self._origin, "device": str(self._device)}
        return state | {"textures": self._textures, "library": self._library, "unit": self._unit}

    def __setstate__(self, state: dict[str, Any]) -> None:
        """The mesh on the device that it was on; on the first GPU where there is another number of them.

        Raises:
            DeviceError: It was on a GPU, and here is none.
        """
        self._device, self._origin = device_like("mesh", state["device"]), state["origin"]
        self._arrays, self._textures = unpickled(state["arrays"], self._device), state["textures"]
        self._library, self._unit = state["library"], state.get("unit")


def _kind_and_count(name: str, counts: dict[str, int]) -> tuple[Any, int]:
    """The type of an array and how many rows it has in a mesh."""
    if name in PER_VERTEX:
        return PER_VERTEX[name], counts["vertices"]
    return PER_TRIANGLE[name], counts["triangles"] * (3 if name in CORNERS else 1)


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

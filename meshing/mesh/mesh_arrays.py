"""What a mesh holds: vertices about a float64 origin, triangles, and what belongs to either, on one device."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from typing import Any, Self

import numpy as np
import warp as wp
from numpy.typing import DTypeLike, NDArray

from ...core.array_libraries import NUMPY, check_library, hand_out, library_of
from ...core.checks import check_colors, check_name, check_numeric, check_rows, check_textures, is_on_gpu
from ...core.devices import check_same_device, resolve_device
from ...core.dropped_results import returns_new
from ...core.gpu_arrays import take_colors, take_vectors
from ...kernels.arrays.select import gather_rows
from ...kernels.lang import int32, vec2, vec3
from ...kernels.memory import clone, download, move, upload
from ...kernels.meshes.mesh_edits import gather_corners, gather_triangles
from ...pcd.point_arrays import PointArrays, read_only
from .mesh_attributes import MeshAttributes, each, listed, rows_of
from .mesh_questions import MeshQuestions
from .mesh_rows import ATTRIBUTES, PER_TRIANGLE, PER_VERTEX, TEXTURE, as_triples, check_attributes, kind_and_count
from .mesh_up import Upright


class MeshArrays(Upright, MeshQuestions):
    """The arrays of a mesh by name, checked where they are assigned; TriangleMesh adds the operations."""

    _device: Any
    _origin: NDArray[np.float64]
    _attributes: dict[str, dict[str, wp.array]]  # by the names in ATTRIBUTES
    _library: str = NUMPY  # whose arrays operations return, see core/array_libraries.py

    @classmethod
    def _from_device_arrays(
        cls,
        vertices: wp.array,
        triangles: wp.array,
        *,
        vertex_normals: wp.array | None = None,
        vertex_colors: wp.array | None = None,
        triangle_uvs: wp.array | None = None,
        triangle_material_ids: wp.array | None = None,
        textures: tuple[NDArray[np.uint8], ...] = (),
        vertex_attributes: dict[str, wp.array] | None = None,
        triangle_attributes: dict[str, wp.array] | None = None,
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
            vertex_attributes: By name, scalars [m] or [m, c].
            triangle_attributes: By name, scalars [t] or [t, c].
            origin: float64 [3]; None for zero.
            library: Whose arrays its operations return.
        """
        given = {
            "vertices": vertices,
            "triangles": as_triples(triangles),
            "vertex_normals": vertex_normals,
            "vertex_colors": vertex_colors,
            "triangle_uvs": triangle_uvs,
            "triangle_material_ids": triangle_material_ids,
        }
        arrays = {name: values for name, values in given.items() if values is not None}
        counts = {"vertices": vertices.size, "triangles": arrays["triangles"].size}
        for name, values in arrays.items():
            check_same_device(name, vertices.device, values.device)
            kind, count = kind_and_count(name, counts)
            if values.dtype != kind or values.shape != (count,):
                raise ValueError(f"{name}: expected {kind.__name__} [{count}], got {values}")
        attributes = {
            "vertex_attributes": dict(vertex_attributes or {}),
            "triangle_attributes": dict(triangle_attributes or {}),
        }
        for kind, of in ATTRIBUTES.items():
            check_attributes(attributes[kind], counts[of], vertices.device)
        mesh = cls.__new__(cls)
        mesh._device, mesh._arrays, mesh._textures = vertices.device, arrays, tuple(textures)
        mesh._attributes = attributes
        mesh._origin = np.zeros(3) if origin is None else np.array(origin, np.float64)
        mesh._library = library
        return mesh

    def _with_arrays(self, *, origin: NDArray[np.float64] | None = None, **arrays: Any) -> Self:
        """The same mesh with some device arrays replaced, or dropped where None.

        Other triangles than before bring what belongs to them along: `_triangles_at` gives it; other vertices their
        `vertex_attributes`, as `attributes_at` gives them. Attributes that the change does not bring along, and whose
        rows are no longer as many, are left behind with a warning.
        """
        merged = self._arrays | self._attributes | arrays
        kept: dict[str, Any] = {name: values for name, values in merged.items() if values is not None}
        for kind, of in ATTRIBUTES.items():
            if self._attributes[kind] and kind not in arrays and kept[of].size != self._arrays[of].size:
                warnings.warn(f"{kind} {listed(kept.pop(kind))}: left behind, the {of} are others", stacklevel=3)
        place = self._origin if origin is None else origin
        textures = () if "triangle_uvs" in self._arrays and "triangle_uvs" not in kept else self._textures
        mesh = self._from_device_arrays(**kept, textures=textures, origin=place, library=self._library)
        mesh._unit, mesh._up = self._unit, self._up
        return mesh

    @property
    def _device_arrays(self) -> dict[str, wp.array]:
        """The device arrays by name, as `array` gives them one by one: for code that reads them."""
        return dict(self._arrays)

    @property
    def array_library(self) -> str:
        """The library whose arrays operations return: that of the arrays which the mesh was made of."""
        return self._library

    def _handed_out(self, array: wp.array, *, dtype: DTypeLike | None = None) -> Any:
        """A result as an array of the library that the mesh was made of; see `hand_out`. NumPy's own their memory."""
        found = hand_out(array, self._library, dtype=dtype)
        return found.copy() if self._library == NUMPY and not found.flags.owndata else found

    def _per_vertex(self) -> dict[str, Any]:
        """What has one row a vertex, by name."""
        return {name: values for name, values in self._arrays.items() if name in PER_VERTEX}

    def _triangles_at(self, rows: wp.array) -> dict[str, Any]:
        """What belongs to triangles, by name, at some of them: int32 device array, each in 0..t-1, repeats allowed."""
        taken: dict[str, Any] = {"triangles": gather_triangles(self._arrays["triangles"], rows)}
        if "triangle_uvs" in self._arrays:
            taken["triangle_uvs"] = gather_corners(self._arrays["triangle_uvs"], rows)
        if "triangle_material_ids" in self._arrays:
            taken["triangle_material_ids"] = gather_rows(self._arrays["triangle_material_ids"], rows)
        return taken | self._attributes_at("triangle_attributes", rows)

    def _vertices_at(self, rows: wp.array) -> dict[str, Any]:
        """What belongs to vertices, by name, at some of them: int32 device array, each in 0..m-1, repeats allowed."""
        taken = {name: gather_rows(values, rows) for name, values in self._per_vertex().items()}
        return taken | self._attributes_at("vertex_attributes", rows)

    def _attributes_at(self, kind: str, rows: wp.array) -> dict[str, Any]:
        """The attributes of vertices or of triangles at some of them, as `_with_arrays` takes them."""
        return {kind: rows_of(self._attributes[kind], rows)}

    def _assign(self, name: str, values: Any) -> None:
        if isinstance(values, PointArrays):  # whose array would be its points
            raise TypeError(f"{name}: expected an array, got a PointCloud; take one of its arrays")
        count = self._arrays["vertices"].size
        if is_on_gpu(values):
            given = (take_colors if name == "vertex_colors" else take_vectors)(name, values, self._device)
            found = [given.size, 3]
        else:
            rows = check_rows(name, values, 3, dtype=None if name == "vertex_colors" else np.float32)
            rows = check_colors(name, rows) if name == "vertex_colors" else rows
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

    def __repr__(self) -> str:
        extras = "".join(f", {name}" for name in self._arrays if name not in ("vertices", "triangles"))
        extras += "".join(f", {kind}[{listed(held)}]" for kind, held in self._attributes.items() if held)
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
        """Positions [m], a float64 copy of shape [m, 3] with the origin added; assigning takes any array-like."""
        return read_only(download(self._arrays["vertices"]).astype(np.float64).reshape(-1, 3) + self._origin)

    @vertices.setter
    def vertices(self, values: Any) -> None:
        kind: Any = type(self)
        made = kind(values, device=self._device)
        count = self._arrays["vertices"].size
        held = [name for name in PER_VERTEX if name in self._arrays and name != "vertices"]
        if made.array("vertices").size != count and (held or len(self)):
            has = f"{count} vertices" + "".join(f", {name}" for name in ("triangles", *held) if name in self._arrays)
            raise ValueError(
                f"vertices: expected shape [{count}, 3] as the mesh has {has}, got {list(made.vertices.shape)}; "
                "TriangleMesh(vertices, triangles) makes another mesh"
            )
        self._arrays["vertices"], self._origin = made._arrays["vertices"], made._origin

    @property
    def triangles(self) -> NDArray[np.int32]:
        """Vertex numbers, an int32 copy of shape [t, 3]; assigning takes any array-like.

        With texture coordinates or material numbers their count stays: three rows of those belong to each triangle.
        """
        return read_only(download(self._arrays["triangles"]).reshape(-1, 3).copy())

    @triangles.setter
    def triangles(self, values: Any) -> None:
        kind: Any = type(self)
        made = kind(np.zeros((self._arrays["vertices"].size, 3)), values, device=self._device)
        held = [name for name in TEXTURE if name in self._arrays]
        if held and len(made) != len(self):
            raise ValueError(
                f"triangles: expected shape [{len(self)}, 3] as the mesh has {', '.join(held)}, got [{len(made)}, 3]; "
                "mesh.triangle_uvs = None drops them"
            )
        self._arrays["triangles"] = made._arrays["triangles"]

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

    @property
    def vertex_attributes(self) -> MeshAttributes:
        """Further values at vertices, a mapping of NumPy arrays of shape [m] or [m, c]: to set an item sets the mesh's.

        They follow what is selected, joined, cut and subdivided: floating ones are interpolated at new vertices, of
        others a new vertex takes those of the nearest old one.
        """
        vertices = self._arrays["vertices"].size
        return MeshAttributes(
            self._attributes["vertex_attributes"], vertices, self._device, "vertex", tuple(PER_VERTEX)
        )

    @property
    def triangle_attributes(self) -> MeshAttributes:
        """The same for triangles, shape [t] or [t, c]; parts of a triangle have its values."""
        fields = tuple(PER_TRIANGLE)
        return MeshAttributes(self._attributes["triangle_attributes"], len(self), self._device, "triangle", fields)

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

    @returns_new
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
        mesh = self._with_each(lambda values: move(values, target))
        mesh._library = library
        return mesh

    @returns_new
    def clear(self) -> Self:
        """A mesh without vertices and triangles on the same device: `mesh = mesh.clear()`."""
        kind: Any = type(self)
        return kind(device=self._device)

    @returns_new
    def copy(self) -> Self:
        """Another mesh over the same arrays: what is assigned to one does not reach the other."""
        return self._with_arrays()

    def __copy__(self) -> Self:
        return self.copy()

    def __deepcopy__(self, memo: dict[int, Any]) -> Self:
        return self._with_each(clone)

    def _bare(self) -> Self:
        """The mesh without further attributes."""
        return self._with_arrays(**dict.fromkeys(ATTRIBUTES))

    def _with_each(self, change: Callable[[wp.array], Any]) -> Self:
        """The mesh with every array changed alike."""
        changed: dict[str, Any] = each(self._arrays, change)
        changed |= {kind: each(held, change) for kind, held in self._attributes.items()}
        return self._with_arrays(**changed)

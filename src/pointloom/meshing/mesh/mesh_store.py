"""Device arrays of a mesh with their origin, attributes and textures, for the modules of this package."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, MutableMapping
from typing import Any

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ...core.array_libraries import NUMPY, owned, shared_view
from ...core.checks import check_name, shown
from ...core.devices import check_same_device
from ...core.escaped_text import escaped
from ...core.up_axis import Direction
from ...kernels.array_types import Device
from ...kernels.arrays.select import gather_rows
from ...kernels.lang import int32, vec2, vec3, vec3i
from ...kernels.meshes.mesh_edits import gather_corners
from ...pcd.attribute_columns import upload_column
from ...pcd.point_store import ArrayStore
from ...pcd.stored_arrays import read_only

PER_VERTEX = {"vertices": vec3, "vertex_normals": vec3, "vertex_colors": vec3}
PER_TRIANGLE = {"triangles": vec3i, "triangle_uvs": vec2, "triangle_material_ids": int32}
TEXTURE = ("triangle_uvs", "triangle_material_ids")
CORNERS = ("triangle_uvs",)  # three rows per triangle
ATTRIBUTES = {"vertex_attributes": "vertices", "triangle_attributes": "triangles"}  # and arrays of the same rows
Arrays = dict[str, wp.array]
Textures = tuple[NDArray[np.uint8], ...]


def kind_and_count(name: str, counts: dict[str, int]) -> tuple[Any, int]:
    if name in PER_VERTEX:
        return PER_VERTEX[name], counts["vertices"]
    return PER_TRIANGLE[name], counts["triangles"] * (3 if name in CORNERS else 1)


def check_attributes(attributes: dict[str, wp.array], count: int, device: Device) -> None:
    for name, values in attributes.items():
        check_same_device(name, device, values.device)
        if values.ndim not in (1, 2) or values.shape[0] != count:
            raise ValueError(f"{escaped(name)}: expected scalars [{count}] or [{count}, c], got {values}")


def as_triples(triangles: wp.array) -> wp.array:
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


class MeshAttributes(MutableMapping[str, NDArray[Any]]):
    """Read-only NumPy attributes of shape (n,) or (n, c) by name, n the mesh's vertices or triangles. Assignment
    accepts numbers of up to 64 bits and booleans, and keeps the type."""

    def __init__(self, store: ArrayStore, arrays: Arrays, count: int, of: str, fields: tuple[str, ...]):
        self._store, self._arrays, self._count, self._of, self._fields = store, arrays, count, of, fields

    def __getitem__(self, name: str) -> NDArray[Any]:
        return read_only(owned(self._arrays[name]))

    def __setitem__(self, name: str, values: ArrayLike) -> None:
        if check_name("name", name) in self._fields:
            raise KeyError(f"{name}: not a custom attribute. Assign mesh.{name}")
        self._arrays[name] = upload_column(name, values, self._count, self._store.device, of=self._of)

    def __delitem__(self, name: str) -> None:
        del self._arrays[name]

    def __iter__(self) -> Iterator[str]:
        return iter(list(self._arrays))

    def __len__(self) -> int:
        return len(self._arrays)

    def __repr__(self) -> str:
        return "{" + ", ".join(f"{name!r}: {values.dtype} {list(values.shape)}" for name, values in self.items()) + "}"

    def _ipython_key_completions_(self) -> list[str]:
        return list(self)

    @property
    def name(self) -> str:
        """ "vertex_attributes" or "triangle_attributes"."""
        return "vertex_attributes" if self._of == "vertices" else "triangle_attributes"

    @property
    def arrays(self) -> Arrays:
        return dict(self._arrays)

    def array(self, name: str) -> Any:
        """Shared array of an attribute, as of `TriangleMesh.array`. KeyError if missing."""
        return shared_view(self._arrays[name], self._store.library)


def assign_all(attributes: MeshAttributes, given: Mapping[str, Any] | None) -> None:
    """Assign a mapping. TypeError if it is none. None assigns nothing."""
    if given is not None and not isinstance(given, Mapping):
        raise TypeError(f"{attributes.name}: expected arrays by name, got {shown(given)}")
    for name, values in (given or {}).items():
        attributes[name] = values


def each(arrays: Arrays, change: Callable[[wp.array], Any]) -> dict[str, Any]:
    return {name: change(values) for name, values in arrays.items()}


def rows_of(arrays: Arrays, rows: wp.array) -> dict[str, Any]:
    return each(arrays, lambda values: gather_rows(values, rows))


def listed(names: Iterable[str]) -> str:
    """Names in one line of text, without control characters."""
    return escaped(", ".join(names))


class MeshStore(ArrayStore):
    """Arrays of a mesh: those of `mesh.array`. `mesh.arrays` is one.

    Attributes:
        attributes: Arrays of `vertex_attributes` and `triangle_attributes` by name.
        textures: Images, uint8 (height, width, 3 or 4), on the host.
        up: Up direction. None if unknown.
    """

    __slots__ = ("attributes", "textures", "up")

    def __init__(
        self, arrays: Mapping[str, Any], origin: NDArray[np.float64], library: str = NUMPY, *, textures: Textures = ()
    ):
        super().__init__({name: rows for name, rows in arrays.items() if rows is not None and name not in ATTRIBUTES})
        self.origin, self.library, self.textures = np.array(origin, np.float64), library, tuple(textures)
        self.attributes = {kind: dict(arrays.get(kind) or {}) for kind in ATTRIBUTES}
        self.up: Direction | None = None

    @property
    def vertex_count(self) -> int:
        return self["vertices"].size

    def per_vertex(self) -> Arrays:
        return {name: values for name, values in self.items() if name in PER_VERTEX}

    def triangles_at(self, rows: wp.array) -> dict[str, Any]:
        """Triangle data at rows, an int32 device array with repeats allowed. Arguments of `with_arrays`."""
        selected: dict[str, Any] = {"triangles": gather_rows(self["triangles"], rows)}
        if "triangle_uvs" in self:
            selected["triangle_uvs"] = gather_corners(self["triangle_uvs"], rows)
        if "triangle_material_ids" in self:
            selected["triangle_material_ids"] = gather_rows(self["triangle_material_ids"], rows)
        return selected | self.attributes_at("triangle_attributes", rows)

    def vertices_at(self, rows: wp.array) -> dict[str, Any]:
        """Vertex data at rows, an int32 device array with repeats allowed. Arguments of `with_arrays`."""
        selected = {name: gather_rows(values, rows) for name, values in self.per_vertex().items()}
        return selected | self.attributes_at("vertex_attributes", rows)

    def attributes_at(self, kind: str, rows: wp.array) -> dict[str, Arrays]:
        """Attributes of vertices or triangles at rows. Arguments of `with_arrays`."""
        return {kind: rows_of(self.attributes[kind], rows)}

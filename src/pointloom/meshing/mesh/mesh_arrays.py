"""Arrays of a mesh: vertices, triangles and attributes on one device, sums of meshes, affine maps."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, Self, TypeVar

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ...core.array_libraries import NUMPY, check_library, library_of, owned, shared_view
from ...core.callable_bool import CallableBool
from ...core.checks import (
    check_color,
    check_colors,
    check_finite,
    check_list,
    check_name,
    check_numeric,
    check_rows,
    check_shape,
    check_textures,
    check_transformation,
    is_on_gpu,
)
from ...core.coordinate_systems import Reprojection
from ...core.coordinates import choose_origin, origin_under
from ...core.devices import DeviceLike, check_same_device, resolve_device
from ...core.dropped_results import returns_new
from ...core.escaped_text import escaped
from ...core.exchange import on_host
from ...core.gpu_arrays import take_colors, take_vectors
from ...core.html_tables import array_type, html_table
from ...core.joined_parts import ESTIMATED, missing_names, warn_of_missing
from ...core.other_geometry import conversion_of
from ...core.pickled_arrays import device_like, pickled, unpickled, unpickling
from ...core.units import warn_of_units
from ...core.up_axis import Direction, check_up, transform_up_vector
from ...io.table import MeshTable
from ...kernels.algebra.transform import transform_directions, transform_points
from ...kernels.arrays.bounds import bound_points
from ...kernels.arrays.concatenation import concatenate_points, concatenate_rows
from ...kernels.extent.mean_covariance import mean_and_covariance
from ...kernels.lang import int32, vec2, vec3
from ...kernels.linear_algebra import det, inv, matmul
from ...kernels.memory import clone, download, full, move, upload, zeros
from ...kernels.meshes import mesh_edits
from ...kernels.meshes.mesh_edits import raise_numbers, shift_triangles
from ...pcd.attribute_columns import concatenate_columns
from ...pcd.motion import Movable
from ...pcd.point_arrays import PointArrays, place_points
from ...pcd.point_store import sample_about
from ...pcd.stored_arrays import StoredArrays, read_only
from ...pcd.units import common_reference, crs_under, unit_under
from .mesh_checks import check_finite_corners
from .mesh_store import (
    ATTRIBUTES,
    PER_TRIANGLE,
    PER_VERTEX,
    TEXTURE,
    MeshAttributes,
    MeshStore,
    Textures,
    as_triples,
    check_attributes,
    each,
    kind_and_count,
    listed,
)

Mesh = TypeVar("Mesh", bound="MeshArrays")  # a mesh and the result of an operation on it

MAX_INT32 = 2**31 - 1  # 32-bit indices


class MeshArrays(StoredArrays, Movable):
    """Vertices, triangles and attributes of a mesh, validated on assignment. Base of TriangleMesh."""

    arrays: MeshStore  # device arrays for the modules of this package
    _internal = ("without_attributes",)

    def __len__(self) -> int:
        return self.arrays["triangles"].size

    def _repr_html_(self) -> str:
        arrays = [*self.arrays.items()]
        arrays += [
            (f"{kind}[{name!r}]", column) for kind, of in self.arrays.attributes.items() for name, column in of.items()
        ]
        arrays += [(f"textures[{number}]", image) for number, image in enumerate(self.arrays.textures)]
        return html_table(repr(self), ((name, array_type(values)) for name, values in arrays))

    @property
    def has_vertices(self) -> CallableBool:
        """True if there are vertices. Also callable."""
        return CallableBool(self.arrays["vertices"].size)

    @property
    def has_triangles(self) -> CallableBool:
        """True if there are triangles. Also callable."""
        return CallableBool(len(self))

    @property
    def has_vertex_normals(self) -> CallableBool:
        """True if there are vertex normals. Also callable."""
        return CallableBool("vertex_normals" in self.arrays)

    @property
    def has_vertex_colors(self) -> CallableBool:
        """True if there are vertex colors. Also callable."""
        return CallableBool("vertex_colors" in self.arrays)

    @property
    def has_triangle_uvs(self) -> CallableBool:
        """True if there are texture coordinates. Also callable."""
        return CallableBool("triangle_uvs" in self.arrays)

    @property
    def has_textures(self) -> CallableBool:
        """True if there are texture images. Also callable."""
        return CallableBool(len(self.arrays.textures))

    @property
    def is_empty(self) -> CallableBool:
        """True if there are no vertices. Also callable."""
        return CallableBool(self.arrays["vertices"].size == 0)

    @property
    def up(self) -> Direction | None:
        """Up direction, a unit vector, from a glTF file or assigned. None if unknown (views then use z).

        Assign an axis ("y") or a direction. Vertices do not change. Operations keep it and rotations rotate it.

        Raises:
            TypeError, ValueError: If the value is not "x", "y", "z" or a direction of nonzero length.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> mesh = loom.TriangleMesh.create_cone()
            >>> mesh.up = "y"
            >>> mesh.rotate(np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]]), (0, 0, 0)).up
            (0.0, 0.0, 1.0)
        """
        return self.arrays.up

    @up.setter
    def up(self, value: ArrayLike | str | None) -> None:
        self.arrays.up = None if value is None else check_up(value)

    @classmethod
    def from_device_arrays(
        cls, arrays: Mapping[str, Any], origin: NDArray[np.float64], library: str = NUMPY, *, textures: Textures = ()
    ) -> Self:
        """Create a mesh from device arrays by name without copies. Only types, lengths and devices are checked.

        Args:
            arrays: Arrays of `array`, None for none. `triangles` is vec3i (t,), or int32 (3 t,) or (t, 3), shared.
                `vertex_attributes` and `triangle_attributes` are arrays by name.
            origin: Origin of the vertices [m].
            library: Library of the arrays that operations return.
            textures: uint8 images on the host.
        """
        store = MeshStore({**arrays, "triangles": as_triples(arrays["triangles"])}, origin, library, textures=textures)
        device = store["vertices"].device
        counts = {"vertices": store["vertices"].size, "triangles": store["triangles"].size}
        for name, values in store.items():
            check_same_device(name, device, values.device)
            kind, count = kind_and_count(name, counts)
            if values.dtype != kind or values.shape != (count,):
                raise ValueError(f"{name}: expected {kind.__name__} [{count}], got {values}")
        for kind, of in ATTRIBUTES.items():
            check_attributes(store.attributes[kind], counts[of], device)
        mesh = cls.__new__(cls)
        vars(mesh)["arrays"] = store
        return mesh

    def with_arrays(self, *, origin: NDArray[np.float64] | None = None, **arrays: Any) -> Self:
        """Copy with some device arrays replaced, or dropped if None. New triangles need their data from
        `MeshStore.triangles_at`, new vertices those from `MeshStore.attributes_at`. Other attributes whose row count
        no longer matches are dropped with a warning."""
        merged: dict[str, Any] = self.arrays | self.arrays.attributes | arrays
        remaining = {name: values for name, values in merged.items() if values is not None}
        for kind, of in ATTRIBUTES.items():
            if self.arrays.attributes[kind] and kind not in arrays and remaining[of].size != self.arrays[of].size:
                warn_of_units(f"{kind} {listed(remaining.pop(kind))}: dropped, because the {of} changed", UserWarning)
        new_origin = self.arrays.origin if origin is None else origin
        textures = () if "triangle_uvs" in self.arrays and "triangle_uvs" not in remaining else self.arrays.textures
        mesh = self.from_device_arrays(remaining, new_origin, self.arrays.library, textures=textures)
        mesh.unit, mesh.crs, mesh.arrays.up = self.unit, self.crs, self.arrays.up
        return mesh

    def _assign(self, name: str, values: ArrayLike) -> None:
        if isinstance(values, PointArrays):  # its `array` would be its points
            raise TypeError(f"{name}: expected an array, got a PointCloud. Pass one of its arrays")
        count = self.arrays["vertices"].size
        if is_on_gpu(values):
            given = (take_colors if name == "vertex_colors" else take_vectors)(name, values, self.device)
            shape = [given.size, 3]
        else:
            rows = check_rows(name, values, 3, dtype=None if name == "vertex_colors" else np.float32)
            rows = check_colors(name, rows) if name == "vertex_colors" else rows
            shape = list(rows.shape)
            given = upload(rows, vec3, self.device, copied=library_of(values) == NUMPY)
        if given.size != count:
            raise ValueError(f"{name}: expected shape [{count}, 3], one row per vertex, got {shape}")
        self.arrays[name] = given

    def _assign_uvs(self, values: ArrayLike) -> None:
        rows, count = check_rows("triangle_uvs", on_host("triangle_uvs", values), 2, dtype=np.float32), 3 * len(self)
        if len(rows) != count:
            raise ValueError(
                f"triangle_uvs: expected shape [{count}, 2], three rows per triangle, got {list(rows.shape)}"
            )
        self.arrays["triangle_uvs"] = upload(rows, vec2, self.device)

    def _assign_material_ids(self, values: ArrayLike) -> None:
        ids = check_numeric("triangle_material_ids", on_host("triangle_material_ids", values))
        if ids.size and ids.dtype.kind not in "iu":
            raise TypeError(f"triangle_material_ids: expected whole numbers, got {ids.dtype}")
        if ids.shape != (len(self),):
            raise ValueError(f"triangle_material_ids: expected shape [{len(self)}], got {list(ids.shape)}")
        if ids.size and (ids.min() < 0 or ids.max() >= 2**31):
            raise ValueError(f"triangle_material_ids: expected values >= 0, got {ids.min()}..{ids.max()}")
        self.arrays["triangle_material_ids"] = upload(ids.astype(np.int32), int32, self.device)

    def __repr__(self) -> str:
        extras = "".join(f", {name}" for name in self.arrays if name not in ("vertices", "triangles"))
        extras += "".join(f", {kind}[{listed(columns)}]" for kind, columns in self.arrays.attributes.items() if columns)
        sizes = f"{self.arrays['vertices'].size} vertices, {len(self)} triangles"
        extras += "" if self.crs is None else f", {escaped(self.crs.name)}"
        return f"{type(self).__name__}({sizes}{extras}, {self.device})"

    @property
    def vertices(self) -> NDArray[np.float64]:
        """Positions [m], float64 copy (m, 3) with the origin added; assignable, which keeps the other arrays."""
        return read_only(download(self.arrays["vertices"]).astype(np.float64).reshape(-1, 3) + self.arrays.origin)

    @vertices.setter
    def vertices(self, values: ArrayLike) -> None:
        kind: Any = type(self)
        is_placed = self._in_degrees and not is_on_gpu(values)
        origin = choose_origin(check_rows("vertices", values, 3), in_degrees=True) if is_placed else None
        made = kind(values, device=self.device, origin=origin)
        count = self.arrays["vertices"].size
        per_vertex = [name for name in PER_VERTEX if name in self.arrays and name != "vertices"]
        if made.arrays["vertices"].size != count and (per_vertex or len(self)):
            has = f"{count} vertices" + "".join(
                f", {name}" for name in ("triangles", *per_vertex) if name in self.arrays
            )
            raise ValueError(
                f"vertices: expected shape [{count}, 3] as the mesh has {has}, got {list(made.vertices.shape)}; "
                "TriangleMesh(vertices, triangles) creates another mesh"
            )
        self.arrays["vertices"], self.arrays.origin = made.arrays["vertices"], made.arrays.origin

    @property
    def triangles(self) -> NDArray[np.int32]:
        """Vertex indices, int32 copy (t, 3); assignable. Texture coordinates or material ids fix the count."""
        return read_only(owned(self.arrays["triangles"]).reshape(-1, 3))

    @triangles.setter
    def triangles(self, values: ArrayLike) -> None:
        kind: Any = type(self)
        made = kind(np.zeros((self.arrays["vertices"].size, 3)), values, device=self.device)
        per_triangle = [name for name in TEXTURE if name in self.arrays]
        if per_triangle and len(made) != len(self):
            raise ValueError(
                f"triangles: expected shape [{len(self)}, 3] as the mesh has {', '.join(per_triangle)}, "
                f"got [{len(made)}, 3]; mesh.triangle_uvs = None drops them"
            )
        self.arrays["triangles"] = made.arrays["triangles"]

    @property
    def vertex_normals(self) -> NDArray[np.float32] | None:
        """Normals, float32 copy (m, 3), or None; assignable."""
        return self._read("vertex_normals")

    @vertex_normals.setter
    def vertex_normals(self, values: ArrayLike) -> None:
        self._assign("vertex_normals", values)

    @property
    def vertex_colors(self) -> NDArray[np.float32] | None:
        """Colors in 0..1, float32 copy (m, 3), or None; assignable."""
        return self._read("vertex_colors")

    @vertex_colors.setter
    def vertex_colors(self, values: ArrayLike) -> None:
        self._assign("vertex_colors", values)

    @property
    def triangle_uvs(self) -> NDArray[np.float32] | None:
        """Texture coordinates of corners, float32 copy (3 t, 2), or None; (0, 0) is the lower left corner.

        Three rows per triangle, which allows seams. Assigning None also drops textures and material ids.
        """
        return self._read("triangle_uvs", 2)

    @triangle_uvs.setter
    def triangle_uvs(self, values: ArrayLike) -> None:
        if values is not None:
            self._assign_uvs(values)
            return
        for name in TEXTURE:
            self.arrays.pop(name, None)
        self.arrays.textures = ()

    @property
    def triangle_material_ids(self) -> NDArray[np.int32] | None:
        """Index into `textures` per triangle, int32 copy (t,), or None if all use the first."""
        ids = self.arrays.get("triangle_material_ids")
        return None if ids is None else read_only(owned(ids))

    @triangle_material_ids.setter
    def triangle_material_ids(self, values: ArrayLike) -> None:
        self._assign_material_ids(values)

    @property
    def textures(self) -> tuple[NDArray[np.uint8], ...]:
        """Texture images, uint8 (height, width, 3 or 4), top row first, on the host; assignable as a list."""
        return self.arrays.textures

    @textures.setter
    def textures(self, values: ArrayLike) -> None:
        self.arrays.textures = check_textures("textures", values)

    @property
    def vertex_attributes(self) -> MeshAttributes:
        """Additional vertex values, a mutable mapping of NumPy arrays of shape (m,) or (m, c).

        Operations keep them: floating values are interpolated at new vertices, others copied from the nearest.
        """
        vertices, own = self.arrays["vertices"].size, self.arrays.attributes["vertex_attributes"]
        return MeshAttributes(self.arrays, own, vertices, "vertex", tuple(PER_VERTEX))

    @property
    def triangle_attributes(self) -> MeshAttributes:
        """Additional triangle values, shape (t,) or (t, c). Parts of a triangle inherit its values."""
        own = self.arrays.attributes["triangle_attributes"]
        return MeshAttributes(self.arrays, own, len(self), "triangle", tuple(PER_TRIANGLE))

    def _read(self, name: str, width: int = 3) -> NDArray[np.float32] | None:
        return read_only(owned(self.arrays[name]).reshape(-1, width)) if name in self.arrays else None

    def array(self, name: str) -> Any:
        """Get an array by name without a copy, in the library of the mesh (`array_library`) and on its device.

        Args:
            name: "vertices" (relative to `origin`), "vertex_normals" or "vertex_colors", each float32 (m, 3),
                "triangles" (int32 (t, 3)), "triangle_uvs" (float32 (3 t, 2)), "triangle_material_ids" (int32 (t,)).

        Returns:
            A NumPy array, a torch tensor, and so on, as of `PointCloud.array`. Warp's arrays have vectors.

        Raises:
            KeyError: If the mesh has no such array.
        """
        if check_name("name", name) not in self.arrays:
            raise KeyError(f"{escaped(name)}: expected one of the mesh's arrays: {', '.join(self.arrays)}")
        return shared_view(self.arrays[name], self.arrays.library)

    @returns_new
    def to(self, device: DeviceLike, *, arrays: str | None = None) -> Self:
        """Copy the mesh to another device. Returns the mesh itself if it is already there.

        Args:
            device: "cpu", "cuda:0" or "auto".
            arrays: Library of returned arrays, as of `PointCloud.to`.

        Raises:
            DeviceError: If the device does not exist.
            ValueError, ImportError: If the library is unknown or not installed.
        """
        target = resolve_device(device)
        library = self.arrays.library if arrays is None else check_library("arrays", arrays)
        if target == self.device and library == self.arrays.library:
            return self
        mesh = self._with_each(lambda values: move(values, target))
        mesh.arrays.library = library
        return mesh

    @returns_new
    def copy(self) -> Self:
        """Copy that shares arrays. Assignments to one do not affect the other."""
        return self.with_arrays()

    def __deepcopy__(self, memo: dict[int, Any]) -> Self:
        return self._with_each(clone)

    def without_attributes(self) -> Self:
        return self.with_arrays(**dict.fromkeys(ATTRIBUTES))

    def _with_each(self, change: Callable[[wp.array], Any]) -> Self:
        """Apply a function to every array."""
        changed: dict[str, Any] = each(self.arrays, change)
        changed |= {kind: each(columns, change) for kind, columns in self.arrays.attributes.items()}
        return self.with_arrays(**changed)

    def __add__(self, other: object) -> Self:
        if not isinstance(other, MeshArrays):
            return NotImplemented
        return self.concatenate([self, other])

    def __radd__(self, other: object) -> Self:
        if isinstance(other, int) and other == 0:
            return self.copy()
        return NotImplemented

    @classmethod
    def concatenate(cls, meshes: Iterable[MeshArrays]) -> Self:
        """Concatenate meshes without merging vertices. See `remove_duplicated_vertices`.

        Keeps the attributes that all non-empty meshes have, as Open3D's `+`. Textures are appended. The origin is the
        largest mesh's. `up` is unknown if two meshes have different ones.

        Args:
            meshes: At least one, all on one device.

        Raises:
            ValueError: If there is no mesh, an attribute's columns differ, or there are more than 2^31 - 1 rows.
            TypeError: If an item is not a mesh, or an attribute's types differ.
            DeviceError: If the meshes are on different devices.

        Warns:
            UserWarning: If only some meshes have an array or textures, which are dropped then.

        Example:
            >>> import pointloom as loom
            >>> box = loom.TriangleMesh.create_box()
            >>> both = box + box.translate([2, 0, 0])
            >>> both.get_volume(), len(loom.TriangleMesh.concatenate([box] * 10))
            (2.0, 120)
        """
        if isinstance(meshes, PointArrays):
            check_mesh("meshes", meshes)
        given = check_list("meshes", meshes, "triangle meshes")
        if not given:
            raise ValueError("meshes: expected at least one mesh, got none")
        for mesh in given:
            check_mesh("meshes", mesh)
            check_same_device("meshes", mesh.device, given[0].device)
        parts = [mesh for mesh in given if mesh.arrays["vertices"].size] or given[:1]
        for name in ("vertices", "triangles"):
            if sum(mesh.arrays[name].size for mesh in parts) > MAX_INT32:
                raise ValueError(f"meshes: expected at most 2^31 - 1 {name} in total. Split them into several meshes")
        return cls._joined(parts)

    @classmethod
    def _joined(cls, parts: list[MeshArrays]) -> Self:
        origin = max(parts, key=lambda mesh: mesh.arrays["vertices"].size).arrays.origin
        shifts = [mesh.arrays.origin - origin for mesh in parts]
        arrays: dict[str, Any] = {
            "vertices": concatenate_points([mesh.arrays["vertices"] for mesh in parts], shifts),
            "triangles": concatenate_rows(_numbered(parts)),
        }
        per_vertex, missing = [mesh.arrays.per_vertex() for mesh in parts], []
        for name in _shared(per_vertex, missing):
            if name != "vertices":
                arrays[name] = concatenate_rows([rows[name] for rows in per_vertex])
        for kind, of in ATTRIBUTES.items():
            columns = [mesh.arrays.attributes[kind] for mesh in parts if mesh.arrays[of].size]
            arrays[kind] = {
                name: concatenate_columns(name, [of_part[name] for of_part in columns], "meshes")
                for name in _shared(columns, missing)
            }
        uvs, textures = _joined_textures(parts, missing)
        warn_of_missing("meshes", [name for name in missing if name not in ESTIMATED], "meshes")
        joined = cls.from_device_arrays(arrays | uvs, origin, parts[0].array_library, textures=textures)
        joined.unit, joined.crs = common_reference("meshes", parts)
        known = {mesh.arrays.up for mesh in parts} - {None}
        joined.arrays.up = known.pop() if len(known) == 1 else None
        return joined

    def __getstate__(self) -> dict[str, Any]:
        state = {"arrays": pickled(self.arrays), "origin": self.arrays.origin, "device": str(self.device)}
        attributes = {kind: pickled(columns) for kind, columns in self.arrays.attributes.items()}
        state |= {"textures": self.arrays.textures, "library": self.arrays.library, "attributes": attributes}
        return state | {"unit": self._unit, "crs": self._crs, "up": self.arrays.up}

    def __setstate__(self, state: dict[str, Any]) -> None:
        """Restore on the saved device, or the first GPU if its index does not exist."""
        with unpickling("mesh"):
            device, given = device_like("mesh", state["device"]), state["arrays"]
            vertices, triangles = (np.asarray(given[name][0]).reshape(-1, 3) for name in ("vertices", "triangles"))
            ids = given["triangle_material_ids"][0] if "triangle_material_ids" in given else None
            MeshTable(vertices, triangles, triangle_material_ids=ids).checked()
            arrays: dict[str, Any] = unpickled(given, device)
            arrays |= {kind: unpickled(state["attributes"][kind], device) for kind in ATTRIBUTES}
            textures = check_textures("textures", state["textures"])
            origin = check_finite("origin", check_shape("origin", state["origin"], (3,)))
            library = check_library("library", state["library"])
            mesh = self.from_device_arrays(arrays, origin, library, textures=textures)
            mesh.unit, mesh.crs, mesh.up = state.get("unit"), state.get("crs"), state.get("up")
        vars(self).update(vars(mesh))

    @returns_new
    def transform(self, transformation: ArrayLike) -> Self:
        """Apply an affine transformation.

        Args:
            transformation: Finite, invertible 4x4 matrix with last row (0, 0, 0, 1).

        Returns:
            The mesh. Normals use the inverse transpose and keep their lengths. Reflections reverse triangles.

        Raises:
            ValueError: If the matrix is invalid.
        """
        return self._mapped("transformation", check_transformation("transformation", transformation))

    def _mapped(self, name: str, T: NDArray[np.float64]) -> Self:
        """Apply an affine map; `name` is the argument reported in errors."""
        A, determinant = T[:3, :3], float(det(T[:3, :3]))
        if determinant == 0:
            raise ValueError(f"{name}: expected an invertible matrix, got a singular one")
        target = matmul(A, self.arrays.origin) + T[:3, 3]
        low, high, finite = bound_points(self.arrays["vertices"])  # sync
        low, high = (low, high) if finite else (np.zeros(3), np.zeros(3))
        local = (lambda: sample_about(self.arrays["vertices"], np.zeros(3))) if self.arrays.origin.any() else None
        origin = origin_under(name, A, target, low, high, target, in_degrees=self._in_degrees, sample=local)
        arrays: dict[str, Any] = {"vertices": transform_points(self.arrays["vertices"], A, target - origin)}
        if "vertex_normals" in self.arrays and not np.array_equal(A, np.eye(3)):
            arrays["vertex_normals"] = transform_directions(self.arrays["vertex_normals"], inv(A).T)
        if determinant < 0:
            arrays["triangles"] = mesh_edits.flip_triangles(self.arrays["triangles"])
            if "triangle_uvs" in self.arrays:
                arrays["triangle_uvs"] = mesh_edits.flip_corners(self.arrays["triangle_uvs"])
        mesh = self.with_arrays(origin=origin, **arrays)
        mesh.unit, mesh.crs = unit_under(self.unit, A), crs_under(self.crs, A)
        mesh.arrays.up = transform_up_vector(self.arrays.up, A)
        return mesh

    def _reprojected(self, way: Reprojection) -> Self:
        positions = self.vertices
        vertices, origin, _ = place_points(
            way.points(positions), None, self.device, in_degrees=way.unit_name == "degree"
        )
        arrays: dict[str, Any] = {"vertices": vertices}
        if "vertex_normals" in self.arrays:
            normals = way.normals(positions, download(self.arrays["vertex_normals"]))
            arrays["vertex_normals"] = upload(normals.astype(np.float32), vec3, self.device)
        return self.with_arrays(origin=origin, **arrays)

    def _enlarged(self, factor: float) -> Self:
        vertices = transform_points(self.arrays["vertices"], factor * np.eye(3), np.zeros(3))
        return self.with_arrays(origin=self.arrays.origin * factor, vertices=vertices)

    def get_center(self) -> NDArray[np.float64]:
        """Mean of the finite vertices [m], shape (3,); zeros if there are none.

        Raises:
            ValueError: If a triangle has a corner that is not finite.
        """
        check_finite_corners("get_center", self)
        return self._finite_center()

    def _finite_center(self) -> NDArray[np.float64]:
        count, mean, _ = mean_and_covariance(self.arrays["vertices"])
        return mean + self.arrays.origin if count else np.zeros(3)

    @returns_new
    def paint_uniform_color(self, color: ArrayLike) -> Self:
        """Set one color for all vertices.

        Args:
            color: Red, green and blue in 0..1 (Open3D clips other values).

        Raises:
            ValueError: If there are not three numbers in 0..1.

        Example:
            >>> import pointloom as loom
            >>> loom.TriangleMesh.create_plane().paint_uniform_color([1, 0.5, 0]).vertex_colors[0].tolist()
            [1.0, 0.5, 0.0]
        """
        rgb = check_color("color", color)
        colors = full(self.arrays["vertices"].size, vec3(*rgb.tolist()), vec3, self.device)
        return self.with_arrays(vertex_colors=colors)


def check_mesh(name: str, mesh: object) -> None:
    if not isinstance(mesh, MeshArrays):
        given = f"{type(mesh).__name__}{conversion_of(mesh, expected='mesh')}"
        raise TypeError(f"{name}: expected a TriangleMesh, got {given}")


def _numbered(parts: list[MeshArrays]) -> list[Any]:
    """Triangles of each mesh with vertex indices of the concatenation."""
    numbered, start = [], 0
    for mesh in parts:
        triangles = mesh.arrays["triangles"]
        numbered.append(shift_triangles(triangles, start) if start else triangles)
        start += mesh.arrays["vertices"].size
    return numbered


def _shared(parts: Sequence[Mapping[str, Any]], missing: list[str]) -> list[str]:
    """The names that all parts have. The others are appended to `missing`."""
    others = missing_names(parts)
    missing += others
    return [name for name in parts[0] if name not in others] if parts else []


def _joined_textures(parts: list[MeshArrays], missing: list[str]) -> tuple[dict[str, wp.array], Textures]:
    """Concatenated texture coordinates and material ids, and all textures. What some lack is appended to `missing`."""
    triangled = [mesh for mesh in parts if len(mesh)]
    names = ("triangle_uvs", "triangle_material_ids")
    if any("triangle_uvs" in mesh.arrays for mesh in triangled):
        kinds = [{"triangle_uvs": "triangle_uvs" in mesh.arrays, "textures": mesh.textures} for mesh in triangled]
        if others := missing_names([[name for name, has in kind.items() if has] for kind in kinds]):
            missing += others
            return {}, ()
    joined: dict[str, wp.array] = {}
    textures = tuple(image for mesh in triangled for image in mesh.textures)
    if triangled and "triangle_uvs" in triangled[0].arrays:
        joined[names[0]] = concatenate_rows([mesh.arrays[names[0]] for mesh in triangled])
    if (textures and len(triangled) > 1) or (triangled and all(names[1] in mesh.arrays for mesh in triangled)):
        ids, first = [], 0
        for mesh in triangled:
            mesh_ids = mesh.arrays.get(names[1])
            mesh_ids = zeros(len(mesh), int32, mesh.device) if mesh_ids is None else mesh_ids
            ids.append(raise_numbers(mesh_ids, first) if first else mesh_ids)
            first += len(mesh.textures)
        joined[names[1]] = concatenate_rows(ids)
    return joined, textures

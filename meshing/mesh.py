"""TriangleMesh: shared vertices and triangles on one device."""

from __future__ import annotations

from typing import Any

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ..kernels.algebra.transform import transform_points
from ..kernels.arrays.bounds import bound_points
from ..kernels.lang import vec3, vec3i
from ..kernels.memory import clone, download, move, upload
from ..kernels.meshes import mesh_edits, mesh_measures
from ..kernels.meshes.mesh_topology import Topology, examine
from ..pcd.checks import check_name, check_rows, check_shape, check_transformation
from ..pcd.coordinates import ORIGIN_LIMIT, split_origin
from ..pcd.devices import check_same_device, resolve_device
from ..pcd.dropped_results import returns_new
from ..pcd.io.table import MeshTable
from ..pcd.known_names import KnownNames
from ..pcd.pickled_arrays import device_like, pickled, unpickled
from ..pcd.point_arrays import read_only

_OPTIONAL = ("vertex_normals", "vertex_colors")


class TriangleMesh(KnownNames):
    """A triangle mesh: vertices, the triangles between them, and optionally a normal and a colour at each vertex.

    Everything is float32 (int32 for triangles) on one device. Vertices are stored relative to a float64 `origin`,
    so that they stay exact far from zero. Operations return a new mesh that shares the arrays which they leave as they
    are. `len(mesh)` is the number of triangles.

    Args:
        vertices: Positions [m], shape [m, 3].
        triangles: Vertex numbers, shape [t, 3]; counter-clockwise seen from outside.
        vertex_normals: Shape [m, 3], stored as given.
        vertex_colors: In 0..1, shape [m, 3].
        device: "cpu" (default), "cuda:N" or "auto".
        origin: The point [3] that positions are stored relative to; None takes zero, or the middle of the box where a
            coordinate passes 1e4 m.

    Raises:
        TypeError: Not numeric, or triangles that are not whole numbers.
        ValueError: Another shape, or a triangle that names a vertex which does not exist.
        DeviceError: No such device.

    Example:
        >>> mesh = TriangleMesh([[0, 0, 0], [2, 0, 0], [0, 1, 0]], [[0, 1, 2]])
        >>> mesh.get_surface_area()
        1.0
        >>> mesh.compute_vertex_normals().vertex_normals[0].tolist()
        [0.0, 0.0, 1.0]
    """

    def __init__(
        self,
        vertices: Any = (),
        triangles: Any = (),
        *,
        vertex_normals: Any = None,
        vertex_colors: Any = None,
        device: Any = None,
        origin: Any = None,
    ):
        positions = check_rows("vertices", vertices, 3)
        if len(positions) >= 2**31:
            raise ValueError(f"vertices: 32-bit triangles cannot reach {len(positions)} vertices")
        table = MeshTable(positions, triangles).checked()
        anchor = None if origin is None else check_shape("origin", origin, (3,))
        local, anchor = split_origin(table.vertices, anchor)
        self._device = resolve_device(device)
        self._origin = anchor
        self._arrays: dict[str, wp.array] = {
            "vertices": upload(local, vec3, self._device),
            "triangles": upload(table.triangles, vec3i, self._device),
        }
        for name, values in (("vertex_normals", vertex_normals), ("vertex_colors", vertex_colors)):
            if values is not None:
                self._assign(name, values)

    @classmethod
    def _from_arrays(
        cls,
        vertices: wp.array,
        triangles: wp.array,
        *,
        vertex_normals: wp.array | None = None,
        vertex_colors: wp.array | None = None,
        origin: Any = None,
    ) -> TriangleMesh:
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

    def _with(self, *, origin: NDArray[np.float64] | None = None, **arrays: wp.array | None) -> TriangleMesh:
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
        extras = "".join(f", {name}" for name in _OPTIONAL if name in self._arrays)
        return f"TriangleMesh({self._arrays['vertices'].size} vertices, {len(self)} triangles{extras}, {self._device})"

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

    def to(self, device: Any) -> TriangleMesh:
        """The mesh on another device; itself where it is there already."""
        target = resolve_device(device)
        if target == self._device:
            return self
        arrays: dict[str, Any] = {name: move(values, target) for name, values in self._arrays.items()}
        return self._with(**arrays)

    def copy(self) -> TriangleMesh:
        """Another mesh over the same arrays: what is assigned to one does not reach the other."""
        return self._with()

    def __copy__(self) -> TriangleMesh:
        return self.copy()

    def __deepcopy__(self, memo: dict[int, Any]) -> TriangleMesh:
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

    # -------------------------------------------------------------------------------------------- operations

    @returns_new
    def compute_vertex_normals(self) -> TriangleMesh:
        """Set the normal of each vertex to the mean of the triangles around it, weighted by their areas.

        Returns:
            The mesh with unit normals [m, 3]; (0, 0, 1) at vertices without area around them, as Open3D has it, and NaN
            at vertices that are not finite, whose triangles count nowhere.

        Notes:
            O(m + t) memory. Sums run in float64 by ascending triangle: the same bits from run to run.
        """
        vertices, triangles = self._arrays["vertices"], self._arrays["triangles"]
        return self._with(vertex_normals=mesh_measures.vertex_normals(vertices, triangles))

    def compute_triangle_normals(self) -> NDArray[np.float32]:
        """The unit normals of the triangles by the right-hand rule, shape [t, 3]; (0, 0, 1) for those without area.

        Open3D stores them in its mesh; here they are returned.
        """
        normals = mesh_measures.triangle_normals(self._arrays["vertices"], self._arrays["triangles"])
        return download(normals).reshape(-1, 3)

    def get_surface_area(self) -> float:
        """The area [m^2] of all triangles; those with a corner that is not finite count as none."""
        return mesh_measures.measure(self._arrays["vertices"], self._arrays["triangles"])[0]

    def get_volume(self) -> float:
        """The volume [m^3] that a closed mesh encloses.

        Raises:
            ValueError: The mesh is not watertight, or neighbouring triangles do not turn the same way.
        """
        topology = self._topology()
        if not _is_closed(topology):
            raise ValueError("get_volume: the mesh is not watertight, so it encloses no volume")
        if topology.has_twisted_edge:
            raise ValueError("get_volume: neighbouring triangles turn different ways; orient them alike")
        return abs(mesh_measures.measure(self._arrays["vertices"], self._arrays["triangles"])[1])

    def is_edge_manifold(self, allow_boundary_edges: bool = True) -> bool:
        """Whether no edge belongs to more than two triangles.

        Args:
            allow_boundary_edges: Whether edges of one triangle only are allowed.
        """
        topology = self._topology()
        return not topology.has_crowded_edge and (allow_boundary_edges or not topology.has_boundary)

    def is_watertight(self) -> bool:
        """Whether each edge belongs to exactly two triangles, and the triangles at each vertex are one fan.

        Unlike Open3D's, the test says nothing of triangles that cut through each other.
        """
        return _is_closed(self._topology())

    def _topology(self) -> Topology:
        return examine(self._arrays["triangles"], self._arrays["vertices"].size)

    def get_axis_aligned_bounding_box(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """The lowest and highest coordinates [m] of the finite vertices, float64 [3] each; zeros if none are."""
        low, high, count = bound_points(self._arrays["vertices"])
        if not count:
            return np.zeros(3), np.zeros(3)
        return low.astype(np.float64) + self._origin, high.astype(np.float64) + self._origin

    @returns_new
    def transform(self, transformation: Any) -> TriangleMesh:
        """Move the mesh by an affine transformation.

        Args:
            transformation: A finite 4x4 matrix with last row (0, 0, 0, 1) and an inverse.

        Returns:
            The moved mesh. Normals turn with the surface (by the inverse transpose, at unit length; Open3D turns them
            as if they were directions), and a reflection reverses the triangles, so that their outside stays outside.

        Raises:
            ValueError: Another matrix.
        """
        T = check_transformation("transformation", transformation)
        A, determinant = T[:3, :3], float(np.linalg.det(T[:3, :3]))
        if determinant == 0:
            raise ValueError("transformation: expected a matrix with an inverse, got one that flattens space")
        target = A @ self._origin + T[:3, 3]
        origin = np.round(target) if np.abs(target).max() > ORIGIN_LIMIT else np.zeros(3)
        arrays: dict[str, Any] = {"vertices": transform_points(self._arrays["vertices"], A, target - origin)}
        if "vertex_normals" in self._arrays:
            arrays["vertex_normals"] = mesh_edits.turn_normals(self._arrays["vertex_normals"], np.linalg.inv(A).T)
        if determinant < 0:
            arrays["triangles"] = mesh_edits.flip_triangles(self._arrays["triangles"])
        return self._with(origin=origin, **arrays)

    @returns_new
    def remove_unreferenced_vertices(self) -> TriangleMesh:
        """Drop the vertices that no triangle uses; the others keep their order."""
        names = [name for name in self._arrays if name != "triangles"]
        vertex_count = self._arrays["vertices"].size
        rows = [self._arrays[name] for name in names]
        triangles, kept = mesh_edits.drop_unreferenced(self._arrays["triangles"], vertex_count, rows)
        return self._with(triangles=triangles, **dict(zip(names, kept, strict=True)))


def _is_closed(topology: Topology) -> bool:
    return not (topology.has_boundary or topology.has_crowded_edge or topology.has_split_vertex)


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

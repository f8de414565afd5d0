"""Solids joined, cut and intersected, by the library manifold on the host."""

from __future__ import annotations

from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from ...core.dropped_results import returns_new
from ...core.units import common_unit
from .finite_corners import REMEDY, find_wrong_corner
from .flat_polygons import LIBRARY, load_manifold
from .mesh_arrays import MeshArrays
from .mesh_measures import MeshMeasures


class MeshBooleans(MeshMeasures):
    """The part of TriangleMesh that takes it for a solid."""

    @returns_new
    def boolean_union(self, mesh: Self) -> Self:
        """The solid that two closed meshes fill together.

        Computed on the host, whatever the device: by the package manifold3d, which `pip install "pointloom[mesh]"`
        brings. Open3D goes through VTK and takes a tolerance; here there is none to choose.

        Args:
            mesh: A closed mesh on any device, whose triangles look outwards, as must those of this one.

        Returns:
            The surface of the solid, on the device of this mesh, relative to its origin. Colours of vertices go along
            where both meshes have them, on the cut between those of its triangle's corners; normals are made anew where
            both have them; texture is left behind. An empty mesh where nothing is left.

        Raises:
            ValueError: A mesh that is not closed, or whose triangles turn different ways or inwards.
            TypeError: No mesh.
            ImportError: manifold3d is not installed.

        Notes:
            The cut is made in float64 and rounded once to float32. The same bits from run to run are manifold's promise
            and not ours.

        Example:
            >>> import pointloom as loom
            >>> import numpy as np
            >>> corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
            >>> sides = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
            >>> solid, other = loom.TriangleMesh(corners, sides), loom.TriangleMesh(corners + [0.2, 0, 0], sides)
            >>> both = solid.boolean_union(other)
            >>> both.is_watertight(), 1 / 6 < both.get_volume() < 1 / 3
            (True, True)
        """
        return self._combine(mesh, "boolean_union", lambda a, b: a + b)

    @returns_new
    def boolean_difference(self, mesh: Self) -> Self:
        """The solid that this closed mesh fills and another does not; all else as `boolean_union`.

        Args:
            mesh: What is taken away.

        Raises:
            ValueError: A mesh that is not closed, or whose triangles turn different ways or inwards.
            TypeError: No mesh.
            ImportError: manifold3d is not installed.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> corners = np.array([[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2]])
            >>> sides = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
            >>> solid, corner = loom.TriangleMesh(corners, sides), loom.TriangleMesh(corners / 2 - 0.1, sides)
            >>> solid.boolean_difference(corner).get_volume() < solid.get_volume()
            True
        """
        return self._combine(mesh, "boolean_difference", lambda a, b: a - b)

    @returns_new
    def boolean_intersection(self, mesh: Self) -> Self:
        """The solid that two closed meshes both fill; all else as `boolean_union`.

        Args:
            mesh: The other one.

        Raises:
            ValueError: A mesh that is not closed, or whose triangles turn different ways or inwards.
            TypeError: No mesh.
            ImportError: manifold3d is not installed.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> corners = np.array([[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2]])
            >>> sides = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
            >>> solid, other = loom.TriangleMesh(corners, sides), loom.TriangleMesh(corners + 5, sides)
            >>> len(solid.boolean_intersection(other))
            0
        """
        return self._combine(mesh, "boolean_intersection", lambda a, b: a ^ b)

    def _combine(self, other: Self, name: str, operation: Any) -> Self:
        if not isinstance(other, MeshArrays):
            raise TypeError(f"mesh: expected a TriangleMesh, got {type(other).__name__}")
        library = load_manifold(name)
        with_colors = "vertex_colors" in self._arrays and "vertex_colors" in other._device_arrays
        solids = [
            _solid(library, mesh, self._origin, with_colors, f"{name}: {what}")
            for what, mesh in (("the mesh", self), ("mesh: it", other))
        ]
        result = operation(*solids)
        _check_status(result, name)
        vertices, triangles, colors = _arrays_of(result)
        make: Any = type(self)  # TriangleMesh
        mesh = make(
            vertices + self._origin,
            triangles,
            vertex_colors=np.clip(colors, 0, 1) if with_colors else None,
            device=self._device,
            origin=self._origin,
        )
        mesh.unit = common_unit(f"{name}: the meshes", (self.unit, other.unit))
        both_have_normals = "vertex_normals" in self._arrays and "vertex_normals" in other._device_arrays
        return mesh.compute_vertex_normals() if both_have_normals else mesh


def _solid(library: Any, mesh: Any, origin: NDArray[np.float64], with_colors: bool, what: str) -> Any:
    """A mesh as manifold holds it, relative to an origin; refused where it is no solid."""
    if len(mesh):
        if (wrong := find_wrong_corner(mesh)) is not None:
            raise ValueError(f"{what} has corners that are not finite: {wrong}; {REMEDY}")
        topology = mesh.edge_topology()
        if topology.has_boundary or topology.has_crowded_edge:
            raise ValueError(f"{what} is not closed, so it is no solid; repair(hole_size=...) closes holes")
        if topology.has_twisted_edge:
            raise ValueError(f"{what} has neighbouring triangles that turn different ways; see orient_triangles")
        if mesh._signed_volume() < 0:
            raise ValueError(f"{what} looks inwards; orient_triangles(outward=True) turns it")
    columns = [mesh.vertices - origin]
    if with_colors:
        columns.append(mesh.vertex_colors)
    properties = np.ascontiguousarray(np.column_stack(columns), np.float64)
    solid = library.Manifold(library.Mesh64(properties, np.ascontiguousarray(mesh.triangles, np.uint64)))
    _check_status(solid, what)
    return solid


def _check_status(solid: Any, what: str) -> None:
    status = solid.status()
    if status.name != "NoError":
        raise ValueError(f"{what} is no solid to {LIBRARY}: {status.name}")


def _arrays_of(solid: Any) -> tuple[NDArray[np.float64], NDArray[np.int64], NDArray[np.float64]]:
    """(positions [m, 3], triangles [t, 3], further columns): vertices that differ in the latter alone become one."""
    mesh = solid.to_mesh64()
    properties = np.asarray(mesh.vert_properties)
    target = np.arange(len(properties))
    target[np.asarray(mesh.merge_from_vert, np.int64)] = np.asarray(mesh.merge_to_vert, np.int64)
    kept, triangles = np.unique(target[np.asarray(mesh.tri_verts, np.int64)], return_inverse=True)
    return properties[kept, :3], triangles.reshape(-1, 3), properties[kept, 3:]

"""The meshes that Open3D makes: shapes, and surfaces of clouds, by our functions of the same names."""

from __future__ import annotations

from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike

from ...meshing.mesh import mesh
from ..held import column, ours
from ..vectors import DoubleVector
from .mesh_base import MeshBase
from .point_cloud import PointCloud

Ours = mesh.TriangleMesh


class MeshFactories(MeshBase):
    """What makes meshes."""

    @classmethod
    def create_box(
        cls,
        width: float = 1.0,
        height: float = 1.0,
        depth: float = 1.0,
        create_uv_map: bool = False,
        map_texture_to_each_face: bool = False,
    ) -> Self:
        """A box from (0, 0, 0)."""
        return cls._of(Ours.create_box(width, height, depth, create_uv_map, map_texture_to_each_face))

    @classmethod
    def create_tetrahedron(cls, radius: float = 1.0, create_uv_map: bool = False) -> Self:
        """A tetrahedron about (0, 0, 0)."""
        return cls._of(Ours.create_tetrahedron(radius, create_uv_map))

    @classmethod
    def create_octahedron(cls, radius: float = 1.0, create_uv_map: bool = False) -> Self:
        """An octahedron about (0, 0, 0)."""
        return cls._of(Ours.create_octahedron(radius, create_uv_map))

    @classmethod
    def create_icosahedron(cls, radius: float = 1.0, create_uv_map: bool = False) -> Self:
        """An icosahedron about (0, 0, 0)."""
        return cls._of(Ours.create_icosahedron(radius, create_uv_map))

    @classmethod
    def create_sphere(cls, radius: float = 1.0, resolution: int = 20, create_uv_map: bool = False) -> Self:
        """A sphere about (0, 0, 0)."""
        return cls._of(Ours.create_sphere(radius, resolution, create_uv_map))

    @classmethod
    def create_ellipsoid(
        cls,
        radius_x: float = 1.0,
        radius_y: float = 1.0,
        radius_z: float = 1.0,
        resolution: int = 20,
        create_uv_map: bool = False,
    ) -> Self:
        """An ellipsoid about (0, 0, 0)."""
        return cls._of(Ours.create_ellipsoid(radius_x, radius_y, radius_z, resolution, create_uv_map))

    @classmethod
    def create_cylinder(
        cls, radius: float = 1.0, height: float = 2.0, resolution: int = 20, split: int = 4, create_uv_map: bool = False
    ) -> Self:
        """A cylinder about the z axis."""
        return cls._of(Ours.create_cylinder(radius, height, resolution, split, create_uv_map))

    @classmethod
    def create_cone(
        cls, radius: float = 1.0, height: float = 2.0, resolution: int = 20, split: int = 1, create_uv_map: bool = False
    ) -> Self:
        """A cone on the xy plane."""
        return cls._of(Ours.create_cone(radius, height, resolution, split, create_uv_map))

    @classmethod
    def create_torus(
        cls,
        torus_radius: float = 1.0,
        tube_radius: float = 0.5,
        radial_resolution: int = 30,
        tubular_resolution: int = 20,
    ) -> Self:
        """A torus about the z axis."""
        return cls._of(Ours.create_torus(torus_radius, tube_radius, radial_resolution, tubular_resolution))

    @classmethod
    def create_arrow(
        cls,
        cylinder_radius: float = 1.0,
        cone_radius: float = 1.5,
        cylinder_height: float = 5.0,
        cone_height: float = 4.0,
        resolution: int = 20,
        cylinder_split: int = 4,
        cone_split: int = 1,
    ) -> Self:
        """An arrow along the z axis."""
        sizes = cylinder_radius, cone_radius, cylinder_height, cone_height
        return cls._of(Ours.create_arrow(*sizes, resolution, cylinder_split, cone_split))

    @classmethod
    def create_coordinate_frame(cls, size: float = 1.0, origin: ArrayLike = (0.0, 0.0, 0.0)) -> Self:
        """Arrows along x (red), y (green) and z (blue)."""
        return cls._of(Ours.create_coordinate_frame(size, column("origin", origin)))

    @classmethod
    def create_mobius(
        cls,
        length_split: int = 70,
        width_split: int = 15,
        twists: int = 1,
        radius: float = 1,
        flatness: float = 1,
        width: float = 1,
        scale: float = 1,
    ) -> Self:
        """A Moebius strip."""
        return cls._of(Ours.create_mobius(length_split, width_split, twists, radius, flatness, width, scale))

    @classmethod
    def create_from_oriented_bounding_box(
        cls, obox: Any, scale: ArrayLike = (1.0, 1.0, 1.0), create_uv_map: bool = False
    ) -> Self:
        """A box around the box, its sides scaled."""
        box = ours(obox)
        extent = box.extent * np.asarray(scale, np.float64)
        width, height, depth = extent.tolist()
        made = Ours.create_box(width, height, depth, create_uv_map).translate(-extent / 2)
        return cls._of(made.rotate(box.R, [0, 0, 0]).translate(box.center))

    # -------------------------------------------------------------------------------------------- surfaces of clouds

    @classmethod
    def create_from_point_cloud_alpha_shape(
        cls, pcd: Any, alpha: float, tetra_mesh: Any = None, pt_map: Any = None
    ) -> Self:
        """The alpha shape of a cloud; the tetrahedra are made anew, also where Open3D takes them."""
        return cls._of(Ours.create_from_point_cloud_alpha_shape(ours(pcd, PointCloud, "pcd"), alpha))

    @classmethod
    def create_from_point_cloud_ball_pivoting(cls, pcd: Any, radii: Any) -> Self:
        """The surface of balls that roll over a cloud with normals."""
        return cls._of(Ours.create_from_point_cloud_ball_pivoting(ours(pcd, PointCloud, "pcd"), np.asarray(radii)))

    @classmethod
    def create_from_point_cloud_poisson(
        cls,
        pcd: Any,
        depth: int = 8,
        width: float = 0,
        scale: float = 1.1,
        linear_fit: bool = False,
        n_threads: int = -1,
        full_depth: int = 5,
        samples_per_node: float = 1.5,
        point_weight: float = 2.0,
    ) -> tuple[Self, DoubleVector]:
        """The closed surface that follows normals, and a density a vertex.

        A width above 0 takes the place of the depth, which may be 0 then. Threads and full_depth have no effect.
        """
        made, densities = Ours.create_from_point_cloud_poisson(
            ours(pcd, PointCloud, "pcd"),
            8 if width > 0 else depth,
            width,
            scale,
            linear_fit,
            point_weight=point_weight,
            samples_per_node=samples_per_node,
        )
        return cls._of(made), DoubleVector(densities)

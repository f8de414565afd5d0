"""Mass properties of closed meshes of uniform density."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ...kernels.meshes.mass_integrals import integrate_volume
from .mesh_measures import MeshMeasures


class MeshMass(MeshMeasures):
    """Methods of TriangleMesh that integrate over its volume."""

    @property
    def center_of_mass(self) -> NDArray[np.float64]:
        """Center of mass of a closed mesh of uniform density [m], shape (3,), float64.

        Volumes of inward-facing parts, such as cavities, are subtracted, as in `get_volume`. trimesh: `center_mass`.

        Raises:
            ValueError: If a corner is not finite, the mesh is not watertight, its orientation is inconsistent, or it
                encloses no volume.

        Example:
            >>> import pointloom as loom
            >>> loom.TriangleMesh.create_box(4, 2, 1).center_of_mass.tolist()
            [2.0, 1.0, 0.5]
        """
        return self._mass("center_of_mass")[1] + self.arrays.origin

    @property
    def moment_of_inertia(self) -> NDArray[np.float64]:
        """Inertia tensor of a closed mesh of density 1 about its center of mass, shape (3, 3), float64 [m^5].

        Multiply by the density [kg/m^3] for kg m^2. The axes are those of the coordinates. `numpy.linalg.eigh` returns
        the principal moments and axes. trimesh: `moment_inertia`.

        Raises:
            ValueError: As `center_of_mass`.

        Example:
            >>> import pointloom as loom
            >>> inertia = loom.TriangleMesh.create_box(4, 2, 1).moment_of_inertia  # 8 m^3 of density 1
            >>> inertia.diagonal().tolist() == [8 / 12 * (2**2 + 1), 8 / 12 * (4**2 + 1), 8 / 12 * (4**2 + 2**2)]
            True
        """
        second = self._mass("moment_of_inertia")[2]
        return np.eye(3) * np.trace(second) - second

    def _mass(self, name: str) -> tuple[float, NDArray[np.float64], NDArray[np.float64]]:
        """Volume, center relative to the origin, and second moments; positive for an inward-facing mesh, too."""
        self.check_solid(name)
        if not len(self):
            raise ValueError(f"{name}: expected triangles that enclose a volume, got none")
        volume, center, second = integrate_volume(self.arrays["vertices"], self.arrays["triangles"])
        if volume == 0 or not np.isfinite(center).all():
            raise ValueError(
                f"{name}: expected a mesh that encloses a volume, got {volume:g}. "
                "Orient separate parts outward with orient_triangles(outward=True)"
            )
        return abs(volume), center, second if volume > 0 else -second

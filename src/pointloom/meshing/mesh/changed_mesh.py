"""Base of results that change a mesh: `ChangedMesh`."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from ...core.reports import Assessed, Fields, Report
from .mesh import TriangleMesh
from .mesh_checks import find_wrong_corner
from .metrics import UnreachedError, fractions_beyond


@dataclass(frozen=True, kw_only=True, eq=False)
class ChangedMesh(Report, Assessed):
    """A mesh made from another one.

    Attributes:
        mesh: The result.
        vertices_in, triangles_in: Counts of the input.
        reliable, warnings: True if all quality checks passed, and those that failed.
    """

    mesh: TriangleMesh
    vertices_in: int
    triangles_in: int

    def sizes_to_dict(self) -> dict[str, Any]:
        """Numbers of vertices, triangles and parts before and after."""
        before = {"device": str(self.mesh.device), "vertices_in": self.vertices_in, "triangles_in": self.triangles_in}
        return before | {"vertices": self.mesh.arrays["vertices"].size, "triangles": len(self.mesh)}

    def size_fields(self) -> Fields:
        """Numbers of vertices, triangles and parts before and after, as text."""
        return [
            ("vertices", f"{self.mesh.arrays['vertices'].size:,} of {self.vertices_in:,}"),
            ("triangles", f"{len(self.mesh):,} of {self.triangles_in:,}"),
        ]


# A surface has another shape if more than a twentieth of it is off by more than 2 % of its size, the rule of
# docs/trust.md. Neither was fitted.
SHAPE_TOLERANCE = 0.02  # of the box's diagonal
MAX_CHANGED = 0.05  # of the area
SHAPE_SAMPLES = 20_000  # points of each surface: a fraction of 0.05 has a standard deviation of 0.0015


def can_be_compared(before: TriangleMesh, after: TriangleMesh) -> bool:
    """False if either mesh has no area or a corner that is not finite."""
    if find_wrong_corner(before) or find_wrong_corner(after):
        return False
    return before.get_surface_area() > 0 and after.get_surface_area() > 0


def fractions_changed(before: TriangleMesh, after: TriangleMesh) -> tuple[float, float] | None:
    """Fractions of each surface farther than SHAPE_TOLERANCE from the other one.

    None if either has no area or a corner that is not finite, or if they are 1.8e19 m apart.
    """
    if not can_be_compared(before, after):
        return None
    diagonal = math.dist(*before.get_axis_aligned_bounding_box())
    try:
        return fractions_beyond(before, after, SHAPE_TOLERANCE * diagonal, SHAPE_SAMPLES)
    except UnreachedError:
        return None


def sizes_before(mesh: TriangleMesh) -> dict[str, Any]:
    return {"vertices_in": mesh.arrays["vertices"].size, "triangles_in": len(mesh)}

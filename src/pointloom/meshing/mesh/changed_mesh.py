"""Base of results that change a mesh: `ChangedMesh`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from ...core.reports import Assessed, Fields, Report
from .mesh import TriangleMesh


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


def sizes_before(mesh: TriangleMesh) -> dict[str, Any]:
    return {"vertices_in": mesh.arrays["vertices"].size, "triangles_in": len(mesh)}

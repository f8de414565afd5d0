"""What the results have in common that change a mesh: `ChangedMesh`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from ...core.reports import Assessed, Fields, Report
from .mesh import TriangleMesh


@dataclass(frozen=True, kw_only=True, eq=False)
class ChangedMesh(Report, Assessed):
    """A mesh that was made of another one, and what there is to say of it; `print` tells it.

    Attributes:
        mesh: The new one.
        vertices_in, triangles_in: How many the other one had.
        reliable, warnings: Whether all quality checks passed, and those that failed.
    """

    mesh: TriangleMesh
    vertices_in: int
    triangles_in: int

    def sizes_to_dict(self) -> dict[str, Any]:
        """Where it was computed, and the counts before and after, in JSON's types."""
        before = {"device": str(self.mesh.device), "vertices_in": self.vertices_in, "triangles_in": self.triangles_in}
        return before | {"vertices": self.mesh.array("vertices").size, "triangles": len(self.mesh)}

    def size_fields(self) -> Fields:
        """The counts as labels and values."""
        return [
            ("vertices", f"{self.mesh.array('vertices').size:,} of {self.vertices_in:,}"),
            ("triangles", f"{len(self.mesh):,} of {self.triangles_in:,}"),
        ]


def sizes_before(mesh: TriangleMesh) -> dict[str, Any]:
    """The counts of the mesh that another one is made of, as ChangedMesh names them."""
    return {"vertices_in": mesh.array("vertices").size, "triangles_in": len(mesh)}

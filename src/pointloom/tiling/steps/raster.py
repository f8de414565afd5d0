"""Rasters of tiles as a step."""

from __future__ import annotations

from typing import Any, ClassVar

from ...core.checks import check_count, check_finite, check_positive, check_shape, shown
from ...pcd.raster_cells import DEFAULT_RADIUS, check_classes
from ...pcd.terrain import KINDS
from ..exact_sums import ExactSums
from ..plan_check import TilePlan
from .step import Part, Step


class Rasterize(Step):
    """Write a raster of the tile's cells, merged by `finish_tiles`. Points pass unchanged."""

    name, required, searches, writes = "rasterize", ("cell",), False, True
    defaults: ClassVar[dict[str, Any]] = {
        "kind": "dtm", "method": "idw", "reach": None, "neighbors": 8, "classes": None, "corner": (0.0, 0.0),
        "fill": None, "crs": None, "name": None,
    }  # fmt: skip

    def check(self) -> None:
        params = self.params
        self.cell, self.kind = check_positive("cell", params["cell"]), params["kind"]
        if self.kind not in KINDS:
            raise ValueError(f"steps: kind: expected {' or '.join(map(repr, KINDS))}, got {shown(self.kind)}")
        if params["method"] != "idw":
            reason = "a triangle depends on points at any distance. Use 'idw', or rasterize in memory"
            raise ValueError(f"steps: method: expected 'idw', got {shown(params['method'])}: {reason}")
        if params["reach"] is None:
            params["reach"] = DEFAULT_RADIUS * self.cell
        around = check_positive("reach", params["reach"]) if self.kind in ("dtm", "chm") else 0.0
        check_count("neighbors", params["neighbors"])
        params["classes"] = None if params["classes"] is None else [*(check_classes(params["classes"]) or ())]
        params["corner"] = check_finite("corner", check_shape("corner", params["corner"], (2,))).tolist()
        self.fill = None if params["fill"] is None else check_positive("fill", params["fill"])
        if params["name"] is None:
            params["name"] = self.kind
        name = params["name"]
        if not isinstance(name, str) or not name.replace("_", "").replace("-", "").isalnum():
            raise ValueError(f"steps: name: expected letters and digits, got {shown(name)}")
        self.raster = name
        self.margin = 0.0 if self.fill is None else self.fill + self.cell
        self.radius = max(around, self.cell / 2) + self.margin

    def run(self, part: Part, plan: TilePlan, numbers: ExactSums | None) -> Part:
        return part

"""Reprojection to another coordinate system, as the last step."""

from __future__ import annotations

import dataclasses
import math
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from ...core.checks import shown
from ...core.errors import FileError
from ...io.optional_imports import import_for
from ...io.points.geodetic import system_named, system_of
from ...io.points.las import open_las
from ..exact_sums import ExactSums
from ..plan_check import TilePlan
from .step import Part, Step

MAX_UNIT_DIFFERENCE = 1e-9  # of a unit's length


class Reproject(Step):
    """Reproject points by pyproj on the CPU. Heights stay unless both systems have a vertical part. Must be the last
    step: tiles and halos are in the source's units."""

    name, required, searches = "reproject", ("to_crs",), False
    defaults: ClassVar[dict[str, Any]] = {"from_crs": None, "scales": None, "offsets": None, "wkt": None}

    def check(self) -> None:
        for name in ("to_crs", "from_crs"):
            value = self.params[name]
            if not (isinstance(value, str) and value) and not (name == "from_crs" and value is None):
                raise ValueError(
                    f"steps: reproject: {name}: expected a system such as 'EPSG:25832', got {shown(value)}"
                )
        self._way: Any = None

    def adapt(self, sources: list[dict[str, Any]]) -> None:
        """Find the source's system and the target's coordinate scale."""
        path = Path(sources[0]["path"])
        pyproj: Any = import_for(path, "pyproj", "geo")
        target = system_named("steps: reproject: to_crs", self.params["to_crs"])
        if self.params["from_crs"] is None:
            source = system_of(path, open_las(path).header)
            if source is None:
                remedy = "Pass it as from_crs='EPSG:25832' of the step, or as --from-crs"
                raise FileError(path, "has no coordinate system to reproject from", remedy=remedy)
        else:
            source = system_named("steps: reproject: from_crs", self.params["from_crs"])
        for name, system in (("to_crs", target), ("from_crs", source)):
            if not _plane_of(system).is_projected:
                reason = f"{system.name} is not in units of length, which tiles and search trees need"
                raise ValueError(f"steps: reproject: {name}: {reason}. Use a projected system")
        filled = [one for one in sources if one["points"]]
        if not filled:
            return  # reported elsewhere
        units = [one.axis_info[0].unit_conversion_factor for one in (source, target)]
        if source.is_compound and not target.is_compound:  # heights and their datum stay
            heights = source.sub_crs_list[1]
            output = pyproj.crs.CompoundCRS(f"{target.name} + {heights.name}", [target, heights])
        else:
            output = target
        if not (source.is_compound and target.is_compound) and abs(units[0] / units[1] - 1) > MAX_UNIT_DIFFERENCE:
            names = [one.axis_info[0].unit_name for one in (source, target)]
            reason = f"x and y would be in {names[1]}, and heights stay in {names[0]}"
            raise ValueError(f"steps: reproject: {reason}. Use systems with heights, such as 'EPSG:2994+6360'")
        step = 10.0 ** math.floor(math.log10(sources[0]["scales"][0] * units[0] / units[1]) + 1e-9)
        self.params |= {
            "from_crs": source.to_wkt(),
            "wkt": output.to_wkt("WKT1_GDAL"),
            "scales": [step, step, sources[0]["scales"][2]],
        }
        middle = (np.min([s["low"] for s in filled], axis=0) + np.max([s["high"] for s in filled], axis=0)) / 2
        self.params["offsets"] = np.round(self._moved(middle[None])[0]).tolist()

    def run(self, part: Part, plan: TilePlan, numbers: ExactSums | None) -> Part:
        """Apply the step. Points keep their homes in the source's coordinates."""
        exact = part.cloud.points if part.exact is None else part.exact
        return dataclasses.replace(part, exact=self._moved(np.asarray(exact, np.float64)))

    def _moved(self, points: NDArray[np.float64]) -> NDArray[np.float64]:
        """Points in the target's coordinates. ValueError if some cannot be converted."""
        if self._way is None:
            pyproj: Any = import_for("steps", "pyproj", "geo")
            systems = [pyproj.CRS.from_user_input(self.params[name]) for name in ("from_crs", "to_crs")]
            self._has_heights = all(system.is_compound for system in systems)
            if not self._has_heights:
                systems = [_plane_of(system) for system in systems]
            self._way = pyproj.Transformer.from_crs(*systems, always_xy=True)
        x, y, z = points.T
        if self._has_heights:
            moved = np.column_stack(self._way.transform(x, y, z))
        else:
            moved = np.column_stack([*self._way.transform(x, y), z])
        lost = int((~np.isfinite(moved).all(axis=1)).sum())
        if lost:
            reason = f"{lost:,} of {len(points):,} points have no position in {self.params['to_crs']}"
            raise ValueError(f"steps: reproject: {reason}. Crop to the area of that system first")
        return moved


def _plane_of(system: Any) -> Any:
    """Horizontal part of a coordinate system."""
    return system.sub_crs_list[0] if system.is_compound else system

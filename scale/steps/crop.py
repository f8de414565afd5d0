"""Points in a box or in polygons."""

from __future__ import annotations

from typing import Any, ClassVar

from ...core.checks import check_finite, check_shape
from ...kernels.memory import download
from ...pcd.boxes import AxisAlignedBoundingBox
from ..exact_sums import ExactSums
from ..polygons import in_survey, mask_area, parse_area, to_json
from .step import Part, Step


class Crop(Step):
    """Points in a box or in polygons stay, a box's faces included; or with `invert` all others."""

    name = "crop"
    defaults: ClassVar[dict[str, Any]] = {
        "min_bound": None, "max_bound": None, "polygon": None, "polygon_crs": None, "invert": False,
    }  # fmt: skip

    def check(self) -> None:
        """Set the box or the polygons by the parameters."""
        ends = ("min_bound", "max_bound")
        given = [name for name in (*ends, "polygon") if self.params[name] is not None]
        if given not in ([*ends], ["polygon"]):
            raise ValueError(f"steps: crop needs min_bound and max_bound, or polygon, got {', '.join(given) or 'none'}")
        if "polygon" not in given and self.params["polygon_crs"] is not None:
            raise ValueError("steps: crop: polygon_crs goes with polygon")
        if given == ["polygon"]:
            self.area = parse_area("steps: crop: polygon", self.params["polygon"])
            self.params["polygon"] = to_json(self.area)
            return
        for name in ends:
            self.params[name] = check_finite(name, check_shape(name, self.params[name], (3,))).tolist()
        self.box = AxisAlignedBoundingBox(self.params["min_bound"], self.params["max_bound"])

    def settle(self, sources: list[dict[str, Any]]) -> None:
        """Bring polygons to the survey's coordinates."""
        if self.params["polygon"] is not None:
            self.area = in_survey("steps: crop: polygon", self.area, self.params["polygon_crs"], sources)
            self.params |= {"polygon": to_json(self.area), "polygon_crs": None}

    def run(self, part: Part, plan: Any, numbers: ExactSums | None) -> Part:
        """The step on a part."""
        points, origin = part.cloud._device_array("points"), part.cloud.origin
        if self.params["polygon"] is None:
            keep = download(self.box.mask_points(points, origin)) != 0
        else:
            keep = mask_area(self.area, points, origin)
        return part.select(keep != self.params["invert"])

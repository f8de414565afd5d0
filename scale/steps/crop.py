"""Points in a box."""

from __future__ import annotations

from typing import Any, ClassVar

from ...core.checks import check_finite, check_shape
from ...kernels.memory import download
from ...pcd.boxes import AxisAlignedBoundingBox
from ..exact_sums import ExactSums
from .step import Part, Step


class Crop(Step):
    """Points in a box stay, its faces included; or with `invert` all others."""

    name, required = "crop", ("min_bound", "max_bound")
    defaults: ClassVar[dict[str, Any]] = {"invert": False}

    def check(self) -> None:
        """Set reach and neighbours by the parameters."""
        for name in self.required:
            self.params[name] = check_finite(name, check_shape(name, self.params[name], (3,))).tolist()
        self.box = AxisAlignedBoundingBox(self.params["min_bound"], self.params["max_bound"])

    def run(self, part: Part, plan: Any, numbers: ExactSums | None) -> Part:
        """The step on a part."""
        mask = self.box.mask_points(part.cloud.device_array("points"), part.cloud.origin)
        return part.select((download(mask) != 0) != self.params["invert"])

"""Points moved onto the planes of their neighbours."""

from __future__ import annotations

import dataclasses
from typing import Any, ClassVar

from ...core.checks import check_positive, check_search
from ..exact_sums import ExactSums
from .step import Part, Step


class SmoothMls(Step):
    """Each point moves onto the plane through its neighbours within a radius; it stays at home in its tile."""

    name, required = "smooth_mls", ("radius",)
    defaults: ClassVar[dict[str, Any]] = {"max_nn": 30}

    def check(self) -> None:
        """Set reach and neighbours by the parameters."""
        self.reach = check_positive("radius", self.params["radius"])
        check_search(self.reach, self.params["max_nn"])

    def spread_after(self, spread: float) -> float:
        """A plane through neighbours is no farther away than they are."""
        return spread + self.reach

    def run(self, part: Part, plan: Any, numbers: ExactSums | None) -> Part:
        """The step on a part."""
        cloud = part.cloud.smooth_mls(radius=self.reach, max_nn=self.params["max_nn"])
        return dataclasses.replace(part, cloud=cloud, exact=None, spread=self.spread_after(part.spread))

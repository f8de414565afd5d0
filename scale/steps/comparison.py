"""What has changed to another epoch of the survey."""

from __future__ import annotations

import dataclasses
import math
from pathlib import Path
from typing import Any, ClassVar

import numpy as np

from ...core.checks import check_direction, check_positive, shown
from ...pcd.change import check_radii, m3c2
from ..exact_sums import ExactSums
from .step import Part, Step
from .thinning import thinned


class Compared(Step):
    """A step that compares with another epoch, the files of its parameter `other`."""

    def check(self) -> None:
        """Set the epoch by the parameters."""
        other = self.params["other"]
        listed = [other] if isinstance(other, str | Path) else other
        if not isinstance(listed, list | tuple) or not listed or not all(isinstance(p, str | Path) for p in listed):
            raise ValueError(f"steps: other: expected paths of the other epoch's files or folders, got {shown(other)}")
        self.params["other"] = self.epoch = [str(Path(path).absolute()) for path in listed]


class Distance(Compared):
    """The distance of each point to the nearest of another epoch, as the attribute `distance`; NaN beyond a limit."""

    name, required, searches = "distance", ("other", "max_distance"), False

    def check(self) -> None:
        """Set the reach and the epoch by the parameters."""
        super().check()
        self.reach = check_positive("max_distance", self.params["max_distance"])

    def run(self, part: Part, plan: Any, numbers: ExactSums | None) -> Part:
        """The step on a part."""
        assert part.other is not None
        cloud = part.cloud.copy()
        distances = np.asarray(part.cloud.compute_point_cloud_distance(part.other))
        cloud[self.name] = np.where(distances <= self.reach, distances, np.nan).astype(np.float32)
        return dataclasses.replace(part, cloud=cloud)


class Change(Compared):
    """M3C2 to another epoch: distance, level of detection, whether that is a change, and points of both epochs.

    With `core_spacing` it is measured at the points alone that `thin` would leave, and the others go; normals and means
    are of all points.
    """

    name, required = "m3c2", ("other", "cylinder_radius", "max_distance")
    defaults: ClassVar[dict[str, Any]] = {
        "normal_radii": None, "registration_error": 0.0, "orientation": (0.0, 0.0, 1.0), "direction": None,
        "core_spacing": None, "corner": (0.0, 0.0, 0.0),
    }  # fmt: skip

    def check(self) -> None:
        """Set reach and epoch by the parameters."""
        super().check()
        params = self.params
        radius, length = (check_positive(name, params[name]) for name in ("cylinder_radius", "max_distance"))
        check_positive("registration_error", params["registration_error"], allow_zero=True)
        params["orientation"] = check_direction("orientation", params["orientation"]).tolist()
        if params["direction"] is not None:
            params["direction"] = check_direction("direction", params["direction"]).tolist()
        radii = check_radii(params["normal_radii"], params["direction"])
        params["normal_radii"] = radii.tolist() or None
        self.reach = max([math.hypot(radius, length), *radii.tolist()])
        if params["core_spacing"] is not None:
            self.reach = max(self.reach, check_positive("core_spacing", params["core_spacing"]))

    def run(self, part: Part, plan: Any, numbers: ExactSums | None) -> Part:
        """The step on a part."""
        assert part.other is not None
        params = self.params
        cores = part
        if params["core_spacing"] is not None:
            cores = thinned(part, params["core_spacing"], params["corner"])
        given = {name: params[name] for name in (
            "normal_radii", "cylinder_radius", "max_distance", "registration_error", "orientation"
        )}  # fmt: skip
        found = m3c2(part.cloud, part.other, core_points=cores.cloud, directions=params["direction"], **given)
        cloud = cores.cloud.copy()
        cloud["m3c2_distance"] = found.distances.astype(np.float32)
        cloud["level_of_detection"] = found.level_of_detection.astype(np.float32)
        cloud["significant"] = found.is_significant.astype(np.uint8)
        cloud["points_before"], cloud["points_after"] = found.counts.T.copy()
        return dataclasses.replace(cores, cloud=cloud)

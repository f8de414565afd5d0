"""The steps of a job: what each does to a part of a cloud, and how far around a tile it must see to do that rightly.

A step is of one of three classes. One of finite reach needs what lies within its reach. One of the k nearest is run
with a guess and certified: each point whose result is used must have k points nearer than what is missing. One with
numbers of the whole first measures all tiles, and is then done with exact sums over them. What needs the whole at once
is refused.
"""

from __future__ import annotations

import dataclasses
import importlib
import math
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from ..core.checks import check_count, check_direction, check_finite, check_positive, check_search, check_shape, shown
from ..core.errors import FileError
from ..core.known_names import nearest_name
from ..kernels.memory import download
from ..kernels.search.neighbor_distances import average_distances
from ..kernels.segmentation.neighbor_counts import mask_crowded
from ..pcd.boxes import AxisAlignedBoundingBox
from ..pcd.cloud import PointCloud
from ..pcd.outliers import ROUNDING
from .exact_sums import ExactSums

ROW = "pointloom_row"  # the attribute by which a step that drops points tells which are left

WHOLE = {
    "cluster_dbscan": "clusters reach across any number of tiles",
    "segment_plane": "a plane is found among all points",
    "detect_planar_patches": "patches reach across any number of tiles",
    "farthest_point_down_sample": "each choice depends on all before it",
    "orient_normals_consistent_tangent_plane": "signs spread over the whole cloud",
    "random_down_sample": "the choice depends on the number of all points",
    "uniform_down_sample": "the choice depends on the rows of all points",
    "classify_ground": "its grid and its windows start at the cloud's own corner",
}


@dataclass(frozen=True, eq=False)
class Part:
    """What a tile and its halo hold between two steps.

    Attributes:
        cloud: The points about the plan's origin.
        exact: Their positions as the files have them, float64 [n, 3]; None once a step has moved them.
        homes: Where each point counts as lying, x and y, float64 [n, 2]: its position in the file, or its voxel's
            middle. Each home is in one tile, whatever the tiles' size.
        spread: How far a point may lie from its home along x or y.
    """

    cloud: PointCloud
    exact: NDArray[np.float64] | None
    homes: NDArray[np.float64]
    spread: float = 0.0

    def select(self, keep: NDArray[np.bool_]) -> Part:
        """The points of a mask."""
        if keep.all():
            return self
        return self.take(np.flatnonzero(keep), self.cloud.select_by_mask(keep))

    def take(self, rows: NDArray[Any], cloud: PointCloud) -> Part:
        """Some rows, whose cloud is there already."""
        exact = None if self.exact is None else self.exact[rows]
        return dataclasses.replace(self, cloud=cloud, exact=exact, homes=self.homes[rows])


class Step:
    """One step, its parameters checked.

    Attributes:
        name: As users write it.
        params: In JSON's types, defaults filled in.
        reach: How far a result depends on other points; of the k nearest the guess, which the plan makes.
        neighbors: k, of a step of the k nearest.
        needs_numbers: Whether it needs numbers of the whole.
    """

    name = ""
    defaults: ClassVar[dict[str, Any]] = {}
    required: tuple[str, ...] = ()
    reach = 0.0
    neighbors: int | None = None
    needs_numbers = False

    def __init__(self, params: dict[str, Any]):
        known = {*self.defaults, *self.required}
        for name in params:
            if name not in known:
                raise ValueError(f"steps: {self.name} has no parameter {name!r}{nearest_name(name, known)}")
        for name in self.required:
            if name not in params:
                raise ValueError(f"steps: {self.name} needs {name!r}")
        self.params = self.defaults | params
        self.check()

    def check(self) -> None:
        """Check the parameters and set what follows from them."""

    def spread_after(self, spread: float) -> float:
        """How far points may lie from their homes after the step."""
        return spread

    def halo_before(self, after: float, spread: float, reach: float) -> float:
        """The halo that it must be given so that all is right in a halo `after` it."""
        return after + reach + 2 * spread

    def run(self, part: Part, plan: Any, numbers: ExactSums | None) -> Part:
        """The step on a part."""
        raise NotImplementedError

    def measure(self, part: Part) -> NDArray[np.float64]:
        """The values whose sums over the whole are needed."""
        raise NotImplementedError


class VoxelDownSample(Step):
    """Means of voxels of a grid that the plan fixes; a voxel is of the tile that its middle is in."""

    name, required = "voxel_down_sample", ("voxel_size",)
    defaults: ClassVar[dict[str, Any]] = {"corner": None}

    def check(self) -> None:
        """Set reach and neighbours by the parameters."""
        self.size = check_positive("voxel_size", self.params["voxel_size"])
        self.reach = self.size / 2
        if self.params["corner"] is not None:
            corner = check_finite("corner", check_shape("corner", self.params["corner"], (3,)))
            self.params["corner"] = corner.tolist()

    def spread_after(self, spread: float) -> float:
        """Means lie in their voxel, whose middle is their home."""
        return self.size / 2

    def halo_before(self, after: float, spread: float, reach: float) -> float:
        """Whole voxels are wanted."""
        return after + reach + spread

    def run(self, part: Part, plan: Any, numbers: ExactSums | None) -> Part:
        """The step on a part."""
        corner = np.array(self.params["corner"] or plan.voxel_corner, np.float64)
        trace = part.cloud.voxel_down_sample_and_trace(self.size, min_bound=corner)
        offsets, order = np.asarray(trace.offsets), np.asarray(trace.indices)
        firsts = download(part.cloud.device_array("points"))[order[offsets[:-1]]].astype(np.float64)
        cells = np.floor((firsts - (corner - part.cloud.origin)) / self.size)
        homes = corner[:2] + (cells[:, :2] + 0.5) * self.size
        return Part(trace.cloud, None, homes, self.spread_after(part.spread))


class RadiusOutlier(Step):
    """Points with few neighbours go."""

    name, required = "remove_radius_outlier", ("nb_points", "radius")

    def check(self) -> None:
        """Set reach and neighbours by the parameters."""
        check_count("nb_points", self.params["nb_points"])
        self.reach = check_positive("radius", self.params["radius"])

    def run(self, part: Part, plan: Any, numbers: ExactSums | None) -> Part:
        """The step on a part."""
        mask = mask_crowded(part.cloud.search_tree(), self.reach, self.params["nb_points"] + 1)
        return part.select(download(mask) != 0)


class EstimateNormals(Step):
    """Normals of the neighbours within a radius, of the nearest, or both; turned to a direction or left."""

    name = "estimate_normals"
    defaults: ClassVar[dict[str, Any]] = {"radius": None, "max_nn": 30, "orient": (0.0, 0.0, 1.0)}

    def check(self) -> None:
        """Set reach and neighbours by the parameters."""
        radius, count = check_search(self.params["radius"], self.params["max_nn"])
        if math.isfinite(radius):
            self.reach = radius
        else:
            self.neighbors = count
        orient = self.params["orient"]
        if isinstance(orient, str) and orient != "up":
            raise ValueError(f"steps: orient: expected 'up', a direction or None, got {shown(orient)}")
        orient = (0.0, 0.0, 1.0) if isinstance(orient, str) else orient
        self.params["orient"] = None if orient is None else check_direction("orient", orient).tolist()

    def run(self, part: Part, plan: Any, numbers: ExactSums | None) -> Part:
        """The step on a part."""
        cloud = part.cloud.estimate_normals(radius=self.params["radius"], max_nn=self.params["max_nn"])
        if self.params["orient"] is not None:
            cloud = cloud.orient_normals_to_align_with_direction(self.params["orient"])
        return dataclasses.replace(part, cloud=cloud)


class StatisticalOutlier(Step):
    """Points whose neighbours are farther away than is usual in all tiles go."""

    name, required, needs_numbers = "remove_statistical_outlier", ("nb_neighbors", "std_ratio"), True

    def check(self) -> None:
        """Set reach and neighbours by the parameters."""
        self.neighbors = check_count("nb_neighbors", self.params["nb_neighbors"])
        check_positive("std_ratio", self.params["std_ratio"])

    def measure(self, part: Part) -> NDArray[np.float64]:
        """Mean distances of the nearest."""
        assert self.neighbors is not None
        return download(average_distances(part.cloud.search_tree(), self.neighbors))

    def run(self, part: Part, plan: Any, numbers: ExactSums | None) -> Part:
        """The step on a part."""
        assert numbers is not None
        mean, deviation = numbers.mean_and_deviation()
        limit = (mean + self.params["std_ratio"] * deviation) * ROUNDING if numbers.count else 0.0
        return part.select(self.measure(part) <= limit)


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
        return Part(cloud, None, part.homes, self.spread_after(part.spread))


class Function(Step):
    """A function of a module, with its reach: it takes a cloud and gives one, of the same rows or fewer.

    It must be a pure function of the points within its reach. It may change attributes and drop points, not move or
    add any.
    """

    name, required = "function", ("call", "reach")
    defaults: ClassVar[dict[str, Any]] = {"arguments": {}}

    def check(self) -> None:
        """Set reach and neighbours by the parameters."""
        self.reach = check_positive("reach", self.params["reach"], allow_zero=True)
        call = self.params["call"]
        if callable(call):
            call = f"{getattr(call, '__module__', '')}:{getattr(call, '__qualname__', '')}"
        if not isinstance(call, str) or call.count(":") != 1 or "<" in call or call.startswith("__main__:"):
            remedy = "a function at the top of a module that workers can import, as 'module:function'"
            raise ValueError(f"steps: call: expected {remedy}, got {shown(self.params['call'])}")
        self.params["call"] = call
        self.function()

    def function(self) -> Callable[..., Any]:
        """The function itself."""
        module, _, path = self.params["call"].partition(":")
        try:
            found: Any = importlib.import_module(module)
            for name in path.split("."):
                found = getattr(found, name)
        except (ImportError, AttributeError) as error:
            raise ValueError(f"steps: call: {self.params['call']!r} cannot be imported: {error}") from error
        return found

    def run(self, part: Part, plan: Any, numbers: ExactSums | None) -> Part:
        """The step on a part."""
        given = part.cloud.copy()
        given[ROW] = np.arange(len(given))
        cloud = self.function()(given, **self.params["arguments"])
        if not isinstance(cloud, PointCloud) or ROW not in cloud.attributes:
            raise ValueError(f"{self.params['call']}: expected a PointCloud of some of its rows, got {shown(cloud)}")
        rows = np.asarray(cloud[ROW])
        cloud = cloud.copy()
        del cloud.attributes[ROW]
        left = part.take(rows, cloud)
        if not np.array_equal(part.cloud.points[rows], cloud.points):
            raise ValueError(f"{self.params['call']}: moved points, which a step of a function may not")
        return left


KNOWN: dict[str, type[Step]] = {
    kind.name: kind
    for kind in (VoxelDownSample, RadiusOutlier, EstimateNormals, StatisticalOutlier, Crop, SmoothMls, Function)
}


def parse_steps(steps: Any) -> list[Step]:
    """The steps of a list of dictionaries, or of a TOML file of [[step]] tables; "step" names each.

    Raises:
        FileError: The file cannot be read.
        ValueError: No such step, one that needs the whole cloud, or a parameter that it does not have or take.
    """
    if isinstance(steps, str | Path):
        steps = _read_toml(Path(steps))
    if isinstance(steps, dict) or not hasattr(steps, "__iter__"):
        raise TypeError(f"steps: expected a list of dictionaries or a .toml file, got {shown(steps)}")
    parsed = []
    for given in steps:
        if not isinstance(given, dict) or not isinstance(given.get("step"), str):
            raise ValueError(f"steps: expected a dictionary with the name of a 'step', got {shown(given)}")
        params = {name: value for name, value in given.items() if name != "step"}
        name = given["step"]
        if name in WHOLE:
            raise ValueError(f"steps: {name} needs the whole cloud at once: {WHOLE[name]}")
        if name not in KNOWN:
            raise ValueError(f"steps: there is no step {name!r}{nearest_name(name, KNOWN)}; {', '.join(KNOWN)}")
        parsed.append(KNOWN[name](params))
    return parsed


def _read_toml(path: Path) -> list[Any]:
    import tomllib

    try:
        content = tomllib.loads(path.read_text())
    except OSError as error:
        raise FileError(path, f"cannot be read: {error.strerror or error}") from error
    except (ValueError, RecursionError) as error:
        raise FileError(path, f"not TOML: {error}") from error
    if set(content) != {"step"} or not isinstance(content["step"], list):
        raise FileError(path, "expected [[step]] tables and nothing else")
    return [dict(table, step=table.pop("name", table.get("step"))) for table in content["step"]]

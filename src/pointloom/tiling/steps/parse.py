"""Steps by name, and parsers of step lists and TOML files.

Clusters across tiles are joined by labels at tile borders (label_join.py).
"""

from __future__ import annotations

import dataclasses
import json
import math
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, nullcontext
from itertools import pairwise
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from ...core.attribute_hints import nearest_name
from ...core.checks import (
    check_count,
    check_direction,
    check_finite,
    check_list,
    check_positive,
    check_search,
    check_shape,
    shown,
)
from ...core.errors import FileError, values_of_file
from ...core.paths import input_path
from ...core.units import UnitWarning, without_warnings
from ...kernels.features.eigen_features import SHAPES
from ...kernels.lang import int32
from ...kernels.memory import download, full, upload
from ...kernels.search.neighbor_distances import average_distances
from ...kernels.segmentation.border_labels import label_borders
from ...kernels.segmentation.cluster_labels import NOISE_LABEL, rename_cores
from ...kernels.segmentation.dbscan import cluster_cores
from ...kernels.segmentation.neighbor_counts import mask_crowded
from ...pcd.boxes import AxisAlignedBoundingBox
from ...pcd.change import check_radii, m3c2
from ...pcd.features import compute_eigen_features
from ...pcd.ground import CELL_SIZE, HEIGHT_THRESHOLD, MAX_WINDOW, SLOPE_SCALING, TERRAIN_SLOPE, classify_ground
from ...pcd.raster_cells import GROUND_CLASSES, NoGroundError, check_classes
from ...pcd.segmentation import UNLIMITED_COUNT
from ...pcd.selection import MEAN_ROUNDING
from ...pcd.terrain import ground_reach, height_above_ground
from ..exact_sums import ExactSums
from ..label_join import MAX_INT32, border_data, join_labels
from ..plan_check import TilePlan
from ..polygons import in_survey, mask_area, parse_area, to_json
from .function import ROW, Function
from .raster import Rasterize
from .reprojection import Reproject
from .step import Part, Sight, Step


class Thin(Step):
    """Keep the point nearest to the center of each cell of a fixed grid."""

    name, required, searches = "thin", ("spacing",), False
    defaults: ClassVar[dict[str, Any]] = {"corner": (0.0, 0.0, 0.0)}

    def check(self) -> None:
        """Set the halo to complete cells."""
        self.radius = check_positive("spacing", self.params["spacing"])
        self.params["corner"] = check_finite("corner", check_shape("corner", self.params["corner"], (3,))).tolist()

    def run(self, part: Part, plan: TilePlan, numbers: ExactSums | None) -> Part:
        return thinned(part, self.radius, self.params["corner"])


def thinned(part: Part, spacing: float, corner: Any) -> Part:
    cloud = part.cloud.copy()
    cloud[ROW] = np.arange(len(cloud))
    cloud = cloud.thin(spacing, corner)
    rows = np.asarray(cloud[ROW])
    del cloud.attributes[ROW]
    return part.take(rows, cloud)


NAME = "cluster"  # of the attribute


class Clusters(Step):
    """Cluster labels as the attribute `cluster`, int32, int64 beyond 2^31 clusters; -1 for noise. The halo is twice the
    radius, because cores within the radius have neighbors beyond it."""

    joins, hops = True, 2
    min_points = 1  # minimum points of a core
    bounds = (1, 2**63 - 1)
    by_size = False

    def gather(self, part: Part, sight: Sight) -> dict[str, NDArray[Any]]:
        """Clusters of a tile: complete ones, and border points of the others."""
        if part.keys is None:
            raise ValueError(f"steps: {self.name}: there are too many voxels to number them. Use larger voxels")
        _, labels, count = self._cores(part)
        return border_data(download(labels), count, part, sight, self.bounds, self.by_size)

    def join(self, left: Any, folder: Path) -> int:
        return join_labels(left, folder, self.bounds, self.by_size)

    def run(self, part: Part, plan: TilePlan, numbers: Any) -> Part:
        total, names = numbers
        kind = np.int32 if total <= MAX_INT32 else np.int64
        names = np.empty(0, kind) if names is None else names
        cores, labels, count = self._cores(part)
        if count != len(names):
            raise ValueError(f"{self.name}: expected {len(names)} clusters as in the first pass, got {count}")
        unique_names = np.unique(names[names >= 0])
        if count:
            ranks = np.where(names >= 0, np.searchsorted(unique_names, names), NOISE_LABEL).astype(np.int32)
            rename_cores(cores, upload(ranks, int32, labels.device), labels)
            if self.min_points > 1 and len(unique_names):
                label_borders(cores, labels)
        tile_labels = download(labels)
        cloud = part.cloud.copy()
        values = np.full(len(tile_labels), -1, kind)
        values[tile_labels >= 0] = unique_names[tile_labels[tile_labels >= 0]]
        cloud[NAME] = values
        return dataclasses.replace(part, cloud=cloud)

    def _cores(self, part: Part) -> tuple[Any, Any, int]:
        tree = part.cloud.search_tree()
        labels = full(len(part.cloud), NOISE_LABEL, int32, tree.device)
        cores, count = cluster_cores(tree, self.radius, self.min_points, labels)
        return cores, labels, count


class ClusterDbscan(Clusters):
    name, required = "cluster_dbscan", ("eps", "min_points")

    def check(self) -> None:
        self.radius = check_positive("eps", self.params["eps"])
        self.min_points = check_count("min_points", self.params["min_points"], **UNLIMITED_COUNT)


class ClusterEuclidean(Clusters):
    name, required, by_size = "cluster_euclidean", ("tolerance",), True
    defaults: ClassVar[dict[str, Any]] = {"min_cluster_size": 1, "max_cluster_size": None}

    def check(self) -> None:
        self.radius = check_positive("tolerance", self.params["tolerance"])
        low = check_count("min_cluster_size", self.params["min_cluster_size"], **UNLIMITED_COUNT)
        maximum = self.params["max_cluster_size"]
        high = self.bounds[1] if maximum is None else check_count("max_cluster_size", maximum, **UNLIMITED_COUNT)
        if high < low:
            raise ValueError(f"max_cluster_size: expected at least min_cluster_size = {low}, got {high}")
        self.bounds = low, high


class Compared(Step):
    """Step that compares with another epoch, the files of its parameter `other`."""

    def check(self) -> None:
        other = self.params["other"]
        listed = [other] if isinstance(other, str | Path) else other
        if not isinstance(listed, list | tuple) or not listed or not all(isinstance(p, str | Path) for p in listed):
            raise ValueError(f"steps: other: expected paths of the other epoch's files or folders, got {shown(other)}")
        self.params["other"] = self.epoch = [str(Path(path).absolute()) for path in listed]


class Distance(Compared):
    """Distance of each point to the nearest of another epoch, as `distance`. NaN beyond a limit."""

    name, required, searches = "distance", ("other", "max_distance"), False

    def check(self) -> None:
        super().check()
        self.radius = check_positive("max_distance", self.params["max_distance"])

    def run(self, part: Part, plan: TilePlan, numbers: ExactSums | None) -> Part:
        assert part.other is not None
        cloud = part.cloud.copy()
        distances = np.asarray(part.cloud.compute_point_cloud_distance(part.other))
        cloud[self.name] = np.where(distances <= self.radius, distances, np.nan).astype(np.float32)
        return dataclasses.replace(part, cloud=cloud)


class Change(Compared):
    """M3C2 to another epoch: distance, level of detection, significance, and point counts. With `core_spacing` only the
    points that `thin` keeps are measured and kept. Normals and means use all points."""

    name, required = "m3c2", ("other", "cylinder_radius", "max_distance")
    defaults: ClassVar[dict[str, Any]] = {
        "normal_radii": None, "registration_error": 0.0, "orientation": (0.0, 0.0, 1.0), "direction": None,
        "core_spacing": None, "corner": (0.0, 0.0, 0.0),
    }  # fmt: skip

    def check(self) -> None:
        super().check()
        params = self.params
        radius, length = (check_positive(name, params[name]) for name in ("cylinder_radius", "max_distance"))
        check_positive("registration_error", params["registration_error"], allow_zero=True)
        params["orientation"] = check_direction("orientation", params["orientation"]).tolist()
        if params["direction"] is not None:
            params["direction"] = check_direction("direction", params["direction"]).tolist()
        radii = check_radii(params["normal_radii"], params["direction"])
        params["normal_radii"] = radii.tolist() or None
        self.radius = max([math.hypot(radius, length), *radii.tolist()])
        params["corner"] = check_finite("corner", check_shape("corner", params["corner"], (3,))).tolist()
        if params["core_spacing"] is not None:
            self.radius = max(self.radius, check_positive("core_spacing", params["core_spacing"]))

    def run(self, part: Part, plan: TilePlan, numbers: ExactSums | None) -> Part:
        assert part.other is not None
        params = self.params
        cores = part
        if params["core_spacing"] is not None:
            cores = thinned(part, params["core_spacing"], params["corner"])
        given = {name: params[name] for name in (
            "normal_radii", "cylinder_radius", "max_distance", "registration_error", "orientation"
        )}  # fmt: skip
        result = m3c2(part.cloud, part.other, core_points=cores.cloud, directions=params["direction"], **given)
        cloud = cores.cloud.copy()
        cloud["m3c2_distance"] = result.distances.astype(np.float32)
        cloud["level_of_detection"] = result.level_of_detection.astype(np.float32)
        cloud["significant"] = result.is_significant.astype(np.uint8)
        cloud["points_before"], cloud["points_after"] = result.counts.T.copy()
        return dataclasses.replace(cores, cloud=cloud)


UNCLASSIFIED_CLASS = 1  # LAS class of former ground points


class ClassifyGround(Step):
    """Set class 2 for ground points. Others with class 2 or none get class 1."""

    name, searches = "classify_ground", False
    defaults: ClassVar[dict[str, Any]] = {
        "cell_size": CELL_SIZE, "slope": TERRAIN_SLOPE, "max_window": MAX_WINDOW,
        "elevation_threshold": HEIGHT_THRESHOLD, "scaling": SLOPE_SCALING, "corner": (0.0, 0.0),
    }  # fmt: skip

    def check(self) -> None:
        for name in ("slope", "elevation_threshold", "scaling"):
            check_positive(name, self.params[name], allow_zero=True)
        self.params["corner"] = _corner_of(self.params["corner"])
        self.radius = ground_reach(self.params["cell_size"], self.params["max_window"])

    def run(self, part: Part, plan: TilePlan, numbers: ExactSums | None) -> Part:
        with without_warnings(UnitWarning):  # all lengths of a plan are in the files' unit
            ground = np.asarray(classify_ground(part.cloud, **self.params))
        cloud = part.cloud.copy()
        before = np.asarray(cloud["classification"]) if "classification" in cloud else np.zeros(len(cloud), np.uint8)
        stays = (before != 0) & (before != GROUND_CLASSES[0])
        cloud["classification"] = np.where(
            ground, GROUND_CLASSES[0], np.where(stays, before, UNCLASSIFIED_CLASS)
        ).astype(np.uint8)
        return dataclasses.replace(part, cloud=cloud)


class HeightAboveGround(Step):
    """Height above nearby ground as the attribute `height_above_ground`."""

    name, searches = "height_above_ground", False
    defaults: ClassVar[dict[str, Any]] = {
        "reach": 20.0, "neighbors": 8, "cell": 1.0, "corner": (0.0, 0.0), "classes": GROUND_CLASSES,
    }  # fmt: skip

    def check(self) -> None:
        self.radius = check_positive("reach", self.params["reach"])
        check_count("neighbors", self.params["neighbors"])
        check_positive("cell", self.params["cell"])
        self.params["corner"] = _corner_of(self.params["corner"])
        self.params["classes"] = [*(check_classes(self.params["classes"]) or GROUND_CLASSES)]

    def run(self, part: Part, plan: TilePlan, numbers: ExactSums | None) -> Part:
        cloud = part.cloud.copy()
        try:
            cloud[self.name] = np.asarray(height_above_ground(part.cloud, **self.params))
        except NoGroundError:
            cloud[self.name] = np.full(len(cloud), np.nan, np.float32)
        return dataclasses.replace(part, cloud=cloud)


def _corner_of(corner: Any) -> list[float]:
    return check_finite("corner", check_shape("corner", corner, (2,))).tolist()


class RadiusOutlier(Step):
    name, required = "remove_radius_outlier", ("nb_points", "radius")

    def check(self) -> None:
        check_count("nb_points", self.params["nb_points"])
        self.radius = check_positive("radius", self.params["radius"])

    def run(self, part: Part, plan: TilePlan, numbers: ExactSums | None) -> Part:
        mask = mask_crowded(part.cloud.search_tree(), self.radius, self.params["nb_points"] + 1)
        return part.select(download(mask) != 0)


class StatisticalOutlier(Step):
    """Remove points with unusually distant neighbors, by statistics of all tiles."""

    name, required, needs_numbers = "remove_statistical_outlier", ("nb_neighbors", "std_ratio"), True

    def check(self) -> None:
        self.neighbors = check_count("nb_neighbors", self.params["nb_neighbors"])
        check_positive("std_ratio", self.params["std_ratio"])

    def measure(self, part: Part) -> NDArray[np.float64]:
        assert self.neighbors is not None
        return download(average_distances(part.cloud.search_tree(), self.neighbors))

    def run(self, part: Part, plan: TilePlan, numbers: ExactSums | None) -> Part:
        assert numbers is not None
        mean, deviation = numbers.mean_and_deviation()
        limit = (mean + self.params["std_ratio"] * deviation) * MEAN_ROUNDING if numbers.count else 0.0
        return part.select(self.measure(part) <= limit)


def relative_corner(params: Mapping[str, Any], plan: Mapping[str, Any]) -> NDArray[np.float64]:
    """Corner of the voxel grid of a step relative to the origin of the plan's data."""
    origin = np.array(plan["origin"])
    if params["corner"] is not None:
        return np.array(params["corner"]) - origin
    low = (np.array(plan["voxel_low"]) - origin).astype(np.float32)
    return low.astype(np.float64) - params["voxel_size"] / 2


class VoxelDownSample(Step):
    """Voxel means. The grid is that of `voxel_down_sample` of all files. A voxel belongs to the tile of its center."""

    name, required = "voxel_down_sample", ("voxel_size",)
    defaults: ClassVar[dict[str, Any]] = {"corner": None}

    def check(self) -> None:
        self.size = check_positive("voxel_size", self.params["voxel_size"])
        self.radius = self.size / 2
        if self.params["corner"] is not None:
            corner = check_finite("corner", check_shape("corner", self.params["corner"], (3,)))
            self.params["corner"] = corner.tolist()

    def spread_after(self, spread: float) -> float:
        """Means are in their voxel, whose center decides the tile."""
        return self.size / 2

    def halo_before(self, after: float, spread: float, radius: float) -> float:
        """Extend the halo to complete voxels."""
        return after + radius + spread

    def run(self, part: Part, plan: TilePlan, numbers: ExactSums | None) -> Part:
        local = self.corner_in(plan) + (plan.origin - part.cloud.origin)
        corner = local + part.cloud.origin
        trace = part.cloud.trace_grid(self.size, local)
        offsets, order = np.asarray(trace.offsets), np.asarray(trace.indices)
        firsts = download(part.cloud.arrays["points"])[order[offsets[:-1]]].astype(np.float64)
        cells = np.floor((firsts - local) / self.size)
        homes = corner[:2] + (cells[:, :2] + 0.5) * self.size
        keys = self._keys(cells, corner, plan, part)
        return Part(trace.cloud, None, homes, self.spread_after(part.spread), keys=keys)

    def corner_in(self, plan: TilePlan) -> NDArray[np.float64]:
        """Corner of the grid relative to the plan's origin, rounded as that of a cloud of all files."""
        return relative_corner(self.params, plan.data)

    def _keys(
        self, cells: NDArray[np.float64], corner: NDArray[np.float64], plan: TilePlan, part: Part
    ) -> NDArray[np.int64] | None:
        """Voxel numbers, x slowest. None if 64 bits are too few."""
        ends = (np.array([plan.data["low"], plan.data["high"]]) - corner) / self.size
        beyond = 2 + np.ceil((plan.slack + part.spread) / self.size)  # voxels, for rounding and moved points
        low, high = np.floor(ends[0]) - beyond, np.floor(ends[1]) + beyond
        shape = [int(n) for n in high - low + 1]
        if math.prod(shape) >= 2**63:
            return None
        x, y, z = np.clip(cells - low, 0, high - low).astype(np.int64).T
        return (x * shape[1] + y) * shape[2] + z


class Crop(Step):
    """Keep points in a box (faces included) or polygons. With `invert` all others."""

    name = "crop"
    defaults: ClassVar[dict[str, Any]] = {
        "min_bound": None, "max_bound": None, "polygon": None, "polygon_crs": None, "invert": False,
    }  # fmt: skip

    def check(self) -> None:
        ends = ("min_bound", "max_bound")
        given = [name for name in (*ends, "polygon") if self.params[name] is not None]
        if given not in ([*ends], ["polygon"]):
            raise ValueError(
                f"steps: crop: expected min_bound and max_bound, or polygon, got {', '.join(given) or 'none'}"
            )
        if "polygon" not in given and self.params["polygon_crs"] is not None:
            raise ValueError("steps: crop: polygon_crs needs polygon")
        if not isinstance(self.params["invert"], bool):
            raise TypeError(f"steps: crop: invert: expected True or False, got {shown(self.params['invert'])}")
        if given == ["polygon"]:
            self.area = parse_area("steps: crop: polygon", self.params["polygon"])
            self.params["polygon"] = to_json(self.area)
            return
        for name in ends:
            self.params[name] = check_finite(name, check_shape(name, self.params[name], (3,))).tolist()
        self.box = AxisAlignedBoundingBox(self.params["min_bound"], self.params["max_bound"])

    def adapt(self, sources: list[dict[str, Any]]) -> None:
        if self.params["polygon"] is not None:
            self.area = in_survey("steps: crop: polygon", self.area, self.params["polygon_crs"], sources)
            self.params |= {"polygon": to_json(self.area), "polygon_crs": None}

    def run(self, part: Part, plan: TilePlan, numbers: ExactSums | None) -> Part:
        points, origin = part.cloud.arrays["points"], part.cloud.origin
        if self.params["polygon"] is None:
            keep = download(self.box.mask_points(points, origin)) != 0
        else:
            keep = mask_area(self.area, points, origin)
        return part.select(keep != self.params["invert"])


NAMES = ("eigenvalues", *SHAPES)


class Features(Step):
    """Selected or all features of `compute_eigen_features`."""

    name = "features"
    defaults: ClassVar[dict[str, Any]] = {"radius": None, "max_nn": 30, "names": SHAPES}

    def check(self) -> None:
        radius, count = check_search(self.params["radius"], self.params["max_nn"])
        self.radius, self.neighbors = (radius, None) if math.isfinite(radius) else (0.0, count)
        names = self.params["names"]
        names = [names] if isinstance(names, str) else names
        if not isinstance(names, list | tuple) or not names:
            raise ValueError(f"steps: names: expected some of {', '.join(NAMES)}, got {shown(names)}")
        for name in names:
            if name not in NAMES:
                raise ValueError(f"steps: names: unknown feature {shown(name)}{nearest_name(name, NAMES)}")
        self.params["names"] = [*dict.fromkeys(names)]

    def run(self, part: Part, plan: TilePlan, numbers: ExactSums | None) -> Part:
        features = compute_eigen_features(part.cloud, radius=self.params["radius"], max_nn=self.params["max_nn"])
        cloud = part.cloud.copy()
        for name in self.params["names"]:
            cloud[name] = features[name]
        return dataclasses.replace(part, cloud=cloud)


class SmoothMls(Step):
    """`smooth_mls` within a radius. Points stay assigned to their tile."""

    name, required = "smooth_mls", ("radius",)
    defaults: ClassVar[dict[str, Any]] = {"max_nn": 30}

    def check(self) -> None:
        self.radius = check_positive("radius", self.params["radius"])
        check_search(self.radius, self.params["max_nn"])

    def spread_after(self, spread: float) -> float:
        """A plane through neighbors is not farther away than they are."""
        return spread + self.radius

    def run(self, part: Part, plan: TilePlan, numbers: ExactSums | None) -> Part:
        cloud = part.cloud.smooth_mls(radius=self.radius, max_nn=self.params["max_nn"])
        return dataclasses.replace(part, cloud=cloud, exact=None, spread=self.spread_after(part.spread))


class EstimateNormals(Step):
    """`estimate_normals` by radius or count; optionally oriented to a direction."""

    name = "estimate_normals"
    defaults: ClassVar[dict[str, Any]] = {"radius": None, "max_nn": 30, "orient": (0.0, 0.0, 1.0)}

    def check(self) -> None:
        radius, count = check_search(self.params["radius"], self.params["max_nn"])
        self.radius, self.neighbors = (radius, None) if math.isfinite(radius) else (0.0, count)
        orient = self.params["orient"]
        if isinstance(orient, str) and orient != "up":
            raise ValueError(f"steps: orient: expected 'up', a direction or None, got {shown(orient)}")
        orient = (0.0, 0.0, 1.0) if isinstance(orient, str) else orient
        self.params["orient"] = None if orient is None else check_direction("orient", orient).tolist()

    def run(self, part: Part, plan: TilePlan, numbers: ExactSums | None) -> Part:
        cloud = part.cloud.estimate_normals(radius=self.params["radius"], max_nn=self.params["max_nn"])
        if self.params["orient"] is not None:
            cloud = cloud.orient_normals_to_align_with_direction(self.params["orient"])
        return dataclasses.replace(part, cloud=cloud)


NEEDS_ALL_POINTS = {
    "segment_plane": "a plane is searched among all points. Thin them here and search it in memory",
    "detect_planar_patches": "patches extend over any number of tiles. Thin the points here and search them in memory",
    "farthest_point_down_sample": "each choice depends on all previous ones",
    "orient_normals_consistent_tangent_plane": "signs propagate over the complete cloud",
    "random_down_sample": "the choice depends on the number of all points",
    "uniform_down_sample": "the choice depends on the rows of all points",
}

KNOWN: dict[str, type[Step]] = {
    kind.name: kind
    for kind in (VoxelDownSample, RadiusOutlier, EstimateNormals, StatisticalOutlier, Crop, SmoothMls, Function)
}
KNOWN |= {kind.name: kind for kind in (ClusterDbscan, ClusterEuclidean)}
KNOWN |= {kind.name: kind for kind in (ClassifyGround, HeightAboveGround, Rasterize)}
KNOWN |= {kind.name: kind for kind in (Features, Thin, Distance, Change, Reproject)}


def parse_steps(steps: Any) -> list[Step]:
    """Parse a list of dictionaries or a TOML file of [[step]] tables. FileError or ValueError if a step is invalid."""
    with naming_file(steps):
        return _parse(read_toml(Path(steps)) if isinstance(steps, str | Path) else steps)


@contextmanager
def naming_file(steps: Any) -> Iterator[None]:
    """Convert errors about steps to a `FileError` if the steps came from a file."""
    with values_of_file(steps) if isinstance(steps, str | Path) else nullcontext():
        yield


def _parse(steps: Any) -> list[Step]:
    parsed = []
    for given in check_list("steps", steps, "dictionaries or a .toml file"):
        if not isinstance(given, dict) or not isinstance(given.get("step"), str):
            raise ValueError(f"steps: expected a dictionary with the name of a 'step', got {shown(given)}")
        params = {name: value for name, value in given.items() if name != "step"}
        name = given["step"]
        if name in NEEDS_ALL_POINTS:
            raise ValueError(f"steps: {name} needs the complete cloud at once: {NEEDS_ALL_POINTS[name]}")
        if name not in KNOWN:
            raise ValueError(
                f"steps: unknown step {name!r}{nearest_name(name, KNOWN)}; expected one of {', '.join(KNOWN)}"
            )
        parsed.append(KNOWN[name](params))
        _check_json(name, parsed[-1].params)
    names = [step.raster for step in parsed if isinstance(step, Rasterize)]
    if len({*names}) < len(names):
        raise ValueError(
            f"steps: expected different names of the rasters, got {', '.join(names)}. Pass a 'name' for each"
        )
    _check_order(parsed)
    return parsed


def _check_json(name: str, params: dict[str, Any]) -> None:
    """Raise ValueError if JSON cannot represent the parameters."""
    try:
        json.dumps(params, allow_nan=False)
    except (ValueError, TypeError, RecursionError) as error:
        raise ValueError(f"steps: {name}: expected numbers, strings, lists and tables of them: {error}") from error


def _check_order(steps: list[Step]) -> None:
    """Raise ValueError if a step with a variable halo follows one that was joined with the planned halo."""
    for before, step in pairwise(steps):
        if isinstance(before, Reproject):
            reason = "reproject must be the last step, since tiles and halos are in the units of the files"
            raise ValueError(f"steps: {step.name} after reproject: {reason}")
    joined = ""
    for step in steps:
        if joined and step.neighbors is not None:
            reason = f"the halo of {step.name} by nearest neighbors is known too late for {joined}"
            raise ValueError(f"steps: {reason}. Put {joined} after it, or give a radius")
        joined = step.name if step.joins else joined


def read_toml(path: Path) -> list[Any]:
    import tomllib

    path = input_path(path)
    try:
        content = tomllib.loads(path.read_text("utf-8"))
    except OSError as error:
        raise FileError(path, f"cannot be read: {error.strerror or error}") from error
    except (ValueError, RecursionError) as error:
        raise FileError(path, f"not TOML: {error}") from error
    tables = content.get("step")
    if len(content) != 1 or not isinstance(tables, list) or not all(isinstance(table, dict) for table in tables):
        raise FileError(path, "expected [[step]] tables and nothing else")
    return [table if "step" in table else {"step": table.pop("name", None), **table} for table in tables]

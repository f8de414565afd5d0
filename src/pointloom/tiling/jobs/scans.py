"""Register hundreds of scans: pairs as tasks, then the pose graph of `register_multiway`.

Stages: "scans" thins each scan once and stores its surface; "pairs" registers likely overlaps, by known positions or
order; "pairs alike" tries scans outside the largest group with similar ones; "graph" predicts more pairs from the
poses; "loops" registers these. Results are bitwise those of `register_multiway`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import lru_cache
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from ...core.atomic import atomic_write
from ...core.checks import LARGEST_NUMBER, check_count, check_list, check_positive, check_rigid, check_seed, check_shape
from ...core.devices import resolve_device
from ...core.errors import FileError, FilePath
from ...core.json_fields import (
    Checks,
    below,
    check_fields,
    has_fields,
    is_count,
    is_flag,
    is_list,
    is_number,
    is_positive,
    is_text,
    list_of,
    numbers,
    optional,
)
from ...core.paths import job_file, path_of
from ...io.points.archives import Arrays, Expected, read_part_of_job, rows_of
from ...io.points.point_cloud import read_point_cloud
from ...kernels.lang import vec3
from ...kernels.linear_algebra import matmul, norm
from ...kernels.memory import download, upload
from ...kernels.surface.hollow_side import Surface
from ...pcd.cloud import PointCloud
from ...registration.assessment_constants import MIN_SCORE
from ...registration.globally.global_registration import Description, describe
from ...registration.globally.level_poses import check_level
from ...registration.pose_graphs.connected_parts import connected_parts
from ...registration.pose_graphs.fragment_graph import (
    Extent,
    FragmentGraph,
    FragmentPair,
    loop_candidates,
    overlapping_pairs,
    poses_from_pairs,
    refine_pairs,
    transformed_box,
    with_pairs,
)
from ...registration.pose_graphs.multiway import check_known, pairs_to_try, try_pair
from .job import Done, Job, JobStatus, Task, make_job, stamp_of

SURFACES = "surfaces"  # folder of thinned scans
_AGAIN = "Plan the scans again in another folder"
MAX_CACHED = 2  # described scans cached per process: one pair. Consecutive pairs often share a scan
POSITION_NEIGHBORS = 12  # default neighbors by position
STAGE_WORDS = {1: "order", 2: "look", 4: "loop"}  # reason for the pairs of a stage
SIMILARITY_NEIGHBORS = 8  # default neighbors by similarity


class RegistrationJob(Job):
    KIND = "registration"
    STAGES = ("scans", "pairs", "pairs alike", "graph", "loops")
    PLAN: ClassVar[Checks] = {
        "scans": lambda value: list_of(is_text)(value) and len(value) > 0,
        "voxel_size": is_positive,
        "places": optional(list_of(optional(lambda value: numbers(3)(value) or _is_pose(value)))),
        "place_error": is_number,
        "neighbors": optional(is_count),
        "pairs": optional(list_of(list_of(is_count, 2))),
        "known": is_list,
        "max_similar": is_count,
        "free": optional(list_of(is_text)),
        "seed": is_count,
    }

    def __init__(self, plan: dict[str, Any], folder: Path):
        super().__init__(plan, folder)
        scan = below(len(plan["scans"]))
        self._pair: Checks = {
            **dict.fromkeys(("source", "target"), scan),
            "transformation": numbers(16),
            "fitness": is_number,
            "score": optional(is_number),
        }
        pairs: Checks = {"known": list_of(has_fields(self._pair)), "pairs": optional(list_of(list_of(scan, 2)))}
        places: Checks = {"places": optional(lambda value: len(value) == len(plan["scans"]))}
        check_fields("plan", plan, pairs | places)
        self.size: float = plan["voxel_size"]
        self._described = lru_cache(MAX_CACHED)(self._describe)

    def task_fields(self, stage: int) -> tuple[Checks, Checks]:
        refined = has_fields(self._pair | {"information": list_of(numbers(6), 6)})
        if stage == 0:
            result = dict.fromkeys(("low", "high", "origin"), numbers(3)) | {"points": is_count, "voxels": is_count}
            result |= {"radius": is_number, "look": list_of(is_number), "unit": optional(is_text)}
            return {"scan": self._pair["source"]}, result | {"stamp": is_text}
        if stage == 3:
            extents = list_of(numbers(4), len(self.plan["scans"]))
            return {"extents": extents, "pairs": list_of(refined)}, {"candidates": list_of(has_fields(self._pair))}
        result = {"pair": optional(refined), "score": optional(is_number), "doubt": is_text}
        return self._pair | {"is_known": is_flag}, result

    def check(self, done: Callable[[int], Iterator[Done]]) -> None:
        for task in done(0):
            path = self.plan["scans"][task.inputs["scan"]]
            if stamp_of([Path(path)]) != task.result["stamp"]:
                raise FileError(path, "has changed since it was read", remedy="Plan the scans again in another folder")

    def do(self, stage: int, name: str, inputs: dict[str, Any]) -> dict[str, Any]:
        if stage == 0:
            return self._look(inputs["scan"])
        if stage == 3:
            return self._graph(inputs)
        pair = pair_of(inputs)
        if stage == 4:
            overlaps = overlapping_pairs(self._surfaces(pair), [pair], self.size)
            return self._refined(pair) if overlaps else _rejected(pair, "the surfaces barely overlap")
        if inputs["is_known"]:
            return self._refined(pair)
        left, right = self._described(pair.source), self._described(pair.target)
        pair, reason = try_pair(pair.source, pair.target, left, right, self.plan["seed"], self.plan["free"])
        return self._refined(pair) if pair.score > MIN_SCORE else _rejected(pair, reason)

    def follow(self, stage: int, done: Callable[[int], Iterator[Done]]) -> Sequence[Task]:
        plan, scans = self.plan, list(done(0))
        if stage == 0:
            known = [_task(pair_of(entry), is_known=True) for entry in plan["known"]]
            given = {frozenset((entry["source"], entry["target"])) for entry in plan["known"]}
            return [*known, *(_to_try(*ends) for ends in self._first_pairs(scans) if frozenset(ends) not in given)]
        if stage == 1:
            return [_to_try(*ends) for ends in self._alike(scans, list(done(1)))]
        if stage == 2:
            extents = [[*task.result["origin"], task.result["radius"]] for task in scans]
            return [Task("graph", {"extents": extents, "pairs": _accepted_pairs(done)})]
        (graph,) = done(3)
        return [_task(pair_of(entry), is_known=False) for entry in graph.result["candidates"]]

    def warnings(self, done: Callable[[int], Iterator[Done]]) -> list[str]:
        scans = list(done(0))
        names = [self.plan["scans"][task.inputs["scan"]] for task in scans]
        units = sorted({task.result["unit"] for task in scans if task.result["unit"]})
        warnings = [f"the scans are in different units, {' and '.join(units)}"] if len(units) > 1 else []
        few = [name for name, task in zip(names, scans, strict=True) if not task.result["voxels"]]
        return [*warnings, *(f"{name}: has no surface with voxels of {self.size:g}" for name in few)]

    def _first_pairs(self, scans: Sequence[Done]) -> list[tuple[int, int]]:
        plan, count = self.plan, len(scans)
        if plan["places"] is None:
            return pairs_to_try(count, plan["neighbors"], plan["pairs"])
        boxes = [
            None if pose is None or not task.result["voxels"] else box_at_pose(
                np.array(task.result["low"]), np.array(task.result["high"]), np.array(pose), plan["place_error"]
            )
            for pose, task in zip(plan["places"], scans, strict=True)
        ]  # fmt: skip
        return nearest_of(
            meeting_boxes(boxes), boxes, POSITION_NEIGHBORS if plan["neighbors"] is None else plan["neighbors"]
        )

    def _alike(self, scans: Sequence[Done], tried: Sequence[Done]) -> list[tuple[int, int]]:
        """Pairs of scans outside the largest group with the most similar scans in it."""
        if not self.plan["max_similar"]:
            return []
        accepted = [(task.inputs["source"], task.inputs["target"]) for task in tried if task.result["pair"]]
        groups = groups_of(len(scans), accepted)
        largest = int(np.bincount(groups).argmax())
        over = {frozenset((task.inputs["source"], task.inputs["target"])) for task in tried}
        looks = np.array([task.result["look"] for task in scans])
        pairs = set()
        for k in np.flatnonzero(groups != largest).tolist():
            others = [j for j in np.flatnonzero(groups != groups[k]).tolist() if frozenset((j, k)) not in over]
            for j in most_similar(looks, k, np.array(others, np.int64), self.plan["max_similar"]):
                pairs.add((min(j, k), max(j, k)))
        return sorted(pairs)

    def _describe(self, scan: int) -> Description:
        surface = self._surface(scan)
        return describe(surface, self.size, Surface(surface.arrays["points"], surface.arrays["normals"]))

    def _surfaces(self, pair: FragmentPair) -> dict[int, PointCloud]:
        return {k: self._described(k).cloud for k in (pair.source, pair.target)}

    def _look(self, scan: int) -> dict[str, Any]:
        stamp = stamp_of([Path(self.plan["scans"][scan])])
        cloud = read_point_cloud(self.plan["scans"][scan], device=self.device)
        described = describe(cloud, self.size)
        surface, path = described.thinned, self._surface_path(scan)
        points, normals = (download(surface.arrays[name]).reshape(-1, 3) for name in ("points", "normals"))
        with atomic_write(job_file(path)) as file:
            np.savez(file, points=points, normals=normals, origin=surface.origin)
        extent, points = Extent.of(surface), surface.points
        ends = [points.min(axis=0).tolist(), points.max(axis=0).tolist()] if len(points) else [[0.0] * 3] * 2
        return {
            "stamp": stamp,
            "points": len(cloud),
            "voxels": len(surface),
            "low": ends[0],
            "high": ends[1],
            "origin": extent.origin.tolist(),
            "radius": extent.radius,
            "look": look_of(download(described.features)).tolist(),
            "unit": None if cloud.unit is None else str(cloud.unit),
        }

    def _surface_path(self, scan: int) -> Path:
        return self.folder / SURFACES / f"{scan}.npz"

    def _surface(self, scan: int) -> PointCloud:
        path, where = self._surface_path(scan), resolve_device(self.device)
        stored = read_part_of_job(path, "a scan's surface", _arrays_of_surface, _find_infinite, _AGAIN)
        arrays = {name: upload(stored[name], vec3, where) for name in ("points", "normals")}
        return PointCloud.from_device_arrays(arrays, stored["origin"])

    def _refined(self, pair: FragmentPair) -> dict[str, Any]:
        (pair,), (information,) = refine_pairs(self._surfaces(pair), [pair], self.size, self.plan["free"])
        entry = _pair_to_json(pair)
        return {"pair": entry | {"information": information.tolist()}, "score": entry["score"], "doubt": ""}

    def _graph(self, inputs: dict[str, Any]) -> dict[str, Any]:
        """Pairs that overlap according to the poses and were not found yet."""
        graph, pairs, _ = _solve_graph(inputs, self.size, self.plan["free"])
        boxes = [transformed_box(self._surface(k), graph.poses[k]) for k in graph.members.tolist()]
        return {
            "candidates": [_pair_to_json(pair) for pair in loop_candidates(boxes, graph.poses, graph.members, pairs)]
        }


def plan_registration(
    scans: Iterable[FilePath],
    folder: FilePath,
    *,
    voxel_size: float,
    places: Sequence[Any] | None = None,
    place_error: float = 0.0,
    neighbors: int | None = None,
    pairs: Sequence[tuple[int, int]] | None = None,
    known: Sequence[FragmentPair] = (),
    max_similar: int = SIMILARITY_NEIGHBORS,
    free: Sequence[str] | None = None,
    seed: int = 0,
) -> JobStatus:
    """Plan the registration of many scans without initial poses; `run_job` runs it, one task per pair.

    A folder with the same plan keeps its finished work. One with another plan is rejected. `finish_registration` gives
    bitwise the result of `register_multiway` for the same pairs. 24 B of disk per voxel of each scan.

    Args:
        scans: Point cloud files, each in its own frame, in capture order if there is one.
        folder: Folder of the job, created if missing.
        voxel_size: Edge of a voxel [m], as of `register_multiway`.
        places: Approximate pose T_world_scan (4, 4) or position (3,) of each scan, or None. Only pairs with overlapping
            boxes are tried then. Registration itself uses no initial guess.
        place_error: Error of the places [m].
        neighbors: Number of following scans tried with each. If None: all for up to 40 scans, else 5. With places:
            number of nearest overlapping boxes, default 12.
        pairs: Index pairs to try instead.
        known, free: As of `register_multiway`.
        max_similar: Number of similar scans tried with each scan outside the largest group. 0 for none.
        seed: As of `register_globally`.

    Raises:
        FileError: If a scan is missing, or the job's folder contains something else.
        ValueError: As of `register_multiway`. Also if places and scans disagree, or pairs are combined with others.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> x, y = np.random.default_rng(0).uniform(-1, 1, (2, 4000))
        >>> surface = np.column_stack([x, y, 0.2 * np.sin(5 * x) * np.cos(4 * y) + 0.1 * np.sin(9 * y + x)])
        >>> loom.write_point_cloud("west.ply", loom.PointCloud(surface[x < 0.6]))
        >>> loom.write_point_cloud("east.ply", loom.PointCloud(surface[x > -0.6] + [1, 2, 3]))
        >>> loom.tiling.plan_registration(["west.ply", "east.ply"], "job", voxel_size=0.08).waiting
        2
        >>> loom.tiling.run_job("job").is_finished
        True
        >>> loom.tiling.finish_registration("job").poses[1, :3, 3].round(2).tolist()
        [-1.0, -2.0, -3.0]
    """
    paths = [str(path_of(path).absolute()) for path in check_list("scans", scans, "paths")]
    size = check_positive("voxel_size", voxel_size, maximum=LARGEST_NUMBER)
    if not paths:
        raise ValueError("scans: expected at least one, got none")
    for path in paths:
        if not Path(path).is_file():
            raise FileError(path, "does not exist")
    if places is not None and pairs is not None:
        raise ValueError("places, pairs: expected one of them, got both")
    tried = None if pairs is None else pairs_to_try(len(paths), neighbors, pairs)
    level = check_level(free)
    plan = {
        "scans": paths,
        "voxel_size": size,
        "places": None if places is None else _check_prior_poses(places, len(paths)),
        "place_error": check_positive("place_error", place_error, allow_zero=True),
        "neighbors": None if neighbors is None else check_count("neighbors", neighbors),
        "pairs": tried,
        "known": [_pair_to_json(pair) for pair in check_known(known, len(paths), level)],
        "max_similar": check_count("max_similar", max_similar, minimum=0),
        "free": None if level is None else list(level),
        "seed": check_seed(seed),
    }
    return make_job(RegistrationJob, folder, plan, [Task(path, {"scan": k}) for k, path in enumerate(paths)])


def solve_graph(
    done: Callable[[int], Iterator[Done]], size: float, free: Sequence[str] | None
) -> tuple[FragmentGraph, list[FragmentPair]]:
    """Pose graph of a finished job, and the accepted pairs."""
    (graph,) = done(3)
    result, pairs, information = _solve_graph(graph.inputs, size, free)
    closing = [task.result["pair"] for task in done(4) if task.result["pair"]]
    if closing:
        pairs += [pair_of(row) for row in closing]
        information += [np.array(row["information"]) for row in closing]
        result = with_pairs(result, pairs, information, size, free)
    return result, pairs


def _solve_graph(
    inputs: dict[str, Any], size: float, free: Sequence[str] | None
) -> tuple[FragmentGraph, list[FragmentPair], list[NDArray[np.float64]]]:
    """Pose graph of a task's pairs, these pairs, and their information."""
    extents = [Extent(np.array(row[:3]), row[3]) for row in inputs["extents"]]
    pairs = [pair_of(row) for row in inputs["pairs"]]
    information = [np.array(row["information"]) for row in inputs["pairs"]]
    return poses_from_pairs(extents, pairs, information, size, free), pairs, information


def _arrays_of_surface(arrays: Arrays) -> Expected:
    rows = (np.float32, (rows_of(arrays, "points"), 3))
    return {"points": rows, "normals": rows, "origin": (np.float64, (3,))}


def _find_infinite(arrays: Arrays) -> str:
    wrong = [name for name in ("points", "origin") if not np.isfinite(arrays[name]).all()]
    return f"{wrong[0]}: expected finite numbers" if wrong else ""


def pair_of(entry: dict[str, Any]) -> FragmentPair:
    score = np.nan if entry["score"] is None else entry["score"]
    T = np.array(entry["transformation"], np.float64).reshape(4, 4)
    return FragmentPair(entry["source"], entry["target"], T, entry["fitness"], score)


def _pair_to_json(pair: FragmentPair) -> dict[str, Any]:
    score = None if np.isnan(pair.score) else float(pair.score)
    entry = {"source": int(pair.source), "target": int(pair.target), "fitness": float(pair.fitness), "score": score}
    return entry | {"transformation": np.asarray(pair.transformation, np.float64).ravel().tolist()}


def _rejected(pair: FragmentPair, reason: str) -> dict[str, Any]:
    return {"pair": None, "score": _pair_to_json(pair)["score"], "doubt": reason}


def _task(pair: FragmentPair, *, is_known: bool) -> Task:
    return Task(f"pair {pair.target} {pair.source}", _pair_to_json(pair) | {"is_known": is_known})


def _to_try(i: int, j: int) -> Task:
    return _task(FragmentPair(j, i, np.eye(4), 0.0, 0.0), is_known=False)


def _accepted_pairs(done: Callable[[int], Iterator[Done]]) -> list[dict[str, Any]]:
    """Accepted pairs: known ones first, then by scans."""
    accepted = [task for stage in (1, 2) for task in done(stage) if task.result["pair"]]
    known = [task for task in accepted if task.inputs["is_known"]]
    rest = [task for task in accepted if not task.inputs["is_known"]]
    rest.sort(key=lambda task: (task.inputs["target"], task.inputs["source"]))
    return [task.result["pair"] for task in (*known, *rest)]


def _check_prior_poses(places: Sequence[Any], count: int) -> list[Any]:
    poses = check_list("places", places, "poses, positions or None")
    if len(poses) != count:
        raise ValueError(f"places: expected {count}, a pose, a position or None for each scan, got {len(poses)}")
    checked = []
    for k, pose in enumerate(poses):
        if pose is None:
            checked.append(None)
        elif np.shape(pose) == (4, 4):
            checked.append(check_rigid(f"places[{k}]", pose).tolist())
        else:
            checked.append(check_shape(f"places[{k}]", pose, (3,)).tolist())
    return checked


def _is_pose(value: object) -> bool:
    return list_of(numbers(4), 4)(value)


Box = tuple[NDArray[np.float64], NDArray[np.float64]]


def look_of(features: NDArray[np.float32]) -> NDArray[np.float64]:
    """Descriptor of a scan: means and standard deviations of its points' features, or zeros if empty."""
    finite = features[np.isfinite(features).all(axis=1)].astype(np.float64)
    if not len(finite):
        return np.zeros(2 * features.shape[1])
    return np.concatenate([finite.mean(axis=0), finite.std(axis=0)])


def most_similar(looks: NDArray[np.float64], scan: int, others: NDArray[np.int64], count: int) -> list[int]:
    """Most similar scans first. Columns are scaled by their spread."""
    spread = looks.std(axis=0)
    scaled = looks / np.where(spread > 0, spread, 1.0)
    distances = np.linalg.norm(scaled[others] - scaled[scan], axis=1)
    return others[np.argsort(distances, kind="stable")[:count]].tolist()


def box_at_pose(low: NDArray[Any], high: NDArray[Any], pose: NDArray[np.float64], error: float) -> Box:
    """Bounds of a scan's box at a pose (4, 4) or, for any rotation, at a position (3,), enlarged by `error`."""
    if pose.shape == (3,):
        radius = float(norm(np.maximum(np.abs(low), np.abs(high)))) + error
        return pose - radius, pose + radius
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)])
    moved = matmul(np.where(corners, high, low), pose[:3, :3].T) + pose[:3, 3]
    return moved.min(axis=0) - error, moved.max(axis=0) + error


def meeting_boxes(boxes: Sequence[Box | None]) -> list[tuple[int, int]]:
    """Pairs of overlapping boxes, (earlier, later), ascending."""
    there = [k for k, box in enumerate(boxes) if box is not None]
    low = np.array([box[0] for box in boxes if box is not None]).reshape(-1, 3)
    high = np.array([box[1] for box in boxes if box is not None]).reshape(-1, 3)
    pairs = []
    for i, k in enumerate(there):
        meets = ((low[i + 1 :] <= high[i]) & (high[i + 1 :] >= low[i])).all(axis=1)
        pairs += [(k, there[i + 1 + j]) for j in np.flatnonzero(meets).tolist()]
    return pairs


def nearest_of(pairs: Sequence[tuple[int, int]], boxes: Sequence[Box | None], count: int) -> list[tuple[int, int]]:
    """Pairs that are among the `count` nearest of either box, by centers."""
    middles = {k: (box[0] + box[1]) / 2 for k, box in enumerate(boxes) if box is not None}
    beside: dict[int, list[tuple[float, tuple[int, int]]]] = {k: [] for k in middles}
    for i, j in pairs:
        distance = float(norm(middles[i] - middles[j]))
        for k in (i, j):
            beside[k].append((distance, (i, j)))
    return sorted({ends for neighbors in beside.values() for _, ends in sorted(neighbors)[:count]})


def groups_of(count: int, pairs: Iterable[tuple[int, int]]) -> NDArray[np.int32]:
    """Connected component of each scan, numbered by first scan."""
    ends = np.array([*pairs], np.int64).reshape(-1, 2)
    return connected_parts(ends[:, 0], ends[:, 1], count)

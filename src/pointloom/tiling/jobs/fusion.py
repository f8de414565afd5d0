"""Fuse posed frames by cubes of complete blocks into TSDF volumes larger than memory.

"frames" reads each frame once and lists the cubes it touches. "cubes" integrates each cube's frames in order, with one
layer of blocks of the next cubes, and extracts its triangles. Results are bitwise those of one volume.
"""

from __future__ import annotations

import hashlib
import re
from collections import defaultdict
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict
from functools import cached_property
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic, check_camera
from ...cameras.depth_range import DEPTH_MAX
from ...core.atomic import atomic_write
from ...core.checks import check_count, check_positive
from ...core.coordinates import choose_origin
from ...core.errors import FileError, FilePath
from ...core.json_fields import (
    Checks,
    below,
    builds,
    is_count,
    is_flag,
    is_number,
    is_positive,
    is_text,
    list_of,
    numbers,
    optional,
)
from ...core.paths import job_file, path_of, plain_name
from ...io.frames.datasets import Frame, RGBDDataset, open_frames
from ...io.frames.frames import depth_unit, read_in_order, source_warnings
from ...kernels.linear_algebra import inv
from ...kernels.volumes.tsdf_blocks import BLOCK_SIDE, block_box
from ...meshing.volume.surface_weights import min_weight
from ...meshing.volume.volume_part import BlockFinder, PartSurface, VolumePart
from ..manifest import NAME, hash_of
from .job import Done, Job, JobStatus, Task, make_job, stamp_of

VOXEL_SIZE = 0.02  # [m] as of `fuse`
BLOCKS_PER_SIDE = 32  # default blocks along a cube: 256 voxels. At most 400 MB with color
FRAMES_PER_TASK = 32  # frames per task
CUBES = "cubes"  # folder of their surfaces
_CUBE_NAME = re.compile(r"-?[0-9]{1,10}(_-?[0-9]{1,10}){2}")
_LOWER_CUBES = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)])

Cube = tuple[int, int, int]


SOURCE_FIELDS: Checks = {
    "layout": is_text,
    "every": lambda value: is_count(value) and value > 0,
    "depth_scale": optional(is_positive),
    "leave_out": is_flag,
    "intrinsic": optional(builds(lambda value: PinholeCameraIntrinsic(**value))),
}


class FusionJob(Job):
    KIND = "fusion"
    STAGES = ("frames", "cubes")
    PLAN: ClassVar[Checks] = SOURCE_FIELDS | {
        "frames": is_text,
        **dict.fromkeys(("voxel_size", "truncation", "depth_max"), is_positive),
        "blocks": lambda value: is_count(value) and value > 0,
        "weight_threshold": is_number,
        "origin": numbers(3),
        "color": is_flag,
        "digest": is_text,
        "left_out": list_of(is_text),
    }

    def task_fields(self, stage: int) -> tuple[Checks, Checks]:
        if stage == 1:
            inputs: Checks = {"cube": list_of(_is_cube_index, 3), "frames": list_of(list_of(below(2**31), 2))}
            return inputs, dict.fromkeys(("vertices", "triangles", "blocks", "bytes"), is_count)
        inputs = {"first": below(2**31), "count": lambda value: is_count(value) and value <= FRAMES_PER_TASK}
        result: Checks = {
            "meeting": _is_frames_by_cube,
            "filled": list_of(_is_cube_name),
            "left_out": list_of(is_text),
            "stamp": is_text,
        }
        return inputs, result

    @cached_property
    def frames(self) -> RGBDDataset:
        return _open(self.plan)

    @property
    def origin(self) -> NDArray[np.float64]:
        return np.array(self.plan["origin"])

    def check(self, done: Callable[[int], Iterator[Done]]) -> None:
        reason, remedy = "have changed since the job was planned", "Plan it again in another folder"
        if _digest(self.frames) != self.plan["digest"]:
            raise FileError(self.plan["frames"], f"its frames, their poses or their camera {reason}", remedy=remedy)
        for task in done(0):
            if self._stamp(task.inputs) != task.result["stamp"]:
                raise FileError(self.plan["frames"], f"{task.name} {reason}", remedy=remedy)

    def _stamp(self, inputs: dict[str, Any]) -> str:
        """Sizes and times of the files of some frames."""
        return stamp_of(
            path
            for files in self.frames.frames[inputs["first"] : inputs["first"] + inputs["count"]]
            for path in (files.depth, files.color)
            if path is not None
        )

    def do(self, stage: int, name: str, inputs: dict[str, Any]) -> dict[str, Any]:
        return self._look(inputs) if stage == 0 else self._fuse(inputs)

    def follow(self, stage: int, done: Callable[[int], Iterator[Done]]) -> Sequence[Task]:
        meeting: dict[Cube, list[int]] = defaultdict(list)
        filled: set[Cube] = set()
        for task in done(0):
            filled |= {_cube(name) for name in task.result["filled"]}
            for name, frames in task.result["meeting"].items():
                meeting[_cube(name)] += frames
        return [Task(_name(cube), {"cube": cube, "frames": _runs(meeting[cube])}) for cube in sorted(filled)]

    def notes(self, done: Callable[[int], Iterator[Done]]) -> list[str]:
        notes = [f"left out: {name}" for name in self.plan["left_out"]]
        return notes + [f"left out: {reason}" for task in done(0) for reason in task.result["left_out"]]

    def warnings(self, done: Callable[[int], Iterator[Done]]) -> list[str]:
        return [*source_warnings(self.frames)]

    def _look(self, inputs: dict[str, Any]) -> dict[str, Any]:
        """Cubes that frames touch, and those with blocks beyond the extra layer."""
        finder, n = BlockFinder(origin=self.origin, device=self.device, **self._sizes), self.plan["blocks"]
        stamp = self._stamp(inputs)
        meeting, filled, left_out = defaultdict[str, list[int]](list), set[str](), []
        for number, frame in self._read([[inputs["first"], inputs["count"]]]):
            if isinstance(frame, FileError):
                if not self.plan["leave_out"]:
                    raise frame
                left_out.append(str(frame))
                continue
            self._integrate(finder, frame)
            cubes = np.floor_divide(finder.block_indices, n)
            lowest = finder.block_indices % n == 0
            own = np.unique(cubes, axis=0)
            filled |= {_name(cube) for cube in own.tolist()}
            # a block at a lower side is in the layer of the next lower cube, one at a corner in that of seven
            beside = [cubes[(lowest | (shift == 0)).all(axis=1)] - shift for shift in _LOWER_CUBES]
            for cube in np.unique(np.concatenate(beside), axis=0).tolist():
                meeting[_name(cube)].append(number)
        result = {"meeting": dict(meeting), "filled": sorted(filled), "left_out": left_out}
        return result | {"stamp": stamp}

    def _fuse(self, inputs: dict[str, Any]) -> dict[str, Any]:
        low = np.array(inputs["cube"]) * self.plan["blocks"]
        sizes = {"origin": self.origin, "device": self.device, **self._sizes}
        volume = VolumePart(low, low + self.plan["blocks"], **sizes)
        for _, frame in self._read(inputs["frames"]):
            if isinstance(frame, FileError):
                raise frame
            self._integrate(volume, frame)
        surface = volume.extract_part(self.plan["weight_threshold"])
        sizes = {"blocks": volume.block_count, "bytes": volume.memory_bytes}
        write_surface(surface_path(self.folder, _name(inputs["cube"])), surface, low, low + self.plan["blocks"])
        return {"vertices": len(surface.vertices), "triangles": len(surface.triangles), **sizes}

    @property
    def _sizes(self) -> dict[str, Any]:
        return {name: self.plan[name] for name in ("voxel_size", "truncation", "color")}

    def _read(self, runs: list[list[int]]) -> Iterator[tuple[int, Frame | FileError]]:
        """Frames by runs: the first number and the count of each."""
        if any(first + count > len(self.frames) for first, count in runs):
            reason = f"a task has frames beyond the {len(self.frames)} of {self.plan['frames']}"
            raise FileError(self.folder / NAME, reason, remedy="Plan it again in another folder")
        numbers = [first + k for first, count in runs for k in range(count)]
        for number, take in zip(numbers, read_in_order(self.frames.read, numbers), strict=True):
            try:
                yield number, take()
            except FileError as error:
                yield number, error

    def _integrate(self, volume: Any, frame: Frame) -> None:
        camera, plan = self.frames.intrinsic, self.plan
        limits = {"depth_scale": depth_unit(self.frames, frame), "depth_max": plan["depth_max"]}
        color = frame.color if plan["color"] else None
        assert frame.T_world_camera is not None
        try:
            volume.integrate(frame.depth, camera, inv(frame.T_world_camera), color=color, **limits)
        except ValueError as error:
            raise ValueError(f"frame {frame.name}: {error}") from error


def plan_fusion(
    frames: FilePath,
    folder: FilePath,
    *,
    voxel_size: float = VOXEL_SIZE,
    size: float | None = None,
    truncation: float | None = None,
    depth_max: float = DEPTH_MAX,
    weight_threshold: float | None = None,
    layout: str = "auto",
    intrinsic: PinholeCameraIntrinsic | None = None,
    depth_scale: float | None = None,
    every: int = 1,
    leave_out: bool = False,
) -> JobStatus:
    """Plan the fusion of posed frames into a volume larger than memory, by cubes; `run_job` runs it.

    A folder with the same plan keeps its finished work. One with another plan is rejected. `finish_fusion` gives the
    triangles of `fuse` bitwise, for any cube size, ordered by cubes. Memory: a cube's blocks, 6 KB each.

    Args:
        frames: A folder of posed RGB-D or depth frames, as `open_frames` accepts it.
        folder: Folder of the job, created if missing.
        voxel_size: Edge of a voxel [m].
        size: Edge of a cube [m], rounded to blocks of 8 voxels. If None: 32 blocks.
        truncation: Truncation distance [m]. If None: 4 voxels.
        depth_max: Maximum depth used [m].
        weight_threshold: Minimum exclusive frame count of a voxel. If None: 3 from 30 frames on, 1 from 10, else 0.
        layout: As of `open_frames`, like the next three.
        intrinsic, depth_scale: Camera and depth units per meter, if they differ from the folder's files.
        every: Use every k-th frame.
        leave_out: Skip incomplete or unreadable frames and list them in `job_status`. Else they are errors.

    Raises:
        FileError: If the folder cannot be read, frames lack a pose, or the job's folder contains something else.
        ValueError: If a length is not positive, or a cube is smaller than a block.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pointloom.datasets.scenes.room import write_room_sequence
        >>> write_room_sequence("walk", frame_count=12, width=80, height=60)
        >>> loom.tiling.plan_fusion("walk", "job", voxel_size=0.05, size=0.8).stage
        'frames'
        >>> loom.tiling.run_job("job").is_finished
        True
        >>> mesh = loom.read_triangle_mesh(loom.tiling.finish_fusion("job"))
        >>> len(mesh) == len(loom.rgbd.fuse(loom.open_frames("walk"), voxel_size=0.05).mesh)
        True
    """
    edge, farthest = check_positive("voxel_size", voxel_size), check_positive("depth_max", depth_max)
    cut = 4 * edge if truncation is None else check_positive("truncation", truncation)
    if cut < edge:
        raise ValueError(f"truncation: expected at least one voxel ({edge} m), got {cut} m. 4 voxels are usual")
    blocks = BLOCKS_PER_SIDE if size is None else check_positive("size", size) / (BLOCK_SIDE * edge) * (1 + 1e-9)
    if not 1 <= blocks < 2**31:
        smallest = f"{BLOCK_SIDE} voxels ({BLOCK_SIDE * edge:g} m)"
        raise ValueError(f"size: expected 1 to 2^31 blocks of {smallest}, got {size} m")
    if weight_threshold is not None:
        weight_threshold = check_positive("weight_threshold", weight_threshold, allow_zero=True)
    camera = None if intrinsic is None else asdict(check_camera("intrinsic", intrinsic))
    plan: dict[str, Any] = {"layout": layout, "every": check_count("every", every), "depth_scale": depth_scale}
    plan |= {"frames": str(path_of(frames).absolute()), "leave_out": bool(leave_out)}
    plan |= {"intrinsic": camera, "voxel_size": edge, "truncation": cut, "depth_max": farthest, "blocks": int(blocks)}
    dataset = _open(plan)
    if not len(dataset):
        raise FileError(frames, "contains no frames that can be fused")
    threshold = min_weight(len(dataset)) if weight_threshold is None else weight_threshold
    pose = np.array(dataset.frames[0].T_world_camera, np.float64)
    first = inv(inv(pose))[None, :3, 3]  # as in `integrate`
    plan |= {"weight_threshold": float(threshold), "origin": choose_origin(first, in_one_unit=True).tolist()}
    plan |= {"color": dataset.frames[0].color is not None, "digest": _digest(dataset), "left_out": dataset.left_out}
    starts = range(0, len(dataset), FRAMES_PER_TASK)
    tasks = [(k, min(FRAMES_PER_TASK, len(dataset) - k)) for k in starts]
    chunks = [Task(f"frames {k} to {k + n - 1}", {"first": k, "count": n}) for k, n in tasks]
    return make_job(FusionJob, folder, plan, chunks)


def _open(plan: dict[str, Any]) -> RGBDDataset:
    camera = None if plan["intrinsic"] is None else PinholeCameraIntrinsic(**plan["intrinsic"])
    options = {name: plan[name] for name in ("layout", "every", "depth_scale")}
    dataset = open_frames(plan["frames"], intrinsic=camera, skip_missing=plan["leave_out"], **options)
    without = [files.name for files in dataset.frames if files.T_world_camera is None]
    if without and not plan["leave_out"]:
        reason = f"{len(without)} of {len(dataset)} frames have no pose, the first {without[0]}"
        raise FileError(
            plan["frames"],
            reason,
            remedy="Fusion needs a pose for each frame. Pass leave_out=True to skip frames without poses",
        )
    dataset.left_out.extend(f"{name} has no pose" for name in without)
    dataset.frames[:] = [files for files in dataset.frames if files.T_world_camera is not None]
    return dataset


def _digest(frames: RGBDDataset) -> str:
    digest = hashlib.sha256(np.array([files.T_world_camera for files in frames.frames]).tobytes())
    for files in frames.frames:
        digest.update(f"{files.depth}\0{files.color}\0".encode())
    return hash_of({"camera": asdict(frames.intrinsic), "scale": frames.depth_scale, "frames": digest.hexdigest()})


def _is_cube_index(value: object) -> bool:
    return isinstance(value, int) and not isinstance(value, bool) and abs(value) < 2**31


def _is_cube_name(value: object) -> bool:
    return is_text(value) and _CUBE_NAME.fullmatch(value) is not None


def _is_frames_by_cube(value: object) -> bool:
    return (
        isinstance(value, dict) and all(map(_is_cube_name, value)) and all(map(list_of(below(2**31)), value.values()))
    )


def _name(cube: Sequence[int]) -> str:
    return "_".join(map(str, cube))


def _cube(name: str) -> Cube:
    x, y, z = map(int, name.split("_"))
    return x, y, z


def _runs(numbers: list[int]) -> list[list[int]]:
    """Ascending numbers as [first, count] runs."""
    runs: list[list[int]] = []
    for number in sorted(numbers):
        if runs and number == sum(runs[-1]):
            runs[-1][1] += 1
        else:
            runs.append([number, 1])
    return runs


def surface_path(folder: Path, name: str) -> Path:
    return folder / CUBES / f"{plain_name(folder / NAME, name)}.npz"


def write_surface(path: Path, surface: PartSurface, low: NDArray[np.int64], high: NDArray[np.int64]) -> None:
    """Write a cube's surface, with its vertices on the cube's sides, which other cubes share."""
    beyond = block_box(surface.blocks)
    row, remainder = np.divmod(surface.edge_slots, 3 * BLOCK_SIDE)
    axis, z = np.divmod(remainder, BLOCK_SIDE)
    voxel = np.stack([row // BLOCK_SIDE, row % BLOCK_SIDE, z], axis=1)
    lowest = (beyond == low) & (voxel == 0) & (axis[:, None] != np.arange(3))
    shared = np.flatnonzero(((beyond == high) | lowest).any(axis=1))
    codes = {"shared": shared, "blocks": surface.blocks[shared], "places": surface.edge_slots[shared]}
    arrays = {"vertices": surface.vertices, "triangles": surface.triangles, **codes}
    if surface.colors is not None:
        arrays["colors"] = surface.colors
    with atomic_write(job_file(path)) as file:
        np.savez(file, **arrays)

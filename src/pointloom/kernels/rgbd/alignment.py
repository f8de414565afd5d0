"""Coarse-to-fine RGB-D frame alignment in one device loop, and reliability statistics.

Two launches per step. All levels share arrays, and results come with one sync. On CUDA alignments are one graph, which
is reused for frames of the same cameras (2.4 MB per VGA frame). Reliability uses the normal equations at a coarser
level without gradients at noise level, since noise of normals and brightness looks like information.
"""

import dataclasses
import os
import threading
from collections.abc import Hashable, Sequence
from typing import Any

import numpy as np

from ..algebra.matrices import multiply44
from ..algebra.rigid_solve import small_motion, solve_system, triangle, triangle_index, vec6d
from ..arrays.segment_blocks import SegmentBlocks
from ..arrays.side_by_side import SideBySide
from ..lang import (
    array,
    block_elements,
    dot,
    float32,
    float64,
    func,
    int32,
    kernel,
    launch,
    loop_while,
    mat44d,
    record,
    reduce_segments,
    replay,
    segment_reduction,
    sqrt,
    tid,
    vec3,
    vec4,
    vector,
)
from ..lru_cache import LruCache
from ..memory import on_give_back
from .alignment_rows import (
    BRIGHTNESS_COUNT,
    BRIGHTNESS_ERROR,
    SHADE_SUMS_AT,
    SURFACE_COUNT,
    SURFACE_ERROR,
    AlignmentRules,
    AlignmentState,
    row_sums,
    sum_alignment_rows,
)
from .check_rows import INLIER_LIMIT, consistency_sums, sum_consistency
from .level_copies import copy_levels
from .pyramid import FrameLevels
from .seen_pixels import (
    SLOPE_MARGIN,
    axis,
    brightness_row,
    depth_noise,
    moved_point,
    row,
    seen_at,
    seen_brightness,
    surface_row,
)

certainty_sums = vector(22, float64)  # the upper triangle, then the pixels
MIN_SLOPE = 0.015  # of brightness [1 / px]: three 8-bit gray levels, rare as noise in means of 16 px
EDGE_STEP = 0.03  # relative depth deviation from the plane at a depth edge
# Fraction of brightness weighted by the estimated noise: its errors are correlated between pixels
CORRELATED_FRACTION = 0.1
SHADE_NOISE = 0.04  # brightness deviation between frames of real cameras


@func
def squares_of(g: row, j: row, h: row, k: row, count: float) -> certainty_sums:
    """Sums of two weighted rows: g = w j, h = w k."""
    return certainty_sums(
        float64(g[0] * j[0] + h[0] * k[0]), float64(g[0] * j[1] + h[0] * k[1]), float64(g[0] * j[2] + h[0] * k[2]),
        float64(g[0] * j[3] + h[0] * k[3]), float64(g[0] * j[4] + h[0] * k[4]), float64(g[0] * j[5] + h[0] * k[5]),
        float64(g[1] * j[1] + h[1] * k[1]), float64(g[1] * j[2] + h[1] * k[2]), float64(g[1] * j[3] + h[1] * k[3]),
        float64(g[1] * j[4] + h[1] * k[4]), float64(g[1] * j[5] + h[1] * k[5]), float64(g[2] * j[2] + h[2] * k[2]),
        float64(g[2] * j[3] + h[2] * k[3]), float64(g[2] * j[4] + h[2] * k[4]), float64(g[2] * j[5] + h[2] * k[5]),
        float64(g[3] * j[3] + h[3] * k[3]), float64(g[3] * j[4] + h[3] * k[4]), float64(g[3] * j[5] + h[3] * k[5]),
        float64(g[4] * j[4] + h[4] * k[4]), float64(g[4] * j[5] + h[4] * k[5]), float64(g[5] * j[5] + h[5] * k[5]),
        float64(count),
    )  # fmt: skip


@func
def leaves_plane(at: int, u: int, v: int, plane: vec4, lens: vec4, frame: FrameLevels) -> float:
    """Distance [m] from a plane of the surface at a pixel, or of the camera if there is none."""
    z = frame.depth[at]
    p = vec3((float(u) - lens[2]) / lens[0], (float(v) - lens[3]) / lens[1], 1.0) * z
    return abs(dot(axis(plane), p) - plane[3])


@func
def is_inside(at: int, margin: int, level: int, frame: FrameLevels) -> int:
    """1 if a surface continues in its plane for `margin` pixels to all four sides."""
    size = frame.layout[level]
    lens = frame.lenses[level]
    e = at - size[2]
    u = e % size[0]
    v = e // size[0]
    inside = 0
    if margin == 0:
        inside = 1
    elif u >= margin and v >= margin and u < size[0] - margin and v < size[1] - margin:
        plane = frame.planes[at]
        if plane[3] < 0.0:
            left = leaves_plane(at - margin, u - margin, v, plane, lens, frame)
            right = leaves_plane(at + margin, u + margin, v, plane, lens, frame)
            above = leaves_plane(at - margin * size[0], u, v - margin, plane, lens, frame)
            below = leaves_plane(at + margin * size[0], u, v + margin, plane, lens, frame)
            if max(max(left, right), max(above, below)) < EDGE_STEP * frame.depth[at]:
                inside = 1
    return inside


@segment_reduction
def sum_certainty(
    source: FrameLevels,
    target: FrameLevels,
    level: int,
    other: int,
    surface_fraction: float,
    brightness_fraction: float,
    margin: int,
    warps: array(dtype=vec4),
    scales: array(dtype=float32),
) -> certainty_sums:
    """A source pixel's part. Pixels within a margin [px] of surface edges are skipped: models are rounded there, and
    occluders move with the camera. With a margin, brightness is weighted by the noise `scales`.
    """
    e = tid()
    size = source.layout[level]
    i = size[2] + e
    z = source.depth[i]
    g = row(0.0)
    j = row(0.0)
    h = row(0.0)
    k = row(0.0)
    count = 0.0
    if z > 0.0:
        p = moved_point(float(e % size[0]), float(e // size[0]), z, warps)
        u, v, at = seen_at(p, other, target)
        there = 0.0
        if at >= 0:
            there = target.depth[at]
        noise = depth_noise(p[2])
        if there > 0.0 and abs(p[2] - there) < INLIER_LIMIT * (noise + SLOPE_MARGIN * p[2]):
            count = 1.0
            plane = target.planes[at]
            inside = is_inside(at, margin, other, target)
            if plane[3] < 0.0 and inside == 1:
                j = surface_row(p, plane)
                g = j * (surface_fraction / (noise * noise))
            if source.brightness[i] >= 0.0 and brightness_fraction > 0.0 and inside == 1:
                sample = seen_brightness(u, v, other, target)
                if sample[1] * sample[1] + sample[2] * sample[2] > MIN_SLOPE * MIN_SLOPE:
                    k = brightness_row(p, sample, other, target)
                    weight = 1.0 / (SHADE_NOISE * SHADE_NOISE)
                    if margin > 0:
                        weight = scales[1] * CORRELATED_FRACTION
                    h = k * (brightness_fraction * weight)
    return squares_of(g, j, h, k, count)


DIAGONAL_DAMPING = 1.0e-6  # of the diagonal: fixes undetermined motions
MIN_PIXELS = 12.0  # fewer determine nothing
MIN_NOISE, MAX_NOISE = 0.25, 100.0  # factor of the depth variance
MIN_SHADE_NOISE, MAX_SHADE_NOISE = 0.004, 0.2  # brightness deviation, 0..1
MIN_GAIN, MAX_GAIN = 0.5, 2.0  # limits of exposure changes
MIN_VARIANCE = 1.0e-4  # of brightness: flatter images do not determine the gain


@func
def damped_solution(total: row_sums) -> vec6d:
    h = triangle(0.0)
    b = vec6d(0.0)
    n = int(6)
    m = int(21)
    for k in range(m):
        h[k] = total[k]
    for k in range(n):
        at = triangle_index(k, k)
        h[at] = h[at] * (1.0 + float64(DIAGONAL_DAMPING)) + 1.0e-12
        b[k] = -total[21 + k]
    return solve_system(h, b)


@func
def bounded(value: float64, low: float64, high: float64) -> float64:
    return min(max(value, low), high)


@func
def set_warps(level: int, source: FrameLevels, pose: mat44d, warps: array(dtype=vec4)):
    """Rays of a level's pixels under a pose: u w0 + v w1 + w2, and the translation."""
    lens = source.lenses[level]
    fx = float64(lens[0])
    fy = float64(lens[1])
    cx = float64(lens[2])
    cy = float64(lens[3])
    a = vec4(float(pose[0, 0] / fx), float(pose[1, 0] / fx), float(pose[2, 0] / fx), float(pose[0, 3]))
    b = vec4(float(pose[0, 1] / fy), float(pose[1, 1] / fy), float(pose[2, 1] / fy), float(pose[1, 3]))
    c = vec4(
        float(pose[0, 2] - pose[0, 0] * cx / fx - pose[0, 1] * cy / fy),
        float(pose[1, 2] - pose[1, 0] * cx / fx - pose[1, 1] * cy / fy),
        float(pose[2, 2] - pose[2, 0] * cx / fx - pose[2, 1] * cy / fy),
        float(pose[2, 3]),
    )
    warps[0] = a
    warps[1] = b
    warps[2] = c


@func
def learn_noise(total: row_sums, state: AlignmentState):
    """Update residual variances and exposure for the next step."""
    count = total[SURFACE_COUNT]
    if count > float64(MIN_PIXELS):
        variance = bounded(total[SURFACE_ERROR] / count, float64(MIN_NOISE), float64(MAX_NOISE))
        state.scales[0] = float(1.0 / variance)
    count = total[BRIGHTNESS_COUNT]
    if count > float64(MIN_PIXELS):
        low = float64(MIN_SHADE_NOISE) * float64(MIN_SHADE_NOISE)
        high = float64(MAX_SHADE_NOISE) * float64(MAX_SHADE_NOISE)
        state.scales[1] = float(1.0 / bounded(total[BRIGHTNESS_ERROR] / count, low, high))
        weight = total[SHADE_SUMS_AT]
        source = total[SHADE_SUMS_AT + 1] / weight
        target = total[SHADE_SUMS_AT + 2] / weight
        source_variance = total[SHADE_SUMS_AT + 3] / weight - source * source
        target_variance = total[SHADE_SUMS_AT + 4] / weight - target * target
        gain = float64(1.0)
        if min(source_variance, target_variance) > float64(MIN_VARIANCE):
            gain = bounded(sqrt(target_variance / source_variance), float64(MIN_GAIN), float64(MAX_GAIN))
        state.scales[2] = float(gain)
        state.scales[3] = float(target - gain * source)


@kernel
def step_alignment_kernel(
    source: FrameLevels, rules: AlignmentRules, sums: array(dtype=row_sums), state: AlignmentState
):
    """Move the pose. Next level after a short step or enough steps. One thread."""
    i = tid()
    level = state.counts[i]
    total = sums[level]
    learn_noise(total, state)
    state.counts[2] = state.counts[2] + 1
    taken = state.counts[1] + 1
    done = 0
    pose = state.pose[0]
    if total[SURFACE_COUNT] + total[BRIGHTNESS_COUNT] < float64(MIN_PIXELS):
        done = 1
    else:
        x = damped_solution(total)
        rotated = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2])
        moved = sqrt(x[3] * x[3] + x[4] * x[4] + x[5] * x[5])
        if rotated < 1.0 and moved < 2.0:  # otherwise (or NaN) the step is rejected
            pose = multiply44(small_motion(x), pose)
            state.pose[0] = pose
            limit = float64(rules.short_step) / float64(source.lenses[level][0])
            if taken > 1 and rotated < limit and moved < limit:
                done = 1
        else:
            done = 1
    if taken >= state.max_steps[level]:
        done = 1
    if done == 1:
        state.live[level] = 0
        level = level - 1
        taken = 0
        if level >= rules.first_level:
            state.live[level] = 1
            state.counts[0] = level
        else:
            state.running[0] = 0
    state.counts[1] = taken
    if level >= rules.first_level:
        set_warps(level, source, pose, state.warps)


@kernel
def begin_alignment_kernel(source: FrameLevels, level: int, state: AlignmentState):
    i = tid()
    set_warps(level, source, state.pose[i], state.warps)


MAX_CACHED = 8  # of Descents: 24 B per level pixel of their frames, 5 MB for VGA
COLUMNS_PER_MARGIN = 27.0  # 1/27 of the columns (3 px of 80): margin at surface edges, for plane windows and rounding


@dataclasses.dataclass(frozen=True, eq=False)
class AlignmentTask:
    """Frames to align from the pose T_target_source: from source level `last` down to the rules' first level, with at
    most `max_steps` per level (the finest first). Statistics are those of `check_level`.
    """

    source: FrameLevels
    target: FrameLevels
    pose: np.ndarray
    rules: AlignmentRules
    max_steps: Sequence[int]
    last: int
    check_level: int

    @property
    def plan(self) -> tuple[Hashable, ...]:
        """What tasks that share a Descent have in common, besides the cameras."""
        return (*vars(self.rules).values(), *self.max_steps, self.last, self.check_level)


@dataclasses.dataclass
class Alignment:
    """Result: T_target_source; `scales`: inverse variances of surface and brightness, gain, offset; `sums` of the last
    step; `consistency` and `certainty` sums at `level`; `firm`: the latter without surface edges.
    """

    pose: np.ndarray
    steps: int
    scales: np.ndarray
    sums: np.ndarray
    consistency: np.ndarray
    certainty: np.ndarray
    firm: np.ndarray
    level: int


def first_state(task: AlignmentTask) -> dict[str, tuple[np.ndarray, Any]]:
    """Initial arrays of the AlignmentState and results, for SideBySide."""
    levels = task.source.count
    live = np.zeros(levels, np.int64)
    live[task.last] = 1
    steps = np.zeros(levels, np.int64)
    steps[task.rules.first_level : task.last + 1] = task.max_steps
    return {
        "pose": (task.pose[None], mat44d),
        "counts": (np.array([task.last, 0, 0, 0]), int32),
        "scales": (np.array([0.25, 400.0, 1.0, 0.0]), float32),
        "sums": (np.zeros((levels, len(row_sums(0.0)))), row_sums),
        "running": (np.array([1]), int32),
        "live": (live, int32),
        "max_steps": (steps, int32),
        "warps": (np.zeros((3, 4)), vec4),
        "checked": (np.array([1]), int32),
        "consistency": (np.zeros((1, len(consistency_sums(0.0)))), consistency_sums),
        "certainty": (np.zeros((1, len(certainty_sums(0.0)))), certainty_sums),
        "firm": (np.zeros((1, len(certainty_sums(0.0)))), certainty_sums),
    }


class Descent:
    """Launches of an alignment with existing arrays, for frames of the cameras of a task."""

    def __init__(self, task: AlignmentTask, arrays: dict[str, Any]) -> None:
        source, rules, device = task.source, task.rules, task.source.device
        self._rules, self._last, self._level = rules, task.last, task.check_level
        self._arrays, self._state = arrays, AlignmentState(arrays)
        self._blocks = SegmentBlocks(source.firsts, source.counts, device)
        count = int(source.counts[self._level])
        self._checked = SegmentBlocks([0], [count], device, block_elements(count, device))
        self._partials = self._blocks.partials(row_sums)
        self._check_partials = {kind: self._checked.partials(kind) for kind in (consistency_sums, certainty_sums)}
        self._margin = max(1, round(float(source.sizes[self._level, 0]) / COLUMNS_PER_MARGIN))

    def align(self, source: FrameLevels, target: FrameLevels) -> None:
        """Align a source to a target, and compute the statistics of the result."""
        rules, state, arrays, level = self._rules, self._state, self._arrays, self._level

        def iterate() -> None:
            arguments = [source, target, rules, state]
            reduce_segments(sum_alignment_rows, self._blocks, state.live, arguments, self._partials, arrays["sums"])
            launch(step_alignment_kernel, 1, [source, rules, arrays["sums"], state])

        launch(begin_alignment_kernel, 1, [source, self._last, state])
        loop_while(state.running, iterate)
        launch(begin_alignment_kernel, 1, [source, level, state])
        seen, noise = [source, target, level, level + rules.shift], [state.warps, state.scales]
        fractions = [float(rules.surface_fraction > 0), float(rules.brightness_fraction > 0)]  # all nonzero terms
        self._sum(sum_consistency, [*seen, *noise], "consistency", consistency_sums)
        self._sum(sum_certainty, [*seen, *fractions, 0, *noise], "certainty", certainty_sums)
        self._sum(sum_certainty, [*seen, *fractions, self._margin, *noise], "firm", certainty_sums)

    def _sum(self, reduction: Any, arguments: list[Any], name: str, kind: Any) -> None:
        checked, arrays = self._checked, self._arrays
        reduce_segments(reduction, checked, arrays["checked"], arguments, self._check_partials[kind], arrays[name])

    def result(self, values: dict[str, np.ndarray]) -> Alignment:
        """The Alignment of downloaded arrays."""
        return Alignment(
            values["pose"][0].copy(),
            int(values["counts"][2]),
            values["scales"].copy(),
            values["sums"][self._rules.first_level].copy(),
            values["consistency"][0].copy(),
            values["certainty"][0].copy(),
            values["firm"][0].copy(),
            self._level,
        )


class Descents:
    """Alignments with one upload and one download. On CUDA they copy frames into their own, reusing one graph."""

    def __init__(self, tasks: Sequence[AlignmentTask], frames: Sequence[FrameLevels]) -> None:
        self._device: Any = frames[0].device
        states = {(k, name): value for k, task in enumerate(tasks) for name, value in first_state(task).items()}
        self._buffers = SideBySide(states, self._device)
        self._descents = [Descent(task, _of(k, self._buffers.arrays)) for k, task in enumerate(tasks)]
        self._own = [levels.like() for levels in frames] if self._device.is_cuda else []
        self._recorded: Any = None

    def run(
        self, tasks: Sequence[AlignmentTask], frames: Sequence[FrameLevels], pairs: Sequence[tuple[int, int]]
    ) -> list[Alignment]:
        """Align. `pairs`: rows of the source and the target of each task in `frames`, the same in all runs."""
        self._buffers.rewrite({(k, "pose"): (task.pose[None], mat44d) for k, task in enumerate(tasks)})
        if self._device.is_cuda:
            copy_levels(frames, self._own)
            if self._recorded is None:
                self._recorded = record(self._device, lambda: self._align(self._own, pairs))
            replay(self._recorded)
        else:
            self._align(frames, pairs)
        values = self._buffers.download()  # sync
        return [descent.result(_of(k, values)) for k, descent in enumerate(self._descents)]

    def _align(self, frames: Sequence[FrameLevels], pairs: Sequence[tuple[int, int]]) -> None:
        for descent, (source, target) in zip(self._descents, pairs, strict=True):
            descent.align(frames[source], frames[target])


def _of(number: int, values: dict[Any, Any]) -> dict[str, Any]:
    """The values of one of several alignments, by name."""
    return {name: value for (k, name), value in values.items() if k == number}


_descents: LruCache[Descents] = LruCache(MAX_CACHED)  # by cameras and plans
_lock = threading.Lock()
if hasattr(os, "register_at_fork"):  # not on Windows
    os.register_at_fork(after_in_child=_lock._at_fork_reinit)  # type: ignore[attr-defined]


def clear_descents() -> None:
    """Release memory cached for further alignments: levels of their frames on GPUs, MAX_CACHED times."""
    with _lock:
        _descents.clear()


on_give_back.append(clear_descents)


def align_levels(*tasks: AlignmentTask) -> list[Alignment]:
    """The results of the tasks, whose frames are on one device, with one sync."""
    different = {id(levels): levels for task in tasks for levels in (task.source, task.target)}
    frames, rows = list(different.values()), {number: row for row, number in enumerate(different)}
    pairs = [(rows[id(task.source)], rows[id(task.target)]) for task in tasks]
    key = (tuple(levels.key for levels in frames), *pairs, *(task.plan for task in tasks))
    with _lock:
        descents = _descents.pop(key)
    if descents is None:
        descents = Descents(tasks, frames)
    results = descents.run(tasks, frames, pairs)
    with _lock:
        _descents.put(key, descents)
    return results

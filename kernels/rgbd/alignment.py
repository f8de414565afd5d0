"""The alignment of two frames, coarse to fine, without a host in its loop, and the sums for checks of its reliability.

A step is two launches, whatever the level: sums over the pixels of the level at work, and the step. All levels stand in
the same arrays, so the whole descent is one loop of the device. What it found comes back in one read. On CUDA the
graph is kept, with arrays of its own, which frames of the same sizes are copied into: 2.4 MB a VGA frame.
"""

import contextlib
import dataclasses
import threading
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ..arrays.segment_blocks import SegmentBlocks
from ..arrays.side_by_side import SideBySide
from ..lang import DeviceLoop, array, float32, int32, kernel, launch, mat44d, reduce, reduce_segments, tid, vec4
from ..lru_cache import LruCache
from ..memory import empty, on_give_back
from .alignment_rows import AlignmentRules, AlignmentState, row_sums, sum_alignment_rows
from .alignment_step import begin_alignment_kernel, step_alignment_kernel
from .certainty_rows import certainty_sums, sum_certainty
from .level_copies import copy_levels_kernel
from .verdict_rows import sum_verdict, verdict_sums

if TYPE_CHECKING:
    from .pyramid import FrameLevels

MOST_KEPT = 8  # loops: 24 B a pixel of the levels of both frames each, 5 MB for VGA
KEPT = ("verdict", "certainty", "firm")
EDGE = 27.0  # a share of the columns, 3 px of 80, from an edge of a surface: the window of a plane and what is rounded


@kernel
def keep_sums_kernel(
    verdict: array(dtype=verdict_sums),
    certainty: array(dtype=certainty_sums),
    firm: array(dtype=certainty_sums),
    kept_verdict: array(dtype=verdict_sums),
    kept_certainty: array(dtype=certainty_sums),
    kept_firm: array(dtype=certainty_sums),
):
    """Put them beside the pose, so that all is read in one wait. One thread."""
    i = tid()
    kept_verdict[i] = verdict[i]
    kept_certainty[i] = certainty[i]
    kept_firm[i] = firm[i]


@dataclasses.dataclass
class Alignment:
    """What an alignment found.

    Attributes:
        pose: T_target_source, float64 [4, 4].
        steps: Steps taken.
        scales: Inverse variances of surface and brightness, gain and offset.
        sums: The row_sums of the last step.
        verdict: The verdict_sums of the source in the target.
        certainty: The certainty_sums under the pose.
        firm: The same without what lies at the edges of surfaces.
    """

    pose: np.ndarray
    steps: int
    scales: np.ndarray
    sums: np.ndarray
    verdict: np.ndarray
    certainty: np.ndarray
    firm: np.ndarray


def first_state(
    source: "FrameLevels", pose: np.ndarray, most_steps: Sequence[int], first_level: int, last: int
) -> dict[str, tuple[np.ndarray, Any]]:
    """The arrays of the AlignmentState at the start, and of what comes back with it, as SideBySide takes them."""
    levels = source.count
    live = np.zeros(levels, np.int64)
    live[last] = 1
    steps = np.zeros(levels, np.int64)
    steps[first_level : last + 1] = most_steps
    return {
        "pose": (pose[None], mat44d),
        "counts": (np.array([last, 0, 0, 0]), int32),
        "scales": (np.array([0.25, 400.0, 1.0, 0.0]), float32),
        "sums": (np.zeros((levels, len(row_sums(0.0)))), row_sums),
        "running": (np.array([1]), int32),
        "live": (live, int32),
        "most_steps": (steps, int32),
        "warps": (np.zeros((3, 4)), vec4),
        "verdict": (np.zeros((1, len(verdict_sums(0.0)))), verdict_sums),
        "certainty": (np.zeros((1, len(certainty_sums(0.0)))), certainty_sums),
        "firm": (np.zeros((1, len(certainty_sums(0.0)))), certainty_sums),
    }


class Descent:
    """The loop over the levels of two frames.

    Args:
        source, target: FrameLevels on one device.
        rules: AlignmentRules.
        begin: As `first_state` gives it.
        is_kept: Whether the loop has levels of its own, which frames of these sizes are copied into: on CUDA its graph
            is made once then.
    """

    def __init__(
        self,
        source: "FrameLevels",
        target: "FrameLevels",
        rules: AlignmentRules,
        begin: dict[str, tuple[np.ndarray, Any]],
        *,
        is_kept: bool,
    ) -> None:
        self._is_kept = is_kept
        self.source, self.target = (source.like(), target.like()) if is_kept else (source, target)
        self.kept = SideBySide(begin, source.device)
        state = self.state = AlignmentState(self.kept.arrays)
        sums, blocks = self.kept.arrays["sums"], SegmentBlocks(source.firsts, source.counts, source.device)
        partials = empty(blocks.count, row_sums, source.device)

        def turn() -> None:
            arguments = [self.source, self.target, rules, state]
            reduce_segments(sum_alignment_rows, blocks, state.live, arguments, partials, sums)
            launch(step_alignment_kernel, 1, [self.source, rules, sums, state])

        self._loop = DeviceLoop(state.running, turn)

    def run(
        self, source: "FrameLevels", target: "FrameLevels", begin: dict[str, tuple[np.ndarray, Any]], last: int
    ) -> None:
        """Bring a source onto a target; the pose is in `state`."""
        if self._is_kept:
            self.kept.rewrite(begin)
            for levels, own in ((source, self.source), (target, self.target)):
                launch(copy_levels_kernel, own.total, [levels, own])
        launch(begin_alignment_kernel, 1, [self.source, last, self.state])
        self._loop.run()


_descents: LruCache[Descent] = LruCache(MOST_KEPT)  # on GPUs, by the sizes of the frames and the rules
_turn = threading.Lock()


def clear_descents() -> None:
    """Release what alignments keep on GPUs for the next ones: levels of two frames, MOST_KEPT times."""
    with _turn:
        _descents.clear()


on_give_back.append(clear_descents)


@contextlib.contextmanager
def _descent_of(
    source: "FrameLevels", target: "FrameLevels", rules: AlignmentRules, begin: dict[str, tuple[np.ndarray, Any]]
) -> Iterator[Descent]:
    """A descent for two frames: one that is kept and that nobody else uses, or a new one."""
    device = source.device
    if not device.is_cuda:
        yield Descent(source, target, rules, begin, is_kept=False)
        return
    sizes = [tuple(levels.sizes.reshape(-1).tolist()) for levels in (source, target)]
    key = (device.alias, *sizes, *vars(rules).values())
    with _turn:
        descent = _descents.pop(key)
    if descent is None:
        descent = Descent(source, target, rules, begin, is_kept=True)
    yield descent
    with _turn:
        _descents.put(key, descent)


def align_levels(
    source: "FrameLevels",
    target: "FrameLevels",
    pose: np.ndarray,
    rules: AlignmentRules,
    most_steps: Sequence[int],
    last: int,
    verdict_level: int,
) -> Alignment:
    """Bring a source onto a target.

    Args:
        source, target: FrameLevels on one device.
        pose: The start, T_target_source, float64 [4, 4].
        rules: AlignmentRules.
        most_steps: Steps at most in each level from `rules.first_level` to `last`, the coarsest.
        last: That level of the source.
        verdict_level: The source's level of the sums for the checks of reliability.
    """
    begin = first_state(source, pose, most_steps, rules.first_level, last)
    with _descent_of(source, target, rules, begin) as descent:
        descent.run(source, target, begin, last)
        state, kept = descent.state, descent.kept
        launch(begin_alignment_kernel, 1, [source, verdict_level, state])
        count = int(source.counts[verdict_level])
        arguments = [source, target, verdict_level, verdict_level + rules.shift, state.warps, state.scales]
        verdict = reduce(sum_verdict, count, arguments)
        shares = [float(rules.surface_share > 0), float(rules.brightness_share > 0)]  # whatever counts determines
        edge = max(1, round(float(source.sizes[verdict_level, 0]) / EDGE))
        certainty = reduce(sum_certainty, count, [*arguments[:4], *shares, 0, *arguments[4:]])
        firm = reduce(sum_certainty, count, [*arguments[:4], *shares, edge, *arguments[4:]])
        launch(keep_sums_kernel, 1, [verdict, certainty, firm, *(kept.arrays[name] for name in KEPT)])
        found = kept.download("pose", "counts", "scales", "sums", *KEPT)  # sync
    return Alignment(
        found["pose"][0].copy(),
        int(found["counts"][2]),
        found["scales"].copy(),
        found["sums"][rules.first_level].copy(),
        found["verdict"][0].copy(),
        found["certainty"][0].copy(),
        found["firm"][0].copy(),
    )

"""The alignment of two frames, coarse to fine, without a host in its loop, and the sums that its verdict reads.

A step is two launches, whatever the level: sums over the pixels of the level at work, and the step. All levels stand in
the same arrays, so the whole descent is one loop of the device. What it found comes back in one read.
"""

import dataclasses

import numpy as np

from ..arrays.segment_blocks import SegmentBlocks
from ..arrays.side_by_side import SideBySide
from ..lang import float32, int32, launch, loop_while, mat44d, reduce, reduce_segments, vec4
from ..memory import download, empty
from .alignment_rows import AlignmentState, row_sums, sum_alignment_rows
from .alignment_step import begin_alignment_kernel, step_alignment_kernel
from .certainty_rows import sum_certainty
from .verdict_rows import sum_verdict


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
    """

    pose: np.ndarray
    steps: int
    scales: np.ndarray
    sums: np.ndarray
    verdict: np.ndarray
    certainty: np.ndarray


def make_state(source, pose, most_steps, first_level):
    """The AlignmentState at the start, and the SideBySide that holds it."""
    levels = source.count
    last = levels - 1
    live = np.zeros(levels, np.int64)
    live[last] = 1
    steps = np.zeros(levels, np.int64)
    steps[first_level:] = most_steps[: levels - first_level]
    kept = SideBySide(
        {
            "pose": (pose[None], mat44d),
            "counts": (np.array([last, 0, 0, 0]), int32),
            "scales": (np.array([0.25, 400.0, 1.0, 0.0]), float32),
            "sums": (np.zeros((levels, len(row_sums(0.0)))), row_sums),
            "running": (np.array([1]), int32),
            "live": (live, int32),
            "most_steps": (steps, int32),
            "warps": (np.zeros((3, 4)), vec4),
        },
        source.device,
    )
    return AlignmentState(kept.arrays), kept


def align_levels(source, target, pose, rules, most_steps, verdict_level):
    """Bring a source onto a target.

    Args:
        source, target: FrameLevels on one device.
        pose: The start, T_target_source, float64 [4, 4].
        rules: AlignmentRules.
        most_steps: Steps at most in each level from `rules.first_level` on.
        verdict_level: The source's level that the verdict's sums are taken in.
    """
    device = source.device
    state, kept = make_state(source, pose, most_steps, rules.first_level)
    sums = kept.arrays["sums"]
    blocks = SegmentBlocks(source.firsts, source.counts, device)
    partials = empty(blocks.count, row_sums, device)
    launch(begin_alignment_kernel, 1, [source, source.count - 1, state])

    def turn():
        reduce_segments(sum_alignment_rows, blocks, state.live, [source, target, rules, state], partials, sums)
        launch(step_alignment_kernel, 1, [source, rules, sums, state])

    loop_while(state.running, turn)
    launch(begin_alignment_kernel, 1, [source, verdict_level, state])
    count = int(source.counts[verdict_level])
    arguments = [source, target, verdict_level, verdict_level + rules.shift, state.warps, state.scales]
    verdict = reduce(sum_verdict, count, arguments)
    shares = [rules.surface_share, rules.brightness_share]
    certainty = reduce(sum_certainty, count, [*arguments[:4], *shares, state.warps])
    found = kept.download("pose", "counts", "scales", "sums")  # sync
    return Alignment(
        found["pose"][0].copy(),
        int(found["counts"][2]),
        found["scales"].copy(),
        found["sums"][rules.first_level].copy(),
        download(verdict)[0].copy(),
        download(certainty)[0].copy(),
    )

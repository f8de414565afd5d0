"""Acceptance of global registration in rooms with axis-aligned furniture, and in a kitchen.

Overlapping pairs of one room should be accepted at the correct pose, pairs of different rooms never.
Constants of the rating were chosen on rooms 0 to 15 and 100 to 109 of box_rooms.py, not on those used here, and on
every 15th image of the kitchen. The images here are the ones between.
"""

from __future__ import annotations

import dataclasses
import itertools
import sys
import zlib
from collections.abc import Iterator, Sequence

import belief_scenes
import beliefs
import box_rooms
import held_out
import numpy as np
from belief_scenes import Scan
from judged import Judged
from real_data import DataMissingError

SEEDS = range(200, 210)
VOXEL = 0.05  # [m]
APART = 3  # one of this many pairs of different rooms is judged


def judge() -> Iterator[Judged]:
    """Accepted pairs with and without overlap."""
    scans = [
        Scan(f"box room {seed} part {k}", f"box room {seed}", "room", points, pose)
        for seed in SEEDS
        for k, (points, pose) in enumerate(box_rooms.fragments(seed))
    ]
    judge_pair = beliefs.Judge(VOXEL)
    yield _count("rooms of boxes, parts of one", _shared(judge_pair, scans))
    yield _count("rooms of boxes, parts of two", _apart(judge_pair, scans, scans))
    try:
        kitchen = [scan for scan in belief_scenes.kitchen() if "frame" not in scan.name][::3]
    except DataMissingError as error:
        print(f"skipped: fragments of a kitchen: {error}", file=sys.stderr)
        return
    yield _count("kitchen, fragments of 30 frames", _shared(judge_pair, kitchen))
    yield _count("kitchen and rooms of boxes", _apart(judge_pair, kitchen, scans[::2]))
    images = list(belief_scenes.kitchen_images(range(7, 300, 15)))
    for case in held_out.judge_overlapping(judge_pair, images, "images of a kitchen"):
        yield dataclasses.replace(case, area=case.area.removesuffix(", held out"))
    apart = [(a, b) for a, b in itertools.product(images[::3], scans[::4]) if a.scene != b.scene]
    yield _count("images of the kitchen and rooms of boxes", (judge_pair.judge(*pair, None, 0.0) for pair in apart))


def _shared(judge_pair: beliefs.Judge, scans: Sequence[Scan]) -> Iterator[beliefs.Belief]:
    for source, target, T, fraction in beliefs.overlapping(scans, VOXEL):
        yield judge_pair.judge(source, target, T, fraction)


def _apart(judge_pair: beliefs.Judge, sources: Sequence[Scan], targets: Sequence[Scan]) -> Iterator[beliefs.Belief]:
    for source, target in itertools.product(sources, targets):
        if source.scene != target.scene and zlib.crc32(f"{source.name} {target.name}".encode()) % APART == 0:
            yield judge_pair.judge(source, target, None, 0.0)


def _count(case: str, outcomes: Iterator[beliefs.Belief]) -> Judged:
    rows = list(outcomes)
    wrong = [row for row in rows if not row.right]
    right = [row for row in rows if row.right]
    accepted = [row for row in wrong if row.believed]
    rejected = [row for row in right if not row.believed]
    reasons = sorted({warning for row in rejected for warning in row.warnings})
    scores = np.array([row.score for row in wrong])
    return Judged(
        "registration from no guess",
        case,
        len(rows),
        len(wrong),
        len(accepted),
        len(rejected),
        said="; ".join(reasons),
        error=f"highest score of a wrong pose {scores.max():.2f}" if len(scores) else "",
    )

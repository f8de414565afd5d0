"""Frames one after the other, cut into fragments: each follows the one before by odometry, or begins a new fragment.

A pair that odometry does not align breaks the fragment; no motion is made up for it. The frame behind a break is tried
with the last frame of the fragment before, a few frames back: what covered the lens may be gone.
"""

from __future__ import annotations

from collections.abc import Generator
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.progress import ReportProgress
from ...core.records import digest_of
from ...kernels.linear_algebra import matmul
from ..odometry.alignment import Method, align_frames
from ..odometry.frames import OdometryFrame
from ..odometry.results import OdometryResult
from .config import ReconstructionConfig
from .frames import Frames, LostFrame, ReadFrame
from .keyframes import Keyframe

Matrix = NDArray[np.float64]

METHODS = {"hybrid": Method.Hybrid, "intensity": Method.Intensity, "point_to_plane": Method.PointToPlane}
BRIDGE = 30  # frames that may lie between two fragments that odometry joins: a second


@dataclass(frozen=True, eq=False)
class Joint:
    """How a fragment hangs on an earlier one by odometry.

    Attributes:
        fragment: Number of the earlier one; the motion starts from its last frame.
        T_last_first: Pose of the later one's first frame in the earlier one's last.
        skipped: Frames between the two.
    """

    fragment: int
    T_last_first: Matrix
    skipped: int


@dataclass(eq=False)
class Draft:
    """Frames that follow each other, before their loops are closed.

    Attributes:
        number: Of the fragment.
        indices, names: Its frames.
        poses: T_first_frame of each, from odometry.
        motions: The consecutive alignments; one less than frames.
        keyframes: Every n-th frame, prepared for alignment.
        colored: Whether all of its frames have colour.
        joint: How it hangs on the fragment before; None where it does not.
        broke: Why it began, or is a beginning; empty where the fragment before was full.
        made_from: Digest of all that decided it.
        velocity: The motion that is expected of the frame behind it.
    """

    number: int
    indices: list[int] = field(default_factory=list)
    names: list[str] = field(default_factory=list)
    poses: list[Matrix] = field(default_factory=list)
    motions: list[OdometryResult] = field(default_factory=list)
    keyframes: list[Keyframe] = field(default_factory=list)
    colored: bool = True
    joint: Joint | None = None
    broke: str = ""
    made_from: str = ""
    velocity: Matrix = field(default_factory=lambda: np.eye(4))

    def __len__(self) -> int:
        return len(self.indices)


@dataclass(frozen=True, eq=False)
class Start:
    """Where a walk takes up: behind the last fragment that is done.

    Attributes:
        number: Of the next fragment.
        index: The first frame behind.
        velocity: The motion that is expected of it.
        made_from: Digest of the fragments so far.
    """

    number: int = 0
    index: int = 0
    velocity: Matrix = field(default_factory=lambda: np.eye(4))
    made_from: str = ""


def digest_of_fragment(settings: dict[str, Any], before: str, digests: list[str]) -> str:
    """What decides a fragment: the settings, the fragments before it, its frames, and the one that ends it."""
    return digest_of([settings, before, digests])


class Walk:
    """A walk through frames; `lost` grows while `drafts` is run.

    Args:
        frames: Of the source.
        settings: What of the configuration decides fragments, for their digests.
        device: Where to compute.
        start: Where to take up.
        say: Told how many frames are done.
    """

    def __init__(self, frames: Frames, settings: dict[str, Any], device: Any, start: Start, say: ReportProgress):
        self.frames, self.settings, self.device, self.start, self.say = frames, settings, device, start, say
        self.config: ReconstructionConfig = frames.config
        self.lost: list[LostFrame] = []
        self.number, self.made_from, self._first = start.number, start.made_from, start.index
        self._digests: dict[int, str] = {}  # of the frames behind the last fragment
        self._draft: Draft | None = None
        self._previous: tuple[OdometryFrame, int] | None = None  # the frame before, where it can be aligned with
        self._anchor: tuple[OdometryFrame, int, int] | None = None  # last frame of the last fragment, its index, number
        self._velocity = start.velocity
        self._spare: Draft | None = None  # the longest of those that are too short, while there is no fragment

    def drafts(self) -> Generator[Draft, None, None]:
        """The fragments, in order."""
        begin, count = self.start.index, self.frames.count
        if self.start.number:
            last = self.prepare(self.frames.read(begin - 1))
            self._previous, self._anchor = (last, begin - 1), (last, begin - 1, self.start.number - 1)
        self.say("frames", begin, count)
        with self.frames.closing(range(begin, count)) as frames:
            for frame in frames:
                self._digests[frame.index] = frame.digest
                yield from self._take(frame)
                self.say("frames", frame.index + 1, count)
        yield from self._close("the frames end")
        if self._spare is not None:
            draft, self._spare = self._spare, None
            self.lost = [lost for lost in self.lost if lost.index not in draft.indices]
            yield self._kept(draft)

    def prepare(self, frame: ReadFrame) -> OdometryFrame:
        """A frame as alignment takes it."""
        assert frame.depth is not None
        return OdometryFrame(
            frame.depth, self.frames.intrinsic, color=frame.color, depth_max=self.config.depth_max, device=self.device
        )

    def _take(self, frame: ReadFrame) -> Generator[Draft, None, None]:
        """One frame: it joins the open draft, or closes it and begins another."""
        if frame.depth is None:
            self.lost.append(LostFrame(frame.index, frame.name, frame.reason))
            yield from self._close(f"{frame.name}: {frame.reason}")
            self._previous = None
            return
        current = self.prepare(frame)
        found, reason = None, "there is no frame before it"
        if self._previous is not None:
            found = self._follow(current, self._previous[0])
            reason = "; ".join(found.warnings)
        if found is not None and found.reliable and self._draft and len(self._draft) < self._limit:
            self._append(frame, current, found)
        else:
            succeeded = found is not None and found.reliable
            yield from self._close("" if succeeded else f"{frame.name} cannot be aligned with it: {reason}")
            self._begin(frame, current, found if succeeded else None, reason)
        self._previous = current, frame.index

    @property
    def _limit(self) -> int:
        return self.config.n_frames_per_fragment

    def _follow(self, current: OdometryFrame, previous: OdometryFrame) -> OdometryResult:
        """The motion from the frame before, begun where it is expected, or else from no motion."""
        found = align(self.config, current, previous, self._velocity)
        if not found.reliable and not np.array_equal(self._velocity, np.eye(4)):
            found = align(self.config, current, previous, np.eye(4))
        return found

    def _append(self, frame: ReadFrame, current: OdometryFrame, found: OdometryResult) -> None:
        draft = self._draft
        assert draft is not None
        self._velocity = np.asarray(found.transformation)
        draft.motions.append(found)
        self._add(draft, frame, current, matmul(draft.poses[-1], found.transformation))

    def _add(self, draft: Draft, frame: ReadFrame, current: OdometryFrame, pose: Matrix) -> None:
        if len(draft) % self.config.n_keyframes_per_n_frame == 0:
            assert frame.depth is not None
            draft.keyframes.append(Keyframe.make(len(draft), current, frame.depth, self.frames.intrinsic))
        draft.indices.append(frame.index)
        draft.names.append(frame.name)
        draft.poses.append(pose)
        draft.colored = draft.colored and frame.color is not None

    def _begin(self, frame: ReadFrame, current: OdometryFrame, found: OdometryResult | None, reason: str) -> None:
        """A new draft; it hangs on the fragment before where odometry says so."""
        draft = Draft(self.number, broke="" if found is not None else reason)
        if found is not None and self._anchor is not None and self._anchor[1] == frame.index - 1:
            self._velocity = np.asarray(found.transformation)
            draft.joint = Joint(self._anchor[2], self._velocity, 0)
        else:
            self._velocity = np.eye(4)
            draft.joint = self._bridge(frame, current)
        self._add(draft, frame, current, np.eye(4))
        self._draft = draft

    def _bridge(self, frame: ReadFrame, current: OdometryFrame) -> Joint | None:
        """How a frame hangs on the last fragment, across some that do not."""
        if self._anchor is None or not 1 < frame.index - self._anchor[1] <= BRIDGE:
            return None
        found = align(self.config, current, self._anchor[0], np.eye(4))
        if not found.reliable:
            return None
        return Joint(self._anchor[2], np.asarray(found.transformation), frame.index - self._anchor[1] - 1)

    def _close(self, reason: str) -> Generator[Draft, None, None]:
        """End the open draft: a fragment, or frames that are lost."""
        draft, self._draft = self._draft, None
        if draft is None:
            return
        draft.velocity = self._velocity
        if len(draft) >= self.config.n_frames_least:
            self._spare = None
            if self._previous is not None:
                self._anchor = self._previous[0], draft.indices[-1], draft.number
            yield self._kept(draft)
            return
        few = f"{len(draft)} frame{'s' * (len(draft) > 1)} alone, {self.config.n_frames_least} needed"
        before = f"; {draft.broke}" if draft.broke else ""
        behind = f"; {reason}" if reason else ""
        for index, name in zip(draft.indices, draft.names, strict=True):
            self.lost.append(LostFrame(index, name, f"{few}{before}{behind}"))
        if self.number == 0 and (self._spare is None or len(draft) > len(self._spare)):
            self._spare = draft

    def _kept(self, draft: Draft) -> Draft:
        """A draft that becomes a fragment, with the digest of what decided it."""
        last = draft.indices[-1]
        decided = [self._digests[i] for i in range(self._first, last + 1)] + [self._digests.get(last + 1, "")]
        draft.made_from = self.made_from = digest_of_fragment(self.settings, self.made_from, decided)
        self._first = last + 1
        self._digests = {index: digest for index, digest in self._digests.items() if index > last}
        self.number += 1
        return draft


def align(
    config: ReconstructionConfig, source: OdometryFrame, target: OdometryFrame, T_target_source: Matrix
) -> OdometryResult:
    """Odometry between two frames as the configuration says; by depth alone where one has no colour."""
    method = METHODS[config.odometry_method if source.has_color and target.has_color else "point_to_plane"]
    return align_frames(source, target, T_target_source, method=method)

"""Maps of a SLAM run: a camera that is lost for long starts a new one, and may return to an old one.

Each map has its own model, keyframes and coordinates until it is joined (map_joins.py).
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .frames import SensorFrame
from .keyframes import Keyframes
from .model import SlamModel
from .results import TrackingResult
from .submaps import SubmapRecorder
from .tracker import Attempt, Tracker

Pose = NDArray[np.float64]

LOST_FOR_LONG = 20  # frames with content: a lost camera was then searched by shape four times (tracker.py)
TRIAL_FRAMES = 10  # fused frames that confirm a new map; before, a lost frame ends it
LONGEST_TRIAL = 30  # maximum frames of a trial
MAX_MAPS = 4  # kept with a model; beyond it the smallest inactive one is freed


class FusedFrame(NamedTuple):
    """A frame as it was fused into the map `owner`: its number, depth [m], colors or None, and pose."""

    number: int
    owner: SlamMap
    depth: Any
    pixels: Any
    pose: Pose


class SlamMap:
    """A model with its own coordinates, numbered from 0, with keyframes, tracker, and submap recorder or None."""

    def __init__(self, number: int, model: SlamModel, keyframes: Keyframes, recorder: SubmapRecorder | None):
        self.number, self.model, self.keyframes, self.recorder = number, model, keyframes, recorder
        self.tracker = Tracker(model, keyframes)

    def __repr__(self) -> str:
        return f"SlamMap({self.number}, {self.model.frame_count} frames, {len(self.keyframes)} keyframes)"

    def begin_again(self, pose: Pose, recorder: SubmapRecorder | None) -> None:
        """Reset the map. The next frame is at T_world_camera."""
        self.model.begin_anew(pose)
        self.keyframes, self.recorder = Keyframes(self.model.device, self.keyframes.seed), recorder
        self.tracker = Tracker(self.model, self.keyframes)

    def withdraw(self, frame: FusedFrame, *, is_restored: bool = False) -> None:
        """Remove a frame from the surface and the submaps, or add it again. Tracking uses the complete model."""
        self.model._withdraw(frame.depth, frame.pixels, frame.pose, is_restored)
        if self.recorder is not None:
            self.recorder._withdraw(frame.number, frame.depth, frame.pose, frame.pixels, is_restored)

    def leave(self) -> None:
        """Mark the camera as lost here since it continues in another map."""
        motion = self.tracker.motion
        motion.step, motion.missed = np.eye(4), max(motion.missed, 1)
        if self.recorder is not None:
            self.recorder.finish()


class Maps:
    """The current map (`here`), all searchable maps (`searchable`), and the number ever begun (`begun`)."""

    def __init__(self, make: Callable[[int], SlamMap]):
        self._make = make
        self.here = make(0)
        self.searchable, self.begun = [self.here], 1
        self._before: SlamMap | None = None  # the map before the trial
        self._lost = self._taken = 0  # lost frames with content. Frames on trial
        self._is_tracking_alone = False

    @property
    def others(self) -> list[SlamMap]:
        return [known for known in reversed(self.searchable) if known is not self.here]

    @property
    def is_on_trial(self) -> bool:
        return self._before is not None

    def find_elsewhere(self, frame: SensorFrame) -> Attempt | None:
        """Find a lost frame in a map that the camera left, which becomes `here`."""
        for other in self.others:
            attempt, _ = other.tracker.locate(frame)
            if attempt.status == "tracked":
                self.enter(other)
                return attempt
        return None

    def enter(self, other: SlamMap) -> None:
        if self.here is not other:
            self.here.leave()
        self.here, self._before, self._lost = other, None, 0

    def note_tracked(self) -> None:
        self._lost = 0
        if self.is_on_trial:
            self._taken += 1
            if self.here.model.frame_count >= TRIAL_FRAMES:
                self._before = None

    def is_failing(self) -> bool:
        return self.is_on_trial and self._taken >= LONGEST_TRIAL and self.here.model.frame_count < TRIAL_FRAMES

    def lost(self) -> bool:
        """Note a frame with content that no map matches. True if a new map should begin."""
        self._lost += 1
        return self._lost > LOST_FOR_LONG and not self._is_tracking_alone

    def begin(self) -> SlamMap:
        before = self.here
        before.leave()
        self._let_go()
        self.here = self._make(self.begun)
        self.begun += 1
        self.searchable.append(self.here)
        self._before, self._lost, self._taken = before, 0, 0
        return self.here

    def give_up(self, results: list[TrackingResult]) -> None:
        """Discard the map on trial: its frames are lost, and the previous map is searched again."""
        number, self._is_tracking_alone = self.here.number, not self.here.model.frame_count
        count = sum(result.map == number and result.pose is not None for result in results)
        assert self._before is not None
        message = f"the new map that began here was discarded after {count} frame{'s' if count != 1 else ''}"
        for i, result in enumerate(results):
            if result.map == number:
                warnings = (message,) if result.pose is not None else result.warnings
                changes = {"pose": None, "status": "lost", "warnings": warnings, "fused": False}
                results[i] = dataclasses.replace(result, map=self._before.number, **changes)
        self.searchable.remove(self.here)
        self.here, self._before, self._lost = self._before, None, 0

    def drop(self, joined: SlamMap, *, instead: SlamMap) -> None:
        self.searchable.remove(joined)
        if self.here is joined:
            self.here, self._before = instead, None

    def _let_go(self) -> None:
        """Free the smallest map if there are too many. Its frames keep its number."""
        while len(self.searchable) >= MAX_MAPS:
            smallest = min(self.others or self.searchable, key=lambda known: (known.model.frame_count, -known.number))
            self.searchable.remove(smallest)


def map_sizes(results: list[TrackingResult]) -> dict[int, int]:
    sizes: dict[int, int] = {}
    for result in results:
        if result.pose is not None:
            sizes[result.map] = sizes.get(result.map, 0) + 1
    return dict(sorted(sizes.items(), key=lambda item: (-item[1], item[0])))

"""The maps of a run: a camera that is lost for long begins a new one, and comes back to an old one where it knows it.

Each map has a model, keyframes and coordinates of its own. Nothing is known of how two lie to each other until one of
them shows what the other shows (joins.py); until then nothing of both is told in the same coordinates.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from .frames import SensorFrame
from .keyframes import Keyframes
from .model import Model
from .results import TrackingResult
from .submaps import SubmapRecorder
from .tracker import Attempt, Tracker

Pose = NDArray[np.float64]

LOST_FOR_LONG = 20  # frames that show something: by then a lost camera was looked for by shape four times (tracker.py)
TRIAL = 10  # fused frames from which on a new map is one; before, a lost frame ends it
LONGEST_TRIAL = 30  # frames within which these have to be: else what it shows fixes no motion
MOST_MAPS = 4  # kept with a model; one more, and the smallest of those that the camera left is let go


class SlamMap:
    """A model with coordinates of its own, and what finds frames in it.

    Attributes:
        number: From 0, in the order in which maps were begun.
        model: The Model.
        keyframes: The Keyframes.
        tracker: The Tracker of the two.
        recorder: What keeps its submaps, or None.
    """

    def __init__(self, number: int, model: Model, keyframes: Keyframes, recorder: SubmapRecorder | None):
        self.number, self.model, self.keyframes, self.recorder = number, model, keyframes, recorder
        self.tracker = Tracker(model, keyframes)

    def __repr__(self) -> str:
        return f"SlamMap({self.number}, {self.model.frame_count} frames, {len(self.keyframes)} keyframes)"

    def begin_again(self, pose: Pose, recorder: SubmapRecorder | None) -> None:
        """Forget what was seen; the next frame stands at a pose, T_world_camera."""
        self.model.begin_anew(pose)
        self.keyframes, self.recorder = Keyframes(self.model.device, self.keyframes.seed), recorder
        self.tracker = Tracker(self.model, self.keyframes)

    def leave(self) -> None:
        """The camera goes on in another map: here it is lost, and nothing is known of its velocity."""
        motion = self.tracker.motion
        motion.step, motion.missed = np.eye(4), max(motion.missed, 1)
        if self.recorder is not None:
            self.recorder.finish()


class Maps:
    """The map that the camera is in, and those that it left.

    Args:
        make: Makes an empty map of a number.

    Attributes:
        here: The map that the camera is in.
        kept: All maps that frames can be found in, `here` among them.
        begun: How many maps were begun, those included that were given up, joined or let go.
    """

    def __init__(self, make: Callable[[int], SlamMap]):
        self._make = make
        self.here = make(0)
        self.kept, self.begun = [self.here], 1
        self._before: SlamMap | None = None  # where the camera was when the map on trial began
        self._lost = self._taken = 0  # frames lost that showed something; frames that the map on trial was given
        self._is_tracking_alone = False

    @property
    def others(self) -> list[SlamMap]:
        """Those that the camera left, the latest first."""
        return [known for known in reversed(self.kept) if known is not self.here]

    @property
    def is_on_trial(self) -> bool:
        """Whether `here` is a new map that may be given up."""
        return self._before is not None

    def find_elsewhere(self, frame: SensorFrame) -> Attempt | None:
        """A frame that is lost here, found in a map that the camera left; that one is `here` then."""
        for other in self.others:
            attempt, _ = other.tracker.locate(frame)
            if attempt.verdict == "tracked":
                self.enter(other)
                return attempt
        return None

    def enter(self, other: SlamMap) -> None:
        """The camera goes on in another map."""
        if self.here is not other:
            self.here.leave()
        self.here, self._before, self._lost = other, None, 0

    def found(self) -> None:
        """A frame has a place here."""
        self._lost = 0
        if self.is_on_trial:
            self._taken += 1
            if self.here.model.frame_count >= TRIAL:
                self._before = None

    def is_failing(self) -> bool:
        """Whether the map on trial has not become one in time."""
        return self.is_on_trial and self._taken >= LONGEST_TRIAL and self.here.model.frame_count < TRIAL

    def lost(self) -> bool:
        """A frame that shows something has no place in any map; whether a new one is to be begun with it."""
        self._lost += 1
        return self._lost > LOST_FOR_LONG and not self._is_tracking_alone

    def begin(self) -> SlamMap:
        """A new map, on trial."""
        before = self.here
        before.leave()
        self._let_go()
        self.here = self._make(self.begun)
        self.begun += 1
        self.kept.append(self.here)
        self._before, self._lost, self._taken = before, 0, 0
        return self.here

    def give_up(self, results: list[TrackingResult]) -> None:
        """End the map on trial: its frames are lost ones, and the camera is looked for where it was before."""
        number, self._is_tracking_alone = self.here.number, not self.here.model.frame_count
        count = sum(result.map == number and result.pose is not None for result in results)
        assert self._before is not None
        told = f"a new map that began here was given up after {count} frame{'s' if count != 1 else ''}"
        for i, result in enumerate(results):
            if result.map == number:
                reason = told if result.pose is not None else result.reason
                changes = {"pose": None, "verdict": "lost", "reason": reason, "fused": False}
                results[i] = dataclasses.replace(result, map=self._before.number, **changes)
        self.kept.remove(self.here)
        self.here, self._before, self._lost = self._before, None, 0

    def drop(self, joined: SlamMap, *, instead: SlamMap) -> None:
        """A map was joined to another one, where the camera goes on if it was in it."""
        self.kept.remove(joined)
        if self.here is joined:
            self.here, self._before = instead, None

    def _let_go(self) -> None:
        """Free the smallest of the maps, where there are too many; its frames keep its number."""
        while len(self.kept) >= MOST_MAPS:
            least = min(self.others or self.kept, key=lambda known: (known.model.frame_count, -known.number))
            self.kept.remove(least)


def map_sizes(results: list[TrackingResult]) -> dict[int, int]:
    """How many frames have a place in each map, the largest first; of two as large the earlier first."""
    sizes: dict[int, int] = {}
    for result in results:
        if result.pose is not None:
            sizes[result.map] = sizes.get(result.map, 0) + 1
    return dict(sorted(sizes.items(), key=lambda item: (-item[1], item[0])))

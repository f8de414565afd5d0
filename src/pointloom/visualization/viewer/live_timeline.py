"""History of a running viewer: `LiveTimeline`, updated by `SceneEdits`.

A time step stores its changes only: geometries by reference, poses as matrices. An earlier scene follows from the last
change of each name.
"""

from __future__ import annotations

import bisect
import dataclasses
import logging
import math
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ...core.checks import check_name, check_number, check_positive, check_rigid
from .items import Item, Matrix, make_item
from .scene_display import SceneDisplay

HISTORY_BYTES = 2**30
ENTRY_BYTES = 400  # bytes of a change without arrays: a pose and Python objects
MAX_INCLUDED_BYTES = 256  # bytes of arrays included in ENTRY_BYTES
MAX_UNIT_STEP_INTERVAL = 4  # integer times with a larger mean interval use another step
REMAINING_FRACTION = 0.9  # of the memory limit after dropping, so that not every change drops a step
FULL = "The history is full: its oldest time steps are dropped when new ones are added."
log = logging.getLogger("pointloom.viewer")


@dataclasses.dataclass(frozen=True, eq=False)
class State:
    """State of a geometry at a time step: pose (4x4 or None), visibility, and the item (whose own ones are ignored)."""

    item: Item
    pose: Matrix | None
    visible: bool


class LiveTimeline:
    """Time steps of a viewer. Requires the scene's lock. Beyond `max_bytes` the oldest steps are dropped.

    `times` are the stored times, ascending, and `bytes` is the memory used. Shared arrays count once.
    """

    def __init__(self, display: SceneDisplay, max_bytes: float):
        self._display, self._scene = display, display.scene
        self._max_bytes = check_positive("history_bytes", max_bytes)
        self.times: list[float] = []
        self.bytes, self.dropped = 0, 0  # number of dropped steps: that of the first of `times`
        self._tracks: dict[str, list[tuple[int, State | None]]] = {}
        self._touched: list[set[str]] = []  # names that changed, by step
        self._arrays: dict[int, tuple[int, int]] = {}  # by address: reference count and bytes
        self._shown: int | None = None  # number of the displayed step. None follows the newest
        self.is_integer = True  # all times are integers
        self._control: Any = None
        self._sent_value = 0.0  # last value sent to the control
        self._is_closed = False
        self._unbuilt: set[Item] = set()  # replaced while their levels of detail were being built

    @property
    def is_live(self) -> bool:
        """True if pages show the newest step."""
        return self._shown is None

    @property
    def time(self) -> float:
        return self.times[-1 if self._shown is None else self._shown - self.dropped]

    def set_time(self, t: float) -> None:
        time = check_number("t", t)
        if self.times and time < self.times[-1]:
            raise ValueError(f"t: expected at least the newest time, {self.times[-1]:g}, got {time:g}")
        if self.times and time == self.times[-1]:
            return
        is_first = not self.times
        self.is_integer = self.is_integer and hasattr(t, "__index__")
        self.times.append(time)
        self._touched.append(set())
        if is_first:
            self.take_scene()
        self._update_control()

    def take_scene(self, names: Iterable[Any] = ()) -> None:
        """Record the displayed state of some names, or of all, in the newest step."""
        items = self._scene.shown
        for name in tuple(names) or [*items, *(known for known in self._tracks if known not in items)]:
            self._log(name, items.get(name))

    # changes of these names while pages show an earlier step

    def add_named(self, named: list[Any], trees: Mapping[str, Any] | None = None) -> None:
        self._scene.check_units(named)
        items = [make_item(n, self._scene.next_number(), g, style, (trees or {}).get(n)) for n, g, style in named]
        for item in items:
            self._put(item.name, State(item, None, True))

    def update(self, name: str, geometry: object) -> None:
        old = self._find(name)
        item = make_item(name, old.item.number, geometry, old.item.style)
        self._put(name, State(item, old.pose, old.visible))

    def remove(self, name: str) -> None:
        self._find(name)
        self._put(name, None)

    def clear(self) -> None:
        for name in self.names():
            self._put(name, None)

    def set_pose(self, name: str, T: ArrayLike) -> None:
        self._put(name, dataclasses.replace(self._find(name), pose=check_rigid("T", T)))

    def set_visible(self, name: str, visible: bool) -> None:
        self._put(name, dataclasses.replace(self._find(name), visible=bool(visible)))

    def names(self) -> list[str]:
        return [name for name, track in self._tracks.items() if track[-1][1] is not None]

    def newest(self) -> dict[str, Item]:
        """Scene of the newest step, as separate items."""
        states = {name: self._find(name) for name in self.names()}
        return {n: dataclasses.replace(s.item, pose=s.pose, visible=s.visible) for n, s in states.items()}

    def scene_at(self, number: int) -> dict[str, State]:
        scene = {}
        for name, track in self._tracks.items():
            index = bisect.bisect_right(track, number, key=lambda entry: entry[0])
            state = track[index - 1][1] if index else None
            if state is not None:
                scene[name] = state
        return scene

    def look(self, t: float | None) -> None:
        """Show the newest step up to a time in all pages. None follows the newest."""
        self._look(t)
        self._update_control()

    def _look(self, t: float | None) -> None:
        newest = self.dropped + len(self.times) - 1
        number = newest
        if t is not None:
            number = self.dropped + max(bisect.bisect_right(self.times, t) - 1, 0)
        if number != (newest if self._shown is None else self._shown):
            self._show(self.scene_at(number))
        self._shown = None if number == newest else number

    def _show(self, states: dict[str, State]) -> None:
        scene, display = self._scene, self._display
        unfinished = [item for name, item in scene.shown.items() if name in scene.previews]
        with display.batch():
            for name, state in states.items():
                item = state.item
                if scene.shown.get(name) is not item:
                    item.pose, item.visible = state.pose, state.visible
                    continue
                if not _is_same_pose(item.pose, state.pose):
                    display.set_pose(name, np.eye(4) if state.pose is None else state.pose)
                if item.visible != state.visible:
                    display.set_visible(name, state.visible)
            display.show_items({name: state.item for name, state in states.items()}, self._unbuilt)
        self._unbuilt |= {item for item in unfinished if scene.shown.get(item.name) is not item}

    def close(self) -> None:
        self._is_closed = True
        self._tracks, self._arrays, self._unbuilt, self.bytes = {}, {}, set(), 0

    def text_of(self, time: float) -> str:
        return f"{time:.0f}" if self.is_integer else f"{time:.6g} s"

    @property
    def step(self) -> float:
        """Step of the page's timeline: 1, or at most the mean interval between steps."""
        mean = (self.times[-1] - self.times[0]) / max(len(self.times) - 1, 1)
        if self.is_integer and mean < MAX_UNIT_STEP_INTERVAL:
            return 1
        power = 10.0 ** math.floor(math.log10(mean)) if mean > 0 else 1.0
        return next(power * digit for digit in (5, 2, 1) if power * digit <= mean * (1 + 1e-9))

    def _update_control(self) -> None:
        if len(self.times) < 2:
            return
        kind = int if self.is_integer else float
        first, last, value = kind(self.times[0]), kind(self.times[-1]), kind(self.time)
        with self._display.server.pages.atomic():
            if self._control is None:
                self._control = self._display.server.pages.gui.add_timeline(first, last, self.step, value)
                self._control.on_update(self._on_update)
                return
            self._control.min, self._control.max, self._control.step = first, last, self.step
            self._control.value = self._sent_value = value

    def _on_update(self, event: Any) -> None:
        """Handle a drag in a page. Newer page events win over changes by the program meanwhile."""
        if event.client_id is None or not self._scene.take_lock():
            return
        try:
            if not self._is_closed:
                self._look(None if event.value > self.times[-1] - self.step / 2 else event.value + self.step / 1000)
                if self._control.value == self._sent_value:
                    self._control.value = event.value
        finally:
            self._scene.lock.release()

    def _find(self, name: str) -> State:
        track = self._tracks.get(check_name("name", name))
        state = track[-1][1] if track else None
        if state is None:
            known = ", ".join(map(repr, self.names())) or "none"
            raise KeyError(f"name: no geometry {name!r}; there are {known}")
        return state

    def _log(self, name: str, item: Item | None) -> None:
        """Record the current state of a name if it has changed."""
        track = self._tracks.get(name)
        old = track[-1][1] if track else None
        if item is None:
            if old is not None:
                self._put(name, None)
        elif old is None or old.item is not item or old.visible != item.visible or old.pose is not item.pose:
            self._put(name, State(item, item.pose, item.visible))

    def _put(self, name: str, state: State | None) -> None:
        newest = self.dropped + len(self.times) - 1
        track = self._tracks.setdefault(name, [])
        if state is not None:
            self._update_usage(state, 1)
        if track and track[-1][0] == newest:
            old, track[-1] = track[-1][1], (newest, state)
            if old is not None:
                self._update_usage(old, -1)
        else:
            track.append((newest, state))
            self._touched[-1].add(name)
        if self.bytes > self._max_bytes:
            self._drop_oldest()

    def _update_usage(self, state: State, change: int) -> None:
        """Update the memory usage for an added or removed state."""
        self.bytes += change * ENTRY_BYTES
        for address, size in _arrays_of(state.item):
            count = self._arrays.get(address, (0, size))[0]
            if count + change > 0:
                self._arrays[address] = count + change, size
            else:
                self._arrays.pop(address, None)
            if (count == 0) != (count + change == 0):
                self.bytes += change * size

    def _drop_oldest(self) -> None:
        """Drop steps down to 90% of the memory limit, but never the newest and its content."""
        count = 0
        while self.bytes > REMAINING_FRACTION * self._max_bytes and count < len(self.times) - 1:
            count += 1
            start = self.dropped + count
            for name in self._touched[count]:
                self._forget_before(name, start)
        if count == 0:
            return
        if self.dropped == 0:
            log.warning("%s", FULL)
            for client in self._display.server.pages.get_clients().values():
                client.notify("pointloom", FULL)
        self._unbuilt &= {state.item for track in self._tracks.values() for _, state in track if state is not None}
        del self.times[:count], self._touched[:count]
        self.dropped += count
        if self._shown is not None and self._shown < self.dropped:  # the displayed step was dropped
            self._show(self.scene_at(self.dropped))
            self._shown = self.dropped if len(self.times) > 1 else None
        self._update_control()

    def _forget_before(self, name: str, start: int) -> None:
        """Drop states of a name before a step with its own state."""
        track = self._tracks[name]
        while len(track) > 1 and track[1][0] <= start:
            old = track.pop(0)[1]
            if old is not None:
                self._update_usage(old, -1)
        if track[0][1] is None and len(track) == 1:
            del self._tracks[name]


def _is_same_pose(a: Matrix | None, b: Matrix | None) -> bool:
    if a is None or b is None:
        return a is b
    return a is b or np.array_equal(a, b)


def _arrays_of(item: Item) -> Iterator[tuple[int, int]]:
    """Address and size of each array of an item."""
    arrays: list[Any] = [getattr(part, field.name) for part in item.parts for field in dataclasses.fields(part)]
    if item.cloud is not None:
        arrays += [item.cloud.arrays[name] for name in item.cloud.attributes]
    seen = set()
    for array in arrays:
        if isinstance(array, np.ndarray):
            address, size = array.__array_interface__["data"][0], array.nbytes
        elif hasattr(array, "ptr") and hasattr(array, "capacity"):
            address, size = array.ptr, array.capacity
        else:
            continue
        if address and size > MAX_INCLUDED_BYTES and address not in seen:
            seen.add(address)
            yield address, size

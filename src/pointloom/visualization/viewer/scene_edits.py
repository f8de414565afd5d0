"""Changes of a viewer's scene and their history: `SceneEdits`."""

from __future__ import annotations

import contextlib
import functools
import threading
from collections.abc import Callable, Iterator, Mapping
from types import MappingProxyType
from typing import Any, TypeVar, cast

from numpy.typing import ArrayLike

from ...core.checks import check_name, check_number, check_rigid
from ...core.errors import PointloomError
from ..render.geometries import Named, named_geometries
from .items import Item, make_item
from .live_timeline import LiveTimeline
from .scene_display import SceneDisplay

EARLIER = "The timeline shows an earlier time; go to its end to change the scene."
_asker = threading.local()
Change = TypeVar("Change", bound=Callable[..., None])


@contextlib.contextmanager
def requested_by_page() -> Iterator[None]:
    """Context for changes requested by a page, which apply to the displayed step and not to the program's state."""
    before, _asker.is_page = getattr(_asker, "is_page", False), True
    try:
        yield
    finally:
        _asker.is_page = before


def logged(change: Change) -> Change:
    """Decorator: record a change in the step of `set_time`, if that was called.

    While pages show an earlier step, changes of the program go into the history only.
    """
    name = change.__name__

    @functools.wraps(change)
    def run(edits: SceneEdits, *arguments: Any, **keywords: Any) -> None:
        with edits.scene.lock:
            timeline = edits.timeline
            if timeline is None:
                change(edits, *arguments, **keywords)
            elif timeline.is_live:
                change(edits, *arguments, **keywords)
                given = (*arguments, *keywords.values())[:1]
                timeline.take_scene([n for n, *_ in given[0]] if name == "add_named" else given)
            elif not getattr(_asker, "is_page", False):
                edits.scene.check_open()
                getattr(timeline, name)(*arguments, **keywords)
            elif name in ("set_visible", "set_pose"):  # of the displayed step, temporarily
                change(edits, *arguments, **keywords)
            else:
                raise PointloomError(EARLIER)

    return cast(Change, run)


class SceneEdits:
    """Changes of the scene by the program and by tools of the pages. See the methods of `Viewer`.

    Attributes:
        timeline: History since `set_time`. None before.
    """

    def __init__(self, display: SceneDisplay):
        self.display, self.scene = display, display.scene
        self.timeline: LiveTimeline | None = None

    @property
    def items(self) -> Mapping[str, Item]:
        """Items by name. Always the newest state, also if the pages show an earlier time."""
        timeline = self.timeline
        if timeline is None or timeline.is_live:
            return self.scene.shown
        with self.scene.lock:
            return timeline.newest()

    def add(self, name: str, geometry: object, **style: Any) -> None:
        check_name("name", name)
        if style.get("colormap") is not None:
            check_name("colormap", style["colormap"])
        self.add_named(named_geometries([{"geometry": geometry, "name": name, **style}]))

    @logged
    def add_named(self, named: list[Named], trees: Mapping[str, Any] = MappingProxyType({})) -> None:
        scene = self.scene
        with scene.lock, self.display.batch():
            scene.check_open()
            scene.check_units(named)
            items = [
                make_item(name, scene.next_number(), geometry, style, trees.get(name))
                for name, geometry, style in named
            ]
            self.display.add_items(items)

    @logged
    def update(self, name: str, geometry: object) -> None:
        with self.scene.lock:
            self.scene.check_open()
            old = self.scene.find(name)
            item = make_item(name, old.number, geometry, old.style)
            item.visible, item.pose = old.visible, old.pose
            self.display.replace_item(item)

    @logged
    def remove(self, name: str) -> None:
        with self.scene.lock:
            self.scene.check_open()
            self.scene.find(name)
            self.display.remove_items([name])

    @logged
    def clear(self) -> None:
        with self.scene.lock, self.display.batch():
            self.scene.check_open()
            self.display.clear()

    @logged
    def set_pose(self, name: str, T: ArrayLike) -> None:
        with self.scene.lock:
            self.scene.check_open()
            self.scene.find(name)
            self.display.set_pose(name, check_rigid("T", T).copy())  # the caller may change its array later

    @logged
    def set_visible(self, name: str, visible: bool) -> None:
        with self.scene.lock:
            self.scene.check_open()
            self.display.set_visible(name, bool(visible))

    def set_time(self, t: float, history_bytes: float) -> None:
        with self.scene.lock:
            self.scene.check_open()
            timeline = self.timeline or LiveTimeline(self.display, history_bytes)
            timeline.set_time(t)
            self.timeline = timeline

    def show_time(self, t: float | None) -> None:
        with self.scene.lock:
            self.scene.check_open()
            time = None if t is None else check_number("t", t)
            if self.timeline is None:
                raise ValueError(
                    "t: no time step was recorded; call viewer.set_time(t) before the changes of each time step"
                )
            self.timeline.look(time)

    def close(self) -> None:
        """Release the history."""
        timeline, self.timeline = self.timeline, None
        if timeline is not None:
            timeline.close()

"""Decorator for viewer methods in the history of `set_time` (`logged`), and requests by pages (`requested_by_page`)."""

from __future__ import annotations

import contextlib
import functools
import threading
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any, TypeVar, cast

from ...core.errors import PointloomError

if TYPE_CHECKING:
    from .live_timeline import LiveTimeline

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
    def run(viewer: Any, *arguments: Any, **keywords: Any) -> None:
        with viewer.lock:
            timeline: LiveTimeline | None = viewer.timeline
            if timeline is None:
                change(viewer, *arguments, **keywords)
            elif timeline.is_live:
                change(viewer, *arguments, **keywords)
                given = (*arguments, *keywords.values())[:1]
                timeline.take_scene([n for n, *_ in given[0]] if name == "add_named" else given)
            elif not getattr(_asker, "is_page", False):
                viewer._check_open()
                getattr(timeline, name)(*arguments, **keywords)
            elif name in ("set_visible", "set_pose"):  # of the displayed step, temporarily
                change(viewer, *arguments, **keywords)
            else:
                raise PointloomError(EARLIER)

    return cast(Change, run)

"""Calls of the viewer that belong to the moment of `set_time`: `logged`; what pages ask for: `asked_by_page`."""

from __future__ import annotations

import contextlib
import functools
import threading
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any, TypeVar, cast

from ...core.errors import PointloomError

if TYPE_CHECKING:
    from .live_timeline import LiveTimeline

EARLIER = "The time line shows an earlier moment; go to its end to change the scene."
_asker = threading.local()
Change = TypeVar("Change", bound=Callable[..., None])


@contextlib.contextmanager
def asked_by_page() -> Iterator[None]:
    """What is done within is what a page asks for of what it sees, not what the program does."""
    before, _asker.is_page = getattr(_asker, "is_page", False), True
    try:
        yield
    finally:
        _asker.is_page = before


def logged(change: Change) -> Change:
    """Have a call of the viewer belong to the moment of `set_time`; it does as ever where that was never called.

    While the pages look at an earlier moment, the program's changes go into the history alone.
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
            elif name in ("set_visible", "set_pose"):  # of what is looked at, for as long as it is
                change(viewer, *arguments, **keywords)
            else:
                raise PointloomError(EARLIER)

    return cast(Change, run)

"""Progress events of algorithms for observers: `report` in the algorithm, `watch` around the call.

Without observers `report` is almost free; guard expensive data with `watched`. Events pass references, not copies.
"""

from __future__ import annotations

import contextlib
import contextvars
from collections.abc import Callable, Iterator
from typing import Any

from .checks import check_callback

Watcher = Callable[[str, dict[str, Any]], None]

_watchers: contextvars.ContextVar[tuple[Watcher, ...]] = contextvars.ContextVar("watchers", default=())
_standing: contextvars.ContextVar[dict[str, Any] | None] = contextvars.ContextVar("standing", default=None)


@contextlib.contextmanager
def watch(callback: Watcher) -> Iterator[None]:
    """Call `callback(event, data)` for events reported inside the block, in this thread.

    Observers nest, the outermost is called first. An exception in a callback ends the algorithm. Algorithms called by
    it report nothing. `data` is a dict.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.core.observers import watch
        >>> seen = []
        >>> with watch(lambda event, data: seen.append((event, data.get("iteration_index")))):
        ...     cloud = loom.PointCloud([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
        ...     result = loom.registration.registration_icp(cloud, cloud, 0.5)
        >>> seen[0], seen[-1]
        (('icp', 0), ('registration', None))
    """
    token = _watchers.set((*_watchers.get(), check_callback("callback", callback)))
    try:
        yield
    finally:
        _watchers.reset(token)


@contextlib.contextmanager
def standing_for(**data: Any) -> Iterator[None]:
    """Override data of events inside the block, such as clouds before downsampling. The outer block wins."""
    token = _standing.set(data | (_standing.get() or {}))
    try:
        yield
    finally:
        _standing.reset(token)


@contextlib.contextmanager
def unwatched() -> Iterator[None]:
    """Report nothing inside the block: for algorithms inside others."""
    token = _watchers.set(())
    try:
        yield
    finally:
        _watchers.reset(token)


def watched() -> bool:
    """True if there are observers: guards data computed only for events."""
    return bool(_watchers.get())


def report(event: str, **data: Any) -> None:
    watchers = _watchers.get()
    if not watchers:
        return
    event_data = data | (_standing.get() or {})
    with unwatched():  # an observer may call algorithms itself
        for watcher in watchers:
            watcher(event, event_data)

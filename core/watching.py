"""What algorithms tell while they run, for those who watch: `report` in the algorithm, `watch` around the call.

Nobody watches as a rule: then `report` is a look at an empty tuple, and what would cost more stands behind `watched`.
Events carry references, never copies: who wants to keep something that may change takes its own copy.
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
    """Call `callback(event, data)` for what algorithms report inside the block, in this thread alone.

    Watchers nest: all are told, the outermost first. What one raises ends the algorithm with that error. What it calls
    itself is not reported.

    Args:
        callback: Takes the event's name and a dict of what belongs to it.

    Raises:
        TypeError: No function.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.core.watching import watch
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
    """Have what is reported inside the block carry this data, in place of its own of the same names.

    ICP of thinned clouds so reports the clouds that they were made of. Of blocks in blocks the outer one counts.
    """
    token = _standing.set(data | (_standing.get() or {}))
    try:
        yield
    finally:
        _standing.reset(token)


@contextlib.contextmanager
def unwatched() -> Iterator[None]:
    """Report nothing inside the block: for algorithms inside others, whose steps nobody asked for."""
    token = _watchers.set(())
    try:
        yield
    finally:
        _watchers.reset(token)


def watched() -> bool:
    """Whether anybody watches: guards what is only computed to be reported."""
    return bool(_watchers.get())


def report(event: str, **data: Any) -> None:
    """Tell all watchers of an event; nothing where there are none."""
    watchers = _watchers.get()
    if not watchers:
        return
    told = data | (_standing.get() or {})
    with unwatched():  # a watcher may call algorithms itself
        for watcher in watchers:
            watcher(event, told)

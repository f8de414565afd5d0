"""The viewers that a notebook's cells opened: `make_room`, `keep`.

A cell that runs again closes what it opened the last time, and of all cells the latest 16 viewers stay open, so that
neither ports nor memory run out in a kernel that lives for days. Viewers are held weakly here.
"""

from __future__ import annotations

import threading
import weakref
from typing import TYPE_CHECKING, Any, NamedTuple

from ..notebook_output import ipython_shell

if TYPE_CHECKING:
    from .viewer import Viewer

MOST_OPEN = 16  # viewers of a kernel's cells: fewer than the ports that are tried


class _Run(NamedTuple):
    """A cell, and which of its runs."""

    cell: str
    number: str


_opened: list[tuple[_Run, weakref.ref[Viewer]]] = []  # the earliest first
_lock = threading.Lock()


def make_room() -> None:
    """Close what earlier runs of this cell opened, and the earliest of all where 16 are open."""
    run = _this_run()
    with _lock:
        alive = [(by, viewer) for by, ref in _opened if (viewer := ref()) is not None and not viewer.closed]
        again = [viewer for by, viewer in alive if run is not None and by.cell == run.cell and by.number != run.number]
        others = [(by, viewer) for by, viewer in alive if viewer not in again]
        surplus = others[: max(0, len(others) - MOST_OPEN + 1)]
        _opened[:] = [(by, weakref.ref(viewer)) for by, viewer in others[len(surplus) :]]
    for viewer in again:
        viewer.close()
    for _, viewer in surplus:
        viewer._close(f"{MOST_OPEN} viewers of this notebook stay open, and this was the oldest: run its cell again.")


def keep(viewer: Viewer) -> None:
    """Count a viewer as opened by the cell that runs."""
    with _lock:
        _opened.append((_this_run() or _Run("", ""), weakref.ref(viewer)))


def _this_run() -> _Run | None:
    """The cell that runs, by the name that the notebook gives it, else by its text; None where there is none.

    JupyterLab and VS Code tell the name of a cell with each request; where it is missing, cells of the same text count
    as one.
    """
    get_parent = getattr(ipython_shell(), "get_parent", None)
    if get_parent is None:
        return None
    request: Any = get_parent()
    try:
        named = request["metadata"].get("cellId") or request["metadata"].get("cell_id")
        return _Run(str(named or request["content"]["code"]), str(request["header"]["msg_id"]))
    except (AttributeError, KeyError, TypeError):  # another protocol's request
        return None

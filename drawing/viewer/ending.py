"""The end of the program: pages are told of it, and how to start it again: `farewell`, `close_at_exit`."""

from __future__ import annotations

import atexit
import contextlib
import shlex
import sys
import weakref
from pathlib import Path
from typing import TYPE_CHECKING

from ..notebook_output import in_notebook

if TYPE_CHECKING:
    from .viewer import Viewer

_open: weakref.WeakSet[Viewer] = weakref.WeakSet()


def close_at_exit(viewer: Viewer) -> None:
    """Close a viewer at the end of the process, where nobody has done so before."""
    _open.add(viewer)


@atexit.register
def _close_all() -> None:
    for viewer in list(_open):
        if not viewer.server.closed:  # as a forked child's copy is, which has no page
            with contextlib.suppress(Exception):  # the interpreter is going
                viewer.close()


def farewell() -> str:
    """That the program has ended, and how to start it again."""
    if in_notebook():
        again = "Run the cell again to see it again."
    else:
        command = _command(sys.argv)
        again = f"To start it again:\n{command}" if command else "The program can open another viewer."
    return f"The viewer has been closed. {again}"


def _command(arguments: list[str]) -> str:
    """The command line that this program was started by; "" where there was none, as in an interpreter."""
    name = Path(arguments[0]).name if arguments else ""
    if name in ("", "-", "-c", "-m"):
        return ""
    if name in ("pointloom", "pointloom.exe") or (name == "__main__.py" and "pointloom" in arguments[0]):
        return shlex.join(["pointloom", *arguments[1:]])
    return f"python {shlex.quote(name)}"

"""Notice in the pages of a viewer that was closed: `shutdown_notice`."""

from __future__ import annotations

import shlex
import sys
from pathlib import Path

from ..notebook_output import in_notebook


def shutdown_notice() -> str:
    """Shutdown notice: the program has ended, and how to restart it."""
    if in_notebook():
        again = "Run the cell again to see it again."
    else:
        command = _command(sys.argv)
        again = f"To start it again:\n{command}" if command else "The program can open another viewer."
    return f"The viewer has been closed. {again}"


def _command(arguments: list[str]) -> str:
    """Command line of this program; "" if unknown, as in an interpreter."""
    name = Path(arguments[0]).name if arguments else ""
    if name in ("", "-", "-c", "-m"):
        return ""
    if name in ("pointloom", "pointloom.exe") or (name == "__main__.py" and "pointloom" in arguments[0]):
        return shlex.join(["pointloom", *arguments[1:]])
    return f"python {shlex.quote(name)}"

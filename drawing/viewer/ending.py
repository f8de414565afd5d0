"""What pages are told when the program ends: `farewell`."""

from __future__ import annotations

import shlex
import sys
from pathlib import Path

from ..notebook_output import in_notebook


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

"""The command `pointloom`, which `python -m pointloom` is too."""

import os
import signal
from types import FrameType

INTERRUPTED = 130


def _leave(number: int, frame: FrameType | None) -> None:
    """End at once: nothing has begun yet that had to be tidied up, and a traceback of imports says nothing."""
    os.write(2, b"interrupted\n")
    os._exit(INTERRUPTED)


def main() -> None:
    """Run the command; Ctrl-C while it is loaded is one line and exit code 130 too."""
    if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
        signal.signal(signal.SIGINT, _leave)
    from .app.shell.cli import main as run  # what loads click and the commands

    run()


if __name__ == "__main__":
    main()

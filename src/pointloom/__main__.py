"""The command `pointloom`, also `python -m pointloom`."""

import os
import signal
import sys
from types import FrameType

INTERRUPTED = 130


def _leave(number: int, frame: FrameType | None) -> None:
    """Exit immediately: nothing needs cleanup yet, and a traceback of imports is not helpful."""
    os.write(2, b"interrupted\n")
    os._exit(INTERRUPTED)


vars(_leave)["ends_process"] = True  # imports do not defer it


def main() -> None:
    """Run the command. Ctrl-C during loading also gives one line and exit code 130."""
    if signal.getsignal(signal.SIGINT) is signal.default_int_handler:
        signal.signal(signal.SIGINT, _leave)
    from .kernels.language.environment import VERBOSITY, setting

    try:
        setting(VERBOSITY)  # the first import of the commands reads it
    except ValueError as error:
        sys.exit(f"error: {error}")
    from .cli.shell.cli import main as run  # loads click and the commands

    run()


if __name__ == "__main__":
    main()

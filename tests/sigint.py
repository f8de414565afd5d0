"""Tests of Ctrl-C that also work where the tests themselves run in the background."""

import signal
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def sigint_enabled() -> Iterator[None]:
    """Handle SIGINT in this process, and in the processes that are started inside the `with` block.

    A shell sets SIGINT to ignored for its background jobs. Child processes inherit that, and Python then raises no
    KeyboardInterrupt. A handler of the parent process becomes the default action in the program that a child executes.
    """
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)

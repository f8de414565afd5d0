"""Changes of arrays in place that are made whole or not at all, whatever interrupts the program.

Ctrl-C, or memory that runs out, ends Python code before or after a launch, never within one. So whoever keeps arrays
that change lets one launch alone write to what counts, and has that launch note the number of its change: after an
interruption the note tells whether the change was made. Everything else (rows beyond those that count, tables that can
be made again) may be left as it is.
"""

from collections.abc import Callable
from typing import Any

from ..array_types import Device
from ..lang import array, func, int64, struct
from ..memory import download, zeros


@struct
class Changes:
    """What holds of arrays that change in place, and how many changes made it so.

    Attributes:
        latest: int64 [1], the number of the last change that a launch made.
        number: That of the change in progress.
        count: Changes made.
        value: What the owner knows of its arrays since the last of them: the number of rows that count.
    """

    latest: array(dtype=int64)
    number: int64

    def __init__(self, value: Any, device: Device) -> None:
        self.latest = zeros(1, int64, device)
        self._made: tuple[int, Any] = (0, value)
        self._begun: tuple[int, Any] | None = None
        self.number = 0

    @property
    def count(self) -> int:
        """Changes made."""
        return self._made[0]

    @property
    def value(self) -> Any:
        """What the owner knows of its arrays since the last change."""
        return self._made[1]

    def begin(self, value: Any) -> None:
        """Announce a change, after which `value` will hold, before the first array is touched."""
        self.number = self.count + 1
        self._begun = (self.number, value)

    def end(self) -> None:
        """Take note that the launch of the change was made."""
        self._made, self._begun = self._begun or self._made, None

    def settle(self, clear: Callable[[], None]) -> None:
        """Bring a change that was interrupted to its end where its launch was made (sync), else forget it.

        Args:
            clear: Clears away what a change that was not made left behind.
        """
        if self._begun is None:
            return
        if int(download(self.latest)[0]) == self.number:
            self.end()
            return
        clear()
        self._begun = None


@func
def note_change(thread: int, changes: Changes):
    """The first thread of the launch that makes a change notes its number."""
    if thread == 0:
        changes.latest[0] = changes.number

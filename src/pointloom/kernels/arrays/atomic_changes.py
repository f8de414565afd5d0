"""Atomic in-place changes of arrays under interruption (Ctrl-C, out of memory).

Interrupts occur before or after a launch. One launch writes all that counts and records the change number, so it can be
determined afterward whether the change was made. Everything else may stay inconsistent.
"""

from collections.abc import Callable
from typing import Any

from ..array_types import Device
from ..lang import array, func, int64, struct
from ..memory import download, zeros


@struct
class Changes:
    """Transaction state: `latest` change made, `number` in progress, `count` made; `value`: the owner's state."""

    latest: array(dtype=int64)
    number: int64

    def __init__(self, value: Any, device: Device) -> None:
        self.latest = zeros(1, int64, device)
        self._current: tuple[int, Any] = (0, value)
        self._begun: tuple[int, Any] | None = None
        self.number = 0

    @property
    def count(self) -> int:
        return self._current[0]

    @property
    def value(self) -> Any:
        return self._current[1]

    def begin(self, value: Any, steps: int = 1) -> None:
        """Start a change that ends in state `value`, before the first array is touched. It counts as `steps` changes,
        made together."""
        self.number = self.count + steps
        self._begun = (self.number, value)

    def end(self) -> None:
        """Confirm that the launch of the change was made."""
        self._current, self._begun = self._begun or self._current, None

    def recover(self, clear: Callable[[], None]) -> None:
        """Complete an interrupted change if its launch was made (sync), else discard it with `clear`."""
        if self._begun is None:
            return
        if int(download(self.latest)[0]) == self.number:
            self.end()
            return
        clear()
        self._begun = None


@func
def note_change(thread: int, changes: Changes):
    """The first thread of the changing launch records the change number."""
    if thread == 0:
        changes.latest[0] = changes.number

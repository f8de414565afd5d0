"""Rows processed in rounds until none is open. CUDA runs increasing numbers of rounds between syncs."""

from collections.abc import Callable

from ..array_types import Device, Indices, Mask
from ..lang import uint8
from ..memory import empty
from .select import gather_rows, positions_of
from .sort import positions

MAX_ROUNDS = 64
CHECKED_ROUNDS = (4, 16, MAX_ROUNDS)  # rounds between checks on CUDA


def resolve_in_rounds(attempt: Callable[[Indices, Mask], None], count: int, device: Device) -> Indices:
    """Rows that MAX_ROUNDS rounds leave open, ascending; `attempt(rows, open)` writes 1 for rows still open."""
    rows, open_rows = positions(count, device), empty(count, uint8, device)
    for iteration in range(1, MAX_ROUNDS + 1):
        attempt(rows, open_rows)
        if not device.is_cuda or iteration in CHECKED_ROUNDS:
            rows = gather_rows(rows, positions_of(open_rows))  # sync
            if not rows.size:
                break
            open_rows = empty(rows.size, uint8, device)
    return rows

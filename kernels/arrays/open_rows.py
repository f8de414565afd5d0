"""Rows processed in rounds until none is open. CUDA runs increasing numbers of rounds between syncs."""

from collections.abc import Callable

from ..array_types import Device, Indices, Mask
from ..lang import uint8
from ..memory import empty
from .select import gather_rows, positions_of
from .sort import positions

ROUNDS = 64
LOOKS = (4, 16, ROUNDS)  # rounds between checks on CUDA


def settle_in_rounds(attempt: Callable[[Indices, Mask], None], count: int, device: Device) -> Indices:
    """Rows that ROUNDS rounds leave open, ascending; `attempt(rows, open)` writes 1 for rows still open."""
    rows, open_rows = positions(count, device), empty(count, uint8, device)
    for turn in range(1, ROUNDS + 1):
        attempt(rows, open_rows)
        if not device.is_cuda or turn in LOOKS:
            rows = gather_rows(rows, positions_of(open_rows))  # sync
            if not rows.size:
                break
            open_rows = empty(rows.size, uint8, device)
    return rows

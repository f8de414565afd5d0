"""Rows that are settled in rounds, each where its turn has come, until none is open.

On the CPU those that are open are listed after every round. On CUDA the rounds between two looks are ever more: what a
round finds settled costs it less than the host's wait for their number.
"""

from collections.abc import Callable

from ..array_types import Device, Indices, Mask
from ..lang import uint8
from ..memory import empty
from .select import gather_rows, positions_of
from .sort import positions

ROUNDS = 64
LOOKS = (4, 16, ROUNDS)  # after so many rounds, on CUDA


def settle_in_rounds(attempt: Callable[[Indices, Mask], None], count: int, device: Device) -> Indices:
    """Those of `count` rows that ROUNDS rounds leave open, int32, ascending; one sync at each look.

    Args:
        attempt: Tries to settle rows, int32 [n], and writes uint8 [n], 1 where one stays open. Settled ones may
            be tried again.
        count: Rows.
        device: Where they are.
    """
    rows, open_rows = positions(count, device), empty(count, uint8, device)
    for turn in range(1, ROUNDS + 1):
        attempt(rows, open_rows)
        if not device.is_cuda or turn in LOOKS:
            rows = gather_rows(rows, positions_of(open_rows))  # sync
            if not rows.size:
                break
            open_rows = empty(rows.size, uint8, device)
    return rows

"""The record of a public operation. A new operation needs one, and no other entry in a list of operations.

Records are in operations_on_clouds.py (operations on a cloud) and operations_on_scenes.py (all others). digests.py, the
host work and the tests of all operations read them; tests/test_operations.py lists what is derived from a record.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Operation:
    """A call of a public operation.

    Attributes:
        call: Scene -> result. The scene is a `SampledSurface` or `Scenes` of digest_scenes.py. Lengths are multiples of
            the scene's `spacing`, so that the call is valid for any density of points.
        offset_tolerance: Maximum change of the result of a cloud at another position, in the units of the result. None
            if the result depends on the position.
        neighbor_tolerance: Maximum change of the result of the other elements if one has a number that is not finite.
        counts_host_work: Its launches, waits, allocations and bytes have limits in tests/emulated_cuda/host_calls.json.
    """

    call: Callable[[Any], Any]
    offset_tolerance: float | None = 1e-6
    neighbor_tolerance: float = 1e-6
    counts_host_work: bool = False

    def __call__(self, scene: Any) -> Any:
        """The result on a scene."""
        return self.call(scene)


def records(calls: Mapping[str, Callable[[Any], Any]]) -> dict[str, Operation]:
    """Records by name. A plain call has the default claims."""
    return {name: call if isinstance(call, Operation) else Operation(call) for name, call in calls.items()}

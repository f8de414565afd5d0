"""Speed targets of all benchmarks, and reasons where they are not reached: from the operations of bench_*.py."""

from __future__ import annotations

from contest import operations

_OPERATIONS = [operation for _, operation in operations().values()]

# (operation, size): the best baseline's time on the CPU in one run is at least this factor times pointloom's
TARGETS: dict[tuple[str, str], float] = {
    (operation.name, size): factor for operation in _OPERATIONS for size, factor in operation.targets.items()
}
# (operation, size): why its target is not reached, or why the baseline is faster; docs/measured.md lists these
REASONS: dict[tuple[str, str], str] = {
    (operation.name, size): reason for operation in _OPERATIONS for size, reason in operation.reasons.items()
}

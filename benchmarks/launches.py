"""Profile of pointloom's kernels: time by kernel name.

    python benchmarks/launches.py OPERATION SIZE [DEVICE]

Wraps `launch` and `reduce` of the kernel language in all modules that import them, and synchronizes the GPU after each
kernel, so GPU times are longer in total. The rest of the call is host work: NumPy, Warp's sorts and scans, transfers,
Python.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any

from contest import limit_threads, operations


@dataclass
class LaunchTimes:
    """Seconds and launches by kernel name."""

    seconds: dict[str, float] = field(default_factory=dict)
    counts: dict[str, int] = field(default_factory=dict)
    total: float = 0.0  # [s] of the calls, including kernels

    def add(self, name: str, seconds: float) -> None:
        """Count one launch."""
        self.seconds[name] = self.seconds.get(name, 0.0) + seconds
        self.counts[name] = self.counts.get(name, 0) + 1

    def table(self, title: str, calls: int) -> str:
        """The kernels of one call, slowest first."""
        rows = sorted(self.seconds.items(), key=lambda row: -row[1])
        lines = [f"{title}: {1000 * self.total / calls:.2f} ms a call"]
        for name, seconds in [*rows, ("(host, sorts, transfers)", self.total - sum(self.seconds.values()))]:
            launches = f"{self.counts[name] / calls:8.1f} launches" if name in self.counts else " " * 17
            fraction = seconds / self.total if self.total else 0.0
            lines.append(f"  {name:44} {launches} {1000 * seconds / calls:10.3f} ms {fraction:6.1%}")
        return "\n".join(lines)


@contextmanager
def timed_launches(device: str) -> Iterator[LaunchTimes]:
    """Time each launch inside the block."""
    import warp as wp

    from pointloom.kernels import lang

    times = LaunchTimes()

    def timed(call: Callable[..., Any]) -> Callable[..., Any]:
        def run(kernel: Any, count: int, arguments: Any, **options: Any) -> Any:
            begin = time.perf_counter()
            result = call(kernel, count, arguments, **options)
            if device.startswith("cuda"):
                wp.synchronize_device(device)
            times.add(kernel.name, time.perf_counter() - begin)
            return result

        return run

    originals = (lang.launch, lang.reduce)
    wrapped = [timed(call) for call in originals]
    targets = [
        (module, name, original, replacement)
        for key, module in list(sys.modules.items())
        if key.startswith("pointloom.")
        for original, replacement in zip(originals, wrapped, strict=True)
        for name, value in list(vars(module).items())
        if value is original
    ]
    for module, name, _, replacement in targets:
        setattr(module, name, replacement)
    try:
        yield times
    finally:
        for module, name, original, _ in targets:
            setattr(module, name, original)


def profile(operation_name: str, size: str, device: str, seconds: float = 1.0) -> str:
    """The table of one operation at one size: the mean of as many calls as fit, at least one."""
    _, operation = operations()[operation_name]
    scene = {**operation.quick, **operation.scenes}[size]()
    trial = operation.contestants[0].trial(scene, device)
    trial.once()  # compiles, and imports all modules whose launches are wrapped
    calls = 0
    with timed_launches(device) as times:
        while calls == 0 or (times.total < seconds and calls < 10):
            arguments = trial.arguments()
            begin = time.perf_counter()
            trial.call(*arguments)
            times.total += time.perf_counter() - begin
            calls += 1
    return times.table(f"{operation_name} {size} on {device}", calls)


if __name__ == "__main__":
    name, size, device = [*sys.argv[1:], "cpu"][:3]
    limit_threads(device)
    print(profile(name, size, device))

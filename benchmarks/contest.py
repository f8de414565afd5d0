"""Benchmark definitions: operations, sizes, and contestants that do the same work on the same data.

Used by the timing with pytest (conftest.py), the peak memory (memory.py) and the profile (launches.py).
"""

from __future__ import annotations

import importlib
import importlib.metadata
import os
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

POINTLOOM = "pointloom"
PACKAGES = (
    "pointloom", "numpy", "warp-lang", "open3d", "small_gicp", "pykdtree", "scipy", "scikit-image", "vtk",
    "PyMCubes", "scikit-learn", "kiss-matcher", "kiss-icp", "opencv-python-headless",
    "embreex", "fast-simplification", "pyfqmr", "meshoptimizer", "fpsample", "genz-icp", "rko-lio", "numba",
    "quadrants", "py4dgeo", "pyransac3d", "pycpd", "torch", "torch-cluster", "pytorch3d",
)  # fmt: skip


@dataclass(frozen=True)
class Trial:
    """One contestant's work on one scene, with the data on its device.

    Attributes:
        call: The timed call; gets the result of `setup`, if any.
        setup: Called before each call, outside the timed region.
    """

    call: Callable[..., Any]
    setup: Callable[[], Any] | None = None

    def once(self) -> Any:
        """Run the call once, including the set-up."""
        return self.call(*self.arguments())

    def arguments(self) -> tuple[Any, ...]:
        """The arguments of the next call."""
        return () if self.setup is None else (self.setup(),)


@dataclass(frozen=True)
class Contestant:
    """A library that performs an operation.

    Attributes:
        name: Name in the table.
        prepare: (scene, device) -> the Trial, or a plain call; loads the library and transfers the data.
        facts: Converts a result to the compared values (NumPy arrays or numbers); not timed.
        devices: Supported device kinds, of "cpu" and "cuda".
    """

    name: str
    prepare: Callable[[Any, str], Trial | Callable[[], Any]]
    facts: Callable[[Any], Any]
    devices: tuple[str, ...] = ("cpu",)

    def trial(self, scene: Any, device: str) -> Trial:
        """The work on a scene."""
        prepared = self.prepare(scene, device)
        return prepared if isinstance(prepared, Trial) else Trial(prepared)


@dataclass(frozen=True)
class Operation:
    """A compared operation.

    Attributes:
        name: Name in the table.
        scenes: Functions that create the data, by size.
        quick: The same for a quick run, with small data.
        contestants: pointloom is the first.
        check: (actual, reference, name of the baseline): raises AssertionError if the results disagree.
        unit_count: Scene -> number of units per call; times are given per unit.
        memory_size: The size for the peak memory; None for the last one.
        long: Sizes that only `--long` measures.
        targets: By size, the factor of the best baseline's time on the CPU to pointloom's that is required.
        reasons: By size, why the target is not reached, or why the baseline is faster. docs/measured.md lists these.
        slow: Baselines by size that the CPU measures with `--long` only: calls of 10 s, twice those of another one.
    """

    name: str
    scenes: Mapping[str, Callable[[], Any]]
    quick: Mapping[str, Callable[[], Any]]
    contestants: tuple[Contestant, ...]
    check: Callable[[Any, Any, str], None]
    unit_count: Callable[[Any], int] = field(default=lambda scene: 1)
    memory_size: str | None = None
    long: tuple[str, ...] = ()
    targets: Mapping[str, float] = field(default_factory=dict)
    reasons: Mapping[str, str] = field(default_factory=dict)
    slow: Mapping[str, tuple[str, ...]] = field(default_factory=dict)

    def sizes(self, *, quick: bool = False, long: bool = False) -> Mapping[str, Callable[[], Any]]:
        """The sizes that a run measures."""
        if quick:
            return self.quick
        return {name: make for name, make in self.scenes.items() if long or name not in self.long}

    def contestants_on(self, device: str) -> Iterator[tuple[Contestant, str, str]]:
        """Yield the contestants on a device as (contestant, device of the contestant, label).

        If no baseline runs on the GPU, the CPU baselines are used and labeled "(cpu)".
        """
        kind = "cuda" if device.startswith("cuda") else "cpu"
        own, *peers = self.contestants
        yield own, device, POINTLOOM
        available = [peer for peer in peers if kind in peer.devices]
        for peer in available or peers:
            yield peer, device if available else "cpu", peer.name if available else f"{peer.name} (cpu)"

    def contestant(self, label: str, device: str) -> tuple[Contestant, str]:
        """The contestant with this label, and its device."""
        for contestant, run_device, name in self.contestants_on(device):
            if name == label:
                return contestant, run_device
        raise KeyError(f"{self.name} has no contestant {label!r} on {device}")


def timed(operation: Operation) -> Callable[[Callable], Callable]:
    """Mark a test function as the timing of an operation; conftest.py parametrizes it."""

    def mark(function: Callable) -> Callable:
        function.operation = operation
        return function

    return mark


def bench_modules() -> dict[str, Path]:
    """The benchmark files by module name."""
    return {path.stem: path for path in sorted(Path(__file__).parent.glob("bench_*.py"))}


def operations() -> dict[str, tuple[str, Operation]]:
    """All operations by name, with their modules."""
    by_name: dict[str, tuple[str, Operation]] = {}
    for module in bench_modules():
        for operation in importlib.import_module(module).OPERATIONS:
            by_name[operation.name] = (module, operation)
    return by_name


# ------------------------------------------------------------------------------------------------ fairness


def thread_count() -> int:
    """Threads of every contestant: BENCH_THREADS, or 2."""
    return int(os.environ.get("BENCH_THREADS", "2"))


def limit_threads(device: str) -> None:
    """Bind this process to the same few cores for every contestant. Call it before any library is loaded.

    Also sets the thread count of each library: libraries that start a thread per core of the machine would otherwise
    overload the available cores.
    """
    count = str(thread_count())
    for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "POINTLOOM_CPU_THREADS"):
        os.environ.setdefault(name, count)
    if device == "cpu" and hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, sorted(os.sched_getaffinity(0))[: thread_count()])


def load_open3d() -> Any:
    """Import Open3D with a limited thread count."""
    import open3d as o3d

    o3d.utility.set_max_threads(thread_count())
    return o3d


def open3d_device(device: str) -> Any:
    """Convert a device name to Open3D's device."""
    return load_open3d().core.Device(device.upper() if ":" in device else f"{device.upper()}:0")


def anew(cloud: Any) -> Any:
    """A cloud over the same arrays without the cached search tree, for calls that must build it."""
    return type(cloud).from_device_arrays(dict(cloud.arrays), cloud.origin, cloud.array_library)


def kept_on(cloud: Any, device: str) -> Any:
    """A cloud whose results stay on its GPU, like Open3D's tensors; on the CPU the cloud itself."""
    return cloud.to(device, arrays="warp") if device.startswith("cuda") else cloud


def given_on(array: Any, device: str) -> Any:
    """An input on the contestants' device: a Warp array on a GPU, as Open3D's tensors are uploaded before the call."""
    if not device.startswith("cuda"):
        return array
    import warp as wp

    return wp.array(array, dtype=wp.dtype_from_numpy(array.dtype), device=device)


def on_host(array: Any) -> Any:
    """A result as a NumPy array."""
    return array.numpy() if hasattr(array, "numpy") else array


def waiting(call: Callable[..., Any], device: str, library: str) -> Callable[..., Any]:
    """Wrap a call to synchronize the GPU; on the CPU return the call itself."""
    if not device.startswith("cuda"):
        return call
    wait = _waits(device)[library]

    def call_and_wait(*arguments: Any) -> Any:
        result = call(*arguments)
        wait()
        return result

    return call_and_wait


def _waits(device: str) -> dict[str, Callable[[], None]]:
    import warp as wp

    def wait_open3d() -> None:
        load_open3d().core.cuda.synchronize(open3d_device(device))

    return {"warp": lambda: wp.synchronize_device(device), "open3d": wait_open3d}


def versions() -> dict[str, str]:
    """Versions of the installed libraries."""
    result = {}
    for package in PACKAGES:
        try:
            result[package] = importlib.metadata.version(package)
        except importlib.metadata.PackageNotFoundError:
            continue
    return result

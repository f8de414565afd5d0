"""What a benchmark is: an operation, the sizes that it runs at, and contestants that do the same work on the same data.

The timing of pytest (conftest.py), the peak memory (memory.py) and the profile (launches.py) all run these.
"""

from __future__ import annotations

import importlib
import importlib.metadata
import os
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

OURS = "pointloom"
PACKAGES = (
    "pointloom", "numpy", "warp-lang", "open3d", "small_gicp", "pykdtree", "scipy", "scikit-image", "vtk",
    "PyMCubes", "scikit-learn", "kiss-matcher", "kiss-icp", "opencv-python-headless",
    "embreex", "fast-simplification", "pyfqmr", "meshoptimizer", "fpsample", "genz-icp", "rko-lio", "numba",
    "quadrants", "py4dgeo", "pyransac3d", "pycpd",
)  # fmt: skip


@dataclass(frozen=True)
class Trial:
    """One contestant's work on one scene, with the data where it needs it.

    Attributes:
        call: The timed call; gets what `setup` returned, where there is one.
        setup: Made anew before each call, outside the timed region.
    """

    call: Callable[..., Any]
    setup: Callable[[], Any] | None = None

    def once(self) -> Any:
        """Run it once, set-up included."""
        return self.call(*self.arguments())

    def arguments(self) -> tuple[Any, ...]:
        """What the next call gets."""
        return () if self.setup is None else (self.setup(),)


@dataclass(frozen=True)
class Contestant:
    """A library that does the work of an operation.

    Attributes:
        name: As in the table.
        prepare: (scene, device) -> the Trial, or a plain call; loads the library and moves the data.
        facts: What of its result is compared, as NumPy arrays or numbers; never timed.
        devices: Kinds of device that it runs on, of "cpu" and "cuda".
    """

    name: str
    prepare: Callable[[Any, str], Trial | Callable[[], Any]]
    facts: Callable[[Any], Any]
    devices: tuple[str, ...] = ("cpu",)

    def trial(self, scene: Any, device: str) -> Trial:
        """The work on this scene."""
        made = self.prepare(scene, device)
        return made if isinstance(made, Trial) else Trial(made)


@dataclass(frozen=True)
class Operation:
    """What is compared.

    Attributes:
        name: As in the table and in targets.py.
        scenes: Makers of the data by size.
        quick: The same for a quick run; small.
        contestants: Ours first.
        check: (ours, theirs, name of the peer): raises AssertionError where the two results disagree.
        unit_count: Scene -> how many units a call does; times are given per unit.
        memory_size: The size whose peak memory is measured; None for the last.
    """

    name: str
    scenes: Mapping[str, Callable[[], Any]]
    quick: Mapping[str, Callable[[], Any]]
    contestants: tuple[Contestant, ...]
    check: Callable[[Any, Any, str], None]
    unit_count: Callable[[Any], int] = field(default=lambda scene: 1)
    memory_size: str | None = None

    def places(self, device: str) -> Iterator[tuple[Contestant, str, str]]:
        """The contestants on a device: (contestant, device that it runs on, label).

        Where no peer runs on the GPU, its peers on the CPU stand beside it, and the label says so.
        """
        kind = "cuda" if device.startswith("cuda") else "cpu"
        ours, *peers = self.contestants
        yield ours, device, OURS
        here = [peer for peer in peers if kind in peer.devices]
        for peer in here or peers:
            yield peer, device if here else "cpu", peer.name if here else f"{peer.name} (cpu)"

    def contestant(self, label: str, device: str) -> tuple[Contestant, str]:
        """The contestant with this label, and the device that it runs on."""
        for contestant, place, name in self.places(device):
            if name == label:
                return contestant, place
        raise KeyError(f"{self.name} has no contestant {label!r} on {device}")


def timed(operation: Operation) -> Callable[[Callable], Callable]:
    """Mark a test function as the one that times an operation; conftest.py gives it its turns."""

    def mark(function: Callable) -> Callable:
        function.operation = operation
        return function

    return mark


def bench_modules() -> dict[str, Path]:
    """The files of benchmarks by module name."""
    return {path.stem: path for path in sorted(Path(__file__).parent.glob("bench_*.py"))}


def operations() -> dict[str, tuple[str, Operation]]:
    """All operations by name, with the modules that hold them."""
    found: dict[str, tuple[str, Operation]] = {}
    for module in bench_modules():
        for operation in importlib.import_module(module).OPERATIONS:
            found[operation.name] = (module, operation)
    return found


# ------------------------------------------------------------------------------------------------ fairness


def thread_count() -> int:
    """Threads of every contestant: BENCH_THREADS, or 2."""
    return int(os.environ.get("BENCH_THREADS", "2"))


def limit_threads(device: str) -> None:
    """Give this process, and so every contestant in it, the same few cores. Call it before any library is loaded.

    Thread counts of each library are set too: those that start a thread a core of the machine would otherwise crowd
    the cores that they were given.
    """
    count = str(thread_count())
    for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "POINTLOOM_CPU_THREADS"):
        os.environ.setdefault(name, count)
    if device == "cpu" and hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, sorted(os.sched_getaffinity(0))[: thread_count()])


def load_open3d() -> Any:
    """Open3D, limited to our threads."""
    import open3d as o3d

    o3d.utility.set_max_threads(thread_count())
    return o3d


def open3d_device(device: str) -> Any:
    """Open3D's device for one of our names."""
    return load_open3d().core.Device(device.upper() if ":" in device else f"{device.upper()}:0")


def anew(cloud: Any) -> Any:
    """Our cloud over the same arrays without the search tree that it keeps: for calls that have to build it."""
    return type(cloud)._from_device_arrays(dict(cloud._arrays), cloud.origin)


def waiting(call: Callable[..., Any], device: str, library: str) -> Callable[..., Any]:
    """The call with the wait for the GPU inside it; on the CPU the call itself."""
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
    """Versions of the libraries that are here."""
    found = {}
    for package in PACKAGES:
        try:
            found[package] = importlib.metadata.version(package)
        except importlib.metadata.PackageNotFoundError:
            continue
    return found

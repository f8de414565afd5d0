"""Putting the emulated device between Warp's Python and its native library."""

import atexit
import contextlib
import ctypes
import os
import re
from collections.abc import Callable
from typing import Any

from .allocations import Allocations
from .arrays import Arrays
from .compiler import Compiler
from .driver import Driver, is_driver
from .findings import CudaFault, Findings
from .gcc import EmulationError, check_machine
from .graphs import Graphs
from .kernel_coverage import mark_kernels
from .launches import Launches
from .memory import Memory
from .properties import Properties
from .settings import settings
from .streams import Streams

# What needs a device; NVRTC, and the functions for the host, stay Warp's
_DEVICE_FUNCTION = re.compile(r"wp_(cuda_(?!compile_|toolkit_version|[gs]et_context_restore)|.*_device$|.*_device_)")


class Device:
    """The emulated device: its parts have the functions of warp.so that need CUDA, by their names."""

    def __init__(self, real: ctypes.CDLL):
        self.real = real
        self.findings = Findings()
        self.memory = Memory(settings.memory, uninitialized=settings.uninitialized, races=settings.races)
        self.streams = Streams(self.findings)
        self.graphs = Graphs(self.streams, self.memory, self.findings)
        self.allocations = Allocations(self.streams, self.memory, self.findings, self.graphs)
        self.launches = Launches(self.streams, self.memory, self.findings)
        self.driver = Driver(self.streams, self.memory, self.allocations.pinned)
        self.parts = (
            *(self.findings, self.streams, self.graphs, self.allocations, self.launches),
            Arrays(real, self.streams, self.memory, self.findings),
            Properties(real, self.memory),
            Compiler(real, self.findings),
        )
        if settings.report:
            atexit.register(self.write_report)

    def part(self, name: str) -> Any:
        return next((part for part in self.parts if hasattr(part, name)), None)

    def function(self, name: str) -> Any:
        """The part's function of this name, one call at a time; None where no part has it."""
        part = self.part(name)
        if part is None:
            return None
        function = getattr(part, name)

        def call(*arguments: Any) -> Any:
            with self.streams.lock:
                return function(*arguments)

        call.__name__ = name
        return call

    def synchronize(self) -> None:
        with contextlib.suppress(CudaFault):
            self.streams.wp_cuda_context_synchronize(None)

    def count_requests(self, run: Callable[[], Any]) -> dict[str, int]:
        self.synchronize()
        before = dict(self.findings.counts)
        run()
        self.synchronize()
        counts = {what: count - before[what] for what, count in self.findings.counts.items()}
        counts["waits"] -= 1  # the one above
        return counts

    def write_report(self) -> None:
        self.synchronize()
        memory = self.memory
        sizes = {"peak bytes": memory.peak, "total bytes": memory.total, "live arrays": len(memory.live)}
        self.findings.write_report(settings.report.replace("%p", str(os.getpid())), sizes)


class Core:
    """warp.so with the device's functions in place of its own."""

    def __init__(self, real: ctypes.CDLL, device: Device):
        self.__dict__.update(_real=real, _device=device)

    def __getattr__(self, name: str) -> Any:
        function = self._device.function(name) if name.startswith("wp_") else None
        if function is None:
            function = getattr(self._real, name)
            if _DEVICE_FUNCTION.match(name):
                function = _missing(name)
        self.__dict__[name] = function
        return function


def _missing(name: str) -> Any:
    def call(*_: Any) -> Any:
        raise NotImplementedError(f"the emulated device has no {name}")

    call.__name__ = name
    return call


_device: Device | None = None


def installed() -> Device | None:
    return _device


def install() -> None:
    """Give Warp the emulated device as its only one; before Warp starts."""
    import warp._src.context as context

    check_machine()
    if context.runtime is not None:
        raise EmulationError("the emulated device comes before Warp starts: import none of pointloom's kernels first")
    load = context.Runtime.load_dll

    def load_dll(self: Any, path: str) -> Any:
        global _device
        library = load(self, path)
        if not path.endswith("warp.so"):
            return library
        _device = Device(library)
        return Core(library, _device)

    context.Runtime.load_dll = load_dll
    load_library = ctypes.cdll.LoadLibrary

    def load_driver(name: str) -> Any:
        return installed().driver if installed() and is_driver(name) else load_library(name)

    if settings.coverage:
        mark_kernels()
    ctypes.cdll.LoadLibrary = load_driver  # type: ignore[method-assign]

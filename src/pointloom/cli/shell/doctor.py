"""Check of this machine: versions, cores, devices, threads, and a trial on each device."""

from __future__ import annotations

import ctypes
import importlib.metadata
import os
import platform
import re
import sys
import warnings
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...core.cuda_driver import installed_driver, needed_driver, why_no_gpu
from ...core.devices import resolve_device
from ...core.reports import Fields, Report, failed, quality
from ...core.threads import get_num_threads
from ...core.timing import Clock
from ...core.wording import format_bytes
from ...kernels.arrays.bounds import bound_points
from ...kernels.lang import current_cpu_compiler, vec3
from ...kernels.language import compiled_ahead, cpu_archive, cpu_pool, pool_code, warp_parts
from ...kernels.memory import upload

_PACKAGES = ("numpy", "scipy", "warp-lang", "click", "rich", "Pillow")
# Newest versions that all tests passed with.
_TESTED_VERSIONS = {"numpy": (2, 4), "scipy": (1, 17), "warp-lang": (1, 19)}
_TRIAL_POINTS = 100_000

NO_COMPILER = "none"


@dataclass(frozen=True)
class Machine:
    """The machine; `cores` are those available to this process."""

    system: str
    python: str
    cores: int
    cores_of_machine: int | None
    memory_bytes: int


@dataclass(frozen=True)
class Gpu:
    """A GPU that Warp can use: alias, name, memory [B], and architecture (90 for sm_90)."""

    name: str
    title: str
    memory_bytes: int
    arch: int


@dataclass(frozen=True)
class Cuda:
    """State of CUDA: versions of CUDA and of NVIDIA's driver, `why_none` if no GPU is usable, and the GPUs."""

    driver: str | None
    installed_driver: str | None
    needed_driver: int | None
    why_none: str | None
    devices: list[Gpu]
    compiled_ahead: str


@dataclass(frozen=True)
class Trial:
    """A small kernel on one device, run twice as the first run may compile it. The error, or None."""

    device: str
    seconds: dict[str, float]
    error: str | None

    @property
    def ok(self) -> bool:
        return self.error is None

    def to_dict(self) -> dict[str, Any]:
        report: dict[str, Any] = {"device": self.device, "ok": self.ok, **self.seconds}
        return report if self.ok else {**report, "error": self.error}

    def __str__(self) -> str:
        first, again = self.seconds.get("first_seconds", 0.0), self.seconds.get("again_seconds", 0.0)
        outcome = self.error if self.error is not None else f"{first:.2f} s the first time, {again * 1000:.1f} ms again"
        return f"{self.device}: {outcome}"


@dataclass(frozen=True)
class Diagnosis(Report):
    """State of the machine, with dependency versions (or "missing"), those that are newer than the tested ones, and the
    compiler of CPU kernels (or "none")."""

    versions: dict[str, str]
    untested: list[str]
    machine: Machine
    cuda: Cuda
    cpu_compiler: str
    why: str
    cpu_code: str
    trials: list[Trial]
    warnings: tuple[str, ...]

    def to_dict(self) -> dict[str, Any]:
        return {"command": "doctor", **super().to_dict(), **quality(self)}

    def fields(self) -> Fields:
        machine, cuda = self.machine, self.cuda
        cores = f"{machine.cores} usable of {machine.cores_of_machine}"
        gpus = [f"{gpu.name} {gpu.title}, {format_bytes(gpu.memory_bytes)}, sm_{gpu.arch}" for gpu in cuda.devices]
        return [
            ("versions", ", ".join(f"{name} {version}" for name, version in self.versions.items())),
            *([("untested", f"{', '.join(self.untested)}: newer than the tested versions")] if self.untested else []),
            ("system", f"{machine.system}, Python {machine.python}"),
            ("cores", f"{cores}, {format_bytes(machine.memory_bytes)} of memory"),
            ("GPUs", "\n".join(gpus) or f"none: {cuda.why_none}"),
            ("driver", f"{cuda.installed_driver or 'none'}, needed for GPUs: {cuda.needed_driver or 'not known'}"),
            ("GPU code", cuda.compiled_ahead),
            ("CPU kernels", f"{self.cpu_compiler}: {self.why}"),
            ("CPU code", self.cpu_code),
            ("trials", "\n".join(str(trial) for trial in self.trials)),
            ("state", "healthy" if not self.warnings else "has problems, see below"),
        ]


def diagnose() -> Diagnosis:
    """Check the machine, running a small kernel twice on every device."""
    versions, gpus = _versions(), _gpus()
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", "pointloom uses one CPU core")  # reported by `why`
        trials = [_try(device) for device in ("cpu", *(gpu.name for gpu in gpus))]
        chosen, why = _choose()
    return Diagnosis(
        versions=versions,
        untested=_untested(versions),
        machine=Machine(
            system=platform.platform(),
            python=platform.python_version(),
            cores=cpu_pool.usable_cores(),
            cores_of_machine=os.cpu_count(),
            memory_bytes=_memory_bytes(),
        ),
        cuda=Cuda(
            driver=_cuda_driver(),
            installed_driver=installed_driver(),
            needed_driver=needed_driver(),
            why_none=None if gpus else why_no_gpu(),
            devices=gpus,
            compiled_ahead=compiled_ahead.described(),
        ),
        cpu_compiler=chosen,
        why=why,
        cpu_code=cpu_archive.described(),
        trials=trials,
        warnings=failed(_why_slow(chosen, why, trials), _why_gpu_is_idle(gpus)),
    )


def _try(device: str) -> Trial:
    """Compute bounds twice on one device and compare with NumPy."""
    points = np.random.default_rng(0).random((_TRIAL_POINTS, 3), np.float32)
    clock = Clock()
    try:
        for stage in ("first_seconds", "again_seconds"):
            clock.restart()
            low, high, count = bound_points(upload(points, vec3, resolve_device(device)))
            clock.stop(stage)
        right = count == len(points) and (low == points.min(axis=0)).all() and (high == points.max(axis=0)).all()
        fault = None if right else "ran, but gave a wrong result"
    except Exception as error:  # any failure of this machine is to be reported
        fault = str(error) or type(error).__name__
    return Trial(device, clock.seconds, fault)


def _choose() -> tuple[str, str]:
    """The compiler of CPU kernels, and the number of threads or the reason."""
    try:
        chosen = current_cpu_compiler()
        if chosen == "warp":
            return chosen, _threads()
        return chosen, f"POINTLOOM_CPU={chosen} is set"
    except (RuntimeError, ValueError) as error:
        return NO_COMPILER, str(error)


def _threads() -> str:
    count = get_num_threads()
    if reason := _why_one_core():
        return reason
    threads = f"{count} thread" if count == 1 else f"{count} threads"
    if os.environ.get(cpu_pool.THREADS):
        return f"{threads} ({cpu_pool.THREADS})"
    if sys.platform != "linux":
        return f"{threads}, since more are not tested on this system; set {cpu_pool.THREADS} to use more"
    return threads


def _why_one_core() -> str | None:
    """Reason why this Warp uses one core and slower code, or None."""
    if pool_code.is_usable():
        return None
    version = importlib.metadata.version("warp-lang")
    remedy = f"install the tested version: pip install warp-lang=={warp_parts.TESTED[-1]}"
    return f"one core only, since Warp {version} does not support cpu_access.h; {remedy}"


def _why_slow(chosen: str, why: str, trials: list[Trial]) -> str | None:
    if chosen == NO_COMPILER:
        return f"CPU kernels do not run: {why}"
    slow = _why_one_core() if chosen == "warp" else None
    return "; ".join(failed(slow, *(f"{trial.device}: {trial.error}" for trial in trials if not trial.ok))) or None


def _why_gpu_is_idle(gpus: list[Gpu]) -> str | None:
    """Reason why no GPU is usable in spite of a driver."""
    return None if gpus or installed_driver() is None else f"no GPU is usable: {why_no_gpu()}"


def _versions() -> dict[str, str]:
    from ... import __version__  # pyright: ignore[reportMissingImports]

    versions = {"pointloom": __version__}
    for package in _PACKAGES:
        try:
            versions[package] = importlib.metadata.version(package)
        except importlib.metadata.PackageNotFoundError:
            versions[package] = "missing"
    return versions


def _untested(versions: dict[str, str]) -> list[str]:
    """Packages newer than the tested minor versions, with their versions."""
    return [
        f"{name} {versions[name]}"
        for name, newest in _TESTED_VERSIONS.items()
        if tuple(int(part) for part in re.findall(r"\d+", versions[name])[:2]) > newest
    ]


def _memory_bytes() -> int:
    if sys.platform == "win32":
        status = (ctypes.c_uint64 * 8)(64)  # MEMORYSTATUSEX: its size, the memory, other fields
        ctypes.WinDLL("kernel32").GlobalMemoryStatusEx(ctypes.byref(status))  # type: ignore[attr-defined]
        return status[1]
    return os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")


def _cuda_driver() -> str | None:
    import warp as wp

    version = wp.get_cuda_driver_version() if wp.get_cuda_device_count() else None
    return ".".join(map(str, version)) if version else None


def _gpus() -> list[Gpu]:
    import warp as wp

    return [Gpu(gpu.alias, gpu.name, int(gpu.total_memory), int(gpu.arch)) for gpu in wp.get_cuda_devices()]

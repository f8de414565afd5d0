"""Whether pointloom is well on this machine: versions, cores, devices, and a trial of each compiler."""

from __future__ import annotations

import importlib.metadata
import os
import platform
import warnings
from typing import Any

import numpy as np

from ...core.cuda_driver import installed_driver, needed_driver, why_no_gpu
from ...core.devices import resolve_device
from ...core.timing import Clock
from ...core.wording import format_bytes
from ...kernels.arrays.bounds import bound_points
from ...kernels.lang import cpu_compiler, current_cpu_compiler, vec3
from ...kernels.language import compiled_ahead
from ...kernels.memory import upload

_PACKAGES = ("numpy", "scipy", "warp-lang", "taichi", "click", "rich", "Pillow")
_TRIAL_POINTS = 100_000

NO_COMPILER = "none"


def diagnose() -> dict[str, Any]:
    """Look at the machine, in JSON's types; "poor" says why CPU kernels fall back to one core or fail, or why no GPU
    serves though there is a driver for one, or is None.

    Notes:
        Every compiler runs a small kernel on every device that it serves, twice: the first run may compile it.
    """
    trials = [_try("taichi", "cpu"), _try("warp", "cpu")]
    gpus = _gpus()
    trials += [_try("warp", gpu["name"]) for gpu in gpus]
    chosen, why = _choose(trials[0])
    return {
        "command": "doctor",
        "versions": _versions(),
        "machine": {
            "system": platform.platform(),
            "python": platform.python_version(),
            "cores": _usable_cores(),
            "cores_of_machine": os.cpu_count(),
            "memory_bytes": _memory_bytes(),
        },
        "cuda": {
            "driver": _cuda_driver(),
            "installed_driver": installed_driver(),
            "needed_driver": needed_driver(),
            "why_none": None if gpus else why_no_gpu(),
            "devices": gpus,
            "compiled_ahead": compiled_ahead.described(),
        },
        "cpu_compiler": chosen,
        "why": why,
        "trials": trials,
        "poor": "; ".join(filter(None, [_why_poor(chosen, why, trials), _why_gpu_is_idle(gpus)])) or None,
    }


def doctor_fields(report: dict[str, Any]) -> list[tuple[str, str]]:
    """The diagnosis as labels and values for the terminal."""
    machine, cuda = report["machine"], report["cuda"]
    cores = f"{machine['cores']} usable of {machine['cores_of_machine']}"
    gpus = [
        f"{gpu['name']} {gpu['title']}, {format_bytes(gpu['memory_bytes'])}, sm_{gpu['arch']}"
        for gpu in cuda["devices"]
    ]
    trials = [f"{trial['compiler']} on {trial['device']}: {_outcome(trial)}" for trial in report["trials"]]
    return [
        ("versions", ", ".join(f"{name} {version}" for name, version in report["versions"].items())),
        ("system", f"{machine['system']}, Python {machine['python']}"),
        ("cores", f"{cores}, {format_bytes(machine['memory_bytes'])} of memory"),
        ("GPUs", "\n".join(gpus) or f"none: {cuda['why_none']}"),
        ("driver", f"{cuda['installed_driver'] or 'none'}, needed for GPUs: {cuda['needed_driver'] or 'not known'}"),
        ("GPU code", cuda["compiled_ahead"]),
        ("CPU kernels", f"{report['cpu_compiler']}: {report['why']}"),
        ("trials", "\n".join(trials)),
        ("state", "falls short, see below" if report["poor"] else "healthy"),
    ]


def _outcome(trial: dict[str, Any]) -> str:
    if not trial["ok"]:
        return trial["error"]
    return f"{trial['first_seconds']:.2f} s the first time, {trial['again_seconds'] * 1000:.1f} ms again"


def _try(compiler: str, device: str) -> dict[str, Any]:
    """Bound a cloud twice by one compiler on one device, and hold the answer against NumPy's."""
    points = np.random.default_rng(0).random((_TRIAL_POINTS, 3), np.float32)
    trial: dict[str, Any] = {"compiler": compiler, "device": device, "ok": False}
    clock = Clock()
    try:
        with cpu_compiler(compiler):
            for stage in ("first_seconds", "again_seconds"):
                clock.restart()
                low, high, count = bound_points(upload(points, vec3, resolve_device(device)))
                clock.stop(stage)
        right = count == len(points) and (low == points.min(axis=0)).all() and (high == points.max(axis=0)).all()
        return trial | clock.seconds | ({"ok": True} if right else {"error": "ran, but gave a wrong result"})
    except Exception as error:  # whatever is broken on this machine is what the user wants to read
        return trial | clock.seconds | {"error": str(error) or type(error).__name__}


def _choose(taichi_trial: dict[str, Any]) -> tuple[str, str]:
    """The compiler that CPU kernels go through, and why."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # the fallback's warning; its reason is shown here
        try:
            chosen = current_cpu_compiler()
        except RuntimeError as error:
            return NO_COMPILER, str(error)
    if os.environ.get("POINTLOOM_CPU"):
        return chosen, f"POINTLOOM_CPU={os.environ['POINTLOOM_CPU']} asks for it"
    if chosen == "taichi":
        threads = os.environ.get("POINTLOOM_CPU_THREADS", "")
        large = f"{threads} threads (POINTLOOM_CPU_THREADS)" if threads else "all cores"
        return chosen, f"large launches run on {large}, small ones by warp on one core"
    return chosen, f"one core only, since {taichi_trial.get('error', 'Taichi cannot serve')}"


def _why_poor(chosen: str, why: str, trials: list[dict[str, Any]]) -> str | None:
    forced = bool(os.environ.get("POINTLOOM_CPU"))
    failed = [trial for trial in trials if not trial["ok"] and not (forced and _is_unused(trial, chosen))]
    if chosen == NO_COMPILER:
        return f"CPU kernels do not run: {why}"
    if not failed:
        return None
    reasons = (f"{trial['compiler']} on {trial['device']}: {trial['error']}" for trial in failed)
    return "; ".join(reasons)


def _why_gpu_is_idle(gpus: list[dict[str, Any]]) -> str | None:
    """Why no GPU serves though the machine has a driver for one."""
    return None if gpus or installed_driver() is None else f"no GPU serves: {why_no_gpu()}"


def _is_unused(trial: dict[str, Any], chosen: str) -> bool:
    return trial["device"] == "cpu" and trial["compiler"] != chosen


def _versions() -> dict[str, str]:
    from ... import __version__  # pyright: ignore[reportMissingImports]

    versions = {"pointloom": __version__}
    for package in _PACKAGES:
        try:
            versions[package] = importlib.metadata.version(package)
        except importlib.metadata.PackageNotFoundError:
            versions[package] = "missing"
    return versions


def _usable_cores() -> int:
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def _memory_bytes() -> int:
    return os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")


def _cuda_driver() -> str | None:
    import warp as wp

    version = wp.get_cuda_driver_version() if wp.get_cuda_device_count() else None
    return ".".join(map(str, version)) if version else None


def _gpus() -> list[dict[str, Any]]:
    import warp as wp

    return [
        {"name": gpu.alias, "title": gpu.name, "memory_bytes": int(gpu.total_memory), "arch": int(gpu.arch)}
        for gpu in wp.get_cuda_devices()
    ]

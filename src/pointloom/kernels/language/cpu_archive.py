"""CPU kernels compiled ahead: machine code of all kernels for levels of x86-64, in the folder kernels/compiled.

`make cpu-kernels` (kernels/cpu_kernels.py) writes the folder, and wheels contain it. The code is used on Linux if the
kernel sources, Warp's version and the compiler flags are those it was made from, and the processor has a level.
Otherwise kernels are compiled at first use, and one log record (INFO, logger "pointloom") gives the reason.
POINTLOOM_CPU_KERNELS names another folder. Empty, it disables code that was compiled ahead.
"""

from __future__ import annotations

import hashlib
import json
import os
import platform
import sys
from functools import cache
from pathlib import Path
from typing import Any

import warp as wp

from . import cpu_code
from .compile_notices import LOGGER
from .compiled_ahead import digest_of_sources

VARIABLE = "POINTLOOM_CPU_KERNELS"
FOLDER = Path(__file__).parents[1] / "compiled"
MANIFEST = "manifest.json"
PREFIX = __name__.partition("language.")[0]
# Highest first. The names of features in /proc/cpuinfo
_V2 = {"cx16", "lahf_lm", "popcnt", "pni", "sse4_1", "sse4_2", "ssse3"}
_V3 = _V2 | {"avx", "avx2", "bmi1", "bmi2", "f16c", "fma", "abm", "movbe"}
_V4 = _V3 | {"avx512f", "avx512bw", "avx512cd", "avx512dq", "avx512vl"}
LEVELS = {"x86-64-v4": _V4, "x86-64-v3": _V3, "x86-64-v2": _V2}
_is_disabled = False


def made_from() -> dict[str, str]:
    """Everything that machine code of a level depends on; nothing of this machine."""
    return {
        "format": "1",
        "Warp": wp.__version__,
        "flags": cpu_code.FLAGS,
        "header": hashlib.sha256((cpu_code.header() + cpu_code.pool_header()).encode()).hexdigest(),
        "sources of kernels": digest_of_sources(),
    }


def name_of(module: str) -> str:
    """Name of the files of a module of kernels. Empty for other packages."""
    return module.removeprefix(PREFIX) if module.startswith(PREFIX) else ""


def entry_of(module: str, kernel: str) -> list[Any] | None:
    """Fields of the CachedKernel of a kernel, with the path of its machine code last. None if there is none."""
    kernels, machine_code = _read(module)
    return [*kernels[kernel], machine_code] if kernel in kernels else None


def contains(machine_code: str) -> bool:
    return _folder() is not None and Path(machine_code).parent == _folder()


def described() -> str:
    """One line for reports: the code in use, or the reason for none."""
    path = _folder()
    if path is not None:
        return f"{path} (compiled ahead)"
    if folder() is None:
        return "compiled at first use: no code was compiled ahead"
    return f"compiled at first use: {folder()} does not fit this processor, Warp or these sources"


def disable() -> None:
    """Compile kernels in this process, for those that compile ahead."""
    global _is_disabled
    _is_disabled = True


def folder() -> Path | None:
    """Folder with the levels, or None."""
    if _is_disabled:
        return None
    named = os.environ.get(VARIABLE)
    path = FOLDER if named is None else Path(named)
    if named and not path.is_dir():
        raise ValueError(f"{VARIABLE}: expected an existing folder, got {named!r}. Change or unset the variable")
    return path if named != "" and path.is_dir() else None


@cache
def _read(module: str) -> tuple[dict[str, Any], str]:
    """Kernels of a module by name, and the path of its machine code. Empty if the code is missing or damaged."""
    path, name = _folder(), name_of(module)
    if path is None or not name:
        return {}, ""
    code = path / f"{name}.o"
    try:
        entries = json.loads((path / f"{name}.json").read_text(encoding="utf-8"))
        if hashlib.sha256(code.read_bytes()).hexdigest() != entries["sha256"]:
            raise ValueError("the digest differs")
        return dict(entries["kernels"]), str(code)
    except FileNotFoundError:  # of a kernel file that has none for the CPU
        return {}, ""
    except (OSError, ValueError, KeyError, TypeError) as error:
        LOGGER.info("%s: damaged (%s): its kernels are compiled at first use", code, error)
        return {}, ""


@cache
def _folder() -> Path | None:
    """Folder of the highest level that this processor has, or None."""
    if (base := folder()) is None or not (level := level_of_processor()):
        return None
    path = base / level
    try:
        stored = json.loads((path / MANIFEST).read_text(encoding="utf-8"))
        differing = [name for name, value in made_from().items() if stored.get(name) != value]
        problem = f"made from other {', '.join(differing)}" if differing else ""
    except (OSError, ValueError, AttributeError) as error:
        problem = f"not readable ({error})"
    if problem:
        LOGGER.info("%s: %s: kernels are compiled at first use", path, problem)
    return None if problem else path


def level_of_processor() -> str:
    """Highest of LEVELS that this processor has; "" if none or unknown."""
    if sys.platform != "linux" or platform.machine() != "x86_64":
        return ""
    features = _features()
    return next((level for level, needed in LEVELS.items() if needed <= features), "")


def _features() -> set[str]:
    try:
        with Path("/proc/cpuinfo").open(encoding="utf-8") as file:
            return next((set(line.partition(":")[2].split()) for line in file if line.startswith("flags")), set())
    except OSError:
        return set()

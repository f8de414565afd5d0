"""Print and record the machine's properties: GPU, driver, clocks, processor, packages. Read these before trusting any
measurement.
"""

from __future__ import annotations

import importlib.metadata
import os
import platform
import shutil
import subprocess
import sys
import threading
from pathlib import Path

from gpu_kit.records import record

PACKAGES = ("numpy", "scipy", "torch", "pytest", "hypothesis", "cupy-cuda12x", "cupy-cuda13x", "cupy", "jax", "triton")
PROGRAMS = ("ncu", "nsys", "compute-sanitizer", "nvcc")
SAMPLED = ("clocks.sm", "clocks.mem", "power.draw", "temperature.gpu")
FIXED = ("name", "driver_version", "clocks.max.sm", "clocks.max.mem", "power.limit", "persistence_mode")
PERIOD = 10.0  # seconds between samples: one takes about 50 ms of another core


def queried(names: tuple[str, ...]) -> dict[str, str]:
    """Properties of the first GPU by nvidia-smi; empty without it."""
    if not shutil.which("nvidia-smi"):
        return {}
    command = ["nvidia-smi", f"--query-gpu={','.join(names)}", "--format=csv,noheader,nounits", "--id=0"]
    line = subprocess.run(command, capture_output=True, text=True, check=False).stdout.strip()
    values = [value.strip() for value in line.split(",")]
    return dict(zip(names, values, strict=True)) if len(values) == len(names) else {}


class Clocks:
    """Samples the GPU's clocks [MHz], power [W] and temperature [C] while a step runs."""

    def __init__(self) -> None:
        self.samples: list[dict[str, str]] = []
        self.ended = threading.Event()
        self.thread = threading.Thread(target=self.sample, daemon=True)

    def sample(self) -> None:
        while not self.ended.wait(PERIOD):
            self.samples.append(queried(SAMPLED))

    def __enter__(self) -> Clocks:
        if shutil.which("nvidia-smi"):
            self.thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self.ended.set()
        if self.thread.ident:
            self.thread.join()

    def ranges(self) -> dict[str, list[float]]:
        """The minimum and maximum of each property."""
        values = {name: [_number(sample.get(name, "")) for sample in self.samples] for name in SAMPLED}
        known = {name: [value for value in each if value is not None] for name, each in values.items()}
        return {name: [min(each), max(each)] for name, each in known.items() if each}


def _number(text: str) -> float | None:
    try:
        return float(text)
    except ValueError:  # "[N/A]"
        return None


def processor() -> str:
    """The processor's name."""
    path = Path("/proc/cpuinfo")
    lines = path.read_text().splitlines() if path.exists() else []
    names = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return names[0] if names else platform.processor() or platform.machine()


def versions() -> dict[str, str]:
    """Versions of the packages that steps use."""
    found = {}
    for name in PACKAGES:
        try:
            found[name] = importlib.metadata.version(name)
        except importlib.metadata.PackageNotFoundError:
            continue
    return found


def main() -> int:
    """Print and record the facts."""
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 2**30
    machine = {
        "processor": processor(),
        "cores": os.cpu_count(),
        "memory_gib": round(memory, 1),
        "platform": platform.platform(),
        "python": platform.python_version(),
        "gpu": queried((*FIXED, *SAMPLED)),
        "packages": versions(),
        "programs": {name: shutil.which(name) or "not installed" for name in PROGRAMS},
    }
    record(Path(sys.argv[1]), "machine", machine)
    for name, value in machine.items():
        print(f"{name}: {value}")
    return 0


if __name__ == "__main__":
    sys.exit(main())

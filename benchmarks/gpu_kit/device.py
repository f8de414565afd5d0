"""The device that is measured: a GPU, or in a dry run the emulated one, of which no figure is kept."""

from __future__ import annotations

import os
import re
import sys
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
NAME = "cuda:0"
DRY = "POINTLOOM_GPU_DRY"  # set for the steps of a dry run: the emulated device, small sizes
EMULATED = "emulated"  # stands in the emulated device's name


class EmulatedDeviceError(RuntimeError):
    """Figures of the emulated device were to be kept: what it does is counted, it takes no time that means anything."""


@dataclass(frozen=True)
class Device:
    """What a figure depends on, of the device."""

    name: str
    architecture: int
    processors: int
    memory_gib: float
    driver: str
    toolkit: str

    @property
    def chip(self) -> str:
        """Its short name, as in files: "h100" of "NVIDIA H100 80GB HBM3", "rtx-4090" of "NVIDIA GeForce RTX 4090"."""
        return chip_of(self.name)

    @property
    def is_emulated(self) -> bool:
        return EMULATED in self.name.lower()

    def as_json(self) -> dict[str, Any]:
        return asdict(self)


def chip_of(name: str) -> str:
    """The short name of a chip, from its whole one."""
    words = re.sub(r"\b(nvidia|tesla|geforce|graphics|device|cuda)\b", " ", name.lower())
    found = re.search(r"\brtx\s+(?:pro\s+)?\w+(?:\s+(?:ti|super|ada))*|\b[a-z]+\d+[a-z]*\b", words)
    return "-".join((found.group() if found else words).split()) or "unknown"


def is_dry() -> bool:
    """Whether this process belongs to a dry run."""
    return bool(os.environ.get(DRY))


def start() -> Device:
    """Start Warp; in a dry run on the emulated device. Before pointloom is imported.

    Raises:
        SystemExit: There is no GPU, and this is no dry run.
    """
    if is_dry():
        os.environ.setdefault("EMULATED_CUDA_UNINITIALISED", "0")
        sys.path.append(str(ROOT / "tests"))
        from emulated_cuda.install import install, installed

        if installed() is None:
            install()
    import warp as wp

    import pointloom.kernels.lang  # noqa: F401  before Warp starts: it silences the banner

    wp.init()
    if not wp.get_cuda_device_count():
        raise SystemExit("no CUDA device here; --dry runs the kit on the emulated one")
    found = wp.get_device(NAME)
    driver, toolkit = (".".join(map(str, version or ())) for version in (wp.get_cuda_driver_version(), _toolkit()))
    device = Device(found.name, found.arch, found.sm_count, round(found.total_memory / 2**30, 1), driver, toolkit)
    if is_dry() != device.is_emulated:
        raise SystemExit(f"{device.name}: a dry run is on the emulated device, and no other run is")
    return device


def _toolkit() -> Any:
    import warp as wp

    return wp.get_cuda_toolkit_version()

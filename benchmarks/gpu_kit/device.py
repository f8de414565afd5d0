"""The measured device: a GPU, or in a dry run the emulated one, of which no measurements are saved."""

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
EMULATED = "emulated"  # contained in the emulated device's name


class EmulatedDeviceError(RuntimeError):
    """Raised on an attempt to save measurements of the emulated device, whose times are meaningless."""


@dataclass(frozen=True)
class Device:
    """The properties of the device that measurements depend on."""

    name: str
    architecture: int
    processors: int
    memory_gib: float
    driver: str
    toolkit: str

    @property
    def chip(self) -> str:
        """Short name for files: "h100" for "NVIDIA H100 80GB HBM3", "rtx-4090" for "NVIDIA GeForce RTX 4090"."""
        return chip_of(self.name)

    @property
    def is_emulated(self) -> bool:
        return EMULATED in self.name.lower()

    def as_json(self) -> dict[str, Any]:
        return asdict(self)


def chip_of(name: str) -> str:
    """The short name of a chip, from its full name."""
    words = re.sub(r"\b(nvidia|tesla|geforce|graphics|device|cuda)\b", " ", name.lower())
    match = re.search(r"\brtx\s+(?:pro\s+)?\w+(?:\s+(?:ti|super|ada))*|\b[a-z]+\d+[a-z]*\b", words)
    return "-".join((match.group() if match else words).split()) or "unknown"


def is_dry() -> bool:
    """True if this process belongs to a dry run."""
    return bool(os.environ.get(DRY))


def start() -> Device:
    """Start Warp, in a dry run with the emulated device. Call it before importing pointloom.

    Raises:
        SystemExit: There is no GPU, and this is no dry run.
    """
    if is_dry():
        os.environ.setdefault("EMULATED_CUDA_UNINITIALISED", "0")
        sys.path.append(str(ROOT))
        from tests.emulated_cuda.install import install, installed

        if installed() is None:
            install()
    import warp as wp

    import pointloom.kernels.lang  # noqa: F401  before Warp starts: it silences the banner

    wp.init()
    if not wp.get_cuda_device_count():
        raise SystemExit("no CUDA device found; use --dry to run the kit on the emulated device")
    warp_device = wp.get_device(NAME)
    driver, toolkit = (".".join(map(str, version or ())) for version in (wp.get_cuda_driver_version(), _toolkit()))
    device = Device(
        warp_device.name,
        warp_device.arch,
        warp_device.sm_count,
        round(warp_device.total_memory / 2**30, 1),
        driver,
        toolkit,
    )
    if is_dry() != device.is_emulated:
        raise SystemExit(f"{device.name}: dry runs, and only these, use the emulated device")
    return device


def _toolkit() -> Any:
    import warp as wp

    return wp.get_cuda_toolkit_version()

"""Why there is no GPU: the installed NVIDIA driver, found without CUDA, and the required one."""

from __future__ import annotations

import os
import re
from pathlib import Path

PROC = Path("/proc/driver/nvidia/version")

# The oldest driver of each CUDA version by minor version compatibility: NVIDIA's "CUDA
# Toolkit Release Notes", table 2.
OLDEST_DRIVERS = {11: 450, 12: 525, 13: 580}


def installed_driver() -> str | None:
    """Version of the loaded driver, such as "535.183.01". None without one, and in WSL."""
    try:
        text = PROC.read_text(errors="replace")
    except OSError:
        return None
    match = re.search(r"Kernel Module\D*?(?:for \S+)?\s+(\d+(?:\.\d+)+)\s", text)
    return match[1] if match else None


def needed_driver() -> int | None:
    """The oldest driver for Warp's CUDA version, such as 580. None if unknown."""
    import warp as wp

    toolkit = wp.get_cuda_toolkit_version()
    return OLDEST_DRIVERS.get(toolkit[0]) if toolkit else None


def why_no_gpu() -> str:
    """Why Warp finds no GPU, as a clause after a colon."""
    import warp as wp

    installed, needed = installed_driver(), needed_driver()
    toolkit = wp.get_cuda_toolkit_version()
    warp = f"Warp {wp.__version__}" + (f" (CUDA {toolkit[0]})" if toolkit else "")
    wants = f"{warp} needs {needed} or newer" if needed else f"{warp} needs one"
    if installed is None:
        return f"no NVIDIA driver is loaded; {wants}"
    if needed and int(installed.split(".")[0]) < needed:
        return f"driver {installed} is too old; {wants}: install a newer driver"
    hidden = os.environ.get("CUDA_VISIBLE_DEVICES")
    shown = "" if hidden is None else f", with CUDA_VISIBLE_DEVICES={hidden!r}"
    return f"driver {installed} is new enough, but shows no device{shown}; try nvidia-smi"

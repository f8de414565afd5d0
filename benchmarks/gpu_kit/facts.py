"""Print the machine's properties: GPU, driver, processor, packages. Read these before trusting any measurement."""

from __future__ import annotations

import os
import platform
import shutil
import subprocess
import sys

PACKAGES = ("numpy", "scipy", "torch", "pytest", "hypothesis", "cupy", "jax", "triton", "pillow", "rich", "click")
PROGRAMS = ("ncu", "nsys", "compute-sanitizer", "nvcc")


def main() -> int:
    """Print the facts."""
    if shutil.which("nvidia-smi"):
        print(subprocess.run(["nvidia-smi"], capture_output=True, text=True).stdout)
    print(f"Python {platform.python_version()}, {os.cpu_count()} cores, {platform.platform()}")
    listed = subprocess.run([sys.executable, "-m", "pip", "list"], capture_output=True, text=True).stdout
    print(*(line for line in listed.splitlines() if line.lower().split(" ")[0] in PACKAGES), sep="\n")
    print(*(f"{name}: {shutil.which(name) or 'not here'}" for name in PROGRAMS), sep="\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())

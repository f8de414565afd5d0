"""Compile all kernels for the emulated device ahead, on all cores: python tests/emulated_cuda/compile_kernels.py

NVRTC and gcc work on one core each, and are most of what a first run costs. What is compiled already is only looked up.
"""

from __future__ import annotations

import importlib
import os
import pkgutil
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from emulated_cuda.install import install


def kernel_modules() -> list[str]:
    """The names of all modules with kernels; Warp is started."""
    from pointloom import kernels
    from pointloom.kernels import lang

    for module in pkgutil.walk_packages(kernels.__path__, kernels.__name__ + "."):
        importlib.import_module(module.name)
    return sorted(lang.KERNEL_MODULES)


def compile_share(first: int, step: int) -> None:
    """Load every step-th module on the device."""
    install()
    names = kernel_modules()
    import warp as wp

    # the largest sources first, so that no worker is left with one of them at the end
    names.sort(key=lambda name: -Path(str(sys.modules[name].__file__)).stat().st_size)
    for name in names[first::step]:
        wp.get_module(name).load(wp.get_device("cuda:0"))


def main() -> int:
    """A process for each core; the exit status."""
    if len(sys.argv) == 3:
        compile_share(int(sys.argv[1]), int(sys.argv[2]))
        return 0
    count = len(os.sched_getaffinity(0))
    command = [sys.executable, __file__]
    workers = [subprocess.Popen([*command, str(k), str(count)], stdout=subprocess.DEVNULL) for k in range(count)]
    return max(worker.wait() for worker in workers)


if __name__ == "__main__":
    sys.exit(main())

"""Compile all kernels for the emulated device ahead, on all cores: python tests/emulated_cuda/compile_kernels.py

NVRTC and gcc use one core each, and are most of what a first run costs. What is compiled already is only looked up.
"""

import importlib
import multiprocessing
import os
import pkgutil
import sys
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from emulated_cuda.install import install


def module_names() -> list[str]:
    """All modules of kernels/, the largest sources first, so that no core is left with one of them at the end."""
    spec = importlib.util.find_spec("pointloom.kernels")
    assert spec and spec.submodule_search_locations
    sources = pkgutil.walk_packages(spec.submodule_search_locations, "pointloom.kernels.")
    sizes = {m.name: Path(m.module_finder.path, m.name.rpartition(".")[2] + ".py") for m in sources if not m.ispkg}
    return sorted(sizes, key=lambda name: -sizes[name].stat().st_size)


def compile_module(name: str) -> None:
    """Load a module on the device, the part that only CUDA runs included."""
    from pointloom.kernels import lang
    from pointloom.kernels.language.warp_compiler import cuda_module

    import warp as wp  # isort: skip

    importlib.import_module(name)
    if name in lang.LAUNCHED:
        lang.resolve_module(name)
        for module in (wp.get_module(name), cuda_module(name)):
            if module.kernels:
                module.load(wp.get_device("cuda:0"))


def main() -> None:
    spawn = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(len(os.sched_getaffinity(0)), spawn, initializer=install) as pool:
        for _ in pool.map(compile_module, module_names()):
            pass


if __name__ == "__main__":
    main()

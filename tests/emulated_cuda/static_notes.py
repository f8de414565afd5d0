"""Notes about the PTX of kernels: float atomics, products that ptxas may fuse, approximations, local memory.

    python tests/emulated_cuda/static_notes.py [file.ptx ...]

Without files: of all modules of pointloom in Warp's cache, which `make test-cuda-emulated` fills.
"""

import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from emulated_cuda.ptx import UnknownPtx, translate


def cached_modules() -> list[Path]:
    import warp as wp

    wp.config.quiet = True
    wp.init()
    newest = {}
    for path in Path(wp.config.kernel_cache_dir).glob("wp_pointloom.*/*.ptx"):
        module = re.sub(r"_[0-9a-f]{7}\..*", "", path.name)
        newest[module] = max(newest.get(module, path), path, key=lambda p: p.stat().st_mtime)
    return sorted(newest.values())


def main(paths: list[Path]) -> int:
    failures = 0
    for path in paths:
        name = re.sub(r"_[0-9a-f]{7}\..*", "", path.name).removeprefix("wp_pointloom.kernels.")
        try:
            kernels = translate(path.read_bytes().decode(errors="replace")).kernels
        except UnknownPtx as error:
            failures += 1
            print(f"{name}: {error}", file=sys.stderr)
            continue
        for kernel in kernels:
            short = re.sub(r"_[0-9a-f]{8}_cuda_kernel_forward$", "", kernel.name)
            size = f"{kernel.statements} statements, {kernel.local_bytes} B of local memory"
            print(f"{name}.{short}: {size}{'; ' if kernel.findings else ''}{'; '.join(kernel.findings)}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main([Path(name) for name in sys.argv[1:]] or cached_modules()))

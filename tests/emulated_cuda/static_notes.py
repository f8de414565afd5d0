"""Notes about the PTX of kernels: float atomics, products that ptxas may fuse, approximations, local memory.

    python tests/emulated_cuda/static_notes.py [--loops] [file.ptx ...]

Without files: of all modules of pointloom in Warp's cache, which `make test-cuda-emulated` fills. `--loops` lists the
loops in which a load of an element waits for the store of the element before, as L and S in their order: the compiler
keeps that order, since both could be the same address. Where they are not, load all elements first. The lists of two
commits, compared with diff, show new loops.
"""

import re
import sys
from collections.abc import Iterator
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


def short_name(kernel: str) -> str:
    return re.sub(r"_[0-9a-f]{8}_cuda_kernel_forward$", "", kernel)


def waiting_loops(ptx: str) -> Iterator[tuple[str, str]]:
    """(kernel, its loads and stores of global memory in order) of loops with a load after a store, twice or more."""
    kernel, statements, labels = "", [], {}
    for line in map(str.strip, ptx.splitlines()):
        if entry := re.match(r"(?:\.visible )?\.entry (\w+)", line):
            kernel, statements, labels = entry[1], [], {}
        elif label := re.match(r"(\$L\w+):", line):
            labels[label[1]] = len(statements)
        elif line.endswith(";") and not line.startswith("."):
            statements.append(line)
            branch = re.search(r"bra(?:\.uni)?\s+(\$L\w+)", line)
            if branch and branch[1] in labels:
                body = statements[labels[branch[1]] :]
                order = "".join("S" if "st.global" in s else "L" if "ld.global" in s else "" for s in body)
                if re.search("SL+SL", re.sub("S+", "S", order)):
                    yield kernel, order


def main(paths: list[Path], loops: bool) -> int:
    failures = 0
    for path in paths:
        name = re.sub(r"_[0-9a-f]{7}\..*", "", path.name).removeprefix("wp_pointloom.kernels.")
        if loops:
            for kernel, order in waiting_loops(path.read_text("utf-8", "replace")):
                print(f"{name}.{short_name(kernel)}: {order[:60]}")
            continue
        try:
            kernels = translate(path.read_bytes().decode(errors="replace")).kernels
        except UnknownPtx as error:
            failures += 1
            print(f"{name}: {error}", file=sys.stderr)
            continue
        for kernel in kernels:
            size = f"{kernel.statements} statements, {kernel.local_bytes} B of local memory"
            print(
                f"{name}.{short_name(kernel.name)}: {size}{'; ' if kernel.findings else ''}{'; '.join(kernel.findings)}"
            )
    return 1 if failures else 0


if __name__ == "__main__":
    names = [name for name in sys.argv[1:] if name != "--loops"]
    sys.exit(main([Path(name) for name in names] or cached_modules(), "--loops" in sys.argv))

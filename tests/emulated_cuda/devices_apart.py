"""A program for test_devices_apart.py: operations on cuda:1 while cuda:0 is the default; faults as JSON.

    python -m emulated_cuda.devices_apart one|both [PREFIX ...]

`one` runs each operation on cuda:1 alone and lists its uses of cuda:0; `both` runs each on the two at once, in two
threads, and lists the operations whose results differ from a run alone.
"""

import json
import sys
import threading
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[2]
sys.path[:0] = [str(ROOT / "src"), str(ROOT)]
from tests.emulated_cuda.install import install, installed  # noqa: E402

install()
import warp as wp  # noqa: E402

from tests.emulated_cuda.findings import caller  # noqa: E402
from tests.emulated_cuda.streams import CONTEXT, address_of  # noqa: E402
from tests.small_scenes import ON_CLOUDS, ON_HOST, ONCE, SmallScenes, digest  # noqa: E402

WORK = (  # calls that use a device, all with its context as first argument
    *("wp_alloc_device", "wp_alloc_device_async", "wp_cuda_launch_kernel", "wp_memset_device", "wp_memtile_device"),
    *("wp_memcpy_h2d", "wp_memcpy_d2h", "wp_memcpy_d2d", "wp_array_copy_device", "wp_array_fill_device"),
)


def operations(device: str) -> dict[str, Any]:
    small = SmallScenes(device)
    works = {name: lambda work=work: work(small.surface) for name, work in ON_CLOUDS.items()}
    works |= {name: lambda work=work: work(small) for name, work in ONCE.items()}
    return {name: work for name, work in works.items() if not name.startswith(ON_HOST)}


def watch_first(uses: list[str]) -> None:
    wp.init()
    core = wp._src.context.runtime.core
    for name in WORK:
        real = getattr(core, name)

        def call(context: Any, *arguments: Any, real: Any = real, name: str = name) -> Any:
            if (address_of(context) or CONTEXT) == CONTEXT:
                uses.append(f"{name}: {caller()}")
            return real(context, *arguments)

        setattr(core, name, call)


def run_one(prefixes: tuple[str, ...]) -> dict[str, Any]:
    uses: list[str] = []
    results: dict[str, Any] = {}
    watch_first(uses)
    works = operations("cuda:1")
    for name, work in works.items():
        if name.startswith(prefixes):
            work()
            wp.synchronize_device("cuda:1")
            results[name] = sorted(set(uses))
            uses.clear()
    return results


def run_both(prefixes: tuple[str, ...]) -> dict[str, Any]:
    sides = [operations(f"cuda:{k}") for k in (0, 1)]
    results: dict[str, Any] = {}
    for name in sides[0]:
        if not name.startswith(prefixes):
            continue
        alone, together = digest(sides[0][name]()), ["", ""]

        def run(k: int, name: str = name, together: list[str] = together) -> None:
            try:
                together[k] = digest(sides[k][name]())
            except Exception as error:
                together[k] = f"{type(error).__name__}: {error}"

        threads = [threading.Thread(target=run, args=(k,)) for k in (0, 1)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        results[name] = [] if together == [alone, alone] else [alone, *together]
    return results


if __name__ == "__main__":
    run = {"one": run_one, "both": run_both}[sys.argv[1]]
    report = run(tuple(sys.argv[2:]) or ("",))
    print(json.dumps({"found": report, "faults": installed().findings.faults}))  # type: ignore[union-attr]

"""Bitwise comparison of every operation's results on small scenes: two runs on the GPU, and one on the CPU.

python -m gpu_kit.digests STATE SECONDS
"""

from __future__ import annotations

import subprocess
import sys
import time
from pathlib import Path
from typing import Any

from gpu_kit import device as devices
from gpu_kit.documents import keep_part

RUNS = {"first": devices.NAME, "second": devices.NAME, "cpu": "cpu"}


def digests_of(text: str) -> dict[str, str]:
    """The digest of each operation, from the output of tests.small_digests."""
    return {name: digest for digest, _, name in (line.partition(" ") for line in text.splitlines()[1:])}


def compared(first: dict[str, str], second: dict[str, str], cpu: dict[str, str]) -> dict[str, Any]:
    """Counts and names of operations by agreement of their results."""
    both = [name for name in first if name in second]
    errors = [name for name in first if first[name].startswith("error") and cpu.get(name) != first[name]]
    return {
        "operations": len(both),
        "different from run to run": [name for name in both if first[name] != second[name]],
        "compared with the CPU": len([name for name in first if name in cpu]),
        "different from the CPU": [name for name in first if name in cpu and first[name] != cpu[name]],
        "errors on the GPU alone": {name: first[name] for name in errors},
    }


def print_digests(on: str) -> None:
    """Print the digests of a device; in a dry run the GPU is the emulated one."""
    devices.start()
    sys.argv[1:] = ["--device", on]
    from tests.small_digests import main as digests_of_device

    digests_of_device()


def main() -> int:
    """Run the three processes side by side, and compare what they printed within the time limit."""
    if sys.argv[1] == "--on":
        print_digests(sys.argv[2])
        return 0
    state, end = Path(sys.argv[1]), time.monotonic() + float(sys.argv[2])
    device = devices.start()
    logs = {name: state / "logs" / f"digests-{name}.txt" for name in RUNS}
    processes = []
    for name, on in RUNS.items():
        command = [sys.executable, "-m", "gpu_kit.digests", "--on", on]
        with logs[name].open("w") as file:
            processes.append(subprocess.Popen(command, stdout=file, cwd=devices.ROOT))
    for process in processes:
        try:
            process.wait(max(1.0, end - time.monotonic()))
        except subprocess.TimeoutExpired:
            process.kill()
    result = compared(*(digests_of(log.read_text()) for log in logs.values()))
    keep_part(state, device, "digests", result)
    for name, value in result.items():
        print(f"{name}: {f'{len(value)}: {value}' if isinstance(value, (list, dict)) else value}")
    bad = not result["operations"] or result["different from run to run"] or result["errors on the GPU alone"]
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())

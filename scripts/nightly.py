"""The checks that are too slow for CI, one after another, with a table of results: `make nightly`.

    make nightly ARGS="--only mutants --only fuzz"    some of them
    make nightly ARGS="--list"                        their names and commands

Each stage writes its output to build/nightly/<stage>.log. A failed stage does not stop the next one. The exit code is 1
if one failed.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
LOGS = ROOT / "build" / "nightly"
FUZZ = [".venv/bin/python", "benchmarks/fuzz/run.py", "--count", "3000", "--seed", "1"]

# Beside other libraries: the newest versions that pip finds (its settings choose the index), in their own environment.
OTHERS = "torch jax numba open3d pyinstaller pytest pytest-xdist hypothesis"
TESTS_BESIDE = " ".join(
    f"tests/core/test_{name}.py" for name in ("array_libraries", "other_array_libraries", "standard_streams")
)
BESIDE = f"""set -e
{sys.executable} -m venv build/beside
build/beside/bin/python -m pip install --quiet --upgrade --editable . {OTHERS}
build/beside/bin/python -m pip list
build/beside/bin/python -m pytest -n 0 {TESTS_BESIDE}"""

# stage -> command and additional environment variables
STAGES: dict[str, tuple[list[str], dict[str, str]]] = {
    "gpu-kit": (["make", "gpu-run", "ARGS=--dry"], {}),
    "cuda-architectures": (["make", "check-cuda"], {}),
    "trust": (["make", "trust", "ARGS=--quick"], {}),
    "fuzz": (FUZZ, {}),
    "nightly-tests": (["make", "test-all", "ARGS=-m nightly"], {}),
    "oldest-versions": ([".venv/bin/python", "scripts/test_versions.py", "oldest"], {}),
    "newest-versions": ([".venv/bin/python", "scripts/test_versions.py", "newest"], {}),
    "taichi": (["make", "test-all", "ARGS=--taichi"], {}),
    "gallery": (["make", "docs"], {}),
    "platforms": ([".venv/bin/python", "scripts/check_platforms.py"], {}),
    "beside": (["sh", "-c", BESIDE], {}),
    "flakes": (["make", "flakes"], {}),
    "mutants": (["make", "mutants", "ARGS=--all"], {}),
    "emulated-order-0": (["make", "test-cuda-emulated"], {"EMULATED_CUDA_ORDER": "0"}),
    "emulated-order-2": (["make", "test-cuda-emulated"], {"EMULATED_CUDA_ORDER": "2"}),
    "emulated-order-3": (["make", "test-cuda-emulated"], {"EMULATED_CUDA_ORDER": "3"}),
    "kernel-coverage": (["make", "kernel-coverage", "TESTS=full"], {"EMULATED_CUDA_ORDER": "0"}),
}


def main() -> int:
    """Run the stages and print the table; returns the exit code."""
    parser = argparse.ArgumentParser(prog="make nightly", description=__doc__.partition("\n")[0])
    parser.add_argument("--only", action="append", choices=STAGES, metavar="STAGE", help="this stage; may be repeated")
    parser.add_argument("--list", action="store_true", help="print the stages and run nothing")
    options = parser.parse_args()
    chosen = {name: STAGES[name] for name in options.only or STAGES}
    if options.list:
        for name, (command, settings) in chosen.items():
            print(f"{name:<20} {' '.join([*(f'{key}={value}' for key, value in settings.items()), *command])}")
        return 0
    LOGS.mkdir(parents=True, exist_ok=True)
    failed, rows = 0, []
    for name, (command, settings) in chosen.items():
        print(f"{name}: {' '.join(command)}, log in {(LOGS / name).relative_to(ROOT)}.log", flush=True)
        begin = time.monotonic()
        with (LOGS / f"{name}.log").open("w") as log:
            done = subprocess.run(
                command, cwd=ROOT, env=os.environ | settings, stdout=log, stderr=subprocess.STDOUT, check=False
            )
        failed += done.returncode != 0
        last = (LOGS / f"{name}.log").read_text(errors="replace").splitlines()[-1:] or [""]
        result = "passed" if done.returncode == 0 else f"failed ({done.returncode})"
        rows.append(f"{name:<20} {result:<12} {(time.monotonic() - begin) / 60:7.1f} min  {last[0][:100]}")
        print(rows[-1], flush=True)
    print("\n".join(["", *rows]))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())

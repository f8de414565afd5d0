"""All tests of cuda:0 within a time limit, those not run for longest first; failing tests are repeated individually.

    python -m gpu_kit.suite STATE SECONDS

A stage is a run of pytest, which pytest-xdist distributes by file. A test that passes individually was affected by
another test or by a lost context; one that still fails is a fault of pointloom. Tests that lack a package are counted
separately. Failures are written at once, so a stage that ran out of time has their names. The next run continues with
the remaining stages.
"""

from __future__ import annotations

import importlib.util
import json
import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any, NamedTuple

from gpu_kit import device as devices
from gpu_kit.documents import keep_part, last_measured, saved_part
from gpu_kit.gpu_only import FAILURES
from gpu_kit.runner import MORE

SMOKE = ["arrays", "language/test_launch.py", "language/test_lanes.py", "test_memory.py"]
# few stages: each start costs
PACKAGES = ("visualization photogrammetry cli", "pcd", "registration meshing rgbd", "kernels")
STAGES = {"smoke": [f"tests/kernels/{name}" for name in SMOKE]} | {
    packages: [f"tests/{package}" for package in packages.split()] for packages in PACKAGES
}
DRY_TESTS = ["tests/kernels/arrays/test_select.py"]
# Independent of a GPU, or without use on one
SKIP = ("tests/kernels/test_check_cuda.py", "tests/kernels/test_cuda_cache.py")
SKIP += ("tests/visualization/viewer", "tests/photogrammetry/depth")
LACKING = ("No module named", "ImportError while importing")
STAGE_AT_LEAST, ALONE_AT_LEAST, ALONE_AT_MOST, MAX_ALONE = 15.0, 20.0, 60.0, 60
LONGEST_TEST = 100  # seconds, if pytest-timeout is installed


class Ran(NamedTuple):
    """A run of pytest; code 124 if it exceeded its time."""

    code: int
    text: str


def run(arguments: list[str], seconds: float, state: Path, name: str) -> Ran:
    """Run pytest, and terminate it and its workers after some seconds."""
    log = state / "logs" / f"tests-{name}.txt"
    failed_file(state, name).unlink(missing_ok=True)
    environment = {**os.environ, FAILURES: str(failed_file(state, name))}
    command = [sys.executable, "-m", "pytest", "-q", "-p", "gpu_kit.gpu_only", "-o", "filterwarnings=default"]
    command += ["--tb=short", *(["--emulated-cuda"] if devices.is_dry() else []), *arguments]
    with log.open("w") as file:
        process = subprocess.Popen(
            command, stdout=file, stderr=subprocess.STDOUT, env=environment, start_new_session=True
        )
        try:
            code = process.wait(max(1.0, seconds))
        except subprocess.TimeoutExpired:
            code = 124
            for kind in (signal.SIGINT, signal.SIGTERM, signal.SIGKILL):  # the first makes pytest print its summary
                os.killpg(process.pid, kind)
                try:
                    process.wait(8)
                    break
                except subprocess.TimeoutExpired:
                    continue
    return Ran(code, log.read_text(errors="replace"))


def failed_file(state: Path, name: str) -> Path:
    """The file of a run of pytest to which gpu_only.py appends failures."""
    return state / "logs" / f"tests-{name}.jsonl"


def failures(state: Path, name: str) -> tuple[list[str], int]:
    """The failed tests of a run of pytest, and the number of tests that lack a package."""
    path = failed_file(state, name)
    rows = [json.loads(line) for line in path.read_text().splitlines()] if path.exists() else []
    own = [row["test"] for row in rows if not any(word in row["text"] for word in LACKING)]
    return list(dict.fromkeys(own)), len(rows) - len(own)


def summary(ran: Ran) -> str:
    """pytest's last line."""
    lines = [line for line in ran.text.splitlines() if re.search(r"\d+ (passed|failed|error|skipped)", line)]
    return lines[-1].strip("= ") if lines else f"exit {ran.code}, no summary"


class Suite:
    """The stages of a run and their results."""

    def __init__(self, state: Path, seconds: float) -> None:
        self.state, self.end, self.device = state, time.monotonic() + seconds, devices.start()
        empty: dict[str, Any] = {"stages": {}, "seconds": {}, "failed": [], "alone": {}, "lacking": 0}
        self.results = saved_part(state, "tests") or empty

    @property
    def left(self) -> float:
        return self.end - time.monotonic()

    def stage(self, name: str, paths: list[str]) -> bool:
        """Run a stage; returns False if the time is not enough for all of it."""
        existing = [path for path in paths if Path(path).exists()]
        if self.left < STAGE_AT_LEAST:
            return False
        workers = os.environ.get("POINTLOOM_GPU_WORKERS", str(max(1, (os.cpu_count() or 2) - 2)))
        options = [*existing, *(f"--ignore={path}" for path in SKIP)]
        if importlib.util.find_spec("xdist") and not devices.is_dry():
            options += ["-n", workers, "--dist", "loadfile", "--max-worker-restart=200"]
        if importlib.util.find_spec("pytest_timeout"):
            options += [f"--timeout={LONGEST_TEST}"]
        start = time.monotonic()
        log = name.replace(" ", "-")
        ran = run(options, self.left - 12, self.state, log)
        failed, lacking = failures(self.state, log)
        self.results["seconds"][name] = round(time.monotonic() - start, 1)
        self.results["failed"] = list(dict.fromkeys([*self.results["failed"], *failed]))
        if ran.code == 124:
            self.results.setdefault("incomplete", {})[name] = summary(ran)
            print(f"{name:14} out of time; the next run repeats it: {summary(ran)}", flush=True)
        else:
            self.results.get("incomplete", {}).pop(name, None)
            self.results["stages"][name] = summary(ran)
            self.results["lacking"] += lacking
            print(f"{name:14} {time.monotonic() - start:6.0f} s  {summary(ran)}", flush=True)
        keep_part(self.state, self.device, "tests", self.results)
        return ran.code != 124

    def again_alone(self) -> None:
        """Repeat each failed test in a separate process."""
        for test in self.results["failed"]:
            if test in self.results["alone"]:
                continue
            if self.left < ALONE_AT_LEAST or len(self.results["alone"]) >= MAX_ALONE:
                return
            ran = run([test], min(self.left - 5, ALONE_AT_MOST), self.state, "one")
            self.results["alone"][test] = ran.code == 0
            with (self.state / "logs" / "tests-failures.txt").open("a") as file:
                file.write(f"===== {test}: exit {ran.code}\n{ran.text[-4000:]}\n")
            print(f"again alone: {'PASSES' if ran.code == 0 else f'FAILS {ran.code}'}  {test}", flush=True)
            keep_part(self.state, self.device, "tests", self.results)


def _age(stage: str, known: dict[str, tuple[str, str]]) -> tuple[bool, str]:
    """The order of a stage: basics first, then by the date of the last complete run."""
    return stage != "smoke", known.get(stage, ("", ""))[0]


def main() -> int:
    """Run the remaining stages; returns MORE if some remain."""
    suite = Suite(Path(sys.argv[1]), float(sys.argv[2]))
    known = last_measured("tests", "stages", chip=suite.device.chip)
    stages = (
        {"smoke": DRY_TESTS}
        if devices.is_dry()
        else dict(sorted(STAGES.items(), key=lambda each: _age(each[0], known)))
    )
    complete = all(name in suite.results["stages"] or suite.stage(name, paths) for name, paths in stages.items())
    suite.again_alone()
    failed, alone = suite.results["failed"], suite.results["alone"]
    print(f"{len(failed)} failed, {sum(alone.values())} pass individually; {suite.results['lacking']} lack a package")
    if not complete:
        return MORE
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())

"""Run the steps within a time limit: each in a separate process, with its output on stdout and in a log, and its
status, seconds and clocks saved.

Finished steps are not repeated. A step that ran out of time is started again by the next run and continues, since it
saves its results one by one. A failed step is skipped until it is requested by name. A step may use its planned seconds
and those that later steps do not need.
"""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import threading
import time
from collections.abc import Iterable, Sequence
from pathlib import Path

from gpu_kit.device import DRY, ROOT
from gpu_kit.facts import Clocks
from gpu_kit.records import record
from gpu_kit.steps import Step

MORE = 75  # exit code of a step with remaining work (EX_TEMPFAIL)
MARGIN = 8.0  # seconds between a step's own limit and its termination
AT_LEAST = 10.0  # seconds in which a step can import pointloom and save a result


class Run:
    """A run in a folder: marks of steps in done/, output in logs/, results in parts/."""

    def __init__(self, state: Path, seconds: float, *, dry: bool) -> None:
        self.state, self.dry, self.end = state, dry, time.monotonic() + seconds
        for name in ("done", "logs", "parts"):
            (state / name).mkdir(parents=True, exist_ok=True)

    @property
    def left(self) -> float:
        return self.end - time.monotonic()

    def status(self, step: Step) -> str:
        """ "done", "failed", or "" if it is not finished."""
        mark = self.state / "done" / step.name
        return mark.read_text() if mark.exists() else ""

    def forget(self, step: Step) -> None:
        """Mark a step as not done, so that it starts from the beginning."""
        (self.state / "done" / step.name).unlink(missing_ok=True)
        if step.part:
            (self.state / "parts" / f"{step.part}.json").unlink(missing_ok=True)

    def why_not(self, step: Step, pieces: Iterable[str] | None) -> str:
        """Why a step cannot run now; empty if it can."""
        if status := self.status(step):
            return f"{status} before"
        if self.dry and step.not_dry:
            return step.not_dry
        if not step.is_possible:
            return f"no {step.program} here"
        missing = [] if pieces is None else [piece for piece in step.needs if piece not in pieces]
        if missing:
            return f"waits for {', '.join(missing)}"
        needed = min(AT_LEAST, step.seconds)
        return f"not enough time left, it needs {needed:.0f} s" if self.left < needed else ""

    def all(self, steps: Sequence[Step], pieces: Iterable[str] | None = None) -> list[str]:
        """Run all possible steps; returns the names of failed steps."""
        failed = []
        for k, step in enumerate(steps):
            if reason := self.why_not(step, pieces):
                print(f"== {step.name}: {reason}", flush=True)
                continue
            begin = time.monotonic()
            later = sum(other.seconds for other in steps[k + 1 :] if not self.why_not(other, pieces))
            with Clocks() as clocks:
                code = self.one(step, step.seconds + max(0.0, self.left - MARGIN - step.seconds - later))
            if code != MORE:
                (self.state / "done" / step.name).write_text("failed" if code else "done")
            ended = {0: "done", MORE: "incomplete"}.get(code, f"FAILED, exit {code}")
            seconds = time.monotonic() - begin
            record(self.state, "steps", {step.name: {"seconds": seconds, "ended": ended, "clocks": clocks.ranges()}})
            print(f"== {step.name}: {ended}, {seconds:.0f} s of {step.seconds}", flush=True)
            if code not in (0, MORE):
                failed.append(step.name)
                self.print_errors(step)
        return failed

    def one(self, step: Step, seconds: float) -> int:
        """Run a step for some seconds. Returns its exit code, MORE if it ran out of time."""
        seconds = min(seconds, self.left - MARGIN)
        environment = {**os.environ, "PYTHONUNBUFFERED": "1", "PYTHONPATH": self.path()}
        environment |= {DRY: "1"} if self.dry else {}
        log, errors = (self.state / "logs" / f"{step.name}.{ending}" for ending in ("txt", "err"))
        with log.open("a") as output, errors.open("a") as complaints:
            process = subprocess.Popen(
                step.command(self.state, seconds), stdout=subprocess.PIPE, stderr=complaints, text=True,
                env=environment, cwd=ROOT, start_new_session=True,
            )  # fmt: skip
            over = threading.Event()
            timer = threading.Timer(seconds + MARGIN, _end, [process, over])
            timer.start()
            try:
                assert process.stdout is not None
                for line in process.stdout:
                    output.write(line)
                    print(line, end="", flush=True)
                code = process.wait()
            finally:
                timer.cancel()
                process.stdout.close()
                if process.poll() is None:
                    _end(process, over)
        return MORE if over.is_set() else code

    def print_errors(self, step: Step, lines: int = 12) -> None:
        """Print the last error lines of a step."""
        lines_of_log = (self.state / "logs" / f"{step.name}.err").read_text(errors="replace").splitlines()
        print(*lines_of_log[-lines:], sep="\n", flush=True)

    @staticmethod
    def path() -> str:
        """Search paths of this package, the benchmarks and pointloom."""
        own = [str(ROOT / "benchmarks"), str(ROOT / "src")]
        return os.pathsep.join([*own, *filter(None, [os.environ.get("PYTHONPATH")])])


def _end(process: subprocess.Popen[str], over: threading.Event) -> None:
    """Terminate a step and its child processes."""
    over.set()
    for kind in (signal.SIGTERM, signal.SIGKILL):
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, kind)
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(5)
            return

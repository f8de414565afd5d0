"""Runs the steps within a time limit: each in a process of its own, its words on stdout and in a log, its end noted.

What is noted as done is not done again; a step that ran out of time is begun again by the next run, and goes on where
it ended, since it keeps what it found one by one. A step that failed is left alone until it is asked for by name.
"""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import threading
import time
from collections.abc import Iterable
from pathlib import Path

from gpu_kit.device import DRY, ROOT
from gpu_kit.steps import Step

MORE = 75  # the exit code of a step that has more to do (EX_TEMPFAIL)
MARGIN = 8.0  # seconds that a step has from its own limit to the one at which it is ended


class Run:
    """A run in a folder: marks of steps under done/, their words under logs/, what they found under parts/."""

    def __init__(self, state: Path, seconds: float, *, dry: bool) -> None:
        self.state, self.dry, self.end = state, dry, time.monotonic() + seconds
        for name in ("done", "logs", "parts"):
            (state / name).mkdir(parents=True, exist_ok=True)

    @property
    def left(self) -> float:
        return self.end - time.monotonic()

    def status(self, step: Step) -> str:
        """ "done", "failed", or "" where it has to be done still."""
        mark = self.state / "done" / step.name
        return mark.read_text() if mark.exists() else ""

    def forget(self, step: Step) -> None:
        """Have a step done again, from its beginning."""
        (self.state / "done" / step.name).unlink(missing_ok=True)
        if step.part:
            (self.state / "parts" / f"{step.part}.json").unlink(missing_ok=True)

    def why_not(self, step: Step, pieces: Iterable[str] | None) -> str:
        """Why a step is not done now; empty where it is."""
        if found := self.status(step):
            return f"{found} before"
        if self.dry and not step.in_dry_run:
            return "not in a dry run"
        if not step.is_possible:
            return f"no {step.program} here"
        missing = [] if pieces is None else [piece for piece in step.needs if piece not in pieces]
        if missing:
            return f"waits for {', '.join(missing)}"
        return f"no time left, it wants {step.at_least:.0f} s" if self.left < step.at_least else ""

    def all(self, steps: Iterable[Step], pieces: Iterable[str] | None = None) -> list[str]:
        """Do what can be done; the names of steps that failed."""
        failed = []
        for step in steps:
            if reason := self.why_not(step, pieces):
                print(f"== {step.name}: {reason}", flush=True)
                continue
            begin = time.monotonic()
            code = self.one(step)
            if code != MORE:
                (self.state / "done" / step.name).write_text("failed" if code else "done")
            ended = {0: "done", MORE: "more to do"}.get(code, f"FAILED, exit {code}")
            print(f"== {step.name}: {ended}, {time.monotonic() - begin:.0f} s", flush=True)
            if code not in (0, MORE):
                failed.append(step.name)
                self.print_errors(step)
        return failed

    def one(self, step: Step) -> int:
        """Do a step; its exit code, MORE where its time was over."""
        seconds = min(step.at_most, self.left - MARGIN)
        environment = {**os.environ, "PYTHONUNBUFFERED": "1", "PYTHONPATH": self.path()}
        environment |= {DRY: "1"} if self.dry else {}
        log, errors = (self.state / "logs" / f"{step.name}.{ending}" for ending in ("txt", "err"))
        with log.open("a") as said, errors.open("a") as complaints:
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
                    said.write(line)
                    print(line, end="", flush=True)
                code = process.wait()
            finally:
                timer.cancel()
                process.stdout.close()
                if process.poll() is None:
                    _end(process, over)
        return MORE if over.is_set() else code

    def print_errors(self, step: Step, lines: int = 12) -> None:
        """The end of what a step complained of."""
        said = (self.state / "logs" / f"{step.name}.err").read_text(errors="replace").splitlines()
        print(*said[-lines:], sep="\n", flush=True)

    @staticmethod
    def path() -> str:
        """Where steps find this package, the benchmarks and pointloom."""
        own = [str(ROOT / "benchmarks"), str(ROOT / "src")]
        return os.pathsep.join([*own, *filter(None, [os.environ.get("PYTHONPATH")])])


def _end(process: subprocess.Popen[str], over: threading.Event) -> None:
    """End a step and what it started."""
    over.set()
    for kind in (signal.SIGTERM, signal.SIGKILL):
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, kind)
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(5)
            return

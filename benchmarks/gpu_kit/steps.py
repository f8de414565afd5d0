"""The plan: the steps on a GPU, in order, with their seconds. README.md's tables are written from it (page.py).

A run has 900 s in calls of at most 600 s. The first call has the steps that need no archive, the last one all
others. The calls between them only carry archives.
"""

from __future__ import annotations

import shutil
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

# Seconds of the device: of all calls, of one call, and around the commands
BUDGET, MAX_CALL = 900, 600
START, TRANSFER, UNPACK, RETURN = 90, 25, 20, 25
RUNS, EVERY = (1, 2), 0
BASE = ("warp", "kernels")


@dataclass(frozen=True)
class Step:
    """A step in a separate process.

    Attributes:
        name: Name in logs and marks.
        module: Module of this package. It gets the folder of the run, its seconds and `arguments`.
        seconds: Planned seconds. It may also use the seconds that later steps do not need.
        gives: The result, for README.md.
        run: The run of 900 s that includes it; EVERY for both.
        needs: Required archives (only if they arrive one by one: call.sh).
        program: Required program. The step is skipped without it.
        not_dry: Why a dry run does not include the step. Empty if it does.
        part: Part of the run's document that it writes. It is replaced if the step is repeated.
    """

    name: str
    module: str
    seconds: int
    gives: str
    run: int = 1
    needs: tuple[str, ...] = BASE
    program: str = ""
    not_dry: str = ""
    arguments: tuple[str, ...] = ()
    part: str = ""

    def command(self, state: Path, seconds: float) -> list[str]:
        """The command of the step."""
        return [sys.executable, "-m", f"gpu_kit.{self.module}", str(state), f"{seconds:.0f}", *self.arguments]

    @property
    def is_possible(self) -> bool:
        return not self.program or shutil.which(self.program) is not None


NO_TORCH = "torch has no emulated device"
NO_TOOL = "NVIDIA's tools need a GPU"
MINUTES = "6 CPU minutes per process on the emulated device; tests/emulated_cuda/test_orders.py compares its results"
STEPS = (
    Step("facts", "facts", 5, "GPU, driver, clocks, processor, packages", EVERY, needs=()),
    Step(
        "torch", "torch_constants", 25, "launches, graphs and copies of torch alone", needs=(), not_dry=NO_TORCH
    ),
    Step("questions", "questions", 25, "loops in graphs, threads, bitwise results", part="questions"),
    Step("constants", "constants", 15, "launch, wait, graph node, copies", EVERY, part="constants"),
    Step(
        "exchange", "exchange", 25, "torch, CuPy, JAX arrays; capture in the caller's CUDA graph", part="exchange"
    ),
    Step("times", "measure", 90, "the caller's times without a profiler", arguments=("call",), part="operations"),
    Step("profile", "measure", 60, "device times by kernel", arguments=("device",)),
    Step("compare", "compare", 150, "the same before a change of kernels", needs=(*BASE, "before"), part="comparisons"),
    Step("ncu", "under_tools", 45, "stalls, cache hits, spills", program="ncu", not_dry=NO_TOOL, arguments=("ncu",)),
    Step("peers", "peers", 40, "the same operations in Warp, CuPy and torch", part="peers"),
    Step("frames", "frames", 30, "100 frames and LiDAR scans: median, p99", part="frames"),
    Step("large", "large", 30, "10M and 50M points: time, peak memory", part="large"),
    Step("tests", "suite", 45, "tests of cuda:0, the oldest results first", part="tests"),
    Step(
        "digests", "digests", 100, "bitwise results of all operations, twice and on the CPU", 2, not_dry=MINUTES,
        part="digests",
    ),
    Step(
        "sanitizer", "under_tools", 90, "memory errors and races", 2, program="compute-sanitizer", not_dry=NO_TOOL,
        arguments=("sanitizer",),
    ),
    Step("benchmarks", "benches", 340, "pointloom beside Open3D", 2, needs=(*BASE, "open3d"), part="benchmarks"),
)  # fmt: skip


def steps_of(run: int) -> list[Step]:
    """The steps of a run."""
    return [step for step in STEPS if step.run in (run, EVERY)]


@dataclass(frozen=True)
class Call:
    """A call of the device: its number, the limit of its command [s], and its steps."""

    number: int
    seconds: int
    steps: tuple[Step, ...]

    @property
    def command(self) -> str:
        return f"bash benchmarks/gpu_kit/call.sh build/gpu-kit/{self.number}"


def calls_of(run: int, count: int) -> list[Call]:
    """The calls of a run.

    Args:
        run: Number of the run.
        count: Number of calls that carry the archives, at least 2.

    Raises:
        ValueError: The calls exceed the limits of the device.
    """
    steps = steps_of(run)
    groups = [[step for step in steps if not step.needs], *[[]] * (count - 2), [step for step in steps if step.needs]]
    calls = [Call(k, UNPACK + sum(step.seconds for step in group), tuple(group)) for k, group in enumerate(groups, 1)]
    if max(call.seconds for call in calls) > MAX_CALL or total_seconds(calls) > BUDGET:
        given = f"{[call.seconds for call in calls]} and {total_seconds(calls)} s"
        raise ValueError(
            f"run {run}: expected calls of at most {MAX_CALL} s and {BUDGET} s in all, got {given}. Shorten a step, or "
            "move it to another run"
        )
    return calls


def total_seconds(calls: Sequence[Call]) -> int:
    """Seconds of the device for some calls, with its start and the transfers."""
    return START + sum(call.seconds for call in calls) + TRANSFER * (len(calls) - 1) + RETURN


def plan_table(run: int, count: int = 2) -> str:
    """A run as a table of Markdown."""
    lines = ["| s (cumulated) | call | step | s | result |", "|---|---|---|---|---|"]
    end = START
    lines.append(f"| {end} | | start and first transfer | {START} | |")
    for call in calls_of(run, count):
        if call.number > 1:
            end += TRANSFER
            lines.append(f"| {end} | | transfer | {TRANSFER} | |")
        end += UNPACK
        lines.append(f"| {end} | {call.number} | unpack archives | {UNPACK} | |")
        for step in call.steps:
            end += step.seconds
            lines.append(f"| {end} | {call.number} | {step.name} | {step.seconds} | {step.gives} |")
    lines.append(f"| {end + RETURN} | | results back | {RETURN} | |")
    return "\n".join([*lines, f"| {BUDGET} | | reserve | {BUDGET - end - RETURN} | one repetition |"])


def dry_table() -> str:
    """The steps that a dry run skips, with the reasons, as a table of Markdown."""
    rows = [f"| {step.name} | {step.not_dry} |" for step in STEPS if step.not_dry]
    return "\n".join(["| not in a dry run | reason |", "|---|---|", *rows])

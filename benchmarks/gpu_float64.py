"""What float64 costs on an H200, and on an RTX 4090, which has hardly any units for it: a table, from kept counts.

    python benchmarks/gpu_float64.py            # the newest counts of benchmarks/results
    python benchmarks/gpu_float64.py --write    # into docs/gpu.md

A bound, no prediction: how long an SM's units for float64 are busy with what the warps ask of them, and nothing else.
An SM of an H200 has 64 of them, one of an RTX 4090 two (NVIDIA's white papers on Hopper and Ada), so that a warp's
instruction takes half a cycle there and sixteen here, however few of its lanes are active.
"""

from __future__ import annotations

import argparse
import math
import sys
from pathlib import Path
from typing import Any

from gpu_chips import H200, RTX_4090, Chip
from gpu_machine import FEW
from gpu_page import PAGE
from gpu_prediction import predict
from gpu_results import kept, newest

BEGIN, END = "<!-- gpu_float64: begin -->", "<!-- gpu_float64: end -->"
UNITS = 64  # of a Hopper's SM
CYCLES = 2.0  # of a scheduler that costs.py counts for an instruction of float64
LEAST = 1e-6  # s on the RTX 4090 below which an operation is left out


def seconds(chip: Chip, launch: dict[str, Any]) -> float:
    """How long a GPU's units for float64 are busy with a launch."""
    rounds = launch["blocks"] / chip.sms
    rounds = rounds if rounds > FEW else math.ceil(rounds)
    warps = rounds * -(-launch["threads"] // 32)
    return warps * instructions_of_warp(launch) * 32 / (UNITS / chip.fp64_cycles) / chip.clock


def instructions_of_warp(launch: dict[str, Any]) -> float:
    """Instructions of float64 that a warp gives out, in the mean; divisions and roots are sequences of them."""
    return launch["units"].get("fp64", 0.0) / CYCLES


def kernels_of(counts: dict[str, Any]) -> dict[str, tuple[float, float, float]]:
    """Of each kernel: millions of a warp's instructions, and seconds on both."""
    found: dict[str, tuple[float, float, float]] = {}
    for x in counts["launches"]:
        if not x.get("units", {}).get("fp64"):
            continue
        times = x.get("times", 1)
        total = x["blocks"] * -(-x["threads"] // 32) * instructions_of_warp(x)
        one = total / 1e6, seconds(H200, x), seconds(RTX_4090, x)
        before = found.get(x["kernel"], (0.0, 0.0, 0.0))
        found[x["kernel"]] = tuple(a + times * b for a, b in zip(before, one, strict=True))  # type: ignore[assignment]
    return found


def table(all_counts: list[dict[str, Any]]) -> list[str]:
    """One line an operation, that with most float64 first."""
    rows = []
    for counts in all_counts:
        kernels = kernels_of(counts)
        if not kernels:
            continue
        millions, ours, theirs = (sum(k[i] for k in kernels.values()) for i in range(3))
        most = max(kernels, key=lambda name: kernels[name][2])
        if theirs >= LEAST:
            whole = predict(counts).timeline.device
            name = f"{counts['operation']} | {counts['size']:,} | {millions:.3g}M"
            row = f"| {name} | {1e3 * ours:.2g} | {1e3 * whole:.3g} | {1e3 * theirs:.3g} | {most} |"
            rows.append((theirs / whole, row))
    head = "operation | size | warp instructions of float64 | H200, ms for them | H200, ms in all"
    lines = [f"| {head} | RTX 4090, ms for them | most in |", "|---|---|---|---|---|---|---|"]
    return lines + [row for _, row in sorted(rows, reverse=True)]


def main() -> int:
    """Print the table, or write it."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--read", type=Path, metavar="FILE", help="counts that gpu_model.py --save has kept")
    parser.add_argument("--write", action="store_true", help="into docs/gpu.md")
    given = parser.parse_args()
    lines = table(kept(given.read) if given.read else newest())
    print("\n".join(lines))
    if given.write:
        before, rest = PAGE.read_text().split(BEGIN)
        after = rest.split(END)[1]
        PAGE.write_text("\n".join([before + BEGIN, *lines, END]) + after)
    return 0


if __name__ == "__main__":
    sys.exit(main())

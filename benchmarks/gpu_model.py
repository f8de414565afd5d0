"""Predict what operations would take on a GPU, from counts, as a table.

    python benchmarks/gpu_model.py [NAME ...] [--sizes 200k 1M] [--chip h200] [--save FILE | --write]
    python benchmarks/gpu_model.py --read benchmarks/results/gpu-model-before.json
    python benchmarks/gpu_model.py normals_k30 --sizes 200k --lines     # and the source lines that cost most

Each operation runs on the emulated device in a process of its own (gpu_counts.py), which counts what its warps ran and
what they asked of memory; gpu_machine.py makes seconds of that. A model, no
measurement: `make gpu-run` measures. --save keeps the counts, --read predicts from kept ones, and --write keeps them in
benchmarks/results and writes the tables of docs/gpu.md.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from gpu_chips import CHIPS, chip_named
from gpu_cubins import ARCHITECTURE
from gpu_host import measured_hosts
from gpu_operation import SIZES
from gpu_operations import OPERATIONS
from gpu_page import write_page
from gpu_prediction import Predicted, predict
from gpu_results import keep, kept, todays_file
from real_data import DataMissingError

HERE = Path(__file__).parent
UNITS = {"k": 1_000, "M": 1_000_000}


def _short(x: float) -> str:
    for limit, unit in ((1e9, "G"), (1e6, "M"), (1e3, "k")):
        if x >= limit:
            return f"{x / limit:.3g}{unit}"
    return f"{x:.3g}"


def _print_breakdown(found: Predicted) -> None:
    """One line a kernel, the slowest first."""
    head = f"{'kernel':34}{'launches':>9}{'us':>9}  {'bound by':13}{'warp instr':>11}{'active':>8}{'sect/req':>9}"
    print(head + f"{'L2 B':>8}{'mem B':>8}{'lost B':>8}{'local B':>8}{'regs':>6}{'stack':>6}{'occ.':>7}")
    for name, row in sorted(found.rows.items(), key=lambda item: -item[1].seconds):
        bound = max(row.bounds, key=lambda k: row.bounds[k]) if row.bounds else "-"
        print(
            f"{name[:33]:34}{row.launches:9}{1e6 * row.seconds:9.1f}  {bound:13}{_short(row.instructions):>11}"
            f"{100 * row.active:7.0f}%{row.sectors_a_request:9.1f}{_short(row.l2_bytes):>8}"
            f"{_short(row.memory_bytes):>8}{_short(row.lost_bytes):>8}{_short(row.local_bytes):>8}"
            f"{row.registers:6}{row.spilled:6}{100 * row.occupancy:6.1f}%"
        )


def _print_summary(found: Predicted) -> None:
    """The call as a whole."""
    counts, timeline = found.counts, found.timeline
    operation, size, host = OPERATIONS[counts["operation"]], counts["size"], counts["host"]
    bar = f", bar {operation.bar} ms at {operation.bar_size:,}" if operation.bar else ""
    print(
        f"\n{operation.name}, {size:,}, {found.chip.title}: predicted {1e3 * timeline.device:.3f} ms on the device, "
        f"{1e3 * timeline.call:.3f} ms for the caller (a model){bar}; limit {1e3 * operation.limit(size):.4f} ms"
    )
    print(f"  host: {', '.join(f'{count} {name}' for name, count in host.items() if count)}")


def _print_lines(lines: list[dict[str, Any]]) -> None:
    """The source lines that give out most instructions."""
    for x in lines:
        active = 100 * x["lane_statements"] / (32 * x["statements"]) if x.get("statements") else 0
        sectors = x.get("sectors", 0) / x["requests"] if x.get("requests") else 0
        numbers = f"{_short(x.get('instructions', 0)):>7}{active:5.0f}%{_short(x.get('requests', 0)):>8}{sectors:6.1f}"
        print(f"  {numbers}  {x['place'][-44:]:44}  {x.get('text', '')[:70]}")


def print_call(found: Predicted) -> None:
    """A call, then its kernels."""
    _print_summary(found)
    _print_breakdown(found)
    sys.stdout.flush()


def counted(name: str, size: int, how: list[str]) -> dict[str, Any]:
    """The counts of one call, from a process of its own; `how` are its last arguments."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "counts.json"
        command = [sys.executable, str(HERE / "gpu_counts.py"), name, str(size), str(out), *how]
        subprocess.run(command, check=True)
        return kept(out)[0]


def _size(text: str) -> int:
    return int(float(text[:-1]) * UNITS[text[-1]]) if text[-1] in UNITS else int(text)


def _runs(names: list[str], sizes: list[int] | None) -> Iterator[tuple[str, int]]:
    for name in names or OPERATIONS:
        own = OPERATIONS[name].sizes
        for size in sizes if sizes and (own == SIZES or set(sizes) <= set(own)) else own:
            yield name, size


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("operations", nargs="*", metavar="NAME", help=f"of {', '.join(OPERATIONS)}; all")
    parser.add_argument("--sizes", nargs="+", type=_size, metavar="N", help="points, as 200k or 1M")
    parser.add_argument("--save", type=Path, metavar="FILE", help="add the counts to this file")
    parser.add_argument("--read", type=Path, metavar="FILE", help="run nothing: predict from this file")
    parser.add_argument(
        "--write", action="store_true", help="keep the counts and write docs/gpu.md; with --read, write alone"
    )
    parser.add_argument("--lines", action="store_true", help="also lines: instructions, active, requests, sectors each")
    parser.add_argument(
        "--fast", action="store_true", help="run only what is counted of kernels whose results end the call"
    )
    parser.add_argument("--chip", choices=CHIPS, default="h200", help="the GPU (h200)")
    return parser.parse_args()


def _is_possible(name: str) -> bool:
    """Whether the data are there that an operation wants."""
    try:
        if (needs := OPERATIONS[name].needs) is not None:
            needs()
    except DataMissingError as error:
        print(f"{name}: left out: {error}", file=sys.stderr)
        return False
    return True


def main() -> int:
    """Run the operations that are asked for; the exit status."""
    given = _options()
    chip, hosts = chip_named(given.chip), measured_hosts()
    file, failures = todays_file() if given.write else given.save, 0
    how = ["lines"] * given.lines + ["fast"] * given.fast
    wanted = {89} if given.write else {chip.architecture} - {ARCHITECTURE}  # the page has an RTX 4090's times too
    how += [str(architecture) for architecture in sorted(wanted)]
    if given.read:
        for counts in kept(given.read):
            if not given.operations or counts["operation"] in given.operations:
                print_call(predict(counts, chip, hosts.get(counts["operation"])))
        if given.write:
            write_page()
        return 0
    for name, size in _runs(given.operations, given.sizes):
        if not _is_possible(name):
            continue
        try:
            counts = counted(name, size, how)
        except subprocess.CalledProcessError as error:
            print(f"{name}, {size:,}: failed, {error}", file=sys.stderr)
            failures += 1
            continue
        print_call(predict(counts, chip, hosts.get(name)))
        _print_lines(counts.pop("lines", []))
        if file:
            keep(file, counts)
    if given.write:
        write_page()
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())

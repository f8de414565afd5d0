"""Write the tables of docs/gpu.md from the saved runs: python benchmarks/gpu_kit/page.py [--check].

Of several runs of a chip the newest one that has a row counts, by date.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "benchmarks"))
from pages import replaced_between  # noqa: E402

from gpu_kit.documents import saved_runs  # noqa: E402

PAGE = ROOT / "docs" / "gpu.md"
CONSTANTS = {  # name of a constant: description, unit and divisor of the value
    "HOST_LAUNCH": ("launch of a kernel, of the host", "us", 1e-6),
    "WAIT": ("synchronization", "us", 1e-6),
    "GRAPH_NODE": ("node of a graph", "us", 1e-6),
    "LOOP_TURN": ("iteration of a loop on the device", "us", 1e-6),
    "MEMORY_BANDWIDTH": ("copy in device memory, read and written", "GB/s", 1e9),
    "L2_BANDWIDTH": ("copy in the L2 cache", "GB/s", 1e9),
    "LINK_PINNED": ("to pinned host memory", "GB/s", 1e9),
    "to host, reused": ("to host memory that was used before", "GB/s", 1e9),
    "to host, fresh, mapped by threads": ("to new host memory, by pointloom", "GB/s", 1e9),
    "LINK_FRESH": ("to new host memory, by Warp", "GB/s", 1e9),
    "LINK_PAGEABLE": ("from host memory", "GB/s", 1e9),
}


def merged(documents: list[dict[str, Any]], *path: str) -> dict[str, Any]:
    """The entries of a part of all runs: of each name the newest one, of entries with fields each field's newest."""
    result: dict[str, Any] = {}
    for document in documents:
        part: Any = document
        for name in path:
            part = part.get(name, {})
        for name, entry in part.items():
            result[name] = result.get(name, {}) | entry if isinstance(entry, dict) else entry
    return result


def constants(documents: list[dict[str, Any]]) -> list[str]:
    values = merged(documents, "constants")
    rows = [
        f"| {text} | {values[name] / unit:,.1f} {label} |"
        for name, (text, label, unit) in CONSTANTS.items()
        if name in values
    ]
    return ["| | |", "|---|---|", *rows]


def beside(documents: list[dict[str, Any]]) -> list[str]:
    lines = ["| operation | size | pointloom, ms | Open3D CUDA, ms | ratio |", "|---|---|---|---|---|"]
    for name, rows in sorted(merged(documents, "benchmarks", "operations").items()):
        times = {(row["size"], row["peer"]): row["best_ms"] for row in rows if "error" not in row}
        for size in dict.fromkeys(size for size, _ in times):
            own, other = times.get((size, "pointloom")), times.get((size, "open3d-tensor"))
            if own and other:
                lines.append(f"| {name} | {size} | {own:.2f} | {other:.2f} | {other / own:.2f} |")
    return lines


def operations(documents: list[dict[str, Any]]) -> list[str]:
    lines = [
        "| operation | size | call, ms | device, ms | launches | longest on the device |",
        "|---|---|---|---|---|---|",
    ]
    for key, row in sorted(merged(documents, "operations").items()):
        if "kernels" not in row or "best_ms" not in row:
            continue
        name, size = key.rsplit(" ", 1)
        longest = row["kernels"][0]
        kernel = "sorts and scans of CUB" if "cub::" in longest["kernel"] else longest["kernel"]
        what = f"{kernel}, {longest['us'] / 1e3:.2f} ms"
        cells = (
            name,
            f"{int(size):,}",
            f"{row['best_ms']:.2f}",
            f"{row['device_ms']:.2f}",
            f"{row['launches']:,}",
            what,
        )
        lines.append("| " + " | ".join(cells) + " |")
    return lines


def boxes(documents: list[dict[str, Any]]) -> list[str]:
    """The searches with one box and two boxes per eight lanes."""
    lines = ["| operation | points | one box, ms | two boxes, ms | ratio |", "|---|---|---|---|---|"]
    rows = merged(documents, "comparisons", "two boxes per eight lanes")
    for key, row in sorted(rows.items(), key=lambda entry: (entry[0].split()[0], int(entry[0].split()[1]))):
        name, size = key.split()
        before, after = row["before_ms"], row["after_ms"]
        lines.append(f"| {name} | {int(size):,} | {before:.2f} | {after:.2f} | {before / after:.2f} |")
    return lines


def main() -> int:
    documents, page = saved_runs(), PAGE.read_text()
    for name, make in (("constants", constants), ("beside", beside), ("operations", operations), ("boxes", boxes)):
        page = replaced_between(page, name, "\n".join(make(documents)))
    if "--check" in sys.argv:
        if page != PAGE.read_text():
            print(f"{PAGE.name} differs from benchmarks/results: run python benchmarks/gpu_kit/page.py")
            return 1
        return 0
    PAGE.write_text(page)
    return 0


if __name__ == "__main__":
    sys.exit(main())

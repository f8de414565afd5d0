"""Write the tables of docs/gpu.md and the sentence of the first page from the saved runs, and the plan of the kit:

    python benchmarks/gpu_kit/page.py [--check]

Each chip has tables of its own. Of several runs of a chip the newest one that has a row counts, by date.
"""

from __future__ import annotations

import sys
import textwrap
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
OWN = Path(__file__).resolve().parent  # of a script, on the path: its modules have names of other modules
sys.path[:] = [str(ROOT / "benchmarks"), *(path for path in sys.path if Path(path).resolve() != OWN)]
from pages import replaced_between  # noqa: E402

from gpu_kit.compare import CHANGES, compared  # noqa: E402
from gpu_kit.documents import chip_of_run, last_measured, saved_runs  # noqa: E402
from gpu_kit.steps import RUNS, STEPS, dry_table, plan_table  # noqa: E402

PAGE, FIRST_PAGE, README = ROOT / "docs" / "gpu.md", ROOT / "README.md", Path(__file__).parent / "README.md"
NEVER = ("", "")
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


def runs(documents: list[dict[str, Any]]) -> list[str]:
    """The GPU, the commit and the date of each run."""
    return [f"{run['device']['name']}, commit {run['commit'][:8]}, {run['date'][:10]}." for run in documents]


def times_beside(documents: list[dict[str, Any]]) -> list[tuple[str, str, float, float]]:
    """Operation, size, and the times of pointloom and of Open3D's CUDA code [ms]."""
    result = []
    for name, rows in sorted(merged(documents, "benchmarks", "operations").items()):
        times = {(row["size"], row["peer"]): row["best_ms"] for row in rows if "error" not in row}
        for size in dict.fromkeys(size for size, _ in times):
            own, other = times.get((size, "pointloom")), times.get((size, "open3d-tensor"))
            if own and other:
                result.append((name, size, own, other))
    return result


def beside(documents: list[dict[str, Any]]) -> list[str]:
    lines = ["| operation | size | pointloom, ms | Open3D CUDA, ms | ratio |", "|---|---|---|---|---|"]
    for name, size, own, other in times_beside(documents):
        lines.append(f"| {name} | {size} | {own:.2f} | {other:.2f} | {other / own:.2f} |")
    return lines


def summary(documents: list[dict[str, Any]]) -> str:
    """The sentence of the first page about GPUs: of the chip that was measured last beside Open3D."""
    documents = next(runs_of_chip for runs_of_chip in of_chips(documents).values() if times_beside(runs_of_chip))
    rows, run = times_beside(documents), documents[-1]
    ahead = sum(other >= own for _, _, own, other in rows)
    return textwrap.fill(
        f"On one {run['device']['name']}, pointloom is ahead of Open3D's CUDA code in {ahead} of {len(rows)} rows "
        f"({run['date'][:10]}, commit {run['commit'][:8]}, [gpu](docs/gpu.md)).",
        120,
        break_on_hyphens=False,
    )


def operations(documents: list[dict[str, Any]]) -> list[str]:
    lines = [
        "| operation | size | call, ms | device, ms | launches | longest on the device |",
        "|---|---|---|---|---|---|",
    ]
    for key, row in sorted(merged(documents, "operations").items()):
        if "best_ms" not in row:
            continue
        name, size = key.rsplit(" ", 1)
        device = ["-"] * 3
        if "kernels" in row:
            longest = row["kernels"][0]
            kernel = "sorts and scans of CUB" if "cub::" in longest["kernel"] else longest["kernel"]
            device = [f"{row['device_ms']:.2f}", f"{row['launches']:,}", f"{kernel}, {longest['us'] / 1e3:.2f} ms"]
        cells = (name, f"{int(size):,}", f"{row['best_ms']:.2f}", *device)
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


NOT_YET = ["Not measured yet."]


def measured(documents: list[dict[str, Any]], *part: str) -> dict[str, Any]:
    """The results of a part without errors and skipped ones."""
    rows = merged(documents, *part)
    return {name: row for name, row in sorted(rows.items()) if not {"error", "skipped"} & set(row)}


def table(headings: str, rows: list[list[str]]) -> list[str]:
    """A table of Markdown, or a sentence if there are no rows."""
    names = headings.split(", ")
    return [f"| {' | '.join(cells)} |" for cells in (names, ["---"] * len(names), *rows)] if rows else NOT_YET


def libraries(documents: list[dict[str, Any]]) -> list[str]:
    """Operations beside the libraries of peers.py."""
    rows = []
    for key, row in measured(documents, "peers").items():
        operation, _, peer = key.partition(" beside ")
        name, size = operation.rsplit(" ", 1)
        own, other = row["best_ms"]["pointloom"], row["best_ms"][peer]
        rows.append([name, f"{int(size):,}", peer, f"{own:.2f}", f"{other:.2f}", f"{other / own:.2f}"])
    return table("operation, size, library, pointloom [ms], library [ms], ratio", rows)


def sequences(documents: list[dict[str, Any]]) -> list[str]:
    """The distribution of the times of frames."""
    rows = [
        [name, str(row["frames"]), *(f"{row[field]:.2f}" for field in ("median_ms", "p99_ms", "max_ms", "first_ms"))]
        for name, row in measured(documents, "frames").items()
    ]
    return table("sequence, frames, median [ms], p99 [ms], maximum [ms], first frame [ms]", rows)


def large_clouds(documents: list[dict[str, Any]]) -> list[str]:
    """Time and peak memory of large clouds."""
    rows = []
    for key, row in measured(documents, "large").items():
        name, size = key.rsplit(" ", 1)
        rows.append([name, f"{int(size):,}", f"{row['best_ms']:.1f}", f"{row['peak bytes per point']:.1f}"])
    return table("operation, points, call [ms], peak bytes per point beyond the cloud", rows)


def changes(documents: list[dict[str, Any]]) -> list[str]:
    """Times before and after the changes of compare.py."""
    rows = []
    for name, row in measured(documents, "comparisons").items():
        for key, times in (compared(row["laps"]) if "laps" in row else {}).items():
            cells = []
            for kind in ("call", "device"):
                before, after = times.get(kind, (0.0, 0.0))
                cells += [f"{before:.2f}", f"{after:.2f}", f"{before / after:.2f}"] if after else ["-"] * 3
            rows.append([name, *key.rsplit(" ", 1), *cells])
    times = "before [ms], after [ms], ratio"
    return table(f"change, operation, size, call {times}, device {times}", rows)


def of_chips(documents: list[dict[str, Any]]) -> dict[str, list[dict[str, Any]]]:
    """The runs of each chip, the chip with the newest run first."""
    groups: dict[str, list[dict[str, Any]]] = {}
    for run in reversed(documents):
        groups.setdefault(chip_of_run(run), []).insert(0, run)
    return groups


def by_chip(make: Callable[[list[dict[str, Any]]], list[str]], documents: list[dict[str, Any]]) -> list[str]:
    """The lines of each chip, below its name if there are several."""
    groups = of_chips(documents)
    lines = []
    for runs_of_chip in groups.values():
        heading = [f"**{runs_of_chip[-1]['device']['name']}**", ""] if len(groups) > 1 else []
        lines += [*([""] if lines else []), *heading, *make(runs_of_chip)]
    return lines


def dated(rows: list[str], *part: str, chip: str, field: str = "") -> dict[tuple[str, str], list[str]]:
    """Rows by the date and commit of their newest measurement on a chip."""
    known = last_measured(*part, chip=chip, field=field)
    groups: dict[tuple[str, str], list[str]] = {}
    for row in rows:
        groups.setdefault(known.get(row, NEVER), []).append(row)
    return groups


def ages(documents: list[dict[str, Any]]) -> list[str]:
    """When each row was measured last on the chip of these runs, the oldest first: the order of its next run."""
    from gpu_operations import OPERATIONS

    from gpu_kit.benches import on_gpu
    from gpu_kit.peers import PEERS, key_of
    from gpu_kit.suite import STAGES

    sizes = [(o.name, f"{o.name} {size}") for o in OPERATIONS.values() for size in o.sizes]
    large = [f"{o.name} {size}" for o in OPERATIONS.values() for size in o.large]
    of = partial(dated, chip=chip_of_run(documents[-1]))
    written = {"times", "profile", "benchmarks", "large", "peers", "compare", "tests"}
    groups = {
        "times of the caller": of([key for _, key in sizes], "operations", field="best_ms"),
        "device times": of([key for _, key in sizes], "operations", field="device_ms"),
        "beside Open3D on the GPU": of(on_gpu(), "benchmarks", "operations"),
        "large clouds": of(large, "large"),
        "beside other libraries": of([key_of(peer) for peer in PEERS], "peers"),
        "before and after a change": of([change.name for change in CHANGES], "comparisons"),
        "tests": of(list(STAGES), "tests", "stages"),
    }
    parts = last_parts(documents)
    for step in STEPS:
        if step.part and step.name not in written:
            groups.setdefault("steps", {}).setdefault(parts.get(step.part, NEVER), []).append(step.name)
    lines = ["| measurement | rows | date | commit |", "|---|---|---|---|"]
    for what, by_date in groups.items():
        for (date, commit), rows in sorted(by_date.items()):
            lines.append(f"| {what} | {shortened(rows)} | {date[:10] or 'never'} | {commit or '-'} |")
    return lines


def last_parts(documents: list[dict[str, Any]]) -> dict[str, tuple[str, str]]:
    """Date and commit of the newest run with each part."""
    return {name: (run["date"], run["commit"][:7]) for run in documents for name in run}


def shortened(rows: list[str]) -> str:
    """Rows of a name and a size as one entry per name: "tree 200000, 1000000"."""
    sizes: dict[str, list[str]] = {}
    for row in rows:
        name, _, size = row.rpartition(" ")
        if name and size.isdigit():
            sizes.setdefault(name, []).append(size)
        else:
            sizes.setdefault(row, [])
    return ", ".join(" ".join([name, *(f"{int(size):,}" for size in each)]) for name, each in sizes.items())


TABLES = {
    "runs": runs,
    "constants": constants,
    "beside": beside,
    "operations": operations,
    "libraries": libraries,
    "sequences": sequences,
    "large": large_clouds,
    "changes": changes,
    "boxes": boxes,
    "ages": ages,
}


def pages() -> dict[Path, str]:
    """The generated pages."""
    documents, page, readme = saved_runs(), PAGE.read_text(), README.read_text()
    for name, make in TABLES.items():
        page = replaced_between(page, name, "\n".join(by_chip(make, documents)))
    for run in RUNS:
        readme = replaced_between(readme, f"run {run}", plan_table(run))
    return {
        PAGE: page,
        FIRST_PAGE: replaced_between(FIRST_PAGE.read_text(), "gpu", summary(documents)),
        README: replaced_between(readme, "dry", dry_table()),
    }


def main() -> int:
    for path, text in pages().items():
        if text == path.read_text():
            continue
        if "--check" in sys.argv:
            print(f"{path.relative_to(ROOT)} is outdated: run python benchmarks/gpu_kit/page.py")
            return 1
        path.write_text(text)
    return 0


if __name__ == "__main__":
    sys.exit(main())

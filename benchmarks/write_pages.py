"""Write the tables of README.md and docs/measured.md from the saved runs in benchmarks/results.

    python benchmarks/write_pages.py [--check]

`--check` writes nothing. The exit code is then 1 if a page differs from the saved runs. The page names the commit of
the run: `git log COMMIT.. -- FILE` lists the changes of a module since.
"""

from __future__ import annotations

import argparse
import datetime
import json
import math
import statistics
import sys
import textwrap
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from pages import replaced_between
from targets import REASONS

FOLDER = Path(__file__).resolve().parent
ROOT = FOLDER.parent
OPERATIONS = "operations-cpu.json"  # the saved run of `make bench`
README, MEASURED = ROOT / "README.md", ROOT / "docs" / "measured.md"

# Of the README: (operation, size) and their texts. The rows in which pointloom is furthest behind follow.
SHOWN = {
    ("voxel_down_sample", "1M"): ("voxel down-sampling, 2 cm", "1M points"),
    ("normals_hybrid", "1M"): ("hybrid normals, 30 within r", "1M"),
    ("orient_consistently", "200k"): ("consistent orientation", "200k"),
    ("statistical_outliers", "1M"): ("statistical outliers, 20 neighbors", "1M"),
    ("segment_plane", "1M"): ("plane, 1000 samples", "1M"),
    ("cloud_distance", "1M"): ("distance to another cloud", "1M"),
    ("icp_plane", "200k"): ("point-to-plane ICP, one of 20 steps with all set-up", "200k"),
    ("register_globally", "200k, 5 cm"): ("global registration", "200k"),
    ("tsdf_integrate", "30 frames"): ("TSDF integration, 1 cm", "640 x 480"),
    ("poisson", "200k, depth 9"): ("Poisson surface, depth 9", "200k"),
}
BEHIND = 2  # operations in which pointloom is furthest behind, with their lowest rows
MONTHS = "January February March April May June July August September October November December"


def load(name: str) -> dict[str, Any]:
    """A saved run."""
    return json.loads((FOLDER / "results" / name).read_text())


def milliseconds(seconds: float) -> str:
    """A time with three digits: 12.3 ms, or 1.23 s from a second on."""
    value, unit = (seconds, "s") if seconds >= 1 else (1000 * seconds, "ms")
    digits = max(0, 2 - math.floor(math.log10(value))) if value > 0 else 0
    return f"{value:.{digits}f} {unit}"


def times(ratio: float) -> str:
    """A ratio with two digits, or as a whole number from 10 on."""
    return f"{ratio:.0f}" if ratio >= 10 else f"{ratio:.2g}" if ratio < 1 else f"{ratio:.1f}"


def day(about: dict[str, Any]) -> str:
    """The date of a run in words."""
    date = datetime.datetime.fromisoformat(about["date"])
    return f"{date.day} {MONTHS.split()[date.month - 1]} {date.year}"


def computer(about: dict[str, Any]) -> str:
    """The processor of a run."""
    machine = about["machine"]
    return f"{machine['threads']} cores ({machine['cpu']})"


def cells(row: dict[str, Any]) -> list[str]:
    """pointloom's time, the best baseline with its time, and the ratio."""
    contestants, best = row["contestants"], row["best_peer"]
    own, peer = contestants["pointloom"]["min_s"], contestants[best]["min_s"]
    return [milliseconds(own), f"{best} {milliseconds(peer)}", times(row["ratio"])]


def filled(text: str) -> str:
    """A paragraph in lines of 120 characters."""
    return textwrap.fill(text, 120, break_long_words=False, break_on_hyphens=False)


def line(texts: list[str]) -> str:
    """A line of a Markdown table."""
    return f"| {' | '.join(texts)} |"


def compared(run: dict[str, Any]) -> list[dict[str, Any]]:
    """The rows that have a baseline."""
    return [row for row in run["results"] if "ratio" in row]


def readme_table(run: dict[str, Any]) -> str:
    """The selected rows and those in which pointloom is furthest behind."""
    rows = {(row["operation"], row["size"]): row for row in compared(run)}
    lowest = sorted((row["ratio"], key) for key, row in rows.items() if key not in SHOWN and row["ratio"] < 1)
    first = {key[0]: key for _, key in reversed(lowest)}  # the lowest row of each operation
    furthest = sorted(first.values(), key=lambda key: rows[key]["ratio"])[:BEHIND]
    behind = {key: (f"`{key[0]}`", key[1]) for key in furthest}
    ahead = sum(row["ratio"] >= 1 for row in rows.values())
    threads = run["machine"]["threads"]
    text = (
        f"Times beside the fastest other library on {computer(run)}, all with {threads} threads, one run of `make "
        f"bench` on {day(run)} (commit {run['commit'][:8]}). The ratio is baseline / pointloom. pointloom is ahead in "
        f"{ahead} of {len(rows)} rows. The last rows below are the operations in which it is furthest behind. All "
        "rows, with memory and the reasons of those behind: [docs/measured.md](docs/measured.md)."
    )
    shown = [(rows[key], *texts) for key, texts in (SHOWN | behind).items()]
    lines = [filled(text), ""]
    lines += ["| operation | size | pointloom | best baseline | ratio |", "|---|---|---|---|---|"]
    return "\n".join([*lines, *(line([name, size, *cells(row)]) for row, name, size in shown)])


def memory(row: dict[str, Any]) -> str:
    """Peak memory of pointloom and of the best baseline [MB]; empty if not measured."""
    values = [row["contestants"][label]["peak_memory_bytes"] for label in ("pointloom", row["best_peer"])]
    return " / ".join(f"{value / 1e6:.0f}" for value in values) if None not in values else ""


def measured_table(run: dict[str, Any]) -> str:
    """All rows, and the reasons of those below their target or behind.

    Raises:
        ValueError: A row is behind or below its target, and the operation has no reason.
    """
    rows = compared(run)
    text = (
        f"One run of `make bench` on {day(run)} ({run['seconds'] / 60:.0f} minutes, commit {run['commit'][:8]}), on "
        f"{computer(run)}. Every program has {run['machine']['threads']} threads. Times are the best of several "
        "rounds. The ratio is baseline / pointloom. Memory is the peak above the data (pointloom / baseline)."
    )
    lines = [filled(text), ""]
    lines += [
        "| operation | size | pointloom | best baseline | ratio | target | memory [MB] |",
        "|---|---|---|---|---|---|---|",
    ]
    below = []
    for row in rows:
        target = row["target"]
        texts = [f"`{row['operation']}`", row["size"], *cells(row), f"{target:g}" if target else "", memory(row)]
        lines.append(line(texts))
        if row["ratio"] < (target or 1):
            below.append((row["operation"], row["size"]))
    if missing := [f"{operation} {size}" for operation, size in below if (operation, size) not in REASONS]:
        raise ValueError(
            f"{'; '.join(missing)}: behind or below a target; expected an entry in the `reasons` of the operation "
            "(benchmarks/bench_*.py)"
        )
    ahead = sum(row["ratio"] >= 1 for row in rows)
    lines += ["", filled(f"pointloom is ahead in {ahead} of {len(rows)} rows. {medians(run)}"), ""]
    lines += ["Rows behind, or below their target:", ""]
    lines += ["| operation | size | reason |", "|---|---|---|"]
    lines += [line([f"`{operation}`", size, REASONS[operation, size]]) for operation, size in below]
    if failed := run["problems"]["failed"]:
        lines += ["", "Baselines without a time, because they failed or their results differ:", ""]
        lines += [f"- {text}" for text in failed]
    return "\n".join(lines)


def medians(run: dict[str, Any]) -> str:
    """The median of the ratios on this processor and on others, beside the best baseline of each."""
    texts = [f"The median of the ratios is {times(statistics.median(row['ratio'] for row in compared(run)))}"]
    for cpu, about in run.get("other_processors", {}).items():
        texts.append(
            f"{times(about['median'])} on {cpu} ({day(about)}, commit {about['commit'][:8]}, ahead in "
            f"{about['ahead']} of {about['rows']})"
        )
    return ", and ".join(texts) + "."


def growth_beside_tables(run: dict[str, Any]) -> Iterator[str]:
    """The sentence about the run, and for each operation the lines of pointloom and of the fastest other library."""
    about = run["about"]
    counts = sorted({int(count) for row in run["rows"].values() for sizes in row.values() for count in sizes})
    yield filled(
        f"The best of up to six calls on {computer(about)}, {day(about)} (commit {about['commit'][:8]}): `python "
        "benchmarks/growth.py`. The other library is the best baseline of `make bench`. "
        "The exponent p of n^p is that between the last two sizes of a line. Memory is the peak beside the "
        "data at the largest size of both. A library leaves before a size that would take more than "
        f"{about['limit']:g} s."
    )
    yield ""
    yield line(["operation", "library", *(short(count) for count in counts), "exponent", "memory [MB]"])
    yield "|" + "---|" * (len(counts) + 4)
    for name, row in run["rows"].items():
        done = {
            label: {int(count): value for count, value in sizes.items() if "error" not in value}
            for label, sizes in row.items()
        }
        others = [label for label, sizes in done.items() if label != "pointloom" and sizes]
        best = min(others, key=lambda label: (-max(done[label]), done[label][max(done[label])]["seconds"]))
        common = max(set(done["pointloom"]) & set(done[best]))
        for label in ("pointloom", best):
            sizes = done[label]
            texts = [milliseconds(sizes[count]["seconds"]) if count in sizes else "" for count in counts]
            last = sorted(sizes)[-2:]
            p = math.log(sizes[last[1]]["seconds"] / sizes[last[0]]["seconds"]) / math.log(last[1] / last[0])
            yield line([
                f"`{name}`" if label == "pointloom" else "", label, *texts, f"{p:.2f}",
                f"{sizes[common]['bytes'] / 1e6:.0f}",
            ])  # fmt: skip


def short(count: int) -> str:
    return f"{count // 10**6}M" if count >= 10**6 else f"{count // 1000}k"


def threads_tables(run: dict[str, Any]) -> Iterator[str]:
    """The sentence about the run, and the speed-ups from one to two threads, the least first."""
    about = run["about"]
    yield filled(
        f"The best of some calls each on {computer(about)}, {day(about)} (commit {about['commit'][:8]}): `python "
        "benchmarks/threads.py`. The serial part is that of Amdahl's law, 2 / speed-up - 1 of the time of one thread."
    )
    yield ""
    yield line(["operation", "size", "one thread", "two threads", "speed-up", "serial part", "best baseline"])
    yield "|---|---|---|---|---|---|---|"
    rows = []
    for name, row in run["rows"].items():
        one, two = row["seconds"]["pointloom"]
        peer = row["seconds"][row["peer"]]
        other = f"{row['peer']} {peer[0] / peer[1]:.2f}" if None not in peer else row["peer"]
        serial = f"{max(2 * two / one - 1, 0):.0%}".replace("%", " %")
        times_of = [milliseconds(one), milliseconds(two), f"{one / two:.2f}"]
        rows.append((one / two, [f"`{name}`", row["size"], *times_of, serial, other]))
    yield from (line(texts) for _, texts in sorted(rows))


def growth_tables(run: dict[str, Any]) -> Iterator[str]:
    """The sentence about the run, and the table of growth."""
    largest = max(size["count"] for row in run["rows"] for size in row.get("sizes", ()))
    counts = [f"{largest // 4**step:,}" for step in (3, 2, 1, 0)]
    yield f"One call each on {computer(run['about'])}, {day(run['about'])}: `python benchmarks/scale.py`."
    yield ""
    yield line(["operation", *(f"{count} [s]" for count in counts), "exponent", "memory [MB]", "exponent"])
    yield "|---|---|---|---|---|---|---|---|"
    for row in run["rows"]:
        if "error" in row:
            yield line([f"`{row['operation']}`", row["error"], "", "", "", "", "", ""])
            continue
        sizes = row["sizes"]
        seconds = [f"{size['seconds']:.3f}" for size in sizes]
        exponents = [exponent([size[key] for size in sizes]) for key in ("seconds", "bytes")]
        yield line([f"`{row['operation']}`", *seconds, exponents[0], f"{sizes[-1]['bytes'] / 1e6:.0f}", exponents[1]])


def exponent(values: list[float]) -> str:
    """p of growth like n^p between the second and the last of four sizes; empty if a value is not positive."""
    return f"{math.log(values[-1] / values[1]) / math.log(16):.2f}" if min(values[1], values[-1]) > 0 else ""


def pages() -> dict[Path, str]:
    """The contents of the pages with the tables of the saved runs."""
    run, growth = load(OPERATIONS), load("scale-cpu.json")
    measured = replaced_between(MEASURED.read_text(), "bench", measured_table(run))
    for name, table in (("growth", growth_beside_tables), ("threads", threads_tables)):
        if (FOLDER / "results" / f"{name}-cpu.json").exists():  # a page has their marks once they were measured
            text = "\n".join(table(load(f"{name}-cpu.json")))
            measured = replaced_between(measured, f"{name} beside others", text)
    return {
        README: replaced_between(README.read_text(), "bench", readme_table(run)),
        MEASURED: replaced_between(measured, "growth", "\n".join(growth_tables(growth))),
    }


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true", help="only check the pages")
    options = parser.parse_args()
    problems = []
    for path, text in pages().items():
        if text == path.read_text():
            continue
        if options.check:
            name = path.relative_to(ROOT)
            problems.append(f"{name}: its tables differ from benchmarks/results; run python benchmarks/write_pages.py")
        else:
            path.write_text(text)
    for problem in problems:
        print(problem, file=sys.stderr)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())

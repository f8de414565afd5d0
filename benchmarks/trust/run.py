"""Rates of unreliable results accepted and of reliable results rejected.

    make trust [ARGS="--only lidar --write"]        POINTLOOM_DATA: folder of real data, optional
    make trust ARGS=--quick                         the first cases of each area, five minutes in total

Cases that should be rejected and cases that should be accepted, by area: those of each area's own file, and synthetic
sites on which no constant was chosen (held_out.py). Prints the tables of docs/trust.md. `--write` replaces the rows of
the areas that were run, and keeps the others.
"""

from __future__ import annotations

import argparse
import dataclasses
import importlib
import json
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
sys.path[:0] = [str(FOLDER), str(FOLDER.parent)]

import held_out  # noqa: E402
from judged import NO_CONSTANT, Judged, rates, table  # noqa: E402
from pages import text_between, write_between  # noqa: E402

PAGE = FOLDER.parent.parent / "docs" / "trust.md"
QUICK_SECONDS = 300.0  # of all areas with --quick
MOST_CASES = 12  # of a kind of result in the table of failure cases
OWN = (
    "images",
    "facades",
    "depth",
    "lidar",
    "stream",
    "cameras",
    "tracking",
    "maps",
    "registration",
    "alignment",
    "surfaces",
    "meshes",
    "fusing",
)  # files with `judge`


def areas() -> dict[str, Callable[[], Iterator[Judged]]]:
    """The areas by name."""
    own = {
        name: (lambda name=name: importlib.import_module(name).judge())
        for name in OWN
        if (FOLDER / f"{name}.py").exists()
    }
    return own | {f"held-out-{name}": judge for name, judge in held_out.AREAS.items()}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", action="append", choices=list(areas()), help="an area; may be given several times")
    parser.add_argument("--output", type=Path, help="write each case as a line of JSON")
    parser.add_argument("--cases", action="store_true", help="print each case, not only the rates")
    parser.add_argument("--write", action="store_true", help="write the tables into docs/trust.md")
    parser.add_argument("--quick", action="store_true", help="the first cases of each area, five minutes in all")
    parser.add_argument(
        "--read", type=Path, action="append", help="read the cases from the --output of earlier runs instead"
    )
    arguments = parser.parse_args()
    if arguments.read:
        rows = [line for path in arguments.read for line in path.read_text().splitlines()]
        report([Judged(**json.loads(row)) for row in rows], cases=arguments.cases, write=arguments.write)
        return
    judged_cases: list[Judged] = []
    lines = arguments.output.open("w") if arguments.output else None
    chosen = {name: judge for name, judge in areas().items() if not arguments.only or name in arguments.only}
    seconds = QUICK_SECONDS / len(chosen) if arguments.quick else float("inf")
    for name, judge in chosen.items():
        begin = time.monotonic()
        for judged in judge():
            judged_cases.append(judged)
            print(f"\r{name}: {len(judged_cases)} cases", end="", file=sys.stderr, flush=True)
            if lines is not None:
                lines.write(json.dumps(dataclasses.asdict(judged)) + "\n")
                lines.flush()
            if time.monotonic() - begin > seconds:
                break
        print(file=sys.stderr)
    if lines is not None:
        lines.close()
    report(judged_cases, cases=arguments.cases, write=arguments.write)


def report(cases_of_run: list[Judged], *, cases: bool, write: bool) -> None:
    """Print the tables and write them into the page."""
    print("\n".join([*rates(cases_of_run), "", *(table(cases_of_run) if cases else [])]))
    if write:
        failures = [c for c in cases_of_run if c.wrong_believed or c.right_refused]
        kinds = list(dict.fromkeys(c.area for c in cases_of_run))
        first = [c for kind in kinds for c in [f for f in failures if f.area == kind][:MOST_CASES]]
        for name, lines in (("rates", rates(cases_of_run)), ("cases", table(first))):
            write_between(PAGE, name, "\n".join(merged(text_between(PAGE, name).splitlines(), lines, kinds)))


def merged(old: list[str], new: list[str], kinds: list[str]) -> list[str]:
    """The rows of a table, with those of some kinds of results replaced where the first of each kind was."""
    heading, rows = new[:2], new[2:]
    kind_of = {row: row.split(" | ")[0].removeprefix("| ").removesuffix(NO_CONSTANT) for row in old[2:] + rows}
    order = dict.fromkeys([kind_of[row] for row in old[2:]] + kinds)
    return heading + [row for kind in order for row in (rows if kind in kinds else old[2:]) if kind_of[row] == kind]


if __name__ == "__main__":
    main()

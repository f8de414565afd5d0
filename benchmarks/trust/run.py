"""Rates of unreliable results accepted and of reliable results rejected.

    make trust [ARGS="--only scanning --output FILE"]        POINTLOOM_DATA: folder of real data, optional

Cases that should be rejected and cases that should be accepted, by area: those of each area's own file, and synthetic
sites on which no constant was chosen (held_out.py). Prints the tables of docs/trust.md.
"""

from __future__ import annotations

import argparse
import dataclasses
import importlib
import json
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
sys.path[:0] = [str(FOLDER), str(FOLDER.parent)]

import held_out  # noqa: E402
from judged import Judged, rates, table  # noqa: E402
from pages import write_between  # noqa: E402

PAGE = FOLDER.parent.parent / "docs" / "trust.md"
OWN = (
    "pictures",
    "depth",
    "lidar",
    "stream",
    "tracking",
    "maps",
    "registration",
    "alignment",
    "surfaces",
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
    for name, judge in areas().items():
        if arguments.only and name not in arguments.only:
            continue
        for judged in judge():
            judged_cases.append(judged)
            print(f"\r{name}: {len(judged_cases)} cases", end="", file=sys.stderr, flush=True)
            if lines is not None:
                lines.write(json.dumps(dataclasses.asdict(judged)) + "\n")
                lines.flush()
        print(file=sys.stderr)
    if lines is not None:
        lines.close()
    report(judged_cases, cases=arguments.cases, write=arguments.write)


def report(cases_of_run: list[Judged], *, cases: bool, write: bool) -> None:
    """Print the tables and write them into the page."""
    print("\n".join([*rates(cases_of_run), "", *(table(cases_of_run) if cases else [])]))
    if write:
        write_between(PAGE, "rates", "\n".join(rates(cases_of_run)))
        write_between(PAGE, "cases", "\n".join(table(c for c in cases_of_run if c.wrong_believed or c.right_refused)))


if __name__ == "__main__":
    main()

"""How often verdicts are wrong: of wrong answers how many are believed, of right ones how many are refused.

    make trust [ARGS="--only scanning --output FILE"]        POINTLOOM_DATA names real data, where there is any

Cases that ought to be refused and cases that ought to be believed, area by area: those of each area's own file, and
made-up places of kinds that chose no constant (held_out.py). It prints the tables of docs/trust.md.
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

OWN = (
    "pictures",
    "depth",
    "lidar",
    "stream",
    "tracking",
    "maps",
    "registration",
    "surfaces",
    "fusing",
)  # files with `judge`


def areas() -> dict[str, Callable[[], Iterator[Judged]]]:
    """What can be judged, by name."""
    own = {
        name: (lambda name=name: importlib.import_module(name).judge())
        for name in OWN
        if (FOLDER / f"{name}.py").exists()
    }
    return own | {f"held-out-{name}": judge for name, judge in held_out.AREAS.items()}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", action="append", choices=list(areas()), help="an area; may be given several times")
    parser.add_argument("--output", type=Path, help="what was said of each case, a line of JSON each")
    parser.add_argument("--cases", action="store_true", help="print each case, not the rates alone")
    arguments = parser.parse_args()
    found: list[Judged] = []
    lines = arguments.output.open("w") if arguments.output else None
    for name, judge in areas().items():
        if arguments.only and name not in arguments.only:
            continue
        for judged in judge():
            found.append(judged)
            print(f"\r{name}: {len(found)} cases", end="", file=sys.stderr, flush=True)
            if lines is not None:
                lines.write(json.dumps(dataclasses.asdict(judged)) + "\n")
                lines.flush()
        print(file=sys.stderr)
    if lines is not None:
        lines.close()
    print("\n".join([*rates(found), "", *(table(found) if arguments.cases else [])]))


if __name__ == "__main__":
    main()

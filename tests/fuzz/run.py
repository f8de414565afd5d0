"""Fuzz the readers with damaged files: `python tests/fuzz/run.py --count 3000 --seed 1`.

A reader rejects a damaged file with a FileError that names it, or reads the file's contents. Each reader of
cases.py gets
`count` files: complete files truncated at every boundary, alternating with randomly damaged ones. They are read in
child
processes, so a crash is counted and the rest continues. A result that contradicts the oracle counts as invented, an
exception other than FileError as a raw error, and more than ten seconds as a crash. Such files are saved (--keep), and
the exit code is 1.
"""

from __future__ import annotations

import argparse
import json
import os
import random
import re
import resource
import signal
import sys
import tempfile
import warnings
from collections import Counter
from pathlib import Path

import numpy as np
from cases import CASES, Case
from oracles import RefusedError

from pointloom.core.errors import FileError

OUTCOMES = ("refused", "read", "invented", "raw error", "crash")
SECONDS = 10
MEMORY = 4 << 30
AT_A_TIME = 200  # files per child process


class Hang(BaseException):
    """A reader exceeded the limit of SECONDS."""


def inputs(case: Case, seeds: list[bytes], number: int, seed: int) -> bytes:
    """The file of this number: truncated ones, while there are any, alternate with damaged ones."""
    borders = [(k, at) for k, data in enumerate(seeds) for at in _borders(data)]
    if number % 2 == 0 and number // 2 < len(borders):
        k, at = borders[number // 2]
        return seeds[k][:at]
    rng = random.Random(f"{case.name} {seed} {number}")
    return case.mutate(rng, rng.choice(seeds))


def _borders(data: bytes) -> list[int]:
    """Positions after words, lines and the numbers of binary rows."""
    head = data.find(b"end_header\n") + 11 if b"end_header\n" in data else data.find(b"DATA binary")
    is_text = head < 0 or b"ascii" in data[:200] or not any(byte > 126 or byte < 9 for byte in data)
    text = [match.end() for match in re.finditer(rb"\s", data if is_text else data[:head])]
    return text if is_text else [*text, *range(max(head, 80), len(data))]


def outcome(case: Case, path: Path) -> tuple[str, str]:
    """The outcome for a file, and a description of the fault."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            warnings.simplefilter("ignore", UserWarning)
            read = case.read(path)
    except FileError as error:
        return (
            ("refused", "")
            if str(path) in str(error) and error.reason
            else ("raw error", f"does not name the file: {error}")
        )
    except Exception as error:
        return "raw error", repr(error)[:300]
    try:
        with np.errstate(all="ignore"):
            wrong = case.oracle(path, read)
    except RefusedError as error:
        wrong = f"must be rejected: {error}"
    except Exception as error:
        wrong = f"no file for the oracle: {error!r}"
    return ("invented", wrong) if wrong else ("read", "")


def fuzz(case: Case, numbers: range, seed: int, folder: Path) -> list[tuple[int, str, str]]:
    """The outcomes of these files, read in this process."""
    seeds, outcomes = case.seeds(), []
    for number in numbers:
        path = folder / f"x{case.suffix}"
        path.write_bytes(inputs(case, seeds, number, seed) or b" ")
        outcomes.append((number, *outcome(case, path)))
    return outcomes


def fuzz_in_children(case: Case, count: int, seed: int, folder: Path) -> list[tuple[int, str, str]]:
    outcomes: list[tuple[int, str, str]] = []
    while len(outcomes) < count:
        log = folder / "log"
        log.write_text("")
        child = os.fork()
        if child == 0:
            _be_a_child(case, range(len(outcomes), min(count, len(outcomes) + AT_A_TIME)), seed, folder, log)
        _, status = os.waitpid(child, 0)
        done = [tuple(json.loads(line)) for line in log.read_text().splitlines()]
        outcomes += done
        if status:
            outcomes.append((len(outcomes), "crash", f"status {status}"))
    return outcomes


def _be_a_child(case: Case, numbers: range, seed: int, folder: Path, log: Path) -> None:
    def hang(*_: object) -> None:
        raise Hang

    signal.signal(signal.SIGALRM, hang)
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    code = 1
    try:
        case.seeds()  # without the time limit, since a job may have to run first
        with log.open("a") as file:
            for number in numbers:
                signal.alarm(SECONDS)
                try:
                    ((_, *what),) = fuzz(case, range(number, number + 1), seed, folder)
                except Hang:
                    what = ["crash", f"hangs for more than {SECONDS} s"]
                signal.alarm(0)
                file.write(json.dumps([number, *what]) + "\n")
                file.flush()
        code = 0
    finally:
        os._exit(code)


def main(arguments: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=3000, help="files a reader")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--only", default="", help="only readers whose name contains this")
    parser.add_argument("--keep", type=Path, help="folder for files with faults")
    given = parser.parse_args(arguments)
    slips = 0
    print(f"| {'reader':20} | inputs | " + " | ".join(OUTCOMES) + " |\n|---|" + "---|" * (1 + len(OUTCOMES)))
    for case in CASES:
        if given.only.lower() not in case.name.lower():
            continue
        with tempfile.TemporaryDirectory() as folder:
            outcomes = fuzz_in_children(case, given.count, given.seed, Path(folder))
        tally = Counter(what for _, what, _ in outcomes)
        print(
            f"| {case.name:20} | {len(outcomes)} | " + " | ".join(str(tally[what]) for what in OUTCOMES) + " |",
            flush=True,
        )
        wrong = [(number, what, why) for number, what, why in outcomes if what not in ("refused", "read")]
        slips += len(wrong)
        for number, what, why in wrong[:10]:
            print(f"    {what}, file {number}: {why}", file=sys.stderr)
            if given.keep:
                given.keep.mkdir(parents=True, exist_ok=True)
                data = inputs(case, case.seeds(), number, given.seed)
                (given.keep / f"{case.name.replace(' ', '_')}_{number}{case.suffix}").write_bytes(data)
    return 1 if slips else 0


if __name__ == "__main__":
    sys.exit(main())

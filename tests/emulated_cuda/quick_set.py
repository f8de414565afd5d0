"""The tests that CI runs on the emulated device, in order 3: all but those of quick_set.txt.

    make emulated-set TESTS=full   measures which branches of kernels each test takes, and writes the file (hours)
    make emulated-set              with the present set as candidates, so that it can only become smaller

The set consists of the tests of tests/emulated_cuda (host calls, streams, memory, orders of threads) that take at most
MAX_SECONDS, and of the least expensive others that take the same branches of kernels as all candidates together. It is
computed for a release. A test that is new since then is not in the file, so CI runs it.
"""

from __future__ import annotations

import sys
from pathlib import Path

if __name__ == "__main__":
    sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from tests.smallest_set import LeftOut, recorded, smallest_set

FOLDER = "tests/emulated_cuda/"
FILE = Path(__file__).with_name("quick_set.txt")
MAX_SECONDS = 1.0  # CPU [s] of a test of the device that is in the set in any case
HEAD = """\
# Tests that CI does not run on the emulated CUDA device: others take the same branches of kernels. Written by
# `make emulated-set` (quick_set.py): {chosen} of {candidates} tests run, {seconds:.0f} of {all_seconds:.0f} CPU s.
"""


def write(contexts: Path) -> str:
    """Choose the tests by what each took, and write the file; returns its head."""
    tests = recorded(contexts)
    required = {name for name in tests if name.startswith(FOLDER) and tests[name].seconds <= MAX_SECONDS}
    chosen = smallest_set(tests, required)
    head = HEAD.format(
        chosen=len(chosen),
        candidates=len(tests),
        seconds=sum(tests[name].seconds for name in chosen),
        all_seconds=sum(taken.seconds for taken in tests.values()),
    )
    left_out = LeftOut(FILE)
    if any(name in left_out for name in tests):  # all tests were candidates
        left_out = LeftOut()
    left_out.leave_out(tests.keys() - chosen, tests)
    left_out.write(FILE, head)
    return head


if __name__ == "__main__":
    print(write(Path(sys.argv[1])), end="")

"""Which lines and branches of a kernel the marks of a launch report as missed."""

import ast
import json

import pytest

from .loop_ranges import Loops
from .processes import ROOT, run

KERNELS = """\
from pointloom.kernels.lang import array, func, int32, kernel, loop, tid


@loop
def odd_up_to(count: int) -> int:
    for j in range(count):
        if j % 2 == 1:
            yield j


@func
def bounded(x: int) -> int:
    return x if x < 9 else 9


@kernel
def sum_kernel(values: array(dtype=int32), out: array(dtype=int32)):
    i = tid()
    if values[i] < 0:
        return
    total = 0
    for k in range(2):
        total += k
    for j in odd_up_to(values[i]):
        total += j
    while total > 20:
        total = total - 20
    out[i] = bounded(total)


@kernel
def unused_kernel(out: array(dtype=int32)):
    i = tid()
    out[i] = 1
"""
RUN = """\
import json, sys
from pathlib import Path

folder, tests = Path(sys.argv[1]), sys.argv[2]
sys.path[:0] = [str(folder), tests]
from emulated_cuda import kernel_coverage
kernel_coverage.ROOT = kernel_coverage.KERNELS = folder
from emulated_cuda.install import install, installed
install()
import made
import warp as wp
from pointloom.kernels.lang import launch

found = []
for values in json.loads(sys.argv[3]):
    given = [wp.array(values, dtype=int, device="cuda:0"), wp.zeros(len(values), dtype=int, device="cuda:0")]
    launch(made.sum_kernel, len(values), given)
    wp.synchronize()
    marks = installed().launches.marks.bytes
    covered, = kernel_coverage.coverage_of(marks[:])
    found.append([covered.missed_lines, covered.missed_branches])
    for first in range(0, len(marks), 4):
        marks[first : first + 2] = bytes(2)
print(json.dumps(found))
"""
UNUSED = [33, 34]  # the lines of unused_kernel
# values -> lines that are missed, and lines of the conditions with the outcome that is missed
CASES: dict[tuple[int, ...], tuple[list[int], list[str]]] = {
    (-1, 0, 5, 12): ([], []),
    (0, 5, 12): ([20], ["19 true"]),
    (-1,): (
        [6, 7, 8, 13, *range(21, 29)],
        ["6 with", "6 without", "7 false", "7 true", "13 false", "13 true", "19 false", "26 false", "26 true"],
    ),
    (-1, 0): ([7, 8, 25, 27], ["6 with", "7 false", "7 true", "13 false", "26 true"]),
    (-1, 1): ([8, 25, 27], ["6 without", "7 true", "13 false", "26 true"]),
}


@pytest.fixture(scope="module")
def missed(tmp_path_factory) -> list[tuple[list[int], list[tuple[int, int, str]]]]:
    """What each case misses, from one process whose kernels have marks."""
    folder = tmp_path_factory.mktemp("made")
    (folder / "made.py").write_text(KERNELS)
    settings = {"EMULATED_CUDA_COVERAGE": str(folder / "marks"), "PYTHONPATH": str(ROOT / "src")}
    return run("-c", RUN, str(folder), str(ROOT / "tests"), json.dumps(list(CASES)), **settings)


@pytest.mark.parametrize("case", CASES, ids=str)
def test_missed_lines_and_branches_are_those_without_a_thread(missed, case):
    lines, branches = missed[list(CASES).index(case)]
    assert lines == sorted(CASES[case][0] + UNUSED)
    assert [f"{line} {text.split('never ')[1].split()[0]}" for line, _, text in branches] == CASES[case][1]


ALWAYS = (
    *("range(i, i + N)", "range(-n, n + 1)", "range(i * run, min((i + 1) * run, count))"),
    *("range(max(i - n, 0), min(i + n + 1, count))", "range(groups.starts[i], groups.starts[i + 1])"),
    *("range(first, last) in if last - first > 2", "range(count) in if count > 0", "range(n) in for j in range(n)"),
    "range(j + 1, n) in for j in range(n - 1)",
)
SOMETIMES = (
    *("range(count)", "range(starts[i], starts[i + 1])", "range(groups.starts[i] + 1, groups.starts[i + 1])"),
    *("range(i * run, count)", "range(first, last) in if last > 2", "range(n) in if count > 0"),
    "range(j + 1, n) in for j in range(n)",
)


@pytest.mark.parametrize("text", ALWAYS + SOMETIMES)
def test_a_loop_always_runs_by_its_chunk_window_or_condition(text):
    loop, _, around = text.partition(" in ")
    lines = "def f(groups: UniqueKeys):", f"    {around or 'if x'}:", f"        for k in {loop}:", "            f(k)"
    function = ast.parse("\n".join(lines)).body[0]
    node = next(n for n in ast.walk(function) if isinstance(n, ast.For) and n.target.id == "k")
    assert Loops(function).always_run(node) == (text in ALWAYS)

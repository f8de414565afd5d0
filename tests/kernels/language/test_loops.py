"""Loops with a name and functions as arguments do what Python's generators and functions do."""

import numpy as np
import pytest

from pointloom.kernels import lang, memory
from pointloom.kernels.language.source import KernelLanguageError

pytestmark = pytest.mark.both_compilers
TRAVERSALS = """
LIMIT = 4
STEP = 3

@struct
class Table:
    firsts: array(dtype=int32)
    lasts: array(dtype=int32)

@func
def next_of(n: int) -> int:
    return n + STEP

@loop
def places(table: Table, i: int, most: int) -> int:
    \"\"\"The places of a row, the first LIMIT of them below `most`.\"\"\"
    first = table.firsts[i]
    for j in range(first, table.lasts[i]):
        if j < most and j < first + LIMIT:
            yield j

@loop
def steps(first: int, last: int) -> tuple[int, float]:
    n = first + 0
    while n < last:
        yield n, 0.5 * float(n)
        n = next_of(n)

@loop
def pairs(most: int) -> tuple[int, int]:
    for a in range(most):
        for b in range(a):
            yield a, b

@loop
def both(table: Table, i: int, up: int) -> int:
    if up == 1:
        for j in places(table, i, 100):
            yield j
    else:
        for n, half in steps(0, 10):
            yield n

@loop
def both_ends(most: int) -> int:
    for j in range(most):
        yield j
    for k in range(most):
        yield most + k

@loop
def ended(most: int, done: array(dtype=int32)) -> int:
    for j in range(most):
        yield j
    done[0] = 1

@loop
def twice(i: int, of: callback) -> int:
    for j in range(2):
        yield of(i) + j
"""
KERNELS = f"""{TRAVERSALS}
@func
def scaled(factor: int, n: int) -> int:
    return factor * n

@func
def at_row(table: Table, shift: int, n: int) -> int:
    return table.firsts[n] + shift

@func
def apply(n: int, of: callback, more: int) -> int:
    return of(n) + more

@func
def apply_twice(n: int, of: callback) -> int:
    return apply(apply(n, of, 0), of, 100)

@kernel
def places_kernel(table: Table, most: int, out: array(dtype=int32)):
    i = tid()
    total = int(0)
    for j in places(table, i, most - 1):
        if j == 3:
            continue
        total = total * 10 + j
    out[i] = total

@kernel
def bound_kernel(table: Table, out: array(dtype=int32)):
    i = tid()
    most = int(100)
    total = int(0)
    for j in places(table, i, most):
        total += 1
        most = 3
    out[i] = total

@kernel
def steps_kernel(out: array(dtype=float32)):
    i = tid()
    total = float(0.0)
    for n, half in steps(i, 20):
        total += half
    for m, half in steps(0, 2 * i):
        if m > 6:
            break
        total += 100.0 * float(m)
    out[i] = total

@kernel
def both_kernel(table: Table, out: array(dtype=int32)):
    i = tid()
    count = int(1)
    for j in both(table, i, i % 2):
        for k in both(table, i, 1):
            count = count * 3 + j * k
    out[i] = count

@kernel
def callbacks_kernel(table: Table, out: array(dtype=int32)):
    i = tid()
    factor = int(2)
    total = apply_twice(i, next_of) + apply_twice(i, partial(scaled, factor + 1))
    for j in twice(i, partial(scaled, factor)):
        total = total * 7 + j
        factor = 10
    out[i] = total + apply(i, partial(at_row, table, 1000), 5)

@kernel
def after_kernel(out: array(dtype=int32)):
    i = tid()
    n = int(100)
    last = int(0)
    for n, half in steps(0, 3 * i):
        last = n
    out[i] = 1000 * last + n

@kernel
def hygiene_kernel(table: Table, out: array(dtype=int32)):
    i = tid()
    count = int(0)
    next_of = int(7)
    LIMIT = int(1)
    for j in places(table, i, 100):
        count += j
    for n, half in steps(i, 9):
        count += n * next_of * LIMIT
    out[i] = count

@reduction
def sum_places(table: Table) -> vec2:
    i = tid()
    total = float(0.0)
    for j in places(table, i, 100):
        total += float(j)
    return vec2(total, 1.0)
"""
FIRSTS, LASTS = np.array([0, 2, 5, 1, 3]), np.array([3, 9, 5, 4, 4])


@pytest.fixture(scope="module")
def kernels(write_kernels):
    return write_kernels("walks", KERNELS)


@pytest.fixture
def run(device, kernels):
    class Table:
        firsts, lasts = (memory.upload(values, lang.int32, device) for values in (FIRSTS, LASTS))

    def launch(name, *arguments, dtype=lang.int32):
        out = memory.zeros(5, dtype, device)
        lang.launch(getattr(kernels, name), 5, [*arguments, out])
        return memory.download(out).tolist()

    launch.table = Table()
    return launch


def row(i, limit=100):
    return [j for j in range(FIRSTS[i], LASTS[i]) if j < limit][:4]


@pytest.mark.parametrize(
    ("name", "most", "expected"),
    [
        ("places_kernel", [8], [int("0" + "".join(str(j) for j in row(i, 7) if j != 3)) for i in range(5)]),
        ("bound_kernel", [], [3, 1, 0, 2, 1]),  # after the first value only those below 3
        ("hygiene_kernel", [], [sum(row(i)) + 7 * sum(range(i, 9, 3)) for i in range(5)]),
    ],
    ids=["yields its values in order", "sees what its body changes", "has no names in common with its caller"],
)
def test_a_loop_yields_what_a_generator_of_python_yields(run, name, most, expected):
    assert run(name, run.table, *most) == expected


def test_a_loop_leaves_its_variable_as_python_does(run):
    assert run("after_kernel") == [100, 0, 3003, 6006, 9009]


def test_a_loop_can_yield_several_values_and_be_left(run):
    halves = [sum(0.5 * n for n in range(i, 20, 3)) for i in range(5)]
    hundreds = [sum(100 * n for n in range(0, 2 * i, 3) if n <= 6) for i in range(5)]
    assert run("steps_kernel", dtype=lang.float32) == [a + b for a, b in zip(halves, hundreds, strict=True)]


def test_loops_can_be_nested(run):
    expected = []
    for i in range(5):
        count = 1
        for j in row(i) if i % 2 else range(0, 10, 3):
            for k in row(i):
                count = (count * 3 + j * k) % 2**32
        expected.append(int(np.uint32(count).view(np.int32)))
    assert run("both_kernel", run.table) == expected


def test_functions_are_arguments(run):
    expected = []
    for i in range(5):
        total = (i + 3 + 3 + 100) + (9 * i + 100)
        total = (total * 7 + 2 * i) * 7 + (10 * i + 1)  # a loop's callback reads `factor` as it is then
        expected.append(total + int(FIRSTS[i]) + 1000 + 5)
    assert run("callbacks_kernel", run.table) == expected


def test_reductions_can_contain_loops(device, kernels, run):
    total = memory.download(lang.reduce(kernels.sum_places, 5, [run.table]))
    np.testing.assert_array_equal(total, [[sum(sum(row(i)) for i in range(5)), 5.0]])


REFUSED = {
    "for j in places(table, i):\n    out[i] = j": "places takes 3 arguments, got 2",
    "for j, k in places(table, i, 3):\n    out[i] = j": "the loop hands out 1 value",
    "for n in steps(0, 3):\n    out[i] = n": "the loop hands out 2 values",
    "for j in places(table, i, 3):\n    j = 4": "j is the variable of a loop: change a copy",
    "for a, b in pairs(3):\n    if b > 1:\n        break": "no `break` out of this walk",
    "for j in ended(3, out):\n    if j > 1:\n        break": "no `break` out of this walk, which has more loops or",
    "for j in both_ends(3):\n    if j > 1:\n        break": "no `break` out of this walk",
    "m = int(3)\nfor m in places(table, i, m):\n    out[i] = m": "m is what the loop is given, and its variable",
    "for n, h in steps(0, 3):\n    if n > 1:\n        continue": "no `continue` out of this walk",
    "for j in places(table, i, 3):\n    out[i] = j\nelse:\n    out[i] = 1": "`else` of a loop is not",
    "for j in twice(i, 3):\n    out[i] = j": "expected the name of a device function, or partial(function, first",
    "for j in twice(i, places):\n    out[i] = j": "expected the name of a device function",
    "for j in places(table, i, 1.5):\n    out[i] = j": "argument 3 of places is int32, got float32: conv",
    "for j in places(table, i, 3 * 0.5):\n    out[i] = j": "`*` between int32 and float32",
    "for j in places(table, out, 3):\n    out[i] = j": "argument 2 of places is int32, got array of int32",
    "for j in places(out, i, 3):\n    out[i] = j": "argument 1 of places is a Table",
    "for j in places(table.firsts, i, 3):\n    out[i] = j": "argument 1 of places is a Table",
    "out[i] = places(table, i, 3)": "places is a Loop, not a word of the kernel language",
    "for j in places(table, i, 3):\n    out[i] = count": "count is not known here",
}


@pytest.mark.parametrize("body", REFUSED)
def test_unsupported_loops_are_refused(write_kernels, body):
    text = "".join(f"    {line}\n" for line in body.splitlines())
    source = f"{TRAVERSALS}\n@kernel\ndef k(table: Table, out: array(dtype=int32)):\n    i = tid()\n{text}"
    with pytest.raises(KernelLanguageError) as caught:
        write_kernels("faulty_walks", source)
    assert REFUSED[body] in caught.value.msg
    lines = source.count("\n") + 2  # after the two that write_kernels puts before
    assert lines - len(body.splitlines()) < caught.value.lineno <= lines


def test_loops_and_functions_of_other_modules_keep_their_own_names_words_and_widths(device, write_kernels):
    shared = """

@func
def scaled(n: int) -> int:
    return FACTOR * n

@loop
def steps(last: int) -> int:
    for j in range(last):
        yield FACTOR * j

@loop
def roots(last: int) -> float:
    for j in range(last):
        if (int64(j) & int64(5)) == int64(j):
            yield sqrt(float(j))
"""
    for name, factor in (("walk_a", 10), ("walk_b", 100)):
        write_kernels(name, f"FACTOR = {factor}\n{shared}")
    source = """
from walk_a import roots, scaled, steps
from walk_b import scaled as other, steps as others
del sqrt

@func
def apply(n: int, of: callback) -> int:
    return of(n)

@kernel
def k(out: array(dtype=float32)):
    i = tid()
    total = float(apply(i + 1, scaled) + apply(i + 1, other))
    for a in steps(3):
        total += float(a)
    for b in others(3):
        total += float(b)
    for root in roots(6):
        total += root
    out[i] = total
"""
    module = write_kernels("two_walks", source)
    out = memory.zeros(2, lang.float32, device)
    lang.launch(module.k, 2, [out])
    roots = sum(np.sqrt(j) for j in (0, 1, 4, 5))
    np.testing.assert_allclose(memory.download(out), [110 + 30 + 300 + roots, 220 + 30 + 300 + roots], rtol=1e-6)

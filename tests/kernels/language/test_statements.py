"""Statements of the kernel language do what Python does with them, through each compiler and device."""

import numpy as np
import pytest
import warp as wp

from pointloom.kernels import lang

pytestmark = pytest.mark.both_compilers
STATEMENTS = """
LIMIT = 5
FAR = 1 << 29
V6 = vector(6, float32)

@func
def split(x: int):
    return x // 10, float(x % 10)

@func
def halve(x: int) -> int:
    x = x // 2
    return x

@func
def put(a: array(dtype=int32), i: int, value: int):
    a[i] = value

@func
def sum_row(a: array(dtype=int32, ndim=2), row: int) -> int:
    total = int(0)
    for column in range(a.shape[1]):
        total += a[row, column]
    return total

@kernel
def loops_kernel(a: array(dtype=int32), out: array(dtype=int32)):
    i = tid()
    total = int(0)
    for j in range(a[i]):
        if j == 2:
            continue
        if j > LIMIT:
            break
        for k in range(j, 4):
            total += 10 * k + j
    n = int(0)
    while True:
        n += 1
        if n * n > a[i]:
            break
    while n > 3 and n < 100:
        n = n - 3
    out[i] = total * 100 + n

@kernel
def returns_kernel(a: array(dtype=int32), out: array(dtype=int32)):
    i = tid()
    if a[i] < 3:
        out[i] = -1
        return
    elif a[i] > 50:
        return
    put(out, i, halve(a[i]))

@kernel
def tuples_kernel(a: array(dtype=int32), out: array(dtype=float32)):
    i = tid()
    tens, ones = split(a[i])
    x, y = tens, 2
    out[i] = float(x * y) + ones

@kernel
def guards_kernel(a: array(dtype=int32), out: array(dtype=int32)):
    i = tid()
    if i > 0 and a[FAR * int(i == 0) + i - 1] > 1:
        out[i] = 1
    if i == 0 or a[FAR * int(i == 0)] == 0:
        out[i] = out[i] + 2
    last = a[FAR * int(i == 0)] if i > 0 else -1
    out[i] = out[i] + 10 * last

@kernel
def parts_kernel(scale: float, a: array(dtype=vec3), m: array(dtype=mat33), out: array(dtype=vec3)):
    i = tid()
    v = a[i]
    w = v
    w[i % 3] = scale
    w[1] += 1.0
    q = m[i]
    q[0, 1] = v[0]
    out[i] = q @ w
    out[i][2] = v[2]
    h = V6(0.0)
    for j in range(6):
        h[j] = float(j) * scale
    out[i][0] = out[i][0] + h[i % 6] + h[5]

@kernel
def planes_kernel(a: array(dtype=int32, ndim=2), out: array(dtype=int32), flags: array(dtype=uint8, ndim=2)):
    i = tid()
    out[i] = sum_row(a, i)
    for j in range(a.shape[1]):
        flags[i, j] = uint8(a[i, j] + 250)

@kernel
def atomics_kernel(a: array(dtype=int32), counts: array(dtype=int64), low: array(dtype=float32),
                   ticket: array(dtype=int32)):
    i = tid()
    atomic_add(counts, a[i] % 2, int64(a[i]))
    atomic_min(low, 0, -float(a[i]))
    atomic_max(low, 1, float(a[i]))
    atomic_max(counts, 2, int64(a[i]) << int64(40))
    place = atomic_add(ticket, 0, 1)
    atomic_add(ticket, 1 + place, a[i])

@kernel
def arguments_kernel(m: mat33, v: vec3, d: vec3d, n: int64, u: uint32, x: float64, out: array(dtype=float64)):
    i = tid()
    p = m @ v
    out[i] = float64(p[i % 3]) + d[0] + float64(n) + float64(u) + x

@kernel
def idle_kernel(out: array(dtype=int32)):
    i = tid()
    pass
"""


@pytest.fixture(scope="module")
def statements(write_kernels):
    return write_kernels("statements", STATEMENTS)


def put(values, kind, device):
    return wp.array(np.asarray(values), dtype=kind, device=device)


def test_loops_break_continue_and_nest(statements, device):
    a = np.array([0, 1, 3, 5, 9, 70])
    out = wp.zeros(len(a), dtype=wp.int32, device=device)
    lang.launch(statements.loops_kernel, len(a), [put(a, wp.int32, device), out])
    expected = []
    for x in a:
        total = sum(10 * k + j for j in range(min(x, 6)) if j != 2 for k in range(j, 4))
        n = next(n for n in range(1, 100) if n * n > x)
        while n > 3:
            n -= 3
        expected.append(total * 100 + n)
    assert out.numpy().tolist() == expected


def test_a_return_ends_its_thread_alone(statements, device):
    out = wp.zeros(5, dtype=wp.int32, device=device)
    lang.launch(statements.returns_kernel, 5, [put([1, 3, 60, 50, 0], wp.int32, device), out])
    assert out.numpy().tolist() == [-1, 1, 0, 25, -1]


def test_functions_return_tuples(statements, device):
    out = wp.zeros(3, dtype=wp.float32, device=device)
    lang.launch(statements.tuples_kernel, 3, [put([7, 42, 99], wp.int32, device), out])
    assert out.numpy().tolist() == [7.0, 10.0, 27.0]


def test_and_or_and_if_read_no_more_than_they_need(statements, device):
    out = wp.zeros(3, dtype=wp.int32, device=device)
    lang.launch(statements.guards_kernel, 3, [put([0, 5, 2], wp.int32, device), out])
    assert out.numpy().tolist() == [2 - 10, 2 + 0, 1 + 2 + 0]


def test_components_rows_and_local_vectors_can_be_set(statements, device):
    a = np.array([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 9.0], [0.5, 0.25, 1.0]], np.float32)
    m = np.arange(36, dtype=np.float32).reshape(4, 3, 3)
    out = wp.zeros(4, dtype=wp.vec3, device=device)
    lang.launch(statements.parts_kernel, 4, [2.0, put(a, wp.vec3, device), put(m, wp.mat33, device), out])
    expected = np.empty_like(a)
    for i in range(4):
        w, q = a[i].copy(), m[i].copy()
        w[i % 3] = 2.0
        w[1] += 1.0
        q[0, 1] = a[i, 0]
        expected[i] = q @ w
        expected[i, 2] = a[i, 2]
        expected[i, 0] += 2.0 * (i % 6) + 10.0
    np.testing.assert_allclose(out.numpy(), expected, rtol=1e-6)


def test_arrays_may_have_two_axes_and_small_integers(statements, device, rng):
    a = rng.integers(0, 5, (6, 4))
    out, flags = wp.zeros(6, dtype=wp.int32, device=device), wp.zeros((6, 4), dtype=wp.uint8, device=device)
    lang.launch(statements.planes_kernel, 6, [put(a, wp.int32, device), out, flags])
    assert out.numpy().tolist() == a.sum(1).tolist()
    assert (flags.numpy() == a + 250).all()


def test_atomics_resolve_races(statements, device, rng):
    a = rng.integers(1, 1000, 5000)
    counts = wp.zeros(3, dtype=wp.int64, device=device)
    low, ticket = put([np.inf, -np.inf], wp.float32, device), wp.zeros(5001, dtype=wp.int32, device=device)
    lang.launch(statements.atomics_kernel, 5000, [put(a, wp.int32, device), counts, low, ticket])
    assert counts.numpy().tolist() == [a[a % 2 == 0].sum(), a[a % 2 == 1].sum(), int(a.max()) << 40]
    assert low.numpy().tolist() == [-a.max(), a.max()]
    assert ticket.numpy()[0] == 5000 and sorted(ticket.numpy()[1:]) == sorted(a)


@pytest.mark.parametrize("form", ["numpy", "lists", "warp"])
def test_vectors_matrices_and_numbers_are_taken_as_arguments(statements, device, form):
    m, v, d = np.arange(9.0).reshape(3, 3), [1.0, 2.0, 3.0], [0.1, 0.2, 0.3]
    given = {
        "numpy": [m, np.array(v), np.array(d), np.int64(2**40), np.uint32(2**32 - 1), np.float32(0.5)],
        "lists": [m.ravel().tolist(), v, tuple(d), 2**40, 2**32 - 1, 0.5],
        "warp": [wp.mat33(*m.ravel()), wp.vec3(*v), wp.vec3d(*d), 2**40, 2**32 - 1, 0.5],
    }[form]
    out = wp.zeros(3, dtype=wp.float64, device=device)
    lang.launch(statements.arguments_kernel, 3, [*given, out])
    assert out.numpy().tolist() == (m @ v + 0.1 + 2**40 + (2**32 - 1) + 0.5).tolist()


def test_a_kernel_may_do_nothing(statements, device):
    lang.launch(statements.idle_kernel, 3, [wp.zeros(3, dtype=wp.int32, device=device)])

"""Every word and statement of the kernel language computes what NumPy and Python compute, by each compiler and device.

Both CPU compilers are also bitwise identical, if the arithmetic is exact or correctly rounded.
"""

from typing import NamedTuple

import numpy as np
import pytest
import warp as wp

from pointloom.kernels import lang

pytestmark = pytest.mark.both_compilers
X = np.array([0.25, -1.5, 3.0, 0.7, -0.1, 100.0, -7.9, 0.0])
INTEGERS = np.array([0, 1, 2, 3, 7, 100, 30, 5])
SIGNED = np.array([0, -1, 2, -3, 7, -100, 30, -5])
V = np.array([[1.0, 2.0, 2.0], [0.5, -0.25, 4.0], [0.0, 0.0, 0.0], [-3.0, 1.0, 0.1]])
M = np.array([np.arange(9.0).reshape(3, 3), np.eye(3) * 2.0, -np.ones((3, 3)), [[0, 1, 0], [0, 0, 1], [1, 0, 0]]])


class Case(NamedTuple):
    """out[i] = body of a[i], against NumPy's `expected` of the same array."""

    body: str
    a: np.ndarray
    kind: str
    out: str
    expected: object
    exact: bool = True


def scalar_cases(kind: str) -> list[Case]:
    c = "" if kind == "float32" else "float64"
    x = X.astype(kind)
    one = np.dtype(kind).type
    same = [
        (f"a[i] + {c}(1.5)", x + one(1.5)), (f"a[i] - {c}(0.1)", x - one(0.1)),
        (f"a[i] * {c}(0.1)", x * one(0.1)), (f"a[i] / {c}(0.3)", x / one(0.3)),
        ("-a[i]", -x), ("abs(a[i])", np.abs(x)), ("floor(a[i])", np.floor(x)), ("ceil(a[i])", np.ceil(x)),
        ("sqrt(abs(a[i]))", np.sqrt(np.abs(x))), (f"a[i] if a[i] > {c}(0.5) else -a[i]", np.where(x > 0.5, x, -x)),
        (f"min(a[i], {c}(0.5))", np.minimum(x, one(0.5))), (f"max(a[i], {c}(0.5))", np.maximum(x, one(0.5))),
        (f"{c}(THIRD) * a[i]", one(1 / 3) * x), (f"{c}(1.0) / {c}(3.0) * a[i]", one(1) / one(3) * x),
        (f"min(a[i], {c}(INFINITY))", x),
    ]  # fmt: skip
    rounded = [(f"{f}(a[i])", getattr(np, f)(x)) for f in ("sin", "cos", "tan")]
    inverses = {"exp": np.exp, "acos": np.arccos, "asin": np.arcsin}
    rounded += [(f"{word}(a[i] / {c}(101.0))", numpy(x / one(101.0))) for word, numpy in inverses.items()]
    rounded += [
        (f"log(abs(a[i]) + {c}(1.0))", np.log(np.abs(x) + one(1))),
        (f"atan2(a[i], {c}(2.0))", np.arctan2(x, one(2))),
        (f"pow(abs(a[i]), {c}(1.5))", np.abs(x) ** one(1.5)),
    ]
    cases = [Case(body, x, kind, kind, e) for body, e in same]
    return cases + [Case(body, x, kind, kind, e, exact=False) for body, e in rounded]


def integer_cases(kind: str) -> list[Case]:
    c = "" if kind == "int32" else kind
    integers, signed = INTEGERS.astype(kind), (SIGNED if kind[0] == "i" else INTEGERS).astype(kind)
    mask = (1 << (20 if kind.endswith("32") else 40)) - 1
    pairs = [
        (f"a[i] * {c}(3) + {c}(5)", signed * 3 + 5), (f"a[i] // {c}(3)", signed // 3),
        (f"a[i] % {c}(3)", np.fmod(signed, 3)), (f"a[i] & {c}({mask & 0x55555})", signed & (mask & 0x55555)),
        (f"(a[i] | {c}(8)) ^ {c}(3)", (signed | 8) ^ 3), ("~a[i]", ~signed),
        (f"a[i] << {c}(3)", signed << 3), (f"a[i] >> {c}(1)", signed >> 1),
        (f"min(a[i], {c}(5))", np.minimum(signed, 5)), (f"max(a[i], {c}(5))", np.maximum(signed, 5)),
    ]  # fmt: skip
    cases = [Case(body, signed, kind, kind, e) for body, e in pairs]
    cases += [Case("bit_count(a[i])", integers, kind, "int32", [int(v).bit_count() for v in integers])]
    cases += [Case(f"{c or 'int'}(1) << a[i]", integers % 31, kind, kind, 1 << (integers % 31))]
    if kind[0] == "i":
        cases += [Case("abs(a[i])", signed, kind, kind, np.abs(signed))]
    return cases


def vector_cases(kind: str) -> list[Case]:
    d = "d" if kind == "float64" else ""
    c = "float64" if d else ""
    v, m = V.astype(kind), M.astype(kind)
    one = np.dtype(kind).type
    lengths = np.sqrt((v * v).sum(1, dtype=kind))
    units = np.divide(v, lengths[:, None], out=np.zeros_like(v), where=lengths[:, None] > 0)
    w = np.array([0.5, 2.0, -1.0], kind)
    w_text = f"vec3{d}(0.5, 2.0, -1.0)"
    vectors = [
        (f"a[i] + {w_text}", f"vec3{d}", v + w), (f"-(a[i] - {w_text})", f"vec3{d}", -(v - w)),
        (f"cross(a[i], {w_text})", f"vec3{d}", np.cross(v, w)), ("length(a[i])", kind, lengths),
        (f"outer(a[i], {w_text})", f"mat33{d}", v[:, :, None] * w), ("normalize(a[i])", f"vec3{d}", units),
        (f"{c}(2.0) * a[i] / {c}(3.0)", f"vec3{d}", one(2) * v / one(3)),
        (f"min(a[i], {w_text})", f"vec3{d}", np.minimum(v, w)),
        (f"max(a[i], vec3{d}(0.1))", f"vec3{d}", np.maximum(v, one(0.1))),
        ("a[i][i % 3]", kind, v[np.arange(4), np.arange(4) % 3]), (f"dot(a[i], {w_text})", kind, (v * w).sum(1)),
        (f"mat33{d}({', '.join(f'{x}.0' for x in range(9))}) @ a[i]", f"vec3{d}", v @ m[0].T),
        (f"a[i] @ mat33{d}({', '.join(f'{x}.0' for x in range(9))})", f"vec3{d}", v @ m[0]),
    ]  # fmt: skip
    matrices = [
        ("transpose(a[i])", f"mat33{d}", m.transpose(0, 2, 1)),
        (f"{c}(0.5) * a[i] + a[i]", f"mat33{d}", one(0.5) * m + m),
        ("a[i][1, 2] - a[i][2, 0]", kind, m[:, 1, 2] - m[:, 2, 0]),
    ]
    cases = [Case(body, v, f"vec3{d}", out, e) for body, out, e in vectors]
    return cases + [Case(body, m, f"mat33{d}", out, e) for body, out, e in matrices]


NOT_FINITE = np.array([1.0, np.nan, np.inf, -np.inf, 3e38, 0.0])
CASTS = [
    Case("int(a[i])", X, "float32", "int32", X.astype(np.float32).astype(np.int32)),
    Case("int64(a[i])", X * 1e9, "float64", "int64", (X * 1e9).astype(np.int64)),
    Case("float(a[i])", X, "float64", "float32", X.astype(np.float32)),
    Case("float64(a[i])", X, "float32", "float64", X.astype(np.float32).astype(np.float64)),
    Case("float(a[i])", SIGNED, "int32", "float32", SIGNED.astype(np.float32)),
    Case("int(a[i])", SIGNED + 2**33, "int64", "int32", SIGNED),
    Case("uint32(a[i])", SIGNED, "int32", "uint32", SIGNED.astype(np.int32).astype(np.uint32)),
    Case("int(a[i]) * 2", INTEGERS * 2, "uint8", "int32", INTEGERS * 4),
    Case("uint8(int(a[i]) * 2)", INTEGERS * 2, "uint8", "uint8", INTEGERS * 4),
    Case("uint16(int(a[i]) * 655)", INTEGERS, "uint16", "uint16", INTEGERS * 655),
    Case("(int64(a[i]) << int64(32)) | int64(7)", SIGNED, "int32", "int64", (SIGNED << 32) | 7),
    Case("a[i] * uint64(0x9E3779B97F4A7C15) >> uint64(33)", INTEGERS, "uint64", "uint64",
         INTEGERS.astype(np.uint64) * np.uint64(0x9E3779B97F4A7C15) >> np.uint64(33)),
    Case("int64(WIDE) & a[i]", SIGNED, "int64", "int64", SIGNED & 0xFF_FFFF_FFFF),
    Case("float_bits(a[i])", X, "float32", "int32", X.astype(np.float32).view(np.int32)),
    Case("bits_float(a[i])", X.astype(np.float32).view(np.int32), "int32", "float32", X.astype(np.float32)),
    Case("int(isfinite(a[i]))", NOT_FINITE, "float32", "int32", np.isfinite(NOT_FINITE)),
    Case("int(isfinite(a[i]))", NOT_FINITE, "float64", "int32", np.isfinite(NOT_FINITE)),
    Case("int(isfinite(a[i]))", np.array([[1, 2, 3], [1, np.nan, 3], [np.inf, 0, 0], [3e38, 3e38, 3e38]]), "vec3",
         "int32", [1, 0, 0, 1]),
    Case("int(not (a[i] > 0.0))", X, "float32", "int32", ~(X > 0)),
    Case("int(a[i] != 3 or (a[i] > 1 and a[i] <= 3))", INTEGERS, "int32", "int32", np.ones(8)),
    Case("-7 // 2 + -7 % 4 * 10 + a[i]", INTEGERS, "int32", "int32", INTEGERS - 34),
    Case("a[i] * (TENTH * 3.3)", X, "float32", "float32", X.astype(np.float32) * (np.float32(0.1) * np.float32(3.3))),
    Case("a[i] * float64(1.0 / 3.0)", X, "float64", "float64", X * np.float64(np.float32(1) / np.float32(3))),
    Case("vec3d(0.1, 0.2, a[i])", X, "float64", "vec3d", np.stack([0 * X + 0.1, 0 * X + 0.2, X], 1)),
    Case("vec3i(1, 2, a[i]) * 2", INTEGERS, "int32", "vec3i",
         np.stack([0 * INTEGERS + 2, 0 * INTEGERS + 4, INTEGERS * 2], 1)),
]  # fmt: skip
CASES = [
    *scalar_cases("float32"), *scalar_cases("float64"), *integer_cases("int32"), *integer_cases("int64"),
    *integer_cases("uint32"), *integer_cases("uint64"), *vector_cases("float32"), *vector_cases("float64"), *CASTS,
]  # fmt: skip
CONSTANTS = "THIRD = 1 / 3\nTENTH = 0.1\nINFINITY = math.inf\nWIDE = 0xFF_FFFF_FFFF\n"
ARRAYS = list({case.a.tobytes(): None for case in CASES})
GROUPS: dict[str, list[Case]] = {}  # one kernel each: expressions of one array
for case in CASES:
    GROUPS.setdefault(f"{case.kind} to {case.out} of array {ARRAYS.index(case.a.tobytes())}", []).append(case)


@pytest.fixture(scope="module")
def expressions(write_kernels):
    source = CONSTANTS
    for k, group in enumerate(GROUPS.values()):
        source += f"@kernel\ndef group_{k}_kernel(a: array(dtype={group[0].kind}), out: array(dtype={group[0].out})):\n"
        source += "    i = tid()\n"
        source += "".join(f"    out[{j * len(case.a)} + i] = {case.body}\n" for j, case in enumerate(group))
    return write_kernels("expressions", source)


def run_group(module, name: str, device: str) -> np.ndarray:
    group, k = GROUPS[name], list(GROUPS).index(name)
    kind, count = getattr(lang, group[0].kind), len(group[0].a)
    values = group[0].a.astype(wp.dtype_to_numpy(getattr(kind, "_wp_scalar_type_", kind)))
    a = wp.array(values, dtype=kind, device=device)
    out = wp.zeros(count * len(group), dtype=getattr(lang, group[0].out), device=device)
    lang.launch(getattr(module, f"group_{k}_kernel"), count, [a, out])
    return out.numpy().reshape(len(group), count, *out.numpy().shape[1:])


@pytest.mark.parametrize("name", GROUPS)
def test_an_expression_gives_the_result_of_numpy(expressions, device, name):
    for case, result in zip(GROUPS[name], run_group(expressions, name, device), strict=True):
        expected = np.asarray(case.expected)
        if result.dtype.kind != "f":
            np.testing.assert_array_equal(result, expected.astype(result.dtype), err_msg=case.body)
            continue
        rounding = 1e-6 if result.dtype == np.float32 else 1e-14  # sums in another order, different libm
        np.testing.assert_allclose(result, expected, rtol=rounding, atol=rounding, err_msg=case.body)


@pytest.mark.taichi
def test_both_cpu_compilers_are_bitwise_identical(expressions):
    for name, group in GROUPS.items():
        results = []
        for compiler in ("taichi", "warp"):
            with lang.cpu_compiler(compiler):
                results.append(run_group(expressions, name, "cpu") + 0)  # + 0: the sign of zero is not promised
        for case, one, other in zip(group, *results, strict=True):
            assert not case.exact or one.tobytes() == other.tobytes(), case.body


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


@pytest.mark.parametrize(
    ("name", "given", "kind", "expected"),
    [
        ("returns_kernel", [1, 3, 60, 50, 0], wp.int32, [-1, 1, 0, 25, -1]),
        ("tuples_kernel", [7, 42, 99], wp.float32, [7.0, 10.0, 27.0]),
        ("guards_kernel", [0, 5, 2], wp.int32, [2 - 10, 2 + 0, 1 + 2 + 0]),
        ("idle_kernel", None, wp.int32, [0, 0, 0]),
    ],
    ids=["return ends its thread", "tuples", "and, or and if read no more than they need", "a kernel may do nothing"],
)
def test_statements_do_what_python_does(statements, device, name, given, kind, expected):
    out = wp.zeros(len(expected), dtype=kind, device=device)
    lang.launch(getattr(statements, name), len(expected), [*([put(given, wp.int32, device)] if given else []), out])
    assert out.numpy().tolist() == expected


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
    assert out.numpy().tolist() == a.sum(1).tolist() and (flags.numpy() == a + 250).all()


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

"""What the kernel language refuses when a function is decorated, with the file, the line and what to write instead."""

import pytest

from pointloom.kernels.language.source import KernelLanguageError

pytestmark = pytest.mark.both_compilers
# (statements of a kernel, the line of the fault counted from its first statement, a part of the message)
REFUSED = [
    # form
    ("o[i] = a[i:][0]", 0, "slices are not in the kernel language"),
    ("x = [1, 2]", 0, "lists are not"),
    ("x: int = 3", 0, "annotations of variables (write `x = float(...)`) are not"),
    ("o[i] = int(a[i] is n)", 0, "tests by `is` (write `==`)"),
    ("o[i] = int(a[i] in (1, 3))", 0, "tests by `in`"),
    ("o[i] = int(0 < a[i] < 3)", 0, "chained comparisons: write `a < b and b < c`"),
    ("assert i > 0", 0, "assertions are not"),
    ("x = a[i]\nx = o[i] = x", 1, "one assignment a line"),
    ("for j in range(3):\n    o[i] = j\nelse:\n    o[i] = 7", 3, "`else` of a loop"),
    ("while i < 0:\n    break\nelse:\n    o[i] = 7", 3, "`else` of a loop"),
    ("for j in range(5, 0, -1):\n    o[i] = j", 0, "range has no step: count by one and compute"),
    ("for j in a:\n    o[i] = j", 0, "loops run over range(...)"),
    ("for j, k in range(3):\n    o[i] = j", 0, "a loop has one variable"),
    ("o[i] = max(a[i], a[i], key=a)", 0, "arguments are positional"),
    ("o[i] = a.size", 0, "`array.shape[k]` is the one attribute"),
    ("v = vec3(0.0)\ny[i] = v.x", 1, "components are v[0], v[1]"),
    ("o[i] = a.shape[i]", 0, "`.shape[k]` takes a literal k"),
    ("o[i] = math.floor(2.5)", 0, "call functions by their plain names"),
    ("print(a[i])", 0, "print is not known here"),
    ("x = 'text'", 0, "'text' is not in the kernel language"),
    ("x = None", 0, "None is not in the kernel language"),
    ("a[i]", 0, "its value is lost"),
    ("ti = a[i]", 0, "the name ti is taken by the compilers"),
    ("chunk_ = a[i]", 0, "the name chunk_ is taken by the compilers"),
    ("o[i] = tid()", 0, "tid() is called once, first in a kernel"),
    ("return a[i]", 0, "a kernel returns nothing: write to an array"),
    ("for j in range(3):\n    if j > 1:\n        return", 2, "no `return` inside a loop"),
    # names
    ("o[i] = unknown", 0, "unknown is not known here; define it above"),
    ("o[i] = TABLE[i]", 0, "TABLE is a tuple, not a word of the kernel language; constants are Python numbers"),
    ("o[i] = NUMPY", 0, "NUMPY is a int64, not a word of the kernel language"),
    ("n = n + 1", 0, "n is a parameter: change a copy, `copy = n`"),
    ("a = 3", 0, "a is an array"),
    ("i = i + 1", 0, "i is the thread's index"),
    ("for j in range(3):\n    j = 7", 1, "j is the variable of a loop"),
    ("j = 7\nfor j in range(3):\n    o[i] = j", 1, "j is in use: give the loop a variable of its own"),
    ("for j in range(3):\n    o[i] = j\no[i] = j", 2, "set j before the branch or loop that changes it"),
    ("if i > 0:\n    x = 1\no[i] = x", 2, "set x before the branch or loop that changes it"),
    ("x += 1", 0, "set x before it is changed"),
    ("x = True\nfor j in range(3):\n    x = False", 2, "x began as a truth value, which does not change"),
    # types
    ("x = 1.5\no[i] = a[i] + x", 1, "`+` between int32 and float32: convert with float(...)"),
    ("z[i] = z[i] * y[i]", 0, "`*` between float64 and float32: convert with float64(...)"),
    ("k[i] = a[i]", 0, "k[i] is int64, the value is int32: convert with int64(...)"),
    ("o[i] = a[i] > 3", 0, "o[i] is int32, the value is bool: convert with int(...)"),
    ("x = int(0)\nx = k[i]", 1, "x was int32 and becomes int64; take another name or convert"),
    ("y[i] = a[i] / 2", 0, "`/` between integers means two things: write `//`, or float(...)"),
    ("y[i] = y[i] ** 2.0", 0, "`**` is not in the kernel language: multiply, or pow(a, b)"),
    ("y[i] = y[i] % 2.0", 0, "`%` is for integers, not float32: write x - floor(x / y) * y"),
    ("o[i] = int(y[i] & 3)", 0, "`&` between float32 and int32"),
    ("o[i] = int(y[i] << y[i])", 0, "`<<` needs integers, not float32"),
    ("o[i] = ~y[i]", 0, "`~` needs an integer"),
    ("o[i] = int((a[i] > 1) & (a[i] < 3))", 0, "`&` on a truth value: write `and` / `or`"),
    ("u[i] = u[i] // u[i]", 0, "8 and 16 bits are for storage, write int(...) first"),
    ("o[i] = int(-u[i])", 0, "the sign of a uint8: write int(...) first"),
    ("u[i] = min(u[i], u[i])", 0, "min is not for uint8 and uint8"),
    ("k[i] = int64(a[i] + 3000000000)", 0, "3000000000 needs more than 32 bits: write int64(...) around the number"),
    ("k[i] = k[i] & WIDE", 0, "WIDE needs more than 32 bits"),
    ("k[i] = int64(1 << 40)", 0, "1 << 40 needs more than 32 bits"),
    ("o[i] = int(3000000000)", 0, "3000000000 does not fit into int32"),
    ("k[i] = int64(THREE)\no[i] = a[i] // THREE", 1, "THREE is used in 32 bits and in 64 bits here"),
    ("k[i] = int64(uint64(-1))", 0, "-1 does not fit into uint64"),
    ("y[i] = 1.0 if i > 0 else 0", 0, "the two values are float32 and int32"),
    ("o[i] += 1", 0, "`+=` on an array hides an atomic: write `o[i] = o[i] + ...`"),
    ("p[i][0] += 1.0", 0, "`+=` on an array hides an atomic"),
    ("b = a", 0, "an array has one name: use the parameter itself"),
    ("o[i] = a + 1", 0, "`+` on a whole array: index it"),
    ("o[i] = abs(a)", 0, "abs takes numbers, not a whole array"),
    ("o[i] = a[-1]", 0, "negative indices do not count from the end here"),
    ("o[i] = a[y[i]]", 0, "an index is a whole number, not float32"),
    ("o[i] = a[i, 0]", 0, "an array with 1 axes takes 1 indices"),
    ("o[i] = g[i][0]", 0, "an array with 2 axes takes 2 indices in one pair of brackets"),
    ("for j in range(k[i]):\n    o[i] = j", 0, "range runs over int32, not int64: write int(...)"),
    ("atomic_add(o, i, k[i])", 0, "atomic_add of int64 on an array of int32: convert with int(...)"),
    ("atomic_max(g, i, 1.0)", 0, "with an index for each axis"),
    ("atomic_add(p, i, p[i])", 0, "it works on numbers of 32 or 64 bits"),
    ("y[i] = sqrt(a[i])", 0, "sqrt is not for int32: it takes floats of one type"),
    ("y[i] = min(y[i], 2)", 0, "min of float32 and int32: convert with float(...)"),
    ("y[i] = min(y[i], y[i], y[i])", 0, "min takes 2 arguments, got 3"),
    ("y[i] = helper(a[i])", 0, "argument 1 of helper is float32, got int32: convert with float(...)"),
    ("y[i] = helper(y[i], y[i])", 0, "helper takes 1 arguments, got 2"),
    ("y[i] = first(o)", 0, "argument 1 of first is array of float32, got array of int32"),
    ("if i > 0 and first(y) > 1.0:\n    o[i] = 1", 0, "first(...) would run in any case: call it in an `if` statement"),
    ("x = atomic_add(o, 0, 1) if i > 0 else 3", 0, "atomic_add(...) would run in any case"),
    ("p[i] = p[i - 1] if i > 0 else p[i]", 0, "both vectors would be evaluated: choose with an `if` statement"),
    ("x, w = helper(y[i]), 1, 2", 0, "2 names for 3 values"),
    ("x, w = n, 1\nx, w = w, x", 0, "one variable a line: Warp copies nothing here"),
    # numbers beside other types
    ("z[i] = z[i] * 2", 0, "`*` between float64 and int32: convert with float64(...)"),
    ("k[i] = k[i] * 0.5", 0, "`*` between int64 and float32"),
    ("y[i] = y[i] * 2", 0, "`*` between float32 and int32"),
    ("z[i] = z[i] * (0.5 + 0.25)", 0, "`*` between float64 and float32"),
    ("z[i] = z[i] * THIRD", 0, "`*` between float64 and float32"),
    ("x = 0.0\nx = z[i]", 1, "x was float32 and becomes float64"),
    ("x = 0.0\nfor j in range(n):\n    x += z[j]", 2, "`+` between float32 and float64"),
    ("a[i] = 1\nk[i] = k[i] + 9223372036854775808", 1, "9223372036854775808 does not fit into int64"),
    ("c[i] = c[i] - -1", 0, "-1 does not fit into uint32"),
    ("atomic_add()", 0, "atomic_add(array, index, value), with an index for each axis"),
    ("u[i] = 256", 0, "256 does not fit into uint8"),
    ("a[i] = int(u[i] == -1)", 0, "-1 does not fit into uint8"),
    # vectors and matrices
    ("m = mat33(0.0)\nq = m * m", 1, "`*` between matrices means two things: write `@`"),
    ("m = mat33(0.0)\np[i] = m * p[i]", 1, "write `@` for the product"),
    ("m = mat33(0.0)\nq = m @ m", 1, "`@` between matrices is fused by Warp alone: take multiply33"),
    ("m = mat33(0.0)\nm *= m", 1, "write `@` for the product"),
    ("m = mat33(0.0)\ny[i] = m[1][2]", 1, "write m[row, column]"),
    ("m = mat33(0.0)\nm[1] = p[i]", 1, "write m[row, column]"),
    ("p[i] = p[i] * p[i]", 0, "`*` between vector of 3 float32 and vector of 3 float32: write it out by components"),
    ("y[i] = p[i] @ p[i]", 0, "it takes a matrix; dot(a, b) is for vectors"),
    ("p[i] = mat44(0.0) @ p[i]", 0, "the sizes do not fit"),
    ("if p[i] == p[i]:\n    o[i] = 1", 0, "a comparison of a vector of 3 float32: compare its components"),
    ("if p[i]:\n    o[i] = 1", 0, "neither true nor false"),
    ("p[i] = floor(p[i])", 0, "floor is not for vector of 3 float32"),
    ("y[i] = dot(p[i], vec2(1.0, 2.0))", 0, "it takes vectors that fit each other"),
    ("y[i] = p[i][3]", 0, "component 3 of a vector of 3 float32"),
    ("p[i] = vec3()", 0, "vec3() is empty: give all components, or one fill value"),
    ("p[i] = vec3(1.0, 2.0)", 0, "vec3 takes 3 components or one fill value, not 2"),
    ("p[i] = vec3(z[i], z[i], z[i])", 0, "vec3(...) takes float32, not float64: convert with float(...)"),
    ("m = mat33(p[i], p[i], p[i])", 0, "mat33 takes 9 components or one fill value, not 3"),
    ("p[i] = transpose(p[i])", 0, "transpose is not for vector of 3 float32: it takes a matrix"),
]
KERNEL = """
import numpy

TABLE = (1, 2)
THREE = 3
THIRD = 1.0 / 3.0
WIDE = 0xFFFF_FFFF
NUMPY = numpy.int64(3)

@func
def helper(x: float) -> float:
    return x

@func
def first(a: array(dtype=float32)) -> float:
    return a[0]

@kernel
def faulty_kernel(
    a: array(dtype=int32), k: array(dtype=int64), u: array(dtype=uint8), y: array(dtype=float32),
    z: array(dtype=float64), c: array(dtype=uint32), p: array(dtype=vec3), g: array(dtype=float32, ndim=2), n: int,
    o: array(dtype=int32),
):
    i = tid()
"""
FIRST_LINE = KERNEL.count("\n") + 3  # after the two lines that write_kernels puts before


@pytest.mark.parametrize(("body", "line", "message"), REFUSED, ids=[body for body, _, _ in REFUSED])
def test_a_kernel_outside_the_language_is_refused(write_kernels, tmp_path, body, line, message):
    source = KERNEL + "".join(f"    {text}\n" for text in body.splitlines())
    with pytest.raises(KernelLanguageError) as caught:
        write_kernels("faulty", source)
    assert caught.value.msg.startswith("faulty_kernel: ") and message in caught.value.msg
    assert caught.value.filename.endswith("faulty.py") and caught.value.lineno == FIRST_LINE + line


INVALID_KERNELS = {
    "@kernel\ndef k(a: array(dtype=int32)):\n    a[0] = 1\n": "the first statement of a kernel is `i = tid()`",
    "@kernel\ndef k(a):\n    i = tid()\n": "parameter a needs a type",
    "@kernel\ndef k(a: bool):\n    i = tid()\n": "parameter a is no number, vector, matrix or array of them; write int",
    "@kernel\ndef k(a: str):\n    i = tid()\n": "parameter a is no number",
    "@kernel\ndef k(new: int):\n    i = tid()\n": "new is a word of C++, which no parameter may be called",
    "@kernel\ndef k(a: array(dtype=bool)):\n    i = tid()\n": "write uint8 for flags",
    "@kernel\ndef k(a: int = 3):\n    i = tid()\n": "parameters are positional, without defaults",
    "@kernel\ndef k(*a: int):\n    i = tid()\n": "parameters are positional, without defaults",
    "@kernel\ndef k(a: 'int'):\n    i = tid()\n": "remove `from __future__ import annotations`",
    "@func\ndef f(x: int) -> float:\n    return x\n": "returns int32, declared float32",
    "@func\ndef f(x: int) -> tuple[int, float]:\n    return x, x\n": "returns (int32, int32), declared (int32, f",
    "@func\ndef f(a: array(dtype=int32)):\n    return a\n": "arrays are not returned",
    "@func\ndef f(x: int) -> int:\n    if x > 0:\n        return 1\n    return 2\n": "one `return`, as its last",
    "@func\ndef f(x: int) -> int:\n    return f(x - 1)\n": "f is not known here",
    "@func\ndef f(x: int) -> int:\n    i = tid()\n    return i\n": "tid() is called once, first in a kernel",
    "@reduction\ndef r(a: array(dtype=vec3)):\n    i = tid()\n    return a[i]\n": "names the type of its vector",
    "@reduction\ndef r(a: array(dtype=vec3)) -> float:\n    i = tid()\n    return a[i][0]\n": "the type of its vector",
    "@reduction\ndef r(a: array(dtype=vec3)) -> vec3:\n    i = tid()\n": "a reduction returns its vector",
    "@reduction\ndef r(a: array(dtype=vec3)) -> vec4:\n    i = tid()\n    return a[i]\n": "returns vector of 3 float32",
    "def make():\n    n = 3\n    @func\n    def f(x: int) -> int:\n        return x + n\nmake()\n": "closes over n",
    "@loop\ndef w(n: int):\n    for j in range(n):\n        x = j\n": "a loop hands out its variable with `yield`",
    "@loop\ndef w(n: int):\n    for j in range(n):\n        x = yield j\n": "`yield` stands on a line of its own",
    "@loop\ndef w(n: int):\n    for j in range(n):\n        yield\n": "`yield` hands out a value",
    "@loop\ndef w(n: int):\n    yield n\n    return\n": "a loop has no `return`",
    "@loop\ndef w(n: int):\n    n = n + 1\n    yield n\n": "n is a parameter: change a copy",
    "@loop\ndef w(n: int):\n    yield n\n    yield n, n\n": "every `yield` of a loop hands out as many values",
    "@loop\ndef w(n: int) -> float:\n    yield n\n": "hands out (int32), declared (float32)",
    "@loop\ndef w(n: int):\n    yield n + 1.5\n": "`+` between int32 and float32",
    "@loop\ndef w(n: int):\n    yield unknown\n": "unknown is not known here",
    "@loop\ndef w(n):\n    yield n\n": "parameter n needs a type",
    "@kernel\ndef w(a: array(dtype=int32), f: callback):\n    i = tid()\n": "a kernel takes no function",
}


@pytest.mark.parametrize("source", INVALID_KERNELS, ids=list(INVALID_KERNELS.values()))
def test_a_function_outside_the_language_is_refused(write_kernels, source):
    with pytest.raises(KernelLanguageError) as caught:
        write_kernels("faulty", source)
    assert INVALID_KERNELS[source] in caught.value.msg and caught.value.filename.endswith("faulty.py")


def test_the_error_is_printed_with_file_and_line(write_kernels):
    with pytest.raises(SyntaxError, match="k:"):
        write_kernels("faulty", "@kernel\ndef k(a: array(dtype=int32)):\n    i = tid()\n    print(a[i])\n")

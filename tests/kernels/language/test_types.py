"""Structures and literals: fields and types that both compilers get, and errors that name the source."""

import ast
from types import SimpleNamespace

import numpy as np
import pytest
import warp as wp

from pointloom.kernels import lang, memory
from pointloom.kernels.language.source import KernelLanguageError

pytestmark = pytest.mark.both_compilers
STRUCTURES = """
@struct
class Curve:
    codes: array(dtype=int32)
    low: vec3

@struct
class Tree:
    count: int
    curve: Curve
    points: array(dtype=vec3)

@func
def code_at(curve: Curve, i: int) -> int:
    return curve.codes[i]

@func
def height(tree: Tree, i: int) -> float:
    return tree.points[i][2] - tree.curve.low[2]

@func
def double(curve: Curve, i: int):
    curve.codes[i] = curve.codes[i] * 2
"""
KERNELS = f"""{STRUCTURES}
@kernel
def read_kernel(tree: Tree, scale: float, out: array(dtype=float32)):
    i = tid()
    if i < tree.count:
        out[i] = scale * height(tree, i) + float(code_at(tree.curve, i))

@kernel
def double_kernel(tree: Tree):
    i = tid()
    double(tree.curve, i)

@reduction
def sum_codes(curve: Curve) -> vec2:
    i = tid()
    return vec2(float(curve.codes[i]), float(curve.codes.shape[0]))
"""


@pytest.fixture(scope="module")
def kernels(write_kernels):
    return write_kernels("structures", KERNELS)


@pytest.fixture
def tree(device):
    points = memory.upload(np.arange(15, dtype=np.float32).reshape(5, 3), lang.vec3, device)
    curve = SimpleNamespace(codes=memory.upload(np.arange(5) * 10, lang.int32, device), low=np.array([0, 0, 1.0]))
    return SimpleNamespace(count=4, curve=curve, points=points)


def test_kernels_reductions_and_functions_take_any_object_that_has_the_fields(device, kernels, tree):
    out = memory.zeros(5, lang.float32, device)
    lang.launch(kernels.read_kernel, 5, [tree, 0.5, out])
    heights = np.arange(15).reshape(5, 3)[:, 2] - 1.0
    np.testing.assert_array_equal(memory.download(out), [*(0.5 * heights + np.arange(5) * 10)[:4], 0.0])
    np.testing.assert_array_equal(memory.download(lang.reduce(kernels.sum_codes, 5, [tree.curve])), [[100.0, 25.0]])
    lang.launch(kernels.double_kernel, 5, [tree])  # a function writes to an array of the structure
    np.testing.assert_array_equal(memory.download(tree.curve.codes), np.arange(5) * 20)


def test_only_fields_that_are_used_are_passed(kernels):
    assert list(kernels.read_kernel.source.parameters) == [
        "tree__count", "tree__curve__codes", "tree__curve__low", "tree__points", "scale", "out",
    ]  # fmt: skip
    assert list(kernels.double_kernel.source.parameters) == ["tree__curve__codes"]


def test_arguments_are_named_as_they_are_written(device, kernels, tree):
    out = memory.zeros(5, lang.float32, device)
    with pytest.raises(TypeError, match="read_kernel:"):
        tree.curve.codes = out
        lang.launch(kernels.read_kernel, 5, [tree, 0.5, out])
    with pytest.raises(TypeError, match="read_kernel:"):
        del tree.points
        lang.launch(kernels.read_kernel, 5, [tree, 0.5, out])
    with pytest.raises(ValueError, match="read_kernel:"):
        lang.launch(kernels.read_kernel, 5, [tree, out])


REFUSED = {
    "t = tree": "tree is a structure: read a field of it, or pass it on to a function",
    "c = tree.curve": "tree.curve is a structure: read a field of it",
    "out[i] = tree.height": "Tree has no field height: it has count, curve, points",
    "tree.count = 3": "tree.count belongs to the host: keep a variable of your own",
    "out[i] = float(code_at(tree, i))": "argument 1 of code_at is no Tree",
    "out[i] = float(code_at(out, i))": "argument 1 of code_at is a Curve",
    "out[i] = float(code_at(tree.curve))": "code_at takes 2 arguments, got 1",
    "out[i] = tree.points[i]": "out[i] is float32, the value is vector of 3 float32",
    "out[i] = tree.count": "out[i] is float32, the value is int32",
    "out[i] = tree.count + 1.5": "`+` between int32 and float32",
    "tree__count = 3": "tree__count: two underscores join a structure and its field; choose another name",
    "out[i] = code_at": "code_at is a function: call it, or hand it on to a `callback`",
    "out[i] = tree.points": "out[i] is float32, the value is array of vector of 3 float32",
    "x = double(tree.curve, i)": "double returns nothing: call it on a line of its own",
}


@pytest.mark.parametrize("body", REFUSED)
def test_unsupported_structures_are_refused(write_kernels, body):
    source = f"{STRUCTURES}\n@kernel\ndef k(tree: Tree, out: array(dtype=float32)):\n    i = tid()\n    {body}\n"
    with pytest.raises(KernelLanguageError) as caught:
        write_kernels("faulty_structures", source)
    assert REFUSED[body] in caught.value.msg
    assert caught.value.lineno == source.count("\n") + 2  # after the two lines that write_kernels puts before


FAULTY = {
    "@func\ndef f(tree: Tree) -> float:\n    return tree.count\n": "^f:.*int32.*float32",
    "@func\ndef f(tree: Tree) -> int:\n    return abs(tree.points)\n": "^f:",
    "@kernel\ndef f(t: Tree):\n    i = tid()\n    t.curve.codes[i] += 1\n": r"^f:(.*t\.curve\.codes\[i){2}",
    "@func\ndef f(i: int) -> Curve:\n    return i\n": "^f:",
    "@struct\nclass A:\n    x: str\n@func\ndef f(a: A) -> int:\n    return int(a.x)\n": r"^f:.*a\.x",
}


@pytest.mark.parametrize("source", FAULTY)
def test_errors_name_fields_with_a_dot(write_kernels, source):
    with pytest.raises(KernelLanguageError, match=FAULTY[source]):
        write_kernels("faulty_structures", f"{STRUCTURES}\n{source}")


DECLARATIONS = {
    "@struct\nclass A:\n    pass\n": "A: a structure needs an annotated attribute for each field",
    "@struct\nclass A:\n    x__y: int\n": r"A\.x__y: two underscores join a structure and its field",
    "@struct\nclass A:\n    x: 'int'\n": "A: remove `from __future__ import annotations`",
}


@pytest.mark.parametrize("source", DECLARATIONS)
def test_a_structure_without_types_is_refused(write_kernels, source):
    with pytest.raises(TypeError, match=DECLARATIONS[source]):
        write_kernels("faulty_structures", source)


KERNEL = """
NO_KEY = 0x7FFF_FFFF_FFFF_FFFF
FAR = 100
THIRD = 1.0 / 3.0
pair = vector(2, float64)

@func
def scaled(x: float64, factor: float64) -> float64:
    return x * factor

@kernel
def text_kernel(
    a: array(dtype=int32), k: array(dtype=int64), u: array(dtype=uint8), y: array(dtype=float32),
    z: array(dtype=float64), q: array(dtype=uint32), p: array(dtype=vec3d), n: int, far: float64,
):
    i = tid()
"""
# (as it is written, as both compilers see it)
WRITTEN = [
    # numbers of 32 bits are what they are
    ("a[i] = a[i] + 1", "a[i] = a[i] + 1"), ("y[i] = 2.0 * y[i]", "y[i] = 2.0 * y[i]"),
    # either side of an operator, nested
    ("z[i] = z[i] * 0.5", "z[i] = z[i] * float64(0.5)"), ("z[i] = 0.5 * z[i]", "z[i] = float64(0.5) * z[i]"),
    ("z[i] = 1.0 - z[i] * (z[i] + 0.1)", "z[i] = float64(1.0) - z[i] * (z[i] + float64(0.1))"),
    ("z[i] = -1.5 * z[i]", "z[i] = float64(-1.5) * z[i]"), ("z[i] = -(0.5 * z[i])", "z[i] = -(float64(0.5) * z[i])"),
    ("k[i] = (k[i] << 32) | 0xFFFFFFFF", "k[i] = k[i] << int64(32) | int64(4294967295)"),
    ("q[i] = q[i] >> 3", "q[i] = q[i] >> uint32(3)"), ("p[i] = p[i] * 0.5", "p[i] = p[i] * float64(0.5)"),
    ("p[i] = 1.0 / p[i]", "p[i] = float64(1.0) / p[i]"),
    # comparisons, choices, the least and the most
    ("a[i] = int(z[i] > 0.0)", "a[i] = int(z[i] > float64(0.0))"),
    ("a[i] = int(0 < k[i])", "a[i] = int(int64(0) < k[i])"),
    ("if u[i] != 0:\n    a[i] = 1", "if u[i] != uint8(0):\n    a[i] = 1"),
    ("z[i] = z[i] if n > 0 else 0.0", "z[i] = z[i] if n > 0 else float64(0.0)"),
    ("z[i] = min(max(z[i], 0.0), 1.0)", "z[i] = min(max(z[i], float64(0.0)), float64(1.0))"),
    ("z[i] = pow(z[i], 2.0)", "z[i] = pow(z[i], float64(2.0))"),
    # elements, parameters, constructors, variables that are there
    ("u[i] = 1", "u[i] = uint8(1)"), ("k[i] = -1", "k[i] = int64(-1)"),
    ("z[i] = scaled(z[i], 2.0)", "z[i] = scaled(z[i], float64(2.0))"),
    ("atomic_add(k, 0, 1)", "atomic_add(k, 0, int64(1))"),
    ("atomic_max(k, 0, 3000000000)", "atomic_max(k, 0, int64(3000000000))"),
    ("p[i] = vec3d(z[i], 0.0, -1.0)", "p[i] = vec3d(z[i], float64(0.0), float64(-1.0))"),
    ("v = pair(0.1)\nv[1] = 2.0", "v = pair(float64(0.1))\nv[1] = float64(2.0)"),
    ("x = far\nx = 1.5\nx += 0.5", "x = far\nx = float64(1.5)\nx += float64(0.5)"),
    # between two numbers nothing gives them another type
    ("y[i] = y[i] * (0.5 + 0.25)", "y[i] = y[i] * (0.5 + 0.25)"),
    ("z[i] = float64(0.5 + 0.25)", "z[i] = float64(0.5 + 0.25)"),
    # what begins a variable
    ("x = 0\nfor j in range(n):\n    x += j", "x = int(0)\nfor j in range(n):\n    x += j"),
    ("x = -1.0\nif n > 0:\n    x = y[i]", "x = float(-1.0)\nif n > 0:\n    x = y[i]"),
    ("x = -FAR\nwhile x < n:\n    x += 1", "x = int(-FAR)\nwhile x < n:\n    x += 1"),
    ("x = 6\nfor j in range(x):\n    a[j] = 0", "x = 6\nfor j in range(x):\n    a[j] = 0"),
    ("x = 1\nx = 2\na[i] = x", "x = 1\nx = 2\na[i] = x"),
    ("x = n\nwhile x > 0:\n    x -= 1", "x = n\nwhile x > 0:\n    x -= 1"),
    ("x = int64(NO_KEY)\nfor j in range(n):\n    x = min(x, k[j])",
     "x = int64(NO_KEY) + int64(0)\nfor j in range(n):\n    x = min(x, k[j])"),
    ("x = float64(THIRD)\nwhile x < far:\n    x += 1.0",
     "x = float64(THIRD) + float64(0.0)\nwhile x < far:\n    x += float64(1.0)"),
    ("x = int64(NO_KEY)\nif n > 0:\n    x = k[0]", "x = int64(NO_KEY)\nif n > 0:\n    x = k[0]"),
    ("x = far\nif n > 0:\n    x = 0.0\n    while x < far:\n        x += 1.0",
     "x = far\nif n > 0:\n    x = float64(0.0)\n    while x < far:\n        x += float64(1.0)"),
]  # fmt: skip
VALUES = """
NO_KEY = 0x7FFF_FFFF_FFFF_FFFF

@kernel
def tenth_kernel(values: array(dtype=float64)):
    i = tid()
    values[i] = values[i] * 0.1 + 1.0e-20

@kernel
def least_kernel(keys: array(dtype=int64), count: int, out: array(dtype=int64)):
    i = tid()
    least = int64(NO_KEY)
    most = int64(0)
    before = int64(NO_KEY)
    for k in range(count):
        before = min(before, keys[k])
        most = max(most, keys[k])
    turns = 0
    left = count
    while left > 0:
        left = left // 2
        turns += 1
    out[0] = before
    out[1] = int64(NO_KEY)
    out[2] = most
    out[3] = int64(turns)
    out[4] = least
    out[5] = int64(count)
"""


@pytest.fixture(scope="module")
def values(write_kernels):
    return write_kernels("values", VALUES)


@pytest.mark.parametrize(("written", "seen"), WRITTEN, ids=[written for written, _ in WRITTEN])
def test_a_number_takes_the_type_of_the_other_operand(write_kernels, written, seen):
    lines = "".join(f"    {line}\n" for line in written.splitlines())
    kernel = write_kernels("texts", KERNEL + lines).text_kernel
    assert ast.unparse(kernel.source.definition.body[1:]) == ast.unparse(ast.parse(seen).body)
    kernel.function  # noqa: B018  what is compiled


def test_a_file_need_not_import_the_types_that_its_numbers_take(tmp_path, write_kernels):
    source = (
        "from pointloom.kernels.lang import array, kernel, tid, float64 as real\n"
        "del float64\n"
        "@kernel\ndef half_kernel(x: array(dtype=real)):\n    i = tid()\n    x[i] = (x[i] + 1.0) * 0.5 + x[i]\n"
    )
    kernel = write_kernels("without", source).half_kernel
    values = wp.array([3.0], dtype=wp.float64, device="cpu")
    lang.launch(kernel, 1, [values])
    assert values.numpy().tolist() == [5.0]


def test_a_number_beside_a_float64_has_all_its_digits(values, device):
    result = wp.array([0.3, 0.0, 7.0], dtype=wp.float64, device=device)
    lang.launch(values.tenth_kernel, 3, [result])
    assert result.numpy().tolist() == [0.3 * 0.1 + 1e-20, 1e-20, 7.0 * 0.1 + 1e-20]


def test_a_variable_that_begins_as_a_constant_or_a_parameter_leaves_that_as_it_is(values, device):
    keys = wp.array(np.array([9, 3, 1 << 40], np.int64), device=device)
    out = wp.zeros(6, dtype=wp.int64, device=device)
    lang.launch(values.least_kernel, 1, [keys, 3, out])
    assert out.numpy().tolist() == [3, 2**63 - 1, 1 << 40, 2, 2**63 - 1, 3]

"""Both compilers get the used fields of structures; errors name them as in the source."""

from types import SimpleNamespace

import numpy as np
import pytest

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


def test_kernels_read_the_fields_of_any_object_that_has_them(device, kernels, tree):
    out = memory.zeros(5, lang.float32, device)
    lang.launch(kernels.read_kernel, 5, [tree, 0.5, out])
    heights = np.arange(15).reshape(5, 3)[:, 2] - 1.0
    np.testing.assert_array_equal(memory.download(out), [*(0.5 * heights + np.arange(5) * 10)[:4], 0.0])


def test_functions_write_to_the_arrays_of_a_structure(device, kernels, tree):
    lang.launch(kernels.double_kernel, 5, [tree])
    np.testing.assert_array_equal(memory.download(tree.curve.codes), np.arange(5) * 20)


def test_reductions_take_structures(device, kernels, tree):
    np.testing.assert_array_equal(memory.download(lang.reduce(kernels.sum_codes, 5, [tree.curve])), [[100.0, 25.0]])


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

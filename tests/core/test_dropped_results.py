"""Statements that drop a result warn, other calls do not, and every operation has the guard."""

import inspect
import io
import warnings
from types import ModuleType

import pytest

import pointloom as loom
from pointloom.core import dropped_results
from pointloom.core.dropped_results import returns_new


class Box:
    @returns_new
    def scale(self, factor=1):
        return Box()

    @returns_new
    def cut(self):
        return Box(), [1]


@returns_new
def optimize(box):
    return Box()


DROPPED = """
box.scale()
(box
 .scale())
box.scale(*[2])
Box.scale(box)
box.cut()
boxes[0].scale().scale()
box and box.scale()
optimize(box)
for b in boxes: b.scale(2)
"""
TAKEN = """
taken = box.scale()
_, rows = box.cut()
boxes.append(box.scale())
boxes.extend(map(Box.scale, boxes[:1]))
boxes.extend(map(lambda b: b.scale(), boxes[:1]))
boxes += [b.scale() for b in boxes[:1]]
list(map(save, map(Box.scale, boxes)))
list(boxes).append(box.scale())
print(*(b.scale() for b in boxes), file=nowhere)
for b in [b.scale() for b in boxes]: b
"""


def lines(text):
    return text.strip().replace("\n ", "\r ").split("\n")


def warned(line, *, in_a_function):
    names = {"box": Box(), "boxes": [Box(), Box()], "factor": 2, "save": bool, "nowhere": io.StringIO()}
    source = line.replace("\r", "\n")
    if in_a_function:
        body = source.replace("\n", "\n  ")
        source = f"def user(box, boxes, save, nowhere, factor):\n  {body}\nuser(**given)"
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        exec(compile(source, "<user>", "exec"), {**names, "given": names, "Box": Box, "optimize": optimize})
    return [str(warning.message) for warning in caught]


@pytest.mark.parametrize("in_a_function", [False, True])
def test_only_a_call_that_is_a_statement_warns(in_a_function):
    for line in lines(DROPPED):
        messages = warned(line, in_a_function=in_a_function)
        assert any("the result is discarded" in message for message in messages), line
    for line in lines(TAKEN):
        assert warned(line, in_a_function=in_a_function) == [], line
    pair = "Box.cut: the result is discarded; it returns a new object and changes nothing: write box, _ = box.cut(...)"
    assert warned("box.cut()", in_a_function=in_a_function) == [pair]


def test_code_without_positions_warns_of_nothing():
    bare = compile("box.scale()", "<user>", "exec").replace(co_linetable=b"")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        exec(bare, {"box": Box()})


def test_an_unknown_python_warns_of_nothing(monkeypatch):
    monkeypatch.setattr(dropped_results, "READS_BYTECODE", False)
    assert warned("box.scale()", in_a_function=True) == []


FOR_CODE_ON_THE_DEVICE = {"geometry"}


def public_classes(module):
    for name in module.__all__:
        value = getattr(module, name)
        if inspect.isclass(value):
            yield value
        elif isinstance(value, ModuleType) and hasattr(value, "__all__"):
            yield from public_classes(value)


def returns_its_own(kind, method):
    """Whether a method returns an object of its class, or a pair whose first is one."""
    annotation = method.__annotations__.get("return", "")
    text = annotation if isinstance(annotation, str) else getattr(annotation, "__name__", "")
    first = text.removeprefix("tuple[").split(",")[0]
    return first in {"Self", *(base.__name__ for base in kind.__mro__[:-1])}


def test_every_method_that_returns_its_own_class_has_the_guard():
    methods = {
        (kind.__name__, name): method
        for kind in public_classes(loom)
        for name, method in inspect.getmembers(kind, inspect.isfunction)
        if not name.startswith(("_", "get_")) and name not in FOR_CODE_ON_THE_DEVICE
    }
    kinds = {kind.__name__: kind for kind in public_classes(loom)}
    guarded = {key: method for key, method in methods.items() if returns_its_own(kinds[key[0]], method)}
    assert [".".join(key) for key, method in guarded.items() if not hasattr(method, "__wrapped__")] == []
    assert {("LineSet", "transform"), ("PointCloud", "to"), ("TriangleMesh", "repair")} <= guarded.keys()

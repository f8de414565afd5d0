"""Results that nobody takes are told, those that somebody takes are not, and no operation is without the guard."""

import inspect
import io
import warnings
from types import ModuleType

import pytest

import pointloom as loom
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
[b.scale() for b in boxes]
[b.scale(f) for b in boxes for f in (1, 2)]
[b.scale() for b, _ in zip(boxes, boxes) if b]
{b.scale() for b in boxes}
{1: b.scale() for b in boxes}
list(map(lambda b: b.scale(factor), boxes))
list(map(Box.scale, boxes))
tuple(b.scale(factor) for b in boxes)
"""
TAKEN = """
taken = box.scale()
_, rows = box.cut()
boxes.append(box.scale())
boxes.extend(map(Box.scale, boxes[:1]))
boxes.extend(map(lambda b: b.scale(), boxes[:1]))
boxes.extend(b.scale() for b in boxes[:1])
boxes += [b.scale() for b in boxes[:1]]
taken = [b.scale(f) for b in boxes for f in (1, 2)]
taken = [[b.scale() for b in boxes] for _ in boxes]
len([b.scale() for b in boxes])
list(map(save, map(Box.scale, boxes)))
list(map(save, map(lambda b: b.scale(), boxes)))
list(map(save, (b.scale() for b in boxes)))
list(map(lambda b: save(b.scale(factor)), boxes))
list(boxes).append(box.scale())
print(*(b.scale() for b in boxes), file=nowhere)
for b in [b.scale() for b in boxes]: b
for b in (b.scale() for b in boxes): b
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
def test_what_nobody_takes_is_told_and_what_somebody_takes_is_not(in_a_function):
    for line in lines(DROPPED):
        messages = warned(line, in_a_function=in_a_function)
        assert any("the result is dropped" in message for message in messages), line
    for line in lines(TAKEN):
        assert warned(line, in_a_function=in_a_function) == [], line
    pair = "Box.cut: the result is dropped; it returns a new object and changes nothing: write box, _ = box.cut(...)"
    assert warned("box.cut()", in_a_function=in_a_function) == [pair]


def test_without_positions_of_the_source_a_call_on_its_own_is_told():
    code = compile("box.scale()", "<user>", "exec")
    bare = code.replace(co_linetable=b"")
    with pytest.warns(loom.DroppedResultWarning):
        exec(bare, {"box": Box()})


FOR_CODE_ON_THE_DEVICE = {"with_arrays", "select_rows", "geometry"}


def public_classes(module):
    for name in module.__all__:
        value = getattr(module, name)
        if inspect.isclass(value):
            yield value
        elif isinstance(value, ModuleType) and hasattr(value, "__all__"):
            yield from public_classes(value)


def returns_its_own(kind, method):
    """Whether a method returns an object of its class, or a pair whose first is one."""
    said = method.__annotations__.get("return", "")
    first = (said if isinstance(said, str) else getattr(said, "__name__", "")).removeprefix("tuple[").split(",")[0]
    return first in {"Self", *(base.__name__ for base in kind.__mro__[:-1])}


def test_every_method_that_returns_its_own_class_has_the_guard():
    found = {
        (kind.__name__, name): method
        for kind in public_classes(loom)
        for name, method in inspect.getmembers(kind, inspect.isfunction)
        if not name.startswith(("_", "get_")) and name not in FOR_CODE_ON_THE_DEVICE
    }
    own = {key: method for key, method in found.items() if returns_its_own(loom_class(key[0]), method)}
    assert [".".join(key) for key, method in own.items() if not hasattr(method, "__wrapped__")] == []
    assert {("LineSet", "transform"), ("PointCloud", "to"), ("TriangleMesh", "repair")} <= own.keys()


def loom_class(name):
    return next(kind for kind in public_classes(loom) if kind.__name__ == name)

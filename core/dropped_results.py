"""A warning where the result of an operation is dropped that Open3D would have made in place."""

from __future__ import annotations

import dis
import functools
import opcode
import sys
import warnings
from collections.abc import Callable
from types import CodeType, FrameType
from typing import TYPE_CHECKING, Any, NamedTuple, ParamSpec, TypeVar, cast

from .told_arguments import is_of_call, mismatch

P = ParamSpec("P")
R = TypeVar("R")

_CACHE, _POP_TOP = opcode.opmap.get("CACHE", 0), opcode.opmap["POP_TOP"]

# What else the instruction after a call may do with its result.
_COLLECT = {opcode.opmap[name] for name in ("LIST_APPEND", "SET_ADD", "MAP_ADD")}
_HAND_ON = {opcode.opmap[name] for name in ("RETURN_VALUE", "YIELD_VALUE")}

COMPREHENSIONS = ("<listcomp>", "<setcomp>", "<dictcomp>")  # functions of their own up to Python 3.11
COLLECTORS = (list, tuple, set, frozenset)  # each runs over the whole of a `map` or a generator, and does nothing else
LOADS_OF_NAMES = ("LOAD_NAME", "LOAD_GLOBAL", "LOAD_FAST", "LOAD_DEREF", "LOAD_CLOSURE")
LOADS_OF_ATTRIBUTES = ("LOAD_ATTR", "LOAD_METHOD")
OF_A_NAME = {"PUSH_NULL", "PRECALL", "KW_NAMES", "CALL", "CALL_KW", "CALL_FUNCTION_EX"}  # beside the load, in its call
OWNERS = {"PointCloud": "cloud", "TriangleMesh": "mesh", "LineSet": "lines", "TSDFVolume": "volume"}
MOST_PLACES = 4096  # in programs, that what was found of them is kept for


class DroppedResultWarning(UserWarning):
    """An operation was called for nothing: it returns what it made, and nobody took it.

    Example:
        >>> import warnings, pointloom as loom
        >>> with warnings.catch_warnings():
        ...     warnings.simplefilter("error", loom.DroppedResultWarning)  # make it an error
    """


class Pair(tuple[Any, ...]):
    """A tuple of results that says so where it is taken for the first: `cloud.remove_radius_outlier(4, 0.1).points`."""

    __slots__ = ()

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:  # asked only where there is none
            if not self or name.startswith("_") or not hasattr(type(self[0]), name):
                raise AttributeError(f"'tuple' object has no attribute {name!r}")
            kinds = ", ".join(type(part).__name__ for part in self)
            taken = ", ".join([OWNERS.get(type(self[0]).__name__, "result"), *("_" * (len(self) - 1))])
            raise AttributeError(f"a tuple of {kinds} has no attribute {name!r}; take it apart: {taken} = ...")


class Place(NamedTuple):
    """What a program does around one of its calls."""

    code: CodeType  # kept, so that its id stays its own
    callee: str | None  # the name that is called, or the attribute; None where the compiler left no positions
    is_attribute: bool
    source: CodeType | str | None  # of list(..) and its like: a generator's code, or what is mapped: its code or name
    drops_list: bool  # whether the call is in a comprehension whose list nobody takes


_places: dict[tuple[int, int], Place] = {}


def returns_new(operation: Callable[P, R]) -> Callable[P, R]:
    """Marks an operation that changes its object in Open3D, or returns another of its kind, and returns a new one here.

    A call whose result nobody takes warns: `cloud.estimate_normals()` on a line of its own, and of a pair
    `cloud.remove_radius_outlier(16, 0.05)`; so do lists that nobody takes, `[c.scale(2) for c in clouds]` and
    `list(map(lambda c: c.scale(2), clouds))`. What an interactive prompt shows is taken. The check reads one
    instruction of the caller, in a microsecond; what it finds suspicious is looked at once for each place in a program.

    A call whose arguments do not fit is told as by `told_arguments`.

    Not told, since no instruction of the caller says it: results that a function of the user's own returns and that are
    dropped there (`def move(c): return c.scale(2)`, then `move(c)`), lists that are kept in a variable and never used,
    pairs of which only the second is kept (`_, rows = ...`), and what is only asked for its truth (`if c.scale(2):`).
    """

    @functools.wraps(operation)
    def call(*args: P.args, **kwargs: P.kwargs) -> R:
        try:
            result = operation(*args, **kwargs)
        except TypeError as error:
            if not is_of_call(error):
                raise
            raise mismatch(operation, args, kwargs, error) from None
        if _is_dropped(sys._getframe(1), call):
            warnings.warn(_message(operation, args, result), DroppedResultWarning, stacklevel=2)
        return cast(R, Pair(result)) if type(result) is tuple else result

    return call


def _message(operation: Callable[..., Any], args: tuple[Any, ...], result: Any) -> str:
    name = operation.__name__
    said, taken, call = name, "result", name
    if "." in operation.__qualname__:
        kind = type(args[0]).__name__
        taken = OWNERS.get(kind, "box" if kind.endswith("Box") else "result")
        said, call = f"{kind}.{name}", f"{taken if taken != 'result' else 'it'}.{name}"
    taken += ", _" if isinstance(result, tuple) else ""
    return f"{said}: the result is dropped; it returns a new object and changes nothing: write {taken} = {call}(...)"


def _is_dropped(caller: FrameType, operation: Any) -> bool:
    """Whether what the caller does after its call throws the result away."""
    follows = _next_instruction(caller)
    if follows == _POP_TOP:  # of this call, or of one that made it from C: list(map(operation, clouds))
        return _calls(caller, operation) or _collects(caller, operation)
    outer = caller.f_back
    if follows in _COLLECT:
        if caller.f_code.co_name in COMPREHENSIONS:
            return outer is not None and _next_instruction(outer) == _POP_TOP
        return _place(caller).drops_list
    if follows in _HAND_ON and outer is not None and _next_instruction(outer) == _POP_TOP:
        return _collects(outer, caller.f_code)
    return False


def _next_instruction(frame: FrameType) -> int:
    """The opcode after the one where a frame is; -1 at the end."""
    code = frame.f_code.co_code
    at = frame.f_lasti + 2
    while at < len(code) and code[at] == _CACHE:
        at += 2
    return code[at] if at < len(code) else -1


def _calls(frame: FrameType, operation: Any) -> bool:
    """Whether the call where a frame is is that of an operation; True where that cannot be known."""
    place = _place(frame)
    if place.callee is None or place.is_attribute:
        return place.callee in (None, operation.__name__)
    value = _value(frame, place.callee)
    return getattr(value, "__func__", value) is operation


def _collects(frame: FrameType, made_by: Any) -> bool:
    """Whether the call where a frame is makes a list of just what an operation, or a function's code, returns."""
    place = _place(frame)
    if not place.callee or place.is_attribute:
        return False
    if not any(_value(frame, place.callee) is collector for collector in COLLECTORS):
        return False
    if isinstance(place.source, str):
        if not isinstance(made_by, CodeType):
            return place.source.rpartition(".")[2] == made_by.__name__
        return getattr(_value(frame, place.source), "__code__", None) is made_by
    return place.source is made_by


def _value(frame: FrameType, name: str) -> Any:
    """What a name stands for in a frame; None where nothing is called so."""
    for names in (frame.f_locals, frame.f_globals, frame.f_builtins):
        if name in names:
            return names[name]
    return None


def _place(frame: FrameType) -> Place:
    """What the program does around the call where a frame is; looked up once for each place."""
    key = id(frame.f_code), frame.f_lasti
    if key not in _places:
        if len(_places) >= MOST_PLACES:
            _places.clear()
        _places[key] = _read_place(*key[1:], frame.f_code)
    return _places[key]


def _read_place(at: int, code: CodeType) -> Place:
    steps = list(dis.get_instructions(code))
    here = max(i for i, step in enumerate(steps) if step.offset <= at)
    where = steps[here].positions
    callee, is_attribute, source = None, False, None
    if where is not None and where.lineno is not None and where.col_offset is not None:
        callee = ""
        start = where.lineno, where.col_offset
        same = [i for i in range(here) if _start(steps[i]) == start]  # a call begins where its callee does
        names = [i for i in same if _is_load_of_name(steps[i])]
        attributes = [i for i in same if steps[i].opname in LOADS_OF_ATTRIBUTES]
        if attributes:
            callee, is_attribute = steps[attributes[-1]].argval, True
        elif names and all(i in names or steps[i].opname in OF_A_NAME for i in same):
            callee = steps[names[-1]].argval
            argument = steps[names[-1] + 1 : here]
            source = _source([step for step in argument if step.opname not in ("PUSH_NULL", "CACHE")])
    return Place(code, callee, is_attribute, source, _drops_list(steps, here))


def _start(step: dis.Instruction) -> tuple[int | None, int | None] | None:
    return (step.positions.lineno, step.positions.col_offset) if step.positions else None


def _is_load_of_name(step: dis.Instruction) -> bool:
    return step.opname.startswith(LOADS_OF_NAMES) and isinstance(step.argval, str)


def _source(argument: list[dis.Instruction]) -> CodeType | str | None:
    """What makes the items of `list(..)`, from the instructions of its argument."""
    is_map = bool(argument) and _is_load_of_name(argument[0]) and argument[0].argval == "map"
    steps = argument[1:] if is_map else argument
    for i, step in enumerate(steps):
        if isinstance(step.argval, CodeType):
            return step.argval if is_map or step.argval.co_name == "<genexpr>" else None
        if is_map and _is_load_of_name(step) and i == 0:
            dotted = [step.argval]
            while steps[i + 1].opname in LOADS_OF_ATTRIBUTES:
                i += 1
                dotted.append(steps[i].argval)
            closure = steps[i + 1].opname == "BUILD_TUPLE" or step.opname == "LOAD_CLOSURE"
            if not closure:
                return ".".join(dotted)
    return None


def _drops_list(steps: list[dis.Instruction], here: int) -> bool:
    """Whether the list that a call adds to is dropped after its loops, which Python 3.12 and later have in line."""
    after = steps[here:]
    while back := next((step for step in after if step.opname.startswith("JUMP_BACKWARD")), None):
        head = next(step for step in steps if step.offset == back.argval)
        if head.opname != "FOR_ITER":
            return False
        after = [step for step in steps if step.offset >= head.argval]
        ended = 0
        while after[ended].opname in ("END_FOR", "POP_ITER", "CACHE"):
            ended += 1
        if after[0].opname == "END_FOR" and sys.version_info[:2] == (3, 13):
            ended += 1  # which drops the iterator
        after = after[ended:]
        if after[0].opname.startswith("JUMP_BACKWARD"):  # of a loop around this one
            continue
        if after[0].opname == "SWAP":  # the names of the loops get their values of before back
            after = after[after[0].arg or 1 :]
        return after[0].opname == "POP_TOP"
    return False

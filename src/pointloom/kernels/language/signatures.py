"""Types of the kernel language and signatures of its built-ins: the intersection of Warp and Taichi.

Taichi's minimum of 8-bit numbers aborts the process, and its square root of an integer is an integer. Warp has neither.
"""

from __future__ import annotations

import ast
from collections.abc import Callable
from typing import Any, NamedTuple, TypeAlias

FLOATS = {"float32", "float64"}
RANGES = {f"{sign}int{bits}": bits for sign in ("", "u") for bits in (8, 16, 32, 64)}
SMALL = {"int8", "int16", "uint8", "uint16"}


class Type(NamedTuple):
    scalar: str
    shape: tuple[int, ...] = ()

    def __str__(self) -> str:
        if not self.shape:
            return self.scalar
        if len(self.shape) == 1:
            return f"vector of {self.shape[0]} {self.scalar}"
        return f"{self.shape[0]}x{self.shape[1]} matrix of {self.scalar}"


class ArrayType(NamedTuple):
    element: Type
    axes: int

    def __str__(self) -> str:
        return f"array of {self.element}" if self.axes == 1 else f"{self.axes}-D array of {self.element}"


INT, FLOAT, DOUBLE, BOOL = Type("int32"), Type("float32"), Type("float64"), Type("bool")
Inferred: TypeAlias = "Type | ArrayType | tuple | None"


def remedy(left: Inferred, right: Inferred = None) -> str:
    """How to unify two types."""
    if isinstance(right, Type) and isinstance(left, Type):
        order = ["int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64", "float32", "float64"]
        left = max(left, right, key=lambda t: order.index(t.scalar) if t.scalar in order else -1)
    if not isinstance(left, Type) or left.shape:
        left = Type(left.scalar) if isinstance(left, Type) else None
    return "convert one" if left is None else f"convert with {_constructor(left)}(...)"


def _constructor(kind: Type) -> str:
    return {"int32": "int", "float32": "float"}.get(kind.scalar, kind.scalar)


def words(kind: object) -> str:
    if isinstance(kind, tuple) and not isinstance(kind, Type | ArrayType):
        return "(" + ", ".join(words(part) for part in kind) + ")"
    return "an unknown type" if kind is None else str(kind)


ONE_FLOAT = {"floor", "ceil", "sqrt", "sin", "cos", "tan", "acos", "asin", "exp", "log"}
TWO_FLOATS = {"atan2", "pow"}
LANES = {"lane": 0, "ballot": 1, "shuffle": 2, "shuffle_xor": 2, "sync_lanes": 0, "sync_block": 0}
LOADS = {"load_eight": (Type("float32", (3,)), 24), "load_six": (FLOAT, 6), "load_nine": (FLOAT, 9)}
ATOMIC = {"int32", "int64", "uint32", "uint64", "float32", "float64"}


def check_builtin(fail: Callable[..., Any], node: ast.Call, name: str, kinds: list[Inferred]) -> Inferred:
    """Result type of a built-in. Rejects arguments that one of the compilers does not accept."""
    if name.startswith("atomic_"):
        return _check_atomic(fail, node, name, kinds)
    if name in LOADS:
        element, count = LOADS[name]
        if kinds != [ArrayType(element, 1), INT]:
            fail(node, f"{name} takes an array of {element} and an int32")
        return Type("float32", (count,))
    if name in LANES:
        return _check_lanes(fail, node, name, kinds)
    arity = 0 if name == "tid" else 2 if name in {"min", "max", "dot", "cross", "outer", *TWO_FLOATS} else 1
    if len(kinds) != arity:
        fail(node, f"{name} takes {arity} argument{'s' * (arity != 1)}, got {len(kinds)}")
    if name == "tid":
        return INT
    types = [kind for kind in kinds if isinstance(kind, Type)]
    if len(types) != len(kinds):
        if any(kind is not None for kind in kinds if not isinstance(kind, Type)):
            fail(node, f"{name} takes numbers, not a whole array")
        return {"isfinite": BOOL, "bit_count": INT, "float_bits": INT, "bits_float": FLOAT}.get(name)
    first, listed = types[0], " and ".join(map(str, types))
    if len({kind.scalar for kind in types}) > 1:
        fail(node, f"{name} of {listed}: {remedy(*types)}")
    ranks = [len(kind.shape) for kind in types]
    is_float = first.scalar in FLOATS
    is_vector = set(ranks) == {1} and len({kind.shape for kind in types} if name != "outer" else {0}) == 1
    number = not is_float and first != BOOL and first.scalar not in SMALL
    fits, result = {
        **dict.fromkeys(ONE_FLOAT | TWO_FLOATS, (is_float and not any(ranks), first)),
        **dict.fromkeys(("min", "max", "abs"), ((is_float or number) and (not any(ranks) or is_vector), first)),
        "dot": (is_vector, Type(first.scalar)),
        "cross": (is_vector and first.shape == (3,), first),
        "outer": (is_vector, Type(first.scalar, first.shape + types[-1].shape)),
        "transpose": (ranks == [2], Type(first.scalar, first.shape[::-1])),
        "length": (is_vector and is_float, Type(first.scalar)),
        "normalize": (is_vector and is_float, first),
        "isfinite": (is_float and (ranks == [0] or is_vector), BOOL),
        "bit_count": (number and ranks == [0], INT),
        "float_bits": (first == FLOAT, INT),
        "bits_float": (first == INT, FLOAT),
    }[name]
    if not fits:
        fail(node, f"{name} is not for {listed}: {_TAKES.get(name, 'it takes floats of one type')}")
    return result


_TAKES = {
    **dict.fromkeys(("min", "max", "abs"), "it takes numbers or vectors of one type, of 32 or 64 bits"),
    **dict.fromkeys(("dot", "cross", "outer", "length", "normalize"), "it takes vectors that fit each other"),
    "transpose": "it takes a matrix",
    "isfinite": "it takes a float or a vector of floats",
    "bit_count": "it takes an integer of 32 or 64 bits",
    "float_bits": "it takes float32",
    "bits_float": "it takes int32",
}


def _check_atomic(fail: Callable[..., Any], node: ast.Call, name: str, kinds: list[Inferred]) -> Inferred:
    array, *indices, value = kinds if len(kinds) > 2 else [None, None, None]
    if not isinstance(array, ArrayType) or len(indices) != array.axes:
        fail(node, f"{name}(array, index, value), with an index for each axis")
    assert isinstance(array, ArrayType)
    if array.element.shape or array.element.scalar not in ATOMIC:
        fail(node, f"{name} on an {array}: it works on numbers of 32 or 64 bits")
    if value is not None and value != array.element:
        fail(node, f"{name} of {words(value)} on an {array}: {remedy(array.element)}")
    return array.element


def _check_lanes(fail: Callable[..., Any], node: ast.Call, name: str, kinds: list[Inferred]) -> Inferred:
    if len(kinds) != LANES[name]:
        fail(node, f"{name} takes {LANES[name]} argument{'s' * (LANES[name] != 1)}, got {len(kinds)}")
    if not kinds:
        return INT if name == "lane" else ()
    if kinds[-1] not in (None, INT) or kinds[0] not in (None, INT, FLOAT, DOUBLE):
        given = " and ".join(map(words, kinds))
        fail(node, f"{name} of {given}: it takes int32, float32 or float64, and an int32 lane")
    return INT if name == "ballot" else kinds[0]

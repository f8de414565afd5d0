"""One instruction of PTX, and the table of what translates it."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .function import FunctionTranslator

SIZES = {
    **{"pred": 1, "b8": 1, "u8": 1, "s8": 1, "b16": 2, "u16": 2, "s16": 2, "f16": 2, "bf16": 2},
    **{"b32": 4, "u32": 4, "s32": 4, "f32": 4, "f16x2": 4, "bf16x2": 4},
    **{"b64": 8, "u64": 8, "s64": 8, "f64": 8, "b128": 16},
}
FLOATS = ("f32", "f64")
_C_TYPES = {
    **{"pred": "u8", "b8": "u8", "b16": "u16", "b32": "u32", "b64": "u64", "b128": "u128"},
    **{"f16": "u16", "bf16": "u16", "f16x2": "u32", "bf16x2": "u32"},
}


class UnknownPtx(Exception):  # noqa: N818  it is a state of the translator, not a mistake of the caller
    """Something in the PTX that the translation does not know."""


def c_type(kind: str) -> str:
    """The C type of a PTX type."""
    return _C_TYPES.get(kind, kind)


def bits_of(kind: str) -> str:
    """The untyped form of a type: b32 for f32."""
    return "pred" if kind == "pred" else f"b{8 * SIZES[kind]}"


def clean(name: str) -> str:
    """A name of PTX as one of C."""
    return re.sub(r"[^A-Za-z0-9_]", "_", name.replace("%", "p_").replace("$", "d_"))


@dataclass(frozen=True)
class Instruction:
    """`mul.wide.s32 %rd1, %r1, 4` as its parts and operands."""

    parts: list[str]
    operands: list[str]
    text: str
    number: int  # which statement of the function, for faults and notes
    guard: str = ""  # `%p1` or `!%p1`

    @property
    def op(self) -> str:
        return self.parts[0]

    @property
    def kinds(self) -> list[str]:
        return [p for p in self.parts[1:] if p in SIZES]

    @property
    def kind(self) -> str:
        return self.kinds[-1] if self.kinds else ""

    @property
    def is_float(self) -> bool:
        return self.kind in FLOATS

    def __contains__(self, modifier: str) -> bool:
        return modifier in self.parts

    def one_of(self, *modifiers: str) -> str:
        """The first of the modifiers that the instruction has."""
        return next(p for p in self.parts[1:] if p in modifiers)


Handler = Callable[["FunctionTranslator", Instruction], "str | None"]
HANDLERS: dict[str, Handler] = {}
PURE: set[str] = set()  # operations that know registers alone


def translates(*operations: str, pure: bool = False) -> Callable[[Any], Any]:
    """Mark what translates some operations; it returns C, or None for a form that it does not know."""

    def register(handler: Handler) -> Handler:
        for operation in operations:
            assert operation not in HANDLERS
            HANDLERS[operation] = handler
        PURE.update(operations if pure else ())
        return handler

    return register

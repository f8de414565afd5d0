"""Loads, stores and atomics."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from .instructions import SIZES, Instruction, bits_of, c_type, translates

if TYPE_CHECKING:
    from .function import FunctionTranslator

_OPERATIONS = ("add", "min", "max", "and", "or", "xor", "exch", "cas", "inc", "dec")


def _space(f: FunctionTranslator, i: Instruction, address: str) -> str:
    """global, shared, generic, or local: memory on the host's stack or constant memory, which is not checked."""
    spaces = {p.split("::")[0] for p in i.parts}
    named = re.match(r"^\[\s*([$%\w]+)", address)
    if spaces & {"local", "param", "const"} or (named and named.group(1) in f.variables.data):
        return "local"
    return next((s for s in ("shared", "global") if s in spaces), "generic")


def _length(i: Instruction) -> int:
    return next((n for n in (2, 4, 8) if f"v{n}" in i), 1)


def _elements(operand: str, count: int) -> list[str]:
    return [x.strip() for x in operand.strip()[1:-1].split(",")] if count > 1 else [operand]


@translates("ld", "ldu")
def load(f: FunctionTranslator, i: Instruction) -> str | None:
    count, size = _length(i), SIZES[i.kind]
    if count * size > 16:
        return None
    space = _space(f, i, i.operands[1])
    address = f.address(i.operands[1])
    where = f"{space}_load_{count * size}(t, {address}, {i.number})"
    if space == "local":
        where = f"(const u8 *)(uintptr_t){address}"
    kind = bits_of(i.kind) if i.is_float else i.kind
    code = [
        f.set(register, kind, f"*(const {c_type(kind)} *)(bytes + {k * size})")
        for k, register in enumerate(_elements(i.operands[0], count))
    ]
    # ld.cg is used where a counter after a fence orders the accesses
    begin, end = ("t->is_ordered = 1; ", " t->is_ordered = 0;") if "cg" in i else ("", "")
    return f"{{ {begin}const u8 *bytes = {where};{end} {' '.join(code)} }}"


@translates("st")
def store(f: FunctionTranslator, i: Instruction) -> str | None:
    count, size = _length(i), SIZES[i.kind]
    if count * size > 16:
        return None
    space, kind = _space(f, i, i.operands[0]), bits_of(i.kind)
    address = f.address(i.operands[0])
    values = ", ".join(f.value(x, kind) for x in _elements(i.operands[1], count))
    where = f"{space}_store_{count * size}(t, {address}, {i.number}, value)"
    if space == "local":
        where = f"(u8 *)(uintptr_t){address}"
    return f"{{ {c_type(kind)} value[{count}] = {{ {values} }}; memcpy({where}, value, {count * size}); }}"


@translates("atom", "red")
def atomic(f: FunctionTranslator, i: Instruction) -> str | None:
    """One switch of threads before it at most, none within."""
    operands = ["_", *i.operands] if i.op == "red" else i.operands
    operation = i.one_of(*_OPERATIONS)
    is_known = i.kind in ("f32", "f64", "f16") if operation == "add" else not i.is_float and i.kind != "f16"
    if _length(i) > 1 or i.kind in ("bf16", "f16x2", "bf16x2", "b128") or (i.kind[0] in "f" and not is_known):
        return None
    if i.kind[0] == "f":
        f.function.findings.add(f"atom.add.{i.kind}: the sum depends on the order of threads")
    if operation in ("add", "exch", "inc", "dec", "cas") and operands[0] != "_":
        f.function.findings.add(f"atom.{operation}.{i.kind} with its old value used")
    space, size, c = _space(f, i, operands[1]), SIZES[i.kind], c_type(i.kind)
    if space == "local":
        return None
    address = f.address(operands[1])
    x = f.value(operands[2], i.kind)
    new = {
        "add": f"old + {x}" if i.kind != "f16" else f"float_to_half(half_to_float(old) + half_to_float({x}))",
        "min": f"(old < {x} ? old : {x})",
        "max": f"(old > {x} ? old : {x})",
        "and": f"old & {x}",
        "or": f"old | {x}",
        "xor": f"old ^ {x}",
        "exch": x,
        "inc": f"(old >= {x} ? 0 : old + 1)",
        "dec": f"(old == 0 || old > {x} ? {x} : old - 1)",
        "cas": f"(old == {x} ? {f.value(operands[3], i.kind)} : old)" if operation == "cas" else "",
    }[operation]
    keep = f.set(operands[0], i.kind, "old") if operands[0] != "_" else ""
    where = f"{space}_atomic_{size}(t, {address}, {i.number})"
    return f"{{ {c} *cell = ({c} *){where}; {c} old = *cell; *cell = ({c})({new}); {keep} }}"


@translates("membar", "fence", "prefetch", "prefetchu", "discard", "applypriority")
def nothing(f: FunctionTranslator, i: Instruction) -> str | None:
    """What orders memory or warms caches: threads are sequentially consistent here."""
    return ";"

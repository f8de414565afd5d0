"""Branches, calls, and where threads wait for each other."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .instructions import Instruction, clean, translates
from .shuffles import alone

if TYPE_CHECKING:
    from .function import FunctionTranslator

_REDUX = {
    **{("add", "s"): "ADD", ("add", "u"): "ADD", ("min", "s"): "MIN_S", ("max", "s"): "MAX_S"},
    **{("min", "u"): "MIN_U", ("max", "u"): "MAX_U", ("and", "b"): "AND", ("or", "b"): "OR", ("xor", "b"): "XOR"},
}


def _pointer(f: FunctionTranslator, register: str) -> str:
    """The address of a predicate, or none."""
    return f"&{clean(register)}" if register not in ("", "_") else "0"


@translates("bra")
def branch(f: FunctionTranslator, i: Instruction) -> str | None:
    return f"goto {clean(i.operands[0])};"


@translates("brx")
def indirect_branch(f: FunctionTranslator, i: Instruction) -> str | None:
    cases = " ".join(f"case {k}: goto {clean(target)};" for k, target in enumerate(f.tables[i.operands[1]]))
    return f"switch ({f.value(i.operands[0], 'u32')}) {{ {cases} }}"


@translates("call")
def call(f: FunctionTranslator, i: Instruction) -> str | None:
    groups, returns = list(i.operands), []
    if groups[0].startswith("("):
        returns = [clean(x.strip()) for x in groups.pop(0)[1:-1].split(",") if x.strip()]
    name = groups[0]
    given = [clean(x.strip()) for x in groups[1].strip()[1:-1].split(",") if x.strip()] if len(groups) > 1 else []
    if name == "vprintf":
        text, values = (f"(void *)(uintptr_t)*(u64 *){x}" for x in given)
        return f"emulator_print({text}, {values}); *(u32 *){returns[0]} = 0;"
    if name == "__assertfail":
        return f"emulator_assertion(t, (const char *)(uintptr_t)*(u64 *){given[0]}, {i.number});"
    if name not in f.functions:
        return None
    f.function.calls.add(name)
    return f"f_{clean(name)}({', '.join(['t', *returns, *given])});"


@translates("ret", "exit")
def leave(f: FunctionTranslator, i: Instruction) -> str | None:
    return "return;" if i.op == "ret" or f.function.is_kernel else None


@translates("trap", "brkpt")
def trap(f: FunctionTranslator, i: Instruction) -> str | None:
    return f"emulator_fault(t, FAULT_TRAP, 0, 0, 0, {i.number});"


@translates("nanosleep", "griddepcontrol", "pragma")
def nothing(f: FunctionTranslator, i: Instruction) -> str | None:
    return ";"


@translates("covered")
def cover(f: FunctionTranslator, i: Instruction) -> str | None:
    """A mark of kernel_coverage.py: its number, and 0 or 1."""
    return f"EMULATOR.covered[4 * {i.operands[0]} + {f.value(i.operands[1], 'u32')}] = 1;"


# ------------------------------------------------------------------------------------------------ meetings


@translates("bar", "barrier")
def barrier(f: FunctionTranslator, i: Instruction) -> str | None:
    """Barrier 0 of all threads, and bar.warp.sync."""
    f.function.waits = True
    if "warp" in i:
        return f"emulator_sync_warp(t, {f.value(i.operands[0], 'u32')}, {i.number});"
    if i.operands != ["0"] or "red" in i or "arrive" in i:
        return None
    return f"emulator_barrier(t, {i.number});"


@translates("shfl")
def shuffle(f: FunctionTranslator, i: Instruction) -> str | None:
    """Its C is written by the run of shuffles that it is in (shuffles.py), of which a guarded one is no part."""
    f.function.waits = True
    return alone(f, i) if i.guard else ""


@translates("vote")
def vote(f: FunctionTranslator, i: Instruction) -> str | None:
    f.function.waits = True
    mode = {"ballot": "BALLOT", "all": "ALL", "any": "ANY", "uni": "UNIFORM"}[i.one_of("ballot", "all", "any", "uni")]
    arguments = f"t, VOTE_{mode}, {f.condition(i.operands[1])}, {f.value(i.operands[2], 'b32')}, {i.number}"
    return f.set(i.operands[0], "b32" if mode == "BALLOT" else "pred", f"emulator_vote({arguments})")


@translates("redux")
def redux(f: FunctionTranslator, i: Instruction) -> str | None:
    f.function.waits = True
    mode = _REDUX[i.one_of("add", "min", "max", "and", "or", "xor"), i.kind[0]]
    arguments = f"t, REDUX_{mode}, {f.value(i.operands[1], 'b32')}, {f.value(i.operands[2], 'b32')}, {i.number}"
    return f.set(i.operands[0], "b32", f"emulator_redux({arguments})")


@translates("match")
def match(f: FunctionTranslator, i: Instruction) -> str | None:
    f.function.waits = True
    to, _, everyone = (x.strip() for x in i.operands[0].partition("|"))
    value, mask = f.value(i.operands[1], i.kind), f.value(i.operands[2], "b32")
    arguments = f"t, {int('all' in i)}, {value}, {mask}, {_pointer(f, everyone)}, {i.number}"
    return f.set(to, "b32", f"emulator_match({arguments})")


@translates("activemask")
def active_lanes(f: FunctionTranslator, i: Instruction) -> str | None:
    f.function.waits = True
    return f.set(i.operands[0], "b32", f"emulator_active_lanes(t, {i.number})")

"""cvt, and the addresses of the spaces of memory."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .instructions import FLOATS, SIZES, Instruction, c_type, translates

if TYPE_CHECKING:
    from .function import FunctionTranslator


@translates("cvt", pure=True)
def convert(f: FunctionTranslator, i: Instruction) -> str | None:
    if len(i.kinds) != 2:
        return None
    to, source = i.kinds
    mode = next((p for p in i.parts if p in ("rni", "rzi", "rmi", "rpi", "rn", "rz", "rm", "rp")), "")
    x = f.value(i.operands[1], source)
    if source == "f32" and "ftz" in i:
        x = f"flush({x})"
    if source in FLOATS:
        return _from_float(f, i, x, mode)
    if source in ("f16", "bf16"):
        widened = {"f16": f"half_to_float({x})", "bf16": f"F32((u32){x} << 16)"}[source]
        return f.set(i.operands[0], to, widened) if to == "f32" else None
    if to in FLOATS:
        return f.set(i.operands[0], to, f"({to}){x}") if mode in ("rn", "") else None
    if "sat" in i:
        bits = 8 * SIZES[to]
        low, high = (-(2 ** (bits - 1)), 2 ** (bits - 1) - 1) if to[0] == "s" else (0, 2**bits - 1)
        above = f"(s128){x} > (s128){high}ull ? ({to}){high}ull"
        return f.set(i.operands[0], to, f"((s128){x} < (s128){low}ll ? ({to}){low}ll : {above} : ({to}){x})")
    return f.set(i.operands[0], to, f"({c_type(to)}){x}")


def _from_float(f: FunctionTranslator, i: Instruction, x: str, mode: str) -> str | None:
    to, source = i.kinds
    if to == "f16":
        return f.set(i.operands[0], "b16", f"float_to_half((f32){x})") if mode == "rn" else None
    if to == "bf16":
        return None
    if to in FLOATS:
        if to == "f32" and source == "f64" and mode != "rn":
            return None
        rounded = f"round_to({x}, '{mode[1]}')" if mode.endswith("i") else x
        result = f"saturate_{to}(({to}){rounded})" if "sat" in i else f"({to}){rounded}"
        return f.set(i.operands[0], to, f"flush({result})" if to == "f32" and "ftz" in i else result)
    name = "to_signed" if to[0] == "s" else "to_unsigned"
    wide = int(source == "f64" or SIZES[to] == 8)
    arguments = f"t, (f64){x}, {8 * SIZES[to]}, {wide}, '{mode[1:2] or 'z'}', {i.number}"
    return f.set(i.operands[0], to, f"{name}({arguments})")


@translates("cvta", pure=True)
def convert_address(f: FunctionTranslator, i: Instruction) -> str | None:
    """Only shared memory has addresses of its own; those of all else are generic already."""
    x = f.value(i.operands[1], "u64")
    if "shared" in i:
        x += f" {'-' if 'to' in i else '+'} (u64)(uintptr_t)t->shared"
    return f.set(i.operands[0], "u64", x)


@translates("isspacep", pure=True)
def is_in_space(f: FunctionTranslator, i: Instruction) -> str | None:
    x = f.value(i.operands[1], "u64")
    inside = {
        "shared": f"{x} - (u64)(uintptr_t)t->shared < t->shared_size",
        "local": f"{x} >= t->stack_low && {x} < t->stack_high",
        "global": f"{x} - EMULATOR.base < EMULATOR.size",
        "const": "0",
    }
    return f.set(i.operands[0], "pred", inside[i.parts[1].split("::")[0]])

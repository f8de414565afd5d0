"""Instructions that work on registers alone: arithmetic, comparisons, bits, approximations.

Rounding is PTX's for all but the approximations (ex2, lg2, sin, cos, tanh, rcp, rsqrt with .approx), which are rounded
from double.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from .instructions import FLOATS, SIZES, Instruction, bits_of, c_type, translates

if TYPE_CHECKING:
    from .function import FunctionTranslator

_COMPARISONS = {"eq": "==", "ne": "!=", "lt": "<", "le": "<=", "gt": ">", "ge": ">="}
_UNSIGNED = {"lo": "lt", "ls": "le", "hi": "gt", "hs": "ge"}


def _float_sum(f: FunctionTranslator, i: Instruction, x: str, y: str, z: str, plain: str) -> str | None:
    """x * y + z, of which `plain` is the form that rounds to nearest."""
    toward = next((p for p in i.parts if p in ("rz", "rm", "rp")), None)
    if toward is None:
        if "rn" not in i:
            f.function.findings.add(f"{i.op}.{i.kind} that ptxas may fuse")
        return f.set_float(i, plain)
    return f.set_float(i, f"fma_towards({x}, {y}, {z}, '{toward[1]}')") if i.kind == "f32" else None


@translates("mov", pure=True)
def mov(f: FunctionTranslator, i: Instruction) -> str | None:
    """Also packs `{a, b}` into a wider register and takes it apart."""
    to, source = i.operands
    if source.startswith("{"):
        parts = [x.strip() for x in source[1:-1].split(",")]
        width = 8 * SIZES[i.kind] // len(parts)
        container = bits_of(i.kind)
        packed = " | ".join(
            f"(({c_type(container)}){f.value(x, f'b{width}')} << {width * k})" for k, x in enumerate(parts)
        )
        return f.set(to, i.kind, packed)
    if to.startswith("{"):
        parts = [x.strip() for x in to[1:-1].split(",")]
        width = 8 * SIZES[i.kind] // len(parts)
        return " ".join(f.set(x, f"b{width}", f"{f.value(source, i.kind)} >> {width * k}") for k, x in enumerate(parts))
    return f.set(to, bits_of(i.kind), f.value(source, bits_of(i.kind)))


# ------------------------------------------------------------------------------------------------ sums and products


@translates("add", "sub", "addc", "subc", pure=True)
def add(f: FunctionTranslator, i: Instruction) -> str | None:
    if i.op in ("addc", "subc") or "cc" in i:
        return _with_carry(f, i)
    sign = "+" if i.op == "add" else "-"
    if i.is_float:
        x, y = f.float_value(i, 1), f.float_value(i, 2)
        return _float_sum(f, i, x, "1.0f", f"{sign}{y}", f"{x} {sign} {y}")
    if "sat" in i:
        return None
    return f.set(i.operands[0], i.kind, f"{f.value(i.operands[1], i.kind)} {sign} {f.value(i.operands[2], i.kind)}")


def _product(f: FunctionTranslator, i: Instruction) -> tuple[str, str]:
    """The type and the C of an integer product: its lower half, its upper half, or all of it."""
    x, y = f.value(i.operands[1], i.kind), f.value(i.operands[2], i.kind)
    bits, sign = 8 * SIZES[i.kind], i.kind[0]
    if "wide" in i:
        wide = f"{sign}{2 * bits}"
        return wide, f"({wide}){x} * ({wide}){y}"
    if "hi" in i:
        return i.kind, f"(({sign}{2 * bits}){x} * ({sign}{2 * bits}){y}) >> {bits}"
    return i.kind, f"(u32){x} * (u32){y}" if bits == 16 else f"{x} * {y}"


@translates("mul", pure=True)
def mul(f: FunctionTranslator, i: Instruction) -> str | None:
    if i.is_float:
        x, y = f.float_value(i, 1), f.float_value(i, 2)
        return _float_sum(f, i, x, y, "0.0f", f"{x} * {y}")
    kind, product = _product(f, i)
    return f.set(i.operands[0], kind, product)


@translates("mul24", pure=True)
def mul24(f: FunctionTranslator, i: Instruction) -> str | None:
    if i.kind != "u32" or "lo" not in i:
        return None
    x, y = (f"({f.value(token, i.kind)} & 0xFFFFFF)" for token in i.operands[1:])
    return f.set(i.operands[0], i.kind, f"{x} * {y}")


@translates("mad", "madc", "fma", pure=True)
def mad(f: FunctionTranslator, i: Instruction) -> str | None:
    if i.is_float:
        f.function.findings.add("fma")
        x, y, z = (f.float_value(i, k) for k in (1, 2, 3))
        return _float_sum(f, i, x, y, z, f"{'fmaf' if i.kind == 'f32' else 'fma'}({x}, {y}, {z})")
    if i.op == "madc" or "cc" in i:
        return _with_carry(f, i)
    kind, product = _product(f, i)
    return f.set(i.operands[0], kind, f"({c_type(kind)})({product}) + {f.value(i.operands[3], kind)}")


def _with_carry(f: FunctionTranslator, i: Instruction) -> str:
    f.need("u8 carry = 0;")
    bits = 8 * SIZES[i.kind]
    kind, wide = f"u{bits}", f"u{2 * bits}"
    x, y = f.value(i.operands[1], kind), f.value(i.operands[2], kind)
    if i.op.startswith("mad"):
        x, y = f"(({kind})({_product(f, i)[1]}))", f.value(i.operands[3], kind)
    sign = "-" if i.op.startswith("sub") else "+"
    carry = f" {sign} carry" if i.op.endswith("c") else ""
    keep = f" carry = (u8)(sum >> {bits} & 1);" if "cc" in i else ""
    result = f.set(i.operands[0], kind, f"({kind})sum")
    return f"{{ {wide} sum = ({wide}){x} {sign} ({wide}){y}{carry};{keep} {result} }}"


@translates("div", "rem", pure=True)
def div(f: FunctionTranslator, i: Instruction) -> str | None:
    if i.is_float:
        if "rn" not in i:
            f.function.findings.add(".".join(i.parts))
        return f.set_float(i, f"{f.float_value(i, 1)} / {f.float_value(i, 2)}")
    x, y = (f.value(token, i.kind) for token in i.operands[1:])
    return f.set(i.operands[0], i.kind, f"{i.op}_{i.kind}(t, {x}, {y}, {i.number})")


@translates("abs", "neg", pure=True)
def abs_or_neg(f: FunctionTranslator, i: Instruction) -> str | None:
    if i.op == "neg" and i.is_float:
        if "ftz" in i:
            return f.set_float(i, f"-{f.float_value(i, 1)}")
        sign = {"f32": "0x80000000u", "f64": "0x8000000000000000ull"}[i.kind]
        return f.set(i.operands[0], bits_of(i.kind), f"{f.value(i.operands[1], bits_of(i.kind))} ^ {sign}")
    if i.is_float:
        return f.set_float(i, f"{'fabsf' if i.kind == 'f32' else 'fabs'}({f.float_value(i, 1)})")
    x = f.value(i.operands[1], i.kind)
    return f.set(i.operands[0], i.kind, f"0 - {x}" if i.op == "neg" else f"({x} < 0 ? 0 - {x} : {x})")


@translates("min", "max", pure=True)
def extreme(f: FunctionTranslator, i: Instruction) -> str | None:
    if len(i.operands) != 3 or "NaN" in i or "xorsign" in i or "relu" in i:
        return None
    if i.is_float:
        return f.set_float(i, f"{i.op}_{i.kind}({f.float_value(i, 1)}, {f.float_value(i, 2)})")
    x, y = (f.value(token, i.kind) for token in i.operands[1:])
    return f.set(i.operands[0], i.kind, f"({x} {'<' if i.op == 'min' else '>'} {y} ? {x} : {y})")


# ------------------------------------------------------------------------------------------------ bits


@translates("and", "or", "xor", "not", "lop3", pure=True)
def logic(f: FunctionTranslator, i: Instruction) -> str | None:
    values = [f.value(token, i.kind) for token in i.operands[1:]]
    if i.op == "not":
        return f.set(i.operands[0], i.kind, f"{'!' if i.kind == 'pred' else '~'}{values[0]}")
    if i.op == "lop3":
        return f.set(i.operands[0], "b32", f"lop3({', '.join(values)})")
    return f.set(i.operands[0], i.kind, f" {dict(zip(('and', 'or', 'xor'), '&|^', strict=True))[i.op]} ".join(values))


@translates("shl", "shr", pure=True)
def shift(f: FunctionTranslator, i: Instruction) -> str | None:
    name = "shl" if i.op == "shl" else "shrs" if i.kind.startswith("s") else "shru"
    x, n = f.value(i.operands[1], i.kind), f.value(i.operands[2], "u32")
    return f.set(i.operands[0], i.kind, f"{name}{8 * SIZES[i.kind]}({x}, {n})")


@translates("shf", pure=True)
def funnel_shift(f: FunctionTranslator, i: Instruction) -> str | None:
    a, b, n = f.value(i.operands[1], "b32"), f.value(i.operands[2], "b32"), f.value(i.operands[3], "u32")
    n = f"({n} & 31)" if "wrap" in i else f"({n} > 32 ? 32 : {n})"
    return f.set(i.operands[0], "b32", f"funnel_{'left' if 'l' in i else 'right'}({a}, {b}, {n})")


@translates("bfe", "bfi", pure=True)
def bit_field(f: FunctionTranslator, i: Instruction) -> str | None:
    values = [f.value(token, i.kind) for token in i.operands[1:-2]]
    values += [f.value(token, "u32") for token in i.operands[-2:]]
    return f.set(i.operands[0], i.kind, f"{i.op}_{i.kind}({', '.join(values)})")


@translates("popc", "clz", "brev", "bfind", pure=True)
def count_bits(f: FunctionTranslator, i: Instruction) -> str | None:
    x, bits = f.value(i.operands[1], i.kind), 8 * SIZES[i.kind]
    if "shiftamt" in i:
        return None
    if i.op == "popc":
        return f.set(i.operands[0], "u32", f"__builtin_popcountll((u64){x})")
    if i.op == "bfind":
        return f.set(i.operands[0], "u32", f"bfind_{i.kind}({x})")
    return f.set(i.operands[0], "u32" if i.op == "clz" else i.kind, f"{i.op}{bits}({x})")


@translates("prmt", pure=True)
def permute_bytes(f: FunctionTranslator, i: Instruction) -> str | None:
    if len(i.parts) > 2:
        return None
    return f.set(i.operands[0], "b32", f"prmt({', '.join(f.value(token, 'b32') for token in i.operands[1:])})")


@translates("dp2a", pure=True)
def dot_two_way(f: FunctionTranslator, i: Instruction) -> str | None:
    if i.kinds != ["u32", "u32"]:  # the compiler makes it of sums of bits; no signed one has occurred
        return None
    a, b, c = (f.value(token, "u32") for token in i.operands[1:])
    return f.set(i.operands[0], "u32", f"dp2a({a}, {b}, {c}, {0 if 'lo' in i else 16})")


@translates("dp4a", pure=True)
def dot_bytes(f: FunctionTranslator, i: Instruction) -> str | None:
    if len(i.kinds) != 2 or not {"u32", "s32"}.issuperset(i.kinds):  # the compiler makes it of products of bytes
        return None
    a, b, c = (f.value(token, "u32") for token in i.operands[1:])

    def byte(value: str, kind: str, k: int) -> str:
        return f"(u32)(signed char)({value} >> {k})" if kind == "s32" else f"(({value} >> {k}) & 255u)"

    products = " + ".join(f"{byte(a, i.kinds[0], k)} * {byte(b, i.kinds[1], k)}" for k in (0, 8, 16, 24))
    return f.set(i.operands[0], "u32", f"{c} + {products}")


# ------------------------------------------------------------------------------------------------ comparisons


def _comparison(name: str, x: str, y: str, is_float: bool) -> str | None:
    name = _UNSIGNED.get(name, name)
    if name == "ne" and is_float:  # false where one is NaN, unlike C's
        return f"({x} < {y} || {x} > {y})"
    if name in _COMPARISONS:
        return f"({x} {_COMPARISONS[name]} {y})"
    if name.endswith("u") and name[:2] in _COMPARISONS:
        return f"({x} {_COMPARISONS[name[:2]]} {y} || {x} != {x} || {y} != {y})"
    return {"num": f"({x} == {x} && {y} == {y})", "nan": f"({x} != {x} || {y} != {y})"}.get(name)


@translates("setp", "set", pure=True)
def compare(f: FunctionTranslator, i: Instruction) -> str | None:
    comparison = _comparison(i.parts[1], f.float_value(i, 1), f.float_value(i, 2), i.is_float)
    if comparison is None:
        return None
    if i.op == "set":
        ones = "1.0f : 0.0f" if i.kinds[0] == "f32" else "0xFFFFFFFFu : 0u"
        return f.set(i.operands[0], i.kinds[0], f"({comparison} ? {ones})") if len(i.operands) == 3 else None
    first, _, second = (x.strip() for x in i.operands[0].partition("|"))
    code = [f"u8 found = {comparison};", "u8 other = !found;"]
    joined = {"and": "&", "or": "|", "xor": "^"}
    if len(i.operands) > 3:
        sign = joined[i.one_of(*joined)]
        code += [
            f"u8 with = {f.condition(i.operands[3])};",
            f"found = found {sign} with;",
            f"other = other {sign} with;",
        ]
    code += [
        f.set(name, "pred", value) for name, value in ((first, "found"), (second, "other")) if name not in ("", "_")
    ]
    return f"{{ {' '.join(code)} }}"


@translates("selp", "slct", pure=True)
def select(f: FunctionTranslator, i: Instruction) -> str | None:
    if i.op == "selp":
        x, y = (f.value(token, bits_of(i.kind)) for token in i.operands[1:3])
        return f.set(i.operands[0], bits_of(i.kind), f"({f.condition(i.operands[3])} ? {x} : {y})")
    kind = bits_of(i.kinds[0])
    x, y = (f.value(token, kind) for token in i.operands[1:3])
    return f.set(i.operands[0], kind, f"({f.value(i.operands[3], i.kinds[1])} >= 0 ? {x} : {y})")


# ------------------------------------------------------------------------------------------------ floats


@translates("testp", pure=True)
def test_float(f: FunctionTranslator, i: Instruction) -> str | None:
    x = f.value(i.operands[1], i.kind)
    tests = {"finite": "isfinite", "infinite": "isinf", "number": "!isnan", "notanumber": "isnan", "normal": "isnormal"}
    test = f"{tests[i.parts[1]]}({x})" if i.parts[1] in tests else f"fpclassify({x}) == FP_SUBNORMAL"
    return f.set(i.operands[0], "pred", test)


@translates("copysign", pure=True)
def copy_sign(f: FunctionTranslator, i: Instruction) -> str | None:
    sign, size = (f.value(token, i.kind) for token in i.operands[1:])
    return f.set(i.operands[0], i.kind, f"{'copysignf' if i.kind == 'f32' else 'copysign'}({size}, {sign})")


@translates("sqrt", "rcp", "rsqrt", pure=True)
def root(f: FunctionTranslator, i: Instruction) -> str | None:
    if "rn" not in i:
        f.function.findings.add(f"{i.op}.approx.{i.kind}")
    x = f.float_value(i, 1)
    if i.op == "sqrt":
        return f.set_float(i, f"{'sqrtf' if i.kind == 'f32' else 'sqrt'}({x})")
    exact = f"1 / {x}" if i.op == "rcp" else f"1.0 / sqrt((f64){x})"
    if i.kind == "f64" and "approx" in i:  # some 20 bits, the lower half zero: what follows refines it
        return f.set(i.operands[0], "b64", f"B64({exact}) & 0xFFFFFFFF00000000ull")
    return f.set_float(i, f"({i.kind})({exact})")


@translates("ex2", "lg2", "sin", "cos", "tanh", pure=True)
def approximation(f: FunctionTranslator, i: Instruction) -> str | None:
    if i.kind not in FLOATS:
        return None
    f.function.findings.add(f"{i.op}.approx")
    name = {"ex2": "exp2", "lg2": "log2"}.get(i.op, i.op)
    return f.set_float(i, f"(f32){name}((f64){f.float_value(i, 1)})")

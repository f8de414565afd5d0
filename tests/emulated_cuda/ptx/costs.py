"""What an instruction of PTX costs on a GPU: instructions of the machine, turns of its units, cycles until its result.

Rates are those of compute capability 9.0 (CUDA C++ Programming Guide, table of arithmetic throughput): results a clock
and SM of 128 for float32, 64 for float64, for 32-bit integers and for most conversions, 32 for shuffles and accesses to
memory, 16 for reciprocals, roots, counts of bits and conversions from and to 64 bits. An SM has four schedulers, each
of which gives out an instruction of a warp a cycle; a rate of 64 keeps its unit busy for 2 cycles, 16 for 8. What PTX
has and the machine has not becomes a sequence: 64-bit integers are two of 32 bits, a division that rounds is Newton's
method, of which the usual way is counted.
"""

from __future__ import annotations

from dataclasses import dataclass

from .instructions import SIZES, Instruction

UNITS = ("issued", "alu", "sums", "fma", "fp64", "xu", "lsu")  # cycles of a scheduler; `issued` are instructions


@dataclass(frozen=True)
class Cost:
    """Of one instruction of a warp."""

    issued: int = 1
    alu: int = 0  # comparisons, bits, integers of 64 bits
    sums: int = 0  # of 32-bit integers, which run where comparisons do, or as products with 1 where those do
    fma: int = 0  # float32, and products of integers
    fp64: int = 0
    xu: int = 0  # reciprocals, roots, conversions from and to 64 bits
    lsu: int = 0  # accesses and shuffles
    latency: int = 4


FREE = Cost(0, latency=0)  # what the assembler takes out, or folds into the operands of others
ALU, SUM, FMA, PRODUCT = Cost(alu=2), Cost(sums=2), Cost(fma=1), Cost(fma=2, latency=5)
DOUBLE, SPECIAL = Cost(fp64=2, latency=8), Cost(xu=8, latency=20)
ALU_64 = Cost(2, alu=4, latency=6)
ACCESS = Cost(lsu=4, latency=0)
SHARED_LATENCY, SHUFFLE_LATENCY, BARRIER_LATENCY = 29, 24, 20

_FLOAT_DIVISIONS = {
    ("div", "f32"): Cost(10, alu=4, fma=7, xu=8, latency=50),
    ("rcp", "f32"): Cost(6, alu=2, fma=4, xu=8, latency=40),
    ("sqrt", "f32"): Cost(8, alu=2, fma=6, xu=8, latency=45),
    ("div", "f64"): Cost(16, alu=10, fp64=18, xu=8, latency=95),
    ("rcp", "f64"): Cost(12, alu=8, fp64=12, xu=8, latency=75),
    ("sqrt", "f64"): Cost(15, alu=10, fp64=16, xu=8, latency=95),
}
_INTEGER_DIVISIONS = {4: Cost(20, alu=24, fma=10, xu=16, latency=90), 8: Cost(75, alu=90, fma=50, xu=16, latency=300)}
_FREE = {"mov", "cvta", "pragma", "nanosleep", "membar", "fence", "prefetch", "prefetchu", "discard", "isspacep"}
_BITS = {"popc", "clz", "brev", "bfind"}


def _float(i: Instruction) -> Cost:
    is_double = i.kind == "f64"
    if i.op in ("div", "rcp", "sqrt", "rsqrt"):
        if "rn" in i or i.op == "div":
            return _FLOAT_DIVISIONS.get((i.op, i.kind), SPECIAL) if "rn" in i else Cost(3, fma=2, xu=8, latency=28)
        return SPECIAL
    if i.op in ("abs", "neg"):
        return FREE
    if i.op in ("add", "sub", "mul", "mad", "fma"):
        return DOUBLE if is_double else FMA
    if i.op in ("min", "max"):
        return Cost(5, alu=6, fp64=4, latency=20) if is_double else ALU
    if i.op in ("setp", "set", "testp"):
        return DOUBLE if is_double else ALU
    if i.op == "selp":
        return ALU_64 if is_double else ALU
    return SPECIAL if i.op in ("ex2", "lg2", "sin", "cos", "tanh") else ALU


def _integer(i: Instruction) -> Cost:
    is_wide = SIZES.get(i.kind, 4) == 8
    if i.op in ("div", "rem"):
        return _INTEGER_DIVISIONS[8 if is_wide else 4]
    if i.op in ("mul", "mad", "mul24", "madc"):
        if not is_wide:
            return Cost(fma=4, latency=6) if "wide" in i or "hi" in i else PRODUCT
        return Cost(8, alu=4, fma=16, latency=16) if "hi" in i else Cost(4, fma=8, latency=11)
    if i.op in _BITS:
        return Cost(3, alu=2, xu=16, latency=30) if is_wide else SPECIAL
    if i.op in ("bfe", "bfi"):
        return Cost(4, alu=8, latency=12) if is_wide else Cost(2, alu=4, latency=8)
    if i.op in ("min", "max") and is_wide:
        return Cost(4, alu=8, latency=12)
    if i.kind == "pred":
        return ALU
    if i.op in ("add", "sub", "shl") and not is_wide and "cc" not in i:
        return SUM
    return ALU_64 if is_wide else ALU


def _conversion(i: Instruction) -> Cost:
    to, source = i.kinds[:2]
    if to[0] in "usb" and source[0] in "usb":
        return FREE if SIZES[to] <= SIZES[source] or (SIZES[source] == 4 and source[0] != "s") else ALU
    if "f64" in (to, source) or 8 in (SIZES[to], SIZES[source]):
        return Cost(xu=8, latency=12)
    return Cost(alu=2, latency=6)


def cost_of(i: Instruction) -> Cost:
    """What an instruction costs; memory beyond the instruction itself is counted by address."""
    op, first = i.op, i.operands[1].strip() if len(i.operands) > 1 else ""
    if op == "mov" and first.startswith("%") and "." in first:
        return Cost(alu=2, latency=20)  # a special register
    if op in _FREE or (op == "ld" and ("param" in i or "const" in i)) or (op == "st" and "param" in i):
        return FREE
    if op in ("ld", "ldu", "st", "atom", "red"):
        return ACCESS
    if op == "cvt":
        return _conversion(i)
    if op == "shfl":
        return Cost(lsu=4, latency=SHUFFLE_LATENCY)
    if op in ("vote", "activemask"):
        return Cost(alu=2, latency=12)
    if op in ("redux", "match"):
        return Cost(xu=8, latency=25)
    if op in ("bar", "barrier"):
        return Cost(latency=BARRIER_LATENCY)
    if op in ("bra", "brx", "ret", "exit", "trap", "brkpt"):
        return Cost(latency=8)
    if op == "call":
        return Cost(3, latency=20)
    return _float(i) if i.is_float else _integer(i)

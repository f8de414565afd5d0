"""PTX's arithmetic, by the values that the PTX ISA promises."""

import math
import struct
from fractions import Fraction

import numpy as np
import pytest

from .ptx import UnknownPtx

NAN32, INF32 = 0x7FC00000, 0x7F800000
NAN64 = 0x7FF8000000000000
ALL32, ALL64 = 2**32 - 1, 2**64 - 1


def f32(x: float) -> int:
    return struct.unpack("<I", struct.pack("<f", x))[0]


def f64(x: float) -> int:
    return struct.unpack("<Q", struct.pack("<d", x))[0]


def s32(x: int) -> int:
    return x % 2**32


def s64(x: int) -> int:
    return x % 2**64


# instruction -> rows of (operands), result
CASES = {
    # shifts clamp at the width
    "shl.b32 %r0, %r1, %r2;": [((1, 31), 2**31), ((1, 32), 0), ((1, 2**31), 0), ((3, 0), 3)],
    "shr.u32 %r0, %r1, %r2;": [((2**31, 31), 1), ((2**31, 32), 0), ((ALL32, 4), ALL32 >> 4)],
    "shr.s32 %r0, %r1, %r2;": [((s32(-8), 1), s32(-4)), ((s32(-8), 99), ALL32), ((8, 99), 0)],
    "shl.b64 %rd0, %rd1, %r2;": [((1, 63), 2**63), ((1, 64), 0)],
    "shr.s64 %rd0, %rd1, %r2;": [((s64(-1), 200), ALL64), ((2**62, 62), 1)],
    "shr.s16 %rs0, %rs1, %r2;": [((0x8000, 3), 0xF000), ((0x8000, 40), 0xFFFF), ((0x4000, 40), 0)],
    "shf.l.wrap.b32 %r0, %r1, %r2, %r3;": [((0x80000000, 1, 1), 3), ((5, 7, 32), 7), ((5, 7, 33), 14)],
    "shf.r.wrap.b32 %r0, %r1, %r2, %r3;": [((1, 1, 1), 0x80000000), ((5, 7, 32), 5)],
    "shf.l.clamp.b32 %r0, %r1, %r2, %r3;": [((5, 7, 32), 5), ((5, 7, 99), 5), ((5, 7, 0), 7)],
    "shf.r.clamp.b32 %r0, %r1, %r2, %r3;": [((5, 7, 32), 7), ((5, 7, 99), 7), ((5, 7, 0), 5)],
    # bit fields
    "bfe.u32 %r0, %r1, %r2, %r3;": [((0xABCD1234, 8, 8), 0x12), ((ALL32, 28, 8), 15), ((ALL32, 0, 0), 0)],
    "bfe.s32 %r0, %r1, %r2, %r3;": [
        *[((0x80, 4, 4), s32(-8)), ((0x40, 4, 4), 4), ((ALL32, 0, 0), 0), ((0x80000000, 30, 8), s32(-2))],
        *[((0x80000000, 40, 4), ALL32), ((0x40000000, 40, 4), 0), ((s32(-5), 0, 32), s32(-5))],
    ],
    "bfe.s64 %rd0, %rd1, %r2, %r3;": [((1 << 63, 60, 10), s64(-8)), ((0xF0, 4, 4), ALL64), ((1 << 62, 100, 5), 0)],
    "bfi.b32 %r0, %r1, %r2, 8, 4;": [((0xF, 0), 0xF00), ((0x5, ALL32), 0xFFFFF5FF)],
    "bfi.b32 %r0, %r1, %r2, 28, 8;": [((0xFF, 0), 0xF0000000)],
    "bfi.b64 %rd0, %rd1, %rd2, 32, 32;": [((1, 2), 2**32 + 2), ((ALL64, 0), ALL32 << 32)],
    "bfind.u32 %r0, %r1;": [((0,), ALL32), ((1,), 0), ((ALL32,), 31)],
    "bfind.s32 %r0, %r1;": [((ALL32,), ALL32), ((s32(-2),), 0), ((2**30,), 30)],
    "clz.b64 %r0, %rd1;": [((0,), 64), ((1,), 63), ((1 << 63,), 0)],
    "popc.b64 %r0, %rd1;": [((ALL64,), 64), ((5,), 2)],
    "dp4a.u32.u32 %r0, %r1, %r2, %r3;": [((0xFF020304, 0xFF010203, 5), 65025 + 2 + 6 + 12 + 5), ((0, ALL32, 7), 7)],
    "dp4a.s32.u32 %r0, %r1, %r2, %r3;": [((0xFF020380, 0xFF0102FF, 5), s32(-255 + 2 + 6 - 32640 + 5))],
    "brev.b32 %r0, %r1;": [((1,), 2**31), ((0xF0000000,), 0xF)],
    "brev.b64 %rd0, %rd1;": [((1,), 2**63), ((1 << 40,), 1 << 23)],
    "prmt.b32 %r0, %r1, %r2, %r3;": [
        *[((0x33221100, 0x77665544, 0x7531), 0x77553311), ((0x33221100, 0x77665544, 0x0000), 0)],
        *[((0x80, 0, 0x8888), ALL32), ((0x7F, 0, 0x8888), 0)],
    ],
    "dp2a.lo.u32.u32 %r0, %r1, %r2, %r3;": [((0x00030002, 0x99990705, 11), 42), ((ALL32, 0xFFFF, 0), 0x1FDFE02)],
    "dp2a.hi.u32.u32 %r0, %r1, %r2, %r3;": [((0x00030002, 0x07059999, 11), 42), ((0, ALL32, ALL32), ALL32)],
    "lop3.b32 %r0, %r1, %r2, %r3, 0xE8;": [((0b0011, 0b0101, 0b1001), 0b0001), ((ALL32, ALL32, 0), ALL32)],
    "lop3.b32 %r0, %r1, %r2, %r3, 0x96;": [((0b0011, 0b0101, 0b1001), 0b1111)],
    # wide products and carries
    "mul.hi.u64 %rd0, %rd1, %rd2;": [((ALL64, ALL64), ALL64 - 1), ((2**63, 6), 3)],
    "mul.hi.s64 %rd0, %rd1, %rd2;": [((s64(-1), 5), ALL64), ((s64(-(2**63)), 2), s64(-1))],
    "mul.hi.s32 %r0, %r1, %r2;": [((s32(-(2**31)), 4), s32(-2)), ((2**30, 8), 2)],
    "mul.wide.s32 %rd0, %r1, %r2;": [((s32(-3), 7), s64(-21)), ((s32(-(2**31)), s32(-(2**31))), 2**62)],
    "mul.wide.u16 %r0, %rs1, %rs2;": [((0xFFFF, 0xFFFF), 0xFFFE0001)],
    "mad.lo.s32 %r0, %r1, %r2, %r3;": [((ALL32, ALL32, 1), 2), ((2**31, 2, 7), 7)],
    "add.cc.u32 %r0, %r1, %r2; addc.u32 %r0, %r3, 0;": [((ALL32, 1, 10), 11), ((1, 1, 10), 10)],
    "sub.cc.u32 %r0, %r1, %r2; subc.u32 %r0, %r3, 0;": [((0, 1, 10), 9), ((1, 1, 10), 10)],
    "add.cc.u64 %rd0, %rd1, %rd2; addc.cc.u64 %rd0, %rd3, 0; addc.u64 %rd0, 0, 0;": [
        *[((ALL64, 1, ALL64), 1), ((ALL64, 1, 5), 0)],
    ],
    "mad.lo.cc.u32 %r0, %r1, %r2, %r3; madc.hi.u32 %r0, %r1, %r2, 0;": [((ALL32, ALL32, ALL32), ALL32)],
    # division
    "div.s32 %r0, %r1, %r2;": [((s32(-7), 2), s32(-3)), ((s32(-(2**31)), ALL32), 2**31)],
    "rem.s32 %r0, %r1, %r2;": [((s32(-7), 4), s32(-3)), ((s32(-(2**31)), ALL32), 0)],
    "rem.u64 %rd0, %rd1, %rd2;": [((ALL64, 10), 5)],
    # floats to integers: saturated, NaN by type
    "cvt.rzi.s32.f32 %r0, %f1;": [
        *[((f32(3e9),), 2**31 - 1), ((f32(-3e9),), 2**31), ((NAN32,), 0), ((f32(-1.9),), ALL32), ((INF32,), 2**31 - 1)],
    ],
    "cvt.rni.s32.f32 %r0, %f1;": [((f32(2.5),), 2), ((f32(3.5),), 4), ((f32(-0.5),), 0)],
    "cvt.rmi.s32.f32 %r0, %f1;": [((f32(-0.5),), ALL32), ((f32(0.5),), 0)],
    "cvt.rpi.s32.f64 %r0, %fd1;": [((f64(0.5),), 1), ((f64(-0.5),), 0), ((f64(2**31 - 0.5),), 2**31 - 1)],
    "cvt.rzi.u32.f32 %r0, %f1;": [((f32(-1),), 0), ((f32(5e9),), ALL32), ((NAN32,), 0)],
    "cvt.rzi.s64.f32 %rd0, %f1;": [((f32(1e20),), 2**63 - 1), ((f32(-1e20),), 2**63), ((NAN32,), 2**63)],
    "cvt.rzi.u64.f64 %rd0, %fd1;": [((f64(1e30),), ALL64), ((f64(-5),), 0), ((f64(2.0**63),), 2**63)],
    "cvt.rzi.s32.f64 %r0, %fd1;": [((NAN64,), 2**31), ((f64(1e300),), 2**31 - 1)],
    # integers to integers, and to floats
    "cvt.s64.s32 %rd0, %r1;": [((s32(-5),), s64(-5))],
    "cvt.u64.u32 %rd0, %r1;": [((s32(-5),), s32(-5))],
    "cvt.s32.s8 %r0, %r1;": [((0x80,), s32(-128)), ((0x7F,), 127)],
    "cvt.sat.u8.s32 %r0, %r1;": [((300,), 255), ((s32(-5),), 0), ((7,), 7)],
    "cvt.rn.f32.u64 %f0, %rd1;": [((ALL64,), f32(2.0**64)), ((2**24 + 1,), f32(2.0**24))],
    "cvt.rn.f32.f64 %f0, %fd1;": [((f64(1e300),), INF32), ((f64(0.1),), f32(0.1))],
    "cvt.rmi.f32.f32 %f0, %f1;": [((f32(-0.5),), f32(-1.0))],
    "cvt.sat.f32.f32 %f0, %f1;": [((f32(2.0),), f32(1.0)), ((f32(-2.0),), 0), ((NAN32,), 0)],
    "cvt.f32.f16 %f0, %rs1;": [((0x3C00,), f32(1.0)), ((0x0001,), f32(2.0**-24)), ((0xFC00,), f32(-math.inf))],
    # the number where one side is NaN; signs of zero
    "min.f32 %f0, %f1, %f2;": [((NAN32, f32(2)), f32(2)), ((f32(2), NAN32), f32(2)), ((0, f32(-0.0)), f32(-0.0))],
    "max.f32 %f0, %f1, %f2;": [((NAN32, f32(2)), f32(2)), ((f32(-0.0), 0), 0), ((f32(-1), f32(-3)), f32(-1))],
    "min.f64 %fd0, %fd1, %fd2;": [((NAN64, f64(2)), f64(2)), ((0, f64(-0.0)), f64(-0.0))],
    "min.s32 %r0, %r1, %r2;": [((ALL32, 1), ALL32)],
    "min.u32 %r0, %r1, %r2;": [((ALL32, 1), 1)],
    "abs.s32 %r0, %r1;": [((s32(-5),), 5), ((2**31,), 2**31)],
    "neg.f32 %f0, %f1;": [((0,), f32(-0.0))],
    "copysign.f32 %f0, %f1, %f2;": [((f32(-1), f32(3)), f32(-3))],
    # comparisons with NaN
    "setp.ne.f32 %p0, %f1, %f2;": [((NAN32, 0), 0), ((f32(1), 0), 1), ((0, f32(-0.0)), 0)],
    "setp.neu.f32 %p0, %f1, %f2;": [((NAN32, 0), 1), ((0, 0), 0)],
    "setp.ltu.f64 %p0, %fd1, %fd2;": [((NAN64, 0), 1), ((f64(1), 0), 0)],
    "setp.num.f32 %p0, %f1, %f2;": [((NAN32, 0), 0), ((0, 0), 1)],
    "setp.nan.f32 %p0, %f1, %f2;": [((NAN32, 0), 1)],
    "setp.lt.s32 %p0, %r1, %r2;": [((ALL32, 0), 1)],
    "setp.lo.u32 %p0, %r1, %r2;": [((ALL32, 0), 0)],
    "setp.lt.and.s32 %p0|%p1, %r1, %r2, %p3;": [((1, 2, 1), 1), ((1, 2, 0), 0), ((2, 1, 1), 0)],
    "setp.eq.or.s32 %p3|%p0, %r1, %r2, !%p3;": [((1, 1, 0), 1), ((1, 1, 1), 0), ((1, 2, 1), 1)],
    "xor.pred %p0, %p1, -1;": [((1,), 0), ((0,), 1)],
    "selp.b32 %r0, %r1, %r2, %p3;": [((5, 6, 1), 5), ((5, 6, 0), 6)],
    "testp.subnormal.f32 %p0, %f1;": [((1,), 1), ((f32(1),), 0)],
    # rounding
    "fma.rn.f32 %f0, %f1, %f2, %f3;": [((f32(1 + 2**-12), f32(1 - 2**-12), f32(-1)), f32(-(2.0**-24)))],
    "fma.rm.f32 %f0, %f1, %f2, %f3;": [((f32(1), f32(1), f32(-1e-30)), f32(1 - 2**-24))],
    "fma.rz.f32 %f0, %f1, %f2, %f3;": [((f32(-1), f32(1), f32(1e-30)), f32(-1 + 2**-24))],
    "add.rp.f32 %f0, %f1, %f2;": [((f32(1), f32(1e-30)), f32(1 + 2**-23)), ((f32(1), f32(2)), f32(3))],
    "sub.rm.f32 %f0, %f1, %f2;": [((f32(1), f32(1e-30)), f32(1 - 2**-24))],
    "mul.rz.f32 %f0, %f1, %f2;": [((f32(1 + 2**-23), f32(1 + 2**-23)), f32(1 + 2**-22))],
    "mul.ftz.f32 %f0, %f1, %f2;": [((1, f32(1e10)), 0), ((f32(1e-30), f32(1e-10)), 0)],
    "add.f32 %f0, %f1, %f2;": [((1, 1), 2)],
    "sqrt.rn.f64 %fd0, %fd1;": [((f64(2),), f64(math.sqrt(2)))],
    "rcp.rn.f32 %f0, %f1;": [((f32(3),), f32(np.float32(1) / np.float32(3)))],
    "rcp.approx.ftz.f64 %fd0, %fd1;": [((f64(2),), f64(0.5))],
    "ex2.approx.f32 %f0, %f1;": [((f32(3),), f32(8)), ((f32(-200),), 0)],
    # packing
    "mov.b64 %rd0, {%r1, %r2};": [((1, 2), 2**33 + 1)],
    "mov.b64 {%r0, %r1}, %rd1;": [((2**32 + 7,), 7)],
}  # fmt: skip


@pytest.mark.parametrize("instruction", CASES)
def test_an_instruction_follows_the_isa(programs, instruction):
    rows = CASES[instruction]
    columns = np.zeros((3, len(rows)), np.uint64)
    for k, (operands, _) in enumerate(rows):
        columns[: len(operands), k] = operands
    actual = programs.rows(list(CASES), instruction, *columns)
    assert [hex(x) for x in actual] == [hex(result) for _, result in rows]


def _products(a, b):
    return [int(x) * int(y) for x, y in zip(a, b, strict=True)]


RANDOM = {
    "mul.lo.u64 %rd0, %rd1, %rd2;": lambda a, b: [p % 2**64 for p in _products(a, b)],
    "mul.hi.u64 %rd0, %rd1, %rd2;": lambda a, b: [p >> 64 for p in _products(a, b)],
    "mul.hi.u32 %r0, %r1, %r2;": lambda a, b: [p >> 32 for p in _products(a % 2**32, b % 2**32)],
    "sub.s64 %rd0, %rd1, %rd2;": lambda a, b: [(int(x) - int(y)) % 2**64 for x, y in zip(a, b, strict=True)],
    "add.f64 %fd0, %fd1, %fd2;": lambda a, b: (a.view(np.float64) + b.view(np.float64)).view(np.uint64),
    "mul.f64 %fd0, %fd1, %fd2;": lambda a, b: (a.view(np.float64) * b.view(np.float64)).view(np.uint64),
    "div.rn.f64 %fd0, %fd1, %fd2;": lambda a, b: (a.view(np.float64) / b.view(np.float64)).view(np.uint64),
}


@pytest.mark.parametrize("instruction", RANDOM)
def test_arithmetic_matches_numpy(programs, rng, instruction):
    a, b = rng.integers(0, 2**64, (2, 512), np.uint64)
    if "f64" in instruction:
        a, b = (np.ldexp(rng.random(512) - 0.5, rng.integers(-60, 60, 512)).view(np.uint64) for _ in range(2))
    result = programs.rows(list(RANDOM), instruction, a, b)
    np.testing.assert_array_equal(result, np.array(RANDOM[instruction](a, b), np.uint64))


@pytest.mark.parametrize("toward", ["rm", "rp", "rz"])
def test_directed_sums_are_on_their_side_of_the_exact_result(programs, rng, toward):
    instructions = [f"fma.{mode}.f32 %f0, %f1, %f2, %f3;" for mode in ("rm", "rp", "rz")]
    given = np.ldexp(rng.random((3, 256)) - 0.5, rng.integers(-30, 30, (3, 256))).astype(np.float32)
    bits = given.view(np.uint32).astype(np.uint64)
    result = programs.rows(instructions, f"fma.{toward}.f32 %f0, %f1, %f2, %f3;", *bits)
    for a, b, c, x in zip(*given, result.astype(np.uint32).view(np.float32), strict=True):
        exact = Fraction(float(a)) * Fraction(float(b)) + Fraction(float(c))
        up = toward == "rp" or (toward == "rz" and exact < 0)
        neighbor = np.nextafter(x, np.float32(-np.inf if up else np.inf))
        near, far = Fraction(float(x)), Fraction(float(neighbor))
        assert (far < exact <= near) if up else (near <= exact < far)


LANE = np.arange(32)
# instruction -> what the 32 lanes of a warp get, of their first and second columns
LANES = {
    "vote.sync.ballot.b32 %r0, %p1, -1;": lambda a, b: np.full(32, sum(1 << k for k in LANE if a[k])),
    "vote.sync.ballot.b32 %r0, !%p1, 0xFFFFFFFF;": lambda a, b: np.full(32, sum(1 << k for k in LANE if not a[k])),
    "vote.sync.any.pred %p0, %p1, -1;": lambda a, b: np.full(32, a.any()),
    "vote.sync.all.pred %p0, %p1, -1;": lambda a, b: np.full(32, a.all()),
    "vote.sync.uni.pred %p0, %p1, -1;": lambda a, b: np.full(32, (a != 0).all() or not a.any()),
    "shfl.sync.idx.b32 %r0, %r1, 7, 31, -1;": lambda a, b: np.full(32, a[7]),
    "shfl.sync.idx.b32 %r0, %r1, %r2, 31, -1;": lambda a, b: a[b % 32],
    "shfl.sync.idx.b32 %r0|%p1, %r1, 3, 0x181F, -1;": lambda a, b: a[LANE // 8 * 8 + 3],
    "shfl.sync.up.b32 %r0, %r1, 5, 0, -1;": lambda a, b: a[np.where(LANE < 5, LANE, LANE - 5)],
    "shfl.sync.up.b32 %r3|%p0, %r1, 5, 0, -1;": lambda a, b: LANE >= 5,
    "shfl.sync.down.b32 %r0, %r1, 9, 31, -1;": lambda a, b: a[np.where(LANE + 9 > 31, LANE, LANE + 9)],
    "shfl.sync.down.b32 %r3|%p0, %r1, 9, 31, -1;": lambda a, b: LANE + 9 <= 31,
    "shfl.sync.bfly.b32 %r0, %r1, 13, 31, -1;": lambda a, b: a[LANE ^ 13],
    # a guard: the even lanes meet among themselves
    "and.b32 %r3, %row, 1; setp.eq.u32 %p3, %r3, 0; mov.b32 %r0, %r1; "
    "@%p3 shfl.sync.bfly.b32 %r0|%p1, %r1, 2, 31, 0x55555555;": lambda a, b: np.where(LANE % 2, a, a[LANE ^ 2]),
    "and.b32 %r3, %row, 1; setp.eq.u32 %p3, %r3, 0; mov.b32 %r0, 5; "
    "@!%p3 vote.sync.ballot.b32 %r0, %p1, 0xAAAAAAAA;": lambda a, b: np.where(
        LANE % 2, sum(1 << k for k in LANE if k % 2 and a[k]), 5
    ),
    "bar.warp.sync -1; mov.b32 %r0, %r1;": lambda a, b: a,
    "match.any.sync.b32 %r0, %r2, -1;": lambda a, b: [sum(1 << k for k in LANE if b[k] == x) for x in b],
    "match.all.sync.b32 %r0|%p1, %r2, -1;": lambda a, b: np.full(32, 0xFFFFFFFF if len(set(b)) == 1 else 0),
    "redux.sync.add.u32 %r0, %r1, -1;": lambda a, b: np.full(32, int(a.sum()) % 2**32),
    "activemask.b32 %r3; mov.b32 %r0, %r3;": lambda a, b: np.full(32, 0xFFFFFFFF),
    # where lanes have parted
    "mov.b32 %r0, 0; and.b32 %r3, %row, 3; setp.eq.u32 %p3, %r3, 0; @%p3 bra AWAY; activemask.b32 %r0; AWAY:"
    " mov.b32 %r0, %r0;": lambda a, b: np.where(LANE % 4, 0xEEEEEEEE, 0),
}  # fmt: skip


@pytest.mark.parametrize("instruction", LANES)
def test_shuffles_of_a_warp_follow_the_isa(programs, rng, instruction):
    a, b = rng.integers(0, 4, (2, 32), np.uint64)
    result = programs.rows(list(LANES), instruction, a, b)
    np.testing.assert_array_equal(result, np.asarray(LANES[instruction](a, b), np.uint64))


def test_an_instruction_that_is_not_known_is_named(programs, emulated):
    with pytest.raises(UnknownPtx, match=r"wgmma\.fence\.sync\.aligned"):
        programs.load(".visible .entry k() { wgmma.fence.sync.aligned; ret; }")

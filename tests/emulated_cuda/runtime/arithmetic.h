/* PTX's arithmetic where it is not C's: shifts that clamp, casts that saturate, NaN in min and max (PTX ISA 8). */
#pragma once
#include "emulator.h"

INLINE f32 F32(u32 bits)
{
    f32 x;
    memcpy(&x, &bits, 4);
    return x;
}
INLINE f64 F64(u64 bits)
{
    f64 x;
    memcpy(&x, &bits, 8);
    return x;
}
INLINE u32 B32(f32 x)
{
    u32 bits;
    memcpy(&bits, &x, 4);
    return bits;
}
INLINE u64 B64(f64 x)
{
    u64 bits;
    memcpy(&bits, &x, 8);
    return bits;
}

/* ------------------------------------------------------------------------------------------------ shifts */

INLINE u16 shl16(u16 a, u32 n) { return n > 15 ? 0 : (u16)(a << n); }
INLINE u32 shl32(u32 a, u32 n) { return n > 31 ? 0 : a << n; }
INLINE u64 shl64(u64 a, u32 n) { return n > 63 ? 0 : a << n; }
INLINE u16 shru16(u16 a, u32 n) { return n > 15 ? 0 : (u16)(a >> n); }
INLINE u32 shru32(u32 a, u32 n) { return n > 31 ? 0 : a >> n; }
INLINE u64 shru64(u64 a, u32 n) { return n > 63 ? 0 : a >> n; }
INLINE s16 shrs16(s16 a, u32 n) { return (s16)(a >> (n > 15 ? 15 : n)); }
INLINE s32 shrs32(s32 a, u32 n) { return a >> (n > 31 ? 31 : n); }
INLINE s64 shrs64(s64 a, u32 n) { return a >> (n > 63 ? 63 : n); }

/* The upper or lower word of b:a shifted by n, 0..32. */
INLINE u32 funnel_left(u32 a, u32 b, u32 n) { return (u32)(((((u64)b << 32) | a) << n) >> 32); }
INLINE u32 funnel_right(u32 a, u32 b, u32 n) { return (u32)((((u64)b << 32) | a) >> n); }

/* ------------------------------------------------------------------------------------------------ bit fields */

INLINE u64 low_bits(u32 count) { return count > 63 ? ~0ull : (1ull << count) - 1; }

INLINE u32 bfe_u32(u32 a, u32 position, u32 count)
{
    return (u32)(shru32(a, position & 255) & low_bits(count & 255));
}
INLINE u64 bfe_u64(u64 a, u32 position, u32 count) { return shru64(a, position & 255) & low_bits(count & 255); }

/* Bits beyond the field, and beyond the register, are the field's topmost bit that the register has. */
INLINE s64 bfe_signed(u64 a, u32 position, u32 count, u32 width)
{
    position &= 255;
    count &= 255;
    if (!count)
        return 0;
    u32 top = position + count - 1 < width - 1 ? position + count - 1 : width - 1;
    u64 sign = a >> top & 1 ? ~0ull : 0;
    u32 held = position > top ? 0 : top - position + 1;
    u64 field = held ? a >> position & low_bits(held) : 0;
    return (s64)(field | (sign & ~low_bits(held)));
}
INLINE s32 bfe_s32(s32 a, u32 position, u32 count) { return (s32)bfe_signed((u32)a, position, count, 32); }
INLINE s64 bfe_s64(s64 a, u32 position, u32 count) { return bfe_signed((u64)a, position, count, 64); }

INLINE u32 bfi_b32(u32 a, u32 b, u32 position, u32 count)
{
    u32 mask = shl32((u32)low_bits(count & 255), position & 255);
    return (b & ~mask) | (shl32(a, position & 255) & mask);
}
INLINE u64 bfi_b64(u64 a, u64 b, u32 position, u32 count)
{
    u64 mask = shl64(low_bits(count & 255), position & 255);
    return (b & ~mask) | (shl64(a, position & 255) & mask);
}

INLINE u32 brev32(u32 a)
{
    u32 r = 0;
    for (int k = 0; k < 32; k++)
        r |= (a >> k & 1u) << (31 - k);
    return r;
}
INLINE u64 brev64(u64 a) { return (u64)brev32((u32)a) << 32 | brev32((u32)(a >> 32)); }
INLINE u32 clz32(u32 a) { return a ? (u32)__builtin_clz(a) : 32; }
INLINE u32 clz64(u64 a) { return a ? (u32)__builtin_clzll(a) : 64; }
INLINE u32 bfind_u32(u32 a) { return a ? 31 - (u32)__builtin_clz(a) : ~0u; }
INLINE u32 bfind_s32(s32 a) { return bfind_u32((u32)(a < 0 ? ~a : a)); }
INLINE u32 bfind_u64(u64 a) { return a ? 63 - (u32)__builtin_clzll(a) : ~0u; }
INLINE u32 bfind_s64(s64 a) { return bfind_u64((u64)(a < 0 ? ~a : a)); }

/* Four of the eight bytes of b:a, by the digits of the selector; bit 3 of a digit spreads the byte's sign. */
INLINE u32 prmt(u32 a, u32 b, u32 selector)
{
    u64 both = (u64)b << 32 | a;
    u32 r = 0;
    for (int k = 0; k < 4; k++) {
        u32 digit = selector >> (4 * k) & 15;
        u32 byte = (u32)(both >> (8 * (digit & 7))) & 255;
        if (digit & 8)
            byte = byte & 128 ? 255 : 0;
        r |= byte << (8 * k);
    }
    return r;
}

/* c and the dot product of the two halves of a with two bytes of b, from bit `shift` on. */
INLINE u32 dp2a(u32 a, u32 b, u32 c, u32 shift)
{
    return c + (a & 0xFFFF) * (b >> shift & 255) + (a >> 16) * (b >> (shift + 8) & 255);
}

/* Any function of three bits, by its table. */
INLINE u32 lop3(u32 a, u32 b, u32 c, u32 table)
{
    u32 r = 0;
    for (u32 k = 0; k < 8; k++)
        if (table >> k & 1)
            r |= (k & 4 ? a : ~a) & (k & 2 ? b : ~b) & (k & 1 ? c : ~c);
    return r;
}

/* ------------------------------------------------------------------------------------------------ division */

#define DIVISION(T)                                                         \
    INLINE T div_##T(Thread *t, T a, T b, u32 statement)                    \
    {                                                                       \
        if (UNLIKELY(!b)) {                                                 \
            emulator_note(t, NOTE_DIVISION_BY_ZERO, 0, statement, 0);       \
            return (T) ~(T)0;                                               \
        }                                                                   \
        if ((T)-1 < 0 && b == (T)-1)                                        \
            return (T)(0 - (u64)a);                                         \
        return (T)(a / b);                                                  \
    }                                                                       \
    INLINE T rem_##T(Thread *t, T a, T b, u32 statement)                    \
    {                                                                       \
        if (UNLIKELY(!b)) {                                                 \
            emulator_note(t, NOTE_DIVISION_BY_ZERO, 0, statement, 0);       \
            return a;                                                       \
        }                                                                   \
        if ((T)-1 < 0 && b == (T)-1)                                        \
            return 0;                                                       \
        return (T)(a % b);                                                  \
    }
DIVISION(u16)
DIVISION(s16)
DIVISION(u32)
DIVISION(s32)
DIVISION(u64)
DIVISION(s64)

/* ------------------------------------------------------------------------------------------------ floats */

/* The number where one side is NaN; -0 lies below +0. NaN of two NaNs is PTX's own. */
#define EXTREMES(T, quiet)                                                  \
    INLINE T min_##T(T a, T b)                                              \
    {                                                                       \
        if (a != a)                                                         \
            return b != b ? quiet : b;                                      \
        if (b != b)                                                         \
            return a;                                                       \
        if (a == 0 && b == 0)                                               \
            return signbit(a) ? a : b;                                      \
        return a < b ? a : b;                                               \
    }                                                                       \
    INLINE T max_##T(T a, T b)                                              \
    {                                                                       \
        if (a != a)                                                         \
            return b != b ? quiet : b;                                      \
        if (b != b)                                                         \
            return a;                                                       \
        if (a == 0 && b == 0)                                               \
            return signbit(a) ? b : a;                                      \
        return a > b ? a : b;                                               \
    }
EXTREMES(f32, F32(0x7fffffffu))
EXTREMES(f64, F64(0x7fffffffffffffffull))

INLINE f32 flush(f32 a) { return fpclassify(a) == FP_SUBNORMAL ? copysignf(0.0f, a) : a; }
INLINE f32 saturate_f32(f32 a) { return !(a > 0) ? 0.0f : a > 1 ? 1.0f : a; }
INLINE f64 saturate_f64(f64 a) { return !(a > 0) ? 0.0 : a > 1 ? 1.0 : a; }
INLINE f64 round_to(f64 a, int mode)
{
    return mode == 'z' ? trunc(a) : mode == 'm' ? floor(a) : mode == 'p' ? ceil(a) : nearbyint(a);
}

/* a * b + c rounded toward zero, down or up ('z', 'm', 'p'): the product is exact in double, the sum has an error that is
   known, so it shows on which side of the exact result the nearest float lies. */
INLINE f32 fma_towards(f32 a, f32 b, f32 c, int mode)
{
    f64 product = (f64)a * b, sum = product + c;
    f64 part = sum - product, error = (product - (sum - part)) + (c - part);
    f32 nearest = (f32)sum;
    if (!isfinite(sum))
        return nearest;
    f64 above = (f64)nearest - sum;
    int side = above != 0 ? (above > 0 ? 1 : -1) : error == 0 ? 0 : error < 0 ? 1 : -1;
    if (side > 0 && (mode == 'm' || (mode == 'z' && nearest > 0)))
        return nextafterf(nearest, -INFINITY);
    if (side < 0 && (mode == 'p' || (mode == 'z' && nearest < 0)))
        return nextafterf(nearest, INFINITY);
    return nearest;
}

/* Casts to integers saturate; NaN gives 0, or the top bit alone where source or result has 64 bits. */
INLINE s64 to_signed(Thread *t, f64 x, int bits, int wide, int mode, u32 statement)
{
    s64 high = (s64)low_bits((u32)bits - 1), low = -high - 1;
    f64 end = 2.0 * (f64)(1ull << (bits - 2));
    f64 rounded = round_to(x, mode);
    if (rounded >= -end && rounded < end)
        return (s64)rounded;
    emulator_note(t, NOTE_CAST_OUT_OF_RANGE, 0, statement, 0);
    return x != x ? (wide ? low : 0) : x > 0 ? high : low;
}
INLINE u64 to_unsigned(Thread *t, f64 x, int bits, int wide, int mode, u32 statement)
{
    u64 high = low_bits((u32)bits);
    f64 end = 2.0 * (f64)(1ull << (bits - 1));
    f64 rounded = round_to(x, mode);
    if (rounded >= 0 && rounded < end)
        return (u64)rounded;
    emulator_note(t, NOTE_CAST_OUT_OF_RANGE, 0, statement, 0);
    return x != x ? (wide ? 1ull << (bits - 1) : 0) : x > 0 ? high : 0;
}

INLINE u16 float_to_half(f32 x)
{
    _Float16 h = (_Float16)x;
    u16 bits;
    memcpy(&bits, &h, 2);
    return bits;
}
INLINE f32 half_to_float(u16 h)
{
    u32 sign = (u32)(h & 0x8000) << 16, exponent = h >> 10 & 31, mantissa = h & 1023;
    if (exponent == 0)
        return (sign ? -1.0f : 1.0f) * ldexpf((f32)mantissa, -24);
    if (exponent == 31)
        return F32(sign | 0x7f800000u | mantissa << 13);
    return F32(sign | (exponent + 112) << 23 | mantissa << 13);
}

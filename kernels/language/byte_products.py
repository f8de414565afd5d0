"""Inner products of bytes, sixteen at once: the built-in `sixteen_products(bytes, row, blocks, block)`.

Of a row of 128 bytes and of the 16 of a block of signed bytes, which has four numbers of the first, four of the second
and so on: for each of them vpdpbusd adds four products of AVX-512 VNNI. LLVM makes that of no loop: of the plain one it
makes what takes 7 times as long with AVX-512, and 1.2 times as long as VNNI with AVX2, so there the plain one stands.
Of it NVRTC makes dp4a.
"""

from __future__ import annotations

from typing import Any

import warp as wp


@wp.func_native("""
    const unsigned char* mine = bytes.data + (long long)row * 128;
    const signed char* theirs = (const signed char*)blocks.data + (long long)block * 2048;
    wp::vec_t<16, int> found;
#if defined(__AVX512VNNI__) && __clang_major__ == 22 && !defined(__CUDA_ARCH__)  // whose built-ins have these types
    typedef int lanes __attribute__((vector_size(64), aligned(1), may_alias));
    typedef unsigned char unsigned_bytes __attribute__((vector_size(64)));
    typedef signed char signed_bytes __attribute__((vector_size(64)));
    lanes sums[4] = {};
    for (int k = 0; k < 32; k += 4)
        for (int part = 0; part < 4; ++part) {
            int four;
            __builtin_memcpy(&four, mine + 4 * (k + part), 4);
            lanes same = lanes{} + four;
            lanes other = *(const lanes*)(theirs + 64 * (k + part));
            sums[part] = __builtin_ia32_vpdpbusd512(sums[part], (unsigned_bytes)same, (signed_bytes)other);
        }
    lanes all = (sums[0] + sums[1]) + (sums[2] + sums[3]);
    __builtin_memcpy(found.c, &all, sizeof(all));
#elif defined(__AVX512BW__) && __clang_major__ == 22 && !defined(__CUDA_ARCH__)
    typedef int lanes __attribute__((vector_size(64), may_alias));
    typedef long long quads __attribute__((vector_size(64)));
    typedef short shorts __attribute__((vector_size(64)));
    typedef signed char half __attribute__((vector_size(32), aligned(1), may_alias));
    lanes low = {}, high = {};
    for (int k = 0; k < 32; ++k) {
        unsigned long long four = 0;
        for (int part = 0; part < 4; ++part) four |= (unsigned long long)mine[4 * k + part] << 16 * part;
        shorts same = (shorts)(quads{} + (long long)four);
        const half* others = (const half*)(theirs + 64 * k);
        low += (lanes)__builtin_ia32_pmaddwd512(__builtin_convertvector(others[0], shorts), same);
        high += (lanes)__builtin_ia32_pmaddwd512(__builtin_convertvector(others[1], shorts), same);
    }
    lanes all = __builtin_shufflevector(low, high, 0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30);
    all += __builtin_shufflevector(low, high, 1, 3, 5, 7, 9, 11, 13, 15, 17, 19, 21, 23, 25, 27, 29, 31);
    __builtin_memcpy(found.c, &all, sizeof(all));
#else
    for (int lane = 0; lane < 16; ++lane) found.c[lane] = 0;
    for (int k = 0; k < 32; ++k)
        for (int lane = 0; lane < 16; ++lane)
            for (int part = 0; part < 4; ++part)
                found.c[lane] += (int)mine[4 * k + part] * (int)theirs[64 * k + 4 * lane + part];
#endif
    return found;
""")
def sixteen_products(
    bytes: wp.array2d(dtype=wp.uint8),  # type: ignore[valid-type]
    row: wp.int32,
    blocks: wp.array2d(dtype=wp.int8),  # type: ignore[valid-type]
    block: wp.int32,
) -> wp.types.vector(16, wp.int32):  # type: ignore[valid-type]
    """The products, int32."""
    ...


def sixteen_products_for(ti: Any) -> Any:
    """The same for Taichi."""

    def sixteen_products(rows, row, blocks, block):
        found = ti.Vector([0] * 16)
        for k in range(128):
            mine = ti.cast(rows[row, k], ti.i32)
            for lane in ti.static(range(16)):
                found[lane] += mine * ti.cast(blocks[block, k // 4 * 64 + 4 * lane + k % 4], ti.i32)
        return found

    sixteen_products.__annotations__ = {"rows": ti.template(), "blocks": ti.template()}
    return sixteen_products

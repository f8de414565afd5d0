#define WP_NO_BFLOAT16

#define WP_TILE_BLOCK_DIM 1
#define WP_NO_CRT
#include "builtin.h"
#include "deterministic.h"

#define builtin_tid1d() wp::linear_tid<wp_linear_tid>(task_index, dim)
#define builtin_tid2d(x, y) wp::tid(x, y, task_index, dim)
#define builtin_tid3d(x, y, z) wp::tid(x, y, z, task_index, dim)
#define builtin_tid4d(x, y, z, w) wp::tid(x, y, z, w, task_index, dim)

#define builtin_block_dim() wp::block_dim()

// Overloads for the CPU code that Warp generates, included after Warp's headers: arrays are contiguous and indices are not
// negative, which saves a multiplication, a comparison and an addition per element. They are more specialized than Warp's.
// If Warp renames its own, they are unused or fail to compile: pool_code.py tests that.

namespace wp {

template <typename T> inline T* address(const array_t<T>& a, int i) { return a.data + i; }
template <typename T> inline T* address(const array_t<T>& a, int i, int j) { return a.data + ((long long)i * a.shape[1] + j); }
template <typename T> inline T* address(const array_t<T>& a, int i, int j, int k)
{
    return a.data + (((long long)i * a.shape[1] + j) * a.shape[2] + k);
}
template <typename T> inline void array_store(const array_t<T>& a, int i, T value) { a.data[i] = value; }
template <typename T> inline void array_store(const array_t<T>& a, int i, int j, T value) { *address(a, i, j) = value; }
template <typename T> inline void array_store(const array_t<T>& a, int i, int j, int k, T value)
{
    *address(a, i, j, k) = value;
}

// Warp's own atomics on the CPU are for one thread: a load, and a store.
template <typename T> inline T shared_add(T* place, T value)
{
    T old, wanted;
    __atomic_load(place, &old, __ATOMIC_RELAXED);
    do wanted = old + value; while (!__atomic_compare_exchange(place, &old, &wanted, true, __ATOMIC_SEQ_CST, __ATOMIC_RELAXED));
    return old;
}
inline int shared_add(int* place, int value) { return __atomic_fetch_add(place, value, __ATOMIC_SEQ_CST); }
inline int64 shared_add(int64* place, int64 value) { return __atomic_fetch_add(place, value, __ATOMIC_SEQ_CST); }
template <typename T> inline T shared_min(T* place, T value)
{
    T old;
    __atomic_load(place, &old, __ATOMIC_RELAXED);
    while (value < old && !__atomic_compare_exchange(place, &old, &value, true, __ATOMIC_SEQ_CST, __ATOMIC_RELAXED)) {}
    return old;
}
template <typename T> inline T shared_max(T* place, T value)
{
    T old;
    __atomic_load(place, &old, __ATOMIC_RELAXED);
    while (old < value && !__atomic_compare_exchange(place, &old, &value, true, __ATOMIC_SEQ_CST, __ATOMIC_RELAXED)) {}
    return old;
}
template <typename T> inline T atomic_add(const array_t<T>& a, int i, T value) { return shared_add(a.data + i, value); }
template <typename T> inline T atomic_min(const array_t<T>& a, int i, T value) { return shared_min(a.data + i, value); }
template <typename T> inline T atomic_max(const array_t<T>& a, int i, T value) { return shared_max(a.data + i, value); }
template <typename T> inline T atomic_add(const array_t<T>& a, int i, int j, T value) { return shared_add(address(a, i, j), value); }
template <typename T> inline T atomic_min(const array_t<T>& a, int i, int j, T value) { return shared_min(address(a, i, j), value); }
template <typename T> inline T atomic_max(const array_t<T>& a, int i, int j, T value) { return shared_max(address(a, i, j), value); }

template <unsigned N, typename T> inline T extract(vec_t<N, T>& v, int i) { return v.c[i]; }
template <unsigned R, unsigned C, typename T> inline T extract(mat_t<R, C, T>& m, int i, int j) { return m.data[i][j]; }

// Warp's version calls a library function for each number.
inline bool is_number(double x) { return x - x == 0.0; }
inline bool is_number(float x) { return x - x == 0.0f; }
template <typename T> inline bool is_number(const T& x) { return true; }
template <unsigned N, typename T> inline bool is_number(const vec_t<N, T>& v)
{
    bool all = true;
    for (unsigned i = 0; i < N; ++i) all = all & (v.c[i] - v.c[i] == T(0));
    return all;
}

// A range constructed in place: a function would return four numbers packed in two 64-bit registers.
struct made_range : range_t {
    inline made_range(int last) { start = 0, end = last, step = 1, i = 0; }
    inline made_range(int first, int last) { start = first, end = last, step = 1, i = first; }
    inline made_range(int first, int last, int by) { start = first, end = last, step = by, i = first; }
};

// A part of a launch: if the highest bit of the extent is set, the others are the part's first thread. Warp itself sets
// the extent, below 2^31, and begins at 0.
template <bool Linear> inline int linear_tid(size_t index, const launch_bounds_t<1>& bounds)
{
    const unsigned first = bounds.shape[0];
    return int(index) + int(first & 0x80000000u ? first & 0x7fffffffu : 0u);
}

}
#define range made_range
#define isfinite is_number
// Warp compiles each body for known and for other strides, and tests `dim->coord_mult == 1 && ...`. One is enough here.
#define coord_mult coord_mult * 0

// avoid namespacing of float type for casting to float type, this is to avoid wp::float(x), which is not valid in C++
#define float(x) cast_float(x)
#define adj_float(x, adj_x, adj_ret) adj_cast_float(x, adj_x, adj_ret)

#define int(x) cast_int(x)
#define adj_int(x, adj_x, adj_ret) adj_cast_int(x, adj_x, adj_ret)


// <pointloom.kernels.volumes.bit_rows.bits_below>:1
static wp::int32 bits_below_0(
    wp::int32 var_index)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 1;
    wp::uint32 var_1;
    wp::uint32 var_2;
    wp::uint32 var_3;
    const wp::int32 var_4 = 1;
    wp::uint32 var_5;
    wp::uint32 var_6;
    wp::int32 var_7;
    //---------
    // forward
    // def bits_below(index):                                                                 <L 1>
    // return int((uint32(1) << uint32(index)) - uint32(1))                                   <L 2>
    var_1 = wp::uint32(var_0);
    var_2 = wp::uint32(var_index);
    var_3 = wp::lshift(var_1, var_2);
    var_5 = wp::uint32(var_4);
    var_6 = wp::sub(var_3, var_5);
    var_7 = wp::int(var_6);
    return var_7;
}


// /work/main/src/pointloom/kernels/volumes/bit_rows.py:50
static wp::int32 has_next_0(
    wp::int32 var_w,
    wp::int32 var_nz)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 1;
    wp::int32 var_1;
    const wp::int32 var_2 = 32;
    wp::int32 var_3;
    wp::int32 var_4;
    const wp::int32 var_5 = -1;
    wp::int32 var_6;
    bool var_7;
    const wp::int32 var_8 = 0;
    wp::int32 var_9;
    wp::int32 var_10;
    wp::int32 var_11;
    //---------
    // forward
    // def has_next(w: int, nz: int) -> int:                                                  <L 51>
    // left = nz - 1 - w * WORD                                                               <L 52>
    var_1 = wp::sub(var_nz, var_0);
    var_3 = wp::mul(var_w, var_2);
    var_4 = wp::sub(var_1, var_3);
    // mask = int(ALL)                                                                        <L 53>
    var_6 = wp::int(var_5);
    // if left < WORD:                                                                        <L 54>
    var_7 = (var_4 < var_2);
    if (var_7) {
        // mask = bits_below(max(left, 0))                                                    <L 55>
        var_9 = wp::max(var_4, var_8);
        var_10 = bits_below_0(var_9);
    }
    var_11 = wp::where(var_7, var_10, var_6);
    // return mask                                                                            <L 56>
    return var_11;
}


// <pointloom.kernels.volumes.bit_rows.above>:1
static wp::int32 above_0(
    wp::array_t<wp::int32> var_words,
    wp::int32 var_row,
    wp::int32 var_w,
    wp::int32 var_width)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    const wp::int32 var_2 = 1;
    wp::int32 var_3;
    bool var_4;
    wp::int32 var_5;
    wp::int32 var_6;
    const wp::int32 var_7 = 1;
    wp::int32 var_8;
    wp::int32* var_9;
    const wp::int32 var_10 = 31;
    wp::int32 var_11;
    wp::int32 var_12;
    wp::int32 var_13;
    wp::int32 var_14;
    wp::int32 var_15;
    wp::int32* var_16;
    const wp::int32 var_17 = 1;
    wp::int32 var_18;
    wp::int32 var_19;
    const wp::int32 var_20 = 2147483647;
    wp::int32 var_21;
    wp::int32 var_22;
    //---------
    // forward
    // def above(words, row, w, width):                                                       <L 1>
    // carry = int(0)                                                                         <L 3>
    var_1 = wp::int(var_0);
    // if w + 1 < width:                                                                      <L 4>
    var_3 = wp::add(var_w, var_2);
    var_4 = (var_3 < var_width);
    if (var_4) {
        // carry = words[row * width + w + 1] << 31                                           <L 5>
        var_5 = wp::mul(var_row, var_width);
        var_6 = wp::add(var_5, var_w);
        var_8 = wp::add(var_6, var_7);
        var_9 = wp::address(var_words, var_8);
        var_12 = wp::load(var_9);
        var_11 = wp::lshift(var_12, var_10);
    }
    var_13 = wp::where(var_4, var_11, var_1);
    // return words[row * width + w] >> 1 & LOW_31 | carry                                    <L 6>
    var_14 = wp::mul(var_row, var_width);
    var_15 = wp::add(var_14, var_w);
    var_16 = wp::address(var_words, var_15);
    var_19 = wp::load(var_16);
    var_18 = wp::rshift(var_19, var_17);
    var_21 = wp::bit_and(var_18, var_20);
    var_22 = wp::bit_or(var_21, var_13);
    return var_22;
}


// <pointloom.kernels.volumes.marching_cubes.finite_pairs>:1
static wp::int32 finite_pairs_0(
    wp::int32 var_row,
    wp::int32 var_w,
    wp::int32 var_grid__width,
    wp::array_t<wp::int32> var_grid__finite)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32 var_1;
    wp::int32* var_2;
    wp::int32 var_3;
    wp::int32 var_4;
    wp::int32 var_5;
    //---------
    // forward
    // def finite_pairs(row, w, grid__width, grid__finite):                                   <L 1>
    // return grid__finite[row * grid__width + w] & above(grid__finite, row, w, grid__width)       <L 3>
    var_0 = wp::mul(var_row, var_grid__width);
    var_1 = wp::add(var_0, var_w);
    var_2 = wp::address(var_grid__finite, var_1);
    var_3 = above_0(var_grid__finite, var_row, var_w, var_grid__width);
    var_5 = wp::load(var_2);
    var_4 = wp::bit_and(var_5, var_3);
    return var_4;
}


// <pointloom.kernels.volumes.bit_rows.lowest_bit>:1
static wp::int32 lowest_bit_1(
    wp::int32 var_word)
{
    //---------
    // primal vars
    wp::uint32 var_0;
    wp::uint32 var_1;
    const wp::int32 var_2 = 1;
    wp::uint32 var_3;
    wp::uint32 var_4;
    wp::uint32 var_5;
    const wp::int32 var_6 = 1;
    wp::uint32 var_7;
    wp::uint32 var_8;
    wp::int32 var_9;
    wp::int32 var_10;
    //---------
    // forward
    // def lowest_bit(word):                                                                  <L 1>
    // w = uint32(word)                                                                       <L 3>
    var_0 = wp::uint32(var_word);
    // return bit_count(int((w & ~w + uint32(1)) - uint32(1)))                                <L 4>
    var_1 = wp::invert(var_0);
    var_3 = wp::uint32(var_2);
    var_4 = wp::add(var_1, var_3);
    var_5 = wp::bit_and(var_0, var_4);
    var_7 = wp::uint32(var_6);
    var_8 = wp::sub(var_5, var_7);
    var_9 = wp::int(var_8);
    var_10 = wp::bit_count(var_9);
    return var_10;
}


// /work/main/src/pointloom/kernels/volumes/bit_rows.py:26
static wp::int32 bit_0(
    wp::int32 var_word,
    wp::int32 var_index)
{
    //---------
    // primal vars
    wp::int32 var_0;
    const wp::int32 var_1 = 1;
    wp::int32 var_2;
    //---------
    // forward
    // def bit(word: int, index: int) -> int:                                                 <L 27>
    // return (word >> index) & 1                                                             <L 28>
    var_0 = wp::rshift(var_word, var_index);
    var_2 = wp::bit_and(var_0, var_1);
    return var_2;
}


// /work/main/src/pointloom/kernels/volumes/marching_cubes.py:286
static wp::float32 crossing_fraction_0(
    wp::float32 var_a,
    wp::float32 var_b,
    wp::float32 var_level)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::float64 var_1;
    wp::float64 var_2;
    wp::float64 var_3;
    wp::float64 var_4;
    wp::float64 var_5;
    wp::float64 var_6;
    wp::float32 var_7;
    //---------
    // forward
    // def crossing_fraction(a: float, b: float, level: float) -> float:                      <L 287>
    // return float((float64(level) - float64(a)) / (float64(b) - float64(a)))                <L 289>
    var_0 = wp::float64(var_level);
    var_1 = wp::float64(var_a);
    var_2 = wp::sub(var_0, var_1);
    var_3 = wp::float64(var_b);
    var_4 = wp::float64(var_a);
    var_5 = wp::sub(var_3, var_4);
    var_6 = wp::div(var_2, var_5);
    var_7 = wp::float(var_6);
    return var_7;
}


// <pointloom.kernels.volumes.marching_cubes.sign_word>:1
static wp::int32 sign_word_0(
    wp::int32 var_row,
    wp::int32 var_w,
    wp::int32 var_grid__width,
    wp::array_t<wp::int32> var_grid__signs)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32 var_1;
    wp::int32* var_2;
    wp::int32 var_3;
    wp::int32 var_4;
    //---------
    // forward
    // def sign_word(row, w, grid__width, grid__signs):                                       <L 1>
    // return grid__signs[row * grid__width + w]                                              <L 2>
    var_0 = wp::mul(var_row, var_grid__width);
    var_1 = wp::add(var_0, var_w);
    var_2 = wp::address(var_grid__signs, var_1);
    var_4 = wp::load(var_2);
    var_3 = wp::copy(var_4);
    return var_3;
}


// <pointloom.kernels.volumes.marching_cubes.signs_above>:1
static wp::int32 signs_above_0(
    wp::int32 var_row,
    wp::int32 var_w,
    wp::int32 var_grid__width,
    wp::array_t<wp::int32> var_grid__signs)
{
    //---------
    // primal vars
    wp::int32 var_0;
    //---------
    // forward
    // def signs_above(row, w, grid__width, grid__signs):                                     <L 1>
    // return above(grid__signs, row, w, grid__width)                                         <L 2>
    var_0 = above_0(var_grid__signs, var_row, var_w, var_grid__width);
    return var_0;
}


// <pointloom.kernels.volumes.bit_rows.with_below>:1
static wp::int32 with_below_0(
    wp::array_t<wp::int32> var_words,
    wp::int32 var_row,
    wp::int32 var_w,
    wp::int32 var_width)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32 var_1;
    wp::int32* var_2;
    wp::int32 var_3;
    wp::int32 var_4;
    const wp::int32 var_5 = 0;
    wp::int32 var_6;
    const wp::int32 var_7 = 0;
    bool var_8;
    wp::int32 var_9;
    wp::int32 var_10;
    const wp::int32 var_11 = 1;
    wp::int32 var_12;
    wp::int32* var_13;
    const wp::int32 var_14 = 31;
    wp::int32 var_15;
    wp::int32 var_16;
    const wp::int32 var_17 = 1;
    wp::int32 var_18;
    wp::int32 var_19;
    const wp::int32 var_20 = 1;
    wp::int32 var_21;
    wp::int32 var_22;
    wp::int32 var_23;
    //---------
    // forward
    // def with_below(words, row, w, width):                                                  <L 1>
    // word = words[row * width + w]                                                          <L 3>
    var_0 = wp::mul(var_row, var_width);
    var_1 = wp::add(var_0, var_w);
    var_2 = wp::address(var_words, var_1);
    var_4 = wp::load(var_2);
    var_3 = wp::copy(var_4);
    // carry = int(0)                                                                         <L 4>
    var_6 = wp::int(var_5);
    // if w > 0:                                                                              <L 5>
    var_8 = (var_w > var_7);
    if (var_8) {
        // carry = words[row * width + w - 1] >> 31 & 1                                       <L 6>
        var_9 = wp::mul(var_row, var_width);
        var_10 = wp::add(var_9, var_w);
        var_12 = wp::sub(var_10, var_11);
        var_13 = wp::address(var_words, var_12);
        var_16 = wp::load(var_13);
        var_15 = wp::rshift(var_16, var_14);
        var_18 = wp::bit_and(var_15, var_17);
    }
    var_19 = wp::where(var_8, var_18, var_6);
    // return word | word << 1 | carry                                                        <L 7>
    var_21 = wp::lshift(var_3, var_20);
    var_22 = wp::bit_or(var_3, var_21);
    var_23 = wp::bit_or(var_22, var_19);
    return var_23;
}


// <pointloom.kernels.volumes.marching_cubes.crossing_edges>:1
static wp::vec_t<4, wp::int32> crossing_edges_0(
    wp::int32 var_row,
    wp::int32 var_w,
    wp::int32 var_grid__width,
    wp::int32 var_grid__rows,
    wp::int32 var_grid__ny,
    wp::int32 var_grid__nz,
    wp::array_t<wp::int32> var_grid__signs,
    wp::array_t<wp::int32> var_grid__complete,
    wp::array_t<wp::int32> var_grid__has_gaps)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32 var_1;
    const wp::int32 var_2 = 0;
    wp::int32 var_3;
    const wp::int32 var_4 = 0;
    wp::int32 var_5;
    wp::int32 var_6;
    wp::int32 var_7;
    wp::int32 var_8;
    wp::int32 var_9;
    wp::int32 var_10;
    bool var_11;
    wp::int32 var_12;
    wp::int32 var_13;
    wp::int32 var_14;
    wp::int32 var_15;
    const wp::int32 var_16 = 1;
    wp::int32 var_17;
    bool var_18;
    const wp::int32 var_19 = 1;
    wp::int32 var_20;
    wp::int32 var_21;
    wp::int32 var_22;
    wp::int32 var_23;
    const wp::int32 var_24 = 0;
    wp::int32* var_25;
    const wp::int32 var_26 = 0;
    bool var_27;
    wp::int32 var_28;
    wp::int32 var_29;
    wp::int32 var_30;
    wp::int32 var_31;
    wp::int32 var_32;
    wp::int32* var_33;
    wp::int32 var_34;
    wp::int32 var_35;
    const wp::int32 var_36 = 0;
    bool var_37;
    const wp::int32 var_38 = 1;
    wp::int32 var_39;
    wp::int32 var_40;
    wp::int32 var_41;
    const wp::int32 var_42 = 1;
    wp::int32 var_43;
    wp::int32 var_44;
    wp::int32 var_45;
    wp::int32* var_46;
    wp::int32 var_47;
    wp::int32 var_48;
    wp::int32 var_49;
    wp::int32 var_50;
    bool var_51;
    wp::int32 var_52;
    wp::int32 var_53;
    wp::int32 var_54;
    wp::int32 var_55;
    wp::int32 var_56;
    wp::int32 var_57;
    wp::int32* var_58;
    wp::int32 var_59;
    wp::int32 var_60;
    wp::int32 var_61;
    wp::int32 var_62;
    bool var_63;
    const wp::int32 var_64 = 0;
    bool var_65;
    bool var_66;
    wp::int32 var_67;
    const wp::int32 var_68 = 1;
    wp::int32 var_69;
    wp::int32 var_70;
    wp::int32 var_71;
    wp::int32* var_72;
    wp::int32 var_73;
    wp::int32 var_74;
    wp::int32 var_75;
    wp::int32 var_76;
    wp::int32 var_77;
    wp::int32 var_78;
    wp::int32 var_79;
    wp::int32 var_80;
    wp::int32 var_81;
    const wp::int32 var_82 = 0;
    wp::vec_t<4, wp::int32> var_83;
    //---------
    // forward
    // def crossing_edges(row, w, grid__width, grid__rows, grid__ny, grid__nz, grid__signs, grid__complete, grid__has_gaps):       <L 1>
    // y = row % grid__ny                                                                     <L 3>
    var_0 = wp::mod(var_row, var_grid__ny);
    // a = sign_word(row, w, grid__width, grid__signs)                                        <L 4>
    var_1 = sign_word_0(var_row, var_w, var_grid__width, var_grid__signs);
    // ex = int(0)                                                                            <L 5>
    var_3 = wp::int(var_2);
    // ey = int(0)                                                                            <L 6>
    var_5 = wp::int(var_4);
    // ez = (a ^ signs_above(row, w, grid__width, grid__signs)) & has_next(w, grid__nz)       <L 7>
    var_6 = signs_above_0(var_row, var_w, var_grid__width, var_grid__signs);
    var_7 = wp::bit_xor(var_1, var_6);
    var_8 = has_next_0(var_w, var_grid__nz);
    var_9 = wp::bit_and(var_7, var_8);
    // if row + grid__ny < grid__rows:                                                        <L 8>
    var_10 = wp::add(var_row, var_grid__ny);
    var_11 = (var_10 < var_grid__rows);
    if (var_11) {
        // ex = a ^ sign_word(row + grid__ny, w, grid__width, grid__signs)                    <L 9>
        var_12 = wp::add(var_row, var_grid__ny);
        var_13 = sign_word_0(var_12, var_w, var_grid__width, var_grid__signs);
        var_14 = wp::bit_xor(var_1, var_13);
    }
    var_15 = wp::where(var_11, var_14, var_3);
    // if y + 1 < grid__ny:                                                                   <L 10>
    var_17 = wp::add(var_0, var_16);
    var_18 = (var_17 < var_grid__ny);
    if (var_18) {
        // ey = a ^ sign_word(row + 1, w, grid__width, grid__signs)                           <L 11>
        var_20 = wp::add(var_row, var_19);
        var_21 = sign_word_0(var_20, var_w, var_grid__width, var_grid__signs);
        var_22 = wp::bit_xor(var_1, var_21);
    }
    var_23 = wp::where(var_18, var_22, var_5);
    // if grid__has_gaps[0] != 0:                                                             <L 12>
    var_25 = wp::address(var_grid__has_gaps, var_24);
    var_28 = wp::load(var_25);
    var_27 = (var_28 != var_26);
    if (var_27) {
        // along_x = with_below(grid__complete, row, w, grid__width)                          <L 13>
        var_29 = with_below_0(var_grid__complete, var_row, var_w, var_grid__width);
        // along_y = along_x                                                                  <L 14>
        var_30 = wp::copy(var_29);
        // along_z = grid__complete[row * grid__width + w]                                    <L 15>
        var_31 = wp::mul(var_row, var_grid__width);
        var_32 = wp::add(var_31, var_w);
        var_33 = wp::address(var_grid__complete, var_32);
        var_35 = wp::load(var_33);
        var_34 = wp::copy(var_35);
        // if y > 0:                                                                          <L 16>
        var_37 = (var_0 > var_36);
        if (var_37) {
            // along_x = along_x | with_below(grid__complete, row - 1, w, grid__width)        <L 17>
            var_39 = wp::sub(var_row, var_38);
            var_40 = with_below_0(var_grid__complete, var_39, var_w, var_grid__width);
            var_41 = wp::bit_or(var_29, var_40);
            // along_z = along_z | grid__complete[(row - 1) * grid__width + w]                <L 18>
            var_43 = wp::sub(var_row, var_42);
            var_44 = wp::mul(var_43, var_grid__width);
            var_45 = wp::add(var_44, var_w);
            var_46 = wp::address(var_grid__complete, var_45);
            var_48 = wp::load(var_46);
            var_47 = wp::bit_or(var_34, var_48);
        }
        var_49 = wp::where(var_37, var_41, var_29);
        var_50 = wp::where(var_37, var_47, var_34);
        // if row >= grid__ny:                                                                <L 19>
        var_51 = (var_row >= var_grid__ny);
        if (var_51) {
            // along_y = along_y | with_below(grid__complete, row - grid__ny, w, grid__width)       <L 20>
            var_52 = wp::sub(var_row, var_grid__ny);
            var_53 = with_below_0(var_grid__complete, var_52, var_w, var_grid__width);
            var_54 = wp::bit_or(var_30, var_53);
            // along_z = along_z | grid__complete[(row - grid__ny) * grid__width + w]         <L 21>
            var_55 = wp::sub(var_row, var_grid__ny);
            var_56 = wp::mul(var_55, var_grid__width);
            var_57 = wp::add(var_56, var_w);
            var_58 = wp::address(var_grid__complete, var_57);
            var_60 = wp::load(var_58);
            var_59 = wp::bit_or(var_50, var_60);
        }
        var_61 = wp::where(var_51, var_54, var_30);
        var_62 = wp::where(var_51, var_59, var_50);
        // if y > 0 and row >= grid__ny:                                                      <L 22>
        var_65 = (var_0 > var_64);
        var_63 = var_65;
        if (var_63) {
            var_66 = (var_row >= var_grid__ny);
            var_63 = var_63 && var_66;
        }
        if (var_63) {
            // along_z = along_z | grid__complete[(row - grid__ny - 1) * grid__width + w]       <L 23>
            var_67 = wp::sub(var_row, var_grid__ny);
            var_69 = wp::sub(var_67, var_68);
            var_70 = wp::mul(var_69, var_grid__width);
            var_71 = wp::add(var_70, var_w);
            var_72 = wp::address(var_grid__complete, var_71);
            var_74 = wp::load(var_72);
            var_73 = wp::bit_or(var_62, var_74);
        }
        var_75 = wp::where(var_63, var_73, var_62);
        // ex = ex & along_x                                                                  <L 24>
        var_76 = wp::bit_and(var_15, var_49);
        // ey = ey & along_y                                                                  <L 25>
        var_77 = wp::bit_and(var_23, var_61);
        // ez = ez & along_z                                                                  <L 26>
        var_78 = wp::bit_and(var_9, var_75);
    }
    var_79 = wp::where(var_27, var_76, var_15);
    var_80 = wp::where(var_27, var_77, var_23);
    var_81 = wp::where(var_27, var_78, var_9);
    // return vec4i(0, ex, ey, ez)                                                            <L 27>
    var_83 = wp::vec_t<4, wp::int32>(var_82, var_79, var_80, var_81);
    return var_83;
}


// <pointloom.kernels.volumes.marching_cubes.surface_cells>:1
static wp::int32 surface_cells_0(
    wp::int32 var_row,
    wp::int32 var_w,
    wp::int32 var_grid__width,
    wp::int32 var_grid__ny,
    wp::int32 var_grid__nz,
    wp::array_t<wp::int32> var_grid__signs,
    wp::array_t<wp::int32> var_grid__complete,
    wp::array_t<wp::int32> var_grid__has_gaps)
{
    //---------
    // primal vars
    wp::int32 var_0;
    const wp::int32 var_1 = 1;
    wp::int32 var_2;
    wp::int32 var_3;
    wp::int32 var_4;
    wp::int32 var_5;
    wp::int32 var_6;
    const wp::int32 var_7 = 1;
    wp::int32 var_8;
    wp::int32 var_9;
    wp::int32 var_10;
    wp::int32 var_11;
    wp::int32 var_12;
    wp::int32 var_13;
    wp::int32 var_14;
    wp::int32 var_15;
    wp::int32 var_16;
    wp::int32 var_17;
    const wp::int32 var_18 = 1;
    wp::int32 var_19;
    wp::int32 var_20;
    wp::int32 var_21;
    wp::int32 var_22;
    wp::int32 var_23;
    wp::int32 var_24;
    wp::int32 var_25;
    wp::int32 var_26;
    wp::int32 var_27;
    const wp::int32 var_28 = 1;
    wp::int32 var_29;
    wp::int32 var_30;
    wp::int32 var_31;
    wp::int32 var_32;
    wp::int32 var_33;
    wp::int32 var_34;
    const wp::int32 var_35 = 0;
    wp::int32* var_36;
    const wp::int32 var_37 = 0;
    bool var_38;
    wp::int32 var_39;
    wp::int32 var_40;
    wp::int32 var_41;
    wp::int32* var_42;
    wp::int32 var_43;
    wp::int32 var_44;
    wp::int32 var_45;
    //---------
    // forward
    // def surface_cells(row, w, grid__width, grid__ny, grid__nz, grid__signs, grid__complete, grid__has_gaps):       <L 1>
    // a = sign_word(row, w, grid__width, grid__signs)                                        <L 2>
    var_0 = sign_word_0(var_row, var_w, var_grid__width, var_grid__signs);
    // b = sign_word(row + 1, w, grid__width, grid__signs)                                    <L 3>
    var_2 = wp::add(var_row, var_1);
    var_3 = sign_word_0(var_2, var_w, var_grid__width, var_grid__signs);
    // c = sign_word(row + grid__ny, w, grid__width, grid__signs)                             <L 4>
    var_4 = wp::add(var_row, var_grid__ny);
    var_5 = sign_word_0(var_4, var_w, var_grid__width, var_grid__signs);
    // d = sign_word(row + grid__ny + 1, w, grid__width, grid__signs)                         <L 5>
    var_6 = wp::add(var_row, var_grid__ny);
    var_8 = wp::add(var_6, var_7);
    var_9 = sign_word_0(var_8, var_w, var_grid__width, var_grid__signs);
    // mixed = a ^ b | a ^ c | a ^ d                                                          <L 6>
    var_10 = wp::bit_xor(var_0, var_3);
    var_11 = wp::bit_xor(var_0, var_5);
    var_12 = wp::bit_or(var_10, var_11);
    var_13 = wp::bit_xor(var_0, var_9);
    var_14 = wp::bit_or(var_12, var_13);
    // mixed = mixed | a ^ signs_above(row, w, grid__width, grid__signs) | a ^ signs_above(row + 1, w, grid__width, grid__signs)       <L 7>
    var_15 = signs_above_0(var_row, var_w, var_grid__width, var_grid__signs);
    var_16 = wp::bit_xor(var_0, var_15);
    var_17 = wp::bit_or(var_14, var_16);
    var_19 = wp::add(var_row, var_18);
    var_20 = signs_above_0(var_19, var_w, var_grid__width, var_grid__signs);
    var_21 = wp::bit_xor(var_0, var_20);
    var_22 = wp::bit_or(var_17, var_21);
    // mixed = mixed | a ^ signs_above(row + grid__ny, w, grid__width, grid__signs) | a ^ signs_above(row + grid__ny + 1, w, grid__width, grid__signs)       <L 8>
    var_23 = wp::add(var_row, var_grid__ny);
    var_24 = signs_above_0(var_23, var_w, var_grid__width, var_grid__signs);
    var_25 = wp::bit_xor(var_0, var_24);
    var_26 = wp::bit_or(var_22, var_25);
    var_27 = wp::add(var_row, var_grid__ny);
    var_29 = wp::add(var_27, var_28);
    var_30 = signs_above_0(var_29, var_w, var_grid__width, var_grid__signs);
    var_31 = wp::bit_xor(var_0, var_30);
    var_32 = wp::bit_or(var_26, var_31);
    // mixed = mixed & has_next(w, grid__nz)                                                  <L 9>
    var_33 = has_next_0(var_w, var_grid__nz);
    var_34 = wp::bit_and(var_32, var_33);
    // if grid__has_gaps[0] != 0:                                                             <L 10>
    var_36 = wp::address(var_grid__has_gaps, var_35);
    var_39 = wp::load(var_36);
    var_38 = (var_39 != var_37);
    if (var_38) {
        // mixed = mixed & grid__complete[row * grid__width + w]                              <L 11>
        var_40 = wp::mul(var_row, var_grid__width);
        var_41 = wp::add(var_40, var_w);
        var_42 = wp::address(var_grid__complete, var_41);
        var_44 = wp::load(var_42);
        var_43 = wp::bit_and(var_34, var_44);
    }
    var_45 = wp::where(var_38, var_43, var_34);
    // return mixed                                                                           <L 12>
    return var_45;
}


// <pointloom.kernels.volumes.marching_cubes.word_of>:1
static wp::vec_t<4, wp::int32> word_of_1(
    wp::int32 var_row,
    wp::int32 var_w,
    wp::int32 var_grid__width,
    wp::array_t<wp::vec_t<4, wp::int32>> var_edges__words,
    wp::array_t<wp::int32> var_edges__offsets)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32 var_1;
    wp::vec_t<4, wp::int32>* var_2;
    wp::vec_t<4, wp::int32> var_3;
    wp::vec_t<4, wp::int32> var_4;
    wp::int32* var_5;
    const wp::int32 var_6 = 0;
    wp::int32 var_7;
    wp::int32 var_8;
    wp::int32 var_9;
    const wp::int32 var_10 = 1;
    wp::int32 var_11;
    const wp::int32 var_12 = 2;
    wp::int32 var_13;
    const wp::int32 var_14 = 3;
    wp::int32 var_15;
    wp::vec_t<4, wp::int32> var_16;
    //---------
    // forward
    // def word_of(row, w, grid__width, edges__words, edges__offsets):                        <L 1>
    // word = edges__words[row * grid__width + w]                                             <L 2>
    var_0 = wp::mul(var_row, var_grid__width);
    var_1 = wp::add(var_0, var_w);
    var_2 = wp::address(var_edges__words, var_1);
    var_4 = wp::load(var_2);
    var_3 = wp::copy(var_4);
    // return vec4i(edges__offsets[row] + word[0], word[1], word[2], word[3])                 <L 3>
    var_5 = wp::address(var_edges__offsets, var_row);
    var_7 = wp::extract(var_3, var_6);
    var_9 = wp::load(var_5);
    var_8 = wp::add(var_9, var_7);
    var_11 = wp::extract(var_3, var_10);
    var_13 = wp::extract(var_3, var_12);
    var_15 = wp::extract(var_3, var_14);
    var_16 = wp::vec_t<4, wp::int32>(var_8, var_11, var_13, var_15);
    return var_16;
}


// <pointloom.kernels.volumes.marching_cubes.x_edges_above>:1
static wp::int32 x_edges_above_0(
    wp::vec_t<4, wp::int32> var_word,
    wp::int32 var_row,
    wp::int32 var_w,
    wp::int32 var_grid__width,
    wp::array_t<wp::vec_t<4, wp::int32>> var_edges__words)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    const wp::int32 var_2 = 1;
    wp::int32 var_3;
    bool var_4;
    wp::int32 var_5;
    wp::int32 var_6;
    const wp::int32 var_7 = 1;
    wp::int32 var_8;
    wp::vec_t<4, wp::int32>* var_9;
    const wp::int32 var_10 = 1;
    wp::int32 var_11;
    wp::vec_t<4, wp::int32> var_12;
    const wp::int32 var_13 = 31;
    wp::int32 var_14;
    wp::int32 var_15;
    const wp::int32 var_16 = 1;
    wp::int32 var_17;
    const wp::int32 var_18 = 1;
    wp::int32 var_19;
    const wp::int32 var_20 = 2147483647;
    wp::int32 var_21;
    wp::int32 var_22;
    //---------
    // forward
    // def x_edges_above(word, row, w, grid__width, edges__words):                            <L 1>
    // carry = int(0)                                                                         <L 3>
    var_1 = wp::int(var_0);
    // if w + 1 < grid__width:                                                                <L 4>
    var_3 = wp::add(var_w, var_2);
    var_4 = (var_3 < var_grid__width);
    if (var_4) {
        // carry = edges__words[row * grid__width + w + 1][1] << 31                           <L 5>
        var_5 = wp::mul(var_row, var_grid__width);
        var_6 = wp::add(var_5, var_w);
        var_8 = wp::add(var_6, var_7);
        var_9 = wp::address(var_edges__words, var_8);
        var_12 = wp::load(var_9);
        var_11 = wp::extract(var_12, var_10);
        var_14 = wp::lshift(var_11, var_13);
    }
    var_15 = wp::where(var_4, var_14, var_1);
    // return word[1] >> 1 & LOW_31 | carry                                                   <L 6>
    var_17 = wp::extract(var_word, var_16);
    var_19 = wp::rshift(var_17, var_18);
    var_21 = wp::bit_and(var_19, var_20);
    var_22 = wp::bit_or(var_21, var_15);
    return var_22;
}


// /work/main/src/pointloom/kernels/volumes/marching_cubes.py:338
static wp::vec_t<3, wp::int32> vertices_before_0(
    wp::vec_t<4, wp::int32> var_word,
    wp::int32 var_j)
{
    //---------
    // primal vars
    wp::int32 var_0;
    const wp::int32 var_1 = 0;
    wp::int32 var_2;
    const wp::int32 var_3 = 1;
    wp::int32 var_4;
    wp::int32 var_5;
    wp::int32 var_6;
    wp::int32 var_7;
    const wp::int32 var_8 = 2;
    wp::int32 var_9;
    wp::int32 var_10;
    wp::int32 var_11;
    wp::int32 var_12;
    const wp::int32 var_13 = 3;
    wp::int32 var_14;
    wp::int32 var_15;
    wp::int32 var_16;
    wp::int32 var_17;
    const wp::int32 var_18 = 1;
    wp::int32 var_19;
    wp::int32 var_20;
    wp::int32 var_21;
    const wp::int32 var_22 = 2;
    wp::int32 var_23;
    wp::int32 var_24;
    wp::int32 var_25;
    const wp::int32 var_26 = 3;
    wp::int32 var_27;
    wp::int32 var_28;
    wp::int32 var_29;
    wp::vec_t<3, wp::int32> var_30;
    //---------
    // forward
    // def vertices_before(word: vec4i, j: int) -> vec3i:                                     <L 339>
    // below = bits_below(j)                                                                  <L 341>
    var_0 = bits_below_0(var_j);
    // first = word[0] + bit_count(word[1] & below) + bit_count(word[2] & below) + bit_count(word[3] & below)       <L 342>
    var_2 = wp::extract(var_word, var_1);
    var_4 = wp::extract(var_word, var_3);
    var_5 = wp::bit_and(var_4, var_0);
    var_6 = wp::bit_count(var_5);
    var_7 = wp::add(var_2, var_6);
    var_9 = wp::extract(var_word, var_8);
    var_10 = wp::bit_and(var_9, var_0);
    var_11 = wp::bit_count(var_10);
    var_12 = wp::add(var_7, var_11);
    var_14 = wp::extract(var_word, var_13);
    var_15 = wp::bit_and(var_14, var_0);
    var_16 = wp::bit_count(var_15);
    var_17 = wp::add(var_12, var_16);
    // along_z = first + bit(word[1], j) + bit(word[2], j)                                    <L 343>
    var_19 = wp::extract(var_word, var_18);
    var_20 = bit_0(var_19, var_j);
    var_21 = wp::add(var_17, var_20);
    var_23 = wp::extract(var_word, var_22);
    var_24 = bit_0(var_23, var_j);
    var_25 = wp::add(var_21, var_24);
    // return vec3i(first, along_z, along_z + bit(word[3], j))                                <L 344>
    var_27 = wp::extract(var_word, var_26);
    var_28 = bit_0(var_27, var_j);
    var_29 = wp::add(var_25, var_28);
    var_30 = wp::vec_t<3, wp::int32>(var_17, var_25, var_29);
    return var_30;
}


// <pointloom.kernels.volumes.bit_rows.bits_below>:1
static void adj_bits_below_0(
    wp::int32 var_index,
    wp::int32 & adj_index,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/volumes/bit_rows.py:50
static void adj_has_next_0(
    wp::int32 var_w,
    wp::int32 var_nz,
    wp::int32 & adj_w,
    wp::int32 & adj_nz,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.bit_rows.above>:1
static void adj_above_0(
    wp::array_t<wp::int32> var_words,
    wp::int32 var_row,
    wp::int32 var_w,
    wp::int32 var_width,
    wp::array_t<wp::int32> & adj_words,
    wp::int32 & adj_row,
    wp::int32 & adj_w,
    wp::int32 & adj_width,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.marching_cubes.finite_pairs>:1
static void adj_finite_pairs_0(
    wp::int32 var_row,
    wp::int32 var_w,
    wp::int32 var_grid__width,
    wp::array_t<wp::int32> var_grid__finite,
    wp::int32 & adj_row,
    wp::int32 & adj_w,
    wp::int32 & adj_grid__width,
    wp::array_t<wp::int32> & adj_grid__finite,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.bit_rows.lowest_bit>:1
static void adj_lowest_bit_1(
    wp::int32 var_word,
    wp::int32 & adj_word,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/volumes/bit_rows.py:26
static void adj_bit_0(
    wp::int32 var_word,
    wp::int32 var_index,
    wp::int32 & adj_word,
    wp::int32 & adj_index,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/volumes/marching_cubes.py:286
static void adj_crossing_fraction_0(
    wp::float32 var_a,
    wp::float32 var_b,
    wp::float32 var_level,
    wp::float32 & adj_a,
    wp::float32 & adj_b,
    wp::float32 & adj_level,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.marching_cubes.sign_word>:1
static void adj_sign_word_0(
    wp::int32 var_row,
    wp::int32 var_w,
    wp::int32 var_grid__width,
    wp::array_t<wp::int32> var_grid__signs,
    wp::int32 & adj_row,
    wp::int32 & adj_w,
    wp::int32 & adj_grid__width,
    wp::array_t<wp::int32> & adj_grid__signs,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.marching_cubes.signs_above>:1
static void adj_signs_above_0(
    wp::int32 var_row,
    wp::int32 var_w,
    wp::int32 var_grid__width,
    wp::array_t<wp::int32> var_grid__signs,
    wp::int32 & adj_row,
    wp::int32 & adj_w,
    wp::int32 & adj_grid__width,
    wp::array_t<wp::int32> & adj_grid__signs,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.bit_rows.with_below>:1
static void adj_with_below_0(
    wp::array_t<wp::int32> var_words,
    wp::int32 var_row,
    wp::int32 var_w,
    wp::int32 var_width,
    wp::array_t<wp::int32> & adj_words,
    wp::int32 & adj_row,
    wp::int32 & adj_w,
    wp::int32 & adj_width,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.marching_cubes.crossing_edges>:1
static void adj_crossing_edges_0(
    wp::int32 var_row,
    wp::int32 var_w,
    wp::int32 var_grid__width,
    wp::int32 var_grid__rows,
    wp::int32 var_grid__ny,
    wp::int32 var_grid__nz,
    wp::array_t<wp::int32> var_grid__signs,
    wp::array_t<wp::int32> var_grid__complete,
    wp::array_t<wp::int32> var_grid__has_gaps,
    wp::int32 & adj_row,
    wp::int32 & adj_w,
    wp::int32 & adj_grid__width,
    wp::int32 & adj_grid__rows,
    wp::int32 & adj_grid__ny,
    wp::int32 & adj_grid__nz,
    wp::array_t<wp::int32> & adj_grid__signs,
    wp::array_t<wp::int32> & adj_grid__complete,
    wp::array_t<wp::int32> & adj_grid__has_gaps,
    wp::vec_t<4, wp::int32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.marching_cubes.surface_cells>:1
static void adj_surface_cells_0(
    wp::int32 var_row,
    wp::int32 var_w,
    wp::int32 var_grid__width,
    wp::int32 var_grid__ny,
    wp::int32 var_grid__nz,
    wp::array_t<wp::int32> var_grid__signs,
    wp::array_t<wp::int32> var_grid__complete,
    wp::array_t<wp::int32> var_grid__has_gaps,
    wp::int32 & adj_row,
    wp::int32 & adj_w,
    wp::int32 & adj_grid__width,
    wp::int32 & adj_grid__ny,
    wp::int32 & adj_grid__nz,
    wp::array_t<wp::int32> & adj_grid__signs,
    wp::array_t<wp::int32> & adj_grid__complete,
    wp::array_t<wp::int32> & adj_grid__has_gaps,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.marching_cubes.word_of>:1
static void adj_word_of_1(
    wp::int32 var_row,
    wp::int32 var_w,
    wp::int32 var_grid__width,
    wp::array_t<wp::vec_t<4, wp::int32>> var_edges__words,
    wp::array_t<wp::int32> var_edges__offsets,
    wp::int32 & adj_row,
    wp::int32 & adj_w,
    wp::int32 & adj_grid__width,
    wp::array_t<wp::vec_t<4, wp::int32>> & adj_edges__words,
    wp::array_t<wp::int32> & adj_edges__offsets,
    wp::vec_t<4, wp::int32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.marching_cubes.x_edges_above>:1
static void adj_x_edges_above_0(
    wp::vec_t<4, wp::int32> var_word,
    wp::int32 var_row,
    wp::int32 var_w,
    wp::int32 var_grid__width,
    wp::array_t<wp::vec_t<4, wp::int32>> var_edges__words,
    wp::vec_t<4, wp::int32> & adj_word,
    wp::int32 & adj_row,
    wp::int32 & adj_w,
    wp::int32 & adj_grid__width,
    wp::array_t<wp::vec_t<4, wp::int32>> & adj_edges__words,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/volumes/marching_cubes.py:338
static void adj_vertices_before_0(
    wp::vec_t<4, wp::int32> var_word,
    wp::int32 var_j,
    wp::vec_t<4, wp::int32> & adj_word,
    wp::int32 & adj_j,
    wp::vec_t<3, wp::int32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}

struct wp_args_find_complete_cells_kernel_0a718271 {
    wp::int32 grid__width;
    wp::int32 grid__rows;
    wp::int32 grid__ny;
    wp::int32 grid__nz;
    wp::array_t<wp::int32> grid__finite;
    wp::array_t<wp::int32> grid__complete;
    wp::array_t<wp::int32> grid__has_gaps;
};


template <bool wp_linear_contiguous>
static void find_complete_cells_kernel_0a718271_cpu_kernel_forward(
    wp::launch_bounds_t<1> dim,
    size_t task_index,
    wp_args_find_complete_cells_kernel_0a718271 *_wp_args)
{
    static constexpr bool wp_linear_tid = wp_linear_contiguous;
    wp_args_find_complete_cells_kernel_0a718271 wp_contiguous_args;
    if constexpr (wp_linear_contiguous)
    {
        wp_contiguous_args = *_wp_args;
        wp_contiguous_args.grid__finite.strides[0] = sizeof(wp::int32);
        wp_contiguous_args.grid__complete.strides[0] = sizeof(wp::int32);
        wp_contiguous_args.grid__has_gaps.strides[0] = sizeof(wp::int32);
        _wp_args = &wp_contiguous_args;
    }
    //---------
    // argument vars
    wp::int32 var_grid__width = _wp_args->grid__width;
    wp::int32 var_grid__rows = _wp_args->grid__rows;
    wp::int32 var_grid__ny = _wp_args->grid__ny;
    wp::int32 var_grid__nz = _wp_args->grid__nz;
    wp::array_t<wp::int32> var_grid__finite = _wp_args->grid__finite;
    wp::array_t<wp::int32> var_grid__complete = _wp_args->grid__complete;
    wp::array_t<wp::int32> var_grid__has_gaps = _wp_args->grid__has_gaps;
    //---------
    // primal vars
    wp::int32 var_0;
    const wp::int32 var_1 = 0;
    wp::int32* var_2;
    const wp::int32 var_3 = 0;
    bool var_4;
    wp::int32 var_5;
    wp::int32 var_6;
    wp::range_t var_7;
    wp::int32 var_8;
    const wp::int32 var_9 = 0;
    wp::int32 var_10;
    bool var_11;
    const wp::int32 var_12 = 1;
    wp::int32 var_13;
    bool var_14;
    wp::int32 var_15;
    bool var_16;
    wp::int32 var_17;
    wp::int32 var_18;
    wp::int32 var_19;
    const wp::int32 var_20 = 1;
    wp::int32 var_21;
    wp::int32 var_22;
    wp::int32 var_23;
    wp::int32 var_24;
    wp::int32 var_25;
    wp::int32 var_26;
    wp::int32 var_27;
    const wp::int32 var_28 = 1;
    wp::int32 var_29;
    wp::int32 var_30;
    wp::int32 var_31;
    wp::int32 var_32;
    wp::int32 var_33;
    wp::int32 var_34;
    //---------
    // forward
    // def find_complete_cells_kernel(grid__width, grid__rows, grid__ny, grid__nz, grid__finite, grid__complete, grid__has_gaps):       <L 1>
    // i = tid()                                                                              <L 3>
    var_0 = builtin_tid1d();
    // if grid__has_gaps[0] == 0:                                                             <L 4>
    var_2 = wp::address(var_grid__has_gaps, var_1);
    var_5 = wp::load(var_2);
    var_4 = (var_5 == var_3);
    if (var_4) {
        // return                                                                             <L 5>
        return;
    }
    // y = i % grid__ny                                                                       <L 6>
    var_6 = wp::mod(var_0, var_grid__ny);
    // for w in range(grid__width):                                                           <L 7>
    var_7 = wp::range(var_grid__width);
    start_for_1:;
        if (iter_cmp(var_7) == 0) goto end_for_1;
        var_8 = wp::iter_next(var_7);
        // cells = int(0)                                                                     <L 8>
        var_10 = wp::int(var_9);
        // if y + 1 < grid__ny and i + grid__ny < grid__rows:                                 <L 9>
        var_13 = wp::add(var_6, var_12);
        var_14 = (var_13 < var_grid__ny);
        var_11 = var_14;
        if (var_11) {
            var_15 = wp::add(var_0, var_grid__ny);
            var_16 = (var_15 < var_grid__rows);
            var_11 = var_11 && var_16;
        }
        if (var_11) {
            // cells = has_next(w, grid__nz) & finite_pairs(i, w, grid__width, grid__finite) & finite_pairs(i + 1, w, grid__width, grid__finite)       <L 10>
            var_17 = has_next_0(var_8, var_grid__nz);
            var_18 = finite_pairs_0(var_0, var_8, var_grid__width, var_grid__finite);
            var_19 = wp::bit_and(var_17, var_18);
            var_21 = wp::add(var_0, var_20);
            var_22 = finite_pairs_0(var_21, var_8, var_grid__width, var_grid__finite);
            var_23 = wp::bit_and(var_19, var_22);
            // cells = cells & finite_pairs(i + grid__ny, w, grid__width, grid__finite) & finite_pairs(i + grid__ny + 1, w, grid__width, grid__finite)       <L 11>
            var_24 = wp::add(var_0, var_grid__ny);
            var_25 = finite_pairs_0(var_24, var_8, var_grid__width, var_grid__finite);
            var_26 = wp::bit_and(var_23, var_25);
            var_27 = wp::add(var_0, var_grid__ny);
            var_29 = wp::add(var_27, var_28);
            var_30 = finite_pairs_0(var_29, var_8, var_grid__width, var_grid__finite);
            var_31 = wp::bit_and(var_26, var_30);
        }
        var_32 = wp::where(var_11, var_31, var_10);
        // grid__complete[i * grid__width + w] = cells                                        <L 12>
        var_33 = wp::mul(var_0, var_grid__width);
        var_34 = wp::add(var_33, var_8);
        wp::array_store(var_grid__complete, var_34, var_32);
        goto start_for_1;
    end_for_1:;
}



template <bool wp_linear_contiguous>
static WP_FORCEINLINE void find_complete_cells_kernel_0a718271_cpu_forward_tasks(
    wp::launch_bounds_t<1> *dim,
    wp_args_find_complete_cells_kernel_0a718271 *_wp_args)
{
    for (size_t task_index = 0; task_index < dim->size; ++task_index)
    {
        find_complete_cells_kernel_0a718271_cpu_kernel_forward<wp_linear_contiguous>(*dim, task_index, _wp_args);
    }
}

static WP_FORCEINLINE void find_complete_cells_kernel_0a718271_cpu_forward_dispatch(
    wp::launch_bounds_t<1> *dim,
    wp_args_find_complete_cells_kernel_0a718271 *_wp_args)
{
    wp::tile_shared_storage_t tile_mem;
#if defined(WP_ENABLE_TILES_IN_STACK_MEMORY)
    wp::shared_tile_storage = &tile_mem;
#endif

    const bool wp_linear_contiguous = dim->coord_mult == 1 && ((_wp_args->grid__finite.strides[0] == (int)sizeof(wp::int32)) & (_wp_args->grid__complete.strides[0] == (int)sizeof(wp::int32)) & (_wp_args->grid__has_gaps.strides[0] == (int)sizeof(wp::int32)));
    if (wp_linear_contiguous)
        find_complete_cells_kernel_0a718271_cpu_forward_tasks<true>(dim, _wp_args);
    else
        find_complete_cells_kernel_0a718271_cpu_forward_tasks<false>(dim, _wp_args);
}

extern "C" {

// Python CPU entry points
WP_API void find_complete_cells_kernel_0a718271_cpu_forward(
    wp::launch_bounds_t<1> *dim,
    wp_args_find_complete_cells_kernel_0a718271 *_wp_args)
{
    find_complete_cells_kernel_0a718271_cpu_forward_dispatch(dim, _wp_args);
}

} // extern C

struct wp_args_write_vertices_kernel_50ecb438 {
    wp::array_t<wp::float32> field__values;
    wp::int32 field__ny;
    wp::float32 field__level;
    wp::vec_t<3, wp::float32> field__origin;
    wp::vec_t<3, wp::float32> field__spacing;
    wp::int32 grid__width;
    wp::array_t<wp::vec_t<4, wp::int32>> edges__words;
    wp::array_t<wp::int32> edges__offsets;
    wp::array_t<wp::vec_t<3, wp::float32>> vertices;
};


template <bool wp_linear_contiguous>
static void write_vertices_kernel_50ecb438_cpu_kernel_forward(
    wp::launch_bounds_t<1> dim,
    size_t task_index,
    wp_args_write_vertices_kernel_50ecb438 *_wp_args)
{
    static constexpr bool wp_linear_tid = wp_linear_contiguous;

    //---------
    // argument vars
    wp::array_t<wp::float32> var_field__values = _wp_args->field__values;
    wp::int32 var_field__ny = _wp_args->field__ny;
    wp::float32 var_field__level = _wp_args->field__level;
    wp::vec_t<3, wp::float32> var_field__origin = _wp_args->field__origin;
    wp::vec_t<3, wp::float32> var_field__spacing = _wp_args->field__spacing;
    wp::int32 var_grid__width = _wp_args->grid__width;
    wp::array_t<wp::vec_t<4, wp::int32>> var_edges__words = _wp_args->edges__words;
    wp::array_t<wp::int32> var_edges__offsets = _wp_args->edges__offsets;
    wp::array_t<wp::vec_t<3, wp::float32>> var_vertices = _wp_args->vertices;
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32* var_1;
    wp::int32 var_2;
    wp::int32 var_3;
    const wp::int32 var_4 = 1;
    wp::int32 var_5;
    wp::int32* var_6;
    bool var_7;
    wp::int32 var_8;
    const wp::int32 var_9 = 0;
    wp::float32 var_10;
    const wp::int32 var_11 = 0;
    wp::float32 var_12;
    wp::int32 var_13;
    wp::float32 var_14;
    wp::float32 var_15;
    wp::float32 var_16;
    const wp::int32 var_17 = 1;
    wp::float32 var_18;
    const wp::int32 var_19 = 1;
    wp::float32 var_20;
    wp::int32 var_21;
    wp::float32 var_22;
    wp::float32 var_23;
    wp::float32 var_24;
    wp::range_t var_25;
    wp::int32 var_26;
    wp::int32 var_27;
    wp::int32 var_28;
    wp::vec_t<4, wp::int32>* var_29;
    wp::vec_t<4, wp::int32> var_30;
    wp::vec_t<4, wp::int32> var_31;
    const wp::int32 var_32 = 1;
    wp::int32 var_33;
    const wp::int32 var_34 = 2;
    wp::int32 var_35;
    wp::int32 var_36;
    const wp::int32 var_37 = 3;
    wp::int32 var_38;
    wp::int32 var_39;
    const wp::int32 var_40 = 0;
    bool var_41;
    wp::int32 var_42;
    const wp::int32 var_43 = 1;
    wp::int32 var_44;
    wp::int32 var_45;
    const wp::int32 var_46 = 32;
    wp::int32 var_47;
    wp::int32 var_48;
    const wp::int32 var_49 = 2;
    wp::float32 var_50;
    const wp::int32 var_51 = 2;
    wp::float32 var_52;
    wp::float32 var_53;
    wp::float32 var_54;
    wp::float32 var_55;
    wp::float32* var_56;
    wp::float32 var_57;
    wp::float32 var_58;
    const wp::int32 var_59 = 1;
    wp::int32 var_60;
    wp::int32 var_61;
    const wp::int32 var_62 = 1;
    bool var_63;
    wp::int32 var_64;
    wp::float32* var_65;
    wp::float32 var_66;
    wp::float32 var_67;
    const wp::int32 var_68 = 0;
    wp::float32 var_69;
    wp::float32 var_70;
    wp::float32 var_71;
    wp::vec_t<3, wp::float32> var_72;
    const wp::int32 var_73 = 1;
    wp::int32 var_74;
    wp::int32 var_75;
    const wp::int32 var_76 = 2;
    wp::int32 var_77;
    wp::int32 var_78;
    const wp::int32 var_79 = 1;
    bool var_80;
    const wp::int32 var_81 = 1;
    wp::int32 var_82;
    wp::float32* var_83;
    wp::float32 var_84;
    wp::float32 var_85;
    const wp::int32 var_86 = 1;
    wp::float32 var_87;
    wp::float32 var_88;
    wp::float32 var_89;
    wp::vec_t<3, wp::float32> var_90;
    const wp::int32 var_91 = 1;
    wp::int32 var_92;
    wp::int32 var_93;
    wp::float32 var_94;
    const wp::int32 var_95 = 3;
    wp::int32 var_96;
    wp::int32 var_97;
    const wp::int32 var_98 = 1;
    bool var_99;
    const wp::int32 var_100 = 1;
    wp::int32 var_101;
    wp::float32* var_102;
    wp::float32 var_103;
    wp::float32 var_104;
    const wp::int32 var_105 = 2;
    wp::float32 var_106;
    wp::float32 var_107;
    wp::float32 var_108;
    wp::vec_t<3, wp::float32> var_109;
    const wp::int32 var_110 = 1;
    wp::int32 var_111;
    wp::int32 var_112;
    wp::float32 var_113;
    //---------
    // forward
    // def write_vertices_kernel(field__values, field__ny, field__level, field__origin, field__spacing, grid__width, edges__words, edges__offsets, vertices):       <L 1>
    // i = tid()                                                                              <L 2>
    var_0 = builtin_tid1d();
    // n = edges__offsets[i]                                                                  <L 3>
    var_1 = wp::address(var_edges__offsets, var_0);
    var_3 = wp::load(var_1);
    var_2 = wp::copy(var_3);
    // if edges__offsets[i + 1] == n:                                                         <L 4>
    var_5 = wp::add(var_0, var_4);
    var_6 = wp::address(var_edges__offsets, var_5);
    var_8 = wp::load(var_6);
    var_7 = (var_8 == var_2);
    if (var_7) {
        // return                                                                             <L 5>
        return;
    }
    // x = field__origin[0] + field__spacing[0] * float(i // field__ny)                       <L 6>
    var_10 = wp::extract(var_field__origin, var_9);
    var_12 = wp::extract(var_field__spacing, var_11);
    var_13 = wp::floordiv(var_0, var_field__ny);
    var_14 = wp::float(var_13);
    var_15 = wp::mul(var_12, var_14);
    var_16 = wp::add(var_10, var_15);
    // y = field__origin[1] + field__spacing[1] * float(i % field__ny)                        <L 7>
    var_18 = wp::extract(var_field__origin, var_17);
    var_20 = wp::extract(var_field__spacing, var_19);
    var_21 = wp::mod(var_0, var_field__ny);
    var_22 = wp::float(var_21);
    var_23 = wp::mul(var_20, var_22);
    var_24 = wp::add(var_18, var_23);
    // for w in range(grid__width):                                                           <L 8>
    var_25 = wp::range(var_grid__width);
    start_for_1:;
        if (iter_cmp(var_25) == 0) goto end_for_1;
        var_26 = wp::iter_next(var_25);
        // crossing = edges__words[i * grid__width + w]                                       <L 9>
        var_27 = wp::mul(var_0, var_grid__width);
        var_28 = wp::add(var_27, var_26);
        var_29 = wp::address(var_edges__words, var_28);
        var_31 = wp::load(var_29);
        var_30 = wp::copy(var_31);
        // left = crossing[1] | crossing[2] | crossing[3]                                     <L 10>
        var_33 = wp::extract(var_30, var_32);
        var_35 = wp::extract(var_30, var_34);
        var_36 = wp::bit_or(var_33, var_35);
        var_38 = wp::extract(var_30, var_37);
        var_39 = wp::bit_or(var_36, var_38);
        // while left != 0:                                                                   <L 11>
    start_while_3:;
        var_41 = (var_39 != var_40);
    if ((var_41) == false) goto end_while_3;
            // j = lowest_bit(left)                                                           <L 12>
            var_42 = lowest_bit_1(var_39);
            // left = left ^ 1 << j                                                           <L 13>
            var_44 = wp::lshift(var_43, var_42);
            var_45 = wp::bit_xor(var_39, var_44);
            // k = w * WORD + j                                                               <L 14>
            var_47 = wp::mul(var_26, var_46);
            var_48 = wp::add(var_47, var_42);
            // z = field__origin[2] + field__spacing[2] * float(k)                            <L 15>
            var_50 = wp::extract(var_field__origin, var_49);
            var_52 = wp::extract(var_field__spacing, var_51);
            var_53 = wp::float(var_48);
            var_54 = wp::mul(var_52, var_53);
            var_55 = wp::add(var_50, var_54);
            // a = field__values[i, k]                                                        <L 16>
            var_56 = wp::address(var_field__values, var_0, var_48);
            var_58 = wp::load(var_56);
            var_57 = wp::copy(var_58);
            // if bit(crossing[1], j) == 1:                                                   <L 17>
            var_60 = wp::extract(var_30, var_59);
            var_61 = bit_0(var_60, var_42);
            var_63 = (var_61 == var_62);
            if (var_63) {
                // share = crossing_fraction(a, field__values[i + field__ny, k], field__level)       <L 18>
                var_64 = wp::add(var_0, var_field__ny);
                var_65 = wp::address(var_field__values, var_64, var_48);
                var_67 = wp::load(var_65);
                var_66 = crossing_fraction_0(var_57, var_67, var_field__level);
                // vertices[n] = vec3(x + field__spacing[0] * share, y, z)                    <L 19>
                var_69 = wp::extract(var_field__spacing, var_68);
                var_70 = wp::mul(var_69, var_66);
                var_71 = wp::add(var_16, var_70);
                var_72 = wp::vec_t<3, wp::float32>(var_71, var_24, var_55);
                wp::array_store(var_vertices, var_2, var_72);
                // n += 1                                                                     <L 20>
                var_74 = wp::add(var_2, var_73);
            }
            var_75 = wp::where(var_63, var_74, var_2);
            // if bit(crossing[2], j) == 1:                                                   <L 21>
            var_77 = wp::extract(var_30, var_76);
            var_78 = bit_0(var_77, var_42);
            var_80 = (var_78 == var_79);
            if (var_80) {
                // share = crossing_fraction(a, field__values[i + 1, k], field__level)        <L 22>
                var_82 = wp::add(var_0, var_81);
                var_83 = wp::address(var_field__values, var_82, var_48);
                var_85 = wp::load(var_83);
                var_84 = crossing_fraction_0(var_57, var_85, var_field__level);
                // vertices[n] = vec3(x, y + field__spacing[1] * share, z)                    <L 23>
                var_87 = wp::extract(var_field__spacing, var_86);
                var_88 = wp::mul(var_87, var_84);
                var_89 = wp::add(var_24, var_88);
                var_90 = wp::vec_t<3, wp::float32>(var_16, var_89, var_55);
                wp::array_store(var_vertices, var_75, var_90);
                // n += 1                                                                     <L 24>
                var_92 = wp::add(var_75, var_91);
            }
            var_93 = wp::where(var_80, var_92, var_75);
            var_94 = wp::where(var_80, var_84, var_66);
            // if bit(crossing[3], j) == 1:                                                   <L 25>
            var_96 = wp::extract(var_30, var_95);
            var_97 = bit_0(var_96, var_42);
            var_99 = (var_97 == var_98);
            if (var_99) {
                // share = crossing_fraction(a, field__values[i, k + 1], field__level)        <L 26>
                var_101 = wp::add(var_48, var_100);
                var_102 = wp::address(var_field__values, var_0, var_101);
                var_104 = wp::load(var_102);
                var_103 = crossing_fraction_0(var_57, var_104, var_field__level);
                // vertices[n] = vec3(x, y, z + field__spacing[2] * share)                    <L 27>
                var_106 = wp::extract(var_field__spacing, var_105);
                var_107 = wp::mul(var_106, var_103);
                var_108 = wp::add(var_55, var_107);
                var_109 = wp::vec_t<3, wp::float32>(var_16, var_24, var_108);
                wp::array_store(var_vertices, var_93, var_109);
                // n += 1                                                                     <L 28>
                var_111 = wp::add(var_93, var_110);
            }
            var_112 = wp::where(var_99, var_111, var_93);
            var_113 = wp::where(var_99, var_103, var_94);
            wp::assign(var_2, var_112);
            wp::assign(var_39, var_45);
    goto start_while_3;
    end_while_3:;
        goto start_for_1;
    end_for_1:;
}



template <bool wp_linear_contiguous>
static WP_FORCEINLINE void write_vertices_kernel_50ecb438_cpu_forward_tasks(
    wp::launch_bounds_t<1> *dim,
    wp_args_write_vertices_kernel_50ecb438 *_wp_args)
{
    for (size_t task_index = 0; task_index < dim->size; ++task_index)
    {
        write_vertices_kernel_50ecb438_cpu_kernel_forward<wp_linear_contiguous>(*dim, task_index, _wp_args);
    }
}

static WP_FORCEINLINE void write_vertices_kernel_50ecb438_cpu_forward_dispatch(
    wp::launch_bounds_t<1> *dim,
    wp_args_write_vertices_kernel_50ecb438 *_wp_args)
{
    wp::tile_shared_storage_t tile_mem;
#if defined(WP_ENABLE_TILES_IN_STACK_MEMORY)
    wp::shared_tile_storage = &tile_mem;
#endif

    write_vertices_kernel_50ecb438_cpu_forward_tasks<false>(dim, _wp_args);
}

extern "C" {

// Python CPU entry points
WP_API void write_vertices_kernel_50ecb438_cpu_forward(
    wp::launch_bounds_t<1> *dim,
    wp_args_write_vertices_kernel_50ecb438 *_wp_args)
{
    write_vertices_kernel_50ecb438_cpu_forward_dispatch(dim, _wp_args);
}

} // extern C

struct wp_args_count_surface_kernel_bc69cd89 {
    wp::int32 grid__width;
    wp::int32 grid__rows;
    wp::int32 grid__ny;
    wp::int32 grid__nz;
    wp::array_t<wp::int32> grid__signs;
    wp::array_t<wp::int32> grid__complete;
    wp::array_t<wp::int32> grid__has_gaps;
    wp::array_t<wp::int32> tables__triangle_count;
    wp::array_t<wp::vec_t<4, wp::int32>> edges__words;
    wp::array_t<wp::int32> counts;
};


template <bool wp_linear_contiguous>
static void count_surface_kernel_bc69cd89_cpu_kernel_forward(
    wp::launch_bounds_t<1> dim,
    size_t task_index,
    wp_args_count_surface_kernel_bc69cd89 *_wp_args)
{
    static constexpr bool wp_linear_tid = wp_linear_contiguous;
    wp_args_count_surface_kernel_bc69cd89 wp_contiguous_args;
    if constexpr (wp_linear_contiguous)
    {
        wp_contiguous_args = *_wp_args;
        wp_contiguous_args.grid__signs.strides[0] = sizeof(wp::int32);
        wp_contiguous_args.grid__complete.strides[0] = sizeof(wp::int32);
        wp_contiguous_args.grid__has_gaps.strides[0] = sizeof(wp::int32);
        wp_contiguous_args.tables__triangle_count.strides[0] = sizeof(wp::int32);
        wp_contiguous_args.edges__words.strides[0] = sizeof(wp::vec_t<4, wp::int32>);
        wp_contiguous_args.counts.strides[0] = sizeof(wp::int32);
        _wp_args = &wp_contiguous_args;
    }
    //---------
    // argument vars
    wp::int32 var_grid__width = _wp_args->grid__width;
    wp::int32 var_grid__rows = _wp_args->grid__rows;
    wp::int32 var_grid__ny = _wp_args->grid__ny;
    wp::int32 var_grid__nz = _wp_args->grid__nz;
    wp::array_t<wp::int32> var_grid__signs = _wp_args->grid__signs;
    wp::array_t<wp::int32> var_grid__complete = _wp_args->grid__complete;
    wp::array_t<wp::int32> var_grid__has_gaps = _wp_args->grid__has_gaps;
    wp::array_t<wp::int32> var_tables__triangle_count = _wp_args->tables__triangle_count;
    wp::array_t<wp::vec_t<4, wp::int32>> var_edges__words = _wp_args->edges__words;
    wp::array_t<wp::int32> var_counts = _wp_args->counts;
    //---------
    // primal vars
    wp::int32 var_0;
    const wp::int32 var_1 = 0;
    wp::int32 var_2;
    const wp::int32 var_3 = 0;
    wp::int32 var_4;
    const wp::int32 var_5 = 0;
    wp::int32 var_6;
    bool var_7;
    wp::int32 var_8;
    const wp::int32 var_9 = 1;
    wp::int32 var_10;
    bool var_11;
    wp::int32 var_12;
    bool var_13;
    const wp::int32 var_14 = 1;
    wp::int32 var_15;
    wp::range_t var_16;
    wp::int32 var_17;
    wp::vec_t<4, wp::int32> var_18;
    const wp::int32 var_19 = 0;
    wp::int32 var_20;
    const wp::int32 var_21 = 1;
    bool var_22;
    wp::int32 var_23;
    wp::int32 var_24;
    const wp::int32 var_25 = 1;
    wp::int32 var_26;
    const wp::int32 var_27 = 2;
    wp::int32 var_28;
    const wp::int32 var_29 = 3;
    wp::int32 var_30;
    wp::vec_t<4, wp::int32> var_31;
    wp::int32 var_32;
    wp::int32 var_33;
    const wp::int32 var_34 = 1;
    wp::int32 var_35;
    wp::int32 var_36;
    const wp::int32 var_37 = 2;
    wp::int32 var_38;
    wp::int32 var_39;
    wp::int32 var_40;
    const wp::int32 var_41 = 3;
    wp::int32 var_42;
    wp::int32 var_43;
    wp::int32 var_44;
    wp::int32 var_45;
    wp::int32 var_46;
    const wp::int32 var_47 = 0;
    wp::int32 var_48;
    const wp::int32 var_49 = 0;
    wp::int32 var_50;
    const wp::int32 var_51 = 0;
    wp::int32 var_52;
    const wp::int32 var_53 = 0;
    wp::int32 var_54;
    const wp::int32 var_55 = 0;
    wp::int32 var_56;
    const wp::int32 var_57 = 0;
    wp::int32 var_58;
    const wp::int32 var_59 = 0;
    wp::int32 var_60;
    const wp::int32 var_61 = 0;
    wp::int32 var_62;
    const wp::int32 var_63 = 0;
    bool var_64;
    wp::int32 var_65;
    wp::int32 var_66;
    wp::int32 var_67;
    const wp::int32 var_68 = 1;
    wp::int32 var_69;
    wp::int32 var_70;
    wp::int32 var_71;
    const wp::int32 var_72 = 1;
    wp::int32 var_73;
    wp::int32 var_74;
    wp::int32 var_75;
    wp::int32 var_76;
    wp::int32 var_77;
    const wp::int32 var_78 = 1;
    wp::int32 var_79;
    wp::int32 var_80;
    wp::int32 var_81;
    const wp::int32 var_82 = 1;
    wp::int32 var_83;
    wp::int32 var_84;
    wp::int32 var_85;
    wp::int32 var_86;
    wp::int32 var_87;
    wp::int32 var_88;
    wp::int32 var_89;
    wp::int32 var_90;
    wp::int32 var_91;
    wp::int32 var_92;
    const wp::int32 var_93 = 0;
    bool var_94;
    wp::int32 var_95;
    const wp::int32 var_96 = 1;
    wp::int32 var_97;
    wp::int32 var_98;
    wp::int32 var_99;
    wp::int32 var_100;
    const wp::int32 var_101 = 1;
    wp::int32 var_102;
    wp::int32 var_103;
    wp::int32 var_104;
    const wp::int32 var_105 = 2;
    wp::int32 var_106;
    wp::int32 var_107;
    wp::int32 var_108;
    const wp::int32 var_109 = 3;
    wp::int32 var_110;
    wp::int32 var_111;
    wp::int32 var_112;
    wp::int32 var_113;
    const wp::int32 var_114 = 1;
    wp::int32 var_115;
    wp::int32 var_116;
    wp::int32 var_117;
    const wp::int32 var_118 = 2;
    wp::int32 var_119;
    wp::int32 var_120;
    wp::int32 var_121;
    const wp::int32 var_122 = 3;
    wp::int32 var_123;
    wp::int32 var_124;
    const wp::int32 var_125 = 4;
    wp::int32 var_126;
    wp::int32 var_127;
    wp::int32* var_128;
    wp::int32 var_129;
    wp::int32 var_130;
    wp::int32 var_131;
    //---------
    // forward
    // def count_surface_kernel(grid__width, grid__rows, grid__ny, grid__nz, grid__signs, grid__complete, grid__has_gaps, tables__triangle_count, edges__words, counts):       <L 1>
    // i = tid()                                                                              <L 3>
    var_0 = builtin_tid1d();
    // vertices = int(0)                                                                      <L 4>
    var_2 = wp::int(var_1);
    // triangles = int(0)                                                                     <L 5>
    var_4 = wp::int(var_3);
    // has_cells = int(0)                                                                     <L 6>
    var_6 = wp::int(var_5);
    // if i % grid__ny + 1 < grid__ny and i + grid__ny < grid__rows:                          <L 7>
    var_8 = wp::mod(var_0, var_grid__ny);
    var_10 = wp::add(var_8, var_9);
    var_11 = (var_10 < var_grid__ny);
    var_7 = var_11;
    if (var_7) {
        var_12 = wp::add(var_0, var_grid__ny);
        var_13 = (var_12 < var_grid__rows);
        var_7 = var_7 && var_13;
    }
    if (var_7) {
        // has_cells = 1                                                                      <L 8>
    }
    var_15 = wp::where(var_7, var_14, var_6);
    // for w in range(grid__width):                                                           <L 9>
    var_16 = wp::range(var_grid__width);
    start_for_0:;
        if (iter_cmp(var_16) == 0) goto end_for_0;
        var_17 = wp::iter_next(var_16);
        // crossing = crossing_edges(i, w, grid__width, grid__rows, grid__ny, grid__nz, grid__signs, grid__complete, grid__has_gaps)       <L 10>
        var_18 = crossing_edges_0(var_0, var_17, var_grid__width, var_grid__rows, var_grid__ny, var_grid__nz, var_grid__signs, var_grid__complete, var_grid__has_gaps);
        // cells = int(0)                                                                     <L 11>
        var_20 = wp::int(var_19);
        // if has_cells == 1:                                                                 <L 12>
        var_22 = (var_15 == var_21);
        if (var_22) {
            // cells = surface_cells(i, w, grid__width, grid__ny, grid__nz, grid__signs, grid__complete, grid__has_gaps)       <L 13>
            var_23 = surface_cells_0(var_0, var_17, var_grid__width, var_grid__ny, var_grid__nz, var_grid__signs, var_grid__complete, var_grid__has_gaps);
        }
        var_24 = wp::where(var_22, var_23, var_20);
        // edges__words[i * grid__width + w] = vec4i(vertices, crossing[1], crossing[2], crossing[3])       <L 14>
        var_26 = wp::extract(var_18, var_25);
        var_28 = wp::extract(var_18, var_27);
        var_30 = wp::extract(var_18, var_29);
        var_31 = wp::vec_t<4, wp::int32>(var_2, var_26, var_28, var_30);
        var_32 = wp::mul(var_0, var_grid__width);
        var_33 = wp::add(var_32, var_17);
        wp::array_store(var_edges__words, var_33, var_31);
        // vertices += bit_count(crossing[1]) + bit_count(crossing[2]) + bit_count(crossing[3])       <L 15>
        var_35 = wp::extract(var_18, var_34);
        var_36 = wp::bit_count(var_35);
        var_38 = wp::extract(var_18, var_37);
        var_39 = wp::bit_count(var_38);
        var_40 = wp::add(var_36, var_39);
        var_42 = wp::extract(var_18, var_41);
        var_43 = wp::bit_count(var_42);
        var_44 = wp::add(var_40, var_43);
        var_45 = wp::add(var_2, var_44);
        // left__surface_cases__1 = cells                                                     <L 16>
        var_46 = wp::copy(var_24);
        // a__surface_cases__1 = int(0)                                                       <L 17>
        var_48 = wp::int(var_47);
        // b__surface_cases__1 = int(0)                                                       <L 18>
        var_50 = wp::int(var_49);
        // c__surface_cases__1 = int(0)                                                       <L 19>
        var_52 = wp::int(var_51);
        // d__surface_cases__1 = int(0)                                                       <L 20>
        var_54 = wp::int(var_53);
        // e__surface_cases__1 = int(0)                                                       <L 21>
        var_56 = wp::int(var_55);
        // f__surface_cases__1 = int(0)                                                       <L 22>
        var_58 = wp::int(var_57);
        // g__surface_cases__1 = int(0)                                                       <L 23>
        var_60 = wp::int(var_59);
        // h__surface_cases__1 = int(0)                                                       <L 24>
        var_62 = wp::int(var_61);
        // if left__surface_cases__1 != 0:                                                    <L 25>
        var_64 = (var_46 != var_63);
        if (var_64) {
            // a__surface_cases__1 = sign_word(i, w, grid__width, grid__signs)                <L 26>
            var_65 = sign_word_0(var_0, var_17, var_grid__width, var_grid__signs);
            // b__surface_cases__1 = sign_word(i + grid__ny, w, grid__width, grid__signs)       <L 27>
            var_66 = wp::add(var_0, var_grid__ny);
            var_67 = sign_word_0(var_66, var_17, var_grid__width, var_grid__signs);
            // c__surface_cases__1 = sign_word(i + 1, w, grid__width, grid__signs)            <L 28>
            var_69 = wp::add(var_0, var_68);
            var_70 = sign_word_0(var_69, var_17, var_grid__width, var_grid__signs);
            // d__surface_cases__1 = sign_word(i + grid__ny + 1, w, grid__width, grid__signs)       <L 29>
            var_71 = wp::add(var_0, var_grid__ny);
            var_73 = wp::add(var_71, var_72);
            var_74 = sign_word_0(var_73, var_17, var_grid__width, var_grid__signs);
            // e__surface_cases__1 = signs_above(i, w, grid__width, grid__signs)              <L 30>
            var_75 = signs_above_0(var_0, var_17, var_grid__width, var_grid__signs);
            // f__surface_cases__1 = signs_above(i + grid__ny, w, grid__width, grid__signs)       <L 31>
            var_76 = wp::add(var_0, var_grid__ny);
            var_77 = signs_above_0(var_76, var_17, var_grid__width, var_grid__signs);
            // g__surface_cases__1 = signs_above(i + 1, w, grid__width, grid__signs)          <L 32>
            var_79 = wp::add(var_0, var_78);
            var_80 = signs_above_0(var_79, var_17, var_grid__width, var_grid__signs);
            // h__surface_cases__1 = signs_above(i + grid__ny + 1, w, grid__width, grid__signs)       <L 33>
            var_81 = wp::add(var_0, var_grid__ny);
            var_83 = wp::add(var_81, var_82);
            var_84 = signs_above_0(var_83, var_17, var_grid__width, var_grid__signs);
        }
        var_85 = wp::where(var_64, var_65, var_48);
        var_86 = wp::where(var_64, var_67, var_50);
        var_87 = wp::where(var_64, var_70, var_52);
        var_88 = wp::where(var_64, var_74, var_54);
        var_89 = wp::where(var_64, var_75, var_56);
        var_90 = wp::where(var_64, var_77, var_58);
        var_91 = wp::where(var_64, var_80, var_60);
        var_92 = wp::where(var_64, var_84, var_62);
        // while left__surface_cases__1 != 0:                                                 <L 34>
    start_while_2:;
        var_94 = (var_46 != var_93);
    if ((var_94) == false) goto end_while_2;
            // j = lowest_bit(left__surface_cases__1)                                         <L 35>
            var_95 = lowest_bit_1(var_46);
            // left__surface_cases__1 = left__surface_cases__1 ^ 1 << j                       <L 36>
            var_97 = wp::lshift(var_96, var_95);
            var_98 = wp::bit_xor(var_46, var_97);
            // low__surface_cases__1 = bit(a__surface_cases__1, j) | bit(b__surface_cases__1, j) << 1 | bit(c__surface_cases__1, j) << 2 | bit(d__surface_cases__1, j) << 3       <L 37>
            var_99 = bit_0(var_85, var_95);
            var_100 = bit_0(var_86, var_95);
            var_102 = wp::lshift(var_100, var_101);
            var_103 = wp::bit_or(var_99, var_102);
            var_104 = bit_0(var_87, var_95);
            var_106 = wp::lshift(var_104, var_105);
            var_107 = wp::bit_or(var_103, var_106);
            var_108 = bit_0(var_88, var_95);
            var_110 = wp::lshift(var_108, var_109);
            var_111 = wp::bit_or(var_107, var_110);
            // high__surface_cases__1 = bit(e__surface_cases__1, j) | bit(f__surface_cases__1, j) << 1 | bit(g__surface_cases__1, j) << 2 | bit(h__surface_cases__1, j) << 3       <L 38>
            var_112 = bit_0(var_89, var_95);
            var_113 = bit_0(var_90, var_95);
            var_115 = wp::lshift(var_113, var_114);
            var_116 = wp::bit_or(var_112, var_115);
            var_117 = bit_0(var_91, var_95);
            var_119 = wp::lshift(var_117, var_118);
            var_120 = wp::bit_or(var_116, var_119);
            var_121 = bit_0(var_92, var_95);
            var_123 = wp::lshift(var_121, var_122);
            var_124 = wp::bit_or(var_120, var_123);
            // case = low__surface_cases__1 | high__surface_cases__1 << 4                     <L 39>
            var_126 = wp::lshift(var_124, var_125);
            var_127 = wp::bit_or(var_111, var_126);
            // triangles += tables__triangle_count[case]                                      <L 40>
            var_128 = wp::address(var_tables__triangle_count, var_127);
            var_130 = wp::load(var_128);
            var_129 = wp::add(var_4, var_130);
            wp::assign(var_4, var_129);
            wp::assign(var_46, var_98);
    goto start_while_2;
    end_while_2:;
        wp::assign(var_2, var_45);
        goto start_for_0;
    end_for_0:;
    // counts[i] = vertices                                                                   <L 41>
    wp::array_store(var_counts, var_0, var_2);
    // counts[grid__rows + i] = triangles                                                     <L 42>
    var_131 = wp::add(var_grid__rows, var_0);
    wp::array_store(var_counts, var_131, var_4);
}



template <bool wp_linear_contiguous>
static WP_FORCEINLINE void count_surface_kernel_bc69cd89_cpu_forward_tasks(
    wp::launch_bounds_t<1> *dim,
    wp_args_count_surface_kernel_bc69cd89 *_wp_args)
{
    for (size_t task_index = 0; task_index < dim->size; ++task_index)
    {
        count_surface_kernel_bc69cd89_cpu_kernel_forward<wp_linear_contiguous>(*dim, task_index, _wp_args);
    }
}

static WP_FORCEINLINE void count_surface_kernel_bc69cd89_cpu_forward_dispatch(
    wp::launch_bounds_t<1> *dim,
    wp_args_count_surface_kernel_bc69cd89 *_wp_args)
{
    wp::tile_shared_storage_t tile_mem;
#if defined(WP_ENABLE_TILES_IN_STACK_MEMORY)
    wp::shared_tile_storage = &tile_mem;
#endif

    const bool wp_linear_contiguous = dim->coord_mult == 1 && ((_wp_args->grid__signs.strides[0] == (int)sizeof(wp::int32)) & (_wp_args->grid__complete.strides[0] == (int)sizeof(wp::int32)) & (_wp_args->grid__has_gaps.strides[0] == (int)sizeof(wp::int32)) & (_wp_args->tables__triangle_count.strides[0] == (int)sizeof(wp::int32)) & (_wp_args->edges__words.strides[0] == (int)sizeof(wp::vec_t<4, wp::int32>)) & (_wp_args->counts.strides[0] == (int)sizeof(wp::int32)));
    if (wp_linear_contiguous)
        count_surface_kernel_bc69cd89_cpu_forward_tasks<true>(dim, _wp_args);
    else
        count_surface_kernel_bc69cd89_cpu_forward_tasks<false>(dim, _wp_args);
}

extern "C" {

// Python CPU entry points
WP_API void count_surface_kernel_bc69cd89_cpu_forward(
    wp::launch_bounds_t<1> *dim,
    wp_args_count_surface_kernel_bc69cd89 *_wp_args)
{
    count_surface_kernel_bc69cd89_cpu_forward_dispatch(dim, _wp_args);
}

} // extern C

struct wp_args_pack_signs_kernel_d30e90d4 {
    wp::array_t<wp::float32> field__values;
    wp::int32 field__nz;
    wp::float32 field__level;
    wp::int32 grid__width;
    wp::array_t<wp::int32> grid__signs;
    wp::array_t<wp::int32> grid__finite;
    wp::array_t<wp::int32> grid__has_gaps;
};


template <bool wp_linear_contiguous>
static void pack_signs_kernel_d30e90d4_cpu_kernel_forward(
    wp::launch_bounds_t<1> dim,
    size_t task_index,
    wp_args_pack_signs_kernel_d30e90d4 *_wp_args)
{
    static constexpr bool wp_linear_tid = wp_linear_contiguous;
    wp_args_pack_signs_kernel_d30e90d4 wp_contiguous_args;
    if constexpr (wp_linear_contiguous)
    {
        wp_contiguous_args = *_wp_args;
        wp_contiguous_args.grid__signs.strides[0] = sizeof(wp::int32);
        wp_contiguous_args.grid__finite.strides[0] = sizeof(wp::int32);
        wp_contiguous_args.grid__has_gaps.strides[0] = sizeof(wp::int32);
        _wp_args = &wp_contiguous_args;
    }
    //---------
    // argument vars
    wp::array_t<wp::float32> var_field__values = _wp_args->field__values;
    wp::int32 var_field__nz = _wp_args->field__nz;
    wp::float32 var_field__level = _wp_args->field__level;
    wp::int32 var_grid__width = _wp_args->grid__width;
    wp::array_t<wp::int32> var_grid__signs = _wp_args->grid__signs;
    wp::array_t<wp::int32> var_grid__finite = _wp_args->grid__finite;
    wp::array_t<wp::int32> var_grid__has_gaps = _wp_args->grid__has_gaps;
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32 var_1;
    wp::int32 var_2;
    wp::int32 var_3;
    const wp::int32 var_4 = 32;
    wp::int32 var_5;
    wp::int32 var_6;
    wp::int32 var_7;
    const wp::int32 var_8 = 0;
    wp::int32 var_9;
    const wp::int32 var_10 = 0;
    wp::int32 var_11;
    bool var_12;
    wp::int32 var_13;
    wp::int32 var_14;
    wp::int32 var_15;
    wp::float32* var_16;
    wp::float32 var_17;
    wp::float32 var_18;
    bool var_19;
    wp::int32 var_20;
    wp::int32 var_21;
    wp::int32 var_22;
    bool var_23;
    wp::int32 var_24;
    wp::int32 var_25;
    wp::int32 var_26;
    wp::range_t var_27;
    wp::int32 var_28;
    wp::int32 var_29;
    wp::float32* var_30;
    wp::float32 var_31;
    wp::float32 var_32;
    bool var_33;
    wp::int32 var_34;
    wp::int32 var_35;
    wp::int32 var_36;
    bool var_37;
    wp::int32 var_38;
    wp::int32 var_39;
    wp::int32 var_40;
    wp::int32 var_41;
    wp::float32 var_42;
    wp::int32 var_43;
    bool var_44;
    const wp::int32 var_45 = 0;
    const wp::int32 var_46 = 1;
    wp::int32 var_47;
    //---------
    // forward
    // def pack_signs_kernel(field__values, field__nz, field__level, grid__width, grid__signs, grid__finite, grid__has_gaps):       <L 1>
    // i = tid()                                                                              <L 3>
    var_0 = builtin_tid1d();
    // row = i // grid__width                                                                 <L 4>
    var_1 = wp::floordiv(var_0, var_grid__width);
    // first = (i - row * grid__width) * WORD                                                 <L 5>
    var_2 = wp::mul(var_1, var_grid__width);
    var_3 = wp::sub(var_0, var_2);
    var_5 = wp::mul(var_3, var_4);
    // size = min(field__nz - first, WORD)                                                    <L 6>
    var_6 = wp::sub(var_field__nz, var_5);
    var_7 = wp::min(var_6, var_4);
    // below = int(0)                                                                         <L 7>
    var_9 = wp::int(var_8);
    // known = int(0)                                                                         <L 8>
    var_11 = wp::int(var_10);
    // if size == WORD:                                                                       <L 9>
    var_12 = (var_7 == var_4);
    if (var_12) {
        // for j in range(WORD):                                                              <L 10>
        var_13 = 0;
        start_for_0:;
            if (var_13 >= 32) goto end_for_0;
            var_14 = var_13;
            var_13 += 1;
            // value = field__values[row, first + j]                                          <L 11>
            var_15 = wp::add(var_5, var_14);
            var_16 = wp::address(var_field__values, var_1, var_15);
            var_18 = wp::load(var_16);
            var_17 = wp::copy(var_18);
            // below = below | int(value < field__level) << j                                 <L 12>
            var_19 = (var_17 < var_field__level);
            var_20 = wp::int(var_19);
            var_21 = wp::lshift(var_20, var_14);
            var_22 = wp::bit_or(var_9, var_21);
            // known = known | int(isfinite(value)) << j                                      <L 13>
            var_23 = wp::isfinite(var_17);
            var_24 = wp::int(var_23);
            var_25 = wp::lshift(var_24, var_14);
            var_26 = wp::bit_or(var_11, var_25);
            wp::assign(var_9, var_22);
            wp::assign(var_11, var_26);
            goto start_for_0;
        end_for_0:;
    }
    if (!var_12) {
        // for j in range(size):                                                              <L 15>
        var_27 = wp::range(var_7);
        start_for_2:;
            if (iter_cmp(var_27) == 0) goto end_for_2;
            var_28 = wp::iter_next(var_27);
            // value = field__values[row, first + j]                                          <L 16>
            var_29 = wp::add(var_5, var_28);
            var_30 = wp::address(var_field__values, var_1, var_29);
            var_32 = wp::load(var_30);
            var_31 = wp::copy(var_32);
            // below = below | int(value < field__level) << j                                 <L 17>
            var_33 = (var_31 < var_field__level);
            var_34 = wp::int(var_33);
            var_35 = wp::lshift(var_34, var_28);
            var_36 = wp::bit_or(var_9, var_35);
            // known = known | int(isfinite(value)) << j                                      <L 18>
            var_37 = wp::isfinite(var_31);
            var_38 = wp::int(var_37);
            var_39 = wp::lshift(var_38, var_28);
            var_40 = wp::bit_or(var_11, var_39);
            wp::assign(var_9, var_36);
            wp::assign(var_11, var_40);
            goto start_for_2;
        end_for_2:;
    }
    var_41 = wp::where(var_12, var_14, var_28);
    var_42 = wp::where(var_12, var_17, var_31);
    // grid__signs[i] = below                                                                 <L 19>
    wp::array_store(var_grid__signs, var_0, var_9);
    // grid__finite[i] = known                                                                <L 20>
    wp::array_store(var_grid__finite, var_0, var_11);
    // if bit_count(known) < size:                                                            <L 21>
    var_43 = wp::bit_count(var_11);
    var_44 = (var_43 < var_7);
    if (var_44) {
        // atomic_max(grid__has_gaps, 0, 1)                                                   <L 22>
        var_47 = wp::atomic_max(var_grid__has_gaps, var_45, var_46);
    }
}



template <bool wp_linear_contiguous>
static WP_FORCEINLINE void pack_signs_kernel_d30e90d4_cpu_forward_tasks(
    wp::launch_bounds_t<1> *dim,
    wp_args_pack_signs_kernel_d30e90d4 *_wp_args)
{
    for (size_t task_index = 0; task_index < dim->size; ++task_index)
    {
        pack_signs_kernel_d30e90d4_cpu_kernel_forward<wp_linear_contiguous>(*dim, task_index, _wp_args);
    }
}

static WP_FORCEINLINE void pack_signs_kernel_d30e90d4_cpu_forward_dispatch(
    wp::launch_bounds_t<1> *dim,
    wp_args_pack_signs_kernel_d30e90d4 *_wp_args)
{
    wp::tile_shared_storage_t tile_mem;
#if defined(WP_ENABLE_TILES_IN_STACK_MEMORY)
    wp::shared_tile_storage = &tile_mem;
#endif

    const bool wp_linear_contiguous = dim->coord_mult == 1 && ((_wp_args->grid__signs.strides[0] == (int)sizeof(wp::int32)) & (_wp_args->grid__finite.strides[0] == (int)sizeof(wp::int32)) & (_wp_args->grid__has_gaps.strides[0] == (int)sizeof(wp::int32)));
    if (wp_linear_contiguous)
        pack_signs_kernel_d30e90d4_cpu_forward_tasks<true>(dim, _wp_args);
    else
        pack_signs_kernel_d30e90d4_cpu_forward_tasks<false>(dim, _wp_args);
}

extern "C" {

// Python CPU entry points
WP_API void pack_signs_kernel_d30e90d4_cpu_forward(
    wp::launch_bounds_t<1> *dim,
    wp_args_pack_signs_kernel_d30e90d4 *_wp_args)
{
    pack_signs_kernel_d30e90d4_cpu_forward_dispatch(dim, _wp_args);
}

} // extern C

struct wp_args_write_triangles_kernel_ff207528 {
    wp::int32 grid__width;
    wp::int32 grid__rows;
    wp::int32 grid__ny;
    wp::int32 grid__nz;
    wp::array_t<wp::int32> grid__signs;
    wp::array_t<wp::int32> grid__complete;
    wp::array_t<wp::int32> grid__has_gaps;
    wp::array_t<wp::vec_t<4, wp::int32>> edges__words;
    wp::array_t<wp::int32> edges__offsets;
    wp::array_t<wp::int32> tables__triangle_count;
    wp::array_t<wp::int32> tables__triangle_edges;
    wp::array_t<wp::vec_t<3, wp::int32>> triangles;
};


template <bool wp_linear_contiguous>
static void write_triangles_kernel_ff207528_cpu_kernel_forward(
    wp::launch_bounds_t<1> dim,
    size_t task_index,
    wp_args_write_triangles_kernel_ff207528 *_wp_args)
{
    static constexpr bool wp_linear_tid = wp_linear_contiguous;
    wp_args_write_triangles_kernel_ff207528 wp_contiguous_args;
    if constexpr (wp_linear_contiguous)
    {
        wp_contiguous_args = *_wp_args;
        wp_contiguous_args.grid__signs.strides[0] = sizeof(wp::int32);
        wp_contiguous_args.grid__complete.strides[0] = sizeof(wp::int32);
        wp_contiguous_args.grid__has_gaps.strides[0] = sizeof(wp::int32);
        wp_contiguous_args.edges__words.strides[0] = sizeof(wp::vec_t<4, wp::int32>);
        wp_contiguous_args.edges__offsets.strides[0] = sizeof(wp::int32);
        wp_contiguous_args.tables__triangle_count.strides[0] = sizeof(wp::int32);
        wp_contiguous_args.tables__triangle_edges.strides[0] = sizeof(wp::int32);
        wp_contiguous_args.triangles.strides[0] = sizeof(wp::vec_t<3, wp::int32>);
        _wp_args = &wp_contiguous_args;
    }
    //---------
    // argument vars
    wp::int32 var_grid__width = _wp_args->grid__width;
    wp::int32 var_grid__rows = _wp_args->grid__rows;
    wp::int32 var_grid__ny = _wp_args->grid__ny;
    wp::int32 var_grid__nz = _wp_args->grid__nz;
    wp::array_t<wp::int32> var_grid__signs = _wp_args->grid__signs;
    wp::array_t<wp::int32> var_grid__complete = _wp_args->grid__complete;
    wp::array_t<wp::int32> var_grid__has_gaps = _wp_args->grid__has_gaps;
    wp::array_t<wp::vec_t<4, wp::int32>> var_edges__words = _wp_args->edges__words;
    wp::array_t<wp::int32> var_edges__offsets = _wp_args->edges__offsets;
    wp::array_t<wp::int32> var_tables__triangle_count = _wp_args->tables__triangle_count;
    wp::array_t<wp::int32> var_tables__triangle_edges = _wp_args->tables__triangle_edges;
    wp::array_t<wp::vec_t<3, wp::int32>> var_triangles = _wp_args->triangles;
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32 var_1;
    wp::int32* var_2;
    wp::int32 var_3;
    wp::int32 var_4;
    wp::int32* var_5;
    wp::int32 var_6;
    wp::int32 var_7;
    wp::int32 var_8;
    const wp::int32 var_9 = 1;
    wp::int32 var_10;
    wp::int32* var_11;
    bool var_12;
    wp::int32 var_13;
    wp::range_t var_14;
    wp::int32 var_15;
    wp::int32 var_16;
    const wp::int32 var_17 = 0;
    const wp::int32 var_18 = 0;
    const wp::int32 var_19 = 0;
    const wp::int32 var_20 = 0;
    wp::vec_t<4, wp::int32> var_21;
    const wp::int32 var_22 = 0;
    const wp::int32 var_23 = 0;
    const wp::int32 var_24 = 0;
    const wp::int32 var_25 = 0;
    wp::vec_t<4, wp::int32> var_26;
    const wp::int32 var_27 = 0;
    const wp::int32 var_28 = 0;
    const wp::int32 var_29 = 0;
    const wp::int32 var_30 = 0;
    wp::vec_t<4, wp::int32> var_31;
    const wp::int32 var_32 = 0;
    const wp::int32 var_33 = 0;
    const wp::int32 var_34 = 0;
    const wp::int32 var_35 = 0;
    wp::vec_t<4, wp::int32> var_36;
    const wp::int32 var_37 = 0;
    wp::int32 var_38;
    const wp::int32 var_39 = 0;
    wp::int32 var_40;
    const wp::int32 var_41 = 0;
    bool var_42;
    wp::vec_t<4, wp::int32> var_43;
    wp::int32 var_44;
    wp::vec_t<4, wp::int32> var_45;
    const wp::int32 var_46 = 1;
    wp::int32 var_47;
    wp::vec_t<4, wp::int32> var_48;
    wp::int32 var_49;
    const wp::int32 var_50 = 1;
    wp::int32 var_51;
    wp::vec_t<4, wp::int32> var_52;
    wp::int32 var_53;
    wp::int32 var_54;
    wp::int32 var_55;
    wp::vec_t<4, wp::int32> var_56;
    wp::vec_t<4, wp::int32> var_57;
    wp::vec_t<4, wp::int32> var_58;
    wp::vec_t<4, wp::int32> var_59;
    wp::int32 var_60;
    wp::int32 var_61;
    wp::int32 var_62;
    const wp::int32 var_63 = 0;
    wp::int32 var_64;
    const wp::int32 var_65 = 0;
    wp::int32 var_66;
    const wp::int32 var_67 = 0;
    wp::int32 var_68;
    const wp::int32 var_69 = 0;
    wp::int32 var_70;
    const wp::int32 var_71 = 0;
    wp::int32 var_72;
    const wp::int32 var_73 = 0;
    wp::int32 var_74;
    const wp::int32 var_75 = 0;
    wp::int32 var_76;
    const wp::int32 var_77 = 0;
    wp::int32 var_78;
    const wp::int32 var_79 = 0;
    bool var_80;
    wp::int32 var_81;
    wp::int32 var_82;
    wp::int32 var_83;
    const wp::int32 var_84 = 1;
    wp::int32 var_85;
    wp::int32 var_86;
    wp::int32 var_87;
    const wp::int32 var_88 = 1;
    wp::int32 var_89;
    wp::int32 var_90;
    wp::int32 var_91;
    wp::int32 var_92;
    wp::int32 var_93;
    const wp::int32 var_94 = 1;
    wp::int32 var_95;
    wp::int32 var_96;
    wp::int32 var_97;
    const wp::int32 var_98 = 1;
    wp::int32 var_99;
    wp::int32 var_100;
    wp::int32 var_101;
    wp::int32 var_102;
    wp::int32 var_103;
    wp::int32 var_104;
    wp::int32 var_105;
    wp::int32 var_106;
    wp::int32 var_107;
    wp::int32 var_108;
    const wp::int32 var_109 = 0;
    bool var_110;
    wp::int32 var_111;
    const wp::int32 var_112 = 1;
    wp::int32 var_113;
    wp::int32 var_114;
    wp::int32 var_115;
    wp::int32 var_116;
    const wp::int32 var_117 = 1;
    wp::int32 var_118;
    wp::int32 var_119;
    wp::int32 var_120;
    const wp::int32 var_121 = 2;
    wp::int32 var_122;
    wp::int32 var_123;
    wp::int32 var_124;
    const wp::int32 var_125 = 3;
    wp::int32 var_126;
    wp::int32 var_127;
    wp::int32 var_128;
    wp::int32 var_129;
    const wp::int32 var_130 = 1;
    wp::int32 var_131;
    wp::int32 var_132;
    wp::int32 var_133;
    const wp::int32 var_134 = 2;
    wp::int32 var_135;
    wp::int32 var_136;
    wp::int32 var_137;
    const wp::int32 var_138 = 3;
    wp::int32 var_139;
    wp::int32 var_140;
    const wp::int32 var_141 = 4;
    wp::int32 var_142;
    wp::int32 var_143;
    wp::vec_t<3, wp::int32> var_144;
    wp::vec_t<3, wp::int32> var_145;
    wp::vec_t<3, wp::int32> var_146;
    wp::vec_t<3, wp::int32> var_147;
    const wp::int32 var_148 = 0;
    wp::int32 var_149;
    const wp::int32 var_150 = 1;
    wp::int32 var_151;
    wp::int32 var_152;
    wp::int32 var_153;
    const wp::int32 var_154 = 0;
    wp::int32 var_155;
    const wp::int32 var_156 = 1;
    wp::int32 var_157;
    wp::int32 var_158;
    wp::int32 var_159;
    const wp::int32 var_160 = 2;
    wp::int32 var_161;
    wp::int32 var_162;
    wp::int32 var_163;
    const wp::int32 var_164 = 2;
    wp::int32 var_165;
    wp::int32 var_166;
    wp::int32 var_167;
    const wp::int32 var_168 = 0;
    wp::int32 var_169;
    const wp::int32 var_170 = 0;
    wp::int32 var_171;
    const wp::int32 var_172 = 2;
    wp::int32 var_173;
    const wp::int32 var_174 = 2;
    wp::int32 var_175;
    const wp::int32 var_176 = 1;
    wp::int32 var_177;
    const wp::int32 var_178 = 1;
    wp::int32 var_179;
    const wp::int32 var_180 = 1;
    wp::int32 var_181;
    const wp::int32 var_182 = 1;
    wp::int32 var_183;
    wp::vec_t<12, wp::int32> var_184;
    wp::int32* var_185;
    wp::range_t var_186;
    wp::int32 var_187;
    wp::int32 var_188;
    const wp::int32 var_189 = 15;
    wp::int32 var_190;
    const wp::int32 var_191 = 3;
    wp::int32 var_192;
    wp::int32 var_193;
    wp::int32* var_194;
    wp::int32 var_195;
    wp::int32 var_196;
    const wp::int32 var_197 = 1;
    wp::int32 var_198;
    wp::int32* var_199;
    wp::int32 var_200;
    wp::int32 var_201;
    const wp::int32 var_202 = 2;
    wp::int32 var_203;
    wp::int32* var_204;
    wp::int32 var_205;
    wp::int32 var_206;
    wp::vec_t<3, wp::int32> var_207;
    const wp::int32 var_208 = 1;
    wp::int32 var_209;
    //---------
    // forward
    // def write_triangles_kernel(grid__width, grid__rows, grid__ny, grid__nz, grid__signs, grid__complete, grid__has_gaps, edges__words, edges__offsets, tables__triangle_count, tables__triangle_edges, triangles):       <L 1>
    // i = tid()                                                                              <L 3>
    var_0 = builtin_tid1d();
    // first = edges__offsets[grid__rows + i]                                                 <L 4>
    var_1 = wp::add(var_grid__rows, var_0);
    var_2 = wp::address(var_edges__offsets, var_1);
    var_4 = wp::load(var_2);
    var_3 = wp::copy(var_4);
    // n = first - edges__offsets[grid__rows]                                                 <L 5>
    var_5 = wp::address(var_edges__offsets, var_grid__rows);
    var_7 = wp::load(var_5);
    var_6 = wp::sub(var_3, var_7);
    // if edges__offsets[grid__rows + i + 1] == first:                                        <L 6>
    var_8 = wp::add(var_grid__rows, var_0);
    var_10 = wp::add(var_8, var_9);
    var_11 = wp::address(var_edges__offsets, var_10);
    var_13 = wp::load(var_11);
    var_12 = (var_13 == var_3);
    if (var_12) {
        // return                                                                             <L 7>
        return;
    }
    // for w in range(grid__width):                                                           <L 8>
    var_14 = wp::range(var_grid__width);
    start_for_1:;
        if (iter_cmp(var_14) == 0) goto end_for_1;
        var_15 = wp::iter_next(var_14);
        // cells = surface_cells(i, w, grid__width, grid__ny, grid__nz, grid__signs, grid__complete, grid__has_gaps)       <L 9>
        var_16 = surface_cells_0(var_0, var_15, var_grid__width, var_grid__ny, var_grid__nz, var_grid__signs, var_grid__complete, var_grid__has_gaps);
        // low = vec4i(0, 0, 0, 0)                                                            <L 10>
        var_21 = wp::vec_t<4, wp::int32>(var_17, var_18, var_19, var_20);
        // low_x = vec4i(0, 0, 0, 0)                                                          <L 11>
        var_26 = wp::vec_t<4, wp::int32>(var_22, var_23, var_24, var_25);
        // high = vec4i(0, 0, 0, 0)                                                           <L 12>
        var_31 = wp::vec_t<4, wp::int32>(var_27, var_28, var_29, var_30);
        // high_x = vec4i(0, 0, 0, 0)                                                         <L 13>
        var_36 = wp::vec_t<4, wp::int32>(var_32, var_33, var_34, var_35);
        // low_above = int(0)                                                                 <L 14>
        var_38 = wp::int(var_37);
        // low_x_above = int(0)                                                               <L 15>
        var_40 = wp::int(var_39);
        // if cells != 0:                                                                     <L 16>
        var_42 = (var_16 != var_41);
        if (var_42) {
            // low = word_of(i, w, grid__width, edges__words, edges__offsets)                 <L 17>
            var_43 = word_of_1(var_0, var_15, var_grid__width, var_edges__words, var_edges__offsets);
            // low_x = word_of(i + grid__ny, w, grid__width, edges__words, edges__offsets)       <L 18>
            var_44 = wp::add(var_0, var_grid__ny);
            var_45 = word_of_1(var_44, var_15, var_grid__width, var_edges__words, var_edges__offsets);
            // high = word_of(i + 1, w, grid__width, edges__words, edges__offsets)            <L 19>
            var_47 = wp::add(var_0, var_46);
            var_48 = word_of_1(var_47, var_15, var_grid__width, var_edges__words, var_edges__offsets);
            // high_x = word_of(i + grid__ny + 1, w, grid__width, edges__words, edges__offsets)       <L 20>
            var_49 = wp::add(var_0, var_grid__ny);
            var_51 = wp::add(var_49, var_50);
            var_52 = word_of_1(var_51, var_15, var_grid__width, var_edges__words, var_edges__offsets);
            // low_above = x_edges_above(low, i, w, grid__width, edges__words)                <L 21>
            var_53 = x_edges_above_0(var_43, var_0, var_15, var_grid__width, var_edges__words);
            // low_x_above = x_edges_above(low_x, i + grid__ny, w, grid__width, edges__words)       <L 22>
            var_54 = wp::add(var_0, var_grid__ny);
            var_55 = x_edges_above_0(var_45, var_54, var_15, var_grid__width, var_edges__words);
        }
        var_56 = wp::where(var_42, var_43, var_21);
        var_57 = wp::where(var_42, var_45, var_26);
        var_58 = wp::where(var_42, var_48, var_31);
        var_59 = wp::where(var_42, var_52, var_36);
        var_60 = wp::where(var_42, var_53, var_38);
        var_61 = wp::where(var_42, var_55, var_40);
        // left__surface_cases__1 = cells                                                     <L 23>
        var_62 = wp::copy(var_16);
        // a__surface_cases__1 = int(0)                                                       <L 24>
        var_64 = wp::int(var_63);
        // b__surface_cases__1 = int(0)                                                       <L 25>
        var_66 = wp::int(var_65);
        // c__surface_cases__1 = int(0)                                                       <L 26>
        var_68 = wp::int(var_67);
        // d__surface_cases__1 = int(0)                                                       <L 27>
        var_70 = wp::int(var_69);
        // e__surface_cases__1 = int(0)                                                       <L 28>
        var_72 = wp::int(var_71);
        // f__surface_cases__1 = int(0)                                                       <L 29>
        var_74 = wp::int(var_73);
        // g__surface_cases__1 = int(0)                                                       <L 30>
        var_76 = wp::int(var_75);
        // h__surface_cases__1 = int(0)                                                       <L 31>
        var_78 = wp::int(var_77);
        // if left__surface_cases__1 != 0:                                                    <L 32>
        var_80 = (var_62 != var_79);
        if (var_80) {
            // a__surface_cases__1 = sign_word(i, w, grid__width, grid__signs)                <L 33>
            var_81 = sign_word_0(var_0, var_15, var_grid__width, var_grid__signs);
            // b__surface_cases__1 = sign_word(i + grid__ny, w, grid__width, grid__signs)       <L 34>
            var_82 = wp::add(var_0, var_grid__ny);
            var_83 = sign_word_0(var_82, var_15, var_grid__width, var_grid__signs);
            // c__surface_cases__1 = sign_word(i + 1, w, grid__width, grid__signs)            <L 35>
            var_85 = wp::add(var_0, var_84);
            var_86 = sign_word_0(var_85, var_15, var_grid__width, var_grid__signs);
            // d__surface_cases__1 = sign_word(i + grid__ny + 1, w, grid__width, grid__signs)       <L 36>
            var_87 = wp::add(var_0, var_grid__ny);
            var_89 = wp::add(var_87, var_88);
            var_90 = sign_word_0(var_89, var_15, var_grid__width, var_grid__signs);
            // e__surface_cases__1 = signs_above(i, w, grid__width, grid__signs)              <L 37>
            var_91 = signs_above_0(var_0, var_15, var_grid__width, var_grid__signs);
            // f__surface_cases__1 = signs_above(i + grid__ny, w, grid__width, grid__signs)       <L 38>
            var_92 = wp::add(var_0, var_grid__ny);
            var_93 = signs_above_0(var_92, var_15, var_grid__width, var_grid__signs);
            // g__surface_cases__1 = signs_above(i + 1, w, grid__width, grid__signs)          <L 39>
            var_95 = wp::add(var_0, var_94);
            var_96 = signs_above_0(var_95, var_15, var_grid__width, var_grid__signs);
            // h__surface_cases__1 = signs_above(i + grid__ny + 1, w, grid__width, grid__signs)       <L 40>
            var_97 = wp::add(var_0, var_grid__ny);
            var_99 = wp::add(var_97, var_98);
            var_100 = signs_above_0(var_99, var_15, var_grid__width, var_grid__signs);
        }
        var_101 = wp::where(var_80, var_81, var_64);
        var_102 = wp::where(var_80, var_83, var_66);
        var_103 = wp::where(var_80, var_86, var_68);
        var_104 = wp::where(var_80, var_90, var_70);
        var_105 = wp::where(var_80, var_91, var_72);
        var_106 = wp::where(var_80, var_93, var_74);
        var_107 = wp::where(var_80, var_96, var_76);
        var_108 = wp::where(var_80, var_100, var_78);
        // while left__surface_cases__1 != 0:                                                 <L 41>
    start_while_3:;
        var_110 = (var_62 != var_109);
    if ((var_110) == false) goto end_while_3;
            // j = lowest_bit(left__surface_cases__1)                                         <L 42>
            var_111 = lowest_bit_1(var_62);
            // left__surface_cases__1 = left__surface_cases__1 ^ 1 << j                       <L 43>
            var_113 = wp::lshift(var_112, var_111);
            var_114 = wp::bit_xor(var_62, var_113);
            // low__surface_cases__1 = bit(a__surface_cases__1, j) | bit(b__surface_cases__1, j) << 1 | bit(c__surface_cases__1, j) << 2 | bit(d__surface_cases__1, j) << 3       <L 44>
            var_115 = bit_0(var_101, var_111);
            var_116 = bit_0(var_102, var_111);
            var_118 = wp::lshift(var_116, var_117);
            var_119 = wp::bit_or(var_115, var_118);
            var_120 = bit_0(var_103, var_111);
            var_122 = wp::lshift(var_120, var_121);
            var_123 = wp::bit_or(var_119, var_122);
            var_124 = bit_0(var_104, var_111);
            var_126 = wp::lshift(var_124, var_125);
            var_127 = wp::bit_or(var_123, var_126);
            // high__surface_cases__1 = bit(e__surface_cases__1, j) | bit(f__surface_cases__1, j) << 1 | bit(g__surface_cases__1, j) << 2 | bit(h__surface_cases__1, j) << 3       <L 45>
            var_128 = bit_0(var_105, var_111);
            var_129 = bit_0(var_106, var_111);
            var_131 = wp::lshift(var_129, var_130);
            var_132 = wp::bit_or(var_128, var_131);
            var_133 = bit_0(var_107, var_111);
            var_135 = wp::lshift(var_133, var_134);
            var_136 = wp::bit_or(var_132, var_135);
            var_137 = bit_0(var_108, var_111);
            var_139 = wp::lshift(var_137, var_138);
            var_140 = wp::bit_or(var_136, var_139);
            // case = low__surface_cases__1 | high__surface_cases__1 << 4                     <L 46>
            var_142 = wp::lshift(var_140, var_141);
            var_143 = wp::bit_or(var_127, var_142);
            // p = vertices_before(low, j)                                                    <L 47>
            var_144 = vertices_before_0(var_56, var_111);
            // q = vertices_before(low_x, j)                                                  <L 48>
            var_145 = vertices_before_0(var_57, var_111);
            // r = vertices_before(high, j)                                                   <L 49>
            var_146 = vertices_before_0(var_58, var_111);
            // s = vertices_before(high_x, j)                                                 <L 50>
            var_147 = vertices_before_0(var_59, var_111);
            // y0 = p[0] + bit(low[1], j)                                                     <L 51>
            var_149 = wp::extract(var_144, var_148);
            var_151 = wp::extract(var_56, var_150);
            var_152 = bit_0(var_151, var_111);
            var_153 = wp::add(var_149, var_152);
            // y1 = q[0] + bit(low_x[1], j)                                                   <L 52>
            var_155 = wp::extract(var_145, var_154);
            var_157 = wp::extract(var_57, var_156);
            var_158 = bit_0(var_157, var_111);
            var_159 = wp::add(var_155, var_158);
            // y2 = p[2] + bit(low_above, j)                                                  <L 53>
            var_161 = wp::extract(var_144, var_160);
            var_162 = bit_0(var_60, var_111);
            var_163 = wp::add(var_161, var_162);
            // y3 = q[2] + bit(low_x_above, j)                                                <L 54>
            var_165 = wp::extract(var_145, var_164);
            var_166 = bit_0(var_61, var_111);
            var_167 = wp::add(var_165, var_166);
            // numbers = cell_edges(p[0], r[0], p[2], r[2], y0, y1, y2, y3, p[1], q[1], r[1], s[1])       <L 55>
            var_169 = wp::extract(var_144, var_168);
            var_171 = wp::extract(var_146, var_170);
            var_173 = wp::extract(var_144, var_172);
            var_175 = wp::extract(var_146, var_174);
            var_177 = wp::extract(var_144, var_176);
            var_179 = wp::extract(var_145, var_178);
            var_181 = wp::extract(var_146, var_180);
            var_183 = wp::extract(var_147, var_182);
            var_184 = wp::vec_t<12, wp::int32>({var_169, var_171, var_173, var_175, var_153, var_159, var_163, var_167, var_177, var_179, var_181, var_183});
            // for t in range(tables__triangle_count[case]):                                  <L 56>
            var_185 = wp::address(var_tables__triangle_count, var_143);
            var_187 = wp::load(var_185);
            var_186 = wp::range(var_187);
            start_for_5:;
                if (iter_cmp(var_186) == 0) goto end_for_5;
                var_188 = wp::iter_next(var_186);
                // entry = case * EDGES + 3 * t                                               <L 57>
                var_190 = wp::mul(var_143, var_189);
                var_192 = wp::mul(var_191, var_188);
                var_193 = wp::add(var_190, var_192);
                // a = numbers[tables__triangle_edges[entry]]                                 <L 58>
                var_194 = wp::address(var_tables__triangle_edges, var_193);
                var_196 = wp::load(var_194);
                var_195 = wp::extract(var_184, var_196);
                // b = numbers[tables__triangle_edges[entry + 1]]                             <L 59>
                var_198 = wp::add(var_193, var_197);
                var_199 = wp::address(var_tables__triangle_edges, var_198);
                var_201 = wp::load(var_199);
                var_200 = wp::extract(var_184, var_201);
                // c = numbers[tables__triangle_edges[entry + 2]]                             <L 60>
                var_203 = wp::add(var_193, var_202);
                var_204 = wp::address(var_tables__triangle_edges, var_203);
                var_206 = wp::load(var_204);
                var_205 = wp::extract(var_184, var_206);
                // triangles[n] = vec3i(a, b, c)                                              <L 61>
                var_207 = wp::vec_t<3, wp::int32>(var_195, var_200, var_205);
                wp::array_store(var_triangles, var_6, var_207);
                // n += 1                                                                     <L 62>
                var_209 = wp::add(var_6, var_208);
                wp::assign(var_6, var_209);
                goto start_for_5;
            end_for_5:;
            wp::assign(var_62, var_114);
    goto start_while_3;
    end_while_3:;
        goto start_for_1;
    end_for_1:;
}



template <bool wp_linear_contiguous>
static WP_FORCEINLINE void write_triangles_kernel_ff207528_cpu_forward_tasks(
    wp::launch_bounds_t<1> *dim,
    wp_args_write_triangles_kernel_ff207528 *_wp_args)
{
    for (size_t task_index = 0; task_index < dim->size; ++task_index)
    {
        write_triangles_kernel_ff207528_cpu_kernel_forward<wp_linear_contiguous>(*dim, task_index, _wp_args);
    }
}

static WP_FORCEINLINE void write_triangles_kernel_ff207528_cpu_forward_dispatch(
    wp::launch_bounds_t<1> *dim,
    wp_args_write_triangles_kernel_ff207528 *_wp_args)
{
    wp::tile_shared_storage_t tile_mem;
#if defined(WP_ENABLE_TILES_IN_STACK_MEMORY)
    wp::shared_tile_storage = &tile_mem;
#endif

    const bool wp_linear_contiguous = dim->coord_mult == 1 && ((_wp_args->grid__signs.strides[0] == (int)sizeof(wp::int32)) & (_wp_args->grid__complete.strides[0] == (int)sizeof(wp::int32)) & (_wp_args->grid__has_gaps.strides[0] == (int)sizeof(wp::int32)) & (_wp_args->edges__words.strides[0] == (int)sizeof(wp::vec_t<4, wp::int32>)) & (_wp_args->edges__offsets.strides[0] == (int)sizeof(wp::int32)) & (_wp_args->tables__triangle_count.strides[0] == (int)sizeof(wp::int32)) & (_wp_args->tables__triangle_edges.strides[0] == (int)sizeof(wp::int32)) & (_wp_args->triangles.strides[0] == (int)sizeof(wp::vec_t<3, wp::int32>)));
    if (wp_linear_contiguous)
        write_triangles_kernel_ff207528_cpu_forward_tasks<true>(dim, _wp_args);
    else
        write_triangles_kernel_ff207528_cpu_forward_tasks<false>(dim, _wp_args);
}

extern "C" {

// Python CPU entry points
WP_API void write_triangles_kernel_ff207528_cpu_forward(
    wp::launch_bounds_t<1> *dim,
    wp_args_write_triangles_kernel_ff207528 *_wp_args)
{
    write_triangles_kernel_ff207528_cpu_forward_dispatch(dim, _wp_args);
}

} // extern C


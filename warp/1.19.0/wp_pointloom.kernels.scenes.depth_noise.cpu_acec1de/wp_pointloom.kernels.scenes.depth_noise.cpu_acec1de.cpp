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


// <pointloom.kernels.arrays.random.philox>:1
static wp::vec_t<4, wp::uint32> philox_0(
    wp::uint64 var_x0,
    wp::uint64 var_x1,
    wp::uint64 var_x2,
    wp::uint64 var_x3,
    wp::uint64 var_k0,
    wp::uint64 var_k1)
{
    //---------
    // primal vars
    wp::uint64 var_0;
    wp::uint64 var_1;
    wp::uint64 var_2;
    wp::uint64 var_3;
    wp::uint64 var_4;
    wp::uint64 var_5;
    wp::int32 var_6;
    wp::int32 var_7;
    wp::uint64 var_8;
    wp::uint64 var_9;
    wp::uint64 var_10;
    wp::uint64 var_11;
    wp::uint64 var_12;
    wp::uint64 var_13;
    wp::uint64 var_14;
    wp::uint64 var_15;
    wp::uint64 var_16;
    wp::uint64 var_17;
    wp::uint64 var_18;
    wp::uint64 var_19;
    wp::uint64 var_20;
    wp::uint64 var_21;
    wp::uint64 var_22;
    wp::uint64 var_23;
    wp::uint64 var_24;
    wp::uint64 var_25;
    wp::uint64 var_26;
    wp::uint64 var_27;
    wp::uint64 var_28;
    wp::uint64 var_29;
    wp::uint64 var_30;
    wp::uint64 var_31;
    wp::uint32 var_32;
    wp::uint32 var_33;
    wp::uint32 var_34;
    wp::uint32 var_35;
    wp::vec_t<4, wp::uint32> var_36;
    //---------
    // forward
    // def philox(x0, x1, x2, x3, k0, k1):                                                    <L 1>
    // c0 = x0                                                                                <L 3>
    var_0 = wp::copy(var_x0);
    // c1 = x1                                                                                <L 4>
    var_1 = wp::copy(var_x1);
    // c2 = x2                                                                                <L 5>
    var_2 = wp::copy(var_x2);
    // c3 = x3                                                                                <L 6>
    var_3 = wp::copy(var_x3);
    // key0 = k0                                                                              <L 7>
    var_4 = wp::copy(var_k0);
    // key1 = k1                                                                              <L 8>
    var_5 = wp::copy(var_k1);
    // for _ in range(ROUNDS):                                                                <L 9>
    var_6 = 0;
    start_for_0:;
        if (var_6 >= 10) goto end_for_0;
        var_7 = var_6;
        var_6 += 1;
        // p0 = uint64(MULTIPLIER_0) * c0                                                     <L 10>
        var_8 = 3528531795ull;
        var_9 = wp::mul(var_8, var_0);
        // p1 = uint64(MULTIPLIER_1) * c2                                                     <L 11>
        var_10 = 3449720151ull;
        var_11 = wp::mul(var_10, var_2);
        // c0 = p1 >> uint64(32) ^ c1 ^ key0                                                  <L 12>
        var_12 = 32ull;
        var_13 = wp::rshift(var_11, var_12);
        var_14 = wp::bit_xor(var_13, var_1);
        var_15 = wp::bit_xor(var_14, var_4);
        // c1 = p1 & uint64(LOW_WORD)                                                         <L 13>
        var_16 = 4294967295ull;
        var_17 = wp::bit_and(var_11, var_16);
        // c2 = p0 >> uint64(32) ^ c3 ^ key1                                                  <L 14>
        var_18 = 32ull;
        var_19 = wp::rshift(var_9, var_18);
        var_20 = wp::bit_xor(var_19, var_3);
        var_21 = wp::bit_xor(var_20, var_5);
        // c3 = p0 & uint64(LOW_WORD)                                                         <L 15>
        var_22 = wp::uint64(var_16);
        var_23 = wp::bit_and(var_9, var_22);
        // key0 = key0 + uint64(WEYL_0) & uint64(LOW_WORD)                                    <L 16>
        var_24 = 2654435769ull;
        var_25 = wp::add(var_4, var_24);
        var_26 = wp::uint64(var_16);
        var_27 = wp::bit_and(var_25, var_26);
        // key1 = key1 + uint64(WEYL_1) & uint64(LOW_WORD)                                    <L 17>
        var_28 = 3144134277ull;
        var_29 = wp::add(var_5, var_28);
        var_30 = wp::uint64(var_16);
        var_31 = wp::bit_and(var_29, var_30);
        wp::assign(var_0, var_15);
        wp::assign(var_1, var_17);
        wp::assign(var_2, var_21);
        wp::assign(var_3, var_23);
        wp::assign(var_4, var_27);
        wp::assign(var_5, var_31);
        goto start_for_0;
    end_for_0:;
    // return vec4u(uint32(c0), uint32(c1), uint32(c2), uint32(c3))                           <L 18>
    var_32 = wp::uint32(var_0);
    var_33 = wp::uint32(var_1);
    var_34 = wp::uint32(var_2);
    var_35 = wp::uint32(var_3);
    var_36 = wp::vec_t<4, wp::uint32>(var_32, var_33, var_34, var_35);
    return var_36;
}


// <pointloom.kernels.arrays.random.random_bits>:1
static wp::vec_t<4, wp::uint32> random_bits_0(
    wp::int32 var_seed,
    wp::int32 var_counter,
    wp::int32 var_stream)
{
    //---------
    // primal vars
    wp::int64 var_0;
    wp::int64 var_1;
    wp::int64 var_2;
    wp::uint64 var_3;
    wp::int64 var_4;
    wp::int64 var_5;
    wp::int64 var_6;
    wp::uint64 var_7;
    wp::int64 var_8;
    wp::int64 var_9;
    wp::int64 var_10;
    wp::uint64 var_11;
    wp::uint64 var_12;
    wp::uint64 var_13;
    wp::uint64 var_14;
    wp::vec_t<4, wp::uint32> var_15;
    //---------
    // forward
    // def random_bits(seed, counter, stream):                                                <L 1>
    // key = uint64(int64(seed) & int64(LOW_WORD))                                            <L 3>
    var_0 = wp::int64(var_seed);
    var_1 = 4294967295ll;
    var_2 = wp::bit_and(var_0, var_1);
    var_3 = wp::uint64(var_2);
    // lane = uint64(int64(stream) & int64(LOW_WORD))                                         <L 4>
    var_4 = wp::int64(var_stream);
    var_5 = wp::int64(var_1);
    var_6 = wp::bit_and(var_4, var_5);
    var_7 = wp::uint64(var_6);
    // return philox(uint64(int64(counter) & int64(LOW_WORD)), uint64(0), lane, uint64(0), key, uint64(0))       <L 5>
    var_8 = wp::int64(var_counter);
    var_9 = wp::int64(var_1);
    var_10 = wp::bit_and(var_8, var_9);
    var_11 = wp::uint64(var_10);
    var_12 = 0ull;
    var_13 = 0ull;
    var_14 = 0ull;
    var_15 = philox_0(var_11, var_12, var_7, var_13, var_3, var_14);
    return var_15;
}


// <pointloom.kernels.arrays.random.unit_float>:1
static wp::float32 unit_float_0(
    wp::uint32 var_word)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 8;
    wp::uint32 var_1;
    wp::uint32 var_2;
    wp::float32 var_3;
    const wp::float32 var_4 = 5.960464477539063e-08;
    wp::float32 var_5;
    //---------
    // forward
    // def unit_float(word):                                                                  <L 1>
    // return float32(word >> uint32(8)) * UNIT                                               <L 3>
    var_1 = wp::uint32(var_0);
    var_2 = wp::rshift(var_word, var_1);
    var_3 = wp::float32(var_2);
    var_5 = wp::mul(var_3, var_4);
    return var_5;
}


// /work/main/src/pointloom/kernels/arrays/random.py:66
static wp::vec_t<4, wp::float32> random_uniform_0(
    wp::int32 var_seed,
    wp::int32 var_counter,
    wp::int32 var_stream)
{
    //---------
    // primal vars
    wp::vec_t<4, wp::uint32> var_0;
    const wp::int32 var_1 = 0;
    wp::uint32 var_2;
    wp::float32 var_3;
    const wp::int32 var_4 = 1;
    wp::uint32 var_5;
    wp::float32 var_6;
    const wp::int32 var_7 = 2;
    wp::uint32 var_8;
    wp::float32 var_9;
    const wp::int32 var_10 = 3;
    wp::uint32 var_11;
    wp::float32 var_12;
    wp::vec_t<4, wp::float32> var_13;
    //---------
    // forward
    // def random_uniform(seed: int, counter: int, stream: int) -> vec4:                      <L 67>
    // words = random_bits(seed, counter, stream)                                             <L 68>
    var_0 = random_bits_0(var_seed, var_counter, var_stream);
    // return vec4(unit_float(words[0]), unit_float(words[1]), unit_float(words[2]), unit_float(words[3]))       <L 69>
    var_2 = wp::extract(var_0, var_1);
    var_3 = unit_float_0(var_2);
    var_5 = wp::extract(var_0, var_4);
    var_6 = unit_float_0(var_5);
    var_8 = wp::extract(var_0, var_7);
    var_9 = unit_float_0(var_8);
    var_11 = wp::extract(var_0, var_10);
    var_12 = unit_float_0(var_11);
    var_13 = wp::vec_t<4, wp::float32>(var_3, var_6, var_9, var_12);
    return var_13;
}


// /work/main/src/pointloom/kernels/arrays/random.py:85
static wp::vec_t<2, wp::float32> gaussian_pair_0(
    wp::float32 var_u,
    wp::float32 var_v)
{
    //---------
    // primal vars
    const wp::float32 var_0 = -2.0;
    const wp::float32 var_1 = 1.0;
    wp::float32 var_2;
    wp::float32 var_3;
    wp::float32 var_4;
    wp::float32 var_5;
    const wp::float32 var_6 = 6.283185307179586;
    wp::float32 var_7;
    wp::float32 var_8;
    wp::float32 var_9;
    wp::float32 var_10;
    wp::float32 var_11;
    wp::float32 var_12;
    wp::vec_t<2, wp::float32> var_13;
    //---------
    // forward
    // def gaussian_pair(u: float, v: float) -> vec2:                                         <L 86>
    // radius = sqrt(-2.0 * log(1.0 - u))  # 1 - u is in (0, 1], where the logarithm is finite       <L 88>
    var_2 = wp::sub(var_1, var_u);
    var_3 = wp::log(var_2);
    var_4 = wp::mul(var_0, var_3);
    var_5 = wp::sqrt(var_4);
    // return vec2(radius * cos(TWO_PI * v), radius * sin(TWO_PI * v))                        <L 89>
    var_7 = wp::mul(var_6, var_v);
    var_8 = wp::cos(var_7);
    var_9 = wp::mul(var_5, var_8);
    var_10 = wp::mul(var_6, var_v);
    var_11 = wp::sin(var_10);
    var_12 = wp::mul(var_5, var_11);
    var_13 = wp::vec_t<2, wp::float32>(var_9, var_12);
    return var_13;
}


// <pointloom.kernels.arrays.random.philox>:1
static void adj_philox_0(
    wp::uint64 var_x0,
    wp::uint64 var_x1,
    wp::uint64 var_x2,
    wp::uint64 var_x3,
    wp::uint64 var_k0,
    wp::uint64 var_k1,
    wp::uint64 & adj_x0,
    wp::uint64 & adj_x1,
    wp::uint64 & adj_x2,
    wp::uint64 & adj_x3,
    wp::uint64 & adj_k0,
    wp::uint64 & adj_k1,
    wp::vec_t<4, wp::uint32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.arrays.random.random_bits>:1
static void adj_random_bits_0(
    wp::int32 var_seed,
    wp::int32 var_counter,
    wp::int32 var_stream,
    wp::int32 & adj_seed,
    wp::int32 & adj_counter,
    wp::int32 & adj_stream,
    wp::vec_t<4, wp::uint32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.arrays.random.unit_float>:1
static void adj_unit_float_0(
    wp::uint32 var_word,
    wp::uint32 & adj_word,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/arrays/random.py:66
static void adj_random_uniform_0(
    wp::int32 var_seed,
    wp::int32 var_counter,
    wp::int32 var_stream,
    wp::int32 & adj_seed,
    wp::int32 & adj_counter,
    wp::int32 & adj_stream,
    wp::vec_t<4, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/arrays/random.py:85
static void adj_gaussian_pair_0(
    wp::float32 var_u,
    wp::float32 var_v,
    wp::float32 & adj_u,
    wp::float32 & adj_v,
    wp::vec_t<2, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}

struct wp_args_measure_depth_kernel_ea4b01d5 {
    wp::int32 width;
    wp::int32 height;
    wp::int32 seed;
    wp::int32 frame;
    wp::array_t<wp::float32> depth;
    wp::array_t<wp::float32> incidence;
    wp::array_t<wp::float32> measured;
};


template <bool wp_linear_contiguous>
static void measure_depth_kernel_ea4b01d5_cpu_kernel_forward(
    wp::launch_bounds_t<1> dim,
    size_t task_index,
    wp_args_measure_depth_kernel_ea4b01d5 *_wp_args)
{
    static constexpr bool wp_linear_tid = wp_linear_contiguous;
    wp_args_measure_depth_kernel_ea4b01d5 wp_contiguous_args;
    if constexpr (wp_linear_contiguous)
    {
        wp_contiguous_args = *_wp_args;
        wp_contiguous_args.depth.strides[0] = sizeof(wp::float32);
        wp_contiguous_args.incidence.strides[0] = sizeof(wp::float32);
        wp_contiguous_args.measured.strides[0] = sizeof(wp::float32);
        _wp_args = &wp_contiguous_args;
    }
    //---------
    // argument vars
    wp::int32 var_width = _wp_args->width;
    wp::int32 var_height = _wp_args->height;
    wp::int32 var_seed = _wp_args->seed;
    wp::int32 var_frame = _wp_args->frame;
    wp::array_t<wp::float32> var_depth = _wp_args->depth;
    wp::array_t<wp::float32> var_incidence = _wp_args->incidence;
    wp::array_t<wp::float32> var_measured = _wp_args->measured;
    //---------
    // primal vars
    wp::int32 var_0;
    wp::float32* var_1;
    wp::float32 var_2;
    wp::float32 var_3;
    wp::int32 var_4;
    wp::int32 var_5;
    const wp::float32 var_6 = 0.0;
    wp::float32 var_7;
    wp::int32 var_8;
    wp::int32 var_9;
    const wp::int32 var_10 = 3;
    wp::int32 var_11;
    wp::int32 var_12;
    const wp::int32 var_13 = 1;
    wp::int32 var_14;
    const wp::int32 var_15 = 0;
    wp::int32 var_16;
    const wp::int32 var_17 = 1;
    wp::int32 var_18;
    wp::int32 var_19;
    const wp::int32 var_20 = 3;
    wp::int32 var_21;
    wp::int32 var_22;
    const wp::int32 var_23 = 1;
    wp::int32 var_24;
    const wp::int32 var_25 = 0;
    wp::int32 var_26;
    const wp::int32 var_27 = 1;
    wp::int32 var_28;
    wp::int32 var_29;
    wp::int32 var_30;
    wp::int32 var_31;
    wp::float32* var_32;
    wp::float32 var_33;
    wp::float32 var_34;
    wp::float32 var_35;
    wp::float32 var_36;
    wp::vec_t<4, wp::float32> var_37;
    const wp::float32 var_38 = 0.4;
    wp::float32 var_39;
    const wp::float32 var_40 = 0.0012;
    const wp::float32 var_41 = 0.0019;
    wp::float32 var_42;
    wp::float32 var_43;
    wp::float32 var_44;
    const wp::int32 var_45 = 0;
    wp::float32 var_46;
    const wp::int32 var_47 = 1;
    wp::float32 var_48;
    wp::vec_t<2, wp::float32> var_49;
    const wp::int32 var_50 = 0;
    wp::float32 var_51;
    wp::float32 var_52;
    wp::float32 var_53;
    const wp::int32 var_54 = 1;
    wp::int32 var_55;
    bool var_56;
    const wp::float32 var_57 = 0.3;
    bool var_58;
    const wp::float32 var_59 = 8.0;
    bool var_60;
    wp::float32* var_61;
    const wp::float32 var_62 = 0.17364818;
    bool var_63;
    wp::float32 var_64;
    const wp::int32 var_65 = 0;
    wp::int32 var_66;
    bool var_67;
    const wp::float32 var_68 = 0.04;
    wp::float32 var_69;
    bool var_70;
    const wp::int32 var_71 = 2;
    wp::float32 var_72;
    const wp::float32 var_73 = 0.7;
    bool var_74;
    const wp::int32 var_75 = 0;
    wp::int32 var_76;
    const wp::float32 var_77 = 0.0;
    wp::float32 var_78;
    const wp::int32 var_79 = 1;
    bool var_80;
    const wp::float32 var_81 = 1000.0;
    wp::float32 var_82;
    const wp::float32 var_83 = 0.5;
    wp::float32 var_84;
    wp::float32 var_85;
    const wp::float32 var_86 = 0.001;
    wp::float32 var_87;
    wp::float32 var_88;
    //---------
    // forward
    // def measure_depth_kernel(width, height, seed, frame, depth, incidence, measured):       <L 1>
    // i = tid()                                                                              <L 3>
    var_0 = builtin_tid1d();
    // z = depth[i]                                                                           <L 4>
    var_1 = wp::address(var_depth, var_0);
    var_3 = wp::load(var_1);
    var_2 = wp::copy(var_3);
    // column = i % width                                                                     <L 5>
    var_4 = wp::mod(var_0, var_width);
    // row = i // width                                                                       <L 6>
    var_5 = wp::floordiv(var_0, var_width);
    // jump = float(0.0)                                                                      <L 7>
    var_7 = wp::float(var_6);
    // for k in range(9):                                                                     <L 8>
    var_8 = 0;
    start_for_0:;
        if (var_8 >= 9) goto end_for_0;
        var_9 = var_8;
        var_8 += 1;
        // x = min(max(column + k % 3 - 1, 0), width - 1)                                     <L 9>
        var_11 = wp::mod(var_9, var_10);
        var_12 = wp::add(var_4, var_11);
        var_14 = wp::sub(var_12, var_13);
        var_16 = wp::max(var_14, var_15);
        var_18 = wp::sub(var_width, var_17);
        var_19 = wp::min(var_16, var_18);
        // y = min(max(row + k // 3 - 1, 0), height - 1)                                      <L 10>
        var_21 = wp::floordiv(var_9, var_20);
        var_22 = wp::add(var_5, var_21);
        var_24 = wp::sub(var_22, var_23);
        var_26 = wp::max(var_24, var_25);
        var_28 = wp::sub(var_height, var_27);
        var_29 = wp::min(var_26, var_28);
        // jump = max(jump, abs(depth[y * width + x] - z))                                    <L 11>
        var_30 = wp::mul(var_29, var_width);
        var_31 = wp::add(var_30, var_19);
        var_32 = wp::address(var_depth, var_31);
        var_34 = wp::load(var_32);
        var_33 = wp::sub(var_34, var_2);
        var_35 = wp::abs(var_33);
        var_36 = wp::max(var_7, var_35);
        wp::assign(var_7, var_36);
        goto start_for_0;
    end_for_0:;
    // u = random_uniform(seed, i, frame)                                                     <L 12>
    var_37 = random_uniform_0(var_seed, var_0, var_frame);
    // away = z - AXIAL_NEAREST                                                               <L 13>
    var_39 = wp::sub(var_2, var_38);
    // noisy = z + (AXIAL_BASE + AXIAL_GROWTH * away * away) * gaussian_pair(u[0], u[1])[0]       <L 14>
    var_42 = wp::mul(var_41, var_39);
    var_43 = wp::mul(var_42, var_39);
    var_44 = wp::add(var_40, var_43);
    var_46 = wp::extract(var_37, var_45);
    var_48 = wp::extract(var_37, var_47);
    var_49 = gaussian_pair_0(var_46, var_48);
    var_51 = wp::extract(var_49, var_50);
    var_52 = wp::mul(var_44, var_51);
    var_53 = wp::add(var_2, var_52);
    // is_valid = int(1)                                                                      <L 15>
    var_55 = wp::int(var_54);
    // if noisy < NEAREST or noisy > FARTHEST or incidence[i] < GRAZING:                      <L 16>
    var_58 = (var_53 < var_57);
    var_56 = var_58;
    if (!var_56) {
        var_60 = (var_53 > var_59);
        var_56 = var_56 || var_60;
    }
    if (!var_56) {
        var_61 = wp::address(var_incidence, var_0);
        var_64 = wp::load(var_61);
        var_63 = (var_64 < var_62);
        var_56 = var_56 || var_63;
    }
    if (var_56) {
        // is_valid = 0                                                                       <L 17>
    }
    var_66 = wp::where(var_56, var_65, var_55);
    // if jump > EDGE_JUMP * z and u[2] < EDGE_LOSS:                                          <L 18>
    var_69 = wp::mul(var_68, var_2);
    var_70 = (var_7 > var_69);
    var_67 = var_70;
    if (var_67) {
        var_72 = wp::extract(var_37, var_71);
        var_74 = (var_72 < var_73);
        var_67 = var_67 && var_74;
    }
    if (var_67) {
        // is_valid = 0                                                                       <L 19>
    }
    var_76 = wp::where(var_67, var_75, var_66);
    // value = float(0.0)                                                                     <L 20>
    var_78 = wp::float(var_77);
    // if is_valid == 1:                                                                      <L 21>
    var_80 = (var_76 == var_79);
    if (var_80) {
        // value = floor(noisy * 1000.0 + 0.5) * 0.001                                        <L 22>
        var_82 = wp::mul(var_53, var_81);
        var_84 = wp::add(var_82, var_83);
        var_85 = wp::floor(var_84);
        var_87 = wp::mul(var_85, var_86);
    }
    var_88 = wp::where(var_80, var_87, var_78);
    // measured[i] = value                                                                    <L 23>
    wp::array_store(var_measured, var_0, var_88);
}



template <bool wp_linear_contiguous>
static WP_FORCEINLINE void measure_depth_kernel_ea4b01d5_cpu_forward_tasks(
    wp::launch_bounds_t<1> *dim,
    wp_args_measure_depth_kernel_ea4b01d5 *_wp_args)
{
    for (size_t task_index = 0; task_index < dim->size; ++task_index)
    {
        measure_depth_kernel_ea4b01d5_cpu_kernel_forward<wp_linear_contiguous>(*dim, task_index, _wp_args);
    }
}

static WP_FORCEINLINE void measure_depth_kernel_ea4b01d5_cpu_forward_dispatch(
    wp::launch_bounds_t<1> *dim,
    wp_args_measure_depth_kernel_ea4b01d5 *_wp_args)
{
    wp::tile_shared_storage_t tile_mem;
#if defined(WP_ENABLE_TILES_IN_STACK_MEMORY)
    wp::shared_tile_storage = &tile_mem;
#endif

    const bool wp_linear_contiguous = dim->coord_mult == 1 && ((_wp_args->depth.strides[0] == (int)sizeof(wp::float32)) & (_wp_args->incidence.strides[0] == (int)sizeof(wp::float32)) & (_wp_args->measured.strides[0] == (int)sizeof(wp::float32)));
    if (wp_linear_contiguous)
        measure_depth_kernel_ea4b01d5_cpu_forward_tasks<true>(dim, _wp_args);
    else
        measure_depth_kernel_ea4b01d5_cpu_forward_tasks<false>(dim, _wp_args);
}

extern "C" {

// Python CPU entry points
WP_API void measure_depth_kernel_ea4b01d5_cpu_forward(
    wp::launch_bounds_t<1> *dim,
    wp_args_measure_depth_kernel_ea4b01d5 *_wp_args)
{
    measure_depth_kernel_ea4b01d5_cpu_forward_dispatch(dim, _wp_args);
}

} // extern C


#define WP_NO_BFLOAT16

#define WP_TILE_BLOCK_DIM 256
#define WP_NO_CRT
#include "builtin.h"
#include "deterministic.h"

// Map wp.breakpoint() to a device brkpt at the call site so cuda-gdb attributes the stop to the generated .cu line
#if defined(__CUDACC__) && !defined(_MSC_VER)
#define __debugbreak() __brkpt()
#endif

#define builtin_tid1d() wp::tid(_idx, dim)
#define builtin_tid2d(x, y) wp::tid(x, y, _idx, dim)
#define builtin_tid3d(x, y, z) wp::tid(x, y, z, _idx, dim)
#define builtin_tid4d(x, y, z, w) wp::tid(x, y, z, w, _idx, dim)

#define builtin_block_dim() wp::block_dim()

// CUDA Thread Block Cluster shape declaration. Expands to __cluster_dims__
// only on devices that support clusters (compute capability 9.0+); otherwise
// expands to nothing so the same source compiles cleanly for any target arch.
#if defined(__CUDA_ARCH__) && (__CUDA_ARCH__ >= 900)
#define WP_CLUSTER_DIMS(x, y, z) __cluster_dims__(x, y, z)
#else
#define WP_CLUSTER_DIMS(x, y, z)
#endif

// Maximum registers per thread. __maxnreg__ was added in CUDA Toolkit 12.4;
// older toolkits ignore the opt-in so the same source remains compilable.
#if defined(__CUDACC_VER_MAJOR__) && (__CUDACC_VER_MAJOR__ > 12 || (__CUDACC_VER_MAJOR__ == 12 && __CUDACC_VER_MINOR__ >= 4))
#define WP_MAXNREG(n) __maxnreg__(n)
#else
#define WP_MAXNREG(n)
#endif

// Allow PTXAS to spill registers into shared memory. CUDA Toolkit 13.0
// introduced the pragma, which is unavailable in device-debug compilation.
#if defined(__CUDACC_VER_MAJOR__) && (__CUDACC_VER_MAJOR__ >= 13) && !defined(_DEBUG)
#define WP_ENABLE_SMEM_SPILLING() asm volatile(".pragma \"enable_smem_spilling\";");
#else
#define WP_ENABLE_SMEM_SPILLING()
#endif

// Overloads for the CUDA code that Warp generates, included after Warp's headers: arrays are contiguous (launches check
// it) and indices are not negative, which saves a 64-bit product, a comparison and an addition per element.

namespace wp {

template <typename T> inline CUDA_CALLABLE T* element(const array_t<T>& a, int i) { return a.data + i; }
template <typename T> inline CUDA_CALLABLE T* element(const array_t<T>& a, int i, int j)
{
    return a.data + ((long long)i * a.shape[1] + j);
}
template <typename T> inline CUDA_CALLABLE T* element(const array_t<T>& a, int i, int j, int k)
{
    return a.data + (((long long)i * a.shape[1] + j) * a.shape[2] + k);
}

template <typename T> inline CUDA_CALLABLE T* address(const array_t<T>& a, int i) { return element(a, i); }
template <typename T> inline CUDA_CALLABLE T* address(const array_t<T>& a, int i, int j) { return element(a, i, j); }
template <typename T> inline CUDA_CALLABLE T* address(const array_t<T>& a, int i, int j, int k) { return element(a, i, j, k); }

template <typename T> inline CUDA_CALLABLE void array_store(const array_t<T>& a, int i, T value) { *element(a, i) = value; }
template <typename T> inline CUDA_CALLABLE void array_store(const array_t<T>& a, int i, int j, T value)
{
    *element(a, i, j) = value;
}
template <typename T> inline CUDA_CALLABLE void array_store(const array_t<T>& a, int i, int j, int k, T value)
{
    *element(a, i, j, k) = value;
}

template <typename T> inline CUDA_CALLABLE T atomic_add(const array_t<T>& a, int i, T value)
{
    return atomic_add(element(a, i), value);
}
template <typename T> inline CUDA_CALLABLE T atomic_min(const array_t<T>& a, int i, T value)
{
    return atomic_min(element(a, i), value);
}
template <typename T> inline CUDA_CALLABLE T atomic_max(const array_t<T>& a, int i, T value)
{
    return atomic_max(element(a, i), value);
}
template <typename T> inline CUDA_CALLABLE T atomic_add(const array_t<T>& a, int i, int j, T value)
{
    return atomic_add(element(a, i, j), value);
}
template <typename T> inline CUDA_CALLABLE T atomic_min(const array_t<T>& a, int i, int j, T value)
{
    return atomic_min(element(a, i, j), value);
}
template <typename T> inline CUDA_CALLABLE T atomic_max(const array_t<T>& a, int i, int j, T value)
{
    return atomic_max(element(a, i, j), value);
}

// Warp's version divides by the number of threads per element, and the compiler duplicates the kernel's body for more
// than one. Here each thread has its own element.
inline CUDA_CALLABLE int tid(size_t index, const launch_bounds_t<1>& bounds) { return int(index); }

}

// avoid namespacing of float type for casting to float type, this is to avoid wp::float(x), which is not valid in C++
#define float(x) cast_float(x)
#define adj_float(x, adj_x, adj_ret) adj_cast_float(x, adj_x, adj_ret)

#define int(x) cast_int(x)
#define adj_int(x, adj_x, adj_ret) adj_cast_int(x, adj_x, adj_ret)


// /work/main/src/pointloom/kernels/algebra/transform.py:27
static CUDA_CALLABLE wp::vec_t<3, wp::float64> widen_0(
    wp::vec_t<3, wp::float32> var_p)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    wp::float64 var_2;
    const wp::int32 var_3 = 1;
    wp::float32 var_4;
    wp::float64 var_5;
    const wp::int32 var_6 = 2;
    wp::float32 var_7;
    wp::float64 var_8;
    wp::vec_t<3, wp::float64> var_9;
    //---------
    // forward
    // def widen(p: vec3) -> vec3d:                                                           <L 28>
    // return vec3d(float64(p[0]), float64(p[1]), float64(p[2]))                              <L 29>
    var_1 = wp::extract(var_p, var_0);
    var_2 = wp::float64(var_1);
    var_4 = wp::extract(var_p, var_3);
    var_5 = wp::float64(var_4);
    var_7 = wp::extract(var_p, var_6);
    var_8 = wp::float64(var_7);
    var_9 = wp::vec_t<3, wp::float64>(var_2, var_5, var_8);
    return var_9;
}


// /work/main/src/pointloom/kernels/odometry/local_cells.py:9
static CUDA_CALLABLE wp::vec_t<3, wp::int32> cell_holding_0(
    wp::vec_t<3, wp::float64> var_x,
    wp::float64 var_size)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float64 var_1;
    wp::float64 var_2;
    wp::float64 var_3;
    wp::int32 var_4;
    const wp::int32 var_5 = 1;
    wp::float64 var_6;
    wp::float64 var_7;
    wp::float64 var_8;
    wp::int32 var_9;
    const wp::int32 var_10 = 2;
    wp::float64 var_11;
    wp::float64 var_12;
    wp::float64 var_13;
    wp::int32 var_14;
    wp::vec_t<3, wp::int32> var_15;
    //---------
    // forward
    // def cell_holding(x: vec3d, size: float64) -> vec3i:                                    <L 10>
    // return vec3i(int(floor(x[0] / size)), int(floor(x[1] / size)), int(floor(x[2] / size)))       <L 11>
    var_1 = wp::extract(var_x, var_0);
    var_2 = wp::div(var_1, var_size);
    var_3 = wp::floor(var_2);
    var_4 = wp::int(var_3);
    var_6 = wp::extract(var_x, var_5);
    var_7 = wp::div(var_6, var_size);
    var_8 = wp::floor(var_7);
    var_9 = wp::int(var_8);
    var_11 = wp::extract(var_x, var_10);
    var_12 = wp::div(var_11, var_size);
    var_13 = wp::floor(var_12);
    var_14 = wp::int(var_13);
    var_15 = wp::vec_t<3, wp::int32>(var_4, var_9, var_14);
    return var_15;
}


// <pointloom.kernels.odometry.local_cells.local_key>:1
static CUDA_CALLABLE wp::int64 local_key_0(
    wp::vec_t<3, wp::int32> var_cell,
    wp::vec_t<3, wp::int32> var_cells__first,
    wp::int32 var_cells__bits)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    const wp::int32 var_2 = 0;
    wp::int32 var_3;
    wp::int32 var_4;
    wp::int64 var_5;
    const wp::int32 var_6 = 1;
    wp::int32 var_7;
    const wp::int32 var_8 = 1;
    wp::int32 var_9;
    wp::int32 var_10;
    wp::int64 var_11;
    const wp::int32 var_12 = 2;
    wp::int32 var_13;
    const wp::int32 var_14 = 2;
    wp::int32 var_15;
    wp::int32 var_16;
    wp::int64 var_17;
    wp::int64 var_18;
    wp::int64 var_19;
    wp::int64 var_20;
    wp::int64 var_21;
    wp::int64 var_22;
    wp::int64 var_23;
    //---------
    // forward
    // def local_key(cell, cells__first, cells__bits):                                        <L 1>
    // x = int64(cell[0] - cells__first[0])                                                   <L 2>
    var_1 = wp::extract(var_cell, var_0);
    var_3 = wp::extract(var_cells__first, var_2);
    var_4 = wp::sub(var_1, var_3);
    var_5 = wp::int64(var_4);
    // y = int64(cell[1] - cells__first[1])                                                   <L 3>
    var_7 = wp::extract(var_cell, var_6);
    var_9 = wp::extract(var_cells__first, var_8);
    var_10 = wp::sub(var_7, var_9);
    var_11 = wp::int64(var_10);
    // z = int64(cell[2] - cells__first[2])                                                   <L 4>
    var_13 = wp::extract(var_cell, var_12);
    var_15 = wp::extract(var_cells__first, var_14);
    var_16 = wp::sub(var_13, var_15);
    var_17 = wp::int64(var_16);
    // return (x << int64(cells__bits) | y) << int64(cells__bits) | z                         <L 5>
    var_18 = wp::int64(var_cells__bits);
    var_19 = wp::lshift(var_5, var_18);
    var_20 = wp::bit_or(var_19, var_11);
    var_21 = wp::int64(var_cells__bits);
    var_22 = wp::lshift(var_20, var_21);
    var_23 = wp::bit_or(var_22, var_17);
    return var_23;
}


// <pointloom.kernels.odometry.odometry_sampling.key_in_range>:1
static CUDA_CALLABLE wp::int64 key_in_range_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::float64 var_min_range,
    wp::float64 var_max_range,
    wp::float64 var_cells__size,
    wp::vec_t<3, wp::int32> var_cells__first,
    wp::int32 var_cells__bits,
    wp::int64 var_cells__skipped)
{
    //---------
    // primal vars
    wp::int64 var_0;
    bool var_1;
    wp::vec_t<3, wp::float64> var_2;
    const wp::int32 var_3 = 0;
    wp::float64 var_4;
    const wp::int32 var_5 = 0;
    wp::float64 var_6;
    wp::float64 var_7;
    const wp::int32 var_8 = 1;
    wp::float64 var_9;
    const wp::int32 var_10 = 1;
    wp::float64 var_11;
    wp::float64 var_12;
    wp::float64 var_13;
    const wp::int32 var_14 = 2;
    wp::float64 var_15;
    const wp::int32 var_16 = 2;
    wp::float64 var_17;
    wp::float64 var_18;
    wp::float64 var_19;
    bool var_20;
    wp::float64 var_21;
    bool var_22;
    wp::float64 var_23;
    bool var_24;
    wp::vec_t<3, wp::int32> var_25;
    wp::int64 var_26;
    wp::int64 var_27;
    wp::int64 var_28;
    //---------
    // forward
    // def key_in_range(p, min_range, max_range, cells__size, cells__first, cells__bits, cells__skipped):       <L 1>
    // key = cells__skipped                                                                   <L 3>
    var_0 = wp::copy(var_cells__skipped);
    // if isfinite(p):                                                                        <L 4>
    var_1 = wp::isfinite(var_p);
    if (var_1) {
        // x = widen(p)                                                                       <L 5>
        var_2 = widen_0(var_p);
        // sqdist = x[0] * x[0] + x[1] * x[1] + x[2] * x[2]                                   <L 6>
        var_4 = wp::extract(var_2, var_3);
        var_6 = wp::extract(var_2, var_5);
        var_7 = wp::mul(var_4, var_6);
        var_9 = wp::extract(var_2, var_8);
        var_11 = wp::extract(var_2, var_10);
        var_12 = wp::mul(var_9, var_11);
        var_13 = wp::add(var_7, var_12);
        var_15 = wp::extract(var_2, var_14);
        var_17 = wp::extract(var_2, var_16);
        var_18 = wp::mul(var_15, var_17);
        var_19 = wp::add(var_13, var_18);
        // if sqdist > min_range * min_range and sqdist < max_range * max_range:              <L 7>
        var_21 = wp::mul(var_min_range, var_min_range);
        var_22 = (var_19 > var_21);
        var_20 = var_22;
        if (var_20) {
            var_23 = wp::mul(var_max_range, var_max_range);
            var_24 = (var_19 < var_23);
            var_20 = var_20 && var_24;
        }
        if (var_20) {
            // key = local_key(cell_holding(x, cells__size), cells__first, cells__bits)       <L 8>
            var_25 = cell_holding_0(var_2, var_cells__size);
            var_26 = local_key_0(var_25, var_cells__first, var_cells__bits);
        }
        var_27 = wp::where(var_20, var_26, var_0);
    }
    var_28 = wp::where(var_1, var_27, var_0);
    // return key                                                                             <L 9>
    return var_28;
}


// <pointloom.kernels.arrays.hash_table.mix_bits>:1
static CUDA_CALLABLE wp::int64 mix_bits_0(
    wp::int64 var_key)
{
    //---------
    // primal vars
    wp::int64 var_0;
    wp::int64 var_1;
    wp::int64 var_2;
    wp::int64 var_3;
    wp::int64 var_4;
    wp::int64 var_5;
    wp::int64 var_6;
    wp::int64 var_7;
    wp::int64 var_8;
    wp::int64 var_9;
    wp::int64 var_10;
    wp::int64 var_11;
    //---------
    // forward
    // def mix_bits(key):                                                                     <L 1>
    // h = key ^ key >> int64(33) & int64(2147483647)                                         <L 3>
    var_0 = 33ll;
    var_1 = wp::rshift(var_key, var_0);
    var_2 = 2147483647ll;
    var_3 = wp::bit_and(var_1, var_2);
    var_4 = wp::bit_xor(var_key, var_3);
    // h = h * int64(-49064778989728563)                                                      <L 4>
    var_5 = -49064778989728563ll;
    var_6 = wp::mul(var_4, var_5);
    // return h ^ h >> int64(29) & int64(34359738367)                                         <L 5>
    var_7 = 29ll;
    var_8 = wp::rshift(var_6, var_7);
    var_9 = 34359738367ll;
    var_10 = wp::bit_and(var_8, var_9);
    var_11 = wp::bit_xor(var_6, var_10);
    return var_11;
}


// <pointloom.kernels.arrays.hash_table.insert_entry>:1
static CUDA_CALLABLE void insert_entry_0(
    wp::int64 var_entry,
    wp::int32 var_low_bits,
    wp::array_t<wp::int64> var_entries,
    wp::int64 var_mask)
{
    //---------
    // primal vars
    wp::int64 var_0;
    wp::int64 var_1;
    wp::int64 var_2;
    wp::int64 var_3;
    wp::int64 var_4;
    const wp::int32 var_5 = 1;
    wp::int32 var_6;
    const wp::int32 var_7 = 1;
    bool var_8;
    wp::int32 var_9;
    wp::int64 var_10;
    bool var_11;
    wp::int64 var_12;
    bool var_13;
    wp::int64 var_14;
    wp::int64 var_15;
    wp::int64 var_16;
    wp::int64 var_17;
    bool var_18;
    const wp::int32 var_19 = 0;
    bool var_20;
    wp::int64 var_21;
    wp::int64 var_22;
    wp::int64 var_23;
    wp::int64 var_24;
    wp::int64 var_25;
    wp::int64 var_26;
    wp::int64 var_27;
    wp::int32 var_28;
    //---------
    // forward
    // def insert_entry(entry, low_bits, entries, mask):                                      <L 1>
    // carried = entry                                                                        <L 3>
    var_0 = wp::copy(var_entry);
    // slot = mix_bits(carried >> int64(low_bits)) & mask                                     <L 4>
    var_1 = wp::int64(var_low_bits);
    var_2 = wp::rshift(var_0, var_1);
    var_3 = mix_bits_0(var_2);
    var_4 = wp::bit_and(var_3, var_mask);
    // carrying = int(1)                                                                      <L 5>
    var_6 = wp::int(var_5);
    // while carrying == 1:                                                                   <L 6>
    start_while_0:;
    var_8 = (var_6 == var_7);
    if ((var_8) == false) goto end_while_0;
        // old = atomic_min(entries, int(slot), carried)                                      <L 7>
        var_9 = wp::int(var_4);
        var_10 = wp::atomic_min(var_entries, var_9, var_0);
        // if old == int64(EMPTY) or old >> int64(low_bits) == carried >> int64(low_bits):       <L 8>
        var_12 = 9223372036854775807ll;
        var_13 = (var_10 == var_12);
        var_11 = var_13;
        if (!var_11) {
            var_14 = wp::int64(var_low_bits);
            var_15 = wp::rshift(var_10, var_14);
            var_16 = wp::int64(var_low_bits);
            var_17 = wp::rshift(var_0, var_16);
            var_18 = (var_15 == var_17);
            var_11 = var_11 || var_18;
        }
        if (var_11) {
            // carrying = 0                                                                   <L 9>
        }
        if (!var_11) {
            // if old > carried:                                                              <L 11>
            var_20 = (var_10 > var_0);
            if (var_20) {
                // carried = old                                                              <L 12>
                var_21 = wp::copy(var_10);
            }
            var_22 = wp::where(var_20, var_21, var_0);
            // slot = slot + int64(1) & mask                                                  <L 13>
            var_23 = 1ll;
            var_24 = wp::add(var_4, var_23);
            var_25 = wp::bit_and(var_24, var_mask);
        }
        var_26 = wp::where(var_11, var_0, var_22);
        var_27 = wp::where(var_11, var_4, var_25);
        var_28 = wp::where(var_11, var_19, var_6);
        wp::assign(var_0, var_26);
        wp::assign(var_4, var_27);
        wp::assign(var_6, var_28);
    goto start_while_0;
    end_while_0:;
}


// /work/main/src/pointloom/kernels/algebra/transform.py:32
static CUDA_CALLABLE wp::vec_t<3, wp::float32> narrow_0(
    wp::vec_t<3, wp::float64> var_p)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float64 var_1;
    wp::float32 var_2;
    const wp::int32 var_3 = 1;
    wp::float64 var_4;
    wp::float32 var_5;
    const wp::int32 var_6 = 2;
    wp::float64 var_7;
    wp::float32 var_8;
    wp::vec_t<3, wp::float32> var_9;
    //---------
    // forward
    // def narrow(p: vec3d) -> vec3:                                                          <L 33>
    // return vec3(float(p[0]), float(p[1]), float(p[2]))                                     <L 34>
    var_1 = wp::extract(var_p, var_0);
    var_2 = wp::float(var_1);
    var_4 = wp::extract(var_p, var_3);
    var_5 = wp::float(var_4);
    var_7 = wp::extract(var_p, var_6);
    var_8 = wp::float(var_7);
    var_9 = wp::vec_t<3, wp::float32>(var_2, var_5, var_8);
    return var_9;
}


// /work/main/src/pointloom/kernels/algebra/transform.py:27
static CUDA_CALLABLE void adj_widen_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/odometry/local_cells.py:9
static CUDA_CALLABLE void adj_cell_holding_0(
    wp::vec_t<3, wp::float64> var_x,
    wp::float64 var_size,
    wp::vec_t<3, wp::float64> & adj_x,
    wp::float64 & adj_size,
    wp::vec_t<3, wp::int32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.odometry.local_cells.local_key>:1
static CUDA_CALLABLE void adj_local_key_0(
    wp::vec_t<3, wp::int32> var_cell,
    wp::vec_t<3, wp::int32> var_cells__first,
    wp::int32 var_cells__bits,
    wp::vec_t<3, wp::int32> & adj_cell,
    wp::vec_t<3, wp::int32> & adj_cells__first,
    wp::int32 & adj_cells__bits,
    wp::int64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.odometry.odometry_sampling.key_in_range>:1
static CUDA_CALLABLE void adj_key_in_range_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::float64 var_min_range,
    wp::float64 var_max_range,
    wp::float64 var_cells__size,
    wp::vec_t<3, wp::int32> var_cells__first,
    wp::int32 var_cells__bits,
    wp::int64 var_cells__skipped,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::float64 & adj_min_range,
    wp::float64 & adj_max_range,
    wp::float64 & adj_cells__size,
    wp::vec_t<3, wp::int32> & adj_cells__first,
    wp::int32 & adj_cells__bits,
    wp::int64 & adj_cells__skipped,
    wp::int64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.arrays.hash_table.mix_bits>:1
static CUDA_CALLABLE void adj_mix_bits_0(
    wp::int64 var_key,
    wp::int64 & adj_key,
    wp::int64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.arrays.hash_table.insert_entry>:1
static CUDA_CALLABLE void adj_insert_entry_0(
    wp::int64 var_entry,
    wp::int32 var_low_bits,
    wp::array_t<wp::int64> var_entries,
    wp::int64 var_mask,
    wp::int64 & adj_entry,
    wp::int32 & adj_low_bits,
    wp::array_t<wp::int64> & adj_entries,
    wp::int64 & adj_mask)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/algebra/transform.py:32
static CUDA_CALLABLE void adj_narrow_0(
    wp::vec_t<3, wp::float64> var_p,
    wp::vec_t<3, wp::float64> & adj_p,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void keep_firsts_kernel_028953eb_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::array_t<wp::int32> var_ranks,
    wp::int32 var_level,
    wp::array_t<wp::vec_t<3, wp::float32>> var_selected,
    wp::array_t<wp::int32> var_counts)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::shape_t* var_1;
        const wp::int32 var_2 = 0;
        wp::int32 var_3;
        wp::shape_t var_4;
        const wp::int32 var_5 = 1;
        wp::int32 var_6;
        wp::int32* var_7;
        wp::int32 var_8;
        wp::int32 var_9;
        const wp::int32 var_10 = 0;
        wp::int32 var_11;
        const wp::int32 var_12 = 0;
        bool var_13;
        const wp::int32 var_14 = 1;
        wp::int32 var_15;
        wp::int32* var_16;
        wp::int32 var_17;
        wp::int32 var_18;
        wp::int32 var_19;
        wp::int32* var_20;
        bool var_21;
        wp::int32 var_22;
        wp::vec_t<3, wp::float32>* var_23;
        wp::vec_t<3, wp::float32> var_24;
        wp::vec_t<3, wp::float32> var_25;
        bool var_26;
        const wp::float32 var_27 = NAN;
        wp::vec_t<3, wp::float32> var_28;
        const wp::int32 var_29 = 0;
        bool var_30;
        //---------
        // forward
        // def keep_firsts_kernel(points, ranks, level, selected, counts):                        <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // total = ranks[ranks.shape[0] - 1]                                                      <L 4>
        var_1 = &(var_ranks.shape);
        var_4 = wp::load(var_1);
        var_3 = wp::extract(var_4, var_2);
        var_6 = wp::sub(var_3, var_5);
        var_7 = wp::address(var_ranks, var_6);
        var_9 = wp::load(var_7);
        var_8 = wp::copy(var_9);
        // before = int(0)                                                                        <L 5>
        var_11 = wp::int(var_10);
        // if i > 0:                                                                              <L 6>
        var_13 = (var_0 > var_12);
        if (var_13) {
            // before = ranks[i - 1]                                                              <L 7>
            var_15 = wp::sub(var_0, var_14);
            var_16 = wp::address(var_ranks, var_15);
            var_18 = wp::load(var_16);
            var_17 = wp::copy(var_18);
        }
        var_19 = wp::where(var_13, var_17, var_11);
        // if ranks[i] > before:                                                                  <L 8>
        var_20 = wp::address(var_ranks, var_0);
        var_22 = wp::load(var_20);
        var_21 = (var_22 > var_19);
        if (var_21) {
            // selected[before] = points[i]                                                       <L 9>
            var_23 = wp::address(var_points, var_0);
            var_25 = wp::load(var_23);
            var_24 = wp::copy(var_25);
            wp::array_store(var_selected, var_19, var_24);
        }
        // if i >= total:                                                                         <L 10>
        var_26 = (var_0 >= var_8);
        if (var_26) {
            // selected[i] = vec3(NAN, NAN, NAN)                                                  <L 11>
            var_28 = wp::vec_t<3, wp::float32>(var_27, var_27, var_27);
            wp::array_store(var_selected, var_0, var_28);
        }
        // if i == 0:                                                                             <L 12>
        var_30 = (var_0 == var_29);
        if (var_30) {
            // counts[level] = total                                                              <L 13>
            wp::array_store(var_counts, var_level, var_8);
        }
}



extern "C" __global__ void count_entries_kernel_1c0c5bcf_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int64> var_entries,
    wp::int32 var_index_bits,
    wp::array_t<wp::int32> var_ranks)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::int64* var_1;
        wp::int64 var_2;
        wp::int64 var_3;
        wp::int64 var_4;
        bool var_5;
        const wp::int32 var_6 = 1;
        wp::int64 var_7;
        wp::int64 var_8;
        wp::int64 var_9;
        wp::int64 var_10;
        wp::int64 var_11;
        wp::int64 var_12;
        wp::int32 var_13;
        //---------
        // forward
        // def count_entries_kernel(entries, index_bits, ranks):                                  <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // entry = entries[i]                                                                     <L 3>
        var_1 = wp::address(var_entries, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // if entry != int64(EMPTY):                                                              <L 4>
        var_4 = 9223372036854775807ll;
        var_5 = (var_2 != var_4);
        if (var_5) {
            // ranks[int(entry & (int64(1) << int64(index_bits)) - int64(1))] = 1                 <L 5>
            var_7 = 1ll;
            var_8 = wp::int64(var_index_bits);
            var_9 = wp::lshift(var_7, var_8);
            var_10 = 1ll;
            var_11 = wp::sub(var_9, var_10);
            var_12 = wp::bit_and(var_2, var_11);
            var_13 = wp::int(var_12);
            wp::array_store(var_ranks, var_13, var_6);
        }
}



extern "C" __global__ void mark_entries_kernel_1c55c005_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int64> var_entries,
    wp::int32 var_index_bits,
    wp::array_t<wp::uint8> var_marks)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::int64* var_1;
        wp::int64 var_2;
        wp::int64 var_3;
        wp::int64 var_4;
        bool var_5;
        const wp::int32 var_6 = 1;
        wp::uint8 var_7;
        wp::int64 var_8;
        wp::int64 var_9;
        wp::int64 var_10;
        wp::int64 var_11;
        wp::int64 var_12;
        wp::int64 var_13;
        wp::int32 var_14;
        //---------
        // forward
        // def mark_entries_kernel(entries, index_bits, marks):                                   <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // entry = entries[i]                                                                     <L 3>
        var_1 = wp::address(var_entries, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // if entry != int64(EMPTY):                                                              <L 4>
        var_4 = 9223372036854775807ll;
        var_5 = (var_2 != var_4);
        if (var_5) {
            // marks[int(entry & (int64(1) << int64(index_bits)) - int64(1))] = uint8(1)          <L 5>
            var_7 = wp::uint8(var_6);
            var_8 = 1ll;
            var_9 = wp::int64(var_index_bits);
            var_10 = wp::lshift(var_8, var_9);
            var_11 = 1ll;
            var_12 = wp::sub(var_10, var_11);
            var_13 = wp::bit_and(var_2, var_12);
            var_14 = wp::int(var_13);
            wp::array_store(var_marks, var_14, var_7);
        }
}



extern "C" __global__ void enter_points_kernel_4660c452_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::float64 var_min_range,
    wp::float64 var_max_range,
    wp::float64 var_cells__size,
    wp::vec_t<3, wp::int32> var_cells__first,
    wp::int32 var_cells__bits,
    wp::int64 var_cells__skipped,
    wp::int32 var_index_bits,
    wp::int64 var_mask,
    wp::array_t<wp::int64> var_entries)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::vec_t<3, wp::float32>* var_1;
        wp::int64 var_2;
        wp::vec_t<3, wp::float32> var_3;
        bool var_4;
        wp::int64 var_5;
        wp::int64 var_6;
        wp::int64 var_7;
        wp::int64 var_8;
        //---------
        // forward
        // def enter_points_kernel(points, min_range, max_range, cells__size, cells__first, cells__bits, cells__skipped, index_bits, mask, entries):       <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // key = key_in_range(points[i], min_range, max_range, cells__size, cells__first, cells__bits, cells__skipped)       <L 3>
        var_1 = wp::address(var_points, var_0);
        var_3 = wp::load(var_1);
        var_2 = key_in_range_0(var_3, var_min_range, var_max_range, var_cells__size, var_cells__first, var_cells__bits, var_cells__skipped);
        // if key != cells__skipped:                                                              <L 4>
        var_4 = (var_2 != var_cells__skipped);
        if (var_4) {
            // insert_entry(key << int64(index_bits) | int64(i), index_bits, entries, mask)       <L 5>
            var_5 = wp::int64(var_index_bits);
            var_6 = wp::lshift(var_2, var_5);
            var_7 = wp::int64(var_0);
            var_8 = wp::bit_or(var_6, var_7);
            insert_entry_0(var_8, var_index_bits, var_entries, var_mask);
        }
}



extern "C" __global__ void encode_in_range_kernel_76955f68_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::float64 var_min_range,
    wp::float64 var_max_range,
    wp::float64 var_cells__size,
    wp::vec_t<3, wp::int32> var_cells__first,
    wp::int32 var_cells__bits,
    wp::int64 var_cells__skipped,
    wp::array_t<wp::int64> var_keys)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::vec_t<3, wp::float32>* var_1;
        wp::int64 var_2;
        wp::vec_t<3, wp::float32> var_3;
        //---------
        // forward
        // def encode_in_range_kernel(points, min_range, max_range, cells__size, cells__first, cells__bits, cells__skipped, keys):       <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // keys[i] = key_in_range(points[i], min_range, max_range, cells__size, cells__first, cells__bits, cells__skipped)       <L 3>
        var_1 = wp::address(var_points, var_0);
        var_3 = wp::load(var_1);
        var_2 = key_in_range_0(var_3, var_min_range, var_max_range, var_cells__size, var_cells__first, var_cells__bits, var_cells__skipped);
        wp::array_store(var_keys, var_0, var_2);
}



extern "C" __global__ void shift_points_kernel_9ed1ba41_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::vec_t<3, wp::float64> var_origin,
    wp::array_t<wp::vec_t<3, wp::float32>> var_out)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::vec_t<3, wp::float32>* var_1;
        wp::vec_t<3, wp::float64> var_2;
        wp::vec_t<3, wp::float32> var_3;
        wp::vec_t<3, wp::float64> var_4;
        wp::vec_t<3, wp::float32> var_5;
        //---------
        // forward
        // def shift_points_kernel(points: array(dtype=vec3), origin: vec3d, out: array(dtype=vec3)):       <L 24>
        // i = tid()                                                                              <L 25>
        var_0 = builtin_tid1d();
        // out[i] = narrow(widen(points[i]) + origin)                                             <L 26>
        var_1 = wp::address(var_points, var_0);
        var_3 = wp::load(var_1);
        var_2 = widen_0(var_3);
        var_4 = wp::add(var_2, var_origin);
        var_5 = narrow_0(var_4);
        wp::array_store(var_out, var_0, var_5);
}



extern "C" __global__ void mark_firsts_kernel_d7db3f99_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_groups__order,
    wp::array_t<wp::int32> var_groups__starts,
    wp::array_t<wp::uint8> var_marks)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        const wp::int32 var_1 = 1;
        wp::uint8 var_2;
        wp::int32* var_3;
        wp::int32 var_4;
        wp::int32* var_5;
        wp::int32 var_6;
        //---------
        // forward
        // def mark_firsts_kernel(groups__order, groups__starts, marks):                          <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // marks[groups__order[groups__starts[i]]] = uint8(1)                                     <L 3>
        var_2 = wp::uint8(var_1);
        var_3 = wp::address(var_groups__starts, var_0);
        var_4 = wp::load(var_3);
        var_5 = wp::address(var_groups__order, var_4);
        var_6 = wp::load(var_5);
        wp::array_store(var_marks, var_6, var_2);
}


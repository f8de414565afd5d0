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


// <pointloom.kernels.arrays.runs.row_of>:1
static CUDA_CALLABLE wp::int32 row_of_0(
    wp::int32 var_i,
    wp::int32 var_runs__rows)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 32;
    wp::int32 var_1;
    wp::int32 var_2;
    //---------
    // forward
    // def row_of(i, runs__rows):                                                             <L 1>
    // return i // WARP % runs__rows                                                          <L 3>
    var_1 = wp::floordiv(var_i, var_0);
    var_2 = wp::mod(var_1, var_runs__rows);
    return var_2;
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:174
static CUDA_CALLABLE wp::int32 _shuffle_xor_0(
    wp::int32 x,
    wp::int32 mask)
{
return __shfl_xor_sync(0xffffffffu, x, mask);}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:178
static CUDA_CALLABLE wp::float32 _shuffle_xor_1(
    wp::float32 x,
    wp::int32 mask)
{
return __shfl_xor_sync(0xffffffffu, x, mask);}


// /work/main/src/pointloom/kernels/arrays/lanes.py:9
static CUDA_CALLABLE wp::float32 lane_min_on_cuda_0(
    wp::float32 var_x)
{
    //---------
    // primal vars
    wp::float32 var_0;
    const wp::int32 var_1 = 0;
    const wp::int32 var_2 = 1;
    wp::int32 var_3;
    wp::float32 var_4;
    wp::float32 var_5;
    const wp::int32 var_6 = 1;
    const wp::int32 var_7 = 1;
    wp::int32 var_8;
    wp::float32 var_9;
    wp::float32 var_10;
    const wp::int32 var_11 = 2;
    const wp::int32 var_12 = 1;
    wp::int32 var_13;
    wp::float32 var_14;
    wp::float32 var_15;
    const wp::int32 var_16 = 3;
    const wp::int32 var_17 = 1;
    wp::int32 var_18;
    wp::float32 var_19;
    wp::float32 var_20;
    const wp::int32 var_21 = 4;
    const wp::int32 var_22 = 1;
    wp::int32 var_23;
    wp::float32 var_24;
    wp::float32 var_25;
    //---------
    // forward
    // def lane_min(x: float) -> float:                                                       <L 10>
    // lowest = x                                                                             <L 11>
    var_0 = wp::copy(var_x);
    // for bit in range(LANE_BITS):                                                           <L 12>
    // lowest = min(lowest, shuffle_xor(lowest, 1 << bit))                                    <L 13>
    var_3 = wp::lshift(var_2, var_1);
    var_4 = _shuffle_xor_1(var_0, var_3);
    var_5 = wp::min(var_0, var_4);
    var_8 = wp::lshift(var_7, var_6);
    var_9 = _shuffle_xor_1(var_5, var_8);
    var_10 = wp::min(var_5, var_9);
    var_13 = wp::lshift(var_12, var_11);
    var_14 = _shuffle_xor_1(var_10, var_13);
    var_15 = wp::min(var_10, var_14);
    var_18 = wp::lshift(var_17, var_16);
    var_19 = _shuffle_xor_1(var_15, var_18);
    var_20 = wp::min(var_15, var_19);
    var_23 = wp::lshift(var_22, var_21);
    var_24 = _shuffle_xor_1(var_20, var_23);
    var_25 = wp::min(var_20, var_24);
    // return lowest                                                                          <L 14>
    return var_25;
}


// /work/main/src/pointloom/kernels/arrays/lanes.py:33
static CUDA_CALLABLE wp::vec_t<3, wp::float32> lane_min_corner_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    wp::float32 var_2;
    const wp::int32 var_3 = 1;
    wp::float32 var_4;
    wp::float32 var_5;
    const wp::int32 var_6 = 2;
    wp::float32 var_7;
    wp::float32 var_8;
    wp::vec_t<3, wp::float32> var_9;
    //---------
    // forward
    // def lane_min_corner(p: vec3) -> vec3:                                                  <L 34>
    // return vec3(lane_min(p[0]), lane_min(p[1]), lane_min(p[2]))                            <L 36>
    var_1 = wp::extract(var_p, var_0);
    var_2 = lane_min_on_cuda_0(var_1);
    var_4 = wp::extract(var_p, var_3);
    var_5 = lane_min_on_cuda_0(var_4);
    var_7 = wp::extract(var_p, var_6);
    var_8 = lane_min_on_cuda_0(var_7);
    var_9 = wp::vec_t<3, wp::float32>(var_2, var_5, var_8);
    return var_9;
}


// /work/main/src/pointloom/kernels/arrays/lanes.py:17
static CUDA_CALLABLE wp::float32 lane_max_on_cuda_0(
    wp::float32 var_x)
{
    //---------
    // primal vars
    wp::float32 var_0;
    const wp::int32 var_1 = 0;
    const wp::int32 var_2 = 1;
    wp::int32 var_3;
    wp::float32 var_4;
    wp::float32 var_5;
    const wp::int32 var_6 = 1;
    const wp::int32 var_7 = 1;
    wp::int32 var_8;
    wp::float32 var_9;
    wp::float32 var_10;
    const wp::int32 var_11 = 2;
    const wp::int32 var_12 = 1;
    wp::int32 var_13;
    wp::float32 var_14;
    wp::float32 var_15;
    const wp::int32 var_16 = 3;
    const wp::int32 var_17 = 1;
    wp::int32 var_18;
    wp::float32 var_19;
    wp::float32 var_20;
    const wp::int32 var_21 = 4;
    const wp::int32 var_22 = 1;
    wp::int32 var_23;
    wp::float32 var_24;
    wp::float32 var_25;
    //---------
    // forward
    // def lane_max(x: float) -> float:                                                       <L 18>
    // highest = x                                                                            <L 19>
    var_0 = wp::copy(var_x);
    // for bit in range(LANE_BITS):                                                           <L 20>
    // highest = max(highest, shuffle_xor(highest, 1 << bit))                                 <L 21>
    var_3 = wp::lshift(var_2, var_1);
    var_4 = _shuffle_xor_1(var_0, var_3);
    var_5 = wp::max(var_0, var_4);
    var_8 = wp::lshift(var_7, var_6);
    var_9 = _shuffle_xor_1(var_5, var_8);
    var_10 = wp::max(var_5, var_9);
    var_13 = wp::lshift(var_12, var_11);
    var_14 = _shuffle_xor_1(var_10, var_13);
    var_15 = wp::max(var_10, var_14);
    var_18 = wp::lshift(var_17, var_16);
    var_19 = _shuffle_xor_1(var_15, var_18);
    var_20 = wp::max(var_15, var_19);
    var_23 = wp::lshift(var_22, var_21);
    var_24 = _shuffle_xor_1(var_20, var_23);
    var_25 = wp::max(var_20, var_24);
    // return highest                                                                         <L 22>
    return var_25;
}


// /work/main/src/pointloom/kernels/arrays/lanes.py:39
static CUDA_CALLABLE wp::vec_t<3, wp::float32> lane_max_corner_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    wp::float32 var_2;
    const wp::int32 var_3 = 1;
    wp::float32 var_4;
    wp::float32 var_5;
    const wp::int32 var_6 = 2;
    wp::float32 var_7;
    wp::float32 var_8;
    wp::vec_t<3, wp::float32> var_9;
    //---------
    // forward
    // def lane_max_corner(p: vec3) -> vec3:                                                  <L 40>
    // return vec3(lane_max(p[0]), lane_max(p[1]), lane_max(p[2]))                            <L 41>
    var_1 = wp::extract(var_p, var_0);
    var_2 = lane_max_on_cuda_0(var_1);
    var_4 = wp::extract(var_p, var_3);
    var_5 = lane_max_on_cuda_0(var_4);
    var_7 = wp::extract(var_p, var_6);
    var_8 = lane_max_on_cuda_0(var_7);
    var_9 = wp::vec_t<3, wp::float32>(var_2, var_5, var_8);
    return var_9;
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:143
static CUDA_CALLABLE wp::int32 _float_bits_0(
    wp::float32 var_x)
{
    //---------
    // primal vars
    wp::int32 var_0;
    //---------
    // forward
    // def _float_bits(x: wp.float32):                                                        <L 144>
    // return wp.cast(x, wp.int32)                                                            <L 145>
    var_0 = wp::cast<wp::int32>(var_x);
    return var_0;
}


// /work/main/src/pointloom/kernels/arrays/bounds.py:37
static CUDA_CALLABLE wp::int32 ordered_bits_0(
    wp::float32 var_x)
{
    //---------
    // primal vars
    wp::int32 var_0;
    const wp::int32 var_1 = 31;
    wp::int32 var_2;
    const wp::int32 var_3 = 2147483647;
    wp::int32 var_4;
    wp::int32 var_5;
    //---------
    // forward
    // def ordered_bits(x: float) -> int:                                                     <L 38>
    // bits = float_bits(x)                                                                   <L 40>
    var_0 = _float_bits_0(var_x);
    // return bits ^ ((bits >> 31) & MAGNITUDE)                                               <L 41>
    var_2 = wp::rshift(var_0, var_1);
    var_4 = wp::bit_and(var_2, var_3);
    var_5 = wp::bit_xor(var_0, var_4);
    return var_5;
}


// <pointloom.kernels.arrays.bounds.merge_box_of_lanes>:1
static CUDA_CALLABLE void merge_box_of_lanes_on_cuda_0(
    wp::int32 var_i,
    wp::vec_t<3, wp::float32> var_low,
    wp::vec_t<3, wp::float32> var_high,
    wp::int32 var_count,
    wp::int32 var_runs__rows,
    wp::array_t<wp::int32> var_extremes)
{
    //---------
    // primal vars
    wp::int32 var_0;
    const wp::int32 var_1 = 7;
    wp::int32 var_2;
    wp::int32 var_3;
    const wp::int32 var_4 = 0;
    const wp::int32 var_5 = 1;
    wp::int32 var_6;
    wp::int32 var_7;
    wp::int32 var_8;
    const wp::int32 var_9 = 1;
    const wp::int32 var_10 = 1;
    wp::int32 var_11;
    wp::int32 var_12;
    wp::int32 var_13;
    const wp::int32 var_14 = 2;
    const wp::int32 var_15 = 1;
    wp::int32 var_16;
    wp::int32 var_17;
    wp::int32 var_18;
    const wp::int32 var_19 = 3;
    const wp::int32 var_20 = 1;
    wp::int32 var_21;
    wp::int32 var_22;
    wp::int32 var_23;
    const wp::int32 var_24 = 4;
    const wp::int32 var_25 = 1;
    wp::int32 var_26;
    wp::int32 var_27;
    wp::int32 var_28;
    wp::vec_t<3, wp::float32> var_29;
    wp::vec_t<3, wp::float32> var_30;
    const wp::int32 var_31 = 32;
    wp::int32 var_32;
    const wp::int32 var_33 = 0;
    bool var_34;
    const wp::int32 var_35 = 0;
    wp::int32 var_36;
    wp::float32 var_37;
    wp::float32 var_38;
    wp::int32 var_39;
    wp::int32 var_40;
    const wp::int32 var_41 = 3;
    wp::int32 var_42;
    wp::int32 var_43;
    wp::float32 var_44;
    wp::int32 var_45;
    wp::int32 var_46;
    const wp::int32 var_47 = 1;
    wp::int32 var_48;
    wp::float32 var_49;
    wp::float32 var_50;
    wp::int32 var_51;
    wp::int32 var_52;
    const wp::int32 var_53 = 3;
    wp::int32 var_54;
    wp::int32 var_55;
    wp::float32 var_56;
    wp::int32 var_57;
    wp::int32 var_58;
    const wp::int32 var_59 = 2;
    wp::int32 var_60;
    wp::float32 var_61;
    wp::float32 var_62;
    wp::int32 var_63;
    wp::int32 var_64;
    const wp::int32 var_65 = 3;
    wp::int32 var_66;
    wp::int32 var_67;
    wp::float32 var_68;
    wp::int32 var_69;
    wp::int32 var_70;
    const wp::int32 var_71 = 6;
    wp::int32 var_72;
    wp::int32 var_73;
    //---------
    // forward
    // def merge_box_of_lanes(i, low, high, count, runs__rows, extremes):                     <L 1>
    // at = row_of(i, runs__rows) * WIDTH                                                     <L 3>
    var_0 = row_of_0(var_i, var_runs__rows);
    var_2 = wp::mul(var_0, var_1);
    // total = count                                                                          <L 4>
    var_3 = wp::copy(var_count);
    // for bit in range(LANE_BITS):                                                           <L 5>
    // total += shuffle_xor(total, 1 << bit)                                                  <L 6>
    var_6 = wp::lshift(var_5, var_4);
    var_7 = _shuffle_xor_0(var_3, var_6);
    var_8 = wp::add(var_3, var_7);
    var_11 = wp::lshift(var_10, var_9);
    var_12 = _shuffle_xor_0(var_8, var_11);
    var_13 = wp::add(var_8, var_12);
    var_16 = wp::lshift(var_15, var_14);
    var_17 = _shuffle_xor_0(var_13, var_16);
    var_18 = wp::add(var_13, var_17);
    var_21 = wp::lshift(var_20, var_19);
    var_22 = _shuffle_xor_0(var_18, var_21);
    var_23 = wp::add(var_18, var_22);
    var_26 = wp::lshift(var_25, var_24);
    var_27 = _shuffle_xor_0(var_23, var_26);
    var_28 = wp::add(var_23, var_27);
    // a = lane_min_corner(low)                                                               <L 7>
    var_29 = lane_min_corner_on_cuda_0(var_low);
    // b = lane_max_corner(high)                                                              <L 8>
    var_30 = lane_max_corner_on_cuda_0(var_high);
    // if i % WARP == 0:                                                                      <L 9>
    var_32 = wp::mod(var_i, var_31);
    var_34 = (var_32 == var_33);
    if (var_34) {
        // for axis in range(3):                                                              <L 10>
        // atomic_max(extremes, at + axis, ordered_bits(-a[axis]))                            <L 11>
        var_36 = wp::add(var_2, var_35);
        var_37 = wp::extract(var_29, var_35);
        var_38 = wp::neg(var_37);
        var_39 = ordered_bits_0(var_38);
        var_40 = wp::atomic_max(var_extremes, var_36, var_39);
        // atomic_max(extremes, at + 3 + axis, ordered_bits(b[axis]))                         <L 12>
        var_42 = wp::add(var_2, var_41);
        var_43 = wp::add(var_42, var_35);
        var_44 = wp::extract(var_30, var_35);
        var_45 = ordered_bits_0(var_44);
        var_46 = wp::atomic_max(var_extremes, var_43, var_45);
        // atomic_max(extremes, at + axis, ordered_bits(-a[axis]))                            <L 11>
        var_48 = wp::add(var_2, var_47);
        var_49 = wp::extract(var_29, var_47);
        var_50 = wp::neg(var_49);
        var_51 = ordered_bits_0(var_50);
        var_52 = wp::atomic_max(var_extremes, var_48, var_51);
        // atomic_max(extremes, at + 3 + axis, ordered_bits(b[axis]))                         <L 12>
        var_54 = wp::add(var_2, var_53);
        var_55 = wp::add(var_54, var_47);
        var_56 = wp::extract(var_30, var_47);
        var_57 = ordered_bits_0(var_56);
        var_58 = wp::atomic_max(var_extremes, var_55, var_57);
        // atomic_max(extremes, at + axis, ordered_bits(-a[axis]))                            <L 11>
        var_60 = wp::add(var_2, var_59);
        var_61 = wp::extract(var_29, var_59);
        var_62 = wp::neg(var_61);
        var_63 = ordered_bits_0(var_62);
        var_64 = wp::atomic_max(var_extremes, var_60, var_63);
        // atomic_max(extremes, at + 3 + axis, ordered_bits(b[axis]))                         <L 12>
        var_66 = wp::add(var_2, var_65);
        var_67 = wp::add(var_66, var_59);
        var_68 = wp::extract(var_30, var_59);
        var_69 = ordered_bits_0(var_68);
        var_70 = wp::atomic_max(var_extremes, var_67, var_69);
        // atomic_add(extremes, at + 6, total)                                                <L 13>
        var_72 = wp::add(var_2, var_71);
        var_73 = wp::atomic_add(var_extremes, var_72, var_28);
    }
}


// <pointloom.kernels.arrays.runs.row_of>:1
static CUDA_CALLABLE void adj_row_of_0(
    wp::int32 var_i,
    wp::int32 var_runs__rows,
    wp::int32 & adj_i,
    wp::int32 & adj_runs__rows,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:174
static CUDA_CALLABLE void adj__shuffle_xor_0(
    wp::int32 x,
    wp::int32 mask,
    wp::int32 & adj_x,
    wp::int32 & adj_mask,
    wp::int32 & adj_ret)
{
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:178
static CUDA_CALLABLE void adj__shuffle_xor_1(
    wp::float32 x,
    wp::int32 mask,
    wp::float32 & adj_x,
    wp::int32 & adj_mask,
    wp::float32 & adj_ret)
{
}


// /work/main/src/pointloom/kernels/arrays/lanes.py:9
static CUDA_CALLABLE void adj_lane_min_on_cuda_0(
    wp::float32 var_x,
    wp::float32 & adj_x,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/arrays/lanes.py:33
static CUDA_CALLABLE void adj_lane_min_corner_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/arrays/lanes.py:17
static CUDA_CALLABLE void adj_lane_max_on_cuda_0(
    wp::float32 var_x,
    wp::float32 & adj_x,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/arrays/lanes.py:39
static CUDA_CALLABLE void adj_lane_max_corner_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:143
static CUDA_CALLABLE void adj__float_bits_0(
    wp::float32 var_x,
    wp::float32 & adj_x,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/arrays/bounds.py:37
static CUDA_CALLABLE void adj_ordered_bits_0(
    wp::float32 var_x,
    wp::float32 & adj_x,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.arrays.bounds.merge_box_of_lanes>:1
static CUDA_CALLABLE void adj_merge_box_of_lanes_on_cuda_0(
    wp::int32 var_i,
    wp::vec_t<3, wp::float32> var_low,
    wp::vec_t<3, wp::float32> var_high,
    wp::int32 var_count,
    wp::int32 var_runs__rows,
    wp::array_t<wp::int32> var_extremes,
    wp::int32 & adj_i,
    wp::vec_t<3, wp::float32> & adj_low,
    wp::vec_t<3, wp::float32> & adj_high,
    wp::int32 & adj_count,
    wp::int32 & adj_runs__rows,
    wp::array_t<wp::int32> & adj_extremes)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void bound_points_kernel_eb25716a_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::int32 var_runs__rows,
    wp::int32 var_runs__count,
    wp::int32 var_runs__length,
    wp::int32 var_runs__stride,
    wp::int32 var_runs__step,
    wp::array_t<wp::int32> var_extremes)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        const wp::float32 var_1 = INFINITY;
        wp::float32 var_2;
        wp::float32 var_3;
        wp::float32 var_4;
        wp::float32 var_5;
        wp::float32 var_6;
        wp::float32 var_7;
        wp::float32 var_8;
        wp::float32 var_9;
        wp::float32 var_10;
        const wp::int32 var_11 = 0;
        wp::int32 var_12;
        wp::int32 var_13;
        const wp::int32 var_14 = 1;
        wp::int32 var_15;
        wp::int32 var_16;
        wp::int32 var_17;
        const wp::int32 var_18 = 1;
        wp::int32 var_19;
        wp::int32 var_20;
        wp::range_t var_21;
        wp::int32 var_22;
        wp::int32 var_23;
        wp::int32 var_24;
        wp::vec_t<3, wp::float32>* var_25;
        wp::vec_t<3, wp::float32> var_26;
        wp::vec_t<3, wp::float32> var_27;
        bool var_28;
        const wp::int32 var_29 = 0;
        wp::float32 var_30;
        wp::float32 var_31;
        const wp::int32 var_32 = 1;
        wp::float32 var_33;
        wp::float32 var_34;
        const wp::int32 var_35 = 2;
        wp::float32 var_36;
        wp::float32 var_37;
        const wp::int32 var_38 = 0;
        wp::float32 var_39;
        wp::float32 var_40;
        const wp::int32 var_41 = 1;
        wp::float32 var_42;
        wp::float32 var_43;
        const wp::int32 var_44 = 2;
        wp::float32 var_45;
        wp::float32 var_46;
        const wp::int32 var_47 = 1;
        wp::int32 var_48;
        wp::float32 var_49;
        wp::float32 var_50;
        wp::float32 var_51;
        wp::float32 var_52;
        wp::float32 var_53;
        wp::float32 var_54;
        wp::int32 var_55;
        wp::vec_t<3, wp::float32> var_56;
        wp::vec_t<3, wp::float32> var_57;
        //---------
        // forward
        // def bound_points_kernel(points, runs__rows, runs__count, runs__length, runs__stride, runs__step, extremes):       <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // x0 = float(INFINITY)                                                                   <L 3>
        var_2 = wp::float(var_1);
        // y0 = float(INFINITY)                                                                   <L 4>
        var_3 = wp::float(var_1);
        // z0 = float(INFINITY)                                                                   <L 5>
        var_4 = wp::float(var_1);
        // x1 = -float(INFINITY)                                                                  <L 6>
        var_5 = wp::float(var_1);
        var_6 = wp::neg(var_5);
        // y1 = -float(INFINITY)                                                                  <L 7>
        var_7 = wp::float(var_1);
        var_8 = wp::neg(var_7);
        // z1 = -float(INFINITY)                                                                  <L 8>
        var_9 = wp::float(var_1);
        var_10 = wp::neg(var_9);
        // count = int(0)                                                                         <L 9>
        var_12 = wp::int(var_11);
        // first__elements_of__1 = i * runs__stride                                               <L 10>
        var_13 = wp::mul(var_0, var_runs__stride);
        // for k__elements_of__1 in range(min(runs__length, (runs__count - 1 - first__elements_of__1) // runs__step + 1)):       <L 11>
        var_15 = wp::sub(var_runs__count, var_14);
        var_16 = wp::sub(var_15, var_13);
        var_17 = wp::floordiv(var_16, var_runs__step);
        var_19 = wp::add(var_17, var_18);
        var_20 = wp::min(var_runs__length, var_19);
        var_21 = wp::range(var_20);
        start_for_0:;
            if (iter_cmp(var_21) == 0) goto end_for_0;
            var_22 = wp::iter_next(var_21);
            // j = first__elements_of__1 + k__elements_of__1 * runs__step                         <L 12>
            var_23 = wp::mul(var_22, var_runs__step);
            var_24 = wp::add(var_13, var_23);
            // p = points[j]                                                                      <L 13>
            var_25 = wp::address(var_points, var_24);
            var_27 = wp::load(var_25);
            var_26 = wp::copy(var_27);
            // if isfinite(p):                                                                    <L 14>
            var_28 = wp::isfinite(var_26);
            if (var_28) {
                // x0 = min(x0, p[0])                                                             <L 15>
                var_30 = wp::extract(var_26, var_29);
                var_31 = wp::min(var_2, var_30);
                // y0 = min(y0, p[1])                                                             <L 16>
                var_33 = wp::extract(var_26, var_32);
                var_34 = wp::min(var_3, var_33);
                // z0 = min(z0, p[2])                                                             <L 17>
                var_36 = wp::extract(var_26, var_35);
                var_37 = wp::min(var_4, var_36);
                // x1 = max(x1, p[0])                                                             <L 18>
                var_39 = wp::extract(var_26, var_38);
                var_40 = wp::max(var_6, var_39);
                // y1 = max(y1, p[1])                                                             <L 19>
                var_42 = wp::extract(var_26, var_41);
                var_43 = wp::max(var_8, var_42);
                // z1 = max(z1, p[2])                                                             <L 20>
                var_45 = wp::extract(var_26, var_44);
                var_46 = wp::max(var_10, var_45);
                // count += 1                                                                     <L 21>
                var_48 = wp::add(var_12, var_47);
            }
            var_49 = wp::where(var_28, var_31, var_2);
            var_50 = wp::where(var_28, var_34, var_3);
            var_51 = wp::where(var_28, var_37, var_4);
            var_52 = wp::where(var_28, var_40, var_6);
            var_53 = wp::where(var_28, var_43, var_8);
            var_54 = wp::where(var_28, var_46, var_10);
            var_55 = wp::where(var_28, var_48, var_12);
            wp::assign(var_2, var_49);
            wp::assign(var_3, var_50);
            wp::assign(var_4, var_51);
            wp::assign(var_6, var_52);
            wp::assign(var_8, var_53);
            wp::assign(var_10, var_54);
            wp::assign(var_12, var_55);
            goto start_for_0;
        end_for_0:;
        // merge_box(i, vec3(x0, y0, z0), vec3(x1, y1, z1), count, runs__rows, extremes)          <L 22>
        var_56 = wp::vec_t<3, wp::float32>(var_2, var_3, var_4);
        var_57 = wp::vec_t<3, wp::float32>(var_6, var_8, var_10);
        merge_box_of_lanes_on_cuda_0(var_0, var_56, var_57, var_12, var_runs__rows, var_extremes);
}


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


// <pointloom.kernels.rays.triangle_tree.middle_of>:1
static CUDA_CALLABLE wp::vec_t<3, wp::float32> middle_of_0(
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::vec_t<3, wp::float32> var_c)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float64> var_0;
    wp::vec_t<3, wp::float64> var_1;
    wp::vec_t<3, wp::float64> var_2;
    wp::vec_t<3, wp::float64> var_3;
    wp::vec_t<3, wp::float64> var_4;
    wp::float64 var_5;
    wp::vec_t<3, wp::float64> var_6;
    wp::vec_t<3, wp::float32> var_7;
    //---------
    // forward
    // def middle_of(a, b, c):                                                                <L 1>
    // return narrow((widen(a) + widen(b) + widen(c)) / float64(3.0))                         <L 2>
    var_0 = widen_0(var_a);
    var_1 = widen_0(var_b);
    var_2 = wp::add(var_0, var_1);
    var_3 = widen_0(var_c);
    var_4 = wp::add(var_2, var_3);
    var_5 = 3.0;
    var_6 = wp::div(var_4, var_5);
    var_7 = narrow_0(var_6);
    return var_7;
}


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


// /work/main/src/pointloom/kernels/algebra/transform.py:27
static CUDA_CALLABLE void adj_widen_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float64> & adj_ret)
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


// <pointloom.kernels.rays.triangle_tree.middle_of>:1
static CUDA_CALLABLE void adj_middle_of_0(
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::vec_t<3, wp::float32> var_c,
    wp::vec_t<3, wp::float32> & adj_a,
    wp::vec_t<3, wp::float32> & adj_b,
    wp::vec_t<3, wp::float32> & adj_c,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
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



extern "C" __global__ void bound_triangles_kernel_e0d1b480_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_vertices,
    wp::array_t<wp::vec_t<3, wp::int32>> var_triangles,
    wp::int32 var_runs__rows,
    wp::int32 var_runs__count,
    wp::int32 var_runs__length,
    wp::int32 var_runs__stride,
    wp::int32 var_runs__step,
    wp::array_t<wp::vec_t<3, wp::float32>> var_middles,
    wp::array_t<wp::uint8> var_mask,
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
        wp::vec_t<3, wp::float32> var_2;
        const wp::float32 var_3 = -INFINITY;
        const wp::float32 var_4 = -INFINITY;
        const wp::float32 var_5 = -INFINITY;
        wp::vec_t<3, wp::float32> var_6;
        const wp::int32 var_7 = 0;
        wp::int32 var_8;
        wp::int32 var_9;
        const wp::int32 var_10 = 1;
        wp::int32 var_11;
        wp::int32 var_12;
        wp::int32 var_13;
        const wp::int32 var_14 = 1;
        wp::int32 var_15;
        wp::int32 var_16;
        wp::range_t var_17;
        wp::int32 var_18;
        wp::int32 var_19;
        wp::int32 var_20;
        wp::vec_t<3, wp::int32>* var_21;
        wp::vec_t<3, wp::int32> var_22;
        wp::vec_t<3, wp::int32> var_23;
        const wp::int32 var_24 = 0;
        wp::int32 var_25;
        wp::vec_t<3, wp::float32>* var_26;
        wp::vec_t<3, wp::float32> var_27;
        wp::vec_t<3, wp::float32> var_28;
        const wp::int32 var_29 = 1;
        wp::int32 var_30;
        wp::vec_t<3, wp::float32>* var_31;
        wp::vec_t<3, wp::float32> var_32;
        wp::vec_t<3, wp::float32> var_33;
        const wp::int32 var_34 = 2;
        wp::int32 var_35;
        wp::vec_t<3, wp::float32>* var_36;
        wp::vec_t<3, wp::float32> var_37;
        wp::vec_t<3, wp::float32> var_38;
        const wp::float32 var_39 = NAN;
        wp::vec_t<3, wp::float32> var_40;
        const wp::int32 var_41 = 0;
        wp::int32 var_42;
        bool var_43;
        bool var_44;
        bool var_45;
        bool var_46;
        wp::vec_t<3, wp::float32> var_47;
        const wp::int32 var_48 = 1;
        const wp::int32 var_49 = 0;
        wp::float32 var_50;
        wp::float32 var_51;
        wp::float32 var_52;
        wp::float32 var_53;
        wp::float32 var_54;
        wp::float32 var_55;
        wp::float32 var_56;
        wp::float32 var_57;
        wp::float32 var_58;
        wp::float32 var_59;
        wp::float32 var_60;
        wp::float32 var_61;
        wp::float32 var_62;
        wp::float32 var_63;
        const wp::int32 var_64 = 1;
        wp::float32 var_65;
        wp::float32 var_66;
        wp::float32 var_67;
        wp::float32 var_68;
        wp::float32 var_69;
        wp::float32 var_70;
        wp::float32 var_71;
        wp::float32 var_72;
        wp::float32 var_73;
        wp::float32 var_74;
        wp::float32 var_75;
        wp::float32 var_76;
        wp::float32 var_77;
        wp::float32 var_78;
        const wp::int32 var_79 = 2;
        wp::float32 var_80;
        wp::float32 var_81;
        wp::float32 var_82;
        wp::float32 var_83;
        wp::float32 var_84;
        wp::float32 var_85;
        wp::float32 var_86;
        wp::float32 var_87;
        wp::float32 var_88;
        wp::float32 var_89;
        wp::float32 var_90;
        wp::float32 var_91;
        wp::float32 var_92;
        wp::float32 var_93;
        wp::vec_t<3, wp::float32> var_94;
        wp::int32 var_95;
        wp::uint8 var_96;
        wp::int32 var_97;
        //---------
        // forward
        // def bound_triangles_kernel(vertices, triangles, runs__rows, runs__count, runs__length, runs__stride, runs__step, middles, mask, extremes):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // low = vec3(INFINITY, INFINITY, INFINITY)                                               <L 4>
        var_2 = wp::vec_t<3, wp::float32>(var_1, var_1, var_1);
        // high = vec3(-INFINITY, -INFINITY, -INFINITY)                                           <L 5>
        var_6 = wp::vec_t<3, wp::float32>(var_3, var_4, var_5);
        // count = int(0)                                                                         <L 6>
        var_8 = wp::int(var_7);
        // first__elements_of__1 = i * runs__stride                                               <L 7>
        var_9 = wp::mul(var_0, var_runs__stride);
        // for k__elements_of__1 in range(min(runs__length, (runs__count - 1 - first__elements_of__1) // runs__step + 1)):       <L 8>
        var_11 = wp::sub(var_runs__count, var_10);
        var_12 = wp::sub(var_11, var_9);
        var_13 = wp::floordiv(var_12, var_runs__step);
        var_15 = wp::add(var_13, var_14);
        var_16 = wp::min(var_runs__length, var_15);
        var_17 = wp::range(var_16);
        start_for_0:;
            if (iter_cmp(var_17) == 0) goto end_for_0;
            var_18 = wp::iter_next(var_17);
            // j = first__elements_of__1 + k__elements_of__1 * runs__step                         <L 9>
            var_19 = wp::mul(var_18, var_runs__step);
            var_20 = wp::add(var_9, var_19);
            // t = triangles[j]                                                                   <L 10>
            var_21 = wp::address(var_triangles, var_20);
            var_23 = wp::load(var_21);
            var_22 = wp::copy(var_23);
            // a = vertices[t[0]]                                                                 <L 11>
            var_25 = wp::extract(var_22, var_24);
            var_26 = wp::address(var_vertices, var_25);
            var_28 = wp::load(var_26);
            var_27 = wp::copy(var_28);
            // b = vertices[t[1]]                                                                 <L 12>
            var_30 = wp::extract(var_22, var_29);
            var_31 = wp::address(var_vertices, var_30);
            var_33 = wp::load(var_31);
            var_32 = wp::copy(var_33);
            // c = vertices[t[2]]                                                                 <L 13>
            var_35 = wp::extract(var_22, var_34);
            var_36 = wp::address(var_vertices, var_35);
            var_38 = wp::load(var_36);
            var_37 = wp::copy(var_38);
            // middle = vec3(NAN, NAN, NAN)                                                       <L 14>
            var_40 = wp::vec_t<3, wp::float32>(var_39, var_39, var_39);
            // is_finite = int(0)                                                                 <L 15>
            var_42 = wp::int(var_41);
            // if isfinite(a) and isfinite(b) and isfinite(c):                                    <L 16>
            var_44 = wp::isfinite(var_27);
            var_43 = var_44;
            if (var_43) {
                var_45 = wp::isfinite(var_32);
                var_43 = var_43 && var_45;
            }
            if (var_43) {
                var_46 = wp::isfinite(var_37);
                var_43 = var_43 && var_46;
            }
            if (var_43) {
                // middle = middle_of(a, b, c)                                                    <L 17>
                var_47 = middle_of_0(var_27, var_32, var_37);
                // is_finite = 1                                                                  <L 18>
                // for axis in range(3):                                                          <L 19>
                // low[axis] = min(low[axis], min(a[axis], min(b[axis], c[axis])))                <L 20>
                var_50 = wp::extract(var_2, var_49);
                var_51 = wp::extract(var_27, var_49);
                var_52 = wp::extract(var_32, var_49);
                var_53 = wp::extract(var_37, var_49);
                var_54 = wp::min(var_52, var_53);
                var_55 = wp::min(var_51, var_54);
                var_56 = wp::min(var_50, var_55);
                wp::assign_inplace(var_2, var_49, var_56);
                // high[axis] = max(high[axis], max(a[axis], max(b[axis], c[axis])))              <L 21>
                var_57 = wp::extract(var_6, var_49);
                var_58 = wp::extract(var_27, var_49);
                var_59 = wp::extract(var_32, var_49);
                var_60 = wp::extract(var_37, var_49);
                var_61 = wp::max(var_59, var_60);
                var_62 = wp::max(var_58, var_61);
                var_63 = wp::max(var_57, var_62);
                wp::assign_inplace(var_6, var_49, var_63);
                // low[axis] = min(low[axis], min(a[axis], min(b[axis], c[axis])))                <L 20>
                var_65 = wp::extract(var_2, var_64);
                var_66 = wp::extract(var_27, var_64);
                var_67 = wp::extract(var_32, var_64);
                var_68 = wp::extract(var_37, var_64);
                var_69 = wp::min(var_67, var_68);
                var_70 = wp::min(var_66, var_69);
                var_71 = wp::min(var_65, var_70);
                wp::assign_inplace(var_2, var_64, var_71);
                // high[axis] = max(high[axis], max(a[axis], max(b[axis], c[axis])))              <L 21>
                var_72 = wp::extract(var_6, var_64);
                var_73 = wp::extract(var_27, var_64);
                var_74 = wp::extract(var_32, var_64);
                var_75 = wp::extract(var_37, var_64);
                var_76 = wp::max(var_74, var_75);
                var_77 = wp::max(var_73, var_76);
                var_78 = wp::max(var_72, var_77);
                wp::assign_inplace(var_6, var_64, var_78);
                // low[axis] = min(low[axis], min(a[axis], min(b[axis], c[axis])))                <L 20>
                var_80 = wp::extract(var_2, var_79);
                var_81 = wp::extract(var_27, var_79);
                var_82 = wp::extract(var_32, var_79);
                var_83 = wp::extract(var_37, var_79);
                var_84 = wp::min(var_82, var_83);
                var_85 = wp::min(var_81, var_84);
                var_86 = wp::min(var_80, var_85);
                wp::assign_inplace(var_2, var_79, var_86);
                // high[axis] = max(high[axis], max(a[axis], max(b[axis], c[axis])))              <L 21>
                var_87 = wp::extract(var_6, var_79);
                var_88 = wp::extract(var_27, var_79);
                var_89 = wp::extract(var_32, var_79);
                var_90 = wp::extract(var_37, var_79);
                var_91 = wp::max(var_89, var_90);
                var_92 = wp::max(var_88, var_91);
                var_93 = wp::max(var_87, var_92);
                wp::assign_inplace(var_6, var_79, var_93);
            }
            var_94 = wp::where(var_43, var_47, var_40);
            var_95 = wp::where(var_43, var_48, var_42);
            // middles[j] = middle                                                                <L 22>
            wp::array_store(var_middles, var_20, var_94);
            // mask[j] = uint8(is_finite)                                                         <L 23>
            var_96 = wp::uint8(var_95);
            wp::array_store(var_mask, var_20, var_96);
            // count += is_finite                                                                 <L 24>
            var_97 = wp::add(var_8, var_95);
            wp::assign(var_8, var_97);
            goto start_for_0;
        end_for_0:;
        // merge_box(i, low, high, count, runs__rows, extremes)                                   <L 25>
        merge_box_of_lanes_on_cuda_0(var_0, var_2, var_6, var_8, var_runs__rows, var_extremes);
}


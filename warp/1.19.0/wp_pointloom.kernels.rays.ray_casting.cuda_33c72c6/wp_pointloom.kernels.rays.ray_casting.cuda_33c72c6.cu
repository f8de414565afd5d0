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


// /work/main/src/pointloom/kernels/rays/ray_packets.py:35
static CUDA_CALLABLE wp::vec_t<3, wp::float32> ray_origin_0(
    wp::array_t<wp::float32> var_rays,
    wp::int32 var_i)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 6;
    wp::int32 var_1;
    wp::float32* var_2;
    const wp::int32 var_3 = 6;
    wp::int32 var_4;
    const wp::int32 var_5 = 1;
    wp::int32 var_6;
    wp::float32* var_7;
    const wp::int32 var_8 = 6;
    wp::int32 var_9;
    const wp::int32 var_10 = 2;
    wp::int32 var_11;
    wp::float32* var_12;
    wp::vec_t<3, wp::float32> var_13;
    wp::float32 var_14;
    wp::float32 var_15;
    wp::float32 var_16;
    //---------
    // forward
    // def ray_origin(rays: array(dtype=float32), i: int) -> vec3:                            <L 36>
    // return vec3(rays[6 * i], rays[6 * i + 1], rays[6 * i + 2])                             <L 37>
    var_1 = wp::mul(var_0, var_i);
    var_2 = wp::address(var_rays, var_1);
    var_4 = wp::mul(var_3, var_i);
    var_6 = wp::add(var_4, var_5);
    var_7 = wp::address(var_rays, var_6);
    var_9 = wp::mul(var_8, var_i);
    var_11 = wp::add(var_9, var_10);
    var_12 = wp::address(var_rays, var_11);
    var_14 = wp::load(var_2);
    var_15 = wp::load(var_7);
    var_16 = wp::load(var_12);
    var_13 = wp::vec_t<3, wp::float32>(var_14, var_15, var_16);
    return var_13;
}


// /work/main/src/pointloom/kernels/rays/ray_packets.py:40
static CUDA_CALLABLE wp::vec_t<3, wp::float32> ray_direction_0(
    wp::array_t<wp::float32> var_rays,
    wp::int32 var_i)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 6;
    wp::int32 var_1;
    const wp::int32 var_2 = 3;
    wp::int32 var_3;
    wp::float32* var_4;
    const wp::int32 var_5 = 6;
    wp::int32 var_6;
    const wp::int32 var_7 = 4;
    wp::int32 var_8;
    wp::float32* var_9;
    const wp::int32 var_10 = 6;
    wp::int32 var_11;
    const wp::int32 var_12 = 5;
    wp::int32 var_13;
    wp::float32* var_14;
    wp::vec_t<3, wp::float32> var_15;
    wp::float32 var_16;
    wp::float32 var_17;
    wp::float32 var_18;
    //---------
    // forward
    // def ray_direction(rays: array(dtype=float32), i: int) -> vec3:                         <L 41>
    // return vec3(rays[6 * i + 3], rays[6 * i + 4], rays[6 * i + 5])                         <L 42>
    var_1 = wp::mul(var_0, var_i);
    var_3 = wp::add(var_1, var_2);
    var_4 = wp::address(var_rays, var_3);
    var_6 = wp::mul(var_5, var_i);
    var_8 = wp::add(var_6, var_7);
    var_9 = wp::address(var_rays, var_8);
    var_11 = wp::mul(var_10, var_i);
    var_13 = wp::add(var_11, var_12);
    var_14 = wp::address(var_rays, var_13);
    var_16 = wp::load(var_4);
    var_17 = wp::load(var_9);
    var_18 = wp::load(var_14);
    var_15 = wp::vec_t<3, wp::float32>(var_16, var_17, var_18);
    return var_15;
}


// /work/main/src/pointloom/kernels/rays/ray_hits.py:416
static CUDA_CALLABLE wp::vec_t<5, wp::float64> no_hit_0(
    )
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::float64 var_1;
    wp::vec_t<5, wp::float64> var_2;
    //---------
    // forward
    // def no_hit() -> hit:                                                                   <L 417>
    // zero = float64(0.0)                                                                    <L 418>
    var_0 = 0.0;
    // return hit(float64(INFINITY), zero, zero, zero, zero)                                  <L 419>
    var_1 = INFINITY;
    var_2 = wp::vec_t<5, wp::float64>({var_1, var_0, var_0, var_0, var_0});
    return var_2;
}


// <pointloom.kernels.rays.ray_hits.is_ray>:1
static CUDA_CALLABLE wp::int32 is_ray_0(
    wp::vec_t<3, wp::float32> var_o,
    wp::vec_t<3, wp::float32> var_d)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    bool var_2;
    bool var_3;
    bool var_4;
    const wp::int32 var_5 = 0;
    wp::float32 var_6;
    wp::float32 var_7;
    const wp::int32 var_8 = 1;
    wp::float32 var_9;
    wp::float32 var_10;
    const wp::int32 var_11 = 2;
    wp::float32 var_12;
    wp::float32 var_13;
    wp::float32 var_14;
    wp::float32 var_15;
    const wp::float32 var_16 = 0.0;
    bool var_17;
    const wp::int32 var_18 = 1;
    wp::int32 var_19;
    wp::int32 var_20;
    //---------
    // forward
    // def is_ray(o, d):                                                                      <L 1>
    // valid = int(0)                                                                         <L 3>
    var_1 = wp::int(var_0);
    // if isfinite(o) and isfinite(d):                                                        <L 4>
    var_3 = wp::isfinite(var_o);
    var_2 = var_3;
    if (var_2) {
        var_4 = wp::isfinite(var_d);
        var_2 = var_2 && var_4;
    }
    if (var_2) {
        // if max(abs(d[0]), max(abs(d[1]), abs(d[2]))) > 0.0:                                <L 5>
        var_6 = wp::extract(var_d, var_5);
        var_7 = wp::abs(var_6);
        var_9 = wp::extract(var_d, var_8);
        var_10 = wp::abs(var_9);
        var_12 = wp::extract(var_d, var_11);
        var_13 = wp::abs(var_12);
        var_14 = wp::max(var_10, var_13);
        var_15 = wp::max(var_7, var_14);
        var_17 = (var_15 > var_16);
        if (var_17) {
            // valid = 1                                                                      <L 6>
        }
        var_19 = wp::where(var_17, var_18, var_1);
    }
    var_20 = wp::where(var_2, var_19, var_1);
    // return valid                                                                           <L 7>
    return var_20;
}


// <pointloom.kernels.rays.ray_hits.find_main_axis>:1
static CUDA_CALLABLE wp::int32 find_main_axis_0(
    wp::vec_t<3, wp::float32> var_d)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    const wp::int32 var_2 = 1;
    wp::float32 var_3;
    wp::float32 var_4;
    const wp::int32 var_5 = 0;
    wp::float32 var_6;
    wp::float32 var_7;
    bool var_8;
    const wp::int32 var_9 = 1;
    wp::int32 var_10;
    const wp::int32 var_11 = 2;
    wp::float32 var_12;
    wp::float32 var_13;
    wp::float32 var_14;
    wp::float32 var_15;
    bool var_16;
    const wp::int32 var_17 = 2;
    wp::int32 var_18;
    //---------
    // forward
    // def find_main_axis(d):                                                                 <L 1>
    // axis = int(0)                                                                          <L 2>
    var_1 = wp::int(var_0);
    // if abs(d[1]) > abs(d[0]):                                                              <L 3>
    var_3 = wp::extract(var_d, var_2);
    var_4 = wp::abs(var_3);
    var_6 = wp::extract(var_d, var_5);
    var_7 = wp::abs(var_6);
    var_8 = (var_4 > var_7);
    if (var_8) {
        // axis = 1                                                                           <L 4>
    }
    var_10 = wp::where(var_8, var_9, var_1);
    // if abs(d[2]) > abs(d[axis]):                                                           <L 5>
    var_12 = wp::extract(var_d, var_11);
    var_13 = wp::abs(var_12);
    var_14 = wp::extract(var_d, var_10);
    var_15 = wp::abs(var_14);
    var_16 = (var_13 > var_15);
    if (var_16) {
        // axis = 2                                                                           <L 6>
    }
    var_18 = wp::where(var_16, var_17, var_10);
    // return axis                                                                            <L 7>
    return var_18;
}


// /work/main/src/pointloom/kernels/rays/ray_hits.py:55
static CUDA_CALLABLE wp::vec_t<3, wp::int32> ray_axes_0(
    wp::vec_t<3, wp::float32> var_d)
{
    //---------
    // primal vars
    wp::int32 var_0;
    const wp::int32 var_1 = 1;
    wp::int32 var_2;
    const wp::int32 var_3 = 3;
    wp::int32 var_4;
    const wp::int32 var_5 = 2;
    wp::int32 var_6;
    const wp::int32 var_7 = 3;
    wp::int32 var_8;
    wp::vec_t<3, wp::int32> var_9;
    //---------
    // forward
    // def ray_axes(d: vec3) -> vec3i:                                                        <L 56>
    // axis = find_main_axis(d)                                                               <L 58>
    var_0 = find_main_axis_0(var_d);
    // return vec3i((axis + 1) % 3, (axis + 2) % 3, axis)                                     <L 59>
    var_2 = wp::add(var_0, var_1);
    var_4 = wp::mod(var_2, var_3);
    var_6 = wp::add(var_0, var_5);
    var_8 = wp::mod(var_6, var_7);
    var_9 = wp::vec_t<3, wp::int32>(var_4, var_8, var_0);
    return var_9;
}


// /work/main/src/pointloom/kernels/rays/ray_hits.py:103
static CUDA_CALLABLE wp::vec_t<3, wp::int32> near_sides_0(
    wp::vec_t<3, wp::float32> var_d)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    const wp::int32 var_1 = 0;
    const wp::int32 var_2 = 0;
    wp::vec_t<3, wp::int32> var_3;
    const wp::int32 var_4 = 0;
    wp::float32 var_5;
    const wp::float32 var_6 = 0.0;
    bool var_7;
    const wp::int32 var_8 = 8;
    wp::int32 var_9;
    const wp::int32 var_10 = 3;
    wp::int32 var_11;
    wp::int32 var_12;
    wp::int32 var_13;
    const wp::int32 var_14 = 1;
    wp::float32 var_15;
    const wp::float32 var_16 = 0.0;
    bool var_17;
    wp::int32 var_18;
    const wp::int32 var_19 = 3;
    wp::int32 var_20;
    wp::int32 var_21;
    wp::int32 var_22;
    const wp::int32 var_23 = 2;
    wp::float32 var_24;
    const wp::float32 var_25 = 0.0;
    bool var_26;
    wp::int32 var_27;
    const wp::int32 var_28 = 3;
    wp::int32 var_29;
    wp::int32 var_30;
    wp::int32 var_31;
    //---------
    // forward
    // def near_sides(d: vec3) -> vec3i:                                                      <L 104>
    // sides = vec3i(0, 0, 0)                                                                 <L 106>
    var_3 = wp::vec_t<3, wp::int32>(var_0, var_1, var_2);
    // for k in range(3):                                                                     <L 107>
    // sides[k] = k * FAN if d[k] >= 0.0 else (k + 3) * FAN                                   <L 108>
    var_5 = wp::extract(var_d, var_4);
    var_7 = (var_5 >= var_6);
    if (var_7) {
        var_9 = wp::mul(var_4, var_8);
    }
    if (!var_7) {
        var_11 = wp::add(var_4, var_10);
        var_12 = wp::mul(var_11, var_8);
    }
    var_13 = wp::where(var_7, var_9, var_12);
    wp::assign_inplace(var_3, var_4, var_13);
    var_15 = wp::extract(var_d, var_14);
    var_17 = (var_15 >= var_16);
    if (var_17) {
        var_18 = wp::mul(var_14, var_8);
    }
    if (!var_17) {
        var_20 = wp::add(var_14, var_19);
        var_21 = wp::mul(var_20, var_8);
    }
    var_22 = wp::where(var_17, var_18, var_21);
    wp::assign_inplace(var_3, var_14, var_22);
    var_24 = wp::extract(var_d, var_23);
    var_26 = (var_24 >= var_25);
    if (var_26) {
        var_27 = wp::mul(var_23, var_8);
    }
    if (!var_26) {
        var_29 = wp::add(var_23, var_28);
        var_30 = wp::mul(var_29, var_8);
    }
    var_31 = wp::where(var_26, var_27, var_30);
    wp::assign_inplace(var_3, var_23, var_31);
    // return sides                                                                           <L 109>
    return var_3;
}


// /work/main/src/pointloom/kernels/algebra/plain_min_max.py:11
static CUDA_CALLABLE wp::float32 larger_0(
    wp::float32 var_a,
    wp::float32 var_b)
{
    //---------
    // primal vars
    bool var_0;
    wp::float32 var_1;
    //---------
    // forward
    // def larger(a: float, b: float) -> float:                                               <L 12>
    // return a if a > b else b                                                               <L 13>
    var_0 = (var_a > var_b);
    if (var_0) {
    }
    if (!var_0) {
    }
    var_1 = wp::where(var_0, var_a, var_b);
    return var_1;
}


// /work/main/src/pointloom/kernels/algebra/plain_min_max.py:6
static CUDA_CALLABLE wp::float32 smaller_0(
    wp::float32 var_a,
    wp::float32 var_b)
{
    //---------
    // primal vars
    bool var_0;
    wp::float32 var_1;
    //---------
    // forward
    // def smaller(a: float, b: float) -> float:                                              <L 7>
    // return a if a < b else b                                                               <L 8>
    var_0 = (var_a < var_b);
    if (var_0) {
    }
    if (!var_0) {
    }
    var_1 = wp::where(var_0, var_a, var_b);
    return var_1;
}


// /work/main/src/pointloom/kernels/rays/ray_hits.py:92
static CUDA_CALLABLE wp::vec_t<3, wp::float32> rates_of_0(
    wp::vec_t<3, wp::float32> var_d,
    wp::vec_t<3, wp::int32> var_axes)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 2;
    wp::int32 var_1;
    wp::float32 var_2;
    wp::float32 var_3;
    const wp::float32 var_4 = 0.0;
    const wp::float32 var_5 = 0.0;
    const wp::float32 var_6 = 0.0;
    wp::vec_t<3, wp::float32> var_7;
    const wp::int32 var_8 = 0;
    wp::float32 var_9;
    wp::float32 var_10;
    const wp::float32 var_11 = 1e-30;
    wp::float32 var_12;
    wp::float32 var_13;
    wp::float32 var_14;
    const wp::float32 var_15 = 1e+30;
    wp::float32 var_16;
    wp::float32 var_17;
    const wp::float32 var_18 = 0.0;
    bool var_19;
    wp::float32 var_20;
    wp::float32 var_21;
    const wp::int32 var_22 = 1;
    wp::float32 var_23;
    wp::float32 var_24;
    wp::float32 var_25;
    wp::float32 var_26;
    wp::float32 var_27;
    wp::float32 var_28;
    wp::float32 var_29;
    const wp::float32 var_30 = 0.0;
    bool var_31;
    wp::float32 var_32;
    wp::float32 var_33;
    const wp::int32 var_34 = 2;
    wp::float32 var_35;
    wp::float32 var_36;
    wp::float32 var_37;
    wp::float32 var_38;
    wp::float32 var_39;
    wp::float32 var_40;
    wp::float32 var_41;
    const wp::float32 var_42 = 0.0;
    bool var_43;
    wp::float32 var_44;
    wp::float32 var_45;
    //---------
    // forward
    // def rates_of(d: vec3, axes: vec3i) -> vec3:                                            <L 93>
    // main = abs(d[axes[2]])                                                                 <L 95>
    var_1 = wp::extract(var_axes, var_0);
    var_2 = wp::extract(var_d, var_1);
    var_3 = wp::abs(var_2);
    // rates = vec3(0.0, 0.0, 0.0)                                                            <L 96>
    var_7 = wp::vec_t<3, wp::float32>(var_4, var_5, var_6);
    // for k in range(3):                                                                     <L 97>
    // rate = smaller(main / larger(abs(d[k]), main * FLATTEST), STEEPEST)                    <L 98>
    var_9 = wp::extract(var_d, var_8);
    var_10 = wp::abs(var_9);
    var_12 = wp::mul(var_3, var_11);
    var_13 = larger_0(var_10, var_12);
    var_14 = wp::div(var_3, var_13);
    var_16 = smaller_0(var_14, var_15);
    // rates[k] = rate if d[k] >= 0.0 else -rate                                              <L 99>
    var_17 = wp::extract(var_d, var_8);
    var_19 = (var_17 >= var_18);
    if (var_19) {
    }
    if (!var_19) {
        var_20 = wp::neg(var_16);
    }
    var_21 = wp::where(var_19, var_16, var_20);
    wp::assign_inplace(var_7, var_8, var_21);
    // rate = smaller(main / larger(abs(d[k]), main * FLATTEST), STEEPEST)                    <L 98>
    var_23 = wp::extract(var_d, var_22);
    var_24 = wp::abs(var_23);
    var_25 = wp::mul(var_3, var_11);
    var_26 = larger_0(var_24, var_25);
    var_27 = wp::div(var_3, var_26);
    var_28 = smaller_0(var_27, var_15);
    // rates[k] = rate if d[k] >= 0.0 else -rate                                              <L 99>
    var_29 = wp::extract(var_d, var_22);
    var_31 = (var_29 >= var_30);
    if (var_31) {
    }
    if (!var_31) {
        var_32 = wp::neg(var_28);
    }
    var_33 = wp::where(var_31, var_28, var_32);
    wp::assign_inplace(var_7, var_22, var_33);
    // rate = smaller(main / larger(abs(d[k]), main * FLATTEST), STEEPEST)                    <L 98>
    var_35 = wp::extract(var_d, var_34);
    var_36 = wp::abs(var_35);
    var_37 = wp::mul(var_3, var_11);
    var_38 = larger_0(var_36, var_37);
    var_39 = wp::div(var_3, var_38);
    var_40 = smaller_0(var_39, var_15);
    // rates[k] = rate if d[k] >= 0.0 else -rate                                              <L 99>
    var_41 = wp::extract(var_d, var_34);
    var_43 = (var_41 >= var_42);
    if (var_43) {
    }
    if (!var_43) {
        var_44 = wp::neg(var_40);
    }
    var_45 = wp::where(var_43, var_40, var_44);
    wp::assign_inplace(var_7, var_34, var_45);
    // return rates                                                                           <L 100>
    return var_7;
}


// /work/main/src/pointloom/kernels/rays/ray_hits.py:79
static CUDA_CALLABLE wp::vec_t<3, wp::float32> signed_margins_0(
    wp::vec_t<3, wp::float32> var_o,
    wp::vec_t<3, wp::float32> var_d,
    wp::vec_t<3, wp::float32> var_low,
    wp::vec_t<3, wp::float32> var_high,
    wp::vec_t<3, wp::int32> var_axes)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 0.0;
    const wp::float32 var_1 = 0.0;
    const wp::float32 var_2 = 0.0;
    wp::vec_t<3, wp::float32> var_3;
    const wp::int32 var_4 = 0;
    wp::float32 var_5;
    wp::float32 var_6;
    wp::float32 var_7;
    wp::float32 var_8;
    wp::float32 var_9;
    wp::float32 var_10;
    wp::float32 var_11;
    wp::float32 var_12;
    wp::float32 var_13;
    const wp::int32 var_14 = 1;
    wp::float32 var_15;
    wp::float32 var_16;
    wp::float32 var_17;
    wp::float32 var_18;
    wp::float32 var_19;
    wp::float32 var_20;
    wp::float32 var_21;
    wp::float32 var_22;
    wp::float32 var_23;
    const wp::int32 var_24 = 2;
    wp::float32 var_25;
    wp::float32 var_26;
    wp::float32 var_27;
    wp::float32 var_28;
    wp::float32 var_29;
    wp::float32 var_30;
    wp::float32 var_31;
    wp::float32 var_32;
    wp::float32 var_33;
    const wp::int32 var_34 = 2;
    wp::int32 var_35;
    wp::float32 var_36;
    const wp::int32 var_37 = 0;
    wp::float32 var_38;
    wp::float32 var_39;
    const wp::float32 var_40 = 1e-06;
    wp::float32 var_41;
    wp::float32 var_42;
    const wp::float32 var_43 = 0.0;
    bool var_44;
    wp::float32 var_45;
    wp::float32 var_46;
    const wp::int32 var_47 = 1;
    wp::float32 var_48;
    wp::float32 var_49;
    wp::float32 var_50;
    wp::float32 var_51;
    const wp::float32 var_52 = 0.0;
    bool var_53;
    wp::float32 var_54;
    wp::float32 var_55;
    const wp::int32 var_56 = 2;
    wp::float32 var_57;
    wp::float32 var_58;
    wp::float32 var_59;
    wp::float32 var_60;
    const wp::float32 var_61 = 0.0;
    bool var_62;
    wp::float32 var_63;
    wp::float32 var_64;
    //---------
    // forward
    // def signed_margins(o: vec3, d: vec3, low: vec3, high: vec3, axes: vec3i) -> vec3:       <L 80>
    // margins = vec3(0.0, 0.0, 0.0)                                                          <L 82>
    var_3 = wp::vec_t<3, wp::float32>(var_0, var_1, var_2);
    // for k in range(3):                                                                     <L 83>
    // margins[k] = larger(abs(low[k] - o[k]), abs(high[k] - o[k]))                           <L 84>
    var_5 = wp::extract(var_low, var_4);
    var_6 = wp::extract(var_o, var_4);
    var_7 = wp::sub(var_5, var_6);
    var_8 = wp::abs(var_7);
    var_9 = wp::extract(var_high, var_4);
    var_10 = wp::extract(var_o, var_4);
    var_11 = wp::sub(var_9, var_10);
    var_12 = wp::abs(var_11);
    var_13 = larger_0(var_8, var_12);
    wp::assign_inplace(var_3, var_4, var_13);
    var_15 = wp::extract(var_low, var_14);
    var_16 = wp::extract(var_o, var_14);
    var_17 = wp::sub(var_15, var_16);
    var_18 = wp::abs(var_17);
    var_19 = wp::extract(var_high, var_14);
    var_20 = wp::extract(var_o, var_14);
    var_21 = wp::sub(var_19, var_20);
    var_22 = wp::abs(var_21);
    var_23 = larger_0(var_18, var_22);
    wp::assign_inplace(var_3, var_14, var_23);
    var_25 = wp::extract(var_low, var_24);
    var_26 = wp::extract(var_o, var_24);
    var_27 = wp::sub(var_25, var_26);
    var_28 = wp::abs(var_27);
    var_29 = wp::extract(var_high, var_24);
    var_30 = wp::extract(var_o, var_24);
    var_31 = wp::sub(var_29, var_30);
    var_32 = wp::abs(var_31);
    var_33 = larger_0(var_28, var_32);
    wp::assign_inplace(var_3, var_24, var_33);
    // main = margins[axes[2]]                                                                <L 85>
    var_35 = wp::extract(var_axes, var_34);
    var_36 = wp::extract(var_3, var_35);
    // for k in range(3):                                                                     <L 86>
    // margin = (margins[k] + main) * MARGIN                                                  <L 87>
    var_38 = wp::extract(var_3, var_37);
    var_39 = wp::add(var_38, var_36);
    var_41 = wp::mul(var_39, var_40);
    // margins[k] = margin if d[k] >= 0.0 else -margin                                        <L 88>
    var_42 = wp::extract(var_d, var_37);
    var_44 = (var_42 >= var_43);
    if (var_44) {
    }
    if (!var_44) {
        var_45 = wp::neg(var_41);
    }
    var_46 = wp::where(var_44, var_41, var_45);
    wp::assign_inplace(var_3, var_37, var_46);
    // margin = (margins[k] + main) * MARGIN                                                  <L 87>
    var_48 = wp::extract(var_3, var_47);
    var_49 = wp::add(var_48, var_36);
    var_50 = wp::mul(var_49, var_40);
    // margins[k] = margin if d[k] >= 0.0 else -margin                                        <L 88>
    var_51 = wp::extract(var_d, var_47);
    var_53 = (var_51 >= var_52);
    if (var_53) {
    }
    if (!var_53) {
        var_54 = wp::neg(var_50);
    }
    var_55 = wp::where(var_53, var_50, var_54);
    wp::assign_inplace(var_3, var_47, var_55);
    // margin = (margins[k] + main) * MARGIN                                                  <L 87>
    var_57 = wp::extract(var_3, var_56);
    var_58 = wp::add(var_57, var_36);
    var_59 = wp::mul(var_58, var_40);
    // margins[k] = margin if d[k] >= 0.0 else -margin                                        <L 88>
    var_60 = wp::extract(var_d, var_56);
    var_62 = (var_60 >= var_61);
    if (var_62) {
    }
    if (!var_62) {
        var_63 = wp::neg(var_59);
    }
    var_64 = wp::where(var_62, var_59, var_63);
    wp::assign_inplace(var_3, var_56, var_64);
    // return margins                                                                         <L 89>
    return var_3;
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


// <pointloom.kernels.rays.ray_hits.measure_entries>:1
static CUDA_CALLABLE wp::vec_t<8, wp::int32> measure_entries_0(
    wp::array_t<wp::float32> var_boxes,
    wp::int32 var_record,
    wp::vec_t<3, wp::int32> var_near,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::vec_t<3, wp::float32> var_rates,
    wp::float32 var_begin,
    wp::float32 var_end)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::vec_t<8, wp::int32> var_1;
    const wp::int32 var_2 = 48;
    wp::int32 var_3;
    const wp::int32 var_4 = 0;
    wp::int32 var_5;
    wp::int32 var_6;
    const wp::int32 var_7 = 1;
    wp::int32 var_8;
    wp::int32 var_9;
    const wp::int32 var_10 = 2;
    wp::int32 var_11;
    wp::int32 var_12;
    const wp::int32 var_13 = 3;
    const wp::int32 var_14 = 8;
    wp::int32 var_15;
    wp::int32 var_16;
    const wp::int32 var_17 = 0;
    wp::int32 var_18;
    wp::int32 var_19;
    const wp::int32 var_20 = 5;
    wp::int32 var_21;
    wp::int32 var_22;
    const wp::int32 var_23 = 1;
    wp::int32 var_24;
    wp::int32 var_25;
    const wp::int32 var_26 = 7;
    wp::int32 var_27;
    wp::int32 var_28;
    const wp::int32 var_29 = 2;
    wp::int32 var_30;
    wp::int32 var_31;
    const wp::int32 var_32 = 0;
    wp::int32 var_33;
    wp::float32* var_34;
    const wp::int32 var_35 = 0;
    wp::float32 var_36;
    wp::float32 var_37;
    wp::float32 var_38;
    const wp::int32 var_39 = 0;
    wp::float32 var_40;
    wp::float32 var_41;
    wp::int32 var_42;
    wp::float32* var_43;
    const wp::int32 var_44 = 1;
    wp::float32 var_45;
    wp::float32 var_46;
    wp::float32 var_47;
    const wp::int32 var_48 = 1;
    wp::float32 var_49;
    wp::float32 var_50;
    wp::int32 var_51;
    wp::float32* var_52;
    const wp::int32 var_53 = 2;
    wp::float32 var_54;
    wp::float32 var_55;
    wp::float32 var_56;
    const wp::int32 var_57 = 2;
    wp::float32 var_58;
    wp::float32 var_59;
    wp::float32 var_60;
    wp::float32 var_61;
    wp::float32 var_62;
    wp::int32 var_63;
    wp::float32* var_64;
    const wp::int32 var_65 = 0;
    wp::float32 var_66;
    wp::float32 var_67;
    wp::float32 var_68;
    const wp::int32 var_69 = 0;
    wp::float32 var_70;
    wp::float32 var_71;
    wp::int32 var_72;
    wp::float32* var_73;
    const wp::int32 var_74 = 1;
    wp::float32 var_75;
    wp::float32 var_76;
    wp::float32 var_77;
    const wp::int32 var_78 = 1;
    wp::float32 var_79;
    wp::float32 var_80;
    wp::int32 var_81;
    wp::float32* var_82;
    const wp::int32 var_83 = 2;
    wp::float32 var_84;
    wp::float32 var_85;
    wp::float32 var_86;
    const wp::int32 var_87 = 2;
    wp::float32 var_88;
    wp::float32 var_89;
    wp::float32 var_90;
    wp::float32 var_91;
    wp::float32 var_92;
    bool var_93;
    wp::int32 var_94;
    const wp::int32 var_95 = 7;
    wp::int32 var_96;
    wp::int32 var_97;
    wp::int32 var_98;
    const wp::int32 var_99 = 2147483647;
    wp::int32 var_100;
    const wp::int32 var_101 = 1;
    wp::int32 var_102;
    wp::float32* var_103;
    const wp::int32 var_104 = 0;
    wp::float32 var_105;
    wp::float32 var_106;
    wp::float32 var_107;
    const wp::int32 var_108 = 0;
    wp::float32 var_109;
    wp::float32 var_110;
    wp::int32 var_111;
    wp::float32* var_112;
    const wp::int32 var_113 = 1;
    wp::float32 var_114;
    wp::float32 var_115;
    wp::float32 var_116;
    const wp::int32 var_117 = 1;
    wp::float32 var_118;
    wp::float32 var_119;
    wp::int32 var_120;
    wp::float32* var_121;
    const wp::int32 var_122 = 2;
    wp::float32 var_123;
    wp::float32 var_124;
    wp::float32 var_125;
    const wp::int32 var_126 = 2;
    wp::float32 var_127;
    wp::float32 var_128;
    wp::float32 var_129;
    wp::float32 var_130;
    wp::float32 var_131;
    wp::int32 var_132;
    wp::float32* var_133;
    const wp::int32 var_134 = 0;
    wp::float32 var_135;
    wp::float32 var_136;
    wp::float32 var_137;
    const wp::int32 var_138 = 0;
    wp::float32 var_139;
    wp::float32 var_140;
    wp::int32 var_141;
    wp::float32* var_142;
    const wp::int32 var_143 = 1;
    wp::float32 var_144;
    wp::float32 var_145;
    wp::float32 var_146;
    const wp::int32 var_147 = 1;
    wp::float32 var_148;
    wp::float32 var_149;
    wp::int32 var_150;
    wp::float32* var_151;
    const wp::int32 var_152 = 2;
    wp::float32 var_153;
    wp::float32 var_154;
    wp::float32 var_155;
    const wp::int32 var_156 = 2;
    wp::float32 var_157;
    wp::float32 var_158;
    wp::float32 var_159;
    wp::float32 var_160;
    wp::float32 var_161;
    bool var_162;
    wp::int32 var_163;
    const wp::int32 var_164 = 7;
    wp::int32 var_165;
    wp::int32 var_166;
    wp::int32 var_167;
    wp::int32 var_168;
    const wp::int32 var_169 = 2;
    wp::int32 var_170;
    wp::float32* var_171;
    const wp::int32 var_172 = 0;
    wp::float32 var_173;
    wp::float32 var_174;
    wp::float32 var_175;
    const wp::int32 var_176 = 0;
    wp::float32 var_177;
    wp::float32 var_178;
    wp::int32 var_179;
    wp::float32* var_180;
    const wp::int32 var_181 = 1;
    wp::float32 var_182;
    wp::float32 var_183;
    wp::float32 var_184;
    const wp::int32 var_185 = 1;
    wp::float32 var_186;
    wp::float32 var_187;
    wp::int32 var_188;
    wp::float32* var_189;
    const wp::int32 var_190 = 2;
    wp::float32 var_191;
    wp::float32 var_192;
    wp::float32 var_193;
    const wp::int32 var_194 = 2;
    wp::float32 var_195;
    wp::float32 var_196;
    wp::float32 var_197;
    wp::float32 var_198;
    wp::float32 var_199;
    wp::int32 var_200;
    wp::float32* var_201;
    const wp::int32 var_202 = 0;
    wp::float32 var_203;
    wp::float32 var_204;
    wp::float32 var_205;
    const wp::int32 var_206 = 0;
    wp::float32 var_207;
    wp::float32 var_208;
    wp::int32 var_209;
    wp::float32* var_210;
    const wp::int32 var_211 = 1;
    wp::float32 var_212;
    wp::float32 var_213;
    wp::float32 var_214;
    const wp::int32 var_215 = 1;
    wp::float32 var_216;
    wp::float32 var_217;
    wp::int32 var_218;
    wp::float32* var_219;
    const wp::int32 var_220 = 2;
    wp::float32 var_221;
    wp::float32 var_222;
    wp::float32 var_223;
    const wp::int32 var_224 = 2;
    wp::float32 var_225;
    wp::float32 var_226;
    wp::float32 var_227;
    wp::float32 var_228;
    wp::float32 var_229;
    bool var_230;
    wp::int32 var_231;
    const wp::int32 var_232 = 7;
    wp::int32 var_233;
    wp::int32 var_234;
    wp::int32 var_235;
    wp::int32 var_236;
    const wp::int32 var_237 = 3;
    wp::int32 var_238;
    wp::float32* var_239;
    const wp::int32 var_240 = 0;
    wp::float32 var_241;
    wp::float32 var_242;
    wp::float32 var_243;
    const wp::int32 var_244 = 0;
    wp::float32 var_245;
    wp::float32 var_246;
    wp::int32 var_247;
    wp::float32* var_248;
    const wp::int32 var_249 = 1;
    wp::float32 var_250;
    wp::float32 var_251;
    wp::float32 var_252;
    const wp::int32 var_253 = 1;
    wp::float32 var_254;
    wp::float32 var_255;
    wp::int32 var_256;
    wp::float32* var_257;
    const wp::int32 var_258 = 2;
    wp::float32 var_259;
    wp::float32 var_260;
    wp::float32 var_261;
    const wp::int32 var_262 = 2;
    wp::float32 var_263;
    wp::float32 var_264;
    wp::float32 var_265;
    wp::float32 var_266;
    wp::float32 var_267;
    wp::int32 var_268;
    wp::float32* var_269;
    const wp::int32 var_270 = 0;
    wp::float32 var_271;
    wp::float32 var_272;
    wp::float32 var_273;
    const wp::int32 var_274 = 0;
    wp::float32 var_275;
    wp::float32 var_276;
    wp::int32 var_277;
    wp::float32* var_278;
    const wp::int32 var_279 = 1;
    wp::float32 var_280;
    wp::float32 var_281;
    wp::float32 var_282;
    const wp::int32 var_283 = 1;
    wp::float32 var_284;
    wp::float32 var_285;
    wp::int32 var_286;
    wp::float32* var_287;
    const wp::int32 var_288 = 2;
    wp::float32 var_289;
    wp::float32 var_290;
    wp::float32 var_291;
    const wp::int32 var_292 = 2;
    wp::float32 var_293;
    wp::float32 var_294;
    wp::float32 var_295;
    wp::float32 var_296;
    wp::float32 var_297;
    bool var_298;
    wp::int32 var_299;
    const wp::int32 var_300 = 7;
    wp::int32 var_301;
    wp::int32 var_302;
    wp::int32 var_303;
    wp::int32 var_304;
    const wp::int32 var_305 = 4;
    wp::int32 var_306;
    wp::float32* var_307;
    const wp::int32 var_308 = 0;
    wp::float32 var_309;
    wp::float32 var_310;
    wp::float32 var_311;
    const wp::int32 var_312 = 0;
    wp::float32 var_313;
    wp::float32 var_314;
    wp::int32 var_315;
    wp::float32* var_316;
    const wp::int32 var_317 = 1;
    wp::float32 var_318;
    wp::float32 var_319;
    wp::float32 var_320;
    const wp::int32 var_321 = 1;
    wp::float32 var_322;
    wp::float32 var_323;
    wp::int32 var_324;
    wp::float32* var_325;
    const wp::int32 var_326 = 2;
    wp::float32 var_327;
    wp::float32 var_328;
    wp::float32 var_329;
    const wp::int32 var_330 = 2;
    wp::float32 var_331;
    wp::float32 var_332;
    wp::float32 var_333;
    wp::float32 var_334;
    wp::float32 var_335;
    wp::int32 var_336;
    wp::float32* var_337;
    const wp::int32 var_338 = 0;
    wp::float32 var_339;
    wp::float32 var_340;
    wp::float32 var_341;
    const wp::int32 var_342 = 0;
    wp::float32 var_343;
    wp::float32 var_344;
    wp::int32 var_345;
    wp::float32* var_346;
    const wp::int32 var_347 = 1;
    wp::float32 var_348;
    wp::float32 var_349;
    wp::float32 var_350;
    const wp::int32 var_351 = 1;
    wp::float32 var_352;
    wp::float32 var_353;
    wp::int32 var_354;
    wp::float32* var_355;
    const wp::int32 var_356 = 2;
    wp::float32 var_357;
    wp::float32 var_358;
    wp::float32 var_359;
    const wp::int32 var_360 = 2;
    wp::float32 var_361;
    wp::float32 var_362;
    wp::float32 var_363;
    wp::float32 var_364;
    wp::float32 var_365;
    bool var_366;
    wp::int32 var_367;
    const wp::int32 var_368 = 7;
    wp::int32 var_369;
    wp::int32 var_370;
    wp::int32 var_371;
    wp::int32 var_372;
    const wp::int32 var_373 = 5;
    wp::int32 var_374;
    wp::float32* var_375;
    const wp::int32 var_376 = 0;
    wp::float32 var_377;
    wp::float32 var_378;
    wp::float32 var_379;
    const wp::int32 var_380 = 0;
    wp::float32 var_381;
    wp::float32 var_382;
    wp::int32 var_383;
    wp::float32* var_384;
    const wp::int32 var_385 = 1;
    wp::float32 var_386;
    wp::float32 var_387;
    wp::float32 var_388;
    const wp::int32 var_389 = 1;
    wp::float32 var_390;
    wp::float32 var_391;
    wp::int32 var_392;
    wp::float32* var_393;
    const wp::int32 var_394 = 2;
    wp::float32 var_395;
    wp::float32 var_396;
    wp::float32 var_397;
    const wp::int32 var_398 = 2;
    wp::float32 var_399;
    wp::float32 var_400;
    wp::float32 var_401;
    wp::float32 var_402;
    wp::float32 var_403;
    wp::int32 var_404;
    wp::float32* var_405;
    const wp::int32 var_406 = 0;
    wp::float32 var_407;
    wp::float32 var_408;
    wp::float32 var_409;
    const wp::int32 var_410 = 0;
    wp::float32 var_411;
    wp::float32 var_412;
    wp::int32 var_413;
    wp::float32* var_414;
    const wp::int32 var_415 = 1;
    wp::float32 var_416;
    wp::float32 var_417;
    wp::float32 var_418;
    const wp::int32 var_419 = 1;
    wp::float32 var_420;
    wp::float32 var_421;
    wp::int32 var_422;
    wp::float32* var_423;
    const wp::int32 var_424 = 2;
    wp::float32 var_425;
    wp::float32 var_426;
    wp::float32 var_427;
    const wp::int32 var_428 = 2;
    wp::float32 var_429;
    wp::float32 var_430;
    wp::float32 var_431;
    wp::float32 var_432;
    wp::float32 var_433;
    bool var_434;
    wp::int32 var_435;
    const wp::int32 var_436 = 7;
    wp::int32 var_437;
    wp::int32 var_438;
    wp::int32 var_439;
    wp::int32 var_440;
    const wp::int32 var_441 = 6;
    wp::int32 var_442;
    wp::float32* var_443;
    const wp::int32 var_444 = 0;
    wp::float32 var_445;
    wp::float32 var_446;
    wp::float32 var_447;
    const wp::int32 var_448 = 0;
    wp::float32 var_449;
    wp::float32 var_450;
    wp::int32 var_451;
    wp::float32* var_452;
    const wp::int32 var_453 = 1;
    wp::float32 var_454;
    wp::float32 var_455;
    wp::float32 var_456;
    const wp::int32 var_457 = 1;
    wp::float32 var_458;
    wp::float32 var_459;
    wp::int32 var_460;
    wp::float32* var_461;
    const wp::int32 var_462 = 2;
    wp::float32 var_463;
    wp::float32 var_464;
    wp::float32 var_465;
    const wp::int32 var_466 = 2;
    wp::float32 var_467;
    wp::float32 var_468;
    wp::float32 var_469;
    wp::float32 var_470;
    wp::float32 var_471;
    wp::int32 var_472;
    wp::float32* var_473;
    const wp::int32 var_474 = 0;
    wp::float32 var_475;
    wp::float32 var_476;
    wp::float32 var_477;
    const wp::int32 var_478 = 0;
    wp::float32 var_479;
    wp::float32 var_480;
    wp::int32 var_481;
    wp::float32* var_482;
    const wp::int32 var_483 = 1;
    wp::float32 var_484;
    wp::float32 var_485;
    wp::float32 var_486;
    const wp::int32 var_487 = 1;
    wp::float32 var_488;
    wp::float32 var_489;
    wp::int32 var_490;
    wp::float32* var_491;
    const wp::int32 var_492 = 2;
    wp::float32 var_493;
    wp::float32 var_494;
    wp::float32 var_495;
    const wp::int32 var_496 = 2;
    wp::float32 var_497;
    wp::float32 var_498;
    wp::float32 var_499;
    wp::float32 var_500;
    wp::float32 var_501;
    bool var_502;
    wp::int32 var_503;
    const wp::int32 var_504 = 7;
    wp::int32 var_505;
    wp::int32 var_506;
    wp::int32 var_507;
    wp::int32 var_508;
    const wp::int32 var_509 = 7;
    wp::int32 var_510;
    wp::float32* var_511;
    const wp::int32 var_512 = 0;
    wp::float32 var_513;
    wp::float32 var_514;
    wp::float32 var_515;
    const wp::int32 var_516 = 0;
    wp::float32 var_517;
    wp::float32 var_518;
    wp::int32 var_519;
    wp::float32* var_520;
    const wp::int32 var_521 = 1;
    wp::float32 var_522;
    wp::float32 var_523;
    wp::float32 var_524;
    const wp::int32 var_525 = 1;
    wp::float32 var_526;
    wp::float32 var_527;
    wp::int32 var_528;
    wp::float32* var_529;
    const wp::int32 var_530 = 2;
    wp::float32 var_531;
    wp::float32 var_532;
    wp::float32 var_533;
    const wp::int32 var_534 = 2;
    wp::float32 var_535;
    wp::float32 var_536;
    wp::float32 var_537;
    wp::float32 var_538;
    wp::float32 var_539;
    wp::int32 var_540;
    wp::float32* var_541;
    const wp::int32 var_542 = 0;
    wp::float32 var_543;
    wp::float32 var_544;
    wp::float32 var_545;
    const wp::int32 var_546 = 0;
    wp::float32 var_547;
    wp::float32 var_548;
    wp::int32 var_549;
    wp::float32* var_550;
    const wp::int32 var_551 = 1;
    wp::float32 var_552;
    wp::float32 var_553;
    wp::float32 var_554;
    const wp::int32 var_555 = 1;
    wp::float32 var_556;
    wp::float32 var_557;
    wp::int32 var_558;
    wp::float32* var_559;
    const wp::int32 var_560 = 2;
    wp::float32 var_561;
    wp::float32 var_562;
    wp::float32 var_563;
    const wp::int32 var_564 = 2;
    wp::float32 var_565;
    wp::float32 var_566;
    wp::float32 var_567;
    wp::float32 var_568;
    wp::float32 var_569;
    bool var_570;
    wp::int32 var_571;
    const wp::int32 var_572 = 7;
    wp::int32 var_573;
    wp::int32 var_574;
    wp::int32 var_575;
    wp::int32 var_576;
    //---------
    // forward
    // def measure_entries(boxes, record, near, a, b, rates, begin, end):                     <L 1>
    // keys = entry_keys(0)                                                                   <L 3>
    var_1 = wp::vec_t<8, wp::int32>(var_0);
    // at__child_entries__1 = record * SIDES__child_entries                                   <L 4>
    var_3 = wp::mul(var_record, var_2);
    // x0__child_entries__1 = at__child_entries__1 + near[0]                                  <L 5>
    var_5 = wp::extract(var_near, var_4);
    var_6 = wp::add(var_3, var_5);
    // y0__child_entries__1 = at__child_entries__1 + near[1]                                  <L 6>
    var_8 = wp::extract(var_near, var_7);
    var_9 = wp::add(var_3, var_8);
    // z0__child_entries__1 = at__child_entries__1 + near[2]                                  <L 7>
    var_11 = wp::extract(var_near, var_10);
    var_12 = wp::add(var_3, var_11);
    // x1__child_entries__1 = at__child_entries__1 + 3 * FAN__child_entries - near[0]         <L 8>
    var_15 = wp::mul(var_13, var_14);
    var_16 = wp::add(var_3, var_15);
    var_18 = wp::extract(var_near, var_17);
    var_19 = wp::sub(var_16, var_18);
    // y1__child_entries__1 = at__child_entries__1 + 5 * FAN__child_entries - near[1]         <L 9>
    var_21 = wp::mul(var_20, var_14);
    var_22 = wp::add(var_3, var_21);
    var_24 = wp::extract(var_near, var_23);
    var_25 = wp::sub(var_22, var_24);
    // z1__child_entries__1 = at__child_entries__1 + 7 * FAN__child_entries - near[2]         <L 10>
    var_27 = wp::mul(var_26, var_14);
    var_28 = wp::add(var_3, var_27);
    var_30 = wp::extract(var_near, var_29);
    var_31 = wp::sub(var_28, var_30);
    // for j in range(FAN__child_entries):                                                    <L 11>
    // x__child_entries__1 = (boxes[x0__child_entries__1 + j] - a[0]) * rates[0]              <L 12>
    var_33 = wp::add(var_6, var_32);
    var_34 = wp::address(var_boxes, var_33);
    var_36 = wp::extract(var_a, var_35);
    var_38 = wp::load(var_34);
    var_37 = wp::sub(var_38, var_36);
    var_40 = wp::extract(var_rates, var_39);
    var_41 = wp::mul(var_37, var_40);
    // y__child_entries__1 = (boxes[y0__child_entries__1 + j] - a[1]) * rates[1]              <L 13>
    var_42 = wp::add(var_9, var_32);
    var_43 = wp::address(var_boxes, var_42);
    var_45 = wp::extract(var_a, var_44);
    var_47 = wp::load(var_43);
    var_46 = wp::sub(var_47, var_45);
    var_49 = wp::extract(var_rates, var_48);
    var_50 = wp::mul(var_46, var_49);
    // z__child_entries__1 = (boxes[z0__child_entries__1 + j] - a[2]) * rates[2]              <L 14>
    var_51 = wp::add(var_12, var_32);
    var_52 = wp::address(var_boxes, var_51);
    var_54 = wp::extract(var_a, var_53);
    var_56 = wp::load(var_52);
    var_55 = wp::sub(var_56, var_54);
    var_58 = wp::extract(var_rates, var_57);
    var_59 = wp::mul(var_55, var_58);
    // first__child_entries__1 = larger(larger(x__child_entries__1, y__child_entries__1), larger(z__child_entries__1, begin))       <L 15>
    var_60 = larger_0(var_41, var_50);
    var_61 = larger_0(var_59, var_begin);
    var_62 = larger_0(var_60, var_61);
    // u__child_entries__1 = (boxes[x1__child_entries__1 + j] - b[0]) * rates[0]              <L 16>
    var_63 = wp::add(var_19, var_32);
    var_64 = wp::address(var_boxes, var_63);
    var_66 = wp::extract(var_b, var_65);
    var_68 = wp::load(var_64);
    var_67 = wp::sub(var_68, var_66);
    var_70 = wp::extract(var_rates, var_69);
    var_71 = wp::mul(var_67, var_70);
    // v__child_entries__1 = (boxes[y1__child_entries__1 + j] - b[1]) * rates[1]              <L 17>
    var_72 = wp::add(var_25, var_32);
    var_73 = wp::address(var_boxes, var_72);
    var_75 = wp::extract(var_b, var_74);
    var_77 = wp::load(var_73);
    var_76 = wp::sub(var_77, var_75);
    var_79 = wp::extract(var_rates, var_78);
    var_80 = wp::mul(var_76, var_79);
    // w__child_entries__1 = (boxes[z1__child_entries__1 + j] - b[2]) * rates[2]              <L 18>
    var_81 = wp::add(var_31, var_32);
    var_82 = wp::address(var_boxes, var_81);
    var_84 = wp::extract(var_b, var_83);
    var_86 = wp::load(var_82);
    var_85 = wp::sub(var_86, var_84);
    var_88 = wp::extract(var_rates, var_87);
    var_89 = wp::mul(var_85, var_88);
    // last__child_entries__1 = smaller(smaller(u__child_entries__1, v__child_entries__1), smaller(w__child_entries__1, end))       <L 19>
    var_90 = smaller_0(var_71, var_80);
    var_91 = smaller_0(var_89, var_end);
    var_92 = smaller_0(var_90, var_91);
    // key = float_bits(first__child_entries__1) & ~7 | j if first__child_entries__1 <= last__child_entries__1 else NOT_ENTERED__child_entries       <L 20>
    var_93 = (var_62 <= var_92);
    if (var_93) {
        var_94 = _float_bits_0(var_62);
        var_96 = wp::invert(var_95);
        var_97 = wp::bit_and(var_94, var_96);
        var_98 = wp::bit_or(var_97, var_32);
    }
    if (!var_93) {
    }
    var_100 = wp::where(var_93, var_98, var_99);
    // keys[j] = key                                                                          <L 21>
    wp::assign_inplace(var_1, var_32, var_100);
    // x__child_entries__1 = (boxes[x0__child_entries__1 + j] - a[0]) * rates[0]              <L 12>
    var_102 = wp::add(var_6, var_101);
    var_103 = wp::address(var_boxes, var_102);
    var_105 = wp::extract(var_a, var_104);
    var_107 = wp::load(var_103);
    var_106 = wp::sub(var_107, var_105);
    var_109 = wp::extract(var_rates, var_108);
    var_110 = wp::mul(var_106, var_109);
    // y__child_entries__1 = (boxes[y0__child_entries__1 + j] - a[1]) * rates[1]              <L 13>
    var_111 = wp::add(var_9, var_101);
    var_112 = wp::address(var_boxes, var_111);
    var_114 = wp::extract(var_a, var_113);
    var_116 = wp::load(var_112);
    var_115 = wp::sub(var_116, var_114);
    var_118 = wp::extract(var_rates, var_117);
    var_119 = wp::mul(var_115, var_118);
    // z__child_entries__1 = (boxes[z0__child_entries__1 + j] - a[2]) * rates[2]              <L 14>
    var_120 = wp::add(var_12, var_101);
    var_121 = wp::address(var_boxes, var_120);
    var_123 = wp::extract(var_a, var_122);
    var_125 = wp::load(var_121);
    var_124 = wp::sub(var_125, var_123);
    var_127 = wp::extract(var_rates, var_126);
    var_128 = wp::mul(var_124, var_127);
    // first__child_entries__1 = larger(larger(x__child_entries__1, y__child_entries__1), larger(z__child_entries__1, begin))       <L 15>
    var_129 = larger_0(var_110, var_119);
    var_130 = larger_0(var_128, var_begin);
    var_131 = larger_0(var_129, var_130);
    // u__child_entries__1 = (boxes[x1__child_entries__1 + j] - b[0]) * rates[0]              <L 16>
    var_132 = wp::add(var_19, var_101);
    var_133 = wp::address(var_boxes, var_132);
    var_135 = wp::extract(var_b, var_134);
    var_137 = wp::load(var_133);
    var_136 = wp::sub(var_137, var_135);
    var_139 = wp::extract(var_rates, var_138);
    var_140 = wp::mul(var_136, var_139);
    // v__child_entries__1 = (boxes[y1__child_entries__1 + j] - b[1]) * rates[1]              <L 17>
    var_141 = wp::add(var_25, var_101);
    var_142 = wp::address(var_boxes, var_141);
    var_144 = wp::extract(var_b, var_143);
    var_146 = wp::load(var_142);
    var_145 = wp::sub(var_146, var_144);
    var_148 = wp::extract(var_rates, var_147);
    var_149 = wp::mul(var_145, var_148);
    // w__child_entries__1 = (boxes[z1__child_entries__1 + j] - b[2]) * rates[2]              <L 18>
    var_150 = wp::add(var_31, var_101);
    var_151 = wp::address(var_boxes, var_150);
    var_153 = wp::extract(var_b, var_152);
    var_155 = wp::load(var_151);
    var_154 = wp::sub(var_155, var_153);
    var_157 = wp::extract(var_rates, var_156);
    var_158 = wp::mul(var_154, var_157);
    // last__child_entries__1 = smaller(smaller(u__child_entries__1, v__child_entries__1), smaller(w__child_entries__1, end))       <L 19>
    var_159 = smaller_0(var_140, var_149);
    var_160 = smaller_0(var_158, var_end);
    var_161 = smaller_0(var_159, var_160);
    // key = float_bits(first__child_entries__1) & ~7 | j if first__child_entries__1 <= last__child_entries__1 else NOT_ENTERED__child_entries       <L 20>
    var_162 = (var_131 <= var_161);
    if (var_162) {
        var_163 = _float_bits_0(var_131);
        var_165 = wp::invert(var_164);
        var_166 = wp::bit_and(var_163, var_165);
        var_167 = wp::bit_or(var_166, var_101);
    }
    if (!var_162) {
    }
    var_168 = wp::where(var_162, var_167, var_99);
    // keys[j] = key                                                                          <L 21>
    wp::assign_inplace(var_1, var_101, var_168);
    // x__child_entries__1 = (boxes[x0__child_entries__1 + j] - a[0]) * rates[0]              <L 12>
    var_170 = wp::add(var_6, var_169);
    var_171 = wp::address(var_boxes, var_170);
    var_173 = wp::extract(var_a, var_172);
    var_175 = wp::load(var_171);
    var_174 = wp::sub(var_175, var_173);
    var_177 = wp::extract(var_rates, var_176);
    var_178 = wp::mul(var_174, var_177);
    // y__child_entries__1 = (boxes[y0__child_entries__1 + j] - a[1]) * rates[1]              <L 13>
    var_179 = wp::add(var_9, var_169);
    var_180 = wp::address(var_boxes, var_179);
    var_182 = wp::extract(var_a, var_181);
    var_184 = wp::load(var_180);
    var_183 = wp::sub(var_184, var_182);
    var_186 = wp::extract(var_rates, var_185);
    var_187 = wp::mul(var_183, var_186);
    // z__child_entries__1 = (boxes[z0__child_entries__1 + j] - a[2]) * rates[2]              <L 14>
    var_188 = wp::add(var_12, var_169);
    var_189 = wp::address(var_boxes, var_188);
    var_191 = wp::extract(var_a, var_190);
    var_193 = wp::load(var_189);
    var_192 = wp::sub(var_193, var_191);
    var_195 = wp::extract(var_rates, var_194);
    var_196 = wp::mul(var_192, var_195);
    // first__child_entries__1 = larger(larger(x__child_entries__1, y__child_entries__1), larger(z__child_entries__1, begin))       <L 15>
    var_197 = larger_0(var_178, var_187);
    var_198 = larger_0(var_196, var_begin);
    var_199 = larger_0(var_197, var_198);
    // u__child_entries__1 = (boxes[x1__child_entries__1 + j] - b[0]) * rates[0]              <L 16>
    var_200 = wp::add(var_19, var_169);
    var_201 = wp::address(var_boxes, var_200);
    var_203 = wp::extract(var_b, var_202);
    var_205 = wp::load(var_201);
    var_204 = wp::sub(var_205, var_203);
    var_207 = wp::extract(var_rates, var_206);
    var_208 = wp::mul(var_204, var_207);
    // v__child_entries__1 = (boxes[y1__child_entries__1 + j] - b[1]) * rates[1]              <L 17>
    var_209 = wp::add(var_25, var_169);
    var_210 = wp::address(var_boxes, var_209);
    var_212 = wp::extract(var_b, var_211);
    var_214 = wp::load(var_210);
    var_213 = wp::sub(var_214, var_212);
    var_216 = wp::extract(var_rates, var_215);
    var_217 = wp::mul(var_213, var_216);
    // w__child_entries__1 = (boxes[z1__child_entries__1 + j] - b[2]) * rates[2]              <L 18>
    var_218 = wp::add(var_31, var_169);
    var_219 = wp::address(var_boxes, var_218);
    var_221 = wp::extract(var_b, var_220);
    var_223 = wp::load(var_219);
    var_222 = wp::sub(var_223, var_221);
    var_225 = wp::extract(var_rates, var_224);
    var_226 = wp::mul(var_222, var_225);
    // last__child_entries__1 = smaller(smaller(u__child_entries__1, v__child_entries__1), smaller(w__child_entries__1, end))       <L 19>
    var_227 = smaller_0(var_208, var_217);
    var_228 = smaller_0(var_226, var_end);
    var_229 = smaller_0(var_227, var_228);
    // key = float_bits(first__child_entries__1) & ~7 | j if first__child_entries__1 <= last__child_entries__1 else NOT_ENTERED__child_entries       <L 20>
    var_230 = (var_199 <= var_229);
    if (var_230) {
        var_231 = _float_bits_0(var_199);
        var_233 = wp::invert(var_232);
        var_234 = wp::bit_and(var_231, var_233);
        var_235 = wp::bit_or(var_234, var_169);
    }
    if (!var_230) {
    }
    var_236 = wp::where(var_230, var_235, var_99);
    // keys[j] = key                                                                          <L 21>
    wp::assign_inplace(var_1, var_169, var_236);
    // x__child_entries__1 = (boxes[x0__child_entries__1 + j] - a[0]) * rates[0]              <L 12>
    var_238 = wp::add(var_6, var_237);
    var_239 = wp::address(var_boxes, var_238);
    var_241 = wp::extract(var_a, var_240);
    var_243 = wp::load(var_239);
    var_242 = wp::sub(var_243, var_241);
    var_245 = wp::extract(var_rates, var_244);
    var_246 = wp::mul(var_242, var_245);
    // y__child_entries__1 = (boxes[y0__child_entries__1 + j] - a[1]) * rates[1]              <L 13>
    var_247 = wp::add(var_9, var_237);
    var_248 = wp::address(var_boxes, var_247);
    var_250 = wp::extract(var_a, var_249);
    var_252 = wp::load(var_248);
    var_251 = wp::sub(var_252, var_250);
    var_254 = wp::extract(var_rates, var_253);
    var_255 = wp::mul(var_251, var_254);
    // z__child_entries__1 = (boxes[z0__child_entries__1 + j] - a[2]) * rates[2]              <L 14>
    var_256 = wp::add(var_12, var_237);
    var_257 = wp::address(var_boxes, var_256);
    var_259 = wp::extract(var_a, var_258);
    var_261 = wp::load(var_257);
    var_260 = wp::sub(var_261, var_259);
    var_263 = wp::extract(var_rates, var_262);
    var_264 = wp::mul(var_260, var_263);
    // first__child_entries__1 = larger(larger(x__child_entries__1, y__child_entries__1), larger(z__child_entries__1, begin))       <L 15>
    var_265 = larger_0(var_246, var_255);
    var_266 = larger_0(var_264, var_begin);
    var_267 = larger_0(var_265, var_266);
    // u__child_entries__1 = (boxes[x1__child_entries__1 + j] - b[0]) * rates[0]              <L 16>
    var_268 = wp::add(var_19, var_237);
    var_269 = wp::address(var_boxes, var_268);
    var_271 = wp::extract(var_b, var_270);
    var_273 = wp::load(var_269);
    var_272 = wp::sub(var_273, var_271);
    var_275 = wp::extract(var_rates, var_274);
    var_276 = wp::mul(var_272, var_275);
    // v__child_entries__1 = (boxes[y1__child_entries__1 + j] - b[1]) * rates[1]              <L 17>
    var_277 = wp::add(var_25, var_237);
    var_278 = wp::address(var_boxes, var_277);
    var_280 = wp::extract(var_b, var_279);
    var_282 = wp::load(var_278);
    var_281 = wp::sub(var_282, var_280);
    var_284 = wp::extract(var_rates, var_283);
    var_285 = wp::mul(var_281, var_284);
    // w__child_entries__1 = (boxes[z1__child_entries__1 + j] - b[2]) * rates[2]              <L 18>
    var_286 = wp::add(var_31, var_237);
    var_287 = wp::address(var_boxes, var_286);
    var_289 = wp::extract(var_b, var_288);
    var_291 = wp::load(var_287);
    var_290 = wp::sub(var_291, var_289);
    var_293 = wp::extract(var_rates, var_292);
    var_294 = wp::mul(var_290, var_293);
    // last__child_entries__1 = smaller(smaller(u__child_entries__1, v__child_entries__1), smaller(w__child_entries__1, end))       <L 19>
    var_295 = smaller_0(var_276, var_285);
    var_296 = smaller_0(var_294, var_end);
    var_297 = smaller_0(var_295, var_296);
    // key = float_bits(first__child_entries__1) & ~7 | j if first__child_entries__1 <= last__child_entries__1 else NOT_ENTERED__child_entries       <L 20>
    var_298 = (var_267 <= var_297);
    if (var_298) {
        var_299 = _float_bits_0(var_267);
        var_301 = wp::invert(var_300);
        var_302 = wp::bit_and(var_299, var_301);
        var_303 = wp::bit_or(var_302, var_237);
    }
    if (!var_298) {
    }
    var_304 = wp::where(var_298, var_303, var_99);
    // keys[j] = key                                                                          <L 21>
    wp::assign_inplace(var_1, var_237, var_304);
    // x__child_entries__1 = (boxes[x0__child_entries__1 + j] - a[0]) * rates[0]              <L 12>
    var_306 = wp::add(var_6, var_305);
    var_307 = wp::address(var_boxes, var_306);
    var_309 = wp::extract(var_a, var_308);
    var_311 = wp::load(var_307);
    var_310 = wp::sub(var_311, var_309);
    var_313 = wp::extract(var_rates, var_312);
    var_314 = wp::mul(var_310, var_313);
    // y__child_entries__1 = (boxes[y0__child_entries__1 + j] - a[1]) * rates[1]              <L 13>
    var_315 = wp::add(var_9, var_305);
    var_316 = wp::address(var_boxes, var_315);
    var_318 = wp::extract(var_a, var_317);
    var_320 = wp::load(var_316);
    var_319 = wp::sub(var_320, var_318);
    var_322 = wp::extract(var_rates, var_321);
    var_323 = wp::mul(var_319, var_322);
    // z__child_entries__1 = (boxes[z0__child_entries__1 + j] - a[2]) * rates[2]              <L 14>
    var_324 = wp::add(var_12, var_305);
    var_325 = wp::address(var_boxes, var_324);
    var_327 = wp::extract(var_a, var_326);
    var_329 = wp::load(var_325);
    var_328 = wp::sub(var_329, var_327);
    var_331 = wp::extract(var_rates, var_330);
    var_332 = wp::mul(var_328, var_331);
    // first__child_entries__1 = larger(larger(x__child_entries__1, y__child_entries__1), larger(z__child_entries__1, begin))       <L 15>
    var_333 = larger_0(var_314, var_323);
    var_334 = larger_0(var_332, var_begin);
    var_335 = larger_0(var_333, var_334);
    // u__child_entries__1 = (boxes[x1__child_entries__1 + j] - b[0]) * rates[0]              <L 16>
    var_336 = wp::add(var_19, var_305);
    var_337 = wp::address(var_boxes, var_336);
    var_339 = wp::extract(var_b, var_338);
    var_341 = wp::load(var_337);
    var_340 = wp::sub(var_341, var_339);
    var_343 = wp::extract(var_rates, var_342);
    var_344 = wp::mul(var_340, var_343);
    // v__child_entries__1 = (boxes[y1__child_entries__1 + j] - b[1]) * rates[1]              <L 17>
    var_345 = wp::add(var_25, var_305);
    var_346 = wp::address(var_boxes, var_345);
    var_348 = wp::extract(var_b, var_347);
    var_350 = wp::load(var_346);
    var_349 = wp::sub(var_350, var_348);
    var_352 = wp::extract(var_rates, var_351);
    var_353 = wp::mul(var_349, var_352);
    // w__child_entries__1 = (boxes[z1__child_entries__1 + j] - b[2]) * rates[2]              <L 18>
    var_354 = wp::add(var_31, var_305);
    var_355 = wp::address(var_boxes, var_354);
    var_357 = wp::extract(var_b, var_356);
    var_359 = wp::load(var_355);
    var_358 = wp::sub(var_359, var_357);
    var_361 = wp::extract(var_rates, var_360);
    var_362 = wp::mul(var_358, var_361);
    // last__child_entries__1 = smaller(smaller(u__child_entries__1, v__child_entries__1), smaller(w__child_entries__1, end))       <L 19>
    var_363 = smaller_0(var_344, var_353);
    var_364 = smaller_0(var_362, var_end);
    var_365 = smaller_0(var_363, var_364);
    // key = float_bits(first__child_entries__1) & ~7 | j if first__child_entries__1 <= last__child_entries__1 else NOT_ENTERED__child_entries       <L 20>
    var_366 = (var_335 <= var_365);
    if (var_366) {
        var_367 = _float_bits_0(var_335);
        var_369 = wp::invert(var_368);
        var_370 = wp::bit_and(var_367, var_369);
        var_371 = wp::bit_or(var_370, var_305);
    }
    if (!var_366) {
    }
    var_372 = wp::where(var_366, var_371, var_99);
    // keys[j] = key                                                                          <L 21>
    wp::assign_inplace(var_1, var_305, var_372);
    // x__child_entries__1 = (boxes[x0__child_entries__1 + j] - a[0]) * rates[0]              <L 12>
    var_374 = wp::add(var_6, var_373);
    var_375 = wp::address(var_boxes, var_374);
    var_377 = wp::extract(var_a, var_376);
    var_379 = wp::load(var_375);
    var_378 = wp::sub(var_379, var_377);
    var_381 = wp::extract(var_rates, var_380);
    var_382 = wp::mul(var_378, var_381);
    // y__child_entries__1 = (boxes[y0__child_entries__1 + j] - a[1]) * rates[1]              <L 13>
    var_383 = wp::add(var_9, var_373);
    var_384 = wp::address(var_boxes, var_383);
    var_386 = wp::extract(var_a, var_385);
    var_388 = wp::load(var_384);
    var_387 = wp::sub(var_388, var_386);
    var_390 = wp::extract(var_rates, var_389);
    var_391 = wp::mul(var_387, var_390);
    // z__child_entries__1 = (boxes[z0__child_entries__1 + j] - a[2]) * rates[2]              <L 14>
    var_392 = wp::add(var_12, var_373);
    var_393 = wp::address(var_boxes, var_392);
    var_395 = wp::extract(var_a, var_394);
    var_397 = wp::load(var_393);
    var_396 = wp::sub(var_397, var_395);
    var_399 = wp::extract(var_rates, var_398);
    var_400 = wp::mul(var_396, var_399);
    // first__child_entries__1 = larger(larger(x__child_entries__1, y__child_entries__1), larger(z__child_entries__1, begin))       <L 15>
    var_401 = larger_0(var_382, var_391);
    var_402 = larger_0(var_400, var_begin);
    var_403 = larger_0(var_401, var_402);
    // u__child_entries__1 = (boxes[x1__child_entries__1 + j] - b[0]) * rates[0]              <L 16>
    var_404 = wp::add(var_19, var_373);
    var_405 = wp::address(var_boxes, var_404);
    var_407 = wp::extract(var_b, var_406);
    var_409 = wp::load(var_405);
    var_408 = wp::sub(var_409, var_407);
    var_411 = wp::extract(var_rates, var_410);
    var_412 = wp::mul(var_408, var_411);
    // v__child_entries__1 = (boxes[y1__child_entries__1 + j] - b[1]) * rates[1]              <L 17>
    var_413 = wp::add(var_25, var_373);
    var_414 = wp::address(var_boxes, var_413);
    var_416 = wp::extract(var_b, var_415);
    var_418 = wp::load(var_414);
    var_417 = wp::sub(var_418, var_416);
    var_420 = wp::extract(var_rates, var_419);
    var_421 = wp::mul(var_417, var_420);
    // w__child_entries__1 = (boxes[z1__child_entries__1 + j] - b[2]) * rates[2]              <L 18>
    var_422 = wp::add(var_31, var_373);
    var_423 = wp::address(var_boxes, var_422);
    var_425 = wp::extract(var_b, var_424);
    var_427 = wp::load(var_423);
    var_426 = wp::sub(var_427, var_425);
    var_429 = wp::extract(var_rates, var_428);
    var_430 = wp::mul(var_426, var_429);
    // last__child_entries__1 = smaller(smaller(u__child_entries__1, v__child_entries__1), smaller(w__child_entries__1, end))       <L 19>
    var_431 = smaller_0(var_412, var_421);
    var_432 = smaller_0(var_430, var_end);
    var_433 = smaller_0(var_431, var_432);
    // key = float_bits(first__child_entries__1) & ~7 | j if first__child_entries__1 <= last__child_entries__1 else NOT_ENTERED__child_entries       <L 20>
    var_434 = (var_403 <= var_433);
    if (var_434) {
        var_435 = _float_bits_0(var_403);
        var_437 = wp::invert(var_436);
        var_438 = wp::bit_and(var_435, var_437);
        var_439 = wp::bit_or(var_438, var_373);
    }
    if (!var_434) {
    }
    var_440 = wp::where(var_434, var_439, var_99);
    // keys[j] = key                                                                          <L 21>
    wp::assign_inplace(var_1, var_373, var_440);
    // x__child_entries__1 = (boxes[x0__child_entries__1 + j] - a[0]) * rates[0]              <L 12>
    var_442 = wp::add(var_6, var_441);
    var_443 = wp::address(var_boxes, var_442);
    var_445 = wp::extract(var_a, var_444);
    var_447 = wp::load(var_443);
    var_446 = wp::sub(var_447, var_445);
    var_449 = wp::extract(var_rates, var_448);
    var_450 = wp::mul(var_446, var_449);
    // y__child_entries__1 = (boxes[y0__child_entries__1 + j] - a[1]) * rates[1]              <L 13>
    var_451 = wp::add(var_9, var_441);
    var_452 = wp::address(var_boxes, var_451);
    var_454 = wp::extract(var_a, var_453);
    var_456 = wp::load(var_452);
    var_455 = wp::sub(var_456, var_454);
    var_458 = wp::extract(var_rates, var_457);
    var_459 = wp::mul(var_455, var_458);
    // z__child_entries__1 = (boxes[z0__child_entries__1 + j] - a[2]) * rates[2]              <L 14>
    var_460 = wp::add(var_12, var_441);
    var_461 = wp::address(var_boxes, var_460);
    var_463 = wp::extract(var_a, var_462);
    var_465 = wp::load(var_461);
    var_464 = wp::sub(var_465, var_463);
    var_467 = wp::extract(var_rates, var_466);
    var_468 = wp::mul(var_464, var_467);
    // first__child_entries__1 = larger(larger(x__child_entries__1, y__child_entries__1), larger(z__child_entries__1, begin))       <L 15>
    var_469 = larger_0(var_450, var_459);
    var_470 = larger_0(var_468, var_begin);
    var_471 = larger_0(var_469, var_470);
    // u__child_entries__1 = (boxes[x1__child_entries__1 + j] - b[0]) * rates[0]              <L 16>
    var_472 = wp::add(var_19, var_441);
    var_473 = wp::address(var_boxes, var_472);
    var_475 = wp::extract(var_b, var_474);
    var_477 = wp::load(var_473);
    var_476 = wp::sub(var_477, var_475);
    var_479 = wp::extract(var_rates, var_478);
    var_480 = wp::mul(var_476, var_479);
    // v__child_entries__1 = (boxes[y1__child_entries__1 + j] - b[1]) * rates[1]              <L 17>
    var_481 = wp::add(var_25, var_441);
    var_482 = wp::address(var_boxes, var_481);
    var_484 = wp::extract(var_b, var_483);
    var_486 = wp::load(var_482);
    var_485 = wp::sub(var_486, var_484);
    var_488 = wp::extract(var_rates, var_487);
    var_489 = wp::mul(var_485, var_488);
    // w__child_entries__1 = (boxes[z1__child_entries__1 + j] - b[2]) * rates[2]              <L 18>
    var_490 = wp::add(var_31, var_441);
    var_491 = wp::address(var_boxes, var_490);
    var_493 = wp::extract(var_b, var_492);
    var_495 = wp::load(var_491);
    var_494 = wp::sub(var_495, var_493);
    var_497 = wp::extract(var_rates, var_496);
    var_498 = wp::mul(var_494, var_497);
    // last__child_entries__1 = smaller(smaller(u__child_entries__1, v__child_entries__1), smaller(w__child_entries__1, end))       <L 19>
    var_499 = smaller_0(var_480, var_489);
    var_500 = smaller_0(var_498, var_end);
    var_501 = smaller_0(var_499, var_500);
    // key = float_bits(first__child_entries__1) & ~7 | j if first__child_entries__1 <= last__child_entries__1 else NOT_ENTERED__child_entries       <L 20>
    var_502 = (var_471 <= var_501);
    if (var_502) {
        var_503 = _float_bits_0(var_471);
        var_505 = wp::invert(var_504);
        var_506 = wp::bit_and(var_503, var_505);
        var_507 = wp::bit_or(var_506, var_441);
    }
    if (!var_502) {
    }
    var_508 = wp::where(var_502, var_507, var_99);
    // keys[j] = key                                                                          <L 21>
    wp::assign_inplace(var_1, var_441, var_508);
    // x__child_entries__1 = (boxes[x0__child_entries__1 + j] - a[0]) * rates[0]              <L 12>
    var_510 = wp::add(var_6, var_509);
    var_511 = wp::address(var_boxes, var_510);
    var_513 = wp::extract(var_a, var_512);
    var_515 = wp::load(var_511);
    var_514 = wp::sub(var_515, var_513);
    var_517 = wp::extract(var_rates, var_516);
    var_518 = wp::mul(var_514, var_517);
    // y__child_entries__1 = (boxes[y0__child_entries__1 + j] - a[1]) * rates[1]              <L 13>
    var_519 = wp::add(var_9, var_509);
    var_520 = wp::address(var_boxes, var_519);
    var_522 = wp::extract(var_a, var_521);
    var_524 = wp::load(var_520);
    var_523 = wp::sub(var_524, var_522);
    var_526 = wp::extract(var_rates, var_525);
    var_527 = wp::mul(var_523, var_526);
    // z__child_entries__1 = (boxes[z0__child_entries__1 + j] - a[2]) * rates[2]              <L 14>
    var_528 = wp::add(var_12, var_509);
    var_529 = wp::address(var_boxes, var_528);
    var_531 = wp::extract(var_a, var_530);
    var_533 = wp::load(var_529);
    var_532 = wp::sub(var_533, var_531);
    var_535 = wp::extract(var_rates, var_534);
    var_536 = wp::mul(var_532, var_535);
    // first__child_entries__1 = larger(larger(x__child_entries__1, y__child_entries__1), larger(z__child_entries__1, begin))       <L 15>
    var_537 = larger_0(var_518, var_527);
    var_538 = larger_0(var_536, var_begin);
    var_539 = larger_0(var_537, var_538);
    // u__child_entries__1 = (boxes[x1__child_entries__1 + j] - b[0]) * rates[0]              <L 16>
    var_540 = wp::add(var_19, var_509);
    var_541 = wp::address(var_boxes, var_540);
    var_543 = wp::extract(var_b, var_542);
    var_545 = wp::load(var_541);
    var_544 = wp::sub(var_545, var_543);
    var_547 = wp::extract(var_rates, var_546);
    var_548 = wp::mul(var_544, var_547);
    // v__child_entries__1 = (boxes[y1__child_entries__1 + j] - b[1]) * rates[1]              <L 17>
    var_549 = wp::add(var_25, var_509);
    var_550 = wp::address(var_boxes, var_549);
    var_552 = wp::extract(var_b, var_551);
    var_554 = wp::load(var_550);
    var_553 = wp::sub(var_554, var_552);
    var_556 = wp::extract(var_rates, var_555);
    var_557 = wp::mul(var_553, var_556);
    // w__child_entries__1 = (boxes[z1__child_entries__1 + j] - b[2]) * rates[2]              <L 18>
    var_558 = wp::add(var_31, var_509);
    var_559 = wp::address(var_boxes, var_558);
    var_561 = wp::extract(var_b, var_560);
    var_563 = wp::load(var_559);
    var_562 = wp::sub(var_563, var_561);
    var_565 = wp::extract(var_rates, var_564);
    var_566 = wp::mul(var_562, var_565);
    // last__child_entries__1 = smaller(smaller(u__child_entries__1, v__child_entries__1), smaller(w__child_entries__1, end))       <L 19>
    var_567 = smaller_0(var_548, var_557);
    var_568 = smaller_0(var_566, var_end);
    var_569 = smaller_0(var_567, var_568);
    // key = float_bits(first__child_entries__1) & ~7 | j if first__child_entries__1 <= last__child_entries__1 else NOT_ENTERED__child_entries       <L 20>
    var_570 = (var_539 <= var_569);
    if (var_570) {
        var_571 = _float_bits_0(var_539);
        var_573 = wp::invert(var_572);
        var_574 = wp::bit_and(var_571, var_573);
        var_575 = wp::bit_or(var_574, var_509);
    }
    if (!var_570) {
    }
    var_576 = wp::where(var_570, var_575, var_99);
    // keys[j] = key                                                                          <L 21>
    wp::assign_inplace(var_1, var_509, var_576);
    // return keys                                                                            <L 22>
    return var_1;
}


// /work/main/src/pointloom/kernels/rays/ray_hits.py:148
static CUDA_CALLABLE wp::int32 first_entered_0(
    wp::vec_t<8, wp::int32> var_keys,
    wp::int32 var_left)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 255;
    wp::int32 var_1;
    wp::vec_t<8, wp::int32> var_2;
    const wp::int32 var_3 = 0;
    wp::int32 var_4;
    const wp::int32 var_5 = 1;
    wp::int32 var_6;
    const wp::int32 var_7 = 1;
    bool var_8;
    const wp::int32 var_9 = 2147483647;
    wp::int32 var_10;
    wp::int32 var_11;
    const wp::int32 var_12 = 1;
    wp::int32 var_13;
    const wp::int32 var_14 = 1;
    wp::int32 var_15;
    const wp::int32 var_16 = 1;
    bool var_17;
    wp::int32 var_18;
    wp::int32 var_19;
    const wp::int32 var_20 = 2;
    wp::int32 var_21;
    const wp::int32 var_22 = 1;
    wp::int32 var_23;
    const wp::int32 var_24 = 1;
    bool var_25;
    wp::int32 var_26;
    wp::int32 var_27;
    const wp::int32 var_28 = 3;
    wp::int32 var_29;
    const wp::int32 var_30 = 1;
    wp::int32 var_31;
    const wp::int32 var_32 = 1;
    bool var_33;
    wp::int32 var_34;
    wp::int32 var_35;
    const wp::int32 var_36 = 4;
    wp::int32 var_37;
    const wp::int32 var_38 = 1;
    wp::int32 var_39;
    const wp::int32 var_40 = 1;
    bool var_41;
    wp::int32 var_42;
    wp::int32 var_43;
    const wp::int32 var_44 = 5;
    wp::int32 var_45;
    const wp::int32 var_46 = 1;
    wp::int32 var_47;
    const wp::int32 var_48 = 1;
    bool var_49;
    wp::int32 var_50;
    wp::int32 var_51;
    const wp::int32 var_52 = 6;
    wp::int32 var_53;
    const wp::int32 var_54 = 1;
    wp::int32 var_55;
    const wp::int32 var_56 = 1;
    bool var_57;
    wp::int32 var_58;
    wp::int32 var_59;
    const wp::int32 var_60 = 7;
    wp::int32 var_61;
    const wp::int32 var_62 = 1;
    wp::int32 var_63;
    const wp::int32 var_64 = 1;
    bool var_65;
    wp::int32 var_66;
    wp::int32 var_67;
    const wp::int32 var_68 = 0;
    wp::int32 var_69;
    const wp::int32 var_70 = 1;
    wp::int32 var_71;
    wp::int32 var_72;
    const wp::int32 var_73 = 2;
    wp::int32 var_74;
    const wp::int32 var_75 = 3;
    wp::int32 var_76;
    wp::int32 var_77;
    wp::int32 var_78;
    const wp::int32 var_79 = 4;
    wp::int32 var_80;
    const wp::int32 var_81 = 5;
    wp::int32 var_82;
    wp::int32 var_83;
    const wp::int32 var_84 = 6;
    wp::int32 var_85;
    const wp::int32 var_86 = 7;
    wp::int32 var_87;
    wp::int32 var_88;
    wp::int32 var_89;
    wp::int32 var_90;
    //---------
    // forward
    // def first_entered(keys: entry_keys, left: int) -> int:                                 <L 149>
    // passed = BYTE ^ left                                                                   <L 150>
    var_1 = wp::bit_xor(var_0, var_left);
    // open_keys = keys                                                                       <L 151>
    var_2 = wp::copy(var_keys);
    // for j in range(FAN):                                                                   <L 152>
    // open_keys[j] = NOT_ENTERED if ((passed >> j) & 1) == 1 else keys[j]                    <L 153>
    var_4 = wp::rshift(var_1, var_3);
    var_6 = wp::bit_and(var_4, var_5);
    var_8 = (var_6 == var_7);
    if (var_8) {
    }
    if (!var_8) {
        var_10 = wp::extract(var_keys, var_3);
    }
    var_11 = wp::where(var_8, var_9, var_10);
    wp::assign_inplace(var_2, var_3, var_11);
    var_13 = wp::rshift(var_1, var_12);
    var_15 = wp::bit_and(var_13, var_14);
    var_17 = (var_15 == var_16);
    if (var_17) {
    }
    if (!var_17) {
        var_18 = wp::extract(var_keys, var_12);
    }
    var_19 = wp::where(var_17, var_9, var_18);
    wp::assign_inplace(var_2, var_12, var_19);
    var_21 = wp::rshift(var_1, var_20);
    var_23 = wp::bit_and(var_21, var_22);
    var_25 = (var_23 == var_24);
    if (var_25) {
    }
    if (!var_25) {
        var_26 = wp::extract(var_keys, var_20);
    }
    var_27 = wp::where(var_25, var_9, var_26);
    wp::assign_inplace(var_2, var_20, var_27);
    var_29 = wp::rshift(var_1, var_28);
    var_31 = wp::bit_and(var_29, var_30);
    var_33 = (var_31 == var_32);
    if (var_33) {
    }
    if (!var_33) {
        var_34 = wp::extract(var_keys, var_28);
    }
    var_35 = wp::where(var_33, var_9, var_34);
    wp::assign_inplace(var_2, var_28, var_35);
    var_37 = wp::rshift(var_1, var_36);
    var_39 = wp::bit_and(var_37, var_38);
    var_41 = (var_39 == var_40);
    if (var_41) {
    }
    if (!var_41) {
        var_42 = wp::extract(var_keys, var_36);
    }
    var_43 = wp::where(var_41, var_9, var_42);
    wp::assign_inplace(var_2, var_36, var_43);
    var_45 = wp::rshift(var_1, var_44);
    var_47 = wp::bit_and(var_45, var_46);
    var_49 = (var_47 == var_48);
    if (var_49) {
    }
    if (!var_49) {
        var_50 = wp::extract(var_keys, var_44);
    }
    var_51 = wp::where(var_49, var_9, var_50);
    wp::assign_inplace(var_2, var_44, var_51);
    var_53 = wp::rshift(var_1, var_52);
    var_55 = wp::bit_and(var_53, var_54);
    var_57 = (var_55 == var_56);
    if (var_57) {
    }
    if (!var_57) {
        var_58 = wp::extract(var_keys, var_52);
    }
    var_59 = wp::where(var_57, var_9, var_58);
    wp::assign_inplace(var_2, var_52, var_59);
    var_61 = wp::rshift(var_1, var_60);
    var_63 = wp::bit_and(var_61, var_62);
    var_65 = (var_63 == var_64);
    if (var_65) {
    }
    if (!var_65) {
        var_66 = wp::extract(var_keys, var_60);
    }
    var_67 = wp::where(var_65, var_9, var_66);
    wp::assign_inplace(var_2, var_60, var_67);
    // a = min(min(open_keys[0], open_keys[1]), min(open_keys[2], open_keys[3]))              <L 154>
    var_69 = wp::extract(var_2, var_68);
    var_71 = wp::extract(var_2, var_70);
    var_72 = wp::min(var_69, var_71);
    var_74 = wp::extract(var_2, var_73);
    var_76 = wp::extract(var_2, var_75);
    var_77 = wp::min(var_74, var_76);
    var_78 = wp::min(var_72, var_77);
    // b = min(min(open_keys[4], open_keys[5]), min(open_keys[6], open_keys[7]))              <L 155>
    var_80 = wp::extract(var_2, var_79);
    var_82 = wp::extract(var_2, var_81);
    var_83 = wp::min(var_80, var_82);
    var_85 = wp::extract(var_2, var_84);
    var_87 = wp::extract(var_2, var_86);
    var_88 = wp::min(var_85, var_87);
    var_89 = wp::min(var_83, var_88);
    // return min(a, b)                                                                       <L 156>
    var_90 = wp::min(var_78, var_89);
    return var_90;
}


// /work/main/src/pointloom/kernels/rays/ray_hits.py:159
static CUDA_CALLABLE wp::int32 entered_bits_0(
    wp::vec_t<8, wp::int32> var_keys)
{
    //---------
    // primal vars
    wp::vec_t<8, wp::int32> var_0;
    const wp::int32 var_1 = 0;
    wp::int32 var_2;
    const wp::int32 var_3 = 2147483647;
    wp::int32 var_4;
    const wp::int32 var_5 = 31;
    wp::int32 var_6;
    const wp::int32 var_7 = 1;
    wp::int32 var_8;
    wp::int32 var_9;
    const wp::int32 var_10 = 1;
    wp::int32 var_11;
    wp::int32 var_12;
    const wp::int32 var_13 = 31;
    wp::int32 var_14;
    const wp::int32 var_15 = 1;
    wp::int32 var_16;
    wp::int32 var_17;
    const wp::int32 var_18 = 2;
    wp::int32 var_19;
    wp::int32 var_20;
    const wp::int32 var_21 = 31;
    wp::int32 var_22;
    const wp::int32 var_23 = 1;
    wp::int32 var_24;
    wp::int32 var_25;
    const wp::int32 var_26 = 3;
    wp::int32 var_27;
    wp::int32 var_28;
    const wp::int32 var_29 = 31;
    wp::int32 var_30;
    const wp::int32 var_31 = 1;
    wp::int32 var_32;
    wp::int32 var_33;
    const wp::int32 var_34 = 4;
    wp::int32 var_35;
    wp::int32 var_36;
    const wp::int32 var_37 = 31;
    wp::int32 var_38;
    const wp::int32 var_39 = 1;
    wp::int32 var_40;
    wp::int32 var_41;
    const wp::int32 var_42 = 5;
    wp::int32 var_43;
    wp::int32 var_44;
    const wp::int32 var_45 = 31;
    wp::int32 var_46;
    const wp::int32 var_47 = 1;
    wp::int32 var_48;
    wp::int32 var_49;
    const wp::int32 var_50 = 6;
    wp::int32 var_51;
    wp::int32 var_52;
    const wp::int32 var_53 = 31;
    wp::int32 var_54;
    const wp::int32 var_55 = 1;
    wp::int32 var_56;
    wp::int32 var_57;
    const wp::int32 var_58 = 7;
    wp::int32 var_59;
    wp::int32 var_60;
    const wp::int32 var_61 = 31;
    wp::int32 var_62;
    const wp::int32 var_63 = 1;
    wp::int32 var_64;
    wp::int32 var_65;
    const wp::int32 var_66 = 0;
    wp::int32 var_67;
    const wp::int32 var_68 = 1;
    wp::int32 var_69;
    wp::int32 var_70;
    const wp::int32 var_71 = 2;
    wp::int32 var_72;
    const wp::int32 var_73 = 3;
    wp::int32 var_74;
    wp::int32 var_75;
    wp::int32 var_76;
    const wp::int32 var_77 = 4;
    wp::int32 var_78;
    const wp::int32 var_79 = 5;
    wp::int32 var_80;
    wp::int32 var_81;
    const wp::int32 var_82 = 6;
    wp::int32 var_83;
    const wp::int32 var_84 = 7;
    wp::int32 var_85;
    wp::int32 var_86;
    wp::int32 var_87;
    wp::int32 var_88;
    //---------
    // forward
    // def entered_bits(keys: entry_keys) -> int:                                             <L 160>
    // bits = keys                                                                            <L 161>
    var_0 = wp::copy(var_keys);
    // for j in range(FAN):                                                                   <L 162>
    // bits[j] = ((keys[j] - NOT_ENTERED) >> 31) & (1 << j)                                   <L 163>
    var_2 = wp::extract(var_keys, var_1);
    var_4 = wp::sub(var_2, var_3);
    var_6 = wp::rshift(var_4, var_5);
    var_8 = wp::lshift(var_7, var_1);
    var_9 = wp::bit_and(var_6, var_8);
    wp::assign_inplace(var_0, var_1, var_9);
    var_11 = wp::extract(var_keys, var_10);
    var_12 = wp::sub(var_11, var_3);
    var_14 = wp::rshift(var_12, var_13);
    var_16 = wp::lshift(var_15, var_10);
    var_17 = wp::bit_and(var_14, var_16);
    wp::assign_inplace(var_0, var_10, var_17);
    var_19 = wp::extract(var_keys, var_18);
    var_20 = wp::sub(var_19, var_3);
    var_22 = wp::rshift(var_20, var_21);
    var_24 = wp::lshift(var_23, var_18);
    var_25 = wp::bit_and(var_22, var_24);
    wp::assign_inplace(var_0, var_18, var_25);
    var_27 = wp::extract(var_keys, var_26);
    var_28 = wp::sub(var_27, var_3);
    var_30 = wp::rshift(var_28, var_29);
    var_32 = wp::lshift(var_31, var_26);
    var_33 = wp::bit_and(var_30, var_32);
    wp::assign_inplace(var_0, var_26, var_33);
    var_35 = wp::extract(var_keys, var_34);
    var_36 = wp::sub(var_35, var_3);
    var_38 = wp::rshift(var_36, var_37);
    var_40 = wp::lshift(var_39, var_34);
    var_41 = wp::bit_and(var_38, var_40);
    wp::assign_inplace(var_0, var_34, var_41);
    var_43 = wp::extract(var_keys, var_42);
    var_44 = wp::sub(var_43, var_3);
    var_46 = wp::rshift(var_44, var_45);
    var_48 = wp::lshift(var_47, var_42);
    var_49 = wp::bit_and(var_46, var_48);
    wp::assign_inplace(var_0, var_42, var_49);
    var_51 = wp::extract(var_keys, var_50);
    var_52 = wp::sub(var_51, var_3);
    var_54 = wp::rshift(var_52, var_53);
    var_56 = wp::lshift(var_55, var_50);
    var_57 = wp::bit_and(var_54, var_56);
    wp::assign_inplace(var_0, var_50, var_57);
    var_59 = wp::extract(var_keys, var_58);
    var_60 = wp::sub(var_59, var_3);
    var_62 = wp::rshift(var_60, var_61);
    var_64 = wp::lshift(var_63, var_58);
    var_65 = wp::bit_and(var_62, var_64);
    wp::assign_inplace(var_0, var_58, var_65);
    // return ((bits[0] | bits[1]) | (bits[2] | bits[3])) | ((bits[4] | bits[5]) | (bits[6] | bits[7]))       <L 164>
    var_67 = wp::extract(var_0, var_66);
    var_69 = wp::extract(var_0, var_68);
    var_70 = wp::bit_or(var_67, var_69);
    var_72 = wp::extract(var_0, var_71);
    var_74 = wp::extract(var_0, var_73);
    var_75 = wp::bit_or(var_72, var_74);
    var_76 = wp::bit_or(var_70, var_75);
    var_78 = wp::extract(var_0, var_77);
    var_80 = wp::extract(var_0, var_79);
    var_81 = wp::bit_or(var_78, var_80);
    var_83 = wp::extract(var_0, var_82);
    var_85 = wp::extract(var_0, var_84);
    var_86 = wp::bit_or(var_83, var_85);
    var_87 = wp::bit_or(var_81, var_86);
    var_88 = wp::bit_or(var_76, var_87);
    return var_88;
}


// <pointloom.kernels.rays.ray_hits.next_leaf>:1
static CUDA_CALLABLE wp::vec_t<4, wp::int64> next_leaf_0(
    wp::vec_t<4, wp::int64> var_step,
    wp::array_t<wp::int32> var_levels,
    wp::int32 var_root,
    wp::array_t<wp::float32> var_boxes,
    wp::vec_t<3, wp::int32> var_near,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::vec_t<3, wp::float32> var_rates,
    wp::float32 var_begin,
    wp::float32 var_end)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int64 var_1;
    wp::int32 var_2;
    const wp::int32 var_3 = 1;
    wp::int64 var_4;
    wp::int32 var_5;
    const wp::int32 var_6 = 2;
    wp::int64 var_7;
    const wp::int32 var_8 = -1;
    wp::int32 var_9;
    bool var_10;
    const wp::int32 var_11 = 0;
    bool var_12;
    bool var_13;
    const wp::int32 var_14 = 8;
    wp::int32 var_15;
    wp::int64 var_16;
    wp::int64 var_17;
    wp::int32 var_18;
    const wp::int32 var_19 = 255;
    wp::int32 var_20;
    const wp::int32 var_21 = 2147483647;
    wp::int32 var_22;
    const wp::int32 var_23 = 0;
    bool var_24;
    wp::int32* var_25;
    wp::int32 var_26;
    wp::int32 var_27;
    wp::vec_t<8, wp::int32> var_28;
    wp::int32 var_29;
    wp::int32 var_30;
    wp::int32 var_31;
    const wp::int32 var_32 = 1;
    const wp::int32 var_33 = 7;
    wp::int32 var_34;
    wp::int32 var_35;
    wp::int32 var_36;
    wp::int32 var_37;
    wp::int64 var_38;
    wp::int64 var_39;
    wp::int64 var_40;
    wp::int64 var_41;
    wp::int64 var_42;
    wp::int64 var_43;
    wp::int64 var_44;
    wp::int64 var_45;
    wp::int32 var_46;
    bool var_47;
    wp::int32 var_48;
    const wp::int32 var_49 = 1;
    wp::int32 var_50;
    const wp::int32 var_51 = 0;
    bool var_52;
    wp::int32 var_53;
    const wp::int32 var_54 = 7;
    wp::int32 var_55;
    wp::int32 var_56;
    wp::int32 var_57;
    const wp::int32 var_58 = 7;
    wp::int32 var_59;
    wp::int32 var_60;
    const wp::int32 var_61 = 1;
    wp::int32 var_62;
    wp::int64 var_63;
    wp::int32 var_64;
    wp::int64 var_65;
    wp::int64 var_66;
    wp::int64 var_67;
    wp::int32 var_68;
    wp::int32 var_69;
    wp::int64 var_70;
    wp::int32 var_71;
    wp::int32 var_72;
    wp::int32 var_73;
    wp::int64 var_74;
    wp::int32 var_75;
    wp::int64 var_76;
    wp::int64 var_77;
    wp::int64 var_78;
    wp::vec_t<4, wp::int64> var_79;
    //---------
    // forward
    // def next_leaf(step, levels, root, boxes, near, a, b, rates, begin, end):               <L 1>
    // level = int(step[0])                                                                   <L 3>
    var_1 = wp::extract(var_step, var_0);
    var_2 = wp::int(var_1);
    // node = int(step[1])                                                                    <L 4>
    var_4 = wp::extract(var_step, var_3);
    var_5 = wp::int(var_4);
    // pending = step[2]                                                                      <L 5>
    var_7 = wp::extract(var_step, var_6);
    // leaf = int(-1)                                                                         <L 6>
    var_9 = wp::int(var_8);
    // while leaf < 0 and level <= root:                                                      <L 7>
    start_while_0:;
    var_12 = (var_9 < var_11);
    var_10 = var_12;
    if (var_10) {
        var_13 = (var_2 <= var_root);
        var_10 = var_10 && var_13;
    }
    if ((var_10) == false) goto end_while_0;
        // shift = int64(FAN * level)                                                         <L 8>
        var_15 = wp::mul(var_14, var_2);
        var_16 = wp::int64(var_15);
        // left = int(pending >> shift) & BYTE                                                <L 9>
        var_17 = wp::rshift(var_7, var_16);
        var_18 = wp::int(var_17);
        var_20 = wp::bit_and(var_18, var_19);
        // key = int(NOT_ENTERED)                                                             <L 10>
        var_22 = wp::int(var_21);
        // if left != 0:                                                                      <L 11>
        var_24 = (var_20 != var_23);
        if (var_24) {
            // keys = measure_entries(boxes, levels[level] + node, near, a, b, rates, begin, end)       <L 12>
            var_25 = wp::address(var_levels, var_2);
            var_27 = wp::load(var_25);
            var_26 = wp::add(var_27, var_5);
            var_28 = measure_entries_0(var_boxes, var_26, var_near, var_a, var_b, var_rates, var_begin, var_end);
            // key = first_entered(keys, left)                                                <L 13>
            var_29 = first_entered_0(var_28, var_20);
            // others = entered_bits(keys) & left & ~(1 << (key & 7))                         <L 14>
            var_30 = entered_bits_0(var_28);
            var_31 = wp::bit_and(var_30, var_20);
            var_34 = wp::bit_and(var_29, var_33);
            var_35 = wp::lshift(var_32, var_34);
            var_36 = wp::invert(var_35);
            var_37 = wp::bit_and(var_31, var_36);
            // pending = pending & ~(int64(FULL_BYTE) << shift) | int64(others) << shift       <L 15>
            var_38 = 255ll;
            var_39 = wp::lshift(var_38, var_16);
            var_40 = wp::invert(var_39);
            var_41 = wp::bit_and(var_7, var_40);
            var_42 = wp::int64(var_37);
            var_43 = wp::lshift(var_42, var_16);
            var_44 = wp::bit_or(var_41, var_43);
        }
        var_45 = wp::where(var_24, var_44, var_7);
        var_46 = wp::where(var_24, var_29, var_22);
        // if key == NOT_ENTERED:                                                             <L 16>
        var_47 = (var_46 == var_21);
        if (var_47) {
            // node = node // FAN                                                             <L 17>
            var_48 = wp::floordiv(var_5, var_14);
            // level = level + 1                                                              <L 18>
            var_50 = wp::add(var_2, var_49);
        }
        if (!var_47) {
            // elif level == 0:                                                               <L 19>
            var_52 = (var_2 == var_51);
            if (var_52) {
                // leaf = node * FAN + (key & 7)                                              <L 20>
                var_53 = wp::mul(var_5, var_14);
                var_55 = wp::bit_and(var_46, var_54);
                var_56 = wp::add(var_53, var_55);
            }
            if (!var_52) {
                // node = node * FAN + (key & 7)                                              <L 22>
                var_57 = wp::mul(var_5, var_14);
                var_59 = wp::bit_and(var_46, var_58);
                var_60 = wp::add(var_57, var_59);
                // level = level - 1                                                          <L 23>
                var_62 = wp::sub(var_2, var_61);
                // pending = pending | int64(FULL_BYTE) << int64(FAN * level)                 <L 24>
                var_63 = wp::int64(var_38);
                var_64 = wp::mul(var_14, var_62);
                var_65 = wp::int64(var_64);
                var_66 = wp::lshift(var_63, var_65);
                var_67 = wp::bit_or(var_45, var_66);
            }
            var_68 = wp::where(var_52, var_2, var_62);
            var_69 = wp::where(var_52, var_5, var_60);
            var_70 = wp::where(var_52, var_45, var_67);
            var_71 = wp::where(var_52, var_56, var_9);
        }
        var_72 = wp::where(var_47, var_50, var_68);
        var_73 = wp::where(var_47, var_48, var_69);
        var_74 = wp::where(var_47, var_45, var_70);
        var_75 = wp::where(var_47, var_9, var_71);
        wp::assign(var_2, var_72);
        wp::assign(var_5, var_73);
        wp::assign(var_7, var_74);
        wp::assign(var_9, var_75);
    goto start_while_0;
    end_while_0:;
    // return leaf_traversal(int64(level), int64(node), pending, int64(leaf))                 <L 25>
    var_76 = wp::int64(var_2);
    var_77 = wp::int64(var_5);
    var_78 = wp::int64(var_9);
    var_79 = wp::vec_t<4, wp::int64>(var_76, var_77, var_7, var_78);
    return var_79;
}


// <pointloom.kernels.rays.ray_hits.next_object>:1
static CUDA_CALLABLE wp::vec_t<4, wp::int64> next_object_0(
    wp::vec_t<4, wp::int64> var_step,
    wp::vec_t<3, wp::int32> var_near,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::vec_t<3, wp::float32> var_rates,
    wp::float32 var_begin,
    wp::float32 var_end,
    wp::array_t<wp::float32> var_trees__object_boxes,
    wp::array_t<wp::int32> var_trees__object_levels,
    wp::int32 var_trees__object_root)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 0.999999;
    wp::float32 var_1;
    const wp::float32 var_2 = 1.000001;
    wp::float32 var_3;
    wp::vec_t<4, wp::int64> var_4;
    //---------
    // forward
    // def next_object(step, near, a, b, rates, begin, end, trees__object_boxes, trees__object_levels, trees__object_root):       <L 1>
    // low = begin * NARROWER                                                                 <L 3>
    var_1 = wp::mul(var_begin, var_0);
    // high = end * WIDER                                                                     <L 4>
    var_3 = wp::mul(var_end, var_2);
    // return next_leaf(step, trees__object_levels, trees__object_root, trees__object_boxes, near, a, b, rates, low, high)       <L 5>
    var_4 = next_leaf_0(var_step, var_trees__object_levels, var_trees__object_root, var_trees__object_boxes, var_near, var_a, var_b, var_rates, var_1, var_3);
    return var_4;
}


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


// /work/main/src/pointloom/kernels/rays/ray_hits.py:422
static CUDA_CALLABLE wp::vec_t<3, wp::float64> vector_at_0(
    wp::array_t<wp::float64> var_motions,
    wp::int32 var_at)
{
    //---------
    // primal vars
    wp::float64* var_0;
    const wp::int32 var_1 = 1;
    wp::int32 var_2;
    wp::float64* var_3;
    const wp::int32 var_4 = 2;
    wp::int32 var_5;
    wp::float64* var_6;
    wp::vec_t<3, wp::float64> var_7;
    wp::float64 var_8;
    wp::float64 var_9;
    wp::float64 var_10;
    //---------
    // forward
    // def vector_at(motions: array(dtype=float64), at: int) -> vec3d:                        <L 423>
    // return vec3d(motions[at], motions[at + 1], motions[at + 2])                            <L 424>
    var_0 = wp::address(var_motions, var_at);
    var_2 = wp::add(var_at, var_1);
    var_3 = wp::address(var_motions, var_2);
    var_5 = wp::add(var_at, var_4);
    var_6 = wp::address(var_motions, var_5);
    var_8 = wp::load(var_0);
    var_9 = wp::load(var_3);
    var_10 = wp::load(var_6);
    var_7 = wp::vec_t<3, wp::float64>(var_8, var_9, var_10);
    return var_7;
}


// /work/main/src/pointloom/kernels/rays/ray_hits.py:427
static CUDA_CALLABLE wp::vec_t<3, wp::float64> rotate_into_0(
    wp::vec_t<3, wp::float64> var_d,
    wp::array_t<wp::float64> var_motions,
    wp::int32 var_row)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 18;
    wp::int32 var_1;
    wp::vec_t<3, wp::float64> var_2;
    const wp::int32 var_3 = 3;
    wp::int32 var_4;
    wp::vec_t<3, wp::float64> var_5;
    const wp::int32 var_6 = 6;
    wp::int32 var_7;
    wp::vec_t<3, wp::float64> var_8;
    const wp::int32 var_9 = 0;
    wp::float64 var_10;
    const wp::int32 var_11 = 0;
    wp::float64 var_12;
    wp::float64 var_13;
    const wp::int32 var_14 = 1;
    wp::float64 var_15;
    const wp::int32 var_16 = 1;
    wp::float64 var_17;
    wp::float64 var_18;
    wp::float64 var_19;
    const wp::int32 var_20 = 2;
    wp::float64 var_21;
    const wp::int32 var_22 = 2;
    wp::float64 var_23;
    wp::float64 var_24;
    wp::float64 var_25;
    const wp::int32 var_26 = 0;
    wp::float64 var_27;
    const wp::int32 var_28 = 0;
    wp::float64 var_29;
    wp::float64 var_30;
    const wp::int32 var_31 = 1;
    wp::float64 var_32;
    const wp::int32 var_33 = 1;
    wp::float64 var_34;
    wp::float64 var_35;
    wp::float64 var_36;
    const wp::int32 var_37 = 2;
    wp::float64 var_38;
    const wp::int32 var_39 = 2;
    wp::float64 var_40;
    wp::float64 var_41;
    wp::float64 var_42;
    const wp::int32 var_43 = 0;
    wp::float64 var_44;
    const wp::int32 var_45 = 0;
    wp::float64 var_46;
    wp::float64 var_47;
    const wp::int32 var_48 = 1;
    wp::float64 var_49;
    const wp::int32 var_50 = 1;
    wp::float64 var_51;
    wp::float64 var_52;
    wp::float64 var_53;
    const wp::int32 var_54 = 2;
    wp::float64 var_55;
    const wp::int32 var_56 = 2;
    wp::float64 var_57;
    wp::float64 var_58;
    wp::float64 var_59;
    wp::vec_t<3, wp::float64> var_60;
    //---------
    // forward
    // def rotate_into(d: vec3d, motions: array(dtype=float64), row: int) -> vec3d:           <L 428>
    // at = row * MOTION                                                                      <L 430>
    var_1 = wp::mul(var_row, var_0);
    // x = vector_at(motions, at)                                                             <L 431>
    var_2 = vector_at_0(var_motions, var_1);
    // y = vector_at(motions, at + 3)                                                         <L 432>
    var_4 = wp::add(var_1, var_3);
    var_5 = vector_at_0(var_motions, var_4);
    // z = vector_at(motions, at + 6)                                                         <L 433>
    var_7 = wp::add(var_1, var_6);
    var_8 = vector_at_0(var_motions, var_7);
    // return vec3d(                                                                          <L 434>
    // x[0] * d[0] + x[1] * d[1] + x[2] * d[2],                                               <L 435>
    var_10 = wp::extract(var_2, var_9);
    var_12 = wp::extract(var_d, var_11);
    var_13 = wp::mul(var_10, var_12);
    var_15 = wp::extract(var_2, var_14);
    var_17 = wp::extract(var_d, var_16);
    var_18 = wp::mul(var_15, var_17);
    var_19 = wp::add(var_13, var_18);
    var_21 = wp::extract(var_2, var_20);
    var_23 = wp::extract(var_d, var_22);
    var_24 = wp::mul(var_21, var_23);
    var_25 = wp::add(var_19, var_24);
    // y[0] * d[0] + y[1] * d[1] + y[2] * d[2],                                               <L 436>
    var_27 = wp::extract(var_5, var_26);
    var_29 = wp::extract(var_d, var_28);
    var_30 = wp::mul(var_27, var_29);
    var_32 = wp::extract(var_5, var_31);
    var_34 = wp::extract(var_d, var_33);
    var_35 = wp::mul(var_32, var_34);
    var_36 = wp::add(var_30, var_35);
    var_38 = wp::extract(var_5, var_37);
    var_40 = wp::extract(var_d, var_39);
    var_41 = wp::mul(var_38, var_40);
    var_42 = wp::add(var_36, var_41);
    // z[0] * d[0] + z[1] * d[1] + z[2] * d[2],                                               <L 437>
    var_44 = wp::extract(var_8, var_43);
    var_46 = wp::extract(var_d, var_45);
    var_47 = wp::mul(var_44, var_46);
    var_49 = wp::extract(var_8, var_48);
    var_51 = wp::extract(var_d, var_50);
    var_52 = wp::mul(var_49, var_51);
    var_53 = wp::add(var_47, var_52);
    var_55 = wp::extract(var_8, var_54);
    var_57 = wp::extract(var_d, var_56);
    var_58 = wp::mul(var_55, var_57);
    var_59 = wp::add(var_53, var_58);
    var_60 = wp::vec_t<3, wp::float64>(var_25, var_42, var_59);
    return var_60;
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


// /work/main/src/pointloom/kernels/rays/ray_hits.py:72
static CUDA_CALLABLE wp::vec_t<3, wp::float32> shear_of_0(
    wp::vec_t<3, wp::float32> var_d,
    wp::vec_t<3, wp::int32> var_axes)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 2;
    wp::int32 var_1;
    wp::float32 var_2;
    const wp::int32 var_3 = 0;
    wp::int32 var_4;
    wp::float32 var_5;
    wp::float32 var_6;
    const wp::int32 var_7 = 1;
    wp::int32 var_8;
    wp::float32 var_9;
    wp::float32 var_10;
    wp::vec_t<3, wp::float32> var_11;
    //---------
    // forward
    // def shear_of(d: vec3, axes: vec3i) -> vec3:                                            <L 73>
    // main = d[axes[2]]                                                                      <L 75>
    var_1 = wp::extract(var_axes, var_0);
    var_2 = wp::extract(var_d, var_1);
    // return vec3(d[axes[0]] / main, d[axes[1]] / main, main)                                <L 76>
    var_4 = wp::extract(var_axes, var_3);
    var_5 = wp::extract(var_d, var_4);
    var_6 = wp::div(var_5, var_2);
    var_8 = wp::extract(var_axes, var_7);
    var_9 = wp::extract(var_d, var_8);
    var_10 = wp::div(var_9, var_2);
    var_11 = wp::vec_t<3, wp::float32>(var_6, var_10, var_2);
    return var_11;
}


// <pointloom.kernels.rays.ray_hits.lanes_met>:1
static CUDA_CALLABLE wp::int32 lanes_met_0(
    wp::array_t<wp::float32> var_corners,
    wp::int32 var_leaf,
    wp::vec_t<3, wp::float32> var_o,
    wp::vec_t<3, wp::int32> var_axes,
    wp::vec_t<3, wp::float32> var_shear)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 72;
    wp::int32 var_1;
    const wp::int32 var_2 = 0;
    wp::int32 var_3;
    const wp::int32 var_4 = 8;
    wp::int32 var_5;
    wp::int32 var_6;
    wp::int32 var_7;
    const wp::int32 var_8 = 1;
    wp::int32 var_9;
    wp::int32 var_10;
    wp::int32 var_11;
    wp::int32 var_12;
    const wp::int32 var_13 = 2;
    wp::int32 var_14;
    wp::int32 var_15;
    wp::int32 var_16;
    const wp::int32 var_17 = 0;
    wp::int32 var_18;
    wp::float32 var_19;
    const wp::int32 var_20 = 1;
    wp::int32 var_21;
    wp::float32 var_22;
    const wp::int32 var_23 = 2;
    wp::int32 var_24;
    wp::float32 var_25;
    const wp::float32 var_26 = 0.0;
    wp::vec_t<8, wp::float32> var_27;
    const wp::int32 var_28 = 0;
    wp::int32 var_29;
    wp::float32* var_30;
    wp::float32 var_31;
    wp::float32 var_32;
    wp::int32 var_33;
    wp::float32* var_34;
    wp::float32 var_35;
    wp::float32 var_36;
    const wp::int32 var_37 = 0;
    wp::float32 var_38;
    wp::float32 var_39;
    wp::float32 var_40;
    wp::int32 var_41;
    wp::float32* var_42;
    wp::float32 var_43;
    wp::float32 var_44;
    const wp::int32 var_45 = 1;
    wp::float32 var_46;
    wp::float32 var_47;
    wp::float32 var_48;
    const wp::int32 var_49 = 3;
    wp::int32 var_50;
    wp::int32 var_51;
    wp::int32 var_52;
    wp::float32* var_53;
    wp::float32 var_54;
    wp::float32 var_55;
    const wp::int32 var_56 = 3;
    wp::int32 var_57;
    wp::int32 var_58;
    wp::int32 var_59;
    wp::float32* var_60;
    wp::float32 var_61;
    wp::float32 var_62;
    const wp::int32 var_63 = 0;
    wp::float32 var_64;
    wp::float32 var_65;
    wp::float32 var_66;
    const wp::int32 var_67 = 3;
    wp::int32 var_68;
    wp::int32 var_69;
    wp::int32 var_70;
    wp::float32* var_71;
    wp::float32 var_72;
    wp::float32 var_73;
    const wp::int32 var_74 = 1;
    wp::float32 var_75;
    wp::float32 var_76;
    wp::float32 var_77;
    const wp::int32 var_78 = 6;
    wp::int32 var_79;
    wp::int32 var_80;
    wp::int32 var_81;
    wp::float32* var_82;
    wp::float32 var_83;
    wp::float32 var_84;
    const wp::int32 var_85 = 6;
    wp::int32 var_86;
    wp::int32 var_87;
    wp::int32 var_88;
    wp::float32* var_89;
    wp::float32 var_90;
    wp::float32 var_91;
    const wp::int32 var_92 = 0;
    wp::float32 var_93;
    wp::float32 var_94;
    wp::float32 var_95;
    const wp::int32 var_96 = 6;
    wp::int32 var_97;
    wp::int32 var_98;
    wp::int32 var_99;
    wp::float32* var_100;
    wp::float32 var_101;
    wp::float32 var_102;
    const wp::int32 var_103 = 1;
    wp::float32 var_104;
    wp::float32 var_105;
    wp::float32 var_106;
    wp::float32 var_107;
    wp::float32 var_108;
    wp::float32 var_109;
    wp::float32 var_110;
    wp::float32 var_111;
    wp::float32 var_112;
    wp::float32 var_113;
    wp::float32 var_114;
    wp::float32 var_115;
    wp::float32 var_116;
    wp::float32 var_117;
    wp::float32 var_118;
    wp::float32 var_119;
    wp::float32 var_120;
    wp::float32 var_121;
    const wp::int32 var_122 = 1;
    wp::int32 var_123;
    wp::float32* var_124;
    wp::float32 var_125;
    wp::float32 var_126;
    wp::int32 var_127;
    wp::float32* var_128;
    wp::float32 var_129;
    wp::float32 var_130;
    const wp::int32 var_131 = 0;
    wp::float32 var_132;
    wp::float32 var_133;
    wp::float32 var_134;
    wp::int32 var_135;
    wp::float32* var_136;
    wp::float32 var_137;
    wp::float32 var_138;
    const wp::int32 var_139 = 1;
    wp::float32 var_140;
    wp::float32 var_141;
    wp::float32 var_142;
    const wp::int32 var_143 = 3;
    wp::int32 var_144;
    wp::int32 var_145;
    wp::int32 var_146;
    wp::float32* var_147;
    wp::float32 var_148;
    wp::float32 var_149;
    const wp::int32 var_150 = 3;
    wp::int32 var_151;
    wp::int32 var_152;
    wp::int32 var_153;
    wp::float32* var_154;
    wp::float32 var_155;
    wp::float32 var_156;
    const wp::int32 var_157 = 0;
    wp::float32 var_158;
    wp::float32 var_159;
    wp::float32 var_160;
    const wp::int32 var_161 = 3;
    wp::int32 var_162;
    wp::int32 var_163;
    wp::int32 var_164;
    wp::float32* var_165;
    wp::float32 var_166;
    wp::float32 var_167;
    const wp::int32 var_168 = 1;
    wp::float32 var_169;
    wp::float32 var_170;
    wp::float32 var_171;
    const wp::int32 var_172 = 6;
    wp::int32 var_173;
    wp::int32 var_174;
    wp::int32 var_175;
    wp::float32* var_176;
    wp::float32 var_177;
    wp::float32 var_178;
    const wp::int32 var_179 = 6;
    wp::int32 var_180;
    wp::int32 var_181;
    wp::int32 var_182;
    wp::float32* var_183;
    wp::float32 var_184;
    wp::float32 var_185;
    const wp::int32 var_186 = 0;
    wp::float32 var_187;
    wp::float32 var_188;
    wp::float32 var_189;
    const wp::int32 var_190 = 6;
    wp::int32 var_191;
    wp::int32 var_192;
    wp::int32 var_193;
    wp::float32* var_194;
    wp::float32 var_195;
    wp::float32 var_196;
    const wp::int32 var_197 = 1;
    wp::float32 var_198;
    wp::float32 var_199;
    wp::float32 var_200;
    wp::float32 var_201;
    wp::float32 var_202;
    wp::float32 var_203;
    wp::float32 var_204;
    wp::float32 var_205;
    wp::float32 var_206;
    wp::float32 var_207;
    wp::float32 var_208;
    wp::float32 var_209;
    wp::float32 var_210;
    wp::float32 var_211;
    wp::float32 var_212;
    wp::float32 var_213;
    wp::float32 var_214;
    wp::float32 var_215;
    const wp::int32 var_216 = 2;
    wp::int32 var_217;
    wp::float32* var_218;
    wp::float32 var_219;
    wp::float32 var_220;
    wp::int32 var_221;
    wp::float32* var_222;
    wp::float32 var_223;
    wp::float32 var_224;
    const wp::int32 var_225 = 0;
    wp::float32 var_226;
    wp::float32 var_227;
    wp::float32 var_228;
    wp::int32 var_229;
    wp::float32* var_230;
    wp::float32 var_231;
    wp::float32 var_232;
    const wp::int32 var_233 = 1;
    wp::float32 var_234;
    wp::float32 var_235;
    wp::float32 var_236;
    const wp::int32 var_237 = 3;
    wp::int32 var_238;
    wp::int32 var_239;
    wp::int32 var_240;
    wp::float32* var_241;
    wp::float32 var_242;
    wp::float32 var_243;
    const wp::int32 var_244 = 3;
    wp::int32 var_245;
    wp::int32 var_246;
    wp::int32 var_247;
    wp::float32* var_248;
    wp::float32 var_249;
    wp::float32 var_250;
    const wp::int32 var_251 = 0;
    wp::float32 var_252;
    wp::float32 var_253;
    wp::float32 var_254;
    const wp::int32 var_255 = 3;
    wp::int32 var_256;
    wp::int32 var_257;
    wp::int32 var_258;
    wp::float32* var_259;
    wp::float32 var_260;
    wp::float32 var_261;
    const wp::int32 var_262 = 1;
    wp::float32 var_263;
    wp::float32 var_264;
    wp::float32 var_265;
    const wp::int32 var_266 = 6;
    wp::int32 var_267;
    wp::int32 var_268;
    wp::int32 var_269;
    wp::float32* var_270;
    wp::float32 var_271;
    wp::float32 var_272;
    const wp::int32 var_273 = 6;
    wp::int32 var_274;
    wp::int32 var_275;
    wp::int32 var_276;
    wp::float32* var_277;
    wp::float32 var_278;
    wp::float32 var_279;
    const wp::int32 var_280 = 0;
    wp::float32 var_281;
    wp::float32 var_282;
    wp::float32 var_283;
    const wp::int32 var_284 = 6;
    wp::int32 var_285;
    wp::int32 var_286;
    wp::int32 var_287;
    wp::float32* var_288;
    wp::float32 var_289;
    wp::float32 var_290;
    const wp::int32 var_291 = 1;
    wp::float32 var_292;
    wp::float32 var_293;
    wp::float32 var_294;
    wp::float32 var_295;
    wp::float32 var_296;
    wp::float32 var_297;
    wp::float32 var_298;
    wp::float32 var_299;
    wp::float32 var_300;
    wp::float32 var_301;
    wp::float32 var_302;
    wp::float32 var_303;
    wp::float32 var_304;
    wp::float32 var_305;
    wp::float32 var_306;
    wp::float32 var_307;
    wp::float32 var_308;
    wp::float32 var_309;
    const wp::int32 var_310 = 3;
    wp::int32 var_311;
    wp::float32* var_312;
    wp::float32 var_313;
    wp::float32 var_314;
    wp::int32 var_315;
    wp::float32* var_316;
    wp::float32 var_317;
    wp::float32 var_318;
    const wp::int32 var_319 = 0;
    wp::float32 var_320;
    wp::float32 var_321;
    wp::float32 var_322;
    wp::int32 var_323;
    wp::float32* var_324;
    wp::float32 var_325;
    wp::float32 var_326;
    const wp::int32 var_327 = 1;
    wp::float32 var_328;
    wp::float32 var_329;
    wp::float32 var_330;
    const wp::int32 var_331 = 3;
    wp::int32 var_332;
    wp::int32 var_333;
    wp::int32 var_334;
    wp::float32* var_335;
    wp::float32 var_336;
    wp::float32 var_337;
    const wp::int32 var_338 = 3;
    wp::int32 var_339;
    wp::int32 var_340;
    wp::int32 var_341;
    wp::float32* var_342;
    wp::float32 var_343;
    wp::float32 var_344;
    const wp::int32 var_345 = 0;
    wp::float32 var_346;
    wp::float32 var_347;
    wp::float32 var_348;
    const wp::int32 var_349 = 3;
    wp::int32 var_350;
    wp::int32 var_351;
    wp::int32 var_352;
    wp::float32* var_353;
    wp::float32 var_354;
    wp::float32 var_355;
    const wp::int32 var_356 = 1;
    wp::float32 var_357;
    wp::float32 var_358;
    wp::float32 var_359;
    const wp::int32 var_360 = 6;
    wp::int32 var_361;
    wp::int32 var_362;
    wp::int32 var_363;
    wp::float32* var_364;
    wp::float32 var_365;
    wp::float32 var_366;
    const wp::int32 var_367 = 6;
    wp::int32 var_368;
    wp::int32 var_369;
    wp::int32 var_370;
    wp::float32* var_371;
    wp::float32 var_372;
    wp::float32 var_373;
    const wp::int32 var_374 = 0;
    wp::float32 var_375;
    wp::float32 var_376;
    wp::float32 var_377;
    const wp::int32 var_378 = 6;
    wp::int32 var_379;
    wp::int32 var_380;
    wp::int32 var_381;
    wp::float32* var_382;
    wp::float32 var_383;
    wp::float32 var_384;
    const wp::int32 var_385 = 1;
    wp::float32 var_386;
    wp::float32 var_387;
    wp::float32 var_388;
    wp::float32 var_389;
    wp::float32 var_390;
    wp::float32 var_391;
    wp::float32 var_392;
    wp::float32 var_393;
    wp::float32 var_394;
    wp::float32 var_395;
    wp::float32 var_396;
    wp::float32 var_397;
    wp::float32 var_398;
    wp::float32 var_399;
    wp::float32 var_400;
    wp::float32 var_401;
    wp::float32 var_402;
    wp::float32 var_403;
    const wp::int32 var_404 = 4;
    wp::int32 var_405;
    wp::float32* var_406;
    wp::float32 var_407;
    wp::float32 var_408;
    wp::int32 var_409;
    wp::float32* var_410;
    wp::float32 var_411;
    wp::float32 var_412;
    const wp::int32 var_413 = 0;
    wp::float32 var_414;
    wp::float32 var_415;
    wp::float32 var_416;
    wp::int32 var_417;
    wp::float32* var_418;
    wp::float32 var_419;
    wp::float32 var_420;
    const wp::int32 var_421 = 1;
    wp::float32 var_422;
    wp::float32 var_423;
    wp::float32 var_424;
    const wp::int32 var_425 = 3;
    wp::int32 var_426;
    wp::int32 var_427;
    wp::int32 var_428;
    wp::float32* var_429;
    wp::float32 var_430;
    wp::float32 var_431;
    const wp::int32 var_432 = 3;
    wp::int32 var_433;
    wp::int32 var_434;
    wp::int32 var_435;
    wp::float32* var_436;
    wp::float32 var_437;
    wp::float32 var_438;
    const wp::int32 var_439 = 0;
    wp::float32 var_440;
    wp::float32 var_441;
    wp::float32 var_442;
    const wp::int32 var_443 = 3;
    wp::int32 var_444;
    wp::int32 var_445;
    wp::int32 var_446;
    wp::float32* var_447;
    wp::float32 var_448;
    wp::float32 var_449;
    const wp::int32 var_450 = 1;
    wp::float32 var_451;
    wp::float32 var_452;
    wp::float32 var_453;
    const wp::int32 var_454 = 6;
    wp::int32 var_455;
    wp::int32 var_456;
    wp::int32 var_457;
    wp::float32* var_458;
    wp::float32 var_459;
    wp::float32 var_460;
    const wp::int32 var_461 = 6;
    wp::int32 var_462;
    wp::int32 var_463;
    wp::int32 var_464;
    wp::float32* var_465;
    wp::float32 var_466;
    wp::float32 var_467;
    const wp::int32 var_468 = 0;
    wp::float32 var_469;
    wp::float32 var_470;
    wp::float32 var_471;
    const wp::int32 var_472 = 6;
    wp::int32 var_473;
    wp::int32 var_474;
    wp::int32 var_475;
    wp::float32* var_476;
    wp::float32 var_477;
    wp::float32 var_478;
    const wp::int32 var_479 = 1;
    wp::float32 var_480;
    wp::float32 var_481;
    wp::float32 var_482;
    wp::float32 var_483;
    wp::float32 var_484;
    wp::float32 var_485;
    wp::float32 var_486;
    wp::float32 var_487;
    wp::float32 var_488;
    wp::float32 var_489;
    wp::float32 var_490;
    wp::float32 var_491;
    wp::float32 var_492;
    wp::float32 var_493;
    wp::float32 var_494;
    wp::float32 var_495;
    wp::float32 var_496;
    wp::float32 var_497;
    const wp::int32 var_498 = 5;
    wp::int32 var_499;
    wp::float32* var_500;
    wp::float32 var_501;
    wp::float32 var_502;
    wp::int32 var_503;
    wp::float32* var_504;
    wp::float32 var_505;
    wp::float32 var_506;
    const wp::int32 var_507 = 0;
    wp::float32 var_508;
    wp::float32 var_509;
    wp::float32 var_510;
    wp::int32 var_511;
    wp::float32* var_512;
    wp::float32 var_513;
    wp::float32 var_514;
    const wp::int32 var_515 = 1;
    wp::float32 var_516;
    wp::float32 var_517;
    wp::float32 var_518;
    const wp::int32 var_519 = 3;
    wp::int32 var_520;
    wp::int32 var_521;
    wp::int32 var_522;
    wp::float32* var_523;
    wp::float32 var_524;
    wp::float32 var_525;
    const wp::int32 var_526 = 3;
    wp::int32 var_527;
    wp::int32 var_528;
    wp::int32 var_529;
    wp::float32* var_530;
    wp::float32 var_531;
    wp::float32 var_532;
    const wp::int32 var_533 = 0;
    wp::float32 var_534;
    wp::float32 var_535;
    wp::float32 var_536;
    const wp::int32 var_537 = 3;
    wp::int32 var_538;
    wp::int32 var_539;
    wp::int32 var_540;
    wp::float32* var_541;
    wp::float32 var_542;
    wp::float32 var_543;
    const wp::int32 var_544 = 1;
    wp::float32 var_545;
    wp::float32 var_546;
    wp::float32 var_547;
    const wp::int32 var_548 = 6;
    wp::int32 var_549;
    wp::int32 var_550;
    wp::int32 var_551;
    wp::float32* var_552;
    wp::float32 var_553;
    wp::float32 var_554;
    const wp::int32 var_555 = 6;
    wp::int32 var_556;
    wp::int32 var_557;
    wp::int32 var_558;
    wp::float32* var_559;
    wp::float32 var_560;
    wp::float32 var_561;
    const wp::int32 var_562 = 0;
    wp::float32 var_563;
    wp::float32 var_564;
    wp::float32 var_565;
    const wp::int32 var_566 = 6;
    wp::int32 var_567;
    wp::int32 var_568;
    wp::int32 var_569;
    wp::float32* var_570;
    wp::float32 var_571;
    wp::float32 var_572;
    const wp::int32 var_573 = 1;
    wp::float32 var_574;
    wp::float32 var_575;
    wp::float32 var_576;
    wp::float32 var_577;
    wp::float32 var_578;
    wp::float32 var_579;
    wp::float32 var_580;
    wp::float32 var_581;
    wp::float32 var_582;
    wp::float32 var_583;
    wp::float32 var_584;
    wp::float32 var_585;
    wp::float32 var_586;
    wp::float32 var_587;
    wp::float32 var_588;
    wp::float32 var_589;
    wp::float32 var_590;
    wp::float32 var_591;
    const wp::int32 var_592 = 6;
    wp::int32 var_593;
    wp::float32* var_594;
    wp::float32 var_595;
    wp::float32 var_596;
    wp::int32 var_597;
    wp::float32* var_598;
    wp::float32 var_599;
    wp::float32 var_600;
    const wp::int32 var_601 = 0;
    wp::float32 var_602;
    wp::float32 var_603;
    wp::float32 var_604;
    wp::int32 var_605;
    wp::float32* var_606;
    wp::float32 var_607;
    wp::float32 var_608;
    const wp::int32 var_609 = 1;
    wp::float32 var_610;
    wp::float32 var_611;
    wp::float32 var_612;
    const wp::int32 var_613 = 3;
    wp::int32 var_614;
    wp::int32 var_615;
    wp::int32 var_616;
    wp::float32* var_617;
    wp::float32 var_618;
    wp::float32 var_619;
    const wp::int32 var_620 = 3;
    wp::int32 var_621;
    wp::int32 var_622;
    wp::int32 var_623;
    wp::float32* var_624;
    wp::float32 var_625;
    wp::float32 var_626;
    const wp::int32 var_627 = 0;
    wp::float32 var_628;
    wp::float32 var_629;
    wp::float32 var_630;
    const wp::int32 var_631 = 3;
    wp::int32 var_632;
    wp::int32 var_633;
    wp::int32 var_634;
    wp::float32* var_635;
    wp::float32 var_636;
    wp::float32 var_637;
    const wp::int32 var_638 = 1;
    wp::float32 var_639;
    wp::float32 var_640;
    wp::float32 var_641;
    const wp::int32 var_642 = 6;
    wp::int32 var_643;
    wp::int32 var_644;
    wp::int32 var_645;
    wp::float32* var_646;
    wp::float32 var_647;
    wp::float32 var_648;
    const wp::int32 var_649 = 6;
    wp::int32 var_650;
    wp::int32 var_651;
    wp::int32 var_652;
    wp::float32* var_653;
    wp::float32 var_654;
    wp::float32 var_655;
    const wp::int32 var_656 = 0;
    wp::float32 var_657;
    wp::float32 var_658;
    wp::float32 var_659;
    const wp::int32 var_660 = 6;
    wp::int32 var_661;
    wp::int32 var_662;
    wp::int32 var_663;
    wp::float32* var_664;
    wp::float32 var_665;
    wp::float32 var_666;
    const wp::int32 var_667 = 1;
    wp::float32 var_668;
    wp::float32 var_669;
    wp::float32 var_670;
    wp::float32 var_671;
    wp::float32 var_672;
    wp::float32 var_673;
    wp::float32 var_674;
    wp::float32 var_675;
    wp::float32 var_676;
    wp::float32 var_677;
    wp::float32 var_678;
    wp::float32 var_679;
    wp::float32 var_680;
    wp::float32 var_681;
    wp::float32 var_682;
    wp::float32 var_683;
    wp::float32 var_684;
    wp::float32 var_685;
    const wp::int32 var_686 = 7;
    wp::int32 var_687;
    wp::float32* var_688;
    wp::float32 var_689;
    wp::float32 var_690;
    wp::int32 var_691;
    wp::float32* var_692;
    wp::float32 var_693;
    wp::float32 var_694;
    const wp::int32 var_695 = 0;
    wp::float32 var_696;
    wp::float32 var_697;
    wp::float32 var_698;
    wp::int32 var_699;
    wp::float32* var_700;
    wp::float32 var_701;
    wp::float32 var_702;
    const wp::int32 var_703 = 1;
    wp::float32 var_704;
    wp::float32 var_705;
    wp::float32 var_706;
    const wp::int32 var_707 = 3;
    wp::int32 var_708;
    wp::int32 var_709;
    wp::int32 var_710;
    wp::float32* var_711;
    wp::float32 var_712;
    wp::float32 var_713;
    const wp::int32 var_714 = 3;
    wp::int32 var_715;
    wp::int32 var_716;
    wp::int32 var_717;
    wp::float32* var_718;
    wp::float32 var_719;
    wp::float32 var_720;
    const wp::int32 var_721 = 0;
    wp::float32 var_722;
    wp::float32 var_723;
    wp::float32 var_724;
    const wp::int32 var_725 = 3;
    wp::int32 var_726;
    wp::int32 var_727;
    wp::int32 var_728;
    wp::float32* var_729;
    wp::float32 var_730;
    wp::float32 var_731;
    const wp::int32 var_732 = 1;
    wp::float32 var_733;
    wp::float32 var_734;
    wp::float32 var_735;
    const wp::int32 var_736 = 6;
    wp::int32 var_737;
    wp::int32 var_738;
    wp::int32 var_739;
    wp::float32* var_740;
    wp::float32 var_741;
    wp::float32 var_742;
    const wp::int32 var_743 = 6;
    wp::int32 var_744;
    wp::int32 var_745;
    wp::int32 var_746;
    wp::float32* var_747;
    wp::float32 var_748;
    wp::float32 var_749;
    const wp::int32 var_750 = 0;
    wp::float32 var_751;
    wp::float32 var_752;
    wp::float32 var_753;
    const wp::int32 var_754 = 6;
    wp::int32 var_755;
    wp::int32 var_756;
    wp::int32 var_757;
    wp::float32* var_758;
    wp::float32 var_759;
    wp::float32 var_760;
    const wp::int32 var_761 = 1;
    wp::float32 var_762;
    wp::float32 var_763;
    wp::float32 var_764;
    wp::float32 var_765;
    wp::float32 var_766;
    wp::float32 var_767;
    wp::float32 var_768;
    wp::float32 var_769;
    wp::float32 var_770;
    wp::float32 var_771;
    wp::float32 var_772;
    wp::float32 var_773;
    wp::float32 var_774;
    wp::float32 var_775;
    wp::float32 var_776;
    wp::float32 var_777;
    wp::float32 var_778;
    wp::float32 var_779;
    const wp::int32 var_780 = 0;
    wp::int32 var_781;
    const wp::int32 var_782 = 0;
    wp::float32 var_783;
    const wp::float32 var_784 = 0.0;
    bool var_785;
    const wp::int32 var_786 = 1;
    wp::int32 var_787;
    const wp::int32 var_788 = 0;
    wp::int32 var_789;
    wp::int32 var_790;
    const wp::int32 var_791 = 1;
    wp::float32 var_792;
    const wp::float32 var_793 = 0.0;
    bool var_794;
    const wp::int32 var_795 = 1;
    wp::int32 var_796;
    const wp::int32 var_797 = 0;
    wp::int32 var_798;
    wp::int32 var_799;
    const wp::int32 var_800 = 2;
    wp::float32 var_801;
    const wp::float32 var_802 = 0.0;
    bool var_803;
    const wp::int32 var_804 = 1;
    wp::int32 var_805;
    const wp::int32 var_806 = 0;
    wp::int32 var_807;
    wp::int32 var_808;
    const wp::int32 var_809 = 3;
    wp::float32 var_810;
    const wp::float32 var_811 = 0.0;
    bool var_812;
    const wp::int32 var_813 = 1;
    wp::int32 var_814;
    const wp::int32 var_815 = 0;
    wp::int32 var_816;
    wp::int32 var_817;
    const wp::int32 var_818 = 4;
    wp::float32 var_819;
    const wp::float32 var_820 = 0.0;
    bool var_821;
    const wp::int32 var_822 = 1;
    wp::int32 var_823;
    const wp::int32 var_824 = 0;
    wp::int32 var_825;
    wp::int32 var_826;
    const wp::int32 var_827 = 5;
    wp::float32 var_828;
    const wp::float32 var_829 = 0.0;
    bool var_830;
    const wp::int32 var_831 = 1;
    wp::int32 var_832;
    const wp::int32 var_833 = 0;
    wp::int32 var_834;
    wp::int32 var_835;
    const wp::int32 var_836 = 6;
    wp::float32 var_837;
    const wp::float32 var_838 = 0.0;
    bool var_839;
    const wp::int32 var_840 = 1;
    wp::int32 var_841;
    const wp::int32 var_842 = 0;
    wp::int32 var_843;
    wp::int32 var_844;
    const wp::int32 var_845 = 7;
    wp::float32 var_846;
    const wp::float32 var_847 = 0.0;
    bool var_848;
    const wp::int32 var_849 = 1;
    wp::int32 var_850;
    const wp::int32 var_851 = 0;
    wp::int32 var_852;
    wp::int32 var_853;
    //---------
    // forward
    // def lanes_met(corners, leaf, o, axes, shear):                                          <L 1>
    // x = leaf * LEAF_NUMBERS + axes[0] * LEAF                                               <L 3>
    var_1 = wp::mul(var_leaf, var_0);
    var_3 = wp::extract(var_axes, var_2);
    var_5 = wp::mul(var_3, var_4);
    var_6 = wp::add(var_1, var_5);
    // y = leaf * LEAF_NUMBERS + axes[1] * LEAF                                               <L 4>
    var_7 = wp::mul(var_leaf, var_0);
    var_9 = wp::extract(var_axes, var_8);
    var_10 = wp::mul(var_9, var_4);
    var_11 = wp::add(var_7, var_10);
    // z = leaf * LEAF_NUMBERS + axes[2] * LEAF                                               <L 5>
    var_12 = wp::mul(var_leaf, var_0);
    var_14 = wp::extract(var_axes, var_13);
    var_15 = wp::mul(var_14, var_4);
    var_16 = wp::add(var_12, var_15);
    // ox = o[axes[0]]                                                                        <L 6>
    var_18 = wp::extract(var_axes, var_17);
    var_19 = wp::extract(var_o, var_18);
    // oy = o[axes[1]]                                                                        <L 7>
    var_21 = wp::extract(var_axes, var_20);
    var_22 = wp::extract(var_o, var_21);
    // oz = o[axes[2]]                                                                        <L 8>
    var_24 = wp::extract(var_axes, var_23);
    var_25 = wp::extract(var_o, var_24);
    // sides = lane_numbers(0.0)                                                              <L 9>
    var_27 = wp::vec_t<8, wp::float32>(var_26);
    // for j in range(LEAF):                                                                  <L 10>
    // az = corners[z + j] - oz                                                               <L 11>
    var_29 = wp::add(var_16, var_28);
    var_30 = wp::address(var_corners, var_29);
    var_32 = wp::load(var_30);
    var_31 = wp::sub(var_32, var_25);
    // ax = corners[x + j] - ox - shear[0] * az                                               <L 12>
    var_33 = wp::add(var_6, var_28);
    var_34 = wp::address(var_corners, var_33);
    var_36 = wp::load(var_34);
    var_35 = wp::sub(var_36, var_19);
    var_38 = wp::extract(var_shear, var_37);
    var_39 = wp::mul(var_38, var_31);
    var_40 = wp::sub(var_35, var_39);
    // ay = corners[y + j] - oy - shear[1] * az                                               <L 13>
    var_41 = wp::add(var_11, var_28);
    var_42 = wp::address(var_corners, var_41);
    var_44 = wp::load(var_42);
    var_43 = wp::sub(var_44, var_22);
    var_46 = wp::extract(var_shear, var_45);
    var_47 = wp::mul(var_46, var_31);
    var_48 = wp::sub(var_43, var_47);
    // bz = corners[z + 3 * LEAF + j] - oz                                                    <L 14>
    var_50 = wp::mul(var_49, var_4);
    var_51 = wp::add(var_16, var_50);
    var_52 = wp::add(var_51, var_28);
    var_53 = wp::address(var_corners, var_52);
    var_55 = wp::load(var_53);
    var_54 = wp::sub(var_55, var_25);
    // bx = corners[x + 3 * LEAF + j] - ox - shear[0] * bz                                    <L 15>
    var_57 = wp::mul(var_56, var_4);
    var_58 = wp::add(var_6, var_57);
    var_59 = wp::add(var_58, var_28);
    var_60 = wp::address(var_corners, var_59);
    var_62 = wp::load(var_60);
    var_61 = wp::sub(var_62, var_19);
    var_64 = wp::extract(var_shear, var_63);
    var_65 = wp::mul(var_64, var_54);
    var_66 = wp::sub(var_61, var_65);
    // by = corners[y + 3 * LEAF + j] - oy - shear[1] * bz                                    <L 16>
    var_68 = wp::mul(var_67, var_4);
    var_69 = wp::add(var_11, var_68);
    var_70 = wp::add(var_69, var_28);
    var_71 = wp::address(var_corners, var_70);
    var_73 = wp::load(var_71);
    var_72 = wp::sub(var_73, var_22);
    var_75 = wp::extract(var_shear, var_74);
    var_76 = wp::mul(var_75, var_54);
    var_77 = wp::sub(var_72, var_76);
    // cz = corners[z + 6 * LEAF + j] - oz                                                    <L 17>
    var_79 = wp::mul(var_78, var_4);
    var_80 = wp::add(var_16, var_79);
    var_81 = wp::add(var_80, var_28);
    var_82 = wp::address(var_corners, var_81);
    var_84 = wp::load(var_82);
    var_83 = wp::sub(var_84, var_25);
    // cx = corners[x + 6 * LEAF + j] - ox - shear[0] * cz                                    <L 18>
    var_86 = wp::mul(var_85, var_4);
    var_87 = wp::add(var_6, var_86);
    var_88 = wp::add(var_87, var_28);
    var_89 = wp::address(var_corners, var_88);
    var_91 = wp::load(var_89);
    var_90 = wp::sub(var_91, var_19);
    var_93 = wp::extract(var_shear, var_92);
    var_94 = wp::mul(var_93, var_83);
    var_95 = wp::sub(var_90, var_94);
    // cy = corners[y + 6 * LEAF + j] - oy - shear[1] * cz                                    <L 19>
    var_97 = wp::mul(var_96, var_4);
    var_98 = wp::add(var_11, var_97);
    var_99 = wp::add(var_98, var_28);
    var_100 = wp::address(var_corners, var_99);
    var_102 = wp::load(var_100);
    var_101 = wp::sub(var_102, var_22);
    var_104 = wp::extract(var_shear, var_103);
    var_105 = wp::mul(var_104, var_83);
    var_106 = wp::sub(var_101, var_105);
    // u = cx * by - cy * bx                                                                  <L 20>
    var_107 = wp::mul(var_95, var_77);
    var_108 = wp::mul(var_106, var_66);
    var_109 = wp::sub(var_107, var_108);
    // v = ax * cy - ay * cx                                                                  <L 21>
    var_110 = wp::mul(var_40, var_106);
    var_111 = wp::mul(var_48, var_95);
    var_112 = wp::sub(var_110, var_111);
    // w = bx * ay - by * ax                                                                  <L 22>
    var_113 = wp::mul(var_66, var_48);
    var_114 = wp::mul(var_77, var_40);
    var_115 = wp::sub(var_113, var_114);
    // sides[j] = larger(smaller(u, smaller(v, w)), -larger(u, larger(v, w)))                 <L 23>
    var_116 = smaller_0(var_112, var_115);
    var_117 = smaller_0(var_109, var_116);
    var_118 = larger_0(var_112, var_115);
    var_119 = larger_0(var_109, var_118);
    var_120 = wp::neg(var_119);
    var_121 = larger_0(var_117, var_120);
    wp::assign_inplace(var_27, var_28, var_121);
    // az = corners[z + j] - oz                                                               <L 11>
    var_123 = wp::add(var_16, var_122);
    var_124 = wp::address(var_corners, var_123);
    var_126 = wp::load(var_124);
    var_125 = wp::sub(var_126, var_25);
    // ax = corners[x + j] - ox - shear[0] * az                                               <L 12>
    var_127 = wp::add(var_6, var_122);
    var_128 = wp::address(var_corners, var_127);
    var_130 = wp::load(var_128);
    var_129 = wp::sub(var_130, var_19);
    var_132 = wp::extract(var_shear, var_131);
    var_133 = wp::mul(var_132, var_125);
    var_134 = wp::sub(var_129, var_133);
    // ay = corners[y + j] - oy - shear[1] * az                                               <L 13>
    var_135 = wp::add(var_11, var_122);
    var_136 = wp::address(var_corners, var_135);
    var_138 = wp::load(var_136);
    var_137 = wp::sub(var_138, var_22);
    var_140 = wp::extract(var_shear, var_139);
    var_141 = wp::mul(var_140, var_125);
    var_142 = wp::sub(var_137, var_141);
    // bz = corners[z + 3 * LEAF + j] - oz                                                    <L 14>
    var_144 = wp::mul(var_143, var_4);
    var_145 = wp::add(var_16, var_144);
    var_146 = wp::add(var_145, var_122);
    var_147 = wp::address(var_corners, var_146);
    var_149 = wp::load(var_147);
    var_148 = wp::sub(var_149, var_25);
    // bx = corners[x + 3 * LEAF + j] - ox - shear[0] * bz                                    <L 15>
    var_151 = wp::mul(var_150, var_4);
    var_152 = wp::add(var_6, var_151);
    var_153 = wp::add(var_152, var_122);
    var_154 = wp::address(var_corners, var_153);
    var_156 = wp::load(var_154);
    var_155 = wp::sub(var_156, var_19);
    var_158 = wp::extract(var_shear, var_157);
    var_159 = wp::mul(var_158, var_148);
    var_160 = wp::sub(var_155, var_159);
    // by = corners[y + 3 * LEAF + j] - oy - shear[1] * bz                                    <L 16>
    var_162 = wp::mul(var_161, var_4);
    var_163 = wp::add(var_11, var_162);
    var_164 = wp::add(var_163, var_122);
    var_165 = wp::address(var_corners, var_164);
    var_167 = wp::load(var_165);
    var_166 = wp::sub(var_167, var_22);
    var_169 = wp::extract(var_shear, var_168);
    var_170 = wp::mul(var_169, var_148);
    var_171 = wp::sub(var_166, var_170);
    // cz = corners[z + 6 * LEAF + j] - oz                                                    <L 17>
    var_173 = wp::mul(var_172, var_4);
    var_174 = wp::add(var_16, var_173);
    var_175 = wp::add(var_174, var_122);
    var_176 = wp::address(var_corners, var_175);
    var_178 = wp::load(var_176);
    var_177 = wp::sub(var_178, var_25);
    // cx = corners[x + 6 * LEAF + j] - ox - shear[0] * cz                                    <L 18>
    var_180 = wp::mul(var_179, var_4);
    var_181 = wp::add(var_6, var_180);
    var_182 = wp::add(var_181, var_122);
    var_183 = wp::address(var_corners, var_182);
    var_185 = wp::load(var_183);
    var_184 = wp::sub(var_185, var_19);
    var_187 = wp::extract(var_shear, var_186);
    var_188 = wp::mul(var_187, var_177);
    var_189 = wp::sub(var_184, var_188);
    // cy = corners[y + 6 * LEAF + j] - oy - shear[1] * cz                                    <L 19>
    var_191 = wp::mul(var_190, var_4);
    var_192 = wp::add(var_11, var_191);
    var_193 = wp::add(var_192, var_122);
    var_194 = wp::address(var_corners, var_193);
    var_196 = wp::load(var_194);
    var_195 = wp::sub(var_196, var_22);
    var_198 = wp::extract(var_shear, var_197);
    var_199 = wp::mul(var_198, var_177);
    var_200 = wp::sub(var_195, var_199);
    // u = cx * by - cy * bx                                                                  <L 20>
    var_201 = wp::mul(var_189, var_171);
    var_202 = wp::mul(var_200, var_160);
    var_203 = wp::sub(var_201, var_202);
    // v = ax * cy - ay * cx                                                                  <L 21>
    var_204 = wp::mul(var_134, var_200);
    var_205 = wp::mul(var_142, var_189);
    var_206 = wp::sub(var_204, var_205);
    // w = bx * ay - by * ax                                                                  <L 22>
    var_207 = wp::mul(var_160, var_142);
    var_208 = wp::mul(var_171, var_134);
    var_209 = wp::sub(var_207, var_208);
    // sides[j] = larger(smaller(u, smaller(v, w)), -larger(u, larger(v, w)))                 <L 23>
    var_210 = smaller_0(var_206, var_209);
    var_211 = smaller_0(var_203, var_210);
    var_212 = larger_0(var_206, var_209);
    var_213 = larger_0(var_203, var_212);
    var_214 = wp::neg(var_213);
    var_215 = larger_0(var_211, var_214);
    wp::assign_inplace(var_27, var_122, var_215);
    // az = corners[z + j] - oz                                                               <L 11>
    var_217 = wp::add(var_16, var_216);
    var_218 = wp::address(var_corners, var_217);
    var_220 = wp::load(var_218);
    var_219 = wp::sub(var_220, var_25);
    // ax = corners[x + j] - ox - shear[0] * az                                               <L 12>
    var_221 = wp::add(var_6, var_216);
    var_222 = wp::address(var_corners, var_221);
    var_224 = wp::load(var_222);
    var_223 = wp::sub(var_224, var_19);
    var_226 = wp::extract(var_shear, var_225);
    var_227 = wp::mul(var_226, var_219);
    var_228 = wp::sub(var_223, var_227);
    // ay = corners[y + j] - oy - shear[1] * az                                               <L 13>
    var_229 = wp::add(var_11, var_216);
    var_230 = wp::address(var_corners, var_229);
    var_232 = wp::load(var_230);
    var_231 = wp::sub(var_232, var_22);
    var_234 = wp::extract(var_shear, var_233);
    var_235 = wp::mul(var_234, var_219);
    var_236 = wp::sub(var_231, var_235);
    // bz = corners[z + 3 * LEAF + j] - oz                                                    <L 14>
    var_238 = wp::mul(var_237, var_4);
    var_239 = wp::add(var_16, var_238);
    var_240 = wp::add(var_239, var_216);
    var_241 = wp::address(var_corners, var_240);
    var_243 = wp::load(var_241);
    var_242 = wp::sub(var_243, var_25);
    // bx = corners[x + 3 * LEAF + j] - ox - shear[0] * bz                                    <L 15>
    var_245 = wp::mul(var_244, var_4);
    var_246 = wp::add(var_6, var_245);
    var_247 = wp::add(var_246, var_216);
    var_248 = wp::address(var_corners, var_247);
    var_250 = wp::load(var_248);
    var_249 = wp::sub(var_250, var_19);
    var_252 = wp::extract(var_shear, var_251);
    var_253 = wp::mul(var_252, var_242);
    var_254 = wp::sub(var_249, var_253);
    // by = corners[y + 3 * LEAF + j] - oy - shear[1] * bz                                    <L 16>
    var_256 = wp::mul(var_255, var_4);
    var_257 = wp::add(var_11, var_256);
    var_258 = wp::add(var_257, var_216);
    var_259 = wp::address(var_corners, var_258);
    var_261 = wp::load(var_259);
    var_260 = wp::sub(var_261, var_22);
    var_263 = wp::extract(var_shear, var_262);
    var_264 = wp::mul(var_263, var_242);
    var_265 = wp::sub(var_260, var_264);
    // cz = corners[z + 6 * LEAF + j] - oz                                                    <L 17>
    var_267 = wp::mul(var_266, var_4);
    var_268 = wp::add(var_16, var_267);
    var_269 = wp::add(var_268, var_216);
    var_270 = wp::address(var_corners, var_269);
    var_272 = wp::load(var_270);
    var_271 = wp::sub(var_272, var_25);
    // cx = corners[x + 6 * LEAF + j] - ox - shear[0] * cz                                    <L 18>
    var_274 = wp::mul(var_273, var_4);
    var_275 = wp::add(var_6, var_274);
    var_276 = wp::add(var_275, var_216);
    var_277 = wp::address(var_corners, var_276);
    var_279 = wp::load(var_277);
    var_278 = wp::sub(var_279, var_19);
    var_281 = wp::extract(var_shear, var_280);
    var_282 = wp::mul(var_281, var_271);
    var_283 = wp::sub(var_278, var_282);
    // cy = corners[y + 6 * LEAF + j] - oy - shear[1] * cz                                    <L 19>
    var_285 = wp::mul(var_284, var_4);
    var_286 = wp::add(var_11, var_285);
    var_287 = wp::add(var_286, var_216);
    var_288 = wp::address(var_corners, var_287);
    var_290 = wp::load(var_288);
    var_289 = wp::sub(var_290, var_22);
    var_292 = wp::extract(var_shear, var_291);
    var_293 = wp::mul(var_292, var_271);
    var_294 = wp::sub(var_289, var_293);
    // u = cx * by - cy * bx                                                                  <L 20>
    var_295 = wp::mul(var_283, var_265);
    var_296 = wp::mul(var_294, var_254);
    var_297 = wp::sub(var_295, var_296);
    // v = ax * cy - ay * cx                                                                  <L 21>
    var_298 = wp::mul(var_228, var_294);
    var_299 = wp::mul(var_236, var_283);
    var_300 = wp::sub(var_298, var_299);
    // w = bx * ay - by * ax                                                                  <L 22>
    var_301 = wp::mul(var_254, var_236);
    var_302 = wp::mul(var_265, var_228);
    var_303 = wp::sub(var_301, var_302);
    // sides[j] = larger(smaller(u, smaller(v, w)), -larger(u, larger(v, w)))                 <L 23>
    var_304 = smaller_0(var_300, var_303);
    var_305 = smaller_0(var_297, var_304);
    var_306 = larger_0(var_300, var_303);
    var_307 = larger_0(var_297, var_306);
    var_308 = wp::neg(var_307);
    var_309 = larger_0(var_305, var_308);
    wp::assign_inplace(var_27, var_216, var_309);
    // az = corners[z + j] - oz                                                               <L 11>
    var_311 = wp::add(var_16, var_310);
    var_312 = wp::address(var_corners, var_311);
    var_314 = wp::load(var_312);
    var_313 = wp::sub(var_314, var_25);
    // ax = corners[x + j] - ox - shear[0] * az                                               <L 12>
    var_315 = wp::add(var_6, var_310);
    var_316 = wp::address(var_corners, var_315);
    var_318 = wp::load(var_316);
    var_317 = wp::sub(var_318, var_19);
    var_320 = wp::extract(var_shear, var_319);
    var_321 = wp::mul(var_320, var_313);
    var_322 = wp::sub(var_317, var_321);
    // ay = corners[y + j] - oy - shear[1] * az                                               <L 13>
    var_323 = wp::add(var_11, var_310);
    var_324 = wp::address(var_corners, var_323);
    var_326 = wp::load(var_324);
    var_325 = wp::sub(var_326, var_22);
    var_328 = wp::extract(var_shear, var_327);
    var_329 = wp::mul(var_328, var_313);
    var_330 = wp::sub(var_325, var_329);
    // bz = corners[z + 3 * LEAF + j] - oz                                                    <L 14>
    var_332 = wp::mul(var_331, var_4);
    var_333 = wp::add(var_16, var_332);
    var_334 = wp::add(var_333, var_310);
    var_335 = wp::address(var_corners, var_334);
    var_337 = wp::load(var_335);
    var_336 = wp::sub(var_337, var_25);
    // bx = corners[x + 3 * LEAF + j] - ox - shear[0] * bz                                    <L 15>
    var_339 = wp::mul(var_338, var_4);
    var_340 = wp::add(var_6, var_339);
    var_341 = wp::add(var_340, var_310);
    var_342 = wp::address(var_corners, var_341);
    var_344 = wp::load(var_342);
    var_343 = wp::sub(var_344, var_19);
    var_346 = wp::extract(var_shear, var_345);
    var_347 = wp::mul(var_346, var_336);
    var_348 = wp::sub(var_343, var_347);
    // by = corners[y + 3 * LEAF + j] - oy - shear[1] * bz                                    <L 16>
    var_350 = wp::mul(var_349, var_4);
    var_351 = wp::add(var_11, var_350);
    var_352 = wp::add(var_351, var_310);
    var_353 = wp::address(var_corners, var_352);
    var_355 = wp::load(var_353);
    var_354 = wp::sub(var_355, var_22);
    var_357 = wp::extract(var_shear, var_356);
    var_358 = wp::mul(var_357, var_336);
    var_359 = wp::sub(var_354, var_358);
    // cz = corners[z + 6 * LEAF + j] - oz                                                    <L 17>
    var_361 = wp::mul(var_360, var_4);
    var_362 = wp::add(var_16, var_361);
    var_363 = wp::add(var_362, var_310);
    var_364 = wp::address(var_corners, var_363);
    var_366 = wp::load(var_364);
    var_365 = wp::sub(var_366, var_25);
    // cx = corners[x + 6 * LEAF + j] - ox - shear[0] * cz                                    <L 18>
    var_368 = wp::mul(var_367, var_4);
    var_369 = wp::add(var_6, var_368);
    var_370 = wp::add(var_369, var_310);
    var_371 = wp::address(var_corners, var_370);
    var_373 = wp::load(var_371);
    var_372 = wp::sub(var_373, var_19);
    var_375 = wp::extract(var_shear, var_374);
    var_376 = wp::mul(var_375, var_365);
    var_377 = wp::sub(var_372, var_376);
    // cy = corners[y + 6 * LEAF + j] - oy - shear[1] * cz                                    <L 19>
    var_379 = wp::mul(var_378, var_4);
    var_380 = wp::add(var_11, var_379);
    var_381 = wp::add(var_380, var_310);
    var_382 = wp::address(var_corners, var_381);
    var_384 = wp::load(var_382);
    var_383 = wp::sub(var_384, var_22);
    var_386 = wp::extract(var_shear, var_385);
    var_387 = wp::mul(var_386, var_365);
    var_388 = wp::sub(var_383, var_387);
    // u = cx * by - cy * bx                                                                  <L 20>
    var_389 = wp::mul(var_377, var_359);
    var_390 = wp::mul(var_388, var_348);
    var_391 = wp::sub(var_389, var_390);
    // v = ax * cy - ay * cx                                                                  <L 21>
    var_392 = wp::mul(var_322, var_388);
    var_393 = wp::mul(var_330, var_377);
    var_394 = wp::sub(var_392, var_393);
    // w = bx * ay - by * ax                                                                  <L 22>
    var_395 = wp::mul(var_348, var_330);
    var_396 = wp::mul(var_359, var_322);
    var_397 = wp::sub(var_395, var_396);
    // sides[j] = larger(smaller(u, smaller(v, w)), -larger(u, larger(v, w)))                 <L 23>
    var_398 = smaller_0(var_394, var_397);
    var_399 = smaller_0(var_391, var_398);
    var_400 = larger_0(var_394, var_397);
    var_401 = larger_0(var_391, var_400);
    var_402 = wp::neg(var_401);
    var_403 = larger_0(var_399, var_402);
    wp::assign_inplace(var_27, var_310, var_403);
    // az = corners[z + j] - oz                                                               <L 11>
    var_405 = wp::add(var_16, var_404);
    var_406 = wp::address(var_corners, var_405);
    var_408 = wp::load(var_406);
    var_407 = wp::sub(var_408, var_25);
    // ax = corners[x + j] - ox - shear[0] * az                                               <L 12>
    var_409 = wp::add(var_6, var_404);
    var_410 = wp::address(var_corners, var_409);
    var_412 = wp::load(var_410);
    var_411 = wp::sub(var_412, var_19);
    var_414 = wp::extract(var_shear, var_413);
    var_415 = wp::mul(var_414, var_407);
    var_416 = wp::sub(var_411, var_415);
    // ay = corners[y + j] - oy - shear[1] * az                                               <L 13>
    var_417 = wp::add(var_11, var_404);
    var_418 = wp::address(var_corners, var_417);
    var_420 = wp::load(var_418);
    var_419 = wp::sub(var_420, var_22);
    var_422 = wp::extract(var_shear, var_421);
    var_423 = wp::mul(var_422, var_407);
    var_424 = wp::sub(var_419, var_423);
    // bz = corners[z + 3 * LEAF + j] - oz                                                    <L 14>
    var_426 = wp::mul(var_425, var_4);
    var_427 = wp::add(var_16, var_426);
    var_428 = wp::add(var_427, var_404);
    var_429 = wp::address(var_corners, var_428);
    var_431 = wp::load(var_429);
    var_430 = wp::sub(var_431, var_25);
    // bx = corners[x + 3 * LEAF + j] - ox - shear[0] * bz                                    <L 15>
    var_433 = wp::mul(var_432, var_4);
    var_434 = wp::add(var_6, var_433);
    var_435 = wp::add(var_434, var_404);
    var_436 = wp::address(var_corners, var_435);
    var_438 = wp::load(var_436);
    var_437 = wp::sub(var_438, var_19);
    var_440 = wp::extract(var_shear, var_439);
    var_441 = wp::mul(var_440, var_430);
    var_442 = wp::sub(var_437, var_441);
    // by = corners[y + 3 * LEAF + j] - oy - shear[1] * bz                                    <L 16>
    var_444 = wp::mul(var_443, var_4);
    var_445 = wp::add(var_11, var_444);
    var_446 = wp::add(var_445, var_404);
    var_447 = wp::address(var_corners, var_446);
    var_449 = wp::load(var_447);
    var_448 = wp::sub(var_449, var_22);
    var_451 = wp::extract(var_shear, var_450);
    var_452 = wp::mul(var_451, var_430);
    var_453 = wp::sub(var_448, var_452);
    // cz = corners[z + 6 * LEAF + j] - oz                                                    <L 17>
    var_455 = wp::mul(var_454, var_4);
    var_456 = wp::add(var_16, var_455);
    var_457 = wp::add(var_456, var_404);
    var_458 = wp::address(var_corners, var_457);
    var_460 = wp::load(var_458);
    var_459 = wp::sub(var_460, var_25);
    // cx = corners[x + 6 * LEAF + j] - ox - shear[0] * cz                                    <L 18>
    var_462 = wp::mul(var_461, var_4);
    var_463 = wp::add(var_6, var_462);
    var_464 = wp::add(var_463, var_404);
    var_465 = wp::address(var_corners, var_464);
    var_467 = wp::load(var_465);
    var_466 = wp::sub(var_467, var_19);
    var_469 = wp::extract(var_shear, var_468);
    var_470 = wp::mul(var_469, var_459);
    var_471 = wp::sub(var_466, var_470);
    // cy = corners[y + 6 * LEAF + j] - oy - shear[1] * cz                                    <L 19>
    var_473 = wp::mul(var_472, var_4);
    var_474 = wp::add(var_11, var_473);
    var_475 = wp::add(var_474, var_404);
    var_476 = wp::address(var_corners, var_475);
    var_478 = wp::load(var_476);
    var_477 = wp::sub(var_478, var_22);
    var_480 = wp::extract(var_shear, var_479);
    var_481 = wp::mul(var_480, var_459);
    var_482 = wp::sub(var_477, var_481);
    // u = cx * by - cy * bx                                                                  <L 20>
    var_483 = wp::mul(var_471, var_453);
    var_484 = wp::mul(var_482, var_442);
    var_485 = wp::sub(var_483, var_484);
    // v = ax * cy - ay * cx                                                                  <L 21>
    var_486 = wp::mul(var_416, var_482);
    var_487 = wp::mul(var_424, var_471);
    var_488 = wp::sub(var_486, var_487);
    // w = bx * ay - by * ax                                                                  <L 22>
    var_489 = wp::mul(var_442, var_424);
    var_490 = wp::mul(var_453, var_416);
    var_491 = wp::sub(var_489, var_490);
    // sides[j] = larger(smaller(u, smaller(v, w)), -larger(u, larger(v, w)))                 <L 23>
    var_492 = smaller_0(var_488, var_491);
    var_493 = smaller_0(var_485, var_492);
    var_494 = larger_0(var_488, var_491);
    var_495 = larger_0(var_485, var_494);
    var_496 = wp::neg(var_495);
    var_497 = larger_0(var_493, var_496);
    wp::assign_inplace(var_27, var_404, var_497);
    // az = corners[z + j] - oz                                                               <L 11>
    var_499 = wp::add(var_16, var_498);
    var_500 = wp::address(var_corners, var_499);
    var_502 = wp::load(var_500);
    var_501 = wp::sub(var_502, var_25);
    // ax = corners[x + j] - ox - shear[0] * az                                               <L 12>
    var_503 = wp::add(var_6, var_498);
    var_504 = wp::address(var_corners, var_503);
    var_506 = wp::load(var_504);
    var_505 = wp::sub(var_506, var_19);
    var_508 = wp::extract(var_shear, var_507);
    var_509 = wp::mul(var_508, var_501);
    var_510 = wp::sub(var_505, var_509);
    // ay = corners[y + j] - oy - shear[1] * az                                               <L 13>
    var_511 = wp::add(var_11, var_498);
    var_512 = wp::address(var_corners, var_511);
    var_514 = wp::load(var_512);
    var_513 = wp::sub(var_514, var_22);
    var_516 = wp::extract(var_shear, var_515);
    var_517 = wp::mul(var_516, var_501);
    var_518 = wp::sub(var_513, var_517);
    // bz = corners[z + 3 * LEAF + j] - oz                                                    <L 14>
    var_520 = wp::mul(var_519, var_4);
    var_521 = wp::add(var_16, var_520);
    var_522 = wp::add(var_521, var_498);
    var_523 = wp::address(var_corners, var_522);
    var_525 = wp::load(var_523);
    var_524 = wp::sub(var_525, var_25);
    // bx = corners[x + 3 * LEAF + j] - ox - shear[0] * bz                                    <L 15>
    var_527 = wp::mul(var_526, var_4);
    var_528 = wp::add(var_6, var_527);
    var_529 = wp::add(var_528, var_498);
    var_530 = wp::address(var_corners, var_529);
    var_532 = wp::load(var_530);
    var_531 = wp::sub(var_532, var_19);
    var_534 = wp::extract(var_shear, var_533);
    var_535 = wp::mul(var_534, var_524);
    var_536 = wp::sub(var_531, var_535);
    // by = corners[y + 3 * LEAF + j] - oy - shear[1] * bz                                    <L 16>
    var_538 = wp::mul(var_537, var_4);
    var_539 = wp::add(var_11, var_538);
    var_540 = wp::add(var_539, var_498);
    var_541 = wp::address(var_corners, var_540);
    var_543 = wp::load(var_541);
    var_542 = wp::sub(var_543, var_22);
    var_545 = wp::extract(var_shear, var_544);
    var_546 = wp::mul(var_545, var_524);
    var_547 = wp::sub(var_542, var_546);
    // cz = corners[z + 6 * LEAF + j] - oz                                                    <L 17>
    var_549 = wp::mul(var_548, var_4);
    var_550 = wp::add(var_16, var_549);
    var_551 = wp::add(var_550, var_498);
    var_552 = wp::address(var_corners, var_551);
    var_554 = wp::load(var_552);
    var_553 = wp::sub(var_554, var_25);
    // cx = corners[x + 6 * LEAF + j] - ox - shear[0] * cz                                    <L 18>
    var_556 = wp::mul(var_555, var_4);
    var_557 = wp::add(var_6, var_556);
    var_558 = wp::add(var_557, var_498);
    var_559 = wp::address(var_corners, var_558);
    var_561 = wp::load(var_559);
    var_560 = wp::sub(var_561, var_19);
    var_563 = wp::extract(var_shear, var_562);
    var_564 = wp::mul(var_563, var_553);
    var_565 = wp::sub(var_560, var_564);
    // cy = corners[y + 6 * LEAF + j] - oy - shear[1] * cz                                    <L 19>
    var_567 = wp::mul(var_566, var_4);
    var_568 = wp::add(var_11, var_567);
    var_569 = wp::add(var_568, var_498);
    var_570 = wp::address(var_corners, var_569);
    var_572 = wp::load(var_570);
    var_571 = wp::sub(var_572, var_22);
    var_574 = wp::extract(var_shear, var_573);
    var_575 = wp::mul(var_574, var_553);
    var_576 = wp::sub(var_571, var_575);
    // u = cx * by - cy * bx                                                                  <L 20>
    var_577 = wp::mul(var_565, var_547);
    var_578 = wp::mul(var_576, var_536);
    var_579 = wp::sub(var_577, var_578);
    // v = ax * cy - ay * cx                                                                  <L 21>
    var_580 = wp::mul(var_510, var_576);
    var_581 = wp::mul(var_518, var_565);
    var_582 = wp::sub(var_580, var_581);
    // w = bx * ay - by * ax                                                                  <L 22>
    var_583 = wp::mul(var_536, var_518);
    var_584 = wp::mul(var_547, var_510);
    var_585 = wp::sub(var_583, var_584);
    // sides[j] = larger(smaller(u, smaller(v, w)), -larger(u, larger(v, w)))                 <L 23>
    var_586 = smaller_0(var_582, var_585);
    var_587 = smaller_0(var_579, var_586);
    var_588 = larger_0(var_582, var_585);
    var_589 = larger_0(var_579, var_588);
    var_590 = wp::neg(var_589);
    var_591 = larger_0(var_587, var_590);
    wp::assign_inplace(var_27, var_498, var_591);
    // az = corners[z + j] - oz                                                               <L 11>
    var_593 = wp::add(var_16, var_592);
    var_594 = wp::address(var_corners, var_593);
    var_596 = wp::load(var_594);
    var_595 = wp::sub(var_596, var_25);
    // ax = corners[x + j] - ox - shear[0] * az                                               <L 12>
    var_597 = wp::add(var_6, var_592);
    var_598 = wp::address(var_corners, var_597);
    var_600 = wp::load(var_598);
    var_599 = wp::sub(var_600, var_19);
    var_602 = wp::extract(var_shear, var_601);
    var_603 = wp::mul(var_602, var_595);
    var_604 = wp::sub(var_599, var_603);
    // ay = corners[y + j] - oy - shear[1] * az                                               <L 13>
    var_605 = wp::add(var_11, var_592);
    var_606 = wp::address(var_corners, var_605);
    var_608 = wp::load(var_606);
    var_607 = wp::sub(var_608, var_22);
    var_610 = wp::extract(var_shear, var_609);
    var_611 = wp::mul(var_610, var_595);
    var_612 = wp::sub(var_607, var_611);
    // bz = corners[z + 3 * LEAF + j] - oz                                                    <L 14>
    var_614 = wp::mul(var_613, var_4);
    var_615 = wp::add(var_16, var_614);
    var_616 = wp::add(var_615, var_592);
    var_617 = wp::address(var_corners, var_616);
    var_619 = wp::load(var_617);
    var_618 = wp::sub(var_619, var_25);
    // bx = corners[x + 3 * LEAF + j] - ox - shear[0] * bz                                    <L 15>
    var_621 = wp::mul(var_620, var_4);
    var_622 = wp::add(var_6, var_621);
    var_623 = wp::add(var_622, var_592);
    var_624 = wp::address(var_corners, var_623);
    var_626 = wp::load(var_624);
    var_625 = wp::sub(var_626, var_19);
    var_628 = wp::extract(var_shear, var_627);
    var_629 = wp::mul(var_628, var_618);
    var_630 = wp::sub(var_625, var_629);
    // by = corners[y + 3 * LEAF + j] - oy - shear[1] * bz                                    <L 16>
    var_632 = wp::mul(var_631, var_4);
    var_633 = wp::add(var_11, var_632);
    var_634 = wp::add(var_633, var_592);
    var_635 = wp::address(var_corners, var_634);
    var_637 = wp::load(var_635);
    var_636 = wp::sub(var_637, var_22);
    var_639 = wp::extract(var_shear, var_638);
    var_640 = wp::mul(var_639, var_618);
    var_641 = wp::sub(var_636, var_640);
    // cz = corners[z + 6 * LEAF + j] - oz                                                    <L 17>
    var_643 = wp::mul(var_642, var_4);
    var_644 = wp::add(var_16, var_643);
    var_645 = wp::add(var_644, var_592);
    var_646 = wp::address(var_corners, var_645);
    var_648 = wp::load(var_646);
    var_647 = wp::sub(var_648, var_25);
    // cx = corners[x + 6 * LEAF + j] - ox - shear[0] * cz                                    <L 18>
    var_650 = wp::mul(var_649, var_4);
    var_651 = wp::add(var_6, var_650);
    var_652 = wp::add(var_651, var_592);
    var_653 = wp::address(var_corners, var_652);
    var_655 = wp::load(var_653);
    var_654 = wp::sub(var_655, var_19);
    var_657 = wp::extract(var_shear, var_656);
    var_658 = wp::mul(var_657, var_647);
    var_659 = wp::sub(var_654, var_658);
    // cy = corners[y + 6 * LEAF + j] - oy - shear[1] * cz                                    <L 19>
    var_661 = wp::mul(var_660, var_4);
    var_662 = wp::add(var_11, var_661);
    var_663 = wp::add(var_662, var_592);
    var_664 = wp::address(var_corners, var_663);
    var_666 = wp::load(var_664);
    var_665 = wp::sub(var_666, var_22);
    var_668 = wp::extract(var_shear, var_667);
    var_669 = wp::mul(var_668, var_647);
    var_670 = wp::sub(var_665, var_669);
    // u = cx * by - cy * bx                                                                  <L 20>
    var_671 = wp::mul(var_659, var_641);
    var_672 = wp::mul(var_670, var_630);
    var_673 = wp::sub(var_671, var_672);
    // v = ax * cy - ay * cx                                                                  <L 21>
    var_674 = wp::mul(var_604, var_670);
    var_675 = wp::mul(var_612, var_659);
    var_676 = wp::sub(var_674, var_675);
    // w = bx * ay - by * ax                                                                  <L 22>
    var_677 = wp::mul(var_630, var_612);
    var_678 = wp::mul(var_641, var_604);
    var_679 = wp::sub(var_677, var_678);
    // sides[j] = larger(smaller(u, smaller(v, w)), -larger(u, larger(v, w)))                 <L 23>
    var_680 = smaller_0(var_676, var_679);
    var_681 = smaller_0(var_673, var_680);
    var_682 = larger_0(var_676, var_679);
    var_683 = larger_0(var_673, var_682);
    var_684 = wp::neg(var_683);
    var_685 = larger_0(var_681, var_684);
    wp::assign_inplace(var_27, var_592, var_685);
    // az = corners[z + j] - oz                                                               <L 11>
    var_687 = wp::add(var_16, var_686);
    var_688 = wp::address(var_corners, var_687);
    var_690 = wp::load(var_688);
    var_689 = wp::sub(var_690, var_25);
    // ax = corners[x + j] - ox - shear[0] * az                                               <L 12>
    var_691 = wp::add(var_6, var_686);
    var_692 = wp::address(var_corners, var_691);
    var_694 = wp::load(var_692);
    var_693 = wp::sub(var_694, var_19);
    var_696 = wp::extract(var_shear, var_695);
    var_697 = wp::mul(var_696, var_689);
    var_698 = wp::sub(var_693, var_697);
    // ay = corners[y + j] - oy - shear[1] * az                                               <L 13>
    var_699 = wp::add(var_11, var_686);
    var_700 = wp::address(var_corners, var_699);
    var_702 = wp::load(var_700);
    var_701 = wp::sub(var_702, var_22);
    var_704 = wp::extract(var_shear, var_703);
    var_705 = wp::mul(var_704, var_689);
    var_706 = wp::sub(var_701, var_705);
    // bz = corners[z + 3 * LEAF + j] - oz                                                    <L 14>
    var_708 = wp::mul(var_707, var_4);
    var_709 = wp::add(var_16, var_708);
    var_710 = wp::add(var_709, var_686);
    var_711 = wp::address(var_corners, var_710);
    var_713 = wp::load(var_711);
    var_712 = wp::sub(var_713, var_25);
    // bx = corners[x + 3 * LEAF + j] - ox - shear[0] * bz                                    <L 15>
    var_715 = wp::mul(var_714, var_4);
    var_716 = wp::add(var_6, var_715);
    var_717 = wp::add(var_716, var_686);
    var_718 = wp::address(var_corners, var_717);
    var_720 = wp::load(var_718);
    var_719 = wp::sub(var_720, var_19);
    var_722 = wp::extract(var_shear, var_721);
    var_723 = wp::mul(var_722, var_712);
    var_724 = wp::sub(var_719, var_723);
    // by = corners[y + 3 * LEAF + j] - oy - shear[1] * bz                                    <L 16>
    var_726 = wp::mul(var_725, var_4);
    var_727 = wp::add(var_11, var_726);
    var_728 = wp::add(var_727, var_686);
    var_729 = wp::address(var_corners, var_728);
    var_731 = wp::load(var_729);
    var_730 = wp::sub(var_731, var_22);
    var_733 = wp::extract(var_shear, var_732);
    var_734 = wp::mul(var_733, var_712);
    var_735 = wp::sub(var_730, var_734);
    // cz = corners[z + 6 * LEAF + j] - oz                                                    <L 17>
    var_737 = wp::mul(var_736, var_4);
    var_738 = wp::add(var_16, var_737);
    var_739 = wp::add(var_738, var_686);
    var_740 = wp::address(var_corners, var_739);
    var_742 = wp::load(var_740);
    var_741 = wp::sub(var_742, var_25);
    // cx = corners[x + 6 * LEAF + j] - ox - shear[0] * cz                                    <L 18>
    var_744 = wp::mul(var_743, var_4);
    var_745 = wp::add(var_6, var_744);
    var_746 = wp::add(var_745, var_686);
    var_747 = wp::address(var_corners, var_746);
    var_749 = wp::load(var_747);
    var_748 = wp::sub(var_749, var_19);
    var_751 = wp::extract(var_shear, var_750);
    var_752 = wp::mul(var_751, var_741);
    var_753 = wp::sub(var_748, var_752);
    // cy = corners[y + 6 * LEAF + j] - oy - shear[1] * cz                                    <L 19>
    var_755 = wp::mul(var_754, var_4);
    var_756 = wp::add(var_11, var_755);
    var_757 = wp::add(var_756, var_686);
    var_758 = wp::address(var_corners, var_757);
    var_760 = wp::load(var_758);
    var_759 = wp::sub(var_760, var_22);
    var_762 = wp::extract(var_shear, var_761);
    var_763 = wp::mul(var_762, var_741);
    var_764 = wp::sub(var_759, var_763);
    // u = cx * by - cy * bx                                                                  <L 20>
    var_765 = wp::mul(var_753, var_735);
    var_766 = wp::mul(var_764, var_724);
    var_767 = wp::sub(var_765, var_766);
    // v = ax * cy - ay * cx                                                                  <L 21>
    var_768 = wp::mul(var_698, var_764);
    var_769 = wp::mul(var_706, var_753);
    var_770 = wp::sub(var_768, var_769);
    // w = bx * ay - by * ax                                                                  <L 22>
    var_771 = wp::mul(var_724, var_706);
    var_772 = wp::mul(var_735, var_698);
    var_773 = wp::sub(var_771, var_772);
    // sides[j] = larger(smaller(u, smaller(v, w)), -larger(u, larger(v, w)))                 <L 23>
    var_774 = smaller_0(var_770, var_773);
    var_775 = smaller_0(var_767, var_774);
    var_776 = larger_0(var_770, var_773);
    var_777 = larger_0(var_767, var_776);
    var_778 = wp::neg(var_777);
    var_779 = larger_0(var_775, var_778);
    wp::assign_inplace(var_27, var_686, var_779);
    // mask = int(0)                                                                          <L 24>
    var_781 = wp::int(var_780);
    // for j in range(LEAF):                                                                  <L 25>
    // mask = mask | (1 << j if sides[j] >= 0.0 else 0)                                       <L 26>
    var_783 = wp::extract(var_27, var_782);
    var_785 = (var_783 >= var_784);
    if (var_785) {
        var_787 = wp::lshift(var_786, var_782);
    }
    if (!var_785) {
    }
    var_789 = wp::where(var_785, var_787, var_788);
    var_790 = wp::bit_or(var_781, var_789);
    var_792 = wp::extract(var_27, var_791);
    var_794 = (var_792 >= var_793);
    if (var_794) {
        var_796 = wp::lshift(var_795, var_791);
    }
    if (!var_794) {
    }
    var_798 = wp::where(var_794, var_796, var_797);
    var_799 = wp::bit_or(var_790, var_798);
    var_801 = wp::extract(var_27, var_800);
    var_803 = (var_801 >= var_802);
    if (var_803) {
        var_805 = wp::lshift(var_804, var_800);
    }
    if (!var_803) {
    }
    var_807 = wp::where(var_803, var_805, var_806);
    var_808 = wp::bit_or(var_799, var_807);
    var_810 = wp::extract(var_27, var_809);
    var_812 = (var_810 >= var_811);
    if (var_812) {
        var_814 = wp::lshift(var_813, var_809);
    }
    if (!var_812) {
    }
    var_816 = wp::where(var_812, var_814, var_815);
    var_817 = wp::bit_or(var_808, var_816);
    var_819 = wp::extract(var_27, var_818);
    var_821 = (var_819 >= var_820);
    if (var_821) {
        var_823 = wp::lshift(var_822, var_818);
    }
    if (!var_821) {
    }
    var_825 = wp::where(var_821, var_823, var_824);
    var_826 = wp::bit_or(var_817, var_825);
    var_828 = wp::extract(var_27, var_827);
    var_830 = (var_828 >= var_829);
    if (var_830) {
        var_832 = wp::lshift(var_831, var_827);
    }
    if (!var_830) {
    }
    var_834 = wp::where(var_830, var_832, var_833);
    var_835 = wp::bit_or(var_826, var_834);
    var_837 = wp::extract(var_27, var_836);
    var_839 = (var_837 >= var_838);
    if (var_839) {
        var_841 = wp::lshift(var_840, var_836);
    }
    if (!var_839) {
    }
    var_843 = wp::where(var_839, var_841, var_842);
    var_844 = wp::bit_or(var_835, var_843);
    var_846 = wp::extract(var_27, var_845);
    var_848 = (var_846 >= var_847);
    if (var_848) {
        var_850 = wp::lshift(var_849, var_845);
    }
    if (!var_848) {
    }
    var_852 = wp::where(var_848, var_850, var_851);
    var_853 = wp::bit_or(var_844, var_852);
    // return mask                                                                            <L 27>
    return var_853;
}


// /work/main/src/pointloom/kernels/search/tree_walk.py:20
static CUDA_CALLABLE wp::int32 lowest_bit_0(
    wp::int32 var_bits)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32 var_1;
    const wp::int32 var_2 = 1;
    wp::int32 var_3;
    wp::int32 var_4;
    //---------
    // forward
    // def lowest_bit(bits: int) -> int:                                                      <L 21>
    // return bit_count((bits & (-bits)) - 1)                                                 <L 22>
    var_0 = wp::neg(var_bits);
    var_1 = wp::bit_and(var_bits, var_0);
    var_3 = wp::sub(var_1, var_2);
    var_4 = wp::bit_count(var_3);
    return var_4;
}


// /work/main/src/pointloom/kernels/rays/ray_hits.py:330
static CUDA_CALLABLE wp::float64 cross_products_0(
    wp::float32 var_ax,
    wp::float32 var_ay,
    wp::float32 var_bx,
    wp::float32 var_by)
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
    //---------
    // forward
    // def cross_products(ax: float, ay: float, bx: float, by: float) -> float64:             <L 331>
    // return float64(ax) * float64(by) - float64(ay) * float64(bx)                           <L 333>
    var_0 = wp::float64(var_ax);
    var_1 = wp::float64(var_by);
    var_2 = wp::mul(var_0, var_1);
    var_3 = wp::float64(var_ay);
    var_4 = wp::float64(var_bx);
    var_5 = wp::mul(var_3, var_4);
    var_6 = wp::sub(var_2, var_5);
    return var_6;
}


// <pointloom.kernels.rays.ray_hits.meet_edge>:1
static CUDA_CALLABLE wp::vec_t<3, wp::float64> meet_edge_0(
    wp::float32 var_ax,
    wp::float32 var_ay,
    wp::float32 var_az,
    wp::float32 var_bx,
    wp::float32 var_by,
    wp::float32 var_bz)
{
    //---------
    // primal vars
    bool var_0;
    bool var_1;
    bool var_2;
    bool var_3;
    bool var_4;
    const wp::int32 var_5 = 1;
    const wp::int32 var_6 = 0;
    wp::int32 var_7;
    const wp::int32 var_8 = 1;
    bool var_9;
    wp::float32 var_10;
    wp::float64 var_11;
    const wp::int32 var_12 = 1;
    bool var_13;
    wp::float32 var_14;
    wp::float64 var_15;
    wp::float64 var_16;
    wp::float64 var_17;
    wp::float64 var_18;
    wp::float64 var_19;
    wp::float64 var_20;
    wp::float64 var_21;
    bool var_22;
    const wp::int32 var_23 = 1;
    bool var_24;
    wp::float32 var_25;
    wp::float64 var_26;
    const wp::int32 var_27 = 1;
    bool var_28;
    wp::float32 var_29;
    wp::float64 var_30;
    wp::float64 var_31;
    wp::float64 var_32;
    const wp::int32 var_33 = 1;
    bool var_34;
    wp::float32 var_35;
    wp::float64 var_36;
    const wp::int32 var_37 = 1;
    bool var_38;
    wp::float32 var_39;
    wp::float64 var_40;
    wp::float64 var_41;
    wp::float64 var_42;
    wp::float64 var_43;
    wp::float64 var_44;
    wp::float64 var_45;
    wp::float64 var_46;
    wp::float64 var_47;
    wp::float64 var_48;
    wp::float64 var_49;
    wp::float64 var_50;
    wp::vec_t<3, wp::float64> var_51;
    const wp::int32 var_52 = 1;
    bool var_53;
    wp::vec_t<3, wp::float64> var_54;
    wp::vec_t<3, wp::float64> var_55;
    //---------
    // forward
    // def meet_edge(ax, ay, az, bx, by, bz):                                                 <L 1>
    // swapped = 1 if bx < ax or (bx == ax and by < ay) else 0                                <L 3>
    var_1 = (var_bx < var_ax);
    var_0 = var_1;
    if (!var_0) {
        var_3 = (var_bx == var_ax);
        var_2 = var_3;
        if (var_2) {
            var_4 = (var_by < var_ay);
            var_2 = var_2 && var_4;
        }
        var_0 = var_0 || var_2;
    }
    if (var_0) {
    }
    if (!var_0) {
    }
    var_7 = wp::where(var_0, var_5, var_6);
    // p = float64(bx if swapped == 1 else ax)                                                <L 4>
    var_9 = (var_7 == var_8);
    if (var_9) {
    }
    if (!var_9) {
    }
    var_10 = wp::where(var_9, var_bx, var_ax);
    var_11 = wp::float64(var_10);
    // q = float64(ax if swapped == 1 else bx)                                                <L 5>
    var_13 = (var_7 == var_12);
    if (var_13) {
    }
    if (!var_13) {
    }
    var_14 = wp::where(var_13, var_ax, var_bx);
    var_15 = wp::float64(var_14);
    // if abs(float64(by) - float64(ay)) > abs(q - p):                                        <L 6>
    var_16 = wp::float64(var_by);
    var_17 = wp::float64(var_ay);
    var_18 = wp::sub(var_16, var_17);
    var_19 = wp::abs(var_18);
    var_20 = wp::sub(var_15, var_11);
    var_21 = wp::abs(var_20);
    var_22 = (var_19 > var_21);
    if (var_22) {
        // p = float64(by if swapped == 1 else ay)                                            <L 7>
        var_24 = (var_7 == var_23);
        if (var_24) {
        }
        if (!var_24) {
        }
        var_25 = wp::where(var_24, var_by, var_ay);
        var_26 = wp::float64(var_25);
        // q = float64(ay if swapped == 1 else by)                                            <L 8>
        var_28 = (var_7 == var_27);
        if (var_28) {
        }
        if (!var_28) {
        }
        var_29 = wp::where(var_28, var_ay, var_by);
        var_30 = wp::float64(var_29);
    }
    var_31 = wp::where(var_22, var_26, var_11);
    var_32 = wp::where(var_22, var_30, var_15);
    // near = float64(bz if swapped == 1 else az)                                             <L 9>
    var_34 = (var_7 == var_33);
    if (var_34) {
    }
    if (!var_34) {
    }
    var_35 = wp::where(var_34, var_bz, var_az);
    var_36 = wp::float64(var_35);
    // far = float64(az if swapped == 1 else bz)                                              <L 10>
    var_38 = (var_7 == var_37);
    if (var_38) {
    }
    if (!var_38) {
    }
    var_39 = wp::where(var_38, var_az, var_bz);
    var_40 = wp::float64(var_39);
    // share = -p / (q - p)                                                                   <L 11>
    var_41 = wp::neg(var_31);
    var_42 = wp::sub(var_32, var_31);
    var_43 = wp::div(var_41, var_42);
    // rest = float64(1.0) - share                                                            <L 12>
    var_44 = 1.0;
    var_45 = wp::sub(var_44, var_43);
    // depth = (near * q - far * p) / (q - p)                                                 <L 13>
    var_46 = wp::mul(var_36, var_32);
    var_47 = wp::mul(var_40, var_31);
    var_48 = wp::sub(var_46, var_47);
    var_49 = wp::sub(var_32, var_31);
    var_50 = wp::div(var_48, var_49);
    // weights = weights_and_depth(rest, share, depth)                                        <L 14>
    var_51 = wp::vec_t<3, wp::float64>(var_45, var_43, var_50);
    // if swapped == 1:                                                                       <L 15>
    var_53 = (var_7 == var_52);
    if (var_53) {
        // weights = weights_and_depth(share, rest, depth)                                    <L 16>
        var_54 = wp::vec_t<3, wp::float64>(var_43, var_45, var_50);
    }
    var_55 = wp::where(var_53, var_54, var_51);
    // return weights                                                                         <L 17>
    return var_55;
}


// /work/main/src/pointloom/kernels/rays/ray_hits.py:356
static CUDA_CALLABLE wp::vec_t<4, wp::float64> meet_triangle_0(
    wp::array_t<wp::float32> var_corners,
    wp::int32 var_leaf,
    wp::int32 var_lane,
    wp::vec_t<3, wp::float32> var_o,
    wp::vec_t<3, wp::int32> var_axes,
    wp::vec_t<3, wp::float32> var_shear)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 72;
    wp::int32 var_1;
    wp::int32 var_2;
    const wp::int32 var_3 = 0;
    wp::int32 var_4;
    const wp::int32 var_5 = 8;
    wp::int32 var_6;
    wp::int32 var_7;
    const wp::int32 var_8 = 1;
    wp::int32 var_9;
    wp::int32 var_10;
    wp::int32 var_11;
    const wp::int32 var_12 = 2;
    wp::int32 var_13;
    wp::int32 var_14;
    wp::int32 var_15;
    const wp::int32 var_16 = 2;
    wp::int32 var_17;
    wp::float32 var_18;
    wp::float32* var_19;
    wp::float32 var_20;
    wp::float32 var_21;
    wp::float32* var_22;
    const wp::int32 var_23 = 0;
    wp::int32 var_24;
    wp::float32 var_25;
    wp::float32 var_26;
    wp::float32 var_27;
    const wp::int32 var_28 = 0;
    wp::float32 var_29;
    wp::float32 var_30;
    wp::float32 var_31;
    wp::float32* var_32;
    const wp::int32 var_33 = 1;
    wp::int32 var_34;
    wp::float32 var_35;
    wp::float32 var_36;
    wp::float32 var_37;
    const wp::int32 var_38 = 1;
    wp::float32 var_39;
    wp::float32 var_40;
    wp::float32 var_41;
    const wp::int32 var_42 = 3;
    wp::int32 var_43;
    wp::int32 var_44;
    wp::float32* var_45;
    wp::float32 var_46;
    wp::float32 var_47;
    const wp::int32 var_48 = 3;
    wp::int32 var_49;
    wp::int32 var_50;
    wp::float32* var_51;
    const wp::int32 var_52 = 0;
    wp::int32 var_53;
    wp::float32 var_54;
    wp::float32 var_55;
    wp::float32 var_56;
    const wp::int32 var_57 = 0;
    wp::float32 var_58;
    wp::float32 var_59;
    wp::float32 var_60;
    const wp::int32 var_61 = 3;
    wp::int32 var_62;
    wp::int32 var_63;
    wp::float32* var_64;
    const wp::int32 var_65 = 1;
    wp::int32 var_66;
    wp::float32 var_67;
    wp::float32 var_68;
    wp::float32 var_69;
    const wp::int32 var_70 = 1;
    wp::float32 var_71;
    wp::float32 var_72;
    wp::float32 var_73;
    const wp::int32 var_74 = 6;
    wp::int32 var_75;
    wp::int32 var_76;
    wp::float32* var_77;
    wp::float32 var_78;
    wp::float32 var_79;
    const wp::int32 var_80 = 6;
    wp::int32 var_81;
    wp::int32 var_82;
    wp::float32* var_83;
    const wp::int32 var_84 = 0;
    wp::int32 var_85;
    wp::float32 var_86;
    wp::float32 var_87;
    wp::float32 var_88;
    const wp::int32 var_89 = 0;
    wp::float32 var_90;
    wp::float32 var_91;
    wp::float32 var_92;
    const wp::int32 var_93 = 6;
    wp::int32 var_94;
    wp::int32 var_95;
    wp::float32* var_96;
    const wp::int32 var_97 = 1;
    wp::int32 var_98;
    wp::float32 var_99;
    wp::float32 var_100;
    wp::float32 var_101;
    const wp::int32 var_102 = 1;
    wp::float32 var_103;
    wp::float32 var_104;
    wp::float32 var_105;
    wp::float64 var_106;
    wp::float64 var_107;
    wp::float64 var_108;
    wp::float64 var_109;
    wp::float64 var_110;
    wp::float64 var_111;
    wp::float64 var_112;
    wp::float64 var_113;
    wp::vec_t<4, wp::float64> var_114;
    bool var_115;
    bool var_116;
    bool var_117;
    wp::float64 var_118;
    wp::float64 var_119;
    bool var_120;
    wp::float64 var_121;
    wp::float64 var_122;
    bool var_123;
    wp::float64 var_124;
    wp::float64 var_125;
    wp::float64 var_126;
    wp::float64 var_127;
    wp::float64 var_128;
    wp::float64 var_129;
    wp::float64 var_130;
    wp::float64 var_131;
    wp::float64 var_132;
    wp::float64 var_133;
    wp::float64 var_134;
    wp::float64 var_135;
    wp::float64 var_136;
    wp::float64 var_137;
    wp::float64 var_138;
    bool var_139;
    bool var_140;
    bool var_141;
    bool var_142;
    wp::vec_t<3, wp::float64> var_143;
    const wp::int32 var_144 = 0;
    wp::float64 var_145;
    const wp::int32 var_146 = 1;
    wp::float64 var_147;
    const wp::int32 var_148 = 2;
    wp::float64 var_149;
    wp::float64 var_150;
    wp::float64 var_151;
    wp::float64 var_152;
    bool var_153;
    bool var_154;
    bool var_155;
    bool var_156;
    wp::vec_t<3, wp::float64> var_157;
    const wp::int32 var_158 = 0;
    wp::float64 var_159;
    const wp::int32 var_160 = 1;
    wp::float64 var_161;
    const wp::int32 var_162 = 2;
    wp::float64 var_163;
    wp::float64 var_164;
    wp::float64 var_165;
    wp::float64 var_166;
    wp::vec_t<3, wp::float64> var_167;
    bool var_168;
    bool var_169;
    bool var_170;
    bool var_171;
    wp::vec_t<3, wp::float64> var_172;
    const wp::int32 var_173 = 0;
    wp::float64 var_174;
    const wp::int32 var_175 = 1;
    wp::float64 var_176;
    const wp::int32 var_177 = 2;
    wp::float64 var_178;
    wp::float64 var_179;
    wp::float64 var_180;
    wp::float64 var_181;
    wp::vec_t<3, wp::float64> var_182;
    bool var_183;
    bool var_184;
    bool var_185;
    bool var_186;
    wp::float64 var_187;
    wp::float64 var_188;
    wp::float64 var_189;
    wp::float64 var_190;
    wp::float64 var_191;
    wp::float64 var_192;
    wp::float64 var_193;
    wp::float64 var_194;
    wp::float64 var_195;
    const wp::int32 var_196 = 2;
    wp::float32 var_197;
    const wp::float32 var_198 = 0.0;
    bool var_199;
    wp::float64 var_200;
    wp::float64 var_201;
    wp::vec_t<4, wp::float64> var_202;
    wp::float64 var_203;
    wp::float64 var_204;
    wp::float64 var_205;
    wp::vec_t<4, wp::float64> var_206;
    //---------
    // forward
    // def meet_triangle(                                                                     <L 357>
    // at = leaf * LEAF_NUMBERS + lane                                                        <L 361>
    var_1 = wp::mul(var_leaf, var_0);
    var_2 = wp::add(var_1, var_lane);
    // x = at + axes[0] * LEAF                                                                <L 362>
    var_4 = wp::extract(var_axes, var_3);
    var_6 = wp::mul(var_4, var_5);
    var_7 = wp::add(var_2, var_6);
    // y = at + axes[1] * LEAF                                                                <L 363>
    var_9 = wp::extract(var_axes, var_8);
    var_10 = wp::mul(var_9, var_5);
    var_11 = wp::add(var_2, var_10);
    // z = at + axes[2] * LEAF                                                                <L 364>
    var_13 = wp::extract(var_axes, var_12);
    var_14 = wp::mul(var_13, var_5);
    var_15 = wp::add(var_2, var_14);
    // oz = o[axes[2]]                                                                        <L 365>
    var_17 = wp::extract(var_axes, var_16);
    var_18 = wp::extract(var_o, var_17);
    // az = corners[z] - oz                                                                   <L 366>
    var_19 = wp::address(var_corners, var_15);
    var_21 = wp::load(var_19);
    var_20 = wp::sub(var_21, var_18);
    // ax = (corners[x] - o[axes[0]]) - shear[0] * az                                         <L 367>
    var_22 = wp::address(var_corners, var_7);
    var_24 = wp::extract(var_axes, var_23);
    var_25 = wp::extract(var_o, var_24);
    var_27 = wp::load(var_22);
    var_26 = wp::sub(var_27, var_25);
    var_29 = wp::extract(var_shear, var_28);
    var_30 = wp::mul(var_29, var_20);
    var_31 = wp::sub(var_26, var_30);
    // ay = (corners[y] - o[axes[1]]) - shear[1] * az                                         <L 368>
    var_32 = wp::address(var_corners, var_11);
    var_34 = wp::extract(var_axes, var_33);
    var_35 = wp::extract(var_o, var_34);
    var_37 = wp::load(var_32);
    var_36 = wp::sub(var_37, var_35);
    var_39 = wp::extract(var_shear, var_38);
    var_40 = wp::mul(var_39, var_20);
    var_41 = wp::sub(var_36, var_40);
    // bz = corners[z + 3 * LEAF] - oz                                                        <L 369>
    var_43 = wp::mul(var_42, var_5);
    var_44 = wp::add(var_15, var_43);
    var_45 = wp::address(var_corners, var_44);
    var_47 = wp::load(var_45);
    var_46 = wp::sub(var_47, var_18);
    // bx = (corners[x + 3 * LEAF] - o[axes[0]]) - shear[0] * bz                              <L 370>
    var_49 = wp::mul(var_48, var_5);
    var_50 = wp::add(var_7, var_49);
    var_51 = wp::address(var_corners, var_50);
    var_53 = wp::extract(var_axes, var_52);
    var_54 = wp::extract(var_o, var_53);
    var_56 = wp::load(var_51);
    var_55 = wp::sub(var_56, var_54);
    var_58 = wp::extract(var_shear, var_57);
    var_59 = wp::mul(var_58, var_46);
    var_60 = wp::sub(var_55, var_59);
    // by = (corners[y + 3 * LEAF] - o[axes[1]]) - shear[1] * bz                              <L 371>
    var_62 = wp::mul(var_61, var_5);
    var_63 = wp::add(var_11, var_62);
    var_64 = wp::address(var_corners, var_63);
    var_66 = wp::extract(var_axes, var_65);
    var_67 = wp::extract(var_o, var_66);
    var_69 = wp::load(var_64);
    var_68 = wp::sub(var_69, var_67);
    var_71 = wp::extract(var_shear, var_70);
    var_72 = wp::mul(var_71, var_46);
    var_73 = wp::sub(var_68, var_72);
    // cz = corners[z + 6 * LEAF] - oz                                                        <L 372>
    var_75 = wp::mul(var_74, var_5);
    var_76 = wp::add(var_15, var_75);
    var_77 = wp::address(var_corners, var_76);
    var_79 = wp::load(var_77);
    var_78 = wp::sub(var_79, var_18);
    // cx = (corners[x + 6 * LEAF] - o[axes[0]]) - shear[0] * cz                              <L 373>
    var_81 = wp::mul(var_80, var_5);
    var_82 = wp::add(var_7, var_81);
    var_83 = wp::address(var_corners, var_82);
    var_85 = wp::extract(var_axes, var_84);
    var_86 = wp::extract(var_o, var_85);
    var_88 = wp::load(var_83);
    var_87 = wp::sub(var_88, var_86);
    var_90 = wp::extract(var_shear, var_89);
    var_91 = wp::mul(var_90, var_78);
    var_92 = wp::sub(var_87, var_91);
    // cy = (corners[y + 6 * LEAF] - o[axes[1]]) - shear[1] * cz                              <L 374>
    var_94 = wp::mul(var_93, var_5);
    var_95 = wp::add(var_11, var_94);
    var_96 = wp::address(var_corners, var_95);
    var_98 = wp::extract(var_axes, var_97);
    var_99 = wp::extract(var_o, var_98);
    var_101 = wp::load(var_96);
    var_100 = wp::sub(var_101, var_99);
    var_103 = wp::extract(var_shear, var_102);
    var_104 = wp::mul(var_103, var_78);
    var_105 = wp::sub(var_100, var_104);
    // zero = float64(0.0)                                                                    <L 375>
    var_106 = 0.0;
    // one = float64(1.0)                                                                     <L 376>
    var_107 = 1.0;
    // u = cross_products(cx, cy, bx, by)                                                     <L 377>
    var_108 = cross_products_0(var_92, var_105, var_60, var_73);
    // v = cross_products(ax, ay, cx, cy)                                                     <L 378>
    var_109 = cross_products_0(var_31, var_41, var_92, var_105);
    // w = cross_products(bx, by, ax, ay)                                                     <L 379>
    var_110 = cross_products_0(var_60, var_73, var_31, var_41);
    // total = u + v + w                                                                      <L 380>
    var_111 = wp::add(var_108, var_109);
    var_112 = wp::add(var_111, var_110);
    // met = depth_and_weights(float64(INFINITY), zero, zero, zero)                           <L 381>
    var_113 = INFINITY;
    var_114 = wp::vec_t<4, wp::float64>(var_113, var_106, var_106, var_106);
    // if total != zero and (min(u, min(v, w)) >= zero or max(u, max(v, w)) <= zero):         <L 382>
    var_116 = (var_112 != var_106);
    var_115 = var_116;
    if (var_115) {
        var_118 = wp::min(var_109, var_110);
        var_119 = wp::min(var_108, var_118);
        var_120 = (var_119 >= var_106);
        var_117 = var_120;
        if (!var_117) {
            var_121 = wp::max(var_109, var_110);
            var_122 = wp::max(var_108, var_121);
            var_123 = (var_122 <= var_106);
            var_117 = var_117 || var_123;
        }
        var_115 = var_115 && var_117;
    }
    if (var_115) {
        // depth = (u * float64(az) + v * float64(bz) + w * float64(cz)) / total              <L 383>
        var_124 = wp::float64(var_20);
        var_125 = wp::mul(var_108, var_124);
        var_126 = wp::float64(var_46);
        var_127 = wp::mul(var_109, var_126);
        var_128 = wp::add(var_125, var_127);
        var_129 = wp::float64(var_78);
        var_130 = wp::mul(var_110, var_129);
        var_131 = wp::add(var_128, var_130);
        var_132 = wp::div(var_131, var_112);
        // u = u / total + zero  # avoids minus zero                                          <L 384>
        var_133 = wp::div(var_108, var_112);
        var_134 = wp::add(var_133, var_106);
        // v = v / total + zero                                                               <L 385>
        var_135 = wp::div(var_109, var_112);
        var_136 = wp::add(var_135, var_106);
        // w = w / total + zero                                                               <L 386>
        var_137 = wp::div(var_110, var_112);
        var_138 = wp::add(var_137, var_106);
        // if u == zero and v != zero and w != zero:                                          <L 387>
        var_140 = (var_134 == var_106);
        var_139 = var_140;
        if (var_139) {
            var_141 = (var_136 != var_106);
            var_139 = var_139 && var_141;
        }
        if (var_139) {
            var_142 = (var_138 != var_106);
            var_139 = var_139 && var_142;
        }
        if (var_139) {
            // edge = meet_edge(bx, by, bz, cx, cy, cz)                                       <L 388>
            var_143 = meet_edge_0(var_60, var_73, var_46, var_92, var_105, var_78);
            // v = edge[0]                                                                    <L 389>
            var_145 = wp::extract(var_143, var_144);
            // w = edge[1]                                                                    <L 390>
            var_147 = wp::extract(var_143, var_146);
            // depth = edge[2]                                                                <L 391>
            var_149 = wp::extract(var_143, var_148);
        }
        var_150 = wp::where(var_139, var_145, var_136);
        var_151 = wp::where(var_139, var_147, var_138);
        var_152 = wp::where(var_139, var_149, var_132);
        // if v == zero and w != zero and u != zero:                                          <L 392>
        var_154 = (var_150 == var_106);
        var_153 = var_154;
        if (var_153) {
            var_155 = (var_151 != var_106);
            var_153 = var_153 && var_155;
        }
        if (var_153) {
            var_156 = (var_134 != var_106);
            var_153 = var_153 && var_156;
        }
        if (var_153) {
            // edge = meet_edge(cx, cy, cz, ax, ay, az)                                       <L 393>
            var_157 = meet_edge_0(var_92, var_105, var_78, var_31, var_41, var_20);
            // w = edge[0]                                                                    <L 394>
            var_159 = wp::extract(var_157, var_158);
            // u = edge[1]                                                                    <L 395>
            var_161 = wp::extract(var_157, var_160);
            // depth = edge[2]                                                                <L 396>
            var_163 = wp::extract(var_157, var_162);
        }
        var_164 = wp::where(var_153, var_161, var_134);
        var_165 = wp::where(var_153, var_159, var_151);
        var_166 = wp::where(var_153, var_163, var_152);
        var_167 = wp::where(var_153, var_157, var_143);
        // if w == zero and u != zero and v != zero:                                          <L 397>
        var_169 = (var_165 == var_106);
        var_168 = var_169;
        if (var_168) {
            var_170 = (var_164 != var_106);
            var_168 = var_168 && var_170;
        }
        if (var_168) {
            var_171 = (var_150 != var_106);
            var_168 = var_168 && var_171;
        }
        if (var_168) {
            // edge = meet_edge(ax, ay, az, bx, by, bz)                                       <L 398>
            var_172 = meet_edge_0(var_31, var_41, var_20, var_60, var_73, var_46);
            // u = edge[0]                                                                    <L 399>
            var_174 = wp::extract(var_172, var_173);
            // v = edge[1]                                                                    <L 400>
            var_176 = wp::extract(var_172, var_175);
            // depth = edge[2]                                                                <L 401>
            var_178 = wp::extract(var_172, var_177);
        }
        var_179 = wp::where(var_168, var_174, var_164);
        var_180 = wp::where(var_168, var_176, var_150);
        var_181 = wp::where(var_168, var_178, var_166);
        var_182 = wp::where(var_168, var_172, var_167);
        // if u == one or v == one or w == one:                                               <L 402>
        var_184 = (var_179 == var_107);
        var_183 = var_184;
        if (!var_183) {
            var_185 = (var_180 == var_107);
            var_183 = var_183 || var_185;
        }
        if (!var_183) {
            var_186 = (var_165 == var_107);
            var_183 = var_183 || var_186;
        }
        if (var_183) {
            // depth = u * float64(az) + v * float64(bz) + w * float64(cz)  # exact at a corner       <L 403>
            var_187 = wp::float64(var_20);
            var_188 = wp::mul(var_179, var_187);
            var_189 = wp::float64(var_46);
            var_190 = wp::mul(var_180, var_189);
            var_191 = wp::add(var_188, var_190);
            var_192 = wp::float64(var_78);
            var_193 = wp::mul(var_165, var_192);
            var_194 = wp::add(var_191, var_193);
        }
        var_195 = wp::where(var_183, var_194, var_181);
        // if shear[2] < 0.0:                                                                 <L 404>
        var_197 = wp::extract(var_shear, var_196);
        var_199 = (var_197 < var_198);
        if (var_199) {
            // depth = zero - depth  # avoids minus zero                                      <L 405>
            var_200 = wp::sub(var_106, var_195);
        }
        var_201 = wp::where(var_199, var_200, var_195);
        // met = depth_and_weights(depth, u, v, w)                                            <L 406>
        var_202 = wp::vec_t<4, wp::float64>(var_201, var_179, var_180, var_165);
    }
    var_203 = wp::where(var_115, var_179, var_108);
    var_204 = wp::where(var_115, var_180, var_109);
    var_205 = wp::where(var_115, var_165, var_110);
    var_206 = wp::where(var_115, var_202, var_114);
    // return met                                                                             <L 407>
    return var_206;
}


// <pointloom.kernels.rays.ray_hits.next_hit>:1
static CUDA_CALLABLE wp::vec_t<5, wp::float64> next_hit_on_cuda_0(
    wp::vec_t<3, wp::float32> var_o,
    wp::vec_t<3, wp::float32> var_d,
    wp::float32 var_nearest,
    wp::float32 var_farthest,
    wp::float64 var_after,
    wp::int32 var_above,
    wp::int32 var_any_hit,
    wp::array_t<wp::float32> var_trees__boxes,
    wp::array_t<wp::float32> var_trees__corners,
    wp::array_t<wp::int32> var_trees__order,
    wp::array_t<wp::int32> var_trees__rows,
    wp::array_t<wp::float64> var_trees__motions,
    wp::int32 var_trees__object_count,
    wp::array_t<wp::float32> var_trees__object_boxes,
    wp::array_t<wp::int32> var_trees__object_levels,
    wp::int32 var_trees__object_root,
    wp::vec_t<3, wp::float32> var_trees__low,
    wp::vec_t<3, wp::float32> var_trees__high)
{
    //---------
    // primal vars
    wp::vec_t<5, wp::float64> var_0;
    wp::int32 var_1;
    const wp::int32 var_2 = 1;
    bool var_3;
    wp::float32 var_4;
    const wp::int32 var_5 = 2147483647;
    wp::int32 var_6;
    wp::int32 var_7;
    const wp::float32 var_8 = 0.0;
    const wp::float32 var_9 = 0.0;
    const wp::float32 var_10 = 0.0;
    wp::vec_t<3, wp::float32> var_11;
    wp::vec_t<3, wp::int32> var_12;
    const wp::int32 var_13 = 2;
    wp::int32 var_14;
    wp::float32 var_15;
    wp::float32 var_16;
    wp::vec_t<3, wp::int32> var_17;
    wp::vec_t<3, wp::float32> var_18;
    wp::vec_t<3, wp::float32> var_19;
    wp::vec_t<3, wp::float32> var_20;
    wp::int64 var_21;
    wp::int64 var_22;
    wp::int64 var_23;
    wp::int64 var_24;
    wp::int64 var_25;
    wp::vec_t<4, wp::int64> var_26;
    const wp::int32 var_27 = 1;
    bool var_28;
    wp::vec_t<3, wp::float32> var_29;
    wp::vec_t<3, wp::float32> var_30;
    wp::vec_t<3, wp::float32> var_31;
    wp::vec_t<3, wp::float32> var_32;
    wp::float32 var_33;
    wp::float32 var_34;
    wp::vec_t<4, wp::int64> var_35;
    wp::vec_t<3, wp::float32> var_36;
    wp::vec_t<3, wp::float32> var_37;
    wp::vec_t<3, wp::float32> var_38;
    wp::vec_t<4, wp::int64> var_39;
    const wp::int32 var_40 = 3;
    wp::int64 var_41;
    wp::int32 var_42;
    const wp::int32 var_43 = 0;
    bool var_44;
    const wp::int32 var_45 = 3;
    wp::int64 var_46;
    wp::int32 var_47;
    wp::vec_t<3, wp::float64> var_48;
    wp::vec_t<3, wp::float64> var_49;
    const wp::int32 var_50 = 18;
    wp::int32 var_51;
    const wp::int32 var_52 = 9;
    wp::int32 var_53;
    wp::vec_t<3, wp::float64> var_54;
    wp::vec_t<3, wp::float64> var_55;
    wp::vec_t<3, wp::float32> var_56;
    wp::vec_t<3, wp::float64> var_57;
    wp::vec_t<3, wp::float64> var_58;
    wp::vec_t<3, wp::float32> var_59;
    wp::int32 var_60;
    const wp::int32 var_61 = 12;
    wp::int32 var_62;
    wp::vec_t<3, wp::float64> var_63;
    wp::vec_t<3, wp::float32> var_64;
    wp::int32 var_65;
    const wp::int32 var_66 = 15;
    wp::int32 var_67;
    wp::vec_t<3, wp::float64> var_68;
    wp::vec_t<3, wp::float32> var_69;
    const wp::int32 var_70 = 16;
    wp::int32 var_71;
    const wp::int32 var_72 = 14;
    wp::int32 var_73;
    wp::int32* var_74;
    wp::int32 var_75;
    wp::int32 var_76;
    wp::int32 var_77;
    const wp::int32 var_78 = 13;
    wp::int32 var_79;
    wp::int32* var_80;
    wp::int32 var_81;
    wp::int32 var_82;
    wp::vec_t<3, wp::int32> var_83;
    wp::vec_t<3, wp::float32> var_84;
    const wp::int32 var_85 = 2;
    wp::float32 var_86;
    wp::float32 var_87;
    wp::vec_t<3, wp::int32> var_88;
    wp::vec_t<3, wp::float32> var_89;
    wp::vec_t<3, wp::float32> var_90;
    wp::vec_t<3, wp::float32> var_91;
    wp::vec_t<3, wp::float32> var_92;
    wp::float32 var_93;
    const wp::float32 var_94 = 0.999999;
    wp::float32 var_95;
    wp::float32 var_96;
    const wp::float32 var_97 = 1.000001;
    wp::float32 var_98;
    wp::int32 var_99;
    wp::int32 var_100;
    const wp::int32 var_101 = 12;
    wp::int32 var_102;
    wp::int32* var_103;
    wp::int32 var_104;
    wp::int32 var_105;
    wp::int32 var_106;
    const wp::int32 var_107 = 0;
    wp::int32 var_108;
    wp::int64 var_109;
    wp::int64 var_110;
    bool var_111;
    const wp::int32 var_112 = 8;
    const wp::int32 var_113 = 1;
    wp::int32 var_114;
    const wp::int32 var_115 = 0;
    wp::int32 var_116;
    wp::int32 var_117;
    wp::int64 var_118;
    const wp::int32 var_119 = 255;
    wp::int32 var_120;
    const wp::int32 var_121 = 0;
    bool var_122;
    wp::int64 var_123;
    wp::int32 var_124;
    wp::int32 var_125;
    wp::int32 var_126;
    const wp::int32 var_127 = 2147483647;
    wp::int32 var_128;
    const wp::int32 var_129 = 0;
    bool var_130;
    wp::int32 var_131;
    wp::int32* var_132;
    wp::int32 var_133;
    wp::int32 var_134;
    wp::vec_t<8, wp::int32> var_135;
    wp::int32 var_136;
    const wp::int32 var_137 = 0;
    bool var_138;
    bool var_139;
    bool var_140;
    wp::int32 var_141;
    const wp::int32 var_142 = 7;
    wp::int32 var_143;
    bool var_144;
    wp::int32 var_145;
    const wp::int32 var_146 = 7;
    wp::int32 var_147;
    wp::int32 var_148;
    wp::int32 var_149;
    wp::int32 var_150;
    wp::int32 var_151;
    const wp::int32 var_152 = 0;
    bool var_153;
    wp::int32 var_154;
    const wp::int32 var_155 = 1;
    wp::int32 var_156;
    wp::int32 var_157;
    wp::vec_t<4, wp::float64> var_158;
    const wp::int32 var_159 = 0;
    wp::float64 var_160;
    wp::float64 var_161;
    wp::float64 var_162;
    wp::float32 var_163;
    bool var_164;
    wp::float64 var_165;
    bool var_166;
    bool var_167;
    wp::float64 var_168;
    bool var_169;
    bool var_170;
    bool var_171;
    bool var_172;
    bool var_173;
    bool var_174;
    const wp::int32 var_175 = 8;
    wp::int32 var_176;
    wp::int32 var_177;
    wp::int32* var_178;
    wp::int32 var_179;
    wp::int32 var_180;
    bool var_181;
    bool var_182;
    bool var_183;
    bool var_184;
    bool var_185;
    bool var_186;
    bool var_187;
    wp::float32 var_188;
    wp::int32 var_189;
    wp::int32 var_190;
    wp::float64 var_191;
    wp::float64 var_192;
    wp::int32 var_193;
    wp::int32 var_194;
    wp::float64 var_195;
    const wp::int32 var_196 = 2;
    wp::float64 var_197;
    const wp::int32 var_198 = 3;
    wp::float64 var_199;
    wp::vec_t<5, wp::float64> var_200;
    wp::float32 var_201;
    wp::float32 var_202;
    const wp::int32 var_203 = 1;
    bool var_204;
    const wp::float32 var_205 = -1.0;
    const wp::float32 var_206 = -1.0;
    wp::float32 var_207;
    wp::float32 var_208;
    wp::vec_t<5, wp::float64> var_209;
    wp::float32 var_210;
    wp::int32 var_211;
    wp::int32 var_212;
    wp::float32 var_213;
    wp::vec_t<5, wp::float64> var_214;
    wp::float32 var_215;
    wp::int32 var_216;
    wp::int32 var_217;
    wp::float32 var_218;
    const wp::int32 var_219 = 1;
    const wp::int32 var_220 = 7;
    wp::int32 var_221;
    wp::int32 var_222;
    wp::int32 var_223;
    wp::int32 var_224;
    wp::int32 var_225;
    wp::int32 var_226;
    wp::int32 var_227;
    const wp::int32 var_228 = 1;
    const wp::int32 var_229 = 7;
    wp::int32 var_230;
    wp::int32 var_231;
    wp::int32 var_232;
    wp::int32 var_233;
    wp::int64 var_234;
    wp::int64 var_235;
    wp::int64 var_236;
    wp::int64 var_237;
    wp::int64 var_238;
    wp::int64 var_239;
    wp::int64 var_240;
    wp::int64 var_241;
    wp::int32 var_242;
    wp::int64 var_243;
    wp::int32 var_244;
    bool var_245;
    wp::int32 var_246;
    const wp::int32 var_247 = 7;
    wp::int32 var_248;
    wp::int32 var_249;
    const wp::int32 var_250 = 1;
    wp::int32 var_251;
    const wp::int32 var_252 = 0;
    bool var_253;
    wp::int64 var_254;
    const wp::int32 var_255 = 1;
    wp::int32 var_256;
    wp::int32 var_257;
    wp::int64 var_258;
    wp::int64 var_259;
    wp::int64 var_260;
    wp::int64 var_261;
    wp::int32 var_262;
    const wp::int32 var_263 = 1;
    wp::int32 var_264;
    wp::int32 var_265;
    wp::int32 var_266;
    wp::int64 var_267;
    const wp::int32 var_268 = 0;
    wp::int64 var_269;
    const wp::int32 var_270 = 1;
    wp::int64 var_271;
    const wp::int32 var_272 = 2;
    wp::int64 var_273;
    wp::int64 var_274;
    wp::vec_t<4, wp::int64> var_275;
    bool var_276;
    const wp::int32 var_277 = 1;
    bool var_278;
    const wp::float32 var_279 = 0.0;
    bool var_280;
    wp::float32 var_281;
    wp::float32 var_282;
    wp::vec_t<4, wp::int64> var_283;
    wp::vec_t<4, wp::int64> var_284;
    //---------
    // forward
    // def next_hit(o, d, nearest, farthest, after, above, any_hit, trees__boxes, trees__corners, trees__order, trees__rows, trees__motions, trees__object_count, trees__object_boxes, trees__object_levels, trees__object_root, trees__low, trees__high):       <L 1>
    // best = no_hit()                                                                        <L 3>
    var_0 = no_hit_0();
    // if is_ray(o, d) == 1:                                                                  <L 4>
    var_1 = is_ray_0(var_o, var_d);
    var_3 = (var_1 == var_2);
    if (var_3) {
        // best_t = farthest                                                                  <L 5>
        var_4 = wp::copy(var_farthest);
        // best_number = int(NO_OBJECT)                                                       <L 6>
        var_6 = wp::int(var_5);
        // best_triangle = int(NO_OBJECT)                                                     <L 7>
        var_7 = wp::int(var_5);
        // zero__objects_on_ray__3 = vec3(0.0, 0.0, 0.0)                                      <L 8>
        var_11 = wp::vec_t<3, wp::float32>(var_8, var_9, var_10);
        // axes__objects_on_ray__3 = ray_axes(d)                                              <L 9>
        var_12 = ray_axes_0(var_d);
        // main__objects_on_ray__3 = abs(d[axes__objects_on_ray__3[2]])                       <L 10>
        var_14 = wp::extract(var_12, var_13);
        var_15 = wp::extract(var_d, var_14);
        var_16 = wp::abs(var_15);
        // near__objects_on_ray__3 = near_sides(d)                                            <L 11>
        var_17 = near_sides_0(var_d);
        // rates__objects_on_ray__3 = zero__objects_on_ray__3                                 <L 12>
        var_18 = wp::copy(var_11);
        // a__objects_on_ray__3 = zero__objects_on_ray__3                                     <L 13>
        var_19 = wp::copy(var_11);
        // b__objects_on_ray__3 = zero__objects_on_ray__3                                     <L 14>
        var_20 = wp::copy(var_11);
        // step__objects_on_ray__3 = leaf_traversal(int64(trees__object_root), int64(0), ~int64(0), int64(0))       <L 15>
        var_21 = wp::int64(var_trees__object_root);
        var_22 = 0ll;
        var_23 = 0ll;
        var_24 = wp::invert(var_23);
        var_25 = 0ll;
        var_26 = wp::vec_t<4, wp::int64>(var_21, var_22, var_24, var_25);
        // if trees__object_count > 1:                                                        <L 16>
        var_28 = (var_trees__object_count > var_27);
        if (var_28) {
            // rates__objects_on_ray__3 = rates_of(d, axes__objects_on_ray__3)                <L 17>
            var_29 = rates_of_0(var_d, var_12);
            // margins__objects_on_ray__3 = signed_margins(o, d, trees__low, trees__high, axes__objects_on_ray__3)       <L 18>
            var_30 = signed_margins_0(var_o, var_d, var_trees__low, var_trees__high, var_12);
            // a__objects_on_ray__3 = o + margins__objects_on_ray__3                          <L 19>
            var_31 = wp::add(var_o, var_30);
            // b__objects_on_ray__3 = o - margins__objects_on_ray__3                          <L 20>
            var_32 = wp::sub(var_o, var_30);
            // step__objects_on_ray__3 = next_object(step__objects_on_ray__3, near__objects_on_ray__3, a__objects_on_ray__3, b__objects_on_ray__3, rates__objects_on_ray__3, nearest * main__objects_on_ray__3, best_t * main__objects_on_ray__3, trees__object_boxes, trees__object_levels, trees__object_root)       <L 21>
            var_33 = wp::mul(var_nearest, var_16);
            var_34 = wp::mul(var_4, var_16);
            var_35 = next_object_0(var_26, var_17, var_31, var_32, var_29, var_33, var_34, var_trees__object_boxes, var_trees__object_levels, var_trees__object_root);
        }
        var_36 = wp::where(var_28, var_29, var_18);
        var_37 = wp::where(var_28, var_31, var_19);
        var_38 = wp::where(var_28, var_32, var_20);
        var_39 = wp::where(var_28, var_35, var_26);
        // while int(step__objects_on_ray__3[3]) >= 0:                                        <L 22>
    start_while_0:;
        var_41 = wp::extract(var_39, var_40);
        var_42 = wp::int(var_41);
        var_44 = (var_42 >= var_43);
    if ((var_44) == false) goto end_while_0;
            // row = int(step__objects_on_ray__3[3])                                          <L 23>
            var_46 = wp::extract(var_39, var_45);
            var_47 = wp::int(var_46);
            // p = rotate_into(widen(o), trees__motions, row) + vector_at(trees__motions, row * MOTION + 9)       <L 24>
            var_48 = widen_0(var_o);
            var_49 = rotate_into_0(var_48, var_trees__motions, var_47);
            var_51 = wp::mul(var_47, var_50);
            var_53 = wp::add(var_51, var_52);
            var_54 = vector_at_0(var_trees__motions, var_53);
            var_55 = wp::add(var_49, var_54);
            // q = narrow(p)                                                                  <L 25>
            var_56 = narrow_0(var_55);
            // e = narrow(rotate_into(widen(d), trees__motions, row))                         <L 26>
            var_57 = widen_0(var_d);
            var_58 = rotate_into_0(var_57, var_trees__motions, var_47);
            var_59 = narrow_0(var_58);
            // low = narrow(vector_at(trees__motions, row * MOTION + 12))                     <L 27>
            var_60 = wp::mul(var_47, var_50);
            var_62 = wp::add(var_60, var_61);
            var_63 = vector_at_0(var_trees__motions, var_62);
            var_64 = narrow_0(var_63);
            // high = narrow(vector_at(trees__motions, row * MOTION + 15))                    <L 28>
            var_65 = wp::mul(var_47, var_50);
            var_67 = wp::add(var_65, var_66);
            var_68 = vector_at_0(var_trees__motions, var_67);
            var_69 = narrow_0(var_68);
            // number = trees__rows[row * ROW + NUMBER]                                       <L 29>
            var_71 = wp::mul(var_47, var_70);
            var_73 = wp::add(var_71, var_72);
            var_74 = wp::address(var_trees__rows, var_73);
            var_76 = wp::load(var_74);
            var_75 = wp::copy(var_76);
            // first_leaf = trees__rows[row * ROW + FIRST_LEAF]                               <L 30>
            var_77 = wp::mul(var_47, var_70);
            var_79 = wp::add(var_77, var_78);
            var_80 = wp::address(var_trees__rows, var_79);
            var_82 = wp::load(var_80);
            var_81 = wp::copy(var_82);
            // own_axes = ray_axes(e)                                                         <L 31>
            var_83 = ray_axes_0(var_59);
            // shear = shear_of(e, own_axes)                                                  <L 32>
            var_84 = shear_of_0(var_59, var_83);
            // own_main = abs(shear[2])                                                       <L 33>
            var_86 = wp::extract(var_84, var_85);
            var_87 = wp::abs(var_86);
            // own_near = near_sides(e)                                                       <L 34>
            var_88 = near_sides_0(var_59);
            // own_rates = rates_of(e, own_axes)                                              <L 35>
            var_89 = rates_of_0(var_59, var_83);
            // own_margins = signed_margins(q, e, low, high, own_axes)                        <L 36>
            var_90 = signed_margins_0(var_56, var_59, var_64, var_69, var_83);
            // own_a = q + own_margins                                                        <L 37>
            var_91 = wp::add(var_56, var_90);
            // own_b = q - own_margins                                                        <L 38>
            var_92 = wp::sub(var_56, var_90);
            // own_begin = nearest * own_main * NARROWER                                      <L 39>
            var_93 = wp::mul(var_nearest, var_87);
            var_95 = wp::mul(var_93, var_94);
            // own_end = best_t * own_main * WIDER                                            <L 40>
            var_96 = wp::mul(var_4, var_87);
            var_98 = wp::mul(var_96, var_97);
            // first__leaves_on_ray_by_bits__2 = row * ROW                                    <L 41>
            var_99 = wp::mul(var_47, var_70);
            // root__leaves_on_ray_by_bits__2 = trees__rows[row * ROW + ROOT]                 <L 42>
            var_100 = wp::mul(var_47, var_70);
            var_102 = wp::add(var_100, var_101);
            var_103 = wp::address(var_trees__rows, var_102);
            var_105 = wp::load(var_103);
            var_104 = wp::copy(var_105);
            // level__leaves_on_ray_by_bits__2 = root__leaves_on_ray_by_bits__2               <L 43>
            var_106 = wp::copy(var_104);
            // node__leaves_on_ray_by_bits__2 = int(0)                                        <L 44>
            var_108 = wp::int(var_107);
            // pending__leaves_on_ray_by_bits__2 = ~int64(0)                                  <L 45>
            var_109 = 0ll;
            var_110 = wp::invert(var_109);
            // while level__leaves_on_ray_by_bits__2 <= root__leaves_on_ray_by_bits__2:       <L 46>
    start_while_2:;
            var_111 = (var_106 <= var_104);
    if ((var_111) == false) goto end_while_2;
                // shift__leaves_on_ray_by_bits__2 = int64(FAN__leaves_on_ray_by_bits * max(level__leaves_on_ray_by_bits__2 - 1, 0))       <L 47>
                var_114 = wp::sub(var_106, var_113);
                var_116 = wp::max(var_114, var_115);
                var_117 = wp::mul(var_112, var_116);
                var_118 = wp::int64(var_117);
                // left__leaves_on_ray_by_bits__2 = int(BYTE__leaves_on_ray_by_bits)          <L 48>
                var_120 = wp::int(var_119);
                // if level__leaves_on_ray_by_bits__2 > 0:                                    <L 49>
                var_122 = (var_106 > var_121);
                if (var_122) {
                    // left__leaves_on_ray_by_bits__2 = int(pending__leaves_on_ray_by_bits__2 >> shift__leaves_on_ray_by_bits__2) & BYTE__leaves_on_ray_by_bits       <L 50>
                    var_123 = wp::rshift(var_110, var_118);
                    var_124 = wp::int(var_123);
                    var_125 = wp::bit_and(var_124, var_119);
                }
                var_126 = wp::where(var_122, var_125, var_120);
                // key__leaves_on_ray_by_bits__2 = int(NOT_ENTERED__leaves_on_ray_by_bits)       <L 51>
                var_128 = wp::int(var_127);
                // if left__leaves_on_ray_by_bits__2 != 0:                                    <L 52>
                var_130 = (var_126 != var_129);
                if (var_130) {
                    // keys__leaves_on_ray_by_bits__2 = measure_entries(trees__boxes, trees__rows[first__leaves_on_ray_by_bits__2 + level__leaves_on_ray_by_bits__2] + node__leaves_on_ray_by_bits__2, own_near, own_a, own_b, own_rates, own_begin, own_end)       <L 53>
                    var_131 = wp::add(var_99, var_106);
                    var_132 = wp::address(var_trees__rows, var_131);
                    var_134 = wp::load(var_132);
                    var_133 = wp::add(var_134, var_108);
                    var_135 = measure_entries_0(var_trees__boxes, var_133, var_88, var_91, var_92, var_89, var_95, var_98);
                    // key__leaves_on_ray_by_bits__2 = first_entered(keys__leaves_on_ray_by_bits__2, left__leaves_on_ray_by_bits__2)       <L 54>
                    var_136 = first_entered_0(var_135, var_126);
                    // if level__leaves_on_ray_by_bits__2 == 0:                               <L 55>
                    var_138 = (var_106 == var_137);
                    if (var_138) {
                        // while key__leaves_on_ray_by_bits__2 < NOT_ENTERED__leaves_on_ray_by_bits and key__leaves_on_ray_by_bits__2 <= float_bits(own_end) | 7:       <L 56>
    start_while_4:;
                        var_140 = (var_136 < var_127);
                        var_139 = var_140;
                        if (var_139) {
                            var_141 = _float_bits_0(var_98);
                            var_143 = wp::bit_or(var_141, var_142);
                            var_144 = (var_136 <= var_143);
                            var_139 = var_139 && var_144;
                        }
    if ((var_139) == false) goto end_while_4;
                            // leaf = node__leaves_on_ray_by_bits__2 * FAN__leaves_on_ray_by_bits + (key__leaves_on_ray_by_bits__2 & 7)       <L 57>
                            var_145 = wp::mul(var_108, var_112);
                            var_147 = wp::bit_and(var_136, var_146);
                            var_148 = wp::add(var_145, var_147);
                            // leaf_index = first_leaf + leaf                                 <L 58>
                            var_149 = wp::add(var_81, var_148);
                            // byte__bits_of__1 = lanes_met(trees__corners, leaf_index, q, own_axes, shear)       <L 59>
                            var_150 = lanes_met_0(var_trees__corners, var_149, var_56, var_83, var_84);
                            // left__bits_of__1 = byte__bits_of__1                            <L 60>
                            var_151 = wp::copy(var_150);
                            // while left__bits_of__1 != 0:                                   <L 61>
    start_while_6:;
                            var_153 = (var_151 != var_152);
    if ((var_153) == false) goto end_while_6;
                                // lane = lowest_bit__bits_of(left__bits_of__1)               <L 62>
                                var_154 = lowest_bit_0(var_151);
                                // left__bits_of__1 = left__bits_of__1 & left__bits_of__1 - 1       <L 63>
                                var_156 = wp::sub(var_151, var_155);
                                var_157 = wp::bit_and(var_151, var_156);
                                // met = meet_triangle(trees__corners, leaf_index, lane, q, own_axes, shear)       <L 64>
                                var_158 = meet_triangle_0(var_trees__corners, var_149, var_154, var_56, var_83, var_84);
                                // t = float(met[0] / float64(own_main))                      <L 65>
                                var_160 = wp::extract(var_158, var_159);
                                var_161 = wp::float64(var_87);
                                var_162 = wp::div(var_160, var_161);
                                var_163 = wp::float(var_162);
                                // is_after = float64(t) > after or (float64(t) == after and number > above)       <L 66>
                                var_165 = wp::float64(var_163);
                                var_166 = (var_165 > var_after);
                                var_164 = var_166;
                                if (!var_164) {
                                    var_168 = wp::float64(var_163);
                                    var_169 = (var_168 == var_after);
                                    var_167 = var_169;
                                    if (var_167) {
                                        var_170 = (var_75 > var_above);
                                        var_167 = var_167 && var_170;
                                    }
                                    var_164 = var_164 || var_167;
                                }
                                // if is_after and t >= nearest and (t <= best_t) and isfinite(t):       <L 67>
                                var_171 = var_164;
                                if (var_171) {
                                    var_172 = (var_163 >= var_nearest);
                                    var_171 = var_171 && var_172;
                                }
                                if (var_171) {
                                    var_173 = (var_163 <= var_4);
                                    var_171 = var_171 && var_173;
                                }
                                if (var_171) {
                                    var_174 = wp::isfinite(var_163);
                                    var_171 = var_171 && var_174;
                                }
                                if (var_171) {
                                    // triangle = trees__order[leaf_index * LEAF + lane]       <L 68>
                                    var_176 = wp::mul(var_149, var_175);
                                    var_177 = wp::add(var_176, var_154);
                                    var_178 = wp::address(var_trees__order, var_177);
                                    var_180 = wp::load(var_178);
                                    var_179 = wp::copy(var_180);
                                    // is_first = t < best_t or number < best_number          <L 69>
                                    var_182 = (var_163 < var_4);
                                    var_181 = var_182;
                                    if (!var_181) {
                                        var_183 = (var_75 < var_6);
                                        var_181 = var_181 || var_183;
                                    }
                                    // if is_first or (number == best_number and triangle < best_triangle):       <L 70>
                                    var_184 = var_181;
                                    if (!var_184) {
                                        var_186 = (var_75 == var_6);
                                        var_185 = var_186;
                                        if (var_185) {
                                            var_187 = (var_179 < var_7);
                                            var_185 = var_185 && var_187;
                                        }
                                        var_184 = var_184 || var_185;
                                    }
                                    if (var_184) {
                                        // best_t = t                                         <L 71>
                                        var_188 = wp::copy(var_163);
                                        // best_number = number                               <L 72>
                                        var_189 = wp::copy(var_75);
                                        // best_triangle = triangle                           <L 73>
                                        var_190 = wp::copy(var_179);
                                        // best = hit(float64(t), float64(row), float64(leaf_index * LEAF + lane), met[2], met[3])       <L 74>
                                        var_191 = wp::float64(var_163);
                                        var_192 = wp::float64(var_47);
                                        var_193 = wp::mul(var_149, var_175);
                                        var_194 = wp::add(var_193, var_154);
                                        var_195 = wp::float64(var_194);
                                        var_197 = wp::extract(var_158, var_196);
                                        var_199 = wp::extract(var_158, var_198);
                                        var_200 = wp::vec_t<5, wp::float64>({var_191, var_192, var_195, var_197, var_199});
                                        // own_end = best_t * own_main * WIDER                <L 75>
                                        var_201 = wp::mul(var_188, var_87);
                                        var_202 = wp::mul(var_201, var_97);
                                        // if any_hit == 1:                                   <L 76>
                                        var_204 = (var_any_hit == var_203);
                                        if (var_204) {
                                            // own_end = -1.0                                 <L 77>
                                            // best_t = -1.0                                  <L 78>
                                        }
                                        var_207 = wp::where(var_204, var_206, var_188);
                                        var_208 = wp::where(var_204, var_205, var_202);
                                    }
                                    var_209 = wp::where(var_184, var_200, var_0);
                                    var_210 = wp::where(var_184, var_207, var_4);
                                    var_211 = wp::where(var_184, var_189, var_6);
                                    var_212 = wp::where(var_184, var_190, var_7);
                                    var_213 = wp::where(var_184, var_208, var_98);
                                }
                                var_214 = wp::where(var_171, var_209, var_0);
                                var_215 = wp::where(var_171, var_210, var_4);
                                var_216 = wp::where(var_171, var_211, var_6);
                                var_217 = wp::where(var_171, var_212, var_7);
                                var_218 = wp::where(var_171, var_213, var_98);
                                wp::assign(var_0, var_214);
                                wp::assign(var_4, var_215);
                                wp::assign(var_6, var_216);
                                wp::assign(var_7, var_217);
                                wp::assign(var_98, var_218);
                                wp::assign(var_151, var_157);
    goto start_while_6;
    end_while_6:;
                            // left__leaves_on_ray_by_bits__2 = left__leaves_on_ray_by_bits__2 ^ 1 << (key__leaves_on_ray_by_bits__2 & 7)       <L 79>
                            var_221 = wp::bit_and(var_136, var_220);
                            var_222 = wp::lshift(var_219, var_221);
                            var_223 = wp::bit_xor(var_126, var_222);
                            // key__leaves_on_ray_by_bits__2 = first_entered(keys__leaves_on_ray_by_bits__2, left__leaves_on_ray_by_bits__2)       <L 80>
                            var_224 = first_entered_0(var_135, var_223);
                            wp::assign(var_126, var_223);
                            wp::assign(var_136, var_224);
    goto start_while_4;
    end_while_4:;
                        // key__leaves_on_ray_by_bits__2 = NOT_ENTERED__leaves_on_ray_by_bits       <L 81>
                        var_225 = wp::copy(var_127);
                    }
                    if (!var_138) {
                        // others__leaves_on_ray_by_bits__2 = entered_bits(keys__leaves_on_ray_by_bits__2) & left__leaves_on_ray_by_bits__2 & ~(1 << (key__leaves_on_ray_by_bits__2 & 7))       <L 83>
                        var_226 = entered_bits_0(var_135);
                        var_227 = wp::bit_and(var_226, var_126);
                        var_230 = wp::bit_and(var_136, var_229);
                        var_231 = wp::lshift(var_228, var_230);
                        var_232 = wp::invert(var_231);
                        var_233 = wp::bit_and(var_227, var_232);
                        // pending__leaves_on_ray_by_bits__2 = pending__leaves_on_ray_by_bits__2 & ~(int64(FULL_BYTE__leaves_on_ray_by_bits) << shift__leaves_on_ray_by_bits__2) | int64(others__leaves_on_ray_by_bits__2) << shift__leaves_on_ray_by_bits__2       <L 84>
                        var_234 = 255ll;
                        var_235 = wp::lshift(var_234, var_118);
                        var_236 = wp::invert(var_235);
                        var_237 = wp::bit_and(var_110, var_236);
                        var_238 = wp::int64(var_233);
                        var_239 = wp::lshift(var_238, var_118);
                        var_240 = wp::bit_or(var_237, var_239);
                    }
                    var_241 = wp::where(var_138, var_110, var_240);
                    var_242 = wp::where(var_138, var_225, var_136);
                }
                var_243 = wp::where(var_130, var_241, var_110);
                var_244 = wp::where(var_130, var_242, var_128);
                // if key__leaves_on_ray_by_bits__2 < NOT_ENTERED__leaves_on_ray_by_bits:       <L 85>
                var_245 = (var_244 < var_127);
                if (var_245) {
                    // node__leaves_on_ray_by_bits__2 = node__leaves_on_ray_by_bits__2 * FAN__leaves_on_ray_by_bits + (key__leaves_on_ray_by_bits__2 & 7)       <L 86>
                    var_246 = wp::mul(var_108, var_112);
                    var_248 = wp::bit_and(var_244, var_247);
                    var_249 = wp::add(var_246, var_248);
                    // level__leaves_on_ray_by_bits__2 = level__leaves_on_ray_by_bits__2 - 1       <L 87>
                    var_251 = wp::sub(var_106, var_250);
                    // if level__leaves_on_ray_by_bits__2 > 0:                                <L 88>
                    var_253 = (var_251 > var_252);
                    if (var_253) {
                        // pending__leaves_on_ray_by_bits__2 = pending__leaves_on_ray_by_bits__2 | int64(FULL_BYTE__leaves_on_ray_by_bits) << int64(FAN__leaves_on_ray_by_bits * (level__leaves_on_ray_by_bits__2 - 1))       <L 89>
                        var_254 = wp::int64(var_234);
                        var_256 = wp::sub(var_251, var_255);
                        var_257 = wp::mul(var_112, var_256);
                        var_258 = wp::int64(var_257);
                        var_259 = wp::lshift(var_254, var_258);
                        var_260 = wp::bit_or(var_243, var_259);
                    }
                    var_261 = wp::where(var_253, var_260, var_243);
                }
                if (!var_245) {
                    // node__leaves_on_ray_by_bits__2 = node__leaves_on_ray_by_bits__2 // FAN__leaves_on_ray_by_bits       <L 91>
                    var_262 = wp::floordiv(var_108, var_112);
                    // level__leaves_on_ray_by_bits__2 = level__leaves_on_ray_by_bits__2 + 1       <L 92>
                    var_264 = wp::add(var_106, var_263);
                }
                var_265 = wp::where(var_245, var_251, var_264);
                var_266 = wp::where(var_245, var_249, var_262);
                var_267 = wp::where(var_245, var_261, var_243);
                wp::assign(var_106, var_265);
                wp::assign(var_108, var_266);
                wp::assign(var_110, var_267);
    goto start_while_2;
    end_while_2:;
            // step__objects_on_ray__3 = leaf_traversal(step__objects_on_ray__3[0], step__objects_on_ray__3[1], step__objects_on_ray__3[2], int64(-1))       <L 93>
            var_269 = wp::extract(var_39, var_268);
            var_271 = wp::extract(var_39, var_270);
            var_273 = wp::extract(var_39, var_272);
            var_274 = -1ll;
            var_275 = wp::vec_t<4, wp::int64>(var_269, var_271, var_273, var_274);
            // if trees__object_count > 1 and best_t >= 0.0:                                  <L 94>
            var_278 = (var_trees__object_count > var_277);
            var_276 = var_278;
            if (var_276) {
                var_280 = (var_4 >= var_279);
                var_276 = var_276 && var_280;
            }
            if (var_276) {
                // step__objects_on_ray__3 = next_object(step__objects_on_ray__3, near__objects_on_ray__3, a__objects_on_ray__3, b__objects_on_ray__3, rates__objects_on_ray__3, nearest * main__objects_on_ray__3, best_t * main__objects_on_ray__3, trees__object_boxes, trees__object_levels, trees__object_root)       <L 95>
                var_281 = wp::mul(var_nearest, var_16);
                var_282 = wp::mul(var_4, var_16);
                var_283 = next_object_0(var_275, var_17, var_37, var_38, var_36, var_281, var_282, var_trees__object_boxes, var_trees__object_levels, var_trees__object_root);
            }
            var_284 = wp::where(var_276, var_283, var_275);
            wp::assign(var_39, var_284);
    goto start_while_0;
    end_while_0:;
    }
    // return best                                                                            <L 96>
    return var_0;
}


// /work/main/src/pointloom/kernels/rays/triangle_tree.py:124
static CUDA_CALLABLE wp::vec_t<3, wp::float32> leaf_corner_0(
    wp::array_t<wp::float32> var_corners,
    wp::int32 var_leaf,
    wp::int32 var_lane,
    wp::int32 var_corner)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 72;
    wp::int32 var_1;
    const wp::int32 var_2 = 3;
    wp::int32 var_3;
    const wp::int32 var_4 = 8;
    wp::int32 var_5;
    wp::int32 var_6;
    wp::int32 var_7;
    wp::float32* var_8;
    wp::int32 var_9;
    wp::float32* var_10;
    const wp::int32 var_11 = 2;
    wp::int32 var_12;
    wp::int32 var_13;
    wp::float32* var_14;
    wp::vec_t<3, wp::float32> var_15;
    wp::float32 var_16;
    wp::float32 var_17;
    wp::float32 var_18;
    //---------
    // forward
    // def leaf_corner(corners: array(dtype=float32), leaf: int, lane: int, corner: int) -> vec3:       <L 125>
    // at = leaf * LEAF_NUMBERS + 3 * corner * LEAF + lane                                    <L 126>
    var_1 = wp::mul(var_leaf, var_0);
    var_3 = wp::mul(var_2, var_corner);
    var_5 = wp::mul(var_3, var_4);
    var_6 = wp::add(var_1, var_5);
    var_7 = wp::add(var_6, var_lane);
    // return vec3(corners[at], corners[at + LEAF], corners[at + 2 * LEAF])                   <L 127>
    var_8 = wp::address(var_corners, var_7);
    var_9 = wp::add(var_7, var_4);
    var_10 = wp::address(var_corners, var_9);
    var_12 = wp::mul(var_11, var_4);
    var_13 = wp::add(var_7, var_12);
    var_14 = wp::address(var_corners, var_13);
    var_16 = wp::load(var_8);
    var_17 = wp::load(var_10);
    var_18 = wp::load(var_14);
    var_15 = wp::vec_t<3, wp::float32>(var_16, var_17, var_18);
    return var_15;
}


// /work/main/src/pointloom/kernels/rays/ray_hits.py:441
static CUDA_CALLABLE wp::vec_t<3, wp::float64> rotate_back_0(
    wp::vec_t<3, wp::float64> var_n,
    wp::array_t<wp::float64> var_motions,
    wp::int32 var_row)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 18;
    wp::int32 var_1;
    wp::vec_t<3, wp::float64> var_2;
    const wp::int32 var_3 = 0;
    wp::float64 var_4;
    wp::vec_t<3, wp::float64> var_5;
    const wp::int32 var_6 = 3;
    wp::int32 var_7;
    wp::vec_t<3, wp::float64> var_8;
    const wp::int32 var_9 = 1;
    wp::float64 var_10;
    wp::vec_t<3, wp::float64> var_11;
    wp::vec_t<3, wp::float64> var_12;
    const wp::int32 var_13 = 6;
    wp::int32 var_14;
    wp::vec_t<3, wp::float64> var_15;
    const wp::int32 var_16 = 2;
    wp::float64 var_17;
    wp::vec_t<3, wp::float64> var_18;
    wp::vec_t<3, wp::float64> var_19;
    //---------
    // forward
    // def rotate_back(n: vec3d, motions: array(dtype=float64), row: int) -> vec3d:           <L 442>
    // at = row * MOTION                                                                      <L 444>
    var_1 = wp::mul(var_row, var_0);
    // return vector_at(motions, at) * n[0] + vector_at(motions, at + 3) * n[1] + vector_at(motions, at + 6) * n[2]       <L 445>
    var_2 = vector_at_0(var_motions, var_1);
    var_4 = wp::extract(var_n, var_3);
    var_5 = wp::mul(var_2, var_4);
    var_7 = wp::add(var_1, var_6);
    var_8 = vector_at_0(var_motions, var_7);
    var_10 = wp::extract(var_n, var_9);
    var_11 = wp::mul(var_8, var_10);
    var_12 = wp::add(var_5, var_11);
    var_14 = wp::add(var_1, var_13);
    var_15 = vector_at_0(var_motions, var_14);
    var_17 = wp::extract(var_n, var_16);
    var_18 = wp::mul(var_15, var_17);
    var_19 = wp::add(var_12, var_18);
    return var_19;
}


// <pointloom.kernels.rays.ray_casting.normal_of>:1
static CUDA_CALLABLE wp::vec_t<3, wp::float32> normal_of_1(
    wp::int32 var_index,
    wp::int32 var_row,
    wp::array_t<wp::float32> var_trees__corners,
    wp::array_t<wp::float64> var_trees__motions)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 8;
    wp::int32 var_1;
    wp::int32 var_2;
    const wp::int32 var_3 = 0;
    wp::vec_t<3, wp::float32> var_4;
    wp::int32 var_5;
    wp::int32 var_6;
    const wp::int32 var_7 = 1;
    wp::vec_t<3, wp::float32> var_8;
    wp::int32 var_9;
    wp::int32 var_10;
    const wp::int32 var_11 = 2;
    wp::vec_t<3, wp::float32> var_12;
    wp::vec_t<3, wp::float64> var_13;
    wp::vec_t<3, wp::float64> var_14;
    wp::vec_t<3, wp::float64> var_15;
    wp::vec_t<3, wp::float64> var_16;
    wp::vec_t<3, wp::float64> var_17;
    wp::vec_t<3, wp::float64> var_18;
    wp::vec_t<3, wp::float64> var_19;
    wp::vec_t<3, wp::float64> var_20;
    wp::float64 var_21;
    wp::vec_t<3, wp::float64> var_22;
    wp::vec_t<3, wp::float32> var_23;
    //---------
    // forward
    // def normal_of(index, row, trees__corners, trees__motions):                             <L 1>
    // a = leaf_corner(trees__corners, index // LEAF, index % LEAF, 0)                        <L 3>
    var_1 = wp::floordiv(var_index, var_0);
    var_2 = wp::mod(var_index, var_0);
    var_4 = leaf_corner_0(var_trees__corners, var_1, var_2, var_3);
    // b = leaf_corner(trees__corners, index // LEAF, index % LEAF, 1)                        <L 4>
    var_5 = wp::floordiv(var_index, var_0);
    var_6 = wp::mod(var_index, var_0);
    var_8 = leaf_corner_0(var_trees__corners, var_5, var_6, var_7);
    // c = leaf_corner(trees__corners, index // LEAF, index % LEAF, 2)                        <L 5>
    var_9 = wp::floordiv(var_index, var_0);
    var_10 = wp::mod(var_index, var_0);
    var_12 = leaf_corner_0(var_trees__corners, var_9, var_10, var_11);
    // n = rotate_back(cross(widen(b) - widen(a), widen(c) - widen(a)), trees__motions, row)       <L 6>
    var_13 = widen_0(var_8);
    var_14 = widen_0(var_4);
    var_15 = wp::sub(var_13, var_14);
    var_16 = widen_0(var_12);
    var_17 = widen_0(var_4);
    var_18 = wp::sub(var_16, var_17);
    var_19 = wp::cross(var_15, var_18);
    var_20 = rotate_back_0(var_19, var_trees__motions, var_row);
    // return narrow(n / length(n))                                                           <L 7>
    var_21 = wp::length(var_20);
    var_22 = wp::div(var_20, var_21);
    var_23 = narrow_0(var_22);
    return var_23;
}


// <pointloom.kernels.rays.ray_casting.store_hit>:1
static CUDA_CALLABLE void store_hit_0(
    wp::int32 var_i,
    wp::int32 var_row,
    wp::int32 var_index,
    wp::array_t<wp::float32> var_trees__corners,
    wp::array_t<wp::int32> var_trees__order,
    wp::array_t<wp::int32> var_trees__rows,
    wp::array_t<wp::float64> var_trees__motions,
    wp::array_t<wp::int32> var_hits__geometry_ids,
    wp::array_t<wp::int32> var_hits__primitive_ids,
    wp::array_t<wp::vec_t<3, wp::float32>> var_normals)
{
    //---------
    // primal vars
    const wp::int32 var_0 = -1;
    const wp::float32 var_1 = 0.0;
    const wp::float32 var_2 = 0.0;
    const wp::float32 var_3 = 0.0;
    wp::vec_t<3, wp::float32> var_4;
    const wp::int32 var_5 = 0;
    bool var_6;
    const wp::int32 var_7 = 16;
    wp::int32 var_8;
    const wp::int32 var_9 = 14;
    wp::int32 var_10;
    wp::int32* var_11;
    wp::int32 var_12;
    wp::int32 var_13;
    wp::int32* var_14;
    wp::int32 var_15;
    wp::int32 var_16;
    wp::vec_t<3, wp::float32> var_17;
    wp::vec_t<3, wp::float32> var_18;
    //---------
    // forward
    // def store_hit(i, row, index, trees__corners, trees__order, trees__rows, trees__motions, hits__geometry_ids, hits__primitive_ids, normals):       <L 1>
    // hits__geometry_ids[i] = NO_ID                                                          <L 3>
    wp::array_store(var_hits__geometry_ids, var_i, var_0);
    // hits__primitive_ids[i] = NO_ID                                                         <L 4>
    wp::array_store(var_hits__primitive_ids, var_i, var_0);
    // normal = vec3(0.0, 0.0, 0.0)                                                           <L 5>
    var_4 = wp::vec_t<3, wp::float32>(var_1, var_2, var_3);
    // if index >= 0:                                                                         <L 6>
    var_6 = (var_index >= var_5);
    if (var_6) {
        // hits__geometry_ids[i] = trees__rows[row * ROW + NUMBER]                            <L 7>
        var_8 = wp::mul(var_row, var_7);
        var_10 = wp::add(var_8, var_9);
        var_11 = wp::address(var_trees__rows, var_10);
        var_13 = wp::load(var_11);
        var_12 = wp::copy(var_13);
        wp::array_store(var_hits__geometry_ids, var_i, var_12);
        // hits__primitive_ids[i] = trees__order[index]                                       <L 8>
        var_14 = wp::address(var_trees__order, var_index);
        var_16 = wp::load(var_14);
        var_15 = wp::copy(var_16);
        wp::array_store(var_hits__primitive_ids, var_i, var_15);
        // normal = normal_of(index, row, trees__corners, trees__motions)                     <L 9>
        var_17 = normal_of_1(var_index, var_row, var_trees__corners, var_trees__motions);
    }
    var_18 = wp::where(var_6, var_17, var_4);
    // normals[i] = normal                                                                    <L 10>
    wp::array_store(var_normals, var_i, var_18);
}


// <pointloom.kernels.rays.ray_casting.cast_ray>:1
static CUDA_CALLABLE void cast_ray_on_cuda_0(
    wp::int32 var_i,
    wp::array_t<wp::float32> var_rays,
    wp::array_t<wp::float32> var_trees__boxes,
    wp::array_t<wp::float32> var_trees__corners,
    wp::array_t<wp::int32> var_trees__order,
    wp::array_t<wp::int32> var_trees__rows,
    wp::array_t<wp::float64> var_trees__motions,
    wp::int32 var_trees__object_count,
    wp::array_t<wp::float32> var_trees__object_boxes,
    wp::array_t<wp::int32> var_trees__object_levels,
    wp::int32 var_trees__object_root,
    wp::vec_t<3, wp::float32> var_trees__low,
    wp::vec_t<3, wp::float32> var_trees__high,
    wp::array_t<wp::float32> var_hits__t_hit,
    wp::array_t<wp::int32> var_hits__geometry_ids,
    wp::array_t<wp::int32> var_hits__primitive_ids,
    wp::array_t<wp::vec_t<2, wp::float32>> var_hits__primitive_uvs,
    wp::array_t<wp::vec_t<3, wp::float32>> var_normals)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float32> var_0;
    wp::vec_t<3, wp::float32> var_1;
    const wp::float32 var_2 = 0.0;
    const wp::float32 var_3 = INFINITY;
    wp::float64 var_4;
    const wp::int32 var_5 = -1;
    const wp::int32 var_6 = 0;
    wp::vec_t<5, wp::float64> var_7;
    const wp::int32 var_8 = 0;
    wp::float64 var_9;
    wp::float32 var_10;
    const wp::int32 var_11 = 3;
    wp::float64 var_12;
    wp::float32 var_13;
    const wp::int32 var_14 = 4;
    wp::float64 var_15;
    wp::float32 var_16;
    wp::vec_t<2, wp::float32> var_17;
    const wp::int32 var_18 = 1;
    wp::float64 var_19;
    wp::int32 var_20;
    const wp::int32 var_21 = 0;
    wp::float64 var_22;
    bool var_23;
    const wp::int32 var_24 = 2;
    wp::float64 var_25;
    wp::int32 var_26;
    const wp::int32 var_27 = -1;
    wp::int32 var_28;
    //---------
    // forward
    // def cast_ray(i, rays, trees__boxes, trees__corners, trees__order, trees__rows, trees__motions, trees__object_count, trees__object_boxes, trees__object_levels, trees__object_root, trees__low, trees__high, hits__t_hit, hits__geometry_ids, hits__primitive_ids, hits__primitive_uvs, normals):       <L 1>
    // met = next_hit(ray_origin(rays, i), ray_direction(rays, i), 0.0, INFINITY, float64(BEFORE), NO_ID, 0, trees__boxes, trees__corners, trees__order, trees__rows, trees__motions, trees__object_count, trees__object_boxes, trees__object_levels, trees__object_root, trees__low, trees__high)       <L 2>
    var_0 = ray_origin_0(var_rays, var_i);
    var_1 = ray_direction_0(var_rays, var_i);
    var_4 = -1.0;
    var_7 = next_hit_on_cuda_0(var_0, var_1, var_2, var_3, var_4, var_5, var_6, var_trees__boxes, var_trees__corners, var_trees__order, var_trees__rows, var_trees__motions, var_trees__object_count, var_trees__object_boxes, var_trees__object_levels, var_trees__object_root, var_trees__low, var_trees__high);
    // hits__t_hit[i] = float(met[0])                                                         <L 3>
    var_9 = wp::extract(var_7, var_8);
    var_10 = wp::float(var_9);
    wp::array_store(var_hits__t_hit, var_i, var_10);
    // hits__primitive_uvs[i] = vec2(float(met[3]), float(met[4]))                            <L 4>
    var_12 = wp::extract(var_7, var_11);
    var_13 = wp::float(var_12);
    var_15 = wp::extract(var_7, var_14);
    var_16 = wp::float(var_15);
    var_17 = wp::vec_t<2, wp::float32>(var_13, var_16);
    wp::array_store(var_hits__primitive_uvs, var_i, var_17);
    // store_hit(i, int(met[1]), int(met[2]) if isfinite(met[0]) else -1, trees__corners, trees__order, trees__rows, trees__motions, hits__geometry_ids, hits__primitive_ids, normals)       <L 5>
    var_19 = wp::extract(var_7, var_18);
    var_20 = wp::int(var_19);
    var_22 = wp::extract(var_7, var_21);
    var_23 = wp::isfinite(var_22);
    if (var_23) {
        var_25 = wp::extract(var_7, var_24);
        var_26 = wp::int(var_25);
    }
    if (!var_23) {
    }
    var_28 = wp::where(var_23, var_26, var_27);
    store_hit_0(var_i, var_20, var_28, var_trees__corners, var_trees__order, var_trees__rows, var_trees__motions, var_hits__geometry_ids, var_hits__primitive_ids, var_normals);
}


// /work/main/src/pointloom/kernels/rays/ray_packets.py:35
static CUDA_CALLABLE void adj_ray_origin_0(
    wp::array_t<wp::float32> var_rays,
    wp::int32 var_i,
    wp::array_t<wp::float32> & adj_rays,
    wp::int32 & adj_i,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/rays/ray_packets.py:40
static CUDA_CALLABLE void adj_ray_direction_0(
    wp::array_t<wp::float32> var_rays,
    wp::int32 var_i,
    wp::array_t<wp::float32> & adj_rays,
    wp::int32 & adj_i,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/rays/ray_hits.py:416
static CUDA_CALLABLE void adj_no_hit_0(
    wp::vec_t<5, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.rays.ray_hits.is_ray>:1
static CUDA_CALLABLE void adj_is_ray_0(
    wp::vec_t<3, wp::float32> var_o,
    wp::vec_t<3, wp::float32> var_d,
    wp::vec_t<3, wp::float32> & adj_o,
    wp::vec_t<3, wp::float32> & adj_d,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.rays.ray_hits.find_main_axis>:1
static CUDA_CALLABLE void adj_find_main_axis_0(
    wp::vec_t<3, wp::float32> var_d,
    wp::vec_t<3, wp::float32> & adj_d,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/rays/ray_hits.py:55
static CUDA_CALLABLE void adj_ray_axes_0(
    wp::vec_t<3, wp::float32> var_d,
    wp::vec_t<3, wp::float32> & adj_d,
    wp::vec_t<3, wp::int32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/rays/ray_hits.py:103
static CUDA_CALLABLE void adj_near_sides_0(
    wp::vec_t<3, wp::float32> var_d,
    wp::vec_t<3, wp::float32> & adj_d,
    wp::vec_t<3, wp::int32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/algebra/plain_min_max.py:11
static CUDA_CALLABLE void adj_larger_0(
    wp::float32 var_a,
    wp::float32 var_b,
    wp::float32 & adj_a,
    wp::float32 & adj_b,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/algebra/plain_min_max.py:6
static CUDA_CALLABLE void adj_smaller_0(
    wp::float32 var_a,
    wp::float32 var_b,
    wp::float32 & adj_a,
    wp::float32 & adj_b,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/rays/ray_hits.py:92
static CUDA_CALLABLE void adj_rates_of_0(
    wp::vec_t<3, wp::float32> var_d,
    wp::vec_t<3, wp::int32> var_axes,
    wp::vec_t<3, wp::float32> & adj_d,
    wp::vec_t<3, wp::int32> & adj_axes,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/rays/ray_hits.py:79
static CUDA_CALLABLE void adj_signed_margins_0(
    wp::vec_t<3, wp::float32> var_o,
    wp::vec_t<3, wp::float32> var_d,
    wp::vec_t<3, wp::float32> var_low,
    wp::vec_t<3, wp::float32> var_high,
    wp::vec_t<3, wp::int32> var_axes,
    wp::vec_t<3, wp::float32> & adj_o,
    wp::vec_t<3, wp::float32> & adj_d,
    wp::vec_t<3, wp::float32> & adj_low,
    wp::vec_t<3, wp::float32> & adj_high,
    wp::vec_t<3, wp::int32> & adj_axes,
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


// <pointloom.kernels.rays.ray_hits.measure_entries>:1
static CUDA_CALLABLE void adj_measure_entries_0(
    wp::array_t<wp::float32> var_boxes,
    wp::int32 var_record,
    wp::vec_t<3, wp::int32> var_near,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::vec_t<3, wp::float32> var_rates,
    wp::float32 var_begin,
    wp::float32 var_end,
    wp::array_t<wp::float32> & adj_boxes,
    wp::int32 & adj_record,
    wp::vec_t<3, wp::int32> & adj_near,
    wp::vec_t<3, wp::float32> & adj_a,
    wp::vec_t<3, wp::float32> & adj_b,
    wp::vec_t<3, wp::float32> & adj_rates,
    wp::float32 & adj_begin,
    wp::float32 & adj_end,
    wp::vec_t<8, wp::int32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/rays/ray_hits.py:148
static CUDA_CALLABLE void adj_first_entered_0(
    wp::vec_t<8, wp::int32> var_keys,
    wp::int32 var_left,
    wp::vec_t<8, wp::int32> & adj_keys,
    wp::int32 & adj_left,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/rays/ray_hits.py:159
static CUDA_CALLABLE void adj_entered_bits_0(
    wp::vec_t<8, wp::int32> var_keys,
    wp::vec_t<8, wp::int32> & adj_keys,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.rays.ray_hits.next_leaf>:1
static CUDA_CALLABLE void adj_next_leaf_0(
    wp::vec_t<4, wp::int64> var_step,
    wp::array_t<wp::int32> var_levels,
    wp::int32 var_root,
    wp::array_t<wp::float32> var_boxes,
    wp::vec_t<3, wp::int32> var_near,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::vec_t<3, wp::float32> var_rates,
    wp::float32 var_begin,
    wp::float32 var_end,
    wp::vec_t<4, wp::int64> & adj_step,
    wp::array_t<wp::int32> & adj_levels,
    wp::int32 & adj_root,
    wp::array_t<wp::float32> & adj_boxes,
    wp::vec_t<3, wp::int32> & adj_near,
    wp::vec_t<3, wp::float32> & adj_a,
    wp::vec_t<3, wp::float32> & adj_b,
    wp::vec_t<3, wp::float32> & adj_rates,
    wp::float32 & adj_begin,
    wp::float32 & adj_end,
    wp::vec_t<4, wp::int64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.rays.ray_hits.next_object>:1
static CUDA_CALLABLE void adj_next_object_0(
    wp::vec_t<4, wp::int64> var_step,
    wp::vec_t<3, wp::int32> var_near,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::vec_t<3, wp::float32> var_rates,
    wp::float32 var_begin,
    wp::float32 var_end,
    wp::array_t<wp::float32> var_trees__object_boxes,
    wp::array_t<wp::int32> var_trees__object_levels,
    wp::int32 var_trees__object_root,
    wp::vec_t<4, wp::int64> & adj_step,
    wp::vec_t<3, wp::int32> & adj_near,
    wp::vec_t<3, wp::float32> & adj_a,
    wp::vec_t<3, wp::float32> & adj_b,
    wp::vec_t<3, wp::float32> & adj_rates,
    wp::float32 & adj_begin,
    wp::float32 & adj_end,
    wp::array_t<wp::float32> & adj_trees__object_boxes,
    wp::array_t<wp::int32> & adj_trees__object_levels,
    wp::int32 & adj_trees__object_root,
    wp::vec_t<4, wp::int64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/algebra/transform.py:27
static CUDA_CALLABLE void adj_widen_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/rays/ray_hits.py:422
static CUDA_CALLABLE void adj_vector_at_0(
    wp::array_t<wp::float64> var_motions,
    wp::int32 var_at,
    wp::array_t<wp::float64> & adj_motions,
    wp::int32 & adj_at,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/rays/ray_hits.py:427
static CUDA_CALLABLE void adj_rotate_into_0(
    wp::vec_t<3, wp::float64> var_d,
    wp::array_t<wp::float64> var_motions,
    wp::int32 var_row,
    wp::vec_t<3, wp::float64> & adj_d,
    wp::array_t<wp::float64> & adj_motions,
    wp::int32 & adj_row,
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


// /work/main/src/pointloom/kernels/rays/ray_hits.py:72
static CUDA_CALLABLE void adj_shear_of_0(
    wp::vec_t<3, wp::float32> var_d,
    wp::vec_t<3, wp::int32> var_axes,
    wp::vec_t<3, wp::float32> & adj_d,
    wp::vec_t<3, wp::int32> & adj_axes,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.rays.ray_hits.lanes_met>:1
static CUDA_CALLABLE void adj_lanes_met_0(
    wp::array_t<wp::float32> var_corners,
    wp::int32 var_leaf,
    wp::vec_t<3, wp::float32> var_o,
    wp::vec_t<3, wp::int32> var_axes,
    wp::vec_t<3, wp::float32> var_shear,
    wp::array_t<wp::float32> & adj_corners,
    wp::int32 & adj_leaf,
    wp::vec_t<3, wp::float32> & adj_o,
    wp::vec_t<3, wp::int32> & adj_axes,
    wp::vec_t<3, wp::float32> & adj_shear,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/search/tree_walk.py:20
static CUDA_CALLABLE void adj_lowest_bit_0(
    wp::int32 var_bits,
    wp::int32 & adj_bits,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/rays/ray_hits.py:330
static CUDA_CALLABLE void adj_cross_products_0(
    wp::float32 var_ax,
    wp::float32 var_ay,
    wp::float32 var_bx,
    wp::float32 var_by,
    wp::float32 & adj_ax,
    wp::float32 & adj_ay,
    wp::float32 & adj_bx,
    wp::float32 & adj_by,
    wp::float64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.rays.ray_hits.meet_edge>:1
static CUDA_CALLABLE void adj_meet_edge_0(
    wp::float32 var_ax,
    wp::float32 var_ay,
    wp::float32 var_az,
    wp::float32 var_bx,
    wp::float32 var_by,
    wp::float32 var_bz,
    wp::float32 & adj_ax,
    wp::float32 & adj_ay,
    wp::float32 & adj_az,
    wp::float32 & adj_bx,
    wp::float32 & adj_by,
    wp::float32 & adj_bz,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/rays/ray_hits.py:356
static CUDA_CALLABLE void adj_meet_triangle_0(
    wp::array_t<wp::float32> var_corners,
    wp::int32 var_leaf,
    wp::int32 var_lane,
    wp::vec_t<3, wp::float32> var_o,
    wp::vec_t<3, wp::int32> var_axes,
    wp::vec_t<3, wp::float32> var_shear,
    wp::array_t<wp::float32> & adj_corners,
    wp::int32 & adj_leaf,
    wp::int32 & adj_lane,
    wp::vec_t<3, wp::float32> & adj_o,
    wp::vec_t<3, wp::int32> & adj_axes,
    wp::vec_t<3, wp::float32> & adj_shear,
    wp::vec_t<4, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.rays.ray_hits.next_hit>:1
static CUDA_CALLABLE void adj_next_hit_on_cuda_0(
    wp::vec_t<3, wp::float32> var_o,
    wp::vec_t<3, wp::float32> var_d,
    wp::float32 var_nearest,
    wp::float32 var_farthest,
    wp::float64 var_after,
    wp::int32 var_above,
    wp::int32 var_any_hit,
    wp::array_t<wp::float32> var_trees__boxes,
    wp::array_t<wp::float32> var_trees__corners,
    wp::array_t<wp::int32> var_trees__order,
    wp::array_t<wp::int32> var_trees__rows,
    wp::array_t<wp::float64> var_trees__motions,
    wp::int32 var_trees__object_count,
    wp::array_t<wp::float32> var_trees__object_boxes,
    wp::array_t<wp::int32> var_trees__object_levels,
    wp::int32 var_trees__object_root,
    wp::vec_t<3, wp::float32> var_trees__low,
    wp::vec_t<3, wp::float32> var_trees__high,
    wp::vec_t<3, wp::float32> & adj_o,
    wp::vec_t<3, wp::float32> & adj_d,
    wp::float32 & adj_nearest,
    wp::float32 & adj_farthest,
    wp::float64 & adj_after,
    wp::int32 & adj_above,
    wp::int32 & adj_any_hit,
    wp::array_t<wp::float32> & adj_trees__boxes,
    wp::array_t<wp::float32> & adj_trees__corners,
    wp::array_t<wp::int32> & adj_trees__order,
    wp::array_t<wp::int32> & adj_trees__rows,
    wp::array_t<wp::float64> & adj_trees__motions,
    wp::int32 & adj_trees__object_count,
    wp::array_t<wp::float32> & adj_trees__object_boxes,
    wp::array_t<wp::int32> & adj_trees__object_levels,
    wp::int32 & adj_trees__object_root,
    wp::vec_t<3, wp::float32> & adj_trees__low,
    wp::vec_t<3, wp::float32> & adj_trees__high,
    wp::vec_t<5, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/rays/triangle_tree.py:124
static CUDA_CALLABLE void adj_leaf_corner_0(
    wp::array_t<wp::float32> var_corners,
    wp::int32 var_leaf,
    wp::int32 var_lane,
    wp::int32 var_corner,
    wp::array_t<wp::float32> & adj_corners,
    wp::int32 & adj_leaf,
    wp::int32 & adj_lane,
    wp::int32 & adj_corner,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/rays/ray_hits.py:441
static CUDA_CALLABLE void adj_rotate_back_0(
    wp::vec_t<3, wp::float64> var_n,
    wp::array_t<wp::float64> var_motions,
    wp::int32 var_row,
    wp::vec_t<3, wp::float64> & adj_n,
    wp::array_t<wp::float64> & adj_motions,
    wp::int32 & adj_row,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.rays.ray_casting.normal_of>:1
static CUDA_CALLABLE void adj_normal_of_1(
    wp::int32 var_index,
    wp::int32 var_row,
    wp::array_t<wp::float32> var_trees__corners,
    wp::array_t<wp::float64> var_trees__motions,
    wp::int32 & adj_index,
    wp::int32 & adj_row,
    wp::array_t<wp::float32> & adj_trees__corners,
    wp::array_t<wp::float64> & adj_trees__motions,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.rays.ray_casting.store_hit>:1
static CUDA_CALLABLE void adj_store_hit_0(
    wp::int32 var_i,
    wp::int32 var_row,
    wp::int32 var_index,
    wp::array_t<wp::float32> var_trees__corners,
    wp::array_t<wp::int32> var_trees__order,
    wp::array_t<wp::int32> var_trees__rows,
    wp::array_t<wp::float64> var_trees__motions,
    wp::array_t<wp::int32> var_hits__geometry_ids,
    wp::array_t<wp::int32> var_hits__primitive_ids,
    wp::array_t<wp::vec_t<3, wp::float32>> var_normals,
    wp::int32 & adj_i,
    wp::int32 & adj_row,
    wp::int32 & adj_index,
    wp::array_t<wp::float32> & adj_trees__corners,
    wp::array_t<wp::int32> & adj_trees__order,
    wp::array_t<wp::int32> & adj_trees__rows,
    wp::array_t<wp::float64> & adj_trees__motions,
    wp::array_t<wp::int32> & adj_hits__geometry_ids,
    wp::array_t<wp::int32> & adj_hits__primitive_ids,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_normals)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.rays.ray_casting.cast_ray>:1
static CUDA_CALLABLE void adj_cast_ray_on_cuda_0(
    wp::int32 var_i,
    wp::array_t<wp::float32> var_rays,
    wp::array_t<wp::float32> var_trees__boxes,
    wp::array_t<wp::float32> var_trees__corners,
    wp::array_t<wp::int32> var_trees__order,
    wp::array_t<wp::int32> var_trees__rows,
    wp::array_t<wp::float64> var_trees__motions,
    wp::int32 var_trees__object_count,
    wp::array_t<wp::float32> var_trees__object_boxes,
    wp::array_t<wp::int32> var_trees__object_levels,
    wp::int32 var_trees__object_root,
    wp::vec_t<3, wp::float32> var_trees__low,
    wp::vec_t<3, wp::float32> var_trees__high,
    wp::array_t<wp::float32> var_hits__t_hit,
    wp::array_t<wp::int32> var_hits__geometry_ids,
    wp::array_t<wp::int32> var_hits__primitive_ids,
    wp::array_t<wp::vec_t<2, wp::float32>> var_hits__primitive_uvs,
    wp::array_t<wp::vec_t<3, wp::float32>> var_normals,
    wp::int32 & adj_i,
    wp::array_t<wp::float32> & adj_rays,
    wp::array_t<wp::float32> & adj_trees__boxes,
    wp::array_t<wp::float32> & adj_trees__corners,
    wp::array_t<wp::int32> & adj_trees__order,
    wp::array_t<wp::int32> & adj_trees__rows,
    wp::array_t<wp::float64> & adj_trees__motions,
    wp::int32 & adj_trees__object_count,
    wp::array_t<wp::float32> & adj_trees__object_boxes,
    wp::array_t<wp::int32> & adj_trees__object_levels,
    wp::int32 & adj_trees__object_root,
    wp::vec_t<3, wp::float32> & adj_trees__low,
    wp::vec_t<3, wp::float32> & adj_trees__high,
    wp::array_t<wp::float32> & adj_hits__t_hit,
    wp::array_t<wp::int32> & adj_hits__geometry_ids,
    wp::array_t<wp::int32> & adj_hits__primitive_ids,
    wp::array_t<wp::vec_t<2, wp::float32>> & adj_hits__primitive_uvs,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_normals)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void test_occlusions_kernel_73a54442_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_rays,
    wp::float32 var_nearest,
    wp::float32 var_farthest,
    wp::array_t<wp::float32> var_trees__boxes,
    wp::array_t<wp::float32> var_trees__corners,
    wp::array_t<wp::int32> var_trees__order,
    wp::array_t<wp::int32> var_trees__rows,
    wp::array_t<wp::float64> var_trees__motions,
    wp::int32 var_trees__object_count,
    wp::array_t<wp::float32> var_trees__object_boxes,
    wp::array_t<wp::int32> var_trees__object_levels,
    wp::int32 var_trees__object_root,
    wp::vec_t<3, wp::float32> var_trees__low,
    wp::vec_t<3, wp::float32> var_trees__high,
    wp::array_t<wp::uint8> var_occluded)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::vec_t<3, wp::float32> var_1;
        wp::vec_t<3, wp::float32> var_2;
        wp::float64 var_3;
        const wp::int32 var_4 = -1;
        const wp::int32 var_5 = 1;
        wp::vec_t<5, wp::float64> var_6;
        const wp::int32 var_7 = 0;
        wp::float64 var_8;
        bool var_9;
        const wp::int32 var_10 = 1;
        const wp::int32 var_11 = 0;
        wp::int32 var_12;
        wp::uint8 var_13;
        //---------
        // forward
        // def test_occlusions_kernel(rays, nearest, farthest, trees__boxes, trees__corners, trees__order, trees__rows, trees__motions, trees__object_count, trees__object_boxes, trees__object_levels, trees__object_root, trees__low, trees__high, occluded):       <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // o = ray_origin(rays, i)                                                                <L 3>
        var_1 = ray_origin_0(var_rays, var_0);
        // d = ray_direction(rays, i)                                                             <L 4>
        var_2 = ray_direction_0(var_rays, var_0);
        // met = next_hit(o, d, nearest, farthest, float64(BEFORE), NO_ID, 1, trees__boxes, trees__corners, trees__order, trees__rows, trees__motions, trees__object_count, trees__object_boxes, trees__object_levels, trees__object_root, trees__low, trees__high)       <L 5>
        var_3 = -1.0;
        var_6 = next_hit_on_cuda_0(var_1, var_2, var_nearest, var_farthest, var_3, var_4, var_5, var_trees__boxes, var_trees__corners, var_trees__order, var_trees__rows, var_trees__motions, var_trees__object_count, var_trees__object_boxes, var_trees__object_levels, var_trees__object_root, var_trees__low, var_trees__high);
        // occluded[i] = uint8(1 if isfinite(met[0]) else 0)                                      <L 6>
        var_8 = wp::extract(var_6, var_7);
        var_9 = wp::isfinite(var_8);
        if (var_9) {
        }
        if (!var_9) {
        }
        var_12 = wp::where(var_9, var_10, var_11);
        var_13 = wp::uint8(var_12);
        wp::array_store(var_occluded, var_0, var_13);
}



extern "C" __global__ void list_hits_kernel_7428983b_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_rays,
    wp::array_t<wp::int32> var_offsets,
    wp::array_t<wp::float32> var_trees__boxes,
    wp::array_t<wp::float32> var_trees__corners,
    wp::array_t<wp::int32> var_trees__order,
    wp::array_t<wp::int32> var_trees__rows,
    wp::array_t<wp::float64> var_trees__motions,
    wp::int32 var_trees__object_count,
    wp::array_t<wp::float32> var_trees__object_boxes,
    wp::array_t<wp::int32> var_trees__object_levels,
    wp::int32 var_trees__object_root,
    wp::vec_t<3, wp::float32> var_trees__low,
    wp::vec_t<3, wp::float32> var_trees__high,
    wp::array_t<wp::float32> var_hits__t_hit,
    wp::array_t<wp::int32> var_hits__geometry_ids,
    wp::array_t<wp::int32> var_hits__primitive_ids,
    wp::array_t<wp::vec_t<2, wp::float32>> var_hits__primitive_uvs,
    wp::array_t<wp::int32> var_ray_ids)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::vec_t<3, wp::float32> var_1;
        wp::vec_t<3, wp::float32> var_2;
        wp::float64 var_3;
        wp::float64 var_4;
        wp::float64 var_5;
        const wp::int32 var_6 = -1;
        wp::int32 var_7;
        wp::int32* var_8;
        const wp::int32 var_9 = 1;
        wp::int32 var_10;
        wp::int32* var_11;
        wp::range_t var_12;
        wp::int32 var_13;
        wp::int32 var_14;
        wp::int32 var_15;
        wp::float32 var_16;
        const wp::float32 var_17 = 0.0;
        wp::float32 var_18;
        const wp::float32 var_19 = INFINITY;
        const wp::int32 var_20 = 0;
        wp::vec_t<5, wp::float64> var_21;
        const wp::int32 var_22 = 0;
        wp::float64 var_23;
        const wp::int32 var_24 = 1;
        wp::float64 var_25;
        wp::int32 var_26;
        const wp::int32 var_27 = 16;
        wp::int32 var_28;
        const wp::int32 var_29 = 14;
        wp::int32 var_30;
        wp::int32* var_31;
        wp::int32 var_32;
        wp::int32 var_33;
        wp::float32 var_34;
        const wp::int32 var_35 = 2;
        wp::float64 var_36;
        wp::int32 var_37;
        wp::int32* var_38;
        wp::int32 var_39;
        wp::int32 var_40;
        const wp::int32 var_41 = 3;
        wp::float64 var_42;
        wp::float32 var_43;
        const wp::int32 var_44 = 4;
        wp::float64 var_45;
        wp::float32 var_46;
        wp::vec_t<2, wp::float32> var_47;
        //---------
        // forward
        // def list_hits_kernel(rays, offsets, trees__boxes, trees__corners, trees__order, trees__rows, trees__motions, trees__object_count, trees__object_boxes, trees__object_levels, trees__object_root, trees__low, trees__high, hits__t_hit, hits__geometry_ids, hits__primitive_ids, hits__primitive_uvs, ray_ids):       <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // o = ray_origin(rays, i)                                                                <L 3>
        var_1 = ray_origin_0(var_rays, var_0);
        // d = ray_direction(rays, i)                                                             <L 4>
        var_2 = ray_direction_0(var_rays, var_0);
        // after = float64(BEFORE) + float64(0.0)                                                 <L 5>
        var_3 = -1.0;
        var_4 = 0.0;
        var_5 = wp::add(var_3, var_4);
        // above = int(NO_ID)                                                                     <L 6>
        var_7 = wp::int(var_6);
        // for j in range(offsets[i], offsets[i + 1]):                                            <L 7>
        var_8 = wp::address(var_offsets, var_0);
        var_10 = wp::add(var_0, var_9);
        var_11 = wp::address(var_offsets, var_10);
        var_13 = wp::load(var_8);
        var_14 = wp::load(var_11);
        var_12 = wp::range(var_13, var_14);
        start_for_0:;
            if (iter_cmp(var_12) == 0) goto end_for_0;
            var_15 = wp::iter_next(var_12);
            // met = next_hit(o, d, max(float(after), 0.0), INFINITY, after, above, 0, trees__boxes, trees__corners, trees__order, trees__rows, trees__motions, trees__object_count, trees__object_boxes, trees__object_levels, trees__object_root, trees__low, trees__high)       <L 8>
            var_16 = wp::float(var_5);
            var_18 = wp::max(var_16, var_17);
            var_21 = next_hit_on_cuda_0(var_1, var_2, var_18, var_19, var_5, var_7, var_20, var_trees__boxes, var_trees__corners, var_trees__order, var_trees__rows, var_trees__motions, var_trees__object_count, var_trees__object_boxes, var_trees__object_levels, var_trees__object_root, var_trees__low, var_trees__high);
            // after = met[0]                                                                     <L 9>
            var_23 = wp::extract(var_21, var_22);
            // above = trees__rows[int(met[1]) * ROW + NUMBER]                                    <L 10>
            var_25 = wp::extract(var_21, var_24);
            var_26 = wp::int(var_25);
            var_28 = wp::mul(var_26, var_27);
            var_30 = wp::add(var_28, var_29);
            var_31 = wp::address(var_trees__rows, var_30);
            var_33 = wp::load(var_31);
            var_32 = wp::copy(var_33);
            // hits__t_hit[j] = float(after)                                                      <L 11>
            var_34 = wp::float(var_23);
            wp::array_store(var_hits__t_hit, var_15, var_34);
            // hits__geometry_ids[j] = above                                                      <L 12>
            wp::array_store(var_hits__geometry_ids, var_15, var_32);
            // hits__primitive_ids[j] = trees__order[int(met[2])]                                 <L 13>
            var_36 = wp::extract(var_21, var_35);
            var_37 = wp::int(var_36);
            var_38 = wp::address(var_trees__order, var_37);
            var_40 = wp::load(var_38);
            var_39 = wp::copy(var_40);
            wp::array_store(var_hits__primitive_ids, var_15, var_39);
            // hits__primitive_uvs[j] = vec2(float(met[3]), float(met[4]))                        <L 14>
            var_42 = wp::extract(var_21, var_41);
            var_43 = wp::float(var_42);
            var_45 = wp::extract(var_21, var_44);
            var_46 = wp::float(var_45);
            var_47 = wp::vec_t<2, wp::float32>(var_43, var_46);
            wp::array_store(var_hits__primitive_uvs, var_15, var_47);
            // ray_ids[j] = i                                                                     <L 15>
            wp::array_store(var_ray_ids, var_15, var_0);
            wp::assign(var_5, var_23);
            wp::assign(var_7, var_32);
            goto start_for_0;
        end_for_0:;
}



extern "C" __global__ void cast_single_rays_kernel_a6958c02_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_rays,
    wp::int32 var_run,
    wp::array_t<wp::float32> var_trees__boxes,
    wp::array_t<wp::float32> var_trees__corners,
    wp::array_t<wp::int32> var_trees__order,
    wp::array_t<wp::int32> var_trees__rows,
    wp::array_t<wp::float64> var_trees__motions,
    wp::int32 var_trees__object_count,
    wp::array_t<wp::float32> var_trees__object_boxes,
    wp::array_t<wp::int32> var_trees__object_levels,
    wp::int32 var_trees__object_root,
    wp::vec_t<3, wp::float32> var_trees__low,
    wp::vec_t<3, wp::float32> var_trees__high,
    wp::array_t<wp::float32> var_hits__t_hit,
    wp::array_t<wp::int32> var_hits__geometry_ids,
    wp::array_t<wp::int32> var_hits__primitive_ids,
    wp::array_t<wp::vec_t<2, wp::float32>> var_hits__primitive_uvs,
    wp::array_t<wp::vec_t<3, wp::float32>> var_normals)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        //---------
        // forward
        // def cast_single_rays_kernel(rays, run, trees__boxes, trees__corners, trees__order, trees__rows, trees__motions, trees__object_count, trees__object_boxes, trees__object_levels, trees__object_root, trees__low, trees__high, hits__t_hit, hits__geometry_ids, hits__primitive_ids, hits__primitive_uvs, normals):       <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // cast_ray(i, rays, trees__boxes, trees__corners, trees__order, trees__rows, trees__motions, trees__object_count, trees__object_boxes, trees__object_levels, trees__object_root, trees__low, trees__high, hits__t_hit, hits__geometry_ids, hits__primitive_ids, hits__primitive_uvs, normals)       <L 3>
        cast_ray_on_cuda_0(var_0, var_rays, var_trees__boxes, var_trees__corners, var_trees__order, var_trees__rows, var_trees__motions, var_trees__object_count, var_trees__object_boxes, var_trees__object_levels, var_trees__object_root, var_trees__low, var_trees__high, var_hits__t_hit, var_hits__geometry_ids, var_hits__primitive_ids, var_hits__primitive_uvs, var_normals);
}



extern "C" __global__ void count_hits_kernel_db0f71a0_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_rays,
    wp::array_t<wp::float32> var_trees__boxes,
    wp::array_t<wp::float32> var_trees__corners,
    wp::array_t<wp::int32> var_trees__order,
    wp::array_t<wp::int32> var_trees__rows,
    wp::array_t<wp::float64> var_trees__motions,
    wp::int32 var_trees__object_count,
    wp::array_t<wp::float32> var_trees__object_boxes,
    wp::array_t<wp::int32> var_trees__object_levels,
    wp::int32 var_trees__object_root,
    wp::vec_t<3, wp::float32> var_trees__low,
    wp::vec_t<3, wp::float32> var_trees__high,
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
        wp::vec_t<3, wp::float32> var_1;
        wp::vec_t<3, wp::float32> var_2;
        const wp::int32 var_3 = -1;
        wp::int32 var_4;
        wp::float64 var_5;
        wp::float64 var_6;
        wp::float64 var_7;
        const wp::int32 var_8 = -1;
        wp::int32 var_9;
        bool var_10;
        wp::float32 var_11;
        const wp::float32 var_12 = 0.0;
        wp::float32 var_13;
        const wp::float32 var_14 = INFINITY;
        const wp::int32 var_15 = 0;
        wp::vec_t<5, wp::float64> var_16;
        const wp::int32 var_17 = 0;
        wp::float64 var_18;
        bool var_19;
        const wp::int32 var_20 = 1;
        wp::float64 var_21;
        wp::int32 var_22;
        const wp::int32 var_23 = 16;
        wp::int32 var_24;
        const wp::int32 var_25 = 14;
        wp::int32 var_26;
        wp::int32* var_27;
        wp::int32 var_28;
        wp::int32 var_29;
        wp::int32 var_30;
        const wp::int32 var_31 = 1;
        wp::int32 var_32;
        //---------
        // forward
        // def count_hits_kernel(rays, trees__boxes, trees__corners, trees__order, trees__rows, trees__motions, trees__object_count, trees__object_boxes, trees__object_levels, trees__object_root, trees__low, trees__high, counts):       <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // o = ray_origin(rays, i)                                                                <L 3>
        var_1 = ray_origin_0(var_rays, var_0);
        // d = ray_direction(rays, i)                                                             <L 4>
        var_2 = ray_direction_0(var_rays, var_0);
        // count = int(-1)                                                                        <L 5>
        var_4 = wp::int(var_3);
        // after = float64(BEFORE) + float64(0.0)                                                 <L 6>
        var_5 = -1.0;
        var_6 = 0.0;
        var_7 = wp::add(var_5, var_6);
        // above = int(NO_ID)                                                                     <L 7>
        var_9 = wp::int(var_8);
        // while isfinite(after):                                                                 <L 8>
        start_while_0:;
        var_10 = wp::isfinite(var_7);
        if ((var_10) == false) goto end_while_0;
            // met = next_hit(o, d, max(float(after), 0.0), INFINITY, after, above, 0, trees__boxes, trees__corners, trees__order, trees__rows, trees__motions, trees__object_count, trees__object_boxes, trees__object_levels, trees__object_root, trees__low, trees__high)       <L 9>
            var_11 = wp::float(var_7);
            var_13 = wp::max(var_11, var_12);
            var_16 = next_hit_on_cuda_0(var_1, var_2, var_13, var_14, var_7, var_9, var_15, var_trees__boxes, var_trees__corners, var_trees__order, var_trees__rows, var_trees__motions, var_trees__object_count, var_trees__object_boxes, var_trees__object_levels, var_trees__object_root, var_trees__low, var_trees__high);
            // after = met[0]                                                                     <L 10>
            var_18 = wp::extract(var_16, var_17);
            // if isfinite(after):                                                                <L 11>
            var_19 = wp::isfinite(var_18);
            if (var_19) {
                // above = trees__rows[int(met[1]) * ROW + NUMBER]                                <L 12>
                var_21 = wp::extract(var_16, var_20);
                var_22 = wp::int(var_21);
                var_24 = wp::mul(var_22, var_23);
                var_26 = wp::add(var_24, var_25);
                var_27 = wp::address(var_trees__rows, var_26);
                var_29 = wp::load(var_27);
                var_28 = wp::copy(var_29);
            }
            var_30 = wp::where(var_19, var_28, var_9);
            // count += 1                                                                         <L 13>
            var_32 = wp::add(var_4, var_31);
            wp::assign(var_4, var_32);
            wp::assign(var_7, var_18);
            wp::assign(var_9, var_30);
        goto start_while_0;
        end_while_0:;
        // counts[i] = count                                                                      <L 14>
        wp::array_store(var_counts, var_0, var_4);
}


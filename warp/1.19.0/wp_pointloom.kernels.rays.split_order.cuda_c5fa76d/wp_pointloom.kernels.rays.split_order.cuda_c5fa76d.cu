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


// /work/main/src/pointloom/kernels/rays/split_order.py:32
static CUDA_CALLABLE void widen_run_0(
    wp::int32 var_run,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::int32 var_part,
    wp::int32 var_size,
    wp::array_t<wp::float32> var_low,
    wp::array_t<wp::float32> var_high)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    bool var_1;
    wp::float32 var_2;
    const wp::int32 var_3 = 3;
    wp::int32 var_4;
    wp::int32 var_5;
    wp::float32 var_6;
    const wp::int32 var_7 = 3;
    wp::int32 var_8;
    wp::int32 var_9;
    const wp::int32 var_10 = 3;
    wp::int32 var_11;
    wp::int32 var_12;
    wp::float32 var_13;
    wp::float32 var_14;
    const wp::int32 var_15 = 3;
    wp::int32 var_16;
    wp::int32 var_17;
    wp::float32 var_18;
    wp::float32 var_19;
    const wp::int32 var_20 = 1;
    bool var_21;
    wp::float32 var_22;
    const wp::int32 var_23 = 3;
    wp::int32 var_24;
    wp::int32 var_25;
    wp::float32 var_26;
    const wp::int32 var_27 = 3;
    wp::int32 var_28;
    wp::int32 var_29;
    const wp::int32 var_30 = 3;
    wp::int32 var_31;
    wp::int32 var_32;
    wp::float32 var_33;
    wp::float32 var_34;
    const wp::int32 var_35 = 3;
    wp::int32 var_36;
    wp::int32 var_37;
    wp::float32 var_38;
    wp::float32 var_39;
    const wp::int32 var_40 = 2;
    bool var_41;
    wp::float32 var_42;
    const wp::int32 var_43 = 3;
    wp::int32 var_44;
    wp::int32 var_45;
    wp::float32 var_46;
    const wp::int32 var_47 = 3;
    wp::int32 var_48;
    wp::int32 var_49;
    const wp::int32 var_50 = 3;
    wp::int32 var_51;
    wp::int32 var_52;
    wp::float32 var_53;
    wp::float32 var_54;
    const wp::int32 var_55 = 3;
    wp::int32 var_56;
    wp::int32 var_57;
    wp::float32 var_58;
    wp::float32 var_59;
    //---------
    // forward
    // def widen_run(run: int, a: vec3, b: vec3, part: int, size: int, low: array(dtype=float32), high: array(dtype=float32)):       <L 33>
    // for axis in range(3):                                                                  <L 35>
    // if part == size:                                                                       <L 36>
    var_1 = (var_part == var_size);
    if (var_1) {
        // low[3 * run + axis] = a[axis]                                                      <L 37>
        var_2 = wp::extract(var_a, var_0);
        var_4 = wp::mul(var_3, var_run);
        var_5 = wp::add(var_4, var_0);
        wp::array_store(var_low, var_5, var_2);
        // high[3 * run + axis] = b[axis]                                                     <L 38>
        var_6 = wp::extract(var_b, var_0);
        var_8 = wp::mul(var_7, var_run);
        var_9 = wp::add(var_8, var_0);
        wp::array_store(var_high, var_9, var_6);
    }
    if (!var_1) {
        // atomic_min(low, 3 * run + axis, a[axis])                                           <L 40>
        var_11 = wp::mul(var_10, var_run);
        var_12 = wp::add(var_11, var_0);
        var_13 = wp::extract(var_a, var_0);
        var_14 = wp::atomic_min(var_low, var_12, var_13);
        // atomic_max(high, 3 * run + axis, b[axis])                                          <L 41>
        var_16 = wp::mul(var_15, var_run);
        var_17 = wp::add(var_16, var_0);
        var_18 = wp::extract(var_b, var_0);
        var_19 = wp::atomic_max(var_high, var_17, var_18);
    }
    // if part == size:                                                                       <L 36>
    var_21 = (var_part == var_size);
    if (var_21) {
        // low[3 * run + axis] = a[axis]                                                      <L 37>
        var_22 = wp::extract(var_a, var_20);
        var_24 = wp::mul(var_23, var_run);
        var_25 = wp::add(var_24, var_20);
        wp::array_store(var_low, var_25, var_22);
        // high[3 * run + axis] = b[axis]                                                     <L 38>
        var_26 = wp::extract(var_b, var_20);
        var_28 = wp::mul(var_27, var_run);
        var_29 = wp::add(var_28, var_20);
        wp::array_store(var_high, var_29, var_26);
    }
    if (!var_21) {
        // atomic_min(low, 3 * run + axis, a[axis])                                           <L 40>
        var_31 = wp::mul(var_30, var_run);
        var_32 = wp::add(var_31, var_20);
        var_33 = wp::extract(var_a, var_20);
        var_34 = wp::atomic_min(var_low, var_32, var_33);
        // atomic_max(high, 3 * run + axis, b[axis])                                          <L 41>
        var_36 = wp::mul(var_35, var_run);
        var_37 = wp::add(var_36, var_20);
        var_38 = wp::extract(var_b, var_20);
        var_39 = wp::atomic_max(var_high, var_37, var_38);
    }
    // if part == size:                                                                       <L 36>
    var_41 = (var_part == var_size);
    if (var_41) {
        // low[3 * run + axis] = a[axis]                                                      <L 37>
        var_42 = wp::extract(var_a, var_40);
        var_44 = wp::mul(var_43, var_run);
        var_45 = wp::add(var_44, var_40);
        wp::array_store(var_low, var_45, var_42);
        // high[3 * run + axis] = b[axis]                                                     <L 38>
        var_46 = wp::extract(var_b, var_40);
        var_48 = wp::mul(var_47, var_run);
        var_49 = wp::add(var_48, var_40);
        wp::array_store(var_high, var_49, var_46);
    }
    if (!var_41) {
        // atomic_min(low, 3 * run + axis, a[axis])                                           <L 40>
        var_51 = wp::mul(var_50, var_run);
        var_52 = wp::add(var_51, var_40);
        var_53 = wp::extract(var_a, var_40);
        var_54 = wp::atomic_min(var_low, var_52, var_53);
        // atomic_max(high, 3 * run + axis, b[axis])                                          <L 41>
        var_56 = wp::mul(var_55, var_run);
        var_57 = wp::add(var_56, var_40);
        var_58 = wp::extract(var_b, var_40);
        var_59 = wp::atomic_max(var_high, var_57, var_58);
    }
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


// /work/main/src/pointloom/kernels/rays/split_order.py:32
static CUDA_CALLABLE void adj_widen_run_0(
    wp::int32 var_run,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::int32 var_part,
    wp::int32 var_size,
    wp::array_t<wp::float32> var_low,
    wp::array_t<wp::float32> var_high,
    wp::int32 & adj_run,
    wp::vec_t<3, wp::float32> & adj_a,
    wp::vec_t<3, wp::float32> & adj_b,
    wp::int32 & adj_part,
    wp::int32 & adj_size,
    wp::array_t<wp::float32> & adj_low,
    wp::array_t<wp::float32> & adj_high)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void bound_runs_by_lanes_kernel_35465b2a_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::array_t<wp::int32> var_order,
    wp::int32 var_part,
    wp::int32 var_size,
    wp::array_t<wp::float32> var_low,
    wp::array_t<wp::float32> var_high)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        const wp::int32 var_1 = 32;
        wp::int32 var_2;
        wp::int32 var_3;
        wp::int32 var_4;
        wp::shape_t* var_5;
        const wp::int32 var_6 = 0;
        wp::int32 var_7;
        wp::shape_t var_8;
        wp::int32 var_9;
        const wp::float32 var_10 = INFINITY;
        wp::vec_t<3, wp::float32> var_11;
        const wp::float32 var_12 = -INFINITY;
        const wp::float32 var_13 = -INFINITY;
        const wp::float32 var_14 = -INFINITY;
        wp::vec_t<3, wp::float32> var_15;
        wp::int32 var_16;
        wp::int32 var_17;
        bool var_18;
        wp::int32* var_19;
        wp::int32 var_20;
        wp::vec_t<3, wp::float32>* var_21;
        wp::vec_t<3, wp::float32> var_22;
        wp::vec_t<3, wp::float32> var_23;
        const wp::int32 var_24 = 0;
        wp::float32 var_25;
        const wp::int32 var_26 = 0;
        wp::float32 var_27;
        wp::float32 var_28;
        const wp::int32 var_29 = 1;
        wp::float32 var_30;
        const wp::int32 var_31 = 1;
        wp::float32 var_32;
        wp::float32 var_33;
        const wp::int32 var_34 = 2;
        wp::float32 var_35;
        const wp::int32 var_36 = 2;
        wp::float32 var_37;
        wp::float32 var_38;
        wp::vec_t<3, wp::float32> var_39;
        const wp::int32 var_40 = 0;
        wp::float32 var_41;
        const wp::int32 var_42 = 0;
        wp::float32 var_43;
        wp::float32 var_44;
        const wp::int32 var_45 = 1;
        wp::float32 var_46;
        const wp::int32 var_47 = 1;
        wp::float32 var_48;
        wp::float32 var_49;
        const wp::int32 var_50 = 2;
        wp::float32 var_51;
        const wp::int32 var_52 = 2;
        wp::float32 var_53;
        wp::float32 var_54;
        wp::vec_t<3, wp::float32> var_55;
        wp::int32 var_56;
        wp::vec_t<3, wp::float32> var_57;
        wp::vec_t<3, wp::float32> var_58;
        wp::int32 var_59;
        const wp::int32 var_60 = 0;
        bool var_61;
        wp::int32 var_62;
        //---------
        // forward
        // def bound_runs_by_lanes_kernel(                                                        <L 65>
        // i = tid()                                                                              <L 73>
        var_0 = builtin_tid1d();
        // head = i // WARP * part                                                                <L 74>
        var_2 = wp::floordiv(var_0, var_1);
        var_3 = wp::mul(var_2, var_part);
        // last = min(head + part, order.shape[0])                                                <L 75>
        var_4 = wp::add(var_3, var_part);
        var_5 = &(var_order.shape);
        var_8 = wp::load(var_5);
        var_7 = wp::extract(var_8, var_6);
        var_9 = wp::min(var_4, var_7);
        // a = vec3(INFINITY, INFINITY, INFINITY)                                                 <L 76>
        var_11 = wp::vec_t<3, wp::float32>(var_10, var_10, var_10);
        // b = vec3(-INFINITY, -INFINITY, -INFINITY)                                              <L 77>
        var_15 = wp::vec_t<3, wp::float32>(var_12, var_13, var_14);
        // j = head + i % WARP                                                                    <L 78>
        var_16 = wp::mod(var_0, var_1);
        var_17 = wp::add(var_3, var_16);
        // while j < last:                                                                        <L 79>
        start_while_0:;
        var_18 = (var_17 < var_9);
        if ((var_18) == false) goto end_while_0;
            // p = points[order[j]]                                                               <L 80>
            var_19 = wp::address(var_order, var_17);
            var_20 = wp::load(var_19);
            var_21 = wp::address(var_points, var_20);
            var_23 = wp::load(var_21);
            var_22 = wp::copy(var_23);
            // a = vec3(min(a[0], p[0]), min(a[1], p[1]), min(a[2], p[2]))                        <L 81>
            var_25 = wp::extract(var_11, var_24);
            var_27 = wp::extract(var_22, var_26);
            var_28 = wp::min(var_25, var_27);
            var_30 = wp::extract(var_11, var_29);
            var_32 = wp::extract(var_22, var_31);
            var_33 = wp::min(var_30, var_32);
            var_35 = wp::extract(var_11, var_34);
            var_37 = wp::extract(var_22, var_36);
            var_38 = wp::min(var_35, var_37);
            var_39 = wp::vec_t<3, wp::float32>(var_28, var_33, var_38);
            // b = vec3(max(b[0], p[0]), max(b[1], p[1]), max(b[2], p[2]))                        <L 82>
            var_41 = wp::extract(var_15, var_40);
            var_43 = wp::extract(var_22, var_42);
            var_44 = wp::max(var_41, var_43);
            var_46 = wp::extract(var_15, var_45);
            var_48 = wp::extract(var_22, var_47);
            var_49 = wp::max(var_46, var_48);
            var_51 = wp::extract(var_15, var_50);
            var_53 = wp::extract(var_22, var_52);
            var_54 = wp::max(var_51, var_53);
            var_55 = wp::vec_t<3, wp::float32>(var_44, var_49, var_54);
            // j += WARP                                                                          <L 83>
            var_56 = wp::add(var_17, var_1);
            wp::assign(var_11, var_39);
            wp::assign(var_15, var_55);
            wp::assign(var_17, var_56);
        goto start_while_0;
        end_while_0:;
        // a = lane_min_corner(a)                                                                 <L 84>
        var_57 = lane_min_corner_on_cuda_0(var_11);
        // b = lane_max_corner(b)                                                                 <L 85>
        var_58 = lane_max_corner_on_cuda_0(var_15);
        // if i % WARP == 0:                                                                      <L 86>
        var_59 = wp::mod(var_0, var_1);
        var_61 = (var_59 == var_60);
        if (var_61) {
            // widen_run(head // size, a, b, part, size, low, high)                               <L 87>
            var_62 = wp::floordiv(var_3, var_size);
            widen_run_0(var_62, var_57, var_58, var_part, var_size, var_low, var_high);
        }
}


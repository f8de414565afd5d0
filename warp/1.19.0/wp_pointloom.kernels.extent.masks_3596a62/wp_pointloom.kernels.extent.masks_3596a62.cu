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


// <pointloom.kernels.extent.masks.is_finite_row>:1
static CUDA_CALLABLE wp::int32 is_finite_row_0(
    wp::array_t<wp::float32> var_rows,
    wp::int32 var_i)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 1;
    wp::int32 var_1;
    wp::shape_t* var_2;
    const wp::int32 var_3 = 1;
    wp::int32 var_4;
    wp::shape_t var_5;
    wp::range_t var_6;
    wp::int32 var_7;
    wp::float32* var_8;
    bool var_9;
    wp::float32 var_10;
    bool var_11;
    const wp::int32 var_12 = 0;
    wp::int32 var_13;
    //---------
    // forward
    // def is_finite_row(rows, i):                                                            <L 1>
    // finite = int(1)                                                                        <L 2>
    var_1 = wp::int(var_0);
    // for column in range(rows.shape[1]):                                                    <L 3>
    var_2 = &(var_rows.shape);
    var_5 = wp::load(var_2);
    var_4 = wp::extract(var_5, var_3);
    var_6 = wp::range(var_4);
    start_for_0:;
        if (iter_cmp(var_6) == 0) goto end_for_0;
        var_7 = wp::iter_next(var_6);
        // if not isfinite(rows[i, column]):                                                  <L 4>
        var_8 = wp::address(var_rows, var_i, var_7);
        var_10 = wp::load(var_8);
        var_9 = wp::isfinite(var_10);
        var_11 = wp::unot(var_9);
        if (var_11) {
            // finite = 0                                                                     <L 5>
        }
        var_13 = wp::where(var_11, var_12, var_1);
        wp::assign(var_1, var_13);
        goto start_for_0;
    end_for_0:;
    // return finite                                                                          <L 6>
    return var_1;
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


// <pointloom.kernels.extent.masks.is_finite_row>:1
static CUDA_CALLABLE void adj_is_finite_row_0(
    wp::array_t<wp::float32> var_rows,
    wp::int32 var_i,
    wp::array_t<wp::float32> & adj_rows,
    wp::int32 & adj_i,
    wp::int32 & adj_ret)
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



extern "C" __global__ void mask_finite_kernel_31643be1_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::int32 var_drop_nan,
    wp::int32 var_drop_infinite,
    wp::array_t<wp::uint8> var_mask)
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
        wp::vec_t<3, wp::float32> var_2;
        wp::vec_t<3, wp::float32> var_3;
        const wp::int32 var_4 = 1;
        wp::int32 var_5;
        const wp::int32 var_6 = 0;
        wp::float32 var_7;
        bool var_8;
        bool var_9;
        wp::float32 var_10;
        wp::float32 var_11;
        bool var_12;
        const wp::int32 var_13 = 1;
        bool var_14;
        const wp::int32 var_15 = 0;
        wp::int32 var_16;
        const wp::int32 var_17 = 1;
        bool var_18;
        const wp::int32 var_19 = 0;
        wp::int32 var_20;
        wp::int32 var_21;
        wp::int32 var_22;
        const wp::int32 var_23 = 1;
        wp::float32 var_24;
        bool var_25;
        bool var_26;
        wp::float32 var_27;
        wp::float32 var_28;
        bool var_29;
        const wp::int32 var_30 = 1;
        bool var_31;
        const wp::int32 var_32 = 0;
        wp::int32 var_33;
        const wp::int32 var_34 = 1;
        bool var_35;
        const wp::int32 var_36 = 0;
        wp::int32 var_37;
        wp::int32 var_38;
        wp::int32 var_39;
        const wp::int32 var_40 = 2;
        wp::float32 var_41;
        bool var_42;
        bool var_43;
        wp::float32 var_44;
        wp::float32 var_45;
        bool var_46;
        const wp::int32 var_47 = 1;
        bool var_48;
        const wp::int32 var_49 = 0;
        wp::int32 var_50;
        const wp::int32 var_51 = 1;
        bool var_52;
        const wp::int32 var_53 = 0;
        wp::int32 var_54;
        wp::int32 var_55;
        wp::int32 var_56;
        wp::uint8 var_57;
        //---------
        // forward
        // def mask_finite_kernel(points, drop_nan, drop_infinite, mask):                         <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // p = points[i]                                                                          <L 4>
        var_1 = wp::address(var_points, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // keep = int(1)                                                                          <L 5>
        var_5 = wp::int(var_4);
        // for axis in range(3):                                                                  <L 6>
        // if not isfinite(p[axis]):                                                              <L 7>
        var_7 = wp::extract(var_2, var_6);
        var_8 = wp::isfinite(var_7);
        var_9 = wp::unot(var_8);
        if (var_9) {
            // if p[axis] == p[axis]:                                                             <L 8>
            var_10 = wp::extract(var_2, var_6);
            var_11 = wp::extract(var_2, var_6);
            var_12 = (var_10 == var_11);
            if (var_12) {
                // if drop_infinite == 1:                                                         <L 9>
                var_14 = (var_drop_infinite == var_13);
                if (var_14) {
                    // keep = 0                                                                   <L 10>
                }
                var_16 = wp::where(var_14, var_15, var_5);
            }
            if (!var_12) {
                // elif drop_nan == 1:                                                            <L 11>
                var_18 = (var_drop_nan == var_17);
                if (var_18) {
                    // keep = 0                                                                   <L 12>
                }
                var_20 = wp::where(var_18, var_19, var_5);
            }
            var_21 = wp::where(var_12, var_16, var_20);
        }
        var_22 = wp::where(var_9, var_21, var_5);
        // if not isfinite(p[axis]):                                                              <L 7>
        var_24 = wp::extract(var_2, var_23);
        var_25 = wp::isfinite(var_24);
        var_26 = wp::unot(var_25);
        if (var_26) {
            // if p[axis] == p[axis]:                                                             <L 8>
            var_27 = wp::extract(var_2, var_23);
            var_28 = wp::extract(var_2, var_23);
            var_29 = (var_27 == var_28);
            if (var_29) {
                // if drop_infinite == 1:                                                         <L 9>
                var_31 = (var_drop_infinite == var_30);
                if (var_31) {
                    // keep = 0                                                                   <L 10>
                }
                var_33 = wp::where(var_31, var_32, var_22);
            }
            if (!var_29) {
                // elif drop_nan == 1:                                                            <L 11>
                var_35 = (var_drop_nan == var_34);
                if (var_35) {
                    // keep = 0                                                                   <L 12>
                }
                var_37 = wp::where(var_35, var_36, var_22);
            }
            var_38 = wp::where(var_29, var_33, var_37);
        }
        var_39 = wp::where(var_26, var_38, var_22);
        // if not isfinite(p[axis]):                                                              <L 7>
        var_41 = wp::extract(var_2, var_40);
        var_42 = wp::isfinite(var_41);
        var_43 = wp::unot(var_42);
        if (var_43) {
            // if p[axis] == p[axis]:                                                             <L 8>
            var_44 = wp::extract(var_2, var_40);
            var_45 = wp::extract(var_2, var_40);
            var_46 = (var_44 == var_45);
            if (var_46) {
                // if drop_infinite == 1:                                                         <L 9>
                var_48 = (var_drop_infinite == var_47);
                if (var_48) {
                    // keep = 0                                                                   <L 10>
                }
                var_50 = wp::where(var_48, var_49, var_39);
            }
            if (!var_46) {
                // elif drop_nan == 1:                                                            <L 11>
                var_52 = (var_drop_nan == var_51);
                if (var_52) {
                    // keep = 0                                                                   <L 12>
                }
                var_54 = wp::where(var_52, var_53, var_39);
            }
            var_55 = wp::where(var_46, var_50, var_54);
        }
        var_56 = wp::where(var_43, var_55, var_39);
        // mask[i] = uint8(keep)                                                                  <L 13>
        var_57 = wp::uint8(var_56);
        wp::array_store(var_mask, var_0, var_57);
}



extern "C" __global__ void count_unusable_kernel_a6e0f982_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::array_t<wp::float32> var_rows,
    wp::int32 var_cloud,
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
        bool var_1;
        wp::int32 var_2;
        const wp::int32 var_3 = 0;
        bool var_4;
        wp::vec_t<3, wp::float32>* var_5;
        bool var_6;
        wp::vec_t<3, wp::float32> var_7;
        const wp::int32 var_8 = 1;
        wp::int32 var_9;
        //---------
        // forward
        // def count_unusable_kernel(                                                             <L 93>
        // i = tid()                                                                              <L 97>
        var_0 = builtin_tid1d();
        // if is_finite_row(rows, i) == 0 and isfinite(points[i]):                                <L 98>
        var_2 = is_finite_row_0(var_rows, var_0);
        var_4 = (var_2 == var_3);
        var_1 = var_4;
        if (var_1) {
            var_5 = wp::address(var_points, var_0);
            var_7 = wp::load(var_5);
            var_6 = wp::isfinite(var_7);
            var_1 = var_1 && var_6;
        }
        if (var_1) {
            // atomic_add(counts, cloud, 1)  # integer sum: order-independent                     <L 99>
            var_9 = wp::atomic_add(var_counts, var_cloud, var_8);
        }
}



extern "C" __global__ void drop_unusable_kernel_ca5da925_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_rows,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::int32 var_1;
        const wp::int32 var_2 = 0;
        bool var_3;
        const wp::float32 var_4 = NAN;
        wp::vec_t<3, wp::float32> var_5;
        //---------
        // forward
        // def drop_unusable_kernel(rows: array(dtype=float32, ndim=2), points: array(dtype=vec3)):       <L 103>
        // i = tid()                                                                              <L 105>
        var_0 = builtin_tid1d();
        // if is_finite_row(rows, i) == 0:                                                        <L 106>
        var_1 = is_finite_row_0(var_rows, var_0);
        var_3 = (var_1 == var_2);
        if (var_3) {
            // points[i] = vec3(NAN, NAN, NAN)                                                    <L 107>
            var_5 = wp::vec_t<3, wp::float32>(var_4, var_4, var_4);
            wp::array_store(var_points, var_0, var_5);
        }
}



extern "C" __global__ void mask_aligned_box_kernel_d3b3b5a5_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::vec_t<3, wp::float32> var_low,
    wp::vec_t<3, wp::float32> var_high,
    wp::array_t<wp::uint8> var_mask)
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
        wp::vec_t<3, wp::float32> var_2;
        wp::vec_t<3, wp::float32> var_3;
        const wp::int32 var_4 = 0;
        wp::int32 var_5;
        bool var_6;
        const wp::int32 var_7 = 0;
        wp::float32 var_8;
        const wp::int32 var_9 = 0;
        wp::float32 var_10;
        bool var_11;
        const wp::int32 var_12 = 1;
        wp::float32 var_13;
        const wp::int32 var_14 = 1;
        wp::float32 var_15;
        bool var_16;
        const wp::int32 var_17 = 2;
        wp::float32 var_18;
        const wp::int32 var_19 = 2;
        wp::float32 var_20;
        bool var_21;
        bool var_22;
        const wp::int32 var_23 = 0;
        wp::float32 var_24;
        const wp::int32 var_25 = 0;
        wp::float32 var_26;
        bool var_27;
        const wp::int32 var_28 = 1;
        wp::float32 var_29;
        const wp::int32 var_30 = 1;
        wp::float32 var_31;
        bool var_32;
        const wp::int32 var_33 = 2;
        wp::float32 var_34;
        const wp::int32 var_35 = 2;
        wp::float32 var_36;
        bool var_37;
        const wp::int32 var_38 = 1;
        wp::int32 var_39;
        wp::int32 var_40;
        wp::uint8 var_41;
        //---------
        // forward
        // def mask_aligned_box_kernel(points, low, high, mask):                                  <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // p = points[i]                                                                          <L 3>
        var_1 = wp::address(var_points, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // inside = int(0)                                                                        <L 4>
        var_5 = wp::int(var_4);
        // if p[0] >= low[0] and p[1] >= low[1] and (p[2] >= low[2]):                             <L 5>
        var_8 = wp::extract(var_2, var_7);
        var_10 = wp::extract(var_low, var_9);
        var_11 = (var_8 >= var_10);
        var_6 = var_11;
        if (var_6) {
            var_13 = wp::extract(var_2, var_12);
            var_15 = wp::extract(var_low, var_14);
            var_16 = (var_13 >= var_15);
            var_6 = var_6 && var_16;
        }
        if (var_6) {
            var_18 = wp::extract(var_2, var_17);
            var_20 = wp::extract(var_low, var_19);
            var_21 = (var_18 >= var_20);
            var_6 = var_6 && var_21;
        }
        if (var_6) {
            // if p[0] <= high[0] and p[1] <= high[1] and (p[2] <= high[2]):                      <L 6>
            var_24 = wp::extract(var_2, var_23);
            var_26 = wp::extract(var_high, var_25);
            var_27 = (var_24 <= var_26);
            var_22 = var_27;
            if (var_22) {
                var_29 = wp::extract(var_2, var_28);
                var_31 = wp::extract(var_high, var_30);
                var_32 = (var_29 <= var_31);
                var_22 = var_22 && var_32;
            }
            if (var_22) {
                var_34 = wp::extract(var_2, var_33);
                var_36 = wp::extract(var_high, var_35);
                var_37 = (var_34 <= var_36);
                var_22 = var_22 && var_37;
            }
            if (var_22) {
                // inside = 1                                                                     <L 7>
            }
            var_39 = wp::where(var_22, var_38, var_5);
        }
        var_40 = wp::where(var_6, var_39, var_5);
        // mask[i] = uint8(inside)                                                                <L 8>
        var_41 = wp::uint8(var_40);
        wp::array_store(var_mask, var_0, var_41);
}



extern "C" __global__ void mask_oriented_box_kernel_d79dded6_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::vec_t<3, wp::float64> var_offset,
    wp::mat_t<3, 3, wp::float64> var_axes,
    wp::vec_t<3, wp::float64> var_half,
    wp::array_t<wp::uint8> var_mask)
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
        wp::vec_t<3, wp::float64> var_5;
        const wp::int32 var_6 = 0;
        wp::int32 var_7;
        bool var_8;
        const wp::int32 var_9 = 0;
        wp::float64 var_10;
        wp::float64 var_11;
        const wp::int32 var_12 = 0;
        wp::float64 var_13;
        bool var_14;
        const wp::int32 var_15 = 1;
        wp::float64 var_16;
        wp::float64 var_17;
        const wp::int32 var_18 = 1;
        wp::float64 var_19;
        bool var_20;
        const wp::int32 var_21 = 2;
        wp::float64 var_22;
        wp::float64 var_23;
        const wp::int32 var_24 = 2;
        wp::float64 var_25;
        bool var_26;
        const wp::int32 var_27 = 1;
        wp::int32 var_28;
        wp::uint8 var_29;
        //---------
        // forward
        // def mask_oriented_box_kernel(points, offset, axes, half, mask):                        <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // q = axes @ (widen(points[i]) + offset)                                                 <L 4>
        var_1 = wp::address(var_points, var_0);
        var_3 = wp::load(var_1);
        var_2 = widen_0(var_3);
        var_4 = wp::add(var_2, var_offset);
        var_5 = wp::mul(var_axes, var_4);
        // inside = int(0)                                                                        <L 5>
        var_7 = wp::int(var_6);
        // if abs(q[0]) <= half[0] and abs(q[1]) <= half[1] and (abs(q[2]) <= half[2]):           <L 6>
        var_10 = wp::extract(var_5, var_9);
        var_11 = wp::abs(var_10);
        var_13 = wp::extract(var_half, var_12);
        var_14 = (var_11 <= var_13);
        var_8 = var_14;
        if (var_8) {
            var_16 = wp::extract(var_5, var_15);
            var_17 = wp::abs(var_16);
            var_19 = wp::extract(var_half, var_18);
            var_20 = (var_17 <= var_19);
            var_8 = var_8 && var_20;
        }
        if (var_8) {
            var_22 = wp::extract(var_5, var_21);
            var_23 = wp::abs(var_22);
            var_25 = wp::extract(var_half, var_24);
            var_26 = (var_23 <= var_25);
            var_8 = var_8 && var_26;
        }
        if (var_8) {
            // inside = 1                                                                         <L 7>
        }
        var_28 = wp::where(var_8, var_27, var_7);
        // mask[i] = uint8(inside)                                                                <L 8>
        var_29 = wp::uint8(var_28);
        wp::array_store(var_mask, var_0, var_29);
}



extern "C" __global__ void mask_usable_kernel_eaa12832_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_normals,
    wp::array_t<wp::uint8> var_mask)
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
        wp::vec_t<3, wp::float32> var_2;
        wp::vec_t<3, wp::float32> var_3;
        wp::vec_t<3, wp::float32>* var_4;
        wp::vec_t<3, wp::float32> var_5;
        wp::vec_t<3, wp::float32> var_6;
        const wp::int32 var_7 = 0;
        wp::int32 var_8;
        bool var_9;
        bool var_10;
        bool var_11;
        const wp::int32 var_12 = 1;
        wp::int32 var_13;
        wp::uint8 var_14;
        //---------
        // forward
        // def mask_usable_kernel(points, normals, mask):                                         <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // p = points[i]                                                                          <L 3>
        var_1 = wp::address(var_points, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // n = normals[i]                                                                         <L 4>
        var_4 = wp::address(var_normals, var_0);
        var_6 = wp::load(var_4);
        var_5 = wp::copy(var_6);
        // usable = int(0)                                                                        <L 5>
        var_8 = wp::int(var_7);
        // if isfinite(p) and isfinite(n):                                                        <L 6>
        var_10 = wp::isfinite(var_2);
        var_9 = var_10;
        if (var_9) {
            var_11 = wp::isfinite(var_5);
            var_9 = var_9 && var_11;
        }
        if (var_9) {
            // usable = 1                                                                         <L 7>
        }
        var_13 = wp::where(var_9, var_12, var_8);
        // mask[i] = uint8(usable)                                                                <L 8>
        var_14 = wp::uint8(var_13);
        wp::array_store(var_mask, var_0, var_14);
}


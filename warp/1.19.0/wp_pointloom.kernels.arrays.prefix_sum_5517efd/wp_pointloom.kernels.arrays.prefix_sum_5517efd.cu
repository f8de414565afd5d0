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


// <pointloom.kernels.arrays.prefix_sum.sum_of_run>:1
static CUDA_CALLABLE wp::int64 sum_of_run_0(
    wp::int32 var_i,
    wp::array_t<wp::int32> var_counts,
    wp::int32 var_runs__count,
    wp::int32 var_runs__length,
    wp::int32 var_runs__stride,
    wp::int32 var_runs__step)
{
    //---------
    // primal vars
    wp::int64 var_0;
    wp::int32 var_1;
    const wp::int32 var_2 = 1;
    wp::int32 var_3;
    wp::int32 var_4;
    wp::int32 var_5;
    const wp::int32 var_6 = 1;
    wp::int32 var_7;
    wp::int32 var_8;
    wp::range_t var_9;
    wp::int32 var_10;
    wp::int32 var_11;
    wp::int32 var_12;
    wp::int32* var_13;
    wp::int64 var_14;
    wp::int32 var_15;
    wp::int64 var_16;
    //---------
    // forward
    // def sum_of_run(i, counts, runs__count, runs__length, runs__stride, runs__step):        <L 1>
    // part = int64(0)                                                                        <L 2>
    var_0 = 0ll;
    // first__elements_of__1 = i * runs__stride                                               <L 3>
    var_1 = wp::mul(var_i, var_runs__stride);
    // for k__elements_of__1 in range(min(runs__length, (runs__count - 1 - first__elements_of__1) // runs__step + 1)):       <L 4>
    var_3 = wp::sub(var_runs__count, var_2);
    var_4 = wp::sub(var_3, var_1);
    var_5 = wp::floordiv(var_4, var_runs__step);
    var_7 = wp::add(var_5, var_6);
    var_8 = wp::min(var_runs__length, var_7);
    var_9 = wp::range(var_8);
    start_for_0:;
        if (iter_cmp(var_9) == 0) goto end_for_0;
        var_10 = wp::iter_next(var_9);
        // j = first__elements_of__1 + k__elements_of__1 * runs__step                         <L 5>
        var_11 = wp::mul(var_10, var_runs__step);
        var_12 = wp::add(var_1, var_11);
        // part += int64(counts[j])                                                           <L 6>
        var_13 = wp::address(var_counts, var_12);
        var_15 = wp::load(var_13);
        var_14 = wp::int64(var_15);
        var_16 = wp::add(var_0, var_14);
        wp::assign(var_0, var_16);
        goto start_for_0;
    end_for_0:;
    // return part                                                                            <L 7>
    return var_0;
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


// <pointloom.kernels.arrays.prefix_sum.sum_of_run>:1
static CUDA_CALLABLE void adj_sum_of_run_0(
    wp::int32 var_i,
    wp::array_t<wp::int32> var_counts,
    wp::int32 var_runs__count,
    wp::int32 var_runs__length,
    wp::int32 var_runs__stride,
    wp::int32 var_runs__step,
    wp::int32 & adj_i,
    wp::array_t<wp::int32> & adj_counts,
    wp::int32 & adj_runs__count,
    wp::int32 & adj_runs__length,
    wp::int32 & adj_runs__stride,
    wp::int32 & adj_runs__step,
    wp::int64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void copy_middle_kernel_a40a30b3_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_offsets,
    wp::int32 var_slot,
    wp::array_t<wp::int64> var_totals)
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
        const wp::int32 var_5 = 2;
        wp::int32 var_6;
        wp::int32* var_7;
        wp::int64 var_8;
        wp::int32 var_9;
        wp::int32 var_10;
        //---------
        // forward
        // def copy_middle_kernel(offsets: array(dtype=int32), slot: int, totals: array(dtype=int64)):       <L 65>
        // i = tid()                                                                              <L 67>
        var_0 = builtin_tid1d();
        // totals[slot + i] = int64(offsets[offsets.shape[0] // 2])                               <L 68>
        var_1 = &(var_offsets.shape);
        var_4 = wp::load(var_1);
        var_3 = wp::extract(var_4, var_2);
        var_6 = wp::floordiv(var_3, var_5);
        var_7 = wp::address(var_offsets, var_6);
        var_9 = wp::load(var_7);
        var_8 = wp::int64(var_9);
        var_10 = wp::add(var_slot, var_0);
        wp::array_store(var_totals, var_10, var_8);
}



extern "C" __global__ void note_offsets_kernel_d0f1d0db_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_offsets,
    wp::array_t<wp::int32> var_indices,
    wp::array_t<wp::int64> var_copied)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::int32* var_1;
        wp::int32 var_2;
        wp::int32* var_3;
        wp::int64 var_4;
        wp::int32 var_5;
        //---------
        // forward
        // def note_offsets_kernel(offsets: array(dtype=int32), indices: array(dtype=int32), copied: array(dtype=int64)):       <L 58>
        // i = tid()                                                                              <L 60>
        var_0 = builtin_tid1d();
        // copied[i] = int64(offsets[indices[i]])                                                 <L 61>
        var_1 = wp::address(var_indices, var_0);
        var_2 = wp::load(var_1);
        var_3 = wp::address(var_offsets, var_2);
        var_5 = wp::load(var_3);
        var_4 = wp::int64(var_5);
        wp::array_store(var_copied, var_0, var_4);
}



extern "C" __global__ void start_offsets_kernel_dc7e0e79_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_counts,
    wp::int32 var_runs__rows,
    wp::int32 var_runs__count,
    wp::int32 var_runs__length,
    wp::int32 var_runs__stride,
    wp::int32 var_runs__step,
    wp::array_t<wp::int64> var_totals,
    wp::array_t<wp::int32> var_offsets)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        const wp::int32 var_1 = 0;
        bool var_2;
        const wp::int32 var_3 = 0;
        const wp::int32 var_4 = 0;
        wp::int32 var_5;
        wp::int64 var_6;
        wp::int64 var_7;
        //---------
        // forward
        // def start_offsets_kernel(counts, runs__rows, runs__count, runs__length, runs__stride, runs__step, totals, offsets):       <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // if i == 0:                                                                             <L 3>
        var_2 = (var_0 == var_1);
        if (var_2) {
            // offsets[0] = 0                                                                     <L 4>
            wp::array_store(var_offsets, var_4, var_3);
        }
        // atomic_add(totals, row_of(i, runs__rows), sum_of_run(i, counts, runs__count, runs__length, runs__stride, runs__step))       <L 5>
        var_5 = row_of_0(var_0, var_runs__rows);
        var_6 = sum_of_run_0(var_0, var_counts, var_runs__count, var_runs__length, var_runs__stride, var_runs__step);
        var_7 = wp::atomic_add(var_totals, var_5, var_6);
}



extern "C" __global__ void sum_counts_kernel_f0711661_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_counts,
    wp::int32 var_runs__rows,
    wp::int32 var_runs__count,
    wp::int32 var_runs__length,
    wp::int32 var_runs__stride,
    wp::int32 var_runs__step,
    wp::array_t<wp::int64> var_totals)
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
        wp::int64 var_2;
        wp::int64 var_3;
        //---------
        // forward
        // def sum_counts_kernel(counts, runs__rows, runs__count, runs__length, runs__stride, runs__step, totals):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // atomic_add(totals, row_of(i, runs__rows), sum_of_run(i, counts, runs__count, runs__length, runs__stride, runs__step))       <L 4>
        var_1 = row_of_0(var_0, var_runs__rows);
        var_2 = sum_of_run_0(var_0, var_counts, var_runs__count, var_runs__length, var_runs__stride, var_runs__step);
        var_3 = wp::atomic_add(var_totals, var_1, var_2);
}


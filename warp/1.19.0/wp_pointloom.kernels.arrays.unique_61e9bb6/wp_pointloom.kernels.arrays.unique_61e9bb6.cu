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



extern "C" __global__ void count_runs_kernel_3bf57e95_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_starts,
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
        const wp::int32 var_1 = 1;
        wp::int32 var_2;
        wp::int32* var_3;
        wp::int32* var_4;
        wp::int32 var_5;
        wp::int32 var_6;
        wp::int32 var_7;
        //---------
        // forward
        // def count_runs_kernel(starts: array(dtype=int32), counts: array(dtype=int32)):         <L 58>
        // i = tid()                                                                              <L 59>
        var_0 = builtin_tid1d();
        // counts[i] = starts[i + 1] - starts[i]                                                  <L 60>
        var_2 = wp::add(var_0, var_1);
        var_3 = wp::address(var_starts, var_2);
        var_4 = wp::address(var_starts, var_0);
        var_6 = wp::load(var_3);
        var_7 = wp::load(var_4);
        var_5 = wp::sub(var_6, var_7);
        wp::array_store(var_counts, var_0, var_5);
}



extern "C" __global__ void write_heads_kernel_c04cf4f4_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int64> var_sorted_keys,
    wp::array_t<wp::int32> var_ranks,
    wp::array_t<wp::int64> var_keys,
    wp::array_t<wp::int32> var_starts)
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
        wp::int32 var_2;
        const wp::int32 var_3 = 0;
        bool var_4;
        const wp::int32 var_5 = 1;
        wp::int32 var_6;
        wp::int32* var_7;
        wp::int32 var_8;
        wp::int32 var_9;
        wp::int32 var_10;
        wp::int32* var_11;
        bool var_12;
        wp::int32 var_13;
        wp::int64* var_14;
        wp::int64 var_15;
        wp::int64 var_16;
        wp::shape_t* var_17;
        const wp::int32 var_18 = 0;
        wp::int32 var_19;
        wp::shape_t var_20;
        const wp::int32 var_21 = 1;
        wp::int32 var_22;
        bool var_23;
        const wp::int32 var_24 = 1;
        wp::int32 var_25;
        wp::int32* var_26;
        wp::int32 var_27;
        //---------
        // forward
        // def write_heads_kernel(sorted_keys, ranks, keys, starts):                              <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // before = int(0)                                                                        <L 4>
        var_2 = wp::int(var_1);
        // if i > 0:                                                                              <L 5>
        var_4 = (var_0 > var_3);
        if (var_4) {
            // before = ranks[i - 1]                                                              <L 6>
            var_6 = wp::sub(var_0, var_5);
            var_7 = wp::address(var_ranks, var_6);
            var_9 = wp::load(var_7);
            var_8 = wp::copy(var_9);
        }
        var_10 = wp::where(var_4, var_8, var_2);
        // if ranks[i] > before:                                                                  <L 7>
        var_11 = wp::address(var_ranks, var_0);
        var_13 = wp::load(var_11);
        var_12 = (var_13 > var_10);
        if (var_12) {
            // keys[before] = sorted_keys[i]                                                      <L 8>
            var_14 = wp::address(var_sorted_keys, var_0);
            var_16 = wp::load(var_14);
            var_15 = wp::copy(var_16);
            wp::array_store(var_keys, var_10, var_15);
            // starts[before] = i                                                                 <L 9>
            wp::array_store(var_starts, var_10, var_0);
        }
        // if i == sorted_keys.shape[0] - 1:                                                      <L 10>
        var_17 = &(var_sorted_keys.shape);
        var_20 = wp::load(var_17);
        var_19 = wp::extract(var_20, var_18);
        var_22 = wp::sub(var_19, var_21);
        var_23 = (var_0 == var_22);
        if (var_23) {
            // starts[ranks[i]] = i + 1                                                           <L 11>
            var_25 = wp::add(var_0, var_24);
            var_26 = wp::address(var_ranks, var_0);
            var_27 = wp::load(var_26);
            wp::array_store(var_starts, var_27, var_25);
        }
}



extern "C" __global__ void mark_heads_kernel_f5532c2a_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int64> var_keys,
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
        const wp::int32 var_1 = 1;
        wp::int32 var_2;
        const wp::int32 var_3 = 0;
        bool var_4;
        wp::int64* var_5;
        const wp::int32 var_6 = 1;
        wp::int32 var_7;
        wp::int64* var_8;
        bool var_9;
        wp::int64 var_10;
        wp::int64 var_11;
        const wp::int32 var_12 = 0;
        wp::int32 var_13;
        wp::int32 var_14;
        wp::shape_t* var_15;
        const wp::int32 var_16 = 0;
        wp::int32 var_17;
        wp::shape_t var_18;
        const wp::int32 var_19 = 1;
        wp::int32 var_20;
        bool var_21;
        wp::int64* var_22;
        wp::int32 var_23;
        wp::int64 var_24;
        const wp::int32 var_25 = 1;
        wp::int32 var_26;
        wp::int64* var_27;
        wp::int64 var_28;
        wp::int64 var_29;
        wp::int64 var_30;
        wp::int32 var_31;
        const wp::int32 var_32 = 2;
        wp::int32 var_33;
        //---------
        // forward
        // def mark_heads_kernel(keys, ranks):                                                    <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // first = int(1)                                                                         <L 4>
        var_2 = wp::int(var_1);
        // if i > 0:                                                                              <L 5>
        var_4 = (var_0 > var_3);
        if (var_4) {
            // if keys[i] == keys[i - 1]:                                                         <L 6>
            var_5 = wp::address(var_keys, var_0);
            var_7 = wp::sub(var_0, var_6);
            var_8 = wp::address(var_keys, var_7);
            var_10 = wp::load(var_5);
            var_11 = wp::load(var_8);
            var_9 = (var_10 == var_11);
            if (var_9) {
                // first = 0                                                                      <L 7>
            }
            var_13 = wp::where(var_9, var_12, var_2);
        }
        var_14 = wp::where(var_4, var_13, var_2);
        // ranks[i] = first                                                                       <L 8>
        wp::array_store(var_ranks, var_0, var_14);
        // if i == keys.shape[0] - 1:                                                             <L 9>
        var_15 = &(var_keys.shape);
        var_18 = wp::load(var_15);
        var_17 = wp::extract(var_18, var_16);
        var_20 = wp::sub(var_17, var_19);
        var_21 = (var_0 == var_20);
        if (var_21) {
            // ranks[i + 1] = int(keys[i])                                                        <L 10>
            var_22 = wp::address(var_keys, var_0);
            var_24 = wp::load(var_22);
            var_23 = wp::int(var_24);
            var_26 = wp::add(var_0, var_25);
            wp::array_store(var_ranks, var_26, var_23);
            // ranks[i + 2] = int(keys[i] >> int64(32))                                           <L 11>
            var_27 = wp::address(var_keys, var_0);
            var_28 = 32ll;
            var_30 = wp::load(var_27);
            var_29 = wp::rshift(var_30, var_28);
            var_31 = wp::int(var_29);
            var_33 = wp::add(var_0, var_32);
            wp::array_store(var_ranks, var_33, var_31);
        }
}


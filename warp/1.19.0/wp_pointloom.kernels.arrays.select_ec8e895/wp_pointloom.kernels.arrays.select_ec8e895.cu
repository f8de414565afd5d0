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



extern "C" __global__ void copy_last_kernel_23ef6053_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_ranks,
    wp::int32 var_slot,
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
        wp::int32 var_10;
        //---------
        // forward
        // def copy_last_kernel(ranks: array(dtype=int32), slot: int, counts: array(dtype=int32)):       <L 82>
        // i = tid()                                                                              <L 83>
        var_0 = builtin_tid1d();
        // counts[slot + i] = ranks[ranks.shape[0] - 1]                                           <L 84>
        var_1 = &(var_ranks.shape);
        var_4 = wp::load(var_1);
        var_3 = wp::extract(var_4, var_2);
        var_6 = wp::sub(var_3, var_5);
        var_7 = wp::address(var_ranks, var_6);
        var_9 = wp::load(var_7);
        var_8 = wp::copy(var_9);
        var_10 = wp::add(var_slot, var_0);
        wp::array_store(var_counts, var_10, var_8);
}



extern "C" __global__ void gather_counts_kernel_771d4c5f_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_ranks,
    wp::array_t<wp::int32> var_firsts,
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
        const wp::int32 var_1 = 0;
        wp::int32 var_2;
        wp::int32* var_3;
        const wp::int32 var_4 = 0;
        bool var_5;
        wp::int32 var_6;
        wp::int32* var_7;
        const wp::int32 var_8 = 1;
        wp::int32 var_9;
        wp::int32 var_10;
        wp::int32* var_11;
        wp::int32 var_12;
        wp::int32 var_13;
        wp::int32 var_14;
        //---------
        // forward
        // def gather_counts_kernel(ranks, firsts, counts):                                       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // count = int(0)                                                                         <L 4>
        var_2 = wp::int(var_1);
        // if firsts[i] > 0:                                                                      <L 5>
        var_3 = wp::address(var_firsts, var_0);
        var_6 = wp::load(var_3);
        var_5 = (var_6 > var_4);
        if (var_5) {
            // count = ranks[firsts[i] - 1]                                                       <L 6>
            var_7 = wp::address(var_firsts, var_0);
            var_10 = wp::load(var_7);
            var_9 = wp::sub(var_10, var_8);
            var_11 = wp::address(var_ranks, var_9);
            var_13 = wp::load(var_11);
            var_12 = wp::copy(var_13);
        }
        var_14 = wp::where(var_5, var_12, var_2);
        // counts[i] = count                                                                      <L 7>
        wp::array_store(var_counts, var_0, var_14);
}



extern "C" __global__ void invert_mask_kernel_8948133e_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::uint8> var_mask,
    wp::array_t<wp::uint8> var_inverted)
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
        wp::uint8* var_3;
        const wp::int32 var_4 = 0;
        wp::uint8 var_5;
        bool var_6;
        wp::uint8 var_7;
        const wp::int32 var_8 = 1;
        wp::int32 var_9;
        wp::uint8 var_10;
        //---------
        // forward
        // def invert_mask_kernel(mask, inverted):                                                <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // value = int(0)                                                                         <L 3>
        var_2 = wp::int(var_1);
        // if mask[i] == uint8(0):                                                                <L 4>
        var_3 = wp::address(var_mask, var_0);
        var_5 = wp::uint8(var_4);
        var_7 = wp::load(var_3);
        var_6 = (var_7 == var_5);
        if (var_6) {
            // value = 1                                                                          <L 5>
        }
        var_9 = wp::where(var_6, var_8, var_2);
        // inverted[i] = uint8(value)                                                             <L 6>
        var_10 = wp::uint8(var_9);
        wp::array_store(var_inverted, var_0, var_10);
}



extern "C" __global__ void number_rows_kernel_a9b341fb_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_rows,
    wp::array_t<wp::int32> var_numbers)
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
        //---------
        // forward
        // def number_rows_kernel(rows: array(dtype=int32), numbers: array(dtype=int32)):         <L 33>
        // i = tid()                                                                              <L 35>
        var_0 = builtin_tid1d();
        // numbers[rows[i]] = i                                                                   <L 36>
        var_1 = wp::address(var_rows, var_0);
        var_2 = wp::load(var_1);
        wp::array_store(var_numbers, var_2, var_0);
}



extern "C" __global__ void scatter_positions_kernel_be59ef07_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::uint8> var_mask,
    wp::array_t<wp::int32> var_ranks,
    wp::array_t<wp::int32> var_positions)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::uint8* var_1;
        const wp::int32 var_2 = 0;
        wp::uint8 var_3;
        bool var_4;
        wp::uint8 var_5;
        wp::int32* var_6;
        const wp::int32 var_7 = 1;
        wp::int32 var_8;
        wp::int32 var_9;
        //---------
        // forward
        // def scatter_positions_kernel(mask, ranks, positions):                                  <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // if mask[i] != uint8(0):                                                                <L 4>
        var_1 = wp::address(var_mask, var_0);
        var_3 = wp::uint8(var_2);
        var_5 = wp::load(var_1);
        var_4 = (var_5 != var_3);
        if (var_4) {
            // positions[ranks[i] - 1] = i                                                        <L 5>
            var_6 = wp::address(var_ranks, var_0);
            var_9 = wp::load(var_6);
            var_8 = wp::sub(var_9, var_7);
            wp::array_store(var_positions, var_8, var_0);
        }
}



extern "C" __global__ void gather_vec3_kernel_be8b9f79_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_values,
    wp::array_t<wp::int32> var_rows,
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
        wp::int32* var_1;
        wp::int32 var_2;
        wp::vec_t<3, wp::float32>* var_3;
        wp::vec_t<3, wp::float32> var_4;
        wp::vec_t<3, wp::float32> var_5;
        //---------
        // forward
        // def gather_vec3_kernel(values: array(dtype=vec3), rows: array(dtype=int32), out: array(dtype=vec3)):       <L 40>
        // i = tid()                                                                              <L 41>
        var_0 = builtin_tid1d();
        // out[i] = values[rows[i]]                                                               <L 42>
        var_1 = wp::address(var_rows, var_0);
        var_2 = wp::load(var_1);
        var_3 = wp::address(var_values, var_2);
        var_5 = wp::load(var_3);
        var_4 = wp::copy(var_5);
        wp::array_store(var_out, var_0, var_4);
}



extern "C" __global__ void count_mask_kernel_fbc5fc9a_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::uint8> var_mask,
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
        const wp::int32 var_1 = 0;
        wp::int32 var_2;
        wp::uint8* var_3;
        const wp::int32 var_4 = 0;
        wp::uint8 var_5;
        bool var_6;
        wp::uint8 var_7;
        const wp::int32 var_8 = 1;
        wp::int32 var_9;
        //---------
        // forward
        // def count_mask_kernel(mask, counts):                                                   <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // selected = int(0)                                                                      <L 3>
        var_2 = wp::int(var_1);
        // if mask[i] != uint8(0):                                                                <L 4>
        var_3 = wp::address(var_mask, var_0);
        var_5 = wp::uint8(var_4);
        var_7 = wp::load(var_3);
        var_6 = (var_7 != var_5);
        if (var_6) {
            // selected = 1                                                                       <L 5>
        }
        var_9 = wp::where(var_6, var_8, var_2);
        // counts[i] = selected                                                                   <L 6>
        wp::array_store(var_counts, var_0, var_9);
}


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


// <pointloom.kernels.arrays.packed_keys.key_bits>:1
static CUDA_CALLABLE wp::int32 key_bits_0(
    wp::int64 var_key)
{
    //---------
    // primal vars
    wp::int64 var_0;
    wp::int64 var_1;
    wp::int32 var_2;
    //---------
    // forward
    // def key_bits(key):                                                                     <L 1>
    // return int(key >> int64(32))                                                           <L 2>
    var_0 = 32ll;
    var_1 = wp::rshift(var_key, var_0);
    var_2 = wp::int(var_1);
    return var_2;
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:148
static CUDA_CALLABLE wp::float32 _bits_float_0(
    wp::int32 var_i)
{
    //---------
    // primal vars
    wp::float32 var_0;
    //---------
    // forward
    // def _bits_float(i: wp.int32):                                                          <L 149>
    // return wp.cast(i, wp.float32)                                                          <L 150>
    var_0 = wp::cast<wp::float32>(var_i);
    return var_0;
}


// /work/main/src/pointloom/kernels/arrays/packed_keys.py:28
static CUDA_CALLABLE wp::float32 key_number_0(
    wp::int64 var_key)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::float32 var_1;
    //---------
    // forward
    // def key_number(key: int64) -> float:                                                   <L 29>
    // return bits_float(key_bits(key))                                                       <L 30>
    var_0 = key_bits_0(var_key);
    var_1 = _bits_float_0(var_0);
    return var_1;
}


// <pointloom.kernels.arrays.packed_keys.key_bits>:1
static CUDA_CALLABLE void adj_key_bits_0(
    wp::int64 var_key,
    wp::int64 & adj_key,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:148
static CUDA_CALLABLE void adj__bits_float_0(
    wp::int32 var_i,
    wp::int32 & adj_i,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/arrays/packed_keys.py:28
static CUDA_CALLABLE void adj_key_number_0(
    wp::int64 var_key,
    wp::int64 & adj_key,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void mask_up_to_kernel_14a24b9e_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float64> var_values,
    wp::float64 var_threshold,
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
        const wp::int32 var_1 = 0;
        wp::int32 var_2;
        wp::float64* var_3;
        bool var_4;
        wp::float64 var_5;
        const wp::int32 var_6 = 1;
        wp::int32 var_7;
        wp::uint8 var_8;
        //---------
        // forward
        // def mask_up_to_kernel(values, threshold, mask):                                        <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // is_selected = int(0)                                                                   <L 4>
        var_2 = wp::int(var_1);
        // if values[i] <= threshold:                                                             <L 5>
        var_3 = wp::address(var_values, var_0);
        var_5 = wp::load(var_3);
        var_4 = (var_5 <= var_threshold);
        if (var_4) {
            // is_selected = 1                                                                    <L 6>
        }
        var_7 = wp::where(var_4, var_6, var_2);
        // mask[i] = uint8(is_selected)                                                           <L 7>
        var_8 = wp::uint8(var_7);
        wp::array_store(var_mask, var_0, var_8);
}



extern "C" __global__ void root_distances_kernel_755331fb_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int64> var_nearest,
    wp::array_t<wp::vec_t<3, wp::float32>> var_queries,
    wp::float32 var_missing,
    wp::array_t<wp::float64> var_distances)
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
        wp::float64 var_4;
        wp::int64* var_5;
        wp::int64 var_6;
        bool var_7;
        wp::int64 var_8;
        wp::int64* var_9;
        wp::float32 var_10;
        wp::int64 var_11;
        wp::float64 var_12;
        wp::float64 var_13;
        wp::float64 var_14;
        bool var_15;
        bool var_16;
        const wp::float32 var_17 = NAN;
        wp::float64 var_18;
        wp::float64 var_19;
        //---------
        // forward
        // def root_distances_kernel(nearest, queries, missing, distances):                       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // q = queries[i]                                                                         <L 4>
        var_1 = wp::address(var_queries, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // distance = float64(missing)                                                            <L 5>
        var_4 = wp::float64(var_missing);
        // if nearest[i] >= int64(0):                                                             <L 6>
        var_5 = wp::address(var_nearest, var_0);
        var_6 = 0ll;
        var_8 = wp::load(var_5);
        var_7 = (var_8 >= var_6);
        if (var_7) {
            // distance = sqrt(float64(key_number(nearest[i])))                                   <L 7>
            var_9 = wp::address(var_nearest, var_0);
            var_11 = wp::load(var_9);
            var_10 = key_number_0(var_11);
            var_12 = wp::float64(var_10);
            var_13 = wp::sqrt(var_12);
        }
        var_14 = wp::where(var_7, var_13, var_4);
        // if not isfinite(q):                                                                    <L 8>
        var_15 = wp::isfinite(var_2);
        var_16 = wp::unot(var_15);
        if (var_16) {
            // distance = float64(NAN)                                                            <L 9>
            var_18 = wp::float64(var_17);
        }
        var_19 = wp::where(var_16, var_18, var_14);
        // distances[i] = distance                                                                <L 10>
        wp::array_store(var_distances, var_0, var_19);
}


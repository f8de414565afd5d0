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



extern "C" __global__ void pack_level_kernel_9f545e03_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_levels__depth,
    wp::array_t<wp::vec_t<4, wp::float32>> var_levels__planes,
    wp::int32 var_first,
    wp::array_t<wp::float32> var_rows)
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
        wp::float32* var_2;
        wp::float32 var_3;
        wp::float32 var_4;
        const wp::int32 var_5 = 0;
        const wp::int32 var_6 = 0;
        wp::int32 var_7;
        wp::vec_t<4, wp::float32>* var_8;
        wp::float32 var_9;
        wp::vec_t<4, wp::float32> var_10;
        const wp::int32 var_11 = 1;
        wp::int32 var_12;
        const wp::int32 var_13 = 1;
        wp::int32 var_14;
        wp::vec_t<4, wp::float32>* var_15;
        wp::float32 var_16;
        wp::vec_t<4, wp::float32> var_17;
        const wp::int32 var_18 = 1;
        wp::int32 var_19;
        const wp::int32 var_20 = 2;
        wp::int32 var_21;
        wp::vec_t<4, wp::float32>* var_22;
        wp::float32 var_23;
        wp::vec_t<4, wp::float32> var_24;
        const wp::int32 var_25 = 1;
        wp::int32 var_26;
        const wp::int32 var_27 = 3;
        wp::int32 var_28;
        wp::vec_t<4, wp::float32>* var_29;
        wp::float32 var_30;
        wp::vec_t<4, wp::float32> var_31;
        const wp::int32 var_32 = 1;
        wp::int32 var_33;
        //---------
        // forward
        // def pack_level_kernel(levels__depth, levels__planes, first, rows):                     <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // rows[i, 0] = levels__depth[first + i]                                                  <L 3>
        var_1 = wp::add(var_first, var_0);
        var_2 = wp::address(var_levels__depth, var_1);
        var_4 = wp::load(var_2);
        var_3 = wp::copy(var_4);
        wp::array_store(var_rows, var_0, var_5, var_3);
        // for k in range(4):                                                                     <L 4>
        // rows[i, 1 + k] = levels__planes[first + i][k]                                          <L 5>
        var_7 = wp::add(var_first, var_0);
        var_8 = wp::address(var_levels__planes, var_7);
        var_10 = wp::load(var_8);
        var_9 = wp::extract(var_10, var_6);
        var_12 = wp::add(var_11, var_6);
        wp::array_store(var_rows, var_0, var_12, var_9);
        var_14 = wp::add(var_first, var_0);
        var_15 = wp::address(var_levels__planes, var_14);
        var_17 = wp::load(var_15);
        var_16 = wp::extract(var_17, var_13);
        var_19 = wp::add(var_18, var_13);
        wp::array_store(var_rows, var_0, var_19, var_16);
        var_21 = wp::add(var_first, var_0);
        var_22 = wp::address(var_levels__planes, var_21);
        var_24 = wp::load(var_22);
        var_23 = wp::extract(var_24, var_20);
        var_26 = wp::add(var_25, var_20);
        wp::array_store(var_rows, var_0, var_26, var_23);
        var_28 = wp::add(var_first, var_0);
        var_29 = wp::address(var_levels__planes, var_28);
        var_31 = wp::load(var_29);
        var_30 = wp::extract(var_31, var_27);
        var_33 = wp::add(var_32, var_27);
        wp::array_store(var_rows, var_0, var_33, var_30);
}



extern "C" __global__ void copy_levels_kernel_be306aa3_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<4, wp::float32>> var_levels__lenses,
    wp::array_t<wp::float32> var_levels__depth,
    wp::array_t<wp::float32> var_levels__brightness,
    wp::array_t<wp::vec_t<4, wp::float32>> var_levels__planes,
    wp::array_t<wp::vec_t<4, wp::float32>> var_out__lenses,
    wp::array_t<wp::float32> var_out__depth,
    wp::array_t<wp::float32> var_out__brightness,
    wp::array_t<wp::vec_t<4, wp::float32>> var_out__planes)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::float32* var_1;
        wp::float32 var_2;
        wp::float32 var_3;
        wp::float32* var_4;
        wp::float32 var_5;
        wp::float32 var_6;
        wp::vec_t<4, wp::float32>* var_7;
        wp::vec_t<4, wp::float32> var_8;
        wp::vec_t<4, wp::float32> var_9;
        wp::shape_t* var_10;
        const wp::int32 var_11 = 0;
        wp::int32 var_12;
        wp::shape_t var_13;
        bool var_14;
        wp::vec_t<4, wp::float32>* var_15;
        wp::vec_t<4, wp::float32> var_16;
        wp::vec_t<4, wp::float32> var_17;
        //---------
        // forward
        // def copy_levels_kernel(levels__lenses, levels__depth, levels__brightness, levels__planes, out__lenses, out__depth, out__brightness, out__planes):       <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // out__depth[i] = levels__depth[i]                                                       <L 3>
        var_1 = wp::address(var_levels__depth, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        wp::array_store(var_out__depth, var_0, var_2);
        // out__brightness[i] = levels__brightness[i]                                             <L 4>
        var_4 = wp::address(var_levels__brightness, var_0);
        var_6 = wp::load(var_4);
        var_5 = wp::copy(var_6);
        wp::array_store(var_out__brightness, var_0, var_5);
        // out__planes[i] = levels__planes[i]                                                     <L 5>
        var_7 = wp::address(var_levels__planes, var_0);
        var_9 = wp::load(var_7);
        var_8 = wp::copy(var_9);
        wp::array_store(var_out__planes, var_0, var_8);
        // if i < levels__lenses.shape[0]:                                                        <L 6>
        var_10 = &(var_levels__lenses.shape);
        var_13 = wp::load(var_10);
        var_12 = wp::extract(var_13, var_11);
        var_14 = (var_0 < var_12);
        if (var_14) {
            // out__lenses[i] = levels__lenses[i]                                                 <L 7>
            var_15 = wp::address(var_levels__lenses, var_0);
            var_17 = wp::load(var_15);
            var_16 = wp::copy(var_17);
            wp::array_store(var_out__lenses, var_0, var_16);
        }
}


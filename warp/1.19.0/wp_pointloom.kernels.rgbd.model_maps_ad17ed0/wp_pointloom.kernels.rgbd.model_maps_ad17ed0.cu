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


// /work/main/src/pointloom/kernels/rgbd/model_maps.py:24
static CUDA_CALLABLE wp::int32 round_half_even_0(
    wp::float32 var_x)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 0.5;
    wp::float32 var_1;
    wp::float32 var_2;
    wp::int32 var_3;
    bool var_4;
    wp::float32 var_5;
    const wp::float32 var_6 = 0.5;
    bool var_7;
    const wp::int32 var_8 = 2;
    wp::int32 var_9;
    const wp::int32 var_10 = 1;
    bool var_11;
    const wp::int32 var_12 = 1;
    wp::int32 var_13;
    wp::int32 var_14;
    //---------
    // forward
    // def round_half_even(x: float) -> int:                                                  <L 25>
    // up = floor(x + 0.5)                                                                    <L 27>
    var_1 = wp::add(var_x, var_0);
    var_2 = wp::floor(var_1);
    // nearest = int(up)                                                                      <L 28>
    var_3 = wp::int(var_2);
    // if up - x == 0.5 and nearest % 2 == 1:                                                 <L 29>
    var_5 = wp::sub(var_2, var_x);
    var_7 = (var_5 == var_6);
    var_4 = var_7;
    if (var_4) {
        var_9 = wp::mod(var_3, var_8);
        var_11 = (var_9 == var_10);
        var_4 = var_4 && var_11;
    }
    if (var_4) {
        // nearest = nearest - 1                                                              <L 30>
        var_13 = wp::sub(var_3, var_12);
    }
    var_14 = wp::where(var_4, var_13, var_3);
    // return nearest                                                                         <L 31>
    return var_14;
}


// /work/main/src/pointloom/kernels/rgbd/model_maps.py:24
static CUDA_CALLABLE void adj_round_half_even_0(
    wp::float32 var_x,
    wp::float32 & adj_x,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void write_colors_kernel_169daded_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_depth,
    wp::array_t<wp::vec_t<3, wp::float32>> var_colors,
    wp::array_t<wp::uint8> var_pixels)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        const wp::float32 var_1 = 0.5;
        wp::vec_t<3, wp::float32> var_2;
        wp::float32* var_3;
        const wp::float32 var_4 = 0.0;
        bool var_5;
        wp::float32 var_6;
        wp::vec_t<3, wp::float32>* var_7;
        wp::vec_t<3, wp::float32> var_8;
        wp::vec_t<3, wp::float32> var_9;
        wp::vec_t<3, wp::float32> var_10;
        const wp::int32 var_11 = 0;
        const wp::float32 var_12 = 255.0;
        wp::float32 var_13;
        wp::float32 var_14;
        wp::int32 var_15;
        wp::uint8 var_16;
        const wp::int32 var_17 = 1;
        const wp::float32 var_18 = 255.0;
        wp::float32 var_19;
        wp::float32 var_20;
        wp::int32 var_21;
        wp::uint8 var_22;
        const wp::int32 var_23 = 2;
        const wp::float32 var_24 = 255.0;
        wp::float32 var_25;
        wp::float32 var_26;
        wp::int32 var_27;
        wp::uint8 var_28;
        //---------
        // forward
        // def write_colors_kernel(depth: array(dtype=float32), colors: array(dtype=vec3), pixels: array(dtype=uint8, ndim=2)):       <L 35>
        // i = tid()                                                                              <L 36>
        var_0 = builtin_tid1d();
        // color = vec3(GRAY, GRAY, GRAY)                                                         <L 37>
        var_2 = wp::vec_t<3, wp::float32>(var_1, var_1, var_1);
        // if depth[i] > 0.0:                                                                     <L 38>
        var_3 = wp::address(var_depth, var_0);
        var_6 = wp::load(var_3);
        var_5 = (var_6 > var_4);
        if (var_5) {
            // color = colors[i]                                                                  <L 39>
            var_7 = wp::address(var_colors, var_0);
            var_9 = wp::load(var_7);
            var_8 = wp::copy(var_9);
        }
        var_10 = wp::where(var_5, var_8, var_2);
        // for k in range(3):                                                                     <L 40>
        // pixels[i, k] = uint8(round_half_even(255.0 * color[k]))                                <L 41>
        var_13 = wp::extract(var_10, var_11);
        var_14 = wp::mul(var_12, var_13);
        var_15 = round_half_even_0(var_14);
        var_16 = wp::uint8(var_15);
        wp::array_store(var_pixels, var_0, var_11, var_16);
        var_19 = wp::extract(var_10, var_17);
        var_20 = wp::mul(var_18, var_19);
        var_21 = round_half_even_0(var_20);
        var_22 = wp::uint8(var_21);
        wp::array_store(var_pixels, var_0, var_17, var_22);
        var_25 = wp::extract(var_10, var_23);
        var_26 = wp::mul(var_24, var_25);
        var_27 = round_half_even_0(var_26);
        var_28 = wp::uint8(var_27);
        wp::array_store(var_pixels, var_0, var_23, var_28);
}



extern "C" __global__ void hide_unseen_kernel_c865879e_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_depth,
    wp::array_t<wp::float32> var_brightness)
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
        const wp::float32 var_2 = 0.0;
        bool var_3;
        wp::float32 var_4;
        const wp::float32 var_5 = -1.0;
        //---------
        // forward
        // def hide_unseen_kernel(depth: array(dtype=float32), brightness: array(dtype=float32)):       <L 10>
        // i = tid()                                                                              <L 11>
        var_0 = builtin_tid1d();
        // if depth[i] <= 0.0:                                                                    <L 12>
        var_1 = wp::address(var_depth, var_0);
        var_4 = wp::load(var_1);
        var_3 = (var_4 <= var_2);
        if (var_3) {
            // brightness[i] = NO_COLOR                                                           <L 13>
            wp::array_store(var_brightness, var_0, var_5);
        }
}


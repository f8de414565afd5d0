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


// /work/main/src/pointloom/kernels/rgbd/pyramid.py:147
static CUDA_CALLABLE wp::float32 luma_0(
    wp::int32 var_at,
    wp::array_t<wp::uint8> var_pixels)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 0.299;
    const wp::int32 var_1 = 0;
    wp::uint8* var_2;
    wp::float32 var_3;
    wp::uint8 var_4;
    wp::float32 var_5;
    const wp::float32 var_6 = 0.587;
    const wp::int32 var_7 = 1;
    wp::uint8* var_8;
    wp::float32 var_9;
    wp::uint8 var_10;
    wp::float32 var_11;
    wp::float32 var_12;
    const wp::float32 var_13 = 0.114;
    const wp::int32 var_14 = 2;
    wp::uint8* var_15;
    wp::float32 var_16;
    wp::uint8 var_17;
    wp::float32 var_18;
    wp::float32 var_19;
    const wp::float32 var_20 = 255.0;
    wp::float32 var_21;
    //---------
    // forward
    // def luma(at: int, pixels: array(dtype=uint8, ndim=2)) -> float:                        <L 148>
    // return (RED * float(pixels[at, 0]) + GREEN * float(pixels[at, 1]) + BLUE * float(pixels[at, 2])) / 255.0       <L 149>
    var_2 = wp::address(var_pixels, var_at, var_1);
    var_4 = wp::load(var_2);
    var_3 = wp::float(var_4);
    var_5 = wp::mul(var_0, var_3);
    var_8 = wp::address(var_pixels, var_at, var_7);
    var_10 = wp::load(var_8);
    var_9 = wp::float(var_10);
    var_11 = wp::mul(var_6, var_9);
    var_12 = wp::add(var_5, var_11);
    var_15 = wp::address(var_pixels, var_at, var_14);
    var_17 = wp::load(var_15);
    var_16 = wp::float(var_17);
    var_18 = wp::mul(var_13, var_16);
    var_19 = wp::add(var_12, var_18);
    var_21 = wp::div(var_19, var_20);
    return var_21;
}


// /work/main/src/pointloom/kernels/rgbd/pyramid.py:147
static CUDA_CALLABLE void adj_luma_0(
    wp::int32 var_at,
    wp::array_t<wp::uint8> var_pixels,
    wp::int32 & adj_at,
    wp::array_t<wp::uint8> & adj_pixels,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void hide_near_kernel_1b94f3ff_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_depth,
    wp::float32 var_limit,
    wp::array_t<wp::float32> var_far)
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
        const wp::float32 var_4 = 0.0;
        wp::float32 var_5;
        bool var_6;
        wp::float32 var_7;
        wp::float32 var_8;
        //---------
        // forward
        // def hide_near_kernel(depth, limit, far):                                               <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // d = depth[i]                                                                           <L 3>
        var_1 = wp::address(var_depth, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // value = float(0.0)                                                                     <L 4>
        var_5 = wp::float(var_4);
        // if d > limit:                                                                          <L 5>
        var_6 = (var_2 > var_limit);
        if (var_6) {
            // value = d                                                                          <L 6>
            var_7 = wp::copy(var_2);
        }
        var_8 = wp::where(var_6, var_7, var_5);
        // far[i] = value                                                                         <L 7>
        wp::array_store(var_far, var_0, var_8);
}



extern "C" __global__ void hide_cells_kernel_cb2d4248_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_depth,
    wp::array_t<wp::uint8> var_hidden,
    wp::int32 var_width,
    wp::int32 var_side,
    wp::int32 var_columns,
    wp::int32 var_rows,
    wp::array_t<wp::float32> var_shown)
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
        wp::int32 var_2;
        wp::int32 var_3;
        wp::int32 var_4;
        wp::float32* var_5;
        wp::float32 var_6;
        wp::float32 var_7;
        bool var_8;
        bool var_9;
        bool var_10;
        wp::int32 var_11;
        wp::int32 var_12;
        wp::uint8* var_13;
        const wp::int32 var_14 = 0;
        wp::uint8 var_15;
        bool var_16;
        wp::uint8 var_17;
        const wp::float32 var_18 = 0.0;
        wp::float32 var_19;
        wp::float32 var_20;
        //---------
        // forward
        // def hide_cells_kernel(                                                                 <L 35>
        // i = tid()                                                                              <L 39>
        var_0 = builtin_tid1d();
        // u = i % width // side                                                                  <L 40>
        var_1 = wp::mod(var_0, var_width);
        var_2 = wp::floordiv(var_1, var_side);
        // v = i // width // side                                                                 <L 41>
        var_3 = wp::floordiv(var_0, var_width);
        var_4 = wp::floordiv(var_3, var_side);
        // value = depth[i]                                                                       <L 42>
        var_5 = wp::address(var_depth, var_0);
        var_7 = wp::load(var_5);
        var_6 = wp::copy(var_7);
        // if u < columns and v < rows:                                                           <L 43>
        var_9 = (var_2 < var_columns);
        var_8 = var_9;
        if (var_8) {
            var_10 = (var_4 < var_rows);
            var_8 = var_8 && var_10;
        }
        if (var_8) {
            // if hidden[v * columns + u] != uint8(0):                                            <L 44>
            var_11 = wp::mul(var_4, var_columns);
            var_12 = wp::add(var_11, var_2);
            var_13 = wp::address(var_hidden, var_12);
            var_15 = wp::uint8(var_14);
            var_17 = wp::load(var_13);
            var_16 = (var_17 != var_15);
            if (var_16) {
                // value = 0.0                                                                    <L 45>
            }
            var_19 = wp::where(var_16, var_18, var_6);
        }
        var_20 = wp::where(var_8, var_19, var_6);
        // shown[i] = value                                                                       <L 46>
        wp::array_store(var_shown, var_0, var_20);
}



extern "C" __global__ void view_stream_kernel_dbdffe66_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_depth,
    wp::array_t<wp::uint8> var_pixels,
    wp::int32 var_has_color,
    wp::int32 var_width,
    wp::int32 var_side,
    wp::int32 var_columns,
    wp::array_t<wp::float32> var_brightness,
    wp::array_t<wp::float32> var_nearness)
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
        wp::int32 var_2;
        wp::int32 var_3;
        wp::int32 var_4;
        wp::int32 var_5;
        wp::int32 var_6;
        const wp::float32 var_7 = 0.0;
        wp::float32 var_8;
        const wp::float32 var_9 = 0.0;
        wp::float32 var_10;
        const wp::float32 var_11 = 0.0;
        wp::float32 var_12;
        wp::int32 var_13;
        wp::range_t var_14;
        wp::int32 var_15;
        wp::int32 var_16;
        wp::int32 var_17;
        wp::int32 var_18;
        wp::int32 var_19;
        wp::int32 var_20;
        wp::float32* var_21;
        wp::float32 var_22;
        wp::float32 var_23;
        const wp::float32 var_24 = 0.0;
        bool var_25;
        const wp::float32 var_26 = 1.0;
        wp::float32 var_27;
        wp::float32 var_28;
        const wp::float32 var_29 = 1.0;
        wp::float32 var_30;
        wp::float32 var_31;
        wp::float32 var_32;
        const wp::int32 var_33 = 1;
        bool var_34;
        wp::float32 var_35;
        wp::float32 var_36;
        wp::float32 var_37;
        wp::int32 var_38;
        wp::float32 var_39;
        const wp::float32 var_40 = -1.0;
        wp::float32 var_41;
        const wp::int32 var_42 = 1;
        bool var_43;
        wp::float32 var_44;
        const wp::float32 var_45 = 0.0;
        const wp::float32 var_46 = 0.75;
        wp::float32 var_47;
        bool var_48;
        wp::float32 var_49;
        //---------
        // forward
        // def view_stream_kernel(depth, pixels, has_color, width, side, columns, brightness, nearness):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // first = i // columns * side * width + i % columns * side                               <L 4>
        var_1 = wp::floordiv(var_0, var_columns);
        var_2 = wp::mul(var_1, var_side);
        var_3 = wp::mul(var_2, var_width);
        var_4 = wp::mod(var_0, var_columns);
        var_5 = wp::mul(var_4, var_side);
        var_6 = wp::add(var_3, var_5);
        // shade = float(0.0)                                                                     <L 5>
        var_8 = wp::float(var_7);
        // near = float(0.0)                                                                      <L 6>
        var_10 = wp::float(var_9);
        // count = float(0.0)                                                                     <L 7>
        var_12 = wp::float(var_11);
        // for k in range(side * side):                                                           <L 8>
        var_13 = wp::mul(var_side, var_side);
        var_14 = wp::range(var_13);
        start_for_0:;
            if (iter_cmp(var_14) == 0) goto end_for_0;
            var_15 = wp::iter_next(var_14);
            // at = first + k // side * width + k % side                                          <L 9>
            var_16 = wp::floordiv(var_15, var_side);
            var_17 = wp::mul(var_16, var_width);
            var_18 = wp::add(var_6, var_17);
            var_19 = wp::mod(var_15, var_side);
            var_20 = wp::add(var_18, var_19);
            // z = depth[at]                                                                      <L 10>
            var_21 = wp::address(var_depth, var_20);
            var_23 = wp::load(var_21);
            var_22 = wp::copy(var_23);
            // if z > 0.0:                                                                        <L 11>
            var_25 = (var_22 > var_24);
            if (var_25) {
                // near += 1.0 / z                                                                <L 12>
                var_27 = wp::div(var_26, var_22);
                var_28 = wp::add(var_10, var_27);
                // count += 1.0                                                                   <L 13>
                var_30 = wp::add(var_12, var_29);
            }
            var_31 = wp::where(var_25, var_28, var_10);
            var_32 = wp::where(var_25, var_30, var_12);
            // if has_color == 1:                                                                 <L 14>
            var_34 = (var_has_color == var_33);
            if (var_34) {
                // shade += luma(at, pixels)                                                      <L 15>
                var_35 = luma_0(var_20, var_pixels);
                var_36 = wp::add(var_8, var_35);
            }
            var_37 = wp::where(var_34, var_36, var_8);
            wp::assign(var_8, var_37);
            wp::assign(var_10, var_31);
            wp::assign(var_12, var_32);
            goto start_for_0;
        end_for_0:;
        // area = float(side * side)                                                              <L 16>
        var_38 = wp::mul(var_side, var_side);
        var_39 = wp::float(var_38);
        // brightness[i] = float(NO_COLOR)                                                        <L 17>
        var_41 = wp::float(var_40);
        wp::array_store(var_brightness, var_0, var_41);
        // if has_color == 1:                                                                     <L 18>
        var_43 = (var_has_color == var_42);
        if (var_43) {
            // brightness[i] = shade / area                                                       <L 19>
            var_44 = wp::div(var_8, var_39);
            wp::array_store(var_brightness, var_0, var_44);
        }
        // nearness[i] = 0.0                                                                      <L 20>
        wp::array_store(var_nearness, var_0, var_45);
        // if count >= FULL * area:                                                               <L 21>
        var_47 = wp::mul(var_46, var_39);
        var_48 = (var_12 >= var_47);
        if (var_48) {
            // nearness[i] = near / count                                                         <L 22>
            var_49 = wp::div(var_10, var_12);
            wp::array_store(var_nearness, var_0, var_49);
        }
}


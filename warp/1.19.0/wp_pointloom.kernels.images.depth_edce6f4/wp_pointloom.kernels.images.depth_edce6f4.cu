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


// <pointloom.kernels.images.depth.unproject_pixel>:1
static CUDA_CALLABLE wp::vec_t<3, wp::float64> unproject_pixel_0(
    wp::int32 var_u,
    wp::int32 var_v,
    wp::float32 var_d,
    wp::float64 var_camera__fx,
    wp::float64 var_camera__fy,
    wp::float64 var_camera__cx,
    wp::float64 var_camera__cy)
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
    wp::float64 var_7;
    wp::float64 var_8;
    wp::vec_t<3, wp::float64> var_9;
    //---------
    // forward
    // def unproject_pixel(u, v, d, camera__fx, camera__fy, camera__cx, camera__cy):          <L 1>
    // z = float64(d)                                                                         <L 2>
    var_0 = wp::float64(var_d);
    // return vec3d((float64(u) - camera__cx) * z / camera__fx, (float64(v) - camera__cy) * z / camera__fy, z)       <L 3>
    var_1 = wp::float64(var_u);
    var_2 = wp::sub(var_1, var_camera__cx);
    var_3 = wp::mul(var_2, var_0);
    var_4 = wp::div(var_3, var_camera__fx);
    var_5 = wp::float64(var_v);
    var_6 = wp::sub(var_5, var_camera__cy);
    var_7 = wp::mul(var_6, var_0);
    var_8 = wp::div(var_7, var_camera__fy);
    var_9 = wp::vec_t<3, wp::float64>(var_4, var_8, var_0);
    return var_9;
}


// <pointloom.kernels.algebra.transform.transform_point>:1
static CUDA_CALLABLE wp::vec_t<3, wp::float64> transform_point_0(
    wp::vec_t<3, wp::float64> var_p,
    wp::mat_t<3, 3, wp::float64> var_T__R,
    wp::vec_t<3, wp::float64> var_T__t)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float64> var_0;
    wp::vec_t<3, wp::float64> var_1;
    //---------
    // forward
    // def transform_point(p, T__R, T__t):                                                    <L 1>
    // return T__R @ p + T__t                                                                 <L 2>
    var_0 = wp::mul(var_T__R, var_p);
    var_1 = wp::add(var_0, var_T__t);
    return var_1;
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


// <pointloom.kernels.images.depth.grid_pixel>:1
static CUDA_CALLABLE wp::int32 grid_pixel_0(
    wp::int32 var_i,
    wp::int32 var_grid__stride,
    wp::int32 var_grid__columns,
    wp::int32 var_grid__width)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32 var_1;
    wp::int32 var_2;
    wp::int32 var_3;
    wp::int32 var_4;
    wp::int32 var_5;
    //---------
    // forward
    // def grid_pixel(i, grid__stride, grid__columns, grid__width):                           <L 1>
    // return i // grid__columns * grid__stride * grid__width + i % grid__columns * grid__stride       <L 2>
    var_0 = wp::floordiv(var_i, var_grid__columns);
    var_1 = wp::mul(var_0, var_grid__stride);
    var_2 = wp::mul(var_1, var_grid__width);
    var_3 = wp::mod(var_i, var_grid__columns);
    var_4 = wp::mul(var_3, var_grid__stride);
    var_5 = wp::add(var_2, var_4);
    return var_5;
}


// <pointloom.kernels.images.depth.meet_neighbors>:1
static CUDA_CALLABLE wp::vec_t<3, wp::float64> meet_neighbors_0(
    wp::int32 var_u,
    wp::int32 var_v,
    wp::vec_t<3, wp::float32> var_depths,
    wp::int32 var_stride,
    wp::float64 var_camera__fx,
    wp::float64 var_camera__fy,
    wp::float64 var_camera__cx,
    wp::float64 var_camera__cy)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    wp::vec_t<3, wp::float64> var_2;
    wp::int32 var_3;
    const wp::int32 var_4 = 1;
    wp::float32 var_5;
    wp::vec_t<3, wp::float64> var_6;
    wp::vec_t<3, wp::float64> var_7;
    wp::int32 var_8;
    const wp::int32 var_9 = 2;
    wp::float32 var_10;
    wp::vec_t<3, wp::float64> var_11;
    wp::vec_t<3, wp::float64> var_12;
    wp::vec_t<3, wp::float64> var_13;
    //---------
    // forward
    // def meet_neighbors(u, v, depths, stride, camera__fx, camera__fy, camera__cx, camera__cy):       <L 1>
    // p = unproject_pixel(u, v, depths[0], camera__fx, camera__fy, camera__cx, camera__cy)       <L 3>
    var_1 = wp::extract(var_depths, var_0);
    var_2 = unproject_pixel_0(var_u, var_v, var_1, var_camera__fx, var_camera__fy, var_camera__cx, var_camera__cy);
    // along = unproject_pixel(u + stride, v, depths[1], camera__fx, camera__fy, camera__cx, camera__cy) - p       <L 4>
    var_3 = wp::add(var_u, var_stride);
    var_5 = wp::extract(var_depths, var_4);
    var_6 = unproject_pixel_0(var_3, var_v, var_5, var_camera__fx, var_camera__fy, var_camera__cx, var_camera__cy);
    var_7 = wp::sub(var_6, var_2);
    // down = unproject_pixel(u, v + stride, depths[2], camera__fx, camera__fy, camera__cx, camera__cy) - p       <L 5>
    var_8 = wp::add(var_v, var_stride);
    var_10 = wp::extract(var_depths, var_9);
    var_11 = unproject_pixel_0(var_u, var_8, var_10, var_camera__fx, var_camera__fy, var_camera__cx, var_camera__cy);
    var_12 = wp::sub(var_11, var_2);
    // return cross(down, along)                                                              <L 6>
    var_13 = wp::cross(var_12, var_7);
    return var_13;
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


// <pointloom.kernels.images.depth.unproject_pixel>:1
static CUDA_CALLABLE void adj_unproject_pixel_0(
    wp::int32 var_u,
    wp::int32 var_v,
    wp::float32 var_d,
    wp::float64 var_camera__fx,
    wp::float64 var_camera__fy,
    wp::float64 var_camera__cx,
    wp::float64 var_camera__cy,
    wp::int32 & adj_u,
    wp::int32 & adj_v,
    wp::float32 & adj_d,
    wp::float64 & adj_camera__fx,
    wp::float64 & adj_camera__fy,
    wp::float64 & adj_camera__cx,
    wp::float64 & adj_camera__cy,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.algebra.transform.transform_point>:1
static CUDA_CALLABLE void adj_transform_point_0(
    wp::vec_t<3, wp::float64> var_p,
    wp::mat_t<3, 3, wp::float64> var_T__R,
    wp::vec_t<3, wp::float64> var_T__t,
    wp::vec_t<3, wp::float64> & adj_p,
    wp::mat_t<3, 3, wp::float64> & adj_T__R,
    wp::vec_t<3, wp::float64> & adj_T__t,
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


// <pointloom.kernels.images.depth.grid_pixel>:1
static CUDA_CALLABLE void adj_grid_pixel_0(
    wp::int32 var_i,
    wp::int32 var_grid__stride,
    wp::int32 var_grid__columns,
    wp::int32 var_grid__width,
    wp::int32 & adj_i,
    wp::int32 & adj_grid__stride,
    wp::int32 & adj_grid__columns,
    wp::int32 & adj_grid__width,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.images.depth.meet_neighbors>:1
static CUDA_CALLABLE void adj_meet_neighbors_0(
    wp::int32 var_u,
    wp::int32 var_v,
    wp::vec_t<3, wp::float32> var_depths,
    wp::int32 var_stride,
    wp::float64 var_camera__fx,
    wp::float64 var_camera__fy,
    wp::float64 var_camera__cx,
    wp::float64 var_camera__cy,
    wp::int32 & adj_u,
    wp::int32 & adj_v,
    wp::vec_t<3, wp::float32> & adj_depths,
    wp::int32 & adj_stride,
    wp::float64 & adj_camera__fx,
    wp::float64 & adj_camera__fy,
    wp::float64 & adj_camera__cx,
    wp::float64 & adj_camera__cy,
    wp::vec_t<3, wp::float64> & adj_ret)
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



extern "C" __global__ void unproject_depth_kernel_11f7eeba_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_depth,
    wp::int32 var_grid__stride,
    wp::int32 var_grid__columns,
    wp::int32 var_grid__width,
    wp::float64 var_camera__fx,
    wp::float64 var_camera__fy,
    wp::float64 var_camera__cx,
    wp::float64 var_camera__cy,
    wp::mat_t<3, 3, wp::float64> var_T_world_camera__R,
    wp::vec_t<3, wp::float64> var_T_world_camera__t,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::array_t<wp::uint8> var_valid)
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
        wp::float32* var_7;
        wp::float32 var_8;
        wp::float32 var_9;
        const wp::float32 var_10 = NAN;
        wp::vec_t<3, wp::float32> var_11;
        const wp::int32 var_12 = 0;
        wp::int32 var_13;
        const wp::float32 var_14 = 0.0;
        bool var_15;
        wp::vec_t<3, wp::float64> var_16;
        wp::vec_t<3, wp::float64> var_17;
        wp::vec_t<3, wp::float32> var_18;
        const wp::int32 var_19 = 1;
        wp::vec_t<3, wp::float32> var_20;
        wp::int32 var_21;
        wp::uint8 var_22;
        //---------
        // forward
        // def unproject_depth_kernel(depth, grid__stride, grid__columns, grid__width, camera__fx, camera__fy, camera__cx, camera__cy, T_world_camera__R, T_world_camera__t, points, valid):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // u = i % grid__columns * grid__stride                                                   <L 4>
        var_1 = wp::mod(var_0, var_grid__columns);
        var_2 = wp::mul(var_1, var_grid__stride);
        // v = i // grid__columns * grid__stride                                                  <L 5>
        var_3 = wp::floordiv(var_0, var_grid__columns);
        var_4 = wp::mul(var_3, var_grid__stride);
        // d = depth[v * grid__width + u]                                                         <L 6>
        var_5 = wp::mul(var_4, var_grid__width);
        var_6 = wp::add(var_5, var_2);
        var_7 = wp::address(var_depth, var_6);
        var_9 = wp::load(var_7);
        var_8 = wp::copy(var_9);
        // p = vec3(NAN, NAN, NAN)                                                                <L 7>
        var_11 = wp::vec_t<3, wp::float32>(var_10, var_10, var_10);
        // good = int(0)                                                                          <L 8>
        var_13 = wp::int(var_12);
        // if d > 0.0:                                                                            <L 9>
        var_15 = (var_8 > var_14);
        if (var_15) {
            // p = narrow(transform_point(unproject_pixel(u, v, d, camera__fx, camera__fy, camera__cx, camera__cy), T_world_camera__R, T_world_camera__t))       <L 10>
            var_16 = unproject_pixel_0(var_2, var_4, var_8, var_camera__fx, var_camera__fy, var_camera__cx, var_camera__cy);
            var_17 = transform_point_0(var_16, var_T_world_camera__R, var_T_world_camera__t);
            var_18 = narrow_0(var_17);
            // good = 1                                                                           <L 11>
        }
        var_20 = wp::where(var_15, var_18, var_11);
        var_21 = wp::where(var_15, var_19, var_13);
        // points[i] = p                                                                          <L 12>
        wp::array_store(var_points, var_0, var_20);
        // valid[i] = uint8(good)                                                                 <L 13>
        var_22 = wp::uint8(var_21);
        wp::array_store(var_valid, var_0, var_22);
}



extern "C" __global__ void decode_sun_kernel_14fec5e2_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::uint16> var_raw,
    wp::array_t<wp::uint16> var_depth)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::uint16* var_1;
        wp::int32 var_2;
        wp::uint16 var_3;
        const wp::int32 var_4 = 3;
        wp::int32 var_5;
        const wp::int32 var_6 = 13;
        wp::int32 var_7;
        wp::int32 var_8;
        const wp::int32 var_9 = 65535;
        wp::int32 var_10;
        wp::uint16 var_11;
        //---------
        // forward
        // def decode_sun_kernel(raw: array(dtype=uint16), depth: array(dtype=uint16)):           <L 46>
        // i = tid()                                                                              <L 48>
        var_0 = builtin_tid1d();
        // x = int(raw[i])                                                                        <L 49>
        var_1 = wp::address(var_raw, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::int(var_3);
        // depth[i] = uint16(((x >> 3) | (x << 13)) & WORD)                                       <L 50>
        var_5 = wp::rshift(var_2, var_4);
        var_7 = wp::lshift(var_2, var_6);
        var_8 = wp::bit_or(var_5, var_7);
        var_10 = wp::bit_and(var_8, var_9);
        var_11 = wp::uint16(var_10);
        wp::array_store(var_depth, var_0, var_11);
}



extern "C" __global__ void gray_pixels_kernel_16e313dc_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_intensity,
    wp::int32 var_grid__stride,
    wp::int32 var_grid__columns,
    wp::int32 var_grid__width,
    wp::array_t<wp::vec_t<3, wp::float32>> var_colors)
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
        wp::vec_t<3, wp::float32> var_5;
        //---------
        // forward
        // def gray_pixels_kernel(intensity, grid__stride, grid__columns, grid__width, colors):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // g = intensity[grid_pixel(i, grid__stride, grid__columns, grid__width)]                 <L 4>
        var_1 = grid_pixel_0(var_0, var_grid__stride, var_grid__columns, var_grid__width);
        var_2 = wp::address(var_intensity, var_1);
        var_4 = wp::load(var_2);
        var_3 = wp::copy(var_4);
        // colors[i] = vec3(g, g, g)                                                              <L 5>
        var_5 = wp::vec_t<3, wp::float32>(var_3, var_3, var_3);
        wp::array_store(var_colors, var_0, var_5);
}



extern "C" __global__ void fit_pixel_normals_kernel_24f0c32a_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_depth,
    wp::int32 var_grid__stride,
    wp::int32 var_grid__columns,
    wp::int32 var_grid__width,
    wp::int32 var_camera__width,
    wp::int32 var_camera__height,
    wp::float64 var_camera__fx,
    wp::float64 var_camera__fy,
    wp::float64 var_camera__cx,
    wp::float64 var_camera__cy,
    wp::mat_t<3, 3, wp::float64> var_R,
    wp::float32 var_fill,
    wp::array_t<wp::vec_t<3, wp::float32>> var_normals,
    wp::array_t<wp::uint8> var_valid)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        const wp::int32 var_1 = 8;
        wp::int32 var_2;
        const wp::int32 var_3 = 1;
        wp::int32 var_4;
        wp::int32 var_5;
        wp::int32 var_6;
        wp::int32 var_7;
        wp::int32 var_8;
        wp::int32 var_9;
        wp::int32 var_10;
        wp::int32 var_11;
        const wp::int32 var_12 = 1;
        wp::int32 var_13;
        wp::int32 var_14;
        wp::int32 var_15;
        const wp::float32 var_16 = 0.0;
        wp::vec_t<8, wp::float32> var_17;
        const wp::float32 var_18 = 0.0;
        wp::vec_t<8, wp::float32> var_19;
        const wp::float32 var_20 = 0.0;
        wp::vec_t<8, wp::float32> var_21;
        const wp::int32 var_22 = 0;
        wp::int32 var_23;
        wp::int32 var_24;
        const wp::int32 var_25 = 1;
        wp::int32 var_26;
        wp::int32 var_27;
        wp::int32 var_28;
        const wp::int32 var_29 = 1;
        wp::int32 var_30;
        wp::int32 var_31;
        wp::int32 var_32;
        wp::float32* var_33;
        wp::int32 var_34;
        wp::float32* var_35;
        wp::int32 var_36;
        wp::float32* var_37;
        wp::vec_t<3, wp::float32> var_38;
        wp::float32 var_39;
        wp::float32 var_40;
        wp::float32 var_41;
        wp::vec_t<3, wp::float64> var_42;
        wp::float64 var_43;
        wp::float64 var_44;
        wp::vec_t<3, wp::float64> var_45;
        wp::vec_t<3, wp::float64> var_46;
        wp::vec_t<3, wp::float32> var_47;
        bool var_48;
        wp::int32 var_49;
        bool var_50;
        wp::int32 var_51;
        bool var_52;
        bool var_53;
        wp::float64 var_54;
        bool var_55;
        const wp::int32 var_56 = 0;
        wp::float32 var_57;
        const wp::int32 var_58 = 1;
        wp::float32 var_59;
        wp::float32 var_60;
        const wp::int32 var_61 = 2;
        wp::float32 var_62;
        wp::float32 var_63;
        const wp::float32 var_64 = 0.0;
        bool var_65;
        const wp::int32 var_66 = 0;
        wp::float32 var_67;
        const wp::float32 var_68 = NAN;
        wp::float32 var_69;
        wp::float32 var_70;
        const wp::int32 var_71 = 1;
        wp::float32 var_72;
        wp::float32 var_73;
        wp::float32 var_74;
        const wp::int32 var_75 = 2;
        wp::float32 var_76;
        wp::float32 var_77;
        wp::float32 var_78;
        const wp::int32 var_79 = 1;
        wp::int32 var_80;
        wp::int32 var_81;
        const wp::int32 var_82 = 1;
        wp::int32 var_83;
        wp::int32 var_84;
        wp::int32 var_85;
        const wp::int32 var_86 = 1;
        wp::int32 var_87;
        wp::int32 var_88;
        wp::int32 var_89;
        wp::float32* var_90;
        wp::int32 var_91;
        wp::float32* var_92;
        wp::int32 var_93;
        wp::float32* var_94;
        wp::vec_t<3, wp::float32> var_95;
        wp::float32 var_96;
        wp::float32 var_97;
        wp::float32 var_98;
        wp::vec_t<3, wp::float64> var_99;
        wp::float64 var_100;
        wp::float64 var_101;
        wp::vec_t<3, wp::float64> var_102;
        wp::vec_t<3, wp::float64> var_103;
        wp::vec_t<3, wp::float32> var_104;
        bool var_105;
        wp::int32 var_106;
        bool var_107;
        wp::int32 var_108;
        bool var_109;
        bool var_110;
        wp::float64 var_111;
        bool var_112;
        const wp::int32 var_113 = 0;
        wp::float32 var_114;
        const wp::int32 var_115 = 1;
        wp::float32 var_116;
        wp::float32 var_117;
        const wp::int32 var_118 = 2;
        wp::float32 var_119;
        wp::float32 var_120;
        const wp::float32 var_121 = 0.0;
        bool var_122;
        const wp::int32 var_123 = 0;
        wp::float32 var_124;
        wp::float32 var_125;
        wp::float32 var_126;
        const wp::int32 var_127 = 1;
        wp::float32 var_128;
        wp::float32 var_129;
        wp::float32 var_130;
        const wp::int32 var_131 = 2;
        wp::float32 var_132;
        wp::float32 var_133;
        wp::float32 var_134;
        const wp::int32 var_135 = 2;
        wp::int32 var_136;
        wp::int32 var_137;
        const wp::int32 var_138 = 1;
        wp::int32 var_139;
        wp::int32 var_140;
        wp::int32 var_141;
        const wp::int32 var_142 = 1;
        wp::int32 var_143;
        wp::int32 var_144;
        wp::int32 var_145;
        wp::float32* var_146;
        wp::int32 var_147;
        wp::float32* var_148;
        wp::int32 var_149;
        wp::float32* var_150;
        wp::vec_t<3, wp::float32> var_151;
        wp::float32 var_152;
        wp::float32 var_153;
        wp::float32 var_154;
        wp::vec_t<3, wp::float64> var_155;
        wp::float64 var_156;
        wp::float64 var_157;
        wp::vec_t<3, wp::float64> var_158;
        wp::vec_t<3, wp::float64> var_159;
        wp::vec_t<3, wp::float32> var_160;
        bool var_161;
        wp::int32 var_162;
        bool var_163;
        wp::int32 var_164;
        bool var_165;
        bool var_166;
        wp::float64 var_167;
        bool var_168;
        const wp::int32 var_169 = 0;
        wp::float32 var_170;
        const wp::int32 var_171 = 1;
        wp::float32 var_172;
        wp::float32 var_173;
        const wp::int32 var_174 = 2;
        wp::float32 var_175;
        wp::float32 var_176;
        const wp::float32 var_177 = 0.0;
        bool var_178;
        const wp::int32 var_179 = 0;
        wp::float32 var_180;
        wp::float32 var_181;
        wp::float32 var_182;
        const wp::int32 var_183 = 1;
        wp::float32 var_184;
        wp::float32 var_185;
        wp::float32 var_186;
        const wp::int32 var_187 = 2;
        wp::float32 var_188;
        wp::float32 var_189;
        wp::float32 var_190;
        const wp::int32 var_191 = 3;
        wp::int32 var_192;
        wp::int32 var_193;
        const wp::int32 var_194 = 1;
        wp::int32 var_195;
        wp::int32 var_196;
        wp::int32 var_197;
        const wp::int32 var_198 = 1;
        wp::int32 var_199;
        wp::int32 var_200;
        wp::int32 var_201;
        wp::float32* var_202;
        wp::int32 var_203;
        wp::float32* var_204;
        wp::int32 var_205;
        wp::float32* var_206;
        wp::vec_t<3, wp::float32> var_207;
        wp::float32 var_208;
        wp::float32 var_209;
        wp::float32 var_210;
        wp::vec_t<3, wp::float64> var_211;
        wp::float64 var_212;
        wp::float64 var_213;
        wp::vec_t<3, wp::float64> var_214;
        wp::vec_t<3, wp::float64> var_215;
        wp::vec_t<3, wp::float32> var_216;
        bool var_217;
        wp::int32 var_218;
        bool var_219;
        wp::int32 var_220;
        bool var_221;
        bool var_222;
        wp::float64 var_223;
        bool var_224;
        const wp::int32 var_225 = 0;
        wp::float32 var_226;
        const wp::int32 var_227 = 1;
        wp::float32 var_228;
        wp::float32 var_229;
        const wp::int32 var_230 = 2;
        wp::float32 var_231;
        wp::float32 var_232;
        const wp::float32 var_233 = 0.0;
        bool var_234;
        const wp::int32 var_235 = 0;
        wp::float32 var_236;
        wp::float32 var_237;
        wp::float32 var_238;
        const wp::int32 var_239 = 1;
        wp::float32 var_240;
        wp::float32 var_241;
        wp::float32 var_242;
        const wp::int32 var_243 = 2;
        wp::float32 var_244;
        wp::float32 var_245;
        wp::float32 var_246;
        const wp::int32 var_247 = 4;
        wp::int32 var_248;
        wp::int32 var_249;
        const wp::int32 var_250 = 1;
        wp::int32 var_251;
        wp::int32 var_252;
        wp::int32 var_253;
        const wp::int32 var_254 = 1;
        wp::int32 var_255;
        wp::int32 var_256;
        wp::int32 var_257;
        wp::float32* var_258;
        wp::int32 var_259;
        wp::float32* var_260;
        wp::int32 var_261;
        wp::float32* var_262;
        wp::vec_t<3, wp::float32> var_263;
        wp::float32 var_264;
        wp::float32 var_265;
        wp::float32 var_266;
        wp::vec_t<3, wp::float64> var_267;
        wp::float64 var_268;
        wp::float64 var_269;
        wp::vec_t<3, wp::float64> var_270;
        wp::vec_t<3, wp::float64> var_271;
        wp::vec_t<3, wp::float32> var_272;
        bool var_273;
        wp::int32 var_274;
        bool var_275;
        wp::int32 var_276;
        bool var_277;
        bool var_278;
        wp::float64 var_279;
        bool var_280;
        const wp::int32 var_281 = 0;
        wp::float32 var_282;
        const wp::int32 var_283 = 1;
        wp::float32 var_284;
        wp::float32 var_285;
        const wp::int32 var_286 = 2;
        wp::float32 var_287;
        wp::float32 var_288;
        const wp::float32 var_289 = 0.0;
        bool var_290;
        const wp::int32 var_291 = 0;
        wp::float32 var_292;
        wp::float32 var_293;
        wp::float32 var_294;
        const wp::int32 var_295 = 1;
        wp::float32 var_296;
        wp::float32 var_297;
        wp::float32 var_298;
        const wp::int32 var_299 = 2;
        wp::float32 var_300;
        wp::float32 var_301;
        wp::float32 var_302;
        const wp::int32 var_303 = 5;
        wp::int32 var_304;
        wp::int32 var_305;
        const wp::int32 var_306 = 1;
        wp::int32 var_307;
        wp::int32 var_308;
        wp::int32 var_309;
        const wp::int32 var_310 = 1;
        wp::int32 var_311;
        wp::int32 var_312;
        wp::int32 var_313;
        wp::float32* var_314;
        wp::int32 var_315;
        wp::float32* var_316;
        wp::int32 var_317;
        wp::float32* var_318;
        wp::vec_t<3, wp::float32> var_319;
        wp::float32 var_320;
        wp::float32 var_321;
        wp::float32 var_322;
        wp::vec_t<3, wp::float64> var_323;
        wp::float64 var_324;
        wp::float64 var_325;
        wp::vec_t<3, wp::float64> var_326;
        wp::vec_t<3, wp::float64> var_327;
        wp::vec_t<3, wp::float32> var_328;
        bool var_329;
        wp::int32 var_330;
        bool var_331;
        wp::int32 var_332;
        bool var_333;
        bool var_334;
        wp::float64 var_335;
        bool var_336;
        const wp::int32 var_337 = 0;
        wp::float32 var_338;
        const wp::int32 var_339 = 1;
        wp::float32 var_340;
        wp::float32 var_341;
        const wp::int32 var_342 = 2;
        wp::float32 var_343;
        wp::float32 var_344;
        const wp::float32 var_345 = 0.0;
        bool var_346;
        const wp::int32 var_347 = 0;
        wp::float32 var_348;
        wp::float32 var_349;
        wp::float32 var_350;
        const wp::int32 var_351 = 1;
        wp::float32 var_352;
        wp::float32 var_353;
        wp::float32 var_354;
        const wp::int32 var_355 = 2;
        wp::float32 var_356;
        wp::float32 var_357;
        wp::float32 var_358;
        const wp::int32 var_359 = 6;
        wp::int32 var_360;
        wp::int32 var_361;
        const wp::int32 var_362 = 1;
        wp::int32 var_363;
        wp::int32 var_364;
        wp::int32 var_365;
        const wp::int32 var_366 = 1;
        wp::int32 var_367;
        wp::int32 var_368;
        wp::int32 var_369;
        wp::float32* var_370;
        wp::int32 var_371;
        wp::float32* var_372;
        wp::int32 var_373;
        wp::float32* var_374;
        wp::vec_t<3, wp::float32> var_375;
        wp::float32 var_376;
        wp::float32 var_377;
        wp::float32 var_378;
        wp::vec_t<3, wp::float64> var_379;
        wp::float64 var_380;
        wp::float64 var_381;
        wp::vec_t<3, wp::float64> var_382;
        wp::vec_t<3, wp::float64> var_383;
        wp::vec_t<3, wp::float32> var_384;
        bool var_385;
        wp::int32 var_386;
        bool var_387;
        wp::int32 var_388;
        bool var_389;
        bool var_390;
        wp::float64 var_391;
        bool var_392;
        const wp::int32 var_393 = 0;
        wp::float32 var_394;
        const wp::int32 var_395 = 1;
        wp::float32 var_396;
        wp::float32 var_397;
        const wp::int32 var_398 = 2;
        wp::float32 var_399;
        wp::float32 var_400;
        const wp::float32 var_401 = 0.0;
        bool var_402;
        const wp::int32 var_403 = 0;
        wp::float32 var_404;
        wp::float32 var_405;
        wp::float32 var_406;
        const wp::int32 var_407 = 1;
        wp::float32 var_408;
        wp::float32 var_409;
        wp::float32 var_410;
        const wp::int32 var_411 = 2;
        wp::float32 var_412;
        wp::float32 var_413;
        wp::float32 var_414;
        const wp::int32 var_415 = 7;
        wp::int32 var_416;
        wp::int32 var_417;
        const wp::int32 var_418 = 1;
        wp::int32 var_419;
        wp::int32 var_420;
        wp::int32 var_421;
        const wp::int32 var_422 = 1;
        wp::int32 var_423;
        wp::int32 var_424;
        wp::int32 var_425;
        wp::float32* var_426;
        wp::int32 var_427;
        wp::float32* var_428;
        wp::int32 var_429;
        wp::float32* var_430;
        wp::vec_t<3, wp::float32> var_431;
        wp::float32 var_432;
        wp::float32 var_433;
        wp::float32 var_434;
        wp::vec_t<3, wp::float64> var_435;
        wp::float64 var_436;
        wp::float64 var_437;
        wp::vec_t<3, wp::float64> var_438;
        wp::vec_t<3, wp::float64> var_439;
        wp::vec_t<3, wp::float32> var_440;
        bool var_441;
        wp::int32 var_442;
        bool var_443;
        wp::int32 var_444;
        bool var_445;
        bool var_446;
        wp::float64 var_447;
        bool var_448;
        const wp::int32 var_449 = 0;
        wp::float32 var_450;
        const wp::int32 var_451 = 1;
        wp::float32 var_452;
        wp::float32 var_453;
        const wp::int32 var_454 = 2;
        wp::float32 var_455;
        wp::float32 var_456;
        const wp::float32 var_457 = 0.0;
        bool var_458;
        const wp::int32 var_459 = 0;
        wp::float32 var_460;
        wp::float32 var_461;
        wp::float32 var_462;
        const wp::int32 var_463 = 1;
        wp::float32 var_464;
        wp::float32 var_465;
        wp::float32 var_466;
        const wp::int32 var_467 = 2;
        wp::float32 var_468;
        wp::float32 var_469;
        wp::float32 var_470;
        const wp::int32 var_471 = 0;
        wp::int32 var_472;
        bool var_473;
        wp::int32 var_474;
        wp::int32 var_475;
        wp::int32 var_476;
        wp::float32 var_477;
        wp::float32 var_478;
        wp::float32 var_479;
        wp::vec_t<3, wp::float32> var_480;
        const wp::int32 var_481 = 1;
        wp::int32 var_482;
        bool var_483;
        bool var_484;
        wp::vec_t<3, wp::float32> var_485;
        const wp::int32 var_486 = 0;
        wp::vec_t<3, wp::float32> var_487;
        wp::int32 var_488;
        wp::uint8 var_489;
        wp::vec_t<3, wp::float32> var_490;
        const wp::int32 var_491 = 1;
        wp::int32 var_492;
        bool var_493;
        wp::int32 var_494;
        wp::int32 var_495;
        wp::int32 var_496;
        wp::float32 var_497;
        wp::float32 var_498;
        wp::float32 var_499;
        wp::vec_t<3, wp::float32> var_500;
        const wp::int32 var_501 = 1;
        wp::int32 var_502;
        bool var_503;
        bool var_504;
        wp::vec_t<3, wp::float32> var_505;
        const wp::int32 var_506 = 0;
        wp::vec_t<3, wp::float32> var_507;
        wp::int32 var_508;
        wp::uint8 var_509;
        wp::vec_t<3, wp::float32> var_510;
        wp::int32 var_511;
        wp::int32 var_512;
        const wp::int32 var_513 = 2;
        wp::int32 var_514;
        bool var_515;
        wp::int32 var_516;
        wp::int32 var_517;
        wp::int32 var_518;
        wp::float32 var_519;
        wp::float32 var_520;
        wp::float32 var_521;
        wp::vec_t<3, wp::float32> var_522;
        const wp::int32 var_523 = 1;
        wp::int32 var_524;
        bool var_525;
        bool var_526;
        wp::vec_t<3, wp::float32> var_527;
        const wp::int32 var_528 = 0;
        wp::vec_t<3, wp::float32> var_529;
        wp::int32 var_530;
        wp::uint8 var_531;
        wp::vec_t<3, wp::float32> var_532;
        wp::int32 var_533;
        wp::int32 var_534;
        const wp::int32 var_535 = 3;
        wp::int32 var_536;
        bool var_537;
        wp::int32 var_538;
        wp::int32 var_539;
        wp::int32 var_540;
        wp::float32 var_541;
        wp::float32 var_542;
        wp::float32 var_543;
        wp::vec_t<3, wp::float32> var_544;
        const wp::int32 var_545 = 1;
        wp::int32 var_546;
        bool var_547;
        bool var_548;
        wp::vec_t<3, wp::float32> var_549;
        const wp::int32 var_550 = 0;
        wp::vec_t<3, wp::float32> var_551;
        wp::int32 var_552;
        wp::uint8 var_553;
        wp::vec_t<3, wp::float32> var_554;
        wp::int32 var_555;
        wp::int32 var_556;
        const wp::int32 var_557 = 4;
        wp::int32 var_558;
        bool var_559;
        wp::int32 var_560;
        wp::int32 var_561;
        wp::int32 var_562;
        wp::float32 var_563;
        wp::float32 var_564;
        wp::float32 var_565;
        wp::vec_t<3, wp::float32> var_566;
        const wp::int32 var_567 = 1;
        wp::int32 var_568;
        bool var_569;
        bool var_570;
        wp::vec_t<3, wp::float32> var_571;
        const wp::int32 var_572 = 0;
        wp::vec_t<3, wp::float32> var_573;
        wp::int32 var_574;
        wp::uint8 var_575;
        wp::vec_t<3, wp::float32> var_576;
        wp::int32 var_577;
        wp::int32 var_578;
        const wp::int32 var_579 = 5;
        wp::int32 var_580;
        bool var_581;
        wp::int32 var_582;
        wp::int32 var_583;
        wp::int32 var_584;
        wp::float32 var_585;
        wp::float32 var_586;
        wp::float32 var_587;
        wp::vec_t<3, wp::float32> var_588;
        const wp::int32 var_589 = 1;
        wp::int32 var_590;
        bool var_591;
        bool var_592;
        wp::vec_t<3, wp::float32> var_593;
        const wp::int32 var_594 = 0;
        wp::vec_t<3, wp::float32> var_595;
        wp::int32 var_596;
        wp::uint8 var_597;
        wp::vec_t<3, wp::float32> var_598;
        wp::int32 var_599;
        wp::int32 var_600;
        const wp::int32 var_601 = 6;
        wp::int32 var_602;
        bool var_603;
        wp::int32 var_604;
        wp::int32 var_605;
        wp::int32 var_606;
        wp::float32 var_607;
        wp::float32 var_608;
        wp::float32 var_609;
        wp::vec_t<3, wp::float32> var_610;
        const wp::int32 var_611 = 1;
        wp::int32 var_612;
        bool var_613;
        bool var_614;
        wp::vec_t<3, wp::float32> var_615;
        const wp::int32 var_616 = 0;
        wp::vec_t<3, wp::float32> var_617;
        wp::int32 var_618;
        wp::uint8 var_619;
        wp::vec_t<3, wp::float32> var_620;
        wp::int32 var_621;
        wp::int32 var_622;
        const wp::int32 var_623 = 7;
        wp::int32 var_624;
        bool var_625;
        wp::int32 var_626;
        wp::int32 var_627;
        wp::int32 var_628;
        wp::float32 var_629;
        wp::float32 var_630;
        wp::float32 var_631;
        wp::vec_t<3, wp::float32> var_632;
        const wp::int32 var_633 = 1;
        wp::int32 var_634;
        bool var_635;
        bool var_636;
        wp::vec_t<3, wp::float32> var_637;
        const wp::int32 var_638 = 0;
        wp::vec_t<3, wp::float32> var_639;
        wp::int32 var_640;
        wp::uint8 var_641;
        wp::vec_t<3, wp::float32> var_642;
        wp::int32 var_643;
        wp::int32 var_644;
        //---------
        // forward
        // def fit_pixel_normals_kernel(depth, grid__stride, grid__columns, grid__width, camera__width, camera__height, camera__fx, camera__fy, camera__cx, camera__cy, R, fill, normals, valid):       <L 1>
        // i = tid()                                                                              <L 4>
        var_0 = builtin_tid1d();
        // groups = (grid__columns + LANES - 1) // LANES                                          <L 5>
        var_2 = wp::add(var_grid__columns, var_1);
        var_4 = wp::sub(var_2, var_3);
        var_5 = wp::floordiv(var_4, var_1);
        // first = i % groups * LANES                                                             <L 6>
        var_6 = wp::mod(var_0, var_5);
        var_7 = wp::mul(var_6, var_1);
        // row = i // groups                                                                      <L 7>
        var_8 = wp::floordiv(var_0, var_5);
        // v = row * grid__stride                                                                 <L 8>
        var_9 = wp::mul(var_8, var_grid__stride);
        // line = v * grid__width                                                                 <L 9>
        var_10 = wp::mul(var_9, var_grid__width);
        // below = min(v + grid__stride, camera__height - 1) * grid__width                        <L 10>
        var_11 = wp::add(var_9, var_grid__stride);
        var_13 = wp::sub(var_camera__height, var_12);
        var_14 = wp::min(var_11, var_13);
        var_15 = wp::mul(var_14, var_grid__width);
        // x = octet(0.0)                                                                         <L 11>
        var_17 = wp::vec_t<8, wp::float32>(var_16);
        // y = octet(0.0)                                                                         <L 12>
        var_19 = wp::vec_t<8, wp::float32>(var_18);
        // z = octet(0.0)                                                                         <L 13>
        var_21 = wp::vec_t<8, wp::float32>(var_20);
        // for lane in range(LANES):                                                              <L 14>
        // u = min((first + lane) * grid__stride, camera__width - 1)                              <L 15>
        var_23 = wp::add(var_7, var_22);
        var_24 = wp::mul(var_23, var_grid__stride);
        var_26 = wp::sub(var_camera__width, var_25);
        var_27 = wp::min(var_24, var_26);
        // right = min(u + grid__stride, camera__width - 1)                                       <L 16>
        var_28 = wp::add(var_27, var_grid__stride);
        var_30 = wp::sub(var_camera__width, var_29);
        var_31 = wp::min(var_28, var_30);
        // depths = vec3(depth[line + u], depth[line + right], depth[below + u])                  <L 17>
        var_32 = wp::add(var_10, var_27);
        var_33 = wp::address(var_depth, var_32);
        var_34 = wp::add(var_10, var_31);
        var_35 = wp::address(var_depth, var_34);
        var_36 = wp::add(var_15, var_27);
        var_37 = wp::address(var_depth, var_36);
        var_39 = wp::load(var_33);
        var_40 = wp::load(var_35);
        var_41 = wp::load(var_37);
        var_38 = wp::vec_t<3, wp::float32>(var_39, var_40, var_41);
        // m = meet_neighbors(u, v, depths, grid__stride, camera__fx, camera__fy, camera__cx, camera__cy)       <L 18>
        var_42 = meet_neighbors_0(var_27, var_9, var_38, var_grid__stride, var_camera__fx, var_camera__fy, var_camera__cx, var_camera__cy);
        // size = dot(m, m)                                                                       <L 19>
        var_43 = wp::dot(var_42, var_42);
        // n = narrow(R @ (m / sqrt(size)))                                                       <L 20>
        var_44 = wp::sqrt(var_43);
        var_45 = wp::div(var_42, var_44);
        var_46 = wp::mul(var_R, var_45);
        var_47 = narrow_0(var_46);
        // inside = u + grid__stride < camera__width and v + grid__stride < camera__height        <L 21>
        var_49 = wp::add(var_27, var_grid__stride);
        var_50 = (var_49 < var_camera__width);
        var_48 = var_50;
        if (var_48) {
            var_51 = wp::add(var_9, var_grid__stride);
            var_52 = (var_51 < var_camera__height);
            var_48 = var_48 && var_52;
        }
        // good = inside and size > float64(0.0) and (min(min(depths[0], depths[1]), depths[2]) > 0.0)       <L 22>
        var_53 = var_48;
        if (var_53) {
            var_54 = 0.0;
            var_55 = (var_43 > var_54);
            var_53 = var_53 && var_55;
        }
        if (var_53) {
            var_57 = wp::extract(var_38, var_56);
            var_59 = wp::extract(var_38, var_58);
            var_60 = wp::min(var_57, var_59);
            var_62 = wp::extract(var_38, var_61);
            var_63 = wp::min(var_60, var_62);
            var_65 = (var_63 > var_64);
            var_53 = var_53 && var_65;
        }
        // x[lane] = n[0] if good else float(NAN)                                                 <L 23>
        if (var_53) {
            var_67 = wp::extract(var_47, var_66);
        }
        if (!var_53) {
            var_69 = wp::float(var_68);
        }
        var_70 = wp::where(var_53, var_67, var_69);
        wp::assign_inplace(var_17, var_22, var_70);
        // y[lane] = n[1] if good else float(NAN)                                                 <L 24>
        if (var_53) {
            var_72 = wp::extract(var_47, var_71);
        }
        if (!var_53) {
            var_73 = wp::float(var_68);
        }
        var_74 = wp::where(var_53, var_72, var_73);
        wp::assign_inplace(var_19, var_22, var_74);
        // z[lane] = n[2] if good else float(NAN)                                                 <L 25>
        if (var_53) {
            var_76 = wp::extract(var_47, var_75);
        }
        if (!var_53) {
            var_77 = wp::float(var_68);
        }
        var_78 = wp::where(var_53, var_76, var_77);
        wp::assign_inplace(var_21, var_22, var_78);
        // u = min((first + lane) * grid__stride, camera__width - 1)                              <L 15>
        var_80 = wp::add(var_7, var_79);
        var_81 = wp::mul(var_80, var_grid__stride);
        var_83 = wp::sub(var_camera__width, var_82);
        var_84 = wp::min(var_81, var_83);
        // right = min(u + grid__stride, camera__width - 1)                                       <L 16>
        var_85 = wp::add(var_84, var_grid__stride);
        var_87 = wp::sub(var_camera__width, var_86);
        var_88 = wp::min(var_85, var_87);
        // depths = vec3(depth[line + u], depth[line + right], depth[below + u])                  <L 17>
        var_89 = wp::add(var_10, var_84);
        var_90 = wp::address(var_depth, var_89);
        var_91 = wp::add(var_10, var_88);
        var_92 = wp::address(var_depth, var_91);
        var_93 = wp::add(var_15, var_84);
        var_94 = wp::address(var_depth, var_93);
        var_96 = wp::load(var_90);
        var_97 = wp::load(var_92);
        var_98 = wp::load(var_94);
        var_95 = wp::vec_t<3, wp::float32>(var_96, var_97, var_98);
        // m = meet_neighbors(u, v, depths, grid__stride, camera__fx, camera__fy, camera__cx, camera__cy)       <L 18>
        var_99 = meet_neighbors_0(var_84, var_9, var_95, var_grid__stride, var_camera__fx, var_camera__fy, var_camera__cx, var_camera__cy);
        // size = dot(m, m)                                                                       <L 19>
        var_100 = wp::dot(var_99, var_99);
        // n = narrow(R @ (m / sqrt(size)))                                                       <L 20>
        var_101 = wp::sqrt(var_100);
        var_102 = wp::div(var_99, var_101);
        var_103 = wp::mul(var_R, var_102);
        var_104 = narrow_0(var_103);
        // inside = u + grid__stride < camera__width and v + grid__stride < camera__height        <L 21>
        var_106 = wp::add(var_84, var_grid__stride);
        var_107 = (var_106 < var_camera__width);
        var_105 = var_107;
        if (var_105) {
            var_108 = wp::add(var_9, var_grid__stride);
            var_109 = (var_108 < var_camera__height);
            var_105 = var_105 && var_109;
        }
        // good = inside and size > float64(0.0) and (min(min(depths[0], depths[1]), depths[2]) > 0.0)       <L 22>
        var_110 = var_105;
        if (var_110) {
            var_111 = 0.0;
            var_112 = (var_100 > var_111);
            var_110 = var_110 && var_112;
        }
        if (var_110) {
            var_114 = wp::extract(var_95, var_113);
            var_116 = wp::extract(var_95, var_115);
            var_117 = wp::min(var_114, var_116);
            var_119 = wp::extract(var_95, var_118);
            var_120 = wp::min(var_117, var_119);
            var_122 = (var_120 > var_121);
            var_110 = var_110 && var_122;
        }
        // x[lane] = n[0] if good else float(NAN)                                                 <L 23>
        if (var_110) {
            var_124 = wp::extract(var_104, var_123);
        }
        if (!var_110) {
            var_125 = wp::float(var_68);
        }
        var_126 = wp::where(var_110, var_124, var_125);
        wp::assign_inplace(var_17, var_79, var_126);
        // y[lane] = n[1] if good else float(NAN)                                                 <L 24>
        if (var_110) {
            var_128 = wp::extract(var_104, var_127);
        }
        if (!var_110) {
            var_129 = wp::float(var_68);
        }
        var_130 = wp::where(var_110, var_128, var_129);
        wp::assign_inplace(var_19, var_79, var_130);
        // z[lane] = n[2] if good else float(NAN)                                                 <L 25>
        if (var_110) {
            var_132 = wp::extract(var_104, var_131);
        }
        if (!var_110) {
            var_133 = wp::float(var_68);
        }
        var_134 = wp::where(var_110, var_132, var_133);
        wp::assign_inplace(var_21, var_79, var_134);
        // u = min((first + lane) * grid__stride, camera__width - 1)                              <L 15>
        var_136 = wp::add(var_7, var_135);
        var_137 = wp::mul(var_136, var_grid__stride);
        var_139 = wp::sub(var_camera__width, var_138);
        var_140 = wp::min(var_137, var_139);
        // right = min(u + grid__stride, camera__width - 1)                                       <L 16>
        var_141 = wp::add(var_140, var_grid__stride);
        var_143 = wp::sub(var_camera__width, var_142);
        var_144 = wp::min(var_141, var_143);
        // depths = vec3(depth[line + u], depth[line + right], depth[below + u])                  <L 17>
        var_145 = wp::add(var_10, var_140);
        var_146 = wp::address(var_depth, var_145);
        var_147 = wp::add(var_10, var_144);
        var_148 = wp::address(var_depth, var_147);
        var_149 = wp::add(var_15, var_140);
        var_150 = wp::address(var_depth, var_149);
        var_152 = wp::load(var_146);
        var_153 = wp::load(var_148);
        var_154 = wp::load(var_150);
        var_151 = wp::vec_t<3, wp::float32>(var_152, var_153, var_154);
        // m = meet_neighbors(u, v, depths, grid__stride, camera__fx, camera__fy, camera__cx, camera__cy)       <L 18>
        var_155 = meet_neighbors_0(var_140, var_9, var_151, var_grid__stride, var_camera__fx, var_camera__fy, var_camera__cx, var_camera__cy);
        // size = dot(m, m)                                                                       <L 19>
        var_156 = wp::dot(var_155, var_155);
        // n = narrow(R @ (m / sqrt(size)))                                                       <L 20>
        var_157 = wp::sqrt(var_156);
        var_158 = wp::div(var_155, var_157);
        var_159 = wp::mul(var_R, var_158);
        var_160 = narrow_0(var_159);
        // inside = u + grid__stride < camera__width and v + grid__stride < camera__height        <L 21>
        var_162 = wp::add(var_140, var_grid__stride);
        var_163 = (var_162 < var_camera__width);
        var_161 = var_163;
        if (var_161) {
            var_164 = wp::add(var_9, var_grid__stride);
            var_165 = (var_164 < var_camera__height);
            var_161 = var_161 && var_165;
        }
        // good = inside and size > float64(0.0) and (min(min(depths[0], depths[1]), depths[2]) > 0.0)       <L 22>
        var_166 = var_161;
        if (var_166) {
            var_167 = 0.0;
            var_168 = (var_156 > var_167);
            var_166 = var_166 && var_168;
        }
        if (var_166) {
            var_170 = wp::extract(var_151, var_169);
            var_172 = wp::extract(var_151, var_171);
            var_173 = wp::min(var_170, var_172);
            var_175 = wp::extract(var_151, var_174);
            var_176 = wp::min(var_173, var_175);
            var_178 = (var_176 > var_177);
            var_166 = var_166 && var_178;
        }
        // x[lane] = n[0] if good else float(NAN)                                                 <L 23>
        if (var_166) {
            var_180 = wp::extract(var_160, var_179);
        }
        if (!var_166) {
            var_181 = wp::float(var_68);
        }
        var_182 = wp::where(var_166, var_180, var_181);
        wp::assign_inplace(var_17, var_135, var_182);
        // y[lane] = n[1] if good else float(NAN)                                                 <L 24>
        if (var_166) {
            var_184 = wp::extract(var_160, var_183);
        }
        if (!var_166) {
            var_185 = wp::float(var_68);
        }
        var_186 = wp::where(var_166, var_184, var_185);
        wp::assign_inplace(var_19, var_135, var_186);
        // z[lane] = n[2] if good else float(NAN)                                                 <L 25>
        if (var_166) {
            var_188 = wp::extract(var_160, var_187);
        }
        if (!var_166) {
            var_189 = wp::float(var_68);
        }
        var_190 = wp::where(var_166, var_188, var_189);
        wp::assign_inplace(var_21, var_135, var_190);
        // u = min((first + lane) * grid__stride, camera__width - 1)                              <L 15>
        var_192 = wp::add(var_7, var_191);
        var_193 = wp::mul(var_192, var_grid__stride);
        var_195 = wp::sub(var_camera__width, var_194);
        var_196 = wp::min(var_193, var_195);
        // right = min(u + grid__stride, camera__width - 1)                                       <L 16>
        var_197 = wp::add(var_196, var_grid__stride);
        var_199 = wp::sub(var_camera__width, var_198);
        var_200 = wp::min(var_197, var_199);
        // depths = vec3(depth[line + u], depth[line + right], depth[below + u])                  <L 17>
        var_201 = wp::add(var_10, var_196);
        var_202 = wp::address(var_depth, var_201);
        var_203 = wp::add(var_10, var_200);
        var_204 = wp::address(var_depth, var_203);
        var_205 = wp::add(var_15, var_196);
        var_206 = wp::address(var_depth, var_205);
        var_208 = wp::load(var_202);
        var_209 = wp::load(var_204);
        var_210 = wp::load(var_206);
        var_207 = wp::vec_t<3, wp::float32>(var_208, var_209, var_210);
        // m = meet_neighbors(u, v, depths, grid__stride, camera__fx, camera__fy, camera__cx, camera__cy)       <L 18>
        var_211 = meet_neighbors_0(var_196, var_9, var_207, var_grid__stride, var_camera__fx, var_camera__fy, var_camera__cx, var_camera__cy);
        // size = dot(m, m)                                                                       <L 19>
        var_212 = wp::dot(var_211, var_211);
        // n = narrow(R @ (m / sqrt(size)))                                                       <L 20>
        var_213 = wp::sqrt(var_212);
        var_214 = wp::div(var_211, var_213);
        var_215 = wp::mul(var_R, var_214);
        var_216 = narrow_0(var_215);
        // inside = u + grid__stride < camera__width and v + grid__stride < camera__height        <L 21>
        var_218 = wp::add(var_196, var_grid__stride);
        var_219 = (var_218 < var_camera__width);
        var_217 = var_219;
        if (var_217) {
            var_220 = wp::add(var_9, var_grid__stride);
            var_221 = (var_220 < var_camera__height);
            var_217 = var_217 && var_221;
        }
        // good = inside and size > float64(0.0) and (min(min(depths[0], depths[1]), depths[2]) > 0.0)       <L 22>
        var_222 = var_217;
        if (var_222) {
            var_223 = 0.0;
            var_224 = (var_212 > var_223);
            var_222 = var_222 && var_224;
        }
        if (var_222) {
            var_226 = wp::extract(var_207, var_225);
            var_228 = wp::extract(var_207, var_227);
            var_229 = wp::min(var_226, var_228);
            var_231 = wp::extract(var_207, var_230);
            var_232 = wp::min(var_229, var_231);
            var_234 = (var_232 > var_233);
            var_222 = var_222 && var_234;
        }
        // x[lane] = n[0] if good else float(NAN)                                                 <L 23>
        if (var_222) {
            var_236 = wp::extract(var_216, var_235);
        }
        if (!var_222) {
            var_237 = wp::float(var_68);
        }
        var_238 = wp::where(var_222, var_236, var_237);
        wp::assign_inplace(var_17, var_191, var_238);
        // y[lane] = n[1] if good else float(NAN)                                                 <L 24>
        if (var_222) {
            var_240 = wp::extract(var_216, var_239);
        }
        if (!var_222) {
            var_241 = wp::float(var_68);
        }
        var_242 = wp::where(var_222, var_240, var_241);
        wp::assign_inplace(var_19, var_191, var_242);
        // z[lane] = n[2] if good else float(NAN)                                                 <L 25>
        if (var_222) {
            var_244 = wp::extract(var_216, var_243);
        }
        if (!var_222) {
            var_245 = wp::float(var_68);
        }
        var_246 = wp::where(var_222, var_244, var_245);
        wp::assign_inplace(var_21, var_191, var_246);
        // u = min((first + lane) * grid__stride, camera__width - 1)                              <L 15>
        var_248 = wp::add(var_7, var_247);
        var_249 = wp::mul(var_248, var_grid__stride);
        var_251 = wp::sub(var_camera__width, var_250);
        var_252 = wp::min(var_249, var_251);
        // right = min(u + grid__stride, camera__width - 1)                                       <L 16>
        var_253 = wp::add(var_252, var_grid__stride);
        var_255 = wp::sub(var_camera__width, var_254);
        var_256 = wp::min(var_253, var_255);
        // depths = vec3(depth[line + u], depth[line + right], depth[below + u])                  <L 17>
        var_257 = wp::add(var_10, var_252);
        var_258 = wp::address(var_depth, var_257);
        var_259 = wp::add(var_10, var_256);
        var_260 = wp::address(var_depth, var_259);
        var_261 = wp::add(var_15, var_252);
        var_262 = wp::address(var_depth, var_261);
        var_264 = wp::load(var_258);
        var_265 = wp::load(var_260);
        var_266 = wp::load(var_262);
        var_263 = wp::vec_t<3, wp::float32>(var_264, var_265, var_266);
        // m = meet_neighbors(u, v, depths, grid__stride, camera__fx, camera__fy, camera__cx, camera__cy)       <L 18>
        var_267 = meet_neighbors_0(var_252, var_9, var_263, var_grid__stride, var_camera__fx, var_camera__fy, var_camera__cx, var_camera__cy);
        // size = dot(m, m)                                                                       <L 19>
        var_268 = wp::dot(var_267, var_267);
        // n = narrow(R @ (m / sqrt(size)))                                                       <L 20>
        var_269 = wp::sqrt(var_268);
        var_270 = wp::div(var_267, var_269);
        var_271 = wp::mul(var_R, var_270);
        var_272 = narrow_0(var_271);
        // inside = u + grid__stride < camera__width and v + grid__stride < camera__height        <L 21>
        var_274 = wp::add(var_252, var_grid__stride);
        var_275 = (var_274 < var_camera__width);
        var_273 = var_275;
        if (var_273) {
            var_276 = wp::add(var_9, var_grid__stride);
            var_277 = (var_276 < var_camera__height);
            var_273 = var_273 && var_277;
        }
        // good = inside and size > float64(0.0) and (min(min(depths[0], depths[1]), depths[2]) > 0.0)       <L 22>
        var_278 = var_273;
        if (var_278) {
            var_279 = 0.0;
            var_280 = (var_268 > var_279);
            var_278 = var_278 && var_280;
        }
        if (var_278) {
            var_282 = wp::extract(var_263, var_281);
            var_284 = wp::extract(var_263, var_283);
            var_285 = wp::min(var_282, var_284);
            var_287 = wp::extract(var_263, var_286);
            var_288 = wp::min(var_285, var_287);
            var_290 = (var_288 > var_289);
            var_278 = var_278 && var_290;
        }
        // x[lane] = n[0] if good else float(NAN)                                                 <L 23>
        if (var_278) {
            var_292 = wp::extract(var_272, var_291);
        }
        if (!var_278) {
            var_293 = wp::float(var_68);
        }
        var_294 = wp::where(var_278, var_292, var_293);
        wp::assign_inplace(var_17, var_247, var_294);
        // y[lane] = n[1] if good else float(NAN)                                                 <L 24>
        if (var_278) {
            var_296 = wp::extract(var_272, var_295);
        }
        if (!var_278) {
            var_297 = wp::float(var_68);
        }
        var_298 = wp::where(var_278, var_296, var_297);
        wp::assign_inplace(var_19, var_247, var_298);
        // z[lane] = n[2] if good else float(NAN)                                                 <L 25>
        if (var_278) {
            var_300 = wp::extract(var_272, var_299);
        }
        if (!var_278) {
            var_301 = wp::float(var_68);
        }
        var_302 = wp::where(var_278, var_300, var_301);
        wp::assign_inplace(var_21, var_247, var_302);
        // u = min((first + lane) * grid__stride, camera__width - 1)                              <L 15>
        var_304 = wp::add(var_7, var_303);
        var_305 = wp::mul(var_304, var_grid__stride);
        var_307 = wp::sub(var_camera__width, var_306);
        var_308 = wp::min(var_305, var_307);
        // right = min(u + grid__stride, camera__width - 1)                                       <L 16>
        var_309 = wp::add(var_308, var_grid__stride);
        var_311 = wp::sub(var_camera__width, var_310);
        var_312 = wp::min(var_309, var_311);
        // depths = vec3(depth[line + u], depth[line + right], depth[below + u])                  <L 17>
        var_313 = wp::add(var_10, var_308);
        var_314 = wp::address(var_depth, var_313);
        var_315 = wp::add(var_10, var_312);
        var_316 = wp::address(var_depth, var_315);
        var_317 = wp::add(var_15, var_308);
        var_318 = wp::address(var_depth, var_317);
        var_320 = wp::load(var_314);
        var_321 = wp::load(var_316);
        var_322 = wp::load(var_318);
        var_319 = wp::vec_t<3, wp::float32>(var_320, var_321, var_322);
        // m = meet_neighbors(u, v, depths, grid__stride, camera__fx, camera__fy, camera__cx, camera__cy)       <L 18>
        var_323 = meet_neighbors_0(var_308, var_9, var_319, var_grid__stride, var_camera__fx, var_camera__fy, var_camera__cx, var_camera__cy);
        // size = dot(m, m)                                                                       <L 19>
        var_324 = wp::dot(var_323, var_323);
        // n = narrow(R @ (m / sqrt(size)))                                                       <L 20>
        var_325 = wp::sqrt(var_324);
        var_326 = wp::div(var_323, var_325);
        var_327 = wp::mul(var_R, var_326);
        var_328 = narrow_0(var_327);
        // inside = u + grid__stride < camera__width and v + grid__stride < camera__height        <L 21>
        var_330 = wp::add(var_308, var_grid__stride);
        var_331 = (var_330 < var_camera__width);
        var_329 = var_331;
        if (var_329) {
            var_332 = wp::add(var_9, var_grid__stride);
            var_333 = (var_332 < var_camera__height);
            var_329 = var_329 && var_333;
        }
        // good = inside and size > float64(0.0) and (min(min(depths[0], depths[1]), depths[2]) > 0.0)       <L 22>
        var_334 = var_329;
        if (var_334) {
            var_335 = 0.0;
            var_336 = (var_324 > var_335);
            var_334 = var_334 && var_336;
        }
        if (var_334) {
            var_338 = wp::extract(var_319, var_337);
            var_340 = wp::extract(var_319, var_339);
            var_341 = wp::min(var_338, var_340);
            var_343 = wp::extract(var_319, var_342);
            var_344 = wp::min(var_341, var_343);
            var_346 = (var_344 > var_345);
            var_334 = var_334 && var_346;
        }
        // x[lane] = n[0] if good else float(NAN)                                                 <L 23>
        if (var_334) {
            var_348 = wp::extract(var_328, var_347);
        }
        if (!var_334) {
            var_349 = wp::float(var_68);
        }
        var_350 = wp::where(var_334, var_348, var_349);
        wp::assign_inplace(var_17, var_303, var_350);
        // y[lane] = n[1] if good else float(NAN)                                                 <L 24>
        if (var_334) {
            var_352 = wp::extract(var_328, var_351);
        }
        if (!var_334) {
            var_353 = wp::float(var_68);
        }
        var_354 = wp::where(var_334, var_352, var_353);
        wp::assign_inplace(var_19, var_303, var_354);
        // z[lane] = n[2] if good else float(NAN)                                                 <L 25>
        if (var_334) {
            var_356 = wp::extract(var_328, var_355);
        }
        if (!var_334) {
            var_357 = wp::float(var_68);
        }
        var_358 = wp::where(var_334, var_356, var_357);
        wp::assign_inplace(var_21, var_303, var_358);
        // u = min((first + lane) * grid__stride, camera__width - 1)                              <L 15>
        var_360 = wp::add(var_7, var_359);
        var_361 = wp::mul(var_360, var_grid__stride);
        var_363 = wp::sub(var_camera__width, var_362);
        var_364 = wp::min(var_361, var_363);
        // right = min(u + grid__stride, camera__width - 1)                                       <L 16>
        var_365 = wp::add(var_364, var_grid__stride);
        var_367 = wp::sub(var_camera__width, var_366);
        var_368 = wp::min(var_365, var_367);
        // depths = vec3(depth[line + u], depth[line + right], depth[below + u])                  <L 17>
        var_369 = wp::add(var_10, var_364);
        var_370 = wp::address(var_depth, var_369);
        var_371 = wp::add(var_10, var_368);
        var_372 = wp::address(var_depth, var_371);
        var_373 = wp::add(var_15, var_364);
        var_374 = wp::address(var_depth, var_373);
        var_376 = wp::load(var_370);
        var_377 = wp::load(var_372);
        var_378 = wp::load(var_374);
        var_375 = wp::vec_t<3, wp::float32>(var_376, var_377, var_378);
        // m = meet_neighbors(u, v, depths, grid__stride, camera__fx, camera__fy, camera__cx, camera__cy)       <L 18>
        var_379 = meet_neighbors_0(var_364, var_9, var_375, var_grid__stride, var_camera__fx, var_camera__fy, var_camera__cx, var_camera__cy);
        // size = dot(m, m)                                                                       <L 19>
        var_380 = wp::dot(var_379, var_379);
        // n = narrow(R @ (m / sqrt(size)))                                                       <L 20>
        var_381 = wp::sqrt(var_380);
        var_382 = wp::div(var_379, var_381);
        var_383 = wp::mul(var_R, var_382);
        var_384 = narrow_0(var_383);
        // inside = u + grid__stride < camera__width and v + grid__stride < camera__height        <L 21>
        var_386 = wp::add(var_364, var_grid__stride);
        var_387 = (var_386 < var_camera__width);
        var_385 = var_387;
        if (var_385) {
            var_388 = wp::add(var_9, var_grid__stride);
            var_389 = (var_388 < var_camera__height);
            var_385 = var_385 && var_389;
        }
        // good = inside and size > float64(0.0) and (min(min(depths[0], depths[1]), depths[2]) > 0.0)       <L 22>
        var_390 = var_385;
        if (var_390) {
            var_391 = 0.0;
            var_392 = (var_380 > var_391);
            var_390 = var_390 && var_392;
        }
        if (var_390) {
            var_394 = wp::extract(var_375, var_393);
            var_396 = wp::extract(var_375, var_395);
            var_397 = wp::min(var_394, var_396);
            var_399 = wp::extract(var_375, var_398);
            var_400 = wp::min(var_397, var_399);
            var_402 = (var_400 > var_401);
            var_390 = var_390 && var_402;
        }
        // x[lane] = n[0] if good else float(NAN)                                                 <L 23>
        if (var_390) {
            var_404 = wp::extract(var_384, var_403);
        }
        if (!var_390) {
            var_405 = wp::float(var_68);
        }
        var_406 = wp::where(var_390, var_404, var_405);
        wp::assign_inplace(var_17, var_359, var_406);
        // y[lane] = n[1] if good else float(NAN)                                                 <L 24>
        if (var_390) {
            var_408 = wp::extract(var_384, var_407);
        }
        if (!var_390) {
            var_409 = wp::float(var_68);
        }
        var_410 = wp::where(var_390, var_408, var_409);
        wp::assign_inplace(var_19, var_359, var_410);
        // z[lane] = n[2] if good else float(NAN)                                                 <L 25>
        if (var_390) {
            var_412 = wp::extract(var_384, var_411);
        }
        if (!var_390) {
            var_413 = wp::float(var_68);
        }
        var_414 = wp::where(var_390, var_412, var_413);
        wp::assign_inplace(var_21, var_359, var_414);
        // u = min((first + lane) * grid__stride, camera__width - 1)                              <L 15>
        var_416 = wp::add(var_7, var_415);
        var_417 = wp::mul(var_416, var_grid__stride);
        var_419 = wp::sub(var_camera__width, var_418);
        var_420 = wp::min(var_417, var_419);
        // right = min(u + grid__stride, camera__width - 1)                                       <L 16>
        var_421 = wp::add(var_420, var_grid__stride);
        var_423 = wp::sub(var_camera__width, var_422);
        var_424 = wp::min(var_421, var_423);
        // depths = vec3(depth[line + u], depth[line + right], depth[below + u])                  <L 17>
        var_425 = wp::add(var_10, var_420);
        var_426 = wp::address(var_depth, var_425);
        var_427 = wp::add(var_10, var_424);
        var_428 = wp::address(var_depth, var_427);
        var_429 = wp::add(var_15, var_420);
        var_430 = wp::address(var_depth, var_429);
        var_432 = wp::load(var_426);
        var_433 = wp::load(var_428);
        var_434 = wp::load(var_430);
        var_431 = wp::vec_t<3, wp::float32>(var_432, var_433, var_434);
        // m = meet_neighbors(u, v, depths, grid__stride, camera__fx, camera__fy, camera__cx, camera__cy)       <L 18>
        var_435 = meet_neighbors_0(var_420, var_9, var_431, var_grid__stride, var_camera__fx, var_camera__fy, var_camera__cx, var_camera__cy);
        // size = dot(m, m)                                                                       <L 19>
        var_436 = wp::dot(var_435, var_435);
        // n = narrow(R @ (m / sqrt(size)))                                                       <L 20>
        var_437 = wp::sqrt(var_436);
        var_438 = wp::div(var_435, var_437);
        var_439 = wp::mul(var_R, var_438);
        var_440 = narrow_0(var_439);
        // inside = u + grid__stride < camera__width and v + grid__stride < camera__height        <L 21>
        var_442 = wp::add(var_420, var_grid__stride);
        var_443 = (var_442 < var_camera__width);
        var_441 = var_443;
        if (var_441) {
            var_444 = wp::add(var_9, var_grid__stride);
            var_445 = (var_444 < var_camera__height);
            var_441 = var_441 && var_445;
        }
        // good = inside and size > float64(0.0) and (min(min(depths[0], depths[1]), depths[2]) > 0.0)       <L 22>
        var_446 = var_441;
        if (var_446) {
            var_447 = 0.0;
            var_448 = (var_436 > var_447);
            var_446 = var_446 && var_448;
        }
        if (var_446) {
            var_450 = wp::extract(var_431, var_449);
            var_452 = wp::extract(var_431, var_451);
            var_453 = wp::min(var_450, var_452);
            var_455 = wp::extract(var_431, var_454);
            var_456 = wp::min(var_453, var_455);
            var_458 = (var_456 > var_457);
            var_446 = var_446 && var_458;
        }
        // x[lane] = n[0] if good else float(NAN)                                                 <L 23>
        if (var_446) {
            var_460 = wp::extract(var_440, var_459);
        }
        if (!var_446) {
            var_461 = wp::float(var_68);
        }
        var_462 = wp::where(var_446, var_460, var_461);
        wp::assign_inplace(var_17, var_415, var_462);
        // y[lane] = n[1] if good else float(NAN)                                                 <L 24>
        if (var_446) {
            var_464 = wp::extract(var_440, var_463);
        }
        if (!var_446) {
            var_465 = wp::float(var_68);
        }
        var_466 = wp::where(var_446, var_464, var_465);
        wp::assign_inplace(var_19, var_415, var_466);
        // z[lane] = n[2] if good else float(NAN)                                                 <L 25>
        if (var_446) {
            var_468 = wp::extract(var_440, var_467);
        }
        if (!var_446) {
            var_469 = wp::float(var_68);
        }
        var_470 = wp::where(var_446, var_468, var_469);
        wp::assign_inplace(var_21, var_415, var_470);
        // for lane in range(LANES):                                                              <L 26>
        // if first + lane < grid__columns:                                                       <L 27>
        var_472 = wp::add(var_7, var_471);
        var_473 = (var_472 < var_grid__columns);
        if (var_473) {
            // at = row * grid__columns + first + lane                                            <L 28>
            var_474 = wp::mul(var_8, var_grid__columns);
            var_475 = wp::add(var_474, var_7);
            var_476 = wp::add(var_475, var_471);
            // n = vec3(x[lane], y[lane], z[lane])                                                <L 29>
            var_477 = wp::extract(var_17, var_471);
            var_478 = wp::extract(var_19, var_471);
            var_479 = wp::extract(var_21, var_471);
            var_480 = wp::vec_t<3, wp::float32>(var_477, var_478, var_479);
            // fitted = int(1)                                                                    <L 30>
            var_482 = wp::int(var_481);
            // if not isfinite(n):                                                                <L 31>
            var_483 = wp::isfinite(var_480);
            var_484 = wp::unot(var_483);
            if (var_484) {
                // n = vec3(fill, fill, fill)                                                     <L 32>
                var_485 = wp::vec_t<3, wp::float32>(var_fill, var_fill, var_fill);
                // fitted = 0                                                                     <L 33>
            }
            var_487 = wp::where(var_484, var_485, var_480);
            var_488 = wp::where(var_484, var_486, var_482);
            // normals[at] = n                                                                    <L 34>
            wp::array_store(var_normals, var_476, var_487);
            // valid[at] = uint8(fitted)                                                          <L 35>
            var_489 = wp::uint8(var_488);
            wp::array_store(var_valid, var_476, var_489);
        }
        var_490 = wp::where(var_473, var_487, var_440);
        // if first + lane < grid__columns:                                                       <L 27>
        var_492 = wp::add(var_7, var_491);
        var_493 = (var_492 < var_grid__columns);
        if (var_493) {
            // at = row * grid__columns + first + lane                                            <L 28>
            var_494 = wp::mul(var_8, var_grid__columns);
            var_495 = wp::add(var_494, var_7);
            var_496 = wp::add(var_495, var_491);
            // n = vec3(x[lane], y[lane], z[lane])                                                <L 29>
            var_497 = wp::extract(var_17, var_491);
            var_498 = wp::extract(var_19, var_491);
            var_499 = wp::extract(var_21, var_491);
            var_500 = wp::vec_t<3, wp::float32>(var_497, var_498, var_499);
            // fitted = int(1)                                                                    <L 30>
            var_502 = wp::int(var_501);
            // if not isfinite(n):                                                                <L 31>
            var_503 = wp::isfinite(var_500);
            var_504 = wp::unot(var_503);
            if (var_504) {
                // n = vec3(fill, fill, fill)                                                     <L 32>
                var_505 = wp::vec_t<3, wp::float32>(var_fill, var_fill, var_fill);
                // fitted = 0                                                                     <L 33>
            }
            var_507 = wp::where(var_504, var_505, var_500);
            var_508 = wp::where(var_504, var_506, var_502);
            // normals[at] = n                                                                    <L 34>
            wp::array_store(var_normals, var_496, var_507);
            // valid[at] = uint8(fitted)                                                          <L 35>
            var_509 = wp::uint8(var_508);
            wp::array_store(var_valid, var_496, var_509);
        }
        var_510 = wp::where(var_493, var_507, var_490);
        var_511 = wp::where(var_493, var_496, var_476);
        var_512 = wp::where(var_493, var_508, var_488);
        // if first + lane < grid__columns:                                                       <L 27>
        var_514 = wp::add(var_7, var_513);
        var_515 = (var_514 < var_grid__columns);
        if (var_515) {
            // at = row * grid__columns + first + lane                                            <L 28>
            var_516 = wp::mul(var_8, var_grid__columns);
            var_517 = wp::add(var_516, var_7);
            var_518 = wp::add(var_517, var_513);
            // n = vec3(x[lane], y[lane], z[lane])                                                <L 29>
            var_519 = wp::extract(var_17, var_513);
            var_520 = wp::extract(var_19, var_513);
            var_521 = wp::extract(var_21, var_513);
            var_522 = wp::vec_t<3, wp::float32>(var_519, var_520, var_521);
            // fitted = int(1)                                                                    <L 30>
            var_524 = wp::int(var_523);
            // if not isfinite(n):                                                                <L 31>
            var_525 = wp::isfinite(var_522);
            var_526 = wp::unot(var_525);
            if (var_526) {
                // n = vec3(fill, fill, fill)                                                     <L 32>
                var_527 = wp::vec_t<3, wp::float32>(var_fill, var_fill, var_fill);
                // fitted = 0                                                                     <L 33>
            }
            var_529 = wp::where(var_526, var_527, var_522);
            var_530 = wp::where(var_526, var_528, var_524);
            // normals[at] = n                                                                    <L 34>
            wp::array_store(var_normals, var_518, var_529);
            // valid[at] = uint8(fitted)                                                          <L 35>
            var_531 = wp::uint8(var_530);
            wp::array_store(var_valid, var_518, var_531);
        }
        var_532 = wp::where(var_515, var_529, var_510);
        var_533 = wp::where(var_515, var_518, var_511);
        var_534 = wp::where(var_515, var_530, var_512);
        // if first + lane < grid__columns:                                                       <L 27>
        var_536 = wp::add(var_7, var_535);
        var_537 = (var_536 < var_grid__columns);
        if (var_537) {
            // at = row * grid__columns + first + lane                                            <L 28>
            var_538 = wp::mul(var_8, var_grid__columns);
            var_539 = wp::add(var_538, var_7);
            var_540 = wp::add(var_539, var_535);
            // n = vec3(x[lane], y[lane], z[lane])                                                <L 29>
            var_541 = wp::extract(var_17, var_535);
            var_542 = wp::extract(var_19, var_535);
            var_543 = wp::extract(var_21, var_535);
            var_544 = wp::vec_t<3, wp::float32>(var_541, var_542, var_543);
            // fitted = int(1)                                                                    <L 30>
            var_546 = wp::int(var_545);
            // if not isfinite(n):                                                                <L 31>
            var_547 = wp::isfinite(var_544);
            var_548 = wp::unot(var_547);
            if (var_548) {
                // n = vec3(fill, fill, fill)                                                     <L 32>
                var_549 = wp::vec_t<3, wp::float32>(var_fill, var_fill, var_fill);
                // fitted = 0                                                                     <L 33>
            }
            var_551 = wp::where(var_548, var_549, var_544);
            var_552 = wp::where(var_548, var_550, var_546);
            // normals[at] = n                                                                    <L 34>
            wp::array_store(var_normals, var_540, var_551);
            // valid[at] = uint8(fitted)                                                          <L 35>
            var_553 = wp::uint8(var_552);
            wp::array_store(var_valid, var_540, var_553);
        }
        var_554 = wp::where(var_537, var_551, var_532);
        var_555 = wp::where(var_537, var_540, var_533);
        var_556 = wp::where(var_537, var_552, var_534);
        // if first + lane < grid__columns:                                                       <L 27>
        var_558 = wp::add(var_7, var_557);
        var_559 = (var_558 < var_grid__columns);
        if (var_559) {
            // at = row * grid__columns + first + lane                                            <L 28>
            var_560 = wp::mul(var_8, var_grid__columns);
            var_561 = wp::add(var_560, var_7);
            var_562 = wp::add(var_561, var_557);
            // n = vec3(x[lane], y[lane], z[lane])                                                <L 29>
            var_563 = wp::extract(var_17, var_557);
            var_564 = wp::extract(var_19, var_557);
            var_565 = wp::extract(var_21, var_557);
            var_566 = wp::vec_t<3, wp::float32>(var_563, var_564, var_565);
            // fitted = int(1)                                                                    <L 30>
            var_568 = wp::int(var_567);
            // if not isfinite(n):                                                                <L 31>
            var_569 = wp::isfinite(var_566);
            var_570 = wp::unot(var_569);
            if (var_570) {
                // n = vec3(fill, fill, fill)                                                     <L 32>
                var_571 = wp::vec_t<3, wp::float32>(var_fill, var_fill, var_fill);
                // fitted = 0                                                                     <L 33>
            }
            var_573 = wp::where(var_570, var_571, var_566);
            var_574 = wp::where(var_570, var_572, var_568);
            // normals[at] = n                                                                    <L 34>
            wp::array_store(var_normals, var_562, var_573);
            // valid[at] = uint8(fitted)                                                          <L 35>
            var_575 = wp::uint8(var_574);
            wp::array_store(var_valid, var_562, var_575);
        }
        var_576 = wp::where(var_559, var_573, var_554);
        var_577 = wp::where(var_559, var_562, var_555);
        var_578 = wp::where(var_559, var_574, var_556);
        // if first + lane < grid__columns:                                                       <L 27>
        var_580 = wp::add(var_7, var_579);
        var_581 = (var_580 < var_grid__columns);
        if (var_581) {
            // at = row * grid__columns + first + lane                                            <L 28>
            var_582 = wp::mul(var_8, var_grid__columns);
            var_583 = wp::add(var_582, var_7);
            var_584 = wp::add(var_583, var_579);
            // n = vec3(x[lane], y[lane], z[lane])                                                <L 29>
            var_585 = wp::extract(var_17, var_579);
            var_586 = wp::extract(var_19, var_579);
            var_587 = wp::extract(var_21, var_579);
            var_588 = wp::vec_t<3, wp::float32>(var_585, var_586, var_587);
            // fitted = int(1)                                                                    <L 30>
            var_590 = wp::int(var_589);
            // if not isfinite(n):                                                                <L 31>
            var_591 = wp::isfinite(var_588);
            var_592 = wp::unot(var_591);
            if (var_592) {
                // n = vec3(fill, fill, fill)                                                     <L 32>
                var_593 = wp::vec_t<3, wp::float32>(var_fill, var_fill, var_fill);
                // fitted = 0                                                                     <L 33>
            }
            var_595 = wp::where(var_592, var_593, var_588);
            var_596 = wp::where(var_592, var_594, var_590);
            // normals[at] = n                                                                    <L 34>
            wp::array_store(var_normals, var_584, var_595);
            // valid[at] = uint8(fitted)                                                          <L 35>
            var_597 = wp::uint8(var_596);
            wp::array_store(var_valid, var_584, var_597);
        }
        var_598 = wp::where(var_581, var_595, var_576);
        var_599 = wp::where(var_581, var_584, var_577);
        var_600 = wp::where(var_581, var_596, var_578);
        // if first + lane < grid__columns:                                                       <L 27>
        var_602 = wp::add(var_7, var_601);
        var_603 = (var_602 < var_grid__columns);
        if (var_603) {
            // at = row * grid__columns + first + lane                                            <L 28>
            var_604 = wp::mul(var_8, var_grid__columns);
            var_605 = wp::add(var_604, var_7);
            var_606 = wp::add(var_605, var_601);
            // n = vec3(x[lane], y[lane], z[lane])                                                <L 29>
            var_607 = wp::extract(var_17, var_601);
            var_608 = wp::extract(var_19, var_601);
            var_609 = wp::extract(var_21, var_601);
            var_610 = wp::vec_t<3, wp::float32>(var_607, var_608, var_609);
            // fitted = int(1)                                                                    <L 30>
            var_612 = wp::int(var_611);
            // if not isfinite(n):                                                                <L 31>
            var_613 = wp::isfinite(var_610);
            var_614 = wp::unot(var_613);
            if (var_614) {
                // n = vec3(fill, fill, fill)                                                     <L 32>
                var_615 = wp::vec_t<3, wp::float32>(var_fill, var_fill, var_fill);
                // fitted = 0                                                                     <L 33>
            }
            var_617 = wp::where(var_614, var_615, var_610);
            var_618 = wp::where(var_614, var_616, var_612);
            // normals[at] = n                                                                    <L 34>
            wp::array_store(var_normals, var_606, var_617);
            // valid[at] = uint8(fitted)                                                          <L 35>
            var_619 = wp::uint8(var_618);
            wp::array_store(var_valid, var_606, var_619);
        }
        var_620 = wp::where(var_603, var_617, var_598);
        var_621 = wp::where(var_603, var_606, var_599);
        var_622 = wp::where(var_603, var_618, var_600);
        // if first + lane < grid__columns:                                                       <L 27>
        var_624 = wp::add(var_7, var_623);
        var_625 = (var_624 < var_grid__columns);
        if (var_625) {
            // at = row * grid__columns + first + lane                                            <L 28>
            var_626 = wp::mul(var_8, var_grid__columns);
            var_627 = wp::add(var_626, var_7);
            var_628 = wp::add(var_627, var_623);
            // n = vec3(x[lane], y[lane], z[lane])                                                <L 29>
            var_629 = wp::extract(var_17, var_623);
            var_630 = wp::extract(var_19, var_623);
            var_631 = wp::extract(var_21, var_623);
            var_632 = wp::vec_t<3, wp::float32>(var_629, var_630, var_631);
            // fitted = int(1)                                                                    <L 30>
            var_634 = wp::int(var_633);
            // if not isfinite(n):                                                                <L 31>
            var_635 = wp::isfinite(var_632);
            var_636 = wp::unot(var_635);
            if (var_636) {
                // n = vec3(fill, fill, fill)                                                     <L 32>
                var_637 = wp::vec_t<3, wp::float32>(var_fill, var_fill, var_fill);
                // fitted = 0                                                                     <L 33>
            }
            var_639 = wp::where(var_636, var_637, var_632);
            var_640 = wp::where(var_636, var_638, var_634);
            // normals[at] = n                                                                    <L 34>
            wp::array_store(var_normals, var_628, var_639);
            // valid[at] = uint8(fitted)                                                          <L 35>
            var_641 = wp::uint8(var_640);
            wp::array_store(var_valid, var_628, var_641);
        }
        var_642 = wp::where(var_625, var_639, var_620);
        var_643 = wp::where(var_625, var_628, var_621);
        var_644 = wp::where(var_625, var_640, var_622);
}



extern "C" __global__ void decode_nyu_kernel_54ab82ee_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::uint16> var_raw,
    wp::array_t<wp::uint16> var_depth)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::uint16* var_1;
        wp::int32 var_2;
        wp::uint16 var_3;
        const wp::int32 var_4 = 255;
        wp::int32 var_5;
        const wp::int32 var_6 = 8;
        wp::int32 var_7;
        const wp::int32 var_8 = 8;
        wp::int32 var_9;
        wp::int32 var_10;
        wp::float64 var_11;
        wp::float64 var_12;
        wp::float64 var_13;
        wp::float64 var_14;
        wp::float64 var_15;
        const wp::int32 var_16 = 0;
        wp::int32 var_17;
        wp::float64 var_18;
        bool var_19;
        wp::float64 var_20;
        wp::float64 var_21;
        wp::float64 var_22;
        wp::float64 var_23;
        wp::float64 var_24;
        wp::int32 var_25;
        const wp::int32 var_26 = 65535;
        wp::int32 var_27;
        wp::int32 var_28;
        wp::uint16 var_29;
        //---------
        // forward
        // def decode_nyu_kernel(raw, depth):                                                     <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // x = int(raw[i])                                                                        <L 4>
        var_1 = wp::address(var_raw, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::int(var_3);
        // x = (x & BYTE) << 8 | x >> 8                                                           <L 5>
        var_5 = wp::bit_and(var_2, var_4);
        var_7 = wp::lshift(var_5, var_6);
        var_9 = wp::rshift(var_2, var_8);
        var_10 = wp::bit_or(var_7, var_9);
        // meters = float64(NYU_SCALE) / (float64(NYU_OFFSET) - float64(x))                       <L 6>
        var_11 = 351.3;
        var_12 = 1092.5;
        var_13 = wp::float64(var_10);
        var_14 = wp::sub(var_12, var_13);
        var_15 = wp::div(var_11, var_14);
        // millimeters = int(0)                                                                   <L 7>
        var_17 = wp::int(var_16);
        // if meters > float64(0.0):                                                              <L 8>
        var_18 = 0.0;
        var_19 = (var_15 > var_18);
        if (var_19) {
            // millimeters = min(int(floor(meters * float64(1000.0) + float64(0.5))), WORD)       <L 9>
            var_20 = 1000.0;
            var_21 = wp::mul(var_15, var_20);
            var_22 = 0.5;
            var_23 = wp::add(var_21, var_22);
            var_24 = wp::floor(var_23);
            var_25 = wp::int(var_24);
            var_27 = wp::min(var_25, var_26);
        }
        var_28 = wp::where(var_19, var_27, var_17);
        // depth[i] = uint16(millimeters)                                                         <L 10>
        var_29 = wp::uint16(var_28);
        wp::array_store(var_depth, var_0, var_29);
}



extern "C" __global__ void color_pixels_kernel_5a58a3ee_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::uint8> var_pixels,
    wp::int32 var_grid__stride,
    wp::int32 var_grid__columns,
    wp::int32 var_grid__width,
    wp::array_t<wp::vec_t<3, wp::float32>> var_colors)
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
        wp::uint8* var_3;
        wp::float32 var_4;
        wp::uint8 var_5;
        const wp::float32 var_6 = 255.0;
        wp::float32 var_7;
        const wp::int32 var_8 = 1;
        wp::uint8* var_9;
        wp::float32 var_10;
        wp::uint8 var_11;
        const wp::float32 var_12 = 255.0;
        wp::float32 var_13;
        const wp::int32 var_14 = 2;
        wp::uint8* var_15;
        wp::float32 var_16;
        wp::uint8 var_17;
        const wp::float32 var_18 = 255.0;
        wp::float32 var_19;
        wp::vec_t<3, wp::float32> var_20;
        //---------
        // forward
        // def color_pixels_kernel(pixels, grid__stride, grid__columns, grid__width, colors):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // j = grid_pixel(i, grid__stride, grid__columns, grid__width)                            <L 4>
        var_1 = grid_pixel_0(var_0, var_grid__stride, var_grid__columns, var_grid__width);
        // colors[i] = vec3(float(pixels[j, 0]) / 255.0, float(pixels[j, 1]) / 255.0, float(pixels[j, 2]) / 255.0)       <L 5>
        var_3 = wp::address(var_pixels, var_1, var_2);
        var_5 = wp::load(var_3);
        var_4 = wp::float(var_5);
        var_7 = wp::div(var_4, var_6);
        var_9 = wp::address(var_pixels, var_1, var_8);
        var_11 = wp::load(var_9);
        var_10 = wp::float(var_11);
        var_13 = wp::div(var_10, var_12);
        var_15 = wp::address(var_pixels, var_1, var_14);
        var_17 = wp::load(var_15);
        var_16 = wp::float(var_17);
        var_19 = wp::div(var_16, var_18);
        var_20 = wp::vec_t<3, wp::float32>(var_7, var_13, var_19);
        wp::array_store(var_colors, var_0, var_20);
}



extern "C" __global__ void weigh_colors_kernel_7f13dd78_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::uint8> var_pixels,
    wp::array_t<wp::float32> var_intensity)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        const wp::float32 var_1 = 0.299;
        const wp::int32 var_2 = 0;
        wp::uint8* var_3;
        wp::float32 var_4;
        wp::uint8 var_5;
        wp::float32 var_6;
        const wp::float32 var_7 = 0.587;
        const wp::int32 var_8 = 1;
        wp::uint8* var_9;
        wp::float32 var_10;
        wp::uint8 var_11;
        wp::float32 var_12;
        wp::float32 var_13;
        const wp::float32 var_14 = 0.114;
        const wp::int32 var_15 = 2;
        wp::uint8* var_16;
        wp::float32 var_17;
        wp::uint8 var_18;
        wp::float32 var_19;
        wp::float32 var_20;
        const wp::float32 var_21 = 255.0;
        wp::float32 var_22;
        //---------
        // forward
        // def weigh_colors_kernel(pixels: array(dtype=uint8, ndim=2), intensity: array(dtype=float32)):       <L 231>
        // i = tid()                                                                              <L 232>
        var_0 = builtin_tid1d();
        // intensity[i] = (RED * float(pixels[i, 0]) + GREEN * float(pixels[i, 1]) + BLUE * float(pixels[i, 2])) / 255.0       <L 233>
        var_3 = wp::address(var_pixels, var_0, var_2);
        var_5 = wp::load(var_3);
        var_4 = wp::float(var_5);
        var_6 = wp::mul(var_1, var_4);
        var_9 = wp::address(var_pixels, var_0, var_8);
        var_11 = wp::load(var_9);
        var_10 = wp::float(var_11);
        var_12 = wp::mul(var_7, var_10);
        var_13 = wp::add(var_6, var_12);
        var_16 = wp::address(var_pixels, var_0, var_15);
        var_18 = wp::load(var_16);
        var_17 = wp::float(var_18);
        var_19 = wp::mul(var_14, var_17);
        var_20 = wp::add(var_13, var_19);
        var_22 = wp::div(var_20, var_21);
        wp::array_store(var_intensity, var_0, var_22);
}



extern "C" __global__ void limit_depth_kernel_d4255092_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_raw,
    wp::int32 var_runs__rows,
    wp::int32 var_runs__count,
    wp::int32 var_runs__length,
    wp::int32 var_runs__stride,
    wp::int32 var_runs__step,
    wp::float32 var_scale,
    wp::float32 var_farthest,
    wp::array_t<wp::float32> var_depth,
    wp::array_t<wp::int32> var_largest)
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
        wp::int32 var_3;
        const wp::int32 var_4 = 1;
        wp::int32 var_5;
        wp::int32 var_6;
        wp::int32 var_7;
        const wp::int32 var_8 = 1;
        wp::int32 var_9;
        wp::int32 var_10;
        wp::range_t var_11;
        wp::int32 var_12;
        wp::int32 var_13;
        wp::int32 var_14;
        wp::float32* var_15;
        wp::float32 var_16;
        wp::float32 var_17;
        const wp::float32 var_18 = 0.0;
        wp::float32 var_19;
        bool var_20;
        const wp::float32 var_21 = 0.0;
        bool var_22;
        bool var_23;
        bool var_24;
        wp::float32 var_25;
        wp::float32 var_26;
        wp::int32 var_27;
        wp::int32 var_28;
        const wp::int32 var_29 = 0;
        bool var_30;
        wp::int32 var_31;
        wp::int32 var_32;
        //---------
        // forward
        // def limit_depth_kernel(raw, runs__rows, runs__count, runs__length, runs__stride, runs__step, scale, farthest, depth, largest):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // maximum = int(0)                                                                       <L 4>
        var_2 = wp::int(var_1);
        // first__elements_of__1 = i * runs__stride                                               <L 5>
        var_3 = wp::mul(var_0, var_runs__stride);
        // for k__elements_of__1 in range(min(runs__length, (runs__count - 1 - first__elements_of__1) // runs__step + 1)):       <L 6>
        var_5 = wp::sub(var_runs__count, var_4);
        var_6 = wp::sub(var_5, var_3);
        var_7 = wp::floordiv(var_6, var_runs__step);
        var_9 = wp::add(var_7, var_8);
        var_10 = wp::min(var_runs__length, var_9);
        var_11 = wp::range(var_10);
        start_for_0:;
            if (iter_cmp(var_11) == 0) goto end_for_0;
            var_12 = wp::iter_next(var_11);
            // j = first__elements_of__1 + k__elements_of__1 * runs__step                         <L 7>
            var_13 = wp::mul(var_12, var_runs__step);
            var_14 = wp::add(var_3, var_13);
            // d = raw[j] / scale                                                                 <L 8>
            var_15 = wp::address(var_raw, var_14);
            var_17 = wp::load(var_15);
            var_16 = wp::div(var_17, var_scale);
            // meters = float(0.0)                                                                <L 9>
            var_19 = wp::float(var_18);
            // if d > 0.0 and d <= farthest and isfinite(d):                                      <L 10>
            var_22 = (var_16 > var_21);
            var_20 = var_22;
            if (var_20) {
                var_23 = (var_16 <= var_farthest);
                var_20 = var_20 && var_23;
            }
            if (var_20) {
                var_24 = wp::isfinite(var_16);
                var_20 = var_20 && var_24;
            }
            if (var_20) {
                // meters = d                                                                     <L 11>
                var_25 = wp::copy(var_16);
            }
            var_26 = wp::where(var_20, var_25, var_19);
            // depth[j] = meters                                                                  <L 12>
            wp::array_store(var_depth, var_14, var_26);
            // maximum = max(maximum, float_bits(meters))                                         <L 13>
            var_27 = _float_bits_0(var_26);
            var_28 = wp::max(var_2, var_27);
            wp::assign(var_2, var_28);
            goto start_for_0;
        end_for_0:;
        // if maximum > 0:                                                                        <L 14>
        var_30 = (var_2 > var_29);
        if (var_30) {
            // atomic_max(largest, row_of(i, runs__rows), maximum)                                <L 15>
            var_31 = row_of_0(var_0, var_runs__rows);
            var_32 = wp::atomic_max(var_largest, var_31, var_2);
        }
}



extern "C" __global__ void scale_depth_kernel_f547cedf_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::uint16> var_raw,
    wp::int32 var_runs__rows,
    wp::int32 var_runs__count,
    wp::int32 var_runs__length,
    wp::int32 var_runs__stride,
    wp::int32 var_runs__step,
    wp::float32 var_scale,
    wp::float32 var_farthest,
    wp::array_t<wp::float32> var_depth,
    wp::array_t<wp::int32> var_largest)
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
        wp::int32 var_3;
        const wp::int32 var_4 = 1;
        wp::int32 var_5;
        wp::int32 var_6;
        wp::int32 var_7;
        const wp::int32 var_8 = 1;
        wp::int32 var_9;
        wp::int32 var_10;
        wp::range_t var_11;
        wp::int32 var_12;
        wp::int32 var_13;
        wp::int32 var_14;
        wp::uint16* var_15;
        wp::float32 var_16;
        wp::uint16 var_17;
        wp::float32 var_18;
        bool var_19;
        const wp::float32 var_20 = 0.0;
        wp::float32 var_21;
        wp::int32 var_22;
        wp::int32 var_23;
        const wp::int32 var_24 = 0;
        bool var_25;
        wp::int32 var_26;
        wp::int32 var_27;
        //---------
        // forward
        // def scale_depth_kernel(raw, runs__rows, runs__count, runs__length, runs__stride, runs__step, scale, farthest, depth, largest):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // maximum = int(0)                                                                       <L 4>
        var_2 = wp::int(var_1);
        // first__elements_of__1 = i * runs__stride                                               <L 5>
        var_3 = wp::mul(var_0, var_runs__stride);
        // for k__elements_of__1 in range(min(runs__length, (runs__count - 1 - first__elements_of__1) // runs__step + 1)):       <L 6>
        var_5 = wp::sub(var_runs__count, var_4);
        var_6 = wp::sub(var_5, var_3);
        var_7 = wp::floordiv(var_6, var_runs__step);
        var_9 = wp::add(var_7, var_8);
        var_10 = wp::min(var_runs__length, var_9);
        var_11 = wp::range(var_10);
        start_for_0:;
            if (iter_cmp(var_11) == 0) goto end_for_0;
            var_12 = wp::iter_next(var_11);
            // j = first__elements_of__1 + k__elements_of__1 * runs__step                         <L 7>
            var_13 = wp::mul(var_12, var_runs__step);
            var_14 = wp::add(var_3, var_13);
            // d = float(raw[j]) / scale                                                          <L 8>
            var_15 = wp::address(var_raw, var_14);
            var_17 = wp::load(var_15);
            var_16 = wp::float(var_17);
            var_18 = wp::div(var_16, var_scale);
            // if d > farthest:                                                                   <L 9>
            var_19 = (var_18 > var_farthest);
            if (var_19) {
                // d = 0.0                                                                        <L 10>
            }
            var_21 = wp::where(var_19, var_20, var_18);
            // depth[j] = d                                                                       <L 11>
            wp::array_store(var_depth, var_14, var_21);
            // maximum = max(maximum, float_bits(d))                                              <L 12>
            var_22 = _float_bits_0(var_21);
            var_23 = wp::max(var_2, var_22);
            wp::assign(var_2, var_23);
            goto start_for_0;
        end_for_0:;
        // if maximum > 0:                                                                        <L 13>
        var_25 = (var_2 > var_24);
        if (var_25) {
            // atomic_max(largest, row_of(i, runs__rows), maximum)                                <L 14>
            var_26 = row_of_0(var_0, var_runs__rows);
            var_27 = wp::atomic_max(var_largest, var_26, var_2);
        }
}


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


// <pointloom.kernels.meshes.clean_triangles.uses_vertex_twice>:1
static CUDA_CALLABLE wp::int32 uses_vertex_twice_0(
    wp::vec_t<3, wp::int32> var_t)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    bool var_2;
    const wp::int32 var_3 = 0;
    wp::int32 var_4;
    const wp::int32 var_5 = 1;
    wp::int32 var_6;
    bool var_7;
    const wp::int32 var_8 = 1;
    wp::int32 var_9;
    const wp::int32 var_10 = 2;
    wp::int32 var_11;
    bool var_12;
    const wp::int32 var_13 = 2;
    wp::int32 var_14;
    const wp::int32 var_15 = 0;
    wp::int32 var_16;
    bool var_17;
    const wp::int32 var_18 = 1;
    wp::int32 var_19;
    //---------
    // forward
    // def uses_vertex_twice(t):                                                              <L 1>
    // repeated = int(0)                                                                      <L 2>
    var_1 = wp::int(var_0);
    // if t[0] == t[1] or t[1] == t[2] or t[2] == t[0]:                                       <L 3>
    var_4 = wp::extract(var_t, var_3);
    var_6 = wp::extract(var_t, var_5);
    var_7 = (var_4 == var_6);
    var_2 = var_7;
    if (!var_2) {
        var_9 = wp::extract(var_t, var_8);
        var_11 = wp::extract(var_t, var_10);
        var_12 = (var_9 == var_11);
        var_2 = var_2 || var_12;
    }
    if (!var_2) {
        var_14 = wp::extract(var_t, var_13);
        var_16 = wp::extract(var_t, var_15);
        var_17 = (var_14 == var_16);
        var_2 = var_2 || var_17;
    }
    if (var_2) {
        // repeated = 1                                                                       <L 4>
    }
    var_19 = wp::where(var_2, var_18, var_1);
    // return repeated                                                                        <L 5>
    return var_19;
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


// <pointloom.kernels.meshes.mesh_measures.triangle_cross>:1
static CUDA_CALLABLE wp::vec_t<3, wp::float64> triangle_cross_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_vertices,
    wp::vec_t<3, wp::int32> var_t)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    wp::vec_t<3, wp::float32>* var_2;
    wp::vec_t<3, wp::float64> var_3;
    wp::vec_t<3, wp::float32> var_4;
    const wp::int32 var_5 = 1;
    wp::int32 var_6;
    wp::vec_t<3, wp::float32>* var_7;
    wp::vec_t<3, wp::float64> var_8;
    wp::vec_t<3, wp::float32> var_9;
    wp::vec_t<3, wp::float64> var_10;
    const wp::int32 var_11 = 2;
    wp::int32 var_12;
    wp::vec_t<3, wp::float32>* var_13;
    wp::vec_t<3, wp::float64> var_14;
    wp::vec_t<3, wp::float32> var_15;
    wp::vec_t<3, wp::float64> var_16;
    wp::vec_t<3, wp::float64> var_17;
    bool var_18;
    bool var_19;
    wp::float64 var_20;
    wp::float64 var_21;
    wp::float64 var_22;
    wp::vec_t<3, wp::float64> var_23;
    wp::vec_t<3, wp::float64> var_24;
    //---------
    // forward
    // def triangle_cross(vertices, t):                                                       <L 1>
    // a = widen(vertices[t[0]])                                                              <L 3>
    var_1 = wp::extract(var_t, var_0);
    var_2 = wp::address(var_vertices, var_1);
    var_4 = wp::load(var_2);
    var_3 = widen_0(var_4);
    // n = cross(widen(vertices[t[1]]) - a, widen(vertices[t[2]]) - a)                        <L 4>
    var_6 = wp::extract(var_t, var_5);
    var_7 = wp::address(var_vertices, var_6);
    var_9 = wp::load(var_7);
    var_8 = widen_0(var_9);
    var_10 = wp::sub(var_8, var_3);
    var_12 = wp::extract(var_t, var_11);
    var_13 = wp::address(var_vertices, var_12);
    var_15 = wp::load(var_13);
    var_14 = widen_0(var_15);
    var_16 = wp::sub(var_14, var_3);
    var_17 = wp::cross(var_10, var_16);
    // if not isfinite(n):                                                                    <L 5>
    var_18 = wp::isfinite(var_17);
    var_19 = wp::unot(var_18);
    if (var_19) {
        // n = vec3d(float64(0.0), float64(0.0), float64(0.0))                                <L 6>
        var_20 = 0.0;
        var_21 = 0.0;
        var_22 = 0.0;
        var_23 = wp::vec_t<3, wp::float64>(var_20, var_21, var_22);
    }
    var_24 = wp::where(var_19, var_23, var_17);
    // return n                                                                               <L 7>
    return var_24;
}


// <pointloom.kernels.meshes.clean_triangles.uses_vertex_twice>:1
static CUDA_CALLABLE void adj_uses_vertex_twice_0(
    wp::vec_t<3, wp::int32> var_t,
    wp::vec_t<3, wp::int32> & adj_t,
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


// <pointloom.kernels.meshes.mesh_measures.triangle_cross>:1
static CUDA_CALLABLE void adj_triangle_cross_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_vertices,
    wp::vec_t<3, wp::int32> var_t,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_vertices,
    wp::vec_t<3, wp::int32> & adj_t,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void join_masks_kernel_4ea1c2fd_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::uint8> var_more,
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
        wp::uint8* var_1;
        const wp::int32 var_2 = 0;
        wp::uint8 var_3;
        bool var_4;
        wp::uint8 var_5;
        const wp::int32 var_6 = 1;
        wp::uint8 var_7;
        //---------
        // forward
        // def join_masks_kernel(more, mask):                                                     <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // if more[i] != uint8(0):                                                                <L 3>
        var_1 = wp::address(var_more, var_0);
        var_3 = wp::uint8(var_2);
        var_5 = wp::load(var_1);
        var_4 = (var_5 != var_3);
        if (var_4) {
            // mask[i] = uint8(1)                                                                 <L 4>
            var_7 = wp::uint8(var_6);
            wp::array_store(var_mask, var_0, var_7);
        }
}



extern "C" __global__ void mark_corners_kernel_60da7c8e_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::int32>> var_triangles,
    wp::array_t<wp::uint8> var_removed,
    wp::array_t<wp::uint8> var_used)
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
        wp::vec_t<3, wp::int32>* var_6;
        wp::vec_t<3, wp::int32> var_7;
        wp::vec_t<3, wp::int32> var_8;
        const wp::int32 var_9 = 0;
        const wp::int32 var_10 = 1;
        wp::uint8 var_11;
        wp::int32 var_12;
        const wp::int32 var_13 = 1;
        const wp::int32 var_14 = 1;
        wp::uint8 var_15;
        wp::int32 var_16;
        const wp::int32 var_17 = 2;
        const wp::int32 var_18 = 1;
        wp::uint8 var_19;
        wp::int32 var_20;
        //---------
        // forward
        // def mark_corners_kernel(triangles, removed, used):                                     <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // if removed[i] == uint8(0):                                                             <L 4>
        var_1 = wp::address(var_removed, var_0);
        var_3 = wp::uint8(var_2);
        var_5 = wp::load(var_1);
        var_4 = (var_5 == var_3);
        if (var_4) {
            // t = triangles[i]                                                                   <L 5>
            var_6 = wp::address(var_triangles, var_0);
            var_8 = wp::load(var_6);
            var_7 = wp::copy(var_8);
            // for k in range(3):                                                                 <L 6>
            // used[t[k]] = uint8(1)                                                              <L 7>
            var_11 = wp::uint8(var_10);
            var_12 = wp::extract(var_7, var_9);
            wp::array_store(var_used, var_12, var_11);
            var_15 = wp::uint8(var_14);
            var_16 = wp::extract(var_7, var_13);
            wp::array_store(var_used, var_16, var_15);
            var_19 = wp::uint8(var_18);
            var_20 = wp::extract(var_7, var_17);
            wp::array_store(var_used, var_20, var_19);
        }
}



extern "C" __global__ void mask_degenerate_kernel_c09f2950_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_vertices,
    wp::array_t<wp::vec_t<3, wp::int32>> var_triangles,
    wp::int32 var_zero_area,
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
        wp::vec_t<3, wp::int32>* var_1;
        wp::vec_t<3, wp::int32> var_2;
        wp::vec_t<3, wp::int32> var_3;
        wp::int32 var_4;
        bool var_5;
        const wp::int32 var_6 = 1;
        bool var_7;
        const wp::int32 var_8 = 0;
        bool var_9;
        wp::vec_t<3, wp::float64> var_10;
        bool var_11;
        const wp::int32 var_12 = 0;
        wp::int32 var_13;
        wp::vec_t<3, wp::float32>* var_14;
        bool var_15;
        wp::vec_t<3, wp::float32> var_16;
        const wp::int32 var_17 = 1;
        wp::int32 var_18;
        wp::vec_t<3, wp::float32>* var_19;
        bool var_20;
        wp::vec_t<3, wp::float32> var_21;
        const wp::int32 var_22 = 2;
        wp::int32 var_23;
        wp::vec_t<3, wp::float32>* var_24;
        bool var_25;
        wp::vec_t<3, wp::float32> var_26;
        bool var_27;
        wp::float64 var_28;
        wp::float64 var_29;
        bool var_30;
        const wp::int32 var_31 = 1;
        wp::int32 var_32;
        wp::int32 var_33;
        wp::uint8 var_34;
        //---------
        // forward
        // def mask_degenerate_kernel(vertices, triangles, zero_area, mask):                      <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // t = triangles[i]                                                                       <L 3>
        var_1 = wp::address(var_triangles, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // degenerate = uses_vertex_twice(t)                                                      <L 4>
        var_4 = uses_vertex_twice_0(var_2);
        // if zero_area == 1 and degenerate == 0:                                                 <L 5>
        var_7 = (var_zero_area == var_6);
        var_5 = var_7;
        if (var_5) {
            var_9 = (var_4 == var_8);
            var_5 = var_5 && var_9;
        }
        if (var_5) {
            // n = triangle_cross(vertices, t)                                                    <L 6>
            var_10 = triangle_cross_0(var_vertices, var_2);
            // finite = isfinite(vertices[t[0]]) and isfinite(vertices[t[1]]) and isfinite(vertices[t[2]])       <L 7>
            var_13 = wp::extract(var_2, var_12);
            var_14 = wp::address(var_vertices, var_13);
            var_16 = wp::load(var_14);
            var_15 = wp::isfinite(var_16);
            var_11 = var_15;
            if (var_11) {
                var_18 = wp::extract(var_2, var_17);
                var_19 = wp::address(var_vertices, var_18);
                var_21 = wp::load(var_19);
                var_20 = wp::isfinite(var_21);
                var_11 = var_11 && var_20;
            }
            if (var_11) {
                var_23 = wp::extract(var_2, var_22);
                var_24 = wp::address(var_vertices, var_23);
                var_26 = wp::load(var_24);
                var_25 = wp::isfinite(var_26);
                var_11 = var_11 && var_25;
            }
            // if finite and length(n) == float64(0.0):                                           <L 8>
            var_27 = var_11;
            if (var_27) {
                var_28 = wp::length(var_10);
                var_29 = 0.0;
                var_30 = (var_28 == var_29);
                var_27 = var_27 && var_30;
            }
            if (var_27) {
                // degenerate = 1                                                                 <L 9>
            }
            var_32 = wp::where(var_27, var_31, var_4);
        }
        var_33 = wp::where(var_5, var_32, var_4);
        // mask[i] = uint8(degenerate)                                                            <L 10>
        var_34 = wp::uint8(var_33);
        wp::array_store(var_mask, var_0, var_34);
}



extern "C" __global__ void list_rotated_kernel_c6b9da70_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::int32>> var_triangles,
    wp::array_t<wp::vec_t<3, wp::int32>> var_rotated)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::vec_t<3, wp::int32>* var_1;
        wp::vec_t<3, wp::int32> var_2;
        wp::vec_t<3, wp::int32> var_3;
        const wp::int32 var_4 = 0;
        const wp::int32 var_5 = 0;
        const wp::int32 var_6 = 0;
        wp::vec_t<3, wp::int32> var_7;
        wp::vec_t<3, wp::int32> var_8;
        const wp::int32 var_9 = 0;
        const wp::int32 var_10 = 1;
        wp::int32 var_11;
        const wp::int32 var_12 = 2;
        wp::int32 var_13;
        const wp::int32 var_14 = 0;
        wp::int32 var_15;
        wp::vec_t<3, wp::int32> var_16;
        const wp::int32 var_17 = 1;
        bool var_18;
        const wp::int32 var_19 = 2;
        wp::int32 var_20;
        const wp::int32 var_21 = 0;
        wp::int32 var_22;
        const wp::int32 var_23 = 1;
        wp::int32 var_24;
        wp::vec_t<3, wp::int32> var_25;
        wp::vec_t<3, wp::int32> var_26;
        const wp::int32 var_27 = 0;
        wp::int32 var_28;
        const wp::int32 var_29 = 0;
        wp::int32 var_30;
        const wp::int32 var_31 = 0;
        wp::int32 var_32;
        bool var_33;
        const wp::int32 var_34 = 1;
        wp::int32 var_35;
        bool var_36;
        const wp::int32 var_37 = 0;
        wp::int32 var_38;
        const wp::int32 var_39 = 0;
        wp::int32 var_40;
        bool var_41;
        const wp::int32 var_42 = 1;
        wp::int32 var_43;
        const wp::int32 var_44 = 1;
        wp::int32 var_45;
        bool var_46;
        const wp::int32 var_47 = 1;
        wp::int32 var_48;
        const wp::int32 var_49 = 1;
        bool var_50;
        wp::vec_t<3, wp::int32> var_51;
        wp::vec_t<3, wp::int32> var_52;
        const wp::int32 var_53 = 1;
        const wp::int32 var_54 = 1;
        wp::int32 var_55;
        const wp::int32 var_56 = 2;
        wp::int32 var_57;
        const wp::int32 var_58 = 0;
        wp::int32 var_59;
        wp::vec_t<3, wp::int32> var_60;
        const wp::int32 var_61 = 1;
        bool var_62;
        const wp::int32 var_63 = 2;
        wp::int32 var_64;
        const wp::int32 var_65 = 0;
        wp::int32 var_66;
        const wp::int32 var_67 = 1;
        wp::int32 var_68;
        wp::vec_t<3, wp::int32> var_69;
        wp::vec_t<3, wp::int32> var_70;
        const wp::int32 var_71 = 0;
        wp::int32 var_72;
        const wp::int32 var_73 = 0;
        wp::int32 var_74;
        const wp::int32 var_75 = 0;
        wp::int32 var_76;
        bool var_77;
        const wp::int32 var_78 = 1;
        wp::int32 var_79;
        bool var_80;
        const wp::int32 var_81 = 0;
        wp::int32 var_82;
        const wp::int32 var_83 = 0;
        wp::int32 var_84;
        bool var_85;
        const wp::int32 var_86 = 1;
        wp::int32 var_87;
        const wp::int32 var_88 = 1;
        wp::int32 var_89;
        bool var_90;
        const wp::int32 var_91 = 1;
        wp::int32 var_92;
        const wp::int32 var_93 = 1;
        bool var_94;
        wp::vec_t<3, wp::int32> var_95;
        wp::vec_t<3, wp::int32> var_96;
        //---------
        // forward
        // def list_rotated_kernel(triangles, rotated):                                           <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // t = triangles[i]                                                                       <L 3>
        var_1 = wp::address(var_triangles, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // best = t + vec3i(0, 0, 0)                                                              <L 4>
        var_7 = wp::vec_t<3, wp::int32>(var_4, var_5, var_6);
        var_8 = wp::add(var_2, var_7);
        // for k in range(2):                                                                     <L 5>
        // other = vec3i(t[1], t[2], t[0])                                                        <L 6>
        var_11 = wp::extract(var_2, var_10);
        var_13 = wp::extract(var_2, var_12);
        var_15 = wp::extract(var_2, var_14);
        var_16 = wp::vec_t<3, wp::int32>(var_11, var_13, var_15);
        // if k == 1:                                                                             <L 7>
        var_18 = (var_9 == var_17);
        if (var_18) {
            // other = vec3i(t[2], t[0], t[1])                                                    <L 8>
            var_20 = wp::extract(var_2, var_19);
            var_22 = wp::extract(var_2, var_21);
            var_24 = wp::extract(var_2, var_23);
            var_25 = wp::vec_t<3, wp::int32>(var_20, var_22, var_24);
        }
        var_26 = wp::where(var_18, var_25, var_16);
        // less = int(0)                                                                          <L 9>
        var_28 = wp::int(var_27);
        // if other[0] < best[0]:                                                                 <L 10>
        var_30 = wp::extract(var_26, var_29);
        var_32 = wp::extract(var_8, var_31);
        var_33 = (var_30 < var_32);
        if (var_33) {
            // less = 1                                                                           <L 11>
        }
        var_35 = wp::where(var_33, var_34, var_28);
        // if other[0] == best[0] and other[1] < best[1]:                                         <L 12>
        var_38 = wp::extract(var_26, var_37);
        var_40 = wp::extract(var_8, var_39);
        var_41 = (var_38 == var_40);
        var_36 = var_41;
        if (var_36) {
            var_43 = wp::extract(var_26, var_42);
            var_45 = wp::extract(var_8, var_44);
            var_46 = (var_43 < var_45);
            var_36 = var_36 && var_46;
        }
        if (var_36) {
            // less = 1                                                                           <L 13>
        }
        var_48 = wp::where(var_36, var_47, var_35);
        // if less == 1:                                                                          <L 14>
        var_50 = (var_48 == var_49);
        if (var_50) {
            // best = other                                                                       <L 15>
            var_51 = wp::copy(var_26);
        }
        var_52 = wp::where(var_50, var_51, var_8);
        // other = vec3i(t[1], t[2], t[0])                                                        <L 6>
        var_55 = wp::extract(var_2, var_54);
        var_57 = wp::extract(var_2, var_56);
        var_59 = wp::extract(var_2, var_58);
        var_60 = wp::vec_t<3, wp::int32>(var_55, var_57, var_59);
        // if k == 1:                                                                             <L 7>
        var_62 = (var_53 == var_61);
        if (var_62) {
            // other = vec3i(t[2], t[0], t[1])                                                    <L 8>
            var_64 = wp::extract(var_2, var_63);
            var_66 = wp::extract(var_2, var_65);
            var_68 = wp::extract(var_2, var_67);
            var_69 = wp::vec_t<3, wp::int32>(var_64, var_66, var_68);
        }
        var_70 = wp::where(var_62, var_69, var_60);
        // less = int(0)                                                                          <L 9>
        var_72 = wp::int(var_71);
        // if other[0] < best[0]:                                                                 <L 10>
        var_74 = wp::extract(var_70, var_73);
        var_76 = wp::extract(var_52, var_75);
        var_77 = (var_74 < var_76);
        if (var_77) {
            // less = 1                                                                           <L 11>
        }
        var_79 = wp::where(var_77, var_78, var_72);
        // if other[0] == best[0] and other[1] < best[1]:                                         <L 12>
        var_82 = wp::extract(var_70, var_81);
        var_84 = wp::extract(var_52, var_83);
        var_85 = (var_82 == var_84);
        var_80 = var_85;
        if (var_80) {
            var_87 = wp::extract(var_70, var_86);
            var_89 = wp::extract(var_52, var_88);
            var_90 = (var_87 < var_89);
            var_80 = var_80 && var_90;
        }
        if (var_80) {
            // less = 1                                                                           <L 13>
        }
        var_92 = wp::where(var_80, var_91, var_79);
        // if less == 1:                                                                          <L 14>
        var_94 = (var_92 == var_93);
        if (var_94) {
            // best = other                                                                       <L 15>
            var_95 = wp::copy(var_70);
        }
        var_96 = wp::where(var_94, var_95, var_52);
        // rotated[i] = best                                                                      <L 16>
        wp::array_store(var_rotated, var_0, var_96);
}



extern "C" __global__ void mask_not_finite_kernel_cbd1b079_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_vertices,
    wp::array_t<wp::vec_t<3, wp::int32>> var_triangles,
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
        wp::vec_t<3, wp::int32>* var_1;
        wp::vec_t<3, wp::int32> var_2;
        wp::vec_t<3, wp::int32> var_3;
        bool var_4;
        const wp::int32 var_5 = 0;
        wp::int32 var_6;
        wp::vec_t<3, wp::float32>* var_7;
        bool var_8;
        wp::vec_t<3, wp::float32> var_9;
        const wp::int32 var_10 = 1;
        wp::int32 var_11;
        wp::vec_t<3, wp::float32>* var_12;
        bool var_13;
        wp::vec_t<3, wp::float32> var_14;
        const wp::int32 var_15 = 2;
        wp::int32 var_16;
        wp::vec_t<3, wp::float32>* var_17;
        bool var_18;
        wp::vec_t<3, wp::float32> var_19;
        const wp::int32 var_20 = 0;
        const wp::int32 var_21 = 1;
        wp::int32 var_22;
        wp::uint8 var_23;
        //---------
        // forward
        // def mask_not_finite_kernel(vertices: array(dtype=vec3), triangles: array(dtype=vec3i), mask: array(dtype=uint8)):       <L 37>
        // i = tid()                                                                              <L 38>
        var_0 = builtin_tid1d();
        // t = triangles[i]                                                                       <L 39>
        var_1 = wp::address(var_triangles, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // finite = isfinite(vertices[t[0]]) and isfinite(vertices[t[1]]) and isfinite(vertices[t[2]])       <L 40>
        var_6 = wp::extract(var_2, var_5);
        var_7 = wp::address(var_vertices, var_6);
        var_9 = wp::load(var_7);
        var_8 = wp::isfinite(var_9);
        var_4 = var_8;
        if (var_4) {
            var_11 = wp::extract(var_2, var_10);
            var_12 = wp::address(var_vertices, var_11);
            var_14 = wp::load(var_12);
            var_13 = wp::isfinite(var_14);
            var_4 = var_4 && var_13;
        }
        if (var_4) {
            var_16 = wp::extract(var_2, var_15);
            var_17 = wp::address(var_vertices, var_16);
            var_19 = wp::load(var_17);
            var_18 = wp::isfinite(var_19);
            var_4 = var_4 && var_18;
        }
        // mask[i] = uint8(0 if finite else 1)                                                    <L 41>
        if (var_4) {
        }
        if (!var_4) {
        }
        var_22 = wp::where(var_4, var_20, var_21);
        var_23 = wp::uint8(var_22);
        wp::array_store(var_mask, var_0, var_23);
}


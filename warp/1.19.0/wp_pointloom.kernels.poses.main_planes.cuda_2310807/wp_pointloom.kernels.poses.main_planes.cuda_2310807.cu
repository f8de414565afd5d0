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


// <pointloom.kernels.poses.main_planes.is_coplanar>:1
static CUDA_CALLABLE wp::int32 is_coplanar_0(
    wp::int32 var_i,
    wp::array_t<wp::vec_t<3, wp::float32>> var_voters__points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_voters__normals,
    wp::array_t<wp::int32> var_voters__sizes,
    wp::array_t<wp::vec_t<3, wp::float64>> var_voters__point,
    wp::array_t<wp::vec_t<3, wp::float64>> var_voters__normal,
    wp::float32 var_slab,
    wp::float32 var_cosine)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    bool var_2;
    const wp::int32 var_3 = 0;
    wp::int32* var_4;
    bool var_5;
    wp::int32 var_6;
    const wp::int32 var_7 = 2;
    wp::int32* var_8;
    const wp::int32 var_9 = 0;
    bool var_10;
    wp::int32 var_11;
    const wp::int32 var_12 = 0;
    wp::vec_t<3, wp::float64>* var_13;
    wp::vec_t<3, wp::float32> var_14;
    wp::vec_t<3, wp::float64> var_15;
    wp::vec_t<3, wp::float32>* var_16;
    wp::float32 var_17;
    wp::vec_t<3, wp::float32> var_18;
    wp::float32 var_19;
    bool var_20;
    wp::vec_t<3, wp::float32>* var_21;
    const wp::int32 var_22 = 0;
    wp::vec_t<3, wp::float64>* var_23;
    wp::vec_t<3, wp::float32> var_24;
    wp::vec_t<3, wp::float64> var_25;
    wp::vec_t<3, wp::float32> var_26;
    wp::vec_t<3, wp::float32> var_27;
    wp::float32 var_28;
    wp::float32 var_29;
    bool var_30;
    const wp::int32 var_31 = 1;
    wp::int32 var_32;
    wp::int32 var_33;
    wp::int32 var_34;
    //---------
    // forward
    // def is_coplanar(i, voters__points, voters__normals, voters__sizes, voters__point, voters__normal, slab, cosine):       <L 1>
    // is_inlier = int(0)                                                                     <L 2>
    var_1 = wp::int(var_0);
    // if i < voters__sizes[VOTERS_AT] and voters__sizes[DONE_AT] == 0:                       <L 3>
    var_4 = wp::address(var_voters__sizes, var_3);
    var_6 = wp::load(var_4);
    var_5 = (var_i < var_6);
    var_2 = var_5;
    if (var_2) {
        var_8 = wp::address(var_voters__sizes, var_7);
        var_11 = wp::load(var_8);
        var_10 = (var_11 == var_9);
        var_2 = var_2 && var_10;
    }
    if (var_2) {
        // n = narrow(voters__normal[0])                                                      <L 4>
        var_13 = wp::address(var_voters__normal, var_12);
        var_15 = wp::load(var_13);
        var_14 = narrow_0(var_15);
        // if abs(dot(n, voters__normals[i])) > cosine:                                       <L 5>
        var_16 = wp::address(var_voters__normals, var_i);
        var_18 = wp::load(var_16);
        var_17 = wp::dot(var_14, var_18);
        var_19 = wp::abs(var_17);
        var_20 = (var_19 > var_cosine);
        if (var_20) {
            // if abs(dot(n, voters__points[i] - narrow(voters__point[0]))) < slab:           <L 6>
            var_21 = wp::address(var_voters__points, var_i);
            var_23 = wp::address(var_voters__point, var_22);
            var_25 = wp::load(var_23);
            var_24 = narrow_0(var_25);
            var_27 = wp::load(var_21);
            var_26 = wp::sub(var_27, var_24);
            var_28 = wp::dot(var_14, var_26);
            var_29 = wp::abs(var_28);
            var_30 = (var_29 < var_slab);
            if (var_30) {
                // is_inlier = 1                                                              <L 7>
            }
            var_32 = wp::where(var_30, var_31, var_1);
        }
        var_33 = wp::where(var_20, var_32, var_1);
    }
    var_34 = wp::where(var_2, var_33, var_1);
    // return is_inlier                                                                       <L 8>
    return var_34;
}


// <pointloom.kernels.algebra.moments.add_difference>:1
static CUDA_CALLABLE wp::vec_t<10, wp::float64> add_difference_0(
    wp::vec_t<10, wp::float64> var_total,
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> var_q)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    wp::float64 var_2;
    const wp::int32 var_3 = 0;
    wp::float32 var_4;
    wp::float64 var_5;
    wp::float64 var_6;
    const wp::int32 var_7 = 1;
    wp::float32 var_8;
    wp::float64 var_9;
    const wp::int32 var_10 = 1;
    wp::float32 var_11;
    wp::float64 var_12;
    wp::float64 var_13;
    const wp::int32 var_14 = 2;
    wp::float32 var_15;
    wp::float64 var_16;
    const wp::int32 var_17 = 2;
    wp::float32 var_18;
    wp::float64 var_19;
    wp::float64 var_20;
    wp::float64 var_21;
    wp::float64 var_22;
    wp::float64 var_23;
    wp::float64 var_24;
    wp::float64 var_25;
    wp::float64 var_26;
    wp::float64 var_27;
    wp::vec_t<10, wp::float64> var_28;
    wp::vec_t<10, wp::float64> var_29;
    //---------
    // forward
    // def add_difference(total, p, q):                                                       <L 1>
    // x = float64(q[0]) - float64(p[0])                                                      <L 3>
    var_1 = wp::extract(var_q, var_0);
    var_2 = wp::float64(var_1);
    var_4 = wp::extract(var_p, var_3);
    var_5 = wp::float64(var_4);
    var_6 = wp::sub(var_2, var_5);
    // y = float64(q[1]) - float64(p[1])                                                      <L 4>
    var_8 = wp::extract(var_q, var_7);
    var_9 = wp::float64(var_8);
    var_11 = wp::extract(var_p, var_10);
    var_12 = wp::float64(var_11);
    var_13 = wp::sub(var_9, var_12);
    // z = float64(q[2]) - float64(p[2])                                                      <L 5>
    var_15 = wp::extract(var_q, var_14);
    var_16 = wp::float64(var_15);
    var_18 = wp::extract(var_p, var_17);
    var_19 = wp::float64(var_18);
    var_20 = wp::sub(var_16, var_19);
    // return total + moments(float64(1.0), x, y, z, x * x, x * y, x * z, y * y, y * z, z * z)       <L 6>
    var_21 = 1.0;
    var_22 = wp::mul(var_6, var_6);
    var_23 = wp::mul(var_6, var_13);
    var_24 = wp::mul(var_6, var_20);
    var_25 = wp::mul(var_13, var_13);
    var_26 = wp::mul(var_13, var_20);
    var_27 = wp::mul(var_20, var_20);
    var_28 = wp::vec_t<10, wp::float64>({var_21, var_6, var_13, var_20, var_22, var_23, var_24, var_25, var_26, var_27});
    var_29 = wp::add(var_total, var_28);
    return var_29;
}


// <pointloom.kernels.poses.main_planes.sum_coplanar_element>:1
static CUDA_CALLABLE wp::vec_t<10, wp::float64> sum_coplanar_element_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_voters__points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_voters__normals,
    wp::array_t<wp::int32> var_voters__sizes,
    wp::array_t<wp::vec_t<3, wp::float64>> var_voters__point,
    wp::array_t<wp::vec_t<3, wp::float64>> var_voters__normal,
    wp::float32 var_slab,
    wp::float32 var_cosine,
    wp::int32 var_i)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::vec_t<10, wp::float64> var_1;
    wp::int32 var_2;
    const wp::int32 var_3 = 1;
    bool var_4;
    const wp::int32 var_5 = 0;
    wp::vec_t<3, wp::float64>* var_6;
    wp::vec_t<3, wp::float32> var_7;
    wp::vec_t<3, wp::float64> var_8;
    wp::vec_t<3, wp::float32>* var_9;
    wp::vec_t<10, wp::float64> var_10;
    wp::vec_t<3, wp::float32> var_11;
    wp::vec_t<10, wp::float64> var_12;
    //---------
    // forward
    // def sum_coplanar_element(voters__points, voters__normals, voters__sizes, voters__point, voters__normal, slab, cosine, i):       <L 1>
    // total = moments(float64(0.0))                                                          <L 2>
    var_0 = 0.0;
    var_1 = wp::vec_t<10, wp::float64>(var_0);
    // if is_coplanar(i, voters__points, voters__normals, voters__sizes, voters__point, voters__normal, slab, cosine) == 1:       <L 3>
    var_2 = is_coplanar_0(var_i, var_voters__points, var_voters__normals, var_voters__sizes, var_voters__point, var_voters__normal, var_slab, var_cosine);
    var_4 = (var_2 == var_3);
    if (var_4) {
        // total = add_difference(total, narrow(voters__point[0]), voters__points[i])         <L 4>
        var_6 = wp::address(var_voters__point, var_5);
        var_8 = wp::load(var_6);
        var_7 = narrow_0(var_8);
        var_9 = wp::address(var_voters__points, var_i);
        var_11 = wp::load(var_9);
        var_10 = add_difference_0(var_1, var_7, var_11);
    }
    var_12 = wp::where(var_4, var_10, var_1);
    // return total                                                                           <L 5>
    return var_12;
}


// /work/main/src/pointloom/kernels/algebra/transform.py:32
static CUDA_CALLABLE void adj_narrow_0(
    wp::vec_t<3, wp::float64> var_p,
    wp::vec_t<3, wp::float64> & adj_p,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.poses.main_planes.is_coplanar>:1
static CUDA_CALLABLE void adj_is_coplanar_0(
    wp::int32 var_i,
    wp::array_t<wp::vec_t<3, wp::float32>> var_voters__points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_voters__normals,
    wp::array_t<wp::int32> var_voters__sizes,
    wp::array_t<wp::vec_t<3, wp::float64>> var_voters__point,
    wp::array_t<wp::vec_t<3, wp::float64>> var_voters__normal,
    wp::float32 var_slab,
    wp::float32 var_cosine,
    wp::int32 & adj_i,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_voters__points,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_voters__normals,
    wp::array_t<wp::int32> & adj_voters__sizes,
    wp::array_t<wp::vec_t<3, wp::float64>> & adj_voters__point,
    wp::array_t<wp::vec_t<3, wp::float64>> & adj_voters__normal,
    wp::float32 & adj_slab,
    wp::float32 & adj_cosine,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.algebra.moments.add_difference>:1
static CUDA_CALLABLE void adj_add_difference_0(
    wp::vec_t<10, wp::float64> var_total,
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> var_q,
    wp::vec_t<10, wp::float64> & adj_total,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float32> & adj_q,
    wp::vec_t<10, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.poses.main_planes.sum_coplanar_element>:1
static CUDA_CALLABLE void adj_sum_coplanar_element_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_voters__points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_voters__normals,
    wp::array_t<wp::int32> var_voters__sizes,
    wp::array_t<wp::vec_t<3, wp::float64>> var_voters__point,
    wp::array_t<wp::vec_t<3, wp::float64>> var_voters__normal,
    wp::float32 var_slab,
    wp::float32 var_cosine,
    wp::int32 var_i,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_voters__points,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_voters__normals,
    wp::array_t<wp::int32> & adj_voters__sizes,
    wp::array_t<wp::vec_t<3, wp::float64>> & adj_voters__point,
    wp::array_t<wp::vec_t<3, wp::float64>> & adj_voters__normal,
    wp::float32 & adj_slab,
    wp::float32 & adj_cosine,
    wp::int32 & adj_i,
    wp::vec_t<10, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void sum_coplanar_tiles_0791413b_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_voters__points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_voters__normals,
    wp::array_t<wp::int32> var_voters__sizes,
    wp::array_t<wp::vec_t<3, wp::float64>> var_voters__point,
    wp::array_t<wp::vec_t<3, wp::float64>> var_voters__normal,
    wp::float32 var_slab,
    wp::float32 var_cosine,
    wp::int32 var_count_,
    wp::array_t<wp::vec_t<10, wp::float64>> var_partials_)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::vec_t<10, wp::float64> var_1;
        bool var_2;
        wp::vec_t<10, wp::float64> var_3;
        wp::vec_t<10, wp::float64> var_4;
        const wp::int32 var_5 = 0;
        wp::float64 var_6;
        const wp::int32 var_7 = 1;
        wp::float64 var_8;
        const wp::int32 var_9 = 2;
        wp::float64 var_10;
        const wp::int32 var_11 = 3;
        wp::float64 var_12;
        wp::vec_t<4, wp::float64> var_13;
        const bool var_14 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_15 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_16 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_17 = 0;
        wp::vec_t<4, wp::float64> var_18;
        const wp::int32 var_19 = 0;
        wp::float64 var_20;
        const wp::int32 var_21 = 0;
        const wp::int32 var_22 = 1;
        wp::float64 var_23;
        const wp::int32 var_24 = 1;
        const wp::int32 var_25 = 2;
        wp::float64 var_26;
        const wp::int32 var_27 = 2;
        const wp::int32 var_28 = 3;
        wp::float64 var_29;
        const wp::int32 var_30 = 3;
        const wp::int32 var_31 = 4;
        wp::float64 var_32;
        const wp::int32 var_33 = 5;
        wp::float64 var_34;
        const wp::int32 var_35 = 6;
        wp::float64 var_36;
        const wp::int32 var_37 = 7;
        wp::float64 var_38;
        wp::vec_t<4, wp::float64> var_39;
        const bool var_40 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_41 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_42 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_43 = 0;
        wp::vec_t<4, wp::float64> var_44;
        const wp::int32 var_45 = 0;
        wp::float64 var_46;
        const wp::int32 var_47 = 4;
        const wp::int32 var_48 = 1;
        wp::float64 var_49;
        const wp::int32 var_50 = 5;
        const wp::int32 var_51 = 2;
        wp::float64 var_52;
        const wp::int32 var_53 = 6;
        const wp::int32 var_54 = 3;
        wp::float64 var_55;
        const wp::int32 var_56 = 7;
        const wp::int32 var_57 = 8;
        wp::float64 var_58;
        const wp::int32 var_59 = 9;
        wp::float64 var_60;
        wp::vec_t<2, wp::float64> var_61;
        const bool var_62 = true;
        wp::tile_register_t<wp::vec_t<2, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_63 = wp::tile_register_t<wp::vec_t<2, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<2, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_64 = wp::tile_alloc_empty<wp::vec_t<2, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_65 = 0;
        wp::vec_t<2, wp::float64> var_66;
        const wp::int32 var_67 = 0;
        wp::float64 var_68;
        const wp::int32 var_69 = 8;
        const wp::int32 var_70 = 1;
        wp::float64 var_71;
        const wp::int32 var_72 = 9;
        const wp::int32 var_73 = 256;
        wp::int32 var_74;
        const wp::int32 var_75 = 0;
        bool var_76;
        const wp::int32 var_77 = 256;
        wp::int32 var_78;
        //---------
        // forward
        // def sum_coplanar_tiles(voters__points, voters__normals, voters__sizes, voters__point, voters__normal, slab, cosine, count_, partials_):       <L 1>
        // i_ = wp.tid()                                                                          <L 2>
        var_0 = builtin_tid1d();
        // value_ = vector_()                                                                     <L 3>
        var_1 = wp::vec_t<10, wp::float64>();
        // if i_ < count_:                                                                        <L 4>
        var_2 = (var_0 < var_count_);
        if (var_2) {
            // value_ = element_(voters__points, voters__normals, voters__sizes, voters__point, voters__normal, slab, cosine, i_)       <L 5>
            var_3 = sum_coplanar_element_0(var_voters__points, var_voters__normals, var_voters__sizes, var_voters__point, var_voters__normal, var_slab, var_cosine, var_0);
        }
        var_4 = wp::where(var_2, var_3, var_1);
        // part_0 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[0], value_[1], value_[2], value_[3]), preserve_type=True)), 0)       <L 6>
        var_6 = wp::extract(var_4, var_5);
        var_8 = wp::extract(var_4, var_7);
        var_10 = wp::extract(var_4, var_9);
        var_12 = wp::extract(var_4, var_11);
        var_13 = wp::vec_t<4, wp::float64>(var_6, var_8, var_10, var_12);
        var_15 = wp::tile<wp::vec_t<4, wp::float64>>(var_13);
        var_16 = wp::tile_sum(var_15);
        var_18 = wp::tile_extract(var_16, var_17);
        // value_[0] = part_0[0]                                                                  <L 7>
        var_20 = wp::extract(var_18, var_19);
        wp::assign_inplace(var_4, var_21, var_20);
        // value_[1] = part_0[1]                                                                  <L 8>
        var_23 = wp::extract(var_18, var_22);
        wp::assign_inplace(var_4, var_24, var_23);
        // value_[2] = part_0[2]                                                                  <L 9>
        var_26 = wp::extract(var_18, var_25);
        wp::assign_inplace(var_4, var_27, var_26);
        // value_[3] = part_0[3]                                                                  <L 10>
        var_29 = wp::extract(var_18, var_28);
        wp::assign_inplace(var_4, var_30, var_29);
        // part_4 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[4], value_[5], value_[6], value_[7]), preserve_type=True)), 0)       <L 11>
        var_32 = wp::extract(var_4, var_31);
        var_34 = wp::extract(var_4, var_33);
        var_36 = wp::extract(var_4, var_35);
        var_38 = wp::extract(var_4, var_37);
        var_39 = wp::vec_t<4, wp::float64>(var_32, var_34, var_36, var_38);
        var_41 = wp::tile<wp::vec_t<4, wp::float64>>(var_39);
        var_42 = wp::tile_sum(var_41);
        var_44 = wp::tile_extract(var_42, var_43);
        // value_[4] = part_4[0]                                                                  <L 12>
        var_46 = wp::extract(var_44, var_45);
        wp::assign_inplace(var_4, var_47, var_46);
        // value_[5] = part_4[1]                                                                  <L 13>
        var_49 = wp::extract(var_44, var_48);
        wp::assign_inplace(var_4, var_50, var_49);
        // value_[6] = part_4[2]                                                                  <L 14>
        var_52 = wp::extract(var_44, var_51);
        wp::assign_inplace(var_4, var_53, var_52);
        // value_[7] = part_4[3]                                                                  <L 15>
        var_55 = wp::extract(var_44, var_54);
        wp::assign_inplace(var_4, var_56, var_55);
        // part_8 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[8], value_[9]), preserve_type=True)), 0)       <L 16>
        var_58 = wp::extract(var_4, var_57);
        var_60 = wp::extract(var_4, var_59);
        var_61 = wp::vec_t<2, wp::float64>(var_58, var_60);
        var_63 = wp::tile<wp::vec_t<2, wp::float64>>(var_61);
        var_64 = wp::tile_sum(var_63);
        var_66 = wp::tile_extract(var_64, var_65);
        // value_[8] = part_8[0]                                                                  <L 17>
        var_68 = wp::extract(var_66, var_67);
        wp::assign_inplace(var_4, var_69, var_68);
        // value_[9] = part_8[1]                                                                  <L 18>
        var_71 = wp::extract(var_66, var_70);
        wp::assign_inplace(var_4, var_72, var_71);
        // if i_ % 256 == 0:                                                                      <L 19>
        var_74 = wp::mod(var_0, var_73);
        var_76 = (var_74 == var_75);
        if (var_76) {
            // partials_[i_ // 256] = value_                                                      <L 20>
            var_78 = wp::floordiv(var_0, var_77);
            wp::array_store(var_partials_, var_78, var_4);
        }
}



extern "C" __global__ void sum_coplanar_fold_tiles_2121a3e1_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::int32 var_count_,
    wp::array_t<wp::vec_t<10, wp::float64>> var_partials_,
    wp::array_t<wp::vec_t<10, wp::float64>> var_out_)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::vec_t<10, wp::float64> var_1;
        const wp::int32 var_2 = 256;
        wp::range_t var_3;
        wp::int32 var_4;
        wp::vec_t<10, wp::float64>* var_5;
        wp::vec_t<10, wp::float64> var_6;
        wp::vec_t<10, wp::float64> var_7;
        const wp::int32 var_8 = 0;
        wp::float64 var_9;
        const wp::int32 var_10 = 1;
        wp::float64 var_11;
        const wp::int32 var_12 = 2;
        wp::float64 var_13;
        const wp::int32 var_14 = 3;
        wp::float64 var_15;
        wp::vec_t<4, wp::float64> var_16;
        const bool var_17 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_18 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_19 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_20 = 0;
        wp::vec_t<4, wp::float64> var_21;
        const wp::int32 var_22 = 0;
        wp::float64 var_23;
        const wp::int32 var_24 = 0;
        const wp::int32 var_25 = 1;
        wp::float64 var_26;
        const wp::int32 var_27 = 1;
        const wp::int32 var_28 = 2;
        wp::float64 var_29;
        const wp::int32 var_30 = 2;
        const wp::int32 var_31 = 3;
        wp::float64 var_32;
        const wp::int32 var_33 = 3;
        const wp::int32 var_34 = 4;
        wp::float64 var_35;
        const wp::int32 var_36 = 5;
        wp::float64 var_37;
        const wp::int32 var_38 = 6;
        wp::float64 var_39;
        const wp::int32 var_40 = 7;
        wp::float64 var_41;
        wp::vec_t<4, wp::float64> var_42;
        const bool var_43 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_44 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_45 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_46 = 0;
        wp::vec_t<4, wp::float64> var_47;
        const wp::int32 var_48 = 0;
        wp::float64 var_49;
        const wp::int32 var_50 = 4;
        const wp::int32 var_51 = 1;
        wp::float64 var_52;
        const wp::int32 var_53 = 5;
        const wp::int32 var_54 = 2;
        wp::float64 var_55;
        const wp::int32 var_56 = 6;
        const wp::int32 var_57 = 3;
        wp::float64 var_58;
        const wp::int32 var_59 = 7;
        const wp::int32 var_60 = 8;
        wp::float64 var_61;
        const wp::int32 var_62 = 9;
        wp::float64 var_63;
        wp::vec_t<2, wp::float64> var_64;
        const bool var_65 = true;
        wp::tile_register_t<wp::vec_t<2, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_66 = wp::tile_register_t<wp::vec_t<2, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<2, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_67 = wp::tile_alloc_empty<wp::vec_t<2, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_68 = 0;
        wp::vec_t<2, wp::float64> var_69;
        const wp::int32 var_70 = 0;
        wp::float64 var_71;
        const wp::int32 var_72 = 8;
        const wp::int32 var_73 = 1;
        wp::float64 var_74;
        const wp::int32 var_75 = 9;
        const wp::int32 var_76 = 0;
        bool var_77;
        const wp::int32 var_78 = 0;
        //---------
        // forward
        // def sum_coplanar_fold_tiles(count_, partials_, out_):                                  <L 1>
        // i_ = wp.tid()                                                                          <L 2>
        var_0 = builtin_tid1d();
        // value_ = vector_()                                                                     <L 3>
        var_1 = wp::vec_t<10, wp::float64>();
        // for j_ in range(i_, count_, 256):                                                      <L 4>
        var_3 = wp::range(var_0, var_count_, var_2);
        start_for_0:;
            if (iter_cmp(var_3) == 0) goto end_for_0;
            var_4 = wp::iter_next(var_3);
            // value_ += partials_[j_]                                                            <L 5>
            var_5 = wp::address(var_partials_, var_4);
            var_7 = wp::load(var_5);
            var_6 = wp::add(var_1, var_7);
            wp::assign(var_1, var_6);
            goto start_for_0;
        end_for_0:;
        // part_0 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[0], value_[1], value_[2], value_[3]), preserve_type=True)), 0)       <L 6>
        var_9 = wp::extract(var_1, var_8);
        var_11 = wp::extract(var_1, var_10);
        var_13 = wp::extract(var_1, var_12);
        var_15 = wp::extract(var_1, var_14);
        var_16 = wp::vec_t<4, wp::float64>(var_9, var_11, var_13, var_15);
        var_18 = wp::tile<wp::vec_t<4, wp::float64>>(var_16);
        var_19 = wp::tile_sum(var_18);
        var_21 = wp::tile_extract(var_19, var_20);
        // value_[0] = part_0[0]                                                                  <L 7>
        var_23 = wp::extract(var_21, var_22);
        wp::assign_inplace(var_1, var_24, var_23);
        // value_[1] = part_0[1]                                                                  <L 8>
        var_26 = wp::extract(var_21, var_25);
        wp::assign_inplace(var_1, var_27, var_26);
        // value_[2] = part_0[2]                                                                  <L 9>
        var_29 = wp::extract(var_21, var_28);
        wp::assign_inplace(var_1, var_30, var_29);
        // value_[3] = part_0[3]                                                                  <L 10>
        var_32 = wp::extract(var_21, var_31);
        wp::assign_inplace(var_1, var_33, var_32);
        // part_4 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[4], value_[5], value_[6], value_[7]), preserve_type=True)), 0)       <L 11>
        var_35 = wp::extract(var_1, var_34);
        var_37 = wp::extract(var_1, var_36);
        var_39 = wp::extract(var_1, var_38);
        var_41 = wp::extract(var_1, var_40);
        var_42 = wp::vec_t<4, wp::float64>(var_35, var_37, var_39, var_41);
        var_44 = wp::tile<wp::vec_t<4, wp::float64>>(var_42);
        var_45 = wp::tile_sum(var_44);
        var_47 = wp::tile_extract(var_45, var_46);
        // value_[4] = part_4[0]                                                                  <L 12>
        var_49 = wp::extract(var_47, var_48);
        wp::assign_inplace(var_1, var_50, var_49);
        // value_[5] = part_4[1]                                                                  <L 13>
        var_52 = wp::extract(var_47, var_51);
        wp::assign_inplace(var_1, var_53, var_52);
        // value_[6] = part_4[2]                                                                  <L 14>
        var_55 = wp::extract(var_47, var_54);
        wp::assign_inplace(var_1, var_56, var_55);
        // value_[7] = part_4[3]                                                                  <L 15>
        var_58 = wp::extract(var_47, var_57);
        wp::assign_inplace(var_1, var_59, var_58);
        // part_8 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[8], value_[9]), preserve_type=True)), 0)       <L 16>
        var_61 = wp::extract(var_1, var_60);
        var_63 = wp::extract(var_1, var_62);
        var_64 = wp::vec_t<2, wp::float64>(var_61, var_63);
        var_66 = wp::tile<wp::vec_t<2, wp::float64>>(var_64);
        var_67 = wp::tile_sum(var_66);
        var_69 = wp::tile_extract(var_67, var_68);
        // value_[8] = part_8[0]                                                                  <L 17>
        var_71 = wp::extract(var_69, var_70);
        wp::assign_inplace(var_1, var_72, var_71);
        // value_[9] = part_8[1]                                                                  <L 18>
        var_74 = wp::extract(var_69, var_73);
        wp::assign_inplace(var_1, var_75, var_74);
        // if i_ == 0:                                                                            <L 19>
        var_77 = (var_0 == var_76);
        if (var_77) {
            // out_[0] = value_                                                                   <L 20>
            wp::array_store(var_out_, var_78, var_1);
        }
}


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


// <pointloom.kernels.icp.jobs.sum_moments_element>:1
static CUDA_CALLABLE wp::vec_t<4, wp::float64> sum_moments_element_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::int32 var_i)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float32>* var_0;
    wp::vec_t<3, wp::float64> var_1;
    wp::vec_t<3, wp::float32> var_2;
    const wp::int32 var_3 = 0;
    wp::float64 var_4;
    const wp::int32 var_5 = 1;
    wp::float64 var_6;
    const wp::int32 var_7 = 2;
    wp::float64 var_8;
    const wp::int32 var_9 = 0;
    wp::float64 var_10;
    const wp::int32 var_11 = 0;
    wp::float64 var_12;
    wp::float64 var_13;
    const wp::int32 var_14 = 1;
    wp::float64 var_15;
    const wp::int32 var_16 = 1;
    wp::float64 var_17;
    wp::float64 var_18;
    wp::float64 var_19;
    const wp::int32 var_20 = 2;
    wp::float64 var_21;
    const wp::int32 var_22 = 2;
    wp::float64 var_23;
    wp::float64 var_24;
    wp::float64 var_25;
    wp::vec_t<4, wp::float64> var_26;
    //---------
    // forward
    // def sum_moments_element(points, i):                                                    <L 1>
    // p = widen(points[i])                                                                   <L 2>
    var_0 = wp::address(var_points, var_i);
    var_2 = wp::load(var_0);
    var_1 = widen_0(var_2);
    // return first_moments(p[0], p[1], p[2], p[0] * p[0] + p[1] * p[1] + p[2] * p[2])        <L 3>
    var_4 = wp::extract(var_1, var_3);
    var_6 = wp::extract(var_1, var_5);
    var_8 = wp::extract(var_1, var_7);
    var_10 = wp::extract(var_1, var_9);
    var_12 = wp::extract(var_1, var_11);
    var_13 = wp::mul(var_10, var_12);
    var_15 = wp::extract(var_1, var_14);
    var_17 = wp::extract(var_1, var_16);
    var_18 = wp::mul(var_15, var_17);
    var_19 = wp::add(var_13, var_18);
    var_21 = wp::extract(var_1, var_20);
    var_23 = wp::extract(var_1, var_22);
    var_24 = wp::mul(var_21, var_23);
    var_25 = wp::add(var_19, var_24);
    var_26 = wp::vec_t<4, wp::float64>(var_4, var_6, var_8, var_25);
    return var_26;
}


// /work/main/src/pointloom/kernels/algebra/transform.py:27
static CUDA_CALLABLE void adj_widen_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.icp.jobs.sum_moments_element>:1
static CUDA_CALLABLE void adj_sum_moments_element_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::int32 var_i,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_points,
    wp::int32 & adj_i,
    wp::vec_t<4, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void sum_moments_fold_tiles_2ab2275b_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_starts_,
    wp::array_t<wp::int32> var_live_,
    wp::array_t<wp::vec_t<4, wp::float64>> var_partials_,
    wp::array_t<wp::vec_t<4, wp::float64>> var_out_)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        const wp::int32 var_1 = 256;
        wp::int32 var_2;
        wp::vec_t<4, wp::float64> var_3;
        wp::int32* var_4;
        const wp::int32 var_5 = 256;
        wp::int32 var_6;
        wp::int32 var_7;
        wp::int32 var_8;
        const wp::int32 var_9 = 1;
        wp::int32 var_10;
        wp::int32* var_11;
        const wp::int32 var_12 = 256;
        wp::range_t var_13;
        wp::int32 var_14;
        wp::int32 var_15;
        wp::vec_t<4, wp::float64>* var_16;
        wp::vec_t<4, wp::float64> var_17;
        wp::vec_t<4, wp::float64> var_18;
        const wp::int32 var_19 = 0;
        wp::float64 var_20;
        const wp::int32 var_21 = 1;
        wp::float64 var_22;
        const wp::int32 var_23 = 2;
        wp::float64 var_24;
        const wp::int32 var_25 = 3;
        wp::float64 var_26;
        wp::vec_t<4, wp::float64> var_27;
        const bool var_28 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_29 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_30 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_31 = 0;
        wp::vec_t<4, wp::float64> var_32;
        const wp::int32 var_33 = 0;
        wp::float64 var_34;
        const wp::int32 var_35 = 0;
        const wp::int32 var_36 = 1;
        wp::float64 var_37;
        const wp::int32 var_38 = 1;
        const wp::int32 var_39 = 2;
        wp::float64 var_40;
        const wp::int32 var_41 = 2;
        const wp::int32 var_42 = 3;
        wp::float64 var_43;
        const wp::int32 var_44 = 3;
        const wp::int32 var_45 = 256;
        wp::int32 var_46;
        const wp::int32 var_47 = 0;
        bool var_48;
        //---------
        // forward
        // def sum_moments_fold_tiles(starts_, live_, partials_, out_):                           <L 1>
        // i_ = wp.tid()                                                                          <L 2>
        var_0 = builtin_tid1d();
        // s_ = i_ // 256                                                                         <L 3>
        var_2 = wp::floordiv(var_0, var_1);
        // value_ = vector_()                                                                     <L 4>
        var_3 = wp::vec_t<4, wp::float64>();
        // for j_ in range(starts_[s_] + i_ % 256, starts_[s_ + 1], 256):                         <L 5>
        var_4 = wp::address(var_starts_, var_2);
        var_6 = wp::mod(var_0, var_5);
        var_8 = wp::load(var_4);
        var_7 = wp::add(var_8, var_6);
        var_10 = wp::add(var_2, var_9);
        var_11 = wp::address(var_starts_, var_10);
        var_14 = wp::load(var_11);
        var_13 = wp::range(var_7, var_14, var_12);
        start_for_0:;
            if (iter_cmp(var_13) == 0) goto end_for_0;
            var_15 = wp::iter_next(var_13);
            // value_ += partials_[j_]                                                            <L 6>
            var_16 = wp::address(var_partials_, var_15);
            var_18 = wp::load(var_16);
            var_17 = wp::add(var_3, var_18);
            wp::assign(var_3, var_17);
            goto start_for_0;
        end_for_0:;
        // part_0 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[0], value_[1], value_[2], value_[3]), preserve_type=True)), 0)       <L 7>
        var_20 = wp::extract(var_3, var_19);
        var_22 = wp::extract(var_3, var_21);
        var_24 = wp::extract(var_3, var_23);
        var_26 = wp::extract(var_3, var_25);
        var_27 = wp::vec_t<4, wp::float64>(var_20, var_22, var_24, var_26);
        var_29 = wp::tile<wp::vec_t<4, wp::float64>>(var_27);
        var_30 = wp::tile_sum(var_29);
        var_32 = wp::tile_extract(var_30, var_31);
        // value_[0] = part_0[0]                                                                  <L 8>
        var_34 = wp::extract(var_32, var_33);
        wp::assign_inplace(var_3, var_35, var_34);
        // value_[1] = part_0[1]                                                                  <L 9>
        var_37 = wp::extract(var_32, var_36);
        wp::assign_inplace(var_3, var_38, var_37);
        // value_[2] = part_0[2]                                                                  <L 10>
        var_40 = wp::extract(var_32, var_39);
        wp::assign_inplace(var_3, var_41, var_40);
        // value_[3] = part_0[3]                                                                  <L 11>
        var_43 = wp::extract(var_32, var_42);
        wp::assign_inplace(var_3, var_44, var_43);
        // if i_ % 256 == 0:                                                                      <L 12>
        var_46 = wp::mod(var_0, var_45);
        var_48 = (var_46 == var_47);
        if (var_48) {
            // out_[s_] = value_                                                                  <L 13>
            wp::array_store(var_out_, var_2, var_3);
        }
}



extern "C" __global__ void sum_moments_tiles_c137a5a1_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::array_t<wp::int32> var_firsts_,
    wp::array_t<wp::int32> var_lasts_,
    wp::array_t<wp::int32> var_owners_,
    wp::array_t<wp::int32> var_live_,
    wp::array_t<wp::vec_t<4, wp::float64>> var_partials_)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        const wp::int32 var_1 = 256;
        wp::int32 var_2;
        wp::vec_t<4, wp::float64> var_3;
        wp::int32* var_4;
        wp::int32 var_5;
        wp::int32* var_6;
        const wp::int32 var_7 = 0;
        bool var_8;
        wp::int32 var_9;
        wp::int32* var_10;
        const wp::int32 var_11 = 256;
        wp::int32 var_12;
        wp::int32 var_13;
        wp::int32 var_14;
        wp::int32* var_15;
        const wp::int32 var_16 = 256;
        wp::range_t var_17;
        wp::int32 var_18;
        wp::int32 var_19;
        wp::vec_t<4, wp::float64> var_20;
        wp::vec_t<4, wp::float64> var_21;
        const wp::int32 var_22 = 0;
        wp::float64 var_23;
        const wp::int32 var_24 = 1;
        wp::float64 var_25;
        const wp::int32 var_26 = 2;
        wp::float64 var_27;
        const wp::int32 var_28 = 3;
        wp::float64 var_29;
        wp::vec_t<4, wp::float64> var_30;
        const bool var_31 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_32 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_33 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_34 = 0;
        wp::vec_t<4, wp::float64> var_35;
        const wp::int32 var_36 = 0;
        wp::float64 var_37;
        const wp::int32 var_38 = 0;
        const wp::int32 var_39 = 1;
        wp::float64 var_40;
        const wp::int32 var_41 = 1;
        const wp::int32 var_42 = 2;
        wp::float64 var_43;
        const wp::int32 var_44 = 2;
        const wp::int32 var_45 = 3;
        wp::float64 var_46;
        const wp::int32 var_47 = 3;
        const wp::int32 var_48 = 256;
        wp::int32 var_49;
        const wp::int32 var_50 = 0;
        bool var_51;
        //---------
        // forward
        // def sum_moments_tiles(points, firsts_, lasts_, owners_, live_, partials_):             <L 1>
        // i_ = wp.tid()                                                                          <L 2>
        var_0 = builtin_tid1d();
        // b_ = i_ // 256                                                                         <L 3>
        var_2 = wp::floordiv(var_0, var_1);
        // value_ = vector_()                                                                     <L 4>
        var_3 = wp::vec_t<4, wp::float64>();
        // if live_[owners_[b_]] != 0:                                                            <L 5>
        var_4 = wp::address(var_owners_, var_2);
        var_5 = wp::load(var_4);
        var_6 = wp::address(var_live_, var_5);
        var_9 = wp::load(var_6);
        var_8 = (var_9 != var_7);
        if (var_8) {
            // for j_ in range(firsts_[b_] + i_ % 256, lasts_[b_], 256):                          <L 6>
            var_10 = wp::address(var_firsts_, var_2);
            var_12 = wp::mod(var_0, var_11);
            var_14 = wp::load(var_10);
            var_13 = wp::add(var_14, var_12);
            var_15 = wp::address(var_lasts_, var_2);
            var_18 = wp::load(var_15);
            var_17 = wp::range(var_13, var_18, var_16);
            start_for_0:;
                if (iter_cmp(var_17) == 0) goto end_for_0;
                var_19 = wp::iter_next(var_17);
                // value_ += element_(points, j_)                                                 <L 7>
                var_20 = sum_moments_element_0(var_points, var_19);
                var_21 = wp::add(var_3, var_20);
                wp::assign(var_3, var_21);
                goto start_for_0;
            end_for_0:;
        }
        // part_0 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[0], value_[1], value_[2], value_[3]), preserve_type=True)), 0)       <L 8>
        var_23 = wp::extract(var_3, var_22);
        var_25 = wp::extract(var_3, var_24);
        var_27 = wp::extract(var_3, var_26);
        var_29 = wp::extract(var_3, var_28);
        var_30 = wp::vec_t<4, wp::float64>(var_23, var_25, var_27, var_29);
        var_32 = wp::tile<wp::vec_t<4, wp::float64>>(var_30);
        var_33 = wp::tile_sum(var_32);
        var_35 = wp::tile_extract(var_33, var_34);
        // value_[0] = part_0[0]                                                                  <L 9>
        var_37 = wp::extract(var_35, var_36);
        wp::assign_inplace(var_3, var_38, var_37);
        // value_[1] = part_0[1]                                                                  <L 10>
        var_40 = wp::extract(var_35, var_39);
        wp::assign_inplace(var_3, var_41, var_40);
        // value_[2] = part_0[2]                                                                  <L 11>
        var_43 = wp::extract(var_35, var_42);
        wp::assign_inplace(var_3, var_44, var_43);
        // value_[3] = part_0[3]                                                                  <L 12>
        var_46 = wp::extract(var_35, var_45);
        wp::assign_inplace(var_3, var_47, var_46);
        // if i_ % 256 == 0:                                                                      <L 13>
        var_49 = wp::mod(var_0, var_48);
        var_51 = (var_49 == var_50);
        if (var_51) {
            // partials_[b_] = value_                                                             <L 14>
            wp::array_store(var_partials_, var_2, var_3);
        }
}


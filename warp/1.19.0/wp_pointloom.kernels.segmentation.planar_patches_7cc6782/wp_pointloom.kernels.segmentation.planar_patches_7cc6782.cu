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


// /work/main/src/pointloom/kernels/language/warp_compiler.py:143
static CUDA_CALLABLE void adj__float_bits_0(
    wp::float32 var_x,
    wp::float32 & adj_x,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void bound_runs_kernel_222e9727_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_statistics,
    wp::array_t<wp::float32> var_spreads,
    wp::float32 var_slack,
    wp::array_t<wp::float32> var_similar,
    wp::array_t<wp::float32> var_near)
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
        wp::int32 var_5;
        wp::float32* var_6;
        const wp::float32 var_7 = 4.4478;
        wp::int32 var_8;
        wp::float32* var_9;
        wp::float32 var_10;
        wp::float32 var_11;
        wp::float32 var_12;
        wp::float32 var_13;
        const wp::float32 var_14 = 0.999999;
        wp::float32 var_15;
        const wp::int32 var_16 = 4;
        wp::int32 var_17;
        wp::int32 var_18;
        wp::float32* var_19;
        const wp::int32 var_20 = 4;
        wp::int32 var_21;
        wp::int32 var_22;
        wp::float32* var_23;
        wp::float32 var_24;
        wp::float32 var_25;
        wp::float32 var_26;
        wp::float32 var_27;
        wp::float32 var_28;
        //---------
        // forward
        // def bound_runs_kernel(                                                                 <L 179>
        // i = tid()                                                                              <L 187>
        var_0 = builtin_tid1d();
        // runs = near.shape[0]                                                                   <L 188>
        var_1 = &(var_near.shape);
        var_4 = wp::load(var_1);
        var_3 = wp::extract(var_4, var_2);
        // similar[i] = min(statistics[runs + i] - SPREAD_MAD * spreads[runs + i], MAX_SIMILAR)       <L 189>
        var_5 = wp::add(var_3, var_0);
        var_6 = wp::address(var_statistics, var_5);
        var_8 = wp::add(var_3, var_0);
        var_9 = wp::address(var_spreads, var_8);
        var_11 = wp::load(var_9);
        var_10 = wp::mul(var_7, var_11);
        var_13 = wp::load(var_6);
        var_12 = wp::sub(var_13, var_10);
        var_15 = wp::min(var_12, var_14);
        wp::array_store(var_similar, var_0, var_15);
        // near[i] = max(statistics[4 * runs + i] + SPREAD_MAD * spreads[4 * runs + i], slack)       <L 190>
        var_17 = wp::mul(var_16, var_3);
        var_18 = wp::add(var_17, var_0);
        var_19 = wp::address(var_statistics, var_18);
        var_21 = wp::mul(var_20, var_3);
        var_22 = wp::add(var_21, var_0);
        var_23 = wp::address(var_spreads, var_22);
        var_25 = wp::load(var_23);
        var_24 = wp::mul(var_7, var_25);
        var_27 = wp::load(var_19);
        var_26 = wp::add(var_27, var_24);
        var_28 = wp::max(var_26, var_slack);
        wp::array_store(var_near, var_0, var_28);
}



extern "C" __global__ void deviate_kernel_3480fe8f_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_values,
    wp::array_t<wp::int32> var_runs,
    wp::array_t<wp::float32> var_statistics,
    wp::array_t<wp::float32> var_out)
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
        wp::int32 var_5;
        wp::shape_t* var_6;
        const wp::int32 var_7 = 0;
        wp::int32 var_8;
        wp::shape_t var_9;
        const wp::int32 var_10 = 6;
        wp::int32 var_11;
        const wp::int32 var_12 = 3;
        wp::int32 var_13;
        const wp::int32 var_14 = 1;
        wp::int32 var_15;
        wp::int32 var_16;
        wp::shape_t* var_17;
        const wp::int32 var_18 = 0;
        wp::int32 var_19;
        wp::shape_t var_20;
        wp::int32 var_21;
        wp::int32 var_22;
        wp::int32* var_23;
        wp::int32 var_24;
        wp::int32 var_25;
        wp::float32* var_26;
        wp::float32 var_27;
        wp::float32 var_28;
        wp::float32* var_29;
        wp::float32 var_30;
        wp::float32 var_31;
        wp::float32 var_32;
        //---------
        // forward
        // def deviate_kernel(                                                                    <L 102>
        // i = tid()                                                                              <L 106>
        var_0 = builtin_tid1d();
        // quantity = i // runs.shape[0]                                                          <L 107>
        var_1 = &(var_runs.shape);
        var_4 = wp::load(var_1);
        var_3 = wp::extract(var_4, var_2);
        var_5 = wp::floordiv(var_0, var_3);
        // count = statistics.shape[0] // 6                                                       <L 108>
        var_6 = &(var_statistics.shape);
        var_9 = wp::load(var_6);
        var_8 = wp::extract(var_9, var_7);
        var_11 = wp::floordiv(var_8, var_10);
        // median = statistics[(3 * quantity + 1) * count + runs[i - quantity * runs.shape[0]]]       <L 109>
        var_13 = wp::mul(var_12, var_5);
        var_15 = wp::add(var_13, var_14);
        var_16 = wp::mul(var_15, var_11);
        var_17 = &(var_runs.shape);
        var_20 = wp::load(var_17);
        var_19 = wp::extract(var_20, var_18);
        var_21 = wp::mul(var_5, var_19);
        var_22 = wp::sub(var_0, var_21);
        var_23 = wp::address(var_runs, var_22);
        var_25 = wp::load(var_23);
        var_24 = wp::add(var_16, var_25);
        var_26 = wp::address(var_statistics, var_24);
        var_28 = wp::load(var_26);
        var_27 = wp::copy(var_28);
        // out[i] = abs(values[i] - median)                                                       <L 110>
        var_29 = wp::address(var_values, var_0);
        var_31 = wp::load(var_29);
        var_30 = wp::sub(var_31, var_27);
        var_32 = wp::abs(var_30);
        wp::array_store(var_out, var_0, var_32);
}



extern "C" __global__ void take_normal_axes_kernel_46c03d88_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_normals,
    wp::array_t<wp::int32> var_rows,
    wp::array_t<wp::int32> var_runs,
    wp::array_t<wp::vec_t<3, wp::float32>> var_references,
    wp::array_t<wp::float32> var_out)
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
        wp::int32* var_6;
        wp::int32 var_7;
        wp::vec_t<3, wp::float32>* var_8;
        wp::float32 var_9;
        wp::vec_t<3, wp::float32> var_10;
        const wp::float32 var_11 = 0.0;
        bool var_12;
        wp::vec_t<3, wp::float32> var_13;
        wp::vec_t<3, wp::float32> var_14;
        const wp::int32 var_15 = 0;
        wp::float32 var_16;
        wp::shape_t* var_17;
        const wp::int32 var_18 = 0;
        wp::int32 var_19;
        wp::shape_t var_20;
        wp::int32 var_21;
        wp::int32 var_22;
        const wp::int32 var_23 = 1;
        wp::float32 var_24;
        wp::shape_t* var_25;
        const wp::int32 var_26 = 0;
        wp::int32 var_27;
        wp::shape_t var_28;
        wp::int32 var_29;
        wp::int32 var_30;
        const wp::int32 var_31 = 2;
        wp::float32 var_32;
        wp::shape_t* var_33;
        const wp::int32 var_34 = 0;
        wp::int32 var_35;
        wp::shape_t var_36;
        wp::int32 var_37;
        wp::int32 var_38;
        //---------
        // forward
        // def take_normal_axes_kernel(                                                           <L 54>
        // i = tid()                                                                              <L 62>
        var_0 = builtin_tid1d();
        // n = normals[rows[i]]                                                                   <L 63>
        var_1 = wp::address(var_rows, var_0);
        var_2 = wp::load(var_1);
        var_3 = wp::address(var_normals, var_2);
        var_5 = wp::load(var_3);
        var_4 = wp::copy(var_5);
        // if dot(n, references[runs[i]]) < 0.0:                                                  <L 64>
        var_6 = wp::address(var_runs, var_0);
        var_7 = wp::load(var_6);
        var_8 = wp::address(var_references, var_7);
        var_10 = wp::load(var_8);
        var_9 = wp::dot(var_4, var_10);
        var_12 = (var_9 < var_11);
        if (var_12) {
            // n = -n                                                                             <L 65>
            var_13 = wp::neg(var_4);
        }
        var_14 = wp::where(var_12, var_13, var_4);
        // for axis in range(3):                                                                  <L 66>
        // out[axis * rows.shape[0] + i] = n[axis]                                                <L 67>
        var_16 = wp::extract(var_14, var_15);
        var_17 = &(var_rows.shape);
        var_20 = wp::load(var_17);
        var_19 = wp::extract(var_20, var_18);
        var_21 = wp::mul(var_15, var_19);
        var_22 = wp::add(var_21, var_0);
        wp::array_store(var_out, var_22, var_16);
        var_24 = wp::extract(var_14, var_23);
        var_25 = &(var_rows.shape);
        var_28 = wp::load(var_25);
        var_27 = wp::extract(var_28, var_26);
        var_29 = wp::mul(var_23, var_27);
        var_30 = wp::add(var_29, var_0);
        wp::array_store(var_out, var_30, var_24);
        var_32 = wp::extract(var_14, var_31);
        var_33 = &(var_rows.shape);
        var_36 = wp::load(var_33);
        var_35 = wp::extract(var_36, var_34);
        var_37 = wp::mul(var_31, var_35);
        var_38 = wp::add(var_37, var_0);
        wp::array_store(var_out, var_38, var_32);
}



extern "C" __global__ void lift_centers_kernel_4c0ab3cc_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_heights,
    wp::array_t<wp::vec_t<3, wp::float32>> var_directions,
    wp::array_t<wp::vec_t<3, wp::float32>> var_centers)
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
        wp::vec_t<3, wp::float32>* var_2;
        wp::shape_t* var_3;
        const wp::int32 var_4 = 0;
        wp::int32 var_5;
        wp::shape_t var_6;
        wp::int32 var_7;
        wp::float32* var_8;
        wp::vec_t<3, wp::float32> var_9;
        wp::vec_t<3, wp::float32> var_10;
        wp::float32 var_11;
        wp::vec_t<3, wp::float32> var_12;
        wp::vec_t<3, wp::float32> var_13;
        //---------
        // forward
        // def lift_centers_kernel(heights: array(dtype=float32), directions: array(dtype=vec3), centers: array(dtype=vec3)):       <L 173>
        // i = tid()                                                                              <L 174>
        var_0 = builtin_tid1d();
        // centers[i] = centers[i] + directions[i] * heights[centers.shape[0] + i]                <L 175>
        var_1 = wp::address(var_centers, var_0);
        var_2 = wp::address(var_directions, var_0);
        var_3 = &(var_centers.shape);
        var_6 = wp::load(var_3);
        var_5 = wp::extract(var_6, var_4);
        var_7 = wp::add(var_5, var_0);
        var_8 = wp::address(var_heights, var_7);
        var_10 = wp::load(var_2);
        var_11 = wp::load(var_8);
        var_9 = wp::mul(var_10, var_11);
        var_13 = wp::load(var_1);
        var_12 = wp::add(var_13, var_9);
        wp::array_store(var_centers, var_0, var_12);
}



extern "C" __global__ void finish_planes_kernel_6d036489_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_coordinates,
    wp::array_t<wp::float32> var_sides,
    wp::array_t<wp::vec_t<3, wp::float32>> var_references,
    wp::array_t<wp::vec_t<3, wp::float32>> var_centers,
    wp::array_t<wp::vec_t<3, wp::float32>> var_directions,
    wp::array_t<wp::float32> var_edges)
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
        wp::int32 var_5;
        wp::float32* var_6;
        wp::float32 var_7;
        wp::float32 var_8;
        const wp::int32 var_9 = 4;
        wp::int32 var_10;
        wp::int32 var_11;
        wp::float32* var_12;
        wp::float32 var_13;
        wp::float32 var_14;
        const wp::int32 var_15 = 7;
        wp::int32 var_16;
        wp::int32 var_17;
        wp::float32* var_18;
        wp::float32 var_19;
        wp::float32 var_20;
        wp::float32 var_21;
        wp::float32 var_22;
        wp::float32 var_23;
        wp::float32 var_24;
        wp::float32 var_25;
        wp::float32 var_26;
        wp::vec_t<3, wp::float32>* var_27;
        wp::vec_t<3, wp::float32> var_28;
        wp::vec_t<3, wp::float32> var_29;
        const wp::float32 var_30 = 0.0;
        bool var_31;
        wp::float32 var_32;
        wp::float32 var_33;
        wp::float32 var_34;
        wp::vec_t<3, wp::float32> var_35;
        wp::vec_t<3, wp::float32> var_36;
        wp::int32 var_37;
        wp::float32* var_38;
        const wp::int32 var_39 = 4;
        wp::int32 var_40;
        wp::int32 var_41;
        wp::float32* var_42;
        const wp::int32 var_43 = 7;
        wp::int32 var_44;
        wp::int32 var_45;
        wp::float32* var_46;
        wp::vec_t<3, wp::float32> var_47;
        wp::float32 var_48;
        wp::float32 var_49;
        wp::float32 var_50;
        const wp::float32 var_51 = 0.0;
        wp::float32 var_52;
        const wp::int32 var_53 = 0;
        const wp::int32 var_54 = 3;
        wp::int32 var_55;
        wp::int32 var_56;
        wp::int32 var_57;
        const wp::int32 var_58 = 2;
        wp::int32 var_59;
        wp::int32 var_60;
        wp::float32* var_61;
        wp::float32* var_62;
        wp::float32 var_63;
        wp::float32 var_64;
        wp::float32 var_65;
        wp::float32 var_66;
        const wp::int32 var_67 = 1;
        const wp::int32 var_68 = 3;
        wp::int32 var_69;
        wp::int32 var_70;
        wp::int32 var_71;
        const wp::int32 var_72 = 2;
        wp::int32 var_73;
        wp::int32 var_74;
        wp::float32* var_75;
        wp::float32* var_76;
        wp::float32 var_77;
        wp::float32 var_78;
        wp::float32 var_79;
        wp::float32 var_80;
        const wp::int32 var_81 = 2;
        const wp::int32 var_82 = 3;
        wp::int32 var_83;
        wp::int32 var_84;
        wp::int32 var_85;
        const wp::int32 var_86 = 2;
        wp::int32 var_87;
        wp::int32 var_88;
        wp::float32* var_89;
        wp::float32* var_90;
        wp::float32 var_91;
        wp::float32 var_92;
        wp::float32 var_93;
        wp::float32 var_94;
        //---------
        // forward
        // def finish_planes_kernel(                                                              <L 145>
        // i = tid()                                                                              <L 154>
        var_0 = builtin_tid1d();
        // runs = edges.shape[0]                                                                  <L 155>
        var_1 = &(var_edges.shape);
        var_4 = wp::load(var_1);
        var_3 = wp::extract(var_4, var_2);
        // x = sides[runs + i]                                                                    <L 156>
        var_5 = wp::add(var_3, var_0);
        var_6 = wp::address(var_sides, var_5);
        var_8 = wp::load(var_6);
        var_7 = wp::copy(var_8);
        // y = sides[4 * runs + i]                                                                <L 157>
        var_10 = wp::mul(var_9, var_3);
        var_11 = wp::add(var_10, var_0);
        var_12 = wp::address(var_sides, var_11);
        var_14 = wp::load(var_12);
        var_13 = wp::copy(var_14);
        // z = sides[7 * runs + i]                                                                <L 158>
        var_16 = wp::mul(var_15, var_3);
        var_17 = wp::add(var_16, var_0);
        var_18 = wp::address(var_sides, var_17);
        var_20 = wp::load(var_18);
        var_19 = wp::copy(var_20);
        // size = sqrt(x * x + y * y + z * z)                                                     <L 159>
        var_21 = wp::mul(var_7, var_7);
        var_22 = wp::mul(var_13, var_13);
        var_23 = wp::add(var_21, var_22);
        var_24 = wp::mul(var_19, var_19);
        var_25 = wp::add(var_23, var_24);
        var_26 = wp::sqrt(var_25);
        // direction = references[i]                                                              <L 160>
        var_27 = wp::address(var_references, var_0);
        var_29 = wp::load(var_27);
        var_28 = wp::copy(var_29);
        // if size > 0.0:                                                                         <L 161>
        var_31 = (var_26 > var_30);
        if (var_31) {
            // direction = vec3(x / size, y / size, z / size)                                     <L 162>
            var_32 = wp::div(var_7, var_26);
            var_33 = wp::div(var_13, var_26);
            var_34 = wp::div(var_19, var_26);
            var_35 = wp::vec_t<3, wp::float32>(var_32, var_33, var_34);
        }
        var_36 = wp::where(var_31, var_35, var_28);
        // directions[i] = direction                                                              <L 163>
        wp::array_store(var_directions, var_0, var_36);
        // centers[i] = vec3(coordinates[runs + i], coordinates[4 * runs + i], coordinates[7 * runs + i])       <L 164>
        var_37 = wp::add(var_3, var_0);
        var_38 = wp::address(var_coordinates, var_37);
        var_40 = wp::mul(var_39, var_3);
        var_41 = wp::add(var_40, var_0);
        var_42 = wp::address(var_coordinates, var_41);
        var_44 = wp::mul(var_43, var_3);
        var_45 = wp::add(var_44, var_0);
        var_46 = wp::address(var_coordinates, var_45);
        var_48 = wp::load(var_38);
        var_49 = wp::load(var_42);
        var_50 = wp::load(var_46);
        var_47 = wp::vec_t<3, wp::float32>(var_48, var_49, var_50);
        wp::array_store(var_centers, var_0, var_47);
        // edge = float(0.0)                                                                      <L 165>
        var_52 = wp::float(var_51);
        // for axis in range(3):                                                                  <L 166>
        // at = 3 * axis * runs + i                                                               <L 167>
        var_55 = wp::mul(var_54, var_53);
        var_56 = wp::mul(var_55, var_3);
        var_57 = wp::add(var_56, var_0);
        // edge = max(edge, coordinates[at + 2 * runs] - coordinates[at])                         <L 168>
        var_59 = wp::mul(var_58, var_3);
        var_60 = wp::add(var_57, var_59);
        var_61 = wp::address(var_coordinates, var_60);
        var_62 = wp::address(var_coordinates, var_57);
        var_64 = wp::load(var_61);
        var_65 = wp::load(var_62);
        var_63 = wp::sub(var_64, var_65);
        var_66 = wp::max(var_52, var_63);
        // at = 3 * axis * runs + i                                                               <L 167>
        var_69 = wp::mul(var_68, var_67);
        var_70 = wp::mul(var_69, var_3);
        var_71 = wp::add(var_70, var_0);
        // edge = max(edge, coordinates[at + 2 * runs] - coordinates[at])                         <L 168>
        var_73 = wp::mul(var_72, var_3);
        var_74 = wp::add(var_71, var_73);
        var_75 = wp::address(var_coordinates, var_74);
        var_76 = wp::address(var_coordinates, var_71);
        var_78 = wp::load(var_75);
        var_79 = wp::load(var_76);
        var_77 = wp::sub(var_78, var_79);
        var_80 = wp::max(var_66, var_77);
        // at = 3 * axis * runs + i                                                               <L 167>
        var_83 = wp::mul(var_82, var_81);
        var_84 = wp::mul(var_83, var_3);
        var_85 = wp::add(var_84, var_0);
        // edge = max(edge, coordinates[at + 2 * runs] - coordinates[at])                         <L 168>
        var_87 = wp::mul(var_86, var_3);
        var_88 = wp::add(var_85, var_87);
        var_89 = wp::address(var_coordinates, var_88);
        var_90 = wp::address(var_coordinates, var_85);
        var_92 = wp::load(var_89);
        var_93 = wp::load(var_90);
        var_91 = wp::sub(var_92, var_93);
        var_94 = wp::max(var_80, var_91);
        // edges[i] = edge                                                                        <L 169>
        wp::array_store(var_edges, var_0, var_94);
}



extern "C" __global__ void measure_points_kernel_70fae51a_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_normals,
    wp::array_t<wp::int32> var_rows,
    wp::array_t<wp::int32> var_runs,
    wp::array_t<wp::vec_t<3, wp::float32>> var_centers,
    wp::array_t<wp::vec_t<3, wp::float32>> var_directions,
    wp::array_t<wp::float32> var_measured)
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
        wp::int32 var_3;
        wp::vec_t<3, wp::float32>* var_4;
        wp::int32* var_5;
        wp::int32 var_6;
        wp::vec_t<3, wp::float32>* var_7;
        wp::float32 var_8;
        wp::vec_t<3, wp::float32> var_9;
        wp::vec_t<3, wp::float32> var_10;
        wp::float32 var_11;
        wp::vec_t<3, wp::float32>* var_12;
        wp::int32* var_13;
        wp::int32 var_14;
        wp::vec_t<3, wp::float32>* var_15;
        wp::vec_t<3, wp::float32>* var_16;
        wp::vec_t<3, wp::float32> var_17;
        wp::vec_t<3, wp::float32> var_18;
        wp::vec_t<3, wp::float32> var_19;
        wp::float32 var_20;
        wp::vec_t<3, wp::float32> var_21;
        wp::float32 var_22;
        wp::shape_t* var_23;
        const wp::int32 var_24 = 0;
        wp::int32 var_25;
        wp::shape_t var_26;
        wp::int32 var_27;
        //---------
        // forward
        // def measure_points_kernel(                                                             <L 71>
        // i = tid()                                                                              <L 81>
        var_0 = builtin_tid1d();
        // run = runs[i]                                                                          <L 82>
        var_1 = wp::address(var_runs, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // measured[i] = abs(dot(directions[run], normals[rows[i]]))                              <L 83>
        var_4 = wp::address(var_directions, var_2);
        var_5 = wp::address(var_rows, var_0);
        var_6 = wp::load(var_5);
        var_7 = wp::address(var_normals, var_6);
        var_9 = wp::load(var_4);
        var_10 = wp::load(var_7);
        var_8 = wp::dot(var_9, var_10);
        var_11 = wp::abs(var_8);
        wp::array_store(var_measured, var_0, var_11);
        // measured[rows.shape[0] + i] = abs(dot(directions[run], points[rows[i]] - centers[run]))       <L 84>
        var_12 = wp::address(var_directions, var_2);
        var_13 = wp::address(var_rows, var_0);
        var_14 = wp::load(var_13);
        var_15 = wp::address(var_points, var_14);
        var_16 = wp::address(var_centers, var_2);
        var_18 = wp::load(var_15);
        var_19 = wp::load(var_16);
        var_17 = wp::sub(var_18, var_19);
        var_21 = wp::load(var_12);
        var_20 = wp::dot(var_21, var_17);
        var_22 = wp::abs(var_20);
        var_23 = &(var_rows.shape);
        var_26 = wp::load(var_23);
        var_25 = wp::extract(var_26, var_24);
        var_27 = wp::add(var_25, var_0);
        wp::array_store(var_measured, var_27, var_22);
}



extern "C" __global__ void claim_seeds_kernel_9f966710_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_measured,
    wp::array_t<wp::int32> var_rows,
    wp::array_t<wp::int32> var_runs,
    wp::array_t<wp::float32> var_similar,
    wp::array_t<wp::float32> var_near,
    wp::array_t<wp::int32> var_names,
    wp::array_t<wp::int32> var_labels)
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
        wp::int32 var_3;
        bool var_4;
        wp::float32* var_5;
        wp::float32* var_6;
        bool var_7;
        wp::float32 var_8;
        wp::float32 var_9;
        wp::shape_t* var_10;
        const wp::int32 var_11 = 0;
        wp::int32 var_12;
        wp::shape_t var_13;
        wp::int32 var_14;
        wp::float32* var_15;
        wp::float32* var_16;
        bool var_17;
        wp::float32 var_18;
        wp::float32 var_19;
        bool var_20;
        wp::int32* var_21;
        const wp::int32 var_22 = 0;
        bool var_23;
        wp::int32 var_24;
        wp::int32* var_25;
        wp::int32 var_26;
        wp::int32 var_27;
        wp::int32* var_28;
        wp::int32 var_29;
        //---------
        // forward
        // def claim_seeds_kernel(                                                                <L 128>
        // i = tid()                                                                              <L 137>
        var_0 = builtin_tid1d();
        // run = runs[i]                                                                          <L 138>
        var_1 = wp::address(var_runs, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // is_inlier = measured[i] >= similar[run] and measured[runs.shape[0] + i] <= near[run]       <L 139>
        var_5 = wp::address(var_measured, var_0);
        var_6 = wp::address(var_similar, var_2);
        var_8 = wp::load(var_5);
        var_9 = wp::load(var_6);
        var_7 = (var_8 >= var_9);
        var_4 = var_7;
        if (var_4) {
            var_10 = &(var_runs.shape);
            var_13 = wp::load(var_10);
            var_12 = wp::extract(var_13, var_11);
            var_14 = wp::add(var_12, var_0);
            var_15 = wp::address(var_measured, var_14);
            var_16 = wp::address(var_near, var_2);
            var_18 = wp::load(var_15);
            var_19 = wp::load(var_16);
            var_17 = (var_18 <= var_19);
            var_4 = var_4 && var_17;
        }
        // if names[run] >= 0 and is_inlier:                                                      <L 140>
        var_21 = wp::address(var_names, var_2);
        var_24 = wp::load(var_21);
        var_23 = (var_24 >= var_22);
        var_20 = var_23;
        if (var_20) {
            var_20 = var_20 && var_4;
        }
        if (var_20) {
            // labels[rows[i]] = names[run]                                                       <L 141>
            var_25 = wp::address(var_names, var_2);
            var_27 = wp::load(var_25);
            var_26 = wp::copy(var_27);
            var_28 = wp::address(var_rows, var_0);
            var_29 = wp::load(var_28);
            wp::array_store(var_labels, var_29, var_26);
        }
}



extern "C" __global__ void measure_heights_kernel_ae8044c6_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::array_t<wp::int32> var_rows,
    wp::array_t<wp::int32> var_runs,
    wp::array_t<wp::vec_t<3, wp::float32>> var_centers,
    wp::array_t<wp::vec_t<3, wp::float32>> var_directions,
    wp::array_t<wp::float32> var_heights)
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
        wp::int32 var_3;
        wp::vec_t<3, wp::float32>* var_4;
        wp::int32* var_5;
        wp::int32 var_6;
        wp::vec_t<3, wp::float32>* var_7;
        wp::vec_t<3, wp::float32>* var_8;
        wp::vec_t<3, wp::float32> var_9;
        wp::vec_t<3, wp::float32> var_10;
        wp::vec_t<3, wp::float32> var_11;
        wp::float32 var_12;
        wp::vec_t<3, wp::float32> var_13;
        //---------
        // forward
        // def measure_heights_kernel(                                                            <L 88>
        // i = tid()                                                                              <L 96>
        var_0 = builtin_tid1d();
        // run = runs[i]                                                                          <L 97>
        var_1 = wp::address(var_runs, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // heights[i] = dot(directions[run], points[rows[i]] - centers[run])                      <L 98>
        var_4 = wp::address(var_directions, var_2);
        var_5 = wp::address(var_rows, var_0);
        var_6 = wp::load(var_5);
        var_7 = wp::address(var_points, var_6);
        var_8 = wp::address(var_centers, var_2);
        var_10 = wp::load(var_7);
        var_11 = wp::load(var_8);
        var_9 = wp::sub(var_10, var_11);
        var_13 = wp::load(var_4);
        var_12 = wp::dot(var_13, var_9);
        wp::array_store(var_heights, var_0, var_12);
}



extern "C" __global__ void pack_planes_kernel_d92a5e41_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_centers,
    wp::array_t<wp::vec_t<3, wp::float32>> var_directions,
    wp::array_t<wp::float32> var_edges,
    wp::array_t<wp::float32> var_similar,
    wp::array_t<wp::float32> var_near,
    wp::array_t<wp::int32> var_outliers,
    wp::array_t<wp::int32> var_starts,
    wp::array_t<wp::int32> var_packed)
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
        wp::vec_t<3, wp::float32>* var_2;
        wp::float32 var_3;
        wp::vec_t<3, wp::float32> var_4;
        wp::int32 var_5;
        wp::vec_t<3, wp::float32>* var_6;
        wp::float32 var_7;
        wp::vec_t<3, wp::float32> var_8;
        wp::int32 var_9;
        const wp::int32 var_10 = 3;
        wp::int32 var_11;
        const wp::int32 var_12 = 1;
        wp::vec_t<3, wp::float32>* var_13;
        wp::float32 var_14;
        wp::vec_t<3, wp::float32> var_15;
        wp::int32 var_16;
        wp::vec_t<3, wp::float32>* var_17;
        wp::float32 var_18;
        wp::vec_t<3, wp::float32> var_19;
        wp::int32 var_20;
        const wp::int32 var_21 = 3;
        wp::int32 var_22;
        const wp::int32 var_23 = 2;
        wp::vec_t<3, wp::float32>* var_24;
        wp::float32 var_25;
        wp::vec_t<3, wp::float32> var_26;
        wp::int32 var_27;
        wp::vec_t<3, wp::float32>* var_28;
        wp::float32 var_29;
        wp::vec_t<3, wp::float32> var_30;
        wp::int32 var_31;
        const wp::int32 var_32 = 3;
        wp::int32 var_33;
        wp::float32* var_34;
        wp::int32 var_35;
        wp::float32 var_36;
        const wp::int32 var_37 = 6;
        wp::float32* var_38;
        wp::int32 var_39;
        wp::float32 var_40;
        const wp::int32 var_41 = 7;
        wp::float32* var_42;
        wp::int32 var_43;
        wp::float32 var_44;
        const wp::int32 var_45 = 8;
        wp::int32* var_46;
        wp::int32 var_47;
        wp::int32 var_48;
        const wp::int32 var_49 = 9;
        const wp::int32 var_50 = 1;
        wp::int32 var_51;
        wp::int32* var_52;
        wp::int32* var_53;
        wp::int32 var_54;
        wp::int32 var_55;
        wp::int32 var_56;
        const wp::int32 var_57 = 10;
        //---------
        // forward
        // def pack_planes_kernel(                                                                <L 194>
        // i = tid()                                                                              <L 205>
        var_0 = builtin_tid1d();
        // for axis in range(3):                                                                  <L 206>
        // packed[i, axis] = float_bits(centers[i][axis])                                         <L 207>
        var_2 = wp::address(var_centers, var_0);
        var_4 = wp::load(var_2);
        var_3 = wp::extract(var_4, var_1);
        var_5 = _float_bits_0(var_3);
        wp::array_store(var_packed, var_0, var_1, var_5);
        // packed[i, 3 + axis] = float_bits(directions[i][axis])                                  <L 208>
        var_6 = wp::address(var_directions, var_0);
        var_8 = wp::load(var_6);
        var_7 = wp::extract(var_8, var_1);
        var_9 = _float_bits_0(var_7);
        var_11 = wp::add(var_10, var_1);
        wp::array_store(var_packed, var_0, var_11, var_9);
        // packed[i, axis] = float_bits(centers[i][axis])                                         <L 207>
        var_13 = wp::address(var_centers, var_0);
        var_15 = wp::load(var_13);
        var_14 = wp::extract(var_15, var_12);
        var_16 = _float_bits_0(var_14);
        wp::array_store(var_packed, var_0, var_12, var_16);
        // packed[i, 3 + axis] = float_bits(directions[i][axis])                                  <L 208>
        var_17 = wp::address(var_directions, var_0);
        var_19 = wp::load(var_17);
        var_18 = wp::extract(var_19, var_12);
        var_20 = _float_bits_0(var_18);
        var_22 = wp::add(var_21, var_12);
        wp::array_store(var_packed, var_0, var_22, var_20);
        // packed[i, axis] = float_bits(centers[i][axis])                                         <L 207>
        var_24 = wp::address(var_centers, var_0);
        var_26 = wp::load(var_24);
        var_25 = wp::extract(var_26, var_23);
        var_27 = _float_bits_0(var_25);
        wp::array_store(var_packed, var_0, var_23, var_27);
        // packed[i, 3 + axis] = float_bits(directions[i][axis])                                  <L 208>
        var_28 = wp::address(var_directions, var_0);
        var_30 = wp::load(var_28);
        var_29 = wp::extract(var_30, var_23);
        var_31 = _float_bits_0(var_29);
        var_33 = wp::add(var_32, var_23);
        wp::array_store(var_packed, var_0, var_33, var_31);
        // packed[i, 6] = float_bits(edges[i])                                                    <L 209>
        var_34 = wp::address(var_edges, var_0);
        var_36 = wp::load(var_34);
        var_35 = _float_bits_0(var_36);
        wp::array_store(var_packed, var_0, var_37, var_35);
        // packed[i, 7] = float_bits(similar[i])                                                  <L 210>
        var_38 = wp::address(var_similar, var_0);
        var_40 = wp::load(var_38);
        var_39 = _float_bits_0(var_40);
        wp::array_store(var_packed, var_0, var_41, var_39);
        // packed[i, 8] = float_bits(near[i])                                                     <L 211>
        var_42 = wp::address(var_near, var_0);
        var_44 = wp::load(var_42);
        var_43 = _float_bits_0(var_44);
        wp::array_store(var_packed, var_0, var_45, var_43);
        // packed[i, 9] = outliers[i]                                                             <L 212>
        var_46 = wp::address(var_outliers, var_0);
        var_48 = wp::load(var_46);
        var_47 = wp::copy(var_48);
        wp::array_store(var_packed, var_0, var_49, var_47);
        // packed[i, 10] = starts[i + 1] - starts[i]                                              <L 213>
        var_51 = wp::add(var_0, var_50);
        var_52 = wp::address(var_starts, var_51);
        var_53 = wp::address(var_starts, var_0);
        var_55 = wp::load(var_52);
        var_56 = wp::load(var_53);
        var_54 = wp::sub(var_55, var_56);
        wp::array_store(var_packed, var_0, var_57, var_54);
}



extern "C" __global__ void count_outliers_kernel_dc05740a_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_measured,
    wp::array_t<wp::int32> var_runs,
    wp::array_t<wp::float32> var_similar,
    wp::array_t<wp::float32> var_near,
    wp::array_t<wp::int32> var_outliers)
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
        wp::int32 var_3;
        bool var_4;
        wp::float32* var_5;
        wp::float32* var_6;
        bool var_7;
        wp::float32 var_8;
        wp::float32 var_9;
        wp::shape_t* var_10;
        const wp::int32 var_11 = 0;
        wp::int32 var_12;
        wp::shape_t var_13;
        wp::int32 var_14;
        wp::float32* var_15;
        wp::float32* var_16;
        bool var_17;
        wp::float32 var_18;
        wp::float32 var_19;
        const wp::int32 var_20 = 1;
        wp::int32 var_21;
        //---------
        // forward
        // def count_outliers_kernel(                                                             <L 114>
        // i = tid()                                                                              <L 121>
        var_0 = builtin_tid1d();
        // run = runs[i]                                                                          <L 122>
        var_1 = wp::address(var_runs, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // if measured[i] < similar[run] or measured[runs.shape[0] + i] > near[run]:              <L 123>
        var_5 = wp::address(var_measured, var_0);
        var_6 = wp::address(var_similar, var_2);
        var_8 = wp::load(var_5);
        var_9 = wp::load(var_6);
        var_7 = (var_8 < var_9);
        var_4 = var_7;
        if (!var_4) {
            var_10 = &(var_runs.shape);
            var_13 = wp::load(var_10);
            var_12 = wp::extract(var_13, var_11);
            var_14 = wp::add(var_12, var_0);
            var_15 = wp::address(var_measured, var_14);
            var_16 = wp::address(var_near, var_2);
            var_18 = wp::load(var_15);
            var_19 = wp::load(var_16);
            var_17 = (var_18 > var_19);
            var_4 = var_4 || var_17;
        }
        if (var_4) {
            // atomic_add(outliers, run, 1)                                                       <L 124>
            var_21 = wp::atomic_add(var_outliers, var_2, var_20);
        }
}



extern "C" __global__ void multiply_normals_kernel_de69ccd2_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_normals,
    wp::array_t<wp::int32> var_rows,
    wp::array_t<wp::float64> var_out)
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
        const wp::int32 var_6 = 0;
        wp::int32 var_7;
        const wp::int32 var_8 = 0;
        const wp::int32 var_9 = 0;
        wp::float32 var_10;
        wp::float64 var_11;
        wp::float32 var_12;
        wp::float64 var_13;
        wp::float64 var_14;
        const wp::int32 var_15 = 1;
        wp::int32 var_16;
        const wp::int32 var_17 = 1;
        wp::float32 var_18;
        wp::float64 var_19;
        wp::float32 var_20;
        wp::float64 var_21;
        wp::float64 var_22;
        const wp::int32 var_23 = 1;
        wp::int32 var_24;
        const wp::int32 var_25 = 2;
        wp::float32 var_26;
        wp::float64 var_27;
        wp::float32 var_28;
        wp::float64 var_29;
        wp::float64 var_30;
        const wp::int32 var_31 = 1;
        wp::int32 var_32;
        const wp::int32 var_33 = 1;
        const wp::int32 var_34 = 1;
        wp::float32 var_35;
        wp::float64 var_36;
        wp::float32 var_37;
        wp::float64 var_38;
        wp::float64 var_39;
        const wp::int32 var_40 = 1;
        wp::int32 var_41;
        const wp::int32 var_42 = 2;
        wp::float32 var_43;
        wp::float64 var_44;
        wp::float32 var_45;
        wp::float64 var_46;
        wp::float64 var_47;
        const wp::int32 var_48 = 1;
        wp::int32 var_49;
        const wp::int32 var_50 = 2;
        const wp::int32 var_51 = 2;
        wp::float32 var_52;
        wp::float64 var_53;
        wp::float32 var_54;
        wp::float64 var_55;
        wp::float64 var_56;
        const wp::int32 var_57 = 1;
        wp::int32 var_58;
        //---------
        // forward
        // def multiply_normals_kernel(normals, rows, out):                                       <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // n = normals[rows[i]]                                                                   <L 3>
        var_1 = wp::address(var_rows, var_0);
        var_2 = wp::load(var_1);
        var_3 = wp::address(var_normals, var_2);
        var_5 = wp::load(var_3);
        var_4 = wp::copy(var_5);
        // at = int(0)                                                                            <L 4>
        var_7 = wp::int(var_6);
        // for a in range(3):                                                                     <L 5>
        // for b in range(a, 3):                                                                  <L 6>
        // out[i, at] = float64(n[a]) * float64(n[b])                                             <L 7>
        var_10 = wp::extract(var_4, var_8);
        var_11 = wp::float64(var_10);
        var_12 = wp::extract(var_4, var_9);
        var_13 = wp::float64(var_12);
        var_14 = wp::mul(var_11, var_13);
        wp::array_store(var_out, var_0, var_7, var_14);
        // at += 1                                                                                <L 8>
        var_16 = wp::add(var_7, var_15);
        // out[i, at] = float64(n[a]) * float64(n[b])                                             <L 7>
        var_18 = wp::extract(var_4, var_8);
        var_19 = wp::float64(var_18);
        var_20 = wp::extract(var_4, var_17);
        var_21 = wp::float64(var_20);
        var_22 = wp::mul(var_19, var_21);
        wp::array_store(var_out, var_0, var_16, var_22);
        // at += 1                                                                                <L 8>
        var_24 = wp::add(var_16, var_23);
        // out[i, at] = float64(n[a]) * float64(n[b])                                             <L 7>
        var_26 = wp::extract(var_4, var_8);
        var_27 = wp::float64(var_26);
        var_28 = wp::extract(var_4, var_25);
        var_29 = wp::float64(var_28);
        var_30 = wp::mul(var_27, var_29);
        wp::array_store(var_out, var_0, var_24, var_30);
        // at += 1                                                                                <L 8>
        var_32 = wp::add(var_24, var_31);
        // for b in range(a, 3):                                                                  <L 6>
        // out[i, at] = float64(n[a]) * float64(n[b])                                             <L 7>
        var_35 = wp::extract(var_4, var_33);
        var_36 = wp::float64(var_35);
        var_37 = wp::extract(var_4, var_34);
        var_38 = wp::float64(var_37);
        var_39 = wp::mul(var_36, var_38);
        wp::array_store(var_out, var_0, var_32, var_39);
        // at += 1                                                                                <L 8>
        var_41 = wp::add(var_32, var_40);
        // out[i, at] = float64(n[a]) * float64(n[b])                                             <L 7>
        var_43 = wp::extract(var_4, var_33);
        var_44 = wp::float64(var_43);
        var_45 = wp::extract(var_4, var_42);
        var_46 = wp::float64(var_45);
        var_47 = wp::mul(var_44, var_46);
        wp::array_store(var_out, var_0, var_41, var_47);
        // at += 1                                                                                <L 8>
        var_49 = wp::add(var_41, var_48);
        // for b in range(a, 3):                                                                  <L 6>
        // out[i, at] = float64(n[a]) * float64(n[b])                                             <L 7>
        var_52 = wp::extract(var_4, var_50);
        var_53 = wp::float64(var_52);
        var_54 = wp::extract(var_4, var_51);
        var_55 = wp::float64(var_54);
        var_56 = wp::mul(var_53, var_55);
        wp::array_store(var_out, var_0, var_49, var_56);
        // at += 1                                                                                <L 8>
        var_58 = wp::add(var_49, var_57);
}



extern "C" __global__ void take_axes_kernel_f7eef35f_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_values,
    wp::array_t<wp::int32> var_rows,
    wp::array_t<wp::float32> var_out)
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
        const wp::int32 var_6 = 0;
        wp::float32 var_7;
        wp::shape_t* var_8;
        const wp::int32 var_9 = 0;
        wp::int32 var_10;
        wp::shape_t var_11;
        wp::int32 var_12;
        wp::int32 var_13;
        const wp::int32 var_14 = 1;
        wp::float32 var_15;
        wp::shape_t* var_16;
        const wp::int32 var_17 = 0;
        wp::int32 var_18;
        wp::shape_t var_19;
        wp::int32 var_20;
        wp::int32 var_21;
        const wp::int32 var_22 = 2;
        wp::float32 var_23;
        wp::shape_t* var_24;
        const wp::int32 var_25 = 0;
        wp::int32 var_26;
        wp::shape_t var_27;
        wp::int32 var_28;
        wp::int32 var_29;
        //---------
        // forward
        // def take_axes_kernel(values: array(dtype=vec3), rows: array(dtype=int32), out: array(dtype=float32)):       <L 45>
        // i = tid()                                                                              <L 47>
        var_0 = builtin_tid1d();
        // value = values[rows[i]]                                                                <L 48>
        var_1 = wp::address(var_rows, var_0);
        var_2 = wp::load(var_1);
        var_3 = wp::address(var_values, var_2);
        var_5 = wp::load(var_3);
        var_4 = wp::copy(var_5);
        // for axis in range(3):                                                                  <L 49>
        // out[axis * rows.shape[0] + i] = value[axis]                                            <L 50>
        var_7 = wp::extract(var_4, var_6);
        var_8 = &(var_rows.shape);
        var_11 = wp::load(var_8);
        var_10 = wp::extract(var_11, var_9);
        var_12 = wp::mul(var_6, var_10);
        var_13 = wp::add(var_12, var_0);
        wp::array_store(var_out, var_13, var_7);
        var_15 = wp::extract(var_4, var_14);
        var_16 = &(var_rows.shape);
        var_19 = wp::load(var_16);
        var_18 = wp::extract(var_19, var_17);
        var_20 = wp::mul(var_14, var_18);
        var_21 = wp::add(var_20, var_0);
        wp::array_store(var_out, var_21, var_15);
        var_23 = wp::extract(var_4, var_22);
        var_24 = &(var_rows.shape);
        var_27 = wp::load(var_24);
        var_26 = wp::extract(var_27, var_25);
        var_28 = wp::mul(var_22, var_26);
        var_29 = wp::add(var_28, var_0);
        wp::array_store(var_out, var_29, var_23);
}


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


// /work/main/src/pointloom/kernels/algebra/plain_min_max.py:6
static CUDA_CALLABLE wp::float32 smaller_0(
    wp::float32 var_a,
    wp::float32 var_b)
{
    //---------
    // primal vars
    bool var_0;
    wp::float32 var_1;
    //---------
    // forward
    // def smaller(a: float, b: float) -> float:                                              <L 7>
    // return a if a < b else b                                                               <L 8>
    var_0 = (var_a < var_b);
    if (var_0) {
    }
    if (!var_0) {
    }
    var_1 = wp::where(var_0, var_a, var_b);
    return var_1;
}


// /work/main/src/pointloom/kernels/algebra/plain_min_max.py:11
static CUDA_CALLABLE wp::float32 larger_0(
    wp::float32 var_a,
    wp::float32 var_b)
{
    //---------
    // primal vars
    bool var_0;
    wp::float32 var_1;
    //---------
    // forward
    // def larger(a: float, b: float) -> float:                                               <L 12>
    // return a if a > b else b                                                               <L 13>
    var_0 = (var_a > var_b);
    if (var_0) {
    }
    if (!var_0) {
    }
    var_1 = wp::where(var_0, var_a, var_b);
    return var_1;
}


// <pointloom.kernels.features.feature_tree.is_one_row>:1
static CUDA_CALLABLE wp::int32 is_one_row_0(
    wp::int32 var_first,
    wp::int32 var_last,
    wp::int32 var_tree__width,
    wp::array_t<wp::float32> var_tree__packed)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 1;
    wp::int32 var_1;
    const wp::int32 var_2 = 1;
    wp::int32 var_3;
    wp::int32 var_4;
    bool var_5;
    wp::int32 var_6;
    bool var_7;
    const wp::int32 var_8 = 1;
    bool var_9;
    wp::float32* var_10;
    wp::int32 var_11;
    wp::float32* var_12;
    bool var_13;
    wp::float32 var_14;
    wp::float32 var_15;
    const wp::int32 var_16 = 0;
    wp::int32 var_17;
    const wp::int32 var_18 = 1;
    wp::int32 var_19;
    //---------
    // forward
    // def is_one_row(first, last, tree__width, tree__packed):                                <L 1>
    // same = int(1)                                                                          <L 2>
    var_1 = wp::int(var_0);
    // at = (first + 1) * tree__width                                                         <L 3>
    var_3 = wp::add(var_first, var_2);
    var_4 = wp::mul(var_3, var_tree__width);
    // while at < last * tree__width and same == 1:                                           <L 4>
    start_while_0:;
    var_6 = wp::mul(var_last, var_tree__width);
    var_7 = (var_4 < var_6);
    var_5 = var_7;
    if (var_5) {
        var_9 = (var_1 == var_8);
        var_5 = var_5 && var_9;
    }
    if ((var_5) == false) goto end_while_0;
        // if tree__packed[at] != tree__packed[at - tree__width]:                             <L 5>
        var_10 = wp::address(var_tree__packed, var_4);
        var_11 = wp::sub(var_4, var_tree__width);
        var_12 = wp::address(var_tree__packed, var_11);
        var_14 = wp::load(var_10);
        var_15 = wp::load(var_12);
        var_13 = (var_14 != var_15);
        if (var_13) {
            // same = 0                                                                       <L 6>
        }
        var_17 = wp::where(var_13, var_16, var_1);
        // at += 1                                                                            <L 7>
        var_19 = wp::add(var_4, var_18);
        wp::assign(var_1, var_17);
        wp::assign(var_4, var_19);
    goto start_while_0;
    end_while_0:;
    // return same                                                                            <L 8>
    return var_1;
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:143
static CUDA_CALLABLE void adj__float_bits_0(
    wp::float32 var_x,
    wp::float32 & adj_x,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/algebra/plain_min_max.py:6
static CUDA_CALLABLE void adj_smaller_0(
    wp::float32 var_a,
    wp::float32 var_b,
    wp::float32 & adj_a,
    wp::float32 & adj_b,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/algebra/plain_min_max.py:11
static CUDA_CALLABLE void adj_larger_0(
    wp::float32 var_a,
    wp::float32 var_b,
    wp::float32 & adj_a,
    wp::float32 & adj_b,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.features.feature_tree.is_one_row>:1
static CUDA_CALLABLE void adj_is_one_row_0(
    wp::int32 var_first,
    wp::int32 var_last,
    wp::int32 var_tree__width,
    wp::array_t<wp::float32> var_tree__packed,
    wp::int32 & adj_first,
    wp::int32 & adj_last,
    wp::int32 & adj_tree__width,
    wp::array_t<wp::float32> & adj_tree__packed,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void mark_rows_kernel_39fe0a49_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_features,
    wp::array_t<wp::uint8> var_usable)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        const wp::int32 var_1 = 1;
        wp::int32 var_2;
        wp::shape_t* var_3;
        const wp::int32 var_4 = 1;
        wp::int32 var_5;
        wp::shape_t var_6;
        wp::range_t var_7;
        wp::int32 var_8;
        wp::float32* var_9;
        wp::float32 var_10;
        wp::float32 var_11;
        const wp::float32 var_12 = 1000000000000000.0;
        bool var_13;
        bool var_14;
        const wp::int32 var_15 = 0;
        wp::int32 var_16;
        wp::uint8 var_17;
        //---------
        // forward
        // def mark_rows_kernel(features, usable):                                                <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // good = int(1)                                                                          <L 4>
        var_2 = wp::int(var_1);
        // for c in range(features.shape[1]):                                                     <L 5>
        var_3 = &(var_features.shape);
        var_6 = wp::load(var_3);
        var_5 = wp::extract(var_6, var_4);
        var_7 = wp::range(var_5);
        start_for_0:;
            if (iter_cmp(var_7) == 0) goto end_for_0;
            var_8 = wp::iter_next(var_7);
            // if not abs(features[i, c]) <= LARGEST_NUMBER:                                      <L 6>
            var_9 = wp::address(var_features, var_0, var_8);
            var_11 = wp::load(var_9);
            var_10 = wp::abs(var_11);
            var_13 = (var_10 <= var_12);
            var_14 = wp::unot(var_13);
            if (var_14) {
                // good = 0                                                                       <L 7>
            }
            var_16 = wp::where(var_14, var_15, var_2);
            wp::assign(var_2, var_16);
            goto start_for_0;
        end_for_0:;
        // usable[i] = uint8(good)                                                                <L 8>
        var_17 = wp::uint8(var_2);
        wp::array_store(var_usable, var_0, var_17);
}



extern "C" __global__ void gather_sample_kernel_41117bb1_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_source__features,
    wp::array_t<wp::int32> var_source__rows,
    wp::array_t<wp::float32> var_sample)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::int64 var_1;
        wp::shape_t* var_2;
        const wp::int32 var_3 = 0;
        wp::int32 var_4;
        wp::shape_t var_5;
        wp::int64 var_6;
        wp::int64 var_7;
        wp::shape_t* var_8;
        const wp::int32 var_9 = 0;
        wp::int32 var_10;
        wp::shape_t var_11;
        wp::int64 var_12;
        wp::int64 var_13;
        wp::int32 var_14;
        wp::int32* var_15;
        wp::int32 var_16;
        wp::int32 var_17;
        wp::shape_t* var_18;
        const wp::int32 var_19 = 1;
        wp::int32 var_20;
        wp::shape_t var_21;
        wp::range_t var_22;
        wp::int32 var_23;
        wp::float32* var_24;
        wp::float32 var_25;
        wp::float32 var_26;
        //---------
        // forward
        // def gather_sample_kernel(source__features, source__rows, sample):                      <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // row = source__rows[int(int64(i) * int64(source__rows.shape[0]) // int64(sample.shape[0]))]       <L 3>
        var_1 = wp::int64(var_0);
        var_2 = &(var_source__rows.shape);
        var_5 = wp::load(var_2);
        var_4 = wp::extract(var_5, var_3);
        var_6 = wp::int64(var_4);
        var_7 = wp::mul(var_1, var_6);
        var_8 = &(var_sample.shape);
        var_11 = wp::load(var_8);
        var_10 = wp::extract(var_11, var_9);
        var_12 = wp::int64(var_10);
        var_13 = wp::floordiv(var_7, var_12);
        var_14 = wp::int(var_13);
        var_15 = wp::address(var_source__rows, var_14);
        var_17 = wp::load(var_15);
        var_16 = wp::copy(var_17);
        // for c in range(source__features.shape[1]):                                             <L 4>
        var_18 = &(var_source__features.shape);
        var_21 = wp::load(var_18);
        var_20 = wp::extract(var_21, var_19);
        var_22 = wp::range(var_20);
        start_for_0:;
            if (iter_cmp(var_22) == 0) goto end_for_0;
            var_23 = wp::iter_next(var_22);
            // sample[i, c] = source__features[row, c]                                            <L 5>
            var_24 = wp::address(var_source__features, var_16, var_23);
            var_26 = wp::load(var_24);
            var_25 = wp::copy(var_26);
            wp::array_store(var_sample, var_0, var_23, var_25);
            goto start_for_0;
        end_for_0:;
}



extern "C" __global__ void pack_rows_kernel_6c0ae02e_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_source__features,
    wp::array_t<wp::int32> var_source__rows,
    wp::array_t<wp::int32> var_before,
    wp::array_t<wp::int32> var_moves,
    wp::array_t<wp::int32> var_order,
    wp::int32 var_tree__width,
    wp::array_t<wp::int32> var_tree__labels,
    wp::array_t<wp::float32> var_tree__packed)
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
        wp::int32* var_3;
        wp::int32 var_4;
        wp::int32 var_5;
        wp::int32* var_6;
        wp::int32 var_7;
        wp::int32 var_8;
        wp::shape_t* var_9;
        const wp::int32 var_10 = 1;
        wp::int32 var_11;
        wp::shape_t var_12;
        wp::range_t var_13;
        wp::int32 var_14;
        wp::float32* var_15;
        wp::float32 var_16;
        wp::float32 var_17;
        wp::int32 var_18;
        wp::int32 var_19;
        wp::range_t var_20;
        wp::int32 var_21;
        const wp::float32 var_22 = 0.0;
        wp::int32 var_23;
        wp::int32 var_24;
        //---------
        // forward
        // def pack_rows_kernel(source__features, source__rows, before, moves, order, tree__width, tree__labels, tree__packed):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // position = before[moves[i]]                                                            <L 4>
        var_1 = wp::address(var_moves, var_0);
        var_2 = wp::load(var_1);
        var_3 = wp::address(var_before, var_2);
        var_5 = wp::load(var_3);
        var_4 = wp::copy(var_5);
        // order[i] = position                                                                    <L 5>
        wp::array_store(var_order, var_0, var_4);
        // row = source__rows[position]                                                           <L 6>
        var_6 = wp::address(var_source__rows, var_4);
        var_8 = wp::load(var_6);
        var_7 = wp::copy(var_8);
        // tree__labels[i] = row                                                                  <L 7>
        wp::array_store(var_tree__labels, var_0, var_7);
        // columns = source__features.shape[1]                                                    <L 8>
        var_9 = &(var_source__features.shape);
        var_12 = wp::load(var_9);
        var_11 = wp::extract(var_12, var_10);
        // for c in range(columns):                                                               <L 9>
        var_13 = wp::range(var_11);
        start_for_0:;
            if (iter_cmp(var_13) == 0) goto end_for_0;
            var_14 = wp::iter_next(var_13);
            // tree__packed[i * tree__width + c] = source__features[row, c]                       <L 10>
            var_15 = wp::address(var_source__features, var_7, var_14);
            var_17 = wp::load(var_15);
            var_16 = wp::copy(var_17);
            var_18 = wp::mul(var_0, var_tree__width);
            var_19 = wp::add(var_18, var_14);
            wp::array_store(var_tree__packed, var_19, var_16);
            goto start_for_0;
        end_for_0:;
        // for c in range(columns, tree__width):                                                  <L 11>
        var_20 = wp::range(var_11, var_tree__width);
        start_for_2:;
            if (iter_cmp(var_20) == 0) goto end_for_2;
            var_21 = wp::iter_next(var_20);
            // tree__packed[i * tree__width + c] = 0.0                                            <L 12>
            var_23 = wp::mul(var_0, var_tree__width);
            var_24 = wp::add(var_23, var_21);
            wp::array_store(var_tree__packed, var_24, var_22);
            goto start_for_2;
        end_for_2:;
}



extern "C" __global__ void make_slab_keys_kernel_750e3450_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_coordinates,
    wp::array_t<wp::int32> var_before,
    wp::array_t<wp::int32> var_moves,
    wp::int32 var_axis,
    wp::int32 var_slab,
    wp::array_t<wp::int32> var_order,
    wp::array_t<wp::int64> var_keys)
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
        bool var_3;
        wp::int32* var_4;
        wp::int32 var_5;
        wp::int32* var_6;
        wp::int32 var_7;
        wp::int32 var_8;
        wp::int32 var_9;
        wp::float32* var_10;
        wp::int32 var_11;
        wp::float32 var_12;
        const wp::int32 var_13 = 31;
        wp::int32 var_14;
        const wp::int32 var_15 = 2147483647;
        wp::int32 var_16;
        wp::int32 var_17;
        wp::int32 var_18;
        const wp::int32 var_19 = 2;
        wp::int32 var_20;
        const wp::int32 var_21 = 1;
        bool var_22;
        const wp::int32 var_23 = -1;
        wp::int32 var_24;
        wp::int32 var_25;
        wp::int32 var_26;
        wp::int64 var_27;
        wp::int64 var_28;
        wp::int64 var_29;
        wp::int64 var_30;
        wp::int64 var_31;
        wp::int64 var_32;
        wp::int64 var_33;
        //---------
        // forward
        // def make_slab_keys_kernel(coordinates, before, moves, axis, slab, order, keys):        <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // position = i                                                                           <L 4>
        var_1 = wp::copy(var_0);
        // if axis > 0:                                                                           <L 5>
        var_3 = (var_axis > var_2);
        if (var_3) {
            // position = before[moves[i]]                                                        <L 6>
            var_4 = wp::address(var_moves, var_0);
            var_5 = wp::load(var_4);
            var_6 = wp::address(var_before, var_5);
            var_8 = wp::load(var_6);
            var_7 = wp::copy(var_8);
        }
        var_9 = wp::where(var_3, var_7, var_1);
        // order[i] = position                                                                    <L 7>
        wp::array_store(var_order, var_0, var_9);
        // bits = float_bits(coordinates[position, axis])                                         <L 8>
        var_10 = wp::address(var_coordinates, var_9, var_axis);
        var_12 = wp::load(var_10);
        var_11 = _float_bits_0(var_12);
        // ascending = bits ^ bits >> 31 & 2147483647                                             <L 9>
        var_14 = wp::rshift(var_11, var_13);
        var_16 = wp::bit_and(var_14, var_15);
        var_17 = wp::bit_xor(var_11, var_16);
        // if i // slab % 2 == 1:                                                                 <L 10>
        var_18 = wp::floordiv(var_0, var_slab);
        var_20 = wp::mod(var_18, var_19);
        var_22 = (var_20 == var_21);
        if (var_22) {
            // ascending = -1 - ascending                                                         <L 11>
            var_24 = wp::sub(var_23, var_17);
        }
        var_25 = wp::where(var_22, var_24, var_17);
        // keys[i] = (int64(i // slab) << int64(32)) + (int64(ascending) + int64(2147483648))       <L 12>
        var_26 = wp::floordiv(var_0, var_slab);
        var_27 = wp::int64(var_26);
        var_28 = 32ll;
        var_29 = wp::lshift(var_27, var_28);
        var_30 = wp::int64(var_25);
        var_31 = 2147483648ll;
        var_32 = wp::add(var_30, var_31);
        var_33 = wp::add(var_29, var_32);
        wp::array_store(var_keys, var_0, var_33);
}



extern "C" __global__ void bound_children_kernel_9f5a8c06_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::int32 var_below,
    wp::int32 var_first,
    wp::array_t<wp::float32> var_boxes)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        const wp::int32 var_1 = 16;
        wp::int32 var_2;
        wp::int32 var_3;
        const wp::int32 var_4 = 192;
        wp::int32 var_5;
        wp::int32 var_6;
        wp::int32 var_7;
        const wp::int32 var_8 = 0;
        const wp::float32 var_9 = INFINITY;
        wp::float32 var_10;
        wp::float32 var_11;
        wp::float32 var_12;
        wp::int32 var_13;
        bool var_14;
        const wp::int32 var_15 = 0;
        wp::int32 var_16;
        wp::int32 var_17;
        wp::int32 var_18;
        wp::int32 var_19;
        wp::int32 var_20;
        wp::float32* var_21;
        wp::float32 var_22;
        wp::float32 var_23;
        const wp::int32 var_24 = 6;
        wp::int32 var_25;
        wp::int32 var_26;
        wp::float32* var_27;
        wp::float32 var_28;
        wp::float32 var_29;
        const wp::int32 var_30 = 1;
        wp::int32 var_31;
        wp::int32 var_32;
        wp::int32 var_33;
        wp::int32 var_34;
        wp::int32 var_35;
        wp::float32* var_36;
        wp::float32 var_37;
        wp::float32 var_38;
        wp::int32 var_39;
        wp::int32 var_40;
        wp::float32* var_41;
        wp::float32 var_42;
        wp::float32 var_43;
        const wp::int32 var_44 = 2;
        wp::int32 var_45;
        wp::int32 var_46;
        wp::int32 var_47;
        wp::int32 var_48;
        wp::int32 var_49;
        wp::float32* var_50;
        wp::float32 var_51;
        wp::float32 var_52;
        wp::int32 var_53;
        wp::int32 var_54;
        wp::float32* var_55;
        wp::float32 var_56;
        wp::float32 var_57;
        const wp::int32 var_58 = 3;
        wp::int32 var_59;
        wp::int32 var_60;
        wp::int32 var_61;
        wp::int32 var_62;
        wp::int32 var_63;
        wp::float32* var_64;
        wp::float32 var_65;
        wp::float32 var_66;
        wp::int32 var_67;
        wp::int32 var_68;
        wp::float32* var_69;
        wp::float32 var_70;
        wp::float32 var_71;
        const wp::int32 var_72 = 4;
        wp::int32 var_73;
        wp::int32 var_74;
        wp::int32 var_75;
        wp::int32 var_76;
        wp::int32 var_77;
        wp::float32* var_78;
        wp::float32 var_79;
        wp::float32 var_80;
        wp::int32 var_81;
        wp::int32 var_82;
        wp::float32* var_83;
        wp::float32 var_84;
        wp::float32 var_85;
        const wp::int32 var_86 = 5;
        wp::int32 var_87;
        wp::int32 var_88;
        wp::int32 var_89;
        wp::int32 var_90;
        wp::int32 var_91;
        wp::float32* var_92;
        wp::float32 var_93;
        wp::float32 var_94;
        wp::int32 var_95;
        wp::int32 var_96;
        wp::float32* var_97;
        wp::float32 var_98;
        wp::float32 var_99;
        const wp::int32 var_100 = 6;
        wp::int32 var_101;
        wp::int32 var_102;
        wp::int32 var_103;
        wp::int32 var_104;
        wp::int32 var_105;
        wp::float32* var_106;
        wp::float32 var_107;
        wp::float32 var_108;
        wp::int32 var_109;
        wp::int32 var_110;
        wp::float32* var_111;
        wp::float32 var_112;
        wp::float32 var_113;
        const wp::int32 var_114 = 7;
        wp::int32 var_115;
        wp::int32 var_116;
        wp::int32 var_117;
        wp::int32 var_118;
        wp::int32 var_119;
        wp::float32* var_120;
        wp::float32 var_121;
        wp::float32 var_122;
        wp::int32 var_123;
        wp::int32 var_124;
        wp::float32* var_125;
        wp::float32 var_126;
        wp::float32 var_127;
        const wp::int32 var_128 = 8;
        wp::int32 var_129;
        wp::int32 var_130;
        wp::int32 var_131;
        wp::int32 var_132;
        wp::int32 var_133;
        wp::float32* var_134;
        wp::float32 var_135;
        wp::float32 var_136;
        wp::int32 var_137;
        wp::int32 var_138;
        wp::float32* var_139;
        wp::float32 var_140;
        wp::float32 var_141;
        const wp::int32 var_142 = 9;
        wp::int32 var_143;
        wp::int32 var_144;
        wp::int32 var_145;
        wp::int32 var_146;
        wp::int32 var_147;
        wp::float32* var_148;
        wp::float32 var_149;
        wp::float32 var_150;
        wp::int32 var_151;
        wp::int32 var_152;
        wp::float32* var_153;
        wp::float32 var_154;
        wp::float32 var_155;
        const wp::int32 var_156 = 10;
        wp::int32 var_157;
        wp::int32 var_158;
        wp::int32 var_159;
        wp::int32 var_160;
        wp::int32 var_161;
        wp::float32* var_162;
        wp::float32 var_163;
        wp::float32 var_164;
        wp::int32 var_165;
        wp::int32 var_166;
        wp::float32* var_167;
        wp::float32 var_168;
        wp::float32 var_169;
        const wp::int32 var_170 = 11;
        wp::int32 var_171;
        wp::int32 var_172;
        wp::int32 var_173;
        wp::int32 var_174;
        wp::int32 var_175;
        wp::float32* var_176;
        wp::float32 var_177;
        wp::float32 var_178;
        wp::int32 var_179;
        wp::int32 var_180;
        wp::float32* var_181;
        wp::float32 var_182;
        wp::float32 var_183;
        const wp::int32 var_184 = 12;
        wp::int32 var_185;
        wp::int32 var_186;
        wp::int32 var_187;
        wp::int32 var_188;
        wp::int32 var_189;
        wp::float32* var_190;
        wp::float32 var_191;
        wp::float32 var_192;
        wp::int32 var_193;
        wp::int32 var_194;
        wp::float32* var_195;
        wp::float32 var_196;
        wp::float32 var_197;
        const wp::int32 var_198 = 13;
        wp::int32 var_199;
        wp::int32 var_200;
        wp::int32 var_201;
        wp::int32 var_202;
        wp::int32 var_203;
        wp::float32* var_204;
        wp::float32 var_205;
        wp::float32 var_206;
        wp::int32 var_207;
        wp::int32 var_208;
        wp::float32* var_209;
        wp::float32 var_210;
        wp::float32 var_211;
        const wp::int32 var_212 = 14;
        wp::int32 var_213;
        wp::int32 var_214;
        wp::int32 var_215;
        wp::int32 var_216;
        wp::int32 var_217;
        wp::float32* var_218;
        wp::float32 var_219;
        wp::float32 var_220;
        wp::int32 var_221;
        wp::int32 var_222;
        wp::float32* var_223;
        wp::float32 var_224;
        wp::float32 var_225;
        const wp::int32 var_226 = 15;
        wp::int32 var_227;
        wp::int32 var_228;
        wp::int32 var_229;
        wp::int32 var_230;
        wp::int32 var_231;
        wp::float32* var_232;
        wp::float32 var_233;
        wp::float32 var_234;
        wp::int32 var_235;
        wp::int32 var_236;
        wp::float32* var_237;
        wp::float32 var_238;
        wp::float32 var_239;
        wp::float32 var_240;
        wp::float32 var_241;
        wp::int32 var_242;
        wp::int32 var_243;
        wp::int32 var_244;
        wp::int32 var_245;
        wp::int32 var_246;
        const wp::int32 var_247 = 1;
        wp::float32 var_248;
        wp::float32 var_249;
        wp::float32 var_250;
        wp::int32 var_251;
        bool var_252;
        const wp::int32 var_253 = 0;
        wp::int32 var_254;
        wp::int32 var_255;
        wp::int32 var_256;
        wp::int32 var_257;
        wp::int32 var_258;
        wp::float32* var_259;
        wp::float32 var_260;
        wp::float32 var_261;
        wp::int32 var_262;
        wp::int32 var_263;
        wp::float32* var_264;
        wp::float32 var_265;
        wp::float32 var_266;
        const wp::int32 var_267 = 1;
        wp::int32 var_268;
        wp::int32 var_269;
        wp::int32 var_270;
        wp::int32 var_271;
        wp::int32 var_272;
        wp::float32* var_273;
        wp::float32 var_274;
        wp::float32 var_275;
        wp::int32 var_276;
        wp::int32 var_277;
        wp::float32* var_278;
        wp::float32 var_279;
        wp::float32 var_280;
        const wp::int32 var_281 = 2;
        wp::int32 var_282;
        wp::int32 var_283;
        wp::int32 var_284;
        wp::int32 var_285;
        wp::int32 var_286;
        wp::float32* var_287;
        wp::float32 var_288;
        wp::float32 var_289;
        wp::int32 var_290;
        wp::int32 var_291;
        wp::float32* var_292;
        wp::float32 var_293;
        wp::float32 var_294;
        const wp::int32 var_295 = 3;
        wp::int32 var_296;
        wp::int32 var_297;
        wp::int32 var_298;
        wp::int32 var_299;
        wp::int32 var_300;
        wp::float32* var_301;
        wp::float32 var_302;
        wp::float32 var_303;
        wp::int32 var_304;
        wp::int32 var_305;
        wp::float32* var_306;
        wp::float32 var_307;
        wp::float32 var_308;
        const wp::int32 var_309 = 4;
        wp::int32 var_310;
        wp::int32 var_311;
        wp::int32 var_312;
        wp::int32 var_313;
        wp::int32 var_314;
        wp::float32* var_315;
        wp::float32 var_316;
        wp::float32 var_317;
        wp::int32 var_318;
        wp::int32 var_319;
        wp::float32* var_320;
        wp::float32 var_321;
        wp::float32 var_322;
        const wp::int32 var_323 = 5;
        wp::int32 var_324;
        wp::int32 var_325;
        wp::int32 var_326;
        wp::int32 var_327;
        wp::int32 var_328;
        wp::float32* var_329;
        wp::float32 var_330;
        wp::float32 var_331;
        wp::int32 var_332;
        wp::int32 var_333;
        wp::float32* var_334;
        wp::float32 var_335;
        wp::float32 var_336;
        const wp::int32 var_337 = 6;
        wp::int32 var_338;
        wp::int32 var_339;
        wp::int32 var_340;
        wp::int32 var_341;
        wp::int32 var_342;
        wp::float32* var_343;
        wp::float32 var_344;
        wp::float32 var_345;
        wp::int32 var_346;
        wp::int32 var_347;
        wp::float32* var_348;
        wp::float32 var_349;
        wp::float32 var_350;
        const wp::int32 var_351 = 7;
        wp::int32 var_352;
        wp::int32 var_353;
        wp::int32 var_354;
        wp::int32 var_355;
        wp::int32 var_356;
        wp::float32* var_357;
        wp::float32 var_358;
        wp::float32 var_359;
        wp::int32 var_360;
        wp::int32 var_361;
        wp::float32* var_362;
        wp::float32 var_363;
        wp::float32 var_364;
        const wp::int32 var_365 = 8;
        wp::int32 var_366;
        wp::int32 var_367;
        wp::int32 var_368;
        wp::int32 var_369;
        wp::int32 var_370;
        wp::float32* var_371;
        wp::float32 var_372;
        wp::float32 var_373;
        wp::int32 var_374;
        wp::int32 var_375;
        wp::float32* var_376;
        wp::float32 var_377;
        wp::float32 var_378;
        const wp::int32 var_379 = 9;
        wp::int32 var_380;
        wp::int32 var_381;
        wp::int32 var_382;
        wp::int32 var_383;
        wp::int32 var_384;
        wp::float32* var_385;
        wp::float32 var_386;
        wp::float32 var_387;
        wp::int32 var_388;
        wp::int32 var_389;
        wp::float32* var_390;
        wp::float32 var_391;
        wp::float32 var_392;
        const wp::int32 var_393 = 10;
        wp::int32 var_394;
        wp::int32 var_395;
        wp::int32 var_396;
        wp::int32 var_397;
        wp::int32 var_398;
        wp::float32* var_399;
        wp::float32 var_400;
        wp::float32 var_401;
        wp::int32 var_402;
        wp::int32 var_403;
        wp::float32* var_404;
        wp::float32 var_405;
        wp::float32 var_406;
        const wp::int32 var_407 = 11;
        wp::int32 var_408;
        wp::int32 var_409;
        wp::int32 var_410;
        wp::int32 var_411;
        wp::int32 var_412;
        wp::float32* var_413;
        wp::float32 var_414;
        wp::float32 var_415;
        wp::int32 var_416;
        wp::int32 var_417;
        wp::float32* var_418;
        wp::float32 var_419;
        wp::float32 var_420;
        const wp::int32 var_421 = 12;
        wp::int32 var_422;
        wp::int32 var_423;
        wp::int32 var_424;
        wp::int32 var_425;
        wp::int32 var_426;
        wp::float32* var_427;
        wp::float32 var_428;
        wp::float32 var_429;
        wp::int32 var_430;
        wp::int32 var_431;
        wp::float32* var_432;
        wp::float32 var_433;
        wp::float32 var_434;
        const wp::int32 var_435 = 13;
        wp::int32 var_436;
        wp::int32 var_437;
        wp::int32 var_438;
        wp::int32 var_439;
        wp::int32 var_440;
        wp::float32* var_441;
        wp::float32 var_442;
        wp::float32 var_443;
        wp::int32 var_444;
        wp::int32 var_445;
        wp::float32* var_446;
        wp::float32 var_447;
        wp::float32 var_448;
        const wp::int32 var_449 = 14;
        wp::int32 var_450;
        wp::int32 var_451;
        wp::int32 var_452;
        wp::int32 var_453;
        wp::int32 var_454;
        wp::float32* var_455;
        wp::float32 var_456;
        wp::float32 var_457;
        wp::int32 var_458;
        wp::int32 var_459;
        wp::float32* var_460;
        wp::float32 var_461;
        wp::float32 var_462;
        const wp::int32 var_463 = 15;
        wp::int32 var_464;
        wp::int32 var_465;
        wp::int32 var_466;
        wp::int32 var_467;
        wp::int32 var_468;
        wp::float32* var_469;
        wp::float32 var_470;
        wp::float32 var_471;
        wp::int32 var_472;
        wp::int32 var_473;
        wp::float32* var_474;
        wp::float32 var_475;
        wp::float32 var_476;
        wp::float32 var_477;
        wp::float32 var_478;
        wp::int32 var_479;
        wp::int32 var_480;
        wp::int32 var_481;
        wp::int32 var_482;
        wp::int32 var_483;
        wp::int32 var_484;
        wp::int32 var_485;
        const wp::int32 var_486 = 2;
        wp::float32 var_487;
        wp::float32 var_488;
        wp::float32 var_489;
        wp::int32 var_490;
        bool var_491;
        const wp::int32 var_492 = 0;
        wp::int32 var_493;
        wp::int32 var_494;
        wp::int32 var_495;
        wp::int32 var_496;
        wp::int32 var_497;
        wp::float32* var_498;
        wp::float32 var_499;
        wp::float32 var_500;
        wp::int32 var_501;
        wp::int32 var_502;
        wp::float32* var_503;
        wp::float32 var_504;
        wp::float32 var_505;
        const wp::int32 var_506 = 1;
        wp::int32 var_507;
        wp::int32 var_508;
        wp::int32 var_509;
        wp::int32 var_510;
        wp::int32 var_511;
        wp::float32* var_512;
        wp::float32 var_513;
        wp::float32 var_514;
        wp::int32 var_515;
        wp::int32 var_516;
        wp::float32* var_517;
        wp::float32 var_518;
        wp::float32 var_519;
        const wp::int32 var_520 = 2;
        wp::int32 var_521;
        wp::int32 var_522;
        wp::int32 var_523;
        wp::int32 var_524;
        wp::int32 var_525;
        wp::float32* var_526;
        wp::float32 var_527;
        wp::float32 var_528;
        wp::int32 var_529;
        wp::int32 var_530;
        wp::float32* var_531;
        wp::float32 var_532;
        wp::float32 var_533;
        const wp::int32 var_534 = 3;
        wp::int32 var_535;
        wp::int32 var_536;
        wp::int32 var_537;
        wp::int32 var_538;
        wp::int32 var_539;
        wp::float32* var_540;
        wp::float32 var_541;
        wp::float32 var_542;
        wp::int32 var_543;
        wp::int32 var_544;
        wp::float32* var_545;
        wp::float32 var_546;
        wp::float32 var_547;
        const wp::int32 var_548 = 4;
        wp::int32 var_549;
        wp::int32 var_550;
        wp::int32 var_551;
        wp::int32 var_552;
        wp::int32 var_553;
        wp::float32* var_554;
        wp::float32 var_555;
        wp::float32 var_556;
        wp::int32 var_557;
        wp::int32 var_558;
        wp::float32* var_559;
        wp::float32 var_560;
        wp::float32 var_561;
        const wp::int32 var_562 = 5;
        wp::int32 var_563;
        wp::int32 var_564;
        wp::int32 var_565;
        wp::int32 var_566;
        wp::int32 var_567;
        wp::float32* var_568;
        wp::float32 var_569;
        wp::float32 var_570;
        wp::int32 var_571;
        wp::int32 var_572;
        wp::float32* var_573;
        wp::float32 var_574;
        wp::float32 var_575;
        const wp::int32 var_576 = 6;
        wp::int32 var_577;
        wp::int32 var_578;
        wp::int32 var_579;
        wp::int32 var_580;
        wp::int32 var_581;
        wp::float32* var_582;
        wp::float32 var_583;
        wp::float32 var_584;
        wp::int32 var_585;
        wp::int32 var_586;
        wp::float32* var_587;
        wp::float32 var_588;
        wp::float32 var_589;
        const wp::int32 var_590 = 7;
        wp::int32 var_591;
        wp::int32 var_592;
        wp::int32 var_593;
        wp::int32 var_594;
        wp::int32 var_595;
        wp::float32* var_596;
        wp::float32 var_597;
        wp::float32 var_598;
        wp::int32 var_599;
        wp::int32 var_600;
        wp::float32* var_601;
        wp::float32 var_602;
        wp::float32 var_603;
        const wp::int32 var_604 = 8;
        wp::int32 var_605;
        wp::int32 var_606;
        wp::int32 var_607;
        wp::int32 var_608;
        wp::int32 var_609;
        wp::float32* var_610;
        wp::float32 var_611;
        wp::float32 var_612;
        wp::int32 var_613;
        wp::int32 var_614;
        wp::float32* var_615;
        wp::float32 var_616;
        wp::float32 var_617;
        const wp::int32 var_618 = 9;
        wp::int32 var_619;
        wp::int32 var_620;
        wp::int32 var_621;
        wp::int32 var_622;
        wp::int32 var_623;
        wp::float32* var_624;
        wp::float32 var_625;
        wp::float32 var_626;
        wp::int32 var_627;
        wp::int32 var_628;
        wp::float32* var_629;
        wp::float32 var_630;
        wp::float32 var_631;
        const wp::int32 var_632 = 10;
        wp::int32 var_633;
        wp::int32 var_634;
        wp::int32 var_635;
        wp::int32 var_636;
        wp::int32 var_637;
        wp::float32* var_638;
        wp::float32 var_639;
        wp::float32 var_640;
        wp::int32 var_641;
        wp::int32 var_642;
        wp::float32* var_643;
        wp::float32 var_644;
        wp::float32 var_645;
        const wp::int32 var_646 = 11;
        wp::int32 var_647;
        wp::int32 var_648;
        wp::int32 var_649;
        wp::int32 var_650;
        wp::int32 var_651;
        wp::float32* var_652;
        wp::float32 var_653;
        wp::float32 var_654;
        wp::int32 var_655;
        wp::int32 var_656;
        wp::float32* var_657;
        wp::float32 var_658;
        wp::float32 var_659;
        const wp::int32 var_660 = 12;
        wp::int32 var_661;
        wp::int32 var_662;
        wp::int32 var_663;
        wp::int32 var_664;
        wp::int32 var_665;
        wp::float32* var_666;
        wp::float32 var_667;
        wp::float32 var_668;
        wp::int32 var_669;
        wp::int32 var_670;
        wp::float32* var_671;
        wp::float32 var_672;
        wp::float32 var_673;
        const wp::int32 var_674 = 13;
        wp::int32 var_675;
        wp::int32 var_676;
        wp::int32 var_677;
        wp::int32 var_678;
        wp::int32 var_679;
        wp::float32* var_680;
        wp::float32 var_681;
        wp::float32 var_682;
        wp::int32 var_683;
        wp::int32 var_684;
        wp::float32* var_685;
        wp::float32 var_686;
        wp::float32 var_687;
        const wp::int32 var_688 = 14;
        wp::int32 var_689;
        wp::int32 var_690;
        wp::int32 var_691;
        wp::int32 var_692;
        wp::int32 var_693;
        wp::float32* var_694;
        wp::float32 var_695;
        wp::float32 var_696;
        wp::int32 var_697;
        wp::int32 var_698;
        wp::float32* var_699;
        wp::float32 var_700;
        wp::float32 var_701;
        const wp::int32 var_702 = 15;
        wp::int32 var_703;
        wp::int32 var_704;
        wp::int32 var_705;
        wp::int32 var_706;
        wp::int32 var_707;
        wp::float32* var_708;
        wp::float32 var_709;
        wp::float32 var_710;
        wp::int32 var_711;
        wp::int32 var_712;
        wp::float32* var_713;
        wp::float32 var_714;
        wp::float32 var_715;
        wp::float32 var_716;
        wp::float32 var_717;
        wp::int32 var_718;
        wp::int32 var_719;
        wp::int32 var_720;
        wp::int32 var_721;
        wp::int32 var_722;
        wp::int32 var_723;
        wp::int32 var_724;
        const wp::int32 var_725 = 3;
        wp::float32 var_726;
        wp::float32 var_727;
        wp::float32 var_728;
        wp::int32 var_729;
        bool var_730;
        const wp::int32 var_731 = 0;
        wp::int32 var_732;
        wp::int32 var_733;
        wp::int32 var_734;
        wp::int32 var_735;
        wp::int32 var_736;
        wp::float32* var_737;
        wp::float32 var_738;
        wp::float32 var_739;
        wp::int32 var_740;
        wp::int32 var_741;
        wp::float32* var_742;
        wp::float32 var_743;
        wp::float32 var_744;
        const wp::int32 var_745 = 1;
        wp::int32 var_746;
        wp::int32 var_747;
        wp::int32 var_748;
        wp::int32 var_749;
        wp::int32 var_750;
        wp::float32* var_751;
        wp::float32 var_752;
        wp::float32 var_753;
        wp::int32 var_754;
        wp::int32 var_755;
        wp::float32* var_756;
        wp::float32 var_757;
        wp::float32 var_758;
        const wp::int32 var_759 = 2;
        wp::int32 var_760;
        wp::int32 var_761;
        wp::int32 var_762;
        wp::int32 var_763;
        wp::int32 var_764;
        wp::float32* var_765;
        wp::float32 var_766;
        wp::float32 var_767;
        wp::int32 var_768;
        wp::int32 var_769;
        wp::float32* var_770;
        wp::float32 var_771;
        wp::float32 var_772;
        const wp::int32 var_773 = 3;
        wp::int32 var_774;
        wp::int32 var_775;
        wp::int32 var_776;
        wp::int32 var_777;
        wp::int32 var_778;
        wp::float32* var_779;
        wp::float32 var_780;
        wp::float32 var_781;
        wp::int32 var_782;
        wp::int32 var_783;
        wp::float32* var_784;
        wp::float32 var_785;
        wp::float32 var_786;
        const wp::int32 var_787 = 4;
        wp::int32 var_788;
        wp::int32 var_789;
        wp::int32 var_790;
        wp::int32 var_791;
        wp::int32 var_792;
        wp::float32* var_793;
        wp::float32 var_794;
        wp::float32 var_795;
        wp::int32 var_796;
        wp::int32 var_797;
        wp::float32* var_798;
        wp::float32 var_799;
        wp::float32 var_800;
        const wp::int32 var_801 = 5;
        wp::int32 var_802;
        wp::int32 var_803;
        wp::int32 var_804;
        wp::int32 var_805;
        wp::int32 var_806;
        wp::float32* var_807;
        wp::float32 var_808;
        wp::float32 var_809;
        wp::int32 var_810;
        wp::int32 var_811;
        wp::float32* var_812;
        wp::float32 var_813;
        wp::float32 var_814;
        const wp::int32 var_815 = 6;
        wp::int32 var_816;
        wp::int32 var_817;
        wp::int32 var_818;
        wp::int32 var_819;
        wp::int32 var_820;
        wp::float32* var_821;
        wp::float32 var_822;
        wp::float32 var_823;
        wp::int32 var_824;
        wp::int32 var_825;
        wp::float32* var_826;
        wp::float32 var_827;
        wp::float32 var_828;
        const wp::int32 var_829 = 7;
        wp::int32 var_830;
        wp::int32 var_831;
        wp::int32 var_832;
        wp::int32 var_833;
        wp::int32 var_834;
        wp::float32* var_835;
        wp::float32 var_836;
        wp::float32 var_837;
        wp::int32 var_838;
        wp::int32 var_839;
        wp::float32* var_840;
        wp::float32 var_841;
        wp::float32 var_842;
        const wp::int32 var_843 = 8;
        wp::int32 var_844;
        wp::int32 var_845;
        wp::int32 var_846;
        wp::int32 var_847;
        wp::int32 var_848;
        wp::float32* var_849;
        wp::float32 var_850;
        wp::float32 var_851;
        wp::int32 var_852;
        wp::int32 var_853;
        wp::float32* var_854;
        wp::float32 var_855;
        wp::float32 var_856;
        const wp::int32 var_857 = 9;
        wp::int32 var_858;
        wp::int32 var_859;
        wp::int32 var_860;
        wp::int32 var_861;
        wp::int32 var_862;
        wp::float32* var_863;
        wp::float32 var_864;
        wp::float32 var_865;
        wp::int32 var_866;
        wp::int32 var_867;
        wp::float32* var_868;
        wp::float32 var_869;
        wp::float32 var_870;
        const wp::int32 var_871 = 10;
        wp::int32 var_872;
        wp::int32 var_873;
        wp::int32 var_874;
        wp::int32 var_875;
        wp::int32 var_876;
        wp::float32* var_877;
        wp::float32 var_878;
        wp::float32 var_879;
        wp::int32 var_880;
        wp::int32 var_881;
        wp::float32* var_882;
        wp::float32 var_883;
        wp::float32 var_884;
        const wp::int32 var_885 = 11;
        wp::int32 var_886;
        wp::int32 var_887;
        wp::int32 var_888;
        wp::int32 var_889;
        wp::int32 var_890;
        wp::float32* var_891;
        wp::float32 var_892;
        wp::float32 var_893;
        wp::int32 var_894;
        wp::int32 var_895;
        wp::float32* var_896;
        wp::float32 var_897;
        wp::float32 var_898;
        const wp::int32 var_899 = 12;
        wp::int32 var_900;
        wp::int32 var_901;
        wp::int32 var_902;
        wp::int32 var_903;
        wp::int32 var_904;
        wp::float32* var_905;
        wp::float32 var_906;
        wp::float32 var_907;
        wp::int32 var_908;
        wp::int32 var_909;
        wp::float32* var_910;
        wp::float32 var_911;
        wp::float32 var_912;
        const wp::int32 var_913 = 13;
        wp::int32 var_914;
        wp::int32 var_915;
        wp::int32 var_916;
        wp::int32 var_917;
        wp::int32 var_918;
        wp::float32* var_919;
        wp::float32 var_920;
        wp::float32 var_921;
        wp::int32 var_922;
        wp::int32 var_923;
        wp::float32* var_924;
        wp::float32 var_925;
        wp::float32 var_926;
        const wp::int32 var_927 = 14;
        wp::int32 var_928;
        wp::int32 var_929;
        wp::int32 var_930;
        wp::int32 var_931;
        wp::int32 var_932;
        wp::float32* var_933;
        wp::float32 var_934;
        wp::float32 var_935;
        wp::int32 var_936;
        wp::int32 var_937;
        wp::float32* var_938;
        wp::float32 var_939;
        wp::float32 var_940;
        const wp::int32 var_941 = 15;
        wp::int32 var_942;
        wp::int32 var_943;
        wp::int32 var_944;
        wp::int32 var_945;
        wp::int32 var_946;
        wp::float32* var_947;
        wp::float32 var_948;
        wp::float32 var_949;
        wp::int32 var_950;
        wp::int32 var_951;
        wp::float32* var_952;
        wp::float32 var_953;
        wp::float32 var_954;
        wp::float32 var_955;
        wp::float32 var_956;
        wp::int32 var_957;
        wp::int32 var_958;
        wp::int32 var_959;
        wp::int32 var_960;
        wp::int32 var_961;
        wp::int32 var_962;
        wp::int32 var_963;
        const wp::int32 var_964 = 4;
        wp::float32 var_965;
        wp::float32 var_966;
        wp::float32 var_967;
        wp::int32 var_968;
        bool var_969;
        const wp::int32 var_970 = 0;
        wp::int32 var_971;
        wp::int32 var_972;
        wp::int32 var_973;
        wp::int32 var_974;
        wp::int32 var_975;
        wp::float32* var_976;
        wp::float32 var_977;
        wp::float32 var_978;
        wp::int32 var_979;
        wp::int32 var_980;
        wp::float32* var_981;
        wp::float32 var_982;
        wp::float32 var_983;
        const wp::int32 var_984 = 1;
        wp::int32 var_985;
        wp::int32 var_986;
        wp::int32 var_987;
        wp::int32 var_988;
        wp::int32 var_989;
        wp::float32* var_990;
        wp::float32 var_991;
        wp::float32 var_992;
        wp::int32 var_993;
        wp::int32 var_994;
        wp::float32* var_995;
        wp::float32 var_996;
        wp::float32 var_997;
        const wp::int32 var_998 = 2;
        wp::int32 var_999;
        wp::int32 var_1000;
        wp::int32 var_1001;
        wp::int32 var_1002;
        wp::int32 var_1003;
        wp::float32* var_1004;
        wp::float32 var_1005;
        wp::float32 var_1006;
        wp::int32 var_1007;
        wp::int32 var_1008;
        wp::float32* var_1009;
        wp::float32 var_1010;
        wp::float32 var_1011;
        const wp::int32 var_1012 = 3;
        wp::int32 var_1013;
        wp::int32 var_1014;
        wp::int32 var_1015;
        wp::int32 var_1016;
        wp::int32 var_1017;
        wp::float32* var_1018;
        wp::float32 var_1019;
        wp::float32 var_1020;
        wp::int32 var_1021;
        wp::int32 var_1022;
        wp::float32* var_1023;
        wp::float32 var_1024;
        wp::float32 var_1025;
        const wp::int32 var_1026 = 4;
        wp::int32 var_1027;
        wp::int32 var_1028;
        wp::int32 var_1029;
        wp::int32 var_1030;
        wp::int32 var_1031;
        wp::float32* var_1032;
        wp::float32 var_1033;
        wp::float32 var_1034;
        wp::int32 var_1035;
        wp::int32 var_1036;
        wp::float32* var_1037;
        wp::float32 var_1038;
        wp::float32 var_1039;
        const wp::int32 var_1040 = 5;
        wp::int32 var_1041;
        wp::int32 var_1042;
        wp::int32 var_1043;
        wp::int32 var_1044;
        wp::int32 var_1045;
        wp::float32* var_1046;
        wp::float32 var_1047;
        wp::float32 var_1048;
        wp::int32 var_1049;
        wp::int32 var_1050;
        wp::float32* var_1051;
        wp::float32 var_1052;
        wp::float32 var_1053;
        const wp::int32 var_1054 = 6;
        wp::int32 var_1055;
        wp::int32 var_1056;
        wp::int32 var_1057;
        wp::int32 var_1058;
        wp::int32 var_1059;
        wp::float32* var_1060;
        wp::float32 var_1061;
        wp::float32 var_1062;
        wp::int32 var_1063;
        wp::int32 var_1064;
        wp::float32* var_1065;
        wp::float32 var_1066;
        wp::float32 var_1067;
        const wp::int32 var_1068 = 7;
        wp::int32 var_1069;
        wp::int32 var_1070;
        wp::int32 var_1071;
        wp::int32 var_1072;
        wp::int32 var_1073;
        wp::float32* var_1074;
        wp::float32 var_1075;
        wp::float32 var_1076;
        wp::int32 var_1077;
        wp::int32 var_1078;
        wp::float32* var_1079;
        wp::float32 var_1080;
        wp::float32 var_1081;
        const wp::int32 var_1082 = 8;
        wp::int32 var_1083;
        wp::int32 var_1084;
        wp::int32 var_1085;
        wp::int32 var_1086;
        wp::int32 var_1087;
        wp::float32* var_1088;
        wp::float32 var_1089;
        wp::float32 var_1090;
        wp::int32 var_1091;
        wp::int32 var_1092;
        wp::float32* var_1093;
        wp::float32 var_1094;
        wp::float32 var_1095;
        const wp::int32 var_1096 = 9;
        wp::int32 var_1097;
        wp::int32 var_1098;
        wp::int32 var_1099;
        wp::int32 var_1100;
        wp::int32 var_1101;
        wp::float32* var_1102;
        wp::float32 var_1103;
        wp::float32 var_1104;
        wp::int32 var_1105;
        wp::int32 var_1106;
        wp::float32* var_1107;
        wp::float32 var_1108;
        wp::float32 var_1109;
        const wp::int32 var_1110 = 10;
        wp::int32 var_1111;
        wp::int32 var_1112;
        wp::int32 var_1113;
        wp::int32 var_1114;
        wp::int32 var_1115;
        wp::float32* var_1116;
        wp::float32 var_1117;
        wp::float32 var_1118;
        wp::int32 var_1119;
        wp::int32 var_1120;
        wp::float32* var_1121;
        wp::float32 var_1122;
        wp::float32 var_1123;
        const wp::int32 var_1124 = 11;
        wp::int32 var_1125;
        wp::int32 var_1126;
        wp::int32 var_1127;
        wp::int32 var_1128;
        wp::int32 var_1129;
        wp::float32* var_1130;
        wp::float32 var_1131;
        wp::float32 var_1132;
        wp::int32 var_1133;
        wp::int32 var_1134;
        wp::float32* var_1135;
        wp::float32 var_1136;
        wp::float32 var_1137;
        const wp::int32 var_1138 = 12;
        wp::int32 var_1139;
        wp::int32 var_1140;
        wp::int32 var_1141;
        wp::int32 var_1142;
        wp::int32 var_1143;
        wp::float32* var_1144;
        wp::float32 var_1145;
        wp::float32 var_1146;
        wp::int32 var_1147;
        wp::int32 var_1148;
        wp::float32* var_1149;
        wp::float32 var_1150;
        wp::float32 var_1151;
        const wp::int32 var_1152 = 13;
        wp::int32 var_1153;
        wp::int32 var_1154;
        wp::int32 var_1155;
        wp::int32 var_1156;
        wp::int32 var_1157;
        wp::float32* var_1158;
        wp::float32 var_1159;
        wp::float32 var_1160;
        wp::int32 var_1161;
        wp::int32 var_1162;
        wp::float32* var_1163;
        wp::float32 var_1164;
        wp::float32 var_1165;
        const wp::int32 var_1166 = 14;
        wp::int32 var_1167;
        wp::int32 var_1168;
        wp::int32 var_1169;
        wp::int32 var_1170;
        wp::int32 var_1171;
        wp::float32* var_1172;
        wp::float32 var_1173;
        wp::float32 var_1174;
        wp::int32 var_1175;
        wp::int32 var_1176;
        wp::float32* var_1177;
        wp::float32 var_1178;
        wp::float32 var_1179;
        const wp::int32 var_1180 = 15;
        wp::int32 var_1181;
        wp::int32 var_1182;
        wp::int32 var_1183;
        wp::int32 var_1184;
        wp::int32 var_1185;
        wp::float32* var_1186;
        wp::float32 var_1187;
        wp::float32 var_1188;
        wp::int32 var_1189;
        wp::int32 var_1190;
        wp::float32* var_1191;
        wp::float32 var_1192;
        wp::float32 var_1193;
        wp::float32 var_1194;
        wp::float32 var_1195;
        wp::int32 var_1196;
        wp::int32 var_1197;
        wp::int32 var_1198;
        wp::int32 var_1199;
        wp::int32 var_1200;
        wp::int32 var_1201;
        wp::int32 var_1202;
        const wp::int32 var_1203 = 5;
        wp::float32 var_1204;
        wp::float32 var_1205;
        wp::float32 var_1206;
        wp::int32 var_1207;
        bool var_1208;
        const wp::int32 var_1209 = 0;
        wp::int32 var_1210;
        wp::int32 var_1211;
        wp::int32 var_1212;
        wp::int32 var_1213;
        wp::int32 var_1214;
        wp::float32* var_1215;
        wp::float32 var_1216;
        wp::float32 var_1217;
        wp::int32 var_1218;
        wp::int32 var_1219;
        wp::float32* var_1220;
        wp::float32 var_1221;
        wp::float32 var_1222;
        const wp::int32 var_1223 = 1;
        wp::int32 var_1224;
        wp::int32 var_1225;
        wp::int32 var_1226;
        wp::int32 var_1227;
        wp::int32 var_1228;
        wp::float32* var_1229;
        wp::float32 var_1230;
        wp::float32 var_1231;
        wp::int32 var_1232;
        wp::int32 var_1233;
        wp::float32* var_1234;
        wp::float32 var_1235;
        wp::float32 var_1236;
        const wp::int32 var_1237 = 2;
        wp::int32 var_1238;
        wp::int32 var_1239;
        wp::int32 var_1240;
        wp::int32 var_1241;
        wp::int32 var_1242;
        wp::float32* var_1243;
        wp::float32 var_1244;
        wp::float32 var_1245;
        wp::int32 var_1246;
        wp::int32 var_1247;
        wp::float32* var_1248;
        wp::float32 var_1249;
        wp::float32 var_1250;
        const wp::int32 var_1251 = 3;
        wp::int32 var_1252;
        wp::int32 var_1253;
        wp::int32 var_1254;
        wp::int32 var_1255;
        wp::int32 var_1256;
        wp::float32* var_1257;
        wp::float32 var_1258;
        wp::float32 var_1259;
        wp::int32 var_1260;
        wp::int32 var_1261;
        wp::float32* var_1262;
        wp::float32 var_1263;
        wp::float32 var_1264;
        const wp::int32 var_1265 = 4;
        wp::int32 var_1266;
        wp::int32 var_1267;
        wp::int32 var_1268;
        wp::int32 var_1269;
        wp::int32 var_1270;
        wp::float32* var_1271;
        wp::float32 var_1272;
        wp::float32 var_1273;
        wp::int32 var_1274;
        wp::int32 var_1275;
        wp::float32* var_1276;
        wp::float32 var_1277;
        wp::float32 var_1278;
        const wp::int32 var_1279 = 5;
        wp::int32 var_1280;
        wp::int32 var_1281;
        wp::int32 var_1282;
        wp::int32 var_1283;
        wp::int32 var_1284;
        wp::float32* var_1285;
        wp::float32 var_1286;
        wp::float32 var_1287;
        wp::int32 var_1288;
        wp::int32 var_1289;
        wp::float32* var_1290;
        wp::float32 var_1291;
        wp::float32 var_1292;
        const wp::int32 var_1293 = 6;
        wp::int32 var_1294;
        wp::int32 var_1295;
        wp::int32 var_1296;
        wp::int32 var_1297;
        wp::int32 var_1298;
        wp::float32* var_1299;
        wp::float32 var_1300;
        wp::float32 var_1301;
        wp::int32 var_1302;
        wp::int32 var_1303;
        wp::float32* var_1304;
        wp::float32 var_1305;
        wp::float32 var_1306;
        const wp::int32 var_1307 = 7;
        wp::int32 var_1308;
        wp::int32 var_1309;
        wp::int32 var_1310;
        wp::int32 var_1311;
        wp::int32 var_1312;
        wp::float32* var_1313;
        wp::float32 var_1314;
        wp::float32 var_1315;
        wp::int32 var_1316;
        wp::int32 var_1317;
        wp::float32* var_1318;
        wp::float32 var_1319;
        wp::float32 var_1320;
        const wp::int32 var_1321 = 8;
        wp::int32 var_1322;
        wp::int32 var_1323;
        wp::int32 var_1324;
        wp::int32 var_1325;
        wp::int32 var_1326;
        wp::float32* var_1327;
        wp::float32 var_1328;
        wp::float32 var_1329;
        wp::int32 var_1330;
        wp::int32 var_1331;
        wp::float32* var_1332;
        wp::float32 var_1333;
        wp::float32 var_1334;
        const wp::int32 var_1335 = 9;
        wp::int32 var_1336;
        wp::int32 var_1337;
        wp::int32 var_1338;
        wp::int32 var_1339;
        wp::int32 var_1340;
        wp::float32* var_1341;
        wp::float32 var_1342;
        wp::float32 var_1343;
        wp::int32 var_1344;
        wp::int32 var_1345;
        wp::float32* var_1346;
        wp::float32 var_1347;
        wp::float32 var_1348;
        const wp::int32 var_1349 = 10;
        wp::int32 var_1350;
        wp::int32 var_1351;
        wp::int32 var_1352;
        wp::int32 var_1353;
        wp::int32 var_1354;
        wp::float32* var_1355;
        wp::float32 var_1356;
        wp::float32 var_1357;
        wp::int32 var_1358;
        wp::int32 var_1359;
        wp::float32* var_1360;
        wp::float32 var_1361;
        wp::float32 var_1362;
        const wp::int32 var_1363 = 11;
        wp::int32 var_1364;
        wp::int32 var_1365;
        wp::int32 var_1366;
        wp::int32 var_1367;
        wp::int32 var_1368;
        wp::float32* var_1369;
        wp::float32 var_1370;
        wp::float32 var_1371;
        wp::int32 var_1372;
        wp::int32 var_1373;
        wp::float32* var_1374;
        wp::float32 var_1375;
        wp::float32 var_1376;
        const wp::int32 var_1377 = 12;
        wp::int32 var_1378;
        wp::int32 var_1379;
        wp::int32 var_1380;
        wp::int32 var_1381;
        wp::int32 var_1382;
        wp::float32* var_1383;
        wp::float32 var_1384;
        wp::float32 var_1385;
        wp::int32 var_1386;
        wp::int32 var_1387;
        wp::float32* var_1388;
        wp::float32 var_1389;
        wp::float32 var_1390;
        const wp::int32 var_1391 = 13;
        wp::int32 var_1392;
        wp::int32 var_1393;
        wp::int32 var_1394;
        wp::int32 var_1395;
        wp::int32 var_1396;
        wp::float32* var_1397;
        wp::float32 var_1398;
        wp::float32 var_1399;
        wp::int32 var_1400;
        wp::int32 var_1401;
        wp::float32* var_1402;
        wp::float32 var_1403;
        wp::float32 var_1404;
        const wp::int32 var_1405 = 14;
        wp::int32 var_1406;
        wp::int32 var_1407;
        wp::int32 var_1408;
        wp::int32 var_1409;
        wp::int32 var_1410;
        wp::float32* var_1411;
        wp::float32 var_1412;
        wp::float32 var_1413;
        wp::int32 var_1414;
        wp::int32 var_1415;
        wp::float32* var_1416;
        wp::float32 var_1417;
        wp::float32 var_1418;
        const wp::int32 var_1419 = 15;
        wp::int32 var_1420;
        wp::int32 var_1421;
        wp::int32 var_1422;
        wp::int32 var_1423;
        wp::int32 var_1424;
        wp::float32* var_1425;
        wp::float32 var_1426;
        wp::float32 var_1427;
        wp::int32 var_1428;
        wp::int32 var_1429;
        wp::float32* var_1430;
        wp::float32 var_1431;
        wp::float32 var_1432;
        wp::float32 var_1433;
        wp::float32 var_1434;
        wp::int32 var_1435;
        wp::int32 var_1436;
        wp::int32 var_1437;
        wp::int32 var_1438;
        wp::int32 var_1439;
        wp::int32 var_1440;
        wp::int32 var_1441;
        //---------
        // forward
        // def bound_children_kernel(below: int, first: int, boxes: array(dtype=float32)):        <L 270>
        // i = tid()                                                                              <L 272>
        var_0 = builtin_tid1d();
        // at = (first + i // FAN) * SIDES + i % FAN                                              <L 273>
        var_2 = wp::floordiv(var_0, var_1);
        var_3 = wp::add(var_first, var_2);
        var_5 = wp::mul(var_3, var_4);
        var_6 = wp::mod(var_0, var_1);
        var_7 = wp::add(var_5, var_6);
        // for k in range(BOXED):                                                                 <L 274>
        // low = float(INFINITY)                                                                  <L 275>
        var_10 = wp::float(var_9);
        // high = -float(INFINITY)                                                                <L 276>
        var_11 = wp::float(var_9);
        var_12 = wp::neg(var_11);
        // if below + i < first:                                                                  <L 277>
        var_13 = wp::add(var_below, var_0);
        var_14 = (var_13 < var_first);
        if (var_14) {
            // for j in range(FAN):                                                               <L 278>
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_16 = wp::add(var_below, var_0);
            var_17 = wp::mul(var_16, var_4);
            var_18 = wp::mul(var_8, var_1);
            var_19 = wp::add(var_17, var_18);
            var_20 = wp::add(var_19, var_15);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_21 = wp::address(var_boxes, var_20);
            var_23 = wp::load(var_21);
            var_22 = smaller_0(var_10, var_23);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_25 = wp::mul(var_24, var_1);
            var_26 = wp::add(var_20, var_25);
            var_27 = wp::address(var_boxes, var_26);
            var_29 = wp::load(var_27);
            var_28 = larger_0(var_12, var_29);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_31 = wp::add(var_below, var_0);
            var_32 = wp::mul(var_31, var_4);
            var_33 = wp::mul(var_8, var_1);
            var_34 = wp::add(var_32, var_33);
            var_35 = wp::add(var_34, var_30);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_36 = wp::address(var_boxes, var_35);
            var_38 = wp::load(var_36);
            var_37 = smaller_0(var_22, var_38);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_39 = wp::mul(var_24, var_1);
            var_40 = wp::add(var_35, var_39);
            var_41 = wp::address(var_boxes, var_40);
            var_43 = wp::load(var_41);
            var_42 = larger_0(var_28, var_43);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_45 = wp::add(var_below, var_0);
            var_46 = wp::mul(var_45, var_4);
            var_47 = wp::mul(var_8, var_1);
            var_48 = wp::add(var_46, var_47);
            var_49 = wp::add(var_48, var_44);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_50 = wp::address(var_boxes, var_49);
            var_52 = wp::load(var_50);
            var_51 = smaller_0(var_37, var_52);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_53 = wp::mul(var_24, var_1);
            var_54 = wp::add(var_49, var_53);
            var_55 = wp::address(var_boxes, var_54);
            var_57 = wp::load(var_55);
            var_56 = larger_0(var_42, var_57);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_59 = wp::add(var_below, var_0);
            var_60 = wp::mul(var_59, var_4);
            var_61 = wp::mul(var_8, var_1);
            var_62 = wp::add(var_60, var_61);
            var_63 = wp::add(var_62, var_58);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_64 = wp::address(var_boxes, var_63);
            var_66 = wp::load(var_64);
            var_65 = smaller_0(var_51, var_66);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_67 = wp::mul(var_24, var_1);
            var_68 = wp::add(var_63, var_67);
            var_69 = wp::address(var_boxes, var_68);
            var_71 = wp::load(var_69);
            var_70 = larger_0(var_56, var_71);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_73 = wp::add(var_below, var_0);
            var_74 = wp::mul(var_73, var_4);
            var_75 = wp::mul(var_8, var_1);
            var_76 = wp::add(var_74, var_75);
            var_77 = wp::add(var_76, var_72);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_78 = wp::address(var_boxes, var_77);
            var_80 = wp::load(var_78);
            var_79 = smaller_0(var_65, var_80);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_81 = wp::mul(var_24, var_1);
            var_82 = wp::add(var_77, var_81);
            var_83 = wp::address(var_boxes, var_82);
            var_85 = wp::load(var_83);
            var_84 = larger_0(var_70, var_85);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_87 = wp::add(var_below, var_0);
            var_88 = wp::mul(var_87, var_4);
            var_89 = wp::mul(var_8, var_1);
            var_90 = wp::add(var_88, var_89);
            var_91 = wp::add(var_90, var_86);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_92 = wp::address(var_boxes, var_91);
            var_94 = wp::load(var_92);
            var_93 = smaller_0(var_79, var_94);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_95 = wp::mul(var_24, var_1);
            var_96 = wp::add(var_91, var_95);
            var_97 = wp::address(var_boxes, var_96);
            var_99 = wp::load(var_97);
            var_98 = larger_0(var_84, var_99);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_101 = wp::add(var_below, var_0);
            var_102 = wp::mul(var_101, var_4);
            var_103 = wp::mul(var_8, var_1);
            var_104 = wp::add(var_102, var_103);
            var_105 = wp::add(var_104, var_100);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_106 = wp::address(var_boxes, var_105);
            var_108 = wp::load(var_106);
            var_107 = smaller_0(var_93, var_108);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_109 = wp::mul(var_24, var_1);
            var_110 = wp::add(var_105, var_109);
            var_111 = wp::address(var_boxes, var_110);
            var_113 = wp::load(var_111);
            var_112 = larger_0(var_98, var_113);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_115 = wp::add(var_below, var_0);
            var_116 = wp::mul(var_115, var_4);
            var_117 = wp::mul(var_8, var_1);
            var_118 = wp::add(var_116, var_117);
            var_119 = wp::add(var_118, var_114);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_120 = wp::address(var_boxes, var_119);
            var_122 = wp::load(var_120);
            var_121 = smaller_0(var_107, var_122);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_123 = wp::mul(var_24, var_1);
            var_124 = wp::add(var_119, var_123);
            var_125 = wp::address(var_boxes, var_124);
            var_127 = wp::load(var_125);
            var_126 = larger_0(var_112, var_127);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_129 = wp::add(var_below, var_0);
            var_130 = wp::mul(var_129, var_4);
            var_131 = wp::mul(var_8, var_1);
            var_132 = wp::add(var_130, var_131);
            var_133 = wp::add(var_132, var_128);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_134 = wp::address(var_boxes, var_133);
            var_136 = wp::load(var_134);
            var_135 = smaller_0(var_121, var_136);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_137 = wp::mul(var_24, var_1);
            var_138 = wp::add(var_133, var_137);
            var_139 = wp::address(var_boxes, var_138);
            var_141 = wp::load(var_139);
            var_140 = larger_0(var_126, var_141);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_143 = wp::add(var_below, var_0);
            var_144 = wp::mul(var_143, var_4);
            var_145 = wp::mul(var_8, var_1);
            var_146 = wp::add(var_144, var_145);
            var_147 = wp::add(var_146, var_142);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_148 = wp::address(var_boxes, var_147);
            var_150 = wp::load(var_148);
            var_149 = smaller_0(var_135, var_150);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_151 = wp::mul(var_24, var_1);
            var_152 = wp::add(var_147, var_151);
            var_153 = wp::address(var_boxes, var_152);
            var_155 = wp::load(var_153);
            var_154 = larger_0(var_140, var_155);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_157 = wp::add(var_below, var_0);
            var_158 = wp::mul(var_157, var_4);
            var_159 = wp::mul(var_8, var_1);
            var_160 = wp::add(var_158, var_159);
            var_161 = wp::add(var_160, var_156);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_162 = wp::address(var_boxes, var_161);
            var_164 = wp::load(var_162);
            var_163 = smaller_0(var_149, var_164);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_165 = wp::mul(var_24, var_1);
            var_166 = wp::add(var_161, var_165);
            var_167 = wp::address(var_boxes, var_166);
            var_169 = wp::load(var_167);
            var_168 = larger_0(var_154, var_169);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_171 = wp::add(var_below, var_0);
            var_172 = wp::mul(var_171, var_4);
            var_173 = wp::mul(var_8, var_1);
            var_174 = wp::add(var_172, var_173);
            var_175 = wp::add(var_174, var_170);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_176 = wp::address(var_boxes, var_175);
            var_178 = wp::load(var_176);
            var_177 = smaller_0(var_163, var_178);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_179 = wp::mul(var_24, var_1);
            var_180 = wp::add(var_175, var_179);
            var_181 = wp::address(var_boxes, var_180);
            var_183 = wp::load(var_181);
            var_182 = larger_0(var_168, var_183);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_185 = wp::add(var_below, var_0);
            var_186 = wp::mul(var_185, var_4);
            var_187 = wp::mul(var_8, var_1);
            var_188 = wp::add(var_186, var_187);
            var_189 = wp::add(var_188, var_184);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_190 = wp::address(var_boxes, var_189);
            var_192 = wp::load(var_190);
            var_191 = smaller_0(var_177, var_192);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_193 = wp::mul(var_24, var_1);
            var_194 = wp::add(var_189, var_193);
            var_195 = wp::address(var_boxes, var_194);
            var_197 = wp::load(var_195);
            var_196 = larger_0(var_182, var_197);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_199 = wp::add(var_below, var_0);
            var_200 = wp::mul(var_199, var_4);
            var_201 = wp::mul(var_8, var_1);
            var_202 = wp::add(var_200, var_201);
            var_203 = wp::add(var_202, var_198);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_204 = wp::address(var_boxes, var_203);
            var_206 = wp::load(var_204);
            var_205 = smaller_0(var_191, var_206);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_207 = wp::mul(var_24, var_1);
            var_208 = wp::add(var_203, var_207);
            var_209 = wp::address(var_boxes, var_208);
            var_211 = wp::load(var_209);
            var_210 = larger_0(var_196, var_211);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_213 = wp::add(var_below, var_0);
            var_214 = wp::mul(var_213, var_4);
            var_215 = wp::mul(var_8, var_1);
            var_216 = wp::add(var_214, var_215);
            var_217 = wp::add(var_216, var_212);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_218 = wp::address(var_boxes, var_217);
            var_220 = wp::load(var_218);
            var_219 = smaller_0(var_205, var_220);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_221 = wp::mul(var_24, var_1);
            var_222 = wp::add(var_217, var_221);
            var_223 = wp::address(var_boxes, var_222);
            var_225 = wp::load(var_223);
            var_224 = larger_0(var_210, var_225);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_227 = wp::add(var_below, var_0);
            var_228 = wp::mul(var_227, var_4);
            var_229 = wp::mul(var_8, var_1);
            var_230 = wp::add(var_228, var_229);
            var_231 = wp::add(var_230, var_226);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_232 = wp::address(var_boxes, var_231);
            var_234 = wp::load(var_232);
            var_233 = smaller_0(var_219, var_234);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_235 = wp::mul(var_24, var_1);
            var_236 = wp::add(var_231, var_235);
            var_237 = wp::address(var_boxes, var_236);
            var_239 = wp::load(var_237);
            var_238 = larger_0(var_224, var_239);
        }
        var_240 = wp::where(var_14, var_233, var_10);
        var_241 = wp::where(var_14, var_238, var_12);
        // boxes[at + k * FAN] = low                                                              <L 282>
        var_242 = wp::mul(var_8, var_1);
        var_243 = wp::add(var_7, var_242);
        wp::array_store(var_boxes, var_243, var_240);
        // boxes[at + (BOXED + k) * FAN] = high                                                   <L 283>
        var_244 = wp::add(var_24, var_8);
        var_245 = wp::mul(var_244, var_1);
        var_246 = wp::add(var_7, var_245);
        wp::array_store(var_boxes, var_246, var_241);
        // low = float(INFINITY)                                                                  <L 275>
        var_248 = wp::float(var_9);
        // high = -float(INFINITY)                                                                <L 276>
        var_249 = wp::float(var_9);
        var_250 = wp::neg(var_249);
        // if below + i < first:                                                                  <L 277>
        var_251 = wp::add(var_below, var_0);
        var_252 = (var_251 < var_first);
        if (var_252) {
            // for j in range(FAN):                                                               <L 278>
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_254 = wp::add(var_below, var_0);
            var_255 = wp::mul(var_254, var_4);
            var_256 = wp::mul(var_247, var_1);
            var_257 = wp::add(var_255, var_256);
            var_258 = wp::add(var_257, var_253);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_259 = wp::address(var_boxes, var_258);
            var_261 = wp::load(var_259);
            var_260 = smaller_0(var_248, var_261);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_262 = wp::mul(var_24, var_1);
            var_263 = wp::add(var_258, var_262);
            var_264 = wp::address(var_boxes, var_263);
            var_266 = wp::load(var_264);
            var_265 = larger_0(var_250, var_266);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_268 = wp::add(var_below, var_0);
            var_269 = wp::mul(var_268, var_4);
            var_270 = wp::mul(var_247, var_1);
            var_271 = wp::add(var_269, var_270);
            var_272 = wp::add(var_271, var_267);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_273 = wp::address(var_boxes, var_272);
            var_275 = wp::load(var_273);
            var_274 = smaller_0(var_260, var_275);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_276 = wp::mul(var_24, var_1);
            var_277 = wp::add(var_272, var_276);
            var_278 = wp::address(var_boxes, var_277);
            var_280 = wp::load(var_278);
            var_279 = larger_0(var_265, var_280);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_282 = wp::add(var_below, var_0);
            var_283 = wp::mul(var_282, var_4);
            var_284 = wp::mul(var_247, var_1);
            var_285 = wp::add(var_283, var_284);
            var_286 = wp::add(var_285, var_281);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_287 = wp::address(var_boxes, var_286);
            var_289 = wp::load(var_287);
            var_288 = smaller_0(var_274, var_289);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_290 = wp::mul(var_24, var_1);
            var_291 = wp::add(var_286, var_290);
            var_292 = wp::address(var_boxes, var_291);
            var_294 = wp::load(var_292);
            var_293 = larger_0(var_279, var_294);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_296 = wp::add(var_below, var_0);
            var_297 = wp::mul(var_296, var_4);
            var_298 = wp::mul(var_247, var_1);
            var_299 = wp::add(var_297, var_298);
            var_300 = wp::add(var_299, var_295);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_301 = wp::address(var_boxes, var_300);
            var_303 = wp::load(var_301);
            var_302 = smaller_0(var_288, var_303);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_304 = wp::mul(var_24, var_1);
            var_305 = wp::add(var_300, var_304);
            var_306 = wp::address(var_boxes, var_305);
            var_308 = wp::load(var_306);
            var_307 = larger_0(var_293, var_308);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_310 = wp::add(var_below, var_0);
            var_311 = wp::mul(var_310, var_4);
            var_312 = wp::mul(var_247, var_1);
            var_313 = wp::add(var_311, var_312);
            var_314 = wp::add(var_313, var_309);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_315 = wp::address(var_boxes, var_314);
            var_317 = wp::load(var_315);
            var_316 = smaller_0(var_302, var_317);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_318 = wp::mul(var_24, var_1);
            var_319 = wp::add(var_314, var_318);
            var_320 = wp::address(var_boxes, var_319);
            var_322 = wp::load(var_320);
            var_321 = larger_0(var_307, var_322);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_324 = wp::add(var_below, var_0);
            var_325 = wp::mul(var_324, var_4);
            var_326 = wp::mul(var_247, var_1);
            var_327 = wp::add(var_325, var_326);
            var_328 = wp::add(var_327, var_323);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_329 = wp::address(var_boxes, var_328);
            var_331 = wp::load(var_329);
            var_330 = smaller_0(var_316, var_331);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_332 = wp::mul(var_24, var_1);
            var_333 = wp::add(var_328, var_332);
            var_334 = wp::address(var_boxes, var_333);
            var_336 = wp::load(var_334);
            var_335 = larger_0(var_321, var_336);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_338 = wp::add(var_below, var_0);
            var_339 = wp::mul(var_338, var_4);
            var_340 = wp::mul(var_247, var_1);
            var_341 = wp::add(var_339, var_340);
            var_342 = wp::add(var_341, var_337);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_343 = wp::address(var_boxes, var_342);
            var_345 = wp::load(var_343);
            var_344 = smaller_0(var_330, var_345);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_346 = wp::mul(var_24, var_1);
            var_347 = wp::add(var_342, var_346);
            var_348 = wp::address(var_boxes, var_347);
            var_350 = wp::load(var_348);
            var_349 = larger_0(var_335, var_350);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_352 = wp::add(var_below, var_0);
            var_353 = wp::mul(var_352, var_4);
            var_354 = wp::mul(var_247, var_1);
            var_355 = wp::add(var_353, var_354);
            var_356 = wp::add(var_355, var_351);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_357 = wp::address(var_boxes, var_356);
            var_359 = wp::load(var_357);
            var_358 = smaller_0(var_344, var_359);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_360 = wp::mul(var_24, var_1);
            var_361 = wp::add(var_356, var_360);
            var_362 = wp::address(var_boxes, var_361);
            var_364 = wp::load(var_362);
            var_363 = larger_0(var_349, var_364);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_366 = wp::add(var_below, var_0);
            var_367 = wp::mul(var_366, var_4);
            var_368 = wp::mul(var_247, var_1);
            var_369 = wp::add(var_367, var_368);
            var_370 = wp::add(var_369, var_365);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_371 = wp::address(var_boxes, var_370);
            var_373 = wp::load(var_371);
            var_372 = smaller_0(var_358, var_373);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_374 = wp::mul(var_24, var_1);
            var_375 = wp::add(var_370, var_374);
            var_376 = wp::address(var_boxes, var_375);
            var_378 = wp::load(var_376);
            var_377 = larger_0(var_363, var_378);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_380 = wp::add(var_below, var_0);
            var_381 = wp::mul(var_380, var_4);
            var_382 = wp::mul(var_247, var_1);
            var_383 = wp::add(var_381, var_382);
            var_384 = wp::add(var_383, var_379);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_385 = wp::address(var_boxes, var_384);
            var_387 = wp::load(var_385);
            var_386 = smaller_0(var_372, var_387);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_388 = wp::mul(var_24, var_1);
            var_389 = wp::add(var_384, var_388);
            var_390 = wp::address(var_boxes, var_389);
            var_392 = wp::load(var_390);
            var_391 = larger_0(var_377, var_392);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_394 = wp::add(var_below, var_0);
            var_395 = wp::mul(var_394, var_4);
            var_396 = wp::mul(var_247, var_1);
            var_397 = wp::add(var_395, var_396);
            var_398 = wp::add(var_397, var_393);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_399 = wp::address(var_boxes, var_398);
            var_401 = wp::load(var_399);
            var_400 = smaller_0(var_386, var_401);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_402 = wp::mul(var_24, var_1);
            var_403 = wp::add(var_398, var_402);
            var_404 = wp::address(var_boxes, var_403);
            var_406 = wp::load(var_404);
            var_405 = larger_0(var_391, var_406);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_408 = wp::add(var_below, var_0);
            var_409 = wp::mul(var_408, var_4);
            var_410 = wp::mul(var_247, var_1);
            var_411 = wp::add(var_409, var_410);
            var_412 = wp::add(var_411, var_407);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_413 = wp::address(var_boxes, var_412);
            var_415 = wp::load(var_413);
            var_414 = smaller_0(var_400, var_415);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_416 = wp::mul(var_24, var_1);
            var_417 = wp::add(var_412, var_416);
            var_418 = wp::address(var_boxes, var_417);
            var_420 = wp::load(var_418);
            var_419 = larger_0(var_405, var_420);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_422 = wp::add(var_below, var_0);
            var_423 = wp::mul(var_422, var_4);
            var_424 = wp::mul(var_247, var_1);
            var_425 = wp::add(var_423, var_424);
            var_426 = wp::add(var_425, var_421);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_427 = wp::address(var_boxes, var_426);
            var_429 = wp::load(var_427);
            var_428 = smaller_0(var_414, var_429);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_430 = wp::mul(var_24, var_1);
            var_431 = wp::add(var_426, var_430);
            var_432 = wp::address(var_boxes, var_431);
            var_434 = wp::load(var_432);
            var_433 = larger_0(var_419, var_434);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_436 = wp::add(var_below, var_0);
            var_437 = wp::mul(var_436, var_4);
            var_438 = wp::mul(var_247, var_1);
            var_439 = wp::add(var_437, var_438);
            var_440 = wp::add(var_439, var_435);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_441 = wp::address(var_boxes, var_440);
            var_443 = wp::load(var_441);
            var_442 = smaller_0(var_428, var_443);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_444 = wp::mul(var_24, var_1);
            var_445 = wp::add(var_440, var_444);
            var_446 = wp::address(var_boxes, var_445);
            var_448 = wp::load(var_446);
            var_447 = larger_0(var_433, var_448);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_450 = wp::add(var_below, var_0);
            var_451 = wp::mul(var_450, var_4);
            var_452 = wp::mul(var_247, var_1);
            var_453 = wp::add(var_451, var_452);
            var_454 = wp::add(var_453, var_449);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_455 = wp::address(var_boxes, var_454);
            var_457 = wp::load(var_455);
            var_456 = smaller_0(var_442, var_457);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_458 = wp::mul(var_24, var_1);
            var_459 = wp::add(var_454, var_458);
            var_460 = wp::address(var_boxes, var_459);
            var_462 = wp::load(var_460);
            var_461 = larger_0(var_447, var_462);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_464 = wp::add(var_below, var_0);
            var_465 = wp::mul(var_464, var_4);
            var_466 = wp::mul(var_247, var_1);
            var_467 = wp::add(var_465, var_466);
            var_468 = wp::add(var_467, var_463);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_469 = wp::address(var_boxes, var_468);
            var_471 = wp::load(var_469);
            var_470 = smaller_0(var_456, var_471);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_472 = wp::mul(var_24, var_1);
            var_473 = wp::add(var_468, var_472);
            var_474 = wp::address(var_boxes, var_473);
            var_476 = wp::load(var_474);
            var_475 = larger_0(var_461, var_476);
        }
        var_477 = wp::where(var_252, var_470, var_248);
        var_478 = wp::where(var_252, var_475, var_250);
        var_479 = wp::where(var_252, var_463, var_226);
        var_480 = wp::where(var_252, var_468, var_231);
        // boxes[at + k * FAN] = low                                                              <L 282>
        var_481 = wp::mul(var_247, var_1);
        var_482 = wp::add(var_7, var_481);
        wp::array_store(var_boxes, var_482, var_477);
        // boxes[at + (BOXED + k) * FAN] = high                                                   <L 283>
        var_483 = wp::add(var_24, var_247);
        var_484 = wp::mul(var_483, var_1);
        var_485 = wp::add(var_7, var_484);
        wp::array_store(var_boxes, var_485, var_478);
        // low = float(INFINITY)                                                                  <L 275>
        var_487 = wp::float(var_9);
        // high = -float(INFINITY)                                                                <L 276>
        var_488 = wp::float(var_9);
        var_489 = wp::neg(var_488);
        // if below + i < first:                                                                  <L 277>
        var_490 = wp::add(var_below, var_0);
        var_491 = (var_490 < var_first);
        if (var_491) {
            // for j in range(FAN):                                                               <L 278>
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_493 = wp::add(var_below, var_0);
            var_494 = wp::mul(var_493, var_4);
            var_495 = wp::mul(var_486, var_1);
            var_496 = wp::add(var_494, var_495);
            var_497 = wp::add(var_496, var_492);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_498 = wp::address(var_boxes, var_497);
            var_500 = wp::load(var_498);
            var_499 = smaller_0(var_487, var_500);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_501 = wp::mul(var_24, var_1);
            var_502 = wp::add(var_497, var_501);
            var_503 = wp::address(var_boxes, var_502);
            var_505 = wp::load(var_503);
            var_504 = larger_0(var_489, var_505);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_507 = wp::add(var_below, var_0);
            var_508 = wp::mul(var_507, var_4);
            var_509 = wp::mul(var_486, var_1);
            var_510 = wp::add(var_508, var_509);
            var_511 = wp::add(var_510, var_506);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_512 = wp::address(var_boxes, var_511);
            var_514 = wp::load(var_512);
            var_513 = smaller_0(var_499, var_514);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_515 = wp::mul(var_24, var_1);
            var_516 = wp::add(var_511, var_515);
            var_517 = wp::address(var_boxes, var_516);
            var_519 = wp::load(var_517);
            var_518 = larger_0(var_504, var_519);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_521 = wp::add(var_below, var_0);
            var_522 = wp::mul(var_521, var_4);
            var_523 = wp::mul(var_486, var_1);
            var_524 = wp::add(var_522, var_523);
            var_525 = wp::add(var_524, var_520);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_526 = wp::address(var_boxes, var_525);
            var_528 = wp::load(var_526);
            var_527 = smaller_0(var_513, var_528);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_529 = wp::mul(var_24, var_1);
            var_530 = wp::add(var_525, var_529);
            var_531 = wp::address(var_boxes, var_530);
            var_533 = wp::load(var_531);
            var_532 = larger_0(var_518, var_533);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_535 = wp::add(var_below, var_0);
            var_536 = wp::mul(var_535, var_4);
            var_537 = wp::mul(var_486, var_1);
            var_538 = wp::add(var_536, var_537);
            var_539 = wp::add(var_538, var_534);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_540 = wp::address(var_boxes, var_539);
            var_542 = wp::load(var_540);
            var_541 = smaller_0(var_527, var_542);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_543 = wp::mul(var_24, var_1);
            var_544 = wp::add(var_539, var_543);
            var_545 = wp::address(var_boxes, var_544);
            var_547 = wp::load(var_545);
            var_546 = larger_0(var_532, var_547);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_549 = wp::add(var_below, var_0);
            var_550 = wp::mul(var_549, var_4);
            var_551 = wp::mul(var_486, var_1);
            var_552 = wp::add(var_550, var_551);
            var_553 = wp::add(var_552, var_548);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_554 = wp::address(var_boxes, var_553);
            var_556 = wp::load(var_554);
            var_555 = smaller_0(var_541, var_556);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_557 = wp::mul(var_24, var_1);
            var_558 = wp::add(var_553, var_557);
            var_559 = wp::address(var_boxes, var_558);
            var_561 = wp::load(var_559);
            var_560 = larger_0(var_546, var_561);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_563 = wp::add(var_below, var_0);
            var_564 = wp::mul(var_563, var_4);
            var_565 = wp::mul(var_486, var_1);
            var_566 = wp::add(var_564, var_565);
            var_567 = wp::add(var_566, var_562);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_568 = wp::address(var_boxes, var_567);
            var_570 = wp::load(var_568);
            var_569 = smaller_0(var_555, var_570);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_571 = wp::mul(var_24, var_1);
            var_572 = wp::add(var_567, var_571);
            var_573 = wp::address(var_boxes, var_572);
            var_575 = wp::load(var_573);
            var_574 = larger_0(var_560, var_575);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_577 = wp::add(var_below, var_0);
            var_578 = wp::mul(var_577, var_4);
            var_579 = wp::mul(var_486, var_1);
            var_580 = wp::add(var_578, var_579);
            var_581 = wp::add(var_580, var_576);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_582 = wp::address(var_boxes, var_581);
            var_584 = wp::load(var_582);
            var_583 = smaller_0(var_569, var_584);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_585 = wp::mul(var_24, var_1);
            var_586 = wp::add(var_581, var_585);
            var_587 = wp::address(var_boxes, var_586);
            var_589 = wp::load(var_587);
            var_588 = larger_0(var_574, var_589);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_591 = wp::add(var_below, var_0);
            var_592 = wp::mul(var_591, var_4);
            var_593 = wp::mul(var_486, var_1);
            var_594 = wp::add(var_592, var_593);
            var_595 = wp::add(var_594, var_590);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_596 = wp::address(var_boxes, var_595);
            var_598 = wp::load(var_596);
            var_597 = smaller_0(var_583, var_598);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_599 = wp::mul(var_24, var_1);
            var_600 = wp::add(var_595, var_599);
            var_601 = wp::address(var_boxes, var_600);
            var_603 = wp::load(var_601);
            var_602 = larger_0(var_588, var_603);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_605 = wp::add(var_below, var_0);
            var_606 = wp::mul(var_605, var_4);
            var_607 = wp::mul(var_486, var_1);
            var_608 = wp::add(var_606, var_607);
            var_609 = wp::add(var_608, var_604);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_610 = wp::address(var_boxes, var_609);
            var_612 = wp::load(var_610);
            var_611 = smaller_0(var_597, var_612);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_613 = wp::mul(var_24, var_1);
            var_614 = wp::add(var_609, var_613);
            var_615 = wp::address(var_boxes, var_614);
            var_617 = wp::load(var_615);
            var_616 = larger_0(var_602, var_617);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_619 = wp::add(var_below, var_0);
            var_620 = wp::mul(var_619, var_4);
            var_621 = wp::mul(var_486, var_1);
            var_622 = wp::add(var_620, var_621);
            var_623 = wp::add(var_622, var_618);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_624 = wp::address(var_boxes, var_623);
            var_626 = wp::load(var_624);
            var_625 = smaller_0(var_611, var_626);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_627 = wp::mul(var_24, var_1);
            var_628 = wp::add(var_623, var_627);
            var_629 = wp::address(var_boxes, var_628);
            var_631 = wp::load(var_629);
            var_630 = larger_0(var_616, var_631);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_633 = wp::add(var_below, var_0);
            var_634 = wp::mul(var_633, var_4);
            var_635 = wp::mul(var_486, var_1);
            var_636 = wp::add(var_634, var_635);
            var_637 = wp::add(var_636, var_632);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_638 = wp::address(var_boxes, var_637);
            var_640 = wp::load(var_638);
            var_639 = smaller_0(var_625, var_640);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_641 = wp::mul(var_24, var_1);
            var_642 = wp::add(var_637, var_641);
            var_643 = wp::address(var_boxes, var_642);
            var_645 = wp::load(var_643);
            var_644 = larger_0(var_630, var_645);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_647 = wp::add(var_below, var_0);
            var_648 = wp::mul(var_647, var_4);
            var_649 = wp::mul(var_486, var_1);
            var_650 = wp::add(var_648, var_649);
            var_651 = wp::add(var_650, var_646);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_652 = wp::address(var_boxes, var_651);
            var_654 = wp::load(var_652);
            var_653 = smaller_0(var_639, var_654);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_655 = wp::mul(var_24, var_1);
            var_656 = wp::add(var_651, var_655);
            var_657 = wp::address(var_boxes, var_656);
            var_659 = wp::load(var_657);
            var_658 = larger_0(var_644, var_659);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_661 = wp::add(var_below, var_0);
            var_662 = wp::mul(var_661, var_4);
            var_663 = wp::mul(var_486, var_1);
            var_664 = wp::add(var_662, var_663);
            var_665 = wp::add(var_664, var_660);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_666 = wp::address(var_boxes, var_665);
            var_668 = wp::load(var_666);
            var_667 = smaller_0(var_653, var_668);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_669 = wp::mul(var_24, var_1);
            var_670 = wp::add(var_665, var_669);
            var_671 = wp::address(var_boxes, var_670);
            var_673 = wp::load(var_671);
            var_672 = larger_0(var_658, var_673);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_675 = wp::add(var_below, var_0);
            var_676 = wp::mul(var_675, var_4);
            var_677 = wp::mul(var_486, var_1);
            var_678 = wp::add(var_676, var_677);
            var_679 = wp::add(var_678, var_674);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_680 = wp::address(var_boxes, var_679);
            var_682 = wp::load(var_680);
            var_681 = smaller_0(var_667, var_682);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_683 = wp::mul(var_24, var_1);
            var_684 = wp::add(var_679, var_683);
            var_685 = wp::address(var_boxes, var_684);
            var_687 = wp::load(var_685);
            var_686 = larger_0(var_672, var_687);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_689 = wp::add(var_below, var_0);
            var_690 = wp::mul(var_689, var_4);
            var_691 = wp::mul(var_486, var_1);
            var_692 = wp::add(var_690, var_691);
            var_693 = wp::add(var_692, var_688);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_694 = wp::address(var_boxes, var_693);
            var_696 = wp::load(var_694);
            var_695 = smaller_0(var_681, var_696);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_697 = wp::mul(var_24, var_1);
            var_698 = wp::add(var_693, var_697);
            var_699 = wp::address(var_boxes, var_698);
            var_701 = wp::load(var_699);
            var_700 = larger_0(var_686, var_701);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_703 = wp::add(var_below, var_0);
            var_704 = wp::mul(var_703, var_4);
            var_705 = wp::mul(var_486, var_1);
            var_706 = wp::add(var_704, var_705);
            var_707 = wp::add(var_706, var_702);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_708 = wp::address(var_boxes, var_707);
            var_710 = wp::load(var_708);
            var_709 = smaller_0(var_695, var_710);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_711 = wp::mul(var_24, var_1);
            var_712 = wp::add(var_707, var_711);
            var_713 = wp::address(var_boxes, var_712);
            var_715 = wp::load(var_713);
            var_714 = larger_0(var_700, var_715);
        }
        var_716 = wp::where(var_491, var_709, var_487);
        var_717 = wp::where(var_491, var_714, var_489);
        var_718 = wp::where(var_491, var_702, var_479);
        var_719 = wp::where(var_491, var_707, var_480);
        // boxes[at + k * FAN] = low                                                              <L 282>
        var_720 = wp::mul(var_486, var_1);
        var_721 = wp::add(var_7, var_720);
        wp::array_store(var_boxes, var_721, var_716);
        // boxes[at + (BOXED + k) * FAN] = high                                                   <L 283>
        var_722 = wp::add(var_24, var_486);
        var_723 = wp::mul(var_722, var_1);
        var_724 = wp::add(var_7, var_723);
        wp::array_store(var_boxes, var_724, var_717);
        // low = float(INFINITY)                                                                  <L 275>
        var_726 = wp::float(var_9);
        // high = -float(INFINITY)                                                                <L 276>
        var_727 = wp::float(var_9);
        var_728 = wp::neg(var_727);
        // if below + i < first:                                                                  <L 277>
        var_729 = wp::add(var_below, var_0);
        var_730 = (var_729 < var_first);
        if (var_730) {
            // for j in range(FAN):                                                               <L 278>
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_732 = wp::add(var_below, var_0);
            var_733 = wp::mul(var_732, var_4);
            var_734 = wp::mul(var_725, var_1);
            var_735 = wp::add(var_733, var_734);
            var_736 = wp::add(var_735, var_731);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_737 = wp::address(var_boxes, var_736);
            var_739 = wp::load(var_737);
            var_738 = smaller_0(var_726, var_739);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_740 = wp::mul(var_24, var_1);
            var_741 = wp::add(var_736, var_740);
            var_742 = wp::address(var_boxes, var_741);
            var_744 = wp::load(var_742);
            var_743 = larger_0(var_728, var_744);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_746 = wp::add(var_below, var_0);
            var_747 = wp::mul(var_746, var_4);
            var_748 = wp::mul(var_725, var_1);
            var_749 = wp::add(var_747, var_748);
            var_750 = wp::add(var_749, var_745);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_751 = wp::address(var_boxes, var_750);
            var_753 = wp::load(var_751);
            var_752 = smaller_0(var_738, var_753);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_754 = wp::mul(var_24, var_1);
            var_755 = wp::add(var_750, var_754);
            var_756 = wp::address(var_boxes, var_755);
            var_758 = wp::load(var_756);
            var_757 = larger_0(var_743, var_758);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_760 = wp::add(var_below, var_0);
            var_761 = wp::mul(var_760, var_4);
            var_762 = wp::mul(var_725, var_1);
            var_763 = wp::add(var_761, var_762);
            var_764 = wp::add(var_763, var_759);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_765 = wp::address(var_boxes, var_764);
            var_767 = wp::load(var_765);
            var_766 = smaller_0(var_752, var_767);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_768 = wp::mul(var_24, var_1);
            var_769 = wp::add(var_764, var_768);
            var_770 = wp::address(var_boxes, var_769);
            var_772 = wp::load(var_770);
            var_771 = larger_0(var_757, var_772);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_774 = wp::add(var_below, var_0);
            var_775 = wp::mul(var_774, var_4);
            var_776 = wp::mul(var_725, var_1);
            var_777 = wp::add(var_775, var_776);
            var_778 = wp::add(var_777, var_773);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_779 = wp::address(var_boxes, var_778);
            var_781 = wp::load(var_779);
            var_780 = smaller_0(var_766, var_781);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_782 = wp::mul(var_24, var_1);
            var_783 = wp::add(var_778, var_782);
            var_784 = wp::address(var_boxes, var_783);
            var_786 = wp::load(var_784);
            var_785 = larger_0(var_771, var_786);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_788 = wp::add(var_below, var_0);
            var_789 = wp::mul(var_788, var_4);
            var_790 = wp::mul(var_725, var_1);
            var_791 = wp::add(var_789, var_790);
            var_792 = wp::add(var_791, var_787);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_793 = wp::address(var_boxes, var_792);
            var_795 = wp::load(var_793);
            var_794 = smaller_0(var_780, var_795);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_796 = wp::mul(var_24, var_1);
            var_797 = wp::add(var_792, var_796);
            var_798 = wp::address(var_boxes, var_797);
            var_800 = wp::load(var_798);
            var_799 = larger_0(var_785, var_800);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_802 = wp::add(var_below, var_0);
            var_803 = wp::mul(var_802, var_4);
            var_804 = wp::mul(var_725, var_1);
            var_805 = wp::add(var_803, var_804);
            var_806 = wp::add(var_805, var_801);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_807 = wp::address(var_boxes, var_806);
            var_809 = wp::load(var_807);
            var_808 = smaller_0(var_794, var_809);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_810 = wp::mul(var_24, var_1);
            var_811 = wp::add(var_806, var_810);
            var_812 = wp::address(var_boxes, var_811);
            var_814 = wp::load(var_812);
            var_813 = larger_0(var_799, var_814);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_816 = wp::add(var_below, var_0);
            var_817 = wp::mul(var_816, var_4);
            var_818 = wp::mul(var_725, var_1);
            var_819 = wp::add(var_817, var_818);
            var_820 = wp::add(var_819, var_815);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_821 = wp::address(var_boxes, var_820);
            var_823 = wp::load(var_821);
            var_822 = smaller_0(var_808, var_823);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_824 = wp::mul(var_24, var_1);
            var_825 = wp::add(var_820, var_824);
            var_826 = wp::address(var_boxes, var_825);
            var_828 = wp::load(var_826);
            var_827 = larger_0(var_813, var_828);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_830 = wp::add(var_below, var_0);
            var_831 = wp::mul(var_830, var_4);
            var_832 = wp::mul(var_725, var_1);
            var_833 = wp::add(var_831, var_832);
            var_834 = wp::add(var_833, var_829);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_835 = wp::address(var_boxes, var_834);
            var_837 = wp::load(var_835);
            var_836 = smaller_0(var_822, var_837);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_838 = wp::mul(var_24, var_1);
            var_839 = wp::add(var_834, var_838);
            var_840 = wp::address(var_boxes, var_839);
            var_842 = wp::load(var_840);
            var_841 = larger_0(var_827, var_842);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_844 = wp::add(var_below, var_0);
            var_845 = wp::mul(var_844, var_4);
            var_846 = wp::mul(var_725, var_1);
            var_847 = wp::add(var_845, var_846);
            var_848 = wp::add(var_847, var_843);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_849 = wp::address(var_boxes, var_848);
            var_851 = wp::load(var_849);
            var_850 = smaller_0(var_836, var_851);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_852 = wp::mul(var_24, var_1);
            var_853 = wp::add(var_848, var_852);
            var_854 = wp::address(var_boxes, var_853);
            var_856 = wp::load(var_854);
            var_855 = larger_0(var_841, var_856);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_858 = wp::add(var_below, var_0);
            var_859 = wp::mul(var_858, var_4);
            var_860 = wp::mul(var_725, var_1);
            var_861 = wp::add(var_859, var_860);
            var_862 = wp::add(var_861, var_857);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_863 = wp::address(var_boxes, var_862);
            var_865 = wp::load(var_863);
            var_864 = smaller_0(var_850, var_865);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_866 = wp::mul(var_24, var_1);
            var_867 = wp::add(var_862, var_866);
            var_868 = wp::address(var_boxes, var_867);
            var_870 = wp::load(var_868);
            var_869 = larger_0(var_855, var_870);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_872 = wp::add(var_below, var_0);
            var_873 = wp::mul(var_872, var_4);
            var_874 = wp::mul(var_725, var_1);
            var_875 = wp::add(var_873, var_874);
            var_876 = wp::add(var_875, var_871);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_877 = wp::address(var_boxes, var_876);
            var_879 = wp::load(var_877);
            var_878 = smaller_0(var_864, var_879);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_880 = wp::mul(var_24, var_1);
            var_881 = wp::add(var_876, var_880);
            var_882 = wp::address(var_boxes, var_881);
            var_884 = wp::load(var_882);
            var_883 = larger_0(var_869, var_884);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_886 = wp::add(var_below, var_0);
            var_887 = wp::mul(var_886, var_4);
            var_888 = wp::mul(var_725, var_1);
            var_889 = wp::add(var_887, var_888);
            var_890 = wp::add(var_889, var_885);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_891 = wp::address(var_boxes, var_890);
            var_893 = wp::load(var_891);
            var_892 = smaller_0(var_878, var_893);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_894 = wp::mul(var_24, var_1);
            var_895 = wp::add(var_890, var_894);
            var_896 = wp::address(var_boxes, var_895);
            var_898 = wp::load(var_896);
            var_897 = larger_0(var_883, var_898);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_900 = wp::add(var_below, var_0);
            var_901 = wp::mul(var_900, var_4);
            var_902 = wp::mul(var_725, var_1);
            var_903 = wp::add(var_901, var_902);
            var_904 = wp::add(var_903, var_899);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_905 = wp::address(var_boxes, var_904);
            var_907 = wp::load(var_905);
            var_906 = smaller_0(var_892, var_907);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_908 = wp::mul(var_24, var_1);
            var_909 = wp::add(var_904, var_908);
            var_910 = wp::address(var_boxes, var_909);
            var_912 = wp::load(var_910);
            var_911 = larger_0(var_897, var_912);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_914 = wp::add(var_below, var_0);
            var_915 = wp::mul(var_914, var_4);
            var_916 = wp::mul(var_725, var_1);
            var_917 = wp::add(var_915, var_916);
            var_918 = wp::add(var_917, var_913);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_919 = wp::address(var_boxes, var_918);
            var_921 = wp::load(var_919);
            var_920 = smaller_0(var_906, var_921);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_922 = wp::mul(var_24, var_1);
            var_923 = wp::add(var_918, var_922);
            var_924 = wp::address(var_boxes, var_923);
            var_926 = wp::load(var_924);
            var_925 = larger_0(var_911, var_926);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_928 = wp::add(var_below, var_0);
            var_929 = wp::mul(var_928, var_4);
            var_930 = wp::mul(var_725, var_1);
            var_931 = wp::add(var_929, var_930);
            var_932 = wp::add(var_931, var_927);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_933 = wp::address(var_boxes, var_932);
            var_935 = wp::load(var_933);
            var_934 = smaller_0(var_920, var_935);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_936 = wp::mul(var_24, var_1);
            var_937 = wp::add(var_932, var_936);
            var_938 = wp::address(var_boxes, var_937);
            var_940 = wp::load(var_938);
            var_939 = larger_0(var_925, var_940);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_942 = wp::add(var_below, var_0);
            var_943 = wp::mul(var_942, var_4);
            var_944 = wp::mul(var_725, var_1);
            var_945 = wp::add(var_943, var_944);
            var_946 = wp::add(var_945, var_941);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_947 = wp::address(var_boxes, var_946);
            var_949 = wp::load(var_947);
            var_948 = smaller_0(var_934, var_949);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_950 = wp::mul(var_24, var_1);
            var_951 = wp::add(var_946, var_950);
            var_952 = wp::address(var_boxes, var_951);
            var_954 = wp::load(var_952);
            var_953 = larger_0(var_939, var_954);
        }
        var_955 = wp::where(var_730, var_948, var_726);
        var_956 = wp::where(var_730, var_953, var_728);
        var_957 = wp::where(var_730, var_941, var_718);
        var_958 = wp::where(var_730, var_946, var_719);
        // boxes[at + k * FAN] = low                                                              <L 282>
        var_959 = wp::mul(var_725, var_1);
        var_960 = wp::add(var_7, var_959);
        wp::array_store(var_boxes, var_960, var_955);
        // boxes[at + (BOXED + k) * FAN] = high                                                   <L 283>
        var_961 = wp::add(var_24, var_725);
        var_962 = wp::mul(var_961, var_1);
        var_963 = wp::add(var_7, var_962);
        wp::array_store(var_boxes, var_963, var_956);
        // low = float(INFINITY)                                                                  <L 275>
        var_965 = wp::float(var_9);
        // high = -float(INFINITY)                                                                <L 276>
        var_966 = wp::float(var_9);
        var_967 = wp::neg(var_966);
        // if below + i < first:                                                                  <L 277>
        var_968 = wp::add(var_below, var_0);
        var_969 = (var_968 < var_first);
        if (var_969) {
            // for j in range(FAN):                                                               <L 278>
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_971 = wp::add(var_below, var_0);
            var_972 = wp::mul(var_971, var_4);
            var_973 = wp::mul(var_964, var_1);
            var_974 = wp::add(var_972, var_973);
            var_975 = wp::add(var_974, var_970);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_976 = wp::address(var_boxes, var_975);
            var_978 = wp::load(var_976);
            var_977 = smaller_0(var_965, var_978);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_979 = wp::mul(var_24, var_1);
            var_980 = wp::add(var_975, var_979);
            var_981 = wp::address(var_boxes, var_980);
            var_983 = wp::load(var_981);
            var_982 = larger_0(var_967, var_983);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_985 = wp::add(var_below, var_0);
            var_986 = wp::mul(var_985, var_4);
            var_987 = wp::mul(var_964, var_1);
            var_988 = wp::add(var_986, var_987);
            var_989 = wp::add(var_988, var_984);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_990 = wp::address(var_boxes, var_989);
            var_992 = wp::load(var_990);
            var_991 = smaller_0(var_977, var_992);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_993 = wp::mul(var_24, var_1);
            var_994 = wp::add(var_989, var_993);
            var_995 = wp::address(var_boxes, var_994);
            var_997 = wp::load(var_995);
            var_996 = larger_0(var_982, var_997);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_999 = wp::add(var_below, var_0);
            var_1000 = wp::mul(var_999, var_4);
            var_1001 = wp::mul(var_964, var_1);
            var_1002 = wp::add(var_1000, var_1001);
            var_1003 = wp::add(var_1002, var_998);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_1004 = wp::address(var_boxes, var_1003);
            var_1006 = wp::load(var_1004);
            var_1005 = smaller_0(var_991, var_1006);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_1007 = wp::mul(var_24, var_1);
            var_1008 = wp::add(var_1003, var_1007);
            var_1009 = wp::address(var_boxes, var_1008);
            var_1011 = wp::load(var_1009);
            var_1010 = larger_0(var_996, var_1011);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_1013 = wp::add(var_below, var_0);
            var_1014 = wp::mul(var_1013, var_4);
            var_1015 = wp::mul(var_964, var_1);
            var_1016 = wp::add(var_1014, var_1015);
            var_1017 = wp::add(var_1016, var_1012);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_1018 = wp::address(var_boxes, var_1017);
            var_1020 = wp::load(var_1018);
            var_1019 = smaller_0(var_1005, var_1020);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_1021 = wp::mul(var_24, var_1);
            var_1022 = wp::add(var_1017, var_1021);
            var_1023 = wp::address(var_boxes, var_1022);
            var_1025 = wp::load(var_1023);
            var_1024 = larger_0(var_1010, var_1025);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_1027 = wp::add(var_below, var_0);
            var_1028 = wp::mul(var_1027, var_4);
            var_1029 = wp::mul(var_964, var_1);
            var_1030 = wp::add(var_1028, var_1029);
            var_1031 = wp::add(var_1030, var_1026);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_1032 = wp::address(var_boxes, var_1031);
            var_1034 = wp::load(var_1032);
            var_1033 = smaller_0(var_1019, var_1034);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_1035 = wp::mul(var_24, var_1);
            var_1036 = wp::add(var_1031, var_1035);
            var_1037 = wp::address(var_boxes, var_1036);
            var_1039 = wp::load(var_1037);
            var_1038 = larger_0(var_1024, var_1039);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_1041 = wp::add(var_below, var_0);
            var_1042 = wp::mul(var_1041, var_4);
            var_1043 = wp::mul(var_964, var_1);
            var_1044 = wp::add(var_1042, var_1043);
            var_1045 = wp::add(var_1044, var_1040);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_1046 = wp::address(var_boxes, var_1045);
            var_1048 = wp::load(var_1046);
            var_1047 = smaller_0(var_1033, var_1048);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_1049 = wp::mul(var_24, var_1);
            var_1050 = wp::add(var_1045, var_1049);
            var_1051 = wp::address(var_boxes, var_1050);
            var_1053 = wp::load(var_1051);
            var_1052 = larger_0(var_1038, var_1053);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_1055 = wp::add(var_below, var_0);
            var_1056 = wp::mul(var_1055, var_4);
            var_1057 = wp::mul(var_964, var_1);
            var_1058 = wp::add(var_1056, var_1057);
            var_1059 = wp::add(var_1058, var_1054);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_1060 = wp::address(var_boxes, var_1059);
            var_1062 = wp::load(var_1060);
            var_1061 = smaller_0(var_1047, var_1062);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_1063 = wp::mul(var_24, var_1);
            var_1064 = wp::add(var_1059, var_1063);
            var_1065 = wp::address(var_boxes, var_1064);
            var_1067 = wp::load(var_1065);
            var_1066 = larger_0(var_1052, var_1067);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_1069 = wp::add(var_below, var_0);
            var_1070 = wp::mul(var_1069, var_4);
            var_1071 = wp::mul(var_964, var_1);
            var_1072 = wp::add(var_1070, var_1071);
            var_1073 = wp::add(var_1072, var_1068);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_1074 = wp::address(var_boxes, var_1073);
            var_1076 = wp::load(var_1074);
            var_1075 = smaller_0(var_1061, var_1076);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_1077 = wp::mul(var_24, var_1);
            var_1078 = wp::add(var_1073, var_1077);
            var_1079 = wp::address(var_boxes, var_1078);
            var_1081 = wp::load(var_1079);
            var_1080 = larger_0(var_1066, var_1081);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_1083 = wp::add(var_below, var_0);
            var_1084 = wp::mul(var_1083, var_4);
            var_1085 = wp::mul(var_964, var_1);
            var_1086 = wp::add(var_1084, var_1085);
            var_1087 = wp::add(var_1086, var_1082);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_1088 = wp::address(var_boxes, var_1087);
            var_1090 = wp::load(var_1088);
            var_1089 = smaller_0(var_1075, var_1090);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_1091 = wp::mul(var_24, var_1);
            var_1092 = wp::add(var_1087, var_1091);
            var_1093 = wp::address(var_boxes, var_1092);
            var_1095 = wp::load(var_1093);
            var_1094 = larger_0(var_1080, var_1095);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_1097 = wp::add(var_below, var_0);
            var_1098 = wp::mul(var_1097, var_4);
            var_1099 = wp::mul(var_964, var_1);
            var_1100 = wp::add(var_1098, var_1099);
            var_1101 = wp::add(var_1100, var_1096);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_1102 = wp::address(var_boxes, var_1101);
            var_1104 = wp::load(var_1102);
            var_1103 = smaller_0(var_1089, var_1104);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_1105 = wp::mul(var_24, var_1);
            var_1106 = wp::add(var_1101, var_1105);
            var_1107 = wp::address(var_boxes, var_1106);
            var_1109 = wp::load(var_1107);
            var_1108 = larger_0(var_1094, var_1109);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_1111 = wp::add(var_below, var_0);
            var_1112 = wp::mul(var_1111, var_4);
            var_1113 = wp::mul(var_964, var_1);
            var_1114 = wp::add(var_1112, var_1113);
            var_1115 = wp::add(var_1114, var_1110);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_1116 = wp::address(var_boxes, var_1115);
            var_1118 = wp::load(var_1116);
            var_1117 = smaller_0(var_1103, var_1118);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_1119 = wp::mul(var_24, var_1);
            var_1120 = wp::add(var_1115, var_1119);
            var_1121 = wp::address(var_boxes, var_1120);
            var_1123 = wp::load(var_1121);
            var_1122 = larger_0(var_1108, var_1123);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_1125 = wp::add(var_below, var_0);
            var_1126 = wp::mul(var_1125, var_4);
            var_1127 = wp::mul(var_964, var_1);
            var_1128 = wp::add(var_1126, var_1127);
            var_1129 = wp::add(var_1128, var_1124);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_1130 = wp::address(var_boxes, var_1129);
            var_1132 = wp::load(var_1130);
            var_1131 = smaller_0(var_1117, var_1132);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_1133 = wp::mul(var_24, var_1);
            var_1134 = wp::add(var_1129, var_1133);
            var_1135 = wp::address(var_boxes, var_1134);
            var_1137 = wp::load(var_1135);
            var_1136 = larger_0(var_1122, var_1137);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_1139 = wp::add(var_below, var_0);
            var_1140 = wp::mul(var_1139, var_4);
            var_1141 = wp::mul(var_964, var_1);
            var_1142 = wp::add(var_1140, var_1141);
            var_1143 = wp::add(var_1142, var_1138);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_1144 = wp::address(var_boxes, var_1143);
            var_1146 = wp::load(var_1144);
            var_1145 = smaller_0(var_1131, var_1146);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_1147 = wp::mul(var_24, var_1);
            var_1148 = wp::add(var_1143, var_1147);
            var_1149 = wp::address(var_boxes, var_1148);
            var_1151 = wp::load(var_1149);
            var_1150 = larger_0(var_1136, var_1151);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_1153 = wp::add(var_below, var_0);
            var_1154 = wp::mul(var_1153, var_4);
            var_1155 = wp::mul(var_964, var_1);
            var_1156 = wp::add(var_1154, var_1155);
            var_1157 = wp::add(var_1156, var_1152);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_1158 = wp::address(var_boxes, var_1157);
            var_1160 = wp::load(var_1158);
            var_1159 = smaller_0(var_1145, var_1160);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_1161 = wp::mul(var_24, var_1);
            var_1162 = wp::add(var_1157, var_1161);
            var_1163 = wp::address(var_boxes, var_1162);
            var_1165 = wp::load(var_1163);
            var_1164 = larger_0(var_1150, var_1165);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_1167 = wp::add(var_below, var_0);
            var_1168 = wp::mul(var_1167, var_4);
            var_1169 = wp::mul(var_964, var_1);
            var_1170 = wp::add(var_1168, var_1169);
            var_1171 = wp::add(var_1170, var_1166);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_1172 = wp::address(var_boxes, var_1171);
            var_1174 = wp::load(var_1172);
            var_1173 = smaller_0(var_1159, var_1174);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_1175 = wp::mul(var_24, var_1);
            var_1176 = wp::add(var_1171, var_1175);
            var_1177 = wp::address(var_boxes, var_1176);
            var_1179 = wp::load(var_1177);
            var_1178 = larger_0(var_1164, var_1179);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_1181 = wp::add(var_below, var_0);
            var_1182 = wp::mul(var_1181, var_4);
            var_1183 = wp::mul(var_964, var_1);
            var_1184 = wp::add(var_1182, var_1183);
            var_1185 = wp::add(var_1184, var_1180);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_1186 = wp::address(var_boxes, var_1185);
            var_1188 = wp::load(var_1186);
            var_1187 = smaller_0(var_1173, var_1188);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_1189 = wp::mul(var_24, var_1);
            var_1190 = wp::add(var_1185, var_1189);
            var_1191 = wp::address(var_boxes, var_1190);
            var_1193 = wp::load(var_1191);
            var_1192 = larger_0(var_1178, var_1193);
        }
        var_1194 = wp::where(var_969, var_1187, var_965);
        var_1195 = wp::where(var_969, var_1192, var_967);
        var_1196 = wp::where(var_969, var_1180, var_957);
        var_1197 = wp::where(var_969, var_1185, var_958);
        // boxes[at + k * FAN] = low                                                              <L 282>
        var_1198 = wp::mul(var_964, var_1);
        var_1199 = wp::add(var_7, var_1198);
        wp::array_store(var_boxes, var_1199, var_1194);
        // boxes[at + (BOXED + k) * FAN] = high                                                   <L 283>
        var_1200 = wp::add(var_24, var_964);
        var_1201 = wp::mul(var_1200, var_1);
        var_1202 = wp::add(var_7, var_1201);
        wp::array_store(var_boxes, var_1202, var_1195);
        // low = float(INFINITY)                                                                  <L 275>
        var_1204 = wp::float(var_9);
        // high = -float(INFINITY)                                                                <L 276>
        var_1205 = wp::float(var_9);
        var_1206 = wp::neg(var_1205);
        // if below + i < first:                                                                  <L 277>
        var_1207 = wp::add(var_below, var_0);
        var_1208 = (var_1207 < var_first);
        if (var_1208) {
            // for j in range(FAN):                                                               <L 278>
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_1210 = wp::add(var_below, var_0);
            var_1211 = wp::mul(var_1210, var_4);
            var_1212 = wp::mul(var_1203, var_1);
            var_1213 = wp::add(var_1211, var_1212);
            var_1214 = wp::add(var_1213, var_1209);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_1215 = wp::address(var_boxes, var_1214);
            var_1217 = wp::load(var_1215);
            var_1216 = smaller_0(var_1204, var_1217);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_1218 = wp::mul(var_24, var_1);
            var_1219 = wp::add(var_1214, var_1218);
            var_1220 = wp::address(var_boxes, var_1219);
            var_1222 = wp::load(var_1220);
            var_1221 = larger_0(var_1206, var_1222);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_1224 = wp::add(var_below, var_0);
            var_1225 = wp::mul(var_1224, var_4);
            var_1226 = wp::mul(var_1203, var_1);
            var_1227 = wp::add(var_1225, var_1226);
            var_1228 = wp::add(var_1227, var_1223);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_1229 = wp::address(var_boxes, var_1228);
            var_1231 = wp::load(var_1229);
            var_1230 = smaller_0(var_1216, var_1231);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_1232 = wp::mul(var_24, var_1);
            var_1233 = wp::add(var_1228, var_1232);
            var_1234 = wp::address(var_boxes, var_1233);
            var_1236 = wp::load(var_1234);
            var_1235 = larger_0(var_1221, var_1236);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_1238 = wp::add(var_below, var_0);
            var_1239 = wp::mul(var_1238, var_4);
            var_1240 = wp::mul(var_1203, var_1);
            var_1241 = wp::add(var_1239, var_1240);
            var_1242 = wp::add(var_1241, var_1237);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_1243 = wp::address(var_boxes, var_1242);
            var_1245 = wp::load(var_1243);
            var_1244 = smaller_0(var_1230, var_1245);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_1246 = wp::mul(var_24, var_1);
            var_1247 = wp::add(var_1242, var_1246);
            var_1248 = wp::address(var_boxes, var_1247);
            var_1250 = wp::load(var_1248);
            var_1249 = larger_0(var_1235, var_1250);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_1252 = wp::add(var_below, var_0);
            var_1253 = wp::mul(var_1252, var_4);
            var_1254 = wp::mul(var_1203, var_1);
            var_1255 = wp::add(var_1253, var_1254);
            var_1256 = wp::add(var_1255, var_1251);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_1257 = wp::address(var_boxes, var_1256);
            var_1259 = wp::load(var_1257);
            var_1258 = smaller_0(var_1244, var_1259);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_1260 = wp::mul(var_24, var_1);
            var_1261 = wp::add(var_1256, var_1260);
            var_1262 = wp::address(var_boxes, var_1261);
            var_1264 = wp::load(var_1262);
            var_1263 = larger_0(var_1249, var_1264);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_1266 = wp::add(var_below, var_0);
            var_1267 = wp::mul(var_1266, var_4);
            var_1268 = wp::mul(var_1203, var_1);
            var_1269 = wp::add(var_1267, var_1268);
            var_1270 = wp::add(var_1269, var_1265);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_1271 = wp::address(var_boxes, var_1270);
            var_1273 = wp::load(var_1271);
            var_1272 = smaller_0(var_1258, var_1273);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_1274 = wp::mul(var_24, var_1);
            var_1275 = wp::add(var_1270, var_1274);
            var_1276 = wp::address(var_boxes, var_1275);
            var_1278 = wp::load(var_1276);
            var_1277 = larger_0(var_1263, var_1278);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_1280 = wp::add(var_below, var_0);
            var_1281 = wp::mul(var_1280, var_4);
            var_1282 = wp::mul(var_1203, var_1);
            var_1283 = wp::add(var_1281, var_1282);
            var_1284 = wp::add(var_1283, var_1279);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_1285 = wp::address(var_boxes, var_1284);
            var_1287 = wp::load(var_1285);
            var_1286 = smaller_0(var_1272, var_1287);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_1288 = wp::mul(var_24, var_1);
            var_1289 = wp::add(var_1284, var_1288);
            var_1290 = wp::address(var_boxes, var_1289);
            var_1292 = wp::load(var_1290);
            var_1291 = larger_0(var_1277, var_1292);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_1294 = wp::add(var_below, var_0);
            var_1295 = wp::mul(var_1294, var_4);
            var_1296 = wp::mul(var_1203, var_1);
            var_1297 = wp::add(var_1295, var_1296);
            var_1298 = wp::add(var_1297, var_1293);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_1299 = wp::address(var_boxes, var_1298);
            var_1301 = wp::load(var_1299);
            var_1300 = smaller_0(var_1286, var_1301);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_1302 = wp::mul(var_24, var_1);
            var_1303 = wp::add(var_1298, var_1302);
            var_1304 = wp::address(var_boxes, var_1303);
            var_1306 = wp::load(var_1304);
            var_1305 = larger_0(var_1291, var_1306);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_1308 = wp::add(var_below, var_0);
            var_1309 = wp::mul(var_1308, var_4);
            var_1310 = wp::mul(var_1203, var_1);
            var_1311 = wp::add(var_1309, var_1310);
            var_1312 = wp::add(var_1311, var_1307);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_1313 = wp::address(var_boxes, var_1312);
            var_1315 = wp::load(var_1313);
            var_1314 = smaller_0(var_1300, var_1315);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_1316 = wp::mul(var_24, var_1);
            var_1317 = wp::add(var_1312, var_1316);
            var_1318 = wp::address(var_boxes, var_1317);
            var_1320 = wp::load(var_1318);
            var_1319 = larger_0(var_1305, var_1320);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_1322 = wp::add(var_below, var_0);
            var_1323 = wp::mul(var_1322, var_4);
            var_1324 = wp::mul(var_1203, var_1);
            var_1325 = wp::add(var_1323, var_1324);
            var_1326 = wp::add(var_1325, var_1321);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_1327 = wp::address(var_boxes, var_1326);
            var_1329 = wp::load(var_1327);
            var_1328 = smaller_0(var_1314, var_1329);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_1330 = wp::mul(var_24, var_1);
            var_1331 = wp::add(var_1326, var_1330);
            var_1332 = wp::address(var_boxes, var_1331);
            var_1334 = wp::load(var_1332);
            var_1333 = larger_0(var_1319, var_1334);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_1336 = wp::add(var_below, var_0);
            var_1337 = wp::mul(var_1336, var_4);
            var_1338 = wp::mul(var_1203, var_1);
            var_1339 = wp::add(var_1337, var_1338);
            var_1340 = wp::add(var_1339, var_1335);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_1341 = wp::address(var_boxes, var_1340);
            var_1343 = wp::load(var_1341);
            var_1342 = smaller_0(var_1328, var_1343);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_1344 = wp::mul(var_24, var_1);
            var_1345 = wp::add(var_1340, var_1344);
            var_1346 = wp::address(var_boxes, var_1345);
            var_1348 = wp::load(var_1346);
            var_1347 = larger_0(var_1333, var_1348);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_1350 = wp::add(var_below, var_0);
            var_1351 = wp::mul(var_1350, var_4);
            var_1352 = wp::mul(var_1203, var_1);
            var_1353 = wp::add(var_1351, var_1352);
            var_1354 = wp::add(var_1353, var_1349);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_1355 = wp::address(var_boxes, var_1354);
            var_1357 = wp::load(var_1355);
            var_1356 = smaller_0(var_1342, var_1357);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_1358 = wp::mul(var_24, var_1);
            var_1359 = wp::add(var_1354, var_1358);
            var_1360 = wp::address(var_boxes, var_1359);
            var_1362 = wp::load(var_1360);
            var_1361 = larger_0(var_1347, var_1362);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_1364 = wp::add(var_below, var_0);
            var_1365 = wp::mul(var_1364, var_4);
            var_1366 = wp::mul(var_1203, var_1);
            var_1367 = wp::add(var_1365, var_1366);
            var_1368 = wp::add(var_1367, var_1363);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_1369 = wp::address(var_boxes, var_1368);
            var_1371 = wp::load(var_1369);
            var_1370 = smaller_0(var_1356, var_1371);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_1372 = wp::mul(var_24, var_1);
            var_1373 = wp::add(var_1368, var_1372);
            var_1374 = wp::address(var_boxes, var_1373);
            var_1376 = wp::load(var_1374);
            var_1375 = larger_0(var_1361, var_1376);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_1378 = wp::add(var_below, var_0);
            var_1379 = wp::mul(var_1378, var_4);
            var_1380 = wp::mul(var_1203, var_1);
            var_1381 = wp::add(var_1379, var_1380);
            var_1382 = wp::add(var_1381, var_1377);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_1383 = wp::address(var_boxes, var_1382);
            var_1385 = wp::load(var_1383);
            var_1384 = smaller_0(var_1370, var_1385);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_1386 = wp::mul(var_24, var_1);
            var_1387 = wp::add(var_1382, var_1386);
            var_1388 = wp::address(var_boxes, var_1387);
            var_1390 = wp::load(var_1388);
            var_1389 = larger_0(var_1375, var_1390);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_1392 = wp::add(var_below, var_0);
            var_1393 = wp::mul(var_1392, var_4);
            var_1394 = wp::mul(var_1203, var_1);
            var_1395 = wp::add(var_1393, var_1394);
            var_1396 = wp::add(var_1395, var_1391);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_1397 = wp::address(var_boxes, var_1396);
            var_1399 = wp::load(var_1397);
            var_1398 = smaller_0(var_1384, var_1399);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_1400 = wp::mul(var_24, var_1);
            var_1401 = wp::add(var_1396, var_1400);
            var_1402 = wp::address(var_boxes, var_1401);
            var_1404 = wp::load(var_1402);
            var_1403 = larger_0(var_1389, var_1404);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_1406 = wp::add(var_below, var_0);
            var_1407 = wp::mul(var_1406, var_4);
            var_1408 = wp::mul(var_1203, var_1);
            var_1409 = wp::add(var_1407, var_1408);
            var_1410 = wp::add(var_1409, var_1405);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_1411 = wp::address(var_boxes, var_1410);
            var_1413 = wp::load(var_1411);
            var_1412 = smaller_0(var_1398, var_1413);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_1414 = wp::mul(var_24, var_1);
            var_1415 = wp::add(var_1410, var_1414);
            var_1416 = wp::address(var_boxes, var_1415);
            var_1418 = wp::load(var_1416);
            var_1417 = larger_0(var_1403, var_1418);
            // child = (below + i) * SIDES + k * FAN + j                                          <L 279>
            var_1420 = wp::add(var_below, var_0);
            var_1421 = wp::mul(var_1420, var_4);
            var_1422 = wp::mul(var_1203, var_1);
            var_1423 = wp::add(var_1421, var_1422);
            var_1424 = wp::add(var_1423, var_1419);
            // low = smaller(low, boxes[child])                                                   <L 280>
            var_1425 = wp::address(var_boxes, var_1424);
            var_1427 = wp::load(var_1425);
            var_1426 = smaller_0(var_1412, var_1427);
            // high = larger(high, boxes[child + BOXED * FAN])                                    <L 281>
            var_1428 = wp::mul(var_24, var_1);
            var_1429 = wp::add(var_1424, var_1428);
            var_1430 = wp::address(var_boxes, var_1429);
            var_1432 = wp::load(var_1430);
            var_1431 = larger_0(var_1417, var_1432);
        }
        var_1433 = wp::where(var_1208, var_1426, var_1204);
        var_1434 = wp::where(var_1208, var_1431, var_1206);
        var_1435 = wp::where(var_1208, var_1419, var_1196);
        var_1436 = wp::where(var_1208, var_1424, var_1197);
        // boxes[at + k * FAN] = low                                                              <L 282>
        var_1437 = wp::mul(var_1203, var_1);
        var_1438 = wp::add(var_7, var_1437);
        wp::array_store(var_boxes, var_1438, var_1433);
        // boxes[at + (BOXED + k) * FAN] = high                                                   <L 283>
        var_1439 = wp::add(var_24, var_1203);
        var_1440 = wp::mul(var_1439, var_1);
        var_1441 = wp::add(var_7, var_1440);
        wp::array_store(var_boxes, var_1441, var_1434);
}



extern "C" __global__ void bound_groups_kernel_dd4db768_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_coordinates,
    wp::array_t<wp::int32> var_order,
    wp::int32 var_tree__width,
    wp::array_t<wp::float32> var_tree__packed,
    wp::array_t<wp::float32> var_tree__grouped,
    wp::array_t<wp::int32> var_tree__alike,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::array_t<wp::float32> var_tree__extent)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        const wp::int32 var_1 = 16;
        wp::int32 var_2;
        const wp::int32 var_3 = 0;
        wp::shape_t* var_4;
        const wp::int32 var_5 = 0;
        wp::int32 var_6;
        wp::shape_t var_7;
        wp::int32 var_8;
        wp::int32 var_9;
        wp::int32 var_10;
        const wp::float32 var_11 = INFINITY;
        wp::vec_t<6, wp::float32> var_12;
        const wp::float32 var_13 = -INFINITY;
        wp::vec_t<6, wp::float32> var_14;
        const wp::float32 var_15 = 0.0;
        wp::float32 var_16;
        wp::range_t var_17;
        wp::int32 var_18;
        wp::int32 var_19;
        wp::int32* var_20;
        wp::int32 var_21;
        wp::int32 var_22;
        const wp::float32 var_23 = 0.0;
        wp::float32 var_24;
        const wp::int32 var_25 = 0;
        wp::float32* var_26;
        wp::float32 var_27;
        wp::float32 var_28;
        const wp::int32 var_29 = 16;
        wp::int32 var_30;
        wp::int32 var_31;
        wp::int32 var_32;
        wp::int32 var_33;
        wp::float32 var_34;
        wp::float32 var_35;
        const wp::int32 var_36 = 1;
        wp::float32* var_37;
        wp::float32 var_38;
        wp::float32 var_39;
        wp::int32 var_40;
        wp::int32 var_41;
        wp::int32 var_42;
        wp::int32 var_43;
        wp::float32 var_44;
        wp::float32 var_45;
        const wp::int32 var_46 = 2;
        wp::float32* var_47;
        wp::float32 var_48;
        wp::float32 var_49;
        wp::int32 var_50;
        wp::int32 var_51;
        wp::int32 var_52;
        wp::int32 var_53;
        wp::float32 var_54;
        wp::float32 var_55;
        const wp::int32 var_56 = 3;
        wp::float32* var_57;
        wp::float32 var_58;
        wp::float32 var_59;
        wp::int32 var_60;
        wp::int32 var_61;
        wp::int32 var_62;
        wp::int32 var_63;
        wp::float32 var_64;
        wp::float32 var_65;
        const wp::int32 var_66 = 4;
        wp::float32* var_67;
        wp::float32 var_68;
        wp::float32 var_69;
        wp::int32 var_70;
        wp::int32 var_71;
        wp::int32 var_72;
        wp::int32 var_73;
        wp::float32 var_74;
        wp::float32 var_75;
        const wp::int32 var_76 = 5;
        wp::float32* var_77;
        wp::float32 var_78;
        wp::float32 var_79;
        wp::int32 var_80;
        wp::int32 var_81;
        wp::int32 var_82;
        wp::int32 var_83;
        wp::float32 var_84;
        wp::float32 var_85;
        const wp::int32 var_86 = 6;
        wp::float32* var_87;
        wp::float32 var_88;
        wp::float32 var_89;
        wp::int32 var_90;
        wp::int32 var_91;
        wp::int32 var_92;
        wp::int32 var_93;
        wp::float32 var_94;
        wp::float32 var_95;
        const wp::int32 var_96 = 7;
        wp::float32* var_97;
        wp::float32 var_98;
        wp::float32 var_99;
        wp::int32 var_100;
        wp::int32 var_101;
        wp::int32 var_102;
        wp::int32 var_103;
        wp::float32 var_104;
        wp::float32 var_105;
        const wp::int32 var_106 = 8;
        wp::float32* var_107;
        wp::float32 var_108;
        wp::float32 var_109;
        wp::int32 var_110;
        wp::int32 var_111;
        wp::int32 var_112;
        wp::int32 var_113;
        wp::float32 var_114;
        wp::float32 var_115;
        const wp::int32 var_116 = 9;
        wp::float32* var_117;
        wp::float32 var_118;
        wp::float32 var_119;
        wp::int32 var_120;
        wp::int32 var_121;
        wp::int32 var_122;
        wp::int32 var_123;
        wp::float32 var_124;
        wp::float32 var_125;
        const wp::int32 var_126 = 10;
        wp::float32* var_127;
        wp::float32 var_128;
        wp::float32 var_129;
        wp::int32 var_130;
        wp::int32 var_131;
        wp::int32 var_132;
        wp::int32 var_133;
        wp::float32 var_134;
        wp::float32 var_135;
        const wp::int32 var_136 = 11;
        wp::float32* var_137;
        wp::float32 var_138;
        wp::float32 var_139;
        wp::int32 var_140;
        wp::int32 var_141;
        wp::int32 var_142;
        wp::int32 var_143;
        wp::float32 var_144;
        wp::float32 var_145;
        const wp::int32 var_146 = 12;
        wp::float32* var_147;
        wp::float32 var_148;
        wp::float32 var_149;
        wp::int32 var_150;
        wp::int32 var_151;
        wp::int32 var_152;
        wp::int32 var_153;
        wp::float32 var_154;
        wp::float32 var_155;
        const wp::int32 var_156 = 13;
        wp::float32* var_157;
        wp::float32 var_158;
        wp::float32 var_159;
        wp::int32 var_160;
        wp::int32 var_161;
        wp::int32 var_162;
        wp::int32 var_163;
        wp::float32 var_164;
        wp::float32 var_165;
        const wp::int32 var_166 = 14;
        wp::float32* var_167;
        wp::float32 var_168;
        wp::float32 var_169;
        wp::int32 var_170;
        wp::int32 var_171;
        wp::int32 var_172;
        wp::int32 var_173;
        wp::float32 var_174;
        wp::float32 var_175;
        const wp::int32 var_176 = 15;
        wp::float32* var_177;
        wp::float32 var_178;
        wp::float32 var_179;
        wp::int32 var_180;
        wp::int32 var_181;
        wp::int32 var_182;
        wp::int32 var_183;
        wp::float32 var_184;
        wp::float32 var_185;
        const wp::int32 var_186 = 0;
        wp::float32 var_187;
        wp::float32* var_188;
        wp::float32 var_189;
        wp::float32 var_190;
        wp::float32 var_191;
        wp::float32* var_192;
        wp::float32 var_193;
        wp::float32 var_194;
        const wp::int32 var_195 = 1;
        wp::float32 var_196;
        wp::float32* var_197;
        wp::float32 var_198;
        wp::float32 var_199;
        wp::float32 var_200;
        wp::float32* var_201;
        wp::float32 var_202;
        wp::float32 var_203;
        const wp::int32 var_204 = 2;
        wp::float32 var_205;
        wp::float32* var_206;
        wp::float32 var_207;
        wp::float32 var_208;
        wp::float32 var_209;
        wp::float32* var_210;
        wp::float32 var_211;
        wp::float32 var_212;
        const wp::int32 var_213 = 3;
        wp::float32 var_214;
        wp::float32* var_215;
        wp::float32 var_216;
        wp::float32 var_217;
        wp::float32 var_218;
        wp::float32* var_219;
        wp::float32 var_220;
        wp::float32 var_221;
        const wp::int32 var_222 = 4;
        wp::float32 var_223;
        wp::float32* var_224;
        wp::float32 var_225;
        wp::float32 var_226;
        wp::float32 var_227;
        wp::float32* var_228;
        wp::float32 var_229;
        wp::float32 var_230;
        const wp::int32 var_231 = 5;
        wp::float32 var_232;
        wp::float32* var_233;
        wp::float32 var_234;
        wp::float32 var_235;
        wp::float32 var_236;
        wp::float32* var_237;
        wp::float32 var_238;
        wp::float32 var_239;
        wp::float32 var_240;
        const wp::int32 var_241 = 16;
        wp::int32 var_242;
        const wp::int32 var_243 = 192;
        wp::int32 var_244;
        wp::int32 var_245;
        wp::int32 var_246;
        const wp::int32 var_247 = 0;
        wp::float32 var_248;
        wp::int32 var_249;
        wp::int32 var_250;
        wp::float32 var_251;
        const wp::int32 var_252 = 6;
        wp::int32 var_253;
        wp::int32 var_254;
        wp::int32 var_255;
        const wp::int32 var_256 = 1;
        wp::float32 var_257;
        wp::int32 var_258;
        wp::int32 var_259;
        wp::float32 var_260;
        wp::int32 var_261;
        wp::int32 var_262;
        wp::int32 var_263;
        const wp::int32 var_264 = 2;
        wp::float32 var_265;
        wp::int32 var_266;
        wp::int32 var_267;
        wp::float32 var_268;
        wp::int32 var_269;
        wp::int32 var_270;
        wp::int32 var_271;
        const wp::int32 var_272 = 3;
        wp::float32 var_273;
        wp::int32 var_274;
        wp::int32 var_275;
        wp::float32 var_276;
        wp::int32 var_277;
        wp::int32 var_278;
        wp::int32 var_279;
        const wp::int32 var_280 = 4;
        wp::float32 var_281;
        wp::int32 var_282;
        wp::int32 var_283;
        wp::float32 var_284;
        wp::int32 var_285;
        wp::int32 var_286;
        wp::int32 var_287;
        const wp::int32 var_288 = 5;
        wp::float32 var_289;
        wp::int32 var_290;
        wp::int32 var_291;
        wp::float32 var_292;
        wp::int32 var_293;
        wp::int32 var_294;
        wp::int32 var_295;
        wp::shape_t* var_296;
        const wp::int32 var_297 = 0;
        wp::int32 var_298;
        wp::shape_t var_299;
        bool var_300;
        const wp::int32 var_301 = 16;
        wp::range_t var_302;
        wp::int32 var_303;
        wp::int32 var_304;
        const wp::int32 var_305 = 0;
        wp::int32 var_306;
        wp::int32 var_307;
        wp::int32 var_308;
        wp::int32 var_309;
        const wp::int32 var_310 = 1;
        wp::int32 var_311;
        wp::int32 var_312;
        wp::int32 var_313;
        wp::int32 var_314;
        const wp::int32 var_315 = 2;
        wp::int32 var_316;
        wp::int32 var_317;
        wp::int32 var_318;
        wp::int32 var_319;
        const wp::int32 var_320 = 3;
        wp::int32 var_321;
        wp::int32 var_322;
        wp::int32 var_323;
        wp::int32 var_324;
        const wp::int32 var_325 = 4;
        wp::int32 var_326;
        wp::int32 var_327;
        wp::int32 var_328;
        wp::int32 var_329;
        const wp::int32 var_330 = 5;
        wp::int32 var_331;
        wp::int32 var_332;
        wp::int32 var_333;
        wp::int32 var_334;
        const wp::int32 var_335 = 6;
        wp::int32 var_336;
        wp::int32 var_337;
        wp::int32 var_338;
        wp::int32 var_339;
        const wp::int32 var_340 = 7;
        wp::int32 var_341;
        wp::int32 var_342;
        wp::int32 var_343;
        wp::int32 var_344;
        const wp::int32 var_345 = 8;
        wp::int32 var_346;
        wp::int32 var_347;
        wp::int32 var_348;
        wp::int32 var_349;
        const wp::int32 var_350 = 9;
        wp::int32 var_351;
        wp::int32 var_352;
        wp::int32 var_353;
        wp::int32 var_354;
        const wp::int32 var_355 = 10;
        wp::int32 var_356;
        wp::int32 var_357;
        wp::int32 var_358;
        wp::int32 var_359;
        const wp::int32 var_360 = 11;
        wp::int32 var_361;
        wp::int32 var_362;
        wp::int32 var_363;
        wp::int32 var_364;
        const wp::int32 var_365 = 12;
        wp::int32 var_366;
        wp::int32 var_367;
        wp::int32 var_368;
        wp::int32 var_369;
        const wp::int32 var_370 = 13;
        wp::int32 var_371;
        wp::int32 var_372;
        wp::int32 var_373;
        wp::int32 var_374;
        const wp::int32 var_375 = 14;
        wp::int32 var_376;
        wp::int32 var_377;
        wp::int32 var_378;
        wp::int32 var_379;
        const wp::int32 var_380 = 15;
        wp::int32 var_381;
        wp::int32 var_382;
        wp::int32 var_383;
        wp::int32 var_384;
        wp::int32 var_385;
        wp::int32 var_386;
        const wp::int32 var_387 = 0;
        bool var_388;
        wp::int32 var_389;
        wp::int32 var_390;
        bool var_391;
        const wp::int32 var_392 = 1;
        bool var_393;
        const wp::int32 var_394 = 0;
        bool var_395;
        wp::int32 var_396;
        wp::int32 var_397;
        wp::int32 var_398;
        wp::int32 var_399;
        wp::int32 var_400;
        const wp::int32 var_401 = 0;
        wp::float32 var_402;
        //---------
        // forward
        // def bound_groups_kernel(coordinates, order, tree__width, tree__packed, tree__grouped, tree__alike, tree__boxes, tree__extent):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // first = i * GROUP                                                                      <L 4>
        var_2 = wp::mul(var_0, var_1);
        // size = max(0, min(GROUP, order.shape[0] - first))                                      <L 5>
        var_4 = &(var_order.shape);
        var_7 = wp::load(var_4);
        var_6 = wp::extract(var_7, var_5);
        var_8 = wp::sub(var_6, var_2);
        var_9 = wp::min(var_1, var_8);
        var_10 = wp::max(var_3, var_9);
        // low = boxed(INFINITY)                                                                  <L 6>
        var_12 = wp::vec_t<6, wp::float32>(var_11);
        // high = boxed(-INFINITY)                                                                <L 7>
        var_14 = wp::vec_t<6, wp::float32>(var_13);
        // longest = float(0.0)                                                                   <L 8>
        var_16 = wp::float(var_15);
        // for lane in range(size):                                                               <L 9>
        var_17 = wp::range(var_10);
        start_for_0:;
            if (iter_cmp(var_17) == 0) goto end_for_0;
            var_18 = wp::iter_next(var_17);
            // position = order[first + lane]                                                     <L 10>
            var_19 = wp::add(var_2, var_18);
            var_20 = wp::address(var_order, var_19);
            var_22 = wp::load(var_20);
            var_21 = wp::copy(var_22);
            // sqlength = float(0.0)                                                              <L 11>
            var_24 = wp::float(var_23);
            // for k in range(AXES):                                                              <L 12>
            // x = coordinates[position, k]                                                       <L 13>
            var_26 = wp::address(var_coordinates, var_21, var_25);
            var_28 = wp::load(var_26);
            var_27 = wp::copy(var_28);
            // tree__grouped[(i * AXES + k) * GROUP + lane] = x                                   <L 14>
            var_30 = wp::mul(var_0, var_29);
            var_31 = wp::add(var_30, var_25);
            var_32 = wp::mul(var_31, var_1);
            var_33 = wp::add(var_32, var_18);
            wp::array_store(var_tree__grouped, var_33, var_27);
            // sqlength += x * x                                                                  <L 15>
            var_34 = wp::mul(var_27, var_27);
            var_35 = wp::add(var_24, var_34);
            // x = coordinates[position, k]                                                       <L 13>
            var_37 = wp::address(var_coordinates, var_21, var_36);
            var_39 = wp::load(var_37);
            var_38 = wp::copy(var_39);
            // tree__grouped[(i * AXES + k) * GROUP + lane] = x                                   <L 14>
            var_40 = wp::mul(var_0, var_29);
            var_41 = wp::add(var_40, var_36);
            var_42 = wp::mul(var_41, var_1);
            var_43 = wp::add(var_42, var_18);
            wp::array_store(var_tree__grouped, var_43, var_38);
            // sqlength += x * x                                                                  <L 15>
            var_44 = wp::mul(var_38, var_38);
            var_45 = wp::add(var_35, var_44);
            // x = coordinates[position, k]                                                       <L 13>
            var_47 = wp::address(var_coordinates, var_21, var_46);
            var_49 = wp::load(var_47);
            var_48 = wp::copy(var_49);
            // tree__grouped[(i * AXES + k) * GROUP + lane] = x                                   <L 14>
            var_50 = wp::mul(var_0, var_29);
            var_51 = wp::add(var_50, var_46);
            var_52 = wp::mul(var_51, var_1);
            var_53 = wp::add(var_52, var_18);
            wp::array_store(var_tree__grouped, var_53, var_48);
            // sqlength += x * x                                                                  <L 15>
            var_54 = wp::mul(var_48, var_48);
            var_55 = wp::add(var_45, var_54);
            // x = coordinates[position, k]                                                       <L 13>
            var_57 = wp::address(var_coordinates, var_21, var_56);
            var_59 = wp::load(var_57);
            var_58 = wp::copy(var_59);
            // tree__grouped[(i * AXES + k) * GROUP + lane] = x                                   <L 14>
            var_60 = wp::mul(var_0, var_29);
            var_61 = wp::add(var_60, var_56);
            var_62 = wp::mul(var_61, var_1);
            var_63 = wp::add(var_62, var_18);
            wp::array_store(var_tree__grouped, var_63, var_58);
            // sqlength += x * x                                                                  <L 15>
            var_64 = wp::mul(var_58, var_58);
            var_65 = wp::add(var_55, var_64);
            // x = coordinates[position, k]                                                       <L 13>
            var_67 = wp::address(var_coordinates, var_21, var_66);
            var_69 = wp::load(var_67);
            var_68 = wp::copy(var_69);
            // tree__grouped[(i * AXES + k) * GROUP + lane] = x                                   <L 14>
            var_70 = wp::mul(var_0, var_29);
            var_71 = wp::add(var_70, var_66);
            var_72 = wp::mul(var_71, var_1);
            var_73 = wp::add(var_72, var_18);
            wp::array_store(var_tree__grouped, var_73, var_68);
            // sqlength += x * x                                                                  <L 15>
            var_74 = wp::mul(var_68, var_68);
            var_75 = wp::add(var_65, var_74);
            // x = coordinates[position, k]                                                       <L 13>
            var_77 = wp::address(var_coordinates, var_21, var_76);
            var_79 = wp::load(var_77);
            var_78 = wp::copy(var_79);
            // tree__grouped[(i * AXES + k) * GROUP + lane] = x                                   <L 14>
            var_80 = wp::mul(var_0, var_29);
            var_81 = wp::add(var_80, var_76);
            var_82 = wp::mul(var_81, var_1);
            var_83 = wp::add(var_82, var_18);
            wp::array_store(var_tree__grouped, var_83, var_78);
            // sqlength += x * x                                                                  <L 15>
            var_84 = wp::mul(var_78, var_78);
            var_85 = wp::add(var_75, var_84);
            // x = coordinates[position, k]                                                       <L 13>
            var_87 = wp::address(var_coordinates, var_21, var_86);
            var_89 = wp::load(var_87);
            var_88 = wp::copy(var_89);
            // tree__grouped[(i * AXES + k) * GROUP + lane] = x                                   <L 14>
            var_90 = wp::mul(var_0, var_29);
            var_91 = wp::add(var_90, var_86);
            var_92 = wp::mul(var_91, var_1);
            var_93 = wp::add(var_92, var_18);
            wp::array_store(var_tree__grouped, var_93, var_88);
            // sqlength += x * x                                                                  <L 15>
            var_94 = wp::mul(var_88, var_88);
            var_95 = wp::add(var_85, var_94);
            // x = coordinates[position, k]                                                       <L 13>
            var_97 = wp::address(var_coordinates, var_21, var_96);
            var_99 = wp::load(var_97);
            var_98 = wp::copy(var_99);
            // tree__grouped[(i * AXES + k) * GROUP + lane] = x                                   <L 14>
            var_100 = wp::mul(var_0, var_29);
            var_101 = wp::add(var_100, var_96);
            var_102 = wp::mul(var_101, var_1);
            var_103 = wp::add(var_102, var_18);
            wp::array_store(var_tree__grouped, var_103, var_98);
            // sqlength += x * x                                                                  <L 15>
            var_104 = wp::mul(var_98, var_98);
            var_105 = wp::add(var_95, var_104);
            // x = coordinates[position, k]                                                       <L 13>
            var_107 = wp::address(var_coordinates, var_21, var_106);
            var_109 = wp::load(var_107);
            var_108 = wp::copy(var_109);
            // tree__grouped[(i * AXES + k) * GROUP + lane] = x                                   <L 14>
            var_110 = wp::mul(var_0, var_29);
            var_111 = wp::add(var_110, var_106);
            var_112 = wp::mul(var_111, var_1);
            var_113 = wp::add(var_112, var_18);
            wp::array_store(var_tree__grouped, var_113, var_108);
            // sqlength += x * x                                                                  <L 15>
            var_114 = wp::mul(var_108, var_108);
            var_115 = wp::add(var_105, var_114);
            // x = coordinates[position, k]                                                       <L 13>
            var_117 = wp::address(var_coordinates, var_21, var_116);
            var_119 = wp::load(var_117);
            var_118 = wp::copy(var_119);
            // tree__grouped[(i * AXES + k) * GROUP + lane] = x                                   <L 14>
            var_120 = wp::mul(var_0, var_29);
            var_121 = wp::add(var_120, var_116);
            var_122 = wp::mul(var_121, var_1);
            var_123 = wp::add(var_122, var_18);
            wp::array_store(var_tree__grouped, var_123, var_118);
            // sqlength += x * x                                                                  <L 15>
            var_124 = wp::mul(var_118, var_118);
            var_125 = wp::add(var_115, var_124);
            // x = coordinates[position, k]                                                       <L 13>
            var_127 = wp::address(var_coordinates, var_21, var_126);
            var_129 = wp::load(var_127);
            var_128 = wp::copy(var_129);
            // tree__grouped[(i * AXES + k) * GROUP + lane] = x                                   <L 14>
            var_130 = wp::mul(var_0, var_29);
            var_131 = wp::add(var_130, var_126);
            var_132 = wp::mul(var_131, var_1);
            var_133 = wp::add(var_132, var_18);
            wp::array_store(var_tree__grouped, var_133, var_128);
            // sqlength += x * x                                                                  <L 15>
            var_134 = wp::mul(var_128, var_128);
            var_135 = wp::add(var_125, var_134);
            // x = coordinates[position, k]                                                       <L 13>
            var_137 = wp::address(var_coordinates, var_21, var_136);
            var_139 = wp::load(var_137);
            var_138 = wp::copy(var_139);
            // tree__grouped[(i * AXES + k) * GROUP + lane] = x                                   <L 14>
            var_140 = wp::mul(var_0, var_29);
            var_141 = wp::add(var_140, var_136);
            var_142 = wp::mul(var_141, var_1);
            var_143 = wp::add(var_142, var_18);
            wp::array_store(var_tree__grouped, var_143, var_138);
            // sqlength += x * x                                                                  <L 15>
            var_144 = wp::mul(var_138, var_138);
            var_145 = wp::add(var_135, var_144);
            // x = coordinates[position, k]                                                       <L 13>
            var_147 = wp::address(var_coordinates, var_21, var_146);
            var_149 = wp::load(var_147);
            var_148 = wp::copy(var_149);
            // tree__grouped[(i * AXES + k) * GROUP + lane] = x                                   <L 14>
            var_150 = wp::mul(var_0, var_29);
            var_151 = wp::add(var_150, var_146);
            var_152 = wp::mul(var_151, var_1);
            var_153 = wp::add(var_152, var_18);
            wp::array_store(var_tree__grouped, var_153, var_148);
            // sqlength += x * x                                                                  <L 15>
            var_154 = wp::mul(var_148, var_148);
            var_155 = wp::add(var_145, var_154);
            // x = coordinates[position, k]                                                       <L 13>
            var_157 = wp::address(var_coordinates, var_21, var_156);
            var_159 = wp::load(var_157);
            var_158 = wp::copy(var_159);
            // tree__grouped[(i * AXES + k) * GROUP + lane] = x                                   <L 14>
            var_160 = wp::mul(var_0, var_29);
            var_161 = wp::add(var_160, var_156);
            var_162 = wp::mul(var_161, var_1);
            var_163 = wp::add(var_162, var_18);
            wp::array_store(var_tree__grouped, var_163, var_158);
            // sqlength += x * x                                                                  <L 15>
            var_164 = wp::mul(var_158, var_158);
            var_165 = wp::add(var_155, var_164);
            // x = coordinates[position, k]                                                       <L 13>
            var_167 = wp::address(var_coordinates, var_21, var_166);
            var_169 = wp::load(var_167);
            var_168 = wp::copy(var_169);
            // tree__grouped[(i * AXES + k) * GROUP + lane] = x                                   <L 14>
            var_170 = wp::mul(var_0, var_29);
            var_171 = wp::add(var_170, var_166);
            var_172 = wp::mul(var_171, var_1);
            var_173 = wp::add(var_172, var_18);
            wp::array_store(var_tree__grouped, var_173, var_168);
            // sqlength += x * x                                                                  <L 15>
            var_174 = wp::mul(var_168, var_168);
            var_175 = wp::add(var_165, var_174);
            // x = coordinates[position, k]                                                       <L 13>
            var_177 = wp::address(var_coordinates, var_21, var_176);
            var_179 = wp::load(var_177);
            var_178 = wp::copy(var_179);
            // tree__grouped[(i * AXES + k) * GROUP + lane] = x                                   <L 14>
            var_180 = wp::mul(var_0, var_29);
            var_181 = wp::add(var_180, var_176);
            var_182 = wp::mul(var_181, var_1);
            var_183 = wp::add(var_182, var_18);
            wp::array_store(var_tree__grouped, var_183, var_178);
            // sqlength += x * x                                                                  <L 15>
            var_184 = wp::mul(var_178, var_178);
            var_185 = wp::add(var_175, var_184);
            // for k in range(BOXED):                                                             <L 16>
            // low[k] = smaller(low[k], coordinates[position, k])                                 <L 17>
            var_187 = wp::extract(var_12, var_186);
            var_188 = wp::address(var_coordinates, var_21, var_186);
            var_190 = wp::load(var_188);
            var_189 = smaller_0(var_187, var_190);
            wp::assign_inplace(var_12, var_186, var_189);
            // high[k] = larger(high[k], coordinates[position, k])                                <L 18>
            var_191 = wp::extract(var_14, var_186);
            var_192 = wp::address(var_coordinates, var_21, var_186);
            var_194 = wp::load(var_192);
            var_193 = larger_0(var_191, var_194);
            wp::assign_inplace(var_14, var_186, var_193);
            // low[k] = smaller(low[k], coordinates[position, k])                                 <L 17>
            var_196 = wp::extract(var_12, var_195);
            var_197 = wp::address(var_coordinates, var_21, var_195);
            var_199 = wp::load(var_197);
            var_198 = smaller_0(var_196, var_199);
            wp::assign_inplace(var_12, var_195, var_198);
            // high[k] = larger(high[k], coordinates[position, k])                                <L 18>
            var_200 = wp::extract(var_14, var_195);
            var_201 = wp::address(var_coordinates, var_21, var_195);
            var_203 = wp::load(var_201);
            var_202 = larger_0(var_200, var_203);
            wp::assign_inplace(var_14, var_195, var_202);
            // low[k] = smaller(low[k], coordinates[position, k])                                 <L 17>
            var_205 = wp::extract(var_12, var_204);
            var_206 = wp::address(var_coordinates, var_21, var_204);
            var_208 = wp::load(var_206);
            var_207 = smaller_0(var_205, var_208);
            wp::assign_inplace(var_12, var_204, var_207);
            // high[k] = larger(high[k], coordinates[position, k])                                <L 18>
            var_209 = wp::extract(var_14, var_204);
            var_210 = wp::address(var_coordinates, var_21, var_204);
            var_212 = wp::load(var_210);
            var_211 = larger_0(var_209, var_212);
            wp::assign_inplace(var_14, var_204, var_211);
            // low[k] = smaller(low[k], coordinates[position, k])                                 <L 17>
            var_214 = wp::extract(var_12, var_213);
            var_215 = wp::address(var_coordinates, var_21, var_213);
            var_217 = wp::load(var_215);
            var_216 = smaller_0(var_214, var_217);
            wp::assign_inplace(var_12, var_213, var_216);
            // high[k] = larger(high[k], coordinates[position, k])                                <L 18>
            var_218 = wp::extract(var_14, var_213);
            var_219 = wp::address(var_coordinates, var_21, var_213);
            var_221 = wp::load(var_219);
            var_220 = larger_0(var_218, var_221);
            wp::assign_inplace(var_14, var_213, var_220);
            // low[k] = smaller(low[k], coordinates[position, k])                                 <L 17>
            var_223 = wp::extract(var_12, var_222);
            var_224 = wp::address(var_coordinates, var_21, var_222);
            var_226 = wp::load(var_224);
            var_225 = smaller_0(var_223, var_226);
            wp::assign_inplace(var_12, var_222, var_225);
            // high[k] = larger(high[k], coordinates[position, k])                                <L 18>
            var_227 = wp::extract(var_14, var_222);
            var_228 = wp::address(var_coordinates, var_21, var_222);
            var_230 = wp::load(var_228);
            var_229 = larger_0(var_227, var_230);
            wp::assign_inplace(var_14, var_222, var_229);
            // low[k] = smaller(low[k], coordinates[position, k])                                 <L 17>
            var_232 = wp::extract(var_12, var_231);
            var_233 = wp::address(var_coordinates, var_21, var_231);
            var_235 = wp::load(var_233);
            var_234 = smaller_0(var_232, var_235);
            wp::assign_inplace(var_12, var_231, var_234);
            // high[k] = larger(high[k], coordinates[position, k])                                <L 18>
            var_236 = wp::extract(var_14, var_231);
            var_237 = wp::address(var_coordinates, var_21, var_231);
            var_239 = wp::load(var_237);
            var_238 = larger_0(var_236, var_239);
            wp::assign_inplace(var_14, var_231, var_238);
            // longest = larger(longest, sqlength)                                                <L 19>
            var_240 = larger_0(var_16, var_185);
            wp::assign(var_16, var_240);
            goto start_for_0;
        end_for_0:;
        // at = i // FAN * SIDES + i % FAN                                                        <L 20>
        var_242 = wp::floordiv(var_0, var_241);
        var_244 = wp::mul(var_242, var_243);
        var_245 = wp::mod(var_0, var_241);
        var_246 = wp::add(var_244, var_245);
        // for k in range(BOXED):                                                                 <L 21>
        // tree__boxes[at + k * FAN] = low[k]                                                     <L 22>
        var_248 = wp::extract(var_12, var_247);
        var_249 = wp::mul(var_247, var_241);
        var_250 = wp::add(var_246, var_249);
        wp::array_store(var_tree__boxes, var_250, var_248);
        // tree__boxes[at + (BOXED + k) * FAN] = high[k]                                          <L 23>
        var_251 = wp::extract(var_14, var_247);
        var_253 = wp::add(var_252, var_247);
        var_254 = wp::mul(var_253, var_241);
        var_255 = wp::add(var_246, var_254);
        wp::array_store(var_tree__boxes, var_255, var_251);
        // tree__boxes[at + k * FAN] = low[k]                                                     <L 22>
        var_257 = wp::extract(var_12, var_256);
        var_258 = wp::mul(var_256, var_241);
        var_259 = wp::add(var_246, var_258);
        wp::array_store(var_tree__boxes, var_259, var_257);
        // tree__boxes[at + (BOXED + k) * FAN] = high[k]                                          <L 23>
        var_260 = wp::extract(var_14, var_256);
        var_261 = wp::add(var_252, var_256);
        var_262 = wp::mul(var_261, var_241);
        var_263 = wp::add(var_246, var_262);
        wp::array_store(var_tree__boxes, var_263, var_260);
        // tree__boxes[at + k * FAN] = low[k]                                                     <L 22>
        var_265 = wp::extract(var_12, var_264);
        var_266 = wp::mul(var_264, var_241);
        var_267 = wp::add(var_246, var_266);
        wp::array_store(var_tree__boxes, var_267, var_265);
        // tree__boxes[at + (BOXED + k) * FAN] = high[k]                                          <L 23>
        var_268 = wp::extract(var_14, var_264);
        var_269 = wp::add(var_252, var_264);
        var_270 = wp::mul(var_269, var_241);
        var_271 = wp::add(var_246, var_270);
        wp::array_store(var_tree__boxes, var_271, var_268);
        // tree__boxes[at + k * FAN] = low[k]                                                     <L 22>
        var_273 = wp::extract(var_12, var_272);
        var_274 = wp::mul(var_272, var_241);
        var_275 = wp::add(var_246, var_274);
        wp::array_store(var_tree__boxes, var_275, var_273);
        // tree__boxes[at + (BOXED + k) * FAN] = high[k]                                          <L 23>
        var_276 = wp::extract(var_14, var_272);
        var_277 = wp::add(var_252, var_272);
        var_278 = wp::mul(var_277, var_241);
        var_279 = wp::add(var_246, var_278);
        wp::array_store(var_tree__boxes, var_279, var_276);
        // tree__boxes[at + k * FAN] = low[k]                                                     <L 22>
        var_281 = wp::extract(var_12, var_280);
        var_282 = wp::mul(var_280, var_241);
        var_283 = wp::add(var_246, var_282);
        wp::array_store(var_tree__boxes, var_283, var_281);
        // tree__boxes[at + (BOXED + k) * FAN] = high[k]                                          <L 23>
        var_284 = wp::extract(var_14, var_280);
        var_285 = wp::add(var_252, var_280);
        var_286 = wp::mul(var_285, var_241);
        var_287 = wp::add(var_246, var_286);
        wp::array_store(var_tree__boxes, var_287, var_284);
        // tree__boxes[at + k * FAN] = low[k]                                                     <L 22>
        var_289 = wp::extract(var_12, var_288);
        var_290 = wp::mul(var_288, var_241);
        var_291 = wp::add(var_246, var_290);
        wp::array_store(var_tree__boxes, var_291, var_289);
        // tree__boxes[at + (BOXED + k) * FAN] = high[k]                                          <L 23>
        var_292 = wp::extract(var_14, var_288);
        var_293 = wp::add(var_252, var_288);
        var_294 = wp::mul(var_293, var_241);
        var_295 = wp::add(var_246, var_294);
        wp::array_store(var_tree__boxes, var_295, var_292);
        // if i < tree__alike.shape[0]:                                                           <L 24>
        var_296 = &(var_tree__alike.shape);
        var_299 = wp::load(var_296);
        var_298 = wp::extract(var_299, var_297);
        var_300 = (var_0 < var_298);
        if (var_300) {
            // for lane in range(size, GROUP):                                                    <L 25>
            var_302 = wp::range(var_10, var_301);
            var_303 = wp::copy(var_288);
            start_for_2:;
                if (iter_cmp(var_302) == 0) goto end_for_2;
                var_304 = wp::iter_next(var_302);
                // for k in range(AXES):                                                          <L 26>
                // tree__grouped[(i * AXES + k) * GROUP + lane] = INFINITY                        <L 27>
                var_306 = wp::mul(var_0, var_29);
                var_307 = wp::add(var_306, var_305);
                var_308 = wp::mul(var_307, var_1);
                var_309 = wp::add(var_308, var_304);
                wp::array_store(var_tree__grouped, var_309, var_11);
                var_311 = wp::mul(var_0, var_29);
                var_312 = wp::add(var_311, var_310);
                var_313 = wp::mul(var_312, var_1);
                var_314 = wp::add(var_313, var_304);
                wp::array_store(var_tree__grouped, var_314, var_11);
                var_316 = wp::mul(var_0, var_29);
                var_317 = wp::add(var_316, var_315);
                var_318 = wp::mul(var_317, var_1);
                var_319 = wp::add(var_318, var_304);
                wp::array_store(var_tree__grouped, var_319, var_11);
                var_321 = wp::mul(var_0, var_29);
                var_322 = wp::add(var_321, var_320);
                var_323 = wp::mul(var_322, var_1);
                var_324 = wp::add(var_323, var_304);
                wp::array_store(var_tree__grouped, var_324, var_11);
                var_326 = wp::mul(var_0, var_29);
                var_327 = wp::add(var_326, var_325);
                var_328 = wp::mul(var_327, var_1);
                var_329 = wp::add(var_328, var_304);
                wp::array_store(var_tree__grouped, var_329, var_11);
                var_331 = wp::mul(var_0, var_29);
                var_332 = wp::add(var_331, var_330);
                var_333 = wp::mul(var_332, var_1);
                var_334 = wp::add(var_333, var_304);
                wp::array_store(var_tree__grouped, var_334, var_11);
                var_336 = wp::mul(var_0, var_29);
                var_337 = wp::add(var_336, var_335);
                var_338 = wp::mul(var_337, var_1);
                var_339 = wp::add(var_338, var_304);
                wp::array_store(var_tree__grouped, var_339, var_11);
                var_341 = wp::mul(var_0, var_29);
                var_342 = wp::add(var_341, var_340);
                var_343 = wp::mul(var_342, var_1);
                var_344 = wp::add(var_343, var_304);
                wp::array_store(var_tree__grouped, var_344, var_11);
                var_346 = wp::mul(var_0, var_29);
                var_347 = wp::add(var_346, var_345);
                var_348 = wp::mul(var_347, var_1);
                var_349 = wp::add(var_348, var_304);
                wp::array_store(var_tree__grouped, var_349, var_11);
                var_351 = wp::mul(var_0, var_29);
                var_352 = wp::add(var_351, var_350);
                var_353 = wp::mul(var_352, var_1);
                var_354 = wp::add(var_353, var_304);
                wp::array_store(var_tree__grouped, var_354, var_11);
                var_356 = wp::mul(var_0, var_29);
                var_357 = wp::add(var_356, var_355);
                var_358 = wp::mul(var_357, var_1);
                var_359 = wp::add(var_358, var_304);
                wp::array_store(var_tree__grouped, var_359, var_11);
                var_361 = wp::mul(var_0, var_29);
                var_362 = wp::add(var_361, var_360);
                var_363 = wp::mul(var_362, var_1);
                var_364 = wp::add(var_363, var_304);
                wp::array_store(var_tree__grouped, var_364, var_11);
                var_366 = wp::mul(var_0, var_29);
                var_367 = wp::add(var_366, var_365);
                var_368 = wp::mul(var_367, var_1);
                var_369 = wp::add(var_368, var_304);
                wp::array_store(var_tree__grouped, var_369, var_11);
                var_371 = wp::mul(var_0, var_29);
                var_372 = wp::add(var_371, var_370);
                var_373 = wp::mul(var_372, var_1);
                var_374 = wp::add(var_373, var_304);
                wp::array_store(var_tree__grouped, var_374, var_11);
                var_376 = wp::mul(var_0, var_29);
                var_377 = wp::add(var_376, var_375);
                var_378 = wp::mul(var_377, var_1);
                var_379 = wp::add(var_378, var_304);
                wp::array_store(var_tree__grouped, var_379, var_11);
                var_381 = wp::mul(var_0, var_29);
                var_382 = wp::add(var_381, var_380);
                var_383 = wp::mul(var_382, var_1);
                var_384 = wp::add(var_383, var_304);
                wp::array_store(var_tree__grouped, var_384, var_11);
                wp::assign(var_303, var_380);
                goto start_for_2;
            end_for_2:;
        }
        var_385 = wp::where(var_300, var_304, var_18);
        var_386 = wp::where(var_300, var_303, var_288);
        // if size > 0:                                                                           <L 28>
        var_388 = (var_10 > var_387);
        if (var_388) {
            // equal = is_one_row(first, first + size, tree__width, tree__packed)                 <L 29>
            var_389 = wp::add(var_2, var_10);
            var_390 = is_one_row_0(var_2, var_389, var_tree__width, var_tree__packed);
            // if equal == 1 and i > 0:                                                           <L 30>
            var_393 = (var_390 == var_392);
            var_391 = var_393;
            if (var_391) {
                var_395 = (var_0 > var_394);
                var_391 = var_391 && var_395;
            }
            if (var_391) {
                // equal += is_one_row(first - GROUP, first + size, tree__width, tree__packed)       <L 31>
                var_396 = wp::sub(var_2, var_1);
                var_397 = wp::add(var_2, var_10);
                var_398 = is_one_row_0(var_396, var_397, var_tree__width, var_tree__packed);
                var_399 = wp::add(var_390, var_398);
            }
            var_400 = wp::where(var_391, var_399, var_390);
            // tree__alike[i] = equal                                                             <L 32>
            wp::array_store(var_tree__alike, var_0, var_400);
            // atomic_max(tree__extent, 0, longest)                                               <L 33>
            var_402 = wp::atomic_max(var_tree__extent, var_401, var_16);
        }
}



extern "C" __global__ void project_rows_kernel_eac47386_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_source__features,
    wp::array_t<wp::int32> var_source__rows,
    wp::array_t<wp::float64> var_basis,
    wp::array_t<wp::float32> var_coordinates)
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
        wp::float64 var_4;
        wp::vec_t<15, wp::float64> var_5;
        wp::float64 var_6;
        wp::shape_t* var_7;
        const wp::int32 var_8 = 1;
        wp::int32 var_9;
        wp::shape_t var_10;
        wp::range_t var_11;
        wp::int32 var_12;
        wp::float32* var_13;
        wp::float64 var_14;
        wp::float32 var_15;
        const wp::int32 var_16 = 0;
        wp::float64* var_17;
        wp::float64 var_18;
        wp::float64 var_19;
        wp::float64 var_20;
        wp::float64 var_21;
        const wp::int32 var_22 = 0;
        const wp::int32 var_23 = 1;
        wp::int32 var_24;
        wp::float64* var_25;
        wp::float64 var_26;
        wp::float64 var_27;
        const wp::int32 var_28 = 1;
        const wp::int32 var_29 = 1;
        wp::int32 var_30;
        wp::float64* var_31;
        wp::float64 var_32;
        wp::float64 var_33;
        const wp::int32 var_34 = 2;
        const wp::int32 var_35 = 1;
        wp::int32 var_36;
        wp::float64* var_37;
        wp::float64 var_38;
        wp::float64 var_39;
        const wp::int32 var_40 = 3;
        const wp::int32 var_41 = 1;
        wp::int32 var_42;
        wp::float64* var_43;
        wp::float64 var_44;
        wp::float64 var_45;
        const wp::int32 var_46 = 4;
        const wp::int32 var_47 = 1;
        wp::int32 var_48;
        wp::float64* var_49;
        wp::float64 var_50;
        wp::float64 var_51;
        const wp::int32 var_52 = 5;
        const wp::int32 var_53 = 1;
        wp::int32 var_54;
        wp::float64* var_55;
        wp::float64 var_56;
        wp::float64 var_57;
        const wp::int32 var_58 = 6;
        const wp::int32 var_59 = 1;
        wp::int32 var_60;
        wp::float64* var_61;
        wp::float64 var_62;
        wp::float64 var_63;
        const wp::int32 var_64 = 7;
        const wp::int32 var_65 = 1;
        wp::int32 var_66;
        wp::float64* var_67;
        wp::float64 var_68;
        wp::float64 var_69;
        const wp::int32 var_70 = 8;
        const wp::int32 var_71 = 1;
        wp::int32 var_72;
        wp::float64* var_73;
        wp::float64 var_74;
        wp::float64 var_75;
        const wp::int32 var_76 = 9;
        const wp::int32 var_77 = 1;
        wp::int32 var_78;
        wp::float64* var_79;
        wp::float64 var_80;
        wp::float64 var_81;
        const wp::int32 var_82 = 10;
        const wp::int32 var_83 = 1;
        wp::int32 var_84;
        wp::float64* var_85;
        wp::float64 var_86;
        wp::float64 var_87;
        const wp::int32 var_88 = 11;
        const wp::int32 var_89 = 1;
        wp::int32 var_90;
        wp::float64* var_91;
        wp::float64 var_92;
        wp::float64 var_93;
        const wp::int32 var_94 = 12;
        const wp::int32 var_95 = 1;
        wp::int32 var_96;
        wp::float64* var_97;
        wp::float64 var_98;
        wp::float64 var_99;
        const wp::int32 var_100 = 13;
        const wp::int32 var_101 = 1;
        wp::int32 var_102;
        wp::float64* var_103;
        wp::float64 var_104;
        wp::float64 var_105;
        const wp::int32 var_106 = 14;
        const wp::int32 var_107 = 1;
        wp::int32 var_108;
        wp::float64* var_109;
        wp::float64 var_110;
        wp::float64 var_111;
        const wp::int32 var_112 = 0;
        wp::float64 var_113;
        wp::float64 var_114;
        wp::float64 var_115;
        wp::float64 var_116;
        wp::float64 var_117;
        wp::float32 var_118;
        const wp::int32 var_119 = 1;
        wp::float64 var_120;
        wp::float64 var_121;
        wp::float64 var_122;
        wp::float64 var_123;
        wp::float64 var_124;
        wp::float32 var_125;
        const wp::int32 var_126 = 2;
        wp::float64 var_127;
        wp::float64 var_128;
        wp::float64 var_129;
        wp::float64 var_130;
        wp::float64 var_131;
        wp::float32 var_132;
        const wp::int32 var_133 = 3;
        wp::float64 var_134;
        wp::float64 var_135;
        wp::float64 var_136;
        wp::float64 var_137;
        wp::float64 var_138;
        wp::float32 var_139;
        const wp::int32 var_140 = 4;
        wp::float64 var_141;
        wp::float64 var_142;
        wp::float64 var_143;
        wp::float64 var_144;
        wp::float64 var_145;
        wp::float32 var_146;
        const wp::int32 var_147 = 5;
        wp::float64 var_148;
        wp::float64 var_149;
        wp::float64 var_150;
        wp::float64 var_151;
        wp::float64 var_152;
        wp::float32 var_153;
        const wp::int32 var_154 = 6;
        wp::float64 var_155;
        wp::float64 var_156;
        wp::float64 var_157;
        wp::float64 var_158;
        wp::float64 var_159;
        wp::float32 var_160;
        const wp::int32 var_161 = 7;
        wp::float64 var_162;
        wp::float64 var_163;
        wp::float64 var_164;
        wp::float64 var_165;
        wp::float64 var_166;
        wp::float32 var_167;
        const wp::int32 var_168 = 8;
        wp::float64 var_169;
        wp::float64 var_170;
        wp::float64 var_171;
        wp::float64 var_172;
        wp::float64 var_173;
        wp::float32 var_174;
        const wp::int32 var_175 = 9;
        wp::float64 var_176;
        wp::float64 var_177;
        wp::float64 var_178;
        wp::float64 var_179;
        wp::float64 var_180;
        wp::float32 var_181;
        const wp::int32 var_182 = 10;
        wp::float64 var_183;
        wp::float64 var_184;
        wp::float64 var_185;
        wp::float64 var_186;
        wp::float64 var_187;
        wp::float32 var_188;
        const wp::int32 var_189 = 11;
        wp::float64 var_190;
        wp::float64 var_191;
        wp::float64 var_192;
        wp::float64 var_193;
        wp::float64 var_194;
        wp::float32 var_195;
        const wp::int32 var_196 = 12;
        wp::float64 var_197;
        wp::float64 var_198;
        wp::float64 var_199;
        wp::float64 var_200;
        wp::float64 var_201;
        wp::float32 var_202;
        const wp::int32 var_203 = 13;
        wp::float64 var_204;
        wp::float64 var_205;
        wp::float64 var_206;
        wp::float64 var_207;
        wp::float64 var_208;
        wp::float32 var_209;
        const wp::int32 var_210 = 14;
        wp::float64 var_211;
        wp::float64 var_212;
        wp::float64 var_213;
        wp::float64 var_214;
        wp::float64 var_215;
        wp::float32 var_216;
        wp::float64 var_217;
        wp::float64 var_218;
        wp::float64 var_219;
        wp::float32 var_220;
        const wp::int32 var_221 = 15;
        //---------
        // forward
        // def project_rows_kernel(source__features, source__rows, basis, coordinates):           <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // row = source__rows[i]                                                                  <L 4>
        var_1 = wp::address(var_source__rows, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // along = leading(float64(0.0))                                                          <L 5>
        var_4 = 0.0;
        var_5 = wp::vec_t<15, wp::float64>(var_4);
        // left = float64(0.0)                                                                    <L 6>
        var_6 = 0.0;
        // for c in range(source__features.shape[1]):                                             <L 7>
        var_7 = &(var_source__features.shape);
        var_10 = wp::load(var_7);
        var_9 = wp::extract(var_10, var_8);
        var_11 = wp::range(var_9);
        start_for_0:;
            if (iter_cmp(var_11) == 0) goto end_for_0;
            var_12 = wp::iter_next(var_11);
            // x = float64(source__features[row, c]) - basis[c, 0]                                <L 8>
            var_13 = wp::address(var_source__features, var_2, var_12);
            var_15 = wp::load(var_13);
            var_14 = wp::float64(var_15);
            var_17 = wp::address(var_basis, var_12, var_16);
            var_19 = wp::load(var_17);
            var_18 = wp::sub(var_14, var_19);
            // left += x * x                                                                      <L 9>
            var_20 = wp::mul(var_18, var_18);
            var_21 = wp::add(var_6, var_20);
            // for k in range(LEADING):                                                           <L 10>
            // along[k] += x * basis[c, 1 + k]                                                    <L 11>
            var_24 = wp::add(var_23, var_22);
            var_25 = wp::address(var_basis, var_12, var_24);
            var_27 = wp::load(var_25);
            var_26 = wp::mul(var_18, var_27);
            wp::add_inplace(var_5, var_22, var_26);
            var_30 = wp::add(var_29, var_28);
            var_31 = wp::address(var_basis, var_12, var_30);
            var_33 = wp::load(var_31);
            var_32 = wp::mul(var_18, var_33);
            wp::add_inplace(var_5, var_28, var_32);
            var_36 = wp::add(var_35, var_34);
            var_37 = wp::address(var_basis, var_12, var_36);
            var_39 = wp::load(var_37);
            var_38 = wp::mul(var_18, var_39);
            wp::add_inplace(var_5, var_34, var_38);
            var_42 = wp::add(var_41, var_40);
            var_43 = wp::address(var_basis, var_12, var_42);
            var_45 = wp::load(var_43);
            var_44 = wp::mul(var_18, var_45);
            wp::add_inplace(var_5, var_40, var_44);
            var_48 = wp::add(var_47, var_46);
            var_49 = wp::address(var_basis, var_12, var_48);
            var_51 = wp::load(var_49);
            var_50 = wp::mul(var_18, var_51);
            wp::add_inplace(var_5, var_46, var_50);
            var_54 = wp::add(var_53, var_52);
            var_55 = wp::address(var_basis, var_12, var_54);
            var_57 = wp::load(var_55);
            var_56 = wp::mul(var_18, var_57);
            wp::add_inplace(var_5, var_52, var_56);
            var_60 = wp::add(var_59, var_58);
            var_61 = wp::address(var_basis, var_12, var_60);
            var_63 = wp::load(var_61);
            var_62 = wp::mul(var_18, var_63);
            wp::add_inplace(var_5, var_58, var_62);
            var_66 = wp::add(var_65, var_64);
            var_67 = wp::address(var_basis, var_12, var_66);
            var_69 = wp::load(var_67);
            var_68 = wp::mul(var_18, var_69);
            wp::add_inplace(var_5, var_64, var_68);
            var_72 = wp::add(var_71, var_70);
            var_73 = wp::address(var_basis, var_12, var_72);
            var_75 = wp::load(var_73);
            var_74 = wp::mul(var_18, var_75);
            wp::add_inplace(var_5, var_70, var_74);
            var_78 = wp::add(var_77, var_76);
            var_79 = wp::address(var_basis, var_12, var_78);
            var_81 = wp::load(var_79);
            var_80 = wp::mul(var_18, var_81);
            wp::add_inplace(var_5, var_76, var_80);
            var_84 = wp::add(var_83, var_82);
            var_85 = wp::address(var_basis, var_12, var_84);
            var_87 = wp::load(var_85);
            var_86 = wp::mul(var_18, var_87);
            wp::add_inplace(var_5, var_82, var_86);
            var_90 = wp::add(var_89, var_88);
            var_91 = wp::address(var_basis, var_12, var_90);
            var_93 = wp::load(var_91);
            var_92 = wp::mul(var_18, var_93);
            wp::add_inplace(var_5, var_88, var_92);
            var_96 = wp::add(var_95, var_94);
            var_97 = wp::address(var_basis, var_12, var_96);
            var_99 = wp::load(var_97);
            var_98 = wp::mul(var_18, var_99);
            wp::add_inplace(var_5, var_94, var_98);
            var_102 = wp::add(var_101, var_100);
            var_103 = wp::address(var_basis, var_12, var_102);
            var_105 = wp::load(var_103);
            var_104 = wp::mul(var_18, var_105);
            wp::add_inplace(var_5, var_100, var_104);
            var_108 = wp::add(var_107, var_106);
            var_109 = wp::address(var_basis, var_12, var_108);
            var_111 = wp::load(var_109);
            var_110 = wp::mul(var_18, var_111);
            wp::add_inplace(var_5, var_106, var_110);
            wp::assign(var_6, var_21);
            goto start_for_0;
        end_for_0:;
        // for k in range(LEADING):                                                               <L 12>
        // left -= along[k] * along[k]                                                            <L 13>
        var_113 = wp::extract(var_5, var_112);
        var_114 = wp::extract(var_5, var_112);
        var_115 = wp::mul(var_113, var_114);
        var_116 = wp::sub(var_6, var_115);
        // coordinates[i, k] = float32(along[k])                                                  <L 14>
        var_117 = wp::extract(var_5, var_112);
        var_118 = wp::float32(var_117);
        wp::array_store(var_coordinates, var_0, var_112, var_118);
        // left -= along[k] * along[k]                                                            <L 13>
        var_120 = wp::extract(var_5, var_119);
        var_121 = wp::extract(var_5, var_119);
        var_122 = wp::mul(var_120, var_121);
        var_123 = wp::sub(var_116, var_122);
        // coordinates[i, k] = float32(along[k])                                                  <L 14>
        var_124 = wp::extract(var_5, var_119);
        var_125 = wp::float32(var_124);
        wp::array_store(var_coordinates, var_0, var_119, var_125);
        // left -= along[k] * along[k]                                                            <L 13>
        var_127 = wp::extract(var_5, var_126);
        var_128 = wp::extract(var_5, var_126);
        var_129 = wp::mul(var_127, var_128);
        var_130 = wp::sub(var_123, var_129);
        // coordinates[i, k] = float32(along[k])                                                  <L 14>
        var_131 = wp::extract(var_5, var_126);
        var_132 = wp::float32(var_131);
        wp::array_store(var_coordinates, var_0, var_126, var_132);
        // left -= along[k] * along[k]                                                            <L 13>
        var_134 = wp::extract(var_5, var_133);
        var_135 = wp::extract(var_5, var_133);
        var_136 = wp::mul(var_134, var_135);
        var_137 = wp::sub(var_130, var_136);
        // coordinates[i, k] = float32(along[k])                                                  <L 14>
        var_138 = wp::extract(var_5, var_133);
        var_139 = wp::float32(var_138);
        wp::array_store(var_coordinates, var_0, var_133, var_139);
        // left -= along[k] * along[k]                                                            <L 13>
        var_141 = wp::extract(var_5, var_140);
        var_142 = wp::extract(var_5, var_140);
        var_143 = wp::mul(var_141, var_142);
        var_144 = wp::sub(var_137, var_143);
        // coordinates[i, k] = float32(along[k])                                                  <L 14>
        var_145 = wp::extract(var_5, var_140);
        var_146 = wp::float32(var_145);
        wp::array_store(var_coordinates, var_0, var_140, var_146);
        // left -= along[k] * along[k]                                                            <L 13>
        var_148 = wp::extract(var_5, var_147);
        var_149 = wp::extract(var_5, var_147);
        var_150 = wp::mul(var_148, var_149);
        var_151 = wp::sub(var_144, var_150);
        // coordinates[i, k] = float32(along[k])                                                  <L 14>
        var_152 = wp::extract(var_5, var_147);
        var_153 = wp::float32(var_152);
        wp::array_store(var_coordinates, var_0, var_147, var_153);
        // left -= along[k] * along[k]                                                            <L 13>
        var_155 = wp::extract(var_5, var_154);
        var_156 = wp::extract(var_5, var_154);
        var_157 = wp::mul(var_155, var_156);
        var_158 = wp::sub(var_151, var_157);
        // coordinates[i, k] = float32(along[k])                                                  <L 14>
        var_159 = wp::extract(var_5, var_154);
        var_160 = wp::float32(var_159);
        wp::array_store(var_coordinates, var_0, var_154, var_160);
        // left -= along[k] * along[k]                                                            <L 13>
        var_162 = wp::extract(var_5, var_161);
        var_163 = wp::extract(var_5, var_161);
        var_164 = wp::mul(var_162, var_163);
        var_165 = wp::sub(var_158, var_164);
        // coordinates[i, k] = float32(along[k])                                                  <L 14>
        var_166 = wp::extract(var_5, var_161);
        var_167 = wp::float32(var_166);
        wp::array_store(var_coordinates, var_0, var_161, var_167);
        // left -= along[k] * along[k]                                                            <L 13>
        var_169 = wp::extract(var_5, var_168);
        var_170 = wp::extract(var_5, var_168);
        var_171 = wp::mul(var_169, var_170);
        var_172 = wp::sub(var_165, var_171);
        // coordinates[i, k] = float32(along[k])                                                  <L 14>
        var_173 = wp::extract(var_5, var_168);
        var_174 = wp::float32(var_173);
        wp::array_store(var_coordinates, var_0, var_168, var_174);
        // left -= along[k] * along[k]                                                            <L 13>
        var_176 = wp::extract(var_5, var_175);
        var_177 = wp::extract(var_5, var_175);
        var_178 = wp::mul(var_176, var_177);
        var_179 = wp::sub(var_172, var_178);
        // coordinates[i, k] = float32(along[k])                                                  <L 14>
        var_180 = wp::extract(var_5, var_175);
        var_181 = wp::float32(var_180);
        wp::array_store(var_coordinates, var_0, var_175, var_181);
        // left -= along[k] * along[k]                                                            <L 13>
        var_183 = wp::extract(var_5, var_182);
        var_184 = wp::extract(var_5, var_182);
        var_185 = wp::mul(var_183, var_184);
        var_186 = wp::sub(var_179, var_185);
        // coordinates[i, k] = float32(along[k])                                                  <L 14>
        var_187 = wp::extract(var_5, var_182);
        var_188 = wp::float32(var_187);
        wp::array_store(var_coordinates, var_0, var_182, var_188);
        // left -= along[k] * along[k]                                                            <L 13>
        var_190 = wp::extract(var_5, var_189);
        var_191 = wp::extract(var_5, var_189);
        var_192 = wp::mul(var_190, var_191);
        var_193 = wp::sub(var_186, var_192);
        // coordinates[i, k] = float32(along[k])                                                  <L 14>
        var_194 = wp::extract(var_5, var_189);
        var_195 = wp::float32(var_194);
        wp::array_store(var_coordinates, var_0, var_189, var_195);
        // left -= along[k] * along[k]                                                            <L 13>
        var_197 = wp::extract(var_5, var_196);
        var_198 = wp::extract(var_5, var_196);
        var_199 = wp::mul(var_197, var_198);
        var_200 = wp::sub(var_193, var_199);
        // coordinates[i, k] = float32(along[k])                                                  <L 14>
        var_201 = wp::extract(var_5, var_196);
        var_202 = wp::float32(var_201);
        wp::array_store(var_coordinates, var_0, var_196, var_202);
        // left -= along[k] * along[k]                                                            <L 13>
        var_204 = wp::extract(var_5, var_203);
        var_205 = wp::extract(var_5, var_203);
        var_206 = wp::mul(var_204, var_205);
        var_207 = wp::sub(var_200, var_206);
        // coordinates[i, k] = float32(along[k])                                                  <L 14>
        var_208 = wp::extract(var_5, var_203);
        var_209 = wp::float32(var_208);
        wp::array_store(var_coordinates, var_0, var_203, var_209);
        // left -= along[k] * along[k]                                                            <L 13>
        var_211 = wp::extract(var_5, var_210);
        var_212 = wp::extract(var_5, var_210);
        var_213 = wp::mul(var_211, var_212);
        var_214 = wp::sub(var_207, var_213);
        // coordinates[i, k] = float32(along[k])                                                  <L 14>
        var_215 = wp::extract(var_5, var_210);
        var_216 = wp::float32(var_215);
        wp::array_store(var_coordinates, var_0, var_210, var_216);
        // coordinates[i, LEADING] = float32(sqrt(max(left, float64(0.0))))                       <L 15>
        var_217 = 0.0;
        var_218 = wp::max(var_214, var_217);
        var_219 = wp::sqrt(var_218);
        var_220 = wp::float32(var_219);
        wp::array_store(var_coordinates, var_0, var_221, var_220);
}


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


// <pointloom.kernels.arrays.duplicates.coordinate_bits>:1
static CUDA_CALLABLE wp::int64 coordinate_bits_0(
    wp::float32 var_x)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int64 var_1;
    wp::int64 var_2;
    wp::int64 var_3;
    wp::int64 var_4;
    bool var_5;
    wp::int64 var_6;
    wp::int64 var_7;
    //---------
    // forward
    // def coordinate_bits(x):                                                                <L 1>
    // bits = int64(float_bits(x)) & int64(LOW_WORD)                                          <L 3>
    var_0 = _float_bits_0(var_x);
    var_1 = wp::int64(var_0);
    var_2 = 4294967295ll;
    var_3 = wp::bit_and(var_1, var_2);
    // return bits if bits != int64(MINUS_ZERO) else int64(0)                                 <L 4>
    var_4 = 2147483648ll;
    var_5 = (var_3 != var_4);
    if (var_5) {
    }
    if (!var_5) {
        var_6 = 0ll;
    }
    var_7 = wp::where(var_5, var_3, var_6);
    return var_7;
}


// <pointloom.kernels.arrays.duplicates.same_point>:1
static CUDA_CALLABLE wp::int32 same_point_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> var_q)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    const wp::int32 var_2 = 0;
    wp::float32 var_3;
    wp::int64 var_4;
    wp::float32 var_5;
    wp::int64 var_6;
    bool var_7;
    const wp::int32 var_8 = 1;
    wp::int32 var_9;
    const wp::int32 var_10 = 1;
    wp::float32 var_11;
    wp::int64 var_12;
    wp::float32 var_13;
    wp::int64 var_14;
    bool var_15;
    const wp::int32 var_16 = 1;
    wp::int32 var_17;
    const wp::int32 var_18 = 2;
    wp::float32 var_19;
    wp::int64 var_20;
    wp::float32 var_21;
    wp::int64 var_22;
    bool var_23;
    const wp::int32 var_24 = 1;
    wp::int32 var_25;
    const wp::int32 var_26 = 1;
    wp::int32 var_27;
    //---------
    // forward
    // def same_point(p, q):                                                                  <L 1>
    // differing = int(0)                                                                     <L 2>
    var_1 = wp::int(var_0);
    // for axis in range(3):                                                                  <L 3>
    // if coordinate_bits(p[axis]) != coordinate_bits(q[axis]):                               <L 4>
    var_3 = wp::extract(var_p, var_2);
    var_4 = coordinate_bits_0(var_3);
    var_5 = wp::extract(var_q, var_2);
    var_6 = coordinate_bits_0(var_5);
    var_7 = (var_4 != var_6);
    if (var_7) {
        // differing = 1                                                                      <L 5>
    }
    var_9 = wp::where(var_7, var_8, var_1);
    // if coordinate_bits(p[axis]) != coordinate_bits(q[axis]):                               <L 4>
    var_11 = wp::extract(var_p, var_10);
    var_12 = coordinate_bits_0(var_11);
    var_13 = wp::extract(var_q, var_10);
    var_14 = coordinate_bits_0(var_13);
    var_15 = (var_12 != var_14);
    if (var_15) {
        // differing = 1                                                                      <L 5>
    }
    var_17 = wp::where(var_15, var_16, var_9);
    // if coordinate_bits(p[axis]) != coordinate_bits(q[axis]):                               <L 4>
    var_19 = wp::extract(var_p, var_18);
    var_20 = coordinate_bits_0(var_19);
    var_21 = wp::extract(var_q, var_18);
    var_22 = coordinate_bits_0(var_21);
    var_23 = (var_20 != var_22);
    if (var_23) {
        // differing = 1                                                                      <L 5>
    }
    var_25 = wp::where(var_23, var_24, var_17);
    // return 1 - differing                                                                   <L 6>
    var_27 = wp::sub(var_26, var_25);
    return var_27;
}


// <pointloom.kernels.search.point_tree.copies_after>:1
static CUDA_CALLABLE wp::int32 copies_after_0(
    wp::int32 var_i,
    wp::int32 var_tree__count,
    wp::array_t<wp::vec_t<3, wp::float32>> var_tree__points)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float32>* var_0;
    wp::vec_t<3, wp::float32> var_1;
    wp::vec_t<3, wp::float32> var_2;
    const wp::int32 var_3 = 0;
    wp::int32 var_4;
    const wp::int32 var_5 = 1;
    wp::int32 var_6;
    const wp::int32 var_7 = 5;
    wp::int32 var_8;
    wp::int32 var_9;
    wp::range_t var_10;
    wp::int32 var_11;
    wp::vec_t<3, wp::float32>* var_12;
    const wp::int32 var_13 = 0;
    wp::float32 var_14;
    wp::vec_t<3, wp::float32> var_15;
    const wp::int32 var_16 = 0;
    wp::float32 var_17;
    bool var_18;
    wp::vec_t<3, wp::float32>* var_19;
    wp::int32 var_20;
    wp::vec_t<3, wp::float32> var_21;
    wp::int32 var_22;
    wp::int32 var_23;
    //---------
    // forward
    // def copies_after(i, tree__count, tree__points):                                        <L 1>
    // p = tree__points[i]                                                                    <L 3>
    var_0 = wp::address(var_tree__points, var_i);
    var_2 = wp::load(var_0);
    var_1 = wp::copy(var_2);
    // copies = int(0)                                                                        <L 4>
    var_4 = wp::int(var_3);
    // for j in range(i + 1, min(i + WINDOW, tree__count)):                                   <L 5>
    var_6 = wp::add(var_i, var_5);
    var_8 = wp::add(var_i, var_7);
    var_9 = wp::min(var_8, var_tree__count);
    var_10 = wp::range(var_6, var_9);
    start_for_0:;
        if (iter_cmp(var_10) == 0) goto end_for_0;
        var_11 = wp::iter_next(var_10);
        // if tree__points[j][0] == p[0]:                                                     <L 6>
        var_12 = wp::address(var_tree__points, var_11);
        var_15 = wp::load(var_12);
        var_14 = wp::extract(var_15, var_13);
        var_17 = wp::extract(var_1, var_16);
        var_18 = (var_14 == var_17);
        if (var_18) {
            // copies += same_point(p, tree__points[j])                                       <L 7>
            var_19 = wp::address(var_tree__points, var_11);
            var_21 = wp::load(var_19);
            var_20 = same_point_0(var_1, var_21);
            var_22 = wp::add(var_4, var_20);
        }
        var_23 = wp::where(var_18, var_22, var_4);
        wp::assign(var_4, var_23);
        goto start_for_0;
    end_for_0:;
    // return copies                                                                          <L 8>
    return var_4;
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:143
static CUDA_CALLABLE void adj__float_bits_0(
    wp::float32 var_x,
    wp::float32 & adj_x,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.arrays.duplicates.coordinate_bits>:1
static CUDA_CALLABLE void adj_coordinate_bits_0(
    wp::float32 var_x,
    wp::float32 & adj_x,
    wp::int64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.arrays.duplicates.same_point>:1
static CUDA_CALLABLE void adj_same_point_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> var_q,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float32> & adj_q,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.point_tree.copies_after>:1
static CUDA_CALLABLE void adj_copies_after_0(
    wp::int32 var_i,
    wp::int32 var_tree__count,
    wp::array_t<wp::vec_t<3, wp::float32>> var_tree__points,
    wp::int32 & adj_i,
    wp::int32 & adj_tree__count,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_tree__points,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void find_most_copies_kernel_117eb98b_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_counts,
    wp::array_t<wp::int32> var_most)
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
        const wp::int32 var_2 = 0;
        wp::int32* var_3;
        bool var_4;
        wp::int32 var_5;
        wp::int32 var_6;
        const wp::int32 var_7 = 0;
        wp::int32* var_8;
        wp::int32 var_9;
        wp::int32 var_10;
        //---------
        // forward
        // def find_most_copies_kernel(counts: array(dtype=int32), most: array(dtype=int32)):       <L 46>
        // i = tid()                                                                              <L 47>
        var_0 = builtin_tid1d();
        // if counts[i] > most[0]:                                                                <L 48>
        var_1 = wp::address(var_counts, var_0);
        var_3 = wp::address(var_most, var_2);
        var_5 = wp::load(var_1);
        var_6 = wp::load(var_3);
        var_4 = (var_5 > var_6);
        if (var_4) {
            // atomic_max(most, 0, counts[i])  # the order does not matter                        <L 49>
            var_8 = wp::address(var_counts, var_0);
            var_10 = wp::load(var_8);
            var_9 = wp::atomic_max(var_most, var_7, var_10);
        }
}



extern "C" __global__ void find_adjacent_copies_kernel_5af978fc_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::int32 var_tree__count,
    wp::array_t<wp::vec_t<3, wp::float32>> var_tree__points,
    wp::array_t<wp::int32> var_flag)
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
        const wp::int32 var_4 = 1;
        const wp::int32 var_5 = 0;
        //---------
        // forward
        // def find_adjacent_copies_kernel(tree__count, tree__points, flag):                      <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // if copies_after(i, tree__count, tree__points) > 0:                                     <L 4>
        var_1 = copies_after_0(var_0, var_tree__count, var_tree__points);
        var_3 = (var_1 > var_2);
        if (var_3) {
            // flag[0] = 1                                                                        <L 5>
            wp::array_store(var_flag, var_5, var_4);
        }
}



extern "C" __global__ void mask_heads_kernel_86d26bf2_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_firsts,
    wp::array_t<wp::uint8> var_mask,
    wp::array_t<wp::int32> var_ranks)
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
        bool var_2;
        wp::int32 var_3;
        const wp::int32 var_4 = 1;
        const wp::int32 var_5 = 0;
        wp::int32 var_6;
        wp::uint8 var_7;
        //---------
        // forward
        // def mask_heads_kernel(firsts: array(dtype=int32), mask: array(dtype=uint8), ranks: array(dtype=int32)):       <L 53>
        // i = tid()                                                                              <L 54>
        var_0 = builtin_tid1d();
        // is_first = 1 if firsts[i] == i else 0                                                  <L 55>
        var_1 = wp::address(var_firsts, var_0);
        var_3 = wp::load(var_1);
        var_2 = (var_3 == var_0);
        if (var_2) {
        }
        if (!var_2) {
        }
        var_6 = wp::where(var_2, var_4, var_5);
        // mask[i] = uint8(is_first)                                                              <L 56>
        var_7 = wp::uint8(var_6);
        wp::array_store(var_mask, var_0, var_7);
        // ranks[i] = is_first                                                                    <L 57>
        wp::array_store(var_ranks, var_0, var_6);
}



extern "C" __global__ void number_copies_kernel_ba2aa157_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_firsts,
    wp::array_t<wp::int32> var_ranks,
    wp::array_t<wp::int32> var_rows)
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
        const wp::int32 var_4 = 1;
        wp::int32 var_5;
        wp::int32 var_6;
        //---------
        // forward
        // def number_copies_kernel(firsts: array(dtype=int32), ranks: array(dtype=int32), rows: array(dtype=int32)):       <L 61>
        // i = tid()                                                                              <L 63>
        var_0 = builtin_tid1d();
        // rows[i] = ranks[firsts[i]] - 1                                                         <L 64>
        var_1 = wp::address(var_firsts, var_0);
        var_2 = wp::load(var_1);
        var_3 = wp::address(var_ranks, var_2);
        var_6 = wp::load(var_3);
        var_5 = wp::sub(var_6, var_4);
        wp::array_store(var_rows, var_0, var_5);
}



extern "C" __global__ void count_copies_kernel_d7413bc9_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::array_t<wp::int32> var_firsts,
    wp::array_t<wp::int32> var_counts)
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
        bool var_4;
        wp::int32* var_5;
        const wp::int32 var_6 = 1;
        wp::int32 var_7;
        wp::int32 var_8;
        //---------
        // forward
        // def count_copies_kernel(points: array(dtype=vec3), firsts: array(dtype=int32), counts: array(dtype=int32)):       <L 38>
        // i = tid()                                                                              <L 39>
        var_0 = builtin_tid1d();
        // p = points[i]                                                                          <L 40>
        var_1 = wp::address(var_points, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // if isfinite(p):                                                                        <L 41>
        var_4 = wp::isfinite(var_2);
        if (var_4) {
            // atomic_add(counts, firsts[i], 1)  # integers: the order does not matter            <L 42>
            var_5 = wp::address(var_firsts, var_0);
            var_8 = wp::load(var_5);
            var_7 = wp::atomic_add(var_counts, var_8, var_6);
        }
}


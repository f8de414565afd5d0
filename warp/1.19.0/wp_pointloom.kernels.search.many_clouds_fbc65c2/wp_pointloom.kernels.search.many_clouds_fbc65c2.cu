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


// <pointloom.kernels.search.many_clouds.given_row>:1
static CUDA_CALLABLE wp::int32 given_row_0(
    wp::int32 var_i,
    wp::array_t<wp::int32> var_clouds__order,
    wp::array_t<wp::int32> var_clouds__owners,
    wp::array_t<wp::int32> var_clouds__starts)
{
    //---------
    // primal vars
    wp::int32* var_0;
    wp::int32 var_1;
    wp::int32 var_2;
    const wp::int32 var_3 = -1;
    wp::int32 var_4;
    const wp::int32 var_5 = 0;
    bool var_6;
    const wp::int32 var_7 = 64;
    wp::int32 var_8;
    wp::int32* var_9;
    wp::int32 var_10;
    wp::int32* var_11;
    wp::int32 var_12;
    wp::int32 var_13;
    wp::int32 var_14;
    //---------
    // forward
    // def given_row(i, clouds__order, clouds__owners, clouds__starts):                       <L 1>
    // row = clouds__order[i]                                                                 <L 3>
    var_0 = wp::address(var_clouds__order, var_i);
    var_2 = wp::load(var_0);
    var_1 = wp::copy(var_2);
    // at = int(-1)                                                                           <L 4>
    var_4 = wp::int(var_3);
    // if row >= 0:                                                                           <L 5>
    var_6 = (var_1 >= var_5);
    if (var_6) {
        // at = clouds__starts[clouds__owners[i // BUCKET]] + row                             <L 6>
        var_8 = wp::floordiv(var_i, var_7);
        var_9 = wp::address(var_clouds__owners, var_8);
        var_10 = wp::load(var_9);
        var_11 = wp::address(var_clouds__starts, var_10);
        var_13 = wp::load(var_11);
        var_12 = wp::add(var_13, var_1);
    }
    var_14 = wp::where(var_6, var_12, var_4);
    // return at                                                                              <L 7>
    return var_14;
}


// <pointloom.kernels.arrays.prefix_sum.find_owner>:1
static CUDA_CALLABLE wp::int32 find_owner_0(
    wp::array_t<wp::int32> var_offsets,
    wp::int32 var_i)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    wp::shape_t* var_2;
    const wp::int32 var_3 = 0;
    wp::int32 var_4;
    wp::shape_t var_5;
    const wp::int32 var_6 = 1;
    wp::int32 var_7;
    bool var_8;
    wp::int32 var_9;
    const wp::int32 var_10 = 2;
    wp::int32 var_11;
    wp::int32 var_12;
    const wp::int32 var_13 = 1;
    wp::int32 var_14;
    wp::int32* var_15;
    bool var_16;
    wp::int32 var_17;
    wp::int32 var_18;
    const wp::int32 var_19 = 1;
    wp::int32 var_20;
    wp::int32 var_21;
    wp::int32 var_22;
    //---------
    // forward
    // def find_owner(offsets, i):                                                            <L 1>
    // low = int(0)                                                                           <L 3>
    var_1 = wp::int(var_0);
    // high = offsets.shape[0] - 1                                                            <L 4>
    var_2 = &(var_offsets.shape);
    var_5 = wp::load(var_2);
    var_4 = wp::extract(var_5, var_3);
    var_7 = wp::sub(var_4, var_6);
    // while low < high:                                                                      <L 5>
    start_while_0:;
    var_8 = (var_1 < var_7);
    if ((var_8) == false) goto end_while_0;
        // middle = low + (high - low) // 2                                                   <L 6>
        var_9 = wp::sub(var_7, var_1);
        var_11 = wp::floordiv(var_9, var_10);
        var_12 = wp::add(var_1, var_11);
        // if offsets[middle + 1] > i:                                                        <L 7>
        var_14 = wp::add(var_12, var_13);
        var_15 = wp::address(var_offsets, var_14);
        var_17 = wp::load(var_15);
        var_16 = (var_17 > var_i);
        if (var_16) {
            // high = middle                                                                  <L 8>
            var_18 = wp::copy(var_12);
        }
        if (!var_16) {
            // low = middle + 1                                                               <L 10>
            var_20 = wp::add(var_12, var_19);
        }
        var_21 = wp::where(var_16, var_1, var_20);
        var_22 = wp::where(var_16, var_18, var_7);
        wp::assign(var_1, var_21);
        wp::assign(var_7, var_22);
    goto start_while_0;
    end_while_0:;
    // return low                                                                             <L 11>
    return var_1;
}


// <pointloom.kernels.search.many_clouds.given_row>:1
static CUDA_CALLABLE void adj_given_row_0(
    wp::int32 var_i,
    wp::array_t<wp::int32> var_clouds__order,
    wp::array_t<wp::int32> var_clouds__owners,
    wp::array_t<wp::int32> var_clouds__starts,
    wp::int32 & adj_i,
    wp::array_t<wp::int32> & adj_clouds__order,
    wp::array_t<wp::int32> & adj_clouds__owners,
    wp::array_t<wp::int32> & adj_clouds__starts,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.arrays.prefix_sum.find_owner>:1
static CUDA_CALLABLE void adj_find_owner_0(
    wp::array_t<wp::int32> var_offsets,
    wp::int32 var_i,
    wp::array_t<wp::int32> & adj_offsets,
    wp::int32 & adj_i,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void gather_points_kernel_4c95c713_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::array_t<wp::int32> var_sorted_rows,
    wp::array_t<wp::vec_t<3, wp::float32>> var_clouds__points,
    wp::array_t<wp::int32> var_clouds__order,
    wp::array_t<wp::int32> var_clouds__owners,
    wp::array_t<wp::int32> var_clouds__starts,
    wp::array_t<wp::int32> var_clouds__first_positions,
    wp::array_t<wp::int32> var_clouds__finite_counts)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        const wp::int32 var_1 = 64;
        wp::int32 var_2;
        wp::int32* var_3;
        wp::int32 var_4;
        wp::int32 var_5;
        wp::int32* var_6;
        wp::int32 var_7;
        wp::int32 var_8;
        const wp::int32 var_9 = -1;
        wp::int32 var_10;
        const wp::float32 var_11 = INFINITY;
        wp::vec_t<3, wp::float32> var_12;
        wp::int32* var_13;
        bool var_14;
        wp::int32 var_15;
        wp::int32* var_16;
        wp::int32 var_17;
        wp::int32 var_18;
        wp::int32* var_19;
        wp::int32 var_20;
        wp::int32 var_21;
        wp::int32* var_22;
        wp::int32 var_23;
        wp::int32 var_24;
        wp::vec_t<3, wp::float32>* var_25;
        wp::vec_t<3, wp::float32> var_26;
        wp::vec_t<3, wp::float32> var_27;
        wp::int32 var_28;
        wp::vec_t<3, wp::float32> var_29;
        //---------
        // forward
        // def gather_points_kernel(points, sorted_rows, clouds__points, clouds__order, clouds__owners, clouds__starts, clouds__first_positions, clouds__finite_counts):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // owner = clouds__owners[i // BUCKET]                                                    <L 4>
        var_2 = wp::floordiv(var_0, var_1);
        var_3 = wp::address(var_clouds__owners, var_2);
        var_5 = wp::load(var_3);
        var_4 = wp::copy(var_5);
        // rank = i - clouds__first_positions[owner]                                              <L 5>
        var_6 = wp::address(var_clouds__first_positions, var_4);
        var_8 = wp::load(var_6);
        var_7 = wp::sub(var_0, var_8);
        // row = int(-1)                                                                          <L 6>
        var_10 = wp::int(var_9);
        // p = vec3(INFINITY, INFINITY, INFINITY)                                                 <L 7>
        var_12 = wp::vec_t<3, wp::float32>(var_11, var_11, var_11);
        // if rank < clouds__finite_counts[owner]:                                                <L 8>
        var_13 = wp::address(var_clouds__finite_counts, var_4);
        var_15 = wp::load(var_13);
        var_14 = (var_7 < var_15);
        if (var_14) {
            // at = sorted_rows[clouds__starts[owner] + rank]                                     <L 9>
            var_16 = wp::address(var_clouds__starts, var_4);
            var_18 = wp::load(var_16);
            var_17 = wp::add(var_18, var_7);
            var_19 = wp::address(var_sorted_rows, var_17);
            var_21 = wp::load(var_19);
            var_20 = wp::copy(var_21);
            // row = at - clouds__starts[owner]                                                   <L 10>
            var_22 = wp::address(var_clouds__starts, var_4);
            var_24 = wp::load(var_22);
            var_23 = wp::sub(var_20, var_24);
            // p = points[at]                                                                     <L 11>
            var_25 = wp::address(var_points, var_20);
            var_27 = wp::load(var_25);
            var_26 = wp::copy(var_27);
        }
        var_28 = wp::where(var_14, var_23, var_10);
        var_29 = wp::where(var_14, var_26, var_12);
        // clouds__order[i] = row                                                                 <L 12>
        wp::array_store(var_clouds__order, var_0, var_28);
        // clouds__points[i] = p                                                                  <L 13>
        wp::array_store(var_clouds__points, var_0, var_29);
}



extern "C" __global__ void gather_codes_kernel_658adb0a_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int64> var_keys,
    wp::int32 var_bits,
    wp::array_t<wp::int32> var_clouds__owners,
    wp::array_t<wp::int32> var_clouds__starts,
    wp::array_t<wp::int32> var_clouds__first_positions,
    wp::array_t<wp::int64> var_clouds__codes)
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
        wp::int32* var_4;
        const wp::int32 var_5 = 64;
        wp::int32 var_6;
        wp::int32 var_7;
        wp::int32 var_8;
        wp::int32* var_9;
        wp::int32 var_10;
        wp::int32 var_11;
        wp::int64 var_12;
        const wp::int32 var_13 = 1;
        wp::int32 var_14;
        wp::int32* var_15;
        bool var_16;
        wp::int32 var_17;
        wp::int64* var_18;
        wp::int64 var_19;
        wp::int64 var_20;
        wp::int64 var_21;
        wp::int64 var_22;
        wp::int64 var_23;
        wp::int64 var_24;
        wp::int64 var_25;
        wp::int64 var_26;
        //---------
        // forward
        // def gather_codes_kernel(keys, bits, clouds__owners, clouds__starts, clouds__first_positions, clouds__codes):       <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // owner = clouds__owners[i]                                                              <L 3>
        var_1 = wp::address(var_clouds__owners, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // at = clouds__starts[owner] + i * BUCKET - clouds__first_positions[owner]               <L 4>
        var_4 = wp::address(var_clouds__starts, var_2);
        var_6 = wp::mul(var_0, var_5);
        var_8 = wp::load(var_4);
        var_7 = wp::add(var_8, var_6);
        var_9 = wp::address(var_clouds__first_positions, var_2);
        var_11 = wp::load(var_9);
        var_10 = wp::sub(var_7, var_11);
        // code = int64(0)                                                                        <L 5>
        var_12 = 0ll;
        // if at < clouds__starts[owner + 1]:                                                     <L 6>
        var_14 = wp::add(var_2, var_13);
        var_15 = wp::address(var_clouds__starts, var_14);
        var_17 = wp::load(var_15);
        var_16 = (var_10 < var_17);
        if (var_16) {
            // code = keys[at] & (int64(1) << int64(bits)) - int64(1)                             <L 7>
            var_18 = wp::address(var_keys, var_10);
            var_19 = 1ll;
            var_20 = wp::int64(var_bits);
            var_21 = wp::lshift(var_19, var_20);
            var_22 = 1ll;
            var_23 = wp::sub(var_21, var_22);
            var_25 = wp::load(var_18);
            var_24 = wp::bit_and(var_25, var_23);
        }
        var_26 = wp::where(var_16, var_24, var_12);
        // clouds__codes[i] = code                                                                <L 8>
        wp::array_store(var_clouds__codes, var_0, var_26);
}



extern "C" __global__ void gather_rows_kernel_83d21f74_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_values,
    wp::array_t<wp::int32> var_clouds__order,
    wp::array_t<wp::int32> var_clouds__owners,
    wp::array_t<wp::int32> var_clouds__starts,
    wp::array_t<wp::float32> var_gathered)
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
        wp::shape_t* var_2;
        const wp::int32 var_3 = 1;
        wp::int32 var_4;
        wp::shape_t var_5;
        wp::range_t var_6;
        wp::int32 var_7;
        const wp::float32 var_8 = 0.0;
        wp::float32 var_9;
        const wp::int32 var_10 = 0;
        bool var_11;
        wp::float32* var_12;
        wp::float32 var_13;
        wp::float32 var_14;
        wp::float32 var_15;
        //---------
        // forward
        // def gather_rows_kernel(values, clouds__order, clouds__owners, clouds__starts, gathered):       <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // row = given_row(i, clouds__order, clouds__owners, clouds__starts)                      <L 3>
        var_1 = given_row_0(var_0, var_clouds__order, var_clouds__owners, var_clouds__starts);
        // for column in range(gathered.shape[1]):                                                <L 4>
        var_2 = &(var_gathered.shape);
        var_5 = wp::load(var_2);
        var_4 = wp::extract(var_5, var_3);
        var_6 = wp::range(var_4);
        start_for_0:;
            if (iter_cmp(var_6) == 0) goto end_for_0;
            var_7 = wp::iter_next(var_6);
            // value = float(0.0)                                                                 <L 5>
            var_9 = wp::float(var_8);
            // if row >= 0:                                                                       <L 6>
            var_11 = (var_1 >= var_10);
            if (var_11) {
                // value = values[row, column]                                                    <L 7>
                var_12 = wp::address(var_values, var_1, var_7);
                var_14 = wp::load(var_12);
                var_13 = wp::copy(var_14);
            }
            var_15 = wp::where(var_11, var_13, var_9);
            // gathered[i, column] = value                                                        <L 8>
            wp::array_store(var_gathered, var_0, var_7, var_15);
            goto start_for_0;
        end_for_0:;
}



extern "C" __global__ void count_finite_kernel_85460447_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int64> var_keys,
    wp::array_t<wp::int32> var_starts,
    wp::int32 var_bits,
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
        wp::int64 var_1;
        wp::int64 var_2;
        wp::int64 var_3;
        wp::int64 var_4;
        const wp::int32 var_5 = 1;
        wp::int32 var_6;
        wp::int64 var_7;
        wp::int64 var_8;
        wp::int64 var_9;
        wp::int32* var_10;
        wp::int32 var_11;
        wp::int32 var_12;
        const wp::int32 var_13 = 1;
        wp::int32 var_14;
        wp::int32* var_15;
        wp::int32 var_16;
        wp::int32 var_17;
        bool var_18;
        wp::int32 var_19;
        const wp::int32 var_20 = 2;
        wp::int32 var_21;
        wp::int64* var_22;
        bool var_23;
        wp::int64 var_24;
        const wp::int32 var_25 = 1;
        wp::int32 var_26;
        wp::int32 var_27;
        wp::int32 var_28;
        wp::int32 var_29;
        wp::int32* var_30;
        wp::int32 var_31;
        wp::int32 var_32;
        //---------
        // forward
        // def count_finite_kernel(keys, starts, bits, counts):                                   <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // limit = int64(i) << int64(bits) | int64(1) << int64(bits - 1)                          <L 4>
        var_1 = wp::int64(var_0);
        var_2 = wp::int64(var_bits);
        var_3 = wp::lshift(var_1, var_2);
        var_4 = 1ll;
        var_6 = wp::sub(var_bits, var_5);
        var_7 = wp::int64(var_6);
        var_8 = wp::lshift(var_4, var_7);
        var_9 = wp::bit_or(var_3, var_8);
        // a = starts[i]                                                                          <L 5>
        var_10 = wp::address(var_starts, var_0);
        var_12 = wp::load(var_10);
        var_11 = wp::copy(var_12);
        // b = starts[i + 1]                                                                      <L 6>
        var_14 = wp::add(var_0, var_13);
        var_15 = wp::address(var_starts, var_14);
        var_17 = wp::load(var_15);
        var_16 = wp::copy(var_17);
        // while a < b:                                                                           <L 7>
        start_while_0:;
        var_18 = (var_11 < var_16);
        if ((var_18) == false) goto end_while_0;
            // middle = (a + b) // 2                                                              <L 8>
            var_19 = wp::add(var_11, var_16);
            var_21 = wp::floordiv(var_19, var_20);
            // if keys[middle] < limit:                                                           <L 9>
            var_22 = wp::address(var_keys, var_21);
            var_24 = wp::load(var_22);
            var_23 = (var_24 < var_9);
            if (var_23) {
                // a = middle + 1                                                                 <L 10>
                var_26 = wp::add(var_21, var_25);
            }
            if (!var_23) {
                // b = middle                                                                     <L 12>
                var_27 = wp::copy(var_21);
            }
            var_28 = wp::where(var_23, var_26, var_11);
            var_29 = wp::where(var_23, var_16, var_27);
            wp::assign(var_11, var_28);
            wp::assign(var_16, var_29);
        goto start_while_0;
        end_while_0:;
        // counts[i] = a - starts[i]                                                              <L 13>
        var_30 = wp::address(var_starts, var_0);
        var_32 = wp::load(var_30);
        var_31 = wp::sub(var_11, var_32);
        wp::array_store(var_counts, var_0, var_31);
}



extern "C" __global__ void gather_vectors_kernel_aaac3f1c_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_values,
    wp::array_t<wp::int32> var_clouds__order,
    wp::array_t<wp::int32> var_clouds__owners,
    wp::array_t<wp::int32> var_clouds__starts,
    wp::array_t<wp::vec_t<3, wp::float32>> var_gathered)
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
        const wp::float32 var_2 = 0.0;
        const wp::float32 var_3 = 0.0;
        const wp::float32 var_4 = 0.0;
        wp::vec_t<3, wp::float32> var_5;
        const wp::int32 var_6 = 0;
        bool var_7;
        wp::vec_t<3, wp::float32>* var_8;
        wp::vec_t<3, wp::float32> var_9;
        wp::vec_t<3, wp::float32> var_10;
        wp::vec_t<3, wp::float32> var_11;
        //---------
        // forward
        // def gather_vectors_kernel(values, clouds__order, clouds__owners, clouds__starts, gathered):       <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // row = given_row(i, clouds__order, clouds__owners, clouds__starts)                      <L 3>
        var_1 = given_row_0(var_0, var_clouds__order, var_clouds__owners, var_clouds__starts);
        // value = vec3(0.0, 0.0, 0.0)                                                            <L 4>
        var_5 = wp::vec_t<3, wp::float32>(var_2, var_3, var_4);
        // if row >= 0:                                                                           <L 5>
        var_7 = (var_1 >= var_6);
        if (var_7) {
            // value = values[row]                                                                <L 6>
            var_8 = wp::address(var_values, var_1);
            var_10 = wp::load(var_8);
            var_9 = wp::copy(var_10);
        }
        var_11 = wp::where(var_7, var_9, var_5);
        // gathered[i] = value                                                                    <L 7>
        wp::array_store(var_gathered, var_0, var_11);
}



extern "C" __global__ void mark_segments_kernel_b5d9cbf0_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_starts,
    wp::int32 var_bits,
    wp::array_t<wp::int64> var_codes__keys)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::int64* var_1;
        wp::int32 var_2;
        wp::int64 var_3;
        wp::int64 var_4;
        wp::int64 var_5;
        wp::int64 var_6;
        wp::int64 var_7;
        //---------
        // forward
        // def mark_segments_kernel(starts, bits, codes__keys):                                   <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // codes__keys[i] = codes__keys[i] | int64(find_owner(starts, i)) << int64(bits)          <L 3>
        var_1 = wp::address(var_codes__keys, var_0);
        var_2 = find_owner_0(var_starts, var_0);
        var_3 = wp::int64(var_2);
        var_4 = wp::int64(var_bits);
        var_5 = wp::lshift(var_3, var_4);
        var_7 = wp::load(var_1);
        var_6 = wp::bit_or(var_7, var_5);
        wp::array_store(var_codes__keys, var_0, var_6);
}


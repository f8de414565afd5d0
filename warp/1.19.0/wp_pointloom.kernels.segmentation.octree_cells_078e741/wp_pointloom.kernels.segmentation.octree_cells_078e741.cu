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


// /work/main/src/pointloom/kernels/segmentation/octree_cells.py:64
static CUDA_CALLABLE wp::int32 cell_of_1(
    wp::array_t<wp::int32> var_marks,
    wp::array_t<wp::int32> var_offsets,
    wp::int32 var_i)
{
    //---------
    // primal vars
    wp::int32* var_0;
    wp::int32* var_1;
    wp::int32 var_2;
    wp::int32 var_3;
    wp::int32 var_4;
    const wp::int32 var_5 = 1;
    wp::int32 var_6;
    //---------
    // forward
    // def cell_of(marks: array(dtype=int32), offsets: array(dtype=int32), i: int) -> int:       <L 65>
    // return offsets[i] + marks[i] - 1                                                       <L 66>
    var_0 = wp::address(var_offsets, var_i);
    var_1 = wp::address(var_marks, var_i);
    var_3 = wp::load(var_0);
    var_4 = wp::load(var_1);
    var_2 = wp::add(var_3, var_4);
    var_6 = wp::sub(var_2, var_5);
    return var_6;
}


// <pointloom.kernels.search.hilbert_order.spread_bits>:1
static CUDA_CALLABLE wp::int64 spread_bits_0(
    wp::int32 var_v)
{
    //---------
    // primal vars
    wp::int64 var_0;
    wp::int64 var_1;
    wp::int64 var_2;
    wp::int64 var_3;
    wp::int64 var_4;
    wp::int64 var_5;
    wp::int64 var_6;
    wp::int64 var_7;
    wp::int64 var_8;
    wp::int64 var_9;
    wp::int64 var_10;
    wp::int64 var_11;
    wp::int64 var_12;
    wp::int64 var_13;
    wp::int64 var_14;
    wp::int64 var_15;
    wp::int64 var_16;
    wp::int64 var_17;
    wp::int64 var_18;
    wp::int64 var_19;
    wp::int64 var_20;
    wp::int64 var_21;
    wp::int64 var_22;
    wp::int64 var_23;
    wp::int64 var_24;
    wp::int64 var_25;
    //---------
    // forward
    // def spread_bits(v):                                                                    <L 1>
    // x = int64(v)                                                                           <L 3>
    var_0 = wp::int64(var_v);
    // x = (x | x << int64(32)) & int64(8725724278095871)                                     <L 4>
    var_1 = 32ll;
    var_2 = wp::lshift(var_0, var_1);
    var_3 = wp::bit_or(var_0, var_2);
    var_4 = 8725724278095871ll;
    var_5 = wp::bit_and(var_3, var_4);
    // x = (x | x << int64(16)) & int64(8725728556220671)                                     <L 5>
    var_6 = 16ll;
    var_7 = wp::lshift(var_5, var_6);
    var_8 = wp::bit_or(var_5, var_7);
    var_9 = 8725728556220671ll;
    var_10 = wp::bit_and(var_8, var_9);
    // x = (x | x << int64(8)) & int64(1157144660301377551)                                   <L 6>
    var_11 = 8ll;
    var_12 = wp::lshift(var_10, var_11);
    var_13 = wp::bit_or(var_10, var_12);
    var_14 = 1157144660301377551ll;
    var_15 = wp::bit_and(var_13, var_14);
    // x = (x | x << int64(4)) & int64(1207822528635744451)                                   <L 7>
    var_16 = 4ll;
    var_17 = wp::lshift(var_15, var_16);
    var_18 = wp::bit_or(var_15, var_17);
    var_19 = 1207822528635744451ll;
    var_20 = wp::bit_and(var_18, var_19);
    // return (x | x << int64(2)) & int64(1317624576693539401)                                <L 8>
    var_21 = 2ll;
    var_22 = wp::lshift(var_20, var_21);
    var_23 = wp::bit_or(var_20, var_22);
    var_24 = 1317624576693539401ll;
    var_25 = wp::bit_and(var_23, var_24);
    return var_25;
}


// /work/main/src/pointloom/kernels/segmentation/octree_cells.py:64
static CUDA_CALLABLE void adj_cell_of_1(
    wp::array_t<wp::int32> var_marks,
    wp::array_t<wp::int32> var_offsets,
    wp::int32 var_i,
    wp::array_t<wp::int32> & adj_marks,
    wp::array_t<wp::int32> & adj_offsets,
    wp::int32 & adj_i,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.hilbert_order.spread_bits>:1
static CUDA_CALLABLE void adj_spread_bits_0(
    wp::int32 var_v,
    wp::int32 & adj_v,
    wp::int64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void start_cells_kernel_06e7f5d2_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_marks,
    wp::array_t<wp::int32> var_offsets,
    wp::array_t<wp::int32> var_starts)
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
        const wp::int32 var_2 = 1;
        bool var_3;
        wp::int32 var_4;
        wp::int32* var_5;
        wp::int32 var_6;
        const wp::int32 var_7 = 1;
        wp::int32 var_8;
        wp::shape_t* var_9;
        const wp::int32 var_10 = 0;
        wp::int32 var_11;
        wp::shape_t var_12;
        bool var_13;
        const wp::int32 var_14 = 1;
        wp::int32 var_15;
        const wp::int32 var_16 = 1;
        wp::int32 var_17;
        wp::int32* var_18;
        wp::int32 var_19;
        //---------
        // forward
        // def start_cells_kernel(marks: array(dtype=int32), offsets: array(dtype=int32), starts: array(dtype=int32)):       <L 56>
        // i = tid()                                                                              <L 57>
        var_0 = builtin_tid1d();
        // if marks[i] == 1:                                                                      <L 58>
        var_1 = wp::address(var_marks, var_0);
        var_4 = wp::load(var_1);
        var_3 = (var_4 == var_2);
        if (var_3) {
            // starts[offsets[i]] = i                                                             <L 59>
            var_5 = wp::address(var_offsets, var_0);
            var_6 = wp::load(var_5);
            wp::array_store(var_starts, var_6, var_0);
        }
        // if i + 1 == marks.shape[0]:                                                            <L 60>
        var_8 = wp::add(var_0, var_7);
        var_9 = &(var_marks.shape);
        var_12 = wp::load(var_9);
        var_11 = wp::extract(var_12, var_10);
        var_13 = (var_8 == var_11);
        if (var_13) {
            // starts[offsets[i + 1]] = i + 1                                                     <L 61>
            var_15 = wp::add(var_0, var_14);
            var_17 = wp::add(var_0, var_16);
            var_18 = wp::address(var_offsets, var_17);
            var_19 = wp::load(var_18);
            wp::array_store(var_starts, var_19, var_15);
        }
}



extern "C" __global__ void mark_points_kernel_47499049_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_marks,
    wp::array_t<wp::int32> var_offsets,
    wp::array_t<wp::int32> var_numbers,
    wp::array_t<wp::int32> var_inside)
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
        wp::int32* var_4;
        const wp::int32 var_5 = 0;
        bool var_6;
        wp::int32 var_7;
        const wp::int32 var_8 = 1;
        wp::int32 var_9;
        //---------
        // forward
        // def mark_points_kernel(marks, offsets, numbers, inside):                               <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // is_inside = int(0)                                                                     <L 3>
        var_2 = wp::int(var_1);
        // if numbers[cell_of(marks, offsets, i)] >= 0:                                           <L 4>
        var_3 = cell_of_1(var_marks, var_offsets, var_0);
        var_4 = wp::address(var_numbers, var_3);
        var_7 = wp::load(var_4);
        var_6 = (var_7 >= var_5);
        if (var_6) {
            // is_inside = 1                                                                      <L 5>
        }
        var_9 = wp::where(var_6, var_8, var_2);
        // inside[i] = is_inside                                                                  <L 6>
        wp::array_store(var_inside, var_0, var_9);
}



extern "C" __global__ void number_cells_kernel_50d5f225_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_starts,
    wp::array_t<wp::int32> var_slots,
    wp::array_t<wp::int32> var_numbers,
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
        const wp::int32 var_1 = -1;
        wp::int32 var_2;
        const wp::int32 var_3 = 1;
        wp::int32 var_4;
        wp::int32* var_5;
        wp::int32* var_6;
        bool var_7;
        wp::int32 var_8;
        wp::int32 var_9;
        wp::int32* var_10;
        wp::int32 var_11;
        wp::int32 var_12;
        const wp::int32 var_13 = 1;
        wp::int32 var_14;
        wp::int32* var_15;
        wp::int32* var_16;
        wp::int32 var_17;
        wp::int32 var_18;
        wp::int32 var_19;
        wp::int32 var_20;
        //---------
        // forward
        // def number_cells_kernel(starts, slots, numbers, counts):                               <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // number = int(-1)                                                                       <L 4>
        var_2 = wp::int(var_1);
        // if slots[i + 1] > slots[i]:                                                            <L 5>
        var_4 = wp::add(var_0, var_3);
        var_5 = wp::address(var_slots, var_4);
        var_6 = wp::address(var_slots, var_0);
        var_8 = wp::load(var_5);
        var_9 = wp::load(var_6);
        var_7 = (var_8 > var_9);
        if (var_7) {
            // number = slots[i]                                                                  <L 6>
            var_10 = wp::address(var_slots, var_0);
            var_12 = wp::load(var_10);
            var_11 = wp::copy(var_12);
            // counts[number] = starts[i + 1] - starts[i]                                         <L 7>
            var_14 = wp::add(var_0, var_13);
            var_15 = wp::address(var_starts, var_14);
            var_16 = wp::address(var_starts, var_0);
            var_18 = wp::load(var_15);
            var_19 = wp::load(var_16);
            var_17 = wp::sub(var_18, var_19);
            wp::array_store(var_counts, var_11, var_17);
        }
        var_20 = wp::where(var_7, var_11, var_2);
        // numbers[i] = number                                                                    <L 8>
        wp::array_store(var_numbers, var_0, var_20);
}



extern "C" __global__ void cover_cells_kernel_5960e4ef_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_marks,
    wp::array_t<wp::int32> var_offsets,
    wp::array_t<wp::int32> var_numbers,
    wp::array_t<wp::int32> var_flat,
    wp::array_t<wp::int32> var_passed,
    wp::array_t<wp::uint8> var_covered)
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
        wp::int32* var_2;
        const wp::int32 var_3 = 1;
        bool var_4;
        wp::int32 var_5;
        const wp::int32 var_6 = 1;
        wp::uint8 var_7;
        wp::int32* var_8;
        const wp::int32 var_9 = 0;
        bool var_10;
        wp::int32 var_11;
        wp::int32* var_12;
        wp::int32 var_13;
        wp::int32* var_14;
        const wp::int32 var_15 = 1;
        bool var_16;
        wp::int32 var_17;
        const wp::int32 var_18 = 1;
        wp::uint8 var_19;
        //---------
        // forward
        // def cover_cells_kernel(marks, offsets, numbers, flat, passed, covered):                <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // cell = cell_of(marks, offsets, i)                                                      <L 4>
        var_1 = cell_of_1(var_marks, var_offsets, var_0);
        // if flat[cell] == 1:                                                                    <L 5>
        var_2 = wp::address(var_flat, var_1);
        var_5 = wp::load(var_2);
        var_4 = (var_5 == var_3);
        if (var_4) {
            // covered[i] = uint8(1)                                                              <L 6>
            var_7 = wp::uint8(var_6);
            wp::array_store(var_covered, var_0, var_7);
        }
        // if numbers[cell] >= 0:                                                                 <L 7>
        var_8 = wp::address(var_numbers, var_1);
        var_11 = wp::load(var_8);
        var_10 = (var_11 >= var_9);
        if (var_10) {
            // if passed[numbers[cell]] == 1:                                                     <L 8>
            var_12 = wp::address(var_numbers, var_1);
            var_13 = wp::load(var_12);
            var_14 = wp::address(var_passed, var_13);
            var_17 = wp::load(var_14);
            var_16 = (var_17 == var_15);
            if (var_16) {
                // covered[i] = uint8(1)                                                          <L 9>
                var_19 = wp::uint8(var_18);
                wp::array_store(var_covered, var_0, var_19);
            }
        }
}



extern "C" __global__ void encode_cells_kernel_5e8a188a_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::array_t<wp::int32> var_rows,
    wp::vec_t<3, wp::float32> var_low,
    wp::float32 var_scale,
    wp::array_t<wp::int64> var_codes)
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
        wp::vec_t<3, wp::float32> var_6;
        const wp::int32 var_7 = 1;
        const wp::int32 var_8 = 16;
        wp::int32 var_9;
        const wp::int32 var_10 = 1;
        wp::int32 var_11;
        wp::float32 var_12;
        const wp::int32 var_13 = 0;
        wp::float32 var_14;
        const wp::float32 var_15 = 0.0;
        wp::float32 var_16;
        wp::float32 var_17;
        wp::int32 var_18;
        wp::int64 var_19;
        const wp::int32 var_20 = 1;
        wp::float32 var_21;
        const wp::float32 var_22 = 0.0;
        wp::float32 var_23;
        wp::float32 var_24;
        wp::int32 var_25;
        wp::int64 var_26;
        const wp::int32 var_27 = 2;
        wp::float32 var_28;
        const wp::float32 var_29 = 0.0;
        wp::float32 var_30;
        wp::float32 var_31;
        wp::int32 var_32;
        wp::int64 var_33;
        wp::int64 var_34;
        wp::int64 var_35;
        wp::int64 var_36;
        wp::int64 var_37;
        wp::int64 var_38;
        wp::int64 var_39;
        //---------
        // forward
        // def encode_cells_kernel(points, rows, low, scale, codes):                              <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // p = (points[rows[i]] - low) * scale                                                    <L 3>
        var_1 = wp::address(var_rows, var_0);
        var_2 = wp::load(var_1);
        var_3 = wp::address(var_points, var_2);
        var_5 = wp::load(var_3);
        var_4 = wp::sub(var_5, var_low);
        var_6 = wp::mul(var_4, var_scale);
        // top = float((1 << LEVELS) - 1)                                                         <L 4>
        var_9 = wp::lshift(var_7, var_8);
        var_11 = wp::sub(var_9, var_10);
        var_12 = wp::float(var_11);
        // x = spread_bits(int(min(max(p[0], 0.0), top)))                                         <L 5>
        var_14 = wp::extract(var_6, var_13);
        var_16 = wp::max(var_14, var_15);
        var_17 = wp::min(var_16, var_12);
        var_18 = wp::int(var_17);
        var_19 = spread_bits_0(var_18);
        // y = spread_bits(int(min(max(p[1], 0.0), top)))                                         <L 6>
        var_21 = wp::extract(var_6, var_20);
        var_23 = wp::max(var_21, var_22);
        var_24 = wp::min(var_23, var_12);
        var_25 = wp::int(var_24);
        var_26 = spread_bits_0(var_25);
        // z = spread_bits(int(min(max(p[2], 0.0), top)))                                         <L 7>
        var_28 = wp::extract(var_6, var_27);
        var_30 = wp::max(var_28, var_29);
        var_31 = wp::min(var_30, var_12);
        var_32 = wp::int(var_31);
        var_33 = spread_bits_0(var_32);
        // codes[i] = x << int64(2) | y << int64(1) | z                                           <L 8>
        var_34 = 2ll;
        var_35 = wp::lshift(var_19, var_34);
        var_36 = 1ll;
        var_37 = wp::lshift(var_26, var_36);
        var_38 = wp::bit_or(var_35, var_37);
        var_39 = wp::bit_or(var_38, var_33);
        wp::array_store(var_codes, var_0, var_39);
}



extern "C" __global__ void list_points_kernel_9ef16292_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_marks,
    wp::array_t<wp::int32> var_offsets,
    wp::array_t<wp::int32> var_numbers,
    wp::array_t<wp::int32> var_points,
    wp::array_t<wp::int32> var_slots,
    wp::array_t<wp::int32> var_rows,
    wp::array_t<wp::int32> var_runs)
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
        wp::int32* var_3;
        wp::int32* var_4;
        bool var_5;
        wp::int32 var_6;
        wp::int32 var_7;
        wp::int32* var_8;
        wp::int32 var_9;
        wp::int32 var_10;
        wp::int32* var_11;
        wp::int32 var_12;
        wp::int32 var_13;
        wp::int32* var_14;
        wp::int32 var_15;
        wp::int32 var_16;
        wp::int32* var_17;
        wp::int32 var_18;
        //---------
        // forward
        // def list_points_kernel(                                                                <L 121>
        // i = tid()                                                                              <L 130>
        var_0 = builtin_tid1d();
        // if slots[i + 1] > slots[i]:                                                            <L 131>
        var_2 = wp::add(var_0, var_1);
        var_3 = wp::address(var_slots, var_2);
        var_4 = wp::address(var_slots, var_0);
        var_6 = wp::load(var_3);
        var_7 = wp::load(var_4);
        var_5 = (var_6 > var_7);
        if (var_5) {
            // rows[slots[i]] = points[i]                                                         <L 132>
            var_8 = wp::address(var_points, var_0);
            var_10 = wp::load(var_8);
            var_9 = wp::copy(var_10);
            var_11 = wp::address(var_slots, var_0);
            var_12 = wp::load(var_11);
            wp::array_store(var_rows, var_12, var_9);
            // runs[slots[i]] = numbers[cell_of(marks, offsets, i)]                               <L 133>
            var_13 = cell_of_1(var_marks, var_offsets, var_0);
            var_14 = wp::address(var_numbers, var_13);
            var_16 = wp::load(var_14);
            var_15 = wp::copy(var_16);
            var_17 = wp::address(var_slots, var_0);
            var_18 = wp::load(var_17);
            wp::array_store(var_runs, var_18, var_15);
        }
}



extern "C" __global__ void choose_cells_kernel_ae5d171e_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_starts,
    wp::array_t<wp::int32> var_offsets,
    wp::array_t<wp::int32> var_flat,
    wp::int32 var_min_count,
    wp::array_t<wp::int32> var_chosen)
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
        wp::shape_t* var_3;
        const wp::int32 var_4 = 0;
        wp::int32 var_5;
        wp::shape_t var_6;
        const wp::int32 var_7 = 1;
        wp::int32 var_8;
        wp::int32* var_9;
        bool var_10;
        wp::int32 var_11;
        bool var_12;
        const wp::int32 var_13 = 1;
        wp::int32 var_14;
        wp::int32* var_15;
        wp::int32* var_16;
        wp::int32 var_17;
        wp::int32 var_18;
        wp::int32 var_19;
        bool var_20;
        wp::int32* var_21;
        const wp::int32 var_22 = 0;
        bool var_23;
        wp::int32 var_24;
        const wp::int32 var_25 = 1;
        wp::int32 var_26;
        wp::int32 var_27;
        //---------
        // forward
        // def choose_cells_kernel(starts, offsets, flat, min_count, chosen):                     <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // wanted = int(0)                                                                        <L 4>
        var_2 = wp::int(var_1);
        // if i < offsets[offsets.shape[0] - 1]:                                                  <L 5>
        var_3 = &(var_offsets.shape);
        var_6 = wp::load(var_3);
        var_5 = wp::extract(var_6, var_4);
        var_8 = wp::sub(var_5, var_7);
        var_9 = wp::address(var_offsets, var_8);
        var_11 = wp::load(var_9);
        var_10 = (var_0 < var_11);
        if (var_10) {
            // if starts[i + 1] - starts[i] >= min_count and flat[i] == 0:                        <L 6>
            var_14 = wp::add(var_0, var_13);
            var_15 = wp::address(var_starts, var_14);
            var_16 = wp::address(var_starts, var_0);
            var_18 = wp::load(var_15);
            var_19 = wp::load(var_16);
            var_17 = wp::sub(var_18, var_19);
            var_20 = (var_17 >= var_min_count);
            var_12 = var_20;
            if (var_12) {
                var_21 = wp::address(var_flat, var_0);
                var_24 = wp::load(var_21);
                var_23 = (var_24 == var_22);
                var_12 = var_12 && var_23;
            }
            if (var_12) {
                // wanted = 1                                                                     <L 7>
            }
            var_26 = wp::where(var_12, var_25, var_2);
        }
        var_27 = wp::where(var_10, var_26, var_2);
        // chosen[i] = wanted                                                                     <L 8>
        wp::array_store(var_chosen, var_0, var_27);
}



extern "C" __global__ void find_covered_kernel_b64c1ba0_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::uint8> var_covered,
    wp::array_t<wp::int32> var_marks,
    wp::array_t<wp::int32> var_offsets,
    wp::array_t<wp::int32> var_flat)
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
        wp::int32 var_6;
        const wp::int32 var_7 = 1;
        wp::int32 var_8;
        //---------
        // forward
        // def find_covered_kernel(covered, marks, offsets, flat):                                <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // if covered[i] != uint8(0):                                                             <L 4>
        var_1 = wp::address(var_covered, var_0);
        var_3 = wp::uint8(var_2);
        var_5 = wp::load(var_1);
        var_4 = (var_5 != var_3);
        if (var_4) {
            // atomic_max(flat, cell_of(marks, offsets, i), 1)                                    <L 5>
            var_6 = cell_of_1(var_marks, var_offsets, var_0);
            var_8 = wp::atomic_max(var_flat, var_6, var_7);
        }
}



extern "C" __global__ void mark_cells_kernel_b83ac4f6_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int64> var_codes,
    wp::int64 var_shift,
    wp::array_t<wp::int32> var_marks)
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
        const wp::int32 var_3 = 0;
        bool var_4;
        wp::int64* var_5;
        wp::int64 var_6;
        wp::int64 var_7;
        const wp::int32 var_8 = 1;
        wp::int32 var_9;
        wp::int64* var_10;
        wp::int64 var_11;
        wp::int64 var_12;
        bool var_13;
        const wp::int32 var_14 = 0;
        wp::int32 var_15;
        wp::int32 var_16;
        //---------
        // forward
        // def mark_cells_kernel(codes, shift, marks):                                            <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // mark = int(1)                                                                          <L 3>
        var_2 = wp::int(var_1);
        // if i > 0:                                                                              <L 4>
        var_4 = (var_0 > var_3);
        if (var_4) {
            // if codes[i] >> shift == codes[i - 1] >> shift:                                     <L 5>
            var_5 = wp::address(var_codes, var_0);
            var_7 = wp::load(var_5);
            var_6 = wp::rshift(var_7, var_shift);
            var_9 = wp::sub(var_0, var_8);
            var_10 = wp::address(var_codes, var_9);
            var_12 = wp::load(var_10);
            var_11 = wp::rshift(var_12, var_shift);
            var_13 = (var_6 == var_11);
            if (var_13) {
                // mark = 0                                                                       <L 6>
            }
            var_15 = wp::where(var_13, var_14, var_2);
        }
        var_16 = wp::where(var_4, var_15, var_2);
        // marks[i] = mark                                                                        <L 7>
        wp::array_store(var_marks, var_0, var_16);
}



extern "C" __global__ void find_deepest_kernel_c7c17ec8_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int64> var_codes,
    wp::int32 var_min_count,
    wp::array_t<wp::int32> var_deepest)
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
        const wp::int32 var_3 = 1;
        wp::int32 var_4;
        wp::int64* var_5;
        wp::int64 var_6;
        wp::int64 var_7;
        wp::int64 var_8;
        const wp::int32 var_9 = 16;
        wp::int32 var_10;
        wp::int64 var_11;
        bool var_12;
        wp::int64 var_13;
        wp::int64 var_14;
        const wp::int32 var_15 = 1;
        wp::int32 var_16;
        const wp::int32 var_17 = 0;
        wp::int32 var_18;
        //---------
        // forward
        // def find_deepest_kernel(codes, min_count, deepest):                                    <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // differing = codes[i] ^ codes[i + min_count - 1]                                        <L 4>
        var_1 = wp::address(var_codes, var_0);
        var_2 = wp::add(var_0, var_min_count);
        var_4 = wp::sub(var_2, var_3);
        var_5 = wp::address(var_codes, var_4);
        var_7 = wp::load(var_1);
        var_8 = wp::load(var_5);
        var_6 = wp::bit_xor(var_7, var_8);
        // level = int(LEVELS)                                                                    <L 5>
        var_10 = wp::int(var_9);
        // while differing != int64(0):                                                           <L 6>
        start_while_0:;
        var_11 = 0ll;
        var_12 = (var_6 != var_11);
        if ((var_12) == false) goto end_while_0;
            // differing = differing >> int64(3)                                                  <L 7>
            var_13 = 3ll;
            var_14 = wp::rshift(var_6, var_13);
            // level = level - 1                                                                  <L 8>
            var_16 = wp::sub(var_10, var_15);
            wp::assign(var_6, var_14);
            wp::assign(var_10, var_16);
        goto start_while_0;
        end_while_0:;
        // atomic_max(deepest, 0, level)                                                          <L 9>
        var_18 = wp::atomic_max(var_deepest, var_17, var_10);
}


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


// /work/main/src/pointloom/kernels/search/point_tree.py:245
static CUDA_CALLABLE wp::vec_t<3, wp::float32> lowest_corner_0(
    wp::int32 var_node,
    wp::array_t<wp::float32> var_boxes)
{
    //---------
    // primal vars
    const wp::float32 var_0 = INFINITY;
    wp::vec_t<3, wp::float32> var_1;
    const wp::int32 var_2 = 48;
    wp::int32 var_3;
    wp::int32 var_4;
    const wp::int32 var_5 = 8;
    wp::int32 var_6;
    wp::range_t var_7;
    wp::int32 var_8;
    const wp::int32 var_9 = 0;
    wp::float32 var_10;
    wp::float32* var_11;
    wp::float32 var_12;
    wp::float32 var_13;
    const wp::int32 var_14 = 1;
    wp::float32 var_15;
    wp::int32 var_16;
    wp::float32* var_17;
    wp::float32 var_18;
    wp::float32 var_19;
    const wp::int32 var_20 = 2;
    wp::float32 var_21;
    const wp::int32 var_22 = 2;
    wp::int32 var_23;
    wp::int32 var_24;
    wp::float32* var_25;
    wp::float32 var_26;
    wp::float32 var_27;
    wp::vec_t<3, wp::float32> var_28;
    //---------
    // forward
    // def lowest_corner(node: int, boxes: array(dtype=float32)) -> vec3:                     <L 246>
    // a = vec3(INFINITY, INFINITY, INFINITY)                                                 <L 247>
    var_1 = wp::vec_t<3, wp::float32>(var_0, var_0, var_0);
    // for j in range(node * SIDES, node * SIDES + FAN):                                      <L 248>
    var_3 = wp::mul(var_node, var_2);
    var_4 = wp::mul(var_node, var_2);
    var_6 = wp::add(var_4, var_5);
    var_7 = wp::range(var_3, var_6);
    start_for_0:;
        if (iter_cmp(var_7) == 0) goto end_for_0;
        var_8 = wp::iter_next(var_7);
        // a = vec3(min(a[0], boxes[j]), min(a[1], boxes[j + FAN]), min(a[2], boxes[j + 2 * FAN]))       <L 249>
        var_10 = wp::extract(var_1, var_9);
        var_11 = wp::address(var_boxes, var_8);
        var_13 = wp::load(var_11);
        var_12 = wp::min(var_10, var_13);
        var_15 = wp::extract(var_1, var_14);
        var_16 = wp::add(var_8, var_5);
        var_17 = wp::address(var_boxes, var_16);
        var_19 = wp::load(var_17);
        var_18 = wp::min(var_15, var_19);
        var_21 = wp::extract(var_1, var_20);
        var_23 = wp::mul(var_22, var_5);
        var_24 = wp::add(var_8, var_23);
        var_25 = wp::address(var_boxes, var_24);
        var_27 = wp::load(var_25);
        var_26 = wp::min(var_21, var_27);
        var_28 = wp::vec_t<3, wp::float32>(var_12, var_18, var_26);
        wp::assign(var_1, var_28);
        goto start_for_0;
    end_for_0:;
    // return a                                                                               <L 250>
    return var_1;
}


// /work/main/src/pointloom/kernels/search/point_tree.py:253
static CUDA_CALLABLE wp::vec_t<3, wp::float32> highest_corner_0(
    wp::int32 var_node,
    wp::array_t<wp::float32> var_boxes)
{
    //---------
    // primal vars
    const wp::float32 var_0 = INFINITY;
    const wp::float32 var_1 = -INFINITY;
    const wp::float32 var_2 = -INFINITY;
    const wp::float32 var_3 = -INFINITY;
    wp::vec_t<3, wp::float32> var_4;
    const wp::int32 var_5 = 48;
    wp::int32 var_6;
    const wp::int32 var_7 = 3;
    const wp::int32 var_8 = 8;
    wp::int32 var_9;
    wp::int32 var_10;
    wp::int32 var_11;
    const wp::int32 var_12 = 4;
    wp::int32 var_13;
    wp::int32 var_14;
    wp::range_t var_15;
    wp::int32 var_16;
    const wp::int32 var_17 = 0;
    wp::float32 var_18;
    wp::float32* var_19;
    wp::float32 var_20;
    wp::float32 var_21;
    const wp::int32 var_22 = 1;
    wp::float32 var_23;
    wp::int32 var_24;
    wp::float32* var_25;
    wp::float32 var_26;
    wp::float32 var_27;
    const wp::int32 var_28 = 2;
    wp::float32 var_29;
    const wp::int32 var_30 = 2;
    wp::int32 var_31;
    wp::int32 var_32;
    wp::float32* var_33;
    wp::float32 var_34;
    wp::float32 var_35;
    wp::vec_t<3, wp::float32> var_36;
    //---------
    // forward
    // def highest_corner(node: int, boxes: array(dtype=float32)) -> vec3:                    <L 254>
    // b = vec3(-INFINITY, -INFINITY, -INFINITY)                                              <L 255>
    var_4 = wp::vec_t<3, wp::float32>(var_1, var_2, var_3);
    // for j in range(node * SIDES + 3 * FAN, node * SIDES + 4 * FAN):                        <L 256>
    var_6 = wp::mul(var_node, var_5);
    var_9 = wp::mul(var_7, var_8);
    var_10 = wp::add(var_6, var_9);
    var_11 = wp::mul(var_node, var_5);
    var_13 = wp::mul(var_12, var_8);
    var_14 = wp::add(var_11, var_13);
    var_15 = wp::range(var_10, var_14);
    start_for_0:;
        if (iter_cmp(var_15) == 0) goto end_for_0;
        var_16 = wp::iter_next(var_15);
        // b = vec3(max(b[0], boxes[j]), max(b[1], boxes[j + FAN]), max(b[2], boxes[j + 2 * FAN]))       <L 257>
        var_18 = wp::extract(var_4, var_17);
        var_19 = wp::address(var_boxes, var_16);
        var_21 = wp::load(var_19);
        var_20 = wp::max(var_18, var_21);
        var_23 = wp::extract(var_4, var_22);
        var_24 = wp::add(var_16, var_8);
        var_25 = wp::address(var_boxes, var_24);
        var_27 = wp::load(var_25);
        var_26 = wp::max(var_23, var_27);
        var_29 = wp::extract(var_4, var_28);
        var_31 = wp::mul(var_30, var_8);
        var_32 = wp::add(var_16, var_31);
        var_33 = wp::address(var_boxes, var_32);
        var_35 = wp::load(var_33);
        var_34 = wp::max(var_29, var_35);
        var_36 = wp::vec_t<3, wp::float32>(var_20, var_26, var_34);
        wp::assign(var_4, var_36);
        goto start_for_0;
    end_for_0:;
    // return b                                                                               <L 258>
    return var_4;
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:178
static CUDA_CALLABLE wp::float32 _shuffle_xor_1(
    wp::float32 x,
    wp::int32 mask)
{
return __shfl_xor_sync(0xffffffffu, x, mask);}


// /work/main/src/pointloom/kernels/search/point_tree.py:188
static CUDA_CALLABLE wp::vec_t<3, wp::float32> lowest_of_lanes_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::int32 var_first,
    wp::int32 var_last)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 0.0;
    const wp::float32 var_1 = 0.0;
    const wp::float32 var_2 = 0.0;
    wp::vec_t<3, wp::float32> var_3;
    wp::vec_t<3, wp::float32> var_4;
    wp::range_t var_5;
    wp::int32 var_6;
    const wp::int32 var_7 = 0;
    wp::float32 var_8;
    const wp::int32 var_9 = 1;
    wp::int32 var_10;
    wp::float32 var_11;
    const wp::int32 var_12 = 1;
    wp::float32 var_13;
    const wp::int32 var_14 = 1;
    wp::int32 var_15;
    wp::float32 var_16;
    const wp::int32 var_17 = 2;
    wp::float32 var_18;
    const wp::int32 var_19 = 1;
    wp::int32 var_20;
    wp::float32 var_21;
    const wp::int32 var_22 = 0;
    wp::float32 var_23;
    wp::float32 var_24;
    const wp::int32 var_25 = 1;
    wp::float32 var_26;
    wp::float32 var_27;
    const wp::int32 var_28 = 2;
    wp::float32 var_29;
    wp::float32 var_30;
    wp::vec_t<3, wp::float32> var_31;
    //---------
    // forward
    // def lowest_of_lanes(p: vec3, first: int, last: int) -> vec3:                           <L 189>
    // a = p + vec3(0.0, 0.0, 0.0)                                                            <L 191>
    var_3 = wp::vec_t<3, wp::float32>(var_0, var_1, var_2);
    var_4 = wp::add(var_p, var_3);
    // for bit in range(first, last):                                                         <L 192>
    var_5 = wp::range(var_first, var_last);
    start_for_0:;
        if (iter_cmp(var_5) == 0) goto end_for_0;
        var_6 = wp::iter_next(var_5);
        // x = shuffle_xor(a[0], 1 << bit)                                                    <L 193>
        var_8 = wp::extract(var_4, var_7);
        var_10 = wp::lshift(var_9, var_6);
        var_11 = _shuffle_xor_1(var_8, var_10);
        // y = shuffle_xor(a[1], 1 << bit)                                                    <L 194>
        var_13 = wp::extract(var_4, var_12);
        var_15 = wp::lshift(var_14, var_6);
        var_16 = _shuffle_xor_1(var_13, var_15);
        // z = shuffle_xor(a[2], 1 << bit)                                                    <L 195>
        var_18 = wp::extract(var_4, var_17);
        var_20 = wp::lshift(var_19, var_6);
        var_21 = _shuffle_xor_1(var_18, var_20);
        // a = vec3(min(a[0], x), min(a[1], y), min(a[2], z))                                 <L 196>
        var_23 = wp::extract(var_4, var_22);
        var_24 = wp::min(var_23, var_11);
        var_26 = wp::extract(var_4, var_25);
        var_27 = wp::min(var_26, var_16);
        var_29 = wp::extract(var_4, var_28);
        var_30 = wp::min(var_29, var_21);
        var_31 = wp::vec_t<3, wp::float32>(var_24, var_27, var_30);
        wp::assign(var_4, var_31);
        goto start_for_0;
    end_for_0:;
    // return a                                                                               <L 197>
    return var_4;
}


// /work/main/src/pointloom/kernels/search/point_tree.py:200
static CUDA_CALLABLE void write_side_on_cuda_0(
    wp::int32 var_lane,
    wp::vec_t<3, wp::float32> var_low,
    wp::vec_t<3, wp::float32> var_high,
    wp::int32 var_at,
    wp::array_t<wp::float32> var_boxes)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 3;
    bool var_1;
    const wp::int32 var_2 = 0;
    wp::float32 var_3;
    const wp::int32 var_4 = 0;
    wp::float32 var_5;
    wp::float32 var_6;
    const wp::int32 var_7 = 4;
    bool var_8;
    const wp::int32 var_9 = 1;
    wp::float32 var_10;
    const wp::int32 var_11 = 1;
    wp::float32 var_12;
    wp::float32 var_13;
    const wp::int32 var_14 = 5;
    bool var_15;
    const wp::int32 var_16 = 2;
    wp::float32 var_17;
    const wp::int32 var_18 = 2;
    wp::float32 var_19;
    wp::float32 var_20;
    const wp::int32 var_21 = 3;
    wp::int32 var_22;
    const wp::int32 var_23 = 0;
    bool var_24;
    const wp::int32 var_25 = 3;
    wp::int32 var_26;
    const wp::int32 var_27 = 1;
    bool var_28;
    wp::float32 var_29;
    wp::float32 var_30;
    const wp::int32 var_31 = 6;
    bool var_32;
    const wp::int32 var_33 = 8;
    wp::int32 var_34;
    wp::int32 var_35;
    //---------
    // forward
    // def write_side(lane: int, low: vec3, high: vec3, at: int, boxes: array(dtype=float32)):       <L 201>
    // x = high[0] if lane == 3 else low[0]                                                   <L 203>
    var_1 = (var_lane == var_0);
    if (var_1) {
        var_3 = wp::extract(var_high, var_2);
    }
    if (!var_1) {
        var_5 = wp::extract(var_low, var_4);
    }
    var_6 = wp::where(var_1, var_3, var_5);
    // y = high[1] if lane == 4 else low[1]                                                   <L 204>
    var_8 = (var_lane == var_7);
    if (var_8) {
        var_10 = wp::extract(var_high, var_9);
    }
    if (!var_8) {
        var_12 = wp::extract(var_low, var_11);
    }
    var_13 = wp::where(var_8, var_10, var_12);
    // z = high[2] if lane == 5 else low[2]                                                   <L 205>
    var_15 = (var_lane == var_14);
    if (var_15) {
        var_17 = wp::extract(var_high, var_16);
    }
    if (!var_15) {
        var_19 = wp::extract(var_low, var_18);
    }
    var_20 = wp::where(var_15, var_17, var_19);
    // side = x if lane % 3 == 0 else y if lane % 3 == 1 else z                               <L 206>
    var_22 = wp::mod(var_lane, var_21);
    var_24 = (var_22 == var_23);
    if (var_24) {
    }
    if (!var_24) {
        var_26 = wp::mod(var_lane, var_25);
        var_28 = (var_26 == var_27);
        if (var_28) {
        }
        if (!var_28) {
        }
        var_29 = wp::where(var_28, var_13, var_20);
    }
    var_30 = wp::where(var_24, var_6, var_29);
    // if lane < 6:                                                                           <L 207>
    var_32 = (var_lane < var_31);
    if (var_32) {
        // boxes[at + lane * FAN] = side                                                      <L 208>
        var_34 = wp::mul(var_lane, var_33);
        var_35 = wp::add(var_at, var_34);
        wp::array_store(var_boxes, var_35, var_30);
    }
}


// /work/main/src/pointloom/kernels/search/point_tree.py:245
static CUDA_CALLABLE void adj_lowest_corner_0(
    wp::int32 var_node,
    wp::array_t<wp::float32> var_boxes,
    wp::int32 & adj_node,
    wp::array_t<wp::float32> & adj_boxes,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/search/point_tree.py:253
static CUDA_CALLABLE void adj_highest_corner_0(
    wp::int32 var_node,
    wp::array_t<wp::float32> var_boxes,
    wp::int32 & adj_node,
    wp::array_t<wp::float32> & adj_boxes,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:178
static CUDA_CALLABLE void adj__shuffle_xor_1(
    wp::float32 x,
    wp::int32 mask,
    wp::float32 & adj_x,
    wp::int32 & adj_mask,
    wp::float32 & adj_ret)
{
}


// /work/main/src/pointloom/kernels/search/point_tree.py:188
static CUDA_CALLABLE void adj_lowest_of_lanes_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::int32 var_first,
    wp::int32 var_last,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::int32 & adj_first,
    wp::int32 & adj_last,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/search/point_tree.py:200
static CUDA_CALLABLE void adj_write_side_on_cuda_0(
    wp::int32 var_lane,
    wp::vec_t<3, wp::float32> var_low,
    wp::vec_t<3, wp::float32> var_high,
    wp::int32 var_at,
    wp::array_t<wp::float32> var_boxes,
    wp::int32 & adj_lane,
    wp::vec_t<3, wp::float32> & adj_low,
    wp::vec_t<3, wp::float32> & adj_high,
    wp::int32 & adj_at,
    wp::array_t<wp::float32> & adj_boxes)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void bound_two_levels_kernel_408ad426_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::int32 var_level,
    wp::array_t<wp::int32> var_levels,
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
        const wp::int32 var_1 = 1;
        wp::int32 var_2;
        wp::int32* var_3;
        wp::int32 var_4;
        wp::int32 var_5;
        wp::int32* var_6;
        wp::int32 var_7;
        wp::int32 var_8;
        const wp::int32 var_9 = 1;
        wp::int32 var_10;
        wp::int32* var_11;
        wp::int32 var_12;
        wp::int32 var_13;
        const wp::float32 var_14 = INFINITY;
        wp::vec_t<3, wp::float32> var_15;
        const wp::float32 var_16 = -INFINITY;
        const wp::float32 var_17 = -INFINITY;
        const wp::float32 var_18 = -INFINITY;
        wp::vec_t<3, wp::float32> var_19;
        wp::int32 var_20;
        bool var_21;
        wp::int32 var_22;
        wp::vec_t<3, wp::float32> var_23;
        wp::int32 var_24;
        wp::vec_t<3, wp::float32> var_25;
        wp::vec_t<3, wp::float32> var_26;
        wp::vec_t<3, wp::float32> var_27;
        const wp::int32 var_28 = 8;
        wp::int32 var_29;
        wp::int32 var_30;
        bool var_31;
        wp::int32 var_32;
        const wp::int32 var_33 = 48;
        wp::int32 var_34;
        wp::int32 var_35;
        wp::int32 var_36;
        const wp::int32 var_37 = 0;
        wp::float32 var_38;
        wp::int32 var_39;
        wp::int32 var_40;
        wp::float32 var_41;
        const wp::int32 var_42 = 3;
        wp::int32 var_43;
        wp::int32 var_44;
        wp::int32 var_45;
        const wp::int32 var_46 = 1;
        wp::float32 var_47;
        wp::int32 var_48;
        wp::int32 var_49;
        wp::float32 var_50;
        const wp::int32 var_51 = 3;
        wp::int32 var_52;
        wp::int32 var_53;
        wp::int32 var_54;
        const wp::int32 var_55 = 2;
        wp::float32 var_56;
        wp::int32 var_57;
        wp::int32 var_58;
        wp::float32 var_59;
        const wp::int32 var_60 = 3;
        wp::int32 var_61;
        wp::int32 var_62;
        wp::int32 var_63;
        const wp::int32 var_64 = 0;
        const wp::int32 var_65 = 3;
        wp::vec_t<3, wp::float32> var_66;
        wp::vec_t<3, wp::float32> var_67;
        const wp::int32 var_68 = 0;
        const wp::int32 var_69 = 3;
        wp::vec_t<3, wp::float32> var_70;
        const wp::int32 var_71 = 2;
        wp::int32 var_72;
        wp::shape_t* var_73;
        const wp::int32 var_74 = 0;
        wp::int32 var_75;
        wp::shape_t var_76;
        bool var_77;
        wp::int32 var_78;
        wp::vec_t<3, wp::float32> var_79;
        wp::int32 var_80;
        wp::int32 var_81;
        wp::int32 var_82;
        wp::int32 var_83;
        wp::int32 var_84;
        //---------
        // forward
        // def bound_two_levels_kernel(level: int, levels: array(dtype=int32), boxes: array(dtype=float32)):       <L 284>
        // i = tid()                                                                              <L 286>
        var_0 = builtin_tid1d();
        // below = levels[level - 1]                                                              <L 287>
        var_2 = wp::sub(var_level, var_1);
        var_3 = wp::address(var_levels, var_2);
        var_5 = wp::load(var_3);
        var_4 = wp::copy(var_5);
        // first = levels[level]                                                                  <L 288>
        var_6 = wp::address(var_levels, var_level);
        var_8 = wp::load(var_6);
        var_7 = wp::copy(var_8);
        // above = levels[level + 1]                                                              <L 289>
        var_10 = wp::add(var_level, var_9);
        var_11 = wp::address(var_levels, var_10);
        var_13 = wp::load(var_11);
        var_12 = wp::copy(var_13);
        // a = vec3(INFINITY, INFINITY, INFINITY)                                                 <L 290>
        var_15 = wp::vec_t<3, wp::float32>(var_14, var_14, var_14);
        // b = vec3(-INFINITY, -INFINITY, -INFINITY)                                              <L 291>
        var_19 = wp::vec_t<3, wp::float32>(var_16, var_17, var_18);
        // if below + i < first:                                                                  <L 292>
        var_20 = wp::add(var_4, var_0);
        var_21 = (var_20 < var_7);
        if (var_21) {
            // a = lowest_corner(below + i, boxes)                                                <L 293>
            var_22 = wp::add(var_4, var_0);
            var_23 = lowest_corner_0(var_22, var_boxes);
            // b = highest_corner(below + i, boxes)                                               <L 294>
            var_24 = wp::add(var_4, var_0);
            var_25 = highest_corner_0(var_24, var_boxes);
        }
        var_26 = wp::where(var_21, var_23, var_15);
        var_27 = wp::where(var_21, var_25, var_19);
        // parent = i // FAN                                                                      <L 295>
        var_29 = wp::floordiv(var_0, var_28);
        // if first + parent < above:                                                             <L 296>
        var_30 = wp::add(var_7, var_29);
        var_31 = (var_30 < var_12);
        if (var_31) {
            // at = (first + parent) * SIDES + i % FAN                                            <L 297>
            var_32 = wp::add(var_7, var_29);
            var_34 = wp::mul(var_32, var_33);
            var_35 = wp::mod(var_0, var_28);
            var_36 = wp::add(var_34, var_35);
            // for axis in range(3):                                                              <L 298>
            // boxes[at + axis * FAN] = a[axis]                                                   <L 299>
            var_38 = wp::extract(var_26, var_37);
            var_39 = wp::mul(var_37, var_28);
            var_40 = wp::add(var_36, var_39);
            wp::array_store(var_boxes, var_40, var_38);
            // boxes[at + (axis + 3) * FAN] = b[axis]                                             <L 300>
            var_41 = wp::extract(var_27, var_37);
            var_43 = wp::add(var_37, var_42);
            var_44 = wp::mul(var_43, var_28);
            var_45 = wp::add(var_36, var_44);
            wp::array_store(var_boxes, var_45, var_41);
            // boxes[at + axis * FAN] = a[axis]                                                   <L 299>
            var_47 = wp::extract(var_26, var_46);
            var_48 = wp::mul(var_46, var_28);
            var_49 = wp::add(var_36, var_48);
            wp::array_store(var_boxes, var_49, var_47);
            // boxes[at + (axis + 3) * FAN] = b[axis]                                             <L 300>
            var_50 = wp::extract(var_27, var_46);
            var_52 = wp::add(var_46, var_51);
            var_53 = wp::mul(var_52, var_28);
            var_54 = wp::add(var_36, var_53);
            wp::array_store(var_boxes, var_54, var_50);
            // boxes[at + axis * FAN] = a[axis]                                                   <L 299>
            var_56 = wp::extract(var_26, var_55);
            var_57 = wp::mul(var_55, var_28);
            var_58 = wp::add(var_36, var_57);
            wp::array_store(var_boxes, var_58, var_56);
            // boxes[at + (axis + 3) * FAN] = b[axis]                                             <L 300>
            var_59 = wp::extract(var_27, var_55);
            var_61 = wp::add(var_55, var_60);
            var_62 = wp::mul(var_61, var_28);
            var_63 = wp::add(var_36, var_62);
            wp::array_store(var_boxes, var_63, var_59);
        }
        // a = lowest_of_lanes(a, 0, 3)                                                           <L 301>
        var_66 = lowest_of_lanes_on_cuda_0(var_26, var_64, var_65);
        // b = lowest_of_lanes(-b, 0, 3)                                                          <L 302>
        var_67 = wp::neg(var_27);
        var_70 = lowest_of_lanes_on_cuda_0(var_67, var_68, var_69);
        // if level + 2 < levels.shape[0]:                                                        <L 303>
        var_72 = wp::add(var_level, var_71);
        var_73 = &(var_levels.shape);
        var_76 = wp::load(var_73);
        var_75 = wp::extract(var_76, var_74);
        var_77 = (var_72 < var_75);
        if (var_77) {
            // write_side(i % FAN, a, -b, (above + parent // FAN) * SIDES + parent % FAN, boxes)       <L 304>
            var_78 = wp::mod(var_0, var_28);
            var_79 = wp::neg(var_70);
            var_80 = wp::floordiv(var_29, var_28);
            var_81 = wp::add(var_12, var_80);
            var_82 = wp::mul(var_81, var_33);
            var_83 = wp::mod(var_29, var_28);
            var_84 = wp::add(var_82, var_83);
            write_side_on_cuda_0(var_78, var_66, var_79, var_84, var_boxes);
        }
}



extern "C" __global__ void store_buckets_kernel_56cc2bc9_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_source,
    wp::array_t<wp::int64> var_codes,
    wp::int32 var_tree__count,
    wp::int32 var_tree__root,
    wp::array_t<wp::int32> var_tree__levels,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> var_tree__points,
    wp::array_t<wp::int32> var_tree__order,
    wp::array_t<wp::int64> var_tree__codes)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        const wp::int32 var_1 = 32;
        wp::int32 var_2;
        wp::int32 var_3;
        bool var_4;
        const wp::int32 var_5 = 0;
        bool var_6;
        wp::shape_t* var_7;
        const wp::int32 var_8 = 0;
        wp::int32 var_9;
        wp::shape_t var_10;
        bool var_11;
        const wp::int32 var_12 = 64;
        wp::int32 var_13;
        bool var_14;
        wp::int32 var_15;
        wp::int64* var_16;
        wp::int64 var_17;
        wp::int64 var_18;
        wp::int64 var_19;
        wp::int64 var_20;
        const wp::float32 var_21 = INFINITY;
        wp::vec_t<3, wp::float32> var_22;
        wp::vec_t<3, wp::float32> var_23;
        const wp::int32 var_24 = 0;
        wp::int32 var_25;
        wp::int32 var_26;
        wp::int32 var_27;
        wp::int32 var_28;
        wp::vec_t<3, wp::float32> var_29;
        wp::vec_t<3, wp::float32> var_30;
        bool var_31;
        wp::int32* var_32;
        wp::int32 var_33;
        wp::vec_t<3, wp::float32>* var_34;
        wp::vec_t<3, wp::float32> var_35;
        wp::vec_t<3, wp::float32> var_36;
        bool var_37;
        wp::vec_t<3, wp::float32> var_38;
        wp::vec_t<3, wp::float32> var_39;
        wp::vec_t<3, wp::float32> var_40;
        wp::vec_t<3, wp::float32> var_41;
        wp::shape_t* var_42;
        const wp::int32 var_43 = 0;
        wp::int32 var_44;
        wp::shape_t var_45;
        bool var_46;
        wp::vec_t<3, wp::float32> var_47;
        wp::vec_t<3, wp::float32> var_48;
        const wp::int32 var_49 = 0;
        const wp::int32 var_50 = 3;
        wp::vec_t<3, wp::float32> var_51;
        const wp::int32 var_52 = 0;
        const wp::int32 var_53 = 3;
        wp::vec_t<3, wp::float32> var_54;
        wp::shape_t* var_55;
        const wp::int32 var_56 = 0;
        wp::int32 var_57;
        wp::shape_t var_58;
        bool var_59;
        const wp::int32 var_60 = 8;
        wp::int32 var_61;
        wp::vec_t<3, wp::float32> var_62;
        const wp::int32 var_63 = 48;
        wp::int32 var_64;
        const wp::int32 var_65 = 8;
        const wp::int32 var_66 = 2;
        wp::int32 var_67;
        wp::int32 var_68;
        wp::int32 var_69;
        wp::int32 var_70;
        wp::int32 var_71;
        const wp::int32 var_72 = 0;
        wp::float32 var_73;
        const wp::int32 var_74 = 0;
        wp::float32 var_75;
        wp::float32 var_76;
        const wp::int32 var_77 = 1;
        wp::float32 var_78;
        const wp::int32 var_79 = 1;
        wp::float32 var_80;
        wp::float32 var_81;
        const wp::int32 var_82 = 2;
        wp::float32 var_83;
        const wp::int32 var_84 = 2;
        wp::float32 var_85;
        wp::float32 var_86;
        wp::vec_t<3, wp::float32> var_87;
        const wp::int32 var_88 = 0;
        wp::float32 var_89;
        const wp::int32 var_90 = 0;
        wp::float32 var_91;
        wp::float32 var_92;
        const wp::int32 var_93 = 1;
        wp::float32 var_94;
        const wp::int32 var_95 = 1;
        wp::float32 var_96;
        wp::float32 var_97;
        const wp::int32 var_98 = 2;
        wp::float32 var_99;
        const wp::int32 var_100 = 2;
        wp::float32 var_101;
        wp::float32 var_102;
        wp::vec_t<3, wp::float32> var_103;
        const wp::int32 var_104 = 1;
        wp::int32 var_105;
        wp::int32 var_106;
        wp::int32 var_107;
        wp::int32 var_108;
        wp::vec_t<3, wp::float32> var_109;
        wp::vec_t<3, wp::float32> var_110;
        bool var_111;
        wp::int32* var_112;
        wp::int32 var_113;
        wp::vec_t<3, wp::float32>* var_114;
        wp::vec_t<3, wp::float32> var_115;
        wp::vec_t<3, wp::float32> var_116;
        bool var_117;
        wp::vec_t<3, wp::float32> var_118;
        wp::vec_t<3, wp::float32> var_119;
        wp::vec_t<3, wp::float32> var_120;
        wp::vec_t<3, wp::float32> var_121;
        wp::shape_t* var_122;
        const wp::int32 var_123 = 0;
        wp::int32 var_124;
        wp::shape_t var_125;
        bool var_126;
        wp::vec_t<3, wp::float32> var_127;
        wp::vec_t<3, wp::float32> var_128;
        wp::vec_t<3, wp::float32> var_129;
        const wp::int32 var_130 = 0;
        const wp::int32 var_131 = 3;
        wp::vec_t<3, wp::float32> var_132;
        const wp::int32 var_133 = 0;
        const wp::int32 var_134 = 3;
        wp::vec_t<3, wp::float32> var_135;
        wp::shape_t* var_136;
        const wp::int32 var_137 = 0;
        wp::int32 var_138;
        wp::shape_t var_139;
        bool var_140;
        wp::int32 var_141;
        wp::vec_t<3, wp::float32> var_142;
        wp::int32 var_143;
        const wp::int32 var_144 = 2;
        wp::int32 var_145;
        wp::int32 var_146;
        wp::int32 var_147;
        wp::int32 var_148;
        wp::int32 var_149;
        const wp::int32 var_150 = 0;
        wp::float32 var_151;
        const wp::int32 var_152 = 0;
        wp::float32 var_153;
        wp::float32 var_154;
        const wp::int32 var_155 = 1;
        wp::float32 var_156;
        const wp::int32 var_157 = 1;
        wp::float32 var_158;
        wp::float32 var_159;
        const wp::int32 var_160 = 2;
        wp::float32 var_161;
        const wp::int32 var_162 = 2;
        wp::float32 var_163;
        wp::float32 var_164;
        wp::vec_t<3, wp::float32> var_165;
        const wp::int32 var_166 = 0;
        wp::float32 var_167;
        const wp::int32 var_168 = 0;
        wp::float32 var_169;
        wp::float32 var_170;
        const wp::int32 var_171 = 1;
        wp::float32 var_172;
        const wp::int32 var_173 = 1;
        wp::float32 var_174;
        wp::float32 var_175;
        const wp::int32 var_176 = 2;
        wp::float32 var_177;
        const wp::int32 var_178 = 2;
        wp::float32 var_179;
        wp::float32 var_180;
        wp::vec_t<3, wp::float32> var_181;
        const wp::int32 var_182 = 3;
        const wp::int32 var_183 = 5;
        wp::vec_t<3, wp::float32> var_184;
        const wp::int32 var_185 = 3;
        const wp::int32 var_186 = 5;
        wp::vec_t<3, wp::float32> var_187;
        const wp::int32 var_188 = 0;
        bool var_189;
        wp::vec_t<3, wp::float32> var_190;
        const wp::int32 var_191 = 1;
        wp::int32* var_192;
        wp::int32 var_193;
        wp::int32 var_194;
        wp::int32 var_195;
        wp::int32 var_196;
        wp::int32 var_197;
        wp::int32 var_198;
        //---------
        // forward
        // def store_buckets_kernel(source, codes, tree__count, tree__root, tree__levels, tree__boxes, tree__points, tree__order, tree__codes):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // bucket = i // WARP                                                                     <L 4>
        var_2 = wp::floordiv(var_0, var_1);
        // lane = i % WARP                                                                        <L 5>
        var_3 = wp::mod(var_0, var_1);
        // if lane == 0 and bucket < tree__codes.shape[0]:                                        <L 6>
        var_6 = (var_3 == var_5);
        var_4 = var_6;
        if (var_4) {
            var_7 = &(var_tree__codes.shape);
            var_10 = wp::load(var_7);
            var_9 = wp::extract(var_10, var_8);
            var_11 = (var_2 < var_9);
            var_4 = var_4 && var_11;
        }
        if (var_4) {
            // tree__codes[bucket] = codes[bucket * BUCKET] if bucket * BUCKET < tree__count else int64(0)       <L 7>
            var_13 = wp::mul(var_2, var_12);
            var_14 = (var_13 < var_tree__count);
            if (var_14) {
                var_15 = wp::mul(var_2, var_12);
                var_16 = wp::address(var_codes, var_15);
                var_18 = wp::load(var_16);
                var_17 = wp::copy(var_18);
            }
            if (!var_14) {
                var_19 = 0ll;
            }
            var_20 = wp::where(var_14, var_17, var_19);
            wp::array_store(var_tree__codes, var_2, var_20);
        }
        // low = vec3(INFINITY, INFINITY, INFINITY)                                               <L 8>
        var_22 = wp::vec_t<3, wp::float32>(var_21, var_21, var_21);
        // high = vec3(INFINITY, INFINITY, INFINITY)                                              <L 9>
        var_23 = wp::vec_t<3, wp::float32>(var_21, var_21, var_21);
        // for half in range(2):                                                                  <L 10>
        // position = bucket * BUCKET + half * WARP + lane                                        <L 11>
        var_25 = wp::mul(var_2, var_12);
        var_26 = wp::mul(var_24, var_1);
        var_27 = wp::add(var_25, var_26);
        var_28 = wp::add(var_27, var_3);
        // a = vec3(INFINITY, INFINITY, INFINITY)                                                 <L 12>
        var_29 = wp::vec_t<3, wp::float32>(var_21, var_21, var_21);
        // b = vec3(INFINITY, INFINITY, INFINITY)                                                 <L 13>
        var_30 = wp::vec_t<3, wp::float32>(var_21, var_21, var_21);
        // if position < tree__count:                                                             <L 14>
        var_31 = (var_28 < var_tree__count);
        if (var_31) {
            // p = source[tree__order[position]]                                                  <L 15>
            var_32 = wp::address(var_tree__order, var_28);
            var_33 = wp::load(var_32);
            var_34 = wp::address(var_source, var_33);
            var_36 = wp::load(var_34);
            var_35 = wp::copy(var_36);
            // tree__points[position] = p                                                         <L 16>
            wp::array_store(var_tree__points, var_28, var_35);
            // if isfinite(p):                                                                    <L 17>
            var_37 = wp::isfinite(var_35);
            if (var_37) {
                // a = p                                                                          <L 18>
                var_38 = wp::copy(var_35);
                // b = -p                                                                         <L 19>
                var_39 = wp::neg(var_35);
            }
            var_40 = wp::where(var_37, var_38, var_29);
            var_41 = wp::where(var_37, var_39, var_30);
        }
        if (!var_31) {
            // elif position < tree__points.shape[0]:                                             <L 20>
            var_42 = &(var_tree__points.shape);
            var_45 = wp::load(var_42);
            var_44 = wp::extract(var_45, var_43);
            var_46 = (var_28 < var_44);
            if (var_46) {
                // tree__points[position] = a                                                     <L 21>
                wp::array_store(var_tree__points, var_28, var_29);
            }
        }
        var_47 = wp::where(var_31, var_40, var_29);
        var_48 = wp::where(var_31, var_41, var_30);
        // a = lowest_of_lanes(a, 0, 3)                                                           <L 22>
        var_51 = lowest_of_lanes_on_cuda_0(var_47, var_49, var_50);
        // b = lowest_of_lanes(b, 0, 3)                                                           <L 23>
        var_54 = lowest_of_lanes_on_cuda_0(var_48, var_52, var_53);
        // if bucket < tree__codes.shape[0]:                                                      <L 24>
        var_55 = &(var_tree__codes.shape);
        var_58 = wp::load(var_55);
        var_57 = wp::extract(var_58, var_56);
        var_59 = (var_2 < var_57);
        if (var_59) {
            // write_side(lane % LEAF, a, -b, bucket * SIDES + half * (FAN // 2) + lane // LEAF, tree__boxes)       <L 25>
            var_61 = wp::mod(var_3, var_60);
            var_62 = wp::neg(var_54);
            var_64 = wp::mul(var_2, var_63);
            var_67 = wp::floordiv(var_65, var_66);
            var_68 = wp::mul(var_24, var_67);
            var_69 = wp::add(var_64, var_68);
            var_70 = wp::floordiv(var_3, var_60);
            var_71 = wp::add(var_69, var_70);
            write_side_on_cuda_0(var_61, var_51, var_62, var_71, var_tree__boxes);
        }
        // low = vec3(min(low[0], a[0]), min(low[1], a[1]), min(low[2], a[2]))                    <L 26>
        var_73 = wp::extract(var_22, var_72);
        var_75 = wp::extract(var_51, var_74);
        var_76 = wp::min(var_73, var_75);
        var_78 = wp::extract(var_22, var_77);
        var_80 = wp::extract(var_51, var_79);
        var_81 = wp::min(var_78, var_80);
        var_83 = wp::extract(var_22, var_82);
        var_85 = wp::extract(var_51, var_84);
        var_86 = wp::min(var_83, var_85);
        var_87 = wp::vec_t<3, wp::float32>(var_76, var_81, var_86);
        // high = vec3(min(high[0], b[0]), min(high[1], b[1]), min(high[2], b[2]))                <L 27>
        var_89 = wp::extract(var_23, var_88);
        var_91 = wp::extract(var_54, var_90);
        var_92 = wp::min(var_89, var_91);
        var_94 = wp::extract(var_23, var_93);
        var_96 = wp::extract(var_54, var_95);
        var_97 = wp::min(var_94, var_96);
        var_99 = wp::extract(var_23, var_98);
        var_101 = wp::extract(var_54, var_100);
        var_102 = wp::min(var_99, var_101);
        var_103 = wp::vec_t<3, wp::float32>(var_92, var_97, var_102);
        // position = bucket * BUCKET + half * WARP + lane                                        <L 11>
        var_105 = wp::mul(var_2, var_12);
        var_106 = wp::mul(var_104, var_1);
        var_107 = wp::add(var_105, var_106);
        var_108 = wp::add(var_107, var_3);
        // a = vec3(INFINITY, INFINITY, INFINITY)                                                 <L 12>
        var_109 = wp::vec_t<3, wp::float32>(var_21, var_21, var_21);
        // b = vec3(INFINITY, INFINITY, INFINITY)                                                 <L 13>
        var_110 = wp::vec_t<3, wp::float32>(var_21, var_21, var_21);
        // if position < tree__count:                                                             <L 14>
        var_111 = (var_108 < var_tree__count);
        if (var_111) {
            // p = source[tree__order[position]]                                                  <L 15>
            var_112 = wp::address(var_tree__order, var_108);
            var_113 = wp::load(var_112);
            var_114 = wp::address(var_source, var_113);
            var_116 = wp::load(var_114);
            var_115 = wp::copy(var_116);
            // tree__points[position] = p                                                         <L 16>
            wp::array_store(var_tree__points, var_108, var_115);
            // if isfinite(p):                                                                    <L 17>
            var_117 = wp::isfinite(var_115);
            if (var_117) {
                // a = p                                                                          <L 18>
                var_118 = wp::copy(var_115);
                // b = -p                                                                         <L 19>
                var_119 = wp::neg(var_115);
            }
            var_120 = wp::where(var_117, var_118, var_109);
            var_121 = wp::where(var_117, var_119, var_110);
        }
        if (!var_111) {
            // elif position < tree__points.shape[0]:                                             <L 20>
            var_122 = &(var_tree__points.shape);
            var_125 = wp::load(var_122);
            var_124 = wp::extract(var_125, var_123);
            var_126 = (var_108 < var_124);
            if (var_126) {
                // tree__points[position] = a                                                     <L 21>
                wp::array_store(var_tree__points, var_108, var_109);
            }
        }
        var_127 = wp::where(var_111, var_120, var_109);
        var_128 = wp::where(var_111, var_121, var_110);
        var_129 = wp::where(var_111, var_115, var_35);
        // a = lowest_of_lanes(a, 0, 3)                                                           <L 22>
        var_132 = lowest_of_lanes_on_cuda_0(var_127, var_130, var_131);
        // b = lowest_of_lanes(b, 0, 3)                                                           <L 23>
        var_135 = lowest_of_lanes_on_cuda_0(var_128, var_133, var_134);
        // if bucket < tree__codes.shape[0]:                                                      <L 24>
        var_136 = &(var_tree__codes.shape);
        var_139 = wp::load(var_136);
        var_138 = wp::extract(var_139, var_137);
        var_140 = (var_2 < var_138);
        if (var_140) {
            // write_side(lane % LEAF, a, -b, bucket * SIDES + half * (FAN // 2) + lane // LEAF, tree__boxes)       <L 25>
            var_141 = wp::mod(var_3, var_60);
            var_142 = wp::neg(var_135);
            var_143 = wp::mul(var_2, var_63);
            var_145 = wp::floordiv(var_65, var_144);
            var_146 = wp::mul(var_104, var_145);
            var_147 = wp::add(var_143, var_146);
            var_148 = wp::floordiv(var_3, var_60);
            var_149 = wp::add(var_147, var_148);
            write_side_on_cuda_0(var_141, var_132, var_142, var_149, var_tree__boxes);
        }
        // low = vec3(min(low[0], a[0]), min(low[1], a[1]), min(low[2], a[2]))                    <L 26>
        var_151 = wp::extract(var_87, var_150);
        var_153 = wp::extract(var_132, var_152);
        var_154 = wp::min(var_151, var_153);
        var_156 = wp::extract(var_87, var_155);
        var_158 = wp::extract(var_132, var_157);
        var_159 = wp::min(var_156, var_158);
        var_161 = wp::extract(var_87, var_160);
        var_163 = wp::extract(var_132, var_162);
        var_164 = wp::min(var_161, var_163);
        var_165 = wp::vec_t<3, wp::float32>(var_154, var_159, var_164);
        // high = vec3(min(high[0], b[0]), min(high[1], b[1]), min(high[2], b[2]))                <L 27>
        var_167 = wp::extract(var_103, var_166);
        var_169 = wp::extract(var_135, var_168);
        var_170 = wp::min(var_167, var_169);
        var_172 = wp::extract(var_103, var_171);
        var_174 = wp::extract(var_135, var_173);
        var_175 = wp::min(var_172, var_174);
        var_177 = wp::extract(var_103, var_176);
        var_179 = wp::extract(var_135, var_178);
        var_180 = wp::min(var_177, var_179);
        var_181 = wp::vec_t<3, wp::float32>(var_170, var_175, var_180);
        // low = lowest_of_lanes(low, 3, 5)                                                       <L 28>
        var_184 = lowest_of_lanes_on_cuda_0(var_165, var_182, var_183);
        // high = lowest_of_lanes(high, 3, 5)                                                     <L 29>
        var_187 = lowest_of_lanes_on_cuda_0(var_181, var_185, var_186);
        // if tree__root > 0:                                                                     <L 30>
        var_189 = (var_tree__root > var_188);
        if (var_189) {
            // write_side(lane, low, -high, (tree__levels[1] + bucket // FAN) * SIDES + bucket % FAN, tree__boxes)       <L 31>
            var_190 = wp::neg(var_187);
            var_192 = wp::address(var_tree__levels, var_191);
            var_193 = wp::floordiv(var_2, var_65);
            var_195 = wp::load(var_192);
            var_194 = wp::add(var_195, var_193);
            var_196 = wp::mul(var_194, var_63);
            var_197 = wp::mod(var_2, var_65);
            var_198 = wp::add(var_196, var_197);
            write_side_on_cuda_0(var_3, var_184, var_190, var_198, var_tree__boxes);
        }
}


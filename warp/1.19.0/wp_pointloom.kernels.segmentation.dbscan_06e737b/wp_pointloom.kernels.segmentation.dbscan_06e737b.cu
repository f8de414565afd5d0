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


// /work/main/src/pointloom/kernels/search/tree_walk.py:185
static CUDA_CALLABLE wp::vec_t<3, wp::float32> box_corner_0(
    wp::array_t<wp::float32> var_boxes,
    wp::int32 var_leaf,
    wp::int32 var_side)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 3;
    wp::int32 var_1;
    const wp::int32 var_2 = 48;
    wp::int32 var_3;
    const wp::int32 var_4 = 8;
    const wp::int32 var_5 = 1;
    wp::int32 var_6;
    wp::int32 var_7;
    wp::int32 var_8;
    const wp::int32 var_9 = 3;
    wp::int32 var_10;
    wp::int32 var_11;
    wp::int32 var_12;
    wp::float32* var_13;
    wp::int32 var_14;
    wp::float32* var_15;
    const wp::int32 var_16 = 2;
    wp::int32 var_17;
    wp::int32 var_18;
    wp::float32* var_19;
    wp::vec_t<3, wp::float32> var_20;
    wp::float32 var_21;
    wp::float32 var_22;
    wp::float32 var_23;
    //---------
    // forward
    // def box_corner(boxes: array(dtype=float32), leaf: int, side: int) -> vec3:             <L 186>
    // at = (leaf >> FAN_BITS) * SIDES + (leaf & (FAN - 1)) + 3 * side * FAN                  <L 187>
    var_1 = wp::rshift(var_leaf, var_0);
    var_3 = wp::mul(var_1, var_2);
    var_6 = wp::sub(var_4, var_5);
    var_7 = wp::bit_and(var_leaf, var_6);
    var_8 = wp::add(var_3, var_7);
    var_10 = wp::mul(var_9, var_side);
    var_11 = wp::mul(var_10, var_4);
    var_12 = wp::add(var_8, var_11);
    // return vec3(boxes[at], boxes[at + FAN], boxes[at + 2 * FAN])                           <L 188>
    var_13 = wp::address(var_boxes, var_12);
    var_14 = wp::add(var_12, var_4);
    var_15 = wp::address(var_boxes, var_14);
    var_17 = wp::mul(var_16, var_4);
    var_18 = wp::add(var_12, var_17);
    var_19 = wp::address(var_boxes, var_18);
    var_21 = wp::load(var_13);
    var_22 = wp::load(var_15);
    var_23 = wp::load(var_19);
    var_20 = wp::vec_t<3, wp::float32>(var_21, var_22, var_23);
    return var_20;
}


// <pointloom.kernels.search.tree_walk.begin_traversal>:1
static CUDA_CALLABLE wp::vec_t<4, wp::int64> begin_traversal_0(
    wp::int32 var_level,
    wp::int32 var_node)
{
    //---------
    // primal vars
    wp::int64 var_0;
    wp::int64 var_1;
    wp::int64 var_2;
    wp::int64 var_3;
    wp::vec_t<4, wp::int64> var_4;
    //---------
    // forward
    // def begin_traversal(level, node):                                                      <L 1>
    // return traversal(int64(level), int64(level), int64(node), int64(0))                    <L 3>
    var_0 = wp::int64(var_level);
    var_1 = wp::int64(var_level);
    var_2 = wp::int64(var_node);
    var_3 = 0ll;
    var_4 = wp::vec_t<4, wp::int64>(var_0, var_1, var_2, var_3);
    return var_4;
}


// /work/main/src/pointloom/kernels/search/bucket_walk.py:35
static CUDA_CALLABLE wp::int64 byte_shift_0(
    wp::int32 var_level)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 8;
    const wp::int32 var_1 = 1;
    wp::int32 var_2;
    const wp::int32 var_3 = 0;
    wp::int32 var_4;
    wp::int32 var_5;
    wp::int64 var_6;
    //---------
    // forward
    // def byte_shift(level: int) -> int64:                                                   <L 36>
    // return int64(FAN * max(level - 1, 0))                                                  <L 38>
    var_2 = wp::sub(var_level, var_1);
    var_4 = wp::max(var_2, var_3);
    var_5 = wp::mul(var_0, var_4);
    var_6 = wp::int64(var_5);
    return var_6;
}


// /work/main/src/pointloom/kernels/search/tree_walk.py:40
static CUDA_CALLABLE wp::int64 pending_shift_0(
    wp::int32 var_level)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 1;
    wp::int32 var_1;
    wp::int64 var_2;
    //---------
    // forward
    // def pending_shift(level: int) -> int64:                                                <L 41>
    // return byte_shift(level - 1)                                                           <L 43>
    var_1 = wp::sub(var_level, var_0);
    var_2 = byte_shift_0(var_1);
    return var_2;
}


// /work/main/src/pointloom/kernels/search/tree_walk.py:20
static CUDA_CALLABLE wp::int32 lowest_bit_0(
    wp::int32 var_bits)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32 var_1;
    const wp::int32 var_2 = 1;
    wp::int32 var_3;
    wp::int32 var_4;
    //---------
    // forward
    // def lowest_bit(bits: int) -> int:                                                      <L 21>
    // return bit_count((bits & (-bits)) - 1)                                                 <L 22>
    var_0 = wp::neg(var_bits);
    var_1 = wp::bit_and(var_bits, var_0);
    var_3 = wp::sub(var_1, var_2);
    var_4 = wp::bit_count(var_3);
    return var_4;
}


// <pointloom.kernels.search.tree_walk.next_node>:1
static CUDA_CALLABLE wp::vec_t<4, wp::int64> next_node_0(
    wp::vec_t<4, wp::int64> var_step,
    wp::int32 var_top)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int64 var_1;
    wp::int32 var_2;
    const wp::int32 var_3 = 1;
    wp::int64 var_4;
    wp::int32 var_5;
    const wp::int32 var_6 = 2;
    wp::int64 var_7;
    wp::int32 var_8;
    const wp::int32 var_9 = 3;
    wp::int64 var_10;
    const wp::int32 var_11 = 1;
    wp::int32 var_12;
    const wp::int32 var_13 = 1;
    bool var_14;
    const wp::int32 var_15 = 0;
    wp::int32 var_16;
    const wp::int32 var_17 = 1;
    bool var_18;
    wp::int64 var_19;
    wp::int64 var_20;
    wp::int32 var_21;
    const wp::int32 var_22 = 255;
    wp::int32 var_23;
    wp::int32 var_24;
    const wp::int32 var_25 = 0;
    bool var_26;
    wp::int32 var_27;
    wp::int64 var_28;
    wp::int64 var_29;
    wp::int64 var_30;
    wp::int64 var_31;
    wp::int64 var_32;
    wp::int64 var_33;
    const wp::int32 var_34 = 8;
    wp::int32 var_35;
    wp::int32 var_36;
    const wp::int32 var_37 = 1;
    wp::int32 var_38;
    const wp::int32 var_39 = 0;
    const wp::int32 var_40 = 3;
    wp::int32 var_41;
    const wp::int32 var_42 = 1;
    wp::int32 var_43;
    bool var_44;
    const wp::int32 var_45 = 1;
    wp::int32 var_46;
    const wp::int32 var_47 = 0;
    wp::int32 var_48;
    wp::int32 var_49;
    wp::int32 var_50;
    wp::int32 var_51;
    wp::int32 var_52;
    wp::int64 var_53;
    wp::int32 var_54;
    wp::int64 var_55;
    wp::int64 var_56;
    wp::int64 var_57;
    wp::vec_t<4, wp::int64> var_58;
    //---------
    // forward
    // def next_node(step, top):                                                              <L 1>
    // height = int(step[0])                                                                  <L 3>
    var_1 = wp::extract(var_step, var_0);
    var_2 = wp::int(var_1);
    // level = int(step[1])                                                                   <L 4>
    var_4 = wp::extract(var_step, var_3);
    var_5 = wp::int(var_4);
    // node = int(step[2])                                                                    <L 5>
    var_7 = wp::extract(var_step, var_6);
    var_8 = wp::int(var_7);
    // pending = step[3]                                                                      <L 6>
    var_10 = wp::extract(var_step, var_9);
    // searching = int(1)                                                                     <L 7>
    var_12 = wp::int(var_11);
    // while searching == 1:                                                                  <L 8>
    start_while_0:;
    var_14 = (var_12 == var_13);
    if ((var_14) == false) goto end_while_0;
        // left = int(0)                                                                      <L 9>
        var_16 = wp::int(var_15);
        // if level > 1:                                                                      <L 10>
        var_18 = (var_5 > var_17);
        if (var_18) {
            // left = int(pending >> pending_shift(level)) & BYTE                             <L 11>
            var_19 = pending_shift_0(var_5);
            var_20 = wp::rshift(var_10, var_19);
            var_21 = wp::int(var_20);
            var_23 = wp::bit_and(var_21, var_22);
        }
        var_24 = wp::where(var_18, var_23, var_16);
        // if left != 0:                                                                      <L 12>
        var_26 = (var_24 != var_25);
        if (var_26) {
            // child = lowest_bit(left)                                                       <L 13>
            var_27 = lowest_bit_0(var_24);
            // pending = pending ^ int64(1) << pending_shift(level) + int64(child)            <L 14>
            var_28 = 1ll;
            var_29 = pending_shift_0(var_5);
            var_30 = wp::int64(var_27);
            var_31 = wp::add(var_29, var_30);
            var_32 = wp::lshift(var_28, var_31);
            var_33 = wp::bit_xor(var_10, var_32);
            // node = node * FAN + child                                                      <L 15>
            var_35 = wp::mul(var_8, var_34);
            var_36 = wp::add(var_35, var_27);
            // level = level - 1                                                              <L 16>
            var_38 = wp::sub(var_5, var_37);
            // searching = 0                                                                  <L 17>
        }
        if (!var_26) {
            // node = node >> FAN_BITS                                                        <L 19>
            var_41 = wp::rshift(var_8, var_40);
            // level = level + 1                                                              <L 20>
            var_43 = wp::add(var_5, var_42);
            // if level > height:                                                             <L 21>
            var_44 = (var_43 > var_2);
            if (var_44) {
                // height = height + 1                                                        <L 22>
                var_46 = wp::add(var_2, var_45);
                // searching = 0                                                              <L 23>
            }
            var_48 = wp::where(var_44, var_46, var_2);
            var_49 = wp::where(var_44, var_47, var_12);
        }
        var_50 = wp::where(var_26, var_2, var_48);
        var_51 = wp::where(var_26, var_38, var_43);
        var_52 = wp::where(var_26, var_36, var_41);
        var_53 = wp::where(var_26, var_33, var_10);
        var_54 = wp::where(var_26, var_39, var_49);
        wp::assign(var_2, var_50);
        wp::assign(var_5, var_51);
        wp::assign(var_8, var_52);
        wp::assign(var_10, var_53);
        wp::assign(var_12, var_54);
    goto start_while_0;
    end_while_0:;
    // return traversal(int64(height), int64(level), int64(node), pending)                    <L 24>
    var_55 = wp::int64(var_2);
    var_56 = wp::int64(var_5);
    var_57 = wp::int64(var_8);
    var_58 = wp::vec_t<4, wp::int64>(var_55, var_56, var_57, var_10);
    return var_58;
}


// /work/main/src/pointloom/kernels/segmentation/dbscan.py:76
static CUDA_CALLABLE wp::int32 minimum_of_0(
    wp::vec_t<8, wp::int32> var_values)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    const wp::int32 var_2 = 1;
    wp::int32 var_3;
    wp::int32 var_4;
    const wp::int32 var_5 = 2;
    wp::int32 var_6;
    wp::int32 var_7;
    const wp::int32 var_8 = 3;
    wp::int32 var_9;
    wp::int32 var_10;
    const wp::int32 var_11 = 4;
    wp::int32 var_12;
    wp::int32 var_13;
    const wp::int32 var_14 = 5;
    wp::int32 var_15;
    wp::int32 var_16;
    const wp::int32 var_17 = 6;
    wp::int32 var_18;
    wp::int32 var_19;
    const wp::int32 var_20 = 7;
    wp::int32 var_21;
    wp::int32 var_22;
    //---------
    // forward
    // def minimum_of(values: numbers) -> int:                                                <L 77>
    // minimum = values[0]                                                                    <L 78>
    var_1 = wp::extract(var_values, var_0);
    // for j in range(1, LEAF):                                                               <L 79>
    // minimum = min(minimum, values[j])                                                      <L 80>
    var_3 = wp::extract(var_values, var_2);
    var_4 = wp::min(var_1, var_3);
    var_6 = wp::extract(var_values, var_5);
    var_7 = wp::min(var_4, var_6);
    var_9 = wp::extract(var_values, var_8);
    var_10 = wp::min(var_7, var_9);
    var_12 = wp::extract(var_values, var_11);
    var_13 = wp::min(var_10, var_12);
    var_15 = wp::extract(var_values, var_14);
    var_16 = wp::min(var_13, var_15);
    var_18 = wp::extract(var_values, var_17);
    var_19 = wp::min(var_16, var_18);
    var_21 = wp::extract(var_values, var_20);
    var_22 = wp::min(var_19, var_21);
    // return minimum                                                                         <L 81>
    return var_22;
}


// /work/main/src/pointloom/kernels/search/tree_walk.py:34
static CUDA_CALLABLE wp::int32 record_of_0(
    wp::array_t<wp::int32> var_levels,
    wp::int32 var_level,
    wp::int32 var_node)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 1;
    wp::int32 var_1;
    wp::int32* var_2;
    wp::int32 var_3;
    wp::int32 var_4;
    //---------
    // forward
    // def record_of(levels: array(dtype=int32), level: int, node: int) -> int:               <L 35>
    // return levels[level - 1] + node                                                        <L 37>
    var_1 = wp::sub(var_level, var_0);
    var_2 = wp::address(var_levels, var_1);
    var_4 = wp::load(var_2);
    var_3 = wp::add(var_4, var_node);
    return var_3;
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


// /work/main/src/pointloom/kernels/search/point_tree.py:388
static CUDA_CALLABLE wp::vec_t<8, wp::float32> measure_boxes_0(
    wp::array_t<wp::float32> var_boxes,
    wp::int32 var_node,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 48;
    wp::int32 var_1;
    const wp::float32 var_2 = 0.0;
    wp::vec_t<8, wp::float32> var_3;
    const wp::int32 var_4 = 0;
    wp::int32 var_5;
    wp::float32* var_6;
    const wp::int32 var_7 = 0;
    wp::float32 var_8;
    wp::float32 var_9;
    wp::float32 var_10;
    const wp::int32 var_11 = 0;
    wp::float32 var_12;
    wp::int32 var_13;
    const wp::int32 var_14 = 3;
    const wp::int32 var_15 = 8;
    wp::int32 var_16;
    wp::int32 var_17;
    wp::float32* var_18;
    wp::float32 var_19;
    wp::float32 var_20;
    wp::float32 var_21;
    const wp::float32 var_22 = 0.0;
    wp::float32 var_23;
    wp::int32 var_24;
    wp::int32 var_25;
    wp::float32* var_26;
    const wp::int32 var_27 = 1;
    wp::float32 var_28;
    wp::float32 var_29;
    wp::float32 var_30;
    const wp::int32 var_31 = 1;
    wp::float32 var_32;
    wp::int32 var_33;
    const wp::int32 var_34 = 4;
    wp::int32 var_35;
    wp::int32 var_36;
    wp::float32* var_37;
    wp::float32 var_38;
    wp::float32 var_39;
    wp::float32 var_40;
    const wp::float32 var_41 = 0.0;
    wp::float32 var_42;
    wp::int32 var_43;
    const wp::int32 var_44 = 2;
    wp::int32 var_45;
    wp::int32 var_46;
    wp::float32* var_47;
    const wp::int32 var_48 = 2;
    wp::float32 var_49;
    wp::float32 var_50;
    wp::float32 var_51;
    const wp::int32 var_52 = 2;
    wp::float32 var_53;
    wp::int32 var_54;
    const wp::int32 var_55 = 5;
    wp::int32 var_56;
    wp::int32 var_57;
    wp::float32* var_58;
    wp::float32 var_59;
    wp::float32 var_60;
    wp::float32 var_61;
    const wp::float32 var_62 = 0.0;
    wp::float32 var_63;
    wp::float32 var_64;
    wp::float32 var_65;
    wp::float32 var_66;
    wp::float32 var_67;
    wp::float32 var_68;
    const wp::int32 var_69 = 1;
    wp::int32 var_70;
    wp::float32* var_71;
    const wp::int32 var_72 = 0;
    wp::float32 var_73;
    wp::float32 var_74;
    wp::float32 var_75;
    const wp::int32 var_76 = 0;
    wp::float32 var_77;
    wp::int32 var_78;
    const wp::int32 var_79 = 3;
    wp::int32 var_80;
    wp::int32 var_81;
    wp::float32* var_82;
    wp::float32 var_83;
    wp::float32 var_84;
    wp::float32 var_85;
    const wp::float32 var_86 = 0.0;
    wp::float32 var_87;
    wp::int32 var_88;
    wp::int32 var_89;
    wp::float32* var_90;
    const wp::int32 var_91 = 1;
    wp::float32 var_92;
    wp::float32 var_93;
    wp::float32 var_94;
    const wp::int32 var_95 = 1;
    wp::float32 var_96;
    wp::int32 var_97;
    const wp::int32 var_98 = 4;
    wp::int32 var_99;
    wp::int32 var_100;
    wp::float32* var_101;
    wp::float32 var_102;
    wp::float32 var_103;
    wp::float32 var_104;
    const wp::float32 var_105 = 0.0;
    wp::float32 var_106;
    wp::int32 var_107;
    const wp::int32 var_108 = 2;
    wp::int32 var_109;
    wp::int32 var_110;
    wp::float32* var_111;
    const wp::int32 var_112 = 2;
    wp::float32 var_113;
    wp::float32 var_114;
    wp::float32 var_115;
    const wp::int32 var_116 = 2;
    wp::float32 var_117;
    wp::int32 var_118;
    const wp::int32 var_119 = 5;
    wp::int32 var_120;
    wp::int32 var_121;
    wp::float32* var_122;
    wp::float32 var_123;
    wp::float32 var_124;
    wp::float32 var_125;
    const wp::float32 var_126 = 0.0;
    wp::float32 var_127;
    wp::float32 var_128;
    wp::float32 var_129;
    wp::float32 var_130;
    wp::float32 var_131;
    wp::float32 var_132;
    const wp::int32 var_133 = 2;
    wp::int32 var_134;
    wp::float32* var_135;
    const wp::int32 var_136 = 0;
    wp::float32 var_137;
    wp::float32 var_138;
    wp::float32 var_139;
    const wp::int32 var_140 = 0;
    wp::float32 var_141;
    wp::int32 var_142;
    const wp::int32 var_143 = 3;
    wp::int32 var_144;
    wp::int32 var_145;
    wp::float32* var_146;
    wp::float32 var_147;
    wp::float32 var_148;
    wp::float32 var_149;
    const wp::float32 var_150 = 0.0;
    wp::float32 var_151;
    wp::int32 var_152;
    wp::int32 var_153;
    wp::float32* var_154;
    const wp::int32 var_155 = 1;
    wp::float32 var_156;
    wp::float32 var_157;
    wp::float32 var_158;
    const wp::int32 var_159 = 1;
    wp::float32 var_160;
    wp::int32 var_161;
    const wp::int32 var_162 = 4;
    wp::int32 var_163;
    wp::int32 var_164;
    wp::float32* var_165;
    wp::float32 var_166;
    wp::float32 var_167;
    wp::float32 var_168;
    const wp::float32 var_169 = 0.0;
    wp::float32 var_170;
    wp::int32 var_171;
    const wp::int32 var_172 = 2;
    wp::int32 var_173;
    wp::int32 var_174;
    wp::float32* var_175;
    const wp::int32 var_176 = 2;
    wp::float32 var_177;
    wp::float32 var_178;
    wp::float32 var_179;
    const wp::int32 var_180 = 2;
    wp::float32 var_181;
    wp::int32 var_182;
    const wp::int32 var_183 = 5;
    wp::int32 var_184;
    wp::int32 var_185;
    wp::float32* var_186;
    wp::float32 var_187;
    wp::float32 var_188;
    wp::float32 var_189;
    const wp::float32 var_190 = 0.0;
    wp::float32 var_191;
    wp::float32 var_192;
    wp::float32 var_193;
    wp::float32 var_194;
    wp::float32 var_195;
    wp::float32 var_196;
    const wp::int32 var_197 = 3;
    wp::int32 var_198;
    wp::float32* var_199;
    const wp::int32 var_200 = 0;
    wp::float32 var_201;
    wp::float32 var_202;
    wp::float32 var_203;
    const wp::int32 var_204 = 0;
    wp::float32 var_205;
    wp::int32 var_206;
    const wp::int32 var_207 = 3;
    wp::int32 var_208;
    wp::int32 var_209;
    wp::float32* var_210;
    wp::float32 var_211;
    wp::float32 var_212;
    wp::float32 var_213;
    const wp::float32 var_214 = 0.0;
    wp::float32 var_215;
    wp::int32 var_216;
    wp::int32 var_217;
    wp::float32* var_218;
    const wp::int32 var_219 = 1;
    wp::float32 var_220;
    wp::float32 var_221;
    wp::float32 var_222;
    const wp::int32 var_223 = 1;
    wp::float32 var_224;
    wp::int32 var_225;
    const wp::int32 var_226 = 4;
    wp::int32 var_227;
    wp::int32 var_228;
    wp::float32* var_229;
    wp::float32 var_230;
    wp::float32 var_231;
    wp::float32 var_232;
    const wp::float32 var_233 = 0.0;
    wp::float32 var_234;
    wp::int32 var_235;
    const wp::int32 var_236 = 2;
    wp::int32 var_237;
    wp::int32 var_238;
    wp::float32* var_239;
    const wp::int32 var_240 = 2;
    wp::float32 var_241;
    wp::float32 var_242;
    wp::float32 var_243;
    const wp::int32 var_244 = 2;
    wp::float32 var_245;
    wp::int32 var_246;
    const wp::int32 var_247 = 5;
    wp::int32 var_248;
    wp::int32 var_249;
    wp::float32* var_250;
    wp::float32 var_251;
    wp::float32 var_252;
    wp::float32 var_253;
    const wp::float32 var_254 = 0.0;
    wp::float32 var_255;
    wp::float32 var_256;
    wp::float32 var_257;
    wp::float32 var_258;
    wp::float32 var_259;
    wp::float32 var_260;
    const wp::int32 var_261 = 4;
    wp::int32 var_262;
    wp::float32* var_263;
    const wp::int32 var_264 = 0;
    wp::float32 var_265;
    wp::float32 var_266;
    wp::float32 var_267;
    const wp::int32 var_268 = 0;
    wp::float32 var_269;
    wp::int32 var_270;
    const wp::int32 var_271 = 3;
    wp::int32 var_272;
    wp::int32 var_273;
    wp::float32* var_274;
    wp::float32 var_275;
    wp::float32 var_276;
    wp::float32 var_277;
    const wp::float32 var_278 = 0.0;
    wp::float32 var_279;
    wp::int32 var_280;
    wp::int32 var_281;
    wp::float32* var_282;
    const wp::int32 var_283 = 1;
    wp::float32 var_284;
    wp::float32 var_285;
    wp::float32 var_286;
    const wp::int32 var_287 = 1;
    wp::float32 var_288;
    wp::int32 var_289;
    const wp::int32 var_290 = 4;
    wp::int32 var_291;
    wp::int32 var_292;
    wp::float32* var_293;
    wp::float32 var_294;
    wp::float32 var_295;
    wp::float32 var_296;
    const wp::float32 var_297 = 0.0;
    wp::float32 var_298;
    wp::int32 var_299;
    const wp::int32 var_300 = 2;
    wp::int32 var_301;
    wp::int32 var_302;
    wp::float32* var_303;
    const wp::int32 var_304 = 2;
    wp::float32 var_305;
    wp::float32 var_306;
    wp::float32 var_307;
    const wp::int32 var_308 = 2;
    wp::float32 var_309;
    wp::int32 var_310;
    const wp::int32 var_311 = 5;
    wp::int32 var_312;
    wp::int32 var_313;
    wp::float32* var_314;
    wp::float32 var_315;
    wp::float32 var_316;
    wp::float32 var_317;
    const wp::float32 var_318 = 0.0;
    wp::float32 var_319;
    wp::float32 var_320;
    wp::float32 var_321;
    wp::float32 var_322;
    wp::float32 var_323;
    wp::float32 var_324;
    const wp::int32 var_325 = 5;
    wp::int32 var_326;
    wp::float32* var_327;
    const wp::int32 var_328 = 0;
    wp::float32 var_329;
    wp::float32 var_330;
    wp::float32 var_331;
    const wp::int32 var_332 = 0;
    wp::float32 var_333;
    wp::int32 var_334;
    const wp::int32 var_335 = 3;
    wp::int32 var_336;
    wp::int32 var_337;
    wp::float32* var_338;
    wp::float32 var_339;
    wp::float32 var_340;
    wp::float32 var_341;
    const wp::float32 var_342 = 0.0;
    wp::float32 var_343;
    wp::int32 var_344;
    wp::int32 var_345;
    wp::float32* var_346;
    const wp::int32 var_347 = 1;
    wp::float32 var_348;
    wp::float32 var_349;
    wp::float32 var_350;
    const wp::int32 var_351 = 1;
    wp::float32 var_352;
    wp::int32 var_353;
    const wp::int32 var_354 = 4;
    wp::int32 var_355;
    wp::int32 var_356;
    wp::float32* var_357;
    wp::float32 var_358;
    wp::float32 var_359;
    wp::float32 var_360;
    const wp::float32 var_361 = 0.0;
    wp::float32 var_362;
    wp::int32 var_363;
    const wp::int32 var_364 = 2;
    wp::int32 var_365;
    wp::int32 var_366;
    wp::float32* var_367;
    const wp::int32 var_368 = 2;
    wp::float32 var_369;
    wp::float32 var_370;
    wp::float32 var_371;
    const wp::int32 var_372 = 2;
    wp::float32 var_373;
    wp::int32 var_374;
    const wp::int32 var_375 = 5;
    wp::int32 var_376;
    wp::int32 var_377;
    wp::float32* var_378;
    wp::float32 var_379;
    wp::float32 var_380;
    wp::float32 var_381;
    const wp::float32 var_382 = 0.0;
    wp::float32 var_383;
    wp::float32 var_384;
    wp::float32 var_385;
    wp::float32 var_386;
    wp::float32 var_387;
    wp::float32 var_388;
    const wp::int32 var_389 = 6;
    wp::int32 var_390;
    wp::float32* var_391;
    const wp::int32 var_392 = 0;
    wp::float32 var_393;
    wp::float32 var_394;
    wp::float32 var_395;
    const wp::int32 var_396 = 0;
    wp::float32 var_397;
    wp::int32 var_398;
    const wp::int32 var_399 = 3;
    wp::int32 var_400;
    wp::int32 var_401;
    wp::float32* var_402;
    wp::float32 var_403;
    wp::float32 var_404;
    wp::float32 var_405;
    const wp::float32 var_406 = 0.0;
    wp::float32 var_407;
    wp::int32 var_408;
    wp::int32 var_409;
    wp::float32* var_410;
    const wp::int32 var_411 = 1;
    wp::float32 var_412;
    wp::float32 var_413;
    wp::float32 var_414;
    const wp::int32 var_415 = 1;
    wp::float32 var_416;
    wp::int32 var_417;
    const wp::int32 var_418 = 4;
    wp::int32 var_419;
    wp::int32 var_420;
    wp::float32* var_421;
    wp::float32 var_422;
    wp::float32 var_423;
    wp::float32 var_424;
    const wp::float32 var_425 = 0.0;
    wp::float32 var_426;
    wp::int32 var_427;
    const wp::int32 var_428 = 2;
    wp::int32 var_429;
    wp::int32 var_430;
    wp::float32* var_431;
    const wp::int32 var_432 = 2;
    wp::float32 var_433;
    wp::float32 var_434;
    wp::float32 var_435;
    const wp::int32 var_436 = 2;
    wp::float32 var_437;
    wp::int32 var_438;
    const wp::int32 var_439 = 5;
    wp::int32 var_440;
    wp::int32 var_441;
    wp::float32* var_442;
    wp::float32 var_443;
    wp::float32 var_444;
    wp::float32 var_445;
    const wp::float32 var_446 = 0.0;
    wp::float32 var_447;
    wp::float32 var_448;
    wp::float32 var_449;
    wp::float32 var_450;
    wp::float32 var_451;
    wp::float32 var_452;
    const wp::int32 var_453 = 7;
    wp::int32 var_454;
    wp::float32* var_455;
    const wp::int32 var_456 = 0;
    wp::float32 var_457;
    wp::float32 var_458;
    wp::float32 var_459;
    const wp::int32 var_460 = 0;
    wp::float32 var_461;
    wp::int32 var_462;
    const wp::int32 var_463 = 3;
    wp::int32 var_464;
    wp::int32 var_465;
    wp::float32* var_466;
    wp::float32 var_467;
    wp::float32 var_468;
    wp::float32 var_469;
    const wp::float32 var_470 = 0.0;
    wp::float32 var_471;
    wp::int32 var_472;
    wp::int32 var_473;
    wp::float32* var_474;
    const wp::int32 var_475 = 1;
    wp::float32 var_476;
    wp::float32 var_477;
    wp::float32 var_478;
    const wp::int32 var_479 = 1;
    wp::float32 var_480;
    wp::int32 var_481;
    const wp::int32 var_482 = 4;
    wp::int32 var_483;
    wp::int32 var_484;
    wp::float32* var_485;
    wp::float32 var_486;
    wp::float32 var_487;
    wp::float32 var_488;
    const wp::float32 var_489 = 0.0;
    wp::float32 var_490;
    wp::int32 var_491;
    const wp::int32 var_492 = 2;
    wp::int32 var_493;
    wp::int32 var_494;
    wp::float32* var_495;
    const wp::int32 var_496 = 2;
    wp::float32 var_497;
    wp::float32 var_498;
    wp::float32 var_499;
    const wp::int32 var_500 = 2;
    wp::float32 var_501;
    wp::int32 var_502;
    const wp::int32 var_503 = 5;
    wp::int32 var_504;
    wp::int32 var_505;
    wp::float32* var_506;
    wp::float32 var_507;
    wp::float32 var_508;
    wp::float32 var_509;
    const wp::float32 var_510 = 0.0;
    wp::float32 var_511;
    wp::float32 var_512;
    wp::float32 var_513;
    wp::float32 var_514;
    wp::float32 var_515;
    wp::float32 var_516;
    //---------
    // forward
    // def measure_boxes(boxes: array(dtype=float32), node: int, a: vec3, b: vec3) -> box_distances:       <L 389>
    // at = node * SIDES                                                                      <L 391>
    var_1 = wp::mul(var_node, var_0);
    // distances = box_distances(0.0)                                                         <L 392>
    var_3 = wp::vec_t<8, wp::float32>(var_2);
    // for j in range(FAN):                                                                   <L 393>
    // x = larger(larger(boxes[at + j] - b[0], a[0] - boxes[at + j + 3 * FAN]), 0.0)          <L 394>
    var_5 = wp::add(var_1, var_4);
    var_6 = wp::address(var_boxes, var_5);
    var_8 = wp::extract(var_b, var_7);
    var_10 = wp::load(var_6);
    var_9 = wp::sub(var_10, var_8);
    var_12 = wp::extract(var_a, var_11);
    var_13 = wp::add(var_1, var_4);
    var_16 = wp::mul(var_14, var_15);
    var_17 = wp::add(var_13, var_16);
    var_18 = wp::address(var_boxes, var_17);
    var_20 = wp::load(var_18);
    var_19 = wp::sub(var_12, var_20);
    var_21 = larger_0(var_9, var_19);
    var_23 = larger_0(var_21, var_22);
    // y = larger(larger(boxes[at + j + FAN] - b[1], a[1] - boxes[at + j + 4 * FAN]), 0.0)       <L 395>
    var_24 = wp::add(var_1, var_4);
    var_25 = wp::add(var_24, var_15);
    var_26 = wp::address(var_boxes, var_25);
    var_28 = wp::extract(var_b, var_27);
    var_30 = wp::load(var_26);
    var_29 = wp::sub(var_30, var_28);
    var_32 = wp::extract(var_a, var_31);
    var_33 = wp::add(var_1, var_4);
    var_35 = wp::mul(var_34, var_15);
    var_36 = wp::add(var_33, var_35);
    var_37 = wp::address(var_boxes, var_36);
    var_39 = wp::load(var_37);
    var_38 = wp::sub(var_32, var_39);
    var_40 = larger_0(var_29, var_38);
    var_42 = larger_0(var_40, var_41);
    // z = larger(larger(boxes[at + j + 2 * FAN] - b[2], a[2] - boxes[at + j + 5 * FAN]), 0.0)       <L 396>
    var_43 = wp::add(var_1, var_4);
    var_45 = wp::mul(var_44, var_15);
    var_46 = wp::add(var_43, var_45);
    var_47 = wp::address(var_boxes, var_46);
    var_49 = wp::extract(var_b, var_48);
    var_51 = wp::load(var_47);
    var_50 = wp::sub(var_51, var_49);
    var_53 = wp::extract(var_a, var_52);
    var_54 = wp::add(var_1, var_4);
    var_56 = wp::mul(var_55, var_15);
    var_57 = wp::add(var_54, var_56);
    var_58 = wp::address(var_boxes, var_57);
    var_60 = wp::load(var_58);
    var_59 = wp::sub(var_53, var_60);
    var_61 = larger_0(var_50, var_59);
    var_63 = larger_0(var_61, var_62);
    // distances[j] = x * x + y * y + z * z                                                   <L 397>
    var_64 = wp::mul(var_23, var_23);
    var_65 = wp::mul(var_42, var_42);
    var_66 = wp::add(var_64, var_65);
    var_67 = wp::mul(var_63, var_63);
    var_68 = wp::add(var_66, var_67);
    wp::assign_inplace(var_3, var_4, var_68);
    // x = larger(larger(boxes[at + j] - b[0], a[0] - boxes[at + j + 3 * FAN]), 0.0)          <L 394>
    var_70 = wp::add(var_1, var_69);
    var_71 = wp::address(var_boxes, var_70);
    var_73 = wp::extract(var_b, var_72);
    var_75 = wp::load(var_71);
    var_74 = wp::sub(var_75, var_73);
    var_77 = wp::extract(var_a, var_76);
    var_78 = wp::add(var_1, var_69);
    var_80 = wp::mul(var_79, var_15);
    var_81 = wp::add(var_78, var_80);
    var_82 = wp::address(var_boxes, var_81);
    var_84 = wp::load(var_82);
    var_83 = wp::sub(var_77, var_84);
    var_85 = larger_0(var_74, var_83);
    var_87 = larger_0(var_85, var_86);
    // y = larger(larger(boxes[at + j + FAN] - b[1], a[1] - boxes[at + j + 4 * FAN]), 0.0)       <L 395>
    var_88 = wp::add(var_1, var_69);
    var_89 = wp::add(var_88, var_15);
    var_90 = wp::address(var_boxes, var_89);
    var_92 = wp::extract(var_b, var_91);
    var_94 = wp::load(var_90);
    var_93 = wp::sub(var_94, var_92);
    var_96 = wp::extract(var_a, var_95);
    var_97 = wp::add(var_1, var_69);
    var_99 = wp::mul(var_98, var_15);
    var_100 = wp::add(var_97, var_99);
    var_101 = wp::address(var_boxes, var_100);
    var_103 = wp::load(var_101);
    var_102 = wp::sub(var_96, var_103);
    var_104 = larger_0(var_93, var_102);
    var_106 = larger_0(var_104, var_105);
    // z = larger(larger(boxes[at + j + 2 * FAN] - b[2], a[2] - boxes[at + j + 5 * FAN]), 0.0)       <L 396>
    var_107 = wp::add(var_1, var_69);
    var_109 = wp::mul(var_108, var_15);
    var_110 = wp::add(var_107, var_109);
    var_111 = wp::address(var_boxes, var_110);
    var_113 = wp::extract(var_b, var_112);
    var_115 = wp::load(var_111);
    var_114 = wp::sub(var_115, var_113);
    var_117 = wp::extract(var_a, var_116);
    var_118 = wp::add(var_1, var_69);
    var_120 = wp::mul(var_119, var_15);
    var_121 = wp::add(var_118, var_120);
    var_122 = wp::address(var_boxes, var_121);
    var_124 = wp::load(var_122);
    var_123 = wp::sub(var_117, var_124);
    var_125 = larger_0(var_114, var_123);
    var_127 = larger_0(var_125, var_126);
    // distances[j] = x * x + y * y + z * z                                                   <L 397>
    var_128 = wp::mul(var_87, var_87);
    var_129 = wp::mul(var_106, var_106);
    var_130 = wp::add(var_128, var_129);
    var_131 = wp::mul(var_127, var_127);
    var_132 = wp::add(var_130, var_131);
    wp::assign_inplace(var_3, var_69, var_132);
    // x = larger(larger(boxes[at + j] - b[0], a[0] - boxes[at + j + 3 * FAN]), 0.0)          <L 394>
    var_134 = wp::add(var_1, var_133);
    var_135 = wp::address(var_boxes, var_134);
    var_137 = wp::extract(var_b, var_136);
    var_139 = wp::load(var_135);
    var_138 = wp::sub(var_139, var_137);
    var_141 = wp::extract(var_a, var_140);
    var_142 = wp::add(var_1, var_133);
    var_144 = wp::mul(var_143, var_15);
    var_145 = wp::add(var_142, var_144);
    var_146 = wp::address(var_boxes, var_145);
    var_148 = wp::load(var_146);
    var_147 = wp::sub(var_141, var_148);
    var_149 = larger_0(var_138, var_147);
    var_151 = larger_0(var_149, var_150);
    // y = larger(larger(boxes[at + j + FAN] - b[1], a[1] - boxes[at + j + 4 * FAN]), 0.0)       <L 395>
    var_152 = wp::add(var_1, var_133);
    var_153 = wp::add(var_152, var_15);
    var_154 = wp::address(var_boxes, var_153);
    var_156 = wp::extract(var_b, var_155);
    var_158 = wp::load(var_154);
    var_157 = wp::sub(var_158, var_156);
    var_160 = wp::extract(var_a, var_159);
    var_161 = wp::add(var_1, var_133);
    var_163 = wp::mul(var_162, var_15);
    var_164 = wp::add(var_161, var_163);
    var_165 = wp::address(var_boxes, var_164);
    var_167 = wp::load(var_165);
    var_166 = wp::sub(var_160, var_167);
    var_168 = larger_0(var_157, var_166);
    var_170 = larger_0(var_168, var_169);
    // z = larger(larger(boxes[at + j + 2 * FAN] - b[2], a[2] - boxes[at + j + 5 * FAN]), 0.0)       <L 396>
    var_171 = wp::add(var_1, var_133);
    var_173 = wp::mul(var_172, var_15);
    var_174 = wp::add(var_171, var_173);
    var_175 = wp::address(var_boxes, var_174);
    var_177 = wp::extract(var_b, var_176);
    var_179 = wp::load(var_175);
    var_178 = wp::sub(var_179, var_177);
    var_181 = wp::extract(var_a, var_180);
    var_182 = wp::add(var_1, var_133);
    var_184 = wp::mul(var_183, var_15);
    var_185 = wp::add(var_182, var_184);
    var_186 = wp::address(var_boxes, var_185);
    var_188 = wp::load(var_186);
    var_187 = wp::sub(var_181, var_188);
    var_189 = larger_0(var_178, var_187);
    var_191 = larger_0(var_189, var_190);
    // distances[j] = x * x + y * y + z * z                                                   <L 397>
    var_192 = wp::mul(var_151, var_151);
    var_193 = wp::mul(var_170, var_170);
    var_194 = wp::add(var_192, var_193);
    var_195 = wp::mul(var_191, var_191);
    var_196 = wp::add(var_194, var_195);
    wp::assign_inplace(var_3, var_133, var_196);
    // x = larger(larger(boxes[at + j] - b[0], a[0] - boxes[at + j + 3 * FAN]), 0.0)          <L 394>
    var_198 = wp::add(var_1, var_197);
    var_199 = wp::address(var_boxes, var_198);
    var_201 = wp::extract(var_b, var_200);
    var_203 = wp::load(var_199);
    var_202 = wp::sub(var_203, var_201);
    var_205 = wp::extract(var_a, var_204);
    var_206 = wp::add(var_1, var_197);
    var_208 = wp::mul(var_207, var_15);
    var_209 = wp::add(var_206, var_208);
    var_210 = wp::address(var_boxes, var_209);
    var_212 = wp::load(var_210);
    var_211 = wp::sub(var_205, var_212);
    var_213 = larger_0(var_202, var_211);
    var_215 = larger_0(var_213, var_214);
    // y = larger(larger(boxes[at + j + FAN] - b[1], a[1] - boxes[at + j + 4 * FAN]), 0.0)       <L 395>
    var_216 = wp::add(var_1, var_197);
    var_217 = wp::add(var_216, var_15);
    var_218 = wp::address(var_boxes, var_217);
    var_220 = wp::extract(var_b, var_219);
    var_222 = wp::load(var_218);
    var_221 = wp::sub(var_222, var_220);
    var_224 = wp::extract(var_a, var_223);
    var_225 = wp::add(var_1, var_197);
    var_227 = wp::mul(var_226, var_15);
    var_228 = wp::add(var_225, var_227);
    var_229 = wp::address(var_boxes, var_228);
    var_231 = wp::load(var_229);
    var_230 = wp::sub(var_224, var_231);
    var_232 = larger_0(var_221, var_230);
    var_234 = larger_0(var_232, var_233);
    // z = larger(larger(boxes[at + j + 2 * FAN] - b[2], a[2] - boxes[at + j + 5 * FAN]), 0.0)       <L 396>
    var_235 = wp::add(var_1, var_197);
    var_237 = wp::mul(var_236, var_15);
    var_238 = wp::add(var_235, var_237);
    var_239 = wp::address(var_boxes, var_238);
    var_241 = wp::extract(var_b, var_240);
    var_243 = wp::load(var_239);
    var_242 = wp::sub(var_243, var_241);
    var_245 = wp::extract(var_a, var_244);
    var_246 = wp::add(var_1, var_197);
    var_248 = wp::mul(var_247, var_15);
    var_249 = wp::add(var_246, var_248);
    var_250 = wp::address(var_boxes, var_249);
    var_252 = wp::load(var_250);
    var_251 = wp::sub(var_245, var_252);
    var_253 = larger_0(var_242, var_251);
    var_255 = larger_0(var_253, var_254);
    // distances[j] = x * x + y * y + z * z                                                   <L 397>
    var_256 = wp::mul(var_215, var_215);
    var_257 = wp::mul(var_234, var_234);
    var_258 = wp::add(var_256, var_257);
    var_259 = wp::mul(var_255, var_255);
    var_260 = wp::add(var_258, var_259);
    wp::assign_inplace(var_3, var_197, var_260);
    // x = larger(larger(boxes[at + j] - b[0], a[0] - boxes[at + j + 3 * FAN]), 0.0)          <L 394>
    var_262 = wp::add(var_1, var_261);
    var_263 = wp::address(var_boxes, var_262);
    var_265 = wp::extract(var_b, var_264);
    var_267 = wp::load(var_263);
    var_266 = wp::sub(var_267, var_265);
    var_269 = wp::extract(var_a, var_268);
    var_270 = wp::add(var_1, var_261);
    var_272 = wp::mul(var_271, var_15);
    var_273 = wp::add(var_270, var_272);
    var_274 = wp::address(var_boxes, var_273);
    var_276 = wp::load(var_274);
    var_275 = wp::sub(var_269, var_276);
    var_277 = larger_0(var_266, var_275);
    var_279 = larger_0(var_277, var_278);
    // y = larger(larger(boxes[at + j + FAN] - b[1], a[1] - boxes[at + j + 4 * FAN]), 0.0)       <L 395>
    var_280 = wp::add(var_1, var_261);
    var_281 = wp::add(var_280, var_15);
    var_282 = wp::address(var_boxes, var_281);
    var_284 = wp::extract(var_b, var_283);
    var_286 = wp::load(var_282);
    var_285 = wp::sub(var_286, var_284);
    var_288 = wp::extract(var_a, var_287);
    var_289 = wp::add(var_1, var_261);
    var_291 = wp::mul(var_290, var_15);
    var_292 = wp::add(var_289, var_291);
    var_293 = wp::address(var_boxes, var_292);
    var_295 = wp::load(var_293);
    var_294 = wp::sub(var_288, var_295);
    var_296 = larger_0(var_285, var_294);
    var_298 = larger_0(var_296, var_297);
    // z = larger(larger(boxes[at + j + 2 * FAN] - b[2], a[2] - boxes[at + j + 5 * FAN]), 0.0)       <L 396>
    var_299 = wp::add(var_1, var_261);
    var_301 = wp::mul(var_300, var_15);
    var_302 = wp::add(var_299, var_301);
    var_303 = wp::address(var_boxes, var_302);
    var_305 = wp::extract(var_b, var_304);
    var_307 = wp::load(var_303);
    var_306 = wp::sub(var_307, var_305);
    var_309 = wp::extract(var_a, var_308);
    var_310 = wp::add(var_1, var_261);
    var_312 = wp::mul(var_311, var_15);
    var_313 = wp::add(var_310, var_312);
    var_314 = wp::address(var_boxes, var_313);
    var_316 = wp::load(var_314);
    var_315 = wp::sub(var_309, var_316);
    var_317 = larger_0(var_306, var_315);
    var_319 = larger_0(var_317, var_318);
    // distances[j] = x * x + y * y + z * z                                                   <L 397>
    var_320 = wp::mul(var_279, var_279);
    var_321 = wp::mul(var_298, var_298);
    var_322 = wp::add(var_320, var_321);
    var_323 = wp::mul(var_319, var_319);
    var_324 = wp::add(var_322, var_323);
    wp::assign_inplace(var_3, var_261, var_324);
    // x = larger(larger(boxes[at + j] - b[0], a[0] - boxes[at + j + 3 * FAN]), 0.0)          <L 394>
    var_326 = wp::add(var_1, var_325);
    var_327 = wp::address(var_boxes, var_326);
    var_329 = wp::extract(var_b, var_328);
    var_331 = wp::load(var_327);
    var_330 = wp::sub(var_331, var_329);
    var_333 = wp::extract(var_a, var_332);
    var_334 = wp::add(var_1, var_325);
    var_336 = wp::mul(var_335, var_15);
    var_337 = wp::add(var_334, var_336);
    var_338 = wp::address(var_boxes, var_337);
    var_340 = wp::load(var_338);
    var_339 = wp::sub(var_333, var_340);
    var_341 = larger_0(var_330, var_339);
    var_343 = larger_0(var_341, var_342);
    // y = larger(larger(boxes[at + j + FAN] - b[1], a[1] - boxes[at + j + 4 * FAN]), 0.0)       <L 395>
    var_344 = wp::add(var_1, var_325);
    var_345 = wp::add(var_344, var_15);
    var_346 = wp::address(var_boxes, var_345);
    var_348 = wp::extract(var_b, var_347);
    var_350 = wp::load(var_346);
    var_349 = wp::sub(var_350, var_348);
    var_352 = wp::extract(var_a, var_351);
    var_353 = wp::add(var_1, var_325);
    var_355 = wp::mul(var_354, var_15);
    var_356 = wp::add(var_353, var_355);
    var_357 = wp::address(var_boxes, var_356);
    var_359 = wp::load(var_357);
    var_358 = wp::sub(var_352, var_359);
    var_360 = larger_0(var_349, var_358);
    var_362 = larger_0(var_360, var_361);
    // z = larger(larger(boxes[at + j + 2 * FAN] - b[2], a[2] - boxes[at + j + 5 * FAN]), 0.0)       <L 396>
    var_363 = wp::add(var_1, var_325);
    var_365 = wp::mul(var_364, var_15);
    var_366 = wp::add(var_363, var_365);
    var_367 = wp::address(var_boxes, var_366);
    var_369 = wp::extract(var_b, var_368);
    var_371 = wp::load(var_367);
    var_370 = wp::sub(var_371, var_369);
    var_373 = wp::extract(var_a, var_372);
    var_374 = wp::add(var_1, var_325);
    var_376 = wp::mul(var_375, var_15);
    var_377 = wp::add(var_374, var_376);
    var_378 = wp::address(var_boxes, var_377);
    var_380 = wp::load(var_378);
    var_379 = wp::sub(var_373, var_380);
    var_381 = larger_0(var_370, var_379);
    var_383 = larger_0(var_381, var_382);
    // distances[j] = x * x + y * y + z * z                                                   <L 397>
    var_384 = wp::mul(var_343, var_343);
    var_385 = wp::mul(var_362, var_362);
    var_386 = wp::add(var_384, var_385);
    var_387 = wp::mul(var_383, var_383);
    var_388 = wp::add(var_386, var_387);
    wp::assign_inplace(var_3, var_325, var_388);
    // x = larger(larger(boxes[at + j] - b[0], a[0] - boxes[at + j + 3 * FAN]), 0.0)          <L 394>
    var_390 = wp::add(var_1, var_389);
    var_391 = wp::address(var_boxes, var_390);
    var_393 = wp::extract(var_b, var_392);
    var_395 = wp::load(var_391);
    var_394 = wp::sub(var_395, var_393);
    var_397 = wp::extract(var_a, var_396);
    var_398 = wp::add(var_1, var_389);
    var_400 = wp::mul(var_399, var_15);
    var_401 = wp::add(var_398, var_400);
    var_402 = wp::address(var_boxes, var_401);
    var_404 = wp::load(var_402);
    var_403 = wp::sub(var_397, var_404);
    var_405 = larger_0(var_394, var_403);
    var_407 = larger_0(var_405, var_406);
    // y = larger(larger(boxes[at + j + FAN] - b[1], a[1] - boxes[at + j + 4 * FAN]), 0.0)       <L 395>
    var_408 = wp::add(var_1, var_389);
    var_409 = wp::add(var_408, var_15);
    var_410 = wp::address(var_boxes, var_409);
    var_412 = wp::extract(var_b, var_411);
    var_414 = wp::load(var_410);
    var_413 = wp::sub(var_414, var_412);
    var_416 = wp::extract(var_a, var_415);
    var_417 = wp::add(var_1, var_389);
    var_419 = wp::mul(var_418, var_15);
    var_420 = wp::add(var_417, var_419);
    var_421 = wp::address(var_boxes, var_420);
    var_423 = wp::load(var_421);
    var_422 = wp::sub(var_416, var_423);
    var_424 = larger_0(var_413, var_422);
    var_426 = larger_0(var_424, var_425);
    // z = larger(larger(boxes[at + j + 2 * FAN] - b[2], a[2] - boxes[at + j + 5 * FAN]), 0.0)       <L 396>
    var_427 = wp::add(var_1, var_389);
    var_429 = wp::mul(var_428, var_15);
    var_430 = wp::add(var_427, var_429);
    var_431 = wp::address(var_boxes, var_430);
    var_433 = wp::extract(var_b, var_432);
    var_435 = wp::load(var_431);
    var_434 = wp::sub(var_435, var_433);
    var_437 = wp::extract(var_a, var_436);
    var_438 = wp::add(var_1, var_389);
    var_440 = wp::mul(var_439, var_15);
    var_441 = wp::add(var_438, var_440);
    var_442 = wp::address(var_boxes, var_441);
    var_444 = wp::load(var_442);
    var_443 = wp::sub(var_437, var_444);
    var_445 = larger_0(var_434, var_443);
    var_447 = larger_0(var_445, var_446);
    // distances[j] = x * x + y * y + z * z                                                   <L 397>
    var_448 = wp::mul(var_407, var_407);
    var_449 = wp::mul(var_426, var_426);
    var_450 = wp::add(var_448, var_449);
    var_451 = wp::mul(var_447, var_447);
    var_452 = wp::add(var_450, var_451);
    wp::assign_inplace(var_3, var_389, var_452);
    // x = larger(larger(boxes[at + j] - b[0], a[0] - boxes[at + j + 3 * FAN]), 0.0)          <L 394>
    var_454 = wp::add(var_1, var_453);
    var_455 = wp::address(var_boxes, var_454);
    var_457 = wp::extract(var_b, var_456);
    var_459 = wp::load(var_455);
    var_458 = wp::sub(var_459, var_457);
    var_461 = wp::extract(var_a, var_460);
    var_462 = wp::add(var_1, var_453);
    var_464 = wp::mul(var_463, var_15);
    var_465 = wp::add(var_462, var_464);
    var_466 = wp::address(var_boxes, var_465);
    var_468 = wp::load(var_466);
    var_467 = wp::sub(var_461, var_468);
    var_469 = larger_0(var_458, var_467);
    var_471 = larger_0(var_469, var_470);
    // y = larger(larger(boxes[at + j + FAN] - b[1], a[1] - boxes[at + j + 4 * FAN]), 0.0)       <L 395>
    var_472 = wp::add(var_1, var_453);
    var_473 = wp::add(var_472, var_15);
    var_474 = wp::address(var_boxes, var_473);
    var_476 = wp::extract(var_b, var_475);
    var_478 = wp::load(var_474);
    var_477 = wp::sub(var_478, var_476);
    var_480 = wp::extract(var_a, var_479);
    var_481 = wp::add(var_1, var_453);
    var_483 = wp::mul(var_482, var_15);
    var_484 = wp::add(var_481, var_483);
    var_485 = wp::address(var_boxes, var_484);
    var_487 = wp::load(var_485);
    var_486 = wp::sub(var_480, var_487);
    var_488 = larger_0(var_477, var_486);
    var_490 = larger_0(var_488, var_489);
    // z = larger(larger(boxes[at + j + 2 * FAN] - b[2], a[2] - boxes[at + j + 5 * FAN]), 0.0)       <L 396>
    var_491 = wp::add(var_1, var_453);
    var_493 = wp::mul(var_492, var_15);
    var_494 = wp::add(var_491, var_493);
    var_495 = wp::address(var_boxes, var_494);
    var_497 = wp::extract(var_b, var_496);
    var_499 = wp::load(var_495);
    var_498 = wp::sub(var_499, var_497);
    var_501 = wp::extract(var_a, var_500);
    var_502 = wp::add(var_1, var_453);
    var_504 = wp::mul(var_503, var_15);
    var_505 = wp::add(var_502, var_504);
    var_506 = wp::address(var_boxes, var_505);
    var_508 = wp::load(var_506);
    var_507 = wp::sub(var_501, var_508);
    var_509 = larger_0(var_498, var_507);
    var_511 = larger_0(var_509, var_510);
    // distances[j] = x * x + y * y + z * z                                                   <L 397>
    var_512 = wp::mul(var_471, var_471);
    var_513 = wp::mul(var_490, var_490);
    var_514 = wp::add(var_512, var_513);
    var_515 = wp::mul(var_511, var_511);
    var_516 = wp::add(var_514, var_515);
    wp::assign_inplace(var_3, var_453, var_516);
    // return distances                                                                       <L 398>
    return var_3;
}


// <pointloom.kernels.search.tree_walk.bits_within>:1
static CUDA_CALLABLE wp::int32 bits_within_0(
    wp::vec_t<8, wp::float32> var_distances,
    wp::float32 var_max_sqdist)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    const wp::int32 var_2 = 0;
    wp::float32 var_3;
    bool var_4;
    const wp::int32 var_5 = 1;
    wp::int32 var_6;
    const wp::int32 var_7 = 0;
    wp::int32 var_8;
    wp::int32 var_9;
    const wp::int32 var_10 = 1;
    wp::float32 var_11;
    bool var_12;
    const wp::int32 var_13 = 1;
    wp::int32 var_14;
    const wp::int32 var_15 = 0;
    wp::int32 var_16;
    wp::int32 var_17;
    const wp::int32 var_18 = 2;
    wp::float32 var_19;
    bool var_20;
    const wp::int32 var_21 = 1;
    wp::int32 var_22;
    const wp::int32 var_23 = 0;
    wp::int32 var_24;
    wp::int32 var_25;
    const wp::int32 var_26 = 3;
    wp::float32 var_27;
    bool var_28;
    const wp::int32 var_29 = 1;
    wp::int32 var_30;
    const wp::int32 var_31 = 0;
    wp::int32 var_32;
    wp::int32 var_33;
    const wp::int32 var_34 = 4;
    wp::float32 var_35;
    bool var_36;
    const wp::int32 var_37 = 1;
    wp::int32 var_38;
    const wp::int32 var_39 = 0;
    wp::int32 var_40;
    wp::int32 var_41;
    const wp::int32 var_42 = 5;
    wp::float32 var_43;
    bool var_44;
    const wp::int32 var_45 = 1;
    wp::int32 var_46;
    const wp::int32 var_47 = 0;
    wp::int32 var_48;
    wp::int32 var_49;
    const wp::int32 var_50 = 6;
    wp::float32 var_51;
    bool var_52;
    const wp::int32 var_53 = 1;
    wp::int32 var_54;
    const wp::int32 var_55 = 0;
    wp::int32 var_56;
    wp::int32 var_57;
    const wp::int32 var_58 = 7;
    wp::float32 var_59;
    bool var_60;
    const wp::int32 var_61 = 1;
    wp::int32 var_62;
    const wp::int32 var_63 = 0;
    wp::int32 var_64;
    wp::int32 var_65;
    //---------
    // forward
    // def bits_within(distances, max_sqdist):                                                <L 1>
    // bits = int(0)                                                                          <L 2>
    var_1 = wp::int(var_0);
    // for j in range(FAN):                                                                   <L 3>
    // bits = bits | (1 << j if distances[j] <= max_sqdist else 0)                            <L 4>
    var_3 = wp::extract(var_distances, var_2);
    var_4 = (var_3 <= var_max_sqdist);
    if (var_4) {
        var_6 = wp::lshift(var_5, var_2);
    }
    if (!var_4) {
    }
    var_8 = wp::where(var_4, var_6, var_7);
    var_9 = wp::bit_or(var_1, var_8);
    var_11 = wp::extract(var_distances, var_10);
    var_12 = (var_11 <= var_max_sqdist);
    if (var_12) {
        var_14 = wp::lshift(var_13, var_10);
    }
    if (!var_12) {
    }
    var_16 = wp::where(var_12, var_14, var_15);
    var_17 = wp::bit_or(var_9, var_16);
    var_19 = wp::extract(var_distances, var_18);
    var_20 = (var_19 <= var_max_sqdist);
    if (var_20) {
        var_22 = wp::lshift(var_21, var_18);
    }
    if (!var_20) {
    }
    var_24 = wp::where(var_20, var_22, var_23);
    var_25 = wp::bit_or(var_17, var_24);
    var_27 = wp::extract(var_distances, var_26);
    var_28 = (var_27 <= var_max_sqdist);
    if (var_28) {
        var_30 = wp::lshift(var_29, var_26);
    }
    if (!var_28) {
    }
    var_32 = wp::where(var_28, var_30, var_31);
    var_33 = wp::bit_or(var_25, var_32);
    var_35 = wp::extract(var_distances, var_34);
    var_36 = (var_35 <= var_max_sqdist);
    if (var_36) {
        var_38 = wp::lshift(var_37, var_34);
    }
    if (!var_36) {
    }
    var_40 = wp::where(var_36, var_38, var_39);
    var_41 = wp::bit_or(var_33, var_40);
    var_43 = wp::extract(var_distances, var_42);
    var_44 = (var_43 <= var_max_sqdist);
    if (var_44) {
        var_46 = wp::lshift(var_45, var_42);
    }
    if (!var_44) {
    }
    var_48 = wp::where(var_44, var_46, var_47);
    var_49 = wp::bit_or(var_41, var_48);
    var_51 = wp::extract(var_distances, var_50);
    var_52 = (var_51 <= var_max_sqdist);
    if (var_52) {
        var_54 = wp::lshift(var_53, var_50);
    }
    if (!var_52) {
    }
    var_56 = wp::where(var_52, var_54, var_55);
    var_57 = wp::bit_or(var_49, var_56);
    var_59 = wp::extract(var_distances, var_58);
    var_60 = (var_59 <= var_max_sqdist);
    if (var_60) {
        var_62 = wp::lshift(var_61, var_58);
    }
    if (!var_60) {
    }
    var_64 = wp::where(var_60, var_62, var_63);
    var_65 = wp::bit_or(var_57, var_64);
    // return bits                                                                            <L 5>
    return var_65;
}


// /work/main/src/pointloom/kernels/search/tree_walk.py:85
static CUDA_CALLABLE wp::int32 own_child_0(
    wp::int32 var_leaf,
    wp::int32 var_level)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 3;
    const wp::int32 var_1 = 1;
    wp::int32 var_2;
    wp::int32 var_3;
    wp::int32 var_4;
    const wp::int32 var_5 = 8;
    const wp::int32 var_6 = 1;
    wp::int32 var_7;
    wp::int32 var_8;
    //---------
    // forward
    // def own_child(leaf: int, level: int) -> int:                                           <L 86>
    // return (leaf >> (FAN_BITS * (level - 1))) & (FAN - 1)                                  <L 88>
    var_2 = wp::sub(var_level, var_1);
    var_3 = wp::mul(var_0, var_2);
    var_4 = wp::rshift(var_leaf, var_3);
    var_7 = wp::sub(var_5, var_6);
    var_8 = wp::bit_and(var_4, var_7);
    return var_8;
}


// /work/main/src/pointloom/kernels/search/tree_walk.py:91
static CUDA_CALLABLE wp::int32 other_children_0(
    wp::int32 var_leaf,
    wp::int32 var_height,
    wp::int32 var_level)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 255;
    wp::int32 var_1;
    bool var_2;
    const wp::int32 var_3 = 1;
    bool var_4;
    bool var_5;
    const wp::int32 var_6 = 1;
    wp::int32 var_7;
    wp::int32 var_8;
    wp::int32 var_9;
    wp::int32 var_10;
    //---------
    // forward
    // def other_children(leaf: int, height: int, level: int) -> int:                         <L 92>
    // others = int(BYTE)                                                                     <L 94>
    var_1 = wp::int(var_0);
    // if level > 1 and level == height:                                                      <L 95>
    var_4 = (var_level > var_3);
    var_2 = var_4;
    if (var_2) {
        var_5 = (var_level == var_height);
        var_2 = var_2 && var_5;
    }
    if (var_2) {
        // others = BYTE - (1 << own_child(leaf, level))                                      <L 96>
        var_7 = own_child_0(var_leaf, var_level);
        var_8 = wp::lshift(var_6, var_7);
        var_9 = wp::sub(var_0, var_8);
    }
    var_10 = wp::where(var_2, var_9, var_1);
    // return others                                                                          <L 97>
    return var_10;
}


// /work/main/src/pointloom/kernels/search/tree_walk.py:151
static CUDA_CALLABLE wp::vec_t<8, wp::float32> measure_farthest_0(
    wp::array_t<wp::float32> var_boxes,
    wp::int32 var_record,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 48;
    wp::int32 var_1;
    const wp::float32 var_2 = 0.0;
    wp::vec_t<8, wp::float32> var_3;
    const wp::int32 var_4 = 0;
    wp::int32 var_5;
    const wp::int32 var_6 = 3;
    const wp::int32 var_7 = 8;
    wp::int32 var_8;
    wp::int32 var_9;
    wp::float32* var_10;
    const wp::int32 var_11 = 0;
    wp::float32 var_12;
    wp::float32 var_13;
    wp::float32 var_14;
    const wp::int32 var_15 = 0;
    wp::float32 var_16;
    wp::int32 var_17;
    wp::float32* var_18;
    wp::float32 var_19;
    wp::float32 var_20;
    wp::float32 var_21;
    wp::int32 var_22;
    const wp::int32 var_23 = 4;
    wp::int32 var_24;
    wp::int32 var_25;
    wp::float32* var_26;
    const wp::int32 var_27 = 1;
    wp::float32 var_28;
    wp::float32 var_29;
    wp::float32 var_30;
    const wp::int32 var_31 = 1;
    wp::float32 var_32;
    wp::int32 var_33;
    wp::int32 var_34;
    wp::float32* var_35;
    wp::float32 var_36;
    wp::float32 var_37;
    wp::float32 var_38;
    wp::int32 var_39;
    const wp::int32 var_40 = 5;
    wp::int32 var_41;
    wp::int32 var_42;
    wp::float32* var_43;
    const wp::int32 var_44 = 2;
    wp::float32 var_45;
    wp::float32 var_46;
    wp::float32 var_47;
    const wp::int32 var_48 = 2;
    wp::float32 var_49;
    wp::int32 var_50;
    const wp::int32 var_51 = 2;
    wp::int32 var_52;
    wp::int32 var_53;
    wp::float32* var_54;
    wp::float32 var_55;
    wp::float32 var_56;
    wp::float32 var_57;
    wp::float32 var_58;
    wp::float32 var_59;
    wp::float32 var_60;
    wp::float32 var_61;
    wp::float32 var_62;
    const wp::int32 var_63 = 1;
    wp::int32 var_64;
    const wp::int32 var_65 = 3;
    wp::int32 var_66;
    wp::int32 var_67;
    wp::float32* var_68;
    const wp::int32 var_69 = 0;
    wp::float32 var_70;
    wp::float32 var_71;
    wp::float32 var_72;
    const wp::int32 var_73 = 0;
    wp::float32 var_74;
    wp::int32 var_75;
    wp::float32* var_76;
    wp::float32 var_77;
    wp::float32 var_78;
    wp::float32 var_79;
    wp::int32 var_80;
    const wp::int32 var_81 = 4;
    wp::int32 var_82;
    wp::int32 var_83;
    wp::float32* var_84;
    const wp::int32 var_85 = 1;
    wp::float32 var_86;
    wp::float32 var_87;
    wp::float32 var_88;
    const wp::int32 var_89 = 1;
    wp::float32 var_90;
    wp::int32 var_91;
    wp::int32 var_92;
    wp::float32* var_93;
    wp::float32 var_94;
    wp::float32 var_95;
    wp::float32 var_96;
    wp::int32 var_97;
    const wp::int32 var_98 = 5;
    wp::int32 var_99;
    wp::int32 var_100;
    wp::float32* var_101;
    const wp::int32 var_102 = 2;
    wp::float32 var_103;
    wp::float32 var_104;
    wp::float32 var_105;
    const wp::int32 var_106 = 2;
    wp::float32 var_107;
    wp::int32 var_108;
    const wp::int32 var_109 = 2;
    wp::int32 var_110;
    wp::int32 var_111;
    wp::float32* var_112;
    wp::float32 var_113;
    wp::float32 var_114;
    wp::float32 var_115;
    wp::float32 var_116;
    wp::float32 var_117;
    wp::float32 var_118;
    wp::float32 var_119;
    wp::float32 var_120;
    const wp::int32 var_121 = 2;
    wp::int32 var_122;
    const wp::int32 var_123 = 3;
    wp::int32 var_124;
    wp::int32 var_125;
    wp::float32* var_126;
    const wp::int32 var_127 = 0;
    wp::float32 var_128;
    wp::float32 var_129;
    wp::float32 var_130;
    const wp::int32 var_131 = 0;
    wp::float32 var_132;
    wp::int32 var_133;
    wp::float32* var_134;
    wp::float32 var_135;
    wp::float32 var_136;
    wp::float32 var_137;
    wp::int32 var_138;
    const wp::int32 var_139 = 4;
    wp::int32 var_140;
    wp::int32 var_141;
    wp::float32* var_142;
    const wp::int32 var_143 = 1;
    wp::float32 var_144;
    wp::float32 var_145;
    wp::float32 var_146;
    const wp::int32 var_147 = 1;
    wp::float32 var_148;
    wp::int32 var_149;
    wp::int32 var_150;
    wp::float32* var_151;
    wp::float32 var_152;
    wp::float32 var_153;
    wp::float32 var_154;
    wp::int32 var_155;
    const wp::int32 var_156 = 5;
    wp::int32 var_157;
    wp::int32 var_158;
    wp::float32* var_159;
    const wp::int32 var_160 = 2;
    wp::float32 var_161;
    wp::float32 var_162;
    wp::float32 var_163;
    const wp::int32 var_164 = 2;
    wp::float32 var_165;
    wp::int32 var_166;
    const wp::int32 var_167 = 2;
    wp::int32 var_168;
    wp::int32 var_169;
    wp::float32* var_170;
    wp::float32 var_171;
    wp::float32 var_172;
    wp::float32 var_173;
    wp::float32 var_174;
    wp::float32 var_175;
    wp::float32 var_176;
    wp::float32 var_177;
    wp::float32 var_178;
    const wp::int32 var_179 = 3;
    wp::int32 var_180;
    const wp::int32 var_181 = 3;
    wp::int32 var_182;
    wp::int32 var_183;
    wp::float32* var_184;
    const wp::int32 var_185 = 0;
    wp::float32 var_186;
    wp::float32 var_187;
    wp::float32 var_188;
    const wp::int32 var_189 = 0;
    wp::float32 var_190;
    wp::int32 var_191;
    wp::float32* var_192;
    wp::float32 var_193;
    wp::float32 var_194;
    wp::float32 var_195;
    wp::int32 var_196;
    const wp::int32 var_197 = 4;
    wp::int32 var_198;
    wp::int32 var_199;
    wp::float32* var_200;
    const wp::int32 var_201 = 1;
    wp::float32 var_202;
    wp::float32 var_203;
    wp::float32 var_204;
    const wp::int32 var_205 = 1;
    wp::float32 var_206;
    wp::int32 var_207;
    wp::int32 var_208;
    wp::float32* var_209;
    wp::float32 var_210;
    wp::float32 var_211;
    wp::float32 var_212;
    wp::int32 var_213;
    const wp::int32 var_214 = 5;
    wp::int32 var_215;
    wp::int32 var_216;
    wp::float32* var_217;
    const wp::int32 var_218 = 2;
    wp::float32 var_219;
    wp::float32 var_220;
    wp::float32 var_221;
    const wp::int32 var_222 = 2;
    wp::float32 var_223;
    wp::int32 var_224;
    const wp::int32 var_225 = 2;
    wp::int32 var_226;
    wp::int32 var_227;
    wp::float32* var_228;
    wp::float32 var_229;
    wp::float32 var_230;
    wp::float32 var_231;
    wp::float32 var_232;
    wp::float32 var_233;
    wp::float32 var_234;
    wp::float32 var_235;
    wp::float32 var_236;
    const wp::int32 var_237 = 4;
    wp::int32 var_238;
    const wp::int32 var_239 = 3;
    wp::int32 var_240;
    wp::int32 var_241;
    wp::float32* var_242;
    const wp::int32 var_243 = 0;
    wp::float32 var_244;
    wp::float32 var_245;
    wp::float32 var_246;
    const wp::int32 var_247 = 0;
    wp::float32 var_248;
    wp::int32 var_249;
    wp::float32* var_250;
    wp::float32 var_251;
    wp::float32 var_252;
    wp::float32 var_253;
    wp::int32 var_254;
    const wp::int32 var_255 = 4;
    wp::int32 var_256;
    wp::int32 var_257;
    wp::float32* var_258;
    const wp::int32 var_259 = 1;
    wp::float32 var_260;
    wp::float32 var_261;
    wp::float32 var_262;
    const wp::int32 var_263 = 1;
    wp::float32 var_264;
    wp::int32 var_265;
    wp::int32 var_266;
    wp::float32* var_267;
    wp::float32 var_268;
    wp::float32 var_269;
    wp::float32 var_270;
    wp::int32 var_271;
    const wp::int32 var_272 = 5;
    wp::int32 var_273;
    wp::int32 var_274;
    wp::float32* var_275;
    const wp::int32 var_276 = 2;
    wp::float32 var_277;
    wp::float32 var_278;
    wp::float32 var_279;
    const wp::int32 var_280 = 2;
    wp::float32 var_281;
    wp::int32 var_282;
    const wp::int32 var_283 = 2;
    wp::int32 var_284;
    wp::int32 var_285;
    wp::float32* var_286;
    wp::float32 var_287;
    wp::float32 var_288;
    wp::float32 var_289;
    wp::float32 var_290;
    wp::float32 var_291;
    wp::float32 var_292;
    wp::float32 var_293;
    wp::float32 var_294;
    const wp::int32 var_295 = 5;
    wp::int32 var_296;
    const wp::int32 var_297 = 3;
    wp::int32 var_298;
    wp::int32 var_299;
    wp::float32* var_300;
    const wp::int32 var_301 = 0;
    wp::float32 var_302;
    wp::float32 var_303;
    wp::float32 var_304;
    const wp::int32 var_305 = 0;
    wp::float32 var_306;
    wp::int32 var_307;
    wp::float32* var_308;
    wp::float32 var_309;
    wp::float32 var_310;
    wp::float32 var_311;
    wp::int32 var_312;
    const wp::int32 var_313 = 4;
    wp::int32 var_314;
    wp::int32 var_315;
    wp::float32* var_316;
    const wp::int32 var_317 = 1;
    wp::float32 var_318;
    wp::float32 var_319;
    wp::float32 var_320;
    const wp::int32 var_321 = 1;
    wp::float32 var_322;
    wp::int32 var_323;
    wp::int32 var_324;
    wp::float32* var_325;
    wp::float32 var_326;
    wp::float32 var_327;
    wp::float32 var_328;
    wp::int32 var_329;
    const wp::int32 var_330 = 5;
    wp::int32 var_331;
    wp::int32 var_332;
    wp::float32* var_333;
    const wp::int32 var_334 = 2;
    wp::float32 var_335;
    wp::float32 var_336;
    wp::float32 var_337;
    const wp::int32 var_338 = 2;
    wp::float32 var_339;
    wp::int32 var_340;
    const wp::int32 var_341 = 2;
    wp::int32 var_342;
    wp::int32 var_343;
    wp::float32* var_344;
    wp::float32 var_345;
    wp::float32 var_346;
    wp::float32 var_347;
    wp::float32 var_348;
    wp::float32 var_349;
    wp::float32 var_350;
    wp::float32 var_351;
    wp::float32 var_352;
    const wp::int32 var_353 = 6;
    wp::int32 var_354;
    const wp::int32 var_355 = 3;
    wp::int32 var_356;
    wp::int32 var_357;
    wp::float32* var_358;
    const wp::int32 var_359 = 0;
    wp::float32 var_360;
    wp::float32 var_361;
    wp::float32 var_362;
    const wp::int32 var_363 = 0;
    wp::float32 var_364;
    wp::int32 var_365;
    wp::float32* var_366;
    wp::float32 var_367;
    wp::float32 var_368;
    wp::float32 var_369;
    wp::int32 var_370;
    const wp::int32 var_371 = 4;
    wp::int32 var_372;
    wp::int32 var_373;
    wp::float32* var_374;
    const wp::int32 var_375 = 1;
    wp::float32 var_376;
    wp::float32 var_377;
    wp::float32 var_378;
    const wp::int32 var_379 = 1;
    wp::float32 var_380;
    wp::int32 var_381;
    wp::int32 var_382;
    wp::float32* var_383;
    wp::float32 var_384;
    wp::float32 var_385;
    wp::float32 var_386;
    wp::int32 var_387;
    const wp::int32 var_388 = 5;
    wp::int32 var_389;
    wp::int32 var_390;
    wp::float32* var_391;
    const wp::int32 var_392 = 2;
    wp::float32 var_393;
    wp::float32 var_394;
    wp::float32 var_395;
    const wp::int32 var_396 = 2;
    wp::float32 var_397;
    wp::int32 var_398;
    const wp::int32 var_399 = 2;
    wp::int32 var_400;
    wp::int32 var_401;
    wp::float32* var_402;
    wp::float32 var_403;
    wp::float32 var_404;
    wp::float32 var_405;
    wp::float32 var_406;
    wp::float32 var_407;
    wp::float32 var_408;
    wp::float32 var_409;
    wp::float32 var_410;
    const wp::int32 var_411 = 7;
    wp::int32 var_412;
    const wp::int32 var_413 = 3;
    wp::int32 var_414;
    wp::int32 var_415;
    wp::float32* var_416;
    const wp::int32 var_417 = 0;
    wp::float32 var_418;
    wp::float32 var_419;
    wp::float32 var_420;
    const wp::int32 var_421 = 0;
    wp::float32 var_422;
    wp::int32 var_423;
    wp::float32* var_424;
    wp::float32 var_425;
    wp::float32 var_426;
    wp::float32 var_427;
    wp::int32 var_428;
    const wp::int32 var_429 = 4;
    wp::int32 var_430;
    wp::int32 var_431;
    wp::float32* var_432;
    const wp::int32 var_433 = 1;
    wp::float32 var_434;
    wp::float32 var_435;
    wp::float32 var_436;
    const wp::int32 var_437 = 1;
    wp::float32 var_438;
    wp::int32 var_439;
    wp::int32 var_440;
    wp::float32* var_441;
    wp::float32 var_442;
    wp::float32 var_443;
    wp::float32 var_444;
    wp::int32 var_445;
    const wp::int32 var_446 = 5;
    wp::int32 var_447;
    wp::int32 var_448;
    wp::float32* var_449;
    const wp::int32 var_450 = 2;
    wp::float32 var_451;
    wp::float32 var_452;
    wp::float32 var_453;
    const wp::int32 var_454 = 2;
    wp::float32 var_455;
    wp::int32 var_456;
    const wp::int32 var_457 = 2;
    wp::int32 var_458;
    wp::int32 var_459;
    wp::float32* var_460;
    wp::float32 var_461;
    wp::float32 var_462;
    wp::float32 var_463;
    wp::float32 var_464;
    wp::float32 var_465;
    wp::float32 var_466;
    wp::float32 var_467;
    wp::float32 var_468;
    //---------
    // forward
    // def measure_farthest(boxes: array(dtype=float32), record: int, a: vec3, b: vec3) -> box_distances:       <L 152>
    // at = record * SIDES                                                                    <L 154>
    var_1 = wp::mul(var_record, var_0);
    // distances = box_distances(0.0)                                                         <L 155>
    var_3 = wp::vec_t<8, wp::float32>(var_2);
    // for j in range(FAN):                                                                   <L 156>
    // x = larger(boxes[at + j + 3 * FAN] - a[0], b[0] - boxes[at + j])                       <L 157>
    var_5 = wp::add(var_1, var_4);
    var_8 = wp::mul(var_6, var_7);
    var_9 = wp::add(var_5, var_8);
    var_10 = wp::address(var_boxes, var_9);
    var_12 = wp::extract(var_a, var_11);
    var_14 = wp::load(var_10);
    var_13 = wp::sub(var_14, var_12);
    var_16 = wp::extract(var_b, var_15);
    var_17 = wp::add(var_1, var_4);
    var_18 = wp::address(var_boxes, var_17);
    var_20 = wp::load(var_18);
    var_19 = wp::sub(var_16, var_20);
    var_21 = larger_0(var_13, var_19);
    // y = larger(boxes[at + j + 4 * FAN] - a[1], b[1] - boxes[at + j + FAN])                 <L 158>
    var_22 = wp::add(var_1, var_4);
    var_24 = wp::mul(var_23, var_7);
    var_25 = wp::add(var_22, var_24);
    var_26 = wp::address(var_boxes, var_25);
    var_28 = wp::extract(var_a, var_27);
    var_30 = wp::load(var_26);
    var_29 = wp::sub(var_30, var_28);
    var_32 = wp::extract(var_b, var_31);
    var_33 = wp::add(var_1, var_4);
    var_34 = wp::add(var_33, var_7);
    var_35 = wp::address(var_boxes, var_34);
    var_37 = wp::load(var_35);
    var_36 = wp::sub(var_32, var_37);
    var_38 = larger_0(var_29, var_36);
    // z = larger(boxes[at + j + 5 * FAN] - a[2], b[2] - boxes[at + j + 2 * FAN])             <L 159>
    var_39 = wp::add(var_1, var_4);
    var_41 = wp::mul(var_40, var_7);
    var_42 = wp::add(var_39, var_41);
    var_43 = wp::address(var_boxes, var_42);
    var_45 = wp::extract(var_a, var_44);
    var_47 = wp::load(var_43);
    var_46 = wp::sub(var_47, var_45);
    var_49 = wp::extract(var_b, var_48);
    var_50 = wp::add(var_1, var_4);
    var_52 = wp::mul(var_51, var_7);
    var_53 = wp::add(var_50, var_52);
    var_54 = wp::address(var_boxes, var_53);
    var_56 = wp::load(var_54);
    var_55 = wp::sub(var_49, var_56);
    var_57 = larger_0(var_46, var_55);
    // distances[j] = x * x + y * y + z * z                                                   <L 160>
    var_58 = wp::mul(var_21, var_21);
    var_59 = wp::mul(var_38, var_38);
    var_60 = wp::add(var_58, var_59);
    var_61 = wp::mul(var_57, var_57);
    var_62 = wp::add(var_60, var_61);
    wp::assign_inplace(var_3, var_4, var_62);
    // x = larger(boxes[at + j + 3 * FAN] - a[0], b[0] - boxes[at + j])                       <L 157>
    var_64 = wp::add(var_1, var_63);
    var_66 = wp::mul(var_65, var_7);
    var_67 = wp::add(var_64, var_66);
    var_68 = wp::address(var_boxes, var_67);
    var_70 = wp::extract(var_a, var_69);
    var_72 = wp::load(var_68);
    var_71 = wp::sub(var_72, var_70);
    var_74 = wp::extract(var_b, var_73);
    var_75 = wp::add(var_1, var_63);
    var_76 = wp::address(var_boxes, var_75);
    var_78 = wp::load(var_76);
    var_77 = wp::sub(var_74, var_78);
    var_79 = larger_0(var_71, var_77);
    // y = larger(boxes[at + j + 4 * FAN] - a[1], b[1] - boxes[at + j + FAN])                 <L 158>
    var_80 = wp::add(var_1, var_63);
    var_82 = wp::mul(var_81, var_7);
    var_83 = wp::add(var_80, var_82);
    var_84 = wp::address(var_boxes, var_83);
    var_86 = wp::extract(var_a, var_85);
    var_88 = wp::load(var_84);
    var_87 = wp::sub(var_88, var_86);
    var_90 = wp::extract(var_b, var_89);
    var_91 = wp::add(var_1, var_63);
    var_92 = wp::add(var_91, var_7);
    var_93 = wp::address(var_boxes, var_92);
    var_95 = wp::load(var_93);
    var_94 = wp::sub(var_90, var_95);
    var_96 = larger_0(var_87, var_94);
    // z = larger(boxes[at + j + 5 * FAN] - a[2], b[2] - boxes[at + j + 2 * FAN])             <L 159>
    var_97 = wp::add(var_1, var_63);
    var_99 = wp::mul(var_98, var_7);
    var_100 = wp::add(var_97, var_99);
    var_101 = wp::address(var_boxes, var_100);
    var_103 = wp::extract(var_a, var_102);
    var_105 = wp::load(var_101);
    var_104 = wp::sub(var_105, var_103);
    var_107 = wp::extract(var_b, var_106);
    var_108 = wp::add(var_1, var_63);
    var_110 = wp::mul(var_109, var_7);
    var_111 = wp::add(var_108, var_110);
    var_112 = wp::address(var_boxes, var_111);
    var_114 = wp::load(var_112);
    var_113 = wp::sub(var_107, var_114);
    var_115 = larger_0(var_104, var_113);
    // distances[j] = x * x + y * y + z * z                                                   <L 160>
    var_116 = wp::mul(var_79, var_79);
    var_117 = wp::mul(var_96, var_96);
    var_118 = wp::add(var_116, var_117);
    var_119 = wp::mul(var_115, var_115);
    var_120 = wp::add(var_118, var_119);
    wp::assign_inplace(var_3, var_63, var_120);
    // x = larger(boxes[at + j + 3 * FAN] - a[0], b[0] - boxes[at + j])                       <L 157>
    var_122 = wp::add(var_1, var_121);
    var_124 = wp::mul(var_123, var_7);
    var_125 = wp::add(var_122, var_124);
    var_126 = wp::address(var_boxes, var_125);
    var_128 = wp::extract(var_a, var_127);
    var_130 = wp::load(var_126);
    var_129 = wp::sub(var_130, var_128);
    var_132 = wp::extract(var_b, var_131);
    var_133 = wp::add(var_1, var_121);
    var_134 = wp::address(var_boxes, var_133);
    var_136 = wp::load(var_134);
    var_135 = wp::sub(var_132, var_136);
    var_137 = larger_0(var_129, var_135);
    // y = larger(boxes[at + j + 4 * FAN] - a[1], b[1] - boxes[at + j + FAN])                 <L 158>
    var_138 = wp::add(var_1, var_121);
    var_140 = wp::mul(var_139, var_7);
    var_141 = wp::add(var_138, var_140);
    var_142 = wp::address(var_boxes, var_141);
    var_144 = wp::extract(var_a, var_143);
    var_146 = wp::load(var_142);
    var_145 = wp::sub(var_146, var_144);
    var_148 = wp::extract(var_b, var_147);
    var_149 = wp::add(var_1, var_121);
    var_150 = wp::add(var_149, var_7);
    var_151 = wp::address(var_boxes, var_150);
    var_153 = wp::load(var_151);
    var_152 = wp::sub(var_148, var_153);
    var_154 = larger_0(var_145, var_152);
    // z = larger(boxes[at + j + 5 * FAN] - a[2], b[2] - boxes[at + j + 2 * FAN])             <L 159>
    var_155 = wp::add(var_1, var_121);
    var_157 = wp::mul(var_156, var_7);
    var_158 = wp::add(var_155, var_157);
    var_159 = wp::address(var_boxes, var_158);
    var_161 = wp::extract(var_a, var_160);
    var_163 = wp::load(var_159);
    var_162 = wp::sub(var_163, var_161);
    var_165 = wp::extract(var_b, var_164);
    var_166 = wp::add(var_1, var_121);
    var_168 = wp::mul(var_167, var_7);
    var_169 = wp::add(var_166, var_168);
    var_170 = wp::address(var_boxes, var_169);
    var_172 = wp::load(var_170);
    var_171 = wp::sub(var_165, var_172);
    var_173 = larger_0(var_162, var_171);
    // distances[j] = x * x + y * y + z * z                                                   <L 160>
    var_174 = wp::mul(var_137, var_137);
    var_175 = wp::mul(var_154, var_154);
    var_176 = wp::add(var_174, var_175);
    var_177 = wp::mul(var_173, var_173);
    var_178 = wp::add(var_176, var_177);
    wp::assign_inplace(var_3, var_121, var_178);
    // x = larger(boxes[at + j + 3 * FAN] - a[0], b[0] - boxes[at + j])                       <L 157>
    var_180 = wp::add(var_1, var_179);
    var_182 = wp::mul(var_181, var_7);
    var_183 = wp::add(var_180, var_182);
    var_184 = wp::address(var_boxes, var_183);
    var_186 = wp::extract(var_a, var_185);
    var_188 = wp::load(var_184);
    var_187 = wp::sub(var_188, var_186);
    var_190 = wp::extract(var_b, var_189);
    var_191 = wp::add(var_1, var_179);
    var_192 = wp::address(var_boxes, var_191);
    var_194 = wp::load(var_192);
    var_193 = wp::sub(var_190, var_194);
    var_195 = larger_0(var_187, var_193);
    // y = larger(boxes[at + j + 4 * FAN] - a[1], b[1] - boxes[at + j + FAN])                 <L 158>
    var_196 = wp::add(var_1, var_179);
    var_198 = wp::mul(var_197, var_7);
    var_199 = wp::add(var_196, var_198);
    var_200 = wp::address(var_boxes, var_199);
    var_202 = wp::extract(var_a, var_201);
    var_204 = wp::load(var_200);
    var_203 = wp::sub(var_204, var_202);
    var_206 = wp::extract(var_b, var_205);
    var_207 = wp::add(var_1, var_179);
    var_208 = wp::add(var_207, var_7);
    var_209 = wp::address(var_boxes, var_208);
    var_211 = wp::load(var_209);
    var_210 = wp::sub(var_206, var_211);
    var_212 = larger_0(var_203, var_210);
    // z = larger(boxes[at + j + 5 * FAN] - a[2], b[2] - boxes[at + j + 2 * FAN])             <L 159>
    var_213 = wp::add(var_1, var_179);
    var_215 = wp::mul(var_214, var_7);
    var_216 = wp::add(var_213, var_215);
    var_217 = wp::address(var_boxes, var_216);
    var_219 = wp::extract(var_a, var_218);
    var_221 = wp::load(var_217);
    var_220 = wp::sub(var_221, var_219);
    var_223 = wp::extract(var_b, var_222);
    var_224 = wp::add(var_1, var_179);
    var_226 = wp::mul(var_225, var_7);
    var_227 = wp::add(var_224, var_226);
    var_228 = wp::address(var_boxes, var_227);
    var_230 = wp::load(var_228);
    var_229 = wp::sub(var_223, var_230);
    var_231 = larger_0(var_220, var_229);
    // distances[j] = x * x + y * y + z * z                                                   <L 160>
    var_232 = wp::mul(var_195, var_195);
    var_233 = wp::mul(var_212, var_212);
    var_234 = wp::add(var_232, var_233);
    var_235 = wp::mul(var_231, var_231);
    var_236 = wp::add(var_234, var_235);
    wp::assign_inplace(var_3, var_179, var_236);
    // x = larger(boxes[at + j + 3 * FAN] - a[0], b[0] - boxes[at + j])                       <L 157>
    var_238 = wp::add(var_1, var_237);
    var_240 = wp::mul(var_239, var_7);
    var_241 = wp::add(var_238, var_240);
    var_242 = wp::address(var_boxes, var_241);
    var_244 = wp::extract(var_a, var_243);
    var_246 = wp::load(var_242);
    var_245 = wp::sub(var_246, var_244);
    var_248 = wp::extract(var_b, var_247);
    var_249 = wp::add(var_1, var_237);
    var_250 = wp::address(var_boxes, var_249);
    var_252 = wp::load(var_250);
    var_251 = wp::sub(var_248, var_252);
    var_253 = larger_0(var_245, var_251);
    // y = larger(boxes[at + j + 4 * FAN] - a[1], b[1] - boxes[at + j + FAN])                 <L 158>
    var_254 = wp::add(var_1, var_237);
    var_256 = wp::mul(var_255, var_7);
    var_257 = wp::add(var_254, var_256);
    var_258 = wp::address(var_boxes, var_257);
    var_260 = wp::extract(var_a, var_259);
    var_262 = wp::load(var_258);
    var_261 = wp::sub(var_262, var_260);
    var_264 = wp::extract(var_b, var_263);
    var_265 = wp::add(var_1, var_237);
    var_266 = wp::add(var_265, var_7);
    var_267 = wp::address(var_boxes, var_266);
    var_269 = wp::load(var_267);
    var_268 = wp::sub(var_264, var_269);
    var_270 = larger_0(var_261, var_268);
    // z = larger(boxes[at + j + 5 * FAN] - a[2], b[2] - boxes[at + j + 2 * FAN])             <L 159>
    var_271 = wp::add(var_1, var_237);
    var_273 = wp::mul(var_272, var_7);
    var_274 = wp::add(var_271, var_273);
    var_275 = wp::address(var_boxes, var_274);
    var_277 = wp::extract(var_a, var_276);
    var_279 = wp::load(var_275);
    var_278 = wp::sub(var_279, var_277);
    var_281 = wp::extract(var_b, var_280);
    var_282 = wp::add(var_1, var_237);
    var_284 = wp::mul(var_283, var_7);
    var_285 = wp::add(var_282, var_284);
    var_286 = wp::address(var_boxes, var_285);
    var_288 = wp::load(var_286);
    var_287 = wp::sub(var_281, var_288);
    var_289 = larger_0(var_278, var_287);
    // distances[j] = x * x + y * y + z * z                                                   <L 160>
    var_290 = wp::mul(var_253, var_253);
    var_291 = wp::mul(var_270, var_270);
    var_292 = wp::add(var_290, var_291);
    var_293 = wp::mul(var_289, var_289);
    var_294 = wp::add(var_292, var_293);
    wp::assign_inplace(var_3, var_237, var_294);
    // x = larger(boxes[at + j + 3 * FAN] - a[0], b[0] - boxes[at + j])                       <L 157>
    var_296 = wp::add(var_1, var_295);
    var_298 = wp::mul(var_297, var_7);
    var_299 = wp::add(var_296, var_298);
    var_300 = wp::address(var_boxes, var_299);
    var_302 = wp::extract(var_a, var_301);
    var_304 = wp::load(var_300);
    var_303 = wp::sub(var_304, var_302);
    var_306 = wp::extract(var_b, var_305);
    var_307 = wp::add(var_1, var_295);
    var_308 = wp::address(var_boxes, var_307);
    var_310 = wp::load(var_308);
    var_309 = wp::sub(var_306, var_310);
    var_311 = larger_0(var_303, var_309);
    // y = larger(boxes[at + j + 4 * FAN] - a[1], b[1] - boxes[at + j + FAN])                 <L 158>
    var_312 = wp::add(var_1, var_295);
    var_314 = wp::mul(var_313, var_7);
    var_315 = wp::add(var_312, var_314);
    var_316 = wp::address(var_boxes, var_315);
    var_318 = wp::extract(var_a, var_317);
    var_320 = wp::load(var_316);
    var_319 = wp::sub(var_320, var_318);
    var_322 = wp::extract(var_b, var_321);
    var_323 = wp::add(var_1, var_295);
    var_324 = wp::add(var_323, var_7);
    var_325 = wp::address(var_boxes, var_324);
    var_327 = wp::load(var_325);
    var_326 = wp::sub(var_322, var_327);
    var_328 = larger_0(var_319, var_326);
    // z = larger(boxes[at + j + 5 * FAN] - a[2], b[2] - boxes[at + j + 2 * FAN])             <L 159>
    var_329 = wp::add(var_1, var_295);
    var_331 = wp::mul(var_330, var_7);
    var_332 = wp::add(var_329, var_331);
    var_333 = wp::address(var_boxes, var_332);
    var_335 = wp::extract(var_a, var_334);
    var_337 = wp::load(var_333);
    var_336 = wp::sub(var_337, var_335);
    var_339 = wp::extract(var_b, var_338);
    var_340 = wp::add(var_1, var_295);
    var_342 = wp::mul(var_341, var_7);
    var_343 = wp::add(var_340, var_342);
    var_344 = wp::address(var_boxes, var_343);
    var_346 = wp::load(var_344);
    var_345 = wp::sub(var_339, var_346);
    var_347 = larger_0(var_336, var_345);
    // distances[j] = x * x + y * y + z * z                                                   <L 160>
    var_348 = wp::mul(var_311, var_311);
    var_349 = wp::mul(var_328, var_328);
    var_350 = wp::add(var_348, var_349);
    var_351 = wp::mul(var_347, var_347);
    var_352 = wp::add(var_350, var_351);
    wp::assign_inplace(var_3, var_295, var_352);
    // x = larger(boxes[at + j + 3 * FAN] - a[0], b[0] - boxes[at + j])                       <L 157>
    var_354 = wp::add(var_1, var_353);
    var_356 = wp::mul(var_355, var_7);
    var_357 = wp::add(var_354, var_356);
    var_358 = wp::address(var_boxes, var_357);
    var_360 = wp::extract(var_a, var_359);
    var_362 = wp::load(var_358);
    var_361 = wp::sub(var_362, var_360);
    var_364 = wp::extract(var_b, var_363);
    var_365 = wp::add(var_1, var_353);
    var_366 = wp::address(var_boxes, var_365);
    var_368 = wp::load(var_366);
    var_367 = wp::sub(var_364, var_368);
    var_369 = larger_0(var_361, var_367);
    // y = larger(boxes[at + j + 4 * FAN] - a[1], b[1] - boxes[at + j + FAN])                 <L 158>
    var_370 = wp::add(var_1, var_353);
    var_372 = wp::mul(var_371, var_7);
    var_373 = wp::add(var_370, var_372);
    var_374 = wp::address(var_boxes, var_373);
    var_376 = wp::extract(var_a, var_375);
    var_378 = wp::load(var_374);
    var_377 = wp::sub(var_378, var_376);
    var_380 = wp::extract(var_b, var_379);
    var_381 = wp::add(var_1, var_353);
    var_382 = wp::add(var_381, var_7);
    var_383 = wp::address(var_boxes, var_382);
    var_385 = wp::load(var_383);
    var_384 = wp::sub(var_380, var_385);
    var_386 = larger_0(var_377, var_384);
    // z = larger(boxes[at + j + 5 * FAN] - a[2], b[2] - boxes[at + j + 2 * FAN])             <L 159>
    var_387 = wp::add(var_1, var_353);
    var_389 = wp::mul(var_388, var_7);
    var_390 = wp::add(var_387, var_389);
    var_391 = wp::address(var_boxes, var_390);
    var_393 = wp::extract(var_a, var_392);
    var_395 = wp::load(var_391);
    var_394 = wp::sub(var_395, var_393);
    var_397 = wp::extract(var_b, var_396);
    var_398 = wp::add(var_1, var_353);
    var_400 = wp::mul(var_399, var_7);
    var_401 = wp::add(var_398, var_400);
    var_402 = wp::address(var_boxes, var_401);
    var_404 = wp::load(var_402);
    var_403 = wp::sub(var_397, var_404);
    var_405 = larger_0(var_394, var_403);
    // distances[j] = x * x + y * y + z * z                                                   <L 160>
    var_406 = wp::mul(var_369, var_369);
    var_407 = wp::mul(var_386, var_386);
    var_408 = wp::add(var_406, var_407);
    var_409 = wp::mul(var_405, var_405);
    var_410 = wp::add(var_408, var_409);
    wp::assign_inplace(var_3, var_353, var_410);
    // x = larger(boxes[at + j + 3 * FAN] - a[0], b[0] - boxes[at + j])                       <L 157>
    var_412 = wp::add(var_1, var_411);
    var_414 = wp::mul(var_413, var_7);
    var_415 = wp::add(var_412, var_414);
    var_416 = wp::address(var_boxes, var_415);
    var_418 = wp::extract(var_a, var_417);
    var_420 = wp::load(var_416);
    var_419 = wp::sub(var_420, var_418);
    var_422 = wp::extract(var_b, var_421);
    var_423 = wp::add(var_1, var_411);
    var_424 = wp::address(var_boxes, var_423);
    var_426 = wp::load(var_424);
    var_425 = wp::sub(var_422, var_426);
    var_427 = larger_0(var_419, var_425);
    // y = larger(boxes[at + j + 4 * FAN] - a[1], b[1] - boxes[at + j + FAN])                 <L 158>
    var_428 = wp::add(var_1, var_411);
    var_430 = wp::mul(var_429, var_7);
    var_431 = wp::add(var_428, var_430);
    var_432 = wp::address(var_boxes, var_431);
    var_434 = wp::extract(var_a, var_433);
    var_436 = wp::load(var_432);
    var_435 = wp::sub(var_436, var_434);
    var_438 = wp::extract(var_b, var_437);
    var_439 = wp::add(var_1, var_411);
    var_440 = wp::add(var_439, var_7);
    var_441 = wp::address(var_boxes, var_440);
    var_443 = wp::load(var_441);
    var_442 = wp::sub(var_438, var_443);
    var_444 = larger_0(var_435, var_442);
    // z = larger(boxes[at + j + 5 * FAN] - a[2], b[2] - boxes[at + j + 2 * FAN])             <L 159>
    var_445 = wp::add(var_1, var_411);
    var_447 = wp::mul(var_446, var_7);
    var_448 = wp::add(var_445, var_447);
    var_449 = wp::address(var_boxes, var_448);
    var_451 = wp::extract(var_a, var_450);
    var_453 = wp::load(var_449);
    var_452 = wp::sub(var_453, var_451);
    var_455 = wp::extract(var_b, var_454);
    var_456 = wp::add(var_1, var_411);
    var_458 = wp::mul(var_457, var_7);
    var_459 = wp::add(var_456, var_458);
    var_460 = wp::address(var_boxes, var_459);
    var_462 = wp::load(var_460);
    var_461 = wp::sub(var_455, var_462);
    var_463 = larger_0(var_452, var_461);
    // distances[j] = x * x + y * y + z * z                                                   <L 160>
    var_464 = wp::mul(var_427, var_427);
    var_465 = wp::mul(var_444, var_444);
    var_466 = wp::add(var_464, var_465);
    var_467 = wp::mul(var_463, var_463);
    var_468 = wp::add(var_466, var_467);
    wp::assign_inplace(var_3, var_411, var_468);
    // return distances                                                                       <L 161>
    return var_3;
}


// <pointloom.kernels.search.tree_walk.point_sum>:1
static CUDA_CALLABLE wp::int32 point_sum_0(
    wp::int32 var_children,
    wp::int32 var_level,
    wp::int32 var_node,
    wp::int32 var_count)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    const wp::int32 var_2 = 8;
    const wp::int32 var_3 = 3;
    const wp::int32 var_4 = 1;
    wp::int32 var_5;
    wp::int32 var_6;
    wp::int32 var_7;
    wp::int32 var_8;
    const wp::int32 var_9 = 0;
    bool var_10;
    wp::int32 var_11;
    const wp::int32 var_12 = 1;
    wp::int32 var_13;
    wp::int32 var_14;
    const wp::int32 var_15 = 8;
    wp::int32 var_16;
    wp::int32 var_17;
    wp::int32 var_18;
    wp::int32 var_19;
    wp::int32 var_20;
    wp::int32 var_21;
    //---------
    // forward
    // def point_sum(children, level, node, count):                                           <L 1>
    // total = int(0)                                                                         <L 3>
    var_1 = wp::int(var_0);
    // size = LEAF << FAN_BITS * (level - 1)                                                  <L 4>
    var_5 = wp::sub(var_level, var_4);
    var_6 = wp::mul(var_3, var_5);
    var_7 = wp::lshift(var_2, var_6);
    // left__bits_of__1 = children                                                            <L 5>
    var_8 = wp::copy(var_children);
    // while left__bits_of__1 != 0:                                                           <L 6>
    start_while_0:;
    var_10 = (var_8 != var_9);
    if ((var_10) == false) goto end_while_0;
        // child = lowest_bit(left__bits_of__1)                                               <L 7>
        var_11 = lowest_bit_0(var_8);
        // left__bits_of__1 = left__bits_of__1 & left__bits_of__1 - 1                         <L 8>
        var_13 = wp::sub(var_8, var_12);
        var_14 = wp::bit_and(var_8, var_13);
        // total += min(size, count - (node * FAN + child) * size)                            <L 9>
        var_16 = wp::mul(var_node, var_15);
        var_17 = wp::add(var_16, var_11);
        var_18 = wp::mul(var_17, var_7);
        var_19 = wp::sub(var_count, var_18);
        var_20 = wp::min(var_7, var_19);
        var_21 = wp::add(var_1, var_20);
        wp::assign(var_1, var_21);
        wp::assign(var_8, var_14);
    goto start_while_0;
    end_while_0:;
    // return total                                                                           <L 10>
    return var_1;
}


// /work/main/src/pointloom/kernels/segmentation/dbscan.py:34
static CUDA_CALLABLE wp::vec_t<8, wp::int32> count_leaf_0(
    wp::vec_t<8, wp::int32> var_counts,
    wp::vec_t<8, wp::float32> var_xs,
    wp::vec_t<8, wp::float32> var_ys,
    wp::vec_t<8, wp::float32> var_zs,
    wp::int32 var_first,
    wp::int32 var_last,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::float32 var_max_sqdist)
{
    //---------
    // primal vars
    wp::vec_t<8, wp::int32> var_0;
    wp::range_t var_1;
    wp::int32 var_2;
    wp::vec_t<3, wp::float32>* var_3;
    wp::vec_t<3, wp::float32> var_4;
    wp::vec_t<3, wp::float32> var_5;
    const wp::int32 var_6 = 0;
    const wp::int32 var_7 = 0;
    wp::float32 var_8;
    wp::float32 var_9;
    wp::float32 var_10;
    const wp::int32 var_11 = 1;
    wp::float32 var_12;
    wp::float32 var_13;
    wp::float32 var_14;
    const wp::int32 var_15 = 2;
    wp::float32 var_16;
    wp::float32 var_17;
    wp::float32 var_18;
    wp::int32 var_19;
    wp::float32 var_20;
    wp::float32 var_21;
    wp::float32 var_22;
    wp::float32 var_23;
    wp::float32 var_24;
    bool var_25;
    const wp::int32 var_26 = 1;
    const wp::int32 var_27 = 0;
    wp::int32 var_28;
    wp::int32 var_29;
    const wp::int32 var_30 = 1073741824;
    wp::int32 var_31;
    const wp::int32 var_32 = 1;
    const wp::int32 var_33 = 0;
    wp::float32 var_34;
    wp::float32 var_35;
    wp::float32 var_36;
    const wp::int32 var_37 = 1;
    wp::float32 var_38;
    wp::float32 var_39;
    wp::float32 var_40;
    const wp::int32 var_41 = 2;
    wp::float32 var_42;
    wp::float32 var_43;
    wp::float32 var_44;
    wp::int32 var_45;
    wp::float32 var_46;
    wp::float32 var_47;
    wp::float32 var_48;
    wp::float32 var_49;
    wp::float32 var_50;
    bool var_51;
    const wp::int32 var_52 = 1;
    const wp::int32 var_53 = 0;
    wp::int32 var_54;
    wp::int32 var_55;
    wp::int32 var_56;
    const wp::int32 var_57 = 2;
    const wp::int32 var_58 = 0;
    wp::float32 var_59;
    wp::float32 var_60;
    wp::float32 var_61;
    const wp::int32 var_62 = 1;
    wp::float32 var_63;
    wp::float32 var_64;
    wp::float32 var_65;
    const wp::int32 var_66 = 2;
    wp::float32 var_67;
    wp::float32 var_68;
    wp::float32 var_69;
    wp::int32 var_70;
    wp::float32 var_71;
    wp::float32 var_72;
    wp::float32 var_73;
    wp::float32 var_74;
    wp::float32 var_75;
    bool var_76;
    const wp::int32 var_77 = 1;
    const wp::int32 var_78 = 0;
    wp::int32 var_79;
    wp::int32 var_80;
    wp::int32 var_81;
    const wp::int32 var_82 = 3;
    const wp::int32 var_83 = 0;
    wp::float32 var_84;
    wp::float32 var_85;
    wp::float32 var_86;
    const wp::int32 var_87 = 1;
    wp::float32 var_88;
    wp::float32 var_89;
    wp::float32 var_90;
    const wp::int32 var_91 = 2;
    wp::float32 var_92;
    wp::float32 var_93;
    wp::float32 var_94;
    wp::int32 var_95;
    wp::float32 var_96;
    wp::float32 var_97;
    wp::float32 var_98;
    wp::float32 var_99;
    wp::float32 var_100;
    bool var_101;
    const wp::int32 var_102 = 1;
    const wp::int32 var_103 = 0;
    wp::int32 var_104;
    wp::int32 var_105;
    wp::int32 var_106;
    const wp::int32 var_107 = 4;
    const wp::int32 var_108 = 0;
    wp::float32 var_109;
    wp::float32 var_110;
    wp::float32 var_111;
    const wp::int32 var_112 = 1;
    wp::float32 var_113;
    wp::float32 var_114;
    wp::float32 var_115;
    const wp::int32 var_116 = 2;
    wp::float32 var_117;
    wp::float32 var_118;
    wp::float32 var_119;
    wp::int32 var_120;
    wp::float32 var_121;
    wp::float32 var_122;
    wp::float32 var_123;
    wp::float32 var_124;
    wp::float32 var_125;
    bool var_126;
    const wp::int32 var_127 = 1;
    const wp::int32 var_128 = 0;
    wp::int32 var_129;
    wp::int32 var_130;
    wp::int32 var_131;
    const wp::int32 var_132 = 5;
    const wp::int32 var_133 = 0;
    wp::float32 var_134;
    wp::float32 var_135;
    wp::float32 var_136;
    const wp::int32 var_137 = 1;
    wp::float32 var_138;
    wp::float32 var_139;
    wp::float32 var_140;
    const wp::int32 var_141 = 2;
    wp::float32 var_142;
    wp::float32 var_143;
    wp::float32 var_144;
    wp::int32 var_145;
    wp::float32 var_146;
    wp::float32 var_147;
    wp::float32 var_148;
    wp::float32 var_149;
    wp::float32 var_150;
    bool var_151;
    const wp::int32 var_152 = 1;
    const wp::int32 var_153 = 0;
    wp::int32 var_154;
    wp::int32 var_155;
    wp::int32 var_156;
    const wp::int32 var_157 = 6;
    const wp::int32 var_158 = 0;
    wp::float32 var_159;
    wp::float32 var_160;
    wp::float32 var_161;
    const wp::int32 var_162 = 1;
    wp::float32 var_163;
    wp::float32 var_164;
    wp::float32 var_165;
    const wp::int32 var_166 = 2;
    wp::float32 var_167;
    wp::float32 var_168;
    wp::float32 var_169;
    wp::int32 var_170;
    wp::float32 var_171;
    wp::float32 var_172;
    wp::float32 var_173;
    wp::float32 var_174;
    wp::float32 var_175;
    bool var_176;
    const wp::int32 var_177 = 1;
    const wp::int32 var_178 = 0;
    wp::int32 var_179;
    wp::int32 var_180;
    wp::int32 var_181;
    const wp::int32 var_182 = 7;
    const wp::int32 var_183 = 0;
    wp::float32 var_184;
    wp::float32 var_185;
    wp::float32 var_186;
    const wp::int32 var_187 = 1;
    wp::float32 var_188;
    wp::float32 var_189;
    wp::float32 var_190;
    const wp::int32 var_191 = 2;
    wp::float32 var_192;
    wp::float32 var_193;
    wp::float32 var_194;
    wp::int32 var_195;
    wp::float32 var_196;
    wp::float32 var_197;
    wp::float32 var_198;
    wp::float32 var_199;
    wp::float32 var_200;
    bool var_201;
    const wp::int32 var_202 = 1;
    const wp::int32 var_203 = 0;
    wp::int32 var_204;
    wp::int32 var_205;
    wp::int32 var_206;
    //---------
    // forward
    // def count_leaf(                                                                        <L 35>
    // total = counts                                                                         <L 46>
    var_0 = wp::copy(var_counts);
    // for r in range(first, last):                                                           <L 47>
    var_1 = wp::range(var_first, var_last);
    start_for_0:;
        if (iter_cmp(var_1) == 0) goto end_for_0;
        var_2 = wp::iter_next(var_1);
        // q = points[r]                                                                      <L 48>
        var_3 = wp::address(var_points, var_2);
        var_5 = wp::load(var_3);
        var_4 = wp::copy(var_5);
        // for j in range(LEAF):                                                              <L 49>
        // x = q[0] - xs[j]                                                                   <L 50>
        var_8 = wp::extract(var_4, var_7);
        var_9 = wp::extract(var_xs, var_6);
        var_10 = wp::sub(var_8, var_9);
        // y = q[1] - ys[j]                                                                   <L 51>
        var_12 = wp::extract(var_4, var_11);
        var_13 = wp::extract(var_ys, var_6);
        var_14 = wp::sub(var_12, var_13);
        // z = q[2] - zs[j]                                                                   <L 52>
        var_16 = wp::extract(var_4, var_15);
        var_17 = wp::extract(var_zs, var_6);
        var_18 = wp::sub(var_16, var_17);
        // total[j] = min(total[j] + (1 if x * x + y * y + z * z <= max_sqdist else 0), MANY)       <L 53>
        var_19 = wp::extract(var_0, var_6);
        var_20 = wp::mul(var_10, var_10);
        var_21 = wp::mul(var_14, var_14);
        var_22 = wp::add(var_20, var_21);
        var_23 = wp::mul(var_18, var_18);
        var_24 = wp::add(var_22, var_23);
        var_25 = (var_24 <= var_max_sqdist);
        if (var_25) {
        }
        if (!var_25) {
        }
        var_28 = wp::where(var_25, var_26, var_27);
        var_29 = wp::add(var_19, var_28);
        var_31 = wp::min(var_29, var_30);
        wp::assign_inplace(var_0, var_6, var_31);
        // x = q[0] - xs[j]                                                                   <L 50>
        var_34 = wp::extract(var_4, var_33);
        var_35 = wp::extract(var_xs, var_32);
        var_36 = wp::sub(var_34, var_35);
        // y = q[1] - ys[j]                                                                   <L 51>
        var_38 = wp::extract(var_4, var_37);
        var_39 = wp::extract(var_ys, var_32);
        var_40 = wp::sub(var_38, var_39);
        // z = q[2] - zs[j]                                                                   <L 52>
        var_42 = wp::extract(var_4, var_41);
        var_43 = wp::extract(var_zs, var_32);
        var_44 = wp::sub(var_42, var_43);
        // total[j] = min(total[j] + (1 if x * x + y * y + z * z <= max_sqdist else 0), MANY)       <L 53>
        var_45 = wp::extract(var_0, var_32);
        var_46 = wp::mul(var_36, var_36);
        var_47 = wp::mul(var_40, var_40);
        var_48 = wp::add(var_46, var_47);
        var_49 = wp::mul(var_44, var_44);
        var_50 = wp::add(var_48, var_49);
        var_51 = (var_50 <= var_max_sqdist);
        if (var_51) {
        }
        if (!var_51) {
        }
        var_54 = wp::where(var_51, var_52, var_53);
        var_55 = wp::add(var_45, var_54);
        var_56 = wp::min(var_55, var_30);
        wp::assign_inplace(var_0, var_32, var_56);
        // x = q[0] - xs[j]                                                                   <L 50>
        var_59 = wp::extract(var_4, var_58);
        var_60 = wp::extract(var_xs, var_57);
        var_61 = wp::sub(var_59, var_60);
        // y = q[1] - ys[j]                                                                   <L 51>
        var_63 = wp::extract(var_4, var_62);
        var_64 = wp::extract(var_ys, var_57);
        var_65 = wp::sub(var_63, var_64);
        // z = q[2] - zs[j]                                                                   <L 52>
        var_67 = wp::extract(var_4, var_66);
        var_68 = wp::extract(var_zs, var_57);
        var_69 = wp::sub(var_67, var_68);
        // total[j] = min(total[j] + (1 if x * x + y * y + z * z <= max_sqdist else 0), MANY)       <L 53>
        var_70 = wp::extract(var_0, var_57);
        var_71 = wp::mul(var_61, var_61);
        var_72 = wp::mul(var_65, var_65);
        var_73 = wp::add(var_71, var_72);
        var_74 = wp::mul(var_69, var_69);
        var_75 = wp::add(var_73, var_74);
        var_76 = (var_75 <= var_max_sqdist);
        if (var_76) {
        }
        if (!var_76) {
        }
        var_79 = wp::where(var_76, var_77, var_78);
        var_80 = wp::add(var_70, var_79);
        var_81 = wp::min(var_80, var_30);
        wp::assign_inplace(var_0, var_57, var_81);
        // x = q[0] - xs[j]                                                                   <L 50>
        var_84 = wp::extract(var_4, var_83);
        var_85 = wp::extract(var_xs, var_82);
        var_86 = wp::sub(var_84, var_85);
        // y = q[1] - ys[j]                                                                   <L 51>
        var_88 = wp::extract(var_4, var_87);
        var_89 = wp::extract(var_ys, var_82);
        var_90 = wp::sub(var_88, var_89);
        // z = q[2] - zs[j]                                                                   <L 52>
        var_92 = wp::extract(var_4, var_91);
        var_93 = wp::extract(var_zs, var_82);
        var_94 = wp::sub(var_92, var_93);
        // total[j] = min(total[j] + (1 if x * x + y * y + z * z <= max_sqdist else 0), MANY)       <L 53>
        var_95 = wp::extract(var_0, var_82);
        var_96 = wp::mul(var_86, var_86);
        var_97 = wp::mul(var_90, var_90);
        var_98 = wp::add(var_96, var_97);
        var_99 = wp::mul(var_94, var_94);
        var_100 = wp::add(var_98, var_99);
        var_101 = (var_100 <= var_max_sqdist);
        if (var_101) {
        }
        if (!var_101) {
        }
        var_104 = wp::where(var_101, var_102, var_103);
        var_105 = wp::add(var_95, var_104);
        var_106 = wp::min(var_105, var_30);
        wp::assign_inplace(var_0, var_82, var_106);
        // x = q[0] - xs[j]                                                                   <L 50>
        var_109 = wp::extract(var_4, var_108);
        var_110 = wp::extract(var_xs, var_107);
        var_111 = wp::sub(var_109, var_110);
        // y = q[1] - ys[j]                                                                   <L 51>
        var_113 = wp::extract(var_4, var_112);
        var_114 = wp::extract(var_ys, var_107);
        var_115 = wp::sub(var_113, var_114);
        // z = q[2] - zs[j]                                                                   <L 52>
        var_117 = wp::extract(var_4, var_116);
        var_118 = wp::extract(var_zs, var_107);
        var_119 = wp::sub(var_117, var_118);
        // total[j] = min(total[j] + (1 if x * x + y * y + z * z <= max_sqdist else 0), MANY)       <L 53>
        var_120 = wp::extract(var_0, var_107);
        var_121 = wp::mul(var_111, var_111);
        var_122 = wp::mul(var_115, var_115);
        var_123 = wp::add(var_121, var_122);
        var_124 = wp::mul(var_119, var_119);
        var_125 = wp::add(var_123, var_124);
        var_126 = (var_125 <= var_max_sqdist);
        if (var_126) {
        }
        if (!var_126) {
        }
        var_129 = wp::where(var_126, var_127, var_128);
        var_130 = wp::add(var_120, var_129);
        var_131 = wp::min(var_130, var_30);
        wp::assign_inplace(var_0, var_107, var_131);
        // x = q[0] - xs[j]                                                                   <L 50>
        var_134 = wp::extract(var_4, var_133);
        var_135 = wp::extract(var_xs, var_132);
        var_136 = wp::sub(var_134, var_135);
        // y = q[1] - ys[j]                                                                   <L 51>
        var_138 = wp::extract(var_4, var_137);
        var_139 = wp::extract(var_ys, var_132);
        var_140 = wp::sub(var_138, var_139);
        // z = q[2] - zs[j]                                                                   <L 52>
        var_142 = wp::extract(var_4, var_141);
        var_143 = wp::extract(var_zs, var_132);
        var_144 = wp::sub(var_142, var_143);
        // total[j] = min(total[j] + (1 if x * x + y * y + z * z <= max_sqdist else 0), MANY)       <L 53>
        var_145 = wp::extract(var_0, var_132);
        var_146 = wp::mul(var_136, var_136);
        var_147 = wp::mul(var_140, var_140);
        var_148 = wp::add(var_146, var_147);
        var_149 = wp::mul(var_144, var_144);
        var_150 = wp::add(var_148, var_149);
        var_151 = (var_150 <= var_max_sqdist);
        if (var_151) {
        }
        if (!var_151) {
        }
        var_154 = wp::where(var_151, var_152, var_153);
        var_155 = wp::add(var_145, var_154);
        var_156 = wp::min(var_155, var_30);
        wp::assign_inplace(var_0, var_132, var_156);
        // x = q[0] - xs[j]                                                                   <L 50>
        var_159 = wp::extract(var_4, var_158);
        var_160 = wp::extract(var_xs, var_157);
        var_161 = wp::sub(var_159, var_160);
        // y = q[1] - ys[j]                                                                   <L 51>
        var_163 = wp::extract(var_4, var_162);
        var_164 = wp::extract(var_ys, var_157);
        var_165 = wp::sub(var_163, var_164);
        // z = q[2] - zs[j]                                                                   <L 52>
        var_167 = wp::extract(var_4, var_166);
        var_168 = wp::extract(var_zs, var_157);
        var_169 = wp::sub(var_167, var_168);
        // total[j] = min(total[j] + (1 if x * x + y * y + z * z <= max_sqdist else 0), MANY)       <L 53>
        var_170 = wp::extract(var_0, var_157);
        var_171 = wp::mul(var_161, var_161);
        var_172 = wp::mul(var_165, var_165);
        var_173 = wp::add(var_171, var_172);
        var_174 = wp::mul(var_169, var_169);
        var_175 = wp::add(var_173, var_174);
        var_176 = (var_175 <= var_max_sqdist);
        if (var_176) {
        }
        if (!var_176) {
        }
        var_179 = wp::where(var_176, var_177, var_178);
        var_180 = wp::add(var_170, var_179);
        var_181 = wp::min(var_180, var_30);
        wp::assign_inplace(var_0, var_157, var_181);
        // x = q[0] - xs[j]                                                                   <L 50>
        var_184 = wp::extract(var_4, var_183);
        var_185 = wp::extract(var_xs, var_182);
        var_186 = wp::sub(var_184, var_185);
        // y = q[1] - ys[j]                                                                   <L 51>
        var_188 = wp::extract(var_4, var_187);
        var_189 = wp::extract(var_ys, var_182);
        var_190 = wp::sub(var_188, var_189);
        // z = q[2] - zs[j]                                                                   <L 52>
        var_192 = wp::extract(var_4, var_191);
        var_193 = wp::extract(var_zs, var_182);
        var_194 = wp::sub(var_192, var_193);
        // total[j] = min(total[j] + (1 if x * x + y * y + z * z <= max_sqdist else 0), MANY)       <L 53>
        var_195 = wp::extract(var_0, var_182);
        var_196 = wp::mul(var_186, var_186);
        var_197 = wp::mul(var_190, var_190);
        var_198 = wp::add(var_196, var_197);
        var_199 = wp::mul(var_194, var_194);
        var_200 = wp::add(var_198, var_199);
        var_201 = (var_200 <= var_max_sqdist);
        if (var_201) {
        }
        if (!var_201) {
        }
        var_204 = wp::where(var_201, var_202, var_203);
        var_205 = wp::add(var_195, var_204);
        var_206 = wp::min(var_205, var_30);
        wp::assign_inplace(var_0, var_182, var_206);
        goto start_for_0;
    end_for_0:;
    // return total                                                                           <L 54>
    return var_0;
}


// /work/main/src/pointloom/kernels/search/tree_walk.py:52
static CUDA_CALLABLE wp::vec_t<4, wp::int64> put_off_0(
    wp::vec_t<4, wp::int64> var_step,
    wp::int32 var_children)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int64 var_1;
    const wp::int32 var_2 = 1;
    wp::int64 var_3;
    const wp::int32 var_4 = 2;
    wp::int64 var_5;
    const wp::int32 var_6 = 3;
    wp::int64 var_7;
    wp::int64 var_8;
    const wp::int32 var_9 = 1;
    wp::int64 var_10;
    wp::int32 var_11;
    wp::int64 var_12;
    wp::int64 var_13;
    wp::int64 var_14;
    wp::vec_t<4, wp::int64> var_15;
    //---------
    // forward
    // def put_off(step: traversal, children: int) -> traversal:                              <L 53>
    // return traversal(step[0], step[1], step[2], step[3] | (int64(children) << pending_shift(int(step[1]))))       <L 55>
    var_1 = wp::extract(var_step, var_0);
    var_3 = wp::extract(var_step, var_2);
    var_5 = wp::extract(var_step, var_4);
    var_7 = wp::extract(var_step, var_6);
    var_8 = wp::int64(var_children);
    var_10 = wp::extract(var_step, var_9);
    var_11 = wp::int(var_10);
    var_12 = pending_shift_0(var_11);
    var_13 = wp::lshift(var_8, var_12);
    var_14 = wp::bit_or(var_7, var_13);
    var_15 = wp::vec_t<4, wp::int64>(var_1, var_3, var_5, var_14);
    return var_15;
}


// <pointloom.kernels.segmentation.dbscan.count_group>:1
static CUDA_CALLABLE wp::vec_t<8, wp::int32> count_group_0(
    wp::vec_t<8, wp::int32> var_counts,
    wp::vec_t<8, wp::float32> var_xs,
    wp::vec_t<8, wp::float32> var_ys,
    wp::vec_t<8, wp::float32> var_zs,
    wp::int32 var_leaf,
    wp::int32 var_tree__count,
    wp::int32 var_tree__root,
    wp::array_t<wp::int32> var_tree__levels,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> var_tree__points,
    wp::float32 var_max_sqdist)
{
    //---------
    // primal vars
    wp::vec_t<8, wp::int32> var_0;
    const wp::int32 var_1 = 0;
    wp::vec_t<3, wp::float32> var_2;
    const wp::int32 var_3 = 1;
    wp::vec_t<3, wp::float32> var_4;
    const wp::int32 var_5 = 0;
    wp::int32 var_6;
    const wp::int32 var_7 = 0;
    const wp::int32 var_8 = 3;
    const wp::int32 var_9 = 0;
    wp::int32 var_10;
    wp::int32 var_11;
    wp::vec_t<4, wp::int64> var_12;
    const wp::int32 var_13 = 1;
    wp::int32 var_14;
    wp::vec_t<4, wp::int64> var_15;
    const wp::int32 var_16 = 0;
    wp::int64 var_17;
    wp::int32 var_18;
    const wp::int32 var_19 = 1;
    wp::int32 var_20;
    bool var_21;
    const wp::int32 var_22 = 0;
    wp::int64 var_23;
    wp::int32 var_24;
    const wp::int32 var_25 = 1;
    wp::int64 var_26;
    wp::int32 var_27;
    const wp::int32 var_28 = 2;
    wp::int64 var_29;
    wp::int32 var_30;
    wp::int32 var_31;
    const wp::int32 var_32 = 0;
    bool var_33;
    wp::int32 var_34;
    wp::vec_t<8, wp::float32> var_35;
    wp::int32 var_36;
    wp::int32 var_37;
    wp::int32 var_38;
    const wp::int32 var_39 = 0;
    bool var_40;
    wp::vec_t<8, wp::float32> var_41;
    wp::int32 var_42;
    wp::int32 var_43;
    const wp::int32 var_44 = 0;
    bool var_45;
    wp::int32 var_46;
    wp::vec_t<8, wp::int32> var_47;
    wp::vec_t<8, wp::int32> var_48;
    wp::int32 var_49;
    wp::vec_t<8, wp::int32> var_50;
    wp::int32 var_51;
    const wp::int32 var_52 = 1;
    bool var_53;
    wp::int32 var_54;
    const wp::int32 var_55 = 0;
    bool var_56;
    wp::int32 var_57;
    const wp::int32 var_58 = 1;
    wp::int32 var_59;
    wp::int32 var_60;
    const wp::int32 var_61 = 8;
    wp::int32 var_62;
    wp::int32 var_63;
    const wp::int32 var_64 = 8;
    wp::int32 var_65;
    wp::int32 var_66;
    wp::int32 var_67;
    wp::vec_t<8, wp::int32> var_68;
    wp::vec_t<8, wp::int32> var_69;
    wp::int32 var_70;
    const wp::int32 var_71 = 1;
    bool var_72;
    wp::vec_t<4, wp::int64> var_73;
    wp::vec_t<4, wp::int64> var_74;
    const wp::int32 var_75 = 1;
    wp::int32 var_76;
    wp::vec_t<4, wp::int64> var_77;
    //---------
    // forward
    // def count_group(counts, xs, ys, zs, leaf, tree__count, tree__root, tree__levels, tree__boxes, tree__points, max_sqdist):       <L 1>
    // total = counts                                                                         <L 3>
    var_0 = wp::copy(var_counts);
    // a = box_corner(tree__boxes, leaf, 0)                                                   <L 4>
    var_2 = box_corner_0(var_tree__boxes, var_leaf, var_1);
    // b = box_corner(tree__boxes, leaf, 1)                                                   <L 5>
    var_4 = box_corner_0(var_tree__boxes, var_leaf, var_3);
    // near = int(0)                                                                          <L 6>
    var_6 = wp::int(var_5);
    // step__nodes_after__3 = next_node__nodes_after(begin_traversal__nodes_after(0, leaf >> FAN_BITS__nodes_after * 0), tree__root + 1)       <L 7>
    var_10 = wp::mul(var_8, var_9);
    var_11 = wp::rshift(var_leaf, var_10);
    var_12 = begin_traversal_0(var_7, var_11);
    var_14 = wp::add(var_tree__root, var_13);
    var_15 = next_node_0(var_12, var_14);
    // while int(step__nodes_after__3[0]) <= tree__root + 1:                                  <L 8>
    start_while_0:;
    var_17 = wp::extract(var_15, var_16);
    var_18 = wp::int(var_17);
    var_20 = wp::add(var_tree__root, var_19);
    var_21 = (var_18 <= var_20);
    if ((var_21) == false) goto end_while_0;
        // height = int(step__nodes_after__3[0])                                              <L 9>
        var_23 = wp::extract(var_15, var_22);
        var_24 = wp::int(var_23);
        // level = int(step__nodes_after__3[1])                                               <L 10>
        var_26 = wp::extract(var_15, var_25);
        var_27 = wp::int(var_26);
        // node = int(step__nodes_after__3[2])                                                <L 11>
        var_29 = wp::extract(var_15, var_28);
        var_30 = wp::int(var_29);
        // if minimum_of(total) >= 0:                                                         <L 12>
        var_31 = minimum_of_0(var_0);
        var_33 = (var_31 >= var_32);
        if (var_33) {
            // break                                                                          <L 13>
            goto end_while_0;
        }
        // record = record_of(tree__levels, level, node)                                      <L 14>
        var_34 = record_of_0(var_tree__levels, var_27, var_30);
        // near = bits_within(measure_boxes(tree__boxes, record, a, b), max_sqdist) & other_children(leaf, height, level)       <L 15>
        var_35 = measure_boxes_0(var_tree__boxes, var_34, var_2, var_4);
        var_36 = bits_within_0(var_35, var_max_sqdist);
        var_37 = other_children_0(var_leaf, var_24, var_27);
        var_38 = wp::bit_and(var_36, var_37);
        // if near != 0:                                                                      <L 16>
        var_40 = (var_38 != var_39);
        if (var_40) {
            // inside = near & bits_within(measure_farthest(tree__boxes, record, a, b), max_sqdist)       <L 17>
            var_41 = measure_farthest_0(var_tree__boxes, var_34, var_2, var_4);
            var_42 = bits_within_0(var_41, var_max_sqdist);
            var_43 = wp::bit_and(var_38, var_42);
            // if inside != 0:                                                                <L 18>
            var_45 = (var_43 != var_44);
            if (var_45) {
                // total += numbers(point_sum(inside, level, node, tree__count))              <L 19>
                var_46 = point_sum_0(var_43, var_27, var_30, var_tree__count);
                var_47 = wp::vec_t<8, wp::int32>(var_46);
                var_48 = wp::add(var_0, var_47);
                // near = near ^ inside                                                       <L 20>
                var_49 = wp::bit_xor(var_38, var_43);
            }
            var_50 = wp::where(var_45, var_48, var_0);
            var_51 = wp::where(var_45, var_49, var_38);
            // if level == 1:                                                                 <L 21>
            var_53 = (var_27 == var_52);
            if (var_53) {
                // left__bits_of__2 = near                                                    <L 22>
                var_54 = wp::copy(var_51);
                // while left__bits_of__2 != 0:                                               <L 23>
    start_while_2:;
                var_56 = (var_54 != var_55);
    if ((var_56) == false) goto end_while_2;
                    // child__leaves_of__1 = lowest_bit(left__bits_of__2)                     <L 24>
                    var_57 = lowest_bit_0(var_54);
                    // left__bits_of__2 = left__bits_of__2 & left__bits_of__2 - 1             <L 25>
                    var_59 = wp::sub(var_54, var_58);
                    var_60 = wp::bit_and(var_54, var_59);
                    // first = (node * FAN__leaves_of + child__leaves_of__1) * LEAF__leaves_of       <L 26>
                    var_62 = wp::mul(var_30, var_61);
                    var_63 = wp::add(var_62, var_57);
                    var_65 = wp::mul(var_63, var_64);
                    // last = min(first + LEAF__leaves_of, tree__count)                       <L 27>
                    var_66 = wp::add(var_65, var_64);
                    var_67 = wp::min(var_66, var_tree__count);
                    // total = count_leaf(total, xs, ys, zs, first, last, tree__points, max_sqdist)       <L 28>
                    var_68 = count_leaf_0(var_50, var_xs, var_ys, var_zs, var_65, var_67, var_tree__points, var_max_sqdist);
                    wp::assign(var_50, var_68);
                    wp::assign(var_54, var_60);
    goto start_while_2;
    end_while_2:;
            }
        }
        var_69 = wp::where(var_40, var_50, var_0);
        var_70 = wp::where(var_40, var_51, var_38);
        // if level > 1:                                                                      <L 29>
        var_72 = (var_27 > var_71);
        if (var_72) {
            // step__nodes_after__3 = put_off__nodes_after(step__nodes_after__3, near)        <L 30>
            var_73 = put_off_0(var_15, var_70);
        }
        var_74 = wp::where(var_72, var_73, var_15);
        // step__nodes_after__3 = next_node__nodes_after(step__nodes_after__3, tree__root + 1)       <L 31>
        var_76 = wp::add(var_tree__root, var_75);
        var_77 = next_node_0(var_74, var_76);
        wp::assign(var_0, var_69);
        wp::assign(var_6, var_70);
        wp::assign(var_15, var_77);
    goto start_while_0;
    end_while_0:;
    // return total                                                                           <L 32>
    return var_0;
}


// <pointloom.kernels.segmentation.dbscan.join_lanes>:1
static CUDA_CALLABLE wp::vec_t<8, wp::int32> join_lanes_0(
    wp::vec_t<8, wp::float32> var_xs,
    wp::vec_t<8, wp::float32> var_ys,
    wp::vec_t<8, wp::float32> var_zs,
    wp::float32 var_max_sqdist)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::vec_t<8, wp::int32> var_1;
    const wp::int32 var_2 = 0;
    const wp::int32 var_3 = 1;
    wp::int32 var_4;
    const wp::int32 var_5 = 1;
    const wp::int32 var_6 = 1;
    wp::int32 var_7;
    const wp::int32 var_8 = 2;
    const wp::int32 var_9 = 1;
    wp::int32 var_10;
    const wp::int32 var_11 = 3;
    const wp::int32 var_12 = 1;
    wp::int32 var_13;
    const wp::int32 var_14 = 4;
    const wp::int32 var_15 = 1;
    wp::int32 var_16;
    const wp::int32 var_17 = 5;
    const wp::int32 var_18 = 1;
    wp::int32 var_19;
    const wp::int32 var_20 = 6;
    const wp::int32 var_21 = 1;
    wp::int32 var_22;
    const wp::int32 var_23 = 7;
    const wp::int32 var_24 = 1;
    wp::int32 var_25;
    const wp::int32 var_26 = 0;
    const wp::int32 var_27 = 0;
    wp::int32 var_28;
    const wp::int32 var_29 = 0;
    wp::float32 var_30;
    wp::float32 var_31;
    wp::float32 var_32;
    wp::float32 var_33;
    wp::float32 var_34;
    wp::float32 var_35;
    wp::float32 var_36;
    wp::float32 var_37;
    wp::float32 var_38;
    wp::float32 var_39;
    wp::float32 var_40;
    wp::float32 var_41;
    wp::float32 var_42;
    wp::float32 var_43;
    bool var_44;
    wp::int32 var_45;
    const wp::int32 var_46 = 0;
    wp::int32 var_47;
    wp::int32 var_48;
    const wp::int32 var_49 = 1;
    wp::float32 var_50;
    wp::float32 var_51;
    wp::float32 var_52;
    wp::float32 var_53;
    wp::float32 var_54;
    wp::float32 var_55;
    wp::float32 var_56;
    wp::float32 var_57;
    wp::float32 var_58;
    wp::float32 var_59;
    wp::float32 var_60;
    wp::float32 var_61;
    wp::float32 var_62;
    wp::float32 var_63;
    bool var_64;
    wp::int32 var_65;
    const wp::int32 var_66 = 0;
    wp::int32 var_67;
    wp::int32 var_68;
    const wp::int32 var_69 = 2;
    wp::float32 var_70;
    wp::float32 var_71;
    wp::float32 var_72;
    wp::float32 var_73;
    wp::float32 var_74;
    wp::float32 var_75;
    wp::float32 var_76;
    wp::float32 var_77;
    wp::float32 var_78;
    wp::float32 var_79;
    wp::float32 var_80;
    wp::float32 var_81;
    wp::float32 var_82;
    wp::float32 var_83;
    bool var_84;
    wp::int32 var_85;
    const wp::int32 var_86 = 0;
    wp::int32 var_87;
    wp::int32 var_88;
    const wp::int32 var_89 = 3;
    wp::float32 var_90;
    wp::float32 var_91;
    wp::float32 var_92;
    wp::float32 var_93;
    wp::float32 var_94;
    wp::float32 var_95;
    wp::float32 var_96;
    wp::float32 var_97;
    wp::float32 var_98;
    wp::float32 var_99;
    wp::float32 var_100;
    wp::float32 var_101;
    wp::float32 var_102;
    wp::float32 var_103;
    bool var_104;
    wp::int32 var_105;
    const wp::int32 var_106 = 0;
    wp::int32 var_107;
    wp::int32 var_108;
    const wp::int32 var_109 = 4;
    wp::float32 var_110;
    wp::float32 var_111;
    wp::float32 var_112;
    wp::float32 var_113;
    wp::float32 var_114;
    wp::float32 var_115;
    wp::float32 var_116;
    wp::float32 var_117;
    wp::float32 var_118;
    wp::float32 var_119;
    wp::float32 var_120;
    wp::float32 var_121;
    wp::float32 var_122;
    wp::float32 var_123;
    bool var_124;
    wp::int32 var_125;
    const wp::int32 var_126 = 0;
    wp::int32 var_127;
    wp::int32 var_128;
    const wp::int32 var_129 = 5;
    wp::float32 var_130;
    wp::float32 var_131;
    wp::float32 var_132;
    wp::float32 var_133;
    wp::float32 var_134;
    wp::float32 var_135;
    wp::float32 var_136;
    wp::float32 var_137;
    wp::float32 var_138;
    wp::float32 var_139;
    wp::float32 var_140;
    wp::float32 var_141;
    wp::float32 var_142;
    wp::float32 var_143;
    bool var_144;
    wp::int32 var_145;
    const wp::int32 var_146 = 0;
    wp::int32 var_147;
    wp::int32 var_148;
    const wp::int32 var_149 = 6;
    wp::float32 var_150;
    wp::float32 var_151;
    wp::float32 var_152;
    wp::float32 var_153;
    wp::float32 var_154;
    wp::float32 var_155;
    wp::float32 var_156;
    wp::float32 var_157;
    wp::float32 var_158;
    wp::float32 var_159;
    wp::float32 var_160;
    wp::float32 var_161;
    wp::float32 var_162;
    wp::float32 var_163;
    bool var_164;
    wp::int32 var_165;
    const wp::int32 var_166 = 0;
    wp::int32 var_167;
    wp::int32 var_168;
    const wp::int32 var_169 = 7;
    wp::float32 var_170;
    wp::float32 var_171;
    wp::float32 var_172;
    wp::float32 var_173;
    wp::float32 var_174;
    wp::float32 var_175;
    wp::float32 var_176;
    wp::float32 var_177;
    wp::float32 var_178;
    wp::float32 var_179;
    wp::float32 var_180;
    wp::float32 var_181;
    wp::float32 var_182;
    wp::float32 var_183;
    bool var_184;
    wp::int32 var_185;
    const wp::int32 var_186 = 0;
    wp::int32 var_187;
    wp::int32 var_188;
    wp::int32 var_189;
    wp::int32 var_190;
    const wp::int32 var_191 = 0;
    wp::int32 var_192;
    wp::int32 var_193;
    const wp::int32 var_194 = 0;
    bool var_195;
    wp::int32 var_196;
    wp::int32 var_197;
    const wp::int32 var_198 = 1;
    wp::int32 var_199;
    wp::int32 var_200;
    const wp::int32 var_201 = 0;
    bool var_202;
    wp::int32 var_203;
    wp::int32 var_204;
    const wp::int32 var_205 = 2;
    wp::int32 var_206;
    wp::int32 var_207;
    const wp::int32 var_208 = 0;
    bool var_209;
    wp::int32 var_210;
    wp::int32 var_211;
    const wp::int32 var_212 = 3;
    wp::int32 var_213;
    wp::int32 var_214;
    const wp::int32 var_215 = 0;
    bool var_216;
    wp::int32 var_217;
    wp::int32 var_218;
    const wp::int32 var_219 = 4;
    wp::int32 var_220;
    wp::int32 var_221;
    const wp::int32 var_222 = 0;
    bool var_223;
    wp::int32 var_224;
    wp::int32 var_225;
    const wp::int32 var_226 = 5;
    wp::int32 var_227;
    wp::int32 var_228;
    const wp::int32 var_229 = 0;
    bool var_230;
    wp::int32 var_231;
    wp::int32 var_232;
    const wp::int32 var_233 = 6;
    wp::int32 var_234;
    wp::int32 var_235;
    const wp::int32 var_236 = 0;
    bool var_237;
    wp::int32 var_238;
    wp::int32 var_239;
    const wp::int32 var_240 = 7;
    wp::int32 var_241;
    wp::int32 var_242;
    const wp::int32 var_243 = 0;
    bool var_244;
    wp::int32 var_245;
    wp::int32 var_246;
    const wp::int32 var_247 = 1;
    const wp::int32 var_248 = 0;
    wp::int32 var_249;
    const wp::int32 var_250 = 0;
    wp::float32 var_251;
    wp::float32 var_252;
    wp::float32 var_253;
    wp::float32 var_254;
    wp::float32 var_255;
    wp::float32 var_256;
    wp::float32 var_257;
    wp::float32 var_258;
    wp::float32 var_259;
    wp::float32 var_260;
    wp::float32 var_261;
    wp::float32 var_262;
    wp::float32 var_263;
    wp::float32 var_264;
    bool var_265;
    wp::int32 var_266;
    const wp::int32 var_267 = 0;
    wp::int32 var_268;
    wp::int32 var_269;
    const wp::int32 var_270 = 1;
    wp::float32 var_271;
    wp::float32 var_272;
    wp::float32 var_273;
    wp::float32 var_274;
    wp::float32 var_275;
    wp::float32 var_276;
    wp::float32 var_277;
    wp::float32 var_278;
    wp::float32 var_279;
    wp::float32 var_280;
    wp::float32 var_281;
    wp::float32 var_282;
    wp::float32 var_283;
    wp::float32 var_284;
    bool var_285;
    wp::int32 var_286;
    const wp::int32 var_287 = 0;
    wp::int32 var_288;
    wp::int32 var_289;
    const wp::int32 var_290 = 2;
    wp::float32 var_291;
    wp::float32 var_292;
    wp::float32 var_293;
    wp::float32 var_294;
    wp::float32 var_295;
    wp::float32 var_296;
    wp::float32 var_297;
    wp::float32 var_298;
    wp::float32 var_299;
    wp::float32 var_300;
    wp::float32 var_301;
    wp::float32 var_302;
    wp::float32 var_303;
    wp::float32 var_304;
    bool var_305;
    wp::int32 var_306;
    const wp::int32 var_307 = 0;
    wp::int32 var_308;
    wp::int32 var_309;
    const wp::int32 var_310 = 3;
    wp::float32 var_311;
    wp::float32 var_312;
    wp::float32 var_313;
    wp::float32 var_314;
    wp::float32 var_315;
    wp::float32 var_316;
    wp::float32 var_317;
    wp::float32 var_318;
    wp::float32 var_319;
    wp::float32 var_320;
    wp::float32 var_321;
    wp::float32 var_322;
    wp::float32 var_323;
    wp::float32 var_324;
    bool var_325;
    wp::int32 var_326;
    const wp::int32 var_327 = 0;
    wp::int32 var_328;
    wp::int32 var_329;
    const wp::int32 var_330 = 4;
    wp::float32 var_331;
    wp::float32 var_332;
    wp::float32 var_333;
    wp::float32 var_334;
    wp::float32 var_335;
    wp::float32 var_336;
    wp::float32 var_337;
    wp::float32 var_338;
    wp::float32 var_339;
    wp::float32 var_340;
    wp::float32 var_341;
    wp::float32 var_342;
    wp::float32 var_343;
    wp::float32 var_344;
    bool var_345;
    wp::int32 var_346;
    const wp::int32 var_347 = 0;
    wp::int32 var_348;
    wp::int32 var_349;
    const wp::int32 var_350 = 5;
    wp::float32 var_351;
    wp::float32 var_352;
    wp::float32 var_353;
    wp::float32 var_354;
    wp::float32 var_355;
    wp::float32 var_356;
    wp::float32 var_357;
    wp::float32 var_358;
    wp::float32 var_359;
    wp::float32 var_360;
    wp::float32 var_361;
    wp::float32 var_362;
    wp::float32 var_363;
    wp::float32 var_364;
    bool var_365;
    wp::int32 var_366;
    const wp::int32 var_367 = 0;
    wp::int32 var_368;
    wp::int32 var_369;
    const wp::int32 var_370 = 6;
    wp::float32 var_371;
    wp::float32 var_372;
    wp::float32 var_373;
    wp::float32 var_374;
    wp::float32 var_375;
    wp::float32 var_376;
    wp::float32 var_377;
    wp::float32 var_378;
    wp::float32 var_379;
    wp::float32 var_380;
    wp::float32 var_381;
    wp::float32 var_382;
    wp::float32 var_383;
    wp::float32 var_384;
    bool var_385;
    wp::int32 var_386;
    const wp::int32 var_387 = 0;
    wp::int32 var_388;
    wp::int32 var_389;
    const wp::int32 var_390 = 7;
    wp::float32 var_391;
    wp::float32 var_392;
    wp::float32 var_393;
    wp::float32 var_394;
    wp::float32 var_395;
    wp::float32 var_396;
    wp::float32 var_397;
    wp::float32 var_398;
    wp::float32 var_399;
    wp::float32 var_400;
    wp::float32 var_401;
    wp::float32 var_402;
    wp::float32 var_403;
    wp::float32 var_404;
    bool var_405;
    wp::int32 var_406;
    const wp::int32 var_407 = 0;
    wp::int32 var_408;
    wp::int32 var_409;
    wp::int32 var_410;
    wp::int32 var_411;
    const wp::int32 var_412 = 0;
    wp::int32 var_413;
    wp::int32 var_414;
    const wp::int32 var_415 = 0;
    bool var_416;
    wp::int32 var_417;
    wp::int32 var_418;
    const wp::int32 var_419 = 1;
    wp::int32 var_420;
    wp::int32 var_421;
    const wp::int32 var_422 = 0;
    bool var_423;
    wp::int32 var_424;
    wp::int32 var_425;
    const wp::int32 var_426 = 2;
    wp::int32 var_427;
    wp::int32 var_428;
    const wp::int32 var_429 = 0;
    bool var_430;
    wp::int32 var_431;
    wp::int32 var_432;
    const wp::int32 var_433 = 3;
    wp::int32 var_434;
    wp::int32 var_435;
    const wp::int32 var_436 = 0;
    bool var_437;
    wp::int32 var_438;
    wp::int32 var_439;
    const wp::int32 var_440 = 4;
    wp::int32 var_441;
    wp::int32 var_442;
    const wp::int32 var_443 = 0;
    bool var_444;
    wp::int32 var_445;
    wp::int32 var_446;
    const wp::int32 var_447 = 5;
    wp::int32 var_448;
    wp::int32 var_449;
    const wp::int32 var_450 = 0;
    bool var_451;
    wp::int32 var_452;
    wp::int32 var_453;
    const wp::int32 var_454 = 6;
    wp::int32 var_455;
    wp::int32 var_456;
    const wp::int32 var_457 = 0;
    bool var_458;
    wp::int32 var_459;
    wp::int32 var_460;
    const wp::int32 var_461 = 7;
    wp::int32 var_462;
    wp::int32 var_463;
    const wp::int32 var_464 = 0;
    bool var_465;
    wp::int32 var_466;
    wp::int32 var_467;
    const wp::int32 var_468 = 2;
    const wp::int32 var_469 = 0;
    wp::int32 var_470;
    const wp::int32 var_471 = 0;
    wp::float32 var_472;
    wp::float32 var_473;
    wp::float32 var_474;
    wp::float32 var_475;
    wp::float32 var_476;
    wp::float32 var_477;
    wp::float32 var_478;
    wp::float32 var_479;
    wp::float32 var_480;
    wp::float32 var_481;
    wp::float32 var_482;
    wp::float32 var_483;
    wp::float32 var_484;
    wp::float32 var_485;
    bool var_486;
    wp::int32 var_487;
    const wp::int32 var_488 = 0;
    wp::int32 var_489;
    wp::int32 var_490;
    const wp::int32 var_491 = 1;
    wp::float32 var_492;
    wp::float32 var_493;
    wp::float32 var_494;
    wp::float32 var_495;
    wp::float32 var_496;
    wp::float32 var_497;
    wp::float32 var_498;
    wp::float32 var_499;
    wp::float32 var_500;
    wp::float32 var_501;
    wp::float32 var_502;
    wp::float32 var_503;
    wp::float32 var_504;
    wp::float32 var_505;
    bool var_506;
    wp::int32 var_507;
    const wp::int32 var_508 = 0;
    wp::int32 var_509;
    wp::int32 var_510;
    const wp::int32 var_511 = 2;
    wp::float32 var_512;
    wp::float32 var_513;
    wp::float32 var_514;
    wp::float32 var_515;
    wp::float32 var_516;
    wp::float32 var_517;
    wp::float32 var_518;
    wp::float32 var_519;
    wp::float32 var_520;
    wp::float32 var_521;
    wp::float32 var_522;
    wp::float32 var_523;
    wp::float32 var_524;
    wp::float32 var_525;
    bool var_526;
    wp::int32 var_527;
    const wp::int32 var_528 = 0;
    wp::int32 var_529;
    wp::int32 var_530;
    const wp::int32 var_531 = 3;
    wp::float32 var_532;
    wp::float32 var_533;
    wp::float32 var_534;
    wp::float32 var_535;
    wp::float32 var_536;
    wp::float32 var_537;
    wp::float32 var_538;
    wp::float32 var_539;
    wp::float32 var_540;
    wp::float32 var_541;
    wp::float32 var_542;
    wp::float32 var_543;
    wp::float32 var_544;
    wp::float32 var_545;
    bool var_546;
    wp::int32 var_547;
    const wp::int32 var_548 = 0;
    wp::int32 var_549;
    wp::int32 var_550;
    const wp::int32 var_551 = 4;
    wp::float32 var_552;
    wp::float32 var_553;
    wp::float32 var_554;
    wp::float32 var_555;
    wp::float32 var_556;
    wp::float32 var_557;
    wp::float32 var_558;
    wp::float32 var_559;
    wp::float32 var_560;
    wp::float32 var_561;
    wp::float32 var_562;
    wp::float32 var_563;
    wp::float32 var_564;
    wp::float32 var_565;
    bool var_566;
    wp::int32 var_567;
    const wp::int32 var_568 = 0;
    wp::int32 var_569;
    wp::int32 var_570;
    const wp::int32 var_571 = 5;
    wp::float32 var_572;
    wp::float32 var_573;
    wp::float32 var_574;
    wp::float32 var_575;
    wp::float32 var_576;
    wp::float32 var_577;
    wp::float32 var_578;
    wp::float32 var_579;
    wp::float32 var_580;
    wp::float32 var_581;
    wp::float32 var_582;
    wp::float32 var_583;
    wp::float32 var_584;
    wp::float32 var_585;
    bool var_586;
    wp::int32 var_587;
    const wp::int32 var_588 = 0;
    wp::int32 var_589;
    wp::int32 var_590;
    const wp::int32 var_591 = 6;
    wp::float32 var_592;
    wp::float32 var_593;
    wp::float32 var_594;
    wp::float32 var_595;
    wp::float32 var_596;
    wp::float32 var_597;
    wp::float32 var_598;
    wp::float32 var_599;
    wp::float32 var_600;
    wp::float32 var_601;
    wp::float32 var_602;
    wp::float32 var_603;
    wp::float32 var_604;
    wp::float32 var_605;
    bool var_606;
    wp::int32 var_607;
    const wp::int32 var_608 = 0;
    wp::int32 var_609;
    wp::int32 var_610;
    const wp::int32 var_611 = 7;
    wp::float32 var_612;
    wp::float32 var_613;
    wp::float32 var_614;
    wp::float32 var_615;
    wp::float32 var_616;
    wp::float32 var_617;
    wp::float32 var_618;
    wp::float32 var_619;
    wp::float32 var_620;
    wp::float32 var_621;
    wp::float32 var_622;
    wp::float32 var_623;
    wp::float32 var_624;
    wp::float32 var_625;
    bool var_626;
    wp::int32 var_627;
    const wp::int32 var_628 = 0;
    wp::int32 var_629;
    wp::int32 var_630;
    wp::int32 var_631;
    wp::int32 var_632;
    const wp::int32 var_633 = 0;
    wp::int32 var_634;
    wp::int32 var_635;
    const wp::int32 var_636 = 0;
    bool var_637;
    wp::int32 var_638;
    wp::int32 var_639;
    const wp::int32 var_640 = 1;
    wp::int32 var_641;
    wp::int32 var_642;
    const wp::int32 var_643 = 0;
    bool var_644;
    wp::int32 var_645;
    wp::int32 var_646;
    const wp::int32 var_647 = 2;
    wp::int32 var_648;
    wp::int32 var_649;
    const wp::int32 var_650 = 0;
    bool var_651;
    wp::int32 var_652;
    wp::int32 var_653;
    const wp::int32 var_654 = 3;
    wp::int32 var_655;
    wp::int32 var_656;
    const wp::int32 var_657 = 0;
    bool var_658;
    wp::int32 var_659;
    wp::int32 var_660;
    const wp::int32 var_661 = 4;
    wp::int32 var_662;
    wp::int32 var_663;
    const wp::int32 var_664 = 0;
    bool var_665;
    wp::int32 var_666;
    wp::int32 var_667;
    const wp::int32 var_668 = 5;
    wp::int32 var_669;
    wp::int32 var_670;
    const wp::int32 var_671 = 0;
    bool var_672;
    wp::int32 var_673;
    wp::int32 var_674;
    const wp::int32 var_675 = 6;
    wp::int32 var_676;
    wp::int32 var_677;
    const wp::int32 var_678 = 0;
    bool var_679;
    wp::int32 var_680;
    wp::int32 var_681;
    const wp::int32 var_682 = 7;
    wp::int32 var_683;
    wp::int32 var_684;
    const wp::int32 var_685 = 0;
    bool var_686;
    wp::int32 var_687;
    wp::int32 var_688;
    const wp::int32 var_689 = 3;
    const wp::int32 var_690 = 0;
    wp::int32 var_691;
    const wp::int32 var_692 = 0;
    wp::float32 var_693;
    wp::float32 var_694;
    wp::float32 var_695;
    wp::float32 var_696;
    wp::float32 var_697;
    wp::float32 var_698;
    wp::float32 var_699;
    wp::float32 var_700;
    wp::float32 var_701;
    wp::float32 var_702;
    wp::float32 var_703;
    wp::float32 var_704;
    wp::float32 var_705;
    wp::float32 var_706;
    bool var_707;
    wp::int32 var_708;
    const wp::int32 var_709 = 0;
    wp::int32 var_710;
    wp::int32 var_711;
    const wp::int32 var_712 = 1;
    wp::float32 var_713;
    wp::float32 var_714;
    wp::float32 var_715;
    wp::float32 var_716;
    wp::float32 var_717;
    wp::float32 var_718;
    wp::float32 var_719;
    wp::float32 var_720;
    wp::float32 var_721;
    wp::float32 var_722;
    wp::float32 var_723;
    wp::float32 var_724;
    wp::float32 var_725;
    wp::float32 var_726;
    bool var_727;
    wp::int32 var_728;
    const wp::int32 var_729 = 0;
    wp::int32 var_730;
    wp::int32 var_731;
    const wp::int32 var_732 = 2;
    wp::float32 var_733;
    wp::float32 var_734;
    wp::float32 var_735;
    wp::float32 var_736;
    wp::float32 var_737;
    wp::float32 var_738;
    wp::float32 var_739;
    wp::float32 var_740;
    wp::float32 var_741;
    wp::float32 var_742;
    wp::float32 var_743;
    wp::float32 var_744;
    wp::float32 var_745;
    wp::float32 var_746;
    bool var_747;
    wp::int32 var_748;
    const wp::int32 var_749 = 0;
    wp::int32 var_750;
    wp::int32 var_751;
    const wp::int32 var_752 = 3;
    wp::float32 var_753;
    wp::float32 var_754;
    wp::float32 var_755;
    wp::float32 var_756;
    wp::float32 var_757;
    wp::float32 var_758;
    wp::float32 var_759;
    wp::float32 var_760;
    wp::float32 var_761;
    wp::float32 var_762;
    wp::float32 var_763;
    wp::float32 var_764;
    wp::float32 var_765;
    wp::float32 var_766;
    bool var_767;
    wp::int32 var_768;
    const wp::int32 var_769 = 0;
    wp::int32 var_770;
    wp::int32 var_771;
    const wp::int32 var_772 = 4;
    wp::float32 var_773;
    wp::float32 var_774;
    wp::float32 var_775;
    wp::float32 var_776;
    wp::float32 var_777;
    wp::float32 var_778;
    wp::float32 var_779;
    wp::float32 var_780;
    wp::float32 var_781;
    wp::float32 var_782;
    wp::float32 var_783;
    wp::float32 var_784;
    wp::float32 var_785;
    wp::float32 var_786;
    bool var_787;
    wp::int32 var_788;
    const wp::int32 var_789 = 0;
    wp::int32 var_790;
    wp::int32 var_791;
    const wp::int32 var_792 = 5;
    wp::float32 var_793;
    wp::float32 var_794;
    wp::float32 var_795;
    wp::float32 var_796;
    wp::float32 var_797;
    wp::float32 var_798;
    wp::float32 var_799;
    wp::float32 var_800;
    wp::float32 var_801;
    wp::float32 var_802;
    wp::float32 var_803;
    wp::float32 var_804;
    wp::float32 var_805;
    wp::float32 var_806;
    bool var_807;
    wp::int32 var_808;
    const wp::int32 var_809 = 0;
    wp::int32 var_810;
    wp::int32 var_811;
    const wp::int32 var_812 = 6;
    wp::float32 var_813;
    wp::float32 var_814;
    wp::float32 var_815;
    wp::float32 var_816;
    wp::float32 var_817;
    wp::float32 var_818;
    wp::float32 var_819;
    wp::float32 var_820;
    wp::float32 var_821;
    wp::float32 var_822;
    wp::float32 var_823;
    wp::float32 var_824;
    wp::float32 var_825;
    wp::float32 var_826;
    bool var_827;
    wp::int32 var_828;
    const wp::int32 var_829 = 0;
    wp::int32 var_830;
    wp::int32 var_831;
    const wp::int32 var_832 = 7;
    wp::float32 var_833;
    wp::float32 var_834;
    wp::float32 var_835;
    wp::float32 var_836;
    wp::float32 var_837;
    wp::float32 var_838;
    wp::float32 var_839;
    wp::float32 var_840;
    wp::float32 var_841;
    wp::float32 var_842;
    wp::float32 var_843;
    wp::float32 var_844;
    wp::float32 var_845;
    wp::float32 var_846;
    bool var_847;
    wp::int32 var_848;
    const wp::int32 var_849 = 0;
    wp::int32 var_850;
    wp::int32 var_851;
    wp::int32 var_852;
    wp::int32 var_853;
    const wp::int32 var_854 = 0;
    wp::int32 var_855;
    wp::int32 var_856;
    const wp::int32 var_857 = 0;
    bool var_858;
    wp::int32 var_859;
    wp::int32 var_860;
    const wp::int32 var_861 = 1;
    wp::int32 var_862;
    wp::int32 var_863;
    const wp::int32 var_864 = 0;
    bool var_865;
    wp::int32 var_866;
    wp::int32 var_867;
    const wp::int32 var_868 = 2;
    wp::int32 var_869;
    wp::int32 var_870;
    const wp::int32 var_871 = 0;
    bool var_872;
    wp::int32 var_873;
    wp::int32 var_874;
    const wp::int32 var_875 = 3;
    wp::int32 var_876;
    wp::int32 var_877;
    const wp::int32 var_878 = 0;
    bool var_879;
    wp::int32 var_880;
    wp::int32 var_881;
    const wp::int32 var_882 = 4;
    wp::int32 var_883;
    wp::int32 var_884;
    const wp::int32 var_885 = 0;
    bool var_886;
    wp::int32 var_887;
    wp::int32 var_888;
    const wp::int32 var_889 = 5;
    wp::int32 var_890;
    wp::int32 var_891;
    const wp::int32 var_892 = 0;
    bool var_893;
    wp::int32 var_894;
    wp::int32 var_895;
    const wp::int32 var_896 = 6;
    wp::int32 var_897;
    wp::int32 var_898;
    const wp::int32 var_899 = 0;
    bool var_900;
    wp::int32 var_901;
    wp::int32 var_902;
    const wp::int32 var_903 = 7;
    wp::int32 var_904;
    wp::int32 var_905;
    const wp::int32 var_906 = 0;
    bool var_907;
    wp::int32 var_908;
    wp::int32 var_909;
    const wp::int32 var_910 = 4;
    const wp::int32 var_911 = 0;
    wp::int32 var_912;
    const wp::int32 var_913 = 0;
    wp::float32 var_914;
    wp::float32 var_915;
    wp::float32 var_916;
    wp::float32 var_917;
    wp::float32 var_918;
    wp::float32 var_919;
    wp::float32 var_920;
    wp::float32 var_921;
    wp::float32 var_922;
    wp::float32 var_923;
    wp::float32 var_924;
    wp::float32 var_925;
    wp::float32 var_926;
    wp::float32 var_927;
    bool var_928;
    wp::int32 var_929;
    const wp::int32 var_930 = 0;
    wp::int32 var_931;
    wp::int32 var_932;
    const wp::int32 var_933 = 1;
    wp::float32 var_934;
    wp::float32 var_935;
    wp::float32 var_936;
    wp::float32 var_937;
    wp::float32 var_938;
    wp::float32 var_939;
    wp::float32 var_940;
    wp::float32 var_941;
    wp::float32 var_942;
    wp::float32 var_943;
    wp::float32 var_944;
    wp::float32 var_945;
    wp::float32 var_946;
    wp::float32 var_947;
    bool var_948;
    wp::int32 var_949;
    const wp::int32 var_950 = 0;
    wp::int32 var_951;
    wp::int32 var_952;
    const wp::int32 var_953 = 2;
    wp::float32 var_954;
    wp::float32 var_955;
    wp::float32 var_956;
    wp::float32 var_957;
    wp::float32 var_958;
    wp::float32 var_959;
    wp::float32 var_960;
    wp::float32 var_961;
    wp::float32 var_962;
    wp::float32 var_963;
    wp::float32 var_964;
    wp::float32 var_965;
    wp::float32 var_966;
    wp::float32 var_967;
    bool var_968;
    wp::int32 var_969;
    const wp::int32 var_970 = 0;
    wp::int32 var_971;
    wp::int32 var_972;
    const wp::int32 var_973 = 3;
    wp::float32 var_974;
    wp::float32 var_975;
    wp::float32 var_976;
    wp::float32 var_977;
    wp::float32 var_978;
    wp::float32 var_979;
    wp::float32 var_980;
    wp::float32 var_981;
    wp::float32 var_982;
    wp::float32 var_983;
    wp::float32 var_984;
    wp::float32 var_985;
    wp::float32 var_986;
    wp::float32 var_987;
    bool var_988;
    wp::int32 var_989;
    const wp::int32 var_990 = 0;
    wp::int32 var_991;
    wp::int32 var_992;
    const wp::int32 var_993 = 4;
    wp::float32 var_994;
    wp::float32 var_995;
    wp::float32 var_996;
    wp::float32 var_997;
    wp::float32 var_998;
    wp::float32 var_999;
    wp::float32 var_1000;
    wp::float32 var_1001;
    wp::float32 var_1002;
    wp::float32 var_1003;
    wp::float32 var_1004;
    wp::float32 var_1005;
    wp::float32 var_1006;
    wp::float32 var_1007;
    bool var_1008;
    wp::int32 var_1009;
    const wp::int32 var_1010 = 0;
    wp::int32 var_1011;
    wp::int32 var_1012;
    const wp::int32 var_1013 = 5;
    wp::float32 var_1014;
    wp::float32 var_1015;
    wp::float32 var_1016;
    wp::float32 var_1017;
    wp::float32 var_1018;
    wp::float32 var_1019;
    wp::float32 var_1020;
    wp::float32 var_1021;
    wp::float32 var_1022;
    wp::float32 var_1023;
    wp::float32 var_1024;
    wp::float32 var_1025;
    wp::float32 var_1026;
    wp::float32 var_1027;
    bool var_1028;
    wp::int32 var_1029;
    const wp::int32 var_1030 = 0;
    wp::int32 var_1031;
    wp::int32 var_1032;
    const wp::int32 var_1033 = 6;
    wp::float32 var_1034;
    wp::float32 var_1035;
    wp::float32 var_1036;
    wp::float32 var_1037;
    wp::float32 var_1038;
    wp::float32 var_1039;
    wp::float32 var_1040;
    wp::float32 var_1041;
    wp::float32 var_1042;
    wp::float32 var_1043;
    wp::float32 var_1044;
    wp::float32 var_1045;
    wp::float32 var_1046;
    wp::float32 var_1047;
    bool var_1048;
    wp::int32 var_1049;
    const wp::int32 var_1050 = 0;
    wp::int32 var_1051;
    wp::int32 var_1052;
    const wp::int32 var_1053 = 7;
    wp::float32 var_1054;
    wp::float32 var_1055;
    wp::float32 var_1056;
    wp::float32 var_1057;
    wp::float32 var_1058;
    wp::float32 var_1059;
    wp::float32 var_1060;
    wp::float32 var_1061;
    wp::float32 var_1062;
    wp::float32 var_1063;
    wp::float32 var_1064;
    wp::float32 var_1065;
    wp::float32 var_1066;
    wp::float32 var_1067;
    bool var_1068;
    wp::int32 var_1069;
    const wp::int32 var_1070 = 0;
    wp::int32 var_1071;
    wp::int32 var_1072;
    wp::int32 var_1073;
    wp::int32 var_1074;
    const wp::int32 var_1075 = 0;
    wp::int32 var_1076;
    wp::int32 var_1077;
    const wp::int32 var_1078 = 0;
    bool var_1079;
    wp::int32 var_1080;
    wp::int32 var_1081;
    const wp::int32 var_1082 = 1;
    wp::int32 var_1083;
    wp::int32 var_1084;
    const wp::int32 var_1085 = 0;
    bool var_1086;
    wp::int32 var_1087;
    wp::int32 var_1088;
    const wp::int32 var_1089 = 2;
    wp::int32 var_1090;
    wp::int32 var_1091;
    const wp::int32 var_1092 = 0;
    bool var_1093;
    wp::int32 var_1094;
    wp::int32 var_1095;
    const wp::int32 var_1096 = 3;
    wp::int32 var_1097;
    wp::int32 var_1098;
    const wp::int32 var_1099 = 0;
    bool var_1100;
    wp::int32 var_1101;
    wp::int32 var_1102;
    const wp::int32 var_1103 = 4;
    wp::int32 var_1104;
    wp::int32 var_1105;
    const wp::int32 var_1106 = 0;
    bool var_1107;
    wp::int32 var_1108;
    wp::int32 var_1109;
    const wp::int32 var_1110 = 5;
    wp::int32 var_1111;
    wp::int32 var_1112;
    const wp::int32 var_1113 = 0;
    bool var_1114;
    wp::int32 var_1115;
    wp::int32 var_1116;
    const wp::int32 var_1117 = 6;
    wp::int32 var_1118;
    wp::int32 var_1119;
    const wp::int32 var_1120 = 0;
    bool var_1121;
    wp::int32 var_1122;
    wp::int32 var_1123;
    const wp::int32 var_1124 = 7;
    wp::int32 var_1125;
    wp::int32 var_1126;
    const wp::int32 var_1127 = 0;
    bool var_1128;
    wp::int32 var_1129;
    wp::int32 var_1130;
    const wp::int32 var_1131 = 5;
    const wp::int32 var_1132 = 0;
    wp::int32 var_1133;
    const wp::int32 var_1134 = 0;
    wp::float32 var_1135;
    wp::float32 var_1136;
    wp::float32 var_1137;
    wp::float32 var_1138;
    wp::float32 var_1139;
    wp::float32 var_1140;
    wp::float32 var_1141;
    wp::float32 var_1142;
    wp::float32 var_1143;
    wp::float32 var_1144;
    wp::float32 var_1145;
    wp::float32 var_1146;
    wp::float32 var_1147;
    wp::float32 var_1148;
    bool var_1149;
    wp::int32 var_1150;
    const wp::int32 var_1151 = 0;
    wp::int32 var_1152;
    wp::int32 var_1153;
    const wp::int32 var_1154 = 1;
    wp::float32 var_1155;
    wp::float32 var_1156;
    wp::float32 var_1157;
    wp::float32 var_1158;
    wp::float32 var_1159;
    wp::float32 var_1160;
    wp::float32 var_1161;
    wp::float32 var_1162;
    wp::float32 var_1163;
    wp::float32 var_1164;
    wp::float32 var_1165;
    wp::float32 var_1166;
    wp::float32 var_1167;
    wp::float32 var_1168;
    bool var_1169;
    wp::int32 var_1170;
    const wp::int32 var_1171 = 0;
    wp::int32 var_1172;
    wp::int32 var_1173;
    const wp::int32 var_1174 = 2;
    wp::float32 var_1175;
    wp::float32 var_1176;
    wp::float32 var_1177;
    wp::float32 var_1178;
    wp::float32 var_1179;
    wp::float32 var_1180;
    wp::float32 var_1181;
    wp::float32 var_1182;
    wp::float32 var_1183;
    wp::float32 var_1184;
    wp::float32 var_1185;
    wp::float32 var_1186;
    wp::float32 var_1187;
    wp::float32 var_1188;
    bool var_1189;
    wp::int32 var_1190;
    const wp::int32 var_1191 = 0;
    wp::int32 var_1192;
    wp::int32 var_1193;
    const wp::int32 var_1194 = 3;
    wp::float32 var_1195;
    wp::float32 var_1196;
    wp::float32 var_1197;
    wp::float32 var_1198;
    wp::float32 var_1199;
    wp::float32 var_1200;
    wp::float32 var_1201;
    wp::float32 var_1202;
    wp::float32 var_1203;
    wp::float32 var_1204;
    wp::float32 var_1205;
    wp::float32 var_1206;
    wp::float32 var_1207;
    wp::float32 var_1208;
    bool var_1209;
    wp::int32 var_1210;
    const wp::int32 var_1211 = 0;
    wp::int32 var_1212;
    wp::int32 var_1213;
    const wp::int32 var_1214 = 4;
    wp::float32 var_1215;
    wp::float32 var_1216;
    wp::float32 var_1217;
    wp::float32 var_1218;
    wp::float32 var_1219;
    wp::float32 var_1220;
    wp::float32 var_1221;
    wp::float32 var_1222;
    wp::float32 var_1223;
    wp::float32 var_1224;
    wp::float32 var_1225;
    wp::float32 var_1226;
    wp::float32 var_1227;
    wp::float32 var_1228;
    bool var_1229;
    wp::int32 var_1230;
    const wp::int32 var_1231 = 0;
    wp::int32 var_1232;
    wp::int32 var_1233;
    const wp::int32 var_1234 = 5;
    wp::float32 var_1235;
    wp::float32 var_1236;
    wp::float32 var_1237;
    wp::float32 var_1238;
    wp::float32 var_1239;
    wp::float32 var_1240;
    wp::float32 var_1241;
    wp::float32 var_1242;
    wp::float32 var_1243;
    wp::float32 var_1244;
    wp::float32 var_1245;
    wp::float32 var_1246;
    wp::float32 var_1247;
    wp::float32 var_1248;
    bool var_1249;
    wp::int32 var_1250;
    const wp::int32 var_1251 = 0;
    wp::int32 var_1252;
    wp::int32 var_1253;
    const wp::int32 var_1254 = 6;
    wp::float32 var_1255;
    wp::float32 var_1256;
    wp::float32 var_1257;
    wp::float32 var_1258;
    wp::float32 var_1259;
    wp::float32 var_1260;
    wp::float32 var_1261;
    wp::float32 var_1262;
    wp::float32 var_1263;
    wp::float32 var_1264;
    wp::float32 var_1265;
    wp::float32 var_1266;
    wp::float32 var_1267;
    wp::float32 var_1268;
    bool var_1269;
    wp::int32 var_1270;
    const wp::int32 var_1271 = 0;
    wp::int32 var_1272;
    wp::int32 var_1273;
    const wp::int32 var_1274 = 7;
    wp::float32 var_1275;
    wp::float32 var_1276;
    wp::float32 var_1277;
    wp::float32 var_1278;
    wp::float32 var_1279;
    wp::float32 var_1280;
    wp::float32 var_1281;
    wp::float32 var_1282;
    wp::float32 var_1283;
    wp::float32 var_1284;
    wp::float32 var_1285;
    wp::float32 var_1286;
    wp::float32 var_1287;
    wp::float32 var_1288;
    bool var_1289;
    wp::int32 var_1290;
    const wp::int32 var_1291 = 0;
    wp::int32 var_1292;
    wp::int32 var_1293;
    wp::int32 var_1294;
    wp::int32 var_1295;
    const wp::int32 var_1296 = 0;
    wp::int32 var_1297;
    wp::int32 var_1298;
    const wp::int32 var_1299 = 0;
    bool var_1300;
    wp::int32 var_1301;
    wp::int32 var_1302;
    const wp::int32 var_1303 = 1;
    wp::int32 var_1304;
    wp::int32 var_1305;
    const wp::int32 var_1306 = 0;
    bool var_1307;
    wp::int32 var_1308;
    wp::int32 var_1309;
    const wp::int32 var_1310 = 2;
    wp::int32 var_1311;
    wp::int32 var_1312;
    const wp::int32 var_1313 = 0;
    bool var_1314;
    wp::int32 var_1315;
    wp::int32 var_1316;
    const wp::int32 var_1317 = 3;
    wp::int32 var_1318;
    wp::int32 var_1319;
    const wp::int32 var_1320 = 0;
    bool var_1321;
    wp::int32 var_1322;
    wp::int32 var_1323;
    const wp::int32 var_1324 = 4;
    wp::int32 var_1325;
    wp::int32 var_1326;
    const wp::int32 var_1327 = 0;
    bool var_1328;
    wp::int32 var_1329;
    wp::int32 var_1330;
    const wp::int32 var_1331 = 5;
    wp::int32 var_1332;
    wp::int32 var_1333;
    const wp::int32 var_1334 = 0;
    bool var_1335;
    wp::int32 var_1336;
    wp::int32 var_1337;
    const wp::int32 var_1338 = 6;
    wp::int32 var_1339;
    wp::int32 var_1340;
    const wp::int32 var_1341 = 0;
    bool var_1342;
    wp::int32 var_1343;
    wp::int32 var_1344;
    const wp::int32 var_1345 = 7;
    wp::int32 var_1346;
    wp::int32 var_1347;
    const wp::int32 var_1348 = 0;
    bool var_1349;
    wp::int32 var_1350;
    wp::int32 var_1351;
    const wp::int32 var_1352 = 6;
    const wp::int32 var_1353 = 0;
    wp::int32 var_1354;
    const wp::int32 var_1355 = 0;
    wp::float32 var_1356;
    wp::float32 var_1357;
    wp::float32 var_1358;
    wp::float32 var_1359;
    wp::float32 var_1360;
    wp::float32 var_1361;
    wp::float32 var_1362;
    wp::float32 var_1363;
    wp::float32 var_1364;
    wp::float32 var_1365;
    wp::float32 var_1366;
    wp::float32 var_1367;
    wp::float32 var_1368;
    wp::float32 var_1369;
    bool var_1370;
    wp::int32 var_1371;
    const wp::int32 var_1372 = 0;
    wp::int32 var_1373;
    wp::int32 var_1374;
    const wp::int32 var_1375 = 1;
    wp::float32 var_1376;
    wp::float32 var_1377;
    wp::float32 var_1378;
    wp::float32 var_1379;
    wp::float32 var_1380;
    wp::float32 var_1381;
    wp::float32 var_1382;
    wp::float32 var_1383;
    wp::float32 var_1384;
    wp::float32 var_1385;
    wp::float32 var_1386;
    wp::float32 var_1387;
    wp::float32 var_1388;
    wp::float32 var_1389;
    bool var_1390;
    wp::int32 var_1391;
    const wp::int32 var_1392 = 0;
    wp::int32 var_1393;
    wp::int32 var_1394;
    const wp::int32 var_1395 = 2;
    wp::float32 var_1396;
    wp::float32 var_1397;
    wp::float32 var_1398;
    wp::float32 var_1399;
    wp::float32 var_1400;
    wp::float32 var_1401;
    wp::float32 var_1402;
    wp::float32 var_1403;
    wp::float32 var_1404;
    wp::float32 var_1405;
    wp::float32 var_1406;
    wp::float32 var_1407;
    wp::float32 var_1408;
    wp::float32 var_1409;
    bool var_1410;
    wp::int32 var_1411;
    const wp::int32 var_1412 = 0;
    wp::int32 var_1413;
    wp::int32 var_1414;
    const wp::int32 var_1415 = 3;
    wp::float32 var_1416;
    wp::float32 var_1417;
    wp::float32 var_1418;
    wp::float32 var_1419;
    wp::float32 var_1420;
    wp::float32 var_1421;
    wp::float32 var_1422;
    wp::float32 var_1423;
    wp::float32 var_1424;
    wp::float32 var_1425;
    wp::float32 var_1426;
    wp::float32 var_1427;
    wp::float32 var_1428;
    wp::float32 var_1429;
    bool var_1430;
    wp::int32 var_1431;
    const wp::int32 var_1432 = 0;
    wp::int32 var_1433;
    wp::int32 var_1434;
    const wp::int32 var_1435 = 4;
    wp::float32 var_1436;
    wp::float32 var_1437;
    wp::float32 var_1438;
    wp::float32 var_1439;
    wp::float32 var_1440;
    wp::float32 var_1441;
    wp::float32 var_1442;
    wp::float32 var_1443;
    wp::float32 var_1444;
    wp::float32 var_1445;
    wp::float32 var_1446;
    wp::float32 var_1447;
    wp::float32 var_1448;
    wp::float32 var_1449;
    bool var_1450;
    wp::int32 var_1451;
    const wp::int32 var_1452 = 0;
    wp::int32 var_1453;
    wp::int32 var_1454;
    const wp::int32 var_1455 = 5;
    wp::float32 var_1456;
    wp::float32 var_1457;
    wp::float32 var_1458;
    wp::float32 var_1459;
    wp::float32 var_1460;
    wp::float32 var_1461;
    wp::float32 var_1462;
    wp::float32 var_1463;
    wp::float32 var_1464;
    wp::float32 var_1465;
    wp::float32 var_1466;
    wp::float32 var_1467;
    wp::float32 var_1468;
    wp::float32 var_1469;
    bool var_1470;
    wp::int32 var_1471;
    const wp::int32 var_1472 = 0;
    wp::int32 var_1473;
    wp::int32 var_1474;
    const wp::int32 var_1475 = 6;
    wp::float32 var_1476;
    wp::float32 var_1477;
    wp::float32 var_1478;
    wp::float32 var_1479;
    wp::float32 var_1480;
    wp::float32 var_1481;
    wp::float32 var_1482;
    wp::float32 var_1483;
    wp::float32 var_1484;
    wp::float32 var_1485;
    wp::float32 var_1486;
    wp::float32 var_1487;
    wp::float32 var_1488;
    wp::float32 var_1489;
    bool var_1490;
    wp::int32 var_1491;
    const wp::int32 var_1492 = 0;
    wp::int32 var_1493;
    wp::int32 var_1494;
    const wp::int32 var_1495 = 7;
    wp::float32 var_1496;
    wp::float32 var_1497;
    wp::float32 var_1498;
    wp::float32 var_1499;
    wp::float32 var_1500;
    wp::float32 var_1501;
    wp::float32 var_1502;
    wp::float32 var_1503;
    wp::float32 var_1504;
    wp::float32 var_1505;
    wp::float32 var_1506;
    wp::float32 var_1507;
    wp::float32 var_1508;
    wp::float32 var_1509;
    bool var_1510;
    wp::int32 var_1511;
    const wp::int32 var_1512 = 0;
    wp::int32 var_1513;
    wp::int32 var_1514;
    wp::int32 var_1515;
    wp::int32 var_1516;
    const wp::int32 var_1517 = 0;
    wp::int32 var_1518;
    wp::int32 var_1519;
    const wp::int32 var_1520 = 0;
    bool var_1521;
    wp::int32 var_1522;
    wp::int32 var_1523;
    const wp::int32 var_1524 = 1;
    wp::int32 var_1525;
    wp::int32 var_1526;
    const wp::int32 var_1527 = 0;
    bool var_1528;
    wp::int32 var_1529;
    wp::int32 var_1530;
    const wp::int32 var_1531 = 2;
    wp::int32 var_1532;
    wp::int32 var_1533;
    const wp::int32 var_1534 = 0;
    bool var_1535;
    wp::int32 var_1536;
    wp::int32 var_1537;
    const wp::int32 var_1538 = 3;
    wp::int32 var_1539;
    wp::int32 var_1540;
    const wp::int32 var_1541 = 0;
    bool var_1542;
    wp::int32 var_1543;
    wp::int32 var_1544;
    const wp::int32 var_1545 = 4;
    wp::int32 var_1546;
    wp::int32 var_1547;
    const wp::int32 var_1548 = 0;
    bool var_1549;
    wp::int32 var_1550;
    wp::int32 var_1551;
    const wp::int32 var_1552 = 5;
    wp::int32 var_1553;
    wp::int32 var_1554;
    const wp::int32 var_1555 = 0;
    bool var_1556;
    wp::int32 var_1557;
    wp::int32 var_1558;
    const wp::int32 var_1559 = 6;
    wp::int32 var_1560;
    wp::int32 var_1561;
    const wp::int32 var_1562 = 0;
    bool var_1563;
    wp::int32 var_1564;
    wp::int32 var_1565;
    const wp::int32 var_1566 = 7;
    wp::int32 var_1567;
    wp::int32 var_1568;
    const wp::int32 var_1569 = 0;
    bool var_1570;
    wp::int32 var_1571;
    wp::int32 var_1572;
    const wp::int32 var_1573 = 7;
    const wp::int32 var_1574 = 0;
    wp::int32 var_1575;
    const wp::int32 var_1576 = 0;
    wp::float32 var_1577;
    wp::float32 var_1578;
    wp::float32 var_1579;
    wp::float32 var_1580;
    wp::float32 var_1581;
    wp::float32 var_1582;
    wp::float32 var_1583;
    wp::float32 var_1584;
    wp::float32 var_1585;
    wp::float32 var_1586;
    wp::float32 var_1587;
    wp::float32 var_1588;
    wp::float32 var_1589;
    wp::float32 var_1590;
    bool var_1591;
    wp::int32 var_1592;
    const wp::int32 var_1593 = 0;
    wp::int32 var_1594;
    wp::int32 var_1595;
    const wp::int32 var_1596 = 1;
    wp::float32 var_1597;
    wp::float32 var_1598;
    wp::float32 var_1599;
    wp::float32 var_1600;
    wp::float32 var_1601;
    wp::float32 var_1602;
    wp::float32 var_1603;
    wp::float32 var_1604;
    wp::float32 var_1605;
    wp::float32 var_1606;
    wp::float32 var_1607;
    wp::float32 var_1608;
    wp::float32 var_1609;
    wp::float32 var_1610;
    bool var_1611;
    wp::int32 var_1612;
    const wp::int32 var_1613 = 0;
    wp::int32 var_1614;
    wp::int32 var_1615;
    const wp::int32 var_1616 = 2;
    wp::float32 var_1617;
    wp::float32 var_1618;
    wp::float32 var_1619;
    wp::float32 var_1620;
    wp::float32 var_1621;
    wp::float32 var_1622;
    wp::float32 var_1623;
    wp::float32 var_1624;
    wp::float32 var_1625;
    wp::float32 var_1626;
    wp::float32 var_1627;
    wp::float32 var_1628;
    wp::float32 var_1629;
    wp::float32 var_1630;
    bool var_1631;
    wp::int32 var_1632;
    const wp::int32 var_1633 = 0;
    wp::int32 var_1634;
    wp::int32 var_1635;
    const wp::int32 var_1636 = 3;
    wp::float32 var_1637;
    wp::float32 var_1638;
    wp::float32 var_1639;
    wp::float32 var_1640;
    wp::float32 var_1641;
    wp::float32 var_1642;
    wp::float32 var_1643;
    wp::float32 var_1644;
    wp::float32 var_1645;
    wp::float32 var_1646;
    wp::float32 var_1647;
    wp::float32 var_1648;
    wp::float32 var_1649;
    wp::float32 var_1650;
    bool var_1651;
    wp::int32 var_1652;
    const wp::int32 var_1653 = 0;
    wp::int32 var_1654;
    wp::int32 var_1655;
    const wp::int32 var_1656 = 4;
    wp::float32 var_1657;
    wp::float32 var_1658;
    wp::float32 var_1659;
    wp::float32 var_1660;
    wp::float32 var_1661;
    wp::float32 var_1662;
    wp::float32 var_1663;
    wp::float32 var_1664;
    wp::float32 var_1665;
    wp::float32 var_1666;
    wp::float32 var_1667;
    wp::float32 var_1668;
    wp::float32 var_1669;
    wp::float32 var_1670;
    bool var_1671;
    wp::int32 var_1672;
    const wp::int32 var_1673 = 0;
    wp::int32 var_1674;
    wp::int32 var_1675;
    const wp::int32 var_1676 = 5;
    wp::float32 var_1677;
    wp::float32 var_1678;
    wp::float32 var_1679;
    wp::float32 var_1680;
    wp::float32 var_1681;
    wp::float32 var_1682;
    wp::float32 var_1683;
    wp::float32 var_1684;
    wp::float32 var_1685;
    wp::float32 var_1686;
    wp::float32 var_1687;
    wp::float32 var_1688;
    wp::float32 var_1689;
    wp::float32 var_1690;
    bool var_1691;
    wp::int32 var_1692;
    const wp::int32 var_1693 = 0;
    wp::int32 var_1694;
    wp::int32 var_1695;
    const wp::int32 var_1696 = 6;
    wp::float32 var_1697;
    wp::float32 var_1698;
    wp::float32 var_1699;
    wp::float32 var_1700;
    wp::float32 var_1701;
    wp::float32 var_1702;
    wp::float32 var_1703;
    wp::float32 var_1704;
    wp::float32 var_1705;
    wp::float32 var_1706;
    wp::float32 var_1707;
    wp::float32 var_1708;
    wp::float32 var_1709;
    wp::float32 var_1710;
    bool var_1711;
    wp::int32 var_1712;
    const wp::int32 var_1713 = 0;
    wp::int32 var_1714;
    wp::int32 var_1715;
    const wp::int32 var_1716 = 7;
    wp::float32 var_1717;
    wp::float32 var_1718;
    wp::float32 var_1719;
    wp::float32 var_1720;
    wp::float32 var_1721;
    wp::float32 var_1722;
    wp::float32 var_1723;
    wp::float32 var_1724;
    wp::float32 var_1725;
    wp::float32 var_1726;
    wp::float32 var_1727;
    wp::float32 var_1728;
    wp::float32 var_1729;
    wp::float32 var_1730;
    bool var_1731;
    wp::int32 var_1732;
    const wp::int32 var_1733 = 0;
    wp::int32 var_1734;
    wp::int32 var_1735;
    wp::int32 var_1736;
    wp::int32 var_1737;
    const wp::int32 var_1738 = 0;
    wp::int32 var_1739;
    wp::int32 var_1740;
    const wp::int32 var_1741 = 0;
    bool var_1742;
    wp::int32 var_1743;
    wp::int32 var_1744;
    const wp::int32 var_1745 = 1;
    wp::int32 var_1746;
    wp::int32 var_1747;
    const wp::int32 var_1748 = 0;
    bool var_1749;
    wp::int32 var_1750;
    wp::int32 var_1751;
    const wp::int32 var_1752 = 2;
    wp::int32 var_1753;
    wp::int32 var_1754;
    const wp::int32 var_1755 = 0;
    bool var_1756;
    wp::int32 var_1757;
    wp::int32 var_1758;
    const wp::int32 var_1759 = 3;
    wp::int32 var_1760;
    wp::int32 var_1761;
    const wp::int32 var_1762 = 0;
    bool var_1763;
    wp::int32 var_1764;
    wp::int32 var_1765;
    const wp::int32 var_1766 = 4;
    wp::int32 var_1767;
    wp::int32 var_1768;
    const wp::int32 var_1769 = 0;
    bool var_1770;
    wp::int32 var_1771;
    wp::int32 var_1772;
    const wp::int32 var_1773 = 5;
    wp::int32 var_1774;
    wp::int32 var_1775;
    const wp::int32 var_1776 = 0;
    bool var_1777;
    wp::int32 var_1778;
    wp::int32 var_1779;
    const wp::int32 var_1780 = 6;
    wp::int32 var_1781;
    wp::int32 var_1782;
    const wp::int32 var_1783 = 0;
    bool var_1784;
    wp::int32 var_1785;
    wp::int32 var_1786;
    const wp::int32 var_1787 = 7;
    wp::int32 var_1788;
    wp::int32 var_1789;
    const wp::int32 var_1790 = 0;
    bool var_1791;
    wp::int32 var_1792;
    wp::int32 var_1793;
    //---------
    // forward
    // def join_lanes(xs, ys, zs, max_sqdist):                                                <L 1>
    // heads = numbers(0)                                                                     <L 3>
    var_1 = wp::vec_t<8, wp::int32>(var_0);
    // for j in range(LEAF):                                                                  <L 4>
    // heads[j] = 1 << j                                                                      <L 5>
    var_4 = wp::lshift(var_3, var_2);
    wp::assign_inplace(var_1, var_2, var_4);
    var_7 = wp::lshift(var_6, var_5);
    wp::assign_inplace(var_1, var_5, var_7);
    var_10 = wp::lshift(var_9, var_8);
    wp::assign_inplace(var_1, var_8, var_10);
    var_13 = wp::lshift(var_12, var_11);
    wp::assign_inplace(var_1, var_11, var_13);
    var_16 = wp::lshift(var_15, var_14);
    wp::assign_inplace(var_1, var_14, var_16);
    var_19 = wp::lshift(var_18, var_17);
    wp::assign_inplace(var_1, var_17, var_19);
    var_22 = wp::lshift(var_21, var_20);
    wp::assign_inplace(var_1, var_20, var_22);
    var_25 = wp::lshift(var_24, var_23);
    wp::assign_inplace(var_1, var_23, var_25);
    // for k in range(LEAF):                                                                  <L 6>
    // touched = int(0)                                                                       <L 7>
    var_28 = wp::int(var_27);
    // for j in range(LEAF):                                                                  <L 8>
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_30 = wp::extract(var_xs, var_26);
    var_31 = wp::extract(var_xs, var_29);
    var_32 = wp::sub(var_30, var_31);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_33 = wp::extract(var_ys, var_26);
    var_34 = wp::extract(var_ys, var_29);
    var_35 = wp::sub(var_33, var_34);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_36 = wp::extract(var_zs, var_26);
    var_37 = wp::extract(var_zs, var_29);
    var_38 = wp::sub(var_36, var_37);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_39 = wp::mul(var_32, var_32);
    var_40 = wp::mul(var_35, var_35);
    var_41 = wp::add(var_39, var_40);
    var_42 = wp::mul(var_38, var_38);
    var_43 = wp::add(var_41, var_42);
    var_44 = (var_43 <= var_max_sqdist);
    if (var_44) {
        var_45 = wp::extract(var_1, var_29);
    }
    if (!var_44) {
    }
    var_47 = wp::where(var_44, var_45, var_46);
    var_48 = wp::bit_or(var_28, var_47);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_50 = wp::extract(var_xs, var_26);
    var_51 = wp::extract(var_xs, var_49);
    var_52 = wp::sub(var_50, var_51);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_53 = wp::extract(var_ys, var_26);
    var_54 = wp::extract(var_ys, var_49);
    var_55 = wp::sub(var_53, var_54);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_56 = wp::extract(var_zs, var_26);
    var_57 = wp::extract(var_zs, var_49);
    var_58 = wp::sub(var_56, var_57);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_59 = wp::mul(var_52, var_52);
    var_60 = wp::mul(var_55, var_55);
    var_61 = wp::add(var_59, var_60);
    var_62 = wp::mul(var_58, var_58);
    var_63 = wp::add(var_61, var_62);
    var_64 = (var_63 <= var_max_sqdist);
    if (var_64) {
        var_65 = wp::extract(var_1, var_49);
    }
    if (!var_64) {
    }
    var_67 = wp::where(var_64, var_65, var_66);
    var_68 = wp::bit_or(var_48, var_67);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_70 = wp::extract(var_xs, var_26);
    var_71 = wp::extract(var_xs, var_69);
    var_72 = wp::sub(var_70, var_71);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_73 = wp::extract(var_ys, var_26);
    var_74 = wp::extract(var_ys, var_69);
    var_75 = wp::sub(var_73, var_74);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_76 = wp::extract(var_zs, var_26);
    var_77 = wp::extract(var_zs, var_69);
    var_78 = wp::sub(var_76, var_77);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_79 = wp::mul(var_72, var_72);
    var_80 = wp::mul(var_75, var_75);
    var_81 = wp::add(var_79, var_80);
    var_82 = wp::mul(var_78, var_78);
    var_83 = wp::add(var_81, var_82);
    var_84 = (var_83 <= var_max_sqdist);
    if (var_84) {
        var_85 = wp::extract(var_1, var_69);
    }
    if (!var_84) {
    }
    var_87 = wp::where(var_84, var_85, var_86);
    var_88 = wp::bit_or(var_68, var_87);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_90 = wp::extract(var_xs, var_26);
    var_91 = wp::extract(var_xs, var_89);
    var_92 = wp::sub(var_90, var_91);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_93 = wp::extract(var_ys, var_26);
    var_94 = wp::extract(var_ys, var_89);
    var_95 = wp::sub(var_93, var_94);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_96 = wp::extract(var_zs, var_26);
    var_97 = wp::extract(var_zs, var_89);
    var_98 = wp::sub(var_96, var_97);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_99 = wp::mul(var_92, var_92);
    var_100 = wp::mul(var_95, var_95);
    var_101 = wp::add(var_99, var_100);
    var_102 = wp::mul(var_98, var_98);
    var_103 = wp::add(var_101, var_102);
    var_104 = (var_103 <= var_max_sqdist);
    if (var_104) {
        var_105 = wp::extract(var_1, var_89);
    }
    if (!var_104) {
    }
    var_107 = wp::where(var_104, var_105, var_106);
    var_108 = wp::bit_or(var_88, var_107);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_110 = wp::extract(var_xs, var_26);
    var_111 = wp::extract(var_xs, var_109);
    var_112 = wp::sub(var_110, var_111);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_113 = wp::extract(var_ys, var_26);
    var_114 = wp::extract(var_ys, var_109);
    var_115 = wp::sub(var_113, var_114);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_116 = wp::extract(var_zs, var_26);
    var_117 = wp::extract(var_zs, var_109);
    var_118 = wp::sub(var_116, var_117);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_119 = wp::mul(var_112, var_112);
    var_120 = wp::mul(var_115, var_115);
    var_121 = wp::add(var_119, var_120);
    var_122 = wp::mul(var_118, var_118);
    var_123 = wp::add(var_121, var_122);
    var_124 = (var_123 <= var_max_sqdist);
    if (var_124) {
        var_125 = wp::extract(var_1, var_109);
    }
    if (!var_124) {
    }
    var_127 = wp::where(var_124, var_125, var_126);
    var_128 = wp::bit_or(var_108, var_127);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_130 = wp::extract(var_xs, var_26);
    var_131 = wp::extract(var_xs, var_129);
    var_132 = wp::sub(var_130, var_131);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_133 = wp::extract(var_ys, var_26);
    var_134 = wp::extract(var_ys, var_129);
    var_135 = wp::sub(var_133, var_134);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_136 = wp::extract(var_zs, var_26);
    var_137 = wp::extract(var_zs, var_129);
    var_138 = wp::sub(var_136, var_137);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_139 = wp::mul(var_132, var_132);
    var_140 = wp::mul(var_135, var_135);
    var_141 = wp::add(var_139, var_140);
    var_142 = wp::mul(var_138, var_138);
    var_143 = wp::add(var_141, var_142);
    var_144 = (var_143 <= var_max_sqdist);
    if (var_144) {
        var_145 = wp::extract(var_1, var_129);
    }
    if (!var_144) {
    }
    var_147 = wp::where(var_144, var_145, var_146);
    var_148 = wp::bit_or(var_128, var_147);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_150 = wp::extract(var_xs, var_26);
    var_151 = wp::extract(var_xs, var_149);
    var_152 = wp::sub(var_150, var_151);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_153 = wp::extract(var_ys, var_26);
    var_154 = wp::extract(var_ys, var_149);
    var_155 = wp::sub(var_153, var_154);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_156 = wp::extract(var_zs, var_26);
    var_157 = wp::extract(var_zs, var_149);
    var_158 = wp::sub(var_156, var_157);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_159 = wp::mul(var_152, var_152);
    var_160 = wp::mul(var_155, var_155);
    var_161 = wp::add(var_159, var_160);
    var_162 = wp::mul(var_158, var_158);
    var_163 = wp::add(var_161, var_162);
    var_164 = (var_163 <= var_max_sqdist);
    if (var_164) {
        var_165 = wp::extract(var_1, var_149);
    }
    if (!var_164) {
    }
    var_167 = wp::where(var_164, var_165, var_166);
    var_168 = wp::bit_or(var_148, var_167);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_170 = wp::extract(var_xs, var_26);
    var_171 = wp::extract(var_xs, var_169);
    var_172 = wp::sub(var_170, var_171);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_173 = wp::extract(var_ys, var_26);
    var_174 = wp::extract(var_ys, var_169);
    var_175 = wp::sub(var_173, var_174);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_176 = wp::extract(var_zs, var_26);
    var_177 = wp::extract(var_zs, var_169);
    var_178 = wp::sub(var_176, var_177);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_179 = wp::mul(var_172, var_172);
    var_180 = wp::mul(var_175, var_175);
    var_181 = wp::add(var_179, var_180);
    var_182 = wp::mul(var_178, var_178);
    var_183 = wp::add(var_181, var_182);
    var_184 = (var_183 <= var_max_sqdist);
    if (var_184) {
        var_185 = wp::extract(var_1, var_169);
    }
    if (!var_184) {
    }
    var_187 = wp::where(var_184, var_185, var_186);
    var_188 = wp::bit_or(var_168, var_187);
    // lowest = touched & -touched                                                            <L 13>
    var_189 = wp::neg(var_188);
    var_190 = wp::bit_and(var_188, var_189);
    // for j in range(LEAF):                                                                  <L 14>
    // heads[j] = lowest if heads[j] & touched != 0 else heads[j]                             <L 15>
    var_192 = wp::extract(var_1, var_191);
    var_193 = wp::bit_and(var_192, var_188);
    var_195 = (var_193 != var_194);
    if (var_195) {
    }
    if (!var_195) {
        var_196 = wp::extract(var_1, var_191);
    }
    var_197 = wp::where(var_195, var_190, var_196);
    wp::assign_inplace(var_1, var_191, var_197);
    var_199 = wp::extract(var_1, var_198);
    var_200 = wp::bit_and(var_199, var_188);
    var_202 = (var_200 != var_201);
    if (var_202) {
    }
    if (!var_202) {
        var_203 = wp::extract(var_1, var_198);
    }
    var_204 = wp::where(var_202, var_190, var_203);
    wp::assign_inplace(var_1, var_198, var_204);
    var_206 = wp::extract(var_1, var_205);
    var_207 = wp::bit_and(var_206, var_188);
    var_209 = (var_207 != var_208);
    if (var_209) {
    }
    if (!var_209) {
        var_210 = wp::extract(var_1, var_205);
    }
    var_211 = wp::where(var_209, var_190, var_210);
    wp::assign_inplace(var_1, var_205, var_211);
    var_213 = wp::extract(var_1, var_212);
    var_214 = wp::bit_and(var_213, var_188);
    var_216 = (var_214 != var_215);
    if (var_216) {
    }
    if (!var_216) {
        var_217 = wp::extract(var_1, var_212);
    }
    var_218 = wp::where(var_216, var_190, var_217);
    wp::assign_inplace(var_1, var_212, var_218);
    var_220 = wp::extract(var_1, var_219);
    var_221 = wp::bit_and(var_220, var_188);
    var_223 = (var_221 != var_222);
    if (var_223) {
    }
    if (!var_223) {
        var_224 = wp::extract(var_1, var_219);
    }
    var_225 = wp::where(var_223, var_190, var_224);
    wp::assign_inplace(var_1, var_219, var_225);
    var_227 = wp::extract(var_1, var_226);
    var_228 = wp::bit_and(var_227, var_188);
    var_230 = (var_228 != var_229);
    if (var_230) {
    }
    if (!var_230) {
        var_231 = wp::extract(var_1, var_226);
    }
    var_232 = wp::where(var_230, var_190, var_231);
    wp::assign_inplace(var_1, var_226, var_232);
    var_234 = wp::extract(var_1, var_233);
    var_235 = wp::bit_and(var_234, var_188);
    var_237 = (var_235 != var_236);
    if (var_237) {
    }
    if (!var_237) {
        var_238 = wp::extract(var_1, var_233);
    }
    var_239 = wp::where(var_237, var_190, var_238);
    wp::assign_inplace(var_1, var_233, var_239);
    var_241 = wp::extract(var_1, var_240);
    var_242 = wp::bit_and(var_241, var_188);
    var_244 = (var_242 != var_243);
    if (var_244) {
    }
    if (!var_244) {
        var_245 = wp::extract(var_1, var_240);
    }
    var_246 = wp::where(var_244, var_190, var_245);
    wp::assign_inplace(var_1, var_240, var_246);
    // touched = int(0)                                                                       <L 7>
    var_249 = wp::int(var_248);
    // for j in range(LEAF):                                                                  <L 8>
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_251 = wp::extract(var_xs, var_247);
    var_252 = wp::extract(var_xs, var_250);
    var_253 = wp::sub(var_251, var_252);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_254 = wp::extract(var_ys, var_247);
    var_255 = wp::extract(var_ys, var_250);
    var_256 = wp::sub(var_254, var_255);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_257 = wp::extract(var_zs, var_247);
    var_258 = wp::extract(var_zs, var_250);
    var_259 = wp::sub(var_257, var_258);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_260 = wp::mul(var_253, var_253);
    var_261 = wp::mul(var_256, var_256);
    var_262 = wp::add(var_260, var_261);
    var_263 = wp::mul(var_259, var_259);
    var_264 = wp::add(var_262, var_263);
    var_265 = (var_264 <= var_max_sqdist);
    if (var_265) {
        var_266 = wp::extract(var_1, var_250);
    }
    if (!var_265) {
    }
    var_268 = wp::where(var_265, var_266, var_267);
    var_269 = wp::bit_or(var_249, var_268);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_271 = wp::extract(var_xs, var_247);
    var_272 = wp::extract(var_xs, var_270);
    var_273 = wp::sub(var_271, var_272);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_274 = wp::extract(var_ys, var_247);
    var_275 = wp::extract(var_ys, var_270);
    var_276 = wp::sub(var_274, var_275);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_277 = wp::extract(var_zs, var_247);
    var_278 = wp::extract(var_zs, var_270);
    var_279 = wp::sub(var_277, var_278);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_280 = wp::mul(var_273, var_273);
    var_281 = wp::mul(var_276, var_276);
    var_282 = wp::add(var_280, var_281);
    var_283 = wp::mul(var_279, var_279);
    var_284 = wp::add(var_282, var_283);
    var_285 = (var_284 <= var_max_sqdist);
    if (var_285) {
        var_286 = wp::extract(var_1, var_270);
    }
    if (!var_285) {
    }
    var_288 = wp::where(var_285, var_286, var_287);
    var_289 = wp::bit_or(var_269, var_288);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_291 = wp::extract(var_xs, var_247);
    var_292 = wp::extract(var_xs, var_290);
    var_293 = wp::sub(var_291, var_292);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_294 = wp::extract(var_ys, var_247);
    var_295 = wp::extract(var_ys, var_290);
    var_296 = wp::sub(var_294, var_295);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_297 = wp::extract(var_zs, var_247);
    var_298 = wp::extract(var_zs, var_290);
    var_299 = wp::sub(var_297, var_298);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_300 = wp::mul(var_293, var_293);
    var_301 = wp::mul(var_296, var_296);
    var_302 = wp::add(var_300, var_301);
    var_303 = wp::mul(var_299, var_299);
    var_304 = wp::add(var_302, var_303);
    var_305 = (var_304 <= var_max_sqdist);
    if (var_305) {
        var_306 = wp::extract(var_1, var_290);
    }
    if (!var_305) {
    }
    var_308 = wp::where(var_305, var_306, var_307);
    var_309 = wp::bit_or(var_289, var_308);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_311 = wp::extract(var_xs, var_247);
    var_312 = wp::extract(var_xs, var_310);
    var_313 = wp::sub(var_311, var_312);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_314 = wp::extract(var_ys, var_247);
    var_315 = wp::extract(var_ys, var_310);
    var_316 = wp::sub(var_314, var_315);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_317 = wp::extract(var_zs, var_247);
    var_318 = wp::extract(var_zs, var_310);
    var_319 = wp::sub(var_317, var_318);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_320 = wp::mul(var_313, var_313);
    var_321 = wp::mul(var_316, var_316);
    var_322 = wp::add(var_320, var_321);
    var_323 = wp::mul(var_319, var_319);
    var_324 = wp::add(var_322, var_323);
    var_325 = (var_324 <= var_max_sqdist);
    if (var_325) {
        var_326 = wp::extract(var_1, var_310);
    }
    if (!var_325) {
    }
    var_328 = wp::where(var_325, var_326, var_327);
    var_329 = wp::bit_or(var_309, var_328);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_331 = wp::extract(var_xs, var_247);
    var_332 = wp::extract(var_xs, var_330);
    var_333 = wp::sub(var_331, var_332);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_334 = wp::extract(var_ys, var_247);
    var_335 = wp::extract(var_ys, var_330);
    var_336 = wp::sub(var_334, var_335);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_337 = wp::extract(var_zs, var_247);
    var_338 = wp::extract(var_zs, var_330);
    var_339 = wp::sub(var_337, var_338);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_340 = wp::mul(var_333, var_333);
    var_341 = wp::mul(var_336, var_336);
    var_342 = wp::add(var_340, var_341);
    var_343 = wp::mul(var_339, var_339);
    var_344 = wp::add(var_342, var_343);
    var_345 = (var_344 <= var_max_sqdist);
    if (var_345) {
        var_346 = wp::extract(var_1, var_330);
    }
    if (!var_345) {
    }
    var_348 = wp::where(var_345, var_346, var_347);
    var_349 = wp::bit_or(var_329, var_348);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_351 = wp::extract(var_xs, var_247);
    var_352 = wp::extract(var_xs, var_350);
    var_353 = wp::sub(var_351, var_352);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_354 = wp::extract(var_ys, var_247);
    var_355 = wp::extract(var_ys, var_350);
    var_356 = wp::sub(var_354, var_355);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_357 = wp::extract(var_zs, var_247);
    var_358 = wp::extract(var_zs, var_350);
    var_359 = wp::sub(var_357, var_358);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_360 = wp::mul(var_353, var_353);
    var_361 = wp::mul(var_356, var_356);
    var_362 = wp::add(var_360, var_361);
    var_363 = wp::mul(var_359, var_359);
    var_364 = wp::add(var_362, var_363);
    var_365 = (var_364 <= var_max_sqdist);
    if (var_365) {
        var_366 = wp::extract(var_1, var_350);
    }
    if (!var_365) {
    }
    var_368 = wp::where(var_365, var_366, var_367);
    var_369 = wp::bit_or(var_349, var_368);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_371 = wp::extract(var_xs, var_247);
    var_372 = wp::extract(var_xs, var_370);
    var_373 = wp::sub(var_371, var_372);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_374 = wp::extract(var_ys, var_247);
    var_375 = wp::extract(var_ys, var_370);
    var_376 = wp::sub(var_374, var_375);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_377 = wp::extract(var_zs, var_247);
    var_378 = wp::extract(var_zs, var_370);
    var_379 = wp::sub(var_377, var_378);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_380 = wp::mul(var_373, var_373);
    var_381 = wp::mul(var_376, var_376);
    var_382 = wp::add(var_380, var_381);
    var_383 = wp::mul(var_379, var_379);
    var_384 = wp::add(var_382, var_383);
    var_385 = (var_384 <= var_max_sqdist);
    if (var_385) {
        var_386 = wp::extract(var_1, var_370);
    }
    if (!var_385) {
    }
    var_388 = wp::where(var_385, var_386, var_387);
    var_389 = wp::bit_or(var_369, var_388);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_391 = wp::extract(var_xs, var_247);
    var_392 = wp::extract(var_xs, var_390);
    var_393 = wp::sub(var_391, var_392);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_394 = wp::extract(var_ys, var_247);
    var_395 = wp::extract(var_ys, var_390);
    var_396 = wp::sub(var_394, var_395);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_397 = wp::extract(var_zs, var_247);
    var_398 = wp::extract(var_zs, var_390);
    var_399 = wp::sub(var_397, var_398);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_400 = wp::mul(var_393, var_393);
    var_401 = wp::mul(var_396, var_396);
    var_402 = wp::add(var_400, var_401);
    var_403 = wp::mul(var_399, var_399);
    var_404 = wp::add(var_402, var_403);
    var_405 = (var_404 <= var_max_sqdist);
    if (var_405) {
        var_406 = wp::extract(var_1, var_390);
    }
    if (!var_405) {
    }
    var_408 = wp::where(var_405, var_406, var_407);
    var_409 = wp::bit_or(var_389, var_408);
    // lowest = touched & -touched                                                            <L 13>
    var_410 = wp::neg(var_409);
    var_411 = wp::bit_and(var_409, var_410);
    // for j in range(LEAF):                                                                  <L 14>
    // heads[j] = lowest if heads[j] & touched != 0 else heads[j]                             <L 15>
    var_413 = wp::extract(var_1, var_412);
    var_414 = wp::bit_and(var_413, var_409);
    var_416 = (var_414 != var_415);
    if (var_416) {
    }
    if (!var_416) {
        var_417 = wp::extract(var_1, var_412);
    }
    var_418 = wp::where(var_416, var_411, var_417);
    wp::assign_inplace(var_1, var_412, var_418);
    var_420 = wp::extract(var_1, var_419);
    var_421 = wp::bit_and(var_420, var_409);
    var_423 = (var_421 != var_422);
    if (var_423) {
    }
    if (!var_423) {
        var_424 = wp::extract(var_1, var_419);
    }
    var_425 = wp::where(var_423, var_411, var_424);
    wp::assign_inplace(var_1, var_419, var_425);
    var_427 = wp::extract(var_1, var_426);
    var_428 = wp::bit_and(var_427, var_409);
    var_430 = (var_428 != var_429);
    if (var_430) {
    }
    if (!var_430) {
        var_431 = wp::extract(var_1, var_426);
    }
    var_432 = wp::where(var_430, var_411, var_431);
    wp::assign_inplace(var_1, var_426, var_432);
    var_434 = wp::extract(var_1, var_433);
    var_435 = wp::bit_and(var_434, var_409);
    var_437 = (var_435 != var_436);
    if (var_437) {
    }
    if (!var_437) {
        var_438 = wp::extract(var_1, var_433);
    }
    var_439 = wp::where(var_437, var_411, var_438);
    wp::assign_inplace(var_1, var_433, var_439);
    var_441 = wp::extract(var_1, var_440);
    var_442 = wp::bit_and(var_441, var_409);
    var_444 = (var_442 != var_443);
    if (var_444) {
    }
    if (!var_444) {
        var_445 = wp::extract(var_1, var_440);
    }
    var_446 = wp::where(var_444, var_411, var_445);
    wp::assign_inplace(var_1, var_440, var_446);
    var_448 = wp::extract(var_1, var_447);
    var_449 = wp::bit_and(var_448, var_409);
    var_451 = (var_449 != var_450);
    if (var_451) {
    }
    if (!var_451) {
        var_452 = wp::extract(var_1, var_447);
    }
    var_453 = wp::where(var_451, var_411, var_452);
    wp::assign_inplace(var_1, var_447, var_453);
    var_455 = wp::extract(var_1, var_454);
    var_456 = wp::bit_and(var_455, var_409);
    var_458 = (var_456 != var_457);
    if (var_458) {
    }
    if (!var_458) {
        var_459 = wp::extract(var_1, var_454);
    }
    var_460 = wp::where(var_458, var_411, var_459);
    wp::assign_inplace(var_1, var_454, var_460);
    var_462 = wp::extract(var_1, var_461);
    var_463 = wp::bit_and(var_462, var_409);
    var_465 = (var_463 != var_464);
    if (var_465) {
    }
    if (!var_465) {
        var_466 = wp::extract(var_1, var_461);
    }
    var_467 = wp::where(var_465, var_411, var_466);
    wp::assign_inplace(var_1, var_461, var_467);
    // touched = int(0)                                                                       <L 7>
    var_470 = wp::int(var_469);
    // for j in range(LEAF):                                                                  <L 8>
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_472 = wp::extract(var_xs, var_468);
    var_473 = wp::extract(var_xs, var_471);
    var_474 = wp::sub(var_472, var_473);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_475 = wp::extract(var_ys, var_468);
    var_476 = wp::extract(var_ys, var_471);
    var_477 = wp::sub(var_475, var_476);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_478 = wp::extract(var_zs, var_468);
    var_479 = wp::extract(var_zs, var_471);
    var_480 = wp::sub(var_478, var_479);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_481 = wp::mul(var_474, var_474);
    var_482 = wp::mul(var_477, var_477);
    var_483 = wp::add(var_481, var_482);
    var_484 = wp::mul(var_480, var_480);
    var_485 = wp::add(var_483, var_484);
    var_486 = (var_485 <= var_max_sqdist);
    if (var_486) {
        var_487 = wp::extract(var_1, var_471);
    }
    if (!var_486) {
    }
    var_489 = wp::where(var_486, var_487, var_488);
    var_490 = wp::bit_or(var_470, var_489);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_492 = wp::extract(var_xs, var_468);
    var_493 = wp::extract(var_xs, var_491);
    var_494 = wp::sub(var_492, var_493);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_495 = wp::extract(var_ys, var_468);
    var_496 = wp::extract(var_ys, var_491);
    var_497 = wp::sub(var_495, var_496);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_498 = wp::extract(var_zs, var_468);
    var_499 = wp::extract(var_zs, var_491);
    var_500 = wp::sub(var_498, var_499);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_501 = wp::mul(var_494, var_494);
    var_502 = wp::mul(var_497, var_497);
    var_503 = wp::add(var_501, var_502);
    var_504 = wp::mul(var_500, var_500);
    var_505 = wp::add(var_503, var_504);
    var_506 = (var_505 <= var_max_sqdist);
    if (var_506) {
        var_507 = wp::extract(var_1, var_491);
    }
    if (!var_506) {
    }
    var_509 = wp::where(var_506, var_507, var_508);
    var_510 = wp::bit_or(var_490, var_509);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_512 = wp::extract(var_xs, var_468);
    var_513 = wp::extract(var_xs, var_511);
    var_514 = wp::sub(var_512, var_513);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_515 = wp::extract(var_ys, var_468);
    var_516 = wp::extract(var_ys, var_511);
    var_517 = wp::sub(var_515, var_516);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_518 = wp::extract(var_zs, var_468);
    var_519 = wp::extract(var_zs, var_511);
    var_520 = wp::sub(var_518, var_519);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_521 = wp::mul(var_514, var_514);
    var_522 = wp::mul(var_517, var_517);
    var_523 = wp::add(var_521, var_522);
    var_524 = wp::mul(var_520, var_520);
    var_525 = wp::add(var_523, var_524);
    var_526 = (var_525 <= var_max_sqdist);
    if (var_526) {
        var_527 = wp::extract(var_1, var_511);
    }
    if (!var_526) {
    }
    var_529 = wp::where(var_526, var_527, var_528);
    var_530 = wp::bit_or(var_510, var_529);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_532 = wp::extract(var_xs, var_468);
    var_533 = wp::extract(var_xs, var_531);
    var_534 = wp::sub(var_532, var_533);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_535 = wp::extract(var_ys, var_468);
    var_536 = wp::extract(var_ys, var_531);
    var_537 = wp::sub(var_535, var_536);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_538 = wp::extract(var_zs, var_468);
    var_539 = wp::extract(var_zs, var_531);
    var_540 = wp::sub(var_538, var_539);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_541 = wp::mul(var_534, var_534);
    var_542 = wp::mul(var_537, var_537);
    var_543 = wp::add(var_541, var_542);
    var_544 = wp::mul(var_540, var_540);
    var_545 = wp::add(var_543, var_544);
    var_546 = (var_545 <= var_max_sqdist);
    if (var_546) {
        var_547 = wp::extract(var_1, var_531);
    }
    if (!var_546) {
    }
    var_549 = wp::where(var_546, var_547, var_548);
    var_550 = wp::bit_or(var_530, var_549);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_552 = wp::extract(var_xs, var_468);
    var_553 = wp::extract(var_xs, var_551);
    var_554 = wp::sub(var_552, var_553);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_555 = wp::extract(var_ys, var_468);
    var_556 = wp::extract(var_ys, var_551);
    var_557 = wp::sub(var_555, var_556);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_558 = wp::extract(var_zs, var_468);
    var_559 = wp::extract(var_zs, var_551);
    var_560 = wp::sub(var_558, var_559);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_561 = wp::mul(var_554, var_554);
    var_562 = wp::mul(var_557, var_557);
    var_563 = wp::add(var_561, var_562);
    var_564 = wp::mul(var_560, var_560);
    var_565 = wp::add(var_563, var_564);
    var_566 = (var_565 <= var_max_sqdist);
    if (var_566) {
        var_567 = wp::extract(var_1, var_551);
    }
    if (!var_566) {
    }
    var_569 = wp::where(var_566, var_567, var_568);
    var_570 = wp::bit_or(var_550, var_569);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_572 = wp::extract(var_xs, var_468);
    var_573 = wp::extract(var_xs, var_571);
    var_574 = wp::sub(var_572, var_573);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_575 = wp::extract(var_ys, var_468);
    var_576 = wp::extract(var_ys, var_571);
    var_577 = wp::sub(var_575, var_576);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_578 = wp::extract(var_zs, var_468);
    var_579 = wp::extract(var_zs, var_571);
    var_580 = wp::sub(var_578, var_579);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_581 = wp::mul(var_574, var_574);
    var_582 = wp::mul(var_577, var_577);
    var_583 = wp::add(var_581, var_582);
    var_584 = wp::mul(var_580, var_580);
    var_585 = wp::add(var_583, var_584);
    var_586 = (var_585 <= var_max_sqdist);
    if (var_586) {
        var_587 = wp::extract(var_1, var_571);
    }
    if (!var_586) {
    }
    var_589 = wp::where(var_586, var_587, var_588);
    var_590 = wp::bit_or(var_570, var_589);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_592 = wp::extract(var_xs, var_468);
    var_593 = wp::extract(var_xs, var_591);
    var_594 = wp::sub(var_592, var_593);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_595 = wp::extract(var_ys, var_468);
    var_596 = wp::extract(var_ys, var_591);
    var_597 = wp::sub(var_595, var_596);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_598 = wp::extract(var_zs, var_468);
    var_599 = wp::extract(var_zs, var_591);
    var_600 = wp::sub(var_598, var_599);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_601 = wp::mul(var_594, var_594);
    var_602 = wp::mul(var_597, var_597);
    var_603 = wp::add(var_601, var_602);
    var_604 = wp::mul(var_600, var_600);
    var_605 = wp::add(var_603, var_604);
    var_606 = (var_605 <= var_max_sqdist);
    if (var_606) {
        var_607 = wp::extract(var_1, var_591);
    }
    if (!var_606) {
    }
    var_609 = wp::where(var_606, var_607, var_608);
    var_610 = wp::bit_or(var_590, var_609);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_612 = wp::extract(var_xs, var_468);
    var_613 = wp::extract(var_xs, var_611);
    var_614 = wp::sub(var_612, var_613);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_615 = wp::extract(var_ys, var_468);
    var_616 = wp::extract(var_ys, var_611);
    var_617 = wp::sub(var_615, var_616);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_618 = wp::extract(var_zs, var_468);
    var_619 = wp::extract(var_zs, var_611);
    var_620 = wp::sub(var_618, var_619);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_621 = wp::mul(var_614, var_614);
    var_622 = wp::mul(var_617, var_617);
    var_623 = wp::add(var_621, var_622);
    var_624 = wp::mul(var_620, var_620);
    var_625 = wp::add(var_623, var_624);
    var_626 = (var_625 <= var_max_sqdist);
    if (var_626) {
        var_627 = wp::extract(var_1, var_611);
    }
    if (!var_626) {
    }
    var_629 = wp::where(var_626, var_627, var_628);
    var_630 = wp::bit_or(var_610, var_629);
    // lowest = touched & -touched                                                            <L 13>
    var_631 = wp::neg(var_630);
    var_632 = wp::bit_and(var_630, var_631);
    // for j in range(LEAF):                                                                  <L 14>
    // heads[j] = lowest if heads[j] & touched != 0 else heads[j]                             <L 15>
    var_634 = wp::extract(var_1, var_633);
    var_635 = wp::bit_and(var_634, var_630);
    var_637 = (var_635 != var_636);
    if (var_637) {
    }
    if (!var_637) {
        var_638 = wp::extract(var_1, var_633);
    }
    var_639 = wp::where(var_637, var_632, var_638);
    wp::assign_inplace(var_1, var_633, var_639);
    var_641 = wp::extract(var_1, var_640);
    var_642 = wp::bit_and(var_641, var_630);
    var_644 = (var_642 != var_643);
    if (var_644) {
    }
    if (!var_644) {
        var_645 = wp::extract(var_1, var_640);
    }
    var_646 = wp::where(var_644, var_632, var_645);
    wp::assign_inplace(var_1, var_640, var_646);
    var_648 = wp::extract(var_1, var_647);
    var_649 = wp::bit_and(var_648, var_630);
    var_651 = (var_649 != var_650);
    if (var_651) {
    }
    if (!var_651) {
        var_652 = wp::extract(var_1, var_647);
    }
    var_653 = wp::where(var_651, var_632, var_652);
    wp::assign_inplace(var_1, var_647, var_653);
    var_655 = wp::extract(var_1, var_654);
    var_656 = wp::bit_and(var_655, var_630);
    var_658 = (var_656 != var_657);
    if (var_658) {
    }
    if (!var_658) {
        var_659 = wp::extract(var_1, var_654);
    }
    var_660 = wp::where(var_658, var_632, var_659);
    wp::assign_inplace(var_1, var_654, var_660);
    var_662 = wp::extract(var_1, var_661);
    var_663 = wp::bit_and(var_662, var_630);
    var_665 = (var_663 != var_664);
    if (var_665) {
    }
    if (!var_665) {
        var_666 = wp::extract(var_1, var_661);
    }
    var_667 = wp::where(var_665, var_632, var_666);
    wp::assign_inplace(var_1, var_661, var_667);
    var_669 = wp::extract(var_1, var_668);
    var_670 = wp::bit_and(var_669, var_630);
    var_672 = (var_670 != var_671);
    if (var_672) {
    }
    if (!var_672) {
        var_673 = wp::extract(var_1, var_668);
    }
    var_674 = wp::where(var_672, var_632, var_673);
    wp::assign_inplace(var_1, var_668, var_674);
    var_676 = wp::extract(var_1, var_675);
    var_677 = wp::bit_and(var_676, var_630);
    var_679 = (var_677 != var_678);
    if (var_679) {
    }
    if (!var_679) {
        var_680 = wp::extract(var_1, var_675);
    }
    var_681 = wp::where(var_679, var_632, var_680);
    wp::assign_inplace(var_1, var_675, var_681);
    var_683 = wp::extract(var_1, var_682);
    var_684 = wp::bit_and(var_683, var_630);
    var_686 = (var_684 != var_685);
    if (var_686) {
    }
    if (!var_686) {
        var_687 = wp::extract(var_1, var_682);
    }
    var_688 = wp::where(var_686, var_632, var_687);
    wp::assign_inplace(var_1, var_682, var_688);
    // touched = int(0)                                                                       <L 7>
    var_691 = wp::int(var_690);
    // for j in range(LEAF):                                                                  <L 8>
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_693 = wp::extract(var_xs, var_689);
    var_694 = wp::extract(var_xs, var_692);
    var_695 = wp::sub(var_693, var_694);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_696 = wp::extract(var_ys, var_689);
    var_697 = wp::extract(var_ys, var_692);
    var_698 = wp::sub(var_696, var_697);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_699 = wp::extract(var_zs, var_689);
    var_700 = wp::extract(var_zs, var_692);
    var_701 = wp::sub(var_699, var_700);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_702 = wp::mul(var_695, var_695);
    var_703 = wp::mul(var_698, var_698);
    var_704 = wp::add(var_702, var_703);
    var_705 = wp::mul(var_701, var_701);
    var_706 = wp::add(var_704, var_705);
    var_707 = (var_706 <= var_max_sqdist);
    if (var_707) {
        var_708 = wp::extract(var_1, var_692);
    }
    if (!var_707) {
    }
    var_710 = wp::where(var_707, var_708, var_709);
    var_711 = wp::bit_or(var_691, var_710);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_713 = wp::extract(var_xs, var_689);
    var_714 = wp::extract(var_xs, var_712);
    var_715 = wp::sub(var_713, var_714);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_716 = wp::extract(var_ys, var_689);
    var_717 = wp::extract(var_ys, var_712);
    var_718 = wp::sub(var_716, var_717);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_719 = wp::extract(var_zs, var_689);
    var_720 = wp::extract(var_zs, var_712);
    var_721 = wp::sub(var_719, var_720);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_722 = wp::mul(var_715, var_715);
    var_723 = wp::mul(var_718, var_718);
    var_724 = wp::add(var_722, var_723);
    var_725 = wp::mul(var_721, var_721);
    var_726 = wp::add(var_724, var_725);
    var_727 = (var_726 <= var_max_sqdist);
    if (var_727) {
        var_728 = wp::extract(var_1, var_712);
    }
    if (!var_727) {
    }
    var_730 = wp::where(var_727, var_728, var_729);
    var_731 = wp::bit_or(var_711, var_730);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_733 = wp::extract(var_xs, var_689);
    var_734 = wp::extract(var_xs, var_732);
    var_735 = wp::sub(var_733, var_734);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_736 = wp::extract(var_ys, var_689);
    var_737 = wp::extract(var_ys, var_732);
    var_738 = wp::sub(var_736, var_737);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_739 = wp::extract(var_zs, var_689);
    var_740 = wp::extract(var_zs, var_732);
    var_741 = wp::sub(var_739, var_740);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_742 = wp::mul(var_735, var_735);
    var_743 = wp::mul(var_738, var_738);
    var_744 = wp::add(var_742, var_743);
    var_745 = wp::mul(var_741, var_741);
    var_746 = wp::add(var_744, var_745);
    var_747 = (var_746 <= var_max_sqdist);
    if (var_747) {
        var_748 = wp::extract(var_1, var_732);
    }
    if (!var_747) {
    }
    var_750 = wp::where(var_747, var_748, var_749);
    var_751 = wp::bit_or(var_731, var_750);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_753 = wp::extract(var_xs, var_689);
    var_754 = wp::extract(var_xs, var_752);
    var_755 = wp::sub(var_753, var_754);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_756 = wp::extract(var_ys, var_689);
    var_757 = wp::extract(var_ys, var_752);
    var_758 = wp::sub(var_756, var_757);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_759 = wp::extract(var_zs, var_689);
    var_760 = wp::extract(var_zs, var_752);
    var_761 = wp::sub(var_759, var_760);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_762 = wp::mul(var_755, var_755);
    var_763 = wp::mul(var_758, var_758);
    var_764 = wp::add(var_762, var_763);
    var_765 = wp::mul(var_761, var_761);
    var_766 = wp::add(var_764, var_765);
    var_767 = (var_766 <= var_max_sqdist);
    if (var_767) {
        var_768 = wp::extract(var_1, var_752);
    }
    if (!var_767) {
    }
    var_770 = wp::where(var_767, var_768, var_769);
    var_771 = wp::bit_or(var_751, var_770);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_773 = wp::extract(var_xs, var_689);
    var_774 = wp::extract(var_xs, var_772);
    var_775 = wp::sub(var_773, var_774);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_776 = wp::extract(var_ys, var_689);
    var_777 = wp::extract(var_ys, var_772);
    var_778 = wp::sub(var_776, var_777);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_779 = wp::extract(var_zs, var_689);
    var_780 = wp::extract(var_zs, var_772);
    var_781 = wp::sub(var_779, var_780);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_782 = wp::mul(var_775, var_775);
    var_783 = wp::mul(var_778, var_778);
    var_784 = wp::add(var_782, var_783);
    var_785 = wp::mul(var_781, var_781);
    var_786 = wp::add(var_784, var_785);
    var_787 = (var_786 <= var_max_sqdist);
    if (var_787) {
        var_788 = wp::extract(var_1, var_772);
    }
    if (!var_787) {
    }
    var_790 = wp::where(var_787, var_788, var_789);
    var_791 = wp::bit_or(var_771, var_790);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_793 = wp::extract(var_xs, var_689);
    var_794 = wp::extract(var_xs, var_792);
    var_795 = wp::sub(var_793, var_794);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_796 = wp::extract(var_ys, var_689);
    var_797 = wp::extract(var_ys, var_792);
    var_798 = wp::sub(var_796, var_797);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_799 = wp::extract(var_zs, var_689);
    var_800 = wp::extract(var_zs, var_792);
    var_801 = wp::sub(var_799, var_800);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_802 = wp::mul(var_795, var_795);
    var_803 = wp::mul(var_798, var_798);
    var_804 = wp::add(var_802, var_803);
    var_805 = wp::mul(var_801, var_801);
    var_806 = wp::add(var_804, var_805);
    var_807 = (var_806 <= var_max_sqdist);
    if (var_807) {
        var_808 = wp::extract(var_1, var_792);
    }
    if (!var_807) {
    }
    var_810 = wp::where(var_807, var_808, var_809);
    var_811 = wp::bit_or(var_791, var_810);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_813 = wp::extract(var_xs, var_689);
    var_814 = wp::extract(var_xs, var_812);
    var_815 = wp::sub(var_813, var_814);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_816 = wp::extract(var_ys, var_689);
    var_817 = wp::extract(var_ys, var_812);
    var_818 = wp::sub(var_816, var_817);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_819 = wp::extract(var_zs, var_689);
    var_820 = wp::extract(var_zs, var_812);
    var_821 = wp::sub(var_819, var_820);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_822 = wp::mul(var_815, var_815);
    var_823 = wp::mul(var_818, var_818);
    var_824 = wp::add(var_822, var_823);
    var_825 = wp::mul(var_821, var_821);
    var_826 = wp::add(var_824, var_825);
    var_827 = (var_826 <= var_max_sqdist);
    if (var_827) {
        var_828 = wp::extract(var_1, var_812);
    }
    if (!var_827) {
    }
    var_830 = wp::where(var_827, var_828, var_829);
    var_831 = wp::bit_or(var_811, var_830);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_833 = wp::extract(var_xs, var_689);
    var_834 = wp::extract(var_xs, var_832);
    var_835 = wp::sub(var_833, var_834);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_836 = wp::extract(var_ys, var_689);
    var_837 = wp::extract(var_ys, var_832);
    var_838 = wp::sub(var_836, var_837);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_839 = wp::extract(var_zs, var_689);
    var_840 = wp::extract(var_zs, var_832);
    var_841 = wp::sub(var_839, var_840);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_842 = wp::mul(var_835, var_835);
    var_843 = wp::mul(var_838, var_838);
    var_844 = wp::add(var_842, var_843);
    var_845 = wp::mul(var_841, var_841);
    var_846 = wp::add(var_844, var_845);
    var_847 = (var_846 <= var_max_sqdist);
    if (var_847) {
        var_848 = wp::extract(var_1, var_832);
    }
    if (!var_847) {
    }
    var_850 = wp::where(var_847, var_848, var_849);
    var_851 = wp::bit_or(var_831, var_850);
    // lowest = touched & -touched                                                            <L 13>
    var_852 = wp::neg(var_851);
    var_853 = wp::bit_and(var_851, var_852);
    // for j in range(LEAF):                                                                  <L 14>
    // heads[j] = lowest if heads[j] & touched != 0 else heads[j]                             <L 15>
    var_855 = wp::extract(var_1, var_854);
    var_856 = wp::bit_and(var_855, var_851);
    var_858 = (var_856 != var_857);
    if (var_858) {
    }
    if (!var_858) {
        var_859 = wp::extract(var_1, var_854);
    }
    var_860 = wp::where(var_858, var_853, var_859);
    wp::assign_inplace(var_1, var_854, var_860);
    var_862 = wp::extract(var_1, var_861);
    var_863 = wp::bit_and(var_862, var_851);
    var_865 = (var_863 != var_864);
    if (var_865) {
    }
    if (!var_865) {
        var_866 = wp::extract(var_1, var_861);
    }
    var_867 = wp::where(var_865, var_853, var_866);
    wp::assign_inplace(var_1, var_861, var_867);
    var_869 = wp::extract(var_1, var_868);
    var_870 = wp::bit_and(var_869, var_851);
    var_872 = (var_870 != var_871);
    if (var_872) {
    }
    if (!var_872) {
        var_873 = wp::extract(var_1, var_868);
    }
    var_874 = wp::where(var_872, var_853, var_873);
    wp::assign_inplace(var_1, var_868, var_874);
    var_876 = wp::extract(var_1, var_875);
    var_877 = wp::bit_and(var_876, var_851);
    var_879 = (var_877 != var_878);
    if (var_879) {
    }
    if (!var_879) {
        var_880 = wp::extract(var_1, var_875);
    }
    var_881 = wp::where(var_879, var_853, var_880);
    wp::assign_inplace(var_1, var_875, var_881);
    var_883 = wp::extract(var_1, var_882);
    var_884 = wp::bit_and(var_883, var_851);
    var_886 = (var_884 != var_885);
    if (var_886) {
    }
    if (!var_886) {
        var_887 = wp::extract(var_1, var_882);
    }
    var_888 = wp::where(var_886, var_853, var_887);
    wp::assign_inplace(var_1, var_882, var_888);
    var_890 = wp::extract(var_1, var_889);
    var_891 = wp::bit_and(var_890, var_851);
    var_893 = (var_891 != var_892);
    if (var_893) {
    }
    if (!var_893) {
        var_894 = wp::extract(var_1, var_889);
    }
    var_895 = wp::where(var_893, var_853, var_894);
    wp::assign_inplace(var_1, var_889, var_895);
    var_897 = wp::extract(var_1, var_896);
    var_898 = wp::bit_and(var_897, var_851);
    var_900 = (var_898 != var_899);
    if (var_900) {
    }
    if (!var_900) {
        var_901 = wp::extract(var_1, var_896);
    }
    var_902 = wp::where(var_900, var_853, var_901);
    wp::assign_inplace(var_1, var_896, var_902);
    var_904 = wp::extract(var_1, var_903);
    var_905 = wp::bit_and(var_904, var_851);
    var_907 = (var_905 != var_906);
    if (var_907) {
    }
    if (!var_907) {
        var_908 = wp::extract(var_1, var_903);
    }
    var_909 = wp::where(var_907, var_853, var_908);
    wp::assign_inplace(var_1, var_903, var_909);
    // touched = int(0)                                                                       <L 7>
    var_912 = wp::int(var_911);
    // for j in range(LEAF):                                                                  <L 8>
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_914 = wp::extract(var_xs, var_910);
    var_915 = wp::extract(var_xs, var_913);
    var_916 = wp::sub(var_914, var_915);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_917 = wp::extract(var_ys, var_910);
    var_918 = wp::extract(var_ys, var_913);
    var_919 = wp::sub(var_917, var_918);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_920 = wp::extract(var_zs, var_910);
    var_921 = wp::extract(var_zs, var_913);
    var_922 = wp::sub(var_920, var_921);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_923 = wp::mul(var_916, var_916);
    var_924 = wp::mul(var_919, var_919);
    var_925 = wp::add(var_923, var_924);
    var_926 = wp::mul(var_922, var_922);
    var_927 = wp::add(var_925, var_926);
    var_928 = (var_927 <= var_max_sqdist);
    if (var_928) {
        var_929 = wp::extract(var_1, var_913);
    }
    if (!var_928) {
    }
    var_931 = wp::where(var_928, var_929, var_930);
    var_932 = wp::bit_or(var_912, var_931);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_934 = wp::extract(var_xs, var_910);
    var_935 = wp::extract(var_xs, var_933);
    var_936 = wp::sub(var_934, var_935);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_937 = wp::extract(var_ys, var_910);
    var_938 = wp::extract(var_ys, var_933);
    var_939 = wp::sub(var_937, var_938);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_940 = wp::extract(var_zs, var_910);
    var_941 = wp::extract(var_zs, var_933);
    var_942 = wp::sub(var_940, var_941);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_943 = wp::mul(var_936, var_936);
    var_944 = wp::mul(var_939, var_939);
    var_945 = wp::add(var_943, var_944);
    var_946 = wp::mul(var_942, var_942);
    var_947 = wp::add(var_945, var_946);
    var_948 = (var_947 <= var_max_sqdist);
    if (var_948) {
        var_949 = wp::extract(var_1, var_933);
    }
    if (!var_948) {
    }
    var_951 = wp::where(var_948, var_949, var_950);
    var_952 = wp::bit_or(var_932, var_951);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_954 = wp::extract(var_xs, var_910);
    var_955 = wp::extract(var_xs, var_953);
    var_956 = wp::sub(var_954, var_955);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_957 = wp::extract(var_ys, var_910);
    var_958 = wp::extract(var_ys, var_953);
    var_959 = wp::sub(var_957, var_958);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_960 = wp::extract(var_zs, var_910);
    var_961 = wp::extract(var_zs, var_953);
    var_962 = wp::sub(var_960, var_961);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_963 = wp::mul(var_956, var_956);
    var_964 = wp::mul(var_959, var_959);
    var_965 = wp::add(var_963, var_964);
    var_966 = wp::mul(var_962, var_962);
    var_967 = wp::add(var_965, var_966);
    var_968 = (var_967 <= var_max_sqdist);
    if (var_968) {
        var_969 = wp::extract(var_1, var_953);
    }
    if (!var_968) {
    }
    var_971 = wp::where(var_968, var_969, var_970);
    var_972 = wp::bit_or(var_952, var_971);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_974 = wp::extract(var_xs, var_910);
    var_975 = wp::extract(var_xs, var_973);
    var_976 = wp::sub(var_974, var_975);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_977 = wp::extract(var_ys, var_910);
    var_978 = wp::extract(var_ys, var_973);
    var_979 = wp::sub(var_977, var_978);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_980 = wp::extract(var_zs, var_910);
    var_981 = wp::extract(var_zs, var_973);
    var_982 = wp::sub(var_980, var_981);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_983 = wp::mul(var_976, var_976);
    var_984 = wp::mul(var_979, var_979);
    var_985 = wp::add(var_983, var_984);
    var_986 = wp::mul(var_982, var_982);
    var_987 = wp::add(var_985, var_986);
    var_988 = (var_987 <= var_max_sqdist);
    if (var_988) {
        var_989 = wp::extract(var_1, var_973);
    }
    if (!var_988) {
    }
    var_991 = wp::where(var_988, var_989, var_990);
    var_992 = wp::bit_or(var_972, var_991);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_994 = wp::extract(var_xs, var_910);
    var_995 = wp::extract(var_xs, var_993);
    var_996 = wp::sub(var_994, var_995);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_997 = wp::extract(var_ys, var_910);
    var_998 = wp::extract(var_ys, var_993);
    var_999 = wp::sub(var_997, var_998);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_1000 = wp::extract(var_zs, var_910);
    var_1001 = wp::extract(var_zs, var_993);
    var_1002 = wp::sub(var_1000, var_1001);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_1003 = wp::mul(var_996, var_996);
    var_1004 = wp::mul(var_999, var_999);
    var_1005 = wp::add(var_1003, var_1004);
    var_1006 = wp::mul(var_1002, var_1002);
    var_1007 = wp::add(var_1005, var_1006);
    var_1008 = (var_1007 <= var_max_sqdist);
    if (var_1008) {
        var_1009 = wp::extract(var_1, var_993);
    }
    if (!var_1008) {
    }
    var_1011 = wp::where(var_1008, var_1009, var_1010);
    var_1012 = wp::bit_or(var_992, var_1011);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_1014 = wp::extract(var_xs, var_910);
    var_1015 = wp::extract(var_xs, var_1013);
    var_1016 = wp::sub(var_1014, var_1015);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_1017 = wp::extract(var_ys, var_910);
    var_1018 = wp::extract(var_ys, var_1013);
    var_1019 = wp::sub(var_1017, var_1018);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_1020 = wp::extract(var_zs, var_910);
    var_1021 = wp::extract(var_zs, var_1013);
    var_1022 = wp::sub(var_1020, var_1021);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_1023 = wp::mul(var_1016, var_1016);
    var_1024 = wp::mul(var_1019, var_1019);
    var_1025 = wp::add(var_1023, var_1024);
    var_1026 = wp::mul(var_1022, var_1022);
    var_1027 = wp::add(var_1025, var_1026);
    var_1028 = (var_1027 <= var_max_sqdist);
    if (var_1028) {
        var_1029 = wp::extract(var_1, var_1013);
    }
    if (!var_1028) {
    }
    var_1031 = wp::where(var_1028, var_1029, var_1030);
    var_1032 = wp::bit_or(var_1012, var_1031);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_1034 = wp::extract(var_xs, var_910);
    var_1035 = wp::extract(var_xs, var_1033);
    var_1036 = wp::sub(var_1034, var_1035);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_1037 = wp::extract(var_ys, var_910);
    var_1038 = wp::extract(var_ys, var_1033);
    var_1039 = wp::sub(var_1037, var_1038);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_1040 = wp::extract(var_zs, var_910);
    var_1041 = wp::extract(var_zs, var_1033);
    var_1042 = wp::sub(var_1040, var_1041);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_1043 = wp::mul(var_1036, var_1036);
    var_1044 = wp::mul(var_1039, var_1039);
    var_1045 = wp::add(var_1043, var_1044);
    var_1046 = wp::mul(var_1042, var_1042);
    var_1047 = wp::add(var_1045, var_1046);
    var_1048 = (var_1047 <= var_max_sqdist);
    if (var_1048) {
        var_1049 = wp::extract(var_1, var_1033);
    }
    if (!var_1048) {
    }
    var_1051 = wp::where(var_1048, var_1049, var_1050);
    var_1052 = wp::bit_or(var_1032, var_1051);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_1054 = wp::extract(var_xs, var_910);
    var_1055 = wp::extract(var_xs, var_1053);
    var_1056 = wp::sub(var_1054, var_1055);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_1057 = wp::extract(var_ys, var_910);
    var_1058 = wp::extract(var_ys, var_1053);
    var_1059 = wp::sub(var_1057, var_1058);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_1060 = wp::extract(var_zs, var_910);
    var_1061 = wp::extract(var_zs, var_1053);
    var_1062 = wp::sub(var_1060, var_1061);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_1063 = wp::mul(var_1056, var_1056);
    var_1064 = wp::mul(var_1059, var_1059);
    var_1065 = wp::add(var_1063, var_1064);
    var_1066 = wp::mul(var_1062, var_1062);
    var_1067 = wp::add(var_1065, var_1066);
    var_1068 = (var_1067 <= var_max_sqdist);
    if (var_1068) {
        var_1069 = wp::extract(var_1, var_1053);
    }
    if (!var_1068) {
    }
    var_1071 = wp::where(var_1068, var_1069, var_1070);
    var_1072 = wp::bit_or(var_1052, var_1071);
    // lowest = touched & -touched                                                            <L 13>
    var_1073 = wp::neg(var_1072);
    var_1074 = wp::bit_and(var_1072, var_1073);
    // for j in range(LEAF):                                                                  <L 14>
    // heads[j] = lowest if heads[j] & touched != 0 else heads[j]                             <L 15>
    var_1076 = wp::extract(var_1, var_1075);
    var_1077 = wp::bit_and(var_1076, var_1072);
    var_1079 = (var_1077 != var_1078);
    if (var_1079) {
    }
    if (!var_1079) {
        var_1080 = wp::extract(var_1, var_1075);
    }
    var_1081 = wp::where(var_1079, var_1074, var_1080);
    wp::assign_inplace(var_1, var_1075, var_1081);
    var_1083 = wp::extract(var_1, var_1082);
    var_1084 = wp::bit_and(var_1083, var_1072);
    var_1086 = (var_1084 != var_1085);
    if (var_1086) {
    }
    if (!var_1086) {
        var_1087 = wp::extract(var_1, var_1082);
    }
    var_1088 = wp::where(var_1086, var_1074, var_1087);
    wp::assign_inplace(var_1, var_1082, var_1088);
    var_1090 = wp::extract(var_1, var_1089);
    var_1091 = wp::bit_and(var_1090, var_1072);
    var_1093 = (var_1091 != var_1092);
    if (var_1093) {
    }
    if (!var_1093) {
        var_1094 = wp::extract(var_1, var_1089);
    }
    var_1095 = wp::where(var_1093, var_1074, var_1094);
    wp::assign_inplace(var_1, var_1089, var_1095);
    var_1097 = wp::extract(var_1, var_1096);
    var_1098 = wp::bit_and(var_1097, var_1072);
    var_1100 = (var_1098 != var_1099);
    if (var_1100) {
    }
    if (!var_1100) {
        var_1101 = wp::extract(var_1, var_1096);
    }
    var_1102 = wp::where(var_1100, var_1074, var_1101);
    wp::assign_inplace(var_1, var_1096, var_1102);
    var_1104 = wp::extract(var_1, var_1103);
    var_1105 = wp::bit_and(var_1104, var_1072);
    var_1107 = (var_1105 != var_1106);
    if (var_1107) {
    }
    if (!var_1107) {
        var_1108 = wp::extract(var_1, var_1103);
    }
    var_1109 = wp::where(var_1107, var_1074, var_1108);
    wp::assign_inplace(var_1, var_1103, var_1109);
    var_1111 = wp::extract(var_1, var_1110);
    var_1112 = wp::bit_and(var_1111, var_1072);
    var_1114 = (var_1112 != var_1113);
    if (var_1114) {
    }
    if (!var_1114) {
        var_1115 = wp::extract(var_1, var_1110);
    }
    var_1116 = wp::where(var_1114, var_1074, var_1115);
    wp::assign_inplace(var_1, var_1110, var_1116);
    var_1118 = wp::extract(var_1, var_1117);
    var_1119 = wp::bit_and(var_1118, var_1072);
    var_1121 = (var_1119 != var_1120);
    if (var_1121) {
    }
    if (!var_1121) {
        var_1122 = wp::extract(var_1, var_1117);
    }
    var_1123 = wp::where(var_1121, var_1074, var_1122);
    wp::assign_inplace(var_1, var_1117, var_1123);
    var_1125 = wp::extract(var_1, var_1124);
    var_1126 = wp::bit_and(var_1125, var_1072);
    var_1128 = (var_1126 != var_1127);
    if (var_1128) {
    }
    if (!var_1128) {
        var_1129 = wp::extract(var_1, var_1124);
    }
    var_1130 = wp::where(var_1128, var_1074, var_1129);
    wp::assign_inplace(var_1, var_1124, var_1130);
    // touched = int(0)                                                                       <L 7>
    var_1133 = wp::int(var_1132);
    // for j in range(LEAF):                                                                  <L 8>
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_1135 = wp::extract(var_xs, var_1131);
    var_1136 = wp::extract(var_xs, var_1134);
    var_1137 = wp::sub(var_1135, var_1136);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_1138 = wp::extract(var_ys, var_1131);
    var_1139 = wp::extract(var_ys, var_1134);
    var_1140 = wp::sub(var_1138, var_1139);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_1141 = wp::extract(var_zs, var_1131);
    var_1142 = wp::extract(var_zs, var_1134);
    var_1143 = wp::sub(var_1141, var_1142);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_1144 = wp::mul(var_1137, var_1137);
    var_1145 = wp::mul(var_1140, var_1140);
    var_1146 = wp::add(var_1144, var_1145);
    var_1147 = wp::mul(var_1143, var_1143);
    var_1148 = wp::add(var_1146, var_1147);
    var_1149 = (var_1148 <= var_max_sqdist);
    if (var_1149) {
        var_1150 = wp::extract(var_1, var_1134);
    }
    if (!var_1149) {
    }
    var_1152 = wp::where(var_1149, var_1150, var_1151);
    var_1153 = wp::bit_or(var_1133, var_1152);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_1155 = wp::extract(var_xs, var_1131);
    var_1156 = wp::extract(var_xs, var_1154);
    var_1157 = wp::sub(var_1155, var_1156);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_1158 = wp::extract(var_ys, var_1131);
    var_1159 = wp::extract(var_ys, var_1154);
    var_1160 = wp::sub(var_1158, var_1159);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_1161 = wp::extract(var_zs, var_1131);
    var_1162 = wp::extract(var_zs, var_1154);
    var_1163 = wp::sub(var_1161, var_1162);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_1164 = wp::mul(var_1157, var_1157);
    var_1165 = wp::mul(var_1160, var_1160);
    var_1166 = wp::add(var_1164, var_1165);
    var_1167 = wp::mul(var_1163, var_1163);
    var_1168 = wp::add(var_1166, var_1167);
    var_1169 = (var_1168 <= var_max_sqdist);
    if (var_1169) {
        var_1170 = wp::extract(var_1, var_1154);
    }
    if (!var_1169) {
    }
    var_1172 = wp::where(var_1169, var_1170, var_1171);
    var_1173 = wp::bit_or(var_1153, var_1172);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_1175 = wp::extract(var_xs, var_1131);
    var_1176 = wp::extract(var_xs, var_1174);
    var_1177 = wp::sub(var_1175, var_1176);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_1178 = wp::extract(var_ys, var_1131);
    var_1179 = wp::extract(var_ys, var_1174);
    var_1180 = wp::sub(var_1178, var_1179);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_1181 = wp::extract(var_zs, var_1131);
    var_1182 = wp::extract(var_zs, var_1174);
    var_1183 = wp::sub(var_1181, var_1182);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_1184 = wp::mul(var_1177, var_1177);
    var_1185 = wp::mul(var_1180, var_1180);
    var_1186 = wp::add(var_1184, var_1185);
    var_1187 = wp::mul(var_1183, var_1183);
    var_1188 = wp::add(var_1186, var_1187);
    var_1189 = (var_1188 <= var_max_sqdist);
    if (var_1189) {
        var_1190 = wp::extract(var_1, var_1174);
    }
    if (!var_1189) {
    }
    var_1192 = wp::where(var_1189, var_1190, var_1191);
    var_1193 = wp::bit_or(var_1173, var_1192);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_1195 = wp::extract(var_xs, var_1131);
    var_1196 = wp::extract(var_xs, var_1194);
    var_1197 = wp::sub(var_1195, var_1196);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_1198 = wp::extract(var_ys, var_1131);
    var_1199 = wp::extract(var_ys, var_1194);
    var_1200 = wp::sub(var_1198, var_1199);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_1201 = wp::extract(var_zs, var_1131);
    var_1202 = wp::extract(var_zs, var_1194);
    var_1203 = wp::sub(var_1201, var_1202);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_1204 = wp::mul(var_1197, var_1197);
    var_1205 = wp::mul(var_1200, var_1200);
    var_1206 = wp::add(var_1204, var_1205);
    var_1207 = wp::mul(var_1203, var_1203);
    var_1208 = wp::add(var_1206, var_1207);
    var_1209 = (var_1208 <= var_max_sqdist);
    if (var_1209) {
        var_1210 = wp::extract(var_1, var_1194);
    }
    if (!var_1209) {
    }
    var_1212 = wp::where(var_1209, var_1210, var_1211);
    var_1213 = wp::bit_or(var_1193, var_1212);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_1215 = wp::extract(var_xs, var_1131);
    var_1216 = wp::extract(var_xs, var_1214);
    var_1217 = wp::sub(var_1215, var_1216);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_1218 = wp::extract(var_ys, var_1131);
    var_1219 = wp::extract(var_ys, var_1214);
    var_1220 = wp::sub(var_1218, var_1219);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_1221 = wp::extract(var_zs, var_1131);
    var_1222 = wp::extract(var_zs, var_1214);
    var_1223 = wp::sub(var_1221, var_1222);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_1224 = wp::mul(var_1217, var_1217);
    var_1225 = wp::mul(var_1220, var_1220);
    var_1226 = wp::add(var_1224, var_1225);
    var_1227 = wp::mul(var_1223, var_1223);
    var_1228 = wp::add(var_1226, var_1227);
    var_1229 = (var_1228 <= var_max_sqdist);
    if (var_1229) {
        var_1230 = wp::extract(var_1, var_1214);
    }
    if (!var_1229) {
    }
    var_1232 = wp::where(var_1229, var_1230, var_1231);
    var_1233 = wp::bit_or(var_1213, var_1232);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_1235 = wp::extract(var_xs, var_1131);
    var_1236 = wp::extract(var_xs, var_1234);
    var_1237 = wp::sub(var_1235, var_1236);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_1238 = wp::extract(var_ys, var_1131);
    var_1239 = wp::extract(var_ys, var_1234);
    var_1240 = wp::sub(var_1238, var_1239);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_1241 = wp::extract(var_zs, var_1131);
    var_1242 = wp::extract(var_zs, var_1234);
    var_1243 = wp::sub(var_1241, var_1242);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_1244 = wp::mul(var_1237, var_1237);
    var_1245 = wp::mul(var_1240, var_1240);
    var_1246 = wp::add(var_1244, var_1245);
    var_1247 = wp::mul(var_1243, var_1243);
    var_1248 = wp::add(var_1246, var_1247);
    var_1249 = (var_1248 <= var_max_sqdist);
    if (var_1249) {
        var_1250 = wp::extract(var_1, var_1234);
    }
    if (!var_1249) {
    }
    var_1252 = wp::where(var_1249, var_1250, var_1251);
    var_1253 = wp::bit_or(var_1233, var_1252);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_1255 = wp::extract(var_xs, var_1131);
    var_1256 = wp::extract(var_xs, var_1254);
    var_1257 = wp::sub(var_1255, var_1256);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_1258 = wp::extract(var_ys, var_1131);
    var_1259 = wp::extract(var_ys, var_1254);
    var_1260 = wp::sub(var_1258, var_1259);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_1261 = wp::extract(var_zs, var_1131);
    var_1262 = wp::extract(var_zs, var_1254);
    var_1263 = wp::sub(var_1261, var_1262);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_1264 = wp::mul(var_1257, var_1257);
    var_1265 = wp::mul(var_1260, var_1260);
    var_1266 = wp::add(var_1264, var_1265);
    var_1267 = wp::mul(var_1263, var_1263);
    var_1268 = wp::add(var_1266, var_1267);
    var_1269 = (var_1268 <= var_max_sqdist);
    if (var_1269) {
        var_1270 = wp::extract(var_1, var_1254);
    }
    if (!var_1269) {
    }
    var_1272 = wp::where(var_1269, var_1270, var_1271);
    var_1273 = wp::bit_or(var_1253, var_1272);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_1275 = wp::extract(var_xs, var_1131);
    var_1276 = wp::extract(var_xs, var_1274);
    var_1277 = wp::sub(var_1275, var_1276);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_1278 = wp::extract(var_ys, var_1131);
    var_1279 = wp::extract(var_ys, var_1274);
    var_1280 = wp::sub(var_1278, var_1279);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_1281 = wp::extract(var_zs, var_1131);
    var_1282 = wp::extract(var_zs, var_1274);
    var_1283 = wp::sub(var_1281, var_1282);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_1284 = wp::mul(var_1277, var_1277);
    var_1285 = wp::mul(var_1280, var_1280);
    var_1286 = wp::add(var_1284, var_1285);
    var_1287 = wp::mul(var_1283, var_1283);
    var_1288 = wp::add(var_1286, var_1287);
    var_1289 = (var_1288 <= var_max_sqdist);
    if (var_1289) {
        var_1290 = wp::extract(var_1, var_1274);
    }
    if (!var_1289) {
    }
    var_1292 = wp::where(var_1289, var_1290, var_1291);
    var_1293 = wp::bit_or(var_1273, var_1292);
    // lowest = touched & -touched                                                            <L 13>
    var_1294 = wp::neg(var_1293);
    var_1295 = wp::bit_and(var_1293, var_1294);
    // for j in range(LEAF):                                                                  <L 14>
    // heads[j] = lowest if heads[j] & touched != 0 else heads[j]                             <L 15>
    var_1297 = wp::extract(var_1, var_1296);
    var_1298 = wp::bit_and(var_1297, var_1293);
    var_1300 = (var_1298 != var_1299);
    if (var_1300) {
    }
    if (!var_1300) {
        var_1301 = wp::extract(var_1, var_1296);
    }
    var_1302 = wp::where(var_1300, var_1295, var_1301);
    wp::assign_inplace(var_1, var_1296, var_1302);
    var_1304 = wp::extract(var_1, var_1303);
    var_1305 = wp::bit_and(var_1304, var_1293);
    var_1307 = (var_1305 != var_1306);
    if (var_1307) {
    }
    if (!var_1307) {
        var_1308 = wp::extract(var_1, var_1303);
    }
    var_1309 = wp::where(var_1307, var_1295, var_1308);
    wp::assign_inplace(var_1, var_1303, var_1309);
    var_1311 = wp::extract(var_1, var_1310);
    var_1312 = wp::bit_and(var_1311, var_1293);
    var_1314 = (var_1312 != var_1313);
    if (var_1314) {
    }
    if (!var_1314) {
        var_1315 = wp::extract(var_1, var_1310);
    }
    var_1316 = wp::where(var_1314, var_1295, var_1315);
    wp::assign_inplace(var_1, var_1310, var_1316);
    var_1318 = wp::extract(var_1, var_1317);
    var_1319 = wp::bit_and(var_1318, var_1293);
    var_1321 = (var_1319 != var_1320);
    if (var_1321) {
    }
    if (!var_1321) {
        var_1322 = wp::extract(var_1, var_1317);
    }
    var_1323 = wp::where(var_1321, var_1295, var_1322);
    wp::assign_inplace(var_1, var_1317, var_1323);
    var_1325 = wp::extract(var_1, var_1324);
    var_1326 = wp::bit_and(var_1325, var_1293);
    var_1328 = (var_1326 != var_1327);
    if (var_1328) {
    }
    if (!var_1328) {
        var_1329 = wp::extract(var_1, var_1324);
    }
    var_1330 = wp::where(var_1328, var_1295, var_1329);
    wp::assign_inplace(var_1, var_1324, var_1330);
    var_1332 = wp::extract(var_1, var_1331);
    var_1333 = wp::bit_and(var_1332, var_1293);
    var_1335 = (var_1333 != var_1334);
    if (var_1335) {
    }
    if (!var_1335) {
        var_1336 = wp::extract(var_1, var_1331);
    }
    var_1337 = wp::where(var_1335, var_1295, var_1336);
    wp::assign_inplace(var_1, var_1331, var_1337);
    var_1339 = wp::extract(var_1, var_1338);
    var_1340 = wp::bit_and(var_1339, var_1293);
    var_1342 = (var_1340 != var_1341);
    if (var_1342) {
    }
    if (!var_1342) {
        var_1343 = wp::extract(var_1, var_1338);
    }
    var_1344 = wp::where(var_1342, var_1295, var_1343);
    wp::assign_inplace(var_1, var_1338, var_1344);
    var_1346 = wp::extract(var_1, var_1345);
    var_1347 = wp::bit_and(var_1346, var_1293);
    var_1349 = (var_1347 != var_1348);
    if (var_1349) {
    }
    if (!var_1349) {
        var_1350 = wp::extract(var_1, var_1345);
    }
    var_1351 = wp::where(var_1349, var_1295, var_1350);
    wp::assign_inplace(var_1, var_1345, var_1351);
    // touched = int(0)                                                                       <L 7>
    var_1354 = wp::int(var_1353);
    // for j in range(LEAF):                                                                  <L 8>
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_1356 = wp::extract(var_xs, var_1352);
    var_1357 = wp::extract(var_xs, var_1355);
    var_1358 = wp::sub(var_1356, var_1357);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_1359 = wp::extract(var_ys, var_1352);
    var_1360 = wp::extract(var_ys, var_1355);
    var_1361 = wp::sub(var_1359, var_1360);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_1362 = wp::extract(var_zs, var_1352);
    var_1363 = wp::extract(var_zs, var_1355);
    var_1364 = wp::sub(var_1362, var_1363);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_1365 = wp::mul(var_1358, var_1358);
    var_1366 = wp::mul(var_1361, var_1361);
    var_1367 = wp::add(var_1365, var_1366);
    var_1368 = wp::mul(var_1364, var_1364);
    var_1369 = wp::add(var_1367, var_1368);
    var_1370 = (var_1369 <= var_max_sqdist);
    if (var_1370) {
        var_1371 = wp::extract(var_1, var_1355);
    }
    if (!var_1370) {
    }
    var_1373 = wp::where(var_1370, var_1371, var_1372);
    var_1374 = wp::bit_or(var_1354, var_1373);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_1376 = wp::extract(var_xs, var_1352);
    var_1377 = wp::extract(var_xs, var_1375);
    var_1378 = wp::sub(var_1376, var_1377);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_1379 = wp::extract(var_ys, var_1352);
    var_1380 = wp::extract(var_ys, var_1375);
    var_1381 = wp::sub(var_1379, var_1380);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_1382 = wp::extract(var_zs, var_1352);
    var_1383 = wp::extract(var_zs, var_1375);
    var_1384 = wp::sub(var_1382, var_1383);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_1385 = wp::mul(var_1378, var_1378);
    var_1386 = wp::mul(var_1381, var_1381);
    var_1387 = wp::add(var_1385, var_1386);
    var_1388 = wp::mul(var_1384, var_1384);
    var_1389 = wp::add(var_1387, var_1388);
    var_1390 = (var_1389 <= var_max_sqdist);
    if (var_1390) {
        var_1391 = wp::extract(var_1, var_1375);
    }
    if (!var_1390) {
    }
    var_1393 = wp::where(var_1390, var_1391, var_1392);
    var_1394 = wp::bit_or(var_1374, var_1393);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_1396 = wp::extract(var_xs, var_1352);
    var_1397 = wp::extract(var_xs, var_1395);
    var_1398 = wp::sub(var_1396, var_1397);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_1399 = wp::extract(var_ys, var_1352);
    var_1400 = wp::extract(var_ys, var_1395);
    var_1401 = wp::sub(var_1399, var_1400);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_1402 = wp::extract(var_zs, var_1352);
    var_1403 = wp::extract(var_zs, var_1395);
    var_1404 = wp::sub(var_1402, var_1403);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_1405 = wp::mul(var_1398, var_1398);
    var_1406 = wp::mul(var_1401, var_1401);
    var_1407 = wp::add(var_1405, var_1406);
    var_1408 = wp::mul(var_1404, var_1404);
    var_1409 = wp::add(var_1407, var_1408);
    var_1410 = (var_1409 <= var_max_sqdist);
    if (var_1410) {
        var_1411 = wp::extract(var_1, var_1395);
    }
    if (!var_1410) {
    }
    var_1413 = wp::where(var_1410, var_1411, var_1412);
    var_1414 = wp::bit_or(var_1394, var_1413);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_1416 = wp::extract(var_xs, var_1352);
    var_1417 = wp::extract(var_xs, var_1415);
    var_1418 = wp::sub(var_1416, var_1417);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_1419 = wp::extract(var_ys, var_1352);
    var_1420 = wp::extract(var_ys, var_1415);
    var_1421 = wp::sub(var_1419, var_1420);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_1422 = wp::extract(var_zs, var_1352);
    var_1423 = wp::extract(var_zs, var_1415);
    var_1424 = wp::sub(var_1422, var_1423);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_1425 = wp::mul(var_1418, var_1418);
    var_1426 = wp::mul(var_1421, var_1421);
    var_1427 = wp::add(var_1425, var_1426);
    var_1428 = wp::mul(var_1424, var_1424);
    var_1429 = wp::add(var_1427, var_1428);
    var_1430 = (var_1429 <= var_max_sqdist);
    if (var_1430) {
        var_1431 = wp::extract(var_1, var_1415);
    }
    if (!var_1430) {
    }
    var_1433 = wp::where(var_1430, var_1431, var_1432);
    var_1434 = wp::bit_or(var_1414, var_1433);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_1436 = wp::extract(var_xs, var_1352);
    var_1437 = wp::extract(var_xs, var_1435);
    var_1438 = wp::sub(var_1436, var_1437);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_1439 = wp::extract(var_ys, var_1352);
    var_1440 = wp::extract(var_ys, var_1435);
    var_1441 = wp::sub(var_1439, var_1440);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_1442 = wp::extract(var_zs, var_1352);
    var_1443 = wp::extract(var_zs, var_1435);
    var_1444 = wp::sub(var_1442, var_1443);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_1445 = wp::mul(var_1438, var_1438);
    var_1446 = wp::mul(var_1441, var_1441);
    var_1447 = wp::add(var_1445, var_1446);
    var_1448 = wp::mul(var_1444, var_1444);
    var_1449 = wp::add(var_1447, var_1448);
    var_1450 = (var_1449 <= var_max_sqdist);
    if (var_1450) {
        var_1451 = wp::extract(var_1, var_1435);
    }
    if (!var_1450) {
    }
    var_1453 = wp::where(var_1450, var_1451, var_1452);
    var_1454 = wp::bit_or(var_1434, var_1453);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_1456 = wp::extract(var_xs, var_1352);
    var_1457 = wp::extract(var_xs, var_1455);
    var_1458 = wp::sub(var_1456, var_1457);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_1459 = wp::extract(var_ys, var_1352);
    var_1460 = wp::extract(var_ys, var_1455);
    var_1461 = wp::sub(var_1459, var_1460);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_1462 = wp::extract(var_zs, var_1352);
    var_1463 = wp::extract(var_zs, var_1455);
    var_1464 = wp::sub(var_1462, var_1463);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_1465 = wp::mul(var_1458, var_1458);
    var_1466 = wp::mul(var_1461, var_1461);
    var_1467 = wp::add(var_1465, var_1466);
    var_1468 = wp::mul(var_1464, var_1464);
    var_1469 = wp::add(var_1467, var_1468);
    var_1470 = (var_1469 <= var_max_sqdist);
    if (var_1470) {
        var_1471 = wp::extract(var_1, var_1455);
    }
    if (!var_1470) {
    }
    var_1473 = wp::where(var_1470, var_1471, var_1472);
    var_1474 = wp::bit_or(var_1454, var_1473);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_1476 = wp::extract(var_xs, var_1352);
    var_1477 = wp::extract(var_xs, var_1475);
    var_1478 = wp::sub(var_1476, var_1477);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_1479 = wp::extract(var_ys, var_1352);
    var_1480 = wp::extract(var_ys, var_1475);
    var_1481 = wp::sub(var_1479, var_1480);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_1482 = wp::extract(var_zs, var_1352);
    var_1483 = wp::extract(var_zs, var_1475);
    var_1484 = wp::sub(var_1482, var_1483);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_1485 = wp::mul(var_1478, var_1478);
    var_1486 = wp::mul(var_1481, var_1481);
    var_1487 = wp::add(var_1485, var_1486);
    var_1488 = wp::mul(var_1484, var_1484);
    var_1489 = wp::add(var_1487, var_1488);
    var_1490 = (var_1489 <= var_max_sqdist);
    if (var_1490) {
        var_1491 = wp::extract(var_1, var_1475);
    }
    if (!var_1490) {
    }
    var_1493 = wp::where(var_1490, var_1491, var_1492);
    var_1494 = wp::bit_or(var_1474, var_1493);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_1496 = wp::extract(var_xs, var_1352);
    var_1497 = wp::extract(var_xs, var_1495);
    var_1498 = wp::sub(var_1496, var_1497);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_1499 = wp::extract(var_ys, var_1352);
    var_1500 = wp::extract(var_ys, var_1495);
    var_1501 = wp::sub(var_1499, var_1500);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_1502 = wp::extract(var_zs, var_1352);
    var_1503 = wp::extract(var_zs, var_1495);
    var_1504 = wp::sub(var_1502, var_1503);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_1505 = wp::mul(var_1498, var_1498);
    var_1506 = wp::mul(var_1501, var_1501);
    var_1507 = wp::add(var_1505, var_1506);
    var_1508 = wp::mul(var_1504, var_1504);
    var_1509 = wp::add(var_1507, var_1508);
    var_1510 = (var_1509 <= var_max_sqdist);
    if (var_1510) {
        var_1511 = wp::extract(var_1, var_1495);
    }
    if (!var_1510) {
    }
    var_1513 = wp::where(var_1510, var_1511, var_1512);
    var_1514 = wp::bit_or(var_1494, var_1513);
    // lowest = touched & -touched                                                            <L 13>
    var_1515 = wp::neg(var_1514);
    var_1516 = wp::bit_and(var_1514, var_1515);
    // for j in range(LEAF):                                                                  <L 14>
    // heads[j] = lowest if heads[j] & touched != 0 else heads[j]                             <L 15>
    var_1518 = wp::extract(var_1, var_1517);
    var_1519 = wp::bit_and(var_1518, var_1514);
    var_1521 = (var_1519 != var_1520);
    if (var_1521) {
    }
    if (!var_1521) {
        var_1522 = wp::extract(var_1, var_1517);
    }
    var_1523 = wp::where(var_1521, var_1516, var_1522);
    wp::assign_inplace(var_1, var_1517, var_1523);
    var_1525 = wp::extract(var_1, var_1524);
    var_1526 = wp::bit_and(var_1525, var_1514);
    var_1528 = (var_1526 != var_1527);
    if (var_1528) {
    }
    if (!var_1528) {
        var_1529 = wp::extract(var_1, var_1524);
    }
    var_1530 = wp::where(var_1528, var_1516, var_1529);
    wp::assign_inplace(var_1, var_1524, var_1530);
    var_1532 = wp::extract(var_1, var_1531);
    var_1533 = wp::bit_and(var_1532, var_1514);
    var_1535 = (var_1533 != var_1534);
    if (var_1535) {
    }
    if (!var_1535) {
        var_1536 = wp::extract(var_1, var_1531);
    }
    var_1537 = wp::where(var_1535, var_1516, var_1536);
    wp::assign_inplace(var_1, var_1531, var_1537);
    var_1539 = wp::extract(var_1, var_1538);
    var_1540 = wp::bit_and(var_1539, var_1514);
    var_1542 = (var_1540 != var_1541);
    if (var_1542) {
    }
    if (!var_1542) {
        var_1543 = wp::extract(var_1, var_1538);
    }
    var_1544 = wp::where(var_1542, var_1516, var_1543);
    wp::assign_inplace(var_1, var_1538, var_1544);
    var_1546 = wp::extract(var_1, var_1545);
    var_1547 = wp::bit_and(var_1546, var_1514);
    var_1549 = (var_1547 != var_1548);
    if (var_1549) {
    }
    if (!var_1549) {
        var_1550 = wp::extract(var_1, var_1545);
    }
    var_1551 = wp::where(var_1549, var_1516, var_1550);
    wp::assign_inplace(var_1, var_1545, var_1551);
    var_1553 = wp::extract(var_1, var_1552);
    var_1554 = wp::bit_and(var_1553, var_1514);
    var_1556 = (var_1554 != var_1555);
    if (var_1556) {
    }
    if (!var_1556) {
        var_1557 = wp::extract(var_1, var_1552);
    }
    var_1558 = wp::where(var_1556, var_1516, var_1557);
    wp::assign_inplace(var_1, var_1552, var_1558);
    var_1560 = wp::extract(var_1, var_1559);
    var_1561 = wp::bit_and(var_1560, var_1514);
    var_1563 = (var_1561 != var_1562);
    if (var_1563) {
    }
    if (!var_1563) {
        var_1564 = wp::extract(var_1, var_1559);
    }
    var_1565 = wp::where(var_1563, var_1516, var_1564);
    wp::assign_inplace(var_1, var_1559, var_1565);
    var_1567 = wp::extract(var_1, var_1566);
    var_1568 = wp::bit_and(var_1567, var_1514);
    var_1570 = (var_1568 != var_1569);
    if (var_1570) {
    }
    if (!var_1570) {
        var_1571 = wp::extract(var_1, var_1566);
    }
    var_1572 = wp::where(var_1570, var_1516, var_1571);
    wp::assign_inplace(var_1, var_1566, var_1572);
    // touched = int(0)                                                                       <L 7>
    var_1575 = wp::int(var_1574);
    // for j in range(LEAF):                                                                  <L 8>
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_1577 = wp::extract(var_xs, var_1573);
    var_1578 = wp::extract(var_xs, var_1576);
    var_1579 = wp::sub(var_1577, var_1578);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_1580 = wp::extract(var_ys, var_1573);
    var_1581 = wp::extract(var_ys, var_1576);
    var_1582 = wp::sub(var_1580, var_1581);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_1583 = wp::extract(var_zs, var_1573);
    var_1584 = wp::extract(var_zs, var_1576);
    var_1585 = wp::sub(var_1583, var_1584);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_1586 = wp::mul(var_1579, var_1579);
    var_1587 = wp::mul(var_1582, var_1582);
    var_1588 = wp::add(var_1586, var_1587);
    var_1589 = wp::mul(var_1585, var_1585);
    var_1590 = wp::add(var_1588, var_1589);
    var_1591 = (var_1590 <= var_max_sqdist);
    if (var_1591) {
        var_1592 = wp::extract(var_1, var_1576);
    }
    if (!var_1591) {
    }
    var_1594 = wp::where(var_1591, var_1592, var_1593);
    var_1595 = wp::bit_or(var_1575, var_1594);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_1597 = wp::extract(var_xs, var_1573);
    var_1598 = wp::extract(var_xs, var_1596);
    var_1599 = wp::sub(var_1597, var_1598);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_1600 = wp::extract(var_ys, var_1573);
    var_1601 = wp::extract(var_ys, var_1596);
    var_1602 = wp::sub(var_1600, var_1601);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_1603 = wp::extract(var_zs, var_1573);
    var_1604 = wp::extract(var_zs, var_1596);
    var_1605 = wp::sub(var_1603, var_1604);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_1606 = wp::mul(var_1599, var_1599);
    var_1607 = wp::mul(var_1602, var_1602);
    var_1608 = wp::add(var_1606, var_1607);
    var_1609 = wp::mul(var_1605, var_1605);
    var_1610 = wp::add(var_1608, var_1609);
    var_1611 = (var_1610 <= var_max_sqdist);
    if (var_1611) {
        var_1612 = wp::extract(var_1, var_1596);
    }
    if (!var_1611) {
    }
    var_1614 = wp::where(var_1611, var_1612, var_1613);
    var_1615 = wp::bit_or(var_1595, var_1614);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_1617 = wp::extract(var_xs, var_1573);
    var_1618 = wp::extract(var_xs, var_1616);
    var_1619 = wp::sub(var_1617, var_1618);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_1620 = wp::extract(var_ys, var_1573);
    var_1621 = wp::extract(var_ys, var_1616);
    var_1622 = wp::sub(var_1620, var_1621);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_1623 = wp::extract(var_zs, var_1573);
    var_1624 = wp::extract(var_zs, var_1616);
    var_1625 = wp::sub(var_1623, var_1624);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_1626 = wp::mul(var_1619, var_1619);
    var_1627 = wp::mul(var_1622, var_1622);
    var_1628 = wp::add(var_1626, var_1627);
    var_1629 = wp::mul(var_1625, var_1625);
    var_1630 = wp::add(var_1628, var_1629);
    var_1631 = (var_1630 <= var_max_sqdist);
    if (var_1631) {
        var_1632 = wp::extract(var_1, var_1616);
    }
    if (!var_1631) {
    }
    var_1634 = wp::where(var_1631, var_1632, var_1633);
    var_1635 = wp::bit_or(var_1615, var_1634);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_1637 = wp::extract(var_xs, var_1573);
    var_1638 = wp::extract(var_xs, var_1636);
    var_1639 = wp::sub(var_1637, var_1638);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_1640 = wp::extract(var_ys, var_1573);
    var_1641 = wp::extract(var_ys, var_1636);
    var_1642 = wp::sub(var_1640, var_1641);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_1643 = wp::extract(var_zs, var_1573);
    var_1644 = wp::extract(var_zs, var_1636);
    var_1645 = wp::sub(var_1643, var_1644);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_1646 = wp::mul(var_1639, var_1639);
    var_1647 = wp::mul(var_1642, var_1642);
    var_1648 = wp::add(var_1646, var_1647);
    var_1649 = wp::mul(var_1645, var_1645);
    var_1650 = wp::add(var_1648, var_1649);
    var_1651 = (var_1650 <= var_max_sqdist);
    if (var_1651) {
        var_1652 = wp::extract(var_1, var_1636);
    }
    if (!var_1651) {
    }
    var_1654 = wp::where(var_1651, var_1652, var_1653);
    var_1655 = wp::bit_or(var_1635, var_1654);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_1657 = wp::extract(var_xs, var_1573);
    var_1658 = wp::extract(var_xs, var_1656);
    var_1659 = wp::sub(var_1657, var_1658);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_1660 = wp::extract(var_ys, var_1573);
    var_1661 = wp::extract(var_ys, var_1656);
    var_1662 = wp::sub(var_1660, var_1661);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_1663 = wp::extract(var_zs, var_1573);
    var_1664 = wp::extract(var_zs, var_1656);
    var_1665 = wp::sub(var_1663, var_1664);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_1666 = wp::mul(var_1659, var_1659);
    var_1667 = wp::mul(var_1662, var_1662);
    var_1668 = wp::add(var_1666, var_1667);
    var_1669 = wp::mul(var_1665, var_1665);
    var_1670 = wp::add(var_1668, var_1669);
    var_1671 = (var_1670 <= var_max_sqdist);
    if (var_1671) {
        var_1672 = wp::extract(var_1, var_1656);
    }
    if (!var_1671) {
    }
    var_1674 = wp::where(var_1671, var_1672, var_1673);
    var_1675 = wp::bit_or(var_1655, var_1674);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_1677 = wp::extract(var_xs, var_1573);
    var_1678 = wp::extract(var_xs, var_1676);
    var_1679 = wp::sub(var_1677, var_1678);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_1680 = wp::extract(var_ys, var_1573);
    var_1681 = wp::extract(var_ys, var_1676);
    var_1682 = wp::sub(var_1680, var_1681);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_1683 = wp::extract(var_zs, var_1573);
    var_1684 = wp::extract(var_zs, var_1676);
    var_1685 = wp::sub(var_1683, var_1684);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_1686 = wp::mul(var_1679, var_1679);
    var_1687 = wp::mul(var_1682, var_1682);
    var_1688 = wp::add(var_1686, var_1687);
    var_1689 = wp::mul(var_1685, var_1685);
    var_1690 = wp::add(var_1688, var_1689);
    var_1691 = (var_1690 <= var_max_sqdist);
    if (var_1691) {
        var_1692 = wp::extract(var_1, var_1676);
    }
    if (!var_1691) {
    }
    var_1694 = wp::where(var_1691, var_1692, var_1693);
    var_1695 = wp::bit_or(var_1675, var_1694);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_1697 = wp::extract(var_xs, var_1573);
    var_1698 = wp::extract(var_xs, var_1696);
    var_1699 = wp::sub(var_1697, var_1698);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_1700 = wp::extract(var_ys, var_1573);
    var_1701 = wp::extract(var_ys, var_1696);
    var_1702 = wp::sub(var_1700, var_1701);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_1703 = wp::extract(var_zs, var_1573);
    var_1704 = wp::extract(var_zs, var_1696);
    var_1705 = wp::sub(var_1703, var_1704);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_1706 = wp::mul(var_1699, var_1699);
    var_1707 = wp::mul(var_1702, var_1702);
    var_1708 = wp::add(var_1706, var_1707);
    var_1709 = wp::mul(var_1705, var_1705);
    var_1710 = wp::add(var_1708, var_1709);
    var_1711 = (var_1710 <= var_max_sqdist);
    if (var_1711) {
        var_1712 = wp::extract(var_1, var_1696);
    }
    if (!var_1711) {
    }
    var_1714 = wp::where(var_1711, var_1712, var_1713);
    var_1715 = wp::bit_or(var_1695, var_1714);
    // x = xs[k] - xs[j]                                                                      <L 9>
    var_1717 = wp::extract(var_xs, var_1573);
    var_1718 = wp::extract(var_xs, var_1716);
    var_1719 = wp::sub(var_1717, var_1718);
    // y = ys[k] - ys[j]                                                                      <L 10>
    var_1720 = wp::extract(var_ys, var_1573);
    var_1721 = wp::extract(var_ys, var_1716);
    var_1722 = wp::sub(var_1720, var_1721);
    // z = zs[k] - zs[j]                                                                      <L 11>
    var_1723 = wp::extract(var_zs, var_1573);
    var_1724 = wp::extract(var_zs, var_1716);
    var_1725 = wp::sub(var_1723, var_1724);
    // touched = touched | (heads[j] if x * x + y * y + z * z <= max_sqdist else 0)           <L 12>
    var_1726 = wp::mul(var_1719, var_1719);
    var_1727 = wp::mul(var_1722, var_1722);
    var_1728 = wp::add(var_1726, var_1727);
    var_1729 = wp::mul(var_1725, var_1725);
    var_1730 = wp::add(var_1728, var_1729);
    var_1731 = (var_1730 <= var_max_sqdist);
    if (var_1731) {
        var_1732 = wp::extract(var_1, var_1716);
    }
    if (!var_1731) {
    }
    var_1734 = wp::where(var_1731, var_1732, var_1733);
    var_1735 = wp::bit_or(var_1715, var_1734);
    // lowest = touched & -touched                                                            <L 13>
    var_1736 = wp::neg(var_1735);
    var_1737 = wp::bit_and(var_1735, var_1736);
    // for j in range(LEAF):                                                                  <L 14>
    // heads[j] = lowest if heads[j] & touched != 0 else heads[j]                             <L 15>
    var_1739 = wp::extract(var_1, var_1738);
    var_1740 = wp::bit_and(var_1739, var_1735);
    var_1742 = (var_1740 != var_1741);
    if (var_1742) {
    }
    if (!var_1742) {
        var_1743 = wp::extract(var_1, var_1738);
    }
    var_1744 = wp::where(var_1742, var_1737, var_1743);
    wp::assign_inplace(var_1, var_1738, var_1744);
    var_1746 = wp::extract(var_1, var_1745);
    var_1747 = wp::bit_and(var_1746, var_1735);
    var_1749 = (var_1747 != var_1748);
    if (var_1749) {
    }
    if (!var_1749) {
        var_1750 = wp::extract(var_1, var_1745);
    }
    var_1751 = wp::where(var_1749, var_1737, var_1750);
    wp::assign_inplace(var_1, var_1745, var_1751);
    var_1753 = wp::extract(var_1, var_1752);
    var_1754 = wp::bit_and(var_1753, var_1735);
    var_1756 = (var_1754 != var_1755);
    if (var_1756) {
    }
    if (!var_1756) {
        var_1757 = wp::extract(var_1, var_1752);
    }
    var_1758 = wp::where(var_1756, var_1737, var_1757);
    wp::assign_inplace(var_1, var_1752, var_1758);
    var_1760 = wp::extract(var_1, var_1759);
    var_1761 = wp::bit_and(var_1760, var_1735);
    var_1763 = (var_1761 != var_1762);
    if (var_1763) {
    }
    if (!var_1763) {
        var_1764 = wp::extract(var_1, var_1759);
    }
    var_1765 = wp::where(var_1763, var_1737, var_1764);
    wp::assign_inplace(var_1, var_1759, var_1765);
    var_1767 = wp::extract(var_1, var_1766);
    var_1768 = wp::bit_and(var_1767, var_1735);
    var_1770 = (var_1768 != var_1769);
    if (var_1770) {
    }
    if (!var_1770) {
        var_1771 = wp::extract(var_1, var_1766);
    }
    var_1772 = wp::where(var_1770, var_1737, var_1771);
    wp::assign_inplace(var_1, var_1766, var_1772);
    var_1774 = wp::extract(var_1, var_1773);
    var_1775 = wp::bit_and(var_1774, var_1735);
    var_1777 = (var_1775 != var_1776);
    if (var_1777) {
    }
    if (!var_1777) {
        var_1778 = wp::extract(var_1, var_1773);
    }
    var_1779 = wp::where(var_1777, var_1737, var_1778);
    wp::assign_inplace(var_1, var_1773, var_1779);
    var_1781 = wp::extract(var_1, var_1780);
    var_1782 = wp::bit_and(var_1781, var_1735);
    var_1784 = (var_1782 != var_1783);
    if (var_1784) {
    }
    if (!var_1784) {
        var_1785 = wp::extract(var_1, var_1780);
    }
    var_1786 = wp::where(var_1784, var_1737, var_1785);
    wp::assign_inplace(var_1, var_1780, var_1786);
    var_1788 = wp::extract(var_1, var_1787);
    var_1789 = wp::bit_and(var_1788, var_1735);
    var_1791 = (var_1789 != var_1790);
    if (var_1791) {
    }
    if (!var_1791) {
        var_1792 = wp::extract(var_1, var_1787);
    }
    var_1793 = wp::where(var_1791, var_1737, var_1792);
    wp::assign_inplace(var_1, var_1787, var_1793);
    // return heads                                                                           <L 16>
    return var_1;
}


// /work/main/src/pointloom/kernels/search/tree_walk.py:185
static CUDA_CALLABLE void adj_box_corner_0(
    wp::array_t<wp::float32> var_boxes,
    wp::int32 var_leaf,
    wp::int32 var_side,
    wp::array_t<wp::float32> & adj_boxes,
    wp::int32 & adj_leaf,
    wp::int32 & adj_side,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.tree_walk.begin_traversal>:1
static CUDA_CALLABLE void adj_begin_traversal_0(
    wp::int32 var_level,
    wp::int32 var_node,
    wp::int32 & adj_level,
    wp::int32 & adj_node,
    wp::vec_t<4, wp::int64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/search/bucket_walk.py:35
static CUDA_CALLABLE void adj_byte_shift_0(
    wp::int32 var_level,
    wp::int32 & adj_level,
    wp::int64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/search/tree_walk.py:40
static CUDA_CALLABLE void adj_pending_shift_0(
    wp::int32 var_level,
    wp::int32 & adj_level,
    wp::int64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/search/tree_walk.py:20
static CUDA_CALLABLE void adj_lowest_bit_0(
    wp::int32 var_bits,
    wp::int32 & adj_bits,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.tree_walk.next_node>:1
static CUDA_CALLABLE void adj_next_node_0(
    wp::vec_t<4, wp::int64> var_step,
    wp::int32 var_top,
    wp::vec_t<4, wp::int64> & adj_step,
    wp::int32 & adj_top,
    wp::vec_t<4, wp::int64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/segmentation/dbscan.py:76
static CUDA_CALLABLE void adj_minimum_of_0(
    wp::vec_t<8, wp::int32> var_values,
    wp::vec_t<8, wp::int32> & adj_values,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/search/tree_walk.py:34
static CUDA_CALLABLE void adj_record_of_0(
    wp::array_t<wp::int32> var_levels,
    wp::int32 var_level,
    wp::int32 var_node,
    wp::array_t<wp::int32> & adj_levels,
    wp::int32 & adj_level,
    wp::int32 & adj_node,
    wp::int32 & adj_ret)
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


// /work/main/src/pointloom/kernels/search/point_tree.py:388
static CUDA_CALLABLE void adj_measure_boxes_0(
    wp::array_t<wp::float32> var_boxes,
    wp::int32 var_node,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::array_t<wp::float32> & adj_boxes,
    wp::int32 & adj_node,
    wp::vec_t<3, wp::float32> & adj_a,
    wp::vec_t<3, wp::float32> & adj_b,
    wp::vec_t<8, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.tree_walk.bits_within>:1
static CUDA_CALLABLE void adj_bits_within_0(
    wp::vec_t<8, wp::float32> var_distances,
    wp::float32 var_max_sqdist,
    wp::vec_t<8, wp::float32> & adj_distances,
    wp::float32 & adj_max_sqdist,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/search/tree_walk.py:85
static CUDA_CALLABLE void adj_own_child_0(
    wp::int32 var_leaf,
    wp::int32 var_level,
    wp::int32 & adj_leaf,
    wp::int32 & adj_level,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/search/tree_walk.py:91
static CUDA_CALLABLE void adj_other_children_0(
    wp::int32 var_leaf,
    wp::int32 var_height,
    wp::int32 var_level,
    wp::int32 & adj_leaf,
    wp::int32 & adj_height,
    wp::int32 & adj_level,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/search/tree_walk.py:151
static CUDA_CALLABLE void adj_measure_farthest_0(
    wp::array_t<wp::float32> var_boxes,
    wp::int32 var_record,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::array_t<wp::float32> & adj_boxes,
    wp::int32 & adj_record,
    wp::vec_t<3, wp::float32> & adj_a,
    wp::vec_t<3, wp::float32> & adj_b,
    wp::vec_t<8, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.tree_walk.point_sum>:1
static CUDA_CALLABLE void adj_point_sum_0(
    wp::int32 var_children,
    wp::int32 var_level,
    wp::int32 var_node,
    wp::int32 var_count,
    wp::int32 & adj_children,
    wp::int32 & adj_level,
    wp::int32 & adj_node,
    wp::int32 & adj_count,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/segmentation/dbscan.py:34
static CUDA_CALLABLE void adj_count_leaf_0(
    wp::vec_t<8, wp::int32> var_counts,
    wp::vec_t<8, wp::float32> var_xs,
    wp::vec_t<8, wp::float32> var_ys,
    wp::vec_t<8, wp::float32> var_zs,
    wp::int32 var_first,
    wp::int32 var_last,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::float32 var_max_sqdist,
    wp::vec_t<8, wp::int32> & adj_counts,
    wp::vec_t<8, wp::float32> & adj_xs,
    wp::vec_t<8, wp::float32> & adj_ys,
    wp::vec_t<8, wp::float32> & adj_zs,
    wp::int32 & adj_first,
    wp::int32 & adj_last,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_points,
    wp::float32 & adj_max_sqdist,
    wp::vec_t<8, wp::int32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/search/tree_walk.py:52
static CUDA_CALLABLE void adj_put_off_0(
    wp::vec_t<4, wp::int64> var_step,
    wp::int32 var_children,
    wp::vec_t<4, wp::int64> & adj_step,
    wp::int32 & adj_children,
    wp::vec_t<4, wp::int64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.segmentation.dbscan.count_group>:1
static CUDA_CALLABLE void adj_count_group_0(
    wp::vec_t<8, wp::int32> var_counts,
    wp::vec_t<8, wp::float32> var_xs,
    wp::vec_t<8, wp::float32> var_ys,
    wp::vec_t<8, wp::float32> var_zs,
    wp::int32 var_leaf,
    wp::int32 var_tree__count,
    wp::int32 var_tree__root,
    wp::array_t<wp::int32> var_tree__levels,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> var_tree__points,
    wp::float32 var_max_sqdist,
    wp::vec_t<8, wp::int32> & adj_counts,
    wp::vec_t<8, wp::float32> & adj_xs,
    wp::vec_t<8, wp::float32> & adj_ys,
    wp::vec_t<8, wp::float32> & adj_zs,
    wp::int32 & adj_leaf,
    wp::int32 & adj_tree__count,
    wp::int32 & adj_tree__root,
    wp::array_t<wp::int32> & adj_tree__levels,
    wp::array_t<wp::float32> & adj_tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_tree__points,
    wp::float32 & adj_max_sqdist,
    wp::vec_t<8, wp::int32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.segmentation.dbscan.join_lanes>:1
static CUDA_CALLABLE void adj_join_lanes_0(
    wp::vec_t<8, wp::float32> var_xs,
    wp::vec_t<8, wp::float32> var_ys,
    wp::vec_t<8, wp::float32> var_zs,
    wp::float32 var_max_sqdist,
    wp::vec_t<8, wp::float32> & adj_xs,
    wp::vec_t<8, wp::float32> & adj_ys,
    wp::vec_t<8, wp::float32> & adj_zs,
    wp::float32 & adj_max_sqdist,
    wp::vec_t<8, wp::int32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void WP_MAXNREG(80) find_cores_kernel_6e02624f_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::int32 var_cores__tree__count,
    wp::int32 var_cores__tree__root,
    wp::array_t<wp::int32> var_cores__tree__levels,
    wp::array_t<wp::float32> var_cores__tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> var_cores__tree__points,
    wp::float32 var_cores__max_sqdist,
    wp::array_t<wp::int32> var_cores__owners,
    wp::array_t<wp::int32> var_cores__lowest,
    wp::int32 var_needed)
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
        const wp::float32 var_3 = INFINITY;
        wp::vec_t<8, wp::float32> var_4;
        const wp::float32 var_5 = 0.0;
        wp::vec_t<8, wp::float32> var_6;
        const wp::float32 var_7 = 0.0;
        wp::vec_t<8, wp::float32> var_8;
        const wp::int32 var_9 = 0;
        wp::vec_t<8, wp::int32> var_10;
        const wp::int32 var_11 = 0;
        const wp::int32 var_12 = 8;
        wp::int32 var_13;
        wp::int32 var_14;
        bool var_15;
        wp::int32 var_16;
        wp::int32 var_17;
        wp::vec_t<3, wp::float32>* var_18;
        wp::vec_t<3, wp::float32> var_19;
        wp::vec_t<3, wp::float32> var_20;
        const wp::int32 var_21 = 0;
        wp::float32 var_22;
        const wp::int32 var_23 = 1;
        wp::float32 var_24;
        const wp::int32 var_25 = 2;
        wp::float32 var_26;
        wp::int32 var_27;
        const wp::int32 var_28 = 1;
        wp::int32 var_29;
        wp::int32 var_30;
        bool var_31;
        wp::int32 var_32;
        wp::int32 var_33;
        wp::vec_t<3, wp::float32>* var_34;
        wp::vec_t<3, wp::float32> var_35;
        wp::vec_t<3, wp::float32> var_36;
        const wp::int32 var_37 = 0;
        wp::float32 var_38;
        const wp::int32 var_39 = 1;
        wp::float32 var_40;
        const wp::int32 var_41 = 2;
        wp::float32 var_42;
        wp::int32 var_43;
        wp::vec_t<3, wp::float32> var_44;
        const wp::int32 var_45 = 2;
        wp::int32 var_46;
        wp::int32 var_47;
        bool var_48;
        wp::int32 var_49;
        wp::int32 var_50;
        wp::vec_t<3, wp::float32>* var_51;
        wp::vec_t<3, wp::float32> var_52;
        wp::vec_t<3, wp::float32> var_53;
        const wp::int32 var_54 = 0;
        wp::float32 var_55;
        const wp::int32 var_56 = 1;
        wp::float32 var_57;
        const wp::int32 var_58 = 2;
        wp::float32 var_59;
        wp::int32 var_60;
        wp::vec_t<3, wp::float32> var_61;
        const wp::int32 var_62 = 3;
        wp::int32 var_63;
        wp::int32 var_64;
        bool var_65;
        wp::int32 var_66;
        wp::int32 var_67;
        wp::vec_t<3, wp::float32>* var_68;
        wp::vec_t<3, wp::float32> var_69;
        wp::vec_t<3, wp::float32> var_70;
        const wp::int32 var_71 = 0;
        wp::float32 var_72;
        const wp::int32 var_73 = 1;
        wp::float32 var_74;
        const wp::int32 var_75 = 2;
        wp::float32 var_76;
        wp::int32 var_77;
        wp::vec_t<3, wp::float32> var_78;
        const wp::int32 var_79 = 4;
        wp::int32 var_80;
        wp::int32 var_81;
        bool var_82;
        wp::int32 var_83;
        wp::int32 var_84;
        wp::vec_t<3, wp::float32>* var_85;
        wp::vec_t<3, wp::float32> var_86;
        wp::vec_t<3, wp::float32> var_87;
        const wp::int32 var_88 = 0;
        wp::float32 var_89;
        const wp::int32 var_90 = 1;
        wp::float32 var_91;
        const wp::int32 var_92 = 2;
        wp::float32 var_93;
        wp::int32 var_94;
        wp::vec_t<3, wp::float32> var_95;
        const wp::int32 var_96 = 5;
        wp::int32 var_97;
        wp::int32 var_98;
        bool var_99;
        wp::int32 var_100;
        wp::int32 var_101;
        wp::vec_t<3, wp::float32>* var_102;
        wp::vec_t<3, wp::float32> var_103;
        wp::vec_t<3, wp::float32> var_104;
        const wp::int32 var_105 = 0;
        wp::float32 var_106;
        const wp::int32 var_107 = 1;
        wp::float32 var_108;
        const wp::int32 var_109 = 2;
        wp::float32 var_110;
        wp::int32 var_111;
        wp::vec_t<3, wp::float32> var_112;
        const wp::int32 var_113 = 6;
        wp::int32 var_114;
        wp::int32 var_115;
        bool var_116;
        wp::int32 var_117;
        wp::int32 var_118;
        wp::vec_t<3, wp::float32>* var_119;
        wp::vec_t<3, wp::float32> var_120;
        wp::vec_t<3, wp::float32> var_121;
        const wp::int32 var_122 = 0;
        wp::float32 var_123;
        const wp::int32 var_124 = 1;
        wp::float32 var_125;
        const wp::int32 var_126 = 2;
        wp::float32 var_127;
        wp::int32 var_128;
        wp::vec_t<3, wp::float32> var_129;
        const wp::int32 var_130 = 7;
        wp::int32 var_131;
        wp::int32 var_132;
        bool var_133;
        wp::int32 var_134;
        wp::int32 var_135;
        wp::vec_t<3, wp::float32>* var_136;
        wp::vec_t<3, wp::float32> var_137;
        wp::vec_t<3, wp::float32> var_138;
        const wp::int32 var_139 = 0;
        wp::float32 var_140;
        const wp::int32 var_141 = 1;
        wp::float32 var_142;
        const wp::int32 var_143 = 2;
        wp::float32 var_144;
        wp::int32 var_145;
        wp::vec_t<3, wp::float32> var_146;
        wp::vec_t<8, wp::int32> var_147;
        const wp::int32 var_148 = 0;
        wp::int32 var_149;
        const wp::int32 var_150 = 0;
        bool var_151;
        const wp::int32 var_152 = 1;
        wp::int32 var_153;
        const wp::int32 var_154 = 0;
        bool var_155;
        const wp::int32 var_156 = 2;
        wp::int32 var_157;
        const wp::int32 var_158 = 0;
        bool var_159;
        const wp::int32 var_160 = 3;
        wp::int32 var_161;
        const wp::int32 var_162 = 0;
        bool var_163;
        const wp::int32 var_164 = 4;
        wp::int32 var_165;
        const wp::int32 var_166 = 0;
        bool var_167;
        const wp::int32 var_168 = 5;
        wp::int32 var_169;
        const wp::int32 var_170 = 0;
        bool var_171;
        const wp::int32 var_172 = 6;
        wp::int32 var_173;
        const wp::int32 var_174 = 0;
        bool var_175;
        const wp::int32 var_176 = 7;
        wp::int32 var_177;
        const wp::int32 var_178 = 0;
        bool var_179;
        wp::vec_t<8, wp::int32> var_180;
        const wp::int32 var_181 = 2147483647;
        wp::int32 var_182;
        const wp::int32 var_183 = 0;
        wp::int32 var_184;
        bool var_185;
        const wp::int32 var_186 = -1;
        wp::int32 var_187;
        wp::int32 var_188;
        const wp::int32 var_189 = 0;
        bool var_190;
        wp::int32 var_191;
        wp::int32 var_192;
        wp::int32 var_193;
        wp::int32 var_194;
        wp::int32 var_195;
        wp::int32 var_196;
        wp::int32 var_197;
        wp::int32 var_198;
        wp::int32 var_199;
        const wp::int32 var_200 = 1;
        wp::int32 var_201;
        bool var_202;
        wp::int32 var_203;
        wp::int32 var_204;
        const wp::int32 var_205 = 0;
        bool var_206;
        wp::int32 var_207;
        wp::int32 var_208;
        wp::int32 var_209;
        wp::int32 var_210;
        wp::int32 var_211;
        wp::int32 var_212;
        wp::int32 var_213;
        wp::int32 var_214;
        wp::int32 var_215;
        wp::int32 var_216;
        const wp::int32 var_217 = 2;
        wp::int32 var_218;
        bool var_219;
        wp::int32 var_220;
        wp::int32 var_221;
        const wp::int32 var_222 = 0;
        bool var_223;
        wp::int32 var_224;
        wp::int32 var_225;
        wp::int32 var_226;
        wp::int32 var_227;
        wp::int32 var_228;
        wp::int32 var_229;
        wp::int32 var_230;
        wp::int32 var_231;
        wp::int32 var_232;
        wp::int32 var_233;
        const wp::int32 var_234 = 3;
        wp::int32 var_235;
        bool var_236;
        wp::int32 var_237;
        wp::int32 var_238;
        const wp::int32 var_239 = 0;
        bool var_240;
        wp::int32 var_241;
        wp::int32 var_242;
        wp::int32 var_243;
        wp::int32 var_244;
        wp::int32 var_245;
        wp::int32 var_246;
        wp::int32 var_247;
        wp::int32 var_248;
        wp::int32 var_249;
        wp::int32 var_250;
        const wp::int32 var_251 = 4;
        wp::int32 var_252;
        bool var_253;
        wp::int32 var_254;
        wp::int32 var_255;
        const wp::int32 var_256 = 0;
        bool var_257;
        wp::int32 var_258;
        wp::int32 var_259;
        wp::int32 var_260;
        wp::int32 var_261;
        wp::int32 var_262;
        wp::int32 var_263;
        wp::int32 var_264;
        wp::int32 var_265;
        wp::int32 var_266;
        wp::int32 var_267;
        const wp::int32 var_268 = 5;
        wp::int32 var_269;
        bool var_270;
        wp::int32 var_271;
        wp::int32 var_272;
        const wp::int32 var_273 = 0;
        bool var_274;
        wp::int32 var_275;
        wp::int32 var_276;
        wp::int32 var_277;
        wp::int32 var_278;
        wp::int32 var_279;
        wp::int32 var_280;
        wp::int32 var_281;
        wp::int32 var_282;
        wp::int32 var_283;
        wp::int32 var_284;
        const wp::int32 var_285 = 6;
        wp::int32 var_286;
        bool var_287;
        wp::int32 var_288;
        wp::int32 var_289;
        const wp::int32 var_290 = 0;
        bool var_291;
        wp::int32 var_292;
        wp::int32 var_293;
        wp::int32 var_294;
        wp::int32 var_295;
        wp::int32 var_296;
        wp::int32 var_297;
        wp::int32 var_298;
        wp::int32 var_299;
        wp::int32 var_300;
        wp::int32 var_301;
        const wp::int32 var_302 = 7;
        wp::int32 var_303;
        bool var_304;
        wp::int32 var_305;
        wp::int32 var_306;
        const wp::int32 var_307 = 0;
        bool var_308;
        wp::int32 var_309;
        wp::int32 var_310;
        wp::int32 var_311;
        wp::int32 var_312;
        wp::int32 var_313;
        wp::int32 var_314;
        wp::int32 var_315;
        wp::int32 var_316;
        wp::int32 var_317;
        wp::int32 var_318;
        //---------
        // forward
        // def find_cores_kernel(cores__tree__count, cores__tree__root, cores__tree__levels, cores__tree__boxes, cores__tree__points, cores__max_sqdist, cores__owners, cores__lowest, needed):       <L 1>
        // leaf = tid()                                                                           <L 3>
        var_0 = builtin_tid1d();
        // head = leaf * LEAF                                                                     <L 4>
        var_2 = wp::mul(var_0, var_1);
        // xs = lanes(INFINITY)                                                                   <L 5>
        var_4 = wp::vec_t<8, wp::float32>(var_3);
        // ys = lanes(0.0)                                                                        <L 6>
        var_6 = wp::vec_t<8, wp::float32>(var_5);
        // zs = lanes(0.0)                                                                        <L 7>
        var_8 = wp::vec_t<8, wp::float32>(var_7);
        // counts = numbers(0)                                                                    <L 8>
        var_10 = wp::vec_t<8, wp::int32>(var_9);
        // for j in range(LEAF__points_of):                                                       <L 9>
        // if leaf * LEAF__points_of + j < cores__tree__count:                                    <L 10>
        var_13 = wp::mul(var_0, var_12);
        var_14 = wp::add(var_13, var_11);
        var_15 = (var_14 < var_cores__tree__count);
        if (var_15) {
            // p = cores__tree__points[leaf * LEAF__points_of + j]                                <L 11>
            var_16 = wp::mul(var_0, var_12);
            var_17 = wp::add(var_16, var_11);
            var_18 = wp::address(var_cores__tree__points, var_17);
            var_20 = wp::load(var_18);
            var_19 = wp::copy(var_20);
            // xs[j] = p[0]                                                                       <L 12>
            var_22 = wp::extract(var_19, var_21);
            wp::assign_inplace(var_4, var_11, var_22);
            // ys[j] = p[1]                                                                       <L 13>
            var_24 = wp::extract(var_19, var_23);
            wp::assign_inplace(var_6, var_11, var_24);
            // zs[j] = p[2]                                                                       <L 14>
            var_26 = wp::extract(var_19, var_25);
            wp::assign_inplace(var_8, var_11, var_26);
            // counts[j] = -needed                                                                <L 15>
            var_27 = wp::neg(var_needed);
            wp::assign_inplace(var_10, var_11, var_27);
        }
        // if leaf * LEAF__points_of + j < cores__tree__count:                                    <L 10>
        var_29 = wp::mul(var_0, var_12);
        var_30 = wp::add(var_29, var_28);
        var_31 = (var_30 < var_cores__tree__count);
        if (var_31) {
            // p = cores__tree__points[leaf * LEAF__points_of + j]                                <L 11>
            var_32 = wp::mul(var_0, var_12);
            var_33 = wp::add(var_32, var_28);
            var_34 = wp::address(var_cores__tree__points, var_33);
            var_36 = wp::load(var_34);
            var_35 = wp::copy(var_36);
            // xs[j] = p[0]                                                                       <L 12>
            var_38 = wp::extract(var_35, var_37);
            wp::assign_inplace(var_4, var_28, var_38);
            // ys[j] = p[1]                                                                       <L 13>
            var_40 = wp::extract(var_35, var_39);
            wp::assign_inplace(var_6, var_28, var_40);
            // zs[j] = p[2]                                                                       <L 14>
            var_42 = wp::extract(var_35, var_41);
            wp::assign_inplace(var_8, var_28, var_42);
            // counts[j] = -needed                                                                <L 15>
            var_43 = wp::neg(var_needed);
            wp::assign_inplace(var_10, var_28, var_43);
        }
        var_44 = wp::where(var_31, var_35, var_19);
        // if leaf * LEAF__points_of + j < cores__tree__count:                                    <L 10>
        var_46 = wp::mul(var_0, var_12);
        var_47 = wp::add(var_46, var_45);
        var_48 = (var_47 < var_cores__tree__count);
        if (var_48) {
            // p = cores__tree__points[leaf * LEAF__points_of + j]                                <L 11>
            var_49 = wp::mul(var_0, var_12);
            var_50 = wp::add(var_49, var_45);
            var_51 = wp::address(var_cores__tree__points, var_50);
            var_53 = wp::load(var_51);
            var_52 = wp::copy(var_53);
            // xs[j] = p[0]                                                                       <L 12>
            var_55 = wp::extract(var_52, var_54);
            wp::assign_inplace(var_4, var_45, var_55);
            // ys[j] = p[1]                                                                       <L 13>
            var_57 = wp::extract(var_52, var_56);
            wp::assign_inplace(var_6, var_45, var_57);
            // zs[j] = p[2]                                                                       <L 14>
            var_59 = wp::extract(var_52, var_58);
            wp::assign_inplace(var_8, var_45, var_59);
            // counts[j] = -needed                                                                <L 15>
            var_60 = wp::neg(var_needed);
            wp::assign_inplace(var_10, var_45, var_60);
        }
        var_61 = wp::where(var_48, var_52, var_44);
        // if leaf * LEAF__points_of + j < cores__tree__count:                                    <L 10>
        var_63 = wp::mul(var_0, var_12);
        var_64 = wp::add(var_63, var_62);
        var_65 = (var_64 < var_cores__tree__count);
        if (var_65) {
            // p = cores__tree__points[leaf * LEAF__points_of + j]                                <L 11>
            var_66 = wp::mul(var_0, var_12);
            var_67 = wp::add(var_66, var_62);
            var_68 = wp::address(var_cores__tree__points, var_67);
            var_70 = wp::load(var_68);
            var_69 = wp::copy(var_70);
            // xs[j] = p[0]                                                                       <L 12>
            var_72 = wp::extract(var_69, var_71);
            wp::assign_inplace(var_4, var_62, var_72);
            // ys[j] = p[1]                                                                       <L 13>
            var_74 = wp::extract(var_69, var_73);
            wp::assign_inplace(var_6, var_62, var_74);
            // zs[j] = p[2]                                                                       <L 14>
            var_76 = wp::extract(var_69, var_75);
            wp::assign_inplace(var_8, var_62, var_76);
            // counts[j] = -needed                                                                <L 15>
            var_77 = wp::neg(var_needed);
            wp::assign_inplace(var_10, var_62, var_77);
        }
        var_78 = wp::where(var_65, var_69, var_61);
        // if leaf * LEAF__points_of + j < cores__tree__count:                                    <L 10>
        var_80 = wp::mul(var_0, var_12);
        var_81 = wp::add(var_80, var_79);
        var_82 = (var_81 < var_cores__tree__count);
        if (var_82) {
            // p = cores__tree__points[leaf * LEAF__points_of + j]                                <L 11>
            var_83 = wp::mul(var_0, var_12);
            var_84 = wp::add(var_83, var_79);
            var_85 = wp::address(var_cores__tree__points, var_84);
            var_87 = wp::load(var_85);
            var_86 = wp::copy(var_87);
            // xs[j] = p[0]                                                                       <L 12>
            var_89 = wp::extract(var_86, var_88);
            wp::assign_inplace(var_4, var_79, var_89);
            // ys[j] = p[1]                                                                       <L 13>
            var_91 = wp::extract(var_86, var_90);
            wp::assign_inplace(var_6, var_79, var_91);
            // zs[j] = p[2]                                                                       <L 14>
            var_93 = wp::extract(var_86, var_92);
            wp::assign_inplace(var_8, var_79, var_93);
            // counts[j] = -needed                                                                <L 15>
            var_94 = wp::neg(var_needed);
            wp::assign_inplace(var_10, var_79, var_94);
        }
        var_95 = wp::where(var_82, var_86, var_78);
        // if leaf * LEAF__points_of + j < cores__tree__count:                                    <L 10>
        var_97 = wp::mul(var_0, var_12);
        var_98 = wp::add(var_97, var_96);
        var_99 = (var_98 < var_cores__tree__count);
        if (var_99) {
            // p = cores__tree__points[leaf * LEAF__points_of + j]                                <L 11>
            var_100 = wp::mul(var_0, var_12);
            var_101 = wp::add(var_100, var_96);
            var_102 = wp::address(var_cores__tree__points, var_101);
            var_104 = wp::load(var_102);
            var_103 = wp::copy(var_104);
            // xs[j] = p[0]                                                                       <L 12>
            var_106 = wp::extract(var_103, var_105);
            wp::assign_inplace(var_4, var_96, var_106);
            // ys[j] = p[1]                                                                       <L 13>
            var_108 = wp::extract(var_103, var_107);
            wp::assign_inplace(var_6, var_96, var_108);
            // zs[j] = p[2]                                                                       <L 14>
            var_110 = wp::extract(var_103, var_109);
            wp::assign_inplace(var_8, var_96, var_110);
            // counts[j] = -needed                                                                <L 15>
            var_111 = wp::neg(var_needed);
            wp::assign_inplace(var_10, var_96, var_111);
        }
        var_112 = wp::where(var_99, var_103, var_95);
        // if leaf * LEAF__points_of + j < cores__tree__count:                                    <L 10>
        var_114 = wp::mul(var_0, var_12);
        var_115 = wp::add(var_114, var_113);
        var_116 = (var_115 < var_cores__tree__count);
        if (var_116) {
            // p = cores__tree__points[leaf * LEAF__points_of + j]                                <L 11>
            var_117 = wp::mul(var_0, var_12);
            var_118 = wp::add(var_117, var_113);
            var_119 = wp::address(var_cores__tree__points, var_118);
            var_121 = wp::load(var_119);
            var_120 = wp::copy(var_121);
            // xs[j] = p[0]                                                                       <L 12>
            var_123 = wp::extract(var_120, var_122);
            wp::assign_inplace(var_4, var_113, var_123);
            // ys[j] = p[1]                                                                       <L 13>
            var_125 = wp::extract(var_120, var_124);
            wp::assign_inplace(var_6, var_113, var_125);
            // zs[j] = p[2]                                                                       <L 14>
            var_127 = wp::extract(var_120, var_126);
            wp::assign_inplace(var_8, var_113, var_127);
            // counts[j] = -needed                                                                <L 15>
            var_128 = wp::neg(var_needed);
            wp::assign_inplace(var_10, var_113, var_128);
        }
        var_129 = wp::where(var_116, var_120, var_112);
        // if leaf * LEAF__points_of + j < cores__tree__count:                                    <L 10>
        var_131 = wp::mul(var_0, var_12);
        var_132 = wp::add(var_131, var_130);
        var_133 = (var_132 < var_cores__tree__count);
        if (var_133) {
            // p = cores__tree__points[leaf * LEAF__points_of + j]                                <L 11>
            var_134 = wp::mul(var_0, var_12);
            var_135 = wp::add(var_134, var_130);
            var_136 = wp::address(var_cores__tree__points, var_135);
            var_138 = wp::load(var_136);
            var_137 = wp::copy(var_138);
            // xs[j] = p[0]                                                                       <L 12>
            var_140 = wp::extract(var_137, var_139);
            wp::assign_inplace(var_4, var_130, var_140);
            // ys[j] = p[1]                                                                       <L 13>
            var_142 = wp::extract(var_137, var_141);
            wp::assign_inplace(var_6, var_130, var_142);
            // zs[j] = p[2]                                                                       <L 14>
            var_144 = wp::extract(var_137, var_143);
            wp::assign_inplace(var_8, var_130, var_144);
            // counts[j] = -needed                                                                <L 15>
            var_145 = wp::neg(var_needed);
            wp::assign_inplace(var_10, var_130, var_145);
        }
        var_146 = wp::where(var_133, var_137, var_129);
        // counts = count_group(counts, xs, ys, zs, leaf, cores__tree__count, cores__tree__root, cores__tree__levels, cores__tree__boxes, cores__tree__points, cores__max_sqdist)       <L 16>
        var_147 = count_group_0(var_10, var_4, var_6, var_8, var_0, var_cores__tree__count, var_cores__tree__root, var_cores__tree__levels, var_cores__tree__boxes, var_cores__tree__points, var_cores__max_sqdist);
        // for j in range(LEAF):                                                                  <L 17>
        // if counts[j] < 0:                                                                      <L 18>
        var_149 = wp::extract(var_147, var_148);
        var_151 = (var_149 < var_150);
        if (var_151) {
            // xs[j] = INFINITY                                                                   <L 19>
            wp::assign_inplace(var_4, var_148, var_3);
        }
        // if counts[j] < 0:                                                                      <L 18>
        var_153 = wp::extract(var_147, var_152);
        var_155 = (var_153 < var_154);
        if (var_155) {
            // xs[j] = INFINITY                                                                   <L 19>
            wp::assign_inplace(var_4, var_152, var_3);
        }
        // if counts[j] < 0:                                                                      <L 18>
        var_157 = wp::extract(var_147, var_156);
        var_159 = (var_157 < var_158);
        if (var_159) {
            // xs[j] = INFINITY                                                                   <L 19>
            wp::assign_inplace(var_4, var_156, var_3);
        }
        // if counts[j] < 0:                                                                      <L 18>
        var_161 = wp::extract(var_147, var_160);
        var_163 = (var_161 < var_162);
        if (var_163) {
            // xs[j] = INFINITY                                                                   <L 19>
            wp::assign_inplace(var_4, var_160, var_3);
        }
        // if counts[j] < 0:                                                                      <L 18>
        var_165 = wp::extract(var_147, var_164);
        var_167 = (var_165 < var_166);
        if (var_167) {
            // xs[j] = INFINITY                                                                   <L 19>
            wp::assign_inplace(var_4, var_164, var_3);
        }
        // if counts[j] < 0:                                                                      <L 18>
        var_169 = wp::extract(var_147, var_168);
        var_171 = (var_169 < var_170);
        if (var_171) {
            // xs[j] = INFINITY                                                                   <L 19>
            wp::assign_inplace(var_4, var_168, var_3);
        }
        // if counts[j] < 0:                                                                      <L 18>
        var_173 = wp::extract(var_147, var_172);
        var_175 = (var_173 < var_174);
        if (var_175) {
            // xs[j] = INFINITY                                                                   <L 19>
            wp::assign_inplace(var_4, var_172, var_3);
        }
        // if counts[j] < 0:                                                                      <L 18>
        var_177 = wp::extract(var_147, var_176);
        var_179 = (var_177 < var_178);
        if (var_179) {
            // xs[j] = INFINITY                                                                   <L 19>
            wp::assign_inplace(var_4, var_176, var_3);
        }
        // heads = join_lanes(xs, ys, zs, cores__max_sqdist)                                      <L 20>
        var_180 = join_lanes_0(var_4, var_6, var_8, var_cores__max_sqdist);
        // lowest = int(NO_NUMBER)                                                                <L 21>
        var_182 = wp::int(var_181);
        // for j in range(LEAF):                                                                  <L 22>
        // if head + j < cores__tree__count:                                                      <L 23>
        var_184 = wp::add(var_2, var_183);
        var_185 = (var_184 < var_cores__tree__count);
        if (var_185) {
            // owner = int(NOISE)                                                                 <L 24>
            var_187 = wp::int(var_186);
            // if counts[j] >= 0:                                                                 <L 25>
            var_188 = wp::extract(var_147, var_183);
            var_190 = (var_188 >= var_189);
            if (var_190) {
                // owner = head + lowest_bit(heads[j])                                            <L 26>
                var_191 = wp::extract(var_180, var_183);
                var_192 = lowest_bit_0(var_191);
                var_193 = wp::add(var_2, var_192);
                // lowest = min(lowest, head + j)                                                 <L 27>
                var_194 = wp::add(var_2, var_183);
                var_195 = wp::min(var_182, var_194);
            }
            var_196 = wp::where(var_190, var_195, var_182);
            var_197 = wp::where(var_190, var_193, var_187);
            // cores__owners[head + j] = owner                                                    <L 28>
            var_198 = wp::add(var_2, var_183);
            wp::array_store(var_cores__owners, var_198, var_197);
        }
        var_199 = wp::where(var_185, var_196, var_182);
        // if head + j < cores__tree__count:                                                      <L 23>
        var_201 = wp::add(var_2, var_200);
        var_202 = (var_201 < var_cores__tree__count);
        if (var_202) {
            // owner = int(NOISE)                                                                 <L 24>
            var_203 = wp::int(var_186);
            // if counts[j] >= 0:                                                                 <L 25>
            var_204 = wp::extract(var_147, var_200);
            var_206 = (var_204 >= var_205);
            if (var_206) {
                // owner = head + lowest_bit(heads[j])                                            <L 26>
                var_207 = wp::extract(var_180, var_200);
                var_208 = lowest_bit_0(var_207);
                var_209 = wp::add(var_2, var_208);
                // lowest = min(lowest, head + j)                                                 <L 27>
                var_210 = wp::add(var_2, var_200);
                var_211 = wp::min(var_199, var_210);
            }
            var_212 = wp::where(var_206, var_211, var_199);
            var_213 = wp::where(var_206, var_209, var_203);
            // cores__owners[head + j] = owner                                                    <L 28>
            var_214 = wp::add(var_2, var_200);
            wp::array_store(var_cores__owners, var_214, var_213);
        }
        var_215 = wp::where(var_202, var_212, var_199);
        var_216 = wp::where(var_202, var_213, var_197);
        // if head + j < cores__tree__count:                                                      <L 23>
        var_218 = wp::add(var_2, var_217);
        var_219 = (var_218 < var_cores__tree__count);
        if (var_219) {
            // owner = int(NOISE)                                                                 <L 24>
            var_220 = wp::int(var_186);
            // if counts[j] >= 0:                                                                 <L 25>
            var_221 = wp::extract(var_147, var_217);
            var_223 = (var_221 >= var_222);
            if (var_223) {
                // owner = head + lowest_bit(heads[j])                                            <L 26>
                var_224 = wp::extract(var_180, var_217);
                var_225 = lowest_bit_0(var_224);
                var_226 = wp::add(var_2, var_225);
                // lowest = min(lowest, head + j)                                                 <L 27>
                var_227 = wp::add(var_2, var_217);
                var_228 = wp::min(var_215, var_227);
            }
            var_229 = wp::where(var_223, var_228, var_215);
            var_230 = wp::where(var_223, var_226, var_220);
            // cores__owners[head + j] = owner                                                    <L 28>
            var_231 = wp::add(var_2, var_217);
            wp::array_store(var_cores__owners, var_231, var_230);
        }
        var_232 = wp::where(var_219, var_229, var_215);
        var_233 = wp::where(var_219, var_230, var_216);
        // if head + j < cores__tree__count:                                                      <L 23>
        var_235 = wp::add(var_2, var_234);
        var_236 = (var_235 < var_cores__tree__count);
        if (var_236) {
            // owner = int(NOISE)                                                                 <L 24>
            var_237 = wp::int(var_186);
            // if counts[j] >= 0:                                                                 <L 25>
            var_238 = wp::extract(var_147, var_234);
            var_240 = (var_238 >= var_239);
            if (var_240) {
                // owner = head + lowest_bit(heads[j])                                            <L 26>
                var_241 = wp::extract(var_180, var_234);
                var_242 = lowest_bit_0(var_241);
                var_243 = wp::add(var_2, var_242);
                // lowest = min(lowest, head + j)                                                 <L 27>
                var_244 = wp::add(var_2, var_234);
                var_245 = wp::min(var_232, var_244);
            }
            var_246 = wp::where(var_240, var_245, var_232);
            var_247 = wp::where(var_240, var_243, var_237);
            // cores__owners[head + j] = owner                                                    <L 28>
            var_248 = wp::add(var_2, var_234);
            wp::array_store(var_cores__owners, var_248, var_247);
        }
        var_249 = wp::where(var_236, var_246, var_232);
        var_250 = wp::where(var_236, var_247, var_233);
        // if head + j < cores__tree__count:                                                      <L 23>
        var_252 = wp::add(var_2, var_251);
        var_253 = (var_252 < var_cores__tree__count);
        if (var_253) {
            // owner = int(NOISE)                                                                 <L 24>
            var_254 = wp::int(var_186);
            // if counts[j] >= 0:                                                                 <L 25>
            var_255 = wp::extract(var_147, var_251);
            var_257 = (var_255 >= var_256);
            if (var_257) {
                // owner = head + lowest_bit(heads[j])                                            <L 26>
                var_258 = wp::extract(var_180, var_251);
                var_259 = lowest_bit_0(var_258);
                var_260 = wp::add(var_2, var_259);
                // lowest = min(lowest, head + j)                                                 <L 27>
                var_261 = wp::add(var_2, var_251);
                var_262 = wp::min(var_249, var_261);
            }
            var_263 = wp::where(var_257, var_262, var_249);
            var_264 = wp::where(var_257, var_260, var_254);
            // cores__owners[head + j] = owner                                                    <L 28>
            var_265 = wp::add(var_2, var_251);
            wp::array_store(var_cores__owners, var_265, var_264);
        }
        var_266 = wp::where(var_253, var_263, var_249);
        var_267 = wp::where(var_253, var_264, var_250);
        // if head + j < cores__tree__count:                                                      <L 23>
        var_269 = wp::add(var_2, var_268);
        var_270 = (var_269 < var_cores__tree__count);
        if (var_270) {
            // owner = int(NOISE)                                                                 <L 24>
            var_271 = wp::int(var_186);
            // if counts[j] >= 0:                                                                 <L 25>
            var_272 = wp::extract(var_147, var_268);
            var_274 = (var_272 >= var_273);
            if (var_274) {
                // owner = head + lowest_bit(heads[j])                                            <L 26>
                var_275 = wp::extract(var_180, var_268);
                var_276 = lowest_bit_0(var_275);
                var_277 = wp::add(var_2, var_276);
                // lowest = min(lowest, head + j)                                                 <L 27>
                var_278 = wp::add(var_2, var_268);
                var_279 = wp::min(var_266, var_278);
            }
            var_280 = wp::where(var_274, var_279, var_266);
            var_281 = wp::where(var_274, var_277, var_271);
            // cores__owners[head + j] = owner                                                    <L 28>
            var_282 = wp::add(var_2, var_268);
            wp::array_store(var_cores__owners, var_282, var_281);
        }
        var_283 = wp::where(var_270, var_280, var_266);
        var_284 = wp::where(var_270, var_281, var_267);
        // if head + j < cores__tree__count:                                                      <L 23>
        var_286 = wp::add(var_2, var_285);
        var_287 = (var_286 < var_cores__tree__count);
        if (var_287) {
            // owner = int(NOISE)                                                                 <L 24>
            var_288 = wp::int(var_186);
            // if counts[j] >= 0:                                                                 <L 25>
            var_289 = wp::extract(var_147, var_285);
            var_291 = (var_289 >= var_290);
            if (var_291) {
                // owner = head + lowest_bit(heads[j])                                            <L 26>
                var_292 = wp::extract(var_180, var_285);
                var_293 = lowest_bit_0(var_292);
                var_294 = wp::add(var_2, var_293);
                // lowest = min(lowest, head + j)                                                 <L 27>
                var_295 = wp::add(var_2, var_285);
                var_296 = wp::min(var_283, var_295);
            }
            var_297 = wp::where(var_291, var_296, var_283);
            var_298 = wp::where(var_291, var_294, var_288);
            // cores__owners[head + j] = owner                                                    <L 28>
            var_299 = wp::add(var_2, var_285);
            wp::array_store(var_cores__owners, var_299, var_298);
        }
        var_300 = wp::where(var_287, var_297, var_283);
        var_301 = wp::where(var_287, var_298, var_284);
        // if head + j < cores__tree__count:                                                      <L 23>
        var_303 = wp::add(var_2, var_302);
        var_304 = (var_303 < var_cores__tree__count);
        if (var_304) {
            // owner = int(NOISE)                                                                 <L 24>
            var_305 = wp::int(var_186);
            // if counts[j] >= 0:                                                                 <L 25>
            var_306 = wp::extract(var_147, var_302);
            var_308 = (var_306 >= var_307);
            if (var_308) {
                // owner = head + lowest_bit(heads[j])                                            <L 26>
                var_309 = wp::extract(var_180, var_302);
                var_310 = lowest_bit_0(var_309);
                var_311 = wp::add(var_2, var_310);
                // lowest = min(lowest, head + j)                                                 <L 27>
                var_312 = wp::add(var_2, var_302);
                var_313 = wp::min(var_300, var_312);
            }
            var_314 = wp::where(var_308, var_313, var_300);
            var_315 = wp::where(var_308, var_311, var_305);
            // cores__owners[head + j] = owner                                                    <L 28>
            var_316 = wp::add(var_2, var_302);
            wp::array_store(var_cores__owners, var_316, var_315);
        }
        var_317 = wp::where(var_304, var_314, var_300);
        var_318 = wp::where(var_304, var_315, var_301);
        // cores__lowest[leaf] = lowest                                                           <L 29>
        wp::array_store(var_cores__lowest, var_0, var_317);
}


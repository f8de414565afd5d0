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


// /work/main/src/pointloom/kernels/segmentation/cluster_labels.py:91
static CUDA_CALLABLE wp::int32 largest_of_0(
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
    // def largest_of(values: numbers) -> int:                                                <L 92>
    // largest = values[0]                                                                    <L 93>
    var_1 = wp::extract(var_values, var_0);
    // for j in range(1, LEAF):                                                               <L 94>
    // largest = max(largest, values[j])                                                      <L 95>
    var_3 = wp::extract(var_values, var_2);
    var_4 = wp::max(var_1, var_3);
    var_6 = wp::extract(var_values, var_5);
    var_7 = wp::max(var_4, var_6);
    var_9 = wp::extract(var_values, var_8);
    var_10 = wp::max(var_7, var_9);
    var_12 = wp::extract(var_values, var_11);
    var_13 = wp::max(var_10, var_12);
    var_15 = wp::extract(var_values, var_14);
    var_16 = wp::max(var_13, var_15);
    var_18 = wp::extract(var_values, var_17);
    var_19 = wp::max(var_16, var_18);
    var_21 = wp::extract(var_values, var_20);
    var_22 = wp::max(var_19, var_21);
    // return largest                                                                         <L 96>
    return var_22;
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


// <pointloom.kernels.segmentation.cluster_labels.lower_children>:1
static CUDA_CALLABLE wp::int32 lower_children_0(
    wp::array_t<wp::int32> var_lowest,
    wp::int32 var_record,
    wp::int32 var_label)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    const wp::int32 var_2 = 0;
    const wp::int32 var_3 = 8;
    wp::int32 var_4;
    wp::int32 var_5;
    wp::int32* var_6;
    bool var_7;
    wp::int32 var_8;
    const wp::int32 var_9 = 1;
    wp::int32 var_10;
    const wp::int32 var_11 = 0;
    wp::int32 var_12;
    wp::int32 var_13;
    const wp::int32 var_14 = 1;
    wp::int32 var_15;
    wp::int32 var_16;
    wp::int32* var_17;
    bool var_18;
    wp::int32 var_19;
    const wp::int32 var_20 = 1;
    wp::int32 var_21;
    const wp::int32 var_22 = 0;
    wp::int32 var_23;
    wp::int32 var_24;
    const wp::int32 var_25 = 2;
    wp::int32 var_26;
    wp::int32 var_27;
    wp::int32* var_28;
    bool var_29;
    wp::int32 var_30;
    const wp::int32 var_31 = 1;
    wp::int32 var_32;
    const wp::int32 var_33 = 0;
    wp::int32 var_34;
    wp::int32 var_35;
    const wp::int32 var_36 = 3;
    wp::int32 var_37;
    wp::int32 var_38;
    wp::int32* var_39;
    bool var_40;
    wp::int32 var_41;
    const wp::int32 var_42 = 1;
    wp::int32 var_43;
    const wp::int32 var_44 = 0;
    wp::int32 var_45;
    wp::int32 var_46;
    const wp::int32 var_47 = 4;
    wp::int32 var_48;
    wp::int32 var_49;
    wp::int32* var_50;
    bool var_51;
    wp::int32 var_52;
    const wp::int32 var_53 = 1;
    wp::int32 var_54;
    const wp::int32 var_55 = 0;
    wp::int32 var_56;
    wp::int32 var_57;
    const wp::int32 var_58 = 5;
    wp::int32 var_59;
    wp::int32 var_60;
    wp::int32* var_61;
    bool var_62;
    wp::int32 var_63;
    const wp::int32 var_64 = 1;
    wp::int32 var_65;
    const wp::int32 var_66 = 0;
    wp::int32 var_67;
    wp::int32 var_68;
    const wp::int32 var_69 = 6;
    wp::int32 var_70;
    wp::int32 var_71;
    wp::int32* var_72;
    bool var_73;
    wp::int32 var_74;
    const wp::int32 var_75 = 1;
    wp::int32 var_76;
    const wp::int32 var_77 = 0;
    wp::int32 var_78;
    wp::int32 var_79;
    const wp::int32 var_80 = 7;
    wp::int32 var_81;
    wp::int32 var_82;
    wp::int32* var_83;
    bool var_84;
    wp::int32 var_85;
    const wp::int32 var_86 = 1;
    wp::int32 var_87;
    const wp::int32 var_88 = 0;
    wp::int32 var_89;
    wp::int32 var_90;
    //---------
    // forward
    // def lower_children(lowest, record, label):                                             <L 1>
    // bits = int(0)                                                                          <L 3>
    var_1 = wp::int(var_0);
    // for j in range(FAN):                                                                   <L 4>
    // bits = bits | (1 << j if lowest[record * FAN + j] < label else 0)                      <L 5>
    var_4 = wp::mul(var_record, var_3);
    var_5 = wp::add(var_4, var_2);
    var_6 = wp::address(var_lowest, var_5);
    var_8 = wp::load(var_6);
    var_7 = (var_8 < var_label);
    if (var_7) {
        var_10 = wp::lshift(var_9, var_2);
    }
    if (!var_7) {
    }
    var_12 = wp::where(var_7, var_10, var_11);
    var_13 = wp::bit_or(var_1, var_12);
    var_15 = wp::mul(var_record, var_3);
    var_16 = wp::add(var_15, var_14);
    var_17 = wp::address(var_lowest, var_16);
    var_19 = wp::load(var_17);
    var_18 = (var_19 < var_label);
    if (var_18) {
        var_21 = wp::lshift(var_20, var_14);
    }
    if (!var_18) {
    }
    var_23 = wp::where(var_18, var_21, var_22);
    var_24 = wp::bit_or(var_13, var_23);
    var_26 = wp::mul(var_record, var_3);
    var_27 = wp::add(var_26, var_25);
    var_28 = wp::address(var_lowest, var_27);
    var_30 = wp::load(var_28);
    var_29 = (var_30 < var_label);
    if (var_29) {
        var_32 = wp::lshift(var_31, var_25);
    }
    if (!var_29) {
    }
    var_34 = wp::where(var_29, var_32, var_33);
    var_35 = wp::bit_or(var_24, var_34);
    var_37 = wp::mul(var_record, var_3);
    var_38 = wp::add(var_37, var_36);
    var_39 = wp::address(var_lowest, var_38);
    var_41 = wp::load(var_39);
    var_40 = (var_41 < var_label);
    if (var_40) {
        var_43 = wp::lshift(var_42, var_36);
    }
    if (!var_40) {
    }
    var_45 = wp::where(var_40, var_43, var_44);
    var_46 = wp::bit_or(var_35, var_45);
    var_48 = wp::mul(var_record, var_3);
    var_49 = wp::add(var_48, var_47);
    var_50 = wp::address(var_lowest, var_49);
    var_52 = wp::load(var_50);
    var_51 = (var_52 < var_label);
    if (var_51) {
        var_54 = wp::lshift(var_53, var_47);
    }
    if (!var_51) {
    }
    var_56 = wp::where(var_51, var_54, var_55);
    var_57 = wp::bit_or(var_46, var_56);
    var_59 = wp::mul(var_record, var_3);
    var_60 = wp::add(var_59, var_58);
    var_61 = wp::address(var_lowest, var_60);
    var_63 = wp::load(var_61);
    var_62 = (var_63 < var_label);
    if (var_62) {
        var_65 = wp::lshift(var_64, var_58);
    }
    if (!var_62) {
    }
    var_67 = wp::where(var_62, var_65, var_66);
    var_68 = wp::bit_or(var_57, var_67);
    var_70 = wp::mul(var_record, var_3);
    var_71 = wp::add(var_70, var_69);
    var_72 = wp::address(var_lowest, var_71);
    var_74 = wp::load(var_72);
    var_73 = (var_74 < var_label);
    if (var_73) {
        var_76 = wp::lshift(var_75, var_69);
    }
    if (!var_73) {
    }
    var_78 = wp::where(var_73, var_76, var_77);
    var_79 = wp::bit_or(var_68, var_78);
    var_81 = wp::mul(var_record, var_3);
    var_82 = wp::add(var_81, var_80);
    var_83 = wp::address(var_lowest, var_82);
    var_85 = wp::load(var_83);
    var_84 = (var_85 < var_label);
    if (var_84) {
        var_87 = wp::lshift(var_86, var_80);
    }
    if (!var_84) {
    }
    var_89 = wp::where(var_84, var_87, var_88);
    var_90 = wp::bit_or(var_79, var_89);
    // return bits                                                                            <L 6>
    return var_90;
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


// /work/main/src/pointloom/kernels/segmentation/cluster_labels.py:83
static CUDA_CALLABLE wp::vec_t<8, wp::int32> lower_lanes_0(
    wp::vec_t<8, wp::int32> var_best,
    wp::int32 var_value)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::vec_t<8, wp::int32> var_1;
    const wp::int32 var_2 = 0;
    wp::int32 var_3;
    wp::int32 var_4;
    const wp::int32 var_5 = 1;
    wp::int32 var_6;
    wp::int32 var_7;
    const wp::int32 var_8 = 2;
    wp::int32 var_9;
    wp::int32 var_10;
    const wp::int32 var_11 = 3;
    wp::int32 var_12;
    wp::int32 var_13;
    const wp::int32 var_14 = 4;
    wp::int32 var_15;
    wp::int32 var_16;
    const wp::int32 var_17 = 5;
    wp::int32 var_18;
    wp::int32 var_19;
    const wp::int32 var_20 = 6;
    wp::int32 var_21;
    wp::int32 var_22;
    const wp::int32 var_23 = 7;
    wp::int32 var_24;
    wp::int32 var_25;
    //---------
    // forward
    // def lower_lanes(best: numbers, value: int) -> numbers:                                 <L 84>
    // lower = numbers(0)                                                                     <L 85>
    var_1 = wp::vec_t<8, wp::int32>(var_0);
    // for j in range(LEAF):                                                                  <L 86>
    // lower[j] = min(best[j], value)                                                         <L 87>
    var_3 = wp::extract(var_best, var_2);
    var_4 = wp::min(var_3, var_value);
    wp::assign_inplace(var_1, var_2, var_4);
    var_6 = wp::extract(var_best, var_5);
    var_7 = wp::min(var_6, var_value);
    wp::assign_inplace(var_1, var_5, var_7);
    var_9 = wp::extract(var_best, var_8);
    var_10 = wp::min(var_9, var_value);
    wp::assign_inplace(var_1, var_8, var_10);
    var_12 = wp::extract(var_best, var_11);
    var_13 = wp::min(var_12, var_value);
    wp::assign_inplace(var_1, var_11, var_13);
    var_15 = wp::extract(var_best, var_14);
    var_16 = wp::min(var_15, var_value);
    wp::assign_inplace(var_1, var_14, var_16);
    var_18 = wp::extract(var_best, var_17);
    var_19 = wp::min(var_18, var_value);
    wp::assign_inplace(var_1, var_17, var_19);
    var_21 = wp::extract(var_best, var_20);
    var_22 = wp::min(var_21, var_value);
    wp::assign_inplace(var_1, var_20, var_22);
    var_24 = wp::extract(var_best, var_23);
    var_25 = wp::min(var_24, var_value);
    wp::assign_inplace(var_1, var_23, var_25);
    // return lower                                                                           <L 88>
    return var_1;
}


// <pointloom.kernels.segmentation.cluster_labels.follow_leaf>:1
static CUDA_CALLABLE wp::vec_t<8, wp::int32> follow_leaf_0(
    wp::vec_t<8, wp::int32> var_best,
    wp::vec_t<8, wp::float32> var_xs,
    wp::vec_t<8, wp::float32> var_ys,
    wp::vec_t<8, wp::float32> var_zs,
    wp::int32 var_first,
    wp::int32 var_last,
    wp::array_t<wp::vec_t<3, wp::float32>> var_cores__tree__points,
    wp::float32 var_cores__max_sqdist,
    wp::array_t<wp::int32> var_cores__owners)
{
    //---------
    // primal vars
    wp::vec_t<8, wp::int32> var_0;
    wp::range_t var_1;
    wp::int32 var_2;
    wp::int32* var_3;
    wp::int32 var_4;
    wp::int32 var_5;
    const wp::int32 var_6 = 0;
    bool var_7;
    wp::vec_t<3, wp::float32>* var_8;
    wp::vec_t<3, wp::float32> var_9;
    wp::vec_t<3, wp::float32> var_10;
    const wp::int32 var_11 = 0;
    const wp::int32 var_12 = 0;
    wp::float32 var_13;
    wp::float32 var_14;
    wp::float32 var_15;
    const wp::int32 var_16 = 1;
    wp::float32 var_17;
    wp::float32 var_18;
    wp::float32 var_19;
    const wp::int32 var_20 = 2;
    wp::float32 var_21;
    wp::float32 var_22;
    wp::float32 var_23;
    wp::int32 var_24;
    wp::float32 var_25;
    wp::float32 var_26;
    wp::float32 var_27;
    wp::float32 var_28;
    wp::float32 var_29;
    bool var_30;
    const wp::int32 var_31 = 2147483647;
    wp::int32 var_32;
    wp::int32 var_33;
    const wp::int32 var_34 = 1;
    const wp::int32 var_35 = 0;
    wp::float32 var_36;
    wp::float32 var_37;
    wp::float32 var_38;
    const wp::int32 var_39 = 1;
    wp::float32 var_40;
    wp::float32 var_41;
    wp::float32 var_42;
    const wp::int32 var_43 = 2;
    wp::float32 var_44;
    wp::float32 var_45;
    wp::float32 var_46;
    wp::int32 var_47;
    wp::float32 var_48;
    wp::float32 var_49;
    wp::float32 var_50;
    wp::float32 var_51;
    wp::float32 var_52;
    bool var_53;
    wp::int32 var_54;
    wp::int32 var_55;
    const wp::int32 var_56 = 2;
    const wp::int32 var_57 = 0;
    wp::float32 var_58;
    wp::float32 var_59;
    wp::float32 var_60;
    const wp::int32 var_61 = 1;
    wp::float32 var_62;
    wp::float32 var_63;
    wp::float32 var_64;
    const wp::int32 var_65 = 2;
    wp::float32 var_66;
    wp::float32 var_67;
    wp::float32 var_68;
    wp::int32 var_69;
    wp::float32 var_70;
    wp::float32 var_71;
    wp::float32 var_72;
    wp::float32 var_73;
    wp::float32 var_74;
    bool var_75;
    wp::int32 var_76;
    wp::int32 var_77;
    const wp::int32 var_78 = 3;
    const wp::int32 var_79 = 0;
    wp::float32 var_80;
    wp::float32 var_81;
    wp::float32 var_82;
    const wp::int32 var_83 = 1;
    wp::float32 var_84;
    wp::float32 var_85;
    wp::float32 var_86;
    const wp::int32 var_87 = 2;
    wp::float32 var_88;
    wp::float32 var_89;
    wp::float32 var_90;
    wp::int32 var_91;
    wp::float32 var_92;
    wp::float32 var_93;
    wp::float32 var_94;
    wp::float32 var_95;
    wp::float32 var_96;
    bool var_97;
    wp::int32 var_98;
    wp::int32 var_99;
    const wp::int32 var_100 = 4;
    const wp::int32 var_101 = 0;
    wp::float32 var_102;
    wp::float32 var_103;
    wp::float32 var_104;
    const wp::int32 var_105 = 1;
    wp::float32 var_106;
    wp::float32 var_107;
    wp::float32 var_108;
    const wp::int32 var_109 = 2;
    wp::float32 var_110;
    wp::float32 var_111;
    wp::float32 var_112;
    wp::int32 var_113;
    wp::float32 var_114;
    wp::float32 var_115;
    wp::float32 var_116;
    wp::float32 var_117;
    wp::float32 var_118;
    bool var_119;
    wp::int32 var_120;
    wp::int32 var_121;
    const wp::int32 var_122 = 5;
    const wp::int32 var_123 = 0;
    wp::float32 var_124;
    wp::float32 var_125;
    wp::float32 var_126;
    const wp::int32 var_127 = 1;
    wp::float32 var_128;
    wp::float32 var_129;
    wp::float32 var_130;
    const wp::int32 var_131 = 2;
    wp::float32 var_132;
    wp::float32 var_133;
    wp::float32 var_134;
    wp::int32 var_135;
    wp::float32 var_136;
    wp::float32 var_137;
    wp::float32 var_138;
    wp::float32 var_139;
    wp::float32 var_140;
    bool var_141;
    wp::int32 var_142;
    wp::int32 var_143;
    const wp::int32 var_144 = 6;
    const wp::int32 var_145 = 0;
    wp::float32 var_146;
    wp::float32 var_147;
    wp::float32 var_148;
    const wp::int32 var_149 = 1;
    wp::float32 var_150;
    wp::float32 var_151;
    wp::float32 var_152;
    const wp::int32 var_153 = 2;
    wp::float32 var_154;
    wp::float32 var_155;
    wp::float32 var_156;
    wp::int32 var_157;
    wp::float32 var_158;
    wp::float32 var_159;
    wp::float32 var_160;
    wp::float32 var_161;
    wp::float32 var_162;
    bool var_163;
    wp::int32 var_164;
    wp::int32 var_165;
    const wp::int32 var_166 = 7;
    const wp::int32 var_167 = 0;
    wp::float32 var_168;
    wp::float32 var_169;
    wp::float32 var_170;
    const wp::int32 var_171 = 1;
    wp::float32 var_172;
    wp::float32 var_173;
    wp::float32 var_174;
    const wp::int32 var_175 = 2;
    wp::float32 var_176;
    wp::float32 var_177;
    wp::float32 var_178;
    wp::int32 var_179;
    wp::float32 var_180;
    wp::float32 var_181;
    wp::float32 var_182;
    wp::float32 var_183;
    wp::float32 var_184;
    bool var_185;
    wp::int32 var_186;
    wp::int32 var_187;
    //---------
    // forward
    // def follow_leaf(best, xs, ys, zs, first, last, cores__tree__points, cores__max_sqdist, cores__owners):       <L 1>
    // lower = best                                                                           <L 3>
    var_0 = wp::copy(var_best);
    // for r in range(first, last):                                                           <L 4>
    var_1 = wp::range(var_first, var_last);
    start_for_0:;
        if (iter_cmp(var_1) == 0) goto end_for_0;
        var_2 = wp::iter_next(var_1);
        // label = cores__owners[r]                                                           <L 5>
        var_3 = wp::address(var_cores__owners, var_2);
        var_5 = wp::load(var_3);
        var_4 = wp::copy(var_5);
        // if label >= 0:                                                                     <L 6>
        var_7 = (var_4 >= var_6);
        if (var_7) {
            // q = cores__tree__points[r]                                                     <L 7>
            var_8 = wp::address(var_cores__tree__points, var_2);
            var_10 = wp::load(var_8);
            var_9 = wp::copy(var_10);
            // for j in range(LEAF):                                                          <L 8>
            // x = q[0] - xs[j]                                                               <L 9>
            var_13 = wp::extract(var_9, var_12);
            var_14 = wp::extract(var_xs, var_11);
            var_15 = wp::sub(var_13, var_14);
            // y = q[1] - ys[j]                                                               <L 10>
            var_17 = wp::extract(var_9, var_16);
            var_18 = wp::extract(var_ys, var_11);
            var_19 = wp::sub(var_17, var_18);
            // z = q[2] - zs[j]                                                               <L 11>
            var_21 = wp::extract(var_9, var_20);
            var_22 = wp::extract(var_zs, var_11);
            var_23 = wp::sub(var_21, var_22);
            // lower[j] = min(lower[j], label if x * x + y * y + z * z <= cores__max_sqdist else NO_NUMBER)       <L 12>
            var_24 = wp::extract(var_0, var_11);
            var_25 = wp::mul(var_15, var_15);
            var_26 = wp::mul(var_19, var_19);
            var_27 = wp::add(var_25, var_26);
            var_28 = wp::mul(var_23, var_23);
            var_29 = wp::add(var_27, var_28);
            var_30 = (var_29 <= var_cores__max_sqdist);
            if (var_30) {
            }
            if (!var_30) {
            }
            var_32 = wp::where(var_30, var_4, var_31);
            var_33 = wp::min(var_24, var_32);
            wp::assign_inplace(var_0, var_11, var_33);
            // x = q[0] - xs[j]                                                               <L 9>
            var_36 = wp::extract(var_9, var_35);
            var_37 = wp::extract(var_xs, var_34);
            var_38 = wp::sub(var_36, var_37);
            // y = q[1] - ys[j]                                                               <L 10>
            var_40 = wp::extract(var_9, var_39);
            var_41 = wp::extract(var_ys, var_34);
            var_42 = wp::sub(var_40, var_41);
            // z = q[2] - zs[j]                                                               <L 11>
            var_44 = wp::extract(var_9, var_43);
            var_45 = wp::extract(var_zs, var_34);
            var_46 = wp::sub(var_44, var_45);
            // lower[j] = min(lower[j], label if x * x + y * y + z * z <= cores__max_sqdist else NO_NUMBER)       <L 12>
            var_47 = wp::extract(var_0, var_34);
            var_48 = wp::mul(var_38, var_38);
            var_49 = wp::mul(var_42, var_42);
            var_50 = wp::add(var_48, var_49);
            var_51 = wp::mul(var_46, var_46);
            var_52 = wp::add(var_50, var_51);
            var_53 = (var_52 <= var_cores__max_sqdist);
            if (var_53) {
            }
            if (!var_53) {
            }
            var_54 = wp::where(var_53, var_4, var_31);
            var_55 = wp::min(var_47, var_54);
            wp::assign_inplace(var_0, var_34, var_55);
            // x = q[0] - xs[j]                                                               <L 9>
            var_58 = wp::extract(var_9, var_57);
            var_59 = wp::extract(var_xs, var_56);
            var_60 = wp::sub(var_58, var_59);
            // y = q[1] - ys[j]                                                               <L 10>
            var_62 = wp::extract(var_9, var_61);
            var_63 = wp::extract(var_ys, var_56);
            var_64 = wp::sub(var_62, var_63);
            // z = q[2] - zs[j]                                                               <L 11>
            var_66 = wp::extract(var_9, var_65);
            var_67 = wp::extract(var_zs, var_56);
            var_68 = wp::sub(var_66, var_67);
            // lower[j] = min(lower[j], label if x * x + y * y + z * z <= cores__max_sqdist else NO_NUMBER)       <L 12>
            var_69 = wp::extract(var_0, var_56);
            var_70 = wp::mul(var_60, var_60);
            var_71 = wp::mul(var_64, var_64);
            var_72 = wp::add(var_70, var_71);
            var_73 = wp::mul(var_68, var_68);
            var_74 = wp::add(var_72, var_73);
            var_75 = (var_74 <= var_cores__max_sqdist);
            if (var_75) {
            }
            if (!var_75) {
            }
            var_76 = wp::where(var_75, var_4, var_31);
            var_77 = wp::min(var_69, var_76);
            wp::assign_inplace(var_0, var_56, var_77);
            // x = q[0] - xs[j]                                                               <L 9>
            var_80 = wp::extract(var_9, var_79);
            var_81 = wp::extract(var_xs, var_78);
            var_82 = wp::sub(var_80, var_81);
            // y = q[1] - ys[j]                                                               <L 10>
            var_84 = wp::extract(var_9, var_83);
            var_85 = wp::extract(var_ys, var_78);
            var_86 = wp::sub(var_84, var_85);
            // z = q[2] - zs[j]                                                               <L 11>
            var_88 = wp::extract(var_9, var_87);
            var_89 = wp::extract(var_zs, var_78);
            var_90 = wp::sub(var_88, var_89);
            // lower[j] = min(lower[j], label if x * x + y * y + z * z <= cores__max_sqdist else NO_NUMBER)       <L 12>
            var_91 = wp::extract(var_0, var_78);
            var_92 = wp::mul(var_82, var_82);
            var_93 = wp::mul(var_86, var_86);
            var_94 = wp::add(var_92, var_93);
            var_95 = wp::mul(var_90, var_90);
            var_96 = wp::add(var_94, var_95);
            var_97 = (var_96 <= var_cores__max_sqdist);
            if (var_97) {
            }
            if (!var_97) {
            }
            var_98 = wp::where(var_97, var_4, var_31);
            var_99 = wp::min(var_91, var_98);
            wp::assign_inplace(var_0, var_78, var_99);
            // x = q[0] - xs[j]                                                               <L 9>
            var_102 = wp::extract(var_9, var_101);
            var_103 = wp::extract(var_xs, var_100);
            var_104 = wp::sub(var_102, var_103);
            // y = q[1] - ys[j]                                                               <L 10>
            var_106 = wp::extract(var_9, var_105);
            var_107 = wp::extract(var_ys, var_100);
            var_108 = wp::sub(var_106, var_107);
            // z = q[2] - zs[j]                                                               <L 11>
            var_110 = wp::extract(var_9, var_109);
            var_111 = wp::extract(var_zs, var_100);
            var_112 = wp::sub(var_110, var_111);
            // lower[j] = min(lower[j], label if x * x + y * y + z * z <= cores__max_sqdist else NO_NUMBER)       <L 12>
            var_113 = wp::extract(var_0, var_100);
            var_114 = wp::mul(var_104, var_104);
            var_115 = wp::mul(var_108, var_108);
            var_116 = wp::add(var_114, var_115);
            var_117 = wp::mul(var_112, var_112);
            var_118 = wp::add(var_116, var_117);
            var_119 = (var_118 <= var_cores__max_sqdist);
            if (var_119) {
            }
            if (!var_119) {
            }
            var_120 = wp::where(var_119, var_4, var_31);
            var_121 = wp::min(var_113, var_120);
            wp::assign_inplace(var_0, var_100, var_121);
            // x = q[0] - xs[j]                                                               <L 9>
            var_124 = wp::extract(var_9, var_123);
            var_125 = wp::extract(var_xs, var_122);
            var_126 = wp::sub(var_124, var_125);
            // y = q[1] - ys[j]                                                               <L 10>
            var_128 = wp::extract(var_9, var_127);
            var_129 = wp::extract(var_ys, var_122);
            var_130 = wp::sub(var_128, var_129);
            // z = q[2] - zs[j]                                                               <L 11>
            var_132 = wp::extract(var_9, var_131);
            var_133 = wp::extract(var_zs, var_122);
            var_134 = wp::sub(var_132, var_133);
            // lower[j] = min(lower[j], label if x * x + y * y + z * z <= cores__max_sqdist else NO_NUMBER)       <L 12>
            var_135 = wp::extract(var_0, var_122);
            var_136 = wp::mul(var_126, var_126);
            var_137 = wp::mul(var_130, var_130);
            var_138 = wp::add(var_136, var_137);
            var_139 = wp::mul(var_134, var_134);
            var_140 = wp::add(var_138, var_139);
            var_141 = (var_140 <= var_cores__max_sqdist);
            if (var_141) {
            }
            if (!var_141) {
            }
            var_142 = wp::where(var_141, var_4, var_31);
            var_143 = wp::min(var_135, var_142);
            wp::assign_inplace(var_0, var_122, var_143);
            // x = q[0] - xs[j]                                                               <L 9>
            var_146 = wp::extract(var_9, var_145);
            var_147 = wp::extract(var_xs, var_144);
            var_148 = wp::sub(var_146, var_147);
            // y = q[1] - ys[j]                                                               <L 10>
            var_150 = wp::extract(var_9, var_149);
            var_151 = wp::extract(var_ys, var_144);
            var_152 = wp::sub(var_150, var_151);
            // z = q[2] - zs[j]                                                               <L 11>
            var_154 = wp::extract(var_9, var_153);
            var_155 = wp::extract(var_zs, var_144);
            var_156 = wp::sub(var_154, var_155);
            // lower[j] = min(lower[j], label if x * x + y * y + z * z <= cores__max_sqdist else NO_NUMBER)       <L 12>
            var_157 = wp::extract(var_0, var_144);
            var_158 = wp::mul(var_148, var_148);
            var_159 = wp::mul(var_152, var_152);
            var_160 = wp::add(var_158, var_159);
            var_161 = wp::mul(var_156, var_156);
            var_162 = wp::add(var_160, var_161);
            var_163 = (var_162 <= var_cores__max_sqdist);
            if (var_163) {
            }
            if (!var_163) {
            }
            var_164 = wp::where(var_163, var_4, var_31);
            var_165 = wp::min(var_157, var_164);
            wp::assign_inplace(var_0, var_144, var_165);
            // x = q[0] - xs[j]                                                               <L 9>
            var_168 = wp::extract(var_9, var_167);
            var_169 = wp::extract(var_xs, var_166);
            var_170 = wp::sub(var_168, var_169);
            // y = q[1] - ys[j]                                                               <L 10>
            var_172 = wp::extract(var_9, var_171);
            var_173 = wp::extract(var_ys, var_166);
            var_174 = wp::sub(var_172, var_173);
            // z = q[2] - zs[j]                                                               <L 11>
            var_176 = wp::extract(var_9, var_175);
            var_177 = wp::extract(var_zs, var_166);
            var_178 = wp::sub(var_176, var_177);
            // lower[j] = min(lower[j], label if x * x + y * y + z * z <= cores__max_sqdist else NO_NUMBER)       <L 12>
            var_179 = wp::extract(var_0, var_166);
            var_180 = wp::mul(var_170, var_170);
            var_181 = wp::mul(var_174, var_174);
            var_182 = wp::add(var_180, var_181);
            var_183 = wp::mul(var_178, var_178);
            var_184 = wp::add(var_182, var_183);
            var_185 = (var_184 <= var_cores__max_sqdist);
            if (var_185) {
            }
            if (!var_185) {
            }
            var_186 = wp::where(var_185, var_4, var_31);
            var_187 = wp::min(var_179, var_186);
            wp::assign_inplace(var_0, var_166, var_187);
        }
        goto start_for_0;
    end_for_0:;
    // return lower                                                                           <L 13>
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


// <pointloom.kernels.segmentation.cluster_labels.follow_cores>:1
static CUDA_CALLABLE wp::vec_t<8, wp::int32> follow_cores_0(
    wp::vec_t<8, wp::int32> var_best,
    wp::vec_t<8, wp::float32> var_xs,
    wp::vec_t<8, wp::float32> var_ys,
    wp::vec_t<8, wp::float32> var_zs,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::int32 var_leaf,
    wp::int32 var_cores__tree__count,
    wp::int32 var_cores__tree__root,
    wp::array_t<wp::int32> var_cores__tree__levels,
    wp::array_t<wp::float32> var_cores__tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> var_cores__tree__points,
    wp::float32 var_cores__max_sqdist,
    wp::array_t<wp::int32> var_cores__owners,
    wp::array_t<wp::int32> var_cores__lowest)
{
    //---------
    // primal vars
    wp::vec_t<8, wp::int32> var_0;
    wp::int32 var_1;
    const wp::int32 var_2 = 0;
    wp::int32 var_3;
    const wp::int32 var_4 = 0;
    const wp::int32 var_5 = 3;
    const wp::int32 var_6 = 0;
    wp::int32 var_7;
    wp::int32 var_8;
    wp::vec_t<4, wp::int64> var_9;
    const wp::int32 var_10 = 1;
    wp::int32 var_11;
    wp::vec_t<4, wp::int64> var_12;
    const wp::int32 var_13 = 0;
    wp::int64 var_14;
    wp::int32 var_15;
    const wp::int32 var_16 = 1;
    wp::int32 var_17;
    bool var_18;
    const wp::int32 var_19 = 0;
    wp::int64 var_20;
    wp::int32 var_21;
    const wp::int32 var_22 = 1;
    wp::int64 var_23;
    wp::int32 var_24;
    const wp::int32 var_25 = 2;
    wp::int64 var_26;
    wp::int32 var_27;
    const wp::int32 var_28 = 0;
    bool var_29;
    wp::int32 var_30;
    wp::int32 var_31;
    wp::int32 var_32;
    wp::int32 var_33;
    const wp::int32 var_34 = 0;
    bool var_35;
    wp::vec_t<8, wp::float32> var_36;
    wp::int32 var_37;
    wp::int32 var_38;
    wp::int32 var_39;
    const wp::int32 var_40 = 0;
    bool var_41;
    wp::vec_t<8, wp::float32> var_42;
    wp::int32 var_43;
    wp::int32 var_44;
    wp::int32 var_45;
    wp::int32 var_46;
    const wp::int32 var_47 = 0;
    bool var_48;
    wp::int32 var_49;
    const wp::int32 var_50 = 1;
    wp::int32 var_51;
    wp::int32 var_52;
    const wp::int32 var_53 = 8;
    wp::int32 var_54;
    wp::int32 var_55;
    wp::int32* var_56;
    wp::vec_t<8, wp::int32> var_57;
    wp::int32 var_58;
    const wp::int32 var_59 = 1;
    bool var_60;
    wp::int32 var_61;
    const wp::int32 var_62 = 0;
    bool var_63;
    wp::int32 var_64;
    const wp::int32 var_65 = 1;
    wp::int32 var_66;
    wp::int32 var_67;
    const wp::int32 var_68 = 8;
    wp::int32 var_69;
    wp::int32 var_70;
    const wp::int32 var_71 = 8;
    wp::int32 var_72;
    wp::int32 var_73;
    wp::int32 var_74;
    wp::vec_t<8, wp::int32> var_75;
    wp::int32 var_76;
    wp::int32 var_77;
    wp::int32 var_78;
    const wp::int32 var_79 = 1;
    bool var_80;
    wp::vec_t<4, wp::int64> var_81;
    wp::vec_t<4, wp::int64> var_82;
    const wp::int32 var_83 = 1;
    wp::int32 var_84;
    wp::vec_t<4, wp::int64> var_85;
    //---------
    // forward
    // def follow_cores(best, xs, ys, zs, a, b, leaf, cores__tree__count, cores__tree__root, cores__tree__levels, cores__tree__boxes, cores__tree__points, cores__max_sqdist, cores__owners, cores__lowest):       <L 1>
    // lower = best                                                                           <L 3>
    var_0 = wp::copy(var_best);
    // worst = largest_of(lower)                                                              <L 4>
    var_1 = largest_of_0(var_0);
    // near = int(0)                                                                          <L 5>
    var_3 = wp::int(var_2);
    // step__nodes_after__4 = next_node__nodes_after(begin_traversal__nodes_after(0, leaf >> FAN_BITS__nodes_after * 0), cores__tree__root + 1)       <L 6>
    var_7 = wp::mul(var_5, var_6);
    var_8 = wp::rshift(var_leaf, var_7);
    var_9 = begin_traversal_0(var_4, var_8);
    var_11 = wp::add(var_cores__tree__root, var_10);
    var_12 = next_node_0(var_9, var_11);
    // while int(step__nodes_after__4[0]) <= cores__tree__root + 1:                           <L 7>
    start_while_0:;
    var_14 = wp::extract(var_12, var_13);
    var_15 = wp::int(var_14);
    var_17 = wp::add(var_cores__tree__root, var_16);
    var_18 = (var_15 <= var_17);
    if ((var_18) == false) goto end_while_0;
        // height = int(step__nodes_after__4[0])                                              <L 8>
        var_20 = wp::extract(var_12, var_19);
        var_21 = wp::int(var_20);
        // level = int(step__nodes_after__4[1])                                               <L 9>
        var_23 = wp::extract(var_12, var_22);
        var_24 = wp::int(var_23);
        // node = int(step__nodes_after__4[2])                                                <L 10>
        var_26 = wp::extract(var_12, var_25);
        var_27 = wp::int(var_26);
        // if worst <= 0:                                                                     <L 11>
        var_29 = (var_1 <= var_28);
        if (var_29) {
            // break                                                                          <L 12>
            goto end_while_0;
        }
        // record = record_of(cores__tree__levels, level, node)                               <L 13>
        var_30 = record_of_0(var_cores__tree__levels, var_24, var_27);
        // near = lower_children(cores__lowest, record, worst) & other_children(leaf, height, level)       <L 14>
        var_31 = lower_children_0(var_cores__lowest, var_30, var_1);
        var_32 = other_children_0(var_leaf, var_21, var_24);
        var_33 = wp::bit_and(var_31, var_32);
        // if near != 0:                                                                      <L 15>
        var_35 = (var_33 != var_34);
        if (var_35) {
            // near = near & bits_within(measure_boxes(cores__tree__boxes, record, a, b), cores__max_sqdist)       <L 16>
            var_36 = measure_boxes_0(var_cores__tree__boxes, var_30, var_a, var_b);
            var_37 = bits_within_0(var_36, var_cores__max_sqdist);
            var_38 = wp::bit_and(var_33, var_37);
        }
        var_39 = wp::where(var_35, var_38, var_33);
        // if near != 0:                                                                      <L 17>
        var_41 = (var_39 != var_40);
        if (var_41) {
            // inside = near & bits_within(measure_farthest(cores__tree__boxes, record, a, b), cores__max_sqdist)       <L 18>
            var_42 = measure_farthest_0(var_cores__tree__boxes, var_30, var_a, var_b);
            var_43 = bits_within_0(var_42, var_cores__max_sqdist);
            var_44 = wp::bit_and(var_39, var_43);
            // near = near ^ inside                                                           <L 19>
            var_45 = wp::bit_xor(var_39, var_44);
            // left__bits_of__1 = inside                                                      <L 20>
            var_46 = wp::copy(var_44);
            // while left__bits_of__1 != 0:                                                   <L 21>
    start_while_2:;
            var_48 = (var_46 != var_47);
    if ((var_48) == false) goto end_while_2;
                // child = lowest_bit__bits_of(left__bits_of__1)                              <L 22>
                var_49 = lowest_bit_0(var_46);
                // left__bits_of__1 = left__bits_of__1 & left__bits_of__1 - 1                 <L 23>
                var_51 = wp::sub(var_46, var_50);
                var_52 = wp::bit_and(var_46, var_51);
                // lower = lower_lanes(lower, cores__lowest[record * FAN + child])            <L 24>
                var_54 = wp::mul(var_30, var_53);
                var_55 = wp::add(var_54, var_49);
                var_56 = wp::address(var_cores__lowest, var_55);
                var_58 = wp::load(var_56);
                var_57 = lower_lanes_0(var_0, var_58);
                wp::assign(var_0, var_57);
                wp::assign(var_46, var_52);
    goto start_while_2;
    end_while_2:;
            // if level == 1:                                                                 <L 25>
            var_60 = (var_24 == var_59);
            if (var_60) {
                // left__bits_of__3 = near                                                    <L 26>
                var_61 = wp::copy(var_45);
                // while left__bits_of__3 != 0:                                               <L 27>
    start_while_4:;
                var_63 = (var_61 != var_62);
    if ((var_63) == false) goto end_while_4;
                    // child__leaves_of__2 = lowest_bit__bits_of(left__bits_of__3)            <L 28>
                    var_64 = lowest_bit_0(var_61);
                    // left__bits_of__3 = left__bits_of__3 & left__bits_of__3 - 1             <L 29>
                    var_66 = wp::sub(var_61, var_65);
                    var_67 = wp::bit_and(var_61, var_66);
                    // first = (node * FAN__leaves_of + child__leaves_of__2) * LEAF__leaves_of       <L 30>
                    var_69 = wp::mul(var_27, var_68);
                    var_70 = wp::add(var_69, var_64);
                    var_72 = wp::mul(var_70, var_71);
                    // last = min(first + LEAF__leaves_of, cores__tree__count)                <L 31>
                    var_73 = wp::add(var_72, var_71);
                    var_74 = wp::min(var_73, var_cores__tree__count);
                    // lower = follow_leaf(lower, xs, ys, zs, first, last, cores__tree__points, cores__max_sqdist, cores__owners)       <L 32>
                    var_75 = follow_leaf_0(var_0, var_xs, var_ys, var_zs, var_72, var_74, var_cores__tree__points, var_cores__max_sqdist, var_cores__owners);
                    wp::assign(var_0, var_75);
                    wp::assign(var_61, var_67);
    goto start_while_4;
    end_while_4:;
            }
            // worst = largest_of(lower)                                                      <L 33>
            var_76 = largest_of_0(var_0);
        }
        var_77 = wp::where(var_41, var_76, var_1);
        var_78 = wp::where(var_41, var_45, var_39);
        // if level > 1:                                                                      <L 34>
        var_80 = (var_24 > var_79);
        if (var_80) {
            // step__nodes_after__4 = put_off__nodes_after(step__nodes_after__4, near)        <L 35>
            var_81 = put_off_0(var_12, var_78);
        }
        var_82 = wp::where(var_80, var_81, var_12);
        // step__nodes_after__4 = next_node__nodes_after(step__nodes_after__4, cores__tree__root + 1)       <L 36>
        var_84 = wp::add(var_cores__tree__root, var_83);
        var_85 = next_node_0(var_82, var_84);
        wp::assign(var_1, var_77);
        wp::assign(var_3, var_78);
        wp::assign(var_12, var_85);
    goto start_while_0;
    end_while_0:;
    // return lower                                                                           <L 37>
    return var_0;
}


// /work/main/src/pointloom/kernels/segmentation/cluster_labels.py:91
static CUDA_CALLABLE void adj_largest_of_0(
    wp::vec_t<8, wp::int32> var_values,
    wp::vec_t<8, wp::int32> & adj_values,
    wp::int32 & adj_ret)
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


// <pointloom.kernels.segmentation.cluster_labels.lower_children>:1
static CUDA_CALLABLE void adj_lower_children_0(
    wp::array_t<wp::int32> var_lowest,
    wp::int32 var_record,
    wp::int32 var_label,
    wp::array_t<wp::int32> & adj_lowest,
    wp::int32 & adj_record,
    wp::int32 & adj_label,
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


// /work/main/src/pointloom/kernels/segmentation/cluster_labels.py:83
static CUDA_CALLABLE void adj_lower_lanes_0(
    wp::vec_t<8, wp::int32> var_best,
    wp::int32 var_value,
    wp::vec_t<8, wp::int32> & adj_best,
    wp::int32 & adj_value,
    wp::vec_t<8, wp::int32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.segmentation.cluster_labels.follow_leaf>:1
static CUDA_CALLABLE void adj_follow_leaf_0(
    wp::vec_t<8, wp::int32> var_best,
    wp::vec_t<8, wp::float32> var_xs,
    wp::vec_t<8, wp::float32> var_ys,
    wp::vec_t<8, wp::float32> var_zs,
    wp::int32 var_first,
    wp::int32 var_last,
    wp::array_t<wp::vec_t<3, wp::float32>> var_cores__tree__points,
    wp::float32 var_cores__max_sqdist,
    wp::array_t<wp::int32> var_cores__owners,
    wp::vec_t<8, wp::int32> & adj_best,
    wp::vec_t<8, wp::float32> & adj_xs,
    wp::vec_t<8, wp::float32> & adj_ys,
    wp::vec_t<8, wp::float32> & adj_zs,
    wp::int32 & adj_first,
    wp::int32 & adj_last,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_cores__tree__points,
    wp::float32 & adj_cores__max_sqdist,
    wp::array_t<wp::int32> & adj_cores__owners,
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


// <pointloom.kernels.segmentation.cluster_labels.follow_cores>:1
static CUDA_CALLABLE void adj_follow_cores_0(
    wp::vec_t<8, wp::int32> var_best,
    wp::vec_t<8, wp::float32> var_xs,
    wp::vec_t<8, wp::float32> var_ys,
    wp::vec_t<8, wp::float32> var_zs,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::int32 var_leaf,
    wp::int32 var_cores__tree__count,
    wp::int32 var_cores__tree__root,
    wp::array_t<wp::int32> var_cores__tree__levels,
    wp::array_t<wp::float32> var_cores__tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> var_cores__tree__points,
    wp::float32 var_cores__max_sqdist,
    wp::array_t<wp::int32> var_cores__owners,
    wp::array_t<wp::int32> var_cores__lowest,
    wp::vec_t<8, wp::int32> & adj_best,
    wp::vec_t<8, wp::float32> & adj_xs,
    wp::vec_t<8, wp::float32> & adj_ys,
    wp::vec_t<8, wp::float32> & adj_zs,
    wp::vec_t<3, wp::float32> & adj_a,
    wp::vec_t<3, wp::float32> & adj_b,
    wp::int32 & adj_leaf,
    wp::int32 & adj_cores__tree__count,
    wp::int32 & adj_cores__tree__root,
    wp::array_t<wp::int32> & adj_cores__tree__levels,
    wp::array_t<wp::float32> & adj_cores__tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_cores__tree__points,
    wp::float32 & adj_cores__max_sqdist,
    wp::array_t<wp::int32> & adj_cores__owners,
    wp::array_t<wp::int32> & adj_cores__lowest,
    wp::vec_t<8, wp::int32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void renumber_rows_kernel_104f4cfa_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int64> var_keys,
    wp::array_t<wp::int32> var_order,
    wp::array_t<wp::int32> var_renamed)
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
        wp::int64* var_3;
        wp::int32 var_4;
        wp::int64 var_5;
        const wp::int32 var_6 = 2147483647;
        bool var_7;
        wp::int32 var_8;
        wp::int32 var_9;
        wp::int32* var_10;
        wp::int32 var_11;
        //---------
        // forward
        // def renumber_rows_kernel(keys: array(dtype=int64), order: array(dtype=int32), renamed: array(dtype=int32)):       <L 205>
        // i = tid()                                                                              <L 206>
        var_0 = builtin_tid1d();
        // label = int(NOISE)                                                                     <L 207>
        var_2 = wp::int(var_1);
        // if int(keys[i]) < NO_NUMBER:                                                           <L 208>
        var_3 = wp::address(var_keys, var_0);
        var_5 = wp::load(var_3);
        var_4 = wp::int(var_5);
        var_7 = (var_4 < var_6);
        if (var_7) {
            // label = i                                                                          <L 209>
            var_8 = wp::copy(var_0);
        }
        var_9 = wp::where(var_7, var_8, var_2);
        // renamed[order[i]] = label                                                              <L 210>
        var_10 = wp::address(var_order, var_0);
        var_11 = wp::load(var_10);
        wp::array_store(var_renamed, var_11, var_9);
}



extern "C" __global__ void rename_labels_kernel_247c9d76_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_renamed,
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
        const wp::int32 var_2 = 0;
        bool var_3;
        wp::int32 var_4;
        wp::int32* var_5;
        wp::int32 var_6;
        wp::int32* var_7;
        wp::int32 var_8;
        wp::int32 var_9;
        //---------
        // forward
        // def rename_labels_kernel(renamed: array(dtype=int32), labels: array(dtype=int32)):       <L 214>
        // i = tid()                                                                              <L 215>
        var_0 = builtin_tid1d();
        // if labels[i] >= 0:                                                                     <L 216>
        var_1 = wp::address(var_labels, var_0);
        var_4 = wp::load(var_1);
        var_3 = (var_4 >= var_2);
        if (var_3) {
            // labels[i] = renamed[labels[i]]                                                     <L 217>
            var_5 = wp::address(var_labels, var_0);
            var_6 = wp::load(var_5);
            var_7 = wp::address(var_renamed, var_6);
            var_9 = wp::load(var_7);
            var_8 = wp::copy(var_9);
            wp::array_store(var_labels, var_0, var_8);
        }
}



extern "C" __global__ void mark_first_kernel_2ab356e3_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_cores__owners,
    wp::array_t<wp::int32> var_firsts,
    wp::array_t<wp::uint8> var_marks)
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
        wp::uint8 var_5;
        wp::int32* var_6;
        wp::int32 var_7;
        //---------
        // forward
        // def mark_first_kernel(cores__owners, firsts, marks):                                   <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // if cores__owners[i] == i:                                                              <L 3>
        var_1 = wp::address(var_cores__owners, var_0);
        var_3 = wp::load(var_1);
        var_2 = (var_3 == var_0);
        if (var_2) {
            // marks[firsts[i]] = uint8(1)                                                        <L 4>
            var_5 = wp::uint8(var_4);
            var_6 = wp::address(var_firsts, var_0);
            var_7 = wp::load(var_6);
            wp::array_store(var_marks, var_7, var_5);
        }
}



extern "C" __global__ void rank_sizes_kernel_30a8b66e_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_counts,
    wp::int32 var_min_size,
    wp::int32 var_max_size,
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
        const wp::int32 var_1 = 2147483647;
        wp::int32 var_2;
        bool var_3;
        wp::int32* var_4;
        bool var_5;
        wp::int32 var_6;
        wp::int32* var_7;
        bool var_8;
        wp::int32 var_9;
        wp::int32* var_10;
        wp::int32 var_11;
        wp::int32 var_12;
        wp::int32 var_13;
        wp::int64 var_14;
        //---------
        // forward
        // def rank_sizes_kernel(counts: array(dtype=int32), min_size: int, max_size: int, keys: array(dtype=int64)):       <L 195>
        // i = tid()                                                                              <L 197>
        var_0 = builtin_tid1d();
        // key = int(NO_NUMBER)                                                                   <L 198>
        var_2 = wp::int(var_1);
        // if counts[i] >= min_size and counts[i] <= max_size:                                    <L 199>
        var_4 = wp::address(var_counts, var_0);
        var_6 = wp::load(var_4);
        var_5 = (var_6 >= var_min_size);
        var_3 = var_5;
        if (var_3) {
            var_7 = wp::address(var_counts, var_0);
            var_9 = wp::load(var_7);
            var_8 = (var_9 <= var_max_size);
            var_3 = var_3 && var_8;
        }
        if (var_3) {
            // key = NO_NUMBER - counts[i]                                                        <L 200>
            var_10 = wp::address(var_counts, var_0);
            var_12 = wp::load(var_10);
            var_11 = wp::sub(var_1, var_12);
        }
        var_13 = wp::where(var_3, var_11, var_2);
        // keys[i] = int64(key)                                                                   <L 201>
        var_14 = wp::int64(var_13);
        wp::array_store(var_keys, var_0, var_14);
}



extern "C" __global__ void label_cores_kernel_5e8bd7c0_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::int32 var_cores__tree__count,
    wp::array_t<wp::int32> var_cores__tree__order,
    wp::array_t<wp::int32> var_cores__owners,
    wp::array_t<wp::int32> var_cores__lowest,
    wp::array_t<wp::int32> var_firsts,
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
        const wp::int32 var_1 = 2147483647;
        wp::int32 var_2;
        const wp::int32 var_3 = 8;
        wp::int32 var_4;
        const wp::int32 var_5 = 1;
        wp::int32 var_6;
        wp::int32 var_7;
        wp::int32 var_8;
        wp::range_t var_9;
        wp::int32 var_10;
        wp::int32* var_11;
        wp::int32 var_12;
        wp::int32 var_13;
        const wp::int32 var_14 = 0;
        bool var_15;
        wp::int32* var_16;
        wp::int32 var_17;
        wp::int32 var_18;
        wp::int32* var_19;
        wp::int32 var_20;
        wp::int32 var_21;
        wp::int32* var_22;
        wp::int32 var_23;
        wp::int32 var_24;
        bool var_25;
        wp::int32 var_26;
        wp::int32 var_27;
        //---------
        // forward
        // def label_cores_kernel(cores__tree__count, cores__tree__order, cores__owners, cores__lowest, firsts, labels):       <L 1>
        // leaf = tid()                                                                           <L 3>
        var_0 = builtin_tid1d();
        // lowest_label = int(NO_NUMBER)                                                          <L 4>
        var_2 = wp::int(var_1);
        // for rank in range(leaf * LEAF, min((leaf + 1) * LEAF, cores__tree__count)):            <L 5>
        var_4 = wp::mul(var_0, var_3);
        var_6 = wp::add(var_0, var_5);
        var_7 = wp::mul(var_6, var_3);
        var_8 = wp::min(var_7, var_cores__tree__count);
        var_9 = wp::range(var_4, var_8);
        start_for_0:;
            if (iter_cmp(var_9) == 0) goto end_for_0;
            var_10 = wp::iter_next(var_9);
            // root = cores__owners[rank]                                                         <L 6>
            var_11 = wp::address(var_cores__owners, var_10);
            var_13 = wp::load(var_11);
            var_12 = wp::copy(var_13);
            // if root >= 0:                                                                      <L 7>
            var_15 = (var_12 >= var_14);
            if (var_15) {
                // first = firsts[root]                                                           <L 8>
                var_16 = wp::address(var_firsts, var_12);
                var_18 = wp::load(var_16);
                var_17 = wp::copy(var_18);
                // label = labels[first]                                                          <L 9>
                var_19 = wp::address(var_labels, var_17);
                var_21 = wp::load(var_19);
                var_20 = wp::copy(var_21);
                // row = cores__tree__order[rank]                                                 <L 10>
                var_22 = wp::address(var_cores__tree__order, var_10);
                var_24 = wp::load(var_22);
                var_23 = wp::copy(var_24);
                // if row != first:                                                               <L 11>
                var_25 = (var_23 != var_17);
                if (var_25) {
                    // labels[row] = label                                                        <L 12>
                    wp::array_store(var_labels, var_23, var_20);
                }
                // cores__owners[rank] = label                                                    <L 13>
                wp::array_store(var_cores__owners, var_10, var_20);
                // lowest_label = min(lowest_label, label)                                        <L 14>
                var_26 = wp::min(var_2, var_20);
            }
            var_27 = wp::where(var_15, var_26, var_2);
            wp::assign(var_2, var_27);
            goto start_for_0;
        end_for_0:;
        // cores__lowest[leaf] = lowest_label                                                     <L 15>
        wp::array_store(var_cores__lowest, var_0, var_2);
}



extern "C" __global__ void find_first_kernel_68b1ab83_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_cores__tree__order,
    wp::array_t<wp::int32> var_cores__owners,
    wp::array_t<wp::int32> var_firsts)
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
        const wp::int32 var_4 = 0;
        bool var_5;
        wp::int32* var_6;
        wp::int32 var_7;
        wp::int32 var_8;
        wp::int32* var_9;
        bool var_10;
        wp::int32 var_11;
        wp::int32 var_12;
        //---------
        // forward
        // def find_first_kernel(cores__tree__order, cores__owners, firsts):                      <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // root = cores__owners[i]                                                                <L 3>
        var_1 = wp::address(var_cores__owners, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // if root >= 0:                                                                          <L 4>
        var_5 = (var_2 >= var_4);
        if (var_5) {
            // row = cores__tree__order[i]                                                        <L 5>
            var_6 = wp::address(var_cores__tree__order, var_0);
            var_8 = wp::load(var_6);
            var_7 = wp::copy(var_8);
            // if row < firsts[root]:                                                             <L 6>
            var_9 = wp::address(var_firsts, var_2);
            var_11 = wp::load(var_9);
            var_10 = (var_7 < var_11);
            if (var_10) {
                // atomic_min(firsts, root, row)                                                  <L 7>
                var_12 = wp::atomic_min(var_firsts, var_2, var_7);
            }
        }
}



extern "C" __global__ void label_borders_kernel_7ad13983_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::int32 var_cores__tree__count,
    wp::int32 var_cores__tree__root,
    wp::array_t<wp::int32> var_cores__tree__levels,
    wp::array_t<wp::float32> var_cores__tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> var_cores__tree__points,
    wp::array_t<wp::int32> var_cores__tree__order,
    wp::float32 var_cores__max_sqdist,
    wp::array_t<wp::int32> var_cores__owners,
    wp::array_t<wp::int32> var_cores__lowest,
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
        const wp::int32 var_1 = 8;
        wp::int32 var_2;
        const wp::float32 var_3 = INFINITY;
        wp::vec_t<8, wp::float32> var_4;
        const wp::float32 var_5 = 0.0;
        wp::vec_t<8, wp::float32> var_6;
        const wp::float32 var_7 = 0.0;
        wp::vec_t<8, wp::float32> var_8;
        wp::vec_t<3, wp::float32> var_9;
        const wp::float32 var_10 = -INFINITY;
        const wp::float32 var_11 = -INFINITY;
        const wp::float32 var_12 = -INFINITY;
        wp::vec_t<3, wp::float32> var_13;
        const wp::int32 var_14 = -1;
        wp::vec_t<8, wp::int32> var_15;
        const wp::int32 var_16 = 0;
        wp::int32 var_17;
        const wp::int32 var_18 = 0;
        const wp::int32 var_19 = 8;
        wp::int32 var_20;
        wp::int32 var_21;
        bool var_22;
        wp::int32 var_23;
        wp::int32 var_24;
        wp::vec_t<3, wp::float32>* var_25;
        wp::vec_t<3, wp::float32> var_26;
        wp::vec_t<3, wp::float32> var_27;
        wp::int32 var_28;
        wp::int32* var_29;
        const wp::int32 var_30 = 0;
        bool var_31;
        wp::int32 var_32;
        const wp::int32 var_33 = 0;
        wp::float32 var_34;
        const wp::int32 var_35 = 1;
        wp::float32 var_36;
        const wp::int32 var_37 = 2;
        wp::float32 var_38;
        const wp::int32 var_39 = 0;
        wp::float32 var_40;
        const wp::int32 var_41 = 0;
        wp::float32 var_42;
        wp::float32 var_43;
        const wp::int32 var_44 = 1;
        wp::float32 var_45;
        const wp::int32 var_46 = 1;
        wp::float32 var_47;
        wp::float32 var_48;
        const wp::int32 var_49 = 2;
        wp::float32 var_50;
        const wp::int32 var_51 = 2;
        wp::float32 var_52;
        wp::float32 var_53;
        wp::vec_t<3, wp::float32> var_54;
        const wp::int32 var_55 = 0;
        wp::float32 var_56;
        const wp::int32 var_57 = 0;
        wp::float32 var_58;
        wp::float32 var_59;
        const wp::int32 var_60 = 1;
        wp::float32 var_61;
        const wp::int32 var_62 = 1;
        wp::float32 var_63;
        wp::float32 var_64;
        const wp::int32 var_65 = 2;
        wp::float32 var_66;
        const wp::int32 var_67 = 2;
        wp::float32 var_68;
        wp::float32 var_69;
        wp::vec_t<3, wp::float32> var_70;
        const wp::int32 var_71 = 2147483647;
        const wp::int32 var_72 = 1;
        wp::vec_t<3, wp::float32> var_73;
        wp::vec_t<3, wp::float32> var_74;
        wp::int32 var_75;
        wp::vec_t<3, wp::float32> var_76;
        wp::vec_t<3, wp::float32> var_77;
        wp::int32 var_78;
        const wp::int32 var_79 = 1;
        wp::int32 var_80;
        wp::int32 var_81;
        bool var_82;
        wp::int32 var_83;
        wp::int32 var_84;
        wp::vec_t<3, wp::float32>* var_85;
        wp::vec_t<3, wp::float32> var_86;
        wp::vec_t<3, wp::float32> var_87;
        wp::int32 var_88;
        wp::int32* var_89;
        const wp::int32 var_90 = 0;
        bool var_91;
        wp::int32 var_92;
        const wp::int32 var_93 = 0;
        wp::float32 var_94;
        const wp::int32 var_95 = 1;
        wp::float32 var_96;
        const wp::int32 var_97 = 2;
        wp::float32 var_98;
        const wp::int32 var_99 = 0;
        wp::float32 var_100;
        const wp::int32 var_101 = 0;
        wp::float32 var_102;
        wp::float32 var_103;
        const wp::int32 var_104 = 1;
        wp::float32 var_105;
        const wp::int32 var_106 = 1;
        wp::float32 var_107;
        wp::float32 var_108;
        const wp::int32 var_109 = 2;
        wp::float32 var_110;
        const wp::int32 var_111 = 2;
        wp::float32 var_112;
        wp::float32 var_113;
        wp::vec_t<3, wp::float32> var_114;
        const wp::int32 var_115 = 0;
        wp::float32 var_116;
        const wp::int32 var_117 = 0;
        wp::float32 var_118;
        wp::float32 var_119;
        const wp::int32 var_120 = 1;
        wp::float32 var_121;
        const wp::int32 var_122 = 1;
        wp::float32 var_123;
        wp::float32 var_124;
        const wp::int32 var_125 = 2;
        wp::float32 var_126;
        const wp::int32 var_127 = 2;
        wp::float32 var_128;
        wp::float32 var_129;
        wp::vec_t<3, wp::float32> var_130;
        const wp::int32 var_131 = 1;
        wp::vec_t<3, wp::float32> var_132;
        wp::vec_t<3, wp::float32> var_133;
        wp::int32 var_134;
        wp::vec_t<3, wp::float32> var_135;
        wp::vec_t<3, wp::float32> var_136;
        wp::int32 var_137;
        wp::vec_t<3, wp::float32> var_138;
        const wp::int32 var_139 = 2;
        wp::int32 var_140;
        wp::int32 var_141;
        bool var_142;
        wp::int32 var_143;
        wp::int32 var_144;
        wp::vec_t<3, wp::float32>* var_145;
        wp::vec_t<3, wp::float32> var_146;
        wp::vec_t<3, wp::float32> var_147;
        wp::int32 var_148;
        wp::int32* var_149;
        const wp::int32 var_150 = 0;
        bool var_151;
        wp::int32 var_152;
        const wp::int32 var_153 = 0;
        wp::float32 var_154;
        const wp::int32 var_155 = 1;
        wp::float32 var_156;
        const wp::int32 var_157 = 2;
        wp::float32 var_158;
        const wp::int32 var_159 = 0;
        wp::float32 var_160;
        const wp::int32 var_161 = 0;
        wp::float32 var_162;
        wp::float32 var_163;
        const wp::int32 var_164 = 1;
        wp::float32 var_165;
        const wp::int32 var_166 = 1;
        wp::float32 var_167;
        wp::float32 var_168;
        const wp::int32 var_169 = 2;
        wp::float32 var_170;
        const wp::int32 var_171 = 2;
        wp::float32 var_172;
        wp::float32 var_173;
        wp::vec_t<3, wp::float32> var_174;
        const wp::int32 var_175 = 0;
        wp::float32 var_176;
        const wp::int32 var_177 = 0;
        wp::float32 var_178;
        wp::float32 var_179;
        const wp::int32 var_180 = 1;
        wp::float32 var_181;
        const wp::int32 var_182 = 1;
        wp::float32 var_183;
        wp::float32 var_184;
        const wp::int32 var_185 = 2;
        wp::float32 var_186;
        const wp::int32 var_187 = 2;
        wp::float32 var_188;
        wp::float32 var_189;
        wp::vec_t<3, wp::float32> var_190;
        const wp::int32 var_191 = 1;
        wp::vec_t<3, wp::float32> var_192;
        wp::vec_t<3, wp::float32> var_193;
        wp::int32 var_194;
        wp::vec_t<3, wp::float32> var_195;
        wp::vec_t<3, wp::float32> var_196;
        wp::int32 var_197;
        wp::vec_t<3, wp::float32> var_198;
        const wp::int32 var_199 = 3;
        wp::int32 var_200;
        wp::int32 var_201;
        bool var_202;
        wp::int32 var_203;
        wp::int32 var_204;
        wp::vec_t<3, wp::float32>* var_205;
        wp::vec_t<3, wp::float32> var_206;
        wp::vec_t<3, wp::float32> var_207;
        wp::int32 var_208;
        wp::int32* var_209;
        const wp::int32 var_210 = 0;
        bool var_211;
        wp::int32 var_212;
        const wp::int32 var_213 = 0;
        wp::float32 var_214;
        const wp::int32 var_215 = 1;
        wp::float32 var_216;
        const wp::int32 var_217 = 2;
        wp::float32 var_218;
        const wp::int32 var_219 = 0;
        wp::float32 var_220;
        const wp::int32 var_221 = 0;
        wp::float32 var_222;
        wp::float32 var_223;
        const wp::int32 var_224 = 1;
        wp::float32 var_225;
        const wp::int32 var_226 = 1;
        wp::float32 var_227;
        wp::float32 var_228;
        const wp::int32 var_229 = 2;
        wp::float32 var_230;
        const wp::int32 var_231 = 2;
        wp::float32 var_232;
        wp::float32 var_233;
        wp::vec_t<3, wp::float32> var_234;
        const wp::int32 var_235 = 0;
        wp::float32 var_236;
        const wp::int32 var_237 = 0;
        wp::float32 var_238;
        wp::float32 var_239;
        const wp::int32 var_240 = 1;
        wp::float32 var_241;
        const wp::int32 var_242 = 1;
        wp::float32 var_243;
        wp::float32 var_244;
        const wp::int32 var_245 = 2;
        wp::float32 var_246;
        const wp::int32 var_247 = 2;
        wp::float32 var_248;
        wp::float32 var_249;
        wp::vec_t<3, wp::float32> var_250;
        const wp::int32 var_251 = 1;
        wp::vec_t<3, wp::float32> var_252;
        wp::vec_t<3, wp::float32> var_253;
        wp::int32 var_254;
        wp::vec_t<3, wp::float32> var_255;
        wp::vec_t<3, wp::float32> var_256;
        wp::int32 var_257;
        wp::vec_t<3, wp::float32> var_258;
        const wp::int32 var_259 = 4;
        wp::int32 var_260;
        wp::int32 var_261;
        bool var_262;
        wp::int32 var_263;
        wp::int32 var_264;
        wp::vec_t<3, wp::float32>* var_265;
        wp::vec_t<3, wp::float32> var_266;
        wp::vec_t<3, wp::float32> var_267;
        wp::int32 var_268;
        wp::int32* var_269;
        const wp::int32 var_270 = 0;
        bool var_271;
        wp::int32 var_272;
        const wp::int32 var_273 = 0;
        wp::float32 var_274;
        const wp::int32 var_275 = 1;
        wp::float32 var_276;
        const wp::int32 var_277 = 2;
        wp::float32 var_278;
        const wp::int32 var_279 = 0;
        wp::float32 var_280;
        const wp::int32 var_281 = 0;
        wp::float32 var_282;
        wp::float32 var_283;
        const wp::int32 var_284 = 1;
        wp::float32 var_285;
        const wp::int32 var_286 = 1;
        wp::float32 var_287;
        wp::float32 var_288;
        const wp::int32 var_289 = 2;
        wp::float32 var_290;
        const wp::int32 var_291 = 2;
        wp::float32 var_292;
        wp::float32 var_293;
        wp::vec_t<3, wp::float32> var_294;
        const wp::int32 var_295 = 0;
        wp::float32 var_296;
        const wp::int32 var_297 = 0;
        wp::float32 var_298;
        wp::float32 var_299;
        const wp::int32 var_300 = 1;
        wp::float32 var_301;
        const wp::int32 var_302 = 1;
        wp::float32 var_303;
        wp::float32 var_304;
        const wp::int32 var_305 = 2;
        wp::float32 var_306;
        const wp::int32 var_307 = 2;
        wp::float32 var_308;
        wp::float32 var_309;
        wp::vec_t<3, wp::float32> var_310;
        const wp::int32 var_311 = 1;
        wp::vec_t<3, wp::float32> var_312;
        wp::vec_t<3, wp::float32> var_313;
        wp::int32 var_314;
        wp::vec_t<3, wp::float32> var_315;
        wp::vec_t<3, wp::float32> var_316;
        wp::int32 var_317;
        wp::vec_t<3, wp::float32> var_318;
        const wp::int32 var_319 = 5;
        wp::int32 var_320;
        wp::int32 var_321;
        bool var_322;
        wp::int32 var_323;
        wp::int32 var_324;
        wp::vec_t<3, wp::float32>* var_325;
        wp::vec_t<3, wp::float32> var_326;
        wp::vec_t<3, wp::float32> var_327;
        wp::int32 var_328;
        wp::int32* var_329;
        const wp::int32 var_330 = 0;
        bool var_331;
        wp::int32 var_332;
        const wp::int32 var_333 = 0;
        wp::float32 var_334;
        const wp::int32 var_335 = 1;
        wp::float32 var_336;
        const wp::int32 var_337 = 2;
        wp::float32 var_338;
        const wp::int32 var_339 = 0;
        wp::float32 var_340;
        const wp::int32 var_341 = 0;
        wp::float32 var_342;
        wp::float32 var_343;
        const wp::int32 var_344 = 1;
        wp::float32 var_345;
        const wp::int32 var_346 = 1;
        wp::float32 var_347;
        wp::float32 var_348;
        const wp::int32 var_349 = 2;
        wp::float32 var_350;
        const wp::int32 var_351 = 2;
        wp::float32 var_352;
        wp::float32 var_353;
        wp::vec_t<3, wp::float32> var_354;
        const wp::int32 var_355 = 0;
        wp::float32 var_356;
        const wp::int32 var_357 = 0;
        wp::float32 var_358;
        wp::float32 var_359;
        const wp::int32 var_360 = 1;
        wp::float32 var_361;
        const wp::int32 var_362 = 1;
        wp::float32 var_363;
        wp::float32 var_364;
        const wp::int32 var_365 = 2;
        wp::float32 var_366;
        const wp::int32 var_367 = 2;
        wp::float32 var_368;
        wp::float32 var_369;
        wp::vec_t<3, wp::float32> var_370;
        const wp::int32 var_371 = 1;
        wp::vec_t<3, wp::float32> var_372;
        wp::vec_t<3, wp::float32> var_373;
        wp::int32 var_374;
        wp::vec_t<3, wp::float32> var_375;
        wp::vec_t<3, wp::float32> var_376;
        wp::int32 var_377;
        wp::vec_t<3, wp::float32> var_378;
        const wp::int32 var_379 = 6;
        wp::int32 var_380;
        wp::int32 var_381;
        bool var_382;
        wp::int32 var_383;
        wp::int32 var_384;
        wp::vec_t<3, wp::float32>* var_385;
        wp::vec_t<3, wp::float32> var_386;
        wp::vec_t<3, wp::float32> var_387;
        wp::int32 var_388;
        wp::int32* var_389;
        const wp::int32 var_390 = 0;
        bool var_391;
        wp::int32 var_392;
        const wp::int32 var_393 = 0;
        wp::float32 var_394;
        const wp::int32 var_395 = 1;
        wp::float32 var_396;
        const wp::int32 var_397 = 2;
        wp::float32 var_398;
        const wp::int32 var_399 = 0;
        wp::float32 var_400;
        const wp::int32 var_401 = 0;
        wp::float32 var_402;
        wp::float32 var_403;
        const wp::int32 var_404 = 1;
        wp::float32 var_405;
        const wp::int32 var_406 = 1;
        wp::float32 var_407;
        wp::float32 var_408;
        const wp::int32 var_409 = 2;
        wp::float32 var_410;
        const wp::int32 var_411 = 2;
        wp::float32 var_412;
        wp::float32 var_413;
        wp::vec_t<3, wp::float32> var_414;
        const wp::int32 var_415 = 0;
        wp::float32 var_416;
        const wp::int32 var_417 = 0;
        wp::float32 var_418;
        wp::float32 var_419;
        const wp::int32 var_420 = 1;
        wp::float32 var_421;
        const wp::int32 var_422 = 1;
        wp::float32 var_423;
        wp::float32 var_424;
        const wp::int32 var_425 = 2;
        wp::float32 var_426;
        const wp::int32 var_427 = 2;
        wp::float32 var_428;
        wp::float32 var_429;
        wp::vec_t<3, wp::float32> var_430;
        const wp::int32 var_431 = 1;
        wp::vec_t<3, wp::float32> var_432;
        wp::vec_t<3, wp::float32> var_433;
        wp::int32 var_434;
        wp::vec_t<3, wp::float32> var_435;
        wp::vec_t<3, wp::float32> var_436;
        wp::int32 var_437;
        wp::vec_t<3, wp::float32> var_438;
        const wp::int32 var_439 = 7;
        wp::int32 var_440;
        wp::int32 var_441;
        bool var_442;
        wp::int32 var_443;
        wp::int32 var_444;
        wp::vec_t<3, wp::float32>* var_445;
        wp::vec_t<3, wp::float32> var_446;
        wp::vec_t<3, wp::float32> var_447;
        wp::int32 var_448;
        wp::int32* var_449;
        const wp::int32 var_450 = 0;
        bool var_451;
        wp::int32 var_452;
        const wp::int32 var_453 = 0;
        wp::float32 var_454;
        const wp::int32 var_455 = 1;
        wp::float32 var_456;
        const wp::int32 var_457 = 2;
        wp::float32 var_458;
        const wp::int32 var_459 = 0;
        wp::float32 var_460;
        const wp::int32 var_461 = 0;
        wp::float32 var_462;
        wp::float32 var_463;
        const wp::int32 var_464 = 1;
        wp::float32 var_465;
        const wp::int32 var_466 = 1;
        wp::float32 var_467;
        wp::float32 var_468;
        const wp::int32 var_469 = 2;
        wp::float32 var_470;
        const wp::int32 var_471 = 2;
        wp::float32 var_472;
        wp::float32 var_473;
        wp::vec_t<3, wp::float32> var_474;
        const wp::int32 var_475 = 0;
        wp::float32 var_476;
        const wp::int32 var_477 = 0;
        wp::float32 var_478;
        wp::float32 var_479;
        const wp::int32 var_480 = 1;
        wp::float32 var_481;
        const wp::int32 var_482 = 1;
        wp::float32 var_483;
        wp::float32 var_484;
        const wp::int32 var_485 = 2;
        wp::float32 var_486;
        const wp::int32 var_487 = 2;
        wp::float32 var_488;
        wp::float32 var_489;
        wp::vec_t<3, wp::float32> var_490;
        const wp::int32 var_491 = 1;
        wp::vec_t<3, wp::float32> var_492;
        wp::vec_t<3, wp::float32> var_493;
        wp::int32 var_494;
        wp::vec_t<3, wp::float32> var_495;
        wp::vec_t<3, wp::float32> var_496;
        wp::int32 var_497;
        wp::vec_t<3, wp::float32> var_498;
        const wp::int32 var_499 = 1;
        bool var_500;
        wp::vec_t<8, wp::int32> var_501;
        const wp::int32 var_502 = 0;
        bool var_503;
        wp::int32 var_504;
        const wp::int32 var_505 = 0;
        bool var_506;
        wp::int32 var_507;
        bool var_508;
        wp::int32 var_509;
        wp::int32 var_510;
        wp::int32* var_511;
        wp::int32 var_512;
        const wp::int32 var_513 = 1;
        bool var_514;
        wp::int32 var_515;
        const wp::int32 var_516 = 0;
        bool var_517;
        wp::int32 var_518;
        bool var_519;
        wp::int32 var_520;
        wp::int32 var_521;
        wp::int32* var_522;
        wp::int32 var_523;
        const wp::int32 var_524 = 2;
        bool var_525;
        wp::int32 var_526;
        const wp::int32 var_527 = 0;
        bool var_528;
        wp::int32 var_529;
        bool var_530;
        wp::int32 var_531;
        wp::int32 var_532;
        wp::int32* var_533;
        wp::int32 var_534;
        const wp::int32 var_535 = 3;
        bool var_536;
        wp::int32 var_537;
        const wp::int32 var_538 = 0;
        bool var_539;
        wp::int32 var_540;
        bool var_541;
        wp::int32 var_542;
        wp::int32 var_543;
        wp::int32* var_544;
        wp::int32 var_545;
        const wp::int32 var_546 = 4;
        bool var_547;
        wp::int32 var_548;
        const wp::int32 var_549 = 0;
        bool var_550;
        wp::int32 var_551;
        bool var_552;
        wp::int32 var_553;
        wp::int32 var_554;
        wp::int32* var_555;
        wp::int32 var_556;
        const wp::int32 var_557 = 5;
        bool var_558;
        wp::int32 var_559;
        const wp::int32 var_560 = 0;
        bool var_561;
        wp::int32 var_562;
        bool var_563;
        wp::int32 var_564;
        wp::int32 var_565;
        wp::int32* var_566;
        wp::int32 var_567;
        const wp::int32 var_568 = 6;
        bool var_569;
        wp::int32 var_570;
        const wp::int32 var_571 = 0;
        bool var_572;
        wp::int32 var_573;
        bool var_574;
        wp::int32 var_575;
        wp::int32 var_576;
        wp::int32* var_577;
        wp::int32 var_578;
        const wp::int32 var_579 = 7;
        bool var_580;
        wp::int32 var_581;
        const wp::int32 var_582 = 0;
        bool var_583;
        wp::int32 var_584;
        bool var_585;
        wp::int32 var_586;
        wp::int32 var_587;
        wp::int32* var_588;
        wp::int32 var_589;
        wp::vec_t<8, wp::int32> var_590;
        wp::int32 var_591;
        //---------
        // forward
        // def label_borders_kernel(cores__tree__count, cores__tree__root, cores__tree__levels, cores__tree__boxes, cores__tree__points, cores__tree__order, cores__max_sqdist, cores__owners, cores__lowest, labels):       <L 1>
        // leaf = tid()                                                                           <L 2>
        var_0 = builtin_tid1d();
        // head = leaf * LEAF                                                                     <L 3>
        var_2 = wp::mul(var_0, var_1);
        // xs = lanes(INFINITY)                                                                   <L 4>
        var_4 = wp::vec_t<8, wp::float32>(var_3);
        // ys = lanes(0.0)                                                                        <L 5>
        var_6 = wp::vec_t<8, wp::float32>(var_5);
        // zs = lanes(0.0)                                                                        <L 6>
        var_8 = wp::vec_t<8, wp::float32>(var_7);
        // a = vec3(INFINITY, INFINITY, INFINITY)                                                 <L 7>
        var_9 = wp::vec_t<3, wp::float32>(var_3, var_3, var_3);
        // b = vec3(-INFINITY, -INFINITY, -INFINITY)                                              <L 8>
        var_13 = wp::vec_t<3, wp::float32>(var_10, var_11, var_12);
        // best = numbers(NOISE)                                                                  <L 9>
        var_15 = wp::vec_t<8, wp::int32>(var_14);
        // searching = int(0)                                                                     <L 10>
        var_17 = wp::int(var_16);
        // for j in range(LEAF__points_of):                                                       <L 11>
        // if leaf * LEAF__points_of + j < cores__tree__count:                                    <L 12>
        var_20 = wp::mul(var_0, var_19);
        var_21 = wp::add(var_20, var_18);
        var_22 = (var_21 < var_cores__tree__count);
        if (var_22) {
            // p = cores__tree__points[leaf * LEAF__points_of + j]                                <L 13>
            var_23 = wp::mul(var_0, var_19);
            var_24 = wp::add(var_23, var_18);
            var_25 = wp::address(var_cores__tree__points, var_24);
            var_27 = wp::load(var_25);
            var_26 = wp::copy(var_27);
            // if cores__owners[head + j] < 0:                                                    <L 14>
            var_28 = wp::add(var_2, var_18);
            var_29 = wp::address(var_cores__owners, var_28);
            var_32 = wp::load(var_29);
            var_31 = (var_32 < var_30);
            if (var_31) {
                // xs[j] = p[0]                                                                   <L 15>
                var_34 = wp::extract(var_26, var_33);
                wp::assign_inplace(var_4, var_18, var_34);
                // ys[j] = p[1]                                                                   <L 16>
                var_36 = wp::extract(var_26, var_35);
                wp::assign_inplace(var_6, var_18, var_36);
                // zs[j] = p[2]                                                                   <L 17>
                var_38 = wp::extract(var_26, var_37);
                wp::assign_inplace(var_8, var_18, var_38);
                // a = vec3(min(a[0], p[0]), min(a[1], p[1]), min(a[2], p[2]))                    <L 18>
                var_40 = wp::extract(var_9, var_39);
                var_42 = wp::extract(var_26, var_41);
                var_43 = wp::min(var_40, var_42);
                var_45 = wp::extract(var_9, var_44);
                var_47 = wp::extract(var_26, var_46);
                var_48 = wp::min(var_45, var_47);
                var_50 = wp::extract(var_9, var_49);
                var_52 = wp::extract(var_26, var_51);
                var_53 = wp::min(var_50, var_52);
                var_54 = wp::vec_t<3, wp::float32>(var_43, var_48, var_53);
                // b = vec3(max(b[0], p[0]), max(b[1], p[1]), max(b[2], p[2]))                    <L 19>
                var_56 = wp::extract(var_13, var_55);
                var_58 = wp::extract(var_26, var_57);
                var_59 = wp::max(var_56, var_58);
                var_61 = wp::extract(var_13, var_60);
                var_63 = wp::extract(var_26, var_62);
                var_64 = wp::max(var_61, var_63);
                var_66 = wp::extract(var_13, var_65);
                var_68 = wp::extract(var_26, var_67);
                var_69 = wp::max(var_66, var_68);
                var_70 = wp::vec_t<3, wp::float32>(var_59, var_64, var_69);
                // best[j] = NO_NUMBER                                                            <L 20>
                wp::assign_inplace(var_15, var_18, var_71);
                // searching = 1                                                                  <L 21>
            }
            var_73 = wp::where(var_31, var_54, var_9);
            var_74 = wp::where(var_31, var_70, var_13);
            var_75 = wp::where(var_31, var_72, var_17);
        }
        var_76 = wp::where(var_22, var_73, var_9);
        var_77 = wp::where(var_22, var_74, var_13);
        var_78 = wp::where(var_22, var_75, var_17);
        // if leaf * LEAF__points_of + j < cores__tree__count:                                    <L 12>
        var_80 = wp::mul(var_0, var_19);
        var_81 = wp::add(var_80, var_79);
        var_82 = (var_81 < var_cores__tree__count);
        if (var_82) {
            // p = cores__tree__points[leaf * LEAF__points_of + j]                                <L 13>
            var_83 = wp::mul(var_0, var_19);
            var_84 = wp::add(var_83, var_79);
            var_85 = wp::address(var_cores__tree__points, var_84);
            var_87 = wp::load(var_85);
            var_86 = wp::copy(var_87);
            // if cores__owners[head + j] < 0:                                                    <L 14>
            var_88 = wp::add(var_2, var_79);
            var_89 = wp::address(var_cores__owners, var_88);
            var_92 = wp::load(var_89);
            var_91 = (var_92 < var_90);
            if (var_91) {
                // xs[j] = p[0]                                                                   <L 15>
                var_94 = wp::extract(var_86, var_93);
                wp::assign_inplace(var_4, var_79, var_94);
                // ys[j] = p[1]                                                                   <L 16>
                var_96 = wp::extract(var_86, var_95);
                wp::assign_inplace(var_6, var_79, var_96);
                // zs[j] = p[2]                                                                   <L 17>
                var_98 = wp::extract(var_86, var_97);
                wp::assign_inplace(var_8, var_79, var_98);
                // a = vec3(min(a[0], p[0]), min(a[1], p[1]), min(a[2], p[2]))                    <L 18>
                var_100 = wp::extract(var_76, var_99);
                var_102 = wp::extract(var_86, var_101);
                var_103 = wp::min(var_100, var_102);
                var_105 = wp::extract(var_76, var_104);
                var_107 = wp::extract(var_86, var_106);
                var_108 = wp::min(var_105, var_107);
                var_110 = wp::extract(var_76, var_109);
                var_112 = wp::extract(var_86, var_111);
                var_113 = wp::min(var_110, var_112);
                var_114 = wp::vec_t<3, wp::float32>(var_103, var_108, var_113);
                // b = vec3(max(b[0], p[0]), max(b[1], p[1]), max(b[2], p[2]))                    <L 19>
                var_116 = wp::extract(var_77, var_115);
                var_118 = wp::extract(var_86, var_117);
                var_119 = wp::max(var_116, var_118);
                var_121 = wp::extract(var_77, var_120);
                var_123 = wp::extract(var_86, var_122);
                var_124 = wp::max(var_121, var_123);
                var_126 = wp::extract(var_77, var_125);
                var_128 = wp::extract(var_86, var_127);
                var_129 = wp::max(var_126, var_128);
                var_130 = wp::vec_t<3, wp::float32>(var_119, var_124, var_129);
                // best[j] = NO_NUMBER                                                            <L 20>
                wp::assign_inplace(var_15, var_79, var_71);
                // searching = 1                                                                  <L 21>
            }
            var_132 = wp::where(var_91, var_114, var_76);
            var_133 = wp::where(var_91, var_130, var_77);
            var_134 = wp::where(var_91, var_131, var_78);
        }
        var_135 = wp::where(var_82, var_132, var_76);
        var_136 = wp::where(var_82, var_133, var_77);
        var_137 = wp::where(var_82, var_134, var_78);
        var_138 = wp::where(var_82, var_86, var_26);
        // if leaf * LEAF__points_of + j < cores__tree__count:                                    <L 12>
        var_140 = wp::mul(var_0, var_19);
        var_141 = wp::add(var_140, var_139);
        var_142 = (var_141 < var_cores__tree__count);
        if (var_142) {
            // p = cores__tree__points[leaf * LEAF__points_of + j]                                <L 13>
            var_143 = wp::mul(var_0, var_19);
            var_144 = wp::add(var_143, var_139);
            var_145 = wp::address(var_cores__tree__points, var_144);
            var_147 = wp::load(var_145);
            var_146 = wp::copy(var_147);
            // if cores__owners[head + j] < 0:                                                    <L 14>
            var_148 = wp::add(var_2, var_139);
            var_149 = wp::address(var_cores__owners, var_148);
            var_152 = wp::load(var_149);
            var_151 = (var_152 < var_150);
            if (var_151) {
                // xs[j] = p[0]                                                                   <L 15>
                var_154 = wp::extract(var_146, var_153);
                wp::assign_inplace(var_4, var_139, var_154);
                // ys[j] = p[1]                                                                   <L 16>
                var_156 = wp::extract(var_146, var_155);
                wp::assign_inplace(var_6, var_139, var_156);
                // zs[j] = p[2]                                                                   <L 17>
                var_158 = wp::extract(var_146, var_157);
                wp::assign_inplace(var_8, var_139, var_158);
                // a = vec3(min(a[0], p[0]), min(a[1], p[1]), min(a[2], p[2]))                    <L 18>
                var_160 = wp::extract(var_135, var_159);
                var_162 = wp::extract(var_146, var_161);
                var_163 = wp::min(var_160, var_162);
                var_165 = wp::extract(var_135, var_164);
                var_167 = wp::extract(var_146, var_166);
                var_168 = wp::min(var_165, var_167);
                var_170 = wp::extract(var_135, var_169);
                var_172 = wp::extract(var_146, var_171);
                var_173 = wp::min(var_170, var_172);
                var_174 = wp::vec_t<3, wp::float32>(var_163, var_168, var_173);
                // b = vec3(max(b[0], p[0]), max(b[1], p[1]), max(b[2], p[2]))                    <L 19>
                var_176 = wp::extract(var_136, var_175);
                var_178 = wp::extract(var_146, var_177);
                var_179 = wp::max(var_176, var_178);
                var_181 = wp::extract(var_136, var_180);
                var_183 = wp::extract(var_146, var_182);
                var_184 = wp::max(var_181, var_183);
                var_186 = wp::extract(var_136, var_185);
                var_188 = wp::extract(var_146, var_187);
                var_189 = wp::max(var_186, var_188);
                var_190 = wp::vec_t<3, wp::float32>(var_179, var_184, var_189);
                // best[j] = NO_NUMBER                                                            <L 20>
                wp::assign_inplace(var_15, var_139, var_71);
                // searching = 1                                                                  <L 21>
            }
            var_192 = wp::where(var_151, var_174, var_135);
            var_193 = wp::where(var_151, var_190, var_136);
            var_194 = wp::where(var_151, var_191, var_137);
        }
        var_195 = wp::where(var_142, var_192, var_135);
        var_196 = wp::where(var_142, var_193, var_136);
        var_197 = wp::where(var_142, var_194, var_137);
        var_198 = wp::where(var_142, var_146, var_138);
        // if leaf * LEAF__points_of + j < cores__tree__count:                                    <L 12>
        var_200 = wp::mul(var_0, var_19);
        var_201 = wp::add(var_200, var_199);
        var_202 = (var_201 < var_cores__tree__count);
        if (var_202) {
            // p = cores__tree__points[leaf * LEAF__points_of + j]                                <L 13>
            var_203 = wp::mul(var_0, var_19);
            var_204 = wp::add(var_203, var_199);
            var_205 = wp::address(var_cores__tree__points, var_204);
            var_207 = wp::load(var_205);
            var_206 = wp::copy(var_207);
            // if cores__owners[head + j] < 0:                                                    <L 14>
            var_208 = wp::add(var_2, var_199);
            var_209 = wp::address(var_cores__owners, var_208);
            var_212 = wp::load(var_209);
            var_211 = (var_212 < var_210);
            if (var_211) {
                // xs[j] = p[0]                                                                   <L 15>
                var_214 = wp::extract(var_206, var_213);
                wp::assign_inplace(var_4, var_199, var_214);
                // ys[j] = p[1]                                                                   <L 16>
                var_216 = wp::extract(var_206, var_215);
                wp::assign_inplace(var_6, var_199, var_216);
                // zs[j] = p[2]                                                                   <L 17>
                var_218 = wp::extract(var_206, var_217);
                wp::assign_inplace(var_8, var_199, var_218);
                // a = vec3(min(a[0], p[0]), min(a[1], p[1]), min(a[2], p[2]))                    <L 18>
                var_220 = wp::extract(var_195, var_219);
                var_222 = wp::extract(var_206, var_221);
                var_223 = wp::min(var_220, var_222);
                var_225 = wp::extract(var_195, var_224);
                var_227 = wp::extract(var_206, var_226);
                var_228 = wp::min(var_225, var_227);
                var_230 = wp::extract(var_195, var_229);
                var_232 = wp::extract(var_206, var_231);
                var_233 = wp::min(var_230, var_232);
                var_234 = wp::vec_t<3, wp::float32>(var_223, var_228, var_233);
                // b = vec3(max(b[0], p[0]), max(b[1], p[1]), max(b[2], p[2]))                    <L 19>
                var_236 = wp::extract(var_196, var_235);
                var_238 = wp::extract(var_206, var_237);
                var_239 = wp::max(var_236, var_238);
                var_241 = wp::extract(var_196, var_240);
                var_243 = wp::extract(var_206, var_242);
                var_244 = wp::max(var_241, var_243);
                var_246 = wp::extract(var_196, var_245);
                var_248 = wp::extract(var_206, var_247);
                var_249 = wp::max(var_246, var_248);
                var_250 = wp::vec_t<3, wp::float32>(var_239, var_244, var_249);
                // best[j] = NO_NUMBER                                                            <L 20>
                wp::assign_inplace(var_15, var_199, var_71);
                // searching = 1                                                                  <L 21>
            }
            var_252 = wp::where(var_211, var_234, var_195);
            var_253 = wp::where(var_211, var_250, var_196);
            var_254 = wp::where(var_211, var_251, var_197);
        }
        var_255 = wp::where(var_202, var_252, var_195);
        var_256 = wp::where(var_202, var_253, var_196);
        var_257 = wp::where(var_202, var_254, var_197);
        var_258 = wp::where(var_202, var_206, var_198);
        // if leaf * LEAF__points_of + j < cores__tree__count:                                    <L 12>
        var_260 = wp::mul(var_0, var_19);
        var_261 = wp::add(var_260, var_259);
        var_262 = (var_261 < var_cores__tree__count);
        if (var_262) {
            // p = cores__tree__points[leaf * LEAF__points_of + j]                                <L 13>
            var_263 = wp::mul(var_0, var_19);
            var_264 = wp::add(var_263, var_259);
            var_265 = wp::address(var_cores__tree__points, var_264);
            var_267 = wp::load(var_265);
            var_266 = wp::copy(var_267);
            // if cores__owners[head + j] < 0:                                                    <L 14>
            var_268 = wp::add(var_2, var_259);
            var_269 = wp::address(var_cores__owners, var_268);
            var_272 = wp::load(var_269);
            var_271 = (var_272 < var_270);
            if (var_271) {
                // xs[j] = p[0]                                                                   <L 15>
                var_274 = wp::extract(var_266, var_273);
                wp::assign_inplace(var_4, var_259, var_274);
                // ys[j] = p[1]                                                                   <L 16>
                var_276 = wp::extract(var_266, var_275);
                wp::assign_inplace(var_6, var_259, var_276);
                // zs[j] = p[2]                                                                   <L 17>
                var_278 = wp::extract(var_266, var_277);
                wp::assign_inplace(var_8, var_259, var_278);
                // a = vec3(min(a[0], p[0]), min(a[1], p[1]), min(a[2], p[2]))                    <L 18>
                var_280 = wp::extract(var_255, var_279);
                var_282 = wp::extract(var_266, var_281);
                var_283 = wp::min(var_280, var_282);
                var_285 = wp::extract(var_255, var_284);
                var_287 = wp::extract(var_266, var_286);
                var_288 = wp::min(var_285, var_287);
                var_290 = wp::extract(var_255, var_289);
                var_292 = wp::extract(var_266, var_291);
                var_293 = wp::min(var_290, var_292);
                var_294 = wp::vec_t<3, wp::float32>(var_283, var_288, var_293);
                // b = vec3(max(b[0], p[0]), max(b[1], p[1]), max(b[2], p[2]))                    <L 19>
                var_296 = wp::extract(var_256, var_295);
                var_298 = wp::extract(var_266, var_297);
                var_299 = wp::max(var_296, var_298);
                var_301 = wp::extract(var_256, var_300);
                var_303 = wp::extract(var_266, var_302);
                var_304 = wp::max(var_301, var_303);
                var_306 = wp::extract(var_256, var_305);
                var_308 = wp::extract(var_266, var_307);
                var_309 = wp::max(var_306, var_308);
                var_310 = wp::vec_t<3, wp::float32>(var_299, var_304, var_309);
                // best[j] = NO_NUMBER                                                            <L 20>
                wp::assign_inplace(var_15, var_259, var_71);
                // searching = 1                                                                  <L 21>
            }
            var_312 = wp::where(var_271, var_294, var_255);
            var_313 = wp::where(var_271, var_310, var_256);
            var_314 = wp::where(var_271, var_311, var_257);
        }
        var_315 = wp::where(var_262, var_312, var_255);
        var_316 = wp::where(var_262, var_313, var_256);
        var_317 = wp::where(var_262, var_314, var_257);
        var_318 = wp::where(var_262, var_266, var_258);
        // if leaf * LEAF__points_of + j < cores__tree__count:                                    <L 12>
        var_320 = wp::mul(var_0, var_19);
        var_321 = wp::add(var_320, var_319);
        var_322 = (var_321 < var_cores__tree__count);
        if (var_322) {
            // p = cores__tree__points[leaf * LEAF__points_of + j]                                <L 13>
            var_323 = wp::mul(var_0, var_19);
            var_324 = wp::add(var_323, var_319);
            var_325 = wp::address(var_cores__tree__points, var_324);
            var_327 = wp::load(var_325);
            var_326 = wp::copy(var_327);
            // if cores__owners[head + j] < 0:                                                    <L 14>
            var_328 = wp::add(var_2, var_319);
            var_329 = wp::address(var_cores__owners, var_328);
            var_332 = wp::load(var_329);
            var_331 = (var_332 < var_330);
            if (var_331) {
                // xs[j] = p[0]                                                                   <L 15>
                var_334 = wp::extract(var_326, var_333);
                wp::assign_inplace(var_4, var_319, var_334);
                // ys[j] = p[1]                                                                   <L 16>
                var_336 = wp::extract(var_326, var_335);
                wp::assign_inplace(var_6, var_319, var_336);
                // zs[j] = p[2]                                                                   <L 17>
                var_338 = wp::extract(var_326, var_337);
                wp::assign_inplace(var_8, var_319, var_338);
                // a = vec3(min(a[0], p[0]), min(a[1], p[1]), min(a[2], p[2]))                    <L 18>
                var_340 = wp::extract(var_315, var_339);
                var_342 = wp::extract(var_326, var_341);
                var_343 = wp::min(var_340, var_342);
                var_345 = wp::extract(var_315, var_344);
                var_347 = wp::extract(var_326, var_346);
                var_348 = wp::min(var_345, var_347);
                var_350 = wp::extract(var_315, var_349);
                var_352 = wp::extract(var_326, var_351);
                var_353 = wp::min(var_350, var_352);
                var_354 = wp::vec_t<3, wp::float32>(var_343, var_348, var_353);
                // b = vec3(max(b[0], p[0]), max(b[1], p[1]), max(b[2], p[2]))                    <L 19>
                var_356 = wp::extract(var_316, var_355);
                var_358 = wp::extract(var_326, var_357);
                var_359 = wp::max(var_356, var_358);
                var_361 = wp::extract(var_316, var_360);
                var_363 = wp::extract(var_326, var_362);
                var_364 = wp::max(var_361, var_363);
                var_366 = wp::extract(var_316, var_365);
                var_368 = wp::extract(var_326, var_367);
                var_369 = wp::max(var_366, var_368);
                var_370 = wp::vec_t<3, wp::float32>(var_359, var_364, var_369);
                // best[j] = NO_NUMBER                                                            <L 20>
                wp::assign_inplace(var_15, var_319, var_71);
                // searching = 1                                                                  <L 21>
            }
            var_372 = wp::where(var_331, var_354, var_315);
            var_373 = wp::where(var_331, var_370, var_316);
            var_374 = wp::where(var_331, var_371, var_317);
        }
        var_375 = wp::where(var_322, var_372, var_315);
        var_376 = wp::where(var_322, var_373, var_316);
        var_377 = wp::where(var_322, var_374, var_317);
        var_378 = wp::where(var_322, var_326, var_318);
        // if leaf * LEAF__points_of + j < cores__tree__count:                                    <L 12>
        var_380 = wp::mul(var_0, var_19);
        var_381 = wp::add(var_380, var_379);
        var_382 = (var_381 < var_cores__tree__count);
        if (var_382) {
            // p = cores__tree__points[leaf * LEAF__points_of + j]                                <L 13>
            var_383 = wp::mul(var_0, var_19);
            var_384 = wp::add(var_383, var_379);
            var_385 = wp::address(var_cores__tree__points, var_384);
            var_387 = wp::load(var_385);
            var_386 = wp::copy(var_387);
            // if cores__owners[head + j] < 0:                                                    <L 14>
            var_388 = wp::add(var_2, var_379);
            var_389 = wp::address(var_cores__owners, var_388);
            var_392 = wp::load(var_389);
            var_391 = (var_392 < var_390);
            if (var_391) {
                // xs[j] = p[0]                                                                   <L 15>
                var_394 = wp::extract(var_386, var_393);
                wp::assign_inplace(var_4, var_379, var_394);
                // ys[j] = p[1]                                                                   <L 16>
                var_396 = wp::extract(var_386, var_395);
                wp::assign_inplace(var_6, var_379, var_396);
                // zs[j] = p[2]                                                                   <L 17>
                var_398 = wp::extract(var_386, var_397);
                wp::assign_inplace(var_8, var_379, var_398);
                // a = vec3(min(a[0], p[0]), min(a[1], p[1]), min(a[2], p[2]))                    <L 18>
                var_400 = wp::extract(var_375, var_399);
                var_402 = wp::extract(var_386, var_401);
                var_403 = wp::min(var_400, var_402);
                var_405 = wp::extract(var_375, var_404);
                var_407 = wp::extract(var_386, var_406);
                var_408 = wp::min(var_405, var_407);
                var_410 = wp::extract(var_375, var_409);
                var_412 = wp::extract(var_386, var_411);
                var_413 = wp::min(var_410, var_412);
                var_414 = wp::vec_t<3, wp::float32>(var_403, var_408, var_413);
                // b = vec3(max(b[0], p[0]), max(b[1], p[1]), max(b[2], p[2]))                    <L 19>
                var_416 = wp::extract(var_376, var_415);
                var_418 = wp::extract(var_386, var_417);
                var_419 = wp::max(var_416, var_418);
                var_421 = wp::extract(var_376, var_420);
                var_423 = wp::extract(var_386, var_422);
                var_424 = wp::max(var_421, var_423);
                var_426 = wp::extract(var_376, var_425);
                var_428 = wp::extract(var_386, var_427);
                var_429 = wp::max(var_426, var_428);
                var_430 = wp::vec_t<3, wp::float32>(var_419, var_424, var_429);
                // best[j] = NO_NUMBER                                                            <L 20>
                wp::assign_inplace(var_15, var_379, var_71);
                // searching = 1                                                                  <L 21>
            }
            var_432 = wp::where(var_391, var_414, var_375);
            var_433 = wp::where(var_391, var_430, var_376);
            var_434 = wp::where(var_391, var_431, var_377);
        }
        var_435 = wp::where(var_382, var_432, var_375);
        var_436 = wp::where(var_382, var_433, var_376);
        var_437 = wp::where(var_382, var_434, var_377);
        var_438 = wp::where(var_382, var_386, var_378);
        // if leaf * LEAF__points_of + j < cores__tree__count:                                    <L 12>
        var_440 = wp::mul(var_0, var_19);
        var_441 = wp::add(var_440, var_439);
        var_442 = (var_441 < var_cores__tree__count);
        if (var_442) {
            // p = cores__tree__points[leaf * LEAF__points_of + j]                                <L 13>
            var_443 = wp::mul(var_0, var_19);
            var_444 = wp::add(var_443, var_439);
            var_445 = wp::address(var_cores__tree__points, var_444);
            var_447 = wp::load(var_445);
            var_446 = wp::copy(var_447);
            // if cores__owners[head + j] < 0:                                                    <L 14>
            var_448 = wp::add(var_2, var_439);
            var_449 = wp::address(var_cores__owners, var_448);
            var_452 = wp::load(var_449);
            var_451 = (var_452 < var_450);
            if (var_451) {
                // xs[j] = p[0]                                                                   <L 15>
                var_454 = wp::extract(var_446, var_453);
                wp::assign_inplace(var_4, var_439, var_454);
                // ys[j] = p[1]                                                                   <L 16>
                var_456 = wp::extract(var_446, var_455);
                wp::assign_inplace(var_6, var_439, var_456);
                // zs[j] = p[2]                                                                   <L 17>
                var_458 = wp::extract(var_446, var_457);
                wp::assign_inplace(var_8, var_439, var_458);
                // a = vec3(min(a[0], p[0]), min(a[1], p[1]), min(a[2], p[2]))                    <L 18>
                var_460 = wp::extract(var_435, var_459);
                var_462 = wp::extract(var_446, var_461);
                var_463 = wp::min(var_460, var_462);
                var_465 = wp::extract(var_435, var_464);
                var_467 = wp::extract(var_446, var_466);
                var_468 = wp::min(var_465, var_467);
                var_470 = wp::extract(var_435, var_469);
                var_472 = wp::extract(var_446, var_471);
                var_473 = wp::min(var_470, var_472);
                var_474 = wp::vec_t<3, wp::float32>(var_463, var_468, var_473);
                // b = vec3(max(b[0], p[0]), max(b[1], p[1]), max(b[2], p[2]))                    <L 19>
                var_476 = wp::extract(var_436, var_475);
                var_478 = wp::extract(var_446, var_477);
                var_479 = wp::max(var_476, var_478);
                var_481 = wp::extract(var_436, var_480);
                var_483 = wp::extract(var_446, var_482);
                var_484 = wp::max(var_481, var_483);
                var_486 = wp::extract(var_436, var_485);
                var_488 = wp::extract(var_446, var_487);
                var_489 = wp::max(var_486, var_488);
                var_490 = wp::vec_t<3, wp::float32>(var_479, var_484, var_489);
                // best[j] = NO_NUMBER                                                            <L 20>
                wp::assign_inplace(var_15, var_439, var_71);
                // searching = 1                                                                  <L 21>
            }
            var_492 = wp::where(var_451, var_474, var_435);
            var_493 = wp::where(var_451, var_490, var_436);
            var_494 = wp::where(var_451, var_491, var_437);
        }
        var_495 = wp::where(var_442, var_492, var_435);
        var_496 = wp::where(var_442, var_493, var_436);
        var_497 = wp::where(var_442, var_494, var_437);
        var_498 = wp::where(var_442, var_446, var_438);
        // if searching == 1:                                                                     <L 22>
        var_500 = (var_497 == var_499);
        if (var_500) {
            // best = follow_cores(best, xs, ys, zs, a, b, leaf, cores__tree__count, cores__tree__root, cores__tree__levels, cores__tree__boxes, cores__tree__points, cores__max_sqdist, cores__owners, cores__lowest)       <L 23>
            var_501 = follow_cores_0(var_15, var_4, var_6, var_8, var_495, var_496, var_0, var_cores__tree__count, var_cores__tree__root, var_cores__tree__levels, var_cores__tree__boxes, var_cores__tree__points, var_cores__max_sqdist, var_cores__owners, var_cores__lowest);
            // for j in range(LEAF):                                                              <L 24>
            // if best[j] >= 0 and best[j] < NO_NUMBER:                                           <L 25>
            var_504 = wp::extract(var_501, var_502);
            var_506 = (var_504 >= var_505);
            var_503 = var_506;
            if (var_503) {
                var_507 = wp::extract(var_501, var_502);
                var_508 = (var_507 < var_71);
                var_503 = var_503 && var_508;
            }
            if (var_503) {
                // labels[cores__tree__order[head + j]] = best[j]                                 <L 26>
                var_509 = wp::extract(var_501, var_502);
                var_510 = wp::add(var_2, var_502);
                var_511 = wp::address(var_cores__tree__order, var_510);
                var_512 = wp::load(var_511);
                wp::array_store(var_labels, var_512, var_509);
            }
            // if best[j] >= 0 and best[j] < NO_NUMBER:                                           <L 25>
            var_515 = wp::extract(var_501, var_513);
            var_517 = (var_515 >= var_516);
            var_514 = var_517;
            if (var_514) {
                var_518 = wp::extract(var_501, var_513);
                var_519 = (var_518 < var_71);
                var_514 = var_514 && var_519;
            }
            if (var_514) {
                // labels[cores__tree__order[head + j]] = best[j]                                 <L 26>
                var_520 = wp::extract(var_501, var_513);
                var_521 = wp::add(var_2, var_513);
                var_522 = wp::address(var_cores__tree__order, var_521);
                var_523 = wp::load(var_522);
                wp::array_store(var_labels, var_523, var_520);
            }
            // if best[j] >= 0 and best[j] < NO_NUMBER:                                           <L 25>
            var_526 = wp::extract(var_501, var_524);
            var_528 = (var_526 >= var_527);
            var_525 = var_528;
            if (var_525) {
                var_529 = wp::extract(var_501, var_524);
                var_530 = (var_529 < var_71);
                var_525 = var_525 && var_530;
            }
            if (var_525) {
                // labels[cores__tree__order[head + j]] = best[j]                                 <L 26>
                var_531 = wp::extract(var_501, var_524);
                var_532 = wp::add(var_2, var_524);
                var_533 = wp::address(var_cores__tree__order, var_532);
                var_534 = wp::load(var_533);
                wp::array_store(var_labels, var_534, var_531);
            }
            // if best[j] >= 0 and best[j] < NO_NUMBER:                                           <L 25>
            var_537 = wp::extract(var_501, var_535);
            var_539 = (var_537 >= var_538);
            var_536 = var_539;
            if (var_536) {
                var_540 = wp::extract(var_501, var_535);
                var_541 = (var_540 < var_71);
                var_536 = var_536 && var_541;
            }
            if (var_536) {
                // labels[cores__tree__order[head + j]] = best[j]                                 <L 26>
                var_542 = wp::extract(var_501, var_535);
                var_543 = wp::add(var_2, var_535);
                var_544 = wp::address(var_cores__tree__order, var_543);
                var_545 = wp::load(var_544);
                wp::array_store(var_labels, var_545, var_542);
            }
            // if best[j] >= 0 and best[j] < NO_NUMBER:                                           <L 25>
            var_548 = wp::extract(var_501, var_546);
            var_550 = (var_548 >= var_549);
            var_547 = var_550;
            if (var_547) {
                var_551 = wp::extract(var_501, var_546);
                var_552 = (var_551 < var_71);
                var_547 = var_547 && var_552;
            }
            if (var_547) {
                // labels[cores__tree__order[head + j]] = best[j]                                 <L 26>
                var_553 = wp::extract(var_501, var_546);
                var_554 = wp::add(var_2, var_546);
                var_555 = wp::address(var_cores__tree__order, var_554);
                var_556 = wp::load(var_555);
                wp::array_store(var_labels, var_556, var_553);
            }
            // if best[j] >= 0 and best[j] < NO_NUMBER:                                           <L 25>
            var_559 = wp::extract(var_501, var_557);
            var_561 = (var_559 >= var_560);
            var_558 = var_561;
            if (var_558) {
                var_562 = wp::extract(var_501, var_557);
                var_563 = (var_562 < var_71);
                var_558 = var_558 && var_563;
            }
            if (var_558) {
                // labels[cores__tree__order[head + j]] = best[j]                                 <L 26>
                var_564 = wp::extract(var_501, var_557);
                var_565 = wp::add(var_2, var_557);
                var_566 = wp::address(var_cores__tree__order, var_565);
                var_567 = wp::load(var_566);
                wp::array_store(var_labels, var_567, var_564);
            }
            // if best[j] >= 0 and best[j] < NO_NUMBER:                                           <L 25>
            var_570 = wp::extract(var_501, var_568);
            var_572 = (var_570 >= var_571);
            var_569 = var_572;
            if (var_569) {
                var_573 = wp::extract(var_501, var_568);
                var_574 = (var_573 < var_71);
                var_569 = var_569 && var_574;
            }
            if (var_569) {
                // labels[cores__tree__order[head + j]] = best[j]                                 <L 26>
                var_575 = wp::extract(var_501, var_568);
                var_576 = wp::add(var_2, var_568);
                var_577 = wp::address(var_cores__tree__order, var_576);
                var_578 = wp::load(var_577);
                wp::array_store(var_labels, var_578, var_575);
            }
            // if best[j] >= 0 and best[j] < NO_NUMBER:                                           <L 25>
            var_581 = wp::extract(var_501, var_579);
            var_583 = (var_581 >= var_582);
            var_580 = var_583;
            if (var_580) {
                var_584 = wp::extract(var_501, var_579);
                var_585 = (var_584 < var_71);
                var_580 = var_580 && var_585;
            }
            if (var_580) {
                // labels[cores__tree__order[head + j]] = best[j]                                 <L 26>
                var_586 = wp::extract(var_501, var_579);
                var_587 = wp::add(var_2, var_579);
                var_588 = wp::address(var_cores__tree__order, var_587);
                var_589 = wp::load(var_588);
                wp::array_store(var_labels, var_589, var_586);
            }
        }
        var_590 = wp::where(var_500, var_501, var_15);
        var_591 = wp::where(var_500, var_579, var_439);
}



extern "C" __global__ void rename_cores_kernel_bcc04236_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_renamed,
    wp::int32 var_cores__tree__count,
    wp::array_t<wp::int32> var_cores__tree__order,
    wp::array_t<wp::int32> var_cores__owners,
    wp::array_t<wp::int32> var_cores__lowest,
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
        const wp::int32 var_1 = 2147483647;
        wp::int32 var_2;
        const wp::int32 var_3 = 8;
        wp::int32 var_4;
        const wp::int32 var_5 = 1;
        wp::int32 var_6;
        wp::int32 var_7;
        wp::int32 var_8;
        wp::range_t var_9;
        wp::int32 var_10;
        wp::int32* var_11;
        wp::int32 var_12;
        wp::int32 var_13;
        const wp::int32 var_14 = 0;
        bool var_15;
        wp::int32* var_16;
        wp::int32 var_17;
        wp::int32 var_18;
        wp::int32* var_19;
        wp::int32 var_20;
        const wp::int32 var_21 = 0;
        bool var_22;
        wp::int32 var_23;
        wp::int32 var_24;
        wp::int32 var_25;
        //---------
        // forward
        // def rename_cores_kernel(renamed, cores__tree__count, cores__tree__order, cores__owners, cores__lowest, labels):       <L 1>
        // leaf = tid()                                                                           <L 3>
        var_0 = builtin_tid1d();
        // lowest_label = int(NO_NUMBER)                                                          <L 4>
        var_2 = wp::int(var_1);
        // for rank in range(leaf * LEAF, min((leaf + 1) * LEAF, cores__tree__count)):            <L 5>
        var_4 = wp::mul(var_0, var_3);
        var_6 = wp::add(var_0, var_5);
        var_7 = wp::mul(var_6, var_3);
        var_8 = wp::min(var_7, var_cores__tree__count);
        var_9 = wp::range(var_4, var_8);
        start_for_0:;
            if (iter_cmp(var_9) == 0) goto end_for_0;
            var_10 = wp::iter_next(var_9);
            // before = cores__owners[rank]                                                       <L 6>
            var_11 = wp::address(var_cores__owners, var_10);
            var_13 = wp::load(var_11);
            var_12 = wp::copy(var_13);
            // if before >= 0:                                                                    <L 7>
            var_15 = (var_12 >= var_14);
            if (var_15) {
                // label = renamed[before]                                                        <L 8>
                var_16 = wp::address(var_renamed, var_12);
                var_18 = wp::load(var_16);
                var_17 = wp::copy(var_18);
                // cores__owners[rank] = label                                                    <L 9>
                wp::array_store(var_cores__owners, var_10, var_17);
                // labels[cores__tree__order[rank]] = label                                       <L 10>
                var_19 = wp::address(var_cores__tree__order, var_10);
                var_20 = wp::load(var_19);
                wp::array_store(var_labels, var_20, var_17);
                // if label >= 0:                                                                 <L 11>
                var_22 = (var_17 >= var_21);
                if (var_22) {
                    // lowest_label = min(lowest_label, label)                                    <L 12>
                    var_23 = wp::min(var_2, var_17);
                }
                var_24 = wp::where(var_22, var_23, var_2);
            }
            var_25 = wp::where(var_15, var_24, var_2);
            wp::assign(var_2, var_25);
            goto start_for_0;
        end_for_0:;
        // cores__lowest[leaf] = lowest_label                                                     <L 13>
        wp::array_store(var_cores__lowest, var_0, var_2);
}



extern "C" __global__ void count_labels_kernel_d8c37374_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::int32 var_run,
    wp::array_t<wp::int32> var_labels,
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
        const wp::int32 var_3 = 0;
        wp::int32 var_4;
        wp::int32 var_5;
        const wp::int32 var_6 = 1;
        wp::int32 var_7;
        wp::int32 var_8;
        wp::shape_t* var_9;
        const wp::int32 var_10 = 0;
        wp::int32 var_11;
        wp::shape_t var_12;
        wp::int32 var_13;
        wp::range_t var_14;
        wp::int32 var_15;
        wp::int32* var_16;
        bool var_17;
        wp::int32 var_18;
        const wp::int32 var_19 = 1;
        wp::int32 var_20;
        const wp::int32 var_21 = 0;
        bool var_22;
        wp::int32 var_23;
        wp::int32* var_24;
        wp::int32 var_25;
        wp::int32 var_26;
        const wp::int32 var_27 = 1;
        wp::int32 var_28;
        wp::int32 var_29;
        const wp::int32 var_30 = 0;
        bool var_31;
        wp::int32 var_32;
        //---------
        // forward
        // def count_labels_kernel(run, labels, counts):                                          <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // label = int(NOISE)                                                                     <L 4>
        var_2 = wp::int(var_1);
        // count = int(0)                                                                         <L 5>
        var_4 = wp::int(var_3);
        // for j in range(i * run, min((i + 1) * run, labels.shape[0])):                          <L 6>
        var_5 = wp::mul(var_0, var_run);
        var_7 = wp::add(var_0, var_6);
        var_8 = wp::mul(var_7, var_run);
        var_9 = &(var_labels.shape);
        var_12 = wp::load(var_9);
        var_11 = wp::extract(var_12, var_10);
        var_13 = wp::min(var_8, var_11);
        var_14 = wp::range(var_5, var_13);
        start_for_0:;
            if (iter_cmp(var_14) == 0) goto end_for_0;
            var_15 = wp::iter_next(var_14);
            // if labels[j] == label:                                                             <L 7>
            var_16 = wp::address(var_labels, var_15);
            var_18 = wp::load(var_16);
            var_17 = (var_18 == var_2);
            if (var_17) {
                // count += 1                                                                     <L 8>
                var_20 = wp::add(var_4, var_19);
            }
            if (!var_17) {
                // if label >= 0:                                                                 <L 10>
                var_22 = (var_2 >= var_21);
                if (var_22) {
                    // atomic_add(counts, label, count)                                           <L 11>
                    var_23 = wp::atomic_add(var_counts, var_2, var_4);
                }
                // label = labels[j]                                                              <L 12>
                var_24 = wp::address(var_labels, var_15);
                var_26 = wp::load(var_24);
                var_25 = wp::copy(var_26);
                // count = 1                                                                      <L 13>
            }
            var_28 = wp::where(var_17, var_2, var_25);
            var_29 = wp::where(var_17, var_20, var_27);
            wp::assign(var_2, var_28);
            wp::assign(var_4, var_29);
            goto start_for_0;
        end_for_0:;
        // if label >= 0:                                                                         <L 14>
        var_31 = (var_2 >= var_30);
        if (var_31) {
            // atomic_add(counts, label, count)                                                   <L 15>
            var_32 = wp::atomic_add(var_counts, var_2, var_4);
        }
}


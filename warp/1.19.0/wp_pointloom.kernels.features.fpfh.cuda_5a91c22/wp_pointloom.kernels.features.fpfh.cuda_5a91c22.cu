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


// /work/main/src/pointloom/kernels/language/warp_compiler.py:154
static CUDA_CALLABLE wp::int32 _lane_0(
    )
{
return (int)(threadIdx.x & 31u);}


// <pointloom.kernels.arrays.packed_keys.key_bits>:1
static CUDA_CALLABLE wp::int32 key_bits_0(
    wp::int64 var_key)
{
    //---------
    // primal vars
    wp::int64 var_0;
    wp::int64 var_1;
    wp::int32 var_2;
    //---------
    // forward
    // def key_bits(key):                                                                     <L 1>
    // return int(key >> int64(32))                                                           <L 2>
    var_0 = 32ll;
    var_1 = wp::rshift(var_key, var_0);
    var_2 = wp::int(var_1);
    return var_2;
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:148
static CUDA_CALLABLE wp::float32 _bits_float_0(
    wp::int32 var_i)
{
    //---------
    // primal vars
    wp::float32 var_0;
    //---------
    // forward
    // def _bits_float(i: wp.int32):                                                          <L 149>
    // return wp.cast(i, wp.float32)                                                          <L 150>
    var_0 = wp::cast<wp::float32>(var_i);
    return var_0;
}


// /work/main/src/pointloom/kernels/arrays/packed_keys.py:28
static CUDA_CALLABLE wp::float32 key_number_0(
    wp::int64 var_key)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::float32 var_1;
    //---------
    // forward
    // def key_number(key: int64) -> float:                                                   <L 29>
    // return bits_float(key_bits(key))                                                       <L 30>
    var_0 = key_bits_0(var_key);
    var_1 = _bits_float_0(var_0);
    return var_1;
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:166
static CUDA_CALLABLE wp::float32 _shuffle_1(
    wp::float32 x,
    wp::int32 lane)
{
return __shfl_sync(0xffffffffu, x, lane);}


// /work/main/src/pointloom/kernels/search/lane_search.py:50
static CUDA_CALLABLE wp::vec_t<3, wp::float32> point_of_lane_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::int32 var_owner)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    wp::float32 var_2;
    const wp::int32 var_3 = 1;
    wp::float32 var_4;
    wp::float32 var_5;
    const wp::int32 var_6 = 2;
    wp::float32 var_7;
    wp::float32 var_8;
    wp::vec_t<3, wp::float32> var_9;
    //---------
    // forward
    // def point_of_lane(p: vec3, owner: int) -> vec3:                                        <L 51>
    // return vec3(shuffle(p[0], owner), shuffle(p[1], owner), shuffle(p[2], owner))          <L 52>
    var_1 = wp::extract(var_p, var_0);
    var_2 = _shuffle_1(var_1, var_owner);
    var_4 = wp::extract(var_p, var_3);
    var_5 = _shuffle_1(var_4, var_owner);
    var_7 = wp::extract(var_p, var_6);
    var_8 = _shuffle_1(var_7, var_owner);
    var_9 = wp::vec_t<3, wp::float32>(var_2, var_5, var_8);
    return var_9;
}


// /work/main/src/pointloom/kernels/search/point_tree.py:379
static CUDA_CALLABLE wp::float32 square_distance_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> var_q)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    const wp::int32 var_2 = 0;
    wp::float32 var_3;
    wp::float32 var_4;
    const wp::int32 var_5 = 1;
    wp::float32 var_6;
    const wp::int32 var_7 = 1;
    wp::float32 var_8;
    wp::float32 var_9;
    const wp::int32 var_10 = 2;
    wp::float32 var_11;
    const wp::int32 var_12 = 2;
    wp::float32 var_13;
    wp::float32 var_14;
    wp::float32 var_15;
    wp::float32 var_16;
    wp::float32 var_17;
    wp::float32 var_18;
    wp::float32 var_19;
    //---------
    // forward
    // def square_distance(p: vec3, q: vec3) -> float:                                        <L 380>
    // x = q[0] - p[0]                                                                        <L 382>
    var_1 = wp::extract(var_q, var_0);
    var_3 = wp::extract(var_p, var_2);
    var_4 = wp::sub(var_1, var_3);
    // y = q[1] - p[1]                                                                        <L 383>
    var_6 = wp::extract(var_q, var_5);
    var_8 = wp::extract(var_p, var_7);
    var_9 = wp::sub(var_6, var_8);
    // z = q[2] - p[2]                                                                        <L 384>
    var_11 = wp::extract(var_q, var_10);
    var_13 = wp::extract(var_p, var_12);
    var_14 = wp::sub(var_11, var_13);
    // return x * x + y * y + z * z                                                           <L 385>
    var_15 = wp::mul(var_4, var_4);
    var_16 = wp::mul(var_9, var_9);
    var_17 = wp::add(var_15, var_16);
    var_18 = wp::mul(var_14, var_14);
    var_19 = wp::add(var_17, var_18);
    return var_19;
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:178
static CUDA_CALLABLE wp::float32 _shuffle_xor_1(
    wp::float32 x,
    wp::int32 mask)
{
return __shfl_xor_sync(0xffffffffu, x, mask);}


// /work/main/src/pointloom/kernels/arrays/lanes.py:52
static CUDA_CALLABLE wp::float32 max_of_eight_on_cuda_0(
    wp::float32 var_x)
{
    //---------
    // primal vars
    wp::float32 var_0;
    const wp::int32 var_1 = 0;
    const wp::int32 var_2 = 1;
    wp::int32 var_3;
    wp::float32 var_4;
    wp::float32 var_5;
    const wp::int32 var_6 = 1;
    const wp::int32 var_7 = 1;
    wp::int32 var_8;
    wp::float32 var_9;
    wp::float32 var_10;
    const wp::int32 var_11 = 2;
    const wp::int32 var_12 = 1;
    wp::int32 var_13;
    wp::float32 var_14;
    wp::float32 var_15;
    //---------
    // forward
    // def max_of_eight(x: float) -> float:                                                   <L 53>
    // highest = x                                                                            <L 54>
    var_0 = wp::copy(var_x);
    // for bit in range(EIGHT_BITS):                                                          <L 55>
    // highest = max(highest, shuffle_xor(highest, 1 << bit))                                 <L 56>
    var_3 = wp::lshift(var_2, var_1);
    var_4 = _shuffle_xor_1(var_0, var_3);
    var_5 = wp::max(var_0, var_4);
    var_8 = wp::lshift(var_7, var_6);
    var_9 = _shuffle_xor_1(var_5, var_8);
    var_10 = wp::max(var_5, var_9);
    var_13 = wp::lshift(var_12, var_11);
    var_14 = _shuffle_xor_1(var_10, var_13);
    var_15 = wp::max(var_10, var_14);
    // return highest                                                                         <L 57>
    return var_15;
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:158
static CUDA_CALLABLE wp::int32 _ballot_0(
    wp::int32 flag)
{
return (int)__ballot_sync(0xffffffffu, flag != 0);}


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


// /work/main/src/pointloom/kernels/arrays/lanes.py:44
static CUDA_CALLABLE wp::float32 min_of_eight_on_cuda_0(
    wp::float32 var_x)
{
    //---------
    // primal vars
    wp::float32 var_0;
    const wp::int32 var_1 = 0;
    const wp::int32 var_2 = 1;
    wp::int32 var_3;
    wp::float32 var_4;
    wp::float32 var_5;
    const wp::int32 var_6 = 1;
    const wp::int32 var_7 = 1;
    wp::int32 var_8;
    wp::float32 var_9;
    wp::float32 var_10;
    const wp::int32 var_11 = 2;
    const wp::int32 var_12 = 1;
    wp::int32 var_13;
    wp::float32 var_14;
    wp::float32 var_15;
    //---------
    // forward
    // def min_of_eight(x: float) -> float:                                                   <L 45>
    // lowest = x                                                                             <L 46>
    var_0 = wp::copy(var_x);
    // for bit in range(EIGHT_BITS):                                                          <L 47>
    // lowest = min(lowest, shuffle_xor(lowest, 1 << bit))                                    <L 48>
    var_3 = wp::lshift(var_2, var_1);
    var_4 = _shuffle_xor_1(var_0, var_3);
    var_5 = wp::min(var_0, var_4);
    var_8 = wp::lshift(var_7, var_6);
    var_9 = _shuffle_xor_1(var_5, var_8);
    var_10 = wp::min(var_5, var_9);
    var_13 = wp::lshift(var_12, var_11);
    var_14 = _shuffle_xor_1(var_10, var_13);
    var_15 = wp::min(var_10, var_14);
    // return lowest                                                                          <L 49>
    return var_15;
}


// /work/main/src/pointloom/kernels/arrays/lanes.py:60
static CUDA_CALLABLE wp::vec_t<3, wp::float32> low_of_eight_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    wp::float32 var_2;
    const wp::int32 var_3 = 1;
    wp::float32 var_4;
    wp::float32 var_5;
    const wp::int32 var_6 = 2;
    wp::float32 var_7;
    wp::float32 var_8;
    wp::vec_t<3, wp::float32> var_9;
    //---------
    // forward
    // def low_of_eight(p: vec3) -> vec3:                                                     <L 61>
    // return vec3(min_of_eight(p[0]), min_of_eight(p[1]), min_of_eight(p[2]))                <L 63>
    var_1 = wp::extract(var_p, var_0);
    var_2 = min_of_eight_on_cuda_0(var_1);
    var_4 = wp::extract(var_p, var_3);
    var_5 = min_of_eight_on_cuda_0(var_4);
    var_7 = wp::extract(var_p, var_6);
    var_8 = min_of_eight_on_cuda_0(var_7);
    var_9 = wp::vec_t<3, wp::float32>(var_2, var_5, var_8);
    return var_9;
}


// /work/main/src/pointloom/kernels/arrays/lanes.py:66
static CUDA_CALLABLE wp::vec_t<3, wp::float32> high_of_eight_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    wp::float32 var_2;
    const wp::int32 var_3 = 1;
    wp::float32 var_4;
    wp::float32 var_5;
    const wp::int32 var_6 = 2;
    wp::float32 var_7;
    wp::float32 var_8;
    wp::vec_t<3, wp::float32> var_9;
    //---------
    // forward
    // def high_of_eight(p: vec3) -> vec3:                                                    <L 67>
    // return vec3(max_of_eight(p[0]), max_of_eight(p[1]), max_of_eight(p[2]))                <L 68>
    var_1 = wp::extract(var_p, var_0);
    var_2 = max_of_eight_on_cuda_0(var_1);
    var_4 = wp::extract(var_p, var_3);
    var_5 = max_of_eight_on_cuda_0(var_4);
    var_7 = wp::extract(var_p, var_6);
    var_8 = max_of_eight_on_cuda_0(var_7);
    var_9 = wp::vec_t<3, wp::float32>(var_2, var_5, var_8);
    return var_9;
}


// /work/main/src/pointloom/kernels/search/lane_search.py:55
static CUDA_CALLABLE wp::vec_t<12, wp::float32> boxes_of_eight_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::int32 var_is_used)
{
    //---------
    // primal vars
    wp::int32 var_0;
    const wp::int32 var_1 = 8;
    const wp::int32 var_2 = 1;
    wp::int32 var_3;
    wp::int32 var_4;
    wp::int32 var_5;
    const wp::int32 var_6 = 1;
    wp::int32 var_7;
    const wp::int32 var_8 = 32;
    const wp::int32 var_9 = 1;
    wp::int32 var_10;
    wp::int32 var_11;
    wp::vec_t<3, wp::float32> var_12;
    const wp::int32 var_13 = 1;
    wp::int32 var_14;
    bool var_15;
    wp::float32 var_16;
    const wp::float32 var_17 = -1.0;
    wp::float32 var_18;
    wp::float32 var_19;
    bool var_20;
    const wp::int32 var_21 = 1;
    const wp::int32 var_22 = 0;
    wp::int32 var_23;
    wp::int32 var_24;
    wp::int32 var_25;
    wp::int32 var_26;
    wp::int32 var_27;
    const wp::int32 var_28 = 255;
    wp::int32 var_29;
    wp::int32 var_30;
    bool var_31;
    const wp::int32 var_32 = 1;
    const wp::int32 var_33 = 0;
    wp::int32 var_34;
    const wp::float32 var_35 = INFINITY;
    wp::vec_t<3, wp::float32> var_36;
    wp::vec_t<3, wp::float32> var_37;
    wp::vec_t<3, wp::float32> var_38;
    wp::vec_t<3, wp::float32> var_39;
    wp::vec_t<3, wp::float32> var_40;
    const wp::int32 var_41 = 1;
    bool var_42;
    const wp::int32 var_43 = 1;
    bool var_44;
    wp::vec_t<3, wp::float32> var_45;
    wp::vec_t<3, wp::float32> var_46;
    wp::vec_t<3, wp::float32> var_47;
    wp::vec_t<3, wp::float32> var_48;
    wp::vec_t<3, wp::float32> var_49;
    wp::vec_t<3, wp::float32> var_50;
    wp::vec_t<3, wp::float32> var_51;
    wp::vec_t<3, wp::float32> var_52;
    wp::vec_t<3, wp::float32> var_53;
    wp::vec_t<3, wp::float32> var_54;
    wp::vec_t<3, wp::float32> var_55;
    wp::vec_t<3, wp::float32> var_56;
    wp::vec_t<3, wp::float32> var_57;
    wp::vec_t<3, wp::float32> var_58;
    wp::vec_t<3, wp::float32> var_59;
    wp::vec_t<3, wp::float32> var_60;
    const wp::int32 var_61 = 0;
    wp::float32 var_62;
    const wp::int32 var_63 = 1;
    wp::float32 var_64;
    const wp::int32 var_65 = 2;
    wp::float32 var_66;
    const wp::int32 var_67 = 0;
    wp::float32 var_68;
    const wp::int32 var_69 = 1;
    wp::float32 var_70;
    const wp::int32 var_71 = 2;
    wp::float32 var_72;
    const wp::int32 var_73 = 0;
    wp::float32 var_74;
    const wp::int32 var_75 = 1;
    wp::float32 var_76;
    const wp::int32 var_77 = 2;
    wp::float32 var_78;
    const wp::int32 var_79 = 0;
    wp::float32 var_80;
    const wp::int32 var_81 = 1;
    wp::float32 var_82;
    const wp::int32 var_83 = 2;
    wp::float32 var_84;
    wp::vec_t<12, wp::float32> var_85;
    //---------
    // forward
    // def boxes_of_eight(p: vec3, is_used: int) -> two_boxes:                                <L 56>
    // own = lane() & (FAN - 1)                                                               <L 59>
    var_0 = _lane_0();
    var_3 = wp::sub(var_1, var_2);
    var_4 = wp::bit_and(var_0, var_3);
    // after = point_of_lane(p, min(lane() + 1, WARP - 1))                                    <L 60>
    var_5 = _lane_0();
    var_7 = wp::add(var_5, var_6);
    var_10 = wp::sub(var_8, var_9);
    var_11 = wp::min(var_7, var_10);
    var_12 = point_of_lane_on_cuda_0(var_p, var_11);
    // gap = square_distance(p, after) if own < FAN - 1 else -1.0                             <L 61>
    var_14 = wp::sub(var_1, var_13);
    var_15 = (var_4 < var_14);
    if (var_15) {
        var_16 = square_distance_0(var_p, var_12);
    }
    if (!var_15) {
    }
    var_18 = wp::where(var_15, var_16, var_17);
    // largest = max_of_eight(gap)                                                            <L 62>
    var_19 = max_of_eight_on_cuda_0(var_18);
    // widest = ballot(1 if gap == largest else 0) >> (lane() - own)                          <L 63>
    var_20 = (var_18 == var_19);
    if (var_20) {
    }
    if (!var_20) {
    }
    var_23 = wp::where(var_20, var_21, var_22);
    var_24 = _ballot_0(var_23);
    var_25 = _lane_0();
    var_26 = wp::sub(var_25, var_4);
    var_27 = wp::rshift(var_24, var_26);
    // is_before = 1 if own <= lowest_bit(widest & BYTE) else 0                               <L 64>
    var_29 = wp::bit_and(var_27, var_28);
    var_30 = lowest_bit_0(var_29);
    var_31 = (var_4 <= var_30);
    if (var_31) {
    }
    if (!var_31) {
    }
    var_34 = wp::where(var_31, var_32, var_33);
    // nowhere = vec3(INFINITY, INFINITY, INFINITY)                                           <L 65>
    var_36 = wp::vec_t<3, wp::float32>(var_35, var_35, var_35);
    // low = nowhere                                                                          <L 66>
    var_37 = wp::copy(var_36);
    // high = -nowhere                                                                        <L 67>
    var_38 = wp::neg(var_36);
    // low_after = nowhere                                                                    <L 68>
    var_39 = wp::copy(var_36);
    // high_after = -nowhere                                                                  <L 69>
    var_40 = wp::neg(var_36);
    // if is_used == 1:                                                                       <L 70>
    var_42 = (var_is_used == var_41);
    if (var_42) {
        // if is_before == 1:                                                                 <L 71>
        var_44 = (var_34 == var_43);
        if (var_44) {
            // low = p                                                                        <L 72>
            var_45 = wp::copy(var_p);
            // high = p                                                                       <L 73>
            var_46 = wp::copy(var_p);
        }
        if (!var_44) {
            // low_after = p                                                                  <L 75>
            var_47 = wp::copy(var_p);
            // high_after = p                                                                 <L 76>
            var_48 = wp::copy(var_p);
        }
        var_49 = wp::where(var_44, var_45, var_37);
        var_50 = wp::where(var_44, var_46, var_38);
        var_51 = wp::where(var_44, var_39, var_47);
        var_52 = wp::where(var_44, var_40, var_48);
    }
    var_53 = wp::where(var_42, var_49, var_37);
    var_54 = wp::where(var_42, var_50, var_38);
    var_55 = wp::where(var_42, var_51, var_39);
    var_56 = wp::where(var_42, var_52, var_40);
    // a = low_of_eight(low)                                                                  <L 77>
    var_57 = low_of_eight_on_cuda_0(var_53);
    // b = high_of_eight(high)                                                                <L 78>
    var_58 = high_of_eight_on_cuda_0(var_54);
    // c = low_of_eight(low_after)                                                            <L 79>
    var_59 = low_of_eight_on_cuda_0(var_55);
    // d = high_of_eight(high_after)                                                          <L 80>
    var_60 = high_of_eight_on_cuda_0(var_56);
    // return two_boxes(a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2], d[0], d[1], d[2])       <L 81>
    var_62 = wp::extract(var_57, var_61);
    var_64 = wp::extract(var_57, var_63);
    var_66 = wp::extract(var_57, var_65);
    var_68 = wp::extract(var_58, var_67);
    var_70 = wp::extract(var_58, var_69);
    var_72 = wp::extract(var_58, var_71);
    var_74 = wp::extract(var_59, var_73);
    var_76 = wp::extract(var_59, var_75);
    var_78 = wp::extract(var_59, var_77);
    var_80 = wp::extract(var_60, var_79);
    var_82 = wp::extract(var_60, var_81);
    var_84 = wp::extract(var_60, var_83);
    var_85 = wp::vec_t<12, wp::float32>({var_62, var_64, var_66, var_68, var_70, var_72, var_74, var_76, var_78, var_80, var_82, var_84});
    return var_85;
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:186
static CUDA_CALLABLE void _sync_lanes_0(
    )
{
__syncwarp();}


// <pointloom.kernels.search.bucket_walk.start_traversal>:1
static CUDA_CALLABLE wp::vec_t<4, wp::int64> start_traversal_0(
    wp::int32 var_bucket)
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
    // def start_traversal(bucket):                                                           <L 1>
    // return traversal(int64(0), int64(0), int64(bucket), int64(0))                          <L 2>
    var_0 = 0ll;
    var_1 = 0ll;
    var_2 = wp::int64(var_bucket);
    var_3 = 0ll;
    var_4 = wp::vec_t<4, wp::int64>(var_0, var_1, var_2, var_3);
    return var_4;
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


// /work/main/src/pointloom/kernels/search/point_tree.py:401
static CUDA_CALLABLE wp::float32 measure_box_0(
    wp::array_t<wp::float32> var_boxes,
    wp::int32 var_node,
    wp::int32 var_child,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 48;
    wp::int32 var_1;
    wp::int32 var_2;
    wp::float32* var_3;
    const wp::int32 var_4 = 0;
    wp::float32 var_5;
    wp::float32 var_6;
    wp::float32 var_7;
    const wp::int32 var_8 = 0;
    wp::float32 var_9;
    const wp::int32 var_10 = 3;
    const wp::int32 var_11 = 8;
    wp::int32 var_12;
    wp::int32 var_13;
    wp::float32* var_14;
    wp::float32 var_15;
    wp::float32 var_16;
    wp::float32 var_17;
    const wp::float32 var_18 = 0.0;
    wp::float32 var_19;
    wp::int32 var_20;
    wp::float32* var_21;
    const wp::int32 var_22 = 1;
    wp::float32 var_23;
    wp::float32 var_24;
    wp::float32 var_25;
    const wp::int32 var_26 = 1;
    wp::float32 var_27;
    const wp::int32 var_28 = 4;
    wp::int32 var_29;
    wp::int32 var_30;
    wp::float32* var_31;
    wp::float32 var_32;
    wp::float32 var_33;
    wp::float32 var_34;
    const wp::float32 var_35 = 0.0;
    wp::float32 var_36;
    const wp::int32 var_37 = 2;
    wp::int32 var_38;
    wp::int32 var_39;
    wp::float32* var_40;
    const wp::int32 var_41 = 2;
    wp::float32 var_42;
    wp::float32 var_43;
    wp::float32 var_44;
    const wp::int32 var_45 = 2;
    wp::float32 var_46;
    const wp::int32 var_47 = 5;
    wp::int32 var_48;
    wp::int32 var_49;
    wp::float32* var_50;
    wp::float32 var_51;
    wp::float32 var_52;
    wp::float32 var_53;
    const wp::float32 var_54 = 0.0;
    wp::float32 var_55;
    wp::float32 var_56;
    wp::float32 var_57;
    wp::float32 var_58;
    wp::float32 var_59;
    wp::float32 var_60;
    //---------
    // forward
    // def measure_box(boxes: array(dtype=float32), node: int, child: int, a: vec3, b: vec3) -> float:       <L 402>
    // at = node * SIDES + child                                                              <L 403>
    var_1 = wp::mul(var_node, var_0);
    var_2 = wp::add(var_1, var_child);
    // x = larger(larger(boxes[at] - b[0], a[0] - boxes[at + 3 * FAN]), 0.0)                  <L 404>
    var_3 = wp::address(var_boxes, var_2);
    var_5 = wp::extract(var_b, var_4);
    var_7 = wp::load(var_3);
    var_6 = wp::sub(var_7, var_5);
    var_9 = wp::extract(var_a, var_8);
    var_12 = wp::mul(var_10, var_11);
    var_13 = wp::add(var_2, var_12);
    var_14 = wp::address(var_boxes, var_13);
    var_16 = wp::load(var_14);
    var_15 = wp::sub(var_9, var_16);
    var_17 = larger_0(var_6, var_15);
    var_19 = larger_0(var_17, var_18);
    // y = larger(larger(boxes[at + FAN] - b[1], a[1] - boxes[at + 4 * FAN]), 0.0)            <L 405>
    var_20 = wp::add(var_2, var_11);
    var_21 = wp::address(var_boxes, var_20);
    var_23 = wp::extract(var_b, var_22);
    var_25 = wp::load(var_21);
    var_24 = wp::sub(var_25, var_23);
    var_27 = wp::extract(var_a, var_26);
    var_29 = wp::mul(var_28, var_11);
    var_30 = wp::add(var_2, var_29);
    var_31 = wp::address(var_boxes, var_30);
    var_33 = wp::load(var_31);
    var_32 = wp::sub(var_27, var_33);
    var_34 = larger_0(var_24, var_32);
    var_36 = larger_0(var_34, var_35);
    // z = larger(larger(boxes[at + 2 * FAN] - b[2], a[2] - boxes[at + 5 * FAN]), 0.0)        <L 406>
    var_38 = wp::mul(var_37, var_11);
    var_39 = wp::add(var_2, var_38);
    var_40 = wp::address(var_boxes, var_39);
    var_42 = wp::extract(var_b, var_41);
    var_44 = wp::load(var_40);
    var_43 = wp::sub(var_44, var_42);
    var_46 = wp::extract(var_a, var_45);
    var_48 = wp::mul(var_47, var_11);
    var_49 = wp::add(var_2, var_48);
    var_50 = wp::address(var_boxes, var_49);
    var_52 = wp::load(var_50);
    var_51 = wp::sub(var_46, var_52);
    var_53 = larger_0(var_43, var_51);
    var_55 = larger_0(var_53, var_54);
    // return x * x + y * y + z * z                                                           <L 407>
    var_56 = wp::mul(var_19, var_19);
    var_57 = wp::mul(var_36, var_36);
    var_58 = wp::add(var_56, var_57);
    var_59 = wp::mul(var_55, var_55);
    var_60 = wp::add(var_58, var_59);
    return var_60;
}


// /work/main/src/pointloom/kernels/search/lane_search.py:84
static CUDA_CALLABLE wp::int32 nearby_children_on_cuda_0(
    wp::array_t<wp::float32> var_boxes,
    wp::int32 var_node,
    wp::vec_t<12, wp::float32> var_around,
    wp::float32 var_bound)
{
    //---------
    // primal vars
    wp::int32 var_0;
    const wp::int32 var_1 = 8;
    const wp::int32 var_2 = 1;
    wp::int32 var_3;
    wp::int32 var_4;
    const wp::int32 var_5 = 0;
    wp::float32 var_6;
    const wp::int32 var_7 = 1;
    wp::float32 var_8;
    const wp::int32 var_9 = 2;
    wp::float32 var_10;
    wp::vec_t<3, wp::float32> var_11;
    const wp::int32 var_12 = 3;
    wp::float32 var_13;
    const wp::int32 var_14 = 4;
    wp::float32 var_15;
    const wp::int32 var_16 = 5;
    wp::float32 var_17;
    wp::vec_t<3, wp::float32> var_18;
    wp::float32 var_19;
    const wp::int32 var_20 = 6;
    wp::float32 var_21;
    const wp::int32 var_22 = 7;
    wp::float32 var_23;
    const wp::int32 var_24 = 8;
    wp::float32 var_25;
    wp::vec_t<3, wp::float32> var_26;
    const wp::int32 var_27 = 9;
    wp::float32 var_28;
    const wp::int32 var_29 = 10;
    wp::float32 var_30;
    const wp::int32 var_31 = 11;
    wp::float32 var_32;
    wp::vec_t<3, wp::float32> var_33;
    wp::float32 var_34;
    wp::float32 var_35;
    bool var_36;
    const wp::int32 var_37 = 1;
    const wp::int32 var_38 = 0;
    wp::int32 var_39;
    wp::int32 var_40;
    const wp::int32 var_41 = 2;
    wp::int32 var_42;
    wp::int32 var_43;
    wp::int32 var_44;
    wp::int32 var_45;
    wp::int32 var_46;
    const wp::int32 var_47 = 255;
    wp::int32 var_48;
    //---------
    // forward
    // def nearby_children(boxes: array(dtype=float32), node: int, around: two_boxes, bound: float) -> int:       <L 85>
    // child = lane() & (FAN - 1)                                                             <L 87>
    var_0 = _lane_0();
    var_3 = wp::sub(var_1, var_2);
    var_4 = wp::bit_and(var_0, var_3);
    // a = measure_box(boxes, node, child, vec3(around[0], around[1], around[2]), vec3(around[3], around[4], around[5]))       <L 88>
    var_6 = wp::extract(var_around, var_5);
    var_8 = wp::extract(var_around, var_7);
    var_10 = wp::extract(var_around, var_9);
    var_11 = wp::vec_t<3, wp::float32>(var_6, var_8, var_10);
    var_13 = wp::extract(var_around, var_12);
    var_15 = wp::extract(var_around, var_14);
    var_17 = wp::extract(var_around, var_16);
    var_18 = wp::vec_t<3, wp::float32>(var_13, var_15, var_17);
    var_19 = measure_box_0(var_boxes, var_node, var_4, var_11, var_18);
    // b = measure_box(boxes, node, child, vec3(around[6], around[7], around[8]), vec3(around[9], around[10], around[11]))       <L 89>
    var_21 = wp::extract(var_around, var_20);
    var_23 = wp::extract(var_around, var_22);
    var_25 = wp::extract(var_around, var_24);
    var_26 = wp::vec_t<3, wp::float32>(var_21, var_23, var_25);
    var_28 = wp::extract(var_around, var_27);
    var_30 = wp::extract(var_around, var_29);
    var_32 = wp::extract(var_around, var_31);
    var_33 = wp::vec_t<3, wp::float32>(var_28, var_30, var_32);
    var_34 = measure_box_0(var_boxes, var_node, var_4, var_26, var_33);
    // near = ballot(1 if min(a, b) <= bound else 0)                                          <L 90>
    var_35 = wp::min(var_19, var_34);
    var_36 = (var_35 <= var_bound);
    if (var_36) {
    }
    if (!var_36) {
    }
    var_39 = wp::where(var_36, var_37, var_38);
    var_40 = _ballot_0(var_39);
    // near = near | (near >> (2 * FAN))                                                      <L 91>
    var_42 = wp::mul(var_41, var_1);
    var_43 = wp::rshift(var_40, var_42);
    var_44 = wp::bit_or(var_40, var_43);
    // return (near | (near >> FAN)) & BYTE                                                   <L 92>
    var_45 = wp::rshift(var_44, var_1);
    var_46 = wp::bit_or(var_44, var_45);
    var_48 = wp::bit_and(var_46, var_47);
    return var_48;
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


// /work/main/src/pointloom/kernels/search/lane_search.py:95
static CUDA_CALLABLE wp::int32 nearby_nodes_on_cuda_0(
    wp::array_t<wp::int32> var_levels,
    wp::int32 var_first,
    wp::array_t<wp::float32> var_boxes,
    wp::vec_t<12, wp::float32> var_around,
    wp::float32 var_bound,
    wp::int32 var_level,
    wp::int32 var_node)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32* var_1;
    wp::int32 var_2;
    wp::int32 var_3;
    wp::int32 var_4;
    //---------
    // forward
    // def nearby_nodes(                                                                      <L 96>
    // return nearby_children(boxes, levels[first + level] + node, around, bound)             <L 106>
    var_0 = wp::add(var_first, var_level);
    var_1 = wp::address(var_levels, var_0);
    var_3 = wp::load(var_1);
    var_2 = wp::add(var_3, var_node);
    var_4 = nearby_children_on_cuda_0(var_boxes, var_2, var_around, var_bound);
    return var_4;
}


// <pointloom.kernels.search.bucket_walk.next_step__nearby_nodes>:1
static CUDA_CALLABLE wp::vec_t<4, wp::int64> next_step__nearby_nodes_on_cuda_0(
    wp::vec_t<4, wp::int64> var_step,
    wp::int32 var_root,
    wp::array_t<wp::int32> var_children__levels,
    wp::int32 var_children__first,
    wp::array_t<wp::float32> var_children__boxes,
    wp::vec_t<12, wp::float32> var_children__around,
    wp::float32 var_children__bound)
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
    bool var_11;
    const wp::int32 var_12 = 0;
    bool var_13;
    const wp::int32 var_14 = 0;
    bool var_15;
    const wp::int32 var_16 = 1;
    const wp::int32 var_17 = 8;
    wp::int32 var_18;
    wp::int32 var_19;
    wp::int32 var_20;
    const wp::int32 var_21 = 1;
    wp::int32 var_22;
    const wp::int32 var_23 = 1;
    bool var_24;
    wp::int64 var_25;
    wp::int64 var_26;
    wp::int32 var_27;
    const wp::int32 var_28 = 255;
    wp::int32 var_29;
    const wp::int32 var_30 = 0;
    bool var_31;
    wp::int32 var_32;
    wp::int32 var_33;
    wp::int64 var_34;
    wp::int64 var_35;
    wp::int64 var_36;
    wp::int64 var_37;
    wp::int32 var_38;
    const wp::int32 var_39 = 1;
    wp::int32 var_40;
    wp::int32 var_41;
    wp::int32 var_42;
    const wp::int32 var_43 = 1;
    wp::int32 var_44;
    const wp::int32 var_45 = 0;
    bool var_46;
    const wp::int32 var_47 = 0;
    wp::int32 var_48;
    wp::int64 var_49;
    wp::int64 var_50;
    wp::int64 var_51;
    wp::int64 var_52;
    wp::int64 var_53;
    wp::int32 var_54;
    bool var_55;
    const wp::int32 var_56 = 1;
    wp::int32 var_57;
    bool var_58;
    const wp::int32 var_59 = 0;
    const wp::int32 var_60 = 1;
    wp::int32 var_61;
    wp::int32 var_62;
    wp::int32 var_63;
    const wp::int32 var_64 = 1;
    wp::int32 var_65;
    wp::int32 var_66;
    wp::int32 var_67;
    wp::int32 var_68;
    wp::int64 var_69;
    wp::int64 var_70;
    wp::int64 var_71;
    wp::int64 var_72;
    wp::int32 var_73;
    wp::int32 var_74;
    wp::int64 var_75;
    wp::int32 var_76;
    wp::int32 var_77;
    const wp::int32 var_78 = 1;
    wp::int32 var_79;
    wp::int32 var_80;
    wp::int32 var_81;
    wp::int32 var_82;
    wp::int64 var_83;
    wp::int32 var_84;
    wp::int32 var_85;
    wp::int32 var_86;
    wp::int32 var_87;
    wp::int64 var_88;
    wp::int32 var_89;
    wp::int64 var_90;
    wp::int64 var_91;
    wp::int64 var_92;
    wp::vec_t<4, wp::int64> var_93;
    //---------
    // forward
    // def next_step__nearby_nodes(step, root, children__levels, children__first, children__boxes, children__around, children__bound):       <L 1>
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
    // if level == 0 and height > 0:                                                          <L 7>
    var_13 = (var_5 == var_12);
    var_11 = var_13;
    if (var_11) {
        var_15 = (var_2 > var_14);
        var_11 = var_11 && var_15;
    }
    if (var_11) {
        // level = 1                                                                          <L 8>
        // node = node // FAN                                                                 <L 9>
        var_18 = wp::floordiv(var_8, var_17);
    }
    var_19 = wp::where(var_11, var_16, var_5);
    var_20 = wp::where(var_11, var_18, var_8);
    // searching = int(1)                                                                     <L 10>
    var_22 = wp::int(var_21);
    // while searching == 1:                                                                  <L 11>
    start_while_0:;
    var_24 = (var_22 == var_23);
    if ((var_24) == false) goto end_while_0;
        // left = int(pending >> byte_shift(level)) & BYTE                                    <L 12>
        var_25 = byte_shift_0(var_19);
        var_26 = wp::rshift(var_10, var_25);
        var_27 = wp::int(var_26);
        var_29 = wp::bit_and(var_27, var_28);
        // if left != 0:                                                                      <L 13>
        var_31 = (var_29 != var_30);
        if (var_31) {
            // lowest = left & -left                                                          <L 14>
            var_32 = wp::neg(var_29);
            var_33 = wp::bit_and(var_29, var_32);
            // pending = pending ^ int64(lowest) << byte_shift(level)                         <L 15>
            var_34 = wp::int64(var_33);
            var_35 = byte_shift_0(var_19);
            var_36 = wp::lshift(var_34, var_35);
            var_37 = wp::bit_xor(var_10, var_36);
            // node = node * FAN + bit_count(lowest - 1)                                      <L 16>
            var_38 = wp::mul(var_20, var_17);
            var_40 = wp::sub(var_33, var_39);
            var_41 = wp::bit_count(var_40);
            var_42 = wp::add(var_38, var_41);
            // level = level - 1                                                              <L 17>
            var_44 = wp::sub(var_19, var_43);
            // if level == 0:                                                                 <L 18>
            var_46 = (var_44 == var_45);
            if (var_46) {
                // searching = 0                                                              <L 19>
            }
            if (!var_46) {
                // inside = children__call(children__levels, children__first, children__boxes, children__around, children__bound, level, node)       <L 21>
                var_48 = nearby_nodes_on_cuda_0(var_children__levels, var_children__first, var_children__boxes, var_children__around, var_children__bound, var_44, var_42);
                // pending = pending | int64(inside) << byte_shift(level)                     <L 22>
                var_49 = wp::int64(var_48);
                var_50 = byte_shift_0(var_44);
                var_51 = wp::lshift(var_49, var_50);
                var_52 = wp::bit_or(var_37, var_51);
            }
            var_53 = wp::where(var_46, var_37, var_52);
            var_54 = wp::where(var_46, var_47, var_22);
        }
        if (!var_31) {
            // elif level == height:                                                          <L 23>
            var_55 = (var_19 == var_2);
            if (var_55) {
                // height = height + 1                                                        <L 24>
                var_57 = wp::add(var_2, var_56);
                // if height > root:                                                          <L 25>
                var_58 = (var_57 > var_root);
                if (var_58) {
                    // searching = 0                                                          <L 26>
                }
                if (!var_58) {
                    // own = 1 << node % FAN                                                  <L 28>
                    var_61 = wp::mod(var_20, var_17);
                    var_62 = wp::lshift(var_60, var_61);
                    // node = node // FAN                                                     <L 29>
                    var_63 = wp::floordiv(var_20, var_17);
                    // level = level + 1                                                      <L 30>
                    var_65 = wp::add(var_19, var_64);
                    // others = children__call(children__levels, children__first, children__boxes, children__around, children__bound, level, node) & BYTE - own       <L 31>
                    var_66 = nearby_nodes_on_cuda_0(var_children__levels, var_children__first, var_children__boxes, var_children__around, var_children__bound, var_65, var_63);
                    var_67 = wp::sub(var_28, var_62);
                    var_68 = wp::bit_and(var_66, var_67);
                    // pending = pending | int64(others) << byte_shift(level)                 <L 32>
                    var_69 = wp::int64(var_68);
                    var_70 = byte_shift_0(var_65);
                    var_71 = wp::lshift(var_69, var_70);
                    var_72 = wp::bit_or(var_10, var_71);
                }
                var_73 = wp::where(var_58, var_19, var_65);
                var_74 = wp::where(var_58, var_20, var_63);
                var_75 = wp::where(var_58, var_10, var_72);
                var_76 = wp::where(var_58, var_59, var_22);
            }
            if (!var_55) {
                // node = node // FAN                                                         <L 34>
                var_77 = wp::floordiv(var_20, var_17);
                // level = level + 1                                                          <L 35>
                var_79 = wp::add(var_19, var_78);
            }
            var_80 = wp::where(var_55, var_57, var_2);
            var_81 = wp::where(var_55, var_73, var_79);
            var_82 = wp::where(var_55, var_74, var_77);
            var_83 = wp::where(var_55, var_75, var_10);
            var_84 = wp::where(var_55, var_76, var_22);
        }
        var_85 = wp::where(var_31, var_2, var_80);
        var_86 = wp::where(var_31, var_44, var_81);
        var_87 = wp::where(var_31, var_42, var_82);
        var_88 = wp::where(var_31, var_53, var_83);
        var_89 = wp::where(var_31, var_54, var_84);
        wp::assign(var_2, var_85);
        wp::assign(var_19, var_86);
        wp::assign(var_20, var_87);
        wp::assign(var_10, var_88);
        wp::assign(var_22, var_89);
    goto start_while_0;
    end_while_0:;
    // return traversal(int64(height), int64(level), int64(node), pending)                    <L 36>
    var_90 = wp::int64(var_2);
    var_91 = wp::int64(var_19);
    var_92 = wp::int64(var_20);
    var_93 = wp::vec_t<4, wp::int64>(var_90, var_91, var_92, var_10);
    return var_93;
}


// <pointloom.kernels.search.lane_search.next_bucket_of_lanes>:1
static CUDA_CALLABLE wp::vec_t<4, wp::int64> next_bucket_of_lanes_on_cuda_0(
    wp::vec_t<4, wp::int64> var_step,
    wp::vec_t<12, wp::float32> var_around,
    wp::float32 var_bound,
    wp::int32 var_tree__root,
    wp::array_t<wp::int32> var_tree__levels,
    wp::array_t<wp::float32> var_tree__boxes)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::vec_t<4, wp::int64> var_1;
    //---------
    // forward
    // def next_bucket_of_lanes(step, around, bound, tree__root, tree__levels, tree__boxes):       <L 1>
    // return next_step__nearby_nodes(step, tree__root, tree__levels, 0, tree__boxes, around, bound)       <L 2>
    var_1 = next_step__nearby_nodes_on_cuda_0(var_step, var_tree__root, var_tree__levels, var_0, var_tree__boxes, var_around, var_bound);
    return var_1;
}


// <pointloom.kernels.search.lane_search.list_leaves>:1
static CUDA_CALLABLE wp::int32 list_leaves_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::float32 var_max_sqdist,
    wp::int32 var_start,
    wp::int32 var_tree__root,
    wp::array_t<wp::int32> var_tree__levels,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::array_t<wp::int32> var_scratch__ids,
    wp::int32 var_scratch__gather,
    wp::int32 var_listing)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 1;
    wp::vec_t<12, wp::float32> var_1;
    wp::float32 var_2;
    wp::int32 var_3;
    const wp::int32 var_4 = 0;
    wp::int32 var_5;
    wp::vec_t<4, wp::int64> var_6;
    bool var_7;
    const wp::int32 var_8 = 0;
    wp::int64 var_9;
    wp::int32 var_10;
    bool var_11;
    bool var_12;
    const wp::int32 var_13 = 2;
    wp::int64 var_14;
    wp::int32 var_15;
    wp::int32 var_16;
    const wp::int32 var_17 = 1;
    wp::int32 var_18;
    const wp::int32 var_19 = 1;
    wp::int32 var_20;
    wp::int32 var_21;
    wp::int32 var_22;
    wp::int32 var_23;
    bool var_24;
    const wp::int32 var_25 = 8;
    bool var_26;
    wp::int32 var_27;
    const wp::int32 var_28 = 1;
    wp::int32 var_29;
    const wp::int32 var_30 = 1;
    bool var_31;
    bool var_32;
    const wp::int32 var_33 = 64;
    wp::int32 var_34;
    const wp::int32 var_35 = 8;
    wp::int32 var_36;
    wp::int32 var_37;
    wp::int32 var_38;
    wp::int32 var_39;
    wp::int32 var_40;
    wp::vec_t<4, wp::int64> var_41;
    //---------
    // forward
    // def list_leaves(p, max_sqdist, start, tree__root, tree__levels, tree__boxes, scratch__ids, scratch__gather, listing):       <L 1>
    // around = boxes_of_eight(p, 1)                                                          <L 3>
    var_1 = boxes_of_eight_on_cuda_0(var_p, var_0);
    // widest = max_of_eight(max_sqdist)                                                      <L 4>
    var_2 = max_of_eight_on_cuda_0(var_max_sqdist);
    // own = lane()                                                                           <L 5>
    var_3 = _lane_0();
    // sync_lanes()                                                                           <L 6>
    _sync_lanes_0();
    // size = int(0)                                                                          <L 7>
    var_5 = wp::int(var_4);
    // step = start_traversal(start)                                                          <L 8>
    var_6 = start_traversal_0(var_start);
    // while int(step[0]) <= tree__root and size <= scratch__gather:                          <L 9>
    start_while_0:;
    var_9 = wp::extract(var_6, var_8);
    var_10 = wp::int(var_9);
    var_11 = (var_10 <= var_tree__root);
    var_7 = var_11;
    if (var_7) {
        var_12 = (var_5 <= var_scratch__gather);
        var_7 = var_7 && var_12;
    }
    if ((var_7) == false) goto end_while_0;
        // bucket = int(step[2])                                                              <L 10>
        var_14 = wp::extract(var_6, var_13);
        var_15 = wp::int(var_14);
        // near = nearby_children(tree__boxes, bucket, around, widest)                        <L 11>
        var_16 = nearby_children_on_cuda_0(var_tree__boxes, var_15, var_1, var_2);
        // slot = size + bit_count(near & (1 << own) - 1)                                     <L 12>
        var_18 = wp::lshift(var_17, var_3);
        var_20 = wp::sub(var_18, var_19);
        var_21 = wp::bit_and(var_16, var_20);
        var_22 = wp::bit_count(var_21);
        var_23 = wp::add(var_5, var_22);
        // if own < FAN and near >> own & 1 == 1 and (slot < scratch__gather):                <L 13>
        var_26 = (var_3 < var_25);
        var_24 = var_26;
        if (var_24) {
            var_27 = wp::rshift(var_16, var_3);
            var_29 = wp::bit_and(var_27, var_28);
            var_31 = (var_29 == var_30);
            var_24 = var_24 && var_31;
        }
        if (var_24) {
            var_32 = (var_23 < var_scratch__gather);
            var_24 = var_24 && var_32;
        }
        if (var_24) {
            // scratch__ids[listing + slot] = bucket * BUCKET + own * LEAF                    <L 14>
            var_34 = wp::mul(var_15, var_33);
            var_36 = wp::mul(var_3, var_35);
            var_37 = wp::add(var_34, var_36);
            var_38 = wp::add(var_listing, var_23);
            wp::array_store(var_scratch__ids, var_38, var_37);
        }
        // size += bit_count(near)                                                            <L 15>
        var_39 = wp::bit_count(var_16);
        var_40 = wp::add(var_5, var_39);
        // step = next_bucket_of_lanes(step, around, widest, tree__root, tree__levels, tree__boxes)       <L 16>
        var_41 = next_bucket_of_lanes_on_cuda_0(var_6, var_1, var_2, var_tree__root, var_tree__levels, var_tree__boxes);
        wp::assign(var_5, var_40);
        wp::assign(var_6, var_41);
    goto start_while_0;
    end_while_0:;
    // sync_lanes()                                                                           <L 17>
    _sync_lanes_0();
    // return size                                                                            <L 18>
    return var_5;
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:193
static CUDA_CALLABLE wp::vec_t<24, wp::float32> _load_eight_0(
    wp::array_t<wp::vec_t<3, wp::float32>> points,
    wp::int32 first)
{

    const float4* quads = (const float4*)(points.data + first);
    wp::vec_t<24, float> result;
    for (int k = 0; k < 6; ++k) {
        float4 quad = quads[k];
        result[4 * k] = quad.x; result[4 * k + 1] = quad.y; result[4 * k + 2] = quad.z; result[4 * k + 3] = quad.w;
    }
    return result;
}


// /work/main/src/pointloom/kernels/search/lane_search.py:135
static CUDA_CALLABLE wp::float32 sqdist_of_on_cuda_0(
    wp::vec_t<24, wp::float32> var_leaf,
    wp::int32 var_j,
    wp::vec_t<3, wp::float32> var_p)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 3;
    wp::int32 var_1;
    wp::float32 var_2;
    const wp::int32 var_3 = 3;
    wp::int32 var_4;
    const wp::int32 var_5 = 1;
    wp::int32 var_6;
    wp::float32 var_7;
    const wp::int32 var_8 = 3;
    wp::int32 var_9;
    const wp::int32 var_10 = 2;
    wp::int32 var_11;
    wp::float32 var_12;
    wp::vec_t<3, wp::float32> var_13;
    wp::float32 var_14;
    //---------
    // forward
    // def sqdist_of(leaf: eight_points, j: int, p: vec3) -> float:                           <L 136>
    // return square_distance(p, vec3(leaf[3 * j], leaf[3 * j + 1], leaf[3 * j + 2]))         <L 137>
    var_1 = wp::mul(var_0, var_j);
    var_2 = wp::extract(var_leaf, var_1);
    var_4 = wp::mul(var_3, var_j);
    var_6 = wp::add(var_4, var_5);
    var_7 = wp::extract(var_leaf, var_6);
    var_9 = wp::mul(var_8, var_j);
    var_11 = wp::add(var_9, var_10);
    var_12 = wp::extract(var_leaf, var_11);
    var_13 = wp::vec_t<3, wp::float32>(var_2, var_7, var_12);
    var_14 = square_distance_0(var_p, var_13);
    return var_14;
}


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


// <pointloom.kernels.arrays.packed_keys.pack_bits>:1
static CUDA_CALLABLE wp::int64 pack_bits_0(
    wp::int32 var_bits,
    wp::int32 var_index)
{
    //---------
    // primal vars
    wp::int64 var_0;
    wp::int64 var_1;
    wp::int64 var_2;
    wp::int64 var_3;
    wp::int64 var_4;
    //---------
    // forward
    // def pack_bits(bits, index):                                                            <L 1>
    // return int64(bits) << int64(32) | int64(index)                                         <L 3>
    var_0 = wp::int64(var_bits);
    var_1 = 32ll;
    var_2 = wp::lshift(var_0, var_1);
    var_3 = wp::int64(var_index);
    var_4 = wp::bit_or(var_2, var_3);
    return var_4;
}


// /work/main/src/pointloom/kernels/arrays/packed_keys.py:18
static CUDA_CALLABLE wp::int64 pack_key_0(
    wp::float32 var_number,
    wp::int32 var_index)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int64 var_1;
    //---------
    // forward
    // def pack_key(number: float, index: int) -> int64:                                      <L 19>
    // return pack_bits(float_bits(number), index)                                            <L 20>
    var_0 = _float_bits_0(var_number);
    var_1 = pack_bits_0(var_0, var_index);
    return var_1;
}


// <pointloom.kernels.search.lane_search.keep_near>:1
static CUDA_CALLABLE wp::int32 keep_near_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::float32 var_max_sqdist,
    wp::array_t<wp::vec_t<3, wp::float32>> var_tree__points,
    wp::array_t<wp::int32> var_scratch__ids,
    wp::array_t<wp::int64> var_scratch__keys,
    wp::int32 var_scratch__room,
    wp::int32 var_scratch__stride,
    wp::int32 var_listing,
    wp::int32 var_size,
    wp::int32 var_base)
{
    //---------
    // primal vars
    wp::int32 var_0;
    const wp::int32 var_1 = 8;
    wp::int32 var_2;
    wp::int32 var_3;
    wp::int32 var_4;
    const wp::int32 var_5 = 0;
    wp::int32 var_6;
    wp::range_t var_7;
    wp::int32 var_8;
    wp::int32 var_9;
    wp::int32* var_10;
    wp::int32 var_11;
    wp::int32 var_12;
    wp::vec_t<24, wp::float32> var_13;
    bool var_14;
    const wp::int32 var_15 = 0;
    wp::float32 var_16;
    bool var_17;
    wp::int32 var_18;
    wp::int64 var_19;
    wp::int32 var_20;
    wp::int32 var_21;
    const wp::int32 var_22 = 1;
    wp::float32 var_23;
    bool var_24;
    wp::int32 var_25;
    wp::int64 var_26;
    wp::int32 var_27;
    wp::int32 var_28;
    const wp::int32 var_29 = 2;
    wp::float32 var_30;
    bool var_31;
    wp::int32 var_32;
    wp::int64 var_33;
    wp::int32 var_34;
    wp::int32 var_35;
    const wp::int32 var_36 = 3;
    wp::float32 var_37;
    bool var_38;
    wp::int32 var_39;
    wp::int64 var_40;
    wp::int32 var_41;
    wp::int32 var_42;
    const wp::int32 var_43 = 4;
    wp::float32 var_44;
    bool var_45;
    wp::int32 var_46;
    wp::int64 var_47;
    wp::int32 var_48;
    wp::int32 var_49;
    const wp::int32 var_50 = 5;
    wp::float32 var_51;
    bool var_52;
    wp::int32 var_53;
    wp::int64 var_54;
    wp::int32 var_55;
    wp::int32 var_56;
    const wp::int32 var_57 = 6;
    wp::float32 var_58;
    bool var_59;
    wp::int32 var_60;
    wp::int64 var_61;
    wp::int32 var_62;
    wp::int32 var_63;
    const wp::int32 var_64 = 7;
    wp::float32 var_65;
    bool var_66;
    wp::int32 var_67;
    wp::int64 var_68;
    wp::int32 var_69;
    wp::int32 var_70;
    const wp::int32 var_71 = 0;
    wp::float32 var_72;
    bool var_73;
    const wp::int32 var_74 = 1;
    wp::int32 var_75;
    wp::int32 var_76;
    const wp::int32 var_77 = 1;
    wp::float32 var_78;
    bool var_79;
    const wp::int32 var_80 = 1;
    wp::int32 var_81;
    wp::int32 var_82;
    const wp::int32 var_83 = 2;
    wp::float32 var_84;
    bool var_85;
    const wp::int32 var_86 = 1;
    wp::int32 var_87;
    wp::int32 var_88;
    const wp::int32 var_89 = 3;
    wp::float32 var_90;
    bool var_91;
    const wp::int32 var_92 = 1;
    wp::int32 var_93;
    wp::int32 var_94;
    const wp::int32 var_95 = 4;
    wp::float32 var_96;
    bool var_97;
    const wp::int32 var_98 = 1;
    wp::int32 var_99;
    wp::int32 var_100;
    const wp::int32 var_101 = 5;
    wp::float32 var_102;
    bool var_103;
    const wp::int32 var_104 = 1;
    wp::int32 var_105;
    wp::int32 var_106;
    const wp::int32 var_107 = 6;
    wp::float32 var_108;
    bool var_109;
    const wp::int32 var_110 = 1;
    wp::int32 var_111;
    wp::int32 var_112;
    const wp::int32 var_113 = 7;
    wp::float32 var_114;
    bool var_115;
    const wp::int32 var_116 = 1;
    wp::int32 var_117;
    wp::int32 var_118;
    wp::int32 var_119;
    wp::int32 var_120;
    wp::int32 var_121;
    wp::int32 var_122;
    wp::int32 var_123;
    wp::int32 var_124;
    //---------
    // forward
    // def keep_near(p, max_sqdist, tree__points, scratch__ids, scratch__keys, scratch__room, scratch__stride, listing, size, base):       <L 1>
    // at = base                                                                              <L 3>
    var_0 = wp::copy(var_base);
    // last = base + (scratch__room - LEAF) * scratch__stride                                 <L 4>
    var_2 = wp::sub(var_scratch__room, var_1);
    var_3 = wp::mul(var_2, var_scratch__stride);
    var_4 = wp::add(var_base, var_3);
    // lacking = int(0)                                                                       <L 5>
    var_6 = wp::int(var_5);
    // for entry in range(size):                                                              <L 6>
    var_7 = wp::range(var_size);
    start_for_0:;
        if (iter_cmp(var_7) == 0) goto end_for_0;
        var_8 = wp::iter_next(var_7);
        // first = scratch__ids[listing + entry]                                              <L 7>
        var_9 = wp::add(var_listing, var_8);
        var_10 = wp::address(var_scratch__ids, var_9);
        var_12 = wp::load(var_10);
        var_11 = wp::copy(var_12);
        // leaf = load_eight(tree__points, first)                                             <L 8>
        var_13 = _load_eight_0(var_tree__points, var_11);
        // if at <= last:                                                                     <L 9>
        var_14 = (var_0 <= var_4);
        if (var_14) {
            // for j in range(LEAF):                                                          <L 10>
            // sqdist = sqdist_of(leaf, j, p)                                                 <L 11>
            var_16 = sqdist_of_on_cuda_0(var_13, var_15, var_p);
            // if sqdist <= max_sqdist:                                                       <L 12>
            var_17 = (var_16 <= var_max_sqdist);
            if (var_17) {
                // scratch__keys[at] = pack_key(sqdist, first + j)                            <L 13>
                var_18 = wp::add(var_11, var_15);
                var_19 = pack_key_0(var_16, var_18);
                wp::array_store(var_scratch__keys, var_0, var_19);
                // at += scratch__stride                                                      <L 14>
                var_20 = wp::add(var_0, var_scratch__stride);
            }
            var_21 = wp::where(var_17, var_20, var_0);
            // sqdist = sqdist_of(leaf, j, p)                                                 <L 11>
            var_23 = sqdist_of_on_cuda_0(var_13, var_22, var_p);
            // if sqdist <= max_sqdist:                                                       <L 12>
            var_24 = (var_23 <= var_max_sqdist);
            if (var_24) {
                // scratch__keys[at] = pack_key(sqdist, first + j)                            <L 13>
                var_25 = wp::add(var_11, var_22);
                var_26 = pack_key_0(var_23, var_25);
                wp::array_store(var_scratch__keys, var_21, var_26);
                // at += scratch__stride                                                      <L 14>
                var_27 = wp::add(var_21, var_scratch__stride);
            }
            var_28 = wp::where(var_24, var_27, var_21);
            // sqdist = sqdist_of(leaf, j, p)                                                 <L 11>
            var_30 = sqdist_of_on_cuda_0(var_13, var_29, var_p);
            // if sqdist <= max_sqdist:                                                       <L 12>
            var_31 = (var_30 <= var_max_sqdist);
            if (var_31) {
                // scratch__keys[at] = pack_key(sqdist, first + j)                            <L 13>
                var_32 = wp::add(var_11, var_29);
                var_33 = pack_key_0(var_30, var_32);
                wp::array_store(var_scratch__keys, var_28, var_33);
                // at += scratch__stride                                                      <L 14>
                var_34 = wp::add(var_28, var_scratch__stride);
            }
            var_35 = wp::where(var_31, var_34, var_28);
            // sqdist = sqdist_of(leaf, j, p)                                                 <L 11>
            var_37 = sqdist_of_on_cuda_0(var_13, var_36, var_p);
            // if sqdist <= max_sqdist:                                                       <L 12>
            var_38 = (var_37 <= var_max_sqdist);
            if (var_38) {
                // scratch__keys[at] = pack_key(sqdist, first + j)                            <L 13>
                var_39 = wp::add(var_11, var_36);
                var_40 = pack_key_0(var_37, var_39);
                wp::array_store(var_scratch__keys, var_35, var_40);
                // at += scratch__stride                                                      <L 14>
                var_41 = wp::add(var_35, var_scratch__stride);
            }
            var_42 = wp::where(var_38, var_41, var_35);
            // sqdist = sqdist_of(leaf, j, p)                                                 <L 11>
            var_44 = sqdist_of_on_cuda_0(var_13, var_43, var_p);
            // if sqdist <= max_sqdist:                                                       <L 12>
            var_45 = (var_44 <= var_max_sqdist);
            if (var_45) {
                // scratch__keys[at] = pack_key(sqdist, first + j)                            <L 13>
                var_46 = wp::add(var_11, var_43);
                var_47 = pack_key_0(var_44, var_46);
                wp::array_store(var_scratch__keys, var_42, var_47);
                // at += scratch__stride                                                      <L 14>
                var_48 = wp::add(var_42, var_scratch__stride);
            }
            var_49 = wp::where(var_45, var_48, var_42);
            // sqdist = sqdist_of(leaf, j, p)                                                 <L 11>
            var_51 = sqdist_of_on_cuda_0(var_13, var_50, var_p);
            // if sqdist <= max_sqdist:                                                       <L 12>
            var_52 = (var_51 <= var_max_sqdist);
            if (var_52) {
                // scratch__keys[at] = pack_key(sqdist, first + j)                            <L 13>
                var_53 = wp::add(var_11, var_50);
                var_54 = pack_key_0(var_51, var_53);
                wp::array_store(var_scratch__keys, var_49, var_54);
                // at += scratch__stride                                                      <L 14>
                var_55 = wp::add(var_49, var_scratch__stride);
            }
            var_56 = wp::where(var_52, var_55, var_49);
            // sqdist = sqdist_of(leaf, j, p)                                                 <L 11>
            var_58 = sqdist_of_on_cuda_0(var_13, var_57, var_p);
            // if sqdist <= max_sqdist:                                                       <L 12>
            var_59 = (var_58 <= var_max_sqdist);
            if (var_59) {
                // scratch__keys[at] = pack_key(sqdist, first + j)                            <L 13>
                var_60 = wp::add(var_11, var_57);
                var_61 = pack_key_0(var_58, var_60);
                wp::array_store(var_scratch__keys, var_56, var_61);
                // at += scratch__stride                                                      <L 14>
                var_62 = wp::add(var_56, var_scratch__stride);
            }
            var_63 = wp::where(var_59, var_62, var_56);
            // sqdist = sqdist_of(leaf, j, p)                                                 <L 11>
            var_65 = sqdist_of_on_cuda_0(var_13, var_64, var_p);
            // if sqdist <= max_sqdist:                                                       <L 12>
            var_66 = (var_65 <= var_max_sqdist);
            if (var_66) {
                // scratch__keys[at] = pack_key(sqdist, first + j)                            <L 13>
                var_67 = wp::add(var_11, var_64);
                var_68 = pack_key_0(var_65, var_67);
                wp::array_store(var_scratch__keys, var_63, var_68);
                // at += scratch__stride                                                      <L 14>
                var_69 = wp::add(var_63, var_scratch__stride);
            }
            var_70 = wp::where(var_66, var_69, var_63);
        }
        if (!var_14) {
            // for j in range(LEAF):                                                          <L 16>
            // if sqdist_of(leaf, j, p) <= max_sqdist:                                        <L 17>
            var_72 = sqdist_of_on_cuda_0(var_13, var_71, var_p);
            var_73 = (var_72 <= var_max_sqdist);
            if (var_73) {
                // lacking += 1                                                               <L 18>
                var_75 = wp::add(var_6, var_74);
            }
            var_76 = wp::where(var_73, var_75, var_6);
            // if sqdist_of(leaf, j, p) <= max_sqdist:                                        <L 17>
            var_78 = sqdist_of_on_cuda_0(var_13, var_77, var_p);
            var_79 = (var_78 <= var_max_sqdist);
            if (var_79) {
                // lacking += 1                                                               <L 18>
                var_81 = wp::add(var_76, var_80);
            }
            var_82 = wp::where(var_79, var_81, var_76);
            // if sqdist_of(leaf, j, p) <= max_sqdist:                                        <L 17>
            var_84 = sqdist_of_on_cuda_0(var_13, var_83, var_p);
            var_85 = (var_84 <= var_max_sqdist);
            if (var_85) {
                // lacking += 1                                                               <L 18>
                var_87 = wp::add(var_82, var_86);
            }
            var_88 = wp::where(var_85, var_87, var_82);
            // if sqdist_of(leaf, j, p) <= max_sqdist:                                        <L 17>
            var_90 = sqdist_of_on_cuda_0(var_13, var_89, var_p);
            var_91 = (var_90 <= var_max_sqdist);
            if (var_91) {
                // lacking += 1                                                               <L 18>
                var_93 = wp::add(var_88, var_92);
            }
            var_94 = wp::where(var_91, var_93, var_88);
            // if sqdist_of(leaf, j, p) <= max_sqdist:                                        <L 17>
            var_96 = sqdist_of_on_cuda_0(var_13, var_95, var_p);
            var_97 = (var_96 <= var_max_sqdist);
            if (var_97) {
                // lacking += 1                                                               <L 18>
                var_99 = wp::add(var_94, var_98);
            }
            var_100 = wp::where(var_97, var_99, var_94);
            // if sqdist_of(leaf, j, p) <= max_sqdist:                                        <L 17>
            var_102 = sqdist_of_on_cuda_0(var_13, var_101, var_p);
            var_103 = (var_102 <= var_max_sqdist);
            if (var_103) {
                // lacking += 1                                                               <L 18>
                var_105 = wp::add(var_100, var_104);
            }
            var_106 = wp::where(var_103, var_105, var_100);
            // if sqdist_of(leaf, j, p) <= max_sqdist:                                        <L 17>
            var_108 = sqdist_of_on_cuda_0(var_13, var_107, var_p);
            var_109 = (var_108 <= var_max_sqdist);
            if (var_109) {
                // lacking += 1                                                               <L 18>
                var_111 = wp::add(var_106, var_110);
            }
            var_112 = wp::where(var_109, var_111, var_106);
            // if sqdist_of(leaf, j, p) <= max_sqdist:                                        <L 17>
            var_114 = sqdist_of_on_cuda_0(var_13, var_113, var_p);
            var_115 = (var_114 <= var_max_sqdist);
            if (var_115) {
                // lacking += 1                                                               <L 18>
                var_117 = wp::add(var_112, var_116);
            }
            var_118 = wp::where(var_115, var_117, var_112);
        }
        var_119 = wp::where(var_14, var_70, var_0);
        var_120 = wp::where(var_14, var_6, var_118);
        var_121 = wp::where(var_14, var_64, var_113);
        wp::assign(var_0, var_119);
        wp::assign(var_6, var_120);
        goto start_for_0;
    end_for_0:;
    // return (at - base) // scratch__stride + lacking                                        <L 19>
    var_122 = wp::sub(var_0, var_base);
    var_123 = wp::floordiv(var_122, var_scratch__stride);
    var_124 = wp::add(var_123, var_6);
    return var_124;
}


// <pointloom.kernels.search.neighbor_keys.keep_up_to>:1
static CUDA_CALLABLE wp::int32 keep_up_to_0(
    wp::array_t<wp::int64> var_keys,
    wp::int32 var_base,
    wp::int32 var_stride,
    wp::int32 var_key_count,
    wp::int64 var_limit)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    wp::range_t var_2;
    wp::int32 var_3;
    wp::int32 var_4;
    wp::int32 var_5;
    wp::int64* var_6;
    wp::int64 var_7;
    wp::int64 var_8;
    bool var_9;
    wp::int32 var_10;
    wp::int32 var_11;
    const wp::int32 var_12 = 1;
    wp::int32 var_13;
    wp::int32 var_14;
    //---------
    // forward
    // def keep_up_to(keys, base, stride, key_count, limit):                                  <L 1>
    // size = int(0)                                                                          <L 3>
    var_1 = wp::int(var_0);
    // for j in range(key_count):                                                             <L 4>
    var_2 = wp::range(var_key_count);
    start_for_0:;
        if (iter_cmp(var_2) == 0) goto end_for_0;
        var_3 = wp::iter_next(var_2);
        // key = keys[base + j * stride]                                                      <L 5>
        var_4 = wp::mul(var_3, var_stride);
        var_5 = wp::add(var_base, var_4);
        var_6 = wp::address(var_keys, var_5);
        var_8 = wp::load(var_6);
        var_7 = wp::copy(var_8);
        // if key <= limit:                                                                   <L 6>
        var_9 = (var_7 <= var_limit);
        if (var_9) {
            // keys[base + size * stride] = key                                               <L 7>
            var_10 = wp::mul(var_1, var_stride);
            var_11 = wp::add(var_base, var_10);
            wp::array_store(var_keys, var_11, var_7);
            // size += 1                                                                      <L 8>
            var_13 = wp::add(var_1, var_12);
        }
        var_14 = wp::where(var_9, var_13, var_1);
        wp::assign(var_1, var_14);
        goto start_for_0;
    end_for_0:;
    // return size                                                                            <L 9>
    return var_1;
}


// <pointloom.kernels.search.lane_search.keep_up_to_limit>:1
static CUDA_CALLABLE wp::int32 keep_up_to_limit_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::int64 var_limit,
    wp::array_t<wp::vec_t<3, wp::float32>> var_tree__points,
    wp::array_t<wp::int32> var_scratch__ids,
    wp::array_t<wp::int64> var_scratch__keys,
    wp::int32 var_scratch__room,
    wp::int32 var_scratch__stride,
    wp::int32 var_listing,
    wp::int32 var_size,
    wp::int32 var_base)
{
    //---------
    // primal vars
    wp::float32 var_0;
    wp::int32 var_1;
    const wp::int32 var_2 = -1;
    wp::int32 var_3;
    const wp::int32 var_4 = 8;
    wp::int32 var_5;
    bool var_6;
    wp::int32 var_7;
    wp::int32 var_8;
    //---------
    // forward
    // def keep_up_to_limit(p, limit, tree__points, scratch__ids, scratch__keys, scratch__room, scratch__stride, listing, size, base):       <L 1>
    // near_count = keep_near(p, key_number(limit), tree__points, scratch__ids, scratch__keys, scratch__room, scratch__stride, listing, size, base)       <L 3>
    var_0 = key_number_0(var_limit);
    var_1 = keep_near_on_cuda_0(var_p, var_0, var_tree__points, var_scratch__ids, var_scratch__keys, var_scratch__room, var_scratch__stride, var_listing, var_size, var_base);
    // count = int(-1)                                                                        <L 4>
    var_3 = wp::int(var_2);
    // if near_count <= scratch__room - LEAF:                                                 <L 5>
    var_5 = wp::sub(var_scratch__room, var_4);
    var_6 = (var_1 <= var_5);
    if (var_6) {
        // count = keep_up_to(scratch__keys, base, scratch__stride, near_count, limit)        <L 6>
        var_7 = keep_up_to_0(var_scratch__keys, var_base, var_scratch__stride, var_1, var_limit);
    }
    var_8 = wp::where(var_6, var_7, var_3);
    // return count                                                                           <L 7>
    return var_8;
}


// <pointloom.kernels.search.neighbor_limits.store_members>:1
static CUDA_CALLABLE wp::int32 store_members_on_cuda_0(
    wp::int32 var_thread,
    wp::int32 var_group,
    wp::array_t<wp::int32> var_ranks,
    wp::int32 var_neighborhood__tree__root,
    wp::array_t<wp::int32> var_neighborhood__tree__levels,
    wp::array_t<wp::float32> var_neighborhood__tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> var_neighborhood__tree__points,
    wp::array_t<wp::int64> var_neighborhood__limits,
    wp::array_t<wp::int32> var_scratch__ids,
    wp::array_t<wp::int64> var_scratch__keys,
    wp::int32 var_scratch__room,
    wp::int32 var_scratch__gather,
    wp::int32 var_scratch__stride)
{
    //---------
    // primal vars
    wp::shape_t* var_0;
    const wp::int32 var_1 = 0;
    wp::int32 var_2;
    wp::shape_t var_3;
    const wp::int32 var_4 = 1;
    wp::int32 var_5;
    const wp::int32 var_6 = 32;
    wp::int32 var_7;
    wp::int32 var_8;
    wp::int32 var_9;
    wp::int32 var_10;
    wp::int32* var_11;
    wp::int32 var_12;
    wp::int32 var_13;
    wp::vec_t<3, wp::float32>* var_14;
    wp::vec_t<3, wp::float32> var_15;
    wp::vec_t<3, wp::float32> var_16;
    wp::int64* var_17;
    wp::int64 var_18;
    wp::int64 var_19;
    wp::int32 var_20;
    wp::int32 var_21;
    wp::int32 var_22;
    wp::int32* var_23;
    const wp::int32 var_24 = 64;
    wp::int32 var_25;
    wp::int32 var_26;
    wp::float32 var_27;
    wp::int32 var_28;
    const wp::int32 var_29 = -1;
    wp::int32 var_30;
    bool var_31;
    wp::int32 var_32;
    wp::int32 var_33;
    //---------
    // forward
    // def store_members(thread, group, ranks, neighborhood__tree__root, neighborhood__tree__levels, neighborhood__tree__boxes, neighborhood__tree__points, neighborhood__limits, scratch__ids, scratch__keys, scratch__room, scratch__gather, scratch__stride):       <L 1>
    // last = ranks.shape[0] - 1                                                              <L 3>
    var_0 = &(var_ranks.shape);
    var_3 = wp::load(var_0);
    var_2 = wp::extract(var_3, var_1);
    var_5 = wp::sub(var_2, var_4);
    // rank = ranks[min(group * WARP + lane(), last)]                                         <L 4>
    var_7 = wp::mul(var_group, var_6);
    var_8 = _lane_0();
    var_9 = wp::add(var_7, var_8);
    var_10 = wp::min(var_9, var_5);
    var_11 = wp::address(var_ranks, var_10);
    var_13 = wp::load(var_11);
    var_12 = wp::copy(var_13);
    // p = neighborhood__tree__points[rank]                                                   <L 5>
    var_14 = wp::address(var_neighborhood__tree__points, var_12);
    var_16 = wp::load(var_14);
    var_15 = wp::copy(var_16);
    // limit = neighborhood__limits[rank]                                                     <L 6>
    var_17 = wp::address(var_neighborhood__limits, var_12);
    var_19 = wp::load(var_17);
    var_18 = wp::copy(var_19);
    // listing = thread // WARP * scratch__gather                                             <L 7>
    var_20 = wp::floordiv(var_thread, var_6);
    var_21 = wp::mul(var_20, var_scratch__gather);
    // start = ranks[group * WARP] // BUCKET                                                  <L 8>
    var_22 = wp::mul(var_group, var_6);
    var_23 = wp::address(var_ranks, var_22);
    var_26 = wp::load(var_23);
    var_25 = wp::floordiv(var_26, var_24);
    // listed = list_leaves(p, key_number(limit), start, neighborhood__tree__root, neighborhood__tree__levels, neighborhood__tree__boxes, scratch__ids, scratch__gather, listing)       <L 9>
    var_27 = key_number_0(var_18);
    var_28 = list_leaves_on_cuda_0(var_15, var_27, var_25, var_neighborhood__tree__root, var_neighborhood__tree__levels, var_neighborhood__tree__boxes, var_scratch__ids, var_scratch__gather, var_21);
    // key_count = int(-1)                                                                    <L 10>
    var_30 = wp::int(var_29);
    // if listed <= scratch__gather:                                                          <L 11>
    var_31 = (var_28 <= var_scratch__gather);
    if (var_31) {
        // key_count = keep_up_to_limit(p, limit, neighborhood__tree__points, scratch__ids, scratch__keys, scratch__room, scratch__stride, listing, listed, thread)       <L 12>
        var_32 = keep_up_to_limit_on_cuda_0(var_15, var_18, var_neighborhood__tree__points, var_scratch__ids, var_scratch__keys, var_scratch__room, var_scratch__stride, var_21, var_28, var_thread);
    }
    var_33 = wp::where(var_31, var_32, var_30);
    // return key_count                                                                       <L 13>
    return var_33;
}


// <pointloom.kernels.search.group_scratch.stored_key_of_lane>:1
static CUDA_CALLABLE wp::int64 stored_key_of_lane_on_cuda_0(
    wp::array_t<wp::int64> var_scratch__keys,
    wp::int32 var_scratch__stride,
    wp::int32 var_base,
    wp::int32 var_j)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32 var_1;
    wp::int64* var_2;
    wp::int64 var_3;
    wp::int64 var_4;
    //---------
    // forward
    // def stored_key_of_lane(scratch__keys, scratch__stride, base, j):                       <L 1>
    // return scratch__keys[base + j * scratch__stride]                                       <L 2>
    var_0 = wp::mul(var_j, var_scratch__stride);
    var_1 = wp::add(var_base, var_0);
    var_2 = wp::address(var_scratch__keys, var_1);
    var_4 = wp::load(var_2);
    var_3 = wp::copy(var_4);
    return var_3;
}


// /work/main/src/pointloom/kernels/arrays/packed_keys.py:33
static CUDA_CALLABLE wp::int32 key_index_0(
    wp::int64 var_key)
{
    //---------
    // primal vars
    wp::int64 var_0;
    wp::int64 var_1;
    wp::int32 var_2;
    //---------
    // forward
    // def key_index(key: int64) -> int:                                                      <L 34>
    // return int(key & int64(INDEX_MASK))                                                    <L 35>
    var_0 = 4294967295ll;
    var_1 = wp::bit_and(var_key, var_0);
    var_2 = wp::int(var_1);
    return var_2;
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


// /work/main/src/pointloom/kernels/features/pair_angles.py:46
static CUDA_CALLABLE wp::int32 quick_bins_0(
    wp::vec_t<3, wp::float32> var_d,
    wp::vec_t<3, wp::float32> var_n1,
    wp::vec_t<3, wp::float32> var_n2)
{
    //---------
    // primal vars
    wp::float32 var_0;
    wp::float32 var_1;
    wp::float32 var_2;
    wp::float32 var_3;
    wp::float32 var_4;
    wp::float32 var_5;
    wp::vec_t<3, wp::float32> var_6;
    wp::float32 var_7;
    wp::float32 var_8;
    wp::float32 var_9;
    bool var_10;
    wp::float32 var_11;
    wp::float32 var_12;
    wp::float32 var_13;
    wp::float32 var_14;
    wp::float32 var_15;
    wp::float32 var_16;
    wp::float32 var_17;
    wp::float32 var_18;
    wp::float32 var_19;
    const wp::float32 var_20 = 1.0;
    wp::float32 var_21;
    wp::float32 var_22;
    wp::float32 var_23;
    wp::float32 var_24;
    const wp::float32 var_25 = 5.5;
    wp::float32 var_26;
    wp::float32 var_27;
    wp::float32 var_28;
    wp::float32 var_29;
    wp::float32 var_30;
    wp::float32 var_31;
    wp::float32 var_32;
    wp::float32 var_33;
    wp::float32 var_34;
    wp::float32 var_35;
    const wp::float32 var_36 = 0.9594929736144974;
    wp::float32 var_37;
    const wp::float32 var_38 = 0.2817325568414297;
    wp::float32 var_39;
    wp::float32 var_40;
    const wp::float32 var_41 = 0.6548607339452851;
    wp::float32 var_42;
    const wp::float32 var_43 = 0.7557495743542583;
    wp::float32 var_44;
    wp::float32 var_45;
    const wp::float32 var_46 = 0.1423148382732851;
    wp::float32 var_47;
    const wp::float32 var_48 = 0.9898214418809327;
    wp::float32 var_49;
    wp::float32 var_50;
    const wp::float32 var_51 = -0.4154150130018863;
    wp::float32 var_52;
    const wp::float32 var_53 = 0.9096319953545184;
    wp::float32 var_54;
    wp::float32 var_55;
    const wp::float32 var_56 = -0.8412535328311811;
    wp::float32 var_57;
    const wp::float32 var_58 = 0.5406408174555976;
    wp::float32 var_59;
    wp::float32 var_60;
    const wp::float32 var_61 = 0.0;
    bool var_62;
    wp::int32 var_63;
    const wp::float32 var_64 = 0.0;
    bool var_65;
    wp::int32 var_66;
    wp::int32 var_67;
    const wp::float32 var_68 = 0.0;
    bool var_69;
    wp::int32 var_70;
    wp::int32 var_71;
    const wp::float32 var_72 = 0.0;
    bool var_73;
    wp::int32 var_74;
    wp::int32 var_75;
    const wp::float32 var_76 = 0.0;
    bool var_77;
    wp::int32 var_78;
    wp::int32 var_79;
    wp::float32 var_80;
    wp::float32 var_81;
    wp::float32 var_82;
    wp::float32 var_83;
    wp::float32 var_84;
    wp::float32 var_85;
    wp::float32 var_86;
    wp::float32 var_87;
    wp::float32 var_88;
    const wp::float32 var_89 = 0.0;
    bool var_90;
    wp::float32 var_91;
    wp::float32 var_92;
    wp::float32 var_93;
    wp::float32 var_94;
    wp::float32 var_95;
    wp::float32 var_96;
    wp::float32 var_97;
    wp::float32 var_98;
    const wp::float32 var_99 = 0.05;
    wp::float32 var_100;
    bool var_101;
    wp::int32 var_102;
    const wp::float32 var_103 = 0.95;
    bool var_104;
    wp::int32 var_105;
    wp::int32 var_106;
    wp::float32 var_107;
    wp::float32 var_108;
    const wp::float32 var_109 = 1e-06;
    bool var_110;
    wp::int32 var_111;
    wp::int32 var_112;
    const wp::int32 var_113 = 3;
    bool var_114;
    wp::float32 var_115;
    const wp::float32 var_116 = 1e-30;
    bool var_117;
    wp::int32 var_118;
    const wp::float32 var_119 = 0.0001;
    wp::float32 var_120;
    bool var_121;
    wp::int32 var_122;
    wp::int32 var_123;
    wp::float32 var_124;
    const wp::float32 var_125 = 4e-06;
    wp::float32 var_126;
    bool var_127;
    wp::int32 var_128;
    wp::int32 var_129;
    wp::float32 var_130;
    const wp::float32 var_131 = 0.5;
    wp::float32 var_132;
    wp::float32 var_133;
    const wp::float32 var_134 = 0.5;
    const wp::float32 var_135 = 2e-05;
    wp::float32 var_136;
    wp::float32 var_137;
    bool var_138;
    wp::int32 var_139;
    wp::int32 var_140;
    wp::float32 var_141;
    const wp::float32 var_142 = 0.5;
    wp::float32 var_143;
    wp::float32 var_144;
    const wp::float32 var_145 = 0.5;
    const wp::float32 var_146 = 1e-05;
    wp::float32 var_147;
    bool var_148;
    wp::int32 var_149;
    wp::int32 var_150;
    const wp::float32 var_151 = 2e-06;
    wp::float32 var_152;
    bool var_153;
    wp::int32 var_154;
    wp::int32 var_155;
    wp::float32 var_156;
    const wp::float32 var_157 = 1.00005;
    bool var_158;
    wp::int32 var_159;
    wp::int32 var_160;
    const wp::float32 var_161 = 0.0;
    bool var_162;
    const wp::int32 var_163 = 5;
    wp::int32 var_164;
    wp::int32 var_165;
    wp::int32 var_166;
    const wp::float32 var_167 = 0.0;
    wp::float32 var_168;
    const wp::float32 var_169 = 10.0;
    wp::float32 var_170;
    wp::int32 var_171;
    const wp::float32 var_172 = 0.0;
    wp::float32 var_173;
    const wp::float32 var_174 = 10.0;
    wp::float32 var_175;
    wp::int32 var_176;
    const wp::int32 var_177 = 4;
    wp::int32 var_178;
    wp::int32 var_179;
    const wp::int32 var_180 = 2;
    wp::int32 var_181;
    wp::int32 var_182;
    wp::int32 var_183;
    const wp::int32 var_184 = 7;
    bool var_185;
    const wp::int32 var_186 = -1;
    wp::int32 var_187;
    //---------
    // forward
    // def quick_bins(d: vec3, n1: vec3, n2: vec3) -> int:                                    <L 47>
    // sqdist = dot(d, d)                                                                     <L 49>
    var_0 = wp::dot(var_d, var_d);
    // along1 = dot(n1, d)                                                                    <L 50>
    var_1 = wp::dot(var_n1, var_d);
    // along2 = dot(n2, d)                                                                    <L 51>
    var_2 = wp::dot(var_n2, var_d);
    // sqlength1 = dot(n1, n1)                                                                <L 52>
    var_3 = wp::dot(var_n1, var_n1);
    // sqlength2 = dot(n2, n2)                                                                <L 53>
    var_4 = wp::dot(var_n2, var_n2);
    // normal_dot = dot(n1, n2)                                                               <L 54>
    var_5 = wp::dot(var_n1, var_n2);
    // side = dot(cross(d, n1), n2)                                                           <L 55>
    var_6 = wp::cross(var_d, var_n1);
    var_7 = wp::dot(var_6, var_n2);
    // ordered = abs(along1) >= abs(along2)                                                   <L 56>
    var_8 = wp::abs(var_1);
    var_9 = wp::abs(var_2);
    var_10 = (var_8 >= var_9);
    // a = along1 if ordered else -along2                                                     <L 57>
    if (var_10) {
    }
    if (!var_10) {
        var_11 = wp::neg(var_2);
    }
    var_12 = wp::where(var_10, var_1, var_11);
    // b = along2 if ordered else -along1                                                     <L 58>
    if (var_10) {
    }
    if (!var_10) {
        var_13 = wp::neg(var_1);
    }
    var_14 = wp::where(var_10, var_2, var_13);
    // sqlength = sqlength1 if ordered else sqlength2                                         <L 59>
    if (var_10) {
    }
    if (!var_10) {
    }
    var_15 = wp::where(var_10, var_3, var_4);
    // square = sqdist * sqlength                                                             <L 60>
    var_16 = wp::mul(var_0, var_15);
    // across = square - a * a  # |d x a|^2                                                   <L 61>
    var_17 = wp::mul(var_12, var_12);
    var_18 = wp::sub(var_16, var_17);
    // distance = sqrt(sqdist)                                                                <L 62>
    var_19 = wp::sqrt(var_0);
    // inverse = 1.0 / sqrt(across)                                                           <L 63>
    var_21 = wp::sqrt(var_18);
    var_22 = wp::div(var_20, var_21);
    // ratio = square / across                                                                <L 64>
    var_23 = wp::div(var_16, var_18);
    // f1 = side * inverse * HALF_BINS + HALF_BINS                                            <L 65>
    var_24 = wp::mul(var_7, var_22);
    var_26 = wp::mul(var_24, var_25);
    var_27 = wp::add(var_26, var_25);
    // f2 = a / distance * HALF_BINS + HALF_BINS                                              <L 66>
    var_28 = wp::div(var_12, var_19);
    var_29 = wp::mul(var_28, var_25);
    var_30 = wp::add(var_29, var_25);
    // y = (b * sqlength - normal_dot * a) * inverse                                          <L 67>
    var_31 = wp::mul(var_14, var_15);
    var_32 = wp::mul(var_5, var_12);
    var_33 = wp::sub(var_31, var_32);
    var_34 = wp::mul(var_33, var_22);
    // height = abs(y)                                                                        <L 68>
    var_35 = wp::abs(var_34);
    // t1 = COS_1 * height - SIN_1 * normal_dot                                               <L 69>
    var_37 = wp::mul(var_36, var_35);
    var_39 = wp::mul(var_38, var_5);
    var_40 = wp::sub(var_37, var_39);
    // t3 = COS_3 * height - SIN_3 * normal_dot                                               <L 70>
    var_42 = wp::mul(var_41, var_35);
    var_44 = wp::mul(var_43, var_5);
    var_45 = wp::sub(var_42, var_44);
    // t5 = COS_5 * height - SIN_5 * normal_dot                                               <L 71>
    var_47 = wp::mul(var_46, var_35);
    var_49 = wp::mul(var_48, var_5);
    var_50 = wp::sub(var_47, var_49);
    // t7 = COS_7 * height - SIN_7 * normal_dot                                               <L 72>
    var_52 = wp::mul(var_51, var_35);
    var_54 = wp::mul(var_53, var_5);
    var_55 = wp::sub(var_52, var_54);
    // t9 = COS_9 * height - SIN_9 * normal_dot                                               <L 73>
    var_57 = wp::mul(var_56, var_35);
    var_59 = wp::mul(var_58, var_5);
    var_60 = wp::sub(var_57, var_59);
    // sectors = int(t1 > 0.0) + int(t3 > 0.0) + int(t5 > 0.0) + int(t7 > 0.0) + int(t9 > 0.0)       <L 74>
    var_62 = (var_40 > var_61);
    var_63 = wp::int(var_62);
    var_65 = (var_45 > var_64);
    var_66 = wp::int(var_65);
    var_67 = wp::add(var_63, var_66);
    var_69 = (var_50 > var_68);
    var_70 = wp::int(var_69);
    var_71 = wp::add(var_67, var_70);
    var_73 = (var_55 > var_72);
    var_74 = wp::int(var_73);
    var_75 = wp::add(var_71, var_74);
    var_77 = (var_60 > var_76);
    var_78 = wp::int(var_77);
    var_79 = wp::add(var_75, var_78);
    // border = smaller(smaller(smaller(abs(t1), abs(t3)), smaller(abs(t5), abs(t7))), abs(t9))       <L 75>
    var_80 = wp::abs(var_40);
    var_81 = wp::abs(var_45);
    var_82 = smaller_0(var_80, var_81);
    var_83 = wp::abs(var_50);
    var_84 = wp::abs(var_55);
    var_85 = smaller_0(var_83, var_84);
    var_86 = smaller_0(var_82, var_85);
    var_87 = wp::abs(var_60);
    var_88 = smaller_0(var_86, var_87);
    // seam = height if normal_dot < 0.0 else border                                          <L 76>
    var_90 = (var_5 < var_89);
    if (var_90) {
    }
    if (!var_90) {
    }
    var_91 = wp::where(var_90, var_35, var_88);
    // level1 = floor(f1)                                                                     <L 77>
    var_92 = wp::floor(var_27);
    // level2 = floor(f2)                                                                     <L 78>
    var_93 = wp::floor(var_30);
    // tie = abs(abs(along1) - abs(along2))                                                   <L 79>
    var_94 = wp::abs(var_1);
    var_95 = wp::abs(var_2);
    var_96 = wp::sub(var_94, var_95);
    var_97 = wp::abs(var_96);
    // flat = int(abs(a) < FLAT_SLOPE * distance) + int(normal_dot > FLAT_COSINE)             <L 80>
    var_98 = wp::abs(var_12);
    var_100 = wp::mul(var_99, var_19);
    var_101 = (var_98 < var_100);
    var_102 = wp::int(var_101);
    var_104 = (var_5 > var_103);
    var_105 = wp::int(var_104);
    var_106 = wp::add(var_102, var_105);
    // alike = int(abs(sqlength1 - sqlength2) < SAME_LENGTH)                                  <L 81>
    var_107 = wp::sub(var_3, var_4);
    var_108 = wp::abs(var_107);
    var_110 = (var_108 < var_109);
    var_111 = wp::int(var_110);
    // gap = distance if flat + alike == 3 else tie                                           <L 82>
    var_112 = wp::add(var_106, var_111);
    var_114 = (var_112 == var_113);
    if (var_114) {
    }
    if (!var_114) {
    }
    var_115 = wp::where(var_114, var_19, var_97);
    // sure = (                                                                               <L 84>
    // int(sqdist > SMALL)                                                                    <L 85>
    var_117 = (var_0 > var_116);
    var_118 = wp::int(var_117);
    // + int(across > square * STEEP)                                                         <L 86>
    var_120 = wp::mul(var_16, var_119);
    var_121 = (var_18 > var_120);
    var_122 = wp::int(var_121);
    var_123 = wp::add(var_118, var_122);
    // + int(smaller(border, seam) > SECTOR_MARGIN * ratio)                                   <L 87>
    var_124 = smaller_0(var_88, var_91);
    var_126 = wp::mul(var_125, var_23);
    var_127 = (var_124 > var_126);
    var_128 = wp::int(var_127);
    var_129 = wp::add(var_123, var_128);
    // + int(abs(f1 - level1 - 0.5) < 0.5 - SIDE_MARGIN * ratio)                              <L 88>
    var_130 = wp::sub(var_27, var_92);
    var_132 = wp::sub(var_130, var_131);
    var_133 = wp::abs(var_132);
    var_136 = wp::mul(var_135, var_23);
    var_137 = wp::sub(var_134, var_136);
    var_138 = (var_133 < var_137);
    var_139 = wp::int(var_138);
    var_140 = wp::add(var_129, var_139);
    // + int(abs(f2 - level2 - 0.5) < 0.5 - SLOPE_MARGIN)                                     <L 89>
    var_141 = wp::sub(var_30, var_93);
    var_143 = wp::sub(var_141, var_142);
    var_144 = wp::abs(var_143);
    var_147 = wp::sub(var_145, var_146);
    var_148 = (var_144 < var_147);
    var_149 = wp::int(var_148);
    var_150 = wp::add(var_140, var_149);
    // + int(gap > TIE_MARGIN * distance)                                                     <L 90>
    var_152 = wp::mul(var_151, var_19);
    var_153 = (var_115 > var_152);
    var_154 = wp::int(var_153);
    var_155 = wp::add(var_150, var_154);
    // + int(larger(sqlength1, sqlength2) < LONGEST)                                          <L 91>
    var_156 = larger_0(var_3, var_4);
    var_158 = (var_156 < var_157);
    var_159 = wp::int(var_158);
    var_160 = wp::add(var_155, var_159);
    // bin0 = MIDDLE + sectors if y >= 0.0 else MIDDLE - sectors                              <L 93>
    var_162 = (var_34 >= var_161);
    if (var_162) {
        var_164 = wp::add(var_163, var_79);
    }
    if (!var_162) {
        var_165 = wp::sub(var_163, var_79);
    }
    var_166 = wp::where(var_162, var_164, var_165);
    // bin1 = int(smaller(larger(level1, 0.0), 10.0))                                         <L 94>
    var_168 = larger_0(var_92, var_167);
    var_170 = smaller_0(var_168, var_169);
    var_171 = wp::int(var_170);
    // bin2 = int(smaller(larger(level2, 0.0), 10.0))                                         <L 95>
    var_173 = larger_0(var_93, var_172);
    var_175 = smaller_0(var_173, var_174);
    var_176 = wp::int(var_175);
    // bins = bin0 | (bin1 << BIN_BITS) | (bin2 << (2 * BIN_BITS))                            <L 96>
    var_178 = wp::lshift(var_171, var_177);
    var_179 = wp::bit_or(var_166, var_178);
    var_181 = wp::mul(var_180, var_177);
    var_182 = wp::lshift(var_176, var_181);
    var_183 = wp::bit_or(var_179, var_182);
    // return bins if sure == 7 else UNSURE                                                   <L 97>
    var_185 = (var_160 == var_184);
    if (var_185) {
    }
    if (!var_185) {
    }
    var_187 = wp::where(var_185, var_183, var_186);
    return var_187;
}


// <pointloom.kernels.features.pair_angles.bin_of>:1
static CUDA_CALLABLE wp::int32 bin_of_0(
    wp::float64 var_level)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::float64 var_1;
    wp::float64 var_2;
    wp::float64 var_3;
    wp::float64 var_4;
    wp::int32 var_5;
    //---------
    // forward
    // def bin_of(level):                                                                     <L 1>
    // return int(min(max(floor(level), float64(0.0)), float64(10.0)))                        <L 3>
    var_0 = wp::floor(var_level);
    var_1 = 0.0;
    var_2 = wp::max(var_0, var_1);
    var_3 = 10.0;
    var_4 = wp::min(var_2, var_3);
    var_5 = wp::int(var_4);
    return var_5;
}


// <pointloom.kernels.features.pair_angles.exact_bins>:1
static CUDA_CALLABLE wp::int32 exact_bins_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> var_n,
    wp::vec_t<3, wp::float32> var_q,
    wp::vec_t<3, wp::float32> var_m)
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
    const wp::int32 var_10 = 0;
    wp::float32 var_11;
    wp::float64 var_12;
    const wp::int32 var_13 = 1;
    wp::float32 var_14;
    wp::float64 var_15;
    const wp::int32 var_16 = 2;
    wp::float32 var_17;
    wp::float64 var_18;
    wp::vec_t<3, wp::float64> var_19;
    wp::vec_t<3, wp::float64> var_20;
    const wp::int32 var_21 = 0;
    wp::float32 var_22;
    wp::float64 var_23;
    const wp::int32 var_24 = 1;
    wp::float32 var_25;
    wp::float64 var_26;
    const wp::int32 var_27 = 2;
    wp::float32 var_28;
    wp::float64 var_29;
    wp::vec_t<3, wp::float64> var_30;
    const wp::int32 var_31 = 0;
    wp::float32 var_32;
    wp::float64 var_33;
    const wp::int32 var_34 = 1;
    wp::float32 var_35;
    wp::float64 var_36;
    const wp::int32 var_37 = 2;
    wp::float32 var_38;
    wp::float64 var_39;
    wp::vec_t<3, wp::float64> var_40;
    wp::float64 var_41;
    wp::float64 var_42;
    wp::float64 var_43;
    wp::float64 var_44;
    wp::float64 var_45;
    wp::float64 var_46;
    bool var_47;
    wp::float64 var_48;
    wp::float64 var_49;
    wp::float64 var_50;
    wp::float64 var_51;
    wp::float64 var_52;
    bool var_53;
    wp::float64 var_54;
    bool var_55;
    wp::float64 var_56;
    wp::float64 var_57;
    wp::float64 var_58;
    wp::float64 var_59;
    wp::float64 var_60;
    bool var_61;
    const wp::int32 var_62 = 0;
    wp::float32 var_63;
    wp::float64 var_64;
    const wp::int32 var_65 = 1;
    wp::float32 var_66;
    wp::float64 var_67;
    const wp::int32 var_68 = 2;
    wp::float32 var_69;
    wp::float64 var_70;
    wp::vec_t<3, wp::float64> var_71;
    const wp::int32 var_72 = 0;
    wp::float32 var_73;
    wp::float64 var_74;
    const wp::int32 var_75 = 1;
    wp::float32 var_76;
    wp::float64 var_77;
    const wp::int32 var_78 = 2;
    wp::float32 var_79;
    wp::float64 var_80;
    wp::vec_t<3, wp::float64> var_81;
    wp::vec_t<3, wp::float64> var_82;
    wp::float64 var_83;
    wp::vec_t<3, wp::float64> var_84;
    wp::vec_t<3, wp::float64> var_85;
    wp::vec_t<3, wp::float64> var_86;
    wp::float64 var_87;
    wp::vec_t<3, wp::float64> var_88;
    wp::float64 var_89;
    wp::float64 var_90;
    wp::float64 var_91;
    bool var_92;
    wp::vec_t<3, wp::float64> var_93;
    wp::vec_t<3, wp::float64> var_94;
    wp::float64 var_95;
    wp::float64 var_96;
    wp::float64 var_97;
    wp::float64 var_98;
    wp::float64 var_99;
    wp::float64 var_100;
    wp::float64 var_101;
    wp::float64 var_102;
    wp::vec_t<3, wp::float64> var_103;
    wp::vec_t<3, wp::float64> var_104;
    wp::vec_t<3, wp::float64> var_105;
    wp::vec_t<3, wp::float64> var_106;
    wp::float64 var_107;
    wp::float64 var_108;
    wp::float64 var_109;
    wp::float64 var_110;
    wp::float64 var_111;
    wp::float64 var_112;
    wp::float64 var_113;
    wp::float64 var_114;
    wp::float64 var_115;
    wp::float64 var_116;
    wp::int32 var_117;
    wp::float64 var_118;
    wp::float64 var_119;
    wp::float64 var_120;
    wp::float64 var_121;
    wp::float64 var_122;
    wp::int32 var_123;
    wp::float64 var_124;
    wp::float64 var_125;
    wp::float64 var_126;
    wp::float64 var_127;
    wp::float64 var_128;
    wp::int32 var_129;
    const wp::int32 var_130 = 4;
    wp::int32 var_131;
    wp::int32 var_132;
    const wp::int32 var_133 = 2;
    wp::int32 var_134;
    wp::int32 var_135;
    wp::int32 var_136;
    //---------
    // forward
    // def exact_bins(p, n, q, m):                                                            <L 1>
    // d = vec3d(float64(q[0]), float64(q[1]), float64(q[2])) - vec3d(float64(p[0]), float64(p[1]), float64(p[2]))       <L 3>
    var_1 = wp::extract(var_q, var_0);
    var_2 = wp::float64(var_1);
    var_4 = wp::extract(var_q, var_3);
    var_5 = wp::float64(var_4);
    var_7 = wp::extract(var_q, var_6);
    var_8 = wp::float64(var_7);
    var_9 = wp::vec_t<3, wp::float64>(var_2, var_5, var_8);
    var_11 = wp::extract(var_p, var_10);
    var_12 = wp::float64(var_11);
    var_14 = wp::extract(var_p, var_13);
    var_15 = wp::float64(var_14);
    var_17 = wp::extract(var_p, var_16);
    var_18 = wp::float64(var_17);
    var_19 = wp::vec_t<3, wp::float64>(var_12, var_15, var_18);
    var_20 = wp::sub(var_9, var_19);
    // a = vec3d(float64(n[0]), float64(n[1]), float64(n[2]))                                 <L 4>
    var_22 = wp::extract(var_n, var_21);
    var_23 = wp::float64(var_22);
    var_25 = wp::extract(var_n, var_24);
    var_26 = wp::float64(var_25);
    var_28 = wp::extract(var_n, var_27);
    var_29 = wp::float64(var_28);
    var_30 = wp::vec_t<3, wp::float64>(var_23, var_26, var_29);
    // b = vec3d(float64(m[0]), float64(m[1]), float64(m[2]))                                 <L 5>
    var_32 = wp::extract(var_m, var_31);
    var_33 = wp::float64(var_32);
    var_35 = wp::extract(var_m, var_34);
    var_36 = wp::float64(var_35);
    var_38 = wp::extract(var_m, var_37);
    var_39 = wp::float64(var_38);
    var_40 = wp::vec_t<3, wp::float64>(var_33, var_36, var_39);
    // f0 = float64(0.0)                                                                      <L 6>
    var_41 = 0.0;
    // f1 = float64(0.0)                                                                      <L 7>
    var_42 = 0.0;
    // f2 = float64(0.0)                                                                      <L 8>
    var_43 = 0.0;
    // distance = sqrt(dot(d, d))                                                             <L 9>
    var_44 = wp::dot(var_20, var_20);
    var_45 = wp::sqrt(var_44);
    // if distance > float64(0.0):                                                            <L 10>
    var_46 = 0.0;
    var_47 = (var_45 > var_46);
    if (var_47) {
        // slope = dot(a, d) / distance                                                       <L 11>
        var_48 = wp::dot(var_30, var_20);
        var_49 = wp::div(var_48, var_45);
        // slope2 = dot(b, d) / distance                                                      <L 12>
        var_50 = wp::dot(var_40, var_20);
        var_51 = wp::div(var_50, var_45);
        // one = float64(1.0)                                                                 <L 13>
        var_52 = 1.0;
        // if abs(slope2) <= one and acos(min(abs(slope), one)) > acos(abs(slope2)):          <L 14>
        var_54 = wp::abs(var_51);
        var_55 = (var_54 <= var_52);
        var_53 = var_55;
        if (var_53) {
            var_56 = wp::abs(var_49);
            var_57 = wp::min(var_56, var_52);
            var_58 = wp::acos(var_57);
            var_59 = wp::abs(var_51);
            var_60 = wp::acos(var_59);
            var_61 = (var_58 > var_60);
            var_53 = var_53 && var_61;
        }
        if (var_53) {
            // a = vec3d(float64(m[0]), float64(m[1]), float64(m[2]))                         <L 15>
            var_63 = wp::extract(var_m, var_62);
            var_64 = wp::float64(var_63);
            var_66 = wp::extract(var_m, var_65);
            var_67 = wp::float64(var_66);
            var_69 = wp::extract(var_m, var_68);
            var_70 = wp::float64(var_69);
            var_71 = wp::vec_t<3, wp::float64>(var_64, var_67, var_70);
            // b = vec3d(float64(n[0]), float64(n[1]), float64(n[2]))                         <L 16>
            var_73 = wp::extract(var_n, var_72);
            var_74 = wp::float64(var_73);
            var_76 = wp::extract(var_n, var_75);
            var_77 = wp::float64(var_76);
            var_79 = wp::extract(var_n, var_78);
            var_80 = wp::float64(var_79);
            var_81 = wp::vec_t<3, wp::float64>(var_74, var_77, var_80);
            // d = -d                                                                         <L 17>
            var_82 = wp::neg(var_20);
            // slope = -slope2                                                                <L 18>
            var_83 = wp::neg(var_51);
        }
        var_84 = wp::where(var_53, var_82, var_20);
        var_85 = wp::where(var_53, var_71, var_30);
        var_86 = wp::where(var_53, var_81, var_40);
        var_87 = wp::where(var_53, var_83, var_49);
        // v = cross(d, a)                                                                    <L 19>
        var_88 = wp::cross(var_84, var_85);
        // size = sqrt(dot(v, v))                                                             <L 20>
        var_89 = wp::dot(var_88, var_88);
        var_90 = wp::sqrt(var_89);
        // if size > float64(0.0):                                                            <L 21>
        var_91 = 0.0;
        var_92 = (var_90 > var_91);
        if (var_92) {
            // v = v / size                                                                   <L 22>
            var_93 = wp::div(var_88, var_90);
            // f0 = atan2(dot(cross(a, v), b), dot(a, b))                                     <L 23>
            var_94 = wp::cross(var_85, var_93);
            var_95 = wp::dot(var_94, var_86);
            var_96 = wp::dot(var_85, var_86);
            var_97 = wp::atan2(var_95, var_96);
            // f1 = dot(v, b)                                                                 <L 24>
            var_98 = wp::dot(var_93, var_86);
            // f2 = slope                                                                     <L 25>
            var_99 = wp::copy(var_87);
        }
        var_100 = wp::where(var_92, var_97, var_41);
        var_101 = wp::where(var_92, var_98, var_42);
        var_102 = wp::where(var_92, var_99, var_43);
        var_103 = wp::where(var_92, var_93, var_88);
    }
    var_104 = wp::where(var_47, var_84, var_20);
    var_105 = wp::where(var_47, var_85, var_30);
    var_106 = wp::where(var_47, var_86, var_40);
    var_107 = wp::where(var_47, var_100, var_41);
    var_108 = wp::where(var_47, var_101, var_42);
    var_109 = wp::where(var_47, var_102, var_43);
    // bins = float64(11.0)                                                                   <L 26>
    var_110 = 11.0;
    // pi = float64(PI)                                                                       <L 27>
    var_111 = 3.141592653589793;
    // bin0 = bin_of(bins * (f0 + pi) / (float64(2.0) * pi))                                  <L 28>
    var_112 = wp::add(var_107, var_111);
    var_113 = wp::mul(var_110, var_112);
    var_114 = 2.0;
    var_115 = wp::mul(var_114, var_111);
    var_116 = wp::div(var_113, var_115);
    var_117 = bin_of_0(var_116);
    // bin1 = bin_of(bins * (f1 + float64(1.0)) * float64(0.5))                               <L 29>
    var_118 = 1.0;
    var_119 = wp::add(var_108, var_118);
    var_120 = wp::mul(var_110, var_119);
    var_121 = 0.5;
    var_122 = wp::mul(var_120, var_121);
    var_123 = bin_of_0(var_122);
    // bin2 = bin_of(bins * (f2 + float64(1.0)) * float64(0.5))                               <L 30>
    var_124 = 1.0;
    var_125 = wp::add(var_109, var_124);
    var_126 = wp::mul(var_110, var_125);
    var_127 = 0.5;
    var_128 = wp::mul(var_126, var_127);
    var_129 = bin_of_0(var_128);
    // return bin0 | bin1 << BIN_BITS | bin2 << 2 * BIN_BITS                                  <L 31>
    var_131 = wp::lshift(var_123, var_130);
    var_132 = wp::bit_or(var_117, var_131);
    var_134 = wp::mul(var_133, var_130);
    var_135 = wp::lshift(var_129, var_134);
    var_136 = wp::bit_or(var_132, var_135);
    return var_136;
}


// /work/main/src/pointloom/kernels/features/pair_angles.py:141
static CUDA_CALLABLE wp::int32 resolved_bins_0(
    wp::int32 var_bins,
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> var_n,
    wp::vec_t<3, wp::float32> var_q,
    wp::vec_t<3, wp::float32> var_m)
{
    //---------
    // primal vars
    wp::int32 var_0;
    const wp::int32 var_1 = -1;
    bool var_2;
    wp::int32 var_3;
    wp::int32 var_4;
    //---------
    // forward
    // def resolved_bins(bins: int, p: vec3, n: vec3, q: vec3, m: vec3) -> int:               <L 142>
    // resolved = bins                                                                        <L 144>
    var_0 = wp::copy(var_bins);
    // if bins == UNSURE:                                                                     <L 145>
    var_2 = (var_bins == var_1);
    if (var_2) {
        // resolved = exact_bins(p, n, q, m)                                                  <L 146>
        var_3 = exact_bins_0(var_p, var_n, var_q, var_m);
    }
    var_4 = wp::where(var_2, var_3, var_0);
    // return resolved                                                                        <L 147>
    return var_4;
}


// <pointloom.kernels.features.fpfh.bin_listed>:1
static CUDA_CALLABLE wp::vec_t<33, wp::int32> bin_listed_on_cuda_0(
    wp::int32 var_rank,
    wp::array_t<wp::vec_t<3, wp::float32>> var_neighborhood__tree__points,
    wp::array_t<wp::int64> var_neighborhood__limits,
    wp::array_t<wp::vec_t<3, wp::float32>> var_normals,
    wp::array_t<wp::int64> var_scratch__keys,
    wp::int32 var_scratch__stride,
    wp::int32 var_base,
    wp::int32 var_stored)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float32>* var_0;
    wp::vec_t<3, wp::float32> var_1;
    wp::vec_t<3, wp::float32> var_2;
    wp::int64* var_3;
    wp::int64 var_4;
    wp::int64 var_5;
    wp::vec_t<3, wp::float32>* var_6;
    wp::vec_t<3, wp::float32> var_7;
    wp::vec_t<3, wp::float32> var_8;
    const wp::int32 var_9 = 0;
    wp::vec_t<33, wp::int32> var_10;
    const wp::float32 var_11 = 0.0;
    wp::vec_t<8, wp::float32> var_12;
    const wp::float32 var_13 = 0.0;
    wp::vec_t<8, wp::float32> var_14;
    const wp::float32 var_15 = 0.0;
    wp::vec_t<8, wp::float32> var_16;
    const wp::float32 var_17 = 0.0;
    wp::vec_t<8, wp::float32> var_18;
    const wp::float32 var_19 = 0.0;
    wp::vec_t<8, wp::float32> var_20;
    const wp::float32 var_21 = 0.0;
    wp::vec_t<8, wp::float32> var_22;
    const wp::int32 var_23 = 0;
    wp::vec_t<8, wp::int32> var_24;
    const wp::int32 var_25 = 8;
    wp::int32 var_26;
    const wp::int32 var_27 = 1;
    wp::int32 var_28;
    wp::int32 var_29;
    wp::range_t var_30;
    wp::int32 var_31;
    wp::int32 var_32;
    const wp::int32 var_33 = 1;
    wp::int32 var_34;
    const wp::int32 var_35 = 0;
    wp::int32 var_36;
    wp::int32 var_37;
    wp::int64 var_38;
    wp::int32 var_39;
    wp::vec_t<3, wp::float32>* var_40;
    wp::vec_t<3, wp::float32> var_41;
    wp::vec_t<3, wp::float32> var_42;
    wp::vec_t<3, wp::float32>* var_43;
    wp::vec_t<3, wp::float32> var_44;
    wp::vec_t<3, wp::float32> var_45;
    const wp::int32 var_46 = 0;
    wp::float32 var_47;
    const wp::int32 var_48 = 0;
    wp::float32 var_49;
    wp::float32 var_50;
    const wp::int32 var_51 = 1;
    wp::float32 var_52;
    const wp::int32 var_53 = 1;
    wp::float32 var_54;
    wp::float32 var_55;
    const wp::int32 var_56 = 2;
    wp::float32 var_57;
    const wp::int32 var_58 = 2;
    wp::float32 var_59;
    wp::float32 var_60;
    const wp::int32 var_61 = 0;
    wp::float32 var_62;
    const wp::int32 var_63 = 1;
    wp::float32 var_64;
    const wp::int32 var_65 = 2;
    wp::float32 var_66;
    const wp::int32 var_67 = 1;
    wp::int32 var_68;
    wp::int32 var_69;
    wp::int64 var_70;
    wp::int32 var_71;
    wp::vec_t<3, wp::float32>* var_72;
    wp::vec_t<3, wp::float32> var_73;
    wp::vec_t<3, wp::float32> var_74;
    wp::vec_t<3, wp::float32>* var_75;
    wp::vec_t<3, wp::float32> var_76;
    wp::vec_t<3, wp::float32> var_77;
    const wp::int32 var_78 = 0;
    wp::float32 var_79;
    const wp::int32 var_80 = 0;
    wp::float32 var_81;
    wp::float32 var_82;
    const wp::int32 var_83 = 1;
    wp::float32 var_84;
    const wp::int32 var_85 = 1;
    wp::float32 var_86;
    wp::float32 var_87;
    const wp::int32 var_88 = 2;
    wp::float32 var_89;
    const wp::int32 var_90 = 2;
    wp::float32 var_91;
    wp::float32 var_92;
    const wp::int32 var_93 = 0;
    wp::float32 var_94;
    const wp::int32 var_95 = 1;
    wp::float32 var_96;
    const wp::int32 var_97 = 2;
    wp::float32 var_98;
    const wp::int32 var_99 = 2;
    wp::int32 var_100;
    wp::int32 var_101;
    wp::int64 var_102;
    wp::int32 var_103;
    wp::vec_t<3, wp::float32>* var_104;
    wp::vec_t<3, wp::float32> var_105;
    wp::vec_t<3, wp::float32> var_106;
    wp::vec_t<3, wp::float32>* var_107;
    wp::vec_t<3, wp::float32> var_108;
    wp::vec_t<3, wp::float32> var_109;
    const wp::int32 var_110 = 0;
    wp::float32 var_111;
    const wp::int32 var_112 = 0;
    wp::float32 var_113;
    wp::float32 var_114;
    const wp::int32 var_115 = 1;
    wp::float32 var_116;
    const wp::int32 var_117 = 1;
    wp::float32 var_118;
    wp::float32 var_119;
    const wp::int32 var_120 = 2;
    wp::float32 var_121;
    const wp::int32 var_122 = 2;
    wp::float32 var_123;
    wp::float32 var_124;
    const wp::int32 var_125 = 0;
    wp::float32 var_126;
    const wp::int32 var_127 = 1;
    wp::float32 var_128;
    const wp::int32 var_129 = 2;
    wp::float32 var_130;
    const wp::int32 var_131 = 3;
    wp::int32 var_132;
    wp::int32 var_133;
    wp::int64 var_134;
    wp::int32 var_135;
    wp::vec_t<3, wp::float32>* var_136;
    wp::vec_t<3, wp::float32> var_137;
    wp::vec_t<3, wp::float32> var_138;
    wp::vec_t<3, wp::float32>* var_139;
    wp::vec_t<3, wp::float32> var_140;
    wp::vec_t<3, wp::float32> var_141;
    const wp::int32 var_142 = 0;
    wp::float32 var_143;
    const wp::int32 var_144 = 0;
    wp::float32 var_145;
    wp::float32 var_146;
    const wp::int32 var_147 = 1;
    wp::float32 var_148;
    const wp::int32 var_149 = 1;
    wp::float32 var_150;
    wp::float32 var_151;
    const wp::int32 var_152 = 2;
    wp::float32 var_153;
    const wp::int32 var_154 = 2;
    wp::float32 var_155;
    wp::float32 var_156;
    const wp::int32 var_157 = 0;
    wp::float32 var_158;
    const wp::int32 var_159 = 1;
    wp::float32 var_160;
    const wp::int32 var_161 = 2;
    wp::float32 var_162;
    const wp::int32 var_163 = 4;
    wp::int32 var_164;
    wp::int32 var_165;
    wp::int64 var_166;
    wp::int32 var_167;
    wp::vec_t<3, wp::float32>* var_168;
    wp::vec_t<3, wp::float32> var_169;
    wp::vec_t<3, wp::float32> var_170;
    wp::vec_t<3, wp::float32>* var_171;
    wp::vec_t<3, wp::float32> var_172;
    wp::vec_t<3, wp::float32> var_173;
    const wp::int32 var_174 = 0;
    wp::float32 var_175;
    const wp::int32 var_176 = 0;
    wp::float32 var_177;
    wp::float32 var_178;
    const wp::int32 var_179 = 1;
    wp::float32 var_180;
    const wp::int32 var_181 = 1;
    wp::float32 var_182;
    wp::float32 var_183;
    const wp::int32 var_184 = 2;
    wp::float32 var_185;
    const wp::int32 var_186 = 2;
    wp::float32 var_187;
    wp::float32 var_188;
    const wp::int32 var_189 = 0;
    wp::float32 var_190;
    const wp::int32 var_191 = 1;
    wp::float32 var_192;
    const wp::int32 var_193 = 2;
    wp::float32 var_194;
    const wp::int32 var_195 = 5;
    wp::int32 var_196;
    wp::int32 var_197;
    wp::int64 var_198;
    wp::int32 var_199;
    wp::vec_t<3, wp::float32>* var_200;
    wp::vec_t<3, wp::float32> var_201;
    wp::vec_t<3, wp::float32> var_202;
    wp::vec_t<3, wp::float32>* var_203;
    wp::vec_t<3, wp::float32> var_204;
    wp::vec_t<3, wp::float32> var_205;
    const wp::int32 var_206 = 0;
    wp::float32 var_207;
    const wp::int32 var_208 = 0;
    wp::float32 var_209;
    wp::float32 var_210;
    const wp::int32 var_211 = 1;
    wp::float32 var_212;
    const wp::int32 var_213 = 1;
    wp::float32 var_214;
    wp::float32 var_215;
    const wp::int32 var_216 = 2;
    wp::float32 var_217;
    const wp::int32 var_218 = 2;
    wp::float32 var_219;
    wp::float32 var_220;
    const wp::int32 var_221 = 0;
    wp::float32 var_222;
    const wp::int32 var_223 = 1;
    wp::float32 var_224;
    const wp::int32 var_225 = 2;
    wp::float32 var_226;
    const wp::int32 var_227 = 6;
    wp::int32 var_228;
    wp::int32 var_229;
    wp::int64 var_230;
    wp::int32 var_231;
    wp::vec_t<3, wp::float32>* var_232;
    wp::vec_t<3, wp::float32> var_233;
    wp::vec_t<3, wp::float32> var_234;
    wp::vec_t<3, wp::float32>* var_235;
    wp::vec_t<3, wp::float32> var_236;
    wp::vec_t<3, wp::float32> var_237;
    const wp::int32 var_238 = 0;
    wp::float32 var_239;
    const wp::int32 var_240 = 0;
    wp::float32 var_241;
    wp::float32 var_242;
    const wp::int32 var_243 = 1;
    wp::float32 var_244;
    const wp::int32 var_245 = 1;
    wp::float32 var_246;
    wp::float32 var_247;
    const wp::int32 var_248 = 2;
    wp::float32 var_249;
    const wp::int32 var_250 = 2;
    wp::float32 var_251;
    wp::float32 var_252;
    const wp::int32 var_253 = 0;
    wp::float32 var_254;
    const wp::int32 var_255 = 1;
    wp::float32 var_256;
    const wp::int32 var_257 = 2;
    wp::float32 var_258;
    const wp::int32 var_259 = 7;
    wp::int32 var_260;
    wp::int32 var_261;
    wp::int64 var_262;
    wp::int32 var_263;
    wp::vec_t<3, wp::float32>* var_264;
    wp::vec_t<3, wp::float32> var_265;
    wp::vec_t<3, wp::float32> var_266;
    wp::vec_t<3, wp::float32>* var_267;
    wp::vec_t<3, wp::float32> var_268;
    wp::vec_t<3, wp::float32> var_269;
    const wp::int32 var_270 = 0;
    wp::float32 var_271;
    const wp::int32 var_272 = 0;
    wp::float32 var_273;
    wp::float32 var_274;
    const wp::int32 var_275 = 1;
    wp::float32 var_276;
    const wp::int32 var_277 = 1;
    wp::float32 var_278;
    wp::float32 var_279;
    const wp::int32 var_280 = 2;
    wp::float32 var_281;
    const wp::int32 var_282 = 2;
    wp::float32 var_283;
    wp::float32 var_284;
    const wp::int32 var_285 = 0;
    wp::float32 var_286;
    const wp::int32 var_287 = 1;
    wp::float32 var_288;
    const wp::int32 var_289 = 2;
    wp::float32 var_290;
    const wp::int32 var_291 = 0;
    wp::float32 var_292;
    wp::float32 var_293;
    wp::float32 var_294;
    wp::vec_t<3, wp::float32> var_295;
    wp::float32 var_296;
    wp::float32 var_297;
    wp::float32 var_298;
    wp::vec_t<3, wp::float32> var_299;
    wp::int32 var_300;
    const wp::int32 var_301 = 1;
    wp::float32 var_302;
    wp::float32 var_303;
    wp::float32 var_304;
    wp::vec_t<3, wp::float32> var_305;
    wp::float32 var_306;
    wp::float32 var_307;
    wp::float32 var_308;
    wp::vec_t<3, wp::float32> var_309;
    wp::int32 var_310;
    const wp::int32 var_311 = 2;
    wp::float32 var_312;
    wp::float32 var_313;
    wp::float32 var_314;
    wp::vec_t<3, wp::float32> var_315;
    wp::float32 var_316;
    wp::float32 var_317;
    wp::float32 var_318;
    wp::vec_t<3, wp::float32> var_319;
    wp::int32 var_320;
    const wp::int32 var_321 = 3;
    wp::float32 var_322;
    wp::float32 var_323;
    wp::float32 var_324;
    wp::vec_t<3, wp::float32> var_325;
    wp::float32 var_326;
    wp::float32 var_327;
    wp::float32 var_328;
    wp::vec_t<3, wp::float32> var_329;
    wp::int32 var_330;
    const wp::int32 var_331 = 4;
    wp::float32 var_332;
    wp::float32 var_333;
    wp::float32 var_334;
    wp::vec_t<3, wp::float32> var_335;
    wp::float32 var_336;
    wp::float32 var_337;
    wp::float32 var_338;
    wp::vec_t<3, wp::float32> var_339;
    wp::int32 var_340;
    const wp::int32 var_341 = 5;
    wp::float32 var_342;
    wp::float32 var_343;
    wp::float32 var_344;
    wp::vec_t<3, wp::float32> var_345;
    wp::float32 var_346;
    wp::float32 var_347;
    wp::float32 var_348;
    wp::vec_t<3, wp::float32> var_349;
    wp::int32 var_350;
    const wp::int32 var_351 = 6;
    wp::float32 var_352;
    wp::float32 var_353;
    wp::float32 var_354;
    wp::vec_t<3, wp::float32> var_355;
    wp::float32 var_356;
    wp::float32 var_357;
    wp::float32 var_358;
    wp::vec_t<3, wp::float32> var_359;
    wp::int32 var_360;
    const wp::int32 var_361 = 7;
    wp::float32 var_362;
    wp::float32 var_363;
    wp::float32 var_364;
    wp::vec_t<3, wp::float32> var_365;
    wp::float32 var_366;
    wp::float32 var_367;
    wp::float32 var_368;
    wp::vec_t<3, wp::float32> var_369;
    wp::int32 var_370;
    wp::int32 var_371;
    const wp::int32 var_372 = 1;
    wp::int32 var_373;
    wp::int32 var_374;
    wp::range_t var_375;
    wp::int32 var_376;
    wp::int32 var_377;
    wp::int64 var_378;
    bool var_379;
    wp::int32 var_380;
    wp::int32 var_381;
    wp::vec_t<3, wp::float32>* var_382;
    wp::vec_t<3, wp::float32>* var_383;
    wp::int32 var_384;
    wp::vec_t<3, wp::float32> var_385;
    wp::vec_t<3, wp::float32> var_386;
    const wp::int32 var_387 = 15;
    wp::int32 var_388;
    const wp::int32 var_389 = 1;
    const wp::int32 var_390 = 11;
    const wp::int32 var_391 = 4;
    wp::int32 var_392;
    wp::int32 var_393;
    wp::int32 var_394;
    const wp::int32 var_395 = 1;
    const wp::int32 var_396 = 2;
    wp::int32 var_397;
    const wp::int32 var_398 = 2;
    wp::int32 var_399;
    wp::int32 var_400;
    wp::int32 var_401;
    const wp::int32 var_402 = 1;
    wp::int32 var_403;
    //---------
    // forward
    // def bin_listed(rank, neighborhood__tree__points, neighborhood__limits, normals, scratch__keys, scratch__stride, base, stored):       <L 1>
    // p = neighborhood__tree__points[rank]                                                   <L 3>
    var_0 = wp::address(var_neighborhood__tree__points, var_rank);
    var_2 = wp::load(var_0);
    var_1 = wp::copy(var_2);
    // limit = neighborhood__limits[rank]                                                     <L 4>
    var_3 = wp::address(var_neighborhood__limits, var_rank);
    var_5 = wp::load(var_3);
    var_4 = wp::copy(var_5);
    // n = normals[rank]                                                                      <L 5>
    var_6 = wp::address(var_normals, var_rank);
    var_8 = wp::load(var_6);
    var_7 = wp::copy(var_8);
    // counts = histogram(0)                                                                  <L 6>
    var_10 = wp::vec_t<33, wp::int32>(var_9);
    // dx = eight(0.0)                                                                        <L 7>
    var_12 = wp::vec_t<8, wp::float32>(var_11);
    // dy = eight(0.0)                                                                        <L 8>
    var_14 = wp::vec_t<8, wp::float32>(var_13);
    // dz = eight(0.0)                                                                        <L 9>
    var_16 = wp::vec_t<8, wp::float32>(var_15);
    // mx = eight(0.0)                                                                        <L 10>
    var_18 = wp::vec_t<8, wp::float32>(var_17);
    // my = eight(0.0)                                                                        <L 11>
    var_20 = wp::vec_t<8, wp::float32>(var_19);
    // mz = eight(0.0)                                                                        <L 12>
    var_22 = wp::vec_t<8, wp::float32>(var_21);
    // pairs = eight_bins(0)                                                                  <L 13>
    var_24 = wp::vec_t<8, wp::int32>(var_23);
    // for chunk in range((stored + LEAF - 1) // LEAF):                                       <L 14>
    var_26 = wp::add(var_stored, var_25);
    var_28 = wp::sub(var_26, var_27);
    var_29 = wp::floordiv(var_28, var_25);
    var_30 = wp::range(var_29);
    start_for_0:;
        if (iter_cmp(var_30) == 0) goto end_for_0;
        var_31 = wp::iter_next(var_30);
        // first = chunk * LEAF                                                               <L 15>
        var_32 = wp::mul(var_31, var_25);
        // last = stored - 1                                                                  <L 16>
        var_34 = wp::sub(var_stored, var_33);
        // for j in range(LEAF):                                                              <L 17>
        // other = key_index(stored_key(scratch__keys, scratch__stride, base, min(first + j, last)))       <L 18>
        var_36 = wp::add(var_32, var_35);
        var_37 = wp::min(var_36, var_34);
        var_38 = stored_key_of_lane_on_cuda_0(var_scratch__keys, var_scratch__stride, var_base, var_37);
        var_39 = key_index_0(var_38);
        // q = neighborhood__tree__points[other]                                              <L 19>
        var_40 = wp::address(var_neighborhood__tree__points, var_39);
        var_42 = wp::load(var_40);
        var_41 = wp::copy(var_42);
        // m = normals[other]                                                                 <L 20>
        var_43 = wp::address(var_normals, var_39);
        var_45 = wp::load(var_43);
        var_44 = wp::copy(var_45);
        // dx[j] = q[0] - p[0]                                                                <L 21>
        var_47 = wp::extract(var_41, var_46);
        var_49 = wp::extract(var_1, var_48);
        var_50 = wp::sub(var_47, var_49);
        wp::assign_inplace(var_12, var_35, var_50);
        // dy[j] = q[1] - p[1]                                                                <L 22>
        var_52 = wp::extract(var_41, var_51);
        var_54 = wp::extract(var_1, var_53);
        var_55 = wp::sub(var_52, var_54);
        wp::assign_inplace(var_14, var_35, var_55);
        // dz[j] = q[2] - p[2]                                                                <L 23>
        var_57 = wp::extract(var_41, var_56);
        var_59 = wp::extract(var_1, var_58);
        var_60 = wp::sub(var_57, var_59);
        wp::assign_inplace(var_16, var_35, var_60);
        // mx[j] = m[0]                                                                       <L 24>
        var_62 = wp::extract(var_44, var_61);
        wp::assign_inplace(var_18, var_35, var_62);
        // my[j] = m[1]                                                                       <L 25>
        var_64 = wp::extract(var_44, var_63);
        wp::assign_inplace(var_20, var_35, var_64);
        // mz[j] = m[2]                                                                       <L 26>
        var_66 = wp::extract(var_44, var_65);
        wp::assign_inplace(var_22, var_35, var_66);
        // other = key_index(stored_key(scratch__keys, scratch__stride, base, min(first + j, last)))       <L 18>
        var_68 = wp::add(var_32, var_67);
        var_69 = wp::min(var_68, var_34);
        var_70 = stored_key_of_lane_on_cuda_0(var_scratch__keys, var_scratch__stride, var_base, var_69);
        var_71 = key_index_0(var_70);
        // q = neighborhood__tree__points[other]                                              <L 19>
        var_72 = wp::address(var_neighborhood__tree__points, var_71);
        var_74 = wp::load(var_72);
        var_73 = wp::copy(var_74);
        // m = normals[other]                                                                 <L 20>
        var_75 = wp::address(var_normals, var_71);
        var_77 = wp::load(var_75);
        var_76 = wp::copy(var_77);
        // dx[j] = q[0] - p[0]                                                                <L 21>
        var_79 = wp::extract(var_73, var_78);
        var_81 = wp::extract(var_1, var_80);
        var_82 = wp::sub(var_79, var_81);
        wp::assign_inplace(var_12, var_67, var_82);
        // dy[j] = q[1] - p[1]                                                                <L 22>
        var_84 = wp::extract(var_73, var_83);
        var_86 = wp::extract(var_1, var_85);
        var_87 = wp::sub(var_84, var_86);
        wp::assign_inplace(var_14, var_67, var_87);
        // dz[j] = q[2] - p[2]                                                                <L 23>
        var_89 = wp::extract(var_73, var_88);
        var_91 = wp::extract(var_1, var_90);
        var_92 = wp::sub(var_89, var_91);
        wp::assign_inplace(var_16, var_67, var_92);
        // mx[j] = m[0]                                                                       <L 24>
        var_94 = wp::extract(var_76, var_93);
        wp::assign_inplace(var_18, var_67, var_94);
        // my[j] = m[1]                                                                       <L 25>
        var_96 = wp::extract(var_76, var_95);
        wp::assign_inplace(var_20, var_67, var_96);
        // mz[j] = m[2]                                                                       <L 26>
        var_98 = wp::extract(var_76, var_97);
        wp::assign_inplace(var_22, var_67, var_98);
        // other = key_index(stored_key(scratch__keys, scratch__stride, base, min(first + j, last)))       <L 18>
        var_100 = wp::add(var_32, var_99);
        var_101 = wp::min(var_100, var_34);
        var_102 = stored_key_of_lane_on_cuda_0(var_scratch__keys, var_scratch__stride, var_base, var_101);
        var_103 = key_index_0(var_102);
        // q = neighborhood__tree__points[other]                                              <L 19>
        var_104 = wp::address(var_neighborhood__tree__points, var_103);
        var_106 = wp::load(var_104);
        var_105 = wp::copy(var_106);
        // m = normals[other]                                                                 <L 20>
        var_107 = wp::address(var_normals, var_103);
        var_109 = wp::load(var_107);
        var_108 = wp::copy(var_109);
        // dx[j] = q[0] - p[0]                                                                <L 21>
        var_111 = wp::extract(var_105, var_110);
        var_113 = wp::extract(var_1, var_112);
        var_114 = wp::sub(var_111, var_113);
        wp::assign_inplace(var_12, var_99, var_114);
        // dy[j] = q[1] - p[1]                                                                <L 22>
        var_116 = wp::extract(var_105, var_115);
        var_118 = wp::extract(var_1, var_117);
        var_119 = wp::sub(var_116, var_118);
        wp::assign_inplace(var_14, var_99, var_119);
        // dz[j] = q[2] - p[2]                                                                <L 23>
        var_121 = wp::extract(var_105, var_120);
        var_123 = wp::extract(var_1, var_122);
        var_124 = wp::sub(var_121, var_123);
        wp::assign_inplace(var_16, var_99, var_124);
        // mx[j] = m[0]                                                                       <L 24>
        var_126 = wp::extract(var_108, var_125);
        wp::assign_inplace(var_18, var_99, var_126);
        // my[j] = m[1]                                                                       <L 25>
        var_128 = wp::extract(var_108, var_127);
        wp::assign_inplace(var_20, var_99, var_128);
        // mz[j] = m[2]                                                                       <L 26>
        var_130 = wp::extract(var_108, var_129);
        wp::assign_inplace(var_22, var_99, var_130);
        // other = key_index(stored_key(scratch__keys, scratch__stride, base, min(first + j, last)))       <L 18>
        var_132 = wp::add(var_32, var_131);
        var_133 = wp::min(var_132, var_34);
        var_134 = stored_key_of_lane_on_cuda_0(var_scratch__keys, var_scratch__stride, var_base, var_133);
        var_135 = key_index_0(var_134);
        // q = neighborhood__tree__points[other]                                              <L 19>
        var_136 = wp::address(var_neighborhood__tree__points, var_135);
        var_138 = wp::load(var_136);
        var_137 = wp::copy(var_138);
        // m = normals[other]                                                                 <L 20>
        var_139 = wp::address(var_normals, var_135);
        var_141 = wp::load(var_139);
        var_140 = wp::copy(var_141);
        // dx[j] = q[0] - p[0]                                                                <L 21>
        var_143 = wp::extract(var_137, var_142);
        var_145 = wp::extract(var_1, var_144);
        var_146 = wp::sub(var_143, var_145);
        wp::assign_inplace(var_12, var_131, var_146);
        // dy[j] = q[1] - p[1]                                                                <L 22>
        var_148 = wp::extract(var_137, var_147);
        var_150 = wp::extract(var_1, var_149);
        var_151 = wp::sub(var_148, var_150);
        wp::assign_inplace(var_14, var_131, var_151);
        // dz[j] = q[2] - p[2]                                                                <L 23>
        var_153 = wp::extract(var_137, var_152);
        var_155 = wp::extract(var_1, var_154);
        var_156 = wp::sub(var_153, var_155);
        wp::assign_inplace(var_16, var_131, var_156);
        // mx[j] = m[0]                                                                       <L 24>
        var_158 = wp::extract(var_140, var_157);
        wp::assign_inplace(var_18, var_131, var_158);
        // my[j] = m[1]                                                                       <L 25>
        var_160 = wp::extract(var_140, var_159);
        wp::assign_inplace(var_20, var_131, var_160);
        // mz[j] = m[2]                                                                       <L 26>
        var_162 = wp::extract(var_140, var_161);
        wp::assign_inplace(var_22, var_131, var_162);
        // other = key_index(stored_key(scratch__keys, scratch__stride, base, min(first + j, last)))       <L 18>
        var_164 = wp::add(var_32, var_163);
        var_165 = wp::min(var_164, var_34);
        var_166 = stored_key_of_lane_on_cuda_0(var_scratch__keys, var_scratch__stride, var_base, var_165);
        var_167 = key_index_0(var_166);
        // q = neighborhood__tree__points[other]                                              <L 19>
        var_168 = wp::address(var_neighborhood__tree__points, var_167);
        var_170 = wp::load(var_168);
        var_169 = wp::copy(var_170);
        // m = normals[other]                                                                 <L 20>
        var_171 = wp::address(var_normals, var_167);
        var_173 = wp::load(var_171);
        var_172 = wp::copy(var_173);
        // dx[j] = q[0] - p[0]                                                                <L 21>
        var_175 = wp::extract(var_169, var_174);
        var_177 = wp::extract(var_1, var_176);
        var_178 = wp::sub(var_175, var_177);
        wp::assign_inplace(var_12, var_163, var_178);
        // dy[j] = q[1] - p[1]                                                                <L 22>
        var_180 = wp::extract(var_169, var_179);
        var_182 = wp::extract(var_1, var_181);
        var_183 = wp::sub(var_180, var_182);
        wp::assign_inplace(var_14, var_163, var_183);
        // dz[j] = q[2] - p[2]                                                                <L 23>
        var_185 = wp::extract(var_169, var_184);
        var_187 = wp::extract(var_1, var_186);
        var_188 = wp::sub(var_185, var_187);
        wp::assign_inplace(var_16, var_163, var_188);
        // mx[j] = m[0]                                                                       <L 24>
        var_190 = wp::extract(var_172, var_189);
        wp::assign_inplace(var_18, var_163, var_190);
        // my[j] = m[1]                                                                       <L 25>
        var_192 = wp::extract(var_172, var_191);
        wp::assign_inplace(var_20, var_163, var_192);
        // mz[j] = m[2]                                                                       <L 26>
        var_194 = wp::extract(var_172, var_193);
        wp::assign_inplace(var_22, var_163, var_194);
        // other = key_index(stored_key(scratch__keys, scratch__stride, base, min(first + j, last)))       <L 18>
        var_196 = wp::add(var_32, var_195);
        var_197 = wp::min(var_196, var_34);
        var_198 = stored_key_of_lane_on_cuda_0(var_scratch__keys, var_scratch__stride, var_base, var_197);
        var_199 = key_index_0(var_198);
        // q = neighborhood__tree__points[other]                                              <L 19>
        var_200 = wp::address(var_neighborhood__tree__points, var_199);
        var_202 = wp::load(var_200);
        var_201 = wp::copy(var_202);
        // m = normals[other]                                                                 <L 20>
        var_203 = wp::address(var_normals, var_199);
        var_205 = wp::load(var_203);
        var_204 = wp::copy(var_205);
        // dx[j] = q[0] - p[0]                                                                <L 21>
        var_207 = wp::extract(var_201, var_206);
        var_209 = wp::extract(var_1, var_208);
        var_210 = wp::sub(var_207, var_209);
        wp::assign_inplace(var_12, var_195, var_210);
        // dy[j] = q[1] - p[1]                                                                <L 22>
        var_212 = wp::extract(var_201, var_211);
        var_214 = wp::extract(var_1, var_213);
        var_215 = wp::sub(var_212, var_214);
        wp::assign_inplace(var_14, var_195, var_215);
        // dz[j] = q[2] - p[2]                                                                <L 23>
        var_217 = wp::extract(var_201, var_216);
        var_219 = wp::extract(var_1, var_218);
        var_220 = wp::sub(var_217, var_219);
        wp::assign_inplace(var_16, var_195, var_220);
        // mx[j] = m[0]                                                                       <L 24>
        var_222 = wp::extract(var_204, var_221);
        wp::assign_inplace(var_18, var_195, var_222);
        // my[j] = m[1]                                                                       <L 25>
        var_224 = wp::extract(var_204, var_223);
        wp::assign_inplace(var_20, var_195, var_224);
        // mz[j] = m[2]                                                                       <L 26>
        var_226 = wp::extract(var_204, var_225);
        wp::assign_inplace(var_22, var_195, var_226);
        // other = key_index(stored_key(scratch__keys, scratch__stride, base, min(first + j, last)))       <L 18>
        var_228 = wp::add(var_32, var_227);
        var_229 = wp::min(var_228, var_34);
        var_230 = stored_key_of_lane_on_cuda_0(var_scratch__keys, var_scratch__stride, var_base, var_229);
        var_231 = key_index_0(var_230);
        // q = neighborhood__tree__points[other]                                              <L 19>
        var_232 = wp::address(var_neighborhood__tree__points, var_231);
        var_234 = wp::load(var_232);
        var_233 = wp::copy(var_234);
        // m = normals[other]                                                                 <L 20>
        var_235 = wp::address(var_normals, var_231);
        var_237 = wp::load(var_235);
        var_236 = wp::copy(var_237);
        // dx[j] = q[0] - p[0]                                                                <L 21>
        var_239 = wp::extract(var_233, var_238);
        var_241 = wp::extract(var_1, var_240);
        var_242 = wp::sub(var_239, var_241);
        wp::assign_inplace(var_12, var_227, var_242);
        // dy[j] = q[1] - p[1]                                                                <L 22>
        var_244 = wp::extract(var_233, var_243);
        var_246 = wp::extract(var_1, var_245);
        var_247 = wp::sub(var_244, var_246);
        wp::assign_inplace(var_14, var_227, var_247);
        // dz[j] = q[2] - p[2]                                                                <L 23>
        var_249 = wp::extract(var_233, var_248);
        var_251 = wp::extract(var_1, var_250);
        var_252 = wp::sub(var_249, var_251);
        wp::assign_inplace(var_16, var_227, var_252);
        // mx[j] = m[0]                                                                       <L 24>
        var_254 = wp::extract(var_236, var_253);
        wp::assign_inplace(var_18, var_227, var_254);
        // my[j] = m[1]                                                                       <L 25>
        var_256 = wp::extract(var_236, var_255);
        wp::assign_inplace(var_20, var_227, var_256);
        // mz[j] = m[2]                                                                       <L 26>
        var_258 = wp::extract(var_236, var_257);
        wp::assign_inplace(var_22, var_227, var_258);
        // other = key_index(stored_key(scratch__keys, scratch__stride, base, min(first + j, last)))       <L 18>
        var_260 = wp::add(var_32, var_259);
        var_261 = wp::min(var_260, var_34);
        var_262 = stored_key_of_lane_on_cuda_0(var_scratch__keys, var_scratch__stride, var_base, var_261);
        var_263 = key_index_0(var_262);
        // q = neighborhood__tree__points[other]                                              <L 19>
        var_264 = wp::address(var_neighborhood__tree__points, var_263);
        var_266 = wp::load(var_264);
        var_265 = wp::copy(var_266);
        // m = normals[other]                                                                 <L 20>
        var_267 = wp::address(var_normals, var_263);
        var_269 = wp::load(var_267);
        var_268 = wp::copy(var_269);
        // dx[j] = q[0] - p[0]                                                                <L 21>
        var_271 = wp::extract(var_265, var_270);
        var_273 = wp::extract(var_1, var_272);
        var_274 = wp::sub(var_271, var_273);
        wp::assign_inplace(var_12, var_259, var_274);
        // dy[j] = q[1] - p[1]                                                                <L 22>
        var_276 = wp::extract(var_265, var_275);
        var_278 = wp::extract(var_1, var_277);
        var_279 = wp::sub(var_276, var_278);
        wp::assign_inplace(var_14, var_259, var_279);
        // dz[j] = q[2] - p[2]                                                                <L 23>
        var_281 = wp::extract(var_265, var_280);
        var_283 = wp::extract(var_1, var_282);
        var_284 = wp::sub(var_281, var_283);
        wp::assign_inplace(var_16, var_259, var_284);
        // mx[j] = m[0]                                                                       <L 24>
        var_286 = wp::extract(var_268, var_285);
        wp::assign_inplace(var_18, var_259, var_286);
        // my[j] = m[1]                                                                       <L 25>
        var_288 = wp::extract(var_268, var_287);
        wp::assign_inplace(var_20, var_259, var_288);
        // mz[j] = m[2]                                                                       <L 26>
        var_290 = wp::extract(var_268, var_289);
        wp::assign_inplace(var_22, var_259, var_290);
        // for j in range(LEAF):                                                              <L 27>
        // pairs[j] = quick_bins(vec3(dx[j], dy[j], dz[j]), n, vec3(mx[j], my[j], mz[j]))       <L 28>
        var_292 = wp::extract(var_12, var_291);
        var_293 = wp::extract(var_14, var_291);
        var_294 = wp::extract(var_16, var_291);
        var_295 = wp::vec_t<3, wp::float32>(var_292, var_293, var_294);
        var_296 = wp::extract(var_18, var_291);
        var_297 = wp::extract(var_20, var_291);
        var_298 = wp::extract(var_22, var_291);
        var_299 = wp::vec_t<3, wp::float32>(var_296, var_297, var_298);
        var_300 = quick_bins_0(var_295, var_7, var_299);
        wp::assign_inplace(var_24, var_291, var_300);
        var_302 = wp::extract(var_12, var_301);
        var_303 = wp::extract(var_14, var_301);
        var_304 = wp::extract(var_16, var_301);
        var_305 = wp::vec_t<3, wp::float32>(var_302, var_303, var_304);
        var_306 = wp::extract(var_18, var_301);
        var_307 = wp::extract(var_20, var_301);
        var_308 = wp::extract(var_22, var_301);
        var_309 = wp::vec_t<3, wp::float32>(var_306, var_307, var_308);
        var_310 = quick_bins_0(var_305, var_7, var_309);
        wp::assign_inplace(var_24, var_301, var_310);
        var_312 = wp::extract(var_12, var_311);
        var_313 = wp::extract(var_14, var_311);
        var_314 = wp::extract(var_16, var_311);
        var_315 = wp::vec_t<3, wp::float32>(var_312, var_313, var_314);
        var_316 = wp::extract(var_18, var_311);
        var_317 = wp::extract(var_20, var_311);
        var_318 = wp::extract(var_22, var_311);
        var_319 = wp::vec_t<3, wp::float32>(var_316, var_317, var_318);
        var_320 = quick_bins_0(var_315, var_7, var_319);
        wp::assign_inplace(var_24, var_311, var_320);
        var_322 = wp::extract(var_12, var_321);
        var_323 = wp::extract(var_14, var_321);
        var_324 = wp::extract(var_16, var_321);
        var_325 = wp::vec_t<3, wp::float32>(var_322, var_323, var_324);
        var_326 = wp::extract(var_18, var_321);
        var_327 = wp::extract(var_20, var_321);
        var_328 = wp::extract(var_22, var_321);
        var_329 = wp::vec_t<3, wp::float32>(var_326, var_327, var_328);
        var_330 = quick_bins_0(var_325, var_7, var_329);
        wp::assign_inplace(var_24, var_321, var_330);
        var_332 = wp::extract(var_12, var_331);
        var_333 = wp::extract(var_14, var_331);
        var_334 = wp::extract(var_16, var_331);
        var_335 = wp::vec_t<3, wp::float32>(var_332, var_333, var_334);
        var_336 = wp::extract(var_18, var_331);
        var_337 = wp::extract(var_20, var_331);
        var_338 = wp::extract(var_22, var_331);
        var_339 = wp::vec_t<3, wp::float32>(var_336, var_337, var_338);
        var_340 = quick_bins_0(var_335, var_7, var_339);
        wp::assign_inplace(var_24, var_331, var_340);
        var_342 = wp::extract(var_12, var_341);
        var_343 = wp::extract(var_14, var_341);
        var_344 = wp::extract(var_16, var_341);
        var_345 = wp::vec_t<3, wp::float32>(var_342, var_343, var_344);
        var_346 = wp::extract(var_18, var_341);
        var_347 = wp::extract(var_20, var_341);
        var_348 = wp::extract(var_22, var_341);
        var_349 = wp::vec_t<3, wp::float32>(var_346, var_347, var_348);
        var_350 = quick_bins_0(var_345, var_7, var_349);
        wp::assign_inplace(var_24, var_341, var_350);
        var_352 = wp::extract(var_12, var_351);
        var_353 = wp::extract(var_14, var_351);
        var_354 = wp::extract(var_16, var_351);
        var_355 = wp::vec_t<3, wp::float32>(var_352, var_353, var_354);
        var_356 = wp::extract(var_18, var_351);
        var_357 = wp::extract(var_20, var_351);
        var_358 = wp::extract(var_22, var_351);
        var_359 = wp::vec_t<3, wp::float32>(var_356, var_357, var_358);
        var_360 = quick_bins_0(var_355, var_7, var_359);
        wp::assign_inplace(var_24, var_351, var_360);
        var_362 = wp::extract(var_12, var_361);
        var_363 = wp::extract(var_14, var_361);
        var_364 = wp::extract(var_16, var_361);
        var_365 = wp::vec_t<3, wp::float32>(var_362, var_363, var_364);
        var_366 = wp::extract(var_18, var_361);
        var_367 = wp::extract(var_20, var_361);
        var_368 = wp::extract(var_22, var_361);
        var_369 = wp::vec_t<3, wp::float32>(var_366, var_367, var_368);
        var_370 = quick_bins_0(var_365, var_7, var_369);
        wp::assign_inplace(var_24, var_361, var_370);
        // for j in range(min(LEAF, last - first + 1)):                                       <L 29>
        var_371 = wp::sub(var_34, var_32);
        var_373 = wp::add(var_371, var_372);
        var_374 = wp::min(var_25, var_373);
        var_375 = wp::range(var_374);
        start_for_2:;
            if (iter_cmp(var_375) == 0) goto end_for_2;
            var_376 = wp::iter_next(var_375);
            // key = stored_key(scratch__keys, scratch__stride, base, first + j)              <L 30>
            var_377 = wp::add(var_32, var_376);
            var_378 = stored_key_of_lane_on_cuda_0(var_scratch__keys, var_scratch__stride, var_base, var_377);
            // if key <= limit:                                                               <L 31>
            var_379 = (var_378 <= var_4);
            if (var_379) {
                // other = key_index(key)                                                     <L 32>
                var_380 = key_index_0(var_378);
                // bins = resolved_bins(pairs[j], p, n, neighborhood__tree__points[other], normals[other])       <L 33>
                var_381 = wp::extract(var_24, var_376);
                var_382 = wp::address(var_neighborhood__tree__points, var_380);
                var_383 = wp::address(var_normals, var_380);
                var_385 = wp::load(var_382);
                var_386 = wp::load(var_383);
                var_384 = resolved_bins_0(var_381, var_1, var_7, var_385, var_386);
                // counts[bins & BIN_MASK] += 1                                               <L 34>
                var_388 = wp::bit_and(var_384, var_387);
                wp::add_inplace(var_10, var_388, var_389);
                // counts[BINS + (bins >> BIN_BITS & BIN_MASK)] += 1                          <L 35>
                var_392 = wp::rshift(var_384, var_391);
                var_393 = wp::bit_and(var_392, var_387);
                var_394 = wp::add(var_390, var_393);
                wp::add_inplace(var_10, var_394, var_395);
                // counts[2 * BINS + (bins >> 2 * BIN_BITS)] += 1                             <L 36>
                var_397 = wp::mul(var_396, var_390);
                var_399 = wp::mul(var_398, var_391);
                var_400 = wp::rshift(var_384, var_399);
                var_401 = wp::add(var_397, var_400);
                wp::add_inplace(var_10, var_401, var_402);
            }
            var_403 = wp::where(var_379, var_380, var_263);
            wp::assign(var_263, var_403);
            goto start_for_2;
        end_for_2:;
        goto start_for_0;
    end_for_0:;
    // return counts                                                                          <L 37>
    return var_10;
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


// <pointloom.kernels.search.bucket_walk.children_within>:1
static CUDA_CALLABLE wp::int32 children_within_0(
    wp::array_t<wp::float32> var_boxes,
    wp::int32 var_node,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::float32 var_bound)
{
    //---------
    // primal vars
    wp::vec_t<8, wp::float32> var_0;
    const wp::int32 var_1 = 0;
    wp::int32 var_2;
    const wp::int32 var_3 = 0;
    wp::float32 var_4;
    bool var_5;
    const wp::int32 var_6 = 1;
    wp::int32 var_7;
    wp::int32 var_8;
    wp::int32 var_9;
    const wp::int32 var_10 = 1;
    wp::float32 var_11;
    bool var_12;
    const wp::int32 var_13 = 1;
    wp::int32 var_14;
    wp::int32 var_15;
    wp::int32 var_16;
    const wp::int32 var_17 = 2;
    wp::float32 var_18;
    bool var_19;
    const wp::int32 var_20 = 1;
    wp::int32 var_21;
    wp::int32 var_22;
    wp::int32 var_23;
    const wp::int32 var_24 = 3;
    wp::float32 var_25;
    bool var_26;
    const wp::int32 var_27 = 1;
    wp::int32 var_28;
    wp::int32 var_29;
    wp::int32 var_30;
    const wp::int32 var_31 = 4;
    wp::float32 var_32;
    bool var_33;
    const wp::int32 var_34 = 1;
    wp::int32 var_35;
    wp::int32 var_36;
    wp::int32 var_37;
    const wp::int32 var_38 = 5;
    wp::float32 var_39;
    bool var_40;
    const wp::int32 var_41 = 1;
    wp::int32 var_42;
    wp::int32 var_43;
    wp::int32 var_44;
    const wp::int32 var_45 = 6;
    wp::float32 var_46;
    bool var_47;
    const wp::int32 var_48 = 1;
    wp::int32 var_49;
    wp::int32 var_50;
    wp::int32 var_51;
    const wp::int32 var_52 = 7;
    wp::float32 var_53;
    bool var_54;
    const wp::int32 var_55 = 1;
    wp::int32 var_56;
    wp::int32 var_57;
    wp::int32 var_58;
    //---------
    // forward
    // def children_within(boxes, node, a, b, bound):                                         <L 1>
    // distances = measure_boxes(boxes, node, a, b)                                           <L 3>
    var_0 = measure_boxes_0(var_boxes, var_node, var_a, var_b);
    // bits = int(0)                                                                          <L 4>
    var_2 = wp::int(var_1);
    // for j in range(FAN):                                                                   <L 5>
    // if distances[j] <= bound:                                                              <L 6>
    var_4 = wp::extract(var_0, var_3);
    var_5 = (var_4 <= var_bound);
    if (var_5) {
        // bits = bits | 1 << j                                                               <L 7>
        var_7 = wp::lshift(var_6, var_3);
        var_8 = wp::bit_or(var_2, var_7);
    }
    var_9 = wp::where(var_5, var_8, var_2);
    // if distances[j] <= bound:                                                              <L 6>
    var_11 = wp::extract(var_0, var_10);
    var_12 = (var_11 <= var_bound);
    if (var_12) {
        // bits = bits | 1 << j                                                               <L 7>
        var_14 = wp::lshift(var_13, var_10);
        var_15 = wp::bit_or(var_9, var_14);
    }
    var_16 = wp::where(var_12, var_15, var_9);
    // if distances[j] <= bound:                                                              <L 6>
    var_18 = wp::extract(var_0, var_17);
    var_19 = (var_18 <= var_bound);
    if (var_19) {
        // bits = bits | 1 << j                                                               <L 7>
        var_21 = wp::lshift(var_20, var_17);
        var_22 = wp::bit_or(var_16, var_21);
    }
    var_23 = wp::where(var_19, var_22, var_16);
    // if distances[j] <= bound:                                                              <L 6>
    var_25 = wp::extract(var_0, var_24);
    var_26 = (var_25 <= var_bound);
    if (var_26) {
        // bits = bits | 1 << j                                                               <L 7>
        var_28 = wp::lshift(var_27, var_24);
        var_29 = wp::bit_or(var_23, var_28);
    }
    var_30 = wp::where(var_26, var_29, var_23);
    // if distances[j] <= bound:                                                              <L 6>
    var_32 = wp::extract(var_0, var_31);
    var_33 = (var_32 <= var_bound);
    if (var_33) {
        // bits = bits | 1 << j                                                               <L 7>
        var_35 = wp::lshift(var_34, var_31);
        var_36 = wp::bit_or(var_30, var_35);
    }
    var_37 = wp::where(var_33, var_36, var_30);
    // if distances[j] <= bound:                                                              <L 6>
    var_39 = wp::extract(var_0, var_38);
    var_40 = (var_39 <= var_bound);
    if (var_40) {
        // bits = bits | 1 << j                                                               <L 7>
        var_42 = wp::lshift(var_41, var_38);
        var_43 = wp::bit_or(var_37, var_42);
    }
    var_44 = wp::where(var_40, var_43, var_37);
    // if distances[j] <= bound:                                                              <L 6>
    var_46 = wp::extract(var_0, var_45);
    var_47 = (var_46 <= var_bound);
    if (var_47) {
        // bits = bits | 1 << j                                                               <L 7>
        var_49 = wp::lshift(var_48, var_45);
        var_50 = wp::bit_or(var_44, var_49);
    }
    var_51 = wp::where(var_47, var_50, var_44);
    // if distances[j] <= bound:                                                              <L 6>
    var_53 = wp::extract(var_0, var_52);
    var_54 = (var_53 <= var_bound);
    if (var_54) {
        // bits = bits | 1 << j                                                               <L 7>
        var_56 = wp::lshift(var_55, var_52);
        var_57 = wp::bit_or(var_51, var_56);
    }
    var_58 = wp::where(var_54, var_57, var_51);
    // return bits                                                                            <L 8>
    return var_58;
}


// /work/main/src/pointloom/kernels/search/bucket_walk.py:86
static CUDA_CALLABLE wp::int32 level_children_within_0(
    wp::array_t<wp::int32> var_levels,
    wp::int32 var_first,
    wp::array_t<wp::float32> var_boxes,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::float32 var_bound,
    wp::int32 var_level,
    wp::int32 var_node)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32* var_1;
    wp::int32 var_2;
    wp::int32 var_3;
    wp::int32 var_4;
    //---------
    // forward
    // def level_children_within(                                                             <L 87>
    // return children_within(boxes, levels[first + level] + node, a, b, bound)               <L 98>
    var_0 = wp::add(var_first, var_level);
    var_1 = wp::address(var_levels, var_0);
    var_3 = wp::load(var_1);
    var_2 = wp::add(var_3, var_node);
    var_4 = children_within_0(var_boxes, var_2, var_a, var_b, var_bound);
    return var_4;
}


// <pointloom.kernels.search.bucket_walk.next_step__level_children_within>:1
static CUDA_CALLABLE wp::vec_t<4, wp::int64> next_step__level_children_within_0(
    wp::vec_t<4, wp::int64> var_step,
    wp::int32 var_root,
    wp::array_t<wp::int32> var_children__levels,
    wp::int32 var_children__first,
    wp::array_t<wp::float32> var_children__boxes,
    wp::vec_t<3, wp::float32> var_children__a,
    wp::vec_t<3, wp::float32> var_children__b,
    wp::float32 var_children__bound)
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
    bool var_11;
    const wp::int32 var_12 = 0;
    bool var_13;
    const wp::int32 var_14 = 0;
    bool var_15;
    const wp::int32 var_16 = 1;
    const wp::int32 var_17 = 8;
    wp::int32 var_18;
    wp::int32 var_19;
    wp::int32 var_20;
    const wp::int32 var_21 = 1;
    wp::int32 var_22;
    const wp::int32 var_23 = 1;
    bool var_24;
    wp::int64 var_25;
    wp::int64 var_26;
    wp::int32 var_27;
    const wp::int32 var_28 = 255;
    wp::int32 var_29;
    const wp::int32 var_30 = 0;
    bool var_31;
    wp::int32 var_32;
    wp::int32 var_33;
    wp::int64 var_34;
    wp::int64 var_35;
    wp::int64 var_36;
    wp::int64 var_37;
    wp::int32 var_38;
    const wp::int32 var_39 = 1;
    wp::int32 var_40;
    wp::int32 var_41;
    wp::int32 var_42;
    const wp::int32 var_43 = 1;
    wp::int32 var_44;
    const wp::int32 var_45 = 0;
    bool var_46;
    const wp::int32 var_47 = 0;
    wp::int32 var_48;
    wp::int64 var_49;
    wp::int64 var_50;
    wp::int64 var_51;
    wp::int64 var_52;
    wp::int64 var_53;
    wp::int32 var_54;
    bool var_55;
    const wp::int32 var_56 = 1;
    wp::int32 var_57;
    bool var_58;
    const wp::int32 var_59 = 0;
    const wp::int32 var_60 = 1;
    wp::int32 var_61;
    wp::int32 var_62;
    wp::int32 var_63;
    const wp::int32 var_64 = 1;
    wp::int32 var_65;
    wp::int32 var_66;
    wp::int32 var_67;
    wp::int32 var_68;
    wp::int64 var_69;
    wp::int64 var_70;
    wp::int64 var_71;
    wp::int64 var_72;
    wp::int32 var_73;
    wp::int32 var_74;
    wp::int64 var_75;
    wp::int32 var_76;
    wp::int32 var_77;
    const wp::int32 var_78 = 1;
    wp::int32 var_79;
    wp::int32 var_80;
    wp::int32 var_81;
    wp::int32 var_82;
    wp::int64 var_83;
    wp::int32 var_84;
    wp::int32 var_85;
    wp::int32 var_86;
    wp::int32 var_87;
    wp::int64 var_88;
    wp::int32 var_89;
    wp::int64 var_90;
    wp::int64 var_91;
    wp::int64 var_92;
    wp::vec_t<4, wp::int64> var_93;
    //---------
    // forward
    // def next_step__level_children_within(step, root, children__levels, children__first, children__boxes, children__a, children__b, children__bound):       <L 1>
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
    // if level == 0 and height > 0:                                                          <L 7>
    var_13 = (var_5 == var_12);
    var_11 = var_13;
    if (var_11) {
        var_15 = (var_2 > var_14);
        var_11 = var_11 && var_15;
    }
    if (var_11) {
        // level = 1                                                                          <L 8>
        // node = node // FAN                                                                 <L 9>
        var_18 = wp::floordiv(var_8, var_17);
    }
    var_19 = wp::where(var_11, var_16, var_5);
    var_20 = wp::where(var_11, var_18, var_8);
    // searching = int(1)                                                                     <L 10>
    var_22 = wp::int(var_21);
    // while searching == 1:                                                                  <L 11>
    start_while_0:;
    var_24 = (var_22 == var_23);
    if ((var_24) == false) goto end_while_0;
        // left = int(pending >> byte_shift(level)) & BYTE                                    <L 12>
        var_25 = byte_shift_0(var_19);
        var_26 = wp::rshift(var_10, var_25);
        var_27 = wp::int(var_26);
        var_29 = wp::bit_and(var_27, var_28);
        // if left != 0:                                                                      <L 13>
        var_31 = (var_29 != var_30);
        if (var_31) {
            // lowest = left & -left                                                          <L 14>
            var_32 = wp::neg(var_29);
            var_33 = wp::bit_and(var_29, var_32);
            // pending = pending ^ int64(lowest) << byte_shift(level)                         <L 15>
            var_34 = wp::int64(var_33);
            var_35 = byte_shift_0(var_19);
            var_36 = wp::lshift(var_34, var_35);
            var_37 = wp::bit_xor(var_10, var_36);
            // node = node * FAN + bit_count(lowest - 1)                                      <L 16>
            var_38 = wp::mul(var_20, var_17);
            var_40 = wp::sub(var_33, var_39);
            var_41 = wp::bit_count(var_40);
            var_42 = wp::add(var_38, var_41);
            // level = level - 1                                                              <L 17>
            var_44 = wp::sub(var_19, var_43);
            // if level == 0:                                                                 <L 18>
            var_46 = (var_44 == var_45);
            if (var_46) {
                // searching = 0                                                              <L 19>
            }
            if (!var_46) {
                // inside = children__call(children__levels, children__first, children__boxes, children__a, children__b, children__bound, level, node)       <L 21>
                var_48 = level_children_within_0(var_children__levels, var_children__first, var_children__boxes, var_children__a, var_children__b, var_children__bound, var_44, var_42);
                // pending = pending | int64(inside) << byte_shift(level)                     <L 22>
                var_49 = wp::int64(var_48);
                var_50 = byte_shift_0(var_44);
                var_51 = wp::lshift(var_49, var_50);
                var_52 = wp::bit_or(var_37, var_51);
            }
            var_53 = wp::where(var_46, var_37, var_52);
            var_54 = wp::where(var_46, var_47, var_22);
        }
        if (!var_31) {
            // elif level == height:                                                          <L 23>
            var_55 = (var_19 == var_2);
            if (var_55) {
                // height = height + 1                                                        <L 24>
                var_57 = wp::add(var_2, var_56);
                // if height > root:                                                          <L 25>
                var_58 = (var_57 > var_root);
                if (var_58) {
                    // searching = 0                                                          <L 26>
                }
                if (!var_58) {
                    // own = 1 << node % FAN                                                  <L 28>
                    var_61 = wp::mod(var_20, var_17);
                    var_62 = wp::lshift(var_60, var_61);
                    // node = node // FAN                                                     <L 29>
                    var_63 = wp::floordiv(var_20, var_17);
                    // level = level + 1                                                      <L 30>
                    var_65 = wp::add(var_19, var_64);
                    // others = children__call(children__levels, children__first, children__boxes, children__a, children__b, children__bound, level, node) & BYTE - own       <L 31>
                    var_66 = level_children_within_0(var_children__levels, var_children__first, var_children__boxes, var_children__a, var_children__b, var_children__bound, var_65, var_63);
                    var_67 = wp::sub(var_28, var_62);
                    var_68 = wp::bit_and(var_66, var_67);
                    // pending = pending | int64(others) << byte_shift(level)                 <L 32>
                    var_69 = wp::int64(var_68);
                    var_70 = byte_shift_0(var_65);
                    var_71 = wp::lshift(var_69, var_70);
                    var_72 = wp::bit_or(var_10, var_71);
                }
                var_73 = wp::where(var_58, var_19, var_65);
                var_74 = wp::where(var_58, var_20, var_63);
                var_75 = wp::where(var_58, var_10, var_72);
                var_76 = wp::where(var_58, var_59, var_22);
            }
            if (!var_55) {
                // node = node // FAN                                                         <L 34>
                var_77 = wp::floordiv(var_20, var_17);
                // level = level + 1                                                          <L 35>
                var_79 = wp::add(var_19, var_78);
            }
            var_80 = wp::where(var_55, var_57, var_2);
            var_81 = wp::where(var_55, var_73, var_79);
            var_82 = wp::where(var_55, var_74, var_77);
            var_83 = wp::where(var_55, var_75, var_10);
            var_84 = wp::where(var_55, var_76, var_22);
        }
        var_85 = wp::where(var_31, var_2, var_80);
        var_86 = wp::where(var_31, var_44, var_81);
        var_87 = wp::where(var_31, var_42, var_82);
        var_88 = wp::where(var_31, var_53, var_83);
        var_89 = wp::where(var_31, var_54, var_84);
        wp::assign(var_2, var_85);
        wp::assign(var_19, var_86);
        wp::assign(var_20, var_87);
        wp::assign(var_10, var_88);
        wp::assign(var_22, var_89);
    goto start_while_0;
    end_while_0:;
    // return traversal(int64(height), int64(level), int64(node), pending)                    <L 36>
    var_90 = wp::int64(var_2);
    var_91 = wp::int64(var_19);
    var_92 = wp::int64(var_20);
    var_93 = wp::vec_t<4, wp::int64>(var_90, var_91, var_92, var_10);
    return var_93;
}


// <pointloom.kernels.search.bucket_walk.next_bucket>:1
static CUDA_CALLABLE wp::vec_t<4, wp::int64> next_bucket_0(
    wp::vec_t<4, wp::int64> var_step,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::float32 var_bound,
    wp::int32 var_tree__root,
    wp::array_t<wp::int32> var_tree__levels,
    wp::array_t<wp::float32> var_tree__boxes)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::vec_t<4, wp::int64> var_1;
    //---------
    // forward
    // def next_bucket(step, a, b, bound, tree__root, tree__levels, tree__boxes):             <L 1>
    // return next_step__level_children_within(step, tree__root, tree__levels, 0, tree__boxes, a, b, bound)       <L 3>
    var_1 = next_step__level_children_within_0(var_step, var_tree__root, var_tree__levels, var_0, var_tree__boxes, var_a, var_b, var_bound);
    return var_1;
}


// <pointloom.kernels.features.fpfh.bin_by_traversal>:1
static CUDA_CALLABLE wp::vec_t<33, wp::int32> bin_by_traversal_0(
    wp::int32 var_rank,
    wp::int32 var_neighborhood__tree__count,
    wp::int32 var_neighborhood__tree__root,
    wp::array_t<wp::int32> var_neighborhood__tree__levels,
    wp::array_t<wp::float32> var_neighborhood__tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> var_neighborhood__tree__points,
    wp::array_t<wp::int64> var_neighborhood__limits,
    wp::array_t<wp::vec_t<3, wp::float32>> var_normals)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float32>* var_0;
    wp::vec_t<3, wp::float32> var_1;
    wp::vec_t<3, wp::float32> var_2;
    wp::vec_t<3, wp::float32>* var_3;
    wp::vec_t<3, wp::float32> var_4;
    wp::vec_t<3, wp::float32> var_5;
    const wp::int32 var_6 = 0;
    wp::vec_t<33, wp::int32> var_7;
    wp::vec_t<3, wp::float32>* var_8;
    wp::vec_t<3, wp::float32> var_9;
    wp::vec_t<3, wp::float32> var_10;
    wp::int64* var_11;
    wp::int64 var_12;
    wp::int64 var_13;
    const wp::int32 var_14 = 64;
    wp::int32 var_15;
    wp::float32 var_16;
    wp::vec_t<4, wp::int64> var_17;
    const wp::int32 var_18 = 0;
    wp::int64 var_19;
    wp::int32 var_20;
    bool var_21;
    const wp::int32 var_22 = 2;
    wp::int64 var_23;
    wp::int32 var_24;
    wp::vec_t<8, wp::float32> var_25;
    const wp::int32 var_26 = 0;
    wp::float32 var_27;
    bool var_28;
    const wp::int32 var_29 = 64;
    wp::int32 var_30;
    const wp::int32 var_31 = 8;
    wp::int32 var_32;
    wp::int32 var_33;
    const wp::int32 var_34 = 8;
    wp::int32 var_35;
    wp::int32 var_36;
    wp::range_t var_37;
    wp::int32 var_38;
    wp::vec_t<3, wp::float32>* var_39;
    wp::float32 var_40;
    wp::vec_t<3, wp::float32> var_41;
    bool var_42;
    wp::int64 var_43;
    bool var_44;
    wp::vec_t<3, wp::float32>* var_45;
    wp::vec_t<3, wp::float32> var_46;
    wp::vec_t<3, wp::float32> var_47;
    wp::vec_t<3, wp::float32> var_48;
    wp::vec_t<3, wp::float32>* var_49;
    wp::int32 var_50;
    wp::vec_t<3, wp::float32> var_51;
    wp::vec_t<3, wp::float32>* var_52;
    wp::int32 var_53;
    wp::vec_t<3, wp::float32> var_54;
    const wp::int32 var_55 = 15;
    wp::int32 var_56;
    const wp::int32 var_57 = 1;
    const wp::int32 var_58 = 11;
    const wp::int32 var_59 = 4;
    wp::int32 var_60;
    wp::int32 var_61;
    wp::int32 var_62;
    const wp::int32 var_63 = 1;
    const wp::int32 var_64 = 2;
    wp::int32 var_65;
    const wp::int32 var_66 = 2;
    wp::int32 var_67;
    wp::int32 var_68;
    wp::int32 var_69;
    const wp::int32 var_70 = 1;
    const wp::int32 var_71 = 1;
    wp::float32 var_72;
    bool var_73;
    wp::int32 var_74;
    wp::int32 var_75;
    wp::int32 var_76;
    wp::int32 var_77;
    wp::int32 var_78;
    wp::range_t var_79;
    wp::int32 var_80;
    wp::vec_t<3, wp::float32>* var_81;
    wp::float32 var_82;
    wp::vec_t<3, wp::float32> var_83;
    bool var_84;
    wp::int64 var_85;
    bool var_86;
    wp::vec_t<3, wp::float32>* var_87;
    wp::vec_t<3, wp::float32> var_88;
    wp::vec_t<3, wp::float32> var_89;
    wp::vec_t<3, wp::float32> var_90;
    wp::vec_t<3, wp::float32>* var_91;
    wp::int32 var_92;
    wp::vec_t<3, wp::float32> var_93;
    wp::vec_t<3, wp::float32>* var_94;
    wp::int32 var_95;
    wp::vec_t<3, wp::float32> var_96;
    wp::int32 var_97;
    const wp::int32 var_98 = 1;
    wp::int32 var_99;
    wp::int32 var_100;
    wp::int32 var_101;
    const wp::int32 var_102 = 1;
    const wp::int32 var_103 = 2;
    wp::int32 var_104;
    const wp::int32 var_105 = 2;
    wp::int32 var_106;
    wp::int32 var_107;
    wp::int32 var_108;
    const wp::int32 var_109 = 1;
    wp::vec_t<3, wp::float32> var_110;
    wp::int32 var_111;
    wp::vec_t<3, wp::float32> var_112;
    wp::int32 var_113;
    wp::int32 var_114;
    wp::int32 var_115;
    const wp::int32 var_116 = 2;
    wp::float32 var_117;
    bool var_118;
    wp::int32 var_119;
    wp::int32 var_120;
    wp::int32 var_121;
    wp::int32 var_122;
    wp::int32 var_123;
    wp::range_t var_124;
    wp::int32 var_125;
    wp::vec_t<3, wp::float32>* var_126;
    wp::float32 var_127;
    wp::vec_t<3, wp::float32> var_128;
    bool var_129;
    wp::int64 var_130;
    bool var_131;
    wp::vec_t<3, wp::float32>* var_132;
    wp::vec_t<3, wp::float32> var_133;
    wp::vec_t<3, wp::float32> var_134;
    wp::vec_t<3, wp::float32> var_135;
    wp::vec_t<3, wp::float32>* var_136;
    wp::int32 var_137;
    wp::vec_t<3, wp::float32> var_138;
    wp::vec_t<3, wp::float32>* var_139;
    wp::int32 var_140;
    wp::vec_t<3, wp::float32> var_141;
    wp::int32 var_142;
    const wp::int32 var_143 = 1;
    wp::int32 var_144;
    wp::int32 var_145;
    wp::int32 var_146;
    const wp::int32 var_147 = 1;
    const wp::int32 var_148 = 2;
    wp::int32 var_149;
    const wp::int32 var_150 = 2;
    wp::int32 var_151;
    wp::int32 var_152;
    wp::int32 var_153;
    const wp::int32 var_154 = 1;
    wp::vec_t<3, wp::float32> var_155;
    wp::int32 var_156;
    wp::vec_t<3, wp::float32> var_157;
    wp::int32 var_158;
    wp::int32 var_159;
    wp::int32 var_160;
    const wp::int32 var_161 = 3;
    wp::float32 var_162;
    bool var_163;
    wp::int32 var_164;
    wp::int32 var_165;
    wp::int32 var_166;
    wp::int32 var_167;
    wp::int32 var_168;
    wp::range_t var_169;
    wp::int32 var_170;
    wp::vec_t<3, wp::float32>* var_171;
    wp::float32 var_172;
    wp::vec_t<3, wp::float32> var_173;
    bool var_174;
    wp::int64 var_175;
    bool var_176;
    wp::vec_t<3, wp::float32>* var_177;
    wp::vec_t<3, wp::float32> var_178;
    wp::vec_t<3, wp::float32> var_179;
    wp::vec_t<3, wp::float32> var_180;
    wp::vec_t<3, wp::float32>* var_181;
    wp::int32 var_182;
    wp::vec_t<3, wp::float32> var_183;
    wp::vec_t<3, wp::float32>* var_184;
    wp::int32 var_185;
    wp::vec_t<3, wp::float32> var_186;
    wp::int32 var_187;
    const wp::int32 var_188 = 1;
    wp::int32 var_189;
    wp::int32 var_190;
    wp::int32 var_191;
    const wp::int32 var_192 = 1;
    const wp::int32 var_193 = 2;
    wp::int32 var_194;
    const wp::int32 var_195 = 2;
    wp::int32 var_196;
    wp::int32 var_197;
    wp::int32 var_198;
    const wp::int32 var_199 = 1;
    wp::vec_t<3, wp::float32> var_200;
    wp::int32 var_201;
    wp::vec_t<3, wp::float32> var_202;
    wp::int32 var_203;
    wp::int32 var_204;
    wp::int32 var_205;
    const wp::int32 var_206 = 4;
    wp::float32 var_207;
    bool var_208;
    wp::int32 var_209;
    wp::int32 var_210;
    wp::int32 var_211;
    wp::int32 var_212;
    wp::int32 var_213;
    wp::range_t var_214;
    wp::int32 var_215;
    wp::vec_t<3, wp::float32>* var_216;
    wp::float32 var_217;
    wp::vec_t<3, wp::float32> var_218;
    bool var_219;
    wp::int64 var_220;
    bool var_221;
    wp::vec_t<3, wp::float32>* var_222;
    wp::vec_t<3, wp::float32> var_223;
    wp::vec_t<3, wp::float32> var_224;
    wp::vec_t<3, wp::float32> var_225;
    wp::vec_t<3, wp::float32>* var_226;
    wp::int32 var_227;
    wp::vec_t<3, wp::float32> var_228;
    wp::vec_t<3, wp::float32>* var_229;
    wp::int32 var_230;
    wp::vec_t<3, wp::float32> var_231;
    wp::int32 var_232;
    const wp::int32 var_233 = 1;
    wp::int32 var_234;
    wp::int32 var_235;
    wp::int32 var_236;
    const wp::int32 var_237 = 1;
    const wp::int32 var_238 = 2;
    wp::int32 var_239;
    const wp::int32 var_240 = 2;
    wp::int32 var_241;
    wp::int32 var_242;
    wp::int32 var_243;
    const wp::int32 var_244 = 1;
    wp::vec_t<3, wp::float32> var_245;
    wp::int32 var_246;
    wp::vec_t<3, wp::float32> var_247;
    wp::int32 var_248;
    wp::int32 var_249;
    wp::int32 var_250;
    const wp::int32 var_251 = 5;
    wp::float32 var_252;
    bool var_253;
    wp::int32 var_254;
    wp::int32 var_255;
    wp::int32 var_256;
    wp::int32 var_257;
    wp::int32 var_258;
    wp::range_t var_259;
    wp::int32 var_260;
    wp::vec_t<3, wp::float32>* var_261;
    wp::float32 var_262;
    wp::vec_t<3, wp::float32> var_263;
    bool var_264;
    wp::int64 var_265;
    bool var_266;
    wp::vec_t<3, wp::float32>* var_267;
    wp::vec_t<3, wp::float32> var_268;
    wp::vec_t<3, wp::float32> var_269;
    wp::vec_t<3, wp::float32> var_270;
    wp::vec_t<3, wp::float32>* var_271;
    wp::int32 var_272;
    wp::vec_t<3, wp::float32> var_273;
    wp::vec_t<3, wp::float32>* var_274;
    wp::int32 var_275;
    wp::vec_t<3, wp::float32> var_276;
    wp::int32 var_277;
    const wp::int32 var_278 = 1;
    wp::int32 var_279;
    wp::int32 var_280;
    wp::int32 var_281;
    const wp::int32 var_282 = 1;
    const wp::int32 var_283 = 2;
    wp::int32 var_284;
    const wp::int32 var_285 = 2;
    wp::int32 var_286;
    wp::int32 var_287;
    wp::int32 var_288;
    const wp::int32 var_289 = 1;
    wp::vec_t<3, wp::float32> var_290;
    wp::int32 var_291;
    wp::vec_t<3, wp::float32> var_292;
    wp::int32 var_293;
    wp::int32 var_294;
    wp::int32 var_295;
    const wp::int32 var_296 = 6;
    wp::float32 var_297;
    bool var_298;
    wp::int32 var_299;
    wp::int32 var_300;
    wp::int32 var_301;
    wp::int32 var_302;
    wp::int32 var_303;
    wp::range_t var_304;
    wp::int32 var_305;
    wp::vec_t<3, wp::float32>* var_306;
    wp::float32 var_307;
    wp::vec_t<3, wp::float32> var_308;
    bool var_309;
    wp::int64 var_310;
    bool var_311;
    wp::vec_t<3, wp::float32>* var_312;
    wp::vec_t<3, wp::float32> var_313;
    wp::vec_t<3, wp::float32> var_314;
    wp::vec_t<3, wp::float32> var_315;
    wp::vec_t<3, wp::float32>* var_316;
    wp::int32 var_317;
    wp::vec_t<3, wp::float32> var_318;
    wp::vec_t<3, wp::float32>* var_319;
    wp::int32 var_320;
    wp::vec_t<3, wp::float32> var_321;
    wp::int32 var_322;
    const wp::int32 var_323 = 1;
    wp::int32 var_324;
    wp::int32 var_325;
    wp::int32 var_326;
    const wp::int32 var_327 = 1;
    const wp::int32 var_328 = 2;
    wp::int32 var_329;
    const wp::int32 var_330 = 2;
    wp::int32 var_331;
    wp::int32 var_332;
    wp::int32 var_333;
    const wp::int32 var_334 = 1;
    wp::vec_t<3, wp::float32> var_335;
    wp::int32 var_336;
    wp::vec_t<3, wp::float32> var_337;
    wp::int32 var_338;
    wp::int32 var_339;
    wp::int32 var_340;
    const wp::int32 var_341 = 7;
    wp::float32 var_342;
    bool var_343;
    wp::int32 var_344;
    wp::int32 var_345;
    wp::int32 var_346;
    wp::int32 var_347;
    wp::int32 var_348;
    wp::range_t var_349;
    wp::int32 var_350;
    wp::vec_t<3, wp::float32>* var_351;
    wp::float32 var_352;
    wp::vec_t<3, wp::float32> var_353;
    bool var_354;
    wp::int64 var_355;
    bool var_356;
    wp::vec_t<3, wp::float32>* var_357;
    wp::vec_t<3, wp::float32> var_358;
    wp::vec_t<3, wp::float32> var_359;
    wp::vec_t<3, wp::float32> var_360;
    wp::vec_t<3, wp::float32>* var_361;
    wp::int32 var_362;
    wp::vec_t<3, wp::float32> var_363;
    wp::vec_t<3, wp::float32>* var_364;
    wp::int32 var_365;
    wp::vec_t<3, wp::float32> var_366;
    wp::int32 var_367;
    const wp::int32 var_368 = 1;
    wp::int32 var_369;
    wp::int32 var_370;
    wp::int32 var_371;
    const wp::int32 var_372 = 1;
    const wp::int32 var_373 = 2;
    wp::int32 var_374;
    const wp::int32 var_375 = 2;
    wp::int32 var_376;
    wp::int32 var_377;
    wp::int32 var_378;
    const wp::int32 var_379 = 1;
    wp::vec_t<3, wp::float32> var_380;
    wp::int32 var_381;
    wp::vec_t<3, wp::float32> var_382;
    wp::int32 var_383;
    wp::int32 var_384;
    wp::int32 var_385;
    wp::vec_t<4, wp::int64> var_386;
    //---------
    // forward
    // def bin_by_traversal(rank, neighborhood__tree__count, neighborhood__tree__root, neighborhood__tree__levels, neighborhood__tree__boxes, neighborhood__tree__points, neighborhood__limits, normals):       <L 1>
    // p = neighborhood__tree__points[rank]                                                   <L 3>
    var_0 = wp::address(var_neighborhood__tree__points, var_rank);
    var_2 = wp::load(var_0);
    var_1 = wp::copy(var_2);
    // n = normals[rank]                                                                      <L 4>
    var_3 = wp::address(var_normals, var_rank);
    var_5 = wp::load(var_3);
    var_4 = wp::copy(var_5);
    // counts = histogram(0)                                                                  <L 5>
    var_7 = wp::vec_t<33, wp::int32>(var_6);
    // p__neighbors_of__1 = neighborhood__tree__points[rank]                                  <L 6>
    var_8 = wp::address(var_neighborhood__tree__points, var_rank);
    var_10 = wp::load(var_8);
    var_9 = wp::copy(var_10);
    // limit__neighbors_of__1 = neighborhood__limits[rank]                                    <L 7>
    var_11 = wp::address(var_neighborhood__limits, var_rank);
    var_13 = wp::load(var_11);
    var_12 = wp::copy(var_13);
    // start__points_within__2 = rank // BUCKET__neighbors_of                                 <L 8>
    var_15 = wp::floordiv(var_rank, var_14);
    // max_sqdist__points_within__2 = key_number(limit__neighbors_of__1)                      <L 9>
    var_16 = key_number_0(var_12);
    // step__leaves_within__3 = start_traversal__leaves_within(start__points_within__2)       <L 10>
    var_17 = start_traversal_0(var_15);
    // while int(step__leaves_within__3[0]) <= neighborhood__tree__root:                      <L 11>
    start_while_0:;
    var_19 = wp::extract(var_17, var_18);
    var_20 = wp::int(var_19);
    var_21 = (var_20 <= var_neighborhood__tree__root);
    if ((var_21) == false) goto end_while_0;
        // bucket__leaves_within__3 = int(step__leaves_within__3[2])                          <L 12>
        var_23 = wp::extract(var_17, var_22);
        var_24 = wp::int(var_23);
        // distances__leaves_within__3 = measure_boxes__leaves_within(neighborhood__tree__boxes, bucket__leaves_within__3, p__neighbors_of__1, p__neighbors_of__1)       <L 13>
        var_25 = measure_boxes_0(var_neighborhood__tree__boxes, var_24, var_9, var_9);
        // for leaf__leaves_within__3 in range(FAN__leaves_within):                           <L 14>
        // if distances__leaves_within__3[leaf__leaves_within__3] <= max_sqdist__points_within__2:       <L 15>
        var_27 = wp::extract(var_25, var_26);
        var_28 = (var_27 <= var_16);
        if (var_28) {
            // first__points_within__2 = bucket__leaves_within__3 * BUCKET__leaves_within + leaf__leaves_within__3 * LEAF__leaves_within       <L 16>
            var_30 = wp::mul(var_24, var_29);
            var_32 = wp::mul(var_26, var_31);
            var_33 = wp::add(var_30, var_32);
            // for j in range(first__points_within__2, min(first__points_within__2 + LEAF__points_within, neighborhood__tree__count)):       <L 17>
            var_35 = wp::add(var_33, var_34);
            var_36 = wp::min(var_35, var_neighborhood__tree__count);
            var_37 = wp::range(var_33, var_36);
            start_for_2:;
                if (iter_cmp(var_37) == 0) goto end_for_2;
                var_38 = wp::iter_next(var_37);
                // sqdist = square_distance__points_within(p__neighbors_of__1, neighborhood__tree__points[j])       <L 18>
                var_39 = wp::address(var_neighborhood__tree__points, var_38);
                var_41 = wp::load(var_39);
                var_40 = square_distance_0(var_9, var_41);
                // if sqdist <= max_sqdist__points_within__2:                                 <L 19>
                var_42 = (var_40 <= var_16);
                if (var_42) {
                    // if pack_key__neighbors_of(sqdist, j) <= limit__neighbors_of__1:        <L 20>
                    var_43 = pack_key_0(var_40, var_38);
                    var_44 = (var_43 <= var_12);
                    if (var_44) {
                        // q = neighborhood__tree__points[j]                                  <L 21>
                        var_45 = wp::address(var_neighborhood__tree__points, var_38);
                        var_47 = wp::load(var_45);
                        var_46 = wp::copy(var_47);
                        // bins = resolved_bins(quick_bins(q - p, n, normals[j]), p, n, q, normals[j])       <L 22>
                        var_48 = wp::sub(var_46, var_1);
                        var_49 = wp::address(var_normals, var_38);
                        var_51 = wp::load(var_49);
                        var_50 = quick_bins_0(var_48, var_4, var_51);
                        var_52 = wp::address(var_normals, var_38);
                        var_54 = wp::load(var_52);
                        var_53 = resolved_bins_0(var_50, var_1, var_4, var_46, var_54);
                        // counts[bins & BIN_MASK] += 1                                       <L 23>
                        var_56 = wp::bit_and(var_53, var_55);
                        wp::add_inplace(var_7, var_56, var_57);
                        // counts[BINS + (bins >> BIN_BITS & BIN_MASK)] += 1                  <L 24>
                        var_60 = wp::rshift(var_53, var_59);
                        var_61 = wp::bit_and(var_60, var_55);
                        var_62 = wp::add(var_58, var_61);
                        wp::add_inplace(var_7, var_62, var_63);
                        // counts[2 * BINS + (bins >> 2 * BIN_BITS)] += 1                     <L 25>
                        var_65 = wp::mul(var_64, var_58);
                        var_67 = wp::mul(var_66, var_59);
                        var_68 = wp::rshift(var_53, var_67);
                        var_69 = wp::add(var_65, var_68);
                        wp::add_inplace(var_7, var_69, var_70);
                    }
                }
                goto start_for_2;
            end_for_2:;
        }
        // if distances__leaves_within__3[leaf__leaves_within__3] <= max_sqdist__points_within__2:       <L 15>
        var_72 = wp::extract(var_25, var_71);
        var_73 = (var_72 <= var_16);
        if (var_73) {
            // first__points_within__2 = bucket__leaves_within__3 * BUCKET__leaves_within + leaf__leaves_within__3 * LEAF__leaves_within       <L 16>
            var_74 = wp::mul(var_24, var_29);
            var_75 = wp::mul(var_71, var_31);
            var_76 = wp::add(var_74, var_75);
            // for j in range(first__points_within__2, min(first__points_within__2 + LEAF__points_within, neighborhood__tree__count)):       <L 17>
            var_77 = wp::add(var_76, var_34);
            var_78 = wp::min(var_77, var_neighborhood__tree__count);
            var_79 = wp::range(var_76, var_78);
            start_for_4:;
                if (iter_cmp(var_79) == 0) goto end_for_4;
                var_80 = wp::iter_next(var_79);
                // sqdist = square_distance__points_within(p__neighbors_of__1, neighborhood__tree__points[j])       <L 18>
                var_81 = wp::address(var_neighborhood__tree__points, var_80);
                var_83 = wp::load(var_81);
                var_82 = square_distance_0(var_9, var_83);
                // if sqdist <= max_sqdist__points_within__2:                                 <L 19>
                var_84 = (var_82 <= var_16);
                if (var_84) {
                    // if pack_key__neighbors_of(sqdist, j) <= limit__neighbors_of__1:        <L 20>
                    var_85 = pack_key_0(var_82, var_80);
                    var_86 = (var_85 <= var_12);
                    if (var_86) {
                        // q = neighborhood__tree__points[j]                                  <L 21>
                        var_87 = wp::address(var_neighborhood__tree__points, var_80);
                        var_89 = wp::load(var_87);
                        var_88 = wp::copy(var_89);
                        // bins = resolved_bins(quick_bins(q - p, n, normals[j]), p, n, q, normals[j])       <L 22>
                        var_90 = wp::sub(var_88, var_1);
                        var_91 = wp::address(var_normals, var_80);
                        var_93 = wp::load(var_91);
                        var_92 = quick_bins_0(var_90, var_4, var_93);
                        var_94 = wp::address(var_normals, var_80);
                        var_96 = wp::load(var_94);
                        var_95 = resolved_bins_0(var_92, var_1, var_4, var_88, var_96);
                        // counts[bins & BIN_MASK] += 1                                       <L 23>
                        var_97 = wp::bit_and(var_95, var_55);
                        wp::add_inplace(var_7, var_97, var_98);
                        // counts[BINS + (bins >> BIN_BITS & BIN_MASK)] += 1                  <L 24>
                        var_99 = wp::rshift(var_95, var_59);
                        var_100 = wp::bit_and(var_99, var_55);
                        var_101 = wp::add(var_58, var_100);
                        wp::add_inplace(var_7, var_101, var_102);
                        // counts[2 * BINS + (bins >> 2 * BIN_BITS)] += 1                     <L 25>
                        var_104 = wp::mul(var_103, var_58);
                        var_106 = wp::mul(var_105, var_59);
                        var_107 = wp::rshift(var_95, var_106);
                        var_108 = wp::add(var_104, var_107);
                        wp::add_inplace(var_7, var_108, var_109);
                    }
                    var_110 = wp::where(var_86, var_88, var_46);
                    var_111 = wp::where(var_86, var_95, var_53);
                }
                var_112 = wp::where(var_84, var_110, var_46);
                var_113 = wp::where(var_84, var_111, var_53);
                wp::assign(var_40, var_82);
                wp::assign(var_46, var_112);
                wp::assign(var_53, var_113);
                goto start_for_4;
            end_for_4:;
        }
        var_114 = wp::where(var_73, var_76, var_33);
        var_115 = wp::where(var_73, var_80, var_38);
        // if distances__leaves_within__3[leaf__leaves_within__3] <= max_sqdist__points_within__2:       <L 15>
        var_117 = wp::extract(var_25, var_116);
        var_118 = (var_117 <= var_16);
        if (var_118) {
            // first__points_within__2 = bucket__leaves_within__3 * BUCKET__leaves_within + leaf__leaves_within__3 * LEAF__leaves_within       <L 16>
            var_119 = wp::mul(var_24, var_29);
            var_120 = wp::mul(var_116, var_31);
            var_121 = wp::add(var_119, var_120);
            // for j in range(first__points_within__2, min(first__points_within__2 + LEAF__points_within, neighborhood__tree__count)):       <L 17>
            var_122 = wp::add(var_121, var_34);
            var_123 = wp::min(var_122, var_neighborhood__tree__count);
            var_124 = wp::range(var_121, var_123);
            start_for_6:;
                if (iter_cmp(var_124) == 0) goto end_for_6;
                var_125 = wp::iter_next(var_124);
                // sqdist = square_distance__points_within(p__neighbors_of__1, neighborhood__tree__points[j])       <L 18>
                var_126 = wp::address(var_neighborhood__tree__points, var_125);
                var_128 = wp::load(var_126);
                var_127 = square_distance_0(var_9, var_128);
                // if sqdist <= max_sqdist__points_within__2:                                 <L 19>
                var_129 = (var_127 <= var_16);
                if (var_129) {
                    // if pack_key__neighbors_of(sqdist, j) <= limit__neighbors_of__1:        <L 20>
                    var_130 = pack_key_0(var_127, var_125);
                    var_131 = (var_130 <= var_12);
                    if (var_131) {
                        // q = neighborhood__tree__points[j]                                  <L 21>
                        var_132 = wp::address(var_neighborhood__tree__points, var_125);
                        var_134 = wp::load(var_132);
                        var_133 = wp::copy(var_134);
                        // bins = resolved_bins(quick_bins(q - p, n, normals[j]), p, n, q, normals[j])       <L 22>
                        var_135 = wp::sub(var_133, var_1);
                        var_136 = wp::address(var_normals, var_125);
                        var_138 = wp::load(var_136);
                        var_137 = quick_bins_0(var_135, var_4, var_138);
                        var_139 = wp::address(var_normals, var_125);
                        var_141 = wp::load(var_139);
                        var_140 = resolved_bins_0(var_137, var_1, var_4, var_133, var_141);
                        // counts[bins & BIN_MASK] += 1                                       <L 23>
                        var_142 = wp::bit_and(var_140, var_55);
                        wp::add_inplace(var_7, var_142, var_143);
                        // counts[BINS + (bins >> BIN_BITS & BIN_MASK)] += 1                  <L 24>
                        var_144 = wp::rshift(var_140, var_59);
                        var_145 = wp::bit_and(var_144, var_55);
                        var_146 = wp::add(var_58, var_145);
                        wp::add_inplace(var_7, var_146, var_147);
                        // counts[2 * BINS + (bins >> 2 * BIN_BITS)] += 1                     <L 25>
                        var_149 = wp::mul(var_148, var_58);
                        var_151 = wp::mul(var_150, var_59);
                        var_152 = wp::rshift(var_140, var_151);
                        var_153 = wp::add(var_149, var_152);
                        wp::add_inplace(var_7, var_153, var_154);
                    }
                    var_155 = wp::where(var_131, var_133, var_46);
                    var_156 = wp::where(var_131, var_140, var_53);
                }
                var_157 = wp::where(var_129, var_155, var_46);
                var_158 = wp::where(var_129, var_156, var_53);
                wp::assign(var_40, var_127);
                wp::assign(var_46, var_157);
                wp::assign(var_53, var_158);
                goto start_for_6;
            end_for_6:;
        }
        var_159 = wp::where(var_118, var_121, var_114);
        var_160 = wp::where(var_118, var_125, var_115);
        // if distances__leaves_within__3[leaf__leaves_within__3] <= max_sqdist__points_within__2:       <L 15>
        var_162 = wp::extract(var_25, var_161);
        var_163 = (var_162 <= var_16);
        if (var_163) {
            // first__points_within__2 = bucket__leaves_within__3 * BUCKET__leaves_within + leaf__leaves_within__3 * LEAF__leaves_within       <L 16>
            var_164 = wp::mul(var_24, var_29);
            var_165 = wp::mul(var_161, var_31);
            var_166 = wp::add(var_164, var_165);
            // for j in range(first__points_within__2, min(first__points_within__2 + LEAF__points_within, neighborhood__tree__count)):       <L 17>
            var_167 = wp::add(var_166, var_34);
            var_168 = wp::min(var_167, var_neighborhood__tree__count);
            var_169 = wp::range(var_166, var_168);
            start_for_8:;
                if (iter_cmp(var_169) == 0) goto end_for_8;
                var_170 = wp::iter_next(var_169);
                // sqdist = square_distance__points_within(p__neighbors_of__1, neighborhood__tree__points[j])       <L 18>
                var_171 = wp::address(var_neighborhood__tree__points, var_170);
                var_173 = wp::load(var_171);
                var_172 = square_distance_0(var_9, var_173);
                // if sqdist <= max_sqdist__points_within__2:                                 <L 19>
                var_174 = (var_172 <= var_16);
                if (var_174) {
                    // if pack_key__neighbors_of(sqdist, j) <= limit__neighbors_of__1:        <L 20>
                    var_175 = pack_key_0(var_172, var_170);
                    var_176 = (var_175 <= var_12);
                    if (var_176) {
                        // q = neighborhood__tree__points[j]                                  <L 21>
                        var_177 = wp::address(var_neighborhood__tree__points, var_170);
                        var_179 = wp::load(var_177);
                        var_178 = wp::copy(var_179);
                        // bins = resolved_bins(quick_bins(q - p, n, normals[j]), p, n, q, normals[j])       <L 22>
                        var_180 = wp::sub(var_178, var_1);
                        var_181 = wp::address(var_normals, var_170);
                        var_183 = wp::load(var_181);
                        var_182 = quick_bins_0(var_180, var_4, var_183);
                        var_184 = wp::address(var_normals, var_170);
                        var_186 = wp::load(var_184);
                        var_185 = resolved_bins_0(var_182, var_1, var_4, var_178, var_186);
                        // counts[bins & BIN_MASK] += 1                                       <L 23>
                        var_187 = wp::bit_and(var_185, var_55);
                        wp::add_inplace(var_7, var_187, var_188);
                        // counts[BINS + (bins >> BIN_BITS & BIN_MASK)] += 1                  <L 24>
                        var_189 = wp::rshift(var_185, var_59);
                        var_190 = wp::bit_and(var_189, var_55);
                        var_191 = wp::add(var_58, var_190);
                        wp::add_inplace(var_7, var_191, var_192);
                        // counts[2 * BINS + (bins >> 2 * BIN_BITS)] += 1                     <L 25>
                        var_194 = wp::mul(var_193, var_58);
                        var_196 = wp::mul(var_195, var_59);
                        var_197 = wp::rshift(var_185, var_196);
                        var_198 = wp::add(var_194, var_197);
                        wp::add_inplace(var_7, var_198, var_199);
                    }
                    var_200 = wp::where(var_176, var_178, var_46);
                    var_201 = wp::where(var_176, var_185, var_53);
                }
                var_202 = wp::where(var_174, var_200, var_46);
                var_203 = wp::where(var_174, var_201, var_53);
                wp::assign(var_40, var_172);
                wp::assign(var_46, var_202);
                wp::assign(var_53, var_203);
                goto start_for_8;
            end_for_8:;
        }
        var_204 = wp::where(var_163, var_166, var_159);
        var_205 = wp::where(var_163, var_170, var_160);
        // if distances__leaves_within__3[leaf__leaves_within__3] <= max_sqdist__points_within__2:       <L 15>
        var_207 = wp::extract(var_25, var_206);
        var_208 = (var_207 <= var_16);
        if (var_208) {
            // first__points_within__2 = bucket__leaves_within__3 * BUCKET__leaves_within + leaf__leaves_within__3 * LEAF__leaves_within       <L 16>
            var_209 = wp::mul(var_24, var_29);
            var_210 = wp::mul(var_206, var_31);
            var_211 = wp::add(var_209, var_210);
            // for j in range(first__points_within__2, min(first__points_within__2 + LEAF__points_within, neighborhood__tree__count)):       <L 17>
            var_212 = wp::add(var_211, var_34);
            var_213 = wp::min(var_212, var_neighborhood__tree__count);
            var_214 = wp::range(var_211, var_213);
            start_for_10:;
                if (iter_cmp(var_214) == 0) goto end_for_10;
                var_215 = wp::iter_next(var_214);
                // sqdist = square_distance__points_within(p__neighbors_of__1, neighborhood__tree__points[j])       <L 18>
                var_216 = wp::address(var_neighborhood__tree__points, var_215);
                var_218 = wp::load(var_216);
                var_217 = square_distance_0(var_9, var_218);
                // if sqdist <= max_sqdist__points_within__2:                                 <L 19>
                var_219 = (var_217 <= var_16);
                if (var_219) {
                    // if pack_key__neighbors_of(sqdist, j) <= limit__neighbors_of__1:        <L 20>
                    var_220 = pack_key_0(var_217, var_215);
                    var_221 = (var_220 <= var_12);
                    if (var_221) {
                        // q = neighborhood__tree__points[j]                                  <L 21>
                        var_222 = wp::address(var_neighborhood__tree__points, var_215);
                        var_224 = wp::load(var_222);
                        var_223 = wp::copy(var_224);
                        // bins = resolved_bins(quick_bins(q - p, n, normals[j]), p, n, q, normals[j])       <L 22>
                        var_225 = wp::sub(var_223, var_1);
                        var_226 = wp::address(var_normals, var_215);
                        var_228 = wp::load(var_226);
                        var_227 = quick_bins_0(var_225, var_4, var_228);
                        var_229 = wp::address(var_normals, var_215);
                        var_231 = wp::load(var_229);
                        var_230 = resolved_bins_0(var_227, var_1, var_4, var_223, var_231);
                        // counts[bins & BIN_MASK] += 1                                       <L 23>
                        var_232 = wp::bit_and(var_230, var_55);
                        wp::add_inplace(var_7, var_232, var_233);
                        // counts[BINS + (bins >> BIN_BITS & BIN_MASK)] += 1                  <L 24>
                        var_234 = wp::rshift(var_230, var_59);
                        var_235 = wp::bit_and(var_234, var_55);
                        var_236 = wp::add(var_58, var_235);
                        wp::add_inplace(var_7, var_236, var_237);
                        // counts[2 * BINS + (bins >> 2 * BIN_BITS)] += 1                     <L 25>
                        var_239 = wp::mul(var_238, var_58);
                        var_241 = wp::mul(var_240, var_59);
                        var_242 = wp::rshift(var_230, var_241);
                        var_243 = wp::add(var_239, var_242);
                        wp::add_inplace(var_7, var_243, var_244);
                    }
                    var_245 = wp::where(var_221, var_223, var_46);
                    var_246 = wp::where(var_221, var_230, var_53);
                }
                var_247 = wp::where(var_219, var_245, var_46);
                var_248 = wp::where(var_219, var_246, var_53);
                wp::assign(var_40, var_217);
                wp::assign(var_46, var_247);
                wp::assign(var_53, var_248);
                goto start_for_10;
            end_for_10:;
        }
        var_249 = wp::where(var_208, var_211, var_204);
        var_250 = wp::where(var_208, var_215, var_205);
        // if distances__leaves_within__3[leaf__leaves_within__3] <= max_sqdist__points_within__2:       <L 15>
        var_252 = wp::extract(var_25, var_251);
        var_253 = (var_252 <= var_16);
        if (var_253) {
            // first__points_within__2 = bucket__leaves_within__3 * BUCKET__leaves_within + leaf__leaves_within__3 * LEAF__leaves_within       <L 16>
            var_254 = wp::mul(var_24, var_29);
            var_255 = wp::mul(var_251, var_31);
            var_256 = wp::add(var_254, var_255);
            // for j in range(first__points_within__2, min(first__points_within__2 + LEAF__points_within, neighborhood__tree__count)):       <L 17>
            var_257 = wp::add(var_256, var_34);
            var_258 = wp::min(var_257, var_neighborhood__tree__count);
            var_259 = wp::range(var_256, var_258);
            start_for_12:;
                if (iter_cmp(var_259) == 0) goto end_for_12;
                var_260 = wp::iter_next(var_259);
                // sqdist = square_distance__points_within(p__neighbors_of__1, neighborhood__tree__points[j])       <L 18>
                var_261 = wp::address(var_neighborhood__tree__points, var_260);
                var_263 = wp::load(var_261);
                var_262 = square_distance_0(var_9, var_263);
                // if sqdist <= max_sqdist__points_within__2:                                 <L 19>
                var_264 = (var_262 <= var_16);
                if (var_264) {
                    // if pack_key__neighbors_of(sqdist, j) <= limit__neighbors_of__1:        <L 20>
                    var_265 = pack_key_0(var_262, var_260);
                    var_266 = (var_265 <= var_12);
                    if (var_266) {
                        // q = neighborhood__tree__points[j]                                  <L 21>
                        var_267 = wp::address(var_neighborhood__tree__points, var_260);
                        var_269 = wp::load(var_267);
                        var_268 = wp::copy(var_269);
                        // bins = resolved_bins(quick_bins(q - p, n, normals[j]), p, n, q, normals[j])       <L 22>
                        var_270 = wp::sub(var_268, var_1);
                        var_271 = wp::address(var_normals, var_260);
                        var_273 = wp::load(var_271);
                        var_272 = quick_bins_0(var_270, var_4, var_273);
                        var_274 = wp::address(var_normals, var_260);
                        var_276 = wp::load(var_274);
                        var_275 = resolved_bins_0(var_272, var_1, var_4, var_268, var_276);
                        // counts[bins & BIN_MASK] += 1                                       <L 23>
                        var_277 = wp::bit_and(var_275, var_55);
                        wp::add_inplace(var_7, var_277, var_278);
                        // counts[BINS + (bins >> BIN_BITS & BIN_MASK)] += 1                  <L 24>
                        var_279 = wp::rshift(var_275, var_59);
                        var_280 = wp::bit_and(var_279, var_55);
                        var_281 = wp::add(var_58, var_280);
                        wp::add_inplace(var_7, var_281, var_282);
                        // counts[2 * BINS + (bins >> 2 * BIN_BITS)] += 1                     <L 25>
                        var_284 = wp::mul(var_283, var_58);
                        var_286 = wp::mul(var_285, var_59);
                        var_287 = wp::rshift(var_275, var_286);
                        var_288 = wp::add(var_284, var_287);
                        wp::add_inplace(var_7, var_288, var_289);
                    }
                    var_290 = wp::where(var_266, var_268, var_46);
                    var_291 = wp::where(var_266, var_275, var_53);
                }
                var_292 = wp::where(var_264, var_290, var_46);
                var_293 = wp::where(var_264, var_291, var_53);
                wp::assign(var_40, var_262);
                wp::assign(var_46, var_292);
                wp::assign(var_53, var_293);
                goto start_for_12;
            end_for_12:;
        }
        var_294 = wp::where(var_253, var_256, var_249);
        var_295 = wp::where(var_253, var_260, var_250);
        // if distances__leaves_within__3[leaf__leaves_within__3] <= max_sqdist__points_within__2:       <L 15>
        var_297 = wp::extract(var_25, var_296);
        var_298 = (var_297 <= var_16);
        if (var_298) {
            // first__points_within__2 = bucket__leaves_within__3 * BUCKET__leaves_within + leaf__leaves_within__3 * LEAF__leaves_within       <L 16>
            var_299 = wp::mul(var_24, var_29);
            var_300 = wp::mul(var_296, var_31);
            var_301 = wp::add(var_299, var_300);
            // for j in range(first__points_within__2, min(first__points_within__2 + LEAF__points_within, neighborhood__tree__count)):       <L 17>
            var_302 = wp::add(var_301, var_34);
            var_303 = wp::min(var_302, var_neighborhood__tree__count);
            var_304 = wp::range(var_301, var_303);
            start_for_14:;
                if (iter_cmp(var_304) == 0) goto end_for_14;
                var_305 = wp::iter_next(var_304);
                // sqdist = square_distance__points_within(p__neighbors_of__1, neighborhood__tree__points[j])       <L 18>
                var_306 = wp::address(var_neighborhood__tree__points, var_305);
                var_308 = wp::load(var_306);
                var_307 = square_distance_0(var_9, var_308);
                // if sqdist <= max_sqdist__points_within__2:                                 <L 19>
                var_309 = (var_307 <= var_16);
                if (var_309) {
                    // if pack_key__neighbors_of(sqdist, j) <= limit__neighbors_of__1:        <L 20>
                    var_310 = pack_key_0(var_307, var_305);
                    var_311 = (var_310 <= var_12);
                    if (var_311) {
                        // q = neighborhood__tree__points[j]                                  <L 21>
                        var_312 = wp::address(var_neighborhood__tree__points, var_305);
                        var_314 = wp::load(var_312);
                        var_313 = wp::copy(var_314);
                        // bins = resolved_bins(quick_bins(q - p, n, normals[j]), p, n, q, normals[j])       <L 22>
                        var_315 = wp::sub(var_313, var_1);
                        var_316 = wp::address(var_normals, var_305);
                        var_318 = wp::load(var_316);
                        var_317 = quick_bins_0(var_315, var_4, var_318);
                        var_319 = wp::address(var_normals, var_305);
                        var_321 = wp::load(var_319);
                        var_320 = resolved_bins_0(var_317, var_1, var_4, var_313, var_321);
                        // counts[bins & BIN_MASK] += 1                                       <L 23>
                        var_322 = wp::bit_and(var_320, var_55);
                        wp::add_inplace(var_7, var_322, var_323);
                        // counts[BINS + (bins >> BIN_BITS & BIN_MASK)] += 1                  <L 24>
                        var_324 = wp::rshift(var_320, var_59);
                        var_325 = wp::bit_and(var_324, var_55);
                        var_326 = wp::add(var_58, var_325);
                        wp::add_inplace(var_7, var_326, var_327);
                        // counts[2 * BINS + (bins >> 2 * BIN_BITS)] += 1                     <L 25>
                        var_329 = wp::mul(var_328, var_58);
                        var_331 = wp::mul(var_330, var_59);
                        var_332 = wp::rshift(var_320, var_331);
                        var_333 = wp::add(var_329, var_332);
                        wp::add_inplace(var_7, var_333, var_334);
                    }
                    var_335 = wp::where(var_311, var_313, var_46);
                    var_336 = wp::where(var_311, var_320, var_53);
                }
                var_337 = wp::where(var_309, var_335, var_46);
                var_338 = wp::where(var_309, var_336, var_53);
                wp::assign(var_40, var_307);
                wp::assign(var_46, var_337);
                wp::assign(var_53, var_338);
                goto start_for_14;
            end_for_14:;
        }
        var_339 = wp::where(var_298, var_301, var_294);
        var_340 = wp::where(var_298, var_305, var_295);
        // if distances__leaves_within__3[leaf__leaves_within__3] <= max_sqdist__points_within__2:       <L 15>
        var_342 = wp::extract(var_25, var_341);
        var_343 = (var_342 <= var_16);
        if (var_343) {
            // first__points_within__2 = bucket__leaves_within__3 * BUCKET__leaves_within + leaf__leaves_within__3 * LEAF__leaves_within       <L 16>
            var_344 = wp::mul(var_24, var_29);
            var_345 = wp::mul(var_341, var_31);
            var_346 = wp::add(var_344, var_345);
            // for j in range(first__points_within__2, min(first__points_within__2 + LEAF__points_within, neighborhood__tree__count)):       <L 17>
            var_347 = wp::add(var_346, var_34);
            var_348 = wp::min(var_347, var_neighborhood__tree__count);
            var_349 = wp::range(var_346, var_348);
            start_for_16:;
                if (iter_cmp(var_349) == 0) goto end_for_16;
                var_350 = wp::iter_next(var_349);
                // sqdist = square_distance__points_within(p__neighbors_of__1, neighborhood__tree__points[j])       <L 18>
                var_351 = wp::address(var_neighborhood__tree__points, var_350);
                var_353 = wp::load(var_351);
                var_352 = square_distance_0(var_9, var_353);
                // if sqdist <= max_sqdist__points_within__2:                                 <L 19>
                var_354 = (var_352 <= var_16);
                if (var_354) {
                    // if pack_key__neighbors_of(sqdist, j) <= limit__neighbors_of__1:        <L 20>
                    var_355 = pack_key_0(var_352, var_350);
                    var_356 = (var_355 <= var_12);
                    if (var_356) {
                        // q = neighborhood__tree__points[j]                                  <L 21>
                        var_357 = wp::address(var_neighborhood__tree__points, var_350);
                        var_359 = wp::load(var_357);
                        var_358 = wp::copy(var_359);
                        // bins = resolved_bins(quick_bins(q - p, n, normals[j]), p, n, q, normals[j])       <L 22>
                        var_360 = wp::sub(var_358, var_1);
                        var_361 = wp::address(var_normals, var_350);
                        var_363 = wp::load(var_361);
                        var_362 = quick_bins_0(var_360, var_4, var_363);
                        var_364 = wp::address(var_normals, var_350);
                        var_366 = wp::load(var_364);
                        var_365 = resolved_bins_0(var_362, var_1, var_4, var_358, var_366);
                        // counts[bins & BIN_MASK] += 1                                       <L 23>
                        var_367 = wp::bit_and(var_365, var_55);
                        wp::add_inplace(var_7, var_367, var_368);
                        // counts[BINS + (bins >> BIN_BITS & BIN_MASK)] += 1                  <L 24>
                        var_369 = wp::rshift(var_365, var_59);
                        var_370 = wp::bit_and(var_369, var_55);
                        var_371 = wp::add(var_58, var_370);
                        wp::add_inplace(var_7, var_371, var_372);
                        // counts[2 * BINS + (bins >> 2 * BIN_BITS)] += 1                     <L 25>
                        var_374 = wp::mul(var_373, var_58);
                        var_376 = wp::mul(var_375, var_59);
                        var_377 = wp::rshift(var_365, var_376);
                        var_378 = wp::add(var_374, var_377);
                        wp::add_inplace(var_7, var_378, var_379);
                    }
                    var_380 = wp::where(var_356, var_358, var_46);
                    var_381 = wp::where(var_356, var_365, var_53);
                }
                var_382 = wp::where(var_354, var_380, var_46);
                var_383 = wp::where(var_354, var_381, var_53);
                wp::assign(var_40, var_352);
                wp::assign(var_46, var_382);
                wp::assign(var_53, var_383);
                goto start_for_16;
            end_for_16:;
        }
        var_384 = wp::where(var_343, var_346, var_339);
        var_385 = wp::where(var_343, var_350, var_340);
        // step__leaves_within__3 = next_bucket__leaves_within(step__leaves_within__3, p__neighbors_of__1, p__neighbors_of__1, max_sqdist__points_within__2, neighborhood__tree__root, neighborhood__tree__levels, neighborhood__tree__boxes)       <L 26>
        var_386 = next_bucket_0(var_17, var_9, var_9, var_16, var_neighborhood__tree__root, var_neighborhood__tree__levels, var_neighborhood__tree__boxes);
        wp::assign(var_17, var_386);
    goto start_while_0;
    end_while_0:;
    // return counts                                                                          <L 27>
    return var_7;
}


// <pointloom.kernels.features.fpfh.write_histogram>:1
static CUDA_CALLABLE void write_histogram_0(
    wp::int32 var_rank,
    wp::vec_t<33, wp::int32> var_counts,
    wp::array_t<wp::float32> var_histograms)
{
    //---------
    // primal vars
    const wp::int32 var_0 = -1;
    wp::int32 var_1;
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
    const wp::int32 var_26 = 8;
    wp::int32 var_27;
    wp::int32 var_28;
    const wp::int32 var_29 = 9;
    wp::int32 var_30;
    wp::int32 var_31;
    const wp::int32 var_32 = 10;
    wp::int32 var_33;
    wp::int32 var_34;
    const wp::float32 var_35 = 100.0;
    const wp::int32 var_36 = 1;
    wp::int32 var_37;
    wp::float32 var_38;
    wp::float32 var_39;
    wp::int32 var_40;
    wp::int32 var_41;
    const wp::int32 var_42 = 0;
    wp::int32 var_43;
    const wp::int32 var_44 = 11;
    wp::int32 var_45;
    const wp::int32 var_46 = 5;
    bool var_47;
    const wp::int32 var_48 = 1;
    wp::int32 var_49;
    wp::int32 var_50;
    wp::int32 var_51;
    wp::float32 var_52;
    wp::float32 var_53;
    //---------
    // forward
    // def write_histogram(rank, counts, histograms):                                         <L 1>
    // pairs = int(-1)                                                                        <L 3>
    var_1 = wp::int(var_0);
    // for j in range(BINS):                                                                  <L 4>
    // pairs += counts[j]                                                                     <L 5>
    var_3 = wp::extract(var_counts, var_2);
    var_4 = wp::add(var_1, var_3);
    var_6 = wp::extract(var_counts, var_5);
    var_7 = wp::add(var_4, var_6);
    var_9 = wp::extract(var_counts, var_8);
    var_10 = wp::add(var_7, var_9);
    var_12 = wp::extract(var_counts, var_11);
    var_13 = wp::add(var_10, var_12);
    var_15 = wp::extract(var_counts, var_14);
    var_16 = wp::add(var_13, var_15);
    var_18 = wp::extract(var_counts, var_17);
    var_19 = wp::add(var_16, var_18);
    var_21 = wp::extract(var_counts, var_20);
    var_22 = wp::add(var_19, var_21);
    var_24 = wp::extract(var_counts, var_23);
    var_25 = wp::add(var_22, var_24);
    var_27 = wp::extract(var_counts, var_26);
    var_28 = wp::add(var_25, var_27);
    var_30 = wp::extract(var_counts, var_29);
    var_31 = wp::add(var_28, var_30);
    var_33 = wp::extract(var_counts, var_32);
    var_34 = wp::add(var_31, var_33);
    // share = 100.0 / float(max(pairs, 1))                                                   <L 6>
    var_37 = wp::max(var_34, var_36);
    var_38 = wp::float(var_37);
    var_39 = wp::div(var_35, var_38);
    // for j in range(COLUMNS):                                                               <L 7>
    var_40 = 0;
    start_for_0:;
        if (var_40 >= 33) goto end_for_0;
        var_41 = var_40;
        var_40 += 1;
        // own = int(0)                                                                       <L 8>
        var_43 = wp::int(var_42);
        // if j % BINS == MIDDLE:                                                             <L 9>
        var_45 = wp::mod(var_41, var_44);
        var_47 = (var_45 == var_46);
        if (var_47) {
            // own = 1                                                                        <L 10>
        }
        var_49 = wp::where(var_47, var_48, var_43);
        // histograms[rank, j] = float(counts[j] - own) * share                               <L 11>
        var_50 = wp::extract(var_counts, var_41);
        var_51 = wp::sub(var_50, var_49);
        var_52 = wp::float(var_51);
        var_53 = wp::mul(var_52, var_39);
        wp::array_store(var_histograms, var_rank, var_41, var_53);
        goto start_for_0;
    end_for_0:;
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:162
static CUDA_CALLABLE wp::int32 _shuffle_0(
    wp::int32 x,
    wp::int32 lane)
{
return __shfl_sync(0xffffffffu, x, lane);}


// <pointloom.kernels.features.fpfh.weight_of>:1
static CUDA_CALLABLE wp::float32 weight_of_0(
    wp::float32 var_sqdist)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 0.0;
    wp::float32 var_1;
    const wp::float32 var_2 = 0.0;
    bool var_3;
    const wp::float32 var_4 = 1.0;
    wp::float32 var_5;
    const wp::float32 var_6 = 1e+30;
    wp::float32 var_7;
    wp::float32 var_8;
    //---------
    // forward
    // def weight_of(sqdist):                                                                 <L 1>
    // weight = float(0.0)                                                                    <L 3>
    var_1 = wp::float(var_0);
    // if sqdist > 0.0:                                                                       <L 4>
    var_3 = (var_sqdist > var_2);
    if (var_3) {
        // weight = min(1.0 / sqdist, HEAVIEST)                                               <L 5>
        var_5 = wp::div(var_4, var_sqdist);
        var_7 = wp::min(var_5, var_6);
    }
    var_8 = wp::where(var_3, var_7, var_1);
    // return weight                                                                          <L 6>
    return var_8;
}


// /work/main/src/pointloom/kernels/arrays/lanes.py:25
static CUDA_CALLABLE wp::float32 sum_of_lanes_on_cuda_0(
    wp::float32 var_x)
{
    //---------
    // primal vars
    wp::float32 var_0;
    const wp::int32 var_1 = 0;
    const wp::int32 var_2 = 1;
    wp::int32 var_3;
    wp::float32 var_4;
    wp::float32 var_5;
    const wp::int32 var_6 = 1;
    const wp::int32 var_7 = 1;
    wp::int32 var_8;
    wp::float32 var_9;
    wp::float32 var_10;
    const wp::int32 var_11 = 2;
    const wp::int32 var_12 = 1;
    wp::int32 var_13;
    wp::float32 var_14;
    wp::float32 var_15;
    const wp::int32 var_16 = 3;
    const wp::int32 var_17 = 1;
    wp::int32 var_18;
    wp::float32 var_19;
    wp::float32 var_20;
    const wp::int32 var_21 = 4;
    const wp::int32 var_22 = 1;
    wp::int32 var_23;
    wp::float32 var_24;
    wp::float32 var_25;
    //---------
    // forward
    // def sum_of_lanes(x: float) -> float:                                                   <L 26>
    // total = x                                                                              <L 27>
    var_0 = wp::copy(var_x);
    // for bit in range(LANE_BITS):                                                           <L 28>
    // total += shuffle_xor(total, 1 << bit)                                                  <L 29>
    var_3 = wp::lshift(var_2, var_1);
    var_4 = _shuffle_xor_1(var_0, var_3);
    var_5 = wp::add(var_0, var_4);
    var_8 = wp::lshift(var_7, var_6);
    var_9 = _shuffle_xor_1(var_5, var_8);
    var_10 = wp::add(var_5, var_9);
    var_13 = wp::lshift(var_12, var_11);
    var_14 = _shuffle_xor_1(var_10, var_13);
    var_15 = wp::add(var_10, var_14);
    var_18 = wp::lshift(var_17, var_16);
    var_19 = _shuffle_xor_1(var_15, var_18);
    var_20 = wp::add(var_15, var_19);
    var_23 = wp::lshift(var_22, var_21);
    var_24 = _shuffle_xor_1(var_20, var_23);
    var_25 = wp::add(var_20, var_24);
    // return total                                                                           <L 30>
    return var_25;
}


// <pointloom.kernels.features.fpfh.scale_of>:1
static CUDA_CALLABLE wp::float32 scale_of_0(
    wp::float32 var_total)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 0.0;
    wp::float32 var_1;
    const wp::float32 var_2 = 0.0;
    bool var_3;
    const wp::float32 var_4 = 100.0;
    wp::float32 var_5;
    wp::float32 var_6;
    //---------
    // forward
    // def scale_of(total):                                                                   <L 1>
    // scale = float(0.0)                                                                     <L 3>
    var_1 = wp::float(var_0);
    // if total > 0.0:                                                                        <L 4>
    var_3 = (var_total > var_2);
    if (var_3) {
        // scale = 100.0 / total                                                              <L 5>
        var_5 = wp::div(var_4, var_total);
    }
    var_6 = wp::where(var_3, var_5, var_1);
    // return scale                                                                           <L 6>
    return var_6;
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:154
static CUDA_CALLABLE void adj__lane_0(
    wp::int32 & adj_ret)
{
}


// <pointloom.kernels.arrays.packed_keys.key_bits>:1
static CUDA_CALLABLE void adj_key_bits_0(
    wp::int64 var_key,
    wp::int64 & adj_key,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:148
static CUDA_CALLABLE void adj__bits_float_0(
    wp::int32 var_i,
    wp::int32 & adj_i,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/arrays/packed_keys.py:28
static CUDA_CALLABLE void adj_key_number_0(
    wp::int64 var_key,
    wp::int64 & adj_key,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:166
static CUDA_CALLABLE void adj__shuffle_1(
    wp::float32 x,
    wp::int32 lane,
    wp::float32 & adj_x,
    wp::int32 & adj_lane,
    wp::float32 & adj_ret)
{
}


// /work/main/src/pointloom/kernels/search/lane_search.py:50
static CUDA_CALLABLE void adj_point_of_lane_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::int32 var_owner,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::int32 & adj_owner,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/search/point_tree.py:379
static CUDA_CALLABLE void adj_square_distance_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> var_q,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float32> & adj_q,
    wp::float32 & adj_ret)
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


// /work/main/src/pointloom/kernels/arrays/lanes.py:52
static CUDA_CALLABLE void adj_max_of_eight_on_cuda_0(
    wp::float32 var_x,
    wp::float32 & adj_x,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:158
static CUDA_CALLABLE void adj__ballot_0(
    wp::int32 flag,
    wp::int32 & adj_flag,
    wp::int32 & adj_ret)
{
}


// /work/main/src/pointloom/kernels/search/tree_walk.py:20
static CUDA_CALLABLE void adj_lowest_bit_0(
    wp::int32 var_bits,
    wp::int32 & adj_bits,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/arrays/lanes.py:44
static CUDA_CALLABLE void adj_min_of_eight_on_cuda_0(
    wp::float32 var_x,
    wp::float32 & adj_x,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/arrays/lanes.py:60
static CUDA_CALLABLE void adj_low_of_eight_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/arrays/lanes.py:66
static CUDA_CALLABLE void adj_high_of_eight_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/search/lane_search.py:55
static CUDA_CALLABLE void adj_boxes_of_eight_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::int32 var_is_used,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::int32 & adj_is_used,
    wp::vec_t<12, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:186
static CUDA_CALLABLE void adj__sync_lanes_0(
    )
{
}


// <pointloom.kernels.search.bucket_walk.start_traversal>:1
static CUDA_CALLABLE void adj_start_traversal_0(
    wp::int32 var_bucket,
    wp::int32 & adj_bucket,
    wp::vec_t<4, wp::int64> & adj_ret)
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


// /work/main/src/pointloom/kernels/search/point_tree.py:401
static CUDA_CALLABLE void adj_measure_box_0(
    wp::array_t<wp::float32> var_boxes,
    wp::int32 var_node,
    wp::int32 var_child,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::array_t<wp::float32> & adj_boxes,
    wp::int32 & adj_node,
    wp::int32 & adj_child,
    wp::vec_t<3, wp::float32> & adj_a,
    wp::vec_t<3, wp::float32> & adj_b,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/search/lane_search.py:84
static CUDA_CALLABLE void adj_nearby_children_on_cuda_0(
    wp::array_t<wp::float32> var_boxes,
    wp::int32 var_node,
    wp::vec_t<12, wp::float32> var_around,
    wp::float32 var_bound,
    wp::array_t<wp::float32> & adj_boxes,
    wp::int32 & adj_node,
    wp::vec_t<12, wp::float32> & adj_around,
    wp::float32 & adj_bound,
    wp::int32 & adj_ret)
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


// /work/main/src/pointloom/kernels/search/lane_search.py:95
static CUDA_CALLABLE void adj_nearby_nodes_on_cuda_0(
    wp::array_t<wp::int32> var_levels,
    wp::int32 var_first,
    wp::array_t<wp::float32> var_boxes,
    wp::vec_t<12, wp::float32> var_around,
    wp::float32 var_bound,
    wp::int32 var_level,
    wp::int32 var_node,
    wp::array_t<wp::int32> & adj_levels,
    wp::int32 & adj_first,
    wp::array_t<wp::float32> & adj_boxes,
    wp::vec_t<12, wp::float32> & adj_around,
    wp::float32 & adj_bound,
    wp::int32 & adj_level,
    wp::int32 & adj_node,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.bucket_walk.next_step__nearby_nodes>:1
static CUDA_CALLABLE void adj_next_step__nearby_nodes_on_cuda_0(
    wp::vec_t<4, wp::int64> var_step,
    wp::int32 var_root,
    wp::array_t<wp::int32> var_children__levels,
    wp::int32 var_children__first,
    wp::array_t<wp::float32> var_children__boxes,
    wp::vec_t<12, wp::float32> var_children__around,
    wp::float32 var_children__bound,
    wp::vec_t<4, wp::int64> & adj_step,
    wp::int32 & adj_root,
    wp::array_t<wp::int32> & adj_children__levels,
    wp::int32 & adj_children__first,
    wp::array_t<wp::float32> & adj_children__boxes,
    wp::vec_t<12, wp::float32> & adj_children__around,
    wp::float32 & adj_children__bound,
    wp::vec_t<4, wp::int64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.lane_search.next_bucket_of_lanes>:1
static CUDA_CALLABLE void adj_next_bucket_of_lanes_on_cuda_0(
    wp::vec_t<4, wp::int64> var_step,
    wp::vec_t<12, wp::float32> var_around,
    wp::float32 var_bound,
    wp::int32 var_tree__root,
    wp::array_t<wp::int32> var_tree__levels,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::vec_t<4, wp::int64> & adj_step,
    wp::vec_t<12, wp::float32> & adj_around,
    wp::float32 & adj_bound,
    wp::int32 & adj_tree__root,
    wp::array_t<wp::int32> & adj_tree__levels,
    wp::array_t<wp::float32> & adj_tree__boxes,
    wp::vec_t<4, wp::int64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.lane_search.list_leaves>:1
static CUDA_CALLABLE void adj_list_leaves_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::float32 var_max_sqdist,
    wp::int32 var_start,
    wp::int32 var_tree__root,
    wp::array_t<wp::int32> var_tree__levels,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::array_t<wp::int32> var_scratch__ids,
    wp::int32 var_scratch__gather,
    wp::int32 var_listing,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::float32 & adj_max_sqdist,
    wp::int32 & adj_start,
    wp::int32 & adj_tree__root,
    wp::array_t<wp::int32> & adj_tree__levels,
    wp::array_t<wp::float32> & adj_tree__boxes,
    wp::array_t<wp::int32> & adj_scratch__ids,
    wp::int32 & adj_scratch__gather,
    wp::int32 & adj_listing,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:193
static CUDA_CALLABLE void adj__load_eight_0(
    wp::array_t<wp::vec_t<3, wp::float32>> points,
    wp::int32 first,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_points,
    wp::int32 & adj_first,
    wp::vec_t<24, wp::float32> & adj_ret)
{
}


// /work/main/src/pointloom/kernels/search/lane_search.py:135
static CUDA_CALLABLE void adj_sqdist_of_on_cuda_0(
    wp::vec_t<24, wp::float32> var_leaf,
    wp::int32 var_j,
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<24, wp::float32> & adj_leaf,
    wp::int32 & adj_j,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:143
static CUDA_CALLABLE void adj__float_bits_0(
    wp::float32 var_x,
    wp::float32 & adj_x,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.arrays.packed_keys.pack_bits>:1
static CUDA_CALLABLE void adj_pack_bits_0(
    wp::int32 var_bits,
    wp::int32 var_index,
    wp::int32 & adj_bits,
    wp::int32 & adj_index,
    wp::int64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/arrays/packed_keys.py:18
static CUDA_CALLABLE void adj_pack_key_0(
    wp::float32 var_number,
    wp::int32 var_index,
    wp::float32 & adj_number,
    wp::int32 & adj_index,
    wp::int64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.lane_search.keep_near>:1
static CUDA_CALLABLE void adj_keep_near_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::float32 var_max_sqdist,
    wp::array_t<wp::vec_t<3, wp::float32>> var_tree__points,
    wp::array_t<wp::int32> var_scratch__ids,
    wp::array_t<wp::int64> var_scratch__keys,
    wp::int32 var_scratch__room,
    wp::int32 var_scratch__stride,
    wp::int32 var_listing,
    wp::int32 var_size,
    wp::int32 var_base,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::float32 & adj_max_sqdist,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_tree__points,
    wp::array_t<wp::int32> & adj_scratch__ids,
    wp::array_t<wp::int64> & adj_scratch__keys,
    wp::int32 & adj_scratch__room,
    wp::int32 & adj_scratch__stride,
    wp::int32 & adj_listing,
    wp::int32 & adj_size,
    wp::int32 & adj_base,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.neighbor_keys.keep_up_to>:1
static CUDA_CALLABLE void adj_keep_up_to_0(
    wp::array_t<wp::int64> var_keys,
    wp::int32 var_base,
    wp::int32 var_stride,
    wp::int32 var_key_count,
    wp::int64 var_limit,
    wp::array_t<wp::int64> & adj_keys,
    wp::int32 & adj_base,
    wp::int32 & adj_stride,
    wp::int32 & adj_key_count,
    wp::int64 & adj_limit,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.lane_search.keep_up_to_limit>:1
static CUDA_CALLABLE void adj_keep_up_to_limit_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::int64 var_limit,
    wp::array_t<wp::vec_t<3, wp::float32>> var_tree__points,
    wp::array_t<wp::int32> var_scratch__ids,
    wp::array_t<wp::int64> var_scratch__keys,
    wp::int32 var_scratch__room,
    wp::int32 var_scratch__stride,
    wp::int32 var_listing,
    wp::int32 var_size,
    wp::int32 var_base,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::int64 & adj_limit,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_tree__points,
    wp::array_t<wp::int32> & adj_scratch__ids,
    wp::array_t<wp::int64> & adj_scratch__keys,
    wp::int32 & adj_scratch__room,
    wp::int32 & adj_scratch__stride,
    wp::int32 & adj_listing,
    wp::int32 & adj_size,
    wp::int32 & adj_base,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.neighbor_limits.store_members>:1
static CUDA_CALLABLE void adj_store_members_on_cuda_0(
    wp::int32 var_thread,
    wp::int32 var_group,
    wp::array_t<wp::int32> var_ranks,
    wp::int32 var_neighborhood__tree__root,
    wp::array_t<wp::int32> var_neighborhood__tree__levels,
    wp::array_t<wp::float32> var_neighborhood__tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> var_neighborhood__tree__points,
    wp::array_t<wp::int64> var_neighborhood__limits,
    wp::array_t<wp::int32> var_scratch__ids,
    wp::array_t<wp::int64> var_scratch__keys,
    wp::int32 var_scratch__room,
    wp::int32 var_scratch__gather,
    wp::int32 var_scratch__stride,
    wp::int32 & adj_thread,
    wp::int32 & adj_group,
    wp::array_t<wp::int32> & adj_ranks,
    wp::int32 & adj_neighborhood__tree__root,
    wp::array_t<wp::int32> & adj_neighborhood__tree__levels,
    wp::array_t<wp::float32> & adj_neighborhood__tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_neighborhood__tree__points,
    wp::array_t<wp::int64> & adj_neighborhood__limits,
    wp::array_t<wp::int32> & adj_scratch__ids,
    wp::array_t<wp::int64> & adj_scratch__keys,
    wp::int32 & adj_scratch__room,
    wp::int32 & adj_scratch__gather,
    wp::int32 & adj_scratch__stride,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.group_scratch.stored_key_of_lane>:1
static CUDA_CALLABLE void adj_stored_key_of_lane_on_cuda_0(
    wp::array_t<wp::int64> var_scratch__keys,
    wp::int32 var_scratch__stride,
    wp::int32 var_base,
    wp::int32 var_j,
    wp::array_t<wp::int64> & adj_scratch__keys,
    wp::int32 & adj_scratch__stride,
    wp::int32 & adj_base,
    wp::int32 & adj_j,
    wp::int64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/arrays/packed_keys.py:33
static CUDA_CALLABLE void adj_key_index_0(
    wp::int64 var_key,
    wp::int64 & adj_key,
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


// /work/main/src/pointloom/kernels/features/pair_angles.py:46
static CUDA_CALLABLE void adj_quick_bins_0(
    wp::vec_t<3, wp::float32> var_d,
    wp::vec_t<3, wp::float32> var_n1,
    wp::vec_t<3, wp::float32> var_n2,
    wp::vec_t<3, wp::float32> & adj_d,
    wp::vec_t<3, wp::float32> & adj_n1,
    wp::vec_t<3, wp::float32> & adj_n2,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.features.pair_angles.bin_of>:1
static CUDA_CALLABLE void adj_bin_of_0(
    wp::float64 var_level,
    wp::float64 & adj_level,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.features.pair_angles.exact_bins>:1
static CUDA_CALLABLE void adj_exact_bins_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> var_n,
    wp::vec_t<3, wp::float32> var_q,
    wp::vec_t<3, wp::float32> var_m,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float32> & adj_n,
    wp::vec_t<3, wp::float32> & adj_q,
    wp::vec_t<3, wp::float32> & adj_m,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/features/pair_angles.py:141
static CUDA_CALLABLE void adj_resolved_bins_0(
    wp::int32 var_bins,
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> var_n,
    wp::vec_t<3, wp::float32> var_q,
    wp::vec_t<3, wp::float32> var_m,
    wp::int32 & adj_bins,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float32> & adj_n,
    wp::vec_t<3, wp::float32> & adj_q,
    wp::vec_t<3, wp::float32> & adj_m,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.features.fpfh.bin_listed>:1
static CUDA_CALLABLE void adj_bin_listed_on_cuda_0(
    wp::int32 var_rank,
    wp::array_t<wp::vec_t<3, wp::float32>> var_neighborhood__tree__points,
    wp::array_t<wp::int64> var_neighborhood__limits,
    wp::array_t<wp::vec_t<3, wp::float32>> var_normals,
    wp::array_t<wp::int64> var_scratch__keys,
    wp::int32 var_scratch__stride,
    wp::int32 var_base,
    wp::int32 var_stored,
    wp::int32 & adj_rank,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_neighborhood__tree__points,
    wp::array_t<wp::int64> & adj_neighborhood__limits,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_normals,
    wp::array_t<wp::int64> & adj_scratch__keys,
    wp::int32 & adj_scratch__stride,
    wp::int32 & adj_base,
    wp::int32 & adj_stored,
    wp::vec_t<33, wp::int32> & adj_ret)
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


// <pointloom.kernels.search.bucket_walk.children_within>:1
static CUDA_CALLABLE void adj_children_within_0(
    wp::array_t<wp::float32> var_boxes,
    wp::int32 var_node,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::float32 var_bound,
    wp::array_t<wp::float32> & adj_boxes,
    wp::int32 & adj_node,
    wp::vec_t<3, wp::float32> & adj_a,
    wp::vec_t<3, wp::float32> & adj_b,
    wp::float32 & adj_bound,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/search/bucket_walk.py:86
static CUDA_CALLABLE void adj_level_children_within_0(
    wp::array_t<wp::int32> var_levels,
    wp::int32 var_first,
    wp::array_t<wp::float32> var_boxes,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::float32 var_bound,
    wp::int32 var_level,
    wp::int32 var_node,
    wp::array_t<wp::int32> & adj_levels,
    wp::int32 & adj_first,
    wp::array_t<wp::float32> & adj_boxes,
    wp::vec_t<3, wp::float32> & adj_a,
    wp::vec_t<3, wp::float32> & adj_b,
    wp::float32 & adj_bound,
    wp::int32 & adj_level,
    wp::int32 & adj_node,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.bucket_walk.next_step__level_children_within>:1
static CUDA_CALLABLE void adj_next_step__level_children_within_0(
    wp::vec_t<4, wp::int64> var_step,
    wp::int32 var_root,
    wp::array_t<wp::int32> var_children__levels,
    wp::int32 var_children__first,
    wp::array_t<wp::float32> var_children__boxes,
    wp::vec_t<3, wp::float32> var_children__a,
    wp::vec_t<3, wp::float32> var_children__b,
    wp::float32 var_children__bound,
    wp::vec_t<4, wp::int64> & adj_step,
    wp::int32 & adj_root,
    wp::array_t<wp::int32> & adj_children__levels,
    wp::int32 & adj_children__first,
    wp::array_t<wp::float32> & adj_children__boxes,
    wp::vec_t<3, wp::float32> & adj_children__a,
    wp::vec_t<3, wp::float32> & adj_children__b,
    wp::float32 & adj_children__bound,
    wp::vec_t<4, wp::int64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.bucket_walk.next_bucket>:1
static CUDA_CALLABLE void adj_next_bucket_0(
    wp::vec_t<4, wp::int64> var_step,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::float32 var_bound,
    wp::int32 var_tree__root,
    wp::array_t<wp::int32> var_tree__levels,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::vec_t<4, wp::int64> & adj_step,
    wp::vec_t<3, wp::float32> & adj_a,
    wp::vec_t<3, wp::float32> & adj_b,
    wp::float32 & adj_bound,
    wp::int32 & adj_tree__root,
    wp::array_t<wp::int32> & adj_tree__levels,
    wp::array_t<wp::float32> & adj_tree__boxes,
    wp::vec_t<4, wp::int64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.features.fpfh.bin_by_traversal>:1
static CUDA_CALLABLE void adj_bin_by_traversal_0(
    wp::int32 var_rank,
    wp::int32 var_neighborhood__tree__count,
    wp::int32 var_neighborhood__tree__root,
    wp::array_t<wp::int32> var_neighborhood__tree__levels,
    wp::array_t<wp::float32> var_neighborhood__tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> var_neighborhood__tree__points,
    wp::array_t<wp::int64> var_neighborhood__limits,
    wp::array_t<wp::vec_t<3, wp::float32>> var_normals,
    wp::int32 & adj_rank,
    wp::int32 & adj_neighborhood__tree__count,
    wp::int32 & adj_neighborhood__tree__root,
    wp::array_t<wp::int32> & adj_neighborhood__tree__levels,
    wp::array_t<wp::float32> & adj_neighborhood__tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_neighborhood__tree__points,
    wp::array_t<wp::int64> & adj_neighborhood__limits,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_normals,
    wp::vec_t<33, wp::int32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.features.fpfh.write_histogram>:1
static CUDA_CALLABLE void adj_write_histogram_0(
    wp::int32 var_rank,
    wp::vec_t<33, wp::int32> var_counts,
    wp::array_t<wp::float32> var_histograms,
    wp::int32 & adj_rank,
    wp::vec_t<33, wp::int32> & adj_counts,
    wp::array_t<wp::float32> & adj_histograms)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:162
static CUDA_CALLABLE void adj__shuffle_0(
    wp::int32 x,
    wp::int32 lane,
    wp::int32 & adj_x,
    wp::int32 & adj_lane,
    wp::int32 & adj_ret)
{
}


// <pointloom.kernels.features.fpfh.weight_of>:1
static CUDA_CALLABLE void adj_weight_of_0(
    wp::float32 var_sqdist,
    wp::float32 & adj_sqdist,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/arrays/lanes.py:25
static CUDA_CALLABLE void adj_sum_of_lanes_on_cuda_0(
    wp::float32 var_x,
    wp::float32 & adj_x,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.features.fpfh.scale_of>:1
static CUDA_CALLABLE void adj_scale_of_0(
    wp::float32 var_total,
    wp::float32 & adj_total,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void WP_MAXNREG(80) count_angles_kernel_0b4a6ff0_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::int32 var_part__first,
    wp::int32 var_part__last,
    wp::int32 var_part__run,
    wp::array_t<wp::int32> var_ranks,
    wp::int32 var_neighborhood__tree__count,
    wp::int32 var_neighborhood__tree__root,
    wp::array_t<wp::int32> var_neighborhood__tree__levels,
    wp::array_t<wp::float32> var_neighborhood__tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> var_neighborhood__tree__points,
    wp::array_t<wp::int64> var_neighborhood__limits,
    wp::array_t<wp::int32> var_scratch__ids,
    wp::array_t<wp::int64> var_scratch__keys,
    wp::int32 var_scratch__room,
    wp::int32 var_scratch__gather,
    wp::int32 var_scratch__stride,
    wp::array_t<wp::vec_t<3, wp::float32>> var_normals,
    wp::array_t<wp::float32> var_histograms)
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
        wp::int32 var_4;
        wp::int32 var_5;
        wp::int32 var_6;
        wp::range_t var_7;
        wp::int32 var_8;
        wp::int32 var_9;
        wp::int32 var_10;
        wp::int32 var_11;
        wp::int32 var_12;
        wp::shape_t* var_13;
        const wp::int32 var_14 = 0;
        wp::int32 var_15;
        wp::shape_t var_16;
        bool var_17;
        wp::int32 var_18;
        wp::int32* var_19;
        wp::int32 var_20;
        wp::int32 var_21;
        const wp::int32 var_22 = 0;
        wp::vec_t<33, wp::int32> var_23;
        const wp::int32 var_24 = 0;
        bool var_25;
        wp::vec_t<33, wp::int32> var_26;
        wp::vec_t<33, wp::int32> var_27;
        wp::vec_t<33, wp::int32> var_28;
        //---------
        // forward
        // def count_angles_kernel(part__first, part__last, part__run, ranks, neighborhood__tree__count, neighborhood__tree__root, neighborhood__tree__levels, neighborhood__tree__boxes, neighborhood__tree__points, neighborhood__limits, scratch__ids, scratch__keys, scratch__room, scratch__gather, scratch__stride, normals, histograms):       <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // first__members_of_lanes__1 = part__first + i // WARP__members_of_lanes * part__run       <L 3>
        var_2 = wp::floordiv(var_0, var_1);
        var_3 = wp::mul(var_2, var_part__run);
        var_4 = wp::add(var_part__first, var_3);
        // for group__members_of_lanes__1 in range(first__members_of_lanes__1, min(first__members_of_lanes__1 + part__run, part__last)):       <L 4>
        var_5 = wp::add(var_4, var_part__run);
        var_6 = wp::min(var_5, var_part__last);
        var_7 = wp::range(var_4, var_6);
        start_for_0:;
            if (iter_cmp(var_7) == 0) goto end_for_0;
            var_8 = wp::iter_next(var_7);
            // stored = store_members(i, group__members_of_lanes__1, ranks, neighborhood__tree__root, neighborhood__tree__levels, neighborhood__tree__boxes, neighborhood__tree__points, neighborhood__limits, scratch__ids, scratch__keys, scratch__room, scratch__gather, scratch__stride)       <L 5>
            var_9 = store_members_on_cuda_0(var_0, var_8, var_ranks, var_neighborhood__tree__root, var_neighborhood__tree__levels, var_neighborhood__tree__boxes, var_neighborhood__tree__points, var_neighborhood__limits, var_scratch__ids, var_scratch__keys, var_scratch__room, var_scratch__gather, var_scratch__stride);
            // member = group__members_of_lanes__1 * WARP__members_of_lanes + lane()              <L 6>
            var_10 = wp::mul(var_8, var_1);
            var_11 = _lane_0();
            var_12 = wp::add(var_10, var_11);
            // if member < ranks.shape[0]:                                                        <L 7>
            var_13 = &(var_ranks.shape);
            var_16 = wp::load(var_13);
            var_15 = wp::extract(var_16, var_14);
            var_17 = (var_12 < var_15);
            if (var_17) {
                // base = i                                                                       <L 8>
                var_18 = wp::copy(var_0);
                // rank = ranks[member]                                                           <L 9>
                var_19 = wp::address(var_ranks, var_12);
                var_21 = wp::load(var_19);
                var_20 = wp::copy(var_21);
                // counts = histogram(0)                                                          <L 10>
                var_23 = wp::vec_t<33, wp::int32>(var_22);
                // if stored >= 0:                                                                <L 11>
                var_25 = (var_9 >= var_24);
                if (var_25) {
                    // counts = bin_listed(rank, neighborhood__tree__points, neighborhood__limits, normals, scratch__keys, scratch__stride, base, stored)       <L 12>
                    var_26 = bin_listed_on_cuda_0(var_20, var_neighborhood__tree__points, var_neighborhood__limits, var_normals, var_scratch__keys, var_scratch__stride, var_18, var_9);
                }
                if (!var_25) {
                    // counts = bin_by_traversal(rank, neighborhood__tree__count, neighborhood__tree__root, neighborhood__tree__levels, neighborhood__tree__boxes, neighborhood__tree__points, neighborhood__limits, normals)       <L 14>
                    var_27 = bin_by_traversal_0(var_20, var_neighborhood__tree__count, var_neighborhood__tree__root, var_neighborhood__tree__levels, var_neighborhood__tree__boxes, var_neighborhood__tree__points, var_neighborhood__limits, var_normals);
                }
                var_28 = wp::where(var_25, var_26, var_27);
                // write_histogram(rank, counts, histograms)                                      <L 15>
                write_histogram_0(var_20, var_28, var_histograms);
            }
            goto start_for_0;
        end_for_0:;
}



extern "C" __global__ void WP_MAXNREG(80) sum_histograms_of_lanes_kernel_5ed01ff3_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::int32 var_part__first,
    wp::int32 var_part__last,
    wp::int32 var_part__run,
    wp::array_t<wp::int32> var_ranks,
    wp::int32 var_neighborhood__tree__count,
    wp::int32 var_neighborhood__tree__root,
    wp::array_t<wp::int32> var_neighborhood__tree__levels,
    wp::array_t<wp::float32> var_neighborhood__tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> var_neighborhood__tree__points,
    wp::array_t<wp::int64> var_neighborhood__limits,
    wp::array_t<wp::int32> var_scratch__ids,
    wp::array_t<wp::int64> var_scratch__keys,
    wp::int32 var_scratch__room,
    wp::int32 var_scratch__gather,
    wp::int32 var_scratch__stride,
    wp::array_t<wp::float32> var_histograms,
    wp::array_t<wp::int32> var_rows,
    wp::array_t<wp::float32> var_features)
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
        wp::int32 var_4;
        wp::int32 var_5;
        wp::int32 var_6;
        wp::range_t var_7;
        wp::int32 var_8;
        wp::int32 var_9;
        wp::shape_t* var_10;
        const wp::int32 var_11 = 0;
        wp::int32 var_12;
        wp::shape_t var_13;
        wp::int32 var_14;
        wp::int32 var_15;
        wp::int32 var_16;
        wp::range_t var_17;
        wp::int32 var_18;
        wp::int32 var_19;
        wp::int32 var_20;
        wp::int32* var_21;
        wp::int32 var_22;
        wp::int32 var_23;
        wp::int32* var_24;
        wp::int32 var_25;
        wp::int32 var_26;
        const wp::float32 var_27 = 0.0;
        wp::float32 var_28;
        const wp::float32 var_29 = 0.0;
        wp::float32 var_30;
        wp::int32 var_31;
        wp::int32 var_32;
        wp::int32 var_33;
        const wp::int32 var_34 = 1;
        wp::int32 var_35;
        wp::int32 var_36;
        wp::range_t var_37;
        wp::int32 var_38;
        wp::int32 var_39;
        wp::int32 var_40;
        wp::int32 var_41;
        wp::int32 var_42;
        wp::int32 var_43;
        wp::int32 var_44;
        const wp::int32 var_45 = 1;
        wp::int32 var_46;
        wp::int32 var_47;
        wp::int32 var_48;
        wp::int32 var_49;
        wp::int32 var_50;
        wp::int64* var_51;
        wp::int64 var_52;
        wp::int64 var_53;
        wp::float32 var_54;
        wp::float32 var_55;
        bool var_56;
        wp::int32 var_57;
        const wp::int32 var_58 = 2;
        const wp::int32 var_59 = 16;
        wp::int32 var_60;
        wp::float32* var_61;
        wp::float32 var_62;
        wp::float32 var_63;
        wp::float32 var_64;
        wp::float32 var_65;
        wp::range_t var_66;
        wp::int32 var_67;
        wp::float32 var_68;
        wp::int32 var_69;
        wp::int32 var_70;
        wp::float32* var_71;
        wp::float32 var_72;
        wp::float32 var_73;
        wp::float32 var_74;
        const wp::int32 var_75 = 0;
        bool var_76;
        wp::vec_t<3, wp::float32>* var_77;
        wp::vec_t<3, wp::float32> var_78;
        wp::vec_t<3, wp::float32> var_79;
        wp::int64* var_80;
        wp::int64 var_81;
        wp::int64 var_82;
        const wp::int32 var_83 = 64;
        wp::int32 var_84;
        wp::float32 var_85;
        wp::vec_t<4, wp::int64> var_86;
        const wp::int32 var_87 = 0;
        wp::int64 var_88;
        wp::int32 var_89;
        bool var_90;
        const wp::int32 var_91 = 2;
        wp::int64 var_92;
        wp::int32 var_93;
        wp::vec_t<8, wp::float32> var_94;
        const wp::int32 var_95 = 0;
        wp::float32 var_96;
        bool var_97;
        const wp::int32 var_98 = 64;
        wp::int32 var_99;
        const wp::int32 var_100 = 8;
        wp::int32 var_101;
        wp::int32 var_102;
        const wp::int32 var_103 = 8;
        wp::int32 var_104;
        wp::int32 var_105;
        wp::range_t var_106;
        wp::int32 var_107;
        wp::vec_t<3, wp::float32>* var_108;
        wp::float32 var_109;
        wp::vec_t<3, wp::float32> var_110;
        bool var_111;
        wp::int64 var_112;
        bool var_113;
        wp::float32 var_114;
        wp::float32* var_115;
        wp::float32 var_116;
        wp::float32 var_117;
        wp::float32 var_118;
        const wp::int32 var_119 = 0;
        bool var_120;
        const wp::int32 var_121 = 2;
        wp::int32 var_122;
        wp::float32* var_123;
        wp::float32 var_124;
        wp::float32 var_125;
        wp::float32 var_126;
        wp::float32 var_127;
        wp::float32 var_128;
        wp::float32 var_129;
        wp::float32 var_130;
        wp::float32 var_131;
        wp::float32 var_132;
        wp::float32 var_133;
        wp::int32 var_134;
        const wp::int32 var_135 = 1;
        wp::float32 var_136;
        bool var_137;
        wp::int32 var_138;
        wp::int32 var_139;
        wp::int32 var_140;
        wp::int32 var_141;
        wp::int32 var_142;
        wp::range_t var_143;
        wp::int32 var_144;
        wp::vec_t<3, wp::float32>* var_145;
        wp::float32 var_146;
        wp::vec_t<3, wp::float32> var_147;
        bool var_148;
        wp::int64 var_149;
        bool var_150;
        wp::float32 var_151;
        wp::float32* var_152;
        wp::float32 var_153;
        wp::float32 var_154;
        wp::float32 var_155;
        const wp::int32 var_156 = 0;
        bool var_157;
        const wp::int32 var_158 = 2;
        wp::int32 var_159;
        wp::float32* var_160;
        wp::float32 var_161;
        wp::float32 var_162;
        wp::float32 var_163;
        wp::float32 var_164;
        wp::float32 var_165;
        wp::float32 var_166;
        wp::float32 var_167;
        wp::float32 var_168;
        wp::float32 var_169;
        wp::float32 var_170;
        wp::int32 var_171;
        wp::int32 var_172;
        const wp::int32 var_173 = 2;
        wp::float32 var_174;
        bool var_175;
        wp::int32 var_176;
        wp::int32 var_177;
        wp::int32 var_178;
        wp::int32 var_179;
        wp::int32 var_180;
        wp::range_t var_181;
        wp::int32 var_182;
        wp::vec_t<3, wp::float32>* var_183;
        wp::float32 var_184;
        wp::vec_t<3, wp::float32> var_185;
        bool var_186;
        wp::int64 var_187;
        bool var_188;
        wp::float32 var_189;
        wp::float32* var_190;
        wp::float32 var_191;
        wp::float32 var_192;
        wp::float32 var_193;
        const wp::int32 var_194 = 0;
        bool var_195;
        const wp::int32 var_196 = 2;
        wp::int32 var_197;
        wp::float32* var_198;
        wp::float32 var_199;
        wp::float32 var_200;
        wp::float32 var_201;
        wp::float32 var_202;
        wp::float32 var_203;
        wp::float32 var_204;
        wp::float32 var_205;
        wp::float32 var_206;
        wp::float32 var_207;
        wp::float32 var_208;
        wp::int32 var_209;
        wp::int32 var_210;
        const wp::int32 var_211 = 3;
        wp::float32 var_212;
        bool var_213;
        wp::int32 var_214;
        wp::int32 var_215;
        wp::int32 var_216;
        wp::int32 var_217;
        wp::int32 var_218;
        wp::range_t var_219;
        wp::int32 var_220;
        wp::vec_t<3, wp::float32>* var_221;
        wp::float32 var_222;
        wp::vec_t<3, wp::float32> var_223;
        bool var_224;
        wp::int64 var_225;
        bool var_226;
        wp::float32 var_227;
        wp::float32* var_228;
        wp::float32 var_229;
        wp::float32 var_230;
        wp::float32 var_231;
        const wp::int32 var_232 = 0;
        bool var_233;
        const wp::int32 var_234 = 2;
        wp::int32 var_235;
        wp::float32* var_236;
        wp::float32 var_237;
        wp::float32 var_238;
        wp::float32 var_239;
        wp::float32 var_240;
        wp::float32 var_241;
        wp::float32 var_242;
        wp::float32 var_243;
        wp::float32 var_244;
        wp::float32 var_245;
        wp::float32 var_246;
        wp::int32 var_247;
        wp::int32 var_248;
        const wp::int32 var_249 = 4;
        wp::float32 var_250;
        bool var_251;
        wp::int32 var_252;
        wp::int32 var_253;
        wp::int32 var_254;
        wp::int32 var_255;
        wp::int32 var_256;
        wp::range_t var_257;
        wp::int32 var_258;
        wp::vec_t<3, wp::float32>* var_259;
        wp::float32 var_260;
        wp::vec_t<3, wp::float32> var_261;
        bool var_262;
        wp::int64 var_263;
        bool var_264;
        wp::float32 var_265;
        wp::float32* var_266;
        wp::float32 var_267;
        wp::float32 var_268;
        wp::float32 var_269;
        const wp::int32 var_270 = 0;
        bool var_271;
        const wp::int32 var_272 = 2;
        wp::int32 var_273;
        wp::float32* var_274;
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
        wp::int32 var_285;
        wp::int32 var_286;
        const wp::int32 var_287 = 5;
        wp::float32 var_288;
        bool var_289;
        wp::int32 var_290;
        wp::int32 var_291;
        wp::int32 var_292;
        wp::int32 var_293;
        wp::int32 var_294;
        wp::range_t var_295;
        wp::int32 var_296;
        wp::vec_t<3, wp::float32>* var_297;
        wp::float32 var_298;
        wp::vec_t<3, wp::float32> var_299;
        bool var_300;
        wp::int64 var_301;
        bool var_302;
        wp::float32 var_303;
        wp::float32* var_304;
        wp::float32 var_305;
        wp::float32 var_306;
        wp::float32 var_307;
        const wp::int32 var_308 = 0;
        bool var_309;
        const wp::int32 var_310 = 2;
        wp::int32 var_311;
        wp::float32* var_312;
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
        wp::int32 var_323;
        wp::int32 var_324;
        const wp::int32 var_325 = 6;
        wp::float32 var_326;
        bool var_327;
        wp::int32 var_328;
        wp::int32 var_329;
        wp::int32 var_330;
        wp::int32 var_331;
        wp::int32 var_332;
        wp::range_t var_333;
        wp::int32 var_334;
        wp::vec_t<3, wp::float32>* var_335;
        wp::float32 var_336;
        wp::vec_t<3, wp::float32> var_337;
        bool var_338;
        wp::int64 var_339;
        bool var_340;
        wp::float32 var_341;
        wp::float32* var_342;
        wp::float32 var_343;
        wp::float32 var_344;
        wp::float32 var_345;
        const wp::int32 var_346 = 0;
        bool var_347;
        const wp::int32 var_348 = 2;
        wp::int32 var_349;
        wp::float32* var_350;
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
        wp::int32 var_361;
        wp::int32 var_362;
        const wp::int32 var_363 = 7;
        wp::float32 var_364;
        bool var_365;
        wp::int32 var_366;
        wp::int32 var_367;
        wp::int32 var_368;
        wp::int32 var_369;
        wp::int32 var_370;
        wp::range_t var_371;
        wp::int32 var_372;
        wp::vec_t<3, wp::float32>* var_373;
        wp::float32 var_374;
        wp::vec_t<3, wp::float32> var_375;
        bool var_376;
        wp::int64 var_377;
        bool var_378;
        wp::float32 var_379;
        wp::float32* var_380;
        wp::float32 var_381;
        wp::float32 var_382;
        wp::float32 var_383;
        const wp::int32 var_384 = 0;
        bool var_385;
        const wp::int32 var_386 = 2;
        wp::int32 var_387;
        wp::float32* var_388;
        wp::float32 var_389;
        wp::float32 var_390;
        wp::float32 var_391;
        wp::float32 var_392;
        wp::float32 var_393;
        wp::float32 var_394;
        wp::float32 var_395;
        wp::float32 var_396;
        wp::float32 var_397;
        wp::float32 var_398;
        wp::int32 var_399;
        wp::int32 var_400;
        wp::vec_t<4, wp::int64> var_401;
        wp::float32 var_402;
        const wp::float32 var_403 = 0.0;
        const wp::float32 var_404 = 0.0;
        const wp::float32 var_405 = 0.0;
        wp::vec_t<3, wp::float32> var_406;
        const wp::int32 var_407 = 0;
        const wp::int32 var_408 = 2;
        const wp::int32 var_409 = 11;
        wp::int32 var_410;
        wp::int32 var_411;
        const wp::int32 var_412 = 2;
        wp::int32 var_413;
        const wp::int32 var_414 = 1;
        wp::int32 var_415;
        wp::int32 var_416;
        wp::float32 var_417;
        const wp::int32 var_418 = 1;
        wp::int32 var_419;
        bool var_420;
        wp::float32 var_421;
        wp::float32 var_422;
        wp::float32 var_423;
        wp::int32 var_424;
        wp::float32 var_425;
        wp::vec_t<3, wp::float32> var_426;
        wp::vec_t<3, wp::float32> var_427;
        const wp::int32 var_428 = 1;
        const wp::int32 var_429 = 2;
        wp::int32 var_430;
        wp::int32 var_431;
        const wp::int32 var_432 = 2;
        wp::int32 var_433;
        const wp::int32 var_434 = 1;
        wp::int32 var_435;
        wp::int32 var_436;
        wp::float32 var_437;
        const wp::int32 var_438 = 1;
        wp::int32 var_439;
        bool var_440;
        wp::float32 var_441;
        wp::float32 var_442;
        wp::float32 var_443;
        wp::int32 var_444;
        wp::float32 var_445;
        wp::vec_t<3, wp::float32> var_446;
        wp::vec_t<3, wp::float32> var_447;
        const wp::int32 var_448 = 2;
        const wp::int32 var_449 = 2;
        wp::int32 var_450;
        wp::int32 var_451;
        const wp::int32 var_452 = 2;
        wp::int32 var_453;
        const wp::int32 var_454 = 1;
        wp::int32 var_455;
        wp::int32 var_456;
        wp::float32 var_457;
        const wp::int32 var_458 = 1;
        wp::int32 var_459;
        bool var_460;
        wp::float32 var_461;
        wp::float32 var_462;
        wp::float32 var_463;
        wp::int32 var_464;
        wp::float32 var_465;
        wp::vec_t<3, wp::float32> var_466;
        wp::vec_t<3, wp::float32> var_467;
        const wp::int32 var_468 = 3;
        const wp::int32 var_469 = 2;
        wp::int32 var_470;
        wp::int32 var_471;
        const wp::int32 var_472 = 2;
        wp::int32 var_473;
        const wp::int32 var_474 = 1;
        wp::int32 var_475;
        wp::int32 var_476;
        wp::float32 var_477;
        const wp::int32 var_478 = 1;
        wp::int32 var_479;
        bool var_480;
        wp::float32 var_481;
        wp::float32 var_482;
        wp::float32 var_483;
        wp::int32 var_484;
        wp::float32 var_485;
        wp::vec_t<3, wp::float32> var_486;
        wp::vec_t<3, wp::float32> var_487;
        const wp::int32 var_488 = 4;
        const wp::int32 var_489 = 2;
        wp::int32 var_490;
        wp::int32 var_491;
        const wp::int32 var_492 = 2;
        wp::int32 var_493;
        const wp::int32 var_494 = 1;
        wp::int32 var_495;
        wp::int32 var_496;
        wp::float32 var_497;
        const wp::int32 var_498 = 1;
        wp::int32 var_499;
        bool var_500;
        wp::float32 var_501;
        wp::float32 var_502;
        wp::float32 var_503;
        wp::int32 var_504;
        wp::float32 var_505;
        wp::vec_t<3, wp::float32> var_506;
        wp::vec_t<3, wp::float32> var_507;
        const wp::int32 var_508 = 5;
        const wp::int32 var_509 = 2;
        wp::int32 var_510;
        wp::int32 var_511;
        const wp::int32 var_512 = 2;
        wp::int32 var_513;
        const wp::int32 var_514 = 1;
        wp::int32 var_515;
        wp::int32 var_516;
        wp::float32 var_517;
        const wp::int32 var_518 = 1;
        wp::int32 var_519;
        bool var_520;
        wp::float32 var_521;
        wp::float32 var_522;
        wp::float32 var_523;
        wp::int32 var_524;
        wp::float32 var_525;
        wp::vec_t<3, wp::float32> var_526;
        wp::vec_t<3, wp::float32> var_527;
        const wp::int32 var_528 = 6;
        const wp::int32 var_529 = 2;
        wp::int32 var_530;
        wp::int32 var_531;
        const wp::int32 var_532 = 2;
        wp::int32 var_533;
        const wp::int32 var_534 = 1;
        wp::int32 var_535;
        wp::int32 var_536;
        wp::float32 var_537;
        const wp::int32 var_538 = 1;
        wp::int32 var_539;
        bool var_540;
        wp::float32 var_541;
        wp::float32 var_542;
        wp::float32 var_543;
        wp::int32 var_544;
        wp::float32 var_545;
        wp::vec_t<3, wp::float32> var_546;
        wp::vec_t<3, wp::float32> var_547;
        const wp::int32 var_548 = 7;
        const wp::int32 var_549 = 2;
        wp::int32 var_550;
        wp::int32 var_551;
        const wp::int32 var_552 = 2;
        wp::int32 var_553;
        const wp::int32 var_554 = 1;
        wp::int32 var_555;
        wp::int32 var_556;
        wp::float32 var_557;
        const wp::int32 var_558 = 1;
        wp::int32 var_559;
        bool var_560;
        wp::float32 var_561;
        wp::float32 var_562;
        wp::float32 var_563;
        wp::int32 var_564;
        wp::float32 var_565;
        wp::vec_t<3, wp::float32> var_566;
        wp::vec_t<3, wp::float32> var_567;
        const wp::int32 var_568 = 8;
        const wp::int32 var_569 = 2;
        wp::int32 var_570;
        wp::int32 var_571;
        const wp::int32 var_572 = 2;
        wp::int32 var_573;
        const wp::int32 var_574 = 1;
        wp::int32 var_575;
        wp::int32 var_576;
        wp::float32 var_577;
        const wp::int32 var_578 = 1;
        wp::int32 var_579;
        bool var_580;
        wp::float32 var_581;
        wp::float32 var_582;
        wp::float32 var_583;
        wp::int32 var_584;
        wp::float32 var_585;
        wp::vec_t<3, wp::float32> var_586;
        wp::vec_t<3, wp::float32> var_587;
        const wp::int32 var_588 = 9;
        const wp::int32 var_589 = 2;
        wp::int32 var_590;
        wp::int32 var_591;
        const wp::int32 var_592 = 2;
        wp::int32 var_593;
        const wp::int32 var_594 = 1;
        wp::int32 var_595;
        wp::int32 var_596;
        wp::float32 var_597;
        const wp::int32 var_598 = 1;
        wp::int32 var_599;
        bool var_600;
        wp::float32 var_601;
        wp::float32 var_602;
        wp::float32 var_603;
        wp::int32 var_604;
        wp::float32 var_605;
        wp::vec_t<3, wp::float32> var_606;
        wp::vec_t<3, wp::float32> var_607;
        const wp::int32 var_608 = 10;
        const wp::int32 var_609 = 2;
        wp::int32 var_610;
        wp::int32 var_611;
        const wp::int32 var_612 = 2;
        wp::int32 var_613;
        const wp::int32 var_614 = 1;
        wp::int32 var_615;
        wp::int32 var_616;
        wp::float32 var_617;
        const wp::int32 var_618 = 1;
        wp::int32 var_619;
        bool var_620;
        wp::float32 var_621;
        wp::float32 var_622;
        wp::float32 var_623;
        wp::int32 var_624;
        wp::float32 var_625;
        wp::vec_t<3, wp::float32> var_626;
        wp::vec_t<3, wp::float32> var_627;
        wp::int32 var_628;
        const wp::int32 var_629 = 0;
        bool var_630;
        const wp::int32 var_631 = 0;
        wp::float32 var_632;
        const wp::int32 var_633 = 1;
        bool var_634;
        const wp::int32 var_635 = 1;
        wp::float32 var_636;
        const wp::int32 var_637 = 2;
        wp::float32 var_638;
        wp::float32 var_639;
        wp::float32 var_640;
        wp::float32 var_641;
        wp::float32 var_642;
        wp::float32* var_643;
        wp::float32 var_644;
        wp::float32 var_645;
        const wp::int32 var_646 = 0;
        bool var_647;
        const wp::int32 var_648 = 2;
        wp::float32 var_649;
        wp::float32 var_650;
        wp::float32 var_651;
        const wp::int32 var_652 = 2;
        wp::int32 var_653;
        wp::float32* var_654;
        wp::float32 var_655;
        wp::float32 var_656;
        const wp::int32 var_657 = 2;
        wp::int32 var_658;
        //---------
        // forward
        // def sum_histograms_of_lanes_kernel(part__first, part__last, part__run, ranks, neighborhood__tree__count, neighborhood__tree__root, neighborhood__tree__levels, neighborhood__tree__boxes, neighborhood__tree__points, neighborhood__limits, scratch__ids, scratch__keys, scratch__room, scratch__gather, scratch__stride, histograms, rows, features):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // first = part__first + i // WARP * part__run                                            <L 4>
        var_2 = wp::floordiv(var_0, var_1);
        var_3 = wp::mul(var_2, var_part__run);
        var_4 = wp::add(var_part__first, var_3);
        // for group in range(first, min(first + part__run, part__last)):                         <L 5>
        var_5 = wp::add(var_4, var_part__run);
        var_6 = wp::min(var_5, var_part__last);
        var_7 = wp::range(var_4, var_6);
        start_for_0:;
            if (iter_cmp(var_7) == 0) goto end_for_0;
            var_8 = wp::iter_next(var_7);
            // stored = store_members(i, group, ranks, neighborhood__tree__root, neighborhood__tree__levels, neighborhood__tree__boxes, neighborhood__tree__points, neighborhood__limits, scratch__ids, scratch__keys, scratch__room, scratch__gather, scratch__stride)       <L 6>
            var_9 = store_members_on_cuda_0(var_0, var_8, var_ranks, var_neighborhood__tree__root, var_neighborhood__tree__levels, var_neighborhood__tree__boxes, var_neighborhood__tree__points, var_neighborhood__limits, var_scratch__ids, var_scratch__keys, var_scratch__room, var_scratch__gather, var_scratch__stride);
            // sync_lanes()                                                                       <L 7>
            _sync_lanes_0();
            // for owner in range(min(WARP, ranks.shape[0] - group * WARP)):                      <L 8>
            var_10 = &(var_ranks.shape);
            var_13 = wp::load(var_10);
            var_12 = wp::extract(var_13, var_11);
            var_14 = wp::mul(var_8, var_1);
            var_15 = wp::sub(var_12, var_14);
            var_16 = wp::min(var_1, var_15);
            var_17 = wp::range(var_16);
            start_for_2:;
                if (iter_cmp(var_17) == 0) goto end_for_2;
                var_18 = wp::iter_next(var_17);
                // member = group * WARP + owner                                                  <L 9>
                var_19 = wp::mul(var_8, var_1);
                var_20 = wp::add(var_19, var_18);
                // rank = ranks[member]                                                           <L 10>
                var_21 = wp::address(var_ranks, var_20);
                var_23 = wp::load(var_21);
                var_22 = wp::copy(var_23);
                // row = rows[member]                                                             <L 11>
                var_24 = wp::address(var_rows, var_20);
                var_26 = wp::load(var_24);
                var_25 = wp::copy(var_26);
                // total = float(0.0)                                                             <L 12>
                var_28 = wp::float(var_27);
                // end = float(0.0)                                                               <L 13>
                var_30 = wp::float(var_29);
                // own = lane()                                                                   <L 14>
                var_31 = _lane_0();
                // count = shuffle(stored, owner)                                                 <L 15>
                var_32 = _shuffle_0(var_9, var_18);
                // for chunk in range((count + WARP - 1) // WARP):                                <L 16>
                var_33 = wp::add(var_32, var_1);
                var_35 = wp::sub(var_33, var_34);
                var_36 = wp::floordiv(var_35, var_1);
                var_37 = wp::range(var_36);
                start_for_4:;
                    if (iter_cmp(var_37) == 0) goto end_for_4;
                    var_38 = wp::iter_next(var_37);
                    // left = min(WARP, count - chunk * WARP)                                     <L 17>
                    var_39 = wp::mul(var_38, var_1);
                    var_40 = wp::sub(var_32, var_39);
                    var_41 = wp::min(var_1, var_40);
                    // key = scratch__keys[i - own + owner + (chunk * WARP + min(own, left - 1)) * scratch__stride]       <L 18>
                    var_42 = wp::sub(var_0, var_31);
                    var_43 = wp::add(var_42, var_18);
                    var_44 = wp::mul(var_38, var_1);
                    var_46 = wp::sub(var_41, var_45);
                    var_47 = wp::min(var_31, var_46);
                    var_48 = wp::add(var_44, var_47);
                    var_49 = wp::mul(var_48, var_scratch__stride);
                    var_50 = wp::add(var_43, var_49);
                    var_51 = wp::address(var_scratch__keys, var_50);
                    var_53 = wp::load(var_51);
                    var_52 = wp::copy(var_53);
                    // weight = weight_of(key_number(key))                                        <L 19>
                    var_54 = key_number_0(var_52);
                    var_55 = weight_of_0(var_54);
                    // if own < left:                                                             <L 20>
                    var_56 = (var_31 < var_41);
                    if (var_56) {
                        // end += weight * histograms[key_index(key), 2 * HALF]                   <L 21>
                        var_57 = key_index_0(var_52);
                        var_60 = wp::mul(var_58, var_59);
                        var_61 = wp::address(var_histograms, var_57, var_60);
                        var_63 = wp::load(var_61);
                        var_62 = wp::mul(var_55, var_63);
                        var_64 = wp::add(var_30, var_62);
                    }
                    var_65 = wp::where(var_56, var_64, var_30);
                    // for j in range(left):                                                      <L 22>
                    var_66 = wp::range(var_41);
                    start_for_6:;
                        if (iter_cmp(var_66) == 0) goto end_for_6;
                        var_67 = wp::iter_next(var_66);
                        // total += shuffle(weight, j) * histograms[shuffle(key_index(key), j), own]       <L 23>
                        var_68 = _shuffle_1(var_55, var_67);
                        var_69 = key_index_0(var_52);
                        var_70 = _shuffle_0(var_69, var_67);
                        var_71 = wp::address(var_histograms, var_70, var_31);
                        var_73 = wp::load(var_71);
                        var_72 = wp::mul(var_68, var_73);
                        var_74 = wp::add(var_28, var_72);
                        wp::assign(var_28, var_74);
                        goto start_for_6;
                    end_for_6:;
                    wp::assign(var_30, var_65);
                    goto start_for_4;
                end_for_4:;
                // if count < 0:                                                                  <L 24>
                var_76 = (var_32 < var_75);
                if (var_76) {
                    // p__neighbors_of__1 = neighborhood__tree__points[rank]                      <L 25>
                    var_77 = wp::address(var_neighborhood__tree__points, var_22);
                    var_79 = wp::load(var_77);
                    var_78 = wp::copy(var_79);
                    // limit__neighbors_of__1 = neighborhood__limits[rank]                        <L 26>
                    var_80 = wp::address(var_neighborhood__limits, var_22);
                    var_82 = wp::load(var_80);
                    var_81 = wp::copy(var_82);
                    // start__points_within__2 = rank // BUCKET__neighbors_of                     <L 27>
                    var_84 = wp::floordiv(var_22, var_83);
                    // max_sqdist__points_within__2 = key_number(limit__neighbors_of__1)          <L 28>
                    var_85 = key_number_0(var_81);
                    // step__leaves_within__3 = start_traversal__leaves_within(start__points_within__2)       <L 29>
                    var_86 = start_traversal_0(var_84);
                    // while int(step__leaves_within__3[0]) <= neighborhood__tree__root:          <L 30>
        start_while_8:;
                    var_88 = wp::extract(var_86, var_87);
                    var_89 = wp::int(var_88);
                    var_90 = (var_89 <= var_neighborhood__tree__root);
        if ((var_90) == false) goto end_while_8;
                        // bucket__leaves_within__3 = int(step__leaves_within__3[2])              <L 31>
                        var_92 = wp::extract(var_86, var_91);
                        var_93 = wp::int(var_92);
                        // distances__leaves_within__3 = measure_boxes__leaves_within(neighborhood__tree__boxes, bucket__leaves_within__3, p__neighbors_of__1, p__neighbors_of__1)       <L 32>
                        var_94 = measure_boxes_0(var_neighborhood__tree__boxes, var_93, var_78, var_78);
                        // for leaf__leaves_within__3 in range(FAN__leaves_within):               <L 33>
                        // if distances__leaves_within__3[leaf__leaves_within__3] <= max_sqdist__points_within__2:       <L 34>
                        var_96 = wp::extract(var_94, var_95);
                        var_97 = (var_96 <= var_85);
                        if (var_97) {
                            // first__points_within__2 = bucket__leaves_within__3 * BUCKET__leaves_within + leaf__leaves_within__3 * LEAF__leaves_within       <L 35>
                            var_99 = wp::mul(var_93, var_98);
                            var_101 = wp::mul(var_95, var_100);
                            var_102 = wp::add(var_99, var_101);
                            // for j in range(first__points_within__2, min(first__points_within__2 + LEAF__points_within, neighborhood__tree__count)):       <L 36>
                            var_104 = wp::add(var_102, var_103);
                            var_105 = wp::min(var_104, var_neighborhood__tree__count);
                            var_106 = wp::range(var_102, var_105);
                            start_for_10:;
                                if (iter_cmp(var_106) == 0) goto end_for_10;
                                var_107 = wp::iter_next(var_106);
                                // sqdist = square_distance__points_within(p__neighbors_of__1, neighborhood__tree__points[j])       <L 37>
                                var_108 = wp::address(var_neighborhood__tree__points, var_107);
                                var_110 = wp::load(var_108);
                                var_109 = square_distance_0(var_78, var_110);
                                // if sqdist <= max_sqdist__points_within__2:                     <L 38>
                                var_111 = (var_109 <= var_85);
                                if (var_111) {
                                    // if pack_key__neighbors_of(sqdist, j) <= limit__neighbors_of__1:       <L 39>
                                    var_112 = pack_key_0(var_109, var_107);
                                    var_113 = (var_112 <= var_81);
                                    if (var_113) {
                                        // weight = weight_of(sqdist)                             <L 40>
                                        var_114 = weight_of_0(var_109);
                                        // total += weight * histograms[j, own]                   <L 41>
                                        var_115 = wp::address(var_histograms, var_107, var_31);
                                        var_117 = wp::load(var_115);
                                        var_116 = wp::mul(var_114, var_117);
                                        var_118 = wp::add(var_28, var_116);
                                        // if own == 0:                                           <L 42>
                                        var_120 = (var_31 == var_119);
                                        if (var_120) {
                                            // end += weight * histograms[j, 2 * HALF]            <L 43>
                                            var_122 = wp::mul(var_121, var_59);
                                            var_123 = wp::address(var_histograms, var_107, var_122);
                                            var_125 = wp::load(var_123);
                                            var_124 = wp::mul(var_114, var_125);
                                            var_126 = wp::add(var_30, var_124);
                                        }
                                        var_127 = wp::where(var_120, var_126, var_30);
                                    }
                                    var_128 = wp::where(var_113, var_118, var_28);
                                    var_129 = wp::where(var_113, var_127, var_30);
                                    var_130 = wp::where(var_113, var_114, var_55);
                                }
                                var_131 = wp::where(var_111, var_128, var_28);
                                var_132 = wp::where(var_111, var_129, var_30);
                                var_133 = wp::where(var_111, var_130, var_55);
                                wp::assign(var_28, var_131);
                                wp::assign(var_30, var_132);
                                wp::assign(var_55, var_133);
                                goto start_for_10;
                            end_for_10:;
                        }
                        var_134 = wp::where(var_97, var_107, var_67);
                        // if distances__leaves_within__3[leaf__leaves_within__3] <= max_sqdist__points_within__2:       <L 34>
                        var_136 = wp::extract(var_94, var_135);
                        var_137 = (var_136 <= var_85);
                        if (var_137) {
                            // first__points_within__2 = bucket__leaves_within__3 * BUCKET__leaves_within + leaf__leaves_within__3 * LEAF__leaves_within       <L 35>
                            var_138 = wp::mul(var_93, var_98);
                            var_139 = wp::mul(var_135, var_100);
                            var_140 = wp::add(var_138, var_139);
                            // for j in range(first__points_within__2, min(first__points_within__2 + LEAF__points_within, neighborhood__tree__count)):       <L 36>
                            var_141 = wp::add(var_140, var_103);
                            var_142 = wp::min(var_141, var_neighborhood__tree__count);
                            var_143 = wp::range(var_140, var_142);
                            start_for_12:;
                                if (iter_cmp(var_143) == 0) goto end_for_12;
                                var_144 = wp::iter_next(var_143);
                                // sqdist = square_distance__points_within(p__neighbors_of__1, neighborhood__tree__points[j])       <L 37>
                                var_145 = wp::address(var_neighborhood__tree__points, var_144);
                                var_147 = wp::load(var_145);
                                var_146 = square_distance_0(var_78, var_147);
                                // if sqdist <= max_sqdist__points_within__2:                     <L 38>
                                var_148 = (var_146 <= var_85);
                                if (var_148) {
                                    // if pack_key__neighbors_of(sqdist, j) <= limit__neighbors_of__1:       <L 39>
                                    var_149 = pack_key_0(var_146, var_144);
                                    var_150 = (var_149 <= var_81);
                                    if (var_150) {
                                        // weight = weight_of(sqdist)                             <L 40>
                                        var_151 = weight_of_0(var_146);
                                        // total += weight * histograms[j, own]                   <L 41>
                                        var_152 = wp::address(var_histograms, var_144, var_31);
                                        var_154 = wp::load(var_152);
                                        var_153 = wp::mul(var_151, var_154);
                                        var_155 = wp::add(var_28, var_153);
                                        // if own == 0:                                           <L 42>
                                        var_157 = (var_31 == var_156);
                                        if (var_157) {
                                            // end += weight * histograms[j, 2 * HALF]            <L 43>
                                            var_159 = wp::mul(var_158, var_59);
                                            var_160 = wp::address(var_histograms, var_144, var_159);
                                            var_162 = wp::load(var_160);
                                            var_161 = wp::mul(var_151, var_162);
                                            var_163 = wp::add(var_30, var_161);
                                        }
                                        var_164 = wp::where(var_157, var_163, var_30);
                                    }
                                    var_165 = wp::where(var_150, var_155, var_28);
                                    var_166 = wp::where(var_150, var_164, var_30);
                                    var_167 = wp::where(var_150, var_151, var_55);
                                }
                                var_168 = wp::where(var_148, var_165, var_28);
                                var_169 = wp::where(var_148, var_166, var_30);
                                var_170 = wp::where(var_148, var_167, var_55);
                                wp::assign(var_28, var_168);
                                wp::assign(var_30, var_169);
                                wp::assign(var_55, var_170);
                                wp::assign(var_109, var_146);
                                goto start_for_12;
                            end_for_12:;
                        }
                        var_171 = wp::where(var_137, var_144, var_134);
                        var_172 = wp::where(var_137, var_140, var_102);
                        // if distances__leaves_within__3[leaf__leaves_within__3] <= max_sqdist__points_within__2:       <L 34>
                        var_174 = wp::extract(var_94, var_173);
                        var_175 = (var_174 <= var_85);
                        if (var_175) {
                            // first__points_within__2 = bucket__leaves_within__3 * BUCKET__leaves_within + leaf__leaves_within__3 * LEAF__leaves_within       <L 35>
                            var_176 = wp::mul(var_93, var_98);
                            var_177 = wp::mul(var_173, var_100);
                            var_178 = wp::add(var_176, var_177);
                            // for j in range(first__points_within__2, min(first__points_within__2 + LEAF__points_within, neighborhood__tree__count)):       <L 36>
                            var_179 = wp::add(var_178, var_103);
                            var_180 = wp::min(var_179, var_neighborhood__tree__count);
                            var_181 = wp::range(var_178, var_180);
                            start_for_14:;
                                if (iter_cmp(var_181) == 0) goto end_for_14;
                                var_182 = wp::iter_next(var_181);
                                // sqdist = square_distance__points_within(p__neighbors_of__1, neighborhood__tree__points[j])       <L 37>
                                var_183 = wp::address(var_neighborhood__tree__points, var_182);
                                var_185 = wp::load(var_183);
                                var_184 = square_distance_0(var_78, var_185);
                                // if sqdist <= max_sqdist__points_within__2:                     <L 38>
                                var_186 = (var_184 <= var_85);
                                if (var_186) {
                                    // if pack_key__neighbors_of(sqdist, j) <= limit__neighbors_of__1:       <L 39>
                                    var_187 = pack_key_0(var_184, var_182);
                                    var_188 = (var_187 <= var_81);
                                    if (var_188) {
                                        // weight = weight_of(sqdist)                             <L 40>
                                        var_189 = weight_of_0(var_184);
                                        // total += weight * histograms[j, own]                   <L 41>
                                        var_190 = wp::address(var_histograms, var_182, var_31);
                                        var_192 = wp::load(var_190);
                                        var_191 = wp::mul(var_189, var_192);
                                        var_193 = wp::add(var_28, var_191);
                                        // if own == 0:                                           <L 42>
                                        var_195 = (var_31 == var_194);
                                        if (var_195) {
                                            // end += weight * histograms[j, 2 * HALF]            <L 43>
                                            var_197 = wp::mul(var_196, var_59);
                                            var_198 = wp::address(var_histograms, var_182, var_197);
                                            var_200 = wp::load(var_198);
                                            var_199 = wp::mul(var_189, var_200);
                                            var_201 = wp::add(var_30, var_199);
                                        }
                                        var_202 = wp::where(var_195, var_201, var_30);
                                    }
                                    var_203 = wp::where(var_188, var_193, var_28);
                                    var_204 = wp::where(var_188, var_202, var_30);
                                    var_205 = wp::where(var_188, var_189, var_55);
                                }
                                var_206 = wp::where(var_186, var_203, var_28);
                                var_207 = wp::where(var_186, var_204, var_30);
                                var_208 = wp::where(var_186, var_205, var_55);
                                wp::assign(var_28, var_206);
                                wp::assign(var_30, var_207);
                                wp::assign(var_55, var_208);
                                wp::assign(var_109, var_184);
                                goto start_for_14;
                            end_for_14:;
                        }
                        var_209 = wp::where(var_175, var_182, var_171);
                        var_210 = wp::where(var_175, var_178, var_172);
                        // if distances__leaves_within__3[leaf__leaves_within__3] <= max_sqdist__points_within__2:       <L 34>
                        var_212 = wp::extract(var_94, var_211);
                        var_213 = (var_212 <= var_85);
                        if (var_213) {
                            // first__points_within__2 = bucket__leaves_within__3 * BUCKET__leaves_within + leaf__leaves_within__3 * LEAF__leaves_within       <L 35>
                            var_214 = wp::mul(var_93, var_98);
                            var_215 = wp::mul(var_211, var_100);
                            var_216 = wp::add(var_214, var_215);
                            // for j in range(first__points_within__2, min(first__points_within__2 + LEAF__points_within, neighborhood__tree__count)):       <L 36>
                            var_217 = wp::add(var_216, var_103);
                            var_218 = wp::min(var_217, var_neighborhood__tree__count);
                            var_219 = wp::range(var_216, var_218);
                            start_for_16:;
                                if (iter_cmp(var_219) == 0) goto end_for_16;
                                var_220 = wp::iter_next(var_219);
                                // sqdist = square_distance__points_within(p__neighbors_of__1, neighborhood__tree__points[j])       <L 37>
                                var_221 = wp::address(var_neighborhood__tree__points, var_220);
                                var_223 = wp::load(var_221);
                                var_222 = square_distance_0(var_78, var_223);
                                // if sqdist <= max_sqdist__points_within__2:                     <L 38>
                                var_224 = (var_222 <= var_85);
                                if (var_224) {
                                    // if pack_key__neighbors_of(sqdist, j) <= limit__neighbors_of__1:       <L 39>
                                    var_225 = pack_key_0(var_222, var_220);
                                    var_226 = (var_225 <= var_81);
                                    if (var_226) {
                                        // weight = weight_of(sqdist)                             <L 40>
                                        var_227 = weight_of_0(var_222);
                                        // total += weight * histograms[j, own]                   <L 41>
                                        var_228 = wp::address(var_histograms, var_220, var_31);
                                        var_230 = wp::load(var_228);
                                        var_229 = wp::mul(var_227, var_230);
                                        var_231 = wp::add(var_28, var_229);
                                        // if own == 0:                                           <L 42>
                                        var_233 = (var_31 == var_232);
                                        if (var_233) {
                                            // end += weight * histograms[j, 2 * HALF]            <L 43>
                                            var_235 = wp::mul(var_234, var_59);
                                            var_236 = wp::address(var_histograms, var_220, var_235);
                                            var_238 = wp::load(var_236);
                                            var_237 = wp::mul(var_227, var_238);
                                            var_239 = wp::add(var_30, var_237);
                                        }
                                        var_240 = wp::where(var_233, var_239, var_30);
                                    }
                                    var_241 = wp::where(var_226, var_231, var_28);
                                    var_242 = wp::where(var_226, var_240, var_30);
                                    var_243 = wp::where(var_226, var_227, var_55);
                                }
                                var_244 = wp::where(var_224, var_241, var_28);
                                var_245 = wp::where(var_224, var_242, var_30);
                                var_246 = wp::where(var_224, var_243, var_55);
                                wp::assign(var_28, var_244);
                                wp::assign(var_30, var_245);
                                wp::assign(var_55, var_246);
                                wp::assign(var_109, var_222);
                                goto start_for_16;
                            end_for_16:;
                        }
                        var_247 = wp::where(var_213, var_220, var_209);
                        var_248 = wp::where(var_213, var_216, var_210);
                        // if distances__leaves_within__3[leaf__leaves_within__3] <= max_sqdist__points_within__2:       <L 34>
                        var_250 = wp::extract(var_94, var_249);
                        var_251 = (var_250 <= var_85);
                        if (var_251) {
                            // first__points_within__2 = bucket__leaves_within__3 * BUCKET__leaves_within + leaf__leaves_within__3 * LEAF__leaves_within       <L 35>
                            var_252 = wp::mul(var_93, var_98);
                            var_253 = wp::mul(var_249, var_100);
                            var_254 = wp::add(var_252, var_253);
                            // for j in range(first__points_within__2, min(first__points_within__2 + LEAF__points_within, neighborhood__tree__count)):       <L 36>
                            var_255 = wp::add(var_254, var_103);
                            var_256 = wp::min(var_255, var_neighborhood__tree__count);
                            var_257 = wp::range(var_254, var_256);
                            start_for_18:;
                                if (iter_cmp(var_257) == 0) goto end_for_18;
                                var_258 = wp::iter_next(var_257);
                                // sqdist = square_distance__points_within(p__neighbors_of__1, neighborhood__tree__points[j])       <L 37>
                                var_259 = wp::address(var_neighborhood__tree__points, var_258);
                                var_261 = wp::load(var_259);
                                var_260 = square_distance_0(var_78, var_261);
                                // if sqdist <= max_sqdist__points_within__2:                     <L 38>
                                var_262 = (var_260 <= var_85);
                                if (var_262) {
                                    // if pack_key__neighbors_of(sqdist, j) <= limit__neighbors_of__1:       <L 39>
                                    var_263 = pack_key_0(var_260, var_258);
                                    var_264 = (var_263 <= var_81);
                                    if (var_264) {
                                        // weight = weight_of(sqdist)                             <L 40>
                                        var_265 = weight_of_0(var_260);
                                        // total += weight * histograms[j, own]                   <L 41>
                                        var_266 = wp::address(var_histograms, var_258, var_31);
                                        var_268 = wp::load(var_266);
                                        var_267 = wp::mul(var_265, var_268);
                                        var_269 = wp::add(var_28, var_267);
                                        // if own == 0:                                           <L 42>
                                        var_271 = (var_31 == var_270);
                                        if (var_271) {
                                            // end += weight * histograms[j, 2 * HALF]            <L 43>
                                            var_273 = wp::mul(var_272, var_59);
                                            var_274 = wp::address(var_histograms, var_258, var_273);
                                            var_276 = wp::load(var_274);
                                            var_275 = wp::mul(var_265, var_276);
                                            var_277 = wp::add(var_30, var_275);
                                        }
                                        var_278 = wp::where(var_271, var_277, var_30);
                                    }
                                    var_279 = wp::where(var_264, var_269, var_28);
                                    var_280 = wp::where(var_264, var_278, var_30);
                                    var_281 = wp::where(var_264, var_265, var_55);
                                }
                                var_282 = wp::where(var_262, var_279, var_28);
                                var_283 = wp::where(var_262, var_280, var_30);
                                var_284 = wp::where(var_262, var_281, var_55);
                                wp::assign(var_28, var_282);
                                wp::assign(var_30, var_283);
                                wp::assign(var_55, var_284);
                                wp::assign(var_109, var_260);
                                goto start_for_18;
                            end_for_18:;
                        }
                        var_285 = wp::where(var_251, var_258, var_247);
                        var_286 = wp::where(var_251, var_254, var_248);
                        // if distances__leaves_within__3[leaf__leaves_within__3] <= max_sqdist__points_within__2:       <L 34>
                        var_288 = wp::extract(var_94, var_287);
                        var_289 = (var_288 <= var_85);
                        if (var_289) {
                            // first__points_within__2 = bucket__leaves_within__3 * BUCKET__leaves_within + leaf__leaves_within__3 * LEAF__leaves_within       <L 35>
                            var_290 = wp::mul(var_93, var_98);
                            var_291 = wp::mul(var_287, var_100);
                            var_292 = wp::add(var_290, var_291);
                            // for j in range(first__points_within__2, min(first__points_within__2 + LEAF__points_within, neighborhood__tree__count)):       <L 36>
                            var_293 = wp::add(var_292, var_103);
                            var_294 = wp::min(var_293, var_neighborhood__tree__count);
                            var_295 = wp::range(var_292, var_294);
                            start_for_20:;
                                if (iter_cmp(var_295) == 0) goto end_for_20;
                                var_296 = wp::iter_next(var_295);
                                // sqdist = square_distance__points_within(p__neighbors_of__1, neighborhood__tree__points[j])       <L 37>
                                var_297 = wp::address(var_neighborhood__tree__points, var_296);
                                var_299 = wp::load(var_297);
                                var_298 = square_distance_0(var_78, var_299);
                                // if sqdist <= max_sqdist__points_within__2:                     <L 38>
                                var_300 = (var_298 <= var_85);
                                if (var_300) {
                                    // if pack_key__neighbors_of(sqdist, j) <= limit__neighbors_of__1:       <L 39>
                                    var_301 = pack_key_0(var_298, var_296);
                                    var_302 = (var_301 <= var_81);
                                    if (var_302) {
                                        // weight = weight_of(sqdist)                             <L 40>
                                        var_303 = weight_of_0(var_298);
                                        // total += weight * histograms[j, own]                   <L 41>
                                        var_304 = wp::address(var_histograms, var_296, var_31);
                                        var_306 = wp::load(var_304);
                                        var_305 = wp::mul(var_303, var_306);
                                        var_307 = wp::add(var_28, var_305);
                                        // if own == 0:                                           <L 42>
                                        var_309 = (var_31 == var_308);
                                        if (var_309) {
                                            // end += weight * histograms[j, 2 * HALF]            <L 43>
                                            var_311 = wp::mul(var_310, var_59);
                                            var_312 = wp::address(var_histograms, var_296, var_311);
                                            var_314 = wp::load(var_312);
                                            var_313 = wp::mul(var_303, var_314);
                                            var_315 = wp::add(var_30, var_313);
                                        }
                                        var_316 = wp::where(var_309, var_315, var_30);
                                    }
                                    var_317 = wp::where(var_302, var_307, var_28);
                                    var_318 = wp::where(var_302, var_316, var_30);
                                    var_319 = wp::where(var_302, var_303, var_55);
                                }
                                var_320 = wp::where(var_300, var_317, var_28);
                                var_321 = wp::where(var_300, var_318, var_30);
                                var_322 = wp::where(var_300, var_319, var_55);
                                wp::assign(var_28, var_320);
                                wp::assign(var_30, var_321);
                                wp::assign(var_55, var_322);
                                wp::assign(var_109, var_298);
                                goto start_for_20;
                            end_for_20:;
                        }
                        var_323 = wp::where(var_289, var_296, var_285);
                        var_324 = wp::where(var_289, var_292, var_286);
                        // if distances__leaves_within__3[leaf__leaves_within__3] <= max_sqdist__points_within__2:       <L 34>
                        var_326 = wp::extract(var_94, var_325);
                        var_327 = (var_326 <= var_85);
                        if (var_327) {
                            // first__points_within__2 = bucket__leaves_within__3 * BUCKET__leaves_within + leaf__leaves_within__3 * LEAF__leaves_within       <L 35>
                            var_328 = wp::mul(var_93, var_98);
                            var_329 = wp::mul(var_325, var_100);
                            var_330 = wp::add(var_328, var_329);
                            // for j in range(first__points_within__2, min(first__points_within__2 + LEAF__points_within, neighborhood__tree__count)):       <L 36>
                            var_331 = wp::add(var_330, var_103);
                            var_332 = wp::min(var_331, var_neighborhood__tree__count);
                            var_333 = wp::range(var_330, var_332);
                            start_for_22:;
                                if (iter_cmp(var_333) == 0) goto end_for_22;
                                var_334 = wp::iter_next(var_333);
                                // sqdist = square_distance__points_within(p__neighbors_of__1, neighborhood__tree__points[j])       <L 37>
                                var_335 = wp::address(var_neighborhood__tree__points, var_334);
                                var_337 = wp::load(var_335);
                                var_336 = square_distance_0(var_78, var_337);
                                // if sqdist <= max_sqdist__points_within__2:                     <L 38>
                                var_338 = (var_336 <= var_85);
                                if (var_338) {
                                    // if pack_key__neighbors_of(sqdist, j) <= limit__neighbors_of__1:       <L 39>
                                    var_339 = pack_key_0(var_336, var_334);
                                    var_340 = (var_339 <= var_81);
                                    if (var_340) {
                                        // weight = weight_of(sqdist)                             <L 40>
                                        var_341 = weight_of_0(var_336);
                                        // total += weight * histograms[j, own]                   <L 41>
                                        var_342 = wp::address(var_histograms, var_334, var_31);
                                        var_344 = wp::load(var_342);
                                        var_343 = wp::mul(var_341, var_344);
                                        var_345 = wp::add(var_28, var_343);
                                        // if own == 0:                                           <L 42>
                                        var_347 = (var_31 == var_346);
                                        if (var_347) {
                                            // end += weight * histograms[j, 2 * HALF]            <L 43>
                                            var_349 = wp::mul(var_348, var_59);
                                            var_350 = wp::address(var_histograms, var_334, var_349);
                                            var_352 = wp::load(var_350);
                                            var_351 = wp::mul(var_341, var_352);
                                            var_353 = wp::add(var_30, var_351);
                                        }
                                        var_354 = wp::where(var_347, var_353, var_30);
                                    }
                                    var_355 = wp::where(var_340, var_345, var_28);
                                    var_356 = wp::where(var_340, var_354, var_30);
                                    var_357 = wp::where(var_340, var_341, var_55);
                                }
                                var_358 = wp::where(var_338, var_355, var_28);
                                var_359 = wp::where(var_338, var_356, var_30);
                                var_360 = wp::where(var_338, var_357, var_55);
                                wp::assign(var_28, var_358);
                                wp::assign(var_30, var_359);
                                wp::assign(var_55, var_360);
                                wp::assign(var_109, var_336);
                                goto start_for_22;
                            end_for_22:;
                        }
                        var_361 = wp::where(var_327, var_334, var_323);
                        var_362 = wp::where(var_327, var_330, var_324);
                        // if distances__leaves_within__3[leaf__leaves_within__3] <= max_sqdist__points_within__2:       <L 34>
                        var_364 = wp::extract(var_94, var_363);
                        var_365 = (var_364 <= var_85);
                        if (var_365) {
                            // first__points_within__2 = bucket__leaves_within__3 * BUCKET__leaves_within + leaf__leaves_within__3 * LEAF__leaves_within       <L 35>
                            var_366 = wp::mul(var_93, var_98);
                            var_367 = wp::mul(var_363, var_100);
                            var_368 = wp::add(var_366, var_367);
                            // for j in range(first__points_within__2, min(first__points_within__2 + LEAF__points_within, neighborhood__tree__count)):       <L 36>
                            var_369 = wp::add(var_368, var_103);
                            var_370 = wp::min(var_369, var_neighborhood__tree__count);
                            var_371 = wp::range(var_368, var_370);
                            start_for_24:;
                                if (iter_cmp(var_371) == 0) goto end_for_24;
                                var_372 = wp::iter_next(var_371);
                                // sqdist = square_distance__points_within(p__neighbors_of__1, neighborhood__tree__points[j])       <L 37>
                                var_373 = wp::address(var_neighborhood__tree__points, var_372);
                                var_375 = wp::load(var_373);
                                var_374 = square_distance_0(var_78, var_375);
                                // if sqdist <= max_sqdist__points_within__2:                     <L 38>
                                var_376 = (var_374 <= var_85);
                                if (var_376) {
                                    // if pack_key__neighbors_of(sqdist, j) <= limit__neighbors_of__1:       <L 39>
                                    var_377 = pack_key_0(var_374, var_372);
                                    var_378 = (var_377 <= var_81);
                                    if (var_378) {
                                        // weight = weight_of(sqdist)                             <L 40>
                                        var_379 = weight_of_0(var_374);
                                        // total += weight * histograms[j, own]                   <L 41>
                                        var_380 = wp::address(var_histograms, var_372, var_31);
                                        var_382 = wp::load(var_380);
                                        var_381 = wp::mul(var_379, var_382);
                                        var_383 = wp::add(var_28, var_381);
                                        // if own == 0:                                           <L 42>
                                        var_385 = (var_31 == var_384);
                                        if (var_385) {
                                            // end += weight * histograms[j, 2 * HALF]            <L 43>
                                            var_387 = wp::mul(var_386, var_59);
                                            var_388 = wp::address(var_histograms, var_372, var_387);
                                            var_390 = wp::load(var_388);
                                            var_389 = wp::mul(var_379, var_390);
                                            var_391 = wp::add(var_30, var_389);
                                        }
                                        var_392 = wp::where(var_385, var_391, var_30);
                                    }
                                    var_393 = wp::where(var_378, var_383, var_28);
                                    var_394 = wp::where(var_378, var_392, var_30);
                                    var_395 = wp::where(var_378, var_379, var_55);
                                }
                                var_396 = wp::where(var_376, var_393, var_28);
                                var_397 = wp::where(var_376, var_394, var_30);
                                var_398 = wp::where(var_376, var_395, var_55);
                                wp::assign(var_28, var_396);
                                wp::assign(var_30, var_397);
                                wp::assign(var_55, var_398);
                                wp::assign(var_109, var_374);
                                goto start_for_24;
                            end_for_24:;
                        }
                        var_399 = wp::where(var_365, var_372, var_361);
                        var_400 = wp::where(var_365, var_368, var_362);
                        // step__leaves_within__3 = next_bucket__leaves_within(step__leaves_within__3, p__neighbors_of__1, p__neighbors_of__1, max_sqdist__points_within__2, neighborhood__tree__root, neighborhood__tree__levels, neighborhood__tree__boxes)       <L 44>
                        var_401 = next_bucket_0(var_86, var_78, var_78, var_85, var_neighborhood__tree__root, var_neighborhood__tree__levels, var_neighborhood__tree__boxes);
                        wp::assign(var_67, var_399);
                        wp::assign(var_86, var_401);
        goto start_while_8;
        end_while_8:;
                }
                // end = sum_of_lanes(end)                                                        <L 45>
                var_402 = sum_of_lanes_on_cuda_0(var_30);
                // sums = vec3(0.0, 0.0, 0.0)                                                     <L 46>
                var_406 = wp::vec_t<3, wp::float32>(var_403, var_404, var_405);
                // for c in range(BINS):                                                          <L 47>
                // third = shuffle(total, min(2 * BINS + c, 2 * HALF - 1))                        <L 48>
                var_410 = wp::mul(var_408, var_409);
                var_411 = wp::add(var_410, var_407);
                var_413 = wp::mul(var_412, var_59);
                var_415 = wp::sub(var_413, var_414);
                var_416 = wp::min(var_411, var_415);
                var_417 = _shuffle_1(var_28, var_416);
                // if c == BINS - 1:                                                              <L 49>
                var_419 = wp::sub(var_409, var_418);
                var_420 = (var_407 == var_419);
                if (var_420) {
                    // third = end                                                                <L 50>
                    var_421 = wp::copy(var_402);
                }
                var_422 = wp::where(var_420, var_421, var_417);
                // sums += vec3(shuffle(total, c), shuffle(total, BINS + c), third)               <L 51>
                var_423 = _shuffle_1(var_28, var_407);
                var_424 = wp::add(var_409, var_407);
                var_425 = _shuffle_1(var_28, var_424);
                var_426 = wp::vec_t<3, wp::float32>(var_423, var_425, var_422);
                var_427 = wp::add(var_406, var_426);
                // third = shuffle(total, min(2 * BINS + c, 2 * HALF - 1))                        <L 48>
                var_430 = wp::mul(var_429, var_409);
                var_431 = wp::add(var_430, var_428);
                var_433 = wp::mul(var_432, var_59);
                var_435 = wp::sub(var_433, var_434);
                var_436 = wp::min(var_431, var_435);
                var_437 = _shuffle_1(var_28, var_436);
                // if c == BINS - 1:                                                              <L 49>
                var_439 = wp::sub(var_409, var_438);
                var_440 = (var_428 == var_439);
                if (var_440) {
                    // third = end                                                                <L 50>
                    var_441 = wp::copy(var_402);
                }
                var_442 = wp::where(var_440, var_441, var_437);
                // sums += vec3(shuffle(total, c), shuffle(total, BINS + c), third)               <L 51>
                var_443 = _shuffle_1(var_28, var_428);
                var_444 = wp::add(var_409, var_428);
                var_445 = _shuffle_1(var_28, var_444);
                var_446 = wp::vec_t<3, wp::float32>(var_443, var_445, var_442);
                var_447 = wp::add(var_427, var_446);
                // third = shuffle(total, min(2 * BINS + c, 2 * HALF - 1))                        <L 48>
                var_450 = wp::mul(var_449, var_409);
                var_451 = wp::add(var_450, var_448);
                var_453 = wp::mul(var_452, var_59);
                var_455 = wp::sub(var_453, var_454);
                var_456 = wp::min(var_451, var_455);
                var_457 = _shuffle_1(var_28, var_456);
                // if c == BINS - 1:                                                              <L 49>
                var_459 = wp::sub(var_409, var_458);
                var_460 = (var_448 == var_459);
                if (var_460) {
                    // third = end                                                                <L 50>
                    var_461 = wp::copy(var_402);
                }
                var_462 = wp::where(var_460, var_461, var_457);
                // sums += vec3(shuffle(total, c), shuffle(total, BINS + c), third)               <L 51>
                var_463 = _shuffle_1(var_28, var_448);
                var_464 = wp::add(var_409, var_448);
                var_465 = _shuffle_1(var_28, var_464);
                var_466 = wp::vec_t<3, wp::float32>(var_463, var_465, var_462);
                var_467 = wp::add(var_447, var_466);
                // third = shuffle(total, min(2 * BINS + c, 2 * HALF - 1))                        <L 48>
                var_470 = wp::mul(var_469, var_409);
                var_471 = wp::add(var_470, var_468);
                var_473 = wp::mul(var_472, var_59);
                var_475 = wp::sub(var_473, var_474);
                var_476 = wp::min(var_471, var_475);
                var_477 = _shuffle_1(var_28, var_476);
                // if c == BINS - 1:                                                              <L 49>
                var_479 = wp::sub(var_409, var_478);
                var_480 = (var_468 == var_479);
                if (var_480) {
                    // third = end                                                                <L 50>
                    var_481 = wp::copy(var_402);
                }
                var_482 = wp::where(var_480, var_481, var_477);
                // sums += vec3(shuffle(total, c), shuffle(total, BINS + c), third)               <L 51>
                var_483 = _shuffle_1(var_28, var_468);
                var_484 = wp::add(var_409, var_468);
                var_485 = _shuffle_1(var_28, var_484);
                var_486 = wp::vec_t<3, wp::float32>(var_483, var_485, var_482);
                var_487 = wp::add(var_467, var_486);
                // third = shuffle(total, min(2 * BINS + c, 2 * HALF - 1))                        <L 48>
                var_490 = wp::mul(var_489, var_409);
                var_491 = wp::add(var_490, var_488);
                var_493 = wp::mul(var_492, var_59);
                var_495 = wp::sub(var_493, var_494);
                var_496 = wp::min(var_491, var_495);
                var_497 = _shuffle_1(var_28, var_496);
                // if c == BINS - 1:                                                              <L 49>
                var_499 = wp::sub(var_409, var_498);
                var_500 = (var_488 == var_499);
                if (var_500) {
                    // third = end                                                                <L 50>
                    var_501 = wp::copy(var_402);
                }
                var_502 = wp::where(var_500, var_501, var_497);
                // sums += vec3(shuffle(total, c), shuffle(total, BINS + c), third)               <L 51>
                var_503 = _shuffle_1(var_28, var_488);
                var_504 = wp::add(var_409, var_488);
                var_505 = _shuffle_1(var_28, var_504);
                var_506 = wp::vec_t<3, wp::float32>(var_503, var_505, var_502);
                var_507 = wp::add(var_487, var_506);
                // third = shuffle(total, min(2 * BINS + c, 2 * HALF - 1))                        <L 48>
                var_510 = wp::mul(var_509, var_409);
                var_511 = wp::add(var_510, var_508);
                var_513 = wp::mul(var_512, var_59);
                var_515 = wp::sub(var_513, var_514);
                var_516 = wp::min(var_511, var_515);
                var_517 = _shuffle_1(var_28, var_516);
                // if c == BINS - 1:                                                              <L 49>
                var_519 = wp::sub(var_409, var_518);
                var_520 = (var_508 == var_519);
                if (var_520) {
                    // third = end                                                                <L 50>
                    var_521 = wp::copy(var_402);
                }
                var_522 = wp::where(var_520, var_521, var_517);
                // sums += vec3(shuffle(total, c), shuffle(total, BINS + c), third)               <L 51>
                var_523 = _shuffle_1(var_28, var_508);
                var_524 = wp::add(var_409, var_508);
                var_525 = _shuffle_1(var_28, var_524);
                var_526 = wp::vec_t<3, wp::float32>(var_523, var_525, var_522);
                var_527 = wp::add(var_507, var_526);
                // third = shuffle(total, min(2 * BINS + c, 2 * HALF - 1))                        <L 48>
                var_530 = wp::mul(var_529, var_409);
                var_531 = wp::add(var_530, var_528);
                var_533 = wp::mul(var_532, var_59);
                var_535 = wp::sub(var_533, var_534);
                var_536 = wp::min(var_531, var_535);
                var_537 = _shuffle_1(var_28, var_536);
                // if c == BINS - 1:                                                              <L 49>
                var_539 = wp::sub(var_409, var_538);
                var_540 = (var_528 == var_539);
                if (var_540) {
                    // third = end                                                                <L 50>
                    var_541 = wp::copy(var_402);
                }
                var_542 = wp::where(var_540, var_541, var_537);
                // sums += vec3(shuffle(total, c), shuffle(total, BINS + c), third)               <L 51>
                var_543 = _shuffle_1(var_28, var_528);
                var_544 = wp::add(var_409, var_528);
                var_545 = _shuffle_1(var_28, var_544);
                var_546 = wp::vec_t<3, wp::float32>(var_543, var_545, var_542);
                var_547 = wp::add(var_527, var_546);
                // third = shuffle(total, min(2 * BINS + c, 2 * HALF - 1))                        <L 48>
                var_550 = wp::mul(var_549, var_409);
                var_551 = wp::add(var_550, var_548);
                var_553 = wp::mul(var_552, var_59);
                var_555 = wp::sub(var_553, var_554);
                var_556 = wp::min(var_551, var_555);
                var_557 = _shuffle_1(var_28, var_556);
                // if c == BINS - 1:                                                              <L 49>
                var_559 = wp::sub(var_409, var_558);
                var_560 = (var_548 == var_559);
                if (var_560) {
                    // third = end                                                                <L 50>
                    var_561 = wp::copy(var_402);
                }
                var_562 = wp::where(var_560, var_561, var_557);
                // sums += vec3(shuffle(total, c), shuffle(total, BINS + c), third)               <L 51>
                var_563 = _shuffle_1(var_28, var_548);
                var_564 = wp::add(var_409, var_548);
                var_565 = _shuffle_1(var_28, var_564);
                var_566 = wp::vec_t<3, wp::float32>(var_563, var_565, var_562);
                var_567 = wp::add(var_547, var_566);
                // third = shuffle(total, min(2 * BINS + c, 2 * HALF - 1))                        <L 48>
                var_570 = wp::mul(var_569, var_409);
                var_571 = wp::add(var_570, var_568);
                var_573 = wp::mul(var_572, var_59);
                var_575 = wp::sub(var_573, var_574);
                var_576 = wp::min(var_571, var_575);
                var_577 = _shuffle_1(var_28, var_576);
                // if c == BINS - 1:                                                              <L 49>
                var_579 = wp::sub(var_409, var_578);
                var_580 = (var_568 == var_579);
                if (var_580) {
                    // third = end                                                                <L 50>
                    var_581 = wp::copy(var_402);
                }
                var_582 = wp::where(var_580, var_581, var_577);
                // sums += vec3(shuffle(total, c), shuffle(total, BINS + c), third)               <L 51>
                var_583 = _shuffle_1(var_28, var_568);
                var_584 = wp::add(var_409, var_568);
                var_585 = _shuffle_1(var_28, var_584);
                var_586 = wp::vec_t<3, wp::float32>(var_583, var_585, var_582);
                var_587 = wp::add(var_567, var_586);
                // third = shuffle(total, min(2 * BINS + c, 2 * HALF - 1))                        <L 48>
                var_590 = wp::mul(var_589, var_409);
                var_591 = wp::add(var_590, var_588);
                var_593 = wp::mul(var_592, var_59);
                var_595 = wp::sub(var_593, var_594);
                var_596 = wp::min(var_591, var_595);
                var_597 = _shuffle_1(var_28, var_596);
                // if c == BINS - 1:                                                              <L 49>
                var_599 = wp::sub(var_409, var_598);
                var_600 = (var_588 == var_599);
                if (var_600) {
                    // third = end                                                                <L 50>
                    var_601 = wp::copy(var_402);
                }
                var_602 = wp::where(var_600, var_601, var_597);
                // sums += vec3(shuffle(total, c), shuffle(total, BINS + c), third)               <L 51>
                var_603 = _shuffle_1(var_28, var_588);
                var_604 = wp::add(var_409, var_588);
                var_605 = _shuffle_1(var_28, var_604);
                var_606 = wp::vec_t<3, wp::float32>(var_603, var_605, var_602);
                var_607 = wp::add(var_587, var_606);
                // third = shuffle(total, min(2 * BINS + c, 2 * HALF - 1))                        <L 48>
                var_610 = wp::mul(var_609, var_409);
                var_611 = wp::add(var_610, var_608);
                var_613 = wp::mul(var_612, var_59);
                var_615 = wp::sub(var_613, var_614);
                var_616 = wp::min(var_611, var_615);
                var_617 = _shuffle_1(var_28, var_616);
                // if c == BINS - 1:                                                              <L 49>
                var_619 = wp::sub(var_409, var_618);
                var_620 = (var_608 == var_619);
                if (var_620) {
                    // third = end                                                                <L 50>
                    var_621 = wp::copy(var_402);
                }
                var_622 = wp::where(var_620, var_621, var_617);
                // sums += vec3(shuffle(total, c), shuffle(total, BINS + c), third)               <L 51>
                var_623 = _shuffle_1(var_28, var_608);
                var_624 = wp::add(var_409, var_608);
                var_625 = _shuffle_1(var_28, var_624);
                var_626 = wp::vec_t<3, wp::float32>(var_623, var_625, var_622);
                var_627 = wp::add(var_607, var_626);
                // angle = own // BINS                                                            <L 52>
                var_628 = wp::floordiv(var_31, var_409);
                // per_angle = sums[0] if angle == 0 else sums[1] if angle == 1 else sums[2]       <L 53>
                var_630 = (var_628 == var_629);
                if (var_630) {
                    var_632 = wp::extract(var_627, var_631);
                }
                if (!var_630) {
                    var_634 = (var_628 == var_633);
                    if (var_634) {
                        var_636 = wp::extract(var_627, var_635);
                    }
                    if (!var_634) {
                        var_638 = wp::extract(var_627, var_637);
                    }
                    var_639 = wp::where(var_634, var_636, var_638);
                }
                var_640 = wp::where(var_630, var_632, var_639);
                // features[row, own] = total * scale_of(per_angle) + histograms[rank, own]       <L 54>
                var_641 = scale_of_0(var_640);
                var_642 = wp::mul(var_28, var_641);
                var_643 = wp::address(var_histograms, var_22, var_31);
                var_645 = wp::load(var_643);
                var_644 = wp::add(var_642, var_645);
                wp::array_store(var_features, var_25, var_31, var_644);
                // if own == 0:                                                                   <L 55>
                var_647 = (var_31 == var_646);
                if (var_647) {
                    // features[row, 2 * HALF] = end * scale_of(sums[2]) + histograms[rank, 2 * HALF]       <L 56>
                    var_649 = wp::extract(var_627, var_648);
                    var_650 = scale_of_0(var_649);
                    var_651 = wp::mul(var_402, var_650);
                    var_653 = wp::mul(var_652, var_59);
                    var_654 = wp::address(var_histograms, var_22, var_653);
                    var_656 = wp::load(var_654);
                    var_655 = wp::add(var_651, var_656);
                    var_658 = wp::mul(var_657, var_59);
                    wp::array_store(var_features, var_25, var_658, var_655);
                }
                goto start_for_2;
            end_for_2:;
            // sync_lanes()                                                                       <L 57>
            _sync_lanes_0();
            // sync_lanes()                                                                       <L 58>
            _sync_lanes_0();
            goto start_for_0;
        end_for_0:;
}


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


// /work/main/src/pointloom/kernels/language/warp_compiler.py:178
static CUDA_CALLABLE wp::float32 _shuffle_xor_1(
    wp::float32 x,
    wp::int32 mask)
{
return __shfl_xor_sync(0xffffffffu, x, mask);}


// /work/main/src/pointloom/kernels/arrays/lanes.py:9
static CUDA_CALLABLE wp::float32 lane_min_on_cuda_0(
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
    // def lane_min(x: float) -> float:                                                       <L 10>
    // lowest = x                                                                             <L 11>
    var_0 = wp::copy(var_x);
    // for bit in range(LANE_BITS):                                                           <L 12>
    // lowest = min(lowest, shuffle_xor(lowest, 1 << bit))                                    <L 13>
    var_3 = wp::lshift(var_2, var_1);
    var_4 = _shuffle_xor_1(var_0, var_3);
    var_5 = wp::min(var_0, var_4);
    var_8 = wp::lshift(var_7, var_6);
    var_9 = _shuffle_xor_1(var_5, var_8);
    var_10 = wp::min(var_5, var_9);
    var_13 = wp::lshift(var_12, var_11);
    var_14 = _shuffle_xor_1(var_10, var_13);
    var_15 = wp::min(var_10, var_14);
    var_18 = wp::lshift(var_17, var_16);
    var_19 = _shuffle_xor_1(var_15, var_18);
    var_20 = wp::min(var_15, var_19);
    var_23 = wp::lshift(var_22, var_21);
    var_24 = _shuffle_xor_1(var_20, var_23);
    var_25 = wp::min(var_20, var_24);
    // return lowest                                                                          <L 14>
    return var_25;
}


// /work/main/src/pointloom/kernels/arrays/lanes.py:33
static CUDA_CALLABLE wp::vec_t<3, wp::float32> lane_min_corner_on_cuda_0(
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
    // def lane_min_corner(p: vec3) -> vec3:                                                  <L 34>
    // return vec3(lane_min(p[0]), lane_min(p[1]), lane_min(p[2]))                            <L 36>
    var_1 = wp::extract(var_p, var_0);
    var_2 = lane_min_on_cuda_0(var_1);
    var_4 = wp::extract(var_p, var_3);
    var_5 = lane_min_on_cuda_0(var_4);
    var_7 = wp::extract(var_p, var_6);
    var_8 = lane_min_on_cuda_0(var_7);
    var_9 = wp::vec_t<3, wp::float32>(var_2, var_5, var_8);
    return var_9;
}


// /work/main/src/pointloom/kernels/arrays/lanes.py:17
static CUDA_CALLABLE wp::float32 lane_max_on_cuda_0(
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
    // def lane_max(x: float) -> float:                                                       <L 18>
    // highest = x                                                                            <L 19>
    var_0 = wp::copy(var_x);
    // for bit in range(LANE_BITS):                                                           <L 20>
    // highest = max(highest, shuffle_xor(highest, 1 << bit))                                 <L 21>
    var_3 = wp::lshift(var_2, var_1);
    var_4 = _shuffle_xor_1(var_0, var_3);
    var_5 = wp::max(var_0, var_4);
    var_8 = wp::lshift(var_7, var_6);
    var_9 = _shuffle_xor_1(var_5, var_8);
    var_10 = wp::max(var_5, var_9);
    var_13 = wp::lshift(var_12, var_11);
    var_14 = _shuffle_xor_1(var_10, var_13);
    var_15 = wp::max(var_10, var_14);
    var_18 = wp::lshift(var_17, var_16);
    var_19 = _shuffle_xor_1(var_15, var_18);
    var_20 = wp::max(var_15, var_19);
    var_23 = wp::lshift(var_22, var_21);
    var_24 = _shuffle_xor_1(var_20, var_23);
    var_25 = wp::max(var_20, var_24);
    // return highest                                                                         <L 22>
    return var_25;
}


// /work/main/src/pointloom/kernels/arrays/lanes.py:39
static CUDA_CALLABLE wp::vec_t<3, wp::float32> lane_max_corner_on_cuda_0(
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
    // def lane_max_corner(p: vec3) -> vec3:                                                  <L 40>
    // return vec3(lane_max(p[0]), lane_max(p[1]), lane_max(p[2]))                            <L 41>
    var_1 = wp::extract(var_p, var_0);
    var_2 = lane_max_on_cuda_0(var_1);
    var_4 = wp::extract(var_p, var_3);
    var_5 = lane_max_on_cuda_0(var_4);
    var_7 = wp::extract(var_p, var_6);
    var_8 = lane_max_on_cuda_0(var_7);
    var_9 = wp::vec_t<3, wp::float32>(var_2, var_5, var_8);
    return var_9;
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


// <pointloom.kernels.search.lane_search.guess_sqradius>:1
static CUDA_CALLABLE wp::float32 guess_sqradius_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::int32 var_bucket,
    wp::int32 var_k,
    wp::array_t<wp::float32> var_tree__boxes)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float32> var_0;
    wp::vec_t<3, wp::float32> var_1;
    const wp::int32 var_2 = 48;
    wp::int32 var_3;
    wp::int32 var_4;
    const wp::int32 var_5 = 8;
    const wp::int32 var_6 = 1;
    wp::int32 var_7;
    wp::int32 var_8;
    wp::int32 var_9;
    wp::float32* var_10;
    wp::int32 var_11;
    wp::float32* var_12;
    const wp::int32 var_13 = 2;
    wp::int32 var_14;
    wp::int32 var_15;
    wp::float32* var_16;
    wp::vec_t<3, wp::float32> var_17;
    wp::float32 var_18;
    wp::float32 var_19;
    wp::float32 var_20;
    wp::vec_t<3, wp::float32> var_21;
    const wp::int32 var_22 = 3;
    wp::int32 var_23;
    wp::int32 var_24;
    wp::float32* var_25;
    const wp::int32 var_26 = 4;
    wp::int32 var_27;
    wp::int32 var_28;
    wp::float32* var_29;
    const wp::int32 var_30 = 5;
    wp::int32 var_31;
    wp::int32 var_32;
    wp::float32* var_33;
    wp::vec_t<3, wp::float32> var_34;
    wp::float32 var_35;
    wp::float32 var_36;
    wp::float32 var_37;
    wp::vec_t<3, wp::float32> var_38;
    const wp::int32 var_39 = 0;
    wp::float32 var_40;
    const wp::int32 var_41 = 0;
    wp::float32 var_42;
    wp::float32 var_43;
    const wp::int32 var_44 = 0;
    wp::float32 var_45;
    const wp::int32 var_46 = 0;
    wp::float32 var_47;
    wp::float32 var_48;
    wp::float32 var_49;
    const wp::float32 var_50 = 0.0;
    wp::float32 var_51;
    const wp::int32 var_52 = 1;
    wp::float32 var_53;
    const wp::int32 var_54 = 1;
    wp::float32 var_55;
    wp::float32 var_56;
    const wp::int32 var_57 = 1;
    wp::float32 var_58;
    const wp::int32 var_59 = 1;
    wp::float32 var_60;
    wp::float32 var_61;
    wp::float32 var_62;
    const wp::float32 var_63 = 0.0;
    wp::float32 var_64;
    const wp::int32 var_65 = 2;
    wp::float32 var_66;
    const wp::int32 var_67 = 2;
    wp::float32 var_68;
    wp::float32 var_69;
    const wp::int32 var_70 = 2;
    wp::float32 var_71;
    const wp::int32 var_72 = 2;
    wp::float32 var_73;
    wp::float32 var_74;
    wp::float32 var_75;
    const wp::float32 var_76 = 0.0;
    wp::float32 var_77;
    wp::float32 var_78;
    const wp::float32 var_79 = 0.0025;
    wp::float32 var_80;
    wp::float32 var_81;
    wp::float32 var_82;
    wp::float32 var_83;
    wp::float32 var_84;
    wp::float32 var_85;
    wp::float32 var_86;
    wp::float32 var_87;
    wp::float32 var_88;
    wp::float32 var_89;
    wp::float32 var_90;
    wp::float32 var_91;
    //---------
    // forward
    // def guess_sqradius(p, bucket, k, tree__boxes):                                         <L 1>
    // a = lane_min_corner(p)                                                                 <L 3>
    var_0 = lane_min_corner_on_cuda_0(var_p);
    // b = lane_max_corner(p)                                                                 <L 4>
    var_1 = lane_max_corner_on_cuda_0(var_p);
    // at = bucket * SIDES + (lane() & FAN - 1)                                               <L 5>
    var_3 = wp::mul(var_bucket, var_2);
    var_4 = _lane_0();
    var_7 = wp::sub(var_5, var_6);
    var_8 = wp::bit_and(var_4, var_7);
    var_9 = wp::add(var_3, var_8);
    // low = lane_min_corner(vec3(tree__boxes[at], tree__boxes[at + FAN], tree__boxes[at + 2 * FAN]))       <L 6>
    var_10 = wp::address(var_tree__boxes, var_9);
    var_11 = wp::add(var_9, var_5);
    var_12 = wp::address(var_tree__boxes, var_11);
    var_14 = wp::mul(var_13, var_5);
    var_15 = wp::add(var_9, var_14);
    var_16 = wp::address(var_tree__boxes, var_15);
    var_18 = wp::load(var_10);
    var_19 = wp::load(var_12);
    var_20 = wp::load(var_16);
    var_17 = wp::vec_t<3, wp::float32>(var_18, var_19, var_20);
    var_21 = lane_min_corner_on_cuda_0(var_17);
    // high = lane_max_corner(vec3(tree__boxes[at + 3 * FAN], tree__boxes[at + 4 * FAN], tree__boxes[at + 5 * FAN]))       <L 7>
    var_23 = wp::mul(var_22, var_5);
    var_24 = wp::add(var_9, var_23);
    var_25 = wp::address(var_tree__boxes, var_24);
    var_27 = wp::mul(var_26, var_5);
    var_28 = wp::add(var_9, var_27);
    var_29 = wp::address(var_tree__boxes, var_28);
    var_31 = wp::mul(var_30, var_5);
    var_32 = wp::add(var_9, var_31);
    var_33 = wp::address(var_tree__boxes, var_32);
    var_35 = wp::load(var_25);
    var_36 = wp::load(var_29);
    var_37 = wp::load(var_33);
    var_34 = wp::vec_t<3, wp::float32>(var_35, var_36, var_37);
    var_38 = lane_max_corner_on_cuda_0(var_34);
    // x = larger(larger(low[0] - b[0], a[0] - high[0]), 0.0)                                 <L 8>
    var_40 = wp::extract(var_21, var_39);
    var_42 = wp::extract(var_1, var_41);
    var_43 = wp::sub(var_40, var_42);
    var_45 = wp::extract(var_0, var_44);
    var_47 = wp::extract(var_38, var_46);
    var_48 = wp::sub(var_45, var_47);
    var_49 = larger_0(var_43, var_48);
    var_51 = larger_0(var_49, var_50);
    // y = larger(larger(low[1] - b[1], a[1] - high[1]), 0.0)                                 <L 9>
    var_53 = wp::extract(var_21, var_52);
    var_55 = wp::extract(var_1, var_54);
    var_56 = wp::sub(var_53, var_55);
    var_58 = wp::extract(var_0, var_57);
    var_60 = wp::extract(var_38, var_59);
    var_61 = wp::sub(var_58, var_60);
    var_62 = larger_0(var_56, var_61);
    var_64 = larger_0(var_62, var_63);
    // z = larger(larger(low[2] - b[2], a[2] - high[2]), 0.0)                                 <L 10>
    var_66 = wp::extract(var_21, var_65);
    var_68 = wp::extract(var_1, var_67);
    var_69 = wp::sub(var_66, var_68);
    var_71 = wp::extract(var_0, var_70);
    var_73 = wp::extract(var_38, var_72);
    var_74 = wp::sub(var_71, var_73);
    var_75 = larger_0(var_69, var_74);
    var_77 = larger_0(var_75, var_76);
    // near = sqrt(square_distance(low, high) * (SURFACE * float(k))) + sqrt(x * x + y * y + z * z)       <L 11>
    var_78 = square_distance_0(var_21, var_38);
    var_80 = wp::float(var_k);
    var_81 = wp::mul(var_79, var_80);
    var_82 = wp::mul(var_78, var_81);
    var_83 = wp::sqrt(var_82);
    var_84 = wp::mul(var_51, var_51);
    var_85 = wp::mul(var_64, var_64);
    var_86 = wp::add(var_84, var_85);
    var_87 = wp::mul(var_77, var_77);
    var_88 = wp::add(var_86, var_87);
    var_89 = wp::sqrt(var_88);
    var_90 = wp::add(var_83, var_89);
    // return near * near                                                                     <L 12>
    var_91 = wp::mul(var_90, var_90);
    return var_91;
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


// <pointloom.kernels.search.lane_search.keep_for_lanes>:1
static CUDA_CALLABLE wp::vec_t<3, wp::float32> keep_for_lanes_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::int32 var_start,
    wp::float32 var_guess,
    wp::int32 var_tree__count,
    wp::int32 var_tree__root,
    wp::array_t<wp::int32> var_tree__levels,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> var_tree__points,
    wp::array_t<wp::int32> var_scratch__ids,
    wp::array_t<wp::int64> var_scratch__keys,
    wp::int32 var_scratch__k,
    wp::int32 var_scratch__room,
    wp::int32 var_scratch__gather,
    wp::int32 var_scratch__stride,
    wp::int32 var_listing,
    wp::int32 var_base,
    wp::float32 var_max_sqdist)
{
    //---------
    // primal vars
    wp::float32 var_0;
    const wp::float32 var_1 = 0.0;
    bool var_2;
    wp::float32 var_3;
    wp::float32 var_4;
    wp::float32 var_5;
    const wp::float32 var_6 = INFINITY;
    wp::float32 var_7;
    const wp::int32 var_8 = 0;
    wp::int32 var_9;
    const wp::int32 var_10 = 0;
    wp::int32 var_11;
    const wp::int32 var_12 = 0;
    wp::int32 var_13;
    const wp::int32 var_14 = 12;
    bool var_15;
    wp::int32 var_16;
    const wp::int32 var_17 = 1;
    wp::int32 var_18;
    bool var_19;
    wp::float32 var_20;
    const wp::float32 var_21 = 0.25;
    wp::float32 var_22;
    wp::int32 var_23;
    wp::float32 var_24;
    wp::float32 var_25;
    bool var_26;
    wp::float32 var_27;
    bool var_28;
    bool var_29;
    bool var_30;
    const wp::int32 var_31 = 1;
    wp::int32 var_32;
    const wp::float32 var_33 = 1.5;
    wp::float32 var_34;
    wp::float32 var_35;
    const wp::float32 var_36 = 1.0;
    wp::float32 var_37;
    wp::float32 var_38;
    const wp::float32 var_39 = 8.0;
    wp::float32 var_40;
    wp::float32 var_41;
    const wp::int32 var_42 = 8;
    wp::int32 var_43;
    bool var_44;
    wp::float32 var_45;
    wp::float32 var_46;
    const wp::float32 var_47 = 0.5;
    wp::float32 var_48;
    wp::float32 var_49;
    wp::float32 var_50;
    const wp::float32 var_51 = 1e-37;
    wp::float32 var_52;
    wp::float32 var_53;
    wp::float32 var_54;
    wp::int32 var_55;
    wp::float32 var_56;
    wp::float32 var_57;
    wp::int32 var_58;
    wp::int32 var_59;
    wp::float32 var_60;
    wp::float32 var_61;
    wp::vec_t<3, wp::float32> var_62;
    //---------
    // forward
    // def keep_for_lanes(p, start, guess, tree__count, tree__root, tree__levels, tree__boxes, tree__points, scratch__ids, scratch__keys, scratch__k, scratch__room, scratch__gather, scratch__stride, listing, base, max_sqdist):       <L 1>
    // covered = guess                                                                        <L 3>
    var_0 = wp::copy(var_guess);
    // if guess < 0.0:                                                                        <L 4>
    var_2 = (var_guess < var_1);
    if (var_2) {
        // covered = guess_sqradius(p, start, scratch__k, tree__boxes)                        <L 5>
        var_3 = guess_sqradius_on_cuda_0(var_p, var_start, var_scratch__k, var_tree__boxes);
    }
    var_4 = wp::where(var_2, var_3, var_0);
    // covered = min(covered, max_sqdist)                                                     <L 6>
    var_5 = wp::min(var_4, var_max_sqdist);
    // beyond = float(INFINITY)                                                               <L 7>
    var_7 = wp::float(var_6);
    // listed = int(0)                                                                        <L 8>
    var_9 = wp::int(var_8);
    // count = int(0)                                                                         <L 9>
    var_11 = wp::int(var_10);
    // attempt = int(0)                                                                       <L 10>
    var_13 = wp::int(var_12);
    // while attempt < MAX_ATTEMPTS:                                                          <L 11>
    start_while_0:;
    var_15 = (var_13 < var_14);
    if ((var_15) == false) goto end_while_0;
        // listed = list_leaves(p, covered, start, tree__root, tree__levels, tree__boxes, scratch__ids, scratch__gather, listing)       <L 12>
        var_16 = list_leaves_on_cuda_0(var_p, var_5, var_start, var_tree__root, var_tree__levels, var_tree__boxes, var_scratch__ids, var_scratch__gather, var_listing);
        // attempt += 1                                                                       <L 13>
        var_18 = wp::add(var_13, var_17);
        // if listed > scratch__gather:                                                       <L 14>
        var_19 = (var_16 > var_scratch__gather);
        if (var_19) {
            // beyond = covered                                                               <L 15>
            var_20 = wp::copy(var_5);
            // covered = covered * SHRUNK                                                     <L 16>
            var_22 = wp::mul(var_5, var_21);
        }
        if (!var_19) {
            // count = keep_near(p, covered, tree__points, scratch__ids, scratch__keys, scratch__room, scratch__stride, listing, listed, base)       <L 18>
            var_23 = keep_near_on_cuda_0(var_p, var_5, var_tree__points, var_scratch__ids, var_scratch__keys, var_scratch__room, var_scratch__stride, var_listing, var_16, var_base);
            // min_count = lane_min(float(count))                                             <L 19>
            var_24 = wp::float(var_23);
            var_25 = lane_min_on_cuda_0(var_24);
            // if min_count >= float(scratch__k) or covered >= max_sqdist or attempt >= MAX_ATTEMPTS:       <L 20>
            var_27 = wp::float(var_scratch__k);
            var_28 = (var_25 >= var_27);
            var_26 = var_28;
            if (!var_26) {
                var_29 = (var_5 >= var_max_sqdist);
                var_26 = var_26 || var_29;
            }
            if (!var_26) {
                var_30 = (var_18 >= var_14);
                var_26 = var_26 || var_30;
            }
            if (var_26) {
                // attempt = MAX_ATTEMPTS + 1                                                 <L 21>
                var_32 = wp::add(var_14, var_31);
            }
            if (!var_26) {
                // grown = covered * min(SPARE * float(scratch__k) / max(min_count, 1.0), MAX_GROWTH)       <L 23>
                var_34 = wp::float(var_scratch__k);
                var_35 = wp::mul(var_33, var_34);
                var_37 = wp::max(var_25, var_36);
                var_38 = wp::div(var_35, var_37);
                var_40 = wp::min(var_38, var_39);
                var_41 = wp::mul(var_5, var_40);
                // if listed * LEAF >= tree__count:                                           <L 24>
                var_43 = wp::mul(var_16, var_42);
                var_44 = (var_43 >= var_tree__count);
                if (var_44) {
                    // grown = max_sqdist                                                     <L 25>
                    var_45 = wp::copy(var_max_sqdist);
                }
                var_46 = wp::where(var_44, var_45, var_41);
                // covered = min(min(max_sqdist, 0.5 * (covered + beyond)), max(grown, TINY))       <L 26>
                var_48 = wp::add(var_5, var_7);
                var_49 = wp::mul(var_47, var_48);
                var_50 = wp::min(var_max_sqdist, var_49);
                var_52 = wp::max(var_46, var_51);
                var_53 = wp::min(var_50, var_52);
            }
            var_54 = wp::where(var_26, var_5, var_53);
            var_55 = wp::where(var_26, var_32, var_18);
        }
        var_56 = wp::where(var_19, var_22, var_54);
        var_57 = wp::where(var_19, var_20, var_7);
        var_58 = wp::where(var_19, var_11, var_23);
        var_59 = wp::where(var_19, var_18, var_55);
        wp::assign(var_5, var_56);
        wp::assign(var_7, var_57);
        wp::assign(var_9, var_16);
        wp::assign(var_11, var_58);
        wp::assign(var_13, var_59);
    goto start_while_0;
    end_while_0:;
    // return vec3(covered, float(listed), float(count))                                      <L 27>
    var_60 = wp::float(var_9);
    var_61 = wp::float(var_11);
    var_62 = wp::vec_t<3, wp::float32>(var_5, var_60, var_61);
    return var_62;
}


// <pointloom.kernels.search.lane_search.keep_nearer>:1
static CUDA_CALLABLE wp::vec_t<2, wp::float32> keep_nearer_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::float32 var_max_sqdist,
    wp::int32 var_near_count,
    wp::array_t<wp::vec_t<3, wp::float32>> var_tree__points,
    wp::array_t<wp::int32> var_scratch__ids,
    wp::array_t<wp::int64> var_scratch__keys,
    wp::int32 var_scratch__k,
    wp::int32 var_scratch__room,
    wp::int32 var_scratch__stride,
    wp::int32 var_listing,
    wp::int32 var_size,
    wp::int32 var_base)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 0.0;
    wp::float32 var_1;
    wp::float32 var_2;
    wp::int32 var_3;
    const wp::int32 var_4 = 8;
    wp::int32 var_5;
    wp::int32 var_6;
    const wp::int32 var_7 = 2;
    wp::int32 var_8;
    const wp::int32 var_9 = 0;
    wp::int32 var_10;
    bool var_11;
    bool var_12;
    const wp::int32 var_13 = 2;
    const wp::int32 var_14 = 6;
    wp::int32 var_15;
    bool var_16;
    wp::float32 var_17;
    wp::float32 var_18;
    wp::float32 var_19;
    wp::float32 var_20;
    wp::float32 var_21;
    wp::float32 var_22;
    bool var_23;
    wp::float32 var_24;
    const wp::float32 var_25 = 0.5;
    wp::float32 var_26;
    wp::float32 var_27;
    wp::float32 var_28;
    wp::int32 var_29;
    bool var_30;
    wp::float32 var_31;
    wp::float32 var_32;
    wp::int32 var_33;
    wp::float32 var_34;
    wp::float32 var_35;
    wp::int32 var_36;
    const wp::int32 var_37 = 1;
    wp::int32 var_38;
    bool var_39;
    const wp::float32 var_40 = -1.0;
    wp::float32 var_41;
    wp::float32 var_42;
    wp::vec_t<2, wp::float32> var_43;
    //---------
    // forward
    // def keep_nearer(p, max_sqdist, near_count, tree__points, scratch__ids, scratch__keys, scratch__k, scratch__room, scratch__stride, listing, size, base):       <L 1>
    // low = float(0.0)                                                                       <L 3>
    var_1 = wp::float(var_0);
    // high = max_sqdist                                                                      <L 4>
    var_2 = wp::copy(var_max_sqdist);
    // above = int(near_count)                                                                <L 5>
    var_3 = wp::int(var_near_count);
    // capacity = scratch__room - LEAF                                                        <L 6>
    var_5 = wp::sub(var_scratch__room, var_4);
    // middle = (scratch__k + capacity) // 2                                                  <L 7>
    var_6 = wp::add(var_scratch__k, var_5);
    var_8 = wp::floordiv(var_6, var_7);
    // iteration = int(0)                                                                     <L 8>
    var_10 = wp::int(var_9);
    // while above > capacity and iteration < 2 * GUESSES:                                    <L 9>
    start_while_0:;
    var_12 = (var_3 > var_5);
    var_11 = var_12;
    if (var_11) {
        var_15 = wp::mul(var_13, var_14);
        var_16 = (var_10 < var_15);
        var_11 = var_11 && var_16;
    }
    if ((var_11) == false) goto end_while_0;
        // guess = low + (high - low) * (float(middle) / float(above))                        <L 10>
        var_17 = wp::sub(var_2, var_1);
        var_18 = wp::float(var_8);
        var_19 = wp::float(var_3);
        var_20 = wp::div(var_18, var_19);
        var_21 = wp::mul(var_17, var_20);
        var_22 = wp::add(var_1, var_21);
        // if iteration >= GUESSES:                                                           <L 11>
        var_23 = (var_10 >= var_14);
        if (var_23) {
            // guess = low + (high - low) * 0.5                                               <L 12>
            var_24 = wp::sub(var_2, var_1);
            var_26 = wp::mul(var_24, var_25);
            var_27 = wp::add(var_1, var_26);
        }
        var_28 = wp::where(var_23, var_27, var_22);
        // count = keep_near(p, guess, tree__points, scratch__ids, scratch__keys, scratch__room, scratch__stride, listing, size, base)       <L 13>
        var_29 = keep_near_on_cuda_0(var_p, var_28, var_tree__points, var_scratch__ids, var_scratch__keys, var_scratch__room, var_scratch__stride, var_listing, var_size, var_base);
        // if count < scratch__k:                                                             <L 14>
        var_30 = (var_29 < var_scratch__k);
        if (var_30) {
            // low = guess                                                                    <L 15>
            var_31 = wp::copy(var_28);
        }
        if (!var_30) {
            // high = guess                                                                   <L 17>
            var_32 = wp::copy(var_28);
            // above = count                                                                  <L 18>
            var_33 = wp::copy(var_29);
        }
        var_34 = wp::where(var_30, var_31, var_1);
        var_35 = wp::where(var_30, var_2, var_32);
        var_36 = wp::where(var_30, var_3, var_33);
        // iteration += 1                                                                     <L 19>
        var_38 = wp::add(var_10, var_37);
        wp::assign(var_1, var_34);
        wp::assign(var_2, var_35);
        wp::assign(var_3, var_36);
        wp::assign(var_10, var_38);
    goto start_while_0;
    end_while_0:;
    // return vec2(high if above <= capacity else -1.0, float(above))                         <L 20>
    var_39 = (var_3 <= var_5);
    if (var_39) {
    }
    if (!var_39) {
    }
    var_41 = wp::where(var_39, var_2, var_40);
    var_42 = wp::float(var_3);
    var_43 = wp::vec_t<2, wp::float32>(var_41, var_42);
    return var_43;
}


// <pointloom.kernels.arrays.packed_keys.key_limit>:1
static CUDA_CALLABLE wp::int64 key_limit_0(
    wp::float32 var_number)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int64 var_1;
    wp::int64 var_2;
    wp::int64 var_3;
    wp::int64 var_4;
    wp::int64 var_5;
    wp::int64 var_6;
    wp::int64 var_7;
    //---------
    // forward
    // def key_limit(number):                                                                 <L 1>
    // return (int64(float_bits(number)) + int64(1) << int64(32)) - int64(1)                  <L 2>
    var_0 = _float_bits_0(var_number);
    var_1 = wp::int64(var_0);
    var_2 = 1ll;
    var_3 = wp::add(var_1, var_2);
    var_4 = 32ll;
    var_5 = wp::lshift(var_3, var_4);
    var_6 = 1ll;
    var_7 = wp::sub(var_5, var_6);
    return var_7;
}


// <pointloom.kernels.search.point_tree.is_one_point>:1
static CUDA_CALLABLE wp::int32 is_one_point_0(
    wp::array_t<wp::float32> var_boxes,
    wp::int32 var_node,
    wp::int32 var_child)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 48;
    wp::int32 var_1;
    wp::int32 var_2;
    const wp::int32 var_3 = 1;
    wp::int32 var_4;
    const wp::int32 var_5 = 0;
    const wp::int32 var_6 = 8;
    wp::int32 var_7;
    wp::int32 var_8;
    wp::float32* var_9;
    const wp::int32 var_10 = 3;
    wp::int32 var_11;
    wp::int32 var_12;
    wp::int32 var_13;
    wp::float32* var_14;
    bool var_15;
    wp::float32 var_16;
    wp::float32 var_17;
    const wp::int32 var_18 = 0;
    wp::int32 var_19;
    const wp::int32 var_20 = 1;
    wp::int32 var_21;
    wp::int32 var_22;
    wp::float32* var_23;
    const wp::int32 var_24 = 3;
    wp::int32 var_25;
    wp::int32 var_26;
    wp::int32 var_27;
    wp::float32* var_28;
    bool var_29;
    wp::float32 var_30;
    wp::float32 var_31;
    const wp::int32 var_32 = 0;
    wp::int32 var_33;
    const wp::int32 var_34 = 2;
    wp::int32 var_35;
    wp::int32 var_36;
    wp::float32* var_37;
    const wp::int32 var_38 = 3;
    wp::int32 var_39;
    wp::int32 var_40;
    wp::int32 var_41;
    wp::float32* var_42;
    bool var_43;
    wp::float32 var_44;
    wp::float32 var_45;
    const wp::int32 var_46 = 0;
    wp::int32 var_47;
    //---------
    // forward
    // def is_one_point(boxes, node, child):                                                  <L 1>
    // at = node * SIDES + child                                                              <L 2>
    var_1 = wp::mul(var_node, var_0);
    var_2 = wp::add(var_1, var_child);
    // equal = int(1)                                                                         <L 3>
    var_4 = wp::int(var_3);
    // for axis in range(3):                                                                  <L 4>
    // if boxes[at + axis * FAN] != boxes[at + (axis + 3) * FAN]:                             <L 5>
    var_7 = wp::mul(var_5, var_6);
    var_8 = wp::add(var_2, var_7);
    var_9 = wp::address(var_boxes, var_8);
    var_11 = wp::add(var_5, var_10);
    var_12 = wp::mul(var_11, var_6);
    var_13 = wp::add(var_2, var_12);
    var_14 = wp::address(var_boxes, var_13);
    var_16 = wp::load(var_9);
    var_17 = wp::load(var_14);
    var_15 = (var_16 != var_17);
    if (var_15) {
        // equal = 0                                                                          <L 6>
    }
    var_19 = wp::where(var_15, var_18, var_4);
    // if boxes[at + axis * FAN] != boxes[at + (axis + 3) * FAN]:                             <L 5>
    var_21 = wp::mul(var_20, var_6);
    var_22 = wp::add(var_2, var_21);
    var_23 = wp::address(var_boxes, var_22);
    var_25 = wp::add(var_20, var_24);
    var_26 = wp::mul(var_25, var_6);
    var_27 = wp::add(var_2, var_26);
    var_28 = wp::address(var_boxes, var_27);
    var_30 = wp::load(var_23);
    var_31 = wp::load(var_28);
    var_29 = (var_30 != var_31);
    if (var_29) {
        // equal = 0                                                                          <L 6>
    }
    var_33 = wp::where(var_29, var_32, var_19);
    // if boxes[at + axis * FAN] != boxes[at + (axis + 3) * FAN]:                             <L 5>
    var_35 = wp::mul(var_34, var_6);
    var_36 = wp::add(var_2, var_35);
    var_37 = wp::address(var_boxes, var_36);
    var_39 = wp::add(var_34, var_38);
    var_40 = wp::mul(var_39, var_6);
    var_41 = wp::add(var_2, var_40);
    var_42 = wp::address(var_boxes, var_41);
    var_44 = wp::load(var_37);
    var_45 = wp::load(var_42);
    var_43 = (var_44 != var_45);
    if (var_43) {
        // equal = 0                                                                          <L 6>
    }
    var_47 = wp::where(var_43, var_46, var_33);
    // return equal                                                                           <L 7>
    return var_47;
}


// <pointloom.kernels.search.k_nearest.offer_leaves_one_by_one>:1
static CUDA_CALLABLE wp::int32 offer_leaves_one_by_one_on_cuda_0(
    wp::int32 var_bucket,
    wp::vec_t<3, wp::float32> var_p,
    wp::int32 var_tree__count,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> var_tree__points,
    wp::array_t<wp::int32> var_labels,
    wp::array_t<wp::int64> var_keys,
    wp::int32 var_base,
    wp::int32 var_stride,
    wp::int32 var_key_count,
    wp::float32 var_max_sqdist,
    wp::int64 var_limit)
{
    //---------
    // primal vars
    wp::int32 var_0;
    const wp::int32 var_1 = 8;
    wp::int32 var_2;
    wp::range_t var_3;
    wp::int32 var_4;
    const wp::int32 var_5 = 64;
    wp::int32 var_6;
    const wp::int32 var_7 = 8;
    wp::int32 var_8;
    wp::int32 var_9;
    const wp::int32 var_10 = 0;
    wp::int32 var_11;
    bool var_12;
    wp::float32 var_13;
    bool var_14;
    const wp::int32 var_15 = 1;
    wp::int32 var_16;
    wp::int32* var_17;
    wp::int64 var_18;
    wp::int32 var_19;
    bool var_20;
    const wp::int32 var_21 = 1;
    wp::int32 var_22;
    wp::int32 var_23;
    wp::int32 var_24;
    wp::int32 var_25;
    wp::int32 var_26;
    const wp::int32 var_27 = 1;
    bool var_28;
    wp::int32 var_29;
    wp::int32 var_30;
    wp::range_t var_31;
    wp::int32 var_32;
    wp::vec_t<3, wp::float32>* var_33;
    wp::float32 var_34;
    wp::vec_t<3, wp::float32> var_35;
    wp::int32* var_36;
    wp::int64 var_37;
    wp::int32 var_38;
    bool var_39;
    wp::int32 var_40;
    wp::int32 var_41;
    const wp::int32 var_42 = 1;
    wp::int32 var_43;
    wp::int32 var_44;
    //---------
    // forward
    // def offer_leaves_one_by_one(bucket, p, tree__count, tree__boxes, tree__points, labels, keys, base, stride, key_count, max_sqdist, limit):       <L 1>
    // size = key_count                                                                       <L 3>
    var_0 = wp::copy(var_key_count);
    // leaves = int(FAN)                                                                      <L 4>
    var_2 = wp::int(var_1);
    // for leaf in range(leaves):                                                             <L 5>
    var_3 = wp::range(var_2);
    start_for_0:;
        if (iter_cmp(var_3) == 0) goto end_for_0;
        var_4 = wp::iter_next(var_3);
        // first = bucket * BUCKET + leaf * LEAF                                              <L 6>
        var_6 = wp::mul(var_bucket, var_5);
        var_8 = wp::mul(var_4, var_7);
        var_9 = wp::add(var_6, var_8);
        // wanted = int(0)                                                                    <L 7>
        var_11 = wp::int(var_10);
        // if first < tree__count:                                                            <L 8>
        var_12 = (var_9 < var_tree__count);
        if (var_12) {
            // sqdist = measure_box(tree__boxes, bucket, leaf, p, p)                          <L 9>
            var_13 = measure_box_0(var_tree__boxes, var_bucket, var_4, var_p, var_p);
            // if sqdist <= max_sqdist:                                                       <L 10>
            var_14 = (var_13 <= var_max_sqdist);
            if (var_14) {
                // wanted = int(1)                                                            <L 11>
                var_16 = wp::int(var_15);
                // if pack_key(sqdist, labels[first]) > limit:                                <L 12>
                var_17 = wp::address(var_labels, var_9);
                var_19 = wp::load(var_17);
                var_18 = pack_key_0(var_13, var_19);
                var_20 = (var_18 > var_limit);
                if (var_20) {
                    // wanted = 1 - is_one_point(tree__boxes, bucket, leaf)                   <L 13>
                    var_22 = is_one_point_0(var_tree__boxes, var_bucket, var_4);
                    var_23 = wp::sub(var_21, var_22);
                }
                var_24 = wp::where(var_20, var_23, var_16);
            }
            var_25 = wp::where(var_14, var_24, var_11);
        }
        var_26 = wp::where(var_12, var_25, var_11);
        // if wanted == 1:                                                                    <L 14>
        var_28 = (var_26 == var_27);
        if (var_28) {
            // for j in range(first, min(first + LEAF, tree__count)):                         <L 15>
            var_29 = wp::add(var_9, var_7);
            var_30 = wp::min(var_29, var_tree__count);
            var_31 = wp::range(var_9, var_30);
            start_for_2:;
                if (iter_cmp(var_31) == 0) goto end_for_2;
                var_32 = wp::iter_next(var_31);
                // key = pack_key(square_distance(p, tree__points[j]), labels[j])             <L 16>
                var_33 = wp::address(var_tree__points, var_32);
                var_35 = wp::load(var_33);
                var_34 = square_distance_0(var_p, var_35);
                var_36 = wp::address(var_labels, var_32);
                var_38 = wp::load(var_36);
                var_37 = pack_key_0(var_34, var_38);
                // if key <= limit:                                                           <L 17>
                var_39 = (var_37 <= var_limit);
                if (var_39) {
                    // keys[base + size * stride] = key                                       <L 18>
                    var_40 = wp::mul(var_0, var_stride);
                    var_41 = wp::add(var_base, var_40);
                    wp::array_store(var_keys, var_41, var_37);
                    // size += 1                                                              <L 19>
                    var_43 = wp::add(var_0, var_42);
                }
                var_44 = wp::where(var_39, var_43, var_0);
                wp::assign(var_0, var_44);
                goto start_for_2;
            end_for_2:;
        }
        goto start_for_0;
    end_for_0:;
    // return size                                                                            <L 20>
    return var_0;
}


// <pointloom.kernels.search.bucket_walk.pass_over_equal_one_by_one>:1
static CUDA_CALLABLE wp::vec_t<4, wp::int64> pass_over_equal_one_by_one_on_cuda_0(
    wp::vec_t<4, wp::int64> var_step,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::int64 var_limit,
    wp::array_t<wp::int32> var_tree__levels,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::array_t<wp::int32> var_labels)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 3;
    wp::int64 var_1;
    const wp::int32 var_2 = 2;
    wp::int64 var_3;
    wp::int32 var_4;
    const wp::int32 var_5 = 1;
    wp::int32 var_6;
    const wp::int32 var_7 = 8;
    wp::int32 var_8;
    const wp::int32 var_9 = 0;
    wp::int64 var_10;
    wp::int32 var_11;
    wp::range_t var_12;
    wp::int32 var_13;
    wp::int32 var_14;
    const wp::int32 var_15 = 1;
    wp::int32 var_16;
    wp::int64 var_17;
    wp::int64 var_18;
    wp::int32 var_19;
    const wp::int32 var_20 = 255;
    wp::int32 var_21;
    const wp::int32 var_22 = 1;
    wp::int32 var_23;
    wp::int32* var_24;
    wp::int32 var_25;
    wp::int32 var_26;
    wp::range_t var_27;
    wp::int32 var_28;
    wp::int32 var_29;
    const wp::int32 var_30 = 1;
    wp::int32 var_31;
    const wp::int32 var_32 = 1;
    bool var_33;
    wp::int32 var_34;
    wp::int32 var_35;
    wp::int32 var_36;
    const wp::int32 var_37 = 64;
    wp::int32 var_38;
    bool var_39;
    wp::int32 var_40;
    const wp::int32 var_41 = 1;
    bool var_42;
    wp::shape_t* var_43;
    const wp::int32 var_44 = 0;
    wp::int32 var_45;
    wp::shape_t var_46;
    bool var_47;
    wp::float32 var_48;
    wp::int32* var_49;
    wp::int64 var_50;
    wp::int32 var_51;
    bool var_52;
    const wp::int32 var_53 = 1;
    wp::int32 var_54;
    wp::int64 var_55;
    const wp::int32 var_56 = 1;
    wp::int32 var_57;
    wp::int64 var_58;
    wp::int64 var_59;
    wp::int64 var_60;
    wp::int64 var_61;
    wp::int64 var_62;
    wp::int64 var_63;
    wp::int32 var_64;
    const wp::int32 var_65 = 0;
    wp::int64 var_66;
    const wp::int32 var_67 = 1;
    wp::int64 var_68;
    const wp::int32 var_69 = 2;
    wp::int64 var_70;
    wp::vec_t<4, wp::int64> var_71;
    //---------
    // forward
    // def pass_over_equal_one_by_one(step, a, b, limit, tree__levels, tree__boxes, labels):       <L 1>
    // pending = step[3]                                                                      <L 2>
    var_1 = wp::extract(var_step, var_0);
    // node = int(step[2])                                                                    <L 3>
    var_3 = wp::extract(var_step, var_2);
    var_4 = wp::int(var_3);
    // buckets = int(1)                                                                       <L 4>
    var_6 = wp::int(var_5);
    // children = int(FAN)                                                                    <L 5>
    var_8 = wp::int(var_7);
    // for above in range(int(step[0])):                                                      <L 6>
    var_10 = wp::extract(var_step, var_9);
    var_11 = wp::int(var_10);
    var_12 = wp::range(var_11);
    start_for_0:;
        if (iter_cmp(var_12) == 0) goto end_for_0;
        var_13 = wp::iter_next(var_12);
        // node = node // FAN                                                                 <L 7>
        var_14 = wp::floordiv(var_4, var_7);
        // left = int(pending >> byte_shift(above + 1)) & BYTE                                <L 8>
        var_16 = wp::add(var_13, var_15);
        var_17 = byte_shift_0(var_16);
        var_18 = wp::rshift(var_1, var_17);
        var_19 = wp::int(var_18);
        var_21 = wp::bit_and(var_19, var_20);
        // record = tree__levels[above + 1] + node                                            <L 9>
        var_23 = wp::add(var_13, var_22);
        var_24 = wp::address(var_tree__levels, var_23);
        var_26 = wp::load(var_24);
        var_25 = wp::add(var_26, var_14);
        // for j in range(children):                                                          <L 10>
        var_27 = wp::range(var_8);
        start_for_2:;
            if (iter_cmp(var_27) == 0) goto end_for_2;
            var_28 = wp::iter_next(var_27);
            // if left >> j & 1 == 1:                                                         <L 11>
            var_29 = wp::rshift(var_21, var_28);
            var_31 = wp::bit_and(var_29, var_30);
            var_33 = (var_31 == var_32);
            if (var_33) {
                // first = (node * FAN + j) * buckets * BUCKET                                <L 12>
                var_34 = wp::mul(var_14, var_7);
                var_35 = wp::add(var_34, var_28);
                var_36 = wp::mul(var_35, var_6);
                var_38 = wp::mul(var_36, var_37);
                // if is_one_point(tree__boxes, record, j) == 1 and first < labels.shape[0]:       <L 13>
                var_40 = is_one_point_0(var_tree__boxes, var_25, var_28);
                var_42 = (var_40 == var_41);
                var_39 = var_42;
                if (var_39) {
                    var_43 = &(var_labels.shape);
                    var_46 = wp::load(var_43);
                    var_45 = wp::extract(var_46, var_44);
                    var_47 = (var_38 < var_45);
                    var_39 = var_39 && var_47;
                }
                if (var_39) {
                    // if pack_key(measure_box(tree__boxes, record, j, a, b), labels[first]) > limit:       <L 14>
                    var_48 = measure_box_0(var_tree__boxes, var_25, var_28, var_a, var_b);
                    var_49 = wp::address(var_labels, var_38);
                    var_51 = wp::load(var_49);
                    var_50 = pack_key_0(var_48, var_51);
                    var_52 = (var_50 > var_limit);
                    if (var_52) {
                        // pending = pending ^ int64(1 << j) << byte_shift(above + 1)         <L 15>
                        var_54 = wp::lshift(var_53, var_28);
                        var_55 = wp::int64(var_54);
                        var_57 = wp::add(var_13, var_56);
                        var_58 = byte_shift_0(var_57);
                        var_59 = wp::lshift(var_55, var_58);
                        var_60 = wp::bit_xor(var_1, var_59);
                    }
                    var_61 = wp::where(var_52, var_60, var_1);
                }
                var_62 = wp::where(var_39, var_61, var_1);
            }
            var_63 = wp::where(var_33, var_62, var_1);
            wp::assign(var_1, var_63);
            goto start_for_2;
        end_for_2:;
        // buckets = buckets * FAN                                                            <L 16>
        var_64 = wp::mul(var_6, var_7);
        wp::assign(var_4, var_14);
        wp::assign(var_6, var_64);
        goto start_for_0;
    end_for_0:;
    // return traversal(step[0], step[1], step[2], pending)                                   <L 17>
    var_66 = wp::extract(var_step, var_65);
    var_68 = wp::extract(var_step, var_67);
    var_70 = wp::extract(var_step, var_69);
    var_71 = wp::vec_t<4, wp::int64>(var_66, var_68, var_70, var_1);
    return var_71;
}


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


// <pointloom.kernels.search.neighbor_keys.count_up_to>:1
static CUDA_CALLABLE wp::int32 count_up_to_0(
    wp::array_t<wp::int64> var_keys,
    wp::int32 var_base,
    wp::int32 var_stride,
    wp::int32 var_key_count,
    wp::int64 var_limit)
{
    //---------
    // primal vars
    wp::int64 var_0;
    wp::range_t var_1;
    wp::int32 var_2;
    wp::int32 var_3;
    wp::int32 var_4;
    wp::int64* var_5;
    bool var_6;
    wp::int64 var_7;
    wp::int64 var_8;
    wp::int64 var_9;
    wp::int64 var_10;
    wp::int32 var_11;
    //---------
    // forward
    // def count_up_to(keys, base, stride, key_count, limit):                                 <L 1>
    // count = int64(0)                                                                       <L 2>
    var_0 = 0ll;
    // for j in range(key_count):                                                             <L 3>
    var_1 = wp::range(var_key_count);
    start_for_0:;
        if (iter_cmp(var_1) == 0) goto end_for_0;
        var_2 = wp::iter_next(var_1);
        // if keys[base + j * stride] <= limit:                                               <L 4>
        var_3 = wp::mul(var_2, var_stride);
        var_4 = wp::add(var_base, var_3);
        var_5 = wp::address(var_keys, var_4);
        var_7 = wp::load(var_5);
        var_6 = (var_7 <= var_limit);
        if (var_6) {
            // count += int64(1)                                                              <L 5>
            var_8 = 1ll;
            var_9 = wp::add(var_0, var_8);
        }
        var_10 = wp::where(var_6, var_9, var_0);
        wp::assign(var_0, var_10);
        goto start_for_0;
    end_for_0:;
    // return int(count)                                                                      <L 6>
    var_11 = wp::int(var_0);
    return var_11;
}


// <pointloom.kernels.search.neighbor_keys.limit_between>:1
static CUDA_CALLABLE wp::int64 limit_between_on_cuda_0(
    wp::array_t<wp::int64> var_keys,
    wp::int32 var_base,
    wp::int32 var_stride,
    wp::int32 var_key_count,
    wp::int32 var_k,
    wp::float32 var_max_sqdist)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 0.0;
    wp::float32 var_1;
    const wp::float32 var_2 = 0.0;
    wp::float32 var_3;
    wp::float32 var_4;
    const wp::int32 var_5 = 0;
    wp::int32 var_6;
    wp::int32 var_7;
    bool var_8;
    bool var_9;
    bool var_10;
    wp::float32 var_11;
    wp::int32 var_12;
    wp::float32 var_13;
    const wp::float32 var_14 = 0.5;
    wp::float32 var_15;
    wp::int32 var_16;
    wp::float32 var_17;
    wp::float32 var_18;
    wp::float32 var_19;
    wp::float32 var_20;
    wp::int32 var_21;
    const wp::int32 var_22 = 1;
    wp::int32 var_23;
    wp::float32 var_24;
    wp::float32 var_25;
    wp::float32 var_26;
    const wp::int32 var_27 = 0;
    wp::int32 var_28;
    const wp::float32 var_29 = 0.0;
    wp::float32 var_30;
    wp::float32 var_31;
    const wp::int32 var_32 = 0;
    wp::int32 var_33;
    wp::range_t var_34;
    wp::int32 var_35;
    wp::int64* var_36;
    wp::float32 var_37;
    wp::int64 var_38;
    bool var_39;
    const wp::int32 var_40 = 1;
    const wp::int32 var_41 = 0;
    wp::int32 var_42;
    wp::int32 var_43;
    const wp::float32 var_44 = 0.0;
    wp::float32 var_45;
    wp::float32 var_46;
    wp::float32 var_47;
    wp::float32 var_48;
    wp::int32 var_49;
    bool var_50;
    wp::float32 var_51;
    wp::int32 var_52;
    wp::float32 var_53;
    wp::float32 var_54;
    wp::int32 var_55;
    wp::float32 var_56;
    wp::float32 var_57;
    wp::float32 var_58;
    wp::int32 var_59;
    wp::int32 var_60;
    wp::int64 var_61;
    bool var_62;
    wp::int64 var_63;
    wp::int32 var_64;
    wp::int64 var_65;
    wp::int64 var_66;
    wp::int64 var_67;
    wp::int64 var_68;
    wp::int64 var_69;
    bool var_70;
    wp::int64 var_71;
    wp::int64 var_72;
    bool var_73;
    bool var_74;
    wp::int64 var_75;
    wp::int64 var_76;
    wp::int64 var_77;
    wp::int64 var_78;
    wp::int32 var_79;
    bool var_80;
    wp::int64 var_81;
    wp::int64 var_82;
    wp::int32 var_83;
    wp::int32 var_84;
    wp::int64 var_85;
    wp::int64 var_86;
    wp::int64 var_87;
    wp::int64 var_88;
    //---------
    // forward
    // def limit_between(keys, base, stride, key_count, k, max_sqdist):                       <L 1>
    // low = float(0.0)                                                                       <L 3>
    var_1 = wp::float(var_0);
    // smallest = float(0.0)                                                                  <L 4>
    var_3 = wp::float(var_2);
    // largest = max_sqdist                                                                   <L 5>
    var_4 = wp::copy(var_max_sqdist);
    // below = int(0)                                                                         <L 6>
    var_6 = wp::int(var_5);
    // above = key_count                                                                      <L 7>
    var_7 = wp::copy(var_key_count);
    // while above > k and smallest < largest:                                                <L 8>
    start_while_0:;
    var_9 = (var_7 > var_k);
    var_8 = var_9;
    if (var_8) {
        var_10 = (var_3 < var_4);
        var_8 = var_8 && var_10;
    }
    if ((var_8) == false) goto end_while_0;
        // guess = low + (largest - low) * ((float(k - below) + 0.5) / float(above - below))       <L 9>
        var_11 = wp::sub(var_4, var_1);
        var_12 = wp::sub(var_k, var_6);
        var_13 = wp::float(var_12);
        var_15 = wp::add(var_13, var_14);
        var_16 = wp::sub(var_7, var_6);
        var_17 = wp::float(var_16);
        var_18 = wp::div(var_15, var_17);
        var_19 = wp::mul(var_11, var_18);
        var_20 = wp::add(var_1, var_19);
        // guess = max(min(guess, bits_float(float_bits(largest) - 1)), smallest)             <L 10>
        var_21 = _float_bits_0(var_4);
        var_23 = wp::sub(var_21, var_22);
        var_24 = _bits_float_0(var_23);
        var_25 = wp::min(var_20, var_24);
        var_26 = wp::max(var_25, var_3);
        // count = int(0)                                                                     <L 11>
        var_28 = wp::int(var_27);
        // up_to = float(0.0)                                                                 <L 12>
        var_30 = wp::float(var_29);
        // beyond = largest                                                                   <L 13>
        var_31 = wp::copy(var_4);
        // at = base + 0                                                                      <L 14>
        var_33 = wp::add(var_base, var_32);
        // for _ in range(key_count):                                                         <L 15>
        var_34 = wp::range(var_key_count);
        start_for_2:;
            if (iter_cmp(var_34) == 0) goto end_for_2;
            var_35 = wp::iter_next(var_34);
            // sqdist = key_number(keys[at])                                                  <L 16>
            var_36 = wp::address(var_keys, var_33);
            var_38 = wp::load(var_36);
            var_37 = key_number_0(var_38);
            // inside = sqdist <= guess                                                       <L 17>
            var_39 = (var_37 <= var_26);
            // count += 1 if inside else 0                                                    <L 18>
            if (var_39) {
            }
            if (!var_39) {
            }
            var_42 = wp::where(var_39, var_40, var_41);
            var_43 = wp::add(var_28, var_42);
            // up_to = max(up_to, sqdist if inside else 0.0)                                  <L 19>
            if (var_39) {
            }
            if (!var_39) {
            }
            var_45 = wp::where(var_39, var_37, var_44);
            var_46 = wp::max(var_30, var_45);
            // beyond = min(beyond, largest if inside else sqdist)                            <L 20>
            if (var_39) {
            }
            if (!var_39) {
            }
            var_47 = wp::where(var_39, var_4, var_37);
            var_48 = wp::min(var_31, var_47);
            // at += stride                                                                   <L 21>
            var_49 = wp::add(var_33, var_stride);
            wp::assign(var_28, var_43);
            wp::assign(var_30, var_46);
            wp::assign(var_31, var_48);
            wp::assign(var_33, var_49);
            goto start_for_2;
        end_for_2:;
        // if count >= k:                                                                     <L 22>
        var_50 = (var_28 >= var_k);
        if (var_50) {
            // largest = up_to                                                                <L 23>
            var_51 = wp::copy(var_30);
            // above = count                                                                  <L 24>
            var_52 = wp::copy(var_28);
        }
        if (!var_50) {
            // smallest = beyond                                                              <L 26>
            var_53 = wp::copy(var_31);
            // low = guess                                                                    <L 27>
            var_54 = wp::copy(var_26);
            // below = count                                                                  <L 28>
            var_55 = wp::copy(var_28);
        }
        var_56 = wp::where(var_50, var_1, var_54);
        var_57 = wp::where(var_50, var_3, var_53);
        var_58 = wp::where(var_50, var_51, var_4);
        var_59 = wp::where(var_50, var_6, var_55);
        var_60 = wp::where(var_50, var_52, var_7);
        wp::assign(var_1, var_56);
        wp::assign(var_3, var_57);
        wp::assign(var_4, var_58);
        wp::assign(var_6, var_59);
        wp::assign(var_7, var_60);
    goto start_while_0;
    end_while_0:;
    // limit = key_limit(largest)                                                             <L 29>
    var_61 = key_limit_0(var_4);
    // if above > k:                                                                          <L 30>
    var_62 = (var_7 > var_k);
    if (var_62) {
        // behind = key_limit(largest)                                                        <L 31>
        var_63 = key_limit_0(var_4);
        // limit = (int64(float_bits(largest)) << int64(32)) - int64(1)                       <L 32>
        var_64 = _float_bits_0(var_4);
        var_65 = wp::int64(var_64);
        var_66 = 32ll;
        var_67 = wp::lshift(var_65, var_66);
        var_68 = 1ll;
        var_69 = wp::sub(var_67, var_68);
        // while behind - limit > int64(1) and above > k:                                     <L 33>
    start_while_4:;
        var_71 = wp::sub(var_63, var_69);
        var_72 = 1ll;
        var_73 = (var_71 > var_72);
        var_70 = var_73;
        if (var_70) {
            var_74 = (var_7 > var_k);
            var_70 = var_70 && var_74;
        }
    if ((var_70) == false) goto end_while_4;
            // middle = limit + (behind - limit) // int64(2)                                  <L 34>
            var_75 = wp::sub(var_63, var_69);
            var_76 = 2ll;
            var_77 = wp::floordiv(var_75, var_76);
            var_78 = wp::add(var_69, var_77);
            // count = count_up_to(keys, base, stride, key_count, middle)                     <L 35>
            var_79 = count_up_to_0(var_keys, var_base, var_stride, var_key_count, var_78);
            // if count < k:                                                                  <L 36>
            var_80 = (var_79 < var_k);
            if (var_80) {
                // limit = middle                                                             <L 37>
                var_81 = wp::copy(var_78);
            }
            if (!var_80) {
                // behind = middle                                                            <L 39>
                var_82 = wp::copy(var_78);
                // above = count                                                              <L 40>
                var_83 = wp::copy(var_79);
            }
            var_84 = wp::where(var_80, var_7, var_83);
            var_85 = wp::where(var_80, var_81, var_69);
            var_86 = wp::where(var_80, var_63, var_82);
            wp::assign(var_7, var_84);
            wp::assign(var_28, var_79);
            wp::assign(var_69, var_85);
            wp::assign(var_63, var_86);
    goto start_while_4;
    end_while_4:;
        // limit = behind                                                                     <L 41>
        var_87 = wp::copy(var_63);
    }
    var_88 = wp::where(var_62, var_87, var_61);
    // return limit                                                                           <L 42>
    return var_88;
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


// <pointloom.kernels.search.neighbor_keys.sort_by_network>:1
static CUDA_CALLABLE void sort_by_network_on_cuda_0(
    wp::array_t<wp::int64> var_keys,
    wp::int32 var_base,
    wp::int32 var_stride,
    wp::int32 var_size)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 1;
    wp::int32 var_1;
    const wp::int32 var_2 = 2;
    wp::int32 var_3;
    bool var_4;
    const wp::int32 var_5 = 2;
    wp::int32 var_6;
    wp::int32 var_7;
    const wp::int32 var_8 = 0;
    bool var_9;
    wp::int32 var_10;
    const wp::int32 var_11 = 0;
    wp::int32 var_12;
    wp::int32 var_13;
    const wp::int32 var_14 = 0;
    bool var_15;
    wp::int32 var_16;
    wp::range_t var_17;
    wp::int32 var_18;
    wp::int32 var_19;
    bool var_20;
    wp::int32 var_21;
    wp::int32 var_22;
    wp::int64* var_23;
    wp::int64 var_24;
    wp::int64 var_25;
    wp::int32 var_26;
    wp::int32 var_27;
    wp::int32 var_28;
    wp::int64* var_29;
    wp::int64 var_30;
    wp::int64 var_31;
    bool var_32;
    wp::int32 var_33;
    wp::int32 var_34;
    wp::int32 var_35;
    wp::int32 var_36;
    wp::int32 var_37;
    wp::int32 var_38;
    const wp::int32 var_39 = 2;
    wp::int32 var_40;
    wp::int32 var_41;
    const wp::int32 var_42 = 2;
    wp::int32 var_43;
    //---------
    // forward
    // def sort_by_network(keys, base, stride, size):                                         <L 1>
    // top = int(1)                                                                           <L 3>
    var_1 = wp::int(var_0);
    // while top * 2 < size:                                                                  <L 4>
    start_while_0:;
    var_3 = wp::mul(var_1, var_2);
    var_4 = (var_3 < var_size);
    if ((var_4) == false) goto end_while_0;
        // top = top * 2                                                                      <L 5>
        var_6 = wp::mul(var_1, var_5);
        wp::assign(var_1, var_6);
    goto start_while_0;
    end_while_0:;
    // p = top                                                                                <L 6>
    var_7 = wp::copy(var_1);
    // while p > 0:                                                                           <L 7>
    start_while_2:;
    var_9 = (var_7 > var_8);
    if ((var_9) == false) goto end_while_2;
        // q = top                                                                            <L 8>
        var_10 = wp::copy(var_1);
        // r = int(0)                                                                         <L 9>
        var_12 = wp::int(var_11);
        // d = p                                                                              <L 10>
        var_13 = wp::copy(var_7);
        // while d > 0:                                                                       <L 11>
    start_while_4:;
        var_15 = (var_13 > var_14);
    if ((var_15) == false) goto end_while_4;
            // for i in range(size - d):                                                      <L 12>
            var_16 = wp::sub(var_size, var_13);
            var_17 = wp::range(var_16);
            start_for_6:;
                if (iter_cmp(var_17) == 0) goto end_for_6;
                var_18 = wp::iter_next(var_17);
                // if i & p == r:                                                             <L 13>
                var_19 = wp::bit_and(var_18, var_7);
                var_20 = (var_19 == var_12);
                if (var_20) {
                    // x = keys[base + i * stride]                                            <L 14>
                    var_21 = wp::mul(var_18, var_stride);
                    var_22 = wp::add(var_base, var_21);
                    var_23 = wp::address(var_keys, var_22);
                    var_25 = wp::load(var_23);
                    var_24 = wp::copy(var_25);
                    // y = keys[base + (i + d) * stride]                                      <L 15>
                    var_26 = wp::add(var_18, var_13);
                    var_27 = wp::mul(var_26, var_stride);
                    var_28 = wp::add(var_base, var_27);
                    var_29 = wp::address(var_keys, var_28);
                    var_31 = wp::load(var_29);
                    var_30 = wp::copy(var_31);
                    // if x > y:                                                              <L 16>
                    var_32 = (var_24 > var_30);
                    if (var_32) {
                        // keys[base + i * stride] = y                                        <L 17>
                        var_33 = wp::mul(var_18, var_stride);
                        var_34 = wp::add(var_base, var_33);
                        wp::array_store(var_keys, var_34, var_30);
                        // keys[base + (i + d) * stride] = x                                  <L 18>
                        var_35 = wp::add(var_18, var_13);
                        var_36 = wp::mul(var_35, var_stride);
                        var_37 = wp::add(var_base, var_36);
                        wp::array_store(var_keys, var_37, var_24);
                    }
                }
                goto start_for_6;
            end_for_6:;
            // d = q - p                                                                      <L 19>
            var_38 = wp::sub(var_10, var_7);
            // q = q // 2                                                                     <L 20>
            var_40 = wp::floordiv(var_10, var_39);
            // r = p                                                                          <L 21>
            var_41 = wp::copy(var_7);
            wp::assign(var_10, var_40);
            wp::assign(var_12, var_41);
            wp::assign(var_13, var_38);
    goto start_while_4;
    end_while_4:;
        // p = p // 2                                                                         <L 22>
        var_43 = wp::floordiv(var_7, var_42);
        wp::assign(var_7, var_43);
    goto start_while_2;
    end_while_2:;
}


// /work/main/src/pointloom/kernels/search/neighbor_keys.py:207
static CUDA_CALLABLE wp::int32 pick_nearest_on_cuda_0(
    wp::array_t<wp::int64> var_keys,
    wp::int32 var_base,
    wp::int32 var_stride,
    wp::int32 var_key_count,
    wp::int32 var_k,
    wp::int32 var_room)
{
    //---------
    // primal vars
    wp::int32 var_0;
    bool var_1;
    wp::int64* var_2;
    wp::int64 var_3;
    wp::int64 var_4;
    const wp::int32 var_5 = 1;
    wp::range_t var_6;
    wp::int32 var_7;
    wp::int32 var_8;
    wp::int32 var_9;
    wp::int64* var_10;
    wp::int64 var_11;
    wp::int64 var_12;
    wp::float32 var_13;
    wp::int64 var_14;
    wp::int32 var_15;
    wp::int32 var_16;
    //---------
    // forward
    // def pick_nearest(keys: array(dtype=int64), base: int, stride: int, key_count: int, k: int, room: int) -> int:       <L 208>
    // left = key_count                                                                       <L 210>
    var_0 = wp::copy(var_key_count);
    // if key_count > k:                                                                      <L 211>
    var_1 = (var_key_count > var_k);
    if (var_1) {
        // largest = keys[base]                                                               <L 212>
        var_2 = wp::address(var_keys, var_base);
        var_4 = wp::load(var_2);
        var_3 = wp::copy(var_4);
        // for j in range(1, key_count):                                                      <L 213>
        var_6 = wp::range(var_5, var_key_count);
        start_for_0:;
            if (iter_cmp(var_6) == 0) goto end_for_0;
            var_7 = wp::iter_next(var_6);
            // largest = max(largest, keys[base + j * stride])                                <L 214>
            var_8 = wp::mul(var_7, var_stride);
            var_9 = wp::add(var_base, var_8);
            var_10 = wp::address(var_keys, var_9);
            var_12 = wp::load(var_10);
            var_11 = wp::max(var_3, var_12);
            wp::assign(var_3, var_11);
            goto start_for_0;
        end_for_0:;
        // limit = limit_nearest(keys, base, stride, key_count, k, key_number(largest))       <L 215>
        var_13 = key_number_0(var_3);
        var_14 = limit_between_on_cuda_0(var_keys, var_base, var_stride, var_key_count, var_k, var_13);
        // left = keep_up_to(keys, base, stride, key_count, limit)                            <L 216>
        var_15 = keep_up_to_0(var_keys, var_base, var_stride, var_key_count, var_14);
    }
    var_16 = wp::where(var_1, var_15, var_0);
    // sort_keys(keys, base, stride, left)                                                    <L 217>
    sort_by_network_on_cuda_0(var_keys, var_base, var_stride, var_16);
    // return left                                                                            <L 218>
    return var_16;
}


// <pointloom.kernels.search.bucket_walk.children_one_by_one>:1
static CUDA_CALLABLE wp::int32 children_one_by_one_on_cuda_0(
    wp::array_t<wp::int32> var_levels,
    wp::array_t<wp::float32> var_boxes,
    wp::vec_t<3, wp::float32> var_p,
    wp::float32 var_bound,
    wp::int32 var_level,
    wp::int32 var_node)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    const wp::int32 var_2 = 8;
    wp::int32 var_3;
    wp::range_t var_4;
    wp::int32 var_5;
    wp::int32* var_6;
    wp::int32 var_7;
    wp::int32 var_8;
    wp::float32 var_9;
    bool var_10;
    const wp::int32 var_11 = 1;
    wp::int32 var_12;
    wp::int32 var_13;
    wp::int32 var_14;
    //---------
    // forward
    // def children_one_by_one(levels, boxes, p, bound, level, node):                         <L 1>
    // bits = int(0)                                                                          <L 3>
    var_1 = wp::int(var_0);
    // children = int(FAN)                                                                    <L 4>
    var_3 = wp::int(var_2);
    // for j in range(children):                                                              <L 5>
    var_4 = wp::range(var_3);
    start_for_0:;
        if (iter_cmp(var_4) == 0) goto end_for_0;
        var_5 = wp::iter_next(var_4);
        // if measure_box(boxes, levels[level] + node, j, p, p) <= bound:                     <L 6>
        var_6 = wp::address(var_levels, var_level);
        var_8 = wp::load(var_6);
        var_7 = wp::add(var_8, var_node);
        var_9 = measure_box_0(var_boxes, var_7, var_5, var_p, var_p);
        var_10 = (var_9 <= var_bound);
        if (var_10) {
            // bits = bits | 1 << j                                                           <L 7>
            var_12 = wp::lshift(var_11, var_5);
            var_13 = wp::bit_or(var_1, var_12);
        }
        var_14 = wp::where(var_10, var_13, var_1);
        wp::assign(var_1, var_14);
        goto start_for_0;
    end_for_0:;
    // return bits                                                                            <L 8>
    return var_1;
}


// <pointloom.kernels.search.bucket_walk.next_step__children_one_by_one>:1
static CUDA_CALLABLE wp::vec_t<4, wp::int64> next_step__children_one_by_one_on_cuda_0(
    wp::vec_t<4, wp::int64> var_step,
    wp::int32 var_root,
    wp::array_t<wp::int32> var_children__levels,
    wp::array_t<wp::float32> var_children__boxes,
    wp::vec_t<3, wp::float32> var_children__p,
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
    // def next_step__children_one_by_one(step, root, children__levels, children__boxes, children__p, children__bound):       <L 1>
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
                // inside = children__call(children__levels, children__boxes, children__p, children__bound, level, node)       <L 21>
                var_48 = children_one_by_one_on_cuda_0(var_children__levels, var_children__boxes, var_children__p, var_children__bound, var_44, var_42);
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
                    // others = children__call(children__levels, children__boxes, children__p, children__bound, level, node) & BYTE - own       <L 31>
                    var_66 = children_one_by_one_on_cuda_0(var_children__levels, var_children__boxes, var_children__p, var_children__bound, var_65, var_63);
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


// <pointloom.kernels.search.bucket_walk.next_bucket_one_by_one>:1
static CUDA_CALLABLE wp::vec_t<4, wp::int64> next_bucket_one_by_one_on_cuda_0(
    wp::vec_t<4, wp::int64> var_step,
    wp::vec_t<3, wp::float32> var_p,
    wp::float32 var_bound,
    wp::int32 var_tree__root,
    wp::array_t<wp::int32> var_tree__levels,
    wp::array_t<wp::float32> var_tree__boxes)
{
    //---------
    // primal vars
    wp::vec_t<4, wp::int64> var_0;
    //---------
    // forward
    // def next_bucket_one_by_one(step, p, bound, tree__root, tree__levels, tree__boxes):       <L 1>
    // return next_step__children_one_by_one(step, tree__root, tree__levels, tree__boxes, p, bound)       <L 2>
    var_0 = next_step__children_one_by_one_on_cuda_0(var_step, var_tree__root, var_tree__levels, var_tree__boxes, var_p, var_bound);
    return var_0;
}


// <pointloom.kernels.search.k_nearest.search_with_one_pick>:1
static CUDA_CALLABLE wp::int32 search_with_one_pick_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::int32 var_start,
    wp::int32 var_tree__count,
    wp::int32 var_tree__root,
    wp::array_t<wp::int32> var_tree__levels,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> var_tree__points,
    wp::array_t<wp::int32> var_labels,
    wp::array_t<wp::int64> var_keys,
    wp::int32 var_base,
    wp::int32 var_stride,
    wp::int32 var_k,
    wp::int32 var_room,
    wp::float32 var_max_sqdist)
{
    //---------
    // primal vars
    wp::float32 var_0;
    wp::int64 var_1;
    const wp::int32 var_2 = 64;
    wp::int32 var_3;
    const wp::int32 var_4 = 3;
    wp::int32 var_5;
    wp::int32 var_6;
    wp::int32 var_7;
    const wp::int32 var_8 = 0;
    wp::int32 var_9;
    const wp::int32 var_10 = 1;
    wp::int32 var_11;
    wp::vec_t<4, wp::int64> var_12;
    const wp::int32 var_13 = 1;
    bool var_14;
    const wp::int32 var_15 = 0;
    wp::int64 var_16;
    wp::int32 var_17;
    bool var_18;
    const wp::int32 var_19 = 2;
    wp::int64 var_20;
    wp::int32 var_21;
    wp::int32 var_22;
    wp::int32 var_23;
    bool var_24;
    const wp::int32 var_25 = 0;
    wp::int32 var_26;
    const wp::int32 var_27 = 1;
    bool var_28;
    wp::vec_t<4, wp::int64> var_29;
    wp::vec_t<4, wp::int64> var_30;
    wp::vec_t<4, wp::int64> var_31;
    const wp::int32 var_32 = 0;
    wp::int32 var_33;
    wp::int32 var_34;
    wp::vec_t<4, wp::int64> var_35;
    bool var_36;
    const wp::int32 var_37 = 0;
    bool var_38;
    bool var_39;
    bool var_40;
    bool var_41;
    const wp::float32 var_42 = 3e+38;
    bool var_43;
    wp::int32 var_44;
    bool var_45;
    const wp::int32 var_46 = 1;
    wp::int32 var_47;
    wp::int32 var_48;
    wp::int32 var_49;
    wp::int64* var_50;
    wp::int64 var_51;
    wp::int64 var_52;
    wp::float32 var_53;
    wp::float32 var_54;
    wp::int64 var_55;
    wp::float32 var_56;
    wp::int64 var_57;
    wp::int32 var_58;
    const wp::int32 var_59 = 1;
    bool var_60;
    wp::vec_t<4, wp::int64> var_61;
    wp::vec_t<4, wp::int64> var_62;
    //---------
    // forward
    // def search_with_one_pick(p, start, tree__count, tree__root, tree__levels, tree__boxes, tree__points, labels, keys, base, stride, k, room, max_sqdist):       <L 1>
    // bound = max_sqdist                                                                     <L 3>
    var_0 = wp::copy(var_max_sqdist);
    // limit = key_limit(max_sqdist)                                                          <L 4>
    var_1 = key_limit_0(var_max_sqdist);
    // crowd = min(room - BUCKET, 3 * k + BUCKET)                                             <L 5>
    var_3 = wp::sub(var_room, var_2);
    var_5 = wp::mul(var_4, var_k);
    var_6 = wp::add(var_5, var_2);
    var_7 = wp::min(var_3, var_6);
    // size = int(0)                                                                          <L 6>
    var_9 = wp::int(var_8);
    // is_active = int(1)                                                                     <L 7>
    var_11 = wp::int(var_10);
    // step = start_traversal(start)                                                          <L 8>
    var_12 = start_traversal_0(var_start);
    // while is_active == 1:                                                                  <L 9>
    start_while_0:;
    var_14 = (var_11 == var_13);
    if ((var_14) == false) goto end_while_0;
        // if int(step[0]) <= tree__root:                                                     <L 10>
        var_16 = wp::extract(var_12, var_15);
        var_17 = wp::int(var_16);
        var_18 = (var_17 <= var_tree__root);
        if (var_18) {
            // bucket = int(step[2])                                                          <L 11>
            var_20 = wp::extract(var_12, var_19);
            var_21 = wp::int(var_20);
            // previous_size = size                                                           <L 12>
            var_22 = wp::copy(var_9);
            // size = offer_bucket(bucket, p, tree__count, tree__boxes, tree__points, labels, keys, base, stride, size, bound, limit)       <L 13>
            var_23 = offer_leaves_one_by_one_on_cuda_0(var_21, var_p, var_tree__count, var_tree__boxes, var_tree__points, var_labels, var_keys, var_base, var_stride, var_9, var_0, var_1);
            // if size == previous_size:                                                      <L 14>
            var_24 = (var_23 == var_22);
            if (var_24) {
                // if is_one_point(tree__boxes, bucket, 0) == 1:                              <L 15>
                var_26 = is_one_point_0(var_tree__boxes, var_21, var_25);
                var_28 = (var_26 == var_27);
                if (var_28) {
                    // step = pass_over_equal(step, p, p, limit, tree__levels, tree__boxes, labels)       <L 16>
                    var_29 = pass_over_equal_one_by_one_on_cuda_0(var_12, var_p, var_p, var_1, var_tree__levels, var_tree__boxes, var_labels);
                }
                var_30 = wp::where(var_28, var_29, var_12);
            }
            var_31 = wp::where(var_24, var_30, var_12);
        }
        if (!var_18) {
            // is_active = 0                                                                  <L 18>
        }
        var_33 = wp::where(var_18, var_23, var_9);
        var_34 = wp::where(var_18, var_11, var_32);
        var_35 = wp::where(var_18, var_31, var_12);
        // if is_active == 0 or size > crowd or (size >= k and bound >= BOUNDLESS):           <L 19>
        var_38 = (var_34 == var_37);
        var_36 = var_38;
        if (!var_36) {
            var_39 = (var_33 > var_7);
            var_36 = var_36 || var_39;
        }
        if (!var_36) {
            var_41 = (var_33 >= var_k);
            var_40 = var_41;
            if (var_40) {
                var_43 = (var_0 >= var_42);
                var_40 = var_40 && var_43;
            }
            var_36 = var_36 || var_40;
        }
        if (var_36) {
            // size = keep_nearest(keys, base, stride, size, k, room)                         <L 20>
            var_44 = pick_nearest_on_cuda_0(var_keys, var_base, var_stride, var_33, var_k, var_room);
            // if size == k:                                                                  <L 21>
            var_45 = (var_44 == var_k);
            if (var_45) {
                // limit = min(limit, keys[base + (k - 1) * stride])                          <L 22>
                var_47 = wp::sub(var_k, var_46);
                var_48 = wp::mul(var_47, var_stride);
                var_49 = wp::add(var_base, var_48);
                var_50 = wp::address(var_keys, var_49);
                var_52 = wp::load(var_50);
                var_51 = wp::min(var_1, var_52);
                // bound = key_number(limit)                                                  <L 23>
                var_53 = key_number_0(var_51);
            }
            var_54 = wp::where(var_45, var_53, var_0);
            var_55 = wp::where(var_45, var_51, var_1);
        }
        var_56 = wp::where(var_36, var_54, var_0);
        var_57 = wp::where(var_36, var_55, var_1);
        var_58 = wp::where(var_36, var_44, var_33);
        // if is_active == 1:                                                                 <L 24>
        var_60 = (var_34 == var_59);
        if (var_60) {
            // step = next_bucket_of_point(step, p, bound, tree__root, tree__levels, tree__boxes)       <L 25>
            var_61 = next_bucket_one_by_one_on_cuda_0(var_35, var_p, var_56, var_tree__root, var_tree__levels, var_tree__boxes);
        }
        var_62 = wp::where(var_60, var_61, var_35);
        wp::assign(var_0, var_56);
        wp::assign(var_1, var_57);
        wp::assign(var_9, var_58);
        wp::assign(var_11, var_34);
        wp::assign(var_12, var_62);
    goto start_while_0;
    end_while_0:;
    // return size                                                                            <L 26>
    return var_9;
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


// <pointloom.kernels.search.lane_search.name_keys>:1
static CUDA_CALLABLE void name_keys_on_cuda_0(
    wp::array_t<wp::int32> var_labels,
    wp::array_t<wp::int64> var_scratch__keys,
    wp::int32 var_scratch__stride,
    wp::int32 var_base,
    wp::int32 var_key_count)
{
    //---------
    // primal vars
    wp::range_t var_0;
    wp::int32 var_1;
    wp::int32 var_2;
    wp::int32 var_3;
    wp::int64* var_4;
    wp::int64 var_5;
    wp::int64 var_6;
    wp::int32 var_7;
    wp::int32 var_8;
    wp::int32* var_9;
    wp::int64 var_10;
    wp::int32 var_11;
    wp::int32 var_12;
    wp::int32 var_13;
    //---------
    // forward
    // def name_keys(labels, scratch__keys, scratch__stride, base, key_count):                <L 1>
    // for j in range(key_count):                                                             <L 2>
    var_0 = wp::range(var_key_count);
    start_for_0:;
        if (iter_cmp(var_0) == 0) goto end_for_0;
        var_1 = wp::iter_next(var_0);
        // key = scratch__keys[base + j * scratch__stride]                                    <L 3>
        var_2 = wp::mul(var_1, var_scratch__stride);
        var_3 = wp::add(var_base, var_2);
        var_4 = wp::address(var_scratch__keys, var_3);
        var_6 = wp::load(var_4);
        var_5 = wp::copy(var_6);
        // scratch__keys[base + j * scratch__stride] = pack_bits(key_bits(key), labels[key_index(key)])       <L 4>
        var_7 = key_bits_0(var_5);
        var_8 = key_index_0(var_5);
        var_9 = wp::address(var_labels, var_8);
        var_11 = wp::load(var_9);
        var_10 = pack_bits_0(var_7, var_11);
        var_12 = wp::mul(var_1, var_scratch__stride);
        var_13 = wp::add(var_base, var_12);
        wp::array_store(var_scratch__keys, var_13, var_10);
        goto start_for_0;
    end_for_0:;
}


// <pointloom.kernels.search.lane_search.search_lanes>:1
static CUDA_CALLABLE wp::vec_t<2, wp::int32> search_lanes_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::int32 var_is_query,
    wp::int32 var_start,
    wp::float32 var_guess,
    wp::int32 var_tree__count,
    wp::int32 var_tree__root,
    wp::array_t<wp::int32> var_tree__levels,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> var_tree__points,
    wp::array_t<wp::int32> var_labels,
    wp::array_t<wp::int32> var_scratch__ids,
    wp::array_t<wp::int64> var_scratch__keys,
    wp::int32 var_scratch__k,
    wp::int32 var_scratch__room,
    wp::int32 var_scratch__gather,
    wp::int32 var_scratch__stride,
    wp::int32 var_thread,
    wp::float32 var_max_sqdist,
    wp::int32 var_by_position)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 32;
    wp::int32 var_1;
    wp::int32 var_2;
    wp::vec_t<3, wp::float32> var_3;
    const wp::int32 var_4 = 0;
    wp::float32 var_5;
    const wp::int32 var_6 = 1;
    wp::float32 var_7;
    wp::int32 var_8;
    const wp::int32 var_9 = 2;
    wp::float32 var_10;
    wp::int32 var_11;
    bool var_12;
    bool var_13;
    bool var_14;
    bool var_15;
    bool var_16;
    const wp::float32 var_17 = -1.0;
    wp::float32 var_18;
    bool var_19;
    const wp::float32 var_20 = 0.0;
    bool var_21;
    const wp::int32 var_22 = 8;
    wp::int32 var_23;
    bool var_24;
    wp::vec_t<2, wp::float32> var_25;
    const wp::int32 var_26 = 0;
    wp::float32 var_27;
    const wp::int32 var_28 = 1;
    wp::float32 var_29;
    wp::int32 var_30;
    wp::float32 var_31;
    wp::int32 var_32;
    const wp::float32 var_33 = 0.0;
    bool var_34;
    const wp::int32 var_35 = 0;
    wp::int32 var_36;
    const wp::int32 var_37 = 1;
    bool var_38;
    wp::int32 var_39;
    wp::float32 var_40;
    bool var_41;
    const wp::int32 var_42 = 1;
    wp::int32 var_43;
    wp::int32 var_44;
    wp::int32 var_45;
    wp::int64* var_46;
    wp::float32 var_47;
    wp::int64 var_48;
    wp::float32 var_49;
    wp::float32 var_50;
    wp::int32 var_51;
    const wp::int32 var_52 = 0;
    bool var_53;
    wp::float32 var_54;
    wp::int32 var_55;
    bool var_56;
    wp::int64 var_57;
    wp::int32 var_58;
    wp::float32 var_59;
    wp::float32 var_60;
    wp::int32 var_61;
    wp::int32 var_62;
    wp::vec_t<2, wp::int32> var_63;
    //---------
    // forward
    // def search_lanes(p, is_query, start, guess, tree__count, tree__root, tree__levels, tree__boxes, tree__points, labels, scratch__ids, scratch__keys, scratch__k, scratch__room, scratch__gather, scratch__stride, thread, max_sqdist, by_position):       <L 1>
    // listing = thread // WARP * scratch__gather                                             <L 5>
    var_1 = wp::floordiv(var_thread, var_0);
    var_2 = wp::mul(var_1, var_scratch__gather);
    // result = keep_for_lanes(p, start, guess, tree__count, tree__root, tree__levels, tree__boxes, tree__points, scratch__ids, scratch__keys, scratch__k, scratch__room, scratch__gather, scratch__stride, listing, thread, max_sqdist)       <L 6>
    var_3 = keep_for_lanes_on_cuda_0(var_p, var_start, var_guess, var_tree__count, var_tree__root, var_tree__levels, var_tree__boxes, var_tree__points, var_scratch__ids, var_scratch__keys, var_scratch__k, var_scratch__room, var_scratch__gather, var_scratch__stride, var_2, var_thread, var_max_sqdist);
    // near = result[0]                                                                       <L 7>
    var_5 = wp::extract(var_3, var_4);
    // listed = int(result[1])                                                                <L 8>
    var_7 = wp::extract(var_3, var_6);
    var_8 = wp::int(var_7);
    // size = int(result[2])                                                                  <L 9>
    var_10 = wp::extract(var_3, var_9);
    var_11 = wp::int(var_10);
    // if listed > scratch__gather or (size < scratch__k and near < max_sqdist):              <L 10>
    var_13 = (var_8 > var_scratch__gather);
    var_12 = var_13;
    if (!var_12) {
        var_15 = (var_11 < var_scratch__k);
        var_14 = var_15;
        if (var_14) {
            var_16 = (var_5 < var_max_sqdist);
            var_14 = var_14 && var_16;
        }
        var_12 = var_12 || var_14;
    }
    if (var_12) {
        // near = -1.0                                                                        <L 11>
    }
    var_18 = wp::where(var_12, var_17, var_5);
    // if near >= 0.0 and size > scratch__room - LEAF:                                        <L 12>
    var_21 = (var_18 >= var_20);
    var_19 = var_21;
    if (var_19) {
        var_23 = wp::sub(var_scratch__room, var_22);
        var_24 = (var_11 > var_23);
        var_19 = var_19 && var_24;
    }
    if (var_19) {
        // nearer = keep_nearer(p, near, size, tree__points, scratch__ids, scratch__keys, scratch__k, scratch__room, scratch__stride, listing, listed, thread)       <L 13>
        var_25 = keep_nearer_on_cuda_0(var_p, var_18, var_11, var_tree__points, var_scratch__ids, var_scratch__keys, var_scratch__k, var_scratch__room, var_scratch__stride, var_2, var_8, var_thread);
        // near = nearer[0]                                                                   <L 14>
        var_27 = wp::extract(var_25, var_26);
        // size = int(nearer[1])                                                              <L 15>
        var_29 = wp::extract(var_25, var_28);
        var_30 = wp::int(var_29);
    }
    var_31 = wp::where(var_19, var_27, var_18);
    var_32 = wp::where(var_19, var_30, var_11);
    // if near < 0.0:                                                                         <L 16>
    var_34 = (var_31 < var_33);
    if (var_34) {
        // size = int(0)                                                                      <L 17>
        var_36 = wp::int(var_35);
        // if is_query == 1:                                                                  <L 18>
        var_38 = (var_is_query == var_37);
        if (var_38) {
            // size = search_k_nearest(p, start, tree__count, tree__root, tree__levels, tree__boxes, tree__points, labels, scratch__keys, thread, scratch__stride, scratch__k, scratch__room, max_sqdist)       <L 19>
            var_39 = search_with_one_pick_on_cuda_0(var_p, var_start, var_tree__count, var_tree__root, var_tree__levels, var_tree__boxes, var_tree__points, var_labels, var_scratch__keys, var_thread, var_scratch__stride, var_scratch__k, var_scratch__room, var_max_sqdist);
            // near = max_sqdist                                                              <L 20>
            var_40 = wp::copy(var_max_sqdist);
            // if size == scratch__k:                                                         <L 21>
            var_41 = (var_39 == var_scratch__k);
            if (var_41) {
                // near = key_number(scratch__keys[thread + (size - 1) * scratch__stride])       <L 22>
                var_43 = wp::sub(var_39, var_42);
                var_44 = wp::mul(var_43, var_scratch__stride);
                var_45 = wp::add(var_thread, var_44);
                var_46 = wp::address(var_scratch__keys, var_45);
                var_48 = wp::load(var_46);
                var_47 = key_number_0(var_48);
            }
            var_49 = wp::where(var_41, var_47, var_40);
        }
        var_50 = wp::where(var_38, var_49, var_31);
        var_51 = wp::where(var_38, var_39, var_36);
    }
    if (!var_34) {
        // elif by_position == 0:                                                             <L 23>
        var_53 = (var_by_position == var_52);
        if (var_53) {
            // name_keys(labels, scratch__keys, scratch__stride, thread, size)                <L 24>
            name_keys_on_cuda_0(var_labels, var_scratch__keys, var_scratch__stride, var_thread, var_32);
        }
    }
    var_54 = wp::where(var_34, var_50, var_31);
    var_55 = wp::where(var_34, var_51, var_32);
    // if size > scratch__k:                                                                  <L 25>
    var_56 = (var_55 > var_scratch__k);
    if (var_56) {
        // limit = limit_nearest(scratch__keys, thread, scratch__stride, size, scratch__k, near)       <L 26>
        var_57 = limit_between_on_cuda_0(var_scratch__keys, var_thread, var_scratch__stride, var_55, var_scratch__k, var_54);
        // size = keep_up_to(scratch__keys, thread, scratch__stride, size, limit)             <L 27>
        var_58 = keep_up_to_0(var_scratch__keys, var_thread, var_scratch__stride, var_55, var_57);
        // near = key_number(limit)                                                           <L 28>
        var_59 = key_number_0(var_57);
    }
    var_60 = wp::where(var_56, var_59, var_54);
    var_61 = wp::where(var_56, var_58, var_55);
    // return vec2i(size, float_bits(near))                                                   <L 29>
    var_62 = _float_bits_0(var_60);
    var_63 = wp::vec_t<2, wp::int32>(var_61, var_62);
    return var_63;
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


// <pointloom.kernels.search.group_search.farthest_key>:1
static CUDA_CALLABLE wp::float32 farthest_key_on_cuda_0(
    wp::array_t<wp::int64> var_scratch__keys,
    wp::int32 var_scratch__stride,
    wp::int32 var_base,
    wp::int32 var_size)
{
    //---------
    // primal vars
    wp::int64 var_0;
    wp::range_t var_1;
    wp::int32 var_2;
    wp::int64 var_3;
    wp::int64 var_4;
    wp::float32 var_5;
    //---------
    // forward
    // def farthest_key(scratch__keys, scratch__stride, base, size):                          <L 1>
    // largest = int64(0)                                                                     <L 3>
    var_0 = 0ll;
    // for j in range(size):                                                                  <L 4>
    var_1 = wp::range(var_size);
    start_for_0:;
        if (iter_cmp(var_1) == 0) goto end_for_0;
        var_2 = wp::iter_next(var_1);
        // largest = max(largest, stored_key(scratch__keys, scratch__stride, base, j))        <L 5>
        var_3 = stored_key_of_lane_on_cuda_0(var_scratch__keys, var_scratch__stride, var_base, var_2);
        var_4 = wp::max(var_0, var_3);
        wp::assign(var_0, var_4);
        goto start_for_0;
    end_for_0:;
    // return key_number(largest)                                                             <L 6>
    var_5 = key_number_0(var_0);
    return var_5;
}


// /work/main/src/pointloom/kernels/algebra/moments.py:11
static CUDA_CALLABLE wp::float32 steps_for_0(
    wp::float32 var_sqdist,
    wp::int32 var_count)
{
    //---------
    // primal vars
    wp::int32 var_0;
    const wp::int32 var_1 = 23;
    wp::int32 var_2;
    const wp::int32 var_3 = 125;
    wp::int32 var_4;
    const wp::int32 var_5 = 1;
    wp::int32 var_6;
    const wp::int32 var_7 = 150;
    wp::int32 var_8;
    const wp::int32 var_9 = 23;
    wp::int32 var_10;
    wp::float32 var_11;
    const wp::int32 var_12 = 131072;
    bool var_13;
    const wp::float32 var_14 = 0.00390625;
    wp::float32 var_15;
    wp::float32 var_16;
    //---------
    // forward
    // def steps_for(sqdist: float, count: int) -> float:                                     <L 12>
    // power = ((float_bits(sqdist) >> 23) - 125) >> 1  # sqdist < 4^power                    <L 14>
    var_0 = _float_bits_0(var_sqdist);
    var_2 = wp::rshift(var_0, var_1);
    var_4 = wp::sub(var_2, var_3);
    var_6 = wp::rshift(var_4, var_5);
    // steps = bits_float((150 - power) << 23)                                                <L 15>
    var_8 = wp::sub(var_7, var_6);
    var_10 = wp::lshift(var_8, var_9);
    var_11 = _bits_float_0(var_10);
    // if count > MAX_EXACT_POINTS:                                                           <L 16>
    var_13 = (var_count > var_12);
    if (var_13) {
        // steps = steps * COARSER                                                            <L 17>
        var_15 = wp::mul(var_11, var_14);
    }
    var_16 = wp::where(var_13, var_15, var_11);
    // return steps                                                                           <L 18>
    return var_16;
}


// /work/main/src/pointloom/kernels/algebra/moments.py:21
static CUDA_CALLABLE wp::int64 integer_steps_0(
    wp::float32 var_length,
    wp::float32 var_steps)
{
    //---------
    // primal vars
    wp::float32 var_0;
    const wp::float32 var_1 = 0.5;
    wp::float32 var_2;
    wp::float32 var_3;
    wp::int32 var_4;
    wp::int64 var_5;
    //---------
    // forward
    // def integer_steps(length: float, steps: float) -> int64:                               <L 22>
    // return int64(int(floor(length * steps + 0.5)))                                         <L 24>
    var_0 = wp::mul(var_length, var_steps);
    var_2 = wp::add(var_0, var_1);
    var_3 = wp::floor(var_2);
    var_4 = wp::int(var_3);
    var_5 = wp::int64(var_4);
    return var_5;
}


// /work/main/src/pointloom/kernels/algebra/moments.py:27
static CUDA_CALLABLE wp::vec_t<10, wp::int64> add_integer_moments_0(
    wp::vec_t<10, wp::int64> var_total,
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> var_q,
    wp::float32 var_steps)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    const wp::int32 var_2 = 0;
    wp::float32 var_3;
    wp::float32 var_4;
    wp::int64 var_5;
    const wp::int32 var_6 = 1;
    wp::float32 var_7;
    const wp::int32 var_8 = 1;
    wp::float32 var_9;
    wp::float32 var_10;
    wp::int64 var_11;
    const wp::int32 var_12 = 2;
    wp::float32 var_13;
    const wp::int32 var_14 = 2;
    wp::float32 var_15;
    wp::float32 var_16;
    wp::int64 var_17;
    wp::int64 var_18;
    wp::int64 var_19;
    wp::int64 var_20;
    wp::int64 var_21;
    wp::int64 var_22;
    wp::int64 var_23;
    wp::int64 var_24;
    wp::vec_t<10, wp::int64> var_25;
    wp::vec_t<10, wp::int64> var_26;
    //---------
    // forward
    // def add_integer_moments(total: integer_moments, p: vec3, q: vec3, steps: float) -> integer_moments:       <L 28>
    // x = integer_steps(q[0] - p[0], steps)                                                  <L 30>
    var_1 = wp::extract(var_q, var_0);
    var_3 = wp::extract(var_p, var_2);
    var_4 = wp::sub(var_1, var_3);
    var_5 = integer_steps_0(var_4, var_steps);
    // y = integer_steps(q[1] - p[1], steps)                                                  <L 31>
    var_7 = wp::extract(var_q, var_6);
    var_9 = wp::extract(var_p, var_8);
    var_10 = wp::sub(var_7, var_9);
    var_11 = integer_steps_0(var_10, var_steps);
    // z = integer_steps(q[2] - p[2], steps)                                                  <L 32>
    var_13 = wp::extract(var_q, var_12);
    var_15 = wp::extract(var_p, var_14);
    var_16 = wp::sub(var_13, var_15);
    var_17 = integer_steps_0(var_16, var_steps);
    // return total + integer_moments(int64(1), x, y, z, x * x, x * y, x * z, y * y, y * z, z * z)       <L 33>
    var_18 = 1ll;
    var_19 = wp::mul(var_5, var_5);
    var_20 = wp::mul(var_5, var_11);
    var_21 = wp::mul(var_5, var_17);
    var_22 = wp::mul(var_11, var_11);
    var_23 = wp::mul(var_11, var_17);
    var_24 = wp::mul(var_17, var_17);
    var_25 = wp::vec_t<10, wp::int64>({var_18, var_5, var_11, var_17, var_19, var_20, var_21, var_22, var_23, var_24});
    var_26 = wp::add(var_total, var_25);
    return var_26;
}


// <pointloom.kernels.algebra.moments.in_meters>:1
static CUDA_CALLABLE wp::vec_t<10, wp::float64> in_meters_0(
    wp::vec_t<10, wp::int64> var_m,
    wp::float32 var_steps)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::float64 var_1;
    wp::float64 var_2;
    wp::float64 var_3;
    const wp::int32 var_4 = 0;
    wp::int64 var_5;
    wp::float64 var_6;
    const wp::int32 var_7 = 1;
    wp::int64 var_8;
    wp::float64 var_9;
    wp::float64 var_10;
    const wp::int32 var_11 = 2;
    wp::int64 var_12;
    wp::float64 var_13;
    wp::float64 var_14;
    const wp::int32 var_15 = 3;
    wp::int64 var_16;
    wp::float64 var_17;
    wp::float64 var_18;
    const wp::int32 var_19 = 4;
    wp::int64 var_20;
    wp::float64 var_21;
    wp::float64 var_22;
    const wp::int32 var_23 = 5;
    wp::int64 var_24;
    wp::float64 var_25;
    wp::float64 var_26;
    const wp::int32 var_27 = 6;
    wp::int64 var_28;
    wp::float64 var_29;
    wp::float64 var_30;
    const wp::int32 var_31 = 7;
    wp::int64 var_32;
    wp::float64 var_33;
    wp::float64 var_34;
    const wp::int32 var_35 = 8;
    wp::int64 var_36;
    wp::float64 var_37;
    wp::float64 var_38;
    const wp::int32 var_39 = 9;
    wp::int64 var_40;
    wp::float64 var_41;
    wp::float64 var_42;
    wp::vec_t<10, wp::float64> var_43;
    //---------
    // forward
    // def in_meters(m, steps):                                                               <L 1>
    // s = float64(1.0) / float64(steps)                                                      <L 3>
    var_0 = 1.0;
    var_1 = wp::float64(var_steps);
    var_2 = wp::div(var_0, var_1);
    // t = s * s                                                                              <L 4>
    var_3 = wp::mul(var_2, var_2);
    // return moments(float64(m[0]), float64(m[1]) * s, float64(m[2]) * s, float64(m[3]) * s, float64(m[4]) * t, float64(m[5]) * t, float64(m[6]) * t, float64(m[7]) * t, float64(m[8]) * t, float64(m[9]) * t)       <L 5>
    var_5 = wp::extract(var_m, var_4);
    var_6 = wp::float64(var_5);
    var_8 = wp::extract(var_m, var_7);
    var_9 = wp::float64(var_8);
    var_10 = wp::mul(var_9, var_2);
    var_12 = wp::extract(var_m, var_11);
    var_13 = wp::float64(var_12);
    var_14 = wp::mul(var_13, var_2);
    var_16 = wp::extract(var_m, var_15);
    var_17 = wp::float64(var_16);
    var_18 = wp::mul(var_17, var_2);
    var_20 = wp::extract(var_m, var_19);
    var_21 = wp::float64(var_20);
    var_22 = wp::mul(var_21, var_3);
    var_24 = wp::extract(var_m, var_23);
    var_25 = wp::float64(var_24);
    var_26 = wp::mul(var_25, var_3);
    var_28 = wp::extract(var_m, var_27);
    var_29 = wp::float64(var_28);
    var_30 = wp::mul(var_29, var_3);
    var_32 = wp::extract(var_m, var_31);
    var_33 = wp::float64(var_32);
    var_34 = wp::mul(var_33, var_3);
    var_36 = wp::extract(var_m, var_35);
    var_37 = wp::float64(var_36);
    var_38 = wp::mul(var_37, var_3);
    var_40 = wp::extract(var_m, var_39);
    var_41 = wp::float64(var_40);
    var_42 = wp::mul(var_41, var_3);
    var_43 = wp::vec_t<10, wp::float64>({var_6, var_10, var_14, var_18, var_22, var_26, var_30, var_34, var_38, var_42});
    return var_43;
}


// <pointloom.kernels.algebra.moments.covariance_of>:1
static CUDA_CALLABLE wp::mat_t<3, 3, wp::float64> covariance_of_0(
    wp::vec_t<10, wp::float64> var_m)
{
    //---------
    // primal vars
    wp::float64 var_0;
    const wp::int32 var_1 = 0;
    wp::float64 var_2;
    wp::float64 var_3;
    wp::float64 var_4;
    wp::float64 var_5;
    const wp::int32 var_6 = 1;
    wp::float64 var_7;
    wp::float64 var_8;
    const wp::int32 var_9 = 2;
    wp::float64 var_10;
    wp::float64 var_11;
    const wp::int32 var_12 = 3;
    wp::float64 var_13;
    wp::float64 var_14;
    const wp::int32 var_15 = 5;
    wp::float64 var_16;
    wp::float64 var_17;
    wp::float64 var_18;
    wp::float64 var_19;
    const wp::int32 var_20 = 6;
    wp::float64 var_21;
    wp::float64 var_22;
    wp::float64 var_23;
    wp::float64 var_24;
    const wp::int32 var_25 = 8;
    wp::float64 var_26;
    wp::float64 var_27;
    wp::float64 var_28;
    wp::float64 var_29;
    const wp::int32 var_30 = 4;
    wp::float64 var_31;
    wp::float64 var_32;
    wp::float64 var_33;
    wp::float64 var_34;
    const wp::int32 var_35 = 7;
    wp::float64 var_36;
    wp::float64 var_37;
    wp::float64 var_38;
    wp::float64 var_39;
    const wp::int32 var_40 = 9;
    wp::float64 var_41;
    wp::float64 var_42;
    wp::float64 var_43;
    wp::float64 var_44;
    wp::mat_t<3, 3, wp::float64> var_45;
    //---------
    // forward
    // def covariance_of(m):                                                                  <L 1>
    // s = float64(1.0) / max(m[0], float64(1.0))                                             <L 3>
    var_0 = 1.0;
    var_2 = wp::extract(var_m, var_1);
    var_3 = 1.0;
    var_4 = wp::max(var_2, var_3);
    var_5 = wp::div(var_0, var_4);
    // x = m[1] * s                                                                           <L 4>
    var_7 = wp::extract(var_m, var_6);
    var_8 = wp::mul(var_7, var_5);
    // y = m[2] * s                                                                           <L 5>
    var_10 = wp::extract(var_m, var_9);
    var_11 = wp::mul(var_10, var_5);
    // z = m[3] * s                                                                           <L 6>
    var_13 = wp::extract(var_m, var_12);
    var_14 = wp::mul(var_13, var_5);
    // xy = m[5] * s - x * y                                                                  <L 7>
    var_16 = wp::extract(var_m, var_15);
    var_17 = wp::mul(var_16, var_5);
    var_18 = wp::mul(var_8, var_11);
    var_19 = wp::sub(var_17, var_18);
    // xz = m[6] * s - x * z                                                                  <L 8>
    var_21 = wp::extract(var_m, var_20);
    var_22 = wp::mul(var_21, var_5);
    var_23 = wp::mul(var_8, var_14);
    var_24 = wp::sub(var_22, var_23);
    // yz = m[8] * s - y * z                                                                  <L 9>
    var_26 = wp::extract(var_m, var_25);
    var_27 = wp::mul(var_26, var_5);
    var_28 = wp::mul(var_11, var_14);
    var_29 = wp::sub(var_27, var_28);
    // return mat33d(m[4] * s - x * x, xy, xz, xy, m[7] * s - y * y, yz, xz, yz, m[9] * s - z * z)       <L 10>
    var_31 = wp::extract(var_m, var_30);
    var_32 = wp::mul(var_31, var_5);
    var_33 = wp::mul(var_8, var_8);
    var_34 = wp::sub(var_32, var_33);
    var_36 = wp::extract(var_m, var_35);
    var_37 = wp::mul(var_36, var_5);
    var_38 = wp::mul(var_11, var_11);
    var_39 = wp::sub(var_37, var_38);
    var_41 = wp::extract(var_m, var_40);
    var_42 = wp::mul(var_41, var_5);
    var_43 = wp::mul(var_14, var_14);
    var_44 = wp::sub(var_42, var_43);
    var_45 = wp::mat_t<3, 3, wp::float64>(var_34, var_19, var_24, var_19, var_39, var_29, var_24, var_29, var_44);
    return var_45;
}


// /work/main/src/pointloom/kernels/algebra/eigen.py:14
static CUDA_CALLABLE wp::float64 largest_entry_0(
    wp::mat_t<3, 3, wp::float64> var_a)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    const wp::int32 var_1 = 0;
    wp::float64 var_2;
    wp::float64 var_3;
    const wp::int32 var_4 = 1;
    const wp::int32 var_5 = 1;
    wp::float64 var_6;
    wp::float64 var_7;
    wp::float64 var_8;
    const wp::int32 var_9 = 2;
    const wp::int32 var_10 = 2;
    wp::float64 var_11;
    wp::float64 var_12;
    wp::float64 var_13;
    const wp::int32 var_14 = 0;
    const wp::int32 var_15 = 1;
    wp::float64 var_16;
    wp::float64 var_17;
    const wp::int32 var_18 = 0;
    const wp::int32 var_19 = 2;
    wp::float64 var_20;
    wp::float64 var_21;
    wp::float64 var_22;
    const wp::int32 var_23 = 1;
    const wp::int32 var_24 = 2;
    wp::float64 var_25;
    wp::float64 var_26;
    wp::float64 var_27;
    wp::float64 var_28;
    //---------
    // forward
    // def largest_entry(a: mat33d) -> float64:                                               <L 15>
    // diagonal = max(max(abs(a[0, 0]), abs(a[1, 1])), abs(a[2, 2]))                          <L 16>
    var_2 = wp::extract(var_a, var_0, var_1);
    var_3 = wp::abs(var_2);
    var_6 = wp::extract(var_a, var_4, var_5);
    var_7 = wp::abs(var_6);
    var_8 = wp::max(var_3, var_7);
    var_11 = wp::extract(var_a, var_9, var_10);
    var_12 = wp::abs(var_11);
    var_13 = wp::max(var_8, var_12);
    // return max(diagonal, max(max(abs(a[0, 1]), abs(a[0, 2])), abs(a[1, 2])))               <L 17>
    var_16 = wp::extract(var_a, var_14, var_15);
    var_17 = wp::abs(var_16);
    var_20 = wp::extract(var_a, var_18, var_19);
    var_21 = wp::abs(var_20);
    var_22 = wp::max(var_17, var_21);
    var_25 = wp::extract(var_a, var_23, var_24);
    var_26 = wp::abs(var_25);
    var_27 = wp::max(var_22, var_26);
    var_28 = wp::max(var_13, var_27);
    return var_28;
}


// /work/main/src/pointloom/kernels/algebra/eigen.py:20
static CUDA_CALLABLE wp::float64 off_diagonal_0(
    wp::mat_t<3, 3, wp::float64> var_a)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    const wp::int32 var_1 = 1;
    wp::float64 var_2;
    const wp::int32 var_3 = 0;
    const wp::int32 var_4 = 1;
    wp::float64 var_5;
    wp::float64 var_6;
    const wp::int32 var_7 = 0;
    const wp::int32 var_8 = 2;
    wp::float64 var_9;
    const wp::int32 var_10 = 0;
    const wp::int32 var_11 = 2;
    wp::float64 var_12;
    wp::float64 var_13;
    wp::float64 var_14;
    const wp::int32 var_15 = 1;
    const wp::int32 var_16 = 2;
    wp::float64 var_17;
    const wp::int32 var_18 = 1;
    const wp::int32 var_19 = 2;
    wp::float64 var_20;
    wp::float64 var_21;
    wp::float64 var_22;
    //---------
    // forward
    // def off_diagonal(a: mat33d) -> float64:                                                <L 21>
    // return a[0, 1] * a[0, 1] + a[0, 2] * a[0, 2] + a[1, 2] * a[1, 2]                       <L 23>
    var_2 = wp::extract(var_a, var_0, var_1);
    var_5 = wp::extract(var_a, var_3, var_4);
    var_6 = wp::mul(var_2, var_5);
    var_9 = wp::extract(var_a, var_7, var_8);
    var_12 = wp::extract(var_a, var_10, var_11);
    var_13 = wp::mul(var_9, var_12);
    var_14 = wp::add(var_6, var_13);
    var_17 = wp::extract(var_a, var_15, var_16);
    var_20 = wp::extract(var_a, var_18, var_19);
    var_21 = wp::mul(var_17, var_20);
    var_22 = wp::add(var_14, var_21);
    return var_22;
}


// <pointloom.kernels.algebra.eigen.sorted_eigenvalues>:1
static CUDA_CALLABLE wp::vec_t<3, wp::float64> sorted_eigenvalues_0(
    wp::mat_t<3, 3, wp::float64> var_a)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    const wp::int32 var_1 = 0;
    wp::float64 var_2;
    const wp::int32 var_3 = 1;
    const wp::int32 var_4 = 1;
    wp::float64 var_5;
    wp::float64 var_6;
    const wp::int32 var_7 = 2;
    const wp::int32 var_8 = 2;
    wp::float64 var_9;
    wp::float64 var_10;
    wp::float64 var_11;
    wp::float64 var_12;
    const wp::int32 var_13 = 0;
    const wp::int32 var_14 = 0;
    wp::float64 var_15;
    wp::float64 var_16;
    const wp::int32 var_17 = 1;
    const wp::int32 var_18 = 1;
    wp::float64 var_19;
    wp::float64 var_20;
    const wp::int32 var_21 = 2;
    const wp::int32 var_22 = 2;
    wp::float64 var_23;
    wp::float64 var_24;
    wp::float64 var_25;
    wp::float64 var_26;
    wp::float64 var_27;
    wp::float64 var_28;
    wp::float64 var_29;
    wp::float64 var_30;
    wp::float64 var_31;
    wp::float64 var_32;
    wp::float64 var_33;
    wp::float64 var_34;
    wp::float64 var_35;
    wp::float64 var_36;
    wp::vec_t<3, wp::float64> var_37;
    wp::float64 var_38;
    bool var_39;
    wp::float64 var_40;
    wp::float64 var_41;
    wp::float64 var_42;
    wp::float64 var_43;
    wp::float64 var_44;
    const wp::int32 var_45 = 1;
    const wp::int32 var_46 = 2;
    wp::float64 var_47;
    wp::float64 var_48;
    const wp::int32 var_49 = 1;
    const wp::int32 var_50 = 2;
    wp::float64 var_51;
    wp::float64 var_52;
    wp::float64 var_53;
    wp::float64 var_54;
    const wp::int32 var_55 = 0;
    const wp::int32 var_56 = 1;
    wp::float64 var_57;
    wp::float64 var_58;
    wp::float64 var_59;
    wp::float64 var_60;
    const wp::int32 var_61 = 1;
    const wp::int32 var_62 = 2;
    wp::float64 var_63;
    wp::float64 var_64;
    const wp::int32 var_65 = 0;
    const wp::int32 var_66 = 2;
    wp::float64 var_67;
    wp::float64 var_68;
    wp::float64 var_69;
    wp::float64 var_70;
    const wp::int32 var_71 = 0;
    const wp::int32 var_72 = 1;
    wp::float64 var_73;
    wp::float64 var_74;
    const wp::int32 var_75 = 1;
    const wp::int32 var_76 = 2;
    wp::float64 var_77;
    wp::float64 var_78;
    wp::float64 var_79;
    wp::float64 var_80;
    const wp::int32 var_81 = 0;
    const wp::int32 var_82 = 2;
    wp::float64 var_83;
    wp::float64 var_84;
    wp::float64 var_85;
    wp::float64 var_86;
    wp::float64 var_87;
    wp::float64 var_88;
    const wp::int32 var_89 = 0;
    const wp::int32 var_90 = 1;
    wp::float64 var_91;
    wp::float64 var_92;
    wp::float64 var_93;
    wp::float64 var_94;
    const wp::int32 var_95 = 0;
    const wp::int32 var_96 = 2;
    wp::float64 var_97;
    wp::float64 var_98;
    wp::float64 var_99;
    wp::float64 var_100;
    wp::float64 var_101;
    wp::float64 var_102;
    wp::float64 var_103;
    wp::float64 var_104;
    wp::float64 var_105;
    wp::float64 var_106;
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
    wp::float64 var_117;
    wp::float64 var_118;
    wp::float64 var_119;
    wp::float64 var_120;
    wp::float64 var_121;
    wp::float64 var_122;
    wp::float64 var_123;
    wp::float64 var_124;
    wp::vec_t<3, wp::float64> var_125;
    wp::vec_t<3, wp::float64> var_126;
    //---------
    // forward
    // def sorted_eigenvalues(a):                                                             <L 1>
    // q = (a[0, 0] + a[1, 1] + a[2, 2]) / float64(3.0)                                       <L 3>
    var_2 = wp::extract(var_a, var_0, var_1);
    var_5 = wp::extract(var_a, var_3, var_4);
    var_6 = wp::add(var_2, var_5);
    var_9 = wp::extract(var_a, var_7, var_8);
    var_10 = wp::add(var_6, var_9);
    var_11 = 3.0;
    var_12 = wp::div(var_10, var_11);
    // b00 = a[0, 0] - q                                                                      <L 4>
    var_15 = wp::extract(var_a, var_13, var_14);
    var_16 = wp::sub(var_15, var_12);
    // b11 = a[1, 1] - q                                                                      <L 5>
    var_19 = wp::extract(var_a, var_17, var_18);
    var_20 = wp::sub(var_19, var_12);
    // b22 = a[2, 2] - q                                                                      <L 6>
    var_23 = wp::extract(var_a, var_21, var_22);
    var_24 = wp::sub(var_23, var_12);
    // p = sqrt((b00 * b00 + b11 * b11 + b22 * b22 + float64(2.0) * off_diagonal(a)) / float64(6.0))       <L 7>
    var_25 = wp::mul(var_16, var_16);
    var_26 = wp::mul(var_20, var_20);
    var_27 = wp::add(var_25, var_26);
    var_28 = wp::mul(var_24, var_24);
    var_29 = wp::add(var_27, var_28);
    var_30 = 2.0;
    var_31 = off_diagonal_0(var_a);
    var_32 = wp::mul(var_30, var_31);
    var_33 = wp::add(var_29, var_32);
    var_34 = 6.0;
    var_35 = wp::div(var_33, var_34);
    var_36 = wp::sqrt(var_35);
    // values = vec3d(q, q, q)                                                                <L 8>
    var_37 = wp::vec_t<3, wp::float64>(var_12, var_12, var_12);
    // if p > float64(0.0):                                                                   <L 9>
    var_38 = 0.0;
    var_39 = (var_36 > var_38);
    if (var_39) {
        // s = float64(1.0) / p                                                               <L 10>
        var_40 = 1.0;
        var_41 = wp::div(var_40, var_36);
        // c00 = b11 * s * (b22 * s) - a[1, 2] * s * (a[1, 2] * s)                            <L 11>
        var_42 = wp::mul(var_20, var_41);
        var_43 = wp::mul(var_24, var_41);
        var_44 = wp::mul(var_42, var_43);
        var_47 = wp::extract(var_a, var_45, var_46);
        var_48 = wp::mul(var_47, var_41);
        var_51 = wp::extract(var_a, var_49, var_50);
        var_52 = wp::mul(var_51, var_41);
        var_53 = wp::mul(var_48, var_52);
        var_54 = wp::sub(var_44, var_53);
        // c01 = a[0, 1] * s * (b22 * s) - a[1, 2] * s * (a[0, 2] * s)                        <L 12>
        var_57 = wp::extract(var_a, var_55, var_56);
        var_58 = wp::mul(var_57, var_41);
        var_59 = wp::mul(var_24, var_41);
        var_60 = wp::mul(var_58, var_59);
        var_63 = wp::extract(var_a, var_61, var_62);
        var_64 = wp::mul(var_63, var_41);
        var_67 = wp::extract(var_a, var_65, var_66);
        var_68 = wp::mul(var_67, var_41);
        var_69 = wp::mul(var_64, var_68);
        var_70 = wp::sub(var_60, var_69);
        // c02 = a[0, 1] * s * (a[1, 2] * s) - b11 * s * (a[0, 2] * s)                        <L 13>
        var_73 = wp::extract(var_a, var_71, var_72);
        var_74 = wp::mul(var_73, var_41);
        var_77 = wp::extract(var_a, var_75, var_76);
        var_78 = wp::mul(var_77, var_41);
        var_79 = wp::mul(var_74, var_78);
        var_80 = wp::mul(var_20, var_41);
        var_83 = wp::extract(var_a, var_81, var_82);
        var_84 = wp::mul(var_83, var_41);
        var_85 = wp::mul(var_80, var_84);
        var_86 = wp::sub(var_79, var_85);
        // det = b00 * s * c00 - a[0, 1] * s * c01 + a[0, 2] * s * c02                        <L 14>
        var_87 = wp::mul(var_16, var_41);
        var_88 = wp::mul(var_87, var_54);
        var_91 = wp::extract(var_a, var_89, var_90);
        var_92 = wp::mul(var_91, var_41);
        var_93 = wp::mul(var_92, var_70);
        var_94 = wp::sub(var_88, var_93);
        var_97 = wp::extract(var_a, var_95, var_96);
        var_98 = wp::mul(var_97, var_41);
        var_99 = wp::mul(var_98, var_86);
        var_100 = wp::add(var_94, var_99);
        // half = min(max(det * float64(0.5), float64(-1.0)), float64(1.0))                   <L 15>
        var_101 = 0.5;
        var_102 = wp::mul(var_100, var_101);
        var_103 = -1.0;
        var_104 = wp::max(var_102, var_103);
        var_105 = 1.0;
        var_106 = wp::min(var_104, var_105);
        // angle = acos(half) / float64(3.0)                                                  <L 16>
        var_107 = wp::acos(var_106);
        var_108 = 3.0;
        var_109 = wp::div(var_107, var_108);
        // high = float64(2.0) * cos(angle)                                                   <L 17>
        var_110 = 2.0;
        var_111 = wp::cos(var_109);
        var_112 = wp::mul(var_110, var_111);
        // low = float64(2.0) * cos(angle + float64(TWO_THIRDS_PI))                           <L 18>
        var_113 = 2.0;
        var_114 = 2.0943951023931953;
        var_115 = wp::add(var_109, var_114);
        var_116 = wp::cos(var_115);
        var_117 = wp::mul(var_113, var_116);
        // values = vec3d(q + p * low, q - p * (low + high), q + p * high)                    <L 19>
        var_118 = wp::mul(var_36, var_117);
        var_119 = wp::add(var_12, var_118);
        var_120 = wp::add(var_117, var_112);
        var_121 = wp::mul(var_36, var_120);
        var_122 = wp::sub(var_12, var_121);
        var_123 = wp::mul(var_36, var_112);
        var_124 = wp::add(var_12, var_123);
        var_125 = wp::vec_t<3, wp::float64>(var_119, var_122, var_124);
    }
    var_126 = wp::where(var_39, var_125, var_37);
    // return values                                                                          <L 20>
    return var_126;
}


// <pointloom.kernels.algebra.eigen.separated_eigenvector>:1
static CUDA_CALLABLE wp::vec_t<3, wp::float64> separated_eigenvector_0(
    wp::mat_t<3, 3, wp::float64> var_a,
    wp::float64 var_value)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    const wp::int32 var_1 = 0;
    wp::float64 var_2;
    wp::float64 var_3;
    const wp::int32 var_4 = 0;
    const wp::int32 var_5 = 1;
    wp::float64 var_6;
    const wp::int32 var_7 = 0;
    const wp::int32 var_8 = 2;
    wp::float64 var_9;
    wp::vec_t<3, wp::float64> var_10;
    const wp::int32 var_11 = 0;
    const wp::int32 var_12 = 1;
    wp::float64 var_13;
    const wp::int32 var_14 = 1;
    const wp::int32 var_15 = 1;
    wp::float64 var_16;
    wp::float64 var_17;
    const wp::int32 var_18 = 1;
    const wp::int32 var_19 = 2;
    wp::float64 var_20;
    wp::vec_t<3, wp::float64> var_21;
    const wp::int32 var_22 = 0;
    const wp::int32 var_23 = 2;
    wp::float64 var_24;
    const wp::int32 var_25 = 1;
    const wp::int32 var_26 = 2;
    wp::float64 var_27;
    const wp::int32 var_28 = 2;
    const wp::int32 var_29 = 2;
    wp::float64 var_30;
    wp::float64 var_31;
    wp::vec_t<3, wp::float64> var_32;
    wp::vec_t<3, wp::float64> var_33;
    wp::float64 var_34;
    wp::vec_t<3, wp::float64> var_35;
    wp::float64 var_36;
    bool var_37;
    wp::vec_t<3, wp::float64> var_38;
    wp::float64 var_39;
    wp::vec_t<3, wp::float64> var_40;
    wp::float64 var_41;
    wp::vec_t<3, wp::float64> var_42;
    wp::float64 var_43;
    bool var_44;
    wp::vec_t<3, wp::float64> var_45;
    wp::float64 var_46;
    wp::vec_t<3, wp::float64> var_47;
    wp::float64 var_48;
    wp::float64 var_49;
    wp::float64 var_50;
    wp::float64 var_51;
    wp::vec_t<3, wp::float64> var_52;
    wp::float64 var_53;
    bool var_54;
    wp::float64 var_55;
    wp::vec_t<3, wp::float64> var_56;
    wp::vec_t<3, wp::float64> var_57;
    //---------
    // forward
    // def separated_eigenvector(a, value):                                                   <L 1>
    // r0 = vec3d(a[0, 0] - value, a[0, 1], a[0, 2])                                          <L 3>
    var_2 = wp::extract(var_a, var_0, var_1);
    var_3 = wp::sub(var_2, var_value);
    var_6 = wp::extract(var_a, var_4, var_5);
    var_9 = wp::extract(var_a, var_7, var_8);
    var_10 = wp::vec_t<3, wp::float64>(var_3, var_6, var_9);
    // r1 = vec3d(a[0, 1], a[1, 1] - value, a[1, 2])                                          <L 4>
    var_13 = wp::extract(var_a, var_11, var_12);
    var_16 = wp::extract(var_a, var_14, var_15);
    var_17 = wp::sub(var_16, var_value);
    var_20 = wp::extract(var_a, var_18, var_19);
    var_21 = wp::vec_t<3, wp::float64>(var_13, var_17, var_20);
    // r2 = vec3d(a[0, 2], a[1, 2], a[2, 2] - value)                                          <L 5>
    var_24 = wp::extract(var_a, var_22, var_23);
    var_27 = wp::extract(var_a, var_25, var_26);
    var_30 = wp::extract(var_a, var_28, var_29);
    var_31 = wp::sub(var_30, var_value);
    var_32 = wp::vec_t<3, wp::float64>(var_24, var_27, var_31);
    // best = cross(r0, r1)                                                                   <L 6>
    var_33 = wp::cross(var_10, var_21);
    // size = dot(best, best)                                                                 <L 7>
    var_34 = wp::dot(var_33, var_33);
    // other = cross(r0, r2)                                                                  <L 8>
    var_35 = wp::cross(var_10, var_32);
    // if dot(other, other) > size:                                                           <L 9>
    var_36 = wp::dot(var_35, var_35);
    var_37 = (var_36 > var_34);
    if (var_37) {
        // best = other                                                                       <L 10>
        var_38 = wp::copy(var_35);
        // size = dot(other, other)                                                           <L 11>
        var_39 = wp::dot(var_35, var_35);
    }
    var_40 = wp::where(var_37, var_38, var_33);
    var_41 = wp::where(var_37, var_39, var_34);
    // other = cross(r1, r2)                                                                  <L 12>
    var_42 = wp::cross(var_21, var_32);
    // if dot(other, other) > size:                                                           <L 13>
    var_43 = wp::dot(var_42, var_42);
    var_44 = (var_43 > var_41);
    if (var_44) {
        // best = other                                                                       <L 14>
        var_45 = wp::copy(var_42);
        // size = dot(other, other)                                                           <L 15>
        var_46 = wp::dot(var_42, var_42);
    }
    var_47 = wp::where(var_44, var_45, var_40);
    var_48 = wp::where(var_44, var_46, var_41);
    // unit = vec3d(float64(0.0), float64(0.0), float64(1.0))                                 <L 16>
    var_49 = 0.0;
    var_50 = 0.0;
    var_51 = 1.0;
    var_52 = wp::vec_t<3, wp::float64>(var_49, var_50, var_51);
    // if size > float64(0.0):                                                                <L 17>
    var_53 = 0.0;
    var_54 = (var_48 > var_53);
    if (var_54) {
        // unit = best / sqrt(size)                                                           <L 18>
        var_55 = wp::sqrt(var_48);
        var_56 = wp::div(var_47, var_55);
    }
    var_57 = wp::where(var_54, var_56, var_52);
    // return unit                                                                            <L 19>
    return var_57;
}


// <pointloom.kernels.algebra.eigen.orthogonal_direction>:1
static CUDA_CALLABLE wp::vec_t<3, wp::float64> orthogonal_direction_0(
    wp::vec_t<3, wp::float64> var_w)
{
    //---------
    // primal vars
    wp::float64 var_0;
    const wp::int32 var_1 = 2;
    wp::float64 var_2;
    const wp::int32 var_3 = 1;
    wp::float64 var_4;
    wp::float64 var_5;
    wp::vec_t<3, wp::float64> var_6;
    const wp::int32 var_7 = 0;
    wp::float64 var_8;
    wp::float64 var_9;
    const wp::int32 var_10 = 1;
    wp::float64 var_11;
    wp::float64 var_12;
    bool var_13;
    const wp::int32 var_14 = 2;
    wp::float64 var_15;
    wp::float64 var_16;
    wp::float64 var_17;
    const wp::int32 var_18 = 0;
    wp::float64 var_19;
    wp::vec_t<3, wp::float64> var_20;
    wp::vec_t<3, wp::float64> var_21;
    wp::float64 var_22;
    wp::float64 var_23;
    wp::vec_t<3, wp::float64> var_24;
    //---------
    // forward
    // def orthogonal_direction(w):                                                           <L 1>
    // u = vec3d(float64(0.0), w[2], -w[1])                                                   <L 2>
    var_0 = 0.0;
    var_2 = wp::extract(var_w, var_1);
    var_4 = wp::extract(var_w, var_3);
    var_5 = wp::neg(var_4);
    var_6 = wp::vec_t<3, wp::float64>(var_0, var_2, var_5);
    // if abs(w[0]) > abs(w[1]):                                                              <L 3>
    var_8 = wp::extract(var_w, var_7);
    var_9 = wp::abs(var_8);
    var_11 = wp::extract(var_w, var_10);
    var_12 = wp::abs(var_11);
    var_13 = (var_9 > var_12);
    if (var_13) {
        // u = vec3d(-w[2], float64(0.0), w[0])                                               <L 4>
        var_15 = wp::extract(var_w, var_14);
        var_16 = wp::neg(var_15);
        var_17 = 0.0;
        var_19 = wp::extract(var_w, var_18);
        var_20 = wp::vec_t<3, wp::float64>(var_16, var_17, var_19);
    }
    var_21 = wp::where(var_13, var_20, var_6);
    // return u / sqrt(dot(u, u))                                                             <L 5>
    var_22 = wp::dot(var_21, var_21);
    var_23 = wp::sqrt(var_22);
    var_24 = wp::div(var_21, var_23);
    return var_24;
}


// <pointloom.kernels.algebra.eigen.smallest_in_plane>:1
static CUDA_CALLABLE wp::vec_t<3, wp::float64> smallest_in_plane_0(
    wp::mat_t<3, 3, wp::float64> var_a,
    wp::vec_t<3, wp::float64> var_w)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float64> var_0;
    wp::vec_t<3, wp::float64> var_1;
    wp::vec_t<3, wp::float64> var_2;
    wp::vec_t<3, wp::float64> var_3;
    wp::float64 var_4;
    wp::float64 var_5;
    wp::float64 var_6;
    wp::float64 var_7;
    wp::float64 var_8;
    wp::float64 var_9;
    wp::float64 var_10;
    wp::float64 var_11;
    wp::float64 var_12;
    wp::float64 var_13;
    wp::float64 var_14;
    wp::float64 var_15;
    bool var_16;
    wp::float64 var_17;
    wp::float64 var_18;
    wp::float64 var_19;
    wp::float64 var_20;
    wp::float64 var_21;
    wp::float64 var_22;
    wp::float64 var_23;
    wp::float64 var_24;
    wp::float64 var_25;
    bool var_26;
    wp::float64 var_27;
    wp::float64 var_28;
    wp::float64 var_29;
    wp::float64 var_30;
    wp::float64 var_31;
    wp::float64 var_32;
    wp::float64 var_33;
    wp::float64 var_34;
    wp::float64 var_35;
    wp::float64 var_36;
    wp::float64 var_37;
    wp::float64 var_38;
    wp::float64 var_39;
    wp::float64 var_40;
    wp::float64 var_41;
    wp::float64 var_42;
    wp::vec_t<3, wp::float64> var_43;
    wp::vec_t<3, wp::float64> var_44;
    wp::vec_t<3, wp::float64> var_45;
    //---------
    // forward
    // def smallest_in_plane(a, w):                                                           <L 1>
    // u = orthogonal_direction(w)                                                            <L 3>
    var_0 = orthogonal_direction_0(var_w);
    // v = cross(w, u)                                                                        <L 4>
    var_1 = wp::cross(var_w, var_0);
    // au = a @ u                                                                             <L 5>
    var_2 = wp::mul(var_a, var_0);
    // av = a @ v                                                                             <L 6>
    var_3 = wp::mul(var_a, var_1);
    // half = (dot(u, au) - dot(v, av)) * float64(0.5)                                        <L 7>
    var_4 = wp::dot(var_0, var_2);
    var_5 = wp::dot(var_1, var_3);
    var_6 = wp::sub(var_4, var_5);
    var_7 = 0.5;
    var_8 = wp::mul(var_6, var_7);
    // mixed = dot(u, av)                                                                     <L 8>
    var_9 = wp::dot(var_0, var_3);
    // size = max(abs(half), abs(mixed))                                                      <L 9>
    var_10 = wp::abs(var_8);
    var_11 = wp::abs(var_9);
    var_12 = wp::max(var_10, var_11);
    // x = float64(0.0)                                                                       <L 10>
    var_13 = 0.0;
    // y = float64(-1.0)                                                                      <L 11>
    var_14 = -1.0;
    // if size > float64(0.0):                                                                <L 12>
    var_15 = 0.0;
    var_16 = (var_12 > var_15);
    if (var_16) {
        // half = half / size                                                                 <L 13>
        var_17 = wp::div(var_8, var_12);
        // mixed = mixed / size                                                               <L 14>
        var_18 = wp::div(var_9, var_12);
        // larger = abs(half) + sqrt(half * half + mixed * mixed)                             <L 15>
        var_19 = wp::abs(var_17);
        var_20 = wp::mul(var_17, var_17);
        var_21 = wp::mul(var_18, var_18);
        var_22 = wp::add(var_20, var_21);
        var_23 = wp::sqrt(var_22);
        var_24 = wp::add(var_19, var_23);
        // if half > float64(0.0):                                                            <L 16>
        var_25 = 0.0;
        var_26 = (var_17 > var_25);
        if (var_26) {
            // x = mixed                                                                      <L 17>
            var_27 = wp::copy(var_18);
            // y = -larger                                                                    <L 18>
            var_28 = wp::neg(var_24);
        }
        if (!var_26) {
            // x = -larger                                                                    <L 20>
            var_29 = wp::neg(var_24);
            // y = mixed                                                                      <L 21>
            var_30 = wp::copy(var_18);
        }
        var_31 = wp::where(var_26, var_27, var_29);
        var_32 = wp::where(var_26, var_28, var_30);
        // length = sqrt(x * x + y * y)                                                       <L 22>
        var_33 = wp::mul(var_31, var_31);
        var_34 = wp::mul(var_32, var_32);
        var_35 = wp::add(var_33, var_34);
        var_36 = wp::sqrt(var_35);
        // x = x / length                                                                     <L 23>
        var_37 = wp::div(var_31, var_36);
        // y = y / length                                                                     <L 24>
        var_38 = wp::div(var_32, var_36);
    }
    var_39 = wp::where(var_16, var_17, var_8);
    var_40 = wp::where(var_16, var_18, var_9);
    var_41 = wp::where(var_16, var_37, var_13);
    var_42 = wp::where(var_16, var_38, var_14);
    // return u * x + v * y                                                                   <L 25>
    var_43 = wp::mul(var_0, var_41);
    var_44 = wp::mul(var_1, var_42);
    var_45 = wp::add(var_43, var_44);
    return var_45;
}


// <pointloom.kernels.algebra.eigen.smallest_eigenvector>:1
static CUDA_CALLABLE wp::vec_t<3, wp::float64> smallest_eigenvector_0(
    wp::mat_t<3, 3, wp::float64> var_covariance)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::float64 var_1;
    wp::float64 var_2;
    wp::vec_t<3, wp::float64> var_3;
    wp::float64 var_4;
    wp::float64 var_5;
    bool var_6;
    wp::float64 var_7;
    wp::float64 var_8;
    wp::mat_t<3, 3, wp::float64> var_9;
    wp::float64 var_10;
    wp::float64 var_11;
    bool var_12;
    wp::vec_t<3, wp::float64> var_13;
    const wp::int32 var_14 = 1;
    wp::float64 var_15;
    const wp::int32 var_16 = 0;
    wp::float64 var_17;
    wp::float64 var_18;
    const wp::int32 var_19 = 2;
    wp::float64 var_20;
    const wp::int32 var_21 = 1;
    wp::float64 var_22;
    wp::float64 var_23;
    bool var_24;
    const wp::int32 var_25 = 0;
    wp::float64 var_26;
    wp::vec_t<3, wp::float64> var_27;
    const wp::int32 var_28 = 2;
    wp::float64 var_29;
    wp::vec_t<3, wp::float64> var_30;
    wp::vec_t<3, wp::float64> var_31;
    wp::vec_t<3, wp::float64> var_32;
    bool var_33;
    const wp::int32 var_34 = 0;
    const wp::int32 var_35 = 0;
    wp::float64 var_36;
    const wp::int32 var_37 = 2;
    const wp::int32 var_38 = 2;
    wp::float64 var_39;
    bool var_40;
    const wp::int32 var_41 = 0;
    const wp::int32 var_42 = 0;
    wp::float64 var_43;
    const wp::int32 var_44 = 1;
    const wp::int32 var_45 = 1;
    wp::float64 var_46;
    bool var_47;
    wp::float64 var_48;
    wp::float64 var_49;
    wp::float64 var_50;
    wp::vec_t<3, wp::float64> var_51;
    wp::vec_t<3, wp::float64> var_52;
    bool var_53;
    const wp::int32 var_54 = 1;
    const wp::int32 var_55 = 1;
    wp::float64 var_56;
    const wp::int32 var_57 = 2;
    const wp::int32 var_58 = 2;
    wp::float64 var_59;
    bool var_60;
    const wp::int32 var_61 = 1;
    const wp::int32 var_62 = 1;
    wp::float64 var_63;
    const wp::int32 var_64 = 0;
    const wp::int32 var_65 = 0;
    wp::float64 var_66;
    bool var_67;
    wp::float64 var_68;
    wp::float64 var_69;
    wp::float64 var_70;
    wp::vec_t<3, wp::float64> var_71;
    wp::vec_t<3, wp::float64> var_72;
    wp::vec_t<3, wp::float64> var_73;
    wp::vec_t<3, wp::float64> var_74;
    //---------
    // forward
    // def smallest_eigenvector(covariance):                                                  <L 1>
    // result = vec3d(float64(0.0), float64(0.0), float64(1.0))                               <L 3>
    var_0 = 0.0;
    var_1 = 0.0;
    var_2 = 1.0;
    var_3 = wp::vec_t<3, wp::float64>(var_0, var_1, var_2);
    // size = largest_entry(covariance)                                                       <L 4>
    var_4 = largest_entry_0(var_covariance);
    // if size > float64(0.0):                                                                <L 5>
    var_5 = 0.0;
    var_6 = (var_4 > var_5);
    if (var_6) {
        // a = covariance * (float64(1.0) / size)                                             <L 6>
        var_7 = 1.0;
        var_8 = wp::div(var_7, var_4);
        var_9 = wp::mul(var_covariance, var_8);
        // if off_diagonal(a) > float64(0.0):                                                 <L 7>
        var_10 = off_diagonal_0(var_9);
        var_11 = 0.0;
        var_12 = (var_10 > var_11);
        if (var_12) {
            // values = sorted_eigenvalues(a)                                                 <L 8>
            var_13 = sorted_eigenvalues_0(var_9);
            // if values[1] - values[0] >= values[2] - values[1]:                             <L 9>
            var_15 = wp::extract(var_13, var_14);
            var_17 = wp::extract(var_13, var_16);
            var_18 = wp::sub(var_15, var_17);
            var_20 = wp::extract(var_13, var_19);
            var_22 = wp::extract(var_13, var_21);
            var_23 = wp::sub(var_20, var_22);
            var_24 = (var_18 >= var_23);
            if (var_24) {
                // result = separated_eigenvector(a, values[0])                               <L 10>
                var_26 = wp::extract(var_13, var_25);
                var_27 = separated_eigenvector_0(var_9, var_26);
            }
            if (!var_24) {
                // result = smallest_in_plane(a, separated_eigenvector(a, values[2]))         <L 12>
                var_29 = wp::extract(var_13, var_28);
                var_30 = separated_eigenvector_0(var_9, var_29);
                var_31 = smallest_in_plane_0(var_9, var_30);
            }
            var_32 = wp::where(var_24, var_27, var_31);
        }
        if (!var_12) {
            // if a[0, 0] < a[2, 2] and a[0, 0] <= a[1, 1]:                                   <L 14>
            var_36 = wp::extract(var_9, var_34, var_35);
            var_39 = wp::extract(var_9, var_37, var_38);
            var_40 = (var_36 < var_39);
            var_33 = var_40;
            if (var_33) {
                var_43 = wp::extract(var_9, var_41, var_42);
                var_46 = wp::extract(var_9, var_44, var_45);
                var_47 = (var_43 <= var_46);
                var_33 = var_33 && var_47;
            }
            if (var_33) {
                // result = vec3d(float64(1.0), float64(0.0), float64(0.0))                   <L 15>
                var_48 = 1.0;
                var_49 = 0.0;
                var_50 = 0.0;
                var_51 = wp::vec_t<3, wp::float64>(var_48, var_49, var_50);
            }
            var_52 = wp::where(var_33, var_51, var_3);
            // if a[1, 1] < a[2, 2] and a[1, 1] < a[0, 0]:                                    <L 16>
            var_56 = wp::extract(var_9, var_54, var_55);
            var_59 = wp::extract(var_9, var_57, var_58);
            var_60 = (var_56 < var_59);
            var_53 = var_60;
            if (var_53) {
                var_63 = wp::extract(var_9, var_61, var_62);
                var_66 = wp::extract(var_9, var_64, var_65);
                var_67 = (var_63 < var_66);
                var_53 = var_53 && var_67;
            }
            if (var_53) {
                // result = vec3d(float64(0.0), float64(1.0), float64(0.0))                   <L 17>
                var_68 = 0.0;
                var_69 = 1.0;
                var_70 = 0.0;
                var_71 = wp::vec_t<3, wp::float64>(var_68, var_69, var_70);
            }
            var_72 = wp::where(var_53, var_71, var_52);
        }
        var_73 = wp::where(var_12, var_32, var_72);
    }
    var_74 = wp::where(var_6, var_73, var_3);
    // return result                                                                          <L 18>
    return var_74;
}


// /work/main/src/pointloom/kernels/surface/normals.py:27
static CUDA_CALLABLE wp::vec_t<3, wp::float32> normal_of_0(
    wp::vec_t<10, wp::float64> var_m)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 0.0;
    const wp::float32 var_1 = 0.0;
    const wp::float32 var_2 = 1.0;
    wp::vec_t<3, wp::float32> var_3;
    const wp::int32 var_4 = 0;
    wp::float64 var_5;
    wp::float64 var_6;
    bool var_7;
    wp::mat_t<3, 3, wp::float64> var_8;
    wp::vec_t<3, wp::float64> var_9;
    const wp::int32 var_10 = 0;
    wp::float64 var_11;
    wp::float32 var_12;
    const wp::int32 var_13 = 1;
    wp::float64 var_14;
    wp::float32 var_15;
    const wp::int32 var_16 = 2;
    wp::float64 var_17;
    wp::float32 var_18;
    wp::vec_t<3, wp::float32> var_19;
    wp::vec_t<3, wp::float32> var_20;
    //---------
    // forward
    // def normal_of(m: moments) -> vec3:                                                     <L 28>
    // n = vec3(0.0, 0.0, 1.0)                                                                <L 30>
    var_3 = wp::vec_t<3, wp::float32>(var_0, var_1, var_2);
    // if m[0] >= float64(MIN_NEIGHBORS):                                                     <L 31>
    var_5 = wp::extract(var_m, var_4);
    var_6 = 3.0;
    var_7 = (var_5 >= var_6);
    if (var_7) {
        // v = smallest_eigenvector(covariance_of(m))                                         <L 32>
        var_8 = covariance_of_0(var_m);
        var_9 = smallest_eigenvector_0(var_8);
        // n = vec3(float(v[0]), float(v[1]), float(v[2]))                                    <L 33>
        var_11 = wp::extract(var_9, var_10);
        var_12 = wp::float(var_11);
        var_14 = wp::extract(var_9, var_13);
        var_15 = wp::float(var_14);
        var_17 = wp::extract(var_9, var_16);
        var_18 = wp::float(var_17);
        var_19 = wp::vec_t<3, wp::float32>(var_12, var_15, var_18);
    }
    var_20 = wp::where(var_7, var_19, var_3);
    // return n                                                                               <L 34>
    return var_20;
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:154
static CUDA_CALLABLE void adj__lane_0(
    wp::int32 & adj_ret)
{
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


// /work/main/src/pointloom/kernels/arrays/lanes.py:9
static CUDA_CALLABLE void adj_lane_min_on_cuda_0(
    wp::float32 var_x,
    wp::float32 & adj_x,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/arrays/lanes.py:33
static CUDA_CALLABLE void adj_lane_min_corner_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/arrays/lanes.py:17
static CUDA_CALLABLE void adj_lane_max_on_cuda_0(
    wp::float32 var_x,
    wp::float32 & adj_x,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/arrays/lanes.py:39
static CUDA_CALLABLE void adj_lane_max_corner_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float32> & adj_ret)
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


// <pointloom.kernels.search.lane_search.guess_sqradius>:1
static CUDA_CALLABLE void adj_guess_sqradius_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::int32 var_bucket,
    wp::int32 var_k,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::int32 & adj_bucket,
    wp::int32 & adj_k,
    wp::array_t<wp::float32> & adj_tree__boxes,
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


// <pointloom.kernels.search.lane_search.keep_for_lanes>:1
static CUDA_CALLABLE void adj_keep_for_lanes_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::int32 var_start,
    wp::float32 var_guess,
    wp::int32 var_tree__count,
    wp::int32 var_tree__root,
    wp::array_t<wp::int32> var_tree__levels,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> var_tree__points,
    wp::array_t<wp::int32> var_scratch__ids,
    wp::array_t<wp::int64> var_scratch__keys,
    wp::int32 var_scratch__k,
    wp::int32 var_scratch__room,
    wp::int32 var_scratch__gather,
    wp::int32 var_scratch__stride,
    wp::int32 var_listing,
    wp::int32 var_base,
    wp::float32 var_max_sqdist,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::int32 & adj_start,
    wp::float32 & adj_guess,
    wp::int32 & adj_tree__count,
    wp::int32 & adj_tree__root,
    wp::array_t<wp::int32> & adj_tree__levels,
    wp::array_t<wp::float32> & adj_tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_tree__points,
    wp::array_t<wp::int32> & adj_scratch__ids,
    wp::array_t<wp::int64> & adj_scratch__keys,
    wp::int32 & adj_scratch__k,
    wp::int32 & adj_scratch__room,
    wp::int32 & adj_scratch__gather,
    wp::int32 & adj_scratch__stride,
    wp::int32 & adj_listing,
    wp::int32 & adj_base,
    wp::float32 & adj_max_sqdist,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.lane_search.keep_nearer>:1
static CUDA_CALLABLE void adj_keep_nearer_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::float32 var_max_sqdist,
    wp::int32 var_near_count,
    wp::array_t<wp::vec_t<3, wp::float32>> var_tree__points,
    wp::array_t<wp::int32> var_scratch__ids,
    wp::array_t<wp::int64> var_scratch__keys,
    wp::int32 var_scratch__k,
    wp::int32 var_scratch__room,
    wp::int32 var_scratch__stride,
    wp::int32 var_listing,
    wp::int32 var_size,
    wp::int32 var_base,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::float32 & adj_max_sqdist,
    wp::int32 & adj_near_count,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_tree__points,
    wp::array_t<wp::int32> & adj_scratch__ids,
    wp::array_t<wp::int64> & adj_scratch__keys,
    wp::int32 & adj_scratch__k,
    wp::int32 & adj_scratch__room,
    wp::int32 & adj_scratch__stride,
    wp::int32 & adj_listing,
    wp::int32 & adj_size,
    wp::int32 & adj_base,
    wp::vec_t<2, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.arrays.packed_keys.key_limit>:1
static CUDA_CALLABLE void adj_key_limit_0(
    wp::float32 var_number,
    wp::float32 & adj_number,
    wp::int64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.point_tree.is_one_point>:1
static CUDA_CALLABLE void adj_is_one_point_0(
    wp::array_t<wp::float32> var_boxes,
    wp::int32 var_node,
    wp::int32 var_child,
    wp::array_t<wp::float32> & adj_boxes,
    wp::int32 & adj_node,
    wp::int32 & adj_child,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.k_nearest.offer_leaves_one_by_one>:1
static CUDA_CALLABLE void adj_offer_leaves_one_by_one_on_cuda_0(
    wp::int32 var_bucket,
    wp::vec_t<3, wp::float32> var_p,
    wp::int32 var_tree__count,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> var_tree__points,
    wp::array_t<wp::int32> var_labels,
    wp::array_t<wp::int64> var_keys,
    wp::int32 var_base,
    wp::int32 var_stride,
    wp::int32 var_key_count,
    wp::float32 var_max_sqdist,
    wp::int64 var_limit,
    wp::int32 & adj_bucket,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::int32 & adj_tree__count,
    wp::array_t<wp::float32> & adj_tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_tree__points,
    wp::array_t<wp::int32> & adj_labels,
    wp::array_t<wp::int64> & adj_keys,
    wp::int32 & adj_base,
    wp::int32 & adj_stride,
    wp::int32 & adj_key_count,
    wp::float32 & adj_max_sqdist,
    wp::int64 & adj_limit,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.bucket_walk.pass_over_equal_one_by_one>:1
static CUDA_CALLABLE void adj_pass_over_equal_one_by_one_on_cuda_0(
    wp::vec_t<4, wp::int64> var_step,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::int64 var_limit,
    wp::array_t<wp::int32> var_tree__levels,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::array_t<wp::int32> var_labels,
    wp::vec_t<4, wp::int64> & adj_step,
    wp::vec_t<3, wp::float32> & adj_a,
    wp::vec_t<3, wp::float32> & adj_b,
    wp::int64 & adj_limit,
    wp::array_t<wp::int32> & adj_tree__levels,
    wp::array_t<wp::float32> & adj_tree__boxes,
    wp::array_t<wp::int32> & adj_labels,
    wp::vec_t<4, wp::int64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
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


// <pointloom.kernels.search.neighbor_keys.count_up_to>:1
static CUDA_CALLABLE void adj_count_up_to_0(
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


// <pointloom.kernels.search.neighbor_keys.limit_between>:1
static CUDA_CALLABLE void adj_limit_between_on_cuda_0(
    wp::array_t<wp::int64> var_keys,
    wp::int32 var_base,
    wp::int32 var_stride,
    wp::int32 var_key_count,
    wp::int32 var_k,
    wp::float32 var_max_sqdist,
    wp::array_t<wp::int64> & adj_keys,
    wp::int32 & adj_base,
    wp::int32 & adj_stride,
    wp::int32 & adj_key_count,
    wp::int32 & adj_k,
    wp::float32 & adj_max_sqdist,
    wp::int64 & adj_ret)
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


// <pointloom.kernels.search.neighbor_keys.sort_by_network>:1
static CUDA_CALLABLE void adj_sort_by_network_on_cuda_0(
    wp::array_t<wp::int64> var_keys,
    wp::int32 var_base,
    wp::int32 var_stride,
    wp::int32 var_size,
    wp::array_t<wp::int64> & adj_keys,
    wp::int32 & adj_base,
    wp::int32 & adj_stride,
    wp::int32 & adj_size)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/search/neighbor_keys.py:207
static CUDA_CALLABLE void adj_pick_nearest_on_cuda_0(
    wp::array_t<wp::int64> var_keys,
    wp::int32 var_base,
    wp::int32 var_stride,
    wp::int32 var_key_count,
    wp::int32 var_k,
    wp::int32 var_room,
    wp::array_t<wp::int64> & adj_keys,
    wp::int32 & adj_base,
    wp::int32 & adj_stride,
    wp::int32 & adj_key_count,
    wp::int32 & adj_k,
    wp::int32 & adj_room,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.bucket_walk.children_one_by_one>:1
static CUDA_CALLABLE void adj_children_one_by_one_on_cuda_0(
    wp::array_t<wp::int32> var_levels,
    wp::array_t<wp::float32> var_boxes,
    wp::vec_t<3, wp::float32> var_p,
    wp::float32 var_bound,
    wp::int32 var_level,
    wp::int32 var_node,
    wp::array_t<wp::int32> & adj_levels,
    wp::array_t<wp::float32> & adj_boxes,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::float32 & adj_bound,
    wp::int32 & adj_level,
    wp::int32 & adj_node,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.bucket_walk.next_step__children_one_by_one>:1
static CUDA_CALLABLE void adj_next_step__children_one_by_one_on_cuda_0(
    wp::vec_t<4, wp::int64> var_step,
    wp::int32 var_root,
    wp::array_t<wp::int32> var_children__levels,
    wp::array_t<wp::float32> var_children__boxes,
    wp::vec_t<3, wp::float32> var_children__p,
    wp::float32 var_children__bound,
    wp::vec_t<4, wp::int64> & adj_step,
    wp::int32 & adj_root,
    wp::array_t<wp::int32> & adj_children__levels,
    wp::array_t<wp::float32> & adj_children__boxes,
    wp::vec_t<3, wp::float32> & adj_children__p,
    wp::float32 & adj_children__bound,
    wp::vec_t<4, wp::int64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.bucket_walk.next_bucket_one_by_one>:1
static CUDA_CALLABLE void adj_next_bucket_one_by_one_on_cuda_0(
    wp::vec_t<4, wp::int64> var_step,
    wp::vec_t<3, wp::float32> var_p,
    wp::float32 var_bound,
    wp::int32 var_tree__root,
    wp::array_t<wp::int32> var_tree__levels,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::vec_t<4, wp::int64> & adj_step,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::float32 & adj_bound,
    wp::int32 & adj_tree__root,
    wp::array_t<wp::int32> & adj_tree__levels,
    wp::array_t<wp::float32> & adj_tree__boxes,
    wp::vec_t<4, wp::int64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.k_nearest.search_with_one_pick>:1
static CUDA_CALLABLE void adj_search_with_one_pick_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::int32 var_start,
    wp::int32 var_tree__count,
    wp::int32 var_tree__root,
    wp::array_t<wp::int32> var_tree__levels,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> var_tree__points,
    wp::array_t<wp::int32> var_labels,
    wp::array_t<wp::int64> var_keys,
    wp::int32 var_base,
    wp::int32 var_stride,
    wp::int32 var_k,
    wp::int32 var_room,
    wp::float32 var_max_sqdist,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::int32 & adj_start,
    wp::int32 & adj_tree__count,
    wp::int32 & adj_tree__root,
    wp::array_t<wp::int32> & adj_tree__levels,
    wp::array_t<wp::float32> & adj_tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_tree__points,
    wp::array_t<wp::int32> & adj_labels,
    wp::array_t<wp::int64> & adj_keys,
    wp::int32 & adj_base,
    wp::int32 & adj_stride,
    wp::int32 & adj_k,
    wp::int32 & adj_room,
    wp::float32 & adj_max_sqdist,
    wp::int32 & adj_ret)
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


// <pointloom.kernels.search.lane_search.name_keys>:1
static CUDA_CALLABLE void adj_name_keys_on_cuda_0(
    wp::array_t<wp::int32> var_labels,
    wp::array_t<wp::int64> var_scratch__keys,
    wp::int32 var_scratch__stride,
    wp::int32 var_base,
    wp::int32 var_key_count,
    wp::array_t<wp::int32> & adj_labels,
    wp::array_t<wp::int64> & adj_scratch__keys,
    wp::int32 & adj_scratch__stride,
    wp::int32 & adj_base,
    wp::int32 & adj_key_count)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.lane_search.search_lanes>:1
static CUDA_CALLABLE void adj_search_lanes_on_cuda_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::int32 var_is_query,
    wp::int32 var_start,
    wp::float32 var_guess,
    wp::int32 var_tree__count,
    wp::int32 var_tree__root,
    wp::array_t<wp::int32> var_tree__levels,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> var_tree__points,
    wp::array_t<wp::int32> var_labels,
    wp::array_t<wp::int32> var_scratch__ids,
    wp::array_t<wp::int64> var_scratch__keys,
    wp::int32 var_scratch__k,
    wp::int32 var_scratch__room,
    wp::int32 var_scratch__gather,
    wp::int32 var_scratch__stride,
    wp::int32 var_thread,
    wp::float32 var_max_sqdist,
    wp::int32 var_by_position,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::int32 & adj_is_query,
    wp::int32 & adj_start,
    wp::float32 & adj_guess,
    wp::int32 & adj_tree__count,
    wp::int32 & adj_tree__root,
    wp::array_t<wp::int32> & adj_tree__levels,
    wp::array_t<wp::float32> & adj_tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_tree__points,
    wp::array_t<wp::int32> & adj_labels,
    wp::array_t<wp::int32> & adj_scratch__ids,
    wp::array_t<wp::int64> & adj_scratch__keys,
    wp::int32 & adj_scratch__k,
    wp::int32 & adj_scratch__room,
    wp::int32 & adj_scratch__gather,
    wp::int32 & adj_scratch__stride,
    wp::int32 & adj_thread,
    wp::float32 & adj_max_sqdist,
    wp::int32 & adj_by_position,
    wp::vec_t<2, wp::int32> & adj_ret)
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


// <pointloom.kernels.search.group_search.farthest_key>:1
static CUDA_CALLABLE void adj_farthest_key_on_cuda_0(
    wp::array_t<wp::int64> var_scratch__keys,
    wp::int32 var_scratch__stride,
    wp::int32 var_base,
    wp::int32 var_size,
    wp::array_t<wp::int64> & adj_scratch__keys,
    wp::int32 & adj_scratch__stride,
    wp::int32 & adj_base,
    wp::int32 & adj_size,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/algebra/moments.py:11
static CUDA_CALLABLE void adj_steps_for_0(
    wp::float32 var_sqdist,
    wp::int32 var_count,
    wp::float32 & adj_sqdist,
    wp::int32 & adj_count,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/algebra/moments.py:21
static CUDA_CALLABLE void adj_integer_steps_0(
    wp::float32 var_length,
    wp::float32 var_steps,
    wp::float32 & adj_length,
    wp::float32 & adj_steps,
    wp::int64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/algebra/moments.py:27
static CUDA_CALLABLE void adj_add_integer_moments_0(
    wp::vec_t<10, wp::int64> var_total,
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> var_q,
    wp::float32 var_steps,
    wp::vec_t<10, wp::int64> & adj_total,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float32> & adj_q,
    wp::float32 & adj_steps,
    wp::vec_t<10, wp::int64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.algebra.moments.in_meters>:1
static CUDA_CALLABLE void adj_in_meters_0(
    wp::vec_t<10, wp::int64> var_m,
    wp::float32 var_steps,
    wp::vec_t<10, wp::int64> & adj_m,
    wp::float32 & adj_steps,
    wp::vec_t<10, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.algebra.moments.covariance_of>:1
static CUDA_CALLABLE void adj_covariance_of_0(
    wp::vec_t<10, wp::float64> var_m,
    wp::vec_t<10, wp::float64> & adj_m,
    wp::mat_t<3, 3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/algebra/eigen.py:14
static CUDA_CALLABLE void adj_largest_entry_0(
    wp::mat_t<3, 3, wp::float64> var_a,
    wp::mat_t<3, 3, wp::float64> & adj_a,
    wp::float64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/algebra/eigen.py:20
static CUDA_CALLABLE void adj_off_diagonal_0(
    wp::mat_t<3, 3, wp::float64> var_a,
    wp::mat_t<3, 3, wp::float64> & adj_a,
    wp::float64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.algebra.eigen.sorted_eigenvalues>:1
static CUDA_CALLABLE void adj_sorted_eigenvalues_0(
    wp::mat_t<3, 3, wp::float64> var_a,
    wp::mat_t<3, 3, wp::float64> & adj_a,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.algebra.eigen.separated_eigenvector>:1
static CUDA_CALLABLE void adj_separated_eigenvector_0(
    wp::mat_t<3, 3, wp::float64> var_a,
    wp::float64 var_value,
    wp::mat_t<3, 3, wp::float64> & adj_a,
    wp::float64 & adj_value,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.algebra.eigen.orthogonal_direction>:1
static CUDA_CALLABLE void adj_orthogonal_direction_0(
    wp::vec_t<3, wp::float64> var_w,
    wp::vec_t<3, wp::float64> & adj_w,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.algebra.eigen.smallest_in_plane>:1
static CUDA_CALLABLE void adj_smallest_in_plane_0(
    wp::mat_t<3, 3, wp::float64> var_a,
    wp::vec_t<3, wp::float64> var_w,
    wp::mat_t<3, 3, wp::float64> & adj_a,
    wp::vec_t<3, wp::float64> & adj_w,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.algebra.eigen.smallest_eigenvector>:1
static CUDA_CALLABLE void adj_smallest_eigenvector_0(
    wp::mat_t<3, 3, wp::float64> var_covariance,
    wp::mat_t<3, 3, wp::float64> & adj_covariance,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/surface/normals.py:27
static CUDA_CALLABLE void adj_normal_of_0(
    wp::vec_t<10, wp::float64> var_m,
    wp::vec_t<10, wp::float64> & adj_m,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void WP_MAXNREG(80) fit_normals_nearest_kernel_1debc263_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::int32 var_part__first,
    wp::int32 var_part__last,
    wp::int32 var_part__run,
    wp::int32 var_tree__count,
    wp::int32 var_tree__root,
    wp::array_t<wp::int32> var_tree__levels,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> var_tree__points,
    wp::array_t<wp::int32> var_tree__order,
    wp::array_t<wp::int32> var_labels,
    wp::array_t<wp::int32> var_scratch__ids,
    wp::array_t<wp::int64> var_scratch__keys,
    wp::int32 var_scratch__k,
    wp::int32 var_scratch__room,
    wp::int32 var_scratch__gather,
    wp::int32 var_scratch__stride,
    wp::float32 var_max_sqdist,
    wp::array_t<wp::vec_t<3, wp::float32>> var_normals)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        const wp::float32 var_1 = -1.0;
        wp::float32 var_2;
        const wp::int32 var_3 = 32;
        wp::int32 var_4;
        wp::int32 var_5;
        wp::int32 var_6;
        wp::int32 var_7;
        wp::int32 var_8;
        wp::range_t var_9;
        wp::int32 var_10;
        wp::int32 var_11;
        wp::int32 var_12;
        wp::int32 var_13;
        const wp::int32 var_14 = 1;
        wp::int32 var_15;
        wp::int32 var_16;
        wp::int32 var_17;
        wp::int32 var_18;
        wp::int32 var_19;
        bool var_20;
        const wp::int32 var_21 = 1;
        const wp::int32 var_22 = 0;
        wp::int32 var_23;
        wp::vec_t<3, wp::float32>* var_24;
        wp::vec_t<3, wp::float32> var_25;
        wp::vec_t<3, wp::float32> var_26;
        wp::int32 var_27;
        const wp::int32 var_28 = 64;
        wp::int32 var_29;
        const wp::int32 var_30 = 1;
        wp::vec_t<2, wp::int32> var_31;
        const wp::int32 var_32 = 1;
        wp::int32 var_33;
        wp::float32 var_34;
        wp::float32 var_35;
        const wp::float32 var_36 = 1.2;
        wp::float32 var_37;
        const wp::int32 var_38 = 0;
        wp::int32 var_39;
        const wp::int32 var_40 = 0;
        const wp::int32 var_41 = 1;
        bool var_42;
        const wp::int32 var_43 = 1;
        bool var_44;
        wp::int32 var_45;
        wp::vec_t<3, wp::float32>* var_46;
        wp::vec_t<3, wp::float32> var_47;
        wp::vec_t<3, wp::float32> var_48;
        wp::float32 var_49;
        wp::float32 var_50;
        wp::int64 var_51;
        wp::vec_t<10, wp::int64> var_52;
        wp::range_t var_53;
        wp::int32 var_54;
        wp::int64 var_55;
        wp::int32 var_56;
        wp::vec_t<3, wp::float32>* var_57;
        wp::vec_t<10, wp::int64> var_58;
        wp::vec_t<3, wp::float32> var_59;
        wp::vec_t<10, wp::float64> var_60;
        wp::vec_t<3, wp::float32> var_61;
        wp::int32* var_62;
        wp::int32 var_63;
        //---------
        // forward
        // def fit_normals_nearest_kernel(part__first, part__last, part__run, tree__count, tree__root, tree__levels, tree__boxes, tree__points, tree__order, labels, scratch__ids, scratch__keys, scratch__k, scratch__room, scratch__gather, scratch__stride, max_sqdist, normals):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // guess__nearest_of_lanes__1 = float(-1.0)                                               <L 4>
        var_2 = wp::float(var_1);
        // first__nearest_of_lanes__1 = part__first + i // WARP__nearest_of_lanes * part__run       <L 5>
        var_4 = wp::floordiv(var_0, var_3);
        var_5 = wp::mul(var_4, var_part__run);
        var_6 = wp::add(var_part__first, var_5);
        // for group__nearest_of_lanes__1 in range(first__nearest_of_lanes__1, min(first__nearest_of_lanes__1 + part__run, part__last)):       <L 6>
        var_7 = wp::add(var_6, var_part__run);
        var_8 = wp::min(var_7, var_part__last);
        var_9 = wp::range(var_6, var_8);
        start_for_0:;
            if (iter_cmp(var_9) == 0) goto end_for_0;
            var_10 = wp::iter_next(var_9);
            // rank = min(group__nearest_of_lanes__1 * WARP__nearest_of_lanes + lane(), tree__count - 1)       <L 7>
            var_11 = wp::mul(var_10, var_3);
            var_12 = _lane_0();
            var_13 = wp::add(var_11, var_12);
            var_15 = wp::sub(var_tree__count, var_14);
            var_16 = wp::min(var_13, var_15);
            // is_query__nearest_of_lanes__1 = 1 if group__nearest_of_lanes__1 * WARP__nearest_of_lanes + lane() < tree__count else 0       <L 8>
            var_17 = wp::mul(var_10, var_3);
            var_18 = _lane_0();
            var_19 = wp::add(var_17, var_18);
            var_20 = (var_19 < var_tree__count);
            if (var_20) {
            }
            if (!var_20) {
            }
            var_23 = wp::where(var_20, var_21, var_22);
            // p__nearest_of_lanes__1 = tree__points[rank]                                        <L 9>
            var_24 = wp::address(var_tree__points, var_16);
            var_26 = wp::load(var_24);
            var_25 = wp::copy(var_26);
            // start__nearest_of_lanes__1 = group__nearest_of_lanes__1 * WARP__nearest_of_lanes // BUCKET__nearest_of_lanes       <L 10>
            var_27 = wp::mul(var_10, var_3);
            var_29 = wp::floordiv(var_27, var_28);
            // result__nearest_of_lanes__1 = search_lanes__nearest_of_lanes(p__nearest_of_lanes__1, is_query__nearest_of_lanes__1, start__nearest_of_lanes__1, guess__nearest_of_lanes__1, tree__count, tree__root, tree__levels, tree__boxes, tree__points, labels, scratch__ids, scratch__keys, scratch__k, scratch__room, scratch__gather, scratch__stride, i, max_sqdist, 1)       <L 11>
            var_31 = search_lanes_on_cuda_0(var_25, var_23, var_29, var_2, var_tree__count, var_tree__root, var_tree__levels, var_tree__boxes, var_tree__points, var_labels, var_scratch__ids, var_scratch__keys, var_scratch__k, var_scratch__room, var_scratch__gather, var_scratch__stride, var_0, var_max_sqdist, var_30);
            // guess__nearest_of_lanes__1 = lane_max__nearest_of_lanes(bits_float(result__nearest_of_lanes__1[1])) * GUESS__nearest_of_lanes       <L 12>
            var_33 = wp::extract(var_31, var_32);
            var_34 = _bits_float_0(var_33);
            var_35 = lane_max_on_cuda_0(var_34);
            var_37 = wp::mul(var_35, var_36);
            // size = result__nearest_of_lanes__1[0]                                              <L 13>
            var_39 = wp::extract(var_31, var_38);
            // if 0 == 1:                                                                         <L 14>
            var_42 = (var_40 == var_41);
            if (var_42) {
                // sort_keys__nearest_of_lanes(scratch__keys, i, scratch__stride, size)           <L 15>
                sort_by_network_on_cuda_0(var_scratch__keys, var_0, var_scratch__stride, var_39);
            }
            // if is_query__nearest_of_lanes__1 == 1:                                             <L 16>
            var_44 = (var_23 == var_43);
            if (var_44) {
                // base = i                                                                       <L 17>
                var_45 = wp::copy(var_0);
                // p = tree__points[rank]                                                         <L 18>
                var_46 = wp::address(var_tree__points, var_16);
                var_48 = wp::load(var_46);
                var_47 = wp::copy(var_48);
                // steps = steps_for(farthest_key(scratch__keys, scratch__stride, base, size), size)       <L 19>
                var_49 = farthest_key_on_cuda_0(var_scratch__keys, var_scratch__stride, var_45, var_39);
                var_50 = steps_for_0(var_49, var_39);
                // total = integer_moments(int64(0))                                              <L 20>
                var_51 = 0ll;
                var_52 = wp::vec_t<10, wp::int64>(var_51);
                // for j in range(size):                                                          <L 21>
                var_53 = wp::range(var_39);
                start_for_2:;
                    if (iter_cmp(var_53) == 0) goto end_for_2;
                    var_54 = wp::iter_next(var_53);
                    // total = add_integer_moments(total, p, tree__points[key_index(stored_key(scratch__keys, scratch__stride, base, j))], steps)       <L 22>
                    var_55 = stored_key_of_lane_on_cuda_0(var_scratch__keys, var_scratch__stride, var_45, var_54);
                    var_56 = key_index_0(var_55);
                    var_57 = wp::address(var_tree__points, var_56);
                    var_59 = wp::load(var_57);
                    var_58 = add_integer_moments_0(var_52, var_47, var_59, var_50);
                    wp::assign(var_52, var_58);
                    goto start_for_2;
                end_for_2:;
                // normals[tree__order[rank]] = normal_of(in_meters(total, steps))                <L 23>
                var_60 = in_meters_0(var_52, var_50);
                var_61 = normal_of_0(var_60);
                var_62 = wp::address(var_tree__order, var_16);
                var_63 = wp::load(var_62);
                wp::array_store(var_normals, var_63, var_61);
            }
            wp::assign(var_2, var_37);
            goto start_for_0;
        end_for_0:;
}


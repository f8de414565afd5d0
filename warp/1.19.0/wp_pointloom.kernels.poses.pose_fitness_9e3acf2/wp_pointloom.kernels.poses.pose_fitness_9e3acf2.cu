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


// /work/main/src/pointloom/kernels/algebra/transform.py:27
static CUDA_CALLABLE wp::vec_t<3, wp::float64> widen_0(
    wp::vec_t<3, wp::float32> var_p)
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
    //---------
    // forward
    // def widen(p: vec3) -> vec3d:                                                           <L 28>
    // return vec3d(float64(p[0]), float64(p[1]), float64(p[2]))                              <L 29>
    var_1 = wp::extract(var_p, var_0);
    var_2 = wp::float64(var_1);
    var_4 = wp::extract(var_p, var_3);
    var_5 = wp::float64(var_4);
    var_7 = wp::extract(var_p, var_6);
    var_8 = wp::float64(var_7);
    var_9 = wp::vec_t<3, wp::float64>(var_2, var_5, var_8);
    return var_9;
}


// /work/main/src/pointloom/kernels/algebra/rigid_solve.py:301
static CUDA_CALLABLE wp::vec_t<3, wp::float64> move_0(
    wp::mat_t<4, 4, wp::float64> var_pose,
    wp::vec_t<3, wp::float64> var_p)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    const wp::int32 var_1 = 0;
    wp::float64 var_2;
    const wp::int32 var_3 = 0;
    wp::float64 var_4;
    wp::float64 var_5;
    const wp::int32 var_6 = 0;
    const wp::int32 var_7 = 1;
    wp::float64 var_8;
    const wp::int32 var_9 = 1;
    wp::float64 var_10;
    wp::float64 var_11;
    wp::float64 var_12;
    const wp::int32 var_13 = 0;
    const wp::int32 var_14 = 2;
    wp::float64 var_15;
    const wp::int32 var_16 = 2;
    wp::float64 var_17;
    wp::float64 var_18;
    wp::float64 var_19;
    const wp::int32 var_20 = 0;
    const wp::int32 var_21 = 3;
    wp::float64 var_22;
    wp::float64 var_23;
    const wp::int32 var_24 = 1;
    const wp::int32 var_25 = 0;
    wp::float64 var_26;
    const wp::int32 var_27 = 0;
    wp::float64 var_28;
    wp::float64 var_29;
    const wp::int32 var_30 = 1;
    const wp::int32 var_31 = 1;
    wp::float64 var_32;
    const wp::int32 var_33 = 1;
    wp::float64 var_34;
    wp::float64 var_35;
    wp::float64 var_36;
    const wp::int32 var_37 = 1;
    const wp::int32 var_38 = 2;
    wp::float64 var_39;
    const wp::int32 var_40 = 2;
    wp::float64 var_41;
    wp::float64 var_42;
    wp::float64 var_43;
    const wp::int32 var_44 = 1;
    const wp::int32 var_45 = 3;
    wp::float64 var_46;
    wp::float64 var_47;
    const wp::int32 var_48 = 2;
    const wp::int32 var_49 = 0;
    wp::float64 var_50;
    const wp::int32 var_51 = 0;
    wp::float64 var_52;
    wp::float64 var_53;
    const wp::int32 var_54 = 2;
    const wp::int32 var_55 = 1;
    wp::float64 var_56;
    const wp::int32 var_57 = 1;
    wp::float64 var_58;
    wp::float64 var_59;
    wp::float64 var_60;
    const wp::int32 var_61 = 2;
    const wp::int32 var_62 = 2;
    wp::float64 var_63;
    const wp::int32 var_64 = 2;
    wp::float64 var_65;
    wp::float64 var_66;
    wp::float64 var_67;
    const wp::int32 var_68 = 2;
    const wp::int32 var_69 = 3;
    wp::float64 var_70;
    wp::float64 var_71;
    wp::vec_t<3, wp::float64> var_72;
    //---------
    // forward
    // def move(pose: mat44d, p: vec3d) -> vec3d:                                             <L 302>
    // return vec3d(                                                                          <L 303>
    // pose[0, 0] * p[0] + pose[0, 1] * p[1] + pose[0, 2] * p[2] + pose[0, 3],                <L 304>
    var_2 = wp::extract(var_pose, var_0, var_1);
    var_4 = wp::extract(var_p, var_3);
    var_5 = wp::mul(var_2, var_4);
    var_8 = wp::extract(var_pose, var_6, var_7);
    var_10 = wp::extract(var_p, var_9);
    var_11 = wp::mul(var_8, var_10);
    var_12 = wp::add(var_5, var_11);
    var_15 = wp::extract(var_pose, var_13, var_14);
    var_17 = wp::extract(var_p, var_16);
    var_18 = wp::mul(var_15, var_17);
    var_19 = wp::add(var_12, var_18);
    var_22 = wp::extract(var_pose, var_20, var_21);
    var_23 = wp::add(var_19, var_22);
    // pose[1, 0] * p[0] + pose[1, 1] * p[1] + pose[1, 2] * p[2] + pose[1, 3],                <L 305>
    var_26 = wp::extract(var_pose, var_24, var_25);
    var_28 = wp::extract(var_p, var_27);
    var_29 = wp::mul(var_26, var_28);
    var_32 = wp::extract(var_pose, var_30, var_31);
    var_34 = wp::extract(var_p, var_33);
    var_35 = wp::mul(var_32, var_34);
    var_36 = wp::add(var_29, var_35);
    var_39 = wp::extract(var_pose, var_37, var_38);
    var_41 = wp::extract(var_p, var_40);
    var_42 = wp::mul(var_39, var_41);
    var_43 = wp::add(var_36, var_42);
    var_46 = wp::extract(var_pose, var_44, var_45);
    var_47 = wp::add(var_43, var_46);
    // pose[2, 0] * p[0] + pose[2, 1] * p[1] + pose[2, 2] * p[2] + pose[2, 3],                <L 306>
    var_50 = wp::extract(var_pose, var_48, var_49);
    var_52 = wp::extract(var_p, var_51);
    var_53 = wp::mul(var_50, var_52);
    var_56 = wp::extract(var_pose, var_54, var_55);
    var_58 = wp::extract(var_p, var_57);
    var_59 = wp::mul(var_56, var_58);
    var_60 = wp::add(var_53, var_59);
    var_63 = wp::extract(var_pose, var_61, var_62);
    var_65 = wp::extract(var_p, var_64);
    var_66 = wp::mul(var_63, var_65);
    var_67 = wp::add(var_60, var_66);
    var_70 = wp::extract(var_pose, var_68, var_69);
    var_71 = wp::add(var_67, var_70);
    var_72 = wp::vec_t<3, wp::float64>(var_23, var_47, var_71);
    return var_72;
}


// /work/main/src/pointloom/kernels/algebra/transform.py:32
static CUDA_CALLABLE wp::vec_t<3, wp::float32> narrow_0(
    wp::vec_t<3, wp::float64> var_p)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float64 var_1;
    wp::float32 var_2;
    const wp::int32 var_3 = 1;
    wp::float64 var_4;
    wp::float32 var_5;
    const wp::int32 var_6 = 2;
    wp::float64 var_7;
    wp::float32 var_8;
    wp::vec_t<3, wp::float32> var_9;
    //---------
    // forward
    // def narrow(p: vec3d) -> vec3:                                                          <L 33>
    // return vec3(float(p[0]), float(p[1]), float(p[2]))                                     <L 34>
    var_1 = wp::extract(var_p, var_0);
    var_2 = wp::float(var_1);
    var_4 = wp::extract(var_p, var_3);
    var_5 = wp::float(var_4);
    var_7 = wp::extract(var_p, var_6);
    var_8 = wp::float(var_7);
    var_9 = wp::vec_t<3, wp::float32>(var_2, var_5, var_8);
    return var_9;
}


// <pointloom.kernels.poses.pose_fitness.moved_point>:1
static CUDA_CALLABLE wp::vec_t<3, wp::float32> moved_point_0(
    wp::mat_t<4, 4, wp::float64> var_pose,
    wp::int32 var_row,
    wp::array_t<wp::vec_t<3, wp::float32>> var_fitness__source,
    wp::vec_t<3, wp::float32> var_fitness__source_middle,
    wp::vec_t<3, wp::float32> var_fitness__target_middle)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float32>* var_0;
    wp::vec_t<3, wp::float64> var_1;
    wp::vec_t<3, wp::float32> var_2;
    wp::vec_t<3, wp::float64> var_3;
    wp::vec_t<3, wp::float64> var_4;
    wp::vec_t<3, wp::float64> var_5;
    wp::vec_t<3, wp::float64> var_6;
    wp::vec_t<3, wp::float64> var_7;
    wp::vec_t<3, wp::float32> var_8;
    //---------
    // forward
    // def moved_point(pose, row, fitness__source, fitness__source_middle, fitness__target_middle):       <L 1>
    // p = widen(fitness__source[row])                                                        <L 3>
    var_0 = wp::address(var_fitness__source, var_row);
    var_2 = wp::load(var_0);
    var_1 = widen_0(var_2);
    // return narrow(move(pose, p - widen(fitness__source_middle)) + widen(fitness__target_middle))       <L 4>
    var_3 = widen_0(var_fitness__source_middle);
    var_4 = wp::sub(var_1, var_3);
    var_5 = move_0(var_pose, var_4);
    var_6 = widen_0(var_fitness__target_middle);
    var_7 = wp::add(var_5, var_6);
    var_8 = narrow_0(var_7);
    return var_8;
}


// /work/main/src/pointloom/kernels/search/hilbert_order.py:102
static CUDA_CALLABLE wp::int32 cell_on_axis_0(
    wp::float32 var_coordinate,
    wp::float32 var_low,
    wp::float32 var_scale,
    wp::int32 var_levels)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 1;
    wp::int32 var_1;
    const wp::int32 var_2 = 1;
    wp::int32 var_3;
    wp::float32 var_4;
    wp::float32 var_5;
    wp::float32 var_6;
    const wp::float32 var_7 = 0.0;
    wp::float32 var_8;
    wp::float32 var_9;
    wp::int32 var_10;
    //---------
    // forward
    // def cell_on_axis(coordinate: float, low: float, scale: float, levels: int) -> int:       <L 103>
    // top = float((1 << levels) - 1)                                                         <L 104>
    var_1 = wp::lshift(var_0, var_levels);
    var_3 = wp::sub(var_1, var_2);
    var_4 = wp::float(var_3);
    // return int(min(max((coordinate - low) * scale, 0.0), top))                             <L 105>
    var_5 = wp::sub(var_coordinate, var_low);
    var_6 = wp::mul(var_5, var_scale);
    var_8 = wp::max(var_6, var_7);
    var_9 = wp::min(var_8, var_4);
    var_10 = wp::int(var_9);
    return var_10;
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


// <pointloom.kernels.search.hilbert_order.hilbert_codes>:1
static CUDA_CALLABLE wp::vec_t<8, wp::int64> hilbert_codes_0(
    wp::vec_t<8, wp::int32> var_cx,
    wp::vec_t<8, wp::int32> var_cy,
    wp::vec_t<8, wp::int32> var_cz,
    wp::int32 var_levels)
{
    //---------
    // primal vars
    wp::vec_t<8, wp::int32> var_0;
    wp::vec_t<8, wp::int32> var_1;
    wp::vec_t<8, wp::int32> var_2;
    const wp::int32 var_3 = 1;
    wp::range_t var_4;
    wp::int32 var_5;
    wp::int32 var_6;
    const wp::int32 var_7 = 1;
    wp::int32 var_8;
    const wp::int32 var_9 = 1;
    wp::int32 var_10;
    const wp::int32 var_11 = 0;
    wp::int32 var_12;
    wp::int32 var_13;
    wp::int32 var_14;
    const wp::int32 var_15 = 1;
    wp::int32 var_16;
    wp::int32 var_17;
    wp::int32 var_18;
    wp::int32 var_19;
    wp::int32 var_20;
    wp::int32 var_21;
    const wp::int32 var_22 = 1;
    wp::int32 var_23;
    wp::int32 var_24;
    wp::int32 var_25;
    wp::int32 var_26;
    wp::int32 var_27;
    wp::int32 var_28;
    wp::int32 var_29;
    wp::int32 var_30;
    wp::int32 var_31;
    wp::int32 var_32;
    wp::int32 var_33;
    wp::int32 var_34;
    wp::int32 var_35;
    wp::int32 var_36;
    wp::int32 var_37;
    wp::int32 var_38;
    const wp::int32 var_39 = 1;
    wp::int32 var_40;
    wp::int32 var_41;
    wp::int32 var_42;
    wp::int32 var_43;
    wp::int32 var_44;
    wp::int32 var_45;
    wp::int32 var_46;
    wp::int32 var_47;
    wp::int32 var_48;
    wp::int32 var_49;
    wp::int32 var_50;
    wp::int32 var_51;
    wp::int32 var_52;
    wp::int32 var_53;
    const wp::int32 var_54 = 1;
    wp::int32 var_55;
    wp::int32 var_56;
    wp::int32 var_57;
    const wp::int32 var_58 = 1;
    wp::int32 var_59;
    wp::int32 var_60;
    wp::int32 var_61;
    wp::int32 var_62;
    wp::int32 var_63;
    wp::int32 var_64;
    const wp::int32 var_65 = 1;
    wp::int32 var_66;
    wp::int32 var_67;
    wp::int32 var_68;
    wp::int32 var_69;
    wp::int32 var_70;
    wp::int32 var_71;
    wp::int32 var_72;
    wp::int32 var_73;
    wp::int32 var_74;
    wp::int32 var_75;
    wp::int32 var_76;
    wp::int32 var_77;
    wp::int32 var_78;
    wp::int32 var_79;
    wp::int32 var_80;
    wp::int32 var_81;
    const wp::int32 var_82 = 1;
    wp::int32 var_83;
    wp::int32 var_84;
    wp::int32 var_85;
    wp::int32 var_86;
    wp::int32 var_87;
    wp::int32 var_88;
    wp::int32 var_89;
    wp::int32 var_90;
    wp::int32 var_91;
    wp::int32 var_92;
    wp::int32 var_93;
    wp::int32 var_94;
    wp::int32 var_95;
    wp::int32 var_96;
    const wp::int32 var_97 = 2;
    wp::int32 var_98;
    wp::int32 var_99;
    wp::int32 var_100;
    const wp::int32 var_101 = 1;
    wp::int32 var_102;
    wp::int32 var_103;
    wp::int32 var_104;
    wp::int32 var_105;
    wp::int32 var_106;
    wp::int32 var_107;
    const wp::int32 var_108 = 1;
    wp::int32 var_109;
    wp::int32 var_110;
    wp::int32 var_111;
    wp::int32 var_112;
    wp::int32 var_113;
    wp::int32 var_114;
    wp::int32 var_115;
    wp::int32 var_116;
    wp::int32 var_117;
    wp::int32 var_118;
    wp::int32 var_119;
    wp::int32 var_120;
    wp::int32 var_121;
    wp::int32 var_122;
    wp::int32 var_123;
    wp::int32 var_124;
    const wp::int32 var_125 = 1;
    wp::int32 var_126;
    wp::int32 var_127;
    wp::int32 var_128;
    wp::int32 var_129;
    wp::int32 var_130;
    wp::int32 var_131;
    wp::int32 var_132;
    wp::int32 var_133;
    wp::int32 var_134;
    wp::int32 var_135;
    wp::int32 var_136;
    wp::int32 var_137;
    wp::int32 var_138;
    wp::int32 var_139;
    const wp::int32 var_140 = 3;
    wp::int32 var_141;
    wp::int32 var_142;
    wp::int32 var_143;
    const wp::int32 var_144 = 1;
    wp::int32 var_145;
    wp::int32 var_146;
    wp::int32 var_147;
    wp::int32 var_148;
    wp::int32 var_149;
    wp::int32 var_150;
    const wp::int32 var_151 = 1;
    wp::int32 var_152;
    wp::int32 var_153;
    wp::int32 var_154;
    wp::int32 var_155;
    wp::int32 var_156;
    wp::int32 var_157;
    wp::int32 var_158;
    wp::int32 var_159;
    wp::int32 var_160;
    wp::int32 var_161;
    wp::int32 var_162;
    wp::int32 var_163;
    wp::int32 var_164;
    wp::int32 var_165;
    wp::int32 var_166;
    wp::int32 var_167;
    const wp::int32 var_168 = 1;
    wp::int32 var_169;
    wp::int32 var_170;
    wp::int32 var_171;
    wp::int32 var_172;
    wp::int32 var_173;
    wp::int32 var_174;
    wp::int32 var_175;
    wp::int32 var_176;
    wp::int32 var_177;
    wp::int32 var_178;
    wp::int32 var_179;
    wp::int32 var_180;
    wp::int32 var_181;
    wp::int32 var_182;
    const wp::int32 var_183 = 4;
    wp::int32 var_184;
    wp::int32 var_185;
    wp::int32 var_186;
    const wp::int32 var_187 = 1;
    wp::int32 var_188;
    wp::int32 var_189;
    wp::int32 var_190;
    wp::int32 var_191;
    wp::int32 var_192;
    wp::int32 var_193;
    const wp::int32 var_194 = 1;
    wp::int32 var_195;
    wp::int32 var_196;
    wp::int32 var_197;
    wp::int32 var_198;
    wp::int32 var_199;
    wp::int32 var_200;
    wp::int32 var_201;
    wp::int32 var_202;
    wp::int32 var_203;
    wp::int32 var_204;
    wp::int32 var_205;
    wp::int32 var_206;
    wp::int32 var_207;
    wp::int32 var_208;
    wp::int32 var_209;
    wp::int32 var_210;
    const wp::int32 var_211 = 1;
    wp::int32 var_212;
    wp::int32 var_213;
    wp::int32 var_214;
    wp::int32 var_215;
    wp::int32 var_216;
    wp::int32 var_217;
    wp::int32 var_218;
    wp::int32 var_219;
    wp::int32 var_220;
    wp::int32 var_221;
    wp::int32 var_222;
    wp::int32 var_223;
    wp::int32 var_224;
    wp::int32 var_225;
    const wp::int32 var_226 = 5;
    wp::int32 var_227;
    wp::int32 var_228;
    wp::int32 var_229;
    const wp::int32 var_230 = 1;
    wp::int32 var_231;
    wp::int32 var_232;
    wp::int32 var_233;
    wp::int32 var_234;
    wp::int32 var_235;
    wp::int32 var_236;
    const wp::int32 var_237 = 1;
    wp::int32 var_238;
    wp::int32 var_239;
    wp::int32 var_240;
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
    wp::int32 var_251;
    wp::int32 var_252;
    wp::int32 var_253;
    const wp::int32 var_254 = 1;
    wp::int32 var_255;
    wp::int32 var_256;
    wp::int32 var_257;
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
    wp::int32 var_268;
    const wp::int32 var_269 = 6;
    wp::int32 var_270;
    wp::int32 var_271;
    wp::int32 var_272;
    const wp::int32 var_273 = 1;
    wp::int32 var_274;
    wp::int32 var_275;
    wp::int32 var_276;
    wp::int32 var_277;
    wp::int32 var_278;
    wp::int32 var_279;
    const wp::int32 var_280 = 1;
    wp::int32 var_281;
    wp::int32 var_282;
    wp::int32 var_283;
    wp::int32 var_284;
    wp::int32 var_285;
    wp::int32 var_286;
    wp::int32 var_287;
    wp::int32 var_288;
    wp::int32 var_289;
    wp::int32 var_290;
    wp::int32 var_291;
    wp::int32 var_292;
    wp::int32 var_293;
    wp::int32 var_294;
    wp::int32 var_295;
    wp::int32 var_296;
    const wp::int32 var_297 = 1;
    wp::int32 var_298;
    wp::int32 var_299;
    wp::int32 var_300;
    wp::int32 var_301;
    wp::int32 var_302;
    wp::int32 var_303;
    wp::int32 var_304;
    wp::int32 var_305;
    wp::int32 var_306;
    wp::int32 var_307;
    wp::int32 var_308;
    wp::int32 var_309;
    wp::int32 var_310;
    wp::int32 var_311;
    const wp::int32 var_312 = 7;
    wp::int32 var_313;
    wp::int32 var_314;
    wp::int32 var_315;
    const wp::int32 var_316 = 1;
    wp::int32 var_317;
    wp::int32 var_318;
    wp::int32 var_319;
    wp::int32 var_320;
    wp::int32 var_321;
    wp::int32 var_322;
    const wp::int32 var_323 = 1;
    wp::int32 var_324;
    wp::int32 var_325;
    wp::int32 var_326;
    wp::int32 var_327;
    wp::int32 var_328;
    wp::int32 var_329;
    wp::int32 var_330;
    wp::int32 var_331;
    wp::int32 var_332;
    wp::int32 var_333;
    wp::int32 var_334;
    wp::int32 var_335;
    wp::int32 var_336;
    wp::int32 var_337;
    wp::int32 var_338;
    wp::int32 var_339;
    const wp::int32 var_340 = 1;
    wp::int32 var_341;
    wp::int32 var_342;
    wp::int32 var_343;
    wp::int32 var_344;
    wp::int32 var_345;
    wp::int32 var_346;
    wp::int32 var_347;
    wp::int32 var_348;
    wp::int32 var_349;
    wp::int32 var_350;
    wp::int32 var_351;
    wp::int32 var_352;
    wp::int32 var_353;
    wp::int32 var_354;
    wp::int64 var_355;
    wp::vec_t<8, wp::int64> var_356;
    const wp::int32 var_357 = 0;
    wp::int32 var_358;
    wp::int32 var_359;
    wp::int32 var_360;
    wp::int32 var_361;
    wp::int32 var_362;
    wp::int32 var_363;
    wp::int32 var_364;
    wp::int32 var_365;
    const wp::int32 var_366 = 1;
    wp::int32 var_367;
    wp::int32 var_368;
    const wp::int32 var_369 = 2;
    wp::int32 var_370;
    wp::int32 var_371;
    const wp::int32 var_372 = 4;
    wp::int32 var_373;
    wp::int32 var_374;
    const wp::int32 var_375 = 8;
    wp::int32 var_376;
    wp::int32 var_377;
    const wp::int32 var_378 = 1;
    wp::int32 var_379;
    wp::int32 var_380;
    wp::int32 var_381;
    wp::int32 var_382;
    wp::int32 var_383;
    wp::int32 var_384;
    wp::int32 var_385;
    wp::int32 var_386;
    wp::int64 var_387;
    wp::int64 var_388;
    wp::int64 var_389;
    wp::int32 var_390;
    wp::int64 var_391;
    wp::int64 var_392;
    wp::int64 var_393;
    wp::int64 var_394;
    wp::int32 var_395;
    wp::int64 var_396;
    wp::int64 var_397;
    const wp::int32 var_398 = 1;
    wp::int32 var_399;
    wp::int32 var_400;
    wp::int32 var_401;
    wp::int32 var_402;
    wp::int32 var_403;
    wp::int32 var_404;
    wp::int32 var_405;
    wp::int32 var_406;
    const wp::int32 var_407 = 1;
    wp::int32 var_408;
    wp::int32 var_409;
    const wp::int32 var_410 = 2;
    wp::int32 var_411;
    wp::int32 var_412;
    const wp::int32 var_413 = 4;
    wp::int32 var_414;
    wp::int32 var_415;
    const wp::int32 var_416 = 8;
    wp::int32 var_417;
    wp::int32 var_418;
    const wp::int32 var_419 = 1;
    wp::int32 var_420;
    wp::int32 var_421;
    wp::int32 var_422;
    wp::int32 var_423;
    wp::int32 var_424;
    wp::int32 var_425;
    wp::int32 var_426;
    wp::int32 var_427;
    wp::int64 var_428;
    wp::int64 var_429;
    wp::int64 var_430;
    wp::int32 var_431;
    wp::int64 var_432;
    wp::int64 var_433;
    wp::int64 var_434;
    wp::int64 var_435;
    wp::int32 var_436;
    wp::int64 var_437;
    wp::int64 var_438;
    const wp::int32 var_439 = 2;
    wp::int32 var_440;
    wp::int32 var_441;
    wp::int32 var_442;
    wp::int32 var_443;
    wp::int32 var_444;
    wp::int32 var_445;
    wp::int32 var_446;
    wp::int32 var_447;
    const wp::int32 var_448 = 1;
    wp::int32 var_449;
    wp::int32 var_450;
    const wp::int32 var_451 = 2;
    wp::int32 var_452;
    wp::int32 var_453;
    const wp::int32 var_454 = 4;
    wp::int32 var_455;
    wp::int32 var_456;
    const wp::int32 var_457 = 8;
    wp::int32 var_458;
    wp::int32 var_459;
    const wp::int32 var_460 = 1;
    wp::int32 var_461;
    wp::int32 var_462;
    wp::int32 var_463;
    wp::int32 var_464;
    wp::int32 var_465;
    wp::int32 var_466;
    wp::int32 var_467;
    wp::int32 var_468;
    wp::int64 var_469;
    wp::int64 var_470;
    wp::int64 var_471;
    wp::int32 var_472;
    wp::int64 var_473;
    wp::int64 var_474;
    wp::int64 var_475;
    wp::int64 var_476;
    wp::int32 var_477;
    wp::int64 var_478;
    wp::int64 var_479;
    const wp::int32 var_480 = 3;
    wp::int32 var_481;
    wp::int32 var_482;
    wp::int32 var_483;
    wp::int32 var_484;
    wp::int32 var_485;
    wp::int32 var_486;
    wp::int32 var_487;
    wp::int32 var_488;
    const wp::int32 var_489 = 1;
    wp::int32 var_490;
    wp::int32 var_491;
    const wp::int32 var_492 = 2;
    wp::int32 var_493;
    wp::int32 var_494;
    const wp::int32 var_495 = 4;
    wp::int32 var_496;
    wp::int32 var_497;
    const wp::int32 var_498 = 8;
    wp::int32 var_499;
    wp::int32 var_500;
    const wp::int32 var_501 = 1;
    wp::int32 var_502;
    wp::int32 var_503;
    wp::int32 var_504;
    wp::int32 var_505;
    wp::int32 var_506;
    wp::int32 var_507;
    wp::int32 var_508;
    wp::int32 var_509;
    wp::int64 var_510;
    wp::int64 var_511;
    wp::int64 var_512;
    wp::int32 var_513;
    wp::int64 var_514;
    wp::int64 var_515;
    wp::int64 var_516;
    wp::int64 var_517;
    wp::int32 var_518;
    wp::int64 var_519;
    wp::int64 var_520;
    const wp::int32 var_521 = 4;
    wp::int32 var_522;
    wp::int32 var_523;
    wp::int32 var_524;
    wp::int32 var_525;
    wp::int32 var_526;
    wp::int32 var_527;
    wp::int32 var_528;
    wp::int32 var_529;
    const wp::int32 var_530 = 1;
    wp::int32 var_531;
    wp::int32 var_532;
    const wp::int32 var_533 = 2;
    wp::int32 var_534;
    wp::int32 var_535;
    const wp::int32 var_536 = 4;
    wp::int32 var_537;
    wp::int32 var_538;
    const wp::int32 var_539 = 8;
    wp::int32 var_540;
    wp::int32 var_541;
    const wp::int32 var_542 = 1;
    wp::int32 var_543;
    wp::int32 var_544;
    wp::int32 var_545;
    wp::int32 var_546;
    wp::int32 var_547;
    wp::int32 var_548;
    wp::int32 var_549;
    wp::int32 var_550;
    wp::int64 var_551;
    wp::int64 var_552;
    wp::int64 var_553;
    wp::int32 var_554;
    wp::int64 var_555;
    wp::int64 var_556;
    wp::int64 var_557;
    wp::int64 var_558;
    wp::int32 var_559;
    wp::int64 var_560;
    wp::int64 var_561;
    const wp::int32 var_562 = 5;
    wp::int32 var_563;
    wp::int32 var_564;
    wp::int32 var_565;
    wp::int32 var_566;
    wp::int32 var_567;
    wp::int32 var_568;
    wp::int32 var_569;
    wp::int32 var_570;
    const wp::int32 var_571 = 1;
    wp::int32 var_572;
    wp::int32 var_573;
    const wp::int32 var_574 = 2;
    wp::int32 var_575;
    wp::int32 var_576;
    const wp::int32 var_577 = 4;
    wp::int32 var_578;
    wp::int32 var_579;
    const wp::int32 var_580 = 8;
    wp::int32 var_581;
    wp::int32 var_582;
    const wp::int32 var_583 = 1;
    wp::int32 var_584;
    wp::int32 var_585;
    wp::int32 var_586;
    wp::int32 var_587;
    wp::int32 var_588;
    wp::int32 var_589;
    wp::int32 var_590;
    wp::int32 var_591;
    wp::int64 var_592;
    wp::int64 var_593;
    wp::int64 var_594;
    wp::int32 var_595;
    wp::int64 var_596;
    wp::int64 var_597;
    wp::int64 var_598;
    wp::int64 var_599;
    wp::int32 var_600;
    wp::int64 var_601;
    wp::int64 var_602;
    const wp::int32 var_603 = 6;
    wp::int32 var_604;
    wp::int32 var_605;
    wp::int32 var_606;
    wp::int32 var_607;
    wp::int32 var_608;
    wp::int32 var_609;
    wp::int32 var_610;
    wp::int32 var_611;
    const wp::int32 var_612 = 1;
    wp::int32 var_613;
    wp::int32 var_614;
    const wp::int32 var_615 = 2;
    wp::int32 var_616;
    wp::int32 var_617;
    const wp::int32 var_618 = 4;
    wp::int32 var_619;
    wp::int32 var_620;
    const wp::int32 var_621 = 8;
    wp::int32 var_622;
    wp::int32 var_623;
    const wp::int32 var_624 = 1;
    wp::int32 var_625;
    wp::int32 var_626;
    wp::int32 var_627;
    wp::int32 var_628;
    wp::int32 var_629;
    wp::int32 var_630;
    wp::int32 var_631;
    wp::int32 var_632;
    wp::int64 var_633;
    wp::int64 var_634;
    wp::int64 var_635;
    wp::int32 var_636;
    wp::int64 var_637;
    wp::int64 var_638;
    wp::int64 var_639;
    wp::int64 var_640;
    wp::int32 var_641;
    wp::int64 var_642;
    wp::int64 var_643;
    const wp::int32 var_644 = 7;
    wp::int32 var_645;
    wp::int32 var_646;
    wp::int32 var_647;
    wp::int32 var_648;
    wp::int32 var_649;
    wp::int32 var_650;
    wp::int32 var_651;
    wp::int32 var_652;
    const wp::int32 var_653 = 1;
    wp::int32 var_654;
    wp::int32 var_655;
    const wp::int32 var_656 = 2;
    wp::int32 var_657;
    wp::int32 var_658;
    const wp::int32 var_659 = 4;
    wp::int32 var_660;
    wp::int32 var_661;
    const wp::int32 var_662 = 8;
    wp::int32 var_663;
    wp::int32 var_664;
    const wp::int32 var_665 = 1;
    wp::int32 var_666;
    wp::int32 var_667;
    wp::int32 var_668;
    wp::int32 var_669;
    wp::int32 var_670;
    wp::int32 var_671;
    wp::int32 var_672;
    wp::int32 var_673;
    wp::int64 var_674;
    wp::int64 var_675;
    wp::int64 var_676;
    wp::int32 var_677;
    wp::int64 var_678;
    wp::int64 var_679;
    wp::int64 var_680;
    wp::int64 var_681;
    wp::int32 var_682;
    wp::int64 var_683;
    wp::int64 var_684;
    //---------
    // forward
    // def hilbert_codes(cx, cy, cz, levels):                                                 <L 1>
    // x = cx                                                                                 <L 3>
    var_0 = wp::copy(var_cx);
    // y = cy                                                                                 <L 4>
    var_1 = wp::copy(var_cy);
    // z = cz                                                                                 <L 5>
    var_2 = wp::copy(var_cz);
    // for level in range(1, levels):                                                         <L 6>
    var_4 = wp::range(var_3, var_levels);
    start_for_0:;
        if (iter_cmp(var_4) == 0) goto end_for_0;
        var_5 = wp::iter_next(var_4);
        // shift = levels - level                                                             <L 7>
        var_6 = wp::sub(var_levels, var_5);
        // low = (1 << shift) - 1                                                             <L 8>
        var_8 = wp::lshift(var_7, var_6);
        var_10 = wp::sub(var_8, var_9);
        // for j in range(LANES):                                                             <L 9>
        // x[j] = x[j] ^ low & -(x[j] >> shift & 1)                                           <L 10>
        var_12 = wp::extract(var_0, var_11);
        var_13 = wp::extract(var_0, var_11);
        var_14 = wp::rshift(var_13, var_6);
        var_16 = wp::bit_and(var_14, var_15);
        var_17 = wp::neg(var_16);
        var_18 = wp::bit_and(var_10, var_17);
        var_19 = wp::bit_xor(var_12, var_18);
        wp::assign_inplace(var_0, var_11, var_19);
        // set_y = -(y[j] >> shift & 1)                                                       <L 11>
        var_20 = wp::extract(var_1, var_11);
        var_21 = wp::rshift(var_20, var_6);
        var_23 = wp::bit_and(var_21, var_22);
        var_24 = wp::neg(var_23);
        // swapped = (x[j] ^ y[j]) & low & ~set_y                                             <L 12>
        var_25 = wp::extract(var_0, var_11);
        var_26 = wp::extract(var_1, var_11);
        var_27 = wp::bit_xor(var_25, var_26);
        var_28 = wp::bit_and(var_27, var_10);
        var_29 = wp::invert(var_24);
        var_30 = wp::bit_and(var_28, var_29);
        // x[j] = x[j] ^ (low & set_y | swapped)                                              <L 13>
        var_31 = wp::extract(var_0, var_11);
        var_32 = wp::bit_and(var_10, var_24);
        var_33 = wp::bit_or(var_32, var_30);
        var_34 = wp::bit_xor(var_31, var_33);
        wp::assign_inplace(var_0, var_11, var_34);
        // y[j] = y[j] ^ swapped                                                              <L 14>
        var_35 = wp::extract(var_1, var_11);
        var_36 = wp::bit_xor(var_35, var_30);
        wp::assign_inplace(var_1, var_11, var_36);
        // set_z = -(z[j] >> shift & 1)                                                       <L 15>
        var_37 = wp::extract(var_2, var_11);
        var_38 = wp::rshift(var_37, var_6);
        var_40 = wp::bit_and(var_38, var_39);
        var_41 = wp::neg(var_40);
        // exchanged = (x[j] ^ z[j]) & low & ~set_z                                           <L 16>
        var_42 = wp::extract(var_0, var_11);
        var_43 = wp::extract(var_2, var_11);
        var_44 = wp::bit_xor(var_42, var_43);
        var_45 = wp::bit_and(var_44, var_10);
        var_46 = wp::invert(var_41);
        var_47 = wp::bit_and(var_45, var_46);
        // x[j] = x[j] ^ (low & set_z | exchanged)                                            <L 17>
        var_48 = wp::extract(var_0, var_11);
        var_49 = wp::bit_and(var_10, var_41);
        var_50 = wp::bit_or(var_49, var_47);
        var_51 = wp::bit_xor(var_48, var_50);
        wp::assign_inplace(var_0, var_11, var_51);
        // z[j] = z[j] ^ exchanged                                                            <L 18>
        var_52 = wp::extract(var_2, var_11);
        var_53 = wp::bit_xor(var_52, var_47);
        wp::assign_inplace(var_2, var_11, var_53);
        // x[j] = x[j] ^ low & -(x[j] >> shift & 1)                                           <L 10>
        var_55 = wp::extract(var_0, var_54);
        var_56 = wp::extract(var_0, var_54);
        var_57 = wp::rshift(var_56, var_6);
        var_59 = wp::bit_and(var_57, var_58);
        var_60 = wp::neg(var_59);
        var_61 = wp::bit_and(var_10, var_60);
        var_62 = wp::bit_xor(var_55, var_61);
        wp::assign_inplace(var_0, var_54, var_62);
        // set_y = -(y[j] >> shift & 1)                                                       <L 11>
        var_63 = wp::extract(var_1, var_54);
        var_64 = wp::rshift(var_63, var_6);
        var_66 = wp::bit_and(var_64, var_65);
        var_67 = wp::neg(var_66);
        // swapped = (x[j] ^ y[j]) & low & ~set_y                                             <L 12>
        var_68 = wp::extract(var_0, var_54);
        var_69 = wp::extract(var_1, var_54);
        var_70 = wp::bit_xor(var_68, var_69);
        var_71 = wp::bit_and(var_70, var_10);
        var_72 = wp::invert(var_67);
        var_73 = wp::bit_and(var_71, var_72);
        // x[j] = x[j] ^ (low & set_y | swapped)                                              <L 13>
        var_74 = wp::extract(var_0, var_54);
        var_75 = wp::bit_and(var_10, var_67);
        var_76 = wp::bit_or(var_75, var_73);
        var_77 = wp::bit_xor(var_74, var_76);
        wp::assign_inplace(var_0, var_54, var_77);
        // y[j] = y[j] ^ swapped                                                              <L 14>
        var_78 = wp::extract(var_1, var_54);
        var_79 = wp::bit_xor(var_78, var_73);
        wp::assign_inplace(var_1, var_54, var_79);
        // set_z = -(z[j] >> shift & 1)                                                       <L 15>
        var_80 = wp::extract(var_2, var_54);
        var_81 = wp::rshift(var_80, var_6);
        var_83 = wp::bit_and(var_81, var_82);
        var_84 = wp::neg(var_83);
        // exchanged = (x[j] ^ z[j]) & low & ~set_z                                           <L 16>
        var_85 = wp::extract(var_0, var_54);
        var_86 = wp::extract(var_2, var_54);
        var_87 = wp::bit_xor(var_85, var_86);
        var_88 = wp::bit_and(var_87, var_10);
        var_89 = wp::invert(var_84);
        var_90 = wp::bit_and(var_88, var_89);
        // x[j] = x[j] ^ (low & set_z | exchanged)                                            <L 17>
        var_91 = wp::extract(var_0, var_54);
        var_92 = wp::bit_and(var_10, var_84);
        var_93 = wp::bit_or(var_92, var_90);
        var_94 = wp::bit_xor(var_91, var_93);
        wp::assign_inplace(var_0, var_54, var_94);
        // z[j] = z[j] ^ exchanged                                                            <L 18>
        var_95 = wp::extract(var_2, var_54);
        var_96 = wp::bit_xor(var_95, var_90);
        wp::assign_inplace(var_2, var_54, var_96);
        // x[j] = x[j] ^ low & -(x[j] >> shift & 1)                                           <L 10>
        var_98 = wp::extract(var_0, var_97);
        var_99 = wp::extract(var_0, var_97);
        var_100 = wp::rshift(var_99, var_6);
        var_102 = wp::bit_and(var_100, var_101);
        var_103 = wp::neg(var_102);
        var_104 = wp::bit_and(var_10, var_103);
        var_105 = wp::bit_xor(var_98, var_104);
        wp::assign_inplace(var_0, var_97, var_105);
        // set_y = -(y[j] >> shift & 1)                                                       <L 11>
        var_106 = wp::extract(var_1, var_97);
        var_107 = wp::rshift(var_106, var_6);
        var_109 = wp::bit_and(var_107, var_108);
        var_110 = wp::neg(var_109);
        // swapped = (x[j] ^ y[j]) & low & ~set_y                                             <L 12>
        var_111 = wp::extract(var_0, var_97);
        var_112 = wp::extract(var_1, var_97);
        var_113 = wp::bit_xor(var_111, var_112);
        var_114 = wp::bit_and(var_113, var_10);
        var_115 = wp::invert(var_110);
        var_116 = wp::bit_and(var_114, var_115);
        // x[j] = x[j] ^ (low & set_y | swapped)                                              <L 13>
        var_117 = wp::extract(var_0, var_97);
        var_118 = wp::bit_and(var_10, var_110);
        var_119 = wp::bit_or(var_118, var_116);
        var_120 = wp::bit_xor(var_117, var_119);
        wp::assign_inplace(var_0, var_97, var_120);
        // y[j] = y[j] ^ swapped                                                              <L 14>
        var_121 = wp::extract(var_1, var_97);
        var_122 = wp::bit_xor(var_121, var_116);
        wp::assign_inplace(var_1, var_97, var_122);
        // set_z = -(z[j] >> shift & 1)                                                       <L 15>
        var_123 = wp::extract(var_2, var_97);
        var_124 = wp::rshift(var_123, var_6);
        var_126 = wp::bit_and(var_124, var_125);
        var_127 = wp::neg(var_126);
        // exchanged = (x[j] ^ z[j]) & low & ~set_z                                           <L 16>
        var_128 = wp::extract(var_0, var_97);
        var_129 = wp::extract(var_2, var_97);
        var_130 = wp::bit_xor(var_128, var_129);
        var_131 = wp::bit_and(var_130, var_10);
        var_132 = wp::invert(var_127);
        var_133 = wp::bit_and(var_131, var_132);
        // x[j] = x[j] ^ (low & set_z | exchanged)                                            <L 17>
        var_134 = wp::extract(var_0, var_97);
        var_135 = wp::bit_and(var_10, var_127);
        var_136 = wp::bit_or(var_135, var_133);
        var_137 = wp::bit_xor(var_134, var_136);
        wp::assign_inplace(var_0, var_97, var_137);
        // z[j] = z[j] ^ exchanged                                                            <L 18>
        var_138 = wp::extract(var_2, var_97);
        var_139 = wp::bit_xor(var_138, var_133);
        wp::assign_inplace(var_2, var_97, var_139);
        // x[j] = x[j] ^ low & -(x[j] >> shift & 1)                                           <L 10>
        var_141 = wp::extract(var_0, var_140);
        var_142 = wp::extract(var_0, var_140);
        var_143 = wp::rshift(var_142, var_6);
        var_145 = wp::bit_and(var_143, var_144);
        var_146 = wp::neg(var_145);
        var_147 = wp::bit_and(var_10, var_146);
        var_148 = wp::bit_xor(var_141, var_147);
        wp::assign_inplace(var_0, var_140, var_148);
        // set_y = -(y[j] >> shift & 1)                                                       <L 11>
        var_149 = wp::extract(var_1, var_140);
        var_150 = wp::rshift(var_149, var_6);
        var_152 = wp::bit_and(var_150, var_151);
        var_153 = wp::neg(var_152);
        // swapped = (x[j] ^ y[j]) & low & ~set_y                                             <L 12>
        var_154 = wp::extract(var_0, var_140);
        var_155 = wp::extract(var_1, var_140);
        var_156 = wp::bit_xor(var_154, var_155);
        var_157 = wp::bit_and(var_156, var_10);
        var_158 = wp::invert(var_153);
        var_159 = wp::bit_and(var_157, var_158);
        // x[j] = x[j] ^ (low & set_y | swapped)                                              <L 13>
        var_160 = wp::extract(var_0, var_140);
        var_161 = wp::bit_and(var_10, var_153);
        var_162 = wp::bit_or(var_161, var_159);
        var_163 = wp::bit_xor(var_160, var_162);
        wp::assign_inplace(var_0, var_140, var_163);
        // y[j] = y[j] ^ swapped                                                              <L 14>
        var_164 = wp::extract(var_1, var_140);
        var_165 = wp::bit_xor(var_164, var_159);
        wp::assign_inplace(var_1, var_140, var_165);
        // set_z = -(z[j] >> shift & 1)                                                       <L 15>
        var_166 = wp::extract(var_2, var_140);
        var_167 = wp::rshift(var_166, var_6);
        var_169 = wp::bit_and(var_167, var_168);
        var_170 = wp::neg(var_169);
        // exchanged = (x[j] ^ z[j]) & low & ~set_z                                           <L 16>
        var_171 = wp::extract(var_0, var_140);
        var_172 = wp::extract(var_2, var_140);
        var_173 = wp::bit_xor(var_171, var_172);
        var_174 = wp::bit_and(var_173, var_10);
        var_175 = wp::invert(var_170);
        var_176 = wp::bit_and(var_174, var_175);
        // x[j] = x[j] ^ (low & set_z | exchanged)                                            <L 17>
        var_177 = wp::extract(var_0, var_140);
        var_178 = wp::bit_and(var_10, var_170);
        var_179 = wp::bit_or(var_178, var_176);
        var_180 = wp::bit_xor(var_177, var_179);
        wp::assign_inplace(var_0, var_140, var_180);
        // z[j] = z[j] ^ exchanged                                                            <L 18>
        var_181 = wp::extract(var_2, var_140);
        var_182 = wp::bit_xor(var_181, var_176);
        wp::assign_inplace(var_2, var_140, var_182);
        // x[j] = x[j] ^ low & -(x[j] >> shift & 1)                                           <L 10>
        var_184 = wp::extract(var_0, var_183);
        var_185 = wp::extract(var_0, var_183);
        var_186 = wp::rshift(var_185, var_6);
        var_188 = wp::bit_and(var_186, var_187);
        var_189 = wp::neg(var_188);
        var_190 = wp::bit_and(var_10, var_189);
        var_191 = wp::bit_xor(var_184, var_190);
        wp::assign_inplace(var_0, var_183, var_191);
        // set_y = -(y[j] >> shift & 1)                                                       <L 11>
        var_192 = wp::extract(var_1, var_183);
        var_193 = wp::rshift(var_192, var_6);
        var_195 = wp::bit_and(var_193, var_194);
        var_196 = wp::neg(var_195);
        // swapped = (x[j] ^ y[j]) & low & ~set_y                                             <L 12>
        var_197 = wp::extract(var_0, var_183);
        var_198 = wp::extract(var_1, var_183);
        var_199 = wp::bit_xor(var_197, var_198);
        var_200 = wp::bit_and(var_199, var_10);
        var_201 = wp::invert(var_196);
        var_202 = wp::bit_and(var_200, var_201);
        // x[j] = x[j] ^ (low & set_y | swapped)                                              <L 13>
        var_203 = wp::extract(var_0, var_183);
        var_204 = wp::bit_and(var_10, var_196);
        var_205 = wp::bit_or(var_204, var_202);
        var_206 = wp::bit_xor(var_203, var_205);
        wp::assign_inplace(var_0, var_183, var_206);
        // y[j] = y[j] ^ swapped                                                              <L 14>
        var_207 = wp::extract(var_1, var_183);
        var_208 = wp::bit_xor(var_207, var_202);
        wp::assign_inplace(var_1, var_183, var_208);
        // set_z = -(z[j] >> shift & 1)                                                       <L 15>
        var_209 = wp::extract(var_2, var_183);
        var_210 = wp::rshift(var_209, var_6);
        var_212 = wp::bit_and(var_210, var_211);
        var_213 = wp::neg(var_212);
        // exchanged = (x[j] ^ z[j]) & low & ~set_z                                           <L 16>
        var_214 = wp::extract(var_0, var_183);
        var_215 = wp::extract(var_2, var_183);
        var_216 = wp::bit_xor(var_214, var_215);
        var_217 = wp::bit_and(var_216, var_10);
        var_218 = wp::invert(var_213);
        var_219 = wp::bit_and(var_217, var_218);
        // x[j] = x[j] ^ (low & set_z | exchanged)                                            <L 17>
        var_220 = wp::extract(var_0, var_183);
        var_221 = wp::bit_and(var_10, var_213);
        var_222 = wp::bit_or(var_221, var_219);
        var_223 = wp::bit_xor(var_220, var_222);
        wp::assign_inplace(var_0, var_183, var_223);
        // z[j] = z[j] ^ exchanged                                                            <L 18>
        var_224 = wp::extract(var_2, var_183);
        var_225 = wp::bit_xor(var_224, var_219);
        wp::assign_inplace(var_2, var_183, var_225);
        // x[j] = x[j] ^ low & -(x[j] >> shift & 1)                                           <L 10>
        var_227 = wp::extract(var_0, var_226);
        var_228 = wp::extract(var_0, var_226);
        var_229 = wp::rshift(var_228, var_6);
        var_231 = wp::bit_and(var_229, var_230);
        var_232 = wp::neg(var_231);
        var_233 = wp::bit_and(var_10, var_232);
        var_234 = wp::bit_xor(var_227, var_233);
        wp::assign_inplace(var_0, var_226, var_234);
        // set_y = -(y[j] >> shift & 1)                                                       <L 11>
        var_235 = wp::extract(var_1, var_226);
        var_236 = wp::rshift(var_235, var_6);
        var_238 = wp::bit_and(var_236, var_237);
        var_239 = wp::neg(var_238);
        // swapped = (x[j] ^ y[j]) & low & ~set_y                                             <L 12>
        var_240 = wp::extract(var_0, var_226);
        var_241 = wp::extract(var_1, var_226);
        var_242 = wp::bit_xor(var_240, var_241);
        var_243 = wp::bit_and(var_242, var_10);
        var_244 = wp::invert(var_239);
        var_245 = wp::bit_and(var_243, var_244);
        // x[j] = x[j] ^ (low & set_y | swapped)                                              <L 13>
        var_246 = wp::extract(var_0, var_226);
        var_247 = wp::bit_and(var_10, var_239);
        var_248 = wp::bit_or(var_247, var_245);
        var_249 = wp::bit_xor(var_246, var_248);
        wp::assign_inplace(var_0, var_226, var_249);
        // y[j] = y[j] ^ swapped                                                              <L 14>
        var_250 = wp::extract(var_1, var_226);
        var_251 = wp::bit_xor(var_250, var_245);
        wp::assign_inplace(var_1, var_226, var_251);
        // set_z = -(z[j] >> shift & 1)                                                       <L 15>
        var_252 = wp::extract(var_2, var_226);
        var_253 = wp::rshift(var_252, var_6);
        var_255 = wp::bit_and(var_253, var_254);
        var_256 = wp::neg(var_255);
        // exchanged = (x[j] ^ z[j]) & low & ~set_z                                           <L 16>
        var_257 = wp::extract(var_0, var_226);
        var_258 = wp::extract(var_2, var_226);
        var_259 = wp::bit_xor(var_257, var_258);
        var_260 = wp::bit_and(var_259, var_10);
        var_261 = wp::invert(var_256);
        var_262 = wp::bit_and(var_260, var_261);
        // x[j] = x[j] ^ (low & set_z | exchanged)                                            <L 17>
        var_263 = wp::extract(var_0, var_226);
        var_264 = wp::bit_and(var_10, var_256);
        var_265 = wp::bit_or(var_264, var_262);
        var_266 = wp::bit_xor(var_263, var_265);
        wp::assign_inplace(var_0, var_226, var_266);
        // z[j] = z[j] ^ exchanged                                                            <L 18>
        var_267 = wp::extract(var_2, var_226);
        var_268 = wp::bit_xor(var_267, var_262);
        wp::assign_inplace(var_2, var_226, var_268);
        // x[j] = x[j] ^ low & -(x[j] >> shift & 1)                                           <L 10>
        var_270 = wp::extract(var_0, var_269);
        var_271 = wp::extract(var_0, var_269);
        var_272 = wp::rshift(var_271, var_6);
        var_274 = wp::bit_and(var_272, var_273);
        var_275 = wp::neg(var_274);
        var_276 = wp::bit_and(var_10, var_275);
        var_277 = wp::bit_xor(var_270, var_276);
        wp::assign_inplace(var_0, var_269, var_277);
        // set_y = -(y[j] >> shift & 1)                                                       <L 11>
        var_278 = wp::extract(var_1, var_269);
        var_279 = wp::rshift(var_278, var_6);
        var_281 = wp::bit_and(var_279, var_280);
        var_282 = wp::neg(var_281);
        // swapped = (x[j] ^ y[j]) & low & ~set_y                                             <L 12>
        var_283 = wp::extract(var_0, var_269);
        var_284 = wp::extract(var_1, var_269);
        var_285 = wp::bit_xor(var_283, var_284);
        var_286 = wp::bit_and(var_285, var_10);
        var_287 = wp::invert(var_282);
        var_288 = wp::bit_and(var_286, var_287);
        // x[j] = x[j] ^ (low & set_y | swapped)                                              <L 13>
        var_289 = wp::extract(var_0, var_269);
        var_290 = wp::bit_and(var_10, var_282);
        var_291 = wp::bit_or(var_290, var_288);
        var_292 = wp::bit_xor(var_289, var_291);
        wp::assign_inplace(var_0, var_269, var_292);
        // y[j] = y[j] ^ swapped                                                              <L 14>
        var_293 = wp::extract(var_1, var_269);
        var_294 = wp::bit_xor(var_293, var_288);
        wp::assign_inplace(var_1, var_269, var_294);
        // set_z = -(z[j] >> shift & 1)                                                       <L 15>
        var_295 = wp::extract(var_2, var_269);
        var_296 = wp::rshift(var_295, var_6);
        var_298 = wp::bit_and(var_296, var_297);
        var_299 = wp::neg(var_298);
        // exchanged = (x[j] ^ z[j]) & low & ~set_z                                           <L 16>
        var_300 = wp::extract(var_0, var_269);
        var_301 = wp::extract(var_2, var_269);
        var_302 = wp::bit_xor(var_300, var_301);
        var_303 = wp::bit_and(var_302, var_10);
        var_304 = wp::invert(var_299);
        var_305 = wp::bit_and(var_303, var_304);
        // x[j] = x[j] ^ (low & set_z | exchanged)                                            <L 17>
        var_306 = wp::extract(var_0, var_269);
        var_307 = wp::bit_and(var_10, var_299);
        var_308 = wp::bit_or(var_307, var_305);
        var_309 = wp::bit_xor(var_306, var_308);
        wp::assign_inplace(var_0, var_269, var_309);
        // z[j] = z[j] ^ exchanged                                                            <L 18>
        var_310 = wp::extract(var_2, var_269);
        var_311 = wp::bit_xor(var_310, var_305);
        wp::assign_inplace(var_2, var_269, var_311);
        // x[j] = x[j] ^ low & -(x[j] >> shift & 1)                                           <L 10>
        var_313 = wp::extract(var_0, var_312);
        var_314 = wp::extract(var_0, var_312);
        var_315 = wp::rshift(var_314, var_6);
        var_317 = wp::bit_and(var_315, var_316);
        var_318 = wp::neg(var_317);
        var_319 = wp::bit_and(var_10, var_318);
        var_320 = wp::bit_xor(var_313, var_319);
        wp::assign_inplace(var_0, var_312, var_320);
        // set_y = -(y[j] >> shift & 1)                                                       <L 11>
        var_321 = wp::extract(var_1, var_312);
        var_322 = wp::rshift(var_321, var_6);
        var_324 = wp::bit_and(var_322, var_323);
        var_325 = wp::neg(var_324);
        // swapped = (x[j] ^ y[j]) & low & ~set_y                                             <L 12>
        var_326 = wp::extract(var_0, var_312);
        var_327 = wp::extract(var_1, var_312);
        var_328 = wp::bit_xor(var_326, var_327);
        var_329 = wp::bit_and(var_328, var_10);
        var_330 = wp::invert(var_325);
        var_331 = wp::bit_and(var_329, var_330);
        // x[j] = x[j] ^ (low & set_y | swapped)                                              <L 13>
        var_332 = wp::extract(var_0, var_312);
        var_333 = wp::bit_and(var_10, var_325);
        var_334 = wp::bit_or(var_333, var_331);
        var_335 = wp::bit_xor(var_332, var_334);
        wp::assign_inplace(var_0, var_312, var_335);
        // y[j] = y[j] ^ swapped                                                              <L 14>
        var_336 = wp::extract(var_1, var_312);
        var_337 = wp::bit_xor(var_336, var_331);
        wp::assign_inplace(var_1, var_312, var_337);
        // set_z = -(z[j] >> shift & 1)                                                       <L 15>
        var_338 = wp::extract(var_2, var_312);
        var_339 = wp::rshift(var_338, var_6);
        var_341 = wp::bit_and(var_339, var_340);
        var_342 = wp::neg(var_341);
        // exchanged = (x[j] ^ z[j]) & low & ~set_z                                           <L 16>
        var_343 = wp::extract(var_0, var_312);
        var_344 = wp::extract(var_2, var_312);
        var_345 = wp::bit_xor(var_343, var_344);
        var_346 = wp::bit_and(var_345, var_10);
        var_347 = wp::invert(var_342);
        var_348 = wp::bit_and(var_346, var_347);
        // x[j] = x[j] ^ (low & set_z | exchanged)                                            <L 17>
        var_349 = wp::extract(var_0, var_312);
        var_350 = wp::bit_and(var_10, var_342);
        var_351 = wp::bit_or(var_350, var_348);
        var_352 = wp::bit_xor(var_349, var_351);
        wp::assign_inplace(var_0, var_312, var_352);
        // z[j] = z[j] ^ exchanged                                                            <L 18>
        var_353 = wp::extract(var_2, var_312);
        var_354 = wp::bit_xor(var_353, var_348);
        wp::assign_inplace(var_2, var_312, var_354);
        goto start_for_0;
    end_for_0:;
    // codes = lane_codes(int64(0))                                                           <L 19>
    var_355 = 0ll;
    var_356 = wp::vec_t<8, wp::int64>(var_355);
    // for j in range(LANES):                                                                 <L 20>
    // y[j] = y[j] ^ x[j]                                                                     <L 21>
    var_358 = wp::extract(var_1, var_357);
    var_359 = wp::extract(var_0, var_357);
    var_360 = wp::bit_xor(var_358, var_359);
    wp::assign_inplace(var_1, var_357, var_360);
    // z[j] = z[j] ^ y[j]                                                                     <L 22>
    var_361 = wp::extract(var_2, var_357);
    var_362 = wp::extract(var_1, var_357);
    var_363 = wp::bit_xor(var_361, var_362);
    wp::assign_inplace(var_2, var_357, var_363);
    // flip = z[j] ^ z[j] >> 1                                                                <L 23>
    var_364 = wp::extract(var_2, var_357);
    var_365 = wp::extract(var_2, var_357);
    var_367 = wp::rshift(var_365, var_366);
    var_368 = wp::bit_xor(var_364, var_367);
    // flip = flip ^ flip >> 2                                                                <L 24>
    var_370 = wp::rshift(var_368, var_369);
    var_371 = wp::bit_xor(var_368, var_370);
    // flip = flip ^ flip >> 4                                                                <L 25>
    var_373 = wp::rshift(var_371, var_372);
    var_374 = wp::bit_xor(var_371, var_373);
    // flip = (flip ^ flip >> 8) >> 1                                                         <L 26>
    var_376 = wp::rshift(var_374, var_375);
    var_377 = wp::bit_xor(var_374, var_376);
    var_379 = wp::rshift(var_377, var_378);
    // x[j] = x[j] ^ flip                                                                     <L 27>
    var_380 = wp::extract(var_0, var_357);
    var_381 = wp::bit_xor(var_380, var_379);
    wp::assign_inplace(var_0, var_357, var_381);
    // y[j] = y[j] ^ flip                                                                     <L 28>
    var_382 = wp::extract(var_1, var_357);
    var_383 = wp::bit_xor(var_382, var_379);
    wp::assign_inplace(var_1, var_357, var_383);
    // z[j] = z[j] ^ flip                                                                     <L 29>
    var_384 = wp::extract(var_2, var_357);
    var_385 = wp::bit_xor(var_384, var_379);
    wp::assign_inplace(var_2, var_357, var_385);
    // codes[j] = spread_bits(x[j]) << int64(2) | spread_bits(y[j]) << int64(1) | spread_bits(z[j])       <L 30>
    var_386 = wp::extract(var_0, var_357);
    var_387 = spread_bits_0(var_386);
    var_388 = 2ll;
    var_389 = wp::lshift(var_387, var_388);
    var_390 = wp::extract(var_1, var_357);
    var_391 = spread_bits_0(var_390);
    var_392 = 1ll;
    var_393 = wp::lshift(var_391, var_392);
    var_394 = wp::bit_or(var_389, var_393);
    var_395 = wp::extract(var_2, var_357);
    var_396 = spread_bits_0(var_395);
    var_397 = wp::bit_or(var_394, var_396);
    wp::assign_inplace(var_356, var_357, var_397);
    // y[j] = y[j] ^ x[j]                                                                     <L 21>
    var_399 = wp::extract(var_1, var_398);
    var_400 = wp::extract(var_0, var_398);
    var_401 = wp::bit_xor(var_399, var_400);
    wp::assign_inplace(var_1, var_398, var_401);
    // z[j] = z[j] ^ y[j]                                                                     <L 22>
    var_402 = wp::extract(var_2, var_398);
    var_403 = wp::extract(var_1, var_398);
    var_404 = wp::bit_xor(var_402, var_403);
    wp::assign_inplace(var_2, var_398, var_404);
    // flip = z[j] ^ z[j] >> 1                                                                <L 23>
    var_405 = wp::extract(var_2, var_398);
    var_406 = wp::extract(var_2, var_398);
    var_408 = wp::rshift(var_406, var_407);
    var_409 = wp::bit_xor(var_405, var_408);
    // flip = flip ^ flip >> 2                                                                <L 24>
    var_411 = wp::rshift(var_409, var_410);
    var_412 = wp::bit_xor(var_409, var_411);
    // flip = flip ^ flip >> 4                                                                <L 25>
    var_414 = wp::rshift(var_412, var_413);
    var_415 = wp::bit_xor(var_412, var_414);
    // flip = (flip ^ flip >> 8) >> 1                                                         <L 26>
    var_417 = wp::rshift(var_415, var_416);
    var_418 = wp::bit_xor(var_415, var_417);
    var_420 = wp::rshift(var_418, var_419);
    // x[j] = x[j] ^ flip                                                                     <L 27>
    var_421 = wp::extract(var_0, var_398);
    var_422 = wp::bit_xor(var_421, var_420);
    wp::assign_inplace(var_0, var_398, var_422);
    // y[j] = y[j] ^ flip                                                                     <L 28>
    var_423 = wp::extract(var_1, var_398);
    var_424 = wp::bit_xor(var_423, var_420);
    wp::assign_inplace(var_1, var_398, var_424);
    // z[j] = z[j] ^ flip                                                                     <L 29>
    var_425 = wp::extract(var_2, var_398);
    var_426 = wp::bit_xor(var_425, var_420);
    wp::assign_inplace(var_2, var_398, var_426);
    // codes[j] = spread_bits(x[j]) << int64(2) | spread_bits(y[j]) << int64(1) | spread_bits(z[j])       <L 30>
    var_427 = wp::extract(var_0, var_398);
    var_428 = spread_bits_0(var_427);
    var_429 = 2ll;
    var_430 = wp::lshift(var_428, var_429);
    var_431 = wp::extract(var_1, var_398);
    var_432 = spread_bits_0(var_431);
    var_433 = 1ll;
    var_434 = wp::lshift(var_432, var_433);
    var_435 = wp::bit_or(var_430, var_434);
    var_436 = wp::extract(var_2, var_398);
    var_437 = spread_bits_0(var_436);
    var_438 = wp::bit_or(var_435, var_437);
    wp::assign_inplace(var_356, var_398, var_438);
    // y[j] = y[j] ^ x[j]                                                                     <L 21>
    var_440 = wp::extract(var_1, var_439);
    var_441 = wp::extract(var_0, var_439);
    var_442 = wp::bit_xor(var_440, var_441);
    wp::assign_inplace(var_1, var_439, var_442);
    // z[j] = z[j] ^ y[j]                                                                     <L 22>
    var_443 = wp::extract(var_2, var_439);
    var_444 = wp::extract(var_1, var_439);
    var_445 = wp::bit_xor(var_443, var_444);
    wp::assign_inplace(var_2, var_439, var_445);
    // flip = z[j] ^ z[j] >> 1                                                                <L 23>
    var_446 = wp::extract(var_2, var_439);
    var_447 = wp::extract(var_2, var_439);
    var_449 = wp::rshift(var_447, var_448);
    var_450 = wp::bit_xor(var_446, var_449);
    // flip = flip ^ flip >> 2                                                                <L 24>
    var_452 = wp::rshift(var_450, var_451);
    var_453 = wp::bit_xor(var_450, var_452);
    // flip = flip ^ flip >> 4                                                                <L 25>
    var_455 = wp::rshift(var_453, var_454);
    var_456 = wp::bit_xor(var_453, var_455);
    // flip = (flip ^ flip >> 8) >> 1                                                         <L 26>
    var_458 = wp::rshift(var_456, var_457);
    var_459 = wp::bit_xor(var_456, var_458);
    var_461 = wp::rshift(var_459, var_460);
    // x[j] = x[j] ^ flip                                                                     <L 27>
    var_462 = wp::extract(var_0, var_439);
    var_463 = wp::bit_xor(var_462, var_461);
    wp::assign_inplace(var_0, var_439, var_463);
    // y[j] = y[j] ^ flip                                                                     <L 28>
    var_464 = wp::extract(var_1, var_439);
    var_465 = wp::bit_xor(var_464, var_461);
    wp::assign_inplace(var_1, var_439, var_465);
    // z[j] = z[j] ^ flip                                                                     <L 29>
    var_466 = wp::extract(var_2, var_439);
    var_467 = wp::bit_xor(var_466, var_461);
    wp::assign_inplace(var_2, var_439, var_467);
    // codes[j] = spread_bits(x[j]) << int64(2) | spread_bits(y[j]) << int64(1) | spread_bits(z[j])       <L 30>
    var_468 = wp::extract(var_0, var_439);
    var_469 = spread_bits_0(var_468);
    var_470 = 2ll;
    var_471 = wp::lshift(var_469, var_470);
    var_472 = wp::extract(var_1, var_439);
    var_473 = spread_bits_0(var_472);
    var_474 = 1ll;
    var_475 = wp::lshift(var_473, var_474);
    var_476 = wp::bit_or(var_471, var_475);
    var_477 = wp::extract(var_2, var_439);
    var_478 = spread_bits_0(var_477);
    var_479 = wp::bit_or(var_476, var_478);
    wp::assign_inplace(var_356, var_439, var_479);
    // y[j] = y[j] ^ x[j]                                                                     <L 21>
    var_481 = wp::extract(var_1, var_480);
    var_482 = wp::extract(var_0, var_480);
    var_483 = wp::bit_xor(var_481, var_482);
    wp::assign_inplace(var_1, var_480, var_483);
    // z[j] = z[j] ^ y[j]                                                                     <L 22>
    var_484 = wp::extract(var_2, var_480);
    var_485 = wp::extract(var_1, var_480);
    var_486 = wp::bit_xor(var_484, var_485);
    wp::assign_inplace(var_2, var_480, var_486);
    // flip = z[j] ^ z[j] >> 1                                                                <L 23>
    var_487 = wp::extract(var_2, var_480);
    var_488 = wp::extract(var_2, var_480);
    var_490 = wp::rshift(var_488, var_489);
    var_491 = wp::bit_xor(var_487, var_490);
    // flip = flip ^ flip >> 2                                                                <L 24>
    var_493 = wp::rshift(var_491, var_492);
    var_494 = wp::bit_xor(var_491, var_493);
    // flip = flip ^ flip >> 4                                                                <L 25>
    var_496 = wp::rshift(var_494, var_495);
    var_497 = wp::bit_xor(var_494, var_496);
    // flip = (flip ^ flip >> 8) >> 1                                                         <L 26>
    var_499 = wp::rshift(var_497, var_498);
    var_500 = wp::bit_xor(var_497, var_499);
    var_502 = wp::rshift(var_500, var_501);
    // x[j] = x[j] ^ flip                                                                     <L 27>
    var_503 = wp::extract(var_0, var_480);
    var_504 = wp::bit_xor(var_503, var_502);
    wp::assign_inplace(var_0, var_480, var_504);
    // y[j] = y[j] ^ flip                                                                     <L 28>
    var_505 = wp::extract(var_1, var_480);
    var_506 = wp::bit_xor(var_505, var_502);
    wp::assign_inplace(var_1, var_480, var_506);
    // z[j] = z[j] ^ flip                                                                     <L 29>
    var_507 = wp::extract(var_2, var_480);
    var_508 = wp::bit_xor(var_507, var_502);
    wp::assign_inplace(var_2, var_480, var_508);
    // codes[j] = spread_bits(x[j]) << int64(2) | spread_bits(y[j]) << int64(1) | spread_bits(z[j])       <L 30>
    var_509 = wp::extract(var_0, var_480);
    var_510 = spread_bits_0(var_509);
    var_511 = 2ll;
    var_512 = wp::lshift(var_510, var_511);
    var_513 = wp::extract(var_1, var_480);
    var_514 = spread_bits_0(var_513);
    var_515 = 1ll;
    var_516 = wp::lshift(var_514, var_515);
    var_517 = wp::bit_or(var_512, var_516);
    var_518 = wp::extract(var_2, var_480);
    var_519 = spread_bits_0(var_518);
    var_520 = wp::bit_or(var_517, var_519);
    wp::assign_inplace(var_356, var_480, var_520);
    // y[j] = y[j] ^ x[j]                                                                     <L 21>
    var_522 = wp::extract(var_1, var_521);
    var_523 = wp::extract(var_0, var_521);
    var_524 = wp::bit_xor(var_522, var_523);
    wp::assign_inplace(var_1, var_521, var_524);
    // z[j] = z[j] ^ y[j]                                                                     <L 22>
    var_525 = wp::extract(var_2, var_521);
    var_526 = wp::extract(var_1, var_521);
    var_527 = wp::bit_xor(var_525, var_526);
    wp::assign_inplace(var_2, var_521, var_527);
    // flip = z[j] ^ z[j] >> 1                                                                <L 23>
    var_528 = wp::extract(var_2, var_521);
    var_529 = wp::extract(var_2, var_521);
    var_531 = wp::rshift(var_529, var_530);
    var_532 = wp::bit_xor(var_528, var_531);
    // flip = flip ^ flip >> 2                                                                <L 24>
    var_534 = wp::rshift(var_532, var_533);
    var_535 = wp::bit_xor(var_532, var_534);
    // flip = flip ^ flip >> 4                                                                <L 25>
    var_537 = wp::rshift(var_535, var_536);
    var_538 = wp::bit_xor(var_535, var_537);
    // flip = (flip ^ flip >> 8) >> 1                                                         <L 26>
    var_540 = wp::rshift(var_538, var_539);
    var_541 = wp::bit_xor(var_538, var_540);
    var_543 = wp::rshift(var_541, var_542);
    // x[j] = x[j] ^ flip                                                                     <L 27>
    var_544 = wp::extract(var_0, var_521);
    var_545 = wp::bit_xor(var_544, var_543);
    wp::assign_inplace(var_0, var_521, var_545);
    // y[j] = y[j] ^ flip                                                                     <L 28>
    var_546 = wp::extract(var_1, var_521);
    var_547 = wp::bit_xor(var_546, var_543);
    wp::assign_inplace(var_1, var_521, var_547);
    // z[j] = z[j] ^ flip                                                                     <L 29>
    var_548 = wp::extract(var_2, var_521);
    var_549 = wp::bit_xor(var_548, var_543);
    wp::assign_inplace(var_2, var_521, var_549);
    // codes[j] = spread_bits(x[j]) << int64(2) | spread_bits(y[j]) << int64(1) | spread_bits(z[j])       <L 30>
    var_550 = wp::extract(var_0, var_521);
    var_551 = spread_bits_0(var_550);
    var_552 = 2ll;
    var_553 = wp::lshift(var_551, var_552);
    var_554 = wp::extract(var_1, var_521);
    var_555 = spread_bits_0(var_554);
    var_556 = 1ll;
    var_557 = wp::lshift(var_555, var_556);
    var_558 = wp::bit_or(var_553, var_557);
    var_559 = wp::extract(var_2, var_521);
    var_560 = spread_bits_0(var_559);
    var_561 = wp::bit_or(var_558, var_560);
    wp::assign_inplace(var_356, var_521, var_561);
    // y[j] = y[j] ^ x[j]                                                                     <L 21>
    var_563 = wp::extract(var_1, var_562);
    var_564 = wp::extract(var_0, var_562);
    var_565 = wp::bit_xor(var_563, var_564);
    wp::assign_inplace(var_1, var_562, var_565);
    // z[j] = z[j] ^ y[j]                                                                     <L 22>
    var_566 = wp::extract(var_2, var_562);
    var_567 = wp::extract(var_1, var_562);
    var_568 = wp::bit_xor(var_566, var_567);
    wp::assign_inplace(var_2, var_562, var_568);
    // flip = z[j] ^ z[j] >> 1                                                                <L 23>
    var_569 = wp::extract(var_2, var_562);
    var_570 = wp::extract(var_2, var_562);
    var_572 = wp::rshift(var_570, var_571);
    var_573 = wp::bit_xor(var_569, var_572);
    // flip = flip ^ flip >> 2                                                                <L 24>
    var_575 = wp::rshift(var_573, var_574);
    var_576 = wp::bit_xor(var_573, var_575);
    // flip = flip ^ flip >> 4                                                                <L 25>
    var_578 = wp::rshift(var_576, var_577);
    var_579 = wp::bit_xor(var_576, var_578);
    // flip = (flip ^ flip >> 8) >> 1                                                         <L 26>
    var_581 = wp::rshift(var_579, var_580);
    var_582 = wp::bit_xor(var_579, var_581);
    var_584 = wp::rshift(var_582, var_583);
    // x[j] = x[j] ^ flip                                                                     <L 27>
    var_585 = wp::extract(var_0, var_562);
    var_586 = wp::bit_xor(var_585, var_584);
    wp::assign_inplace(var_0, var_562, var_586);
    // y[j] = y[j] ^ flip                                                                     <L 28>
    var_587 = wp::extract(var_1, var_562);
    var_588 = wp::bit_xor(var_587, var_584);
    wp::assign_inplace(var_1, var_562, var_588);
    // z[j] = z[j] ^ flip                                                                     <L 29>
    var_589 = wp::extract(var_2, var_562);
    var_590 = wp::bit_xor(var_589, var_584);
    wp::assign_inplace(var_2, var_562, var_590);
    // codes[j] = spread_bits(x[j]) << int64(2) | spread_bits(y[j]) << int64(1) | spread_bits(z[j])       <L 30>
    var_591 = wp::extract(var_0, var_562);
    var_592 = spread_bits_0(var_591);
    var_593 = 2ll;
    var_594 = wp::lshift(var_592, var_593);
    var_595 = wp::extract(var_1, var_562);
    var_596 = spread_bits_0(var_595);
    var_597 = 1ll;
    var_598 = wp::lshift(var_596, var_597);
    var_599 = wp::bit_or(var_594, var_598);
    var_600 = wp::extract(var_2, var_562);
    var_601 = spread_bits_0(var_600);
    var_602 = wp::bit_or(var_599, var_601);
    wp::assign_inplace(var_356, var_562, var_602);
    // y[j] = y[j] ^ x[j]                                                                     <L 21>
    var_604 = wp::extract(var_1, var_603);
    var_605 = wp::extract(var_0, var_603);
    var_606 = wp::bit_xor(var_604, var_605);
    wp::assign_inplace(var_1, var_603, var_606);
    // z[j] = z[j] ^ y[j]                                                                     <L 22>
    var_607 = wp::extract(var_2, var_603);
    var_608 = wp::extract(var_1, var_603);
    var_609 = wp::bit_xor(var_607, var_608);
    wp::assign_inplace(var_2, var_603, var_609);
    // flip = z[j] ^ z[j] >> 1                                                                <L 23>
    var_610 = wp::extract(var_2, var_603);
    var_611 = wp::extract(var_2, var_603);
    var_613 = wp::rshift(var_611, var_612);
    var_614 = wp::bit_xor(var_610, var_613);
    // flip = flip ^ flip >> 2                                                                <L 24>
    var_616 = wp::rshift(var_614, var_615);
    var_617 = wp::bit_xor(var_614, var_616);
    // flip = flip ^ flip >> 4                                                                <L 25>
    var_619 = wp::rshift(var_617, var_618);
    var_620 = wp::bit_xor(var_617, var_619);
    // flip = (flip ^ flip >> 8) >> 1                                                         <L 26>
    var_622 = wp::rshift(var_620, var_621);
    var_623 = wp::bit_xor(var_620, var_622);
    var_625 = wp::rshift(var_623, var_624);
    // x[j] = x[j] ^ flip                                                                     <L 27>
    var_626 = wp::extract(var_0, var_603);
    var_627 = wp::bit_xor(var_626, var_625);
    wp::assign_inplace(var_0, var_603, var_627);
    // y[j] = y[j] ^ flip                                                                     <L 28>
    var_628 = wp::extract(var_1, var_603);
    var_629 = wp::bit_xor(var_628, var_625);
    wp::assign_inplace(var_1, var_603, var_629);
    // z[j] = z[j] ^ flip                                                                     <L 29>
    var_630 = wp::extract(var_2, var_603);
    var_631 = wp::bit_xor(var_630, var_625);
    wp::assign_inplace(var_2, var_603, var_631);
    // codes[j] = spread_bits(x[j]) << int64(2) | spread_bits(y[j]) << int64(1) | spread_bits(z[j])       <L 30>
    var_632 = wp::extract(var_0, var_603);
    var_633 = spread_bits_0(var_632);
    var_634 = 2ll;
    var_635 = wp::lshift(var_633, var_634);
    var_636 = wp::extract(var_1, var_603);
    var_637 = spread_bits_0(var_636);
    var_638 = 1ll;
    var_639 = wp::lshift(var_637, var_638);
    var_640 = wp::bit_or(var_635, var_639);
    var_641 = wp::extract(var_2, var_603);
    var_642 = spread_bits_0(var_641);
    var_643 = wp::bit_or(var_640, var_642);
    wp::assign_inplace(var_356, var_603, var_643);
    // y[j] = y[j] ^ x[j]                                                                     <L 21>
    var_645 = wp::extract(var_1, var_644);
    var_646 = wp::extract(var_0, var_644);
    var_647 = wp::bit_xor(var_645, var_646);
    wp::assign_inplace(var_1, var_644, var_647);
    // z[j] = z[j] ^ y[j]                                                                     <L 22>
    var_648 = wp::extract(var_2, var_644);
    var_649 = wp::extract(var_1, var_644);
    var_650 = wp::bit_xor(var_648, var_649);
    wp::assign_inplace(var_2, var_644, var_650);
    // flip = z[j] ^ z[j] >> 1                                                                <L 23>
    var_651 = wp::extract(var_2, var_644);
    var_652 = wp::extract(var_2, var_644);
    var_654 = wp::rshift(var_652, var_653);
    var_655 = wp::bit_xor(var_651, var_654);
    // flip = flip ^ flip >> 2                                                                <L 24>
    var_657 = wp::rshift(var_655, var_656);
    var_658 = wp::bit_xor(var_655, var_657);
    // flip = flip ^ flip >> 4                                                                <L 25>
    var_660 = wp::rshift(var_658, var_659);
    var_661 = wp::bit_xor(var_658, var_660);
    // flip = (flip ^ flip >> 8) >> 1                                                         <L 26>
    var_663 = wp::rshift(var_661, var_662);
    var_664 = wp::bit_xor(var_661, var_663);
    var_666 = wp::rshift(var_664, var_665);
    // x[j] = x[j] ^ flip                                                                     <L 27>
    var_667 = wp::extract(var_0, var_644);
    var_668 = wp::bit_xor(var_667, var_666);
    wp::assign_inplace(var_0, var_644, var_668);
    // y[j] = y[j] ^ flip                                                                     <L 28>
    var_669 = wp::extract(var_1, var_644);
    var_670 = wp::bit_xor(var_669, var_666);
    wp::assign_inplace(var_1, var_644, var_670);
    // z[j] = z[j] ^ flip                                                                     <L 29>
    var_671 = wp::extract(var_2, var_644);
    var_672 = wp::bit_xor(var_671, var_666);
    wp::assign_inplace(var_2, var_644, var_672);
    // codes[j] = spread_bits(x[j]) << int64(2) | spread_bits(y[j]) << int64(1) | spread_bits(z[j])       <L 30>
    var_673 = wp::extract(var_0, var_644);
    var_674 = spread_bits_0(var_673);
    var_675 = 2ll;
    var_676 = wp::lshift(var_674, var_675);
    var_677 = wp::extract(var_1, var_644);
    var_678 = spread_bits_0(var_677);
    var_679 = 1ll;
    var_680 = wp::lshift(var_678, var_679);
    var_681 = wp::bit_or(var_676, var_680);
    var_682 = wp::extract(var_2, var_644);
    var_683 = spread_bits_0(var_682);
    var_684 = wp::bit_or(var_681, var_683);
    wp::assign_inplace(var_356, var_644, var_684);
    // return codes                                                                           <L 31>
    return var_356;
}


// <pointloom.kernels.search.hilbert_order.locate_on_curve>:1
static CUDA_CALLABLE wp::int64 locate_on_curve_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> var_curve__low,
    wp::float32 var_curve__scale,
    wp::int32 var_curve__levels)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    const wp::int32 var_2 = 0;
    wp::float32 var_3;
    wp::int32 var_4;
    wp::vec_t<8, wp::int32> var_5;
    const wp::int32 var_6 = 1;
    wp::float32 var_7;
    const wp::int32 var_8 = 1;
    wp::float32 var_9;
    wp::int32 var_10;
    wp::vec_t<8, wp::int32> var_11;
    const wp::int32 var_12 = 2;
    wp::float32 var_13;
    const wp::int32 var_14 = 2;
    wp::float32 var_15;
    wp::int32 var_16;
    wp::vec_t<8, wp::int32> var_17;
    wp::vec_t<8, wp::int64> var_18;
    const wp::int32 var_19 = 0;
    wp::int64 var_20;
    //---------
    // forward
    // def locate_on_curve(p, curve__low, curve__scale, curve__levels):                       <L 1>
    // x = lanes(cell_on_axis(p[0], curve__low[0], curve__scale, curve__levels))              <L 3>
    var_1 = wp::extract(var_p, var_0);
    var_3 = wp::extract(var_curve__low, var_2);
    var_4 = cell_on_axis_0(var_1, var_3, var_curve__scale, var_curve__levels);
    var_5 = wp::vec_t<8, wp::int32>(var_4);
    // y = lanes(cell_on_axis(p[1], curve__low[1], curve__scale, curve__levels))              <L 4>
    var_7 = wp::extract(var_p, var_6);
    var_9 = wp::extract(var_curve__low, var_8);
    var_10 = cell_on_axis_0(var_7, var_9, var_curve__scale, var_curve__levels);
    var_11 = wp::vec_t<8, wp::int32>(var_10);
    // z = lanes(cell_on_axis(p[2], curve__low[2], curve__scale, curve__levels))              <L 5>
    var_13 = wp::extract(var_p, var_12);
    var_15 = wp::extract(var_curve__low, var_14);
    var_16 = cell_on_axis_0(var_13, var_15, var_curve__scale, var_curve__levels);
    var_17 = wp::vec_t<8, wp::int32>(var_16);
    // codes = hilbert_codes(x, y, z, curve__levels)                                          <L 6>
    var_18 = hilbert_codes_0(var_5, var_11, var_17, var_curve__levels);
    // return codes[0]                                                                        <L 7>
    var_20 = wp::extract(var_18, var_19);
    return var_20;
}


// <pointloom.kernels.search.point_tree.find_run>:1
static CUDA_CALLABLE wp::int32 find_run_0(
    wp::array_t<wp::int64> var_codes,
    wp::int32 var_first,
    wp::int32 var_count,
    wp::int64 var_code)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    wp::int32 var_2;
    wp::int32 var_3;
    const wp::int32 var_4 = 1;
    bool var_5;
    wp::int32 var_6;
    const wp::int32 var_7 = 2;
    wp::int32 var_8;
    wp::int32 var_9;
    wp::int64* var_10;
    bool var_11;
    wp::int64 var_12;
    wp::int32 var_13;
    wp::int32 var_14;
    wp::int32 var_15;
    wp::int32 var_16;
    //---------
    // forward
    // def find_run(codes, first, count, code):                                               <L 1>
    // a = int(0)                                                                             <L 3>
    var_1 = wp::int(var_0);
    // b = count                                                                              <L 4>
    var_2 = wp::copy(var_count);
    // while b - a > 1:                                                                       <L 5>
    start_while_0:;
    var_3 = wp::sub(var_2, var_1);
    var_5 = (var_3 > var_4);
    if ((var_5) == false) goto end_while_0;
        // middle = (a + b) // 2                                                              <L 6>
        var_6 = wp::add(var_1, var_2);
        var_8 = wp::floordiv(var_6, var_7);
        // if codes[first + middle] <= code:                                                  <L 7>
        var_9 = wp::add(var_first, var_8);
        var_10 = wp::address(var_codes, var_9);
        var_12 = wp::load(var_10);
        var_11 = (var_12 <= var_code);
        if (var_11) {
            // a = middle                                                                     <L 8>
            var_13 = wp::copy(var_8);
        }
        if (!var_11) {
            // b = middle                                                                     <L 10>
            var_14 = wp::copy(var_8);
        }
        var_15 = wp::where(var_11, var_13, var_1);
        var_16 = wp::where(var_11, var_2, var_14);
        wp::assign(var_1, var_15);
        wp::assign(var_2, var_16);
    goto start_while_0;
    end_while_0:;
    // return a                                                                               <L 11>
    return var_1;
}


// <pointloom.kernels.search.point_tree.find_bucket>:1
static CUDA_CALLABLE wp::int32 find_bucket_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::int32 var_tree__count,
    wp::array_t<wp::int64> var_tree__codes,
    wp::vec_t<3, wp::float32> var_tree__curve__low,
    wp::float32 var_tree__curve__scale,
    wp::int32 var_tree__curve__levels)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    const wp::int32 var_1 = 64;
    wp::int32 var_2;
    const wp::int32 var_3 = 1;
    wp::int32 var_4;
    wp::int32 var_5;
    wp::int64 var_6;
    wp::int32 var_7;
    //---------
    // forward
    // def find_bucket(p, tree__count, tree__codes, tree__curve__low, tree__curve__scale, tree__curve__levels):       <L 1>
    // return find_run(tree__codes, 0, (tree__count + BUCKET - 1) // BUCKET, locate_on_curve(p, tree__curve__low, tree__curve__scale, tree__curve__levels))       <L 2>
    var_2 = wp::add(var_tree__count, var_1);
    var_4 = wp::sub(var_2, var_3);
    var_5 = wp::floordiv(var_4, var_1);
    var_6 = locate_on_curve_0(var_p, var_tree__curve__low, var_tree__curve__scale, var_tree__curve__levels);
    var_7 = find_run_0(var_tree__codes, var_0, var_5, var_6);
    return var_7;
}


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


// <pointloom.kernels.poses.pose_fitness.count_flags>:1
static CUDA_CALLABLE wp::int32 count_flags_0(
    wp::vec_t<8, wp::int32> var_flags)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
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
    //---------
    // forward
    // def count_flags(flags):                                                                <L 1>
    // total = int(0)                                                                         <L 2>
    var_1 = wp::int(var_0);
    // for j in range(LEAF):                                                                  <L 3>
    // total += flags[j]                                                                      <L 4>
    var_3 = wp::extract(var_flags, var_2);
    var_4 = wp::add(var_1, var_3);
    var_6 = wp::extract(var_flags, var_5);
    var_7 = wp::add(var_4, var_6);
    var_9 = wp::extract(var_flags, var_8);
    var_10 = wp::add(var_7, var_9);
    var_12 = wp::extract(var_flags, var_11);
    var_13 = wp::add(var_10, var_12);
    var_15 = wp::extract(var_flags, var_14);
    var_16 = wp::add(var_13, var_15);
    var_18 = wp::extract(var_flags, var_17);
    var_19 = wp::add(var_16, var_18);
    var_21 = wp::extract(var_flags, var_20);
    var_22 = wp::add(var_19, var_21);
    var_24 = wp::extract(var_flags, var_23);
    var_25 = wp::add(var_22, var_24);
    // return total                                                                           <L 5>
    return var_25;
}


// <pointloom.kernels.poses.pose_fitness.match_leaf>:1
static CUDA_CALLABLE wp::vec_t<8, wp::int32> match_leaf_0(
    wp::int32 var_first,
    wp::int32 var_tree__count,
    wp::array_t<wp::vec_t<3, wp::float32>> var_tree__points,
    wp::vec_t<8, wp::float32> var_xs,
    wp::vec_t<8, wp::float32> var_ys,
    wp::vec_t<8, wp::float32> var_zs,
    wp::float32 var_sqradius,
    wp::vec_t<8, wp::int32> var_matched)
{
    //---------
    // primal vars
    wp::vec_t<8, wp::int32> var_0;
    const wp::int32 var_1 = 8;
    wp::int32 var_2;
    wp::int32 var_3;
    wp::range_t var_4;
    wp::int32 var_5;
    wp::vec_t<3, wp::float32>* var_6;
    wp::vec_t<3, wp::float32> var_7;
    wp::vec_t<3, wp::float32> var_8;
    const wp::int32 var_9 = 0;
    const wp::int32 var_10 = 0;
    wp::float32 var_11;
    wp::float32 var_12;
    wp::float32 var_13;
    const wp::int32 var_14 = 1;
    wp::float32 var_15;
    wp::float32 var_16;
    wp::float32 var_17;
    const wp::int32 var_18 = 2;
    wp::float32 var_19;
    wp::float32 var_20;
    wp::float32 var_21;
    wp::int32 var_22;
    wp::float32 var_23;
    wp::float32 var_24;
    wp::float32 var_25;
    wp::float32 var_26;
    wp::float32 var_27;
    bool var_28;
    const wp::int32 var_29 = 1;
    const wp::int32 var_30 = 0;
    wp::int32 var_31;
    wp::int32 var_32;
    const wp::int32 var_33 = 1;
    const wp::int32 var_34 = 0;
    wp::float32 var_35;
    wp::float32 var_36;
    wp::float32 var_37;
    const wp::int32 var_38 = 1;
    wp::float32 var_39;
    wp::float32 var_40;
    wp::float32 var_41;
    const wp::int32 var_42 = 2;
    wp::float32 var_43;
    wp::float32 var_44;
    wp::float32 var_45;
    wp::int32 var_46;
    wp::float32 var_47;
    wp::float32 var_48;
    wp::float32 var_49;
    wp::float32 var_50;
    wp::float32 var_51;
    bool var_52;
    const wp::int32 var_53 = 1;
    const wp::int32 var_54 = 0;
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
    const wp::int32 var_81 = 3;
    const wp::int32 var_82 = 0;
    wp::float32 var_83;
    wp::float32 var_84;
    wp::float32 var_85;
    const wp::int32 var_86 = 1;
    wp::float32 var_87;
    wp::float32 var_88;
    wp::float32 var_89;
    const wp::int32 var_90 = 2;
    wp::float32 var_91;
    wp::float32 var_92;
    wp::float32 var_93;
    wp::int32 var_94;
    wp::float32 var_95;
    wp::float32 var_96;
    wp::float32 var_97;
    wp::float32 var_98;
    wp::float32 var_99;
    bool var_100;
    const wp::int32 var_101 = 1;
    const wp::int32 var_102 = 0;
    wp::int32 var_103;
    wp::int32 var_104;
    const wp::int32 var_105 = 4;
    const wp::int32 var_106 = 0;
    wp::float32 var_107;
    wp::float32 var_108;
    wp::float32 var_109;
    const wp::int32 var_110 = 1;
    wp::float32 var_111;
    wp::float32 var_112;
    wp::float32 var_113;
    const wp::int32 var_114 = 2;
    wp::float32 var_115;
    wp::float32 var_116;
    wp::float32 var_117;
    wp::int32 var_118;
    wp::float32 var_119;
    wp::float32 var_120;
    wp::float32 var_121;
    wp::float32 var_122;
    wp::float32 var_123;
    bool var_124;
    const wp::int32 var_125 = 1;
    const wp::int32 var_126 = 0;
    wp::int32 var_127;
    wp::int32 var_128;
    const wp::int32 var_129 = 5;
    const wp::int32 var_130 = 0;
    wp::float32 var_131;
    wp::float32 var_132;
    wp::float32 var_133;
    const wp::int32 var_134 = 1;
    wp::float32 var_135;
    wp::float32 var_136;
    wp::float32 var_137;
    const wp::int32 var_138 = 2;
    wp::float32 var_139;
    wp::float32 var_140;
    wp::float32 var_141;
    wp::int32 var_142;
    wp::float32 var_143;
    wp::float32 var_144;
    wp::float32 var_145;
    wp::float32 var_146;
    wp::float32 var_147;
    bool var_148;
    const wp::int32 var_149 = 1;
    const wp::int32 var_150 = 0;
    wp::int32 var_151;
    wp::int32 var_152;
    const wp::int32 var_153 = 6;
    const wp::int32 var_154 = 0;
    wp::float32 var_155;
    wp::float32 var_156;
    wp::float32 var_157;
    const wp::int32 var_158 = 1;
    wp::float32 var_159;
    wp::float32 var_160;
    wp::float32 var_161;
    const wp::int32 var_162 = 2;
    wp::float32 var_163;
    wp::float32 var_164;
    wp::float32 var_165;
    wp::int32 var_166;
    wp::float32 var_167;
    wp::float32 var_168;
    wp::float32 var_169;
    wp::float32 var_170;
    wp::float32 var_171;
    bool var_172;
    const wp::int32 var_173 = 1;
    const wp::int32 var_174 = 0;
    wp::int32 var_175;
    wp::int32 var_176;
    const wp::int32 var_177 = 7;
    const wp::int32 var_178 = 0;
    wp::float32 var_179;
    wp::float32 var_180;
    wp::float32 var_181;
    const wp::int32 var_182 = 1;
    wp::float32 var_183;
    wp::float32 var_184;
    wp::float32 var_185;
    const wp::int32 var_186 = 2;
    wp::float32 var_187;
    wp::float32 var_188;
    wp::float32 var_189;
    wp::int32 var_190;
    wp::float32 var_191;
    wp::float32 var_192;
    wp::float32 var_193;
    wp::float32 var_194;
    wp::float32 var_195;
    bool var_196;
    const wp::int32 var_197 = 1;
    const wp::int32 var_198 = 0;
    wp::int32 var_199;
    wp::int32 var_200;
    //---------
    // forward
    // def match_leaf(first, tree__count, tree__points, xs, ys, zs, sqradius, matched):       <L 1>
    // flags = matched                                                                        <L 3>
    var_0 = wp::copy(var_matched);
    // for i in range(first, min(first + LEAF, tree__count)):                                 <L 4>
    var_2 = wp::add(var_first, var_1);
    var_3 = wp::min(var_2, var_tree__count);
    var_4 = wp::range(var_first, var_3);
    start_for_0:;
        if (iter_cmp(var_4) == 0) goto end_for_0;
        var_5 = wp::iter_next(var_4);
        // p = tree__points[i]                                                                <L 5>
        var_6 = wp::address(var_tree__points, var_5);
        var_8 = wp::load(var_6);
        var_7 = wp::copy(var_8);
        // for j in range(LEAF):                                                              <L 6>
        // x = p[0] - xs[j]                                                                   <L 7>
        var_11 = wp::extract(var_7, var_10);
        var_12 = wp::extract(var_xs, var_9);
        var_13 = wp::sub(var_11, var_12);
        // y = p[1] - ys[j]                                                                   <L 8>
        var_15 = wp::extract(var_7, var_14);
        var_16 = wp::extract(var_ys, var_9);
        var_17 = wp::sub(var_15, var_16);
        // z = p[2] - zs[j]                                                                   <L 9>
        var_19 = wp::extract(var_7, var_18);
        var_20 = wp::extract(var_zs, var_9);
        var_21 = wp::sub(var_19, var_20);
        // flags[j] = flags[j] | (1 if x * x + y * y + z * z <= sqradius else 0)              <L 10>
        var_22 = wp::extract(var_0, var_9);
        var_23 = wp::mul(var_13, var_13);
        var_24 = wp::mul(var_17, var_17);
        var_25 = wp::add(var_23, var_24);
        var_26 = wp::mul(var_21, var_21);
        var_27 = wp::add(var_25, var_26);
        var_28 = (var_27 <= var_sqradius);
        if (var_28) {
        }
        if (!var_28) {
        }
        var_31 = wp::where(var_28, var_29, var_30);
        var_32 = wp::bit_or(var_22, var_31);
        wp::assign_inplace(var_0, var_9, var_32);
        // x = p[0] - xs[j]                                                                   <L 7>
        var_35 = wp::extract(var_7, var_34);
        var_36 = wp::extract(var_xs, var_33);
        var_37 = wp::sub(var_35, var_36);
        // y = p[1] - ys[j]                                                                   <L 8>
        var_39 = wp::extract(var_7, var_38);
        var_40 = wp::extract(var_ys, var_33);
        var_41 = wp::sub(var_39, var_40);
        // z = p[2] - zs[j]                                                                   <L 9>
        var_43 = wp::extract(var_7, var_42);
        var_44 = wp::extract(var_zs, var_33);
        var_45 = wp::sub(var_43, var_44);
        // flags[j] = flags[j] | (1 if x * x + y * y + z * z <= sqradius else 0)              <L 10>
        var_46 = wp::extract(var_0, var_33);
        var_47 = wp::mul(var_37, var_37);
        var_48 = wp::mul(var_41, var_41);
        var_49 = wp::add(var_47, var_48);
        var_50 = wp::mul(var_45, var_45);
        var_51 = wp::add(var_49, var_50);
        var_52 = (var_51 <= var_sqradius);
        if (var_52) {
        }
        if (!var_52) {
        }
        var_55 = wp::where(var_52, var_53, var_54);
        var_56 = wp::bit_or(var_46, var_55);
        wp::assign_inplace(var_0, var_33, var_56);
        // x = p[0] - xs[j]                                                                   <L 7>
        var_59 = wp::extract(var_7, var_58);
        var_60 = wp::extract(var_xs, var_57);
        var_61 = wp::sub(var_59, var_60);
        // y = p[1] - ys[j]                                                                   <L 8>
        var_63 = wp::extract(var_7, var_62);
        var_64 = wp::extract(var_ys, var_57);
        var_65 = wp::sub(var_63, var_64);
        // z = p[2] - zs[j]                                                                   <L 9>
        var_67 = wp::extract(var_7, var_66);
        var_68 = wp::extract(var_zs, var_57);
        var_69 = wp::sub(var_67, var_68);
        // flags[j] = flags[j] | (1 if x * x + y * y + z * z <= sqradius else 0)              <L 10>
        var_70 = wp::extract(var_0, var_57);
        var_71 = wp::mul(var_61, var_61);
        var_72 = wp::mul(var_65, var_65);
        var_73 = wp::add(var_71, var_72);
        var_74 = wp::mul(var_69, var_69);
        var_75 = wp::add(var_73, var_74);
        var_76 = (var_75 <= var_sqradius);
        if (var_76) {
        }
        if (!var_76) {
        }
        var_79 = wp::where(var_76, var_77, var_78);
        var_80 = wp::bit_or(var_70, var_79);
        wp::assign_inplace(var_0, var_57, var_80);
        // x = p[0] - xs[j]                                                                   <L 7>
        var_83 = wp::extract(var_7, var_82);
        var_84 = wp::extract(var_xs, var_81);
        var_85 = wp::sub(var_83, var_84);
        // y = p[1] - ys[j]                                                                   <L 8>
        var_87 = wp::extract(var_7, var_86);
        var_88 = wp::extract(var_ys, var_81);
        var_89 = wp::sub(var_87, var_88);
        // z = p[2] - zs[j]                                                                   <L 9>
        var_91 = wp::extract(var_7, var_90);
        var_92 = wp::extract(var_zs, var_81);
        var_93 = wp::sub(var_91, var_92);
        // flags[j] = flags[j] | (1 if x * x + y * y + z * z <= sqradius else 0)              <L 10>
        var_94 = wp::extract(var_0, var_81);
        var_95 = wp::mul(var_85, var_85);
        var_96 = wp::mul(var_89, var_89);
        var_97 = wp::add(var_95, var_96);
        var_98 = wp::mul(var_93, var_93);
        var_99 = wp::add(var_97, var_98);
        var_100 = (var_99 <= var_sqradius);
        if (var_100) {
        }
        if (!var_100) {
        }
        var_103 = wp::where(var_100, var_101, var_102);
        var_104 = wp::bit_or(var_94, var_103);
        wp::assign_inplace(var_0, var_81, var_104);
        // x = p[0] - xs[j]                                                                   <L 7>
        var_107 = wp::extract(var_7, var_106);
        var_108 = wp::extract(var_xs, var_105);
        var_109 = wp::sub(var_107, var_108);
        // y = p[1] - ys[j]                                                                   <L 8>
        var_111 = wp::extract(var_7, var_110);
        var_112 = wp::extract(var_ys, var_105);
        var_113 = wp::sub(var_111, var_112);
        // z = p[2] - zs[j]                                                                   <L 9>
        var_115 = wp::extract(var_7, var_114);
        var_116 = wp::extract(var_zs, var_105);
        var_117 = wp::sub(var_115, var_116);
        // flags[j] = flags[j] | (1 if x * x + y * y + z * z <= sqradius else 0)              <L 10>
        var_118 = wp::extract(var_0, var_105);
        var_119 = wp::mul(var_109, var_109);
        var_120 = wp::mul(var_113, var_113);
        var_121 = wp::add(var_119, var_120);
        var_122 = wp::mul(var_117, var_117);
        var_123 = wp::add(var_121, var_122);
        var_124 = (var_123 <= var_sqradius);
        if (var_124) {
        }
        if (!var_124) {
        }
        var_127 = wp::where(var_124, var_125, var_126);
        var_128 = wp::bit_or(var_118, var_127);
        wp::assign_inplace(var_0, var_105, var_128);
        // x = p[0] - xs[j]                                                                   <L 7>
        var_131 = wp::extract(var_7, var_130);
        var_132 = wp::extract(var_xs, var_129);
        var_133 = wp::sub(var_131, var_132);
        // y = p[1] - ys[j]                                                                   <L 8>
        var_135 = wp::extract(var_7, var_134);
        var_136 = wp::extract(var_ys, var_129);
        var_137 = wp::sub(var_135, var_136);
        // z = p[2] - zs[j]                                                                   <L 9>
        var_139 = wp::extract(var_7, var_138);
        var_140 = wp::extract(var_zs, var_129);
        var_141 = wp::sub(var_139, var_140);
        // flags[j] = flags[j] | (1 if x * x + y * y + z * z <= sqradius else 0)              <L 10>
        var_142 = wp::extract(var_0, var_129);
        var_143 = wp::mul(var_133, var_133);
        var_144 = wp::mul(var_137, var_137);
        var_145 = wp::add(var_143, var_144);
        var_146 = wp::mul(var_141, var_141);
        var_147 = wp::add(var_145, var_146);
        var_148 = (var_147 <= var_sqradius);
        if (var_148) {
        }
        if (!var_148) {
        }
        var_151 = wp::where(var_148, var_149, var_150);
        var_152 = wp::bit_or(var_142, var_151);
        wp::assign_inplace(var_0, var_129, var_152);
        // x = p[0] - xs[j]                                                                   <L 7>
        var_155 = wp::extract(var_7, var_154);
        var_156 = wp::extract(var_xs, var_153);
        var_157 = wp::sub(var_155, var_156);
        // y = p[1] - ys[j]                                                                   <L 8>
        var_159 = wp::extract(var_7, var_158);
        var_160 = wp::extract(var_ys, var_153);
        var_161 = wp::sub(var_159, var_160);
        // z = p[2] - zs[j]                                                                   <L 9>
        var_163 = wp::extract(var_7, var_162);
        var_164 = wp::extract(var_zs, var_153);
        var_165 = wp::sub(var_163, var_164);
        // flags[j] = flags[j] | (1 if x * x + y * y + z * z <= sqradius else 0)              <L 10>
        var_166 = wp::extract(var_0, var_153);
        var_167 = wp::mul(var_157, var_157);
        var_168 = wp::mul(var_161, var_161);
        var_169 = wp::add(var_167, var_168);
        var_170 = wp::mul(var_165, var_165);
        var_171 = wp::add(var_169, var_170);
        var_172 = (var_171 <= var_sqradius);
        if (var_172) {
        }
        if (!var_172) {
        }
        var_175 = wp::where(var_172, var_173, var_174);
        var_176 = wp::bit_or(var_166, var_175);
        wp::assign_inplace(var_0, var_153, var_176);
        // x = p[0] - xs[j]                                                                   <L 7>
        var_179 = wp::extract(var_7, var_178);
        var_180 = wp::extract(var_xs, var_177);
        var_181 = wp::sub(var_179, var_180);
        // y = p[1] - ys[j]                                                                   <L 8>
        var_183 = wp::extract(var_7, var_182);
        var_184 = wp::extract(var_ys, var_177);
        var_185 = wp::sub(var_183, var_184);
        // z = p[2] - zs[j]                                                                   <L 9>
        var_187 = wp::extract(var_7, var_186);
        var_188 = wp::extract(var_zs, var_177);
        var_189 = wp::sub(var_187, var_188);
        // flags[j] = flags[j] | (1 if x * x + y * y + z * z <= sqradius else 0)              <L 10>
        var_190 = wp::extract(var_0, var_177);
        var_191 = wp::mul(var_181, var_181);
        var_192 = wp::mul(var_185, var_185);
        var_193 = wp::add(var_191, var_192);
        var_194 = wp::mul(var_189, var_189);
        var_195 = wp::add(var_193, var_194);
        var_196 = (var_195 <= var_sqradius);
        if (var_196) {
        }
        if (!var_196) {
        }
        var_199 = wp::where(var_196, var_197, var_198);
        var_200 = wp::bit_or(var_190, var_199);
        wp::assign_inplace(var_0, var_177, var_200);
        goto start_for_0;
    end_for_0:;
    // return flags                                                                           <L 11>
    return var_0;
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


// <pointloom.kernels.algebra.rigid_solve.jacobi_rotation>:1
static CUDA_CALLABLE wp::vec_t<2, wp::float64> jacobi_rotation_0(
    wp::float64 var_app,
    wp::float64 var_aqq,
    wp::float64 var_apq)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::float64 var_1;
    wp::float64 var_2;
    wp::float64 var_3;
    wp::float64 var_4;
    wp::float64 var_5;
    wp::float64 var_6;
    wp::float64 var_7;
    wp::float64 var_8;
    wp::float64 var_9;
    wp::float64 var_10;
    wp::float64 var_11;
    wp::float64 var_12;
    bool var_13;
    wp::float64 var_14;
    wp::float64 var_15;
    wp::float64 var_16;
    wp::float64 var_17;
    wp::float64 var_18;
    wp::float64 var_19;
    wp::float64 var_20;
    wp::float64 var_21;
    wp::float64 var_22;
    wp::vec_t<2, wp::float64> var_23;
    //---------
    // forward
    // def jacobi_rotation(app, aqq, apq):                                                    <L 1>
    // theta = (aqq - app) / (float64(2.0) * apq)                                             <L 3>
    var_0 = wp::sub(var_aqq, var_app);
    var_1 = 2.0;
    var_2 = wp::mul(var_1, var_apq);
    var_3 = wp::div(var_0, var_2);
    // t = float64(1.0) / (abs(theta) + sqrt(theta * theta + float64(1.0)))                   <L 4>
    var_4 = 1.0;
    var_5 = wp::abs(var_3);
    var_6 = wp::mul(var_3, var_3);
    var_7 = 1.0;
    var_8 = wp::add(var_6, var_7);
    var_9 = wp::sqrt(var_8);
    var_10 = wp::add(var_5, var_9);
    var_11 = wp::div(var_4, var_10);
    // if theta < float64(0.0):                                                               <L 5>
    var_12 = 0.0;
    var_13 = (var_3 < var_12);
    if (var_13) {
        // t = -t                                                                             <L 6>
        var_14 = wp::neg(var_11);
    }
    var_15 = wp::where(var_13, var_14, var_11);
    // c = float64(1.0) / sqrt(t * t + float64(1.0))                                          <L 7>
    var_16 = 1.0;
    var_17 = wp::mul(var_15, var_15);
    var_18 = 1.0;
    var_19 = wp::add(var_17, var_18);
    var_20 = wp::sqrt(var_19);
    var_21 = wp::div(var_16, var_20);
    // return vec2d(c, t * c)                                                                 <L 8>
    var_22 = wp::mul(var_15, var_21);
    var_23 = wp::vec_t<2, wp::float64>(var_21, var_22);
    return var_23;
}


// <pointloom.kernels.algebra.rigid_solve.diagonalize_four>:1
static CUDA_CALLABLE wp::vec_t<20, wp::float64> diagonalize_four_0(
    wp::vec_t<16, wp::float64> var_matrix)
{
    //---------
    // primal vars
    wp::vec_t<16, wp::float64> var_0;
    wp::float64 var_1;
    wp::vec_t<16, wp::float64> var_2;
    const wp::int32 var_3 = 0;
    wp::float64 var_4;
    const wp::int32 var_5 = 5;
    wp::int32 var_6;
    const wp::int32 var_7 = 1;
    wp::float64 var_8;
    const wp::int32 var_9 = 5;
    wp::int32 var_10;
    const wp::int32 var_11 = 2;
    wp::float64 var_12;
    const wp::int32 var_13 = 5;
    wp::int32 var_14;
    const wp::int32 var_15 = 3;
    wp::float64 var_16;
    const wp::int32 var_17 = 5;
    wp::int32 var_18;
    const wp::int32 var_19 = 1;
    wp::int32 var_20;
    const wp::int32 var_21 = 0;
    wp::int32 var_22;
    bool var_23;
    const wp::int32 var_24 = 1;
    bool var_25;
    const wp::int32 var_26 = 10;
    bool var_27;
    const wp::int32 var_28 = 0;
    wp::int32 var_29;
    const wp::int32 var_30 = 1;
    wp::int32 var_31;
    const wp::int32 var_32 = 0;
    const wp::int32 var_33 = 3;
    bool var_34;
    const wp::int32 var_35 = 0;
    const wp::int32 var_36 = 5;
    bool var_37;
    const wp::int32 var_38 = 1;
    const wp::int32 var_39 = 2;
    wp::int32 var_40;
    wp::int32 var_41;
    const wp::int32 var_42 = 1;
    wp::int32 var_43;
    const wp::int32 var_44 = 3;
    bool var_45;
    const wp::int32 var_46 = 0;
    const wp::int32 var_47 = 5;
    bool var_48;
    const wp::int32 var_49 = 2;
    const wp::int32 var_50 = 3;
    wp::int32 var_51;
    wp::int32 var_52;
    wp::int32 var_53;
    const wp::int32 var_54 = 4;
    wp::int32 var_55;
    wp::int32 var_56;
    wp::float64 var_57;
    const wp::int32 var_58 = 4;
    wp::int32 var_59;
    wp::int32 var_60;
    wp::float64 var_61;
    const wp::int32 var_62 = 4;
    wp::int32 var_63;
    wp::int32 var_64;
    wp::float64 var_65;
    bool var_66;
    wp::float64 var_67;
    wp::float64 var_68;
    bool var_69;
    wp::float64 var_70;
    wp::float64 var_71;
    wp::float64 var_72;
    wp::float64 var_73;
    wp::float64 var_74;
    wp::float64 var_75;
    bool var_76;
    const wp::int32 var_77 = 1;
    wp::vec_t<2, wp::float64> var_78;
    const wp::int32 var_79 = 0;
    const wp::int32 var_80 = 4;
    wp::int32 var_81;
    wp::int32 var_82;
    wp::float64 var_83;
    const wp::int32 var_84 = 4;
    wp::int32 var_85;
    wp::int32 var_86;
    wp::float64 var_87;
    const wp::int32 var_88 = 0;
    wp::float64 var_89;
    wp::float64 var_90;
    const wp::int32 var_91 = 1;
    wp::float64 var_92;
    wp::float64 var_93;
    wp::float64 var_94;
    const wp::int32 var_95 = 4;
    wp::int32 var_96;
    wp::int32 var_97;
    const wp::int32 var_98 = 1;
    wp::float64 var_99;
    wp::float64 var_100;
    const wp::int32 var_101 = 0;
    wp::float64 var_102;
    wp::float64 var_103;
    wp::float64 var_104;
    const wp::int32 var_105 = 4;
    wp::int32 var_106;
    wp::int32 var_107;
    const wp::int32 var_108 = 1;
    const wp::int32 var_109 = 4;
    wp::int32 var_110;
    wp::int32 var_111;
    wp::float64 var_112;
    const wp::int32 var_113 = 4;
    wp::int32 var_114;
    wp::int32 var_115;
    wp::float64 var_116;
    const wp::int32 var_117 = 0;
    wp::float64 var_118;
    wp::float64 var_119;
    const wp::int32 var_120 = 1;
    wp::float64 var_121;
    wp::float64 var_122;
    wp::float64 var_123;
    const wp::int32 var_124 = 4;
    wp::int32 var_125;
    wp::int32 var_126;
    const wp::int32 var_127 = 1;
    wp::float64 var_128;
    wp::float64 var_129;
    const wp::int32 var_130 = 0;
    wp::float64 var_131;
    wp::float64 var_132;
    wp::float64 var_133;
    const wp::int32 var_134 = 4;
    wp::int32 var_135;
    wp::int32 var_136;
    const wp::int32 var_137 = 2;
    const wp::int32 var_138 = 4;
    wp::int32 var_139;
    wp::int32 var_140;
    wp::float64 var_141;
    const wp::int32 var_142 = 4;
    wp::int32 var_143;
    wp::int32 var_144;
    wp::float64 var_145;
    const wp::int32 var_146 = 0;
    wp::float64 var_147;
    wp::float64 var_148;
    const wp::int32 var_149 = 1;
    wp::float64 var_150;
    wp::float64 var_151;
    wp::float64 var_152;
    const wp::int32 var_153 = 4;
    wp::int32 var_154;
    wp::int32 var_155;
    const wp::int32 var_156 = 1;
    wp::float64 var_157;
    wp::float64 var_158;
    const wp::int32 var_159 = 0;
    wp::float64 var_160;
    wp::float64 var_161;
    wp::float64 var_162;
    const wp::int32 var_163 = 4;
    wp::int32 var_164;
    wp::int32 var_165;
    const wp::int32 var_166 = 3;
    const wp::int32 var_167 = 4;
    wp::int32 var_168;
    wp::int32 var_169;
    wp::float64 var_170;
    const wp::int32 var_171 = 4;
    wp::int32 var_172;
    wp::int32 var_173;
    wp::float64 var_174;
    const wp::int32 var_175 = 0;
    wp::float64 var_176;
    wp::float64 var_177;
    const wp::int32 var_178 = 1;
    wp::float64 var_179;
    wp::float64 var_180;
    wp::float64 var_181;
    const wp::int32 var_182 = 4;
    wp::int32 var_183;
    wp::int32 var_184;
    const wp::int32 var_185 = 1;
    wp::float64 var_186;
    wp::float64 var_187;
    const wp::int32 var_188 = 0;
    wp::float64 var_189;
    wp::float64 var_190;
    wp::float64 var_191;
    const wp::int32 var_192 = 4;
    wp::int32 var_193;
    wp::int32 var_194;
    const wp::int32 var_195 = 0;
    const wp::int32 var_196 = 4;
    wp::int32 var_197;
    wp::int32 var_198;
    wp::float64 var_199;
    const wp::int32 var_200 = 4;
    wp::int32 var_201;
    wp::int32 var_202;
    wp::float64 var_203;
    const wp::int32 var_204 = 0;
    wp::float64 var_205;
    wp::float64 var_206;
    const wp::int32 var_207 = 1;
    wp::float64 var_208;
    wp::float64 var_209;
    wp::float64 var_210;
    const wp::int32 var_211 = 4;
    wp::int32 var_212;
    wp::int32 var_213;
    const wp::int32 var_214 = 1;
    wp::float64 var_215;
    wp::float64 var_216;
    const wp::int32 var_217 = 0;
    wp::float64 var_218;
    wp::float64 var_219;
    wp::float64 var_220;
    const wp::int32 var_221 = 4;
    wp::int32 var_222;
    wp::int32 var_223;
    const wp::int32 var_224 = 1;
    const wp::int32 var_225 = 4;
    wp::int32 var_226;
    wp::int32 var_227;
    wp::float64 var_228;
    const wp::int32 var_229 = 4;
    wp::int32 var_230;
    wp::int32 var_231;
    wp::float64 var_232;
    const wp::int32 var_233 = 0;
    wp::float64 var_234;
    wp::float64 var_235;
    const wp::int32 var_236 = 1;
    wp::float64 var_237;
    wp::float64 var_238;
    wp::float64 var_239;
    const wp::int32 var_240 = 4;
    wp::int32 var_241;
    wp::int32 var_242;
    const wp::int32 var_243 = 1;
    wp::float64 var_244;
    wp::float64 var_245;
    const wp::int32 var_246 = 0;
    wp::float64 var_247;
    wp::float64 var_248;
    wp::float64 var_249;
    const wp::int32 var_250 = 4;
    wp::int32 var_251;
    wp::int32 var_252;
    const wp::int32 var_253 = 2;
    const wp::int32 var_254 = 4;
    wp::int32 var_255;
    wp::int32 var_256;
    wp::float64 var_257;
    const wp::int32 var_258 = 4;
    wp::int32 var_259;
    wp::int32 var_260;
    wp::float64 var_261;
    const wp::int32 var_262 = 0;
    wp::float64 var_263;
    wp::float64 var_264;
    const wp::int32 var_265 = 1;
    wp::float64 var_266;
    wp::float64 var_267;
    wp::float64 var_268;
    const wp::int32 var_269 = 4;
    wp::int32 var_270;
    wp::int32 var_271;
    const wp::int32 var_272 = 1;
    wp::float64 var_273;
    wp::float64 var_274;
    const wp::int32 var_275 = 0;
    wp::float64 var_276;
    wp::float64 var_277;
    wp::float64 var_278;
    const wp::int32 var_279 = 4;
    wp::int32 var_280;
    wp::int32 var_281;
    const wp::int32 var_282 = 3;
    const wp::int32 var_283 = 4;
    wp::int32 var_284;
    wp::int32 var_285;
    wp::float64 var_286;
    const wp::int32 var_287 = 4;
    wp::int32 var_288;
    wp::int32 var_289;
    wp::float64 var_290;
    const wp::int32 var_291 = 0;
    wp::float64 var_292;
    wp::float64 var_293;
    const wp::int32 var_294 = 1;
    wp::float64 var_295;
    wp::float64 var_296;
    wp::float64 var_297;
    const wp::int32 var_298 = 4;
    wp::int32 var_299;
    wp::int32 var_300;
    const wp::int32 var_301 = 1;
    wp::float64 var_302;
    wp::float64 var_303;
    const wp::int32 var_304 = 0;
    wp::float64 var_305;
    wp::float64 var_306;
    wp::float64 var_307;
    const wp::int32 var_308 = 4;
    wp::int32 var_309;
    wp::int32 var_310;
    const wp::int32 var_311 = 0;
    const wp::int32 var_312 = 4;
    wp::int32 var_313;
    wp::int32 var_314;
    wp::float64 var_315;
    const wp::int32 var_316 = 4;
    wp::int32 var_317;
    wp::int32 var_318;
    wp::float64 var_319;
    const wp::int32 var_320 = 0;
    wp::float64 var_321;
    wp::float64 var_322;
    const wp::int32 var_323 = 1;
    wp::float64 var_324;
    wp::float64 var_325;
    wp::float64 var_326;
    const wp::int32 var_327 = 4;
    wp::int32 var_328;
    wp::int32 var_329;
    const wp::int32 var_330 = 1;
    wp::float64 var_331;
    wp::float64 var_332;
    const wp::int32 var_333 = 0;
    wp::float64 var_334;
    wp::float64 var_335;
    wp::float64 var_336;
    const wp::int32 var_337 = 4;
    wp::int32 var_338;
    wp::int32 var_339;
    const wp::int32 var_340 = 1;
    const wp::int32 var_341 = 4;
    wp::int32 var_342;
    wp::int32 var_343;
    wp::float64 var_344;
    const wp::int32 var_345 = 4;
    wp::int32 var_346;
    wp::int32 var_347;
    wp::float64 var_348;
    const wp::int32 var_349 = 0;
    wp::float64 var_350;
    wp::float64 var_351;
    const wp::int32 var_352 = 1;
    wp::float64 var_353;
    wp::float64 var_354;
    wp::float64 var_355;
    const wp::int32 var_356 = 4;
    wp::int32 var_357;
    wp::int32 var_358;
    const wp::int32 var_359 = 1;
    wp::float64 var_360;
    wp::float64 var_361;
    const wp::int32 var_362 = 0;
    wp::float64 var_363;
    wp::float64 var_364;
    wp::float64 var_365;
    const wp::int32 var_366 = 4;
    wp::int32 var_367;
    wp::int32 var_368;
    const wp::int32 var_369 = 2;
    const wp::int32 var_370 = 4;
    wp::int32 var_371;
    wp::int32 var_372;
    wp::float64 var_373;
    const wp::int32 var_374 = 4;
    wp::int32 var_375;
    wp::int32 var_376;
    wp::float64 var_377;
    const wp::int32 var_378 = 0;
    wp::float64 var_379;
    wp::float64 var_380;
    const wp::int32 var_381 = 1;
    wp::float64 var_382;
    wp::float64 var_383;
    wp::float64 var_384;
    const wp::int32 var_385 = 4;
    wp::int32 var_386;
    wp::int32 var_387;
    const wp::int32 var_388 = 1;
    wp::float64 var_389;
    wp::float64 var_390;
    const wp::int32 var_391 = 0;
    wp::float64 var_392;
    wp::float64 var_393;
    wp::float64 var_394;
    const wp::int32 var_395 = 4;
    wp::int32 var_396;
    wp::int32 var_397;
    const wp::int32 var_398 = 3;
    const wp::int32 var_399 = 4;
    wp::int32 var_400;
    wp::int32 var_401;
    wp::float64 var_402;
    const wp::int32 var_403 = 4;
    wp::int32 var_404;
    wp::int32 var_405;
    wp::float64 var_406;
    const wp::int32 var_407 = 0;
    wp::float64 var_408;
    wp::float64 var_409;
    const wp::int32 var_410 = 1;
    wp::float64 var_411;
    wp::float64 var_412;
    wp::float64 var_413;
    const wp::int32 var_414 = 4;
    wp::int32 var_415;
    wp::int32 var_416;
    const wp::int32 var_417 = 1;
    wp::float64 var_418;
    wp::float64 var_419;
    const wp::int32 var_420 = 0;
    wp::float64 var_421;
    wp::float64 var_422;
    wp::float64 var_423;
    const wp::int32 var_424 = 4;
    wp::int32 var_425;
    wp::int32 var_426;
    wp::int32 var_427;
    const wp::int32 var_428 = 1;
    const wp::int32 var_429 = 3;
    bool var_430;
    const wp::int32 var_431 = 0;
    const wp::int32 var_432 = 5;
    bool var_433;
    const wp::int32 var_434 = 1;
    const wp::int32 var_435 = 2;
    wp::int32 var_436;
    wp::int32 var_437;
    const wp::int32 var_438 = 1;
    wp::int32 var_439;
    const wp::int32 var_440 = 3;
    bool var_441;
    const wp::int32 var_442 = 0;
    const wp::int32 var_443 = 5;
    bool var_444;
    const wp::int32 var_445 = 2;
    const wp::int32 var_446 = 3;
    wp::int32 var_447;
    wp::int32 var_448;
    wp::int32 var_449;
    const wp::int32 var_450 = 4;
    wp::int32 var_451;
    wp::int32 var_452;
    wp::float64 var_453;
    const wp::int32 var_454 = 4;
    wp::int32 var_455;
    wp::int32 var_456;
    wp::float64 var_457;
    const wp::int32 var_458 = 4;
    wp::int32 var_459;
    wp::int32 var_460;
    wp::float64 var_461;
    bool var_462;
    wp::float64 var_463;
    wp::float64 var_464;
    bool var_465;
    wp::float64 var_466;
    wp::float64 var_467;
    wp::float64 var_468;
    wp::float64 var_469;
    wp::float64 var_470;
    wp::float64 var_471;
    bool var_472;
    const wp::int32 var_473 = 1;
    wp::vec_t<2, wp::float64> var_474;
    const wp::int32 var_475 = 0;
    const wp::int32 var_476 = 4;
    wp::int32 var_477;
    wp::int32 var_478;
    wp::float64 var_479;
    const wp::int32 var_480 = 4;
    wp::int32 var_481;
    wp::int32 var_482;
    wp::float64 var_483;
    const wp::int32 var_484 = 0;
    wp::float64 var_485;
    wp::float64 var_486;
    const wp::int32 var_487 = 1;
    wp::float64 var_488;
    wp::float64 var_489;
    wp::float64 var_490;
    const wp::int32 var_491 = 4;
    wp::int32 var_492;
    wp::int32 var_493;
    const wp::int32 var_494 = 1;
    wp::float64 var_495;
    wp::float64 var_496;
    const wp::int32 var_497 = 0;
    wp::float64 var_498;
    wp::float64 var_499;
    wp::float64 var_500;
    const wp::int32 var_501 = 4;
    wp::int32 var_502;
    wp::int32 var_503;
    const wp::int32 var_504 = 1;
    const wp::int32 var_505 = 4;
    wp::int32 var_506;
    wp::int32 var_507;
    wp::float64 var_508;
    const wp::int32 var_509 = 4;
    wp::int32 var_510;
    wp::int32 var_511;
    wp::float64 var_512;
    const wp::int32 var_513 = 0;
    wp::float64 var_514;
    wp::float64 var_515;
    const wp::int32 var_516 = 1;
    wp::float64 var_517;
    wp::float64 var_518;
    wp::float64 var_519;
    const wp::int32 var_520 = 4;
    wp::int32 var_521;
    wp::int32 var_522;
    const wp::int32 var_523 = 1;
    wp::float64 var_524;
    wp::float64 var_525;
    const wp::int32 var_526 = 0;
    wp::float64 var_527;
    wp::float64 var_528;
    wp::float64 var_529;
    const wp::int32 var_530 = 4;
    wp::int32 var_531;
    wp::int32 var_532;
    const wp::int32 var_533 = 2;
    const wp::int32 var_534 = 4;
    wp::int32 var_535;
    wp::int32 var_536;
    wp::float64 var_537;
    const wp::int32 var_538 = 4;
    wp::int32 var_539;
    wp::int32 var_540;
    wp::float64 var_541;
    const wp::int32 var_542 = 0;
    wp::float64 var_543;
    wp::float64 var_544;
    const wp::int32 var_545 = 1;
    wp::float64 var_546;
    wp::float64 var_547;
    wp::float64 var_548;
    const wp::int32 var_549 = 4;
    wp::int32 var_550;
    wp::int32 var_551;
    const wp::int32 var_552 = 1;
    wp::float64 var_553;
    wp::float64 var_554;
    const wp::int32 var_555 = 0;
    wp::float64 var_556;
    wp::float64 var_557;
    wp::float64 var_558;
    const wp::int32 var_559 = 4;
    wp::int32 var_560;
    wp::int32 var_561;
    const wp::int32 var_562 = 3;
    const wp::int32 var_563 = 4;
    wp::int32 var_564;
    wp::int32 var_565;
    wp::float64 var_566;
    const wp::int32 var_567 = 4;
    wp::int32 var_568;
    wp::int32 var_569;
    wp::float64 var_570;
    const wp::int32 var_571 = 0;
    wp::float64 var_572;
    wp::float64 var_573;
    const wp::int32 var_574 = 1;
    wp::float64 var_575;
    wp::float64 var_576;
    wp::float64 var_577;
    const wp::int32 var_578 = 4;
    wp::int32 var_579;
    wp::int32 var_580;
    const wp::int32 var_581 = 1;
    wp::float64 var_582;
    wp::float64 var_583;
    const wp::int32 var_584 = 0;
    wp::float64 var_585;
    wp::float64 var_586;
    wp::float64 var_587;
    const wp::int32 var_588 = 4;
    wp::int32 var_589;
    wp::int32 var_590;
    const wp::int32 var_591 = 0;
    const wp::int32 var_592 = 4;
    wp::int32 var_593;
    wp::int32 var_594;
    wp::float64 var_595;
    const wp::int32 var_596 = 4;
    wp::int32 var_597;
    wp::int32 var_598;
    wp::float64 var_599;
    const wp::int32 var_600 = 0;
    wp::float64 var_601;
    wp::float64 var_602;
    const wp::int32 var_603 = 1;
    wp::float64 var_604;
    wp::float64 var_605;
    wp::float64 var_606;
    const wp::int32 var_607 = 4;
    wp::int32 var_608;
    wp::int32 var_609;
    const wp::int32 var_610 = 1;
    wp::float64 var_611;
    wp::float64 var_612;
    const wp::int32 var_613 = 0;
    wp::float64 var_614;
    wp::float64 var_615;
    wp::float64 var_616;
    const wp::int32 var_617 = 4;
    wp::int32 var_618;
    wp::int32 var_619;
    const wp::int32 var_620 = 1;
    const wp::int32 var_621 = 4;
    wp::int32 var_622;
    wp::int32 var_623;
    wp::float64 var_624;
    const wp::int32 var_625 = 4;
    wp::int32 var_626;
    wp::int32 var_627;
    wp::float64 var_628;
    const wp::int32 var_629 = 0;
    wp::float64 var_630;
    wp::float64 var_631;
    const wp::int32 var_632 = 1;
    wp::float64 var_633;
    wp::float64 var_634;
    wp::float64 var_635;
    const wp::int32 var_636 = 4;
    wp::int32 var_637;
    wp::int32 var_638;
    const wp::int32 var_639 = 1;
    wp::float64 var_640;
    wp::float64 var_641;
    const wp::int32 var_642 = 0;
    wp::float64 var_643;
    wp::float64 var_644;
    wp::float64 var_645;
    const wp::int32 var_646 = 4;
    wp::int32 var_647;
    wp::int32 var_648;
    const wp::int32 var_649 = 2;
    const wp::int32 var_650 = 4;
    wp::int32 var_651;
    wp::int32 var_652;
    wp::float64 var_653;
    const wp::int32 var_654 = 4;
    wp::int32 var_655;
    wp::int32 var_656;
    wp::float64 var_657;
    const wp::int32 var_658 = 0;
    wp::float64 var_659;
    wp::float64 var_660;
    const wp::int32 var_661 = 1;
    wp::float64 var_662;
    wp::float64 var_663;
    wp::float64 var_664;
    const wp::int32 var_665 = 4;
    wp::int32 var_666;
    wp::int32 var_667;
    const wp::int32 var_668 = 1;
    wp::float64 var_669;
    wp::float64 var_670;
    const wp::int32 var_671 = 0;
    wp::float64 var_672;
    wp::float64 var_673;
    wp::float64 var_674;
    const wp::int32 var_675 = 4;
    wp::int32 var_676;
    wp::int32 var_677;
    const wp::int32 var_678 = 3;
    const wp::int32 var_679 = 4;
    wp::int32 var_680;
    wp::int32 var_681;
    wp::float64 var_682;
    const wp::int32 var_683 = 4;
    wp::int32 var_684;
    wp::int32 var_685;
    wp::float64 var_686;
    const wp::int32 var_687 = 0;
    wp::float64 var_688;
    wp::float64 var_689;
    const wp::int32 var_690 = 1;
    wp::float64 var_691;
    wp::float64 var_692;
    wp::float64 var_693;
    const wp::int32 var_694 = 4;
    wp::int32 var_695;
    wp::int32 var_696;
    const wp::int32 var_697 = 1;
    wp::float64 var_698;
    wp::float64 var_699;
    const wp::int32 var_700 = 0;
    wp::float64 var_701;
    wp::float64 var_702;
    wp::float64 var_703;
    const wp::int32 var_704 = 4;
    wp::int32 var_705;
    wp::int32 var_706;
    const wp::int32 var_707 = 0;
    const wp::int32 var_708 = 4;
    wp::int32 var_709;
    wp::int32 var_710;
    wp::float64 var_711;
    const wp::int32 var_712 = 4;
    wp::int32 var_713;
    wp::int32 var_714;
    wp::float64 var_715;
    const wp::int32 var_716 = 0;
    wp::float64 var_717;
    wp::float64 var_718;
    const wp::int32 var_719 = 1;
    wp::float64 var_720;
    wp::float64 var_721;
    wp::float64 var_722;
    const wp::int32 var_723 = 4;
    wp::int32 var_724;
    wp::int32 var_725;
    const wp::int32 var_726 = 1;
    wp::float64 var_727;
    wp::float64 var_728;
    const wp::int32 var_729 = 0;
    wp::float64 var_730;
    wp::float64 var_731;
    wp::float64 var_732;
    const wp::int32 var_733 = 4;
    wp::int32 var_734;
    wp::int32 var_735;
    const wp::int32 var_736 = 1;
    const wp::int32 var_737 = 4;
    wp::int32 var_738;
    wp::int32 var_739;
    wp::float64 var_740;
    const wp::int32 var_741 = 4;
    wp::int32 var_742;
    wp::int32 var_743;
    wp::float64 var_744;
    const wp::int32 var_745 = 0;
    wp::float64 var_746;
    wp::float64 var_747;
    const wp::int32 var_748 = 1;
    wp::float64 var_749;
    wp::float64 var_750;
    wp::float64 var_751;
    const wp::int32 var_752 = 4;
    wp::int32 var_753;
    wp::int32 var_754;
    const wp::int32 var_755 = 1;
    wp::float64 var_756;
    wp::float64 var_757;
    const wp::int32 var_758 = 0;
    wp::float64 var_759;
    wp::float64 var_760;
    wp::float64 var_761;
    const wp::int32 var_762 = 4;
    wp::int32 var_763;
    wp::int32 var_764;
    const wp::int32 var_765 = 2;
    const wp::int32 var_766 = 4;
    wp::int32 var_767;
    wp::int32 var_768;
    wp::float64 var_769;
    const wp::int32 var_770 = 4;
    wp::int32 var_771;
    wp::int32 var_772;
    wp::float64 var_773;
    const wp::int32 var_774 = 0;
    wp::float64 var_775;
    wp::float64 var_776;
    const wp::int32 var_777 = 1;
    wp::float64 var_778;
    wp::float64 var_779;
    wp::float64 var_780;
    const wp::int32 var_781 = 4;
    wp::int32 var_782;
    wp::int32 var_783;
    const wp::int32 var_784 = 1;
    wp::float64 var_785;
    wp::float64 var_786;
    const wp::int32 var_787 = 0;
    wp::float64 var_788;
    wp::float64 var_789;
    wp::float64 var_790;
    const wp::int32 var_791 = 4;
    wp::int32 var_792;
    wp::int32 var_793;
    const wp::int32 var_794 = 3;
    const wp::int32 var_795 = 4;
    wp::int32 var_796;
    wp::int32 var_797;
    wp::float64 var_798;
    const wp::int32 var_799 = 4;
    wp::int32 var_800;
    wp::int32 var_801;
    wp::float64 var_802;
    const wp::int32 var_803 = 0;
    wp::float64 var_804;
    wp::float64 var_805;
    const wp::int32 var_806 = 1;
    wp::float64 var_807;
    wp::float64 var_808;
    wp::float64 var_809;
    const wp::int32 var_810 = 4;
    wp::int32 var_811;
    wp::int32 var_812;
    const wp::int32 var_813 = 1;
    wp::float64 var_814;
    wp::float64 var_815;
    const wp::int32 var_816 = 0;
    wp::float64 var_817;
    wp::float64 var_818;
    wp::float64 var_819;
    const wp::int32 var_820 = 4;
    wp::int32 var_821;
    wp::int32 var_822;
    wp::int32 var_823;
    wp::vec_t<2, wp::float64> var_824;
    wp::int32 var_825;
    wp::float64 var_826;
    wp::float64 var_827;
    wp::float64 var_828;
    wp::float64 var_829;
    wp::float64 var_830;
    wp::float64 var_831;
    const wp::int32 var_832 = 2;
    const wp::int32 var_833 = 3;
    bool var_834;
    const wp::int32 var_835 = 0;
    const wp::int32 var_836 = 5;
    bool var_837;
    const wp::int32 var_838 = 1;
    const wp::int32 var_839 = 2;
    wp::int32 var_840;
    wp::int32 var_841;
    const wp::int32 var_842 = 1;
    wp::int32 var_843;
    const wp::int32 var_844 = 3;
    bool var_845;
    const wp::int32 var_846 = 0;
    const wp::int32 var_847 = 5;
    bool var_848;
    const wp::int32 var_849 = 2;
    const wp::int32 var_850 = 3;
    wp::int32 var_851;
    wp::int32 var_852;
    wp::int32 var_853;
    const wp::int32 var_854 = 4;
    wp::int32 var_855;
    wp::int32 var_856;
    wp::float64 var_857;
    const wp::int32 var_858 = 4;
    wp::int32 var_859;
    wp::int32 var_860;
    wp::float64 var_861;
    const wp::int32 var_862 = 4;
    wp::int32 var_863;
    wp::int32 var_864;
    wp::float64 var_865;
    bool var_866;
    wp::float64 var_867;
    wp::float64 var_868;
    bool var_869;
    wp::float64 var_870;
    wp::float64 var_871;
    wp::float64 var_872;
    wp::float64 var_873;
    wp::float64 var_874;
    wp::float64 var_875;
    bool var_876;
    const wp::int32 var_877 = 1;
    wp::vec_t<2, wp::float64> var_878;
    const wp::int32 var_879 = 0;
    const wp::int32 var_880 = 4;
    wp::int32 var_881;
    wp::int32 var_882;
    wp::float64 var_883;
    const wp::int32 var_884 = 4;
    wp::int32 var_885;
    wp::int32 var_886;
    wp::float64 var_887;
    const wp::int32 var_888 = 0;
    wp::float64 var_889;
    wp::float64 var_890;
    const wp::int32 var_891 = 1;
    wp::float64 var_892;
    wp::float64 var_893;
    wp::float64 var_894;
    const wp::int32 var_895 = 4;
    wp::int32 var_896;
    wp::int32 var_897;
    const wp::int32 var_898 = 1;
    wp::float64 var_899;
    wp::float64 var_900;
    const wp::int32 var_901 = 0;
    wp::float64 var_902;
    wp::float64 var_903;
    wp::float64 var_904;
    const wp::int32 var_905 = 4;
    wp::int32 var_906;
    wp::int32 var_907;
    const wp::int32 var_908 = 1;
    const wp::int32 var_909 = 4;
    wp::int32 var_910;
    wp::int32 var_911;
    wp::float64 var_912;
    const wp::int32 var_913 = 4;
    wp::int32 var_914;
    wp::int32 var_915;
    wp::float64 var_916;
    const wp::int32 var_917 = 0;
    wp::float64 var_918;
    wp::float64 var_919;
    const wp::int32 var_920 = 1;
    wp::float64 var_921;
    wp::float64 var_922;
    wp::float64 var_923;
    const wp::int32 var_924 = 4;
    wp::int32 var_925;
    wp::int32 var_926;
    const wp::int32 var_927 = 1;
    wp::float64 var_928;
    wp::float64 var_929;
    const wp::int32 var_930 = 0;
    wp::float64 var_931;
    wp::float64 var_932;
    wp::float64 var_933;
    const wp::int32 var_934 = 4;
    wp::int32 var_935;
    wp::int32 var_936;
    const wp::int32 var_937 = 2;
    const wp::int32 var_938 = 4;
    wp::int32 var_939;
    wp::int32 var_940;
    wp::float64 var_941;
    const wp::int32 var_942 = 4;
    wp::int32 var_943;
    wp::int32 var_944;
    wp::float64 var_945;
    const wp::int32 var_946 = 0;
    wp::float64 var_947;
    wp::float64 var_948;
    const wp::int32 var_949 = 1;
    wp::float64 var_950;
    wp::float64 var_951;
    wp::float64 var_952;
    const wp::int32 var_953 = 4;
    wp::int32 var_954;
    wp::int32 var_955;
    const wp::int32 var_956 = 1;
    wp::float64 var_957;
    wp::float64 var_958;
    const wp::int32 var_959 = 0;
    wp::float64 var_960;
    wp::float64 var_961;
    wp::float64 var_962;
    const wp::int32 var_963 = 4;
    wp::int32 var_964;
    wp::int32 var_965;
    const wp::int32 var_966 = 3;
    const wp::int32 var_967 = 4;
    wp::int32 var_968;
    wp::int32 var_969;
    wp::float64 var_970;
    const wp::int32 var_971 = 4;
    wp::int32 var_972;
    wp::int32 var_973;
    wp::float64 var_974;
    const wp::int32 var_975 = 0;
    wp::float64 var_976;
    wp::float64 var_977;
    const wp::int32 var_978 = 1;
    wp::float64 var_979;
    wp::float64 var_980;
    wp::float64 var_981;
    const wp::int32 var_982 = 4;
    wp::int32 var_983;
    wp::int32 var_984;
    const wp::int32 var_985 = 1;
    wp::float64 var_986;
    wp::float64 var_987;
    const wp::int32 var_988 = 0;
    wp::float64 var_989;
    wp::float64 var_990;
    wp::float64 var_991;
    const wp::int32 var_992 = 4;
    wp::int32 var_993;
    wp::int32 var_994;
    const wp::int32 var_995 = 0;
    const wp::int32 var_996 = 4;
    wp::int32 var_997;
    wp::int32 var_998;
    wp::float64 var_999;
    const wp::int32 var_1000 = 4;
    wp::int32 var_1001;
    wp::int32 var_1002;
    wp::float64 var_1003;
    const wp::int32 var_1004 = 0;
    wp::float64 var_1005;
    wp::float64 var_1006;
    const wp::int32 var_1007 = 1;
    wp::float64 var_1008;
    wp::float64 var_1009;
    wp::float64 var_1010;
    const wp::int32 var_1011 = 4;
    wp::int32 var_1012;
    wp::int32 var_1013;
    const wp::int32 var_1014 = 1;
    wp::float64 var_1015;
    wp::float64 var_1016;
    const wp::int32 var_1017 = 0;
    wp::float64 var_1018;
    wp::float64 var_1019;
    wp::float64 var_1020;
    const wp::int32 var_1021 = 4;
    wp::int32 var_1022;
    wp::int32 var_1023;
    const wp::int32 var_1024 = 1;
    const wp::int32 var_1025 = 4;
    wp::int32 var_1026;
    wp::int32 var_1027;
    wp::float64 var_1028;
    const wp::int32 var_1029 = 4;
    wp::int32 var_1030;
    wp::int32 var_1031;
    wp::float64 var_1032;
    const wp::int32 var_1033 = 0;
    wp::float64 var_1034;
    wp::float64 var_1035;
    const wp::int32 var_1036 = 1;
    wp::float64 var_1037;
    wp::float64 var_1038;
    wp::float64 var_1039;
    const wp::int32 var_1040 = 4;
    wp::int32 var_1041;
    wp::int32 var_1042;
    const wp::int32 var_1043 = 1;
    wp::float64 var_1044;
    wp::float64 var_1045;
    const wp::int32 var_1046 = 0;
    wp::float64 var_1047;
    wp::float64 var_1048;
    wp::float64 var_1049;
    const wp::int32 var_1050 = 4;
    wp::int32 var_1051;
    wp::int32 var_1052;
    const wp::int32 var_1053 = 2;
    const wp::int32 var_1054 = 4;
    wp::int32 var_1055;
    wp::int32 var_1056;
    wp::float64 var_1057;
    const wp::int32 var_1058 = 4;
    wp::int32 var_1059;
    wp::int32 var_1060;
    wp::float64 var_1061;
    const wp::int32 var_1062 = 0;
    wp::float64 var_1063;
    wp::float64 var_1064;
    const wp::int32 var_1065 = 1;
    wp::float64 var_1066;
    wp::float64 var_1067;
    wp::float64 var_1068;
    const wp::int32 var_1069 = 4;
    wp::int32 var_1070;
    wp::int32 var_1071;
    const wp::int32 var_1072 = 1;
    wp::float64 var_1073;
    wp::float64 var_1074;
    const wp::int32 var_1075 = 0;
    wp::float64 var_1076;
    wp::float64 var_1077;
    wp::float64 var_1078;
    const wp::int32 var_1079 = 4;
    wp::int32 var_1080;
    wp::int32 var_1081;
    const wp::int32 var_1082 = 3;
    const wp::int32 var_1083 = 4;
    wp::int32 var_1084;
    wp::int32 var_1085;
    wp::float64 var_1086;
    const wp::int32 var_1087 = 4;
    wp::int32 var_1088;
    wp::int32 var_1089;
    wp::float64 var_1090;
    const wp::int32 var_1091 = 0;
    wp::float64 var_1092;
    wp::float64 var_1093;
    const wp::int32 var_1094 = 1;
    wp::float64 var_1095;
    wp::float64 var_1096;
    wp::float64 var_1097;
    const wp::int32 var_1098 = 4;
    wp::int32 var_1099;
    wp::int32 var_1100;
    const wp::int32 var_1101 = 1;
    wp::float64 var_1102;
    wp::float64 var_1103;
    const wp::int32 var_1104 = 0;
    wp::float64 var_1105;
    wp::float64 var_1106;
    wp::float64 var_1107;
    const wp::int32 var_1108 = 4;
    wp::int32 var_1109;
    wp::int32 var_1110;
    const wp::int32 var_1111 = 0;
    const wp::int32 var_1112 = 4;
    wp::int32 var_1113;
    wp::int32 var_1114;
    wp::float64 var_1115;
    const wp::int32 var_1116 = 4;
    wp::int32 var_1117;
    wp::int32 var_1118;
    wp::float64 var_1119;
    const wp::int32 var_1120 = 0;
    wp::float64 var_1121;
    wp::float64 var_1122;
    const wp::int32 var_1123 = 1;
    wp::float64 var_1124;
    wp::float64 var_1125;
    wp::float64 var_1126;
    const wp::int32 var_1127 = 4;
    wp::int32 var_1128;
    wp::int32 var_1129;
    const wp::int32 var_1130 = 1;
    wp::float64 var_1131;
    wp::float64 var_1132;
    const wp::int32 var_1133 = 0;
    wp::float64 var_1134;
    wp::float64 var_1135;
    wp::float64 var_1136;
    const wp::int32 var_1137 = 4;
    wp::int32 var_1138;
    wp::int32 var_1139;
    const wp::int32 var_1140 = 1;
    const wp::int32 var_1141 = 4;
    wp::int32 var_1142;
    wp::int32 var_1143;
    wp::float64 var_1144;
    const wp::int32 var_1145 = 4;
    wp::int32 var_1146;
    wp::int32 var_1147;
    wp::float64 var_1148;
    const wp::int32 var_1149 = 0;
    wp::float64 var_1150;
    wp::float64 var_1151;
    const wp::int32 var_1152 = 1;
    wp::float64 var_1153;
    wp::float64 var_1154;
    wp::float64 var_1155;
    const wp::int32 var_1156 = 4;
    wp::int32 var_1157;
    wp::int32 var_1158;
    const wp::int32 var_1159 = 1;
    wp::float64 var_1160;
    wp::float64 var_1161;
    const wp::int32 var_1162 = 0;
    wp::float64 var_1163;
    wp::float64 var_1164;
    wp::float64 var_1165;
    const wp::int32 var_1166 = 4;
    wp::int32 var_1167;
    wp::int32 var_1168;
    const wp::int32 var_1169 = 2;
    const wp::int32 var_1170 = 4;
    wp::int32 var_1171;
    wp::int32 var_1172;
    wp::float64 var_1173;
    const wp::int32 var_1174 = 4;
    wp::int32 var_1175;
    wp::int32 var_1176;
    wp::float64 var_1177;
    const wp::int32 var_1178 = 0;
    wp::float64 var_1179;
    wp::float64 var_1180;
    const wp::int32 var_1181 = 1;
    wp::float64 var_1182;
    wp::float64 var_1183;
    wp::float64 var_1184;
    const wp::int32 var_1185 = 4;
    wp::int32 var_1186;
    wp::int32 var_1187;
    const wp::int32 var_1188 = 1;
    wp::float64 var_1189;
    wp::float64 var_1190;
    const wp::int32 var_1191 = 0;
    wp::float64 var_1192;
    wp::float64 var_1193;
    wp::float64 var_1194;
    const wp::int32 var_1195 = 4;
    wp::int32 var_1196;
    wp::int32 var_1197;
    const wp::int32 var_1198 = 3;
    const wp::int32 var_1199 = 4;
    wp::int32 var_1200;
    wp::int32 var_1201;
    wp::float64 var_1202;
    const wp::int32 var_1203 = 4;
    wp::int32 var_1204;
    wp::int32 var_1205;
    wp::float64 var_1206;
    const wp::int32 var_1207 = 0;
    wp::float64 var_1208;
    wp::float64 var_1209;
    const wp::int32 var_1210 = 1;
    wp::float64 var_1211;
    wp::float64 var_1212;
    wp::float64 var_1213;
    const wp::int32 var_1214 = 4;
    wp::int32 var_1215;
    wp::int32 var_1216;
    const wp::int32 var_1217 = 1;
    wp::float64 var_1218;
    wp::float64 var_1219;
    const wp::int32 var_1220 = 0;
    wp::float64 var_1221;
    wp::float64 var_1222;
    wp::float64 var_1223;
    const wp::int32 var_1224 = 4;
    wp::int32 var_1225;
    wp::int32 var_1226;
    wp::int32 var_1227;
    wp::vec_t<2, wp::float64> var_1228;
    wp::int32 var_1229;
    wp::float64 var_1230;
    wp::float64 var_1231;
    wp::float64 var_1232;
    wp::float64 var_1233;
    wp::float64 var_1234;
    wp::float64 var_1235;
    const wp::int32 var_1236 = 3;
    const wp::int32 var_1237 = 3;
    bool var_1238;
    const wp::int32 var_1239 = 0;
    const wp::int32 var_1240 = 5;
    bool var_1241;
    const wp::int32 var_1242 = 1;
    const wp::int32 var_1243 = 2;
    wp::int32 var_1244;
    wp::int32 var_1245;
    const wp::int32 var_1246 = 1;
    wp::int32 var_1247;
    const wp::int32 var_1248 = 3;
    bool var_1249;
    const wp::int32 var_1250 = 0;
    const wp::int32 var_1251 = 5;
    bool var_1252;
    const wp::int32 var_1253 = 2;
    const wp::int32 var_1254 = 3;
    wp::int32 var_1255;
    wp::int32 var_1256;
    wp::int32 var_1257;
    const wp::int32 var_1258 = 4;
    wp::int32 var_1259;
    wp::int32 var_1260;
    wp::float64 var_1261;
    const wp::int32 var_1262 = 4;
    wp::int32 var_1263;
    wp::int32 var_1264;
    wp::float64 var_1265;
    const wp::int32 var_1266 = 4;
    wp::int32 var_1267;
    wp::int32 var_1268;
    wp::float64 var_1269;
    bool var_1270;
    wp::float64 var_1271;
    wp::float64 var_1272;
    bool var_1273;
    wp::float64 var_1274;
    wp::float64 var_1275;
    wp::float64 var_1276;
    wp::float64 var_1277;
    wp::float64 var_1278;
    wp::float64 var_1279;
    bool var_1280;
    const wp::int32 var_1281 = 1;
    wp::vec_t<2, wp::float64> var_1282;
    const wp::int32 var_1283 = 0;
    const wp::int32 var_1284 = 4;
    wp::int32 var_1285;
    wp::int32 var_1286;
    wp::float64 var_1287;
    const wp::int32 var_1288 = 4;
    wp::int32 var_1289;
    wp::int32 var_1290;
    wp::float64 var_1291;
    const wp::int32 var_1292 = 0;
    wp::float64 var_1293;
    wp::float64 var_1294;
    const wp::int32 var_1295 = 1;
    wp::float64 var_1296;
    wp::float64 var_1297;
    wp::float64 var_1298;
    const wp::int32 var_1299 = 4;
    wp::int32 var_1300;
    wp::int32 var_1301;
    const wp::int32 var_1302 = 1;
    wp::float64 var_1303;
    wp::float64 var_1304;
    const wp::int32 var_1305 = 0;
    wp::float64 var_1306;
    wp::float64 var_1307;
    wp::float64 var_1308;
    const wp::int32 var_1309 = 4;
    wp::int32 var_1310;
    wp::int32 var_1311;
    const wp::int32 var_1312 = 1;
    const wp::int32 var_1313 = 4;
    wp::int32 var_1314;
    wp::int32 var_1315;
    wp::float64 var_1316;
    const wp::int32 var_1317 = 4;
    wp::int32 var_1318;
    wp::int32 var_1319;
    wp::float64 var_1320;
    const wp::int32 var_1321 = 0;
    wp::float64 var_1322;
    wp::float64 var_1323;
    const wp::int32 var_1324 = 1;
    wp::float64 var_1325;
    wp::float64 var_1326;
    wp::float64 var_1327;
    const wp::int32 var_1328 = 4;
    wp::int32 var_1329;
    wp::int32 var_1330;
    const wp::int32 var_1331 = 1;
    wp::float64 var_1332;
    wp::float64 var_1333;
    const wp::int32 var_1334 = 0;
    wp::float64 var_1335;
    wp::float64 var_1336;
    wp::float64 var_1337;
    const wp::int32 var_1338 = 4;
    wp::int32 var_1339;
    wp::int32 var_1340;
    const wp::int32 var_1341 = 2;
    const wp::int32 var_1342 = 4;
    wp::int32 var_1343;
    wp::int32 var_1344;
    wp::float64 var_1345;
    const wp::int32 var_1346 = 4;
    wp::int32 var_1347;
    wp::int32 var_1348;
    wp::float64 var_1349;
    const wp::int32 var_1350 = 0;
    wp::float64 var_1351;
    wp::float64 var_1352;
    const wp::int32 var_1353 = 1;
    wp::float64 var_1354;
    wp::float64 var_1355;
    wp::float64 var_1356;
    const wp::int32 var_1357 = 4;
    wp::int32 var_1358;
    wp::int32 var_1359;
    const wp::int32 var_1360 = 1;
    wp::float64 var_1361;
    wp::float64 var_1362;
    const wp::int32 var_1363 = 0;
    wp::float64 var_1364;
    wp::float64 var_1365;
    wp::float64 var_1366;
    const wp::int32 var_1367 = 4;
    wp::int32 var_1368;
    wp::int32 var_1369;
    const wp::int32 var_1370 = 3;
    const wp::int32 var_1371 = 4;
    wp::int32 var_1372;
    wp::int32 var_1373;
    wp::float64 var_1374;
    const wp::int32 var_1375 = 4;
    wp::int32 var_1376;
    wp::int32 var_1377;
    wp::float64 var_1378;
    const wp::int32 var_1379 = 0;
    wp::float64 var_1380;
    wp::float64 var_1381;
    const wp::int32 var_1382 = 1;
    wp::float64 var_1383;
    wp::float64 var_1384;
    wp::float64 var_1385;
    const wp::int32 var_1386 = 4;
    wp::int32 var_1387;
    wp::int32 var_1388;
    const wp::int32 var_1389 = 1;
    wp::float64 var_1390;
    wp::float64 var_1391;
    const wp::int32 var_1392 = 0;
    wp::float64 var_1393;
    wp::float64 var_1394;
    wp::float64 var_1395;
    const wp::int32 var_1396 = 4;
    wp::int32 var_1397;
    wp::int32 var_1398;
    const wp::int32 var_1399 = 0;
    const wp::int32 var_1400 = 4;
    wp::int32 var_1401;
    wp::int32 var_1402;
    wp::float64 var_1403;
    const wp::int32 var_1404 = 4;
    wp::int32 var_1405;
    wp::int32 var_1406;
    wp::float64 var_1407;
    const wp::int32 var_1408 = 0;
    wp::float64 var_1409;
    wp::float64 var_1410;
    const wp::int32 var_1411 = 1;
    wp::float64 var_1412;
    wp::float64 var_1413;
    wp::float64 var_1414;
    const wp::int32 var_1415 = 4;
    wp::int32 var_1416;
    wp::int32 var_1417;
    const wp::int32 var_1418 = 1;
    wp::float64 var_1419;
    wp::float64 var_1420;
    const wp::int32 var_1421 = 0;
    wp::float64 var_1422;
    wp::float64 var_1423;
    wp::float64 var_1424;
    const wp::int32 var_1425 = 4;
    wp::int32 var_1426;
    wp::int32 var_1427;
    const wp::int32 var_1428 = 1;
    const wp::int32 var_1429 = 4;
    wp::int32 var_1430;
    wp::int32 var_1431;
    wp::float64 var_1432;
    const wp::int32 var_1433 = 4;
    wp::int32 var_1434;
    wp::int32 var_1435;
    wp::float64 var_1436;
    const wp::int32 var_1437 = 0;
    wp::float64 var_1438;
    wp::float64 var_1439;
    const wp::int32 var_1440 = 1;
    wp::float64 var_1441;
    wp::float64 var_1442;
    wp::float64 var_1443;
    const wp::int32 var_1444 = 4;
    wp::int32 var_1445;
    wp::int32 var_1446;
    const wp::int32 var_1447 = 1;
    wp::float64 var_1448;
    wp::float64 var_1449;
    const wp::int32 var_1450 = 0;
    wp::float64 var_1451;
    wp::float64 var_1452;
    wp::float64 var_1453;
    const wp::int32 var_1454 = 4;
    wp::int32 var_1455;
    wp::int32 var_1456;
    const wp::int32 var_1457 = 2;
    const wp::int32 var_1458 = 4;
    wp::int32 var_1459;
    wp::int32 var_1460;
    wp::float64 var_1461;
    const wp::int32 var_1462 = 4;
    wp::int32 var_1463;
    wp::int32 var_1464;
    wp::float64 var_1465;
    const wp::int32 var_1466 = 0;
    wp::float64 var_1467;
    wp::float64 var_1468;
    const wp::int32 var_1469 = 1;
    wp::float64 var_1470;
    wp::float64 var_1471;
    wp::float64 var_1472;
    const wp::int32 var_1473 = 4;
    wp::int32 var_1474;
    wp::int32 var_1475;
    const wp::int32 var_1476 = 1;
    wp::float64 var_1477;
    wp::float64 var_1478;
    const wp::int32 var_1479 = 0;
    wp::float64 var_1480;
    wp::float64 var_1481;
    wp::float64 var_1482;
    const wp::int32 var_1483 = 4;
    wp::int32 var_1484;
    wp::int32 var_1485;
    const wp::int32 var_1486 = 3;
    const wp::int32 var_1487 = 4;
    wp::int32 var_1488;
    wp::int32 var_1489;
    wp::float64 var_1490;
    const wp::int32 var_1491 = 4;
    wp::int32 var_1492;
    wp::int32 var_1493;
    wp::float64 var_1494;
    const wp::int32 var_1495 = 0;
    wp::float64 var_1496;
    wp::float64 var_1497;
    const wp::int32 var_1498 = 1;
    wp::float64 var_1499;
    wp::float64 var_1500;
    wp::float64 var_1501;
    const wp::int32 var_1502 = 4;
    wp::int32 var_1503;
    wp::int32 var_1504;
    const wp::int32 var_1505 = 1;
    wp::float64 var_1506;
    wp::float64 var_1507;
    const wp::int32 var_1508 = 0;
    wp::float64 var_1509;
    wp::float64 var_1510;
    wp::float64 var_1511;
    const wp::int32 var_1512 = 4;
    wp::int32 var_1513;
    wp::int32 var_1514;
    const wp::int32 var_1515 = 0;
    const wp::int32 var_1516 = 4;
    wp::int32 var_1517;
    wp::int32 var_1518;
    wp::float64 var_1519;
    const wp::int32 var_1520 = 4;
    wp::int32 var_1521;
    wp::int32 var_1522;
    wp::float64 var_1523;
    const wp::int32 var_1524 = 0;
    wp::float64 var_1525;
    wp::float64 var_1526;
    const wp::int32 var_1527 = 1;
    wp::float64 var_1528;
    wp::float64 var_1529;
    wp::float64 var_1530;
    const wp::int32 var_1531 = 4;
    wp::int32 var_1532;
    wp::int32 var_1533;
    const wp::int32 var_1534 = 1;
    wp::float64 var_1535;
    wp::float64 var_1536;
    const wp::int32 var_1537 = 0;
    wp::float64 var_1538;
    wp::float64 var_1539;
    wp::float64 var_1540;
    const wp::int32 var_1541 = 4;
    wp::int32 var_1542;
    wp::int32 var_1543;
    const wp::int32 var_1544 = 1;
    const wp::int32 var_1545 = 4;
    wp::int32 var_1546;
    wp::int32 var_1547;
    wp::float64 var_1548;
    const wp::int32 var_1549 = 4;
    wp::int32 var_1550;
    wp::int32 var_1551;
    wp::float64 var_1552;
    const wp::int32 var_1553 = 0;
    wp::float64 var_1554;
    wp::float64 var_1555;
    const wp::int32 var_1556 = 1;
    wp::float64 var_1557;
    wp::float64 var_1558;
    wp::float64 var_1559;
    const wp::int32 var_1560 = 4;
    wp::int32 var_1561;
    wp::int32 var_1562;
    const wp::int32 var_1563 = 1;
    wp::float64 var_1564;
    wp::float64 var_1565;
    const wp::int32 var_1566 = 0;
    wp::float64 var_1567;
    wp::float64 var_1568;
    wp::float64 var_1569;
    const wp::int32 var_1570 = 4;
    wp::int32 var_1571;
    wp::int32 var_1572;
    const wp::int32 var_1573 = 2;
    const wp::int32 var_1574 = 4;
    wp::int32 var_1575;
    wp::int32 var_1576;
    wp::float64 var_1577;
    const wp::int32 var_1578 = 4;
    wp::int32 var_1579;
    wp::int32 var_1580;
    wp::float64 var_1581;
    const wp::int32 var_1582 = 0;
    wp::float64 var_1583;
    wp::float64 var_1584;
    const wp::int32 var_1585 = 1;
    wp::float64 var_1586;
    wp::float64 var_1587;
    wp::float64 var_1588;
    const wp::int32 var_1589 = 4;
    wp::int32 var_1590;
    wp::int32 var_1591;
    const wp::int32 var_1592 = 1;
    wp::float64 var_1593;
    wp::float64 var_1594;
    const wp::int32 var_1595 = 0;
    wp::float64 var_1596;
    wp::float64 var_1597;
    wp::float64 var_1598;
    const wp::int32 var_1599 = 4;
    wp::int32 var_1600;
    wp::int32 var_1601;
    const wp::int32 var_1602 = 3;
    const wp::int32 var_1603 = 4;
    wp::int32 var_1604;
    wp::int32 var_1605;
    wp::float64 var_1606;
    const wp::int32 var_1607 = 4;
    wp::int32 var_1608;
    wp::int32 var_1609;
    wp::float64 var_1610;
    const wp::int32 var_1611 = 0;
    wp::float64 var_1612;
    wp::float64 var_1613;
    const wp::int32 var_1614 = 1;
    wp::float64 var_1615;
    wp::float64 var_1616;
    wp::float64 var_1617;
    const wp::int32 var_1618 = 4;
    wp::int32 var_1619;
    wp::int32 var_1620;
    const wp::int32 var_1621 = 1;
    wp::float64 var_1622;
    wp::float64 var_1623;
    const wp::int32 var_1624 = 0;
    wp::float64 var_1625;
    wp::float64 var_1626;
    wp::float64 var_1627;
    const wp::int32 var_1628 = 4;
    wp::int32 var_1629;
    wp::int32 var_1630;
    wp::int32 var_1631;
    wp::vec_t<2, wp::float64> var_1632;
    wp::int32 var_1633;
    wp::float64 var_1634;
    wp::float64 var_1635;
    wp::float64 var_1636;
    wp::float64 var_1637;
    wp::float64 var_1638;
    wp::float64 var_1639;
    const wp::int32 var_1640 = 4;
    const wp::int32 var_1641 = 3;
    bool var_1642;
    const wp::int32 var_1643 = 0;
    const wp::int32 var_1644 = 5;
    bool var_1645;
    const wp::int32 var_1646 = 1;
    const wp::int32 var_1647 = 2;
    wp::int32 var_1648;
    wp::int32 var_1649;
    const wp::int32 var_1650 = 1;
    wp::int32 var_1651;
    const wp::int32 var_1652 = 3;
    bool var_1653;
    const wp::int32 var_1654 = 0;
    const wp::int32 var_1655 = 5;
    bool var_1656;
    const wp::int32 var_1657 = 2;
    const wp::int32 var_1658 = 3;
    wp::int32 var_1659;
    wp::int32 var_1660;
    wp::int32 var_1661;
    const wp::int32 var_1662 = 4;
    wp::int32 var_1663;
    wp::int32 var_1664;
    wp::float64 var_1665;
    const wp::int32 var_1666 = 4;
    wp::int32 var_1667;
    wp::int32 var_1668;
    wp::float64 var_1669;
    const wp::int32 var_1670 = 4;
    wp::int32 var_1671;
    wp::int32 var_1672;
    wp::float64 var_1673;
    bool var_1674;
    wp::float64 var_1675;
    wp::float64 var_1676;
    bool var_1677;
    wp::float64 var_1678;
    wp::float64 var_1679;
    wp::float64 var_1680;
    wp::float64 var_1681;
    wp::float64 var_1682;
    wp::float64 var_1683;
    bool var_1684;
    const wp::int32 var_1685 = 1;
    wp::vec_t<2, wp::float64> var_1686;
    const wp::int32 var_1687 = 0;
    const wp::int32 var_1688 = 4;
    wp::int32 var_1689;
    wp::int32 var_1690;
    wp::float64 var_1691;
    const wp::int32 var_1692 = 4;
    wp::int32 var_1693;
    wp::int32 var_1694;
    wp::float64 var_1695;
    const wp::int32 var_1696 = 0;
    wp::float64 var_1697;
    wp::float64 var_1698;
    const wp::int32 var_1699 = 1;
    wp::float64 var_1700;
    wp::float64 var_1701;
    wp::float64 var_1702;
    const wp::int32 var_1703 = 4;
    wp::int32 var_1704;
    wp::int32 var_1705;
    const wp::int32 var_1706 = 1;
    wp::float64 var_1707;
    wp::float64 var_1708;
    const wp::int32 var_1709 = 0;
    wp::float64 var_1710;
    wp::float64 var_1711;
    wp::float64 var_1712;
    const wp::int32 var_1713 = 4;
    wp::int32 var_1714;
    wp::int32 var_1715;
    const wp::int32 var_1716 = 1;
    const wp::int32 var_1717 = 4;
    wp::int32 var_1718;
    wp::int32 var_1719;
    wp::float64 var_1720;
    const wp::int32 var_1721 = 4;
    wp::int32 var_1722;
    wp::int32 var_1723;
    wp::float64 var_1724;
    const wp::int32 var_1725 = 0;
    wp::float64 var_1726;
    wp::float64 var_1727;
    const wp::int32 var_1728 = 1;
    wp::float64 var_1729;
    wp::float64 var_1730;
    wp::float64 var_1731;
    const wp::int32 var_1732 = 4;
    wp::int32 var_1733;
    wp::int32 var_1734;
    const wp::int32 var_1735 = 1;
    wp::float64 var_1736;
    wp::float64 var_1737;
    const wp::int32 var_1738 = 0;
    wp::float64 var_1739;
    wp::float64 var_1740;
    wp::float64 var_1741;
    const wp::int32 var_1742 = 4;
    wp::int32 var_1743;
    wp::int32 var_1744;
    const wp::int32 var_1745 = 2;
    const wp::int32 var_1746 = 4;
    wp::int32 var_1747;
    wp::int32 var_1748;
    wp::float64 var_1749;
    const wp::int32 var_1750 = 4;
    wp::int32 var_1751;
    wp::int32 var_1752;
    wp::float64 var_1753;
    const wp::int32 var_1754 = 0;
    wp::float64 var_1755;
    wp::float64 var_1756;
    const wp::int32 var_1757 = 1;
    wp::float64 var_1758;
    wp::float64 var_1759;
    wp::float64 var_1760;
    const wp::int32 var_1761 = 4;
    wp::int32 var_1762;
    wp::int32 var_1763;
    const wp::int32 var_1764 = 1;
    wp::float64 var_1765;
    wp::float64 var_1766;
    const wp::int32 var_1767 = 0;
    wp::float64 var_1768;
    wp::float64 var_1769;
    wp::float64 var_1770;
    const wp::int32 var_1771 = 4;
    wp::int32 var_1772;
    wp::int32 var_1773;
    const wp::int32 var_1774 = 3;
    const wp::int32 var_1775 = 4;
    wp::int32 var_1776;
    wp::int32 var_1777;
    wp::float64 var_1778;
    const wp::int32 var_1779 = 4;
    wp::int32 var_1780;
    wp::int32 var_1781;
    wp::float64 var_1782;
    const wp::int32 var_1783 = 0;
    wp::float64 var_1784;
    wp::float64 var_1785;
    const wp::int32 var_1786 = 1;
    wp::float64 var_1787;
    wp::float64 var_1788;
    wp::float64 var_1789;
    const wp::int32 var_1790 = 4;
    wp::int32 var_1791;
    wp::int32 var_1792;
    const wp::int32 var_1793 = 1;
    wp::float64 var_1794;
    wp::float64 var_1795;
    const wp::int32 var_1796 = 0;
    wp::float64 var_1797;
    wp::float64 var_1798;
    wp::float64 var_1799;
    const wp::int32 var_1800 = 4;
    wp::int32 var_1801;
    wp::int32 var_1802;
    const wp::int32 var_1803 = 0;
    const wp::int32 var_1804 = 4;
    wp::int32 var_1805;
    wp::int32 var_1806;
    wp::float64 var_1807;
    const wp::int32 var_1808 = 4;
    wp::int32 var_1809;
    wp::int32 var_1810;
    wp::float64 var_1811;
    const wp::int32 var_1812 = 0;
    wp::float64 var_1813;
    wp::float64 var_1814;
    const wp::int32 var_1815 = 1;
    wp::float64 var_1816;
    wp::float64 var_1817;
    wp::float64 var_1818;
    const wp::int32 var_1819 = 4;
    wp::int32 var_1820;
    wp::int32 var_1821;
    const wp::int32 var_1822 = 1;
    wp::float64 var_1823;
    wp::float64 var_1824;
    const wp::int32 var_1825 = 0;
    wp::float64 var_1826;
    wp::float64 var_1827;
    wp::float64 var_1828;
    const wp::int32 var_1829 = 4;
    wp::int32 var_1830;
    wp::int32 var_1831;
    const wp::int32 var_1832 = 1;
    const wp::int32 var_1833 = 4;
    wp::int32 var_1834;
    wp::int32 var_1835;
    wp::float64 var_1836;
    const wp::int32 var_1837 = 4;
    wp::int32 var_1838;
    wp::int32 var_1839;
    wp::float64 var_1840;
    const wp::int32 var_1841 = 0;
    wp::float64 var_1842;
    wp::float64 var_1843;
    const wp::int32 var_1844 = 1;
    wp::float64 var_1845;
    wp::float64 var_1846;
    wp::float64 var_1847;
    const wp::int32 var_1848 = 4;
    wp::int32 var_1849;
    wp::int32 var_1850;
    const wp::int32 var_1851 = 1;
    wp::float64 var_1852;
    wp::float64 var_1853;
    const wp::int32 var_1854 = 0;
    wp::float64 var_1855;
    wp::float64 var_1856;
    wp::float64 var_1857;
    const wp::int32 var_1858 = 4;
    wp::int32 var_1859;
    wp::int32 var_1860;
    const wp::int32 var_1861 = 2;
    const wp::int32 var_1862 = 4;
    wp::int32 var_1863;
    wp::int32 var_1864;
    wp::float64 var_1865;
    const wp::int32 var_1866 = 4;
    wp::int32 var_1867;
    wp::int32 var_1868;
    wp::float64 var_1869;
    const wp::int32 var_1870 = 0;
    wp::float64 var_1871;
    wp::float64 var_1872;
    const wp::int32 var_1873 = 1;
    wp::float64 var_1874;
    wp::float64 var_1875;
    wp::float64 var_1876;
    const wp::int32 var_1877 = 4;
    wp::int32 var_1878;
    wp::int32 var_1879;
    const wp::int32 var_1880 = 1;
    wp::float64 var_1881;
    wp::float64 var_1882;
    const wp::int32 var_1883 = 0;
    wp::float64 var_1884;
    wp::float64 var_1885;
    wp::float64 var_1886;
    const wp::int32 var_1887 = 4;
    wp::int32 var_1888;
    wp::int32 var_1889;
    const wp::int32 var_1890 = 3;
    const wp::int32 var_1891 = 4;
    wp::int32 var_1892;
    wp::int32 var_1893;
    wp::float64 var_1894;
    const wp::int32 var_1895 = 4;
    wp::int32 var_1896;
    wp::int32 var_1897;
    wp::float64 var_1898;
    const wp::int32 var_1899 = 0;
    wp::float64 var_1900;
    wp::float64 var_1901;
    const wp::int32 var_1902 = 1;
    wp::float64 var_1903;
    wp::float64 var_1904;
    wp::float64 var_1905;
    const wp::int32 var_1906 = 4;
    wp::int32 var_1907;
    wp::int32 var_1908;
    const wp::int32 var_1909 = 1;
    wp::float64 var_1910;
    wp::float64 var_1911;
    const wp::int32 var_1912 = 0;
    wp::float64 var_1913;
    wp::float64 var_1914;
    wp::float64 var_1915;
    const wp::int32 var_1916 = 4;
    wp::int32 var_1917;
    wp::int32 var_1918;
    const wp::int32 var_1919 = 0;
    const wp::int32 var_1920 = 4;
    wp::int32 var_1921;
    wp::int32 var_1922;
    wp::float64 var_1923;
    const wp::int32 var_1924 = 4;
    wp::int32 var_1925;
    wp::int32 var_1926;
    wp::float64 var_1927;
    const wp::int32 var_1928 = 0;
    wp::float64 var_1929;
    wp::float64 var_1930;
    const wp::int32 var_1931 = 1;
    wp::float64 var_1932;
    wp::float64 var_1933;
    wp::float64 var_1934;
    const wp::int32 var_1935 = 4;
    wp::int32 var_1936;
    wp::int32 var_1937;
    const wp::int32 var_1938 = 1;
    wp::float64 var_1939;
    wp::float64 var_1940;
    const wp::int32 var_1941 = 0;
    wp::float64 var_1942;
    wp::float64 var_1943;
    wp::float64 var_1944;
    const wp::int32 var_1945 = 4;
    wp::int32 var_1946;
    wp::int32 var_1947;
    const wp::int32 var_1948 = 1;
    const wp::int32 var_1949 = 4;
    wp::int32 var_1950;
    wp::int32 var_1951;
    wp::float64 var_1952;
    const wp::int32 var_1953 = 4;
    wp::int32 var_1954;
    wp::int32 var_1955;
    wp::float64 var_1956;
    const wp::int32 var_1957 = 0;
    wp::float64 var_1958;
    wp::float64 var_1959;
    const wp::int32 var_1960 = 1;
    wp::float64 var_1961;
    wp::float64 var_1962;
    wp::float64 var_1963;
    const wp::int32 var_1964 = 4;
    wp::int32 var_1965;
    wp::int32 var_1966;
    const wp::int32 var_1967 = 1;
    wp::float64 var_1968;
    wp::float64 var_1969;
    const wp::int32 var_1970 = 0;
    wp::float64 var_1971;
    wp::float64 var_1972;
    wp::float64 var_1973;
    const wp::int32 var_1974 = 4;
    wp::int32 var_1975;
    wp::int32 var_1976;
    const wp::int32 var_1977 = 2;
    const wp::int32 var_1978 = 4;
    wp::int32 var_1979;
    wp::int32 var_1980;
    wp::float64 var_1981;
    const wp::int32 var_1982 = 4;
    wp::int32 var_1983;
    wp::int32 var_1984;
    wp::float64 var_1985;
    const wp::int32 var_1986 = 0;
    wp::float64 var_1987;
    wp::float64 var_1988;
    const wp::int32 var_1989 = 1;
    wp::float64 var_1990;
    wp::float64 var_1991;
    wp::float64 var_1992;
    const wp::int32 var_1993 = 4;
    wp::int32 var_1994;
    wp::int32 var_1995;
    const wp::int32 var_1996 = 1;
    wp::float64 var_1997;
    wp::float64 var_1998;
    const wp::int32 var_1999 = 0;
    wp::float64 var_2000;
    wp::float64 var_2001;
    wp::float64 var_2002;
    const wp::int32 var_2003 = 4;
    wp::int32 var_2004;
    wp::int32 var_2005;
    const wp::int32 var_2006 = 3;
    const wp::int32 var_2007 = 4;
    wp::int32 var_2008;
    wp::int32 var_2009;
    wp::float64 var_2010;
    const wp::int32 var_2011 = 4;
    wp::int32 var_2012;
    wp::int32 var_2013;
    wp::float64 var_2014;
    const wp::int32 var_2015 = 0;
    wp::float64 var_2016;
    wp::float64 var_2017;
    const wp::int32 var_2018 = 1;
    wp::float64 var_2019;
    wp::float64 var_2020;
    wp::float64 var_2021;
    const wp::int32 var_2022 = 4;
    wp::int32 var_2023;
    wp::int32 var_2024;
    const wp::int32 var_2025 = 1;
    wp::float64 var_2026;
    wp::float64 var_2027;
    const wp::int32 var_2028 = 0;
    wp::float64 var_2029;
    wp::float64 var_2030;
    wp::float64 var_2031;
    const wp::int32 var_2032 = 4;
    wp::int32 var_2033;
    wp::int32 var_2034;
    wp::int32 var_2035;
    wp::vec_t<2, wp::float64> var_2036;
    wp::int32 var_2037;
    wp::float64 var_2038;
    wp::float64 var_2039;
    wp::float64 var_2040;
    wp::float64 var_2041;
    wp::float64 var_2042;
    wp::float64 var_2043;
    const wp::int32 var_2044 = 5;
    const wp::int32 var_2045 = 3;
    bool var_2046;
    const wp::int32 var_2047 = 0;
    const wp::int32 var_2048 = 5;
    bool var_2049;
    const wp::int32 var_2050 = 1;
    const wp::int32 var_2051 = 2;
    wp::int32 var_2052;
    wp::int32 var_2053;
    const wp::int32 var_2054 = 1;
    wp::int32 var_2055;
    const wp::int32 var_2056 = 3;
    bool var_2057;
    const wp::int32 var_2058 = 0;
    const wp::int32 var_2059 = 5;
    bool var_2060;
    const wp::int32 var_2061 = 2;
    const wp::int32 var_2062 = 3;
    wp::int32 var_2063;
    wp::int32 var_2064;
    wp::int32 var_2065;
    const wp::int32 var_2066 = 4;
    wp::int32 var_2067;
    wp::int32 var_2068;
    wp::float64 var_2069;
    const wp::int32 var_2070 = 4;
    wp::int32 var_2071;
    wp::int32 var_2072;
    wp::float64 var_2073;
    const wp::int32 var_2074 = 4;
    wp::int32 var_2075;
    wp::int32 var_2076;
    wp::float64 var_2077;
    bool var_2078;
    wp::float64 var_2079;
    wp::float64 var_2080;
    bool var_2081;
    wp::float64 var_2082;
    wp::float64 var_2083;
    wp::float64 var_2084;
    wp::float64 var_2085;
    wp::float64 var_2086;
    wp::float64 var_2087;
    bool var_2088;
    const wp::int32 var_2089 = 1;
    wp::vec_t<2, wp::float64> var_2090;
    const wp::int32 var_2091 = 0;
    const wp::int32 var_2092 = 4;
    wp::int32 var_2093;
    wp::int32 var_2094;
    wp::float64 var_2095;
    const wp::int32 var_2096 = 4;
    wp::int32 var_2097;
    wp::int32 var_2098;
    wp::float64 var_2099;
    const wp::int32 var_2100 = 0;
    wp::float64 var_2101;
    wp::float64 var_2102;
    const wp::int32 var_2103 = 1;
    wp::float64 var_2104;
    wp::float64 var_2105;
    wp::float64 var_2106;
    const wp::int32 var_2107 = 4;
    wp::int32 var_2108;
    wp::int32 var_2109;
    const wp::int32 var_2110 = 1;
    wp::float64 var_2111;
    wp::float64 var_2112;
    const wp::int32 var_2113 = 0;
    wp::float64 var_2114;
    wp::float64 var_2115;
    wp::float64 var_2116;
    const wp::int32 var_2117 = 4;
    wp::int32 var_2118;
    wp::int32 var_2119;
    const wp::int32 var_2120 = 1;
    const wp::int32 var_2121 = 4;
    wp::int32 var_2122;
    wp::int32 var_2123;
    wp::float64 var_2124;
    const wp::int32 var_2125 = 4;
    wp::int32 var_2126;
    wp::int32 var_2127;
    wp::float64 var_2128;
    const wp::int32 var_2129 = 0;
    wp::float64 var_2130;
    wp::float64 var_2131;
    const wp::int32 var_2132 = 1;
    wp::float64 var_2133;
    wp::float64 var_2134;
    wp::float64 var_2135;
    const wp::int32 var_2136 = 4;
    wp::int32 var_2137;
    wp::int32 var_2138;
    const wp::int32 var_2139 = 1;
    wp::float64 var_2140;
    wp::float64 var_2141;
    const wp::int32 var_2142 = 0;
    wp::float64 var_2143;
    wp::float64 var_2144;
    wp::float64 var_2145;
    const wp::int32 var_2146 = 4;
    wp::int32 var_2147;
    wp::int32 var_2148;
    const wp::int32 var_2149 = 2;
    const wp::int32 var_2150 = 4;
    wp::int32 var_2151;
    wp::int32 var_2152;
    wp::float64 var_2153;
    const wp::int32 var_2154 = 4;
    wp::int32 var_2155;
    wp::int32 var_2156;
    wp::float64 var_2157;
    const wp::int32 var_2158 = 0;
    wp::float64 var_2159;
    wp::float64 var_2160;
    const wp::int32 var_2161 = 1;
    wp::float64 var_2162;
    wp::float64 var_2163;
    wp::float64 var_2164;
    const wp::int32 var_2165 = 4;
    wp::int32 var_2166;
    wp::int32 var_2167;
    const wp::int32 var_2168 = 1;
    wp::float64 var_2169;
    wp::float64 var_2170;
    const wp::int32 var_2171 = 0;
    wp::float64 var_2172;
    wp::float64 var_2173;
    wp::float64 var_2174;
    const wp::int32 var_2175 = 4;
    wp::int32 var_2176;
    wp::int32 var_2177;
    const wp::int32 var_2178 = 3;
    const wp::int32 var_2179 = 4;
    wp::int32 var_2180;
    wp::int32 var_2181;
    wp::float64 var_2182;
    const wp::int32 var_2183 = 4;
    wp::int32 var_2184;
    wp::int32 var_2185;
    wp::float64 var_2186;
    const wp::int32 var_2187 = 0;
    wp::float64 var_2188;
    wp::float64 var_2189;
    const wp::int32 var_2190 = 1;
    wp::float64 var_2191;
    wp::float64 var_2192;
    wp::float64 var_2193;
    const wp::int32 var_2194 = 4;
    wp::int32 var_2195;
    wp::int32 var_2196;
    const wp::int32 var_2197 = 1;
    wp::float64 var_2198;
    wp::float64 var_2199;
    const wp::int32 var_2200 = 0;
    wp::float64 var_2201;
    wp::float64 var_2202;
    wp::float64 var_2203;
    const wp::int32 var_2204 = 4;
    wp::int32 var_2205;
    wp::int32 var_2206;
    const wp::int32 var_2207 = 0;
    const wp::int32 var_2208 = 4;
    wp::int32 var_2209;
    wp::int32 var_2210;
    wp::float64 var_2211;
    const wp::int32 var_2212 = 4;
    wp::int32 var_2213;
    wp::int32 var_2214;
    wp::float64 var_2215;
    const wp::int32 var_2216 = 0;
    wp::float64 var_2217;
    wp::float64 var_2218;
    const wp::int32 var_2219 = 1;
    wp::float64 var_2220;
    wp::float64 var_2221;
    wp::float64 var_2222;
    const wp::int32 var_2223 = 4;
    wp::int32 var_2224;
    wp::int32 var_2225;
    const wp::int32 var_2226 = 1;
    wp::float64 var_2227;
    wp::float64 var_2228;
    const wp::int32 var_2229 = 0;
    wp::float64 var_2230;
    wp::float64 var_2231;
    wp::float64 var_2232;
    const wp::int32 var_2233 = 4;
    wp::int32 var_2234;
    wp::int32 var_2235;
    const wp::int32 var_2236 = 1;
    const wp::int32 var_2237 = 4;
    wp::int32 var_2238;
    wp::int32 var_2239;
    wp::float64 var_2240;
    const wp::int32 var_2241 = 4;
    wp::int32 var_2242;
    wp::int32 var_2243;
    wp::float64 var_2244;
    const wp::int32 var_2245 = 0;
    wp::float64 var_2246;
    wp::float64 var_2247;
    const wp::int32 var_2248 = 1;
    wp::float64 var_2249;
    wp::float64 var_2250;
    wp::float64 var_2251;
    const wp::int32 var_2252 = 4;
    wp::int32 var_2253;
    wp::int32 var_2254;
    const wp::int32 var_2255 = 1;
    wp::float64 var_2256;
    wp::float64 var_2257;
    const wp::int32 var_2258 = 0;
    wp::float64 var_2259;
    wp::float64 var_2260;
    wp::float64 var_2261;
    const wp::int32 var_2262 = 4;
    wp::int32 var_2263;
    wp::int32 var_2264;
    const wp::int32 var_2265 = 2;
    const wp::int32 var_2266 = 4;
    wp::int32 var_2267;
    wp::int32 var_2268;
    wp::float64 var_2269;
    const wp::int32 var_2270 = 4;
    wp::int32 var_2271;
    wp::int32 var_2272;
    wp::float64 var_2273;
    const wp::int32 var_2274 = 0;
    wp::float64 var_2275;
    wp::float64 var_2276;
    const wp::int32 var_2277 = 1;
    wp::float64 var_2278;
    wp::float64 var_2279;
    wp::float64 var_2280;
    const wp::int32 var_2281 = 4;
    wp::int32 var_2282;
    wp::int32 var_2283;
    const wp::int32 var_2284 = 1;
    wp::float64 var_2285;
    wp::float64 var_2286;
    const wp::int32 var_2287 = 0;
    wp::float64 var_2288;
    wp::float64 var_2289;
    wp::float64 var_2290;
    const wp::int32 var_2291 = 4;
    wp::int32 var_2292;
    wp::int32 var_2293;
    const wp::int32 var_2294 = 3;
    const wp::int32 var_2295 = 4;
    wp::int32 var_2296;
    wp::int32 var_2297;
    wp::float64 var_2298;
    const wp::int32 var_2299 = 4;
    wp::int32 var_2300;
    wp::int32 var_2301;
    wp::float64 var_2302;
    const wp::int32 var_2303 = 0;
    wp::float64 var_2304;
    wp::float64 var_2305;
    const wp::int32 var_2306 = 1;
    wp::float64 var_2307;
    wp::float64 var_2308;
    wp::float64 var_2309;
    const wp::int32 var_2310 = 4;
    wp::int32 var_2311;
    wp::int32 var_2312;
    const wp::int32 var_2313 = 1;
    wp::float64 var_2314;
    wp::float64 var_2315;
    const wp::int32 var_2316 = 0;
    wp::float64 var_2317;
    wp::float64 var_2318;
    wp::float64 var_2319;
    const wp::int32 var_2320 = 4;
    wp::int32 var_2321;
    wp::int32 var_2322;
    const wp::int32 var_2323 = 0;
    const wp::int32 var_2324 = 4;
    wp::int32 var_2325;
    wp::int32 var_2326;
    wp::float64 var_2327;
    const wp::int32 var_2328 = 4;
    wp::int32 var_2329;
    wp::int32 var_2330;
    wp::float64 var_2331;
    const wp::int32 var_2332 = 0;
    wp::float64 var_2333;
    wp::float64 var_2334;
    const wp::int32 var_2335 = 1;
    wp::float64 var_2336;
    wp::float64 var_2337;
    wp::float64 var_2338;
    const wp::int32 var_2339 = 4;
    wp::int32 var_2340;
    wp::int32 var_2341;
    const wp::int32 var_2342 = 1;
    wp::float64 var_2343;
    wp::float64 var_2344;
    const wp::int32 var_2345 = 0;
    wp::float64 var_2346;
    wp::float64 var_2347;
    wp::float64 var_2348;
    const wp::int32 var_2349 = 4;
    wp::int32 var_2350;
    wp::int32 var_2351;
    const wp::int32 var_2352 = 1;
    const wp::int32 var_2353 = 4;
    wp::int32 var_2354;
    wp::int32 var_2355;
    wp::float64 var_2356;
    const wp::int32 var_2357 = 4;
    wp::int32 var_2358;
    wp::int32 var_2359;
    wp::float64 var_2360;
    const wp::int32 var_2361 = 0;
    wp::float64 var_2362;
    wp::float64 var_2363;
    const wp::int32 var_2364 = 1;
    wp::float64 var_2365;
    wp::float64 var_2366;
    wp::float64 var_2367;
    const wp::int32 var_2368 = 4;
    wp::int32 var_2369;
    wp::int32 var_2370;
    const wp::int32 var_2371 = 1;
    wp::float64 var_2372;
    wp::float64 var_2373;
    const wp::int32 var_2374 = 0;
    wp::float64 var_2375;
    wp::float64 var_2376;
    wp::float64 var_2377;
    const wp::int32 var_2378 = 4;
    wp::int32 var_2379;
    wp::int32 var_2380;
    const wp::int32 var_2381 = 2;
    const wp::int32 var_2382 = 4;
    wp::int32 var_2383;
    wp::int32 var_2384;
    wp::float64 var_2385;
    const wp::int32 var_2386 = 4;
    wp::int32 var_2387;
    wp::int32 var_2388;
    wp::float64 var_2389;
    const wp::int32 var_2390 = 0;
    wp::float64 var_2391;
    wp::float64 var_2392;
    const wp::int32 var_2393 = 1;
    wp::float64 var_2394;
    wp::float64 var_2395;
    wp::float64 var_2396;
    const wp::int32 var_2397 = 4;
    wp::int32 var_2398;
    wp::int32 var_2399;
    const wp::int32 var_2400 = 1;
    wp::float64 var_2401;
    wp::float64 var_2402;
    const wp::int32 var_2403 = 0;
    wp::float64 var_2404;
    wp::float64 var_2405;
    wp::float64 var_2406;
    const wp::int32 var_2407 = 4;
    wp::int32 var_2408;
    wp::int32 var_2409;
    const wp::int32 var_2410 = 3;
    const wp::int32 var_2411 = 4;
    wp::int32 var_2412;
    wp::int32 var_2413;
    wp::float64 var_2414;
    const wp::int32 var_2415 = 4;
    wp::int32 var_2416;
    wp::int32 var_2417;
    wp::float64 var_2418;
    const wp::int32 var_2419 = 0;
    wp::float64 var_2420;
    wp::float64 var_2421;
    const wp::int32 var_2422 = 1;
    wp::float64 var_2423;
    wp::float64 var_2424;
    wp::float64 var_2425;
    const wp::int32 var_2426 = 4;
    wp::int32 var_2427;
    wp::int32 var_2428;
    const wp::int32 var_2429 = 1;
    wp::float64 var_2430;
    wp::float64 var_2431;
    const wp::int32 var_2432 = 0;
    wp::float64 var_2433;
    wp::float64 var_2434;
    wp::float64 var_2435;
    const wp::int32 var_2436 = 4;
    wp::int32 var_2437;
    wp::int32 var_2438;
    wp::int32 var_2439;
    wp::vec_t<2, wp::float64> var_2440;
    wp::int32 var_2441;
    wp::float64 var_2442;
    wp::float64 var_2443;
    wp::float64 var_2444;
    wp::float64 var_2445;
    wp::float64 var_2446;
    wp::float64 var_2447;
    wp::float64 var_2448;
    wp::vec_t<20, wp::float64> var_2449;
    const wp::int32 var_2450 = 0;
    wp::float64 var_2451;
    const wp::int32 var_2452 = 1;
    wp::float64 var_2453;
    const wp::int32 var_2454 = 2;
    wp::float64 var_2455;
    const wp::int32 var_2456 = 3;
    wp::float64 var_2457;
    const wp::int32 var_2458 = 4;
    wp::float64 var_2459;
    const wp::int32 var_2460 = 5;
    wp::float64 var_2461;
    const wp::int32 var_2462 = 6;
    wp::float64 var_2463;
    const wp::int32 var_2464 = 7;
    wp::float64 var_2465;
    const wp::int32 var_2466 = 8;
    wp::float64 var_2467;
    const wp::int32 var_2468 = 9;
    wp::float64 var_2469;
    const wp::int32 var_2470 = 10;
    wp::float64 var_2471;
    const wp::int32 var_2472 = 11;
    wp::float64 var_2473;
    const wp::int32 var_2474 = 12;
    wp::float64 var_2475;
    const wp::int32 var_2476 = 13;
    wp::float64 var_2477;
    const wp::int32 var_2478 = 14;
    wp::float64 var_2479;
    const wp::int32 var_2480 = 15;
    wp::float64 var_2481;
    const wp::int32 var_2482 = 0;
    const wp::int32 var_2483 = 5;
    wp::int32 var_2484;
    wp::float64 var_2485;
    const wp::int32 var_2486 = 16;
    wp::int32 var_2487;
    const wp::int32 var_2488 = 1;
    const wp::int32 var_2489 = 5;
    wp::int32 var_2490;
    wp::float64 var_2491;
    const wp::int32 var_2492 = 16;
    wp::int32 var_2493;
    const wp::int32 var_2494 = 2;
    const wp::int32 var_2495 = 5;
    wp::int32 var_2496;
    wp::float64 var_2497;
    const wp::int32 var_2498 = 16;
    wp::int32 var_2499;
    const wp::int32 var_2500 = 3;
    const wp::int32 var_2501 = 5;
    wp::int32 var_2502;
    wp::float64 var_2503;
    const wp::int32 var_2504 = 16;
    wp::int32 var_2505;
    //---------
    // forward
    // def diagonalize_four(matrix):                                                          <L 1>
    // a = matrix                                                                             <L 3>
    var_0 = wp::copy(var_matrix);
    // v = four_square(float64(0.0))                                                          <L 4>
    var_1 = 0.0;
    var_2 = wp::vec_t<16, wp::float64>(var_1);
    // for i in range(4):                                                                     <L 5>
    // v[i * 5] = float64(1.0)                                                                <L 6>
    var_4 = 1.0;
    var_6 = wp::mul(var_3, var_5);
    wp::assign_inplace(var_2, var_6, var_4);
    var_8 = 1.0;
    var_10 = wp::mul(var_7, var_9);
    wp::assign_inplace(var_2, var_10, var_8);
    var_12 = 1.0;
    var_14 = wp::mul(var_11, var_13);
    wp::assign_inplace(var_2, var_14, var_12);
    var_16 = 1.0;
    var_18 = wp::mul(var_15, var_17);
    wp::assign_inplace(var_2, var_18, var_16);
    // rotated = int(1)                                                                       <L 7>
    var_20 = wp::int(var_19);
    // sweep = int(0)                                                                         <L 8>
    var_22 = wp::int(var_21);
    // while rotated == 1 and sweep < SWEEPS:                                                 <L 9>
    start_while_0:;
    var_25 = (var_20 == var_24);
    var_23 = var_25;
    if (var_23) {
        var_27 = (var_22 < var_26);
        var_23 = var_23 && var_27;
    }
    if ((var_23) == false) goto end_while_0;
        // rotated = int(0)                                                                   <L 10>
        var_29 = wp::int(var_28);
        // sweep += 1                                                                         <L 11>
        var_31 = wp::add(var_22, var_30);
        // for pair in range(6):                                                              <L 12>
        // p = 0 if pair < 3 else 1 if pair < 5 else 2                                        <L 13>
        var_34 = (var_32 < var_33);
        if (var_34) {
        }
        if (!var_34) {
            var_37 = (var_32 < var_36);
            if (var_37) {
            }
            if (!var_37) {
            }
            var_40 = wp::where(var_37, var_38, var_39);
        }
        var_41 = wp::where(var_34, var_35, var_40);
        // q = pair + 1 - (0 if pair < 3 else 2 if pair < 5 else 3)                           <L 14>
        var_43 = wp::add(var_32, var_42);
        var_45 = (var_32 < var_44);
        if (var_45) {
        }
        if (!var_45) {
            var_48 = (var_32 < var_47);
            if (var_48) {
            }
            if (!var_48) {
            }
            var_51 = wp::where(var_48, var_49, var_50);
        }
        var_52 = wp::where(var_45, var_46, var_51);
        var_53 = wp::sub(var_43, var_52);
        // apq = a[p * 4 + q]                                                                 <L 15>
        var_55 = wp::mul(var_41, var_54);
        var_56 = wp::add(var_55, var_53);
        var_57 = wp::extract(var_0, var_56);
        // app = a[p * 4 + p]                                                                 <L 16>
        var_59 = wp::mul(var_41, var_58);
        var_60 = wp::add(var_59, var_41);
        var_61 = wp::extract(var_0, var_60);
        // aqq = a[q * 4 + q]                                                                 <L 17>
        var_63 = wp::mul(var_53, var_62);
        var_64 = wp::add(var_63, var_53);
        var_65 = wp::extract(var_0, var_64);
        // if abs(apq) > float64(1e-300) and abs(apq) > float64(1e-18) * sqrt(abs(app * aqq)):       <L 18>
        var_67 = wp::abs(var_57);
        var_68 = 1e-300;
        var_69 = (var_67 > var_68);
        var_66 = var_69;
        if (var_66) {
            var_70 = wp::abs(var_57);
            var_71 = 1e-18;
            var_72 = wp::mul(var_61, var_65);
            var_73 = wp::abs(var_72);
            var_74 = wp::sqrt(var_73);
            var_75 = wp::mul(var_71, var_74);
            var_76 = (var_70 > var_75);
            var_66 = var_66 && var_76;
        }
        if (var_66) {
            // rotated = 1                                                                    <L 19>
            // cs = jacobi_rotation(app, aqq, apq)                                            <L 20>
            var_78 = jacobi_rotation_0(var_61, var_65, var_57);
            // for k in range(4):                                                             <L 21>
            // akp = a[k * 4 + p]                                                             <L 22>
            var_81 = wp::mul(var_79, var_80);
            var_82 = wp::add(var_81, var_41);
            var_83 = wp::extract(var_0, var_82);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_85 = wp::mul(var_79, var_84);
            var_86 = wp::add(var_85, var_53);
            var_87 = wp::extract(var_0, var_86);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_89 = wp::extract(var_78, var_88);
            var_90 = wp::mul(var_89, var_83);
            var_92 = wp::extract(var_78, var_91);
            var_93 = wp::mul(var_92, var_87);
            var_94 = wp::sub(var_90, var_93);
            var_96 = wp::mul(var_79, var_95);
            var_97 = wp::add(var_96, var_41);
            wp::assign_inplace(var_0, var_97, var_94);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_99 = wp::extract(var_78, var_98);
            var_100 = wp::mul(var_99, var_83);
            var_102 = wp::extract(var_78, var_101);
            var_103 = wp::mul(var_102, var_87);
            var_104 = wp::add(var_100, var_103);
            var_106 = wp::mul(var_79, var_105);
            var_107 = wp::add(var_106, var_53);
            wp::assign_inplace(var_0, var_107, var_104);
            // akp = a[k * 4 + p]                                                             <L 22>
            var_110 = wp::mul(var_108, var_109);
            var_111 = wp::add(var_110, var_41);
            var_112 = wp::extract(var_0, var_111);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_114 = wp::mul(var_108, var_113);
            var_115 = wp::add(var_114, var_53);
            var_116 = wp::extract(var_0, var_115);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_118 = wp::extract(var_78, var_117);
            var_119 = wp::mul(var_118, var_112);
            var_121 = wp::extract(var_78, var_120);
            var_122 = wp::mul(var_121, var_116);
            var_123 = wp::sub(var_119, var_122);
            var_125 = wp::mul(var_108, var_124);
            var_126 = wp::add(var_125, var_41);
            wp::assign_inplace(var_0, var_126, var_123);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_128 = wp::extract(var_78, var_127);
            var_129 = wp::mul(var_128, var_112);
            var_131 = wp::extract(var_78, var_130);
            var_132 = wp::mul(var_131, var_116);
            var_133 = wp::add(var_129, var_132);
            var_135 = wp::mul(var_108, var_134);
            var_136 = wp::add(var_135, var_53);
            wp::assign_inplace(var_0, var_136, var_133);
            // akp = a[k * 4 + p]                                                             <L 22>
            var_139 = wp::mul(var_137, var_138);
            var_140 = wp::add(var_139, var_41);
            var_141 = wp::extract(var_0, var_140);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_143 = wp::mul(var_137, var_142);
            var_144 = wp::add(var_143, var_53);
            var_145 = wp::extract(var_0, var_144);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_147 = wp::extract(var_78, var_146);
            var_148 = wp::mul(var_147, var_141);
            var_150 = wp::extract(var_78, var_149);
            var_151 = wp::mul(var_150, var_145);
            var_152 = wp::sub(var_148, var_151);
            var_154 = wp::mul(var_137, var_153);
            var_155 = wp::add(var_154, var_41);
            wp::assign_inplace(var_0, var_155, var_152);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_157 = wp::extract(var_78, var_156);
            var_158 = wp::mul(var_157, var_141);
            var_160 = wp::extract(var_78, var_159);
            var_161 = wp::mul(var_160, var_145);
            var_162 = wp::add(var_158, var_161);
            var_164 = wp::mul(var_137, var_163);
            var_165 = wp::add(var_164, var_53);
            wp::assign_inplace(var_0, var_165, var_162);
            // akp = a[k * 4 + p]                                                             <L 22>
            var_168 = wp::mul(var_166, var_167);
            var_169 = wp::add(var_168, var_41);
            var_170 = wp::extract(var_0, var_169);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_172 = wp::mul(var_166, var_171);
            var_173 = wp::add(var_172, var_53);
            var_174 = wp::extract(var_0, var_173);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_176 = wp::extract(var_78, var_175);
            var_177 = wp::mul(var_176, var_170);
            var_179 = wp::extract(var_78, var_178);
            var_180 = wp::mul(var_179, var_174);
            var_181 = wp::sub(var_177, var_180);
            var_183 = wp::mul(var_166, var_182);
            var_184 = wp::add(var_183, var_41);
            wp::assign_inplace(var_0, var_184, var_181);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_186 = wp::extract(var_78, var_185);
            var_187 = wp::mul(var_186, var_170);
            var_189 = wp::extract(var_78, var_188);
            var_190 = wp::mul(var_189, var_174);
            var_191 = wp::add(var_187, var_190);
            var_193 = wp::mul(var_166, var_192);
            var_194 = wp::add(var_193, var_53);
            wp::assign_inplace(var_0, var_194, var_191);
            // for k in range(4):                                                             <L 26>
            // apk = a[p * 4 + k]                                                             <L 27>
            var_197 = wp::mul(var_41, var_196);
            var_198 = wp::add(var_197, var_195);
            var_199 = wp::extract(var_0, var_198);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_201 = wp::mul(var_53, var_200);
            var_202 = wp::add(var_201, var_195);
            var_203 = wp::extract(var_0, var_202);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_205 = wp::extract(var_78, var_204);
            var_206 = wp::mul(var_205, var_199);
            var_208 = wp::extract(var_78, var_207);
            var_209 = wp::mul(var_208, var_203);
            var_210 = wp::sub(var_206, var_209);
            var_212 = wp::mul(var_41, var_211);
            var_213 = wp::add(var_212, var_195);
            wp::assign_inplace(var_0, var_213, var_210);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_215 = wp::extract(var_78, var_214);
            var_216 = wp::mul(var_215, var_199);
            var_218 = wp::extract(var_78, var_217);
            var_219 = wp::mul(var_218, var_203);
            var_220 = wp::add(var_216, var_219);
            var_222 = wp::mul(var_53, var_221);
            var_223 = wp::add(var_222, var_195);
            wp::assign_inplace(var_0, var_223, var_220);
            // apk = a[p * 4 + k]                                                             <L 27>
            var_226 = wp::mul(var_41, var_225);
            var_227 = wp::add(var_226, var_224);
            var_228 = wp::extract(var_0, var_227);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_230 = wp::mul(var_53, var_229);
            var_231 = wp::add(var_230, var_224);
            var_232 = wp::extract(var_0, var_231);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_234 = wp::extract(var_78, var_233);
            var_235 = wp::mul(var_234, var_228);
            var_237 = wp::extract(var_78, var_236);
            var_238 = wp::mul(var_237, var_232);
            var_239 = wp::sub(var_235, var_238);
            var_241 = wp::mul(var_41, var_240);
            var_242 = wp::add(var_241, var_224);
            wp::assign_inplace(var_0, var_242, var_239);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_244 = wp::extract(var_78, var_243);
            var_245 = wp::mul(var_244, var_228);
            var_247 = wp::extract(var_78, var_246);
            var_248 = wp::mul(var_247, var_232);
            var_249 = wp::add(var_245, var_248);
            var_251 = wp::mul(var_53, var_250);
            var_252 = wp::add(var_251, var_224);
            wp::assign_inplace(var_0, var_252, var_249);
            // apk = a[p * 4 + k]                                                             <L 27>
            var_255 = wp::mul(var_41, var_254);
            var_256 = wp::add(var_255, var_253);
            var_257 = wp::extract(var_0, var_256);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_259 = wp::mul(var_53, var_258);
            var_260 = wp::add(var_259, var_253);
            var_261 = wp::extract(var_0, var_260);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_263 = wp::extract(var_78, var_262);
            var_264 = wp::mul(var_263, var_257);
            var_266 = wp::extract(var_78, var_265);
            var_267 = wp::mul(var_266, var_261);
            var_268 = wp::sub(var_264, var_267);
            var_270 = wp::mul(var_41, var_269);
            var_271 = wp::add(var_270, var_253);
            wp::assign_inplace(var_0, var_271, var_268);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_273 = wp::extract(var_78, var_272);
            var_274 = wp::mul(var_273, var_257);
            var_276 = wp::extract(var_78, var_275);
            var_277 = wp::mul(var_276, var_261);
            var_278 = wp::add(var_274, var_277);
            var_280 = wp::mul(var_53, var_279);
            var_281 = wp::add(var_280, var_253);
            wp::assign_inplace(var_0, var_281, var_278);
            // apk = a[p * 4 + k]                                                             <L 27>
            var_284 = wp::mul(var_41, var_283);
            var_285 = wp::add(var_284, var_282);
            var_286 = wp::extract(var_0, var_285);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_288 = wp::mul(var_53, var_287);
            var_289 = wp::add(var_288, var_282);
            var_290 = wp::extract(var_0, var_289);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_292 = wp::extract(var_78, var_291);
            var_293 = wp::mul(var_292, var_286);
            var_295 = wp::extract(var_78, var_294);
            var_296 = wp::mul(var_295, var_290);
            var_297 = wp::sub(var_293, var_296);
            var_299 = wp::mul(var_41, var_298);
            var_300 = wp::add(var_299, var_282);
            wp::assign_inplace(var_0, var_300, var_297);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_302 = wp::extract(var_78, var_301);
            var_303 = wp::mul(var_302, var_286);
            var_305 = wp::extract(var_78, var_304);
            var_306 = wp::mul(var_305, var_290);
            var_307 = wp::add(var_303, var_306);
            var_309 = wp::mul(var_53, var_308);
            var_310 = wp::add(var_309, var_282);
            wp::assign_inplace(var_0, var_310, var_307);
            // for k in range(4):                                                             <L 31>
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_313 = wp::mul(var_311, var_312);
            var_314 = wp::add(var_313, var_41);
            var_315 = wp::extract(var_2, var_314);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_317 = wp::mul(var_311, var_316);
            var_318 = wp::add(var_317, var_53);
            var_319 = wp::extract(var_2, var_318);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_321 = wp::extract(var_78, var_320);
            var_322 = wp::mul(var_321, var_315);
            var_324 = wp::extract(var_78, var_323);
            var_325 = wp::mul(var_324, var_319);
            var_326 = wp::sub(var_322, var_325);
            var_328 = wp::mul(var_311, var_327);
            var_329 = wp::add(var_328, var_41);
            wp::assign_inplace(var_2, var_329, var_326);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_331 = wp::extract(var_78, var_330);
            var_332 = wp::mul(var_331, var_315);
            var_334 = wp::extract(var_78, var_333);
            var_335 = wp::mul(var_334, var_319);
            var_336 = wp::add(var_332, var_335);
            var_338 = wp::mul(var_311, var_337);
            var_339 = wp::add(var_338, var_53);
            wp::assign_inplace(var_2, var_339, var_336);
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_342 = wp::mul(var_340, var_341);
            var_343 = wp::add(var_342, var_41);
            var_344 = wp::extract(var_2, var_343);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_346 = wp::mul(var_340, var_345);
            var_347 = wp::add(var_346, var_53);
            var_348 = wp::extract(var_2, var_347);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_350 = wp::extract(var_78, var_349);
            var_351 = wp::mul(var_350, var_344);
            var_353 = wp::extract(var_78, var_352);
            var_354 = wp::mul(var_353, var_348);
            var_355 = wp::sub(var_351, var_354);
            var_357 = wp::mul(var_340, var_356);
            var_358 = wp::add(var_357, var_41);
            wp::assign_inplace(var_2, var_358, var_355);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_360 = wp::extract(var_78, var_359);
            var_361 = wp::mul(var_360, var_344);
            var_363 = wp::extract(var_78, var_362);
            var_364 = wp::mul(var_363, var_348);
            var_365 = wp::add(var_361, var_364);
            var_367 = wp::mul(var_340, var_366);
            var_368 = wp::add(var_367, var_53);
            wp::assign_inplace(var_2, var_368, var_365);
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_371 = wp::mul(var_369, var_370);
            var_372 = wp::add(var_371, var_41);
            var_373 = wp::extract(var_2, var_372);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_375 = wp::mul(var_369, var_374);
            var_376 = wp::add(var_375, var_53);
            var_377 = wp::extract(var_2, var_376);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_379 = wp::extract(var_78, var_378);
            var_380 = wp::mul(var_379, var_373);
            var_382 = wp::extract(var_78, var_381);
            var_383 = wp::mul(var_382, var_377);
            var_384 = wp::sub(var_380, var_383);
            var_386 = wp::mul(var_369, var_385);
            var_387 = wp::add(var_386, var_41);
            wp::assign_inplace(var_2, var_387, var_384);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_389 = wp::extract(var_78, var_388);
            var_390 = wp::mul(var_389, var_373);
            var_392 = wp::extract(var_78, var_391);
            var_393 = wp::mul(var_392, var_377);
            var_394 = wp::add(var_390, var_393);
            var_396 = wp::mul(var_369, var_395);
            var_397 = wp::add(var_396, var_53);
            wp::assign_inplace(var_2, var_397, var_394);
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_400 = wp::mul(var_398, var_399);
            var_401 = wp::add(var_400, var_41);
            var_402 = wp::extract(var_2, var_401);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_404 = wp::mul(var_398, var_403);
            var_405 = wp::add(var_404, var_53);
            var_406 = wp::extract(var_2, var_405);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_408 = wp::extract(var_78, var_407);
            var_409 = wp::mul(var_408, var_402);
            var_411 = wp::extract(var_78, var_410);
            var_412 = wp::mul(var_411, var_406);
            var_413 = wp::sub(var_409, var_412);
            var_415 = wp::mul(var_398, var_414);
            var_416 = wp::add(var_415, var_41);
            wp::assign_inplace(var_2, var_416, var_413);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_418 = wp::extract(var_78, var_417);
            var_419 = wp::mul(var_418, var_402);
            var_421 = wp::extract(var_78, var_420);
            var_422 = wp::mul(var_421, var_406);
            var_423 = wp::add(var_419, var_422);
            var_425 = wp::mul(var_398, var_424);
            var_426 = wp::add(var_425, var_53);
            wp::assign_inplace(var_2, var_426, var_423);
        }
        var_427 = wp::where(var_66, var_77, var_29);
        // p = 0 if pair < 3 else 1 if pair < 5 else 2                                        <L 13>
        var_430 = (var_428 < var_429);
        if (var_430) {
        }
        if (!var_430) {
            var_433 = (var_428 < var_432);
            if (var_433) {
            }
            if (!var_433) {
            }
            var_436 = wp::where(var_433, var_434, var_435);
        }
        var_437 = wp::where(var_430, var_431, var_436);
        // q = pair + 1 - (0 if pair < 3 else 2 if pair < 5 else 3)                           <L 14>
        var_439 = wp::add(var_428, var_438);
        var_441 = (var_428 < var_440);
        if (var_441) {
        }
        if (!var_441) {
            var_444 = (var_428 < var_443);
            if (var_444) {
            }
            if (!var_444) {
            }
            var_447 = wp::where(var_444, var_445, var_446);
        }
        var_448 = wp::where(var_441, var_442, var_447);
        var_449 = wp::sub(var_439, var_448);
        // apq = a[p * 4 + q]                                                                 <L 15>
        var_451 = wp::mul(var_437, var_450);
        var_452 = wp::add(var_451, var_449);
        var_453 = wp::extract(var_0, var_452);
        // app = a[p * 4 + p]                                                                 <L 16>
        var_455 = wp::mul(var_437, var_454);
        var_456 = wp::add(var_455, var_437);
        var_457 = wp::extract(var_0, var_456);
        // aqq = a[q * 4 + q]                                                                 <L 17>
        var_459 = wp::mul(var_449, var_458);
        var_460 = wp::add(var_459, var_449);
        var_461 = wp::extract(var_0, var_460);
        // if abs(apq) > float64(1e-300) and abs(apq) > float64(1e-18) * sqrt(abs(app * aqq)):       <L 18>
        var_463 = wp::abs(var_453);
        var_464 = 1e-300;
        var_465 = (var_463 > var_464);
        var_462 = var_465;
        if (var_462) {
            var_466 = wp::abs(var_453);
            var_467 = 1e-18;
            var_468 = wp::mul(var_457, var_461);
            var_469 = wp::abs(var_468);
            var_470 = wp::sqrt(var_469);
            var_471 = wp::mul(var_467, var_470);
            var_472 = (var_466 > var_471);
            var_462 = var_462 && var_472;
        }
        if (var_462) {
            // rotated = 1                                                                    <L 19>
            // cs = jacobi_rotation(app, aqq, apq)                                            <L 20>
            var_474 = jacobi_rotation_0(var_457, var_461, var_453);
            // for k in range(4):                                                             <L 21>
            // akp = a[k * 4 + p]                                                             <L 22>
            var_477 = wp::mul(var_475, var_476);
            var_478 = wp::add(var_477, var_437);
            var_479 = wp::extract(var_0, var_478);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_481 = wp::mul(var_475, var_480);
            var_482 = wp::add(var_481, var_449);
            var_483 = wp::extract(var_0, var_482);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_485 = wp::extract(var_474, var_484);
            var_486 = wp::mul(var_485, var_479);
            var_488 = wp::extract(var_474, var_487);
            var_489 = wp::mul(var_488, var_483);
            var_490 = wp::sub(var_486, var_489);
            var_492 = wp::mul(var_475, var_491);
            var_493 = wp::add(var_492, var_437);
            wp::assign_inplace(var_0, var_493, var_490);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_495 = wp::extract(var_474, var_494);
            var_496 = wp::mul(var_495, var_479);
            var_498 = wp::extract(var_474, var_497);
            var_499 = wp::mul(var_498, var_483);
            var_500 = wp::add(var_496, var_499);
            var_502 = wp::mul(var_475, var_501);
            var_503 = wp::add(var_502, var_449);
            wp::assign_inplace(var_0, var_503, var_500);
            // akp = a[k * 4 + p]                                                             <L 22>
            var_506 = wp::mul(var_504, var_505);
            var_507 = wp::add(var_506, var_437);
            var_508 = wp::extract(var_0, var_507);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_510 = wp::mul(var_504, var_509);
            var_511 = wp::add(var_510, var_449);
            var_512 = wp::extract(var_0, var_511);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_514 = wp::extract(var_474, var_513);
            var_515 = wp::mul(var_514, var_508);
            var_517 = wp::extract(var_474, var_516);
            var_518 = wp::mul(var_517, var_512);
            var_519 = wp::sub(var_515, var_518);
            var_521 = wp::mul(var_504, var_520);
            var_522 = wp::add(var_521, var_437);
            wp::assign_inplace(var_0, var_522, var_519);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_524 = wp::extract(var_474, var_523);
            var_525 = wp::mul(var_524, var_508);
            var_527 = wp::extract(var_474, var_526);
            var_528 = wp::mul(var_527, var_512);
            var_529 = wp::add(var_525, var_528);
            var_531 = wp::mul(var_504, var_530);
            var_532 = wp::add(var_531, var_449);
            wp::assign_inplace(var_0, var_532, var_529);
            // akp = a[k * 4 + p]                                                             <L 22>
            var_535 = wp::mul(var_533, var_534);
            var_536 = wp::add(var_535, var_437);
            var_537 = wp::extract(var_0, var_536);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_539 = wp::mul(var_533, var_538);
            var_540 = wp::add(var_539, var_449);
            var_541 = wp::extract(var_0, var_540);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_543 = wp::extract(var_474, var_542);
            var_544 = wp::mul(var_543, var_537);
            var_546 = wp::extract(var_474, var_545);
            var_547 = wp::mul(var_546, var_541);
            var_548 = wp::sub(var_544, var_547);
            var_550 = wp::mul(var_533, var_549);
            var_551 = wp::add(var_550, var_437);
            wp::assign_inplace(var_0, var_551, var_548);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_553 = wp::extract(var_474, var_552);
            var_554 = wp::mul(var_553, var_537);
            var_556 = wp::extract(var_474, var_555);
            var_557 = wp::mul(var_556, var_541);
            var_558 = wp::add(var_554, var_557);
            var_560 = wp::mul(var_533, var_559);
            var_561 = wp::add(var_560, var_449);
            wp::assign_inplace(var_0, var_561, var_558);
            // akp = a[k * 4 + p]                                                             <L 22>
            var_564 = wp::mul(var_562, var_563);
            var_565 = wp::add(var_564, var_437);
            var_566 = wp::extract(var_0, var_565);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_568 = wp::mul(var_562, var_567);
            var_569 = wp::add(var_568, var_449);
            var_570 = wp::extract(var_0, var_569);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_572 = wp::extract(var_474, var_571);
            var_573 = wp::mul(var_572, var_566);
            var_575 = wp::extract(var_474, var_574);
            var_576 = wp::mul(var_575, var_570);
            var_577 = wp::sub(var_573, var_576);
            var_579 = wp::mul(var_562, var_578);
            var_580 = wp::add(var_579, var_437);
            wp::assign_inplace(var_0, var_580, var_577);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_582 = wp::extract(var_474, var_581);
            var_583 = wp::mul(var_582, var_566);
            var_585 = wp::extract(var_474, var_584);
            var_586 = wp::mul(var_585, var_570);
            var_587 = wp::add(var_583, var_586);
            var_589 = wp::mul(var_562, var_588);
            var_590 = wp::add(var_589, var_449);
            wp::assign_inplace(var_0, var_590, var_587);
            // for k in range(4):                                                             <L 26>
            // apk = a[p * 4 + k]                                                             <L 27>
            var_593 = wp::mul(var_437, var_592);
            var_594 = wp::add(var_593, var_591);
            var_595 = wp::extract(var_0, var_594);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_597 = wp::mul(var_449, var_596);
            var_598 = wp::add(var_597, var_591);
            var_599 = wp::extract(var_0, var_598);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_601 = wp::extract(var_474, var_600);
            var_602 = wp::mul(var_601, var_595);
            var_604 = wp::extract(var_474, var_603);
            var_605 = wp::mul(var_604, var_599);
            var_606 = wp::sub(var_602, var_605);
            var_608 = wp::mul(var_437, var_607);
            var_609 = wp::add(var_608, var_591);
            wp::assign_inplace(var_0, var_609, var_606);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_611 = wp::extract(var_474, var_610);
            var_612 = wp::mul(var_611, var_595);
            var_614 = wp::extract(var_474, var_613);
            var_615 = wp::mul(var_614, var_599);
            var_616 = wp::add(var_612, var_615);
            var_618 = wp::mul(var_449, var_617);
            var_619 = wp::add(var_618, var_591);
            wp::assign_inplace(var_0, var_619, var_616);
            // apk = a[p * 4 + k]                                                             <L 27>
            var_622 = wp::mul(var_437, var_621);
            var_623 = wp::add(var_622, var_620);
            var_624 = wp::extract(var_0, var_623);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_626 = wp::mul(var_449, var_625);
            var_627 = wp::add(var_626, var_620);
            var_628 = wp::extract(var_0, var_627);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_630 = wp::extract(var_474, var_629);
            var_631 = wp::mul(var_630, var_624);
            var_633 = wp::extract(var_474, var_632);
            var_634 = wp::mul(var_633, var_628);
            var_635 = wp::sub(var_631, var_634);
            var_637 = wp::mul(var_437, var_636);
            var_638 = wp::add(var_637, var_620);
            wp::assign_inplace(var_0, var_638, var_635);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_640 = wp::extract(var_474, var_639);
            var_641 = wp::mul(var_640, var_624);
            var_643 = wp::extract(var_474, var_642);
            var_644 = wp::mul(var_643, var_628);
            var_645 = wp::add(var_641, var_644);
            var_647 = wp::mul(var_449, var_646);
            var_648 = wp::add(var_647, var_620);
            wp::assign_inplace(var_0, var_648, var_645);
            // apk = a[p * 4 + k]                                                             <L 27>
            var_651 = wp::mul(var_437, var_650);
            var_652 = wp::add(var_651, var_649);
            var_653 = wp::extract(var_0, var_652);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_655 = wp::mul(var_449, var_654);
            var_656 = wp::add(var_655, var_649);
            var_657 = wp::extract(var_0, var_656);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_659 = wp::extract(var_474, var_658);
            var_660 = wp::mul(var_659, var_653);
            var_662 = wp::extract(var_474, var_661);
            var_663 = wp::mul(var_662, var_657);
            var_664 = wp::sub(var_660, var_663);
            var_666 = wp::mul(var_437, var_665);
            var_667 = wp::add(var_666, var_649);
            wp::assign_inplace(var_0, var_667, var_664);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_669 = wp::extract(var_474, var_668);
            var_670 = wp::mul(var_669, var_653);
            var_672 = wp::extract(var_474, var_671);
            var_673 = wp::mul(var_672, var_657);
            var_674 = wp::add(var_670, var_673);
            var_676 = wp::mul(var_449, var_675);
            var_677 = wp::add(var_676, var_649);
            wp::assign_inplace(var_0, var_677, var_674);
            // apk = a[p * 4 + k]                                                             <L 27>
            var_680 = wp::mul(var_437, var_679);
            var_681 = wp::add(var_680, var_678);
            var_682 = wp::extract(var_0, var_681);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_684 = wp::mul(var_449, var_683);
            var_685 = wp::add(var_684, var_678);
            var_686 = wp::extract(var_0, var_685);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_688 = wp::extract(var_474, var_687);
            var_689 = wp::mul(var_688, var_682);
            var_691 = wp::extract(var_474, var_690);
            var_692 = wp::mul(var_691, var_686);
            var_693 = wp::sub(var_689, var_692);
            var_695 = wp::mul(var_437, var_694);
            var_696 = wp::add(var_695, var_678);
            wp::assign_inplace(var_0, var_696, var_693);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_698 = wp::extract(var_474, var_697);
            var_699 = wp::mul(var_698, var_682);
            var_701 = wp::extract(var_474, var_700);
            var_702 = wp::mul(var_701, var_686);
            var_703 = wp::add(var_699, var_702);
            var_705 = wp::mul(var_449, var_704);
            var_706 = wp::add(var_705, var_678);
            wp::assign_inplace(var_0, var_706, var_703);
            // for k in range(4):                                                             <L 31>
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_709 = wp::mul(var_707, var_708);
            var_710 = wp::add(var_709, var_437);
            var_711 = wp::extract(var_2, var_710);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_713 = wp::mul(var_707, var_712);
            var_714 = wp::add(var_713, var_449);
            var_715 = wp::extract(var_2, var_714);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_717 = wp::extract(var_474, var_716);
            var_718 = wp::mul(var_717, var_711);
            var_720 = wp::extract(var_474, var_719);
            var_721 = wp::mul(var_720, var_715);
            var_722 = wp::sub(var_718, var_721);
            var_724 = wp::mul(var_707, var_723);
            var_725 = wp::add(var_724, var_437);
            wp::assign_inplace(var_2, var_725, var_722);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_727 = wp::extract(var_474, var_726);
            var_728 = wp::mul(var_727, var_711);
            var_730 = wp::extract(var_474, var_729);
            var_731 = wp::mul(var_730, var_715);
            var_732 = wp::add(var_728, var_731);
            var_734 = wp::mul(var_707, var_733);
            var_735 = wp::add(var_734, var_449);
            wp::assign_inplace(var_2, var_735, var_732);
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_738 = wp::mul(var_736, var_737);
            var_739 = wp::add(var_738, var_437);
            var_740 = wp::extract(var_2, var_739);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_742 = wp::mul(var_736, var_741);
            var_743 = wp::add(var_742, var_449);
            var_744 = wp::extract(var_2, var_743);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_746 = wp::extract(var_474, var_745);
            var_747 = wp::mul(var_746, var_740);
            var_749 = wp::extract(var_474, var_748);
            var_750 = wp::mul(var_749, var_744);
            var_751 = wp::sub(var_747, var_750);
            var_753 = wp::mul(var_736, var_752);
            var_754 = wp::add(var_753, var_437);
            wp::assign_inplace(var_2, var_754, var_751);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_756 = wp::extract(var_474, var_755);
            var_757 = wp::mul(var_756, var_740);
            var_759 = wp::extract(var_474, var_758);
            var_760 = wp::mul(var_759, var_744);
            var_761 = wp::add(var_757, var_760);
            var_763 = wp::mul(var_736, var_762);
            var_764 = wp::add(var_763, var_449);
            wp::assign_inplace(var_2, var_764, var_761);
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_767 = wp::mul(var_765, var_766);
            var_768 = wp::add(var_767, var_437);
            var_769 = wp::extract(var_2, var_768);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_771 = wp::mul(var_765, var_770);
            var_772 = wp::add(var_771, var_449);
            var_773 = wp::extract(var_2, var_772);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_775 = wp::extract(var_474, var_774);
            var_776 = wp::mul(var_775, var_769);
            var_778 = wp::extract(var_474, var_777);
            var_779 = wp::mul(var_778, var_773);
            var_780 = wp::sub(var_776, var_779);
            var_782 = wp::mul(var_765, var_781);
            var_783 = wp::add(var_782, var_437);
            wp::assign_inplace(var_2, var_783, var_780);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_785 = wp::extract(var_474, var_784);
            var_786 = wp::mul(var_785, var_769);
            var_788 = wp::extract(var_474, var_787);
            var_789 = wp::mul(var_788, var_773);
            var_790 = wp::add(var_786, var_789);
            var_792 = wp::mul(var_765, var_791);
            var_793 = wp::add(var_792, var_449);
            wp::assign_inplace(var_2, var_793, var_790);
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_796 = wp::mul(var_794, var_795);
            var_797 = wp::add(var_796, var_437);
            var_798 = wp::extract(var_2, var_797);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_800 = wp::mul(var_794, var_799);
            var_801 = wp::add(var_800, var_449);
            var_802 = wp::extract(var_2, var_801);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_804 = wp::extract(var_474, var_803);
            var_805 = wp::mul(var_804, var_798);
            var_807 = wp::extract(var_474, var_806);
            var_808 = wp::mul(var_807, var_802);
            var_809 = wp::sub(var_805, var_808);
            var_811 = wp::mul(var_794, var_810);
            var_812 = wp::add(var_811, var_437);
            wp::assign_inplace(var_2, var_812, var_809);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_814 = wp::extract(var_474, var_813);
            var_815 = wp::mul(var_814, var_798);
            var_817 = wp::extract(var_474, var_816);
            var_818 = wp::mul(var_817, var_802);
            var_819 = wp::add(var_815, var_818);
            var_821 = wp::mul(var_794, var_820);
            var_822 = wp::add(var_821, var_449);
            wp::assign_inplace(var_2, var_822, var_819);
        }
        var_823 = wp::where(var_462, var_473, var_427);
        var_824 = wp::where(var_462, var_474, var_78);
        var_825 = wp::where(var_462, var_794, var_398);
        var_826 = wp::where(var_462, var_566, var_170);
        var_827 = wp::where(var_462, var_570, var_174);
        var_828 = wp::where(var_462, var_682, var_286);
        var_829 = wp::where(var_462, var_686, var_290);
        var_830 = wp::where(var_462, var_798, var_402);
        var_831 = wp::where(var_462, var_802, var_406);
        // p = 0 if pair < 3 else 1 if pair < 5 else 2                                        <L 13>
        var_834 = (var_832 < var_833);
        if (var_834) {
        }
        if (!var_834) {
            var_837 = (var_832 < var_836);
            if (var_837) {
            }
            if (!var_837) {
            }
            var_840 = wp::where(var_837, var_838, var_839);
        }
        var_841 = wp::where(var_834, var_835, var_840);
        // q = pair + 1 - (0 if pair < 3 else 2 if pair < 5 else 3)                           <L 14>
        var_843 = wp::add(var_832, var_842);
        var_845 = (var_832 < var_844);
        if (var_845) {
        }
        if (!var_845) {
            var_848 = (var_832 < var_847);
            if (var_848) {
            }
            if (!var_848) {
            }
            var_851 = wp::where(var_848, var_849, var_850);
        }
        var_852 = wp::where(var_845, var_846, var_851);
        var_853 = wp::sub(var_843, var_852);
        // apq = a[p * 4 + q]                                                                 <L 15>
        var_855 = wp::mul(var_841, var_854);
        var_856 = wp::add(var_855, var_853);
        var_857 = wp::extract(var_0, var_856);
        // app = a[p * 4 + p]                                                                 <L 16>
        var_859 = wp::mul(var_841, var_858);
        var_860 = wp::add(var_859, var_841);
        var_861 = wp::extract(var_0, var_860);
        // aqq = a[q * 4 + q]                                                                 <L 17>
        var_863 = wp::mul(var_853, var_862);
        var_864 = wp::add(var_863, var_853);
        var_865 = wp::extract(var_0, var_864);
        // if abs(apq) > float64(1e-300) and abs(apq) > float64(1e-18) * sqrt(abs(app * aqq)):       <L 18>
        var_867 = wp::abs(var_857);
        var_868 = 1e-300;
        var_869 = (var_867 > var_868);
        var_866 = var_869;
        if (var_866) {
            var_870 = wp::abs(var_857);
            var_871 = 1e-18;
            var_872 = wp::mul(var_861, var_865);
            var_873 = wp::abs(var_872);
            var_874 = wp::sqrt(var_873);
            var_875 = wp::mul(var_871, var_874);
            var_876 = (var_870 > var_875);
            var_866 = var_866 && var_876;
        }
        if (var_866) {
            // rotated = 1                                                                    <L 19>
            // cs = jacobi_rotation(app, aqq, apq)                                            <L 20>
            var_878 = jacobi_rotation_0(var_861, var_865, var_857);
            // for k in range(4):                                                             <L 21>
            // akp = a[k * 4 + p]                                                             <L 22>
            var_881 = wp::mul(var_879, var_880);
            var_882 = wp::add(var_881, var_841);
            var_883 = wp::extract(var_0, var_882);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_885 = wp::mul(var_879, var_884);
            var_886 = wp::add(var_885, var_853);
            var_887 = wp::extract(var_0, var_886);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_889 = wp::extract(var_878, var_888);
            var_890 = wp::mul(var_889, var_883);
            var_892 = wp::extract(var_878, var_891);
            var_893 = wp::mul(var_892, var_887);
            var_894 = wp::sub(var_890, var_893);
            var_896 = wp::mul(var_879, var_895);
            var_897 = wp::add(var_896, var_841);
            wp::assign_inplace(var_0, var_897, var_894);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_899 = wp::extract(var_878, var_898);
            var_900 = wp::mul(var_899, var_883);
            var_902 = wp::extract(var_878, var_901);
            var_903 = wp::mul(var_902, var_887);
            var_904 = wp::add(var_900, var_903);
            var_906 = wp::mul(var_879, var_905);
            var_907 = wp::add(var_906, var_853);
            wp::assign_inplace(var_0, var_907, var_904);
            // akp = a[k * 4 + p]                                                             <L 22>
            var_910 = wp::mul(var_908, var_909);
            var_911 = wp::add(var_910, var_841);
            var_912 = wp::extract(var_0, var_911);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_914 = wp::mul(var_908, var_913);
            var_915 = wp::add(var_914, var_853);
            var_916 = wp::extract(var_0, var_915);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_918 = wp::extract(var_878, var_917);
            var_919 = wp::mul(var_918, var_912);
            var_921 = wp::extract(var_878, var_920);
            var_922 = wp::mul(var_921, var_916);
            var_923 = wp::sub(var_919, var_922);
            var_925 = wp::mul(var_908, var_924);
            var_926 = wp::add(var_925, var_841);
            wp::assign_inplace(var_0, var_926, var_923);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_928 = wp::extract(var_878, var_927);
            var_929 = wp::mul(var_928, var_912);
            var_931 = wp::extract(var_878, var_930);
            var_932 = wp::mul(var_931, var_916);
            var_933 = wp::add(var_929, var_932);
            var_935 = wp::mul(var_908, var_934);
            var_936 = wp::add(var_935, var_853);
            wp::assign_inplace(var_0, var_936, var_933);
            // akp = a[k * 4 + p]                                                             <L 22>
            var_939 = wp::mul(var_937, var_938);
            var_940 = wp::add(var_939, var_841);
            var_941 = wp::extract(var_0, var_940);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_943 = wp::mul(var_937, var_942);
            var_944 = wp::add(var_943, var_853);
            var_945 = wp::extract(var_0, var_944);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_947 = wp::extract(var_878, var_946);
            var_948 = wp::mul(var_947, var_941);
            var_950 = wp::extract(var_878, var_949);
            var_951 = wp::mul(var_950, var_945);
            var_952 = wp::sub(var_948, var_951);
            var_954 = wp::mul(var_937, var_953);
            var_955 = wp::add(var_954, var_841);
            wp::assign_inplace(var_0, var_955, var_952);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_957 = wp::extract(var_878, var_956);
            var_958 = wp::mul(var_957, var_941);
            var_960 = wp::extract(var_878, var_959);
            var_961 = wp::mul(var_960, var_945);
            var_962 = wp::add(var_958, var_961);
            var_964 = wp::mul(var_937, var_963);
            var_965 = wp::add(var_964, var_853);
            wp::assign_inplace(var_0, var_965, var_962);
            // akp = a[k * 4 + p]                                                             <L 22>
            var_968 = wp::mul(var_966, var_967);
            var_969 = wp::add(var_968, var_841);
            var_970 = wp::extract(var_0, var_969);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_972 = wp::mul(var_966, var_971);
            var_973 = wp::add(var_972, var_853);
            var_974 = wp::extract(var_0, var_973);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_976 = wp::extract(var_878, var_975);
            var_977 = wp::mul(var_976, var_970);
            var_979 = wp::extract(var_878, var_978);
            var_980 = wp::mul(var_979, var_974);
            var_981 = wp::sub(var_977, var_980);
            var_983 = wp::mul(var_966, var_982);
            var_984 = wp::add(var_983, var_841);
            wp::assign_inplace(var_0, var_984, var_981);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_986 = wp::extract(var_878, var_985);
            var_987 = wp::mul(var_986, var_970);
            var_989 = wp::extract(var_878, var_988);
            var_990 = wp::mul(var_989, var_974);
            var_991 = wp::add(var_987, var_990);
            var_993 = wp::mul(var_966, var_992);
            var_994 = wp::add(var_993, var_853);
            wp::assign_inplace(var_0, var_994, var_991);
            // for k in range(4):                                                             <L 26>
            // apk = a[p * 4 + k]                                                             <L 27>
            var_997 = wp::mul(var_841, var_996);
            var_998 = wp::add(var_997, var_995);
            var_999 = wp::extract(var_0, var_998);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_1001 = wp::mul(var_853, var_1000);
            var_1002 = wp::add(var_1001, var_995);
            var_1003 = wp::extract(var_0, var_1002);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_1005 = wp::extract(var_878, var_1004);
            var_1006 = wp::mul(var_1005, var_999);
            var_1008 = wp::extract(var_878, var_1007);
            var_1009 = wp::mul(var_1008, var_1003);
            var_1010 = wp::sub(var_1006, var_1009);
            var_1012 = wp::mul(var_841, var_1011);
            var_1013 = wp::add(var_1012, var_995);
            wp::assign_inplace(var_0, var_1013, var_1010);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_1015 = wp::extract(var_878, var_1014);
            var_1016 = wp::mul(var_1015, var_999);
            var_1018 = wp::extract(var_878, var_1017);
            var_1019 = wp::mul(var_1018, var_1003);
            var_1020 = wp::add(var_1016, var_1019);
            var_1022 = wp::mul(var_853, var_1021);
            var_1023 = wp::add(var_1022, var_995);
            wp::assign_inplace(var_0, var_1023, var_1020);
            // apk = a[p * 4 + k]                                                             <L 27>
            var_1026 = wp::mul(var_841, var_1025);
            var_1027 = wp::add(var_1026, var_1024);
            var_1028 = wp::extract(var_0, var_1027);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_1030 = wp::mul(var_853, var_1029);
            var_1031 = wp::add(var_1030, var_1024);
            var_1032 = wp::extract(var_0, var_1031);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_1034 = wp::extract(var_878, var_1033);
            var_1035 = wp::mul(var_1034, var_1028);
            var_1037 = wp::extract(var_878, var_1036);
            var_1038 = wp::mul(var_1037, var_1032);
            var_1039 = wp::sub(var_1035, var_1038);
            var_1041 = wp::mul(var_841, var_1040);
            var_1042 = wp::add(var_1041, var_1024);
            wp::assign_inplace(var_0, var_1042, var_1039);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_1044 = wp::extract(var_878, var_1043);
            var_1045 = wp::mul(var_1044, var_1028);
            var_1047 = wp::extract(var_878, var_1046);
            var_1048 = wp::mul(var_1047, var_1032);
            var_1049 = wp::add(var_1045, var_1048);
            var_1051 = wp::mul(var_853, var_1050);
            var_1052 = wp::add(var_1051, var_1024);
            wp::assign_inplace(var_0, var_1052, var_1049);
            // apk = a[p * 4 + k]                                                             <L 27>
            var_1055 = wp::mul(var_841, var_1054);
            var_1056 = wp::add(var_1055, var_1053);
            var_1057 = wp::extract(var_0, var_1056);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_1059 = wp::mul(var_853, var_1058);
            var_1060 = wp::add(var_1059, var_1053);
            var_1061 = wp::extract(var_0, var_1060);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_1063 = wp::extract(var_878, var_1062);
            var_1064 = wp::mul(var_1063, var_1057);
            var_1066 = wp::extract(var_878, var_1065);
            var_1067 = wp::mul(var_1066, var_1061);
            var_1068 = wp::sub(var_1064, var_1067);
            var_1070 = wp::mul(var_841, var_1069);
            var_1071 = wp::add(var_1070, var_1053);
            wp::assign_inplace(var_0, var_1071, var_1068);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_1073 = wp::extract(var_878, var_1072);
            var_1074 = wp::mul(var_1073, var_1057);
            var_1076 = wp::extract(var_878, var_1075);
            var_1077 = wp::mul(var_1076, var_1061);
            var_1078 = wp::add(var_1074, var_1077);
            var_1080 = wp::mul(var_853, var_1079);
            var_1081 = wp::add(var_1080, var_1053);
            wp::assign_inplace(var_0, var_1081, var_1078);
            // apk = a[p * 4 + k]                                                             <L 27>
            var_1084 = wp::mul(var_841, var_1083);
            var_1085 = wp::add(var_1084, var_1082);
            var_1086 = wp::extract(var_0, var_1085);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_1088 = wp::mul(var_853, var_1087);
            var_1089 = wp::add(var_1088, var_1082);
            var_1090 = wp::extract(var_0, var_1089);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_1092 = wp::extract(var_878, var_1091);
            var_1093 = wp::mul(var_1092, var_1086);
            var_1095 = wp::extract(var_878, var_1094);
            var_1096 = wp::mul(var_1095, var_1090);
            var_1097 = wp::sub(var_1093, var_1096);
            var_1099 = wp::mul(var_841, var_1098);
            var_1100 = wp::add(var_1099, var_1082);
            wp::assign_inplace(var_0, var_1100, var_1097);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_1102 = wp::extract(var_878, var_1101);
            var_1103 = wp::mul(var_1102, var_1086);
            var_1105 = wp::extract(var_878, var_1104);
            var_1106 = wp::mul(var_1105, var_1090);
            var_1107 = wp::add(var_1103, var_1106);
            var_1109 = wp::mul(var_853, var_1108);
            var_1110 = wp::add(var_1109, var_1082);
            wp::assign_inplace(var_0, var_1110, var_1107);
            // for k in range(4):                                                             <L 31>
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_1113 = wp::mul(var_1111, var_1112);
            var_1114 = wp::add(var_1113, var_841);
            var_1115 = wp::extract(var_2, var_1114);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_1117 = wp::mul(var_1111, var_1116);
            var_1118 = wp::add(var_1117, var_853);
            var_1119 = wp::extract(var_2, var_1118);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_1121 = wp::extract(var_878, var_1120);
            var_1122 = wp::mul(var_1121, var_1115);
            var_1124 = wp::extract(var_878, var_1123);
            var_1125 = wp::mul(var_1124, var_1119);
            var_1126 = wp::sub(var_1122, var_1125);
            var_1128 = wp::mul(var_1111, var_1127);
            var_1129 = wp::add(var_1128, var_841);
            wp::assign_inplace(var_2, var_1129, var_1126);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_1131 = wp::extract(var_878, var_1130);
            var_1132 = wp::mul(var_1131, var_1115);
            var_1134 = wp::extract(var_878, var_1133);
            var_1135 = wp::mul(var_1134, var_1119);
            var_1136 = wp::add(var_1132, var_1135);
            var_1138 = wp::mul(var_1111, var_1137);
            var_1139 = wp::add(var_1138, var_853);
            wp::assign_inplace(var_2, var_1139, var_1136);
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_1142 = wp::mul(var_1140, var_1141);
            var_1143 = wp::add(var_1142, var_841);
            var_1144 = wp::extract(var_2, var_1143);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_1146 = wp::mul(var_1140, var_1145);
            var_1147 = wp::add(var_1146, var_853);
            var_1148 = wp::extract(var_2, var_1147);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_1150 = wp::extract(var_878, var_1149);
            var_1151 = wp::mul(var_1150, var_1144);
            var_1153 = wp::extract(var_878, var_1152);
            var_1154 = wp::mul(var_1153, var_1148);
            var_1155 = wp::sub(var_1151, var_1154);
            var_1157 = wp::mul(var_1140, var_1156);
            var_1158 = wp::add(var_1157, var_841);
            wp::assign_inplace(var_2, var_1158, var_1155);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_1160 = wp::extract(var_878, var_1159);
            var_1161 = wp::mul(var_1160, var_1144);
            var_1163 = wp::extract(var_878, var_1162);
            var_1164 = wp::mul(var_1163, var_1148);
            var_1165 = wp::add(var_1161, var_1164);
            var_1167 = wp::mul(var_1140, var_1166);
            var_1168 = wp::add(var_1167, var_853);
            wp::assign_inplace(var_2, var_1168, var_1165);
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_1171 = wp::mul(var_1169, var_1170);
            var_1172 = wp::add(var_1171, var_841);
            var_1173 = wp::extract(var_2, var_1172);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_1175 = wp::mul(var_1169, var_1174);
            var_1176 = wp::add(var_1175, var_853);
            var_1177 = wp::extract(var_2, var_1176);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_1179 = wp::extract(var_878, var_1178);
            var_1180 = wp::mul(var_1179, var_1173);
            var_1182 = wp::extract(var_878, var_1181);
            var_1183 = wp::mul(var_1182, var_1177);
            var_1184 = wp::sub(var_1180, var_1183);
            var_1186 = wp::mul(var_1169, var_1185);
            var_1187 = wp::add(var_1186, var_841);
            wp::assign_inplace(var_2, var_1187, var_1184);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_1189 = wp::extract(var_878, var_1188);
            var_1190 = wp::mul(var_1189, var_1173);
            var_1192 = wp::extract(var_878, var_1191);
            var_1193 = wp::mul(var_1192, var_1177);
            var_1194 = wp::add(var_1190, var_1193);
            var_1196 = wp::mul(var_1169, var_1195);
            var_1197 = wp::add(var_1196, var_853);
            wp::assign_inplace(var_2, var_1197, var_1194);
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_1200 = wp::mul(var_1198, var_1199);
            var_1201 = wp::add(var_1200, var_841);
            var_1202 = wp::extract(var_2, var_1201);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_1204 = wp::mul(var_1198, var_1203);
            var_1205 = wp::add(var_1204, var_853);
            var_1206 = wp::extract(var_2, var_1205);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_1208 = wp::extract(var_878, var_1207);
            var_1209 = wp::mul(var_1208, var_1202);
            var_1211 = wp::extract(var_878, var_1210);
            var_1212 = wp::mul(var_1211, var_1206);
            var_1213 = wp::sub(var_1209, var_1212);
            var_1215 = wp::mul(var_1198, var_1214);
            var_1216 = wp::add(var_1215, var_841);
            wp::assign_inplace(var_2, var_1216, var_1213);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_1218 = wp::extract(var_878, var_1217);
            var_1219 = wp::mul(var_1218, var_1202);
            var_1221 = wp::extract(var_878, var_1220);
            var_1222 = wp::mul(var_1221, var_1206);
            var_1223 = wp::add(var_1219, var_1222);
            var_1225 = wp::mul(var_1198, var_1224);
            var_1226 = wp::add(var_1225, var_853);
            wp::assign_inplace(var_2, var_1226, var_1223);
        }
        var_1227 = wp::where(var_866, var_877, var_823);
        var_1228 = wp::where(var_866, var_878, var_824);
        var_1229 = wp::where(var_866, var_1198, var_825);
        var_1230 = wp::where(var_866, var_970, var_826);
        var_1231 = wp::where(var_866, var_974, var_827);
        var_1232 = wp::where(var_866, var_1086, var_828);
        var_1233 = wp::where(var_866, var_1090, var_829);
        var_1234 = wp::where(var_866, var_1202, var_830);
        var_1235 = wp::where(var_866, var_1206, var_831);
        // p = 0 if pair < 3 else 1 if pair < 5 else 2                                        <L 13>
        var_1238 = (var_1236 < var_1237);
        if (var_1238) {
        }
        if (!var_1238) {
            var_1241 = (var_1236 < var_1240);
            if (var_1241) {
            }
            if (!var_1241) {
            }
            var_1244 = wp::where(var_1241, var_1242, var_1243);
        }
        var_1245 = wp::where(var_1238, var_1239, var_1244);
        // q = pair + 1 - (0 if pair < 3 else 2 if pair < 5 else 3)                           <L 14>
        var_1247 = wp::add(var_1236, var_1246);
        var_1249 = (var_1236 < var_1248);
        if (var_1249) {
        }
        if (!var_1249) {
            var_1252 = (var_1236 < var_1251);
            if (var_1252) {
            }
            if (!var_1252) {
            }
            var_1255 = wp::where(var_1252, var_1253, var_1254);
        }
        var_1256 = wp::where(var_1249, var_1250, var_1255);
        var_1257 = wp::sub(var_1247, var_1256);
        // apq = a[p * 4 + q]                                                                 <L 15>
        var_1259 = wp::mul(var_1245, var_1258);
        var_1260 = wp::add(var_1259, var_1257);
        var_1261 = wp::extract(var_0, var_1260);
        // app = a[p * 4 + p]                                                                 <L 16>
        var_1263 = wp::mul(var_1245, var_1262);
        var_1264 = wp::add(var_1263, var_1245);
        var_1265 = wp::extract(var_0, var_1264);
        // aqq = a[q * 4 + q]                                                                 <L 17>
        var_1267 = wp::mul(var_1257, var_1266);
        var_1268 = wp::add(var_1267, var_1257);
        var_1269 = wp::extract(var_0, var_1268);
        // if abs(apq) > float64(1e-300) and abs(apq) > float64(1e-18) * sqrt(abs(app * aqq)):       <L 18>
        var_1271 = wp::abs(var_1261);
        var_1272 = 1e-300;
        var_1273 = (var_1271 > var_1272);
        var_1270 = var_1273;
        if (var_1270) {
            var_1274 = wp::abs(var_1261);
            var_1275 = 1e-18;
            var_1276 = wp::mul(var_1265, var_1269);
            var_1277 = wp::abs(var_1276);
            var_1278 = wp::sqrt(var_1277);
            var_1279 = wp::mul(var_1275, var_1278);
            var_1280 = (var_1274 > var_1279);
            var_1270 = var_1270 && var_1280;
        }
        if (var_1270) {
            // rotated = 1                                                                    <L 19>
            // cs = jacobi_rotation(app, aqq, apq)                                            <L 20>
            var_1282 = jacobi_rotation_0(var_1265, var_1269, var_1261);
            // for k in range(4):                                                             <L 21>
            // akp = a[k * 4 + p]                                                             <L 22>
            var_1285 = wp::mul(var_1283, var_1284);
            var_1286 = wp::add(var_1285, var_1245);
            var_1287 = wp::extract(var_0, var_1286);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_1289 = wp::mul(var_1283, var_1288);
            var_1290 = wp::add(var_1289, var_1257);
            var_1291 = wp::extract(var_0, var_1290);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_1293 = wp::extract(var_1282, var_1292);
            var_1294 = wp::mul(var_1293, var_1287);
            var_1296 = wp::extract(var_1282, var_1295);
            var_1297 = wp::mul(var_1296, var_1291);
            var_1298 = wp::sub(var_1294, var_1297);
            var_1300 = wp::mul(var_1283, var_1299);
            var_1301 = wp::add(var_1300, var_1245);
            wp::assign_inplace(var_0, var_1301, var_1298);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_1303 = wp::extract(var_1282, var_1302);
            var_1304 = wp::mul(var_1303, var_1287);
            var_1306 = wp::extract(var_1282, var_1305);
            var_1307 = wp::mul(var_1306, var_1291);
            var_1308 = wp::add(var_1304, var_1307);
            var_1310 = wp::mul(var_1283, var_1309);
            var_1311 = wp::add(var_1310, var_1257);
            wp::assign_inplace(var_0, var_1311, var_1308);
            // akp = a[k * 4 + p]                                                             <L 22>
            var_1314 = wp::mul(var_1312, var_1313);
            var_1315 = wp::add(var_1314, var_1245);
            var_1316 = wp::extract(var_0, var_1315);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_1318 = wp::mul(var_1312, var_1317);
            var_1319 = wp::add(var_1318, var_1257);
            var_1320 = wp::extract(var_0, var_1319);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_1322 = wp::extract(var_1282, var_1321);
            var_1323 = wp::mul(var_1322, var_1316);
            var_1325 = wp::extract(var_1282, var_1324);
            var_1326 = wp::mul(var_1325, var_1320);
            var_1327 = wp::sub(var_1323, var_1326);
            var_1329 = wp::mul(var_1312, var_1328);
            var_1330 = wp::add(var_1329, var_1245);
            wp::assign_inplace(var_0, var_1330, var_1327);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_1332 = wp::extract(var_1282, var_1331);
            var_1333 = wp::mul(var_1332, var_1316);
            var_1335 = wp::extract(var_1282, var_1334);
            var_1336 = wp::mul(var_1335, var_1320);
            var_1337 = wp::add(var_1333, var_1336);
            var_1339 = wp::mul(var_1312, var_1338);
            var_1340 = wp::add(var_1339, var_1257);
            wp::assign_inplace(var_0, var_1340, var_1337);
            // akp = a[k * 4 + p]                                                             <L 22>
            var_1343 = wp::mul(var_1341, var_1342);
            var_1344 = wp::add(var_1343, var_1245);
            var_1345 = wp::extract(var_0, var_1344);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_1347 = wp::mul(var_1341, var_1346);
            var_1348 = wp::add(var_1347, var_1257);
            var_1349 = wp::extract(var_0, var_1348);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_1351 = wp::extract(var_1282, var_1350);
            var_1352 = wp::mul(var_1351, var_1345);
            var_1354 = wp::extract(var_1282, var_1353);
            var_1355 = wp::mul(var_1354, var_1349);
            var_1356 = wp::sub(var_1352, var_1355);
            var_1358 = wp::mul(var_1341, var_1357);
            var_1359 = wp::add(var_1358, var_1245);
            wp::assign_inplace(var_0, var_1359, var_1356);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_1361 = wp::extract(var_1282, var_1360);
            var_1362 = wp::mul(var_1361, var_1345);
            var_1364 = wp::extract(var_1282, var_1363);
            var_1365 = wp::mul(var_1364, var_1349);
            var_1366 = wp::add(var_1362, var_1365);
            var_1368 = wp::mul(var_1341, var_1367);
            var_1369 = wp::add(var_1368, var_1257);
            wp::assign_inplace(var_0, var_1369, var_1366);
            // akp = a[k * 4 + p]                                                             <L 22>
            var_1372 = wp::mul(var_1370, var_1371);
            var_1373 = wp::add(var_1372, var_1245);
            var_1374 = wp::extract(var_0, var_1373);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_1376 = wp::mul(var_1370, var_1375);
            var_1377 = wp::add(var_1376, var_1257);
            var_1378 = wp::extract(var_0, var_1377);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_1380 = wp::extract(var_1282, var_1379);
            var_1381 = wp::mul(var_1380, var_1374);
            var_1383 = wp::extract(var_1282, var_1382);
            var_1384 = wp::mul(var_1383, var_1378);
            var_1385 = wp::sub(var_1381, var_1384);
            var_1387 = wp::mul(var_1370, var_1386);
            var_1388 = wp::add(var_1387, var_1245);
            wp::assign_inplace(var_0, var_1388, var_1385);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_1390 = wp::extract(var_1282, var_1389);
            var_1391 = wp::mul(var_1390, var_1374);
            var_1393 = wp::extract(var_1282, var_1392);
            var_1394 = wp::mul(var_1393, var_1378);
            var_1395 = wp::add(var_1391, var_1394);
            var_1397 = wp::mul(var_1370, var_1396);
            var_1398 = wp::add(var_1397, var_1257);
            wp::assign_inplace(var_0, var_1398, var_1395);
            // for k in range(4):                                                             <L 26>
            // apk = a[p * 4 + k]                                                             <L 27>
            var_1401 = wp::mul(var_1245, var_1400);
            var_1402 = wp::add(var_1401, var_1399);
            var_1403 = wp::extract(var_0, var_1402);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_1405 = wp::mul(var_1257, var_1404);
            var_1406 = wp::add(var_1405, var_1399);
            var_1407 = wp::extract(var_0, var_1406);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_1409 = wp::extract(var_1282, var_1408);
            var_1410 = wp::mul(var_1409, var_1403);
            var_1412 = wp::extract(var_1282, var_1411);
            var_1413 = wp::mul(var_1412, var_1407);
            var_1414 = wp::sub(var_1410, var_1413);
            var_1416 = wp::mul(var_1245, var_1415);
            var_1417 = wp::add(var_1416, var_1399);
            wp::assign_inplace(var_0, var_1417, var_1414);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_1419 = wp::extract(var_1282, var_1418);
            var_1420 = wp::mul(var_1419, var_1403);
            var_1422 = wp::extract(var_1282, var_1421);
            var_1423 = wp::mul(var_1422, var_1407);
            var_1424 = wp::add(var_1420, var_1423);
            var_1426 = wp::mul(var_1257, var_1425);
            var_1427 = wp::add(var_1426, var_1399);
            wp::assign_inplace(var_0, var_1427, var_1424);
            // apk = a[p * 4 + k]                                                             <L 27>
            var_1430 = wp::mul(var_1245, var_1429);
            var_1431 = wp::add(var_1430, var_1428);
            var_1432 = wp::extract(var_0, var_1431);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_1434 = wp::mul(var_1257, var_1433);
            var_1435 = wp::add(var_1434, var_1428);
            var_1436 = wp::extract(var_0, var_1435);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_1438 = wp::extract(var_1282, var_1437);
            var_1439 = wp::mul(var_1438, var_1432);
            var_1441 = wp::extract(var_1282, var_1440);
            var_1442 = wp::mul(var_1441, var_1436);
            var_1443 = wp::sub(var_1439, var_1442);
            var_1445 = wp::mul(var_1245, var_1444);
            var_1446 = wp::add(var_1445, var_1428);
            wp::assign_inplace(var_0, var_1446, var_1443);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_1448 = wp::extract(var_1282, var_1447);
            var_1449 = wp::mul(var_1448, var_1432);
            var_1451 = wp::extract(var_1282, var_1450);
            var_1452 = wp::mul(var_1451, var_1436);
            var_1453 = wp::add(var_1449, var_1452);
            var_1455 = wp::mul(var_1257, var_1454);
            var_1456 = wp::add(var_1455, var_1428);
            wp::assign_inplace(var_0, var_1456, var_1453);
            // apk = a[p * 4 + k]                                                             <L 27>
            var_1459 = wp::mul(var_1245, var_1458);
            var_1460 = wp::add(var_1459, var_1457);
            var_1461 = wp::extract(var_0, var_1460);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_1463 = wp::mul(var_1257, var_1462);
            var_1464 = wp::add(var_1463, var_1457);
            var_1465 = wp::extract(var_0, var_1464);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_1467 = wp::extract(var_1282, var_1466);
            var_1468 = wp::mul(var_1467, var_1461);
            var_1470 = wp::extract(var_1282, var_1469);
            var_1471 = wp::mul(var_1470, var_1465);
            var_1472 = wp::sub(var_1468, var_1471);
            var_1474 = wp::mul(var_1245, var_1473);
            var_1475 = wp::add(var_1474, var_1457);
            wp::assign_inplace(var_0, var_1475, var_1472);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_1477 = wp::extract(var_1282, var_1476);
            var_1478 = wp::mul(var_1477, var_1461);
            var_1480 = wp::extract(var_1282, var_1479);
            var_1481 = wp::mul(var_1480, var_1465);
            var_1482 = wp::add(var_1478, var_1481);
            var_1484 = wp::mul(var_1257, var_1483);
            var_1485 = wp::add(var_1484, var_1457);
            wp::assign_inplace(var_0, var_1485, var_1482);
            // apk = a[p * 4 + k]                                                             <L 27>
            var_1488 = wp::mul(var_1245, var_1487);
            var_1489 = wp::add(var_1488, var_1486);
            var_1490 = wp::extract(var_0, var_1489);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_1492 = wp::mul(var_1257, var_1491);
            var_1493 = wp::add(var_1492, var_1486);
            var_1494 = wp::extract(var_0, var_1493);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_1496 = wp::extract(var_1282, var_1495);
            var_1497 = wp::mul(var_1496, var_1490);
            var_1499 = wp::extract(var_1282, var_1498);
            var_1500 = wp::mul(var_1499, var_1494);
            var_1501 = wp::sub(var_1497, var_1500);
            var_1503 = wp::mul(var_1245, var_1502);
            var_1504 = wp::add(var_1503, var_1486);
            wp::assign_inplace(var_0, var_1504, var_1501);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_1506 = wp::extract(var_1282, var_1505);
            var_1507 = wp::mul(var_1506, var_1490);
            var_1509 = wp::extract(var_1282, var_1508);
            var_1510 = wp::mul(var_1509, var_1494);
            var_1511 = wp::add(var_1507, var_1510);
            var_1513 = wp::mul(var_1257, var_1512);
            var_1514 = wp::add(var_1513, var_1486);
            wp::assign_inplace(var_0, var_1514, var_1511);
            // for k in range(4):                                                             <L 31>
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_1517 = wp::mul(var_1515, var_1516);
            var_1518 = wp::add(var_1517, var_1245);
            var_1519 = wp::extract(var_2, var_1518);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_1521 = wp::mul(var_1515, var_1520);
            var_1522 = wp::add(var_1521, var_1257);
            var_1523 = wp::extract(var_2, var_1522);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_1525 = wp::extract(var_1282, var_1524);
            var_1526 = wp::mul(var_1525, var_1519);
            var_1528 = wp::extract(var_1282, var_1527);
            var_1529 = wp::mul(var_1528, var_1523);
            var_1530 = wp::sub(var_1526, var_1529);
            var_1532 = wp::mul(var_1515, var_1531);
            var_1533 = wp::add(var_1532, var_1245);
            wp::assign_inplace(var_2, var_1533, var_1530);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_1535 = wp::extract(var_1282, var_1534);
            var_1536 = wp::mul(var_1535, var_1519);
            var_1538 = wp::extract(var_1282, var_1537);
            var_1539 = wp::mul(var_1538, var_1523);
            var_1540 = wp::add(var_1536, var_1539);
            var_1542 = wp::mul(var_1515, var_1541);
            var_1543 = wp::add(var_1542, var_1257);
            wp::assign_inplace(var_2, var_1543, var_1540);
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_1546 = wp::mul(var_1544, var_1545);
            var_1547 = wp::add(var_1546, var_1245);
            var_1548 = wp::extract(var_2, var_1547);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_1550 = wp::mul(var_1544, var_1549);
            var_1551 = wp::add(var_1550, var_1257);
            var_1552 = wp::extract(var_2, var_1551);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_1554 = wp::extract(var_1282, var_1553);
            var_1555 = wp::mul(var_1554, var_1548);
            var_1557 = wp::extract(var_1282, var_1556);
            var_1558 = wp::mul(var_1557, var_1552);
            var_1559 = wp::sub(var_1555, var_1558);
            var_1561 = wp::mul(var_1544, var_1560);
            var_1562 = wp::add(var_1561, var_1245);
            wp::assign_inplace(var_2, var_1562, var_1559);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_1564 = wp::extract(var_1282, var_1563);
            var_1565 = wp::mul(var_1564, var_1548);
            var_1567 = wp::extract(var_1282, var_1566);
            var_1568 = wp::mul(var_1567, var_1552);
            var_1569 = wp::add(var_1565, var_1568);
            var_1571 = wp::mul(var_1544, var_1570);
            var_1572 = wp::add(var_1571, var_1257);
            wp::assign_inplace(var_2, var_1572, var_1569);
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_1575 = wp::mul(var_1573, var_1574);
            var_1576 = wp::add(var_1575, var_1245);
            var_1577 = wp::extract(var_2, var_1576);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_1579 = wp::mul(var_1573, var_1578);
            var_1580 = wp::add(var_1579, var_1257);
            var_1581 = wp::extract(var_2, var_1580);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_1583 = wp::extract(var_1282, var_1582);
            var_1584 = wp::mul(var_1583, var_1577);
            var_1586 = wp::extract(var_1282, var_1585);
            var_1587 = wp::mul(var_1586, var_1581);
            var_1588 = wp::sub(var_1584, var_1587);
            var_1590 = wp::mul(var_1573, var_1589);
            var_1591 = wp::add(var_1590, var_1245);
            wp::assign_inplace(var_2, var_1591, var_1588);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_1593 = wp::extract(var_1282, var_1592);
            var_1594 = wp::mul(var_1593, var_1577);
            var_1596 = wp::extract(var_1282, var_1595);
            var_1597 = wp::mul(var_1596, var_1581);
            var_1598 = wp::add(var_1594, var_1597);
            var_1600 = wp::mul(var_1573, var_1599);
            var_1601 = wp::add(var_1600, var_1257);
            wp::assign_inplace(var_2, var_1601, var_1598);
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_1604 = wp::mul(var_1602, var_1603);
            var_1605 = wp::add(var_1604, var_1245);
            var_1606 = wp::extract(var_2, var_1605);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_1608 = wp::mul(var_1602, var_1607);
            var_1609 = wp::add(var_1608, var_1257);
            var_1610 = wp::extract(var_2, var_1609);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_1612 = wp::extract(var_1282, var_1611);
            var_1613 = wp::mul(var_1612, var_1606);
            var_1615 = wp::extract(var_1282, var_1614);
            var_1616 = wp::mul(var_1615, var_1610);
            var_1617 = wp::sub(var_1613, var_1616);
            var_1619 = wp::mul(var_1602, var_1618);
            var_1620 = wp::add(var_1619, var_1245);
            wp::assign_inplace(var_2, var_1620, var_1617);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_1622 = wp::extract(var_1282, var_1621);
            var_1623 = wp::mul(var_1622, var_1606);
            var_1625 = wp::extract(var_1282, var_1624);
            var_1626 = wp::mul(var_1625, var_1610);
            var_1627 = wp::add(var_1623, var_1626);
            var_1629 = wp::mul(var_1602, var_1628);
            var_1630 = wp::add(var_1629, var_1257);
            wp::assign_inplace(var_2, var_1630, var_1627);
        }
        var_1631 = wp::where(var_1270, var_1281, var_1227);
        var_1632 = wp::where(var_1270, var_1282, var_1228);
        var_1633 = wp::where(var_1270, var_1602, var_1229);
        var_1634 = wp::where(var_1270, var_1374, var_1230);
        var_1635 = wp::where(var_1270, var_1378, var_1231);
        var_1636 = wp::where(var_1270, var_1490, var_1232);
        var_1637 = wp::where(var_1270, var_1494, var_1233);
        var_1638 = wp::where(var_1270, var_1606, var_1234);
        var_1639 = wp::where(var_1270, var_1610, var_1235);
        // p = 0 if pair < 3 else 1 if pair < 5 else 2                                        <L 13>
        var_1642 = (var_1640 < var_1641);
        if (var_1642) {
        }
        if (!var_1642) {
            var_1645 = (var_1640 < var_1644);
            if (var_1645) {
            }
            if (!var_1645) {
            }
            var_1648 = wp::where(var_1645, var_1646, var_1647);
        }
        var_1649 = wp::where(var_1642, var_1643, var_1648);
        // q = pair + 1 - (0 if pair < 3 else 2 if pair < 5 else 3)                           <L 14>
        var_1651 = wp::add(var_1640, var_1650);
        var_1653 = (var_1640 < var_1652);
        if (var_1653) {
        }
        if (!var_1653) {
            var_1656 = (var_1640 < var_1655);
            if (var_1656) {
            }
            if (!var_1656) {
            }
            var_1659 = wp::where(var_1656, var_1657, var_1658);
        }
        var_1660 = wp::where(var_1653, var_1654, var_1659);
        var_1661 = wp::sub(var_1651, var_1660);
        // apq = a[p * 4 + q]                                                                 <L 15>
        var_1663 = wp::mul(var_1649, var_1662);
        var_1664 = wp::add(var_1663, var_1661);
        var_1665 = wp::extract(var_0, var_1664);
        // app = a[p * 4 + p]                                                                 <L 16>
        var_1667 = wp::mul(var_1649, var_1666);
        var_1668 = wp::add(var_1667, var_1649);
        var_1669 = wp::extract(var_0, var_1668);
        // aqq = a[q * 4 + q]                                                                 <L 17>
        var_1671 = wp::mul(var_1661, var_1670);
        var_1672 = wp::add(var_1671, var_1661);
        var_1673 = wp::extract(var_0, var_1672);
        // if abs(apq) > float64(1e-300) and abs(apq) > float64(1e-18) * sqrt(abs(app * aqq)):       <L 18>
        var_1675 = wp::abs(var_1665);
        var_1676 = 1e-300;
        var_1677 = (var_1675 > var_1676);
        var_1674 = var_1677;
        if (var_1674) {
            var_1678 = wp::abs(var_1665);
            var_1679 = 1e-18;
            var_1680 = wp::mul(var_1669, var_1673);
            var_1681 = wp::abs(var_1680);
            var_1682 = wp::sqrt(var_1681);
            var_1683 = wp::mul(var_1679, var_1682);
            var_1684 = (var_1678 > var_1683);
            var_1674 = var_1674 && var_1684;
        }
        if (var_1674) {
            // rotated = 1                                                                    <L 19>
            // cs = jacobi_rotation(app, aqq, apq)                                            <L 20>
            var_1686 = jacobi_rotation_0(var_1669, var_1673, var_1665);
            // for k in range(4):                                                             <L 21>
            // akp = a[k * 4 + p]                                                             <L 22>
            var_1689 = wp::mul(var_1687, var_1688);
            var_1690 = wp::add(var_1689, var_1649);
            var_1691 = wp::extract(var_0, var_1690);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_1693 = wp::mul(var_1687, var_1692);
            var_1694 = wp::add(var_1693, var_1661);
            var_1695 = wp::extract(var_0, var_1694);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_1697 = wp::extract(var_1686, var_1696);
            var_1698 = wp::mul(var_1697, var_1691);
            var_1700 = wp::extract(var_1686, var_1699);
            var_1701 = wp::mul(var_1700, var_1695);
            var_1702 = wp::sub(var_1698, var_1701);
            var_1704 = wp::mul(var_1687, var_1703);
            var_1705 = wp::add(var_1704, var_1649);
            wp::assign_inplace(var_0, var_1705, var_1702);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_1707 = wp::extract(var_1686, var_1706);
            var_1708 = wp::mul(var_1707, var_1691);
            var_1710 = wp::extract(var_1686, var_1709);
            var_1711 = wp::mul(var_1710, var_1695);
            var_1712 = wp::add(var_1708, var_1711);
            var_1714 = wp::mul(var_1687, var_1713);
            var_1715 = wp::add(var_1714, var_1661);
            wp::assign_inplace(var_0, var_1715, var_1712);
            // akp = a[k * 4 + p]                                                             <L 22>
            var_1718 = wp::mul(var_1716, var_1717);
            var_1719 = wp::add(var_1718, var_1649);
            var_1720 = wp::extract(var_0, var_1719);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_1722 = wp::mul(var_1716, var_1721);
            var_1723 = wp::add(var_1722, var_1661);
            var_1724 = wp::extract(var_0, var_1723);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_1726 = wp::extract(var_1686, var_1725);
            var_1727 = wp::mul(var_1726, var_1720);
            var_1729 = wp::extract(var_1686, var_1728);
            var_1730 = wp::mul(var_1729, var_1724);
            var_1731 = wp::sub(var_1727, var_1730);
            var_1733 = wp::mul(var_1716, var_1732);
            var_1734 = wp::add(var_1733, var_1649);
            wp::assign_inplace(var_0, var_1734, var_1731);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_1736 = wp::extract(var_1686, var_1735);
            var_1737 = wp::mul(var_1736, var_1720);
            var_1739 = wp::extract(var_1686, var_1738);
            var_1740 = wp::mul(var_1739, var_1724);
            var_1741 = wp::add(var_1737, var_1740);
            var_1743 = wp::mul(var_1716, var_1742);
            var_1744 = wp::add(var_1743, var_1661);
            wp::assign_inplace(var_0, var_1744, var_1741);
            // akp = a[k * 4 + p]                                                             <L 22>
            var_1747 = wp::mul(var_1745, var_1746);
            var_1748 = wp::add(var_1747, var_1649);
            var_1749 = wp::extract(var_0, var_1748);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_1751 = wp::mul(var_1745, var_1750);
            var_1752 = wp::add(var_1751, var_1661);
            var_1753 = wp::extract(var_0, var_1752);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_1755 = wp::extract(var_1686, var_1754);
            var_1756 = wp::mul(var_1755, var_1749);
            var_1758 = wp::extract(var_1686, var_1757);
            var_1759 = wp::mul(var_1758, var_1753);
            var_1760 = wp::sub(var_1756, var_1759);
            var_1762 = wp::mul(var_1745, var_1761);
            var_1763 = wp::add(var_1762, var_1649);
            wp::assign_inplace(var_0, var_1763, var_1760);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_1765 = wp::extract(var_1686, var_1764);
            var_1766 = wp::mul(var_1765, var_1749);
            var_1768 = wp::extract(var_1686, var_1767);
            var_1769 = wp::mul(var_1768, var_1753);
            var_1770 = wp::add(var_1766, var_1769);
            var_1772 = wp::mul(var_1745, var_1771);
            var_1773 = wp::add(var_1772, var_1661);
            wp::assign_inplace(var_0, var_1773, var_1770);
            // akp = a[k * 4 + p]                                                             <L 22>
            var_1776 = wp::mul(var_1774, var_1775);
            var_1777 = wp::add(var_1776, var_1649);
            var_1778 = wp::extract(var_0, var_1777);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_1780 = wp::mul(var_1774, var_1779);
            var_1781 = wp::add(var_1780, var_1661);
            var_1782 = wp::extract(var_0, var_1781);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_1784 = wp::extract(var_1686, var_1783);
            var_1785 = wp::mul(var_1784, var_1778);
            var_1787 = wp::extract(var_1686, var_1786);
            var_1788 = wp::mul(var_1787, var_1782);
            var_1789 = wp::sub(var_1785, var_1788);
            var_1791 = wp::mul(var_1774, var_1790);
            var_1792 = wp::add(var_1791, var_1649);
            wp::assign_inplace(var_0, var_1792, var_1789);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_1794 = wp::extract(var_1686, var_1793);
            var_1795 = wp::mul(var_1794, var_1778);
            var_1797 = wp::extract(var_1686, var_1796);
            var_1798 = wp::mul(var_1797, var_1782);
            var_1799 = wp::add(var_1795, var_1798);
            var_1801 = wp::mul(var_1774, var_1800);
            var_1802 = wp::add(var_1801, var_1661);
            wp::assign_inplace(var_0, var_1802, var_1799);
            // for k in range(4):                                                             <L 26>
            // apk = a[p * 4 + k]                                                             <L 27>
            var_1805 = wp::mul(var_1649, var_1804);
            var_1806 = wp::add(var_1805, var_1803);
            var_1807 = wp::extract(var_0, var_1806);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_1809 = wp::mul(var_1661, var_1808);
            var_1810 = wp::add(var_1809, var_1803);
            var_1811 = wp::extract(var_0, var_1810);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_1813 = wp::extract(var_1686, var_1812);
            var_1814 = wp::mul(var_1813, var_1807);
            var_1816 = wp::extract(var_1686, var_1815);
            var_1817 = wp::mul(var_1816, var_1811);
            var_1818 = wp::sub(var_1814, var_1817);
            var_1820 = wp::mul(var_1649, var_1819);
            var_1821 = wp::add(var_1820, var_1803);
            wp::assign_inplace(var_0, var_1821, var_1818);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_1823 = wp::extract(var_1686, var_1822);
            var_1824 = wp::mul(var_1823, var_1807);
            var_1826 = wp::extract(var_1686, var_1825);
            var_1827 = wp::mul(var_1826, var_1811);
            var_1828 = wp::add(var_1824, var_1827);
            var_1830 = wp::mul(var_1661, var_1829);
            var_1831 = wp::add(var_1830, var_1803);
            wp::assign_inplace(var_0, var_1831, var_1828);
            // apk = a[p * 4 + k]                                                             <L 27>
            var_1834 = wp::mul(var_1649, var_1833);
            var_1835 = wp::add(var_1834, var_1832);
            var_1836 = wp::extract(var_0, var_1835);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_1838 = wp::mul(var_1661, var_1837);
            var_1839 = wp::add(var_1838, var_1832);
            var_1840 = wp::extract(var_0, var_1839);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_1842 = wp::extract(var_1686, var_1841);
            var_1843 = wp::mul(var_1842, var_1836);
            var_1845 = wp::extract(var_1686, var_1844);
            var_1846 = wp::mul(var_1845, var_1840);
            var_1847 = wp::sub(var_1843, var_1846);
            var_1849 = wp::mul(var_1649, var_1848);
            var_1850 = wp::add(var_1849, var_1832);
            wp::assign_inplace(var_0, var_1850, var_1847);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_1852 = wp::extract(var_1686, var_1851);
            var_1853 = wp::mul(var_1852, var_1836);
            var_1855 = wp::extract(var_1686, var_1854);
            var_1856 = wp::mul(var_1855, var_1840);
            var_1857 = wp::add(var_1853, var_1856);
            var_1859 = wp::mul(var_1661, var_1858);
            var_1860 = wp::add(var_1859, var_1832);
            wp::assign_inplace(var_0, var_1860, var_1857);
            // apk = a[p * 4 + k]                                                             <L 27>
            var_1863 = wp::mul(var_1649, var_1862);
            var_1864 = wp::add(var_1863, var_1861);
            var_1865 = wp::extract(var_0, var_1864);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_1867 = wp::mul(var_1661, var_1866);
            var_1868 = wp::add(var_1867, var_1861);
            var_1869 = wp::extract(var_0, var_1868);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_1871 = wp::extract(var_1686, var_1870);
            var_1872 = wp::mul(var_1871, var_1865);
            var_1874 = wp::extract(var_1686, var_1873);
            var_1875 = wp::mul(var_1874, var_1869);
            var_1876 = wp::sub(var_1872, var_1875);
            var_1878 = wp::mul(var_1649, var_1877);
            var_1879 = wp::add(var_1878, var_1861);
            wp::assign_inplace(var_0, var_1879, var_1876);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_1881 = wp::extract(var_1686, var_1880);
            var_1882 = wp::mul(var_1881, var_1865);
            var_1884 = wp::extract(var_1686, var_1883);
            var_1885 = wp::mul(var_1884, var_1869);
            var_1886 = wp::add(var_1882, var_1885);
            var_1888 = wp::mul(var_1661, var_1887);
            var_1889 = wp::add(var_1888, var_1861);
            wp::assign_inplace(var_0, var_1889, var_1886);
            // apk = a[p * 4 + k]                                                             <L 27>
            var_1892 = wp::mul(var_1649, var_1891);
            var_1893 = wp::add(var_1892, var_1890);
            var_1894 = wp::extract(var_0, var_1893);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_1896 = wp::mul(var_1661, var_1895);
            var_1897 = wp::add(var_1896, var_1890);
            var_1898 = wp::extract(var_0, var_1897);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_1900 = wp::extract(var_1686, var_1899);
            var_1901 = wp::mul(var_1900, var_1894);
            var_1903 = wp::extract(var_1686, var_1902);
            var_1904 = wp::mul(var_1903, var_1898);
            var_1905 = wp::sub(var_1901, var_1904);
            var_1907 = wp::mul(var_1649, var_1906);
            var_1908 = wp::add(var_1907, var_1890);
            wp::assign_inplace(var_0, var_1908, var_1905);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_1910 = wp::extract(var_1686, var_1909);
            var_1911 = wp::mul(var_1910, var_1894);
            var_1913 = wp::extract(var_1686, var_1912);
            var_1914 = wp::mul(var_1913, var_1898);
            var_1915 = wp::add(var_1911, var_1914);
            var_1917 = wp::mul(var_1661, var_1916);
            var_1918 = wp::add(var_1917, var_1890);
            wp::assign_inplace(var_0, var_1918, var_1915);
            // for k in range(4):                                                             <L 31>
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_1921 = wp::mul(var_1919, var_1920);
            var_1922 = wp::add(var_1921, var_1649);
            var_1923 = wp::extract(var_2, var_1922);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_1925 = wp::mul(var_1919, var_1924);
            var_1926 = wp::add(var_1925, var_1661);
            var_1927 = wp::extract(var_2, var_1926);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_1929 = wp::extract(var_1686, var_1928);
            var_1930 = wp::mul(var_1929, var_1923);
            var_1932 = wp::extract(var_1686, var_1931);
            var_1933 = wp::mul(var_1932, var_1927);
            var_1934 = wp::sub(var_1930, var_1933);
            var_1936 = wp::mul(var_1919, var_1935);
            var_1937 = wp::add(var_1936, var_1649);
            wp::assign_inplace(var_2, var_1937, var_1934);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_1939 = wp::extract(var_1686, var_1938);
            var_1940 = wp::mul(var_1939, var_1923);
            var_1942 = wp::extract(var_1686, var_1941);
            var_1943 = wp::mul(var_1942, var_1927);
            var_1944 = wp::add(var_1940, var_1943);
            var_1946 = wp::mul(var_1919, var_1945);
            var_1947 = wp::add(var_1946, var_1661);
            wp::assign_inplace(var_2, var_1947, var_1944);
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_1950 = wp::mul(var_1948, var_1949);
            var_1951 = wp::add(var_1950, var_1649);
            var_1952 = wp::extract(var_2, var_1951);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_1954 = wp::mul(var_1948, var_1953);
            var_1955 = wp::add(var_1954, var_1661);
            var_1956 = wp::extract(var_2, var_1955);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_1958 = wp::extract(var_1686, var_1957);
            var_1959 = wp::mul(var_1958, var_1952);
            var_1961 = wp::extract(var_1686, var_1960);
            var_1962 = wp::mul(var_1961, var_1956);
            var_1963 = wp::sub(var_1959, var_1962);
            var_1965 = wp::mul(var_1948, var_1964);
            var_1966 = wp::add(var_1965, var_1649);
            wp::assign_inplace(var_2, var_1966, var_1963);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_1968 = wp::extract(var_1686, var_1967);
            var_1969 = wp::mul(var_1968, var_1952);
            var_1971 = wp::extract(var_1686, var_1970);
            var_1972 = wp::mul(var_1971, var_1956);
            var_1973 = wp::add(var_1969, var_1972);
            var_1975 = wp::mul(var_1948, var_1974);
            var_1976 = wp::add(var_1975, var_1661);
            wp::assign_inplace(var_2, var_1976, var_1973);
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_1979 = wp::mul(var_1977, var_1978);
            var_1980 = wp::add(var_1979, var_1649);
            var_1981 = wp::extract(var_2, var_1980);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_1983 = wp::mul(var_1977, var_1982);
            var_1984 = wp::add(var_1983, var_1661);
            var_1985 = wp::extract(var_2, var_1984);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_1987 = wp::extract(var_1686, var_1986);
            var_1988 = wp::mul(var_1987, var_1981);
            var_1990 = wp::extract(var_1686, var_1989);
            var_1991 = wp::mul(var_1990, var_1985);
            var_1992 = wp::sub(var_1988, var_1991);
            var_1994 = wp::mul(var_1977, var_1993);
            var_1995 = wp::add(var_1994, var_1649);
            wp::assign_inplace(var_2, var_1995, var_1992);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_1997 = wp::extract(var_1686, var_1996);
            var_1998 = wp::mul(var_1997, var_1981);
            var_2000 = wp::extract(var_1686, var_1999);
            var_2001 = wp::mul(var_2000, var_1985);
            var_2002 = wp::add(var_1998, var_2001);
            var_2004 = wp::mul(var_1977, var_2003);
            var_2005 = wp::add(var_2004, var_1661);
            wp::assign_inplace(var_2, var_2005, var_2002);
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_2008 = wp::mul(var_2006, var_2007);
            var_2009 = wp::add(var_2008, var_1649);
            var_2010 = wp::extract(var_2, var_2009);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_2012 = wp::mul(var_2006, var_2011);
            var_2013 = wp::add(var_2012, var_1661);
            var_2014 = wp::extract(var_2, var_2013);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_2016 = wp::extract(var_1686, var_2015);
            var_2017 = wp::mul(var_2016, var_2010);
            var_2019 = wp::extract(var_1686, var_2018);
            var_2020 = wp::mul(var_2019, var_2014);
            var_2021 = wp::sub(var_2017, var_2020);
            var_2023 = wp::mul(var_2006, var_2022);
            var_2024 = wp::add(var_2023, var_1649);
            wp::assign_inplace(var_2, var_2024, var_2021);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_2026 = wp::extract(var_1686, var_2025);
            var_2027 = wp::mul(var_2026, var_2010);
            var_2029 = wp::extract(var_1686, var_2028);
            var_2030 = wp::mul(var_2029, var_2014);
            var_2031 = wp::add(var_2027, var_2030);
            var_2033 = wp::mul(var_2006, var_2032);
            var_2034 = wp::add(var_2033, var_1661);
            wp::assign_inplace(var_2, var_2034, var_2031);
        }
        var_2035 = wp::where(var_1674, var_1685, var_1631);
        var_2036 = wp::where(var_1674, var_1686, var_1632);
        var_2037 = wp::where(var_1674, var_2006, var_1633);
        var_2038 = wp::where(var_1674, var_1778, var_1634);
        var_2039 = wp::where(var_1674, var_1782, var_1635);
        var_2040 = wp::where(var_1674, var_1894, var_1636);
        var_2041 = wp::where(var_1674, var_1898, var_1637);
        var_2042 = wp::where(var_1674, var_2010, var_1638);
        var_2043 = wp::where(var_1674, var_2014, var_1639);
        // p = 0 if pair < 3 else 1 if pair < 5 else 2                                        <L 13>
        var_2046 = (var_2044 < var_2045);
        if (var_2046) {
        }
        if (!var_2046) {
            var_2049 = (var_2044 < var_2048);
            if (var_2049) {
            }
            if (!var_2049) {
            }
            var_2052 = wp::where(var_2049, var_2050, var_2051);
        }
        var_2053 = wp::where(var_2046, var_2047, var_2052);
        // q = pair + 1 - (0 if pair < 3 else 2 if pair < 5 else 3)                           <L 14>
        var_2055 = wp::add(var_2044, var_2054);
        var_2057 = (var_2044 < var_2056);
        if (var_2057) {
        }
        if (!var_2057) {
            var_2060 = (var_2044 < var_2059);
            if (var_2060) {
            }
            if (!var_2060) {
            }
            var_2063 = wp::where(var_2060, var_2061, var_2062);
        }
        var_2064 = wp::where(var_2057, var_2058, var_2063);
        var_2065 = wp::sub(var_2055, var_2064);
        // apq = a[p * 4 + q]                                                                 <L 15>
        var_2067 = wp::mul(var_2053, var_2066);
        var_2068 = wp::add(var_2067, var_2065);
        var_2069 = wp::extract(var_0, var_2068);
        // app = a[p * 4 + p]                                                                 <L 16>
        var_2071 = wp::mul(var_2053, var_2070);
        var_2072 = wp::add(var_2071, var_2053);
        var_2073 = wp::extract(var_0, var_2072);
        // aqq = a[q * 4 + q]                                                                 <L 17>
        var_2075 = wp::mul(var_2065, var_2074);
        var_2076 = wp::add(var_2075, var_2065);
        var_2077 = wp::extract(var_0, var_2076);
        // if abs(apq) > float64(1e-300) and abs(apq) > float64(1e-18) * sqrt(abs(app * aqq)):       <L 18>
        var_2079 = wp::abs(var_2069);
        var_2080 = 1e-300;
        var_2081 = (var_2079 > var_2080);
        var_2078 = var_2081;
        if (var_2078) {
            var_2082 = wp::abs(var_2069);
            var_2083 = 1e-18;
            var_2084 = wp::mul(var_2073, var_2077);
            var_2085 = wp::abs(var_2084);
            var_2086 = wp::sqrt(var_2085);
            var_2087 = wp::mul(var_2083, var_2086);
            var_2088 = (var_2082 > var_2087);
            var_2078 = var_2078 && var_2088;
        }
        if (var_2078) {
            // rotated = 1                                                                    <L 19>
            // cs = jacobi_rotation(app, aqq, apq)                                            <L 20>
            var_2090 = jacobi_rotation_0(var_2073, var_2077, var_2069);
            // for k in range(4):                                                             <L 21>
            // akp = a[k * 4 + p]                                                             <L 22>
            var_2093 = wp::mul(var_2091, var_2092);
            var_2094 = wp::add(var_2093, var_2053);
            var_2095 = wp::extract(var_0, var_2094);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_2097 = wp::mul(var_2091, var_2096);
            var_2098 = wp::add(var_2097, var_2065);
            var_2099 = wp::extract(var_0, var_2098);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_2101 = wp::extract(var_2090, var_2100);
            var_2102 = wp::mul(var_2101, var_2095);
            var_2104 = wp::extract(var_2090, var_2103);
            var_2105 = wp::mul(var_2104, var_2099);
            var_2106 = wp::sub(var_2102, var_2105);
            var_2108 = wp::mul(var_2091, var_2107);
            var_2109 = wp::add(var_2108, var_2053);
            wp::assign_inplace(var_0, var_2109, var_2106);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_2111 = wp::extract(var_2090, var_2110);
            var_2112 = wp::mul(var_2111, var_2095);
            var_2114 = wp::extract(var_2090, var_2113);
            var_2115 = wp::mul(var_2114, var_2099);
            var_2116 = wp::add(var_2112, var_2115);
            var_2118 = wp::mul(var_2091, var_2117);
            var_2119 = wp::add(var_2118, var_2065);
            wp::assign_inplace(var_0, var_2119, var_2116);
            // akp = a[k * 4 + p]                                                             <L 22>
            var_2122 = wp::mul(var_2120, var_2121);
            var_2123 = wp::add(var_2122, var_2053);
            var_2124 = wp::extract(var_0, var_2123);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_2126 = wp::mul(var_2120, var_2125);
            var_2127 = wp::add(var_2126, var_2065);
            var_2128 = wp::extract(var_0, var_2127);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_2130 = wp::extract(var_2090, var_2129);
            var_2131 = wp::mul(var_2130, var_2124);
            var_2133 = wp::extract(var_2090, var_2132);
            var_2134 = wp::mul(var_2133, var_2128);
            var_2135 = wp::sub(var_2131, var_2134);
            var_2137 = wp::mul(var_2120, var_2136);
            var_2138 = wp::add(var_2137, var_2053);
            wp::assign_inplace(var_0, var_2138, var_2135);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_2140 = wp::extract(var_2090, var_2139);
            var_2141 = wp::mul(var_2140, var_2124);
            var_2143 = wp::extract(var_2090, var_2142);
            var_2144 = wp::mul(var_2143, var_2128);
            var_2145 = wp::add(var_2141, var_2144);
            var_2147 = wp::mul(var_2120, var_2146);
            var_2148 = wp::add(var_2147, var_2065);
            wp::assign_inplace(var_0, var_2148, var_2145);
            // akp = a[k * 4 + p]                                                             <L 22>
            var_2151 = wp::mul(var_2149, var_2150);
            var_2152 = wp::add(var_2151, var_2053);
            var_2153 = wp::extract(var_0, var_2152);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_2155 = wp::mul(var_2149, var_2154);
            var_2156 = wp::add(var_2155, var_2065);
            var_2157 = wp::extract(var_0, var_2156);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_2159 = wp::extract(var_2090, var_2158);
            var_2160 = wp::mul(var_2159, var_2153);
            var_2162 = wp::extract(var_2090, var_2161);
            var_2163 = wp::mul(var_2162, var_2157);
            var_2164 = wp::sub(var_2160, var_2163);
            var_2166 = wp::mul(var_2149, var_2165);
            var_2167 = wp::add(var_2166, var_2053);
            wp::assign_inplace(var_0, var_2167, var_2164);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_2169 = wp::extract(var_2090, var_2168);
            var_2170 = wp::mul(var_2169, var_2153);
            var_2172 = wp::extract(var_2090, var_2171);
            var_2173 = wp::mul(var_2172, var_2157);
            var_2174 = wp::add(var_2170, var_2173);
            var_2176 = wp::mul(var_2149, var_2175);
            var_2177 = wp::add(var_2176, var_2065);
            wp::assign_inplace(var_0, var_2177, var_2174);
            // akp = a[k * 4 + p]                                                             <L 22>
            var_2180 = wp::mul(var_2178, var_2179);
            var_2181 = wp::add(var_2180, var_2053);
            var_2182 = wp::extract(var_0, var_2181);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_2184 = wp::mul(var_2178, var_2183);
            var_2185 = wp::add(var_2184, var_2065);
            var_2186 = wp::extract(var_0, var_2185);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_2188 = wp::extract(var_2090, var_2187);
            var_2189 = wp::mul(var_2188, var_2182);
            var_2191 = wp::extract(var_2090, var_2190);
            var_2192 = wp::mul(var_2191, var_2186);
            var_2193 = wp::sub(var_2189, var_2192);
            var_2195 = wp::mul(var_2178, var_2194);
            var_2196 = wp::add(var_2195, var_2053);
            wp::assign_inplace(var_0, var_2196, var_2193);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_2198 = wp::extract(var_2090, var_2197);
            var_2199 = wp::mul(var_2198, var_2182);
            var_2201 = wp::extract(var_2090, var_2200);
            var_2202 = wp::mul(var_2201, var_2186);
            var_2203 = wp::add(var_2199, var_2202);
            var_2205 = wp::mul(var_2178, var_2204);
            var_2206 = wp::add(var_2205, var_2065);
            wp::assign_inplace(var_0, var_2206, var_2203);
            // for k in range(4):                                                             <L 26>
            // apk = a[p * 4 + k]                                                             <L 27>
            var_2209 = wp::mul(var_2053, var_2208);
            var_2210 = wp::add(var_2209, var_2207);
            var_2211 = wp::extract(var_0, var_2210);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_2213 = wp::mul(var_2065, var_2212);
            var_2214 = wp::add(var_2213, var_2207);
            var_2215 = wp::extract(var_0, var_2214);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_2217 = wp::extract(var_2090, var_2216);
            var_2218 = wp::mul(var_2217, var_2211);
            var_2220 = wp::extract(var_2090, var_2219);
            var_2221 = wp::mul(var_2220, var_2215);
            var_2222 = wp::sub(var_2218, var_2221);
            var_2224 = wp::mul(var_2053, var_2223);
            var_2225 = wp::add(var_2224, var_2207);
            wp::assign_inplace(var_0, var_2225, var_2222);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_2227 = wp::extract(var_2090, var_2226);
            var_2228 = wp::mul(var_2227, var_2211);
            var_2230 = wp::extract(var_2090, var_2229);
            var_2231 = wp::mul(var_2230, var_2215);
            var_2232 = wp::add(var_2228, var_2231);
            var_2234 = wp::mul(var_2065, var_2233);
            var_2235 = wp::add(var_2234, var_2207);
            wp::assign_inplace(var_0, var_2235, var_2232);
            // apk = a[p * 4 + k]                                                             <L 27>
            var_2238 = wp::mul(var_2053, var_2237);
            var_2239 = wp::add(var_2238, var_2236);
            var_2240 = wp::extract(var_0, var_2239);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_2242 = wp::mul(var_2065, var_2241);
            var_2243 = wp::add(var_2242, var_2236);
            var_2244 = wp::extract(var_0, var_2243);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_2246 = wp::extract(var_2090, var_2245);
            var_2247 = wp::mul(var_2246, var_2240);
            var_2249 = wp::extract(var_2090, var_2248);
            var_2250 = wp::mul(var_2249, var_2244);
            var_2251 = wp::sub(var_2247, var_2250);
            var_2253 = wp::mul(var_2053, var_2252);
            var_2254 = wp::add(var_2253, var_2236);
            wp::assign_inplace(var_0, var_2254, var_2251);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_2256 = wp::extract(var_2090, var_2255);
            var_2257 = wp::mul(var_2256, var_2240);
            var_2259 = wp::extract(var_2090, var_2258);
            var_2260 = wp::mul(var_2259, var_2244);
            var_2261 = wp::add(var_2257, var_2260);
            var_2263 = wp::mul(var_2065, var_2262);
            var_2264 = wp::add(var_2263, var_2236);
            wp::assign_inplace(var_0, var_2264, var_2261);
            // apk = a[p * 4 + k]                                                             <L 27>
            var_2267 = wp::mul(var_2053, var_2266);
            var_2268 = wp::add(var_2267, var_2265);
            var_2269 = wp::extract(var_0, var_2268);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_2271 = wp::mul(var_2065, var_2270);
            var_2272 = wp::add(var_2271, var_2265);
            var_2273 = wp::extract(var_0, var_2272);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_2275 = wp::extract(var_2090, var_2274);
            var_2276 = wp::mul(var_2275, var_2269);
            var_2278 = wp::extract(var_2090, var_2277);
            var_2279 = wp::mul(var_2278, var_2273);
            var_2280 = wp::sub(var_2276, var_2279);
            var_2282 = wp::mul(var_2053, var_2281);
            var_2283 = wp::add(var_2282, var_2265);
            wp::assign_inplace(var_0, var_2283, var_2280);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_2285 = wp::extract(var_2090, var_2284);
            var_2286 = wp::mul(var_2285, var_2269);
            var_2288 = wp::extract(var_2090, var_2287);
            var_2289 = wp::mul(var_2288, var_2273);
            var_2290 = wp::add(var_2286, var_2289);
            var_2292 = wp::mul(var_2065, var_2291);
            var_2293 = wp::add(var_2292, var_2265);
            wp::assign_inplace(var_0, var_2293, var_2290);
            // apk = a[p * 4 + k]                                                             <L 27>
            var_2296 = wp::mul(var_2053, var_2295);
            var_2297 = wp::add(var_2296, var_2294);
            var_2298 = wp::extract(var_0, var_2297);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_2300 = wp::mul(var_2065, var_2299);
            var_2301 = wp::add(var_2300, var_2294);
            var_2302 = wp::extract(var_0, var_2301);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_2304 = wp::extract(var_2090, var_2303);
            var_2305 = wp::mul(var_2304, var_2298);
            var_2307 = wp::extract(var_2090, var_2306);
            var_2308 = wp::mul(var_2307, var_2302);
            var_2309 = wp::sub(var_2305, var_2308);
            var_2311 = wp::mul(var_2053, var_2310);
            var_2312 = wp::add(var_2311, var_2294);
            wp::assign_inplace(var_0, var_2312, var_2309);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_2314 = wp::extract(var_2090, var_2313);
            var_2315 = wp::mul(var_2314, var_2298);
            var_2317 = wp::extract(var_2090, var_2316);
            var_2318 = wp::mul(var_2317, var_2302);
            var_2319 = wp::add(var_2315, var_2318);
            var_2321 = wp::mul(var_2065, var_2320);
            var_2322 = wp::add(var_2321, var_2294);
            wp::assign_inplace(var_0, var_2322, var_2319);
            // for k in range(4):                                                             <L 31>
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_2325 = wp::mul(var_2323, var_2324);
            var_2326 = wp::add(var_2325, var_2053);
            var_2327 = wp::extract(var_2, var_2326);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_2329 = wp::mul(var_2323, var_2328);
            var_2330 = wp::add(var_2329, var_2065);
            var_2331 = wp::extract(var_2, var_2330);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_2333 = wp::extract(var_2090, var_2332);
            var_2334 = wp::mul(var_2333, var_2327);
            var_2336 = wp::extract(var_2090, var_2335);
            var_2337 = wp::mul(var_2336, var_2331);
            var_2338 = wp::sub(var_2334, var_2337);
            var_2340 = wp::mul(var_2323, var_2339);
            var_2341 = wp::add(var_2340, var_2053);
            wp::assign_inplace(var_2, var_2341, var_2338);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_2343 = wp::extract(var_2090, var_2342);
            var_2344 = wp::mul(var_2343, var_2327);
            var_2346 = wp::extract(var_2090, var_2345);
            var_2347 = wp::mul(var_2346, var_2331);
            var_2348 = wp::add(var_2344, var_2347);
            var_2350 = wp::mul(var_2323, var_2349);
            var_2351 = wp::add(var_2350, var_2065);
            wp::assign_inplace(var_2, var_2351, var_2348);
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_2354 = wp::mul(var_2352, var_2353);
            var_2355 = wp::add(var_2354, var_2053);
            var_2356 = wp::extract(var_2, var_2355);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_2358 = wp::mul(var_2352, var_2357);
            var_2359 = wp::add(var_2358, var_2065);
            var_2360 = wp::extract(var_2, var_2359);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_2362 = wp::extract(var_2090, var_2361);
            var_2363 = wp::mul(var_2362, var_2356);
            var_2365 = wp::extract(var_2090, var_2364);
            var_2366 = wp::mul(var_2365, var_2360);
            var_2367 = wp::sub(var_2363, var_2366);
            var_2369 = wp::mul(var_2352, var_2368);
            var_2370 = wp::add(var_2369, var_2053);
            wp::assign_inplace(var_2, var_2370, var_2367);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_2372 = wp::extract(var_2090, var_2371);
            var_2373 = wp::mul(var_2372, var_2356);
            var_2375 = wp::extract(var_2090, var_2374);
            var_2376 = wp::mul(var_2375, var_2360);
            var_2377 = wp::add(var_2373, var_2376);
            var_2379 = wp::mul(var_2352, var_2378);
            var_2380 = wp::add(var_2379, var_2065);
            wp::assign_inplace(var_2, var_2380, var_2377);
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_2383 = wp::mul(var_2381, var_2382);
            var_2384 = wp::add(var_2383, var_2053);
            var_2385 = wp::extract(var_2, var_2384);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_2387 = wp::mul(var_2381, var_2386);
            var_2388 = wp::add(var_2387, var_2065);
            var_2389 = wp::extract(var_2, var_2388);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_2391 = wp::extract(var_2090, var_2390);
            var_2392 = wp::mul(var_2391, var_2385);
            var_2394 = wp::extract(var_2090, var_2393);
            var_2395 = wp::mul(var_2394, var_2389);
            var_2396 = wp::sub(var_2392, var_2395);
            var_2398 = wp::mul(var_2381, var_2397);
            var_2399 = wp::add(var_2398, var_2053);
            wp::assign_inplace(var_2, var_2399, var_2396);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_2401 = wp::extract(var_2090, var_2400);
            var_2402 = wp::mul(var_2401, var_2385);
            var_2404 = wp::extract(var_2090, var_2403);
            var_2405 = wp::mul(var_2404, var_2389);
            var_2406 = wp::add(var_2402, var_2405);
            var_2408 = wp::mul(var_2381, var_2407);
            var_2409 = wp::add(var_2408, var_2065);
            wp::assign_inplace(var_2, var_2409, var_2406);
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_2412 = wp::mul(var_2410, var_2411);
            var_2413 = wp::add(var_2412, var_2053);
            var_2414 = wp::extract(var_2, var_2413);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_2416 = wp::mul(var_2410, var_2415);
            var_2417 = wp::add(var_2416, var_2065);
            var_2418 = wp::extract(var_2, var_2417);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_2420 = wp::extract(var_2090, var_2419);
            var_2421 = wp::mul(var_2420, var_2414);
            var_2423 = wp::extract(var_2090, var_2422);
            var_2424 = wp::mul(var_2423, var_2418);
            var_2425 = wp::sub(var_2421, var_2424);
            var_2427 = wp::mul(var_2410, var_2426);
            var_2428 = wp::add(var_2427, var_2053);
            wp::assign_inplace(var_2, var_2428, var_2425);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_2430 = wp::extract(var_2090, var_2429);
            var_2431 = wp::mul(var_2430, var_2414);
            var_2433 = wp::extract(var_2090, var_2432);
            var_2434 = wp::mul(var_2433, var_2418);
            var_2435 = wp::add(var_2431, var_2434);
            var_2437 = wp::mul(var_2410, var_2436);
            var_2438 = wp::add(var_2437, var_2065);
            wp::assign_inplace(var_2, var_2438, var_2435);
        }
        var_2439 = wp::where(var_2078, var_2089, var_2035);
        var_2440 = wp::where(var_2078, var_2090, var_2036);
        var_2441 = wp::where(var_2078, var_2410, var_2037);
        var_2442 = wp::where(var_2078, var_2182, var_2038);
        var_2443 = wp::where(var_2078, var_2186, var_2039);
        var_2444 = wp::where(var_2078, var_2298, var_2040);
        var_2445 = wp::where(var_2078, var_2302, var_2041);
        var_2446 = wp::where(var_2078, var_2414, var_2042);
        var_2447 = wp::where(var_2078, var_2418, var_2043);
        wp::assign(var_20, var_2439);
        wp::assign(var_22, var_31);
    goto start_while_0;
    end_while_0:;
    // system = four_system(float64(0.0))                                                     <L 36>
    var_2448 = 0.0;
    var_2449 = wp::vec_t<20, wp::float64>(var_2448);
    // for i in range(16):                                                                    <L 37>
    // system[i] = v[i]                                                                       <L 38>
    var_2451 = wp::extract(var_2, var_2450);
    wp::assign_inplace(var_2449, var_2450, var_2451);
    var_2453 = wp::extract(var_2, var_2452);
    wp::assign_inplace(var_2449, var_2452, var_2453);
    var_2455 = wp::extract(var_2, var_2454);
    wp::assign_inplace(var_2449, var_2454, var_2455);
    var_2457 = wp::extract(var_2, var_2456);
    wp::assign_inplace(var_2449, var_2456, var_2457);
    var_2459 = wp::extract(var_2, var_2458);
    wp::assign_inplace(var_2449, var_2458, var_2459);
    var_2461 = wp::extract(var_2, var_2460);
    wp::assign_inplace(var_2449, var_2460, var_2461);
    var_2463 = wp::extract(var_2, var_2462);
    wp::assign_inplace(var_2449, var_2462, var_2463);
    var_2465 = wp::extract(var_2, var_2464);
    wp::assign_inplace(var_2449, var_2464, var_2465);
    var_2467 = wp::extract(var_2, var_2466);
    wp::assign_inplace(var_2449, var_2466, var_2467);
    var_2469 = wp::extract(var_2, var_2468);
    wp::assign_inplace(var_2449, var_2468, var_2469);
    var_2471 = wp::extract(var_2, var_2470);
    wp::assign_inplace(var_2449, var_2470, var_2471);
    var_2473 = wp::extract(var_2, var_2472);
    wp::assign_inplace(var_2449, var_2472, var_2473);
    var_2475 = wp::extract(var_2, var_2474);
    wp::assign_inplace(var_2449, var_2474, var_2475);
    var_2477 = wp::extract(var_2, var_2476);
    wp::assign_inplace(var_2449, var_2476, var_2477);
    var_2479 = wp::extract(var_2, var_2478);
    wp::assign_inplace(var_2449, var_2478, var_2479);
    var_2481 = wp::extract(var_2, var_2480);
    wp::assign_inplace(var_2449, var_2480, var_2481);
    // for i in range(4):                                                                     <L 39>
    // system[16 + i] = a[i * 5]                                                              <L 40>
    var_2484 = wp::mul(var_2482, var_2483);
    var_2485 = wp::extract(var_0, var_2484);
    var_2487 = wp::add(var_2486, var_2482);
    wp::assign_inplace(var_2449, var_2487, var_2485);
    var_2490 = wp::mul(var_2488, var_2489);
    var_2491 = wp::extract(var_0, var_2490);
    var_2493 = wp::add(var_2492, var_2488);
    wp::assign_inplace(var_2449, var_2493, var_2491);
    var_2496 = wp::mul(var_2494, var_2495);
    var_2497 = wp::extract(var_0, var_2496);
    var_2499 = wp::add(var_2498, var_2494);
    wp::assign_inplace(var_2449, var_2499, var_2497);
    var_2502 = wp::mul(var_2500, var_2501);
    var_2503 = wp::extract(var_0, var_2502);
    var_2505 = wp::add(var_2504, var_2500);
    wp::assign_inplace(var_2449, var_2505, var_2503);
    // return system                                                                          <L 41>
    return var_2449;
}


// /work/main/src/pointloom/kernels/algebra/rigid_solve.py:134
static CUDA_CALLABLE wp::vec_t<4, wp::float64> largest_of_four_0(
    wp::vec_t<20, wp::float64> var_system)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 16;
    wp::float64 var_1;
    const wp::int32 var_2 = 0;
    wp::float64 var_3;
    const wp::int32 var_4 = 4;
    wp::float64 var_5;
    const wp::int32 var_6 = 8;
    wp::float64 var_7;
    const wp::int32 var_8 = 12;
    wp::float64 var_9;
    wp::vec_t<4, wp::float64> var_10;
    const wp::int32 var_11 = 1;
    const wp::int32 var_12 = 16;
    wp::int32 var_13;
    wp::float64 var_14;
    bool var_15;
    const wp::int32 var_16 = 16;
    wp::int32 var_17;
    wp::float64 var_18;
    wp::float64 var_19;
    const wp::int32 var_20 = 4;
    wp::int32 var_21;
    wp::float64 var_22;
    const wp::int32 var_23 = 8;
    wp::int32 var_24;
    wp::float64 var_25;
    const wp::int32 var_26 = 12;
    wp::int32 var_27;
    wp::float64 var_28;
    wp::vec_t<4, wp::float64> var_29;
    wp::float64 var_30;
    wp::vec_t<4, wp::float64> var_31;
    const wp::int32 var_32 = 2;
    const wp::int32 var_33 = 16;
    wp::int32 var_34;
    wp::float64 var_35;
    bool var_36;
    const wp::int32 var_37 = 16;
    wp::int32 var_38;
    wp::float64 var_39;
    wp::float64 var_40;
    const wp::int32 var_41 = 4;
    wp::int32 var_42;
    wp::float64 var_43;
    const wp::int32 var_44 = 8;
    wp::int32 var_45;
    wp::float64 var_46;
    const wp::int32 var_47 = 12;
    wp::int32 var_48;
    wp::float64 var_49;
    wp::vec_t<4, wp::float64> var_50;
    wp::float64 var_51;
    wp::vec_t<4, wp::float64> var_52;
    const wp::int32 var_53 = 3;
    const wp::int32 var_54 = 16;
    wp::int32 var_55;
    wp::float64 var_56;
    bool var_57;
    const wp::int32 var_58 = 16;
    wp::int32 var_59;
    wp::float64 var_60;
    wp::float64 var_61;
    const wp::int32 var_62 = 4;
    wp::int32 var_63;
    wp::float64 var_64;
    const wp::int32 var_65 = 8;
    wp::int32 var_66;
    wp::float64 var_67;
    const wp::int32 var_68 = 12;
    wp::int32 var_69;
    wp::float64 var_70;
    wp::vec_t<4, wp::float64> var_71;
    wp::float64 var_72;
    wp::vec_t<4, wp::float64> var_73;
    //---------
    // forward
    // def largest_of_four(system: four_system) -> vec4d:                                     <L 135>
    // largest = system[16]                                                                   <L 137>
    var_1 = wp::extract(var_system, var_0);
    // eigenvector = vec4d(system[0], system[4], system[8], system[12])                       <L 138>
    var_3 = wp::extract(var_system, var_2);
    var_5 = wp::extract(var_system, var_4);
    var_7 = wp::extract(var_system, var_6);
    var_9 = wp::extract(var_system, var_8);
    var_10 = wp::vec_t<4, wp::float64>(var_3, var_5, var_7, var_9);
    // for k in range(1, 4):                                                                  <L 139>
    // if system[16 + k] > largest:                                                           <L 140>
    var_13 = wp::add(var_12, var_11);
    var_14 = wp::extract(var_system, var_13);
    var_15 = (var_14 > var_1);
    if (var_15) {
        // largest = system[16 + k]                                                           <L 141>
        var_17 = wp::add(var_16, var_11);
        var_18 = wp::extract(var_system, var_17);
        // eigenvector = vec4d(system[k], system[4 + k], system[8 + k], system[12 + k])       <L 142>
        var_19 = wp::extract(var_system, var_11);
        var_21 = wp::add(var_20, var_11);
        var_22 = wp::extract(var_system, var_21);
        var_24 = wp::add(var_23, var_11);
        var_25 = wp::extract(var_system, var_24);
        var_27 = wp::add(var_26, var_11);
        var_28 = wp::extract(var_system, var_27);
        var_29 = wp::vec_t<4, wp::float64>(var_19, var_22, var_25, var_28);
    }
    var_30 = wp::where(var_15, var_18, var_1);
    var_31 = wp::where(var_15, var_29, var_10);
    // if system[16 + k] > largest:                                                           <L 140>
    var_34 = wp::add(var_33, var_32);
    var_35 = wp::extract(var_system, var_34);
    var_36 = (var_35 > var_30);
    if (var_36) {
        // largest = system[16 + k]                                                           <L 141>
        var_38 = wp::add(var_37, var_32);
        var_39 = wp::extract(var_system, var_38);
        // eigenvector = vec4d(system[k], system[4 + k], system[8 + k], system[12 + k])       <L 142>
        var_40 = wp::extract(var_system, var_32);
        var_42 = wp::add(var_41, var_32);
        var_43 = wp::extract(var_system, var_42);
        var_45 = wp::add(var_44, var_32);
        var_46 = wp::extract(var_system, var_45);
        var_48 = wp::add(var_47, var_32);
        var_49 = wp::extract(var_system, var_48);
        var_50 = wp::vec_t<4, wp::float64>(var_40, var_43, var_46, var_49);
    }
    var_51 = wp::where(var_36, var_39, var_30);
    var_52 = wp::where(var_36, var_50, var_31);
    // if system[16 + k] > largest:                                                           <L 140>
    var_55 = wp::add(var_54, var_53);
    var_56 = wp::extract(var_system, var_55);
    var_57 = (var_56 > var_51);
    if (var_57) {
        // largest = system[16 + k]                                                           <L 141>
        var_59 = wp::add(var_58, var_53);
        var_60 = wp::extract(var_system, var_59);
        // eigenvector = vec4d(system[k], system[4 + k], system[8 + k], system[12 + k])       <L 142>
        var_61 = wp::extract(var_system, var_53);
        var_63 = wp::add(var_62, var_53);
        var_64 = wp::extract(var_system, var_63);
        var_66 = wp::add(var_65, var_53);
        var_67 = wp::extract(var_system, var_66);
        var_69 = wp::add(var_68, var_53);
        var_70 = wp::extract(var_system, var_69);
        var_71 = wp::vec_t<4, wp::float64>(var_61, var_64, var_67, var_70);
    }
    var_72 = wp::where(var_57, var_60, var_51);
    var_73 = wp::where(var_57, var_71, var_52);
    // return eigenvector                                                                     <L 143>
    return var_73;
}


// <pointloom.kernels.algebra.rigid_solve.rotation_about>:1
static CUDA_CALLABLE wp::mat_t<4, 4, wp::float64> rotation_about_0(
    wp::float64 var_rx,
    wp::float64 var_ry,
    wp::float64 var_rz,
    wp::float64 var_rw)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::float64 var_1;
    wp::float64 var_2;
    wp::float64 var_3;
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
    wp::float64 var_16;
    wp::float64 var_17;
    wp::float64 var_18;
    wp::float64 var_19;
    wp::float64 var_20;
    wp::float64 var_21;
    wp::float64 var_22;
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
    wp::float64 var_37;
    wp::float64 var_38;
    wp::float64 var_39;
    wp::float64 var_40;
    wp::float64 var_41;
    wp::float64 var_42;
    wp::float64 var_43;
    wp::float64 var_44;
    wp::float64 var_45;
    wp::float64 var_46;
    wp::float64 var_47;
    wp::float64 var_48;
    wp::float64 var_49;
    wp::mat_t<4, 4, wp::float64> var_50;
    //---------
    // forward
    // def rotation_about(rx, ry, rz, rw):                                                    <L 1>
    // size = rx * rx + ry * ry + rz * rz + rw * rw                                           <L 3>
    var_0 = wp::mul(var_rx, var_rx);
    var_1 = wp::mul(var_ry, var_ry);
    var_2 = wp::add(var_0, var_1);
    var_3 = wp::mul(var_rz, var_rz);
    var_4 = wp::add(var_2, var_3);
    var_5 = wp::mul(var_rw, var_rw);
    var_6 = wp::add(var_4, var_5);
    // s = float64(2.0) / size                                                                <L 4>
    var_7 = 2.0;
    var_8 = wp::div(var_7, var_6);
    // one = float64(1.0)                                                                     <L 5>
    var_9 = 1.0;
    // zero = float64(0.0)                                                                    <L 6>
    var_10 = 0.0;
    // return mat44d(one - s * (ry * ry + rz * rz), s * (rx * ry - rz * rw), s * (rx * rz + ry * rw), zero, s * (rx * ry + rz * rw), one - s * (rx * rx + rz * rz), s * (ry * rz - rx * rw), zero, s * (rx * rz - ry * rw), s * (ry * rz + rx * rw), one - s * (rx * rx + ry * ry), zero, zero, zero, zero, one)       <L 7>
    var_11 = wp::mul(var_ry, var_ry);
    var_12 = wp::mul(var_rz, var_rz);
    var_13 = wp::add(var_11, var_12);
    var_14 = wp::mul(var_8, var_13);
    var_15 = wp::sub(var_9, var_14);
    var_16 = wp::mul(var_rx, var_ry);
    var_17 = wp::mul(var_rz, var_rw);
    var_18 = wp::sub(var_16, var_17);
    var_19 = wp::mul(var_8, var_18);
    var_20 = wp::mul(var_rx, var_rz);
    var_21 = wp::mul(var_ry, var_rw);
    var_22 = wp::add(var_20, var_21);
    var_23 = wp::mul(var_8, var_22);
    var_24 = wp::mul(var_rx, var_ry);
    var_25 = wp::mul(var_rz, var_rw);
    var_26 = wp::add(var_24, var_25);
    var_27 = wp::mul(var_8, var_26);
    var_28 = wp::mul(var_rx, var_rx);
    var_29 = wp::mul(var_rz, var_rz);
    var_30 = wp::add(var_28, var_29);
    var_31 = wp::mul(var_8, var_30);
    var_32 = wp::sub(var_9, var_31);
    var_33 = wp::mul(var_ry, var_rz);
    var_34 = wp::mul(var_rx, var_rw);
    var_35 = wp::sub(var_33, var_34);
    var_36 = wp::mul(var_8, var_35);
    var_37 = wp::mul(var_rx, var_rz);
    var_38 = wp::mul(var_ry, var_rw);
    var_39 = wp::sub(var_37, var_38);
    var_40 = wp::mul(var_8, var_39);
    var_41 = wp::mul(var_ry, var_rz);
    var_42 = wp::mul(var_rx, var_rw);
    var_43 = wp::add(var_41, var_42);
    var_44 = wp::mul(var_8, var_43);
    var_45 = wp::mul(var_rx, var_rx);
    var_46 = wp::mul(var_ry, var_ry);
    var_47 = wp::add(var_45, var_46);
    var_48 = wp::mul(var_8, var_47);
    var_49 = wp::sub(var_9, var_48);
    var_50 = wp::mat_t<4, 4, wp::float64>(var_15, var_19, var_23, var_10, var_27, var_32, var_36, var_10, var_40, var_44, var_49, var_10, var_10, var_10, var_10, var_9);
    return var_50;
}


// <pointloom.kernels.algebra.rigid_solve.fit_pose>:1
static CUDA_CALLABLE wp::mat_t<4, 4, wp::float64> fit_pose_0(
    wp::vec_t<18, wp::float64> var_sums,
    wp::int32 var_with_scaling)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float64 var_1;
    wp::float64 var_2;
    wp::float64 var_3;
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
    wp::float64 var_16;
    wp::float64 var_17;
    wp::mat_t<4, 4, wp::float64> var_18;
    wp::float64 var_19;
    bool var_20;
    const wp::int32 var_21 = 1;
    wp::float64 var_22;
    wp::float64 var_23;
    const wp::int32 var_24 = 2;
    wp::float64 var_25;
    wp::float64 var_26;
    const wp::int32 var_27 = 3;
    wp::float64 var_28;
    wp::float64 var_29;
    const wp::int32 var_30 = 4;
    wp::float64 var_31;
    wp::float64 var_32;
    const wp::int32 var_33 = 5;
    wp::float64 var_34;
    wp::float64 var_35;
    const wp::int32 var_36 = 6;
    wp::float64 var_37;
    wp::float64 var_38;
    const wp::int32 var_39 = 7;
    wp::float64 var_40;
    wp::float64 var_41;
    wp::float64 var_42;
    wp::float64 var_43;
    const wp::int32 var_44 = 8;
    wp::float64 var_45;
    wp::float64 var_46;
    wp::float64 var_47;
    wp::float64 var_48;
    const wp::int32 var_49 = 9;
    wp::float64 var_50;
    wp::float64 var_51;
    wp::float64 var_52;
    wp::float64 var_53;
    const wp::int32 var_54 = 10;
    wp::float64 var_55;
    wp::float64 var_56;
    wp::float64 var_57;
    wp::float64 var_58;
    const wp::int32 var_59 = 11;
    wp::float64 var_60;
    wp::float64 var_61;
    wp::float64 var_62;
    wp::float64 var_63;
    const wp::int32 var_64 = 12;
    wp::float64 var_65;
    wp::float64 var_66;
    wp::float64 var_67;
    wp::float64 var_68;
    const wp::int32 var_69 = 13;
    wp::float64 var_70;
    wp::float64 var_71;
    wp::float64 var_72;
    wp::float64 var_73;
    const wp::int32 var_74 = 14;
    wp::float64 var_75;
    wp::float64 var_76;
    wp::float64 var_77;
    wp::float64 var_78;
    const wp::int32 var_79 = 15;
    wp::float64 var_80;
    wp::float64 var_81;
    wp::float64 var_82;
    wp::float64 var_83;
    const wp::int32 var_84 = 16;
    wp::float64 var_85;
    wp::float64 var_86;
    wp::float64 var_87;
    wp::float64 var_88;
    wp::float64 var_89;
    wp::float64 var_90;
    wp::float64 var_91;
    wp::float64 var_92;
    const wp::int32 var_93 = 17;
    wp::float64 var_94;
    wp::float64 var_95;
    wp::float64 var_96;
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
    wp::float64 var_125;
    wp::float64 var_126;
    wp::float64 var_127;
    wp::vec_t<16, wp::float64> var_128;
    wp::vec_t<20, wp::float64> var_129;
    wp::vec_t<4, wp::float64> var_130;
    const wp::int32 var_131 = 1;
    wp::float64 var_132;
    const wp::int32 var_133 = 2;
    wp::float64 var_134;
    const wp::int32 var_135 = 3;
    wp::float64 var_136;
    const wp::int32 var_137 = 0;
    wp::float64 var_138;
    wp::mat_t<4, 4, wp::float64> var_139;
    wp::float64 var_140;
    bool var_141;
    const wp::int32 var_142 = 1;
    bool var_143;
    wp::float64 var_144;
    bool var_145;
    const wp::int32 var_146 = 0;
    const wp::int32 var_147 = 0;
    wp::float64 var_148;
    wp::float64 var_149;
    const wp::int32 var_150 = 0;
    const wp::int32 var_151 = 1;
    wp::float64 var_152;
    wp::float64 var_153;
    wp::float64 var_154;
    const wp::int32 var_155 = 0;
    const wp::int32 var_156 = 2;
    wp::float64 var_157;
    wp::float64 var_158;
    wp::float64 var_159;
    const wp::int32 var_160 = 1;
    const wp::int32 var_161 = 0;
    wp::float64 var_162;
    wp::float64 var_163;
    const wp::int32 var_164 = 1;
    const wp::int32 var_165 = 1;
    wp::float64 var_166;
    wp::float64 var_167;
    wp::float64 var_168;
    const wp::int32 var_169 = 1;
    const wp::int32 var_170 = 2;
    wp::float64 var_171;
    wp::float64 var_172;
    wp::float64 var_173;
    wp::float64 var_174;
    const wp::int32 var_175 = 2;
    const wp::int32 var_176 = 0;
    wp::float64 var_177;
    wp::float64 var_178;
    const wp::int32 var_179 = 2;
    const wp::int32 var_180 = 1;
    wp::float64 var_181;
    wp::float64 var_182;
    wp::float64 var_183;
    const wp::int32 var_184 = 2;
    const wp::int32 var_185 = 2;
    wp::float64 var_186;
    wp::float64 var_187;
    wp::float64 var_188;
    wp::float64 var_189;
    wp::float64 var_190;
    bool var_191;
    wp::float64 var_192;
    wp::float64 var_193;
    wp::float64 var_194;
    const wp::int32 var_195 = 0;
    const wp::int32 var_196 = 0;
    wp::float64 var_197;
    wp::float64 var_198;
    const wp::int32 var_199 = 1;
    wp::float64 var_200;
    wp::float64 var_201;
    const wp::int32 var_202 = 2;
    wp::float64 var_203;
    wp::float64 var_204;
    const wp::int32 var_205 = 0;
    wp::float64 var_206;
    wp::float64 var_207;
    const wp::int32 var_208 = 1;
    wp::float64 var_209;
    wp::float64 var_210;
    wp::float64 var_211;
    const wp::int32 var_212 = 2;
    wp::float64 var_213;
    wp::float64 var_214;
    wp::float64 var_215;
    wp::float64 var_216;
    const wp::int32 var_217 = 3;
    const wp::int32 var_218 = 1;
    const wp::int32 var_219 = 0;
    wp::float64 var_220;
    wp::float64 var_221;
    const wp::int32 var_222 = 1;
    wp::float64 var_223;
    wp::float64 var_224;
    const wp::int32 var_225 = 2;
    wp::float64 var_226;
    wp::float64 var_227;
    const wp::int32 var_228 = 0;
    wp::float64 var_229;
    wp::float64 var_230;
    const wp::int32 var_231 = 1;
    wp::float64 var_232;
    wp::float64 var_233;
    wp::float64 var_234;
    const wp::int32 var_235 = 2;
    wp::float64 var_236;
    wp::float64 var_237;
    wp::float64 var_238;
    wp::float64 var_239;
    const wp::int32 var_240 = 3;
    const wp::int32 var_241 = 2;
    const wp::int32 var_242 = 0;
    wp::float64 var_243;
    wp::float64 var_244;
    const wp::int32 var_245 = 1;
    wp::float64 var_246;
    wp::float64 var_247;
    const wp::int32 var_248 = 2;
    wp::float64 var_249;
    wp::float64 var_250;
    const wp::int32 var_251 = 0;
    wp::float64 var_252;
    wp::float64 var_253;
    const wp::int32 var_254 = 1;
    wp::float64 var_255;
    wp::float64 var_256;
    wp::float64 var_257;
    const wp::int32 var_258 = 2;
    wp::float64 var_259;
    wp::float64 var_260;
    wp::float64 var_261;
    wp::float64 var_262;
    const wp::int32 var_263 = 3;
    const wp::int32 var_264 = 0;
    const wp::int32 var_265 = 3;
    wp::float64 var_266;
    wp::float64 var_267;
    const wp::int32 var_268 = 0;
    const wp::int32 var_269 = 3;
    const wp::int32 var_270 = 1;
    const wp::int32 var_271 = 3;
    wp::float64 var_272;
    wp::float64 var_273;
    const wp::int32 var_274 = 1;
    const wp::int32 var_275 = 3;
    const wp::int32 var_276 = 2;
    const wp::int32 var_277 = 3;
    wp::float64 var_278;
    wp::float64 var_279;
    const wp::int32 var_280 = 2;
    const wp::int32 var_281 = 3;
    wp::mat_t<4, 4, wp::float64> var_282;
    //---------
    // forward
    // def fit_pose(sums, with_scaling):                                                      <L 1>
    // w = sums[0]                                                                            <L 3>
    var_1 = wp::extract(var_sums, var_0);
    // pose = mat44d(float64(1.0), float64(0.0), float64(0.0), float64(0.0), float64(0.0), float64(1.0), float64(0.0), float64(0.0), float64(0.0), float64(0.0), float64(1.0), float64(0.0), float64(0.0), float64(0.0), float64(0.0), float64(1.0))       <L 4>
    var_2 = 1.0;
    var_3 = 0.0;
    var_4 = 0.0;
    var_5 = 0.0;
    var_6 = 0.0;
    var_7 = 1.0;
    var_8 = 0.0;
    var_9 = 0.0;
    var_10 = 0.0;
    var_11 = 0.0;
    var_12 = 1.0;
    var_13 = 0.0;
    var_14 = 0.0;
    var_15 = 0.0;
    var_16 = 0.0;
    var_17 = 1.0;
    var_18 = wp::mat_t<4, 4, wp::float64>(var_2, var_3, var_4, var_5, var_6, var_7, var_8, var_9, var_10, var_11, var_12, var_13, var_14, var_15, var_16, var_17);
    // if w > float64(0.0):                                                                   <L 5>
    var_19 = 0.0;
    var_20 = (var_1 > var_19);
    if (var_20) {
        // px = sums[1] / w                                                                   <L 6>
        var_22 = wp::extract(var_sums, var_21);
        var_23 = wp::div(var_22, var_1);
        // py = sums[2] / w                                                                   <L 7>
        var_25 = wp::extract(var_sums, var_24);
        var_26 = wp::div(var_25, var_1);
        // pz = sums[3] / w                                                                   <L 8>
        var_28 = wp::extract(var_sums, var_27);
        var_29 = wp::div(var_28, var_1);
        // qx = sums[4] / w                                                                   <L 9>
        var_31 = wp::extract(var_sums, var_30);
        var_32 = wp::div(var_31, var_1);
        // qy = sums[5] / w                                                                   <L 10>
        var_34 = wp::extract(var_sums, var_33);
        var_35 = wp::div(var_34, var_1);
        // qz = sums[6] / w                                                                   <L 11>
        var_37 = wp::extract(var_sums, var_36);
        var_38 = wp::div(var_37, var_1);
        // xx = sums[7] - w * px * qx                                                         <L 12>
        var_40 = wp::extract(var_sums, var_39);
        var_41 = wp::mul(var_1, var_23);
        var_42 = wp::mul(var_41, var_32);
        var_43 = wp::sub(var_40, var_42);
        // xy = sums[8] - w * px * qy                                                         <L 13>
        var_45 = wp::extract(var_sums, var_44);
        var_46 = wp::mul(var_1, var_23);
        var_47 = wp::mul(var_46, var_35);
        var_48 = wp::sub(var_45, var_47);
        // xz = sums[9] - w * px * qz                                                         <L 14>
        var_50 = wp::extract(var_sums, var_49);
        var_51 = wp::mul(var_1, var_23);
        var_52 = wp::mul(var_51, var_38);
        var_53 = wp::sub(var_50, var_52);
        // yx = sums[10] - w * py * qx                                                        <L 15>
        var_55 = wp::extract(var_sums, var_54);
        var_56 = wp::mul(var_1, var_26);
        var_57 = wp::mul(var_56, var_32);
        var_58 = wp::sub(var_55, var_57);
        // yy = sums[11] - w * py * qy                                                        <L 16>
        var_60 = wp::extract(var_sums, var_59);
        var_61 = wp::mul(var_1, var_26);
        var_62 = wp::mul(var_61, var_35);
        var_63 = wp::sub(var_60, var_62);
        // yz = sums[12] - w * py * qz                                                        <L 17>
        var_65 = wp::extract(var_sums, var_64);
        var_66 = wp::mul(var_1, var_26);
        var_67 = wp::mul(var_66, var_38);
        var_68 = wp::sub(var_65, var_67);
        // zx = sums[13] - w * pz * qx                                                        <L 18>
        var_70 = wp::extract(var_sums, var_69);
        var_71 = wp::mul(var_1, var_29);
        var_72 = wp::mul(var_71, var_32);
        var_73 = wp::sub(var_70, var_72);
        // zy = sums[14] - w * pz * qy                                                        <L 19>
        var_75 = wp::extract(var_sums, var_74);
        var_76 = wp::mul(var_1, var_29);
        var_77 = wp::mul(var_76, var_35);
        var_78 = wp::sub(var_75, var_77);
        // zz = sums[15] - w * pz * qz                                                        <L 20>
        var_80 = wp::extract(var_sums, var_79);
        var_81 = wp::mul(var_1, var_29);
        var_82 = wp::mul(var_81, var_38);
        var_83 = wp::sub(var_80, var_82);
        // spread = sums[16] - w * (px * px + py * py + pz * pz)                              <L 21>
        var_85 = wp::extract(var_sums, var_84);
        var_86 = wp::mul(var_23, var_23);
        var_87 = wp::mul(var_26, var_26);
        var_88 = wp::add(var_86, var_87);
        var_89 = wp::mul(var_29, var_29);
        var_90 = wp::add(var_88, var_89);
        var_91 = wp::mul(var_1, var_90);
        var_92 = wp::sub(var_85, var_91);
        // spread_q = sums[17] - w * (qx * qx + qy * qy + qz * qz)                            <L 22>
        var_94 = wp::extract(var_sums, var_93);
        var_95 = wp::mul(var_32, var_32);
        var_96 = wp::mul(var_35, var_35);
        var_97 = wp::add(var_95, var_96);
        var_98 = wp::mul(var_38, var_38);
        var_99 = wp::add(var_97, var_98);
        var_100 = wp::mul(var_1, var_99);
        var_101 = wp::sub(var_94, var_100);
        // still = xx + yy + zz + float64(1e-12) * max(spread + spread_q, float64(0.0))       <L 23>
        var_102 = wp::add(var_43, var_63);
        var_103 = wp::add(var_102, var_83);
        var_104 = 1e-12;
        var_105 = wp::add(var_92, var_101);
        var_106 = 0.0;
        var_107 = wp::max(var_105, var_106);
        var_108 = wp::mul(var_104, var_107);
        var_109 = wp::add(var_103, var_108);
        // a = four_square(still, yz - zy, zx - xz, xy - yx, yz - zy, xx - yy - zz, xy + yx, zx + xz, zx - xz, xy + yx, yy - xx - zz, yz + zy, xy - yx, zx + xz, yz + zy, zz - xx - yy)       <L 24>
        var_110 = wp::sub(var_68, var_78);
        var_111 = wp::sub(var_73, var_53);
        var_112 = wp::sub(var_48, var_58);
        var_113 = wp::sub(var_68, var_78);
        var_114 = wp::sub(var_43, var_63);
        var_115 = wp::sub(var_114, var_83);
        var_116 = wp::add(var_48, var_58);
        var_117 = wp::add(var_73, var_53);
        var_118 = wp::sub(var_73, var_53);
        var_119 = wp::add(var_48, var_58);
        var_120 = wp::sub(var_63, var_43);
        var_121 = wp::sub(var_120, var_83);
        var_122 = wp::add(var_68, var_78);
        var_123 = wp::sub(var_48, var_58);
        var_124 = wp::add(var_73, var_53);
        var_125 = wp::add(var_68, var_78);
        var_126 = wp::sub(var_83, var_43);
        var_127 = wp::sub(var_126, var_63);
        var_128 = wp::vec_t<16, wp::float64>({var_109, var_110, var_111, var_112, var_113, var_115, var_116, var_117, var_118, var_119, var_121, var_122, var_123, var_124, var_125, var_127});
        // best = largest_of_four(diagonalize_four(a))                                        <L 25>
        var_129 = diagonalize_four_0(var_128);
        var_130 = largest_of_four_0(var_129);
        // pose = rotation_about(best[1], best[2], best[3], best[0])                          <L 26>
        var_132 = wp::extract(var_130, var_131);
        var_134 = wp::extract(var_130, var_133);
        var_136 = wp::extract(var_130, var_135);
        var_138 = wp::extract(var_130, var_137);
        var_139 = rotation_about_0(var_132, var_134, var_136, var_138);
        // scale = float64(1.0)                                                               <L 27>
        var_140 = 1.0;
        // if with_scaling == 1 and spread > float64(0.0):                                    <L 28>
        var_143 = (var_with_scaling == var_142);
        var_141 = var_143;
        if (var_141) {
            var_144 = 0.0;
            var_145 = (var_92 > var_144);
            var_141 = var_141 && var_145;
        }
        if (var_141) {
            // aligned = pose[0, 0] * xx + pose[0, 1] * yx + pose[0, 2] * zx                  <L 29>
            var_148 = wp::extract(var_139, var_146, var_147);
            var_149 = wp::mul(var_148, var_43);
            var_152 = wp::extract(var_139, var_150, var_151);
            var_153 = wp::mul(var_152, var_58);
            var_154 = wp::add(var_149, var_153);
            var_157 = wp::extract(var_139, var_155, var_156);
            var_158 = wp::mul(var_157, var_73);
            var_159 = wp::add(var_154, var_158);
            // aligned += pose[1, 0] * xy + pose[1, 1] * yy + pose[1, 2] * zy                 <L 30>
            var_162 = wp::extract(var_139, var_160, var_161);
            var_163 = wp::mul(var_162, var_48);
            var_166 = wp::extract(var_139, var_164, var_165);
            var_167 = wp::mul(var_166, var_63);
            var_168 = wp::add(var_163, var_167);
            var_171 = wp::extract(var_139, var_169, var_170);
            var_172 = wp::mul(var_171, var_78);
            var_173 = wp::add(var_168, var_172);
            var_174 = wp::add(var_159, var_173);
            // aligned += pose[2, 0] * xz + pose[2, 1] * yz + pose[2, 2] * zz                 <L 31>
            var_177 = wp::extract(var_139, var_175, var_176);
            var_178 = wp::mul(var_177, var_53);
            var_181 = wp::extract(var_139, var_179, var_180);
            var_182 = wp::mul(var_181, var_68);
            var_183 = wp::add(var_178, var_182);
            var_186 = wp::extract(var_139, var_184, var_185);
            var_187 = wp::mul(var_186, var_83);
            var_188 = wp::add(var_183, var_187);
            var_189 = wp::add(var_174, var_188);
            // if aligned > float64(0.0):                                                     <L 32>
            var_190 = 0.0;
            var_191 = (var_189 > var_190);
            if (var_191) {
                // scale = aligned / spread                                                   <L 33>
                var_192 = wp::div(var_189, var_92);
            }
            var_193 = wp::where(var_191, var_192, var_140);
        }
        var_194 = wp::where(var_141, var_193, var_140);
        // for i in range(3):                                                                 <L 34>
        // for j in range(3):                                                                 <L 35>
        // pose[i, j] = pose[i, j] * scale                                                    <L 36>
        var_197 = wp::extract(var_139, var_195, var_196);
        var_198 = wp::mul(var_197, var_194);
        wp::assign_inplace(var_139, var_195, var_196, var_198);
        var_200 = wp::extract(var_139, var_195, var_199);
        var_201 = wp::mul(var_200, var_194);
        wp::assign_inplace(var_139, var_195, var_199, var_201);
        var_203 = wp::extract(var_139, var_195, var_202);
        var_204 = wp::mul(var_203, var_194);
        wp::assign_inplace(var_139, var_195, var_202, var_204);
        // pose[i, 3] = -(pose[i, 0] * px + pose[i, 1] * py + pose[i, 2] * pz)                <L 37>
        var_206 = wp::extract(var_139, var_195, var_205);
        var_207 = wp::mul(var_206, var_23);
        var_209 = wp::extract(var_139, var_195, var_208);
        var_210 = wp::mul(var_209, var_26);
        var_211 = wp::add(var_207, var_210);
        var_213 = wp::extract(var_139, var_195, var_212);
        var_214 = wp::mul(var_213, var_29);
        var_215 = wp::add(var_211, var_214);
        var_216 = wp::neg(var_215);
        wp::assign_inplace(var_139, var_195, var_217, var_216);
        // for j in range(3):                                                                 <L 35>
        // pose[i, j] = pose[i, j] * scale                                                    <L 36>
        var_220 = wp::extract(var_139, var_218, var_219);
        var_221 = wp::mul(var_220, var_194);
        wp::assign_inplace(var_139, var_218, var_219, var_221);
        var_223 = wp::extract(var_139, var_218, var_222);
        var_224 = wp::mul(var_223, var_194);
        wp::assign_inplace(var_139, var_218, var_222, var_224);
        var_226 = wp::extract(var_139, var_218, var_225);
        var_227 = wp::mul(var_226, var_194);
        wp::assign_inplace(var_139, var_218, var_225, var_227);
        // pose[i, 3] = -(pose[i, 0] * px + pose[i, 1] * py + pose[i, 2] * pz)                <L 37>
        var_229 = wp::extract(var_139, var_218, var_228);
        var_230 = wp::mul(var_229, var_23);
        var_232 = wp::extract(var_139, var_218, var_231);
        var_233 = wp::mul(var_232, var_26);
        var_234 = wp::add(var_230, var_233);
        var_236 = wp::extract(var_139, var_218, var_235);
        var_237 = wp::mul(var_236, var_29);
        var_238 = wp::add(var_234, var_237);
        var_239 = wp::neg(var_238);
        wp::assign_inplace(var_139, var_218, var_240, var_239);
        // for j in range(3):                                                                 <L 35>
        // pose[i, j] = pose[i, j] * scale                                                    <L 36>
        var_243 = wp::extract(var_139, var_241, var_242);
        var_244 = wp::mul(var_243, var_194);
        wp::assign_inplace(var_139, var_241, var_242, var_244);
        var_246 = wp::extract(var_139, var_241, var_245);
        var_247 = wp::mul(var_246, var_194);
        wp::assign_inplace(var_139, var_241, var_245, var_247);
        var_249 = wp::extract(var_139, var_241, var_248);
        var_250 = wp::mul(var_249, var_194);
        wp::assign_inplace(var_139, var_241, var_248, var_250);
        // pose[i, 3] = -(pose[i, 0] * px + pose[i, 1] * py + pose[i, 2] * pz)                <L 37>
        var_252 = wp::extract(var_139, var_241, var_251);
        var_253 = wp::mul(var_252, var_23);
        var_255 = wp::extract(var_139, var_241, var_254);
        var_256 = wp::mul(var_255, var_26);
        var_257 = wp::add(var_253, var_256);
        var_259 = wp::extract(var_139, var_241, var_258);
        var_260 = wp::mul(var_259, var_29);
        var_261 = wp::add(var_257, var_260);
        var_262 = wp::neg(var_261);
        wp::assign_inplace(var_139, var_241, var_263, var_262);
        // pose[0, 3] = pose[0, 3] + qx                                                       <L 38>
        var_266 = wp::extract(var_139, var_264, var_265);
        var_267 = wp::add(var_266, var_32);
        wp::assign_inplace(var_139, var_268, var_269, var_267);
        // pose[1, 3] = pose[1, 3] + qy                                                       <L 39>
        var_272 = wp::extract(var_139, var_270, var_271);
        var_273 = wp::add(var_272, var_35);
        wp::assign_inplace(var_139, var_274, var_275, var_273);
        // pose[2, 3] = pose[2, 3] + qz                                                       <L 40>
        var_278 = wp::extract(var_139, var_276, var_277);
        var_279 = wp::add(var_278, var_38);
        wp::assign_inplace(var_139, var_280, var_281, var_279);
    }
    var_282 = wp::where(var_20, var_139, var_18);
    // return pose                                                                            <L 41>
    return var_282;
}


// /work/main/src/pointloom/kernels/algebra/transform.py:27
static CUDA_CALLABLE void adj_widen_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/algebra/rigid_solve.py:301
static CUDA_CALLABLE void adj_move_0(
    wp::mat_t<4, 4, wp::float64> var_pose,
    wp::vec_t<3, wp::float64> var_p,
    wp::mat_t<4, 4, wp::float64> & adj_pose,
    wp::vec_t<3, wp::float64> & adj_p,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/algebra/transform.py:32
static CUDA_CALLABLE void adj_narrow_0(
    wp::vec_t<3, wp::float64> var_p,
    wp::vec_t<3, wp::float64> & adj_p,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.poses.pose_fitness.moved_point>:1
static CUDA_CALLABLE void adj_moved_point_0(
    wp::mat_t<4, 4, wp::float64> var_pose,
    wp::int32 var_row,
    wp::array_t<wp::vec_t<3, wp::float32>> var_fitness__source,
    wp::vec_t<3, wp::float32> var_fitness__source_middle,
    wp::vec_t<3, wp::float32> var_fitness__target_middle,
    wp::mat_t<4, 4, wp::float64> & adj_pose,
    wp::int32 & adj_row,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_fitness__source,
    wp::vec_t<3, wp::float32> & adj_fitness__source_middle,
    wp::vec_t<3, wp::float32> & adj_fitness__target_middle,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/search/hilbert_order.py:102
static CUDA_CALLABLE void adj_cell_on_axis_0(
    wp::float32 var_coordinate,
    wp::float32 var_low,
    wp::float32 var_scale,
    wp::int32 var_levels,
    wp::float32 & adj_coordinate,
    wp::float32 & adj_low,
    wp::float32 & adj_scale,
    wp::int32 & adj_levels,
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


// <pointloom.kernels.search.hilbert_order.hilbert_codes>:1
static CUDA_CALLABLE void adj_hilbert_codes_0(
    wp::vec_t<8, wp::int32> var_cx,
    wp::vec_t<8, wp::int32> var_cy,
    wp::vec_t<8, wp::int32> var_cz,
    wp::int32 var_levels,
    wp::vec_t<8, wp::int32> & adj_cx,
    wp::vec_t<8, wp::int32> & adj_cy,
    wp::vec_t<8, wp::int32> & adj_cz,
    wp::int32 & adj_levels,
    wp::vec_t<8, wp::int64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.hilbert_order.locate_on_curve>:1
static CUDA_CALLABLE void adj_locate_on_curve_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> var_curve__low,
    wp::float32 var_curve__scale,
    wp::int32 var_curve__levels,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float32> & adj_curve__low,
    wp::float32 & adj_curve__scale,
    wp::int32 & adj_curve__levels,
    wp::int64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.point_tree.find_run>:1
static CUDA_CALLABLE void adj_find_run_0(
    wp::array_t<wp::int64> var_codes,
    wp::int32 var_first,
    wp::int32 var_count,
    wp::int64 var_code,
    wp::array_t<wp::int64> & adj_codes,
    wp::int32 & adj_first,
    wp::int32 & adj_count,
    wp::int64 & adj_code,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.point_tree.find_bucket>:1
static CUDA_CALLABLE void adj_find_bucket_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::int32 var_tree__count,
    wp::array_t<wp::int64> var_tree__codes,
    wp::vec_t<3, wp::float32> var_tree__curve__low,
    wp::float32 var_tree__curve__scale,
    wp::int32 var_tree__curve__levels,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::int32 & adj_tree__count,
    wp::array_t<wp::int64> & adj_tree__codes,
    wp::vec_t<3, wp::float32> & adj_tree__curve__low,
    wp::float32 & adj_tree__curve__scale,
    wp::int32 & adj_tree__curve__levels,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
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


// <pointloom.kernels.poses.pose_fitness.count_flags>:1
static CUDA_CALLABLE void adj_count_flags_0(
    wp::vec_t<8, wp::int32> var_flags,
    wp::vec_t<8, wp::int32> & adj_flags,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.poses.pose_fitness.match_leaf>:1
static CUDA_CALLABLE void adj_match_leaf_0(
    wp::int32 var_first,
    wp::int32 var_tree__count,
    wp::array_t<wp::vec_t<3, wp::float32>> var_tree__points,
    wp::vec_t<8, wp::float32> var_xs,
    wp::vec_t<8, wp::float32> var_ys,
    wp::vec_t<8, wp::float32> var_zs,
    wp::float32 var_sqradius,
    wp::vec_t<8, wp::int32> var_matched,
    wp::int32 & adj_first,
    wp::int32 & adj_tree__count,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_tree__points,
    wp::vec_t<8, wp::float32> & adj_xs,
    wp::vec_t<8, wp::float32> & adj_ys,
    wp::vec_t<8, wp::float32> & adj_zs,
    wp::float32 & adj_sqradius,
    wp::vec_t<8, wp::int32> & adj_matched,
    wp::vec_t<8, wp::int32> & adj_ret)
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


// <pointloom.kernels.algebra.rigid_solve.jacobi_rotation>:1
static CUDA_CALLABLE void adj_jacobi_rotation_0(
    wp::float64 var_app,
    wp::float64 var_aqq,
    wp::float64 var_apq,
    wp::float64 & adj_app,
    wp::float64 & adj_aqq,
    wp::float64 & adj_apq,
    wp::vec_t<2, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.algebra.rigid_solve.diagonalize_four>:1
static CUDA_CALLABLE void adj_diagonalize_four_0(
    wp::vec_t<16, wp::float64> var_matrix,
    wp::vec_t<16, wp::float64> & adj_matrix,
    wp::vec_t<20, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/algebra/rigid_solve.py:134
static CUDA_CALLABLE void adj_largest_of_four_0(
    wp::vec_t<20, wp::float64> var_system,
    wp::vec_t<20, wp::float64> & adj_system,
    wp::vec_t<4, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.algebra.rigid_solve.rotation_about>:1
static CUDA_CALLABLE void adj_rotation_about_0(
    wp::float64 var_rx,
    wp::float64 var_ry,
    wp::float64 var_rz,
    wp::float64 var_rw,
    wp::float64 & adj_rx,
    wp::float64 & adj_ry,
    wp::float64 & adj_rz,
    wp::float64 & adj_rw,
    wp::mat_t<4, 4, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.algebra.rigid_solve.fit_pose>:1
static CUDA_CALLABLE void adj_fit_pose_0(
    wp::vec_t<18, wp::float64> var_sums,
    wp::int32 var_with_scaling,
    wp::vec_t<18, wp::float64> & adj_sums,
    wp::int32 & adj_with_scaling,
    wp::mat_t<4, 4, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void WP_MAXNREG(128) count_matched_kernel_184df708_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_fitness__source,
    wp::int32 var_fitness__tree__count,
    wp::int32 var_fitness__tree__root,
    wp::array_t<wp::int32> var_fitness__tree__levels,
    wp::array_t<wp::float32> var_fitness__tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> var_fitness__tree__points,
    wp::array_t<wp::int64> var_fitness__tree__codes,
    wp::vec_t<3, wp::float32> var_fitness__tree__curve__low,
    wp::float32 var_fitness__tree__curve__scale,
    wp::int32 var_fitness__tree__curve__levels,
    wp::vec_t<3, wp::float32> var_fitness__source_middle,
    wp::vec_t<3, wp::float32> var_fitness__target_middle,
    wp::int32 var_run,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_poses,
    wp::array_t<wp::int32> var_wanted,
    wp::float32 var_sqradius,
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
        wp::shape_t* var_1;
        const wp::int32 var_2 = 0;
        wp::int32 var_3;
        wp::shape_t var_4;
        const wp::int32 var_5 = 8;
        wp::int32 var_6;
        const wp::int32 var_7 = 1;
        wp::int32 var_8;
        wp::int32 var_9;
        wp::int32 var_10;
        const wp::int32 var_11 = 1;
        wp::int32 var_12;
        wp::int32 var_13;
        wp::int32 var_14;
        wp::int32* var_15;
        const wp::int32 var_16 = 0;
        bool var_17;
        wp::int32 var_18;
        wp::int32 var_19;
        wp::mat_t<4, 4, wp::float64>* var_20;
        wp::mat_t<4, 4, wp::float64> var_21;
        wp::mat_t<4, 4, wp::float64> var_22;
        const wp::int32 var_23 = 0;
        wp::int32 var_24;
        wp::int32 var_25;
        wp::int32 var_26;
        wp::int32 var_27;
        const wp::int32 var_28 = 1;
        wp::int32 var_29;
        wp::int32 var_30;
        wp::int32 var_31;
        wp::range_t var_32;
        wp::int32 var_33;
        wp::int32 var_34;
        wp::int32 var_35;
        wp::int32 var_36;
        wp::vec_t<3, wp::float32> var_37;
        const wp::float32 var_38 = 0.0;
        const wp::float32 var_39 = 0.0;
        const wp::float32 var_40 = 0.0;
        wp::vec_t<3, wp::float32> var_41;
        wp::vec_t<3, wp::float32> var_42;
        const wp::int32 var_43 = 0;
        wp::float32 var_44;
        wp::vec_t<8, wp::float32> var_45;
        const wp::int32 var_46 = 1;
        wp::float32 var_47;
        wp::vec_t<8, wp::float32> var_48;
        const wp::int32 var_49 = 2;
        wp::float32 var_50;
        wp::vec_t<8, wp::float32> var_51;
        const wp::int32 var_52 = 1;
        wp::range_t var_53;
        wp::int32 var_54;
        wp::int32 var_55;
        wp::vec_t<3, wp::float32> var_56;
        const wp::int32 var_57 = 0;
        wp::float32 var_58;
        const wp::int32 var_59 = 1;
        wp::float32 var_60;
        const wp::int32 var_61 = 2;
        wp::float32 var_62;
        const wp::int32 var_63 = 0;
        wp::float32 var_64;
        const wp::int32 var_65 = 0;
        wp::float32 var_66;
        wp::float32 var_67;
        const wp::int32 var_68 = 1;
        wp::float32 var_69;
        const wp::int32 var_70 = 1;
        wp::float32 var_71;
        wp::float32 var_72;
        const wp::int32 var_73 = 2;
        wp::float32 var_74;
        const wp::int32 var_75 = 2;
        wp::float32 var_76;
        wp::float32 var_77;
        wp::vec_t<3, wp::float32> var_78;
        const wp::int32 var_79 = 0;
        wp::float32 var_80;
        const wp::int32 var_81 = 0;
        wp::float32 var_82;
        wp::float32 var_83;
        const wp::int32 var_84 = 1;
        wp::float32 var_85;
        const wp::int32 var_86 = 1;
        wp::float32 var_87;
        wp::float32 var_88;
        const wp::int32 var_89 = 2;
        wp::float32 var_90;
        const wp::int32 var_91 = 2;
        wp::float32 var_92;
        wp::float32 var_93;
        wp::vec_t<3, wp::float32> var_94;
        const wp::int32 var_95 = 0;
        wp::vec_t<8, wp::int32> var_96;
        bool var_97;
        bool var_98;
        bool var_99;
        const wp::int32 var_100 = 8;
        wp::range_t var_101;
        wp::int32 var_102;
        const wp::int32 var_103 = 1;
        const wp::int32 var_104 = 0;
        wp::float32 var_105;
        const wp::int32 var_106 = 0;
        wp::float32 var_107;
        const wp::int32 var_108 = 0;
        wp::float32 var_109;
        wp::vec_t<3, wp::float32> var_110;
        wp::int32 var_111;
        wp::vec_t<4, wp::int64> var_112;
        const wp::int32 var_113 = 0;
        wp::int64 var_114;
        wp::int32 var_115;
        bool var_116;
        const wp::int32 var_117 = 2;
        wp::int64 var_118;
        wp::int32 var_119;
        wp::vec_t<8, wp::float32> var_120;
        wp::int32 var_121;
        wp::int32 var_122;
        const wp::int32 var_123 = 0;
        bool var_124;
        const wp::int32 var_125 = 0;
        bool var_126;
        wp::float32 var_127;
        bool var_128;
        const wp::int32 var_129 = 64;
        wp::int32 var_130;
        wp::int32 var_131;
        wp::int32 var_132;
        wp::vec_t<8, wp::int32> var_133;
        wp::int32 var_134;
        wp::int32 var_135;
        wp::vec_t<8, wp::int32> var_136;
        wp::int32 var_137;
        const wp::int32 var_138 = 1;
        bool var_139;
        const wp::int32 var_140 = 0;
        bool var_141;
        wp::float32 var_142;
        bool var_143;
        wp::int32 var_144;
        wp::int32 var_145;
        wp::int32 var_146;
        wp::vec_t<8, wp::int32> var_147;
        wp::int32 var_148;
        wp::int32 var_149;
        wp::vec_t<8, wp::int32> var_150;
        wp::int32 var_151;
        wp::int32 var_152;
        const wp::int32 var_153 = 2;
        bool var_154;
        const wp::int32 var_155 = 0;
        bool var_156;
        wp::float32 var_157;
        bool var_158;
        wp::int32 var_159;
        wp::int32 var_160;
        wp::int32 var_161;
        wp::vec_t<8, wp::int32> var_162;
        wp::int32 var_163;
        wp::int32 var_164;
        wp::vec_t<8, wp::int32> var_165;
        wp::int32 var_166;
        wp::int32 var_167;
        const wp::int32 var_168 = 3;
        bool var_169;
        const wp::int32 var_170 = 0;
        bool var_171;
        wp::float32 var_172;
        bool var_173;
        wp::int32 var_174;
        wp::int32 var_175;
        wp::int32 var_176;
        wp::vec_t<8, wp::int32> var_177;
        wp::int32 var_178;
        wp::int32 var_179;
        wp::vec_t<8, wp::int32> var_180;
        wp::int32 var_181;
        wp::int32 var_182;
        const wp::int32 var_183 = 4;
        bool var_184;
        const wp::int32 var_185 = 0;
        bool var_186;
        wp::float32 var_187;
        bool var_188;
        wp::int32 var_189;
        wp::int32 var_190;
        wp::int32 var_191;
        wp::vec_t<8, wp::int32> var_192;
        wp::int32 var_193;
        wp::int32 var_194;
        wp::vec_t<8, wp::int32> var_195;
        wp::int32 var_196;
        wp::int32 var_197;
        const wp::int32 var_198 = 5;
        bool var_199;
        const wp::int32 var_200 = 0;
        bool var_201;
        wp::float32 var_202;
        bool var_203;
        wp::int32 var_204;
        wp::int32 var_205;
        wp::int32 var_206;
        wp::vec_t<8, wp::int32> var_207;
        wp::int32 var_208;
        wp::int32 var_209;
        wp::vec_t<8, wp::int32> var_210;
        wp::int32 var_211;
        wp::int32 var_212;
        const wp::int32 var_213 = 6;
        bool var_214;
        const wp::int32 var_215 = 0;
        bool var_216;
        wp::float32 var_217;
        bool var_218;
        wp::int32 var_219;
        wp::int32 var_220;
        wp::int32 var_221;
        wp::vec_t<8, wp::int32> var_222;
        wp::int32 var_223;
        wp::int32 var_224;
        wp::vec_t<8, wp::int32> var_225;
        wp::int32 var_226;
        wp::int32 var_227;
        const wp::int32 var_228 = 7;
        bool var_229;
        const wp::int32 var_230 = 0;
        bool var_231;
        wp::float32 var_232;
        bool var_233;
        wp::int32 var_234;
        wp::int32 var_235;
        wp::int32 var_236;
        wp::vec_t<8, wp::int32> var_237;
        wp::int32 var_238;
        wp::int32 var_239;
        wp::vec_t<8, wp::int32> var_240;
        wp::int32 var_241;
        wp::int32 var_242;
        const wp::int32 var_243 = 0;
        bool var_244;
        wp::vec_t<4, wp::int64> var_245;
        const wp::int32 var_246 = 1;
        wp::int32 var_247;
        wp::int64 var_248;
        wp::int64 var_249;
        wp::int64 var_250;
        wp::int64 var_251;
        wp::vec_t<4, wp::int64> var_252;
        wp::vec_t<4, wp::int64> var_253;
        wp::int32 var_254;
        wp::int32 var_255;
        wp::int32 var_256;
        wp::int32 var_257;
        wp::int32 var_258;
        wp::int32 var_259;
        const wp::int32 var_260 = 0;
        bool var_261;
        wp::int32 var_262;
        wp::int32 var_263;
        //---------
        // forward
        // def count_matched_kernel(fitness__source, fitness__tree__count, fitness__tree__root, fitness__tree__levels, fitness__tree__boxes, fitness__tree__points, fitness__tree__codes, fitness__tree__curve__low, fitness__tree__curve__scale, fitness__tree__curve__levels, fitness__source_middle, fitness__target_middle, run, poses, wanted, sqradius, counts):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // source_count = fitness__source.shape[0]                                                <L 4>
        var_1 = &(var_fitness__source.shape);
        var_4 = wp::load(var_1);
        var_3 = wp::extract(var_4, var_2);
        // groups = (source_count + LEAF - 1) // LEAF                                             <L 5>
        var_6 = wp::add(var_3, var_5);
        var_8 = wp::sub(var_6, var_7);
        var_9 = wp::floordiv(var_8, var_5);
        // runs = (groups + run - 1) // run                                                       <L 6>
        var_10 = wp::add(var_9, var_run);
        var_12 = wp::sub(var_10, var_11);
        var_13 = wp::floordiv(var_12, var_run);
        // if wanted[i // runs] == 0:                                                             <L 7>
        var_14 = wp::floordiv(var_0, var_13);
        var_15 = wp::address(var_wanted, var_14);
        var_18 = wp::load(var_15);
        var_17 = (var_18 == var_16);
        if (var_17) {
            // return                                                                             <L 8>
            return;
        }
        // pose = poses[i // runs]                                                                <L 9>
        var_19 = wp::floordiv(var_0, var_13);
        var_20 = wp::address(var_poses, var_19);
        var_22 = wp::load(var_20);
        var_21 = wp::copy(var_22);
        // total = int(0)                                                                         <L 10>
        var_24 = wp::int(var_23);
        // for group in range(i % runs * run, min((i % runs + 1) * run, groups)):                 <L 11>
        var_25 = wp::mod(var_0, var_13);
        var_26 = wp::mul(var_25, var_run);
        var_27 = wp::mod(var_0, var_13);
        var_29 = wp::add(var_27, var_28);
        var_30 = wp::mul(var_29, var_run);
        var_31 = wp::min(var_30, var_9);
        var_32 = wp::range(var_26, var_31);
        start_for_1:;
            if (iter_cmp(var_32) == 0) goto end_for_1;
            var_33 = wp::iter_next(var_32);
            // head = group * LEAF                                                                <L 12>
            var_34 = wp::mul(var_33, var_5);
            // size = min(LEAF, source_count - head)                                              <L 13>
            var_35 = wp::sub(var_3, var_34);
            var_36 = wp::min(var_5, var_35);
            // a = moved_point(pose, head, fitness__source, fitness__source_middle, fitness__target_middle)       <L 14>
            var_37 = moved_point_0(var_21, var_34, var_fitness__source, var_fitness__source_middle, var_fitness__target_middle);
            // b = a + vec3(0.0, 0.0, 0.0)                                                        <L 15>
            var_41 = wp::vec_t<3, wp::float32>(var_38, var_39, var_40);
            var_42 = wp::add(var_37, var_41);
            // xs = lane_numbers(a[0])                                                            <L 16>
            var_44 = wp::extract(var_37, var_43);
            var_45 = wp::vec_t<8, wp::float32>(var_44);
            // ys = lane_numbers(a[1])                                                            <L 17>
            var_47 = wp::extract(var_37, var_46);
            var_48 = wp::vec_t<8, wp::float32>(var_47);
            // zs = lane_numbers(a[2])                                                            <L 18>
            var_50 = wp::extract(var_37, var_49);
            var_51 = wp::vec_t<8, wp::float32>(var_50);
            // for j in range(1, size):                                                           <L 19>
            var_53 = wp::range(var_52, var_36);
            start_for_3:;
                if (iter_cmp(var_53) == 0) goto end_for_3;
                var_54 = wp::iter_next(var_53);
                // p = moved_point(pose, head + j, fitness__source, fitness__source_middle, fitness__target_middle)       <L 20>
                var_55 = wp::add(var_34, var_54);
                var_56 = moved_point_0(var_21, var_55, var_fitness__source, var_fitness__source_middle, var_fitness__target_middle);
                // xs[j] = p[0]                                                                   <L 21>
                var_58 = wp::extract(var_56, var_57);
                wp::assign_inplace(var_45, var_54, var_58);
                // ys[j] = p[1]                                                                   <L 22>
                var_60 = wp::extract(var_56, var_59);
                wp::assign_inplace(var_48, var_54, var_60);
                // zs[j] = p[2]                                                                   <L 23>
                var_62 = wp::extract(var_56, var_61);
                wp::assign_inplace(var_51, var_54, var_62);
                // a = vec3(min(a[0], p[0]), min(a[1], p[1]), min(a[2], p[2]))                    <L 24>
                var_64 = wp::extract(var_37, var_63);
                var_66 = wp::extract(var_56, var_65);
                var_67 = wp::min(var_64, var_66);
                var_69 = wp::extract(var_37, var_68);
                var_71 = wp::extract(var_56, var_70);
                var_72 = wp::min(var_69, var_71);
                var_74 = wp::extract(var_37, var_73);
                var_76 = wp::extract(var_56, var_75);
                var_77 = wp::min(var_74, var_76);
                var_78 = wp::vec_t<3, wp::float32>(var_67, var_72, var_77);
                // b = vec3(max(b[0], p[0]), max(b[1], p[1]), max(b[2], p[2]))                    <L 25>
                var_80 = wp::extract(var_42, var_79);
                var_82 = wp::extract(var_56, var_81);
                var_83 = wp::max(var_80, var_82);
                var_85 = wp::extract(var_42, var_84);
                var_87 = wp::extract(var_56, var_86);
                var_88 = wp::max(var_85, var_87);
                var_90 = wp::extract(var_42, var_89);
                var_92 = wp::extract(var_56, var_91);
                var_93 = wp::max(var_90, var_92);
                var_94 = wp::vec_t<3, wp::float32>(var_83, var_88, var_93);
                wp::assign(var_37, var_78);
                wp::assign(var_42, var_94);
                goto start_for_3;
            end_for_3:;
            // matched = lane_flags(0)                                                            <L 26>
            var_96 = wp::vec_t<8, wp::int32>(var_95);
            // if isfinite(a) and isfinite(b):                                                    <L 27>
            var_98 = wp::isfinite(var_37);
            var_97 = var_98;
            if (var_97) {
                var_99 = wp::isfinite(var_42);
                var_97 = var_97 && var_99;
            }
            if (var_97) {
                // for j in range(size, LEAF):                                                    <L 28>
                var_101 = wp::range(var_36, var_100);
                start_for_5:;
                    if (iter_cmp(var_101) == 0) goto end_for_5;
                    var_102 = wp::iter_next(var_101);
                    // matched[j] = 1                                                             <L 29>
                    wp::assign_inplace(var_96, var_102, var_103);
                    goto start_for_5;
                end_for_5:;
                // step = start_traversal(find_bucket(vec3(xs[0], ys[0], zs[0]), fitness__tree__count, fitness__tree__codes, fitness__tree__curve__low, fitness__tree__curve__scale, fitness__tree__curve__levels))       <L 30>
                var_105 = wp::extract(var_45, var_104);
                var_107 = wp::extract(var_48, var_106);
                var_109 = wp::extract(var_51, var_108);
                var_110 = wp::vec_t<3, wp::float32>(var_105, var_107, var_109);
                var_111 = find_bucket_0(var_110, var_fitness__tree__count, var_fitness__tree__codes, var_fitness__tree__curve__low, var_fitness__tree__curve__scale, var_fitness__tree__curve__levels);
                var_112 = start_traversal_0(var_111);
                // while int(step[0]) <= fitness__tree__root:                                     <L 31>
        start_while_7:;
                var_114 = wp::extract(var_112, var_113);
                var_115 = wp::int(var_114);
                var_116 = (var_115 <= var_fitness__tree__root);
        if ((var_116) == false) goto end_while_7;
                    // bucket = int(step[2])                                                      <L 32>
                    var_118 = wp::extract(var_112, var_117);
                    var_119 = wp::int(var_118);
                    // distances = measure_boxes(fitness__tree__boxes, bucket, a, b)              <L 33>
                    var_120 = measure_boxes_0(var_fitness__tree__boxes, var_119, var_37, var_42);
                    // missing = LEAF - count_flags(matched)                                      <L 34>
                    var_121 = count_flags_0(var_96);
                    var_122 = wp::sub(var_5, var_121);
                    // for leaf in range(FAN):                                                    <L 35>
                    // if missing > 0 and distances[leaf] <= sqradius:                            <L 36>
                    var_126 = (var_122 > var_125);
                    var_124 = var_126;
                    if (var_124) {
                        var_127 = wp::extract(var_120, var_123);
                        var_128 = (var_127 <= var_sqradius);
                        var_124 = var_124 && var_128;
                    }
                    if (var_124) {
                        // first = bucket * BUCKET + leaf * LEAF                                  <L 37>
                        var_130 = wp::mul(var_119, var_129);
                        var_131 = wp::mul(var_123, var_5);
                        var_132 = wp::add(var_130, var_131);
                        // matched = match_leaf(first, fitness__tree__count, fitness__tree__points, xs, ys, zs, sqradius, matched)       <L 38>
                        var_133 = match_leaf_0(var_132, var_fitness__tree__count, var_fitness__tree__points, var_45, var_48, var_51, var_sqradius, var_96);
                        // missing = LEAF - count_flags(matched)                                  <L 39>
                        var_134 = count_flags_0(var_133);
                        var_135 = wp::sub(var_5, var_134);
                    }
                    var_136 = wp::where(var_124, var_133, var_96);
                    var_137 = wp::where(var_124, var_135, var_122);
                    // if missing > 0 and distances[leaf] <= sqradius:                            <L 36>
                    var_141 = (var_137 > var_140);
                    var_139 = var_141;
                    if (var_139) {
                        var_142 = wp::extract(var_120, var_138);
                        var_143 = (var_142 <= var_sqradius);
                        var_139 = var_139 && var_143;
                    }
                    if (var_139) {
                        // first = bucket * BUCKET + leaf * LEAF                                  <L 37>
                        var_144 = wp::mul(var_119, var_129);
                        var_145 = wp::mul(var_138, var_5);
                        var_146 = wp::add(var_144, var_145);
                        // matched = match_leaf(first, fitness__tree__count, fitness__tree__points, xs, ys, zs, sqradius, matched)       <L 38>
                        var_147 = match_leaf_0(var_146, var_fitness__tree__count, var_fitness__tree__points, var_45, var_48, var_51, var_sqradius, var_136);
                        // missing = LEAF - count_flags(matched)                                  <L 39>
                        var_148 = count_flags_0(var_147);
                        var_149 = wp::sub(var_5, var_148);
                    }
                    var_150 = wp::where(var_139, var_147, var_136);
                    var_151 = wp::where(var_139, var_149, var_137);
                    var_152 = wp::where(var_139, var_146, var_132);
                    // if missing > 0 and distances[leaf] <= sqradius:                            <L 36>
                    var_156 = (var_151 > var_155);
                    var_154 = var_156;
                    if (var_154) {
                        var_157 = wp::extract(var_120, var_153);
                        var_158 = (var_157 <= var_sqradius);
                        var_154 = var_154 && var_158;
                    }
                    if (var_154) {
                        // first = bucket * BUCKET + leaf * LEAF                                  <L 37>
                        var_159 = wp::mul(var_119, var_129);
                        var_160 = wp::mul(var_153, var_5);
                        var_161 = wp::add(var_159, var_160);
                        // matched = match_leaf(first, fitness__tree__count, fitness__tree__points, xs, ys, zs, sqradius, matched)       <L 38>
                        var_162 = match_leaf_0(var_161, var_fitness__tree__count, var_fitness__tree__points, var_45, var_48, var_51, var_sqradius, var_150);
                        // missing = LEAF - count_flags(matched)                                  <L 39>
                        var_163 = count_flags_0(var_162);
                        var_164 = wp::sub(var_5, var_163);
                    }
                    var_165 = wp::where(var_154, var_162, var_150);
                    var_166 = wp::where(var_154, var_164, var_151);
                    var_167 = wp::where(var_154, var_161, var_152);
                    // if missing > 0 and distances[leaf] <= sqradius:                            <L 36>
                    var_171 = (var_166 > var_170);
                    var_169 = var_171;
                    if (var_169) {
                        var_172 = wp::extract(var_120, var_168);
                        var_173 = (var_172 <= var_sqradius);
                        var_169 = var_169 && var_173;
                    }
                    if (var_169) {
                        // first = bucket * BUCKET + leaf * LEAF                                  <L 37>
                        var_174 = wp::mul(var_119, var_129);
                        var_175 = wp::mul(var_168, var_5);
                        var_176 = wp::add(var_174, var_175);
                        // matched = match_leaf(first, fitness__tree__count, fitness__tree__points, xs, ys, zs, sqradius, matched)       <L 38>
                        var_177 = match_leaf_0(var_176, var_fitness__tree__count, var_fitness__tree__points, var_45, var_48, var_51, var_sqradius, var_165);
                        // missing = LEAF - count_flags(matched)                                  <L 39>
                        var_178 = count_flags_0(var_177);
                        var_179 = wp::sub(var_5, var_178);
                    }
                    var_180 = wp::where(var_169, var_177, var_165);
                    var_181 = wp::where(var_169, var_179, var_166);
                    var_182 = wp::where(var_169, var_176, var_167);
                    // if missing > 0 and distances[leaf] <= sqradius:                            <L 36>
                    var_186 = (var_181 > var_185);
                    var_184 = var_186;
                    if (var_184) {
                        var_187 = wp::extract(var_120, var_183);
                        var_188 = (var_187 <= var_sqradius);
                        var_184 = var_184 && var_188;
                    }
                    if (var_184) {
                        // first = bucket * BUCKET + leaf * LEAF                                  <L 37>
                        var_189 = wp::mul(var_119, var_129);
                        var_190 = wp::mul(var_183, var_5);
                        var_191 = wp::add(var_189, var_190);
                        // matched = match_leaf(first, fitness__tree__count, fitness__tree__points, xs, ys, zs, sqradius, matched)       <L 38>
                        var_192 = match_leaf_0(var_191, var_fitness__tree__count, var_fitness__tree__points, var_45, var_48, var_51, var_sqradius, var_180);
                        // missing = LEAF - count_flags(matched)                                  <L 39>
                        var_193 = count_flags_0(var_192);
                        var_194 = wp::sub(var_5, var_193);
                    }
                    var_195 = wp::where(var_184, var_192, var_180);
                    var_196 = wp::where(var_184, var_194, var_181);
                    var_197 = wp::where(var_184, var_191, var_182);
                    // if missing > 0 and distances[leaf] <= sqradius:                            <L 36>
                    var_201 = (var_196 > var_200);
                    var_199 = var_201;
                    if (var_199) {
                        var_202 = wp::extract(var_120, var_198);
                        var_203 = (var_202 <= var_sqradius);
                        var_199 = var_199 && var_203;
                    }
                    if (var_199) {
                        // first = bucket * BUCKET + leaf * LEAF                                  <L 37>
                        var_204 = wp::mul(var_119, var_129);
                        var_205 = wp::mul(var_198, var_5);
                        var_206 = wp::add(var_204, var_205);
                        // matched = match_leaf(first, fitness__tree__count, fitness__tree__points, xs, ys, zs, sqradius, matched)       <L 38>
                        var_207 = match_leaf_0(var_206, var_fitness__tree__count, var_fitness__tree__points, var_45, var_48, var_51, var_sqradius, var_195);
                        // missing = LEAF - count_flags(matched)                                  <L 39>
                        var_208 = count_flags_0(var_207);
                        var_209 = wp::sub(var_5, var_208);
                    }
                    var_210 = wp::where(var_199, var_207, var_195);
                    var_211 = wp::where(var_199, var_209, var_196);
                    var_212 = wp::where(var_199, var_206, var_197);
                    // if missing > 0 and distances[leaf] <= sqradius:                            <L 36>
                    var_216 = (var_211 > var_215);
                    var_214 = var_216;
                    if (var_214) {
                        var_217 = wp::extract(var_120, var_213);
                        var_218 = (var_217 <= var_sqradius);
                        var_214 = var_214 && var_218;
                    }
                    if (var_214) {
                        // first = bucket * BUCKET + leaf * LEAF                                  <L 37>
                        var_219 = wp::mul(var_119, var_129);
                        var_220 = wp::mul(var_213, var_5);
                        var_221 = wp::add(var_219, var_220);
                        // matched = match_leaf(first, fitness__tree__count, fitness__tree__points, xs, ys, zs, sqradius, matched)       <L 38>
                        var_222 = match_leaf_0(var_221, var_fitness__tree__count, var_fitness__tree__points, var_45, var_48, var_51, var_sqradius, var_210);
                        // missing = LEAF - count_flags(matched)                                  <L 39>
                        var_223 = count_flags_0(var_222);
                        var_224 = wp::sub(var_5, var_223);
                    }
                    var_225 = wp::where(var_214, var_222, var_210);
                    var_226 = wp::where(var_214, var_224, var_211);
                    var_227 = wp::where(var_214, var_221, var_212);
                    // if missing > 0 and distances[leaf] <= sqradius:                            <L 36>
                    var_231 = (var_226 > var_230);
                    var_229 = var_231;
                    if (var_229) {
                        var_232 = wp::extract(var_120, var_228);
                        var_233 = (var_232 <= var_sqradius);
                        var_229 = var_229 && var_233;
                    }
                    if (var_229) {
                        // first = bucket * BUCKET + leaf * LEAF                                  <L 37>
                        var_234 = wp::mul(var_119, var_129);
                        var_235 = wp::mul(var_228, var_5);
                        var_236 = wp::add(var_234, var_235);
                        // matched = match_leaf(first, fitness__tree__count, fitness__tree__points, xs, ys, zs, sqradius, matched)       <L 38>
                        var_237 = match_leaf_0(var_236, var_fitness__tree__count, var_fitness__tree__points, var_45, var_48, var_51, var_sqradius, var_225);
                        // missing = LEAF - count_flags(matched)                                  <L 39>
                        var_238 = count_flags_0(var_237);
                        var_239 = wp::sub(var_5, var_238);
                    }
                    var_240 = wp::where(var_229, var_237, var_225);
                    var_241 = wp::where(var_229, var_239, var_226);
                    var_242 = wp::where(var_229, var_236, var_227);
                    // if missing > 0:                                                            <L 40>
                    var_244 = (var_241 > var_243);
                    if (var_244) {
                        // step = next_bucket(step, a, b, sqradius, fitness__tree__root, fitness__tree__levels, fitness__tree__boxes)       <L 41>
                        var_245 = next_bucket_0(var_112, var_37, var_42, var_sqradius, var_fitness__tree__root, var_fitness__tree__levels, var_fitness__tree__boxes);
                    }
                    if (!var_244) {
                        // step = traversal(int64(fitness__tree__root + 1), int64(0), int64(0), int64(0))       <L 43>
                        var_247 = wp::add(var_fitness__tree__root, var_246);
                        var_248 = wp::int64(var_247);
                        var_249 = 0ll;
                        var_250 = 0ll;
                        var_251 = 0ll;
                        var_252 = wp::vec_t<4, wp::int64>(var_248, var_249, var_250, var_251);
                    }
                    var_253 = wp::where(var_244, var_245, var_252);
                    wp::assign(var_96, var_240);
                    wp::assign(var_112, var_253);
        goto start_while_7;
        end_while_7:;
                // total += count_flags(matched) - (LEAF - size)                                  <L 44>
                var_254 = count_flags_0(var_96);
                var_255 = wp::sub(var_5, var_36);
                var_256 = wp::sub(var_254, var_255);
                var_257 = wp::add(var_24, var_256);
            }
            var_258 = wp::where(var_97, var_257, var_24);
            var_259 = wp::where(var_97, var_102, var_54);
            wp::assign(var_24, var_258);
            goto start_for_1;
        end_for_1:;
        // if total > 0:                                                                          <L 45>
        var_261 = (var_24 > var_260);
        if (var_261) {
            // atomic_add(counts, i // runs, total)                                               <L 46>
            var_262 = wp::floordiv(var_0, var_13);
            var_263 = wp::atomic_add(var_counts, var_262, var_24);
        }
}



extern "C" __global__ void WP_MAXNREG(128) judge_matches_kernel_ab158c52_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<19, wp::float64>> var_sums,
    wp::float64 var_limit,
    wp::int32 var_with_scaling,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_course__poses,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_course__best,
    wp::array_t<wp::int32> var_course__counts,
    wp::array_t<wp::float64> var_course__squares,
    wp::array_t<wp::float64> var_course__costs,
    wp::array_t<wp::int32> var_course__left,
    wp::array_t<wp::int32> var_course__running)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::vec_t<19, wp::float64>* var_1;
        wp::vec_t<19, wp::float64> var_2;
        wp::vec_t<19, wp::float64> var_3;
        const wp::int32 var_4 = 18;
        wp::float64 var_5;
        const wp::int32 var_6 = 0;
        wp::float64 var_7;
        wp::float64 var_8;
        wp::float64 var_9;
        const wp::int32 var_10 = 0;
        wp::float64* var_11;
        wp::float64 var_12;
        wp::float64 var_13;
        wp::float64 var_14;
        wp::float64 var_15;
        wp::float64 var_16;
        bool var_17;
        bool var_18;
        wp::mat_t<4, 4, wp::float64>* var_19;
        wp::mat_t<4, 4, wp::float64> var_20;
        wp::mat_t<4, 4, wp::float64> var_21;
        const wp::int32 var_22 = 0;
        wp::float64 var_23;
        wp::int32 var_24;
        wp::float64 var_25;
        wp::int32* var_26;
        const wp::int32 var_27 = 1;
        wp::int32 var_28;
        wp::int32 var_29;
        bool var_30;
        wp::int32* var_31;
        const wp::int32 var_32 = 0;
        bool var_33;
        wp::int32 var_34;
        const wp::int32 var_35 = 0;
        wp::float64 var_36;
        wp::float64 var_37;
        bool var_38;
        wp::float64 var_39;
        wp::vec_t<18, wp::float64> var_40;
        wp::int32 var_41;
        wp::int32 var_42;
        wp::float64 var_43;
        wp::mat_t<4, 4, wp::float64> var_44;
        const wp::int32 var_45 = 1;
        //---------
        // forward
        // def judge_matches_kernel(sums, limit, with_scaling, course__poses, course__best, course__counts, course__squares, course__costs, course__left, course__running):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // total = sums[i]                                                                        <L 4>
        var_1 = wp::address(var_sums, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // cost = total[SUMS] - total[0] * limit                                                  <L 5>
        var_5 = wp::extract(var_2, var_4);
        var_7 = wp::extract(var_2, var_6);
        var_8 = wp::mul(var_7, var_limit);
        var_9 = wp::sub(var_5, var_8);
        // course__running[i] = 0                                                                 <L 6>
        wp::array_store(var_course__running, var_0, var_10);
        // if not cost >= course__costs[i] - float64(STILL) * abs(cost):                          <L 7>
        var_11 = wp::address(var_course__costs, var_0);
        var_12 = 1e-06;
        var_13 = wp::abs(var_9);
        var_14 = wp::mul(var_12, var_13);
        var_16 = wp::load(var_11);
        var_15 = wp::sub(var_16, var_14);
        var_17 = (var_9 >= var_15);
        var_18 = wp::unot(var_17);
        if (var_18) {
            // course__best[i] = course__poses[i]                                                 <L 8>
            var_19 = wp::address(var_course__poses, var_0);
            var_21 = wp::load(var_19);
            var_20 = wp::copy(var_21);
            wp::array_store(var_course__best, var_0, var_20);
            // course__counts[i] = int(total[0])                                                  <L 9>
            var_23 = wp::extract(var_2, var_22);
            var_24 = wp::int(var_23);
            wp::array_store(var_course__counts, var_0, var_24);
            // course__squares[i] = total[SUMS]                                                   <L 10>
            var_25 = wp::extract(var_2, var_4);
            wp::array_store(var_course__squares, var_0, var_25);
            // course__costs[i] = cost                                                            <L 11>
            wp::array_store(var_course__costs, var_0, var_9);
            // course__left[i] = course__left[i] - 1                                              <L 12>
            var_26 = wp::address(var_course__left, var_0);
            var_29 = wp::load(var_26);
            var_28 = wp::sub(var_29, var_27);
            wp::array_store(var_course__left, var_0, var_28);
            // if course__left[i] > 0 and total[0] >= float64(MIN_PAIRS):                         <L 13>
            var_31 = wp::address(var_course__left, var_0);
            var_34 = wp::load(var_31);
            var_33 = (var_34 > var_32);
            var_30 = var_33;
            if (var_30) {
                var_36 = wp::extract(var_2, var_35);
                var_37 = 3;
                var_38 = (var_36 >= var_37);
                var_30 = var_30 && var_38;
            }
            if (var_30) {
                // s = pair_sums(float64(0.0))                                                    <L 14>
                var_39 = 0.0;
                var_40 = wp::vec_t<18, wp::float64>(var_39);
                // for k in range(SUMS):                                                          <L 15>
                var_41 = 0;
                start_for_0:;
                    if (var_41 >= 18) goto end_for_0;
                    var_42 = var_41;
                    var_41 += 1;
                    // s[k] = total[k]                                                            <L 16>
                    var_43 = wp::extract(var_2, var_42);
                    wp::assign_inplace(var_40, var_42, var_43);
                    goto start_for_0;
                end_for_0:;
                // course__poses[i] = fit_pose(s, with_scaling)                                   <L 17>
                var_44 = fit_pose_0(var_40, var_with_scaling);
                wp::array_store(var_course__poses, var_0, var_44);
                // course__running[i] = 1                                                         <L 18>
                wp::array_store(var_course__running, var_0, var_45);
            }
        }
}



extern "C" __global__ void move_points_kernel_bd405854_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_fitness__source,
    wp::vec_t<3, wp::float32> var_fitness__source_middle,
    wp::vec_t<3, wp::float32> var_fitness__target_middle,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_poses,
    wp::array_t<wp::vec_t<3, wp::float32>> var_moved)
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
        wp::mat_t<4, 4, wp::float64>* var_2;
        wp::vec_t<3, wp::float32> var_3;
        wp::mat_t<4, 4, wp::float64> var_4;
        //---------
        // forward
        // def move_points_kernel(fitness__source, fitness__source_middle, fitness__target_middle, poses, moved):       <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // moved[i] = moved_point(poses[0], i, fitness__source, fitness__source_middle, fitness__target_middle)       <L 3>
        var_2 = wp::address(var_poses, var_1);
        var_4 = wp::load(var_2);
        var_3 = moved_point_0(var_4, var_0, var_fitness__source, var_fitness__source_middle, var_fitness__target_middle);
        wp::array_store(var_moved, var_0, var_3);
}


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


// <pointloom.kernels.icp.matches.paired_target>:1
static CUDA_CALLABLE wp::vec_t<3, wp::float64> paired_target_0(
    wp::int32 var_i,
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__targets,
    wp::array_t<wp::int32> var_matches__pairs)
{
    //---------
    // primal vars
    wp::int32* var_0;
    wp::int32 var_1;
    wp::vec_t<3, wp::float32>* var_2;
    wp::vec_t<3, wp::float64> var_3;
    wp::vec_t<3, wp::float32> var_4;
    //---------
    // forward
    // def paired_target(i, matches__targets, matches__pairs):                                <L 1>
    // return widen(matches__targets[matches__pairs[i]])                                      <L 2>
    var_0 = wp::address(var_matches__pairs, var_i);
    var_1 = wp::load(var_0);
    var_2 = wp::address(var_matches__targets, var_1);
    var_4 = wp::load(var_2);
    var_3 = widen_0(var_4);
    return var_3;
}


// /work/main/src/pointloom/kernels/icp/rows.py:114
static CUDA_CALLABLE wp::vec_t<36, wp::float64> sum_row_0(
    wp::vec_t<3, wp::float64> var_u,
    wp::vec_t<3, wp::float64> var_v,
    wp::float64 var_r,
    wp::float64 var_w)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float64> var_0;
    wp::vec_t<3, wp::float64> var_1;
    wp::float64 var_2;
    const wp::int32 var_3 = 0;
    wp::float64 var_4;
    const wp::int32 var_5 = 0;
    wp::float64 var_6;
    wp::float64 var_7;
    const wp::int32 var_8 = 0;
    wp::float64 var_9;
    const wp::int32 var_10 = 1;
    wp::float64 var_11;
    wp::float64 var_12;
    const wp::int32 var_13 = 0;
    wp::float64 var_14;
    const wp::int32 var_15 = 2;
    wp::float64 var_16;
    wp::float64 var_17;
    const wp::int32 var_18 = 0;
    wp::float64 var_19;
    const wp::int32 var_20 = 0;
    wp::float64 var_21;
    wp::float64 var_22;
    const wp::int32 var_23 = 0;
    wp::float64 var_24;
    const wp::int32 var_25 = 1;
    wp::float64 var_26;
    wp::float64 var_27;
    const wp::int32 var_28 = 0;
    wp::float64 var_29;
    const wp::int32 var_30 = 2;
    wp::float64 var_31;
    wp::float64 var_32;
    const wp::int32 var_33 = 1;
    wp::float64 var_34;
    const wp::int32 var_35 = 1;
    wp::float64 var_36;
    wp::float64 var_37;
    const wp::int32 var_38 = 1;
    wp::float64 var_39;
    const wp::int32 var_40 = 2;
    wp::float64 var_41;
    wp::float64 var_42;
    const wp::int32 var_43 = 1;
    wp::float64 var_44;
    const wp::int32 var_45 = 0;
    wp::float64 var_46;
    wp::float64 var_47;
    const wp::int32 var_48 = 1;
    wp::float64 var_49;
    const wp::int32 var_50 = 1;
    wp::float64 var_51;
    wp::float64 var_52;
    const wp::int32 var_53 = 1;
    wp::float64 var_54;
    const wp::int32 var_55 = 2;
    wp::float64 var_56;
    wp::float64 var_57;
    const wp::int32 var_58 = 2;
    wp::float64 var_59;
    const wp::int32 var_60 = 2;
    wp::float64 var_61;
    wp::float64 var_62;
    const wp::int32 var_63 = 2;
    wp::float64 var_64;
    const wp::int32 var_65 = 0;
    wp::float64 var_66;
    wp::float64 var_67;
    const wp::int32 var_68 = 2;
    wp::float64 var_69;
    const wp::int32 var_70 = 1;
    wp::float64 var_71;
    wp::float64 var_72;
    const wp::int32 var_73 = 2;
    wp::float64 var_74;
    const wp::int32 var_75 = 2;
    wp::float64 var_76;
    wp::float64 var_77;
    const wp::int32 var_78 = 0;
    wp::float64 var_79;
    const wp::int32 var_80 = 0;
    wp::float64 var_81;
    wp::float64 var_82;
    const wp::int32 var_83 = 0;
    wp::float64 var_84;
    const wp::int32 var_85 = 1;
    wp::float64 var_86;
    wp::float64 var_87;
    const wp::int32 var_88 = 0;
    wp::float64 var_89;
    const wp::int32 var_90 = 2;
    wp::float64 var_91;
    wp::float64 var_92;
    const wp::int32 var_93 = 1;
    wp::float64 var_94;
    const wp::int32 var_95 = 1;
    wp::float64 var_96;
    wp::float64 var_97;
    const wp::int32 var_98 = 1;
    wp::float64 var_99;
    const wp::int32 var_100 = 2;
    wp::float64 var_101;
    wp::float64 var_102;
    const wp::int32 var_103 = 2;
    wp::float64 var_104;
    const wp::int32 var_105 = 2;
    wp::float64 var_106;
    wp::float64 var_107;
    const wp::int32 var_108 = 0;
    wp::float64 var_109;
    wp::float64 var_110;
    const wp::int32 var_111 = 1;
    wp::float64 var_112;
    wp::float64 var_113;
    const wp::int32 var_114 = 2;
    wp::float64 var_115;
    wp::float64 var_116;
    const wp::int32 var_117 = 0;
    wp::float64 var_118;
    wp::float64 var_119;
    const wp::int32 var_120 = 1;
    wp::float64 var_121;
    wp::float64 var_122;
    const wp::int32 var_123 = 2;
    wp::float64 var_124;
    wp::float64 var_125;
    wp::float64 var_126;
    wp::float64 var_127;
    wp::vec_t<36, wp::float64> var_128;
    //---------
    // forward
    // def sum_row(u: vec3d, v: vec3d, r: float64, w: float64) -> row_sums:                   <L 115>
    // a = w * u                                                                              <L 116>
    var_0 = wp::mul(var_w, var_u);
    // b = w * v                                                                              <L 117>
    var_1 = wp::mul(var_w, var_v);
    // z = float64(0.0)                                                                       <L 118>
    var_2 = 0.0;
    // return row_sums(                                                                       <L 119>
    // a[0] * u[0], a[0] * u[1], a[0] * u[2], a[0] * v[0], a[0] * v[1], a[0] * v[2],          <L 120>
    var_4 = wp::extract(var_0, var_3);
    var_6 = wp::extract(var_u, var_5);
    var_7 = wp::mul(var_4, var_6);
    var_9 = wp::extract(var_0, var_8);
    var_11 = wp::extract(var_u, var_10);
    var_12 = wp::mul(var_9, var_11);
    var_14 = wp::extract(var_0, var_13);
    var_16 = wp::extract(var_u, var_15);
    var_17 = wp::mul(var_14, var_16);
    var_19 = wp::extract(var_0, var_18);
    var_21 = wp::extract(var_v, var_20);
    var_22 = wp::mul(var_19, var_21);
    var_24 = wp::extract(var_0, var_23);
    var_26 = wp::extract(var_v, var_25);
    var_27 = wp::mul(var_24, var_26);
    var_29 = wp::extract(var_0, var_28);
    var_31 = wp::extract(var_v, var_30);
    var_32 = wp::mul(var_29, var_31);
    // a[1] * u[1], a[1] * u[2], a[1] * v[0], a[1] * v[1], a[1] * v[2],                       <L 121>
    var_34 = wp::extract(var_0, var_33);
    var_36 = wp::extract(var_u, var_35);
    var_37 = wp::mul(var_34, var_36);
    var_39 = wp::extract(var_0, var_38);
    var_41 = wp::extract(var_u, var_40);
    var_42 = wp::mul(var_39, var_41);
    var_44 = wp::extract(var_0, var_43);
    var_46 = wp::extract(var_v, var_45);
    var_47 = wp::mul(var_44, var_46);
    var_49 = wp::extract(var_0, var_48);
    var_51 = wp::extract(var_v, var_50);
    var_52 = wp::mul(var_49, var_51);
    var_54 = wp::extract(var_0, var_53);
    var_56 = wp::extract(var_v, var_55);
    var_57 = wp::mul(var_54, var_56);
    // a[2] * u[2], a[2] * v[0], a[2] * v[1], a[2] * v[2],                                    <L 122>
    var_59 = wp::extract(var_0, var_58);
    var_61 = wp::extract(var_u, var_60);
    var_62 = wp::mul(var_59, var_61);
    var_64 = wp::extract(var_0, var_63);
    var_66 = wp::extract(var_v, var_65);
    var_67 = wp::mul(var_64, var_66);
    var_69 = wp::extract(var_0, var_68);
    var_71 = wp::extract(var_v, var_70);
    var_72 = wp::mul(var_69, var_71);
    var_74 = wp::extract(var_0, var_73);
    var_76 = wp::extract(var_v, var_75);
    var_77 = wp::mul(var_74, var_76);
    // b[0] * v[0], b[0] * v[1], b[0] * v[2],                                                 <L 123>
    var_79 = wp::extract(var_1, var_78);
    var_81 = wp::extract(var_v, var_80);
    var_82 = wp::mul(var_79, var_81);
    var_84 = wp::extract(var_1, var_83);
    var_86 = wp::extract(var_v, var_85);
    var_87 = wp::mul(var_84, var_86);
    var_89 = wp::extract(var_1, var_88);
    var_91 = wp::extract(var_v, var_90);
    var_92 = wp::mul(var_89, var_91);
    // b[1] * v[1], b[1] * v[2],                                                              <L 124>
    var_94 = wp::extract(var_1, var_93);
    var_96 = wp::extract(var_v, var_95);
    var_97 = wp::mul(var_94, var_96);
    var_99 = wp::extract(var_1, var_98);
    var_101 = wp::extract(var_v, var_100);
    var_102 = wp::mul(var_99, var_101);
    // b[2] * v[2],                                                                           <L 125>
    var_104 = wp::extract(var_1, var_103);
    var_106 = wp::extract(var_v, var_105);
    var_107 = wp::mul(var_104, var_106);
    // a[0] * r, a[1] * r, a[2] * r, b[0] * r, b[1] * r, b[2] * r,                            <L 126>
    var_109 = wp::extract(var_0, var_108);
    var_110 = wp::mul(var_109, var_r);
    var_112 = wp::extract(var_0, var_111);
    var_113 = wp::mul(var_112, var_r);
    var_115 = wp::extract(var_0, var_114);
    var_116 = wp::mul(var_115, var_r);
    var_118 = wp::extract(var_1, var_117);
    var_119 = wp::mul(var_118, var_r);
    var_121 = wp::extract(var_1, var_120);
    var_122 = wp::mul(var_121, var_r);
    var_124 = wp::extract(var_1, var_123);
    var_125 = wp::mul(var_124, var_r);
    // w * r * r, z, z, z, z, z, z, z, z,                                                     <L 127>
    var_126 = wp::mul(var_w, var_r);
    var_127 = wp::mul(var_126, var_r);
    var_128 = wp::vec_t<36, wp::float64>({var_7, var_12, var_17, var_22, var_27, var_32, var_37, var_42, var_47, var_52, var_57, var_62, var_67, var_72, var_77, var_82, var_87, var_92, var_97, var_102, var_107, var_110, var_113, var_116, var_119, var_122, var_125, var_127, var_2, var_2, var_2, var_2, var_2, var_2, var_2, var_2});
    return var_128;
}


// <pointloom.kernels.icp.rows.sum_information_element>:1
static CUDA_CALLABLE wp::vec_t<36, wp::float64> sum_information_element_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__targets,
    wp::array_t<wp::int32> var_matches__pairs,
    wp::int32 var_i)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::vec_t<36, wp::float64> var_1;
    wp::int32* var_2;
    const wp::int32 var_3 = 0;
    bool var_4;
    wp::int32 var_5;
    wp::vec_t<3, wp::float64> var_6;
    wp::float64 var_7;
    wp::float64 var_8;
    const wp::int32 var_9 = 2;
    wp::float64 var_10;
    const wp::int32 var_11 = 1;
    wp::float64 var_12;
    wp::float64 var_13;
    wp::vec_t<3, wp::float64> var_14;
    wp::vec_t<3, wp::float64> var_15;
    wp::vec_t<36, wp::float64> var_16;
    wp::vec_t<36, wp::float64> var_17;
    const wp::int32 var_18 = 2;
    wp::float64 var_19;
    wp::float64 var_20;
    const wp::int32 var_21 = 0;
    wp::float64 var_22;
    wp::vec_t<3, wp::float64> var_23;
    wp::vec_t<3, wp::float64> var_24;
    wp::vec_t<36, wp::float64> var_25;
    wp::vec_t<36, wp::float64> var_26;
    const wp::int32 var_27 = 1;
    wp::float64 var_28;
    const wp::int32 var_29 = 0;
    wp::float64 var_30;
    wp::float64 var_31;
    wp::vec_t<3, wp::float64> var_32;
    wp::vec_t<3, wp::float64> var_33;
    wp::vec_t<36, wp::float64> var_34;
    wp::vec_t<36, wp::float64> var_35;
    const wp::int32 var_36 = 29;
    wp::vec_t<36, wp::float64> var_37;
    //---------
    // forward
    // def sum_information_element(matches__targets, matches__pairs, i):                      <L 1>
    // total = row_sums(float64(0.0))                                                         <L 2>
    var_0 = 0.0;
    var_1 = wp::vec_t<36, wp::float64>(var_0);
    // if matches__pairs[i] >= 0:                                                             <L 3>
    var_2 = wp::address(var_matches__pairs, var_i);
    var_5 = wp::load(var_2);
    var_4 = (var_5 >= var_3);
    if (var_4) {
        // q = paired_target(i, matches__targets, matches__pairs)                             <L 4>
        var_6 = paired_target_0(var_i, var_matches__targets, var_matches__pairs);
        // zero = float64(0.0)                                                                <L 5>
        var_7 = 0.0;
        // one = float64(1.0)                                                                 <L 6>
        var_8 = 1.0;
        // total += sum_row(vec3d(zero, q[2], -q[1]), vec3d(one, zero, zero), zero, one)       <L 7>
        var_10 = wp::extract(var_6, var_9);
        var_12 = wp::extract(var_6, var_11);
        var_13 = wp::neg(var_12);
        var_14 = wp::vec_t<3, wp::float64>(var_7, var_10, var_13);
        var_15 = wp::vec_t<3, wp::float64>(var_8, var_7, var_7);
        var_16 = sum_row_0(var_14, var_15, var_7, var_8);
        var_17 = wp::add(var_1, var_16);
        // total += sum_row(vec3d(-q[2], zero, q[0]), vec3d(zero, one, zero), zero, one)       <L 8>
        var_19 = wp::extract(var_6, var_18);
        var_20 = wp::neg(var_19);
        var_22 = wp::extract(var_6, var_21);
        var_23 = wp::vec_t<3, wp::float64>(var_20, var_7, var_22);
        var_24 = wp::vec_t<3, wp::float64>(var_7, var_8, var_7);
        var_25 = sum_row_0(var_23, var_24, var_7, var_8);
        var_26 = wp::add(var_17, var_25);
        // total += sum_row(vec3d(q[1], -q[0], zero), vec3d(zero, zero, one), zero, one)       <L 9>
        var_28 = wp::extract(var_6, var_27);
        var_30 = wp::extract(var_6, var_29);
        var_31 = wp::neg(var_30);
        var_32 = wp::vec_t<3, wp::float64>(var_28, var_31, var_7);
        var_33 = wp::vec_t<3, wp::float64>(var_7, var_7, var_8);
        var_34 = sum_row_0(var_32, var_33, var_7, var_8);
        var_35 = wp::add(var_26, var_34);
        // total[COUNT_AT] = one                                                              <L 10>
        wp::assign_inplace(var_35, var_36, var_8);
    }
    var_37 = wp::where(var_4, var_35, var_1);
    // return total                                                                           <L 11>
    return var_37;
}


// <pointloom.kernels.icp.jobs.source_position>:1
static CUDA_CALLABLE wp::int32 source_position_0(
    wp::int32 var_i,
    wp::array_t<wp::int32> var_jobs__sources__first_positions,
    wp::array_t<wp::int32> var_jobs__group_jobs,
    wp::array_t<wp::int32> var_jobs__job_groups,
    wp::array_t<wp::int32> var_jobs__job_sources)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 8;
    wp::int32 var_1;
    wp::int32* var_2;
    wp::int32 var_3;
    wp::int32 var_4;
    wp::int32* var_5;
    wp::int32 var_6;
    wp::int32* var_7;
    wp::int32 var_8;
    wp::int32 var_9;
    wp::int32* var_10;
    wp::int32 var_11;
    wp::int32 var_12;
    wp::int32 var_13;
    //---------
    // forward
    // def source_position(i, jobs__sources__first_positions, jobs__group_jobs, jobs__job_groups, jobs__job_sources):       <L 1>
    // job = jobs__group_jobs[i // LEAF]                                                      <L 2>
    var_1 = wp::floordiv(var_i, var_0);
    var_2 = wp::address(var_jobs__group_jobs, var_1);
    var_4 = wp::load(var_2);
    var_3 = wp::copy(var_4);
    // return jobs__sources__first_positions[jobs__job_sources[job]] + i - jobs__job_groups[job] * LEAF       <L 3>
    var_5 = wp::address(var_jobs__job_sources, var_3);
    var_6 = wp::load(var_5);
    var_7 = wp::address(var_jobs__sources__first_positions, var_6);
    var_9 = wp::load(var_7);
    var_8 = wp::add(var_9, var_i);
    var_10 = wp::address(var_jobs__job_groups, var_3);
    var_12 = wp::load(var_10);
    var_11 = wp::mul(var_12, var_0);
    var_13 = wp::sub(var_8, var_11);
    return var_13;
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


// <pointloom.kernels.icp.matches.moved_source>:1
static CUDA_CALLABLE wp::vec_t<3, wp::float64> moved_source_0(
    wp::int32 var_i,
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__jobs__sources__points,
    wp::array_t<wp::int32> var_matches__jobs__sources__first_positions,
    wp::array_t<wp::int32> var_matches__jobs__group_jobs,
    wp::array_t<wp::int32> var_matches__jobs__job_groups,
    wp::array_t<wp::int32> var_matches__jobs__job_sources,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_matches__poses)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 8;
    wp::int32 var_1;
    wp::int32* var_2;
    wp::int32 var_3;
    wp::int32 var_4;
    wp::mat_t<4, 4, wp::float64>* var_5;
    wp::int32 var_6;
    wp::vec_t<3, wp::float32>* var_7;
    wp::vec_t<3, wp::float64> var_8;
    wp::vec_t<3, wp::float32> var_9;
    wp::vec_t<3, wp::float64> var_10;
    wp::mat_t<4, 4, wp::float64> var_11;
    //---------
    // forward
    // def moved_source(i, matches__jobs__sources__points, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__poses):       <L 1>
    // job = matches__jobs__group_jobs[i // LEAF]                                             <L 2>
    var_1 = wp::floordiv(var_i, var_0);
    var_2 = wp::address(var_matches__jobs__group_jobs, var_1);
    var_4 = wp::load(var_2);
    var_3 = wp::copy(var_4);
    // return move(matches__poses[job], widen(matches__jobs__sources__points[source_position(i, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources)]))       <L 3>
    var_5 = wp::address(var_matches__poses, var_3);
    var_6 = source_position_0(var_i, var_matches__jobs__sources__first_positions, var_matches__jobs__group_jobs, var_matches__jobs__job_groups, var_matches__jobs__job_sources);
    var_7 = wp::address(var_matches__jobs__sources__points, var_6);
    var_9 = wp::load(var_7);
    var_8 = widen_0(var_9);
    var_11 = wp::load(var_5);
    var_10 = move_0(var_11, var_8);
    return var_10;
}


// <pointloom.kernels.icp.matches.pair_of>:1
static CUDA_CALLABLE void pair_of_0(
    wp::int32 var_i,
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__jobs__sources__points,
    wp::array_t<wp::int32> var_matches__jobs__sources__first_positions,
    wp::array_t<wp::int32> var_matches__jobs__group_jobs,
    wp::array_t<wp::int32> var_matches__jobs__job_groups,
    wp::array_t<wp::int32> var_matches__jobs__job_sources,
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__targets,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_matches__poses,
    wp::array_t<wp::int32> var_matches__pairs,
    wp::vec_t<3, wp::float64> & ret_0,
    wp::vec_t<3, wp::float64> & ret_1,
    wp::float64 & ret_2)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::vec_t<3, wp::float64> var_1;
    wp::float64 var_2;
    wp::vec_t<3, wp::float64> var_3;
    wp::float64 var_4;
    wp::int32* var_5;
    const wp::int32 var_6 = 0;
    bool var_7;
    wp::int32 var_8;
    wp::vec_t<3, wp::float64> var_9;
    wp::vec_t<3, wp::float64> var_10;
    wp::float64 var_11;
    wp::vec_t<3, wp::float64> var_12;
    wp::vec_t<3, wp::float64> var_13;
    wp::float64 var_14;
    //---------
    // forward
    // def pair_of(i, matches__jobs__sources__points, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__targets, matches__poses, matches__pairs):       <L 1>
    // p = vec3d(float64(0.0))                                                                <L 3>
    var_0 = 0.0;
    var_1 = wp::vec_t<3, wp::float64>(var_0);
    // q = vec3d(float64(0.0))                                                                <L 4>
    var_2 = 0.0;
    var_3 = wp::vec_t<3, wp::float64>(var_2);
    // paired = float64(0.0)                                                                  <L 5>
    var_4 = 0.0;
    // if matches__pairs[i] >= 0:                                                             <L 6>
    var_5 = wp::address(var_matches__pairs, var_i);
    var_8 = wp::load(var_5);
    var_7 = (var_8 >= var_6);
    if (var_7) {
        // p = moved_source(i, matches__jobs__sources__points, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__poses)       <L 7>
        var_9 = moved_source_0(var_i, var_matches__jobs__sources__points, var_matches__jobs__sources__first_positions, var_matches__jobs__group_jobs, var_matches__jobs__job_groups, var_matches__jobs__job_sources, var_matches__poses);
        // q = paired_target(i, matches__targets, matches__pairs)                             <L 8>
        var_10 = paired_target_0(var_i, var_matches__targets, var_matches__pairs);
        // paired = float64(1.0)                                                              <L 9>
        var_11 = 1.0;
    }
    var_12 = wp::where(var_7, var_9, var_1);
    var_13 = wp::where(var_7, var_10, var_3);
    var_14 = wp::where(var_7, var_11, var_4);
    // return (p, q, paired)                                                                  <L 10>
    ret_0 = var_12;
    ret_1 = var_13;
    ret_2 = var_14;
    return;
}


// <pointloom.kernels.icp.robust_weights.general_weight>:1
static CUDA_CALLABLE wp::float64 general_weight_0(
    wp::float64 var_r,
    wp::float64 var_k,
    wp::float64 var_shape)
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
    bool var_8;
    wp::float64 var_9;
    wp::float64 var_10;
    wp::float64 var_11;
    bool var_12;
    wp::float64 var_13;
    wp::float64 var_14;
    wp::float64 var_15;
    wp::float64 var_16;
    wp::float64 var_17;
    bool var_18;
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
    //---------
    // forward
    // def general_weight(r, k, shape):                                                       <L 1>
    // square = r / k * (r / k)                                                               <L 2>
    var_0 = wp::div(var_r, var_k);
    var_1 = wp::div(var_r, var_k);
    var_2 = wp::mul(var_0, var_1);
    // weight = float64(1.0)                                                                  <L 3>
    var_3 = 1.0;
    // if abs(shape - float64(2.0)) <= float64(TO_TWO):                                       <L 4>
    var_4 = 2.0;
    var_5 = wp::sub(var_shape, var_4);
    var_6 = wp::abs(var_5);
    var_7 = 0.002;
    var_8 = (var_6 <= var_7);
    if (var_8) {
        // weight = float64(1.0)                                                              <L 5>
        var_9 = 1.0;
    }
    if (!var_8) {
        // elif abs(shape) <= float64(TO_ZERO):                                               <L 6>
        var_10 = wp::abs(var_shape);
        var_11 = 1e-08;
        var_12 = (var_10 <= var_11);
        if (var_12) {
            // weight = float64(2.0) / (square + float64(2.0))                                <L 7>
            var_13 = 2.0;
            var_14 = 2.0;
            var_15 = wp::add(var_2, var_14);
            var_16 = wp::div(var_13, var_15);
        }
        if (!var_12) {
            // elif shape < float64(MINUS_INFINITY):                                          <L 8>
            var_17 = -10000000.0;
            var_18 = (var_shape < var_17);
            if (var_18) {
                // weight = exp(-float64(0.5) * square)                                       <L 9>
                var_19 = 0.5;
                var_20 = wp::neg(var_19);
                var_21 = wp::mul(var_20, var_2);
                var_22 = wp::exp(var_21);
            }
            if (!var_18) {
                // base = square / abs(shape - float64(2.0)) + float64(1.0)                   <L 11>
                var_23 = 2.0;
                var_24 = wp::sub(var_shape, var_23);
                var_25 = wp::abs(var_24);
                var_26 = wp::div(var_2, var_25);
                var_27 = 1.0;
                var_28 = wp::add(var_26, var_27);
                // weight = pow(base, float64(0.5) * shape - float64(1.0))                    <L 12>
                var_29 = 0.5;
                var_30 = wp::mul(var_29, var_shape);
                var_31 = 1.0;
                var_32 = wp::sub(var_30, var_31);
                var_33 = wp::pow(var_28, var_32);
            }
            var_34 = wp::where(var_18, var_22, var_33);
        }
        var_35 = wp::where(var_12, var_16, var_34);
    }
    var_36 = wp::where(var_8, var_9, var_35);
    // return weight / (k * k)                                                                <L 13>
    var_37 = wp::mul(var_k, var_k);
    var_38 = wp::div(var_36, var_37);
    return var_38;
}


// <pointloom.kernels.icp.robust_weights.robust_weight>:1
static CUDA_CALLABLE wp::float64 robust_weight_0(
    wp::int32 var_loss__kind,
    wp::float64 var_loss__k,
    wp::float64 var_loss__shape,
    wp::float64 var_r)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::float64 var_1;
    const wp::int32 var_2 = 1;
    bool var_3;
    wp::float64 var_4;
    wp::float64 var_5;
    wp::float64 var_6;
    wp::float64 var_7;
    wp::float64 var_8;
    const wp::int32 var_9 = 2;
    bool var_10;
    wp::float64 var_11;
    wp::float64 var_12;
    wp::float64 var_13;
    const wp::int32 var_14 = 3;
    bool var_15;
    wp::float64 var_16;
    wp::float64 var_17;
    wp::float64 var_18;
    wp::float64 var_19;
    wp::float64 var_20;
    wp::float64 var_21;
    wp::float64 var_22;
    wp::float64 var_23;
    const wp::int32 var_24 = 4;
    bool var_25;
    wp::float64 var_26;
    wp::float64 var_27;
    wp::float64 var_28;
    wp::float64 var_29;
    wp::float64 var_30;
    wp::float64 var_31;
    wp::float64 var_32;
    const wp::int32 var_33 = 5;
    bool var_34;
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
    const wp::int32 var_46 = 6;
    bool var_47;
    wp::float64 var_48;
    wp::float64 var_49;
    //---------
    // forward
    // def robust_weight(loss__kind, loss__k, loss__shape, r):                                <L 1>
    // size = abs(r)                                                                          <L 2>
    var_0 = wp::abs(var_r);
    // weight = float64(1.0)                                                                  <L 3>
    var_1 = 1.0;
    // if loss__kind == L1:                                                                   <L 4>
    var_3 = (var_loss__kind == var_2);
    if (var_3) {
        // weight = float64(1.0) / max(size, float64(MIN_RESIDUAL))                           <L 5>
        var_4 = 1.0;
        var_5 = 1e-09;
        var_6 = wp::max(var_0, var_5);
        var_7 = wp::div(var_4, var_6);
    }
    var_8 = wp::where(var_3, var_7, var_1);
    // if loss__kind == HUBER:                                                                <L 6>
    var_10 = (var_loss__kind == var_9);
    if (var_10) {
        // weight = loss__k / max(size, loss__k)                                              <L 7>
        var_11 = wp::max(var_0, var_loss__k);
        var_12 = wp::div(var_loss__k, var_11);
    }
    var_13 = wp::where(var_10, var_12, var_8);
    // if loss__kind == CAUCHY:                                                               <L 8>
    var_15 = (var_loss__kind == var_14);
    if (var_15) {
        // weight = float64(1.0) / (float64(1.0) + r / loss__k * (r / loss__k))               <L 9>
        var_16 = 1.0;
        var_17 = 1.0;
        var_18 = wp::div(var_r, var_loss__k);
        var_19 = wp::div(var_r, var_loss__k);
        var_20 = wp::mul(var_18, var_19);
        var_21 = wp::add(var_17, var_20);
        var_22 = wp::div(var_16, var_21);
    }
    var_23 = wp::where(var_15, var_22, var_13);
    // if loss__kind == GEMAN_MCCLURE:                                                        <L 10>
    var_25 = (var_loss__kind == var_24);
    if (var_25) {
        // weight = loss__k / ((loss__k + r * r) * (loss__k + r * r))                         <L 11>
        var_26 = wp::mul(var_r, var_r);
        var_27 = wp::add(var_loss__k, var_26);
        var_28 = wp::mul(var_r, var_r);
        var_29 = wp::add(var_loss__k, var_28);
        var_30 = wp::mul(var_27, var_29);
        var_31 = wp::div(var_loss__k, var_30);
    }
    var_32 = wp::where(var_25, var_31, var_23);
    // if loss__kind == TUKEY:                                                                <L 12>
    var_34 = (var_loss__kind == var_33);
    if (var_34) {
        // rest = float64(1.0) - min(float64(1.0), size / loss__k) * min(float64(1.0), size / loss__k)       <L 13>
        var_35 = 1.0;
        var_36 = 1.0;
        var_37 = wp::div(var_0, var_loss__k);
        var_38 = wp::min(var_36, var_37);
        var_39 = 1.0;
        var_40 = wp::div(var_0, var_loss__k);
        var_41 = wp::min(var_39, var_40);
        var_42 = wp::mul(var_38, var_41);
        var_43 = wp::sub(var_35, var_42);
        // weight = rest * rest                                                               <L 14>
        var_44 = wp::mul(var_43, var_43);
    }
    var_45 = wp::where(var_34, var_44, var_32);
    // if loss__kind == GENERAL:                                                              <L 15>
    var_47 = (var_loss__kind == var_46);
    if (var_47) {
        // weight = general_weight(r, loss__k, loss__shape)                                   <L 16>
        var_48 = general_weight_0(var_r, var_loss__k, var_loss__shape);
    }
    var_49 = wp::where(var_47, var_48, var_45);
    // return weight                                                                          <L 17>
    return var_49;
}


// <pointloom.kernels.icp.matches.weight_of>:1
static CUDA_CALLABLE wp::float64 weight_of_2(
    wp::int32 var_i,
    wp::array_t<wp::int32> var_matches__jobs__sources__first_positions,
    wp::array_t<wp::int32> var_matches__jobs__group_jobs,
    wp::array_t<wp::int32> var_matches__jobs__job_groups,
    wp::array_t<wp::int32> var_matches__jobs__job_sources,
    wp::int32 var_matches__weighted,
    wp::array_t<wp::float32> var_matches__weights)
{
    //---------
    // primal vars
    wp::float64 var_0;
    const wp::int32 var_1 = 0;
    bool var_2;
    wp::int32 var_3;
    const wp::int32 var_4 = 0;
    wp::float32* var_5;
    wp::float64 var_6;
    wp::float32 var_7;
    wp::float64 var_8;
    //---------
    // forward
    // def weight_of(i, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__weighted, matches__weights):       <L 1>
    // weight = float64(1.0)                                                                  <L 2>
    var_0 = 1.0;
    // if matches__weighted != 0:                                                             <L 3>
    var_2 = (var_matches__weighted != var_1);
    if (var_2) {
        // weight = float64(matches__weights[source_position(i, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources), 0])       <L 4>
        var_3 = source_position_0(var_i, var_matches__jobs__sources__first_positions, var_matches__jobs__group_jobs, var_matches__jobs__job_groups, var_matches__jobs__job_sources);
        var_5 = wp::address(var_matches__weights, var_3, var_4);
        var_7 = wp::load(var_5);
        var_6 = wp::float64(var_7);
    }
    var_8 = wp::where(var_2, var_6, var_0);
    // return weight                                                                          <L 5>
    return var_8;
}


// /work/main/src/pointloom/kernels/icp/rows.py:178
static CUDA_CALLABLE wp::vec_t<36, wp::float64> count_pair_0(
    wp::vec_t<36, wp::float64> var_sums,
    wp::vec_t<3, wp::float64> var_p,
    wp::vec_t<3, wp::float64> var_q,
    wp::float64 var_paired)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float64> var_0;
    wp::vec_t<36, wp::float64> var_1;
    wp::float64 var_2;
    const wp::int32 var_3 = 28;
    const wp::int32 var_4 = 29;
    const wp::int32 var_5 = 0;
    wp::float64 var_6;
    const wp::int32 var_7 = 30;
    wp::int32 var_8;
    wp::float64 var_9;
    const wp::int32 var_10 = 33;
    wp::int32 var_11;
    const wp::int32 var_12 = 1;
    wp::float64 var_13;
    wp::int32 var_14;
    wp::float64 var_15;
    wp::int32 var_16;
    const wp::int32 var_17 = 2;
    wp::float64 var_18;
    wp::int32 var_19;
    wp::float64 var_20;
    wp::int32 var_21;
    //---------
    // forward
    // def count_pair(sums: row_sums, p: vec3d, q: vec3d, paired: float64) -> row_sums:       <L 179>
    // d = p - q                                                                              <L 181>
    var_0 = wp::sub(var_p, var_q);
    // counted = sums                                                                         <L 182>
    var_1 = wp::copy(var_sums);
    // counted[DISTANCE_AT] = dot(d, d)                                                       <L 183>
    var_2 = wp::dot(var_0, var_0);
    wp::assign_inplace(var_1, var_3, var_2);
    // counted[COUNT_AT] = paired                                                             <L 184>
    wp::assign_inplace(var_1, var_4, var_paired);
    // for axis in range(3):                                                                  <L 185>
    // counted[SOURCE_AT + axis] = p[axis]                                                    <L 186>
    var_6 = wp::extract(var_p, var_5);
    var_8 = wp::add(var_7, var_5);
    wp::assign_inplace(var_1, var_8, var_6);
    // counted[TARGET_AT + axis] = q[axis]                                                    <L 187>
    var_9 = wp::extract(var_q, var_5);
    var_11 = wp::add(var_10, var_5);
    wp::assign_inplace(var_1, var_11, var_9);
    // counted[SOURCE_AT + axis] = p[axis]                                                    <L 186>
    var_13 = wp::extract(var_p, var_12);
    var_14 = wp::add(var_7, var_12);
    wp::assign_inplace(var_1, var_14, var_13);
    // counted[TARGET_AT + axis] = q[axis]                                                    <L 187>
    var_15 = wp::extract(var_q, var_12);
    var_16 = wp::add(var_10, var_12);
    wp::assign_inplace(var_1, var_16, var_15);
    // counted[SOURCE_AT + axis] = p[axis]                                                    <L 186>
    var_18 = wp::extract(var_p, var_17);
    var_19 = wp::add(var_7, var_17);
    wp::assign_inplace(var_1, var_19, var_18);
    // counted[TARGET_AT + axis] = q[axis]                                                    <L 187>
    var_20 = wp::extract(var_q, var_17);
    var_21 = wp::add(var_10, var_17);
    wp::assign_inplace(var_1, var_21, var_20);
    // return counted                                                                         <L 188>
    return var_1;
}


// <pointloom.kernels.icp.rows.sum_colored_rows_element>:1
static CUDA_CALLABLE wp::vec_t<36, wp::float64> sum_colored_rows_element_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__jobs__sources__points,
    wp::array_t<wp::int32> var_matches__jobs__sources__first_positions,
    wp::array_t<wp::int32> var_matches__jobs__group_jobs,
    wp::array_t<wp::int32> var_matches__jobs__job_groups,
    wp::array_t<wp::int32> var_matches__jobs__job_sources,
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__targets,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_matches__poses,
    wp::array_t<wp::int32> var_matches__pairs,
    wp::int32 var_matches__weighted,
    wp::array_t<wp::float32> var_matches__weights,
    wp::int32 var_loss__kind,
    wp::float64 var_loss__k,
    wp::float64 var_loss__shape,
    wp::array_t<wp::float32> var_source__intensities,
    wp::array_t<wp::vec_t<3, wp::float32>> var_target__normals,
    wp::array_t<wp::float32> var_target__intensities,
    wp::array_t<wp::vec_t<3, wp::float32>> var_target__gradients,
    wp::float64 var_geometric_share,
    wp::int32 var_i)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float64> var_0;
    wp::vec_t<3, wp::float64> var_1;
    wp::float64 var_2;
    wp::float64 var_3;
    wp::vec_t<3, wp::float64> var_4;
    wp::float64 var_5;
    wp::vec_t<3, wp::float64> var_6;
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
    wp::int32 var_17;
    wp::int32* var_18;
    wp::int32 var_19;
    wp::vec_t<3, wp::float32>* var_20;
    wp::vec_t<3, wp::float64> var_21;
    wp::vec_t<3, wp::float32> var_22;
    wp::int32* var_23;
    wp::int32 var_24;
    wp::vec_t<3, wp::float32>* var_25;
    wp::vec_t<3, wp::float64> var_26;
    wp::vec_t<3, wp::float32> var_27;
    wp::vec_t<3, wp::float64> var_28;
    wp::float64 var_29;
    wp::float64 var_30;
    wp::float64 var_31;
    wp::float64 var_32;
    wp::float64 var_33;
    wp::int32* var_34;
    const wp::int32 var_35 = 0;
    wp::int32 var_36;
    wp::float32* var_37;
    wp::float64 var_38;
    wp::float32 var_39;
    wp::vec_t<3, wp::float64> var_40;
    wp::vec_t<3, wp::float64> var_41;
    wp::vec_t<3, wp::float64> var_42;
    wp::float64 var_43;
    wp::float64 var_44;
    const wp::int32 var_45 = 0;
    wp::float32* var_46;
    wp::float64 var_47;
    wp::float32 var_48;
    wp::float64 var_49;
    wp::float64 var_50;
    wp::float64 var_51;
    wp::float64 var_52;
    wp::float64 var_53;
    wp::float64 var_54;
    wp::vec_t<3, wp::float64> var_55;
    wp::vec_t<3, wp::float64> var_56;
    wp::vec_t<3, wp::float64> var_57;
    wp::vec_t<3, wp::float64> var_58;
    wp::vec_t<3, wp::float64> var_59;
    wp::float64 var_60;
    wp::float64 var_61;
    wp::float64 var_62;
    wp::float64 var_63;
    wp::vec_t<3, wp::float64> var_64;
    wp::vec_t<3, wp::float64> var_65;
    wp::vec_t<3, wp::float64> var_66;
    wp::vec_t<36, wp::float64> var_67;
    wp::vec_t<3, wp::float64> var_68;
    wp::vec_t<3, wp::float64> var_69;
    wp::vec_t<3, wp::float64> var_70;
    wp::vec_t<36, wp::float64> var_71;
    wp::vec_t<36, wp::float64> var_72;
    wp::vec_t<36, wp::float64> var_73;
    //---------
    // forward
    // def sum_colored_rows_element(matches__jobs__sources__points, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__targets, matches__poses, matches__pairs, matches__weighted, matches__weights, loss__kind, loss__k, loss__shape, source__intensities, target__normals, target__intensities, target__gradients, geometric_share, i):       <L 1>
    // p, q, paired = pair_of(i, matches__jobs__sources__points, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__targets, matches__poses, matches__pairs)       <L 2>
    pair_of_0(var_i, var_matches__jobs__sources__points, var_matches__jobs__sources__first_positions, var_matches__jobs__group_jobs, var_matches__jobs__job_groups, var_matches__jobs__job_sources, var_matches__targets, var_matches__poses, var_matches__pairs, var_0, var_1, var_2);
    // n = vec3d(float64(0.0))                                                                <L 3>
    var_3 = 0.0;
    var_4 = wp::vec_t<3, wp::float64>(var_3);
    // h = vec3d(float64(0.0))                                                                <L 4>
    var_5 = 0.0;
    var_6 = wp::vec_t<3, wp::float64>(var_5);
    // r = float64(0.0)                                                                       <L 5>
    var_7 = 0.0;
    // s = float64(0.0)                                                                       <L 6>
    var_8 = 0.0;
    // w = float64(0.0)                                                                       <L 7>
    var_9 = 0.0;
    // y = float64(0.0)                                                                       <L 8>
    var_10 = 0.0;
    // geometric = sqrt(geometric_share)                                                      <L 9>
    var_11 = wp::sqrt(var_geometric_share);
    // photometric = sqrt(float64(1.0) - geometric_share)                                     <L 10>
    var_12 = 1.0;
    var_13 = wp::sub(var_12, var_geometric_share);
    var_14 = wp::sqrt(var_13);
    // if paired > float64(0.0):                                                              <L 11>
    var_15 = 0.0;
    var_16 = (var_2 > var_15);
    if (var_16) {
        // at = source_position(i, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources)       <L 12>
        var_17 = source_position_0(var_i, var_matches__jobs__sources__first_positions, var_matches__jobs__group_jobs, var_matches__jobs__job_groups, var_matches__jobs__job_sources);
        // n = widen(target__normals[matches__pairs[i]])                                      <L 13>
        var_18 = wp::address(var_matches__pairs, var_i);
        var_19 = wp::load(var_18);
        var_20 = wp::address(var_target__normals, var_19);
        var_22 = wp::load(var_20);
        var_21 = widen_0(var_22);
        // g = widen(target__gradients[matches__pairs[i]])                                    <L 14>
        var_23 = wp::address(var_matches__pairs, var_i);
        var_24 = wp::load(var_23);
        var_25 = wp::address(var_target__gradients, var_24);
        var_27 = wp::load(var_25);
        var_26 = widen_0(var_27);
        // height = dot(p - q, n)                                                             <L 15>
        var_28 = wp::sub(var_0, var_1);
        var_29 = wp::dot(var_28, var_21);
        // r = geometric * height                                                             <L 16>
        var_30 = wp::mul(var_11, var_29);
        // w = robust_weight(loss__kind, loss__k, loss__shape, r) * weight_of(i, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__weighted, matches__weights)       <L 17>
        var_31 = robust_weight_0(var_loss__kind, var_loss__k, var_loss__shape, var_30);
        var_32 = weight_of_2(var_i, var_matches__jobs__sources__first_positions, var_matches__jobs__group_jobs, var_matches__jobs__job_groups, var_matches__jobs__job_sources, var_matches__weighted, var_matches__weights);
        var_33 = wp::mul(var_31, var_32);
        // expected = float64(target__intensities[matches__pairs[i], 0]) + dot(g, p - height * n - q)       <L 18>
        var_34 = wp::address(var_matches__pairs, var_i);
        var_36 = wp::load(var_34);
        var_37 = wp::address(var_target__intensities, var_36, var_35);
        var_39 = wp::load(var_37);
        var_38 = wp::float64(var_39);
        var_40 = wp::mul(var_29, var_21);
        var_41 = wp::sub(var_0, var_40);
        var_42 = wp::sub(var_41, var_1);
        var_43 = wp::dot(var_26, var_42);
        var_44 = wp::add(var_38, var_43);
        // s = photometric * (float64(source__intensities[at, 0]) - expected)                 <L 19>
        var_46 = wp::address(var_source__intensities, var_17, var_45);
        var_48 = wp::load(var_46);
        var_47 = wp::float64(var_48);
        var_49 = wp::sub(var_47, var_44);
        var_50 = wp::mul(var_14, var_49);
        // y = robust_weight(loss__kind, loss__k, loss__shape, s) * weight_of(i, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__weighted, matches__weights)       <L 20>
        var_51 = robust_weight_0(var_loss__kind, var_loss__k, var_loss__shape, var_50);
        var_52 = weight_of_2(var_i, var_matches__jobs__sources__first_positions, var_matches__jobs__group_jobs, var_matches__jobs__job_groups, var_matches__jobs__job_sources, var_matches__weighted, var_matches__weights);
        var_53 = wp::mul(var_51, var_52);
        // h = -(g - dot(g, n) * n)                                                           <L 21>
        var_54 = wp::dot(var_26, var_21);
        var_55 = wp::mul(var_54, var_21);
        var_56 = wp::sub(var_26, var_55);
        var_57 = wp::neg(var_56);
    }
    var_58 = wp::where(var_16, var_21, var_4);
    var_59 = wp::where(var_16, var_57, var_6);
    var_60 = wp::where(var_16, var_30, var_7);
    var_61 = wp::where(var_16, var_50, var_8);
    var_62 = wp::where(var_16, var_33, var_9);
    var_63 = wp::where(var_16, var_53, var_10);
    // total = sum_row(geometric * cross(p, n), geometric * n, r, w)                          <L 22>
    var_64 = wp::cross(var_0, var_58);
    var_65 = wp::mul(var_11, var_64);
    var_66 = wp::mul(var_11, var_58);
    var_67 = sum_row_0(var_65, var_66, var_60, var_62);
    // total += sum_row(photometric * cross(p, h), photometric * h, s, y)                     <L 23>
    var_68 = wp::cross(var_0, var_59);
    var_69 = wp::mul(var_14, var_68);
    var_70 = wp::mul(var_14, var_59);
    var_71 = sum_row_0(var_69, var_70, var_61, var_63);
    var_72 = wp::add(var_67, var_71);
    // return count_pair(total, p, q, paired)                                                 <L 24>
    var_73 = count_pair_0(var_72, var_0, var_1, var_2);
    return var_73;
}


// <pointloom.kernels.icp.rows.sum_doppler_rows_element>:1
static CUDA_CALLABLE wp::vec_t<36, wp::float64> sum_doppler_rows_element_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__jobs__sources__points,
    wp::array_t<wp::int32> var_matches__jobs__sources__first_positions,
    wp::array_t<wp::int32> var_matches__jobs__group_jobs,
    wp::array_t<wp::int32> var_matches__jobs__job_groups,
    wp::array_t<wp::int32> var_matches__jobs__job_sources,
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__targets,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_matches__poses,
    wp::array_t<wp::int32> var_matches__pairs,
    wp::int32 var_matches__weighted,
    wp::array_t<wp::float32> var_matches__weights,
    wp::int32 var_loss__kind,
    wp::float64 var_loss__k,
    wp::float64 var_loss__shape,
    wp::array_t<wp::float32> var_source__dopplers,
    wp::array_t<wp::vec_t<3, wp::float32>> var_source__directions,
    wp::array_t<wp::vec_t<3, wp::float32>> var_target__normals,
    wp::array_t<wp::vec_t<6, wp::float64>> var_velocities,
    wp::array_t<wp::int32> var_iterations,
    wp::vec_t<3, wp::float64> var_rule__sensor,
    wp::float64 var_rule__period,
    wp::float64 var_rule__share,
    wp::int32 var_rule__loss__kind,
    wp::float64 var_rule__loss__k,
    wp::float64 var_rule__loss__shape,
    wp::int32 var_rule__geometric_from,
    wp::int32 var_rule__doppler_from,
    wp::int32 var_rule__reject_from,
    wp::float64 var_rule__threshold,
    wp::int32 var_i)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float64> var_0;
    wp::vec_t<3, wp::float64> var_1;
    wp::float64 var_2;
    wp::float64 var_3;
    wp::vec_t<3, wp::float64> var_4;
    wp::float64 var_5;
    wp::vec_t<3, wp::float64> var_6;
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
    const wp::int32 var_17 = 8;
    wp::int32 var_18;
    wp::int32* var_19;
    wp::int32 var_20;
    wp::int32 var_21;
    wp::int32 var_22;
    wp::vec_t<3, wp::float32>* var_23;
    wp::vec_t<3, wp::float64> var_24;
    wp::vec_t<3, wp::float32> var_25;
    wp::vec_t<6, wp::float64>* var_26;
    wp::vec_t<6, wp::float64> var_27;
    wp::vec_t<6, wp::float64> var_28;
    const wp::int32 var_29 = 0;
    wp::float64 var_30;
    const wp::int32 var_31 = 1;
    wp::float64 var_32;
    const wp::int32 var_33 = 2;
    wp::float64 var_34;
    wp::vec_t<3, wp::float64> var_35;
    const wp::int32 var_36 = 3;
    wp::float64 var_37;
    const wp::int32 var_38 = 4;
    wp::float64 var_39;
    const wp::int32 var_40 = 5;
    wp::float64 var_41;
    wp::vec_t<3, wp::float64> var_42;
    wp::vec_t<3, wp::float64> var_43;
    wp::vec_t<3, wp::float64> var_44;
    const wp::int32 var_45 = 0;
    wp::float32* var_46;
    wp::float64 var_47;
    wp::float32 var_48;
    wp::float64 var_49;
    wp::float64 var_50;
    bool var_51;
    wp::int32* var_52;
    bool var_53;
    wp::int32 var_54;
    wp::float64 var_55;
    bool var_56;
    wp::int32* var_57;
    wp::int32 var_58;
    wp::vec_t<3, wp::float32>* var_59;
    wp::vec_t<3, wp::float64> var_60;
    wp::vec_t<3, wp::float32> var_61;
    wp::vec_t<3, wp::float64> var_62;
    wp::vec_t<3, wp::float64> var_63;
    wp::float64 var_64;
    wp::float64 var_65;
    wp::float64 var_66;
    wp::float64 var_67;
    wp::int32* var_68;
    bool var_69;
    wp::int32 var_70;
    wp::float64 var_71;
    wp::float64 var_72;
    wp::float64 var_73;
    wp::float64 var_74;
    wp::float64 var_75;
    wp::int32* var_76;
    bool var_77;
    wp::int32 var_78;
    wp::float64 var_79;
    wp::float64 var_80;
    wp::float64 var_81;
    wp::vec_t<3, wp::float64> var_82;
    wp::vec_t<3, wp::float64> var_83;
    wp::float64 var_84;
    wp::float64 var_85;
    wp::float64 var_86;
    wp::float64 var_87;
    wp::vec_t<3, wp::float64> var_88;
    wp::vec_t<3, wp::float64> var_89;
    wp::float64 var_90;
    wp::float64 var_91;
    wp::float64 var_92;
    wp::float64 var_93;
    wp::float64 var_94;
    wp::vec_t<3, wp::float64> var_95;
    wp::vec_t<3, wp::float64> var_96;
    wp::vec_t<3, wp::float64> var_97;
    wp::vec_t<36, wp::float64> var_98;
    wp::vec_t<3, wp::float64> var_99;
    wp::vec_t<3, wp::float64> var_100;
    wp::float64 var_101;
    wp::vec_t<3, wp::float64> var_102;
    wp::vec_t<36, wp::float64> var_103;
    wp::vec_t<36, wp::float64> var_104;
    wp::vec_t<36, wp::float64> var_105;
    //---------
    // forward
    // def sum_doppler_rows_element(matches__jobs__sources__points, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__targets, matches__poses, matches__pairs, matches__weighted, matches__weights, loss__kind, loss__k, loss__shape, source__dopplers, source__directions, target__normals, velocities, iterations, rule__sensor, rule__period, rule__share, rule__loss__kind, rule__loss__k, rule__loss__shape, rule__geometric_from, rule__doppler_from, rule__reject_from, rule__threshold, i):       <L 1>
    // p, q, paired = pair_of(i, matches__jobs__sources__points, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__targets, matches__poses, matches__pairs)       <L 2>
    pair_of_0(var_i, var_matches__jobs__sources__points, var_matches__jobs__sources__first_positions, var_matches__jobs__group_jobs, var_matches__jobs__job_groups, var_matches__jobs__job_sources, var_matches__targets, var_matches__poses, var_matches__pairs, var_0, var_1, var_2);
    // n = vec3d(float64(0.0))                                                                <L 3>
    var_3 = 0.0;
    var_4 = wp::vec_t<3, wp::float64>(var_3);
    // u = vec3d(float64(0.0))                                                                <L 4>
    var_5 = 0.0;
    var_6 = wp::vec_t<3, wp::float64>(var_5);
    // r = float64(0.0)                                                                       <L 5>
    var_7 = 0.0;
    // s = float64(0.0)                                                                       <L 6>
    var_8 = 0.0;
    // w = float64(0.0)                                                                       <L 7>
    var_9 = 0.0;
    // y = float64(0.0)                                                                       <L 8>
    var_10 = 0.0;
    // share = sqrt(float64(1.0) - rule__share)                                               <L 9>
    var_11 = 1.0;
    var_12 = wp::sub(var_11, var_rule__share);
    var_13 = wp::sqrt(var_12);
    // doppler_share = sqrt(rule__share)                                                      <L 10>
    var_14 = wp::sqrt(var_rule__share);
    // if paired > float64(0.0):                                                              <L 11>
    var_15 = 0.0;
    var_16 = (var_2 > var_15);
    if (var_16) {
        // job = matches__jobs__group_jobs[i // LEAF]                                         <L 12>
        var_18 = wp::floordiv(var_i, var_17);
        var_19 = wp::address(var_matches__jobs__group_jobs, var_18);
        var_21 = wp::load(var_19);
        var_20 = wp::copy(var_21);
        // at = source_position(i, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources)       <L 13>
        var_22 = source_position_0(var_i, var_matches__jobs__sources__first_positions, var_matches__jobs__group_jobs, var_matches__jobs__job_groups, var_matches__jobs__job_sources);
        // direction = widen(source__directions[at])                                          <L 14>
        var_23 = wp::address(var_source__directions, var_22);
        var_25 = wp::load(var_23);
        var_24 = widen_0(var_25);
        // motion = velocities[job]                                                           <L 15>
        var_26 = wp::address(var_velocities, var_20);
        var_28 = wp::load(var_26);
        var_27 = wp::copy(var_28);
        // turning = vec3d(motion[0], motion[1], motion[2])                                   <L 16>
        var_30 = wp::extract(var_27, var_29);
        var_32 = wp::extract(var_27, var_31);
        var_34 = wp::extract(var_27, var_33);
        var_35 = wp::vec_t<3, wp::float64>(var_30, var_32, var_34);
        // v = vec3d(motion[3], motion[4], motion[5]) + cross(turning, rule__sensor)          <L 17>
        var_37 = wp::extract(var_27, var_36);
        var_39 = wp::extract(var_27, var_38);
        var_41 = wp::extract(var_27, var_40);
        var_42 = wp::vec_t<3, wp::float64>(var_37, var_39, var_41);
        var_43 = wp::cross(var_35, var_rule__sensor);
        var_44 = wp::add(var_42, var_43);
        // error = float64(source__dopplers[at, 0]) + dot(direction, v)                       <L 18>
        var_46 = wp::address(var_source__dopplers, var_22, var_45);
        var_48 = wp::load(var_46);
        var_47 = wp::float64(var_48);
        var_49 = wp::dot(var_24, var_44);
        var_50 = wp::add(var_47, var_49);
        // if iterations[job] < rule__reject_from or abs(error) <= rule__threshold:           <L 19>
        var_52 = wp::address(var_iterations, var_20);
        var_54 = wp::load(var_52);
        var_53 = (var_54 < var_rule__reject_from);
        var_51 = var_53;
        if (!var_51) {
            var_55 = wp::abs(var_50);
            var_56 = (var_55 <= var_rule__threshold);
            var_51 = var_51 || var_56;
        }
        if (var_51) {
            // n = widen(target__normals[matches__pairs[i]])                                  <L 20>
            var_57 = wp::address(var_matches__pairs, var_i);
            var_58 = wp::load(var_57);
            var_59 = wp::address(var_target__normals, var_58);
            var_61 = wp::load(var_59);
            var_60 = widen_0(var_61);
            // u = direction                                                                  <L 21>
            var_62 = wp::copy(var_24);
            // r = share * dot(p - q, n)                                                      <L 22>
            var_63 = wp::sub(var_0, var_1);
            var_64 = wp::dot(var_63, var_60);
            var_65 = wp::mul(var_13, var_64);
            // given = weight_of(i, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__weighted, matches__weights)       <L 23>
            var_66 = weight_of_2(var_i, var_matches__jobs__sources__first_positions, var_matches__jobs__group_jobs, var_matches__jobs__job_groups, var_matches__jobs__job_sources, var_matches__weighted, var_matches__weights);
            // w = given                                                                      <L 24>
            var_67 = wp::copy(var_66);
            // if iterations[job] >= rule__geometric_from:                                    <L 25>
            var_68 = wp::address(var_iterations, var_20);
            var_70 = wp::load(var_68);
            var_69 = (var_70 >= var_rule__geometric_from);
            if (var_69) {
                // w = given * robust_weight(loss__kind, loss__k, loss__shape, r)             <L 26>
                var_71 = robust_weight_0(var_loss__kind, var_loss__k, var_loss__shape, var_65);
                var_72 = wp::mul(var_66, var_71);
            }
            var_73 = wp::where(var_69, var_72, var_67);
            // s = doppler_share * error                                                      <L 27>
            var_74 = wp::mul(var_14, var_50);
            // y = given                                                                      <L 28>
            var_75 = wp::copy(var_66);
            // if iterations[job] >= rule__doppler_from:                                      <L 29>
            var_76 = wp::address(var_iterations, var_20);
            var_78 = wp::load(var_76);
            var_77 = (var_78 >= var_rule__doppler_from);
            if (var_77) {
                // y = given * robust_weight(rule__loss__kind, rule__loss__k, rule__loss__shape, s)       <L 30>
                var_79 = robust_weight_0(var_rule__loss__kind, var_rule__loss__k, var_rule__loss__shape, var_74);
                var_80 = wp::mul(var_66, var_79);
            }
            var_81 = wp::where(var_77, var_80, var_75);
        }
        var_82 = wp::where(var_51, var_60, var_4);
        var_83 = wp::where(var_51, var_62, var_6);
        var_84 = wp::where(var_51, var_65, var_7);
        var_85 = wp::where(var_51, var_74, var_8);
        var_86 = wp::where(var_51, var_73, var_9);
        var_87 = wp::where(var_51, var_81, var_10);
    }
    var_88 = wp::where(var_16, var_82, var_4);
    var_89 = wp::where(var_16, var_83, var_6);
    var_90 = wp::where(var_16, var_84, var_7);
    var_91 = wp::where(var_16, var_85, var_8);
    var_92 = wp::where(var_16, var_86, var_9);
    var_93 = wp::where(var_16, var_87, var_10);
    // doppler_share = doppler_share / rule__period                                           <L 31>
    var_94 = wp::div(var_14, var_rule__period);
    // total = sum_row(share * cross(p, n), share * n, r, w)                                  <L 32>
    var_95 = wp::cross(var_0, var_88);
    var_96 = wp::mul(var_13, var_95);
    var_97 = wp::mul(var_13, var_88);
    var_98 = sum_row_0(var_96, var_97, var_90, var_92);
    // total += sum_row(doppler_share * cross(u, rule__sensor), -doppler_share * u, s, y)       <L 33>
    var_99 = wp::cross(var_89, var_rule__sensor);
    var_100 = wp::mul(var_94, var_99);
    var_101 = wp::neg(var_94);
    var_102 = wp::mul(var_101, var_89);
    var_103 = sum_row_0(var_100, var_102, var_91, var_93);
    var_104 = wp::add(var_98, var_103);
    // return count_pair(total, p, q, paired)                                                 <L 34>
    var_105 = count_pair_0(var_104, var_0, var_1, var_2);
    return var_105;
}


// <pointloom.kernels.icp.rows.sum_plane_rows_element>:1
static CUDA_CALLABLE wp::vec_t<36, wp::float64> sum_plane_rows_element_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__jobs__sources__points,
    wp::array_t<wp::int32> var_matches__jobs__sources__first_positions,
    wp::array_t<wp::int32> var_matches__jobs__group_jobs,
    wp::array_t<wp::int32> var_matches__jobs__job_groups,
    wp::array_t<wp::int32> var_matches__jobs__job_sources,
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__targets,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_matches__poses,
    wp::array_t<wp::int32> var_matches__pairs,
    wp::int32 var_matches__weighted,
    wp::array_t<wp::float32> var_matches__weights,
    wp::int32 var_loss__kind,
    wp::float64 var_loss__k,
    wp::float64 var_loss__shape,
    wp::array_t<wp::vec_t<3, wp::float32>> var_target__normals,
    wp::int32 var_i)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float64> var_0;
    wp::vec_t<3, wp::float64> var_1;
    wp::float64 var_2;
    wp::float64 var_3;
    wp::vec_t<3, wp::float64> var_4;
    wp::float64 var_5;
    wp::float64 var_6;
    wp::float64 var_7;
    bool var_8;
    wp::int32* var_9;
    wp::int32 var_10;
    wp::vec_t<3, wp::float32>* var_11;
    wp::vec_t<3, wp::float64> var_12;
    wp::vec_t<3, wp::float32> var_13;
    wp::vec_t<3, wp::float64> var_14;
    wp::float64 var_15;
    wp::float64 var_16;
    wp::float64 var_17;
    wp::float64 var_18;
    wp::vec_t<3, wp::float64> var_19;
    wp::float64 var_20;
    wp::float64 var_21;
    wp::vec_t<3, wp::float64> var_22;
    wp::vec_t<36, wp::float64> var_23;
    wp::vec_t<36, wp::float64> var_24;
    //---------
    // forward
    // def sum_plane_rows_element(matches__jobs__sources__points, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__targets, matches__poses, matches__pairs, matches__weighted, matches__weights, loss__kind, loss__k, loss__shape, target__normals, i):       <L 1>
    // p, q, paired = pair_of(i, matches__jobs__sources__points, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__targets, matches__poses, matches__pairs)       <L 2>
    pair_of_0(var_i, var_matches__jobs__sources__points, var_matches__jobs__sources__first_positions, var_matches__jobs__group_jobs, var_matches__jobs__job_groups, var_matches__jobs__job_sources, var_matches__targets, var_matches__poses, var_matches__pairs, var_0, var_1, var_2);
    // n = vec3d(float64(0.0))                                                                <L 3>
    var_3 = 0.0;
    var_4 = wp::vec_t<3, wp::float64>(var_3);
    // r = float64(0.0)                                                                       <L 4>
    var_5 = 0.0;
    // w = float64(0.0)                                                                       <L 5>
    var_6 = 0.0;
    // if paired > float64(0.0):                                                              <L 6>
    var_7 = 0.0;
    var_8 = (var_2 > var_7);
    if (var_8) {
        // n = widen(target__normals[matches__pairs[i]])                                      <L 7>
        var_9 = wp::address(var_matches__pairs, var_i);
        var_10 = wp::load(var_9);
        var_11 = wp::address(var_target__normals, var_10);
        var_13 = wp::load(var_11);
        var_12 = widen_0(var_13);
        // r = dot(p - q, n)                                                                  <L 8>
        var_14 = wp::sub(var_0, var_1);
        var_15 = wp::dot(var_14, var_12);
        // w = robust_weight(loss__kind, loss__k, loss__shape, r) * weight_of(i, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__weighted, matches__weights)       <L 9>
        var_16 = robust_weight_0(var_loss__kind, var_loss__k, var_loss__shape, var_15);
        var_17 = weight_of_2(var_i, var_matches__jobs__sources__first_positions, var_matches__jobs__group_jobs, var_matches__jobs__job_groups, var_matches__jobs__job_sources, var_matches__weighted, var_matches__weights);
        var_18 = wp::mul(var_16, var_17);
    }
    var_19 = wp::where(var_8, var_12, var_4);
    var_20 = wp::where(var_8, var_15, var_5);
    var_21 = wp::where(var_8, var_18, var_6);
    // return count_pair(sum_row(cross(p, n), n, r, w), p, q, paired)                         <L 10>
    var_22 = wp::cross(var_0, var_19);
    var_23 = sum_row_0(var_22, var_19, var_20, var_21);
    var_24 = count_pair_0(var_23, var_0, var_1, var_2);
    return var_24;
}


// /work/main/src/pointloom/kernels/algebra/rigid_solve.py:310
static CUDA_CALLABLE wp::vec_t<3, wp::float64> rotate_1(
    wp::mat_t<4, 4, wp::float64> var_pose,
    wp::vec_t<3, wp::float64> var_v)
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
    const wp::int32 var_20 = 1;
    const wp::int32 var_21 = 0;
    wp::float64 var_22;
    const wp::int32 var_23 = 0;
    wp::float64 var_24;
    wp::float64 var_25;
    const wp::int32 var_26 = 1;
    const wp::int32 var_27 = 1;
    wp::float64 var_28;
    const wp::int32 var_29 = 1;
    wp::float64 var_30;
    wp::float64 var_31;
    wp::float64 var_32;
    const wp::int32 var_33 = 1;
    const wp::int32 var_34 = 2;
    wp::float64 var_35;
    const wp::int32 var_36 = 2;
    wp::float64 var_37;
    wp::float64 var_38;
    wp::float64 var_39;
    const wp::int32 var_40 = 2;
    const wp::int32 var_41 = 0;
    wp::float64 var_42;
    const wp::int32 var_43 = 0;
    wp::float64 var_44;
    wp::float64 var_45;
    const wp::int32 var_46 = 2;
    const wp::int32 var_47 = 1;
    wp::float64 var_48;
    const wp::int32 var_49 = 1;
    wp::float64 var_50;
    wp::float64 var_51;
    wp::float64 var_52;
    const wp::int32 var_53 = 2;
    const wp::int32 var_54 = 2;
    wp::float64 var_55;
    const wp::int32 var_56 = 2;
    wp::float64 var_57;
    wp::float64 var_58;
    wp::float64 var_59;
    wp::vec_t<3, wp::float64> var_60;
    //---------
    // forward
    // def rotate(pose: mat44d, v: vec3d) -> vec3d:                                           <L 311>
    // return vec3d(                                                                          <L 312>
    // pose[0, 0] * v[0] + pose[0, 1] * v[1] + pose[0, 2] * v[2],                             <L 313>
    var_2 = wp::extract(var_pose, var_0, var_1);
    var_4 = wp::extract(var_v, var_3);
    var_5 = wp::mul(var_2, var_4);
    var_8 = wp::extract(var_pose, var_6, var_7);
    var_10 = wp::extract(var_v, var_9);
    var_11 = wp::mul(var_8, var_10);
    var_12 = wp::add(var_5, var_11);
    var_15 = wp::extract(var_pose, var_13, var_14);
    var_17 = wp::extract(var_v, var_16);
    var_18 = wp::mul(var_15, var_17);
    var_19 = wp::add(var_12, var_18);
    // pose[1, 0] * v[0] + pose[1, 1] * v[1] + pose[1, 2] * v[2],                             <L 314>
    var_22 = wp::extract(var_pose, var_20, var_21);
    var_24 = wp::extract(var_v, var_23);
    var_25 = wp::mul(var_22, var_24);
    var_28 = wp::extract(var_pose, var_26, var_27);
    var_30 = wp::extract(var_v, var_29);
    var_31 = wp::mul(var_28, var_30);
    var_32 = wp::add(var_25, var_31);
    var_35 = wp::extract(var_pose, var_33, var_34);
    var_37 = wp::extract(var_v, var_36);
    var_38 = wp::mul(var_35, var_37);
    var_39 = wp::add(var_32, var_38);
    // pose[2, 0] * v[0] + pose[2, 1] * v[1] + pose[2, 2] * v[2],                             <L 315>
    var_42 = wp::extract(var_pose, var_40, var_41);
    var_44 = wp::extract(var_v, var_43);
    var_45 = wp::mul(var_42, var_44);
    var_48 = wp::extract(var_pose, var_46, var_47);
    var_50 = wp::extract(var_v, var_49);
    var_51 = wp::mul(var_48, var_50);
    var_52 = wp::add(var_45, var_51);
    var_55 = wp::extract(var_pose, var_53, var_54);
    var_57 = wp::extract(var_v, var_56);
    var_58 = wp::mul(var_55, var_57);
    var_59 = wp::add(var_52, var_58);
    var_60 = wp::vec_t<3, wp::float64>(var_19, var_39, var_59);
    return var_60;
}


// <pointloom.kernels.icp.rows.sum_symmetric_rows_element>:1
static CUDA_CALLABLE wp::vec_t<36, wp::float64> sum_symmetric_rows_element_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__jobs__sources__points,
    wp::array_t<wp::int32> var_matches__jobs__sources__first_positions,
    wp::array_t<wp::int32> var_matches__jobs__group_jobs,
    wp::array_t<wp::int32> var_matches__jobs__job_groups,
    wp::array_t<wp::int32> var_matches__jobs__job_sources,
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__targets,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_matches__poses,
    wp::array_t<wp::int32> var_matches__pairs,
    wp::int32 var_matches__weighted,
    wp::array_t<wp::float32> var_matches__weights,
    wp::int32 var_loss__kind,
    wp::float64 var_loss__k,
    wp::float64 var_loss__shape,
    wp::array_t<wp::vec_t<3, wp::float32>> var_source__normals,
    wp::array_t<wp::vec_t<3, wp::float32>> var_target__normals,
    wp::int32 var_i)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float64> var_0;
    wp::vec_t<3, wp::float64> var_1;
    wp::float64 var_2;
    wp::float64 var_3;
    wp::vec_t<3, wp::float64> var_4;
    wp::float64 var_5;
    wp::float64 var_6;
    wp::float64 var_7;
    bool var_8;
    const wp::int32 var_9 = 8;
    wp::int32 var_10;
    wp::int32* var_11;
    wp::int32 var_12;
    wp::int32 var_13;
    wp::int32 var_14;
    wp::mat_t<4, 4, wp::float64>* var_15;
    wp::vec_t<3, wp::float32>* var_16;
    wp::vec_t<3, wp::float64> var_17;
    wp::vec_t<3, wp::float32> var_18;
    wp::vec_t<3, wp::float64> var_19;
    wp::mat_t<4, 4, wp::float64> var_20;
    wp::int32* var_21;
    wp::int32 var_22;
    wp::vec_t<3, wp::float32>* var_23;
    wp::vec_t<3, wp::float64> var_24;
    wp::vec_t<3, wp::float32> var_25;
    wp::float64 var_26;
    wp::float64 var_27;
    bool var_28;
    wp::vec_t<3, wp::float64> var_29;
    wp::vec_t<3, wp::float64> var_30;
    wp::vec_t<3, wp::float64> var_31;
    wp::vec_t<3, wp::float64> var_32;
    wp::float64 var_33;
    wp::float64 var_34;
    wp::float64 var_35;
    wp::float64 var_36;
    wp::vec_t<3, wp::float64> var_37;
    wp::float64 var_38;
    wp::float64 var_39;
    wp::vec_t<3, wp::float64> var_40;
    wp::vec_t<3, wp::float64> var_41;
    wp::vec_t<36, wp::float64> var_42;
    wp::vec_t<36, wp::float64> var_43;
    //---------
    // forward
    // def sum_symmetric_rows_element(matches__jobs__sources__points, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__targets, matches__poses, matches__pairs, matches__weighted, matches__weights, loss__kind, loss__k, loss__shape, source__normals, target__normals, i):       <L 1>
    // p, q, paired = pair_of(i, matches__jobs__sources__points, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__targets, matches__poses, matches__pairs)       <L 2>
    pair_of_0(var_i, var_matches__jobs__sources__points, var_matches__jobs__sources__first_positions, var_matches__jobs__group_jobs, var_matches__jobs__job_groups, var_matches__jobs__job_sources, var_matches__targets, var_matches__poses, var_matches__pairs, var_0, var_1, var_2);
    // m = vec3d(float64(0.0))                                                                <L 3>
    var_3 = 0.0;
    var_4 = wp::vec_t<3, wp::float64>(var_3);
    // r = float64(0.0)                                                                       <L 4>
    var_5 = 0.0;
    // w = float64(0.0)                                                                       <L 5>
    var_6 = 0.0;
    // if paired > float64(0.0):                                                              <L 6>
    var_7 = 0.0;
    var_8 = (var_2 > var_7);
    if (var_8) {
        // job = matches__jobs__group_jobs[i // LEAF]                                         <L 7>
        var_10 = wp::floordiv(var_i, var_9);
        var_11 = wp::address(var_matches__jobs__group_jobs, var_10);
        var_13 = wp::load(var_11);
        var_12 = wp::copy(var_13);
        // at = source_position(i, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources)       <L 8>
        var_14 = source_position_0(var_i, var_matches__jobs__sources__first_positions, var_matches__jobs__group_jobs, var_matches__jobs__job_groups, var_matches__jobs__job_sources);
        // n = rotate(matches__poses[job], widen(source__normals[at]))                        <L 9>
        var_15 = wp::address(var_matches__poses, var_12);
        var_16 = wp::address(var_source__normals, var_14);
        var_18 = wp::load(var_16);
        var_17 = widen_0(var_18);
        var_20 = wp::load(var_15);
        var_19 = rotate_1(var_20, var_17);
        // m = widen(target__normals[matches__pairs[i]])                                      <L 10>
        var_21 = wp::address(var_matches__pairs, var_i);
        var_22 = wp::load(var_21);
        var_23 = wp::address(var_target__normals, var_22);
        var_25 = wp::load(var_23);
        var_24 = widen_0(var_25);
        // if dot(n, m) < float64(0.0):                                                       <L 11>
        var_26 = wp::dot(var_19, var_24);
        var_27 = 0.0;
        var_28 = (var_26 < var_27);
        if (var_28) {
            // m = m - n                                                                      <L 12>
            var_29 = wp::sub(var_24, var_19);
        }
        if (!var_28) {
            // m = m + n                                                                      <L 14>
            var_30 = wp::add(var_24, var_19);
        }
        var_31 = wp::where(var_28, var_29, var_30);
        // r = dot(p - q, m)                                                                  <L 15>
        var_32 = wp::sub(var_0, var_1);
        var_33 = wp::dot(var_32, var_31);
        // w = robust_weight(loss__kind, loss__k, loss__shape, r) * weight_of(i, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__weighted, matches__weights)       <L 16>
        var_34 = robust_weight_0(var_loss__kind, var_loss__k, var_loss__shape, var_33);
        var_35 = weight_of_2(var_i, var_matches__jobs__sources__first_positions, var_matches__jobs__group_jobs, var_matches__jobs__job_groups, var_matches__jobs__job_sources, var_matches__weighted, var_matches__weights);
        var_36 = wp::mul(var_34, var_35);
    }
    var_37 = wp::where(var_8, var_31, var_4);
    var_38 = wp::where(var_8, var_33, var_5);
    var_39 = wp::where(var_8, var_36, var_6);
    // return count_pair(sum_row(cross(p + q, m), m, r, w), p, q, paired)                     <L 17>
    var_40 = wp::add(var_0, var_1);
    var_41 = wp::cross(var_40, var_37);
    var_42 = sum_row_0(var_41, var_37, var_38, var_39);
    var_43 = count_pair_0(var_42, var_0, var_1, var_2);
    return var_43;
}


// /work/main/src/pointloom/kernels/algebra/rigid_solve.py:319
static CUDA_CALLABLE wp::vec_t<18, wp::float64> sums_of_pair_0(
    wp::vec_t<3, wp::float64> var_p,
    wp::vec_t<3, wp::float64> var_q,
    wp::float64 var_w)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float64 var_1;
    wp::float64 var_2;
    const wp::int32 var_3 = 1;
    wp::float64 var_4;
    wp::float64 var_5;
    const wp::int32 var_6 = 2;
    wp::float64 var_7;
    wp::float64 var_8;
    const wp::int32 var_9 = 0;
    wp::float64 var_10;
    wp::float64 var_11;
    const wp::int32 var_12 = 1;
    wp::float64 var_13;
    wp::float64 var_14;
    const wp::int32 var_15 = 2;
    wp::float64 var_16;
    wp::float64 var_17;
    const wp::int32 var_18 = 0;
    wp::float64 var_19;
    wp::float64 var_20;
    const wp::int32 var_21 = 0;
    wp::float64 var_22;
    wp::float64 var_23;
    const wp::int32 var_24 = 0;
    wp::float64 var_25;
    wp::float64 var_26;
    const wp::int32 var_27 = 1;
    wp::float64 var_28;
    wp::float64 var_29;
    const wp::int32 var_30 = 0;
    wp::float64 var_31;
    wp::float64 var_32;
    const wp::int32 var_33 = 2;
    wp::float64 var_34;
    wp::float64 var_35;
    const wp::int32 var_36 = 1;
    wp::float64 var_37;
    wp::float64 var_38;
    const wp::int32 var_39 = 0;
    wp::float64 var_40;
    wp::float64 var_41;
    const wp::int32 var_42 = 1;
    wp::float64 var_43;
    wp::float64 var_44;
    const wp::int32 var_45 = 1;
    wp::float64 var_46;
    wp::float64 var_47;
    const wp::int32 var_48 = 1;
    wp::float64 var_49;
    wp::float64 var_50;
    const wp::int32 var_51 = 2;
    wp::float64 var_52;
    wp::float64 var_53;
    const wp::int32 var_54 = 2;
    wp::float64 var_55;
    wp::float64 var_56;
    const wp::int32 var_57 = 0;
    wp::float64 var_58;
    wp::float64 var_59;
    const wp::int32 var_60 = 2;
    wp::float64 var_61;
    wp::float64 var_62;
    const wp::int32 var_63 = 1;
    wp::float64 var_64;
    wp::float64 var_65;
    const wp::int32 var_66 = 2;
    wp::float64 var_67;
    wp::float64 var_68;
    const wp::int32 var_69 = 2;
    wp::float64 var_70;
    wp::float64 var_71;
    const wp::int32 var_72 = 0;
    wp::float64 var_73;
    const wp::int32 var_74 = 0;
    wp::float64 var_75;
    wp::float64 var_76;
    const wp::int32 var_77 = 1;
    wp::float64 var_78;
    const wp::int32 var_79 = 1;
    wp::float64 var_80;
    wp::float64 var_81;
    wp::float64 var_82;
    const wp::int32 var_83 = 2;
    wp::float64 var_84;
    const wp::int32 var_85 = 2;
    wp::float64 var_86;
    wp::float64 var_87;
    wp::float64 var_88;
    wp::float64 var_89;
    const wp::int32 var_90 = 0;
    wp::float64 var_91;
    const wp::int32 var_92 = 0;
    wp::float64 var_93;
    wp::float64 var_94;
    const wp::int32 var_95 = 1;
    wp::float64 var_96;
    const wp::int32 var_97 = 1;
    wp::float64 var_98;
    wp::float64 var_99;
    wp::float64 var_100;
    const wp::int32 var_101 = 2;
    wp::float64 var_102;
    const wp::int32 var_103 = 2;
    wp::float64 var_104;
    wp::float64 var_105;
    wp::float64 var_106;
    wp::float64 var_107;
    wp::vec_t<18, wp::float64> var_108;
    //---------
    // forward
    // def sums_of_pair(p: vec3d, q: vec3d, w: float64) -> pair_sums:                         <L 320>
    // return pair_sums(                                                                      <L 322>
    // w, w * p[0], w * p[1], w * p[2], w * q[0], w * q[1], w * q[2],                         <L 323>
    var_1 = wp::extract(var_p, var_0);
    var_2 = wp::mul(var_w, var_1);
    var_4 = wp::extract(var_p, var_3);
    var_5 = wp::mul(var_w, var_4);
    var_7 = wp::extract(var_p, var_6);
    var_8 = wp::mul(var_w, var_7);
    var_10 = wp::extract(var_q, var_9);
    var_11 = wp::mul(var_w, var_10);
    var_13 = wp::extract(var_q, var_12);
    var_14 = wp::mul(var_w, var_13);
    var_16 = wp::extract(var_q, var_15);
    var_17 = wp::mul(var_w, var_16);
    // w * p[0] * q[0], w * p[0] * q[1], w * p[0] * q[2],                                     <L 324>
    var_19 = wp::extract(var_p, var_18);
    var_20 = wp::mul(var_w, var_19);
    var_22 = wp::extract(var_q, var_21);
    var_23 = wp::mul(var_20, var_22);
    var_25 = wp::extract(var_p, var_24);
    var_26 = wp::mul(var_w, var_25);
    var_28 = wp::extract(var_q, var_27);
    var_29 = wp::mul(var_26, var_28);
    var_31 = wp::extract(var_p, var_30);
    var_32 = wp::mul(var_w, var_31);
    var_34 = wp::extract(var_q, var_33);
    var_35 = wp::mul(var_32, var_34);
    // w * p[1] * q[0], w * p[1] * q[1], w * p[1] * q[2],                                     <L 325>
    var_37 = wp::extract(var_p, var_36);
    var_38 = wp::mul(var_w, var_37);
    var_40 = wp::extract(var_q, var_39);
    var_41 = wp::mul(var_38, var_40);
    var_43 = wp::extract(var_p, var_42);
    var_44 = wp::mul(var_w, var_43);
    var_46 = wp::extract(var_q, var_45);
    var_47 = wp::mul(var_44, var_46);
    var_49 = wp::extract(var_p, var_48);
    var_50 = wp::mul(var_w, var_49);
    var_52 = wp::extract(var_q, var_51);
    var_53 = wp::mul(var_50, var_52);
    // w * p[2] * q[0], w * p[2] * q[1], w * p[2] * q[2],                                     <L 326>
    var_55 = wp::extract(var_p, var_54);
    var_56 = wp::mul(var_w, var_55);
    var_58 = wp::extract(var_q, var_57);
    var_59 = wp::mul(var_56, var_58);
    var_61 = wp::extract(var_p, var_60);
    var_62 = wp::mul(var_w, var_61);
    var_64 = wp::extract(var_q, var_63);
    var_65 = wp::mul(var_62, var_64);
    var_67 = wp::extract(var_p, var_66);
    var_68 = wp::mul(var_w, var_67);
    var_70 = wp::extract(var_q, var_69);
    var_71 = wp::mul(var_68, var_70);
    // w * (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]), w * (q[0] * q[0] + q[1] * q[1] + q[2] * q[2]),       <L 327>
    var_73 = wp::extract(var_p, var_72);
    var_75 = wp::extract(var_p, var_74);
    var_76 = wp::mul(var_73, var_75);
    var_78 = wp::extract(var_p, var_77);
    var_80 = wp::extract(var_p, var_79);
    var_81 = wp::mul(var_78, var_80);
    var_82 = wp::add(var_76, var_81);
    var_84 = wp::extract(var_p, var_83);
    var_86 = wp::extract(var_p, var_85);
    var_87 = wp::mul(var_84, var_86);
    var_88 = wp::add(var_82, var_87);
    var_89 = wp::mul(var_w, var_88);
    var_91 = wp::extract(var_q, var_90);
    var_93 = wp::extract(var_q, var_92);
    var_94 = wp::mul(var_91, var_93);
    var_96 = wp::extract(var_q, var_95);
    var_98 = wp::extract(var_q, var_97);
    var_99 = wp::mul(var_96, var_98);
    var_100 = wp::add(var_94, var_99);
    var_102 = wp::extract(var_q, var_101);
    var_104 = wp::extract(var_q, var_103);
    var_105 = wp::mul(var_102, var_104);
    var_106 = wp::add(var_100, var_105);
    var_107 = wp::mul(var_w, var_106);
    var_108 = wp::vec_t<18, wp::float64>({var_w, var_2, var_5, var_8, var_11, var_14, var_17, var_23, var_29, var_35, var_41, var_47, var_53, var_59, var_65, var_71, var_89, var_107});
    return var_108;
}


// /work/main/src/pointloom/kernels/icp/rows.py:166
static CUDA_CALLABLE wp::vec_t<36, wp::float64> sum_pair_0(
    wp::vec_t<3, wp::float64> var_p,
    wp::vec_t<3, wp::float64> var_q,
    wp::float64 var_w)
{
    //---------
    // primal vars
    wp::vec_t<18, wp::float64> var_0;
    wp::float64 var_1;
    const wp::int32 var_2 = 0;
    wp::float64 var_3;
    const wp::int32 var_4 = 1;
    wp::float64 var_5;
    const wp::int32 var_6 = 2;
    wp::float64 var_7;
    const wp::int32 var_8 = 3;
    wp::float64 var_9;
    const wp::int32 var_10 = 4;
    wp::float64 var_11;
    const wp::int32 var_12 = 5;
    wp::float64 var_13;
    const wp::int32 var_14 = 6;
    wp::float64 var_15;
    const wp::int32 var_16 = 7;
    wp::float64 var_17;
    const wp::int32 var_18 = 8;
    wp::float64 var_19;
    const wp::int32 var_20 = 9;
    wp::float64 var_21;
    const wp::int32 var_22 = 10;
    wp::float64 var_23;
    const wp::int32 var_24 = 11;
    wp::float64 var_25;
    const wp::int32 var_26 = 12;
    wp::float64 var_27;
    const wp::int32 var_28 = 13;
    wp::float64 var_29;
    const wp::int32 var_30 = 14;
    wp::float64 var_31;
    const wp::int32 var_32 = 15;
    wp::float64 var_33;
    const wp::int32 var_34 = 16;
    wp::float64 var_35;
    const wp::int32 var_36 = 17;
    wp::float64 var_37;
    const wp::int32 var_38 = 0;
    wp::float64 var_39;
    wp::float64 var_40;
    const wp::int32 var_41 = 0;
    wp::float64 var_42;
    wp::float64 var_43;
    const wp::int32 var_44 = 0;
    wp::float64 var_45;
    wp::float64 var_46;
    const wp::int32 var_47 = 1;
    wp::float64 var_48;
    wp::float64 var_49;
    const wp::int32 var_50 = 0;
    wp::float64 var_51;
    wp::float64 var_52;
    const wp::int32 var_53 = 2;
    wp::float64 var_54;
    wp::float64 var_55;
    const wp::int32 var_56 = 1;
    wp::float64 var_57;
    wp::float64 var_58;
    const wp::int32 var_59 = 1;
    wp::float64 var_60;
    wp::float64 var_61;
    const wp::int32 var_62 = 1;
    wp::float64 var_63;
    wp::float64 var_64;
    const wp::int32 var_65 = 2;
    wp::float64 var_66;
    wp::float64 var_67;
    const wp::int32 var_68 = 2;
    wp::float64 var_69;
    wp::float64 var_70;
    const wp::int32 var_71 = 2;
    wp::float64 var_72;
    wp::float64 var_73;
    wp::vec_t<36, wp::float64> var_74;
    //---------
    // forward
    // def sum_pair(p: vec3d, q: vec3d, w: float64) -> row_sums:                              <L 167>
    // s = sums_of_pair(p, q, w)                                                              <L 169>
    var_0 = sums_of_pair_0(var_p, var_q, var_w);
    // z = float64(0.0)                                                                       <L 170>
    var_1 = 0.0;
    // return row_sums(                                                                       <L 171>
    // s[0], s[1], s[2], s[3], s[4], s[5], s[6], s[7], s[8], s[9], s[10], s[11], s[12], s[13], s[14], s[15], s[16],       <L 172>
    var_3 = wp::extract(var_0, var_2);
    var_5 = wp::extract(var_0, var_4);
    var_7 = wp::extract(var_0, var_6);
    var_9 = wp::extract(var_0, var_8);
    var_11 = wp::extract(var_0, var_10);
    var_13 = wp::extract(var_0, var_12);
    var_15 = wp::extract(var_0, var_14);
    var_17 = wp::extract(var_0, var_16);
    var_19 = wp::extract(var_0, var_18);
    var_21 = wp::extract(var_0, var_20);
    var_23 = wp::extract(var_0, var_22);
    var_25 = wp::extract(var_0, var_24);
    var_27 = wp::extract(var_0, var_26);
    var_29 = wp::extract(var_0, var_28);
    var_31 = wp::extract(var_0, var_30);
    var_33 = wp::extract(var_0, var_32);
    var_35 = wp::extract(var_0, var_34);
    // s[17], w * p[0] * p[0], w * p[0] * p[1], w * p[0] * p[2], w * p[1] * p[1], w * p[1] * p[2], w * p[2] * p[2],       <L 173>
    var_37 = wp::extract(var_0, var_36);
    var_39 = wp::extract(var_p, var_38);
    var_40 = wp::mul(var_w, var_39);
    var_42 = wp::extract(var_p, var_41);
    var_43 = wp::mul(var_40, var_42);
    var_45 = wp::extract(var_p, var_44);
    var_46 = wp::mul(var_w, var_45);
    var_48 = wp::extract(var_p, var_47);
    var_49 = wp::mul(var_46, var_48);
    var_51 = wp::extract(var_p, var_50);
    var_52 = wp::mul(var_w, var_51);
    var_54 = wp::extract(var_p, var_53);
    var_55 = wp::mul(var_52, var_54);
    var_57 = wp::extract(var_p, var_56);
    var_58 = wp::mul(var_w, var_57);
    var_60 = wp::extract(var_p, var_59);
    var_61 = wp::mul(var_58, var_60);
    var_63 = wp::extract(var_p, var_62);
    var_64 = wp::mul(var_w, var_63);
    var_66 = wp::extract(var_p, var_65);
    var_67 = wp::mul(var_64, var_66);
    var_69 = wp::extract(var_p, var_68);
    var_70 = wp::mul(var_w, var_69);
    var_72 = wp::extract(var_p, var_71);
    var_73 = wp::mul(var_70, var_72);
    // z, z, z, z, z, z, z, z, z, z, z, z,                                                    <L 174>
    var_74 = wp::vec_t<36, wp::float64>({var_3, var_5, var_7, var_9, var_11, var_13, var_15, var_17, var_19, var_21, var_23, var_25, var_27, var_29, var_31, var_33, var_35, var_37, var_43, var_49, var_55, var_61, var_67, var_73, var_1, var_1, var_1, var_1, var_1, var_1, var_1, var_1, var_1, var_1, var_1, var_1});
    return var_74;
}


// <pointloom.kernels.icp.rows.sum_point_rows_element>:1
static CUDA_CALLABLE wp::vec_t<36, wp::float64> sum_point_rows_element_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__jobs__sources__points,
    wp::array_t<wp::int32> var_matches__jobs__sources__first_positions,
    wp::array_t<wp::int32> var_matches__jobs__group_jobs,
    wp::array_t<wp::int32> var_matches__jobs__job_groups,
    wp::array_t<wp::int32> var_matches__jobs__job_sources,
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__targets,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_matches__poses,
    wp::array_t<wp::int32> var_matches__pairs,
    wp::int32 var_matches__weighted,
    wp::array_t<wp::float32> var_matches__weights,
    wp::int32 var_loss__kind,
    wp::float64 var_loss__k,
    wp::float64 var_loss__shape,
    wp::array_t<wp::vec_t<3, wp::float64>> var_pivots,
    wp::int32 var_i)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float64> var_0;
    wp::vec_t<3, wp::float64> var_1;
    wp::float64 var_2;
    wp::float64 var_3;
    wp::vec_t<3, wp::float64> var_4;
    wp::float64 var_5;
    wp::vec_t<3, wp::float64> var_6;
    wp::float64 var_7;
    wp::float64 var_8;
    bool var_9;
    const wp::int32 var_10 = 8;
    wp::int32 var_11;
    wp::int32* var_12;
    wp::int32 var_13;
    wp::vec_t<3, wp::float64>* var_14;
    wp::vec_t<3, wp::float64> var_15;
    wp::vec_t<3, wp::float64> var_16;
    wp::vec_t<3, wp::float64> var_17;
    wp::vec_t<3, wp::float64> var_18;
    wp::float64 var_19;
    const wp::int32 var_20 = 0;
    bool var_21;
    wp::vec_t<3, wp::float64> var_22;
    wp::float64 var_23;
    wp::float64 var_24;
    wp::float64 var_25;
    wp::float64 var_26;
    wp::float64 var_27;
    wp::float64 var_28;
    wp::vec_t<3, wp::float64> var_29;
    wp::vec_t<3, wp::float64> var_30;
    wp::float64 var_31;
    wp::vec_t<36, wp::float64> var_32;
    wp::vec_t<36, wp::float64> var_33;
    //---------
    // forward
    // def sum_point_rows_element(matches__jobs__sources__points, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__targets, matches__poses, matches__pairs, matches__weighted, matches__weights, loss__kind, loss__k, loss__shape, pivots, i):       <L 1>
    // p, q, paired = pair_of(i, matches__jobs__sources__points, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__targets, matches__poses, matches__pairs)       <L 2>
    pair_of_0(var_i, var_matches__jobs__sources__points, var_matches__jobs__sources__first_positions, var_matches__jobs__group_jobs, var_matches__jobs__job_groups, var_matches__jobs__job_sources, var_matches__targets, var_matches__poses, var_matches__pairs, var_0, var_1, var_2);
    // a = vec3d(float64(0.0))                                                                <L 3>
    var_3 = 0.0;
    var_4 = wp::vec_t<3, wp::float64>(var_3);
    // b = vec3d(float64(0.0))                                                                <L 4>
    var_5 = 0.0;
    var_6 = wp::vec_t<3, wp::float64>(var_5);
    // w = float64(0.0)                                                                       <L 5>
    var_7 = 0.0;
    // if paired > float64(0.0):                                                              <L 6>
    var_8 = 0.0;
    var_9 = (var_2 > var_8);
    if (var_9) {
        // pivot = pivots[matches__jobs__group_jobs[i // LEAF]]                               <L 7>
        var_11 = wp::floordiv(var_i, var_10);
        var_12 = wp::address(var_matches__jobs__group_jobs, var_11);
        var_13 = wp::load(var_12);
        var_14 = wp::address(var_pivots, var_13);
        var_16 = wp::load(var_14);
        var_15 = wp::copy(var_16);
        // a = p - pivot                                                                      <L 8>
        var_17 = wp::sub(var_0, var_15);
        // b = q - pivot                                                                      <L 9>
        var_18 = wp::sub(var_1, var_15);
        // w = float64(1.0)                                                                   <L 10>
        var_19 = 1.0;
        // if loss__kind != L2:                                                               <L 11>
        var_21 = (var_loss__kind != var_20);
        if (var_21) {
            // d = p - q                                                                      <L 12>
            var_22 = wp::sub(var_0, var_1);
            // w = robust_weight(loss__kind, loss__k, loss__shape, sqrt(dot(d, d)))           <L 13>
            var_23 = wp::dot(var_22, var_22);
            var_24 = wp::sqrt(var_23);
            var_25 = robust_weight_0(var_loss__kind, var_loss__k, var_loss__shape, var_24);
        }
        var_26 = wp::where(var_21, var_25, var_19);
        // w = w * weight_of(i, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__weighted, matches__weights)       <L 14>
        var_27 = weight_of_2(var_i, var_matches__jobs__sources__first_positions, var_matches__jobs__group_jobs, var_matches__jobs__job_groups, var_matches__jobs__job_sources, var_matches__weighted, var_matches__weights);
        var_28 = wp::mul(var_26, var_27);
    }
    var_29 = wp::where(var_9, var_17, var_4);
    var_30 = wp::where(var_9, var_18, var_6);
    var_31 = wp::where(var_9, var_28, var_7);
    // return count_pair(sum_pair(a, b, w), p, q, paired)                                     <L 15>
    var_32 = sum_pair_0(var_29, var_30, var_31);
    var_33 = count_pair_0(var_32, var_0, var_1, var_2);
    return var_33;
}


// <pointloom.kernels.icp.rows.read_covariance>:1
static CUDA_CALLABLE wp::mat_t<3, 3, wp::float64> read_covariance_0(
    wp::array_t<wp::float32> var_covariances,
    wp::int32 var_i)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::mat_t<3, 3, wp::float64> var_1;
    const wp::int32 var_2 = 0;
    const wp::int32 var_3 = 0;
    const wp::int32 var_4 = 3;
    wp::int32 var_5;
    wp::int32 var_6;
    wp::float32* var_7;
    wp::float64 var_8;
    wp::float32 var_9;
    const wp::int32 var_10 = 1;
    const wp::int32 var_11 = 3;
    wp::int32 var_12;
    wp::int32 var_13;
    wp::float32* var_14;
    wp::float64 var_15;
    wp::float32 var_16;
    const wp::int32 var_17 = 2;
    const wp::int32 var_18 = 3;
    wp::int32 var_19;
    wp::int32 var_20;
    wp::float32* var_21;
    wp::float64 var_22;
    wp::float32 var_23;
    const wp::int32 var_24 = 1;
    const wp::int32 var_25 = 0;
    const wp::int32 var_26 = 3;
    wp::int32 var_27;
    wp::int32 var_28;
    wp::float32* var_29;
    wp::float64 var_30;
    wp::float32 var_31;
    const wp::int32 var_32 = 1;
    const wp::int32 var_33 = 3;
    wp::int32 var_34;
    wp::int32 var_35;
    wp::float32* var_36;
    wp::float64 var_37;
    wp::float32 var_38;
    const wp::int32 var_39 = 2;
    const wp::int32 var_40 = 3;
    wp::int32 var_41;
    wp::int32 var_42;
    wp::float32* var_43;
    wp::float64 var_44;
    wp::float32 var_45;
    const wp::int32 var_46 = 2;
    const wp::int32 var_47 = 0;
    const wp::int32 var_48 = 3;
    wp::int32 var_49;
    wp::int32 var_50;
    wp::float32* var_51;
    wp::float64 var_52;
    wp::float32 var_53;
    const wp::int32 var_54 = 1;
    const wp::int32 var_55 = 3;
    wp::int32 var_56;
    wp::int32 var_57;
    wp::float32* var_58;
    wp::float64 var_59;
    wp::float32 var_60;
    const wp::int32 var_61 = 2;
    const wp::int32 var_62 = 3;
    wp::int32 var_63;
    wp::int32 var_64;
    wp::float32* var_65;
    wp::float64 var_66;
    wp::float32 var_67;
    //---------
    // forward
    // def read_covariance(covariances, i):                                                   <L 1>
    // C = mat33d(float64(0.0))                                                               <L 2>
    var_0 = 0.0;
    var_1 = wp::mat_t<3, 3, wp::float64>(var_0);
    // for row in range(3):                                                                   <L 3>
    // for column in range(3):                                                                <L 4>
    // C[row, column] = float64(covariances[i, 3 * row + column])                             <L 5>
    var_5 = wp::mul(var_4, var_2);
    var_6 = wp::add(var_5, var_3);
    var_7 = wp::address(var_covariances, var_i, var_6);
    var_9 = wp::load(var_7);
    var_8 = wp::float64(var_9);
    wp::assign_inplace(var_1, var_2, var_3, var_8);
    var_12 = wp::mul(var_11, var_2);
    var_13 = wp::add(var_12, var_10);
    var_14 = wp::address(var_covariances, var_i, var_13);
    var_16 = wp::load(var_14);
    var_15 = wp::float64(var_16);
    wp::assign_inplace(var_1, var_2, var_10, var_15);
    var_19 = wp::mul(var_18, var_2);
    var_20 = wp::add(var_19, var_17);
    var_21 = wp::address(var_covariances, var_i, var_20);
    var_23 = wp::load(var_21);
    var_22 = wp::float64(var_23);
    wp::assign_inplace(var_1, var_2, var_17, var_22);
    // for column in range(3):                                                                <L 4>
    // C[row, column] = float64(covariances[i, 3 * row + column])                             <L 5>
    var_27 = wp::mul(var_26, var_24);
    var_28 = wp::add(var_27, var_25);
    var_29 = wp::address(var_covariances, var_i, var_28);
    var_31 = wp::load(var_29);
    var_30 = wp::float64(var_31);
    wp::assign_inplace(var_1, var_24, var_25, var_30);
    var_34 = wp::mul(var_33, var_24);
    var_35 = wp::add(var_34, var_32);
    var_36 = wp::address(var_covariances, var_i, var_35);
    var_38 = wp::load(var_36);
    var_37 = wp::float64(var_38);
    wp::assign_inplace(var_1, var_24, var_32, var_37);
    var_41 = wp::mul(var_40, var_24);
    var_42 = wp::add(var_41, var_39);
    var_43 = wp::address(var_covariances, var_i, var_42);
    var_45 = wp::load(var_43);
    var_44 = wp::float64(var_45);
    wp::assign_inplace(var_1, var_24, var_39, var_44);
    // for column in range(3):                                                                <L 4>
    // C[row, column] = float64(covariances[i, 3 * row + column])                             <L 5>
    var_49 = wp::mul(var_48, var_46);
    var_50 = wp::add(var_49, var_47);
    var_51 = wp::address(var_covariances, var_i, var_50);
    var_53 = wp::load(var_51);
    var_52 = wp::float64(var_53);
    wp::assign_inplace(var_1, var_46, var_47, var_52);
    var_56 = wp::mul(var_55, var_46);
    var_57 = wp::add(var_56, var_54);
    var_58 = wp::address(var_covariances, var_i, var_57);
    var_60 = wp::load(var_58);
    var_59 = wp::float64(var_60);
    wp::assign_inplace(var_1, var_46, var_54, var_59);
    var_63 = wp::mul(var_62, var_46);
    var_64 = wp::add(var_63, var_61);
    var_65 = wp::address(var_covariances, var_i, var_64);
    var_67 = wp::load(var_65);
    var_66 = wp::float64(var_67);
    wp::assign_inplace(var_1, var_46, var_61, var_66);
    // return C                                                                               <L 6>
    return var_1;
}


// <pointloom.kernels.algebra.matrices.multiply33>:1
static CUDA_CALLABLE wp::mat_t<3, 3, wp::float64> multiply33_0(
    wp::mat_t<3, 3, wp::float64> var_a,
    wp::mat_t<3, 3, wp::float64> var_b)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::mat_t<3, 3, wp::float64> var_1;
    const wp::int32 var_2 = 0;
    const wp::int32 var_3 = 0;
    const wp::int32 var_4 = 0;
    wp::float64 var_5;
    const wp::int32 var_6 = 0;
    wp::float64 var_7;
    wp::float64 var_8;
    const wp::int32 var_9 = 1;
    wp::float64 var_10;
    const wp::int32 var_11 = 1;
    wp::float64 var_12;
    wp::float64 var_13;
    wp::float64 var_14;
    const wp::int32 var_15 = 2;
    wp::float64 var_16;
    const wp::int32 var_17 = 2;
    wp::float64 var_18;
    wp::float64 var_19;
    wp::float64 var_20;
    const wp::int32 var_21 = 1;
    const wp::int32 var_22 = 0;
    wp::float64 var_23;
    const wp::int32 var_24 = 0;
    wp::float64 var_25;
    wp::float64 var_26;
    const wp::int32 var_27 = 1;
    wp::float64 var_28;
    const wp::int32 var_29 = 1;
    wp::float64 var_30;
    wp::float64 var_31;
    wp::float64 var_32;
    const wp::int32 var_33 = 2;
    wp::float64 var_34;
    const wp::int32 var_35 = 2;
    wp::float64 var_36;
    wp::float64 var_37;
    wp::float64 var_38;
    const wp::int32 var_39 = 2;
    const wp::int32 var_40 = 0;
    wp::float64 var_41;
    const wp::int32 var_42 = 0;
    wp::float64 var_43;
    wp::float64 var_44;
    const wp::int32 var_45 = 1;
    wp::float64 var_46;
    const wp::int32 var_47 = 1;
    wp::float64 var_48;
    wp::float64 var_49;
    wp::float64 var_50;
    const wp::int32 var_51 = 2;
    wp::float64 var_52;
    const wp::int32 var_53 = 2;
    wp::float64 var_54;
    wp::float64 var_55;
    wp::float64 var_56;
    const wp::int32 var_57 = 1;
    const wp::int32 var_58 = 0;
    const wp::int32 var_59 = 0;
    wp::float64 var_60;
    const wp::int32 var_61 = 0;
    wp::float64 var_62;
    wp::float64 var_63;
    const wp::int32 var_64 = 1;
    wp::float64 var_65;
    const wp::int32 var_66 = 1;
    wp::float64 var_67;
    wp::float64 var_68;
    wp::float64 var_69;
    const wp::int32 var_70 = 2;
    wp::float64 var_71;
    const wp::int32 var_72 = 2;
    wp::float64 var_73;
    wp::float64 var_74;
    wp::float64 var_75;
    const wp::int32 var_76 = 1;
    const wp::int32 var_77 = 0;
    wp::float64 var_78;
    const wp::int32 var_79 = 0;
    wp::float64 var_80;
    wp::float64 var_81;
    const wp::int32 var_82 = 1;
    wp::float64 var_83;
    const wp::int32 var_84 = 1;
    wp::float64 var_85;
    wp::float64 var_86;
    wp::float64 var_87;
    const wp::int32 var_88 = 2;
    wp::float64 var_89;
    const wp::int32 var_90 = 2;
    wp::float64 var_91;
    wp::float64 var_92;
    wp::float64 var_93;
    const wp::int32 var_94 = 2;
    const wp::int32 var_95 = 0;
    wp::float64 var_96;
    const wp::int32 var_97 = 0;
    wp::float64 var_98;
    wp::float64 var_99;
    const wp::int32 var_100 = 1;
    wp::float64 var_101;
    const wp::int32 var_102 = 1;
    wp::float64 var_103;
    wp::float64 var_104;
    wp::float64 var_105;
    const wp::int32 var_106 = 2;
    wp::float64 var_107;
    const wp::int32 var_108 = 2;
    wp::float64 var_109;
    wp::float64 var_110;
    wp::float64 var_111;
    const wp::int32 var_112 = 2;
    const wp::int32 var_113 = 0;
    const wp::int32 var_114 = 0;
    wp::float64 var_115;
    const wp::int32 var_116 = 0;
    wp::float64 var_117;
    wp::float64 var_118;
    const wp::int32 var_119 = 1;
    wp::float64 var_120;
    const wp::int32 var_121 = 1;
    wp::float64 var_122;
    wp::float64 var_123;
    wp::float64 var_124;
    const wp::int32 var_125 = 2;
    wp::float64 var_126;
    const wp::int32 var_127 = 2;
    wp::float64 var_128;
    wp::float64 var_129;
    wp::float64 var_130;
    const wp::int32 var_131 = 1;
    const wp::int32 var_132 = 0;
    wp::float64 var_133;
    const wp::int32 var_134 = 0;
    wp::float64 var_135;
    wp::float64 var_136;
    const wp::int32 var_137 = 1;
    wp::float64 var_138;
    const wp::int32 var_139 = 1;
    wp::float64 var_140;
    wp::float64 var_141;
    wp::float64 var_142;
    const wp::int32 var_143 = 2;
    wp::float64 var_144;
    const wp::int32 var_145 = 2;
    wp::float64 var_146;
    wp::float64 var_147;
    wp::float64 var_148;
    const wp::int32 var_149 = 2;
    const wp::int32 var_150 = 0;
    wp::float64 var_151;
    const wp::int32 var_152 = 0;
    wp::float64 var_153;
    wp::float64 var_154;
    const wp::int32 var_155 = 1;
    wp::float64 var_156;
    const wp::int32 var_157 = 1;
    wp::float64 var_158;
    wp::float64 var_159;
    wp::float64 var_160;
    const wp::int32 var_161 = 2;
    wp::float64 var_162;
    const wp::int32 var_163 = 2;
    wp::float64 var_164;
    wp::float64 var_165;
    wp::float64 var_166;
    //---------
    // forward
    // def multiply33(a, b):                                                                  <L 1>
    // product = mat33d(float64(0.0))                                                         <L 2>
    var_0 = 0.0;
    var_1 = wp::mat_t<3, 3, wp::float64>(var_0);
    // for row in range(3):                                                                   <L 3>
    // for column in range(3):                                                                <L 4>
    // product[row, column] = a[row, 0] * b[0, column] + a[row, 1] * b[1, column] + a[row, 2] * b[2, column]       <L 5>
    var_5 = wp::extract(var_a, var_2, var_4);
    var_7 = wp::extract(var_b, var_6, var_3);
    var_8 = wp::mul(var_5, var_7);
    var_10 = wp::extract(var_a, var_2, var_9);
    var_12 = wp::extract(var_b, var_11, var_3);
    var_13 = wp::mul(var_10, var_12);
    var_14 = wp::add(var_8, var_13);
    var_16 = wp::extract(var_a, var_2, var_15);
    var_18 = wp::extract(var_b, var_17, var_3);
    var_19 = wp::mul(var_16, var_18);
    var_20 = wp::add(var_14, var_19);
    wp::assign_inplace(var_1, var_2, var_3, var_20);
    var_23 = wp::extract(var_a, var_2, var_22);
    var_25 = wp::extract(var_b, var_24, var_21);
    var_26 = wp::mul(var_23, var_25);
    var_28 = wp::extract(var_a, var_2, var_27);
    var_30 = wp::extract(var_b, var_29, var_21);
    var_31 = wp::mul(var_28, var_30);
    var_32 = wp::add(var_26, var_31);
    var_34 = wp::extract(var_a, var_2, var_33);
    var_36 = wp::extract(var_b, var_35, var_21);
    var_37 = wp::mul(var_34, var_36);
    var_38 = wp::add(var_32, var_37);
    wp::assign_inplace(var_1, var_2, var_21, var_38);
    var_41 = wp::extract(var_a, var_2, var_40);
    var_43 = wp::extract(var_b, var_42, var_39);
    var_44 = wp::mul(var_41, var_43);
    var_46 = wp::extract(var_a, var_2, var_45);
    var_48 = wp::extract(var_b, var_47, var_39);
    var_49 = wp::mul(var_46, var_48);
    var_50 = wp::add(var_44, var_49);
    var_52 = wp::extract(var_a, var_2, var_51);
    var_54 = wp::extract(var_b, var_53, var_39);
    var_55 = wp::mul(var_52, var_54);
    var_56 = wp::add(var_50, var_55);
    wp::assign_inplace(var_1, var_2, var_39, var_56);
    // for column in range(3):                                                                <L 4>
    // product[row, column] = a[row, 0] * b[0, column] + a[row, 1] * b[1, column] + a[row, 2] * b[2, column]       <L 5>
    var_60 = wp::extract(var_a, var_57, var_59);
    var_62 = wp::extract(var_b, var_61, var_58);
    var_63 = wp::mul(var_60, var_62);
    var_65 = wp::extract(var_a, var_57, var_64);
    var_67 = wp::extract(var_b, var_66, var_58);
    var_68 = wp::mul(var_65, var_67);
    var_69 = wp::add(var_63, var_68);
    var_71 = wp::extract(var_a, var_57, var_70);
    var_73 = wp::extract(var_b, var_72, var_58);
    var_74 = wp::mul(var_71, var_73);
    var_75 = wp::add(var_69, var_74);
    wp::assign_inplace(var_1, var_57, var_58, var_75);
    var_78 = wp::extract(var_a, var_57, var_77);
    var_80 = wp::extract(var_b, var_79, var_76);
    var_81 = wp::mul(var_78, var_80);
    var_83 = wp::extract(var_a, var_57, var_82);
    var_85 = wp::extract(var_b, var_84, var_76);
    var_86 = wp::mul(var_83, var_85);
    var_87 = wp::add(var_81, var_86);
    var_89 = wp::extract(var_a, var_57, var_88);
    var_91 = wp::extract(var_b, var_90, var_76);
    var_92 = wp::mul(var_89, var_91);
    var_93 = wp::add(var_87, var_92);
    wp::assign_inplace(var_1, var_57, var_76, var_93);
    var_96 = wp::extract(var_a, var_57, var_95);
    var_98 = wp::extract(var_b, var_97, var_94);
    var_99 = wp::mul(var_96, var_98);
    var_101 = wp::extract(var_a, var_57, var_100);
    var_103 = wp::extract(var_b, var_102, var_94);
    var_104 = wp::mul(var_101, var_103);
    var_105 = wp::add(var_99, var_104);
    var_107 = wp::extract(var_a, var_57, var_106);
    var_109 = wp::extract(var_b, var_108, var_94);
    var_110 = wp::mul(var_107, var_109);
    var_111 = wp::add(var_105, var_110);
    wp::assign_inplace(var_1, var_57, var_94, var_111);
    // for column in range(3):                                                                <L 4>
    // product[row, column] = a[row, 0] * b[0, column] + a[row, 1] * b[1, column] + a[row, 2] * b[2, column]       <L 5>
    var_115 = wp::extract(var_a, var_112, var_114);
    var_117 = wp::extract(var_b, var_116, var_113);
    var_118 = wp::mul(var_115, var_117);
    var_120 = wp::extract(var_a, var_112, var_119);
    var_122 = wp::extract(var_b, var_121, var_113);
    var_123 = wp::mul(var_120, var_122);
    var_124 = wp::add(var_118, var_123);
    var_126 = wp::extract(var_a, var_112, var_125);
    var_128 = wp::extract(var_b, var_127, var_113);
    var_129 = wp::mul(var_126, var_128);
    var_130 = wp::add(var_124, var_129);
    wp::assign_inplace(var_1, var_112, var_113, var_130);
    var_133 = wp::extract(var_a, var_112, var_132);
    var_135 = wp::extract(var_b, var_134, var_131);
    var_136 = wp::mul(var_133, var_135);
    var_138 = wp::extract(var_a, var_112, var_137);
    var_140 = wp::extract(var_b, var_139, var_131);
    var_141 = wp::mul(var_138, var_140);
    var_142 = wp::add(var_136, var_141);
    var_144 = wp::extract(var_a, var_112, var_143);
    var_146 = wp::extract(var_b, var_145, var_131);
    var_147 = wp::mul(var_144, var_146);
    var_148 = wp::add(var_142, var_147);
    wp::assign_inplace(var_1, var_112, var_131, var_148);
    var_151 = wp::extract(var_a, var_112, var_150);
    var_153 = wp::extract(var_b, var_152, var_149);
    var_154 = wp::mul(var_151, var_153);
    var_156 = wp::extract(var_a, var_112, var_155);
    var_158 = wp::extract(var_b, var_157, var_149);
    var_159 = wp::mul(var_156, var_158);
    var_160 = wp::add(var_154, var_159);
    var_162 = wp::extract(var_a, var_112, var_161);
    var_164 = wp::extract(var_b, var_163, var_149);
    var_165 = wp::mul(var_162, var_164);
    var_166 = wp::add(var_160, var_165);
    wp::assign_inplace(var_1, var_112, var_149, var_166);
    // return product                                                                         <L 6>
    return var_1;
}


// <pointloom.kernels.icp.rows.rotate_covariance>:1
static CUDA_CALLABLE wp::mat_t<3, 3, wp::float64> rotate_covariance_0(
    wp::mat_t<4, 4, wp::float64> var_pose,
    wp::mat_t<3, 3, wp::float64> var_C)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::mat_t<3, 3, wp::float64> var_1;
    const wp::int32 var_2 = 0;
    const wp::int32 var_3 = 0;
    wp::float64 var_4;
    const wp::int32 var_5 = 1;
    wp::float64 var_6;
    const wp::int32 var_7 = 2;
    wp::float64 var_8;
    const wp::int32 var_9 = 1;
    const wp::int32 var_10 = 0;
    wp::float64 var_11;
    const wp::int32 var_12 = 1;
    wp::float64 var_13;
    const wp::int32 var_14 = 2;
    wp::float64 var_15;
    const wp::int32 var_16 = 2;
    const wp::int32 var_17 = 0;
    wp::float64 var_18;
    const wp::int32 var_19 = 1;
    wp::float64 var_20;
    const wp::int32 var_21 = 2;
    wp::float64 var_22;
    wp::mat_t<3, 3, wp::float64> var_23;
    wp::float64 var_24;
    wp::mat_t<3, 3, wp::float64> var_25;
    const wp::int32 var_26 = 0;
    const wp::int32 var_27 = 0;
    const wp::int32 var_28 = 0;
    wp::float64 var_29;
    const wp::int32 var_30 = 0;
    wp::float64 var_31;
    wp::float64 var_32;
    const wp::int32 var_33 = 1;
    wp::float64 var_34;
    const wp::int32 var_35 = 1;
    wp::float64 var_36;
    wp::float64 var_37;
    wp::float64 var_38;
    const wp::int32 var_39 = 2;
    wp::float64 var_40;
    const wp::int32 var_41 = 2;
    wp::float64 var_42;
    wp::float64 var_43;
    wp::float64 var_44;
    const wp::int32 var_45 = 1;
    const wp::int32 var_46 = 0;
    wp::float64 var_47;
    const wp::int32 var_48 = 0;
    wp::float64 var_49;
    wp::float64 var_50;
    const wp::int32 var_51 = 1;
    wp::float64 var_52;
    const wp::int32 var_53 = 1;
    wp::float64 var_54;
    wp::float64 var_55;
    wp::float64 var_56;
    const wp::int32 var_57 = 2;
    wp::float64 var_58;
    const wp::int32 var_59 = 2;
    wp::float64 var_60;
    wp::float64 var_61;
    wp::float64 var_62;
    const wp::int32 var_63 = 2;
    const wp::int32 var_64 = 0;
    wp::float64 var_65;
    const wp::int32 var_66 = 0;
    wp::float64 var_67;
    wp::float64 var_68;
    const wp::int32 var_69 = 1;
    wp::float64 var_70;
    const wp::int32 var_71 = 1;
    wp::float64 var_72;
    wp::float64 var_73;
    wp::float64 var_74;
    const wp::int32 var_75 = 2;
    wp::float64 var_76;
    const wp::int32 var_77 = 2;
    wp::float64 var_78;
    wp::float64 var_79;
    wp::float64 var_80;
    const wp::int32 var_81 = 1;
    const wp::int32 var_82 = 0;
    const wp::int32 var_83 = 0;
    wp::float64 var_84;
    const wp::int32 var_85 = 0;
    wp::float64 var_86;
    wp::float64 var_87;
    const wp::int32 var_88 = 1;
    wp::float64 var_89;
    const wp::int32 var_90 = 1;
    wp::float64 var_91;
    wp::float64 var_92;
    wp::float64 var_93;
    const wp::int32 var_94 = 2;
    wp::float64 var_95;
    const wp::int32 var_96 = 2;
    wp::float64 var_97;
    wp::float64 var_98;
    wp::float64 var_99;
    const wp::int32 var_100 = 1;
    const wp::int32 var_101 = 0;
    wp::float64 var_102;
    const wp::int32 var_103 = 0;
    wp::float64 var_104;
    wp::float64 var_105;
    const wp::int32 var_106 = 1;
    wp::float64 var_107;
    const wp::int32 var_108 = 1;
    wp::float64 var_109;
    wp::float64 var_110;
    wp::float64 var_111;
    const wp::int32 var_112 = 2;
    wp::float64 var_113;
    const wp::int32 var_114 = 2;
    wp::float64 var_115;
    wp::float64 var_116;
    wp::float64 var_117;
    const wp::int32 var_118 = 2;
    const wp::int32 var_119 = 0;
    wp::float64 var_120;
    const wp::int32 var_121 = 0;
    wp::float64 var_122;
    wp::float64 var_123;
    const wp::int32 var_124 = 1;
    wp::float64 var_125;
    const wp::int32 var_126 = 1;
    wp::float64 var_127;
    wp::float64 var_128;
    wp::float64 var_129;
    const wp::int32 var_130 = 2;
    wp::float64 var_131;
    const wp::int32 var_132 = 2;
    wp::float64 var_133;
    wp::float64 var_134;
    wp::float64 var_135;
    const wp::int32 var_136 = 2;
    const wp::int32 var_137 = 0;
    const wp::int32 var_138 = 0;
    wp::float64 var_139;
    const wp::int32 var_140 = 0;
    wp::float64 var_141;
    wp::float64 var_142;
    const wp::int32 var_143 = 1;
    wp::float64 var_144;
    const wp::int32 var_145 = 1;
    wp::float64 var_146;
    wp::float64 var_147;
    wp::float64 var_148;
    const wp::int32 var_149 = 2;
    wp::float64 var_150;
    const wp::int32 var_151 = 2;
    wp::float64 var_152;
    wp::float64 var_153;
    wp::float64 var_154;
    const wp::int32 var_155 = 1;
    const wp::int32 var_156 = 0;
    wp::float64 var_157;
    const wp::int32 var_158 = 0;
    wp::float64 var_159;
    wp::float64 var_160;
    const wp::int32 var_161 = 1;
    wp::float64 var_162;
    const wp::int32 var_163 = 1;
    wp::float64 var_164;
    wp::float64 var_165;
    wp::float64 var_166;
    const wp::int32 var_167 = 2;
    wp::float64 var_168;
    const wp::int32 var_169 = 2;
    wp::float64 var_170;
    wp::float64 var_171;
    wp::float64 var_172;
    const wp::int32 var_173 = 2;
    const wp::int32 var_174 = 0;
    wp::float64 var_175;
    const wp::int32 var_176 = 0;
    wp::float64 var_177;
    wp::float64 var_178;
    const wp::int32 var_179 = 1;
    wp::float64 var_180;
    const wp::int32 var_181 = 1;
    wp::float64 var_182;
    wp::float64 var_183;
    wp::float64 var_184;
    const wp::int32 var_185 = 2;
    wp::float64 var_186;
    const wp::int32 var_187 = 2;
    wp::float64 var_188;
    wp::float64 var_189;
    wp::float64 var_190;
    //---------
    // forward
    // def rotate_covariance(pose, C):                                                        <L 1>
    // R = mat33d(float64(0.0))                                                               <L 2>
    var_0 = 0.0;
    var_1 = wp::mat_t<3, 3, wp::float64>(var_0);
    // for row in range(3):                                                                   <L 3>
    // for column in range(3):                                                                <L 4>
    // R[row, column] = pose[row, column]                                                     <L 5>
    var_4 = wp::extract(var_pose, var_2, var_3);
    wp::assign_inplace(var_1, var_2, var_3, var_4);
    var_6 = wp::extract(var_pose, var_2, var_5);
    wp::assign_inplace(var_1, var_2, var_5, var_6);
    var_8 = wp::extract(var_pose, var_2, var_7);
    wp::assign_inplace(var_1, var_2, var_7, var_8);
    // for column in range(3):                                                                <L 4>
    // R[row, column] = pose[row, column]                                                     <L 5>
    var_11 = wp::extract(var_pose, var_9, var_10);
    wp::assign_inplace(var_1, var_9, var_10, var_11);
    var_13 = wp::extract(var_pose, var_9, var_12);
    wp::assign_inplace(var_1, var_9, var_12, var_13);
    var_15 = wp::extract(var_pose, var_9, var_14);
    wp::assign_inplace(var_1, var_9, var_14, var_15);
    // for column in range(3):                                                                <L 4>
    // R[row, column] = pose[row, column]                                                     <L 5>
    var_18 = wp::extract(var_pose, var_16, var_17);
    wp::assign_inplace(var_1, var_16, var_17, var_18);
    var_20 = wp::extract(var_pose, var_16, var_19);
    wp::assign_inplace(var_1, var_16, var_19, var_20);
    var_22 = wp::extract(var_pose, var_16, var_21);
    wp::assign_inplace(var_1, var_16, var_21, var_22);
    // RC = multiply33(R, C)                                                                  <L 6>
    var_23 = multiply33_0(var_1, var_C);
    // out = mat33d(float64(0.0))                                                             <L 7>
    var_24 = 0.0;
    var_25 = wp::mat_t<3, 3, wp::float64>(var_24);
    // for row in range(3):                                                                   <L 8>
    // for column in range(3):                                                                <L 9>
    // out[row, column] = RC[row, 0] * R[column, 0] + RC[row, 1] * R[column, 1] + RC[row, 2] * R[column, 2]       <L 10>
    var_29 = wp::extract(var_23, var_26, var_28);
    var_31 = wp::extract(var_1, var_27, var_30);
    var_32 = wp::mul(var_29, var_31);
    var_34 = wp::extract(var_23, var_26, var_33);
    var_36 = wp::extract(var_1, var_27, var_35);
    var_37 = wp::mul(var_34, var_36);
    var_38 = wp::add(var_32, var_37);
    var_40 = wp::extract(var_23, var_26, var_39);
    var_42 = wp::extract(var_1, var_27, var_41);
    var_43 = wp::mul(var_40, var_42);
    var_44 = wp::add(var_38, var_43);
    wp::assign_inplace(var_25, var_26, var_27, var_44);
    var_47 = wp::extract(var_23, var_26, var_46);
    var_49 = wp::extract(var_1, var_45, var_48);
    var_50 = wp::mul(var_47, var_49);
    var_52 = wp::extract(var_23, var_26, var_51);
    var_54 = wp::extract(var_1, var_45, var_53);
    var_55 = wp::mul(var_52, var_54);
    var_56 = wp::add(var_50, var_55);
    var_58 = wp::extract(var_23, var_26, var_57);
    var_60 = wp::extract(var_1, var_45, var_59);
    var_61 = wp::mul(var_58, var_60);
    var_62 = wp::add(var_56, var_61);
    wp::assign_inplace(var_25, var_26, var_45, var_62);
    var_65 = wp::extract(var_23, var_26, var_64);
    var_67 = wp::extract(var_1, var_63, var_66);
    var_68 = wp::mul(var_65, var_67);
    var_70 = wp::extract(var_23, var_26, var_69);
    var_72 = wp::extract(var_1, var_63, var_71);
    var_73 = wp::mul(var_70, var_72);
    var_74 = wp::add(var_68, var_73);
    var_76 = wp::extract(var_23, var_26, var_75);
    var_78 = wp::extract(var_1, var_63, var_77);
    var_79 = wp::mul(var_76, var_78);
    var_80 = wp::add(var_74, var_79);
    wp::assign_inplace(var_25, var_26, var_63, var_80);
    // for column in range(3):                                                                <L 9>
    // out[row, column] = RC[row, 0] * R[column, 0] + RC[row, 1] * R[column, 1] + RC[row, 2] * R[column, 2]       <L 10>
    var_84 = wp::extract(var_23, var_81, var_83);
    var_86 = wp::extract(var_1, var_82, var_85);
    var_87 = wp::mul(var_84, var_86);
    var_89 = wp::extract(var_23, var_81, var_88);
    var_91 = wp::extract(var_1, var_82, var_90);
    var_92 = wp::mul(var_89, var_91);
    var_93 = wp::add(var_87, var_92);
    var_95 = wp::extract(var_23, var_81, var_94);
    var_97 = wp::extract(var_1, var_82, var_96);
    var_98 = wp::mul(var_95, var_97);
    var_99 = wp::add(var_93, var_98);
    wp::assign_inplace(var_25, var_81, var_82, var_99);
    var_102 = wp::extract(var_23, var_81, var_101);
    var_104 = wp::extract(var_1, var_100, var_103);
    var_105 = wp::mul(var_102, var_104);
    var_107 = wp::extract(var_23, var_81, var_106);
    var_109 = wp::extract(var_1, var_100, var_108);
    var_110 = wp::mul(var_107, var_109);
    var_111 = wp::add(var_105, var_110);
    var_113 = wp::extract(var_23, var_81, var_112);
    var_115 = wp::extract(var_1, var_100, var_114);
    var_116 = wp::mul(var_113, var_115);
    var_117 = wp::add(var_111, var_116);
    wp::assign_inplace(var_25, var_81, var_100, var_117);
    var_120 = wp::extract(var_23, var_81, var_119);
    var_122 = wp::extract(var_1, var_118, var_121);
    var_123 = wp::mul(var_120, var_122);
    var_125 = wp::extract(var_23, var_81, var_124);
    var_127 = wp::extract(var_1, var_118, var_126);
    var_128 = wp::mul(var_125, var_127);
    var_129 = wp::add(var_123, var_128);
    var_131 = wp::extract(var_23, var_81, var_130);
    var_133 = wp::extract(var_1, var_118, var_132);
    var_134 = wp::mul(var_131, var_133);
    var_135 = wp::add(var_129, var_134);
    wp::assign_inplace(var_25, var_81, var_118, var_135);
    // for column in range(3):                                                                <L 9>
    // out[row, column] = RC[row, 0] * R[column, 0] + RC[row, 1] * R[column, 1] + RC[row, 2] * R[column, 2]       <L 10>
    var_139 = wp::extract(var_23, var_136, var_138);
    var_141 = wp::extract(var_1, var_137, var_140);
    var_142 = wp::mul(var_139, var_141);
    var_144 = wp::extract(var_23, var_136, var_143);
    var_146 = wp::extract(var_1, var_137, var_145);
    var_147 = wp::mul(var_144, var_146);
    var_148 = wp::add(var_142, var_147);
    var_150 = wp::extract(var_23, var_136, var_149);
    var_152 = wp::extract(var_1, var_137, var_151);
    var_153 = wp::mul(var_150, var_152);
    var_154 = wp::add(var_148, var_153);
    wp::assign_inplace(var_25, var_136, var_137, var_154);
    var_157 = wp::extract(var_23, var_136, var_156);
    var_159 = wp::extract(var_1, var_155, var_158);
    var_160 = wp::mul(var_157, var_159);
    var_162 = wp::extract(var_23, var_136, var_161);
    var_164 = wp::extract(var_1, var_155, var_163);
    var_165 = wp::mul(var_162, var_164);
    var_166 = wp::add(var_160, var_165);
    var_168 = wp::extract(var_23, var_136, var_167);
    var_170 = wp::extract(var_1, var_155, var_169);
    var_171 = wp::mul(var_168, var_170);
    var_172 = wp::add(var_166, var_171);
    wp::assign_inplace(var_25, var_136, var_155, var_172);
    var_175 = wp::extract(var_23, var_136, var_174);
    var_177 = wp::extract(var_1, var_173, var_176);
    var_178 = wp::mul(var_175, var_177);
    var_180 = wp::extract(var_23, var_136, var_179);
    var_182 = wp::extract(var_1, var_173, var_181);
    var_183 = wp::mul(var_180, var_182);
    var_184 = wp::add(var_178, var_183);
    var_186 = wp::extract(var_23, var_136, var_185);
    var_188 = wp::extract(var_1, var_173, var_187);
    var_189 = wp::mul(var_186, var_188);
    var_190 = wp::add(var_184, var_189);
    wp::assign_inplace(var_25, var_136, var_173, var_190);
    // return out                                                                             <L 11>
    return var_25;
}


// <pointloom.kernels.icp.rows.inverse>:1
static CUDA_CALLABLE wp::mat_t<3, 3, wp::float64> inverse_0(
    wp::mat_t<3, 3, wp::float64> var_M)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 1;
    const wp::int32 var_1 = 1;
    wp::float64 var_2;
    const wp::int32 var_3 = 2;
    const wp::int32 var_4 = 2;
    wp::float64 var_5;
    wp::float64 var_6;
    const wp::int32 var_7 = 1;
    const wp::int32 var_8 = 2;
    wp::float64 var_9;
    const wp::int32 var_10 = 1;
    const wp::int32 var_11 = 2;
    wp::float64 var_12;
    wp::float64 var_13;
    wp::float64 var_14;
    const wp::int32 var_15 = 0;
    const wp::int32 var_16 = 2;
    wp::float64 var_17;
    const wp::int32 var_18 = 1;
    const wp::int32 var_19 = 2;
    wp::float64 var_20;
    wp::float64 var_21;
    const wp::int32 var_22 = 0;
    const wp::int32 var_23 = 1;
    wp::float64 var_24;
    const wp::int32 var_25 = 2;
    const wp::int32 var_26 = 2;
    wp::float64 var_27;
    wp::float64 var_28;
    wp::float64 var_29;
    const wp::int32 var_30 = 0;
    const wp::int32 var_31 = 1;
    wp::float64 var_32;
    const wp::int32 var_33 = 1;
    const wp::int32 var_34 = 2;
    wp::float64 var_35;
    wp::float64 var_36;
    const wp::int32 var_37 = 0;
    const wp::int32 var_38 = 2;
    wp::float64 var_39;
    const wp::int32 var_40 = 1;
    const wp::int32 var_41 = 1;
    wp::float64 var_42;
    wp::float64 var_43;
    wp::float64 var_44;
    const wp::int32 var_45 = 0;
    const wp::int32 var_46 = 0;
    wp::float64 var_47;
    wp::float64 var_48;
    const wp::int32 var_49 = 0;
    const wp::int32 var_50 = 1;
    wp::float64 var_51;
    wp::float64 var_52;
    wp::float64 var_53;
    const wp::int32 var_54 = 0;
    const wp::int32 var_55 = 2;
    wp::float64 var_56;
    wp::float64 var_57;
    wp::float64 var_58;
    wp::float64 var_59;
    wp::float64 var_60;
    bool var_61;
    wp::float64 var_62;
    wp::float64 var_63;
    wp::float64 var_64;
    const wp::int32 var_65 = 0;
    const wp::int32 var_66 = 0;
    wp::float64 var_67;
    const wp::int32 var_68 = 2;
    const wp::int32 var_69 = 2;
    wp::float64 var_70;
    wp::float64 var_71;
    const wp::int32 var_72 = 0;
    const wp::int32 var_73 = 2;
    wp::float64 var_74;
    const wp::int32 var_75 = 0;
    const wp::int32 var_76 = 2;
    wp::float64 var_77;
    wp::float64 var_78;
    wp::float64 var_79;
    wp::float64 var_80;
    const wp::int32 var_81 = 0;
    const wp::int32 var_82 = 1;
    wp::float64 var_83;
    const wp::int32 var_84 = 0;
    const wp::int32 var_85 = 2;
    wp::float64 var_86;
    wp::float64 var_87;
    const wp::int32 var_88 = 0;
    const wp::int32 var_89 = 0;
    wp::float64 var_90;
    const wp::int32 var_91 = 1;
    const wp::int32 var_92 = 2;
    wp::float64 var_93;
    wp::float64 var_94;
    wp::float64 var_95;
    wp::float64 var_96;
    const wp::int32 var_97 = 0;
    const wp::int32 var_98 = 0;
    wp::float64 var_99;
    const wp::int32 var_100 = 1;
    const wp::int32 var_101 = 1;
    wp::float64 var_102;
    wp::float64 var_103;
    const wp::int32 var_104 = 0;
    const wp::int32 var_105 = 1;
    wp::float64 var_106;
    const wp::int32 var_107 = 0;
    const wp::int32 var_108 = 1;
    wp::float64 var_109;
    wp::float64 var_110;
    wp::float64 var_111;
    wp::float64 var_112;
    wp::float64 var_113;
    wp::float64 var_114;
    wp::float64 var_115;
    wp::float64 var_116;
    wp::float64 var_117;
    wp::mat_t<3, 3, wp::float64> var_118;
    //---------
    // forward
    // def inverse(M):                                                                        <L 1>
    // x = M[1, 1] * M[2, 2] - M[1, 2] * M[1, 2]                                              <L 3>
    var_2 = wp::extract(var_M, var_0, var_1);
    var_5 = wp::extract(var_M, var_3, var_4);
    var_6 = wp::mul(var_2, var_5);
    var_9 = wp::extract(var_M, var_7, var_8);
    var_12 = wp::extract(var_M, var_10, var_11);
    var_13 = wp::mul(var_9, var_12);
    var_14 = wp::sub(var_6, var_13);
    // y = M[0, 2] * M[1, 2] - M[0, 1] * M[2, 2]                                              <L 4>
    var_17 = wp::extract(var_M, var_15, var_16);
    var_20 = wp::extract(var_M, var_18, var_19);
    var_21 = wp::mul(var_17, var_20);
    var_24 = wp::extract(var_M, var_22, var_23);
    var_27 = wp::extract(var_M, var_25, var_26);
    var_28 = wp::mul(var_24, var_27);
    var_29 = wp::sub(var_21, var_28);
    // z = M[0, 1] * M[1, 2] - M[0, 2] * M[1, 1]                                              <L 5>
    var_32 = wp::extract(var_M, var_30, var_31);
    var_35 = wp::extract(var_M, var_33, var_34);
    var_36 = wp::mul(var_32, var_35);
    var_39 = wp::extract(var_M, var_37, var_38);
    var_42 = wp::extract(var_M, var_40, var_41);
    var_43 = wp::mul(var_39, var_42);
    var_44 = wp::sub(var_36, var_43);
    // det = M[0, 0] * x + M[0, 1] * y + M[0, 2] * z                                          <L 6>
    var_47 = wp::extract(var_M, var_45, var_46);
    var_48 = wp::mul(var_47, var_14);
    var_51 = wp::extract(var_M, var_49, var_50);
    var_52 = wp::mul(var_51, var_29);
    var_53 = wp::add(var_48, var_52);
    var_56 = wp::extract(var_M, var_54, var_55);
    var_57 = wp::mul(var_56, var_44);
    var_58 = wp::add(var_53, var_57);
    // s = float64(0.0)                                                                       <L 7>
    var_59 = 0.0;
    // if det > float64(0.0):                                                                 <L 8>
    var_60 = 0.0;
    var_61 = (var_58 > var_60);
    if (var_61) {
        // s = float64(1.0) / det                                                             <L 9>
        var_62 = 1.0;
        var_63 = wp::div(var_62, var_58);
    }
    var_64 = wp::where(var_61, var_63, var_59);
    // a = (M[0, 0] * M[2, 2] - M[0, 2] * M[0, 2]) * s                                        <L 10>
    var_67 = wp::extract(var_M, var_65, var_66);
    var_70 = wp::extract(var_M, var_68, var_69);
    var_71 = wp::mul(var_67, var_70);
    var_74 = wp::extract(var_M, var_72, var_73);
    var_77 = wp::extract(var_M, var_75, var_76);
    var_78 = wp::mul(var_74, var_77);
    var_79 = wp::sub(var_71, var_78);
    var_80 = wp::mul(var_79, var_64);
    // b = (M[0, 1] * M[0, 2] - M[0, 0] * M[1, 2]) * s                                        <L 11>
    var_83 = wp::extract(var_M, var_81, var_82);
    var_86 = wp::extract(var_M, var_84, var_85);
    var_87 = wp::mul(var_83, var_86);
    var_90 = wp::extract(var_M, var_88, var_89);
    var_93 = wp::extract(var_M, var_91, var_92);
    var_94 = wp::mul(var_90, var_93);
    var_95 = wp::sub(var_87, var_94);
    var_96 = wp::mul(var_95, var_64);
    // c = (M[0, 0] * M[1, 1] - M[0, 1] * M[0, 1]) * s                                        <L 12>
    var_99 = wp::extract(var_M, var_97, var_98);
    var_102 = wp::extract(var_M, var_100, var_101);
    var_103 = wp::mul(var_99, var_102);
    var_106 = wp::extract(var_M, var_104, var_105);
    var_109 = wp::extract(var_M, var_107, var_108);
    var_110 = wp::mul(var_106, var_109);
    var_111 = wp::sub(var_103, var_110);
    var_112 = wp::mul(var_111, var_64);
    // return mat33d(x * s, y * s, z * s, y * s, a, b, z * s, b, c)                           <L 13>
    var_113 = wp::mul(var_14, var_64);
    var_114 = wp::mul(var_29, var_64);
    var_115 = wp::mul(var_44, var_64);
    var_116 = wp::mul(var_29, var_64);
    var_117 = wp::mul(var_44, var_64);
    var_118 = wp::mat_t<3, 3, wp::float64>(var_113, var_114, var_115, var_116, var_80, var_96, var_117, var_96, var_112);
    return var_118;
}


// /work/main/src/pointloom/kernels/icp/rows.py:96
static CUDA_CALLABLE wp::float64 trace_of_square_0(
    wp::mat_t<3, 3, wp::float64> var_M)
{
    //---------
    // primal vars
    wp::float64 var_0;
    const wp::int32 var_1 = 0;
    const wp::int32 var_2 = 0;
    wp::float64 var_3;
    wp::float64 var_4;
    wp::float64 var_5;
    wp::float64 var_6;
    const wp::int32 var_7 = 1;
    wp::float64 var_8;
    wp::float64 var_9;
    wp::float64 var_10;
    wp::float64 var_11;
    const wp::int32 var_12 = 2;
    wp::float64 var_13;
    wp::float64 var_14;
    wp::float64 var_15;
    wp::float64 var_16;
    const wp::int32 var_17 = 1;
    const wp::int32 var_18 = 0;
    wp::float64 var_19;
    wp::float64 var_20;
    wp::float64 var_21;
    wp::float64 var_22;
    const wp::int32 var_23 = 1;
    wp::float64 var_24;
    wp::float64 var_25;
    wp::float64 var_26;
    wp::float64 var_27;
    const wp::int32 var_28 = 2;
    wp::float64 var_29;
    wp::float64 var_30;
    wp::float64 var_31;
    wp::float64 var_32;
    const wp::int32 var_33 = 2;
    const wp::int32 var_34 = 0;
    wp::float64 var_35;
    wp::float64 var_36;
    wp::float64 var_37;
    wp::float64 var_38;
    const wp::int32 var_39 = 1;
    wp::float64 var_40;
    wp::float64 var_41;
    wp::float64 var_42;
    wp::float64 var_43;
    const wp::int32 var_44 = 2;
    wp::float64 var_45;
    wp::float64 var_46;
    wp::float64 var_47;
    wp::float64 var_48;
    //---------
    // forward
    // def trace_of_square(M: mat33d) -> float64:                                             <L 97>
    // total = float64(0.0)                                                                   <L 98>
    var_0 = 0.0;
    // for row in range(3):                                                                   <L 99>
    // for column in range(3):                                                                <L 100>
    // total += M[row, column] * M[row, column]                                               <L 101>
    var_3 = wp::extract(var_M, var_1, var_2);
    var_4 = wp::extract(var_M, var_1, var_2);
    var_5 = wp::mul(var_3, var_4);
    var_6 = wp::add(var_0, var_5);
    var_8 = wp::extract(var_M, var_1, var_7);
    var_9 = wp::extract(var_M, var_1, var_7);
    var_10 = wp::mul(var_8, var_9);
    var_11 = wp::add(var_6, var_10);
    var_13 = wp::extract(var_M, var_1, var_12);
    var_14 = wp::extract(var_M, var_1, var_12);
    var_15 = wp::mul(var_13, var_14);
    var_16 = wp::add(var_11, var_15);
    // for column in range(3):                                                                <L 100>
    // total += M[row, column] * M[row, column]                                               <L 101>
    var_19 = wp::extract(var_M, var_17, var_18);
    var_20 = wp::extract(var_M, var_17, var_18);
    var_21 = wp::mul(var_19, var_20);
    var_22 = wp::add(var_16, var_21);
    var_24 = wp::extract(var_M, var_17, var_23);
    var_25 = wp::extract(var_M, var_17, var_23);
    var_26 = wp::mul(var_24, var_25);
    var_27 = wp::add(var_22, var_26);
    var_29 = wp::extract(var_M, var_17, var_28);
    var_30 = wp::extract(var_M, var_17, var_28);
    var_31 = wp::mul(var_29, var_30);
    var_32 = wp::add(var_27, var_31);
    // for column in range(3):                                                                <L 100>
    // total += M[row, column] * M[row, column]                                               <L 101>
    var_35 = wp::extract(var_M, var_33, var_34);
    var_36 = wp::extract(var_M, var_33, var_34);
    var_37 = wp::mul(var_35, var_36);
    var_38 = wp::add(var_32, var_37);
    var_40 = wp::extract(var_M, var_33, var_39);
    var_41 = wp::extract(var_M, var_33, var_39);
    var_42 = wp::mul(var_40, var_41);
    var_43 = wp::add(var_38, var_42);
    var_45 = wp::extract(var_M, var_33, var_44);
    var_46 = wp::extract(var_M, var_33, var_44);
    var_47 = wp::mul(var_45, var_46);
    var_48 = wp::add(var_43, var_47);
    // return total                                                                           <L 102>
    return var_48;
}


// /work/main/src/pointloom/kernels/icp/rows.py:131
static CUDA_CALLABLE wp::vec_t<36, wp::float64> sum_block_0(
    wp::vec_t<3, wp::float64> var_p,
    wp::mat_t<3, 3, wp::float64> var_A,
    wp::vec_t<3, wp::float64> var_d)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    const wp::int32 var_1 = 0;
    wp::float64 var_2;
    const wp::int32 var_3 = 1;
    const wp::int32 var_4 = 0;
    wp::float64 var_5;
    const wp::int32 var_6 = 2;
    const wp::int32 var_7 = 0;
    wp::float64 var_8;
    wp::vec_t<3, wp::float64> var_9;
    const wp::int32 var_10 = 0;
    const wp::int32 var_11 = 1;
    wp::float64 var_12;
    const wp::int32 var_13 = 1;
    const wp::int32 var_14 = 1;
    wp::float64 var_15;
    const wp::int32 var_16 = 2;
    const wp::int32 var_17 = 1;
    wp::float64 var_18;
    wp::vec_t<3, wp::float64> var_19;
    const wp::int32 var_20 = 0;
    const wp::int32 var_21 = 2;
    wp::float64 var_22;
    const wp::int32 var_23 = 1;
    const wp::int32 var_24 = 2;
    wp::float64 var_25;
    const wp::int32 var_26 = 2;
    const wp::int32 var_27 = 2;
    wp::float64 var_28;
    wp::vec_t<3, wp::float64> var_29;
    wp::vec_t<3, wp::float64> var_30;
    wp::vec_t<3, wp::float64> var_31;
    wp::vec_t<3, wp::float64> var_32;
    const wp::int32 var_33 = 0;
    wp::float64 var_34;
    const wp::int32 var_35 = 0;
    wp::float64 var_36;
    const wp::int32 var_37 = 0;
    wp::float64 var_38;
    wp::vec_t<3, wp::float64> var_39;
    wp::vec_t<3, wp::float64> var_40;
    const wp::int32 var_41 = 1;
    wp::float64 var_42;
    const wp::int32 var_43 = 1;
    wp::float64 var_44;
    const wp::int32 var_45 = 1;
    wp::float64 var_46;
    wp::vec_t<3, wp::float64> var_47;
    wp::vec_t<3, wp::float64> var_48;
    const wp::int32 var_49 = 2;
    wp::float64 var_50;
    const wp::int32 var_51 = 2;
    wp::float64 var_52;
    const wp::int32 var_53 = 2;
    wp::float64 var_54;
    wp::vec_t<3, wp::float64> var_55;
    wp::vec_t<3, wp::float64> var_56;
    const wp::int32 var_57 = 0;
    wp::float64 var_58;
    wp::vec_t<3, wp::float64> var_59;
    const wp::int32 var_60 = 1;
    wp::float64 var_61;
    wp::vec_t<3, wp::float64> var_62;
    wp::vec_t<3, wp::float64> var_63;
    const wp::int32 var_64 = 2;
    wp::float64 var_65;
    wp::vec_t<3, wp::float64> var_66;
    wp::vec_t<3, wp::float64> var_67;
    wp::vec_t<3, wp::float64> var_68;
    wp::float64 var_69;
    const wp::int32 var_70 = 0;
    wp::float64 var_71;
    const wp::int32 var_72 = 0;
    wp::float64 var_73;
    const wp::int32 var_74 = 0;
    wp::float64 var_75;
    const wp::int32 var_76 = 0;
    wp::float64 var_77;
    const wp::int32 var_78 = 0;
    wp::float64 var_79;
    const wp::int32 var_80 = 0;
    wp::float64 var_81;
    const wp::int32 var_82 = 1;
    wp::float64 var_83;
    const wp::int32 var_84 = 1;
    wp::float64 var_85;
    const wp::int32 var_86 = 1;
    wp::float64 var_87;
    const wp::int32 var_88 = 1;
    wp::float64 var_89;
    const wp::int32 var_90 = 1;
    wp::float64 var_91;
    const wp::int32 var_92 = 2;
    wp::float64 var_93;
    const wp::int32 var_94 = 2;
    wp::float64 var_95;
    const wp::int32 var_96 = 2;
    wp::float64 var_97;
    const wp::int32 var_98 = 2;
    wp::float64 var_99;
    const wp::int32 var_100 = 0;
    wp::float64 var_101;
    const wp::int32 var_102 = 0;
    wp::float64 var_103;
    const wp::int32 var_104 = 0;
    wp::float64 var_105;
    const wp::int32 var_106 = 1;
    wp::float64 var_107;
    const wp::int32 var_108 = 1;
    wp::float64 var_109;
    const wp::int32 var_110 = 2;
    wp::float64 var_111;
    const wp::int32 var_112 = 0;
    wp::float64 var_113;
    const wp::int32 var_114 = 1;
    wp::float64 var_115;
    const wp::int32 var_116 = 2;
    wp::float64 var_117;
    const wp::int32 var_118 = 0;
    wp::float64 var_119;
    const wp::int32 var_120 = 1;
    wp::float64 var_121;
    const wp::int32 var_122 = 2;
    wp::float64 var_123;
    wp::float64 var_124;
    wp::vec_t<36, wp::float64> var_125;
    //---------
    // forward
    // def sum_block(p: vec3d, A: mat33d, d: vec3d) -> row_sums:                              <L 132>
    // a = vec3d(A[0, 0], A[1, 0], A[2, 0])                                                   <L 134>
    var_2 = wp::extract(var_A, var_0, var_1);
    var_5 = wp::extract(var_A, var_3, var_4);
    var_8 = wp::extract(var_A, var_6, var_7);
    var_9 = wp::vec_t<3, wp::float64>(var_2, var_5, var_8);
    // b = vec3d(A[0, 1], A[1, 1], A[2, 1])                                                   <L 135>
    var_12 = wp::extract(var_A, var_10, var_11);
    var_15 = wp::extract(var_A, var_13, var_14);
    var_18 = wp::extract(var_A, var_16, var_17);
    var_19 = wp::vec_t<3, wp::float64>(var_12, var_15, var_18);
    // c = vec3d(A[0, 2], A[1, 2], A[2, 2])                                                   <L 136>
    var_22 = wp::extract(var_A, var_20, var_21);
    var_25 = wp::extract(var_A, var_23, var_24);
    var_28 = wp::extract(var_A, var_26, var_27);
    var_29 = wp::vec_t<3, wp::float64>(var_22, var_25, var_28);
    // ta = cross(p, a)                                                                       <L 137>
    var_30 = wp::cross(var_p, var_9);
    // tb = cross(p, b)                                                                       <L 138>
    var_31 = wp::cross(var_p, var_19);
    // tc = cross(p, c)                                                                       <L 139>
    var_32 = wp::cross(var_p, var_29);
    // x = cross(p, vec3d(ta[0], tb[0], tc[0]))                                               <L 140>
    var_34 = wp::extract(var_30, var_33);
    var_36 = wp::extract(var_31, var_35);
    var_38 = wp::extract(var_32, var_37);
    var_39 = wp::vec_t<3, wp::float64>(var_34, var_36, var_38);
    var_40 = wp::cross(var_p, var_39);
    // y = cross(p, vec3d(ta[1], tb[1], tc[1]))                                               <L 141>
    var_42 = wp::extract(var_30, var_41);
    var_44 = wp::extract(var_31, var_43);
    var_46 = wp::extract(var_32, var_45);
    var_47 = wp::vec_t<3, wp::float64>(var_42, var_44, var_46);
    var_48 = wp::cross(var_p, var_47);
    // z = cross(p, vec3d(ta[2], tb[2], tc[2]))                                               <L 142>
    var_50 = wp::extract(var_30, var_49);
    var_52 = wp::extract(var_31, var_51);
    var_54 = wp::extract(var_32, var_53);
    var_55 = wp::vec_t<3, wp::float64>(var_50, var_52, var_54);
    var_56 = wp::cross(var_p, var_55);
    // f = a * d[0] + b * d[1] + c * d[2]                                                     <L 143>
    var_58 = wp::extract(var_d, var_57);
    var_59 = wp::mul(var_9, var_58);
    var_61 = wp::extract(var_d, var_60);
    var_62 = wp::mul(var_19, var_61);
    var_63 = wp::add(var_59, var_62);
    var_65 = wp::extract(var_d, var_64);
    var_66 = wp::mul(var_29, var_65);
    var_67 = wp::add(var_63, var_66);
    // m = cross(p, f)                                                                        <L 144>
    var_68 = wp::cross(var_p, var_67);
    // o = float64(0.0)                                                                       <L 145>
    var_69 = 0.0;
    // return row_sums(                                                                       <L 146>
    // x[0], y[0], z[0], ta[0], tb[0], tc[0],                                                 <L 147>
    var_71 = wp::extract(var_40, var_70);
    var_73 = wp::extract(var_48, var_72);
    var_75 = wp::extract(var_56, var_74);
    var_77 = wp::extract(var_30, var_76);
    var_79 = wp::extract(var_31, var_78);
    var_81 = wp::extract(var_32, var_80);
    // y[1], z[1], ta[1], tb[1], tc[1],                                                       <L 148>
    var_83 = wp::extract(var_48, var_82);
    var_85 = wp::extract(var_56, var_84);
    var_87 = wp::extract(var_30, var_86);
    var_89 = wp::extract(var_31, var_88);
    var_91 = wp::extract(var_32, var_90);
    // z[2], ta[2], tb[2], tc[2],                                                             <L 149>
    var_93 = wp::extract(var_56, var_92);
    var_95 = wp::extract(var_30, var_94);
    var_97 = wp::extract(var_31, var_96);
    var_99 = wp::extract(var_32, var_98);
    // a[0], b[0], c[0],                                                                      <L 150>
    var_101 = wp::extract(var_9, var_100);
    var_103 = wp::extract(var_19, var_102);
    var_105 = wp::extract(var_29, var_104);
    // b[1], c[1],                                                                            <L 151>
    var_107 = wp::extract(var_19, var_106);
    var_109 = wp::extract(var_29, var_108);
    // c[2],                                                                                  <L 152>
    var_111 = wp::extract(var_29, var_110);
    // m[0], m[1], m[2], f[0], f[1], f[2],                                                    <L 153>
    var_113 = wp::extract(var_68, var_112);
    var_115 = wp::extract(var_68, var_114);
    var_117 = wp::extract(var_68, var_116);
    var_119 = wp::extract(var_67, var_118);
    var_121 = wp::extract(var_67, var_120);
    var_123 = wp::extract(var_67, var_122);
    // dot(d, f), o, o, o, o, o, o, o, o,                                                     <L 154>
    var_124 = wp::dot(var_d, var_67);
    var_125 = wp::vec_t<36, wp::float64>({var_71, var_73, var_75, var_77, var_79, var_81, var_83, var_85, var_87, var_89, var_91, var_93, var_95, var_97, var_99, var_101, var_103, var_105, var_107, var_109, var_111, var_113, var_115, var_117, var_119, var_121, var_123, var_124, var_69, var_69, var_69, var_69, var_69, var_69, var_69, var_69});
    return var_125;
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


// <pointloom.kernels.algebra.rigid_solve.diagonalize_three>:1
static CUDA_CALLABLE wp::vec_t<12, wp::float64> diagonalize_three_0(
    wp::mat_t<3, 3, wp::float64> var_matrix)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::mat_t<3, 3, wp::float64> var_1;
    wp::float64 var_2;
    wp::float64 var_3;
    wp::float64 var_4;
    wp::float64 var_5;
    wp::float64 var_6;
    wp::float64 var_7;
    wp::float64 var_8;
    wp::float64 var_9;
    wp::float64 var_10;
    wp::mat_t<3, 3, wp::float64> var_11;
    const wp::int32 var_12 = 1;
    wp::int32 var_13;
    const wp::int32 var_14 = 0;
    wp::int32 var_15;
    bool var_16;
    const wp::int32 var_17 = 1;
    bool var_18;
    const wp::int32 var_19 = 10;
    bool var_20;
    const wp::int32 var_21 = 0;
    wp::int32 var_22;
    const wp::int32 var_23 = 1;
    wp::int32 var_24;
    const wp::int32 var_25 = 0;
    const wp::int32 var_26 = 2;
    bool var_27;
    const wp::int32 var_28 = 1;
    const wp::int32 var_29 = 0;
    wp::int32 var_30;
    const wp::int32 var_31 = 0;
    bool var_32;
    const wp::int32 var_33 = 1;
    const wp::int32 var_34 = 2;
    wp::int32 var_35;
    wp::float64 var_36;
    wp::float64 var_37;
    wp::float64 var_38;
    bool var_39;
    wp::float64 var_40;
    wp::float64 var_41;
    bool var_42;
    wp::float64 var_43;
    wp::float64 var_44;
    wp::float64 var_45;
    wp::float64 var_46;
    wp::float64 var_47;
    wp::float64 var_48;
    bool var_49;
    const wp::int32 var_50 = 1;
    wp::vec_t<2, wp::float64> var_51;
    const wp::int32 var_52 = 0;
    wp::float64 var_53;
    wp::float64 var_54;
    const wp::int32 var_55 = 0;
    wp::float64 var_56;
    wp::float64 var_57;
    const wp::int32 var_58 = 1;
    wp::float64 var_59;
    wp::float64 var_60;
    wp::float64 var_61;
    const wp::int32 var_62 = 1;
    wp::float64 var_63;
    wp::float64 var_64;
    const wp::int32 var_65 = 0;
    wp::float64 var_66;
    wp::float64 var_67;
    wp::float64 var_68;
    const wp::int32 var_69 = 1;
    wp::float64 var_70;
    wp::float64 var_71;
    const wp::int32 var_72 = 0;
    wp::float64 var_73;
    wp::float64 var_74;
    const wp::int32 var_75 = 1;
    wp::float64 var_76;
    wp::float64 var_77;
    wp::float64 var_78;
    const wp::int32 var_79 = 1;
    wp::float64 var_80;
    wp::float64 var_81;
    const wp::int32 var_82 = 0;
    wp::float64 var_83;
    wp::float64 var_84;
    wp::float64 var_85;
    const wp::int32 var_86 = 2;
    wp::float64 var_87;
    wp::float64 var_88;
    const wp::int32 var_89 = 0;
    wp::float64 var_90;
    wp::float64 var_91;
    const wp::int32 var_92 = 1;
    wp::float64 var_93;
    wp::float64 var_94;
    wp::float64 var_95;
    const wp::int32 var_96 = 1;
    wp::float64 var_97;
    wp::float64 var_98;
    const wp::int32 var_99 = 0;
    wp::float64 var_100;
    wp::float64 var_101;
    wp::float64 var_102;
    const wp::int32 var_103 = 0;
    wp::float64 var_104;
    wp::float64 var_105;
    const wp::int32 var_106 = 0;
    wp::float64 var_107;
    wp::float64 var_108;
    const wp::int32 var_109 = 1;
    wp::float64 var_110;
    wp::float64 var_111;
    wp::float64 var_112;
    const wp::int32 var_113 = 1;
    wp::float64 var_114;
    wp::float64 var_115;
    const wp::int32 var_116 = 0;
    wp::float64 var_117;
    wp::float64 var_118;
    wp::float64 var_119;
    const wp::int32 var_120 = 1;
    wp::float64 var_121;
    wp::float64 var_122;
    const wp::int32 var_123 = 0;
    wp::float64 var_124;
    wp::float64 var_125;
    const wp::int32 var_126 = 1;
    wp::float64 var_127;
    wp::float64 var_128;
    wp::float64 var_129;
    const wp::int32 var_130 = 1;
    wp::float64 var_131;
    wp::float64 var_132;
    const wp::int32 var_133 = 0;
    wp::float64 var_134;
    wp::float64 var_135;
    wp::float64 var_136;
    const wp::int32 var_137 = 2;
    wp::float64 var_138;
    wp::float64 var_139;
    const wp::int32 var_140 = 0;
    wp::float64 var_141;
    wp::float64 var_142;
    const wp::int32 var_143 = 1;
    wp::float64 var_144;
    wp::float64 var_145;
    wp::float64 var_146;
    const wp::int32 var_147 = 1;
    wp::float64 var_148;
    wp::float64 var_149;
    const wp::int32 var_150 = 0;
    wp::float64 var_151;
    wp::float64 var_152;
    wp::float64 var_153;
    const wp::int32 var_154 = 0;
    wp::float64 var_155;
    wp::float64 var_156;
    const wp::int32 var_157 = 0;
    wp::float64 var_158;
    wp::float64 var_159;
    const wp::int32 var_160 = 1;
    wp::float64 var_161;
    wp::float64 var_162;
    wp::float64 var_163;
    const wp::int32 var_164 = 1;
    wp::float64 var_165;
    wp::float64 var_166;
    const wp::int32 var_167 = 0;
    wp::float64 var_168;
    wp::float64 var_169;
    wp::float64 var_170;
    const wp::int32 var_171 = 1;
    wp::float64 var_172;
    wp::float64 var_173;
    const wp::int32 var_174 = 0;
    wp::float64 var_175;
    wp::float64 var_176;
    const wp::int32 var_177 = 1;
    wp::float64 var_178;
    wp::float64 var_179;
    wp::float64 var_180;
    const wp::int32 var_181 = 1;
    wp::float64 var_182;
    wp::float64 var_183;
    const wp::int32 var_184 = 0;
    wp::float64 var_185;
    wp::float64 var_186;
    wp::float64 var_187;
    const wp::int32 var_188 = 2;
    wp::float64 var_189;
    wp::float64 var_190;
    const wp::int32 var_191 = 0;
    wp::float64 var_192;
    wp::float64 var_193;
    const wp::int32 var_194 = 1;
    wp::float64 var_195;
    wp::float64 var_196;
    wp::float64 var_197;
    const wp::int32 var_198 = 1;
    wp::float64 var_199;
    wp::float64 var_200;
    const wp::int32 var_201 = 0;
    wp::float64 var_202;
    wp::float64 var_203;
    wp::float64 var_204;
    wp::int32 var_205;
    const wp::int32 var_206 = 1;
    const wp::int32 var_207 = 2;
    bool var_208;
    const wp::int32 var_209 = 1;
    const wp::int32 var_210 = 0;
    wp::int32 var_211;
    const wp::int32 var_212 = 0;
    bool var_213;
    const wp::int32 var_214 = 1;
    const wp::int32 var_215 = 2;
    wp::int32 var_216;
    wp::float64 var_217;
    wp::float64 var_218;
    wp::float64 var_219;
    bool var_220;
    wp::float64 var_221;
    wp::float64 var_222;
    bool var_223;
    wp::float64 var_224;
    wp::float64 var_225;
    wp::float64 var_226;
    wp::float64 var_227;
    wp::float64 var_228;
    wp::float64 var_229;
    bool var_230;
    const wp::int32 var_231 = 1;
    wp::vec_t<2, wp::float64> var_232;
    const wp::int32 var_233 = 0;
    wp::float64 var_234;
    wp::float64 var_235;
    const wp::int32 var_236 = 0;
    wp::float64 var_237;
    wp::float64 var_238;
    const wp::int32 var_239 = 1;
    wp::float64 var_240;
    wp::float64 var_241;
    wp::float64 var_242;
    const wp::int32 var_243 = 1;
    wp::float64 var_244;
    wp::float64 var_245;
    const wp::int32 var_246 = 0;
    wp::float64 var_247;
    wp::float64 var_248;
    wp::float64 var_249;
    const wp::int32 var_250 = 1;
    wp::float64 var_251;
    wp::float64 var_252;
    const wp::int32 var_253 = 0;
    wp::float64 var_254;
    wp::float64 var_255;
    const wp::int32 var_256 = 1;
    wp::float64 var_257;
    wp::float64 var_258;
    wp::float64 var_259;
    const wp::int32 var_260 = 1;
    wp::float64 var_261;
    wp::float64 var_262;
    const wp::int32 var_263 = 0;
    wp::float64 var_264;
    wp::float64 var_265;
    wp::float64 var_266;
    const wp::int32 var_267 = 2;
    wp::float64 var_268;
    wp::float64 var_269;
    const wp::int32 var_270 = 0;
    wp::float64 var_271;
    wp::float64 var_272;
    const wp::int32 var_273 = 1;
    wp::float64 var_274;
    wp::float64 var_275;
    wp::float64 var_276;
    const wp::int32 var_277 = 1;
    wp::float64 var_278;
    wp::float64 var_279;
    const wp::int32 var_280 = 0;
    wp::float64 var_281;
    wp::float64 var_282;
    wp::float64 var_283;
    const wp::int32 var_284 = 0;
    wp::float64 var_285;
    wp::float64 var_286;
    const wp::int32 var_287 = 0;
    wp::float64 var_288;
    wp::float64 var_289;
    const wp::int32 var_290 = 1;
    wp::float64 var_291;
    wp::float64 var_292;
    wp::float64 var_293;
    const wp::int32 var_294 = 1;
    wp::float64 var_295;
    wp::float64 var_296;
    const wp::int32 var_297 = 0;
    wp::float64 var_298;
    wp::float64 var_299;
    wp::float64 var_300;
    const wp::int32 var_301 = 1;
    wp::float64 var_302;
    wp::float64 var_303;
    const wp::int32 var_304 = 0;
    wp::float64 var_305;
    wp::float64 var_306;
    const wp::int32 var_307 = 1;
    wp::float64 var_308;
    wp::float64 var_309;
    wp::float64 var_310;
    const wp::int32 var_311 = 1;
    wp::float64 var_312;
    wp::float64 var_313;
    const wp::int32 var_314 = 0;
    wp::float64 var_315;
    wp::float64 var_316;
    wp::float64 var_317;
    const wp::int32 var_318 = 2;
    wp::float64 var_319;
    wp::float64 var_320;
    const wp::int32 var_321 = 0;
    wp::float64 var_322;
    wp::float64 var_323;
    const wp::int32 var_324 = 1;
    wp::float64 var_325;
    wp::float64 var_326;
    wp::float64 var_327;
    const wp::int32 var_328 = 1;
    wp::float64 var_329;
    wp::float64 var_330;
    const wp::int32 var_331 = 0;
    wp::float64 var_332;
    wp::float64 var_333;
    wp::float64 var_334;
    const wp::int32 var_335 = 0;
    wp::float64 var_336;
    wp::float64 var_337;
    const wp::int32 var_338 = 0;
    wp::float64 var_339;
    wp::float64 var_340;
    const wp::int32 var_341 = 1;
    wp::float64 var_342;
    wp::float64 var_343;
    wp::float64 var_344;
    const wp::int32 var_345 = 1;
    wp::float64 var_346;
    wp::float64 var_347;
    const wp::int32 var_348 = 0;
    wp::float64 var_349;
    wp::float64 var_350;
    wp::float64 var_351;
    const wp::int32 var_352 = 1;
    wp::float64 var_353;
    wp::float64 var_354;
    const wp::int32 var_355 = 0;
    wp::float64 var_356;
    wp::float64 var_357;
    const wp::int32 var_358 = 1;
    wp::float64 var_359;
    wp::float64 var_360;
    wp::float64 var_361;
    const wp::int32 var_362 = 1;
    wp::float64 var_363;
    wp::float64 var_364;
    const wp::int32 var_365 = 0;
    wp::float64 var_366;
    wp::float64 var_367;
    wp::float64 var_368;
    const wp::int32 var_369 = 2;
    wp::float64 var_370;
    wp::float64 var_371;
    const wp::int32 var_372 = 0;
    wp::float64 var_373;
    wp::float64 var_374;
    const wp::int32 var_375 = 1;
    wp::float64 var_376;
    wp::float64 var_377;
    wp::float64 var_378;
    const wp::int32 var_379 = 1;
    wp::float64 var_380;
    wp::float64 var_381;
    const wp::int32 var_382 = 0;
    wp::float64 var_383;
    wp::float64 var_384;
    wp::float64 var_385;
    wp::int32 var_386;
    wp::vec_t<2, wp::float64> var_387;
    wp::int32 var_388;
    wp::float64 var_389;
    wp::float64 var_390;
    wp::float64 var_391;
    wp::float64 var_392;
    wp::float64 var_393;
    wp::float64 var_394;
    const wp::int32 var_395 = 2;
    const wp::int32 var_396 = 2;
    bool var_397;
    const wp::int32 var_398 = 1;
    const wp::int32 var_399 = 0;
    wp::int32 var_400;
    const wp::int32 var_401 = 0;
    bool var_402;
    const wp::int32 var_403 = 1;
    const wp::int32 var_404 = 2;
    wp::int32 var_405;
    wp::float64 var_406;
    wp::float64 var_407;
    wp::float64 var_408;
    bool var_409;
    wp::float64 var_410;
    wp::float64 var_411;
    bool var_412;
    wp::float64 var_413;
    wp::float64 var_414;
    wp::float64 var_415;
    wp::float64 var_416;
    wp::float64 var_417;
    wp::float64 var_418;
    bool var_419;
    const wp::int32 var_420 = 1;
    wp::vec_t<2, wp::float64> var_421;
    const wp::int32 var_422 = 0;
    wp::float64 var_423;
    wp::float64 var_424;
    const wp::int32 var_425 = 0;
    wp::float64 var_426;
    wp::float64 var_427;
    const wp::int32 var_428 = 1;
    wp::float64 var_429;
    wp::float64 var_430;
    wp::float64 var_431;
    const wp::int32 var_432 = 1;
    wp::float64 var_433;
    wp::float64 var_434;
    const wp::int32 var_435 = 0;
    wp::float64 var_436;
    wp::float64 var_437;
    wp::float64 var_438;
    const wp::int32 var_439 = 1;
    wp::float64 var_440;
    wp::float64 var_441;
    const wp::int32 var_442 = 0;
    wp::float64 var_443;
    wp::float64 var_444;
    const wp::int32 var_445 = 1;
    wp::float64 var_446;
    wp::float64 var_447;
    wp::float64 var_448;
    const wp::int32 var_449 = 1;
    wp::float64 var_450;
    wp::float64 var_451;
    const wp::int32 var_452 = 0;
    wp::float64 var_453;
    wp::float64 var_454;
    wp::float64 var_455;
    const wp::int32 var_456 = 2;
    wp::float64 var_457;
    wp::float64 var_458;
    const wp::int32 var_459 = 0;
    wp::float64 var_460;
    wp::float64 var_461;
    const wp::int32 var_462 = 1;
    wp::float64 var_463;
    wp::float64 var_464;
    wp::float64 var_465;
    const wp::int32 var_466 = 1;
    wp::float64 var_467;
    wp::float64 var_468;
    const wp::int32 var_469 = 0;
    wp::float64 var_470;
    wp::float64 var_471;
    wp::float64 var_472;
    const wp::int32 var_473 = 0;
    wp::float64 var_474;
    wp::float64 var_475;
    const wp::int32 var_476 = 0;
    wp::float64 var_477;
    wp::float64 var_478;
    const wp::int32 var_479 = 1;
    wp::float64 var_480;
    wp::float64 var_481;
    wp::float64 var_482;
    const wp::int32 var_483 = 1;
    wp::float64 var_484;
    wp::float64 var_485;
    const wp::int32 var_486 = 0;
    wp::float64 var_487;
    wp::float64 var_488;
    wp::float64 var_489;
    const wp::int32 var_490 = 1;
    wp::float64 var_491;
    wp::float64 var_492;
    const wp::int32 var_493 = 0;
    wp::float64 var_494;
    wp::float64 var_495;
    const wp::int32 var_496 = 1;
    wp::float64 var_497;
    wp::float64 var_498;
    wp::float64 var_499;
    const wp::int32 var_500 = 1;
    wp::float64 var_501;
    wp::float64 var_502;
    const wp::int32 var_503 = 0;
    wp::float64 var_504;
    wp::float64 var_505;
    wp::float64 var_506;
    const wp::int32 var_507 = 2;
    wp::float64 var_508;
    wp::float64 var_509;
    const wp::int32 var_510 = 0;
    wp::float64 var_511;
    wp::float64 var_512;
    const wp::int32 var_513 = 1;
    wp::float64 var_514;
    wp::float64 var_515;
    wp::float64 var_516;
    const wp::int32 var_517 = 1;
    wp::float64 var_518;
    wp::float64 var_519;
    const wp::int32 var_520 = 0;
    wp::float64 var_521;
    wp::float64 var_522;
    wp::float64 var_523;
    const wp::int32 var_524 = 0;
    wp::float64 var_525;
    wp::float64 var_526;
    const wp::int32 var_527 = 0;
    wp::float64 var_528;
    wp::float64 var_529;
    const wp::int32 var_530 = 1;
    wp::float64 var_531;
    wp::float64 var_532;
    wp::float64 var_533;
    const wp::int32 var_534 = 1;
    wp::float64 var_535;
    wp::float64 var_536;
    const wp::int32 var_537 = 0;
    wp::float64 var_538;
    wp::float64 var_539;
    wp::float64 var_540;
    const wp::int32 var_541 = 1;
    wp::float64 var_542;
    wp::float64 var_543;
    const wp::int32 var_544 = 0;
    wp::float64 var_545;
    wp::float64 var_546;
    const wp::int32 var_547 = 1;
    wp::float64 var_548;
    wp::float64 var_549;
    wp::float64 var_550;
    const wp::int32 var_551 = 1;
    wp::float64 var_552;
    wp::float64 var_553;
    const wp::int32 var_554 = 0;
    wp::float64 var_555;
    wp::float64 var_556;
    wp::float64 var_557;
    const wp::int32 var_558 = 2;
    wp::float64 var_559;
    wp::float64 var_560;
    const wp::int32 var_561 = 0;
    wp::float64 var_562;
    wp::float64 var_563;
    const wp::int32 var_564 = 1;
    wp::float64 var_565;
    wp::float64 var_566;
    wp::float64 var_567;
    const wp::int32 var_568 = 1;
    wp::float64 var_569;
    wp::float64 var_570;
    const wp::int32 var_571 = 0;
    wp::float64 var_572;
    wp::float64 var_573;
    wp::float64 var_574;
    wp::int32 var_575;
    wp::vec_t<2, wp::float64> var_576;
    wp::int32 var_577;
    wp::float64 var_578;
    wp::float64 var_579;
    wp::float64 var_580;
    wp::float64 var_581;
    wp::float64 var_582;
    wp::float64 var_583;
    const wp::int32 var_584 = 0;
    const wp::int32 var_585 = 0;
    wp::float64 var_586;
    const wp::int32 var_587 = 0;
    const wp::int32 var_588 = 1;
    wp::float64 var_589;
    const wp::int32 var_590 = 0;
    const wp::int32 var_591 = 2;
    wp::float64 var_592;
    const wp::int32 var_593 = 1;
    const wp::int32 var_594 = 0;
    wp::float64 var_595;
    const wp::int32 var_596 = 1;
    const wp::int32 var_597 = 1;
    wp::float64 var_598;
    const wp::int32 var_599 = 1;
    const wp::int32 var_600 = 2;
    wp::float64 var_601;
    const wp::int32 var_602 = 2;
    const wp::int32 var_603 = 0;
    wp::float64 var_604;
    const wp::int32 var_605 = 2;
    const wp::int32 var_606 = 1;
    wp::float64 var_607;
    const wp::int32 var_608 = 2;
    const wp::int32 var_609 = 2;
    wp::float64 var_610;
    const wp::int32 var_611 = 0;
    const wp::int32 var_612 = 0;
    wp::float64 var_613;
    const wp::int32 var_614 = 1;
    const wp::int32 var_615 = 1;
    wp::float64 var_616;
    const wp::int32 var_617 = 2;
    const wp::int32 var_618 = 2;
    wp::float64 var_619;
    wp::vec_t<12, wp::float64> var_620;
    //---------
    // forward
    // def diagonalize_three(matrix):                                                         <L 1>
    // a = matrix * float64(1.0)                                                              <L 3>
    var_0 = 1.0;
    var_1 = wp::mul(var_matrix, var_0);
    // v = mat33d(float64(1.0), float64(0.0), float64(0.0), float64(0.0), float64(1.0), float64(0.0), float64(0.0), float64(0.0), float64(1.0))       <L 4>
    var_2 = 1.0;
    var_3 = 0.0;
    var_4 = 0.0;
    var_5 = 0.0;
    var_6 = 1.0;
    var_7 = 0.0;
    var_8 = 0.0;
    var_9 = 0.0;
    var_10 = 1.0;
    var_11 = wp::mat_t<3, 3, wp::float64>(var_2, var_3, var_4, var_5, var_6, var_7, var_8, var_9, var_10);
    // rotated = int(1)                                                                       <L 5>
    var_13 = wp::int(var_12);
    // sweep = int(0)                                                                         <L 6>
    var_15 = wp::int(var_14);
    // while rotated == 1 and sweep < SWEEPS:                                                 <L 7>
    start_while_0:;
    var_18 = (var_13 == var_17);
    var_16 = var_18;
    if (var_16) {
        var_20 = (var_15 < var_19);
        var_16 = var_16 && var_20;
    }
    if ((var_16) == false) goto end_while_0;
        // rotated = int(0)                                                                   <L 8>
        var_22 = wp::int(var_21);
        // sweep += 1                                                                         <L 9>
        var_24 = wp::add(var_15, var_23);
        // for pair in range(3):                                                              <L 10>
        // p = 1 if pair == 2 else 0                                                          <L 11>
        var_27 = (var_25 == var_26);
        if (var_27) {
        }
        if (!var_27) {
        }
        var_30 = wp::where(var_27, var_28, var_29);
        // q = 1 if pair == 0 else 2                                                          <L 12>
        var_32 = (var_25 == var_31);
        if (var_32) {
        }
        if (!var_32) {
        }
        var_35 = wp::where(var_32, var_33, var_34);
        // apq = a[p, q]                                                                      <L 13>
        var_36 = wp::extract(var_1, var_30, var_35);
        // app = a[p, p]                                                                      <L 14>
        var_37 = wp::extract(var_1, var_30, var_30);
        // aqq = a[q, q]                                                                      <L 15>
        var_38 = wp::extract(var_1, var_35, var_35);
        // if abs(apq) > float64(1e-300) and abs(apq) > float64(1e-18) * sqrt(abs(app * aqq)):       <L 16>
        var_40 = wp::abs(var_36);
        var_41 = 1e-300;
        var_42 = (var_40 > var_41);
        var_39 = var_42;
        if (var_39) {
            var_43 = wp::abs(var_36);
            var_44 = 1e-18;
            var_45 = wp::mul(var_37, var_38);
            var_46 = wp::abs(var_45);
            var_47 = wp::sqrt(var_46);
            var_48 = wp::mul(var_44, var_47);
            var_49 = (var_43 > var_48);
            var_39 = var_39 && var_49;
        }
        if (var_39) {
            // rotated = 1                                                                    <L 17>
            // cs = jacobi_rotation(app, aqq, apq)                                            <L 18>
            var_51 = jacobi_rotation_0(var_37, var_38, var_36);
            // for k in range(3):                                                             <L 19>
            // akp = a[k, p]                                                                  <L 20>
            var_53 = wp::extract(var_1, var_52, var_30);
            // akq = a[k, q]                                                                  <L 21>
            var_54 = wp::extract(var_1, var_52, var_35);
            // a[k, p] = cs[0] * akp - cs[1] * akq                                            <L 22>
            var_56 = wp::extract(var_51, var_55);
            var_57 = wp::mul(var_56, var_53);
            var_59 = wp::extract(var_51, var_58);
            var_60 = wp::mul(var_59, var_54);
            var_61 = wp::sub(var_57, var_60);
            wp::assign_inplace(var_1, var_52, var_30, var_61);
            // a[k, q] = cs[1] * akp + cs[0] * akq                                            <L 23>
            var_63 = wp::extract(var_51, var_62);
            var_64 = wp::mul(var_63, var_53);
            var_66 = wp::extract(var_51, var_65);
            var_67 = wp::mul(var_66, var_54);
            var_68 = wp::add(var_64, var_67);
            wp::assign_inplace(var_1, var_52, var_35, var_68);
            // akp = a[k, p]                                                                  <L 20>
            var_70 = wp::extract(var_1, var_69, var_30);
            // akq = a[k, q]                                                                  <L 21>
            var_71 = wp::extract(var_1, var_69, var_35);
            // a[k, p] = cs[0] * akp - cs[1] * akq                                            <L 22>
            var_73 = wp::extract(var_51, var_72);
            var_74 = wp::mul(var_73, var_70);
            var_76 = wp::extract(var_51, var_75);
            var_77 = wp::mul(var_76, var_71);
            var_78 = wp::sub(var_74, var_77);
            wp::assign_inplace(var_1, var_69, var_30, var_78);
            // a[k, q] = cs[1] * akp + cs[0] * akq                                            <L 23>
            var_80 = wp::extract(var_51, var_79);
            var_81 = wp::mul(var_80, var_70);
            var_83 = wp::extract(var_51, var_82);
            var_84 = wp::mul(var_83, var_71);
            var_85 = wp::add(var_81, var_84);
            wp::assign_inplace(var_1, var_69, var_35, var_85);
            // akp = a[k, p]                                                                  <L 20>
            var_87 = wp::extract(var_1, var_86, var_30);
            // akq = a[k, q]                                                                  <L 21>
            var_88 = wp::extract(var_1, var_86, var_35);
            // a[k, p] = cs[0] * akp - cs[1] * akq                                            <L 22>
            var_90 = wp::extract(var_51, var_89);
            var_91 = wp::mul(var_90, var_87);
            var_93 = wp::extract(var_51, var_92);
            var_94 = wp::mul(var_93, var_88);
            var_95 = wp::sub(var_91, var_94);
            wp::assign_inplace(var_1, var_86, var_30, var_95);
            // a[k, q] = cs[1] * akp + cs[0] * akq                                            <L 23>
            var_97 = wp::extract(var_51, var_96);
            var_98 = wp::mul(var_97, var_87);
            var_100 = wp::extract(var_51, var_99);
            var_101 = wp::mul(var_100, var_88);
            var_102 = wp::add(var_98, var_101);
            wp::assign_inplace(var_1, var_86, var_35, var_102);
            // for k in range(3):                                                             <L 24>
            // apk = a[p, k]                                                                  <L 25>
            var_104 = wp::extract(var_1, var_30, var_103);
            // aqk = a[q, k]                                                                  <L 26>
            var_105 = wp::extract(var_1, var_35, var_103);
            // a[p, k] = cs[0] * apk - cs[1] * aqk                                            <L 27>
            var_107 = wp::extract(var_51, var_106);
            var_108 = wp::mul(var_107, var_104);
            var_110 = wp::extract(var_51, var_109);
            var_111 = wp::mul(var_110, var_105);
            var_112 = wp::sub(var_108, var_111);
            wp::assign_inplace(var_1, var_30, var_103, var_112);
            // a[q, k] = cs[1] * apk + cs[0] * aqk                                            <L 28>
            var_114 = wp::extract(var_51, var_113);
            var_115 = wp::mul(var_114, var_104);
            var_117 = wp::extract(var_51, var_116);
            var_118 = wp::mul(var_117, var_105);
            var_119 = wp::add(var_115, var_118);
            wp::assign_inplace(var_1, var_35, var_103, var_119);
            // apk = a[p, k]                                                                  <L 25>
            var_121 = wp::extract(var_1, var_30, var_120);
            // aqk = a[q, k]                                                                  <L 26>
            var_122 = wp::extract(var_1, var_35, var_120);
            // a[p, k] = cs[0] * apk - cs[1] * aqk                                            <L 27>
            var_124 = wp::extract(var_51, var_123);
            var_125 = wp::mul(var_124, var_121);
            var_127 = wp::extract(var_51, var_126);
            var_128 = wp::mul(var_127, var_122);
            var_129 = wp::sub(var_125, var_128);
            wp::assign_inplace(var_1, var_30, var_120, var_129);
            // a[q, k] = cs[1] * apk + cs[0] * aqk                                            <L 28>
            var_131 = wp::extract(var_51, var_130);
            var_132 = wp::mul(var_131, var_121);
            var_134 = wp::extract(var_51, var_133);
            var_135 = wp::mul(var_134, var_122);
            var_136 = wp::add(var_132, var_135);
            wp::assign_inplace(var_1, var_35, var_120, var_136);
            // apk = a[p, k]                                                                  <L 25>
            var_138 = wp::extract(var_1, var_30, var_137);
            // aqk = a[q, k]                                                                  <L 26>
            var_139 = wp::extract(var_1, var_35, var_137);
            // a[p, k] = cs[0] * apk - cs[1] * aqk                                            <L 27>
            var_141 = wp::extract(var_51, var_140);
            var_142 = wp::mul(var_141, var_138);
            var_144 = wp::extract(var_51, var_143);
            var_145 = wp::mul(var_144, var_139);
            var_146 = wp::sub(var_142, var_145);
            wp::assign_inplace(var_1, var_30, var_137, var_146);
            // a[q, k] = cs[1] * apk + cs[0] * aqk                                            <L 28>
            var_148 = wp::extract(var_51, var_147);
            var_149 = wp::mul(var_148, var_138);
            var_151 = wp::extract(var_51, var_150);
            var_152 = wp::mul(var_151, var_139);
            var_153 = wp::add(var_149, var_152);
            wp::assign_inplace(var_1, var_35, var_137, var_153);
            // for k in range(3):                                                             <L 29>
            // vkp = v[k, p]                                                                  <L 30>
            var_155 = wp::extract(var_11, var_154, var_30);
            // vkq = v[k, q]                                                                  <L 31>
            var_156 = wp::extract(var_11, var_154, var_35);
            // v[k, p] = cs[0] * vkp - cs[1] * vkq                                            <L 32>
            var_158 = wp::extract(var_51, var_157);
            var_159 = wp::mul(var_158, var_155);
            var_161 = wp::extract(var_51, var_160);
            var_162 = wp::mul(var_161, var_156);
            var_163 = wp::sub(var_159, var_162);
            wp::assign_inplace(var_11, var_154, var_30, var_163);
            // v[k, q] = cs[1] * vkp + cs[0] * vkq                                            <L 33>
            var_165 = wp::extract(var_51, var_164);
            var_166 = wp::mul(var_165, var_155);
            var_168 = wp::extract(var_51, var_167);
            var_169 = wp::mul(var_168, var_156);
            var_170 = wp::add(var_166, var_169);
            wp::assign_inplace(var_11, var_154, var_35, var_170);
            // vkp = v[k, p]                                                                  <L 30>
            var_172 = wp::extract(var_11, var_171, var_30);
            // vkq = v[k, q]                                                                  <L 31>
            var_173 = wp::extract(var_11, var_171, var_35);
            // v[k, p] = cs[0] * vkp - cs[1] * vkq                                            <L 32>
            var_175 = wp::extract(var_51, var_174);
            var_176 = wp::mul(var_175, var_172);
            var_178 = wp::extract(var_51, var_177);
            var_179 = wp::mul(var_178, var_173);
            var_180 = wp::sub(var_176, var_179);
            wp::assign_inplace(var_11, var_171, var_30, var_180);
            // v[k, q] = cs[1] * vkp + cs[0] * vkq                                            <L 33>
            var_182 = wp::extract(var_51, var_181);
            var_183 = wp::mul(var_182, var_172);
            var_185 = wp::extract(var_51, var_184);
            var_186 = wp::mul(var_185, var_173);
            var_187 = wp::add(var_183, var_186);
            wp::assign_inplace(var_11, var_171, var_35, var_187);
            // vkp = v[k, p]                                                                  <L 30>
            var_189 = wp::extract(var_11, var_188, var_30);
            // vkq = v[k, q]                                                                  <L 31>
            var_190 = wp::extract(var_11, var_188, var_35);
            // v[k, p] = cs[0] * vkp - cs[1] * vkq                                            <L 32>
            var_192 = wp::extract(var_51, var_191);
            var_193 = wp::mul(var_192, var_189);
            var_195 = wp::extract(var_51, var_194);
            var_196 = wp::mul(var_195, var_190);
            var_197 = wp::sub(var_193, var_196);
            wp::assign_inplace(var_11, var_188, var_30, var_197);
            // v[k, q] = cs[1] * vkp + cs[0] * vkq                                            <L 33>
            var_199 = wp::extract(var_51, var_198);
            var_200 = wp::mul(var_199, var_189);
            var_202 = wp::extract(var_51, var_201);
            var_203 = wp::mul(var_202, var_190);
            var_204 = wp::add(var_200, var_203);
            wp::assign_inplace(var_11, var_188, var_35, var_204);
        }
        var_205 = wp::where(var_39, var_50, var_22);
        // p = 1 if pair == 2 else 0                                                          <L 11>
        var_208 = (var_206 == var_207);
        if (var_208) {
        }
        if (!var_208) {
        }
        var_211 = wp::where(var_208, var_209, var_210);
        // q = 1 if pair == 0 else 2                                                          <L 12>
        var_213 = (var_206 == var_212);
        if (var_213) {
        }
        if (!var_213) {
        }
        var_216 = wp::where(var_213, var_214, var_215);
        // apq = a[p, q]                                                                      <L 13>
        var_217 = wp::extract(var_1, var_211, var_216);
        // app = a[p, p]                                                                      <L 14>
        var_218 = wp::extract(var_1, var_211, var_211);
        // aqq = a[q, q]                                                                      <L 15>
        var_219 = wp::extract(var_1, var_216, var_216);
        // if abs(apq) > float64(1e-300) and abs(apq) > float64(1e-18) * sqrt(abs(app * aqq)):       <L 16>
        var_221 = wp::abs(var_217);
        var_222 = 1e-300;
        var_223 = (var_221 > var_222);
        var_220 = var_223;
        if (var_220) {
            var_224 = wp::abs(var_217);
            var_225 = 1e-18;
            var_226 = wp::mul(var_218, var_219);
            var_227 = wp::abs(var_226);
            var_228 = wp::sqrt(var_227);
            var_229 = wp::mul(var_225, var_228);
            var_230 = (var_224 > var_229);
            var_220 = var_220 && var_230;
        }
        if (var_220) {
            // rotated = 1                                                                    <L 17>
            // cs = jacobi_rotation(app, aqq, apq)                                            <L 18>
            var_232 = jacobi_rotation_0(var_218, var_219, var_217);
            // for k in range(3):                                                             <L 19>
            // akp = a[k, p]                                                                  <L 20>
            var_234 = wp::extract(var_1, var_233, var_211);
            // akq = a[k, q]                                                                  <L 21>
            var_235 = wp::extract(var_1, var_233, var_216);
            // a[k, p] = cs[0] * akp - cs[1] * akq                                            <L 22>
            var_237 = wp::extract(var_232, var_236);
            var_238 = wp::mul(var_237, var_234);
            var_240 = wp::extract(var_232, var_239);
            var_241 = wp::mul(var_240, var_235);
            var_242 = wp::sub(var_238, var_241);
            wp::assign_inplace(var_1, var_233, var_211, var_242);
            // a[k, q] = cs[1] * akp + cs[0] * akq                                            <L 23>
            var_244 = wp::extract(var_232, var_243);
            var_245 = wp::mul(var_244, var_234);
            var_247 = wp::extract(var_232, var_246);
            var_248 = wp::mul(var_247, var_235);
            var_249 = wp::add(var_245, var_248);
            wp::assign_inplace(var_1, var_233, var_216, var_249);
            // akp = a[k, p]                                                                  <L 20>
            var_251 = wp::extract(var_1, var_250, var_211);
            // akq = a[k, q]                                                                  <L 21>
            var_252 = wp::extract(var_1, var_250, var_216);
            // a[k, p] = cs[0] * akp - cs[1] * akq                                            <L 22>
            var_254 = wp::extract(var_232, var_253);
            var_255 = wp::mul(var_254, var_251);
            var_257 = wp::extract(var_232, var_256);
            var_258 = wp::mul(var_257, var_252);
            var_259 = wp::sub(var_255, var_258);
            wp::assign_inplace(var_1, var_250, var_211, var_259);
            // a[k, q] = cs[1] * akp + cs[0] * akq                                            <L 23>
            var_261 = wp::extract(var_232, var_260);
            var_262 = wp::mul(var_261, var_251);
            var_264 = wp::extract(var_232, var_263);
            var_265 = wp::mul(var_264, var_252);
            var_266 = wp::add(var_262, var_265);
            wp::assign_inplace(var_1, var_250, var_216, var_266);
            // akp = a[k, p]                                                                  <L 20>
            var_268 = wp::extract(var_1, var_267, var_211);
            // akq = a[k, q]                                                                  <L 21>
            var_269 = wp::extract(var_1, var_267, var_216);
            // a[k, p] = cs[0] * akp - cs[1] * akq                                            <L 22>
            var_271 = wp::extract(var_232, var_270);
            var_272 = wp::mul(var_271, var_268);
            var_274 = wp::extract(var_232, var_273);
            var_275 = wp::mul(var_274, var_269);
            var_276 = wp::sub(var_272, var_275);
            wp::assign_inplace(var_1, var_267, var_211, var_276);
            // a[k, q] = cs[1] * akp + cs[0] * akq                                            <L 23>
            var_278 = wp::extract(var_232, var_277);
            var_279 = wp::mul(var_278, var_268);
            var_281 = wp::extract(var_232, var_280);
            var_282 = wp::mul(var_281, var_269);
            var_283 = wp::add(var_279, var_282);
            wp::assign_inplace(var_1, var_267, var_216, var_283);
            // for k in range(3):                                                             <L 24>
            // apk = a[p, k]                                                                  <L 25>
            var_285 = wp::extract(var_1, var_211, var_284);
            // aqk = a[q, k]                                                                  <L 26>
            var_286 = wp::extract(var_1, var_216, var_284);
            // a[p, k] = cs[0] * apk - cs[1] * aqk                                            <L 27>
            var_288 = wp::extract(var_232, var_287);
            var_289 = wp::mul(var_288, var_285);
            var_291 = wp::extract(var_232, var_290);
            var_292 = wp::mul(var_291, var_286);
            var_293 = wp::sub(var_289, var_292);
            wp::assign_inplace(var_1, var_211, var_284, var_293);
            // a[q, k] = cs[1] * apk + cs[0] * aqk                                            <L 28>
            var_295 = wp::extract(var_232, var_294);
            var_296 = wp::mul(var_295, var_285);
            var_298 = wp::extract(var_232, var_297);
            var_299 = wp::mul(var_298, var_286);
            var_300 = wp::add(var_296, var_299);
            wp::assign_inplace(var_1, var_216, var_284, var_300);
            // apk = a[p, k]                                                                  <L 25>
            var_302 = wp::extract(var_1, var_211, var_301);
            // aqk = a[q, k]                                                                  <L 26>
            var_303 = wp::extract(var_1, var_216, var_301);
            // a[p, k] = cs[0] * apk - cs[1] * aqk                                            <L 27>
            var_305 = wp::extract(var_232, var_304);
            var_306 = wp::mul(var_305, var_302);
            var_308 = wp::extract(var_232, var_307);
            var_309 = wp::mul(var_308, var_303);
            var_310 = wp::sub(var_306, var_309);
            wp::assign_inplace(var_1, var_211, var_301, var_310);
            // a[q, k] = cs[1] * apk + cs[0] * aqk                                            <L 28>
            var_312 = wp::extract(var_232, var_311);
            var_313 = wp::mul(var_312, var_302);
            var_315 = wp::extract(var_232, var_314);
            var_316 = wp::mul(var_315, var_303);
            var_317 = wp::add(var_313, var_316);
            wp::assign_inplace(var_1, var_216, var_301, var_317);
            // apk = a[p, k]                                                                  <L 25>
            var_319 = wp::extract(var_1, var_211, var_318);
            // aqk = a[q, k]                                                                  <L 26>
            var_320 = wp::extract(var_1, var_216, var_318);
            // a[p, k] = cs[0] * apk - cs[1] * aqk                                            <L 27>
            var_322 = wp::extract(var_232, var_321);
            var_323 = wp::mul(var_322, var_319);
            var_325 = wp::extract(var_232, var_324);
            var_326 = wp::mul(var_325, var_320);
            var_327 = wp::sub(var_323, var_326);
            wp::assign_inplace(var_1, var_211, var_318, var_327);
            // a[q, k] = cs[1] * apk + cs[0] * aqk                                            <L 28>
            var_329 = wp::extract(var_232, var_328);
            var_330 = wp::mul(var_329, var_319);
            var_332 = wp::extract(var_232, var_331);
            var_333 = wp::mul(var_332, var_320);
            var_334 = wp::add(var_330, var_333);
            wp::assign_inplace(var_1, var_216, var_318, var_334);
            // for k in range(3):                                                             <L 29>
            // vkp = v[k, p]                                                                  <L 30>
            var_336 = wp::extract(var_11, var_335, var_211);
            // vkq = v[k, q]                                                                  <L 31>
            var_337 = wp::extract(var_11, var_335, var_216);
            // v[k, p] = cs[0] * vkp - cs[1] * vkq                                            <L 32>
            var_339 = wp::extract(var_232, var_338);
            var_340 = wp::mul(var_339, var_336);
            var_342 = wp::extract(var_232, var_341);
            var_343 = wp::mul(var_342, var_337);
            var_344 = wp::sub(var_340, var_343);
            wp::assign_inplace(var_11, var_335, var_211, var_344);
            // v[k, q] = cs[1] * vkp + cs[0] * vkq                                            <L 33>
            var_346 = wp::extract(var_232, var_345);
            var_347 = wp::mul(var_346, var_336);
            var_349 = wp::extract(var_232, var_348);
            var_350 = wp::mul(var_349, var_337);
            var_351 = wp::add(var_347, var_350);
            wp::assign_inplace(var_11, var_335, var_216, var_351);
            // vkp = v[k, p]                                                                  <L 30>
            var_353 = wp::extract(var_11, var_352, var_211);
            // vkq = v[k, q]                                                                  <L 31>
            var_354 = wp::extract(var_11, var_352, var_216);
            // v[k, p] = cs[0] * vkp - cs[1] * vkq                                            <L 32>
            var_356 = wp::extract(var_232, var_355);
            var_357 = wp::mul(var_356, var_353);
            var_359 = wp::extract(var_232, var_358);
            var_360 = wp::mul(var_359, var_354);
            var_361 = wp::sub(var_357, var_360);
            wp::assign_inplace(var_11, var_352, var_211, var_361);
            // v[k, q] = cs[1] * vkp + cs[0] * vkq                                            <L 33>
            var_363 = wp::extract(var_232, var_362);
            var_364 = wp::mul(var_363, var_353);
            var_366 = wp::extract(var_232, var_365);
            var_367 = wp::mul(var_366, var_354);
            var_368 = wp::add(var_364, var_367);
            wp::assign_inplace(var_11, var_352, var_216, var_368);
            // vkp = v[k, p]                                                                  <L 30>
            var_370 = wp::extract(var_11, var_369, var_211);
            // vkq = v[k, q]                                                                  <L 31>
            var_371 = wp::extract(var_11, var_369, var_216);
            // v[k, p] = cs[0] * vkp - cs[1] * vkq                                            <L 32>
            var_373 = wp::extract(var_232, var_372);
            var_374 = wp::mul(var_373, var_370);
            var_376 = wp::extract(var_232, var_375);
            var_377 = wp::mul(var_376, var_371);
            var_378 = wp::sub(var_374, var_377);
            wp::assign_inplace(var_11, var_369, var_211, var_378);
            // v[k, q] = cs[1] * vkp + cs[0] * vkq                                            <L 33>
            var_380 = wp::extract(var_232, var_379);
            var_381 = wp::mul(var_380, var_370);
            var_383 = wp::extract(var_232, var_382);
            var_384 = wp::mul(var_383, var_371);
            var_385 = wp::add(var_381, var_384);
            wp::assign_inplace(var_11, var_369, var_216, var_385);
        }
        var_386 = wp::where(var_220, var_231, var_205);
        var_387 = wp::where(var_220, var_232, var_51);
        var_388 = wp::where(var_220, var_369, var_188);
        var_389 = wp::where(var_220, var_268, var_87);
        var_390 = wp::where(var_220, var_269, var_88);
        var_391 = wp::where(var_220, var_319, var_138);
        var_392 = wp::where(var_220, var_320, var_139);
        var_393 = wp::where(var_220, var_370, var_189);
        var_394 = wp::where(var_220, var_371, var_190);
        // p = 1 if pair == 2 else 0                                                          <L 11>
        var_397 = (var_395 == var_396);
        if (var_397) {
        }
        if (!var_397) {
        }
        var_400 = wp::where(var_397, var_398, var_399);
        // q = 1 if pair == 0 else 2                                                          <L 12>
        var_402 = (var_395 == var_401);
        if (var_402) {
        }
        if (!var_402) {
        }
        var_405 = wp::where(var_402, var_403, var_404);
        // apq = a[p, q]                                                                      <L 13>
        var_406 = wp::extract(var_1, var_400, var_405);
        // app = a[p, p]                                                                      <L 14>
        var_407 = wp::extract(var_1, var_400, var_400);
        // aqq = a[q, q]                                                                      <L 15>
        var_408 = wp::extract(var_1, var_405, var_405);
        // if abs(apq) > float64(1e-300) and abs(apq) > float64(1e-18) * sqrt(abs(app * aqq)):       <L 16>
        var_410 = wp::abs(var_406);
        var_411 = 1e-300;
        var_412 = (var_410 > var_411);
        var_409 = var_412;
        if (var_409) {
            var_413 = wp::abs(var_406);
            var_414 = 1e-18;
            var_415 = wp::mul(var_407, var_408);
            var_416 = wp::abs(var_415);
            var_417 = wp::sqrt(var_416);
            var_418 = wp::mul(var_414, var_417);
            var_419 = (var_413 > var_418);
            var_409 = var_409 && var_419;
        }
        if (var_409) {
            // rotated = 1                                                                    <L 17>
            // cs = jacobi_rotation(app, aqq, apq)                                            <L 18>
            var_421 = jacobi_rotation_0(var_407, var_408, var_406);
            // for k in range(3):                                                             <L 19>
            // akp = a[k, p]                                                                  <L 20>
            var_423 = wp::extract(var_1, var_422, var_400);
            // akq = a[k, q]                                                                  <L 21>
            var_424 = wp::extract(var_1, var_422, var_405);
            // a[k, p] = cs[0] * akp - cs[1] * akq                                            <L 22>
            var_426 = wp::extract(var_421, var_425);
            var_427 = wp::mul(var_426, var_423);
            var_429 = wp::extract(var_421, var_428);
            var_430 = wp::mul(var_429, var_424);
            var_431 = wp::sub(var_427, var_430);
            wp::assign_inplace(var_1, var_422, var_400, var_431);
            // a[k, q] = cs[1] * akp + cs[0] * akq                                            <L 23>
            var_433 = wp::extract(var_421, var_432);
            var_434 = wp::mul(var_433, var_423);
            var_436 = wp::extract(var_421, var_435);
            var_437 = wp::mul(var_436, var_424);
            var_438 = wp::add(var_434, var_437);
            wp::assign_inplace(var_1, var_422, var_405, var_438);
            // akp = a[k, p]                                                                  <L 20>
            var_440 = wp::extract(var_1, var_439, var_400);
            // akq = a[k, q]                                                                  <L 21>
            var_441 = wp::extract(var_1, var_439, var_405);
            // a[k, p] = cs[0] * akp - cs[1] * akq                                            <L 22>
            var_443 = wp::extract(var_421, var_442);
            var_444 = wp::mul(var_443, var_440);
            var_446 = wp::extract(var_421, var_445);
            var_447 = wp::mul(var_446, var_441);
            var_448 = wp::sub(var_444, var_447);
            wp::assign_inplace(var_1, var_439, var_400, var_448);
            // a[k, q] = cs[1] * akp + cs[0] * akq                                            <L 23>
            var_450 = wp::extract(var_421, var_449);
            var_451 = wp::mul(var_450, var_440);
            var_453 = wp::extract(var_421, var_452);
            var_454 = wp::mul(var_453, var_441);
            var_455 = wp::add(var_451, var_454);
            wp::assign_inplace(var_1, var_439, var_405, var_455);
            // akp = a[k, p]                                                                  <L 20>
            var_457 = wp::extract(var_1, var_456, var_400);
            // akq = a[k, q]                                                                  <L 21>
            var_458 = wp::extract(var_1, var_456, var_405);
            // a[k, p] = cs[0] * akp - cs[1] * akq                                            <L 22>
            var_460 = wp::extract(var_421, var_459);
            var_461 = wp::mul(var_460, var_457);
            var_463 = wp::extract(var_421, var_462);
            var_464 = wp::mul(var_463, var_458);
            var_465 = wp::sub(var_461, var_464);
            wp::assign_inplace(var_1, var_456, var_400, var_465);
            // a[k, q] = cs[1] * akp + cs[0] * akq                                            <L 23>
            var_467 = wp::extract(var_421, var_466);
            var_468 = wp::mul(var_467, var_457);
            var_470 = wp::extract(var_421, var_469);
            var_471 = wp::mul(var_470, var_458);
            var_472 = wp::add(var_468, var_471);
            wp::assign_inplace(var_1, var_456, var_405, var_472);
            // for k in range(3):                                                             <L 24>
            // apk = a[p, k]                                                                  <L 25>
            var_474 = wp::extract(var_1, var_400, var_473);
            // aqk = a[q, k]                                                                  <L 26>
            var_475 = wp::extract(var_1, var_405, var_473);
            // a[p, k] = cs[0] * apk - cs[1] * aqk                                            <L 27>
            var_477 = wp::extract(var_421, var_476);
            var_478 = wp::mul(var_477, var_474);
            var_480 = wp::extract(var_421, var_479);
            var_481 = wp::mul(var_480, var_475);
            var_482 = wp::sub(var_478, var_481);
            wp::assign_inplace(var_1, var_400, var_473, var_482);
            // a[q, k] = cs[1] * apk + cs[0] * aqk                                            <L 28>
            var_484 = wp::extract(var_421, var_483);
            var_485 = wp::mul(var_484, var_474);
            var_487 = wp::extract(var_421, var_486);
            var_488 = wp::mul(var_487, var_475);
            var_489 = wp::add(var_485, var_488);
            wp::assign_inplace(var_1, var_405, var_473, var_489);
            // apk = a[p, k]                                                                  <L 25>
            var_491 = wp::extract(var_1, var_400, var_490);
            // aqk = a[q, k]                                                                  <L 26>
            var_492 = wp::extract(var_1, var_405, var_490);
            // a[p, k] = cs[0] * apk - cs[1] * aqk                                            <L 27>
            var_494 = wp::extract(var_421, var_493);
            var_495 = wp::mul(var_494, var_491);
            var_497 = wp::extract(var_421, var_496);
            var_498 = wp::mul(var_497, var_492);
            var_499 = wp::sub(var_495, var_498);
            wp::assign_inplace(var_1, var_400, var_490, var_499);
            // a[q, k] = cs[1] * apk + cs[0] * aqk                                            <L 28>
            var_501 = wp::extract(var_421, var_500);
            var_502 = wp::mul(var_501, var_491);
            var_504 = wp::extract(var_421, var_503);
            var_505 = wp::mul(var_504, var_492);
            var_506 = wp::add(var_502, var_505);
            wp::assign_inplace(var_1, var_405, var_490, var_506);
            // apk = a[p, k]                                                                  <L 25>
            var_508 = wp::extract(var_1, var_400, var_507);
            // aqk = a[q, k]                                                                  <L 26>
            var_509 = wp::extract(var_1, var_405, var_507);
            // a[p, k] = cs[0] * apk - cs[1] * aqk                                            <L 27>
            var_511 = wp::extract(var_421, var_510);
            var_512 = wp::mul(var_511, var_508);
            var_514 = wp::extract(var_421, var_513);
            var_515 = wp::mul(var_514, var_509);
            var_516 = wp::sub(var_512, var_515);
            wp::assign_inplace(var_1, var_400, var_507, var_516);
            // a[q, k] = cs[1] * apk + cs[0] * aqk                                            <L 28>
            var_518 = wp::extract(var_421, var_517);
            var_519 = wp::mul(var_518, var_508);
            var_521 = wp::extract(var_421, var_520);
            var_522 = wp::mul(var_521, var_509);
            var_523 = wp::add(var_519, var_522);
            wp::assign_inplace(var_1, var_405, var_507, var_523);
            // for k in range(3):                                                             <L 29>
            // vkp = v[k, p]                                                                  <L 30>
            var_525 = wp::extract(var_11, var_524, var_400);
            // vkq = v[k, q]                                                                  <L 31>
            var_526 = wp::extract(var_11, var_524, var_405);
            // v[k, p] = cs[0] * vkp - cs[1] * vkq                                            <L 32>
            var_528 = wp::extract(var_421, var_527);
            var_529 = wp::mul(var_528, var_525);
            var_531 = wp::extract(var_421, var_530);
            var_532 = wp::mul(var_531, var_526);
            var_533 = wp::sub(var_529, var_532);
            wp::assign_inplace(var_11, var_524, var_400, var_533);
            // v[k, q] = cs[1] * vkp + cs[0] * vkq                                            <L 33>
            var_535 = wp::extract(var_421, var_534);
            var_536 = wp::mul(var_535, var_525);
            var_538 = wp::extract(var_421, var_537);
            var_539 = wp::mul(var_538, var_526);
            var_540 = wp::add(var_536, var_539);
            wp::assign_inplace(var_11, var_524, var_405, var_540);
            // vkp = v[k, p]                                                                  <L 30>
            var_542 = wp::extract(var_11, var_541, var_400);
            // vkq = v[k, q]                                                                  <L 31>
            var_543 = wp::extract(var_11, var_541, var_405);
            // v[k, p] = cs[0] * vkp - cs[1] * vkq                                            <L 32>
            var_545 = wp::extract(var_421, var_544);
            var_546 = wp::mul(var_545, var_542);
            var_548 = wp::extract(var_421, var_547);
            var_549 = wp::mul(var_548, var_543);
            var_550 = wp::sub(var_546, var_549);
            wp::assign_inplace(var_11, var_541, var_400, var_550);
            // v[k, q] = cs[1] * vkp + cs[0] * vkq                                            <L 33>
            var_552 = wp::extract(var_421, var_551);
            var_553 = wp::mul(var_552, var_542);
            var_555 = wp::extract(var_421, var_554);
            var_556 = wp::mul(var_555, var_543);
            var_557 = wp::add(var_553, var_556);
            wp::assign_inplace(var_11, var_541, var_405, var_557);
            // vkp = v[k, p]                                                                  <L 30>
            var_559 = wp::extract(var_11, var_558, var_400);
            // vkq = v[k, q]                                                                  <L 31>
            var_560 = wp::extract(var_11, var_558, var_405);
            // v[k, p] = cs[0] * vkp - cs[1] * vkq                                            <L 32>
            var_562 = wp::extract(var_421, var_561);
            var_563 = wp::mul(var_562, var_559);
            var_565 = wp::extract(var_421, var_564);
            var_566 = wp::mul(var_565, var_560);
            var_567 = wp::sub(var_563, var_566);
            wp::assign_inplace(var_11, var_558, var_400, var_567);
            // v[k, q] = cs[1] * vkp + cs[0] * vkq                                            <L 33>
            var_569 = wp::extract(var_421, var_568);
            var_570 = wp::mul(var_569, var_559);
            var_572 = wp::extract(var_421, var_571);
            var_573 = wp::mul(var_572, var_560);
            var_574 = wp::add(var_570, var_573);
            wp::assign_inplace(var_11, var_558, var_405, var_574);
        }
        var_575 = wp::where(var_409, var_420, var_386);
        var_576 = wp::where(var_409, var_421, var_387);
        var_577 = wp::where(var_409, var_558, var_388);
        var_578 = wp::where(var_409, var_457, var_389);
        var_579 = wp::where(var_409, var_458, var_390);
        var_580 = wp::where(var_409, var_508, var_391);
        var_581 = wp::where(var_409, var_509, var_392);
        var_582 = wp::where(var_409, var_559, var_393);
        var_583 = wp::where(var_409, var_560, var_394);
        wp::assign(var_13, var_575);
        wp::assign(var_15, var_24);
    goto start_while_0;
    end_while_0:;
    // return three_system(v[0, 0], v[0, 1], v[0, 2], v[1, 0], v[1, 1], v[1, 2], v[2, 0], v[2, 1], v[2, 2], a[0, 0], a[1, 1], a[2, 2])       <L 34>
    var_586 = wp::extract(var_11, var_584, var_585);
    var_589 = wp::extract(var_11, var_587, var_588);
    var_592 = wp::extract(var_11, var_590, var_591);
    var_595 = wp::extract(var_11, var_593, var_594);
    var_598 = wp::extract(var_11, var_596, var_597);
    var_601 = wp::extract(var_11, var_599, var_600);
    var_604 = wp::extract(var_11, var_602, var_603);
    var_607 = wp::extract(var_11, var_605, var_606);
    var_610 = wp::extract(var_11, var_608, var_609);
    var_613 = wp::extract(var_1, var_611, var_612);
    var_616 = wp::extract(var_1, var_614, var_615);
    var_619 = wp::extract(var_1, var_617, var_618);
    var_620 = wp::vec_t<12, wp::float64>({var_586, var_589, var_592, var_595, var_598, var_601, var_604, var_607, var_610, var_613, var_616, var_619});
    return var_620;
}


// <pointloom.kernels.icp.rows.inverse_root>:1
static CUDA_CALLABLE wp::mat_t<3, 3, wp::float64> inverse_root_0(
    wp::mat_t<3, 3, wp::float64> var_M)
{
    //---------
    // primal vars
    wp::vec_t<12, wp::float64> var_0;
    wp::float64 var_1;
    wp::mat_t<3, 3, wp::float64> var_2;
    const wp::int32 var_3 = 0;
    const wp::int32 var_4 = 9;
    wp::int32 var_5;
    wp::float64 var_6;
    wp::float64 var_7;
    bool var_8;
    wp::float64 var_9;
    wp::float64 var_10;
    wp::float64 var_11;
    const wp::int32 var_12 = 0;
    const wp::int32 var_13 = 0;
    wp::float64 var_14;
    const wp::int32 var_15 = 3;
    wp::int32 var_16;
    wp::int32 var_17;
    wp::float64 var_18;
    wp::float64 var_19;
    const wp::int32 var_20 = 3;
    wp::int32 var_21;
    wp::int32 var_22;
    wp::float64 var_23;
    wp::float64 var_24;
    wp::float64 var_25;
    const wp::int32 var_26 = 1;
    wp::float64 var_27;
    const wp::int32 var_28 = 3;
    wp::int32 var_29;
    wp::int32 var_30;
    wp::float64 var_31;
    wp::float64 var_32;
    const wp::int32 var_33 = 3;
    wp::int32 var_34;
    wp::int32 var_35;
    wp::float64 var_36;
    wp::float64 var_37;
    wp::float64 var_38;
    const wp::int32 var_39 = 2;
    wp::float64 var_40;
    const wp::int32 var_41 = 3;
    wp::int32 var_42;
    wp::int32 var_43;
    wp::float64 var_44;
    wp::float64 var_45;
    const wp::int32 var_46 = 3;
    wp::int32 var_47;
    wp::int32 var_48;
    wp::float64 var_49;
    wp::float64 var_50;
    wp::float64 var_51;
    const wp::int32 var_52 = 1;
    const wp::int32 var_53 = 0;
    wp::float64 var_54;
    const wp::int32 var_55 = 3;
    wp::int32 var_56;
    wp::int32 var_57;
    wp::float64 var_58;
    wp::float64 var_59;
    const wp::int32 var_60 = 3;
    wp::int32 var_61;
    wp::int32 var_62;
    wp::float64 var_63;
    wp::float64 var_64;
    wp::float64 var_65;
    const wp::int32 var_66 = 1;
    wp::float64 var_67;
    const wp::int32 var_68 = 3;
    wp::int32 var_69;
    wp::int32 var_70;
    wp::float64 var_71;
    wp::float64 var_72;
    const wp::int32 var_73 = 3;
    wp::int32 var_74;
    wp::int32 var_75;
    wp::float64 var_76;
    wp::float64 var_77;
    wp::float64 var_78;
    const wp::int32 var_79 = 2;
    wp::float64 var_80;
    const wp::int32 var_81 = 3;
    wp::int32 var_82;
    wp::int32 var_83;
    wp::float64 var_84;
    wp::float64 var_85;
    const wp::int32 var_86 = 3;
    wp::int32 var_87;
    wp::int32 var_88;
    wp::float64 var_89;
    wp::float64 var_90;
    wp::float64 var_91;
    const wp::int32 var_92 = 2;
    const wp::int32 var_93 = 0;
    wp::float64 var_94;
    const wp::int32 var_95 = 3;
    wp::int32 var_96;
    wp::int32 var_97;
    wp::float64 var_98;
    wp::float64 var_99;
    const wp::int32 var_100 = 3;
    wp::int32 var_101;
    wp::int32 var_102;
    wp::float64 var_103;
    wp::float64 var_104;
    wp::float64 var_105;
    const wp::int32 var_106 = 1;
    wp::float64 var_107;
    const wp::int32 var_108 = 3;
    wp::int32 var_109;
    wp::int32 var_110;
    wp::float64 var_111;
    wp::float64 var_112;
    const wp::int32 var_113 = 3;
    wp::int32 var_114;
    wp::int32 var_115;
    wp::float64 var_116;
    wp::float64 var_117;
    wp::float64 var_118;
    const wp::int32 var_119 = 2;
    wp::float64 var_120;
    const wp::int32 var_121 = 3;
    wp::int32 var_122;
    wp::int32 var_123;
    wp::float64 var_124;
    wp::float64 var_125;
    const wp::int32 var_126 = 3;
    wp::int32 var_127;
    wp::int32 var_128;
    wp::float64 var_129;
    wp::float64 var_130;
    wp::float64 var_131;
    const wp::int32 var_132 = 1;
    const wp::int32 var_133 = 9;
    wp::int32 var_134;
    wp::float64 var_135;
    wp::float64 var_136;
    bool var_137;
    wp::float64 var_138;
    wp::float64 var_139;
    wp::float64 var_140;
    const wp::int32 var_141 = 0;
    const wp::int32 var_142 = 0;
    wp::float64 var_143;
    const wp::int32 var_144 = 3;
    wp::int32 var_145;
    wp::int32 var_146;
    wp::float64 var_147;
    wp::float64 var_148;
    const wp::int32 var_149 = 3;
    wp::int32 var_150;
    wp::int32 var_151;
    wp::float64 var_152;
    wp::float64 var_153;
    wp::float64 var_154;
    const wp::int32 var_155 = 1;
    wp::float64 var_156;
    const wp::int32 var_157 = 3;
    wp::int32 var_158;
    wp::int32 var_159;
    wp::float64 var_160;
    wp::float64 var_161;
    const wp::int32 var_162 = 3;
    wp::int32 var_163;
    wp::int32 var_164;
    wp::float64 var_165;
    wp::float64 var_166;
    wp::float64 var_167;
    const wp::int32 var_168 = 2;
    wp::float64 var_169;
    const wp::int32 var_170 = 3;
    wp::int32 var_171;
    wp::int32 var_172;
    wp::float64 var_173;
    wp::float64 var_174;
    const wp::int32 var_175 = 3;
    wp::int32 var_176;
    wp::int32 var_177;
    wp::float64 var_178;
    wp::float64 var_179;
    wp::float64 var_180;
    const wp::int32 var_181 = 1;
    const wp::int32 var_182 = 0;
    wp::float64 var_183;
    const wp::int32 var_184 = 3;
    wp::int32 var_185;
    wp::int32 var_186;
    wp::float64 var_187;
    wp::float64 var_188;
    const wp::int32 var_189 = 3;
    wp::int32 var_190;
    wp::int32 var_191;
    wp::float64 var_192;
    wp::float64 var_193;
    wp::float64 var_194;
    const wp::int32 var_195 = 1;
    wp::float64 var_196;
    const wp::int32 var_197 = 3;
    wp::int32 var_198;
    wp::int32 var_199;
    wp::float64 var_200;
    wp::float64 var_201;
    const wp::int32 var_202 = 3;
    wp::int32 var_203;
    wp::int32 var_204;
    wp::float64 var_205;
    wp::float64 var_206;
    wp::float64 var_207;
    const wp::int32 var_208 = 2;
    wp::float64 var_209;
    const wp::int32 var_210 = 3;
    wp::int32 var_211;
    wp::int32 var_212;
    wp::float64 var_213;
    wp::float64 var_214;
    const wp::int32 var_215 = 3;
    wp::int32 var_216;
    wp::int32 var_217;
    wp::float64 var_218;
    wp::float64 var_219;
    wp::float64 var_220;
    const wp::int32 var_221 = 2;
    const wp::int32 var_222 = 0;
    wp::float64 var_223;
    const wp::int32 var_224 = 3;
    wp::int32 var_225;
    wp::int32 var_226;
    wp::float64 var_227;
    wp::float64 var_228;
    const wp::int32 var_229 = 3;
    wp::int32 var_230;
    wp::int32 var_231;
    wp::float64 var_232;
    wp::float64 var_233;
    wp::float64 var_234;
    const wp::int32 var_235 = 1;
    wp::float64 var_236;
    const wp::int32 var_237 = 3;
    wp::int32 var_238;
    wp::int32 var_239;
    wp::float64 var_240;
    wp::float64 var_241;
    const wp::int32 var_242 = 3;
    wp::int32 var_243;
    wp::int32 var_244;
    wp::float64 var_245;
    wp::float64 var_246;
    wp::float64 var_247;
    const wp::int32 var_248 = 2;
    wp::float64 var_249;
    const wp::int32 var_250 = 3;
    wp::int32 var_251;
    wp::int32 var_252;
    wp::float64 var_253;
    wp::float64 var_254;
    const wp::int32 var_255 = 3;
    wp::int32 var_256;
    wp::int32 var_257;
    wp::float64 var_258;
    wp::float64 var_259;
    wp::float64 var_260;
    wp::float64 var_261;
    wp::int32 var_262;
    wp::int32 var_263;
    const wp::int32 var_264 = 2;
    const wp::int32 var_265 = 9;
    wp::int32 var_266;
    wp::float64 var_267;
    wp::float64 var_268;
    bool var_269;
    wp::float64 var_270;
    wp::float64 var_271;
    wp::float64 var_272;
    const wp::int32 var_273 = 0;
    const wp::int32 var_274 = 0;
    wp::float64 var_275;
    const wp::int32 var_276 = 3;
    wp::int32 var_277;
    wp::int32 var_278;
    wp::float64 var_279;
    wp::float64 var_280;
    const wp::int32 var_281 = 3;
    wp::int32 var_282;
    wp::int32 var_283;
    wp::float64 var_284;
    wp::float64 var_285;
    wp::float64 var_286;
    const wp::int32 var_287 = 1;
    wp::float64 var_288;
    const wp::int32 var_289 = 3;
    wp::int32 var_290;
    wp::int32 var_291;
    wp::float64 var_292;
    wp::float64 var_293;
    const wp::int32 var_294 = 3;
    wp::int32 var_295;
    wp::int32 var_296;
    wp::float64 var_297;
    wp::float64 var_298;
    wp::float64 var_299;
    const wp::int32 var_300 = 2;
    wp::float64 var_301;
    const wp::int32 var_302 = 3;
    wp::int32 var_303;
    wp::int32 var_304;
    wp::float64 var_305;
    wp::float64 var_306;
    const wp::int32 var_307 = 3;
    wp::int32 var_308;
    wp::int32 var_309;
    wp::float64 var_310;
    wp::float64 var_311;
    wp::float64 var_312;
    const wp::int32 var_313 = 1;
    const wp::int32 var_314 = 0;
    wp::float64 var_315;
    const wp::int32 var_316 = 3;
    wp::int32 var_317;
    wp::int32 var_318;
    wp::float64 var_319;
    wp::float64 var_320;
    const wp::int32 var_321 = 3;
    wp::int32 var_322;
    wp::int32 var_323;
    wp::float64 var_324;
    wp::float64 var_325;
    wp::float64 var_326;
    const wp::int32 var_327 = 1;
    wp::float64 var_328;
    const wp::int32 var_329 = 3;
    wp::int32 var_330;
    wp::int32 var_331;
    wp::float64 var_332;
    wp::float64 var_333;
    const wp::int32 var_334 = 3;
    wp::int32 var_335;
    wp::int32 var_336;
    wp::float64 var_337;
    wp::float64 var_338;
    wp::float64 var_339;
    const wp::int32 var_340 = 2;
    wp::float64 var_341;
    const wp::int32 var_342 = 3;
    wp::int32 var_343;
    wp::int32 var_344;
    wp::float64 var_345;
    wp::float64 var_346;
    const wp::int32 var_347 = 3;
    wp::int32 var_348;
    wp::int32 var_349;
    wp::float64 var_350;
    wp::float64 var_351;
    wp::float64 var_352;
    const wp::int32 var_353 = 2;
    const wp::int32 var_354 = 0;
    wp::float64 var_355;
    const wp::int32 var_356 = 3;
    wp::int32 var_357;
    wp::int32 var_358;
    wp::float64 var_359;
    wp::float64 var_360;
    const wp::int32 var_361 = 3;
    wp::int32 var_362;
    wp::int32 var_363;
    wp::float64 var_364;
    wp::float64 var_365;
    wp::float64 var_366;
    const wp::int32 var_367 = 1;
    wp::float64 var_368;
    const wp::int32 var_369 = 3;
    wp::int32 var_370;
    wp::int32 var_371;
    wp::float64 var_372;
    wp::float64 var_373;
    const wp::int32 var_374 = 3;
    wp::int32 var_375;
    wp::int32 var_376;
    wp::float64 var_377;
    wp::float64 var_378;
    wp::float64 var_379;
    const wp::int32 var_380 = 2;
    wp::float64 var_381;
    const wp::int32 var_382 = 3;
    wp::int32 var_383;
    wp::int32 var_384;
    wp::float64 var_385;
    wp::float64 var_386;
    const wp::int32 var_387 = 3;
    wp::int32 var_388;
    wp::int32 var_389;
    wp::float64 var_390;
    wp::float64 var_391;
    wp::float64 var_392;
    wp::float64 var_393;
    wp::int32 var_394;
    wp::int32 var_395;
    //---------
    // forward
    // def inverse_root(M):                                                                   <L 1>
    // system = diagonalize_three(M)                                                          <L 3>
    var_0 = diagonalize_three_0(var_M);
    // W = mat33d(float64(0.0))                                                               <L 4>
    var_1 = 0.0;
    var_2 = wp::mat_t<3, 3, wp::float64>(var_1);
    // for k in range(3):                                                                     <L 5>
    // value = system[9 + k]                                                                  <L 6>
    var_5 = wp::add(var_4, var_3);
    var_6 = wp::extract(var_0, var_5);
    // if value > float64(1e-30):                                                             <L 7>
    var_7 = 1e-30;
    var_8 = (var_6 > var_7);
    if (var_8) {
        // root = float64(1.0) / sqrt(value)                                                  <L 8>
        var_9 = 1.0;
        var_10 = wp::sqrt(var_6);
        var_11 = wp::div(var_9, var_10);
        // for row in range(3):                                                               <L 9>
        // for column in range(3):                                                            <L 10>
        // W[row, column] = W[row, column] + root * system[row * 3 + k] * system[column * 3 + k]       <L 11>
        var_14 = wp::extract(var_2, var_12, var_13);
        var_16 = wp::mul(var_12, var_15);
        var_17 = wp::add(var_16, var_3);
        var_18 = wp::extract(var_0, var_17);
        var_19 = wp::mul(var_11, var_18);
        var_21 = wp::mul(var_13, var_20);
        var_22 = wp::add(var_21, var_3);
        var_23 = wp::extract(var_0, var_22);
        var_24 = wp::mul(var_19, var_23);
        var_25 = wp::add(var_14, var_24);
        wp::assign_inplace(var_2, var_12, var_13, var_25);
        var_27 = wp::extract(var_2, var_12, var_26);
        var_29 = wp::mul(var_12, var_28);
        var_30 = wp::add(var_29, var_3);
        var_31 = wp::extract(var_0, var_30);
        var_32 = wp::mul(var_11, var_31);
        var_34 = wp::mul(var_26, var_33);
        var_35 = wp::add(var_34, var_3);
        var_36 = wp::extract(var_0, var_35);
        var_37 = wp::mul(var_32, var_36);
        var_38 = wp::add(var_27, var_37);
        wp::assign_inplace(var_2, var_12, var_26, var_38);
        var_40 = wp::extract(var_2, var_12, var_39);
        var_42 = wp::mul(var_12, var_41);
        var_43 = wp::add(var_42, var_3);
        var_44 = wp::extract(var_0, var_43);
        var_45 = wp::mul(var_11, var_44);
        var_47 = wp::mul(var_39, var_46);
        var_48 = wp::add(var_47, var_3);
        var_49 = wp::extract(var_0, var_48);
        var_50 = wp::mul(var_45, var_49);
        var_51 = wp::add(var_40, var_50);
        wp::assign_inplace(var_2, var_12, var_39, var_51);
        // for column in range(3):                                                            <L 10>
        // W[row, column] = W[row, column] + root * system[row * 3 + k] * system[column * 3 + k]       <L 11>
        var_54 = wp::extract(var_2, var_52, var_53);
        var_56 = wp::mul(var_52, var_55);
        var_57 = wp::add(var_56, var_3);
        var_58 = wp::extract(var_0, var_57);
        var_59 = wp::mul(var_11, var_58);
        var_61 = wp::mul(var_53, var_60);
        var_62 = wp::add(var_61, var_3);
        var_63 = wp::extract(var_0, var_62);
        var_64 = wp::mul(var_59, var_63);
        var_65 = wp::add(var_54, var_64);
        wp::assign_inplace(var_2, var_52, var_53, var_65);
        var_67 = wp::extract(var_2, var_52, var_66);
        var_69 = wp::mul(var_52, var_68);
        var_70 = wp::add(var_69, var_3);
        var_71 = wp::extract(var_0, var_70);
        var_72 = wp::mul(var_11, var_71);
        var_74 = wp::mul(var_66, var_73);
        var_75 = wp::add(var_74, var_3);
        var_76 = wp::extract(var_0, var_75);
        var_77 = wp::mul(var_72, var_76);
        var_78 = wp::add(var_67, var_77);
        wp::assign_inplace(var_2, var_52, var_66, var_78);
        var_80 = wp::extract(var_2, var_52, var_79);
        var_82 = wp::mul(var_52, var_81);
        var_83 = wp::add(var_82, var_3);
        var_84 = wp::extract(var_0, var_83);
        var_85 = wp::mul(var_11, var_84);
        var_87 = wp::mul(var_79, var_86);
        var_88 = wp::add(var_87, var_3);
        var_89 = wp::extract(var_0, var_88);
        var_90 = wp::mul(var_85, var_89);
        var_91 = wp::add(var_80, var_90);
        wp::assign_inplace(var_2, var_52, var_79, var_91);
        // for column in range(3):                                                            <L 10>
        // W[row, column] = W[row, column] + root * system[row * 3 + k] * system[column * 3 + k]       <L 11>
        var_94 = wp::extract(var_2, var_92, var_93);
        var_96 = wp::mul(var_92, var_95);
        var_97 = wp::add(var_96, var_3);
        var_98 = wp::extract(var_0, var_97);
        var_99 = wp::mul(var_11, var_98);
        var_101 = wp::mul(var_93, var_100);
        var_102 = wp::add(var_101, var_3);
        var_103 = wp::extract(var_0, var_102);
        var_104 = wp::mul(var_99, var_103);
        var_105 = wp::add(var_94, var_104);
        wp::assign_inplace(var_2, var_92, var_93, var_105);
        var_107 = wp::extract(var_2, var_92, var_106);
        var_109 = wp::mul(var_92, var_108);
        var_110 = wp::add(var_109, var_3);
        var_111 = wp::extract(var_0, var_110);
        var_112 = wp::mul(var_11, var_111);
        var_114 = wp::mul(var_106, var_113);
        var_115 = wp::add(var_114, var_3);
        var_116 = wp::extract(var_0, var_115);
        var_117 = wp::mul(var_112, var_116);
        var_118 = wp::add(var_107, var_117);
        wp::assign_inplace(var_2, var_92, var_106, var_118);
        var_120 = wp::extract(var_2, var_92, var_119);
        var_122 = wp::mul(var_92, var_121);
        var_123 = wp::add(var_122, var_3);
        var_124 = wp::extract(var_0, var_123);
        var_125 = wp::mul(var_11, var_124);
        var_127 = wp::mul(var_119, var_126);
        var_128 = wp::add(var_127, var_3);
        var_129 = wp::extract(var_0, var_128);
        var_130 = wp::mul(var_125, var_129);
        var_131 = wp::add(var_120, var_130);
        wp::assign_inplace(var_2, var_92, var_119, var_131);
    }
    // value = system[9 + k]                                                                  <L 6>
    var_134 = wp::add(var_133, var_132);
    var_135 = wp::extract(var_0, var_134);
    // if value > float64(1e-30):                                                             <L 7>
    var_136 = 1e-30;
    var_137 = (var_135 > var_136);
    if (var_137) {
        // root = float64(1.0) / sqrt(value)                                                  <L 8>
        var_138 = 1.0;
        var_139 = wp::sqrt(var_135);
        var_140 = wp::div(var_138, var_139);
        // for row in range(3):                                                               <L 9>
        // for column in range(3):                                                            <L 10>
        // W[row, column] = W[row, column] + root * system[row * 3 + k] * system[column * 3 + k]       <L 11>
        var_143 = wp::extract(var_2, var_141, var_142);
        var_145 = wp::mul(var_141, var_144);
        var_146 = wp::add(var_145, var_132);
        var_147 = wp::extract(var_0, var_146);
        var_148 = wp::mul(var_140, var_147);
        var_150 = wp::mul(var_142, var_149);
        var_151 = wp::add(var_150, var_132);
        var_152 = wp::extract(var_0, var_151);
        var_153 = wp::mul(var_148, var_152);
        var_154 = wp::add(var_143, var_153);
        wp::assign_inplace(var_2, var_141, var_142, var_154);
        var_156 = wp::extract(var_2, var_141, var_155);
        var_158 = wp::mul(var_141, var_157);
        var_159 = wp::add(var_158, var_132);
        var_160 = wp::extract(var_0, var_159);
        var_161 = wp::mul(var_140, var_160);
        var_163 = wp::mul(var_155, var_162);
        var_164 = wp::add(var_163, var_132);
        var_165 = wp::extract(var_0, var_164);
        var_166 = wp::mul(var_161, var_165);
        var_167 = wp::add(var_156, var_166);
        wp::assign_inplace(var_2, var_141, var_155, var_167);
        var_169 = wp::extract(var_2, var_141, var_168);
        var_171 = wp::mul(var_141, var_170);
        var_172 = wp::add(var_171, var_132);
        var_173 = wp::extract(var_0, var_172);
        var_174 = wp::mul(var_140, var_173);
        var_176 = wp::mul(var_168, var_175);
        var_177 = wp::add(var_176, var_132);
        var_178 = wp::extract(var_0, var_177);
        var_179 = wp::mul(var_174, var_178);
        var_180 = wp::add(var_169, var_179);
        wp::assign_inplace(var_2, var_141, var_168, var_180);
        // for column in range(3):                                                            <L 10>
        // W[row, column] = W[row, column] + root * system[row * 3 + k] * system[column * 3 + k]       <L 11>
        var_183 = wp::extract(var_2, var_181, var_182);
        var_185 = wp::mul(var_181, var_184);
        var_186 = wp::add(var_185, var_132);
        var_187 = wp::extract(var_0, var_186);
        var_188 = wp::mul(var_140, var_187);
        var_190 = wp::mul(var_182, var_189);
        var_191 = wp::add(var_190, var_132);
        var_192 = wp::extract(var_0, var_191);
        var_193 = wp::mul(var_188, var_192);
        var_194 = wp::add(var_183, var_193);
        wp::assign_inplace(var_2, var_181, var_182, var_194);
        var_196 = wp::extract(var_2, var_181, var_195);
        var_198 = wp::mul(var_181, var_197);
        var_199 = wp::add(var_198, var_132);
        var_200 = wp::extract(var_0, var_199);
        var_201 = wp::mul(var_140, var_200);
        var_203 = wp::mul(var_195, var_202);
        var_204 = wp::add(var_203, var_132);
        var_205 = wp::extract(var_0, var_204);
        var_206 = wp::mul(var_201, var_205);
        var_207 = wp::add(var_196, var_206);
        wp::assign_inplace(var_2, var_181, var_195, var_207);
        var_209 = wp::extract(var_2, var_181, var_208);
        var_211 = wp::mul(var_181, var_210);
        var_212 = wp::add(var_211, var_132);
        var_213 = wp::extract(var_0, var_212);
        var_214 = wp::mul(var_140, var_213);
        var_216 = wp::mul(var_208, var_215);
        var_217 = wp::add(var_216, var_132);
        var_218 = wp::extract(var_0, var_217);
        var_219 = wp::mul(var_214, var_218);
        var_220 = wp::add(var_209, var_219);
        wp::assign_inplace(var_2, var_181, var_208, var_220);
        // for column in range(3):                                                            <L 10>
        // W[row, column] = W[row, column] + root * system[row * 3 + k] * system[column * 3 + k]       <L 11>
        var_223 = wp::extract(var_2, var_221, var_222);
        var_225 = wp::mul(var_221, var_224);
        var_226 = wp::add(var_225, var_132);
        var_227 = wp::extract(var_0, var_226);
        var_228 = wp::mul(var_140, var_227);
        var_230 = wp::mul(var_222, var_229);
        var_231 = wp::add(var_230, var_132);
        var_232 = wp::extract(var_0, var_231);
        var_233 = wp::mul(var_228, var_232);
        var_234 = wp::add(var_223, var_233);
        wp::assign_inplace(var_2, var_221, var_222, var_234);
        var_236 = wp::extract(var_2, var_221, var_235);
        var_238 = wp::mul(var_221, var_237);
        var_239 = wp::add(var_238, var_132);
        var_240 = wp::extract(var_0, var_239);
        var_241 = wp::mul(var_140, var_240);
        var_243 = wp::mul(var_235, var_242);
        var_244 = wp::add(var_243, var_132);
        var_245 = wp::extract(var_0, var_244);
        var_246 = wp::mul(var_241, var_245);
        var_247 = wp::add(var_236, var_246);
        wp::assign_inplace(var_2, var_221, var_235, var_247);
        var_249 = wp::extract(var_2, var_221, var_248);
        var_251 = wp::mul(var_221, var_250);
        var_252 = wp::add(var_251, var_132);
        var_253 = wp::extract(var_0, var_252);
        var_254 = wp::mul(var_140, var_253);
        var_256 = wp::mul(var_248, var_255);
        var_257 = wp::add(var_256, var_132);
        var_258 = wp::extract(var_0, var_257);
        var_259 = wp::mul(var_254, var_258);
        var_260 = wp::add(var_249, var_259);
        wp::assign_inplace(var_2, var_221, var_248, var_260);
    }
    var_261 = wp::where(var_137, var_140, var_11);
    var_262 = wp::where(var_137, var_221, var_92);
    var_263 = wp::where(var_137, var_248, var_119);
    // value = system[9 + k]                                                                  <L 6>
    var_266 = wp::add(var_265, var_264);
    var_267 = wp::extract(var_0, var_266);
    // if value > float64(1e-30):                                                             <L 7>
    var_268 = 1e-30;
    var_269 = (var_267 > var_268);
    if (var_269) {
        // root = float64(1.0) / sqrt(value)                                                  <L 8>
        var_270 = 1.0;
        var_271 = wp::sqrt(var_267);
        var_272 = wp::div(var_270, var_271);
        // for row in range(3):                                                               <L 9>
        // for column in range(3):                                                            <L 10>
        // W[row, column] = W[row, column] + root * system[row * 3 + k] * system[column * 3 + k]       <L 11>
        var_275 = wp::extract(var_2, var_273, var_274);
        var_277 = wp::mul(var_273, var_276);
        var_278 = wp::add(var_277, var_264);
        var_279 = wp::extract(var_0, var_278);
        var_280 = wp::mul(var_272, var_279);
        var_282 = wp::mul(var_274, var_281);
        var_283 = wp::add(var_282, var_264);
        var_284 = wp::extract(var_0, var_283);
        var_285 = wp::mul(var_280, var_284);
        var_286 = wp::add(var_275, var_285);
        wp::assign_inplace(var_2, var_273, var_274, var_286);
        var_288 = wp::extract(var_2, var_273, var_287);
        var_290 = wp::mul(var_273, var_289);
        var_291 = wp::add(var_290, var_264);
        var_292 = wp::extract(var_0, var_291);
        var_293 = wp::mul(var_272, var_292);
        var_295 = wp::mul(var_287, var_294);
        var_296 = wp::add(var_295, var_264);
        var_297 = wp::extract(var_0, var_296);
        var_298 = wp::mul(var_293, var_297);
        var_299 = wp::add(var_288, var_298);
        wp::assign_inplace(var_2, var_273, var_287, var_299);
        var_301 = wp::extract(var_2, var_273, var_300);
        var_303 = wp::mul(var_273, var_302);
        var_304 = wp::add(var_303, var_264);
        var_305 = wp::extract(var_0, var_304);
        var_306 = wp::mul(var_272, var_305);
        var_308 = wp::mul(var_300, var_307);
        var_309 = wp::add(var_308, var_264);
        var_310 = wp::extract(var_0, var_309);
        var_311 = wp::mul(var_306, var_310);
        var_312 = wp::add(var_301, var_311);
        wp::assign_inplace(var_2, var_273, var_300, var_312);
        // for column in range(3):                                                            <L 10>
        // W[row, column] = W[row, column] + root * system[row * 3 + k] * system[column * 3 + k]       <L 11>
        var_315 = wp::extract(var_2, var_313, var_314);
        var_317 = wp::mul(var_313, var_316);
        var_318 = wp::add(var_317, var_264);
        var_319 = wp::extract(var_0, var_318);
        var_320 = wp::mul(var_272, var_319);
        var_322 = wp::mul(var_314, var_321);
        var_323 = wp::add(var_322, var_264);
        var_324 = wp::extract(var_0, var_323);
        var_325 = wp::mul(var_320, var_324);
        var_326 = wp::add(var_315, var_325);
        wp::assign_inplace(var_2, var_313, var_314, var_326);
        var_328 = wp::extract(var_2, var_313, var_327);
        var_330 = wp::mul(var_313, var_329);
        var_331 = wp::add(var_330, var_264);
        var_332 = wp::extract(var_0, var_331);
        var_333 = wp::mul(var_272, var_332);
        var_335 = wp::mul(var_327, var_334);
        var_336 = wp::add(var_335, var_264);
        var_337 = wp::extract(var_0, var_336);
        var_338 = wp::mul(var_333, var_337);
        var_339 = wp::add(var_328, var_338);
        wp::assign_inplace(var_2, var_313, var_327, var_339);
        var_341 = wp::extract(var_2, var_313, var_340);
        var_343 = wp::mul(var_313, var_342);
        var_344 = wp::add(var_343, var_264);
        var_345 = wp::extract(var_0, var_344);
        var_346 = wp::mul(var_272, var_345);
        var_348 = wp::mul(var_340, var_347);
        var_349 = wp::add(var_348, var_264);
        var_350 = wp::extract(var_0, var_349);
        var_351 = wp::mul(var_346, var_350);
        var_352 = wp::add(var_341, var_351);
        wp::assign_inplace(var_2, var_313, var_340, var_352);
        // for column in range(3):                                                            <L 10>
        // W[row, column] = W[row, column] + root * system[row * 3 + k] * system[column * 3 + k]       <L 11>
        var_355 = wp::extract(var_2, var_353, var_354);
        var_357 = wp::mul(var_353, var_356);
        var_358 = wp::add(var_357, var_264);
        var_359 = wp::extract(var_0, var_358);
        var_360 = wp::mul(var_272, var_359);
        var_362 = wp::mul(var_354, var_361);
        var_363 = wp::add(var_362, var_264);
        var_364 = wp::extract(var_0, var_363);
        var_365 = wp::mul(var_360, var_364);
        var_366 = wp::add(var_355, var_365);
        wp::assign_inplace(var_2, var_353, var_354, var_366);
        var_368 = wp::extract(var_2, var_353, var_367);
        var_370 = wp::mul(var_353, var_369);
        var_371 = wp::add(var_370, var_264);
        var_372 = wp::extract(var_0, var_371);
        var_373 = wp::mul(var_272, var_372);
        var_375 = wp::mul(var_367, var_374);
        var_376 = wp::add(var_375, var_264);
        var_377 = wp::extract(var_0, var_376);
        var_378 = wp::mul(var_373, var_377);
        var_379 = wp::add(var_368, var_378);
        wp::assign_inplace(var_2, var_353, var_367, var_379);
        var_381 = wp::extract(var_2, var_353, var_380);
        var_383 = wp::mul(var_353, var_382);
        var_384 = wp::add(var_383, var_264);
        var_385 = wp::extract(var_0, var_384);
        var_386 = wp::mul(var_272, var_385);
        var_388 = wp::mul(var_380, var_387);
        var_389 = wp::add(var_388, var_264);
        var_390 = wp::extract(var_0, var_389);
        var_391 = wp::mul(var_386, var_390);
        var_392 = wp::add(var_381, var_391);
        wp::assign_inplace(var_2, var_353, var_380, var_392);
    }
    var_393 = wp::where(var_269, var_272, var_261);
    var_394 = wp::where(var_269, var_353, var_262);
    var_395 = wp::where(var_269, var_380, var_263);
    // return W                                                                               <L 12>
    return var_2;
}


// <pointloom.kernels.icp.rows.sum_generalized_rows_element>:1
static CUDA_CALLABLE wp::vec_t<36, wp::float64> sum_generalized_rows_element_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__jobs__sources__points,
    wp::array_t<wp::int32> var_matches__jobs__sources__first_positions,
    wp::array_t<wp::int32> var_matches__jobs__group_jobs,
    wp::array_t<wp::int32> var_matches__jobs__job_groups,
    wp::array_t<wp::int32> var_matches__jobs__job_sources,
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__targets,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_matches__poses,
    wp::array_t<wp::int32> var_matches__pairs,
    wp::int32 var_matches__weighted,
    wp::array_t<wp::float32> var_matches__weights,
    wp::int32 var_loss__kind,
    wp::float64 var_loss__k,
    wp::float64 var_loss__shape,
    wp::array_t<wp::float32> var_source__covariances,
    wp::array_t<wp::float32> var_target__covariances,
    wp::int32 var_i)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float64> var_0;
    wp::vec_t<3, wp::float64> var_1;
    wp::float64 var_2;
    wp::float64 var_3;
    wp::vec_t<36, wp::float64> var_4;
    wp::float64 var_5;
    bool var_6;
    const wp::int32 var_7 = 8;
    wp::int32 var_8;
    wp::int32* var_9;
    wp::int32 var_10;
    wp::int32 var_11;
    wp::int32 var_12;
    wp::mat_t<4, 4, wp::float64>* var_13;
    wp::mat_t<4, 4, wp::float64> var_14;
    wp::mat_t<4, 4, wp::float64> var_15;
    wp::int32* var_16;
    wp::mat_t<3, 3, wp::float64> var_17;
    wp::int32 var_18;
    wp::mat_t<3, 3, wp::float64> var_19;
    wp::mat_t<3, 3, wp::float64> var_20;
    wp::mat_t<3, 3, wp::float64> var_21;
    wp::vec_t<3, wp::float64> var_22;
    const wp::int32 var_23 = 0;
    bool var_24;
    wp::mat_t<3, 3, wp::float64> var_25;
    wp::float64 var_26;
    const wp::int32 var_27 = -1;
    bool var_28;
    wp::float64 var_29;
    wp::float64 var_30;
    wp::float64 var_31;
    wp::float64 var_32;
    const wp::int32 var_33 = 0;
    wp::float64 var_34;
    wp::float64 var_35;
    const wp::int32 var_36 = 1;
    wp::float64 var_37;
    wp::float64 var_38;
    const wp::int32 var_39 = 2;
    wp::float64 var_40;
    wp::float64 var_41;
    const wp::int32 var_42 = 0;
    const wp::int32 var_43 = 0;
    wp::float64 var_44;
    const wp::int32 var_45 = 1;
    const wp::int32 var_46 = 1;
    wp::float64 var_47;
    wp::float64 var_48;
    const wp::int32 var_49 = 2;
    const wp::int32 var_50 = 2;
    wp::float64 var_51;
    wp::float64 var_52;
    wp::float64 var_53;
    wp::float64 var_54;
    wp::vec_t<36, wp::float64> var_55;
    wp::vec_t<36, wp::float64> var_56;
    wp::mat_t<3, 3, wp::float64> var_57;
    const wp::int32 var_58 = 0;
    const wp::int32 var_59 = 0;
    wp::float64 var_60;
    const wp::int32 var_61 = 1;
    wp::float64 var_62;
    const wp::int32 var_63 = 2;
    wp::float64 var_64;
    wp::vec_t<3, wp::float64> var_65;
    wp::float64 var_66;
    wp::vec_t<3, wp::float64> var_67;
    wp::float64 var_68;
    wp::vec_t<36, wp::float64> var_69;
    wp::vec_t<36, wp::float64> var_70;
    const wp::int32 var_71 = 1;
    const wp::int32 var_72 = 0;
    wp::float64 var_73;
    const wp::int32 var_74 = 1;
    wp::float64 var_75;
    const wp::int32 var_76 = 2;
    wp::float64 var_77;
    wp::vec_t<3, wp::float64> var_78;
    wp::float64 var_79;
    wp::vec_t<3, wp::float64> var_80;
    wp::float64 var_81;
    wp::vec_t<36, wp::float64> var_82;
    wp::vec_t<36, wp::float64> var_83;
    const wp::int32 var_84 = 2;
    const wp::int32 var_85 = 0;
    wp::float64 var_86;
    const wp::int32 var_87 = 1;
    wp::float64 var_88;
    const wp::int32 var_89 = 2;
    wp::float64 var_90;
    wp::vec_t<3, wp::float64> var_91;
    wp::float64 var_92;
    wp::vec_t<3, wp::float64> var_93;
    wp::float64 var_94;
    wp::vec_t<36, wp::float64> var_95;
    wp::vec_t<36, wp::float64> var_96;
    wp::float64 var_97;
    wp::vec_t<36, wp::float64> var_98;
    wp::vec_t<36, wp::float64> var_99;
    wp::int32 var_100;
    wp::vec_t<36, wp::float64> var_101;
    wp::vec_t<36, wp::float64> var_102;
    //---------
    // forward
    // def sum_generalized_rows_element(matches__jobs__sources__points, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__targets, matches__poses, matches__pairs, matches__weighted, matches__weights, loss__kind, loss__k, loss__shape, source__covariances, target__covariances, i):       <L 1>
    // p, q, paired = pair_of(i, matches__jobs__sources__points, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__targets, matches__poses, matches__pairs)       <L 2>
    pair_of_0(var_i, var_matches__jobs__sources__points, var_matches__jobs__sources__first_positions, var_matches__jobs__group_jobs, var_matches__jobs__job_groups, var_matches__jobs__job_sources, var_matches__targets, var_matches__poses, var_matches__pairs, var_0, var_1, var_2);
    // total = row_sums(float64(0.0))                                                         <L 3>
    var_3 = 0.0;
    var_4 = wp::vec_t<36, wp::float64>(var_3);
    // if paired > float64(0.0):                                                              <L 4>
    var_5 = 0.0;
    var_6 = (var_2 > var_5);
    if (var_6) {
        // job = matches__jobs__group_jobs[i // LEAF]                                         <L 5>
        var_8 = wp::floordiv(var_i, var_7);
        var_9 = wp::address(var_matches__jobs__group_jobs, var_8);
        var_11 = wp::load(var_9);
        var_10 = wp::copy(var_11);
        // at = source_position(i, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources)       <L 6>
        var_12 = source_position_0(var_i, var_matches__jobs__sources__first_positions, var_matches__jobs__group_jobs, var_matches__jobs__job_groups, var_matches__jobs__job_sources);
        // pose = matches__poses[job]                                                         <L 7>
        var_13 = wp::address(var_matches__poses, var_10);
        var_15 = wp::load(var_13);
        var_14 = wp::copy(var_15);
        // M = read_covariance(target__covariances, matches__pairs[i]) + rotate_covariance(pose, read_covariance(source__covariances, at))       <L 8>
        var_16 = wp::address(var_matches__pairs, var_i);
        var_18 = wp::load(var_16);
        var_17 = read_covariance_0(var_target__covariances, var_18);
        var_19 = read_covariance_0(var_source__covariances, var_12);
        var_20 = rotate_covariance_0(var_14, var_19);
        var_21 = wp::add(var_17, var_20);
        // d = p - q                                                                          <L 9>
        var_22 = wp::sub(var_0, var_1);
        // if loss__kind <= L2:                                                               <L 10>
        var_24 = (var_loss__kind <= var_23);
        if (var_24) {
            // A = inverse(M)                                                                 <L 11>
            var_25 = inverse_0(var_21);
            // scale = weight_of(i, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__weighted, matches__weights)       <L 12>
            var_26 = weight_of_2(var_i, var_matches__jobs__sources__first_positions, var_matches__jobs__group_jobs, var_matches__jobs__job_groups, var_matches__jobs__job_sources, var_matches__weighted, var_matches__weights);
            // if loss__kind == GEOMETRY:                                                     <L 13>
            var_28 = (var_loss__kind == var_27);
            if (var_28) {
                // floor = float64(1.0) / sqrt(trace_of_square(M))                            <L 14>
                var_29 = 1.0;
                var_30 = trace_of_square_0(var_21);
                var_31 = wp::sqrt(var_30);
                var_32 = wp::div(var_29, var_31);
                // for row in range(3):                                                       <L 15>
                // A[row, row] = A[row, row] - floor                                          <L 16>
                var_34 = wp::extract(var_25, var_33, var_33);
                var_35 = wp::sub(var_34, var_32);
                wp::assign_inplace(var_25, var_33, var_33, var_35);
                var_37 = wp::extract(var_25, var_36, var_36);
                var_38 = wp::sub(var_37, var_32);
                wp::assign_inplace(var_25, var_36, var_36, var_38);
                var_40 = wp::extract(var_25, var_39, var_39);
                var_41 = wp::sub(var_40, var_32);
                wp::assign_inplace(var_25, var_39, var_39, var_41);
                // scale = scale / (A[0, 0] + A[1, 1] + A[2, 2])                              <L 17>
                var_44 = wp::extract(var_25, var_42, var_43);
                var_47 = wp::extract(var_25, var_45, var_46);
                var_48 = wp::add(var_44, var_47);
                var_51 = wp::extract(var_25, var_49, var_50);
                var_52 = wp::add(var_48, var_51);
                var_53 = wp::div(var_26, var_52);
            }
            var_54 = wp::where(var_28, var_53, var_26);
            // total = sum_block(p, A, d) * scale                                             <L 18>
            var_55 = sum_block_0(var_0, var_25, var_22);
            var_56 = wp::mul(var_55, var_54);
        }
        if (!var_24) {
            // W = inverse_root(M)                                                            <L 20>
            var_57 = inverse_root_0(var_21);
            // for row in range(3):                                                           <L 21>
            // v = vec3d(W[row, 0], W[row, 1], W[row, 2])                                     <L 22>
            var_60 = wp::extract(var_57, var_58, var_59);
            var_62 = wp::extract(var_57, var_58, var_61);
            var_64 = wp::extract(var_57, var_58, var_63);
            var_65 = wp::vec_t<3, wp::float64>(var_60, var_62, var_64);
            // r = dot(v, d)                                                                  <L 23>
            var_66 = wp::dot(var_65, var_22);
            // total += sum_row(cross(p, v), v, r, robust_weight(loss__kind, loss__k, loss__shape, r))       <L 24>
            var_67 = wp::cross(var_0, var_65);
            var_68 = robust_weight_0(var_loss__kind, var_loss__k, var_loss__shape, var_66);
            var_69 = sum_row_0(var_67, var_65, var_66, var_68);
            var_70 = wp::add(var_4, var_69);
            // v = vec3d(W[row, 0], W[row, 1], W[row, 2])                                     <L 22>
            var_73 = wp::extract(var_57, var_71, var_72);
            var_75 = wp::extract(var_57, var_71, var_74);
            var_77 = wp::extract(var_57, var_71, var_76);
            var_78 = wp::vec_t<3, wp::float64>(var_73, var_75, var_77);
            // r = dot(v, d)                                                                  <L 23>
            var_79 = wp::dot(var_78, var_22);
            // total += sum_row(cross(p, v), v, r, robust_weight(loss__kind, loss__k, loss__shape, r))       <L 24>
            var_80 = wp::cross(var_0, var_78);
            var_81 = robust_weight_0(var_loss__kind, var_loss__k, var_loss__shape, var_79);
            var_82 = sum_row_0(var_80, var_78, var_79, var_81);
            var_83 = wp::add(var_70, var_82);
            // v = vec3d(W[row, 0], W[row, 1], W[row, 2])                                     <L 22>
            var_86 = wp::extract(var_57, var_84, var_85);
            var_88 = wp::extract(var_57, var_84, var_87);
            var_90 = wp::extract(var_57, var_84, var_89);
            var_91 = wp::vec_t<3, wp::float64>(var_86, var_88, var_90);
            // r = dot(v, d)                                                                  <L 23>
            var_92 = wp::dot(var_91, var_22);
            // total += sum_row(cross(p, v), v, r, robust_weight(loss__kind, loss__k, loss__shape, r))       <L 24>
            var_93 = wp::cross(var_0, var_91);
            var_94 = robust_weight_0(var_loss__kind, var_loss__k, var_loss__shape, var_92);
            var_95 = sum_row_0(var_93, var_91, var_92, var_94);
            var_96 = wp::add(var_83, var_95);
            // total = total * weight_of(i, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__weighted, matches__weights)       <L 25>
            var_97 = weight_of_2(var_i, var_matches__jobs__sources__first_positions, var_matches__jobs__group_jobs, var_matches__jobs__job_groups, var_matches__jobs__job_sources, var_matches__weighted, var_matches__weights);
            var_98 = wp::mul(var_96, var_97);
        }
        var_99 = wp::where(var_24, var_56, var_98);
        var_100 = wp::where(var_24, var_39, var_84);
        // total = count_pair(total, p, q, paired)                                            <L 26>
        var_101 = count_pair_0(var_99, var_0, var_1, var_2);
    }
    var_102 = wp::where(var_6, var_101, var_4);
    // return total                                                                           <L 27>
    return var_102;
}


// /work/main/src/pointloom/kernels/algebra/transform.py:27
static CUDA_CALLABLE void adj_widen_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.icp.matches.paired_target>:1
static CUDA_CALLABLE void adj_paired_target_0(
    wp::int32 var_i,
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__targets,
    wp::array_t<wp::int32> var_matches__pairs,
    wp::int32 & adj_i,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_matches__targets,
    wp::array_t<wp::int32> & adj_matches__pairs,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/icp/rows.py:114
static CUDA_CALLABLE void adj_sum_row_0(
    wp::vec_t<3, wp::float64> var_u,
    wp::vec_t<3, wp::float64> var_v,
    wp::float64 var_r,
    wp::float64 var_w,
    wp::vec_t<3, wp::float64> & adj_u,
    wp::vec_t<3, wp::float64> & adj_v,
    wp::float64 & adj_r,
    wp::float64 & adj_w,
    wp::vec_t<36, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.icp.rows.sum_information_element>:1
static CUDA_CALLABLE void adj_sum_information_element_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__targets,
    wp::array_t<wp::int32> var_matches__pairs,
    wp::int32 var_i,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_matches__targets,
    wp::array_t<wp::int32> & adj_matches__pairs,
    wp::int32 & adj_i,
    wp::vec_t<36, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.icp.jobs.source_position>:1
static CUDA_CALLABLE void adj_source_position_0(
    wp::int32 var_i,
    wp::array_t<wp::int32> var_jobs__sources__first_positions,
    wp::array_t<wp::int32> var_jobs__group_jobs,
    wp::array_t<wp::int32> var_jobs__job_groups,
    wp::array_t<wp::int32> var_jobs__job_sources,
    wp::int32 & adj_i,
    wp::array_t<wp::int32> & adj_jobs__sources__first_positions,
    wp::array_t<wp::int32> & adj_jobs__group_jobs,
    wp::array_t<wp::int32> & adj_jobs__job_groups,
    wp::array_t<wp::int32> & adj_jobs__job_sources,
    wp::int32 & adj_ret)
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


// <pointloom.kernels.icp.matches.moved_source>:1
static CUDA_CALLABLE void adj_moved_source_0(
    wp::int32 var_i,
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__jobs__sources__points,
    wp::array_t<wp::int32> var_matches__jobs__sources__first_positions,
    wp::array_t<wp::int32> var_matches__jobs__group_jobs,
    wp::array_t<wp::int32> var_matches__jobs__job_groups,
    wp::array_t<wp::int32> var_matches__jobs__job_sources,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_matches__poses,
    wp::int32 & adj_i,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_matches__jobs__sources__points,
    wp::array_t<wp::int32> & adj_matches__jobs__sources__first_positions,
    wp::array_t<wp::int32> & adj_matches__jobs__group_jobs,
    wp::array_t<wp::int32> & adj_matches__jobs__job_groups,
    wp::array_t<wp::int32> & adj_matches__jobs__job_sources,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> & adj_matches__poses,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.icp.matches.pair_of>:1
static CUDA_CALLABLE void adj_pair_of_0(
    wp::int32 var_i,
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__jobs__sources__points,
    wp::array_t<wp::int32> var_matches__jobs__sources__first_positions,
    wp::array_t<wp::int32> var_matches__jobs__group_jobs,
    wp::array_t<wp::int32> var_matches__jobs__job_groups,
    wp::array_t<wp::int32> var_matches__jobs__job_sources,
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__targets,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_matches__poses,
    wp::array_t<wp::int32> var_matches__pairs,
    wp::vec_t<3, wp::float64> & ret_0,
    wp::vec_t<3, wp::float64> & ret_1,
    wp::float64 & ret_2,
    wp::int32 & adj_i,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_matches__jobs__sources__points,
    wp::array_t<wp::int32> & adj_matches__jobs__sources__first_positions,
    wp::array_t<wp::int32> & adj_matches__jobs__group_jobs,
    wp::array_t<wp::int32> & adj_matches__jobs__job_groups,
    wp::array_t<wp::int32> & adj_matches__jobs__job_sources,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_matches__targets,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> & adj_matches__poses,
    wp::array_t<wp::int32> & adj_matches__pairs,
    wp::vec_t<3, wp::float64> & adj_ret_0,
    wp::vec_t<3, wp::float64> & adj_ret_1,
    wp::float64 & adj_ret_2)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.icp.robust_weights.general_weight>:1
static CUDA_CALLABLE void adj_general_weight_0(
    wp::float64 var_r,
    wp::float64 var_k,
    wp::float64 var_shape,
    wp::float64 & adj_r,
    wp::float64 & adj_k,
    wp::float64 & adj_shape,
    wp::float64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.icp.robust_weights.robust_weight>:1
static CUDA_CALLABLE void adj_robust_weight_0(
    wp::int32 var_loss__kind,
    wp::float64 var_loss__k,
    wp::float64 var_loss__shape,
    wp::float64 var_r,
    wp::int32 & adj_loss__kind,
    wp::float64 & adj_loss__k,
    wp::float64 & adj_loss__shape,
    wp::float64 & adj_r,
    wp::float64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.icp.matches.weight_of>:1
static CUDA_CALLABLE void adj_weight_of_2(
    wp::int32 var_i,
    wp::array_t<wp::int32> var_matches__jobs__sources__first_positions,
    wp::array_t<wp::int32> var_matches__jobs__group_jobs,
    wp::array_t<wp::int32> var_matches__jobs__job_groups,
    wp::array_t<wp::int32> var_matches__jobs__job_sources,
    wp::int32 var_matches__weighted,
    wp::array_t<wp::float32> var_matches__weights,
    wp::int32 & adj_i,
    wp::array_t<wp::int32> & adj_matches__jobs__sources__first_positions,
    wp::array_t<wp::int32> & adj_matches__jobs__group_jobs,
    wp::array_t<wp::int32> & adj_matches__jobs__job_groups,
    wp::array_t<wp::int32> & adj_matches__jobs__job_sources,
    wp::int32 & adj_matches__weighted,
    wp::array_t<wp::float32> & adj_matches__weights,
    wp::float64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/icp/rows.py:178
static CUDA_CALLABLE void adj_count_pair_0(
    wp::vec_t<36, wp::float64> var_sums,
    wp::vec_t<3, wp::float64> var_p,
    wp::vec_t<3, wp::float64> var_q,
    wp::float64 var_paired,
    wp::vec_t<36, wp::float64> & adj_sums,
    wp::vec_t<3, wp::float64> & adj_p,
    wp::vec_t<3, wp::float64> & adj_q,
    wp::float64 & adj_paired,
    wp::vec_t<36, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.icp.rows.sum_colored_rows_element>:1
static CUDA_CALLABLE void adj_sum_colored_rows_element_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__jobs__sources__points,
    wp::array_t<wp::int32> var_matches__jobs__sources__first_positions,
    wp::array_t<wp::int32> var_matches__jobs__group_jobs,
    wp::array_t<wp::int32> var_matches__jobs__job_groups,
    wp::array_t<wp::int32> var_matches__jobs__job_sources,
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__targets,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_matches__poses,
    wp::array_t<wp::int32> var_matches__pairs,
    wp::int32 var_matches__weighted,
    wp::array_t<wp::float32> var_matches__weights,
    wp::int32 var_loss__kind,
    wp::float64 var_loss__k,
    wp::float64 var_loss__shape,
    wp::array_t<wp::float32> var_source__intensities,
    wp::array_t<wp::vec_t<3, wp::float32>> var_target__normals,
    wp::array_t<wp::float32> var_target__intensities,
    wp::array_t<wp::vec_t<3, wp::float32>> var_target__gradients,
    wp::float64 var_geometric_share,
    wp::int32 var_i,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_matches__jobs__sources__points,
    wp::array_t<wp::int32> & adj_matches__jobs__sources__first_positions,
    wp::array_t<wp::int32> & adj_matches__jobs__group_jobs,
    wp::array_t<wp::int32> & adj_matches__jobs__job_groups,
    wp::array_t<wp::int32> & adj_matches__jobs__job_sources,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_matches__targets,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> & adj_matches__poses,
    wp::array_t<wp::int32> & adj_matches__pairs,
    wp::int32 & adj_matches__weighted,
    wp::array_t<wp::float32> & adj_matches__weights,
    wp::int32 & adj_loss__kind,
    wp::float64 & adj_loss__k,
    wp::float64 & adj_loss__shape,
    wp::array_t<wp::float32> & adj_source__intensities,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_target__normals,
    wp::array_t<wp::float32> & adj_target__intensities,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_target__gradients,
    wp::float64 & adj_geometric_share,
    wp::int32 & adj_i,
    wp::vec_t<36, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.icp.rows.sum_doppler_rows_element>:1
static CUDA_CALLABLE void adj_sum_doppler_rows_element_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__jobs__sources__points,
    wp::array_t<wp::int32> var_matches__jobs__sources__first_positions,
    wp::array_t<wp::int32> var_matches__jobs__group_jobs,
    wp::array_t<wp::int32> var_matches__jobs__job_groups,
    wp::array_t<wp::int32> var_matches__jobs__job_sources,
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__targets,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_matches__poses,
    wp::array_t<wp::int32> var_matches__pairs,
    wp::int32 var_matches__weighted,
    wp::array_t<wp::float32> var_matches__weights,
    wp::int32 var_loss__kind,
    wp::float64 var_loss__k,
    wp::float64 var_loss__shape,
    wp::array_t<wp::float32> var_source__dopplers,
    wp::array_t<wp::vec_t<3, wp::float32>> var_source__directions,
    wp::array_t<wp::vec_t<3, wp::float32>> var_target__normals,
    wp::array_t<wp::vec_t<6, wp::float64>> var_velocities,
    wp::array_t<wp::int32> var_iterations,
    wp::vec_t<3, wp::float64> var_rule__sensor,
    wp::float64 var_rule__period,
    wp::float64 var_rule__share,
    wp::int32 var_rule__loss__kind,
    wp::float64 var_rule__loss__k,
    wp::float64 var_rule__loss__shape,
    wp::int32 var_rule__geometric_from,
    wp::int32 var_rule__doppler_from,
    wp::int32 var_rule__reject_from,
    wp::float64 var_rule__threshold,
    wp::int32 var_i,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_matches__jobs__sources__points,
    wp::array_t<wp::int32> & adj_matches__jobs__sources__first_positions,
    wp::array_t<wp::int32> & adj_matches__jobs__group_jobs,
    wp::array_t<wp::int32> & adj_matches__jobs__job_groups,
    wp::array_t<wp::int32> & adj_matches__jobs__job_sources,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_matches__targets,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> & adj_matches__poses,
    wp::array_t<wp::int32> & adj_matches__pairs,
    wp::int32 & adj_matches__weighted,
    wp::array_t<wp::float32> & adj_matches__weights,
    wp::int32 & adj_loss__kind,
    wp::float64 & adj_loss__k,
    wp::float64 & adj_loss__shape,
    wp::array_t<wp::float32> & adj_source__dopplers,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_source__directions,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_target__normals,
    wp::array_t<wp::vec_t<6, wp::float64>> & adj_velocities,
    wp::array_t<wp::int32> & adj_iterations,
    wp::vec_t<3, wp::float64> & adj_rule__sensor,
    wp::float64 & adj_rule__period,
    wp::float64 & adj_rule__share,
    wp::int32 & adj_rule__loss__kind,
    wp::float64 & adj_rule__loss__k,
    wp::float64 & adj_rule__loss__shape,
    wp::int32 & adj_rule__geometric_from,
    wp::int32 & adj_rule__doppler_from,
    wp::int32 & adj_rule__reject_from,
    wp::float64 & adj_rule__threshold,
    wp::int32 & adj_i,
    wp::vec_t<36, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.icp.rows.sum_plane_rows_element>:1
static CUDA_CALLABLE void adj_sum_plane_rows_element_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__jobs__sources__points,
    wp::array_t<wp::int32> var_matches__jobs__sources__first_positions,
    wp::array_t<wp::int32> var_matches__jobs__group_jobs,
    wp::array_t<wp::int32> var_matches__jobs__job_groups,
    wp::array_t<wp::int32> var_matches__jobs__job_sources,
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__targets,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_matches__poses,
    wp::array_t<wp::int32> var_matches__pairs,
    wp::int32 var_matches__weighted,
    wp::array_t<wp::float32> var_matches__weights,
    wp::int32 var_loss__kind,
    wp::float64 var_loss__k,
    wp::float64 var_loss__shape,
    wp::array_t<wp::vec_t<3, wp::float32>> var_target__normals,
    wp::int32 var_i,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_matches__jobs__sources__points,
    wp::array_t<wp::int32> & adj_matches__jobs__sources__first_positions,
    wp::array_t<wp::int32> & adj_matches__jobs__group_jobs,
    wp::array_t<wp::int32> & adj_matches__jobs__job_groups,
    wp::array_t<wp::int32> & adj_matches__jobs__job_sources,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_matches__targets,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> & adj_matches__poses,
    wp::array_t<wp::int32> & adj_matches__pairs,
    wp::int32 & adj_matches__weighted,
    wp::array_t<wp::float32> & adj_matches__weights,
    wp::int32 & adj_loss__kind,
    wp::float64 & adj_loss__k,
    wp::float64 & adj_loss__shape,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_target__normals,
    wp::int32 & adj_i,
    wp::vec_t<36, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/algebra/rigid_solve.py:310
static CUDA_CALLABLE void adj_rotate_1(
    wp::mat_t<4, 4, wp::float64> var_pose,
    wp::vec_t<3, wp::float64> var_v,
    wp::mat_t<4, 4, wp::float64> & adj_pose,
    wp::vec_t<3, wp::float64> & adj_v,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.icp.rows.sum_symmetric_rows_element>:1
static CUDA_CALLABLE void adj_sum_symmetric_rows_element_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__jobs__sources__points,
    wp::array_t<wp::int32> var_matches__jobs__sources__first_positions,
    wp::array_t<wp::int32> var_matches__jobs__group_jobs,
    wp::array_t<wp::int32> var_matches__jobs__job_groups,
    wp::array_t<wp::int32> var_matches__jobs__job_sources,
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__targets,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_matches__poses,
    wp::array_t<wp::int32> var_matches__pairs,
    wp::int32 var_matches__weighted,
    wp::array_t<wp::float32> var_matches__weights,
    wp::int32 var_loss__kind,
    wp::float64 var_loss__k,
    wp::float64 var_loss__shape,
    wp::array_t<wp::vec_t<3, wp::float32>> var_source__normals,
    wp::array_t<wp::vec_t<3, wp::float32>> var_target__normals,
    wp::int32 var_i,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_matches__jobs__sources__points,
    wp::array_t<wp::int32> & adj_matches__jobs__sources__first_positions,
    wp::array_t<wp::int32> & adj_matches__jobs__group_jobs,
    wp::array_t<wp::int32> & adj_matches__jobs__job_groups,
    wp::array_t<wp::int32> & adj_matches__jobs__job_sources,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_matches__targets,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> & adj_matches__poses,
    wp::array_t<wp::int32> & adj_matches__pairs,
    wp::int32 & adj_matches__weighted,
    wp::array_t<wp::float32> & adj_matches__weights,
    wp::int32 & adj_loss__kind,
    wp::float64 & adj_loss__k,
    wp::float64 & adj_loss__shape,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_source__normals,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_target__normals,
    wp::int32 & adj_i,
    wp::vec_t<36, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/algebra/rigid_solve.py:319
static CUDA_CALLABLE void adj_sums_of_pair_0(
    wp::vec_t<3, wp::float64> var_p,
    wp::vec_t<3, wp::float64> var_q,
    wp::float64 var_w,
    wp::vec_t<3, wp::float64> & adj_p,
    wp::vec_t<3, wp::float64> & adj_q,
    wp::float64 & adj_w,
    wp::vec_t<18, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/icp/rows.py:166
static CUDA_CALLABLE void adj_sum_pair_0(
    wp::vec_t<3, wp::float64> var_p,
    wp::vec_t<3, wp::float64> var_q,
    wp::float64 var_w,
    wp::vec_t<3, wp::float64> & adj_p,
    wp::vec_t<3, wp::float64> & adj_q,
    wp::float64 & adj_w,
    wp::vec_t<36, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.icp.rows.sum_point_rows_element>:1
static CUDA_CALLABLE void adj_sum_point_rows_element_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__jobs__sources__points,
    wp::array_t<wp::int32> var_matches__jobs__sources__first_positions,
    wp::array_t<wp::int32> var_matches__jobs__group_jobs,
    wp::array_t<wp::int32> var_matches__jobs__job_groups,
    wp::array_t<wp::int32> var_matches__jobs__job_sources,
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__targets,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_matches__poses,
    wp::array_t<wp::int32> var_matches__pairs,
    wp::int32 var_matches__weighted,
    wp::array_t<wp::float32> var_matches__weights,
    wp::int32 var_loss__kind,
    wp::float64 var_loss__k,
    wp::float64 var_loss__shape,
    wp::array_t<wp::vec_t<3, wp::float64>> var_pivots,
    wp::int32 var_i,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_matches__jobs__sources__points,
    wp::array_t<wp::int32> & adj_matches__jobs__sources__first_positions,
    wp::array_t<wp::int32> & adj_matches__jobs__group_jobs,
    wp::array_t<wp::int32> & adj_matches__jobs__job_groups,
    wp::array_t<wp::int32> & adj_matches__jobs__job_sources,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_matches__targets,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> & adj_matches__poses,
    wp::array_t<wp::int32> & adj_matches__pairs,
    wp::int32 & adj_matches__weighted,
    wp::array_t<wp::float32> & adj_matches__weights,
    wp::int32 & adj_loss__kind,
    wp::float64 & adj_loss__k,
    wp::float64 & adj_loss__shape,
    wp::array_t<wp::vec_t<3, wp::float64>> & adj_pivots,
    wp::int32 & adj_i,
    wp::vec_t<36, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.icp.rows.read_covariance>:1
static CUDA_CALLABLE void adj_read_covariance_0(
    wp::array_t<wp::float32> var_covariances,
    wp::int32 var_i,
    wp::array_t<wp::float32> & adj_covariances,
    wp::int32 & adj_i,
    wp::mat_t<3, 3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.algebra.matrices.multiply33>:1
static CUDA_CALLABLE void adj_multiply33_0(
    wp::mat_t<3, 3, wp::float64> var_a,
    wp::mat_t<3, 3, wp::float64> var_b,
    wp::mat_t<3, 3, wp::float64> & adj_a,
    wp::mat_t<3, 3, wp::float64> & adj_b,
    wp::mat_t<3, 3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.icp.rows.rotate_covariance>:1
static CUDA_CALLABLE void adj_rotate_covariance_0(
    wp::mat_t<4, 4, wp::float64> var_pose,
    wp::mat_t<3, 3, wp::float64> var_C,
    wp::mat_t<4, 4, wp::float64> & adj_pose,
    wp::mat_t<3, 3, wp::float64> & adj_C,
    wp::mat_t<3, 3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.icp.rows.inverse>:1
static CUDA_CALLABLE void adj_inverse_0(
    wp::mat_t<3, 3, wp::float64> var_M,
    wp::mat_t<3, 3, wp::float64> & adj_M,
    wp::mat_t<3, 3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/icp/rows.py:96
static CUDA_CALLABLE void adj_trace_of_square_0(
    wp::mat_t<3, 3, wp::float64> var_M,
    wp::mat_t<3, 3, wp::float64> & adj_M,
    wp::float64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/icp/rows.py:131
static CUDA_CALLABLE void adj_sum_block_0(
    wp::vec_t<3, wp::float64> var_p,
    wp::mat_t<3, 3, wp::float64> var_A,
    wp::vec_t<3, wp::float64> var_d,
    wp::vec_t<3, wp::float64> & adj_p,
    wp::mat_t<3, 3, wp::float64> & adj_A,
    wp::vec_t<3, wp::float64> & adj_d,
    wp::vec_t<36, wp::float64> & adj_ret)
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


// <pointloom.kernels.algebra.rigid_solve.diagonalize_three>:1
static CUDA_CALLABLE void adj_diagonalize_three_0(
    wp::mat_t<3, 3, wp::float64> var_matrix,
    wp::mat_t<3, 3, wp::float64> & adj_matrix,
    wp::vec_t<12, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.icp.rows.inverse_root>:1
static CUDA_CALLABLE void adj_inverse_root_0(
    wp::mat_t<3, 3, wp::float64> var_M,
    wp::mat_t<3, 3, wp::float64> & adj_M,
    wp::mat_t<3, 3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.icp.rows.sum_generalized_rows_element>:1
static CUDA_CALLABLE void adj_sum_generalized_rows_element_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__jobs__sources__points,
    wp::array_t<wp::int32> var_matches__jobs__sources__first_positions,
    wp::array_t<wp::int32> var_matches__jobs__group_jobs,
    wp::array_t<wp::int32> var_matches__jobs__job_groups,
    wp::array_t<wp::int32> var_matches__jobs__job_sources,
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__targets,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_matches__poses,
    wp::array_t<wp::int32> var_matches__pairs,
    wp::int32 var_matches__weighted,
    wp::array_t<wp::float32> var_matches__weights,
    wp::int32 var_loss__kind,
    wp::float64 var_loss__k,
    wp::float64 var_loss__shape,
    wp::array_t<wp::float32> var_source__covariances,
    wp::array_t<wp::float32> var_target__covariances,
    wp::int32 var_i,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_matches__jobs__sources__points,
    wp::array_t<wp::int32> & adj_matches__jobs__sources__first_positions,
    wp::array_t<wp::int32> & adj_matches__jobs__group_jobs,
    wp::array_t<wp::int32> & adj_matches__jobs__job_groups,
    wp::array_t<wp::int32> & adj_matches__jobs__job_sources,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_matches__targets,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> & adj_matches__poses,
    wp::array_t<wp::int32> & adj_matches__pairs,
    wp::int32 & adj_matches__weighted,
    wp::array_t<wp::float32> & adj_matches__weights,
    wp::int32 & adj_loss__kind,
    wp::float64 & adj_loss__k,
    wp::float64 & adj_loss__shape,
    wp::array_t<wp::float32> & adj_source__covariances,
    wp::array_t<wp::float32> & adj_target__covariances,
    wp::int32 & adj_i,
    wp::vec_t<36, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void sum_information_tiles_01b876aa_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__targets,
    wp::array_t<wp::int32> var_matches__pairs,
    wp::array_t<wp::int32> var_firsts_,
    wp::array_t<wp::int32> var_lasts_,
    wp::array_t<wp::int32> var_owners_,
    wp::array_t<wp::int32> var_live_,
    wp::array_t<wp::vec_t<36, wp::float64>> var_partials_)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        const wp::int32 var_1 = 256;
        wp::int32 var_2;
        wp::vec_t<36, wp::float64> var_3;
        wp::int32* var_4;
        wp::int32 var_5;
        wp::int32* var_6;
        const wp::int32 var_7 = 0;
        bool var_8;
        wp::int32 var_9;
        wp::int32* var_10;
        const wp::int32 var_11 = 256;
        wp::int32 var_12;
        wp::int32 var_13;
        wp::int32 var_14;
        wp::int32* var_15;
        const wp::int32 var_16 = 256;
        wp::range_t var_17;
        wp::int32 var_18;
        wp::int32 var_19;
        wp::vec_t<36, wp::float64> var_20;
        wp::vec_t<36, wp::float64> var_21;
        const wp::int32 var_22 = 0;
        wp::float64 var_23;
        const wp::int32 var_24 = 1;
        wp::float64 var_25;
        const wp::int32 var_26 = 2;
        wp::float64 var_27;
        const wp::int32 var_28 = 3;
        wp::float64 var_29;
        wp::vec_t<4, wp::float64> var_30;
        const bool var_31 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_32 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_33 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_34 = 0;
        wp::vec_t<4, wp::float64> var_35;
        const wp::int32 var_36 = 0;
        wp::float64 var_37;
        const wp::int32 var_38 = 0;
        const wp::int32 var_39 = 1;
        wp::float64 var_40;
        const wp::int32 var_41 = 1;
        const wp::int32 var_42 = 2;
        wp::float64 var_43;
        const wp::int32 var_44 = 2;
        const wp::int32 var_45 = 3;
        wp::float64 var_46;
        const wp::int32 var_47 = 3;
        const wp::int32 var_48 = 4;
        wp::float64 var_49;
        const wp::int32 var_50 = 5;
        wp::float64 var_51;
        const wp::int32 var_52 = 6;
        wp::float64 var_53;
        const wp::int32 var_54 = 7;
        wp::float64 var_55;
        wp::vec_t<4, wp::float64> var_56;
        const bool var_57 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_58 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_59 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_60 = 0;
        wp::vec_t<4, wp::float64> var_61;
        const wp::int32 var_62 = 0;
        wp::float64 var_63;
        const wp::int32 var_64 = 4;
        const wp::int32 var_65 = 1;
        wp::float64 var_66;
        const wp::int32 var_67 = 5;
        const wp::int32 var_68 = 2;
        wp::float64 var_69;
        const wp::int32 var_70 = 6;
        const wp::int32 var_71 = 3;
        wp::float64 var_72;
        const wp::int32 var_73 = 7;
        const wp::int32 var_74 = 8;
        wp::float64 var_75;
        const wp::int32 var_76 = 9;
        wp::float64 var_77;
        const wp::int32 var_78 = 10;
        wp::float64 var_79;
        const wp::int32 var_80 = 11;
        wp::float64 var_81;
        wp::vec_t<4, wp::float64> var_82;
        const bool var_83 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_84 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_85 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_86 = 0;
        wp::vec_t<4, wp::float64> var_87;
        const wp::int32 var_88 = 0;
        wp::float64 var_89;
        const wp::int32 var_90 = 8;
        const wp::int32 var_91 = 1;
        wp::float64 var_92;
        const wp::int32 var_93 = 9;
        const wp::int32 var_94 = 2;
        wp::float64 var_95;
        const wp::int32 var_96 = 10;
        const wp::int32 var_97 = 3;
        wp::float64 var_98;
        const wp::int32 var_99 = 11;
        const wp::int32 var_100 = 12;
        wp::float64 var_101;
        const wp::int32 var_102 = 13;
        wp::float64 var_103;
        const wp::int32 var_104 = 14;
        wp::float64 var_105;
        const wp::int32 var_106 = 15;
        wp::float64 var_107;
        wp::vec_t<4, wp::float64> var_108;
        const bool var_109 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_110 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_111 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_112 = 0;
        wp::vec_t<4, wp::float64> var_113;
        const wp::int32 var_114 = 0;
        wp::float64 var_115;
        const wp::int32 var_116 = 12;
        const wp::int32 var_117 = 1;
        wp::float64 var_118;
        const wp::int32 var_119 = 13;
        const wp::int32 var_120 = 2;
        wp::float64 var_121;
        const wp::int32 var_122 = 14;
        const wp::int32 var_123 = 3;
        wp::float64 var_124;
        const wp::int32 var_125 = 15;
        const wp::int32 var_126 = 16;
        wp::float64 var_127;
        const wp::int32 var_128 = 17;
        wp::float64 var_129;
        const wp::int32 var_130 = 18;
        wp::float64 var_131;
        const wp::int32 var_132 = 19;
        wp::float64 var_133;
        wp::vec_t<4, wp::float64> var_134;
        const bool var_135 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_136 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_137 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_138 = 0;
        wp::vec_t<4, wp::float64> var_139;
        const wp::int32 var_140 = 0;
        wp::float64 var_141;
        const wp::int32 var_142 = 16;
        const wp::int32 var_143 = 1;
        wp::float64 var_144;
        const wp::int32 var_145 = 17;
        const wp::int32 var_146 = 2;
        wp::float64 var_147;
        const wp::int32 var_148 = 18;
        const wp::int32 var_149 = 3;
        wp::float64 var_150;
        const wp::int32 var_151 = 19;
        const wp::int32 var_152 = 20;
        wp::float64 var_153;
        const wp::int32 var_154 = 21;
        wp::float64 var_155;
        const wp::int32 var_156 = 22;
        wp::float64 var_157;
        const wp::int32 var_158 = 23;
        wp::float64 var_159;
        wp::vec_t<4, wp::float64> var_160;
        const bool var_161 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_162 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_163 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_164 = 0;
        wp::vec_t<4, wp::float64> var_165;
        const wp::int32 var_166 = 0;
        wp::float64 var_167;
        const wp::int32 var_168 = 20;
        const wp::int32 var_169 = 1;
        wp::float64 var_170;
        const wp::int32 var_171 = 21;
        const wp::int32 var_172 = 2;
        wp::float64 var_173;
        const wp::int32 var_174 = 22;
        const wp::int32 var_175 = 3;
        wp::float64 var_176;
        const wp::int32 var_177 = 23;
        const wp::int32 var_178 = 24;
        wp::float64 var_179;
        const wp::int32 var_180 = 25;
        wp::float64 var_181;
        const wp::int32 var_182 = 26;
        wp::float64 var_183;
        const wp::int32 var_184 = 27;
        wp::float64 var_185;
        wp::vec_t<4, wp::float64> var_186;
        const bool var_187 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_188 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_189 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_190 = 0;
        wp::vec_t<4, wp::float64> var_191;
        const wp::int32 var_192 = 0;
        wp::float64 var_193;
        const wp::int32 var_194 = 24;
        const wp::int32 var_195 = 1;
        wp::float64 var_196;
        const wp::int32 var_197 = 25;
        const wp::int32 var_198 = 2;
        wp::float64 var_199;
        const wp::int32 var_200 = 26;
        const wp::int32 var_201 = 3;
        wp::float64 var_202;
        const wp::int32 var_203 = 27;
        const wp::int32 var_204 = 28;
        wp::float64 var_205;
        const wp::int32 var_206 = 29;
        wp::float64 var_207;
        const wp::int32 var_208 = 30;
        wp::float64 var_209;
        const wp::int32 var_210 = 31;
        wp::float64 var_211;
        wp::vec_t<4, wp::float64> var_212;
        const bool var_213 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_214 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_215 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_216 = 0;
        wp::vec_t<4, wp::float64> var_217;
        const wp::int32 var_218 = 0;
        wp::float64 var_219;
        const wp::int32 var_220 = 28;
        const wp::int32 var_221 = 1;
        wp::float64 var_222;
        const wp::int32 var_223 = 29;
        const wp::int32 var_224 = 2;
        wp::float64 var_225;
        const wp::int32 var_226 = 30;
        const wp::int32 var_227 = 3;
        wp::float64 var_228;
        const wp::int32 var_229 = 31;
        const wp::int32 var_230 = 32;
        wp::float64 var_231;
        const wp::int32 var_232 = 33;
        wp::float64 var_233;
        const wp::int32 var_234 = 34;
        wp::float64 var_235;
        const wp::int32 var_236 = 35;
        wp::float64 var_237;
        wp::vec_t<4, wp::float64> var_238;
        const bool var_239 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_240 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_241 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_242 = 0;
        wp::vec_t<4, wp::float64> var_243;
        const wp::int32 var_244 = 0;
        wp::float64 var_245;
        const wp::int32 var_246 = 32;
        const wp::int32 var_247 = 1;
        wp::float64 var_248;
        const wp::int32 var_249 = 33;
        const wp::int32 var_250 = 2;
        wp::float64 var_251;
        const wp::int32 var_252 = 34;
        const wp::int32 var_253 = 3;
        wp::float64 var_254;
        const wp::int32 var_255 = 35;
        const wp::int32 var_256 = 256;
        wp::int32 var_257;
        const wp::int32 var_258 = 0;
        bool var_259;
        //---------
        // forward
        // def sum_information_tiles(matches__targets, matches__pairs, firsts_, lasts_, owners_, live_, partials_):       <L 1>
        // i_ = wp.tid()                                                                          <L 2>
        var_0 = builtin_tid1d();
        // b_ = i_ // 256                                                                         <L 3>
        var_2 = wp::floordiv(var_0, var_1);
        // value_ = vector_()                                                                     <L 4>
        var_3 = wp::vec_t<36, wp::float64>();
        // if live_[owners_[b_]] != 0:                                                            <L 5>
        var_4 = wp::address(var_owners_, var_2);
        var_5 = wp::load(var_4);
        var_6 = wp::address(var_live_, var_5);
        var_9 = wp::load(var_6);
        var_8 = (var_9 != var_7);
        if (var_8) {
            // for j_ in range(firsts_[b_] + i_ % 256, lasts_[b_], 256):                          <L 6>
            var_10 = wp::address(var_firsts_, var_2);
            var_12 = wp::mod(var_0, var_11);
            var_14 = wp::load(var_10);
            var_13 = wp::add(var_14, var_12);
            var_15 = wp::address(var_lasts_, var_2);
            var_18 = wp::load(var_15);
            var_17 = wp::range(var_13, var_18, var_16);
            start_for_0:;
                if (iter_cmp(var_17) == 0) goto end_for_0;
                var_19 = wp::iter_next(var_17);
                // value_ += element_(matches__targets, matches__pairs, j_)                       <L 7>
                var_20 = sum_information_element_0(var_matches__targets, var_matches__pairs, var_19);
                var_21 = wp::add(var_3, var_20);
                wp::assign(var_3, var_21);
                goto start_for_0;
            end_for_0:;
        }
        // part_0 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[0], value_[1], value_[2], value_[3]), preserve_type=True)), 0)       <L 8>
        var_23 = wp::extract(var_3, var_22);
        var_25 = wp::extract(var_3, var_24);
        var_27 = wp::extract(var_3, var_26);
        var_29 = wp::extract(var_3, var_28);
        var_30 = wp::vec_t<4, wp::float64>(var_23, var_25, var_27, var_29);
        var_32 = wp::tile<wp::vec_t<4, wp::float64>>(var_30);
        var_33 = wp::tile_sum(var_32);
        var_35 = wp::tile_extract(var_33, var_34);
        // value_[0] = part_0[0]                                                                  <L 9>
        var_37 = wp::extract(var_35, var_36);
        wp::assign_inplace(var_3, var_38, var_37);
        // value_[1] = part_0[1]                                                                  <L 10>
        var_40 = wp::extract(var_35, var_39);
        wp::assign_inplace(var_3, var_41, var_40);
        // value_[2] = part_0[2]                                                                  <L 11>
        var_43 = wp::extract(var_35, var_42);
        wp::assign_inplace(var_3, var_44, var_43);
        // value_[3] = part_0[3]                                                                  <L 12>
        var_46 = wp::extract(var_35, var_45);
        wp::assign_inplace(var_3, var_47, var_46);
        // part_4 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[4], value_[5], value_[6], value_[7]), preserve_type=True)), 0)       <L 13>
        var_49 = wp::extract(var_3, var_48);
        var_51 = wp::extract(var_3, var_50);
        var_53 = wp::extract(var_3, var_52);
        var_55 = wp::extract(var_3, var_54);
        var_56 = wp::vec_t<4, wp::float64>(var_49, var_51, var_53, var_55);
        var_58 = wp::tile<wp::vec_t<4, wp::float64>>(var_56);
        var_59 = wp::tile_sum(var_58);
        var_61 = wp::tile_extract(var_59, var_60);
        // value_[4] = part_4[0]                                                                  <L 14>
        var_63 = wp::extract(var_61, var_62);
        wp::assign_inplace(var_3, var_64, var_63);
        // value_[5] = part_4[1]                                                                  <L 15>
        var_66 = wp::extract(var_61, var_65);
        wp::assign_inplace(var_3, var_67, var_66);
        // value_[6] = part_4[2]                                                                  <L 16>
        var_69 = wp::extract(var_61, var_68);
        wp::assign_inplace(var_3, var_70, var_69);
        // value_[7] = part_4[3]                                                                  <L 17>
        var_72 = wp::extract(var_61, var_71);
        wp::assign_inplace(var_3, var_73, var_72);
        // part_8 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[8], value_[9], value_[10], value_[11]), preserve_type=True)), 0)       <L 18>
        var_75 = wp::extract(var_3, var_74);
        var_77 = wp::extract(var_3, var_76);
        var_79 = wp::extract(var_3, var_78);
        var_81 = wp::extract(var_3, var_80);
        var_82 = wp::vec_t<4, wp::float64>(var_75, var_77, var_79, var_81);
        var_84 = wp::tile<wp::vec_t<4, wp::float64>>(var_82);
        var_85 = wp::tile_sum(var_84);
        var_87 = wp::tile_extract(var_85, var_86);
        // value_[8] = part_8[0]                                                                  <L 19>
        var_89 = wp::extract(var_87, var_88);
        wp::assign_inplace(var_3, var_90, var_89);
        // value_[9] = part_8[1]                                                                  <L 20>
        var_92 = wp::extract(var_87, var_91);
        wp::assign_inplace(var_3, var_93, var_92);
        // value_[10] = part_8[2]                                                                 <L 21>
        var_95 = wp::extract(var_87, var_94);
        wp::assign_inplace(var_3, var_96, var_95);
        // value_[11] = part_8[3]                                                                 <L 22>
        var_98 = wp::extract(var_87, var_97);
        wp::assign_inplace(var_3, var_99, var_98);
        // part_12 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[12], value_[13], value_[14], value_[15]), preserve_type=True)), 0)       <L 23>
        var_101 = wp::extract(var_3, var_100);
        var_103 = wp::extract(var_3, var_102);
        var_105 = wp::extract(var_3, var_104);
        var_107 = wp::extract(var_3, var_106);
        var_108 = wp::vec_t<4, wp::float64>(var_101, var_103, var_105, var_107);
        var_110 = wp::tile<wp::vec_t<4, wp::float64>>(var_108);
        var_111 = wp::tile_sum(var_110);
        var_113 = wp::tile_extract(var_111, var_112);
        // value_[12] = part_12[0]                                                                <L 24>
        var_115 = wp::extract(var_113, var_114);
        wp::assign_inplace(var_3, var_116, var_115);
        // value_[13] = part_12[1]                                                                <L 25>
        var_118 = wp::extract(var_113, var_117);
        wp::assign_inplace(var_3, var_119, var_118);
        // value_[14] = part_12[2]                                                                <L 26>
        var_121 = wp::extract(var_113, var_120);
        wp::assign_inplace(var_3, var_122, var_121);
        // value_[15] = part_12[3]                                                                <L 27>
        var_124 = wp::extract(var_113, var_123);
        wp::assign_inplace(var_3, var_125, var_124);
        // part_16 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[16], value_[17], value_[18], value_[19]), preserve_type=True)), 0)       <L 28>
        var_127 = wp::extract(var_3, var_126);
        var_129 = wp::extract(var_3, var_128);
        var_131 = wp::extract(var_3, var_130);
        var_133 = wp::extract(var_3, var_132);
        var_134 = wp::vec_t<4, wp::float64>(var_127, var_129, var_131, var_133);
        var_136 = wp::tile<wp::vec_t<4, wp::float64>>(var_134);
        var_137 = wp::tile_sum(var_136);
        var_139 = wp::tile_extract(var_137, var_138);
        // value_[16] = part_16[0]                                                                <L 29>
        var_141 = wp::extract(var_139, var_140);
        wp::assign_inplace(var_3, var_142, var_141);
        // value_[17] = part_16[1]                                                                <L 30>
        var_144 = wp::extract(var_139, var_143);
        wp::assign_inplace(var_3, var_145, var_144);
        // value_[18] = part_16[2]                                                                <L 31>
        var_147 = wp::extract(var_139, var_146);
        wp::assign_inplace(var_3, var_148, var_147);
        // value_[19] = part_16[3]                                                                <L 32>
        var_150 = wp::extract(var_139, var_149);
        wp::assign_inplace(var_3, var_151, var_150);
        // part_20 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[20], value_[21], value_[22], value_[23]), preserve_type=True)), 0)       <L 33>
        var_153 = wp::extract(var_3, var_152);
        var_155 = wp::extract(var_3, var_154);
        var_157 = wp::extract(var_3, var_156);
        var_159 = wp::extract(var_3, var_158);
        var_160 = wp::vec_t<4, wp::float64>(var_153, var_155, var_157, var_159);
        var_162 = wp::tile<wp::vec_t<4, wp::float64>>(var_160);
        var_163 = wp::tile_sum(var_162);
        var_165 = wp::tile_extract(var_163, var_164);
        // value_[20] = part_20[0]                                                                <L 34>
        var_167 = wp::extract(var_165, var_166);
        wp::assign_inplace(var_3, var_168, var_167);
        // value_[21] = part_20[1]                                                                <L 35>
        var_170 = wp::extract(var_165, var_169);
        wp::assign_inplace(var_3, var_171, var_170);
        // value_[22] = part_20[2]                                                                <L 36>
        var_173 = wp::extract(var_165, var_172);
        wp::assign_inplace(var_3, var_174, var_173);
        // value_[23] = part_20[3]                                                                <L 37>
        var_176 = wp::extract(var_165, var_175);
        wp::assign_inplace(var_3, var_177, var_176);
        // part_24 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[24], value_[25], value_[26], value_[27]), preserve_type=True)), 0)       <L 38>
        var_179 = wp::extract(var_3, var_178);
        var_181 = wp::extract(var_3, var_180);
        var_183 = wp::extract(var_3, var_182);
        var_185 = wp::extract(var_3, var_184);
        var_186 = wp::vec_t<4, wp::float64>(var_179, var_181, var_183, var_185);
        var_188 = wp::tile<wp::vec_t<4, wp::float64>>(var_186);
        var_189 = wp::tile_sum(var_188);
        var_191 = wp::tile_extract(var_189, var_190);
        // value_[24] = part_24[0]                                                                <L 39>
        var_193 = wp::extract(var_191, var_192);
        wp::assign_inplace(var_3, var_194, var_193);
        // value_[25] = part_24[1]                                                                <L 40>
        var_196 = wp::extract(var_191, var_195);
        wp::assign_inplace(var_3, var_197, var_196);
        // value_[26] = part_24[2]                                                                <L 41>
        var_199 = wp::extract(var_191, var_198);
        wp::assign_inplace(var_3, var_200, var_199);
        // value_[27] = part_24[3]                                                                <L 42>
        var_202 = wp::extract(var_191, var_201);
        wp::assign_inplace(var_3, var_203, var_202);
        // part_28 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[28], value_[29], value_[30], value_[31]), preserve_type=True)), 0)       <L 43>
        var_205 = wp::extract(var_3, var_204);
        var_207 = wp::extract(var_3, var_206);
        var_209 = wp::extract(var_3, var_208);
        var_211 = wp::extract(var_3, var_210);
        var_212 = wp::vec_t<4, wp::float64>(var_205, var_207, var_209, var_211);
        var_214 = wp::tile<wp::vec_t<4, wp::float64>>(var_212);
        var_215 = wp::tile_sum(var_214);
        var_217 = wp::tile_extract(var_215, var_216);
        // value_[28] = part_28[0]                                                                <L 44>
        var_219 = wp::extract(var_217, var_218);
        wp::assign_inplace(var_3, var_220, var_219);
        // value_[29] = part_28[1]                                                                <L 45>
        var_222 = wp::extract(var_217, var_221);
        wp::assign_inplace(var_3, var_223, var_222);
        // value_[30] = part_28[2]                                                                <L 46>
        var_225 = wp::extract(var_217, var_224);
        wp::assign_inplace(var_3, var_226, var_225);
        // value_[31] = part_28[3]                                                                <L 47>
        var_228 = wp::extract(var_217, var_227);
        wp::assign_inplace(var_3, var_229, var_228);
        // part_32 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[32], value_[33], value_[34], value_[35]), preserve_type=True)), 0)       <L 48>
        var_231 = wp::extract(var_3, var_230);
        var_233 = wp::extract(var_3, var_232);
        var_235 = wp::extract(var_3, var_234);
        var_237 = wp::extract(var_3, var_236);
        var_238 = wp::vec_t<4, wp::float64>(var_231, var_233, var_235, var_237);
        var_240 = wp::tile<wp::vec_t<4, wp::float64>>(var_238);
        var_241 = wp::tile_sum(var_240);
        var_243 = wp::tile_extract(var_241, var_242);
        // value_[32] = part_32[0]                                                                <L 49>
        var_245 = wp::extract(var_243, var_244);
        wp::assign_inplace(var_3, var_246, var_245);
        // value_[33] = part_32[1]                                                                <L 50>
        var_248 = wp::extract(var_243, var_247);
        wp::assign_inplace(var_3, var_249, var_248);
        // value_[34] = part_32[2]                                                                <L 51>
        var_251 = wp::extract(var_243, var_250);
        wp::assign_inplace(var_3, var_252, var_251);
        // value_[35] = part_32[3]                                                                <L 52>
        var_254 = wp::extract(var_243, var_253);
        wp::assign_inplace(var_3, var_255, var_254);
        // if i_ % 256 == 0:                                                                      <L 53>
        var_257 = wp::mod(var_0, var_256);
        var_259 = (var_257 == var_258);
        if (var_259) {
            // partials_[b_] = value_                                                             <L 54>
            wp::array_store(var_partials_, var_2, var_3);
        }
}



extern "C" __global__ void sum_colored_rows_tiles_097490e8_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__jobs__sources__points,
    wp::array_t<wp::int32> var_matches__jobs__sources__first_positions,
    wp::array_t<wp::int32> var_matches__jobs__group_jobs,
    wp::array_t<wp::int32> var_matches__jobs__job_groups,
    wp::array_t<wp::int32> var_matches__jobs__job_sources,
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__targets,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_matches__poses,
    wp::array_t<wp::int32> var_matches__pairs,
    wp::int32 var_matches__weighted,
    wp::array_t<wp::float32> var_matches__weights,
    wp::int32 var_loss__kind,
    wp::float64 var_loss__k,
    wp::float64 var_loss__shape,
    wp::array_t<wp::float32> var_source__intensities,
    wp::array_t<wp::vec_t<3, wp::float32>> var_target__normals,
    wp::array_t<wp::float32> var_target__intensities,
    wp::array_t<wp::vec_t<3, wp::float32>> var_target__gradients,
    wp::float64 var_geometric_share,
    wp::array_t<wp::int32> var_firsts_,
    wp::array_t<wp::int32> var_lasts_,
    wp::array_t<wp::int32> var_owners_,
    wp::array_t<wp::int32> var_live_,
    wp::array_t<wp::vec_t<36, wp::float64>> var_partials_)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        const wp::int32 var_1 = 256;
        wp::int32 var_2;
        wp::vec_t<36, wp::float64> var_3;
        wp::int32* var_4;
        wp::int32 var_5;
        wp::int32* var_6;
        const wp::int32 var_7 = 0;
        bool var_8;
        wp::int32 var_9;
        wp::int32* var_10;
        const wp::int32 var_11 = 256;
        wp::int32 var_12;
        wp::int32 var_13;
        wp::int32 var_14;
        wp::int32* var_15;
        const wp::int32 var_16 = 256;
        wp::range_t var_17;
        wp::int32 var_18;
        wp::int32 var_19;
        wp::vec_t<36, wp::float64> var_20;
        wp::vec_t<36, wp::float64> var_21;
        const wp::int32 var_22 = 0;
        wp::float64 var_23;
        const wp::int32 var_24 = 1;
        wp::float64 var_25;
        const wp::int32 var_26 = 2;
        wp::float64 var_27;
        const wp::int32 var_28 = 3;
        wp::float64 var_29;
        wp::vec_t<4, wp::float64> var_30;
        const bool var_31 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_32 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_33 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_34 = 0;
        wp::vec_t<4, wp::float64> var_35;
        const wp::int32 var_36 = 0;
        wp::float64 var_37;
        const wp::int32 var_38 = 0;
        const wp::int32 var_39 = 1;
        wp::float64 var_40;
        const wp::int32 var_41 = 1;
        const wp::int32 var_42 = 2;
        wp::float64 var_43;
        const wp::int32 var_44 = 2;
        const wp::int32 var_45 = 3;
        wp::float64 var_46;
        const wp::int32 var_47 = 3;
        const wp::int32 var_48 = 4;
        wp::float64 var_49;
        const wp::int32 var_50 = 5;
        wp::float64 var_51;
        const wp::int32 var_52 = 6;
        wp::float64 var_53;
        const wp::int32 var_54 = 7;
        wp::float64 var_55;
        wp::vec_t<4, wp::float64> var_56;
        const bool var_57 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_58 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_59 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_60 = 0;
        wp::vec_t<4, wp::float64> var_61;
        const wp::int32 var_62 = 0;
        wp::float64 var_63;
        const wp::int32 var_64 = 4;
        const wp::int32 var_65 = 1;
        wp::float64 var_66;
        const wp::int32 var_67 = 5;
        const wp::int32 var_68 = 2;
        wp::float64 var_69;
        const wp::int32 var_70 = 6;
        const wp::int32 var_71 = 3;
        wp::float64 var_72;
        const wp::int32 var_73 = 7;
        const wp::int32 var_74 = 8;
        wp::float64 var_75;
        const wp::int32 var_76 = 9;
        wp::float64 var_77;
        const wp::int32 var_78 = 10;
        wp::float64 var_79;
        const wp::int32 var_80 = 11;
        wp::float64 var_81;
        wp::vec_t<4, wp::float64> var_82;
        const bool var_83 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_84 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_85 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_86 = 0;
        wp::vec_t<4, wp::float64> var_87;
        const wp::int32 var_88 = 0;
        wp::float64 var_89;
        const wp::int32 var_90 = 8;
        const wp::int32 var_91 = 1;
        wp::float64 var_92;
        const wp::int32 var_93 = 9;
        const wp::int32 var_94 = 2;
        wp::float64 var_95;
        const wp::int32 var_96 = 10;
        const wp::int32 var_97 = 3;
        wp::float64 var_98;
        const wp::int32 var_99 = 11;
        const wp::int32 var_100 = 12;
        wp::float64 var_101;
        const wp::int32 var_102 = 13;
        wp::float64 var_103;
        const wp::int32 var_104 = 14;
        wp::float64 var_105;
        const wp::int32 var_106 = 15;
        wp::float64 var_107;
        wp::vec_t<4, wp::float64> var_108;
        const bool var_109 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_110 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_111 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_112 = 0;
        wp::vec_t<4, wp::float64> var_113;
        const wp::int32 var_114 = 0;
        wp::float64 var_115;
        const wp::int32 var_116 = 12;
        const wp::int32 var_117 = 1;
        wp::float64 var_118;
        const wp::int32 var_119 = 13;
        const wp::int32 var_120 = 2;
        wp::float64 var_121;
        const wp::int32 var_122 = 14;
        const wp::int32 var_123 = 3;
        wp::float64 var_124;
        const wp::int32 var_125 = 15;
        const wp::int32 var_126 = 16;
        wp::float64 var_127;
        const wp::int32 var_128 = 17;
        wp::float64 var_129;
        const wp::int32 var_130 = 18;
        wp::float64 var_131;
        const wp::int32 var_132 = 19;
        wp::float64 var_133;
        wp::vec_t<4, wp::float64> var_134;
        const bool var_135 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_136 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_137 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_138 = 0;
        wp::vec_t<4, wp::float64> var_139;
        const wp::int32 var_140 = 0;
        wp::float64 var_141;
        const wp::int32 var_142 = 16;
        const wp::int32 var_143 = 1;
        wp::float64 var_144;
        const wp::int32 var_145 = 17;
        const wp::int32 var_146 = 2;
        wp::float64 var_147;
        const wp::int32 var_148 = 18;
        const wp::int32 var_149 = 3;
        wp::float64 var_150;
        const wp::int32 var_151 = 19;
        const wp::int32 var_152 = 20;
        wp::float64 var_153;
        const wp::int32 var_154 = 21;
        wp::float64 var_155;
        const wp::int32 var_156 = 22;
        wp::float64 var_157;
        const wp::int32 var_158 = 23;
        wp::float64 var_159;
        wp::vec_t<4, wp::float64> var_160;
        const bool var_161 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_162 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_163 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_164 = 0;
        wp::vec_t<4, wp::float64> var_165;
        const wp::int32 var_166 = 0;
        wp::float64 var_167;
        const wp::int32 var_168 = 20;
        const wp::int32 var_169 = 1;
        wp::float64 var_170;
        const wp::int32 var_171 = 21;
        const wp::int32 var_172 = 2;
        wp::float64 var_173;
        const wp::int32 var_174 = 22;
        const wp::int32 var_175 = 3;
        wp::float64 var_176;
        const wp::int32 var_177 = 23;
        const wp::int32 var_178 = 24;
        wp::float64 var_179;
        const wp::int32 var_180 = 25;
        wp::float64 var_181;
        const wp::int32 var_182 = 26;
        wp::float64 var_183;
        const wp::int32 var_184 = 27;
        wp::float64 var_185;
        wp::vec_t<4, wp::float64> var_186;
        const bool var_187 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_188 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_189 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_190 = 0;
        wp::vec_t<4, wp::float64> var_191;
        const wp::int32 var_192 = 0;
        wp::float64 var_193;
        const wp::int32 var_194 = 24;
        const wp::int32 var_195 = 1;
        wp::float64 var_196;
        const wp::int32 var_197 = 25;
        const wp::int32 var_198 = 2;
        wp::float64 var_199;
        const wp::int32 var_200 = 26;
        const wp::int32 var_201 = 3;
        wp::float64 var_202;
        const wp::int32 var_203 = 27;
        const wp::int32 var_204 = 28;
        wp::float64 var_205;
        const wp::int32 var_206 = 29;
        wp::float64 var_207;
        const wp::int32 var_208 = 30;
        wp::float64 var_209;
        const wp::int32 var_210 = 31;
        wp::float64 var_211;
        wp::vec_t<4, wp::float64> var_212;
        const bool var_213 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_214 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_215 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_216 = 0;
        wp::vec_t<4, wp::float64> var_217;
        const wp::int32 var_218 = 0;
        wp::float64 var_219;
        const wp::int32 var_220 = 28;
        const wp::int32 var_221 = 1;
        wp::float64 var_222;
        const wp::int32 var_223 = 29;
        const wp::int32 var_224 = 2;
        wp::float64 var_225;
        const wp::int32 var_226 = 30;
        const wp::int32 var_227 = 3;
        wp::float64 var_228;
        const wp::int32 var_229 = 31;
        const wp::int32 var_230 = 32;
        wp::float64 var_231;
        const wp::int32 var_232 = 33;
        wp::float64 var_233;
        const wp::int32 var_234 = 34;
        wp::float64 var_235;
        const wp::int32 var_236 = 35;
        wp::float64 var_237;
        wp::vec_t<4, wp::float64> var_238;
        const bool var_239 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_240 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_241 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_242 = 0;
        wp::vec_t<4, wp::float64> var_243;
        const wp::int32 var_244 = 0;
        wp::float64 var_245;
        const wp::int32 var_246 = 32;
        const wp::int32 var_247 = 1;
        wp::float64 var_248;
        const wp::int32 var_249 = 33;
        const wp::int32 var_250 = 2;
        wp::float64 var_251;
        const wp::int32 var_252 = 34;
        const wp::int32 var_253 = 3;
        wp::float64 var_254;
        const wp::int32 var_255 = 35;
        const wp::int32 var_256 = 256;
        wp::int32 var_257;
        const wp::int32 var_258 = 0;
        bool var_259;
        //---------
        // forward
        // def sum_colored_rows_tiles(matches__jobs__sources__points, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__targets, matches__poses, matches__pairs, matches__weighted, matches__weights, loss__kind, loss__k, loss__shape, source__intensities, target__normals, target__intensities, target__gradients, geometric_share, firsts_, lasts_, owners_, live_, partials_):       <L 1>
        // i_ = wp.tid()                                                                          <L 2>
        var_0 = builtin_tid1d();
        // b_ = i_ // 256                                                                         <L 3>
        var_2 = wp::floordiv(var_0, var_1);
        // value_ = vector_()                                                                     <L 4>
        var_3 = wp::vec_t<36, wp::float64>();
        // if live_[owners_[b_]] != 0:                                                            <L 5>
        var_4 = wp::address(var_owners_, var_2);
        var_5 = wp::load(var_4);
        var_6 = wp::address(var_live_, var_5);
        var_9 = wp::load(var_6);
        var_8 = (var_9 != var_7);
        if (var_8) {
            // for j_ in range(firsts_[b_] + i_ % 256, lasts_[b_], 256):                          <L 6>
            var_10 = wp::address(var_firsts_, var_2);
            var_12 = wp::mod(var_0, var_11);
            var_14 = wp::load(var_10);
            var_13 = wp::add(var_14, var_12);
            var_15 = wp::address(var_lasts_, var_2);
            var_18 = wp::load(var_15);
            var_17 = wp::range(var_13, var_18, var_16);
            start_for_0:;
                if (iter_cmp(var_17) == 0) goto end_for_0;
                var_19 = wp::iter_next(var_17);
                // value_ += element_(matches__jobs__sources__points, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__targets, matches__poses, matches__pairs, matches__weighted, matches__weights, loss__kind, loss__k, loss__shape, source__intensities, target__normals, target__intensities, target__gradients, geometric_share, j_)       <L 7>
                var_20 = sum_colored_rows_element_0(var_matches__jobs__sources__points, var_matches__jobs__sources__first_positions, var_matches__jobs__group_jobs, var_matches__jobs__job_groups, var_matches__jobs__job_sources, var_matches__targets, var_matches__poses, var_matches__pairs, var_matches__weighted, var_matches__weights, var_loss__kind, var_loss__k, var_loss__shape, var_source__intensities, var_target__normals, var_target__intensities, var_target__gradients, var_geometric_share, var_19);
                var_21 = wp::add(var_3, var_20);
                wp::assign(var_3, var_21);
                goto start_for_0;
            end_for_0:;
        }
        // part_0 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[0], value_[1], value_[2], value_[3]), preserve_type=True)), 0)       <L 8>
        var_23 = wp::extract(var_3, var_22);
        var_25 = wp::extract(var_3, var_24);
        var_27 = wp::extract(var_3, var_26);
        var_29 = wp::extract(var_3, var_28);
        var_30 = wp::vec_t<4, wp::float64>(var_23, var_25, var_27, var_29);
        var_32 = wp::tile<wp::vec_t<4, wp::float64>>(var_30);
        var_33 = wp::tile_sum(var_32);
        var_35 = wp::tile_extract(var_33, var_34);
        // value_[0] = part_0[0]                                                                  <L 9>
        var_37 = wp::extract(var_35, var_36);
        wp::assign_inplace(var_3, var_38, var_37);
        // value_[1] = part_0[1]                                                                  <L 10>
        var_40 = wp::extract(var_35, var_39);
        wp::assign_inplace(var_3, var_41, var_40);
        // value_[2] = part_0[2]                                                                  <L 11>
        var_43 = wp::extract(var_35, var_42);
        wp::assign_inplace(var_3, var_44, var_43);
        // value_[3] = part_0[3]                                                                  <L 12>
        var_46 = wp::extract(var_35, var_45);
        wp::assign_inplace(var_3, var_47, var_46);
        // part_4 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[4], value_[5], value_[6], value_[7]), preserve_type=True)), 0)       <L 13>
        var_49 = wp::extract(var_3, var_48);
        var_51 = wp::extract(var_3, var_50);
        var_53 = wp::extract(var_3, var_52);
        var_55 = wp::extract(var_3, var_54);
        var_56 = wp::vec_t<4, wp::float64>(var_49, var_51, var_53, var_55);
        var_58 = wp::tile<wp::vec_t<4, wp::float64>>(var_56);
        var_59 = wp::tile_sum(var_58);
        var_61 = wp::tile_extract(var_59, var_60);
        // value_[4] = part_4[0]                                                                  <L 14>
        var_63 = wp::extract(var_61, var_62);
        wp::assign_inplace(var_3, var_64, var_63);
        // value_[5] = part_4[1]                                                                  <L 15>
        var_66 = wp::extract(var_61, var_65);
        wp::assign_inplace(var_3, var_67, var_66);
        // value_[6] = part_4[2]                                                                  <L 16>
        var_69 = wp::extract(var_61, var_68);
        wp::assign_inplace(var_3, var_70, var_69);
        // value_[7] = part_4[3]                                                                  <L 17>
        var_72 = wp::extract(var_61, var_71);
        wp::assign_inplace(var_3, var_73, var_72);
        // part_8 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[8], value_[9], value_[10], value_[11]), preserve_type=True)), 0)       <L 18>
        var_75 = wp::extract(var_3, var_74);
        var_77 = wp::extract(var_3, var_76);
        var_79 = wp::extract(var_3, var_78);
        var_81 = wp::extract(var_3, var_80);
        var_82 = wp::vec_t<4, wp::float64>(var_75, var_77, var_79, var_81);
        var_84 = wp::tile<wp::vec_t<4, wp::float64>>(var_82);
        var_85 = wp::tile_sum(var_84);
        var_87 = wp::tile_extract(var_85, var_86);
        // value_[8] = part_8[0]                                                                  <L 19>
        var_89 = wp::extract(var_87, var_88);
        wp::assign_inplace(var_3, var_90, var_89);
        // value_[9] = part_8[1]                                                                  <L 20>
        var_92 = wp::extract(var_87, var_91);
        wp::assign_inplace(var_3, var_93, var_92);
        // value_[10] = part_8[2]                                                                 <L 21>
        var_95 = wp::extract(var_87, var_94);
        wp::assign_inplace(var_3, var_96, var_95);
        // value_[11] = part_8[3]                                                                 <L 22>
        var_98 = wp::extract(var_87, var_97);
        wp::assign_inplace(var_3, var_99, var_98);
        // part_12 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[12], value_[13], value_[14], value_[15]), preserve_type=True)), 0)       <L 23>
        var_101 = wp::extract(var_3, var_100);
        var_103 = wp::extract(var_3, var_102);
        var_105 = wp::extract(var_3, var_104);
        var_107 = wp::extract(var_3, var_106);
        var_108 = wp::vec_t<4, wp::float64>(var_101, var_103, var_105, var_107);
        var_110 = wp::tile<wp::vec_t<4, wp::float64>>(var_108);
        var_111 = wp::tile_sum(var_110);
        var_113 = wp::tile_extract(var_111, var_112);
        // value_[12] = part_12[0]                                                                <L 24>
        var_115 = wp::extract(var_113, var_114);
        wp::assign_inplace(var_3, var_116, var_115);
        // value_[13] = part_12[1]                                                                <L 25>
        var_118 = wp::extract(var_113, var_117);
        wp::assign_inplace(var_3, var_119, var_118);
        // value_[14] = part_12[2]                                                                <L 26>
        var_121 = wp::extract(var_113, var_120);
        wp::assign_inplace(var_3, var_122, var_121);
        // value_[15] = part_12[3]                                                                <L 27>
        var_124 = wp::extract(var_113, var_123);
        wp::assign_inplace(var_3, var_125, var_124);
        // part_16 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[16], value_[17], value_[18], value_[19]), preserve_type=True)), 0)       <L 28>
        var_127 = wp::extract(var_3, var_126);
        var_129 = wp::extract(var_3, var_128);
        var_131 = wp::extract(var_3, var_130);
        var_133 = wp::extract(var_3, var_132);
        var_134 = wp::vec_t<4, wp::float64>(var_127, var_129, var_131, var_133);
        var_136 = wp::tile<wp::vec_t<4, wp::float64>>(var_134);
        var_137 = wp::tile_sum(var_136);
        var_139 = wp::tile_extract(var_137, var_138);
        // value_[16] = part_16[0]                                                                <L 29>
        var_141 = wp::extract(var_139, var_140);
        wp::assign_inplace(var_3, var_142, var_141);
        // value_[17] = part_16[1]                                                                <L 30>
        var_144 = wp::extract(var_139, var_143);
        wp::assign_inplace(var_3, var_145, var_144);
        // value_[18] = part_16[2]                                                                <L 31>
        var_147 = wp::extract(var_139, var_146);
        wp::assign_inplace(var_3, var_148, var_147);
        // value_[19] = part_16[3]                                                                <L 32>
        var_150 = wp::extract(var_139, var_149);
        wp::assign_inplace(var_3, var_151, var_150);
        // part_20 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[20], value_[21], value_[22], value_[23]), preserve_type=True)), 0)       <L 33>
        var_153 = wp::extract(var_3, var_152);
        var_155 = wp::extract(var_3, var_154);
        var_157 = wp::extract(var_3, var_156);
        var_159 = wp::extract(var_3, var_158);
        var_160 = wp::vec_t<4, wp::float64>(var_153, var_155, var_157, var_159);
        var_162 = wp::tile<wp::vec_t<4, wp::float64>>(var_160);
        var_163 = wp::tile_sum(var_162);
        var_165 = wp::tile_extract(var_163, var_164);
        // value_[20] = part_20[0]                                                                <L 34>
        var_167 = wp::extract(var_165, var_166);
        wp::assign_inplace(var_3, var_168, var_167);
        // value_[21] = part_20[1]                                                                <L 35>
        var_170 = wp::extract(var_165, var_169);
        wp::assign_inplace(var_3, var_171, var_170);
        // value_[22] = part_20[2]                                                                <L 36>
        var_173 = wp::extract(var_165, var_172);
        wp::assign_inplace(var_3, var_174, var_173);
        // value_[23] = part_20[3]                                                                <L 37>
        var_176 = wp::extract(var_165, var_175);
        wp::assign_inplace(var_3, var_177, var_176);
        // part_24 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[24], value_[25], value_[26], value_[27]), preserve_type=True)), 0)       <L 38>
        var_179 = wp::extract(var_3, var_178);
        var_181 = wp::extract(var_3, var_180);
        var_183 = wp::extract(var_3, var_182);
        var_185 = wp::extract(var_3, var_184);
        var_186 = wp::vec_t<4, wp::float64>(var_179, var_181, var_183, var_185);
        var_188 = wp::tile<wp::vec_t<4, wp::float64>>(var_186);
        var_189 = wp::tile_sum(var_188);
        var_191 = wp::tile_extract(var_189, var_190);
        // value_[24] = part_24[0]                                                                <L 39>
        var_193 = wp::extract(var_191, var_192);
        wp::assign_inplace(var_3, var_194, var_193);
        // value_[25] = part_24[1]                                                                <L 40>
        var_196 = wp::extract(var_191, var_195);
        wp::assign_inplace(var_3, var_197, var_196);
        // value_[26] = part_24[2]                                                                <L 41>
        var_199 = wp::extract(var_191, var_198);
        wp::assign_inplace(var_3, var_200, var_199);
        // value_[27] = part_24[3]                                                                <L 42>
        var_202 = wp::extract(var_191, var_201);
        wp::assign_inplace(var_3, var_203, var_202);
        // part_28 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[28], value_[29], value_[30], value_[31]), preserve_type=True)), 0)       <L 43>
        var_205 = wp::extract(var_3, var_204);
        var_207 = wp::extract(var_3, var_206);
        var_209 = wp::extract(var_3, var_208);
        var_211 = wp::extract(var_3, var_210);
        var_212 = wp::vec_t<4, wp::float64>(var_205, var_207, var_209, var_211);
        var_214 = wp::tile<wp::vec_t<4, wp::float64>>(var_212);
        var_215 = wp::tile_sum(var_214);
        var_217 = wp::tile_extract(var_215, var_216);
        // value_[28] = part_28[0]                                                                <L 44>
        var_219 = wp::extract(var_217, var_218);
        wp::assign_inplace(var_3, var_220, var_219);
        // value_[29] = part_28[1]                                                                <L 45>
        var_222 = wp::extract(var_217, var_221);
        wp::assign_inplace(var_3, var_223, var_222);
        // value_[30] = part_28[2]                                                                <L 46>
        var_225 = wp::extract(var_217, var_224);
        wp::assign_inplace(var_3, var_226, var_225);
        // value_[31] = part_28[3]                                                                <L 47>
        var_228 = wp::extract(var_217, var_227);
        wp::assign_inplace(var_3, var_229, var_228);
        // part_32 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[32], value_[33], value_[34], value_[35]), preserve_type=True)), 0)       <L 48>
        var_231 = wp::extract(var_3, var_230);
        var_233 = wp::extract(var_3, var_232);
        var_235 = wp::extract(var_3, var_234);
        var_237 = wp::extract(var_3, var_236);
        var_238 = wp::vec_t<4, wp::float64>(var_231, var_233, var_235, var_237);
        var_240 = wp::tile<wp::vec_t<4, wp::float64>>(var_238);
        var_241 = wp::tile_sum(var_240);
        var_243 = wp::tile_extract(var_241, var_242);
        // value_[32] = part_32[0]                                                                <L 49>
        var_245 = wp::extract(var_243, var_244);
        wp::assign_inplace(var_3, var_246, var_245);
        // value_[33] = part_32[1]                                                                <L 50>
        var_248 = wp::extract(var_243, var_247);
        wp::assign_inplace(var_3, var_249, var_248);
        // value_[34] = part_32[2]                                                                <L 51>
        var_251 = wp::extract(var_243, var_250);
        wp::assign_inplace(var_3, var_252, var_251);
        // value_[35] = part_32[3]                                                                <L 52>
        var_254 = wp::extract(var_243, var_253);
        wp::assign_inplace(var_3, var_255, var_254);
        // if i_ % 256 == 0:                                                                      <L 53>
        var_257 = wp::mod(var_0, var_256);
        var_259 = (var_257 == var_258);
        if (var_259) {
            // partials_[b_] = value_                                                             <L 54>
            wp::array_store(var_partials_, var_2, var_3);
        }
}



extern "C" __global__ void sum_point_rows_fold_tiles_2878353a_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_starts_,
    wp::array_t<wp::int32> var_live_,
    wp::array_t<wp::vec_t<36, wp::float64>> var_partials_,
    wp::array_t<wp::vec_t<36, wp::float64>> var_out_)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        const wp::int32 var_1 = 256;
        wp::int32 var_2;
        wp::vec_t<36, wp::float64> var_3;
        wp::int32* var_4;
        const wp::int32 var_5 = 256;
        wp::int32 var_6;
        wp::int32 var_7;
        wp::int32 var_8;
        const wp::int32 var_9 = 1;
        wp::int32 var_10;
        wp::int32* var_11;
        const wp::int32 var_12 = 256;
        wp::range_t var_13;
        wp::int32 var_14;
        wp::int32 var_15;
        wp::vec_t<36, wp::float64>* var_16;
        wp::vec_t<36, wp::float64> var_17;
        wp::vec_t<36, wp::float64> var_18;
        const wp::int32 var_19 = 0;
        wp::float64 var_20;
        const wp::int32 var_21 = 1;
        wp::float64 var_22;
        const wp::int32 var_23 = 2;
        wp::float64 var_24;
        const wp::int32 var_25 = 3;
        wp::float64 var_26;
        wp::vec_t<4, wp::float64> var_27;
        const bool var_28 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_29 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_30 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_31 = 0;
        wp::vec_t<4, wp::float64> var_32;
        const wp::int32 var_33 = 0;
        wp::float64 var_34;
        const wp::int32 var_35 = 0;
        const wp::int32 var_36 = 1;
        wp::float64 var_37;
        const wp::int32 var_38 = 1;
        const wp::int32 var_39 = 2;
        wp::float64 var_40;
        const wp::int32 var_41 = 2;
        const wp::int32 var_42 = 3;
        wp::float64 var_43;
        const wp::int32 var_44 = 3;
        const wp::int32 var_45 = 4;
        wp::float64 var_46;
        const wp::int32 var_47 = 5;
        wp::float64 var_48;
        const wp::int32 var_49 = 6;
        wp::float64 var_50;
        const wp::int32 var_51 = 7;
        wp::float64 var_52;
        wp::vec_t<4, wp::float64> var_53;
        const bool var_54 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_55 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_56 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_57 = 0;
        wp::vec_t<4, wp::float64> var_58;
        const wp::int32 var_59 = 0;
        wp::float64 var_60;
        const wp::int32 var_61 = 4;
        const wp::int32 var_62 = 1;
        wp::float64 var_63;
        const wp::int32 var_64 = 5;
        const wp::int32 var_65 = 2;
        wp::float64 var_66;
        const wp::int32 var_67 = 6;
        const wp::int32 var_68 = 3;
        wp::float64 var_69;
        const wp::int32 var_70 = 7;
        const wp::int32 var_71 = 8;
        wp::float64 var_72;
        const wp::int32 var_73 = 9;
        wp::float64 var_74;
        const wp::int32 var_75 = 10;
        wp::float64 var_76;
        const wp::int32 var_77 = 11;
        wp::float64 var_78;
        wp::vec_t<4, wp::float64> var_79;
        const bool var_80 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_81 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_82 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_83 = 0;
        wp::vec_t<4, wp::float64> var_84;
        const wp::int32 var_85 = 0;
        wp::float64 var_86;
        const wp::int32 var_87 = 8;
        const wp::int32 var_88 = 1;
        wp::float64 var_89;
        const wp::int32 var_90 = 9;
        const wp::int32 var_91 = 2;
        wp::float64 var_92;
        const wp::int32 var_93 = 10;
        const wp::int32 var_94 = 3;
        wp::float64 var_95;
        const wp::int32 var_96 = 11;
        const wp::int32 var_97 = 12;
        wp::float64 var_98;
        const wp::int32 var_99 = 13;
        wp::float64 var_100;
        const wp::int32 var_101 = 14;
        wp::float64 var_102;
        const wp::int32 var_103 = 15;
        wp::float64 var_104;
        wp::vec_t<4, wp::float64> var_105;
        const bool var_106 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_107 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_108 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_109 = 0;
        wp::vec_t<4, wp::float64> var_110;
        const wp::int32 var_111 = 0;
        wp::float64 var_112;
        const wp::int32 var_113 = 12;
        const wp::int32 var_114 = 1;
        wp::float64 var_115;
        const wp::int32 var_116 = 13;
        const wp::int32 var_117 = 2;
        wp::float64 var_118;
        const wp::int32 var_119 = 14;
        const wp::int32 var_120 = 3;
        wp::float64 var_121;
        const wp::int32 var_122 = 15;
        const wp::int32 var_123 = 16;
        wp::float64 var_124;
        const wp::int32 var_125 = 17;
        wp::float64 var_126;
        const wp::int32 var_127 = 18;
        wp::float64 var_128;
        const wp::int32 var_129 = 19;
        wp::float64 var_130;
        wp::vec_t<4, wp::float64> var_131;
        const bool var_132 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_133 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_134 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_135 = 0;
        wp::vec_t<4, wp::float64> var_136;
        const wp::int32 var_137 = 0;
        wp::float64 var_138;
        const wp::int32 var_139 = 16;
        const wp::int32 var_140 = 1;
        wp::float64 var_141;
        const wp::int32 var_142 = 17;
        const wp::int32 var_143 = 2;
        wp::float64 var_144;
        const wp::int32 var_145 = 18;
        const wp::int32 var_146 = 3;
        wp::float64 var_147;
        const wp::int32 var_148 = 19;
        const wp::int32 var_149 = 20;
        wp::float64 var_150;
        const wp::int32 var_151 = 21;
        wp::float64 var_152;
        const wp::int32 var_153 = 22;
        wp::float64 var_154;
        const wp::int32 var_155 = 23;
        wp::float64 var_156;
        wp::vec_t<4, wp::float64> var_157;
        const bool var_158 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_159 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_160 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_161 = 0;
        wp::vec_t<4, wp::float64> var_162;
        const wp::int32 var_163 = 0;
        wp::float64 var_164;
        const wp::int32 var_165 = 20;
        const wp::int32 var_166 = 1;
        wp::float64 var_167;
        const wp::int32 var_168 = 21;
        const wp::int32 var_169 = 2;
        wp::float64 var_170;
        const wp::int32 var_171 = 22;
        const wp::int32 var_172 = 3;
        wp::float64 var_173;
        const wp::int32 var_174 = 23;
        const wp::int32 var_175 = 24;
        wp::float64 var_176;
        const wp::int32 var_177 = 25;
        wp::float64 var_178;
        const wp::int32 var_179 = 26;
        wp::float64 var_180;
        const wp::int32 var_181 = 27;
        wp::float64 var_182;
        wp::vec_t<4, wp::float64> var_183;
        const bool var_184 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_185 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_186 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_187 = 0;
        wp::vec_t<4, wp::float64> var_188;
        const wp::int32 var_189 = 0;
        wp::float64 var_190;
        const wp::int32 var_191 = 24;
        const wp::int32 var_192 = 1;
        wp::float64 var_193;
        const wp::int32 var_194 = 25;
        const wp::int32 var_195 = 2;
        wp::float64 var_196;
        const wp::int32 var_197 = 26;
        const wp::int32 var_198 = 3;
        wp::float64 var_199;
        const wp::int32 var_200 = 27;
        const wp::int32 var_201 = 28;
        wp::float64 var_202;
        const wp::int32 var_203 = 29;
        wp::float64 var_204;
        const wp::int32 var_205 = 30;
        wp::float64 var_206;
        const wp::int32 var_207 = 31;
        wp::float64 var_208;
        wp::vec_t<4, wp::float64> var_209;
        const bool var_210 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_211 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_212 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_213 = 0;
        wp::vec_t<4, wp::float64> var_214;
        const wp::int32 var_215 = 0;
        wp::float64 var_216;
        const wp::int32 var_217 = 28;
        const wp::int32 var_218 = 1;
        wp::float64 var_219;
        const wp::int32 var_220 = 29;
        const wp::int32 var_221 = 2;
        wp::float64 var_222;
        const wp::int32 var_223 = 30;
        const wp::int32 var_224 = 3;
        wp::float64 var_225;
        const wp::int32 var_226 = 31;
        const wp::int32 var_227 = 32;
        wp::float64 var_228;
        const wp::int32 var_229 = 33;
        wp::float64 var_230;
        const wp::int32 var_231 = 34;
        wp::float64 var_232;
        const wp::int32 var_233 = 35;
        wp::float64 var_234;
        wp::vec_t<4, wp::float64> var_235;
        const bool var_236 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_237 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_238 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_239 = 0;
        wp::vec_t<4, wp::float64> var_240;
        const wp::int32 var_241 = 0;
        wp::float64 var_242;
        const wp::int32 var_243 = 32;
        const wp::int32 var_244 = 1;
        wp::float64 var_245;
        const wp::int32 var_246 = 33;
        const wp::int32 var_247 = 2;
        wp::float64 var_248;
        const wp::int32 var_249 = 34;
        const wp::int32 var_250 = 3;
        wp::float64 var_251;
        const wp::int32 var_252 = 35;
        const wp::int32 var_253 = 256;
        wp::int32 var_254;
        const wp::int32 var_255 = 0;
        bool var_256;
        //---------
        // forward
        // def sum_point_rows_fold_tiles(starts_, live_, partials_, out_):                        <L 1>
        // i_ = wp.tid()                                                                          <L 2>
        var_0 = builtin_tid1d();
        // s_ = i_ // 256                                                                         <L 3>
        var_2 = wp::floordiv(var_0, var_1);
        // value_ = vector_()                                                                     <L 4>
        var_3 = wp::vec_t<36, wp::float64>();
        // for j_ in range(starts_[s_] + i_ % 256, starts_[s_ + 1], 256):                         <L 5>
        var_4 = wp::address(var_starts_, var_2);
        var_6 = wp::mod(var_0, var_5);
        var_8 = wp::load(var_4);
        var_7 = wp::add(var_8, var_6);
        var_10 = wp::add(var_2, var_9);
        var_11 = wp::address(var_starts_, var_10);
        var_14 = wp::load(var_11);
        var_13 = wp::range(var_7, var_14, var_12);
        start_for_0:;
            if (iter_cmp(var_13) == 0) goto end_for_0;
            var_15 = wp::iter_next(var_13);
            // value_ += partials_[j_]                                                            <L 6>
            var_16 = wp::address(var_partials_, var_15);
            var_18 = wp::load(var_16);
            var_17 = wp::add(var_3, var_18);
            wp::assign(var_3, var_17);
            goto start_for_0;
        end_for_0:;
        // part_0 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[0], value_[1], value_[2], value_[3]), preserve_type=True)), 0)       <L 7>
        var_20 = wp::extract(var_3, var_19);
        var_22 = wp::extract(var_3, var_21);
        var_24 = wp::extract(var_3, var_23);
        var_26 = wp::extract(var_3, var_25);
        var_27 = wp::vec_t<4, wp::float64>(var_20, var_22, var_24, var_26);
        var_29 = wp::tile<wp::vec_t<4, wp::float64>>(var_27);
        var_30 = wp::tile_sum(var_29);
        var_32 = wp::tile_extract(var_30, var_31);
        // value_[0] = part_0[0]                                                                  <L 8>
        var_34 = wp::extract(var_32, var_33);
        wp::assign_inplace(var_3, var_35, var_34);
        // value_[1] = part_0[1]                                                                  <L 9>
        var_37 = wp::extract(var_32, var_36);
        wp::assign_inplace(var_3, var_38, var_37);
        // value_[2] = part_0[2]                                                                  <L 10>
        var_40 = wp::extract(var_32, var_39);
        wp::assign_inplace(var_3, var_41, var_40);
        // value_[3] = part_0[3]                                                                  <L 11>
        var_43 = wp::extract(var_32, var_42);
        wp::assign_inplace(var_3, var_44, var_43);
        // part_4 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[4], value_[5], value_[6], value_[7]), preserve_type=True)), 0)       <L 12>
        var_46 = wp::extract(var_3, var_45);
        var_48 = wp::extract(var_3, var_47);
        var_50 = wp::extract(var_3, var_49);
        var_52 = wp::extract(var_3, var_51);
        var_53 = wp::vec_t<4, wp::float64>(var_46, var_48, var_50, var_52);
        var_55 = wp::tile<wp::vec_t<4, wp::float64>>(var_53);
        var_56 = wp::tile_sum(var_55);
        var_58 = wp::tile_extract(var_56, var_57);
        // value_[4] = part_4[0]                                                                  <L 13>
        var_60 = wp::extract(var_58, var_59);
        wp::assign_inplace(var_3, var_61, var_60);
        // value_[5] = part_4[1]                                                                  <L 14>
        var_63 = wp::extract(var_58, var_62);
        wp::assign_inplace(var_3, var_64, var_63);
        // value_[6] = part_4[2]                                                                  <L 15>
        var_66 = wp::extract(var_58, var_65);
        wp::assign_inplace(var_3, var_67, var_66);
        // value_[7] = part_4[3]                                                                  <L 16>
        var_69 = wp::extract(var_58, var_68);
        wp::assign_inplace(var_3, var_70, var_69);
        // part_8 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[8], value_[9], value_[10], value_[11]), preserve_type=True)), 0)       <L 17>
        var_72 = wp::extract(var_3, var_71);
        var_74 = wp::extract(var_3, var_73);
        var_76 = wp::extract(var_3, var_75);
        var_78 = wp::extract(var_3, var_77);
        var_79 = wp::vec_t<4, wp::float64>(var_72, var_74, var_76, var_78);
        var_81 = wp::tile<wp::vec_t<4, wp::float64>>(var_79);
        var_82 = wp::tile_sum(var_81);
        var_84 = wp::tile_extract(var_82, var_83);
        // value_[8] = part_8[0]                                                                  <L 18>
        var_86 = wp::extract(var_84, var_85);
        wp::assign_inplace(var_3, var_87, var_86);
        // value_[9] = part_8[1]                                                                  <L 19>
        var_89 = wp::extract(var_84, var_88);
        wp::assign_inplace(var_3, var_90, var_89);
        // value_[10] = part_8[2]                                                                 <L 20>
        var_92 = wp::extract(var_84, var_91);
        wp::assign_inplace(var_3, var_93, var_92);
        // value_[11] = part_8[3]                                                                 <L 21>
        var_95 = wp::extract(var_84, var_94);
        wp::assign_inplace(var_3, var_96, var_95);
        // part_12 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[12], value_[13], value_[14], value_[15]), preserve_type=True)), 0)       <L 22>
        var_98 = wp::extract(var_3, var_97);
        var_100 = wp::extract(var_3, var_99);
        var_102 = wp::extract(var_3, var_101);
        var_104 = wp::extract(var_3, var_103);
        var_105 = wp::vec_t<4, wp::float64>(var_98, var_100, var_102, var_104);
        var_107 = wp::tile<wp::vec_t<4, wp::float64>>(var_105);
        var_108 = wp::tile_sum(var_107);
        var_110 = wp::tile_extract(var_108, var_109);
        // value_[12] = part_12[0]                                                                <L 23>
        var_112 = wp::extract(var_110, var_111);
        wp::assign_inplace(var_3, var_113, var_112);
        // value_[13] = part_12[1]                                                                <L 24>
        var_115 = wp::extract(var_110, var_114);
        wp::assign_inplace(var_3, var_116, var_115);
        // value_[14] = part_12[2]                                                                <L 25>
        var_118 = wp::extract(var_110, var_117);
        wp::assign_inplace(var_3, var_119, var_118);
        // value_[15] = part_12[3]                                                                <L 26>
        var_121 = wp::extract(var_110, var_120);
        wp::assign_inplace(var_3, var_122, var_121);
        // part_16 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[16], value_[17], value_[18], value_[19]), preserve_type=True)), 0)       <L 27>
        var_124 = wp::extract(var_3, var_123);
        var_126 = wp::extract(var_3, var_125);
        var_128 = wp::extract(var_3, var_127);
        var_130 = wp::extract(var_3, var_129);
        var_131 = wp::vec_t<4, wp::float64>(var_124, var_126, var_128, var_130);
        var_133 = wp::tile<wp::vec_t<4, wp::float64>>(var_131);
        var_134 = wp::tile_sum(var_133);
        var_136 = wp::tile_extract(var_134, var_135);
        // value_[16] = part_16[0]                                                                <L 28>
        var_138 = wp::extract(var_136, var_137);
        wp::assign_inplace(var_3, var_139, var_138);
        // value_[17] = part_16[1]                                                                <L 29>
        var_141 = wp::extract(var_136, var_140);
        wp::assign_inplace(var_3, var_142, var_141);
        // value_[18] = part_16[2]                                                                <L 30>
        var_144 = wp::extract(var_136, var_143);
        wp::assign_inplace(var_3, var_145, var_144);
        // value_[19] = part_16[3]                                                                <L 31>
        var_147 = wp::extract(var_136, var_146);
        wp::assign_inplace(var_3, var_148, var_147);
        // part_20 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[20], value_[21], value_[22], value_[23]), preserve_type=True)), 0)       <L 32>
        var_150 = wp::extract(var_3, var_149);
        var_152 = wp::extract(var_3, var_151);
        var_154 = wp::extract(var_3, var_153);
        var_156 = wp::extract(var_3, var_155);
        var_157 = wp::vec_t<4, wp::float64>(var_150, var_152, var_154, var_156);
        var_159 = wp::tile<wp::vec_t<4, wp::float64>>(var_157);
        var_160 = wp::tile_sum(var_159);
        var_162 = wp::tile_extract(var_160, var_161);
        // value_[20] = part_20[0]                                                                <L 33>
        var_164 = wp::extract(var_162, var_163);
        wp::assign_inplace(var_3, var_165, var_164);
        // value_[21] = part_20[1]                                                                <L 34>
        var_167 = wp::extract(var_162, var_166);
        wp::assign_inplace(var_3, var_168, var_167);
        // value_[22] = part_20[2]                                                                <L 35>
        var_170 = wp::extract(var_162, var_169);
        wp::assign_inplace(var_3, var_171, var_170);
        // value_[23] = part_20[3]                                                                <L 36>
        var_173 = wp::extract(var_162, var_172);
        wp::assign_inplace(var_3, var_174, var_173);
        // part_24 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[24], value_[25], value_[26], value_[27]), preserve_type=True)), 0)       <L 37>
        var_176 = wp::extract(var_3, var_175);
        var_178 = wp::extract(var_3, var_177);
        var_180 = wp::extract(var_3, var_179);
        var_182 = wp::extract(var_3, var_181);
        var_183 = wp::vec_t<4, wp::float64>(var_176, var_178, var_180, var_182);
        var_185 = wp::tile<wp::vec_t<4, wp::float64>>(var_183);
        var_186 = wp::tile_sum(var_185);
        var_188 = wp::tile_extract(var_186, var_187);
        // value_[24] = part_24[0]                                                                <L 38>
        var_190 = wp::extract(var_188, var_189);
        wp::assign_inplace(var_3, var_191, var_190);
        // value_[25] = part_24[1]                                                                <L 39>
        var_193 = wp::extract(var_188, var_192);
        wp::assign_inplace(var_3, var_194, var_193);
        // value_[26] = part_24[2]                                                                <L 40>
        var_196 = wp::extract(var_188, var_195);
        wp::assign_inplace(var_3, var_197, var_196);
        // value_[27] = part_24[3]                                                                <L 41>
        var_199 = wp::extract(var_188, var_198);
        wp::assign_inplace(var_3, var_200, var_199);
        // part_28 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[28], value_[29], value_[30], value_[31]), preserve_type=True)), 0)       <L 42>
        var_202 = wp::extract(var_3, var_201);
        var_204 = wp::extract(var_3, var_203);
        var_206 = wp::extract(var_3, var_205);
        var_208 = wp::extract(var_3, var_207);
        var_209 = wp::vec_t<4, wp::float64>(var_202, var_204, var_206, var_208);
        var_211 = wp::tile<wp::vec_t<4, wp::float64>>(var_209);
        var_212 = wp::tile_sum(var_211);
        var_214 = wp::tile_extract(var_212, var_213);
        // value_[28] = part_28[0]                                                                <L 43>
        var_216 = wp::extract(var_214, var_215);
        wp::assign_inplace(var_3, var_217, var_216);
        // value_[29] = part_28[1]                                                                <L 44>
        var_219 = wp::extract(var_214, var_218);
        wp::assign_inplace(var_3, var_220, var_219);
        // value_[30] = part_28[2]                                                                <L 45>
        var_222 = wp::extract(var_214, var_221);
        wp::assign_inplace(var_3, var_223, var_222);
        // value_[31] = part_28[3]                                                                <L 46>
        var_225 = wp::extract(var_214, var_224);
        wp::assign_inplace(var_3, var_226, var_225);
        // part_32 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[32], value_[33], value_[34], value_[35]), preserve_type=True)), 0)       <L 47>
        var_228 = wp::extract(var_3, var_227);
        var_230 = wp::extract(var_3, var_229);
        var_232 = wp::extract(var_3, var_231);
        var_234 = wp::extract(var_3, var_233);
        var_235 = wp::vec_t<4, wp::float64>(var_228, var_230, var_232, var_234);
        var_237 = wp::tile<wp::vec_t<4, wp::float64>>(var_235);
        var_238 = wp::tile_sum(var_237);
        var_240 = wp::tile_extract(var_238, var_239);
        // value_[32] = part_32[0]                                                                <L 48>
        var_242 = wp::extract(var_240, var_241);
        wp::assign_inplace(var_3, var_243, var_242);
        // value_[33] = part_32[1]                                                                <L 49>
        var_245 = wp::extract(var_240, var_244);
        wp::assign_inplace(var_3, var_246, var_245);
        // value_[34] = part_32[2]                                                                <L 50>
        var_248 = wp::extract(var_240, var_247);
        wp::assign_inplace(var_3, var_249, var_248);
        // value_[35] = part_32[3]                                                                <L 51>
        var_251 = wp::extract(var_240, var_250);
        wp::assign_inplace(var_3, var_252, var_251);
        // if i_ % 256 == 0:                                                                      <L 52>
        var_254 = wp::mod(var_0, var_253);
        var_256 = (var_254 == var_255);
        if (var_256) {
            // out_[s_] = value_                                                                  <L 53>
            wp::array_store(var_out_, var_2, var_3);
        }
}



extern "C" __global__ void sum_doppler_rows_tiles_2f8ecd04_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__jobs__sources__points,
    wp::array_t<wp::int32> var_matches__jobs__sources__first_positions,
    wp::array_t<wp::int32> var_matches__jobs__group_jobs,
    wp::array_t<wp::int32> var_matches__jobs__job_groups,
    wp::array_t<wp::int32> var_matches__jobs__job_sources,
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__targets,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_matches__poses,
    wp::array_t<wp::int32> var_matches__pairs,
    wp::int32 var_matches__weighted,
    wp::array_t<wp::float32> var_matches__weights,
    wp::int32 var_loss__kind,
    wp::float64 var_loss__k,
    wp::float64 var_loss__shape,
    wp::array_t<wp::float32> var_source__dopplers,
    wp::array_t<wp::vec_t<3, wp::float32>> var_source__directions,
    wp::array_t<wp::vec_t<3, wp::float32>> var_target__normals,
    wp::array_t<wp::vec_t<6, wp::float64>> var_velocities,
    wp::array_t<wp::int32> var_iterations,
    wp::vec_t<3, wp::float64> var_rule__sensor,
    wp::float64 var_rule__period,
    wp::float64 var_rule__share,
    wp::int32 var_rule__loss__kind,
    wp::float64 var_rule__loss__k,
    wp::float64 var_rule__loss__shape,
    wp::int32 var_rule__geometric_from,
    wp::int32 var_rule__doppler_from,
    wp::int32 var_rule__reject_from,
    wp::float64 var_rule__threshold,
    wp::array_t<wp::int32> var_firsts_,
    wp::array_t<wp::int32> var_lasts_,
    wp::array_t<wp::int32> var_owners_,
    wp::array_t<wp::int32> var_live_,
    wp::array_t<wp::vec_t<36, wp::float64>> var_partials_)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        const wp::int32 var_1 = 256;
        wp::int32 var_2;
        wp::vec_t<36, wp::float64> var_3;
        wp::int32* var_4;
        wp::int32 var_5;
        wp::int32* var_6;
        const wp::int32 var_7 = 0;
        bool var_8;
        wp::int32 var_9;
        wp::int32* var_10;
        const wp::int32 var_11 = 256;
        wp::int32 var_12;
        wp::int32 var_13;
        wp::int32 var_14;
        wp::int32* var_15;
        const wp::int32 var_16 = 256;
        wp::range_t var_17;
        wp::int32 var_18;
        wp::int32 var_19;
        wp::vec_t<36, wp::float64> var_20;
        wp::vec_t<36, wp::float64> var_21;
        const wp::int32 var_22 = 0;
        wp::float64 var_23;
        const wp::int32 var_24 = 1;
        wp::float64 var_25;
        const wp::int32 var_26 = 2;
        wp::float64 var_27;
        const wp::int32 var_28 = 3;
        wp::float64 var_29;
        wp::vec_t<4, wp::float64> var_30;
        const bool var_31 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_32 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_33 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_34 = 0;
        wp::vec_t<4, wp::float64> var_35;
        const wp::int32 var_36 = 0;
        wp::float64 var_37;
        const wp::int32 var_38 = 0;
        const wp::int32 var_39 = 1;
        wp::float64 var_40;
        const wp::int32 var_41 = 1;
        const wp::int32 var_42 = 2;
        wp::float64 var_43;
        const wp::int32 var_44 = 2;
        const wp::int32 var_45 = 3;
        wp::float64 var_46;
        const wp::int32 var_47 = 3;
        const wp::int32 var_48 = 4;
        wp::float64 var_49;
        const wp::int32 var_50 = 5;
        wp::float64 var_51;
        const wp::int32 var_52 = 6;
        wp::float64 var_53;
        const wp::int32 var_54 = 7;
        wp::float64 var_55;
        wp::vec_t<4, wp::float64> var_56;
        const bool var_57 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_58 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_59 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_60 = 0;
        wp::vec_t<4, wp::float64> var_61;
        const wp::int32 var_62 = 0;
        wp::float64 var_63;
        const wp::int32 var_64 = 4;
        const wp::int32 var_65 = 1;
        wp::float64 var_66;
        const wp::int32 var_67 = 5;
        const wp::int32 var_68 = 2;
        wp::float64 var_69;
        const wp::int32 var_70 = 6;
        const wp::int32 var_71 = 3;
        wp::float64 var_72;
        const wp::int32 var_73 = 7;
        const wp::int32 var_74 = 8;
        wp::float64 var_75;
        const wp::int32 var_76 = 9;
        wp::float64 var_77;
        const wp::int32 var_78 = 10;
        wp::float64 var_79;
        const wp::int32 var_80 = 11;
        wp::float64 var_81;
        wp::vec_t<4, wp::float64> var_82;
        const bool var_83 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_84 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_85 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_86 = 0;
        wp::vec_t<4, wp::float64> var_87;
        const wp::int32 var_88 = 0;
        wp::float64 var_89;
        const wp::int32 var_90 = 8;
        const wp::int32 var_91 = 1;
        wp::float64 var_92;
        const wp::int32 var_93 = 9;
        const wp::int32 var_94 = 2;
        wp::float64 var_95;
        const wp::int32 var_96 = 10;
        const wp::int32 var_97 = 3;
        wp::float64 var_98;
        const wp::int32 var_99 = 11;
        const wp::int32 var_100 = 12;
        wp::float64 var_101;
        const wp::int32 var_102 = 13;
        wp::float64 var_103;
        const wp::int32 var_104 = 14;
        wp::float64 var_105;
        const wp::int32 var_106 = 15;
        wp::float64 var_107;
        wp::vec_t<4, wp::float64> var_108;
        const bool var_109 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_110 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_111 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_112 = 0;
        wp::vec_t<4, wp::float64> var_113;
        const wp::int32 var_114 = 0;
        wp::float64 var_115;
        const wp::int32 var_116 = 12;
        const wp::int32 var_117 = 1;
        wp::float64 var_118;
        const wp::int32 var_119 = 13;
        const wp::int32 var_120 = 2;
        wp::float64 var_121;
        const wp::int32 var_122 = 14;
        const wp::int32 var_123 = 3;
        wp::float64 var_124;
        const wp::int32 var_125 = 15;
        const wp::int32 var_126 = 16;
        wp::float64 var_127;
        const wp::int32 var_128 = 17;
        wp::float64 var_129;
        const wp::int32 var_130 = 18;
        wp::float64 var_131;
        const wp::int32 var_132 = 19;
        wp::float64 var_133;
        wp::vec_t<4, wp::float64> var_134;
        const bool var_135 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_136 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_137 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_138 = 0;
        wp::vec_t<4, wp::float64> var_139;
        const wp::int32 var_140 = 0;
        wp::float64 var_141;
        const wp::int32 var_142 = 16;
        const wp::int32 var_143 = 1;
        wp::float64 var_144;
        const wp::int32 var_145 = 17;
        const wp::int32 var_146 = 2;
        wp::float64 var_147;
        const wp::int32 var_148 = 18;
        const wp::int32 var_149 = 3;
        wp::float64 var_150;
        const wp::int32 var_151 = 19;
        const wp::int32 var_152 = 20;
        wp::float64 var_153;
        const wp::int32 var_154 = 21;
        wp::float64 var_155;
        const wp::int32 var_156 = 22;
        wp::float64 var_157;
        const wp::int32 var_158 = 23;
        wp::float64 var_159;
        wp::vec_t<4, wp::float64> var_160;
        const bool var_161 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_162 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_163 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_164 = 0;
        wp::vec_t<4, wp::float64> var_165;
        const wp::int32 var_166 = 0;
        wp::float64 var_167;
        const wp::int32 var_168 = 20;
        const wp::int32 var_169 = 1;
        wp::float64 var_170;
        const wp::int32 var_171 = 21;
        const wp::int32 var_172 = 2;
        wp::float64 var_173;
        const wp::int32 var_174 = 22;
        const wp::int32 var_175 = 3;
        wp::float64 var_176;
        const wp::int32 var_177 = 23;
        const wp::int32 var_178 = 24;
        wp::float64 var_179;
        const wp::int32 var_180 = 25;
        wp::float64 var_181;
        const wp::int32 var_182 = 26;
        wp::float64 var_183;
        const wp::int32 var_184 = 27;
        wp::float64 var_185;
        wp::vec_t<4, wp::float64> var_186;
        const bool var_187 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_188 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_189 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_190 = 0;
        wp::vec_t<4, wp::float64> var_191;
        const wp::int32 var_192 = 0;
        wp::float64 var_193;
        const wp::int32 var_194 = 24;
        const wp::int32 var_195 = 1;
        wp::float64 var_196;
        const wp::int32 var_197 = 25;
        const wp::int32 var_198 = 2;
        wp::float64 var_199;
        const wp::int32 var_200 = 26;
        const wp::int32 var_201 = 3;
        wp::float64 var_202;
        const wp::int32 var_203 = 27;
        const wp::int32 var_204 = 28;
        wp::float64 var_205;
        const wp::int32 var_206 = 29;
        wp::float64 var_207;
        const wp::int32 var_208 = 30;
        wp::float64 var_209;
        const wp::int32 var_210 = 31;
        wp::float64 var_211;
        wp::vec_t<4, wp::float64> var_212;
        const bool var_213 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_214 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_215 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_216 = 0;
        wp::vec_t<4, wp::float64> var_217;
        const wp::int32 var_218 = 0;
        wp::float64 var_219;
        const wp::int32 var_220 = 28;
        const wp::int32 var_221 = 1;
        wp::float64 var_222;
        const wp::int32 var_223 = 29;
        const wp::int32 var_224 = 2;
        wp::float64 var_225;
        const wp::int32 var_226 = 30;
        const wp::int32 var_227 = 3;
        wp::float64 var_228;
        const wp::int32 var_229 = 31;
        const wp::int32 var_230 = 32;
        wp::float64 var_231;
        const wp::int32 var_232 = 33;
        wp::float64 var_233;
        const wp::int32 var_234 = 34;
        wp::float64 var_235;
        const wp::int32 var_236 = 35;
        wp::float64 var_237;
        wp::vec_t<4, wp::float64> var_238;
        const bool var_239 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_240 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_241 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_242 = 0;
        wp::vec_t<4, wp::float64> var_243;
        const wp::int32 var_244 = 0;
        wp::float64 var_245;
        const wp::int32 var_246 = 32;
        const wp::int32 var_247 = 1;
        wp::float64 var_248;
        const wp::int32 var_249 = 33;
        const wp::int32 var_250 = 2;
        wp::float64 var_251;
        const wp::int32 var_252 = 34;
        const wp::int32 var_253 = 3;
        wp::float64 var_254;
        const wp::int32 var_255 = 35;
        const wp::int32 var_256 = 256;
        wp::int32 var_257;
        const wp::int32 var_258 = 0;
        bool var_259;
        //---------
        // forward
        // def sum_doppler_rows_tiles(matches__jobs__sources__points, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__targets, matches__poses, matches__pairs, matches__weighted, matches__weights, loss__kind, loss__k, loss__shape, source__dopplers, source__directions, target__normals, velocities, iterations, rule__sensor, rule__period, rule__share, rule__loss__kind, rule__loss__k, rule__loss__shape, rule__geometric_from, rule__doppler_from, rule__reject_from, rule__threshold, firsts_, lasts_, owners_, live_, partials_):       <L 1>
        // i_ = wp.tid()                                                                          <L 2>
        var_0 = builtin_tid1d();
        // b_ = i_ // 256                                                                         <L 3>
        var_2 = wp::floordiv(var_0, var_1);
        // value_ = vector_()                                                                     <L 4>
        var_3 = wp::vec_t<36, wp::float64>();
        // if live_[owners_[b_]] != 0:                                                            <L 5>
        var_4 = wp::address(var_owners_, var_2);
        var_5 = wp::load(var_4);
        var_6 = wp::address(var_live_, var_5);
        var_9 = wp::load(var_6);
        var_8 = (var_9 != var_7);
        if (var_8) {
            // for j_ in range(firsts_[b_] + i_ % 256, lasts_[b_], 256):                          <L 6>
            var_10 = wp::address(var_firsts_, var_2);
            var_12 = wp::mod(var_0, var_11);
            var_14 = wp::load(var_10);
            var_13 = wp::add(var_14, var_12);
            var_15 = wp::address(var_lasts_, var_2);
            var_18 = wp::load(var_15);
            var_17 = wp::range(var_13, var_18, var_16);
            start_for_0:;
                if (iter_cmp(var_17) == 0) goto end_for_0;
                var_19 = wp::iter_next(var_17);
                // value_ += element_(matches__jobs__sources__points, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__targets, matches__poses, matches__pairs, matches__weighted, matches__weights, loss__kind, loss__k, loss__shape, source__dopplers, source__directions, target__normals, velocities, iterations, rule__sensor, rule__period, rule__share, rule__loss__kind, rule__loss__k, rule__loss__shape, rule__geometric_from, rule__doppler_from, rule__reject_from, rule__threshold, j_)       <L 7>
                var_20 = sum_doppler_rows_element_0(var_matches__jobs__sources__points, var_matches__jobs__sources__first_positions, var_matches__jobs__group_jobs, var_matches__jobs__job_groups, var_matches__jobs__job_sources, var_matches__targets, var_matches__poses, var_matches__pairs, var_matches__weighted, var_matches__weights, var_loss__kind, var_loss__k, var_loss__shape, var_source__dopplers, var_source__directions, var_target__normals, var_velocities, var_iterations, var_rule__sensor, var_rule__period, var_rule__share, var_rule__loss__kind, var_rule__loss__k, var_rule__loss__shape, var_rule__geometric_from, var_rule__doppler_from, var_rule__reject_from, var_rule__threshold, var_19);
                var_21 = wp::add(var_3, var_20);
                wp::assign(var_3, var_21);
                goto start_for_0;
            end_for_0:;
        }
        // part_0 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[0], value_[1], value_[2], value_[3]), preserve_type=True)), 0)       <L 8>
        var_23 = wp::extract(var_3, var_22);
        var_25 = wp::extract(var_3, var_24);
        var_27 = wp::extract(var_3, var_26);
        var_29 = wp::extract(var_3, var_28);
        var_30 = wp::vec_t<4, wp::float64>(var_23, var_25, var_27, var_29);
        var_32 = wp::tile<wp::vec_t<4, wp::float64>>(var_30);
        var_33 = wp::tile_sum(var_32);
        var_35 = wp::tile_extract(var_33, var_34);
        // value_[0] = part_0[0]                                                                  <L 9>
        var_37 = wp::extract(var_35, var_36);
        wp::assign_inplace(var_3, var_38, var_37);
        // value_[1] = part_0[1]                                                                  <L 10>
        var_40 = wp::extract(var_35, var_39);
        wp::assign_inplace(var_3, var_41, var_40);
        // value_[2] = part_0[2]                                                                  <L 11>
        var_43 = wp::extract(var_35, var_42);
        wp::assign_inplace(var_3, var_44, var_43);
        // value_[3] = part_0[3]                                                                  <L 12>
        var_46 = wp::extract(var_35, var_45);
        wp::assign_inplace(var_3, var_47, var_46);
        // part_4 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[4], value_[5], value_[6], value_[7]), preserve_type=True)), 0)       <L 13>
        var_49 = wp::extract(var_3, var_48);
        var_51 = wp::extract(var_3, var_50);
        var_53 = wp::extract(var_3, var_52);
        var_55 = wp::extract(var_3, var_54);
        var_56 = wp::vec_t<4, wp::float64>(var_49, var_51, var_53, var_55);
        var_58 = wp::tile<wp::vec_t<4, wp::float64>>(var_56);
        var_59 = wp::tile_sum(var_58);
        var_61 = wp::tile_extract(var_59, var_60);
        // value_[4] = part_4[0]                                                                  <L 14>
        var_63 = wp::extract(var_61, var_62);
        wp::assign_inplace(var_3, var_64, var_63);
        // value_[5] = part_4[1]                                                                  <L 15>
        var_66 = wp::extract(var_61, var_65);
        wp::assign_inplace(var_3, var_67, var_66);
        // value_[6] = part_4[2]                                                                  <L 16>
        var_69 = wp::extract(var_61, var_68);
        wp::assign_inplace(var_3, var_70, var_69);
        // value_[7] = part_4[3]                                                                  <L 17>
        var_72 = wp::extract(var_61, var_71);
        wp::assign_inplace(var_3, var_73, var_72);
        // part_8 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[8], value_[9], value_[10], value_[11]), preserve_type=True)), 0)       <L 18>
        var_75 = wp::extract(var_3, var_74);
        var_77 = wp::extract(var_3, var_76);
        var_79 = wp::extract(var_3, var_78);
        var_81 = wp::extract(var_3, var_80);
        var_82 = wp::vec_t<4, wp::float64>(var_75, var_77, var_79, var_81);
        var_84 = wp::tile<wp::vec_t<4, wp::float64>>(var_82);
        var_85 = wp::tile_sum(var_84);
        var_87 = wp::tile_extract(var_85, var_86);
        // value_[8] = part_8[0]                                                                  <L 19>
        var_89 = wp::extract(var_87, var_88);
        wp::assign_inplace(var_3, var_90, var_89);
        // value_[9] = part_8[1]                                                                  <L 20>
        var_92 = wp::extract(var_87, var_91);
        wp::assign_inplace(var_3, var_93, var_92);
        // value_[10] = part_8[2]                                                                 <L 21>
        var_95 = wp::extract(var_87, var_94);
        wp::assign_inplace(var_3, var_96, var_95);
        // value_[11] = part_8[3]                                                                 <L 22>
        var_98 = wp::extract(var_87, var_97);
        wp::assign_inplace(var_3, var_99, var_98);
        // part_12 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[12], value_[13], value_[14], value_[15]), preserve_type=True)), 0)       <L 23>
        var_101 = wp::extract(var_3, var_100);
        var_103 = wp::extract(var_3, var_102);
        var_105 = wp::extract(var_3, var_104);
        var_107 = wp::extract(var_3, var_106);
        var_108 = wp::vec_t<4, wp::float64>(var_101, var_103, var_105, var_107);
        var_110 = wp::tile<wp::vec_t<4, wp::float64>>(var_108);
        var_111 = wp::tile_sum(var_110);
        var_113 = wp::tile_extract(var_111, var_112);
        // value_[12] = part_12[0]                                                                <L 24>
        var_115 = wp::extract(var_113, var_114);
        wp::assign_inplace(var_3, var_116, var_115);
        // value_[13] = part_12[1]                                                                <L 25>
        var_118 = wp::extract(var_113, var_117);
        wp::assign_inplace(var_3, var_119, var_118);
        // value_[14] = part_12[2]                                                                <L 26>
        var_121 = wp::extract(var_113, var_120);
        wp::assign_inplace(var_3, var_122, var_121);
        // value_[15] = part_12[3]                                                                <L 27>
        var_124 = wp::extract(var_113, var_123);
        wp::assign_inplace(var_3, var_125, var_124);
        // part_16 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[16], value_[17], value_[18], value_[19]), preserve_type=True)), 0)       <L 28>
        var_127 = wp::extract(var_3, var_126);
        var_129 = wp::extract(var_3, var_128);
        var_131 = wp::extract(var_3, var_130);
        var_133 = wp::extract(var_3, var_132);
        var_134 = wp::vec_t<4, wp::float64>(var_127, var_129, var_131, var_133);
        var_136 = wp::tile<wp::vec_t<4, wp::float64>>(var_134);
        var_137 = wp::tile_sum(var_136);
        var_139 = wp::tile_extract(var_137, var_138);
        // value_[16] = part_16[0]                                                                <L 29>
        var_141 = wp::extract(var_139, var_140);
        wp::assign_inplace(var_3, var_142, var_141);
        // value_[17] = part_16[1]                                                                <L 30>
        var_144 = wp::extract(var_139, var_143);
        wp::assign_inplace(var_3, var_145, var_144);
        // value_[18] = part_16[2]                                                                <L 31>
        var_147 = wp::extract(var_139, var_146);
        wp::assign_inplace(var_3, var_148, var_147);
        // value_[19] = part_16[3]                                                                <L 32>
        var_150 = wp::extract(var_139, var_149);
        wp::assign_inplace(var_3, var_151, var_150);
        // part_20 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[20], value_[21], value_[22], value_[23]), preserve_type=True)), 0)       <L 33>
        var_153 = wp::extract(var_3, var_152);
        var_155 = wp::extract(var_3, var_154);
        var_157 = wp::extract(var_3, var_156);
        var_159 = wp::extract(var_3, var_158);
        var_160 = wp::vec_t<4, wp::float64>(var_153, var_155, var_157, var_159);
        var_162 = wp::tile<wp::vec_t<4, wp::float64>>(var_160);
        var_163 = wp::tile_sum(var_162);
        var_165 = wp::tile_extract(var_163, var_164);
        // value_[20] = part_20[0]                                                                <L 34>
        var_167 = wp::extract(var_165, var_166);
        wp::assign_inplace(var_3, var_168, var_167);
        // value_[21] = part_20[1]                                                                <L 35>
        var_170 = wp::extract(var_165, var_169);
        wp::assign_inplace(var_3, var_171, var_170);
        // value_[22] = part_20[2]                                                                <L 36>
        var_173 = wp::extract(var_165, var_172);
        wp::assign_inplace(var_3, var_174, var_173);
        // value_[23] = part_20[3]                                                                <L 37>
        var_176 = wp::extract(var_165, var_175);
        wp::assign_inplace(var_3, var_177, var_176);
        // part_24 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[24], value_[25], value_[26], value_[27]), preserve_type=True)), 0)       <L 38>
        var_179 = wp::extract(var_3, var_178);
        var_181 = wp::extract(var_3, var_180);
        var_183 = wp::extract(var_3, var_182);
        var_185 = wp::extract(var_3, var_184);
        var_186 = wp::vec_t<4, wp::float64>(var_179, var_181, var_183, var_185);
        var_188 = wp::tile<wp::vec_t<4, wp::float64>>(var_186);
        var_189 = wp::tile_sum(var_188);
        var_191 = wp::tile_extract(var_189, var_190);
        // value_[24] = part_24[0]                                                                <L 39>
        var_193 = wp::extract(var_191, var_192);
        wp::assign_inplace(var_3, var_194, var_193);
        // value_[25] = part_24[1]                                                                <L 40>
        var_196 = wp::extract(var_191, var_195);
        wp::assign_inplace(var_3, var_197, var_196);
        // value_[26] = part_24[2]                                                                <L 41>
        var_199 = wp::extract(var_191, var_198);
        wp::assign_inplace(var_3, var_200, var_199);
        // value_[27] = part_24[3]                                                                <L 42>
        var_202 = wp::extract(var_191, var_201);
        wp::assign_inplace(var_3, var_203, var_202);
        // part_28 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[28], value_[29], value_[30], value_[31]), preserve_type=True)), 0)       <L 43>
        var_205 = wp::extract(var_3, var_204);
        var_207 = wp::extract(var_3, var_206);
        var_209 = wp::extract(var_3, var_208);
        var_211 = wp::extract(var_3, var_210);
        var_212 = wp::vec_t<4, wp::float64>(var_205, var_207, var_209, var_211);
        var_214 = wp::tile<wp::vec_t<4, wp::float64>>(var_212);
        var_215 = wp::tile_sum(var_214);
        var_217 = wp::tile_extract(var_215, var_216);
        // value_[28] = part_28[0]                                                                <L 44>
        var_219 = wp::extract(var_217, var_218);
        wp::assign_inplace(var_3, var_220, var_219);
        // value_[29] = part_28[1]                                                                <L 45>
        var_222 = wp::extract(var_217, var_221);
        wp::assign_inplace(var_3, var_223, var_222);
        // value_[30] = part_28[2]                                                                <L 46>
        var_225 = wp::extract(var_217, var_224);
        wp::assign_inplace(var_3, var_226, var_225);
        // value_[31] = part_28[3]                                                                <L 47>
        var_228 = wp::extract(var_217, var_227);
        wp::assign_inplace(var_3, var_229, var_228);
        // part_32 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[32], value_[33], value_[34], value_[35]), preserve_type=True)), 0)       <L 48>
        var_231 = wp::extract(var_3, var_230);
        var_233 = wp::extract(var_3, var_232);
        var_235 = wp::extract(var_3, var_234);
        var_237 = wp::extract(var_3, var_236);
        var_238 = wp::vec_t<4, wp::float64>(var_231, var_233, var_235, var_237);
        var_240 = wp::tile<wp::vec_t<4, wp::float64>>(var_238);
        var_241 = wp::tile_sum(var_240);
        var_243 = wp::tile_extract(var_241, var_242);
        // value_[32] = part_32[0]                                                                <L 49>
        var_245 = wp::extract(var_243, var_244);
        wp::assign_inplace(var_3, var_246, var_245);
        // value_[33] = part_32[1]                                                                <L 50>
        var_248 = wp::extract(var_243, var_247);
        wp::assign_inplace(var_3, var_249, var_248);
        // value_[34] = part_32[2]                                                                <L 51>
        var_251 = wp::extract(var_243, var_250);
        wp::assign_inplace(var_3, var_252, var_251);
        // value_[35] = part_32[3]                                                                <L 52>
        var_254 = wp::extract(var_243, var_253);
        wp::assign_inplace(var_3, var_255, var_254);
        // if i_ % 256 == 0:                                                                      <L 53>
        var_257 = wp::mod(var_0, var_256);
        var_259 = (var_257 == var_258);
        if (var_259) {
            // partials_[b_] = value_                                                             <L 54>
            wp::array_store(var_partials_, var_2, var_3);
        }
}



extern "C" __global__ void WP_MAXNREG(128) sum_plane_rows_tiles_8779e3be_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__jobs__sources__points,
    wp::array_t<wp::int32> var_matches__jobs__sources__first_positions,
    wp::array_t<wp::int32> var_matches__jobs__group_jobs,
    wp::array_t<wp::int32> var_matches__jobs__job_groups,
    wp::array_t<wp::int32> var_matches__jobs__job_sources,
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__targets,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_matches__poses,
    wp::array_t<wp::int32> var_matches__pairs,
    wp::int32 var_matches__weighted,
    wp::array_t<wp::float32> var_matches__weights,
    wp::int32 var_loss__kind,
    wp::float64 var_loss__k,
    wp::float64 var_loss__shape,
    wp::array_t<wp::vec_t<3, wp::float32>> var_target__normals,
    wp::array_t<wp::int32> var_firsts_,
    wp::array_t<wp::int32> var_lasts_,
    wp::array_t<wp::int32> var_owners_,
    wp::array_t<wp::int32> var_live_,
    wp::array_t<wp::vec_t<36, wp::float64>> var_partials_)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        const wp::int32 var_1 = 256;
        wp::int32 var_2;
        wp::vec_t<36, wp::float64> var_3;
        wp::int32* var_4;
        wp::int32 var_5;
        wp::int32* var_6;
        const wp::int32 var_7 = 0;
        bool var_8;
        wp::int32 var_9;
        wp::int32* var_10;
        const wp::int32 var_11 = 256;
        wp::int32 var_12;
        wp::int32 var_13;
        wp::int32 var_14;
        wp::int32* var_15;
        const wp::int32 var_16 = 256;
        wp::range_t var_17;
        wp::int32 var_18;
        wp::int32 var_19;
        wp::vec_t<36, wp::float64> var_20;
        wp::vec_t<36, wp::float64> var_21;
        const wp::int32 var_22 = 0;
        wp::float64 var_23;
        const wp::int32 var_24 = 1;
        wp::float64 var_25;
        const wp::int32 var_26 = 2;
        wp::float64 var_27;
        const wp::int32 var_28 = 3;
        wp::float64 var_29;
        wp::vec_t<4, wp::float64> var_30;
        const bool var_31 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_32 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_33 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_34 = 0;
        wp::vec_t<4, wp::float64> var_35;
        const wp::int32 var_36 = 0;
        wp::float64 var_37;
        const wp::int32 var_38 = 0;
        const wp::int32 var_39 = 1;
        wp::float64 var_40;
        const wp::int32 var_41 = 1;
        const wp::int32 var_42 = 2;
        wp::float64 var_43;
        const wp::int32 var_44 = 2;
        const wp::int32 var_45 = 3;
        wp::float64 var_46;
        const wp::int32 var_47 = 3;
        const wp::int32 var_48 = 4;
        wp::float64 var_49;
        const wp::int32 var_50 = 5;
        wp::float64 var_51;
        const wp::int32 var_52 = 6;
        wp::float64 var_53;
        const wp::int32 var_54 = 7;
        wp::float64 var_55;
        wp::vec_t<4, wp::float64> var_56;
        const bool var_57 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_58 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_59 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_60 = 0;
        wp::vec_t<4, wp::float64> var_61;
        const wp::int32 var_62 = 0;
        wp::float64 var_63;
        const wp::int32 var_64 = 4;
        const wp::int32 var_65 = 1;
        wp::float64 var_66;
        const wp::int32 var_67 = 5;
        const wp::int32 var_68 = 2;
        wp::float64 var_69;
        const wp::int32 var_70 = 6;
        const wp::int32 var_71 = 3;
        wp::float64 var_72;
        const wp::int32 var_73 = 7;
        const wp::int32 var_74 = 8;
        wp::float64 var_75;
        const wp::int32 var_76 = 9;
        wp::float64 var_77;
        const wp::int32 var_78 = 10;
        wp::float64 var_79;
        const wp::int32 var_80 = 11;
        wp::float64 var_81;
        wp::vec_t<4, wp::float64> var_82;
        const bool var_83 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_84 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_85 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_86 = 0;
        wp::vec_t<4, wp::float64> var_87;
        const wp::int32 var_88 = 0;
        wp::float64 var_89;
        const wp::int32 var_90 = 8;
        const wp::int32 var_91 = 1;
        wp::float64 var_92;
        const wp::int32 var_93 = 9;
        const wp::int32 var_94 = 2;
        wp::float64 var_95;
        const wp::int32 var_96 = 10;
        const wp::int32 var_97 = 3;
        wp::float64 var_98;
        const wp::int32 var_99 = 11;
        const wp::int32 var_100 = 12;
        wp::float64 var_101;
        const wp::int32 var_102 = 13;
        wp::float64 var_103;
        const wp::int32 var_104 = 14;
        wp::float64 var_105;
        const wp::int32 var_106 = 15;
        wp::float64 var_107;
        wp::vec_t<4, wp::float64> var_108;
        const bool var_109 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_110 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_111 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_112 = 0;
        wp::vec_t<4, wp::float64> var_113;
        const wp::int32 var_114 = 0;
        wp::float64 var_115;
        const wp::int32 var_116 = 12;
        const wp::int32 var_117 = 1;
        wp::float64 var_118;
        const wp::int32 var_119 = 13;
        const wp::int32 var_120 = 2;
        wp::float64 var_121;
        const wp::int32 var_122 = 14;
        const wp::int32 var_123 = 3;
        wp::float64 var_124;
        const wp::int32 var_125 = 15;
        const wp::int32 var_126 = 16;
        wp::float64 var_127;
        const wp::int32 var_128 = 17;
        wp::float64 var_129;
        const wp::int32 var_130 = 18;
        wp::float64 var_131;
        const wp::int32 var_132 = 19;
        wp::float64 var_133;
        wp::vec_t<4, wp::float64> var_134;
        const bool var_135 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_136 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_137 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_138 = 0;
        wp::vec_t<4, wp::float64> var_139;
        const wp::int32 var_140 = 0;
        wp::float64 var_141;
        const wp::int32 var_142 = 16;
        const wp::int32 var_143 = 1;
        wp::float64 var_144;
        const wp::int32 var_145 = 17;
        const wp::int32 var_146 = 2;
        wp::float64 var_147;
        const wp::int32 var_148 = 18;
        const wp::int32 var_149 = 3;
        wp::float64 var_150;
        const wp::int32 var_151 = 19;
        const wp::int32 var_152 = 20;
        wp::float64 var_153;
        const wp::int32 var_154 = 21;
        wp::float64 var_155;
        const wp::int32 var_156 = 22;
        wp::float64 var_157;
        const wp::int32 var_158 = 23;
        wp::float64 var_159;
        wp::vec_t<4, wp::float64> var_160;
        const bool var_161 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_162 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_163 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_164 = 0;
        wp::vec_t<4, wp::float64> var_165;
        const wp::int32 var_166 = 0;
        wp::float64 var_167;
        const wp::int32 var_168 = 20;
        const wp::int32 var_169 = 1;
        wp::float64 var_170;
        const wp::int32 var_171 = 21;
        const wp::int32 var_172 = 2;
        wp::float64 var_173;
        const wp::int32 var_174 = 22;
        const wp::int32 var_175 = 3;
        wp::float64 var_176;
        const wp::int32 var_177 = 23;
        const wp::int32 var_178 = 24;
        wp::float64 var_179;
        const wp::int32 var_180 = 25;
        wp::float64 var_181;
        const wp::int32 var_182 = 26;
        wp::float64 var_183;
        const wp::int32 var_184 = 27;
        wp::float64 var_185;
        wp::vec_t<4, wp::float64> var_186;
        const bool var_187 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_188 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_189 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_190 = 0;
        wp::vec_t<4, wp::float64> var_191;
        const wp::int32 var_192 = 0;
        wp::float64 var_193;
        const wp::int32 var_194 = 24;
        const wp::int32 var_195 = 1;
        wp::float64 var_196;
        const wp::int32 var_197 = 25;
        const wp::int32 var_198 = 2;
        wp::float64 var_199;
        const wp::int32 var_200 = 26;
        const wp::int32 var_201 = 3;
        wp::float64 var_202;
        const wp::int32 var_203 = 27;
        const wp::int32 var_204 = 28;
        wp::float64 var_205;
        const wp::int32 var_206 = 29;
        wp::float64 var_207;
        const wp::int32 var_208 = 30;
        wp::float64 var_209;
        const wp::int32 var_210 = 31;
        wp::float64 var_211;
        wp::vec_t<4, wp::float64> var_212;
        const bool var_213 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_214 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_215 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_216 = 0;
        wp::vec_t<4, wp::float64> var_217;
        const wp::int32 var_218 = 0;
        wp::float64 var_219;
        const wp::int32 var_220 = 28;
        const wp::int32 var_221 = 1;
        wp::float64 var_222;
        const wp::int32 var_223 = 29;
        const wp::int32 var_224 = 2;
        wp::float64 var_225;
        const wp::int32 var_226 = 30;
        const wp::int32 var_227 = 3;
        wp::float64 var_228;
        const wp::int32 var_229 = 31;
        const wp::int32 var_230 = 32;
        wp::float64 var_231;
        const wp::int32 var_232 = 33;
        wp::float64 var_233;
        const wp::int32 var_234 = 34;
        wp::float64 var_235;
        const wp::int32 var_236 = 35;
        wp::float64 var_237;
        wp::vec_t<4, wp::float64> var_238;
        const bool var_239 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_240 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_241 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_242 = 0;
        wp::vec_t<4, wp::float64> var_243;
        const wp::int32 var_244 = 0;
        wp::float64 var_245;
        const wp::int32 var_246 = 32;
        const wp::int32 var_247 = 1;
        wp::float64 var_248;
        const wp::int32 var_249 = 33;
        const wp::int32 var_250 = 2;
        wp::float64 var_251;
        const wp::int32 var_252 = 34;
        const wp::int32 var_253 = 3;
        wp::float64 var_254;
        const wp::int32 var_255 = 35;
        const wp::int32 var_256 = 256;
        wp::int32 var_257;
        const wp::int32 var_258 = 0;
        bool var_259;
        //---------
        // forward
        // def sum_plane_rows_tiles(matches__jobs__sources__points, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__targets, matches__poses, matches__pairs, matches__weighted, matches__weights, loss__kind, loss__k, loss__shape, target__normals, firsts_, lasts_, owners_, live_, partials_):       <L 1>
        // i_ = wp.tid()                                                                          <L 2>
        var_0 = builtin_tid1d();
        // b_ = i_ // 256                                                                         <L 3>
        var_2 = wp::floordiv(var_0, var_1);
        // value_ = vector_()                                                                     <L 4>
        var_3 = wp::vec_t<36, wp::float64>();
        // if live_[owners_[b_]] != 0:                                                            <L 5>
        var_4 = wp::address(var_owners_, var_2);
        var_5 = wp::load(var_4);
        var_6 = wp::address(var_live_, var_5);
        var_9 = wp::load(var_6);
        var_8 = (var_9 != var_7);
        if (var_8) {
            // for j_ in range(firsts_[b_] + i_ % 256, lasts_[b_], 256):                          <L 6>
            var_10 = wp::address(var_firsts_, var_2);
            var_12 = wp::mod(var_0, var_11);
            var_14 = wp::load(var_10);
            var_13 = wp::add(var_14, var_12);
            var_15 = wp::address(var_lasts_, var_2);
            var_18 = wp::load(var_15);
            var_17 = wp::range(var_13, var_18, var_16);
            start_for_0:;
                if (iter_cmp(var_17) == 0) goto end_for_0;
                var_19 = wp::iter_next(var_17);
                // value_ += element_(matches__jobs__sources__points, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__targets, matches__poses, matches__pairs, matches__weighted, matches__weights, loss__kind, loss__k, loss__shape, target__normals, j_)       <L 7>
                var_20 = sum_plane_rows_element_0(var_matches__jobs__sources__points, var_matches__jobs__sources__first_positions, var_matches__jobs__group_jobs, var_matches__jobs__job_groups, var_matches__jobs__job_sources, var_matches__targets, var_matches__poses, var_matches__pairs, var_matches__weighted, var_matches__weights, var_loss__kind, var_loss__k, var_loss__shape, var_target__normals, var_19);
                var_21 = wp::add(var_3, var_20);
                wp::assign(var_3, var_21);
                goto start_for_0;
            end_for_0:;
        }
        // part_0 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[0], value_[1], value_[2], value_[3]), preserve_type=True)), 0)       <L 8>
        var_23 = wp::extract(var_3, var_22);
        var_25 = wp::extract(var_3, var_24);
        var_27 = wp::extract(var_3, var_26);
        var_29 = wp::extract(var_3, var_28);
        var_30 = wp::vec_t<4, wp::float64>(var_23, var_25, var_27, var_29);
        var_32 = wp::tile<wp::vec_t<4, wp::float64>>(var_30);
        var_33 = wp::tile_sum(var_32);
        var_35 = wp::tile_extract(var_33, var_34);
        // value_[0] = part_0[0]                                                                  <L 9>
        var_37 = wp::extract(var_35, var_36);
        wp::assign_inplace(var_3, var_38, var_37);
        // value_[1] = part_0[1]                                                                  <L 10>
        var_40 = wp::extract(var_35, var_39);
        wp::assign_inplace(var_3, var_41, var_40);
        // value_[2] = part_0[2]                                                                  <L 11>
        var_43 = wp::extract(var_35, var_42);
        wp::assign_inplace(var_3, var_44, var_43);
        // value_[3] = part_0[3]                                                                  <L 12>
        var_46 = wp::extract(var_35, var_45);
        wp::assign_inplace(var_3, var_47, var_46);
        // part_4 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[4], value_[5], value_[6], value_[7]), preserve_type=True)), 0)       <L 13>
        var_49 = wp::extract(var_3, var_48);
        var_51 = wp::extract(var_3, var_50);
        var_53 = wp::extract(var_3, var_52);
        var_55 = wp::extract(var_3, var_54);
        var_56 = wp::vec_t<4, wp::float64>(var_49, var_51, var_53, var_55);
        var_58 = wp::tile<wp::vec_t<4, wp::float64>>(var_56);
        var_59 = wp::tile_sum(var_58);
        var_61 = wp::tile_extract(var_59, var_60);
        // value_[4] = part_4[0]                                                                  <L 14>
        var_63 = wp::extract(var_61, var_62);
        wp::assign_inplace(var_3, var_64, var_63);
        // value_[5] = part_4[1]                                                                  <L 15>
        var_66 = wp::extract(var_61, var_65);
        wp::assign_inplace(var_3, var_67, var_66);
        // value_[6] = part_4[2]                                                                  <L 16>
        var_69 = wp::extract(var_61, var_68);
        wp::assign_inplace(var_3, var_70, var_69);
        // value_[7] = part_4[3]                                                                  <L 17>
        var_72 = wp::extract(var_61, var_71);
        wp::assign_inplace(var_3, var_73, var_72);
        // part_8 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[8], value_[9], value_[10], value_[11]), preserve_type=True)), 0)       <L 18>
        var_75 = wp::extract(var_3, var_74);
        var_77 = wp::extract(var_3, var_76);
        var_79 = wp::extract(var_3, var_78);
        var_81 = wp::extract(var_3, var_80);
        var_82 = wp::vec_t<4, wp::float64>(var_75, var_77, var_79, var_81);
        var_84 = wp::tile<wp::vec_t<4, wp::float64>>(var_82);
        var_85 = wp::tile_sum(var_84);
        var_87 = wp::tile_extract(var_85, var_86);
        // value_[8] = part_8[0]                                                                  <L 19>
        var_89 = wp::extract(var_87, var_88);
        wp::assign_inplace(var_3, var_90, var_89);
        // value_[9] = part_8[1]                                                                  <L 20>
        var_92 = wp::extract(var_87, var_91);
        wp::assign_inplace(var_3, var_93, var_92);
        // value_[10] = part_8[2]                                                                 <L 21>
        var_95 = wp::extract(var_87, var_94);
        wp::assign_inplace(var_3, var_96, var_95);
        // value_[11] = part_8[3]                                                                 <L 22>
        var_98 = wp::extract(var_87, var_97);
        wp::assign_inplace(var_3, var_99, var_98);
        // part_12 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[12], value_[13], value_[14], value_[15]), preserve_type=True)), 0)       <L 23>
        var_101 = wp::extract(var_3, var_100);
        var_103 = wp::extract(var_3, var_102);
        var_105 = wp::extract(var_3, var_104);
        var_107 = wp::extract(var_3, var_106);
        var_108 = wp::vec_t<4, wp::float64>(var_101, var_103, var_105, var_107);
        var_110 = wp::tile<wp::vec_t<4, wp::float64>>(var_108);
        var_111 = wp::tile_sum(var_110);
        var_113 = wp::tile_extract(var_111, var_112);
        // value_[12] = part_12[0]                                                                <L 24>
        var_115 = wp::extract(var_113, var_114);
        wp::assign_inplace(var_3, var_116, var_115);
        // value_[13] = part_12[1]                                                                <L 25>
        var_118 = wp::extract(var_113, var_117);
        wp::assign_inplace(var_3, var_119, var_118);
        // value_[14] = part_12[2]                                                                <L 26>
        var_121 = wp::extract(var_113, var_120);
        wp::assign_inplace(var_3, var_122, var_121);
        // value_[15] = part_12[3]                                                                <L 27>
        var_124 = wp::extract(var_113, var_123);
        wp::assign_inplace(var_3, var_125, var_124);
        // part_16 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[16], value_[17], value_[18], value_[19]), preserve_type=True)), 0)       <L 28>
        var_127 = wp::extract(var_3, var_126);
        var_129 = wp::extract(var_3, var_128);
        var_131 = wp::extract(var_3, var_130);
        var_133 = wp::extract(var_3, var_132);
        var_134 = wp::vec_t<4, wp::float64>(var_127, var_129, var_131, var_133);
        var_136 = wp::tile<wp::vec_t<4, wp::float64>>(var_134);
        var_137 = wp::tile_sum(var_136);
        var_139 = wp::tile_extract(var_137, var_138);
        // value_[16] = part_16[0]                                                                <L 29>
        var_141 = wp::extract(var_139, var_140);
        wp::assign_inplace(var_3, var_142, var_141);
        // value_[17] = part_16[1]                                                                <L 30>
        var_144 = wp::extract(var_139, var_143);
        wp::assign_inplace(var_3, var_145, var_144);
        // value_[18] = part_16[2]                                                                <L 31>
        var_147 = wp::extract(var_139, var_146);
        wp::assign_inplace(var_3, var_148, var_147);
        // value_[19] = part_16[3]                                                                <L 32>
        var_150 = wp::extract(var_139, var_149);
        wp::assign_inplace(var_3, var_151, var_150);
        // part_20 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[20], value_[21], value_[22], value_[23]), preserve_type=True)), 0)       <L 33>
        var_153 = wp::extract(var_3, var_152);
        var_155 = wp::extract(var_3, var_154);
        var_157 = wp::extract(var_3, var_156);
        var_159 = wp::extract(var_3, var_158);
        var_160 = wp::vec_t<4, wp::float64>(var_153, var_155, var_157, var_159);
        var_162 = wp::tile<wp::vec_t<4, wp::float64>>(var_160);
        var_163 = wp::tile_sum(var_162);
        var_165 = wp::tile_extract(var_163, var_164);
        // value_[20] = part_20[0]                                                                <L 34>
        var_167 = wp::extract(var_165, var_166);
        wp::assign_inplace(var_3, var_168, var_167);
        // value_[21] = part_20[1]                                                                <L 35>
        var_170 = wp::extract(var_165, var_169);
        wp::assign_inplace(var_3, var_171, var_170);
        // value_[22] = part_20[2]                                                                <L 36>
        var_173 = wp::extract(var_165, var_172);
        wp::assign_inplace(var_3, var_174, var_173);
        // value_[23] = part_20[3]                                                                <L 37>
        var_176 = wp::extract(var_165, var_175);
        wp::assign_inplace(var_3, var_177, var_176);
        // part_24 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[24], value_[25], value_[26], value_[27]), preserve_type=True)), 0)       <L 38>
        var_179 = wp::extract(var_3, var_178);
        var_181 = wp::extract(var_3, var_180);
        var_183 = wp::extract(var_3, var_182);
        var_185 = wp::extract(var_3, var_184);
        var_186 = wp::vec_t<4, wp::float64>(var_179, var_181, var_183, var_185);
        var_188 = wp::tile<wp::vec_t<4, wp::float64>>(var_186);
        var_189 = wp::tile_sum(var_188);
        var_191 = wp::tile_extract(var_189, var_190);
        // value_[24] = part_24[0]                                                                <L 39>
        var_193 = wp::extract(var_191, var_192);
        wp::assign_inplace(var_3, var_194, var_193);
        // value_[25] = part_24[1]                                                                <L 40>
        var_196 = wp::extract(var_191, var_195);
        wp::assign_inplace(var_3, var_197, var_196);
        // value_[26] = part_24[2]                                                                <L 41>
        var_199 = wp::extract(var_191, var_198);
        wp::assign_inplace(var_3, var_200, var_199);
        // value_[27] = part_24[3]                                                                <L 42>
        var_202 = wp::extract(var_191, var_201);
        wp::assign_inplace(var_3, var_203, var_202);
        // part_28 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[28], value_[29], value_[30], value_[31]), preserve_type=True)), 0)       <L 43>
        var_205 = wp::extract(var_3, var_204);
        var_207 = wp::extract(var_3, var_206);
        var_209 = wp::extract(var_3, var_208);
        var_211 = wp::extract(var_3, var_210);
        var_212 = wp::vec_t<4, wp::float64>(var_205, var_207, var_209, var_211);
        var_214 = wp::tile<wp::vec_t<4, wp::float64>>(var_212);
        var_215 = wp::tile_sum(var_214);
        var_217 = wp::tile_extract(var_215, var_216);
        // value_[28] = part_28[0]                                                                <L 44>
        var_219 = wp::extract(var_217, var_218);
        wp::assign_inplace(var_3, var_220, var_219);
        // value_[29] = part_28[1]                                                                <L 45>
        var_222 = wp::extract(var_217, var_221);
        wp::assign_inplace(var_3, var_223, var_222);
        // value_[30] = part_28[2]                                                                <L 46>
        var_225 = wp::extract(var_217, var_224);
        wp::assign_inplace(var_3, var_226, var_225);
        // value_[31] = part_28[3]                                                                <L 47>
        var_228 = wp::extract(var_217, var_227);
        wp::assign_inplace(var_3, var_229, var_228);
        // part_32 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[32], value_[33], value_[34], value_[35]), preserve_type=True)), 0)       <L 48>
        var_231 = wp::extract(var_3, var_230);
        var_233 = wp::extract(var_3, var_232);
        var_235 = wp::extract(var_3, var_234);
        var_237 = wp::extract(var_3, var_236);
        var_238 = wp::vec_t<4, wp::float64>(var_231, var_233, var_235, var_237);
        var_240 = wp::tile<wp::vec_t<4, wp::float64>>(var_238);
        var_241 = wp::tile_sum(var_240);
        var_243 = wp::tile_extract(var_241, var_242);
        // value_[32] = part_32[0]                                                                <L 49>
        var_245 = wp::extract(var_243, var_244);
        wp::assign_inplace(var_3, var_246, var_245);
        // value_[33] = part_32[1]                                                                <L 50>
        var_248 = wp::extract(var_243, var_247);
        wp::assign_inplace(var_3, var_249, var_248);
        // value_[34] = part_32[2]                                                                <L 51>
        var_251 = wp::extract(var_243, var_250);
        wp::assign_inplace(var_3, var_252, var_251);
        // value_[35] = part_32[3]                                                                <L 52>
        var_254 = wp::extract(var_243, var_253);
        wp::assign_inplace(var_3, var_255, var_254);
        // if i_ % 256 == 0:                                                                      <L 53>
        var_257 = wp::mod(var_0, var_256);
        var_259 = (var_257 == var_258);
        if (var_259) {
            // partials_[b_] = value_                                                             <L 54>
            wp::array_store(var_partials_, var_2, var_3);
        }
}



extern "C" __global__ void WP_MAXNREG(128) sum_symmetric_rows_tiles_abae20cb_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__jobs__sources__points,
    wp::array_t<wp::int32> var_matches__jobs__sources__first_positions,
    wp::array_t<wp::int32> var_matches__jobs__group_jobs,
    wp::array_t<wp::int32> var_matches__jobs__job_groups,
    wp::array_t<wp::int32> var_matches__jobs__job_sources,
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__targets,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_matches__poses,
    wp::array_t<wp::int32> var_matches__pairs,
    wp::int32 var_matches__weighted,
    wp::array_t<wp::float32> var_matches__weights,
    wp::int32 var_loss__kind,
    wp::float64 var_loss__k,
    wp::float64 var_loss__shape,
    wp::array_t<wp::vec_t<3, wp::float32>> var_source__normals,
    wp::array_t<wp::vec_t<3, wp::float32>> var_target__normals,
    wp::array_t<wp::int32> var_firsts_,
    wp::array_t<wp::int32> var_lasts_,
    wp::array_t<wp::int32> var_owners_,
    wp::array_t<wp::int32> var_live_,
    wp::array_t<wp::vec_t<36, wp::float64>> var_partials_)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        const wp::int32 var_1 = 256;
        wp::int32 var_2;
        wp::vec_t<36, wp::float64> var_3;
        wp::int32* var_4;
        wp::int32 var_5;
        wp::int32* var_6;
        const wp::int32 var_7 = 0;
        bool var_8;
        wp::int32 var_9;
        wp::int32* var_10;
        const wp::int32 var_11 = 256;
        wp::int32 var_12;
        wp::int32 var_13;
        wp::int32 var_14;
        wp::int32* var_15;
        const wp::int32 var_16 = 256;
        wp::range_t var_17;
        wp::int32 var_18;
        wp::int32 var_19;
        wp::vec_t<36, wp::float64> var_20;
        wp::vec_t<36, wp::float64> var_21;
        const wp::int32 var_22 = 0;
        wp::float64 var_23;
        const wp::int32 var_24 = 1;
        wp::float64 var_25;
        const wp::int32 var_26 = 2;
        wp::float64 var_27;
        const wp::int32 var_28 = 3;
        wp::float64 var_29;
        wp::vec_t<4, wp::float64> var_30;
        const bool var_31 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_32 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_33 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_34 = 0;
        wp::vec_t<4, wp::float64> var_35;
        const wp::int32 var_36 = 0;
        wp::float64 var_37;
        const wp::int32 var_38 = 0;
        const wp::int32 var_39 = 1;
        wp::float64 var_40;
        const wp::int32 var_41 = 1;
        const wp::int32 var_42 = 2;
        wp::float64 var_43;
        const wp::int32 var_44 = 2;
        const wp::int32 var_45 = 3;
        wp::float64 var_46;
        const wp::int32 var_47 = 3;
        const wp::int32 var_48 = 4;
        wp::float64 var_49;
        const wp::int32 var_50 = 5;
        wp::float64 var_51;
        const wp::int32 var_52 = 6;
        wp::float64 var_53;
        const wp::int32 var_54 = 7;
        wp::float64 var_55;
        wp::vec_t<4, wp::float64> var_56;
        const bool var_57 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_58 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_59 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_60 = 0;
        wp::vec_t<4, wp::float64> var_61;
        const wp::int32 var_62 = 0;
        wp::float64 var_63;
        const wp::int32 var_64 = 4;
        const wp::int32 var_65 = 1;
        wp::float64 var_66;
        const wp::int32 var_67 = 5;
        const wp::int32 var_68 = 2;
        wp::float64 var_69;
        const wp::int32 var_70 = 6;
        const wp::int32 var_71 = 3;
        wp::float64 var_72;
        const wp::int32 var_73 = 7;
        const wp::int32 var_74 = 8;
        wp::float64 var_75;
        const wp::int32 var_76 = 9;
        wp::float64 var_77;
        const wp::int32 var_78 = 10;
        wp::float64 var_79;
        const wp::int32 var_80 = 11;
        wp::float64 var_81;
        wp::vec_t<4, wp::float64> var_82;
        const bool var_83 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_84 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_85 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_86 = 0;
        wp::vec_t<4, wp::float64> var_87;
        const wp::int32 var_88 = 0;
        wp::float64 var_89;
        const wp::int32 var_90 = 8;
        const wp::int32 var_91 = 1;
        wp::float64 var_92;
        const wp::int32 var_93 = 9;
        const wp::int32 var_94 = 2;
        wp::float64 var_95;
        const wp::int32 var_96 = 10;
        const wp::int32 var_97 = 3;
        wp::float64 var_98;
        const wp::int32 var_99 = 11;
        const wp::int32 var_100 = 12;
        wp::float64 var_101;
        const wp::int32 var_102 = 13;
        wp::float64 var_103;
        const wp::int32 var_104 = 14;
        wp::float64 var_105;
        const wp::int32 var_106 = 15;
        wp::float64 var_107;
        wp::vec_t<4, wp::float64> var_108;
        const bool var_109 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_110 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_111 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_112 = 0;
        wp::vec_t<4, wp::float64> var_113;
        const wp::int32 var_114 = 0;
        wp::float64 var_115;
        const wp::int32 var_116 = 12;
        const wp::int32 var_117 = 1;
        wp::float64 var_118;
        const wp::int32 var_119 = 13;
        const wp::int32 var_120 = 2;
        wp::float64 var_121;
        const wp::int32 var_122 = 14;
        const wp::int32 var_123 = 3;
        wp::float64 var_124;
        const wp::int32 var_125 = 15;
        const wp::int32 var_126 = 16;
        wp::float64 var_127;
        const wp::int32 var_128 = 17;
        wp::float64 var_129;
        const wp::int32 var_130 = 18;
        wp::float64 var_131;
        const wp::int32 var_132 = 19;
        wp::float64 var_133;
        wp::vec_t<4, wp::float64> var_134;
        const bool var_135 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_136 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_137 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_138 = 0;
        wp::vec_t<4, wp::float64> var_139;
        const wp::int32 var_140 = 0;
        wp::float64 var_141;
        const wp::int32 var_142 = 16;
        const wp::int32 var_143 = 1;
        wp::float64 var_144;
        const wp::int32 var_145 = 17;
        const wp::int32 var_146 = 2;
        wp::float64 var_147;
        const wp::int32 var_148 = 18;
        const wp::int32 var_149 = 3;
        wp::float64 var_150;
        const wp::int32 var_151 = 19;
        const wp::int32 var_152 = 20;
        wp::float64 var_153;
        const wp::int32 var_154 = 21;
        wp::float64 var_155;
        const wp::int32 var_156 = 22;
        wp::float64 var_157;
        const wp::int32 var_158 = 23;
        wp::float64 var_159;
        wp::vec_t<4, wp::float64> var_160;
        const bool var_161 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_162 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_163 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_164 = 0;
        wp::vec_t<4, wp::float64> var_165;
        const wp::int32 var_166 = 0;
        wp::float64 var_167;
        const wp::int32 var_168 = 20;
        const wp::int32 var_169 = 1;
        wp::float64 var_170;
        const wp::int32 var_171 = 21;
        const wp::int32 var_172 = 2;
        wp::float64 var_173;
        const wp::int32 var_174 = 22;
        const wp::int32 var_175 = 3;
        wp::float64 var_176;
        const wp::int32 var_177 = 23;
        const wp::int32 var_178 = 24;
        wp::float64 var_179;
        const wp::int32 var_180 = 25;
        wp::float64 var_181;
        const wp::int32 var_182 = 26;
        wp::float64 var_183;
        const wp::int32 var_184 = 27;
        wp::float64 var_185;
        wp::vec_t<4, wp::float64> var_186;
        const bool var_187 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_188 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_189 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_190 = 0;
        wp::vec_t<4, wp::float64> var_191;
        const wp::int32 var_192 = 0;
        wp::float64 var_193;
        const wp::int32 var_194 = 24;
        const wp::int32 var_195 = 1;
        wp::float64 var_196;
        const wp::int32 var_197 = 25;
        const wp::int32 var_198 = 2;
        wp::float64 var_199;
        const wp::int32 var_200 = 26;
        const wp::int32 var_201 = 3;
        wp::float64 var_202;
        const wp::int32 var_203 = 27;
        const wp::int32 var_204 = 28;
        wp::float64 var_205;
        const wp::int32 var_206 = 29;
        wp::float64 var_207;
        const wp::int32 var_208 = 30;
        wp::float64 var_209;
        const wp::int32 var_210 = 31;
        wp::float64 var_211;
        wp::vec_t<4, wp::float64> var_212;
        const bool var_213 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_214 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_215 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_216 = 0;
        wp::vec_t<4, wp::float64> var_217;
        const wp::int32 var_218 = 0;
        wp::float64 var_219;
        const wp::int32 var_220 = 28;
        const wp::int32 var_221 = 1;
        wp::float64 var_222;
        const wp::int32 var_223 = 29;
        const wp::int32 var_224 = 2;
        wp::float64 var_225;
        const wp::int32 var_226 = 30;
        const wp::int32 var_227 = 3;
        wp::float64 var_228;
        const wp::int32 var_229 = 31;
        const wp::int32 var_230 = 32;
        wp::float64 var_231;
        const wp::int32 var_232 = 33;
        wp::float64 var_233;
        const wp::int32 var_234 = 34;
        wp::float64 var_235;
        const wp::int32 var_236 = 35;
        wp::float64 var_237;
        wp::vec_t<4, wp::float64> var_238;
        const bool var_239 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_240 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_241 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_242 = 0;
        wp::vec_t<4, wp::float64> var_243;
        const wp::int32 var_244 = 0;
        wp::float64 var_245;
        const wp::int32 var_246 = 32;
        const wp::int32 var_247 = 1;
        wp::float64 var_248;
        const wp::int32 var_249 = 33;
        const wp::int32 var_250 = 2;
        wp::float64 var_251;
        const wp::int32 var_252 = 34;
        const wp::int32 var_253 = 3;
        wp::float64 var_254;
        const wp::int32 var_255 = 35;
        const wp::int32 var_256 = 256;
        wp::int32 var_257;
        const wp::int32 var_258 = 0;
        bool var_259;
        //---------
        // forward
        // def sum_symmetric_rows_tiles(matches__jobs__sources__points, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__targets, matches__poses, matches__pairs, matches__weighted, matches__weights, loss__kind, loss__k, loss__shape, source__normals, target__normals, firsts_, lasts_, owners_, live_, partials_):       <L 1>
        // i_ = wp.tid()                                                                          <L 2>
        var_0 = builtin_tid1d();
        // b_ = i_ // 256                                                                         <L 3>
        var_2 = wp::floordiv(var_0, var_1);
        // value_ = vector_()                                                                     <L 4>
        var_3 = wp::vec_t<36, wp::float64>();
        // if live_[owners_[b_]] != 0:                                                            <L 5>
        var_4 = wp::address(var_owners_, var_2);
        var_5 = wp::load(var_4);
        var_6 = wp::address(var_live_, var_5);
        var_9 = wp::load(var_6);
        var_8 = (var_9 != var_7);
        if (var_8) {
            // for j_ in range(firsts_[b_] + i_ % 256, lasts_[b_], 256):                          <L 6>
            var_10 = wp::address(var_firsts_, var_2);
            var_12 = wp::mod(var_0, var_11);
            var_14 = wp::load(var_10);
            var_13 = wp::add(var_14, var_12);
            var_15 = wp::address(var_lasts_, var_2);
            var_18 = wp::load(var_15);
            var_17 = wp::range(var_13, var_18, var_16);
            start_for_0:;
                if (iter_cmp(var_17) == 0) goto end_for_0;
                var_19 = wp::iter_next(var_17);
                // value_ += element_(matches__jobs__sources__points, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__targets, matches__poses, matches__pairs, matches__weighted, matches__weights, loss__kind, loss__k, loss__shape, source__normals, target__normals, j_)       <L 7>
                var_20 = sum_symmetric_rows_element_0(var_matches__jobs__sources__points, var_matches__jobs__sources__first_positions, var_matches__jobs__group_jobs, var_matches__jobs__job_groups, var_matches__jobs__job_sources, var_matches__targets, var_matches__poses, var_matches__pairs, var_matches__weighted, var_matches__weights, var_loss__kind, var_loss__k, var_loss__shape, var_source__normals, var_target__normals, var_19);
                var_21 = wp::add(var_3, var_20);
                wp::assign(var_3, var_21);
                goto start_for_0;
            end_for_0:;
        }
        // part_0 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[0], value_[1], value_[2], value_[3]), preserve_type=True)), 0)       <L 8>
        var_23 = wp::extract(var_3, var_22);
        var_25 = wp::extract(var_3, var_24);
        var_27 = wp::extract(var_3, var_26);
        var_29 = wp::extract(var_3, var_28);
        var_30 = wp::vec_t<4, wp::float64>(var_23, var_25, var_27, var_29);
        var_32 = wp::tile<wp::vec_t<4, wp::float64>>(var_30);
        var_33 = wp::tile_sum(var_32);
        var_35 = wp::tile_extract(var_33, var_34);
        // value_[0] = part_0[0]                                                                  <L 9>
        var_37 = wp::extract(var_35, var_36);
        wp::assign_inplace(var_3, var_38, var_37);
        // value_[1] = part_0[1]                                                                  <L 10>
        var_40 = wp::extract(var_35, var_39);
        wp::assign_inplace(var_3, var_41, var_40);
        // value_[2] = part_0[2]                                                                  <L 11>
        var_43 = wp::extract(var_35, var_42);
        wp::assign_inplace(var_3, var_44, var_43);
        // value_[3] = part_0[3]                                                                  <L 12>
        var_46 = wp::extract(var_35, var_45);
        wp::assign_inplace(var_3, var_47, var_46);
        // part_4 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[4], value_[5], value_[6], value_[7]), preserve_type=True)), 0)       <L 13>
        var_49 = wp::extract(var_3, var_48);
        var_51 = wp::extract(var_3, var_50);
        var_53 = wp::extract(var_3, var_52);
        var_55 = wp::extract(var_3, var_54);
        var_56 = wp::vec_t<4, wp::float64>(var_49, var_51, var_53, var_55);
        var_58 = wp::tile<wp::vec_t<4, wp::float64>>(var_56);
        var_59 = wp::tile_sum(var_58);
        var_61 = wp::tile_extract(var_59, var_60);
        // value_[4] = part_4[0]                                                                  <L 14>
        var_63 = wp::extract(var_61, var_62);
        wp::assign_inplace(var_3, var_64, var_63);
        // value_[5] = part_4[1]                                                                  <L 15>
        var_66 = wp::extract(var_61, var_65);
        wp::assign_inplace(var_3, var_67, var_66);
        // value_[6] = part_4[2]                                                                  <L 16>
        var_69 = wp::extract(var_61, var_68);
        wp::assign_inplace(var_3, var_70, var_69);
        // value_[7] = part_4[3]                                                                  <L 17>
        var_72 = wp::extract(var_61, var_71);
        wp::assign_inplace(var_3, var_73, var_72);
        // part_8 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[8], value_[9], value_[10], value_[11]), preserve_type=True)), 0)       <L 18>
        var_75 = wp::extract(var_3, var_74);
        var_77 = wp::extract(var_3, var_76);
        var_79 = wp::extract(var_3, var_78);
        var_81 = wp::extract(var_3, var_80);
        var_82 = wp::vec_t<4, wp::float64>(var_75, var_77, var_79, var_81);
        var_84 = wp::tile<wp::vec_t<4, wp::float64>>(var_82);
        var_85 = wp::tile_sum(var_84);
        var_87 = wp::tile_extract(var_85, var_86);
        // value_[8] = part_8[0]                                                                  <L 19>
        var_89 = wp::extract(var_87, var_88);
        wp::assign_inplace(var_3, var_90, var_89);
        // value_[9] = part_8[1]                                                                  <L 20>
        var_92 = wp::extract(var_87, var_91);
        wp::assign_inplace(var_3, var_93, var_92);
        // value_[10] = part_8[2]                                                                 <L 21>
        var_95 = wp::extract(var_87, var_94);
        wp::assign_inplace(var_3, var_96, var_95);
        // value_[11] = part_8[3]                                                                 <L 22>
        var_98 = wp::extract(var_87, var_97);
        wp::assign_inplace(var_3, var_99, var_98);
        // part_12 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[12], value_[13], value_[14], value_[15]), preserve_type=True)), 0)       <L 23>
        var_101 = wp::extract(var_3, var_100);
        var_103 = wp::extract(var_3, var_102);
        var_105 = wp::extract(var_3, var_104);
        var_107 = wp::extract(var_3, var_106);
        var_108 = wp::vec_t<4, wp::float64>(var_101, var_103, var_105, var_107);
        var_110 = wp::tile<wp::vec_t<4, wp::float64>>(var_108);
        var_111 = wp::tile_sum(var_110);
        var_113 = wp::tile_extract(var_111, var_112);
        // value_[12] = part_12[0]                                                                <L 24>
        var_115 = wp::extract(var_113, var_114);
        wp::assign_inplace(var_3, var_116, var_115);
        // value_[13] = part_12[1]                                                                <L 25>
        var_118 = wp::extract(var_113, var_117);
        wp::assign_inplace(var_3, var_119, var_118);
        // value_[14] = part_12[2]                                                                <L 26>
        var_121 = wp::extract(var_113, var_120);
        wp::assign_inplace(var_3, var_122, var_121);
        // value_[15] = part_12[3]                                                                <L 27>
        var_124 = wp::extract(var_113, var_123);
        wp::assign_inplace(var_3, var_125, var_124);
        // part_16 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[16], value_[17], value_[18], value_[19]), preserve_type=True)), 0)       <L 28>
        var_127 = wp::extract(var_3, var_126);
        var_129 = wp::extract(var_3, var_128);
        var_131 = wp::extract(var_3, var_130);
        var_133 = wp::extract(var_3, var_132);
        var_134 = wp::vec_t<4, wp::float64>(var_127, var_129, var_131, var_133);
        var_136 = wp::tile<wp::vec_t<4, wp::float64>>(var_134);
        var_137 = wp::tile_sum(var_136);
        var_139 = wp::tile_extract(var_137, var_138);
        // value_[16] = part_16[0]                                                                <L 29>
        var_141 = wp::extract(var_139, var_140);
        wp::assign_inplace(var_3, var_142, var_141);
        // value_[17] = part_16[1]                                                                <L 30>
        var_144 = wp::extract(var_139, var_143);
        wp::assign_inplace(var_3, var_145, var_144);
        // value_[18] = part_16[2]                                                                <L 31>
        var_147 = wp::extract(var_139, var_146);
        wp::assign_inplace(var_3, var_148, var_147);
        // value_[19] = part_16[3]                                                                <L 32>
        var_150 = wp::extract(var_139, var_149);
        wp::assign_inplace(var_3, var_151, var_150);
        // part_20 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[20], value_[21], value_[22], value_[23]), preserve_type=True)), 0)       <L 33>
        var_153 = wp::extract(var_3, var_152);
        var_155 = wp::extract(var_3, var_154);
        var_157 = wp::extract(var_3, var_156);
        var_159 = wp::extract(var_3, var_158);
        var_160 = wp::vec_t<4, wp::float64>(var_153, var_155, var_157, var_159);
        var_162 = wp::tile<wp::vec_t<4, wp::float64>>(var_160);
        var_163 = wp::tile_sum(var_162);
        var_165 = wp::tile_extract(var_163, var_164);
        // value_[20] = part_20[0]                                                                <L 34>
        var_167 = wp::extract(var_165, var_166);
        wp::assign_inplace(var_3, var_168, var_167);
        // value_[21] = part_20[1]                                                                <L 35>
        var_170 = wp::extract(var_165, var_169);
        wp::assign_inplace(var_3, var_171, var_170);
        // value_[22] = part_20[2]                                                                <L 36>
        var_173 = wp::extract(var_165, var_172);
        wp::assign_inplace(var_3, var_174, var_173);
        // value_[23] = part_20[3]                                                                <L 37>
        var_176 = wp::extract(var_165, var_175);
        wp::assign_inplace(var_3, var_177, var_176);
        // part_24 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[24], value_[25], value_[26], value_[27]), preserve_type=True)), 0)       <L 38>
        var_179 = wp::extract(var_3, var_178);
        var_181 = wp::extract(var_3, var_180);
        var_183 = wp::extract(var_3, var_182);
        var_185 = wp::extract(var_3, var_184);
        var_186 = wp::vec_t<4, wp::float64>(var_179, var_181, var_183, var_185);
        var_188 = wp::tile<wp::vec_t<4, wp::float64>>(var_186);
        var_189 = wp::tile_sum(var_188);
        var_191 = wp::tile_extract(var_189, var_190);
        // value_[24] = part_24[0]                                                                <L 39>
        var_193 = wp::extract(var_191, var_192);
        wp::assign_inplace(var_3, var_194, var_193);
        // value_[25] = part_24[1]                                                                <L 40>
        var_196 = wp::extract(var_191, var_195);
        wp::assign_inplace(var_3, var_197, var_196);
        // value_[26] = part_24[2]                                                                <L 41>
        var_199 = wp::extract(var_191, var_198);
        wp::assign_inplace(var_3, var_200, var_199);
        // value_[27] = part_24[3]                                                                <L 42>
        var_202 = wp::extract(var_191, var_201);
        wp::assign_inplace(var_3, var_203, var_202);
        // part_28 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[28], value_[29], value_[30], value_[31]), preserve_type=True)), 0)       <L 43>
        var_205 = wp::extract(var_3, var_204);
        var_207 = wp::extract(var_3, var_206);
        var_209 = wp::extract(var_3, var_208);
        var_211 = wp::extract(var_3, var_210);
        var_212 = wp::vec_t<4, wp::float64>(var_205, var_207, var_209, var_211);
        var_214 = wp::tile<wp::vec_t<4, wp::float64>>(var_212);
        var_215 = wp::tile_sum(var_214);
        var_217 = wp::tile_extract(var_215, var_216);
        // value_[28] = part_28[0]                                                                <L 44>
        var_219 = wp::extract(var_217, var_218);
        wp::assign_inplace(var_3, var_220, var_219);
        // value_[29] = part_28[1]                                                                <L 45>
        var_222 = wp::extract(var_217, var_221);
        wp::assign_inplace(var_3, var_223, var_222);
        // value_[30] = part_28[2]                                                                <L 46>
        var_225 = wp::extract(var_217, var_224);
        wp::assign_inplace(var_3, var_226, var_225);
        // value_[31] = part_28[3]                                                                <L 47>
        var_228 = wp::extract(var_217, var_227);
        wp::assign_inplace(var_3, var_229, var_228);
        // part_32 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[32], value_[33], value_[34], value_[35]), preserve_type=True)), 0)       <L 48>
        var_231 = wp::extract(var_3, var_230);
        var_233 = wp::extract(var_3, var_232);
        var_235 = wp::extract(var_3, var_234);
        var_237 = wp::extract(var_3, var_236);
        var_238 = wp::vec_t<4, wp::float64>(var_231, var_233, var_235, var_237);
        var_240 = wp::tile<wp::vec_t<4, wp::float64>>(var_238);
        var_241 = wp::tile_sum(var_240);
        var_243 = wp::tile_extract(var_241, var_242);
        // value_[32] = part_32[0]                                                                <L 49>
        var_245 = wp::extract(var_243, var_244);
        wp::assign_inplace(var_3, var_246, var_245);
        // value_[33] = part_32[1]                                                                <L 50>
        var_248 = wp::extract(var_243, var_247);
        wp::assign_inplace(var_3, var_249, var_248);
        // value_[34] = part_32[2]                                                                <L 51>
        var_251 = wp::extract(var_243, var_250);
        wp::assign_inplace(var_3, var_252, var_251);
        // value_[35] = part_32[3]                                                                <L 52>
        var_254 = wp::extract(var_243, var_253);
        wp::assign_inplace(var_3, var_255, var_254);
        // if i_ % 256 == 0:                                                                      <L 53>
        var_257 = wp::mod(var_0, var_256);
        var_259 = (var_257 == var_258);
        if (var_259) {
            // partials_[b_] = value_                                                             <L 54>
            wp::array_store(var_partials_, var_2, var_3);
        }
}



extern "C" __global__ void WP_MAXNREG(128) sum_point_rows_tiles_cdbef9cf_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__jobs__sources__points,
    wp::array_t<wp::int32> var_matches__jobs__sources__first_positions,
    wp::array_t<wp::int32> var_matches__jobs__group_jobs,
    wp::array_t<wp::int32> var_matches__jobs__job_groups,
    wp::array_t<wp::int32> var_matches__jobs__job_sources,
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__targets,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_matches__poses,
    wp::array_t<wp::int32> var_matches__pairs,
    wp::int32 var_matches__weighted,
    wp::array_t<wp::float32> var_matches__weights,
    wp::int32 var_loss__kind,
    wp::float64 var_loss__k,
    wp::float64 var_loss__shape,
    wp::array_t<wp::vec_t<3, wp::float64>> var_pivots,
    wp::array_t<wp::int32> var_firsts_,
    wp::array_t<wp::int32> var_lasts_,
    wp::array_t<wp::int32> var_owners_,
    wp::array_t<wp::int32> var_live_,
    wp::array_t<wp::vec_t<36, wp::float64>> var_partials_)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        const wp::int32 var_1 = 256;
        wp::int32 var_2;
        wp::vec_t<36, wp::float64> var_3;
        wp::int32* var_4;
        wp::int32 var_5;
        wp::int32* var_6;
        const wp::int32 var_7 = 0;
        bool var_8;
        wp::int32 var_9;
        wp::int32* var_10;
        const wp::int32 var_11 = 256;
        wp::int32 var_12;
        wp::int32 var_13;
        wp::int32 var_14;
        wp::int32* var_15;
        const wp::int32 var_16 = 256;
        wp::range_t var_17;
        wp::int32 var_18;
        wp::int32 var_19;
        wp::vec_t<36, wp::float64> var_20;
        wp::vec_t<36, wp::float64> var_21;
        const wp::int32 var_22 = 0;
        wp::float64 var_23;
        const wp::int32 var_24 = 1;
        wp::float64 var_25;
        const wp::int32 var_26 = 2;
        wp::float64 var_27;
        const wp::int32 var_28 = 3;
        wp::float64 var_29;
        wp::vec_t<4, wp::float64> var_30;
        const bool var_31 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_32 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_33 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_34 = 0;
        wp::vec_t<4, wp::float64> var_35;
        const wp::int32 var_36 = 0;
        wp::float64 var_37;
        const wp::int32 var_38 = 0;
        const wp::int32 var_39 = 1;
        wp::float64 var_40;
        const wp::int32 var_41 = 1;
        const wp::int32 var_42 = 2;
        wp::float64 var_43;
        const wp::int32 var_44 = 2;
        const wp::int32 var_45 = 3;
        wp::float64 var_46;
        const wp::int32 var_47 = 3;
        const wp::int32 var_48 = 4;
        wp::float64 var_49;
        const wp::int32 var_50 = 5;
        wp::float64 var_51;
        const wp::int32 var_52 = 6;
        wp::float64 var_53;
        const wp::int32 var_54 = 7;
        wp::float64 var_55;
        wp::vec_t<4, wp::float64> var_56;
        const bool var_57 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_58 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_59 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_60 = 0;
        wp::vec_t<4, wp::float64> var_61;
        const wp::int32 var_62 = 0;
        wp::float64 var_63;
        const wp::int32 var_64 = 4;
        const wp::int32 var_65 = 1;
        wp::float64 var_66;
        const wp::int32 var_67 = 5;
        const wp::int32 var_68 = 2;
        wp::float64 var_69;
        const wp::int32 var_70 = 6;
        const wp::int32 var_71 = 3;
        wp::float64 var_72;
        const wp::int32 var_73 = 7;
        const wp::int32 var_74 = 8;
        wp::float64 var_75;
        const wp::int32 var_76 = 9;
        wp::float64 var_77;
        const wp::int32 var_78 = 10;
        wp::float64 var_79;
        const wp::int32 var_80 = 11;
        wp::float64 var_81;
        wp::vec_t<4, wp::float64> var_82;
        const bool var_83 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_84 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_85 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_86 = 0;
        wp::vec_t<4, wp::float64> var_87;
        const wp::int32 var_88 = 0;
        wp::float64 var_89;
        const wp::int32 var_90 = 8;
        const wp::int32 var_91 = 1;
        wp::float64 var_92;
        const wp::int32 var_93 = 9;
        const wp::int32 var_94 = 2;
        wp::float64 var_95;
        const wp::int32 var_96 = 10;
        const wp::int32 var_97 = 3;
        wp::float64 var_98;
        const wp::int32 var_99 = 11;
        const wp::int32 var_100 = 12;
        wp::float64 var_101;
        const wp::int32 var_102 = 13;
        wp::float64 var_103;
        const wp::int32 var_104 = 14;
        wp::float64 var_105;
        const wp::int32 var_106 = 15;
        wp::float64 var_107;
        wp::vec_t<4, wp::float64> var_108;
        const bool var_109 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_110 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_111 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_112 = 0;
        wp::vec_t<4, wp::float64> var_113;
        const wp::int32 var_114 = 0;
        wp::float64 var_115;
        const wp::int32 var_116 = 12;
        const wp::int32 var_117 = 1;
        wp::float64 var_118;
        const wp::int32 var_119 = 13;
        const wp::int32 var_120 = 2;
        wp::float64 var_121;
        const wp::int32 var_122 = 14;
        const wp::int32 var_123 = 3;
        wp::float64 var_124;
        const wp::int32 var_125 = 15;
        const wp::int32 var_126 = 16;
        wp::float64 var_127;
        const wp::int32 var_128 = 17;
        wp::float64 var_129;
        const wp::int32 var_130 = 18;
        wp::float64 var_131;
        const wp::int32 var_132 = 19;
        wp::float64 var_133;
        wp::vec_t<4, wp::float64> var_134;
        const bool var_135 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_136 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_137 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_138 = 0;
        wp::vec_t<4, wp::float64> var_139;
        const wp::int32 var_140 = 0;
        wp::float64 var_141;
        const wp::int32 var_142 = 16;
        const wp::int32 var_143 = 1;
        wp::float64 var_144;
        const wp::int32 var_145 = 17;
        const wp::int32 var_146 = 2;
        wp::float64 var_147;
        const wp::int32 var_148 = 18;
        const wp::int32 var_149 = 3;
        wp::float64 var_150;
        const wp::int32 var_151 = 19;
        const wp::int32 var_152 = 20;
        wp::float64 var_153;
        const wp::int32 var_154 = 21;
        wp::float64 var_155;
        const wp::int32 var_156 = 22;
        wp::float64 var_157;
        const wp::int32 var_158 = 23;
        wp::float64 var_159;
        wp::vec_t<4, wp::float64> var_160;
        const bool var_161 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_162 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_163 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_164 = 0;
        wp::vec_t<4, wp::float64> var_165;
        const wp::int32 var_166 = 0;
        wp::float64 var_167;
        const wp::int32 var_168 = 20;
        const wp::int32 var_169 = 1;
        wp::float64 var_170;
        const wp::int32 var_171 = 21;
        const wp::int32 var_172 = 2;
        wp::float64 var_173;
        const wp::int32 var_174 = 22;
        const wp::int32 var_175 = 3;
        wp::float64 var_176;
        const wp::int32 var_177 = 23;
        const wp::int32 var_178 = 24;
        wp::float64 var_179;
        const wp::int32 var_180 = 25;
        wp::float64 var_181;
        const wp::int32 var_182 = 26;
        wp::float64 var_183;
        const wp::int32 var_184 = 27;
        wp::float64 var_185;
        wp::vec_t<4, wp::float64> var_186;
        const bool var_187 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_188 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_189 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_190 = 0;
        wp::vec_t<4, wp::float64> var_191;
        const wp::int32 var_192 = 0;
        wp::float64 var_193;
        const wp::int32 var_194 = 24;
        const wp::int32 var_195 = 1;
        wp::float64 var_196;
        const wp::int32 var_197 = 25;
        const wp::int32 var_198 = 2;
        wp::float64 var_199;
        const wp::int32 var_200 = 26;
        const wp::int32 var_201 = 3;
        wp::float64 var_202;
        const wp::int32 var_203 = 27;
        const wp::int32 var_204 = 28;
        wp::float64 var_205;
        const wp::int32 var_206 = 29;
        wp::float64 var_207;
        const wp::int32 var_208 = 30;
        wp::float64 var_209;
        const wp::int32 var_210 = 31;
        wp::float64 var_211;
        wp::vec_t<4, wp::float64> var_212;
        const bool var_213 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_214 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_215 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_216 = 0;
        wp::vec_t<4, wp::float64> var_217;
        const wp::int32 var_218 = 0;
        wp::float64 var_219;
        const wp::int32 var_220 = 28;
        const wp::int32 var_221 = 1;
        wp::float64 var_222;
        const wp::int32 var_223 = 29;
        const wp::int32 var_224 = 2;
        wp::float64 var_225;
        const wp::int32 var_226 = 30;
        const wp::int32 var_227 = 3;
        wp::float64 var_228;
        const wp::int32 var_229 = 31;
        const wp::int32 var_230 = 32;
        wp::float64 var_231;
        const wp::int32 var_232 = 33;
        wp::float64 var_233;
        const wp::int32 var_234 = 34;
        wp::float64 var_235;
        const wp::int32 var_236 = 35;
        wp::float64 var_237;
        wp::vec_t<4, wp::float64> var_238;
        const bool var_239 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_240 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_241 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_242 = 0;
        wp::vec_t<4, wp::float64> var_243;
        const wp::int32 var_244 = 0;
        wp::float64 var_245;
        const wp::int32 var_246 = 32;
        const wp::int32 var_247 = 1;
        wp::float64 var_248;
        const wp::int32 var_249 = 33;
        const wp::int32 var_250 = 2;
        wp::float64 var_251;
        const wp::int32 var_252 = 34;
        const wp::int32 var_253 = 3;
        wp::float64 var_254;
        const wp::int32 var_255 = 35;
        const wp::int32 var_256 = 256;
        wp::int32 var_257;
        const wp::int32 var_258 = 0;
        bool var_259;
        //---------
        // forward
        // def sum_point_rows_tiles(matches__jobs__sources__points, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__targets, matches__poses, matches__pairs, matches__weighted, matches__weights, loss__kind, loss__k, loss__shape, pivots, firsts_, lasts_, owners_, live_, partials_):       <L 1>
        // i_ = wp.tid()                                                                          <L 2>
        var_0 = builtin_tid1d();
        // b_ = i_ // 256                                                                         <L 3>
        var_2 = wp::floordiv(var_0, var_1);
        // value_ = vector_()                                                                     <L 4>
        var_3 = wp::vec_t<36, wp::float64>();
        // if live_[owners_[b_]] != 0:                                                            <L 5>
        var_4 = wp::address(var_owners_, var_2);
        var_5 = wp::load(var_4);
        var_6 = wp::address(var_live_, var_5);
        var_9 = wp::load(var_6);
        var_8 = (var_9 != var_7);
        if (var_8) {
            // for j_ in range(firsts_[b_] + i_ % 256, lasts_[b_], 256):                          <L 6>
            var_10 = wp::address(var_firsts_, var_2);
            var_12 = wp::mod(var_0, var_11);
            var_14 = wp::load(var_10);
            var_13 = wp::add(var_14, var_12);
            var_15 = wp::address(var_lasts_, var_2);
            var_18 = wp::load(var_15);
            var_17 = wp::range(var_13, var_18, var_16);
            start_for_0:;
                if (iter_cmp(var_17) == 0) goto end_for_0;
                var_19 = wp::iter_next(var_17);
                // value_ += element_(matches__jobs__sources__points, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__targets, matches__poses, matches__pairs, matches__weighted, matches__weights, loss__kind, loss__k, loss__shape, pivots, j_)       <L 7>
                var_20 = sum_point_rows_element_0(var_matches__jobs__sources__points, var_matches__jobs__sources__first_positions, var_matches__jobs__group_jobs, var_matches__jobs__job_groups, var_matches__jobs__job_sources, var_matches__targets, var_matches__poses, var_matches__pairs, var_matches__weighted, var_matches__weights, var_loss__kind, var_loss__k, var_loss__shape, var_pivots, var_19);
                var_21 = wp::add(var_3, var_20);
                wp::assign(var_3, var_21);
                goto start_for_0;
            end_for_0:;
        }
        // part_0 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[0], value_[1], value_[2], value_[3]), preserve_type=True)), 0)       <L 8>
        var_23 = wp::extract(var_3, var_22);
        var_25 = wp::extract(var_3, var_24);
        var_27 = wp::extract(var_3, var_26);
        var_29 = wp::extract(var_3, var_28);
        var_30 = wp::vec_t<4, wp::float64>(var_23, var_25, var_27, var_29);
        var_32 = wp::tile<wp::vec_t<4, wp::float64>>(var_30);
        var_33 = wp::tile_sum(var_32);
        var_35 = wp::tile_extract(var_33, var_34);
        // value_[0] = part_0[0]                                                                  <L 9>
        var_37 = wp::extract(var_35, var_36);
        wp::assign_inplace(var_3, var_38, var_37);
        // value_[1] = part_0[1]                                                                  <L 10>
        var_40 = wp::extract(var_35, var_39);
        wp::assign_inplace(var_3, var_41, var_40);
        // value_[2] = part_0[2]                                                                  <L 11>
        var_43 = wp::extract(var_35, var_42);
        wp::assign_inplace(var_3, var_44, var_43);
        // value_[3] = part_0[3]                                                                  <L 12>
        var_46 = wp::extract(var_35, var_45);
        wp::assign_inplace(var_3, var_47, var_46);
        // part_4 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[4], value_[5], value_[6], value_[7]), preserve_type=True)), 0)       <L 13>
        var_49 = wp::extract(var_3, var_48);
        var_51 = wp::extract(var_3, var_50);
        var_53 = wp::extract(var_3, var_52);
        var_55 = wp::extract(var_3, var_54);
        var_56 = wp::vec_t<4, wp::float64>(var_49, var_51, var_53, var_55);
        var_58 = wp::tile<wp::vec_t<4, wp::float64>>(var_56);
        var_59 = wp::tile_sum(var_58);
        var_61 = wp::tile_extract(var_59, var_60);
        // value_[4] = part_4[0]                                                                  <L 14>
        var_63 = wp::extract(var_61, var_62);
        wp::assign_inplace(var_3, var_64, var_63);
        // value_[5] = part_4[1]                                                                  <L 15>
        var_66 = wp::extract(var_61, var_65);
        wp::assign_inplace(var_3, var_67, var_66);
        // value_[6] = part_4[2]                                                                  <L 16>
        var_69 = wp::extract(var_61, var_68);
        wp::assign_inplace(var_3, var_70, var_69);
        // value_[7] = part_4[3]                                                                  <L 17>
        var_72 = wp::extract(var_61, var_71);
        wp::assign_inplace(var_3, var_73, var_72);
        // part_8 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[8], value_[9], value_[10], value_[11]), preserve_type=True)), 0)       <L 18>
        var_75 = wp::extract(var_3, var_74);
        var_77 = wp::extract(var_3, var_76);
        var_79 = wp::extract(var_3, var_78);
        var_81 = wp::extract(var_3, var_80);
        var_82 = wp::vec_t<4, wp::float64>(var_75, var_77, var_79, var_81);
        var_84 = wp::tile<wp::vec_t<4, wp::float64>>(var_82);
        var_85 = wp::tile_sum(var_84);
        var_87 = wp::tile_extract(var_85, var_86);
        // value_[8] = part_8[0]                                                                  <L 19>
        var_89 = wp::extract(var_87, var_88);
        wp::assign_inplace(var_3, var_90, var_89);
        // value_[9] = part_8[1]                                                                  <L 20>
        var_92 = wp::extract(var_87, var_91);
        wp::assign_inplace(var_3, var_93, var_92);
        // value_[10] = part_8[2]                                                                 <L 21>
        var_95 = wp::extract(var_87, var_94);
        wp::assign_inplace(var_3, var_96, var_95);
        // value_[11] = part_8[3]                                                                 <L 22>
        var_98 = wp::extract(var_87, var_97);
        wp::assign_inplace(var_3, var_99, var_98);
        // part_12 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[12], value_[13], value_[14], value_[15]), preserve_type=True)), 0)       <L 23>
        var_101 = wp::extract(var_3, var_100);
        var_103 = wp::extract(var_3, var_102);
        var_105 = wp::extract(var_3, var_104);
        var_107 = wp::extract(var_3, var_106);
        var_108 = wp::vec_t<4, wp::float64>(var_101, var_103, var_105, var_107);
        var_110 = wp::tile<wp::vec_t<4, wp::float64>>(var_108);
        var_111 = wp::tile_sum(var_110);
        var_113 = wp::tile_extract(var_111, var_112);
        // value_[12] = part_12[0]                                                                <L 24>
        var_115 = wp::extract(var_113, var_114);
        wp::assign_inplace(var_3, var_116, var_115);
        // value_[13] = part_12[1]                                                                <L 25>
        var_118 = wp::extract(var_113, var_117);
        wp::assign_inplace(var_3, var_119, var_118);
        // value_[14] = part_12[2]                                                                <L 26>
        var_121 = wp::extract(var_113, var_120);
        wp::assign_inplace(var_3, var_122, var_121);
        // value_[15] = part_12[3]                                                                <L 27>
        var_124 = wp::extract(var_113, var_123);
        wp::assign_inplace(var_3, var_125, var_124);
        // part_16 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[16], value_[17], value_[18], value_[19]), preserve_type=True)), 0)       <L 28>
        var_127 = wp::extract(var_3, var_126);
        var_129 = wp::extract(var_3, var_128);
        var_131 = wp::extract(var_3, var_130);
        var_133 = wp::extract(var_3, var_132);
        var_134 = wp::vec_t<4, wp::float64>(var_127, var_129, var_131, var_133);
        var_136 = wp::tile<wp::vec_t<4, wp::float64>>(var_134);
        var_137 = wp::tile_sum(var_136);
        var_139 = wp::tile_extract(var_137, var_138);
        // value_[16] = part_16[0]                                                                <L 29>
        var_141 = wp::extract(var_139, var_140);
        wp::assign_inplace(var_3, var_142, var_141);
        // value_[17] = part_16[1]                                                                <L 30>
        var_144 = wp::extract(var_139, var_143);
        wp::assign_inplace(var_3, var_145, var_144);
        // value_[18] = part_16[2]                                                                <L 31>
        var_147 = wp::extract(var_139, var_146);
        wp::assign_inplace(var_3, var_148, var_147);
        // value_[19] = part_16[3]                                                                <L 32>
        var_150 = wp::extract(var_139, var_149);
        wp::assign_inplace(var_3, var_151, var_150);
        // part_20 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[20], value_[21], value_[22], value_[23]), preserve_type=True)), 0)       <L 33>
        var_153 = wp::extract(var_3, var_152);
        var_155 = wp::extract(var_3, var_154);
        var_157 = wp::extract(var_3, var_156);
        var_159 = wp::extract(var_3, var_158);
        var_160 = wp::vec_t<4, wp::float64>(var_153, var_155, var_157, var_159);
        var_162 = wp::tile<wp::vec_t<4, wp::float64>>(var_160);
        var_163 = wp::tile_sum(var_162);
        var_165 = wp::tile_extract(var_163, var_164);
        // value_[20] = part_20[0]                                                                <L 34>
        var_167 = wp::extract(var_165, var_166);
        wp::assign_inplace(var_3, var_168, var_167);
        // value_[21] = part_20[1]                                                                <L 35>
        var_170 = wp::extract(var_165, var_169);
        wp::assign_inplace(var_3, var_171, var_170);
        // value_[22] = part_20[2]                                                                <L 36>
        var_173 = wp::extract(var_165, var_172);
        wp::assign_inplace(var_3, var_174, var_173);
        // value_[23] = part_20[3]                                                                <L 37>
        var_176 = wp::extract(var_165, var_175);
        wp::assign_inplace(var_3, var_177, var_176);
        // part_24 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[24], value_[25], value_[26], value_[27]), preserve_type=True)), 0)       <L 38>
        var_179 = wp::extract(var_3, var_178);
        var_181 = wp::extract(var_3, var_180);
        var_183 = wp::extract(var_3, var_182);
        var_185 = wp::extract(var_3, var_184);
        var_186 = wp::vec_t<4, wp::float64>(var_179, var_181, var_183, var_185);
        var_188 = wp::tile<wp::vec_t<4, wp::float64>>(var_186);
        var_189 = wp::tile_sum(var_188);
        var_191 = wp::tile_extract(var_189, var_190);
        // value_[24] = part_24[0]                                                                <L 39>
        var_193 = wp::extract(var_191, var_192);
        wp::assign_inplace(var_3, var_194, var_193);
        // value_[25] = part_24[1]                                                                <L 40>
        var_196 = wp::extract(var_191, var_195);
        wp::assign_inplace(var_3, var_197, var_196);
        // value_[26] = part_24[2]                                                                <L 41>
        var_199 = wp::extract(var_191, var_198);
        wp::assign_inplace(var_3, var_200, var_199);
        // value_[27] = part_24[3]                                                                <L 42>
        var_202 = wp::extract(var_191, var_201);
        wp::assign_inplace(var_3, var_203, var_202);
        // part_28 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[28], value_[29], value_[30], value_[31]), preserve_type=True)), 0)       <L 43>
        var_205 = wp::extract(var_3, var_204);
        var_207 = wp::extract(var_3, var_206);
        var_209 = wp::extract(var_3, var_208);
        var_211 = wp::extract(var_3, var_210);
        var_212 = wp::vec_t<4, wp::float64>(var_205, var_207, var_209, var_211);
        var_214 = wp::tile<wp::vec_t<4, wp::float64>>(var_212);
        var_215 = wp::tile_sum(var_214);
        var_217 = wp::tile_extract(var_215, var_216);
        // value_[28] = part_28[0]                                                                <L 44>
        var_219 = wp::extract(var_217, var_218);
        wp::assign_inplace(var_3, var_220, var_219);
        // value_[29] = part_28[1]                                                                <L 45>
        var_222 = wp::extract(var_217, var_221);
        wp::assign_inplace(var_3, var_223, var_222);
        // value_[30] = part_28[2]                                                                <L 46>
        var_225 = wp::extract(var_217, var_224);
        wp::assign_inplace(var_3, var_226, var_225);
        // value_[31] = part_28[3]                                                                <L 47>
        var_228 = wp::extract(var_217, var_227);
        wp::assign_inplace(var_3, var_229, var_228);
        // part_32 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[32], value_[33], value_[34], value_[35]), preserve_type=True)), 0)       <L 48>
        var_231 = wp::extract(var_3, var_230);
        var_233 = wp::extract(var_3, var_232);
        var_235 = wp::extract(var_3, var_234);
        var_237 = wp::extract(var_3, var_236);
        var_238 = wp::vec_t<4, wp::float64>(var_231, var_233, var_235, var_237);
        var_240 = wp::tile<wp::vec_t<4, wp::float64>>(var_238);
        var_241 = wp::tile_sum(var_240);
        var_243 = wp::tile_extract(var_241, var_242);
        // value_[32] = part_32[0]                                                                <L 49>
        var_245 = wp::extract(var_243, var_244);
        wp::assign_inplace(var_3, var_246, var_245);
        // value_[33] = part_32[1]                                                                <L 50>
        var_248 = wp::extract(var_243, var_247);
        wp::assign_inplace(var_3, var_249, var_248);
        // value_[34] = part_32[2]                                                                <L 51>
        var_251 = wp::extract(var_243, var_250);
        wp::assign_inplace(var_3, var_252, var_251);
        // value_[35] = part_32[3]                                                                <L 52>
        var_254 = wp::extract(var_243, var_253);
        wp::assign_inplace(var_3, var_255, var_254);
        // if i_ % 256 == 0:                                                                      <L 53>
        var_257 = wp::mod(var_0, var_256);
        var_259 = (var_257 == var_258);
        if (var_259) {
            // partials_[b_] = value_                                                             <L 54>
            wp::array_store(var_partials_, var_2, var_3);
        }
}



extern "C" __global__ void sum_generalized_rows_tiles_ffd526cd_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__jobs__sources__points,
    wp::array_t<wp::int32> var_matches__jobs__sources__first_positions,
    wp::array_t<wp::int32> var_matches__jobs__group_jobs,
    wp::array_t<wp::int32> var_matches__jobs__job_groups,
    wp::array_t<wp::int32> var_matches__jobs__job_sources,
    wp::array_t<wp::vec_t<3, wp::float32>> var_matches__targets,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_matches__poses,
    wp::array_t<wp::int32> var_matches__pairs,
    wp::int32 var_matches__weighted,
    wp::array_t<wp::float32> var_matches__weights,
    wp::int32 var_loss__kind,
    wp::float64 var_loss__k,
    wp::float64 var_loss__shape,
    wp::array_t<wp::float32> var_source__covariances,
    wp::array_t<wp::float32> var_target__covariances,
    wp::array_t<wp::int32> var_firsts_,
    wp::array_t<wp::int32> var_lasts_,
    wp::array_t<wp::int32> var_owners_,
    wp::array_t<wp::int32> var_live_,
    wp::array_t<wp::vec_t<36, wp::float64>> var_partials_)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        const wp::int32 var_1 = 256;
        wp::int32 var_2;
        wp::vec_t<36, wp::float64> var_3;
        wp::int32* var_4;
        wp::int32 var_5;
        wp::int32* var_6;
        const wp::int32 var_7 = 0;
        bool var_8;
        wp::int32 var_9;
        wp::int32* var_10;
        const wp::int32 var_11 = 256;
        wp::int32 var_12;
        wp::int32 var_13;
        wp::int32 var_14;
        wp::int32* var_15;
        const wp::int32 var_16 = 256;
        wp::range_t var_17;
        wp::int32 var_18;
        wp::int32 var_19;
        wp::vec_t<36, wp::float64> var_20;
        wp::vec_t<36, wp::float64> var_21;
        const wp::int32 var_22 = 0;
        wp::float64 var_23;
        const wp::int32 var_24 = 1;
        wp::float64 var_25;
        const wp::int32 var_26 = 2;
        wp::float64 var_27;
        const wp::int32 var_28 = 3;
        wp::float64 var_29;
        wp::vec_t<4, wp::float64> var_30;
        const bool var_31 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_32 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_33 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_34 = 0;
        wp::vec_t<4, wp::float64> var_35;
        const wp::int32 var_36 = 0;
        wp::float64 var_37;
        const wp::int32 var_38 = 0;
        const wp::int32 var_39 = 1;
        wp::float64 var_40;
        const wp::int32 var_41 = 1;
        const wp::int32 var_42 = 2;
        wp::float64 var_43;
        const wp::int32 var_44 = 2;
        const wp::int32 var_45 = 3;
        wp::float64 var_46;
        const wp::int32 var_47 = 3;
        const wp::int32 var_48 = 4;
        wp::float64 var_49;
        const wp::int32 var_50 = 5;
        wp::float64 var_51;
        const wp::int32 var_52 = 6;
        wp::float64 var_53;
        const wp::int32 var_54 = 7;
        wp::float64 var_55;
        wp::vec_t<4, wp::float64> var_56;
        const bool var_57 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_58 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_59 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_60 = 0;
        wp::vec_t<4, wp::float64> var_61;
        const wp::int32 var_62 = 0;
        wp::float64 var_63;
        const wp::int32 var_64 = 4;
        const wp::int32 var_65 = 1;
        wp::float64 var_66;
        const wp::int32 var_67 = 5;
        const wp::int32 var_68 = 2;
        wp::float64 var_69;
        const wp::int32 var_70 = 6;
        const wp::int32 var_71 = 3;
        wp::float64 var_72;
        const wp::int32 var_73 = 7;
        const wp::int32 var_74 = 8;
        wp::float64 var_75;
        const wp::int32 var_76 = 9;
        wp::float64 var_77;
        const wp::int32 var_78 = 10;
        wp::float64 var_79;
        const wp::int32 var_80 = 11;
        wp::float64 var_81;
        wp::vec_t<4, wp::float64> var_82;
        const bool var_83 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_84 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_85 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_86 = 0;
        wp::vec_t<4, wp::float64> var_87;
        const wp::int32 var_88 = 0;
        wp::float64 var_89;
        const wp::int32 var_90 = 8;
        const wp::int32 var_91 = 1;
        wp::float64 var_92;
        const wp::int32 var_93 = 9;
        const wp::int32 var_94 = 2;
        wp::float64 var_95;
        const wp::int32 var_96 = 10;
        const wp::int32 var_97 = 3;
        wp::float64 var_98;
        const wp::int32 var_99 = 11;
        const wp::int32 var_100 = 12;
        wp::float64 var_101;
        const wp::int32 var_102 = 13;
        wp::float64 var_103;
        const wp::int32 var_104 = 14;
        wp::float64 var_105;
        const wp::int32 var_106 = 15;
        wp::float64 var_107;
        wp::vec_t<4, wp::float64> var_108;
        const bool var_109 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_110 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_111 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_112 = 0;
        wp::vec_t<4, wp::float64> var_113;
        const wp::int32 var_114 = 0;
        wp::float64 var_115;
        const wp::int32 var_116 = 12;
        const wp::int32 var_117 = 1;
        wp::float64 var_118;
        const wp::int32 var_119 = 13;
        const wp::int32 var_120 = 2;
        wp::float64 var_121;
        const wp::int32 var_122 = 14;
        const wp::int32 var_123 = 3;
        wp::float64 var_124;
        const wp::int32 var_125 = 15;
        const wp::int32 var_126 = 16;
        wp::float64 var_127;
        const wp::int32 var_128 = 17;
        wp::float64 var_129;
        const wp::int32 var_130 = 18;
        wp::float64 var_131;
        const wp::int32 var_132 = 19;
        wp::float64 var_133;
        wp::vec_t<4, wp::float64> var_134;
        const bool var_135 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_136 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_137 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_138 = 0;
        wp::vec_t<4, wp::float64> var_139;
        const wp::int32 var_140 = 0;
        wp::float64 var_141;
        const wp::int32 var_142 = 16;
        const wp::int32 var_143 = 1;
        wp::float64 var_144;
        const wp::int32 var_145 = 17;
        const wp::int32 var_146 = 2;
        wp::float64 var_147;
        const wp::int32 var_148 = 18;
        const wp::int32 var_149 = 3;
        wp::float64 var_150;
        const wp::int32 var_151 = 19;
        const wp::int32 var_152 = 20;
        wp::float64 var_153;
        const wp::int32 var_154 = 21;
        wp::float64 var_155;
        const wp::int32 var_156 = 22;
        wp::float64 var_157;
        const wp::int32 var_158 = 23;
        wp::float64 var_159;
        wp::vec_t<4, wp::float64> var_160;
        const bool var_161 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_162 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_163 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_164 = 0;
        wp::vec_t<4, wp::float64> var_165;
        const wp::int32 var_166 = 0;
        wp::float64 var_167;
        const wp::int32 var_168 = 20;
        const wp::int32 var_169 = 1;
        wp::float64 var_170;
        const wp::int32 var_171 = 21;
        const wp::int32 var_172 = 2;
        wp::float64 var_173;
        const wp::int32 var_174 = 22;
        const wp::int32 var_175 = 3;
        wp::float64 var_176;
        const wp::int32 var_177 = 23;
        const wp::int32 var_178 = 24;
        wp::float64 var_179;
        const wp::int32 var_180 = 25;
        wp::float64 var_181;
        const wp::int32 var_182 = 26;
        wp::float64 var_183;
        const wp::int32 var_184 = 27;
        wp::float64 var_185;
        wp::vec_t<4, wp::float64> var_186;
        const bool var_187 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_188 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_189 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_190 = 0;
        wp::vec_t<4, wp::float64> var_191;
        const wp::int32 var_192 = 0;
        wp::float64 var_193;
        const wp::int32 var_194 = 24;
        const wp::int32 var_195 = 1;
        wp::float64 var_196;
        const wp::int32 var_197 = 25;
        const wp::int32 var_198 = 2;
        wp::float64 var_199;
        const wp::int32 var_200 = 26;
        const wp::int32 var_201 = 3;
        wp::float64 var_202;
        const wp::int32 var_203 = 27;
        const wp::int32 var_204 = 28;
        wp::float64 var_205;
        const wp::int32 var_206 = 29;
        wp::float64 var_207;
        const wp::int32 var_208 = 30;
        wp::float64 var_209;
        const wp::int32 var_210 = 31;
        wp::float64 var_211;
        wp::vec_t<4, wp::float64> var_212;
        const bool var_213 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_214 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_215 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_216 = 0;
        wp::vec_t<4, wp::float64> var_217;
        const wp::int32 var_218 = 0;
        wp::float64 var_219;
        const wp::int32 var_220 = 28;
        const wp::int32 var_221 = 1;
        wp::float64 var_222;
        const wp::int32 var_223 = 29;
        const wp::int32 var_224 = 2;
        wp::float64 var_225;
        const wp::int32 var_226 = 30;
        const wp::int32 var_227 = 3;
        wp::float64 var_228;
        const wp::int32 var_229 = 31;
        const wp::int32 var_230 = 32;
        wp::float64 var_231;
        const wp::int32 var_232 = 33;
        wp::float64 var_233;
        const wp::int32 var_234 = 34;
        wp::float64 var_235;
        const wp::int32 var_236 = 35;
        wp::float64 var_237;
        wp::vec_t<4, wp::float64> var_238;
        const bool var_239 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_240 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_241 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_242 = 0;
        wp::vec_t<4, wp::float64> var_243;
        const wp::int32 var_244 = 0;
        wp::float64 var_245;
        const wp::int32 var_246 = 32;
        const wp::int32 var_247 = 1;
        wp::float64 var_248;
        const wp::int32 var_249 = 33;
        const wp::int32 var_250 = 2;
        wp::float64 var_251;
        const wp::int32 var_252 = 34;
        const wp::int32 var_253 = 3;
        wp::float64 var_254;
        const wp::int32 var_255 = 35;
        const wp::int32 var_256 = 256;
        wp::int32 var_257;
        const wp::int32 var_258 = 0;
        bool var_259;
        //---------
        // forward
        // def sum_generalized_rows_tiles(matches__jobs__sources__points, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__targets, matches__poses, matches__pairs, matches__weighted, matches__weights, loss__kind, loss__k, loss__shape, source__covariances, target__covariances, firsts_, lasts_, owners_, live_, partials_):       <L 1>
        // i_ = wp.tid()                                                                          <L 2>
        var_0 = builtin_tid1d();
        // b_ = i_ // 256                                                                         <L 3>
        var_2 = wp::floordiv(var_0, var_1);
        // value_ = vector_()                                                                     <L 4>
        var_3 = wp::vec_t<36, wp::float64>();
        // if live_[owners_[b_]] != 0:                                                            <L 5>
        var_4 = wp::address(var_owners_, var_2);
        var_5 = wp::load(var_4);
        var_6 = wp::address(var_live_, var_5);
        var_9 = wp::load(var_6);
        var_8 = (var_9 != var_7);
        if (var_8) {
            // for j_ in range(firsts_[b_] + i_ % 256, lasts_[b_], 256):                          <L 6>
            var_10 = wp::address(var_firsts_, var_2);
            var_12 = wp::mod(var_0, var_11);
            var_14 = wp::load(var_10);
            var_13 = wp::add(var_14, var_12);
            var_15 = wp::address(var_lasts_, var_2);
            var_18 = wp::load(var_15);
            var_17 = wp::range(var_13, var_18, var_16);
            start_for_0:;
                if (iter_cmp(var_17) == 0) goto end_for_0;
                var_19 = wp::iter_next(var_17);
                // value_ += element_(matches__jobs__sources__points, matches__jobs__sources__first_positions, matches__jobs__group_jobs, matches__jobs__job_groups, matches__jobs__job_sources, matches__targets, matches__poses, matches__pairs, matches__weighted, matches__weights, loss__kind, loss__k, loss__shape, source__covariances, target__covariances, j_)       <L 7>
                var_20 = sum_generalized_rows_element_0(var_matches__jobs__sources__points, var_matches__jobs__sources__first_positions, var_matches__jobs__group_jobs, var_matches__jobs__job_groups, var_matches__jobs__job_sources, var_matches__targets, var_matches__poses, var_matches__pairs, var_matches__weighted, var_matches__weights, var_loss__kind, var_loss__k, var_loss__shape, var_source__covariances, var_target__covariances, var_19);
                var_21 = wp::add(var_3, var_20);
                wp::assign(var_3, var_21);
                goto start_for_0;
            end_for_0:;
        }
        // part_0 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[0], value_[1], value_[2], value_[3]), preserve_type=True)), 0)       <L 8>
        var_23 = wp::extract(var_3, var_22);
        var_25 = wp::extract(var_3, var_24);
        var_27 = wp::extract(var_3, var_26);
        var_29 = wp::extract(var_3, var_28);
        var_30 = wp::vec_t<4, wp::float64>(var_23, var_25, var_27, var_29);
        var_32 = wp::tile<wp::vec_t<4, wp::float64>>(var_30);
        var_33 = wp::tile_sum(var_32);
        var_35 = wp::tile_extract(var_33, var_34);
        // value_[0] = part_0[0]                                                                  <L 9>
        var_37 = wp::extract(var_35, var_36);
        wp::assign_inplace(var_3, var_38, var_37);
        // value_[1] = part_0[1]                                                                  <L 10>
        var_40 = wp::extract(var_35, var_39);
        wp::assign_inplace(var_3, var_41, var_40);
        // value_[2] = part_0[2]                                                                  <L 11>
        var_43 = wp::extract(var_35, var_42);
        wp::assign_inplace(var_3, var_44, var_43);
        // value_[3] = part_0[3]                                                                  <L 12>
        var_46 = wp::extract(var_35, var_45);
        wp::assign_inplace(var_3, var_47, var_46);
        // part_4 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[4], value_[5], value_[6], value_[7]), preserve_type=True)), 0)       <L 13>
        var_49 = wp::extract(var_3, var_48);
        var_51 = wp::extract(var_3, var_50);
        var_53 = wp::extract(var_3, var_52);
        var_55 = wp::extract(var_3, var_54);
        var_56 = wp::vec_t<4, wp::float64>(var_49, var_51, var_53, var_55);
        var_58 = wp::tile<wp::vec_t<4, wp::float64>>(var_56);
        var_59 = wp::tile_sum(var_58);
        var_61 = wp::tile_extract(var_59, var_60);
        // value_[4] = part_4[0]                                                                  <L 14>
        var_63 = wp::extract(var_61, var_62);
        wp::assign_inplace(var_3, var_64, var_63);
        // value_[5] = part_4[1]                                                                  <L 15>
        var_66 = wp::extract(var_61, var_65);
        wp::assign_inplace(var_3, var_67, var_66);
        // value_[6] = part_4[2]                                                                  <L 16>
        var_69 = wp::extract(var_61, var_68);
        wp::assign_inplace(var_3, var_70, var_69);
        // value_[7] = part_4[3]                                                                  <L 17>
        var_72 = wp::extract(var_61, var_71);
        wp::assign_inplace(var_3, var_73, var_72);
        // part_8 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[8], value_[9], value_[10], value_[11]), preserve_type=True)), 0)       <L 18>
        var_75 = wp::extract(var_3, var_74);
        var_77 = wp::extract(var_3, var_76);
        var_79 = wp::extract(var_3, var_78);
        var_81 = wp::extract(var_3, var_80);
        var_82 = wp::vec_t<4, wp::float64>(var_75, var_77, var_79, var_81);
        var_84 = wp::tile<wp::vec_t<4, wp::float64>>(var_82);
        var_85 = wp::tile_sum(var_84);
        var_87 = wp::tile_extract(var_85, var_86);
        // value_[8] = part_8[0]                                                                  <L 19>
        var_89 = wp::extract(var_87, var_88);
        wp::assign_inplace(var_3, var_90, var_89);
        // value_[9] = part_8[1]                                                                  <L 20>
        var_92 = wp::extract(var_87, var_91);
        wp::assign_inplace(var_3, var_93, var_92);
        // value_[10] = part_8[2]                                                                 <L 21>
        var_95 = wp::extract(var_87, var_94);
        wp::assign_inplace(var_3, var_96, var_95);
        // value_[11] = part_8[3]                                                                 <L 22>
        var_98 = wp::extract(var_87, var_97);
        wp::assign_inplace(var_3, var_99, var_98);
        // part_12 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[12], value_[13], value_[14], value_[15]), preserve_type=True)), 0)       <L 23>
        var_101 = wp::extract(var_3, var_100);
        var_103 = wp::extract(var_3, var_102);
        var_105 = wp::extract(var_3, var_104);
        var_107 = wp::extract(var_3, var_106);
        var_108 = wp::vec_t<4, wp::float64>(var_101, var_103, var_105, var_107);
        var_110 = wp::tile<wp::vec_t<4, wp::float64>>(var_108);
        var_111 = wp::tile_sum(var_110);
        var_113 = wp::tile_extract(var_111, var_112);
        // value_[12] = part_12[0]                                                                <L 24>
        var_115 = wp::extract(var_113, var_114);
        wp::assign_inplace(var_3, var_116, var_115);
        // value_[13] = part_12[1]                                                                <L 25>
        var_118 = wp::extract(var_113, var_117);
        wp::assign_inplace(var_3, var_119, var_118);
        // value_[14] = part_12[2]                                                                <L 26>
        var_121 = wp::extract(var_113, var_120);
        wp::assign_inplace(var_3, var_122, var_121);
        // value_[15] = part_12[3]                                                                <L 27>
        var_124 = wp::extract(var_113, var_123);
        wp::assign_inplace(var_3, var_125, var_124);
        // part_16 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[16], value_[17], value_[18], value_[19]), preserve_type=True)), 0)       <L 28>
        var_127 = wp::extract(var_3, var_126);
        var_129 = wp::extract(var_3, var_128);
        var_131 = wp::extract(var_3, var_130);
        var_133 = wp::extract(var_3, var_132);
        var_134 = wp::vec_t<4, wp::float64>(var_127, var_129, var_131, var_133);
        var_136 = wp::tile<wp::vec_t<4, wp::float64>>(var_134);
        var_137 = wp::tile_sum(var_136);
        var_139 = wp::tile_extract(var_137, var_138);
        // value_[16] = part_16[0]                                                                <L 29>
        var_141 = wp::extract(var_139, var_140);
        wp::assign_inplace(var_3, var_142, var_141);
        // value_[17] = part_16[1]                                                                <L 30>
        var_144 = wp::extract(var_139, var_143);
        wp::assign_inplace(var_3, var_145, var_144);
        // value_[18] = part_16[2]                                                                <L 31>
        var_147 = wp::extract(var_139, var_146);
        wp::assign_inplace(var_3, var_148, var_147);
        // value_[19] = part_16[3]                                                                <L 32>
        var_150 = wp::extract(var_139, var_149);
        wp::assign_inplace(var_3, var_151, var_150);
        // part_20 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[20], value_[21], value_[22], value_[23]), preserve_type=True)), 0)       <L 33>
        var_153 = wp::extract(var_3, var_152);
        var_155 = wp::extract(var_3, var_154);
        var_157 = wp::extract(var_3, var_156);
        var_159 = wp::extract(var_3, var_158);
        var_160 = wp::vec_t<4, wp::float64>(var_153, var_155, var_157, var_159);
        var_162 = wp::tile<wp::vec_t<4, wp::float64>>(var_160);
        var_163 = wp::tile_sum(var_162);
        var_165 = wp::tile_extract(var_163, var_164);
        // value_[20] = part_20[0]                                                                <L 34>
        var_167 = wp::extract(var_165, var_166);
        wp::assign_inplace(var_3, var_168, var_167);
        // value_[21] = part_20[1]                                                                <L 35>
        var_170 = wp::extract(var_165, var_169);
        wp::assign_inplace(var_3, var_171, var_170);
        // value_[22] = part_20[2]                                                                <L 36>
        var_173 = wp::extract(var_165, var_172);
        wp::assign_inplace(var_3, var_174, var_173);
        // value_[23] = part_20[3]                                                                <L 37>
        var_176 = wp::extract(var_165, var_175);
        wp::assign_inplace(var_3, var_177, var_176);
        // part_24 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[24], value_[25], value_[26], value_[27]), preserve_type=True)), 0)       <L 38>
        var_179 = wp::extract(var_3, var_178);
        var_181 = wp::extract(var_3, var_180);
        var_183 = wp::extract(var_3, var_182);
        var_185 = wp::extract(var_3, var_184);
        var_186 = wp::vec_t<4, wp::float64>(var_179, var_181, var_183, var_185);
        var_188 = wp::tile<wp::vec_t<4, wp::float64>>(var_186);
        var_189 = wp::tile_sum(var_188);
        var_191 = wp::tile_extract(var_189, var_190);
        // value_[24] = part_24[0]                                                                <L 39>
        var_193 = wp::extract(var_191, var_192);
        wp::assign_inplace(var_3, var_194, var_193);
        // value_[25] = part_24[1]                                                                <L 40>
        var_196 = wp::extract(var_191, var_195);
        wp::assign_inplace(var_3, var_197, var_196);
        // value_[26] = part_24[2]                                                                <L 41>
        var_199 = wp::extract(var_191, var_198);
        wp::assign_inplace(var_3, var_200, var_199);
        // value_[27] = part_24[3]                                                                <L 42>
        var_202 = wp::extract(var_191, var_201);
        wp::assign_inplace(var_3, var_203, var_202);
        // part_28 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[28], value_[29], value_[30], value_[31]), preserve_type=True)), 0)       <L 43>
        var_205 = wp::extract(var_3, var_204);
        var_207 = wp::extract(var_3, var_206);
        var_209 = wp::extract(var_3, var_208);
        var_211 = wp::extract(var_3, var_210);
        var_212 = wp::vec_t<4, wp::float64>(var_205, var_207, var_209, var_211);
        var_214 = wp::tile<wp::vec_t<4, wp::float64>>(var_212);
        var_215 = wp::tile_sum(var_214);
        var_217 = wp::tile_extract(var_215, var_216);
        // value_[28] = part_28[0]                                                                <L 44>
        var_219 = wp::extract(var_217, var_218);
        wp::assign_inplace(var_3, var_220, var_219);
        // value_[29] = part_28[1]                                                                <L 45>
        var_222 = wp::extract(var_217, var_221);
        wp::assign_inplace(var_3, var_223, var_222);
        // value_[30] = part_28[2]                                                                <L 46>
        var_225 = wp::extract(var_217, var_224);
        wp::assign_inplace(var_3, var_226, var_225);
        // value_[31] = part_28[3]                                                                <L 47>
        var_228 = wp::extract(var_217, var_227);
        wp::assign_inplace(var_3, var_229, var_228);
        // part_32 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[32], value_[33], value_[34], value_[35]), preserve_type=True)), 0)       <L 48>
        var_231 = wp::extract(var_3, var_230);
        var_233 = wp::extract(var_3, var_232);
        var_235 = wp::extract(var_3, var_234);
        var_237 = wp::extract(var_3, var_236);
        var_238 = wp::vec_t<4, wp::float64>(var_231, var_233, var_235, var_237);
        var_240 = wp::tile<wp::vec_t<4, wp::float64>>(var_238);
        var_241 = wp::tile_sum(var_240);
        var_243 = wp::tile_extract(var_241, var_242);
        // value_[32] = part_32[0]                                                                <L 49>
        var_245 = wp::extract(var_243, var_244);
        wp::assign_inplace(var_3, var_246, var_245);
        // value_[33] = part_32[1]                                                                <L 50>
        var_248 = wp::extract(var_243, var_247);
        wp::assign_inplace(var_3, var_249, var_248);
        // value_[34] = part_32[2]                                                                <L 51>
        var_251 = wp::extract(var_243, var_250);
        wp::assign_inplace(var_3, var_252, var_251);
        // value_[35] = part_32[3]                                                                <L 52>
        var_254 = wp::extract(var_243, var_253);
        wp::assign_inplace(var_3, var_255, var_254);
        // if i_ % 256 == 0:                                                                      <L 53>
        var_257 = wp::mod(var_0, var_256);
        var_259 = (var_257 == var_258);
        if (var_259) {
            // partials_[b_] = value_                                                             <L 54>
            wp::array_store(var_partials_, var_2, var_3);
        }
}


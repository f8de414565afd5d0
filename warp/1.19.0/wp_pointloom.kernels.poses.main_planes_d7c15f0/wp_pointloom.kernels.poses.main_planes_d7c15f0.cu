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


// <pointloom.kernels.poses.main_planes.is_coplanar>:1
static CUDA_CALLABLE wp::int32 is_coplanar_0(
    wp::int32 var_i,
    wp::array_t<wp::vec_t<3, wp::float32>> var_voters__points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_voters__normals,
    wp::array_t<wp::int32> var_voters__sizes,
    wp::array_t<wp::vec_t<3, wp::float64>> var_voters__point,
    wp::array_t<wp::vec_t<3, wp::float64>> var_voters__normal,
    wp::float32 var_slab,
    wp::float32 var_cosine)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    bool var_2;
    const wp::int32 var_3 = 0;
    wp::int32* var_4;
    bool var_5;
    wp::int32 var_6;
    const wp::int32 var_7 = 2;
    wp::int32* var_8;
    const wp::int32 var_9 = 0;
    bool var_10;
    wp::int32 var_11;
    const wp::int32 var_12 = 0;
    wp::vec_t<3, wp::float64>* var_13;
    wp::vec_t<3, wp::float32> var_14;
    wp::vec_t<3, wp::float64> var_15;
    wp::vec_t<3, wp::float32>* var_16;
    wp::float32 var_17;
    wp::vec_t<3, wp::float32> var_18;
    wp::float32 var_19;
    bool var_20;
    wp::vec_t<3, wp::float32>* var_21;
    const wp::int32 var_22 = 0;
    wp::vec_t<3, wp::float64>* var_23;
    wp::vec_t<3, wp::float32> var_24;
    wp::vec_t<3, wp::float64> var_25;
    wp::vec_t<3, wp::float32> var_26;
    wp::vec_t<3, wp::float32> var_27;
    wp::float32 var_28;
    wp::float32 var_29;
    bool var_30;
    const wp::int32 var_31 = 1;
    wp::int32 var_32;
    wp::int32 var_33;
    wp::int32 var_34;
    //---------
    // forward
    // def is_coplanar(i, voters__points, voters__normals, voters__sizes, voters__point, voters__normal, slab, cosine):       <L 1>
    // is_inlier = int(0)                                                                     <L 2>
    var_1 = wp::int(var_0);
    // if i < voters__sizes[VOTERS_AT] and voters__sizes[DONE_AT] == 0:                       <L 3>
    var_4 = wp::address(var_voters__sizes, var_3);
    var_6 = wp::load(var_4);
    var_5 = (var_i < var_6);
    var_2 = var_5;
    if (var_2) {
        var_8 = wp::address(var_voters__sizes, var_7);
        var_11 = wp::load(var_8);
        var_10 = (var_11 == var_9);
        var_2 = var_2 && var_10;
    }
    if (var_2) {
        // n = narrow(voters__normal[0])                                                      <L 4>
        var_13 = wp::address(var_voters__normal, var_12);
        var_15 = wp::load(var_13);
        var_14 = narrow_0(var_15);
        // if abs(dot(n, voters__normals[i])) > cosine:                                       <L 5>
        var_16 = wp::address(var_voters__normals, var_i);
        var_18 = wp::load(var_16);
        var_17 = wp::dot(var_14, var_18);
        var_19 = wp::abs(var_17);
        var_20 = (var_19 > var_cosine);
        if (var_20) {
            // if abs(dot(n, voters__points[i] - narrow(voters__point[0]))) < slab:           <L 6>
            var_21 = wp::address(var_voters__points, var_i);
            var_23 = wp::address(var_voters__point, var_22);
            var_25 = wp::load(var_23);
            var_24 = narrow_0(var_25);
            var_27 = wp::load(var_21);
            var_26 = wp::sub(var_27, var_24);
            var_28 = wp::dot(var_14, var_26);
            var_29 = wp::abs(var_28);
            var_30 = (var_29 < var_slab);
            if (var_30) {
                // is_inlier = 1                                                              <L 7>
            }
            var_32 = wp::where(var_30, var_31, var_1);
        }
        var_33 = wp::where(var_20, var_32, var_1);
    }
    var_34 = wp::where(var_2, var_33, var_1);
    // return is_inlier                                                                       <L 8>
    return var_34;
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


// /work/main/src/pointloom/kernels/algebra/transform.py:32
static CUDA_CALLABLE void adj_narrow_0(
    wp::vec_t<3, wp::float64> var_p,
    wp::vec_t<3, wp::float64> & adj_p,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.poses.main_planes.is_coplanar>:1
static CUDA_CALLABLE void adj_is_coplanar_0(
    wp::int32 var_i,
    wp::array_t<wp::vec_t<3, wp::float32>> var_voters__points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_voters__normals,
    wp::array_t<wp::int32> var_voters__sizes,
    wp::array_t<wp::vec_t<3, wp::float64>> var_voters__point,
    wp::array_t<wp::vec_t<3, wp::float64>> var_voters__normal,
    wp::float32 var_slab,
    wp::float32 var_cosine,
    wp::int32 & adj_i,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_voters__points,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_voters__normals,
    wp::array_t<wp::int32> & adj_voters__sizes,
    wp::array_t<wp::vec_t<3, wp::float64>> & adj_voters__point,
    wp::array_t<wp::vec_t<3, wp::float64>> & adj_voters__normal,
    wp::float32 & adj_slab,
    wp::float32 & adj_cosine,
    wp::int32 & adj_ret)
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


// /work/main/src/pointloom/kernels/algebra/transform.py:27
static CUDA_CALLABLE void adj_widen_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void leave_out_planes_kernel_044b77b2_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_normals,
    wp::array_t<wp::vec_t<3, wp::float32>> var_planes__middles,
    wp::array_t<wp::vec_t<3, wp::float32>> var_planes__directions,
    wp::array_t<wp::int32> var_planes__count,
    wp::float32 var_slab,
    wp::float32 var_cosine,
    wp::float32 var_edge,
    wp::array_t<wp::int64> var_nearest)
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
        const wp::int32 var_4 = 0;
        wp::int32 var_5;
        const wp::int32 var_6 = 0;
        wp::int32* var_7;
        wp::range_t var_8;
        wp::int32 var_9;
        wp::int32 var_10;
        wp::vec_t<3, wp::float32>* var_11;
        wp::vec_t<3, wp::float32> var_12;
        wp::vec_t<3, wp::float32> var_13;
        wp::vec_t<3, wp::float32>* var_14;
        wp::vec_t<3, wp::float32> var_15;
        wp::vec_t<3, wp::float32> var_16;
        wp::float32 var_17;
        wp::float32 var_18;
        bool var_19;
        bool var_20;
        wp::vec_t<3, wp::float32>* var_21;
        wp::float32 var_22;
        wp::vec_t<3, wp::float32> var_23;
        wp::float32 var_24;
        bool var_25;
        const wp::int32 var_26 = 1;
        wp::int32 var_27;
        bool var_28;
        wp::range_t var_29;
        wp::int32 var_30;
        wp::vec_t<3, wp::float32>* var_31;
        wp::vec_t<3, wp::float32> var_32;
        wp::vec_t<3, wp::float32> var_33;
        bool var_34;
        wp::float32 var_35;
        wp::float32 var_36;
        bool var_37;
        wp::vec_t<3, wp::float32>* var_38;
        wp::vec_t<3, wp::float32> var_39;
        wp::vec_t<3, wp::float32> var_40;
        wp::float32 var_41;
        wp::float32 var_42;
        bool var_43;
        const wp::int32 var_44 = 1;
        wp::int32 var_45;
        const wp::int32 var_46 = 1;
        bool var_47;
        wp::int64 var_48;
        //---------
        // forward
        // def leave_out_planes_kernel(points, normals, planes__middles, planes__directions, planes__count, slab, cosine, edge, nearest):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // p = points[i]                                                                          <L 4>
        var_1 = wp::address(var_points, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // left_out = int(0)                                                                      <L 5>
        var_5 = wp::int(var_4);
        // for k in range(planes__count[0]):                                                      <L 6>
        var_7 = wp::address(var_planes__count, var_6);
        var_9 = wp::load(var_7);
        var_8 = wp::range(var_9);
        start_for_0:;
            if (iter_cmp(var_8) == 0) goto end_for_0;
            var_10 = wp::iter_next(var_8);
            // n = planes__directions[k]                                                          <L 7>
            var_11 = wp::address(var_planes__directions, var_10);
            var_13 = wp::load(var_11);
            var_12 = wp::copy(var_13);
            // height = abs(dot(n, p - planes__middles[k]))                                       <L 8>
            var_14 = wp::address(var_planes__middles, var_10);
            var_16 = wp::load(var_14);
            var_15 = wp::sub(var_2, var_16);
            var_17 = wp::dot(var_12, var_15);
            var_18 = wp::abs(var_17);
            // if height < slab and abs(dot(n, normals[i])) > cosine:                             <L 9>
            var_20 = (var_18 < var_slab);
            var_19 = var_20;
            if (var_19) {
                var_21 = wp::address(var_normals, var_0);
                var_23 = wp::load(var_21);
                var_22 = wp::dot(var_12, var_23);
                var_24 = wp::abs(var_22);
                var_25 = (var_24 > var_cosine);
                var_19 = var_19 && var_25;
            }
            if (var_19) {
                // left_out = 1                                                                   <L 10>
            }
            var_27 = wp::where(var_19, var_26, var_5);
            // if height < edge:                                                                  <L 11>
            var_28 = (var_18 < var_edge);
            if (var_28) {
                // for j in range(k):                                                             <L 12>
                var_29 = wp::range(var_10);
                start_for_2:;
                    if (iter_cmp(var_29) == 0) goto end_for_2;
                    var_30 = wp::iter_next(var_29);
                    // m = planes__directions[j]                                                  <L 13>
                    var_31 = wp::address(var_planes__directions, var_30);
                    var_33 = wp::load(var_31);
                    var_32 = wp::copy(var_33);
                    // if abs(dot(n, m)) < cosine and abs(dot(m, p - planes__middles[j])) < edge:       <L 14>
                    var_35 = wp::dot(var_12, var_32);
                    var_36 = wp::abs(var_35);
                    var_37 = (var_36 < var_cosine);
                    var_34 = var_37;
                    if (var_34) {
                        var_38 = wp::address(var_planes__middles, var_30);
                        var_40 = wp::load(var_38);
                        var_39 = wp::sub(var_2, var_40);
                        var_41 = wp::dot(var_32, var_39);
                        var_42 = wp::abs(var_41);
                        var_43 = (var_42 < var_edge);
                        var_34 = var_34 && var_43;
                    }
                    if (var_34) {
                        // left_out = 1                                                           <L 15>
                    }
                    var_45 = wp::where(var_34, var_44, var_27);
                    wp::assign(var_27, var_45);
                    goto start_for_2;
                end_for_2:;
            }
            wp::assign(var_5, var_27);
            goto start_for_0;
        end_for_0:;
        // if left_out == 1:                                                                      <L 16>
        var_47 = (var_5 == var_46);
        if (var_47) {
            // nearest[i] = int64(NO_POINT)                                                       <L 17>
            var_48 = -1ll;
            wp::array_store(var_nearest, var_0, var_48);
        }
}



extern "C" __global__ void silence_coplanar_kernel_752e05e0_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_voters__points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_voters__normals,
    wp::array_t<wp::int32> var_voters__sizes,
    wp::array_t<wp::vec_t<3, wp::float64>> var_voters__point,
    wp::array_t<wp::vec_t<3, wp::float64>> var_voters__normal,
    wp::float32 var_slab,
    wp::float32 var_cosine)
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
        const wp::int32 var_2 = 1;
        bool var_3;
        const wp::float32 var_4 = 0.0;
        const wp::float32 var_5 = 0.0;
        const wp::float32 var_6 = 0.0;
        wp::vec_t<3, wp::float32> var_7;
        //---------
        // forward
        // def silence_coplanar_kernel(voters__points, voters__normals, voters__sizes, voters__point, voters__normal, slab, cosine):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // if is_coplanar(i, voters__points, voters__normals, voters__sizes, voters__point, voters__normal, slab, cosine) == 1:       <L 4>
        var_1 = is_coplanar_0(var_0, var_voters__points, var_voters__normals, var_voters__sizes, var_voters__point, var_voters__normal, var_slab, var_cosine);
        var_3 = (var_1 == var_2);
        if (var_3) {
            // voters__normals[i] = vec3(0.0, 0.0, 0.0)                                           <L 5>
            var_7 = wp::vec_t<3, wp::float32>(var_4, var_5, var_6);
            wp::array_store(var_voters__normals, var_0, var_7);
        }
}



extern "C" __global__ void count_coplanar_kernel_75e45252_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_voters__points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_voters__normals,
    wp::array_t<wp::int32> var_voters__sizes,
    wp::array_t<wp::int32> var_voters__counts,
    wp::float32 var_slab,
    wp::float32 var_cosine)
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
        wp::int32* var_2;
        wp::int32 var_3;
        wp::int32 var_4;
        const wp::int32 var_5 = -1;
        wp::int32 var_6;
        bool var_7;
        const wp::int32 var_8 = 0;
        wp::int32* var_9;
        bool var_10;
        wp::int32 var_11;
        const wp::int32 var_12 = 2;
        wp::int32* var_13;
        const wp::int32 var_14 = 0;
        bool var_15;
        wp::int32 var_16;
        wp::vec_t<3, wp::float32>* var_17;
        wp::vec_t<3, wp::float32> var_18;
        wp::vec_t<3, wp::float32> var_19;
        wp::vec_t<3, wp::float32>* var_20;
        wp::vec_t<3, wp::float32> var_21;
        wp::vec_t<3, wp::float32> var_22;
        const wp::int32 var_23 = 0;
        wp::int32 var_24;
        wp::int32* var_25;
        wp::range_t var_26;
        wp::int32 var_27;
        wp::int32 var_28;
        wp::vec_t<3, wp::float32>* var_29;
        wp::float32 var_30;
        wp::vec_t<3, wp::float32> var_31;
        wp::float32 var_32;
        bool var_33;
        wp::vec_t<3, wp::float32>* var_34;
        wp::vec_t<3, wp::float32> var_35;
        wp::vec_t<3, wp::float32> var_36;
        wp::float32 var_37;
        wp::float32 var_38;
        bool var_39;
        const wp::int32 var_40 = 1;
        wp::int32 var_41;
        wp::int32 var_42;
        wp::int32 var_43;
        wp::int32 var_44;
        //---------
        // forward
        // def count_coplanar_kernel(voters__points, voters__normals, voters__sizes, voters__counts, slab, cosine):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // at = i * voters__sizes[STEP_AT]                                                        <L 4>
        var_2 = wp::address(var_voters__sizes, var_1);
        var_4 = wp::load(var_2);
        var_3 = wp::mul(var_0, var_4);
        // total = int(-1)                                                                        <L 5>
        var_6 = wp::int(var_5);
        // if at < voters__sizes[VOTERS_AT] and voters__sizes[DONE_AT] == 0:                      <L 6>
        var_9 = wp::address(var_voters__sizes, var_8);
        var_11 = wp::load(var_9);
        var_10 = (var_3 < var_11);
        var_7 = var_10;
        if (var_7) {
            var_13 = wp::address(var_voters__sizes, var_12);
            var_16 = wp::load(var_13);
            var_15 = (var_16 == var_14);
            var_7 = var_7 && var_15;
        }
        if (var_7) {
            // p = voters__points[at]                                                             <L 7>
            var_17 = wp::address(var_voters__points, var_3);
            var_19 = wp::load(var_17);
            var_18 = wp::copy(var_19);
            // n = voters__normals[at]                                                            <L 8>
            var_20 = wp::address(var_voters__normals, var_3);
            var_22 = wp::load(var_20);
            var_21 = wp::copy(var_22);
            // total = int(0)                                                                     <L 9>
            var_24 = wp::int(var_23);
            // for j in range(voters__sizes[VOTERS_AT]):                                          <L 10>
            var_25 = wp::address(var_voters__sizes, var_8);
            var_27 = wp::load(var_25);
            var_26 = wp::range(var_27);
            start_for_0:;
                if (iter_cmp(var_26) == 0) goto end_for_0;
                var_28 = wp::iter_next(var_26);
                // if abs(dot(n, voters__normals[j])) > cosine:                                   <L 11>
                var_29 = wp::address(var_voters__normals, var_28);
                var_31 = wp::load(var_29);
                var_30 = wp::dot(var_21, var_31);
                var_32 = wp::abs(var_30);
                var_33 = (var_32 > var_cosine);
                if (var_33) {
                    // if abs(dot(n, voters__points[j] - p)) < slab:                              <L 12>
                    var_34 = wp::address(var_voters__points, var_28);
                    var_36 = wp::load(var_34);
                    var_35 = wp::sub(var_36, var_18);
                    var_37 = wp::dot(var_21, var_35);
                    var_38 = wp::abs(var_37);
                    var_39 = (var_38 < var_slab);
                    if (var_39) {
                        // total += 1                                                             <L 13>
                        var_41 = wp::add(var_24, var_40);
                    }
                    var_42 = wp::where(var_39, var_41, var_24);
                }
                var_43 = wp::where(var_33, var_42, var_24);
                wp::assign(var_24, var_43);
                goto start_for_0;
            end_for_0:;
        }
        var_44 = wp::where(var_7, var_24, var_6);
        // voters__counts[i] = total                                                              <L 14>
        wp::array_store(var_voters__counts, var_0, var_44);
}



extern "C" __global__ void choose_voters_kernel_7c9b12c0_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_normals,
    wp::array_t<wp::int32> var_ranks,
    wp::array_t<wp::vec_t<3, wp::float32>> var_voters__points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_voters__normals,
    wp::array_t<wp::vec_t<3, wp::float32>> var_voters__firsts,
    wp::array_t<wp::int32> var_voters__sizes)
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
        const wp::int32 var_5 = 1;
        wp::int32 var_6;
        wp::int32* var_7;
        wp::int32 var_8;
        wp::int32 var_9;
        const wp::int32 var_10 = 1;
        const wp::int32 var_11 = 2048;
        wp::int32 var_12;
        const wp::int32 var_13 = 1;
        wp::int32 var_14;
        wp::int32 var_15;
        wp::int32 var_16;
        const wp::int32 var_17 = 0;
        wp::int32 var_18;
        const wp::int32 var_19 = 0;
        bool var_20;
        const wp::int32 var_21 = 1;
        wp::int32 var_22;
        wp::int32* var_23;
        wp::int32 var_24;
        wp::int32 var_25;
        wp::int32 var_26;
        bool var_27;
        wp::int32* var_28;
        bool var_29;
        wp::int32 var_30;
        wp::int32 var_31;
        const wp::int32 var_32 = 0;
        bool var_33;
        wp::int32 var_34;
        wp::vec_t<3, wp::float32>* var_35;
        wp::vec_t<3, wp::float32> var_36;
        wp::vec_t<3, wp::float32> var_37;
        wp::vec_t<3, wp::float32>* var_38;
        wp::vec_t<3, wp::float32> var_39;
        wp::vec_t<3, wp::float32> var_40;
        wp::vec_t<3, wp::float32>* var_41;
        wp::vec_t<3, wp::float32> var_42;
        wp::vec_t<3, wp::float32> var_43;
        const wp::int32 var_44 = 0;
        bool var_45;
        wp::int32 var_46;
        const wp::int32 var_47 = 1;
        wp::int32 var_48;
        wp::int32 var_49;
        const wp::int32 var_50 = 0;
        const wp::int32 var_51 = 1;
        const wp::int32 var_52 = 256;
        wp::int32 var_53;
        const wp::int32 var_54 = 1;
        wp::int32 var_55;
        wp::int32 var_56;
        wp::int32 var_57;
        const wp::int32 var_58 = 1;
        const wp::int32 var_59 = 0;
        bool var_60;
        const wp::int32 var_61 = 1;
        const wp::int32 var_62 = 0;
        wp::int32 var_63;
        const wp::int32 var_64 = 2;
        //---------
        // forward
        // def choose_voters_kernel(points, normals, ranks, voters__points, voters__normals, voters__firsts, voters__sizes):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // total = ranks[ranks.shape[0] - 1]                                                      <L 4>
        var_1 = &(var_ranks.shape);
        var_4 = wp::load(var_1);
        var_3 = wp::extract(var_4, var_2);
        var_6 = wp::sub(var_3, var_5);
        var_7 = wp::address(var_ranks, var_6);
        var_9 = wp::load(var_7);
        var_8 = wp::copy(var_9);
        // step = max(1, (total + VOTERS - 1) // VOTERS)                                          <L 5>
        var_12 = wp::add(var_8, var_11);
        var_14 = wp::sub(var_12, var_13);
        var_15 = wp::floordiv(var_14, var_11);
        var_16 = wp::max(var_10, var_15);
        // before = int(0)                                                                        <L 6>
        var_18 = wp::int(var_17);
        // if i > 0:                                                                              <L 7>
        var_20 = (var_0 > var_19);
        if (var_20) {
            // before = ranks[i - 1]                                                              <L 8>
            var_22 = wp::sub(var_0, var_21);
            var_23 = wp::address(var_ranks, var_22);
            var_25 = wp::load(var_23);
            var_24 = wp::copy(var_25);
        }
        var_26 = wp::where(var_20, var_24, var_18);
        // if ranks[i] > before and before % step == 0:                                           <L 9>
        var_28 = wp::address(var_ranks, var_0);
        var_30 = wp::load(var_28);
        var_29 = (var_30 > var_26);
        var_27 = var_29;
        if (var_27) {
            var_31 = wp::mod(var_26, var_16);
            var_33 = (var_31 == var_32);
            var_27 = var_27 && var_33;
        }
        if (var_27) {
            // at = before // step                                                                <L 10>
            var_34 = wp::floordiv(var_26, var_16);
            // voters__points[at] = points[i]                                                     <L 11>
            var_35 = wp::address(var_points, var_0);
            var_37 = wp::load(var_35);
            var_36 = wp::copy(var_37);
            wp::array_store(var_voters__points, var_34, var_36);
            // voters__normals[at] = normals[i]                                                   <L 12>
            var_38 = wp::address(var_normals, var_0);
            var_40 = wp::load(var_38);
            var_39 = wp::copy(var_40);
            wp::array_store(var_voters__normals, var_34, var_39);
            // voters__firsts[at] = normals[i]                                                    <L 13>
            var_41 = wp::address(var_normals, var_0);
            var_43 = wp::load(var_41);
            var_42 = wp::copy(var_43);
            wp::array_store(var_voters__firsts, var_34, var_42);
        }
        // if i == 0:                                                                             <L 14>
        var_45 = (var_0 == var_44);
        if (var_45) {
            // count = (total + step - 1) // step                                                 <L 15>
            var_46 = wp::add(var_8, var_16);
            var_48 = wp::sub(var_46, var_47);
            var_49 = wp::floordiv(var_48, var_16);
            // voters__sizes[VOTERS_AT] = count                                                   <L 16>
            wp::array_store(var_voters__sizes, var_50, var_49);
            // voters__sizes[STEP_AT] = max(1, (count + PLANES - 1) // PLANES)                    <L 17>
            var_53 = wp::add(var_49, var_52);
            var_55 = wp::sub(var_53, var_54);
            var_56 = wp::floordiv(var_55, var_52);
            var_57 = wp::max(var_51, var_56);
            wp::array_store(var_voters__sizes, var_58, var_57);
            // voters__sizes[DONE_AT] = 1 if total == 0 else 0                                    <L 18>
            var_60 = (var_8 == var_59);
            if (var_60) {
            }
            if (!var_60) {
            }
            var_63 = wp::where(var_60, var_61, var_62);
            wp::array_store(var_voters__sizes, var_64, var_63);
        }
}



extern "C" __global__ void fit_plane_kernel_ea438fd2_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<10, wp::float64>> var_sums,
    wp::int32 var_is_last,
    wp::array_t<wp::int32> var_voters__sizes,
    wp::array_t<wp::vec_t<3, wp::float64>> var_voters__point,
    wp::array_t<wp::vec_t<3, wp::float64>> var_voters__normal,
    wp::array_t<wp::vec_t<3, wp::float32>> var_planes__middles,
    wp::array_t<wp::vec_t<3, wp::float32>> var_planes__directions,
    wp::array_t<wp::int32> var_planes__count)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::vec_t<10, wp::float64>* var_1;
        wp::vec_t<10, wp::float64> var_2;
        wp::vec_t<10, wp::float64> var_3;
        const wp::int32 var_4 = 0;
        wp::float64 var_5;
        wp::float64 var_6;
        bool var_7;
        const wp::int32 var_8 = 1;
        const wp::int32 var_9 = 2;
        wp::int32* var_10;
        const wp::int32 var_11 = 0;
        bool var_12;
        wp::int32 var_13;
        const wp::int32 var_14 = 0;
        wp::float64 var_15;
        const wp::int32 var_16 = 1;
        wp::float64 var_17;
        wp::float64 var_18;
        const wp::int32 var_19 = 2;
        wp::float64 var_20;
        wp::float64 var_21;
        const wp::int32 var_22 = 3;
        wp::float64 var_23;
        wp::float64 var_24;
        wp::vec_t<3, wp::float64> var_25;
        const wp::int32 var_26 = 5;
        wp::float64 var_27;
        wp::float64 var_28;
        const wp::int32 var_29 = 6;
        wp::float64 var_30;
        wp::float64 var_31;
        const wp::int32 var_32 = 8;
        wp::float64 var_33;
        wp::float64 var_34;
        const wp::int32 var_35 = 4;
        wp::float64 var_36;
        wp::float64 var_37;
        const wp::int32 var_38 = 7;
        wp::float64 var_39;
        wp::float64 var_40;
        const wp::int32 var_41 = 9;
        wp::float64 var_42;
        wp::float64 var_43;
        wp::mat_t<3, 3, wp::float64> var_44;
        wp::vec_t<3, wp::float64>* var_45;
        wp::vec_t<3, wp::float64> var_46;
        wp::vec_t<3, wp::float64> var_47;
        wp::mat_t<3, 3, wp::float64> var_48;
        wp::mat_t<3, 3, wp::float64> var_49;
        wp::vec_t<3, wp::float64> var_50;
        const wp::int32 var_51 = 1;
        bool var_52;
        const wp::int32 var_53 = 0;
        wp::int32* var_54;
        wp::int32 var_55;
        wp::int32 var_56;
        wp::vec_t<3, wp::float32> var_57;
        wp::vec_t<3, wp::float32> var_58;
        const wp::int32 var_59 = 1;
        wp::int32 var_60;
        const wp::int32 var_61 = 0;
        //---------
        // forward
        // def fit_plane_kernel(sums, is_last, voters__sizes, voters__point, voters__normal, planes__middles, planes__directions, planes__count):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // m = sums[i]                                                                            <L 4>
        var_1 = wp::address(var_sums, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // if m[0] < float64(MIN_POINTS):                                                         <L 5>
        var_5 = wp::extract(var_2, var_4);
        var_6 = 5;
        var_7 = (var_5 < var_6);
        if (var_7) {
            // voters__sizes[DONE_AT] = 1                                                         <L 6>
            wp::array_store(var_voters__sizes, var_9, var_8);
        }
        // if voters__sizes[DONE_AT] == 0:                                                        <L 7>
        var_10 = wp::address(var_voters__sizes, var_9);
        var_13 = wp::load(var_10);
        var_12 = (var_13 == var_11);
        if (var_12) {
            // c = m[0]                                                                           <L 8>
            var_15 = wp::extract(var_2, var_14);
            // mean = vec3d(m[1] / c, m[2] / c, m[3] / c)                                         <L 9>
            var_17 = wp::extract(var_2, var_16);
            var_18 = wp::div(var_17, var_15);
            var_20 = wp::extract(var_2, var_19);
            var_21 = wp::div(var_20, var_15);
            var_23 = wp::extract(var_2, var_22);
            var_24 = wp::div(var_23, var_15);
            var_25 = wp::vec_t<3, wp::float64>(var_18, var_21, var_24);
            // xy = m[5] / c                                                                      <L 10>
            var_27 = wp::extract(var_2, var_26);
            var_28 = wp::div(var_27, var_15);
            // xz = m[6] / c                                                                      <L 11>
            var_30 = wp::extract(var_2, var_29);
            var_31 = wp::div(var_30, var_15);
            // yz = m[8] / c                                                                      <L 12>
            var_33 = wp::extract(var_2, var_32);
            var_34 = wp::div(var_33, var_15);
            // squares = mat33d(m[4] / c, xy, xz, xy, m[7] / c, yz, xz, yz, m[9] / c)             <L 13>
            var_36 = wp::extract(var_2, var_35);
            var_37 = wp::div(var_36, var_15);
            var_39 = wp::extract(var_2, var_38);
            var_40 = wp::div(var_39, var_15);
            var_42 = wp::extract(var_2, var_41);
            var_43 = wp::div(var_42, var_15);
            var_44 = wp::mat_t<3, 3, wp::float64>(var_37, var_28, var_31, var_28, var_40, var_34, var_31, var_34, var_43);
            // p = voters__point[i] + mean                                                        <L 14>
            var_45 = wp::address(var_voters__point, var_0);
            var_47 = wp::load(var_45);
            var_46 = wp::add(var_47, var_25);
            // n = smallest_eigenvector(squares - outer(mean, mean))                              <L 15>
            var_48 = wp::outer(var_25, var_25);
            var_49 = wp::sub(var_44, var_48);
            var_50 = smallest_eigenvector_0(var_49);
            // voters__point[i] = p                                                               <L 16>
            wp::array_store(var_voters__point, var_0, var_46);
            // voters__normal[i] = n                                                              <L 17>
            wp::array_store(var_voters__normal, var_0, var_50);
            // if is_last == 1:                                                                   <L 18>
            var_52 = (var_is_last == var_51);
            if (var_52) {
                // at = planes__count[0]                                                          <L 19>
                var_54 = wp::address(var_planes__count, var_53);
                var_56 = wp::load(var_54);
                var_55 = wp::copy(var_56);
                // planes__middles[at] = narrow(p)                                                <L 20>
                var_57 = narrow_0(var_46);
                wp::array_store(var_planes__middles, var_55, var_57);
                // planes__directions[at] = narrow(n)                                             <L 21>
                var_58 = narrow_0(var_50);
                wp::array_store(var_planes__directions, var_55, var_58);
                // planes__count[0] = at + 1                                                      <L 22>
                var_60 = wp::add(var_55, var_59);
                wp::array_store(var_planes__count, var_61, var_60);
            }
        }
}



extern "C" __global__ void choose_plane_kernel_fc990676_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_voters__points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_voters__firsts,
    wp::array_t<wp::int32> var_voters__sizes,
    wp::array_t<wp::int32> var_voters__counts,
    wp::array_t<wp::vec_t<3, wp::float64>> var_voters__point,
    wp::array_t<wp::vec_t<3, wp::float64>> var_voters__normal)
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
        wp::int32 var_4;
        wp::int32* var_5;
        wp::int32* var_6;
        bool var_7;
        wp::int32 var_8;
        wp::int32 var_9;
        wp::int32 var_10;
        wp::int32 var_11;
        const wp::int32 var_12 = 2;
        wp::int32* var_13;
        const wp::int32 var_14 = 0;
        bool var_15;
        wp::int32 var_16;
        const wp::int32 var_17 = 1;
        wp::int32* var_18;
        wp::int32 var_19;
        wp::int32 var_20;
        wp::vec_t<3, wp::float32>* var_21;
        wp::vec_t<3, wp::float64> var_22;
        wp::vec_t<3, wp::float32> var_23;
        wp::int32* var_24;
        wp::int32 var_25;
        wp::int32 var_26;
        wp::vec_t<3, wp::float32>* var_27;
        wp::vec_t<3, wp::float64> var_28;
        wp::vec_t<3, wp::float32> var_29;
        //---------
        // forward
        // def choose_plane_kernel(voters__points, voters__firsts, voters__sizes, voters__counts, voters__point, voters__normal):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // best = int(0)                                                                          <L 4>
        var_2 = wp::int(var_1);
        // for k in range(PLANES):                                                                <L 5>
        var_3 = 0;
        start_for_0:;
            if (var_3 >= 256) goto end_for_0;
            var_4 = var_3;
            var_3 += 1;
            // if voters__counts[k] > voters__counts[best]:                                       <L 6>
            var_5 = wp::address(var_voters__counts, var_4);
            var_6 = wp::address(var_voters__counts, var_2);
            var_8 = wp::load(var_5);
            var_9 = wp::load(var_6);
            var_7 = (var_8 > var_9);
            if (var_7) {
                // best = k                                                                       <L 7>
                var_10 = wp::copy(var_4);
            }
            var_11 = wp::where(var_7, var_10, var_2);
            wp::assign(var_2, var_11);
            goto start_for_0;
        end_for_0:;
        // if voters__sizes[DONE_AT] == 0:                                                        <L 8>
        var_13 = wp::address(var_voters__sizes, var_12);
        var_16 = wp::load(var_13);
        var_15 = (var_16 == var_14);
        if (var_15) {
            // voters__point[i] = widen(voters__points[best * voters__sizes[STEP_AT]])            <L 9>
            var_18 = wp::address(var_voters__sizes, var_17);
            var_20 = wp::load(var_18);
            var_19 = wp::mul(var_2, var_20);
            var_21 = wp::address(var_voters__points, var_19);
            var_23 = wp::load(var_21);
            var_22 = widen_0(var_23);
            wp::array_store(var_voters__point, var_0, var_22);
            // voters__normal[i] = widen(voters__firsts[best * voters__sizes[STEP_AT]])           <L 10>
            var_24 = wp::address(var_voters__sizes, var_17);
            var_26 = wp::load(var_24);
            var_25 = wp::mul(var_2, var_26);
            var_27 = wp::address(var_voters__firsts, var_25);
            var_29 = wp::load(var_27);
            var_28 = widen_0(var_29);
            wp::array_store(var_voters__normal, var_0, var_28);
        }
}


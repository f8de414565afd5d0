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


// /work/main/src/pointloom/kernels/rgbd/pyramid.py:222
static CUDA_CALLABLE wp::int32 group_count_0(
    wp::vec_t<4, wp::int32> var_size)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 1;
    wp::int32 var_1;
    const wp::int32 var_2 = 0;
    wp::int32 var_3;
    const wp::int32 var_4 = 8;
    wp::int32 var_5;
    const wp::int32 var_6 = 1;
    wp::int32 var_7;
    wp::int32 var_8;
    wp::int32 var_9;
    //---------
    // forward
    // def group_count(size: vec4i) -> int:                                                   <L 223>
    // return size[1] * ((size[0] + LANES - 1) // LANES)                                      <L 224>
    var_1 = wp::extract(var_size, var_0);
    var_3 = wp::extract(var_size, var_2);
    var_5 = wp::add(var_3, var_4);
    var_7 = wp::sub(var_5, var_6);
    var_8 = wp::floordiv(var_7, var_4);
    var_9 = wp::mul(var_1, var_8);
    return var_9;
}


// /work/main/src/pointloom/kernels/rgbd/pyramid.py:189
static CUDA_CALLABLE wp::vec_t<5, wp::float32> plane_of_2(
    wp::vec_t<9, wp::float32> var_sums,
    wp::float32 var_z,
    wp::float32 var_u,
    wp::float32 var_v,
    wp::vec_t<4, wp::float32> var_lens,
    wp::float32 var_support)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    const wp::int32 var_2 = 1;
    wp::float32 var_3;
    wp::float32 var_4;
    const wp::int32 var_5 = 2;
    wp::float32 var_6;
    wp::float32 var_7;
    const wp::int32 var_8 = 6;
    wp::float32 var_9;
    wp::float32 var_10;
    const wp::int32 var_11 = 3;
    wp::float32 var_12;
    wp::float32 var_13;
    wp::float32 var_14;
    wp::float32 var_15;
    const wp::int32 var_16 = 4;
    wp::float32 var_17;
    wp::float32 var_18;
    wp::float32 var_19;
    wp::float32 var_20;
    const wp::int32 var_21 = 5;
    wp::float32 var_22;
    wp::float32 var_23;
    wp::float32 var_24;
    wp::float32 var_25;
    const wp::int32 var_26 = 7;
    wp::float32 var_27;
    wp::float32 var_28;
    wp::float32 var_29;
    wp::float32 var_30;
    const wp::int32 var_31 = 8;
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
    wp::float32 var_44;
    wp::float32 var_45;
    wp::float32 var_46;
    const wp::float32 var_47 = 1.0;
    wp::float32 var_48;
    wp::float32 var_49;
    wp::float32 var_50;
    wp::float32 var_51;
    wp::float32 var_52;
    wp::float32 var_53;
    const wp::int32 var_54 = 0;
    wp::float32 var_55;
    wp::float32 var_56;
    const wp::int32 var_57 = 1;
    wp::float32 var_58;
    wp::float32 var_59;
    const wp::int32 var_60 = 2;
    wp::float32 var_61;
    wp::float32 var_62;
    wp::float32 var_63;
    wp::float32 var_64;
    const wp::int32 var_65 = 3;
    wp::float32 var_66;
    wp::float32 var_67;
    wp::float32 var_68;
    wp::float32 var_69;
    wp::float32 var_70;
    wp::float32 var_71;
    wp::float32 var_72;
    wp::float32 var_73;
    wp::float32 var_74;
    wp::float32 var_75;
    const wp::int32 var_76 = 2;
    wp::float32 var_77;
    wp::float32 var_78;
    const wp::int32 var_79 = 0;
    wp::float32 var_80;
    wp::float32 var_81;
    const wp::int32 var_82 = 3;
    wp::float32 var_83;
    wp::float32 var_84;
    const wp::int32 var_85 = 1;
    wp::float32 var_86;
    wp::float32 var_87;
    wp::float32 var_88;
    wp::float32 var_89;
    wp::float32 var_90;
    const wp::float32 var_91 = 1.0;
    wp::float32 var_92;
    wp::float32 var_93;
    bool var_94;
    bool var_95;
    const wp::float32 var_96 = 0.1;
    bool var_97;
    const wp::float32 var_98 = 0.08;
    wp::float32 var_99;
    wp::float32 var_100;
    bool var_101;
    wp::float32 var_102;
    wp::float32 var_103;
    const wp::float32 var_104 = 0.0;
    wp::float32 var_105;
    wp::float32 var_106;
    wp::float32 var_107;
    const wp::float32 var_108 = 0.0;
    wp::float32 var_109;
    wp::float32 var_110;
    wp::float32 var_111;
    const wp::float32 var_112 = 0.0;
    wp::float32 var_113;
    const wp::float32 var_114 = -1.0;
    wp::float32 var_115;
    const wp::float32 var_116 = 0.0;
    wp::float32 var_117;
    const wp::float32 var_118 = 1.0;
    wp::float32 var_119;
    wp::float32 var_120;
    wp::vec_t<5, wp::float32> var_121;
    //---------
    // forward
    // def plane_of(sums: nine, z: float, u: float, v: float, lens: vec4, support: float) -> five:       <L 190>
    // n = sums[0]                                                                            <L 192>
    var_1 = wp::extract(var_sums, var_0);
    // mu = sums[1] / n                                                                       <L 193>
    var_3 = wp::extract(var_sums, var_2);
    var_4 = wp::div(var_3, var_1);
    // mv = sums[2] / n                                                                       <L 194>
    var_6 = wp::extract(var_sums, var_5);
    var_7 = wp::div(var_6, var_1);
    // mw = sums[6] / n                                                                       <L 195>
    var_9 = wp::extract(var_sums, var_8);
    var_10 = wp::div(var_9, var_1);
    // cuu = sums[3] / n - mu * mu                                                            <L 196>
    var_12 = wp::extract(var_sums, var_11);
    var_13 = wp::div(var_12, var_1);
    var_14 = wp::mul(var_4, var_4);
    var_15 = wp::sub(var_13, var_14);
    // cuv = sums[4] / n - mu * mv                                                            <L 197>
    var_17 = wp::extract(var_sums, var_16);
    var_18 = wp::div(var_17, var_1);
    var_19 = wp::mul(var_4, var_7);
    var_20 = wp::sub(var_18, var_19);
    // cvv = sums[5] / n - mv * mv                                                            <L 198>
    var_22 = wp::extract(var_sums, var_21);
    var_23 = wp::div(var_22, var_1);
    var_24 = wp::mul(var_7, var_7);
    var_25 = wp::sub(var_23, var_24);
    // cuw = sums[7] / n - mu * mw                                                            <L 199>
    var_27 = wp::extract(var_sums, var_26);
    var_28 = wp::div(var_27, var_1);
    var_29 = wp::mul(var_4, var_10);
    var_30 = wp::sub(var_28, var_29);
    // cvw = sums[8] / n - mv * mw                                                            <L 200>
    var_32 = wp::extract(var_sums, var_31);
    var_33 = wp::div(var_32, var_1);
    var_34 = wp::mul(var_7, var_10);
    var_35 = wp::sub(var_33, var_34);
    // det = cuu * cvv - cuv * cuv                                                            <L 201>
    var_36 = wp::mul(var_15, var_25);
    var_37 = wp::mul(var_20, var_20);
    var_38 = wp::sub(var_36, var_37);
    // a = (cuw * cvv - cvw * cuv) / det                                                      <L 202>
    var_39 = wp::mul(var_30, var_25);
    var_40 = wp::mul(var_35, var_20);
    var_41 = wp::sub(var_39, var_40);
    var_42 = wp::div(var_41, var_38);
    // b = (cvw * cuu - cuw * cuv) / det                                                      <L 203>
    var_43 = wp::mul(var_35, var_15);
    var_44 = wp::mul(var_30, var_20);
    var_45 = wp::sub(var_43, var_44);
    var_46 = wp::div(var_45, var_38);
    // c = 1.0 / z + mw - a * mu - b * mv                                                     <L 204>
    var_48 = wp::div(var_47, var_z);
    var_49 = wp::add(var_48, var_10);
    var_50 = wp::mul(var_42, var_4);
    var_51 = wp::sub(var_49, var_50);
    var_52 = wp::mul(var_46, var_7);
    var_53 = wp::sub(var_51, var_52);
    // nx = a * lens[0]                                                                       <L 205>
    var_55 = wp::extract(var_lens, var_54);
    var_56 = wp::mul(var_42, var_55);
    // ny = b * lens[1]                                                                       <L 206>
    var_58 = wp::extract(var_lens, var_57);
    var_59 = wp::mul(var_46, var_58);
    // nz = c + a * (lens[2] - u) + b * (lens[3] - v)                                         <L 207>
    var_61 = wp::extract(var_lens, var_60);
    var_62 = wp::sub(var_61, var_u);
    var_63 = wp::mul(var_42, var_62);
    var_64 = wp::add(var_53, var_63);
    var_66 = wp::extract(var_lens, var_65);
    var_67 = wp::sub(var_66, var_v);
    var_68 = wp::mul(var_46, var_67);
    var_69 = wp::add(var_64, var_68);
    // length = sqrt(nx * nx + ny * ny + nz * nz)                                             <L 208>
    var_70 = wp::mul(var_56, var_56);
    var_71 = wp::mul(var_59, var_59);
    var_72 = wp::add(var_70, var_71);
    var_73 = wp::mul(var_69, var_69);
    var_74 = wp::add(var_72, var_73);
    var_75 = wp::sqrt(var_74);
    // rx = (u - lens[2]) / lens[0]                                                           <L 209>
    var_77 = wp::extract(var_lens, var_76);
    var_78 = wp::sub(var_u, var_77);
    var_80 = wp::extract(var_lens, var_79);
    var_81 = wp::div(var_78, var_80);
    // ry = (v - lens[3]) / lens[1]                                                           <L 210>
    var_83 = wp::extract(var_lens, var_82);
    var_84 = wp::sub(var_v, var_83);
    var_86 = wp::extract(var_lens, var_85);
    var_87 = wp::div(var_84, var_86);
    // ray = sqrt(rx * rx + ry * ry + 1.0)                                                    <L 211>
    var_88 = wp::mul(var_81, var_81);
    var_89 = wp::mul(var_87, var_87);
    var_90 = wp::add(var_88, var_89);
    var_92 = wp::add(var_90, var_91);
    var_93 = wp::sqrt(var_92);
    // has_plane = n >= support and det > 0.1 and c > MIN_SINE * length * ray  # n . ray = c here       <L 212>
    var_95 = (var_1 >= var_support);
    var_94 = var_95;
    if (var_94) {
        var_97 = (var_38 > var_96);
        var_94 = var_94 && var_97;
    }
    if (var_94) {
        var_99 = wp::mul(var_98, var_75);
        var_100 = wp::mul(var_99, var_93);
        var_101 = (var_53 > var_100);
        var_94 = var_94 && var_101;
    }
    // return five(                                                                           <L 213>
    // -nx / length if has_plane else 0.0,                                                    <L 214>
    if (var_94) {
        var_102 = wp::neg(var_56);
        var_103 = wp::div(var_102, var_75);
    }
    if (!var_94) {
    }
    var_105 = wp::where(var_94, var_103, var_104);
    // -ny / length if has_plane else 0.0,                                                    <L 215>
    if (var_94) {
        var_106 = wp::neg(var_59);
        var_107 = wp::div(var_106, var_75);
    }
    if (!var_94) {
    }
    var_109 = wp::where(var_94, var_107, var_108);
    // -nz / length if has_plane else 0.0,                                                    <L 216>
    if (var_94) {
        var_110 = wp::neg(var_69);
        var_111 = wp::div(var_110, var_75);
    }
    if (!var_94) {
    }
    var_113 = wp::where(var_94, var_111, var_112);
    // -1.0 / length if has_plane else 0.0,                                                   <L 217>
    if (var_94) {
        var_115 = wp::div(var_114, var_75);
    }
    if (!var_94) {
    }
    var_117 = wp::where(var_94, var_115, var_116);
    // 1.0 / c if has_plane else z,                                                           <L 218>
    if (var_94) {
        var_119 = wp::div(var_118, var_53);
    }
    if (!var_94) {
    }
    var_120 = wp::where(var_94, var_119, var_z);
    var_121 = wp::vec_t<5, wp::float32>({var_105, var_109, var_113, var_117, var_120});
    return var_121;
}


// /work/main/src/pointloom/kernels/rgbd/pyramid.py:79
static CUDA_CALLABLE wp::float32 nearest_depth_0(
    wp::float32 var_a,
    wp::float32 var_b,
    wp::float32 var_c,
    wp::float32 var_d)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 1e+30;
    wp::float32 var_1;
    const wp::float32 var_2 = 0.0;
    bool var_3;
    wp::float32 var_4;
    wp::float32 var_5;
    const wp::float32 var_6 = 0.0;
    bool var_7;
    wp::float32 var_8;
    wp::float32 var_9;
    const wp::float32 var_10 = 0.0;
    bool var_11;
    wp::float32 var_12;
    wp::float32 var_13;
    const wp::float32 var_14 = 0.0;
    bool var_15;
    wp::float32 var_16;
    wp::float32 var_17;
    //---------
    // forward
    // def nearest_depth(a: float, b: float, c: float, d: float) -> float:                    <L 80>
    // near = float(NO_DEPTH)                                                                 <L 82>
    var_1 = wp::float(var_0);
    // if a > 0.0:                                                                            <L 83>
    var_3 = (var_a > var_2);
    if (var_3) {
        // near = min(near, a)                                                                <L 84>
        var_4 = wp::min(var_1, var_a);
    }
    var_5 = wp::where(var_3, var_4, var_1);
    // if b > 0.0:                                                                            <L 85>
    var_7 = (var_b > var_6);
    if (var_7) {
        // near = min(near, b)                                                                <L 86>
        var_8 = wp::min(var_5, var_b);
    }
    var_9 = wp::where(var_7, var_8, var_5);
    // if c > 0.0:                                                                            <L 87>
    var_11 = (var_c > var_10);
    if (var_11) {
        // near = min(near, c)                                                                <L 88>
        var_12 = wp::min(var_9, var_c);
    }
    var_13 = wp::where(var_11, var_12, var_9);
    // if d > 0.0:                                                                            <L 89>
    var_15 = (var_d > var_14);
    if (var_15) {
        // near = min(near, d)                                                                <L 90>
        var_16 = wp::min(var_13, var_d);
    }
    var_17 = wp::where(var_15, var_16, var_13);
    // return near                                                                            <L 91>
    return var_17;
}


// <pointloom.kernels.rgbd.pyramid.halved_depth>:1
static CUDA_CALLABLE wp::float32 halved_depth_0(
    wp::float32 var_a,
    wp::float32 var_b,
    wp::float32 var_c,
    wp::float32 var_d)
{
    //---------
    // primal vars
    wp::float32 var_0;
    const wp::float32 var_1 = 1.0;
    const wp::float32 var_2 = 0.04;
    wp::float32 var_3;
    wp::float32 var_4;
    const wp::float32 var_5 = 0.0;
    wp::float32 var_6;
    const wp::float32 var_7 = 0.0;
    wp::float32 var_8;
    bool var_9;
    const wp::float32 var_10 = 0.0;
    bool var_11;
    bool var_12;
    wp::float32 var_13;
    const wp::float32 var_14 = 1.0;
    wp::float32 var_15;
    wp::float32 var_16;
    wp::float32 var_17;
    bool var_18;
    const wp::float32 var_19 = 0.0;
    bool var_20;
    bool var_21;
    wp::float32 var_22;
    const wp::float32 var_23 = 1.0;
    wp::float32 var_24;
    wp::float32 var_25;
    wp::float32 var_26;
    bool var_27;
    const wp::float32 var_28 = 0.0;
    bool var_29;
    bool var_30;
    wp::float32 var_31;
    const wp::float32 var_32 = 1.0;
    wp::float32 var_33;
    wp::float32 var_34;
    wp::float32 var_35;
    bool var_36;
    const wp::float32 var_37 = 0.0;
    bool var_38;
    bool var_39;
    wp::float32 var_40;
    const wp::float32 var_41 = 1.0;
    wp::float32 var_42;
    wp::float32 var_43;
    wp::float32 var_44;
    const wp::float32 var_45 = 0.0;
    wp::float32 var_46;
    const wp::float32 var_47 = 0.0;
    bool var_48;
    wp::float32 var_49;
    wp::float32 var_50;
    //---------
    // forward
    // def halved_depth(a, b, c, d):                                                          <L 1>
    // near = nearest_depth(a, b, c, d)                                                       <L 3>
    var_0 = nearest_depth_0(var_a, var_b, var_c, var_d);
    // far = near * (1.0 + SAME_SURFACE)                                                      <L 4>
    var_3 = wp::add(var_1, var_2);
    var_4 = wp::mul(var_0, var_3);
    // total = float(0.0)                                                                     <L 5>
    var_6 = wp::float(var_5);
    // count = float(0.0)                                                                     <L 6>
    var_8 = wp::float(var_7);
    // if a > 0.0 and a <= far:                                                               <L 7>
    var_11 = (var_a > var_10);
    var_9 = var_11;
    if (var_9) {
        var_12 = (var_a <= var_4);
        var_9 = var_9 && var_12;
    }
    if (var_9) {
        // total += a                                                                         <L 8>
        var_13 = wp::add(var_6, var_a);
        // count += 1.0                                                                       <L 9>
        var_15 = wp::add(var_8, var_14);
    }
    var_16 = wp::where(var_9, var_13, var_6);
    var_17 = wp::where(var_9, var_15, var_8);
    // if b > 0.0 and b <= far:                                                               <L 10>
    var_20 = (var_b > var_19);
    var_18 = var_20;
    if (var_18) {
        var_21 = (var_b <= var_4);
        var_18 = var_18 && var_21;
    }
    if (var_18) {
        // total += b                                                                         <L 11>
        var_22 = wp::add(var_16, var_b);
        // count += 1.0                                                                       <L 12>
        var_24 = wp::add(var_17, var_23);
    }
    var_25 = wp::where(var_18, var_22, var_16);
    var_26 = wp::where(var_18, var_24, var_17);
    // if c > 0.0 and c <= far:                                                               <L 13>
    var_29 = (var_c > var_28);
    var_27 = var_29;
    if (var_27) {
        var_30 = (var_c <= var_4);
        var_27 = var_27 && var_30;
    }
    if (var_27) {
        // total += c                                                                         <L 14>
        var_31 = wp::add(var_25, var_c);
        // count += 1.0                                                                       <L 15>
        var_33 = wp::add(var_26, var_32);
    }
    var_34 = wp::where(var_27, var_31, var_25);
    var_35 = wp::where(var_27, var_33, var_26);
    // if d > 0.0 and d <= far:                                                               <L 16>
    var_38 = (var_d > var_37);
    var_36 = var_38;
    if (var_36) {
        var_39 = (var_d <= var_4);
        var_36 = var_36 && var_39;
    }
    if (var_36) {
        // total += d                                                                         <L 17>
        var_40 = wp::add(var_34, var_d);
        // count += 1.0                                                                       <L 18>
        var_42 = wp::add(var_35, var_41);
    }
    var_43 = wp::where(var_36, var_40, var_34);
    var_44 = wp::where(var_36, var_42, var_35);
    // mean = float(0.0)                                                                      <L 19>
    var_46 = wp::float(var_45);
    // if count > 0.0:                                                                        <L 20>
    var_48 = (var_44 > var_47);
    if (var_48) {
        // mean = total / count                                                               <L 21>
        var_49 = wp::div(var_43, var_44);
    }
    var_50 = wp::where(var_48, var_49, var_46);
    // return mean                                                                            <L 22>
    return var_50;
}


// /work/main/src/pointloom/kernels/rgbd/pyramid.py:119
static CUDA_CALLABLE wp::float32 halved_brightness_0(
    wp::float32 var_a,
    wp::float32 var_b,
    wp::float32 var_c,
    wp::float32 var_d)
{
    //---------
    // primal vars
    wp::float32 var_0;
    wp::float32 var_1;
    wp::float32 var_2;
    const wp::float32 var_3 = 0.25;
    wp::float32 var_4;
    wp::float32 var_5;
    wp::float32 var_6;
    wp::float32 var_7;
    const wp::float32 var_8 = 0.0;
    bool var_9;
    const wp::float32 var_10 = -1.0;
    wp::float32 var_11;
    wp::float32 var_12;
    //---------
    // forward
    // def halved_brightness(a: float, b: float, c: float, d: float) -> float:                <L 120>
    // mean = (a + b + c + d) * 0.25                                                          <L 122>
    var_0 = wp::add(var_a, var_b);
    var_1 = wp::add(var_0, var_c);
    var_2 = wp::add(var_1, var_d);
    var_4 = wp::mul(var_2, var_3);
    // if min(min(a, b), min(c, d)) < 0.0:                                                    <L 123>
    var_5 = wp::min(var_a, var_b);
    var_6 = wp::min(var_c, var_d);
    var_7 = wp::min(var_5, var_6);
    var_9 = (var_7 < var_8);
    if (var_9) {
        // mean = NO_COLOR                                                                    <L 124>
        var_11 = wp::copy(var_10);
    }
    var_12 = wp::where(var_9, var_11, var_4);
    // return mean                                                                            <L 125>
    return var_12;
}


// /work/main/src/pointloom/kernels/rgbd/pyramid.py:147
static CUDA_CALLABLE wp::float32 luma_0(
    wp::int32 var_at,
    wp::array_t<wp::uint8> var_pixels)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 0.299;
    const wp::int32 var_1 = 0;
    wp::uint8* var_2;
    wp::float32 var_3;
    wp::uint8 var_4;
    wp::float32 var_5;
    const wp::float32 var_6 = 0.587;
    const wp::int32 var_7 = 1;
    wp::uint8* var_8;
    wp::float32 var_9;
    wp::uint8 var_10;
    wp::float32 var_11;
    wp::float32 var_12;
    const wp::float32 var_13 = 0.114;
    const wp::int32 var_14 = 2;
    wp::uint8* var_15;
    wp::float32 var_16;
    wp::uint8 var_17;
    wp::float32 var_18;
    wp::float32 var_19;
    const wp::float32 var_20 = 255.0;
    wp::float32 var_21;
    //---------
    // forward
    // def luma(at: int, pixels: array(dtype=uint8, ndim=2)) -> float:                        <L 148>
    // return (RED * float(pixels[at, 0]) + GREEN * float(pixels[at, 1]) + BLUE * float(pixels[at, 2])) / 255.0       <L 149>
    var_2 = wp::address(var_pixels, var_at, var_1);
    var_4 = wp::load(var_2);
    var_3 = wp::float(var_4);
    var_5 = wp::mul(var_0, var_3);
    var_8 = wp::address(var_pixels, var_at, var_7);
    var_10 = wp::load(var_8);
    var_9 = wp::float(var_10);
    var_11 = wp::mul(var_6, var_9);
    var_12 = wp::add(var_5, var_11);
    var_15 = wp::address(var_pixels, var_at, var_14);
    var_17 = wp::load(var_15);
    var_16 = wp::float(var_17);
    var_18 = wp::mul(var_13, var_16);
    var_19 = wp::add(var_12, var_18);
    var_21 = wp::div(var_19, var_20);
    return var_21;
}


// /work/main/src/pointloom/kernels/rgbd/pyramid.py:222
static CUDA_CALLABLE void adj_group_count_0(
    wp::vec_t<4, wp::int32> var_size,
    wp::vec_t<4, wp::int32> & adj_size,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/rgbd/pyramid.py:189
static CUDA_CALLABLE void adj_plane_of_2(
    wp::vec_t<9, wp::float32> var_sums,
    wp::float32 var_z,
    wp::float32 var_u,
    wp::float32 var_v,
    wp::vec_t<4, wp::float32> var_lens,
    wp::float32 var_support,
    wp::vec_t<9, wp::float32> & adj_sums,
    wp::float32 & adj_z,
    wp::float32 & adj_u,
    wp::float32 & adj_v,
    wp::vec_t<4, wp::float32> & adj_lens,
    wp::float32 & adj_support,
    wp::vec_t<5, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/rgbd/pyramid.py:79
static CUDA_CALLABLE void adj_nearest_depth_0(
    wp::float32 var_a,
    wp::float32 var_b,
    wp::float32 var_c,
    wp::float32 var_d,
    wp::float32 & adj_a,
    wp::float32 & adj_b,
    wp::float32 & adj_c,
    wp::float32 & adj_d,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.rgbd.pyramid.halved_depth>:1
static CUDA_CALLABLE void adj_halved_depth_0(
    wp::float32 var_a,
    wp::float32 var_b,
    wp::float32 var_c,
    wp::float32 var_d,
    wp::float32 & adj_a,
    wp::float32 & adj_b,
    wp::float32 & adj_c,
    wp::float32 & adj_d,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/rgbd/pyramid.py:119
static CUDA_CALLABLE void adj_halved_brightness_0(
    wp::float32 var_a,
    wp::float32 var_b,
    wp::float32 var_c,
    wp::float32 var_d,
    wp::float32 & adj_a,
    wp::float32 & adj_b,
    wp::float32 & adj_c,
    wp::float32 & adj_d,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/rgbd/pyramid.py:147
static CUDA_CALLABLE void adj_luma_0(
    wp::int32 var_at,
    wp::array_t<wp::uint8> var_pixels,
    wp::int32 & adj_at,
    wp::array_t<wp::uint8> & adj_pixels,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void fit_planes_kernel_1deb17de_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::int32 var_radius,
    wp::array_t<wp::vec_t<4, wp::int32>> var_levels__layout,
    wp::array_t<wp::vec_t<4, wp::float32>> var_levels__lenses,
    wp::array_t<wp::float32> var_levels__depth,
    wp::array_t<wp::vec_t<4, wp::float32>> var_planes,
    wp::array_t<wp::float32> var_smoothed)
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
        wp::shape_t* var_4;
        const wp::int32 var_5 = 0;
        wp::int32 var_6;
        wp::shape_t var_7;
        const wp::int32 var_8 = 1;
        wp::int32 var_9;
        wp::range_t var_10;
        wp::int32 var_11;
        wp::vec_t<4, wp::int32>* var_12;
        wp::int32 var_13;
        wp::vec_t<4, wp::int32> var_14;
        bool var_15;
        bool var_16;
        bool var_17;
        const wp::int32 var_18 = 1;
        wp::int32 var_19;
        wp::int32 var_20;
        wp::int32 var_21;
        wp::int32 var_22;
        wp::vec_t<4, wp::int32>* var_23;
        wp::vec_t<4, wp::int32> var_24;
        wp::vec_t<4, wp::int32> var_25;
        wp::vec_t<4, wp::float32>* var_26;
        wp::vec_t<4, wp::float32> var_27;
        wp::vec_t<4, wp::float32> var_28;
        const wp::int32 var_29 = 0;
        wp::int32 var_30;
        const wp::int32 var_31 = 8;
        wp::int32 var_32;
        const wp::int32 var_33 = 1;
        wp::int32 var_34;
        wp::int32 var_35;
        wp::int32 var_36;
        wp::int32 var_37;
        wp::int32 var_38;
        const wp::int32 var_39 = 1;
        wp::int32 var_40;
        wp::int32 var_41;
        wp::int32 var_42;
        const wp::int32 var_43 = 2;
        wp::int32 var_44;
        wp::int32 var_45;
        wp::int32 var_46;
        const wp::float32 var_47 = 0.0;
        wp::vec_t<8, wp::float32> var_48;
        const wp::float32 var_49 = 0.0;
        wp::vec_t<8, wp::float32> var_50;
        const wp::float32 var_51 = 0.0;
        wp::vec_t<8, wp::float32> var_52;
        const wp::float32 var_53 = 0.0;
        wp::vec_t<8, wp::float32> var_54;
        const wp::float32 var_55 = 0.0;
        wp::vec_t<8, wp::float32> var_56;
        const wp::float32 var_57 = 0.0;
        wp::vec_t<8, wp::float32> var_58;
        const wp::float32 var_59 = 0.0;
        wp::vec_t<8, wp::float32> var_60;
        const wp::float32 var_61 = 0.0;
        wp::vec_t<8, wp::float32> var_62;
        const wp::float32 var_63 = 0.0;
        wp::vec_t<8, wp::float32> var_64;
        const wp::float32 var_65 = 0.0;
        wp::vec_t<8, wp::float32> var_66;
        const wp::float32 var_67 = 0.0;
        wp::vec_t<8, wp::float32> var_68;
        const wp::int32 var_69 = 0;
        wp::int32 var_70;
        const wp::int32 var_71 = 1;
        wp::int32 var_72;
        wp::int32 var_73;
        wp::int32 var_74;
        wp::float32* var_75;
        wp::float32 var_76;
        wp::float32 var_77;
        const wp::int32 var_78 = 1;
        wp::int32 var_79;
        const wp::int32 var_80 = 1;
        wp::int32 var_81;
        wp::int32 var_82;
        wp::int32 var_83;
        wp::float32* var_84;
        wp::float32 var_85;
        wp::float32 var_86;
        const wp::int32 var_87 = 2;
        wp::int32 var_88;
        const wp::int32 var_89 = 1;
        wp::int32 var_90;
        wp::int32 var_91;
        wp::int32 var_92;
        wp::float32* var_93;
        wp::float32 var_94;
        wp::float32 var_95;
        const wp::int32 var_96 = 3;
        wp::int32 var_97;
        const wp::int32 var_98 = 1;
        wp::int32 var_99;
        wp::int32 var_100;
        wp::int32 var_101;
        wp::float32* var_102;
        wp::float32 var_103;
        wp::float32 var_104;
        const wp::int32 var_105 = 4;
        wp::int32 var_106;
        const wp::int32 var_107 = 1;
        wp::int32 var_108;
        wp::int32 var_109;
        wp::int32 var_110;
        wp::float32* var_111;
        wp::float32 var_112;
        wp::float32 var_113;
        const wp::int32 var_114 = 5;
        wp::int32 var_115;
        const wp::int32 var_116 = 1;
        wp::int32 var_117;
        wp::int32 var_118;
        wp::int32 var_119;
        wp::float32* var_120;
        wp::float32 var_121;
        wp::float32 var_122;
        const wp::int32 var_123 = 6;
        wp::int32 var_124;
        const wp::int32 var_125 = 1;
        wp::int32 var_126;
        wp::int32 var_127;
        wp::int32 var_128;
        wp::float32* var_129;
        wp::float32 var_130;
        wp::float32 var_131;
        const wp::int32 var_132 = 7;
        wp::int32 var_133;
        const wp::int32 var_134 = 1;
        wp::int32 var_135;
        wp::int32 var_136;
        wp::int32 var_137;
        wp::float32* var_138;
        wp::float32 var_139;
        wp::float32 var_140;
        wp::int32 var_141;
        wp::int32 var_142;
        wp::int32 var_143;
        const wp::int32 var_144 = 1;
        wp::int32 var_145;
        const wp::int32 var_146 = 1;
        wp::int32 var_147;
        wp::int32 var_148;
        wp::int32 var_149;
        const wp::int32 var_150 = 1;
        wp::int32 var_151;
        wp::range_t var_152;
        wp::int32 var_153;
        wp::int32 var_154;
        wp::float32 var_155;
        wp::int32 var_156;
        const wp::int32 var_157 = 1;
        wp::int32 var_158;
        wp::range_t var_159;
        wp::int32 var_160;
        wp::float32 var_161;
        wp::int32 var_162;
        bool var_163;
        const wp::int32 var_164 = 0;
        bool var_165;
        wp::int32 var_166;
        bool var_167;
        const wp::int32 var_168 = 0;
        wp::int32 var_169;
        wp::int32 var_170;
        wp::int32 var_171;
        wp::int32 var_172;
        wp::float32* var_173;
        wp::float32 var_174;
        wp::float32 var_175;
        const wp::int32 var_176 = 1;
        wp::int32 var_177;
        wp::int32 var_178;
        wp::int32 var_179;
        wp::int32 var_180;
        wp::float32* var_181;
        wp::float32 var_182;
        wp::float32 var_183;
        const wp::int32 var_184 = 2;
        wp::int32 var_185;
        wp::int32 var_186;
        wp::int32 var_187;
        wp::int32 var_188;
        wp::float32* var_189;
        wp::float32 var_190;
        wp::float32 var_191;
        const wp::int32 var_192 = 3;
        wp::int32 var_193;
        wp::int32 var_194;
        wp::int32 var_195;
        wp::int32 var_196;
        wp::float32* var_197;
        wp::float32 var_198;
        wp::float32 var_199;
        const wp::int32 var_200 = 4;
        wp::int32 var_201;
        wp::int32 var_202;
        wp::int32 var_203;
        wp::int32 var_204;
        wp::float32* var_205;
        wp::float32 var_206;
        wp::float32 var_207;
        const wp::int32 var_208 = 5;
        wp::int32 var_209;
        wp::int32 var_210;
        wp::int32 var_211;
        wp::int32 var_212;
        wp::float32* var_213;
        wp::float32 var_214;
        wp::float32 var_215;
        const wp::int32 var_216 = 6;
        wp::int32 var_217;
        wp::int32 var_218;
        wp::int32 var_219;
        wp::int32 var_220;
        wp::float32* var_221;
        wp::float32 var_222;
        wp::float32 var_223;
        const wp::int32 var_224 = 7;
        wp::int32 var_225;
        wp::int32 var_226;
        wp::int32 var_227;
        wp::int32 var_228;
        wp::float32* var_229;
        wp::float32 var_230;
        wp::float32 var_231;
        const wp::int32 var_232 = 0;
        wp::int32 var_233;
        const wp::int32 var_234 = 0;
        wp::int32 var_235;
        const wp::int32 var_236 = 1;
        wp::int32 var_237;
        wp::int32 var_238;
        wp::int32 var_239;
        wp::int32 var_240;
        wp::int32 var_241;
        wp::float32* var_242;
        wp::float32 var_243;
        wp::float32 var_244;
        wp::int32 var_245;
        bool var_246;
        const wp::float32 var_247 = 0.0;
        wp::float32 var_248;
        const wp::int32 var_249 = 1;
        wp::int32 var_250;
        const wp::int32 var_251 = 0;
        wp::int32 var_252;
        const wp::int32 var_253 = 1;
        wp::int32 var_254;
        wp::int32 var_255;
        wp::int32 var_256;
        wp::int32 var_257;
        wp::int32 var_258;
        wp::float32* var_259;
        wp::float32 var_260;
        wp::float32 var_261;
        wp::int32 var_262;
        bool var_263;
        const wp::float32 var_264 = 0.0;
        wp::float32 var_265;
        const wp::int32 var_266 = 2;
        wp::int32 var_267;
        const wp::int32 var_268 = 0;
        wp::int32 var_269;
        const wp::int32 var_270 = 1;
        wp::int32 var_271;
        wp::int32 var_272;
        wp::int32 var_273;
        wp::int32 var_274;
        wp::int32 var_275;
        wp::float32* var_276;
        wp::float32 var_277;
        wp::float32 var_278;
        wp::int32 var_279;
        bool var_280;
        const wp::float32 var_281 = 0.0;
        wp::float32 var_282;
        const wp::int32 var_283 = 3;
        wp::int32 var_284;
        const wp::int32 var_285 = 0;
        wp::int32 var_286;
        const wp::int32 var_287 = 1;
        wp::int32 var_288;
        wp::int32 var_289;
        wp::int32 var_290;
        wp::int32 var_291;
        wp::int32 var_292;
        wp::float32* var_293;
        wp::float32 var_294;
        wp::float32 var_295;
        wp::int32 var_296;
        bool var_297;
        const wp::float32 var_298 = 0.0;
        wp::float32 var_299;
        const wp::int32 var_300 = 4;
        wp::int32 var_301;
        const wp::int32 var_302 = 0;
        wp::int32 var_303;
        const wp::int32 var_304 = 1;
        wp::int32 var_305;
        wp::int32 var_306;
        wp::int32 var_307;
        wp::int32 var_308;
        wp::int32 var_309;
        wp::float32* var_310;
        wp::float32 var_311;
        wp::float32 var_312;
        wp::int32 var_313;
        bool var_314;
        const wp::float32 var_315 = 0.0;
        wp::float32 var_316;
        const wp::int32 var_317 = 5;
        wp::int32 var_318;
        const wp::int32 var_319 = 0;
        wp::int32 var_320;
        const wp::int32 var_321 = 1;
        wp::int32 var_322;
        wp::int32 var_323;
        wp::int32 var_324;
        wp::int32 var_325;
        wp::int32 var_326;
        wp::float32* var_327;
        wp::float32 var_328;
        wp::float32 var_329;
        wp::int32 var_330;
        bool var_331;
        const wp::float32 var_332 = 0.0;
        wp::float32 var_333;
        const wp::int32 var_334 = 6;
        wp::int32 var_335;
        const wp::int32 var_336 = 0;
        wp::int32 var_337;
        const wp::int32 var_338 = 1;
        wp::int32 var_339;
        wp::int32 var_340;
        wp::int32 var_341;
        wp::int32 var_342;
        wp::int32 var_343;
        wp::float32* var_344;
        wp::float32 var_345;
        wp::float32 var_346;
        wp::int32 var_347;
        bool var_348;
        const wp::float32 var_349 = 0.0;
        wp::float32 var_350;
        const wp::int32 var_351 = 7;
        wp::int32 var_352;
        const wp::int32 var_353 = 0;
        wp::int32 var_354;
        const wp::int32 var_355 = 1;
        wp::int32 var_356;
        wp::int32 var_357;
        wp::int32 var_358;
        wp::int32 var_359;
        wp::int32 var_360;
        wp::float32* var_361;
        wp::float32 var_362;
        wp::float32 var_363;
        wp::int32 var_364;
        bool var_365;
        const wp::float32 var_366 = 0.0;
        wp::float32 var_367;
        wp::int32 var_368;
        const wp::int32 var_369 = 0;
        wp::float32 var_370;
        wp::float32 var_371;
        wp::float32 var_372;
        wp::float32 var_373;
        const wp::float32 var_374 = 0.06;
        wp::float32 var_375;
        wp::float32 var_376;
        bool var_377;
        const wp::float32 var_378 = 1.0;
        const wp::float32 var_379 = 0.0;
        wp::float32 var_380;
        const wp::float32 var_381 = 1.0;
        wp::float32 var_382;
        wp::float32 var_383;
        const wp::float32 var_384 = 1.0;
        wp::float32 var_385;
        wp::float32 var_386;
        wp::float32 var_387;
        const wp::float32 var_388 = 0.0;
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
        wp::float32 var_399;
        const wp::int32 var_400 = 1;
        wp::float32 var_401;
        wp::float32 var_402;
        wp::float32 var_403;
        wp::float32 var_404;
        wp::float32 var_405;
        wp::float32 var_406;
        bool var_407;
        const wp::float32 var_408 = 1.0;
        const wp::float32 var_409 = 0.0;
        wp::float32 var_410;
        const wp::float32 var_411 = 1.0;
        wp::float32 var_412;
        wp::float32 var_413;
        const wp::float32 var_414 = 1.0;
        wp::float32 var_415;
        wp::float32 var_416;
        wp::float32 var_417;
        const wp::float32 var_418 = 0.0;
        wp::float32 var_419;
        wp::float32 var_420;
        wp::float32 var_421;
        wp::float32 var_422;
        wp::float32 var_423;
        wp::float32 var_424;
        wp::float32 var_425;
        wp::float32 var_426;
        wp::float32 var_427;
        wp::float32 var_428;
        wp::float32 var_429;
        const wp::int32 var_430 = 2;
        wp::float32 var_431;
        wp::float32 var_432;
        wp::float32 var_433;
        wp::float32 var_434;
        wp::float32 var_435;
        wp::float32 var_436;
        bool var_437;
        const wp::float32 var_438 = 1.0;
        const wp::float32 var_439 = 0.0;
        wp::float32 var_440;
        const wp::float32 var_441 = 1.0;
        wp::float32 var_442;
        wp::float32 var_443;
        const wp::float32 var_444 = 1.0;
        wp::float32 var_445;
        wp::float32 var_446;
        wp::float32 var_447;
        const wp::float32 var_448 = 0.0;
        wp::float32 var_449;
        wp::float32 var_450;
        wp::float32 var_451;
        wp::float32 var_452;
        wp::float32 var_453;
        wp::float32 var_454;
        wp::float32 var_455;
        wp::float32 var_456;
        wp::float32 var_457;
        wp::float32 var_458;
        wp::float32 var_459;
        const wp::int32 var_460 = 3;
        wp::float32 var_461;
        wp::float32 var_462;
        wp::float32 var_463;
        wp::float32 var_464;
        wp::float32 var_465;
        wp::float32 var_466;
        bool var_467;
        const wp::float32 var_468 = 1.0;
        const wp::float32 var_469 = 0.0;
        wp::float32 var_470;
        const wp::float32 var_471 = 1.0;
        wp::float32 var_472;
        wp::float32 var_473;
        const wp::float32 var_474 = 1.0;
        wp::float32 var_475;
        wp::float32 var_476;
        wp::float32 var_477;
        const wp::float32 var_478 = 0.0;
        wp::float32 var_479;
        wp::float32 var_480;
        wp::float32 var_481;
        wp::float32 var_482;
        wp::float32 var_483;
        wp::float32 var_484;
        wp::float32 var_485;
        wp::float32 var_486;
        wp::float32 var_487;
        wp::float32 var_488;
        wp::float32 var_489;
        const wp::int32 var_490 = 4;
        wp::float32 var_491;
        wp::float32 var_492;
        wp::float32 var_493;
        wp::float32 var_494;
        wp::float32 var_495;
        wp::float32 var_496;
        bool var_497;
        const wp::float32 var_498 = 1.0;
        const wp::float32 var_499 = 0.0;
        wp::float32 var_500;
        const wp::float32 var_501 = 1.0;
        wp::float32 var_502;
        wp::float32 var_503;
        const wp::float32 var_504 = 1.0;
        wp::float32 var_505;
        wp::float32 var_506;
        wp::float32 var_507;
        const wp::float32 var_508 = 0.0;
        wp::float32 var_509;
        wp::float32 var_510;
        wp::float32 var_511;
        wp::float32 var_512;
        wp::float32 var_513;
        wp::float32 var_514;
        wp::float32 var_515;
        wp::float32 var_516;
        wp::float32 var_517;
        wp::float32 var_518;
        wp::float32 var_519;
        const wp::int32 var_520 = 5;
        wp::float32 var_521;
        wp::float32 var_522;
        wp::float32 var_523;
        wp::float32 var_524;
        wp::float32 var_525;
        wp::float32 var_526;
        bool var_527;
        const wp::float32 var_528 = 1.0;
        const wp::float32 var_529 = 0.0;
        wp::float32 var_530;
        const wp::float32 var_531 = 1.0;
        wp::float32 var_532;
        wp::float32 var_533;
        const wp::float32 var_534 = 1.0;
        wp::float32 var_535;
        wp::float32 var_536;
        wp::float32 var_537;
        const wp::float32 var_538 = 0.0;
        wp::float32 var_539;
        wp::float32 var_540;
        wp::float32 var_541;
        wp::float32 var_542;
        wp::float32 var_543;
        wp::float32 var_544;
        wp::float32 var_545;
        wp::float32 var_546;
        wp::float32 var_547;
        wp::float32 var_548;
        wp::float32 var_549;
        const wp::int32 var_550 = 6;
        wp::float32 var_551;
        wp::float32 var_552;
        wp::float32 var_553;
        wp::float32 var_554;
        wp::float32 var_555;
        wp::float32 var_556;
        bool var_557;
        const wp::float32 var_558 = 1.0;
        const wp::float32 var_559 = 0.0;
        wp::float32 var_560;
        const wp::float32 var_561 = 1.0;
        wp::float32 var_562;
        wp::float32 var_563;
        const wp::float32 var_564 = 1.0;
        wp::float32 var_565;
        wp::float32 var_566;
        wp::float32 var_567;
        const wp::float32 var_568 = 0.0;
        wp::float32 var_569;
        wp::float32 var_570;
        wp::float32 var_571;
        wp::float32 var_572;
        wp::float32 var_573;
        wp::float32 var_574;
        wp::float32 var_575;
        wp::float32 var_576;
        wp::float32 var_577;
        wp::float32 var_578;
        wp::float32 var_579;
        const wp::int32 var_580 = 7;
        wp::float32 var_581;
        wp::float32 var_582;
        wp::float32 var_583;
        wp::float32 var_584;
        wp::float32 var_585;
        wp::float32 var_586;
        bool var_587;
        const wp::float32 var_588 = 1.0;
        const wp::float32 var_589 = 0.0;
        wp::float32 var_590;
        const wp::float32 var_591 = 1.0;
        wp::float32 var_592;
        wp::float32 var_593;
        const wp::float32 var_594 = 1.0;
        wp::float32 var_595;
        wp::float32 var_596;
        wp::float32 var_597;
        const wp::float32 var_598 = 0.0;
        wp::float32 var_599;
        wp::float32 var_600;
        wp::float32 var_601;
        wp::float32 var_602;
        wp::float32 var_603;
        wp::float32 var_604;
        wp::float32 var_605;
        wp::float32 var_606;
        wp::float32 var_607;
        wp::float32 var_608;
        wp::float32 var_609;
        const wp::float32 var_610 = 0.55;
        const wp::int32 var_611 = 2;
        wp::int32 var_612;
        const wp::int32 var_613 = 1;
        wp::int32 var_614;
        wp::float32 var_615;
        wp::float32 var_616;
        const wp::int32 var_617 = 2;
        wp::int32 var_618;
        const wp::int32 var_619 = 1;
        wp::int32 var_620;
        wp::float32 var_621;
        wp::float32 var_622;
        const wp::int32 var_623 = 0;
        wp::float32 var_624;
        wp::float32 var_625;
        wp::float32 var_626;
        wp::float32 var_627;
        wp::float32 var_628;
        wp::float32 var_629;
        wp::float32 var_630;
        wp::float32 var_631;
        wp::float32 var_632;
        wp::vec_t<9, wp::float32> var_633;
        wp::float32 var_634;
        wp::int32 var_635;
        wp::float32 var_636;
        wp::float32 var_637;
        wp::vec_t<5, wp::float32> var_638;
        const wp::int32 var_639 = 0;
        wp::float32 var_640;
        const wp::int32 var_641 = 1;
        wp::float32 var_642;
        const wp::int32 var_643 = 2;
        wp::float32 var_644;
        const wp::int32 var_645 = 3;
        wp::float32 var_646;
        const wp::int32 var_647 = 4;
        wp::float32 var_648;
        const wp::int32 var_649 = 1;
        wp::float32 var_650;
        wp::float32 var_651;
        wp::float32 var_652;
        wp::float32 var_653;
        wp::float32 var_654;
        wp::float32 var_655;
        wp::float32 var_656;
        wp::float32 var_657;
        wp::float32 var_658;
        wp::vec_t<9, wp::float32> var_659;
        wp::float32 var_660;
        wp::int32 var_661;
        wp::float32 var_662;
        wp::float32 var_663;
        wp::vec_t<5, wp::float32> var_664;
        const wp::int32 var_665 = 0;
        wp::float32 var_666;
        const wp::int32 var_667 = 1;
        wp::float32 var_668;
        const wp::int32 var_669 = 2;
        wp::float32 var_670;
        const wp::int32 var_671 = 3;
        wp::float32 var_672;
        const wp::int32 var_673 = 4;
        wp::float32 var_674;
        const wp::int32 var_675 = 2;
        wp::float32 var_676;
        wp::float32 var_677;
        wp::float32 var_678;
        wp::float32 var_679;
        wp::float32 var_680;
        wp::float32 var_681;
        wp::float32 var_682;
        wp::float32 var_683;
        wp::float32 var_684;
        wp::vec_t<9, wp::float32> var_685;
        wp::float32 var_686;
        wp::int32 var_687;
        wp::float32 var_688;
        wp::float32 var_689;
        wp::vec_t<5, wp::float32> var_690;
        const wp::int32 var_691 = 0;
        wp::float32 var_692;
        const wp::int32 var_693 = 1;
        wp::float32 var_694;
        const wp::int32 var_695 = 2;
        wp::float32 var_696;
        const wp::int32 var_697 = 3;
        wp::float32 var_698;
        const wp::int32 var_699 = 4;
        wp::float32 var_700;
        const wp::int32 var_701 = 3;
        wp::float32 var_702;
        wp::float32 var_703;
        wp::float32 var_704;
        wp::float32 var_705;
        wp::float32 var_706;
        wp::float32 var_707;
        wp::float32 var_708;
        wp::float32 var_709;
        wp::float32 var_710;
        wp::vec_t<9, wp::float32> var_711;
        wp::float32 var_712;
        wp::int32 var_713;
        wp::float32 var_714;
        wp::float32 var_715;
        wp::vec_t<5, wp::float32> var_716;
        const wp::int32 var_717 = 0;
        wp::float32 var_718;
        const wp::int32 var_719 = 1;
        wp::float32 var_720;
        const wp::int32 var_721 = 2;
        wp::float32 var_722;
        const wp::int32 var_723 = 3;
        wp::float32 var_724;
        const wp::int32 var_725 = 4;
        wp::float32 var_726;
        const wp::int32 var_727 = 4;
        wp::float32 var_728;
        wp::float32 var_729;
        wp::float32 var_730;
        wp::float32 var_731;
        wp::float32 var_732;
        wp::float32 var_733;
        wp::float32 var_734;
        wp::float32 var_735;
        wp::float32 var_736;
        wp::vec_t<9, wp::float32> var_737;
        wp::float32 var_738;
        wp::int32 var_739;
        wp::float32 var_740;
        wp::float32 var_741;
        wp::vec_t<5, wp::float32> var_742;
        const wp::int32 var_743 = 0;
        wp::float32 var_744;
        const wp::int32 var_745 = 1;
        wp::float32 var_746;
        const wp::int32 var_747 = 2;
        wp::float32 var_748;
        const wp::int32 var_749 = 3;
        wp::float32 var_750;
        const wp::int32 var_751 = 4;
        wp::float32 var_752;
        const wp::int32 var_753 = 5;
        wp::float32 var_754;
        wp::float32 var_755;
        wp::float32 var_756;
        wp::float32 var_757;
        wp::float32 var_758;
        wp::float32 var_759;
        wp::float32 var_760;
        wp::float32 var_761;
        wp::float32 var_762;
        wp::vec_t<9, wp::float32> var_763;
        wp::float32 var_764;
        wp::int32 var_765;
        wp::float32 var_766;
        wp::float32 var_767;
        wp::vec_t<5, wp::float32> var_768;
        const wp::int32 var_769 = 0;
        wp::float32 var_770;
        const wp::int32 var_771 = 1;
        wp::float32 var_772;
        const wp::int32 var_773 = 2;
        wp::float32 var_774;
        const wp::int32 var_775 = 3;
        wp::float32 var_776;
        const wp::int32 var_777 = 4;
        wp::float32 var_778;
        const wp::int32 var_779 = 6;
        wp::float32 var_780;
        wp::float32 var_781;
        wp::float32 var_782;
        wp::float32 var_783;
        wp::float32 var_784;
        wp::float32 var_785;
        wp::float32 var_786;
        wp::float32 var_787;
        wp::float32 var_788;
        wp::vec_t<9, wp::float32> var_789;
        wp::float32 var_790;
        wp::int32 var_791;
        wp::float32 var_792;
        wp::float32 var_793;
        wp::vec_t<5, wp::float32> var_794;
        const wp::int32 var_795 = 0;
        wp::float32 var_796;
        const wp::int32 var_797 = 1;
        wp::float32 var_798;
        const wp::int32 var_799 = 2;
        wp::float32 var_800;
        const wp::int32 var_801 = 3;
        wp::float32 var_802;
        const wp::int32 var_803 = 4;
        wp::float32 var_804;
        const wp::int32 var_805 = 7;
        wp::float32 var_806;
        wp::float32 var_807;
        wp::float32 var_808;
        wp::float32 var_809;
        wp::float32 var_810;
        wp::float32 var_811;
        wp::float32 var_812;
        wp::float32 var_813;
        wp::float32 var_814;
        wp::vec_t<9, wp::float32> var_815;
        wp::float32 var_816;
        wp::int32 var_817;
        wp::float32 var_818;
        wp::float32 var_819;
        wp::vec_t<5, wp::float32> var_820;
        const wp::int32 var_821 = 0;
        wp::float32 var_822;
        const wp::int32 var_823 = 1;
        wp::float32 var_824;
        const wp::int32 var_825 = 2;
        wp::float32 var_826;
        const wp::int32 var_827 = 3;
        wp::float32 var_828;
        const wp::int32 var_829 = 4;
        wp::float32 var_830;
        const wp::int32 var_831 = 0;
        wp::int32 var_832;
        bool var_833;
        wp::int32 var_834;
        wp::int32 var_835;
        wp::float32 var_836;
        const wp::float32 var_837 = 0.0;
        bool var_838;
        wp::float32 var_839;
        wp::float32 var_840;
        wp::float32 var_841;
        wp::float32 var_842;
        wp::vec_t<4, wp::float32> var_843;
        wp::float32 var_844;
        const wp::float32 var_845 = 0.0;
        const wp::float32 var_846 = 0.0;
        const wp::float32 var_847 = 0.0;
        const wp::float32 var_848 = 0.0;
        wp::vec_t<4, wp::float32> var_849;
        wp::float32 var_850;
        const wp::int32 var_851 = 1;
        wp::int32 var_852;
        bool var_853;
        wp::int32 var_854;
        wp::int32 var_855;
        wp::float32 var_856;
        const wp::float32 var_857 = 0.0;
        bool var_858;
        wp::float32 var_859;
        wp::float32 var_860;
        wp::float32 var_861;
        wp::float32 var_862;
        wp::vec_t<4, wp::float32> var_863;
        wp::float32 var_864;
        const wp::float32 var_865 = 0.0;
        const wp::float32 var_866 = 0.0;
        const wp::float32 var_867 = 0.0;
        const wp::float32 var_868 = 0.0;
        wp::vec_t<4, wp::float32> var_869;
        wp::float32 var_870;
        wp::int32 var_871;
        const wp::int32 var_872 = 2;
        wp::int32 var_873;
        bool var_874;
        wp::int32 var_875;
        wp::int32 var_876;
        wp::float32 var_877;
        const wp::float32 var_878 = 0.0;
        bool var_879;
        wp::float32 var_880;
        wp::float32 var_881;
        wp::float32 var_882;
        wp::float32 var_883;
        wp::vec_t<4, wp::float32> var_884;
        wp::float32 var_885;
        const wp::float32 var_886 = 0.0;
        const wp::float32 var_887 = 0.0;
        const wp::float32 var_888 = 0.0;
        const wp::float32 var_889 = 0.0;
        wp::vec_t<4, wp::float32> var_890;
        wp::float32 var_891;
        wp::int32 var_892;
        const wp::int32 var_893 = 3;
        wp::int32 var_894;
        bool var_895;
        wp::int32 var_896;
        wp::int32 var_897;
        wp::float32 var_898;
        const wp::float32 var_899 = 0.0;
        bool var_900;
        wp::float32 var_901;
        wp::float32 var_902;
        wp::float32 var_903;
        wp::float32 var_904;
        wp::vec_t<4, wp::float32> var_905;
        wp::float32 var_906;
        const wp::float32 var_907 = 0.0;
        const wp::float32 var_908 = 0.0;
        const wp::float32 var_909 = 0.0;
        const wp::float32 var_910 = 0.0;
        wp::vec_t<4, wp::float32> var_911;
        wp::float32 var_912;
        wp::int32 var_913;
        const wp::int32 var_914 = 4;
        wp::int32 var_915;
        bool var_916;
        wp::int32 var_917;
        wp::int32 var_918;
        wp::float32 var_919;
        const wp::float32 var_920 = 0.0;
        bool var_921;
        wp::float32 var_922;
        wp::float32 var_923;
        wp::float32 var_924;
        wp::float32 var_925;
        wp::vec_t<4, wp::float32> var_926;
        wp::float32 var_927;
        const wp::float32 var_928 = 0.0;
        const wp::float32 var_929 = 0.0;
        const wp::float32 var_930 = 0.0;
        const wp::float32 var_931 = 0.0;
        wp::vec_t<4, wp::float32> var_932;
        wp::float32 var_933;
        wp::int32 var_934;
        const wp::int32 var_935 = 5;
        wp::int32 var_936;
        bool var_937;
        wp::int32 var_938;
        wp::int32 var_939;
        wp::float32 var_940;
        const wp::float32 var_941 = 0.0;
        bool var_942;
        wp::float32 var_943;
        wp::float32 var_944;
        wp::float32 var_945;
        wp::float32 var_946;
        wp::vec_t<4, wp::float32> var_947;
        wp::float32 var_948;
        const wp::float32 var_949 = 0.0;
        const wp::float32 var_950 = 0.0;
        const wp::float32 var_951 = 0.0;
        const wp::float32 var_952 = 0.0;
        wp::vec_t<4, wp::float32> var_953;
        wp::float32 var_954;
        wp::int32 var_955;
        const wp::int32 var_956 = 6;
        wp::int32 var_957;
        bool var_958;
        wp::int32 var_959;
        wp::int32 var_960;
        wp::float32 var_961;
        const wp::float32 var_962 = 0.0;
        bool var_963;
        wp::float32 var_964;
        wp::float32 var_965;
        wp::float32 var_966;
        wp::float32 var_967;
        wp::vec_t<4, wp::float32> var_968;
        wp::float32 var_969;
        const wp::float32 var_970 = 0.0;
        const wp::float32 var_971 = 0.0;
        const wp::float32 var_972 = 0.0;
        const wp::float32 var_973 = 0.0;
        wp::vec_t<4, wp::float32> var_974;
        wp::float32 var_975;
        wp::int32 var_976;
        const wp::int32 var_977 = 7;
        wp::int32 var_978;
        bool var_979;
        wp::int32 var_980;
        wp::int32 var_981;
        wp::float32 var_982;
        const wp::float32 var_983 = 0.0;
        bool var_984;
        wp::float32 var_985;
        wp::float32 var_986;
        wp::float32 var_987;
        wp::float32 var_988;
        wp::vec_t<4, wp::float32> var_989;
        wp::float32 var_990;
        const wp::float32 var_991 = 0.0;
        const wp::float32 var_992 = 0.0;
        const wp::float32 var_993 = 0.0;
        const wp::float32 var_994 = 0.0;
        wp::vec_t<4, wp::float32> var_995;
        wp::float32 var_996;
        wp::int32 var_997;
        //---------
        // forward
        // def fit_planes_kernel(radius, levels__layout, levels__lenses, levels__depth, planes, smoothed):       <L 1>
        // i = tid()                                                                              <L 4>
        var_0 = builtin_tid1d();
        // level = int(0)                                                                         <L 5>
        var_2 = wp::int(var_1);
        // group = i                                                                              <L 6>
        var_3 = wp::copy(var_0);
        // for k in range(levels__layout.shape[0] - 1):                                           <L 7>
        var_4 = &(var_levels__layout.shape);
        var_7 = wp::load(var_4);
        var_6 = wp::extract(var_7, var_5);
        var_9 = wp::sub(var_6, var_8);
        var_10 = wp::range(var_9);
        start_for_0:;
            if (iter_cmp(var_10) == 0) goto end_for_0;
            var_11 = wp::iter_next(var_10);
            // groups = group_count(levels__layout[k])                                            <L 8>
            var_12 = wp::address(var_levels__layout, var_11);
            var_14 = wp::load(var_12);
            var_13 = group_count_0(var_14);
            // if level == k and group >= groups:                                                 <L 9>
            var_16 = (var_2 == var_11);
            var_15 = var_16;
            if (var_15) {
                var_17 = (var_3 >= var_13);
                var_15 = var_15 && var_17;
            }
            if (var_15) {
                // level = k + 1                                                                  <L 10>
                var_19 = wp::add(var_11, var_18);
                // group = group - groups                                                         <L 11>
                var_20 = wp::sub(var_3, var_13);
            }
            var_21 = wp::where(var_15, var_19, var_2);
            var_22 = wp::where(var_15, var_20, var_3);
            wp::assign(var_2, var_21);
            wp::assign(var_3, var_22);
            goto start_for_0;
        end_for_0:;
        // size = levels__layout[level]                                                           <L 12>
        var_23 = wp::address(var_levels__layout, var_2);
        var_25 = wp::load(var_23);
        var_24 = wp::copy(var_25);
        // lens = levels__lenses[level]                                                           <L 13>
        var_26 = wp::address(var_levels__lenses, var_2);
        var_28 = wp::load(var_26);
        var_27 = wp::copy(var_28);
        // width = size[0]                                                                        <L 14>
        var_30 = wp::extract(var_24, var_29);
        // first = group % ((width + LANES - 1) // LANES) * LANES                                 <L 15>
        var_32 = wp::add(var_30, var_31);
        var_34 = wp::sub(var_32, var_33);
        var_35 = wp::floordiv(var_34, var_31);
        var_36 = wp::mod(var_3, var_35);
        var_37 = wp::mul(var_36, var_31);
        // v = group // ((width + LANES - 1) // LANES)                                            <L 16>
        var_38 = wp::add(var_30, var_31);
        var_40 = wp::sub(var_38, var_39);
        var_41 = wp::floordiv(var_40, var_31);
        var_42 = wp::floordiv(var_3, var_41);
        // line = size[2] + v * width                                                             <L 17>
        var_44 = wp::extract(var_24, var_43);
        var_45 = wp::mul(var_42, var_30);
        var_46 = wp::add(var_44, var_45);
        // z = octet(0.0)                                                                         <L 18>
        var_48 = wp::vec_t<8, wp::float32>(var_47);
        // d = octet(0.0)                                                                         <L 19>
        var_50 = wp::vec_t<8, wp::float32>(var_49);
        // count = octet(0.0)                                                                     <L 20>
        var_52 = wp::vec_t<8, wp::float32>(var_51);
        // su = octet(0.0)                                                                        <L 21>
        var_54 = wp::vec_t<8, wp::float32>(var_53);
        // sv = octet(0.0)                                                                        <L 22>
        var_56 = wp::vec_t<8, wp::float32>(var_55);
        // suu = octet(0.0)                                                                       <L 23>
        var_58 = wp::vec_t<8, wp::float32>(var_57);
        // suv = octet(0.0)                                                                       <L 24>
        var_60 = wp::vec_t<8, wp::float32>(var_59);
        // svv = octet(0.0)                                                                       <L 25>
        var_62 = wp::vec_t<8, wp::float32>(var_61);
        // sw = octet(0.0)                                                                        <L 26>
        var_64 = wp::vec_t<8, wp::float32>(var_63);
        // suw = octet(0.0)                                                                       <L 27>
        var_66 = wp::vec_t<8, wp::float32>(var_65);
        // svw = octet(0.0)                                                                       <L 28>
        var_68 = wp::vec_t<8, wp::float32>(var_67);
        // for lane in range(LANES):                                                              <L 29>
        // z[lane] = levels__depth[line + min(first + lane, width - 1)]                           <L 30>
        var_70 = wp::add(var_37, var_69);
        var_72 = wp::sub(var_30, var_71);
        var_73 = wp::min(var_70, var_72);
        var_74 = wp::add(var_46, var_73);
        var_75 = wp::address(var_levels__depth, var_74);
        var_77 = wp::load(var_75);
        var_76 = wp::copy(var_77);
        wp::assign_inplace(var_48, var_69, var_76);
        var_79 = wp::add(var_37, var_78);
        var_81 = wp::sub(var_30, var_80);
        var_82 = wp::min(var_79, var_81);
        var_83 = wp::add(var_46, var_82);
        var_84 = wp::address(var_levels__depth, var_83);
        var_86 = wp::load(var_84);
        var_85 = wp::copy(var_86);
        wp::assign_inplace(var_48, var_78, var_85);
        var_88 = wp::add(var_37, var_87);
        var_90 = wp::sub(var_30, var_89);
        var_91 = wp::min(var_88, var_90);
        var_92 = wp::add(var_46, var_91);
        var_93 = wp::address(var_levels__depth, var_92);
        var_95 = wp::load(var_93);
        var_94 = wp::copy(var_95);
        wp::assign_inplace(var_48, var_87, var_94);
        var_97 = wp::add(var_37, var_96);
        var_99 = wp::sub(var_30, var_98);
        var_100 = wp::min(var_97, var_99);
        var_101 = wp::add(var_46, var_100);
        var_102 = wp::address(var_levels__depth, var_101);
        var_104 = wp::load(var_102);
        var_103 = wp::copy(var_104);
        wp::assign_inplace(var_48, var_96, var_103);
        var_106 = wp::add(var_37, var_105);
        var_108 = wp::sub(var_30, var_107);
        var_109 = wp::min(var_106, var_108);
        var_110 = wp::add(var_46, var_109);
        var_111 = wp::address(var_levels__depth, var_110);
        var_113 = wp::load(var_111);
        var_112 = wp::copy(var_113);
        wp::assign_inplace(var_48, var_105, var_112);
        var_115 = wp::add(var_37, var_114);
        var_117 = wp::sub(var_30, var_116);
        var_118 = wp::min(var_115, var_117);
        var_119 = wp::add(var_46, var_118);
        var_120 = wp::address(var_levels__depth, var_119);
        var_122 = wp::load(var_120);
        var_121 = wp::copy(var_122);
        wp::assign_inplace(var_48, var_114, var_121);
        var_124 = wp::add(var_37, var_123);
        var_126 = wp::sub(var_30, var_125);
        var_127 = wp::min(var_124, var_126);
        var_128 = wp::add(var_46, var_127);
        var_129 = wp::address(var_levels__depth, var_128);
        var_131 = wp::load(var_129);
        var_130 = wp::copy(var_131);
        wp::assign_inplace(var_48, var_123, var_130);
        var_133 = wp::add(var_37, var_132);
        var_135 = wp::sub(var_30, var_134);
        var_136 = wp::min(var_133, var_135);
        var_137 = wp::add(var_46, var_136);
        var_138 = wp::address(var_levels__depth, var_137);
        var_140 = wp::load(var_138);
        var_139 = wp::copy(var_140);
        wp::assign_inplace(var_48, var_132, var_139);
        // for dv in range(max(-radius, -v), min(radius, size[1] - 1 - v) + 1):                   <L 31>
        var_141 = wp::neg(var_radius);
        var_142 = wp::neg(var_42);
        var_143 = wp::max(var_141, var_142);
        var_145 = wp::extract(var_24, var_144);
        var_147 = wp::sub(var_145, var_146);
        var_148 = wp::sub(var_147, var_42);
        var_149 = wp::min(var_radius, var_148);
        var_151 = wp::add(var_149, var_150);
        var_152 = wp::range(var_143, var_151);
        var_153 = wp::copy(var_132);
        start_for_2:;
            if (iter_cmp(var_152) == 0) goto end_for_2;
            var_154 = wp::iter_next(var_152);
            // y = float(dv)                                                                      <L 32>
            var_155 = wp::float(var_154);
            // for du in range(-radius, radius + 1):                                              <L 33>
            var_156 = wp::neg(var_radius);
            var_158 = wp::add(var_radius, var_157);
            var_159 = wp::range(var_156, var_158);
            start_for_4:;
                if (iter_cmp(var_159) == 0) goto end_for_4;
                var_160 = wp::iter_next(var_159);
                // x = float(du)                                                                  <L 34>
                var_161 = wp::float(var_160);
                // start = first + du                                                             <L 35>
                var_162 = wp::add(var_37, var_160);
                // if start >= 0 and start + LANES <= width:                                      <L 36>
                var_165 = (var_162 >= var_164);
                var_163 = var_165;
                if (var_163) {
                    var_166 = wp::add(var_162, var_31);
                    var_167 = (var_166 <= var_30);
                    var_163 = var_163 && var_167;
                }
                if (var_163) {
                    // for lane in range(LANES):                                                  <L 37>
                    // d[lane] = levels__depth[line + dv * width + start + lane]                  <L 38>
                    var_169 = wp::mul(var_154, var_30);
                    var_170 = wp::add(var_46, var_169);
                    var_171 = wp::add(var_170, var_162);
                    var_172 = wp::add(var_171, var_168);
                    var_173 = wp::address(var_levels__depth, var_172);
                    var_175 = wp::load(var_173);
                    var_174 = wp::copy(var_175);
                    wp::assign_inplace(var_50, var_168, var_174);
                    var_177 = wp::mul(var_154, var_30);
                    var_178 = wp::add(var_46, var_177);
                    var_179 = wp::add(var_178, var_162);
                    var_180 = wp::add(var_179, var_176);
                    var_181 = wp::address(var_levels__depth, var_180);
                    var_183 = wp::load(var_181);
                    var_182 = wp::copy(var_183);
                    wp::assign_inplace(var_50, var_176, var_182);
                    var_185 = wp::mul(var_154, var_30);
                    var_186 = wp::add(var_46, var_185);
                    var_187 = wp::add(var_186, var_162);
                    var_188 = wp::add(var_187, var_184);
                    var_189 = wp::address(var_levels__depth, var_188);
                    var_191 = wp::load(var_189);
                    var_190 = wp::copy(var_191);
                    wp::assign_inplace(var_50, var_184, var_190);
                    var_193 = wp::mul(var_154, var_30);
                    var_194 = wp::add(var_46, var_193);
                    var_195 = wp::add(var_194, var_162);
                    var_196 = wp::add(var_195, var_192);
                    var_197 = wp::address(var_levels__depth, var_196);
                    var_199 = wp::load(var_197);
                    var_198 = wp::copy(var_199);
                    wp::assign_inplace(var_50, var_192, var_198);
                    var_201 = wp::mul(var_154, var_30);
                    var_202 = wp::add(var_46, var_201);
                    var_203 = wp::add(var_202, var_162);
                    var_204 = wp::add(var_203, var_200);
                    var_205 = wp::address(var_levels__depth, var_204);
                    var_207 = wp::load(var_205);
                    var_206 = wp::copy(var_207);
                    wp::assign_inplace(var_50, var_200, var_206);
                    var_209 = wp::mul(var_154, var_30);
                    var_210 = wp::add(var_46, var_209);
                    var_211 = wp::add(var_210, var_162);
                    var_212 = wp::add(var_211, var_208);
                    var_213 = wp::address(var_levels__depth, var_212);
                    var_215 = wp::load(var_213);
                    var_214 = wp::copy(var_215);
                    wp::assign_inplace(var_50, var_208, var_214);
                    var_217 = wp::mul(var_154, var_30);
                    var_218 = wp::add(var_46, var_217);
                    var_219 = wp::add(var_218, var_162);
                    var_220 = wp::add(var_219, var_216);
                    var_221 = wp::address(var_levels__depth, var_220);
                    var_223 = wp::load(var_221);
                    var_222 = wp::copy(var_223);
                    wp::assign_inplace(var_50, var_216, var_222);
                    var_225 = wp::mul(var_154, var_30);
                    var_226 = wp::add(var_46, var_225);
                    var_227 = wp::add(var_226, var_162);
                    var_228 = wp::add(var_227, var_224);
                    var_229 = wp::address(var_levels__depth, var_228);
                    var_231 = wp::load(var_229);
                    var_230 = wp::copy(var_231);
                    wp::assign_inplace(var_50, var_224, var_230);
                }
                if (!var_163) {
                    // for lane in range(LANES):                                                  <L 40>
                    // column = min(max(start + lane, 0), width - 1)                              <L 41>
                    var_233 = wp::add(var_162, var_232);
                    var_235 = wp::max(var_233, var_234);
                    var_237 = wp::sub(var_30, var_236);
                    var_238 = wp::min(var_235, var_237);
                    // value = levels__depth[line + dv * width + column]                          <L 42>
                    var_239 = wp::mul(var_154, var_30);
                    var_240 = wp::add(var_46, var_239);
                    var_241 = wp::add(var_240, var_238);
                    var_242 = wp::address(var_levels__depth, var_241);
                    var_244 = wp::load(var_242);
                    var_243 = wp::copy(var_244);
                    // d[lane] = value if column == start + lane else 0.0                         <L 43>
                    var_245 = wp::add(var_162, var_232);
                    var_246 = (var_238 == var_245);
                    if (var_246) {
                    }
                    if (!var_246) {
                    }
                    var_248 = wp::where(var_246, var_243, var_247);
                    wp::assign_inplace(var_50, var_232, var_248);
                    // column = min(max(start + lane, 0), width - 1)                              <L 41>
                    var_250 = wp::add(var_162, var_249);
                    var_252 = wp::max(var_250, var_251);
                    var_254 = wp::sub(var_30, var_253);
                    var_255 = wp::min(var_252, var_254);
                    // value = levels__depth[line + dv * width + column]                          <L 42>
                    var_256 = wp::mul(var_154, var_30);
                    var_257 = wp::add(var_46, var_256);
                    var_258 = wp::add(var_257, var_255);
                    var_259 = wp::address(var_levels__depth, var_258);
                    var_261 = wp::load(var_259);
                    var_260 = wp::copy(var_261);
                    // d[lane] = value if column == start + lane else 0.0                         <L 43>
                    var_262 = wp::add(var_162, var_249);
                    var_263 = (var_255 == var_262);
                    if (var_263) {
                    }
                    if (!var_263) {
                    }
                    var_265 = wp::where(var_263, var_260, var_264);
                    wp::assign_inplace(var_50, var_249, var_265);
                    // column = min(max(start + lane, 0), width - 1)                              <L 41>
                    var_267 = wp::add(var_162, var_266);
                    var_269 = wp::max(var_267, var_268);
                    var_271 = wp::sub(var_30, var_270);
                    var_272 = wp::min(var_269, var_271);
                    // value = levels__depth[line + dv * width + column]                          <L 42>
                    var_273 = wp::mul(var_154, var_30);
                    var_274 = wp::add(var_46, var_273);
                    var_275 = wp::add(var_274, var_272);
                    var_276 = wp::address(var_levels__depth, var_275);
                    var_278 = wp::load(var_276);
                    var_277 = wp::copy(var_278);
                    // d[lane] = value if column == start + lane else 0.0                         <L 43>
                    var_279 = wp::add(var_162, var_266);
                    var_280 = (var_272 == var_279);
                    if (var_280) {
                    }
                    if (!var_280) {
                    }
                    var_282 = wp::where(var_280, var_277, var_281);
                    wp::assign_inplace(var_50, var_266, var_282);
                    // column = min(max(start + lane, 0), width - 1)                              <L 41>
                    var_284 = wp::add(var_162, var_283);
                    var_286 = wp::max(var_284, var_285);
                    var_288 = wp::sub(var_30, var_287);
                    var_289 = wp::min(var_286, var_288);
                    // value = levels__depth[line + dv * width + column]                          <L 42>
                    var_290 = wp::mul(var_154, var_30);
                    var_291 = wp::add(var_46, var_290);
                    var_292 = wp::add(var_291, var_289);
                    var_293 = wp::address(var_levels__depth, var_292);
                    var_295 = wp::load(var_293);
                    var_294 = wp::copy(var_295);
                    // d[lane] = value if column == start + lane else 0.0                         <L 43>
                    var_296 = wp::add(var_162, var_283);
                    var_297 = (var_289 == var_296);
                    if (var_297) {
                    }
                    if (!var_297) {
                    }
                    var_299 = wp::where(var_297, var_294, var_298);
                    wp::assign_inplace(var_50, var_283, var_299);
                    // column = min(max(start + lane, 0), width - 1)                              <L 41>
                    var_301 = wp::add(var_162, var_300);
                    var_303 = wp::max(var_301, var_302);
                    var_305 = wp::sub(var_30, var_304);
                    var_306 = wp::min(var_303, var_305);
                    // value = levels__depth[line + dv * width + column]                          <L 42>
                    var_307 = wp::mul(var_154, var_30);
                    var_308 = wp::add(var_46, var_307);
                    var_309 = wp::add(var_308, var_306);
                    var_310 = wp::address(var_levels__depth, var_309);
                    var_312 = wp::load(var_310);
                    var_311 = wp::copy(var_312);
                    // d[lane] = value if column == start + lane else 0.0                         <L 43>
                    var_313 = wp::add(var_162, var_300);
                    var_314 = (var_306 == var_313);
                    if (var_314) {
                    }
                    if (!var_314) {
                    }
                    var_316 = wp::where(var_314, var_311, var_315);
                    wp::assign_inplace(var_50, var_300, var_316);
                    // column = min(max(start + lane, 0), width - 1)                              <L 41>
                    var_318 = wp::add(var_162, var_317);
                    var_320 = wp::max(var_318, var_319);
                    var_322 = wp::sub(var_30, var_321);
                    var_323 = wp::min(var_320, var_322);
                    // value = levels__depth[line + dv * width + column]                          <L 42>
                    var_324 = wp::mul(var_154, var_30);
                    var_325 = wp::add(var_46, var_324);
                    var_326 = wp::add(var_325, var_323);
                    var_327 = wp::address(var_levels__depth, var_326);
                    var_329 = wp::load(var_327);
                    var_328 = wp::copy(var_329);
                    // d[lane] = value if column == start + lane else 0.0                         <L 43>
                    var_330 = wp::add(var_162, var_317);
                    var_331 = (var_323 == var_330);
                    if (var_331) {
                    }
                    if (!var_331) {
                    }
                    var_333 = wp::where(var_331, var_328, var_332);
                    wp::assign_inplace(var_50, var_317, var_333);
                    // column = min(max(start + lane, 0), width - 1)                              <L 41>
                    var_335 = wp::add(var_162, var_334);
                    var_337 = wp::max(var_335, var_336);
                    var_339 = wp::sub(var_30, var_338);
                    var_340 = wp::min(var_337, var_339);
                    // value = levels__depth[line + dv * width + column]                          <L 42>
                    var_341 = wp::mul(var_154, var_30);
                    var_342 = wp::add(var_46, var_341);
                    var_343 = wp::add(var_342, var_340);
                    var_344 = wp::address(var_levels__depth, var_343);
                    var_346 = wp::load(var_344);
                    var_345 = wp::copy(var_346);
                    // d[lane] = value if column == start + lane else 0.0                         <L 43>
                    var_347 = wp::add(var_162, var_334);
                    var_348 = (var_340 == var_347);
                    if (var_348) {
                    }
                    if (!var_348) {
                    }
                    var_350 = wp::where(var_348, var_345, var_349);
                    wp::assign_inplace(var_50, var_334, var_350);
                    // column = min(max(start + lane, 0), width - 1)                              <L 41>
                    var_352 = wp::add(var_162, var_351);
                    var_354 = wp::max(var_352, var_353);
                    var_356 = wp::sub(var_30, var_355);
                    var_357 = wp::min(var_354, var_356);
                    // value = levels__depth[line + dv * width + column]                          <L 42>
                    var_358 = wp::mul(var_154, var_30);
                    var_359 = wp::add(var_46, var_358);
                    var_360 = wp::add(var_359, var_357);
                    var_361 = wp::address(var_levels__depth, var_360);
                    var_363 = wp::load(var_361);
                    var_362 = wp::copy(var_363);
                    // d[lane] = value if column == start + lane else 0.0                         <L 43>
                    var_364 = wp::add(var_162, var_351);
                    var_365 = (var_357 == var_364);
                    if (var_365) {
                    }
                    if (!var_365) {
                    }
                    var_367 = wp::where(var_365, var_362, var_366);
                    wp::assign_inplace(var_50, var_351, var_367);
                }
                var_368 = wp::where(var_163, var_224, var_351);
                // for lane in range(LANES):                                                      <L 44>
                // is_near = abs(d[lane] - z[lane]) <= WINDOW_SURFACE * z[lane]                   <L 45>
                var_370 = wp::extract(var_50, var_369);
                var_371 = wp::extract(var_48, var_369);
                var_372 = wp::sub(var_370, var_371);
                var_373 = wp::abs(var_372);
                var_375 = wp::extract(var_48, var_369);
                var_376 = wp::mul(var_374, var_375);
                var_377 = (var_373 <= var_376);
                // one = 1.0 if is_near else 0.0                                                  <L 46>
                if (var_377) {
                }
                if (!var_377) {
                }
                var_380 = wp::where(var_377, var_378, var_379);
                // w = 1.0 / d[lane] - 1.0 / z[lane] if is_near else 0.0                          <L 47>
                if (var_377) {
                    var_382 = wp::extract(var_50, var_369);
                    var_383 = wp::div(var_381, var_382);
                    var_385 = wp::extract(var_48, var_369);
                    var_386 = wp::div(var_384, var_385);
                    var_387 = wp::sub(var_383, var_386);
                }
                if (!var_377) {
                }
                var_389 = wp::where(var_377, var_387, var_388);
                // count[lane] += one                                                             <L 48>
                wp::add_inplace(var_52, var_369, var_380);
                // su[lane] += one * x                                                            <L 49>
                var_390 = wp::mul(var_380, var_161);
                wp::add_inplace(var_54, var_369, var_390);
                // sv[lane] += one * y                                                            <L 50>
                var_391 = wp::mul(var_380, var_155);
                wp::add_inplace(var_56, var_369, var_391);
                // suu[lane] += one * (x * x)                                                     <L 51>
                var_392 = wp::mul(var_161, var_161);
                var_393 = wp::mul(var_380, var_392);
                wp::add_inplace(var_58, var_369, var_393);
                // suv[lane] += one * (x * y)                                                     <L 52>
                var_394 = wp::mul(var_161, var_155);
                var_395 = wp::mul(var_380, var_394);
                wp::add_inplace(var_60, var_369, var_395);
                // svv[lane] += one * (y * y)                                                     <L 53>
                var_396 = wp::mul(var_155, var_155);
                var_397 = wp::mul(var_380, var_396);
                wp::add_inplace(var_62, var_369, var_397);
                // sw[lane] += w                                                                  <L 54>
                wp::add_inplace(var_64, var_369, var_389);
                // suw[lane] += x * w                                                             <L 55>
                var_398 = wp::mul(var_161, var_389);
                wp::add_inplace(var_66, var_369, var_398);
                // svw[lane] += y * w                                                             <L 56>
                var_399 = wp::mul(var_155, var_389);
                wp::add_inplace(var_68, var_369, var_399);
                // is_near = abs(d[lane] - z[lane]) <= WINDOW_SURFACE * z[lane]                   <L 45>
                var_401 = wp::extract(var_50, var_400);
                var_402 = wp::extract(var_48, var_400);
                var_403 = wp::sub(var_401, var_402);
                var_404 = wp::abs(var_403);
                var_405 = wp::extract(var_48, var_400);
                var_406 = wp::mul(var_374, var_405);
                var_407 = (var_404 <= var_406);
                // one = 1.0 if is_near else 0.0                                                  <L 46>
                if (var_407) {
                }
                if (!var_407) {
                }
                var_410 = wp::where(var_407, var_408, var_409);
                // w = 1.0 / d[lane] - 1.0 / z[lane] if is_near else 0.0                          <L 47>
                if (var_407) {
                    var_412 = wp::extract(var_50, var_400);
                    var_413 = wp::div(var_411, var_412);
                    var_415 = wp::extract(var_48, var_400);
                    var_416 = wp::div(var_414, var_415);
                    var_417 = wp::sub(var_413, var_416);
                }
                if (!var_407) {
                }
                var_419 = wp::where(var_407, var_417, var_418);
                // count[lane] += one                                                             <L 48>
                wp::add_inplace(var_52, var_400, var_410);
                // su[lane] += one * x                                                            <L 49>
                var_420 = wp::mul(var_410, var_161);
                wp::add_inplace(var_54, var_400, var_420);
                // sv[lane] += one * y                                                            <L 50>
                var_421 = wp::mul(var_410, var_155);
                wp::add_inplace(var_56, var_400, var_421);
                // suu[lane] += one * (x * x)                                                     <L 51>
                var_422 = wp::mul(var_161, var_161);
                var_423 = wp::mul(var_410, var_422);
                wp::add_inplace(var_58, var_400, var_423);
                // suv[lane] += one * (x * y)                                                     <L 52>
                var_424 = wp::mul(var_161, var_155);
                var_425 = wp::mul(var_410, var_424);
                wp::add_inplace(var_60, var_400, var_425);
                // svv[lane] += one * (y * y)                                                     <L 53>
                var_426 = wp::mul(var_155, var_155);
                var_427 = wp::mul(var_410, var_426);
                wp::add_inplace(var_62, var_400, var_427);
                // sw[lane] += w                                                                  <L 54>
                wp::add_inplace(var_64, var_400, var_419);
                // suw[lane] += x * w                                                             <L 55>
                var_428 = wp::mul(var_161, var_419);
                wp::add_inplace(var_66, var_400, var_428);
                // svw[lane] += y * w                                                             <L 56>
                var_429 = wp::mul(var_155, var_419);
                wp::add_inplace(var_68, var_400, var_429);
                // is_near = abs(d[lane] - z[lane]) <= WINDOW_SURFACE * z[lane]                   <L 45>
                var_431 = wp::extract(var_50, var_430);
                var_432 = wp::extract(var_48, var_430);
                var_433 = wp::sub(var_431, var_432);
                var_434 = wp::abs(var_433);
                var_435 = wp::extract(var_48, var_430);
                var_436 = wp::mul(var_374, var_435);
                var_437 = (var_434 <= var_436);
                // one = 1.0 if is_near else 0.0                                                  <L 46>
                if (var_437) {
                }
                if (!var_437) {
                }
                var_440 = wp::where(var_437, var_438, var_439);
                // w = 1.0 / d[lane] - 1.0 / z[lane] if is_near else 0.0                          <L 47>
                if (var_437) {
                    var_442 = wp::extract(var_50, var_430);
                    var_443 = wp::div(var_441, var_442);
                    var_445 = wp::extract(var_48, var_430);
                    var_446 = wp::div(var_444, var_445);
                    var_447 = wp::sub(var_443, var_446);
                }
                if (!var_437) {
                }
                var_449 = wp::where(var_437, var_447, var_448);
                // count[lane] += one                                                             <L 48>
                wp::add_inplace(var_52, var_430, var_440);
                // su[lane] += one * x                                                            <L 49>
                var_450 = wp::mul(var_440, var_161);
                wp::add_inplace(var_54, var_430, var_450);
                // sv[lane] += one * y                                                            <L 50>
                var_451 = wp::mul(var_440, var_155);
                wp::add_inplace(var_56, var_430, var_451);
                // suu[lane] += one * (x * x)                                                     <L 51>
                var_452 = wp::mul(var_161, var_161);
                var_453 = wp::mul(var_440, var_452);
                wp::add_inplace(var_58, var_430, var_453);
                // suv[lane] += one * (x * y)                                                     <L 52>
                var_454 = wp::mul(var_161, var_155);
                var_455 = wp::mul(var_440, var_454);
                wp::add_inplace(var_60, var_430, var_455);
                // svv[lane] += one * (y * y)                                                     <L 53>
                var_456 = wp::mul(var_155, var_155);
                var_457 = wp::mul(var_440, var_456);
                wp::add_inplace(var_62, var_430, var_457);
                // sw[lane] += w                                                                  <L 54>
                wp::add_inplace(var_64, var_430, var_449);
                // suw[lane] += x * w                                                             <L 55>
                var_458 = wp::mul(var_161, var_449);
                wp::add_inplace(var_66, var_430, var_458);
                // svw[lane] += y * w                                                             <L 56>
                var_459 = wp::mul(var_155, var_449);
                wp::add_inplace(var_68, var_430, var_459);
                // is_near = abs(d[lane] - z[lane]) <= WINDOW_SURFACE * z[lane]                   <L 45>
                var_461 = wp::extract(var_50, var_460);
                var_462 = wp::extract(var_48, var_460);
                var_463 = wp::sub(var_461, var_462);
                var_464 = wp::abs(var_463);
                var_465 = wp::extract(var_48, var_460);
                var_466 = wp::mul(var_374, var_465);
                var_467 = (var_464 <= var_466);
                // one = 1.0 if is_near else 0.0                                                  <L 46>
                if (var_467) {
                }
                if (!var_467) {
                }
                var_470 = wp::where(var_467, var_468, var_469);
                // w = 1.0 / d[lane] - 1.0 / z[lane] if is_near else 0.0                          <L 47>
                if (var_467) {
                    var_472 = wp::extract(var_50, var_460);
                    var_473 = wp::div(var_471, var_472);
                    var_475 = wp::extract(var_48, var_460);
                    var_476 = wp::div(var_474, var_475);
                    var_477 = wp::sub(var_473, var_476);
                }
                if (!var_467) {
                }
                var_479 = wp::where(var_467, var_477, var_478);
                // count[lane] += one                                                             <L 48>
                wp::add_inplace(var_52, var_460, var_470);
                // su[lane] += one * x                                                            <L 49>
                var_480 = wp::mul(var_470, var_161);
                wp::add_inplace(var_54, var_460, var_480);
                // sv[lane] += one * y                                                            <L 50>
                var_481 = wp::mul(var_470, var_155);
                wp::add_inplace(var_56, var_460, var_481);
                // suu[lane] += one * (x * x)                                                     <L 51>
                var_482 = wp::mul(var_161, var_161);
                var_483 = wp::mul(var_470, var_482);
                wp::add_inplace(var_58, var_460, var_483);
                // suv[lane] += one * (x * y)                                                     <L 52>
                var_484 = wp::mul(var_161, var_155);
                var_485 = wp::mul(var_470, var_484);
                wp::add_inplace(var_60, var_460, var_485);
                // svv[lane] += one * (y * y)                                                     <L 53>
                var_486 = wp::mul(var_155, var_155);
                var_487 = wp::mul(var_470, var_486);
                wp::add_inplace(var_62, var_460, var_487);
                // sw[lane] += w                                                                  <L 54>
                wp::add_inplace(var_64, var_460, var_479);
                // suw[lane] += x * w                                                             <L 55>
                var_488 = wp::mul(var_161, var_479);
                wp::add_inplace(var_66, var_460, var_488);
                // svw[lane] += y * w                                                             <L 56>
                var_489 = wp::mul(var_155, var_479);
                wp::add_inplace(var_68, var_460, var_489);
                // is_near = abs(d[lane] - z[lane]) <= WINDOW_SURFACE * z[lane]                   <L 45>
                var_491 = wp::extract(var_50, var_490);
                var_492 = wp::extract(var_48, var_490);
                var_493 = wp::sub(var_491, var_492);
                var_494 = wp::abs(var_493);
                var_495 = wp::extract(var_48, var_490);
                var_496 = wp::mul(var_374, var_495);
                var_497 = (var_494 <= var_496);
                // one = 1.0 if is_near else 0.0                                                  <L 46>
                if (var_497) {
                }
                if (!var_497) {
                }
                var_500 = wp::where(var_497, var_498, var_499);
                // w = 1.0 / d[lane] - 1.0 / z[lane] if is_near else 0.0                          <L 47>
                if (var_497) {
                    var_502 = wp::extract(var_50, var_490);
                    var_503 = wp::div(var_501, var_502);
                    var_505 = wp::extract(var_48, var_490);
                    var_506 = wp::div(var_504, var_505);
                    var_507 = wp::sub(var_503, var_506);
                }
                if (!var_497) {
                }
                var_509 = wp::where(var_497, var_507, var_508);
                // count[lane] += one                                                             <L 48>
                wp::add_inplace(var_52, var_490, var_500);
                // su[lane] += one * x                                                            <L 49>
                var_510 = wp::mul(var_500, var_161);
                wp::add_inplace(var_54, var_490, var_510);
                // sv[lane] += one * y                                                            <L 50>
                var_511 = wp::mul(var_500, var_155);
                wp::add_inplace(var_56, var_490, var_511);
                // suu[lane] += one * (x * x)                                                     <L 51>
                var_512 = wp::mul(var_161, var_161);
                var_513 = wp::mul(var_500, var_512);
                wp::add_inplace(var_58, var_490, var_513);
                // suv[lane] += one * (x * y)                                                     <L 52>
                var_514 = wp::mul(var_161, var_155);
                var_515 = wp::mul(var_500, var_514);
                wp::add_inplace(var_60, var_490, var_515);
                // svv[lane] += one * (y * y)                                                     <L 53>
                var_516 = wp::mul(var_155, var_155);
                var_517 = wp::mul(var_500, var_516);
                wp::add_inplace(var_62, var_490, var_517);
                // sw[lane] += w                                                                  <L 54>
                wp::add_inplace(var_64, var_490, var_509);
                // suw[lane] += x * w                                                             <L 55>
                var_518 = wp::mul(var_161, var_509);
                wp::add_inplace(var_66, var_490, var_518);
                // svw[lane] += y * w                                                             <L 56>
                var_519 = wp::mul(var_155, var_509);
                wp::add_inplace(var_68, var_490, var_519);
                // is_near = abs(d[lane] - z[lane]) <= WINDOW_SURFACE * z[lane]                   <L 45>
                var_521 = wp::extract(var_50, var_520);
                var_522 = wp::extract(var_48, var_520);
                var_523 = wp::sub(var_521, var_522);
                var_524 = wp::abs(var_523);
                var_525 = wp::extract(var_48, var_520);
                var_526 = wp::mul(var_374, var_525);
                var_527 = (var_524 <= var_526);
                // one = 1.0 if is_near else 0.0                                                  <L 46>
                if (var_527) {
                }
                if (!var_527) {
                }
                var_530 = wp::where(var_527, var_528, var_529);
                // w = 1.0 / d[lane] - 1.0 / z[lane] if is_near else 0.0                          <L 47>
                if (var_527) {
                    var_532 = wp::extract(var_50, var_520);
                    var_533 = wp::div(var_531, var_532);
                    var_535 = wp::extract(var_48, var_520);
                    var_536 = wp::div(var_534, var_535);
                    var_537 = wp::sub(var_533, var_536);
                }
                if (!var_527) {
                }
                var_539 = wp::where(var_527, var_537, var_538);
                // count[lane] += one                                                             <L 48>
                wp::add_inplace(var_52, var_520, var_530);
                // su[lane] += one * x                                                            <L 49>
                var_540 = wp::mul(var_530, var_161);
                wp::add_inplace(var_54, var_520, var_540);
                // sv[lane] += one * y                                                            <L 50>
                var_541 = wp::mul(var_530, var_155);
                wp::add_inplace(var_56, var_520, var_541);
                // suu[lane] += one * (x * x)                                                     <L 51>
                var_542 = wp::mul(var_161, var_161);
                var_543 = wp::mul(var_530, var_542);
                wp::add_inplace(var_58, var_520, var_543);
                // suv[lane] += one * (x * y)                                                     <L 52>
                var_544 = wp::mul(var_161, var_155);
                var_545 = wp::mul(var_530, var_544);
                wp::add_inplace(var_60, var_520, var_545);
                // svv[lane] += one * (y * y)                                                     <L 53>
                var_546 = wp::mul(var_155, var_155);
                var_547 = wp::mul(var_530, var_546);
                wp::add_inplace(var_62, var_520, var_547);
                // sw[lane] += w                                                                  <L 54>
                wp::add_inplace(var_64, var_520, var_539);
                // suw[lane] += x * w                                                             <L 55>
                var_548 = wp::mul(var_161, var_539);
                wp::add_inplace(var_66, var_520, var_548);
                // svw[lane] += y * w                                                             <L 56>
                var_549 = wp::mul(var_155, var_539);
                wp::add_inplace(var_68, var_520, var_549);
                // is_near = abs(d[lane] - z[lane]) <= WINDOW_SURFACE * z[lane]                   <L 45>
                var_551 = wp::extract(var_50, var_550);
                var_552 = wp::extract(var_48, var_550);
                var_553 = wp::sub(var_551, var_552);
                var_554 = wp::abs(var_553);
                var_555 = wp::extract(var_48, var_550);
                var_556 = wp::mul(var_374, var_555);
                var_557 = (var_554 <= var_556);
                // one = 1.0 if is_near else 0.0                                                  <L 46>
                if (var_557) {
                }
                if (!var_557) {
                }
                var_560 = wp::where(var_557, var_558, var_559);
                // w = 1.0 / d[lane] - 1.0 / z[lane] if is_near else 0.0                          <L 47>
                if (var_557) {
                    var_562 = wp::extract(var_50, var_550);
                    var_563 = wp::div(var_561, var_562);
                    var_565 = wp::extract(var_48, var_550);
                    var_566 = wp::div(var_564, var_565);
                    var_567 = wp::sub(var_563, var_566);
                }
                if (!var_557) {
                }
                var_569 = wp::where(var_557, var_567, var_568);
                // count[lane] += one                                                             <L 48>
                wp::add_inplace(var_52, var_550, var_560);
                // su[lane] += one * x                                                            <L 49>
                var_570 = wp::mul(var_560, var_161);
                wp::add_inplace(var_54, var_550, var_570);
                // sv[lane] += one * y                                                            <L 50>
                var_571 = wp::mul(var_560, var_155);
                wp::add_inplace(var_56, var_550, var_571);
                // suu[lane] += one * (x * x)                                                     <L 51>
                var_572 = wp::mul(var_161, var_161);
                var_573 = wp::mul(var_560, var_572);
                wp::add_inplace(var_58, var_550, var_573);
                // suv[lane] += one * (x * y)                                                     <L 52>
                var_574 = wp::mul(var_161, var_155);
                var_575 = wp::mul(var_560, var_574);
                wp::add_inplace(var_60, var_550, var_575);
                // svv[lane] += one * (y * y)                                                     <L 53>
                var_576 = wp::mul(var_155, var_155);
                var_577 = wp::mul(var_560, var_576);
                wp::add_inplace(var_62, var_550, var_577);
                // sw[lane] += w                                                                  <L 54>
                wp::add_inplace(var_64, var_550, var_569);
                // suw[lane] += x * w                                                             <L 55>
                var_578 = wp::mul(var_161, var_569);
                wp::add_inplace(var_66, var_550, var_578);
                // svw[lane] += y * w                                                             <L 56>
                var_579 = wp::mul(var_155, var_569);
                wp::add_inplace(var_68, var_550, var_579);
                // is_near = abs(d[lane] - z[lane]) <= WINDOW_SURFACE * z[lane]                   <L 45>
                var_581 = wp::extract(var_50, var_580);
                var_582 = wp::extract(var_48, var_580);
                var_583 = wp::sub(var_581, var_582);
                var_584 = wp::abs(var_583);
                var_585 = wp::extract(var_48, var_580);
                var_586 = wp::mul(var_374, var_585);
                var_587 = (var_584 <= var_586);
                // one = 1.0 if is_near else 0.0                                                  <L 46>
                if (var_587) {
                }
                if (!var_587) {
                }
                var_590 = wp::where(var_587, var_588, var_589);
                // w = 1.0 / d[lane] - 1.0 / z[lane] if is_near else 0.0                          <L 47>
                if (var_587) {
                    var_592 = wp::extract(var_50, var_580);
                    var_593 = wp::div(var_591, var_592);
                    var_595 = wp::extract(var_48, var_580);
                    var_596 = wp::div(var_594, var_595);
                    var_597 = wp::sub(var_593, var_596);
                }
                if (!var_587) {
                }
                var_599 = wp::where(var_587, var_597, var_598);
                // count[lane] += one                                                             <L 48>
                wp::add_inplace(var_52, var_580, var_590);
                // su[lane] += one * x                                                            <L 49>
                var_600 = wp::mul(var_590, var_161);
                wp::add_inplace(var_54, var_580, var_600);
                // sv[lane] += one * y                                                            <L 50>
                var_601 = wp::mul(var_590, var_155);
                wp::add_inplace(var_56, var_580, var_601);
                // suu[lane] += one * (x * x)                                                     <L 51>
                var_602 = wp::mul(var_161, var_161);
                var_603 = wp::mul(var_590, var_602);
                wp::add_inplace(var_58, var_580, var_603);
                // suv[lane] += one * (x * y)                                                     <L 52>
                var_604 = wp::mul(var_161, var_155);
                var_605 = wp::mul(var_590, var_604);
                wp::add_inplace(var_60, var_580, var_605);
                // svv[lane] += one * (y * y)                                                     <L 53>
                var_606 = wp::mul(var_155, var_155);
                var_607 = wp::mul(var_590, var_606);
                wp::add_inplace(var_62, var_580, var_607);
                // sw[lane] += w                                                                  <L 54>
                wp::add_inplace(var_64, var_580, var_599);
                // suw[lane] += x * w                                                             <L 55>
                var_608 = wp::mul(var_161, var_599);
                wp::add_inplace(var_66, var_580, var_608);
                // svw[lane] += y * w                                                             <L 56>
                var_609 = wp::mul(var_155, var_599);
                wp::add_inplace(var_68, var_580, var_609);
                wp::assign(var_153, var_580);
                goto start_for_4;
            end_for_4:;
            goto start_for_2;
        end_for_2:;
        // support = MIN_SUPPORT * float(2 * radius + 1) * float(2 * radius + 1)                  <L 57>
        var_612 = wp::mul(var_611, var_radius);
        var_614 = wp::add(var_612, var_613);
        var_615 = wp::float(var_614);
        var_616 = wp::mul(var_610, var_615);
        var_618 = wp::mul(var_617, var_radius);
        var_620 = wp::add(var_618, var_619);
        var_621 = wp::float(var_620);
        var_622 = wp::mul(var_616, var_621);
        // for lane in range(LANES):                                                              <L 58>
        // sums = nine(count[lane], su[lane], sv[lane], suu[lane], suv[lane], svv[lane], sw[lane], suw[lane], svw[lane])       <L 59>
        var_624 = wp::extract(var_52, var_623);
        var_625 = wp::extract(var_54, var_623);
        var_626 = wp::extract(var_56, var_623);
        var_627 = wp::extract(var_58, var_623);
        var_628 = wp::extract(var_60, var_623);
        var_629 = wp::extract(var_62, var_623);
        var_630 = wp::extract(var_64, var_623);
        var_631 = wp::extract(var_66, var_623);
        var_632 = wp::extract(var_68, var_623);
        var_633 = wp::vec_t<9, wp::float32>({var_624, var_625, var_626, var_627, var_628, var_629, var_630, var_631, var_632});
        // plane = plane_of(sums, z[lane], float(first + lane), float(v), lens, support)          <L 60>
        var_634 = wp::extract(var_48, var_623);
        var_635 = wp::add(var_37, var_623);
        var_636 = wp::float(var_635);
        var_637 = wp::float(var_42);
        var_638 = plane_of_2(var_633, var_634, var_636, var_637, var_27, var_622);
        // su[lane] = plane[0]                                                                    <L 61>
        var_640 = wp::extract(var_638, var_639);
        wp::assign_inplace(var_54, var_623, var_640);
        // sv[lane] = plane[1]                                                                    <L 62>
        var_642 = wp::extract(var_638, var_641);
        wp::assign_inplace(var_56, var_623, var_642);
        // suu[lane] = plane[2]                                                                   <L 63>
        var_644 = wp::extract(var_638, var_643);
        wp::assign_inplace(var_58, var_623, var_644);
        // suv[lane] = plane[3]                                                                   <L 64>
        var_646 = wp::extract(var_638, var_645);
        wp::assign_inplace(var_60, var_623, var_646);
        // svv[lane] = plane[4]                                                                   <L 65>
        var_648 = wp::extract(var_638, var_647);
        wp::assign_inplace(var_62, var_623, var_648);
        // sums = nine(count[lane], su[lane], sv[lane], suu[lane], suv[lane], svv[lane], sw[lane], suw[lane], svw[lane])       <L 59>
        var_650 = wp::extract(var_52, var_649);
        var_651 = wp::extract(var_54, var_649);
        var_652 = wp::extract(var_56, var_649);
        var_653 = wp::extract(var_58, var_649);
        var_654 = wp::extract(var_60, var_649);
        var_655 = wp::extract(var_62, var_649);
        var_656 = wp::extract(var_64, var_649);
        var_657 = wp::extract(var_66, var_649);
        var_658 = wp::extract(var_68, var_649);
        var_659 = wp::vec_t<9, wp::float32>({var_650, var_651, var_652, var_653, var_654, var_655, var_656, var_657, var_658});
        // plane = plane_of(sums, z[lane], float(first + lane), float(v), lens, support)          <L 60>
        var_660 = wp::extract(var_48, var_649);
        var_661 = wp::add(var_37, var_649);
        var_662 = wp::float(var_661);
        var_663 = wp::float(var_42);
        var_664 = plane_of_2(var_659, var_660, var_662, var_663, var_27, var_622);
        // su[lane] = plane[0]                                                                    <L 61>
        var_666 = wp::extract(var_664, var_665);
        wp::assign_inplace(var_54, var_649, var_666);
        // sv[lane] = plane[1]                                                                    <L 62>
        var_668 = wp::extract(var_664, var_667);
        wp::assign_inplace(var_56, var_649, var_668);
        // suu[lane] = plane[2]                                                                   <L 63>
        var_670 = wp::extract(var_664, var_669);
        wp::assign_inplace(var_58, var_649, var_670);
        // suv[lane] = plane[3]                                                                   <L 64>
        var_672 = wp::extract(var_664, var_671);
        wp::assign_inplace(var_60, var_649, var_672);
        // svv[lane] = plane[4]                                                                   <L 65>
        var_674 = wp::extract(var_664, var_673);
        wp::assign_inplace(var_62, var_649, var_674);
        // sums = nine(count[lane], su[lane], sv[lane], suu[lane], suv[lane], svv[lane], sw[lane], suw[lane], svw[lane])       <L 59>
        var_676 = wp::extract(var_52, var_675);
        var_677 = wp::extract(var_54, var_675);
        var_678 = wp::extract(var_56, var_675);
        var_679 = wp::extract(var_58, var_675);
        var_680 = wp::extract(var_60, var_675);
        var_681 = wp::extract(var_62, var_675);
        var_682 = wp::extract(var_64, var_675);
        var_683 = wp::extract(var_66, var_675);
        var_684 = wp::extract(var_68, var_675);
        var_685 = wp::vec_t<9, wp::float32>({var_676, var_677, var_678, var_679, var_680, var_681, var_682, var_683, var_684});
        // plane = plane_of(sums, z[lane], float(first + lane), float(v), lens, support)          <L 60>
        var_686 = wp::extract(var_48, var_675);
        var_687 = wp::add(var_37, var_675);
        var_688 = wp::float(var_687);
        var_689 = wp::float(var_42);
        var_690 = plane_of_2(var_685, var_686, var_688, var_689, var_27, var_622);
        // su[lane] = plane[0]                                                                    <L 61>
        var_692 = wp::extract(var_690, var_691);
        wp::assign_inplace(var_54, var_675, var_692);
        // sv[lane] = plane[1]                                                                    <L 62>
        var_694 = wp::extract(var_690, var_693);
        wp::assign_inplace(var_56, var_675, var_694);
        // suu[lane] = plane[2]                                                                   <L 63>
        var_696 = wp::extract(var_690, var_695);
        wp::assign_inplace(var_58, var_675, var_696);
        // suv[lane] = plane[3]                                                                   <L 64>
        var_698 = wp::extract(var_690, var_697);
        wp::assign_inplace(var_60, var_675, var_698);
        // svv[lane] = plane[4]                                                                   <L 65>
        var_700 = wp::extract(var_690, var_699);
        wp::assign_inplace(var_62, var_675, var_700);
        // sums = nine(count[lane], su[lane], sv[lane], suu[lane], suv[lane], svv[lane], sw[lane], suw[lane], svw[lane])       <L 59>
        var_702 = wp::extract(var_52, var_701);
        var_703 = wp::extract(var_54, var_701);
        var_704 = wp::extract(var_56, var_701);
        var_705 = wp::extract(var_58, var_701);
        var_706 = wp::extract(var_60, var_701);
        var_707 = wp::extract(var_62, var_701);
        var_708 = wp::extract(var_64, var_701);
        var_709 = wp::extract(var_66, var_701);
        var_710 = wp::extract(var_68, var_701);
        var_711 = wp::vec_t<9, wp::float32>({var_702, var_703, var_704, var_705, var_706, var_707, var_708, var_709, var_710});
        // plane = plane_of(sums, z[lane], float(first + lane), float(v), lens, support)          <L 60>
        var_712 = wp::extract(var_48, var_701);
        var_713 = wp::add(var_37, var_701);
        var_714 = wp::float(var_713);
        var_715 = wp::float(var_42);
        var_716 = plane_of_2(var_711, var_712, var_714, var_715, var_27, var_622);
        // su[lane] = plane[0]                                                                    <L 61>
        var_718 = wp::extract(var_716, var_717);
        wp::assign_inplace(var_54, var_701, var_718);
        // sv[lane] = plane[1]                                                                    <L 62>
        var_720 = wp::extract(var_716, var_719);
        wp::assign_inplace(var_56, var_701, var_720);
        // suu[lane] = plane[2]                                                                   <L 63>
        var_722 = wp::extract(var_716, var_721);
        wp::assign_inplace(var_58, var_701, var_722);
        // suv[lane] = plane[3]                                                                   <L 64>
        var_724 = wp::extract(var_716, var_723);
        wp::assign_inplace(var_60, var_701, var_724);
        // svv[lane] = plane[4]                                                                   <L 65>
        var_726 = wp::extract(var_716, var_725);
        wp::assign_inplace(var_62, var_701, var_726);
        // sums = nine(count[lane], su[lane], sv[lane], suu[lane], suv[lane], svv[lane], sw[lane], suw[lane], svw[lane])       <L 59>
        var_728 = wp::extract(var_52, var_727);
        var_729 = wp::extract(var_54, var_727);
        var_730 = wp::extract(var_56, var_727);
        var_731 = wp::extract(var_58, var_727);
        var_732 = wp::extract(var_60, var_727);
        var_733 = wp::extract(var_62, var_727);
        var_734 = wp::extract(var_64, var_727);
        var_735 = wp::extract(var_66, var_727);
        var_736 = wp::extract(var_68, var_727);
        var_737 = wp::vec_t<9, wp::float32>({var_728, var_729, var_730, var_731, var_732, var_733, var_734, var_735, var_736});
        // plane = plane_of(sums, z[lane], float(first + lane), float(v), lens, support)          <L 60>
        var_738 = wp::extract(var_48, var_727);
        var_739 = wp::add(var_37, var_727);
        var_740 = wp::float(var_739);
        var_741 = wp::float(var_42);
        var_742 = plane_of_2(var_737, var_738, var_740, var_741, var_27, var_622);
        // su[lane] = plane[0]                                                                    <L 61>
        var_744 = wp::extract(var_742, var_743);
        wp::assign_inplace(var_54, var_727, var_744);
        // sv[lane] = plane[1]                                                                    <L 62>
        var_746 = wp::extract(var_742, var_745);
        wp::assign_inplace(var_56, var_727, var_746);
        // suu[lane] = plane[2]                                                                   <L 63>
        var_748 = wp::extract(var_742, var_747);
        wp::assign_inplace(var_58, var_727, var_748);
        // suv[lane] = plane[3]                                                                   <L 64>
        var_750 = wp::extract(var_742, var_749);
        wp::assign_inplace(var_60, var_727, var_750);
        // svv[lane] = plane[4]                                                                   <L 65>
        var_752 = wp::extract(var_742, var_751);
        wp::assign_inplace(var_62, var_727, var_752);
        // sums = nine(count[lane], su[lane], sv[lane], suu[lane], suv[lane], svv[lane], sw[lane], suw[lane], svw[lane])       <L 59>
        var_754 = wp::extract(var_52, var_753);
        var_755 = wp::extract(var_54, var_753);
        var_756 = wp::extract(var_56, var_753);
        var_757 = wp::extract(var_58, var_753);
        var_758 = wp::extract(var_60, var_753);
        var_759 = wp::extract(var_62, var_753);
        var_760 = wp::extract(var_64, var_753);
        var_761 = wp::extract(var_66, var_753);
        var_762 = wp::extract(var_68, var_753);
        var_763 = wp::vec_t<9, wp::float32>({var_754, var_755, var_756, var_757, var_758, var_759, var_760, var_761, var_762});
        // plane = plane_of(sums, z[lane], float(first + lane), float(v), lens, support)          <L 60>
        var_764 = wp::extract(var_48, var_753);
        var_765 = wp::add(var_37, var_753);
        var_766 = wp::float(var_765);
        var_767 = wp::float(var_42);
        var_768 = plane_of_2(var_763, var_764, var_766, var_767, var_27, var_622);
        // su[lane] = plane[0]                                                                    <L 61>
        var_770 = wp::extract(var_768, var_769);
        wp::assign_inplace(var_54, var_753, var_770);
        // sv[lane] = plane[1]                                                                    <L 62>
        var_772 = wp::extract(var_768, var_771);
        wp::assign_inplace(var_56, var_753, var_772);
        // suu[lane] = plane[2]                                                                   <L 63>
        var_774 = wp::extract(var_768, var_773);
        wp::assign_inplace(var_58, var_753, var_774);
        // suv[lane] = plane[3]                                                                   <L 64>
        var_776 = wp::extract(var_768, var_775);
        wp::assign_inplace(var_60, var_753, var_776);
        // svv[lane] = plane[4]                                                                   <L 65>
        var_778 = wp::extract(var_768, var_777);
        wp::assign_inplace(var_62, var_753, var_778);
        // sums = nine(count[lane], su[lane], sv[lane], suu[lane], suv[lane], svv[lane], sw[lane], suw[lane], svw[lane])       <L 59>
        var_780 = wp::extract(var_52, var_779);
        var_781 = wp::extract(var_54, var_779);
        var_782 = wp::extract(var_56, var_779);
        var_783 = wp::extract(var_58, var_779);
        var_784 = wp::extract(var_60, var_779);
        var_785 = wp::extract(var_62, var_779);
        var_786 = wp::extract(var_64, var_779);
        var_787 = wp::extract(var_66, var_779);
        var_788 = wp::extract(var_68, var_779);
        var_789 = wp::vec_t<9, wp::float32>({var_780, var_781, var_782, var_783, var_784, var_785, var_786, var_787, var_788});
        // plane = plane_of(sums, z[lane], float(first + lane), float(v), lens, support)          <L 60>
        var_790 = wp::extract(var_48, var_779);
        var_791 = wp::add(var_37, var_779);
        var_792 = wp::float(var_791);
        var_793 = wp::float(var_42);
        var_794 = plane_of_2(var_789, var_790, var_792, var_793, var_27, var_622);
        // su[lane] = plane[0]                                                                    <L 61>
        var_796 = wp::extract(var_794, var_795);
        wp::assign_inplace(var_54, var_779, var_796);
        // sv[lane] = plane[1]                                                                    <L 62>
        var_798 = wp::extract(var_794, var_797);
        wp::assign_inplace(var_56, var_779, var_798);
        // suu[lane] = plane[2]                                                                   <L 63>
        var_800 = wp::extract(var_794, var_799);
        wp::assign_inplace(var_58, var_779, var_800);
        // suv[lane] = plane[3]                                                                   <L 64>
        var_802 = wp::extract(var_794, var_801);
        wp::assign_inplace(var_60, var_779, var_802);
        // svv[lane] = plane[4]                                                                   <L 65>
        var_804 = wp::extract(var_794, var_803);
        wp::assign_inplace(var_62, var_779, var_804);
        // sums = nine(count[lane], su[lane], sv[lane], suu[lane], suv[lane], svv[lane], sw[lane], suw[lane], svw[lane])       <L 59>
        var_806 = wp::extract(var_52, var_805);
        var_807 = wp::extract(var_54, var_805);
        var_808 = wp::extract(var_56, var_805);
        var_809 = wp::extract(var_58, var_805);
        var_810 = wp::extract(var_60, var_805);
        var_811 = wp::extract(var_62, var_805);
        var_812 = wp::extract(var_64, var_805);
        var_813 = wp::extract(var_66, var_805);
        var_814 = wp::extract(var_68, var_805);
        var_815 = wp::vec_t<9, wp::float32>({var_806, var_807, var_808, var_809, var_810, var_811, var_812, var_813, var_814});
        // plane = plane_of(sums, z[lane], float(first + lane), float(v), lens, support)          <L 60>
        var_816 = wp::extract(var_48, var_805);
        var_817 = wp::add(var_37, var_805);
        var_818 = wp::float(var_817);
        var_819 = wp::float(var_42);
        var_820 = plane_of_2(var_815, var_816, var_818, var_819, var_27, var_622);
        // su[lane] = plane[0]                                                                    <L 61>
        var_822 = wp::extract(var_820, var_821);
        wp::assign_inplace(var_54, var_805, var_822);
        // sv[lane] = plane[1]                                                                    <L 62>
        var_824 = wp::extract(var_820, var_823);
        wp::assign_inplace(var_56, var_805, var_824);
        // suu[lane] = plane[2]                                                                   <L 63>
        var_826 = wp::extract(var_820, var_825);
        wp::assign_inplace(var_58, var_805, var_826);
        // suv[lane] = plane[3]                                                                   <L 64>
        var_828 = wp::extract(var_820, var_827);
        wp::assign_inplace(var_60, var_805, var_828);
        // svv[lane] = plane[4]                                                                   <L 65>
        var_830 = wp::extract(var_820, var_829);
        wp::assign_inplace(var_62, var_805, var_830);
        // for lane in range(LANES):                                                              <L 66>
        // if first + lane < width:                                                               <L 67>
        var_832 = wp::add(var_37, var_831);
        var_833 = (var_832 < var_30);
        if (var_833) {
            // at = line + first + lane                                                           <L 68>
            var_834 = wp::add(var_46, var_37);
            var_835 = wp::add(var_834, var_831);
            // if z[lane] > 0.0:                                                                  <L 69>
            var_836 = wp::extract(var_48, var_831);
            var_838 = (var_836 > var_837);
            if (var_838) {
                // planes[at] = vec4(su[lane], sv[lane], suu[lane], suv[lane])                    <L 70>
                var_839 = wp::extract(var_54, var_831);
                var_840 = wp::extract(var_56, var_831);
                var_841 = wp::extract(var_58, var_831);
                var_842 = wp::extract(var_60, var_831);
                var_843 = wp::vec_t<4, wp::float32>(var_839, var_840, var_841, var_842);
                wp::array_store(var_planes, var_835, var_843);
                // smoothed[at] = svv[lane]                                                       <L 71>
                var_844 = wp::extract(var_62, var_831);
                wp::array_store(var_smoothed, var_835, var_844);
            }
            if (!var_838) {
                // planes[at] = vec4(0.0, 0.0, 0.0, 0.0)                                          <L 73>
                var_849 = wp::vec_t<4, wp::float32>(var_845, var_846, var_847, var_848);
                wp::array_store(var_planes, var_835, var_849);
                // smoothed[at] = z[lane]                                                         <L 74>
                var_850 = wp::extract(var_48, var_831);
                wp::array_store(var_smoothed, var_835, var_850);
            }
        }
        // if first + lane < width:                                                               <L 67>
        var_852 = wp::add(var_37, var_851);
        var_853 = (var_852 < var_30);
        if (var_853) {
            // at = line + first + lane                                                           <L 68>
            var_854 = wp::add(var_46, var_37);
            var_855 = wp::add(var_854, var_851);
            // if z[lane] > 0.0:                                                                  <L 69>
            var_856 = wp::extract(var_48, var_851);
            var_858 = (var_856 > var_857);
            if (var_858) {
                // planes[at] = vec4(su[lane], sv[lane], suu[lane], suv[lane])                    <L 70>
                var_859 = wp::extract(var_54, var_851);
                var_860 = wp::extract(var_56, var_851);
                var_861 = wp::extract(var_58, var_851);
                var_862 = wp::extract(var_60, var_851);
                var_863 = wp::vec_t<4, wp::float32>(var_859, var_860, var_861, var_862);
                wp::array_store(var_planes, var_855, var_863);
                // smoothed[at] = svv[lane]                                                       <L 71>
                var_864 = wp::extract(var_62, var_851);
                wp::array_store(var_smoothed, var_855, var_864);
            }
            if (!var_858) {
                // planes[at] = vec4(0.0, 0.0, 0.0, 0.0)                                          <L 73>
                var_869 = wp::vec_t<4, wp::float32>(var_865, var_866, var_867, var_868);
                wp::array_store(var_planes, var_855, var_869);
                // smoothed[at] = z[lane]                                                         <L 74>
                var_870 = wp::extract(var_48, var_851);
                wp::array_store(var_smoothed, var_855, var_870);
            }
        }
        var_871 = wp::where(var_853, var_855, var_835);
        // if first + lane < width:                                                               <L 67>
        var_873 = wp::add(var_37, var_872);
        var_874 = (var_873 < var_30);
        if (var_874) {
            // at = line + first + lane                                                           <L 68>
            var_875 = wp::add(var_46, var_37);
            var_876 = wp::add(var_875, var_872);
            // if z[lane] > 0.0:                                                                  <L 69>
            var_877 = wp::extract(var_48, var_872);
            var_879 = (var_877 > var_878);
            if (var_879) {
                // planes[at] = vec4(su[lane], sv[lane], suu[lane], suv[lane])                    <L 70>
                var_880 = wp::extract(var_54, var_872);
                var_881 = wp::extract(var_56, var_872);
                var_882 = wp::extract(var_58, var_872);
                var_883 = wp::extract(var_60, var_872);
                var_884 = wp::vec_t<4, wp::float32>(var_880, var_881, var_882, var_883);
                wp::array_store(var_planes, var_876, var_884);
                // smoothed[at] = svv[lane]                                                       <L 71>
                var_885 = wp::extract(var_62, var_872);
                wp::array_store(var_smoothed, var_876, var_885);
            }
            if (!var_879) {
                // planes[at] = vec4(0.0, 0.0, 0.0, 0.0)                                          <L 73>
                var_890 = wp::vec_t<4, wp::float32>(var_886, var_887, var_888, var_889);
                wp::array_store(var_planes, var_876, var_890);
                // smoothed[at] = z[lane]                                                         <L 74>
                var_891 = wp::extract(var_48, var_872);
                wp::array_store(var_smoothed, var_876, var_891);
            }
        }
        var_892 = wp::where(var_874, var_876, var_871);
        // if first + lane < width:                                                               <L 67>
        var_894 = wp::add(var_37, var_893);
        var_895 = (var_894 < var_30);
        if (var_895) {
            // at = line + first + lane                                                           <L 68>
            var_896 = wp::add(var_46, var_37);
            var_897 = wp::add(var_896, var_893);
            // if z[lane] > 0.0:                                                                  <L 69>
            var_898 = wp::extract(var_48, var_893);
            var_900 = (var_898 > var_899);
            if (var_900) {
                // planes[at] = vec4(su[lane], sv[lane], suu[lane], suv[lane])                    <L 70>
                var_901 = wp::extract(var_54, var_893);
                var_902 = wp::extract(var_56, var_893);
                var_903 = wp::extract(var_58, var_893);
                var_904 = wp::extract(var_60, var_893);
                var_905 = wp::vec_t<4, wp::float32>(var_901, var_902, var_903, var_904);
                wp::array_store(var_planes, var_897, var_905);
                // smoothed[at] = svv[lane]                                                       <L 71>
                var_906 = wp::extract(var_62, var_893);
                wp::array_store(var_smoothed, var_897, var_906);
            }
            if (!var_900) {
                // planes[at] = vec4(0.0, 0.0, 0.0, 0.0)                                          <L 73>
                var_911 = wp::vec_t<4, wp::float32>(var_907, var_908, var_909, var_910);
                wp::array_store(var_planes, var_897, var_911);
                // smoothed[at] = z[lane]                                                         <L 74>
                var_912 = wp::extract(var_48, var_893);
                wp::array_store(var_smoothed, var_897, var_912);
            }
        }
        var_913 = wp::where(var_895, var_897, var_892);
        // if first + lane < width:                                                               <L 67>
        var_915 = wp::add(var_37, var_914);
        var_916 = (var_915 < var_30);
        if (var_916) {
            // at = line + first + lane                                                           <L 68>
            var_917 = wp::add(var_46, var_37);
            var_918 = wp::add(var_917, var_914);
            // if z[lane] > 0.0:                                                                  <L 69>
            var_919 = wp::extract(var_48, var_914);
            var_921 = (var_919 > var_920);
            if (var_921) {
                // planes[at] = vec4(su[lane], sv[lane], suu[lane], suv[lane])                    <L 70>
                var_922 = wp::extract(var_54, var_914);
                var_923 = wp::extract(var_56, var_914);
                var_924 = wp::extract(var_58, var_914);
                var_925 = wp::extract(var_60, var_914);
                var_926 = wp::vec_t<4, wp::float32>(var_922, var_923, var_924, var_925);
                wp::array_store(var_planes, var_918, var_926);
                // smoothed[at] = svv[lane]                                                       <L 71>
                var_927 = wp::extract(var_62, var_914);
                wp::array_store(var_smoothed, var_918, var_927);
            }
            if (!var_921) {
                // planes[at] = vec4(0.0, 0.0, 0.0, 0.0)                                          <L 73>
                var_932 = wp::vec_t<4, wp::float32>(var_928, var_929, var_930, var_931);
                wp::array_store(var_planes, var_918, var_932);
                // smoothed[at] = z[lane]                                                         <L 74>
                var_933 = wp::extract(var_48, var_914);
                wp::array_store(var_smoothed, var_918, var_933);
            }
        }
        var_934 = wp::where(var_916, var_918, var_913);
        // if first + lane < width:                                                               <L 67>
        var_936 = wp::add(var_37, var_935);
        var_937 = (var_936 < var_30);
        if (var_937) {
            // at = line + first + lane                                                           <L 68>
            var_938 = wp::add(var_46, var_37);
            var_939 = wp::add(var_938, var_935);
            // if z[lane] > 0.0:                                                                  <L 69>
            var_940 = wp::extract(var_48, var_935);
            var_942 = (var_940 > var_941);
            if (var_942) {
                // planes[at] = vec4(su[lane], sv[lane], suu[lane], suv[lane])                    <L 70>
                var_943 = wp::extract(var_54, var_935);
                var_944 = wp::extract(var_56, var_935);
                var_945 = wp::extract(var_58, var_935);
                var_946 = wp::extract(var_60, var_935);
                var_947 = wp::vec_t<4, wp::float32>(var_943, var_944, var_945, var_946);
                wp::array_store(var_planes, var_939, var_947);
                // smoothed[at] = svv[lane]                                                       <L 71>
                var_948 = wp::extract(var_62, var_935);
                wp::array_store(var_smoothed, var_939, var_948);
            }
            if (!var_942) {
                // planes[at] = vec4(0.0, 0.0, 0.0, 0.0)                                          <L 73>
                var_953 = wp::vec_t<4, wp::float32>(var_949, var_950, var_951, var_952);
                wp::array_store(var_planes, var_939, var_953);
                // smoothed[at] = z[lane]                                                         <L 74>
                var_954 = wp::extract(var_48, var_935);
                wp::array_store(var_smoothed, var_939, var_954);
            }
        }
        var_955 = wp::where(var_937, var_939, var_934);
        // if first + lane < width:                                                               <L 67>
        var_957 = wp::add(var_37, var_956);
        var_958 = (var_957 < var_30);
        if (var_958) {
            // at = line + first + lane                                                           <L 68>
            var_959 = wp::add(var_46, var_37);
            var_960 = wp::add(var_959, var_956);
            // if z[lane] > 0.0:                                                                  <L 69>
            var_961 = wp::extract(var_48, var_956);
            var_963 = (var_961 > var_962);
            if (var_963) {
                // planes[at] = vec4(su[lane], sv[lane], suu[lane], suv[lane])                    <L 70>
                var_964 = wp::extract(var_54, var_956);
                var_965 = wp::extract(var_56, var_956);
                var_966 = wp::extract(var_58, var_956);
                var_967 = wp::extract(var_60, var_956);
                var_968 = wp::vec_t<4, wp::float32>(var_964, var_965, var_966, var_967);
                wp::array_store(var_planes, var_960, var_968);
                // smoothed[at] = svv[lane]                                                       <L 71>
                var_969 = wp::extract(var_62, var_956);
                wp::array_store(var_smoothed, var_960, var_969);
            }
            if (!var_963) {
                // planes[at] = vec4(0.0, 0.0, 0.0, 0.0)                                          <L 73>
                var_974 = wp::vec_t<4, wp::float32>(var_970, var_971, var_972, var_973);
                wp::array_store(var_planes, var_960, var_974);
                // smoothed[at] = z[lane]                                                         <L 74>
                var_975 = wp::extract(var_48, var_956);
                wp::array_store(var_smoothed, var_960, var_975);
            }
        }
        var_976 = wp::where(var_958, var_960, var_955);
        // if first + lane < width:                                                               <L 67>
        var_978 = wp::add(var_37, var_977);
        var_979 = (var_978 < var_30);
        if (var_979) {
            // at = line + first + lane                                                           <L 68>
            var_980 = wp::add(var_46, var_37);
            var_981 = wp::add(var_980, var_977);
            // if z[lane] > 0.0:                                                                  <L 69>
            var_982 = wp::extract(var_48, var_977);
            var_984 = (var_982 > var_983);
            if (var_984) {
                // planes[at] = vec4(su[lane], sv[lane], suu[lane], suv[lane])                    <L 70>
                var_985 = wp::extract(var_54, var_977);
                var_986 = wp::extract(var_56, var_977);
                var_987 = wp::extract(var_58, var_977);
                var_988 = wp::extract(var_60, var_977);
                var_989 = wp::vec_t<4, wp::float32>(var_985, var_986, var_987, var_988);
                wp::array_store(var_planes, var_981, var_989);
                // smoothed[at] = svv[lane]                                                       <L 71>
                var_990 = wp::extract(var_62, var_977);
                wp::array_store(var_smoothed, var_981, var_990);
            }
            if (!var_984) {
                // planes[at] = vec4(0.0, 0.0, 0.0, 0.0)                                          <L 73>
                var_995 = wp::vec_t<4, wp::float32>(var_991, var_992, var_993, var_994);
                wp::array_store(var_planes, var_981, var_995);
                // smoothed[at] = z[lane]                                                         <L 74>
                var_996 = wp::extract(var_48, var_977);
                wp::array_store(var_smoothed, var_981, var_996);
            }
        }
        var_997 = wp::where(var_979, var_981, var_976);
}



extern "C" __global__ void take_normals_kernel_2b6db502_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_normals,
    wp::array_t<wp::float32> var_depth,
    wp::vec_t<4, wp::float32> var_lens,
    wp::int32 var_width,
    wp::array_t<wp::vec_t<4, wp::float32>> var_planes)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::float32* var_1;
        wp::float32 var_2;
        wp::float32 var_3;
        wp::vec_t<3, wp::float32>* var_4;
        wp::vec_t<3, wp::float32> var_5;
        wp::vec_t<3, wp::float32> var_6;
        const wp::float32 var_7 = 0.0;
        const wp::float32 var_8 = 0.0;
        const wp::float32 var_9 = 0.0;
        const wp::float32 var_10 = 0.0;
        wp::vec_t<4, wp::float32> var_11;
        const wp::int32 var_12 = 0;
        wp::float32 var_13;
        const wp::int32 var_14 = 0;
        wp::float32 var_15;
        wp::float32 var_16;
        const wp::int32 var_17 = 1;
        wp::float32 var_18;
        const wp::int32 var_19 = 1;
        wp::float32 var_20;
        wp::float32 var_21;
        wp::float32 var_22;
        const wp::int32 var_23 = 2;
        wp::float32 var_24;
        const wp::int32 var_25 = 2;
        wp::float32 var_26;
        wp::float32 var_27;
        wp::float32 var_28;
        bool var_29;
        const wp::float32 var_30 = 0.0;
        bool var_31;
        const wp::float32 var_32 = 0.25;
        bool var_33;
        const wp::float32 var_34 = 4.0;
        bool var_35;
        wp::float32 var_36;
        wp::int32 var_37;
        wp::float32 var_38;
        const wp::int32 var_39 = 2;
        wp::float32 var_40;
        wp::float32 var_41;
        const wp::int32 var_42 = 0;
        wp::float32 var_43;
        wp::float32 var_44;
        wp::float32 var_45;
        wp::int32 var_46;
        wp::float32 var_47;
        const wp::int32 var_48 = 3;
        wp::float32 var_49;
        wp::float32 var_50;
        const wp::int32 var_51 = 1;
        wp::float32 var_52;
        wp::float32 var_53;
        wp::float32 var_54;
        const wp::int32 var_55 = 0;
        wp::float32 var_56;
        wp::float32 var_57;
        const wp::int32 var_58 = 1;
        wp::float32 var_59;
        wp::float32 var_60;
        wp::float32 var_61;
        const wp::int32 var_62 = 2;
        wp::float32 var_63;
        wp::float32 var_64;
        wp::float32 var_65;
        wp::float32 var_66;
        const wp::float32 var_67 = 1.0;
        wp::float32 var_68;
        const wp::float32 var_69 = 0.0;
        bool var_70;
        const wp::float32 var_71 = -1.0;
        wp::float32 var_72;
        const wp::int32 var_73 = 0;
        wp::float32 var_74;
        wp::float32 var_75;
        wp::float32 var_76;
        const wp::int32 var_77 = 1;
        wp::float32 var_78;
        wp::float32 var_79;
        wp::float32 var_80;
        const wp::int32 var_81 = 2;
        wp::float32 var_82;
        wp::float32 var_83;
        wp::float32 var_84;
        wp::float32 var_85;
        wp::vec_t<4, wp::float32> var_86;
        wp::vec_t<4, wp::float32> var_87;
        //---------
        // forward
        // def take_normals_kernel(                                                               <L 307>
        // i = tid()                                                                              <L 311>
        var_0 = builtin_tid1d();
        // z = depth[i]                                                                           <L 312>
        var_1 = wp::address(var_depth, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // n = normals[i]                                                                         <L 313>
        var_4 = wp::address(var_normals, var_0);
        var_6 = wp::load(var_4);
        var_5 = wp::copy(var_6);
        // plane = vec4(0.0, 0.0, 0.0, 0.0)                                                       <L 314>
        var_11 = wp::vec_t<4, wp::float32>(var_7, var_8, var_9, var_10);
        // square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2]                                       <L 315>
        var_13 = wp::extract(var_5, var_12);
        var_15 = wp::extract(var_5, var_14);
        var_16 = wp::mul(var_13, var_15);
        var_18 = wp::extract(var_5, var_17);
        var_20 = wp::extract(var_5, var_19);
        var_21 = wp::mul(var_18, var_20);
        var_22 = wp::add(var_16, var_21);
        var_24 = wp::extract(var_5, var_23);
        var_26 = wp::extract(var_5, var_25);
        var_27 = wp::mul(var_24, var_26);
        var_28 = wp::add(var_22, var_27);
        // if z > 0.0 and square > 0.25 and square < 4.0:                                         <L 316>
        var_31 = (var_2 > var_30);
        var_29 = var_31;
        if (var_29) {
            var_33 = (var_28 > var_32);
            var_29 = var_29 && var_33;
        }
        if (var_29) {
            var_35 = (var_28 < var_34);
            var_29 = var_29 && var_35;
        }
        if (var_29) {
            // length = sqrt(square)                                                              <L 317>
            var_36 = wp::sqrt(var_28);
            // x = (float(i % width) - lens[2]) / lens[0] * z                                     <L 318>
            var_37 = wp::mod(var_0, var_width);
            var_38 = wp::float(var_37);
            var_40 = wp::extract(var_lens, var_39);
            var_41 = wp::sub(var_38, var_40);
            var_43 = wp::extract(var_lens, var_42);
            var_44 = wp::div(var_41, var_43);
            var_45 = wp::mul(var_44, var_2);
            // y = (float(i // width) - lens[3]) / lens[1] * z                                    <L 319>
            var_46 = wp::floordiv(var_0, var_width);
            var_47 = wp::float(var_46);
            var_49 = wp::extract(var_lens, var_48);
            var_50 = wp::sub(var_47, var_49);
            var_52 = wp::extract(var_lens, var_51);
            var_53 = wp::div(var_50, var_52);
            var_54 = wp::mul(var_53, var_2);
            // d = (n[0] * x + n[1] * y + n[2] * z) / length                                      <L 320>
            var_56 = wp::extract(var_5, var_55);
            var_57 = wp::mul(var_56, var_45);
            var_59 = wp::extract(var_5, var_58);
            var_60 = wp::mul(var_59, var_54);
            var_61 = wp::add(var_57, var_60);
            var_63 = wp::extract(var_5, var_62);
            var_64 = wp::mul(var_63, var_2);
            var_65 = wp::add(var_61, var_64);
            var_66 = wp::div(var_65, var_36);
            // side = float(1.0)                                                                  <L 321>
            var_68 = wp::float(var_67);
            // if d > 0.0:                                                                        <L 322>
            var_70 = (var_66 > var_69);
            if (var_70) {
                // side = -1.0                                                                    <L 323>
            }
            var_72 = wp::where(var_70, var_71, var_68);
            // plane = vec4(side * n[0] / length, side * n[1] / length, side * n[2] / length, side * d)       <L 324>
            var_74 = wp::extract(var_5, var_73);
            var_75 = wp::mul(var_72, var_74);
            var_76 = wp::div(var_75, var_36);
            var_78 = wp::extract(var_5, var_77);
            var_79 = wp::mul(var_72, var_78);
            var_80 = wp::div(var_79, var_36);
            var_82 = wp::extract(var_5, var_81);
            var_83 = wp::mul(var_72, var_82);
            var_84 = wp::div(var_83, var_36);
            var_85 = wp::mul(var_72, var_66);
            var_86 = wp::vec_t<4, wp::float32>(var_76, var_80, var_84, var_85);
        }
        var_87 = wp::where(var_29, var_86, var_11);
        // planes[i] = plane                                                                      <L 325>
        wp::array_store(var_planes, var_0, var_87);
}



extern "C" __global__ void halve_level_kernel_4da4f25f_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_depth,
    wp::array_t<wp::float32> var_brightness,
    wp::int32 var_first,
    wp::int32 var_width,
    wp::int32 var_columns,
    wp::int32 var_out,
    wp::array_t<wp::float32> var_halved_depths,
    wp::array_t<wp::float32> var_halved_brightnesses)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        const wp::int32 var_1 = 2;
        wp::int32 var_2;
        wp::int32 var_3;
        wp::int32 var_4;
        wp::int32 var_5;
        const wp::int32 var_6 = 2;
        wp::int32 var_7;
        wp::int32 var_8;
        wp::int32 var_9;
        wp::float32* var_10;
        const wp::int32 var_11 = 1;
        wp::int32 var_12;
        wp::float32* var_13;
        wp::int32 var_14;
        wp::float32* var_15;
        wp::int32 var_16;
        const wp::int32 var_17 = 1;
        wp::int32 var_18;
        wp::float32* var_19;
        wp::float32 var_20;
        wp::float32 var_21;
        wp::float32 var_22;
        wp::float32 var_23;
        wp::float32 var_24;
        wp::int32 var_25;
        wp::float32* var_26;
        const wp::int32 var_27 = 1;
        wp::int32 var_28;
        wp::float32* var_29;
        wp::int32 var_30;
        wp::float32* var_31;
        wp::int32 var_32;
        const wp::int32 var_33 = 1;
        wp::int32 var_34;
        wp::float32* var_35;
        wp::float32 var_36;
        wp::float32 var_37;
        wp::float32 var_38;
        wp::float32 var_39;
        wp::float32 var_40;
        wp::int32 var_41;
        //---------
        // forward
        // def halve_level_kernel(                                                                <L 129>
        // i = tid()                                                                              <L 139>
        var_0 = builtin_tid1d();
        // at = first + 2 * (i // columns) * width + 2 * (i % columns)                            <L 140>
        var_2 = wp::floordiv(var_0, var_columns);
        var_3 = wp::mul(var_1, var_2);
        var_4 = wp::mul(var_3, var_width);
        var_5 = wp::add(var_first, var_4);
        var_7 = wp::mod(var_0, var_columns);
        var_8 = wp::mul(var_6, var_7);
        var_9 = wp::add(var_5, var_8);
        // halved_depths[out + i] = halved_depth(depth[at], depth[at + 1], depth[at + width], depth[at + width + 1])       <L 141>
        var_10 = wp::address(var_depth, var_9);
        var_12 = wp::add(var_9, var_11);
        var_13 = wp::address(var_depth, var_12);
        var_14 = wp::add(var_9, var_width);
        var_15 = wp::address(var_depth, var_14);
        var_16 = wp::add(var_9, var_width);
        var_18 = wp::add(var_16, var_17);
        var_19 = wp::address(var_depth, var_18);
        var_21 = wp::load(var_10);
        var_22 = wp::load(var_13);
        var_23 = wp::load(var_15);
        var_24 = wp::load(var_19);
        var_20 = halved_depth_0(var_21, var_22, var_23, var_24);
        var_25 = wp::add(var_out, var_0);
        wp::array_store(var_halved_depths, var_25, var_20);
        // halved_brightnesses[out + i] = halved_brightness(                                      <L 142>
        // brightness[at], brightness[at + 1], brightness[at + width], brightness[at + width + 1]       <L 143>
        var_26 = wp::address(var_brightness, var_9);
        var_28 = wp::add(var_9, var_27);
        var_29 = wp::address(var_brightness, var_28);
        var_30 = wp::add(var_9, var_width);
        var_31 = wp::address(var_brightness, var_30);
        var_32 = wp::add(var_9, var_width);
        var_34 = wp::add(var_32, var_33);
        var_35 = wp::address(var_brightness, var_34);
        var_37 = wp::load(var_26);
        var_38 = wp::load(var_29);
        var_39 = wp::load(var_31);
        var_40 = wp::load(var_35);
        var_36 = halved_brightness_0(var_37, var_38, var_39, var_40);
        // halved_brightnesses[out + i] = halved_brightness(                                      <L 142>
        var_41 = wp::add(var_out, var_0);
        wp::array_store(var_halved_brightnesses, var_41, var_36);
}



extern "C" __global__ void halve_colors_kernel_53ba84bf_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_depth,
    wp::array_t<wp::uint8> var_pixels,
    wp::int32 var_width,
    wp::int32 var_columns,
    wp::array_t<wp::float32> var_halved_depths,
    wp::array_t<wp::float32> var_halved_brightnesses)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        const wp::int32 var_1 = 2;
        wp::int32 var_2;
        wp::int32 var_3;
        wp::int32 var_4;
        const wp::int32 var_5 = 2;
        wp::int32 var_6;
        wp::int32 var_7;
        wp::int32 var_8;
        wp::float32* var_9;
        const wp::int32 var_10 = 1;
        wp::int32 var_11;
        wp::float32* var_12;
        wp::int32 var_13;
        wp::float32* var_14;
        wp::int32 var_15;
        const wp::int32 var_16 = 1;
        wp::int32 var_17;
        wp::float32* var_18;
        wp::float32 var_19;
        wp::float32 var_20;
        wp::float32 var_21;
        wp::float32 var_22;
        wp::float32 var_23;
        wp::float32 var_24;
        const wp::int32 var_25 = 1;
        wp::int32 var_26;
        wp::float32 var_27;
        wp::float32 var_28;
        wp::int32 var_29;
        wp::float32 var_30;
        wp::float32 var_31;
        wp::int32 var_32;
        const wp::int32 var_33 = 1;
        wp::int32 var_34;
        wp::float32 var_35;
        wp::float32 var_36;
        const wp::float32 var_37 = 0.25;
        wp::float32 var_38;
        //---------
        // forward
        // def halve_colors_kernel(                                                               <L 153>
        // i = tid()                                                                              <L 161>
        var_0 = builtin_tid1d();
        // at = 2 * (i // columns) * width + 2 * (i % columns)                                    <L 162>
        var_2 = wp::floordiv(var_0, var_columns);
        var_3 = wp::mul(var_1, var_2);
        var_4 = wp::mul(var_3, var_width);
        var_6 = wp::mod(var_0, var_columns);
        var_7 = wp::mul(var_5, var_6);
        var_8 = wp::add(var_4, var_7);
        // halved_depths[i] = halved_depth(depth[at], depth[at + 1], depth[at + width], depth[at + width + 1])       <L 163>
        var_9 = wp::address(var_depth, var_8);
        var_11 = wp::add(var_8, var_10);
        var_12 = wp::address(var_depth, var_11);
        var_13 = wp::add(var_8, var_width);
        var_14 = wp::address(var_depth, var_13);
        var_15 = wp::add(var_8, var_width);
        var_17 = wp::add(var_15, var_16);
        var_18 = wp::address(var_depth, var_17);
        var_20 = wp::load(var_9);
        var_21 = wp::load(var_12);
        var_22 = wp::load(var_14);
        var_23 = wp::load(var_18);
        var_19 = halved_depth_0(var_20, var_21, var_22, var_23);
        wp::array_store(var_halved_depths, var_0, var_19);
        // total = luma(at, pixels) + luma(at + 1, pixels) + luma(at + width, pixels) + luma(at + width + 1, pixels)       <L 164>
        var_24 = luma_0(var_8, var_pixels);
        var_26 = wp::add(var_8, var_25);
        var_27 = luma_0(var_26, var_pixels);
        var_28 = wp::add(var_24, var_27);
        var_29 = wp::add(var_8, var_width);
        var_30 = luma_0(var_29, var_pixels);
        var_31 = wp::add(var_28, var_30);
        var_32 = wp::add(var_8, var_width);
        var_34 = wp::add(var_32, var_33);
        var_35 = luma_0(var_34, var_pixels);
        var_36 = wp::add(var_31, var_35);
        // halved_brightnesses[i] = total * 0.25                                                  <L 165>
        var_38 = wp::mul(var_36, var_37);
        wp::array_store(var_halved_brightnesses, var_0, var_38);
}



extern "C" __global__ void take_level_kernel_b1a8c32e_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_depth,
    wp::array_t<wp::float32> var_brightness,
    wp::array_t<wp::float32> var_depths,
    wp::array_t<wp::float32> var_brightnesses)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::float32* var_1;
        wp::float32 var_2;
        wp::float32 var_3;
        wp::float32* var_4;
        wp::float32 var_5;
        wp::float32 var_6;
        const wp::float32 var_7 = 0.0;
        wp::float32 var_8;
        bool var_9;
        const wp::float32 var_10 = 0.0;
        bool var_11;
        const wp::float32 var_12 = 1000000.0;
        bool var_13;
        wp::float32 var_14;
        wp::float32 var_15;
        const wp::float32 var_16 = -1.0;
        wp::float32 var_17;
        bool var_18;
        const wp::float32 var_19 = 0.0;
        bool var_20;
        const wp::float32 var_21 = 1000000.0;
        bool var_22;
        wp::float32 var_23;
        wp::float32 var_24;
        //---------
        // forward
        // def take_level_kernel(depth, brightness, depths, brightnesses):                        <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // d = depth[i]                                                                           <L 4>
        var_1 = wp::address(var_depth, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // b = brightness[i]                                                                      <L 5>
        var_4 = wp::address(var_brightness, var_0);
        var_6 = wp::load(var_4);
        var_5 = wp::copy(var_6);
        // good = float(0.0)                                                                      <L 6>
        var_8 = wp::float(var_7);
        // if d > 0.0 and d < 1000000.0:                                                          <L 7>
        var_11 = (var_2 > var_10);
        var_9 = var_11;
        if (var_9) {
            var_13 = (var_2 < var_12);
            var_9 = var_9 && var_13;
        }
        if (var_9) {
            // good = d                                                                           <L 8>
            var_14 = wp::copy(var_2);
        }
        var_15 = wp::where(var_9, var_14, var_8);
        // depths[i] = good                                                                       <L 9>
        wp::array_store(var_depths, var_0, var_15);
        // shown = float(NO_COLOR)                                                                <L 10>
        var_17 = wp::float(var_16);
        // if b >= 0.0 and b < 1000000.0:                                                         <L 11>
        var_20 = (var_5 >= var_19);
        var_18 = var_20;
        if (var_18) {
            var_22 = (var_5 < var_21);
            var_18 = var_18 && var_22;
        }
        if (var_18) {
            // shown = b                                                                          <L 12>
            var_23 = wp::copy(var_5);
        }
        var_24 = wp::where(var_18, var_23, var_17);
        // brightnesses[i] = shown                                                                <L 13>
        wp::array_store(var_brightnesses, var_0, var_24);
}


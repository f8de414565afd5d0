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


// /work/main/src/pointloom/kernels/arrays/block_keys.py:16
static CUDA_CALLABLE wp::vec_t<3, wp::int32> key_block_0(
    wp::int64 var_key)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 1;
    const wp::int32 var_1 = 21;
    wp::int32 var_2;
    const wp::int32 var_3 = 1;
    wp::int32 var_4;
    wp::int64 var_5;
    wp::int64 var_6;
    wp::int64 var_7;
    wp::int32 var_8;
    const wp::int32 var_9 = 1048576;
    wp::int32 var_10;
    wp::int64 var_11;
    wp::int64 var_12;
    wp::int64 var_13;
    wp::int32 var_14;
    wp::int32 var_15;
    wp::int64 var_16;
    wp::int32 var_17;
    wp::int32 var_18;
    wp::vec_t<3, wp::int32> var_19;
    //---------
    // forward
    // def key_block(key: int64) -> vec3i:                                                    <L 17>
    // low = int64((1 << 21) - 1)                                                             <L 18>
    var_2 = wp::lshift(var_0, var_1);
    var_4 = wp::sub(var_2, var_3);
    var_5 = wp::int64(var_4);
    // x = int(key >> int64(TWO_AXES)) - BIAS                                                 <L 19>
    var_6 = 42ll;
    var_7 = wp::rshift(var_key, var_6);
    var_8 = wp::int(var_7);
    var_10 = wp::sub(var_8, var_9);
    // y = int((key >> int64(AXIS_BITS)) & low) - BIAS                                        <L 20>
    var_11 = 21ll;
    var_12 = wp::rshift(var_key, var_11);
    var_13 = wp::bit_and(var_12, var_5);
    var_14 = wp::int(var_13);
    var_15 = wp::sub(var_14, var_9);
    // z = int(key & low) - BIAS                                                              <L 21>
    var_16 = wp::bit_and(var_key, var_5);
    var_17 = wp::int(var_16);
    var_18 = wp::sub(var_17, var_9);
    // return vec3i(x, y, z)                                                                  <L 22>
    var_19 = wp::vec_t<3, wp::int32>(var_10, var_15, var_18);
    return var_19;
}


// /work/main/src/pointloom/kernels/volumes/camera_rays.py:91
static CUDA_CALLABLE wp::vec_t<3, wp::float64> in_camera_0(
    wp::float64 var_x,
    wp::float64 var_y,
    wp::float64 var_z,
    wp::mat_t<3, 3, wp::float64> var_R)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    const wp::int32 var_1 = 0;
    wp::float64 var_2;
    wp::float64 var_3;
    const wp::int32 var_4 = 1;
    const wp::int32 var_5 = 0;
    wp::float64 var_6;
    wp::float64 var_7;
    wp::float64 var_8;
    const wp::int32 var_9 = 2;
    const wp::int32 var_10 = 0;
    wp::float64 var_11;
    wp::float64 var_12;
    wp::float64 var_13;
    const wp::int32 var_14 = 0;
    const wp::int32 var_15 = 1;
    wp::float64 var_16;
    wp::float64 var_17;
    const wp::int32 var_18 = 1;
    const wp::int32 var_19 = 1;
    wp::float64 var_20;
    wp::float64 var_21;
    wp::float64 var_22;
    const wp::int32 var_23 = 2;
    const wp::int32 var_24 = 1;
    wp::float64 var_25;
    wp::float64 var_26;
    wp::float64 var_27;
    const wp::int32 var_28 = 0;
    const wp::int32 var_29 = 2;
    wp::float64 var_30;
    wp::float64 var_31;
    const wp::int32 var_32 = 1;
    const wp::int32 var_33 = 2;
    wp::float64 var_34;
    wp::float64 var_35;
    wp::float64 var_36;
    const wp::int32 var_37 = 2;
    const wp::int32 var_38 = 2;
    wp::float64 var_39;
    wp::float64 var_40;
    wp::float64 var_41;
    wp::vec_t<3, wp::float64> var_42;
    //---------
    // forward
    // def in_camera(x: float64, y: float64, z: float64, R: mat33d) -> vec3d:                 <L 92>
    // return vec3d(                                                                          <L 93>
    // R[0, 0] * x + R[1, 0] * y + R[2, 0] * z,                                               <L 94>
    var_2 = wp::extract(var_R, var_0, var_1);
    var_3 = wp::mul(var_2, var_x);
    var_6 = wp::extract(var_R, var_4, var_5);
    var_7 = wp::mul(var_6, var_y);
    var_8 = wp::add(var_3, var_7);
    var_11 = wp::extract(var_R, var_9, var_10);
    var_12 = wp::mul(var_11, var_z);
    var_13 = wp::add(var_8, var_12);
    // R[0, 1] * x + R[1, 1] * y + R[2, 1] * z,                                               <L 95>
    var_16 = wp::extract(var_R, var_14, var_15);
    var_17 = wp::mul(var_16, var_x);
    var_20 = wp::extract(var_R, var_18, var_19);
    var_21 = wp::mul(var_20, var_y);
    var_22 = wp::add(var_17, var_21);
    var_25 = wp::extract(var_R, var_23, var_24);
    var_26 = wp::mul(var_25, var_z);
    var_27 = wp::add(var_22, var_26);
    // R[0, 2] * x + R[1, 2] * y + R[2, 2] * z,                                               <L 96>
    var_30 = wp::extract(var_R, var_28, var_29);
    var_31 = wp::mul(var_30, var_x);
    var_34 = wp::extract(var_R, var_32, var_33);
    var_35 = wp::mul(var_34, var_y);
    var_36 = wp::add(var_31, var_35);
    var_39 = wp::extract(var_R, var_37, var_38);
    var_40 = wp::mul(var_39, var_z);
    var_41 = wp::add(var_36, var_40);
    var_42 = wp::vec_t<3, wp::float64>(var_13, var_27, var_41);
    return var_42;
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


// <pointloom.kernels.volumes.camera_rays.tile_of>:1
static CUDA_CALLABLE wp::int32 tile_of_0(
    wp::float64 var_pixel,
    wp::int32 var_count)
{
    //---------
    // primal vars
    wp::float64 var_0;
    const wp::int32 var_1 = 8;
    wp::int32 var_2;
    const wp::int32 var_3 = 1;
    wp::int32 var_4;
    wp::float64 var_5;
    wp::float64 var_6;
    wp::float64 var_7;
    wp::int32 var_8;
    wp::int32 var_9;
    //---------
    // forward
    // def tile_of(pixel, count):                                                             <L 1>
    // inside = max(float64(0.0), min(pixel, float64(count * TILE - 1)))                      <L 2>
    var_0 = 0.0;
    var_2 = wp::mul(var_count, var_1);
    var_4 = wp::sub(var_2, var_3);
    var_5 = wp::float64(var_4);
    var_6 = wp::min(var_pixel, var_5);
    var_7 = wp::max(var_0, var_6);
    // return int(inside) // TILE                                                             <L 3>
    var_8 = wp::int(var_7);
    var_9 = wp::floordiv(var_8, var_1);
    return var_9;
}


// <pointloom.kernels.volumes.camera_rays.bound_box>:1
static CUDA_CALLABLE void bound_box_0(
    wp::vec_t<3, wp::float64> var_middle,
    wp::vec_t<3, wp::float64> var_half_size,
    wp::int32 var_rays__camera__width,
    wp::int32 var_rays__camera__height,
    wp::float64 var_rays__camera__fx,
    wp::float64 var_rays__camera__fy,
    wp::float64 var_rays__camera__cx,
    wp::float64 var_rays__camera__cy,
    wp::float32 var_rays__nearest,
    wp::float32 var_rays__farthest,
    wp::int32 var_rays__columns,
    wp::int32 var_rows,
    wp::array_t<wp::int32> var_nears,
    wp::array_t<wp::int32> var_fars)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 2;
    wp::float64 var_1;
    const wp::int32 var_2 = 2;
    wp::float64 var_3;
    wp::float64 var_4;
    wp::float64 var_5;
    wp::float64 var_6;
    const wp::int32 var_7 = 2;
    wp::float64 var_8;
    const wp::int32 var_9 = 2;
    wp::float64 var_10;
    wp::float64 var_11;
    bool var_12;
    bool var_13;
    wp::float64 var_14;
    bool var_15;
    const wp::int32 var_16 = 0;
    wp::float64 var_17;
    const wp::int32 var_18 = 0;
    wp::float64 var_19;
    wp::float64 var_20;
    wp::float64 var_21;
    const wp::int32 var_22 = 0;
    wp::float64 var_23;
    const wp::int32 var_24 = 0;
    wp::float64 var_25;
    wp::float64 var_26;
    wp::float64 var_27;
    wp::float64 var_28;
    const wp::int32 var_29 = 0;
    wp::float64 var_30;
    const wp::int32 var_31 = 0;
    wp::float64 var_32;
    wp::float64 var_33;
    wp::float64 var_34;
    const wp::int32 var_35 = 0;
    wp::float64 var_36;
    const wp::int32 var_37 = 0;
    wp::float64 var_38;
    wp::float64 var_39;
    wp::float64 var_40;
    wp::float64 var_41;
    const wp::int32 var_42 = 1;
    wp::float64 var_43;
    const wp::int32 var_44 = 1;
    wp::float64 var_45;
    wp::float64 var_46;
    wp::float64 var_47;
    const wp::int32 var_48 = 1;
    wp::float64 var_49;
    const wp::int32 var_50 = 1;
    wp::float64 var_51;
    wp::float64 var_52;
    wp::float64 var_53;
    wp::float64 var_54;
    const wp::int32 var_55 = 1;
    wp::float64 var_56;
    const wp::int32 var_57 = 1;
    wp::float64 var_58;
    wp::float64 var_59;
    wp::float64 var_60;
    const wp::int32 var_61 = 1;
    wp::float64 var_62;
    const wp::int32 var_63 = 1;
    wp::float64 var_64;
    wp::float64 var_65;
    wp::float64 var_66;
    wp::float64 var_67;
    wp::float64 var_68;
    wp::float64 var_69;
    wp::float64 var_70;
    wp::float64 var_71;
    wp::float64 var_72;
    wp::float64 var_73;
    wp::float64 var_74;
    wp::float64 var_75;
    wp::float64 var_76;
    wp::float64 var_77;
    wp::float64 var_78;
    wp::float64 var_79;
    wp::float64 var_80;
    wp::float64 var_81;
    wp::float64 var_82;
    wp::float64 var_83;
    bool var_84;
    wp::float64 var_85;
    bool var_86;
    wp::float64 var_87;
    bool var_88;
    bool var_89;
    wp::float64 var_90;
    bool var_91;
    wp::float64 var_92;
    bool var_93;
    bool var_94;
    bool var_95;
    bool var_96;
    wp::float32 var_97;
    wp::int32 var_98;
    wp::float32 var_99;
    wp::int32 var_100;
    wp::int32 var_101;
    wp::int32 var_102;
    const wp::int32 var_103 = 1;
    wp::int32 var_104;
    wp::range_t var_105;
    wp::int32 var_106;
    wp::int32 var_107;
    wp::int32 var_108;
    const wp::int32 var_109 = 1;
    wp::int32 var_110;
    wp::range_t var_111;
    wp::int32 var_112;
    wp::int32 var_113;
    wp::int32 var_114;
    wp::int32 var_115;
    wp::int32 var_116;
    wp::int32 var_117;
    wp::int32 var_118;
    //---------
    // forward
    // def bound_box(middle, half_size, rays__camera__width, rays__camera__height, rays__camera__fx, rays__camera__fy, rays__camera__cx, rays__camera__cy, rays__nearest, rays__farthest, rays__columns, rows, nears, fars):       <L 1>
    // near = max(middle[2] - half_size[2], float64(rays__nearest))                           <L 3>
    var_1 = wp::extract(var_middle, var_0);
    var_3 = wp::extract(var_half_size, var_2);
    var_4 = wp::sub(var_1, var_3);
    var_5 = wp::float64(var_rays__nearest);
    var_6 = wp::max(var_4, var_5);
    // far = middle[2] + half_size[2]                                                         <L 4>
    var_8 = wp::extract(var_middle, var_7);
    var_10 = wp::extract(var_half_size, var_9);
    var_11 = wp::add(var_8, var_10);
    // if far >= near and near <= float64(rays__farthest):                                    <L 5>
    var_13 = (var_11 >= var_6);
    var_12 = var_13;
    if (var_12) {
        var_14 = wp::float64(var_rays__farthest);
        var_15 = (var_6 <= var_14);
        var_12 = var_12 && var_15;
    }
    if (var_12) {
        // left = min((middle[0] - half_size[0]) / near, (middle[0] - half_size[0]) / far)       <L 6>
        var_17 = wp::extract(var_middle, var_16);
        var_19 = wp::extract(var_half_size, var_18);
        var_20 = wp::sub(var_17, var_19);
        var_21 = wp::div(var_20, var_6);
        var_23 = wp::extract(var_middle, var_22);
        var_25 = wp::extract(var_half_size, var_24);
        var_26 = wp::sub(var_23, var_25);
        var_27 = wp::div(var_26, var_11);
        var_28 = wp::min(var_21, var_27);
        // right = max((middle[0] + half_size[0]) / near, (middle[0] + half_size[0]) / far)       <L 7>
        var_30 = wp::extract(var_middle, var_29);
        var_32 = wp::extract(var_half_size, var_31);
        var_33 = wp::add(var_30, var_32);
        var_34 = wp::div(var_33, var_6);
        var_36 = wp::extract(var_middle, var_35);
        var_38 = wp::extract(var_half_size, var_37);
        var_39 = wp::add(var_36, var_38);
        var_40 = wp::div(var_39, var_11);
        var_41 = wp::max(var_34, var_40);
        // top = min((middle[1] - half_size[1]) / near, (middle[1] - half_size[1]) / far)       <L 8>
        var_43 = wp::extract(var_middle, var_42);
        var_45 = wp::extract(var_half_size, var_44);
        var_46 = wp::sub(var_43, var_45);
        var_47 = wp::div(var_46, var_6);
        var_49 = wp::extract(var_middle, var_48);
        var_51 = wp::extract(var_half_size, var_50);
        var_52 = wp::sub(var_49, var_51);
        var_53 = wp::div(var_52, var_11);
        var_54 = wp::min(var_47, var_53);
        // bottom = max((middle[1] + half_size[1]) / near, (middle[1] + half_size[1]) / far)       <L 9>
        var_56 = wp::extract(var_middle, var_55);
        var_58 = wp::extract(var_half_size, var_57);
        var_59 = wp::add(var_56, var_58);
        var_60 = wp::div(var_59, var_6);
        var_62 = wp::extract(var_middle, var_61);
        var_64 = wp::extract(var_half_size, var_63);
        var_65 = wp::add(var_62, var_64);
        var_66 = wp::div(var_65, var_11);
        var_67 = wp::max(var_60, var_66);
        // left = rays__camera__fx * left + rays__camera__cx - float64(MARGIN)                <L 10>
        var_68 = wp::mul(var_rays__camera__fx, var_28);
        var_69 = wp::add(var_68, var_rays__camera__cx);
        var_70 = 1.0;
        var_71 = wp::sub(var_69, var_70);
        // right = rays__camera__fx * right + rays__camera__cx + float64(MARGIN)              <L 11>
        var_72 = wp::mul(var_rays__camera__fx, var_41);
        var_73 = wp::add(var_72, var_rays__camera__cx);
        var_74 = wp::float64(var_70);
        var_75 = wp::add(var_73, var_74);
        // top = rays__camera__fy * top + rays__camera__cy - float64(MARGIN)                  <L 12>
        var_76 = wp::mul(var_rays__camera__fy, var_54);
        var_77 = wp::add(var_76, var_rays__camera__cy);
        var_78 = wp::float64(var_70);
        var_79 = wp::sub(var_77, var_78);
        // bottom = rays__camera__fy * bottom + rays__camera__cy + float64(MARGIN)            <L 13>
        var_80 = wp::mul(var_rays__camera__fy, var_67);
        var_81 = wp::add(var_80, var_rays__camera__cy);
        var_82 = wp::float64(var_70);
        var_83 = wp::add(var_81, var_82);
        // is_beside = right < float64(0.0) or left > float64(rays__camera__width)            <L 14>
        var_85 = 0.0;
        var_86 = (var_75 < var_85);
        var_84 = var_86;
        if (!var_84) {
            var_87 = wp::float64(var_rays__camera__width);
            var_88 = (var_71 > var_87);
            var_84 = var_84 || var_88;
        }
        // is_above = bottom < float64(0.0) or top > float64(rays__camera__height)            <L 15>
        var_90 = 0.0;
        var_91 = (var_83 < var_90);
        var_89 = var_91;
        if (!var_89) {
            var_92 = wp::float64(var_rays__camera__height);
            var_93 = (var_79 > var_92);
            var_89 = var_89 || var_93;
        }
        // if not is_beside and (not is_above):                                               <L 16>
        var_95 = wp::unot(var_84);
        var_94 = var_95;
        if (var_94) {
            var_96 = wp::unot(var_89);
            var_94 = var_94 && var_96;
        }
        if (var_94) {
            // near_bits = float_bits(float(near))                                            <L 17>
            var_97 = wp::float(var_6);
            var_98 = _float_bits_0(var_97);
            // far_bits = float_bits(float(far))                                              <L 18>
            var_99 = wp::float(var_11);
            var_100 = _float_bits_0(var_99);
            // for row in range(tile_of(top, rows), tile_of(bottom, rows) + 1):               <L 19>
            var_101 = tile_of_0(var_79, var_rows);
            var_102 = tile_of_0(var_83, var_rows);
            var_104 = wp::add(var_102, var_103);
            var_105 = wp::range(var_101, var_104);
            start_for_0:;
                if (iter_cmp(var_105) == 0) goto end_for_0;
                var_106 = wp::iter_next(var_105);
                // for column in range(tile_of(left, rays__columns), tile_of(right, rays__columns) + 1):       <L 20>
                var_107 = tile_of_0(var_71, var_rays__columns);
                var_108 = tile_of_0(var_75, var_rays__columns);
                var_110 = wp::add(var_108, var_109);
                var_111 = wp::range(var_107, var_110);
                start_for_2:;
                    if (iter_cmp(var_111) == 0) goto end_for_2;
                    var_112 = wp::iter_next(var_111);
                    // atomic_min(nears, row * rays__columns + column, near_bits)             <L 21>
                    var_113 = wp::mul(var_106, var_rays__columns);
                    var_114 = wp::add(var_113, var_112);
                    var_115 = wp::atomic_min(var_nears, var_114, var_98);
                    // atomic_max(fars, row * rays__columns + column, far_bits)               <L 22>
                    var_116 = wp::mul(var_106, var_rays__columns);
                    var_117 = wp::add(var_116, var_112);
                    var_118 = wp::atomic_max(var_fars, var_117, var_100);
                    goto start_for_2;
                end_for_2:;
                goto start_for_0;
            end_for_0:;
        }
    }
}


// /work/main/src/pointloom/kernels/arrays/block_keys.py:16
static CUDA_CALLABLE void adj_key_block_0(
    wp::int64 var_key,
    wp::int64 & adj_key,
    wp::vec_t<3, wp::int32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/volumes/camera_rays.py:91
static CUDA_CALLABLE void adj_in_camera_0(
    wp::float64 var_x,
    wp::float64 var_y,
    wp::float64 var_z,
    wp::mat_t<3, 3, wp::float64> var_R,
    wp::float64 & adj_x,
    wp::float64 & adj_y,
    wp::float64 & adj_z,
    wp::mat_t<3, 3, wp::float64> & adj_R,
    wp::vec_t<3, wp::float64> & adj_ret)
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


// <pointloom.kernels.volumes.camera_rays.tile_of>:1
static CUDA_CALLABLE void adj_tile_of_0(
    wp::float64 var_pixel,
    wp::int32 var_count,
    wp::float64 & adj_pixel,
    wp::int32 & adj_count,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.camera_rays.bound_box>:1
static CUDA_CALLABLE void adj_bound_box_0(
    wp::vec_t<3, wp::float64> var_middle,
    wp::vec_t<3, wp::float64> var_half_size,
    wp::int32 var_rays__camera__width,
    wp::int32 var_rays__camera__height,
    wp::float64 var_rays__camera__fx,
    wp::float64 var_rays__camera__fy,
    wp::float64 var_rays__camera__cx,
    wp::float64 var_rays__camera__cy,
    wp::float32 var_rays__nearest,
    wp::float32 var_rays__farthest,
    wp::int32 var_rays__columns,
    wp::int32 var_rows,
    wp::array_t<wp::int32> var_nears,
    wp::array_t<wp::int32> var_fars,
    wp::vec_t<3, wp::float64> & adj_middle,
    wp::vec_t<3, wp::float64> & adj_half_size,
    wp::int32 & adj_rays__camera__width,
    wp::int32 & adj_rays__camera__height,
    wp::float64 & adj_rays__camera__fx,
    wp::float64 & adj_rays__camera__fy,
    wp::float64 & adj_rays__camera__cx,
    wp::float64 & adj_rays__camera__cy,
    wp::float32 & adj_rays__nearest,
    wp::float32 & adj_rays__farthest,
    wp::int32 & adj_rays__columns,
    wp::int32 & adj_rows,
    wp::array_t<wp::int32> & adj_nears,
    wp::array_t<wp::int32> & adj_fars)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void bound_tiles_kernel_6133f0da_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::int32 var_rays__camera__width,
    wp::int32 var_rays__camera__height,
    wp::float64 var_rays__camera__fx,
    wp::float64 var_rays__camera__fy,
    wp::float64 var_rays__camera__cx,
    wp::float64 var_rays__camera__cy,
    wp::mat_t<3, 3, wp::float64> var_rays__R,
    wp::vec_t<3, wp::int32> var_rays__base,
    wp::vec_t<3, wp::float32> var_rays__start,
    wp::float32 var_rays__nearest,
    wp::float32 var_rays__farthest,
    wp::int32 var_rays__columns,
    wp::float64 var_blocks__voxel_size,
    wp::array_t<wp::int64> var_blocks__keys,
    wp::array_t<wp::int32> var_signs__parts,
    wp::int32 var_rows,
    wp::array_t<wp::int32> var_nears,
    wp::array_t<wp::int32> var_fars)
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
        wp::int64* var_6;
        wp::vec_t<3, wp::int32> var_7;
        wp::int64 var_8;
        const wp::int32 var_9 = 8;
        wp::vec_t<3, wp::int32> var_10;
        wp::vec_t<3, wp::int32> var_11;
        wp::float64 var_12;
        wp::float64 var_13;
        wp::float64 var_14;
        wp::mat_t<3, 3, wp::float64> var_15;
        const wp::int32 var_16 = 0;
        const wp::int32 var_17 = 0;
        wp::float64 var_18;
        wp::float64 var_19;
        const wp::int32 var_20 = 1;
        const wp::int32 var_21 = 0;
        wp::float64 var_22;
        wp::float64 var_23;
        wp::float64 var_24;
        const wp::int32 var_25 = 2;
        const wp::int32 var_26 = 0;
        wp::float64 var_27;
        wp::float64 var_28;
        wp::float64 var_29;
        wp::float64 var_30;
        const wp::int32 var_31 = 0;
        const wp::int32 var_32 = 1;
        wp::float64 var_33;
        wp::float64 var_34;
        const wp::int32 var_35 = 1;
        const wp::int32 var_36 = 1;
        wp::float64 var_37;
        wp::float64 var_38;
        wp::float64 var_39;
        const wp::int32 var_40 = 2;
        const wp::int32 var_41 = 1;
        wp::float64 var_42;
        wp::float64 var_43;
        wp::float64 var_44;
        wp::float64 var_45;
        const wp::int32 var_46 = 0;
        const wp::int32 var_47 = 2;
        wp::float64 var_48;
        wp::float64 var_49;
        const wp::int32 var_50 = 1;
        const wp::int32 var_51 = 2;
        wp::float64 var_52;
        wp::float64 var_53;
        wp::float64 var_54;
        const wp::int32 var_55 = 2;
        const wp::int32 var_56 = 2;
        wp::float64 var_57;
        wp::float64 var_58;
        wp::float64 var_59;
        wp::float64 var_60;
        wp::vec_t<3, wp::float64> var_61;
        const wp::int32 var_62 = 0;
        wp::int32 var_63;
        const wp::int32 var_64 = 1;
        wp::int32 var_65;
        const wp::int32 var_66 = 1;
        bool var_67;
        const wp::int32 var_68 = 0;
        wp::int32 var_69;
        const wp::int32 var_70 = 2;
        wp::int32 var_71;
        const wp::int32 var_72 = 4;
        wp::int32 var_73;
        wp::int32 var_74;
        wp::float64 var_75;
        wp::float64 var_76;
        wp::float64 var_77;
        const wp::int32 var_78 = 0;
        wp::float32 var_79;
        wp::float64 var_80;
        wp::float64 var_81;
        const wp::int32 var_82 = 1;
        wp::int32 var_83;
        const wp::int32 var_84 = 1;
        wp::int32 var_85;
        const wp::int32 var_86 = 1;
        wp::int32 var_87;
        wp::int32 var_88;
        wp::int32 var_89;
        wp::float64 var_90;
        wp::float64 var_91;
        wp::float64 var_92;
        const wp::int32 var_93 = 1;
        wp::float32 var_94;
        wp::float64 var_95;
        wp::float64 var_96;
        const wp::int32 var_97 = 2;
        wp::int32 var_98;
        const wp::int32 var_99 = 1;
        wp::int32 var_100;
        wp::int32 var_101;
        wp::int32 var_102;
        wp::float64 var_103;
        wp::float64 var_104;
        wp::float64 var_105;
        const wp::int32 var_106 = 2;
        wp::float32 var_107;
        wp::float64 var_108;
        wp::float64 var_109;
        wp::float64 var_110;
        wp::float64 var_111;
        wp::float64 var_112;
        wp::vec_t<3, wp::float64> var_113;
        const wp::int32 var_114 = 1;
        wp::int32 var_115;
        const wp::int32 var_116 = 1;
        wp::int32 var_117;
        const wp::int32 var_118 = 1;
        bool var_119;
        const wp::int32 var_120 = 0;
        wp::int32 var_121;
        const wp::int32 var_122 = 2;
        wp::int32 var_123;
        wp::int32 var_124;
        wp::int32 var_125;
        wp::float64 var_126;
        wp::float64 var_127;
        wp::float64 var_128;
        const wp::int32 var_129 = 0;
        wp::float32 var_130;
        wp::float64 var_131;
        wp::float64 var_132;
        const wp::int32 var_133 = 1;
        wp::int32 var_134;
        const wp::int32 var_135 = 1;
        wp::int32 var_136;
        const wp::int32 var_137 = 1;
        wp::int32 var_138;
        wp::int32 var_139;
        wp::int32 var_140;
        wp::float64 var_141;
        wp::float64 var_142;
        wp::float64 var_143;
        const wp::int32 var_144 = 1;
        wp::float32 var_145;
        wp::float64 var_146;
        wp::float64 var_147;
        const wp::int32 var_148 = 2;
        wp::int32 var_149;
        const wp::int32 var_150 = 1;
        wp::int32 var_151;
        wp::int32 var_152;
        wp::int32 var_153;
        wp::float64 var_154;
        wp::float64 var_155;
        wp::float64 var_156;
        const wp::int32 var_157 = 2;
        wp::float32 var_158;
        wp::float64 var_159;
        wp::float64 var_160;
        wp::float64 var_161;
        wp::float64 var_162;
        wp::float64 var_163;
        wp::vec_t<3, wp::float64> var_164;
        wp::float64 var_165;
        wp::float64 var_166;
        wp::float64 var_167;
        const wp::int32 var_168 = 2;
        wp::int32 var_169;
        const wp::int32 var_170 = 1;
        wp::int32 var_171;
        const wp::int32 var_172 = 1;
        bool var_173;
        const wp::int32 var_174 = 0;
        wp::int32 var_175;
        const wp::int32 var_176 = 2;
        wp::int32 var_177;
        wp::int32 var_178;
        wp::int32 var_179;
        wp::float64 var_180;
        wp::float64 var_181;
        wp::float64 var_182;
        const wp::int32 var_183 = 0;
        wp::float32 var_184;
        wp::float64 var_185;
        wp::float64 var_186;
        const wp::int32 var_187 = 1;
        wp::int32 var_188;
        const wp::int32 var_189 = 1;
        wp::int32 var_190;
        const wp::int32 var_191 = 1;
        wp::int32 var_192;
        wp::int32 var_193;
        wp::int32 var_194;
        wp::float64 var_195;
        wp::float64 var_196;
        wp::float64 var_197;
        const wp::int32 var_198 = 1;
        wp::float32 var_199;
        wp::float64 var_200;
        wp::float64 var_201;
        const wp::int32 var_202 = 2;
        wp::int32 var_203;
        const wp::int32 var_204 = 1;
        wp::int32 var_205;
        wp::int32 var_206;
        wp::int32 var_207;
        wp::float64 var_208;
        wp::float64 var_209;
        wp::float64 var_210;
        const wp::int32 var_211 = 2;
        wp::float32 var_212;
        wp::float64 var_213;
        wp::float64 var_214;
        wp::float64 var_215;
        wp::float64 var_216;
        wp::float64 var_217;
        wp::vec_t<3, wp::float64> var_218;
        wp::float64 var_219;
        wp::float64 var_220;
        wp::float64 var_221;
        const wp::int32 var_222 = 3;
        wp::int32 var_223;
        const wp::int32 var_224 = 1;
        wp::int32 var_225;
        const wp::int32 var_226 = 1;
        bool var_227;
        const wp::int32 var_228 = 0;
        wp::int32 var_229;
        const wp::int32 var_230 = 2;
        wp::int32 var_231;
        wp::int32 var_232;
        wp::int32 var_233;
        wp::float64 var_234;
        wp::float64 var_235;
        wp::float64 var_236;
        const wp::int32 var_237 = 0;
        wp::float32 var_238;
        wp::float64 var_239;
        wp::float64 var_240;
        const wp::int32 var_241 = 1;
        wp::int32 var_242;
        const wp::int32 var_243 = 1;
        wp::int32 var_244;
        const wp::int32 var_245 = 1;
        wp::int32 var_246;
        wp::int32 var_247;
        wp::int32 var_248;
        wp::float64 var_249;
        wp::float64 var_250;
        wp::float64 var_251;
        const wp::int32 var_252 = 1;
        wp::float32 var_253;
        wp::float64 var_254;
        wp::float64 var_255;
        const wp::int32 var_256 = 2;
        wp::int32 var_257;
        const wp::int32 var_258 = 1;
        wp::int32 var_259;
        wp::int32 var_260;
        wp::int32 var_261;
        wp::float64 var_262;
        wp::float64 var_263;
        wp::float64 var_264;
        const wp::int32 var_265 = 2;
        wp::float32 var_266;
        wp::float64 var_267;
        wp::float64 var_268;
        wp::float64 var_269;
        wp::float64 var_270;
        wp::float64 var_271;
        wp::vec_t<3, wp::float64> var_272;
        wp::float64 var_273;
        wp::float64 var_274;
        wp::float64 var_275;
        const wp::int32 var_276 = 4;
        wp::int32 var_277;
        const wp::int32 var_278 = 1;
        wp::int32 var_279;
        const wp::int32 var_280 = 1;
        bool var_281;
        const wp::int32 var_282 = 0;
        wp::int32 var_283;
        const wp::int32 var_284 = 2;
        wp::int32 var_285;
        wp::int32 var_286;
        wp::int32 var_287;
        wp::float64 var_288;
        wp::float64 var_289;
        wp::float64 var_290;
        const wp::int32 var_291 = 0;
        wp::float32 var_292;
        wp::float64 var_293;
        wp::float64 var_294;
        const wp::int32 var_295 = 1;
        wp::int32 var_296;
        const wp::int32 var_297 = 1;
        wp::int32 var_298;
        const wp::int32 var_299 = 1;
        wp::int32 var_300;
        wp::int32 var_301;
        wp::int32 var_302;
        wp::float64 var_303;
        wp::float64 var_304;
        wp::float64 var_305;
        const wp::int32 var_306 = 1;
        wp::float32 var_307;
        wp::float64 var_308;
        wp::float64 var_309;
        const wp::int32 var_310 = 2;
        wp::int32 var_311;
        const wp::int32 var_312 = 1;
        wp::int32 var_313;
        wp::int32 var_314;
        wp::int32 var_315;
        wp::float64 var_316;
        wp::float64 var_317;
        wp::float64 var_318;
        const wp::int32 var_319 = 2;
        wp::float32 var_320;
        wp::float64 var_321;
        wp::float64 var_322;
        wp::float64 var_323;
        wp::float64 var_324;
        wp::float64 var_325;
        wp::vec_t<3, wp::float64> var_326;
        wp::float64 var_327;
        wp::float64 var_328;
        wp::float64 var_329;
        const wp::int32 var_330 = 5;
        wp::int32 var_331;
        const wp::int32 var_332 = 1;
        wp::int32 var_333;
        const wp::int32 var_334 = 1;
        bool var_335;
        const wp::int32 var_336 = 0;
        wp::int32 var_337;
        const wp::int32 var_338 = 2;
        wp::int32 var_339;
        wp::int32 var_340;
        wp::int32 var_341;
        wp::float64 var_342;
        wp::float64 var_343;
        wp::float64 var_344;
        const wp::int32 var_345 = 0;
        wp::float32 var_346;
        wp::float64 var_347;
        wp::float64 var_348;
        const wp::int32 var_349 = 1;
        wp::int32 var_350;
        const wp::int32 var_351 = 1;
        wp::int32 var_352;
        const wp::int32 var_353 = 1;
        wp::int32 var_354;
        wp::int32 var_355;
        wp::int32 var_356;
        wp::float64 var_357;
        wp::float64 var_358;
        wp::float64 var_359;
        const wp::int32 var_360 = 1;
        wp::float32 var_361;
        wp::float64 var_362;
        wp::float64 var_363;
        const wp::int32 var_364 = 2;
        wp::int32 var_365;
        const wp::int32 var_366 = 1;
        wp::int32 var_367;
        wp::int32 var_368;
        wp::int32 var_369;
        wp::float64 var_370;
        wp::float64 var_371;
        wp::float64 var_372;
        const wp::int32 var_373 = 2;
        wp::float32 var_374;
        wp::float64 var_375;
        wp::float64 var_376;
        wp::float64 var_377;
        wp::float64 var_378;
        wp::float64 var_379;
        wp::vec_t<3, wp::float64> var_380;
        wp::float64 var_381;
        wp::float64 var_382;
        wp::float64 var_383;
        const wp::int32 var_384 = 6;
        wp::int32 var_385;
        const wp::int32 var_386 = 1;
        wp::int32 var_387;
        const wp::int32 var_388 = 1;
        bool var_389;
        const wp::int32 var_390 = 0;
        wp::int32 var_391;
        const wp::int32 var_392 = 2;
        wp::int32 var_393;
        wp::int32 var_394;
        wp::int32 var_395;
        wp::float64 var_396;
        wp::float64 var_397;
        wp::float64 var_398;
        const wp::int32 var_399 = 0;
        wp::float32 var_400;
        wp::float64 var_401;
        wp::float64 var_402;
        const wp::int32 var_403 = 1;
        wp::int32 var_404;
        const wp::int32 var_405 = 1;
        wp::int32 var_406;
        const wp::int32 var_407 = 1;
        wp::int32 var_408;
        wp::int32 var_409;
        wp::int32 var_410;
        wp::float64 var_411;
        wp::float64 var_412;
        wp::float64 var_413;
        const wp::int32 var_414 = 1;
        wp::float32 var_415;
        wp::float64 var_416;
        wp::float64 var_417;
        const wp::int32 var_418 = 2;
        wp::int32 var_419;
        const wp::int32 var_420 = 1;
        wp::int32 var_421;
        wp::int32 var_422;
        wp::int32 var_423;
        wp::float64 var_424;
        wp::float64 var_425;
        wp::float64 var_426;
        const wp::int32 var_427 = 2;
        wp::float32 var_428;
        wp::float64 var_429;
        wp::float64 var_430;
        wp::float64 var_431;
        wp::float64 var_432;
        wp::float64 var_433;
        wp::vec_t<3, wp::float64> var_434;
        wp::float64 var_435;
        wp::float64 var_436;
        wp::float64 var_437;
        const wp::int32 var_438 = 7;
        wp::int32 var_439;
        const wp::int32 var_440 = 1;
        wp::int32 var_441;
        const wp::int32 var_442 = 1;
        bool var_443;
        const wp::int32 var_444 = 0;
        wp::int32 var_445;
        const wp::int32 var_446 = 2;
        wp::int32 var_447;
        wp::int32 var_448;
        wp::int32 var_449;
        wp::float64 var_450;
        wp::float64 var_451;
        wp::float64 var_452;
        const wp::int32 var_453 = 0;
        wp::float32 var_454;
        wp::float64 var_455;
        wp::float64 var_456;
        const wp::int32 var_457 = 1;
        wp::int32 var_458;
        const wp::int32 var_459 = 1;
        wp::int32 var_460;
        const wp::int32 var_461 = 1;
        wp::int32 var_462;
        wp::int32 var_463;
        wp::int32 var_464;
        wp::float64 var_465;
        wp::float64 var_466;
        wp::float64 var_467;
        const wp::int32 var_468 = 1;
        wp::float32 var_469;
        wp::float64 var_470;
        wp::float64 var_471;
        const wp::int32 var_472 = 2;
        wp::int32 var_473;
        const wp::int32 var_474 = 1;
        wp::int32 var_475;
        wp::int32 var_476;
        wp::int32 var_477;
        wp::float64 var_478;
        wp::float64 var_479;
        wp::float64 var_480;
        const wp::int32 var_481 = 2;
        wp::float32 var_482;
        wp::float64 var_483;
        wp::float64 var_484;
        wp::float64 var_485;
        wp::float64 var_486;
        wp::float64 var_487;
        wp::vec_t<3, wp::float64> var_488;
        wp::float64 var_489;
        wp::float64 var_490;
        wp::float64 var_491;
        //---------
        // forward
        // def bound_tiles_kernel(rays__camera__width, rays__camera__height, rays__camera__fx, rays__camera__fy, rays__camera__cx, rays__camera__cy, rays__R, rays__base, rays__start, rays__nearest, rays__farthest, rays__columns, blocks__voxel_size, blocks__keys, signs__parts, rows, nears, fars):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // parts = signs__parts[i]                                                                <L 4>
        var_1 = wp::address(var_signs__parts, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // if parts != 0:                                                                         <L 5>
        var_5 = (var_2 != var_4);
        if (var_5) {
            // low = key_block(blocks__keys[i]) * SIDE - rays__base                               <L 6>
            var_6 = wp::address(var_blocks__keys, var_0);
            var_8 = wp::load(var_6);
            var_7 = key_block_0(var_8);
            var_10 = wp::mul(var_7, var_9);
            var_11 = wp::sub(var_10, var_rays__base);
            // size = blocks__voxel_size                                                          <L 7>
            var_12 = wp::copy(var_blocks__voxel_size);
            // half = size * float64(HALF_PART)                                                   <L 8>
            var_13 = 2.0;
            var_14 = wp::mul(var_12, var_13);
            // R = rays__R                                                                        <L 9>
            var_15 = wp::copy(var_rays__R);
            // half_size = vec3d(half * (abs(R[0, 0]) + abs(R[1, 0]) + abs(R[2, 0])), half * (abs(R[0, 1]) + abs(R[1, 1]) + abs(R[2, 1])), half * (abs(R[0, 2]) + abs(R[1, 2]) + abs(R[2, 2])))       <L 10>
            var_18 = wp::extract(var_15, var_16, var_17);
            var_19 = wp::abs(var_18);
            var_22 = wp::extract(var_15, var_20, var_21);
            var_23 = wp::abs(var_22);
            var_24 = wp::add(var_19, var_23);
            var_27 = wp::extract(var_15, var_25, var_26);
            var_28 = wp::abs(var_27);
            var_29 = wp::add(var_24, var_28);
            var_30 = wp::mul(var_14, var_29);
            var_33 = wp::extract(var_15, var_31, var_32);
            var_34 = wp::abs(var_33);
            var_37 = wp::extract(var_15, var_35, var_36);
            var_38 = wp::abs(var_37);
            var_39 = wp::add(var_34, var_38);
            var_42 = wp::extract(var_15, var_40, var_41);
            var_43 = wp::abs(var_42);
            var_44 = wp::add(var_39, var_43);
            var_45 = wp::mul(var_14, var_44);
            var_48 = wp::extract(var_15, var_46, var_47);
            var_49 = wp::abs(var_48);
            var_52 = wp::extract(var_15, var_50, var_51);
            var_53 = wp::abs(var_52);
            var_54 = wp::add(var_49, var_53);
            var_57 = wp::extract(var_15, var_55, var_56);
            var_58 = wp::abs(var_57);
            var_59 = wp::add(var_54, var_58);
            var_60 = wp::mul(var_14, var_59);
            var_61 = wp::vec_t<3, wp::float64>(var_30, var_45, var_60);
            // for part in range(PARTS):                                                          <L 11>
            // if parts >> part & 1 == 1:                                                         <L 12>
            var_63 = wp::rshift(var_2, var_62);
            var_65 = wp::bit_and(var_63, var_64);
            var_67 = (var_65 == var_66);
            if (var_67) {
                // x = float64(low[0] + (part >> 2) * HALF) + float64(HALF_PART) - float64(rays__start[0])       <L 13>
                var_69 = wp::extract(var_11, var_68);
                var_71 = wp::rshift(var_62, var_70);
                var_73 = wp::mul(var_71, var_72);
                var_74 = wp::add(var_69, var_73);
                var_75 = wp::float64(var_74);
                var_76 = wp::float64(var_13);
                var_77 = wp::add(var_75, var_76);
                var_79 = wp::extract(var_rays__start, var_78);
                var_80 = wp::float64(var_79);
                var_81 = wp::sub(var_77, var_80);
                // y = float64(low[1] + (part >> 1 & 1) * HALF) + float64(HALF_PART) - float64(rays__start[1])       <L 14>
                var_83 = wp::extract(var_11, var_82);
                var_85 = wp::rshift(var_62, var_84);
                var_87 = wp::bit_and(var_85, var_86);
                var_88 = wp::mul(var_87, var_72);
                var_89 = wp::add(var_83, var_88);
                var_90 = wp::float64(var_89);
                var_91 = wp::float64(var_13);
                var_92 = wp::add(var_90, var_91);
                var_94 = wp::extract(var_rays__start, var_93);
                var_95 = wp::float64(var_94);
                var_96 = wp::sub(var_92, var_95);
                // z = float64(low[2] + (part & 1) * HALF) + float64(HALF_PART) - float64(rays__start[2])       <L 15>
                var_98 = wp::extract(var_11, var_97);
                var_100 = wp::bit_and(var_62, var_99);
                var_101 = wp::mul(var_100, var_72);
                var_102 = wp::add(var_98, var_101);
                var_103 = wp::float64(var_102);
                var_104 = wp::float64(var_13);
                var_105 = wp::add(var_103, var_104);
                var_107 = wp::extract(var_rays__start, var_106);
                var_108 = wp::float64(var_107);
                var_109 = wp::sub(var_105, var_108);
                // bound_box(in_camera(x * size, y * size, z * size, R), half_size, rays__camera__width, rays__camera__height, rays__camera__fx, rays__camera__fy, rays__camera__cx, rays__camera__cy, rays__nearest, rays__farthest, rays__columns, rows, nears, fars)       <L 16>
                var_110 = wp::mul(var_81, var_12);
                var_111 = wp::mul(var_96, var_12);
                var_112 = wp::mul(var_109, var_12);
                var_113 = in_camera_0(var_110, var_111, var_112, var_15);
                bound_box_0(var_113, var_61, var_rays__camera__width, var_rays__camera__height, var_rays__camera__fx, var_rays__camera__fy, var_rays__camera__cx, var_rays__camera__cy, var_rays__nearest, var_rays__farthest, var_rays__columns, var_rows, var_nears, var_fars);
            }
            // if parts >> part & 1 == 1:                                                         <L 12>
            var_115 = wp::rshift(var_2, var_114);
            var_117 = wp::bit_and(var_115, var_116);
            var_119 = (var_117 == var_118);
            if (var_119) {
                // x = float64(low[0] + (part >> 2) * HALF) + float64(HALF_PART) - float64(rays__start[0])       <L 13>
                var_121 = wp::extract(var_11, var_120);
                var_123 = wp::rshift(var_114, var_122);
                var_124 = wp::mul(var_123, var_72);
                var_125 = wp::add(var_121, var_124);
                var_126 = wp::float64(var_125);
                var_127 = wp::float64(var_13);
                var_128 = wp::add(var_126, var_127);
                var_130 = wp::extract(var_rays__start, var_129);
                var_131 = wp::float64(var_130);
                var_132 = wp::sub(var_128, var_131);
                // y = float64(low[1] + (part >> 1 & 1) * HALF) + float64(HALF_PART) - float64(rays__start[1])       <L 14>
                var_134 = wp::extract(var_11, var_133);
                var_136 = wp::rshift(var_114, var_135);
                var_138 = wp::bit_and(var_136, var_137);
                var_139 = wp::mul(var_138, var_72);
                var_140 = wp::add(var_134, var_139);
                var_141 = wp::float64(var_140);
                var_142 = wp::float64(var_13);
                var_143 = wp::add(var_141, var_142);
                var_145 = wp::extract(var_rays__start, var_144);
                var_146 = wp::float64(var_145);
                var_147 = wp::sub(var_143, var_146);
                // z = float64(low[2] + (part & 1) * HALF) + float64(HALF_PART) - float64(rays__start[2])       <L 15>
                var_149 = wp::extract(var_11, var_148);
                var_151 = wp::bit_and(var_114, var_150);
                var_152 = wp::mul(var_151, var_72);
                var_153 = wp::add(var_149, var_152);
                var_154 = wp::float64(var_153);
                var_155 = wp::float64(var_13);
                var_156 = wp::add(var_154, var_155);
                var_158 = wp::extract(var_rays__start, var_157);
                var_159 = wp::float64(var_158);
                var_160 = wp::sub(var_156, var_159);
                // bound_box(in_camera(x * size, y * size, z * size, R), half_size, rays__camera__width, rays__camera__height, rays__camera__fx, rays__camera__fy, rays__camera__cx, rays__camera__cy, rays__nearest, rays__farthest, rays__columns, rows, nears, fars)       <L 16>
                var_161 = wp::mul(var_132, var_12);
                var_162 = wp::mul(var_147, var_12);
                var_163 = wp::mul(var_160, var_12);
                var_164 = in_camera_0(var_161, var_162, var_163, var_15);
                bound_box_0(var_164, var_61, var_rays__camera__width, var_rays__camera__height, var_rays__camera__fx, var_rays__camera__fy, var_rays__camera__cx, var_rays__camera__cy, var_rays__nearest, var_rays__farthest, var_rays__columns, var_rows, var_nears, var_fars);
            }
            var_165 = wp::where(var_119, var_132, var_81);
            var_166 = wp::where(var_119, var_147, var_96);
            var_167 = wp::where(var_119, var_160, var_109);
            // if parts >> part & 1 == 1:                                                         <L 12>
            var_169 = wp::rshift(var_2, var_168);
            var_171 = wp::bit_and(var_169, var_170);
            var_173 = (var_171 == var_172);
            if (var_173) {
                // x = float64(low[0] + (part >> 2) * HALF) + float64(HALF_PART) - float64(rays__start[0])       <L 13>
                var_175 = wp::extract(var_11, var_174);
                var_177 = wp::rshift(var_168, var_176);
                var_178 = wp::mul(var_177, var_72);
                var_179 = wp::add(var_175, var_178);
                var_180 = wp::float64(var_179);
                var_181 = wp::float64(var_13);
                var_182 = wp::add(var_180, var_181);
                var_184 = wp::extract(var_rays__start, var_183);
                var_185 = wp::float64(var_184);
                var_186 = wp::sub(var_182, var_185);
                // y = float64(low[1] + (part >> 1 & 1) * HALF) + float64(HALF_PART) - float64(rays__start[1])       <L 14>
                var_188 = wp::extract(var_11, var_187);
                var_190 = wp::rshift(var_168, var_189);
                var_192 = wp::bit_and(var_190, var_191);
                var_193 = wp::mul(var_192, var_72);
                var_194 = wp::add(var_188, var_193);
                var_195 = wp::float64(var_194);
                var_196 = wp::float64(var_13);
                var_197 = wp::add(var_195, var_196);
                var_199 = wp::extract(var_rays__start, var_198);
                var_200 = wp::float64(var_199);
                var_201 = wp::sub(var_197, var_200);
                // z = float64(low[2] + (part & 1) * HALF) + float64(HALF_PART) - float64(rays__start[2])       <L 15>
                var_203 = wp::extract(var_11, var_202);
                var_205 = wp::bit_and(var_168, var_204);
                var_206 = wp::mul(var_205, var_72);
                var_207 = wp::add(var_203, var_206);
                var_208 = wp::float64(var_207);
                var_209 = wp::float64(var_13);
                var_210 = wp::add(var_208, var_209);
                var_212 = wp::extract(var_rays__start, var_211);
                var_213 = wp::float64(var_212);
                var_214 = wp::sub(var_210, var_213);
                // bound_box(in_camera(x * size, y * size, z * size, R), half_size, rays__camera__width, rays__camera__height, rays__camera__fx, rays__camera__fy, rays__camera__cx, rays__camera__cy, rays__nearest, rays__farthest, rays__columns, rows, nears, fars)       <L 16>
                var_215 = wp::mul(var_186, var_12);
                var_216 = wp::mul(var_201, var_12);
                var_217 = wp::mul(var_214, var_12);
                var_218 = in_camera_0(var_215, var_216, var_217, var_15);
                bound_box_0(var_218, var_61, var_rays__camera__width, var_rays__camera__height, var_rays__camera__fx, var_rays__camera__fy, var_rays__camera__cx, var_rays__camera__cy, var_rays__nearest, var_rays__farthest, var_rays__columns, var_rows, var_nears, var_fars);
            }
            var_219 = wp::where(var_173, var_186, var_165);
            var_220 = wp::where(var_173, var_201, var_166);
            var_221 = wp::where(var_173, var_214, var_167);
            // if parts >> part & 1 == 1:                                                         <L 12>
            var_223 = wp::rshift(var_2, var_222);
            var_225 = wp::bit_and(var_223, var_224);
            var_227 = (var_225 == var_226);
            if (var_227) {
                // x = float64(low[0] + (part >> 2) * HALF) + float64(HALF_PART) - float64(rays__start[0])       <L 13>
                var_229 = wp::extract(var_11, var_228);
                var_231 = wp::rshift(var_222, var_230);
                var_232 = wp::mul(var_231, var_72);
                var_233 = wp::add(var_229, var_232);
                var_234 = wp::float64(var_233);
                var_235 = wp::float64(var_13);
                var_236 = wp::add(var_234, var_235);
                var_238 = wp::extract(var_rays__start, var_237);
                var_239 = wp::float64(var_238);
                var_240 = wp::sub(var_236, var_239);
                // y = float64(low[1] + (part >> 1 & 1) * HALF) + float64(HALF_PART) - float64(rays__start[1])       <L 14>
                var_242 = wp::extract(var_11, var_241);
                var_244 = wp::rshift(var_222, var_243);
                var_246 = wp::bit_and(var_244, var_245);
                var_247 = wp::mul(var_246, var_72);
                var_248 = wp::add(var_242, var_247);
                var_249 = wp::float64(var_248);
                var_250 = wp::float64(var_13);
                var_251 = wp::add(var_249, var_250);
                var_253 = wp::extract(var_rays__start, var_252);
                var_254 = wp::float64(var_253);
                var_255 = wp::sub(var_251, var_254);
                // z = float64(low[2] + (part & 1) * HALF) + float64(HALF_PART) - float64(rays__start[2])       <L 15>
                var_257 = wp::extract(var_11, var_256);
                var_259 = wp::bit_and(var_222, var_258);
                var_260 = wp::mul(var_259, var_72);
                var_261 = wp::add(var_257, var_260);
                var_262 = wp::float64(var_261);
                var_263 = wp::float64(var_13);
                var_264 = wp::add(var_262, var_263);
                var_266 = wp::extract(var_rays__start, var_265);
                var_267 = wp::float64(var_266);
                var_268 = wp::sub(var_264, var_267);
                // bound_box(in_camera(x * size, y * size, z * size, R), half_size, rays__camera__width, rays__camera__height, rays__camera__fx, rays__camera__fy, rays__camera__cx, rays__camera__cy, rays__nearest, rays__farthest, rays__columns, rows, nears, fars)       <L 16>
                var_269 = wp::mul(var_240, var_12);
                var_270 = wp::mul(var_255, var_12);
                var_271 = wp::mul(var_268, var_12);
                var_272 = in_camera_0(var_269, var_270, var_271, var_15);
                bound_box_0(var_272, var_61, var_rays__camera__width, var_rays__camera__height, var_rays__camera__fx, var_rays__camera__fy, var_rays__camera__cx, var_rays__camera__cy, var_rays__nearest, var_rays__farthest, var_rays__columns, var_rows, var_nears, var_fars);
            }
            var_273 = wp::where(var_227, var_240, var_219);
            var_274 = wp::where(var_227, var_255, var_220);
            var_275 = wp::where(var_227, var_268, var_221);
            // if parts >> part & 1 == 1:                                                         <L 12>
            var_277 = wp::rshift(var_2, var_276);
            var_279 = wp::bit_and(var_277, var_278);
            var_281 = (var_279 == var_280);
            if (var_281) {
                // x = float64(low[0] + (part >> 2) * HALF) + float64(HALF_PART) - float64(rays__start[0])       <L 13>
                var_283 = wp::extract(var_11, var_282);
                var_285 = wp::rshift(var_276, var_284);
                var_286 = wp::mul(var_285, var_72);
                var_287 = wp::add(var_283, var_286);
                var_288 = wp::float64(var_287);
                var_289 = wp::float64(var_13);
                var_290 = wp::add(var_288, var_289);
                var_292 = wp::extract(var_rays__start, var_291);
                var_293 = wp::float64(var_292);
                var_294 = wp::sub(var_290, var_293);
                // y = float64(low[1] + (part >> 1 & 1) * HALF) + float64(HALF_PART) - float64(rays__start[1])       <L 14>
                var_296 = wp::extract(var_11, var_295);
                var_298 = wp::rshift(var_276, var_297);
                var_300 = wp::bit_and(var_298, var_299);
                var_301 = wp::mul(var_300, var_72);
                var_302 = wp::add(var_296, var_301);
                var_303 = wp::float64(var_302);
                var_304 = wp::float64(var_13);
                var_305 = wp::add(var_303, var_304);
                var_307 = wp::extract(var_rays__start, var_306);
                var_308 = wp::float64(var_307);
                var_309 = wp::sub(var_305, var_308);
                // z = float64(low[2] + (part & 1) * HALF) + float64(HALF_PART) - float64(rays__start[2])       <L 15>
                var_311 = wp::extract(var_11, var_310);
                var_313 = wp::bit_and(var_276, var_312);
                var_314 = wp::mul(var_313, var_72);
                var_315 = wp::add(var_311, var_314);
                var_316 = wp::float64(var_315);
                var_317 = wp::float64(var_13);
                var_318 = wp::add(var_316, var_317);
                var_320 = wp::extract(var_rays__start, var_319);
                var_321 = wp::float64(var_320);
                var_322 = wp::sub(var_318, var_321);
                // bound_box(in_camera(x * size, y * size, z * size, R), half_size, rays__camera__width, rays__camera__height, rays__camera__fx, rays__camera__fy, rays__camera__cx, rays__camera__cy, rays__nearest, rays__farthest, rays__columns, rows, nears, fars)       <L 16>
                var_323 = wp::mul(var_294, var_12);
                var_324 = wp::mul(var_309, var_12);
                var_325 = wp::mul(var_322, var_12);
                var_326 = in_camera_0(var_323, var_324, var_325, var_15);
                bound_box_0(var_326, var_61, var_rays__camera__width, var_rays__camera__height, var_rays__camera__fx, var_rays__camera__fy, var_rays__camera__cx, var_rays__camera__cy, var_rays__nearest, var_rays__farthest, var_rays__columns, var_rows, var_nears, var_fars);
            }
            var_327 = wp::where(var_281, var_294, var_273);
            var_328 = wp::where(var_281, var_309, var_274);
            var_329 = wp::where(var_281, var_322, var_275);
            // if parts >> part & 1 == 1:                                                         <L 12>
            var_331 = wp::rshift(var_2, var_330);
            var_333 = wp::bit_and(var_331, var_332);
            var_335 = (var_333 == var_334);
            if (var_335) {
                // x = float64(low[0] + (part >> 2) * HALF) + float64(HALF_PART) - float64(rays__start[0])       <L 13>
                var_337 = wp::extract(var_11, var_336);
                var_339 = wp::rshift(var_330, var_338);
                var_340 = wp::mul(var_339, var_72);
                var_341 = wp::add(var_337, var_340);
                var_342 = wp::float64(var_341);
                var_343 = wp::float64(var_13);
                var_344 = wp::add(var_342, var_343);
                var_346 = wp::extract(var_rays__start, var_345);
                var_347 = wp::float64(var_346);
                var_348 = wp::sub(var_344, var_347);
                // y = float64(low[1] + (part >> 1 & 1) * HALF) + float64(HALF_PART) - float64(rays__start[1])       <L 14>
                var_350 = wp::extract(var_11, var_349);
                var_352 = wp::rshift(var_330, var_351);
                var_354 = wp::bit_and(var_352, var_353);
                var_355 = wp::mul(var_354, var_72);
                var_356 = wp::add(var_350, var_355);
                var_357 = wp::float64(var_356);
                var_358 = wp::float64(var_13);
                var_359 = wp::add(var_357, var_358);
                var_361 = wp::extract(var_rays__start, var_360);
                var_362 = wp::float64(var_361);
                var_363 = wp::sub(var_359, var_362);
                // z = float64(low[2] + (part & 1) * HALF) + float64(HALF_PART) - float64(rays__start[2])       <L 15>
                var_365 = wp::extract(var_11, var_364);
                var_367 = wp::bit_and(var_330, var_366);
                var_368 = wp::mul(var_367, var_72);
                var_369 = wp::add(var_365, var_368);
                var_370 = wp::float64(var_369);
                var_371 = wp::float64(var_13);
                var_372 = wp::add(var_370, var_371);
                var_374 = wp::extract(var_rays__start, var_373);
                var_375 = wp::float64(var_374);
                var_376 = wp::sub(var_372, var_375);
                // bound_box(in_camera(x * size, y * size, z * size, R), half_size, rays__camera__width, rays__camera__height, rays__camera__fx, rays__camera__fy, rays__camera__cx, rays__camera__cy, rays__nearest, rays__farthest, rays__columns, rows, nears, fars)       <L 16>
                var_377 = wp::mul(var_348, var_12);
                var_378 = wp::mul(var_363, var_12);
                var_379 = wp::mul(var_376, var_12);
                var_380 = in_camera_0(var_377, var_378, var_379, var_15);
                bound_box_0(var_380, var_61, var_rays__camera__width, var_rays__camera__height, var_rays__camera__fx, var_rays__camera__fy, var_rays__camera__cx, var_rays__camera__cy, var_rays__nearest, var_rays__farthest, var_rays__columns, var_rows, var_nears, var_fars);
            }
            var_381 = wp::where(var_335, var_348, var_327);
            var_382 = wp::where(var_335, var_363, var_328);
            var_383 = wp::where(var_335, var_376, var_329);
            // if parts >> part & 1 == 1:                                                         <L 12>
            var_385 = wp::rshift(var_2, var_384);
            var_387 = wp::bit_and(var_385, var_386);
            var_389 = (var_387 == var_388);
            if (var_389) {
                // x = float64(low[0] + (part >> 2) * HALF) + float64(HALF_PART) - float64(rays__start[0])       <L 13>
                var_391 = wp::extract(var_11, var_390);
                var_393 = wp::rshift(var_384, var_392);
                var_394 = wp::mul(var_393, var_72);
                var_395 = wp::add(var_391, var_394);
                var_396 = wp::float64(var_395);
                var_397 = wp::float64(var_13);
                var_398 = wp::add(var_396, var_397);
                var_400 = wp::extract(var_rays__start, var_399);
                var_401 = wp::float64(var_400);
                var_402 = wp::sub(var_398, var_401);
                // y = float64(low[1] + (part >> 1 & 1) * HALF) + float64(HALF_PART) - float64(rays__start[1])       <L 14>
                var_404 = wp::extract(var_11, var_403);
                var_406 = wp::rshift(var_384, var_405);
                var_408 = wp::bit_and(var_406, var_407);
                var_409 = wp::mul(var_408, var_72);
                var_410 = wp::add(var_404, var_409);
                var_411 = wp::float64(var_410);
                var_412 = wp::float64(var_13);
                var_413 = wp::add(var_411, var_412);
                var_415 = wp::extract(var_rays__start, var_414);
                var_416 = wp::float64(var_415);
                var_417 = wp::sub(var_413, var_416);
                // z = float64(low[2] + (part & 1) * HALF) + float64(HALF_PART) - float64(rays__start[2])       <L 15>
                var_419 = wp::extract(var_11, var_418);
                var_421 = wp::bit_and(var_384, var_420);
                var_422 = wp::mul(var_421, var_72);
                var_423 = wp::add(var_419, var_422);
                var_424 = wp::float64(var_423);
                var_425 = wp::float64(var_13);
                var_426 = wp::add(var_424, var_425);
                var_428 = wp::extract(var_rays__start, var_427);
                var_429 = wp::float64(var_428);
                var_430 = wp::sub(var_426, var_429);
                // bound_box(in_camera(x * size, y * size, z * size, R), half_size, rays__camera__width, rays__camera__height, rays__camera__fx, rays__camera__fy, rays__camera__cx, rays__camera__cy, rays__nearest, rays__farthest, rays__columns, rows, nears, fars)       <L 16>
                var_431 = wp::mul(var_402, var_12);
                var_432 = wp::mul(var_417, var_12);
                var_433 = wp::mul(var_430, var_12);
                var_434 = in_camera_0(var_431, var_432, var_433, var_15);
                bound_box_0(var_434, var_61, var_rays__camera__width, var_rays__camera__height, var_rays__camera__fx, var_rays__camera__fy, var_rays__camera__cx, var_rays__camera__cy, var_rays__nearest, var_rays__farthest, var_rays__columns, var_rows, var_nears, var_fars);
            }
            var_435 = wp::where(var_389, var_402, var_381);
            var_436 = wp::where(var_389, var_417, var_382);
            var_437 = wp::where(var_389, var_430, var_383);
            // if parts >> part & 1 == 1:                                                         <L 12>
            var_439 = wp::rshift(var_2, var_438);
            var_441 = wp::bit_and(var_439, var_440);
            var_443 = (var_441 == var_442);
            if (var_443) {
                // x = float64(low[0] + (part >> 2) * HALF) + float64(HALF_PART) - float64(rays__start[0])       <L 13>
                var_445 = wp::extract(var_11, var_444);
                var_447 = wp::rshift(var_438, var_446);
                var_448 = wp::mul(var_447, var_72);
                var_449 = wp::add(var_445, var_448);
                var_450 = wp::float64(var_449);
                var_451 = wp::float64(var_13);
                var_452 = wp::add(var_450, var_451);
                var_454 = wp::extract(var_rays__start, var_453);
                var_455 = wp::float64(var_454);
                var_456 = wp::sub(var_452, var_455);
                // y = float64(low[1] + (part >> 1 & 1) * HALF) + float64(HALF_PART) - float64(rays__start[1])       <L 14>
                var_458 = wp::extract(var_11, var_457);
                var_460 = wp::rshift(var_438, var_459);
                var_462 = wp::bit_and(var_460, var_461);
                var_463 = wp::mul(var_462, var_72);
                var_464 = wp::add(var_458, var_463);
                var_465 = wp::float64(var_464);
                var_466 = wp::float64(var_13);
                var_467 = wp::add(var_465, var_466);
                var_469 = wp::extract(var_rays__start, var_468);
                var_470 = wp::float64(var_469);
                var_471 = wp::sub(var_467, var_470);
                // z = float64(low[2] + (part & 1) * HALF) + float64(HALF_PART) - float64(rays__start[2])       <L 15>
                var_473 = wp::extract(var_11, var_472);
                var_475 = wp::bit_and(var_438, var_474);
                var_476 = wp::mul(var_475, var_72);
                var_477 = wp::add(var_473, var_476);
                var_478 = wp::float64(var_477);
                var_479 = wp::float64(var_13);
                var_480 = wp::add(var_478, var_479);
                var_482 = wp::extract(var_rays__start, var_481);
                var_483 = wp::float64(var_482);
                var_484 = wp::sub(var_480, var_483);
                // bound_box(in_camera(x * size, y * size, z * size, R), half_size, rays__camera__width, rays__camera__height, rays__camera__fx, rays__camera__fy, rays__camera__cx, rays__camera__cy, rays__nearest, rays__farthest, rays__columns, rows, nears, fars)       <L 16>
                var_485 = wp::mul(var_456, var_12);
                var_486 = wp::mul(var_471, var_12);
                var_487 = wp::mul(var_484, var_12);
                var_488 = in_camera_0(var_485, var_486, var_487, var_15);
                bound_box_0(var_488, var_61, var_rays__camera__width, var_rays__camera__height, var_rays__camera__fx, var_rays__camera__fy, var_rays__camera__cx, var_rays__camera__cy, var_rays__nearest, var_rays__farthest, var_rays__columns, var_rows, var_nears, var_fars);
            }
            var_489 = wp::where(var_443, var_456, var_435);
            var_490 = wp::where(var_443, var_471, var_436);
            var_491 = wp::where(var_443, var_484, var_437);
        }
}


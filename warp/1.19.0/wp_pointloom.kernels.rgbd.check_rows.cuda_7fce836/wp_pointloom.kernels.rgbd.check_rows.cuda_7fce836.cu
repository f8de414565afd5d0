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


// /work/main/src/pointloom/kernels/rgbd/seen_pixels.py:22
static CUDA_CALLABLE wp::vec_t<3, wp::float32> axis_0(
    wp::vec_t<4, wp::float32> var_w)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    const wp::int32 var_2 = 1;
    wp::float32 var_3;
    const wp::int32 var_4 = 2;
    wp::float32 var_5;
    wp::vec_t<3, wp::float32> var_6;
    //---------
    // forward
    // def axis(w: vec4) -> vec3:                                                             <L 23>
    // return vec3(w[0], w[1], w[2])                                                          <L 24>
    var_1 = wp::extract(var_w, var_0);
    var_3 = wp::extract(var_w, var_2);
    var_5 = wp::extract(var_w, var_4);
    var_6 = wp::vec_t<3, wp::float32>(var_1, var_3, var_5);
    return var_6;
}


// /work/main/src/pointloom/kernels/rgbd/seen_pixels.py:27
static CUDA_CALLABLE wp::vec_t<3, wp::float32> moved_point_1(
    wp::float32 var_u,
    wp::float32 var_v,
    wp::float32 var_z,
    wp::array_t<wp::vec_t<4, wp::float32>> var_warps)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::vec_t<4, wp::float32>* var_1;
    wp::vec_t<4, wp::float32> var_2;
    wp::vec_t<4, wp::float32> var_3;
    const wp::int32 var_4 = 1;
    wp::vec_t<4, wp::float32>* var_5;
    wp::vec_t<4, wp::float32> var_6;
    wp::vec_t<4, wp::float32> var_7;
    const wp::int32 var_8 = 2;
    wp::vec_t<4, wp::float32>* var_9;
    wp::vec_t<4, wp::float32> var_10;
    wp::vec_t<4, wp::float32> var_11;
    wp::vec_t<3, wp::float32> var_12;
    wp::vec_t<3, wp::float32> var_13;
    wp::vec_t<3, wp::float32> var_14;
    wp::vec_t<3, wp::float32> var_15;
    wp::vec_t<3, wp::float32> var_16;
    wp::vec_t<3, wp::float32> var_17;
    wp::vec_t<3, wp::float32> var_18;
    wp::vec_t<3, wp::float32> var_19;
    const wp::int32 var_20 = 3;
    wp::float32 var_21;
    const wp::int32 var_22 = 3;
    wp::float32 var_23;
    const wp::int32 var_24 = 3;
    wp::float32 var_25;
    wp::vec_t<3, wp::float32> var_26;
    wp::vec_t<3, wp::float32> var_27;
    //---------
    // forward
    // def moved_point(u: float, v: float, z: float, warps: array(dtype=vec4)) -> vec3:       <L 28>
    // a = warps[0]                                                                           <L 29>
    var_1 = wp::address(var_warps, var_0);
    var_3 = wp::load(var_1);
    var_2 = wp::copy(var_3);
    // b = warps[1]                                                                           <L 30>
    var_5 = wp::address(var_warps, var_4);
    var_7 = wp::load(var_5);
    var_6 = wp::copy(var_7);
    // c = warps[2]                                                                           <L 31>
    var_9 = wp::address(var_warps, var_8);
    var_11 = wp::load(var_9);
    var_10 = wp::copy(var_11);
    // return (axis(a) * u + axis(b) * v + axis(c)) * z + vec3(a[3], b[3], c[3])              <L 32>
    var_12 = axis_0(var_2);
    var_13 = wp::mul(var_12, var_u);
    var_14 = axis_0(var_6);
    var_15 = wp::mul(var_14, var_v);
    var_16 = wp::add(var_13, var_15);
    var_17 = axis_0(var_10);
    var_18 = wp::add(var_16, var_17);
    var_19 = wp::mul(var_18, var_z);
    var_21 = wp::extract(var_2, var_20);
    var_23 = wp::extract(var_6, var_22);
    var_25 = wp::extract(var_10, var_24);
    var_26 = wp::vec_t<3, wp::float32>(var_21, var_23, var_25);
    var_27 = wp::add(var_19, var_26);
    return var_27;
}


// <pointloom.kernels.rgbd.seen_pixels.seen_at>:1
static CUDA_CALLABLE void seen_at_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::int32 var_level,
    wp::array_t<wp::vec_t<4, wp::int32>> var_frame__layout,
    wp::array_t<wp::vec_t<4, wp::float32>> var_frame__lenses,
    wp::float32 & ret_0,
    wp::float32 & ret_1,
    wp::int32 & ret_2)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 0.0;
    wp::float32 var_1;
    const wp::float32 var_2 = 0.0;
    wp::float32 var_3;
    const wp::int32 var_4 = -1;
    wp::int32 var_5;
    const wp::int32 var_6 = 2;
    wp::float32 var_7;
    const wp::float32 var_8 = 0.001;
    bool var_9;
    wp::vec_t<4, wp::float32>* var_10;
    wp::vec_t<4, wp::float32> var_11;
    wp::vec_t<4, wp::float32> var_12;
    wp::vec_t<4, wp::int32>* var_13;
    wp::vec_t<4, wp::int32> var_14;
    wp::vec_t<4, wp::int32> var_15;
    const wp::int32 var_16 = 0;
    wp::float32 var_17;
    const wp::int32 var_18 = 0;
    wp::float32 var_19;
    wp::float32 var_20;
    const wp::int32 var_21 = 2;
    wp::float32 var_22;
    wp::float32 var_23;
    const wp::int32 var_24 = 2;
    wp::float32 var_25;
    wp::float32 var_26;
    const wp::int32 var_27 = 1;
    wp::float32 var_28;
    const wp::int32 var_29 = 1;
    wp::float32 var_30;
    wp::float32 var_31;
    const wp::int32 var_32 = 2;
    wp::float32 var_33;
    wp::float32 var_34;
    const wp::int32 var_35 = 3;
    wp::float32 var_36;
    wp::float32 var_37;
    bool var_38;
    const wp::float32 var_39 = 0.0;
    bool var_40;
    const wp::float32 var_41 = 0.0;
    bool var_42;
    const wp::int32 var_43 = 0;
    wp::int32 var_44;
    const wp::int32 var_45 = 1;
    wp::int32 var_46;
    wp::float32 var_47;
    bool var_48;
    const wp::int32 var_49 = 1;
    wp::int32 var_50;
    const wp::int32 var_51 = 1;
    wp::int32 var_52;
    wp::float32 var_53;
    bool var_54;
    const wp::int32 var_55 = 2;
    wp::int32 var_56;
    const wp::float32 var_57 = 0.5;
    wp::float32 var_58;
    wp::float32 var_59;
    wp::int32 var_60;
    const wp::int32 var_61 = 0;
    wp::int32 var_62;
    wp::int32 var_63;
    wp::int32 var_64;
    const wp::float32 var_65 = 0.5;
    wp::float32 var_66;
    wp::float32 var_67;
    wp::int32 var_68;
    wp::int32 var_69;
    wp::int32 var_70;
    wp::float32 var_71;
    wp::float32 var_72;
    wp::int32 var_73;
    //---------
    // forward
    // def seen_at(p, level, frame__layout, frame__lenses):                                   <L 1>
    // u = float(0.0)                                                                         <L 3>
    var_1 = wp::float(var_0);
    // v = float(0.0)                                                                         <L 4>
    var_3 = wp::float(var_2);
    // at = int(-1)                                                                           <L 5>
    var_5 = wp::int(var_4);
    // if p[2] > NEAREST:                                                                     <L 6>
    var_7 = wp::extract(var_p, var_6);
    var_9 = (var_7 > var_8);
    if (var_9) {
        // lens = frame__lenses[level]                                                        <L 7>
        var_10 = wp::address(var_frame__lenses, var_level);
        var_12 = wp::load(var_10);
        var_11 = wp::copy(var_12);
        // size = frame__layout[level]                                                        <L 8>
        var_13 = wp::address(var_frame__layout, var_level);
        var_15 = wp::load(var_13);
        var_14 = wp::copy(var_15);
        // u = lens[0] * p[0] / p[2] + lens[2]                                                <L 9>
        var_17 = wp::extract(var_11, var_16);
        var_19 = wp::extract(var_p, var_18);
        var_20 = wp::mul(var_17, var_19);
        var_22 = wp::extract(var_p, var_21);
        var_23 = wp::div(var_20, var_22);
        var_25 = wp::extract(var_11, var_24);
        var_26 = wp::add(var_23, var_25);
        // v = lens[1] * p[1] / p[2] + lens[3]                                                <L 10>
        var_28 = wp::extract(var_11, var_27);
        var_30 = wp::extract(var_p, var_29);
        var_31 = wp::mul(var_28, var_30);
        var_33 = wp::extract(var_p, var_32);
        var_34 = wp::div(var_31, var_33);
        var_36 = wp::extract(var_11, var_35);
        var_37 = wp::add(var_34, var_36);
        // if u >= 0.0 and v >= 0.0 and (u < float(size[0] - 1)) and (v < float(size[1] - 1)):       <L 11>
        var_40 = (var_26 >= var_39);
        var_38 = var_40;
        if (var_38) {
            var_42 = (var_37 >= var_41);
            var_38 = var_38 && var_42;
        }
        if (var_38) {
            var_44 = wp::extract(var_14, var_43);
            var_46 = wp::sub(var_44, var_45);
            var_47 = wp::float(var_46);
            var_48 = (var_26 < var_47);
            var_38 = var_38 && var_48;
        }
        if (var_38) {
            var_50 = wp::extract(var_14, var_49);
            var_52 = wp::sub(var_50, var_51);
            var_53 = wp::float(var_52);
            var_54 = (var_37 < var_53);
            var_38 = var_38 && var_54;
        }
        if (var_38) {
            // at = size[2] + int(floor(v + 0.5)) * size[0] + int(floor(u + 0.5))             <L 12>
            var_56 = wp::extract(var_14, var_55);
            var_58 = wp::add(var_37, var_57);
            var_59 = wp::floor(var_58);
            var_60 = wp::int(var_59);
            var_62 = wp::extract(var_14, var_61);
            var_63 = wp::mul(var_60, var_62);
            var_64 = wp::add(var_56, var_63);
            var_66 = wp::add(var_26, var_65);
            var_67 = wp::floor(var_66);
            var_68 = wp::int(var_67);
            var_69 = wp::add(var_64, var_68);
        }
        var_70 = wp::where(var_38, var_69, var_5);
    }
    var_71 = wp::where(var_9, var_26, var_1);
    var_72 = wp::where(var_9, var_37, var_3);
    var_73 = wp::where(var_9, var_70, var_5);
    // return (u, v, at)                                                                      <L 13>
    ret_0 = var_71;
    ret_1 = var_72;
    ret_2 = var_73;
    return;
}


// /work/main/src/pointloom/kernels/rgbd/seen_pixels.py:15
static CUDA_CALLABLE wp::float32 depth_noise_0(
    wp::float32 var_z)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 0.4;
    wp::float32 var_1;
    const wp::float32 var_2 = 0.0;
    wp::float32 var_3;
    const wp::float32 var_4 = 0.0012;
    const wp::float32 var_5 = 0.0019;
    wp::float32 var_6;
    wp::float32 var_7;
    wp::float32 var_8;
    //---------
    // forward
    // def depth_noise(z: float) -> float:                                                    <L 16>
    // beyond = max(z - NOISE_NEAR, 0.0)                                                      <L 18>
    var_1 = wp::sub(var_z, var_0);
    var_3 = wp::max(var_1, var_2);
    // return NOISE_FLOOR + NOISE_SLOPE * beyond * beyond                                     <L 19>
    var_6 = wp::mul(var_5, var_3);
    var_7 = wp::mul(var_6, var_3);
    var_8 = wp::add(var_4, var_7);
    return var_8;
}


// /work/main/src/pointloom/kernels/rgbd/check_rows.py:85
static CUDA_CALLABLE wp::vec_t<3, wp::float32> rotated_normal_0(
    wp::vec_t<4, wp::float32> var_plane,
    wp::vec_t<4, wp::float32> var_lens,
    wp::array_t<wp::vec_t<4, wp::float32>> var_warps)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::vec_t<4, wp::float32>* var_1;
    wp::vec_t<3, wp::float32> var_2;
    wp::vec_t<4, wp::float32> var_3;
    const wp::int32 var_4 = 1;
    wp::vec_t<4, wp::float32>* var_5;
    wp::vec_t<3, wp::float32> var_6;
    wp::vec_t<4, wp::float32> var_7;
    const wp::int32 var_8 = 2;
    wp::vec_t<4, wp::float32>* var_9;
    wp::vec_t<3, wp::float32> var_10;
    wp::vec_t<4, wp::float32> var_11;
    const wp::int32 var_12 = 2;
    wp::float32 var_13;
    wp::vec_t<3, wp::float32> var_14;
    wp::vec_t<3, wp::float32> var_15;
    const wp::int32 var_16 = 3;
    wp::float32 var_17;
    wp::vec_t<3, wp::float32> var_18;
    wp::vec_t<3, wp::float32> var_19;
    const wp::int32 var_20 = 0;
    wp::float32 var_21;
    wp::vec_t<3, wp::float32> var_22;
    const wp::int32 var_23 = 0;
    wp::float32 var_24;
    wp::vec_t<3, wp::float32> var_25;
    const wp::int32 var_26 = 1;
    wp::float32 var_27;
    wp::vec_t<3, wp::float32> var_28;
    const wp::int32 var_29 = 1;
    wp::float32 var_30;
    wp::vec_t<3, wp::float32> var_31;
    wp::vec_t<3, wp::float32> var_32;
    const wp::int32 var_33 = 2;
    wp::float32 var_34;
    wp::vec_t<3, wp::float32> var_35;
    wp::vec_t<3, wp::float32> var_36;
    //---------
    // forward
    // def rotated_normal(plane: vec4, lens: vec4, warps: array(dtype=vec4)) -> vec3:         <L 86>
    // a = axis(warps[0])                                                                     <L 88>
    var_1 = wp::address(var_warps, var_0);
    var_3 = wp::load(var_1);
    var_2 = axis_0(var_3);
    // b = axis(warps[1])                                                                     <L 89>
    var_5 = wp::address(var_warps, var_4);
    var_7 = wp::load(var_5);
    var_6 = axis_0(var_7);
    // c = axis(warps[2]) + a * lens[2] + b * lens[3]                                         <L 90>
    var_9 = wp::address(var_warps, var_8);
    var_11 = wp::load(var_9);
    var_10 = axis_0(var_11);
    var_13 = wp::extract(var_lens, var_12);
    var_14 = wp::mul(var_2, var_13);
    var_15 = wp::add(var_10, var_14);
    var_17 = wp::extract(var_lens, var_16);
    var_18 = wp::mul(var_6, var_17);
    var_19 = wp::add(var_15, var_18);
    // return a * lens[0] * plane[0] + b * lens[1] * plane[1] + c * plane[2]                  <L 91>
    var_21 = wp::extract(var_lens, var_20);
    var_22 = wp::mul(var_2, var_21);
    var_24 = wp::extract(var_plane, var_23);
    var_25 = wp::mul(var_22, var_24);
    var_27 = wp::extract(var_lens, var_26);
    var_28 = wp::mul(var_6, var_27);
    var_30 = wp::extract(var_plane, var_29);
    var_31 = wp::mul(var_28, var_30);
    var_32 = wp::add(var_25, var_31);
    var_34 = wp::extract(var_plane, var_33);
    var_35 = wp::mul(var_19, var_34);
    var_36 = wp::add(var_32, var_35);
    return var_36;
}


// <pointloom.kernels.rgbd.seen_pixels.seen_brightness>:1
static CUDA_CALLABLE wp::vec_t<4, wp::float32> seen_brightness_0(
    wp::float32 var_u,
    wp::float32 var_v,
    wp::int32 var_level,
    wp::array_t<wp::vec_t<4, wp::int32>> var_frame__layout,
    wp::array_t<wp::float32> var_frame__brightness)
{
    //---------
    // primal vars
    wp::vec_t<4, wp::int32>* var_0;
    wp::vec_t<4, wp::int32> var_1;
    wp::vec_t<4, wp::int32> var_2;
    wp::float32 var_3;
    wp::int32 var_4;
    wp::float32 var_5;
    wp::int32 var_6;
    const wp::int32 var_7 = 2;
    wp::int32 var_8;
    const wp::int32 var_9 = 0;
    wp::int32 var_10;
    wp::int32 var_11;
    wp::int32 var_12;
    wp::int32 var_13;
    wp::float32* var_14;
    wp::float32 var_15;
    wp::float32 var_16;
    const wp::int32 var_17 = 1;
    wp::int32 var_18;
    wp::float32* var_19;
    wp::float32 var_20;
    wp::float32 var_21;
    const wp::int32 var_22 = 0;
    wp::int32 var_23;
    wp::int32 var_24;
    wp::float32* var_25;
    wp::float32 var_26;
    wp::float32 var_27;
    const wp::int32 var_28 = 0;
    wp::int32 var_29;
    wp::int32 var_30;
    const wp::int32 var_31 = 1;
    wp::int32 var_32;
    wp::float32* var_33;
    wp::float32 var_34;
    wp::float32 var_35;
    wp::float32 var_36;
    wp::float32 var_37;
    wp::float32 var_38;
    wp::float32 var_39;
    const wp::float32 var_40 = 0.0;
    const wp::float32 var_41 = 0.0;
    const wp::float32 var_42 = 0.0;
    const wp::float32 var_43 = 0.0;
    wp::vec_t<4, wp::float32> var_44;
    wp::float32 var_45;
    wp::float32 var_46;
    wp::float32 var_47;
    const wp::float32 var_48 = 0.0;
    bool var_49;
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
    const wp::float32 var_60 = 1.0;
    wp::float32 var_61;
    wp::float32 var_62;
    wp::float32 var_63;
    wp::float32 var_64;
    wp::float32 var_65;
    wp::float32 var_66;
    const wp::float32 var_67 = 1.0;
    wp::vec_t<4, wp::float32> var_68;
    wp::vec_t<4, wp::float32> var_69;
    //---------
    // forward
    // def seen_brightness(u, v, level, frame__layout, frame__brightness):                    <L 1>
    // size = frame__layout[level]                                                            <L 3>
    var_0 = wp::address(var_frame__layout, var_level);
    var_2 = wp::load(var_0);
    var_1 = wp::copy(var_2);
    // left = int(floor(u))                                                                   <L 4>
    var_3 = wp::floor(var_u);
    var_4 = wp::int(var_3);
    // top = int(floor(v))                                                                    <L 5>
    var_5 = wp::floor(var_v);
    var_6 = wp::int(var_5);
    // at = size[2] + top * size[0] + left                                                    <L 6>
    var_8 = wp::extract(var_1, var_7);
    var_10 = wp::extract(var_1, var_9);
    var_11 = wp::mul(var_6, var_10);
    var_12 = wp::add(var_8, var_11);
    var_13 = wp::add(var_12, var_4);
    // a = frame__brightness[at]                                                              <L 7>
    var_14 = wp::address(var_frame__brightness, var_13);
    var_16 = wp::load(var_14);
    var_15 = wp::copy(var_16);
    // b = frame__brightness[at + 1]                                                          <L 8>
    var_18 = wp::add(var_13, var_17);
    var_19 = wp::address(var_frame__brightness, var_18);
    var_21 = wp::load(var_19);
    var_20 = wp::copy(var_21);
    // c = frame__brightness[at + size[0]]                                                    <L 9>
    var_23 = wp::extract(var_1, var_22);
    var_24 = wp::add(var_13, var_23);
    var_25 = wp::address(var_frame__brightness, var_24);
    var_27 = wp::load(var_25);
    var_26 = wp::copy(var_27);
    // d = frame__brightness[at + size[0] + 1]                                                <L 10>
    var_29 = wp::extract(var_1, var_28);
    var_30 = wp::add(var_13, var_29);
    var_32 = wp::add(var_30, var_31);
    var_33 = wp::address(var_frame__brightness, var_32);
    var_35 = wp::load(var_33);
    var_34 = wp::copy(var_35);
    // s = u - float(left)                                                                    <L 11>
    var_36 = wp::float(var_4);
    var_37 = wp::sub(var_u, var_36);
    // t = v - float(top)                                                                     <L 12>
    var_38 = wp::float(var_6);
    var_39 = wp::sub(var_v, var_38);
    // sample = vec4(0.0, 0.0, 0.0, 0.0)                                                      <L 13>
    var_44 = wp::vec_t<4, wp::float32>(var_40, var_41, var_42, var_43);
    // if min(min(a, b), min(c, d)) >= 0.0:                                                   <L 14>
    var_45 = wp::min(var_15, var_20);
    var_46 = wp::min(var_26, var_34);
    var_47 = wp::min(var_45, var_46);
    var_49 = (var_47 >= var_48);
    if (var_49) {
        // upper = a + (b - a) * s                                                            <L 15>
        var_50 = wp::sub(var_20, var_15);
        var_51 = wp::mul(var_50, var_37);
        var_52 = wp::add(var_15, var_51);
        // lower = c + (d - c) * s                                                            <L 16>
        var_53 = wp::sub(var_34, var_26);
        var_54 = wp::mul(var_53, var_37);
        var_55 = wp::add(var_26, var_54);
        // sample = vec4(upper + (lower - upper) * t, (b - a) * (1.0 - t) + (d - c) * t, lower - upper, 1.0)       <L 17>
        var_56 = wp::sub(var_55, var_52);
        var_57 = wp::mul(var_56, var_39);
        var_58 = wp::add(var_52, var_57);
        var_59 = wp::sub(var_20, var_15);
        var_61 = wp::sub(var_60, var_39);
        var_62 = wp::mul(var_59, var_61);
        var_63 = wp::sub(var_34, var_26);
        var_64 = wp::mul(var_63, var_39);
        var_65 = wp::add(var_62, var_64);
        var_66 = wp::sub(var_55, var_52);
        var_68 = wp::vec_t<4, wp::float32>(var_58, var_65, var_66, var_67);
    }
    var_69 = wp::where(var_49, var_68, var_44);
    // return sample                                                                          <L 18>
    return var_69;
}


// <pointloom.kernels.rgbd.check_rows.summed>:1
static CUDA_CALLABLE wp::vec_t<28, wp::float64> summed_0(
    wp::vec_t<28, wp::float32> var_sums,
    wp::vec_t<3, wp::float32> var_p)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::vec_t<28, wp::float64> var_1;
    wp::int32 var_2;
    wp::int32 var_3;
    wp::float32 var_4;
    wp::float64 var_5;
    const wp::int32 var_6 = 0;
    wp::float32 var_7;
    wp::float64 var_8;
    const wp::int32 var_9 = 17;
    wp::int32 var_10;
    const wp::int32 var_11 = 1;
    wp::float32 var_12;
    wp::float64 var_13;
    wp::int32 var_14;
    const wp::int32 var_15 = 2;
    wp::float32 var_16;
    wp::float64 var_17;
    wp::int32 var_18;
    const wp::int32 var_19 = 0;
    wp::float32 var_20;
    const wp::int32 var_21 = 0;
    wp::float32 var_22;
    wp::float32 var_23;
    wp::float64 var_24;
    const wp::int32 var_25 = 3;
    wp::int32 var_26;
    const wp::int32 var_27 = 0;
    wp::float32 var_28;
    const wp::int32 var_29 = 1;
    wp::float32 var_30;
    wp::float32 var_31;
    wp::float64 var_32;
    const wp::int32 var_33 = 4;
    wp::int32 var_34;
    const wp::int32 var_35 = 0;
    wp::float32 var_36;
    const wp::int32 var_37 = 2;
    wp::float32 var_38;
    wp::float32 var_39;
    wp::float64 var_40;
    const wp::int32 var_41 = 5;
    wp::int32 var_42;
    const wp::int32 var_43 = 1;
    wp::float32 var_44;
    const wp::int32 var_45 = 1;
    wp::float32 var_46;
    wp::float32 var_47;
    wp::float64 var_48;
    const wp::int32 var_49 = 6;
    wp::int32 var_50;
    const wp::int32 var_51 = 1;
    wp::float32 var_52;
    const wp::int32 var_53 = 2;
    wp::float32 var_54;
    wp::float32 var_55;
    wp::float64 var_56;
    const wp::int32 var_57 = 7;
    wp::int32 var_58;
    const wp::int32 var_59 = 2;
    wp::float32 var_60;
    const wp::int32 var_61 = 2;
    wp::float32 var_62;
    wp::float32 var_63;
    wp::float64 var_64;
    const wp::int32 var_65 = 8;
    wp::int32 var_66;
    //---------
    // forward
    // def summed(sums, p):                                                                   <L 1>
    // out = consistency_sums(float64(0.0))                                                   <L 3>
    var_0 = 0.0;
    var_1 = wp::vec_t<28, wp::float64>(var_0);
    // for k in range(28):                                                                    <L 4>
    var_2 = 0;
    start_for_0:;
        if (var_2 >= 28) goto end_for_0;
        var_3 = var_2;
        var_2 += 1;
        // out[k] = float64(sums[k])                                                          <L 5>
        var_4 = wp::extract(var_sums, var_3);
        var_5 = wp::float64(var_4);
        wp::assign_inplace(var_1, var_3, var_5);
        goto start_for_0;
    end_for_0:;
    // for a in range(3):                                                                     <L 6>
    // out[POINTS + a] = float64(p[a])                                                        <L 7>
    var_7 = wp::extract(var_p, var_6);
    var_8 = wp::float64(var_7);
    var_10 = wp::add(var_9, var_6);
    wp::assign_inplace(var_1, var_10, var_8);
    var_12 = wp::extract(var_p, var_11);
    var_13 = wp::float64(var_12);
    var_14 = wp::add(var_9, var_11);
    wp::assign_inplace(var_1, var_14, var_13);
    var_16 = wp::extract(var_p, var_15);
    var_17 = wp::float64(var_16);
    var_18 = wp::add(var_9, var_15);
    wp::assign_inplace(var_1, var_18, var_17);
    // out[POINTS + 3] = float64(p[0] * p[0])                                                 <L 8>
    var_20 = wp::extract(var_p, var_19);
    var_22 = wp::extract(var_p, var_21);
    var_23 = wp::mul(var_20, var_22);
    var_24 = wp::float64(var_23);
    var_26 = wp::add(var_9, var_25);
    wp::assign_inplace(var_1, var_26, var_24);
    // out[POINTS + 4] = float64(p[0] * p[1])                                                 <L 9>
    var_28 = wp::extract(var_p, var_27);
    var_30 = wp::extract(var_p, var_29);
    var_31 = wp::mul(var_28, var_30);
    var_32 = wp::float64(var_31);
    var_34 = wp::add(var_9, var_33);
    wp::assign_inplace(var_1, var_34, var_32);
    // out[POINTS + 5] = float64(p[0] * p[2])                                                 <L 10>
    var_36 = wp::extract(var_p, var_35);
    var_38 = wp::extract(var_p, var_37);
    var_39 = wp::mul(var_36, var_38);
    var_40 = wp::float64(var_39);
    var_42 = wp::add(var_9, var_41);
    wp::assign_inplace(var_1, var_42, var_40);
    // out[POINTS + 6] = float64(p[1] * p[1])                                                 <L 11>
    var_44 = wp::extract(var_p, var_43);
    var_46 = wp::extract(var_p, var_45);
    var_47 = wp::mul(var_44, var_46);
    var_48 = wp::float64(var_47);
    var_50 = wp::add(var_9, var_49);
    wp::assign_inplace(var_1, var_50, var_48);
    // out[POINTS + 7] = float64(p[1] * p[2])                                                 <L 12>
    var_52 = wp::extract(var_p, var_51);
    var_54 = wp::extract(var_p, var_53);
    var_55 = wp::mul(var_52, var_54);
    var_56 = wp::float64(var_55);
    var_58 = wp::add(var_9, var_57);
    wp::assign_inplace(var_1, var_58, var_56);
    // out[POINTS + 8] = float64(p[2] * p[2])                                                 <L 13>
    var_60 = wp::extract(var_p, var_59);
    var_62 = wp::extract(var_p, var_61);
    var_63 = wp::mul(var_60, var_62);
    var_64 = wp::float64(var_63);
    var_66 = wp::add(var_9, var_65);
    wp::assign_inplace(var_1, var_66, var_64);
    // return out                                                                             <L 14>
    return var_1;
}


// <pointloom.kernels.rgbd.check_rows.sum_consistency_element>:1
static CUDA_CALLABLE wp::vec_t<28, wp::float64> sum_consistency_element_0(
    wp::array_t<wp::vec_t<4, wp::int32>> var_source__layout,
    wp::array_t<wp::vec_t<4, wp::float32>> var_source__lenses,
    wp::array_t<wp::float32> var_source__depth,
    wp::array_t<wp::float32> var_source__brightness,
    wp::array_t<wp::vec_t<4, wp::float32>> var_source__planes,
    wp::array_t<wp::vec_t<4, wp::int32>> var_target__layout,
    wp::array_t<wp::vec_t<4, wp::float32>> var_target__lenses,
    wp::array_t<wp::float32> var_target__depth,
    wp::array_t<wp::float32> var_target__brightness,
    wp::array_t<wp::vec_t<4, wp::float32>> var_target__planes,
    wp::int32 var_level,
    wp::int32 var_other,
    wp::array_t<wp::vec_t<4, wp::float32>> var_warps,
    wp::array_t<wp::float32> var_scales,
    wp::int32 var_e)
{
    //---------
    // primal vars
    wp::vec_t<4, wp::int32>* var_0;
    wp::vec_t<4, wp::int32> var_1;
    wp::vec_t<4, wp::int32> var_2;
    const wp::int32 var_3 = 2;
    wp::int32 var_4;
    wp::int32 var_5;
    wp::float32* var_6;
    wp::float32 var_7;
    wp::float32 var_8;
    const wp::float32 var_9 = 0.0;
    wp::vec_t<28, wp::float32> var_10;
    const wp::float32 var_11 = 0.0;
    wp::vec_t<3, wp::float32> var_12;
    const wp::float32 var_13 = 0.0;
    bool var_14;
    const wp::float32 var_15 = 1.0;
    const wp::int32 var_16 = 0;
    const wp::int32 var_17 = 0;
    wp::int32 var_18;
    wp::int32 var_19;
    wp::float32 var_20;
    const wp::int32 var_21 = 0;
    wp::int32 var_22;
    wp::int32 var_23;
    wp::float32 var_24;
    wp::vec_t<3, wp::float32> var_25;
    wp::float32 var_26;
    wp::float32 var_27;
    wp::int32 var_28;
    const wp::float32 var_29 = 0.0;
    wp::float32 var_30;
    const wp::int32 var_31 = 0;
    bool var_32;
    const wp::float32 var_33 = 1.0;
    const wp::int32 var_34 = 1;
    wp::float32* var_35;
    wp::float32 var_36;
    wp::float32 var_37;
    wp::float32 var_38;
    const wp::float32 var_39 = 0.0;
    bool var_40;
    const wp::float32 var_41 = 1.0;
    const wp::int32 var_42 = 2;
    const wp::int32 var_43 = 2;
    wp::float32 var_44;
    wp::float32 var_45;
    const wp::int32 var_46 = 2;
    wp::float32 var_47;
    wp::float32 var_48;
    const wp::float32 var_49 = 4.0;
    const wp::float32 var_50 = 0.01;
    const wp::int32 var_51 = 2;
    wp::float32 var_52;
    wp::float32 var_53;
    wp::float32 var_54;
    wp::float32 var_55;
    wp::float32 var_56;
    bool var_57;
    const wp::float32 var_58 = 1.0;
    const wp::int32 var_59 = 4;
    bool var_60;
    const wp::float32 var_61 = 1.0;
    const wp::int32 var_62 = 5;
    const wp::float32 var_63 = 1.0;
    const wp::int32 var_64 = 3;
    wp::vec_t<3, wp::float32> var_65;
    wp::vec_t<4, wp::float32>* var_66;
    wp::vec_t<4, wp::float32> var_67;
    wp::vec_t<4, wp::float32> var_68;
    const wp::int32 var_69 = 3;
    wp::float32 var_70;
    const wp::float32 var_71 = 0.0;
    bool var_72;
    wp::vec_t<3, wp::float32> var_73;
    wp::float32 var_74;
    const wp::int32 var_75 = 3;
    wp::float32 var_76;
    wp::float32 var_77;
    wp::float32 var_78;
    const wp::int32 var_79 = 15;
    const wp::float32 var_80 = 1.0;
    const wp::int32 var_81 = 26;
    wp::float32 var_82;
    wp::float32 var_83;
    wp::float32 var_84;
    const wp::float32 var_85 = 16.0;
    wp::float32 var_86;
    const wp::int32 var_87 = 27;
    wp::vec_t<4, wp::float32>* var_88;
    const wp::int32 var_89 = 3;
    wp::float32 var_90;
    wp::vec_t<4, wp::float32> var_91;
    const wp::float32 var_92 = 0.0;
    bool var_93;
    wp::vec_t<4, wp::float32>* var_94;
    wp::vec_t<4, wp::float32>* var_95;
    wp::vec_t<3, wp::float32> var_96;
    wp::vec_t<4, wp::float32> var_97;
    wp::vec_t<4, wp::float32> var_98;
    wp::vec_t<3, wp::float32> var_99;
    wp::float32 var_100;
    const wp::float32 var_101 = 1.0;
    const wp::int32 var_102 = 6;
    const wp::int32 var_103 = 7;
    const wp::float32 var_104 = 0.8;
    bool var_105;
    const wp::float32 var_106 = 1.0;
    const wp::int32 var_107 = 8;
    wp::float32* var_108;
    wp::float32 var_109;
    wp::float32 var_110;
    const wp::float32 var_111 = 0.0;
    bool var_112;
    wp::vec_t<4, wp::float32> var_113;
    const wp::int32 var_114 = 3;
    wp::float32 var_115;
    const wp::float32 var_116 = 0.0;
    bool var_117;
    const wp::int32 var_118 = 0;
    wp::float32 var_119;
    const wp::int32 var_120 = 2;
    wp::float32* var_121;
    wp::float32 var_122;
    wp::float32 var_123;
    wp::float32 var_124;
    const wp::int32 var_125 = 3;
    wp::float32* var_126;
    wp::float32 var_127;
    wp::float32 var_128;
    const wp::float32 var_129 = 1.0;
    const wp::int32 var_130 = 9;
    const wp::int32 var_131 = 1;
    wp::int32 var_132;
    const wp::int32 var_133 = 0;
    wp::float32 var_134;
    const wp::int32 var_135 = 2;
    wp::int32 var_136;
    wp::float32 var_137;
    const wp::int32 var_138 = 3;
    wp::int32 var_139;
    const wp::int32 var_140 = 0;
    wp::float32 var_141;
    const wp::int32 var_142 = 0;
    wp::float32 var_143;
    wp::float32 var_144;
    const wp::int32 var_145 = 4;
    wp::int32 var_146;
    const wp::int32 var_147 = 0;
    wp::float32 var_148;
    wp::float32 var_149;
    const wp::int32 var_150 = 5;
    wp::int32 var_151;
    wp::float32 var_152;
    const wp::int32 var_153 = 16;
    wp::vec_t<3, wp::float32> var_154;
    wp::vec_t<3, wp::float32> var_155;
    wp::vec_t<3, wp::float32> var_156;
    wp::vec_t<3, wp::float32> var_157;
    wp::vec_t<28, wp::float64> var_158;
    //---------
    // forward
    // def sum_consistency_element(source__layout, source__lenses, source__depth, source__brightness, source__planes, target__layout, target__lenses, target__depth, target__brightness, target__planes, level, other, warps, scales, e):       <L 1>
    // size = source__layout[level]                                                           <L 2>
    var_0 = wp::address(var_source__layout, var_level);
    var_2 = wp::load(var_0);
    var_1 = wp::copy(var_2);
    // i = size[2] + e                                                                        <L 3>
    var_4 = wp::extract(var_1, var_3);
    var_5 = wp::add(var_4, var_e);
    // z = source__depth[i]                                                                   <L 4>
    var_6 = wp::address(var_source__depth, var_5);
    var_8 = wp::load(var_6);
    var_7 = wp::copy(var_8);
    // out = consistency_row(0.0)                                                             <L 5>
    var_10 = wp::vec_t<28, wp::float32>(var_9);
    // inlier = vec3(0.0)                                                                     <L 6>
    var_12 = wp::vec_t<3, wp::float32>(var_11);
    // if z > 0.0:                                                                            <L 7>
    var_14 = (var_7 > var_13);
    if (var_14) {
        // out[PIXELS] = 1.0                                                                  <L 8>
        wp::assign_inplace(var_10, var_16, var_15);
        // p = moved_point(float(e % size[0]), float(e // size[0]), z, warps)                 <L 9>
        var_18 = wp::extract(var_1, var_17);
        var_19 = wp::mod(var_e, var_18);
        var_20 = wp::float(var_19);
        var_22 = wp::extract(var_1, var_21);
        var_23 = wp::floordiv(var_e, var_22);
        var_24 = wp::float(var_23);
        var_25 = moved_point_1(var_20, var_24, var_7, var_warps);
        // u, v, at = seen_at(p, other, target__layout, target__lenses)                       <L 10>
        seen_at_0(var_25, var_other, var_target__layout, var_target__lenses, var_26, var_27, var_28);
        // there = float(0.0)                                                                 <L 11>
        var_30 = wp::float(var_29);
        // if at >= 0:                                                                        <L 12>
        var_32 = (var_28 >= var_31);
        if (var_32) {
            // out[INSIDE] = 1.0                                                              <L 13>
            wp::assign_inplace(var_10, var_34, var_33);
            // there = target__depth[at]                                                      <L 14>
            var_35 = wp::address(var_target__depth, var_28);
            var_37 = wp::load(var_35);
            var_36 = wp::copy(var_37);
        }
        var_38 = wp::where(var_32, var_36, var_30);
        // if there > 0.0:                                                                    <L 15>
        var_40 = (var_38 > var_39);
        if (var_40) {
            // out[SEEN] = 1.0                                                                <L 16>
            wp::assign_inplace(var_10, var_42, var_41);
            // gap = p[2] - there                                                             <L 17>
            var_44 = wp::extract(var_25, var_43);
            var_45 = wp::sub(var_44, var_38);
            // noise = depth_noise(p[2])                                                      <L 18>
            var_47 = wp::extract(var_25, var_46);
            var_48 = depth_noise_0(var_47);
            // limit = INLIER_LIMIT * (noise + SLOPE_MARGIN * p[2])                           <L 19>
            var_52 = wp::extract(var_25, var_51);
            var_53 = wp::mul(var_50, var_52);
            var_54 = wp::add(var_48, var_53);
            var_55 = wp::mul(var_49, var_54);
            // if gap < -limit:                                                               <L 20>
            var_56 = wp::neg(var_55);
            var_57 = (var_45 < var_56);
            if (var_57) {
                // out[IN_FRONT] = 1.0                                                        <L 21>
                wp::assign_inplace(var_10, var_59, var_58);
            }
            if (!var_57) {
                // elif gap > limit:                                                          <L 22>
                var_60 = (var_45 > var_55);
                if (var_60) {
                    // out[BEHIND] = 1.0                                                      <L 23>
                    wp::assign_inplace(var_10, var_62, var_61);
                }
                if (!var_60) {
                    // out[INLIERS] = 1.0                                                     <L 25>
                    wp::assign_inplace(var_10, var_64, var_63);
                    // inlier = p                                                             <L 26>
                    var_65 = wp::copy(var_25);
                    // plane = target__planes[at]                                             <L 27>
                    var_66 = wp::address(var_target__planes, var_28);
                    var_68 = wp::load(var_66);
                    var_67 = wp::copy(var_68);
                    // if plane[3] < 0.0:                                                     <L 28>
                    var_70 = wp::extract(var_67, var_69);
                    var_72 = (var_70 < var_71);
                    if (var_72) {
                        // r = dot(axis(plane), p) - plane[3]                                 <L 29>
                        var_73 = axis_0(var_67);
                        var_74 = wp::dot(var_73, var_25);
                        var_76 = wp::extract(var_67, var_75);
                        var_77 = wp::sub(var_74, var_76);
                        // out[SQUARES] = r * r                                               <L 30>
                        var_78 = wp::mul(var_77, var_77);
                        wp::assign_inplace(var_10, var_79, var_78);
                        // out[PLANES] = 1.0                                                  <L 31>
                        wp::assign_inplace(var_10, var_81, var_80);
                        // out[EXCESS] = min(r * r / (noise * noise), MAX_EXCESS)             <L 32>
                        var_82 = wp::mul(var_77, var_77);
                        var_83 = wp::mul(var_48, var_48);
                        var_84 = wp::div(var_82, var_83);
                        var_86 = wp::min(var_84, var_85);
                        wp::assign_inplace(var_10, var_87, var_86);
                        // if source__planes[i][3] < 0.0:                                     <L 33>
                        var_88 = wp::address(var_source__planes, var_5);
                        var_91 = wp::load(var_88);
                        var_90 = wp::extract(var_91, var_89);
                        var_93 = (var_90 < var_92);
                        if (var_93) {
                            // cosine = dot(rotated_normal(source__planes[i], source__lenses[level], warps), axis(plane))       <L 34>
                            var_94 = wp::address(var_source__planes, var_5);
                            var_95 = wp::address(var_source__lenses, var_level);
                            var_97 = wp::load(var_94);
                            var_98 = wp::load(var_95);
                            var_96 = rotated_normal_0(var_97, var_98, var_warps);
                            var_99 = axis_0(var_67);
                            var_100 = wp::dot(var_96, var_99);
                            // out[NORMALS] = 1.0                                             <L 35>
                            wp::assign_inplace(var_10, var_102, var_101);
                            // out[COSINES] = cosine                                          <L 36>
                            wp::assign_inplace(var_10, var_103, var_100);
                            // if cosine > AGREEMENT:                                         <L 37>
                            var_105 = (var_100 > var_104);
                            if (var_105) {
                                // out[AGREEING] = 1.0                                        <L 38>
                                wp::assign_inplace(var_10, var_107, var_106);
                            }
                        }
                    }
                    // shade = source__brightness[i]                                          <L 39>
                    var_108 = wp::address(var_source__brightness, var_5);
                    var_110 = wp::load(var_108);
                    var_109 = wp::copy(var_110);
                    // if shade >= 0.0:                                                       <L 40>
                    var_112 = (var_109 >= var_111);
                    if (var_112) {
                        // sample = seen_brightness(u, v, other, target__layout, target__brightness)       <L 41>
                        var_113 = seen_brightness_0(var_26, var_27, var_other, var_target__layout, var_target__brightness);
                        // if sample[3] > 0.0:                                                <L 42>
                        var_115 = wp::extract(var_113, var_114);
                        var_117 = (var_115 > var_116);
                        if (var_117) {
                            // s = sample[0] - shade * scales[2] - scales[3]                  <L 43>
                            var_119 = wp::extract(var_113, var_118);
                            var_121 = wp::address(var_scales, var_120);
                            var_123 = wp::load(var_121);
                            var_122 = wp::mul(var_109, var_123);
                            var_124 = wp::sub(var_119, var_122);
                            var_126 = wp::address(var_scales, var_125);
                            var_128 = wp::load(var_126);
                            var_127 = wp::sub(var_124, var_128);
                            // out[SHADE_COUNT] = 1.0                                         <L 44>
                            wp::assign_inplace(var_10, var_130, var_129);
                            // out[SHADE_COUNT + 1] = shade                                   <L 45>
                            var_132 = wp::add(var_130, var_131);
                            wp::assign_inplace(var_10, var_132, var_109);
                            // out[SHADE_COUNT + 2] = sample[0]                               <L 46>
                            var_134 = wp::extract(var_113, var_133);
                            var_136 = wp::add(var_130, var_135);
                            wp::assign_inplace(var_10, var_136, var_134);
                            // out[SHADE_COUNT + 3] = shade * shade                           <L 47>
                            var_137 = wp::mul(var_109, var_109);
                            var_139 = wp::add(var_130, var_138);
                            wp::assign_inplace(var_10, var_139, var_137);
                            // out[SHADE_COUNT + 4] = sample[0] * sample[0]                   <L 48>
                            var_141 = wp::extract(var_113, var_140);
                            var_143 = wp::extract(var_113, var_142);
                            var_144 = wp::mul(var_141, var_143);
                            var_146 = wp::add(var_130, var_145);
                            wp::assign_inplace(var_10, var_146, var_144);
                            // out[SHADE_COUNT + 5] = shade * sample[0]                       <L 49>
                            var_148 = wp::extract(var_113, var_147);
                            var_149 = wp::mul(var_109, var_148);
                            var_151 = wp::add(var_130, var_150);
                            wp::assign_inplace(var_10, var_151, var_149);
                            // out[SHADE_SQUARES] = s * s                                     <L 50>
                            var_152 = wp::mul(var_127, var_127);
                            wp::assign_inplace(var_10, var_153, var_152);
                        }
                    }
                }
                var_154 = wp::where(var_60, var_12, var_65);
            }
            var_155 = wp::where(var_57, var_12, var_154);
        }
        var_156 = wp::where(var_40, var_155, var_12);
    }
    var_157 = wp::where(var_14, var_156, var_12);
    // return summed(out, inlier)                                                             <L 51>
    var_158 = summed_0(var_10, var_157);
    return var_158;
}


// /work/main/src/pointloom/kernels/rgbd/seen_pixels.py:22
static CUDA_CALLABLE void adj_axis_0(
    wp::vec_t<4, wp::float32> var_w,
    wp::vec_t<4, wp::float32> & adj_w,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/rgbd/seen_pixels.py:27
static CUDA_CALLABLE void adj_moved_point_1(
    wp::float32 var_u,
    wp::float32 var_v,
    wp::float32 var_z,
    wp::array_t<wp::vec_t<4, wp::float32>> var_warps,
    wp::float32 & adj_u,
    wp::float32 & adj_v,
    wp::float32 & adj_z,
    wp::array_t<wp::vec_t<4, wp::float32>> & adj_warps,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.rgbd.seen_pixels.seen_at>:1
static CUDA_CALLABLE void adj_seen_at_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::int32 var_level,
    wp::array_t<wp::vec_t<4, wp::int32>> var_frame__layout,
    wp::array_t<wp::vec_t<4, wp::float32>> var_frame__lenses,
    wp::float32 & ret_0,
    wp::float32 & ret_1,
    wp::int32 & ret_2,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::int32 & adj_level,
    wp::array_t<wp::vec_t<4, wp::int32>> & adj_frame__layout,
    wp::array_t<wp::vec_t<4, wp::float32>> & adj_frame__lenses,
    wp::float32 & adj_ret_0,
    wp::float32 & adj_ret_1,
    wp::int32 & adj_ret_2)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/rgbd/seen_pixels.py:15
static CUDA_CALLABLE void adj_depth_noise_0(
    wp::float32 var_z,
    wp::float32 & adj_z,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/rgbd/check_rows.py:85
static CUDA_CALLABLE void adj_rotated_normal_0(
    wp::vec_t<4, wp::float32> var_plane,
    wp::vec_t<4, wp::float32> var_lens,
    wp::array_t<wp::vec_t<4, wp::float32>> var_warps,
    wp::vec_t<4, wp::float32> & adj_plane,
    wp::vec_t<4, wp::float32> & adj_lens,
    wp::array_t<wp::vec_t<4, wp::float32>> & adj_warps,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.rgbd.seen_pixels.seen_brightness>:1
static CUDA_CALLABLE void adj_seen_brightness_0(
    wp::float32 var_u,
    wp::float32 var_v,
    wp::int32 var_level,
    wp::array_t<wp::vec_t<4, wp::int32>> var_frame__layout,
    wp::array_t<wp::float32> var_frame__brightness,
    wp::float32 & adj_u,
    wp::float32 & adj_v,
    wp::int32 & adj_level,
    wp::array_t<wp::vec_t<4, wp::int32>> & adj_frame__layout,
    wp::array_t<wp::float32> & adj_frame__brightness,
    wp::vec_t<4, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.rgbd.check_rows.summed>:1
static CUDA_CALLABLE void adj_summed_0(
    wp::vec_t<28, wp::float32> var_sums,
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<28, wp::float32> & adj_sums,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<28, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.rgbd.check_rows.sum_consistency_element>:1
static CUDA_CALLABLE void adj_sum_consistency_element_0(
    wp::array_t<wp::vec_t<4, wp::int32>> var_source__layout,
    wp::array_t<wp::vec_t<4, wp::float32>> var_source__lenses,
    wp::array_t<wp::float32> var_source__depth,
    wp::array_t<wp::float32> var_source__brightness,
    wp::array_t<wp::vec_t<4, wp::float32>> var_source__planes,
    wp::array_t<wp::vec_t<4, wp::int32>> var_target__layout,
    wp::array_t<wp::vec_t<4, wp::float32>> var_target__lenses,
    wp::array_t<wp::float32> var_target__depth,
    wp::array_t<wp::float32> var_target__brightness,
    wp::array_t<wp::vec_t<4, wp::float32>> var_target__planes,
    wp::int32 var_level,
    wp::int32 var_other,
    wp::array_t<wp::vec_t<4, wp::float32>> var_warps,
    wp::array_t<wp::float32> var_scales,
    wp::int32 var_e,
    wp::array_t<wp::vec_t<4, wp::int32>> & adj_source__layout,
    wp::array_t<wp::vec_t<4, wp::float32>> & adj_source__lenses,
    wp::array_t<wp::float32> & adj_source__depth,
    wp::array_t<wp::float32> & adj_source__brightness,
    wp::array_t<wp::vec_t<4, wp::float32>> & adj_source__planes,
    wp::array_t<wp::vec_t<4, wp::int32>> & adj_target__layout,
    wp::array_t<wp::vec_t<4, wp::float32>> & adj_target__lenses,
    wp::array_t<wp::float32> & adj_target__depth,
    wp::array_t<wp::float32> & adj_target__brightness,
    wp::array_t<wp::vec_t<4, wp::float32>> & adj_target__planes,
    wp::int32 & adj_level,
    wp::int32 & adj_other,
    wp::array_t<wp::vec_t<4, wp::float32>> & adj_warps,
    wp::array_t<wp::float32> & adj_scales,
    wp::int32 & adj_e,
    wp::vec_t<28, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void sum_consistency_tiles_90a140bb_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<4, wp::int32>> var_source__layout,
    wp::array_t<wp::vec_t<4, wp::float32>> var_source__lenses,
    wp::array_t<wp::float32> var_source__depth,
    wp::array_t<wp::float32> var_source__brightness,
    wp::array_t<wp::vec_t<4, wp::float32>> var_source__planes,
    wp::array_t<wp::vec_t<4, wp::int32>> var_target__layout,
    wp::array_t<wp::vec_t<4, wp::float32>> var_target__lenses,
    wp::array_t<wp::float32> var_target__depth,
    wp::array_t<wp::float32> var_target__brightness,
    wp::array_t<wp::vec_t<4, wp::float32>> var_target__planes,
    wp::int32 var_level,
    wp::int32 var_other,
    wp::array_t<wp::vec_t<4, wp::float32>> var_warps,
    wp::array_t<wp::float32> var_scales,
    wp::int32 var_count_,
    wp::array_t<wp::vec_t<28, wp::float64>> var_partials_)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::vec_t<28, wp::float64> var_1;
        bool var_2;
        wp::vec_t<28, wp::float64> var_3;
        wp::vec_t<28, wp::float64> var_4;
        const wp::int32 var_5 = 0;
        wp::float64 var_6;
        const wp::int32 var_7 = 1;
        wp::float64 var_8;
        const wp::int32 var_9 = 2;
        wp::float64 var_10;
        const wp::int32 var_11 = 3;
        wp::float64 var_12;
        wp::vec_t<4, wp::float64> var_13;
        const bool var_14 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_15 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_16 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_17 = 0;
        wp::vec_t<4, wp::float64> var_18;
        const wp::int32 var_19 = 0;
        wp::float64 var_20;
        const wp::int32 var_21 = 0;
        const wp::int32 var_22 = 1;
        wp::float64 var_23;
        const wp::int32 var_24 = 1;
        const wp::int32 var_25 = 2;
        wp::float64 var_26;
        const wp::int32 var_27 = 2;
        const wp::int32 var_28 = 3;
        wp::float64 var_29;
        const wp::int32 var_30 = 3;
        const wp::int32 var_31 = 4;
        wp::float64 var_32;
        const wp::int32 var_33 = 5;
        wp::float64 var_34;
        const wp::int32 var_35 = 6;
        wp::float64 var_36;
        const wp::int32 var_37 = 7;
        wp::float64 var_38;
        wp::vec_t<4, wp::float64> var_39;
        const bool var_40 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_41 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_42 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_43 = 0;
        wp::vec_t<4, wp::float64> var_44;
        const wp::int32 var_45 = 0;
        wp::float64 var_46;
        const wp::int32 var_47 = 4;
        const wp::int32 var_48 = 1;
        wp::float64 var_49;
        const wp::int32 var_50 = 5;
        const wp::int32 var_51 = 2;
        wp::float64 var_52;
        const wp::int32 var_53 = 6;
        const wp::int32 var_54 = 3;
        wp::float64 var_55;
        const wp::int32 var_56 = 7;
        const wp::int32 var_57 = 8;
        wp::float64 var_58;
        const wp::int32 var_59 = 9;
        wp::float64 var_60;
        const wp::int32 var_61 = 10;
        wp::float64 var_62;
        const wp::int32 var_63 = 11;
        wp::float64 var_64;
        wp::vec_t<4, wp::float64> var_65;
        const bool var_66 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_67 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_68 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_69 = 0;
        wp::vec_t<4, wp::float64> var_70;
        const wp::int32 var_71 = 0;
        wp::float64 var_72;
        const wp::int32 var_73 = 8;
        const wp::int32 var_74 = 1;
        wp::float64 var_75;
        const wp::int32 var_76 = 9;
        const wp::int32 var_77 = 2;
        wp::float64 var_78;
        const wp::int32 var_79 = 10;
        const wp::int32 var_80 = 3;
        wp::float64 var_81;
        const wp::int32 var_82 = 11;
        const wp::int32 var_83 = 12;
        wp::float64 var_84;
        const wp::int32 var_85 = 13;
        wp::float64 var_86;
        const wp::int32 var_87 = 14;
        wp::float64 var_88;
        const wp::int32 var_89 = 15;
        wp::float64 var_90;
        wp::vec_t<4, wp::float64> var_91;
        const bool var_92 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_93 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_94 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_95 = 0;
        wp::vec_t<4, wp::float64> var_96;
        const wp::int32 var_97 = 0;
        wp::float64 var_98;
        const wp::int32 var_99 = 12;
        const wp::int32 var_100 = 1;
        wp::float64 var_101;
        const wp::int32 var_102 = 13;
        const wp::int32 var_103 = 2;
        wp::float64 var_104;
        const wp::int32 var_105 = 14;
        const wp::int32 var_106 = 3;
        wp::float64 var_107;
        const wp::int32 var_108 = 15;
        const wp::int32 var_109 = 16;
        wp::float64 var_110;
        const wp::int32 var_111 = 17;
        wp::float64 var_112;
        const wp::int32 var_113 = 18;
        wp::float64 var_114;
        const wp::int32 var_115 = 19;
        wp::float64 var_116;
        wp::vec_t<4, wp::float64> var_117;
        const bool var_118 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_119 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_120 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_121 = 0;
        wp::vec_t<4, wp::float64> var_122;
        const wp::int32 var_123 = 0;
        wp::float64 var_124;
        const wp::int32 var_125 = 16;
        const wp::int32 var_126 = 1;
        wp::float64 var_127;
        const wp::int32 var_128 = 17;
        const wp::int32 var_129 = 2;
        wp::float64 var_130;
        const wp::int32 var_131 = 18;
        const wp::int32 var_132 = 3;
        wp::float64 var_133;
        const wp::int32 var_134 = 19;
        const wp::int32 var_135 = 20;
        wp::float64 var_136;
        const wp::int32 var_137 = 21;
        wp::float64 var_138;
        const wp::int32 var_139 = 22;
        wp::float64 var_140;
        const wp::int32 var_141 = 23;
        wp::float64 var_142;
        wp::vec_t<4, wp::float64> var_143;
        const bool var_144 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_145 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_146 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_147 = 0;
        wp::vec_t<4, wp::float64> var_148;
        const wp::int32 var_149 = 0;
        wp::float64 var_150;
        const wp::int32 var_151 = 20;
        const wp::int32 var_152 = 1;
        wp::float64 var_153;
        const wp::int32 var_154 = 21;
        const wp::int32 var_155 = 2;
        wp::float64 var_156;
        const wp::int32 var_157 = 22;
        const wp::int32 var_158 = 3;
        wp::float64 var_159;
        const wp::int32 var_160 = 23;
        const wp::int32 var_161 = 24;
        wp::float64 var_162;
        const wp::int32 var_163 = 25;
        wp::float64 var_164;
        const wp::int32 var_165 = 26;
        wp::float64 var_166;
        const wp::int32 var_167 = 27;
        wp::float64 var_168;
        wp::vec_t<4, wp::float64> var_169;
        const bool var_170 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_171 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_172 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_173 = 0;
        wp::vec_t<4, wp::float64> var_174;
        const wp::int32 var_175 = 0;
        wp::float64 var_176;
        const wp::int32 var_177 = 24;
        const wp::int32 var_178 = 1;
        wp::float64 var_179;
        const wp::int32 var_180 = 25;
        const wp::int32 var_181 = 2;
        wp::float64 var_182;
        const wp::int32 var_183 = 26;
        const wp::int32 var_184 = 3;
        wp::float64 var_185;
        const wp::int32 var_186 = 27;
        const wp::int32 var_187 = 256;
        wp::int32 var_188;
        const wp::int32 var_189 = 0;
        bool var_190;
        const wp::int32 var_191 = 256;
        wp::int32 var_192;
        //---------
        // forward
        // def sum_consistency_tiles(source__layout, source__lenses, source__depth, source__brightness, source__planes, target__layout, target__lenses, target__depth, target__brightness, target__planes, level, other, warps, scales, count_, partials_):       <L 1>
        // i_ = wp.tid()                                                                          <L 2>
        var_0 = builtin_tid1d();
        // value_ = vector_()                                                                     <L 3>
        var_1 = wp::vec_t<28, wp::float64>();
        // if i_ < count_:                                                                        <L 4>
        var_2 = (var_0 < var_count_);
        if (var_2) {
            // value_ = element_(source__layout, source__lenses, source__depth, source__brightness, source__planes, target__layout, target__lenses, target__depth, target__brightness, target__planes, level, other, warps, scales, i_)       <L 5>
            var_3 = sum_consistency_element_0(var_source__layout, var_source__lenses, var_source__depth, var_source__brightness, var_source__planes, var_target__layout, var_target__lenses, var_target__depth, var_target__brightness, var_target__planes, var_level, var_other, var_warps, var_scales, var_0);
        }
        var_4 = wp::where(var_2, var_3, var_1);
        // part_0 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[0], value_[1], value_[2], value_[3]), preserve_type=True)), 0)       <L 6>
        var_6 = wp::extract(var_4, var_5);
        var_8 = wp::extract(var_4, var_7);
        var_10 = wp::extract(var_4, var_9);
        var_12 = wp::extract(var_4, var_11);
        var_13 = wp::vec_t<4, wp::float64>(var_6, var_8, var_10, var_12);
        var_15 = wp::tile<wp::vec_t<4, wp::float64>>(var_13);
        var_16 = wp::tile_sum(var_15);
        var_18 = wp::tile_extract(var_16, var_17);
        // value_[0] = part_0[0]                                                                  <L 7>
        var_20 = wp::extract(var_18, var_19);
        wp::assign_inplace(var_4, var_21, var_20);
        // value_[1] = part_0[1]                                                                  <L 8>
        var_23 = wp::extract(var_18, var_22);
        wp::assign_inplace(var_4, var_24, var_23);
        // value_[2] = part_0[2]                                                                  <L 9>
        var_26 = wp::extract(var_18, var_25);
        wp::assign_inplace(var_4, var_27, var_26);
        // value_[3] = part_0[3]                                                                  <L 10>
        var_29 = wp::extract(var_18, var_28);
        wp::assign_inplace(var_4, var_30, var_29);
        // part_4 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[4], value_[5], value_[6], value_[7]), preserve_type=True)), 0)       <L 11>
        var_32 = wp::extract(var_4, var_31);
        var_34 = wp::extract(var_4, var_33);
        var_36 = wp::extract(var_4, var_35);
        var_38 = wp::extract(var_4, var_37);
        var_39 = wp::vec_t<4, wp::float64>(var_32, var_34, var_36, var_38);
        var_41 = wp::tile<wp::vec_t<4, wp::float64>>(var_39);
        var_42 = wp::tile_sum(var_41);
        var_44 = wp::tile_extract(var_42, var_43);
        // value_[4] = part_4[0]                                                                  <L 12>
        var_46 = wp::extract(var_44, var_45);
        wp::assign_inplace(var_4, var_47, var_46);
        // value_[5] = part_4[1]                                                                  <L 13>
        var_49 = wp::extract(var_44, var_48);
        wp::assign_inplace(var_4, var_50, var_49);
        // value_[6] = part_4[2]                                                                  <L 14>
        var_52 = wp::extract(var_44, var_51);
        wp::assign_inplace(var_4, var_53, var_52);
        // value_[7] = part_4[3]                                                                  <L 15>
        var_55 = wp::extract(var_44, var_54);
        wp::assign_inplace(var_4, var_56, var_55);
        // part_8 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[8], value_[9], value_[10], value_[11]), preserve_type=True)), 0)       <L 16>
        var_58 = wp::extract(var_4, var_57);
        var_60 = wp::extract(var_4, var_59);
        var_62 = wp::extract(var_4, var_61);
        var_64 = wp::extract(var_4, var_63);
        var_65 = wp::vec_t<4, wp::float64>(var_58, var_60, var_62, var_64);
        var_67 = wp::tile<wp::vec_t<4, wp::float64>>(var_65);
        var_68 = wp::tile_sum(var_67);
        var_70 = wp::tile_extract(var_68, var_69);
        // value_[8] = part_8[0]                                                                  <L 17>
        var_72 = wp::extract(var_70, var_71);
        wp::assign_inplace(var_4, var_73, var_72);
        // value_[9] = part_8[1]                                                                  <L 18>
        var_75 = wp::extract(var_70, var_74);
        wp::assign_inplace(var_4, var_76, var_75);
        // value_[10] = part_8[2]                                                                 <L 19>
        var_78 = wp::extract(var_70, var_77);
        wp::assign_inplace(var_4, var_79, var_78);
        // value_[11] = part_8[3]                                                                 <L 20>
        var_81 = wp::extract(var_70, var_80);
        wp::assign_inplace(var_4, var_82, var_81);
        // part_12 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[12], value_[13], value_[14], value_[15]), preserve_type=True)), 0)       <L 21>
        var_84 = wp::extract(var_4, var_83);
        var_86 = wp::extract(var_4, var_85);
        var_88 = wp::extract(var_4, var_87);
        var_90 = wp::extract(var_4, var_89);
        var_91 = wp::vec_t<4, wp::float64>(var_84, var_86, var_88, var_90);
        var_93 = wp::tile<wp::vec_t<4, wp::float64>>(var_91);
        var_94 = wp::tile_sum(var_93);
        var_96 = wp::tile_extract(var_94, var_95);
        // value_[12] = part_12[0]                                                                <L 22>
        var_98 = wp::extract(var_96, var_97);
        wp::assign_inplace(var_4, var_99, var_98);
        // value_[13] = part_12[1]                                                                <L 23>
        var_101 = wp::extract(var_96, var_100);
        wp::assign_inplace(var_4, var_102, var_101);
        // value_[14] = part_12[2]                                                                <L 24>
        var_104 = wp::extract(var_96, var_103);
        wp::assign_inplace(var_4, var_105, var_104);
        // value_[15] = part_12[3]                                                                <L 25>
        var_107 = wp::extract(var_96, var_106);
        wp::assign_inplace(var_4, var_108, var_107);
        // part_16 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[16], value_[17], value_[18], value_[19]), preserve_type=True)), 0)       <L 26>
        var_110 = wp::extract(var_4, var_109);
        var_112 = wp::extract(var_4, var_111);
        var_114 = wp::extract(var_4, var_113);
        var_116 = wp::extract(var_4, var_115);
        var_117 = wp::vec_t<4, wp::float64>(var_110, var_112, var_114, var_116);
        var_119 = wp::tile<wp::vec_t<4, wp::float64>>(var_117);
        var_120 = wp::tile_sum(var_119);
        var_122 = wp::tile_extract(var_120, var_121);
        // value_[16] = part_16[0]                                                                <L 27>
        var_124 = wp::extract(var_122, var_123);
        wp::assign_inplace(var_4, var_125, var_124);
        // value_[17] = part_16[1]                                                                <L 28>
        var_127 = wp::extract(var_122, var_126);
        wp::assign_inplace(var_4, var_128, var_127);
        // value_[18] = part_16[2]                                                                <L 29>
        var_130 = wp::extract(var_122, var_129);
        wp::assign_inplace(var_4, var_131, var_130);
        // value_[19] = part_16[3]                                                                <L 30>
        var_133 = wp::extract(var_122, var_132);
        wp::assign_inplace(var_4, var_134, var_133);
        // part_20 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[20], value_[21], value_[22], value_[23]), preserve_type=True)), 0)       <L 31>
        var_136 = wp::extract(var_4, var_135);
        var_138 = wp::extract(var_4, var_137);
        var_140 = wp::extract(var_4, var_139);
        var_142 = wp::extract(var_4, var_141);
        var_143 = wp::vec_t<4, wp::float64>(var_136, var_138, var_140, var_142);
        var_145 = wp::tile<wp::vec_t<4, wp::float64>>(var_143);
        var_146 = wp::tile_sum(var_145);
        var_148 = wp::tile_extract(var_146, var_147);
        // value_[20] = part_20[0]                                                                <L 32>
        var_150 = wp::extract(var_148, var_149);
        wp::assign_inplace(var_4, var_151, var_150);
        // value_[21] = part_20[1]                                                                <L 33>
        var_153 = wp::extract(var_148, var_152);
        wp::assign_inplace(var_4, var_154, var_153);
        // value_[22] = part_20[2]                                                                <L 34>
        var_156 = wp::extract(var_148, var_155);
        wp::assign_inplace(var_4, var_157, var_156);
        // value_[23] = part_20[3]                                                                <L 35>
        var_159 = wp::extract(var_148, var_158);
        wp::assign_inplace(var_4, var_160, var_159);
        // part_24 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[24], value_[25], value_[26], value_[27]), preserve_type=True)), 0)       <L 36>
        var_162 = wp::extract(var_4, var_161);
        var_164 = wp::extract(var_4, var_163);
        var_166 = wp::extract(var_4, var_165);
        var_168 = wp::extract(var_4, var_167);
        var_169 = wp::vec_t<4, wp::float64>(var_162, var_164, var_166, var_168);
        var_171 = wp::tile<wp::vec_t<4, wp::float64>>(var_169);
        var_172 = wp::tile_sum(var_171);
        var_174 = wp::tile_extract(var_172, var_173);
        // value_[24] = part_24[0]                                                                <L 37>
        var_176 = wp::extract(var_174, var_175);
        wp::assign_inplace(var_4, var_177, var_176);
        // value_[25] = part_24[1]                                                                <L 38>
        var_179 = wp::extract(var_174, var_178);
        wp::assign_inplace(var_4, var_180, var_179);
        // value_[26] = part_24[2]                                                                <L 39>
        var_182 = wp::extract(var_174, var_181);
        wp::assign_inplace(var_4, var_183, var_182);
        // value_[27] = part_24[3]                                                                <L 40>
        var_185 = wp::extract(var_174, var_184);
        wp::assign_inplace(var_4, var_186, var_185);
        // if i_ % 256 == 0:                                                                      <L 41>
        var_188 = wp::mod(var_0, var_187);
        var_190 = (var_188 == var_189);
        if (var_190) {
            // partials_[i_ // 256] = value_                                                      <L 42>
            var_192 = wp::floordiv(var_0, var_191);
            wp::array_store(var_partials_, var_192, var_4);
        }
}



extern "C" __global__ void sum_consistency_fold_tiles_ecdc4fb2_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::int32 var_count_,
    wp::array_t<wp::vec_t<28, wp::float64>> var_partials_,
    wp::array_t<wp::vec_t<28, wp::float64>> var_out_)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::vec_t<28, wp::float64> var_1;
        const wp::int32 var_2 = 256;
        wp::range_t var_3;
        wp::int32 var_4;
        wp::vec_t<28, wp::float64>* var_5;
        wp::vec_t<28, wp::float64> var_6;
        wp::vec_t<28, wp::float64> var_7;
        const wp::int32 var_8 = 0;
        wp::float64 var_9;
        const wp::int32 var_10 = 1;
        wp::float64 var_11;
        const wp::int32 var_12 = 2;
        wp::float64 var_13;
        const wp::int32 var_14 = 3;
        wp::float64 var_15;
        wp::vec_t<4, wp::float64> var_16;
        const bool var_17 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_18 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_19 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_20 = 0;
        wp::vec_t<4, wp::float64> var_21;
        const wp::int32 var_22 = 0;
        wp::float64 var_23;
        const wp::int32 var_24 = 0;
        const wp::int32 var_25 = 1;
        wp::float64 var_26;
        const wp::int32 var_27 = 1;
        const wp::int32 var_28 = 2;
        wp::float64 var_29;
        const wp::int32 var_30 = 2;
        const wp::int32 var_31 = 3;
        wp::float64 var_32;
        const wp::int32 var_33 = 3;
        const wp::int32 var_34 = 4;
        wp::float64 var_35;
        const wp::int32 var_36 = 5;
        wp::float64 var_37;
        const wp::int32 var_38 = 6;
        wp::float64 var_39;
        const wp::int32 var_40 = 7;
        wp::float64 var_41;
        wp::vec_t<4, wp::float64> var_42;
        const bool var_43 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_44 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_45 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_46 = 0;
        wp::vec_t<4, wp::float64> var_47;
        const wp::int32 var_48 = 0;
        wp::float64 var_49;
        const wp::int32 var_50 = 4;
        const wp::int32 var_51 = 1;
        wp::float64 var_52;
        const wp::int32 var_53 = 5;
        const wp::int32 var_54 = 2;
        wp::float64 var_55;
        const wp::int32 var_56 = 6;
        const wp::int32 var_57 = 3;
        wp::float64 var_58;
        const wp::int32 var_59 = 7;
        const wp::int32 var_60 = 8;
        wp::float64 var_61;
        const wp::int32 var_62 = 9;
        wp::float64 var_63;
        const wp::int32 var_64 = 10;
        wp::float64 var_65;
        const wp::int32 var_66 = 11;
        wp::float64 var_67;
        wp::vec_t<4, wp::float64> var_68;
        const bool var_69 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_70 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_71 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_72 = 0;
        wp::vec_t<4, wp::float64> var_73;
        const wp::int32 var_74 = 0;
        wp::float64 var_75;
        const wp::int32 var_76 = 8;
        const wp::int32 var_77 = 1;
        wp::float64 var_78;
        const wp::int32 var_79 = 9;
        const wp::int32 var_80 = 2;
        wp::float64 var_81;
        const wp::int32 var_82 = 10;
        const wp::int32 var_83 = 3;
        wp::float64 var_84;
        const wp::int32 var_85 = 11;
        const wp::int32 var_86 = 12;
        wp::float64 var_87;
        const wp::int32 var_88 = 13;
        wp::float64 var_89;
        const wp::int32 var_90 = 14;
        wp::float64 var_91;
        const wp::int32 var_92 = 15;
        wp::float64 var_93;
        wp::vec_t<4, wp::float64> var_94;
        const bool var_95 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_96 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_97 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_98 = 0;
        wp::vec_t<4, wp::float64> var_99;
        const wp::int32 var_100 = 0;
        wp::float64 var_101;
        const wp::int32 var_102 = 12;
        const wp::int32 var_103 = 1;
        wp::float64 var_104;
        const wp::int32 var_105 = 13;
        const wp::int32 var_106 = 2;
        wp::float64 var_107;
        const wp::int32 var_108 = 14;
        const wp::int32 var_109 = 3;
        wp::float64 var_110;
        const wp::int32 var_111 = 15;
        const wp::int32 var_112 = 16;
        wp::float64 var_113;
        const wp::int32 var_114 = 17;
        wp::float64 var_115;
        const wp::int32 var_116 = 18;
        wp::float64 var_117;
        const wp::int32 var_118 = 19;
        wp::float64 var_119;
        wp::vec_t<4, wp::float64> var_120;
        const bool var_121 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_122 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_123 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_124 = 0;
        wp::vec_t<4, wp::float64> var_125;
        const wp::int32 var_126 = 0;
        wp::float64 var_127;
        const wp::int32 var_128 = 16;
        const wp::int32 var_129 = 1;
        wp::float64 var_130;
        const wp::int32 var_131 = 17;
        const wp::int32 var_132 = 2;
        wp::float64 var_133;
        const wp::int32 var_134 = 18;
        const wp::int32 var_135 = 3;
        wp::float64 var_136;
        const wp::int32 var_137 = 19;
        const wp::int32 var_138 = 20;
        wp::float64 var_139;
        const wp::int32 var_140 = 21;
        wp::float64 var_141;
        const wp::int32 var_142 = 22;
        wp::float64 var_143;
        const wp::int32 var_144 = 23;
        wp::float64 var_145;
        wp::vec_t<4, wp::float64> var_146;
        const bool var_147 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_148 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_149 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_150 = 0;
        wp::vec_t<4, wp::float64> var_151;
        const wp::int32 var_152 = 0;
        wp::float64 var_153;
        const wp::int32 var_154 = 20;
        const wp::int32 var_155 = 1;
        wp::float64 var_156;
        const wp::int32 var_157 = 21;
        const wp::int32 var_158 = 2;
        wp::float64 var_159;
        const wp::int32 var_160 = 22;
        const wp::int32 var_161 = 3;
        wp::float64 var_162;
        const wp::int32 var_163 = 23;
        const wp::int32 var_164 = 24;
        wp::float64 var_165;
        const wp::int32 var_166 = 25;
        wp::float64 var_167;
        const wp::int32 var_168 = 26;
        wp::float64 var_169;
        const wp::int32 var_170 = 27;
        wp::float64 var_171;
        wp::vec_t<4, wp::float64> var_172;
        const bool var_173 = true;
        wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_174 = wp::tile_register_t<wp::vec_t<4, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<4, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_175 = wp::tile_alloc_empty<wp::vec_t<4, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_176 = 0;
        wp::vec_t<4, wp::float64> var_177;
        const wp::int32 var_178 = 0;
        wp::float64 var_179;
        const wp::int32 var_180 = 24;
        const wp::int32 var_181 = 1;
        wp::float64 var_182;
        const wp::int32 var_183 = 25;
        const wp::int32 var_184 = 2;
        wp::float64 var_185;
        const wp::int32 var_186 = 26;
        const wp::int32 var_187 = 3;
        wp::float64 var_188;
        const wp::int32 var_189 = 27;
        const wp::int32 var_190 = 0;
        bool var_191;
        const wp::int32 var_192 = 0;
        //---------
        // forward
        // def sum_consistency_fold_tiles(count_, partials_, out_):                               <L 1>
        // i_ = wp.tid()                                                                          <L 2>
        var_0 = builtin_tid1d();
        // value_ = vector_()                                                                     <L 3>
        var_1 = wp::vec_t<28, wp::float64>();
        // for j_ in range(i_, count_, 256):                                                      <L 4>
        var_3 = wp::range(var_0, var_count_, var_2);
        start_for_0:;
            if (iter_cmp(var_3) == 0) goto end_for_0;
            var_4 = wp::iter_next(var_3);
            // value_ += partials_[j_]                                                            <L 5>
            var_5 = wp::address(var_partials_, var_4);
            var_7 = wp::load(var_5);
            var_6 = wp::add(var_1, var_7);
            wp::assign(var_1, var_6);
            goto start_for_0;
        end_for_0:;
        // part_0 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[0], value_[1], value_[2], value_[3]), preserve_type=True)), 0)       <L 6>
        var_9 = wp::extract(var_1, var_8);
        var_11 = wp::extract(var_1, var_10);
        var_13 = wp::extract(var_1, var_12);
        var_15 = wp::extract(var_1, var_14);
        var_16 = wp::vec_t<4, wp::float64>(var_9, var_11, var_13, var_15);
        var_18 = wp::tile<wp::vec_t<4, wp::float64>>(var_16);
        var_19 = wp::tile_sum(var_18);
        var_21 = wp::tile_extract(var_19, var_20);
        // value_[0] = part_0[0]                                                                  <L 7>
        var_23 = wp::extract(var_21, var_22);
        wp::assign_inplace(var_1, var_24, var_23);
        // value_[1] = part_0[1]                                                                  <L 8>
        var_26 = wp::extract(var_21, var_25);
        wp::assign_inplace(var_1, var_27, var_26);
        // value_[2] = part_0[2]                                                                  <L 9>
        var_29 = wp::extract(var_21, var_28);
        wp::assign_inplace(var_1, var_30, var_29);
        // value_[3] = part_0[3]                                                                  <L 10>
        var_32 = wp::extract(var_21, var_31);
        wp::assign_inplace(var_1, var_33, var_32);
        // part_4 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[4], value_[5], value_[6], value_[7]), preserve_type=True)), 0)       <L 11>
        var_35 = wp::extract(var_1, var_34);
        var_37 = wp::extract(var_1, var_36);
        var_39 = wp::extract(var_1, var_38);
        var_41 = wp::extract(var_1, var_40);
        var_42 = wp::vec_t<4, wp::float64>(var_35, var_37, var_39, var_41);
        var_44 = wp::tile<wp::vec_t<4, wp::float64>>(var_42);
        var_45 = wp::tile_sum(var_44);
        var_47 = wp::tile_extract(var_45, var_46);
        // value_[4] = part_4[0]                                                                  <L 12>
        var_49 = wp::extract(var_47, var_48);
        wp::assign_inplace(var_1, var_50, var_49);
        // value_[5] = part_4[1]                                                                  <L 13>
        var_52 = wp::extract(var_47, var_51);
        wp::assign_inplace(var_1, var_53, var_52);
        // value_[6] = part_4[2]                                                                  <L 14>
        var_55 = wp::extract(var_47, var_54);
        wp::assign_inplace(var_1, var_56, var_55);
        // value_[7] = part_4[3]                                                                  <L 15>
        var_58 = wp::extract(var_47, var_57);
        wp::assign_inplace(var_1, var_59, var_58);
        // part_8 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[8], value_[9], value_[10], value_[11]), preserve_type=True)), 0)       <L 16>
        var_61 = wp::extract(var_1, var_60);
        var_63 = wp::extract(var_1, var_62);
        var_65 = wp::extract(var_1, var_64);
        var_67 = wp::extract(var_1, var_66);
        var_68 = wp::vec_t<4, wp::float64>(var_61, var_63, var_65, var_67);
        var_70 = wp::tile<wp::vec_t<4, wp::float64>>(var_68);
        var_71 = wp::tile_sum(var_70);
        var_73 = wp::tile_extract(var_71, var_72);
        // value_[8] = part_8[0]                                                                  <L 17>
        var_75 = wp::extract(var_73, var_74);
        wp::assign_inplace(var_1, var_76, var_75);
        // value_[9] = part_8[1]                                                                  <L 18>
        var_78 = wp::extract(var_73, var_77);
        wp::assign_inplace(var_1, var_79, var_78);
        // value_[10] = part_8[2]                                                                 <L 19>
        var_81 = wp::extract(var_73, var_80);
        wp::assign_inplace(var_1, var_82, var_81);
        // value_[11] = part_8[3]                                                                 <L 20>
        var_84 = wp::extract(var_73, var_83);
        wp::assign_inplace(var_1, var_85, var_84);
        // part_12 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[12], value_[13], value_[14], value_[15]), preserve_type=True)), 0)       <L 21>
        var_87 = wp::extract(var_1, var_86);
        var_89 = wp::extract(var_1, var_88);
        var_91 = wp::extract(var_1, var_90);
        var_93 = wp::extract(var_1, var_92);
        var_94 = wp::vec_t<4, wp::float64>(var_87, var_89, var_91, var_93);
        var_96 = wp::tile<wp::vec_t<4, wp::float64>>(var_94);
        var_97 = wp::tile_sum(var_96);
        var_99 = wp::tile_extract(var_97, var_98);
        // value_[12] = part_12[0]                                                                <L 22>
        var_101 = wp::extract(var_99, var_100);
        wp::assign_inplace(var_1, var_102, var_101);
        // value_[13] = part_12[1]                                                                <L 23>
        var_104 = wp::extract(var_99, var_103);
        wp::assign_inplace(var_1, var_105, var_104);
        // value_[14] = part_12[2]                                                                <L 24>
        var_107 = wp::extract(var_99, var_106);
        wp::assign_inplace(var_1, var_108, var_107);
        // value_[15] = part_12[3]                                                                <L 25>
        var_110 = wp::extract(var_99, var_109);
        wp::assign_inplace(var_1, var_111, var_110);
        // part_16 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[16], value_[17], value_[18], value_[19]), preserve_type=True)), 0)       <L 26>
        var_113 = wp::extract(var_1, var_112);
        var_115 = wp::extract(var_1, var_114);
        var_117 = wp::extract(var_1, var_116);
        var_119 = wp::extract(var_1, var_118);
        var_120 = wp::vec_t<4, wp::float64>(var_113, var_115, var_117, var_119);
        var_122 = wp::tile<wp::vec_t<4, wp::float64>>(var_120);
        var_123 = wp::tile_sum(var_122);
        var_125 = wp::tile_extract(var_123, var_124);
        // value_[16] = part_16[0]                                                                <L 27>
        var_127 = wp::extract(var_125, var_126);
        wp::assign_inplace(var_1, var_128, var_127);
        // value_[17] = part_16[1]                                                                <L 28>
        var_130 = wp::extract(var_125, var_129);
        wp::assign_inplace(var_1, var_131, var_130);
        // value_[18] = part_16[2]                                                                <L 29>
        var_133 = wp::extract(var_125, var_132);
        wp::assign_inplace(var_1, var_134, var_133);
        // value_[19] = part_16[3]                                                                <L 30>
        var_136 = wp::extract(var_125, var_135);
        wp::assign_inplace(var_1, var_137, var_136);
        // part_20 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[20], value_[21], value_[22], value_[23]), preserve_type=True)), 0)       <L 31>
        var_139 = wp::extract(var_1, var_138);
        var_141 = wp::extract(var_1, var_140);
        var_143 = wp::extract(var_1, var_142);
        var_145 = wp::extract(var_1, var_144);
        var_146 = wp::vec_t<4, wp::float64>(var_139, var_141, var_143, var_145);
        var_148 = wp::tile<wp::vec_t<4, wp::float64>>(var_146);
        var_149 = wp::tile_sum(var_148);
        var_151 = wp::tile_extract(var_149, var_150);
        // value_[20] = part_20[0]                                                                <L 32>
        var_153 = wp::extract(var_151, var_152);
        wp::assign_inplace(var_1, var_154, var_153);
        // value_[21] = part_20[1]                                                                <L 33>
        var_156 = wp::extract(var_151, var_155);
        wp::assign_inplace(var_1, var_157, var_156);
        // value_[22] = part_20[2]                                                                <L 34>
        var_159 = wp::extract(var_151, var_158);
        wp::assign_inplace(var_1, var_160, var_159);
        // value_[23] = part_20[3]                                                                <L 35>
        var_162 = wp::extract(var_151, var_161);
        wp::assign_inplace(var_1, var_163, var_162);
        // part_24 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[24], value_[25], value_[26], value_[27]), preserve_type=True)), 0)       <L 36>
        var_165 = wp::extract(var_1, var_164);
        var_167 = wp::extract(var_1, var_166);
        var_169 = wp::extract(var_1, var_168);
        var_171 = wp::extract(var_1, var_170);
        var_172 = wp::vec_t<4, wp::float64>(var_165, var_167, var_169, var_171);
        var_174 = wp::tile<wp::vec_t<4, wp::float64>>(var_172);
        var_175 = wp::tile_sum(var_174);
        var_177 = wp::tile_extract(var_175, var_176);
        // value_[24] = part_24[0]                                                                <L 37>
        var_179 = wp::extract(var_177, var_178);
        wp::assign_inplace(var_1, var_180, var_179);
        // value_[25] = part_24[1]                                                                <L 38>
        var_182 = wp::extract(var_177, var_181);
        wp::assign_inplace(var_1, var_183, var_182);
        // value_[26] = part_24[2]                                                                <L 39>
        var_185 = wp::extract(var_177, var_184);
        wp::assign_inplace(var_1, var_186, var_185);
        // value_[27] = part_24[3]                                                                <L 40>
        var_188 = wp::extract(var_177, var_187);
        wp::assign_inplace(var_1, var_189, var_188);
        // if i_ == 0:                                                                            <L 41>
        var_191 = (var_0 == var_190);
        if (var_191) {
            // out_[0] = value_                                                                   <L 42>
            wp::array_store(var_out_, var_192, var_1);
        }
}


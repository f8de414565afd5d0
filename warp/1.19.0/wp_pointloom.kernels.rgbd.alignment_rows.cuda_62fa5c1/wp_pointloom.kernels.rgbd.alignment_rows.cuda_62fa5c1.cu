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


// <pointloom.kernels.rgbd.seen_pixels.brightness_row>:1
static CUDA_CALLABLE wp::vec_t<6, wp::float32> brightness_row_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<4, wp::float32> var_sample,
    wp::int32 var_level,
    wp::array_t<wp::vec_t<4, wp::float32>> var_frame__lenses)
{
    //---------
    // primal vars
    wp::vec_t<4, wp::float32>* var_0;
    wp::vec_t<4, wp::float32> var_1;
    wp::vec_t<4, wp::float32> var_2;
    const wp::int32 var_3 = 1;
    wp::float32 var_4;
    const wp::int32 var_5 = 0;
    wp::float32 var_6;
    wp::float32 var_7;
    const wp::int32 var_8 = 2;
    wp::float32 var_9;
    wp::float32 var_10;
    const wp::int32 var_11 = 2;
    wp::float32 var_12;
    const wp::int32 var_13 = 1;
    wp::float32 var_14;
    wp::float32 var_15;
    const wp::int32 var_16 = 2;
    wp::float32 var_17;
    wp::float32 var_18;
    const wp::int32 var_19 = 0;
    wp::float32 var_20;
    wp::float32 var_21;
    const wp::int32 var_22 = 1;
    wp::float32 var_23;
    wp::float32 var_24;
    wp::float32 var_25;
    wp::float32 var_26;
    const wp::int32 var_27 = 2;
    wp::float32 var_28;
    wp::float32 var_29;
    const wp::int32 var_30 = 1;
    wp::float32 var_31;
    wp::float32 var_32;
    const wp::int32 var_33 = 2;
    wp::float32 var_34;
    wp::float32 var_35;
    wp::float32 var_36;
    const wp::int32 var_37 = 2;
    wp::float32 var_38;
    wp::float32 var_39;
    const wp::int32 var_40 = 0;
    wp::float32 var_41;
    wp::float32 var_42;
    wp::float32 var_43;
    const wp::int32 var_44 = 0;
    wp::float32 var_45;
    wp::float32 var_46;
    const wp::int32 var_47 = 1;
    wp::float32 var_48;
    wp::float32 var_49;
    wp::float32 var_50;
    wp::vec_t<6, wp::float32> var_51;
    //---------
    // forward
    // def brightness_row(p, sample, level, frame__lenses):                                   <L 1>
    // lens = frame__lenses[level]                                                            <L 2>
    var_0 = wp::address(var_frame__lenses, var_level);
    var_2 = wp::load(var_0);
    var_1 = wp::copy(var_2);
    // a = sample[1] * lens[0] / p[2]                                                         <L 3>
    var_4 = wp::extract(var_sample, var_3);
    var_6 = wp::extract(var_1, var_5);
    var_7 = wp::mul(var_4, var_6);
    var_9 = wp::extract(var_p, var_8);
    var_10 = wp::div(var_7, var_9);
    // b = sample[2] * lens[1] / p[2]                                                         <L 4>
    var_12 = wp::extract(var_sample, var_11);
    var_14 = wp::extract(var_1, var_13);
    var_15 = wp::mul(var_12, var_14);
    var_17 = wp::extract(var_p, var_16);
    var_18 = wp::div(var_15, var_17);
    // c = -(a * p[0] + b * p[1]) / p[2]                                                      <L 5>
    var_20 = wp::extract(var_p, var_19);
    var_21 = wp::mul(var_10, var_20);
    var_23 = wp::extract(var_p, var_22);
    var_24 = wp::mul(var_18, var_23);
    var_25 = wp::add(var_21, var_24);
    var_26 = wp::neg(var_25);
    var_28 = wp::extract(var_p, var_27);
    var_29 = wp::div(var_26, var_28);
    // return row(p[1] * c - p[2] * b, p[2] * a - p[0] * c, p[0] * b - p[1] * a, a, b, c)       <L 6>
    var_31 = wp::extract(var_p, var_30);
    var_32 = wp::mul(var_31, var_29);
    var_34 = wp::extract(var_p, var_33);
    var_35 = wp::mul(var_34, var_18);
    var_36 = wp::sub(var_32, var_35);
    var_38 = wp::extract(var_p, var_37);
    var_39 = wp::mul(var_38, var_10);
    var_41 = wp::extract(var_p, var_40);
    var_42 = wp::mul(var_41, var_29);
    var_43 = wp::sub(var_39, var_42);
    var_45 = wp::extract(var_p, var_44);
    var_46 = wp::mul(var_45, var_18);
    var_48 = wp::extract(var_p, var_47);
    var_49 = wp::mul(var_48, var_10);
    var_50 = wp::sub(var_46, var_49);
    var_51 = wp::vec_t<6, wp::float32>({var_36, var_43, var_50, var_10, var_18, var_29});
    return var_51;
}


// /work/main/src/pointloom/kernels/rgbd/seen_pixels.py:72
static CUDA_CALLABLE wp::vec_t<6, wp::float32> surface_row_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<4, wp::float32> var_plane)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float32> var_0;
    wp::vec_t<3, wp::float32> var_1;
    const wp::int32 var_2 = 0;
    wp::float32 var_3;
    const wp::int32 var_4 = 1;
    wp::float32 var_5;
    const wp::int32 var_6 = 2;
    wp::float32 var_7;
    const wp::int32 var_8 = 0;
    wp::float32 var_9;
    const wp::int32 var_10 = 1;
    wp::float32 var_11;
    const wp::int32 var_12 = 2;
    wp::float32 var_13;
    wp::vec_t<6, wp::float32> var_14;
    //---------
    // forward
    // def surface_row(p: vec3, plane: vec4) -> row:                                          <L 73>
    // n = axis(plane)                                                                        <L 74>
    var_0 = axis_0(var_plane);
    // moment = cross(p, n)                                                                   <L 75>
    var_1 = wp::cross(var_p, var_0);
    // return row(moment[0], moment[1], moment[2], n[0], n[1], n[2])                          <L 76>
    var_3 = wp::extract(var_1, var_2);
    var_5 = wp::extract(var_1, var_4);
    var_7 = wp::extract(var_1, var_6);
    var_9 = wp::extract(var_0, var_8);
    var_11 = wp::extract(var_0, var_10);
    var_13 = wp::extract(var_0, var_12);
    var_14 = wp::vec_t<6, wp::float32>({var_3, var_5, var_7, var_9, var_11, var_13});
    return var_14;
}


// /work/main/src/pointloom/kernels/rgbd/alignment_rows.py:79
static CUDA_CALLABLE wp::vec_t<38, wp::float64> sum_rows_0(
    wp::vec_t<6, wp::float32> var_g,
    wp::vec_t<6, wp::float32> var_j,
    wp::float32 var_r,
    wp::vec_t<6, wp::float32> var_h,
    wp::vec_t<6, wp::float32> var_k,
    wp::float32 var_s,
    wp::vec_t<11, wp::float32> var_extra)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    const wp::int32 var_2 = 0;
    wp::float32 var_3;
    wp::float32 var_4;
    const wp::int32 var_5 = 0;
    wp::float32 var_6;
    const wp::int32 var_7 = 0;
    wp::float32 var_8;
    wp::float32 var_9;
    wp::float32 var_10;
    wp::float64 var_11;
    const wp::int32 var_12 = 0;
    wp::float32 var_13;
    const wp::int32 var_14 = 1;
    wp::float32 var_15;
    wp::float32 var_16;
    const wp::int32 var_17 = 0;
    wp::float32 var_18;
    const wp::int32 var_19 = 1;
    wp::float32 var_20;
    wp::float32 var_21;
    wp::float32 var_22;
    wp::float64 var_23;
    const wp::int32 var_24 = 0;
    wp::float32 var_25;
    const wp::int32 var_26 = 2;
    wp::float32 var_27;
    wp::float32 var_28;
    const wp::int32 var_29 = 0;
    wp::float32 var_30;
    const wp::int32 var_31 = 2;
    wp::float32 var_32;
    wp::float32 var_33;
    wp::float32 var_34;
    wp::float64 var_35;
    const wp::int32 var_36 = 0;
    wp::float32 var_37;
    const wp::int32 var_38 = 3;
    wp::float32 var_39;
    wp::float32 var_40;
    const wp::int32 var_41 = 0;
    wp::float32 var_42;
    const wp::int32 var_43 = 3;
    wp::float32 var_44;
    wp::float32 var_45;
    wp::float32 var_46;
    wp::float64 var_47;
    const wp::int32 var_48 = 0;
    wp::float32 var_49;
    const wp::int32 var_50 = 4;
    wp::float32 var_51;
    wp::float32 var_52;
    const wp::int32 var_53 = 0;
    wp::float32 var_54;
    const wp::int32 var_55 = 4;
    wp::float32 var_56;
    wp::float32 var_57;
    wp::float32 var_58;
    wp::float64 var_59;
    const wp::int32 var_60 = 0;
    wp::float32 var_61;
    const wp::int32 var_62 = 5;
    wp::float32 var_63;
    wp::float32 var_64;
    const wp::int32 var_65 = 0;
    wp::float32 var_66;
    const wp::int32 var_67 = 5;
    wp::float32 var_68;
    wp::float32 var_69;
    wp::float32 var_70;
    wp::float64 var_71;
    const wp::int32 var_72 = 1;
    wp::float32 var_73;
    const wp::int32 var_74 = 1;
    wp::float32 var_75;
    wp::float32 var_76;
    const wp::int32 var_77 = 1;
    wp::float32 var_78;
    const wp::int32 var_79 = 1;
    wp::float32 var_80;
    wp::float32 var_81;
    wp::float32 var_82;
    wp::float64 var_83;
    const wp::int32 var_84 = 1;
    wp::float32 var_85;
    const wp::int32 var_86 = 2;
    wp::float32 var_87;
    wp::float32 var_88;
    const wp::int32 var_89 = 1;
    wp::float32 var_90;
    const wp::int32 var_91 = 2;
    wp::float32 var_92;
    wp::float32 var_93;
    wp::float32 var_94;
    wp::float64 var_95;
    const wp::int32 var_96 = 1;
    wp::float32 var_97;
    const wp::int32 var_98 = 3;
    wp::float32 var_99;
    wp::float32 var_100;
    const wp::int32 var_101 = 1;
    wp::float32 var_102;
    const wp::int32 var_103 = 3;
    wp::float32 var_104;
    wp::float32 var_105;
    wp::float32 var_106;
    wp::float64 var_107;
    const wp::int32 var_108 = 1;
    wp::float32 var_109;
    const wp::int32 var_110 = 4;
    wp::float32 var_111;
    wp::float32 var_112;
    const wp::int32 var_113 = 1;
    wp::float32 var_114;
    const wp::int32 var_115 = 4;
    wp::float32 var_116;
    wp::float32 var_117;
    wp::float32 var_118;
    wp::float64 var_119;
    const wp::int32 var_120 = 1;
    wp::float32 var_121;
    const wp::int32 var_122 = 5;
    wp::float32 var_123;
    wp::float32 var_124;
    const wp::int32 var_125 = 1;
    wp::float32 var_126;
    const wp::int32 var_127 = 5;
    wp::float32 var_128;
    wp::float32 var_129;
    wp::float32 var_130;
    wp::float64 var_131;
    const wp::int32 var_132 = 2;
    wp::float32 var_133;
    const wp::int32 var_134 = 2;
    wp::float32 var_135;
    wp::float32 var_136;
    const wp::int32 var_137 = 2;
    wp::float32 var_138;
    const wp::int32 var_139 = 2;
    wp::float32 var_140;
    wp::float32 var_141;
    wp::float32 var_142;
    wp::float64 var_143;
    const wp::int32 var_144 = 2;
    wp::float32 var_145;
    const wp::int32 var_146 = 3;
    wp::float32 var_147;
    wp::float32 var_148;
    const wp::int32 var_149 = 2;
    wp::float32 var_150;
    const wp::int32 var_151 = 3;
    wp::float32 var_152;
    wp::float32 var_153;
    wp::float32 var_154;
    wp::float64 var_155;
    const wp::int32 var_156 = 2;
    wp::float32 var_157;
    const wp::int32 var_158 = 4;
    wp::float32 var_159;
    wp::float32 var_160;
    const wp::int32 var_161 = 2;
    wp::float32 var_162;
    const wp::int32 var_163 = 4;
    wp::float32 var_164;
    wp::float32 var_165;
    wp::float32 var_166;
    wp::float64 var_167;
    const wp::int32 var_168 = 2;
    wp::float32 var_169;
    const wp::int32 var_170 = 5;
    wp::float32 var_171;
    wp::float32 var_172;
    const wp::int32 var_173 = 2;
    wp::float32 var_174;
    const wp::int32 var_175 = 5;
    wp::float32 var_176;
    wp::float32 var_177;
    wp::float32 var_178;
    wp::float64 var_179;
    const wp::int32 var_180 = 3;
    wp::float32 var_181;
    const wp::int32 var_182 = 3;
    wp::float32 var_183;
    wp::float32 var_184;
    const wp::int32 var_185 = 3;
    wp::float32 var_186;
    const wp::int32 var_187 = 3;
    wp::float32 var_188;
    wp::float32 var_189;
    wp::float32 var_190;
    wp::float64 var_191;
    const wp::int32 var_192 = 3;
    wp::float32 var_193;
    const wp::int32 var_194 = 4;
    wp::float32 var_195;
    wp::float32 var_196;
    const wp::int32 var_197 = 3;
    wp::float32 var_198;
    const wp::int32 var_199 = 4;
    wp::float32 var_200;
    wp::float32 var_201;
    wp::float32 var_202;
    wp::float64 var_203;
    const wp::int32 var_204 = 3;
    wp::float32 var_205;
    const wp::int32 var_206 = 5;
    wp::float32 var_207;
    wp::float32 var_208;
    const wp::int32 var_209 = 3;
    wp::float32 var_210;
    const wp::int32 var_211 = 5;
    wp::float32 var_212;
    wp::float32 var_213;
    wp::float32 var_214;
    wp::float64 var_215;
    const wp::int32 var_216 = 4;
    wp::float32 var_217;
    const wp::int32 var_218 = 4;
    wp::float32 var_219;
    wp::float32 var_220;
    const wp::int32 var_221 = 4;
    wp::float32 var_222;
    const wp::int32 var_223 = 4;
    wp::float32 var_224;
    wp::float32 var_225;
    wp::float32 var_226;
    wp::float64 var_227;
    const wp::int32 var_228 = 4;
    wp::float32 var_229;
    const wp::int32 var_230 = 5;
    wp::float32 var_231;
    wp::float32 var_232;
    const wp::int32 var_233 = 4;
    wp::float32 var_234;
    const wp::int32 var_235 = 5;
    wp::float32 var_236;
    wp::float32 var_237;
    wp::float32 var_238;
    wp::float64 var_239;
    const wp::int32 var_240 = 5;
    wp::float32 var_241;
    const wp::int32 var_242 = 5;
    wp::float32 var_243;
    wp::float32 var_244;
    const wp::int32 var_245 = 5;
    wp::float32 var_246;
    const wp::int32 var_247 = 5;
    wp::float32 var_248;
    wp::float32 var_249;
    wp::float32 var_250;
    wp::float64 var_251;
    const wp::int32 var_252 = 0;
    wp::float32 var_253;
    wp::float32 var_254;
    const wp::int32 var_255 = 0;
    wp::float32 var_256;
    wp::float32 var_257;
    wp::float32 var_258;
    wp::float64 var_259;
    const wp::int32 var_260 = 1;
    wp::float32 var_261;
    wp::float32 var_262;
    const wp::int32 var_263 = 1;
    wp::float32 var_264;
    wp::float32 var_265;
    wp::float32 var_266;
    wp::float64 var_267;
    const wp::int32 var_268 = 2;
    wp::float32 var_269;
    wp::float32 var_270;
    const wp::int32 var_271 = 2;
    wp::float32 var_272;
    wp::float32 var_273;
    wp::float32 var_274;
    wp::float64 var_275;
    const wp::int32 var_276 = 3;
    wp::float32 var_277;
    wp::float32 var_278;
    const wp::int32 var_279 = 3;
    wp::float32 var_280;
    wp::float32 var_281;
    wp::float32 var_282;
    wp::float64 var_283;
    const wp::int32 var_284 = 4;
    wp::float32 var_285;
    wp::float32 var_286;
    const wp::int32 var_287 = 4;
    wp::float32 var_288;
    wp::float32 var_289;
    wp::float32 var_290;
    wp::float64 var_291;
    const wp::int32 var_292 = 5;
    wp::float32 var_293;
    wp::float32 var_294;
    const wp::int32 var_295 = 5;
    wp::float32 var_296;
    wp::float32 var_297;
    wp::float32 var_298;
    wp::float64 var_299;
    const wp::int32 var_300 = 0;
    wp::float32 var_301;
    wp::float64 var_302;
    const wp::int32 var_303 = 1;
    wp::float32 var_304;
    wp::float64 var_305;
    const wp::int32 var_306 = 2;
    wp::float32 var_307;
    wp::float64 var_308;
    const wp::int32 var_309 = 3;
    wp::float32 var_310;
    wp::float64 var_311;
    const wp::int32 var_312 = 4;
    wp::float32 var_313;
    wp::float64 var_314;
    const wp::int32 var_315 = 5;
    wp::float32 var_316;
    wp::float64 var_317;
    const wp::int32 var_318 = 6;
    wp::float32 var_319;
    wp::float64 var_320;
    const wp::int32 var_321 = 7;
    wp::float32 var_322;
    wp::float64 var_323;
    const wp::int32 var_324 = 8;
    wp::float32 var_325;
    wp::float64 var_326;
    const wp::int32 var_327 = 9;
    wp::float32 var_328;
    wp::float64 var_329;
    const wp::int32 var_330 = 10;
    wp::float32 var_331;
    wp::float64 var_332;
    wp::vec_t<38, wp::float64> var_333;
    //---------
    // forward
    // def sum_rows(g: row, j: row, r: float, h: row, k: row, s: float, extra: extra_sums) -> row_sums:       <L 80>
    // return row_sums(                                                                       <L 82>
    // float64(g[0] * j[0] + h[0] * k[0]), float64(g[0] * j[1] + h[0] * k[1]),                <L 83>
    var_1 = wp::extract(var_g, var_0);
    var_3 = wp::extract(var_j, var_2);
    var_4 = wp::mul(var_1, var_3);
    var_6 = wp::extract(var_h, var_5);
    var_8 = wp::extract(var_k, var_7);
    var_9 = wp::mul(var_6, var_8);
    var_10 = wp::add(var_4, var_9);
    var_11 = wp::float64(var_10);
    var_13 = wp::extract(var_g, var_12);
    var_15 = wp::extract(var_j, var_14);
    var_16 = wp::mul(var_13, var_15);
    var_18 = wp::extract(var_h, var_17);
    var_20 = wp::extract(var_k, var_19);
    var_21 = wp::mul(var_18, var_20);
    var_22 = wp::add(var_16, var_21);
    var_23 = wp::float64(var_22);
    // float64(g[0] * j[2] + h[0] * k[2]), float64(g[0] * j[3] + h[0] * k[3]),                <L 84>
    var_25 = wp::extract(var_g, var_24);
    var_27 = wp::extract(var_j, var_26);
    var_28 = wp::mul(var_25, var_27);
    var_30 = wp::extract(var_h, var_29);
    var_32 = wp::extract(var_k, var_31);
    var_33 = wp::mul(var_30, var_32);
    var_34 = wp::add(var_28, var_33);
    var_35 = wp::float64(var_34);
    var_37 = wp::extract(var_g, var_36);
    var_39 = wp::extract(var_j, var_38);
    var_40 = wp::mul(var_37, var_39);
    var_42 = wp::extract(var_h, var_41);
    var_44 = wp::extract(var_k, var_43);
    var_45 = wp::mul(var_42, var_44);
    var_46 = wp::add(var_40, var_45);
    var_47 = wp::float64(var_46);
    // float64(g[0] * j[4] + h[0] * k[4]), float64(g[0] * j[5] + h[0] * k[5]),                <L 85>
    var_49 = wp::extract(var_g, var_48);
    var_51 = wp::extract(var_j, var_50);
    var_52 = wp::mul(var_49, var_51);
    var_54 = wp::extract(var_h, var_53);
    var_56 = wp::extract(var_k, var_55);
    var_57 = wp::mul(var_54, var_56);
    var_58 = wp::add(var_52, var_57);
    var_59 = wp::float64(var_58);
    var_61 = wp::extract(var_g, var_60);
    var_63 = wp::extract(var_j, var_62);
    var_64 = wp::mul(var_61, var_63);
    var_66 = wp::extract(var_h, var_65);
    var_68 = wp::extract(var_k, var_67);
    var_69 = wp::mul(var_66, var_68);
    var_70 = wp::add(var_64, var_69);
    var_71 = wp::float64(var_70);
    // float64(g[1] * j[1] + h[1] * k[1]), float64(g[1] * j[2] + h[1] * k[2]),                <L 86>
    var_73 = wp::extract(var_g, var_72);
    var_75 = wp::extract(var_j, var_74);
    var_76 = wp::mul(var_73, var_75);
    var_78 = wp::extract(var_h, var_77);
    var_80 = wp::extract(var_k, var_79);
    var_81 = wp::mul(var_78, var_80);
    var_82 = wp::add(var_76, var_81);
    var_83 = wp::float64(var_82);
    var_85 = wp::extract(var_g, var_84);
    var_87 = wp::extract(var_j, var_86);
    var_88 = wp::mul(var_85, var_87);
    var_90 = wp::extract(var_h, var_89);
    var_92 = wp::extract(var_k, var_91);
    var_93 = wp::mul(var_90, var_92);
    var_94 = wp::add(var_88, var_93);
    var_95 = wp::float64(var_94);
    // float64(g[1] * j[3] + h[1] * k[3]), float64(g[1] * j[4] + h[1] * k[4]),                <L 87>
    var_97 = wp::extract(var_g, var_96);
    var_99 = wp::extract(var_j, var_98);
    var_100 = wp::mul(var_97, var_99);
    var_102 = wp::extract(var_h, var_101);
    var_104 = wp::extract(var_k, var_103);
    var_105 = wp::mul(var_102, var_104);
    var_106 = wp::add(var_100, var_105);
    var_107 = wp::float64(var_106);
    var_109 = wp::extract(var_g, var_108);
    var_111 = wp::extract(var_j, var_110);
    var_112 = wp::mul(var_109, var_111);
    var_114 = wp::extract(var_h, var_113);
    var_116 = wp::extract(var_k, var_115);
    var_117 = wp::mul(var_114, var_116);
    var_118 = wp::add(var_112, var_117);
    var_119 = wp::float64(var_118);
    // float64(g[1] * j[5] + h[1] * k[5]),                                                    <L 88>
    var_121 = wp::extract(var_g, var_120);
    var_123 = wp::extract(var_j, var_122);
    var_124 = wp::mul(var_121, var_123);
    var_126 = wp::extract(var_h, var_125);
    var_128 = wp::extract(var_k, var_127);
    var_129 = wp::mul(var_126, var_128);
    var_130 = wp::add(var_124, var_129);
    var_131 = wp::float64(var_130);
    // float64(g[2] * j[2] + h[2] * k[2]), float64(g[2] * j[3] + h[2] * k[3]),                <L 89>
    var_133 = wp::extract(var_g, var_132);
    var_135 = wp::extract(var_j, var_134);
    var_136 = wp::mul(var_133, var_135);
    var_138 = wp::extract(var_h, var_137);
    var_140 = wp::extract(var_k, var_139);
    var_141 = wp::mul(var_138, var_140);
    var_142 = wp::add(var_136, var_141);
    var_143 = wp::float64(var_142);
    var_145 = wp::extract(var_g, var_144);
    var_147 = wp::extract(var_j, var_146);
    var_148 = wp::mul(var_145, var_147);
    var_150 = wp::extract(var_h, var_149);
    var_152 = wp::extract(var_k, var_151);
    var_153 = wp::mul(var_150, var_152);
    var_154 = wp::add(var_148, var_153);
    var_155 = wp::float64(var_154);
    // float64(g[2] * j[4] + h[2] * k[4]), float64(g[2] * j[5] + h[2] * k[5]),                <L 90>
    var_157 = wp::extract(var_g, var_156);
    var_159 = wp::extract(var_j, var_158);
    var_160 = wp::mul(var_157, var_159);
    var_162 = wp::extract(var_h, var_161);
    var_164 = wp::extract(var_k, var_163);
    var_165 = wp::mul(var_162, var_164);
    var_166 = wp::add(var_160, var_165);
    var_167 = wp::float64(var_166);
    var_169 = wp::extract(var_g, var_168);
    var_171 = wp::extract(var_j, var_170);
    var_172 = wp::mul(var_169, var_171);
    var_174 = wp::extract(var_h, var_173);
    var_176 = wp::extract(var_k, var_175);
    var_177 = wp::mul(var_174, var_176);
    var_178 = wp::add(var_172, var_177);
    var_179 = wp::float64(var_178);
    // float64(g[3] * j[3] + h[3] * k[3]), float64(g[3] * j[4] + h[3] * k[4]),                <L 91>
    var_181 = wp::extract(var_g, var_180);
    var_183 = wp::extract(var_j, var_182);
    var_184 = wp::mul(var_181, var_183);
    var_186 = wp::extract(var_h, var_185);
    var_188 = wp::extract(var_k, var_187);
    var_189 = wp::mul(var_186, var_188);
    var_190 = wp::add(var_184, var_189);
    var_191 = wp::float64(var_190);
    var_193 = wp::extract(var_g, var_192);
    var_195 = wp::extract(var_j, var_194);
    var_196 = wp::mul(var_193, var_195);
    var_198 = wp::extract(var_h, var_197);
    var_200 = wp::extract(var_k, var_199);
    var_201 = wp::mul(var_198, var_200);
    var_202 = wp::add(var_196, var_201);
    var_203 = wp::float64(var_202);
    // float64(g[3] * j[5] + h[3] * k[5]),                                                    <L 92>
    var_205 = wp::extract(var_g, var_204);
    var_207 = wp::extract(var_j, var_206);
    var_208 = wp::mul(var_205, var_207);
    var_210 = wp::extract(var_h, var_209);
    var_212 = wp::extract(var_k, var_211);
    var_213 = wp::mul(var_210, var_212);
    var_214 = wp::add(var_208, var_213);
    var_215 = wp::float64(var_214);
    // float64(g[4] * j[4] + h[4] * k[4]), float64(g[4] * j[5] + h[4] * k[5]),                <L 93>
    var_217 = wp::extract(var_g, var_216);
    var_219 = wp::extract(var_j, var_218);
    var_220 = wp::mul(var_217, var_219);
    var_222 = wp::extract(var_h, var_221);
    var_224 = wp::extract(var_k, var_223);
    var_225 = wp::mul(var_222, var_224);
    var_226 = wp::add(var_220, var_225);
    var_227 = wp::float64(var_226);
    var_229 = wp::extract(var_g, var_228);
    var_231 = wp::extract(var_j, var_230);
    var_232 = wp::mul(var_229, var_231);
    var_234 = wp::extract(var_h, var_233);
    var_236 = wp::extract(var_k, var_235);
    var_237 = wp::mul(var_234, var_236);
    var_238 = wp::add(var_232, var_237);
    var_239 = wp::float64(var_238);
    // float64(g[5] * j[5] + h[5] * k[5]),                                                    <L 94>
    var_241 = wp::extract(var_g, var_240);
    var_243 = wp::extract(var_j, var_242);
    var_244 = wp::mul(var_241, var_243);
    var_246 = wp::extract(var_h, var_245);
    var_248 = wp::extract(var_k, var_247);
    var_249 = wp::mul(var_246, var_248);
    var_250 = wp::add(var_244, var_249);
    var_251 = wp::float64(var_250);
    // float64(g[0] * r + h[0] * s), float64(g[1] * r + h[1] * s), float64(g[2] * r + h[2] * s),       <L 95>
    var_253 = wp::extract(var_g, var_252);
    var_254 = wp::mul(var_253, var_r);
    var_256 = wp::extract(var_h, var_255);
    var_257 = wp::mul(var_256, var_s);
    var_258 = wp::add(var_254, var_257);
    var_259 = wp::float64(var_258);
    var_261 = wp::extract(var_g, var_260);
    var_262 = wp::mul(var_261, var_r);
    var_264 = wp::extract(var_h, var_263);
    var_265 = wp::mul(var_264, var_s);
    var_266 = wp::add(var_262, var_265);
    var_267 = wp::float64(var_266);
    var_269 = wp::extract(var_g, var_268);
    var_270 = wp::mul(var_269, var_r);
    var_272 = wp::extract(var_h, var_271);
    var_273 = wp::mul(var_272, var_s);
    var_274 = wp::add(var_270, var_273);
    var_275 = wp::float64(var_274);
    // float64(g[3] * r + h[3] * s), float64(g[4] * r + h[4] * s), float64(g[5] * r + h[5] * s),       <L 96>
    var_277 = wp::extract(var_g, var_276);
    var_278 = wp::mul(var_277, var_r);
    var_280 = wp::extract(var_h, var_279);
    var_281 = wp::mul(var_280, var_s);
    var_282 = wp::add(var_278, var_281);
    var_283 = wp::float64(var_282);
    var_285 = wp::extract(var_g, var_284);
    var_286 = wp::mul(var_285, var_r);
    var_288 = wp::extract(var_h, var_287);
    var_289 = wp::mul(var_288, var_s);
    var_290 = wp::add(var_286, var_289);
    var_291 = wp::float64(var_290);
    var_293 = wp::extract(var_g, var_292);
    var_294 = wp::mul(var_293, var_r);
    var_296 = wp::extract(var_h, var_295);
    var_297 = wp::mul(var_296, var_s);
    var_298 = wp::add(var_294, var_297);
    var_299 = wp::float64(var_298);
    // float64(extra[0]), float64(extra[1]), float64(extra[2]), float64(extra[3]), float64(extra[4]),       <L 97>
    var_301 = wp::extract(var_extra, var_300);
    var_302 = wp::float64(var_301);
    var_304 = wp::extract(var_extra, var_303);
    var_305 = wp::float64(var_304);
    var_307 = wp::extract(var_extra, var_306);
    var_308 = wp::float64(var_307);
    var_310 = wp::extract(var_extra, var_309);
    var_311 = wp::float64(var_310);
    var_313 = wp::extract(var_extra, var_312);
    var_314 = wp::float64(var_313);
    // float64(extra[5]), float64(extra[6]), float64(extra[7]), float64(extra[8]), float64(extra[9]),       <L 98>
    var_316 = wp::extract(var_extra, var_315);
    var_317 = wp::float64(var_316);
    var_319 = wp::extract(var_extra, var_318);
    var_320 = wp::float64(var_319);
    var_322 = wp::extract(var_extra, var_321);
    var_323 = wp::float64(var_322);
    var_325 = wp::extract(var_extra, var_324);
    var_326 = wp::float64(var_325);
    var_328 = wp::extract(var_extra, var_327);
    var_329 = wp::float64(var_328);
    // float64(extra[10]),                                                                    <L 99>
    var_331 = wp::extract(var_extra, var_330);
    var_332 = wp::float64(var_331);
    var_333 = wp::vec_t<38, wp::float64>({var_11, var_23, var_35, var_47, var_59, var_71, var_83, var_95, var_107, var_119, var_131, var_143, var_155, var_167, var_179, var_191, var_203, var_215, var_227, var_239, var_251, var_259, var_267, var_275, var_283, var_291, var_299, var_302, var_305, var_308, var_311, var_314, var_317, var_320, var_323, var_326, var_329, var_332});
    return var_333;
}


// <pointloom.kernels.rgbd.alignment_rows.sum_alignment_rows_element>:1
static CUDA_CALLABLE wp::vec_t<38, wp::float64> sum_alignment_rows_element_0(
    wp::array_t<wp::vec_t<4, wp::int32>> var_source__layout,
    wp::array_t<wp::float32> var_source__depth,
    wp::array_t<wp::float32> var_source__brightness,
    wp::array_t<wp::vec_t<4, wp::int32>> var_target__layout,
    wp::array_t<wp::vec_t<4, wp::float32>> var_target__lenses,
    wp::array_t<wp::float32> var_target__depth,
    wp::array_t<wp::float32> var_target__brightness,
    wp::array_t<wp::vec_t<4, wp::float32>> var_target__planes,
    wp::int32 var_rules__shift,
    wp::float32 var_rules__surface_share,
    wp::float32 var_rules__brightness_share,
    wp::float32 var_rules__max_deviation,
    wp::array_t<wp::int32> var_state__counts,
    wp::array_t<wp::vec_t<4, wp::float32>> var_state__warps,
    wp::array_t<wp::float32> var_state__scales,
    wp::int32 var_i)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 0.0;
    wp::vec_t<6, wp::float32> var_1;
    const wp::float32 var_2 = 0.0;
    wp::vec_t<6, wp::float32> var_3;
    const wp::float32 var_4 = 0.0;
    wp::vec_t<6, wp::float32> var_5;
    const wp::float32 var_6 = 0.0;
    wp::vec_t<6, wp::float32> var_7;
    const wp::float32 var_8 = 0.0;
    wp::float32 var_9;
    const wp::float32 var_10 = 0.0;
    wp::float32 var_11;
    const wp::float32 var_12 = 0.0;
    wp::vec_t<11, wp::float32> var_13;
    wp::float32* var_14;
    wp::float32 var_15;
    wp::float32 var_16;
    const wp::float32 var_17 = 0.0;
    bool var_18;
    const wp::int32 var_19 = 0;
    wp::int32* var_20;
    wp::int32 var_21;
    wp::int32 var_22;
    wp::int32 var_23;
    wp::vec_t<4, wp::int32>* var_24;
    wp::vec_t<4, wp::int32> var_25;
    wp::vec_t<4, wp::int32> var_26;
    const wp::int32 var_27 = 2;
    wp::int32 var_28;
    wp::int32 var_29;
    const wp::int32 var_30 = 0;
    wp::int32 var_31;
    wp::int32 var_32;
    wp::float32 var_33;
    const wp::int32 var_34 = 2;
    wp::int32 var_35;
    wp::int32 var_36;
    const wp::int32 var_37 = 0;
    wp::int32 var_38;
    wp::int32 var_39;
    wp::float32 var_40;
    wp::vec_t<3, wp::float32> var_41;
    wp::float32 var_42;
    wp::float32 var_43;
    wp::int32 var_44;
    const wp::float32 var_45 = 0.0;
    wp::float32 var_46;
    const wp::int32 var_47 = 0;
    bool var_48;
    wp::float32* var_49;
    wp::float32 var_50;
    wp::float32 var_51;
    wp::float32 var_52;
    const wp::int32 var_53 = 2;
    wp::float32 var_54;
    wp::float32 var_55;
    bool var_56;
    const wp::float32 var_57 = 0.0;
    bool var_58;
    const wp::int32 var_59 = 2;
    wp::float32 var_60;
    wp::float32 var_61;
    wp::float32 var_62;
    const wp::float32 var_63 = 0.01;
    const wp::int32 var_64 = 2;
    wp::float32 var_65;
    wp::float32 var_66;
    wp::float32 var_67;
    wp::float32 var_68;
    bool var_69;
    wp::float32* var_70;
    wp::float32 var_71;
    wp::float32 var_72;
    bool var_73;
    const wp::float32 var_74 = 0.0;
    bool var_75;
    const wp::float32 var_76 = 0.0;
    bool var_77;
    wp::vec_t<4, wp::float32> var_78;
    const wp::int32 var_79 = 3;
    wp::float32 var_80;
    const wp::float32 var_81 = 0.0;
    bool var_82;
    const wp::int32 var_83 = 0;
    wp::float32 var_84;
    const wp::int32 var_85 = 2;
    wp::float32* var_86;
    wp::float32 var_87;
    wp::float32 var_88;
    wp::float32 var_89;
    const wp::int32 var_90 = 3;
    wp::float32* var_91;
    wp::float32 var_92;
    wp::float32 var_93;
    wp::vec_t<6, wp::float32> var_94;
    const wp::float32 var_95 = 5.0;
    const wp::float32 var_96 = 1.0;
    wp::float32 var_97;
    wp::float32 var_98;
    const wp::int32 var_99 = 1;
    wp::float32* var_100;
    wp::float32 var_101;
    wp::float32 var_102;
    wp::float32 var_103;
    wp::float32 var_104;
    const wp::int32 var_105 = 1;
    wp::float32* var_106;
    wp::float32 var_107;
    wp::float32 var_108;
    wp::float32 var_109;
    wp::vec_t<6, wp::float32> var_110;
    const wp::float32 var_111 = 1.0;
    const wp::int32 var_112 = 3;
    wp::float32 var_113;
    wp::float32 var_114;
    const wp::int32 var_115 = 4;
    const wp::int32 var_116 = 5;
    wp::float32 var_117;
    const wp::int32 var_118 = 6;
    const wp::int32 var_119 = 0;
    wp::float32 var_120;
    wp::float32 var_121;
    const wp::int32 var_122 = 7;
    wp::float32 var_123;
    wp::float32 var_124;
    const wp::int32 var_125 = 8;
    const wp::int32 var_126 = 0;
    wp::float32 var_127;
    wp::float32 var_128;
    const wp::int32 var_129 = 0;
    wp::float32 var_130;
    wp::float32 var_131;
    const wp::int32 var_132 = 9;
    wp::float32 var_133;
    const wp::int32 var_134 = 0;
    wp::float32 var_135;
    wp::float32 var_136;
    const wp::int32 var_137 = 10;
    wp::vec_t<6, wp::float32> var_138;
    wp::vec_t<6, wp::float32> var_139;
    wp::float32 var_140;
    wp::vec_t<6, wp::float32> var_141;
    wp::vec_t<6, wp::float32> var_142;
    wp::float32 var_143;
    wp::vec_t<4, wp::float32>* var_144;
    wp::vec_t<4, wp::float32> var_145;
    wp::vec_t<4, wp::float32> var_146;
    bool var_147;
    const wp::int32 var_148 = 3;
    wp::float32 var_149;
    const wp::float32 var_150 = 0.0;
    bool var_151;
    const wp::float32 var_152 = 0.0;
    bool var_153;
    wp::vec_t<3, wp::float32> var_154;
    wp::float32 var_155;
    const wp::int32 var_156 = 3;
    wp::float32 var_157;
    wp::float32 var_158;
    const wp::float32 var_159 = 1.0;
    wp::float32 var_160;
    wp::float32 var_161;
    wp::float32 var_162;
    wp::float32 var_163;
    const wp::float32 var_164 = 1.0;
    wp::float32 var_165;
    const wp::int32 var_166 = 0;
    wp::float32* var_167;
    wp::float32 var_168;
    wp::float32 var_169;
    wp::float32 var_170;
    wp::float32 var_171;
    wp::vec_t<6, wp::float32> var_172;
    wp::float32 var_173;
    const wp::int32 var_174 = 0;
    wp::float32* var_175;
    wp::float32 var_176;
    wp::float32 var_177;
    wp::float32 var_178;
    wp::vec_t<6, wp::float32> var_179;
    const wp::float32 var_180 = 1.0;
    const wp::int32 var_181 = 0;
    wp::float32 var_182;
    const wp::int32 var_183 = 1;
    wp::float32 var_184;
    const wp::int32 var_185 = 2;
    wp::vec_t<6, wp::float32> var_186;
    wp::vec_t<6, wp::float32> var_187;
    wp::float32 var_188;
    wp::float32 var_189;
    wp::vec_t<6, wp::float32> var_190;
    wp::vec_t<6, wp::float32> var_191;
    wp::vec_t<6, wp::float32> var_192;
    wp::vec_t<6, wp::float32> var_193;
    wp::float32 var_194;
    wp::float32 var_195;
    wp::vec_t<6, wp::float32> var_196;
    wp::vec_t<6, wp::float32> var_197;
    wp::vec_t<6, wp::float32> var_198;
    wp::vec_t<6, wp::float32> var_199;
    wp::float32 var_200;
    wp::float32 var_201;
    wp::vec_t<38, wp::float64> var_202;
    //---------
    // forward
    // def sum_alignment_rows_element(source__layout, source__depth, source__brightness, target__layout, target__lenses, target__depth, target__brightness, target__planes, rules__shift, rules__surface_share, rules__brightness_share, rules__max_deviation, state__counts, state__warps, state__scales, i):       <L 1>
    // g = row(0.0)                                                                           <L 2>
    var_1 = wp::vec_t<6, wp::float32>(var_0);
    // j = row(0.0)                                                                           <L 3>
    var_3 = wp::vec_t<6, wp::float32>(var_2);
    // h = row(0.0)                                                                           <L 4>
    var_5 = wp::vec_t<6, wp::float32>(var_4);
    // k = row(0.0)                                                                           <L 5>
    var_7 = wp::vec_t<6, wp::float32>(var_6);
    // r = float(0.0)                                                                         <L 6>
    var_9 = wp::float(var_8);
    // s = float(0.0)                                                                         <L 7>
    var_11 = wp::float(var_10);
    // extra = extra_sums(0.0)                                                                <L 8>
    var_13 = wp::vec_t<11, wp::float32>(var_12);
    // z = source__depth[i]                                                                   <L 9>
    var_14 = wp::address(var_source__depth, var_i);
    var_16 = wp::load(var_14);
    var_15 = wp::copy(var_16);
    // if z > 0.0:                                                                            <L 10>
    var_18 = (var_15 > var_17);
    if (var_18) {
        // level = state__counts[0]                                                           <L 11>
        var_20 = wp::address(var_state__counts, var_19);
        var_22 = wp::load(var_20);
        var_21 = wp::copy(var_22);
        // other = level + rules__shift                                                       <L 12>
        var_23 = wp::add(var_21, var_rules__shift);
        // size = source__layout[level]                                                       <L 13>
        var_24 = wp::address(var_source__layout, var_21);
        var_26 = wp::load(var_24);
        var_25 = wp::copy(var_26);
        // p = moved_point(float((i - size[2]) % size[0]), float((i - size[2]) // size[0]), z, state__warps)       <L 14>
        var_28 = wp::extract(var_25, var_27);
        var_29 = wp::sub(var_i, var_28);
        var_31 = wp::extract(var_25, var_30);
        var_32 = wp::mod(var_29, var_31);
        var_33 = wp::float(var_32);
        var_35 = wp::extract(var_25, var_34);
        var_36 = wp::sub(var_i, var_35);
        var_38 = wp::extract(var_25, var_37);
        var_39 = wp::floordiv(var_36, var_38);
        var_40 = wp::float(var_39);
        var_41 = moved_point_1(var_33, var_40, var_15, var_state__warps);
        // u, v, at = seen_at(p, other, target__layout, target__lenses)                       <L 15>
        seen_at_0(var_41, var_23, var_target__layout, var_target__lenses, var_42, var_43, var_44);
        // there = float(0.0)                                                                 <L 16>
        var_46 = wp::float(var_45);
        // if at >= 0:                                                                        <L 17>
        var_48 = (var_44 >= var_47);
        if (var_48) {
            // there = target__depth[at]                                                      <L 18>
            var_49 = wp::address(var_target__depth, var_44);
            var_51 = wp::load(var_49);
            var_50 = wp::copy(var_51);
        }
        var_52 = wp::where(var_48, var_50, var_46);
        // noise = depth_noise(p[2])                                                          <L 19>
        var_54 = wp::extract(var_41, var_53);
        var_55 = depth_noise_0(var_54);
        // if there > 0.0 and abs(p[2] - there) < rules__max_deviation * (noise + SLOPE_MARGIN * p[2]):       <L 20>
        var_58 = (var_52 > var_57);
        var_56 = var_58;
        if (var_56) {
            var_60 = wp::extract(var_41, var_59);
            var_61 = wp::sub(var_60, var_52);
            var_62 = wp::abs(var_61);
            var_65 = wp::extract(var_41, var_64);
            var_66 = wp::mul(var_63, var_65);
            var_67 = wp::add(var_55, var_66);
            var_68 = wp::mul(var_rules__max_deviation, var_67);
            var_69 = (var_62 < var_68);
            var_56 = var_56 && var_69;
        }
        if (var_56) {
            // shade = source__brightness[i]                                                  <L 21>
            var_70 = wp::address(var_source__brightness, var_i);
            var_72 = wp::load(var_70);
            var_71 = wp::copy(var_72);
            // if shade >= 0.0 and rules__brightness_share > 0.0:                             <L 22>
            var_75 = (var_71 >= var_74);
            var_73 = var_75;
            if (var_73) {
                var_77 = (var_rules__brightness_share > var_76);
                var_73 = var_73 && var_77;
            }
            if (var_73) {
                // sample = seen_brightness(u, v, other, target__layout, target__brightness)       <L 23>
                var_78 = seen_brightness_0(var_42, var_43, var_23, var_target__layout, var_target__brightness);
                // if sample[3] > 0.0:                                                        <L 24>
                var_80 = wp::extract(var_78, var_79);
                var_82 = (var_80 > var_81);
                if (var_82) {
                    // s = sample[0] - shade * state__scales[2] - state__scales[3]            <L 25>
                    var_84 = wp::extract(var_78, var_83);
                    var_86 = wp::address(var_state__scales, var_85);
                    var_88 = wp::load(var_86);
                    var_87 = wp::mul(var_71, var_88);
                    var_89 = wp::sub(var_84, var_87);
                    var_91 = wp::address(var_state__scales, var_90);
                    var_93 = wp::load(var_91);
                    var_92 = wp::sub(var_89, var_93);
                    // k = brightness_row(p, sample, other, target__lenses)                   <L 26>
                    var_94 = brightness_row_0(var_41, var_78, var_23, var_target__lenses);
                    // t = (NU + 1.0) / (NU + s * s * state__scales[1])                       <L 27>
                    var_97 = wp::add(var_95, var_96);
                    var_98 = wp::mul(var_92, var_92);
                    var_100 = wp::address(var_state__scales, var_99);
                    var_102 = wp::load(var_100);
                    var_101 = wp::mul(var_98, var_102);
                    var_103 = wp::add(var_95, var_101);
                    var_104 = wp::div(var_97, var_103);
                    // h = k * (t * state__scales[1] * rules__brightness_share)               <L 28>
                    var_106 = wp::address(var_state__scales, var_105);
                    var_108 = wp::load(var_106);
                    var_107 = wp::mul(var_104, var_108);
                    var_109 = wp::mul(var_107, var_rules__brightness_share);
                    var_110 = wp::mul(var_94, var_109);
                    // extra[3] = 1.0                                                         <L 29>
                    wp::assign_inplace(var_13, var_112, var_111);
                    // extra[4] = t * s * s                                                   <L 30>
                    var_113 = wp::mul(var_104, var_92);
                    var_114 = wp::mul(var_113, var_92);
                    wp::assign_inplace(var_13, var_115, var_114);
                    // extra[5] = t                                                           <L 31>
                    wp::assign_inplace(var_13, var_116, var_104);
                    // extra[6] = t * shade                                                   <L 32>
                    var_117 = wp::mul(var_104, var_71);
                    wp::assign_inplace(var_13, var_118, var_117);
                    // extra[7] = t * sample[0]                                               <L 33>
                    var_120 = wp::extract(var_78, var_119);
                    var_121 = wp::mul(var_104, var_120);
                    wp::assign_inplace(var_13, var_122, var_121);
                    // extra[8] = t * shade * shade                                           <L 34>
                    var_123 = wp::mul(var_104, var_71);
                    var_124 = wp::mul(var_123, var_71);
                    wp::assign_inplace(var_13, var_125, var_124);
                    // extra[9] = t * sample[0] * sample[0]                                   <L 35>
                    var_127 = wp::extract(var_78, var_126);
                    var_128 = wp::mul(var_104, var_127);
                    var_130 = wp::extract(var_78, var_129);
                    var_131 = wp::mul(var_128, var_130);
                    wp::assign_inplace(var_13, var_132, var_131);
                    // extra[10] = t * shade * sample[0]                                      <L 36>
                    var_133 = wp::mul(var_104, var_71);
                    var_135 = wp::extract(var_78, var_134);
                    var_136 = wp::mul(var_133, var_135);
                    wp::assign_inplace(var_13, var_137, var_136);
                }
                var_138 = wp::where(var_82, var_110, var_5);
                var_139 = wp::where(var_82, var_94, var_7);
                var_140 = wp::where(var_82, var_92, var_11);
            }
            var_141 = wp::where(var_73, var_138, var_5);
            var_142 = wp::where(var_73, var_139, var_7);
            var_143 = wp::where(var_73, var_140, var_11);
            // plane = target__planes[at]                                                     <L 37>
            var_144 = wp::address(var_target__planes, var_44);
            var_146 = wp::load(var_144);
            var_145 = wp::copy(var_146);
            // if plane[3] < 0.0 and rules__surface_share > 0.0:                              <L 38>
            var_149 = wp::extract(var_145, var_148);
            var_151 = (var_149 < var_150);
            var_147 = var_151;
            if (var_147) {
                var_153 = (var_rules__surface_share > var_152);
                var_147 = var_147 && var_153;
            }
            if (var_147) {
                // r = dot(axis(plane), p) - plane[3]                                         <L 39>
                var_154 = axis_0(var_145);
                var_155 = wp::dot(var_154, var_41);
                var_157 = wp::extract(var_145, var_156);
                var_158 = wp::sub(var_155, var_157);
                // inverse = 1.0 / (noise * noise)                                            <L 40>
                var_160 = wp::mul(var_55, var_55);
                var_161 = wp::div(var_159, var_160);
                // square = r * r * inverse                                                   <L 41>
                var_162 = wp::mul(var_158, var_158);
                var_163 = wp::mul(var_162, var_161);
                // t = (NU + 1.0) / (NU + square * state__scales[0])                          <L 42>
                var_165 = wp::add(var_95, var_164);
                var_167 = wp::address(var_state__scales, var_166);
                var_169 = wp::load(var_167);
                var_168 = wp::mul(var_163, var_169);
                var_170 = wp::add(var_95, var_168);
                var_171 = wp::div(var_165, var_170);
                // j = surface_row(p, plane)                                                  <L 43>
                var_172 = surface_row_0(var_41, var_145);
                // g = j * (t * inverse * state__scales[0] * rules__surface_share)            <L 44>
                var_173 = wp::mul(var_171, var_161);
                var_175 = wp::address(var_state__scales, var_174);
                var_177 = wp::load(var_175);
                var_176 = wp::mul(var_173, var_177);
                var_178 = wp::mul(var_176, var_rules__surface_share);
                var_179 = wp::mul(var_172, var_178);
                // extra[0] = 1.0                                                             <L 45>
                wp::assign_inplace(var_13, var_181, var_180);
                // extra[1] = t * square                                                      <L 46>
                var_182 = wp::mul(var_171, var_163);
                wp::assign_inplace(var_13, var_183, var_182);
                // extra[2] = r * r                                                           <L 47>
                var_184 = wp::mul(var_158, var_158);
                wp::assign_inplace(var_13, var_185, var_184);
            }
            var_186 = wp::where(var_147, var_179, var_1);
            var_187 = wp::where(var_147, var_172, var_3);
            var_188 = wp::where(var_147, var_158, var_9);
            var_189 = wp::where(var_147, var_171, var_104);
        }
        var_190 = wp::where(var_56, var_186, var_1);
        var_191 = wp::where(var_56, var_187, var_3);
        var_192 = wp::where(var_56, var_141, var_5);
        var_193 = wp::where(var_56, var_142, var_7);
        var_194 = wp::where(var_56, var_188, var_9);
        var_195 = wp::where(var_56, var_143, var_11);
    }
    var_196 = wp::where(var_18, var_190, var_1);
    var_197 = wp::where(var_18, var_191, var_3);
    var_198 = wp::where(var_18, var_192, var_5);
    var_199 = wp::where(var_18, var_193, var_7);
    var_200 = wp::where(var_18, var_194, var_9);
    var_201 = wp::where(var_18, var_195, var_11);
    // return sum_rows(g, j, r, h, k, s, extra)                                               <L 48>
    var_202 = sum_rows_0(var_196, var_197, var_200, var_198, var_199, var_201, var_13);
    return var_202;
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


// <pointloom.kernels.rgbd.seen_pixels.brightness_row>:1
static CUDA_CALLABLE void adj_brightness_row_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<4, wp::float32> var_sample,
    wp::int32 var_level,
    wp::array_t<wp::vec_t<4, wp::float32>> var_frame__lenses,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<4, wp::float32> & adj_sample,
    wp::int32 & adj_level,
    wp::array_t<wp::vec_t<4, wp::float32>> & adj_frame__lenses,
    wp::vec_t<6, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/rgbd/seen_pixels.py:72
static CUDA_CALLABLE void adj_surface_row_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<4, wp::float32> var_plane,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<4, wp::float32> & adj_plane,
    wp::vec_t<6, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/rgbd/alignment_rows.py:79
static CUDA_CALLABLE void adj_sum_rows_0(
    wp::vec_t<6, wp::float32> var_g,
    wp::vec_t<6, wp::float32> var_j,
    wp::float32 var_r,
    wp::vec_t<6, wp::float32> var_h,
    wp::vec_t<6, wp::float32> var_k,
    wp::float32 var_s,
    wp::vec_t<11, wp::float32> var_extra,
    wp::vec_t<6, wp::float32> & adj_g,
    wp::vec_t<6, wp::float32> & adj_j,
    wp::float32 & adj_r,
    wp::vec_t<6, wp::float32> & adj_h,
    wp::vec_t<6, wp::float32> & adj_k,
    wp::float32 & adj_s,
    wp::vec_t<11, wp::float32> & adj_extra,
    wp::vec_t<38, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.rgbd.alignment_rows.sum_alignment_rows_element>:1
static CUDA_CALLABLE void adj_sum_alignment_rows_element_0(
    wp::array_t<wp::vec_t<4, wp::int32>> var_source__layout,
    wp::array_t<wp::float32> var_source__depth,
    wp::array_t<wp::float32> var_source__brightness,
    wp::array_t<wp::vec_t<4, wp::int32>> var_target__layout,
    wp::array_t<wp::vec_t<4, wp::float32>> var_target__lenses,
    wp::array_t<wp::float32> var_target__depth,
    wp::array_t<wp::float32> var_target__brightness,
    wp::array_t<wp::vec_t<4, wp::float32>> var_target__planes,
    wp::int32 var_rules__shift,
    wp::float32 var_rules__surface_share,
    wp::float32 var_rules__brightness_share,
    wp::float32 var_rules__max_deviation,
    wp::array_t<wp::int32> var_state__counts,
    wp::array_t<wp::vec_t<4, wp::float32>> var_state__warps,
    wp::array_t<wp::float32> var_state__scales,
    wp::int32 var_i,
    wp::array_t<wp::vec_t<4, wp::int32>> & adj_source__layout,
    wp::array_t<wp::float32> & adj_source__depth,
    wp::array_t<wp::float32> & adj_source__brightness,
    wp::array_t<wp::vec_t<4, wp::int32>> & adj_target__layout,
    wp::array_t<wp::vec_t<4, wp::float32>> & adj_target__lenses,
    wp::array_t<wp::float32> & adj_target__depth,
    wp::array_t<wp::float32> & adj_target__brightness,
    wp::array_t<wp::vec_t<4, wp::float32>> & adj_target__planes,
    wp::int32 & adj_rules__shift,
    wp::float32 & adj_rules__surface_share,
    wp::float32 & adj_rules__brightness_share,
    wp::float32 & adj_rules__max_deviation,
    wp::array_t<wp::int32> & adj_state__counts,
    wp::array_t<wp::vec_t<4, wp::float32>> & adj_state__warps,
    wp::array_t<wp::float32> & adj_state__scales,
    wp::int32 & adj_i,
    wp::vec_t<38, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void sum_alignment_rows_fold_tiles_4af5eb53_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_starts_,
    wp::array_t<wp::int32> var_live_,
    wp::array_t<wp::vec_t<38, wp::float64>> var_partials_,
    wp::array_t<wp::vec_t<38, wp::float64>> var_out_)
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
        wp::vec_t<38, wp::float64> var_3;
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
        wp::vec_t<38, wp::float64>* var_16;
        wp::vec_t<38, wp::float64> var_17;
        wp::vec_t<38, wp::float64> var_18;
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
        const wp::int32 var_253 = 36;
        wp::float64 var_254;
        const wp::int32 var_255 = 37;
        wp::float64 var_256;
        wp::vec_t<2, wp::float64> var_257;
        const bool var_258 = true;
        wp::tile_register_t<wp::vec_t<2, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_259 = wp::tile_register_t<wp::vec_t<2, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<2, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_260 = wp::tile_alloc_empty<wp::vec_t<2, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_261 = 0;
        wp::vec_t<2, wp::float64> var_262;
        const wp::int32 var_263 = 0;
        wp::float64 var_264;
        const wp::int32 var_265 = 36;
        const wp::int32 var_266 = 1;
        wp::float64 var_267;
        const wp::int32 var_268 = 37;
        const wp::int32 var_269 = 256;
        wp::int32 var_270;
        const wp::int32 var_271 = 0;
        bool var_272;
        //---------
        // forward
        // def sum_alignment_rows_fold_tiles(starts_, live_, partials_, out_):                    <L 1>
        // i_ = wp.tid()                                                                          <L 2>
        var_0 = builtin_tid1d();
        // s_ = i_ // 256                                                                         <L 3>
        var_2 = wp::floordiv(var_0, var_1);
        // value_ = vector_()                                                                     <L 4>
        var_3 = wp::vec_t<38, wp::float64>();
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
        // part_36 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[36], value_[37]), preserve_type=True)), 0)       <L 52>
        var_254 = wp::extract(var_3, var_253);
        var_256 = wp::extract(var_3, var_255);
        var_257 = wp::vec_t<2, wp::float64>(var_254, var_256);
        var_259 = wp::tile<wp::vec_t<2, wp::float64>>(var_257);
        var_260 = wp::tile_sum(var_259);
        var_262 = wp::tile_extract(var_260, var_261);
        // value_[36] = part_36[0]                                                                <L 53>
        var_264 = wp::extract(var_262, var_263);
        wp::assign_inplace(var_3, var_265, var_264);
        // value_[37] = part_36[1]                                                                <L 54>
        var_267 = wp::extract(var_262, var_266);
        wp::assign_inplace(var_3, var_268, var_267);
        // if i_ % 256 == 0:                                                                      <L 55>
        var_270 = wp::mod(var_0, var_269);
        var_272 = (var_270 == var_271);
        if (var_272) {
            // out_[s_] = value_                                                                  <L 56>
            wp::array_store(var_out_, var_2, var_3);
        }
}



extern "C" __global__ void WP_MAXNREG(128) sum_alignment_rows_tiles_6070163e_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<4, wp::int32>> var_source__layout,
    wp::array_t<wp::float32> var_source__depth,
    wp::array_t<wp::float32> var_source__brightness,
    wp::array_t<wp::vec_t<4, wp::int32>> var_target__layout,
    wp::array_t<wp::vec_t<4, wp::float32>> var_target__lenses,
    wp::array_t<wp::float32> var_target__depth,
    wp::array_t<wp::float32> var_target__brightness,
    wp::array_t<wp::vec_t<4, wp::float32>> var_target__planes,
    wp::int32 var_rules__shift,
    wp::float32 var_rules__surface_share,
    wp::float32 var_rules__brightness_share,
    wp::float32 var_rules__max_deviation,
    wp::array_t<wp::int32> var_state__counts,
    wp::array_t<wp::vec_t<4, wp::float32>> var_state__warps,
    wp::array_t<wp::float32> var_state__scales,
    wp::array_t<wp::int32> var_firsts_,
    wp::array_t<wp::int32> var_lasts_,
    wp::array_t<wp::int32> var_owners_,
    wp::array_t<wp::int32> var_live_,
    wp::array_t<wp::vec_t<38, wp::float64>> var_partials_)
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
        wp::vec_t<38, wp::float64> var_3;
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
        wp::vec_t<38, wp::float64> var_20;
        wp::vec_t<38, wp::float64> var_21;
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
        const wp::int32 var_256 = 36;
        wp::float64 var_257;
        const wp::int32 var_258 = 37;
        wp::float64 var_259;
        wp::vec_t<2, wp::float64> var_260;
        const bool var_261 = true;
        wp::tile_register_t<wp::vec_t<2, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_262 = wp::tile_register_t<wp::vec_t<2, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<2, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_263 = wp::tile_alloc_empty<wp::vec_t<2, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_264 = 0;
        wp::vec_t<2, wp::float64> var_265;
        const wp::int32 var_266 = 0;
        wp::float64 var_267;
        const wp::int32 var_268 = 36;
        const wp::int32 var_269 = 1;
        wp::float64 var_270;
        const wp::int32 var_271 = 37;
        const wp::int32 var_272 = 256;
        wp::int32 var_273;
        const wp::int32 var_274 = 0;
        bool var_275;
        //---------
        // forward
        // def sum_alignment_rows_tiles(source__layout, source__depth, source__brightness, target__layout, target__lenses, target__depth, target__brightness, target__planes, rules__shift, rules__surface_share, rules__brightness_share, rules__max_deviation, state__counts, state__warps, state__scales, firsts_, lasts_, owners_, live_, partials_):       <L 1>
        // i_ = wp.tid()                                                                          <L 2>
        var_0 = builtin_tid1d();
        // b_ = i_ // 256                                                                         <L 3>
        var_2 = wp::floordiv(var_0, var_1);
        // value_ = vector_()                                                                     <L 4>
        var_3 = wp::vec_t<38, wp::float64>();
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
                // value_ += element_(source__layout, source__depth, source__brightness, target__layout, target__lenses, target__depth, target__brightness, target__planes, rules__shift, rules__surface_share, rules__brightness_share, rules__max_deviation, state__counts, state__warps, state__scales, j_)       <L 7>
                var_20 = sum_alignment_rows_element_0(var_source__layout, var_source__depth, var_source__brightness, var_target__layout, var_target__lenses, var_target__depth, var_target__brightness, var_target__planes, var_rules__shift, var_rules__surface_share, var_rules__brightness_share, var_rules__max_deviation, var_state__counts, var_state__warps, var_state__scales, var_19);
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
        // part_36 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[36], value_[37]), preserve_type=True)), 0)       <L 53>
        var_257 = wp::extract(var_3, var_256);
        var_259 = wp::extract(var_3, var_258);
        var_260 = wp::vec_t<2, wp::float64>(var_257, var_259);
        var_262 = wp::tile<wp::vec_t<2, wp::float64>>(var_260);
        var_263 = wp::tile_sum(var_262);
        var_265 = wp::tile_extract(var_263, var_264);
        // value_[36] = part_36[0]                                                                <L 54>
        var_267 = wp::extract(var_265, var_266);
        wp::assign_inplace(var_3, var_268, var_267);
        // value_[37] = part_36[1]                                                                <L 55>
        var_270 = wp::extract(var_265, var_269);
        wp::assign_inplace(var_3, var_271, var_270);
        // if i_ % 256 == 0:                                                                      <L 56>
        var_273 = wp::mod(var_0, var_272);
        var_275 = (var_273 == var_274);
        if (var_275) {
            // partials_[b_] = value_                                                             <L 57>
            wp::array_store(var_partials_, var_2, var_3);
        }
}


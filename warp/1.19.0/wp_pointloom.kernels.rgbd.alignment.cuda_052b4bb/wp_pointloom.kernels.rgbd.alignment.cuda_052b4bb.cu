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


// <pointloom.kernels.rgbd.alignment.leaves_plane>:1
static CUDA_CALLABLE wp::float32 leaves_plane_0(
    wp::int32 var_at,
    wp::int32 var_u,
    wp::int32 var_v,
    wp::vec_t<4, wp::float32> var_plane,
    wp::vec_t<4, wp::float32> var_lens,
    wp::array_t<wp::float32> var_frame__depth)
{
    //---------
    // primal vars
    wp::float32* var_0;
    wp::float32 var_1;
    wp::float32 var_2;
    wp::float32 var_3;
    const wp::int32 var_4 = 2;
    wp::float32 var_5;
    wp::float32 var_6;
    const wp::int32 var_7 = 0;
    wp::float32 var_8;
    wp::float32 var_9;
    wp::float32 var_10;
    const wp::int32 var_11 = 3;
    wp::float32 var_12;
    wp::float32 var_13;
    const wp::int32 var_14 = 1;
    wp::float32 var_15;
    wp::float32 var_16;
    const wp::float32 var_17 = 1.0;
    wp::vec_t<3, wp::float32> var_18;
    wp::vec_t<3, wp::float32> var_19;
    wp::vec_t<3, wp::float32> var_20;
    wp::float32 var_21;
    const wp::int32 var_22 = 3;
    wp::float32 var_23;
    wp::float32 var_24;
    wp::float32 var_25;
    //---------
    // forward
    // def leaves_plane(at, u, v, plane, lens, frame__depth):                                 <L 1>
    // z = frame__depth[at]                                                                   <L 3>
    var_0 = wp::address(var_frame__depth, var_at);
    var_2 = wp::load(var_0);
    var_1 = wp::copy(var_2);
    // p = vec3((float(u) - lens[2]) / lens[0], (float(v) - lens[3]) / lens[1], 1.0) * z       <L 4>
    var_3 = wp::float(var_u);
    var_5 = wp::extract(var_lens, var_4);
    var_6 = wp::sub(var_3, var_5);
    var_8 = wp::extract(var_lens, var_7);
    var_9 = wp::div(var_6, var_8);
    var_10 = wp::float(var_v);
    var_12 = wp::extract(var_lens, var_11);
    var_13 = wp::sub(var_10, var_12);
    var_15 = wp::extract(var_lens, var_14);
    var_16 = wp::div(var_13, var_15);
    var_18 = wp::vec_t<3, wp::float32>(var_9, var_16, var_17);
    var_19 = wp::mul(var_18, var_1);
    // return abs(dot(axis(plane), p) - plane[3])                                             <L 5>
    var_20 = axis_0(var_plane);
    var_21 = wp::dot(var_20, var_19);
    var_23 = wp::extract(var_plane, var_22);
    var_24 = wp::sub(var_21, var_23);
    var_25 = wp::abs(var_24);
    return var_25;
}


// <pointloom.kernels.rgbd.alignment.is_inside>:1
static CUDA_CALLABLE wp::int32 is_inside_0(
    wp::int32 var_at,
    wp::int32 var_margin,
    wp::int32 var_level,
    wp::array_t<wp::vec_t<4, wp::int32>> var_frame__layout,
    wp::array_t<wp::vec_t<4, wp::float32>> var_frame__lenses,
    wp::array_t<wp::float32> var_frame__depth,
    wp::array_t<wp::vec_t<4, wp::float32>> var_frame__planes)
{
    //---------
    // primal vars
    wp::vec_t<4, wp::int32>* var_0;
    wp::vec_t<4, wp::int32> var_1;
    wp::vec_t<4, wp::int32> var_2;
    wp::vec_t<4, wp::float32>* var_3;
    wp::vec_t<4, wp::float32> var_4;
    wp::vec_t<4, wp::float32> var_5;
    const wp::int32 var_6 = 2;
    wp::int32 var_7;
    wp::int32 var_8;
    const wp::int32 var_9 = 0;
    wp::int32 var_10;
    wp::int32 var_11;
    const wp::int32 var_12 = 0;
    wp::int32 var_13;
    wp::int32 var_14;
    const wp::int32 var_15 = 0;
    wp::int32 var_16;
    const wp::int32 var_17 = 0;
    bool var_18;
    const wp::int32 var_19 = 1;
    bool var_20;
    bool var_21;
    bool var_22;
    const wp::int32 var_23 = 0;
    wp::int32 var_24;
    wp::int32 var_25;
    bool var_26;
    const wp::int32 var_27 = 1;
    wp::int32 var_28;
    wp::int32 var_29;
    bool var_30;
    wp::vec_t<4, wp::float32>* var_31;
    wp::vec_t<4, wp::float32> var_32;
    wp::vec_t<4, wp::float32> var_33;
    const wp::int32 var_34 = 3;
    wp::float32 var_35;
    const wp::float32 var_36 = 0.0;
    bool var_37;
    wp::int32 var_38;
    wp::int32 var_39;
    wp::float32 var_40;
    wp::int32 var_41;
    wp::int32 var_42;
    wp::float32 var_43;
    const wp::int32 var_44 = 0;
    wp::int32 var_45;
    wp::int32 var_46;
    wp::int32 var_47;
    wp::int32 var_48;
    wp::float32 var_49;
    const wp::int32 var_50 = 0;
    wp::int32 var_51;
    wp::int32 var_52;
    wp::int32 var_53;
    wp::int32 var_54;
    wp::float32 var_55;
    wp::float32 var_56;
    wp::float32 var_57;
    wp::float32 var_58;
    const wp::float32 var_59 = 0.03;
    wp::float32* var_60;
    wp::float32 var_61;
    wp::float32 var_62;
    bool var_63;
    const wp::int32 var_64 = 1;
    wp::int32 var_65;
    wp::int32 var_66;
    wp::int32 var_67;
    wp::int32 var_68;
    //---------
    // forward
    // def is_inside(at, margin, level, frame__layout, frame__lenses, frame__depth, frame__planes):       <L 1>
    // size = frame__layout[level]                                                            <L 3>
    var_0 = wp::address(var_frame__layout, var_level);
    var_2 = wp::load(var_0);
    var_1 = wp::copy(var_2);
    // lens = frame__lenses[level]                                                            <L 4>
    var_3 = wp::address(var_frame__lenses, var_level);
    var_5 = wp::load(var_3);
    var_4 = wp::copy(var_5);
    // e = at - size[2]                                                                       <L 5>
    var_7 = wp::extract(var_1, var_6);
    var_8 = wp::sub(var_at, var_7);
    // u = e % size[0]                                                                        <L 6>
    var_10 = wp::extract(var_1, var_9);
    var_11 = wp::mod(var_8, var_10);
    // v = e // size[0]                                                                       <L 7>
    var_13 = wp::extract(var_1, var_12);
    var_14 = wp::floordiv(var_8, var_13);
    // inside = int(0)                                                                        <L 8>
    var_16 = wp::int(var_15);
    // if margin == 0:                                                                        <L 9>
    var_18 = (var_margin == var_17);
    if (var_18) {
        // inside = 1                                                                         <L 10>
    }
    if (!var_18) {
        // elif u >= margin and v >= margin and (u < size[0] - margin) and (v < size[1] - margin):       <L 11>
        var_21 = (var_11 >= var_margin);
        var_20 = var_21;
        if (var_20) {
            var_22 = (var_14 >= var_margin);
            var_20 = var_20 && var_22;
        }
        if (var_20) {
            var_24 = wp::extract(var_1, var_23);
            var_25 = wp::sub(var_24, var_margin);
            var_26 = (var_11 < var_25);
            var_20 = var_20 && var_26;
        }
        if (var_20) {
            var_28 = wp::extract(var_1, var_27);
            var_29 = wp::sub(var_28, var_margin);
            var_30 = (var_14 < var_29);
            var_20 = var_20 && var_30;
        }
        if (var_20) {
            // plane = frame__planes[at]                                                      <L 12>
            var_31 = wp::address(var_frame__planes, var_at);
            var_33 = wp::load(var_31);
            var_32 = wp::copy(var_33);
            // if plane[3] < 0.0:                                                             <L 13>
            var_35 = wp::extract(var_32, var_34);
            var_37 = (var_35 < var_36);
            if (var_37) {
                // left = leaves_plane(at - margin, u - margin, v, plane, lens, frame__depth)       <L 14>
                var_38 = wp::sub(var_at, var_margin);
                var_39 = wp::sub(var_11, var_margin);
                var_40 = leaves_plane_0(var_38, var_39, var_14, var_32, var_4, var_frame__depth);
                // right = leaves_plane(at + margin, u + margin, v, plane, lens, frame__depth)       <L 15>
                var_41 = wp::add(var_at, var_margin);
                var_42 = wp::add(var_11, var_margin);
                var_43 = leaves_plane_0(var_41, var_42, var_14, var_32, var_4, var_frame__depth);
                // above = leaves_plane(at - margin * size[0], u, v - margin, plane, lens, frame__depth)       <L 16>
                var_45 = wp::extract(var_1, var_44);
                var_46 = wp::mul(var_margin, var_45);
                var_47 = wp::sub(var_at, var_46);
                var_48 = wp::sub(var_14, var_margin);
                var_49 = leaves_plane_0(var_47, var_11, var_48, var_32, var_4, var_frame__depth);
                // below = leaves_plane(at + margin * size[0], u, v + margin, plane, lens, frame__depth)       <L 17>
                var_51 = wp::extract(var_1, var_50);
                var_52 = wp::mul(var_margin, var_51);
                var_53 = wp::add(var_at, var_52);
                var_54 = wp::add(var_14, var_margin);
                var_55 = leaves_plane_0(var_53, var_11, var_54, var_32, var_4, var_frame__depth);
                // if max(max(left, right), max(above, below)) < EDGE_STEP * frame__depth[at]:       <L 18>
                var_56 = wp::max(var_40, var_43);
                var_57 = wp::max(var_49, var_55);
                var_58 = wp::max(var_56, var_57);
                var_60 = wp::address(var_frame__depth, var_at);
                var_62 = wp::load(var_60);
                var_61 = wp::mul(var_59, var_62);
                var_63 = (var_58 < var_61);
                if (var_63) {
                    // inside = 1                                                             <L 19>
                }
                var_65 = wp::where(var_63, var_64, var_16);
            }
            var_66 = wp::where(var_37, var_65, var_16);
        }
        var_67 = wp::where(var_20, var_66, var_16);
    }
    var_68 = wp::where(var_18, var_19, var_67);
    // return inside                                                                          <L 20>
    return var_68;
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


// /work/main/src/pointloom/kernels/rgbd/alignment.py:79
static CUDA_CALLABLE wp::vec_t<22, wp::float64> squares_of_0(
    wp::vec_t<6, wp::float32> var_g,
    wp::vec_t<6, wp::float32> var_j,
    wp::vec_t<6, wp::float32> var_h,
    wp::vec_t<6, wp::float32> var_k,
    wp::float32 var_count)
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
    wp::float64 var_252;
    wp::vec_t<22, wp::float64> var_253;
    //---------
    // forward
    // def squares_of(g: row, j: row, h: row, k: row, count: float) -> certainty_sums:        <L 80>
    // return certainty_sums(                                                                 <L 82>
    // float64(g[0] * j[0] + h[0] * k[0]), float64(g[0] * j[1] + h[0] * k[1]), float64(g[0] * j[2] + h[0] * k[2]),       <L 83>
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
    var_25 = wp::extract(var_g, var_24);
    var_27 = wp::extract(var_j, var_26);
    var_28 = wp::mul(var_25, var_27);
    var_30 = wp::extract(var_h, var_29);
    var_32 = wp::extract(var_k, var_31);
    var_33 = wp::mul(var_30, var_32);
    var_34 = wp::add(var_28, var_33);
    var_35 = wp::float64(var_34);
    // float64(g[0] * j[3] + h[0] * k[3]), float64(g[0] * j[4] + h[0] * k[4]), float64(g[0] * j[5] + h[0] * k[5]),       <L 84>
    var_37 = wp::extract(var_g, var_36);
    var_39 = wp::extract(var_j, var_38);
    var_40 = wp::mul(var_37, var_39);
    var_42 = wp::extract(var_h, var_41);
    var_44 = wp::extract(var_k, var_43);
    var_45 = wp::mul(var_42, var_44);
    var_46 = wp::add(var_40, var_45);
    var_47 = wp::float64(var_46);
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
    // float64(g[1] * j[1] + h[1] * k[1]), float64(g[1] * j[2] + h[1] * k[2]), float64(g[1] * j[3] + h[1] * k[3]),       <L 85>
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
    var_97 = wp::extract(var_g, var_96);
    var_99 = wp::extract(var_j, var_98);
    var_100 = wp::mul(var_97, var_99);
    var_102 = wp::extract(var_h, var_101);
    var_104 = wp::extract(var_k, var_103);
    var_105 = wp::mul(var_102, var_104);
    var_106 = wp::add(var_100, var_105);
    var_107 = wp::float64(var_106);
    // float64(g[1] * j[4] + h[1] * k[4]), float64(g[1] * j[5] + h[1] * k[5]), float64(g[2] * j[2] + h[2] * k[2]),       <L 86>
    var_109 = wp::extract(var_g, var_108);
    var_111 = wp::extract(var_j, var_110);
    var_112 = wp::mul(var_109, var_111);
    var_114 = wp::extract(var_h, var_113);
    var_116 = wp::extract(var_k, var_115);
    var_117 = wp::mul(var_114, var_116);
    var_118 = wp::add(var_112, var_117);
    var_119 = wp::float64(var_118);
    var_121 = wp::extract(var_g, var_120);
    var_123 = wp::extract(var_j, var_122);
    var_124 = wp::mul(var_121, var_123);
    var_126 = wp::extract(var_h, var_125);
    var_128 = wp::extract(var_k, var_127);
    var_129 = wp::mul(var_126, var_128);
    var_130 = wp::add(var_124, var_129);
    var_131 = wp::float64(var_130);
    var_133 = wp::extract(var_g, var_132);
    var_135 = wp::extract(var_j, var_134);
    var_136 = wp::mul(var_133, var_135);
    var_138 = wp::extract(var_h, var_137);
    var_140 = wp::extract(var_k, var_139);
    var_141 = wp::mul(var_138, var_140);
    var_142 = wp::add(var_136, var_141);
    var_143 = wp::float64(var_142);
    // float64(g[2] * j[3] + h[2] * k[3]), float64(g[2] * j[4] + h[2] * k[4]), float64(g[2] * j[5] + h[2] * k[5]),       <L 87>
    var_145 = wp::extract(var_g, var_144);
    var_147 = wp::extract(var_j, var_146);
    var_148 = wp::mul(var_145, var_147);
    var_150 = wp::extract(var_h, var_149);
    var_152 = wp::extract(var_k, var_151);
    var_153 = wp::mul(var_150, var_152);
    var_154 = wp::add(var_148, var_153);
    var_155 = wp::float64(var_154);
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
    // float64(g[3] * j[3] + h[3] * k[3]), float64(g[3] * j[4] + h[3] * k[4]), float64(g[3] * j[5] + h[3] * k[5]),       <L 88>
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
    var_205 = wp::extract(var_g, var_204);
    var_207 = wp::extract(var_j, var_206);
    var_208 = wp::mul(var_205, var_207);
    var_210 = wp::extract(var_h, var_209);
    var_212 = wp::extract(var_k, var_211);
    var_213 = wp::mul(var_210, var_212);
    var_214 = wp::add(var_208, var_213);
    var_215 = wp::float64(var_214);
    // float64(g[4] * j[4] + h[4] * k[4]), float64(g[4] * j[5] + h[4] * k[5]), float64(g[5] * j[5] + h[5] * k[5]),       <L 89>
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
    var_241 = wp::extract(var_g, var_240);
    var_243 = wp::extract(var_j, var_242);
    var_244 = wp::mul(var_241, var_243);
    var_246 = wp::extract(var_h, var_245);
    var_248 = wp::extract(var_k, var_247);
    var_249 = wp::mul(var_246, var_248);
    var_250 = wp::add(var_244, var_249);
    var_251 = wp::float64(var_250);
    // float64(count),                                                                        <L 90>
    var_252 = wp::float64(var_count);
    var_253 = wp::vec_t<22, wp::float64>({var_11, var_23, var_35, var_47, var_59, var_71, var_83, var_95, var_107, var_119, var_131, var_143, var_155, var_167, var_179, var_191, var_203, var_215, var_227, var_239, var_251, var_252});
    return var_253;
}


// <pointloom.kernels.rgbd.alignment.sum_certainty_element>:1
static CUDA_CALLABLE wp::vec_t<22, wp::float64> sum_certainty_element_0(
    wp::array_t<wp::vec_t<4, wp::int32>> var_source__layout,
    wp::array_t<wp::float32> var_source__depth,
    wp::array_t<wp::float32> var_source__brightness,
    wp::array_t<wp::vec_t<4, wp::int32>> var_target__layout,
    wp::array_t<wp::vec_t<4, wp::float32>> var_target__lenses,
    wp::array_t<wp::float32> var_target__depth,
    wp::array_t<wp::float32> var_target__brightness,
    wp::array_t<wp::vec_t<4, wp::float32>> var_target__planes,
    wp::int32 var_level,
    wp::int32 var_other,
    wp::float32 var_surface_share,
    wp::float32 var_brightness_share,
    wp::int32 var_margin,
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
    wp::vec_t<6, wp::float32> var_10;
    const wp::float32 var_11 = 0.0;
    wp::vec_t<6, wp::float32> var_12;
    const wp::float32 var_13 = 0.0;
    wp::vec_t<6, wp::float32> var_14;
    const wp::float32 var_15 = 0.0;
    wp::vec_t<6, wp::float32> var_16;
    const wp::float32 var_17 = 0.0;
    wp::float32 var_18;
    const wp::float32 var_19 = 0.0;
    bool var_20;
    const wp::int32 var_21 = 0;
    wp::int32 var_22;
    wp::int32 var_23;
    wp::float32 var_24;
    const wp::int32 var_25 = 0;
    wp::int32 var_26;
    wp::int32 var_27;
    wp::float32 var_28;
    wp::vec_t<3, wp::float32> var_29;
    wp::float32 var_30;
    wp::float32 var_31;
    wp::int32 var_32;
    const wp::float32 var_33 = 0.0;
    wp::float32 var_34;
    const wp::int32 var_35 = 0;
    bool var_36;
    wp::float32* var_37;
    wp::float32 var_38;
    wp::float32 var_39;
    wp::float32 var_40;
    const wp::int32 var_41 = 2;
    wp::float32 var_42;
    wp::float32 var_43;
    bool var_44;
    const wp::float32 var_45 = 0.0;
    bool var_46;
    const wp::int32 var_47 = 2;
    wp::float32 var_48;
    wp::float32 var_49;
    wp::float32 var_50;
    const wp::float32 var_51 = 4.0;
    const wp::float32 var_52 = 0.01;
    const wp::int32 var_53 = 2;
    wp::float32 var_54;
    wp::float32 var_55;
    wp::float32 var_56;
    wp::float32 var_57;
    bool var_58;
    const wp::float32 var_59 = 1.0;
    wp::vec_t<4, wp::float32>* var_60;
    wp::vec_t<4, wp::float32> var_61;
    wp::vec_t<4, wp::float32> var_62;
    wp::int32 var_63;
    bool var_64;
    const wp::int32 var_65 = 3;
    wp::float32 var_66;
    const wp::float32 var_67 = 0.0;
    bool var_68;
    const wp::int32 var_69 = 1;
    bool var_70;
    wp::vec_t<6, wp::float32> var_71;
    wp::float32 var_72;
    wp::float32 var_73;
    wp::vec_t<6, wp::float32> var_74;
    wp::vec_t<6, wp::float32> var_75;
    wp::vec_t<6, wp::float32> var_76;
    bool var_77;
    wp::float32* var_78;
    const wp::float32 var_79 = 0.0;
    bool var_80;
    wp::float32 var_81;
    const wp::float32 var_82 = 0.0;
    bool var_83;
    const wp::int32 var_84 = 1;
    bool var_85;
    wp::vec_t<4, wp::float32> var_86;
    const wp::int32 var_87 = 1;
    wp::float32 var_88;
    const wp::int32 var_89 = 1;
    wp::float32 var_90;
    wp::float32 var_91;
    const wp::int32 var_92 = 2;
    wp::float32 var_93;
    const wp::int32 var_94 = 2;
    wp::float32 var_95;
    wp::float32 var_96;
    wp::float32 var_97;
    const wp::float32 var_98 = 0.015;
    wp::float32 var_99;
    bool var_100;
    wp::vec_t<6, wp::float32> var_101;
    const wp::float32 var_102 = 1.0;
    const wp::float32 var_103 = 0.04;
    wp::float32 var_104;
    wp::float32 var_105;
    const wp::int32 var_106 = 0;
    bool var_107;
    const wp::int32 var_108 = 1;
    wp::float32* var_109;
    const wp::float32 var_110 = 0.1;
    wp::float32 var_111;
    wp::float32 var_112;
    wp::float32 var_113;
    wp::float32 var_114;
    wp::vec_t<6, wp::float32> var_115;
    wp::vec_t<6, wp::float32> var_116;
    wp::vec_t<6, wp::float32> var_117;
    wp::vec_t<6, wp::float32> var_118;
    wp::vec_t<6, wp::float32> var_119;
    wp::vec_t<6, wp::float32> var_120;
    wp::vec_t<6, wp::float32> var_121;
    wp::vec_t<6, wp::float32> var_122;
    wp::vec_t<6, wp::float32> var_123;
    wp::float32 var_124;
    wp::vec_t<6, wp::float32> var_125;
    wp::vec_t<6, wp::float32> var_126;
    wp::vec_t<6, wp::float32> var_127;
    wp::vec_t<6, wp::float32> var_128;
    wp::float32 var_129;
    wp::vec_t<22, wp::float64> var_130;
    //---------
    // forward
    // def sum_certainty_element(source__layout, source__depth, source__brightness, target__layout, target__lenses, target__depth, target__brightness, target__planes, level, other, surface_share, brightness_share, margin, warps, scales, e):       <L 1>
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
    // g = row(0.0)                                                                           <L 5>
    var_10 = wp::vec_t<6, wp::float32>(var_9);
    // j = row(0.0)                                                                           <L 6>
    var_12 = wp::vec_t<6, wp::float32>(var_11);
    // h = row(0.0)                                                                           <L 7>
    var_14 = wp::vec_t<6, wp::float32>(var_13);
    // k = row(0.0)                                                                           <L 8>
    var_16 = wp::vec_t<6, wp::float32>(var_15);
    // count = float(0.0)                                                                     <L 9>
    var_18 = wp::float(var_17);
    // if z > 0.0:                                                                            <L 10>
    var_20 = (var_7 > var_19);
    if (var_20) {
        // p = moved_point(float(e % size[0]), float(e // size[0]), z, warps)                 <L 11>
        var_22 = wp::extract(var_1, var_21);
        var_23 = wp::mod(var_e, var_22);
        var_24 = wp::float(var_23);
        var_26 = wp::extract(var_1, var_25);
        var_27 = wp::floordiv(var_e, var_26);
        var_28 = wp::float(var_27);
        var_29 = moved_point_1(var_24, var_28, var_7, var_warps);
        // u, v, at = seen_at(p, other, target__layout, target__lenses)                       <L 12>
        seen_at_0(var_29, var_other, var_target__layout, var_target__lenses, var_30, var_31, var_32);
        // there = float(0.0)                                                                 <L 13>
        var_34 = wp::float(var_33);
        // if at >= 0:                                                                        <L 14>
        var_36 = (var_32 >= var_35);
        if (var_36) {
            // there = target__depth[at]                                                      <L 15>
            var_37 = wp::address(var_target__depth, var_32);
            var_39 = wp::load(var_37);
            var_38 = wp::copy(var_39);
        }
        var_40 = wp::where(var_36, var_38, var_34);
        // noise = depth_noise(p[2])                                                          <L 16>
        var_42 = wp::extract(var_29, var_41);
        var_43 = depth_noise_0(var_42);
        // if there > 0.0 and abs(p[2] - there) < INLIER_LIMIT * (noise + SLOPE_MARGIN * p[2]):       <L 17>
        var_46 = (var_40 > var_45);
        var_44 = var_46;
        if (var_44) {
            var_48 = wp::extract(var_29, var_47);
            var_49 = wp::sub(var_48, var_40);
            var_50 = wp::abs(var_49);
            var_54 = wp::extract(var_29, var_53);
            var_55 = wp::mul(var_52, var_54);
            var_56 = wp::add(var_43, var_55);
            var_57 = wp::mul(var_51, var_56);
            var_58 = (var_50 < var_57);
            var_44 = var_44 && var_58;
        }
        if (var_44) {
            // count = 1.0                                                                    <L 18>
            // plane = target__planes[at]                                                     <L 19>
            var_60 = wp::address(var_target__planes, var_32);
            var_62 = wp::load(var_60);
            var_61 = wp::copy(var_62);
            // inside = is_inside(at, margin, other, target__layout, target__lenses, target__depth, target__planes)       <L 20>
            var_63 = is_inside_0(var_32, var_margin, var_other, var_target__layout, var_target__lenses, var_target__depth, var_target__planes);
            // if plane[3] < 0.0 and inside == 1:                                             <L 21>
            var_66 = wp::extract(var_61, var_65);
            var_68 = (var_66 < var_67);
            var_64 = var_68;
            if (var_64) {
                var_70 = (var_63 == var_69);
                var_64 = var_64 && var_70;
            }
            if (var_64) {
                // j = surface_row(p, plane)                                                  <L 22>
                var_71 = surface_row_0(var_29, var_61);
                // g = j * (surface_share / (noise * noise))                                  <L 23>
                var_72 = wp::mul(var_43, var_43);
                var_73 = wp::div(var_surface_share, var_72);
                var_74 = wp::mul(var_71, var_73);
            }
            var_75 = wp::where(var_64, var_74, var_10);
            var_76 = wp::where(var_64, var_71, var_12);
            // if source__brightness[i] >= 0.0 and brightness_share > 0.0 and (inside == 1):       <L 24>
            var_78 = wp::address(var_source__brightness, var_5);
            var_81 = wp::load(var_78);
            var_80 = (var_81 >= var_79);
            var_77 = var_80;
            if (var_77) {
                var_83 = (var_brightness_share > var_82);
                var_77 = var_77 && var_83;
            }
            if (var_77) {
                var_85 = (var_63 == var_84);
                var_77 = var_77 && var_85;
            }
            if (var_77) {
                // sample = seen_brightness(u, v, other, target__layout, target__brightness)       <L 25>
                var_86 = seen_brightness_0(var_30, var_31, var_other, var_target__layout, var_target__brightness);
                // if sample[1] * sample[1] + sample[2] * sample[2] > MIN_SLOPE * MIN_SLOPE:       <L 26>
                var_88 = wp::extract(var_86, var_87);
                var_90 = wp::extract(var_86, var_89);
                var_91 = wp::mul(var_88, var_90);
                var_93 = wp::extract(var_86, var_92);
                var_95 = wp::extract(var_86, var_94);
                var_96 = wp::mul(var_93, var_95);
                var_97 = wp::add(var_91, var_96);
                var_99 = wp::mul(var_98, var_98);
                var_100 = (var_97 > var_99);
                if (var_100) {
                    // k = brightness_row(p, sample, other, target__lenses)                   <L 27>
                    var_101 = brightness_row_0(var_29, var_86, var_other, var_target__lenses);
                    // weight = 1.0 / (SHADE_NOISE * SHADE_NOISE)                             <L 28>
                    var_104 = wp::mul(var_103, var_103);
                    var_105 = wp::div(var_102, var_104);
                    // if margin > 0:                                                         <L 29>
                    var_107 = (var_margin > var_106);
                    if (var_107) {
                        // weight = scales[1] * ALIKE                                         <L 30>
                        var_109 = wp::address(var_scales, var_108);
                        var_112 = wp::load(var_109);
                        var_111 = wp::mul(var_112, var_110);
                    }
                    var_113 = wp::where(var_107, var_111, var_105);
                    // h = k * (brightness_share * weight)                                    <L 31>
                    var_114 = wp::mul(var_brightness_share, var_113);
                    var_115 = wp::mul(var_101, var_114);
                }
                var_116 = wp::where(var_100, var_115, var_14);
                var_117 = wp::where(var_100, var_101, var_16);
            }
            var_118 = wp::where(var_77, var_116, var_14);
            var_119 = wp::where(var_77, var_117, var_16);
        }
        var_120 = wp::where(var_44, var_75, var_10);
        var_121 = wp::where(var_44, var_76, var_12);
        var_122 = wp::where(var_44, var_118, var_14);
        var_123 = wp::where(var_44, var_119, var_16);
        var_124 = wp::where(var_44, var_59, var_18);
    }
    var_125 = wp::where(var_20, var_120, var_10);
    var_126 = wp::where(var_20, var_121, var_12);
    var_127 = wp::where(var_20, var_122, var_14);
    var_128 = wp::where(var_20, var_123, var_16);
    var_129 = wp::where(var_20, var_124, var_18);
    // return squares_of(g, j, h, k, count)                                                   <L 32>
    var_130 = squares_of_0(var_125, var_126, var_127, var_128, var_129);
    return var_130;
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


// <pointloom.kernels.rgbd.alignment.leaves_plane>:1
static CUDA_CALLABLE void adj_leaves_plane_0(
    wp::int32 var_at,
    wp::int32 var_u,
    wp::int32 var_v,
    wp::vec_t<4, wp::float32> var_plane,
    wp::vec_t<4, wp::float32> var_lens,
    wp::array_t<wp::float32> var_frame__depth,
    wp::int32 & adj_at,
    wp::int32 & adj_u,
    wp::int32 & adj_v,
    wp::vec_t<4, wp::float32> & adj_plane,
    wp::vec_t<4, wp::float32> & adj_lens,
    wp::array_t<wp::float32> & adj_frame__depth,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.rgbd.alignment.is_inside>:1
static CUDA_CALLABLE void adj_is_inside_0(
    wp::int32 var_at,
    wp::int32 var_margin,
    wp::int32 var_level,
    wp::array_t<wp::vec_t<4, wp::int32>> var_frame__layout,
    wp::array_t<wp::vec_t<4, wp::float32>> var_frame__lenses,
    wp::array_t<wp::float32> var_frame__depth,
    wp::array_t<wp::vec_t<4, wp::float32>> var_frame__planes,
    wp::int32 & adj_at,
    wp::int32 & adj_margin,
    wp::int32 & adj_level,
    wp::array_t<wp::vec_t<4, wp::int32>> & adj_frame__layout,
    wp::array_t<wp::vec_t<4, wp::float32>> & adj_frame__lenses,
    wp::array_t<wp::float32> & adj_frame__depth,
    wp::array_t<wp::vec_t<4, wp::float32>> & adj_frame__planes,
    wp::int32 & adj_ret)
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


// /work/main/src/pointloom/kernels/rgbd/alignment.py:79
static CUDA_CALLABLE void adj_squares_of_0(
    wp::vec_t<6, wp::float32> var_g,
    wp::vec_t<6, wp::float32> var_j,
    wp::vec_t<6, wp::float32> var_h,
    wp::vec_t<6, wp::float32> var_k,
    wp::float32 var_count,
    wp::vec_t<6, wp::float32> & adj_g,
    wp::vec_t<6, wp::float32> & adj_j,
    wp::vec_t<6, wp::float32> & adj_h,
    wp::vec_t<6, wp::float32> & adj_k,
    wp::float32 & adj_count,
    wp::vec_t<22, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.rgbd.alignment.sum_certainty_element>:1
static CUDA_CALLABLE void adj_sum_certainty_element_0(
    wp::array_t<wp::vec_t<4, wp::int32>> var_source__layout,
    wp::array_t<wp::float32> var_source__depth,
    wp::array_t<wp::float32> var_source__brightness,
    wp::array_t<wp::vec_t<4, wp::int32>> var_target__layout,
    wp::array_t<wp::vec_t<4, wp::float32>> var_target__lenses,
    wp::array_t<wp::float32> var_target__depth,
    wp::array_t<wp::float32> var_target__brightness,
    wp::array_t<wp::vec_t<4, wp::float32>> var_target__planes,
    wp::int32 var_level,
    wp::int32 var_other,
    wp::float32 var_surface_share,
    wp::float32 var_brightness_share,
    wp::int32 var_margin,
    wp::array_t<wp::vec_t<4, wp::float32>> var_warps,
    wp::array_t<wp::float32> var_scales,
    wp::int32 var_e,
    wp::array_t<wp::vec_t<4, wp::int32>> & adj_source__layout,
    wp::array_t<wp::float32> & adj_source__depth,
    wp::array_t<wp::float32> & adj_source__brightness,
    wp::array_t<wp::vec_t<4, wp::int32>> & adj_target__layout,
    wp::array_t<wp::vec_t<4, wp::float32>> & adj_target__lenses,
    wp::array_t<wp::float32> & adj_target__depth,
    wp::array_t<wp::float32> & adj_target__brightness,
    wp::array_t<wp::vec_t<4, wp::float32>> & adj_target__planes,
    wp::int32 & adj_level,
    wp::int32 & adj_other,
    wp::float32 & adj_surface_share,
    wp::float32 & adj_brightness_share,
    wp::int32 & adj_margin,
    wp::array_t<wp::vec_t<4, wp::float32>> & adj_warps,
    wp::array_t<wp::float32> & adj_scales,
    wp::int32 & adj_e,
    wp::vec_t<22, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void sum_certainty_tiles_68aa3d59_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<4, wp::int32>> var_source__layout,
    wp::array_t<wp::float32> var_source__depth,
    wp::array_t<wp::float32> var_source__brightness,
    wp::array_t<wp::vec_t<4, wp::int32>> var_target__layout,
    wp::array_t<wp::vec_t<4, wp::float32>> var_target__lenses,
    wp::array_t<wp::float32> var_target__depth,
    wp::array_t<wp::float32> var_target__brightness,
    wp::array_t<wp::vec_t<4, wp::float32>> var_target__planes,
    wp::int32 var_level,
    wp::int32 var_other,
    wp::float32 var_surface_share,
    wp::float32 var_brightness_share,
    wp::int32 var_margin,
    wp::array_t<wp::vec_t<4, wp::float32>> var_warps,
    wp::array_t<wp::float32> var_scales,
    wp::int32 var_count_,
    wp::array_t<wp::vec_t<22, wp::float64>> var_partials_)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::vec_t<22, wp::float64> var_1;
        bool var_2;
        wp::vec_t<22, wp::float64> var_3;
        wp::vec_t<22, wp::float64> var_4;
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
        wp::vec_t<2, wp::float64> var_139;
        const bool var_140 = true;
        wp::tile_register_t<wp::vec_t<2, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_141 = wp::tile_register_t<wp::vec_t<2, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<2, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_142 = wp::tile_alloc_empty<wp::vec_t<2, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_143 = 0;
        wp::vec_t<2, wp::float64> var_144;
        const wp::int32 var_145 = 0;
        wp::float64 var_146;
        const wp::int32 var_147 = 20;
        const wp::int32 var_148 = 1;
        wp::float64 var_149;
        const wp::int32 var_150 = 21;
        const wp::int32 var_151 = 256;
        wp::int32 var_152;
        const wp::int32 var_153 = 0;
        bool var_154;
        const wp::int32 var_155 = 256;
        wp::int32 var_156;
        //---------
        // forward
        // def sum_certainty_tiles(source__layout, source__depth, source__brightness, target__layout, target__lenses, target__depth, target__brightness, target__planes, level, other, surface_share, brightness_share, margin, warps, scales, count_, partials_):       <L 1>
        // i_ = wp.tid()                                                                          <L 2>
        var_0 = builtin_tid1d();
        // value_ = vector_()                                                                     <L 3>
        var_1 = wp::vec_t<22, wp::float64>();
        // if i_ < count_:                                                                        <L 4>
        var_2 = (var_0 < var_count_);
        if (var_2) {
            // value_ = element_(source__layout, source__depth, source__brightness, target__layout, target__lenses, target__depth, target__brightness, target__planes, level, other, surface_share, brightness_share, margin, warps, scales, i_)       <L 5>
            var_3 = sum_certainty_element_0(var_source__layout, var_source__depth, var_source__brightness, var_target__layout, var_target__lenses, var_target__depth, var_target__brightness, var_target__planes, var_level, var_other, var_surface_share, var_brightness_share, var_margin, var_warps, var_scales, var_0);
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
        // part_20 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[20], value_[21]), preserve_type=True)), 0)       <L 31>
        var_136 = wp::extract(var_4, var_135);
        var_138 = wp::extract(var_4, var_137);
        var_139 = wp::vec_t<2, wp::float64>(var_136, var_138);
        var_141 = wp::tile<wp::vec_t<2, wp::float64>>(var_139);
        var_142 = wp::tile_sum(var_141);
        var_144 = wp::tile_extract(var_142, var_143);
        // value_[20] = part_20[0]                                                                <L 32>
        var_146 = wp::extract(var_144, var_145);
        wp::assign_inplace(var_4, var_147, var_146);
        // value_[21] = part_20[1]                                                                <L 33>
        var_149 = wp::extract(var_144, var_148);
        wp::assign_inplace(var_4, var_150, var_149);
        // if i_ % 256 == 0:                                                                      <L 34>
        var_152 = wp::mod(var_0, var_151);
        var_154 = (var_152 == var_153);
        if (var_154) {
            // partials_[i_ // 256] = value_                                                      <L 35>
            var_156 = wp::floordiv(var_0, var_155);
            wp::array_store(var_partials_, var_156, var_4);
        }
}



extern "C" __global__ void sum_certainty_fold_tiles_e79c77fc_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::int32 var_count_,
    wp::array_t<wp::vec_t<22, wp::float64>> var_partials_,
    wp::array_t<wp::vec_t<22, wp::float64>> var_out_)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::vec_t<22, wp::float64> var_1;
        const wp::int32 var_2 = 256;
        wp::range_t var_3;
        wp::int32 var_4;
        wp::vec_t<22, wp::float64>* var_5;
        wp::vec_t<22, wp::float64> var_6;
        wp::vec_t<22, wp::float64> var_7;
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
        wp::vec_t<2, wp::float64> var_142;
        const bool var_143 = true;
        wp::tile_register_t<wp::vec_t<2, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_144 = wp::tile_register_t<wp::vec_t<2, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<2, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_145 = wp::tile_alloc_empty<wp::vec_t<2, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_146 = 0;
        wp::vec_t<2, wp::float64> var_147;
        const wp::int32 var_148 = 0;
        wp::float64 var_149;
        const wp::int32 var_150 = 20;
        const wp::int32 var_151 = 1;
        wp::float64 var_152;
        const wp::int32 var_153 = 21;
        const wp::int32 var_154 = 0;
        bool var_155;
        const wp::int32 var_156 = 0;
        //---------
        // forward
        // def sum_certainty_fold_tiles(count_, partials_, out_):                                 <L 1>
        // i_ = wp.tid()                                                                          <L 2>
        var_0 = builtin_tid1d();
        // value_ = vector_()                                                                     <L 3>
        var_1 = wp::vec_t<22, wp::float64>();
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
        // part_20 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[20], value_[21]), preserve_type=True)), 0)       <L 31>
        var_139 = wp::extract(var_1, var_138);
        var_141 = wp::extract(var_1, var_140);
        var_142 = wp::vec_t<2, wp::float64>(var_139, var_141);
        var_144 = wp::tile<wp::vec_t<2, wp::float64>>(var_142);
        var_145 = wp::tile_sum(var_144);
        var_147 = wp::tile_extract(var_145, var_146);
        // value_[20] = part_20[0]                                                                <L 32>
        var_149 = wp::extract(var_147, var_148);
        wp::assign_inplace(var_1, var_150, var_149);
        // value_[21] = part_20[1]                                                                <L 33>
        var_152 = wp::extract(var_147, var_151);
        wp::assign_inplace(var_1, var_153, var_152);
        // if i_ == 0:                                                                            <L 34>
        var_155 = (var_0 == var_154);
        if (var_155) {
            // out_[0] = value_                                                                   <L 35>
            wp::array_store(var_out_, var_156, var_1);
        }
}


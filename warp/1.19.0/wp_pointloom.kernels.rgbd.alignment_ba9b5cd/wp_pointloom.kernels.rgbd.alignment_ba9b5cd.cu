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


// <pointloom.kernels.rgbd.alignment.set_warps>:1
static CUDA_CALLABLE void set_warps_0(
    wp::int32 var_level,
    wp::array_t<wp::vec_t<4, wp::float32>> var_source__lenses,
    wp::mat_t<4, 4, wp::float64> var_pose,
    wp::array_t<wp::vec_t<4, wp::float32>> var_warps)
{
    //---------
    // primal vars
    wp::vec_t<4, wp::float32>* var_0;
    wp::vec_t<4, wp::float32> var_1;
    wp::vec_t<4, wp::float32> var_2;
    const wp::int32 var_3 = 0;
    wp::float32 var_4;
    wp::float64 var_5;
    const wp::int32 var_6 = 1;
    wp::float32 var_7;
    wp::float64 var_8;
    const wp::int32 var_9 = 2;
    wp::float32 var_10;
    wp::float64 var_11;
    const wp::int32 var_12 = 3;
    wp::float32 var_13;
    wp::float64 var_14;
    const wp::int32 var_15 = 0;
    const wp::int32 var_16 = 0;
    wp::float64 var_17;
    wp::float64 var_18;
    wp::float32 var_19;
    const wp::int32 var_20 = 1;
    const wp::int32 var_21 = 0;
    wp::float64 var_22;
    wp::float64 var_23;
    wp::float32 var_24;
    const wp::int32 var_25 = 2;
    const wp::int32 var_26 = 0;
    wp::float64 var_27;
    wp::float64 var_28;
    wp::float32 var_29;
    const wp::int32 var_30 = 0;
    const wp::int32 var_31 = 3;
    wp::float64 var_32;
    wp::float32 var_33;
    wp::vec_t<4, wp::float32> var_34;
    const wp::int32 var_35 = 0;
    const wp::int32 var_36 = 1;
    wp::float64 var_37;
    wp::float64 var_38;
    wp::float32 var_39;
    const wp::int32 var_40 = 1;
    const wp::int32 var_41 = 1;
    wp::float64 var_42;
    wp::float64 var_43;
    wp::float32 var_44;
    const wp::int32 var_45 = 2;
    const wp::int32 var_46 = 1;
    wp::float64 var_47;
    wp::float64 var_48;
    wp::float32 var_49;
    const wp::int32 var_50 = 1;
    const wp::int32 var_51 = 3;
    wp::float64 var_52;
    wp::float32 var_53;
    wp::vec_t<4, wp::float32> var_54;
    const wp::int32 var_55 = 0;
    const wp::int32 var_56 = 2;
    wp::float64 var_57;
    const wp::int32 var_58 = 0;
    const wp::int32 var_59 = 0;
    wp::float64 var_60;
    wp::float64 var_61;
    wp::float64 var_62;
    wp::float64 var_63;
    const wp::int32 var_64 = 0;
    const wp::int32 var_65 = 1;
    wp::float64 var_66;
    wp::float64 var_67;
    wp::float64 var_68;
    wp::float64 var_69;
    wp::float32 var_70;
    const wp::int32 var_71 = 1;
    const wp::int32 var_72 = 2;
    wp::float64 var_73;
    const wp::int32 var_74 = 1;
    const wp::int32 var_75 = 0;
    wp::float64 var_76;
    wp::float64 var_77;
    wp::float64 var_78;
    wp::float64 var_79;
    const wp::int32 var_80 = 1;
    const wp::int32 var_81 = 1;
    wp::float64 var_82;
    wp::float64 var_83;
    wp::float64 var_84;
    wp::float64 var_85;
    wp::float32 var_86;
    const wp::int32 var_87 = 2;
    const wp::int32 var_88 = 2;
    wp::float64 var_89;
    const wp::int32 var_90 = 2;
    const wp::int32 var_91 = 0;
    wp::float64 var_92;
    wp::float64 var_93;
    wp::float64 var_94;
    wp::float64 var_95;
    const wp::int32 var_96 = 2;
    const wp::int32 var_97 = 1;
    wp::float64 var_98;
    wp::float64 var_99;
    wp::float64 var_100;
    wp::float64 var_101;
    wp::float32 var_102;
    const wp::int32 var_103 = 2;
    const wp::int32 var_104 = 3;
    wp::float64 var_105;
    wp::float32 var_106;
    wp::vec_t<4, wp::float32> var_107;
    const wp::int32 var_108 = 0;
    const wp::int32 var_109 = 1;
    const wp::int32 var_110 = 2;
    //---------
    // forward
    // def set_warps(level, source__lenses, pose, warps):                                     <L 1>
    // lens = source__lenses[level]                                                           <L 3>
    var_0 = wp::address(var_source__lenses, var_level);
    var_2 = wp::load(var_0);
    var_1 = wp::copy(var_2);
    // fx = float64(lens[0])                                                                  <L 4>
    var_4 = wp::extract(var_1, var_3);
    var_5 = wp::float64(var_4);
    // fy = float64(lens[1])                                                                  <L 5>
    var_7 = wp::extract(var_1, var_6);
    var_8 = wp::float64(var_7);
    // cx = float64(lens[2])                                                                  <L 6>
    var_10 = wp::extract(var_1, var_9);
    var_11 = wp::float64(var_10);
    // cy = float64(lens[3])                                                                  <L 7>
    var_13 = wp::extract(var_1, var_12);
    var_14 = wp::float64(var_13);
    // a = vec4(float(pose[0, 0] / fx), float(pose[1, 0] / fx), float(pose[2, 0] / fx), float(pose[0, 3]))       <L 8>
    var_17 = wp::extract(var_pose, var_15, var_16);
    var_18 = wp::div(var_17, var_5);
    var_19 = wp::float(var_18);
    var_22 = wp::extract(var_pose, var_20, var_21);
    var_23 = wp::div(var_22, var_5);
    var_24 = wp::float(var_23);
    var_27 = wp::extract(var_pose, var_25, var_26);
    var_28 = wp::div(var_27, var_5);
    var_29 = wp::float(var_28);
    var_32 = wp::extract(var_pose, var_30, var_31);
    var_33 = wp::float(var_32);
    var_34 = wp::vec_t<4, wp::float32>(var_19, var_24, var_29, var_33);
    // b = vec4(float(pose[0, 1] / fy), float(pose[1, 1] / fy), float(pose[2, 1] / fy), float(pose[1, 3]))       <L 9>
    var_37 = wp::extract(var_pose, var_35, var_36);
    var_38 = wp::div(var_37, var_8);
    var_39 = wp::float(var_38);
    var_42 = wp::extract(var_pose, var_40, var_41);
    var_43 = wp::div(var_42, var_8);
    var_44 = wp::float(var_43);
    var_47 = wp::extract(var_pose, var_45, var_46);
    var_48 = wp::div(var_47, var_8);
    var_49 = wp::float(var_48);
    var_52 = wp::extract(var_pose, var_50, var_51);
    var_53 = wp::float(var_52);
    var_54 = wp::vec_t<4, wp::float32>(var_39, var_44, var_49, var_53);
    // c = vec4(float(pose[0, 2] - pose[0, 0] * cx / fx - pose[0, 1] * cy / fy), float(pose[1, 2] - pose[1, 0] * cx / fx - pose[1, 1] * cy / fy), float(pose[2, 2] - pose[2, 0] * cx / fx - pose[2, 1] * cy / fy), float(pose[2, 3]))       <L 10>
    var_57 = wp::extract(var_pose, var_55, var_56);
    var_60 = wp::extract(var_pose, var_58, var_59);
    var_61 = wp::mul(var_60, var_11);
    var_62 = wp::div(var_61, var_5);
    var_63 = wp::sub(var_57, var_62);
    var_66 = wp::extract(var_pose, var_64, var_65);
    var_67 = wp::mul(var_66, var_14);
    var_68 = wp::div(var_67, var_8);
    var_69 = wp::sub(var_63, var_68);
    var_70 = wp::float(var_69);
    var_73 = wp::extract(var_pose, var_71, var_72);
    var_76 = wp::extract(var_pose, var_74, var_75);
    var_77 = wp::mul(var_76, var_11);
    var_78 = wp::div(var_77, var_5);
    var_79 = wp::sub(var_73, var_78);
    var_82 = wp::extract(var_pose, var_80, var_81);
    var_83 = wp::mul(var_82, var_14);
    var_84 = wp::div(var_83, var_8);
    var_85 = wp::sub(var_79, var_84);
    var_86 = wp::float(var_85);
    var_89 = wp::extract(var_pose, var_87, var_88);
    var_92 = wp::extract(var_pose, var_90, var_91);
    var_93 = wp::mul(var_92, var_11);
    var_94 = wp::div(var_93, var_5);
    var_95 = wp::sub(var_89, var_94);
    var_98 = wp::extract(var_pose, var_96, var_97);
    var_99 = wp::mul(var_98, var_14);
    var_100 = wp::div(var_99, var_8);
    var_101 = wp::sub(var_95, var_100);
    var_102 = wp::float(var_101);
    var_105 = wp::extract(var_pose, var_103, var_104);
    var_106 = wp::float(var_105);
    var_107 = wp::vec_t<4, wp::float32>(var_70, var_86, var_102, var_106);
    // warps[0] = a                                                                           <L 11>
    wp::array_store(var_warps, var_108, var_34);
    // warps[1] = b                                                                           <L 12>
    wp::array_store(var_warps, var_109, var_54);
    // warps[2] = c                                                                           <L 13>
    wp::array_store(var_warps, var_110, var_107);
}


// /work/main/src/pointloom/kernels/rgbd/alignment.py:197
static CUDA_CALLABLE wp::float64 bounded_0(
    wp::float64 var_value,
    wp::float64 var_low,
    wp::float64 var_high)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::float64 var_1;
    //---------
    // forward
    // def bounded(value: float64, low: float64, high: float64) -> float64:                   <L 198>
    // return min(max(value, low), high)                                                      <L 199>
    var_0 = wp::max(var_value, var_low);
    var_1 = wp::min(var_0, var_high);
    return var_1;
}


// <pointloom.kernels.rgbd.alignment.learn_noise>:1
static CUDA_CALLABLE void learn_noise_0(
    wp::vec_t<38, wp::float64> var_total,
    wp::array_t<wp::float32> var_state__scales)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 27;
    wp::float64 var_1;
    wp::float64 var_2;
    bool var_3;
    const wp::int32 var_4 = 28;
    wp::float64 var_5;
    wp::float64 var_6;
    wp::float64 var_7;
    wp::float64 var_8;
    wp::float64 var_9;
    wp::float64 var_10;
    wp::float64 var_11;
    wp::float32 var_12;
    const wp::int32 var_13 = 0;
    const wp::int32 var_14 = 30;
    wp::float64 var_15;
    wp::float64 var_16;
    bool var_17;
    wp::float64 var_18;
    wp::float64 var_19;
    wp::float64 var_20;
    wp::float64 var_21;
    wp::float64 var_22;
    wp::float64 var_23;
    wp::float64 var_24;
    const wp::int32 var_25 = 31;
    wp::float64 var_26;
    wp::float64 var_27;
    wp::float64 var_28;
    wp::float64 var_29;
    wp::float32 var_30;
    const wp::int32 var_31 = 1;
    const wp::int32 var_32 = 32;
    wp::float64 var_33;
    const wp::int32 var_34 = 1;
    wp::int32 var_35;
    wp::float64 var_36;
    wp::float64 var_37;
    const wp::int32 var_38 = 2;
    wp::int32 var_39;
    wp::float64 var_40;
    wp::float64 var_41;
    const wp::int32 var_42 = 3;
    wp::int32 var_43;
    wp::float64 var_44;
    wp::float64 var_45;
    wp::float64 var_46;
    wp::float64 var_47;
    const wp::int32 var_48 = 4;
    wp::int32 var_49;
    wp::float64 var_50;
    wp::float64 var_51;
    wp::float64 var_52;
    wp::float64 var_53;
    wp::float64 var_54;
    wp::float64 var_55;
    wp::float64 var_56;
    bool var_57;
    wp::float64 var_58;
    wp::float64 var_59;
    wp::float64 var_60;
    wp::float64 var_61;
    wp::float64 var_62;
    wp::float64 var_63;
    wp::float32 var_64;
    const wp::int32 var_65 = 2;
    wp::float64 var_66;
    wp::float64 var_67;
    wp::float32 var_68;
    const wp::int32 var_69 = 3;
    //---------
    // forward
    // def learn_noise(total, state__scales):                                                 <L 1>
    // count = total[SURFACE_COUNT]                                                           <L 3>
    var_1 = wp::extract(var_total, var_0);
    // if count > float64(MIN_PIXELS):                                                        <L 4>
    var_2 = 12.0;
    var_3 = (var_1 > var_2);
    if (var_3) {
        // variance = bounded(total[SURFACE_ERROR] / count, float64(MIN_NOISE), float64(MAX_NOISE))       <L 5>
        var_5 = wp::extract(var_total, var_4);
        var_6 = wp::div(var_5, var_1);
        var_7 = 0.25;
        var_8 = 100.0;
        var_9 = bounded_0(var_6, var_7, var_8);
        // state__scales[0] = float(float64(1.0) / variance)                                  <L 6>
        var_10 = 1.0;
        var_11 = wp::div(var_10, var_9);
        var_12 = wp::float(var_11);
        wp::array_store(var_state__scales, var_13, var_12);
    }
    // count = total[BRIGHTNESS_COUNT]                                                        <L 7>
    var_15 = wp::extract(var_total, var_14);
    // if count > float64(MIN_PIXELS):                                                        <L 8>
    var_16 = wp::float64(var_2);
    var_17 = (var_15 > var_16);
    if (var_17) {
        // low = float64(MIN_SHADE_NOISE) * float64(MIN_SHADE_NOISE)                          <L 9>
        var_18 = 0.004;
        var_19 = wp::float64(var_18);
        var_20 = wp::mul(var_18, var_19);
        // high = float64(MAX_SHADE_NOISE) * float64(MAX_SHADE_NOISE)                         <L 10>
        var_21 = 0.2;
        var_22 = wp::float64(var_21);
        var_23 = wp::mul(var_21, var_22);
        // state__scales[1] = float(float64(1.0) / bounded(total[BRIGHTNESS_ERROR] / count, low, high))       <L 11>
        var_24 = 1.0;
        var_26 = wp::extract(var_total, var_25);
        var_27 = wp::div(var_26, var_15);
        var_28 = bounded_0(var_27, var_20, var_23);
        var_29 = wp::div(var_24, var_28);
        var_30 = wp::float(var_29);
        wp::array_store(var_state__scales, var_31, var_30);
        // weight = total[SHADES]                                                             <L 12>
        var_33 = wp::extract(var_total, var_32);
        // source = total[SHADES + 1] / weight                                                <L 13>
        var_35 = wp::add(var_32, var_34);
        var_36 = wp::extract(var_total, var_35);
        var_37 = wp::div(var_36, var_33);
        // target = total[SHADES + 2] / weight                                                <L 14>
        var_39 = wp::add(var_32, var_38);
        var_40 = wp::extract(var_total, var_39);
        var_41 = wp::div(var_40, var_33);
        // source_variance = total[SHADES + 3] / weight - source * source                     <L 15>
        var_43 = wp::add(var_32, var_42);
        var_44 = wp::extract(var_total, var_43);
        var_45 = wp::div(var_44, var_33);
        var_46 = wp::mul(var_37, var_37);
        var_47 = wp::sub(var_45, var_46);
        // target_variance = total[SHADES + 4] / weight - target * target                     <L 16>
        var_49 = wp::add(var_32, var_48);
        var_50 = wp::extract(var_total, var_49);
        var_51 = wp::div(var_50, var_33);
        var_52 = wp::mul(var_41, var_41);
        var_53 = wp::sub(var_51, var_52);
        // gain = float64(1.0)                                                                <L 17>
        var_54 = 1.0;
        // if min(source_variance, target_variance) > float64(MIN_VARIANCE):                  <L 18>
        var_55 = wp::min(var_47, var_53);
        var_56 = 0.0001;
        var_57 = (var_55 > var_56);
        if (var_57) {
            // gain = bounded(sqrt(target_variance / source_variance), float64(MIN_GAIN), float64(MAX_GAIN))       <L 19>
            var_58 = wp::div(var_53, var_47);
            var_59 = wp::sqrt(var_58);
            var_60 = 0.5;
            var_61 = 2.0;
            var_62 = bounded_0(var_59, var_60, var_61);
        }
        var_63 = wp::where(var_57, var_62, var_54);
        // state__scales[2] = float(gain)                                                     <L 20>
        var_64 = wp::float(var_63);
        wp::array_store(var_state__scales, var_65, var_64);
        // state__scales[3] = float(target - gain * source)                                   <L 21>
        var_66 = wp::mul(var_63, var_37);
        var_67 = wp::sub(var_41, var_66);
        var_68 = wp::float(var_67);
        wp::array_store(var_state__scales, var_69, var_68);
    }
}


// /work/main/src/pointloom/kernels/algebra/rigid_solve.py:21
static CUDA_CALLABLE wp::int32 triangle_index_0(
    wp::int32 var_row,
    wp::int32 var_column)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 6;
    wp::int32 var_1;
    const wp::int32 var_2 = 1;
    wp::int32 var_3;
    wp::int32 var_4;
    const wp::int32 var_5 = 2;
    wp::int32 var_6;
    wp::int32 var_7;
    wp::int32 var_8;
    wp::int32 var_9;
    //---------
    // forward
    // def triangle_index(row: int, column: int) -> int:                                      <L 22>
    // return row * UNKNOWNS - (row * (row - 1)) // 2 + column - row                          <L 24>
    var_1 = wp::mul(var_row, var_0);
    var_3 = wp::sub(var_row, var_2);
    var_4 = wp::mul(var_row, var_3);
    var_6 = wp::floordiv(var_4, var_5);
    var_7 = wp::sub(var_1, var_6);
    var_8 = wp::add(var_7, var_column);
    var_9 = wp::sub(var_8, var_row);
    return var_9;
}


// <pointloom.kernels.algebra.rigid_solve.full_matrix>:1
static CUDA_CALLABLE wp::vec_t<36, wp::float64> full_matrix_0(
    wp::vec_t<21, wp::float64> var_h)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::vec_t<36, wp::float64> var_1;
    const wp::int32 var_2 = 0;
    const wp::int32 var_3 = 0;
    bool var_4;
    wp::int32 var_5;
    wp::float64 var_6;
    const wp::int32 var_7 = 6;
    wp::int32 var_8;
    wp::int32 var_9;
    wp::int32 var_10;
    wp::float64 var_11;
    wp::int32 var_12;
    wp::int32 var_13;
    const wp::int32 var_14 = 1;
    bool var_15;
    wp::int32 var_16;
    wp::float64 var_17;
    wp::int32 var_18;
    wp::int32 var_19;
    wp::int32 var_20;
    wp::float64 var_21;
    wp::int32 var_22;
    wp::int32 var_23;
    const wp::int32 var_24 = 2;
    bool var_25;
    wp::int32 var_26;
    wp::float64 var_27;
    wp::int32 var_28;
    wp::int32 var_29;
    wp::int32 var_30;
    wp::float64 var_31;
    wp::int32 var_32;
    wp::int32 var_33;
    const wp::int32 var_34 = 3;
    bool var_35;
    wp::int32 var_36;
    wp::float64 var_37;
    wp::int32 var_38;
    wp::int32 var_39;
    wp::int32 var_40;
    wp::float64 var_41;
    wp::int32 var_42;
    wp::int32 var_43;
    const wp::int32 var_44 = 4;
    bool var_45;
    wp::int32 var_46;
    wp::float64 var_47;
    wp::int32 var_48;
    wp::int32 var_49;
    wp::int32 var_50;
    wp::float64 var_51;
    wp::int32 var_52;
    wp::int32 var_53;
    const wp::int32 var_54 = 5;
    bool var_55;
    wp::int32 var_56;
    wp::float64 var_57;
    wp::int32 var_58;
    wp::int32 var_59;
    wp::int32 var_60;
    wp::float64 var_61;
    wp::int32 var_62;
    wp::int32 var_63;
    const wp::int32 var_64 = 1;
    const wp::int32 var_65 = 0;
    bool var_66;
    wp::int32 var_67;
    wp::float64 var_68;
    wp::int32 var_69;
    wp::int32 var_70;
    wp::int32 var_71;
    wp::float64 var_72;
    wp::int32 var_73;
    wp::int32 var_74;
    const wp::int32 var_75 = 1;
    bool var_76;
    wp::int32 var_77;
    wp::float64 var_78;
    wp::int32 var_79;
    wp::int32 var_80;
    wp::int32 var_81;
    wp::float64 var_82;
    wp::int32 var_83;
    wp::int32 var_84;
    const wp::int32 var_85 = 2;
    bool var_86;
    wp::int32 var_87;
    wp::float64 var_88;
    wp::int32 var_89;
    wp::int32 var_90;
    wp::int32 var_91;
    wp::float64 var_92;
    wp::int32 var_93;
    wp::int32 var_94;
    const wp::int32 var_95 = 3;
    bool var_96;
    wp::int32 var_97;
    wp::float64 var_98;
    wp::int32 var_99;
    wp::int32 var_100;
    wp::int32 var_101;
    wp::float64 var_102;
    wp::int32 var_103;
    wp::int32 var_104;
    const wp::int32 var_105 = 4;
    bool var_106;
    wp::int32 var_107;
    wp::float64 var_108;
    wp::int32 var_109;
    wp::int32 var_110;
    wp::int32 var_111;
    wp::float64 var_112;
    wp::int32 var_113;
    wp::int32 var_114;
    const wp::int32 var_115 = 5;
    bool var_116;
    wp::int32 var_117;
    wp::float64 var_118;
    wp::int32 var_119;
    wp::int32 var_120;
    wp::int32 var_121;
    wp::float64 var_122;
    wp::int32 var_123;
    wp::int32 var_124;
    const wp::int32 var_125 = 2;
    const wp::int32 var_126 = 0;
    bool var_127;
    wp::int32 var_128;
    wp::float64 var_129;
    wp::int32 var_130;
    wp::int32 var_131;
    wp::int32 var_132;
    wp::float64 var_133;
    wp::int32 var_134;
    wp::int32 var_135;
    const wp::int32 var_136 = 1;
    bool var_137;
    wp::int32 var_138;
    wp::float64 var_139;
    wp::int32 var_140;
    wp::int32 var_141;
    wp::int32 var_142;
    wp::float64 var_143;
    wp::int32 var_144;
    wp::int32 var_145;
    const wp::int32 var_146 = 2;
    bool var_147;
    wp::int32 var_148;
    wp::float64 var_149;
    wp::int32 var_150;
    wp::int32 var_151;
    wp::int32 var_152;
    wp::float64 var_153;
    wp::int32 var_154;
    wp::int32 var_155;
    const wp::int32 var_156 = 3;
    bool var_157;
    wp::int32 var_158;
    wp::float64 var_159;
    wp::int32 var_160;
    wp::int32 var_161;
    wp::int32 var_162;
    wp::float64 var_163;
    wp::int32 var_164;
    wp::int32 var_165;
    const wp::int32 var_166 = 4;
    bool var_167;
    wp::int32 var_168;
    wp::float64 var_169;
    wp::int32 var_170;
    wp::int32 var_171;
    wp::int32 var_172;
    wp::float64 var_173;
    wp::int32 var_174;
    wp::int32 var_175;
    const wp::int32 var_176 = 5;
    bool var_177;
    wp::int32 var_178;
    wp::float64 var_179;
    wp::int32 var_180;
    wp::int32 var_181;
    wp::int32 var_182;
    wp::float64 var_183;
    wp::int32 var_184;
    wp::int32 var_185;
    const wp::int32 var_186 = 3;
    const wp::int32 var_187 = 0;
    bool var_188;
    wp::int32 var_189;
    wp::float64 var_190;
    wp::int32 var_191;
    wp::int32 var_192;
    wp::int32 var_193;
    wp::float64 var_194;
    wp::int32 var_195;
    wp::int32 var_196;
    const wp::int32 var_197 = 1;
    bool var_198;
    wp::int32 var_199;
    wp::float64 var_200;
    wp::int32 var_201;
    wp::int32 var_202;
    wp::int32 var_203;
    wp::float64 var_204;
    wp::int32 var_205;
    wp::int32 var_206;
    const wp::int32 var_207 = 2;
    bool var_208;
    wp::int32 var_209;
    wp::float64 var_210;
    wp::int32 var_211;
    wp::int32 var_212;
    wp::int32 var_213;
    wp::float64 var_214;
    wp::int32 var_215;
    wp::int32 var_216;
    const wp::int32 var_217 = 3;
    bool var_218;
    wp::int32 var_219;
    wp::float64 var_220;
    wp::int32 var_221;
    wp::int32 var_222;
    wp::int32 var_223;
    wp::float64 var_224;
    wp::int32 var_225;
    wp::int32 var_226;
    const wp::int32 var_227 = 4;
    bool var_228;
    wp::int32 var_229;
    wp::float64 var_230;
    wp::int32 var_231;
    wp::int32 var_232;
    wp::int32 var_233;
    wp::float64 var_234;
    wp::int32 var_235;
    wp::int32 var_236;
    const wp::int32 var_237 = 5;
    bool var_238;
    wp::int32 var_239;
    wp::float64 var_240;
    wp::int32 var_241;
    wp::int32 var_242;
    wp::int32 var_243;
    wp::float64 var_244;
    wp::int32 var_245;
    wp::int32 var_246;
    const wp::int32 var_247 = 4;
    const wp::int32 var_248 = 0;
    bool var_249;
    wp::int32 var_250;
    wp::float64 var_251;
    wp::int32 var_252;
    wp::int32 var_253;
    wp::int32 var_254;
    wp::float64 var_255;
    wp::int32 var_256;
    wp::int32 var_257;
    const wp::int32 var_258 = 1;
    bool var_259;
    wp::int32 var_260;
    wp::float64 var_261;
    wp::int32 var_262;
    wp::int32 var_263;
    wp::int32 var_264;
    wp::float64 var_265;
    wp::int32 var_266;
    wp::int32 var_267;
    const wp::int32 var_268 = 2;
    bool var_269;
    wp::int32 var_270;
    wp::float64 var_271;
    wp::int32 var_272;
    wp::int32 var_273;
    wp::int32 var_274;
    wp::float64 var_275;
    wp::int32 var_276;
    wp::int32 var_277;
    const wp::int32 var_278 = 3;
    bool var_279;
    wp::int32 var_280;
    wp::float64 var_281;
    wp::int32 var_282;
    wp::int32 var_283;
    wp::int32 var_284;
    wp::float64 var_285;
    wp::int32 var_286;
    wp::int32 var_287;
    const wp::int32 var_288 = 4;
    bool var_289;
    wp::int32 var_290;
    wp::float64 var_291;
    wp::int32 var_292;
    wp::int32 var_293;
    wp::int32 var_294;
    wp::float64 var_295;
    wp::int32 var_296;
    wp::int32 var_297;
    const wp::int32 var_298 = 5;
    bool var_299;
    wp::int32 var_300;
    wp::float64 var_301;
    wp::int32 var_302;
    wp::int32 var_303;
    wp::int32 var_304;
    wp::float64 var_305;
    wp::int32 var_306;
    wp::int32 var_307;
    const wp::int32 var_308 = 5;
    const wp::int32 var_309 = 0;
    bool var_310;
    wp::int32 var_311;
    wp::float64 var_312;
    wp::int32 var_313;
    wp::int32 var_314;
    wp::int32 var_315;
    wp::float64 var_316;
    wp::int32 var_317;
    wp::int32 var_318;
    const wp::int32 var_319 = 1;
    bool var_320;
    wp::int32 var_321;
    wp::float64 var_322;
    wp::int32 var_323;
    wp::int32 var_324;
    wp::int32 var_325;
    wp::float64 var_326;
    wp::int32 var_327;
    wp::int32 var_328;
    const wp::int32 var_329 = 2;
    bool var_330;
    wp::int32 var_331;
    wp::float64 var_332;
    wp::int32 var_333;
    wp::int32 var_334;
    wp::int32 var_335;
    wp::float64 var_336;
    wp::int32 var_337;
    wp::int32 var_338;
    const wp::int32 var_339 = 3;
    bool var_340;
    wp::int32 var_341;
    wp::float64 var_342;
    wp::int32 var_343;
    wp::int32 var_344;
    wp::int32 var_345;
    wp::float64 var_346;
    wp::int32 var_347;
    wp::int32 var_348;
    const wp::int32 var_349 = 4;
    bool var_350;
    wp::int32 var_351;
    wp::float64 var_352;
    wp::int32 var_353;
    wp::int32 var_354;
    wp::int32 var_355;
    wp::float64 var_356;
    wp::int32 var_357;
    wp::int32 var_358;
    const wp::int32 var_359 = 5;
    bool var_360;
    wp::int32 var_361;
    wp::float64 var_362;
    wp::int32 var_363;
    wp::int32 var_364;
    wp::int32 var_365;
    wp::float64 var_366;
    wp::int32 var_367;
    wp::int32 var_368;
    //---------
    // forward
    // def full_matrix(h):                                                                    <L 1>
    // a = square(float64(0.0))                                                               <L 2>
    var_0 = 0.0;
    var_1 = wp::vec_t<36, wp::float64>(var_0);
    // for i in range(6):                                                                     <L 3>
    // for j in range(6):                                                                     <L 4>
    // if j >= i:                                                                             <L 5>
    var_4 = (var_3 >= var_2);
    if (var_4) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_5 = triangle_index_0(var_2, var_3);
        var_6 = wp::extract(var_h, var_5);
        var_8 = wp::mul(var_2, var_7);
        var_9 = wp::add(var_8, var_3);
        wp::assign_inplace(var_1, var_9, var_6);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_10 = triangle_index_0(var_2, var_3);
        var_11 = wp::extract(var_h, var_10);
        var_12 = wp::mul(var_3, var_7);
        var_13 = wp::add(var_12, var_2);
        wp::assign_inplace(var_1, var_13, var_11);
    }
    // if j >= i:                                                                             <L 5>
    var_15 = (var_14 >= var_2);
    if (var_15) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_16 = triangle_index_0(var_2, var_14);
        var_17 = wp::extract(var_h, var_16);
        var_18 = wp::mul(var_2, var_7);
        var_19 = wp::add(var_18, var_14);
        wp::assign_inplace(var_1, var_19, var_17);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_20 = triangle_index_0(var_2, var_14);
        var_21 = wp::extract(var_h, var_20);
        var_22 = wp::mul(var_14, var_7);
        var_23 = wp::add(var_22, var_2);
        wp::assign_inplace(var_1, var_23, var_21);
    }
    // if j >= i:                                                                             <L 5>
    var_25 = (var_24 >= var_2);
    if (var_25) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_26 = triangle_index_0(var_2, var_24);
        var_27 = wp::extract(var_h, var_26);
        var_28 = wp::mul(var_2, var_7);
        var_29 = wp::add(var_28, var_24);
        wp::assign_inplace(var_1, var_29, var_27);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_30 = triangle_index_0(var_2, var_24);
        var_31 = wp::extract(var_h, var_30);
        var_32 = wp::mul(var_24, var_7);
        var_33 = wp::add(var_32, var_2);
        wp::assign_inplace(var_1, var_33, var_31);
    }
    // if j >= i:                                                                             <L 5>
    var_35 = (var_34 >= var_2);
    if (var_35) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_36 = triangle_index_0(var_2, var_34);
        var_37 = wp::extract(var_h, var_36);
        var_38 = wp::mul(var_2, var_7);
        var_39 = wp::add(var_38, var_34);
        wp::assign_inplace(var_1, var_39, var_37);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_40 = triangle_index_0(var_2, var_34);
        var_41 = wp::extract(var_h, var_40);
        var_42 = wp::mul(var_34, var_7);
        var_43 = wp::add(var_42, var_2);
        wp::assign_inplace(var_1, var_43, var_41);
    }
    // if j >= i:                                                                             <L 5>
    var_45 = (var_44 >= var_2);
    if (var_45) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_46 = triangle_index_0(var_2, var_44);
        var_47 = wp::extract(var_h, var_46);
        var_48 = wp::mul(var_2, var_7);
        var_49 = wp::add(var_48, var_44);
        wp::assign_inplace(var_1, var_49, var_47);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_50 = triangle_index_0(var_2, var_44);
        var_51 = wp::extract(var_h, var_50);
        var_52 = wp::mul(var_44, var_7);
        var_53 = wp::add(var_52, var_2);
        wp::assign_inplace(var_1, var_53, var_51);
    }
    // if j >= i:                                                                             <L 5>
    var_55 = (var_54 >= var_2);
    if (var_55) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_56 = triangle_index_0(var_2, var_54);
        var_57 = wp::extract(var_h, var_56);
        var_58 = wp::mul(var_2, var_7);
        var_59 = wp::add(var_58, var_54);
        wp::assign_inplace(var_1, var_59, var_57);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_60 = triangle_index_0(var_2, var_54);
        var_61 = wp::extract(var_h, var_60);
        var_62 = wp::mul(var_54, var_7);
        var_63 = wp::add(var_62, var_2);
        wp::assign_inplace(var_1, var_63, var_61);
    }
    // for j in range(6):                                                                     <L 4>
    // if j >= i:                                                                             <L 5>
    var_66 = (var_65 >= var_64);
    if (var_66) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_67 = triangle_index_0(var_64, var_65);
        var_68 = wp::extract(var_h, var_67);
        var_69 = wp::mul(var_64, var_7);
        var_70 = wp::add(var_69, var_65);
        wp::assign_inplace(var_1, var_70, var_68);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_71 = triangle_index_0(var_64, var_65);
        var_72 = wp::extract(var_h, var_71);
        var_73 = wp::mul(var_65, var_7);
        var_74 = wp::add(var_73, var_64);
        wp::assign_inplace(var_1, var_74, var_72);
    }
    // if j >= i:                                                                             <L 5>
    var_76 = (var_75 >= var_64);
    if (var_76) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_77 = triangle_index_0(var_64, var_75);
        var_78 = wp::extract(var_h, var_77);
        var_79 = wp::mul(var_64, var_7);
        var_80 = wp::add(var_79, var_75);
        wp::assign_inplace(var_1, var_80, var_78);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_81 = triangle_index_0(var_64, var_75);
        var_82 = wp::extract(var_h, var_81);
        var_83 = wp::mul(var_75, var_7);
        var_84 = wp::add(var_83, var_64);
        wp::assign_inplace(var_1, var_84, var_82);
    }
    // if j >= i:                                                                             <L 5>
    var_86 = (var_85 >= var_64);
    if (var_86) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_87 = triangle_index_0(var_64, var_85);
        var_88 = wp::extract(var_h, var_87);
        var_89 = wp::mul(var_64, var_7);
        var_90 = wp::add(var_89, var_85);
        wp::assign_inplace(var_1, var_90, var_88);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_91 = triangle_index_0(var_64, var_85);
        var_92 = wp::extract(var_h, var_91);
        var_93 = wp::mul(var_85, var_7);
        var_94 = wp::add(var_93, var_64);
        wp::assign_inplace(var_1, var_94, var_92);
    }
    // if j >= i:                                                                             <L 5>
    var_96 = (var_95 >= var_64);
    if (var_96) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_97 = triangle_index_0(var_64, var_95);
        var_98 = wp::extract(var_h, var_97);
        var_99 = wp::mul(var_64, var_7);
        var_100 = wp::add(var_99, var_95);
        wp::assign_inplace(var_1, var_100, var_98);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_101 = triangle_index_0(var_64, var_95);
        var_102 = wp::extract(var_h, var_101);
        var_103 = wp::mul(var_95, var_7);
        var_104 = wp::add(var_103, var_64);
        wp::assign_inplace(var_1, var_104, var_102);
    }
    // if j >= i:                                                                             <L 5>
    var_106 = (var_105 >= var_64);
    if (var_106) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_107 = triangle_index_0(var_64, var_105);
        var_108 = wp::extract(var_h, var_107);
        var_109 = wp::mul(var_64, var_7);
        var_110 = wp::add(var_109, var_105);
        wp::assign_inplace(var_1, var_110, var_108);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_111 = triangle_index_0(var_64, var_105);
        var_112 = wp::extract(var_h, var_111);
        var_113 = wp::mul(var_105, var_7);
        var_114 = wp::add(var_113, var_64);
        wp::assign_inplace(var_1, var_114, var_112);
    }
    // if j >= i:                                                                             <L 5>
    var_116 = (var_115 >= var_64);
    if (var_116) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_117 = triangle_index_0(var_64, var_115);
        var_118 = wp::extract(var_h, var_117);
        var_119 = wp::mul(var_64, var_7);
        var_120 = wp::add(var_119, var_115);
        wp::assign_inplace(var_1, var_120, var_118);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_121 = triangle_index_0(var_64, var_115);
        var_122 = wp::extract(var_h, var_121);
        var_123 = wp::mul(var_115, var_7);
        var_124 = wp::add(var_123, var_64);
        wp::assign_inplace(var_1, var_124, var_122);
    }
    // for j in range(6):                                                                     <L 4>
    // if j >= i:                                                                             <L 5>
    var_127 = (var_126 >= var_125);
    if (var_127) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_128 = triangle_index_0(var_125, var_126);
        var_129 = wp::extract(var_h, var_128);
        var_130 = wp::mul(var_125, var_7);
        var_131 = wp::add(var_130, var_126);
        wp::assign_inplace(var_1, var_131, var_129);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_132 = triangle_index_0(var_125, var_126);
        var_133 = wp::extract(var_h, var_132);
        var_134 = wp::mul(var_126, var_7);
        var_135 = wp::add(var_134, var_125);
        wp::assign_inplace(var_1, var_135, var_133);
    }
    // if j >= i:                                                                             <L 5>
    var_137 = (var_136 >= var_125);
    if (var_137) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_138 = triangle_index_0(var_125, var_136);
        var_139 = wp::extract(var_h, var_138);
        var_140 = wp::mul(var_125, var_7);
        var_141 = wp::add(var_140, var_136);
        wp::assign_inplace(var_1, var_141, var_139);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_142 = triangle_index_0(var_125, var_136);
        var_143 = wp::extract(var_h, var_142);
        var_144 = wp::mul(var_136, var_7);
        var_145 = wp::add(var_144, var_125);
        wp::assign_inplace(var_1, var_145, var_143);
    }
    // if j >= i:                                                                             <L 5>
    var_147 = (var_146 >= var_125);
    if (var_147) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_148 = triangle_index_0(var_125, var_146);
        var_149 = wp::extract(var_h, var_148);
        var_150 = wp::mul(var_125, var_7);
        var_151 = wp::add(var_150, var_146);
        wp::assign_inplace(var_1, var_151, var_149);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_152 = triangle_index_0(var_125, var_146);
        var_153 = wp::extract(var_h, var_152);
        var_154 = wp::mul(var_146, var_7);
        var_155 = wp::add(var_154, var_125);
        wp::assign_inplace(var_1, var_155, var_153);
    }
    // if j >= i:                                                                             <L 5>
    var_157 = (var_156 >= var_125);
    if (var_157) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_158 = triangle_index_0(var_125, var_156);
        var_159 = wp::extract(var_h, var_158);
        var_160 = wp::mul(var_125, var_7);
        var_161 = wp::add(var_160, var_156);
        wp::assign_inplace(var_1, var_161, var_159);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_162 = triangle_index_0(var_125, var_156);
        var_163 = wp::extract(var_h, var_162);
        var_164 = wp::mul(var_156, var_7);
        var_165 = wp::add(var_164, var_125);
        wp::assign_inplace(var_1, var_165, var_163);
    }
    // if j >= i:                                                                             <L 5>
    var_167 = (var_166 >= var_125);
    if (var_167) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_168 = triangle_index_0(var_125, var_166);
        var_169 = wp::extract(var_h, var_168);
        var_170 = wp::mul(var_125, var_7);
        var_171 = wp::add(var_170, var_166);
        wp::assign_inplace(var_1, var_171, var_169);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_172 = triangle_index_0(var_125, var_166);
        var_173 = wp::extract(var_h, var_172);
        var_174 = wp::mul(var_166, var_7);
        var_175 = wp::add(var_174, var_125);
        wp::assign_inplace(var_1, var_175, var_173);
    }
    // if j >= i:                                                                             <L 5>
    var_177 = (var_176 >= var_125);
    if (var_177) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_178 = triangle_index_0(var_125, var_176);
        var_179 = wp::extract(var_h, var_178);
        var_180 = wp::mul(var_125, var_7);
        var_181 = wp::add(var_180, var_176);
        wp::assign_inplace(var_1, var_181, var_179);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_182 = triangle_index_0(var_125, var_176);
        var_183 = wp::extract(var_h, var_182);
        var_184 = wp::mul(var_176, var_7);
        var_185 = wp::add(var_184, var_125);
        wp::assign_inplace(var_1, var_185, var_183);
    }
    // for j in range(6):                                                                     <L 4>
    // if j >= i:                                                                             <L 5>
    var_188 = (var_187 >= var_186);
    if (var_188) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_189 = triangle_index_0(var_186, var_187);
        var_190 = wp::extract(var_h, var_189);
        var_191 = wp::mul(var_186, var_7);
        var_192 = wp::add(var_191, var_187);
        wp::assign_inplace(var_1, var_192, var_190);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_193 = triangle_index_0(var_186, var_187);
        var_194 = wp::extract(var_h, var_193);
        var_195 = wp::mul(var_187, var_7);
        var_196 = wp::add(var_195, var_186);
        wp::assign_inplace(var_1, var_196, var_194);
    }
    // if j >= i:                                                                             <L 5>
    var_198 = (var_197 >= var_186);
    if (var_198) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_199 = triangle_index_0(var_186, var_197);
        var_200 = wp::extract(var_h, var_199);
        var_201 = wp::mul(var_186, var_7);
        var_202 = wp::add(var_201, var_197);
        wp::assign_inplace(var_1, var_202, var_200);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_203 = triangle_index_0(var_186, var_197);
        var_204 = wp::extract(var_h, var_203);
        var_205 = wp::mul(var_197, var_7);
        var_206 = wp::add(var_205, var_186);
        wp::assign_inplace(var_1, var_206, var_204);
    }
    // if j >= i:                                                                             <L 5>
    var_208 = (var_207 >= var_186);
    if (var_208) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_209 = triangle_index_0(var_186, var_207);
        var_210 = wp::extract(var_h, var_209);
        var_211 = wp::mul(var_186, var_7);
        var_212 = wp::add(var_211, var_207);
        wp::assign_inplace(var_1, var_212, var_210);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_213 = triangle_index_0(var_186, var_207);
        var_214 = wp::extract(var_h, var_213);
        var_215 = wp::mul(var_207, var_7);
        var_216 = wp::add(var_215, var_186);
        wp::assign_inplace(var_1, var_216, var_214);
    }
    // if j >= i:                                                                             <L 5>
    var_218 = (var_217 >= var_186);
    if (var_218) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_219 = triangle_index_0(var_186, var_217);
        var_220 = wp::extract(var_h, var_219);
        var_221 = wp::mul(var_186, var_7);
        var_222 = wp::add(var_221, var_217);
        wp::assign_inplace(var_1, var_222, var_220);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_223 = triangle_index_0(var_186, var_217);
        var_224 = wp::extract(var_h, var_223);
        var_225 = wp::mul(var_217, var_7);
        var_226 = wp::add(var_225, var_186);
        wp::assign_inplace(var_1, var_226, var_224);
    }
    // if j >= i:                                                                             <L 5>
    var_228 = (var_227 >= var_186);
    if (var_228) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_229 = triangle_index_0(var_186, var_227);
        var_230 = wp::extract(var_h, var_229);
        var_231 = wp::mul(var_186, var_7);
        var_232 = wp::add(var_231, var_227);
        wp::assign_inplace(var_1, var_232, var_230);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_233 = triangle_index_0(var_186, var_227);
        var_234 = wp::extract(var_h, var_233);
        var_235 = wp::mul(var_227, var_7);
        var_236 = wp::add(var_235, var_186);
        wp::assign_inplace(var_1, var_236, var_234);
    }
    // if j >= i:                                                                             <L 5>
    var_238 = (var_237 >= var_186);
    if (var_238) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_239 = triangle_index_0(var_186, var_237);
        var_240 = wp::extract(var_h, var_239);
        var_241 = wp::mul(var_186, var_7);
        var_242 = wp::add(var_241, var_237);
        wp::assign_inplace(var_1, var_242, var_240);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_243 = triangle_index_0(var_186, var_237);
        var_244 = wp::extract(var_h, var_243);
        var_245 = wp::mul(var_237, var_7);
        var_246 = wp::add(var_245, var_186);
        wp::assign_inplace(var_1, var_246, var_244);
    }
    // for j in range(6):                                                                     <L 4>
    // if j >= i:                                                                             <L 5>
    var_249 = (var_248 >= var_247);
    if (var_249) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_250 = triangle_index_0(var_247, var_248);
        var_251 = wp::extract(var_h, var_250);
        var_252 = wp::mul(var_247, var_7);
        var_253 = wp::add(var_252, var_248);
        wp::assign_inplace(var_1, var_253, var_251);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_254 = triangle_index_0(var_247, var_248);
        var_255 = wp::extract(var_h, var_254);
        var_256 = wp::mul(var_248, var_7);
        var_257 = wp::add(var_256, var_247);
        wp::assign_inplace(var_1, var_257, var_255);
    }
    // if j >= i:                                                                             <L 5>
    var_259 = (var_258 >= var_247);
    if (var_259) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_260 = triangle_index_0(var_247, var_258);
        var_261 = wp::extract(var_h, var_260);
        var_262 = wp::mul(var_247, var_7);
        var_263 = wp::add(var_262, var_258);
        wp::assign_inplace(var_1, var_263, var_261);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_264 = triangle_index_0(var_247, var_258);
        var_265 = wp::extract(var_h, var_264);
        var_266 = wp::mul(var_258, var_7);
        var_267 = wp::add(var_266, var_247);
        wp::assign_inplace(var_1, var_267, var_265);
    }
    // if j >= i:                                                                             <L 5>
    var_269 = (var_268 >= var_247);
    if (var_269) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_270 = triangle_index_0(var_247, var_268);
        var_271 = wp::extract(var_h, var_270);
        var_272 = wp::mul(var_247, var_7);
        var_273 = wp::add(var_272, var_268);
        wp::assign_inplace(var_1, var_273, var_271);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_274 = triangle_index_0(var_247, var_268);
        var_275 = wp::extract(var_h, var_274);
        var_276 = wp::mul(var_268, var_7);
        var_277 = wp::add(var_276, var_247);
        wp::assign_inplace(var_1, var_277, var_275);
    }
    // if j >= i:                                                                             <L 5>
    var_279 = (var_278 >= var_247);
    if (var_279) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_280 = triangle_index_0(var_247, var_278);
        var_281 = wp::extract(var_h, var_280);
        var_282 = wp::mul(var_247, var_7);
        var_283 = wp::add(var_282, var_278);
        wp::assign_inplace(var_1, var_283, var_281);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_284 = triangle_index_0(var_247, var_278);
        var_285 = wp::extract(var_h, var_284);
        var_286 = wp::mul(var_278, var_7);
        var_287 = wp::add(var_286, var_247);
        wp::assign_inplace(var_1, var_287, var_285);
    }
    // if j >= i:                                                                             <L 5>
    var_289 = (var_288 >= var_247);
    if (var_289) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_290 = triangle_index_0(var_247, var_288);
        var_291 = wp::extract(var_h, var_290);
        var_292 = wp::mul(var_247, var_7);
        var_293 = wp::add(var_292, var_288);
        wp::assign_inplace(var_1, var_293, var_291);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_294 = triangle_index_0(var_247, var_288);
        var_295 = wp::extract(var_h, var_294);
        var_296 = wp::mul(var_288, var_7);
        var_297 = wp::add(var_296, var_247);
        wp::assign_inplace(var_1, var_297, var_295);
    }
    // if j >= i:                                                                             <L 5>
    var_299 = (var_298 >= var_247);
    if (var_299) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_300 = triangle_index_0(var_247, var_298);
        var_301 = wp::extract(var_h, var_300);
        var_302 = wp::mul(var_247, var_7);
        var_303 = wp::add(var_302, var_298);
        wp::assign_inplace(var_1, var_303, var_301);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_304 = triangle_index_0(var_247, var_298);
        var_305 = wp::extract(var_h, var_304);
        var_306 = wp::mul(var_298, var_7);
        var_307 = wp::add(var_306, var_247);
        wp::assign_inplace(var_1, var_307, var_305);
    }
    // for j in range(6):                                                                     <L 4>
    // if j >= i:                                                                             <L 5>
    var_310 = (var_309 >= var_308);
    if (var_310) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_311 = triangle_index_0(var_308, var_309);
        var_312 = wp::extract(var_h, var_311);
        var_313 = wp::mul(var_308, var_7);
        var_314 = wp::add(var_313, var_309);
        wp::assign_inplace(var_1, var_314, var_312);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_315 = triangle_index_0(var_308, var_309);
        var_316 = wp::extract(var_h, var_315);
        var_317 = wp::mul(var_309, var_7);
        var_318 = wp::add(var_317, var_308);
        wp::assign_inplace(var_1, var_318, var_316);
    }
    // if j >= i:                                                                             <L 5>
    var_320 = (var_319 >= var_308);
    if (var_320) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_321 = triangle_index_0(var_308, var_319);
        var_322 = wp::extract(var_h, var_321);
        var_323 = wp::mul(var_308, var_7);
        var_324 = wp::add(var_323, var_319);
        wp::assign_inplace(var_1, var_324, var_322);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_325 = triangle_index_0(var_308, var_319);
        var_326 = wp::extract(var_h, var_325);
        var_327 = wp::mul(var_319, var_7);
        var_328 = wp::add(var_327, var_308);
        wp::assign_inplace(var_1, var_328, var_326);
    }
    // if j >= i:                                                                             <L 5>
    var_330 = (var_329 >= var_308);
    if (var_330) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_331 = triangle_index_0(var_308, var_329);
        var_332 = wp::extract(var_h, var_331);
        var_333 = wp::mul(var_308, var_7);
        var_334 = wp::add(var_333, var_329);
        wp::assign_inplace(var_1, var_334, var_332);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_335 = triangle_index_0(var_308, var_329);
        var_336 = wp::extract(var_h, var_335);
        var_337 = wp::mul(var_329, var_7);
        var_338 = wp::add(var_337, var_308);
        wp::assign_inplace(var_1, var_338, var_336);
    }
    // if j >= i:                                                                             <L 5>
    var_340 = (var_339 >= var_308);
    if (var_340) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_341 = triangle_index_0(var_308, var_339);
        var_342 = wp::extract(var_h, var_341);
        var_343 = wp::mul(var_308, var_7);
        var_344 = wp::add(var_343, var_339);
        wp::assign_inplace(var_1, var_344, var_342);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_345 = triangle_index_0(var_308, var_339);
        var_346 = wp::extract(var_h, var_345);
        var_347 = wp::mul(var_339, var_7);
        var_348 = wp::add(var_347, var_308);
        wp::assign_inplace(var_1, var_348, var_346);
    }
    // if j >= i:                                                                             <L 5>
    var_350 = (var_349 >= var_308);
    if (var_350) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_351 = triangle_index_0(var_308, var_349);
        var_352 = wp::extract(var_h, var_351);
        var_353 = wp::mul(var_308, var_7);
        var_354 = wp::add(var_353, var_349);
        wp::assign_inplace(var_1, var_354, var_352);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_355 = triangle_index_0(var_308, var_349);
        var_356 = wp::extract(var_h, var_355);
        var_357 = wp::mul(var_349, var_7);
        var_358 = wp::add(var_357, var_308);
        wp::assign_inplace(var_1, var_358, var_356);
    }
    // if j >= i:                                                                             <L 5>
    var_360 = (var_359 >= var_308);
    if (var_360) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_361 = triangle_index_0(var_308, var_359);
        var_362 = wp::extract(var_h, var_361);
        var_363 = wp::mul(var_308, var_7);
        var_364 = wp::add(var_363, var_359);
        wp::assign_inplace(var_1, var_364, var_362);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_365 = triangle_index_0(var_308, var_359);
        var_366 = wp::extract(var_h, var_365);
        var_367 = wp::mul(var_359, var_7);
        var_368 = wp::add(var_367, var_308);
        wp::assign_inplace(var_1, var_368, var_366);
    }
    // return a                                                                               <L 8>
    return var_1;
}


// <pointloom.kernels.algebra.rigid_solve.factor_system>:1
static CUDA_CALLABLE wp::vec_t<36, wp::float64> factor_system_0(
    wp::vec_t<21, wp::float64> var_h)
{
    //---------
    // primal vars
    wp::vec_t<36, wp::float64> var_0;
    wp::float64 var_1;
    const wp::int32 var_2 = 0;
    const wp::int32 var_3 = 6;
    wp::int32 var_4;
    wp::int32 var_5;
    wp::float64 var_6;
    wp::float64 var_7;
    wp::float64 var_8;
    const wp::int32 var_9 = 1;
    wp::int32 var_10;
    wp::int32 var_11;
    wp::float64 var_12;
    wp::float64 var_13;
    wp::float64 var_14;
    const wp::int32 var_15 = 2;
    wp::int32 var_16;
    wp::int32 var_17;
    wp::float64 var_18;
    wp::float64 var_19;
    wp::float64 var_20;
    const wp::int32 var_21 = 3;
    wp::int32 var_22;
    wp::int32 var_23;
    wp::float64 var_24;
    wp::float64 var_25;
    wp::float64 var_26;
    const wp::int32 var_27 = 4;
    wp::int32 var_28;
    wp::int32 var_29;
    wp::float64 var_30;
    wp::float64 var_31;
    wp::float64 var_32;
    const wp::int32 var_33 = 5;
    wp::int32 var_34;
    wp::int32 var_35;
    wp::float64 var_36;
    wp::float64 var_37;
    wp::float64 var_38;
    const wp::int32 var_39 = 0;
    wp::int32 var_40;
    wp::int32 var_41;
    wp::float64 var_42;
    wp::float64 var_43;
    wp::float64 var_44;
    wp::float64 var_45;
    bool var_46;
    wp::float64 var_47;
    wp::float64 var_48;
    wp::float64 var_49;
    wp::float64 var_50;
    bool var_51;
    wp::float64 var_52;
    wp::float64 var_53;
    wp::float64 var_54;
    wp::float64 var_55;
    wp::float64 var_56;
    wp::float64 var_57;
    wp::int32 var_58;
    wp::int32 var_59;
    const wp::int32 var_60 = 0;
    bool var_61;
    wp::int32 var_62;
    wp::int32 var_63;
    wp::float64 var_64;
    wp::float64 var_65;
    wp::int32 var_66;
    wp::int32 var_67;
    const wp::int32 var_68 = 1;
    bool var_69;
    wp::int32 var_70;
    wp::int32 var_71;
    wp::float64 var_72;
    wp::float64 var_73;
    wp::int32 var_74;
    wp::int32 var_75;
    wp::float64 var_76;
    const wp::int32 var_77 = 2;
    bool var_78;
    wp::int32 var_79;
    wp::int32 var_80;
    wp::float64 var_81;
    wp::float64 var_82;
    wp::int32 var_83;
    wp::int32 var_84;
    wp::float64 var_85;
    const wp::int32 var_86 = 3;
    bool var_87;
    wp::int32 var_88;
    wp::int32 var_89;
    wp::float64 var_90;
    wp::float64 var_91;
    wp::int32 var_92;
    wp::int32 var_93;
    wp::float64 var_94;
    const wp::int32 var_95 = 4;
    bool var_96;
    wp::int32 var_97;
    wp::int32 var_98;
    wp::float64 var_99;
    wp::float64 var_100;
    wp::int32 var_101;
    wp::int32 var_102;
    wp::float64 var_103;
    const wp::int32 var_104 = 5;
    bool var_105;
    wp::int32 var_106;
    wp::int32 var_107;
    wp::float64 var_108;
    wp::float64 var_109;
    wp::int32 var_110;
    wp::int32 var_111;
    wp::float64 var_112;
    const wp::int32 var_113 = 1;
    wp::int32 var_114;
    wp::int32 var_115;
    wp::float64 var_116;
    const wp::int32 var_117 = 0;
    wp::int32 var_118;
    wp::int32 var_119;
    wp::float64 var_120;
    wp::int32 var_121;
    wp::int32 var_122;
    wp::float64 var_123;
    wp::float64 var_124;
    wp::int32 var_125;
    wp::int32 var_126;
    wp::float64 var_127;
    wp::float64 var_128;
    wp::float64 var_129;
    wp::float64 var_130;
    wp::float64 var_131;
    wp::float64 var_132;
    bool var_133;
    wp::float64 var_134;
    wp::float64 var_135;
    wp::float64 var_136;
    wp::float64 var_137;
    bool var_138;
    wp::float64 var_139;
    wp::float64 var_140;
    wp::float64 var_141;
    wp::float64 var_142;
    wp::float64 var_143;
    wp::float64 var_144;
    wp::int32 var_145;
    wp::int32 var_146;
    const wp::int32 var_147 = 0;
    bool var_148;
    wp::int32 var_149;
    wp::int32 var_150;
    wp::float64 var_151;
    const wp::int32 var_152 = 0;
    wp::int32 var_153;
    wp::int32 var_154;
    wp::float64 var_155;
    wp::int32 var_156;
    wp::int32 var_157;
    wp::float64 var_158;
    wp::float64 var_159;
    wp::int32 var_160;
    wp::int32 var_161;
    wp::float64 var_162;
    wp::float64 var_163;
    wp::float64 var_164;
    wp::float64 var_165;
    wp::int32 var_166;
    wp::int32 var_167;
    wp::float64 var_168;
    wp::int32 var_169;
    const wp::int32 var_170 = 1;
    bool var_171;
    wp::int32 var_172;
    wp::int32 var_173;
    wp::float64 var_174;
    const wp::int32 var_175 = 0;
    wp::int32 var_176;
    wp::int32 var_177;
    wp::float64 var_178;
    wp::int32 var_179;
    wp::int32 var_180;
    wp::float64 var_181;
    wp::float64 var_182;
    wp::int32 var_183;
    wp::int32 var_184;
    wp::float64 var_185;
    wp::float64 var_186;
    wp::float64 var_187;
    wp::float64 var_188;
    wp::int32 var_189;
    wp::int32 var_190;
    wp::float64 var_191;
    wp::int32 var_192;
    const wp::int32 var_193 = 2;
    bool var_194;
    wp::int32 var_195;
    wp::int32 var_196;
    wp::float64 var_197;
    const wp::int32 var_198 = 0;
    wp::int32 var_199;
    wp::int32 var_200;
    wp::float64 var_201;
    wp::int32 var_202;
    wp::int32 var_203;
    wp::float64 var_204;
    wp::float64 var_205;
    wp::int32 var_206;
    wp::int32 var_207;
    wp::float64 var_208;
    wp::float64 var_209;
    wp::float64 var_210;
    wp::float64 var_211;
    wp::int32 var_212;
    wp::int32 var_213;
    wp::float64 var_214;
    wp::int32 var_215;
    const wp::int32 var_216 = 3;
    bool var_217;
    wp::int32 var_218;
    wp::int32 var_219;
    wp::float64 var_220;
    const wp::int32 var_221 = 0;
    wp::int32 var_222;
    wp::int32 var_223;
    wp::float64 var_224;
    wp::int32 var_225;
    wp::int32 var_226;
    wp::float64 var_227;
    wp::float64 var_228;
    wp::int32 var_229;
    wp::int32 var_230;
    wp::float64 var_231;
    wp::float64 var_232;
    wp::float64 var_233;
    wp::float64 var_234;
    wp::int32 var_235;
    wp::int32 var_236;
    wp::float64 var_237;
    wp::int32 var_238;
    const wp::int32 var_239 = 4;
    bool var_240;
    wp::int32 var_241;
    wp::int32 var_242;
    wp::float64 var_243;
    const wp::int32 var_244 = 0;
    wp::int32 var_245;
    wp::int32 var_246;
    wp::float64 var_247;
    wp::int32 var_248;
    wp::int32 var_249;
    wp::float64 var_250;
    wp::float64 var_251;
    wp::int32 var_252;
    wp::int32 var_253;
    wp::float64 var_254;
    wp::float64 var_255;
    wp::float64 var_256;
    wp::float64 var_257;
    wp::int32 var_258;
    wp::int32 var_259;
    wp::float64 var_260;
    wp::int32 var_261;
    const wp::int32 var_262 = 5;
    bool var_263;
    wp::int32 var_264;
    wp::int32 var_265;
    wp::float64 var_266;
    const wp::int32 var_267 = 0;
    wp::int32 var_268;
    wp::int32 var_269;
    wp::float64 var_270;
    wp::int32 var_271;
    wp::int32 var_272;
    wp::float64 var_273;
    wp::float64 var_274;
    wp::int32 var_275;
    wp::int32 var_276;
    wp::float64 var_277;
    wp::float64 var_278;
    wp::float64 var_279;
    wp::float64 var_280;
    wp::int32 var_281;
    wp::int32 var_282;
    wp::float64 var_283;
    wp::int32 var_284;
    const wp::int32 var_285 = 2;
    wp::int32 var_286;
    wp::int32 var_287;
    wp::float64 var_288;
    const wp::int32 var_289 = 0;
    wp::int32 var_290;
    wp::int32 var_291;
    wp::float64 var_292;
    wp::int32 var_293;
    wp::int32 var_294;
    wp::float64 var_295;
    wp::float64 var_296;
    wp::int32 var_297;
    wp::int32 var_298;
    wp::float64 var_299;
    wp::float64 var_300;
    wp::float64 var_301;
    const wp::int32 var_302 = 1;
    wp::int32 var_303;
    wp::int32 var_304;
    wp::float64 var_305;
    wp::int32 var_306;
    wp::int32 var_307;
    wp::float64 var_308;
    wp::float64 var_309;
    wp::int32 var_310;
    wp::int32 var_311;
    wp::float64 var_312;
    wp::float64 var_313;
    wp::float64 var_314;
    wp::float64 var_315;
    wp::float64 var_316;
    wp::float64 var_317;
    bool var_318;
    wp::float64 var_319;
    wp::float64 var_320;
    wp::float64 var_321;
    wp::float64 var_322;
    bool var_323;
    wp::float64 var_324;
    wp::float64 var_325;
    wp::float64 var_326;
    wp::float64 var_327;
    wp::float64 var_328;
    wp::float64 var_329;
    wp::int32 var_330;
    wp::int32 var_331;
    const wp::int32 var_332 = 0;
    bool var_333;
    wp::int32 var_334;
    wp::int32 var_335;
    wp::float64 var_336;
    const wp::int32 var_337 = 0;
    wp::int32 var_338;
    wp::int32 var_339;
    wp::float64 var_340;
    wp::int32 var_341;
    wp::int32 var_342;
    wp::float64 var_343;
    wp::float64 var_344;
    wp::int32 var_345;
    wp::int32 var_346;
    wp::float64 var_347;
    wp::float64 var_348;
    wp::float64 var_349;
    const wp::int32 var_350 = 1;
    wp::int32 var_351;
    wp::int32 var_352;
    wp::float64 var_353;
    wp::int32 var_354;
    wp::int32 var_355;
    wp::float64 var_356;
    wp::float64 var_357;
    wp::int32 var_358;
    wp::int32 var_359;
    wp::float64 var_360;
    wp::float64 var_361;
    wp::float64 var_362;
    wp::float64 var_363;
    wp::int32 var_364;
    wp::int32 var_365;
    wp::float64 var_366;
    wp::int32 var_367;
    const wp::int32 var_368 = 1;
    bool var_369;
    wp::int32 var_370;
    wp::int32 var_371;
    wp::float64 var_372;
    const wp::int32 var_373 = 0;
    wp::int32 var_374;
    wp::int32 var_375;
    wp::float64 var_376;
    wp::int32 var_377;
    wp::int32 var_378;
    wp::float64 var_379;
    wp::float64 var_380;
    wp::int32 var_381;
    wp::int32 var_382;
    wp::float64 var_383;
    wp::float64 var_384;
    wp::float64 var_385;
    const wp::int32 var_386 = 1;
    wp::int32 var_387;
    wp::int32 var_388;
    wp::float64 var_389;
    wp::int32 var_390;
    wp::int32 var_391;
    wp::float64 var_392;
    wp::float64 var_393;
    wp::int32 var_394;
    wp::int32 var_395;
    wp::float64 var_396;
    wp::float64 var_397;
    wp::float64 var_398;
    wp::float64 var_399;
    wp::int32 var_400;
    wp::int32 var_401;
    wp::float64 var_402;
    wp::int32 var_403;
    const wp::int32 var_404 = 2;
    bool var_405;
    wp::int32 var_406;
    wp::int32 var_407;
    wp::float64 var_408;
    const wp::int32 var_409 = 0;
    wp::int32 var_410;
    wp::int32 var_411;
    wp::float64 var_412;
    wp::int32 var_413;
    wp::int32 var_414;
    wp::float64 var_415;
    wp::float64 var_416;
    wp::int32 var_417;
    wp::int32 var_418;
    wp::float64 var_419;
    wp::float64 var_420;
    wp::float64 var_421;
    const wp::int32 var_422 = 1;
    wp::int32 var_423;
    wp::int32 var_424;
    wp::float64 var_425;
    wp::int32 var_426;
    wp::int32 var_427;
    wp::float64 var_428;
    wp::float64 var_429;
    wp::int32 var_430;
    wp::int32 var_431;
    wp::float64 var_432;
    wp::float64 var_433;
    wp::float64 var_434;
    wp::float64 var_435;
    wp::int32 var_436;
    wp::int32 var_437;
    wp::float64 var_438;
    wp::int32 var_439;
    const wp::int32 var_440 = 3;
    bool var_441;
    wp::int32 var_442;
    wp::int32 var_443;
    wp::float64 var_444;
    const wp::int32 var_445 = 0;
    wp::int32 var_446;
    wp::int32 var_447;
    wp::float64 var_448;
    wp::int32 var_449;
    wp::int32 var_450;
    wp::float64 var_451;
    wp::float64 var_452;
    wp::int32 var_453;
    wp::int32 var_454;
    wp::float64 var_455;
    wp::float64 var_456;
    wp::float64 var_457;
    const wp::int32 var_458 = 1;
    wp::int32 var_459;
    wp::int32 var_460;
    wp::float64 var_461;
    wp::int32 var_462;
    wp::int32 var_463;
    wp::float64 var_464;
    wp::float64 var_465;
    wp::int32 var_466;
    wp::int32 var_467;
    wp::float64 var_468;
    wp::float64 var_469;
    wp::float64 var_470;
    wp::float64 var_471;
    wp::int32 var_472;
    wp::int32 var_473;
    wp::float64 var_474;
    wp::int32 var_475;
    const wp::int32 var_476 = 4;
    bool var_477;
    wp::int32 var_478;
    wp::int32 var_479;
    wp::float64 var_480;
    const wp::int32 var_481 = 0;
    wp::int32 var_482;
    wp::int32 var_483;
    wp::float64 var_484;
    wp::int32 var_485;
    wp::int32 var_486;
    wp::float64 var_487;
    wp::float64 var_488;
    wp::int32 var_489;
    wp::int32 var_490;
    wp::float64 var_491;
    wp::float64 var_492;
    wp::float64 var_493;
    const wp::int32 var_494 = 1;
    wp::int32 var_495;
    wp::int32 var_496;
    wp::float64 var_497;
    wp::int32 var_498;
    wp::int32 var_499;
    wp::float64 var_500;
    wp::float64 var_501;
    wp::int32 var_502;
    wp::int32 var_503;
    wp::float64 var_504;
    wp::float64 var_505;
    wp::float64 var_506;
    wp::float64 var_507;
    wp::int32 var_508;
    wp::int32 var_509;
    wp::float64 var_510;
    wp::int32 var_511;
    const wp::int32 var_512 = 5;
    bool var_513;
    wp::int32 var_514;
    wp::int32 var_515;
    wp::float64 var_516;
    const wp::int32 var_517 = 0;
    wp::int32 var_518;
    wp::int32 var_519;
    wp::float64 var_520;
    wp::int32 var_521;
    wp::int32 var_522;
    wp::float64 var_523;
    wp::float64 var_524;
    wp::int32 var_525;
    wp::int32 var_526;
    wp::float64 var_527;
    wp::float64 var_528;
    wp::float64 var_529;
    const wp::int32 var_530 = 1;
    wp::int32 var_531;
    wp::int32 var_532;
    wp::float64 var_533;
    wp::int32 var_534;
    wp::int32 var_535;
    wp::float64 var_536;
    wp::float64 var_537;
    wp::int32 var_538;
    wp::int32 var_539;
    wp::float64 var_540;
    wp::float64 var_541;
    wp::float64 var_542;
    wp::float64 var_543;
    wp::int32 var_544;
    wp::int32 var_545;
    wp::float64 var_546;
    wp::int32 var_547;
    const wp::int32 var_548 = 3;
    wp::int32 var_549;
    wp::int32 var_550;
    wp::float64 var_551;
    const wp::int32 var_552 = 0;
    wp::int32 var_553;
    wp::int32 var_554;
    wp::float64 var_555;
    wp::int32 var_556;
    wp::int32 var_557;
    wp::float64 var_558;
    wp::float64 var_559;
    wp::int32 var_560;
    wp::int32 var_561;
    wp::float64 var_562;
    wp::float64 var_563;
    wp::float64 var_564;
    const wp::int32 var_565 = 1;
    wp::int32 var_566;
    wp::int32 var_567;
    wp::float64 var_568;
    wp::int32 var_569;
    wp::int32 var_570;
    wp::float64 var_571;
    wp::float64 var_572;
    wp::int32 var_573;
    wp::int32 var_574;
    wp::float64 var_575;
    wp::float64 var_576;
    wp::float64 var_577;
    const wp::int32 var_578 = 2;
    wp::int32 var_579;
    wp::int32 var_580;
    wp::float64 var_581;
    wp::int32 var_582;
    wp::int32 var_583;
    wp::float64 var_584;
    wp::float64 var_585;
    wp::int32 var_586;
    wp::int32 var_587;
    wp::float64 var_588;
    wp::float64 var_589;
    wp::float64 var_590;
    wp::float64 var_591;
    wp::float64 var_592;
    wp::float64 var_593;
    bool var_594;
    wp::float64 var_595;
    wp::float64 var_596;
    wp::float64 var_597;
    wp::float64 var_598;
    bool var_599;
    wp::float64 var_600;
    wp::float64 var_601;
    wp::float64 var_602;
    wp::float64 var_603;
    wp::float64 var_604;
    wp::float64 var_605;
    wp::int32 var_606;
    wp::int32 var_607;
    const wp::int32 var_608 = 0;
    bool var_609;
    wp::int32 var_610;
    wp::int32 var_611;
    wp::float64 var_612;
    const wp::int32 var_613 = 0;
    wp::int32 var_614;
    wp::int32 var_615;
    wp::float64 var_616;
    wp::int32 var_617;
    wp::int32 var_618;
    wp::float64 var_619;
    wp::float64 var_620;
    wp::int32 var_621;
    wp::int32 var_622;
    wp::float64 var_623;
    wp::float64 var_624;
    wp::float64 var_625;
    const wp::int32 var_626 = 1;
    wp::int32 var_627;
    wp::int32 var_628;
    wp::float64 var_629;
    wp::int32 var_630;
    wp::int32 var_631;
    wp::float64 var_632;
    wp::float64 var_633;
    wp::int32 var_634;
    wp::int32 var_635;
    wp::float64 var_636;
    wp::float64 var_637;
    wp::float64 var_638;
    const wp::int32 var_639 = 2;
    wp::int32 var_640;
    wp::int32 var_641;
    wp::float64 var_642;
    wp::int32 var_643;
    wp::int32 var_644;
    wp::float64 var_645;
    wp::float64 var_646;
    wp::int32 var_647;
    wp::int32 var_648;
    wp::float64 var_649;
    wp::float64 var_650;
    wp::float64 var_651;
    wp::float64 var_652;
    wp::int32 var_653;
    wp::int32 var_654;
    wp::float64 var_655;
    wp::int32 var_656;
    const wp::int32 var_657 = 1;
    bool var_658;
    wp::int32 var_659;
    wp::int32 var_660;
    wp::float64 var_661;
    const wp::int32 var_662 = 0;
    wp::int32 var_663;
    wp::int32 var_664;
    wp::float64 var_665;
    wp::int32 var_666;
    wp::int32 var_667;
    wp::float64 var_668;
    wp::float64 var_669;
    wp::int32 var_670;
    wp::int32 var_671;
    wp::float64 var_672;
    wp::float64 var_673;
    wp::float64 var_674;
    const wp::int32 var_675 = 1;
    wp::int32 var_676;
    wp::int32 var_677;
    wp::float64 var_678;
    wp::int32 var_679;
    wp::int32 var_680;
    wp::float64 var_681;
    wp::float64 var_682;
    wp::int32 var_683;
    wp::int32 var_684;
    wp::float64 var_685;
    wp::float64 var_686;
    wp::float64 var_687;
    const wp::int32 var_688 = 2;
    wp::int32 var_689;
    wp::int32 var_690;
    wp::float64 var_691;
    wp::int32 var_692;
    wp::int32 var_693;
    wp::float64 var_694;
    wp::float64 var_695;
    wp::int32 var_696;
    wp::int32 var_697;
    wp::float64 var_698;
    wp::float64 var_699;
    wp::float64 var_700;
    wp::float64 var_701;
    wp::int32 var_702;
    wp::int32 var_703;
    wp::float64 var_704;
    wp::int32 var_705;
    const wp::int32 var_706 = 2;
    bool var_707;
    wp::int32 var_708;
    wp::int32 var_709;
    wp::float64 var_710;
    const wp::int32 var_711 = 0;
    wp::int32 var_712;
    wp::int32 var_713;
    wp::float64 var_714;
    wp::int32 var_715;
    wp::int32 var_716;
    wp::float64 var_717;
    wp::float64 var_718;
    wp::int32 var_719;
    wp::int32 var_720;
    wp::float64 var_721;
    wp::float64 var_722;
    wp::float64 var_723;
    const wp::int32 var_724 = 1;
    wp::int32 var_725;
    wp::int32 var_726;
    wp::float64 var_727;
    wp::int32 var_728;
    wp::int32 var_729;
    wp::float64 var_730;
    wp::float64 var_731;
    wp::int32 var_732;
    wp::int32 var_733;
    wp::float64 var_734;
    wp::float64 var_735;
    wp::float64 var_736;
    const wp::int32 var_737 = 2;
    wp::int32 var_738;
    wp::int32 var_739;
    wp::float64 var_740;
    wp::int32 var_741;
    wp::int32 var_742;
    wp::float64 var_743;
    wp::float64 var_744;
    wp::int32 var_745;
    wp::int32 var_746;
    wp::float64 var_747;
    wp::float64 var_748;
    wp::float64 var_749;
    wp::float64 var_750;
    wp::int32 var_751;
    wp::int32 var_752;
    wp::float64 var_753;
    wp::int32 var_754;
    const wp::int32 var_755 = 3;
    bool var_756;
    wp::int32 var_757;
    wp::int32 var_758;
    wp::float64 var_759;
    const wp::int32 var_760 = 0;
    wp::int32 var_761;
    wp::int32 var_762;
    wp::float64 var_763;
    wp::int32 var_764;
    wp::int32 var_765;
    wp::float64 var_766;
    wp::float64 var_767;
    wp::int32 var_768;
    wp::int32 var_769;
    wp::float64 var_770;
    wp::float64 var_771;
    wp::float64 var_772;
    const wp::int32 var_773 = 1;
    wp::int32 var_774;
    wp::int32 var_775;
    wp::float64 var_776;
    wp::int32 var_777;
    wp::int32 var_778;
    wp::float64 var_779;
    wp::float64 var_780;
    wp::int32 var_781;
    wp::int32 var_782;
    wp::float64 var_783;
    wp::float64 var_784;
    wp::float64 var_785;
    const wp::int32 var_786 = 2;
    wp::int32 var_787;
    wp::int32 var_788;
    wp::float64 var_789;
    wp::int32 var_790;
    wp::int32 var_791;
    wp::float64 var_792;
    wp::float64 var_793;
    wp::int32 var_794;
    wp::int32 var_795;
    wp::float64 var_796;
    wp::float64 var_797;
    wp::float64 var_798;
    wp::float64 var_799;
    wp::int32 var_800;
    wp::int32 var_801;
    wp::float64 var_802;
    wp::int32 var_803;
    const wp::int32 var_804 = 4;
    bool var_805;
    wp::int32 var_806;
    wp::int32 var_807;
    wp::float64 var_808;
    const wp::int32 var_809 = 0;
    wp::int32 var_810;
    wp::int32 var_811;
    wp::float64 var_812;
    wp::int32 var_813;
    wp::int32 var_814;
    wp::float64 var_815;
    wp::float64 var_816;
    wp::int32 var_817;
    wp::int32 var_818;
    wp::float64 var_819;
    wp::float64 var_820;
    wp::float64 var_821;
    const wp::int32 var_822 = 1;
    wp::int32 var_823;
    wp::int32 var_824;
    wp::float64 var_825;
    wp::int32 var_826;
    wp::int32 var_827;
    wp::float64 var_828;
    wp::float64 var_829;
    wp::int32 var_830;
    wp::int32 var_831;
    wp::float64 var_832;
    wp::float64 var_833;
    wp::float64 var_834;
    const wp::int32 var_835 = 2;
    wp::int32 var_836;
    wp::int32 var_837;
    wp::float64 var_838;
    wp::int32 var_839;
    wp::int32 var_840;
    wp::float64 var_841;
    wp::float64 var_842;
    wp::int32 var_843;
    wp::int32 var_844;
    wp::float64 var_845;
    wp::float64 var_846;
    wp::float64 var_847;
    wp::float64 var_848;
    wp::int32 var_849;
    wp::int32 var_850;
    wp::float64 var_851;
    wp::int32 var_852;
    const wp::int32 var_853 = 5;
    bool var_854;
    wp::int32 var_855;
    wp::int32 var_856;
    wp::float64 var_857;
    const wp::int32 var_858 = 0;
    wp::int32 var_859;
    wp::int32 var_860;
    wp::float64 var_861;
    wp::int32 var_862;
    wp::int32 var_863;
    wp::float64 var_864;
    wp::float64 var_865;
    wp::int32 var_866;
    wp::int32 var_867;
    wp::float64 var_868;
    wp::float64 var_869;
    wp::float64 var_870;
    const wp::int32 var_871 = 1;
    wp::int32 var_872;
    wp::int32 var_873;
    wp::float64 var_874;
    wp::int32 var_875;
    wp::int32 var_876;
    wp::float64 var_877;
    wp::float64 var_878;
    wp::int32 var_879;
    wp::int32 var_880;
    wp::float64 var_881;
    wp::float64 var_882;
    wp::float64 var_883;
    const wp::int32 var_884 = 2;
    wp::int32 var_885;
    wp::int32 var_886;
    wp::float64 var_887;
    wp::int32 var_888;
    wp::int32 var_889;
    wp::float64 var_890;
    wp::float64 var_891;
    wp::int32 var_892;
    wp::int32 var_893;
    wp::float64 var_894;
    wp::float64 var_895;
    wp::float64 var_896;
    wp::float64 var_897;
    wp::int32 var_898;
    wp::int32 var_899;
    wp::float64 var_900;
    wp::int32 var_901;
    const wp::int32 var_902 = 4;
    wp::int32 var_903;
    wp::int32 var_904;
    wp::float64 var_905;
    const wp::int32 var_906 = 0;
    wp::int32 var_907;
    wp::int32 var_908;
    wp::float64 var_909;
    wp::int32 var_910;
    wp::int32 var_911;
    wp::float64 var_912;
    wp::float64 var_913;
    wp::int32 var_914;
    wp::int32 var_915;
    wp::float64 var_916;
    wp::float64 var_917;
    wp::float64 var_918;
    const wp::int32 var_919 = 1;
    wp::int32 var_920;
    wp::int32 var_921;
    wp::float64 var_922;
    wp::int32 var_923;
    wp::int32 var_924;
    wp::float64 var_925;
    wp::float64 var_926;
    wp::int32 var_927;
    wp::int32 var_928;
    wp::float64 var_929;
    wp::float64 var_930;
    wp::float64 var_931;
    const wp::int32 var_932 = 2;
    wp::int32 var_933;
    wp::int32 var_934;
    wp::float64 var_935;
    wp::int32 var_936;
    wp::int32 var_937;
    wp::float64 var_938;
    wp::float64 var_939;
    wp::int32 var_940;
    wp::int32 var_941;
    wp::float64 var_942;
    wp::float64 var_943;
    wp::float64 var_944;
    const wp::int32 var_945 = 3;
    wp::int32 var_946;
    wp::int32 var_947;
    wp::float64 var_948;
    wp::int32 var_949;
    wp::int32 var_950;
    wp::float64 var_951;
    wp::float64 var_952;
    wp::int32 var_953;
    wp::int32 var_954;
    wp::float64 var_955;
    wp::float64 var_956;
    wp::float64 var_957;
    wp::float64 var_958;
    wp::float64 var_959;
    wp::float64 var_960;
    bool var_961;
    wp::float64 var_962;
    wp::float64 var_963;
    wp::float64 var_964;
    wp::float64 var_965;
    bool var_966;
    wp::float64 var_967;
    wp::float64 var_968;
    wp::float64 var_969;
    wp::float64 var_970;
    wp::float64 var_971;
    wp::float64 var_972;
    wp::int32 var_973;
    wp::int32 var_974;
    const wp::int32 var_975 = 0;
    bool var_976;
    wp::int32 var_977;
    wp::int32 var_978;
    wp::float64 var_979;
    const wp::int32 var_980 = 0;
    wp::int32 var_981;
    wp::int32 var_982;
    wp::float64 var_983;
    wp::int32 var_984;
    wp::int32 var_985;
    wp::float64 var_986;
    wp::float64 var_987;
    wp::int32 var_988;
    wp::int32 var_989;
    wp::float64 var_990;
    wp::float64 var_991;
    wp::float64 var_992;
    const wp::int32 var_993 = 1;
    wp::int32 var_994;
    wp::int32 var_995;
    wp::float64 var_996;
    wp::int32 var_997;
    wp::int32 var_998;
    wp::float64 var_999;
    wp::float64 var_1000;
    wp::int32 var_1001;
    wp::int32 var_1002;
    wp::float64 var_1003;
    wp::float64 var_1004;
    wp::float64 var_1005;
    const wp::int32 var_1006 = 2;
    wp::int32 var_1007;
    wp::int32 var_1008;
    wp::float64 var_1009;
    wp::int32 var_1010;
    wp::int32 var_1011;
    wp::float64 var_1012;
    wp::float64 var_1013;
    wp::int32 var_1014;
    wp::int32 var_1015;
    wp::float64 var_1016;
    wp::float64 var_1017;
    wp::float64 var_1018;
    const wp::int32 var_1019 = 3;
    wp::int32 var_1020;
    wp::int32 var_1021;
    wp::float64 var_1022;
    wp::int32 var_1023;
    wp::int32 var_1024;
    wp::float64 var_1025;
    wp::float64 var_1026;
    wp::int32 var_1027;
    wp::int32 var_1028;
    wp::float64 var_1029;
    wp::float64 var_1030;
    wp::float64 var_1031;
    wp::float64 var_1032;
    wp::int32 var_1033;
    wp::int32 var_1034;
    wp::float64 var_1035;
    wp::int32 var_1036;
    const wp::int32 var_1037 = 1;
    bool var_1038;
    wp::int32 var_1039;
    wp::int32 var_1040;
    wp::float64 var_1041;
    const wp::int32 var_1042 = 0;
    wp::int32 var_1043;
    wp::int32 var_1044;
    wp::float64 var_1045;
    wp::int32 var_1046;
    wp::int32 var_1047;
    wp::float64 var_1048;
    wp::float64 var_1049;
    wp::int32 var_1050;
    wp::int32 var_1051;
    wp::float64 var_1052;
    wp::float64 var_1053;
    wp::float64 var_1054;
    const wp::int32 var_1055 = 1;
    wp::int32 var_1056;
    wp::int32 var_1057;
    wp::float64 var_1058;
    wp::int32 var_1059;
    wp::int32 var_1060;
    wp::float64 var_1061;
    wp::float64 var_1062;
    wp::int32 var_1063;
    wp::int32 var_1064;
    wp::float64 var_1065;
    wp::float64 var_1066;
    wp::float64 var_1067;
    const wp::int32 var_1068 = 2;
    wp::int32 var_1069;
    wp::int32 var_1070;
    wp::float64 var_1071;
    wp::int32 var_1072;
    wp::int32 var_1073;
    wp::float64 var_1074;
    wp::float64 var_1075;
    wp::int32 var_1076;
    wp::int32 var_1077;
    wp::float64 var_1078;
    wp::float64 var_1079;
    wp::float64 var_1080;
    const wp::int32 var_1081 = 3;
    wp::int32 var_1082;
    wp::int32 var_1083;
    wp::float64 var_1084;
    wp::int32 var_1085;
    wp::int32 var_1086;
    wp::float64 var_1087;
    wp::float64 var_1088;
    wp::int32 var_1089;
    wp::int32 var_1090;
    wp::float64 var_1091;
    wp::float64 var_1092;
    wp::float64 var_1093;
    wp::float64 var_1094;
    wp::int32 var_1095;
    wp::int32 var_1096;
    wp::float64 var_1097;
    wp::int32 var_1098;
    const wp::int32 var_1099 = 2;
    bool var_1100;
    wp::int32 var_1101;
    wp::int32 var_1102;
    wp::float64 var_1103;
    const wp::int32 var_1104 = 0;
    wp::int32 var_1105;
    wp::int32 var_1106;
    wp::float64 var_1107;
    wp::int32 var_1108;
    wp::int32 var_1109;
    wp::float64 var_1110;
    wp::float64 var_1111;
    wp::int32 var_1112;
    wp::int32 var_1113;
    wp::float64 var_1114;
    wp::float64 var_1115;
    wp::float64 var_1116;
    const wp::int32 var_1117 = 1;
    wp::int32 var_1118;
    wp::int32 var_1119;
    wp::float64 var_1120;
    wp::int32 var_1121;
    wp::int32 var_1122;
    wp::float64 var_1123;
    wp::float64 var_1124;
    wp::int32 var_1125;
    wp::int32 var_1126;
    wp::float64 var_1127;
    wp::float64 var_1128;
    wp::float64 var_1129;
    const wp::int32 var_1130 = 2;
    wp::int32 var_1131;
    wp::int32 var_1132;
    wp::float64 var_1133;
    wp::int32 var_1134;
    wp::int32 var_1135;
    wp::float64 var_1136;
    wp::float64 var_1137;
    wp::int32 var_1138;
    wp::int32 var_1139;
    wp::float64 var_1140;
    wp::float64 var_1141;
    wp::float64 var_1142;
    const wp::int32 var_1143 = 3;
    wp::int32 var_1144;
    wp::int32 var_1145;
    wp::float64 var_1146;
    wp::int32 var_1147;
    wp::int32 var_1148;
    wp::float64 var_1149;
    wp::float64 var_1150;
    wp::int32 var_1151;
    wp::int32 var_1152;
    wp::float64 var_1153;
    wp::float64 var_1154;
    wp::float64 var_1155;
    wp::float64 var_1156;
    wp::int32 var_1157;
    wp::int32 var_1158;
    wp::float64 var_1159;
    wp::int32 var_1160;
    const wp::int32 var_1161 = 3;
    bool var_1162;
    wp::int32 var_1163;
    wp::int32 var_1164;
    wp::float64 var_1165;
    const wp::int32 var_1166 = 0;
    wp::int32 var_1167;
    wp::int32 var_1168;
    wp::float64 var_1169;
    wp::int32 var_1170;
    wp::int32 var_1171;
    wp::float64 var_1172;
    wp::float64 var_1173;
    wp::int32 var_1174;
    wp::int32 var_1175;
    wp::float64 var_1176;
    wp::float64 var_1177;
    wp::float64 var_1178;
    const wp::int32 var_1179 = 1;
    wp::int32 var_1180;
    wp::int32 var_1181;
    wp::float64 var_1182;
    wp::int32 var_1183;
    wp::int32 var_1184;
    wp::float64 var_1185;
    wp::float64 var_1186;
    wp::int32 var_1187;
    wp::int32 var_1188;
    wp::float64 var_1189;
    wp::float64 var_1190;
    wp::float64 var_1191;
    const wp::int32 var_1192 = 2;
    wp::int32 var_1193;
    wp::int32 var_1194;
    wp::float64 var_1195;
    wp::int32 var_1196;
    wp::int32 var_1197;
    wp::float64 var_1198;
    wp::float64 var_1199;
    wp::int32 var_1200;
    wp::int32 var_1201;
    wp::float64 var_1202;
    wp::float64 var_1203;
    wp::float64 var_1204;
    const wp::int32 var_1205 = 3;
    wp::int32 var_1206;
    wp::int32 var_1207;
    wp::float64 var_1208;
    wp::int32 var_1209;
    wp::int32 var_1210;
    wp::float64 var_1211;
    wp::float64 var_1212;
    wp::int32 var_1213;
    wp::int32 var_1214;
    wp::float64 var_1215;
    wp::float64 var_1216;
    wp::float64 var_1217;
    wp::float64 var_1218;
    wp::int32 var_1219;
    wp::int32 var_1220;
    wp::float64 var_1221;
    wp::int32 var_1222;
    const wp::int32 var_1223 = 4;
    bool var_1224;
    wp::int32 var_1225;
    wp::int32 var_1226;
    wp::float64 var_1227;
    const wp::int32 var_1228 = 0;
    wp::int32 var_1229;
    wp::int32 var_1230;
    wp::float64 var_1231;
    wp::int32 var_1232;
    wp::int32 var_1233;
    wp::float64 var_1234;
    wp::float64 var_1235;
    wp::int32 var_1236;
    wp::int32 var_1237;
    wp::float64 var_1238;
    wp::float64 var_1239;
    wp::float64 var_1240;
    const wp::int32 var_1241 = 1;
    wp::int32 var_1242;
    wp::int32 var_1243;
    wp::float64 var_1244;
    wp::int32 var_1245;
    wp::int32 var_1246;
    wp::float64 var_1247;
    wp::float64 var_1248;
    wp::int32 var_1249;
    wp::int32 var_1250;
    wp::float64 var_1251;
    wp::float64 var_1252;
    wp::float64 var_1253;
    const wp::int32 var_1254 = 2;
    wp::int32 var_1255;
    wp::int32 var_1256;
    wp::float64 var_1257;
    wp::int32 var_1258;
    wp::int32 var_1259;
    wp::float64 var_1260;
    wp::float64 var_1261;
    wp::int32 var_1262;
    wp::int32 var_1263;
    wp::float64 var_1264;
    wp::float64 var_1265;
    wp::float64 var_1266;
    const wp::int32 var_1267 = 3;
    wp::int32 var_1268;
    wp::int32 var_1269;
    wp::float64 var_1270;
    wp::int32 var_1271;
    wp::int32 var_1272;
    wp::float64 var_1273;
    wp::float64 var_1274;
    wp::int32 var_1275;
    wp::int32 var_1276;
    wp::float64 var_1277;
    wp::float64 var_1278;
    wp::float64 var_1279;
    wp::float64 var_1280;
    wp::int32 var_1281;
    wp::int32 var_1282;
    wp::float64 var_1283;
    wp::int32 var_1284;
    const wp::int32 var_1285 = 5;
    bool var_1286;
    wp::int32 var_1287;
    wp::int32 var_1288;
    wp::float64 var_1289;
    const wp::int32 var_1290 = 0;
    wp::int32 var_1291;
    wp::int32 var_1292;
    wp::float64 var_1293;
    wp::int32 var_1294;
    wp::int32 var_1295;
    wp::float64 var_1296;
    wp::float64 var_1297;
    wp::int32 var_1298;
    wp::int32 var_1299;
    wp::float64 var_1300;
    wp::float64 var_1301;
    wp::float64 var_1302;
    const wp::int32 var_1303 = 1;
    wp::int32 var_1304;
    wp::int32 var_1305;
    wp::float64 var_1306;
    wp::int32 var_1307;
    wp::int32 var_1308;
    wp::float64 var_1309;
    wp::float64 var_1310;
    wp::int32 var_1311;
    wp::int32 var_1312;
    wp::float64 var_1313;
    wp::float64 var_1314;
    wp::float64 var_1315;
    const wp::int32 var_1316 = 2;
    wp::int32 var_1317;
    wp::int32 var_1318;
    wp::float64 var_1319;
    wp::int32 var_1320;
    wp::int32 var_1321;
    wp::float64 var_1322;
    wp::float64 var_1323;
    wp::int32 var_1324;
    wp::int32 var_1325;
    wp::float64 var_1326;
    wp::float64 var_1327;
    wp::float64 var_1328;
    const wp::int32 var_1329 = 3;
    wp::int32 var_1330;
    wp::int32 var_1331;
    wp::float64 var_1332;
    wp::int32 var_1333;
    wp::int32 var_1334;
    wp::float64 var_1335;
    wp::float64 var_1336;
    wp::int32 var_1337;
    wp::int32 var_1338;
    wp::float64 var_1339;
    wp::float64 var_1340;
    wp::float64 var_1341;
    wp::float64 var_1342;
    wp::int32 var_1343;
    wp::int32 var_1344;
    wp::float64 var_1345;
    wp::int32 var_1346;
    const wp::int32 var_1347 = 5;
    wp::int32 var_1348;
    wp::int32 var_1349;
    wp::float64 var_1350;
    const wp::int32 var_1351 = 0;
    wp::int32 var_1352;
    wp::int32 var_1353;
    wp::float64 var_1354;
    wp::int32 var_1355;
    wp::int32 var_1356;
    wp::float64 var_1357;
    wp::float64 var_1358;
    wp::int32 var_1359;
    wp::int32 var_1360;
    wp::float64 var_1361;
    wp::float64 var_1362;
    wp::float64 var_1363;
    const wp::int32 var_1364 = 1;
    wp::int32 var_1365;
    wp::int32 var_1366;
    wp::float64 var_1367;
    wp::int32 var_1368;
    wp::int32 var_1369;
    wp::float64 var_1370;
    wp::float64 var_1371;
    wp::int32 var_1372;
    wp::int32 var_1373;
    wp::float64 var_1374;
    wp::float64 var_1375;
    wp::float64 var_1376;
    const wp::int32 var_1377 = 2;
    wp::int32 var_1378;
    wp::int32 var_1379;
    wp::float64 var_1380;
    wp::int32 var_1381;
    wp::int32 var_1382;
    wp::float64 var_1383;
    wp::float64 var_1384;
    wp::int32 var_1385;
    wp::int32 var_1386;
    wp::float64 var_1387;
    wp::float64 var_1388;
    wp::float64 var_1389;
    const wp::int32 var_1390 = 3;
    wp::int32 var_1391;
    wp::int32 var_1392;
    wp::float64 var_1393;
    wp::int32 var_1394;
    wp::int32 var_1395;
    wp::float64 var_1396;
    wp::float64 var_1397;
    wp::int32 var_1398;
    wp::int32 var_1399;
    wp::float64 var_1400;
    wp::float64 var_1401;
    wp::float64 var_1402;
    const wp::int32 var_1403 = 4;
    wp::int32 var_1404;
    wp::int32 var_1405;
    wp::float64 var_1406;
    wp::int32 var_1407;
    wp::int32 var_1408;
    wp::float64 var_1409;
    wp::float64 var_1410;
    wp::int32 var_1411;
    wp::int32 var_1412;
    wp::float64 var_1413;
    wp::float64 var_1414;
    wp::float64 var_1415;
    wp::float64 var_1416;
    wp::float64 var_1417;
    wp::float64 var_1418;
    bool var_1419;
    wp::float64 var_1420;
    wp::float64 var_1421;
    wp::float64 var_1422;
    wp::float64 var_1423;
    bool var_1424;
    wp::float64 var_1425;
    wp::float64 var_1426;
    wp::float64 var_1427;
    wp::float64 var_1428;
    wp::float64 var_1429;
    wp::float64 var_1430;
    wp::int32 var_1431;
    wp::int32 var_1432;
    const wp::int32 var_1433 = 0;
    bool var_1434;
    wp::int32 var_1435;
    wp::int32 var_1436;
    wp::float64 var_1437;
    const wp::int32 var_1438 = 0;
    wp::int32 var_1439;
    wp::int32 var_1440;
    wp::float64 var_1441;
    wp::int32 var_1442;
    wp::int32 var_1443;
    wp::float64 var_1444;
    wp::float64 var_1445;
    wp::int32 var_1446;
    wp::int32 var_1447;
    wp::float64 var_1448;
    wp::float64 var_1449;
    wp::float64 var_1450;
    const wp::int32 var_1451 = 1;
    wp::int32 var_1452;
    wp::int32 var_1453;
    wp::float64 var_1454;
    wp::int32 var_1455;
    wp::int32 var_1456;
    wp::float64 var_1457;
    wp::float64 var_1458;
    wp::int32 var_1459;
    wp::int32 var_1460;
    wp::float64 var_1461;
    wp::float64 var_1462;
    wp::float64 var_1463;
    const wp::int32 var_1464 = 2;
    wp::int32 var_1465;
    wp::int32 var_1466;
    wp::float64 var_1467;
    wp::int32 var_1468;
    wp::int32 var_1469;
    wp::float64 var_1470;
    wp::float64 var_1471;
    wp::int32 var_1472;
    wp::int32 var_1473;
    wp::float64 var_1474;
    wp::float64 var_1475;
    wp::float64 var_1476;
    const wp::int32 var_1477 = 3;
    wp::int32 var_1478;
    wp::int32 var_1479;
    wp::float64 var_1480;
    wp::int32 var_1481;
    wp::int32 var_1482;
    wp::float64 var_1483;
    wp::float64 var_1484;
    wp::int32 var_1485;
    wp::int32 var_1486;
    wp::float64 var_1487;
    wp::float64 var_1488;
    wp::float64 var_1489;
    const wp::int32 var_1490 = 4;
    wp::int32 var_1491;
    wp::int32 var_1492;
    wp::float64 var_1493;
    wp::int32 var_1494;
    wp::int32 var_1495;
    wp::float64 var_1496;
    wp::float64 var_1497;
    wp::int32 var_1498;
    wp::int32 var_1499;
    wp::float64 var_1500;
    wp::float64 var_1501;
    wp::float64 var_1502;
    wp::float64 var_1503;
    wp::int32 var_1504;
    wp::int32 var_1505;
    wp::float64 var_1506;
    wp::int32 var_1507;
    const wp::int32 var_1508 = 1;
    bool var_1509;
    wp::int32 var_1510;
    wp::int32 var_1511;
    wp::float64 var_1512;
    const wp::int32 var_1513 = 0;
    wp::int32 var_1514;
    wp::int32 var_1515;
    wp::float64 var_1516;
    wp::int32 var_1517;
    wp::int32 var_1518;
    wp::float64 var_1519;
    wp::float64 var_1520;
    wp::int32 var_1521;
    wp::int32 var_1522;
    wp::float64 var_1523;
    wp::float64 var_1524;
    wp::float64 var_1525;
    const wp::int32 var_1526 = 1;
    wp::int32 var_1527;
    wp::int32 var_1528;
    wp::float64 var_1529;
    wp::int32 var_1530;
    wp::int32 var_1531;
    wp::float64 var_1532;
    wp::float64 var_1533;
    wp::int32 var_1534;
    wp::int32 var_1535;
    wp::float64 var_1536;
    wp::float64 var_1537;
    wp::float64 var_1538;
    const wp::int32 var_1539 = 2;
    wp::int32 var_1540;
    wp::int32 var_1541;
    wp::float64 var_1542;
    wp::int32 var_1543;
    wp::int32 var_1544;
    wp::float64 var_1545;
    wp::float64 var_1546;
    wp::int32 var_1547;
    wp::int32 var_1548;
    wp::float64 var_1549;
    wp::float64 var_1550;
    wp::float64 var_1551;
    const wp::int32 var_1552 = 3;
    wp::int32 var_1553;
    wp::int32 var_1554;
    wp::float64 var_1555;
    wp::int32 var_1556;
    wp::int32 var_1557;
    wp::float64 var_1558;
    wp::float64 var_1559;
    wp::int32 var_1560;
    wp::int32 var_1561;
    wp::float64 var_1562;
    wp::float64 var_1563;
    wp::float64 var_1564;
    const wp::int32 var_1565 = 4;
    wp::int32 var_1566;
    wp::int32 var_1567;
    wp::float64 var_1568;
    wp::int32 var_1569;
    wp::int32 var_1570;
    wp::float64 var_1571;
    wp::float64 var_1572;
    wp::int32 var_1573;
    wp::int32 var_1574;
    wp::float64 var_1575;
    wp::float64 var_1576;
    wp::float64 var_1577;
    wp::float64 var_1578;
    wp::int32 var_1579;
    wp::int32 var_1580;
    wp::float64 var_1581;
    wp::int32 var_1582;
    const wp::int32 var_1583 = 2;
    bool var_1584;
    wp::int32 var_1585;
    wp::int32 var_1586;
    wp::float64 var_1587;
    const wp::int32 var_1588 = 0;
    wp::int32 var_1589;
    wp::int32 var_1590;
    wp::float64 var_1591;
    wp::int32 var_1592;
    wp::int32 var_1593;
    wp::float64 var_1594;
    wp::float64 var_1595;
    wp::int32 var_1596;
    wp::int32 var_1597;
    wp::float64 var_1598;
    wp::float64 var_1599;
    wp::float64 var_1600;
    const wp::int32 var_1601 = 1;
    wp::int32 var_1602;
    wp::int32 var_1603;
    wp::float64 var_1604;
    wp::int32 var_1605;
    wp::int32 var_1606;
    wp::float64 var_1607;
    wp::float64 var_1608;
    wp::int32 var_1609;
    wp::int32 var_1610;
    wp::float64 var_1611;
    wp::float64 var_1612;
    wp::float64 var_1613;
    const wp::int32 var_1614 = 2;
    wp::int32 var_1615;
    wp::int32 var_1616;
    wp::float64 var_1617;
    wp::int32 var_1618;
    wp::int32 var_1619;
    wp::float64 var_1620;
    wp::float64 var_1621;
    wp::int32 var_1622;
    wp::int32 var_1623;
    wp::float64 var_1624;
    wp::float64 var_1625;
    wp::float64 var_1626;
    const wp::int32 var_1627 = 3;
    wp::int32 var_1628;
    wp::int32 var_1629;
    wp::float64 var_1630;
    wp::int32 var_1631;
    wp::int32 var_1632;
    wp::float64 var_1633;
    wp::float64 var_1634;
    wp::int32 var_1635;
    wp::int32 var_1636;
    wp::float64 var_1637;
    wp::float64 var_1638;
    wp::float64 var_1639;
    const wp::int32 var_1640 = 4;
    wp::int32 var_1641;
    wp::int32 var_1642;
    wp::float64 var_1643;
    wp::int32 var_1644;
    wp::int32 var_1645;
    wp::float64 var_1646;
    wp::float64 var_1647;
    wp::int32 var_1648;
    wp::int32 var_1649;
    wp::float64 var_1650;
    wp::float64 var_1651;
    wp::float64 var_1652;
    wp::float64 var_1653;
    wp::int32 var_1654;
    wp::int32 var_1655;
    wp::float64 var_1656;
    wp::int32 var_1657;
    const wp::int32 var_1658 = 3;
    bool var_1659;
    wp::int32 var_1660;
    wp::int32 var_1661;
    wp::float64 var_1662;
    const wp::int32 var_1663 = 0;
    wp::int32 var_1664;
    wp::int32 var_1665;
    wp::float64 var_1666;
    wp::int32 var_1667;
    wp::int32 var_1668;
    wp::float64 var_1669;
    wp::float64 var_1670;
    wp::int32 var_1671;
    wp::int32 var_1672;
    wp::float64 var_1673;
    wp::float64 var_1674;
    wp::float64 var_1675;
    const wp::int32 var_1676 = 1;
    wp::int32 var_1677;
    wp::int32 var_1678;
    wp::float64 var_1679;
    wp::int32 var_1680;
    wp::int32 var_1681;
    wp::float64 var_1682;
    wp::float64 var_1683;
    wp::int32 var_1684;
    wp::int32 var_1685;
    wp::float64 var_1686;
    wp::float64 var_1687;
    wp::float64 var_1688;
    const wp::int32 var_1689 = 2;
    wp::int32 var_1690;
    wp::int32 var_1691;
    wp::float64 var_1692;
    wp::int32 var_1693;
    wp::int32 var_1694;
    wp::float64 var_1695;
    wp::float64 var_1696;
    wp::int32 var_1697;
    wp::int32 var_1698;
    wp::float64 var_1699;
    wp::float64 var_1700;
    wp::float64 var_1701;
    const wp::int32 var_1702 = 3;
    wp::int32 var_1703;
    wp::int32 var_1704;
    wp::float64 var_1705;
    wp::int32 var_1706;
    wp::int32 var_1707;
    wp::float64 var_1708;
    wp::float64 var_1709;
    wp::int32 var_1710;
    wp::int32 var_1711;
    wp::float64 var_1712;
    wp::float64 var_1713;
    wp::float64 var_1714;
    const wp::int32 var_1715 = 4;
    wp::int32 var_1716;
    wp::int32 var_1717;
    wp::float64 var_1718;
    wp::int32 var_1719;
    wp::int32 var_1720;
    wp::float64 var_1721;
    wp::float64 var_1722;
    wp::int32 var_1723;
    wp::int32 var_1724;
    wp::float64 var_1725;
    wp::float64 var_1726;
    wp::float64 var_1727;
    wp::float64 var_1728;
    wp::int32 var_1729;
    wp::int32 var_1730;
    wp::float64 var_1731;
    wp::int32 var_1732;
    const wp::int32 var_1733 = 4;
    bool var_1734;
    wp::int32 var_1735;
    wp::int32 var_1736;
    wp::float64 var_1737;
    const wp::int32 var_1738 = 0;
    wp::int32 var_1739;
    wp::int32 var_1740;
    wp::float64 var_1741;
    wp::int32 var_1742;
    wp::int32 var_1743;
    wp::float64 var_1744;
    wp::float64 var_1745;
    wp::int32 var_1746;
    wp::int32 var_1747;
    wp::float64 var_1748;
    wp::float64 var_1749;
    wp::float64 var_1750;
    const wp::int32 var_1751 = 1;
    wp::int32 var_1752;
    wp::int32 var_1753;
    wp::float64 var_1754;
    wp::int32 var_1755;
    wp::int32 var_1756;
    wp::float64 var_1757;
    wp::float64 var_1758;
    wp::int32 var_1759;
    wp::int32 var_1760;
    wp::float64 var_1761;
    wp::float64 var_1762;
    wp::float64 var_1763;
    const wp::int32 var_1764 = 2;
    wp::int32 var_1765;
    wp::int32 var_1766;
    wp::float64 var_1767;
    wp::int32 var_1768;
    wp::int32 var_1769;
    wp::float64 var_1770;
    wp::float64 var_1771;
    wp::int32 var_1772;
    wp::int32 var_1773;
    wp::float64 var_1774;
    wp::float64 var_1775;
    wp::float64 var_1776;
    const wp::int32 var_1777 = 3;
    wp::int32 var_1778;
    wp::int32 var_1779;
    wp::float64 var_1780;
    wp::int32 var_1781;
    wp::int32 var_1782;
    wp::float64 var_1783;
    wp::float64 var_1784;
    wp::int32 var_1785;
    wp::int32 var_1786;
    wp::float64 var_1787;
    wp::float64 var_1788;
    wp::float64 var_1789;
    const wp::int32 var_1790 = 4;
    wp::int32 var_1791;
    wp::int32 var_1792;
    wp::float64 var_1793;
    wp::int32 var_1794;
    wp::int32 var_1795;
    wp::float64 var_1796;
    wp::float64 var_1797;
    wp::int32 var_1798;
    wp::int32 var_1799;
    wp::float64 var_1800;
    wp::float64 var_1801;
    wp::float64 var_1802;
    wp::float64 var_1803;
    wp::int32 var_1804;
    wp::int32 var_1805;
    wp::float64 var_1806;
    wp::int32 var_1807;
    const wp::int32 var_1808 = 5;
    bool var_1809;
    wp::int32 var_1810;
    wp::int32 var_1811;
    wp::float64 var_1812;
    const wp::int32 var_1813 = 0;
    wp::int32 var_1814;
    wp::int32 var_1815;
    wp::float64 var_1816;
    wp::int32 var_1817;
    wp::int32 var_1818;
    wp::float64 var_1819;
    wp::float64 var_1820;
    wp::int32 var_1821;
    wp::int32 var_1822;
    wp::float64 var_1823;
    wp::float64 var_1824;
    wp::float64 var_1825;
    const wp::int32 var_1826 = 1;
    wp::int32 var_1827;
    wp::int32 var_1828;
    wp::float64 var_1829;
    wp::int32 var_1830;
    wp::int32 var_1831;
    wp::float64 var_1832;
    wp::float64 var_1833;
    wp::int32 var_1834;
    wp::int32 var_1835;
    wp::float64 var_1836;
    wp::float64 var_1837;
    wp::float64 var_1838;
    const wp::int32 var_1839 = 2;
    wp::int32 var_1840;
    wp::int32 var_1841;
    wp::float64 var_1842;
    wp::int32 var_1843;
    wp::int32 var_1844;
    wp::float64 var_1845;
    wp::float64 var_1846;
    wp::int32 var_1847;
    wp::int32 var_1848;
    wp::float64 var_1849;
    wp::float64 var_1850;
    wp::float64 var_1851;
    const wp::int32 var_1852 = 3;
    wp::int32 var_1853;
    wp::int32 var_1854;
    wp::float64 var_1855;
    wp::int32 var_1856;
    wp::int32 var_1857;
    wp::float64 var_1858;
    wp::float64 var_1859;
    wp::int32 var_1860;
    wp::int32 var_1861;
    wp::float64 var_1862;
    wp::float64 var_1863;
    wp::float64 var_1864;
    const wp::int32 var_1865 = 4;
    wp::int32 var_1866;
    wp::int32 var_1867;
    wp::float64 var_1868;
    wp::int32 var_1869;
    wp::int32 var_1870;
    wp::float64 var_1871;
    wp::float64 var_1872;
    wp::int32 var_1873;
    wp::int32 var_1874;
    wp::float64 var_1875;
    wp::float64 var_1876;
    wp::float64 var_1877;
    wp::float64 var_1878;
    wp::int32 var_1879;
    wp::int32 var_1880;
    wp::float64 var_1881;
    wp::int32 var_1882;
    //---------
    // forward
    // def factor_system(h):                                                                  <L 1>
    // a = full_matrix(h)                                                                     <L 3>
    var_0 = full_matrix_0(var_h);
    // largest = float64(0.0)                                                                 <L 4>
    var_1 = 0.0;
    // for j in range(6):                                                                     <L 5>
    // largest = max(largest, abs(a[j * UNKNOWNS + j]))                                       <L 6>
    var_4 = wp::mul(var_2, var_3);
    var_5 = wp::add(var_4, var_2);
    var_6 = wp::extract(var_0, var_5);
    var_7 = wp::abs(var_6);
    var_8 = wp::max(var_1, var_7);
    var_10 = wp::mul(var_9, var_3);
    var_11 = wp::add(var_10, var_9);
    var_12 = wp::extract(var_0, var_11);
    var_13 = wp::abs(var_12);
    var_14 = wp::max(var_8, var_13);
    var_16 = wp::mul(var_15, var_3);
    var_17 = wp::add(var_16, var_15);
    var_18 = wp::extract(var_0, var_17);
    var_19 = wp::abs(var_18);
    var_20 = wp::max(var_14, var_19);
    var_22 = wp::mul(var_21, var_3);
    var_23 = wp::add(var_22, var_21);
    var_24 = wp::extract(var_0, var_23);
    var_25 = wp::abs(var_24);
    var_26 = wp::max(var_20, var_25);
    var_28 = wp::mul(var_27, var_3);
    var_29 = wp::add(var_28, var_27);
    var_30 = wp::extract(var_0, var_29);
    var_31 = wp::abs(var_30);
    var_32 = wp::max(var_26, var_31);
    var_34 = wp::mul(var_33, var_3);
    var_35 = wp::add(var_34, var_33);
    var_36 = wp::extract(var_0, var_35);
    var_37 = wp::abs(var_36);
    var_38 = wp::max(var_32, var_37);
    // for j in range(6):                                                                     <L 7>
    // d = a[j * UNKNOWNS + j]                                                                <L 8>
    var_40 = wp::mul(var_39, var_3);
    var_41 = wp::add(var_40, var_39);
    var_42 = wp::extract(var_0, var_41);
    // for k in range(j):                                                                     <L 9>
    // inverse = float64(0.0)                                                                 <L 11>
    var_43 = 0.0;
    // if d > float64(1e-15) * largest:                                                       <L 12>
    var_44 = 1e-15;
    var_45 = wp::mul(var_44, var_38);
    var_46 = (var_42 > var_45);
    if (var_46) {
        // inverse = float64(1.0) / d                                                         <L 13>
        var_47 = 1.0;
        var_48 = wp::div(var_47, var_42);
    }
    if (!var_46) {
        // elif d - d == float64(0.0):                                                        <L 14>
        var_49 = wp::sub(var_42, var_42);
        var_50 = 0.0;
        var_51 = (var_49 == var_50);
        if (var_51) {
            // d = float64(0.0)                                                               <L 15>
            var_52 = 0.0;
        }
        if (!var_51) {
            // inverse = d                                                                    <L 17>
            var_53 = wp::copy(var_42);
        }
        var_54 = wp::where(var_51, var_52, var_42);
        var_55 = wp::where(var_51, var_43, var_53);
    }
    var_56 = wp::where(var_46, var_42, var_54);
    var_57 = wp::where(var_46, var_48, var_55);
    // a[j * UNKNOWNS + j] = d                                                                <L 18>
    var_58 = wp::mul(var_39, var_3);
    var_59 = wp::add(var_58, var_39);
    wp::assign_inplace(var_0, var_59, var_56);
    // for i in range(6):                                                                     <L 19>
    // if i > j:                                                                              <L 20>
    var_61 = (var_60 > var_39);
    if (var_61) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_62 = wp::mul(var_60, var_3);
        var_63 = wp::add(var_62, var_39);
        var_64 = wp::extract(var_0, var_63);
        // for k in range(j):                                                                 <L 22>
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_65 = wp::mul(var_64, var_57);
        var_66 = wp::mul(var_60, var_3);
        var_67 = wp::add(var_66, var_39);
        wp::assign_inplace(var_0, var_67, var_65);
    }
    // if i > j:                                                                              <L 20>
    var_69 = (var_68 > var_39);
    if (var_69) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_70 = wp::mul(var_68, var_3);
        var_71 = wp::add(var_70, var_39);
        var_72 = wp::extract(var_0, var_71);
        // for k in range(j):                                                                 <L 22>
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_73 = wp::mul(var_72, var_57);
        var_74 = wp::mul(var_68, var_3);
        var_75 = wp::add(var_74, var_39);
        wp::assign_inplace(var_0, var_75, var_73);
    }
    var_76 = wp::where(var_69, var_72, var_64);
    // if i > j:                                                                              <L 20>
    var_78 = (var_77 > var_39);
    if (var_78) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_79 = wp::mul(var_77, var_3);
        var_80 = wp::add(var_79, var_39);
        var_81 = wp::extract(var_0, var_80);
        // for k in range(j):                                                                 <L 22>
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_82 = wp::mul(var_81, var_57);
        var_83 = wp::mul(var_77, var_3);
        var_84 = wp::add(var_83, var_39);
        wp::assign_inplace(var_0, var_84, var_82);
    }
    var_85 = wp::where(var_78, var_81, var_76);
    // if i > j:                                                                              <L 20>
    var_87 = (var_86 > var_39);
    if (var_87) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_88 = wp::mul(var_86, var_3);
        var_89 = wp::add(var_88, var_39);
        var_90 = wp::extract(var_0, var_89);
        // for k in range(j):                                                                 <L 22>
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_91 = wp::mul(var_90, var_57);
        var_92 = wp::mul(var_86, var_3);
        var_93 = wp::add(var_92, var_39);
        wp::assign_inplace(var_0, var_93, var_91);
    }
    var_94 = wp::where(var_87, var_90, var_85);
    // if i > j:                                                                              <L 20>
    var_96 = (var_95 > var_39);
    if (var_96) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_97 = wp::mul(var_95, var_3);
        var_98 = wp::add(var_97, var_39);
        var_99 = wp::extract(var_0, var_98);
        // for k in range(j):                                                                 <L 22>
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_100 = wp::mul(var_99, var_57);
        var_101 = wp::mul(var_95, var_3);
        var_102 = wp::add(var_101, var_39);
        wp::assign_inplace(var_0, var_102, var_100);
    }
    var_103 = wp::where(var_96, var_99, var_94);
    // if i > j:                                                                              <L 20>
    var_105 = (var_104 > var_39);
    if (var_105) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_106 = wp::mul(var_104, var_3);
        var_107 = wp::add(var_106, var_39);
        var_108 = wp::extract(var_0, var_107);
        // for k in range(j):                                                                 <L 22>
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_109 = wp::mul(var_108, var_57);
        var_110 = wp::mul(var_104, var_3);
        var_111 = wp::add(var_110, var_39);
        wp::assign_inplace(var_0, var_111, var_109);
    }
    var_112 = wp::where(var_105, var_108, var_103);
    // d = a[j * UNKNOWNS + j]                                                                <L 8>
    var_114 = wp::mul(var_113, var_3);
    var_115 = wp::add(var_114, var_113);
    var_116 = wp::extract(var_0, var_115);
    // for k in range(j):                                                                     <L 9>
    // d -= a[j * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]                   <L 10>
    var_118 = wp::mul(var_113, var_3);
    var_119 = wp::add(var_118, var_117);
    var_120 = wp::extract(var_0, var_119);
    var_121 = wp::mul(var_113, var_3);
    var_122 = wp::add(var_121, var_117);
    var_123 = wp::extract(var_0, var_122);
    var_124 = wp::mul(var_120, var_123);
    var_125 = wp::mul(var_117, var_3);
    var_126 = wp::add(var_125, var_117);
    var_127 = wp::extract(var_0, var_126);
    var_128 = wp::mul(var_124, var_127);
    var_129 = wp::sub(var_116, var_128);
    // inverse = float64(0.0)                                                                 <L 11>
    var_130 = 0.0;
    // if d > float64(1e-15) * largest:                                                       <L 12>
    var_131 = 1e-15;
    var_132 = wp::mul(var_131, var_38);
    var_133 = (var_129 > var_132);
    if (var_133) {
        // inverse = float64(1.0) / d                                                         <L 13>
        var_134 = 1.0;
        var_135 = wp::div(var_134, var_129);
    }
    if (!var_133) {
        // elif d - d == float64(0.0):                                                        <L 14>
        var_136 = wp::sub(var_129, var_129);
        var_137 = 0.0;
        var_138 = (var_136 == var_137);
        if (var_138) {
            // d = float64(0.0)                                                               <L 15>
            var_139 = 0.0;
        }
        if (!var_138) {
            // inverse = d                                                                    <L 17>
            var_140 = wp::copy(var_129);
        }
        var_141 = wp::where(var_138, var_139, var_129);
        var_142 = wp::where(var_138, var_130, var_140);
    }
    var_143 = wp::where(var_133, var_129, var_141);
    var_144 = wp::where(var_133, var_135, var_142);
    // a[j * UNKNOWNS + j] = d                                                                <L 18>
    var_145 = wp::mul(var_113, var_3);
    var_146 = wp::add(var_145, var_113);
    wp::assign_inplace(var_0, var_146, var_143);
    // for i in range(6):                                                                     <L 19>
    // if i > j:                                                                              <L 20>
    var_148 = (var_147 > var_113);
    if (var_148) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_149 = wp::mul(var_147, var_3);
        var_150 = wp::add(var_149, var_113);
        var_151 = wp::extract(var_0, var_150);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_153 = wp::mul(var_147, var_3);
        var_154 = wp::add(var_153, var_152);
        var_155 = wp::extract(var_0, var_154);
        var_156 = wp::mul(var_113, var_3);
        var_157 = wp::add(var_156, var_152);
        var_158 = wp::extract(var_0, var_157);
        var_159 = wp::mul(var_155, var_158);
        var_160 = wp::mul(var_152, var_3);
        var_161 = wp::add(var_160, var_152);
        var_162 = wp::extract(var_0, var_161);
        var_163 = wp::mul(var_159, var_162);
        var_164 = wp::sub(var_151, var_163);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_165 = wp::mul(var_164, var_144);
        var_166 = wp::mul(var_147, var_3);
        var_167 = wp::add(var_166, var_113);
        wp::assign_inplace(var_0, var_167, var_165);
    }
    var_168 = wp::where(var_148, var_164, var_112);
    var_169 = wp::where(var_148, var_152, var_117);
    // if i > j:                                                                              <L 20>
    var_171 = (var_170 > var_113);
    if (var_171) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_172 = wp::mul(var_170, var_3);
        var_173 = wp::add(var_172, var_113);
        var_174 = wp::extract(var_0, var_173);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_176 = wp::mul(var_170, var_3);
        var_177 = wp::add(var_176, var_175);
        var_178 = wp::extract(var_0, var_177);
        var_179 = wp::mul(var_113, var_3);
        var_180 = wp::add(var_179, var_175);
        var_181 = wp::extract(var_0, var_180);
        var_182 = wp::mul(var_178, var_181);
        var_183 = wp::mul(var_175, var_3);
        var_184 = wp::add(var_183, var_175);
        var_185 = wp::extract(var_0, var_184);
        var_186 = wp::mul(var_182, var_185);
        var_187 = wp::sub(var_174, var_186);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_188 = wp::mul(var_187, var_144);
        var_189 = wp::mul(var_170, var_3);
        var_190 = wp::add(var_189, var_113);
        wp::assign_inplace(var_0, var_190, var_188);
    }
    var_191 = wp::where(var_171, var_187, var_168);
    var_192 = wp::where(var_171, var_175, var_169);
    // if i > j:                                                                              <L 20>
    var_194 = (var_193 > var_113);
    if (var_194) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_195 = wp::mul(var_193, var_3);
        var_196 = wp::add(var_195, var_113);
        var_197 = wp::extract(var_0, var_196);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_199 = wp::mul(var_193, var_3);
        var_200 = wp::add(var_199, var_198);
        var_201 = wp::extract(var_0, var_200);
        var_202 = wp::mul(var_113, var_3);
        var_203 = wp::add(var_202, var_198);
        var_204 = wp::extract(var_0, var_203);
        var_205 = wp::mul(var_201, var_204);
        var_206 = wp::mul(var_198, var_3);
        var_207 = wp::add(var_206, var_198);
        var_208 = wp::extract(var_0, var_207);
        var_209 = wp::mul(var_205, var_208);
        var_210 = wp::sub(var_197, var_209);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_211 = wp::mul(var_210, var_144);
        var_212 = wp::mul(var_193, var_3);
        var_213 = wp::add(var_212, var_113);
        wp::assign_inplace(var_0, var_213, var_211);
    }
    var_214 = wp::where(var_194, var_210, var_191);
    var_215 = wp::where(var_194, var_198, var_192);
    // if i > j:                                                                              <L 20>
    var_217 = (var_216 > var_113);
    if (var_217) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_218 = wp::mul(var_216, var_3);
        var_219 = wp::add(var_218, var_113);
        var_220 = wp::extract(var_0, var_219);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_222 = wp::mul(var_216, var_3);
        var_223 = wp::add(var_222, var_221);
        var_224 = wp::extract(var_0, var_223);
        var_225 = wp::mul(var_113, var_3);
        var_226 = wp::add(var_225, var_221);
        var_227 = wp::extract(var_0, var_226);
        var_228 = wp::mul(var_224, var_227);
        var_229 = wp::mul(var_221, var_3);
        var_230 = wp::add(var_229, var_221);
        var_231 = wp::extract(var_0, var_230);
        var_232 = wp::mul(var_228, var_231);
        var_233 = wp::sub(var_220, var_232);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_234 = wp::mul(var_233, var_144);
        var_235 = wp::mul(var_216, var_3);
        var_236 = wp::add(var_235, var_113);
        wp::assign_inplace(var_0, var_236, var_234);
    }
    var_237 = wp::where(var_217, var_233, var_214);
    var_238 = wp::where(var_217, var_221, var_215);
    // if i > j:                                                                              <L 20>
    var_240 = (var_239 > var_113);
    if (var_240) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_241 = wp::mul(var_239, var_3);
        var_242 = wp::add(var_241, var_113);
        var_243 = wp::extract(var_0, var_242);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_245 = wp::mul(var_239, var_3);
        var_246 = wp::add(var_245, var_244);
        var_247 = wp::extract(var_0, var_246);
        var_248 = wp::mul(var_113, var_3);
        var_249 = wp::add(var_248, var_244);
        var_250 = wp::extract(var_0, var_249);
        var_251 = wp::mul(var_247, var_250);
        var_252 = wp::mul(var_244, var_3);
        var_253 = wp::add(var_252, var_244);
        var_254 = wp::extract(var_0, var_253);
        var_255 = wp::mul(var_251, var_254);
        var_256 = wp::sub(var_243, var_255);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_257 = wp::mul(var_256, var_144);
        var_258 = wp::mul(var_239, var_3);
        var_259 = wp::add(var_258, var_113);
        wp::assign_inplace(var_0, var_259, var_257);
    }
    var_260 = wp::where(var_240, var_256, var_237);
    var_261 = wp::where(var_240, var_244, var_238);
    // if i > j:                                                                              <L 20>
    var_263 = (var_262 > var_113);
    if (var_263) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_264 = wp::mul(var_262, var_3);
        var_265 = wp::add(var_264, var_113);
        var_266 = wp::extract(var_0, var_265);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_268 = wp::mul(var_262, var_3);
        var_269 = wp::add(var_268, var_267);
        var_270 = wp::extract(var_0, var_269);
        var_271 = wp::mul(var_113, var_3);
        var_272 = wp::add(var_271, var_267);
        var_273 = wp::extract(var_0, var_272);
        var_274 = wp::mul(var_270, var_273);
        var_275 = wp::mul(var_267, var_3);
        var_276 = wp::add(var_275, var_267);
        var_277 = wp::extract(var_0, var_276);
        var_278 = wp::mul(var_274, var_277);
        var_279 = wp::sub(var_266, var_278);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_280 = wp::mul(var_279, var_144);
        var_281 = wp::mul(var_262, var_3);
        var_282 = wp::add(var_281, var_113);
        wp::assign_inplace(var_0, var_282, var_280);
    }
    var_283 = wp::where(var_263, var_279, var_260);
    var_284 = wp::where(var_263, var_267, var_261);
    // d = a[j * UNKNOWNS + j]                                                                <L 8>
    var_286 = wp::mul(var_285, var_3);
    var_287 = wp::add(var_286, var_285);
    var_288 = wp::extract(var_0, var_287);
    // for k in range(j):                                                                     <L 9>
    // d -= a[j * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]                   <L 10>
    var_290 = wp::mul(var_285, var_3);
    var_291 = wp::add(var_290, var_289);
    var_292 = wp::extract(var_0, var_291);
    var_293 = wp::mul(var_285, var_3);
    var_294 = wp::add(var_293, var_289);
    var_295 = wp::extract(var_0, var_294);
    var_296 = wp::mul(var_292, var_295);
    var_297 = wp::mul(var_289, var_3);
    var_298 = wp::add(var_297, var_289);
    var_299 = wp::extract(var_0, var_298);
    var_300 = wp::mul(var_296, var_299);
    var_301 = wp::sub(var_288, var_300);
    var_303 = wp::mul(var_285, var_3);
    var_304 = wp::add(var_303, var_302);
    var_305 = wp::extract(var_0, var_304);
    var_306 = wp::mul(var_285, var_3);
    var_307 = wp::add(var_306, var_302);
    var_308 = wp::extract(var_0, var_307);
    var_309 = wp::mul(var_305, var_308);
    var_310 = wp::mul(var_302, var_3);
    var_311 = wp::add(var_310, var_302);
    var_312 = wp::extract(var_0, var_311);
    var_313 = wp::mul(var_309, var_312);
    var_314 = wp::sub(var_301, var_313);
    // inverse = float64(0.0)                                                                 <L 11>
    var_315 = 0.0;
    // if d > float64(1e-15) * largest:                                                       <L 12>
    var_316 = 1e-15;
    var_317 = wp::mul(var_316, var_38);
    var_318 = (var_314 > var_317);
    if (var_318) {
        // inverse = float64(1.0) / d                                                         <L 13>
        var_319 = 1.0;
        var_320 = wp::div(var_319, var_314);
    }
    if (!var_318) {
        // elif d - d == float64(0.0):                                                        <L 14>
        var_321 = wp::sub(var_314, var_314);
        var_322 = 0.0;
        var_323 = (var_321 == var_322);
        if (var_323) {
            // d = float64(0.0)                                                               <L 15>
            var_324 = 0.0;
        }
        if (!var_323) {
            // inverse = d                                                                    <L 17>
            var_325 = wp::copy(var_314);
        }
        var_326 = wp::where(var_323, var_324, var_314);
        var_327 = wp::where(var_323, var_315, var_325);
    }
    var_328 = wp::where(var_318, var_314, var_326);
    var_329 = wp::where(var_318, var_320, var_327);
    // a[j * UNKNOWNS + j] = d                                                                <L 18>
    var_330 = wp::mul(var_285, var_3);
    var_331 = wp::add(var_330, var_285);
    wp::assign_inplace(var_0, var_331, var_328);
    // for i in range(6):                                                                     <L 19>
    // if i > j:                                                                              <L 20>
    var_333 = (var_332 > var_285);
    if (var_333) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_334 = wp::mul(var_332, var_3);
        var_335 = wp::add(var_334, var_285);
        var_336 = wp::extract(var_0, var_335);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_338 = wp::mul(var_332, var_3);
        var_339 = wp::add(var_338, var_337);
        var_340 = wp::extract(var_0, var_339);
        var_341 = wp::mul(var_285, var_3);
        var_342 = wp::add(var_341, var_337);
        var_343 = wp::extract(var_0, var_342);
        var_344 = wp::mul(var_340, var_343);
        var_345 = wp::mul(var_337, var_3);
        var_346 = wp::add(var_345, var_337);
        var_347 = wp::extract(var_0, var_346);
        var_348 = wp::mul(var_344, var_347);
        var_349 = wp::sub(var_336, var_348);
        var_351 = wp::mul(var_332, var_3);
        var_352 = wp::add(var_351, var_350);
        var_353 = wp::extract(var_0, var_352);
        var_354 = wp::mul(var_285, var_3);
        var_355 = wp::add(var_354, var_350);
        var_356 = wp::extract(var_0, var_355);
        var_357 = wp::mul(var_353, var_356);
        var_358 = wp::mul(var_350, var_3);
        var_359 = wp::add(var_358, var_350);
        var_360 = wp::extract(var_0, var_359);
        var_361 = wp::mul(var_357, var_360);
        var_362 = wp::sub(var_349, var_361);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_363 = wp::mul(var_362, var_329);
        var_364 = wp::mul(var_332, var_3);
        var_365 = wp::add(var_364, var_285);
        wp::assign_inplace(var_0, var_365, var_363);
    }
    var_366 = wp::where(var_333, var_362, var_283);
    var_367 = wp::where(var_333, var_350, var_302);
    // if i > j:                                                                              <L 20>
    var_369 = (var_368 > var_285);
    if (var_369) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_370 = wp::mul(var_368, var_3);
        var_371 = wp::add(var_370, var_285);
        var_372 = wp::extract(var_0, var_371);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_374 = wp::mul(var_368, var_3);
        var_375 = wp::add(var_374, var_373);
        var_376 = wp::extract(var_0, var_375);
        var_377 = wp::mul(var_285, var_3);
        var_378 = wp::add(var_377, var_373);
        var_379 = wp::extract(var_0, var_378);
        var_380 = wp::mul(var_376, var_379);
        var_381 = wp::mul(var_373, var_3);
        var_382 = wp::add(var_381, var_373);
        var_383 = wp::extract(var_0, var_382);
        var_384 = wp::mul(var_380, var_383);
        var_385 = wp::sub(var_372, var_384);
        var_387 = wp::mul(var_368, var_3);
        var_388 = wp::add(var_387, var_386);
        var_389 = wp::extract(var_0, var_388);
        var_390 = wp::mul(var_285, var_3);
        var_391 = wp::add(var_390, var_386);
        var_392 = wp::extract(var_0, var_391);
        var_393 = wp::mul(var_389, var_392);
        var_394 = wp::mul(var_386, var_3);
        var_395 = wp::add(var_394, var_386);
        var_396 = wp::extract(var_0, var_395);
        var_397 = wp::mul(var_393, var_396);
        var_398 = wp::sub(var_385, var_397);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_399 = wp::mul(var_398, var_329);
        var_400 = wp::mul(var_368, var_3);
        var_401 = wp::add(var_400, var_285);
        wp::assign_inplace(var_0, var_401, var_399);
    }
    var_402 = wp::where(var_369, var_398, var_366);
    var_403 = wp::where(var_369, var_386, var_367);
    // if i > j:                                                                              <L 20>
    var_405 = (var_404 > var_285);
    if (var_405) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_406 = wp::mul(var_404, var_3);
        var_407 = wp::add(var_406, var_285);
        var_408 = wp::extract(var_0, var_407);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_410 = wp::mul(var_404, var_3);
        var_411 = wp::add(var_410, var_409);
        var_412 = wp::extract(var_0, var_411);
        var_413 = wp::mul(var_285, var_3);
        var_414 = wp::add(var_413, var_409);
        var_415 = wp::extract(var_0, var_414);
        var_416 = wp::mul(var_412, var_415);
        var_417 = wp::mul(var_409, var_3);
        var_418 = wp::add(var_417, var_409);
        var_419 = wp::extract(var_0, var_418);
        var_420 = wp::mul(var_416, var_419);
        var_421 = wp::sub(var_408, var_420);
        var_423 = wp::mul(var_404, var_3);
        var_424 = wp::add(var_423, var_422);
        var_425 = wp::extract(var_0, var_424);
        var_426 = wp::mul(var_285, var_3);
        var_427 = wp::add(var_426, var_422);
        var_428 = wp::extract(var_0, var_427);
        var_429 = wp::mul(var_425, var_428);
        var_430 = wp::mul(var_422, var_3);
        var_431 = wp::add(var_430, var_422);
        var_432 = wp::extract(var_0, var_431);
        var_433 = wp::mul(var_429, var_432);
        var_434 = wp::sub(var_421, var_433);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_435 = wp::mul(var_434, var_329);
        var_436 = wp::mul(var_404, var_3);
        var_437 = wp::add(var_436, var_285);
        wp::assign_inplace(var_0, var_437, var_435);
    }
    var_438 = wp::where(var_405, var_434, var_402);
    var_439 = wp::where(var_405, var_422, var_403);
    // if i > j:                                                                              <L 20>
    var_441 = (var_440 > var_285);
    if (var_441) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_442 = wp::mul(var_440, var_3);
        var_443 = wp::add(var_442, var_285);
        var_444 = wp::extract(var_0, var_443);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_446 = wp::mul(var_440, var_3);
        var_447 = wp::add(var_446, var_445);
        var_448 = wp::extract(var_0, var_447);
        var_449 = wp::mul(var_285, var_3);
        var_450 = wp::add(var_449, var_445);
        var_451 = wp::extract(var_0, var_450);
        var_452 = wp::mul(var_448, var_451);
        var_453 = wp::mul(var_445, var_3);
        var_454 = wp::add(var_453, var_445);
        var_455 = wp::extract(var_0, var_454);
        var_456 = wp::mul(var_452, var_455);
        var_457 = wp::sub(var_444, var_456);
        var_459 = wp::mul(var_440, var_3);
        var_460 = wp::add(var_459, var_458);
        var_461 = wp::extract(var_0, var_460);
        var_462 = wp::mul(var_285, var_3);
        var_463 = wp::add(var_462, var_458);
        var_464 = wp::extract(var_0, var_463);
        var_465 = wp::mul(var_461, var_464);
        var_466 = wp::mul(var_458, var_3);
        var_467 = wp::add(var_466, var_458);
        var_468 = wp::extract(var_0, var_467);
        var_469 = wp::mul(var_465, var_468);
        var_470 = wp::sub(var_457, var_469);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_471 = wp::mul(var_470, var_329);
        var_472 = wp::mul(var_440, var_3);
        var_473 = wp::add(var_472, var_285);
        wp::assign_inplace(var_0, var_473, var_471);
    }
    var_474 = wp::where(var_441, var_470, var_438);
    var_475 = wp::where(var_441, var_458, var_439);
    // if i > j:                                                                              <L 20>
    var_477 = (var_476 > var_285);
    if (var_477) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_478 = wp::mul(var_476, var_3);
        var_479 = wp::add(var_478, var_285);
        var_480 = wp::extract(var_0, var_479);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_482 = wp::mul(var_476, var_3);
        var_483 = wp::add(var_482, var_481);
        var_484 = wp::extract(var_0, var_483);
        var_485 = wp::mul(var_285, var_3);
        var_486 = wp::add(var_485, var_481);
        var_487 = wp::extract(var_0, var_486);
        var_488 = wp::mul(var_484, var_487);
        var_489 = wp::mul(var_481, var_3);
        var_490 = wp::add(var_489, var_481);
        var_491 = wp::extract(var_0, var_490);
        var_492 = wp::mul(var_488, var_491);
        var_493 = wp::sub(var_480, var_492);
        var_495 = wp::mul(var_476, var_3);
        var_496 = wp::add(var_495, var_494);
        var_497 = wp::extract(var_0, var_496);
        var_498 = wp::mul(var_285, var_3);
        var_499 = wp::add(var_498, var_494);
        var_500 = wp::extract(var_0, var_499);
        var_501 = wp::mul(var_497, var_500);
        var_502 = wp::mul(var_494, var_3);
        var_503 = wp::add(var_502, var_494);
        var_504 = wp::extract(var_0, var_503);
        var_505 = wp::mul(var_501, var_504);
        var_506 = wp::sub(var_493, var_505);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_507 = wp::mul(var_506, var_329);
        var_508 = wp::mul(var_476, var_3);
        var_509 = wp::add(var_508, var_285);
        wp::assign_inplace(var_0, var_509, var_507);
    }
    var_510 = wp::where(var_477, var_506, var_474);
    var_511 = wp::where(var_477, var_494, var_475);
    // if i > j:                                                                              <L 20>
    var_513 = (var_512 > var_285);
    if (var_513) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_514 = wp::mul(var_512, var_3);
        var_515 = wp::add(var_514, var_285);
        var_516 = wp::extract(var_0, var_515);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_518 = wp::mul(var_512, var_3);
        var_519 = wp::add(var_518, var_517);
        var_520 = wp::extract(var_0, var_519);
        var_521 = wp::mul(var_285, var_3);
        var_522 = wp::add(var_521, var_517);
        var_523 = wp::extract(var_0, var_522);
        var_524 = wp::mul(var_520, var_523);
        var_525 = wp::mul(var_517, var_3);
        var_526 = wp::add(var_525, var_517);
        var_527 = wp::extract(var_0, var_526);
        var_528 = wp::mul(var_524, var_527);
        var_529 = wp::sub(var_516, var_528);
        var_531 = wp::mul(var_512, var_3);
        var_532 = wp::add(var_531, var_530);
        var_533 = wp::extract(var_0, var_532);
        var_534 = wp::mul(var_285, var_3);
        var_535 = wp::add(var_534, var_530);
        var_536 = wp::extract(var_0, var_535);
        var_537 = wp::mul(var_533, var_536);
        var_538 = wp::mul(var_530, var_3);
        var_539 = wp::add(var_538, var_530);
        var_540 = wp::extract(var_0, var_539);
        var_541 = wp::mul(var_537, var_540);
        var_542 = wp::sub(var_529, var_541);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_543 = wp::mul(var_542, var_329);
        var_544 = wp::mul(var_512, var_3);
        var_545 = wp::add(var_544, var_285);
        wp::assign_inplace(var_0, var_545, var_543);
    }
    var_546 = wp::where(var_513, var_542, var_510);
    var_547 = wp::where(var_513, var_530, var_511);
    // d = a[j * UNKNOWNS + j]                                                                <L 8>
    var_549 = wp::mul(var_548, var_3);
    var_550 = wp::add(var_549, var_548);
    var_551 = wp::extract(var_0, var_550);
    // for k in range(j):                                                                     <L 9>
    // d -= a[j * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]                   <L 10>
    var_553 = wp::mul(var_548, var_3);
    var_554 = wp::add(var_553, var_552);
    var_555 = wp::extract(var_0, var_554);
    var_556 = wp::mul(var_548, var_3);
    var_557 = wp::add(var_556, var_552);
    var_558 = wp::extract(var_0, var_557);
    var_559 = wp::mul(var_555, var_558);
    var_560 = wp::mul(var_552, var_3);
    var_561 = wp::add(var_560, var_552);
    var_562 = wp::extract(var_0, var_561);
    var_563 = wp::mul(var_559, var_562);
    var_564 = wp::sub(var_551, var_563);
    var_566 = wp::mul(var_548, var_3);
    var_567 = wp::add(var_566, var_565);
    var_568 = wp::extract(var_0, var_567);
    var_569 = wp::mul(var_548, var_3);
    var_570 = wp::add(var_569, var_565);
    var_571 = wp::extract(var_0, var_570);
    var_572 = wp::mul(var_568, var_571);
    var_573 = wp::mul(var_565, var_3);
    var_574 = wp::add(var_573, var_565);
    var_575 = wp::extract(var_0, var_574);
    var_576 = wp::mul(var_572, var_575);
    var_577 = wp::sub(var_564, var_576);
    var_579 = wp::mul(var_548, var_3);
    var_580 = wp::add(var_579, var_578);
    var_581 = wp::extract(var_0, var_580);
    var_582 = wp::mul(var_548, var_3);
    var_583 = wp::add(var_582, var_578);
    var_584 = wp::extract(var_0, var_583);
    var_585 = wp::mul(var_581, var_584);
    var_586 = wp::mul(var_578, var_3);
    var_587 = wp::add(var_586, var_578);
    var_588 = wp::extract(var_0, var_587);
    var_589 = wp::mul(var_585, var_588);
    var_590 = wp::sub(var_577, var_589);
    // inverse = float64(0.0)                                                                 <L 11>
    var_591 = 0.0;
    // if d > float64(1e-15) * largest:                                                       <L 12>
    var_592 = 1e-15;
    var_593 = wp::mul(var_592, var_38);
    var_594 = (var_590 > var_593);
    if (var_594) {
        // inverse = float64(1.0) / d                                                         <L 13>
        var_595 = 1.0;
        var_596 = wp::div(var_595, var_590);
    }
    if (!var_594) {
        // elif d - d == float64(0.0):                                                        <L 14>
        var_597 = wp::sub(var_590, var_590);
        var_598 = 0.0;
        var_599 = (var_597 == var_598);
        if (var_599) {
            // d = float64(0.0)                                                               <L 15>
            var_600 = 0.0;
        }
        if (!var_599) {
            // inverse = d                                                                    <L 17>
            var_601 = wp::copy(var_590);
        }
        var_602 = wp::where(var_599, var_600, var_590);
        var_603 = wp::where(var_599, var_591, var_601);
    }
    var_604 = wp::where(var_594, var_590, var_602);
    var_605 = wp::where(var_594, var_596, var_603);
    // a[j * UNKNOWNS + j] = d                                                                <L 18>
    var_606 = wp::mul(var_548, var_3);
    var_607 = wp::add(var_606, var_548);
    wp::assign_inplace(var_0, var_607, var_604);
    // for i in range(6):                                                                     <L 19>
    // if i > j:                                                                              <L 20>
    var_609 = (var_608 > var_548);
    if (var_609) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_610 = wp::mul(var_608, var_3);
        var_611 = wp::add(var_610, var_548);
        var_612 = wp::extract(var_0, var_611);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_614 = wp::mul(var_608, var_3);
        var_615 = wp::add(var_614, var_613);
        var_616 = wp::extract(var_0, var_615);
        var_617 = wp::mul(var_548, var_3);
        var_618 = wp::add(var_617, var_613);
        var_619 = wp::extract(var_0, var_618);
        var_620 = wp::mul(var_616, var_619);
        var_621 = wp::mul(var_613, var_3);
        var_622 = wp::add(var_621, var_613);
        var_623 = wp::extract(var_0, var_622);
        var_624 = wp::mul(var_620, var_623);
        var_625 = wp::sub(var_612, var_624);
        var_627 = wp::mul(var_608, var_3);
        var_628 = wp::add(var_627, var_626);
        var_629 = wp::extract(var_0, var_628);
        var_630 = wp::mul(var_548, var_3);
        var_631 = wp::add(var_630, var_626);
        var_632 = wp::extract(var_0, var_631);
        var_633 = wp::mul(var_629, var_632);
        var_634 = wp::mul(var_626, var_3);
        var_635 = wp::add(var_634, var_626);
        var_636 = wp::extract(var_0, var_635);
        var_637 = wp::mul(var_633, var_636);
        var_638 = wp::sub(var_625, var_637);
        var_640 = wp::mul(var_608, var_3);
        var_641 = wp::add(var_640, var_639);
        var_642 = wp::extract(var_0, var_641);
        var_643 = wp::mul(var_548, var_3);
        var_644 = wp::add(var_643, var_639);
        var_645 = wp::extract(var_0, var_644);
        var_646 = wp::mul(var_642, var_645);
        var_647 = wp::mul(var_639, var_3);
        var_648 = wp::add(var_647, var_639);
        var_649 = wp::extract(var_0, var_648);
        var_650 = wp::mul(var_646, var_649);
        var_651 = wp::sub(var_638, var_650);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_652 = wp::mul(var_651, var_605);
        var_653 = wp::mul(var_608, var_3);
        var_654 = wp::add(var_653, var_548);
        wp::assign_inplace(var_0, var_654, var_652);
    }
    var_655 = wp::where(var_609, var_651, var_546);
    var_656 = wp::where(var_609, var_639, var_578);
    // if i > j:                                                                              <L 20>
    var_658 = (var_657 > var_548);
    if (var_658) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_659 = wp::mul(var_657, var_3);
        var_660 = wp::add(var_659, var_548);
        var_661 = wp::extract(var_0, var_660);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_663 = wp::mul(var_657, var_3);
        var_664 = wp::add(var_663, var_662);
        var_665 = wp::extract(var_0, var_664);
        var_666 = wp::mul(var_548, var_3);
        var_667 = wp::add(var_666, var_662);
        var_668 = wp::extract(var_0, var_667);
        var_669 = wp::mul(var_665, var_668);
        var_670 = wp::mul(var_662, var_3);
        var_671 = wp::add(var_670, var_662);
        var_672 = wp::extract(var_0, var_671);
        var_673 = wp::mul(var_669, var_672);
        var_674 = wp::sub(var_661, var_673);
        var_676 = wp::mul(var_657, var_3);
        var_677 = wp::add(var_676, var_675);
        var_678 = wp::extract(var_0, var_677);
        var_679 = wp::mul(var_548, var_3);
        var_680 = wp::add(var_679, var_675);
        var_681 = wp::extract(var_0, var_680);
        var_682 = wp::mul(var_678, var_681);
        var_683 = wp::mul(var_675, var_3);
        var_684 = wp::add(var_683, var_675);
        var_685 = wp::extract(var_0, var_684);
        var_686 = wp::mul(var_682, var_685);
        var_687 = wp::sub(var_674, var_686);
        var_689 = wp::mul(var_657, var_3);
        var_690 = wp::add(var_689, var_688);
        var_691 = wp::extract(var_0, var_690);
        var_692 = wp::mul(var_548, var_3);
        var_693 = wp::add(var_692, var_688);
        var_694 = wp::extract(var_0, var_693);
        var_695 = wp::mul(var_691, var_694);
        var_696 = wp::mul(var_688, var_3);
        var_697 = wp::add(var_696, var_688);
        var_698 = wp::extract(var_0, var_697);
        var_699 = wp::mul(var_695, var_698);
        var_700 = wp::sub(var_687, var_699);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_701 = wp::mul(var_700, var_605);
        var_702 = wp::mul(var_657, var_3);
        var_703 = wp::add(var_702, var_548);
        wp::assign_inplace(var_0, var_703, var_701);
    }
    var_704 = wp::where(var_658, var_700, var_655);
    var_705 = wp::where(var_658, var_688, var_656);
    // if i > j:                                                                              <L 20>
    var_707 = (var_706 > var_548);
    if (var_707) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_708 = wp::mul(var_706, var_3);
        var_709 = wp::add(var_708, var_548);
        var_710 = wp::extract(var_0, var_709);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_712 = wp::mul(var_706, var_3);
        var_713 = wp::add(var_712, var_711);
        var_714 = wp::extract(var_0, var_713);
        var_715 = wp::mul(var_548, var_3);
        var_716 = wp::add(var_715, var_711);
        var_717 = wp::extract(var_0, var_716);
        var_718 = wp::mul(var_714, var_717);
        var_719 = wp::mul(var_711, var_3);
        var_720 = wp::add(var_719, var_711);
        var_721 = wp::extract(var_0, var_720);
        var_722 = wp::mul(var_718, var_721);
        var_723 = wp::sub(var_710, var_722);
        var_725 = wp::mul(var_706, var_3);
        var_726 = wp::add(var_725, var_724);
        var_727 = wp::extract(var_0, var_726);
        var_728 = wp::mul(var_548, var_3);
        var_729 = wp::add(var_728, var_724);
        var_730 = wp::extract(var_0, var_729);
        var_731 = wp::mul(var_727, var_730);
        var_732 = wp::mul(var_724, var_3);
        var_733 = wp::add(var_732, var_724);
        var_734 = wp::extract(var_0, var_733);
        var_735 = wp::mul(var_731, var_734);
        var_736 = wp::sub(var_723, var_735);
        var_738 = wp::mul(var_706, var_3);
        var_739 = wp::add(var_738, var_737);
        var_740 = wp::extract(var_0, var_739);
        var_741 = wp::mul(var_548, var_3);
        var_742 = wp::add(var_741, var_737);
        var_743 = wp::extract(var_0, var_742);
        var_744 = wp::mul(var_740, var_743);
        var_745 = wp::mul(var_737, var_3);
        var_746 = wp::add(var_745, var_737);
        var_747 = wp::extract(var_0, var_746);
        var_748 = wp::mul(var_744, var_747);
        var_749 = wp::sub(var_736, var_748);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_750 = wp::mul(var_749, var_605);
        var_751 = wp::mul(var_706, var_3);
        var_752 = wp::add(var_751, var_548);
        wp::assign_inplace(var_0, var_752, var_750);
    }
    var_753 = wp::where(var_707, var_749, var_704);
    var_754 = wp::where(var_707, var_737, var_705);
    // if i > j:                                                                              <L 20>
    var_756 = (var_755 > var_548);
    if (var_756) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_757 = wp::mul(var_755, var_3);
        var_758 = wp::add(var_757, var_548);
        var_759 = wp::extract(var_0, var_758);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_761 = wp::mul(var_755, var_3);
        var_762 = wp::add(var_761, var_760);
        var_763 = wp::extract(var_0, var_762);
        var_764 = wp::mul(var_548, var_3);
        var_765 = wp::add(var_764, var_760);
        var_766 = wp::extract(var_0, var_765);
        var_767 = wp::mul(var_763, var_766);
        var_768 = wp::mul(var_760, var_3);
        var_769 = wp::add(var_768, var_760);
        var_770 = wp::extract(var_0, var_769);
        var_771 = wp::mul(var_767, var_770);
        var_772 = wp::sub(var_759, var_771);
        var_774 = wp::mul(var_755, var_3);
        var_775 = wp::add(var_774, var_773);
        var_776 = wp::extract(var_0, var_775);
        var_777 = wp::mul(var_548, var_3);
        var_778 = wp::add(var_777, var_773);
        var_779 = wp::extract(var_0, var_778);
        var_780 = wp::mul(var_776, var_779);
        var_781 = wp::mul(var_773, var_3);
        var_782 = wp::add(var_781, var_773);
        var_783 = wp::extract(var_0, var_782);
        var_784 = wp::mul(var_780, var_783);
        var_785 = wp::sub(var_772, var_784);
        var_787 = wp::mul(var_755, var_3);
        var_788 = wp::add(var_787, var_786);
        var_789 = wp::extract(var_0, var_788);
        var_790 = wp::mul(var_548, var_3);
        var_791 = wp::add(var_790, var_786);
        var_792 = wp::extract(var_0, var_791);
        var_793 = wp::mul(var_789, var_792);
        var_794 = wp::mul(var_786, var_3);
        var_795 = wp::add(var_794, var_786);
        var_796 = wp::extract(var_0, var_795);
        var_797 = wp::mul(var_793, var_796);
        var_798 = wp::sub(var_785, var_797);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_799 = wp::mul(var_798, var_605);
        var_800 = wp::mul(var_755, var_3);
        var_801 = wp::add(var_800, var_548);
        wp::assign_inplace(var_0, var_801, var_799);
    }
    var_802 = wp::where(var_756, var_798, var_753);
    var_803 = wp::where(var_756, var_786, var_754);
    // if i > j:                                                                              <L 20>
    var_805 = (var_804 > var_548);
    if (var_805) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_806 = wp::mul(var_804, var_3);
        var_807 = wp::add(var_806, var_548);
        var_808 = wp::extract(var_0, var_807);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_810 = wp::mul(var_804, var_3);
        var_811 = wp::add(var_810, var_809);
        var_812 = wp::extract(var_0, var_811);
        var_813 = wp::mul(var_548, var_3);
        var_814 = wp::add(var_813, var_809);
        var_815 = wp::extract(var_0, var_814);
        var_816 = wp::mul(var_812, var_815);
        var_817 = wp::mul(var_809, var_3);
        var_818 = wp::add(var_817, var_809);
        var_819 = wp::extract(var_0, var_818);
        var_820 = wp::mul(var_816, var_819);
        var_821 = wp::sub(var_808, var_820);
        var_823 = wp::mul(var_804, var_3);
        var_824 = wp::add(var_823, var_822);
        var_825 = wp::extract(var_0, var_824);
        var_826 = wp::mul(var_548, var_3);
        var_827 = wp::add(var_826, var_822);
        var_828 = wp::extract(var_0, var_827);
        var_829 = wp::mul(var_825, var_828);
        var_830 = wp::mul(var_822, var_3);
        var_831 = wp::add(var_830, var_822);
        var_832 = wp::extract(var_0, var_831);
        var_833 = wp::mul(var_829, var_832);
        var_834 = wp::sub(var_821, var_833);
        var_836 = wp::mul(var_804, var_3);
        var_837 = wp::add(var_836, var_835);
        var_838 = wp::extract(var_0, var_837);
        var_839 = wp::mul(var_548, var_3);
        var_840 = wp::add(var_839, var_835);
        var_841 = wp::extract(var_0, var_840);
        var_842 = wp::mul(var_838, var_841);
        var_843 = wp::mul(var_835, var_3);
        var_844 = wp::add(var_843, var_835);
        var_845 = wp::extract(var_0, var_844);
        var_846 = wp::mul(var_842, var_845);
        var_847 = wp::sub(var_834, var_846);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_848 = wp::mul(var_847, var_605);
        var_849 = wp::mul(var_804, var_3);
        var_850 = wp::add(var_849, var_548);
        wp::assign_inplace(var_0, var_850, var_848);
    }
    var_851 = wp::where(var_805, var_847, var_802);
    var_852 = wp::where(var_805, var_835, var_803);
    // if i > j:                                                                              <L 20>
    var_854 = (var_853 > var_548);
    if (var_854) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_855 = wp::mul(var_853, var_3);
        var_856 = wp::add(var_855, var_548);
        var_857 = wp::extract(var_0, var_856);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_859 = wp::mul(var_853, var_3);
        var_860 = wp::add(var_859, var_858);
        var_861 = wp::extract(var_0, var_860);
        var_862 = wp::mul(var_548, var_3);
        var_863 = wp::add(var_862, var_858);
        var_864 = wp::extract(var_0, var_863);
        var_865 = wp::mul(var_861, var_864);
        var_866 = wp::mul(var_858, var_3);
        var_867 = wp::add(var_866, var_858);
        var_868 = wp::extract(var_0, var_867);
        var_869 = wp::mul(var_865, var_868);
        var_870 = wp::sub(var_857, var_869);
        var_872 = wp::mul(var_853, var_3);
        var_873 = wp::add(var_872, var_871);
        var_874 = wp::extract(var_0, var_873);
        var_875 = wp::mul(var_548, var_3);
        var_876 = wp::add(var_875, var_871);
        var_877 = wp::extract(var_0, var_876);
        var_878 = wp::mul(var_874, var_877);
        var_879 = wp::mul(var_871, var_3);
        var_880 = wp::add(var_879, var_871);
        var_881 = wp::extract(var_0, var_880);
        var_882 = wp::mul(var_878, var_881);
        var_883 = wp::sub(var_870, var_882);
        var_885 = wp::mul(var_853, var_3);
        var_886 = wp::add(var_885, var_884);
        var_887 = wp::extract(var_0, var_886);
        var_888 = wp::mul(var_548, var_3);
        var_889 = wp::add(var_888, var_884);
        var_890 = wp::extract(var_0, var_889);
        var_891 = wp::mul(var_887, var_890);
        var_892 = wp::mul(var_884, var_3);
        var_893 = wp::add(var_892, var_884);
        var_894 = wp::extract(var_0, var_893);
        var_895 = wp::mul(var_891, var_894);
        var_896 = wp::sub(var_883, var_895);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_897 = wp::mul(var_896, var_605);
        var_898 = wp::mul(var_853, var_3);
        var_899 = wp::add(var_898, var_548);
        wp::assign_inplace(var_0, var_899, var_897);
    }
    var_900 = wp::where(var_854, var_896, var_851);
    var_901 = wp::where(var_854, var_884, var_852);
    // d = a[j * UNKNOWNS + j]                                                                <L 8>
    var_903 = wp::mul(var_902, var_3);
    var_904 = wp::add(var_903, var_902);
    var_905 = wp::extract(var_0, var_904);
    // for k in range(j):                                                                     <L 9>
    // d -= a[j * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]                   <L 10>
    var_907 = wp::mul(var_902, var_3);
    var_908 = wp::add(var_907, var_906);
    var_909 = wp::extract(var_0, var_908);
    var_910 = wp::mul(var_902, var_3);
    var_911 = wp::add(var_910, var_906);
    var_912 = wp::extract(var_0, var_911);
    var_913 = wp::mul(var_909, var_912);
    var_914 = wp::mul(var_906, var_3);
    var_915 = wp::add(var_914, var_906);
    var_916 = wp::extract(var_0, var_915);
    var_917 = wp::mul(var_913, var_916);
    var_918 = wp::sub(var_905, var_917);
    var_920 = wp::mul(var_902, var_3);
    var_921 = wp::add(var_920, var_919);
    var_922 = wp::extract(var_0, var_921);
    var_923 = wp::mul(var_902, var_3);
    var_924 = wp::add(var_923, var_919);
    var_925 = wp::extract(var_0, var_924);
    var_926 = wp::mul(var_922, var_925);
    var_927 = wp::mul(var_919, var_3);
    var_928 = wp::add(var_927, var_919);
    var_929 = wp::extract(var_0, var_928);
    var_930 = wp::mul(var_926, var_929);
    var_931 = wp::sub(var_918, var_930);
    var_933 = wp::mul(var_902, var_3);
    var_934 = wp::add(var_933, var_932);
    var_935 = wp::extract(var_0, var_934);
    var_936 = wp::mul(var_902, var_3);
    var_937 = wp::add(var_936, var_932);
    var_938 = wp::extract(var_0, var_937);
    var_939 = wp::mul(var_935, var_938);
    var_940 = wp::mul(var_932, var_3);
    var_941 = wp::add(var_940, var_932);
    var_942 = wp::extract(var_0, var_941);
    var_943 = wp::mul(var_939, var_942);
    var_944 = wp::sub(var_931, var_943);
    var_946 = wp::mul(var_902, var_3);
    var_947 = wp::add(var_946, var_945);
    var_948 = wp::extract(var_0, var_947);
    var_949 = wp::mul(var_902, var_3);
    var_950 = wp::add(var_949, var_945);
    var_951 = wp::extract(var_0, var_950);
    var_952 = wp::mul(var_948, var_951);
    var_953 = wp::mul(var_945, var_3);
    var_954 = wp::add(var_953, var_945);
    var_955 = wp::extract(var_0, var_954);
    var_956 = wp::mul(var_952, var_955);
    var_957 = wp::sub(var_944, var_956);
    // inverse = float64(0.0)                                                                 <L 11>
    var_958 = 0.0;
    // if d > float64(1e-15) * largest:                                                       <L 12>
    var_959 = 1e-15;
    var_960 = wp::mul(var_959, var_38);
    var_961 = (var_957 > var_960);
    if (var_961) {
        // inverse = float64(1.0) / d                                                         <L 13>
        var_962 = 1.0;
        var_963 = wp::div(var_962, var_957);
    }
    if (!var_961) {
        // elif d - d == float64(0.0):                                                        <L 14>
        var_964 = wp::sub(var_957, var_957);
        var_965 = 0.0;
        var_966 = (var_964 == var_965);
        if (var_966) {
            // d = float64(0.0)                                                               <L 15>
            var_967 = 0.0;
        }
        if (!var_966) {
            // inverse = d                                                                    <L 17>
            var_968 = wp::copy(var_957);
        }
        var_969 = wp::where(var_966, var_967, var_957);
        var_970 = wp::where(var_966, var_958, var_968);
    }
    var_971 = wp::where(var_961, var_957, var_969);
    var_972 = wp::where(var_961, var_963, var_970);
    // a[j * UNKNOWNS + j] = d                                                                <L 18>
    var_973 = wp::mul(var_902, var_3);
    var_974 = wp::add(var_973, var_902);
    wp::assign_inplace(var_0, var_974, var_971);
    // for i in range(6):                                                                     <L 19>
    // if i > j:                                                                              <L 20>
    var_976 = (var_975 > var_902);
    if (var_976) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_977 = wp::mul(var_975, var_3);
        var_978 = wp::add(var_977, var_902);
        var_979 = wp::extract(var_0, var_978);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_981 = wp::mul(var_975, var_3);
        var_982 = wp::add(var_981, var_980);
        var_983 = wp::extract(var_0, var_982);
        var_984 = wp::mul(var_902, var_3);
        var_985 = wp::add(var_984, var_980);
        var_986 = wp::extract(var_0, var_985);
        var_987 = wp::mul(var_983, var_986);
        var_988 = wp::mul(var_980, var_3);
        var_989 = wp::add(var_988, var_980);
        var_990 = wp::extract(var_0, var_989);
        var_991 = wp::mul(var_987, var_990);
        var_992 = wp::sub(var_979, var_991);
        var_994 = wp::mul(var_975, var_3);
        var_995 = wp::add(var_994, var_993);
        var_996 = wp::extract(var_0, var_995);
        var_997 = wp::mul(var_902, var_3);
        var_998 = wp::add(var_997, var_993);
        var_999 = wp::extract(var_0, var_998);
        var_1000 = wp::mul(var_996, var_999);
        var_1001 = wp::mul(var_993, var_3);
        var_1002 = wp::add(var_1001, var_993);
        var_1003 = wp::extract(var_0, var_1002);
        var_1004 = wp::mul(var_1000, var_1003);
        var_1005 = wp::sub(var_992, var_1004);
        var_1007 = wp::mul(var_975, var_3);
        var_1008 = wp::add(var_1007, var_1006);
        var_1009 = wp::extract(var_0, var_1008);
        var_1010 = wp::mul(var_902, var_3);
        var_1011 = wp::add(var_1010, var_1006);
        var_1012 = wp::extract(var_0, var_1011);
        var_1013 = wp::mul(var_1009, var_1012);
        var_1014 = wp::mul(var_1006, var_3);
        var_1015 = wp::add(var_1014, var_1006);
        var_1016 = wp::extract(var_0, var_1015);
        var_1017 = wp::mul(var_1013, var_1016);
        var_1018 = wp::sub(var_1005, var_1017);
        var_1020 = wp::mul(var_975, var_3);
        var_1021 = wp::add(var_1020, var_1019);
        var_1022 = wp::extract(var_0, var_1021);
        var_1023 = wp::mul(var_902, var_3);
        var_1024 = wp::add(var_1023, var_1019);
        var_1025 = wp::extract(var_0, var_1024);
        var_1026 = wp::mul(var_1022, var_1025);
        var_1027 = wp::mul(var_1019, var_3);
        var_1028 = wp::add(var_1027, var_1019);
        var_1029 = wp::extract(var_0, var_1028);
        var_1030 = wp::mul(var_1026, var_1029);
        var_1031 = wp::sub(var_1018, var_1030);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_1032 = wp::mul(var_1031, var_972);
        var_1033 = wp::mul(var_975, var_3);
        var_1034 = wp::add(var_1033, var_902);
        wp::assign_inplace(var_0, var_1034, var_1032);
    }
    var_1035 = wp::where(var_976, var_1031, var_900);
    var_1036 = wp::where(var_976, var_1019, var_945);
    // if i > j:                                                                              <L 20>
    var_1038 = (var_1037 > var_902);
    if (var_1038) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_1039 = wp::mul(var_1037, var_3);
        var_1040 = wp::add(var_1039, var_902);
        var_1041 = wp::extract(var_0, var_1040);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_1043 = wp::mul(var_1037, var_3);
        var_1044 = wp::add(var_1043, var_1042);
        var_1045 = wp::extract(var_0, var_1044);
        var_1046 = wp::mul(var_902, var_3);
        var_1047 = wp::add(var_1046, var_1042);
        var_1048 = wp::extract(var_0, var_1047);
        var_1049 = wp::mul(var_1045, var_1048);
        var_1050 = wp::mul(var_1042, var_3);
        var_1051 = wp::add(var_1050, var_1042);
        var_1052 = wp::extract(var_0, var_1051);
        var_1053 = wp::mul(var_1049, var_1052);
        var_1054 = wp::sub(var_1041, var_1053);
        var_1056 = wp::mul(var_1037, var_3);
        var_1057 = wp::add(var_1056, var_1055);
        var_1058 = wp::extract(var_0, var_1057);
        var_1059 = wp::mul(var_902, var_3);
        var_1060 = wp::add(var_1059, var_1055);
        var_1061 = wp::extract(var_0, var_1060);
        var_1062 = wp::mul(var_1058, var_1061);
        var_1063 = wp::mul(var_1055, var_3);
        var_1064 = wp::add(var_1063, var_1055);
        var_1065 = wp::extract(var_0, var_1064);
        var_1066 = wp::mul(var_1062, var_1065);
        var_1067 = wp::sub(var_1054, var_1066);
        var_1069 = wp::mul(var_1037, var_3);
        var_1070 = wp::add(var_1069, var_1068);
        var_1071 = wp::extract(var_0, var_1070);
        var_1072 = wp::mul(var_902, var_3);
        var_1073 = wp::add(var_1072, var_1068);
        var_1074 = wp::extract(var_0, var_1073);
        var_1075 = wp::mul(var_1071, var_1074);
        var_1076 = wp::mul(var_1068, var_3);
        var_1077 = wp::add(var_1076, var_1068);
        var_1078 = wp::extract(var_0, var_1077);
        var_1079 = wp::mul(var_1075, var_1078);
        var_1080 = wp::sub(var_1067, var_1079);
        var_1082 = wp::mul(var_1037, var_3);
        var_1083 = wp::add(var_1082, var_1081);
        var_1084 = wp::extract(var_0, var_1083);
        var_1085 = wp::mul(var_902, var_3);
        var_1086 = wp::add(var_1085, var_1081);
        var_1087 = wp::extract(var_0, var_1086);
        var_1088 = wp::mul(var_1084, var_1087);
        var_1089 = wp::mul(var_1081, var_3);
        var_1090 = wp::add(var_1089, var_1081);
        var_1091 = wp::extract(var_0, var_1090);
        var_1092 = wp::mul(var_1088, var_1091);
        var_1093 = wp::sub(var_1080, var_1092);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_1094 = wp::mul(var_1093, var_972);
        var_1095 = wp::mul(var_1037, var_3);
        var_1096 = wp::add(var_1095, var_902);
        wp::assign_inplace(var_0, var_1096, var_1094);
    }
    var_1097 = wp::where(var_1038, var_1093, var_1035);
    var_1098 = wp::where(var_1038, var_1081, var_1036);
    // if i > j:                                                                              <L 20>
    var_1100 = (var_1099 > var_902);
    if (var_1100) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_1101 = wp::mul(var_1099, var_3);
        var_1102 = wp::add(var_1101, var_902);
        var_1103 = wp::extract(var_0, var_1102);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_1105 = wp::mul(var_1099, var_3);
        var_1106 = wp::add(var_1105, var_1104);
        var_1107 = wp::extract(var_0, var_1106);
        var_1108 = wp::mul(var_902, var_3);
        var_1109 = wp::add(var_1108, var_1104);
        var_1110 = wp::extract(var_0, var_1109);
        var_1111 = wp::mul(var_1107, var_1110);
        var_1112 = wp::mul(var_1104, var_3);
        var_1113 = wp::add(var_1112, var_1104);
        var_1114 = wp::extract(var_0, var_1113);
        var_1115 = wp::mul(var_1111, var_1114);
        var_1116 = wp::sub(var_1103, var_1115);
        var_1118 = wp::mul(var_1099, var_3);
        var_1119 = wp::add(var_1118, var_1117);
        var_1120 = wp::extract(var_0, var_1119);
        var_1121 = wp::mul(var_902, var_3);
        var_1122 = wp::add(var_1121, var_1117);
        var_1123 = wp::extract(var_0, var_1122);
        var_1124 = wp::mul(var_1120, var_1123);
        var_1125 = wp::mul(var_1117, var_3);
        var_1126 = wp::add(var_1125, var_1117);
        var_1127 = wp::extract(var_0, var_1126);
        var_1128 = wp::mul(var_1124, var_1127);
        var_1129 = wp::sub(var_1116, var_1128);
        var_1131 = wp::mul(var_1099, var_3);
        var_1132 = wp::add(var_1131, var_1130);
        var_1133 = wp::extract(var_0, var_1132);
        var_1134 = wp::mul(var_902, var_3);
        var_1135 = wp::add(var_1134, var_1130);
        var_1136 = wp::extract(var_0, var_1135);
        var_1137 = wp::mul(var_1133, var_1136);
        var_1138 = wp::mul(var_1130, var_3);
        var_1139 = wp::add(var_1138, var_1130);
        var_1140 = wp::extract(var_0, var_1139);
        var_1141 = wp::mul(var_1137, var_1140);
        var_1142 = wp::sub(var_1129, var_1141);
        var_1144 = wp::mul(var_1099, var_3);
        var_1145 = wp::add(var_1144, var_1143);
        var_1146 = wp::extract(var_0, var_1145);
        var_1147 = wp::mul(var_902, var_3);
        var_1148 = wp::add(var_1147, var_1143);
        var_1149 = wp::extract(var_0, var_1148);
        var_1150 = wp::mul(var_1146, var_1149);
        var_1151 = wp::mul(var_1143, var_3);
        var_1152 = wp::add(var_1151, var_1143);
        var_1153 = wp::extract(var_0, var_1152);
        var_1154 = wp::mul(var_1150, var_1153);
        var_1155 = wp::sub(var_1142, var_1154);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_1156 = wp::mul(var_1155, var_972);
        var_1157 = wp::mul(var_1099, var_3);
        var_1158 = wp::add(var_1157, var_902);
        wp::assign_inplace(var_0, var_1158, var_1156);
    }
    var_1159 = wp::where(var_1100, var_1155, var_1097);
    var_1160 = wp::where(var_1100, var_1143, var_1098);
    // if i > j:                                                                              <L 20>
    var_1162 = (var_1161 > var_902);
    if (var_1162) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_1163 = wp::mul(var_1161, var_3);
        var_1164 = wp::add(var_1163, var_902);
        var_1165 = wp::extract(var_0, var_1164);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_1167 = wp::mul(var_1161, var_3);
        var_1168 = wp::add(var_1167, var_1166);
        var_1169 = wp::extract(var_0, var_1168);
        var_1170 = wp::mul(var_902, var_3);
        var_1171 = wp::add(var_1170, var_1166);
        var_1172 = wp::extract(var_0, var_1171);
        var_1173 = wp::mul(var_1169, var_1172);
        var_1174 = wp::mul(var_1166, var_3);
        var_1175 = wp::add(var_1174, var_1166);
        var_1176 = wp::extract(var_0, var_1175);
        var_1177 = wp::mul(var_1173, var_1176);
        var_1178 = wp::sub(var_1165, var_1177);
        var_1180 = wp::mul(var_1161, var_3);
        var_1181 = wp::add(var_1180, var_1179);
        var_1182 = wp::extract(var_0, var_1181);
        var_1183 = wp::mul(var_902, var_3);
        var_1184 = wp::add(var_1183, var_1179);
        var_1185 = wp::extract(var_0, var_1184);
        var_1186 = wp::mul(var_1182, var_1185);
        var_1187 = wp::mul(var_1179, var_3);
        var_1188 = wp::add(var_1187, var_1179);
        var_1189 = wp::extract(var_0, var_1188);
        var_1190 = wp::mul(var_1186, var_1189);
        var_1191 = wp::sub(var_1178, var_1190);
        var_1193 = wp::mul(var_1161, var_3);
        var_1194 = wp::add(var_1193, var_1192);
        var_1195 = wp::extract(var_0, var_1194);
        var_1196 = wp::mul(var_902, var_3);
        var_1197 = wp::add(var_1196, var_1192);
        var_1198 = wp::extract(var_0, var_1197);
        var_1199 = wp::mul(var_1195, var_1198);
        var_1200 = wp::mul(var_1192, var_3);
        var_1201 = wp::add(var_1200, var_1192);
        var_1202 = wp::extract(var_0, var_1201);
        var_1203 = wp::mul(var_1199, var_1202);
        var_1204 = wp::sub(var_1191, var_1203);
        var_1206 = wp::mul(var_1161, var_3);
        var_1207 = wp::add(var_1206, var_1205);
        var_1208 = wp::extract(var_0, var_1207);
        var_1209 = wp::mul(var_902, var_3);
        var_1210 = wp::add(var_1209, var_1205);
        var_1211 = wp::extract(var_0, var_1210);
        var_1212 = wp::mul(var_1208, var_1211);
        var_1213 = wp::mul(var_1205, var_3);
        var_1214 = wp::add(var_1213, var_1205);
        var_1215 = wp::extract(var_0, var_1214);
        var_1216 = wp::mul(var_1212, var_1215);
        var_1217 = wp::sub(var_1204, var_1216);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_1218 = wp::mul(var_1217, var_972);
        var_1219 = wp::mul(var_1161, var_3);
        var_1220 = wp::add(var_1219, var_902);
        wp::assign_inplace(var_0, var_1220, var_1218);
    }
    var_1221 = wp::where(var_1162, var_1217, var_1159);
    var_1222 = wp::where(var_1162, var_1205, var_1160);
    // if i > j:                                                                              <L 20>
    var_1224 = (var_1223 > var_902);
    if (var_1224) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_1225 = wp::mul(var_1223, var_3);
        var_1226 = wp::add(var_1225, var_902);
        var_1227 = wp::extract(var_0, var_1226);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_1229 = wp::mul(var_1223, var_3);
        var_1230 = wp::add(var_1229, var_1228);
        var_1231 = wp::extract(var_0, var_1230);
        var_1232 = wp::mul(var_902, var_3);
        var_1233 = wp::add(var_1232, var_1228);
        var_1234 = wp::extract(var_0, var_1233);
        var_1235 = wp::mul(var_1231, var_1234);
        var_1236 = wp::mul(var_1228, var_3);
        var_1237 = wp::add(var_1236, var_1228);
        var_1238 = wp::extract(var_0, var_1237);
        var_1239 = wp::mul(var_1235, var_1238);
        var_1240 = wp::sub(var_1227, var_1239);
        var_1242 = wp::mul(var_1223, var_3);
        var_1243 = wp::add(var_1242, var_1241);
        var_1244 = wp::extract(var_0, var_1243);
        var_1245 = wp::mul(var_902, var_3);
        var_1246 = wp::add(var_1245, var_1241);
        var_1247 = wp::extract(var_0, var_1246);
        var_1248 = wp::mul(var_1244, var_1247);
        var_1249 = wp::mul(var_1241, var_3);
        var_1250 = wp::add(var_1249, var_1241);
        var_1251 = wp::extract(var_0, var_1250);
        var_1252 = wp::mul(var_1248, var_1251);
        var_1253 = wp::sub(var_1240, var_1252);
        var_1255 = wp::mul(var_1223, var_3);
        var_1256 = wp::add(var_1255, var_1254);
        var_1257 = wp::extract(var_0, var_1256);
        var_1258 = wp::mul(var_902, var_3);
        var_1259 = wp::add(var_1258, var_1254);
        var_1260 = wp::extract(var_0, var_1259);
        var_1261 = wp::mul(var_1257, var_1260);
        var_1262 = wp::mul(var_1254, var_3);
        var_1263 = wp::add(var_1262, var_1254);
        var_1264 = wp::extract(var_0, var_1263);
        var_1265 = wp::mul(var_1261, var_1264);
        var_1266 = wp::sub(var_1253, var_1265);
        var_1268 = wp::mul(var_1223, var_3);
        var_1269 = wp::add(var_1268, var_1267);
        var_1270 = wp::extract(var_0, var_1269);
        var_1271 = wp::mul(var_902, var_3);
        var_1272 = wp::add(var_1271, var_1267);
        var_1273 = wp::extract(var_0, var_1272);
        var_1274 = wp::mul(var_1270, var_1273);
        var_1275 = wp::mul(var_1267, var_3);
        var_1276 = wp::add(var_1275, var_1267);
        var_1277 = wp::extract(var_0, var_1276);
        var_1278 = wp::mul(var_1274, var_1277);
        var_1279 = wp::sub(var_1266, var_1278);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_1280 = wp::mul(var_1279, var_972);
        var_1281 = wp::mul(var_1223, var_3);
        var_1282 = wp::add(var_1281, var_902);
        wp::assign_inplace(var_0, var_1282, var_1280);
    }
    var_1283 = wp::where(var_1224, var_1279, var_1221);
    var_1284 = wp::where(var_1224, var_1267, var_1222);
    // if i > j:                                                                              <L 20>
    var_1286 = (var_1285 > var_902);
    if (var_1286) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_1287 = wp::mul(var_1285, var_3);
        var_1288 = wp::add(var_1287, var_902);
        var_1289 = wp::extract(var_0, var_1288);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_1291 = wp::mul(var_1285, var_3);
        var_1292 = wp::add(var_1291, var_1290);
        var_1293 = wp::extract(var_0, var_1292);
        var_1294 = wp::mul(var_902, var_3);
        var_1295 = wp::add(var_1294, var_1290);
        var_1296 = wp::extract(var_0, var_1295);
        var_1297 = wp::mul(var_1293, var_1296);
        var_1298 = wp::mul(var_1290, var_3);
        var_1299 = wp::add(var_1298, var_1290);
        var_1300 = wp::extract(var_0, var_1299);
        var_1301 = wp::mul(var_1297, var_1300);
        var_1302 = wp::sub(var_1289, var_1301);
        var_1304 = wp::mul(var_1285, var_3);
        var_1305 = wp::add(var_1304, var_1303);
        var_1306 = wp::extract(var_0, var_1305);
        var_1307 = wp::mul(var_902, var_3);
        var_1308 = wp::add(var_1307, var_1303);
        var_1309 = wp::extract(var_0, var_1308);
        var_1310 = wp::mul(var_1306, var_1309);
        var_1311 = wp::mul(var_1303, var_3);
        var_1312 = wp::add(var_1311, var_1303);
        var_1313 = wp::extract(var_0, var_1312);
        var_1314 = wp::mul(var_1310, var_1313);
        var_1315 = wp::sub(var_1302, var_1314);
        var_1317 = wp::mul(var_1285, var_3);
        var_1318 = wp::add(var_1317, var_1316);
        var_1319 = wp::extract(var_0, var_1318);
        var_1320 = wp::mul(var_902, var_3);
        var_1321 = wp::add(var_1320, var_1316);
        var_1322 = wp::extract(var_0, var_1321);
        var_1323 = wp::mul(var_1319, var_1322);
        var_1324 = wp::mul(var_1316, var_3);
        var_1325 = wp::add(var_1324, var_1316);
        var_1326 = wp::extract(var_0, var_1325);
        var_1327 = wp::mul(var_1323, var_1326);
        var_1328 = wp::sub(var_1315, var_1327);
        var_1330 = wp::mul(var_1285, var_3);
        var_1331 = wp::add(var_1330, var_1329);
        var_1332 = wp::extract(var_0, var_1331);
        var_1333 = wp::mul(var_902, var_3);
        var_1334 = wp::add(var_1333, var_1329);
        var_1335 = wp::extract(var_0, var_1334);
        var_1336 = wp::mul(var_1332, var_1335);
        var_1337 = wp::mul(var_1329, var_3);
        var_1338 = wp::add(var_1337, var_1329);
        var_1339 = wp::extract(var_0, var_1338);
        var_1340 = wp::mul(var_1336, var_1339);
        var_1341 = wp::sub(var_1328, var_1340);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_1342 = wp::mul(var_1341, var_972);
        var_1343 = wp::mul(var_1285, var_3);
        var_1344 = wp::add(var_1343, var_902);
        wp::assign_inplace(var_0, var_1344, var_1342);
    }
    var_1345 = wp::where(var_1286, var_1341, var_1283);
    var_1346 = wp::where(var_1286, var_1329, var_1284);
    // d = a[j * UNKNOWNS + j]                                                                <L 8>
    var_1348 = wp::mul(var_1347, var_3);
    var_1349 = wp::add(var_1348, var_1347);
    var_1350 = wp::extract(var_0, var_1349);
    // for k in range(j):                                                                     <L 9>
    // d -= a[j * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]                   <L 10>
    var_1352 = wp::mul(var_1347, var_3);
    var_1353 = wp::add(var_1352, var_1351);
    var_1354 = wp::extract(var_0, var_1353);
    var_1355 = wp::mul(var_1347, var_3);
    var_1356 = wp::add(var_1355, var_1351);
    var_1357 = wp::extract(var_0, var_1356);
    var_1358 = wp::mul(var_1354, var_1357);
    var_1359 = wp::mul(var_1351, var_3);
    var_1360 = wp::add(var_1359, var_1351);
    var_1361 = wp::extract(var_0, var_1360);
    var_1362 = wp::mul(var_1358, var_1361);
    var_1363 = wp::sub(var_1350, var_1362);
    var_1365 = wp::mul(var_1347, var_3);
    var_1366 = wp::add(var_1365, var_1364);
    var_1367 = wp::extract(var_0, var_1366);
    var_1368 = wp::mul(var_1347, var_3);
    var_1369 = wp::add(var_1368, var_1364);
    var_1370 = wp::extract(var_0, var_1369);
    var_1371 = wp::mul(var_1367, var_1370);
    var_1372 = wp::mul(var_1364, var_3);
    var_1373 = wp::add(var_1372, var_1364);
    var_1374 = wp::extract(var_0, var_1373);
    var_1375 = wp::mul(var_1371, var_1374);
    var_1376 = wp::sub(var_1363, var_1375);
    var_1378 = wp::mul(var_1347, var_3);
    var_1379 = wp::add(var_1378, var_1377);
    var_1380 = wp::extract(var_0, var_1379);
    var_1381 = wp::mul(var_1347, var_3);
    var_1382 = wp::add(var_1381, var_1377);
    var_1383 = wp::extract(var_0, var_1382);
    var_1384 = wp::mul(var_1380, var_1383);
    var_1385 = wp::mul(var_1377, var_3);
    var_1386 = wp::add(var_1385, var_1377);
    var_1387 = wp::extract(var_0, var_1386);
    var_1388 = wp::mul(var_1384, var_1387);
    var_1389 = wp::sub(var_1376, var_1388);
    var_1391 = wp::mul(var_1347, var_3);
    var_1392 = wp::add(var_1391, var_1390);
    var_1393 = wp::extract(var_0, var_1392);
    var_1394 = wp::mul(var_1347, var_3);
    var_1395 = wp::add(var_1394, var_1390);
    var_1396 = wp::extract(var_0, var_1395);
    var_1397 = wp::mul(var_1393, var_1396);
    var_1398 = wp::mul(var_1390, var_3);
    var_1399 = wp::add(var_1398, var_1390);
    var_1400 = wp::extract(var_0, var_1399);
    var_1401 = wp::mul(var_1397, var_1400);
    var_1402 = wp::sub(var_1389, var_1401);
    var_1404 = wp::mul(var_1347, var_3);
    var_1405 = wp::add(var_1404, var_1403);
    var_1406 = wp::extract(var_0, var_1405);
    var_1407 = wp::mul(var_1347, var_3);
    var_1408 = wp::add(var_1407, var_1403);
    var_1409 = wp::extract(var_0, var_1408);
    var_1410 = wp::mul(var_1406, var_1409);
    var_1411 = wp::mul(var_1403, var_3);
    var_1412 = wp::add(var_1411, var_1403);
    var_1413 = wp::extract(var_0, var_1412);
    var_1414 = wp::mul(var_1410, var_1413);
    var_1415 = wp::sub(var_1402, var_1414);
    // inverse = float64(0.0)                                                                 <L 11>
    var_1416 = 0.0;
    // if d > float64(1e-15) * largest:                                                       <L 12>
    var_1417 = 1e-15;
    var_1418 = wp::mul(var_1417, var_38);
    var_1419 = (var_1415 > var_1418);
    if (var_1419) {
        // inverse = float64(1.0) / d                                                         <L 13>
        var_1420 = 1.0;
        var_1421 = wp::div(var_1420, var_1415);
    }
    if (!var_1419) {
        // elif d - d == float64(0.0):                                                        <L 14>
        var_1422 = wp::sub(var_1415, var_1415);
        var_1423 = 0.0;
        var_1424 = (var_1422 == var_1423);
        if (var_1424) {
            // d = float64(0.0)                                                               <L 15>
            var_1425 = 0.0;
        }
        if (!var_1424) {
            // inverse = d                                                                    <L 17>
            var_1426 = wp::copy(var_1415);
        }
        var_1427 = wp::where(var_1424, var_1425, var_1415);
        var_1428 = wp::where(var_1424, var_1416, var_1426);
    }
    var_1429 = wp::where(var_1419, var_1415, var_1427);
    var_1430 = wp::where(var_1419, var_1421, var_1428);
    // a[j * UNKNOWNS + j] = d                                                                <L 18>
    var_1431 = wp::mul(var_1347, var_3);
    var_1432 = wp::add(var_1431, var_1347);
    wp::assign_inplace(var_0, var_1432, var_1429);
    // for i in range(6):                                                                     <L 19>
    // if i > j:                                                                              <L 20>
    var_1434 = (var_1433 > var_1347);
    if (var_1434) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_1435 = wp::mul(var_1433, var_3);
        var_1436 = wp::add(var_1435, var_1347);
        var_1437 = wp::extract(var_0, var_1436);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_1439 = wp::mul(var_1433, var_3);
        var_1440 = wp::add(var_1439, var_1438);
        var_1441 = wp::extract(var_0, var_1440);
        var_1442 = wp::mul(var_1347, var_3);
        var_1443 = wp::add(var_1442, var_1438);
        var_1444 = wp::extract(var_0, var_1443);
        var_1445 = wp::mul(var_1441, var_1444);
        var_1446 = wp::mul(var_1438, var_3);
        var_1447 = wp::add(var_1446, var_1438);
        var_1448 = wp::extract(var_0, var_1447);
        var_1449 = wp::mul(var_1445, var_1448);
        var_1450 = wp::sub(var_1437, var_1449);
        var_1452 = wp::mul(var_1433, var_3);
        var_1453 = wp::add(var_1452, var_1451);
        var_1454 = wp::extract(var_0, var_1453);
        var_1455 = wp::mul(var_1347, var_3);
        var_1456 = wp::add(var_1455, var_1451);
        var_1457 = wp::extract(var_0, var_1456);
        var_1458 = wp::mul(var_1454, var_1457);
        var_1459 = wp::mul(var_1451, var_3);
        var_1460 = wp::add(var_1459, var_1451);
        var_1461 = wp::extract(var_0, var_1460);
        var_1462 = wp::mul(var_1458, var_1461);
        var_1463 = wp::sub(var_1450, var_1462);
        var_1465 = wp::mul(var_1433, var_3);
        var_1466 = wp::add(var_1465, var_1464);
        var_1467 = wp::extract(var_0, var_1466);
        var_1468 = wp::mul(var_1347, var_3);
        var_1469 = wp::add(var_1468, var_1464);
        var_1470 = wp::extract(var_0, var_1469);
        var_1471 = wp::mul(var_1467, var_1470);
        var_1472 = wp::mul(var_1464, var_3);
        var_1473 = wp::add(var_1472, var_1464);
        var_1474 = wp::extract(var_0, var_1473);
        var_1475 = wp::mul(var_1471, var_1474);
        var_1476 = wp::sub(var_1463, var_1475);
        var_1478 = wp::mul(var_1433, var_3);
        var_1479 = wp::add(var_1478, var_1477);
        var_1480 = wp::extract(var_0, var_1479);
        var_1481 = wp::mul(var_1347, var_3);
        var_1482 = wp::add(var_1481, var_1477);
        var_1483 = wp::extract(var_0, var_1482);
        var_1484 = wp::mul(var_1480, var_1483);
        var_1485 = wp::mul(var_1477, var_3);
        var_1486 = wp::add(var_1485, var_1477);
        var_1487 = wp::extract(var_0, var_1486);
        var_1488 = wp::mul(var_1484, var_1487);
        var_1489 = wp::sub(var_1476, var_1488);
        var_1491 = wp::mul(var_1433, var_3);
        var_1492 = wp::add(var_1491, var_1490);
        var_1493 = wp::extract(var_0, var_1492);
        var_1494 = wp::mul(var_1347, var_3);
        var_1495 = wp::add(var_1494, var_1490);
        var_1496 = wp::extract(var_0, var_1495);
        var_1497 = wp::mul(var_1493, var_1496);
        var_1498 = wp::mul(var_1490, var_3);
        var_1499 = wp::add(var_1498, var_1490);
        var_1500 = wp::extract(var_0, var_1499);
        var_1501 = wp::mul(var_1497, var_1500);
        var_1502 = wp::sub(var_1489, var_1501);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_1503 = wp::mul(var_1502, var_1430);
        var_1504 = wp::mul(var_1433, var_3);
        var_1505 = wp::add(var_1504, var_1347);
        wp::assign_inplace(var_0, var_1505, var_1503);
    }
    var_1506 = wp::where(var_1434, var_1502, var_1345);
    var_1507 = wp::where(var_1434, var_1490, var_1403);
    // if i > j:                                                                              <L 20>
    var_1509 = (var_1508 > var_1347);
    if (var_1509) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_1510 = wp::mul(var_1508, var_3);
        var_1511 = wp::add(var_1510, var_1347);
        var_1512 = wp::extract(var_0, var_1511);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_1514 = wp::mul(var_1508, var_3);
        var_1515 = wp::add(var_1514, var_1513);
        var_1516 = wp::extract(var_0, var_1515);
        var_1517 = wp::mul(var_1347, var_3);
        var_1518 = wp::add(var_1517, var_1513);
        var_1519 = wp::extract(var_0, var_1518);
        var_1520 = wp::mul(var_1516, var_1519);
        var_1521 = wp::mul(var_1513, var_3);
        var_1522 = wp::add(var_1521, var_1513);
        var_1523 = wp::extract(var_0, var_1522);
        var_1524 = wp::mul(var_1520, var_1523);
        var_1525 = wp::sub(var_1512, var_1524);
        var_1527 = wp::mul(var_1508, var_3);
        var_1528 = wp::add(var_1527, var_1526);
        var_1529 = wp::extract(var_0, var_1528);
        var_1530 = wp::mul(var_1347, var_3);
        var_1531 = wp::add(var_1530, var_1526);
        var_1532 = wp::extract(var_0, var_1531);
        var_1533 = wp::mul(var_1529, var_1532);
        var_1534 = wp::mul(var_1526, var_3);
        var_1535 = wp::add(var_1534, var_1526);
        var_1536 = wp::extract(var_0, var_1535);
        var_1537 = wp::mul(var_1533, var_1536);
        var_1538 = wp::sub(var_1525, var_1537);
        var_1540 = wp::mul(var_1508, var_3);
        var_1541 = wp::add(var_1540, var_1539);
        var_1542 = wp::extract(var_0, var_1541);
        var_1543 = wp::mul(var_1347, var_3);
        var_1544 = wp::add(var_1543, var_1539);
        var_1545 = wp::extract(var_0, var_1544);
        var_1546 = wp::mul(var_1542, var_1545);
        var_1547 = wp::mul(var_1539, var_3);
        var_1548 = wp::add(var_1547, var_1539);
        var_1549 = wp::extract(var_0, var_1548);
        var_1550 = wp::mul(var_1546, var_1549);
        var_1551 = wp::sub(var_1538, var_1550);
        var_1553 = wp::mul(var_1508, var_3);
        var_1554 = wp::add(var_1553, var_1552);
        var_1555 = wp::extract(var_0, var_1554);
        var_1556 = wp::mul(var_1347, var_3);
        var_1557 = wp::add(var_1556, var_1552);
        var_1558 = wp::extract(var_0, var_1557);
        var_1559 = wp::mul(var_1555, var_1558);
        var_1560 = wp::mul(var_1552, var_3);
        var_1561 = wp::add(var_1560, var_1552);
        var_1562 = wp::extract(var_0, var_1561);
        var_1563 = wp::mul(var_1559, var_1562);
        var_1564 = wp::sub(var_1551, var_1563);
        var_1566 = wp::mul(var_1508, var_3);
        var_1567 = wp::add(var_1566, var_1565);
        var_1568 = wp::extract(var_0, var_1567);
        var_1569 = wp::mul(var_1347, var_3);
        var_1570 = wp::add(var_1569, var_1565);
        var_1571 = wp::extract(var_0, var_1570);
        var_1572 = wp::mul(var_1568, var_1571);
        var_1573 = wp::mul(var_1565, var_3);
        var_1574 = wp::add(var_1573, var_1565);
        var_1575 = wp::extract(var_0, var_1574);
        var_1576 = wp::mul(var_1572, var_1575);
        var_1577 = wp::sub(var_1564, var_1576);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_1578 = wp::mul(var_1577, var_1430);
        var_1579 = wp::mul(var_1508, var_3);
        var_1580 = wp::add(var_1579, var_1347);
        wp::assign_inplace(var_0, var_1580, var_1578);
    }
    var_1581 = wp::where(var_1509, var_1577, var_1506);
    var_1582 = wp::where(var_1509, var_1565, var_1507);
    // if i > j:                                                                              <L 20>
    var_1584 = (var_1583 > var_1347);
    if (var_1584) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_1585 = wp::mul(var_1583, var_3);
        var_1586 = wp::add(var_1585, var_1347);
        var_1587 = wp::extract(var_0, var_1586);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_1589 = wp::mul(var_1583, var_3);
        var_1590 = wp::add(var_1589, var_1588);
        var_1591 = wp::extract(var_0, var_1590);
        var_1592 = wp::mul(var_1347, var_3);
        var_1593 = wp::add(var_1592, var_1588);
        var_1594 = wp::extract(var_0, var_1593);
        var_1595 = wp::mul(var_1591, var_1594);
        var_1596 = wp::mul(var_1588, var_3);
        var_1597 = wp::add(var_1596, var_1588);
        var_1598 = wp::extract(var_0, var_1597);
        var_1599 = wp::mul(var_1595, var_1598);
        var_1600 = wp::sub(var_1587, var_1599);
        var_1602 = wp::mul(var_1583, var_3);
        var_1603 = wp::add(var_1602, var_1601);
        var_1604 = wp::extract(var_0, var_1603);
        var_1605 = wp::mul(var_1347, var_3);
        var_1606 = wp::add(var_1605, var_1601);
        var_1607 = wp::extract(var_0, var_1606);
        var_1608 = wp::mul(var_1604, var_1607);
        var_1609 = wp::mul(var_1601, var_3);
        var_1610 = wp::add(var_1609, var_1601);
        var_1611 = wp::extract(var_0, var_1610);
        var_1612 = wp::mul(var_1608, var_1611);
        var_1613 = wp::sub(var_1600, var_1612);
        var_1615 = wp::mul(var_1583, var_3);
        var_1616 = wp::add(var_1615, var_1614);
        var_1617 = wp::extract(var_0, var_1616);
        var_1618 = wp::mul(var_1347, var_3);
        var_1619 = wp::add(var_1618, var_1614);
        var_1620 = wp::extract(var_0, var_1619);
        var_1621 = wp::mul(var_1617, var_1620);
        var_1622 = wp::mul(var_1614, var_3);
        var_1623 = wp::add(var_1622, var_1614);
        var_1624 = wp::extract(var_0, var_1623);
        var_1625 = wp::mul(var_1621, var_1624);
        var_1626 = wp::sub(var_1613, var_1625);
        var_1628 = wp::mul(var_1583, var_3);
        var_1629 = wp::add(var_1628, var_1627);
        var_1630 = wp::extract(var_0, var_1629);
        var_1631 = wp::mul(var_1347, var_3);
        var_1632 = wp::add(var_1631, var_1627);
        var_1633 = wp::extract(var_0, var_1632);
        var_1634 = wp::mul(var_1630, var_1633);
        var_1635 = wp::mul(var_1627, var_3);
        var_1636 = wp::add(var_1635, var_1627);
        var_1637 = wp::extract(var_0, var_1636);
        var_1638 = wp::mul(var_1634, var_1637);
        var_1639 = wp::sub(var_1626, var_1638);
        var_1641 = wp::mul(var_1583, var_3);
        var_1642 = wp::add(var_1641, var_1640);
        var_1643 = wp::extract(var_0, var_1642);
        var_1644 = wp::mul(var_1347, var_3);
        var_1645 = wp::add(var_1644, var_1640);
        var_1646 = wp::extract(var_0, var_1645);
        var_1647 = wp::mul(var_1643, var_1646);
        var_1648 = wp::mul(var_1640, var_3);
        var_1649 = wp::add(var_1648, var_1640);
        var_1650 = wp::extract(var_0, var_1649);
        var_1651 = wp::mul(var_1647, var_1650);
        var_1652 = wp::sub(var_1639, var_1651);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_1653 = wp::mul(var_1652, var_1430);
        var_1654 = wp::mul(var_1583, var_3);
        var_1655 = wp::add(var_1654, var_1347);
        wp::assign_inplace(var_0, var_1655, var_1653);
    }
    var_1656 = wp::where(var_1584, var_1652, var_1581);
    var_1657 = wp::where(var_1584, var_1640, var_1582);
    // if i > j:                                                                              <L 20>
    var_1659 = (var_1658 > var_1347);
    if (var_1659) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_1660 = wp::mul(var_1658, var_3);
        var_1661 = wp::add(var_1660, var_1347);
        var_1662 = wp::extract(var_0, var_1661);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_1664 = wp::mul(var_1658, var_3);
        var_1665 = wp::add(var_1664, var_1663);
        var_1666 = wp::extract(var_0, var_1665);
        var_1667 = wp::mul(var_1347, var_3);
        var_1668 = wp::add(var_1667, var_1663);
        var_1669 = wp::extract(var_0, var_1668);
        var_1670 = wp::mul(var_1666, var_1669);
        var_1671 = wp::mul(var_1663, var_3);
        var_1672 = wp::add(var_1671, var_1663);
        var_1673 = wp::extract(var_0, var_1672);
        var_1674 = wp::mul(var_1670, var_1673);
        var_1675 = wp::sub(var_1662, var_1674);
        var_1677 = wp::mul(var_1658, var_3);
        var_1678 = wp::add(var_1677, var_1676);
        var_1679 = wp::extract(var_0, var_1678);
        var_1680 = wp::mul(var_1347, var_3);
        var_1681 = wp::add(var_1680, var_1676);
        var_1682 = wp::extract(var_0, var_1681);
        var_1683 = wp::mul(var_1679, var_1682);
        var_1684 = wp::mul(var_1676, var_3);
        var_1685 = wp::add(var_1684, var_1676);
        var_1686 = wp::extract(var_0, var_1685);
        var_1687 = wp::mul(var_1683, var_1686);
        var_1688 = wp::sub(var_1675, var_1687);
        var_1690 = wp::mul(var_1658, var_3);
        var_1691 = wp::add(var_1690, var_1689);
        var_1692 = wp::extract(var_0, var_1691);
        var_1693 = wp::mul(var_1347, var_3);
        var_1694 = wp::add(var_1693, var_1689);
        var_1695 = wp::extract(var_0, var_1694);
        var_1696 = wp::mul(var_1692, var_1695);
        var_1697 = wp::mul(var_1689, var_3);
        var_1698 = wp::add(var_1697, var_1689);
        var_1699 = wp::extract(var_0, var_1698);
        var_1700 = wp::mul(var_1696, var_1699);
        var_1701 = wp::sub(var_1688, var_1700);
        var_1703 = wp::mul(var_1658, var_3);
        var_1704 = wp::add(var_1703, var_1702);
        var_1705 = wp::extract(var_0, var_1704);
        var_1706 = wp::mul(var_1347, var_3);
        var_1707 = wp::add(var_1706, var_1702);
        var_1708 = wp::extract(var_0, var_1707);
        var_1709 = wp::mul(var_1705, var_1708);
        var_1710 = wp::mul(var_1702, var_3);
        var_1711 = wp::add(var_1710, var_1702);
        var_1712 = wp::extract(var_0, var_1711);
        var_1713 = wp::mul(var_1709, var_1712);
        var_1714 = wp::sub(var_1701, var_1713);
        var_1716 = wp::mul(var_1658, var_3);
        var_1717 = wp::add(var_1716, var_1715);
        var_1718 = wp::extract(var_0, var_1717);
        var_1719 = wp::mul(var_1347, var_3);
        var_1720 = wp::add(var_1719, var_1715);
        var_1721 = wp::extract(var_0, var_1720);
        var_1722 = wp::mul(var_1718, var_1721);
        var_1723 = wp::mul(var_1715, var_3);
        var_1724 = wp::add(var_1723, var_1715);
        var_1725 = wp::extract(var_0, var_1724);
        var_1726 = wp::mul(var_1722, var_1725);
        var_1727 = wp::sub(var_1714, var_1726);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_1728 = wp::mul(var_1727, var_1430);
        var_1729 = wp::mul(var_1658, var_3);
        var_1730 = wp::add(var_1729, var_1347);
        wp::assign_inplace(var_0, var_1730, var_1728);
    }
    var_1731 = wp::where(var_1659, var_1727, var_1656);
    var_1732 = wp::where(var_1659, var_1715, var_1657);
    // if i > j:                                                                              <L 20>
    var_1734 = (var_1733 > var_1347);
    if (var_1734) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_1735 = wp::mul(var_1733, var_3);
        var_1736 = wp::add(var_1735, var_1347);
        var_1737 = wp::extract(var_0, var_1736);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_1739 = wp::mul(var_1733, var_3);
        var_1740 = wp::add(var_1739, var_1738);
        var_1741 = wp::extract(var_0, var_1740);
        var_1742 = wp::mul(var_1347, var_3);
        var_1743 = wp::add(var_1742, var_1738);
        var_1744 = wp::extract(var_0, var_1743);
        var_1745 = wp::mul(var_1741, var_1744);
        var_1746 = wp::mul(var_1738, var_3);
        var_1747 = wp::add(var_1746, var_1738);
        var_1748 = wp::extract(var_0, var_1747);
        var_1749 = wp::mul(var_1745, var_1748);
        var_1750 = wp::sub(var_1737, var_1749);
        var_1752 = wp::mul(var_1733, var_3);
        var_1753 = wp::add(var_1752, var_1751);
        var_1754 = wp::extract(var_0, var_1753);
        var_1755 = wp::mul(var_1347, var_3);
        var_1756 = wp::add(var_1755, var_1751);
        var_1757 = wp::extract(var_0, var_1756);
        var_1758 = wp::mul(var_1754, var_1757);
        var_1759 = wp::mul(var_1751, var_3);
        var_1760 = wp::add(var_1759, var_1751);
        var_1761 = wp::extract(var_0, var_1760);
        var_1762 = wp::mul(var_1758, var_1761);
        var_1763 = wp::sub(var_1750, var_1762);
        var_1765 = wp::mul(var_1733, var_3);
        var_1766 = wp::add(var_1765, var_1764);
        var_1767 = wp::extract(var_0, var_1766);
        var_1768 = wp::mul(var_1347, var_3);
        var_1769 = wp::add(var_1768, var_1764);
        var_1770 = wp::extract(var_0, var_1769);
        var_1771 = wp::mul(var_1767, var_1770);
        var_1772 = wp::mul(var_1764, var_3);
        var_1773 = wp::add(var_1772, var_1764);
        var_1774 = wp::extract(var_0, var_1773);
        var_1775 = wp::mul(var_1771, var_1774);
        var_1776 = wp::sub(var_1763, var_1775);
        var_1778 = wp::mul(var_1733, var_3);
        var_1779 = wp::add(var_1778, var_1777);
        var_1780 = wp::extract(var_0, var_1779);
        var_1781 = wp::mul(var_1347, var_3);
        var_1782 = wp::add(var_1781, var_1777);
        var_1783 = wp::extract(var_0, var_1782);
        var_1784 = wp::mul(var_1780, var_1783);
        var_1785 = wp::mul(var_1777, var_3);
        var_1786 = wp::add(var_1785, var_1777);
        var_1787 = wp::extract(var_0, var_1786);
        var_1788 = wp::mul(var_1784, var_1787);
        var_1789 = wp::sub(var_1776, var_1788);
        var_1791 = wp::mul(var_1733, var_3);
        var_1792 = wp::add(var_1791, var_1790);
        var_1793 = wp::extract(var_0, var_1792);
        var_1794 = wp::mul(var_1347, var_3);
        var_1795 = wp::add(var_1794, var_1790);
        var_1796 = wp::extract(var_0, var_1795);
        var_1797 = wp::mul(var_1793, var_1796);
        var_1798 = wp::mul(var_1790, var_3);
        var_1799 = wp::add(var_1798, var_1790);
        var_1800 = wp::extract(var_0, var_1799);
        var_1801 = wp::mul(var_1797, var_1800);
        var_1802 = wp::sub(var_1789, var_1801);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_1803 = wp::mul(var_1802, var_1430);
        var_1804 = wp::mul(var_1733, var_3);
        var_1805 = wp::add(var_1804, var_1347);
        wp::assign_inplace(var_0, var_1805, var_1803);
    }
    var_1806 = wp::where(var_1734, var_1802, var_1731);
    var_1807 = wp::where(var_1734, var_1790, var_1732);
    // if i > j:                                                                              <L 20>
    var_1809 = (var_1808 > var_1347);
    if (var_1809) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_1810 = wp::mul(var_1808, var_3);
        var_1811 = wp::add(var_1810, var_1347);
        var_1812 = wp::extract(var_0, var_1811);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_1814 = wp::mul(var_1808, var_3);
        var_1815 = wp::add(var_1814, var_1813);
        var_1816 = wp::extract(var_0, var_1815);
        var_1817 = wp::mul(var_1347, var_3);
        var_1818 = wp::add(var_1817, var_1813);
        var_1819 = wp::extract(var_0, var_1818);
        var_1820 = wp::mul(var_1816, var_1819);
        var_1821 = wp::mul(var_1813, var_3);
        var_1822 = wp::add(var_1821, var_1813);
        var_1823 = wp::extract(var_0, var_1822);
        var_1824 = wp::mul(var_1820, var_1823);
        var_1825 = wp::sub(var_1812, var_1824);
        var_1827 = wp::mul(var_1808, var_3);
        var_1828 = wp::add(var_1827, var_1826);
        var_1829 = wp::extract(var_0, var_1828);
        var_1830 = wp::mul(var_1347, var_3);
        var_1831 = wp::add(var_1830, var_1826);
        var_1832 = wp::extract(var_0, var_1831);
        var_1833 = wp::mul(var_1829, var_1832);
        var_1834 = wp::mul(var_1826, var_3);
        var_1835 = wp::add(var_1834, var_1826);
        var_1836 = wp::extract(var_0, var_1835);
        var_1837 = wp::mul(var_1833, var_1836);
        var_1838 = wp::sub(var_1825, var_1837);
        var_1840 = wp::mul(var_1808, var_3);
        var_1841 = wp::add(var_1840, var_1839);
        var_1842 = wp::extract(var_0, var_1841);
        var_1843 = wp::mul(var_1347, var_3);
        var_1844 = wp::add(var_1843, var_1839);
        var_1845 = wp::extract(var_0, var_1844);
        var_1846 = wp::mul(var_1842, var_1845);
        var_1847 = wp::mul(var_1839, var_3);
        var_1848 = wp::add(var_1847, var_1839);
        var_1849 = wp::extract(var_0, var_1848);
        var_1850 = wp::mul(var_1846, var_1849);
        var_1851 = wp::sub(var_1838, var_1850);
        var_1853 = wp::mul(var_1808, var_3);
        var_1854 = wp::add(var_1853, var_1852);
        var_1855 = wp::extract(var_0, var_1854);
        var_1856 = wp::mul(var_1347, var_3);
        var_1857 = wp::add(var_1856, var_1852);
        var_1858 = wp::extract(var_0, var_1857);
        var_1859 = wp::mul(var_1855, var_1858);
        var_1860 = wp::mul(var_1852, var_3);
        var_1861 = wp::add(var_1860, var_1852);
        var_1862 = wp::extract(var_0, var_1861);
        var_1863 = wp::mul(var_1859, var_1862);
        var_1864 = wp::sub(var_1851, var_1863);
        var_1866 = wp::mul(var_1808, var_3);
        var_1867 = wp::add(var_1866, var_1865);
        var_1868 = wp::extract(var_0, var_1867);
        var_1869 = wp::mul(var_1347, var_3);
        var_1870 = wp::add(var_1869, var_1865);
        var_1871 = wp::extract(var_0, var_1870);
        var_1872 = wp::mul(var_1868, var_1871);
        var_1873 = wp::mul(var_1865, var_3);
        var_1874 = wp::add(var_1873, var_1865);
        var_1875 = wp::extract(var_0, var_1874);
        var_1876 = wp::mul(var_1872, var_1875);
        var_1877 = wp::sub(var_1864, var_1876);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_1878 = wp::mul(var_1877, var_1430);
        var_1879 = wp::mul(var_1808, var_3);
        var_1880 = wp::add(var_1879, var_1347);
        wp::assign_inplace(var_0, var_1880, var_1878);
    }
    var_1881 = wp::where(var_1809, var_1877, var_1806);
    var_1882 = wp::where(var_1809, var_1865, var_1807);
    // return a                                                                               <L 25>
    return var_0;
}


// <pointloom.kernels.algebra.rigid_solve.solve_factored>:1
static CUDA_CALLABLE wp::vec_t<6, wp::float64> solve_factored_0(
    wp::vec_t<36, wp::float64> var_a,
    wp::vec_t<6, wp::float64> var_b)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::vec_t<6, wp::float64> var_1;
    const wp::int32 var_2 = 0;
    wp::float64 var_3;
    const wp::int32 var_4 = 1;
    wp::float64 var_5;
    const wp::int32 var_6 = 0;
    const wp::int32 var_7 = 6;
    wp::int32 var_8;
    wp::int32 var_9;
    wp::float64 var_10;
    wp::float64 var_11;
    wp::float64 var_12;
    wp::float64 var_13;
    const wp::int32 var_14 = 2;
    wp::float64 var_15;
    const wp::int32 var_16 = 0;
    wp::int32 var_17;
    wp::int32 var_18;
    wp::float64 var_19;
    wp::float64 var_20;
    wp::float64 var_21;
    wp::float64 var_22;
    const wp::int32 var_23 = 1;
    wp::int32 var_24;
    wp::int32 var_25;
    wp::float64 var_26;
    wp::float64 var_27;
    wp::float64 var_28;
    wp::float64 var_29;
    const wp::int32 var_30 = 3;
    wp::float64 var_31;
    const wp::int32 var_32 = 0;
    wp::int32 var_33;
    wp::int32 var_34;
    wp::float64 var_35;
    wp::float64 var_36;
    wp::float64 var_37;
    wp::float64 var_38;
    const wp::int32 var_39 = 1;
    wp::int32 var_40;
    wp::int32 var_41;
    wp::float64 var_42;
    wp::float64 var_43;
    wp::float64 var_44;
    wp::float64 var_45;
    const wp::int32 var_46 = 2;
    wp::int32 var_47;
    wp::int32 var_48;
    wp::float64 var_49;
    wp::float64 var_50;
    wp::float64 var_51;
    wp::float64 var_52;
    const wp::int32 var_53 = 4;
    wp::float64 var_54;
    const wp::int32 var_55 = 0;
    wp::int32 var_56;
    wp::int32 var_57;
    wp::float64 var_58;
    wp::float64 var_59;
    wp::float64 var_60;
    wp::float64 var_61;
    const wp::int32 var_62 = 1;
    wp::int32 var_63;
    wp::int32 var_64;
    wp::float64 var_65;
    wp::float64 var_66;
    wp::float64 var_67;
    wp::float64 var_68;
    const wp::int32 var_69 = 2;
    wp::int32 var_70;
    wp::int32 var_71;
    wp::float64 var_72;
    wp::float64 var_73;
    wp::float64 var_74;
    wp::float64 var_75;
    const wp::int32 var_76 = 3;
    wp::int32 var_77;
    wp::int32 var_78;
    wp::float64 var_79;
    wp::float64 var_80;
    wp::float64 var_81;
    wp::float64 var_82;
    const wp::int32 var_83 = 5;
    wp::float64 var_84;
    const wp::int32 var_85 = 0;
    wp::int32 var_86;
    wp::int32 var_87;
    wp::float64 var_88;
    wp::float64 var_89;
    wp::float64 var_90;
    wp::float64 var_91;
    const wp::int32 var_92 = 1;
    wp::int32 var_93;
    wp::int32 var_94;
    wp::float64 var_95;
    wp::float64 var_96;
    wp::float64 var_97;
    wp::float64 var_98;
    const wp::int32 var_99 = 2;
    wp::int32 var_100;
    wp::int32 var_101;
    wp::float64 var_102;
    wp::float64 var_103;
    wp::float64 var_104;
    wp::float64 var_105;
    const wp::int32 var_106 = 3;
    wp::int32 var_107;
    wp::int32 var_108;
    wp::float64 var_109;
    wp::float64 var_110;
    wp::float64 var_111;
    wp::float64 var_112;
    const wp::int32 var_113 = 4;
    wp::int32 var_114;
    wp::int32 var_115;
    wp::float64 var_116;
    wp::float64 var_117;
    wp::float64 var_118;
    wp::float64 var_119;
    const wp::int32 var_120 = 0;
    wp::int32 var_121;
    wp::int32 var_122;
    wp::float64 var_123;
    wp::float64 var_124;
    bool var_125;
    wp::float64 var_126;
    wp::float64 var_127;
    wp::float64 var_128;
    wp::float64 var_129;
    bool var_130;
    wp::float64 var_131;
    const wp::int32 var_132 = 1;
    wp::int32 var_133;
    wp::int32 var_134;
    wp::float64 var_135;
    wp::float64 var_136;
    bool var_137;
    wp::float64 var_138;
    wp::float64 var_139;
    wp::float64 var_140;
    wp::float64 var_141;
    bool var_142;
    wp::float64 var_143;
    const wp::int32 var_144 = 2;
    wp::int32 var_145;
    wp::int32 var_146;
    wp::float64 var_147;
    wp::float64 var_148;
    bool var_149;
    wp::float64 var_150;
    wp::float64 var_151;
    wp::float64 var_152;
    wp::float64 var_153;
    bool var_154;
    wp::float64 var_155;
    const wp::int32 var_156 = 3;
    wp::int32 var_157;
    wp::int32 var_158;
    wp::float64 var_159;
    wp::float64 var_160;
    bool var_161;
    wp::float64 var_162;
    wp::float64 var_163;
    wp::float64 var_164;
    wp::float64 var_165;
    bool var_166;
    wp::float64 var_167;
    const wp::int32 var_168 = 4;
    wp::int32 var_169;
    wp::int32 var_170;
    wp::float64 var_171;
    wp::float64 var_172;
    bool var_173;
    wp::float64 var_174;
    wp::float64 var_175;
    wp::float64 var_176;
    wp::float64 var_177;
    bool var_178;
    wp::float64 var_179;
    const wp::int32 var_180 = 5;
    wp::int32 var_181;
    wp::int32 var_182;
    wp::float64 var_183;
    wp::float64 var_184;
    bool var_185;
    wp::float64 var_186;
    wp::float64 var_187;
    wp::float64 var_188;
    wp::float64 var_189;
    bool var_190;
    wp::float64 var_191;
    const wp::int32 var_192 = 0;
    const wp::int32 var_193 = 1;
    wp::int32 var_194;
    wp::int32 var_195;
    wp::float64 var_196;
    const wp::int32 var_197 = 0;
    bool var_198;
    wp::int32 var_199;
    wp::int32 var_200;
    wp::float64 var_201;
    wp::float64 var_202;
    wp::float64 var_203;
    wp::float64 var_204;
    wp::float64 var_205;
    const wp::int32 var_206 = 1;
    bool var_207;
    wp::int32 var_208;
    wp::int32 var_209;
    wp::float64 var_210;
    wp::float64 var_211;
    wp::float64 var_212;
    wp::float64 var_213;
    wp::float64 var_214;
    const wp::int32 var_215 = 2;
    bool var_216;
    wp::int32 var_217;
    wp::int32 var_218;
    wp::float64 var_219;
    wp::float64 var_220;
    wp::float64 var_221;
    wp::float64 var_222;
    wp::float64 var_223;
    const wp::int32 var_224 = 3;
    bool var_225;
    wp::int32 var_226;
    wp::int32 var_227;
    wp::float64 var_228;
    wp::float64 var_229;
    wp::float64 var_230;
    wp::float64 var_231;
    wp::float64 var_232;
    const wp::int32 var_233 = 4;
    bool var_234;
    wp::int32 var_235;
    wp::int32 var_236;
    wp::float64 var_237;
    wp::float64 var_238;
    wp::float64 var_239;
    wp::float64 var_240;
    wp::float64 var_241;
    const wp::int32 var_242 = 5;
    bool var_243;
    wp::int32 var_244;
    wp::int32 var_245;
    wp::float64 var_246;
    wp::float64 var_247;
    wp::float64 var_248;
    wp::float64 var_249;
    wp::float64 var_250;
    const wp::int32 var_251 = 1;
    const wp::int32 var_252 = 1;
    wp::int32 var_253;
    wp::int32 var_254;
    wp::float64 var_255;
    const wp::int32 var_256 = 0;
    bool var_257;
    wp::int32 var_258;
    wp::int32 var_259;
    wp::float64 var_260;
    wp::float64 var_261;
    wp::float64 var_262;
    wp::float64 var_263;
    wp::float64 var_264;
    const wp::int32 var_265 = 1;
    bool var_266;
    wp::int32 var_267;
    wp::int32 var_268;
    wp::float64 var_269;
    wp::float64 var_270;
    wp::float64 var_271;
    wp::float64 var_272;
    wp::float64 var_273;
    const wp::int32 var_274 = 2;
    bool var_275;
    wp::int32 var_276;
    wp::int32 var_277;
    wp::float64 var_278;
    wp::float64 var_279;
    wp::float64 var_280;
    wp::float64 var_281;
    wp::float64 var_282;
    const wp::int32 var_283 = 3;
    bool var_284;
    wp::int32 var_285;
    wp::int32 var_286;
    wp::float64 var_287;
    wp::float64 var_288;
    wp::float64 var_289;
    wp::float64 var_290;
    wp::float64 var_291;
    const wp::int32 var_292 = 4;
    bool var_293;
    wp::int32 var_294;
    wp::int32 var_295;
    wp::float64 var_296;
    wp::float64 var_297;
    wp::float64 var_298;
    wp::float64 var_299;
    wp::float64 var_300;
    const wp::int32 var_301 = 5;
    bool var_302;
    wp::int32 var_303;
    wp::int32 var_304;
    wp::float64 var_305;
    wp::float64 var_306;
    wp::float64 var_307;
    wp::float64 var_308;
    wp::float64 var_309;
    const wp::int32 var_310 = 2;
    const wp::int32 var_311 = 1;
    wp::int32 var_312;
    wp::int32 var_313;
    wp::float64 var_314;
    const wp::int32 var_315 = 0;
    bool var_316;
    wp::int32 var_317;
    wp::int32 var_318;
    wp::float64 var_319;
    wp::float64 var_320;
    wp::float64 var_321;
    wp::float64 var_322;
    wp::float64 var_323;
    const wp::int32 var_324 = 1;
    bool var_325;
    wp::int32 var_326;
    wp::int32 var_327;
    wp::float64 var_328;
    wp::float64 var_329;
    wp::float64 var_330;
    wp::float64 var_331;
    wp::float64 var_332;
    const wp::int32 var_333 = 2;
    bool var_334;
    wp::int32 var_335;
    wp::int32 var_336;
    wp::float64 var_337;
    wp::float64 var_338;
    wp::float64 var_339;
    wp::float64 var_340;
    wp::float64 var_341;
    const wp::int32 var_342 = 3;
    bool var_343;
    wp::int32 var_344;
    wp::int32 var_345;
    wp::float64 var_346;
    wp::float64 var_347;
    wp::float64 var_348;
    wp::float64 var_349;
    wp::float64 var_350;
    const wp::int32 var_351 = 4;
    bool var_352;
    wp::int32 var_353;
    wp::int32 var_354;
    wp::float64 var_355;
    wp::float64 var_356;
    wp::float64 var_357;
    wp::float64 var_358;
    wp::float64 var_359;
    const wp::int32 var_360 = 5;
    bool var_361;
    wp::int32 var_362;
    wp::int32 var_363;
    wp::float64 var_364;
    wp::float64 var_365;
    wp::float64 var_366;
    wp::float64 var_367;
    wp::float64 var_368;
    const wp::int32 var_369 = 3;
    const wp::int32 var_370 = 1;
    wp::int32 var_371;
    wp::int32 var_372;
    wp::float64 var_373;
    const wp::int32 var_374 = 0;
    bool var_375;
    wp::int32 var_376;
    wp::int32 var_377;
    wp::float64 var_378;
    wp::float64 var_379;
    wp::float64 var_380;
    wp::float64 var_381;
    wp::float64 var_382;
    const wp::int32 var_383 = 1;
    bool var_384;
    wp::int32 var_385;
    wp::int32 var_386;
    wp::float64 var_387;
    wp::float64 var_388;
    wp::float64 var_389;
    wp::float64 var_390;
    wp::float64 var_391;
    const wp::int32 var_392 = 2;
    bool var_393;
    wp::int32 var_394;
    wp::int32 var_395;
    wp::float64 var_396;
    wp::float64 var_397;
    wp::float64 var_398;
    wp::float64 var_399;
    wp::float64 var_400;
    const wp::int32 var_401 = 3;
    bool var_402;
    wp::int32 var_403;
    wp::int32 var_404;
    wp::float64 var_405;
    wp::float64 var_406;
    wp::float64 var_407;
    wp::float64 var_408;
    wp::float64 var_409;
    const wp::int32 var_410 = 4;
    bool var_411;
    wp::int32 var_412;
    wp::int32 var_413;
    wp::float64 var_414;
    wp::float64 var_415;
    wp::float64 var_416;
    wp::float64 var_417;
    wp::float64 var_418;
    const wp::int32 var_419 = 5;
    bool var_420;
    wp::int32 var_421;
    wp::int32 var_422;
    wp::float64 var_423;
    wp::float64 var_424;
    wp::float64 var_425;
    wp::float64 var_426;
    wp::float64 var_427;
    const wp::int32 var_428 = 4;
    const wp::int32 var_429 = 1;
    wp::int32 var_430;
    wp::int32 var_431;
    wp::float64 var_432;
    const wp::int32 var_433 = 0;
    bool var_434;
    wp::int32 var_435;
    wp::int32 var_436;
    wp::float64 var_437;
    wp::float64 var_438;
    wp::float64 var_439;
    wp::float64 var_440;
    wp::float64 var_441;
    const wp::int32 var_442 = 1;
    bool var_443;
    wp::int32 var_444;
    wp::int32 var_445;
    wp::float64 var_446;
    wp::float64 var_447;
    wp::float64 var_448;
    wp::float64 var_449;
    wp::float64 var_450;
    const wp::int32 var_451 = 2;
    bool var_452;
    wp::int32 var_453;
    wp::int32 var_454;
    wp::float64 var_455;
    wp::float64 var_456;
    wp::float64 var_457;
    wp::float64 var_458;
    wp::float64 var_459;
    const wp::int32 var_460 = 3;
    bool var_461;
    wp::int32 var_462;
    wp::int32 var_463;
    wp::float64 var_464;
    wp::float64 var_465;
    wp::float64 var_466;
    wp::float64 var_467;
    wp::float64 var_468;
    const wp::int32 var_469 = 4;
    bool var_470;
    wp::int32 var_471;
    wp::int32 var_472;
    wp::float64 var_473;
    wp::float64 var_474;
    wp::float64 var_475;
    wp::float64 var_476;
    wp::float64 var_477;
    const wp::int32 var_478 = 5;
    bool var_479;
    wp::int32 var_480;
    wp::int32 var_481;
    wp::float64 var_482;
    wp::float64 var_483;
    wp::float64 var_484;
    wp::float64 var_485;
    wp::float64 var_486;
    const wp::int32 var_487 = 5;
    const wp::int32 var_488 = 1;
    wp::int32 var_489;
    wp::int32 var_490;
    wp::float64 var_491;
    const wp::int32 var_492 = 0;
    bool var_493;
    wp::int32 var_494;
    wp::int32 var_495;
    wp::float64 var_496;
    wp::float64 var_497;
    wp::float64 var_498;
    wp::float64 var_499;
    wp::float64 var_500;
    const wp::int32 var_501 = 1;
    bool var_502;
    wp::int32 var_503;
    wp::int32 var_504;
    wp::float64 var_505;
    wp::float64 var_506;
    wp::float64 var_507;
    wp::float64 var_508;
    wp::float64 var_509;
    const wp::int32 var_510 = 2;
    bool var_511;
    wp::int32 var_512;
    wp::int32 var_513;
    wp::float64 var_514;
    wp::float64 var_515;
    wp::float64 var_516;
    wp::float64 var_517;
    wp::float64 var_518;
    const wp::int32 var_519 = 3;
    bool var_520;
    wp::int32 var_521;
    wp::int32 var_522;
    wp::float64 var_523;
    wp::float64 var_524;
    wp::float64 var_525;
    wp::float64 var_526;
    wp::float64 var_527;
    const wp::int32 var_528 = 4;
    bool var_529;
    wp::int32 var_530;
    wp::int32 var_531;
    wp::float64 var_532;
    wp::float64 var_533;
    wp::float64 var_534;
    wp::float64 var_535;
    wp::float64 var_536;
    const wp::int32 var_537 = 5;
    bool var_538;
    wp::int32 var_539;
    wp::int32 var_540;
    wp::float64 var_541;
    wp::float64 var_542;
    wp::float64 var_543;
    wp::float64 var_544;
    wp::float64 var_545;
    //---------
    // forward
    // def solve_factored(a, b):                                                              <L 1>
    // x = vec6d(float64(0.0))                                                                <L 3>
    var_0 = 0.0;
    var_1 = wp::vec_t<6, wp::float64>(var_0);
    // for j in range(6):                                                                     <L 4>
    // v = b[j]                                                                               <L 5>
    var_3 = wp::extract(var_b, var_2);
    // for k in range(j):                                                                     <L 6>
    // x[j] = v                                                                               <L 8>
    wp::assign_inplace(var_1, var_2, var_3);
    // v = b[j]                                                                               <L 5>
    var_5 = wp::extract(var_b, var_4);
    // for k in range(j):                                                                     <L 6>
    // v -= a[j * UNKNOWNS + k] * x[k]                                                        <L 7>
    var_8 = wp::mul(var_4, var_7);
    var_9 = wp::add(var_8, var_6);
    var_10 = wp::extract(var_a, var_9);
    var_11 = wp::extract(var_1, var_6);
    var_12 = wp::mul(var_10, var_11);
    var_13 = wp::sub(var_5, var_12);
    // x[j] = v                                                                               <L 8>
    wp::assign_inplace(var_1, var_4, var_13);
    // v = b[j]                                                                               <L 5>
    var_15 = wp::extract(var_b, var_14);
    // for k in range(j):                                                                     <L 6>
    // v -= a[j * UNKNOWNS + k] * x[k]                                                        <L 7>
    var_17 = wp::mul(var_14, var_7);
    var_18 = wp::add(var_17, var_16);
    var_19 = wp::extract(var_a, var_18);
    var_20 = wp::extract(var_1, var_16);
    var_21 = wp::mul(var_19, var_20);
    var_22 = wp::sub(var_15, var_21);
    var_24 = wp::mul(var_14, var_7);
    var_25 = wp::add(var_24, var_23);
    var_26 = wp::extract(var_a, var_25);
    var_27 = wp::extract(var_1, var_23);
    var_28 = wp::mul(var_26, var_27);
    var_29 = wp::sub(var_22, var_28);
    // x[j] = v                                                                               <L 8>
    wp::assign_inplace(var_1, var_14, var_29);
    // v = b[j]                                                                               <L 5>
    var_31 = wp::extract(var_b, var_30);
    // for k in range(j):                                                                     <L 6>
    // v -= a[j * UNKNOWNS + k] * x[k]                                                        <L 7>
    var_33 = wp::mul(var_30, var_7);
    var_34 = wp::add(var_33, var_32);
    var_35 = wp::extract(var_a, var_34);
    var_36 = wp::extract(var_1, var_32);
    var_37 = wp::mul(var_35, var_36);
    var_38 = wp::sub(var_31, var_37);
    var_40 = wp::mul(var_30, var_7);
    var_41 = wp::add(var_40, var_39);
    var_42 = wp::extract(var_a, var_41);
    var_43 = wp::extract(var_1, var_39);
    var_44 = wp::mul(var_42, var_43);
    var_45 = wp::sub(var_38, var_44);
    var_47 = wp::mul(var_30, var_7);
    var_48 = wp::add(var_47, var_46);
    var_49 = wp::extract(var_a, var_48);
    var_50 = wp::extract(var_1, var_46);
    var_51 = wp::mul(var_49, var_50);
    var_52 = wp::sub(var_45, var_51);
    // x[j] = v                                                                               <L 8>
    wp::assign_inplace(var_1, var_30, var_52);
    // v = b[j]                                                                               <L 5>
    var_54 = wp::extract(var_b, var_53);
    // for k in range(j):                                                                     <L 6>
    // v -= a[j * UNKNOWNS + k] * x[k]                                                        <L 7>
    var_56 = wp::mul(var_53, var_7);
    var_57 = wp::add(var_56, var_55);
    var_58 = wp::extract(var_a, var_57);
    var_59 = wp::extract(var_1, var_55);
    var_60 = wp::mul(var_58, var_59);
    var_61 = wp::sub(var_54, var_60);
    var_63 = wp::mul(var_53, var_7);
    var_64 = wp::add(var_63, var_62);
    var_65 = wp::extract(var_a, var_64);
    var_66 = wp::extract(var_1, var_62);
    var_67 = wp::mul(var_65, var_66);
    var_68 = wp::sub(var_61, var_67);
    var_70 = wp::mul(var_53, var_7);
    var_71 = wp::add(var_70, var_69);
    var_72 = wp::extract(var_a, var_71);
    var_73 = wp::extract(var_1, var_69);
    var_74 = wp::mul(var_72, var_73);
    var_75 = wp::sub(var_68, var_74);
    var_77 = wp::mul(var_53, var_7);
    var_78 = wp::add(var_77, var_76);
    var_79 = wp::extract(var_a, var_78);
    var_80 = wp::extract(var_1, var_76);
    var_81 = wp::mul(var_79, var_80);
    var_82 = wp::sub(var_75, var_81);
    // x[j] = v                                                                               <L 8>
    wp::assign_inplace(var_1, var_53, var_82);
    // v = b[j]                                                                               <L 5>
    var_84 = wp::extract(var_b, var_83);
    // for k in range(j):                                                                     <L 6>
    // v -= a[j * UNKNOWNS + k] * x[k]                                                        <L 7>
    var_86 = wp::mul(var_83, var_7);
    var_87 = wp::add(var_86, var_85);
    var_88 = wp::extract(var_a, var_87);
    var_89 = wp::extract(var_1, var_85);
    var_90 = wp::mul(var_88, var_89);
    var_91 = wp::sub(var_84, var_90);
    var_93 = wp::mul(var_83, var_7);
    var_94 = wp::add(var_93, var_92);
    var_95 = wp::extract(var_a, var_94);
    var_96 = wp::extract(var_1, var_92);
    var_97 = wp::mul(var_95, var_96);
    var_98 = wp::sub(var_91, var_97);
    var_100 = wp::mul(var_83, var_7);
    var_101 = wp::add(var_100, var_99);
    var_102 = wp::extract(var_a, var_101);
    var_103 = wp::extract(var_1, var_99);
    var_104 = wp::mul(var_102, var_103);
    var_105 = wp::sub(var_98, var_104);
    var_107 = wp::mul(var_83, var_7);
    var_108 = wp::add(var_107, var_106);
    var_109 = wp::extract(var_a, var_108);
    var_110 = wp::extract(var_1, var_106);
    var_111 = wp::mul(var_109, var_110);
    var_112 = wp::sub(var_105, var_111);
    var_114 = wp::mul(var_83, var_7);
    var_115 = wp::add(var_114, var_113);
    var_116 = wp::extract(var_a, var_115);
    var_117 = wp::extract(var_1, var_113);
    var_118 = wp::mul(var_116, var_117);
    var_119 = wp::sub(var_112, var_118);
    // x[j] = v                                                                               <L 8>
    wp::assign_inplace(var_1, var_83, var_119);
    // for j in range(6):                                                                     <L 9>
    // pivot = a[j * UNKNOWNS + j]                                                            <L 10>
    var_121 = wp::mul(var_120, var_7);
    var_122 = wp::add(var_121, var_120);
    var_123 = wp::extract(var_a, var_122);
    // if pivot > float64(0.0):                                                               <L 11>
    var_124 = 0.0;
    var_125 = (var_123 > var_124);
    if (var_125) {
        // x[j] = x[j] / pivot                                                                <L 12>
        var_126 = wp::extract(var_1, var_120);
        var_127 = wp::div(var_126, var_123);
        wp::assign_inplace(var_1, var_120, var_127);
    }
    if (!var_125) {
        // elif pivot - pivot == float64(0.0):                                                <L 13>
        var_128 = wp::sub(var_123, var_123);
        var_129 = 0.0;
        var_130 = (var_128 == var_129);
        if (var_130) {
            // x[j] = float64(0.0)                                                            <L 14>
            var_131 = 0.0;
            wp::assign_inplace(var_1, var_120, var_131);
        }
        if (!var_130) {
            // x[j] = pivot                                                                   <L 16>
            wp::assign_inplace(var_1, var_120, var_123);
        }
    }
    // pivot = a[j * UNKNOWNS + j]                                                            <L 10>
    var_133 = wp::mul(var_132, var_7);
    var_134 = wp::add(var_133, var_132);
    var_135 = wp::extract(var_a, var_134);
    // if pivot > float64(0.0):                                                               <L 11>
    var_136 = 0.0;
    var_137 = (var_135 > var_136);
    if (var_137) {
        // x[j] = x[j] / pivot                                                                <L 12>
        var_138 = wp::extract(var_1, var_132);
        var_139 = wp::div(var_138, var_135);
        wp::assign_inplace(var_1, var_132, var_139);
    }
    if (!var_137) {
        // elif pivot - pivot == float64(0.0):                                                <L 13>
        var_140 = wp::sub(var_135, var_135);
        var_141 = 0.0;
        var_142 = (var_140 == var_141);
        if (var_142) {
            // x[j] = float64(0.0)                                                            <L 14>
            var_143 = 0.0;
            wp::assign_inplace(var_1, var_132, var_143);
        }
        if (!var_142) {
            // x[j] = pivot                                                                   <L 16>
            wp::assign_inplace(var_1, var_132, var_135);
        }
    }
    // pivot = a[j * UNKNOWNS + j]                                                            <L 10>
    var_145 = wp::mul(var_144, var_7);
    var_146 = wp::add(var_145, var_144);
    var_147 = wp::extract(var_a, var_146);
    // if pivot > float64(0.0):                                                               <L 11>
    var_148 = 0.0;
    var_149 = (var_147 > var_148);
    if (var_149) {
        // x[j] = x[j] / pivot                                                                <L 12>
        var_150 = wp::extract(var_1, var_144);
        var_151 = wp::div(var_150, var_147);
        wp::assign_inplace(var_1, var_144, var_151);
    }
    if (!var_149) {
        // elif pivot - pivot == float64(0.0):                                                <L 13>
        var_152 = wp::sub(var_147, var_147);
        var_153 = 0.0;
        var_154 = (var_152 == var_153);
        if (var_154) {
            // x[j] = float64(0.0)                                                            <L 14>
            var_155 = 0.0;
            wp::assign_inplace(var_1, var_144, var_155);
        }
        if (!var_154) {
            // x[j] = pivot                                                                   <L 16>
            wp::assign_inplace(var_1, var_144, var_147);
        }
    }
    // pivot = a[j * UNKNOWNS + j]                                                            <L 10>
    var_157 = wp::mul(var_156, var_7);
    var_158 = wp::add(var_157, var_156);
    var_159 = wp::extract(var_a, var_158);
    // if pivot > float64(0.0):                                                               <L 11>
    var_160 = 0.0;
    var_161 = (var_159 > var_160);
    if (var_161) {
        // x[j] = x[j] / pivot                                                                <L 12>
        var_162 = wp::extract(var_1, var_156);
        var_163 = wp::div(var_162, var_159);
        wp::assign_inplace(var_1, var_156, var_163);
    }
    if (!var_161) {
        // elif pivot - pivot == float64(0.0):                                                <L 13>
        var_164 = wp::sub(var_159, var_159);
        var_165 = 0.0;
        var_166 = (var_164 == var_165);
        if (var_166) {
            // x[j] = float64(0.0)                                                            <L 14>
            var_167 = 0.0;
            wp::assign_inplace(var_1, var_156, var_167);
        }
        if (!var_166) {
            // x[j] = pivot                                                                   <L 16>
            wp::assign_inplace(var_1, var_156, var_159);
        }
    }
    // pivot = a[j * UNKNOWNS + j]                                                            <L 10>
    var_169 = wp::mul(var_168, var_7);
    var_170 = wp::add(var_169, var_168);
    var_171 = wp::extract(var_a, var_170);
    // if pivot > float64(0.0):                                                               <L 11>
    var_172 = 0.0;
    var_173 = (var_171 > var_172);
    if (var_173) {
        // x[j] = x[j] / pivot                                                                <L 12>
        var_174 = wp::extract(var_1, var_168);
        var_175 = wp::div(var_174, var_171);
        wp::assign_inplace(var_1, var_168, var_175);
    }
    if (!var_173) {
        // elif pivot - pivot == float64(0.0):                                                <L 13>
        var_176 = wp::sub(var_171, var_171);
        var_177 = 0.0;
        var_178 = (var_176 == var_177);
        if (var_178) {
            // x[j] = float64(0.0)                                                            <L 14>
            var_179 = 0.0;
            wp::assign_inplace(var_1, var_168, var_179);
        }
        if (!var_178) {
            // x[j] = pivot                                                                   <L 16>
            wp::assign_inplace(var_1, var_168, var_171);
        }
    }
    // pivot = a[j * UNKNOWNS + j]                                                            <L 10>
    var_181 = wp::mul(var_180, var_7);
    var_182 = wp::add(var_181, var_180);
    var_183 = wp::extract(var_a, var_182);
    // if pivot > float64(0.0):                                                               <L 11>
    var_184 = 0.0;
    var_185 = (var_183 > var_184);
    if (var_185) {
        // x[j] = x[j] / pivot                                                                <L 12>
        var_186 = wp::extract(var_1, var_180);
        var_187 = wp::div(var_186, var_183);
        wp::assign_inplace(var_1, var_180, var_187);
    }
    if (!var_185) {
        // elif pivot - pivot == float64(0.0):                                                <L 13>
        var_188 = wp::sub(var_183, var_183);
        var_189 = 0.0;
        var_190 = (var_188 == var_189);
        if (var_190) {
            // x[j] = float64(0.0)                                                            <L 14>
            var_191 = 0.0;
            wp::assign_inplace(var_1, var_180, var_191);
        }
        if (!var_190) {
            // x[j] = pivot                                                                   <L 16>
            wp::assign_inplace(var_1, var_180, var_183);
        }
    }
    // for step in range(6):                                                                  <L 17>
    // j = UNKNOWNS - 1 - step                                                                <L 18>
    var_194 = wp::sub(var_7, var_193);
    var_195 = wp::sub(var_194, var_192);
    // v = x[j]                                                                               <L 19>
    var_196 = wp::extract(var_1, var_195);
    // for k in range(6):                                                                     <L 20>
    // if k > j:                                                                              <L 21>
    var_198 = (var_197 > var_195);
    if (var_198) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_199 = wp::mul(var_197, var_7);
        var_200 = wp::add(var_199, var_195);
        var_201 = wp::extract(var_a, var_200);
        var_202 = wp::extract(var_1, var_197);
        var_203 = wp::mul(var_201, var_202);
        var_204 = wp::sub(var_196, var_203);
    }
    var_205 = wp::where(var_198, var_204, var_196);
    // if k > j:                                                                              <L 21>
    var_207 = (var_206 > var_195);
    if (var_207) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_208 = wp::mul(var_206, var_7);
        var_209 = wp::add(var_208, var_195);
        var_210 = wp::extract(var_a, var_209);
        var_211 = wp::extract(var_1, var_206);
        var_212 = wp::mul(var_210, var_211);
        var_213 = wp::sub(var_205, var_212);
    }
    var_214 = wp::where(var_207, var_213, var_205);
    // if k > j:                                                                              <L 21>
    var_216 = (var_215 > var_195);
    if (var_216) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_217 = wp::mul(var_215, var_7);
        var_218 = wp::add(var_217, var_195);
        var_219 = wp::extract(var_a, var_218);
        var_220 = wp::extract(var_1, var_215);
        var_221 = wp::mul(var_219, var_220);
        var_222 = wp::sub(var_214, var_221);
    }
    var_223 = wp::where(var_216, var_222, var_214);
    // if k > j:                                                                              <L 21>
    var_225 = (var_224 > var_195);
    if (var_225) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_226 = wp::mul(var_224, var_7);
        var_227 = wp::add(var_226, var_195);
        var_228 = wp::extract(var_a, var_227);
        var_229 = wp::extract(var_1, var_224);
        var_230 = wp::mul(var_228, var_229);
        var_231 = wp::sub(var_223, var_230);
    }
    var_232 = wp::where(var_225, var_231, var_223);
    // if k > j:                                                                              <L 21>
    var_234 = (var_233 > var_195);
    if (var_234) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_235 = wp::mul(var_233, var_7);
        var_236 = wp::add(var_235, var_195);
        var_237 = wp::extract(var_a, var_236);
        var_238 = wp::extract(var_1, var_233);
        var_239 = wp::mul(var_237, var_238);
        var_240 = wp::sub(var_232, var_239);
    }
    var_241 = wp::where(var_234, var_240, var_232);
    // if k > j:                                                                              <L 21>
    var_243 = (var_242 > var_195);
    if (var_243) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_244 = wp::mul(var_242, var_7);
        var_245 = wp::add(var_244, var_195);
        var_246 = wp::extract(var_a, var_245);
        var_247 = wp::extract(var_1, var_242);
        var_248 = wp::mul(var_246, var_247);
        var_249 = wp::sub(var_241, var_248);
    }
    var_250 = wp::where(var_243, var_249, var_241);
    // x[j] = v                                                                               <L 23>
    wp::assign_inplace(var_1, var_195, var_250);
    // j = UNKNOWNS - 1 - step                                                                <L 18>
    var_253 = wp::sub(var_7, var_252);
    var_254 = wp::sub(var_253, var_251);
    // v = x[j]                                                                               <L 19>
    var_255 = wp::extract(var_1, var_254);
    // for k in range(6):                                                                     <L 20>
    // if k > j:                                                                              <L 21>
    var_257 = (var_256 > var_254);
    if (var_257) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_258 = wp::mul(var_256, var_7);
        var_259 = wp::add(var_258, var_254);
        var_260 = wp::extract(var_a, var_259);
        var_261 = wp::extract(var_1, var_256);
        var_262 = wp::mul(var_260, var_261);
        var_263 = wp::sub(var_255, var_262);
    }
    var_264 = wp::where(var_257, var_263, var_255);
    // if k > j:                                                                              <L 21>
    var_266 = (var_265 > var_254);
    if (var_266) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_267 = wp::mul(var_265, var_7);
        var_268 = wp::add(var_267, var_254);
        var_269 = wp::extract(var_a, var_268);
        var_270 = wp::extract(var_1, var_265);
        var_271 = wp::mul(var_269, var_270);
        var_272 = wp::sub(var_264, var_271);
    }
    var_273 = wp::where(var_266, var_272, var_264);
    // if k > j:                                                                              <L 21>
    var_275 = (var_274 > var_254);
    if (var_275) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_276 = wp::mul(var_274, var_7);
        var_277 = wp::add(var_276, var_254);
        var_278 = wp::extract(var_a, var_277);
        var_279 = wp::extract(var_1, var_274);
        var_280 = wp::mul(var_278, var_279);
        var_281 = wp::sub(var_273, var_280);
    }
    var_282 = wp::where(var_275, var_281, var_273);
    // if k > j:                                                                              <L 21>
    var_284 = (var_283 > var_254);
    if (var_284) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_285 = wp::mul(var_283, var_7);
        var_286 = wp::add(var_285, var_254);
        var_287 = wp::extract(var_a, var_286);
        var_288 = wp::extract(var_1, var_283);
        var_289 = wp::mul(var_287, var_288);
        var_290 = wp::sub(var_282, var_289);
    }
    var_291 = wp::where(var_284, var_290, var_282);
    // if k > j:                                                                              <L 21>
    var_293 = (var_292 > var_254);
    if (var_293) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_294 = wp::mul(var_292, var_7);
        var_295 = wp::add(var_294, var_254);
        var_296 = wp::extract(var_a, var_295);
        var_297 = wp::extract(var_1, var_292);
        var_298 = wp::mul(var_296, var_297);
        var_299 = wp::sub(var_291, var_298);
    }
    var_300 = wp::where(var_293, var_299, var_291);
    // if k > j:                                                                              <L 21>
    var_302 = (var_301 > var_254);
    if (var_302) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_303 = wp::mul(var_301, var_7);
        var_304 = wp::add(var_303, var_254);
        var_305 = wp::extract(var_a, var_304);
        var_306 = wp::extract(var_1, var_301);
        var_307 = wp::mul(var_305, var_306);
        var_308 = wp::sub(var_300, var_307);
    }
    var_309 = wp::where(var_302, var_308, var_300);
    // x[j] = v                                                                               <L 23>
    wp::assign_inplace(var_1, var_254, var_309);
    // j = UNKNOWNS - 1 - step                                                                <L 18>
    var_312 = wp::sub(var_7, var_311);
    var_313 = wp::sub(var_312, var_310);
    // v = x[j]                                                                               <L 19>
    var_314 = wp::extract(var_1, var_313);
    // for k in range(6):                                                                     <L 20>
    // if k > j:                                                                              <L 21>
    var_316 = (var_315 > var_313);
    if (var_316) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_317 = wp::mul(var_315, var_7);
        var_318 = wp::add(var_317, var_313);
        var_319 = wp::extract(var_a, var_318);
        var_320 = wp::extract(var_1, var_315);
        var_321 = wp::mul(var_319, var_320);
        var_322 = wp::sub(var_314, var_321);
    }
    var_323 = wp::where(var_316, var_322, var_314);
    // if k > j:                                                                              <L 21>
    var_325 = (var_324 > var_313);
    if (var_325) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_326 = wp::mul(var_324, var_7);
        var_327 = wp::add(var_326, var_313);
        var_328 = wp::extract(var_a, var_327);
        var_329 = wp::extract(var_1, var_324);
        var_330 = wp::mul(var_328, var_329);
        var_331 = wp::sub(var_323, var_330);
    }
    var_332 = wp::where(var_325, var_331, var_323);
    // if k > j:                                                                              <L 21>
    var_334 = (var_333 > var_313);
    if (var_334) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_335 = wp::mul(var_333, var_7);
        var_336 = wp::add(var_335, var_313);
        var_337 = wp::extract(var_a, var_336);
        var_338 = wp::extract(var_1, var_333);
        var_339 = wp::mul(var_337, var_338);
        var_340 = wp::sub(var_332, var_339);
    }
    var_341 = wp::where(var_334, var_340, var_332);
    // if k > j:                                                                              <L 21>
    var_343 = (var_342 > var_313);
    if (var_343) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_344 = wp::mul(var_342, var_7);
        var_345 = wp::add(var_344, var_313);
        var_346 = wp::extract(var_a, var_345);
        var_347 = wp::extract(var_1, var_342);
        var_348 = wp::mul(var_346, var_347);
        var_349 = wp::sub(var_341, var_348);
    }
    var_350 = wp::where(var_343, var_349, var_341);
    // if k > j:                                                                              <L 21>
    var_352 = (var_351 > var_313);
    if (var_352) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_353 = wp::mul(var_351, var_7);
        var_354 = wp::add(var_353, var_313);
        var_355 = wp::extract(var_a, var_354);
        var_356 = wp::extract(var_1, var_351);
        var_357 = wp::mul(var_355, var_356);
        var_358 = wp::sub(var_350, var_357);
    }
    var_359 = wp::where(var_352, var_358, var_350);
    // if k > j:                                                                              <L 21>
    var_361 = (var_360 > var_313);
    if (var_361) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_362 = wp::mul(var_360, var_7);
        var_363 = wp::add(var_362, var_313);
        var_364 = wp::extract(var_a, var_363);
        var_365 = wp::extract(var_1, var_360);
        var_366 = wp::mul(var_364, var_365);
        var_367 = wp::sub(var_359, var_366);
    }
    var_368 = wp::where(var_361, var_367, var_359);
    // x[j] = v                                                                               <L 23>
    wp::assign_inplace(var_1, var_313, var_368);
    // j = UNKNOWNS - 1 - step                                                                <L 18>
    var_371 = wp::sub(var_7, var_370);
    var_372 = wp::sub(var_371, var_369);
    // v = x[j]                                                                               <L 19>
    var_373 = wp::extract(var_1, var_372);
    // for k in range(6):                                                                     <L 20>
    // if k > j:                                                                              <L 21>
    var_375 = (var_374 > var_372);
    if (var_375) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_376 = wp::mul(var_374, var_7);
        var_377 = wp::add(var_376, var_372);
        var_378 = wp::extract(var_a, var_377);
        var_379 = wp::extract(var_1, var_374);
        var_380 = wp::mul(var_378, var_379);
        var_381 = wp::sub(var_373, var_380);
    }
    var_382 = wp::where(var_375, var_381, var_373);
    // if k > j:                                                                              <L 21>
    var_384 = (var_383 > var_372);
    if (var_384) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_385 = wp::mul(var_383, var_7);
        var_386 = wp::add(var_385, var_372);
        var_387 = wp::extract(var_a, var_386);
        var_388 = wp::extract(var_1, var_383);
        var_389 = wp::mul(var_387, var_388);
        var_390 = wp::sub(var_382, var_389);
    }
    var_391 = wp::where(var_384, var_390, var_382);
    // if k > j:                                                                              <L 21>
    var_393 = (var_392 > var_372);
    if (var_393) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_394 = wp::mul(var_392, var_7);
        var_395 = wp::add(var_394, var_372);
        var_396 = wp::extract(var_a, var_395);
        var_397 = wp::extract(var_1, var_392);
        var_398 = wp::mul(var_396, var_397);
        var_399 = wp::sub(var_391, var_398);
    }
    var_400 = wp::where(var_393, var_399, var_391);
    // if k > j:                                                                              <L 21>
    var_402 = (var_401 > var_372);
    if (var_402) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_403 = wp::mul(var_401, var_7);
        var_404 = wp::add(var_403, var_372);
        var_405 = wp::extract(var_a, var_404);
        var_406 = wp::extract(var_1, var_401);
        var_407 = wp::mul(var_405, var_406);
        var_408 = wp::sub(var_400, var_407);
    }
    var_409 = wp::where(var_402, var_408, var_400);
    // if k > j:                                                                              <L 21>
    var_411 = (var_410 > var_372);
    if (var_411) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_412 = wp::mul(var_410, var_7);
        var_413 = wp::add(var_412, var_372);
        var_414 = wp::extract(var_a, var_413);
        var_415 = wp::extract(var_1, var_410);
        var_416 = wp::mul(var_414, var_415);
        var_417 = wp::sub(var_409, var_416);
    }
    var_418 = wp::where(var_411, var_417, var_409);
    // if k > j:                                                                              <L 21>
    var_420 = (var_419 > var_372);
    if (var_420) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_421 = wp::mul(var_419, var_7);
        var_422 = wp::add(var_421, var_372);
        var_423 = wp::extract(var_a, var_422);
        var_424 = wp::extract(var_1, var_419);
        var_425 = wp::mul(var_423, var_424);
        var_426 = wp::sub(var_418, var_425);
    }
    var_427 = wp::where(var_420, var_426, var_418);
    // x[j] = v                                                                               <L 23>
    wp::assign_inplace(var_1, var_372, var_427);
    // j = UNKNOWNS - 1 - step                                                                <L 18>
    var_430 = wp::sub(var_7, var_429);
    var_431 = wp::sub(var_430, var_428);
    // v = x[j]                                                                               <L 19>
    var_432 = wp::extract(var_1, var_431);
    // for k in range(6):                                                                     <L 20>
    // if k > j:                                                                              <L 21>
    var_434 = (var_433 > var_431);
    if (var_434) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_435 = wp::mul(var_433, var_7);
        var_436 = wp::add(var_435, var_431);
        var_437 = wp::extract(var_a, var_436);
        var_438 = wp::extract(var_1, var_433);
        var_439 = wp::mul(var_437, var_438);
        var_440 = wp::sub(var_432, var_439);
    }
    var_441 = wp::where(var_434, var_440, var_432);
    // if k > j:                                                                              <L 21>
    var_443 = (var_442 > var_431);
    if (var_443) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_444 = wp::mul(var_442, var_7);
        var_445 = wp::add(var_444, var_431);
        var_446 = wp::extract(var_a, var_445);
        var_447 = wp::extract(var_1, var_442);
        var_448 = wp::mul(var_446, var_447);
        var_449 = wp::sub(var_441, var_448);
    }
    var_450 = wp::where(var_443, var_449, var_441);
    // if k > j:                                                                              <L 21>
    var_452 = (var_451 > var_431);
    if (var_452) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_453 = wp::mul(var_451, var_7);
        var_454 = wp::add(var_453, var_431);
        var_455 = wp::extract(var_a, var_454);
        var_456 = wp::extract(var_1, var_451);
        var_457 = wp::mul(var_455, var_456);
        var_458 = wp::sub(var_450, var_457);
    }
    var_459 = wp::where(var_452, var_458, var_450);
    // if k > j:                                                                              <L 21>
    var_461 = (var_460 > var_431);
    if (var_461) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_462 = wp::mul(var_460, var_7);
        var_463 = wp::add(var_462, var_431);
        var_464 = wp::extract(var_a, var_463);
        var_465 = wp::extract(var_1, var_460);
        var_466 = wp::mul(var_464, var_465);
        var_467 = wp::sub(var_459, var_466);
    }
    var_468 = wp::where(var_461, var_467, var_459);
    // if k > j:                                                                              <L 21>
    var_470 = (var_469 > var_431);
    if (var_470) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_471 = wp::mul(var_469, var_7);
        var_472 = wp::add(var_471, var_431);
        var_473 = wp::extract(var_a, var_472);
        var_474 = wp::extract(var_1, var_469);
        var_475 = wp::mul(var_473, var_474);
        var_476 = wp::sub(var_468, var_475);
    }
    var_477 = wp::where(var_470, var_476, var_468);
    // if k > j:                                                                              <L 21>
    var_479 = (var_478 > var_431);
    if (var_479) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_480 = wp::mul(var_478, var_7);
        var_481 = wp::add(var_480, var_431);
        var_482 = wp::extract(var_a, var_481);
        var_483 = wp::extract(var_1, var_478);
        var_484 = wp::mul(var_482, var_483);
        var_485 = wp::sub(var_477, var_484);
    }
    var_486 = wp::where(var_479, var_485, var_477);
    // x[j] = v                                                                               <L 23>
    wp::assign_inplace(var_1, var_431, var_486);
    // j = UNKNOWNS - 1 - step                                                                <L 18>
    var_489 = wp::sub(var_7, var_488);
    var_490 = wp::sub(var_489, var_487);
    // v = x[j]                                                                               <L 19>
    var_491 = wp::extract(var_1, var_490);
    // for k in range(6):                                                                     <L 20>
    // if k > j:                                                                              <L 21>
    var_493 = (var_492 > var_490);
    if (var_493) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_494 = wp::mul(var_492, var_7);
        var_495 = wp::add(var_494, var_490);
        var_496 = wp::extract(var_a, var_495);
        var_497 = wp::extract(var_1, var_492);
        var_498 = wp::mul(var_496, var_497);
        var_499 = wp::sub(var_491, var_498);
    }
    var_500 = wp::where(var_493, var_499, var_491);
    // if k > j:                                                                              <L 21>
    var_502 = (var_501 > var_490);
    if (var_502) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_503 = wp::mul(var_501, var_7);
        var_504 = wp::add(var_503, var_490);
        var_505 = wp::extract(var_a, var_504);
        var_506 = wp::extract(var_1, var_501);
        var_507 = wp::mul(var_505, var_506);
        var_508 = wp::sub(var_500, var_507);
    }
    var_509 = wp::where(var_502, var_508, var_500);
    // if k > j:                                                                              <L 21>
    var_511 = (var_510 > var_490);
    if (var_511) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_512 = wp::mul(var_510, var_7);
        var_513 = wp::add(var_512, var_490);
        var_514 = wp::extract(var_a, var_513);
        var_515 = wp::extract(var_1, var_510);
        var_516 = wp::mul(var_514, var_515);
        var_517 = wp::sub(var_509, var_516);
    }
    var_518 = wp::where(var_511, var_517, var_509);
    // if k > j:                                                                              <L 21>
    var_520 = (var_519 > var_490);
    if (var_520) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_521 = wp::mul(var_519, var_7);
        var_522 = wp::add(var_521, var_490);
        var_523 = wp::extract(var_a, var_522);
        var_524 = wp::extract(var_1, var_519);
        var_525 = wp::mul(var_523, var_524);
        var_526 = wp::sub(var_518, var_525);
    }
    var_527 = wp::where(var_520, var_526, var_518);
    // if k > j:                                                                              <L 21>
    var_529 = (var_528 > var_490);
    if (var_529) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_530 = wp::mul(var_528, var_7);
        var_531 = wp::add(var_530, var_490);
        var_532 = wp::extract(var_a, var_531);
        var_533 = wp::extract(var_1, var_528);
        var_534 = wp::mul(var_532, var_533);
        var_535 = wp::sub(var_527, var_534);
    }
    var_536 = wp::where(var_529, var_535, var_527);
    // if k > j:                                                                              <L 21>
    var_538 = (var_537 > var_490);
    if (var_538) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_539 = wp::mul(var_537, var_7);
        var_540 = wp::add(var_539, var_490);
        var_541 = wp::extract(var_a, var_540);
        var_542 = wp::extract(var_1, var_537);
        var_543 = wp::mul(var_541, var_542);
        var_544 = wp::sub(var_536, var_543);
    }
    var_545 = wp::where(var_538, var_544, var_536);
    // x[j] = v                                                                               <L 23>
    wp::assign_inplace(var_1, var_490, var_545);
    // return x                                                                               <L 24>
    return var_1;
}


// /work/main/src/pointloom/kernels/algebra/rigid_solve.py:244
static CUDA_CALLABLE wp::vec_t<6, wp::float64> solve_system_0(
    wp::vec_t<21, wp::float64> var_h,
    wp::vec_t<6, wp::float64> var_b)
{
    //---------
    // primal vars
    wp::vec_t<36, wp::float64> var_0;
    wp::vec_t<6, wp::float64> var_1;
    //---------
    // forward
    // def solve_system(h: triangle, b: vec6d) -> vec6d:                                      <L 245>
    // return solve_factored(factor_system(h), b)                                             <L 247>
    var_0 = factor_system_0(var_h);
    var_1 = solve_factored_0(var_0, var_b);
    return var_1;
}


// <pointloom.kernels.rgbd.alignment.damped_solution>:1
static CUDA_CALLABLE wp::vec_t<6, wp::float64> damped_solution_0(
    wp::vec_t<38, wp::float64> var_total)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::vec_t<21, wp::float64> var_1;
    wp::float64 var_2;
    wp::vec_t<6, wp::float64> var_3;
    const wp::int32 var_4 = 6;
    wp::int32 var_5;
    const wp::int32 var_6 = 21;
    wp::int32 var_7;
    wp::range_t var_8;
    wp::int32 var_9;
    wp::float64 var_10;
    wp::range_t var_11;
    wp::int32 var_12;
    wp::int32 var_13;
    wp::float64 var_14;
    wp::float64 var_15;
    wp::float64 var_16;
    wp::float64 var_17;
    wp::float64 var_18;
    wp::float64 var_19;
    wp::float64 var_20;
    const wp::int32 var_21 = 21;
    wp::int32 var_22;
    wp::float64 var_23;
    wp::float64 var_24;
    wp::vec_t<6, wp::float64> var_25;
    //---------
    // forward
    // def damped_solution(total):                                                            <L 1>
    // h = triangle(float64(0.0))                                                             <L 2>
    var_0 = 0.0;
    var_1 = wp::vec_t<21, wp::float64>(var_0);
    // b = vec6d(float64(0.0))                                                                <L 3>
    var_2 = 0.0;
    var_3 = wp::vec_t<6, wp::float64>(var_2);
    // n = int(6)                                                                             <L 4>
    var_5 = wp::int(var_4);
    // m = int(21)                                                                            <L 5>
    var_7 = wp::int(var_6);
    // for k in range(m):                                                                     <L 6>
    var_8 = wp::range(var_7);
    start_for_0:;
        if (iter_cmp(var_8) == 0) goto end_for_0;
        var_9 = wp::iter_next(var_8);
        // h[k] = total[k]                                                                    <L 7>
        var_10 = wp::extract(var_total, var_9);
        wp::assign_inplace(var_1, var_9, var_10);
        goto start_for_0;
    end_for_0:;
    // for k in range(n):                                                                     <L 8>
    var_11 = wp::range(var_5);
    start_for_2:;
        if (iter_cmp(var_11) == 0) goto end_for_2;
        var_12 = wp::iter_next(var_11);
        // at = triangle_index(k, k)                                                          <L 9>
        var_13 = triangle_index_0(var_12, var_12);
        // h[at] = h[at] * (float64(1.0) + float64(DAMPING)) + float64(1e-12)                 <L 10>
        var_14 = wp::extract(var_1, var_13);
        var_15 = 1.0;
        var_16 = 1e-06;
        var_17 = wp::add(var_15, var_16);
        var_18 = wp::mul(var_14, var_17);
        var_19 = 1e-12;
        var_20 = wp::add(var_18, var_19);
        wp::assign_inplace(var_1, var_13, var_20);
        // b[k] = -total[21 + k]                                                              <L 11>
        var_22 = wp::add(var_21, var_12);
        var_23 = wp::extract(var_total, var_22);
        var_24 = wp::neg(var_23);
        wp::assign_inplace(var_3, var_12, var_24);
        goto start_for_2;
    end_for_2:;
    // return solve_system(h, b)                                                              <L 12>
    var_25 = solve_system_0(var_1, var_3);
    return var_25;
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


// <pointloom.kernels.algebra.rigid_solve.small_motion>:1
static CUDA_CALLABLE wp::mat_t<4, 4, wp::float64> small_motion_0(
    wp::vec_t<6, wp::float64> var_x)
{
    //---------
    // primal vars
    wp::float64 var_0;
    const wp::int32 var_1 = 0;
    wp::float64 var_2;
    wp::float64 var_3;
    const wp::int32 var_4 = 1;
    wp::float64 var_5;
    wp::float64 var_6;
    const wp::int32 var_7 = 2;
    wp::float64 var_8;
    wp::float64 var_9;
    wp::float64 var_10;
    wp::mat_t<4, 4, wp::float64> var_11;
    const wp::int32 var_12 = 0;
    const wp::int32 var_13 = 3;
    wp::int32 var_14;
    wp::float64 var_15;
    const wp::int32 var_16 = 3;
    const wp::int32 var_17 = 1;
    const wp::int32 var_18 = 3;
    wp::int32 var_19;
    wp::float64 var_20;
    const wp::int32 var_21 = 3;
    const wp::int32 var_22 = 2;
    const wp::int32 var_23 = 3;
    wp::int32 var_24;
    wp::float64 var_25;
    const wp::int32 var_26 = 3;
    //---------
    // forward
    // def small_motion(x):                                                                   <L 1>
    // half = float64(0.5)                                                                    <L 3>
    var_0 = 0.5;
    // pose = rotation_about(x[0] * half, x[1] * half, x[2] * half, float64(1.0))             <L 4>
    var_2 = wp::extract(var_x, var_1);
    var_3 = wp::mul(var_2, var_0);
    var_5 = wp::extract(var_x, var_4);
    var_6 = wp::mul(var_5, var_0);
    var_8 = wp::extract(var_x, var_7);
    var_9 = wp::mul(var_8, var_0);
    var_10 = 1.0;
    var_11 = rotation_about_0(var_3, var_6, var_9, var_10);
    // for i in range(3):                                                                     <L 5>
    // pose[i, 3] = x[3 + i]                                                                  <L 6>
    var_14 = wp::add(var_13, var_12);
    var_15 = wp::extract(var_x, var_14);
    wp::assign_inplace(var_11, var_12, var_16, var_15);
    var_19 = wp::add(var_18, var_17);
    var_20 = wp::extract(var_x, var_19);
    wp::assign_inplace(var_11, var_17, var_21, var_20);
    var_24 = wp::add(var_23, var_22);
    var_25 = wp::extract(var_x, var_24);
    wp::assign_inplace(var_11, var_22, var_26, var_25);
    // return pose                                                                            <L 7>
    return var_11;
}


// <pointloom.kernels.algebra.matrices.multiply44>:1
static CUDA_CALLABLE wp::mat_t<4, 4, wp::float64> multiply44_0(
    wp::mat_t<4, 4, wp::float64> var_a,
    wp::mat_t<4, 4, wp::float64> var_b)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::mat_t<4, 4, wp::float64> var_1;
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
    const wp::int32 var_21 = 3;
    wp::float64 var_22;
    const wp::int32 var_23 = 3;
    wp::float64 var_24;
    wp::float64 var_25;
    wp::float64 var_26;
    const wp::int32 var_27 = 1;
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
    const wp::int32 var_45 = 3;
    wp::float64 var_46;
    const wp::int32 var_47 = 3;
    wp::float64 var_48;
    wp::float64 var_49;
    wp::float64 var_50;
    const wp::int32 var_51 = 2;
    const wp::int32 var_52 = 0;
    wp::float64 var_53;
    const wp::int32 var_54 = 0;
    wp::float64 var_55;
    wp::float64 var_56;
    const wp::int32 var_57 = 1;
    wp::float64 var_58;
    const wp::int32 var_59 = 1;
    wp::float64 var_60;
    wp::float64 var_61;
    wp::float64 var_62;
    const wp::int32 var_63 = 2;
    wp::float64 var_64;
    const wp::int32 var_65 = 2;
    wp::float64 var_66;
    wp::float64 var_67;
    wp::float64 var_68;
    const wp::int32 var_69 = 3;
    wp::float64 var_70;
    const wp::int32 var_71 = 3;
    wp::float64 var_72;
    wp::float64 var_73;
    wp::float64 var_74;
    const wp::int32 var_75 = 3;
    const wp::int32 var_76 = 0;
    wp::float64 var_77;
    const wp::int32 var_78 = 0;
    wp::float64 var_79;
    wp::float64 var_80;
    const wp::int32 var_81 = 1;
    wp::float64 var_82;
    const wp::int32 var_83 = 1;
    wp::float64 var_84;
    wp::float64 var_85;
    wp::float64 var_86;
    const wp::int32 var_87 = 2;
    wp::float64 var_88;
    const wp::int32 var_89 = 2;
    wp::float64 var_90;
    wp::float64 var_91;
    wp::float64 var_92;
    const wp::int32 var_93 = 3;
    wp::float64 var_94;
    const wp::int32 var_95 = 3;
    wp::float64 var_96;
    wp::float64 var_97;
    wp::float64 var_98;
    const wp::int32 var_99 = 1;
    const wp::int32 var_100 = 0;
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
    const wp::int32 var_118 = 3;
    wp::float64 var_119;
    const wp::int32 var_120 = 3;
    wp::float64 var_121;
    wp::float64 var_122;
    wp::float64 var_123;
    const wp::int32 var_124 = 1;
    const wp::int32 var_125 = 0;
    wp::float64 var_126;
    const wp::int32 var_127 = 0;
    wp::float64 var_128;
    wp::float64 var_129;
    const wp::int32 var_130 = 1;
    wp::float64 var_131;
    const wp::int32 var_132 = 1;
    wp::float64 var_133;
    wp::float64 var_134;
    wp::float64 var_135;
    const wp::int32 var_136 = 2;
    wp::float64 var_137;
    const wp::int32 var_138 = 2;
    wp::float64 var_139;
    wp::float64 var_140;
    wp::float64 var_141;
    const wp::int32 var_142 = 3;
    wp::float64 var_143;
    const wp::int32 var_144 = 3;
    wp::float64 var_145;
    wp::float64 var_146;
    wp::float64 var_147;
    const wp::int32 var_148 = 2;
    const wp::int32 var_149 = 0;
    wp::float64 var_150;
    const wp::int32 var_151 = 0;
    wp::float64 var_152;
    wp::float64 var_153;
    const wp::int32 var_154 = 1;
    wp::float64 var_155;
    const wp::int32 var_156 = 1;
    wp::float64 var_157;
    wp::float64 var_158;
    wp::float64 var_159;
    const wp::int32 var_160 = 2;
    wp::float64 var_161;
    const wp::int32 var_162 = 2;
    wp::float64 var_163;
    wp::float64 var_164;
    wp::float64 var_165;
    const wp::int32 var_166 = 3;
    wp::float64 var_167;
    const wp::int32 var_168 = 3;
    wp::float64 var_169;
    wp::float64 var_170;
    wp::float64 var_171;
    const wp::int32 var_172 = 3;
    const wp::int32 var_173 = 0;
    wp::float64 var_174;
    const wp::int32 var_175 = 0;
    wp::float64 var_176;
    wp::float64 var_177;
    const wp::int32 var_178 = 1;
    wp::float64 var_179;
    const wp::int32 var_180 = 1;
    wp::float64 var_181;
    wp::float64 var_182;
    wp::float64 var_183;
    const wp::int32 var_184 = 2;
    wp::float64 var_185;
    const wp::int32 var_186 = 2;
    wp::float64 var_187;
    wp::float64 var_188;
    wp::float64 var_189;
    const wp::int32 var_190 = 3;
    wp::float64 var_191;
    const wp::int32 var_192 = 3;
    wp::float64 var_193;
    wp::float64 var_194;
    wp::float64 var_195;
    const wp::int32 var_196 = 2;
    const wp::int32 var_197 = 0;
    const wp::int32 var_198 = 0;
    wp::float64 var_199;
    const wp::int32 var_200 = 0;
    wp::float64 var_201;
    wp::float64 var_202;
    const wp::int32 var_203 = 1;
    wp::float64 var_204;
    const wp::int32 var_205 = 1;
    wp::float64 var_206;
    wp::float64 var_207;
    wp::float64 var_208;
    const wp::int32 var_209 = 2;
    wp::float64 var_210;
    const wp::int32 var_211 = 2;
    wp::float64 var_212;
    wp::float64 var_213;
    wp::float64 var_214;
    const wp::int32 var_215 = 3;
    wp::float64 var_216;
    const wp::int32 var_217 = 3;
    wp::float64 var_218;
    wp::float64 var_219;
    wp::float64 var_220;
    const wp::int32 var_221 = 1;
    const wp::int32 var_222 = 0;
    wp::float64 var_223;
    const wp::int32 var_224 = 0;
    wp::float64 var_225;
    wp::float64 var_226;
    const wp::int32 var_227 = 1;
    wp::float64 var_228;
    const wp::int32 var_229 = 1;
    wp::float64 var_230;
    wp::float64 var_231;
    wp::float64 var_232;
    const wp::int32 var_233 = 2;
    wp::float64 var_234;
    const wp::int32 var_235 = 2;
    wp::float64 var_236;
    wp::float64 var_237;
    wp::float64 var_238;
    const wp::int32 var_239 = 3;
    wp::float64 var_240;
    const wp::int32 var_241 = 3;
    wp::float64 var_242;
    wp::float64 var_243;
    wp::float64 var_244;
    const wp::int32 var_245 = 2;
    const wp::int32 var_246 = 0;
    wp::float64 var_247;
    const wp::int32 var_248 = 0;
    wp::float64 var_249;
    wp::float64 var_250;
    const wp::int32 var_251 = 1;
    wp::float64 var_252;
    const wp::int32 var_253 = 1;
    wp::float64 var_254;
    wp::float64 var_255;
    wp::float64 var_256;
    const wp::int32 var_257 = 2;
    wp::float64 var_258;
    const wp::int32 var_259 = 2;
    wp::float64 var_260;
    wp::float64 var_261;
    wp::float64 var_262;
    const wp::int32 var_263 = 3;
    wp::float64 var_264;
    const wp::int32 var_265 = 3;
    wp::float64 var_266;
    wp::float64 var_267;
    wp::float64 var_268;
    const wp::int32 var_269 = 3;
    const wp::int32 var_270 = 0;
    wp::float64 var_271;
    const wp::int32 var_272 = 0;
    wp::float64 var_273;
    wp::float64 var_274;
    const wp::int32 var_275 = 1;
    wp::float64 var_276;
    const wp::int32 var_277 = 1;
    wp::float64 var_278;
    wp::float64 var_279;
    wp::float64 var_280;
    const wp::int32 var_281 = 2;
    wp::float64 var_282;
    const wp::int32 var_283 = 2;
    wp::float64 var_284;
    wp::float64 var_285;
    wp::float64 var_286;
    const wp::int32 var_287 = 3;
    wp::float64 var_288;
    const wp::int32 var_289 = 3;
    wp::float64 var_290;
    wp::float64 var_291;
    wp::float64 var_292;
    const wp::int32 var_293 = 3;
    const wp::int32 var_294 = 0;
    const wp::int32 var_295 = 0;
    wp::float64 var_296;
    const wp::int32 var_297 = 0;
    wp::float64 var_298;
    wp::float64 var_299;
    const wp::int32 var_300 = 1;
    wp::float64 var_301;
    const wp::int32 var_302 = 1;
    wp::float64 var_303;
    wp::float64 var_304;
    wp::float64 var_305;
    const wp::int32 var_306 = 2;
    wp::float64 var_307;
    const wp::int32 var_308 = 2;
    wp::float64 var_309;
    wp::float64 var_310;
    wp::float64 var_311;
    const wp::int32 var_312 = 3;
    wp::float64 var_313;
    const wp::int32 var_314 = 3;
    wp::float64 var_315;
    wp::float64 var_316;
    wp::float64 var_317;
    const wp::int32 var_318 = 1;
    const wp::int32 var_319 = 0;
    wp::float64 var_320;
    const wp::int32 var_321 = 0;
    wp::float64 var_322;
    wp::float64 var_323;
    const wp::int32 var_324 = 1;
    wp::float64 var_325;
    const wp::int32 var_326 = 1;
    wp::float64 var_327;
    wp::float64 var_328;
    wp::float64 var_329;
    const wp::int32 var_330 = 2;
    wp::float64 var_331;
    const wp::int32 var_332 = 2;
    wp::float64 var_333;
    wp::float64 var_334;
    wp::float64 var_335;
    const wp::int32 var_336 = 3;
    wp::float64 var_337;
    const wp::int32 var_338 = 3;
    wp::float64 var_339;
    wp::float64 var_340;
    wp::float64 var_341;
    const wp::int32 var_342 = 2;
    const wp::int32 var_343 = 0;
    wp::float64 var_344;
    const wp::int32 var_345 = 0;
    wp::float64 var_346;
    wp::float64 var_347;
    const wp::int32 var_348 = 1;
    wp::float64 var_349;
    const wp::int32 var_350 = 1;
    wp::float64 var_351;
    wp::float64 var_352;
    wp::float64 var_353;
    const wp::int32 var_354 = 2;
    wp::float64 var_355;
    const wp::int32 var_356 = 2;
    wp::float64 var_357;
    wp::float64 var_358;
    wp::float64 var_359;
    const wp::int32 var_360 = 3;
    wp::float64 var_361;
    const wp::int32 var_362 = 3;
    wp::float64 var_363;
    wp::float64 var_364;
    wp::float64 var_365;
    const wp::int32 var_366 = 3;
    const wp::int32 var_367 = 0;
    wp::float64 var_368;
    const wp::int32 var_369 = 0;
    wp::float64 var_370;
    wp::float64 var_371;
    const wp::int32 var_372 = 1;
    wp::float64 var_373;
    const wp::int32 var_374 = 1;
    wp::float64 var_375;
    wp::float64 var_376;
    wp::float64 var_377;
    const wp::int32 var_378 = 2;
    wp::float64 var_379;
    const wp::int32 var_380 = 2;
    wp::float64 var_381;
    wp::float64 var_382;
    wp::float64 var_383;
    const wp::int32 var_384 = 3;
    wp::float64 var_385;
    const wp::int32 var_386 = 3;
    wp::float64 var_387;
    wp::float64 var_388;
    wp::float64 var_389;
    //---------
    // forward
    // def multiply44(a, b):                                                                  <L 1>
    // product = mat44d(float64(0.0))                                                         <L 2>
    var_0 = 0.0;
    var_1 = wp::mat_t<4, 4, wp::float64>(var_0);
    // for row in range(4):                                                                   <L 3>
    // for column in range(4):                                                                <L 4>
    // total = a[row, 0] * b[0, column] + a[row, 1] * b[1, column]                            <L 5>
    var_5 = wp::extract(var_a, var_2, var_4);
    var_7 = wp::extract(var_b, var_6, var_3);
    var_8 = wp::mul(var_5, var_7);
    var_10 = wp::extract(var_a, var_2, var_9);
    var_12 = wp::extract(var_b, var_11, var_3);
    var_13 = wp::mul(var_10, var_12);
    var_14 = wp::add(var_8, var_13);
    // product[row, column] = total + a[row, 2] * b[2, column] + a[row, 3] * b[3, column]       <L 6>
    var_16 = wp::extract(var_a, var_2, var_15);
    var_18 = wp::extract(var_b, var_17, var_3);
    var_19 = wp::mul(var_16, var_18);
    var_20 = wp::add(var_14, var_19);
    var_22 = wp::extract(var_a, var_2, var_21);
    var_24 = wp::extract(var_b, var_23, var_3);
    var_25 = wp::mul(var_22, var_24);
    var_26 = wp::add(var_20, var_25);
    wp::assign_inplace(var_1, var_2, var_3, var_26);
    // total = a[row, 0] * b[0, column] + a[row, 1] * b[1, column]                            <L 5>
    var_29 = wp::extract(var_a, var_2, var_28);
    var_31 = wp::extract(var_b, var_30, var_27);
    var_32 = wp::mul(var_29, var_31);
    var_34 = wp::extract(var_a, var_2, var_33);
    var_36 = wp::extract(var_b, var_35, var_27);
    var_37 = wp::mul(var_34, var_36);
    var_38 = wp::add(var_32, var_37);
    // product[row, column] = total + a[row, 2] * b[2, column] + a[row, 3] * b[3, column]       <L 6>
    var_40 = wp::extract(var_a, var_2, var_39);
    var_42 = wp::extract(var_b, var_41, var_27);
    var_43 = wp::mul(var_40, var_42);
    var_44 = wp::add(var_38, var_43);
    var_46 = wp::extract(var_a, var_2, var_45);
    var_48 = wp::extract(var_b, var_47, var_27);
    var_49 = wp::mul(var_46, var_48);
    var_50 = wp::add(var_44, var_49);
    wp::assign_inplace(var_1, var_2, var_27, var_50);
    // total = a[row, 0] * b[0, column] + a[row, 1] * b[1, column]                            <L 5>
    var_53 = wp::extract(var_a, var_2, var_52);
    var_55 = wp::extract(var_b, var_54, var_51);
    var_56 = wp::mul(var_53, var_55);
    var_58 = wp::extract(var_a, var_2, var_57);
    var_60 = wp::extract(var_b, var_59, var_51);
    var_61 = wp::mul(var_58, var_60);
    var_62 = wp::add(var_56, var_61);
    // product[row, column] = total + a[row, 2] * b[2, column] + a[row, 3] * b[3, column]       <L 6>
    var_64 = wp::extract(var_a, var_2, var_63);
    var_66 = wp::extract(var_b, var_65, var_51);
    var_67 = wp::mul(var_64, var_66);
    var_68 = wp::add(var_62, var_67);
    var_70 = wp::extract(var_a, var_2, var_69);
    var_72 = wp::extract(var_b, var_71, var_51);
    var_73 = wp::mul(var_70, var_72);
    var_74 = wp::add(var_68, var_73);
    wp::assign_inplace(var_1, var_2, var_51, var_74);
    // total = a[row, 0] * b[0, column] + a[row, 1] * b[1, column]                            <L 5>
    var_77 = wp::extract(var_a, var_2, var_76);
    var_79 = wp::extract(var_b, var_78, var_75);
    var_80 = wp::mul(var_77, var_79);
    var_82 = wp::extract(var_a, var_2, var_81);
    var_84 = wp::extract(var_b, var_83, var_75);
    var_85 = wp::mul(var_82, var_84);
    var_86 = wp::add(var_80, var_85);
    // product[row, column] = total + a[row, 2] * b[2, column] + a[row, 3] * b[3, column]       <L 6>
    var_88 = wp::extract(var_a, var_2, var_87);
    var_90 = wp::extract(var_b, var_89, var_75);
    var_91 = wp::mul(var_88, var_90);
    var_92 = wp::add(var_86, var_91);
    var_94 = wp::extract(var_a, var_2, var_93);
    var_96 = wp::extract(var_b, var_95, var_75);
    var_97 = wp::mul(var_94, var_96);
    var_98 = wp::add(var_92, var_97);
    wp::assign_inplace(var_1, var_2, var_75, var_98);
    // for column in range(4):                                                                <L 4>
    // total = a[row, 0] * b[0, column] + a[row, 1] * b[1, column]                            <L 5>
    var_102 = wp::extract(var_a, var_99, var_101);
    var_104 = wp::extract(var_b, var_103, var_100);
    var_105 = wp::mul(var_102, var_104);
    var_107 = wp::extract(var_a, var_99, var_106);
    var_109 = wp::extract(var_b, var_108, var_100);
    var_110 = wp::mul(var_107, var_109);
    var_111 = wp::add(var_105, var_110);
    // product[row, column] = total + a[row, 2] * b[2, column] + a[row, 3] * b[3, column]       <L 6>
    var_113 = wp::extract(var_a, var_99, var_112);
    var_115 = wp::extract(var_b, var_114, var_100);
    var_116 = wp::mul(var_113, var_115);
    var_117 = wp::add(var_111, var_116);
    var_119 = wp::extract(var_a, var_99, var_118);
    var_121 = wp::extract(var_b, var_120, var_100);
    var_122 = wp::mul(var_119, var_121);
    var_123 = wp::add(var_117, var_122);
    wp::assign_inplace(var_1, var_99, var_100, var_123);
    // total = a[row, 0] * b[0, column] + a[row, 1] * b[1, column]                            <L 5>
    var_126 = wp::extract(var_a, var_99, var_125);
    var_128 = wp::extract(var_b, var_127, var_124);
    var_129 = wp::mul(var_126, var_128);
    var_131 = wp::extract(var_a, var_99, var_130);
    var_133 = wp::extract(var_b, var_132, var_124);
    var_134 = wp::mul(var_131, var_133);
    var_135 = wp::add(var_129, var_134);
    // product[row, column] = total + a[row, 2] * b[2, column] + a[row, 3] * b[3, column]       <L 6>
    var_137 = wp::extract(var_a, var_99, var_136);
    var_139 = wp::extract(var_b, var_138, var_124);
    var_140 = wp::mul(var_137, var_139);
    var_141 = wp::add(var_135, var_140);
    var_143 = wp::extract(var_a, var_99, var_142);
    var_145 = wp::extract(var_b, var_144, var_124);
    var_146 = wp::mul(var_143, var_145);
    var_147 = wp::add(var_141, var_146);
    wp::assign_inplace(var_1, var_99, var_124, var_147);
    // total = a[row, 0] * b[0, column] + a[row, 1] * b[1, column]                            <L 5>
    var_150 = wp::extract(var_a, var_99, var_149);
    var_152 = wp::extract(var_b, var_151, var_148);
    var_153 = wp::mul(var_150, var_152);
    var_155 = wp::extract(var_a, var_99, var_154);
    var_157 = wp::extract(var_b, var_156, var_148);
    var_158 = wp::mul(var_155, var_157);
    var_159 = wp::add(var_153, var_158);
    // product[row, column] = total + a[row, 2] * b[2, column] + a[row, 3] * b[3, column]       <L 6>
    var_161 = wp::extract(var_a, var_99, var_160);
    var_163 = wp::extract(var_b, var_162, var_148);
    var_164 = wp::mul(var_161, var_163);
    var_165 = wp::add(var_159, var_164);
    var_167 = wp::extract(var_a, var_99, var_166);
    var_169 = wp::extract(var_b, var_168, var_148);
    var_170 = wp::mul(var_167, var_169);
    var_171 = wp::add(var_165, var_170);
    wp::assign_inplace(var_1, var_99, var_148, var_171);
    // total = a[row, 0] * b[0, column] + a[row, 1] * b[1, column]                            <L 5>
    var_174 = wp::extract(var_a, var_99, var_173);
    var_176 = wp::extract(var_b, var_175, var_172);
    var_177 = wp::mul(var_174, var_176);
    var_179 = wp::extract(var_a, var_99, var_178);
    var_181 = wp::extract(var_b, var_180, var_172);
    var_182 = wp::mul(var_179, var_181);
    var_183 = wp::add(var_177, var_182);
    // product[row, column] = total + a[row, 2] * b[2, column] + a[row, 3] * b[3, column]       <L 6>
    var_185 = wp::extract(var_a, var_99, var_184);
    var_187 = wp::extract(var_b, var_186, var_172);
    var_188 = wp::mul(var_185, var_187);
    var_189 = wp::add(var_183, var_188);
    var_191 = wp::extract(var_a, var_99, var_190);
    var_193 = wp::extract(var_b, var_192, var_172);
    var_194 = wp::mul(var_191, var_193);
    var_195 = wp::add(var_189, var_194);
    wp::assign_inplace(var_1, var_99, var_172, var_195);
    // for column in range(4):                                                                <L 4>
    // total = a[row, 0] * b[0, column] + a[row, 1] * b[1, column]                            <L 5>
    var_199 = wp::extract(var_a, var_196, var_198);
    var_201 = wp::extract(var_b, var_200, var_197);
    var_202 = wp::mul(var_199, var_201);
    var_204 = wp::extract(var_a, var_196, var_203);
    var_206 = wp::extract(var_b, var_205, var_197);
    var_207 = wp::mul(var_204, var_206);
    var_208 = wp::add(var_202, var_207);
    // product[row, column] = total + a[row, 2] * b[2, column] + a[row, 3] * b[3, column]       <L 6>
    var_210 = wp::extract(var_a, var_196, var_209);
    var_212 = wp::extract(var_b, var_211, var_197);
    var_213 = wp::mul(var_210, var_212);
    var_214 = wp::add(var_208, var_213);
    var_216 = wp::extract(var_a, var_196, var_215);
    var_218 = wp::extract(var_b, var_217, var_197);
    var_219 = wp::mul(var_216, var_218);
    var_220 = wp::add(var_214, var_219);
    wp::assign_inplace(var_1, var_196, var_197, var_220);
    // total = a[row, 0] * b[0, column] + a[row, 1] * b[1, column]                            <L 5>
    var_223 = wp::extract(var_a, var_196, var_222);
    var_225 = wp::extract(var_b, var_224, var_221);
    var_226 = wp::mul(var_223, var_225);
    var_228 = wp::extract(var_a, var_196, var_227);
    var_230 = wp::extract(var_b, var_229, var_221);
    var_231 = wp::mul(var_228, var_230);
    var_232 = wp::add(var_226, var_231);
    // product[row, column] = total + a[row, 2] * b[2, column] + a[row, 3] * b[3, column]       <L 6>
    var_234 = wp::extract(var_a, var_196, var_233);
    var_236 = wp::extract(var_b, var_235, var_221);
    var_237 = wp::mul(var_234, var_236);
    var_238 = wp::add(var_232, var_237);
    var_240 = wp::extract(var_a, var_196, var_239);
    var_242 = wp::extract(var_b, var_241, var_221);
    var_243 = wp::mul(var_240, var_242);
    var_244 = wp::add(var_238, var_243);
    wp::assign_inplace(var_1, var_196, var_221, var_244);
    // total = a[row, 0] * b[0, column] + a[row, 1] * b[1, column]                            <L 5>
    var_247 = wp::extract(var_a, var_196, var_246);
    var_249 = wp::extract(var_b, var_248, var_245);
    var_250 = wp::mul(var_247, var_249);
    var_252 = wp::extract(var_a, var_196, var_251);
    var_254 = wp::extract(var_b, var_253, var_245);
    var_255 = wp::mul(var_252, var_254);
    var_256 = wp::add(var_250, var_255);
    // product[row, column] = total + a[row, 2] * b[2, column] + a[row, 3] * b[3, column]       <L 6>
    var_258 = wp::extract(var_a, var_196, var_257);
    var_260 = wp::extract(var_b, var_259, var_245);
    var_261 = wp::mul(var_258, var_260);
    var_262 = wp::add(var_256, var_261);
    var_264 = wp::extract(var_a, var_196, var_263);
    var_266 = wp::extract(var_b, var_265, var_245);
    var_267 = wp::mul(var_264, var_266);
    var_268 = wp::add(var_262, var_267);
    wp::assign_inplace(var_1, var_196, var_245, var_268);
    // total = a[row, 0] * b[0, column] + a[row, 1] * b[1, column]                            <L 5>
    var_271 = wp::extract(var_a, var_196, var_270);
    var_273 = wp::extract(var_b, var_272, var_269);
    var_274 = wp::mul(var_271, var_273);
    var_276 = wp::extract(var_a, var_196, var_275);
    var_278 = wp::extract(var_b, var_277, var_269);
    var_279 = wp::mul(var_276, var_278);
    var_280 = wp::add(var_274, var_279);
    // product[row, column] = total + a[row, 2] * b[2, column] + a[row, 3] * b[3, column]       <L 6>
    var_282 = wp::extract(var_a, var_196, var_281);
    var_284 = wp::extract(var_b, var_283, var_269);
    var_285 = wp::mul(var_282, var_284);
    var_286 = wp::add(var_280, var_285);
    var_288 = wp::extract(var_a, var_196, var_287);
    var_290 = wp::extract(var_b, var_289, var_269);
    var_291 = wp::mul(var_288, var_290);
    var_292 = wp::add(var_286, var_291);
    wp::assign_inplace(var_1, var_196, var_269, var_292);
    // for column in range(4):                                                                <L 4>
    // total = a[row, 0] * b[0, column] + a[row, 1] * b[1, column]                            <L 5>
    var_296 = wp::extract(var_a, var_293, var_295);
    var_298 = wp::extract(var_b, var_297, var_294);
    var_299 = wp::mul(var_296, var_298);
    var_301 = wp::extract(var_a, var_293, var_300);
    var_303 = wp::extract(var_b, var_302, var_294);
    var_304 = wp::mul(var_301, var_303);
    var_305 = wp::add(var_299, var_304);
    // product[row, column] = total + a[row, 2] * b[2, column] + a[row, 3] * b[3, column]       <L 6>
    var_307 = wp::extract(var_a, var_293, var_306);
    var_309 = wp::extract(var_b, var_308, var_294);
    var_310 = wp::mul(var_307, var_309);
    var_311 = wp::add(var_305, var_310);
    var_313 = wp::extract(var_a, var_293, var_312);
    var_315 = wp::extract(var_b, var_314, var_294);
    var_316 = wp::mul(var_313, var_315);
    var_317 = wp::add(var_311, var_316);
    wp::assign_inplace(var_1, var_293, var_294, var_317);
    // total = a[row, 0] * b[0, column] + a[row, 1] * b[1, column]                            <L 5>
    var_320 = wp::extract(var_a, var_293, var_319);
    var_322 = wp::extract(var_b, var_321, var_318);
    var_323 = wp::mul(var_320, var_322);
    var_325 = wp::extract(var_a, var_293, var_324);
    var_327 = wp::extract(var_b, var_326, var_318);
    var_328 = wp::mul(var_325, var_327);
    var_329 = wp::add(var_323, var_328);
    // product[row, column] = total + a[row, 2] * b[2, column] + a[row, 3] * b[3, column]       <L 6>
    var_331 = wp::extract(var_a, var_293, var_330);
    var_333 = wp::extract(var_b, var_332, var_318);
    var_334 = wp::mul(var_331, var_333);
    var_335 = wp::add(var_329, var_334);
    var_337 = wp::extract(var_a, var_293, var_336);
    var_339 = wp::extract(var_b, var_338, var_318);
    var_340 = wp::mul(var_337, var_339);
    var_341 = wp::add(var_335, var_340);
    wp::assign_inplace(var_1, var_293, var_318, var_341);
    // total = a[row, 0] * b[0, column] + a[row, 1] * b[1, column]                            <L 5>
    var_344 = wp::extract(var_a, var_293, var_343);
    var_346 = wp::extract(var_b, var_345, var_342);
    var_347 = wp::mul(var_344, var_346);
    var_349 = wp::extract(var_a, var_293, var_348);
    var_351 = wp::extract(var_b, var_350, var_342);
    var_352 = wp::mul(var_349, var_351);
    var_353 = wp::add(var_347, var_352);
    // product[row, column] = total + a[row, 2] * b[2, column] + a[row, 3] * b[3, column]       <L 6>
    var_355 = wp::extract(var_a, var_293, var_354);
    var_357 = wp::extract(var_b, var_356, var_342);
    var_358 = wp::mul(var_355, var_357);
    var_359 = wp::add(var_353, var_358);
    var_361 = wp::extract(var_a, var_293, var_360);
    var_363 = wp::extract(var_b, var_362, var_342);
    var_364 = wp::mul(var_361, var_363);
    var_365 = wp::add(var_359, var_364);
    wp::assign_inplace(var_1, var_293, var_342, var_365);
    // total = a[row, 0] * b[0, column] + a[row, 1] * b[1, column]                            <L 5>
    var_368 = wp::extract(var_a, var_293, var_367);
    var_370 = wp::extract(var_b, var_369, var_366);
    var_371 = wp::mul(var_368, var_370);
    var_373 = wp::extract(var_a, var_293, var_372);
    var_375 = wp::extract(var_b, var_374, var_366);
    var_376 = wp::mul(var_373, var_375);
    var_377 = wp::add(var_371, var_376);
    // product[row, column] = total + a[row, 2] * b[2, column] + a[row, 3] * b[3, column]       <L 6>
    var_379 = wp::extract(var_a, var_293, var_378);
    var_381 = wp::extract(var_b, var_380, var_366);
    var_382 = wp::mul(var_379, var_381);
    var_383 = wp::add(var_377, var_382);
    var_385 = wp::extract(var_a, var_293, var_384);
    var_387 = wp::extract(var_b, var_386, var_366);
    var_388 = wp::mul(var_385, var_387);
    var_389 = wp::add(var_383, var_388);
    wp::assign_inplace(var_1, var_293, var_366, var_389);
    // return product                                                                         <L 7>
    return var_1;
}


// <pointloom.kernels.rgbd.alignment.set_warps>:1
static CUDA_CALLABLE void adj_set_warps_0(
    wp::int32 var_level,
    wp::array_t<wp::vec_t<4, wp::float32>> var_source__lenses,
    wp::mat_t<4, 4, wp::float64> var_pose,
    wp::array_t<wp::vec_t<4, wp::float32>> var_warps,
    wp::int32 & adj_level,
    wp::array_t<wp::vec_t<4, wp::float32>> & adj_source__lenses,
    wp::mat_t<4, 4, wp::float64> & adj_pose,
    wp::array_t<wp::vec_t<4, wp::float32>> & adj_warps)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/rgbd/alignment.py:197
static CUDA_CALLABLE void adj_bounded_0(
    wp::float64 var_value,
    wp::float64 var_low,
    wp::float64 var_high,
    wp::float64 & adj_value,
    wp::float64 & adj_low,
    wp::float64 & adj_high,
    wp::float64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.rgbd.alignment.learn_noise>:1
static CUDA_CALLABLE void adj_learn_noise_0(
    wp::vec_t<38, wp::float64> var_total,
    wp::array_t<wp::float32> var_state__scales,
    wp::vec_t<38, wp::float64> & adj_total,
    wp::array_t<wp::float32> & adj_state__scales)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/algebra/rigid_solve.py:21
static CUDA_CALLABLE void adj_triangle_index_0(
    wp::int32 var_row,
    wp::int32 var_column,
    wp::int32 & adj_row,
    wp::int32 & adj_column,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.algebra.rigid_solve.full_matrix>:1
static CUDA_CALLABLE void adj_full_matrix_0(
    wp::vec_t<21, wp::float64> var_h,
    wp::vec_t<21, wp::float64> & adj_h,
    wp::vec_t<36, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.algebra.rigid_solve.factor_system>:1
static CUDA_CALLABLE void adj_factor_system_0(
    wp::vec_t<21, wp::float64> var_h,
    wp::vec_t<21, wp::float64> & adj_h,
    wp::vec_t<36, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.algebra.rigid_solve.solve_factored>:1
static CUDA_CALLABLE void adj_solve_factored_0(
    wp::vec_t<36, wp::float64> var_a,
    wp::vec_t<6, wp::float64> var_b,
    wp::vec_t<36, wp::float64> & adj_a,
    wp::vec_t<6, wp::float64> & adj_b,
    wp::vec_t<6, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/algebra/rigid_solve.py:244
static CUDA_CALLABLE void adj_solve_system_0(
    wp::vec_t<21, wp::float64> var_h,
    wp::vec_t<6, wp::float64> var_b,
    wp::vec_t<21, wp::float64> & adj_h,
    wp::vec_t<6, wp::float64> & adj_b,
    wp::vec_t<6, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.rgbd.alignment.damped_solution>:1
static CUDA_CALLABLE void adj_damped_solution_0(
    wp::vec_t<38, wp::float64> var_total,
    wp::vec_t<38, wp::float64> & adj_total,
    wp::vec_t<6, wp::float64> & adj_ret)
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


// <pointloom.kernels.algebra.rigid_solve.small_motion>:1
static CUDA_CALLABLE void adj_small_motion_0(
    wp::vec_t<6, wp::float64> var_x,
    wp::vec_t<6, wp::float64> & adj_x,
    wp::mat_t<4, 4, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.algebra.matrices.multiply44>:1
static CUDA_CALLABLE void adj_multiply44_0(
    wp::mat_t<4, 4, wp::float64> var_a,
    wp::mat_t<4, 4, wp::float64> var_b,
    wp::mat_t<4, 4, wp::float64> & adj_a,
    wp::mat_t<4, 4, wp::float64> & adj_b,
    wp::mat_t<4, 4, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void copy_sums_kernel_4ad7ef10_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<28, wp::float64>> var_consistency,
    wp::array_t<wp::vec_t<22, wp::float64>> var_certainty,
    wp::array_t<wp::vec_t<22, wp::float64>> var_firm,
    wp::array_t<wp::vec_t<28, wp::float64>> var_consistency_copy,
    wp::array_t<wp::vec_t<22, wp::float64>> var_certainty_copy,
    wp::array_t<wp::vec_t<22, wp::float64>> var_firm_copy)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::vec_t<28, wp::float64>* var_1;
        wp::vec_t<28, wp::float64> var_2;
        wp::vec_t<28, wp::float64> var_3;
        wp::vec_t<22, wp::float64>* var_4;
        wp::vec_t<22, wp::float64> var_5;
        wp::vec_t<22, wp::float64> var_6;
        wp::vec_t<22, wp::float64>* var_7;
        wp::vec_t<22, wp::float64> var_8;
        wp::vec_t<22, wp::float64> var_9;
        //---------
        // forward
        // def copy_sums_kernel(                                                                  <L 302>
        // i = tid()                                                                              <L 311>
        var_0 = builtin_tid1d();
        // consistency_copy[i] = consistency[i]                                                   <L 312>
        var_1 = wp::address(var_consistency, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        wp::array_store(var_consistency_copy, var_0, var_2);
        // certainty_copy[i] = certainty[i]                                                       <L 313>
        var_4 = wp::address(var_certainty, var_0);
        var_6 = wp::load(var_4);
        var_5 = wp::copy(var_6);
        wp::array_store(var_certainty_copy, var_0, var_5);
        // firm_copy[i] = firm[i]                                                                 <L 314>
        var_7 = wp::address(var_firm, var_0);
        var_9 = wp::load(var_7);
        var_8 = wp::copy(var_9);
        wp::array_store(var_firm_copy, var_0, var_8);
}



extern "C" __global__ void begin_alignment_kernel_b6542f6f_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<4, wp::float32>> var_source__lenses,
    wp::int32 var_level,
    wp::array_t<wp::vec_t<4, wp::float32>> var_state__warps,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_state__pose)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::mat_t<4, 4, wp::float64>* var_1;
        wp::mat_t<4, 4, wp::float64> var_2;
        //---------
        // forward
        // def begin_alignment_kernel(source__lenses, level, state__warps, state__pose):          <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // set_warps(level, source__lenses, state__pose[i], state__warps)                         <L 3>
        var_1 = wp::address(var_state__pose, var_0);
        var_2 = wp::load(var_1);
        set_warps_0(var_level, var_source__lenses, var_2, var_state__warps);
}



extern "C" __global__ void step_alignment_kernel_c6c8faa1_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<4, wp::float32>> var_source__lenses,
    wp::int32 var_rules__first_level,
    wp::float32 var_rules__short_step,
    wp::array_t<wp::vec_t<38, wp::float64>> var_sums,
    wp::array_t<wp::int32> var_state__running,
    wp::array_t<wp::int32> var_state__live,
    wp::array_t<wp::int32> var_state__counts,
    wp::array_t<wp::int32> var_state__max_steps,
    wp::array_t<wp::vec_t<4, wp::float32>> var_state__warps,
    wp::array_t<wp::float32> var_state__scales,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_state__pose)
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
        wp::vec_t<38, wp::float64>* var_4;
        wp::vec_t<38, wp::float64> var_5;
        wp::vec_t<38, wp::float64> var_6;
        const wp::int32 var_7 = 2;
        wp::int32* var_8;
        const wp::int32 var_9 = 1;
        wp::int32 var_10;
        wp::int32 var_11;
        const wp::int32 var_12 = 2;
        const wp::int32 var_13 = 1;
        wp::int32* var_14;
        const wp::int32 var_15 = 1;
        wp::int32 var_16;
        wp::int32 var_17;
        const wp::int32 var_18 = 0;
        wp::int32 var_19;
        const wp::int32 var_20 = 0;
        wp::mat_t<4, 4, wp::float64>* var_21;
        wp::mat_t<4, 4, wp::float64> var_22;
        wp::mat_t<4, 4, wp::float64> var_23;
        const wp::int32 var_24 = 27;
        wp::float64 var_25;
        const wp::int32 var_26 = 30;
        wp::float64 var_27;
        wp::float64 var_28;
        wp::float64 var_29;
        bool var_30;
        const wp::int32 var_31 = 1;
        wp::vec_t<6, wp::float64> var_32;
        const wp::int32 var_33 = 0;
        wp::float64 var_34;
        const wp::int32 var_35 = 0;
        wp::float64 var_36;
        wp::float64 var_37;
        const wp::int32 var_38 = 1;
        wp::float64 var_39;
        const wp::int32 var_40 = 1;
        wp::float64 var_41;
        wp::float64 var_42;
        wp::float64 var_43;
        const wp::int32 var_44 = 2;
        wp::float64 var_45;
        const wp::int32 var_46 = 2;
        wp::float64 var_47;
        wp::float64 var_48;
        wp::float64 var_49;
        wp::float64 var_50;
        const wp::int32 var_51 = 3;
        wp::float64 var_52;
        const wp::int32 var_53 = 3;
        wp::float64 var_54;
        wp::float64 var_55;
        const wp::int32 var_56 = 4;
        wp::float64 var_57;
        const wp::int32 var_58 = 4;
        wp::float64 var_59;
        wp::float64 var_60;
        wp::float64 var_61;
        const wp::int32 var_62 = 5;
        wp::float64 var_63;
        const wp::int32 var_64 = 5;
        wp::float64 var_65;
        wp::float64 var_66;
        wp::float64 var_67;
        wp::float64 var_68;
        bool var_69;
        wp::float64 var_70;
        bool var_71;
        wp::float64 var_72;
        bool var_73;
        wp::mat_t<4, 4, wp::float64> var_74;
        wp::mat_t<4, 4, wp::float64> var_75;
        const wp::int32 var_76 = 0;
        wp::float64 var_77;
        wp::vec_t<4, wp::float32>* var_78;
        const wp::int32 var_79 = 0;
        wp::float32 var_80;
        wp::vec_t<4, wp::float32> var_81;
        wp::float64 var_82;
        wp::float64 var_83;
        bool var_84;
        const wp::int32 var_85 = 1;
        bool var_86;
        bool var_87;
        bool var_88;
        const wp::int32 var_89 = 1;
        wp::int32 var_90;
        const wp::int32 var_91 = 1;
        wp::int32 var_92;
        wp::mat_t<4, 4, wp::float64> var_93;
        wp::int32 var_94;
        wp::mat_t<4, 4, wp::float64> var_95;
        wp::int32* var_96;
        bool var_97;
        wp::int32 var_98;
        const wp::int32 var_99 = 1;
        wp::int32 var_100;
        const wp::int32 var_101 = 1;
        bool var_102;
        const wp::int32 var_103 = 0;
        const wp::int32 var_104 = 1;
        wp::int32 var_105;
        const wp::int32 var_106 = 0;
        bool var_107;
        const wp::int32 var_108 = 1;
        const wp::int32 var_109 = 0;
        const wp::int32 var_110 = 0;
        const wp::int32 var_111 = 0;
        wp::int32 var_112;
        wp::int32 var_113;
        const wp::int32 var_114 = 1;
        bool var_115;
        //---------
        // forward
        // def step_alignment_kernel(source__lenses, rules__first_level, rules__short_step, sums, state__running, state__live, state__counts, state__max_steps, state__warps, state__scales, state__pose):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // level = state__counts[i]                                                               <L 4>
        var_1 = wp::address(var_state__counts, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // total = sums[level]                                                                    <L 5>
        var_4 = wp::address(var_sums, var_2);
        var_6 = wp::load(var_4);
        var_5 = wp::copy(var_6);
        // learn_noise(total, state__scales)                                                      <L 6>
        learn_noise_0(var_5, var_state__scales);
        // state__counts[2] = state__counts[2] + 1                                                <L 7>
        var_8 = wp::address(var_state__counts, var_7);
        var_11 = wp::load(var_8);
        var_10 = wp::add(var_11, var_9);
        wp::array_store(var_state__counts, var_12, var_10);
        // taken = state__counts[1] + 1                                                           <L 8>
        var_14 = wp::address(var_state__counts, var_13);
        var_17 = wp::load(var_14);
        var_16 = wp::add(var_17, var_15);
        // done = int(0)                                                                          <L 9>
        var_19 = wp::int(var_18);
        // pose = state__pose[0]                                                                  <L 10>
        var_21 = wp::address(var_state__pose, var_20);
        var_23 = wp::load(var_21);
        var_22 = wp::copy(var_23);
        // if total[SURFACE_COUNT] + total[BRIGHTNESS_COUNT] < float64(MIN_PIXELS):               <L 11>
        var_25 = wp::extract(var_5, var_24);
        var_27 = wp::extract(var_5, var_26);
        var_28 = wp::add(var_25, var_27);
        var_29 = 12.0;
        var_30 = (var_28 < var_29);
        if (var_30) {
            // done = 1                                                                           <L 12>
        }
        if (!var_30) {
            // x = damped_solution(total)                                                         <L 14>
            var_32 = damped_solution_0(var_5);
            // rotated = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2])                            <L 15>
            var_34 = wp::extract(var_32, var_33);
            var_36 = wp::extract(var_32, var_35);
            var_37 = wp::mul(var_34, var_36);
            var_39 = wp::extract(var_32, var_38);
            var_41 = wp::extract(var_32, var_40);
            var_42 = wp::mul(var_39, var_41);
            var_43 = wp::add(var_37, var_42);
            var_45 = wp::extract(var_32, var_44);
            var_47 = wp::extract(var_32, var_46);
            var_48 = wp::mul(var_45, var_47);
            var_49 = wp::add(var_43, var_48);
            var_50 = wp::sqrt(var_49);
            // moved = sqrt(x[3] * x[3] + x[4] * x[4] + x[5] * x[5])                              <L 16>
            var_52 = wp::extract(var_32, var_51);
            var_54 = wp::extract(var_32, var_53);
            var_55 = wp::mul(var_52, var_54);
            var_57 = wp::extract(var_32, var_56);
            var_59 = wp::extract(var_32, var_58);
            var_60 = wp::mul(var_57, var_59);
            var_61 = wp::add(var_55, var_60);
            var_63 = wp::extract(var_32, var_62);
            var_65 = wp::extract(var_32, var_64);
            var_66 = wp::mul(var_63, var_65);
            var_67 = wp::add(var_61, var_66);
            var_68 = wp::sqrt(var_67);
            // if rotated < float64(1.0) and moved < float64(2.0):                                <L 17>
            var_70 = 1.0;
            var_71 = (var_50 < var_70);
            var_69 = var_71;
            if (var_69) {
                var_72 = 2.0;
                var_73 = (var_68 < var_72);
                var_69 = var_69 && var_73;
            }
            if (var_69) {
                // pose = multiply44(small_motion(x), pose)                                       <L 18>
                var_74 = small_motion_0(var_32);
                var_75 = multiply44_0(var_74, var_22);
                // state__pose[0] = pose                                                          <L 19>
                wp::array_store(var_state__pose, var_76, var_75);
                // limit = float64(rules__short_step) / float64(source__lenses[level][0])         <L 20>
                var_77 = wp::float64(var_rules__short_step);
                var_78 = wp::address(var_source__lenses, var_2);
                var_81 = wp::load(var_78);
                var_80 = wp::extract(var_81, var_79);
                var_82 = wp::float64(var_80);
                var_83 = wp::div(var_77, var_82);
                // if taken > 1 and rotated < limit and (moved < limit):                          <L 21>
                var_86 = (var_16 > var_85);
                var_84 = var_86;
                if (var_84) {
                    var_87 = (var_50 < var_83);
                    var_84 = var_84 && var_87;
                }
                if (var_84) {
                    var_88 = (var_68 < var_83);
                    var_84 = var_84 && var_88;
                }
                if (var_84) {
                    // done = 1                                                                   <L 22>
                }
                var_90 = wp::where(var_84, var_89, var_19);
            }
            if (!var_69) {
                // done = 1                                                                       <L 24>
            }
            var_92 = wp::where(var_69, var_90, var_91);
            var_93 = wp::where(var_69, var_75, var_22);
        }
        var_94 = wp::where(var_30, var_31, var_92);
        var_95 = wp::where(var_30, var_22, var_93);
        // if taken >= state__max_steps[level]:                                                   <L 25>
        var_96 = wp::address(var_state__max_steps, var_2);
        var_98 = wp::load(var_96);
        var_97 = (var_16 >= var_98);
        if (var_97) {
            // done = 1                                                                           <L 26>
        }
        var_100 = wp::where(var_97, var_99, var_94);
        // if done == 1:                                                                          <L 27>
        var_102 = (var_100 == var_101);
        if (var_102) {
            // state__live[level] = 0                                                             <L 28>
            wp::array_store(var_state__live, var_2, var_103);
            // level = level - 1                                                                  <L 29>
            var_105 = wp::sub(var_2, var_104);
            // taken = 0                                                                          <L 30>
            // if level >= rules__first_level:                                                    <L 31>
            var_107 = (var_105 >= var_rules__first_level);
            if (var_107) {
                // state__live[level] = 1                                                         <L 32>
                wp::array_store(var_state__live, var_105, var_108);
                // state__counts[0] = level                                                       <L 33>
                wp::array_store(var_state__counts, var_109, var_105);
            }
            if (!var_107) {
                // state__running[0] = 0                                                          <L 35>
                wp::array_store(var_state__running, var_111, var_110);
            }
        }
        var_112 = wp::where(var_102, var_105, var_2);
        var_113 = wp::where(var_102, var_106, var_16);
        // state__counts[1] = taken                                                               <L 36>
        wp::array_store(var_state__counts, var_114, var_113);
        // if level >= rules__first_level:                                                        <L 37>
        var_115 = (var_112 >= var_rules__first_level);
        if (var_115) {
            // set_warps(level, source__lenses, pose, state__warps)                               <L 38>
            set_warps_0(var_112, var_source__lenses, var_95, var_state__warps);
        }
}


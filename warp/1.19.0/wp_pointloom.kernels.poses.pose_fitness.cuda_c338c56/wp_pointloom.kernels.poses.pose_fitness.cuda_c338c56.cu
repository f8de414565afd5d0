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


// <pointloom.kernels.poses.pose_fitness.sum_matches_element>:1
static CUDA_CALLABLE wp::vec_t<19, wp::float64> sum_matches_element_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_fitness__source,
    wp::array_t<wp::vec_t<3, wp::float32>> var_fitness__target,
    wp::vec_t<3, wp::float32> var_fitness__source_middle,
    wp::vec_t<3, wp::float32> var_fitness__target_middle,
    wp::array_t<wp::int64> var_nearest,
    wp::int32 var_i)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::vec_t<19, wp::float64> var_1;
    wp::int64* var_2;
    wp::int64 var_3;
    wp::int64 var_4;
    wp::int64 var_5;
    bool var_6;
    wp::vec_t<3, wp::float32>* var_7;
    wp::vec_t<3, wp::float64> var_8;
    wp::vec_t<3, wp::float32> var_9;
    wp::vec_t<3, wp::float64> var_10;
    wp::vec_t<3, wp::float64> var_11;
    wp::int32 var_12;
    wp::vec_t<3, wp::float32>* var_13;
    wp::vec_t<3, wp::float64> var_14;
    wp::vec_t<3, wp::float32> var_15;
    wp::vec_t<3, wp::float64> var_16;
    wp::vec_t<3, wp::float64> var_17;
    wp::float64 var_18;
    wp::vec_t<18, wp::float64> var_19;
    wp::int32 var_20;
    wp::int32 var_21;
    wp::float64 var_22;
    wp::float32 var_23;
    wp::float64 var_24;
    const wp::int32 var_25 = 18;
    //---------
    // forward
    // def sum_matches_element(fitness__source, fitness__target, fitness__source_middle, fitness__target_middle, nearest, i):       <L 1>
    // out = match_sums(float64(0.0))                                                         <L 2>
    var_0 = 0.0;
    var_1 = wp::vec_t<19, wp::float64>(var_0);
    // key = nearest[i]                                                                       <L 3>
    var_2 = wp::address(var_nearest, var_i);
    var_4 = wp::load(var_2);
    var_3 = wp::copy(var_4);
    // if key != int64(NO_POINT):                                                             <L 4>
    var_5 = -1ll;
    var_6 = (var_3 != var_5);
    if (var_6) {
        // p = widen(fitness__source[i]) - widen(fitness__source_middle)                      <L 5>
        var_7 = wp::address(var_fitness__source, var_i);
        var_9 = wp::load(var_7);
        var_8 = widen_0(var_9);
        var_10 = widen_0(var_fitness__source_middle);
        var_11 = wp::sub(var_8, var_10);
        // q = widen(fitness__target[key_index(key)]) - widen(fitness__target_middle)         <L 6>
        var_12 = key_index_0(var_3);
        var_13 = wp::address(var_fitness__target, var_12);
        var_15 = wp::load(var_13);
        var_14 = widen_0(var_15);
        var_16 = widen_0(var_fitness__target_middle);
        var_17 = wp::sub(var_14, var_16);
        // s = sums_of_pair(p, q, float64(1.0))                                               <L 7>
        var_18 = 1.0;
        var_19 = sums_of_pair_0(var_11, var_17, var_18);
        // for k in range(SUMS):                                                              <L 8>
        var_20 = 0;
        start_for_0:;
            if (var_20 >= 18) goto end_for_0;
            var_21 = var_20;
            var_20 += 1;
            // out[k] = s[k]                                                                  <L 9>
            var_22 = wp::extract(var_19, var_21);
            wp::assign_inplace(var_1, var_21, var_22);
            goto start_for_0;
        end_for_0:;
        // out[SUMS] = float64(key_number(key))                                               <L 10>
        var_23 = key_number_0(var_3);
        var_24 = wp::float64(var_23);
        wp::assign_inplace(var_1, var_25, var_24);
    }
    // return out                                                                             <L 11>
    return var_1;
}


// /work/main/src/pointloom/kernels/algebra/transform.py:27
static CUDA_CALLABLE void adj_widen_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float64> & adj_ret)
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


// <pointloom.kernels.poses.pose_fitness.sum_matches_element>:1
static CUDA_CALLABLE void adj_sum_matches_element_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_fitness__source,
    wp::array_t<wp::vec_t<3, wp::float32>> var_fitness__target,
    wp::vec_t<3, wp::float32> var_fitness__source_middle,
    wp::vec_t<3, wp::float32> var_fitness__target_middle,
    wp::array_t<wp::int64> var_nearest,
    wp::int32 var_i,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_fitness__source,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_fitness__target,
    wp::vec_t<3, wp::float32> & adj_fitness__source_middle,
    wp::vec_t<3, wp::float32> & adj_fitness__target_middle,
    wp::array_t<wp::int64> & adj_nearest,
    wp::int32 & adj_i,
    wp::vec_t<19, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void sum_matches_fold_tiles_28f1f7c0_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_starts_,
    wp::array_t<wp::int32> var_live_,
    wp::array_t<wp::vec_t<19, wp::float64>> var_partials_,
    wp::array_t<wp::vec_t<19, wp::float64>> var_out_)
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
        wp::vec_t<19, wp::float64> var_3;
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
        wp::vec_t<19, wp::float64>* var_16;
        wp::vec_t<19, wp::float64> var_17;
        wp::vec_t<19, wp::float64> var_18;
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
        wp::vec_t<3, wp::float64> var_129;
        const bool var_130 = true;
        wp::tile_register_t<wp::vec_t<3, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_131 = wp::tile_register_t<wp::vec_t<3, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<3, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_132 = wp::tile_alloc_empty<wp::vec_t<3, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_133 = 0;
        wp::vec_t<3, wp::float64> var_134;
        const wp::int32 var_135 = 0;
        wp::float64 var_136;
        const wp::int32 var_137 = 16;
        const wp::int32 var_138 = 1;
        wp::float64 var_139;
        const wp::int32 var_140 = 17;
        const wp::int32 var_141 = 2;
        wp::float64 var_142;
        const wp::int32 var_143 = 18;
        const wp::int32 var_144 = 256;
        wp::int32 var_145;
        const wp::int32 var_146 = 0;
        bool var_147;
        //---------
        // forward
        // def sum_matches_fold_tiles(starts_, live_, partials_, out_):                           <L 1>
        // i_ = wp.tid()                                                                          <L 2>
        var_0 = builtin_tid1d();
        // s_ = i_ // 256                                                                         <L 3>
        var_2 = wp::floordiv(var_0, var_1);
        // value_ = vector_()                                                                     <L 4>
        var_3 = wp::vec_t<19, wp::float64>();
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
        // part_16 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[16], value_[17], value_[18]), preserve_type=True)), 0)       <L 27>
        var_124 = wp::extract(var_3, var_123);
        var_126 = wp::extract(var_3, var_125);
        var_128 = wp::extract(var_3, var_127);
        var_129 = wp::vec_t<3, wp::float64>(var_124, var_126, var_128);
        var_131 = wp::tile<wp::vec_t<3, wp::float64>>(var_129);
        var_132 = wp::tile_sum(var_131);
        var_134 = wp::tile_extract(var_132, var_133);
        // value_[16] = part_16[0]                                                                <L 28>
        var_136 = wp::extract(var_134, var_135);
        wp::assign_inplace(var_3, var_137, var_136);
        // value_[17] = part_16[1]                                                                <L 29>
        var_139 = wp::extract(var_134, var_138);
        wp::assign_inplace(var_3, var_140, var_139);
        // value_[18] = part_16[2]                                                                <L 30>
        var_142 = wp::extract(var_134, var_141);
        wp::assign_inplace(var_3, var_143, var_142);
        // if i_ % 256 == 0:                                                                      <L 31>
        var_145 = wp::mod(var_0, var_144);
        var_147 = (var_145 == var_146);
        if (var_147) {
            // out_[s_] = value_                                                                  <L 32>
            wp::array_store(var_out_, var_2, var_3);
        }
}



extern "C" __global__ void sum_matches_tiles_3904ff9c_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_fitness__source,
    wp::array_t<wp::vec_t<3, wp::float32>> var_fitness__target,
    wp::vec_t<3, wp::float32> var_fitness__source_middle,
    wp::vec_t<3, wp::float32> var_fitness__target_middle,
    wp::array_t<wp::int64> var_nearest,
    wp::array_t<wp::int32> var_firsts_,
    wp::array_t<wp::int32> var_lasts_,
    wp::array_t<wp::int32> var_owners_,
    wp::array_t<wp::int32> var_live_,
    wp::array_t<wp::vec_t<19, wp::float64>> var_partials_)
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
        wp::vec_t<19, wp::float64> var_3;
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
        wp::vec_t<19, wp::float64> var_20;
        wp::vec_t<19, wp::float64> var_21;
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
        wp::vec_t<3, wp::float64> var_132;
        const bool var_133 = true;
        wp::tile_register_t<wp::vec_t<3, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>> var_134 = wp::tile_register_t<wp::vec_t<3, wp::float64>,wp::tile_layout_register_t<wp::tile_shape_t<256>>>{};
        wp::tile_shared_t<wp::vec_t<3, wp::float64>,wp::tile_layout_strided_t<wp::tile_shape_t<1>, wp::tile_stride_t<1>>, true> var_135 = wp::tile_alloc_empty<wp::vec_t<3, wp::float64>,wp::tile_shape_t<1>,wp::tile_stride_t<1>,false>();
        const wp::int32 var_136 = 0;
        wp::vec_t<3, wp::float64> var_137;
        const wp::int32 var_138 = 0;
        wp::float64 var_139;
        const wp::int32 var_140 = 16;
        const wp::int32 var_141 = 1;
        wp::float64 var_142;
        const wp::int32 var_143 = 17;
        const wp::int32 var_144 = 2;
        wp::float64 var_145;
        const wp::int32 var_146 = 18;
        const wp::int32 var_147 = 256;
        wp::int32 var_148;
        const wp::int32 var_149 = 0;
        bool var_150;
        //---------
        // forward
        // def sum_matches_tiles(fitness__source, fitness__target, fitness__source_middle, fitness__target_middle, nearest, firsts_, lasts_, owners_, live_, partials_):       <L 1>
        // i_ = wp.tid()                                                                          <L 2>
        var_0 = builtin_tid1d();
        // b_ = i_ // 256                                                                         <L 3>
        var_2 = wp::floordiv(var_0, var_1);
        // value_ = vector_()                                                                     <L 4>
        var_3 = wp::vec_t<19, wp::float64>();
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
                // value_ += element_(fitness__source, fitness__target, fitness__source_middle, fitness__target_middle, nearest, j_)       <L 7>
                var_20 = sum_matches_element_0(var_fitness__source, var_fitness__target, var_fitness__source_middle, var_fitness__target_middle, var_nearest, var_19);
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
        // part_16 = wp.tile_extract(wp.tile_sum(wp.tile(wp.vector(value_[16], value_[17], value_[18]), preserve_type=True)), 0)       <L 28>
        var_127 = wp::extract(var_3, var_126);
        var_129 = wp::extract(var_3, var_128);
        var_131 = wp::extract(var_3, var_130);
        var_132 = wp::vec_t<3, wp::float64>(var_127, var_129, var_131);
        var_134 = wp::tile<wp::vec_t<3, wp::float64>>(var_132);
        var_135 = wp::tile_sum(var_134);
        var_137 = wp::tile_extract(var_135, var_136);
        // value_[16] = part_16[0]                                                                <L 29>
        var_139 = wp::extract(var_137, var_138);
        wp::assign_inplace(var_3, var_140, var_139);
        // value_[17] = part_16[1]                                                                <L 30>
        var_142 = wp::extract(var_137, var_141);
        wp::assign_inplace(var_3, var_143, var_142);
        // value_[18] = part_16[2]                                                                <L 31>
        var_145 = wp::extract(var_137, var_144);
        wp::assign_inplace(var_3, var_146, var_145);
        // if i_ % 256 == 0:                                                                      <L 32>
        var_148 = wp::mod(var_0, var_147);
        var_150 = (var_148 == var_149);
        if (var_150) {
            // partials_[b_] = value_                                                             <L 33>
            wp::array_store(var_partials_, var_2, var_3);
        }
}


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


// <pointloom.kernels.poses.pose_search.probe_of>:1
static CUDA_CALLABLE wp::vec_t<12, wp::float64> probe_of_0(
    wp::mat_t<4, 4, wp::float64> var_pose,
    wp::float64 var_size)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::vec_t<12, wp::float64> var_1;
    const wp::int32 var_2 = 0;
    const wp::int32 var_3 = 3;
    wp::float64 var_4;
    const wp::int32 var_5 = 0;
    wp::float64 var_6;
    wp::float64 var_7;
    const wp::int32 var_8 = 3;
    wp::float64 var_9;
    wp::float64 var_10;
    const wp::int32 var_11 = 3;
    wp::int32 var_12;
    const wp::int32 var_13 = 3;
    wp::int32 var_14;
    wp::int32 var_15;
    const wp::int32 var_16 = 1;
    wp::float64 var_17;
    wp::float64 var_18;
    const wp::int32 var_19 = 3;
    wp::float64 var_20;
    wp::float64 var_21;
    const wp::int32 var_22 = 3;
    wp::int32 var_23;
    const wp::int32 var_24 = 3;
    wp::int32 var_25;
    wp::int32 var_26;
    const wp::int32 var_27 = 2;
    wp::float64 var_28;
    wp::float64 var_29;
    const wp::int32 var_30 = 3;
    wp::float64 var_31;
    wp::float64 var_32;
    const wp::int32 var_33 = 3;
    wp::int32 var_34;
    const wp::int32 var_35 = 3;
    wp::int32 var_36;
    wp::int32 var_37;
    const wp::int32 var_38 = 1;
    const wp::int32 var_39 = 3;
    wp::float64 var_40;
    const wp::int32 var_41 = 0;
    wp::float64 var_42;
    wp::float64 var_43;
    const wp::int32 var_44 = 3;
    wp::float64 var_45;
    wp::float64 var_46;
    const wp::int32 var_47 = 3;
    wp::int32 var_48;
    const wp::int32 var_49 = 3;
    wp::int32 var_50;
    wp::int32 var_51;
    const wp::int32 var_52 = 1;
    wp::float64 var_53;
    wp::float64 var_54;
    const wp::int32 var_55 = 3;
    wp::float64 var_56;
    wp::float64 var_57;
    const wp::int32 var_58 = 3;
    wp::int32 var_59;
    const wp::int32 var_60 = 3;
    wp::int32 var_61;
    wp::int32 var_62;
    const wp::int32 var_63 = 2;
    wp::float64 var_64;
    wp::float64 var_65;
    const wp::int32 var_66 = 3;
    wp::float64 var_67;
    wp::float64 var_68;
    const wp::int32 var_69 = 3;
    wp::int32 var_70;
    const wp::int32 var_71 = 3;
    wp::int32 var_72;
    wp::int32 var_73;
    const wp::int32 var_74 = 2;
    const wp::int32 var_75 = 3;
    wp::float64 var_76;
    const wp::int32 var_77 = 0;
    wp::float64 var_78;
    wp::float64 var_79;
    const wp::int32 var_80 = 3;
    wp::float64 var_81;
    wp::float64 var_82;
    const wp::int32 var_83 = 3;
    wp::int32 var_84;
    const wp::int32 var_85 = 3;
    wp::int32 var_86;
    wp::int32 var_87;
    const wp::int32 var_88 = 1;
    wp::float64 var_89;
    wp::float64 var_90;
    const wp::int32 var_91 = 3;
    wp::float64 var_92;
    wp::float64 var_93;
    const wp::int32 var_94 = 3;
    wp::int32 var_95;
    const wp::int32 var_96 = 3;
    wp::int32 var_97;
    wp::int32 var_98;
    const wp::int32 var_99 = 2;
    wp::float64 var_100;
    wp::float64 var_101;
    const wp::int32 var_102 = 3;
    wp::float64 var_103;
    wp::float64 var_104;
    const wp::int32 var_105 = 3;
    wp::int32 var_106;
    const wp::int32 var_107 = 3;
    wp::int32 var_108;
    wp::int32 var_109;
    //---------
    // forward
    // def probe_of(pose, size):                                                              <L 1>
    // p = probe(float64(0.0))                                                                <L 3>
    var_0 = 0.0;
    var_1 = wp::vec_t<12, wp::float64>(var_0);
    // for row in range(3):                                                                   <L 4>
    // p[row] = pose[row, 3]                                                                  <L 5>
    var_4 = wp::extract(var_pose, var_2, var_3);
    wp::assign_inplace(var_1, var_2, var_4);
    // for axis in range(3):                                                                  <L 6>
    // p[3 * axis + 3 + row] = pose[row, axis] * size + pose[row, 3]                          <L 7>
    var_6 = wp::extract(var_pose, var_2, var_5);
    var_7 = wp::mul(var_6, var_size);
    var_9 = wp::extract(var_pose, var_2, var_8);
    var_10 = wp::add(var_7, var_9);
    var_12 = wp::mul(var_11, var_5);
    var_14 = wp::add(var_12, var_13);
    var_15 = wp::add(var_14, var_2);
    wp::assign_inplace(var_1, var_15, var_10);
    var_17 = wp::extract(var_pose, var_2, var_16);
    var_18 = wp::mul(var_17, var_size);
    var_20 = wp::extract(var_pose, var_2, var_19);
    var_21 = wp::add(var_18, var_20);
    var_23 = wp::mul(var_22, var_16);
    var_25 = wp::add(var_23, var_24);
    var_26 = wp::add(var_25, var_2);
    wp::assign_inplace(var_1, var_26, var_21);
    var_28 = wp::extract(var_pose, var_2, var_27);
    var_29 = wp::mul(var_28, var_size);
    var_31 = wp::extract(var_pose, var_2, var_30);
    var_32 = wp::add(var_29, var_31);
    var_34 = wp::mul(var_33, var_27);
    var_36 = wp::add(var_34, var_35);
    var_37 = wp::add(var_36, var_2);
    wp::assign_inplace(var_1, var_37, var_32);
    // p[row] = pose[row, 3]                                                                  <L 5>
    var_40 = wp::extract(var_pose, var_38, var_39);
    wp::assign_inplace(var_1, var_38, var_40);
    // for axis in range(3):                                                                  <L 6>
    // p[3 * axis + 3 + row] = pose[row, axis] * size + pose[row, 3]                          <L 7>
    var_42 = wp::extract(var_pose, var_38, var_41);
    var_43 = wp::mul(var_42, var_size);
    var_45 = wp::extract(var_pose, var_38, var_44);
    var_46 = wp::add(var_43, var_45);
    var_48 = wp::mul(var_47, var_41);
    var_50 = wp::add(var_48, var_49);
    var_51 = wp::add(var_50, var_38);
    wp::assign_inplace(var_1, var_51, var_46);
    var_53 = wp::extract(var_pose, var_38, var_52);
    var_54 = wp::mul(var_53, var_size);
    var_56 = wp::extract(var_pose, var_38, var_55);
    var_57 = wp::add(var_54, var_56);
    var_59 = wp::mul(var_58, var_52);
    var_61 = wp::add(var_59, var_60);
    var_62 = wp::add(var_61, var_38);
    wp::assign_inplace(var_1, var_62, var_57);
    var_64 = wp::extract(var_pose, var_38, var_63);
    var_65 = wp::mul(var_64, var_size);
    var_67 = wp::extract(var_pose, var_38, var_66);
    var_68 = wp::add(var_65, var_67);
    var_70 = wp::mul(var_69, var_63);
    var_72 = wp::add(var_70, var_71);
    var_73 = wp::add(var_72, var_38);
    wp::assign_inplace(var_1, var_73, var_68);
    // p[row] = pose[row, 3]                                                                  <L 5>
    var_76 = wp::extract(var_pose, var_74, var_75);
    wp::assign_inplace(var_1, var_74, var_76);
    // for axis in range(3):                                                                  <L 6>
    // p[3 * axis + 3 + row] = pose[row, axis] * size + pose[row, 3]                          <L 7>
    var_78 = wp::extract(var_pose, var_74, var_77);
    var_79 = wp::mul(var_78, var_size);
    var_81 = wp::extract(var_pose, var_74, var_80);
    var_82 = wp::add(var_79, var_81);
    var_84 = wp::mul(var_83, var_77);
    var_86 = wp::add(var_84, var_85);
    var_87 = wp::add(var_86, var_74);
    wp::assign_inplace(var_1, var_87, var_82);
    var_89 = wp::extract(var_pose, var_74, var_88);
    var_90 = wp::mul(var_89, var_size);
    var_92 = wp::extract(var_pose, var_74, var_91);
    var_93 = wp::add(var_90, var_92);
    var_95 = wp::mul(var_94, var_88);
    var_97 = wp::add(var_95, var_96);
    var_98 = wp::add(var_97, var_74);
    wp::assign_inplace(var_1, var_98, var_93);
    var_100 = wp::extract(var_pose, var_74, var_99);
    var_101 = wp::mul(var_100, var_size);
    var_103 = wp::extract(var_pose, var_74, var_102);
    var_104 = wp::add(var_101, var_103);
    var_106 = wp::mul(var_105, var_99);
    var_108 = wp::add(var_106, var_107);
    var_109 = wp::add(var_108, var_74);
    wp::assign_inplace(var_1, var_109, var_104);
    // return p                                                                               <L 8>
    return var_1;
}


// <pointloom.kernels.poses.pose_search.is_apart>:1
static CUDA_CALLABLE wp::int32 is_apart_0(
    wp::vec_t<12, wp::float64> var_p,
    wp::int32 var_k,
    wp::array_t<wp::float64> var_probes,
    wp::float64 var_limit)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::float64 var_1;
    const wp::int32 var_2 = 0;
    const wp::int32 var_3 = 3;
    wp::int32 var_4;
    wp::float64 var_5;
    const wp::int32 var_6 = 12;
    wp::int32 var_7;
    const wp::int32 var_8 = 3;
    wp::int32 var_9;
    wp::int32 var_10;
    wp::float64* var_11;
    wp::float64 var_12;
    wp::float64 var_13;
    const wp::int32 var_14 = 3;
    wp::int32 var_15;
    const wp::int32 var_16 = 1;
    wp::int32 var_17;
    wp::float64 var_18;
    wp::int32 var_19;
    const wp::int32 var_20 = 3;
    wp::int32 var_21;
    wp::int32 var_22;
    const wp::int32 var_23 = 1;
    wp::int32 var_24;
    wp::float64* var_25;
    wp::float64 var_26;
    wp::float64 var_27;
    const wp::int32 var_28 = 3;
    wp::int32 var_29;
    const wp::int32 var_30 = 2;
    wp::int32 var_31;
    wp::float64 var_32;
    wp::int32 var_33;
    const wp::int32 var_34 = 3;
    wp::int32 var_35;
    wp::int32 var_36;
    const wp::int32 var_37 = 2;
    wp::int32 var_38;
    wp::float64* var_39;
    wp::float64 var_40;
    wp::float64 var_41;
    wp::float64 var_42;
    wp::float64 var_43;
    wp::float64 var_44;
    wp::float64 var_45;
    wp::float64 var_46;
    wp::float64 var_47;
    wp::float64 var_48;
    const wp::int32 var_49 = 1;
    const wp::int32 var_50 = 3;
    wp::int32 var_51;
    wp::float64 var_52;
    wp::int32 var_53;
    const wp::int32 var_54 = 3;
    wp::int32 var_55;
    wp::int32 var_56;
    wp::float64* var_57;
    wp::float64 var_58;
    wp::float64 var_59;
    const wp::int32 var_60 = 3;
    wp::int32 var_61;
    const wp::int32 var_62 = 1;
    wp::int32 var_63;
    wp::float64 var_64;
    wp::int32 var_65;
    const wp::int32 var_66 = 3;
    wp::int32 var_67;
    wp::int32 var_68;
    const wp::int32 var_69 = 1;
    wp::int32 var_70;
    wp::float64* var_71;
    wp::float64 var_72;
    wp::float64 var_73;
    const wp::int32 var_74 = 3;
    wp::int32 var_75;
    const wp::int32 var_76 = 2;
    wp::int32 var_77;
    wp::float64 var_78;
    wp::int32 var_79;
    const wp::int32 var_80 = 3;
    wp::int32 var_81;
    wp::int32 var_82;
    const wp::int32 var_83 = 2;
    wp::int32 var_84;
    wp::float64* var_85;
    wp::float64 var_86;
    wp::float64 var_87;
    wp::float64 var_88;
    wp::float64 var_89;
    wp::float64 var_90;
    wp::float64 var_91;
    wp::float64 var_92;
    wp::float64 var_93;
    wp::float64 var_94;
    const wp::int32 var_95 = 2;
    const wp::int32 var_96 = 3;
    wp::int32 var_97;
    wp::float64 var_98;
    wp::int32 var_99;
    const wp::int32 var_100 = 3;
    wp::int32 var_101;
    wp::int32 var_102;
    wp::float64* var_103;
    wp::float64 var_104;
    wp::float64 var_105;
    const wp::int32 var_106 = 3;
    wp::int32 var_107;
    const wp::int32 var_108 = 1;
    wp::int32 var_109;
    wp::float64 var_110;
    wp::int32 var_111;
    const wp::int32 var_112 = 3;
    wp::int32 var_113;
    wp::int32 var_114;
    const wp::int32 var_115 = 1;
    wp::int32 var_116;
    wp::float64* var_117;
    wp::float64 var_118;
    wp::float64 var_119;
    const wp::int32 var_120 = 3;
    wp::int32 var_121;
    const wp::int32 var_122 = 2;
    wp::int32 var_123;
    wp::float64 var_124;
    wp::int32 var_125;
    const wp::int32 var_126 = 3;
    wp::int32 var_127;
    wp::int32 var_128;
    const wp::int32 var_129 = 2;
    wp::int32 var_130;
    wp::float64* var_131;
    wp::float64 var_132;
    wp::float64 var_133;
    wp::float64 var_134;
    wp::float64 var_135;
    wp::float64 var_136;
    wp::float64 var_137;
    wp::float64 var_138;
    wp::float64 var_139;
    wp::float64 var_140;
    const wp::int32 var_141 = 3;
    const wp::int32 var_142 = 3;
    wp::int32 var_143;
    wp::float64 var_144;
    wp::int32 var_145;
    const wp::int32 var_146 = 3;
    wp::int32 var_147;
    wp::int32 var_148;
    wp::float64* var_149;
    wp::float64 var_150;
    wp::float64 var_151;
    const wp::int32 var_152 = 3;
    wp::int32 var_153;
    const wp::int32 var_154 = 1;
    wp::int32 var_155;
    wp::float64 var_156;
    wp::int32 var_157;
    const wp::int32 var_158 = 3;
    wp::int32 var_159;
    wp::int32 var_160;
    const wp::int32 var_161 = 1;
    wp::int32 var_162;
    wp::float64* var_163;
    wp::float64 var_164;
    wp::float64 var_165;
    const wp::int32 var_166 = 3;
    wp::int32 var_167;
    const wp::int32 var_168 = 2;
    wp::int32 var_169;
    wp::float64 var_170;
    wp::int32 var_171;
    const wp::int32 var_172 = 3;
    wp::int32 var_173;
    wp::int32 var_174;
    const wp::int32 var_175 = 2;
    wp::int32 var_176;
    wp::float64* var_177;
    wp::float64 var_178;
    wp::float64 var_179;
    wp::float64 var_180;
    wp::float64 var_181;
    wp::float64 var_182;
    wp::float64 var_183;
    wp::float64 var_184;
    wp::float64 var_185;
    wp::float64 var_186;
    bool var_187;
    bool var_188;
    wp::float64 var_189;
    bool var_190;
    const wp::int32 var_191 = 1;
    const wp::int32 var_192 = 0;
    wp::int32 var_193;
    //---------
    // forward
    // def is_apart(p, k, probes, limit):                                                     <L 1>
    // farthest = float64(0.0)                                                                <L 3>
    var_0 = 0.0;
    // total = float64(0.0)                                                                   <L 4>
    var_1 = 0.0;
    // for point in range(4):                                                                 <L 5>
    // x = p[3 * point] - probes[k * PROBE + 3 * point]                                       <L 6>
    var_4 = wp::mul(var_3, var_2);
    var_5 = wp::extract(var_p, var_4);
    var_7 = wp::mul(var_k, var_6);
    var_9 = wp::mul(var_8, var_2);
    var_10 = wp::add(var_7, var_9);
    var_11 = wp::address(var_probes, var_10);
    var_13 = wp::load(var_11);
    var_12 = wp::sub(var_5, var_13);
    // y = p[3 * point + 1] - probes[k * PROBE + 3 * point + 1]                               <L 7>
    var_15 = wp::mul(var_14, var_2);
    var_17 = wp::add(var_15, var_16);
    var_18 = wp::extract(var_p, var_17);
    var_19 = wp::mul(var_k, var_6);
    var_21 = wp::mul(var_20, var_2);
    var_22 = wp::add(var_19, var_21);
    var_24 = wp::add(var_22, var_23);
    var_25 = wp::address(var_probes, var_24);
    var_27 = wp::load(var_25);
    var_26 = wp::sub(var_18, var_27);
    // z = p[3 * point + 2] - probes[k * PROBE + 3 * point + 2]                               <L 8>
    var_29 = wp::mul(var_28, var_2);
    var_31 = wp::add(var_29, var_30);
    var_32 = wp::extract(var_p, var_31);
    var_33 = wp::mul(var_k, var_6);
    var_35 = wp::mul(var_34, var_2);
    var_36 = wp::add(var_33, var_35);
    var_38 = wp::add(var_36, var_37);
    var_39 = wp::address(var_probes, var_38);
    var_41 = wp::load(var_39);
    var_40 = wp::sub(var_32, var_41);
    // square = x * x + y * y + z * z                                                         <L 9>
    var_42 = wp::mul(var_12, var_12);
    var_43 = wp::mul(var_26, var_26);
    var_44 = wp::add(var_42, var_43);
    var_45 = wp::mul(var_40, var_40);
    var_46 = wp::add(var_44, var_45);
    // farthest = max(farthest, square)                                                       <L 10>
    var_47 = wp::max(var_0, var_46);
    // total += square                                                                        <L 11>
    var_48 = wp::add(var_1, var_46);
    // x = p[3 * point] - probes[k * PROBE + 3 * point]                                       <L 6>
    var_51 = wp::mul(var_50, var_49);
    var_52 = wp::extract(var_p, var_51);
    var_53 = wp::mul(var_k, var_6);
    var_55 = wp::mul(var_54, var_49);
    var_56 = wp::add(var_53, var_55);
    var_57 = wp::address(var_probes, var_56);
    var_59 = wp::load(var_57);
    var_58 = wp::sub(var_52, var_59);
    // y = p[3 * point + 1] - probes[k * PROBE + 3 * point + 1]                               <L 7>
    var_61 = wp::mul(var_60, var_49);
    var_63 = wp::add(var_61, var_62);
    var_64 = wp::extract(var_p, var_63);
    var_65 = wp::mul(var_k, var_6);
    var_67 = wp::mul(var_66, var_49);
    var_68 = wp::add(var_65, var_67);
    var_70 = wp::add(var_68, var_69);
    var_71 = wp::address(var_probes, var_70);
    var_73 = wp::load(var_71);
    var_72 = wp::sub(var_64, var_73);
    // z = p[3 * point + 2] - probes[k * PROBE + 3 * point + 2]                               <L 8>
    var_75 = wp::mul(var_74, var_49);
    var_77 = wp::add(var_75, var_76);
    var_78 = wp::extract(var_p, var_77);
    var_79 = wp::mul(var_k, var_6);
    var_81 = wp::mul(var_80, var_49);
    var_82 = wp::add(var_79, var_81);
    var_84 = wp::add(var_82, var_83);
    var_85 = wp::address(var_probes, var_84);
    var_87 = wp::load(var_85);
    var_86 = wp::sub(var_78, var_87);
    // square = x * x + y * y + z * z                                                         <L 9>
    var_88 = wp::mul(var_58, var_58);
    var_89 = wp::mul(var_72, var_72);
    var_90 = wp::add(var_88, var_89);
    var_91 = wp::mul(var_86, var_86);
    var_92 = wp::add(var_90, var_91);
    // farthest = max(farthest, square)                                                       <L 10>
    var_93 = wp::max(var_47, var_92);
    // total += square                                                                        <L 11>
    var_94 = wp::add(var_48, var_92);
    // x = p[3 * point] - probes[k * PROBE + 3 * point]                                       <L 6>
    var_97 = wp::mul(var_96, var_95);
    var_98 = wp::extract(var_p, var_97);
    var_99 = wp::mul(var_k, var_6);
    var_101 = wp::mul(var_100, var_95);
    var_102 = wp::add(var_99, var_101);
    var_103 = wp::address(var_probes, var_102);
    var_105 = wp::load(var_103);
    var_104 = wp::sub(var_98, var_105);
    // y = p[3 * point + 1] - probes[k * PROBE + 3 * point + 1]                               <L 7>
    var_107 = wp::mul(var_106, var_95);
    var_109 = wp::add(var_107, var_108);
    var_110 = wp::extract(var_p, var_109);
    var_111 = wp::mul(var_k, var_6);
    var_113 = wp::mul(var_112, var_95);
    var_114 = wp::add(var_111, var_113);
    var_116 = wp::add(var_114, var_115);
    var_117 = wp::address(var_probes, var_116);
    var_119 = wp::load(var_117);
    var_118 = wp::sub(var_110, var_119);
    // z = p[3 * point + 2] - probes[k * PROBE + 3 * point + 2]                               <L 8>
    var_121 = wp::mul(var_120, var_95);
    var_123 = wp::add(var_121, var_122);
    var_124 = wp::extract(var_p, var_123);
    var_125 = wp::mul(var_k, var_6);
    var_127 = wp::mul(var_126, var_95);
    var_128 = wp::add(var_125, var_127);
    var_130 = wp::add(var_128, var_129);
    var_131 = wp::address(var_probes, var_130);
    var_133 = wp::load(var_131);
    var_132 = wp::sub(var_124, var_133);
    // square = x * x + y * y + z * z                                                         <L 9>
    var_134 = wp::mul(var_104, var_104);
    var_135 = wp::mul(var_118, var_118);
    var_136 = wp::add(var_134, var_135);
    var_137 = wp::mul(var_132, var_132);
    var_138 = wp::add(var_136, var_137);
    // farthest = max(farthest, square)                                                       <L 10>
    var_139 = wp::max(var_93, var_138);
    // total += square                                                                        <L 11>
    var_140 = wp::add(var_94, var_138);
    // x = p[3 * point] - probes[k * PROBE + 3 * point]                                       <L 6>
    var_143 = wp::mul(var_142, var_141);
    var_144 = wp::extract(var_p, var_143);
    var_145 = wp::mul(var_k, var_6);
    var_147 = wp::mul(var_146, var_141);
    var_148 = wp::add(var_145, var_147);
    var_149 = wp::address(var_probes, var_148);
    var_151 = wp::load(var_149);
    var_150 = wp::sub(var_144, var_151);
    // y = p[3 * point + 1] - probes[k * PROBE + 3 * point + 1]                               <L 7>
    var_153 = wp::mul(var_152, var_141);
    var_155 = wp::add(var_153, var_154);
    var_156 = wp::extract(var_p, var_155);
    var_157 = wp::mul(var_k, var_6);
    var_159 = wp::mul(var_158, var_141);
    var_160 = wp::add(var_157, var_159);
    var_162 = wp::add(var_160, var_161);
    var_163 = wp::address(var_probes, var_162);
    var_165 = wp::load(var_163);
    var_164 = wp::sub(var_156, var_165);
    // z = p[3 * point + 2] - probes[k * PROBE + 3 * point + 2]                               <L 8>
    var_167 = wp::mul(var_166, var_141);
    var_169 = wp::add(var_167, var_168);
    var_170 = wp::extract(var_p, var_169);
    var_171 = wp::mul(var_k, var_6);
    var_173 = wp::mul(var_172, var_141);
    var_174 = wp::add(var_171, var_173);
    var_176 = wp::add(var_174, var_175);
    var_177 = wp::address(var_probes, var_176);
    var_179 = wp::load(var_177);
    var_178 = wp::sub(var_170, var_179);
    // square = x * x + y * y + z * z                                                         <L 9>
    var_180 = wp::mul(var_150, var_150);
    var_181 = wp::mul(var_164, var_164);
    var_182 = wp::add(var_180, var_181);
    var_183 = wp::mul(var_178, var_178);
    var_184 = wp::add(var_182, var_183);
    // farthest = max(farthest, square)                                                       <L 10>
    var_185 = wp::max(var_139, var_184);
    // total += square                                                                        <L 11>
    var_186 = wp::add(var_140, var_184);
    // return 1 if farthest > limit and total >= float64(0.0) else 0                          <L 12>
    var_188 = (var_185 > var_limit);
    var_187 = var_188;
    if (var_187) {
        var_189 = 0.0;
        var_190 = (var_186 >= var_189);
        var_187 = var_187 && var_190;
    }
    if (var_187) {
    }
    if (!var_187) {
    }
    var_193 = wp::where(var_187, var_191, var_192);
    return var_193;
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:158
static CUDA_CALLABLE wp::int32 _ballot_0(
    wp::int32 flag)
{
return (int)__ballot_sync(0xffffffffu, flag != 0);}


// /work/main/src/pointloom/kernels/search/tree_walk.py:20
static CUDA_CALLABLE wp::int32 lowest_bit_0(
    wp::int32 var_bits)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32 var_1;
    const wp::int32 var_2 = 1;
    wp::int32 var_3;
    wp::int32 var_4;
    //---------
    // forward
    // def lowest_bit(bits: int) -> int:                                                      <L 21>
    // return bit_count((bits & (-bits)) - 1)                                                 <L 22>
    var_0 = wp::neg(var_bits);
    var_1 = wp::bit_and(var_bits, var_0);
    var_3 = wp::sub(var_1, var_2);
    var_4 = wp::bit_count(var_3);
    return var_4;
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:186
static CUDA_CALLABLE void _sync_lanes_0(
    )
{
__syncwarp();}


// <pointloom.kernels.poses.pose_search.probe_of>:1
static CUDA_CALLABLE void adj_probe_of_0(
    wp::mat_t<4, 4, wp::float64> var_pose,
    wp::float64 var_size,
    wp::mat_t<4, 4, wp::float64> & adj_pose,
    wp::float64 & adj_size,
    wp::vec_t<12, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.poses.pose_search.is_apart>:1
static CUDA_CALLABLE void adj_is_apart_0(
    wp::vec_t<12, wp::float64> var_p,
    wp::int32 var_k,
    wp::array_t<wp::float64> var_probes,
    wp::float64 var_limit,
    wp::vec_t<12, wp::float64> & adj_p,
    wp::int32 & adj_k,
    wp::array_t<wp::float64> & adj_probes,
    wp::float64 & adj_limit,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:158
static CUDA_CALLABLE void adj__ballot_0(
    wp::int32 flag,
    wp::int32 & adj_flag,
    wp::int32 & adj_ret)
{
}


// /work/main/src/pointloom/kernels/search/tree_walk.py:20
static CUDA_CALLABLE void adj_lowest_bit_0(
    wp::int32 var_bits,
    wp::int32 & adj_bits,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:186
static CUDA_CALLABLE void adj__sync_lanes_0(
    )
{
}



extern "C" __global__ void select_distinct_in_lanes_kernel_869cff6d_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_poses,
    wp::array_t<wp::int32> var_scores,
    wp::array_t<wp::int32> var_order,
    wp::float64 var_size,
    wp::float64 var_limit,
    wp::array_t<wp::float64> var_probes,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_distinct,
    wp::array_t<wp::int32> var_distinct_count)
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
        wp::shape_t* var_3;
        const wp::int32 var_4 = 0;
        wp::int32 var_5;
        wp::shape_t var_6;
        const wp::int32 var_7 = 2048;
        wp::int32 var_8;
        const wp::int32 var_9 = 0;
        wp::int32 var_10;
        bool var_11;
        bool var_12;
        const wp::int32 var_13 = 16;
        bool var_14;
        const wp::int32 var_15 = -1;
        wp::int32 var_16;
        wp::float64 var_17;
        wp::vec_t<12, wp::float64> var_18;
        wp::int32 var_19;
        bool var_20;
        wp::int32 var_21;
        wp::int32* var_22;
        wp::int32 var_23;
        wp::int32 var_24;
        wp::int32* var_25;
        const wp::int32 var_26 = -1;
        bool var_27;
        wp::int32 var_28;
        const wp::int32 var_29 = -1;
        wp::mat_t<4, 4, wp::float64>* var_30;
        wp::vec_t<12, wp::float64> var_31;
        wp::mat_t<4, 4, wp::float64> var_32;
        wp::int32 var_33;
        wp::vec_t<12, wp::float64> var_34;
        wp::int32 var_35;
        wp::vec_t<12, wp::float64> var_36;
        wp::range_t var_37;
        wp::int32 var_38;
        const wp::int32 var_39 = 0;
        bool var_40;
        wp::int32 var_41;
        const wp::int32 var_42 = 0;
        bool var_43;
        const wp::int32 var_44 = -1;
        wp::int32 var_45;
        wp::int32 var_46;
        const wp::int32 var_47 = 0;
        bool var_48;
        const wp::int32 var_49 = 1;
        const wp::int32 var_50 = 0;
        wp::int32 var_51;
        wp::int32 var_52;
        bool var_53;
        const wp::int32 var_54 = 0;
        bool var_55;
        bool var_56;
        wp::int32 var_57;
        bool var_58;
        const wp::int32 var_59 = 0;
        wp::float64 var_60;
        const wp::int32 var_61 = 12;
        wp::int32 var_62;
        wp::int32 var_63;
        const wp::int32 var_64 = 1;
        wp::float64 var_65;
        wp::int32 var_66;
        wp::int32 var_67;
        const wp::int32 var_68 = 2;
        wp::float64 var_69;
        wp::int32 var_70;
        wp::int32 var_71;
        const wp::int32 var_72 = 3;
        wp::float64 var_73;
        wp::int32 var_74;
        wp::int32 var_75;
        const wp::int32 var_76 = 4;
        wp::float64 var_77;
        wp::int32 var_78;
        wp::int32 var_79;
        const wp::int32 var_80 = 5;
        wp::float64 var_81;
        wp::int32 var_82;
        wp::int32 var_83;
        const wp::int32 var_84 = 6;
        wp::float64 var_85;
        wp::int32 var_86;
        wp::int32 var_87;
        const wp::int32 var_88 = 7;
        wp::float64 var_89;
        wp::int32 var_90;
        wp::int32 var_91;
        const wp::int32 var_92 = 8;
        wp::float64 var_93;
        wp::int32 var_94;
        wp::int32 var_95;
        const wp::int32 var_96 = 9;
        wp::float64 var_97;
        wp::int32 var_98;
        wp::int32 var_99;
        const wp::int32 var_100 = 10;
        wp::float64 var_101;
        wp::int32 var_102;
        wp::int32 var_103;
        const wp::int32 var_104 = 11;
        wp::float64 var_105;
        wp::int32 var_106;
        wp::int32 var_107;
        wp::mat_t<4, 4, wp::float64>* var_108;
        wp::mat_t<4, 4, wp::float64> var_109;
        wp::mat_t<4, 4, wp::float64> var_110;
        const wp::int32 var_111 = -1;
        wp::int32 var_112;
        wp::int32 var_113;
        const wp::int32 var_114 = 0;
        bool var_115;
        wp::int32 var_116;
        const wp::int32 var_117 = 0;
        bool var_118;
        const wp::int32 var_119 = -1;
        wp::int32 var_120;
        wp::int32 var_121;
        const wp::int32 var_122 = 1;
        wp::int32 var_123;
        const wp::int32 var_124 = 0;
        bool var_125;
        const wp::int32 var_126 = 1;
        const wp::int32 var_127 = 0;
        wp::int32 var_128;
        wp::int32 var_129;
        const wp::int32 var_130 = 32;
        wp::int32 var_131;
        bool var_132;
        bool var_133;
        bool var_134;
        const wp::int32 var_135 = 0;
        bool var_136;
        const wp::int32 var_137 = 0;
        wp::mat_t<4, 4, wp::float64>* var_138;
        wp::mat_t<4, 4, wp::float64> var_139;
        wp::mat_t<4, 4, wp::float64> var_140;
        const wp::int32 var_141 = 0;
        bool var_142;
        const wp::int32 var_143 = 0;
        //---------
        // forward
        // def select_distinct_in_lanes_kernel(poses, scores, order, size, limit, probes, distinct, distinct_count):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // count = int(0)                                                                         <L 4>
        var_2 = wp::int(var_1);
        // ranked = min(order.shape[0], RANKED)                                                   <L 5>
        var_3 = &(var_order.shape);
        var_6 = wp::load(var_3);
        var_5 = wp::extract(var_6, var_4);
        var_8 = wp::min(var_5, var_7);
        // head = int(0)                                                                          <L 6>
        var_10 = wp::int(var_9);
        // while head < ranked and count < MAX_DISTINCT:                                          <L 7>
        start_while_0:;
        var_12 = (var_10 < var_8);
        var_11 = var_12;
        if (var_11) {
            var_14 = (var_2 < var_13);
            var_11 = var_11 && var_14;
        }
        if ((var_11) == false) goto end_while_0;
            // row = int(-1)                                                                      <L 8>
            var_16 = wp::int(var_15);
            // p = probe(float64(0.0))                                                            <L 9>
            var_17 = 0.0;
            var_18 = wp::vec_t<12, wp::float64>(var_17);
            // if head + i < ranked:                                                              <L 10>
            var_19 = wp::add(var_10, var_0);
            var_20 = (var_19 < var_8);
            if (var_20) {
                // row = order[head + i]                                                          <L 11>
                var_21 = wp::add(var_10, var_0);
                var_22 = wp::address(var_order, var_21);
                var_24 = wp::load(var_22);
                var_23 = wp::copy(var_24);
                // if scores[row] == REFUSED:                                                     <L 12>
                var_25 = wp::address(var_scores, var_23);
                var_28 = wp::load(var_25);
                var_27 = (var_28 == var_26);
                if (var_27) {
                    // row = -1                                                                   <L 13>
                }
                if (!var_27) {
                    // p = probe_of(poses[row], size)                                             <L 15>
                    var_30 = wp::address(var_poses, var_23);
                    var_32 = wp::load(var_30);
                    var_31 = probe_of_0(var_32, var_size);
                }
                var_33 = wp::where(var_27, var_29, var_23);
                var_34 = wp::where(var_27, var_18, var_31);
            }
            var_35 = wp::where(var_20, var_33, var_16);
            var_36 = wp::where(var_20, var_34, var_18);
            // for j in range(count):                                                             <L 16>
            var_37 = wp::range(var_2);
            start_for_2:;
                if (iter_cmp(var_37) == 0) goto end_for_2;
                var_38 = wp::iter_next(var_37);
                // if row >= 0:                                                                   <L 17>
                var_40 = (var_35 >= var_39);
                if (var_40) {
                    // if is_apart(p, j, probes, limit) == 0:                                     <L 18>
                    var_41 = is_apart_0(var_36, var_38, var_probes, var_limit);
                    var_43 = (var_41 == var_42);
                    if (var_43) {
                        // row = -1                                                               <L 19>
                    }
                    var_45 = wp::where(var_43, var_44, var_35);
                }
                var_46 = wp::where(var_40, var_45, var_35);
                wp::assign(var_35, var_46);
                goto start_for_2;
            end_for_2:;
            // waiting = ballot(1 if row >= 0 else 0)                                             <L 20>
            var_48 = (var_35 >= var_47);
            if (var_48) {
            }
            if (!var_48) {
            }
            var_51 = wp::where(var_48, var_49, var_50);
            var_52 = _ballot_0(var_51);
            // while waiting != 0 and count < MAX_DISTINCT:                                       <L 21>
        start_while_4:;
            var_55 = (var_52 != var_54);
            var_53 = var_55;
            if (var_53) {
                var_56 = (var_2 < var_13);
                var_53 = var_53 && var_56;
            }
        if ((var_53) == false) goto end_while_4;
                // if i == lowest_bit(waiting):                                                   <L 22>
                var_57 = lowest_bit_0(var_52);
                var_58 = (var_0 == var_57);
                if (var_58) {
                    // for j in range(PROBE):                                                     <L 23>
                    // probes[count * PROBE + j] = p[j]                                           <L 24>
                    var_60 = wp::extract(var_36, var_59);
                    var_62 = wp::mul(var_2, var_61);
                    var_63 = wp::add(var_62, var_59);
                    wp::array_store(var_probes, var_63, var_60);
                    var_65 = wp::extract(var_36, var_64);
                    var_66 = wp::mul(var_2, var_61);
                    var_67 = wp::add(var_66, var_64);
                    wp::array_store(var_probes, var_67, var_65);
                    var_69 = wp::extract(var_36, var_68);
                    var_70 = wp::mul(var_2, var_61);
                    var_71 = wp::add(var_70, var_68);
                    wp::array_store(var_probes, var_71, var_69);
                    var_73 = wp::extract(var_36, var_72);
                    var_74 = wp::mul(var_2, var_61);
                    var_75 = wp::add(var_74, var_72);
                    wp::array_store(var_probes, var_75, var_73);
                    var_77 = wp::extract(var_36, var_76);
                    var_78 = wp::mul(var_2, var_61);
                    var_79 = wp::add(var_78, var_76);
                    wp::array_store(var_probes, var_79, var_77);
                    var_81 = wp::extract(var_36, var_80);
                    var_82 = wp::mul(var_2, var_61);
                    var_83 = wp::add(var_82, var_80);
                    wp::array_store(var_probes, var_83, var_81);
                    var_85 = wp::extract(var_36, var_84);
                    var_86 = wp::mul(var_2, var_61);
                    var_87 = wp::add(var_86, var_84);
                    wp::array_store(var_probes, var_87, var_85);
                    var_89 = wp::extract(var_36, var_88);
                    var_90 = wp::mul(var_2, var_61);
                    var_91 = wp::add(var_90, var_88);
                    wp::array_store(var_probes, var_91, var_89);
                    var_93 = wp::extract(var_36, var_92);
                    var_94 = wp::mul(var_2, var_61);
                    var_95 = wp::add(var_94, var_92);
                    wp::array_store(var_probes, var_95, var_93);
                    var_97 = wp::extract(var_36, var_96);
                    var_98 = wp::mul(var_2, var_61);
                    var_99 = wp::add(var_98, var_96);
                    wp::array_store(var_probes, var_99, var_97);
                    var_101 = wp::extract(var_36, var_100);
                    var_102 = wp::mul(var_2, var_61);
                    var_103 = wp::add(var_102, var_100);
                    wp::array_store(var_probes, var_103, var_101);
                    var_105 = wp::extract(var_36, var_104);
                    var_106 = wp::mul(var_2, var_61);
                    var_107 = wp::add(var_106, var_104);
                    wp::array_store(var_probes, var_107, var_105);
                    // distinct[count] = poses[row]                                               <L 25>
                    var_108 = wp::address(var_poses, var_35);
                    var_110 = wp::load(var_108);
                    var_109 = wp::copy(var_110);
                    wp::array_store(var_distinct, var_2, var_109);
                    // row = -1                                                                   <L 26>
                }
                var_112 = wp::where(var_58, var_111, var_35);
                var_113 = wp::where(var_58, var_104, var_38);
                // sync_lanes()                                                                   <L 27>
                _sync_lanes_0();
                // if row >= 0:                                                                   <L 28>
                var_115 = (var_112 >= var_114);
                if (var_115) {
                    // if is_apart(p, count, probes, limit) == 0:                                 <L 29>
                    var_116 = is_apart_0(var_36, var_2, var_probes, var_limit);
                    var_118 = (var_116 == var_117);
                    if (var_118) {
                        // row = -1                                                               <L 30>
                    }
                    var_120 = wp::where(var_118, var_119, var_112);
                }
                var_121 = wp::where(var_115, var_120, var_112);
                // count += 1                                                                     <L 31>
                var_123 = wp::add(var_2, var_122);
                // waiting = ballot(1 if row >= 0 else 0)                                         <L 32>
                var_125 = (var_121 >= var_124);
                if (var_125) {
                }
                if (!var_125) {
                }
                var_128 = wp::where(var_125, var_126, var_127);
                var_129 = _ballot_0(var_128);
                wp::assign(var_2, var_123);
                wp::assign(var_35, var_121);
                wp::assign(var_38, var_113);
                wp::assign(var_52, var_129);
        goto start_while_4;
        end_while_4:;
            // head += 32                                                                         <L 33>
            var_131 = wp::add(var_10, var_130);
            wp::assign(var_10, var_131);
        goto start_while_0;
        end_while_0:;
        // if i >= count and i < MAX_DISTINCT and (count > 0):                                    <L 34>
        var_133 = (var_0 >= var_2);
        var_132 = var_133;
        if (var_132) {
            var_134 = (var_0 < var_13);
            var_132 = var_132 && var_134;
        }
        if (var_132) {
            var_136 = (var_2 > var_135);
            var_132 = var_132 && var_136;
        }
        if (var_132) {
            // distinct[i] = distinct[0]                                                          <L 35>
            var_138 = wp::address(var_distinct, var_137);
            var_140 = wp::load(var_138);
            var_139 = wp::copy(var_140);
            wp::array_store(var_distinct, var_0, var_139);
        }
        // if i == 0:                                                                             <L 36>
        var_142 = (var_0 == var_141);
        if (var_142) {
            // distinct_count[0] = count                                                          <L 37>
            wp::array_store(var_distinct_count, var_143, var_2);
        }
}


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


// <pointloom.kernels.features.feature_matching.margin_of>:1
static CUDA_CALLABLE wp::float32 margin_of_0(
    wp::array_t<wp::float32> var_queries__extent,
    wp::array_t<wp::float32> var_tree__extent,
    wp::float32 var_rounding)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32* var_1;
    const wp::int32 var_2 = 0;
    wp::float32* var_3;
    wp::float32 var_4;
    wp::float32 var_5;
    wp::float32 var_6;
    wp::float32 var_7;
    wp::float32 var_8;
    //---------
    // forward
    // def margin_of(queries__extent, tree__extent, rounding):                                <L 1>
    // return sqrt(max(queries__extent[0], tree__extent[0])) * rounding                       <L 3>
    var_1 = wp::address(var_queries__extent, var_0);
    var_3 = wp::address(var_tree__extent, var_2);
    var_5 = wp::load(var_1);
    var_6 = wp::load(var_3);
    var_4 = wp::max(var_5, var_6);
    var_7 = wp::sqrt(var_4);
    var_8 = wp::mul(var_7, var_rounding);
    return var_8;
}


// <pointloom.kernels.features.feature_matching.coordinates_of>:1
static CUDA_CALLABLE wp::vec_t<16, wp::float32> coordinates_of_0(
    wp::int32 var_position,
    wp::array_t<wp::float32> var_tree__grouped)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 0.0;
    wp::vec_t<16, wp::float32> var_1;
    const wp::int32 var_2 = 16;
    wp::int32 var_3;
    const wp::int32 var_4 = 16;
    wp::int32 var_5;
    wp::int32 var_6;
    wp::int32 var_7;
    wp::int32 var_8;
    const wp::int32 var_9 = 0;
    wp::int32 var_10;
    wp::int32 var_11;
    wp::float32* var_12;
    wp::float32 var_13;
    wp::float32 var_14;
    const wp::int32 var_15 = 1;
    wp::int32 var_16;
    wp::int32 var_17;
    wp::float32* var_18;
    wp::float32 var_19;
    wp::float32 var_20;
    const wp::int32 var_21 = 2;
    wp::int32 var_22;
    wp::int32 var_23;
    wp::float32* var_24;
    wp::float32 var_25;
    wp::float32 var_26;
    const wp::int32 var_27 = 3;
    wp::int32 var_28;
    wp::int32 var_29;
    wp::float32* var_30;
    wp::float32 var_31;
    wp::float32 var_32;
    const wp::int32 var_33 = 4;
    wp::int32 var_34;
    wp::int32 var_35;
    wp::float32* var_36;
    wp::float32 var_37;
    wp::float32 var_38;
    const wp::int32 var_39 = 5;
    wp::int32 var_40;
    wp::int32 var_41;
    wp::float32* var_42;
    wp::float32 var_43;
    wp::float32 var_44;
    const wp::int32 var_45 = 6;
    wp::int32 var_46;
    wp::int32 var_47;
    wp::float32* var_48;
    wp::float32 var_49;
    wp::float32 var_50;
    const wp::int32 var_51 = 7;
    wp::int32 var_52;
    wp::int32 var_53;
    wp::float32* var_54;
    wp::float32 var_55;
    wp::float32 var_56;
    const wp::int32 var_57 = 8;
    wp::int32 var_58;
    wp::int32 var_59;
    wp::float32* var_60;
    wp::float32 var_61;
    wp::float32 var_62;
    const wp::int32 var_63 = 9;
    wp::int32 var_64;
    wp::int32 var_65;
    wp::float32* var_66;
    wp::float32 var_67;
    wp::float32 var_68;
    const wp::int32 var_69 = 10;
    wp::int32 var_70;
    wp::int32 var_71;
    wp::float32* var_72;
    wp::float32 var_73;
    wp::float32 var_74;
    const wp::int32 var_75 = 11;
    wp::int32 var_76;
    wp::int32 var_77;
    wp::float32* var_78;
    wp::float32 var_79;
    wp::float32 var_80;
    const wp::int32 var_81 = 12;
    wp::int32 var_82;
    wp::int32 var_83;
    wp::float32* var_84;
    wp::float32 var_85;
    wp::float32 var_86;
    const wp::int32 var_87 = 13;
    wp::int32 var_88;
    wp::int32 var_89;
    wp::float32* var_90;
    wp::float32 var_91;
    wp::float32 var_92;
    const wp::int32 var_93 = 14;
    wp::int32 var_94;
    wp::int32 var_95;
    wp::float32* var_96;
    wp::float32 var_97;
    wp::float32 var_98;
    const wp::int32 var_99 = 15;
    wp::int32 var_100;
    wp::int32 var_101;
    wp::float32* var_102;
    wp::float32 var_103;
    wp::float32 var_104;
    //---------
    // forward
    // def coordinates_of(position, tree__grouped):                                           <L 1>
    // y = axes(0.0)                                                                          <L 2>
    var_1 = wp::vec_t<16, wp::float32>(var_0);
    // at = position // GROUP * AXES * GROUP + position % GROUP                               <L 3>
    var_3 = wp::floordiv(var_position, var_2);
    var_5 = wp::mul(var_3, var_4);
    var_6 = wp::mul(var_5, var_2);
    var_7 = wp::mod(var_position, var_2);
    var_8 = wp::add(var_6, var_7);
    // for k in range(AXES):                                                                  <L 4>
    // y[k] = tree__grouped[at + k * GROUP]                                                   <L 5>
    var_10 = wp::mul(var_9, var_2);
    var_11 = wp::add(var_8, var_10);
    var_12 = wp::address(var_tree__grouped, var_11);
    var_14 = wp::load(var_12);
    var_13 = wp::copy(var_14);
    wp::assign_inplace(var_1, var_9, var_13);
    var_16 = wp::mul(var_15, var_2);
    var_17 = wp::add(var_8, var_16);
    var_18 = wp::address(var_tree__grouped, var_17);
    var_20 = wp::load(var_18);
    var_19 = wp::copy(var_20);
    wp::assign_inplace(var_1, var_15, var_19);
    var_22 = wp::mul(var_21, var_2);
    var_23 = wp::add(var_8, var_22);
    var_24 = wp::address(var_tree__grouped, var_23);
    var_26 = wp::load(var_24);
    var_25 = wp::copy(var_26);
    wp::assign_inplace(var_1, var_21, var_25);
    var_28 = wp::mul(var_27, var_2);
    var_29 = wp::add(var_8, var_28);
    var_30 = wp::address(var_tree__grouped, var_29);
    var_32 = wp::load(var_30);
    var_31 = wp::copy(var_32);
    wp::assign_inplace(var_1, var_27, var_31);
    var_34 = wp::mul(var_33, var_2);
    var_35 = wp::add(var_8, var_34);
    var_36 = wp::address(var_tree__grouped, var_35);
    var_38 = wp::load(var_36);
    var_37 = wp::copy(var_38);
    wp::assign_inplace(var_1, var_33, var_37);
    var_40 = wp::mul(var_39, var_2);
    var_41 = wp::add(var_8, var_40);
    var_42 = wp::address(var_tree__grouped, var_41);
    var_44 = wp::load(var_42);
    var_43 = wp::copy(var_44);
    wp::assign_inplace(var_1, var_39, var_43);
    var_46 = wp::mul(var_45, var_2);
    var_47 = wp::add(var_8, var_46);
    var_48 = wp::address(var_tree__grouped, var_47);
    var_50 = wp::load(var_48);
    var_49 = wp::copy(var_50);
    wp::assign_inplace(var_1, var_45, var_49);
    var_52 = wp::mul(var_51, var_2);
    var_53 = wp::add(var_8, var_52);
    var_54 = wp::address(var_tree__grouped, var_53);
    var_56 = wp::load(var_54);
    var_55 = wp::copy(var_56);
    wp::assign_inplace(var_1, var_51, var_55);
    var_58 = wp::mul(var_57, var_2);
    var_59 = wp::add(var_8, var_58);
    var_60 = wp::address(var_tree__grouped, var_59);
    var_62 = wp::load(var_60);
    var_61 = wp::copy(var_62);
    wp::assign_inplace(var_1, var_57, var_61);
    var_64 = wp::mul(var_63, var_2);
    var_65 = wp::add(var_8, var_64);
    var_66 = wp::address(var_tree__grouped, var_65);
    var_68 = wp::load(var_66);
    var_67 = wp::copy(var_68);
    wp::assign_inplace(var_1, var_63, var_67);
    var_70 = wp::mul(var_69, var_2);
    var_71 = wp::add(var_8, var_70);
    var_72 = wp::address(var_tree__grouped, var_71);
    var_74 = wp::load(var_72);
    var_73 = wp::copy(var_74);
    wp::assign_inplace(var_1, var_69, var_73);
    var_76 = wp::mul(var_75, var_2);
    var_77 = wp::add(var_8, var_76);
    var_78 = wp::address(var_tree__grouped, var_77);
    var_80 = wp::load(var_78);
    var_79 = wp::copy(var_80);
    wp::assign_inplace(var_1, var_75, var_79);
    var_82 = wp::mul(var_81, var_2);
    var_83 = wp::add(var_8, var_82);
    var_84 = wp::address(var_tree__grouped, var_83);
    var_86 = wp::load(var_84);
    var_85 = wp::copy(var_86);
    wp::assign_inplace(var_1, var_81, var_85);
    var_88 = wp::mul(var_87, var_2);
    var_89 = wp::add(var_8, var_88);
    var_90 = wp::address(var_tree__grouped, var_89);
    var_92 = wp::load(var_90);
    var_91 = wp::copy(var_92);
    wp::assign_inplace(var_1, var_87, var_91);
    var_94 = wp::mul(var_93, var_2);
    var_95 = wp::add(var_8, var_94);
    var_96 = wp::address(var_tree__grouped, var_95);
    var_98 = wp::load(var_96);
    var_97 = wp::copy(var_98);
    wp::assign_inplace(var_1, var_93, var_97);
    var_100 = wp::mul(var_99, var_2);
    var_101 = wp::add(var_8, var_100);
    var_102 = wp::address(var_tree__grouped, var_101);
    var_104 = wp::load(var_102);
    var_103 = wp::copy(var_104);
    wp::assign_inplace(var_1, var_99, var_103);
    // return y                                                                               <L 6>
    return var_1;
}


// /work/main/src/pointloom/kernels/algebra/plain_min_max.py:11
static CUDA_CALLABLE wp::float32 larger_0(
    wp::float32 var_a,
    wp::float32 var_b)
{
    //---------
    // primal vars
    bool var_0;
    wp::float32 var_1;
    //---------
    // forward
    // def larger(a: float, b: float) -> float:                                               <L 12>
    // return a if a > b else b                                                               <L 13>
    var_0 = (var_a > var_b);
    if (var_0) {
    }
    if (!var_0) {
    }
    var_1 = wp::where(var_0, var_a, var_b);
    return var_1;
}


// /work/main/src/pointloom/kernels/features/feature_matching.py:92
static CUDA_CALLABLE wp::vec_t<16, wp::float32> measure_children_0(
    wp::int32 var_node,
    wp::array_t<wp::float32> var_boxes,
    wp::vec_t<16, wp::float32> var_y)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 192;
    wp::int32 var_1;
    const wp::float32 var_2 = 0.0;
    wp::vec_t<16, wp::float32> var_3;
    const wp::int32 var_4 = 0;
    wp::float32 var_5;
    const wp::int32 var_6 = 0;
    const wp::int32 var_7 = 16;
    wp::int32 var_8;
    wp::int32 var_9;
    wp::int32 var_10;
    wp::float32* var_11;
    wp::float32 var_12;
    wp::float32 var_13;
    const wp::int32 var_14 = 6;
    wp::int32 var_15;
    wp::int32 var_16;
    wp::int32 var_17;
    wp::int32 var_18;
    wp::float32* var_19;
    wp::float32 var_20;
    wp::float32 var_21;
    wp::float32 var_22;
    const wp::float32 var_23 = 0.0;
    wp::float32 var_24;
    wp::float32 var_25;
    const wp::int32 var_26 = 1;
    wp::int32 var_27;
    wp::int32 var_28;
    wp::int32 var_29;
    wp::float32* var_30;
    wp::float32 var_31;
    wp::float32 var_32;
    wp::int32 var_33;
    wp::int32 var_34;
    wp::int32 var_35;
    wp::int32 var_36;
    wp::float32* var_37;
    wp::float32 var_38;
    wp::float32 var_39;
    wp::float32 var_40;
    const wp::float32 var_41 = 0.0;
    wp::float32 var_42;
    wp::float32 var_43;
    const wp::int32 var_44 = 2;
    wp::int32 var_45;
    wp::int32 var_46;
    wp::int32 var_47;
    wp::float32* var_48;
    wp::float32 var_49;
    wp::float32 var_50;
    wp::int32 var_51;
    wp::int32 var_52;
    wp::int32 var_53;
    wp::int32 var_54;
    wp::float32* var_55;
    wp::float32 var_56;
    wp::float32 var_57;
    wp::float32 var_58;
    const wp::float32 var_59 = 0.0;
    wp::float32 var_60;
    wp::float32 var_61;
    const wp::int32 var_62 = 3;
    wp::int32 var_63;
    wp::int32 var_64;
    wp::int32 var_65;
    wp::float32* var_66;
    wp::float32 var_67;
    wp::float32 var_68;
    wp::int32 var_69;
    wp::int32 var_70;
    wp::int32 var_71;
    wp::int32 var_72;
    wp::float32* var_73;
    wp::float32 var_74;
    wp::float32 var_75;
    wp::float32 var_76;
    const wp::float32 var_77 = 0.0;
    wp::float32 var_78;
    wp::float32 var_79;
    const wp::int32 var_80 = 4;
    wp::int32 var_81;
    wp::int32 var_82;
    wp::int32 var_83;
    wp::float32* var_84;
    wp::float32 var_85;
    wp::float32 var_86;
    wp::int32 var_87;
    wp::int32 var_88;
    wp::int32 var_89;
    wp::int32 var_90;
    wp::float32* var_91;
    wp::float32 var_92;
    wp::float32 var_93;
    wp::float32 var_94;
    const wp::float32 var_95 = 0.0;
    wp::float32 var_96;
    wp::float32 var_97;
    const wp::int32 var_98 = 5;
    wp::int32 var_99;
    wp::int32 var_100;
    wp::int32 var_101;
    wp::float32* var_102;
    wp::float32 var_103;
    wp::float32 var_104;
    wp::int32 var_105;
    wp::int32 var_106;
    wp::int32 var_107;
    wp::int32 var_108;
    wp::float32* var_109;
    wp::float32 var_110;
    wp::float32 var_111;
    wp::float32 var_112;
    const wp::float32 var_113 = 0.0;
    wp::float32 var_114;
    wp::float32 var_115;
    const wp::int32 var_116 = 6;
    wp::int32 var_117;
    wp::int32 var_118;
    wp::int32 var_119;
    wp::float32* var_120;
    wp::float32 var_121;
    wp::float32 var_122;
    wp::int32 var_123;
    wp::int32 var_124;
    wp::int32 var_125;
    wp::int32 var_126;
    wp::float32* var_127;
    wp::float32 var_128;
    wp::float32 var_129;
    wp::float32 var_130;
    const wp::float32 var_131 = 0.0;
    wp::float32 var_132;
    wp::float32 var_133;
    const wp::int32 var_134 = 7;
    wp::int32 var_135;
    wp::int32 var_136;
    wp::int32 var_137;
    wp::float32* var_138;
    wp::float32 var_139;
    wp::float32 var_140;
    wp::int32 var_141;
    wp::int32 var_142;
    wp::int32 var_143;
    wp::int32 var_144;
    wp::float32* var_145;
    wp::float32 var_146;
    wp::float32 var_147;
    wp::float32 var_148;
    const wp::float32 var_149 = 0.0;
    wp::float32 var_150;
    wp::float32 var_151;
    const wp::int32 var_152 = 8;
    wp::int32 var_153;
    wp::int32 var_154;
    wp::int32 var_155;
    wp::float32* var_156;
    wp::float32 var_157;
    wp::float32 var_158;
    wp::int32 var_159;
    wp::int32 var_160;
    wp::int32 var_161;
    wp::int32 var_162;
    wp::float32* var_163;
    wp::float32 var_164;
    wp::float32 var_165;
    wp::float32 var_166;
    const wp::float32 var_167 = 0.0;
    wp::float32 var_168;
    wp::float32 var_169;
    const wp::int32 var_170 = 9;
    wp::int32 var_171;
    wp::int32 var_172;
    wp::int32 var_173;
    wp::float32* var_174;
    wp::float32 var_175;
    wp::float32 var_176;
    wp::int32 var_177;
    wp::int32 var_178;
    wp::int32 var_179;
    wp::int32 var_180;
    wp::float32* var_181;
    wp::float32 var_182;
    wp::float32 var_183;
    wp::float32 var_184;
    const wp::float32 var_185 = 0.0;
    wp::float32 var_186;
    wp::float32 var_187;
    const wp::int32 var_188 = 10;
    wp::int32 var_189;
    wp::int32 var_190;
    wp::int32 var_191;
    wp::float32* var_192;
    wp::float32 var_193;
    wp::float32 var_194;
    wp::int32 var_195;
    wp::int32 var_196;
    wp::int32 var_197;
    wp::int32 var_198;
    wp::float32* var_199;
    wp::float32 var_200;
    wp::float32 var_201;
    wp::float32 var_202;
    const wp::float32 var_203 = 0.0;
    wp::float32 var_204;
    wp::float32 var_205;
    const wp::int32 var_206 = 11;
    wp::int32 var_207;
    wp::int32 var_208;
    wp::int32 var_209;
    wp::float32* var_210;
    wp::float32 var_211;
    wp::float32 var_212;
    wp::int32 var_213;
    wp::int32 var_214;
    wp::int32 var_215;
    wp::int32 var_216;
    wp::float32* var_217;
    wp::float32 var_218;
    wp::float32 var_219;
    wp::float32 var_220;
    const wp::float32 var_221 = 0.0;
    wp::float32 var_222;
    wp::float32 var_223;
    const wp::int32 var_224 = 12;
    wp::int32 var_225;
    wp::int32 var_226;
    wp::int32 var_227;
    wp::float32* var_228;
    wp::float32 var_229;
    wp::float32 var_230;
    wp::int32 var_231;
    wp::int32 var_232;
    wp::int32 var_233;
    wp::int32 var_234;
    wp::float32* var_235;
    wp::float32 var_236;
    wp::float32 var_237;
    wp::float32 var_238;
    const wp::float32 var_239 = 0.0;
    wp::float32 var_240;
    wp::float32 var_241;
    const wp::int32 var_242 = 13;
    wp::int32 var_243;
    wp::int32 var_244;
    wp::int32 var_245;
    wp::float32* var_246;
    wp::float32 var_247;
    wp::float32 var_248;
    wp::int32 var_249;
    wp::int32 var_250;
    wp::int32 var_251;
    wp::int32 var_252;
    wp::float32* var_253;
    wp::float32 var_254;
    wp::float32 var_255;
    wp::float32 var_256;
    const wp::float32 var_257 = 0.0;
    wp::float32 var_258;
    wp::float32 var_259;
    const wp::int32 var_260 = 14;
    wp::int32 var_261;
    wp::int32 var_262;
    wp::int32 var_263;
    wp::float32* var_264;
    wp::float32 var_265;
    wp::float32 var_266;
    wp::int32 var_267;
    wp::int32 var_268;
    wp::int32 var_269;
    wp::int32 var_270;
    wp::float32* var_271;
    wp::float32 var_272;
    wp::float32 var_273;
    wp::float32 var_274;
    const wp::float32 var_275 = 0.0;
    wp::float32 var_276;
    wp::float32 var_277;
    const wp::int32 var_278 = 15;
    wp::int32 var_279;
    wp::int32 var_280;
    wp::int32 var_281;
    wp::float32* var_282;
    wp::float32 var_283;
    wp::float32 var_284;
    wp::int32 var_285;
    wp::int32 var_286;
    wp::int32 var_287;
    wp::int32 var_288;
    wp::float32* var_289;
    wp::float32 var_290;
    wp::float32 var_291;
    wp::float32 var_292;
    const wp::float32 var_293 = 0.0;
    wp::float32 var_294;
    wp::float32 var_295;
    const wp::int32 var_296 = 1;
    wp::float32 var_297;
    const wp::int32 var_298 = 0;
    wp::int32 var_299;
    wp::int32 var_300;
    wp::int32 var_301;
    wp::float32* var_302;
    wp::float32 var_303;
    wp::float32 var_304;
    wp::int32 var_305;
    wp::int32 var_306;
    wp::int32 var_307;
    wp::int32 var_308;
    wp::float32* var_309;
    wp::float32 var_310;
    wp::float32 var_311;
    wp::float32 var_312;
    const wp::float32 var_313 = 0.0;
    wp::float32 var_314;
    wp::float32 var_315;
    const wp::int32 var_316 = 1;
    wp::int32 var_317;
    wp::int32 var_318;
    wp::int32 var_319;
    wp::float32* var_320;
    wp::float32 var_321;
    wp::float32 var_322;
    wp::int32 var_323;
    wp::int32 var_324;
    wp::int32 var_325;
    wp::int32 var_326;
    wp::float32* var_327;
    wp::float32 var_328;
    wp::float32 var_329;
    wp::float32 var_330;
    const wp::float32 var_331 = 0.0;
    wp::float32 var_332;
    wp::float32 var_333;
    const wp::int32 var_334 = 2;
    wp::int32 var_335;
    wp::int32 var_336;
    wp::int32 var_337;
    wp::float32* var_338;
    wp::float32 var_339;
    wp::float32 var_340;
    wp::int32 var_341;
    wp::int32 var_342;
    wp::int32 var_343;
    wp::int32 var_344;
    wp::float32* var_345;
    wp::float32 var_346;
    wp::float32 var_347;
    wp::float32 var_348;
    const wp::float32 var_349 = 0.0;
    wp::float32 var_350;
    wp::float32 var_351;
    const wp::int32 var_352 = 3;
    wp::int32 var_353;
    wp::int32 var_354;
    wp::int32 var_355;
    wp::float32* var_356;
    wp::float32 var_357;
    wp::float32 var_358;
    wp::int32 var_359;
    wp::int32 var_360;
    wp::int32 var_361;
    wp::int32 var_362;
    wp::float32* var_363;
    wp::float32 var_364;
    wp::float32 var_365;
    wp::float32 var_366;
    const wp::float32 var_367 = 0.0;
    wp::float32 var_368;
    wp::float32 var_369;
    const wp::int32 var_370 = 4;
    wp::int32 var_371;
    wp::int32 var_372;
    wp::int32 var_373;
    wp::float32* var_374;
    wp::float32 var_375;
    wp::float32 var_376;
    wp::int32 var_377;
    wp::int32 var_378;
    wp::int32 var_379;
    wp::int32 var_380;
    wp::float32* var_381;
    wp::float32 var_382;
    wp::float32 var_383;
    wp::float32 var_384;
    const wp::float32 var_385 = 0.0;
    wp::float32 var_386;
    wp::float32 var_387;
    const wp::int32 var_388 = 5;
    wp::int32 var_389;
    wp::int32 var_390;
    wp::int32 var_391;
    wp::float32* var_392;
    wp::float32 var_393;
    wp::float32 var_394;
    wp::int32 var_395;
    wp::int32 var_396;
    wp::int32 var_397;
    wp::int32 var_398;
    wp::float32* var_399;
    wp::float32 var_400;
    wp::float32 var_401;
    wp::float32 var_402;
    const wp::float32 var_403 = 0.0;
    wp::float32 var_404;
    wp::float32 var_405;
    const wp::int32 var_406 = 6;
    wp::int32 var_407;
    wp::int32 var_408;
    wp::int32 var_409;
    wp::float32* var_410;
    wp::float32 var_411;
    wp::float32 var_412;
    wp::int32 var_413;
    wp::int32 var_414;
    wp::int32 var_415;
    wp::int32 var_416;
    wp::float32* var_417;
    wp::float32 var_418;
    wp::float32 var_419;
    wp::float32 var_420;
    const wp::float32 var_421 = 0.0;
    wp::float32 var_422;
    wp::float32 var_423;
    const wp::int32 var_424 = 7;
    wp::int32 var_425;
    wp::int32 var_426;
    wp::int32 var_427;
    wp::float32* var_428;
    wp::float32 var_429;
    wp::float32 var_430;
    wp::int32 var_431;
    wp::int32 var_432;
    wp::int32 var_433;
    wp::int32 var_434;
    wp::float32* var_435;
    wp::float32 var_436;
    wp::float32 var_437;
    wp::float32 var_438;
    const wp::float32 var_439 = 0.0;
    wp::float32 var_440;
    wp::float32 var_441;
    const wp::int32 var_442 = 8;
    wp::int32 var_443;
    wp::int32 var_444;
    wp::int32 var_445;
    wp::float32* var_446;
    wp::float32 var_447;
    wp::float32 var_448;
    wp::int32 var_449;
    wp::int32 var_450;
    wp::int32 var_451;
    wp::int32 var_452;
    wp::float32* var_453;
    wp::float32 var_454;
    wp::float32 var_455;
    wp::float32 var_456;
    const wp::float32 var_457 = 0.0;
    wp::float32 var_458;
    wp::float32 var_459;
    const wp::int32 var_460 = 9;
    wp::int32 var_461;
    wp::int32 var_462;
    wp::int32 var_463;
    wp::float32* var_464;
    wp::float32 var_465;
    wp::float32 var_466;
    wp::int32 var_467;
    wp::int32 var_468;
    wp::int32 var_469;
    wp::int32 var_470;
    wp::float32* var_471;
    wp::float32 var_472;
    wp::float32 var_473;
    wp::float32 var_474;
    const wp::float32 var_475 = 0.0;
    wp::float32 var_476;
    wp::float32 var_477;
    const wp::int32 var_478 = 10;
    wp::int32 var_479;
    wp::int32 var_480;
    wp::int32 var_481;
    wp::float32* var_482;
    wp::float32 var_483;
    wp::float32 var_484;
    wp::int32 var_485;
    wp::int32 var_486;
    wp::int32 var_487;
    wp::int32 var_488;
    wp::float32* var_489;
    wp::float32 var_490;
    wp::float32 var_491;
    wp::float32 var_492;
    const wp::float32 var_493 = 0.0;
    wp::float32 var_494;
    wp::float32 var_495;
    const wp::int32 var_496 = 11;
    wp::int32 var_497;
    wp::int32 var_498;
    wp::int32 var_499;
    wp::float32* var_500;
    wp::float32 var_501;
    wp::float32 var_502;
    wp::int32 var_503;
    wp::int32 var_504;
    wp::int32 var_505;
    wp::int32 var_506;
    wp::float32* var_507;
    wp::float32 var_508;
    wp::float32 var_509;
    wp::float32 var_510;
    const wp::float32 var_511 = 0.0;
    wp::float32 var_512;
    wp::float32 var_513;
    const wp::int32 var_514 = 12;
    wp::int32 var_515;
    wp::int32 var_516;
    wp::int32 var_517;
    wp::float32* var_518;
    wp::float32 var_519;
    wp::float32 var_520;
    wp::int32 var_521;
    wp::int32 var_522;
    wp::int32 var_523;
    wp::int32 var_524;
    wp::float32* var_525;
    wp::float32 var_526;
    wp::float32 var_527;
    wp::float32 var_528;
    const wp::float32 var_529 = 0.0;
    wp::float32 var_530;
    wp::float32 var_531;
    const wp::int32 var_532 = 13;
    wp::int32 var_533;
    wp::int32 var_534;
    wp::int32 var_535;
    wp::float32* var_536;
    wp::float32 var_537;
    wp::float32 var_538;
    wp::int32 var_539;
    wp::int32 var_540;
    wp::int32 var_541;
    wp::int32 var_542;
    wp::float32* var_543;
    wp::float32 var_544;
    wp::float32 var_545;
    wp::float32 var_546;
    const wp::float32 var_547 = 0.0;
    wp::float32 var_548;
    wp::float32 var_549;
    const wp::int32 var_550 = 14;
    wp::int32 var_551;
    wp::int32 var_552;
    wp::int32 var_553;
    wp::float32* var_554;
    wp::float32 var_555;
    wp::float32 var_556;
    wp::int32 var_557;
    wp::int32 var_558;
    wp::int32 var_559;
    wp::int32 var_560;
    wp::float32* var_561;
    wp::float32 var_562;
    wp::float32 var_563;
    wp::float32 var_564;
    const wp::float32 var_565 = 0.0;
    wp::float32 var_566;
    wp::float32 var_567;
    const wp::int32 var_568 = 15;
    wp::int32 var_569;
    wp::int32 var_570;
    wp::int32 var_571;
    wp::float32* var_572;
    wp::float32 var_573;
    wp::float32 var_574;
    wp::int32 var_575;
    wp::int32 var_576;
    wp::int32 var_577;
    wp::int32 var_578;
    wp::float32* var_579;
    wp::float32 var_580;
    wp::float32 var_581;
    wp::float32 var_582;
    const wp::float32 var_583 = 0.0;
    wp::float32 var_584;
    wp::float32 var_585;
    const wp::int32 var_586 = 2;
    wp::float32 var_587;
    const wp::int32 var_588 = 0;
    wp::int32 var_589;
    wp::int32 var_590;
    wp::int32 var_591;
    wp::float32* var_592;
    wp::float32 var_593;
    wp::float32 var_594;
    wp::int32 var_595;
    wp::int32 var_596;
    wp::int32 var_597;
    wp::int32 var_598;
    wp::float32* var_599;
    wp::float32 var_600;
    wp::float32 var_601;
    wp::float32 var_602;
    const wp::float32 var_603 = 0.0;
    wp::float32 var_604;
    wp::float32 var_605;
    const wp::int32 var_606 = 1;
    wp::int32 var_607;
    wp::int32 var_608;
    wp::int32 var_609;
    wp::float32* var_610;
    wp::float32 var_611;
    wp::float32 var_612;
    wp::int32 var_613;
    wp::int32 var_614;
    wp::int32 var_615;
    wp::int32 var_616;
    wp::float32* var_617;
    wp::float32 var_618;
    wp::float32 var_619;
    wp::float32 var_620;
    const wp::float32 var_621 = 0.0;
    wp::float32 var_622;
    wp::float32 var_623;
    const wp::int32 var_624 = 2;
    wp::int32 var_625;
    wp::int32 var_626;
    wp::int32 var_627;
    wp::float32* var_628;
    wp::float32 var_629;
    wp::float32 var_630;
    wp::int32 var_631;
    wp::int32 var_632;
    wp::int32 var_633;
    wp::int32 var_634;
    wp::float32* var_635;
    wp::float32 var_636;
    wp::float32 var_637;
    wp::float32 var_638;
    const wp::float32 var_639 = 0.0;
    wp::float32 var_640;
    wp::float32 var_641;
    const wp::int32 var_642 = 3;
    wp::int32 var_643;
    wp::int32 var_644;
    wp::int32 var_645;
    wp::float32* var_646;
    wp::float32 var_647;
    wp::float32 var_648;
    wp::int32 var_649;
    wp::int32 var_650;
    wp::int32 var_651;
    wp::int32 var_652;
    wp::float32* var_653;
    wp::float32 var_654;
    wp::float32 var_655;
    wp::float32 var_656;
    const wp::float32 var_657 = 0.0;
    wp::float32 var_658;
    wp::float32 var_659;
    const wp::int32 var_660 = 4;
    wp::int32 var_661;
    wp::int32 var_662;
    wp::int32 var_663;
    wp::float32* var_664;
    wp::float32 var_665;
    wp::float32 var_666;
    wp::int32 var_667;
    wp::int32 var_668;
    wp::int32 var_669;
    wp::int32 var_670;
    wp::float32* var_671;
    wp::float32 var_672;
    wp::float32 var_673;
    wp::float32 var_674;
    const wp::float32 var_675 = 0.0;
    wp::float32 var_676;
    wp::float32 var_677;
    const wp::int32 var_678 = 5;
    wp::int32 var_679;
    wp::int32 var_680;
    wp::int32 var_681;
    wp::float32* var_682;
    wp::float32 var_683;
    wp::float32 var_684;
    wp::int32 var_685;
    wp::int32 var_686;
    wp::int32 var_687;
    wp::int32 var_688;
    wp::float32* var_689;
    wp::float32 var_690;
    wp::float32 var_691;
    wp::float32 var_692;
    const wp::float32 var_693 = 0.0;
    wp::float32 var_694;
    wp::float32 var_695;
    const wp::int32 var_696 = 6;
    wp::int32 var_697;
    wp::int32 var_698;
    wp::int32 var_699;
    wp::float32* var_700;
    wp::float32 var_701;
    wp::float32 var_702;
    wp::int32 var_703;
    wp::int32 var_704;
    wp::int32 var_705;
    wp::int32 var_706;
    wp::float32* var_707;
    wp::float32 var_708;
    wp::float32 var_709;
    wp::float32 var_710;
    const wp::float32 var_711 = 0.0;
    wp::float32 var_712;
    wp::float32 var_713;
    const wp::int32 var_714 = 7;
    wp::int32 var_715;
    wp::int32 var_716;
    wp::int32 var_717;
    wp::float32* var_718;
    wp::float32 var_719;
    wp::float32 var_720;
    wp::int32 var_721;
    wp::int32 var_722;
    wp::int32 var_723;
    wp::int32 var_724;
    wp::float32* var_725;
    wp::float32 var_726;
    wp::float32 var_727;
    wp::float32 var_728;
    const wp::float32 var_729 = 0.0;
    wp::float32 var_730;
    wp::float32 var_731;
    const wp::int32 var_732 = 8;
    wp::int32 var_733;
    wp::int32 var_734;
    wp::int32 var_735;
    wp::float32* var_736;
    wp::float32 var_737;
    wp::float32 var_738;
    wp::int32 var_739;
    wp::int32 var_740;
    wp::int32 var_741;
    wp::int32 var_742;
    wp::float32* var_743;
    wp::float32 var_744;
    wp::float32 var_745;
    wp::float32 var_746;
    const wp::float32 var_747 = 0.0;
    wp::float32 var_748;
    wp::float32 var_749;
    const wp::int32 var_750 = 9;
    wp::int32 var_751;
    wp::int32 var_752;
    wp::int32 var_753;
    wp::float32* var_754;
    wp::float32 var_755;
    wp::float32 var_756;
    wp::int32 var_757;
    wp::int32 var_758;
    wp::int32 var_759;
    wp::int32 var_760;
    wp::float32* var_761;
    wp::float32 var_762;
    wp::float32 var_763;
    wp::float32 var_764;
    const wp::float32 var_765 = 0.0;
    wp::float32 var_766;
    wp::float32 var_767;
    const wp::int32 var_768 = 10;
    wp::int32 var_769;
    wp::int32 var_770;
    wp::int32 var_771;
    wp::float32* var_772;
    wp::float32 var_773;
    wp::float32 var_774;
    wp::int32 var_775;
    wp::int32 var_776;
    wp::int32 var_777;
    wp::int32 var_778;
    wp::float32* var_779;
    wp::float32 var_780;
    wp::float32 var_781;
    wp::float32 var_782;
    const wp::float32 var_783 = 0.0;
    wp::float32 var_784;
    wp::float32 var_785;
    const wp::int32 var_786 = 11;
    wp::int32 var_787;
    wp::int32 var_788;
    wp::int32 var_789;
    wp::float32* var_790;
    wp::float32 var_791;
    wp::float32 var_792;
    wp::int32 var_793;
    wp::int32 var_794;
    wp::int32 var_795;
    wp::int32 var_796;
    wp::float32* var_797;
    wp::float32 var_798;
    wp::float32 var_799;
    wp::float32 var_800;
    const wp::float32 var_801 = 0.0;
    wp::float32 var_802;
    wp::float32 var_803;
    const wp::int32 var_804 = 12;
    wp::int32 var_805;
    wp::int32 var_806;
    wp::int32 var_807;
    wp::float32* var_808;
    wp::float32 var_809;
    wp::float32 var_810;
    wp::int32 var_811;
    wp::int32 var_812;
    wp::int32 var_813;
    wp::int32 var_814;
    wp::float32* var_815;
    wp::float32 var_816;
    wp::float32 var_817;
    wp::float32 var_818;
    const wp::float32 var_819 = 0.0;
    wp::float32 var_820;
    wp::float32 var_821;
    const wp::int32 var_822 = 13;
    wp::int32 var_823;
    wp::int32 var_824;
    wp::int32 var_825;
    wp::float32* var_826;
    wp::float32 var_827;
    wp::float32 var_828;
    wp::int32 var_829;
    wp::int32 var_830;
    wp::int32 var_831;
    wp::int32 var_832;
    wp::float32* var_833;
    wp::float32 var_834;
    wp::float32 var_835;
    wp::float32 var_836;
    const wp::float32 var_837 = 0.0;
    wp::float32 var_838;
    wp::float32 var_839;
    const wp::int32 var_840 = 14;
    wp::int32 var_841;
    wp::int32 var_842;
    wp::int32 var_843;
    wp::float32* var_844;
    wp::float32 var_845;
    wp::float32 var_846;
    wp::int32 var_847;
    wp::int32 var_848;
    wp::int32 var_849;
    wp::int32 var_850;
    wp::float32* var_851;
    wp::float32 var_852;
    wp::float32 var_853;
    wp::float32 var_854;
    const wp::float32 var_855 = 0.0;
    wp::float32 var_856;
    wp::float32 var_857;
    const wp::int32 var_858 = 15;
    wp::int32 var_859;
    wp::int32 var_860;
    wp::int32 var_861;
    wp::float32* var_862;
    wp::float32 var_863;
    wp::float32 var_864;
    wp::int32 var_865;
    wp::int32 var_866;
    wp::int32 var_867;
    wp::int32 var_868;
    wp::float32* var_869;
    wp::float32 var_870;
    wp::float32 var_871;
    wp::float32 var_872;
    const wp::float32 var_873 = 0.0;
    wp::float32 var_874;
    wp::float32 var_875;
    const wp::int32 var_876 = 3;
    wp::float32 var_877;
    const wp::int32 var_878 = 0;
    wp::int32 var_879;
    wp::int32 var_880;
    wp::int32 var_881;
    wp::float32* var_882;
    wp::float32 var_883;
    wp::float32 var_884;
    wp::int32 var_885;
    wp::int32 var_886;
    wp::int32 var_887;
    wp::int32 var_888;
    wp::float32* var_889;
    wp::float32 var_890;
    wp::float32 var_891;
    wp::float32 var_892;
    const wp::float32 var_893 = 0.0;
    wp::float32 var_894;
    wp::float32 var_895;
    const wp::int32 var_896 = 1;
    wp::int32 var_897;
    wp::int32 var_898;
    wp::int32 var_899;
    wp::float32* var_900;
    wp::float32 var_901;
    wp::float32 var_902;
    wp::int32 var_903;
    wp::int32 var_904;
    wp::int32 var_905;
    wp::int32 var_906;
    wp::float32* var_907;
    wp::float32 var_908;
    wp::float32 var_909;
    wp::float32 var_910;
    const wp::float32 var_911 = 0.0;
    wp::float32 var_912;
    wp::float32 var_913;
    const wp::int32 var_914 = 2;
    wp::int32 var_915;
    wp::int32 var_916;
    wp::int32 var_917;
    wp::float32* var_918;
    wp::float32 var_919;
    wp::float32 var_920;
    wp::int32 var_921;
    wp::int32 var_922;
    wp::int32 var_923;
    wp::int32 var_924;
    wp::float32* var_925;
    wp::float32 var_926;
    wp::float32 var_927;
    wp::float32 var_928;
    const wp::float32 var_929 = 0.0;
    wp::float32 var_930;
    wp::float32 var_931;
    const wp::int32 var_932 = 3;
    wp::int32 var_933;
    wp::int32 var_934;
    wp::int32 var_935;
    wp::float32* var_936;
    wp::float32 var_937;
    wp::float32 var_938;
    wp::int32 var_939;
    wp::int32 var_940;
    wp::int32 var_941;
    wp::int32 var_942;
    wp::float32* var_943;
    wp::float32 var_944;
    wp::float32 var_945;
    wp::float32 var_946;
    const wp::float32 var_947 = 0.0;
    wp::float32 var_948;
    wp::float32 var_949;
    const wp::int32 var_950 = 4;
    wp::int32 var_951;
    wp::int32 var_952;
    wp::int32 var_953;
    wp::float32* var_954;
    wp::float32 var_955;
    wp::float32 var_956;
    wp::int32 var_957;
    wp::int32 var_958;
    wp::int32 var_959;
    wp::int32 var_960;
    wp::float32* var_961;
    wp::float32 var_962;
    wp::float32 var_963;
    wp::float32 var_964;
    const wp::float32 var_965 = 0.0;
    wp::float32 var_966;
    wp::float32 var_967;
    const wp::int32 var_968 = 5;
    wp::int32 var_969;
    wp::int32 var_970;
    wp::int32 var_971;
    wp::float32* var_972;
    wp::float32 var_973;
    wp::float32 var_974;
    wp::int32 var_975;
    wp::int32 var_976;
    wp::int32 var_977;
    wp::int32 var_978;
    wp::float32* var_979;
    wp::float32 var_980;
    wp::float32 var_981;
    wp::float32 var_982;
    const wp::float32 var_983 = 0.0;
    wp::float32 var_984;
    wp::float32 var_985;
    const wp::int32 var_986 = 6;
    wp::int32 var_987;
    wp::int32 var_988;
    wp::int32 var_989;
    wp::float32* var_990;
    wp::float32 var_991;
    wp::float32 var_992;
    wp::int32 var_993;
    wp::int32 var_994;
    wp::int32 var_995;
    wp::int32 var_996;
    wp::float32* var_997;
    wp::float32 var_998;
    wp::float32 var_999;
    wp::float32 var_1000;
    const wp::float32 var_1001 = 0.0;
    wp::float32 var_1002;
    wp::float32 var_1003;
    const wp::int32 var_1004 = 7;
    wp::int32 var_1005;
    wp::int32 var_1006;
    wp::int32 var_1007;
    wp::float32* var_1008;
    wp::float32 var_1009;
    wp::float32 var_1010;
    wp::int32 var_1011;
    wp::int32 var_1012;
    wp::int32 var_1013;
    wp::int32 var_1014;
    wp::float32* var_1015;
    wp::float32 var_1016;
    wp::float32 var_1017;
    wp::float32 var_1018;
    const wp::float32 var_1019 = 0.0;
    wp::float32 var_1020;
    wp::float32 var_1021;
    const wp::int32 var_1022 = 8;
    wp::int32 var_1023;
    wp::int32 var_1024;
    wp::int32 var_1025;
    wp::float32* var_1026;
    wp::float32 var_1027;
    wp::float32 var_1028;
    wp::int32 var_1029;
    wp::int32 var_1030;
    wp::int32 var_1031;
    wp::int32 var_1032;
    wp::float32* var_1033;
    wp::float32 var_1034;
    wp::float32 var_1035;
    wp::float32 var_1036;
    const wp::float32 var_1037 = 0.0;
    wp::float32 var_1038;
    wp::float32 var_1039;
    const wp::int32 var_1040 = 9;
    wp::int32 var_1041;
    wp::int32 var_1042;
    wp::int32 var_1043;
    wp::float32* var_1044;
    wp::float32 var_1045;
    wp::float32 var_1046;
    wp::int32 var_1047;
    wp::int32 var_1048;
    wp::int32 var_1049;
    wp::int32 var_1050;
    wp::float32* var_1051;
    wp::float32 var_1052;
    wp::float32 var_1053;
    wp::float32 var_1054;
    const wp::float32 var_1055 = 0.0;
    wp::float32 var_1056;
    wp::float32 var_1057;
    const wp::int32 var_1058 = 10;
    wp::int32 var_1059;
    wp::int32 var_1060;
    wp::int32 var_1061;
    wp::float32* var_1062;
    wp::float32 var_1063;
    wp::float32 var_1064;
    wp::int32 var_1065;
    wp::int32 var_1066;
    wp::int32 var_1067;
    wp::int32 var_1068;
    wp::float32* var_1069;
    wp::float32 var_1070;
    wp::float32 var_1071;
    wp::float32 var_1072;
    const wp::float32 var_1073 = 0.0;
    wp::float32 var_1074;
    wp::float32 var_1075;
    const wp::int32 var_1076 = 11;
    wp::int32 var_1077;
    wp::int32 var_1078;
    wp::int32 var_1079;
    wp::float32* var_1080;
    wp::float32 var_1081;
    wp::float32 var_1082;
    wp::int32 var_1083;
    wp::int32 var_1084;
    wp::int32 var_1085;
    wp::int32 var_1086;
    wp::float32* var_1087;
    wp::float32 var_1088;
    wp::float32 var_1089;
    wp::float32 var_1090;
    const wp::float32 var_1091 = 0.0;
    wp::float32 var_1092;
    wp::float32 var_1093;
    const wp::int32 var_1094 = 12;
    wp::int32 var_1095;
    wp::int32 var_1096;
    wp::int32 var_1097;
    wp::float32* var_1098;
    wp::float32 var_1099;
    wp::float32 var_1100;
    wp::int32 var_1101;
    wp::int32 var_1102;
    wp::int32 var_1103;
    wp::int32 var_1104;
    wp::float32* var_1105;
    wp::float32 var_1106;
    wp::float32 var_1107;
    wp::float32 var_1108;
    const wp::float32 var_1109 = 0.0;
    wp::float32 var_1110;
    wp::float32 var_1111;
    const wp::int32 var_1112 = 13;
    wp::int32 var_1113;
    wp::int32 var_1114;
    wp::int32 var_1115;
    wp::float32* var_1116;
    wp::float32 var_1117;
    wp::float32 var_1118;
    wp::int32 var_1119;
    wp::int32 var_1120;
    wp::int32 var_1121;
    wp::int32 var_1122;
    wp::float32* var_1123;
    wp::float32 var_1124;
    wp::float32 var_1125;
    wp::float32 var_1126;
    const wp::float32 var_1127 = 0.0;
    wp::float32 var_1128;
    wp::float32 var_1129;
    const wp::int32 var_1130 = 14;
    wp::int32 var_1131;
    wp::int32 var_1132;
    wp::int32 var_1133;
    wp::float32* var_1134;
    wp::float32 var_1135;
    wp::float32 var_1136;
    wp::int32 var_1137;
    wp::int32 var_1138;
    wp::int32 var_1139;
    wp::int32 var_1140;
    wp::float32* var_1141;
    wp::float32 var_1142;
    wp::float32 var_1143;
    wp::float32 var_1144;
    const wp::float32 var_1145 = 0.0;
    wp::float32 var_1146;
    wp::float32 var_1147;
    const wp::int32 var_1148 = 15;
    wp::int32 var_1149;
    wp::int32 var_1150;
    wp::int32 var_1151;
    wp::float32* var_1152;
    wp::float32 var_1153;
    wp::float32 var_1154;
    wp::int32 var_1155;
    wp::int32 var_1156;
    wp::int32 var_1157;
    wp::int32 var_1158;
    wp::float32* var_1159;
    wp::float32 var_1160;
    wp::float32 var_1161;
    wp::float32 var_1162;
    const wp::float32 var_1163 = 0.0;
    wp::float32 var_1164;
    wp::float32 var_1165;
    const wp::int32 var_1166 = 4;
    wp::float32 var_1167;
    const wp::int32 var_1168 = 0;
    wp::int32 var_1169;
    wp::int32 var_1170;
    wp::int32 var_1171;
    wp::float32* var_1172;
    wp::float32 var_1173;
    wp::float32 var_1174;
    wp::int32 var_1175;
    wp::int32 var_1176;
    wp::int32 var_1177;
    wp::int32 var_1178;
    wp::float32* var_1179;
    wp::float32 var_1180;
    wp::float32 var_1181;
    wp::float32 var_1182;
    const wp::float32 var_1183 = 0.0;
    wp::float32 var_1184;
    wp::float32 var_1185;
    const wp::int32 var_1186 = 1;
    wp::int32 var_1187;
    wp::int32 var_1188;
    wp::int32 var_1189;
    wp::float32* var_1190;
    wp::float32 var_1191;
    wp::float32 var_1192;
    wp::int32 var_1193;
    wp::int32 var_1194;
    wp::int32 var_1195;
    wp::int32 var_1196;
    wp::float32* var_1197;
    wp::float32 var_1198;
    wp::float32 var_1199;
    wp::float32 var_1200;
    const wp::float32 var_1201 = 0.0;
    wp::float32 var_1202;
    wp::float32 var_1203;
    const wp::int32 var_1204 = 2;
    wp::int32 var_1205;
    wp::int32 var_1206;
    wp::int32 var_1207;
    wp::float32* var_1208;
    wp::float32 var_1209;
    wp::float32 var_1210;
    wp::int32 var_1211;
    wp::int32 var_1212;
    wp::int32 var_1213;
    wp::int32 var_1214;
    wp::float32* var_1215;
    wp::float32 var_1216;
    wp::float32 var_1217;
    wp::float32 var_1218;
    const wp::float32 var_1219 = 0.0;
    wp::float32 var_1220;
    wp::float32 var_1221;
    const wp::int32 var_1222 = 3;
    wp::int32 var_1223;
    wp::int32 var_1224;
    wp::int32 var_1225;
    wp::float32* var_1226;
    wp::float32 var_1227;
    wp::float32 var_1228;
    wp::int32 var_1229;
    wp::int32 var_1230;
    wp::int32 var_1231;
    wp::int32 var_1232;
    wp::float32* var_1233;
    wp::float32 var_1234;
    wp::float32 var_1235;
    wp::float32 var_1236;
    const wp::float32 var_1237 = 0.0;
    wp::float32 var_1238;
    wp::float32 var_1239;
    const wp::int32 var_1240 = 4;
    wp::int32 var_1241;
    wp::int32 var_1242;
    wp::int32 var_1243;
    wp::float32* var_1244;
    wp::float32 var_1245;
    wp::float32 var_1246;
    wp::int32 var_1247;
    wp::int32 var_1248;
    wp::int32 var_1249;
    wp::int32 var_1250;
    wp::float32* var_1251;
    wp::float32 var_1252;
    wp::float32 var_1253;
    wp::float32 var_1254;
    const wp::float32 var_1255 = 0.0;
    wp::float32 var_1256;
    wp::float32 var_1257;
    const wp::int32 var_1258 = 5;
    wp::int32 var_1259;
    wp::int32 var_1260;
    wp::int32 var_1261;
    wp::float32* var_1262;
    wp::float32 var_1263;
    wp::float32 var_1264;
    wp::int32 var_1265;
    wp::int32 var_1266;
    wp::int32 var_1267;
    wp::int32 var_1268;
    wp::float32* var_1269;
    wp::float32 var_1270;
    wp::float32 var_1271;
    wp::float32 var_1272;
    const wp::float32 var_1273 = 0.0;
    wp::float32 var_1274;
    wp::float32 var_1275;
    const wp::int32 var_1276 = 6;
    wp::int32 var_1277;
    wp::int32 var_1278;
    wp::int32 var_1279;
    wp::float32* var_1280;
    wp::float32 var_1281;
    wp::float32 var_1282;
    wp::int32 var_1283;
    wp::int32 var_1284;
    wp::int32 var_1285;
    wp::int32 var_1286;
    wp::float32* var_1287;
    wp::float32 var_1288;
    wp::float32 var_1289;
    wp::float32 var_1290;
    const wp::float32 var_1291 = 0.0;
    wp::float32 var_1292;
    wp::float32 var_1293;
    const wp::int32 var_1294 = 7;
    wp::int32 var_1295;
    wp::int32 var_1296;
    wp::int32 var_1297;
    wp::float32* var_1298;
    wp::float32 var_1299;
    wp::float32 var_1300;
    wp::int32 var_1301;
    wp::int32 var_1302;
    wp::int32 var_1303;
    wp::int32 var_1304;
    wp::float32* var_1305;
    wp::float32 var_1306;
    wp::float32 var_1307;
    wp::float32 var_1308;
    const wp::float32 var_1309 = 0.0;
    wp::float32 var_1310;
    wp::float32 var_1311;
    const wp::int32 var_1312 = 8;
    wp::int32 var_1313;
    wp::int32 var_1314;
    wp::int32 var_1315;
    wp::float32* var_1316;
    wp::float32 var_1317;
    wp::float32 var_1318;
    wp::int32 var_1319;
    wp::int32 var_1320;
    wp::int32 var_1321;
    wp::int32 var_1322;
    wp::float32* var_1323;
    wp::float32 var_1324;
    wp::float32 var_1325;
    wp::float32 var_1326;
    const wp::float32 var_1327 = 0.0;
    wp::float32 var_1328;
    wp::float32 var_1329;
    const wp::int32 var_1330 = 9;
    wp::int32 var_1331;
    wp::int32 var_1332;
    wp::int32 var_1333;
    wp::float32* var_1334;
    wp::float32 var_1335;
    wp::float32 var_1336;
    wp::int32 var_1337;
    wp::int32 var_1338;
    wp::int32 var_1339;
    wp::int32 var_1340;
    wp::float32* var_1341;
    wp::float32 var_1342;
    wp::float32 var_1343;
    wp::float32 var_1344;
    const wp::float32 var_1345 = 0.0;
    wp::float32 var_1346;
    wp::float32 var_1347;
    const wp::int32 var_1348 = 10;
    wp::int32 var_1349;
    wp::int32 var_1350;
    wp::int32 var_1351;
    wp::float32* var_1352;
    wp::float32 var_1353;
    wp::float32 var_1354;
    wp::int32 var_1355;
    wp::int32 var_1356;
    wp::int32 var_1357;
    wp::int32 var_1358;
    wp::float32* var_1359;
    wp::float32 var_1360;
    wp::float32 var_1361;
    wp::float32 var_1362;
    const wp::float32 var_1363 = 0.0;
    wp::float32 var_1364;
    wp::float32 var_1365;
    const wp::int32 var_1366 = 11;
    wp::int32 var_1367;
    wp::int32 var_1368;
    wp::int32 var_1369;
    wp::float32* var_1370;
    wp::float32 var_1371;
    wp::float32 var_1372;
    wp::int32 var_1373;
    wp::int32 var_1374;
    wp::int32 var_1375;
    wp::int32 var_1376;
    wp::float32* var_1377;
    wp::float32 var_1378;
    wp::float32 var_1379;
    wp::float32 var_1380;
    const wp::float32 var_1381 = 0.0;
    wp::float32 var_1382;
    wp::float32 var_1383;
    const wp::int32 var_1384 = 12;
    wp::int32 var_1385;
    wp::int32 var_1386;
    wp::int32 var_1387;
    wp::float32* var_1388;
    wp::float32 var_1389;
    wp::float32 var_1390;
    wp::int32 var_1391;
    wp::int32 var_1392;
    wp::int32 var_1393;
    wp::int32 var_1394;
    wp::float32* var_1395;
    wp::float32 var_1396;
    wp::float32 var_1397;
    wp::float32 var_1398;
    const wp::float32 var_1399 = 0.0;
    wp::float32 var_1400;
    wp::float32 var_1401;
    const wp::int32 var_1402 = 13;
    wp::int32 var_1403;
    wp::int32 var_1404;
    wp::int32 var_1405;
    wp::float32* var_1406;
    wp::float32 var_1407;
    wp::float32 var_1408;
    wp::int32 var_1409;
    wp::int32 var_1410;
    wp::int32 var_1411;
    wp::int32 var_1412;
    wp::float32* var_1413;
    wp::float32 var_1414;
    wp::float32 var_1415;
    wp::float32 var_1416;
    const wp::float32 var_1417 = 0.0;
    wp::float32 var_1418;
    wp::float32 var_1419;
    const wp::int32 var_1420 = 14;
    wp::int32 var_1421;
    wp::int32 var_1422;
    wp::int32 var_1423;
    wp::float32* var_1424;
    wp::float32 var_1425;
    wp::float32 var_1426;
    wp::int32 var_1427;
    wp::int32 var_1428;
    wp::int32 var_1429;
    wp::int32 var_1430;
    wp::float32* var_1431;
    wp::float32 var_1432;
    wp::float32 var_1433;
    wp::float32 var_1434;
    const wp::float32 var_1435 = 0.0;
    wp::float32 var_1436;
    wp::float32 var_1437;
    const wp::int32 var_1438 = 15;
    wp::int32 var_1439;
    wp::int32 var_1440;
    wp::int32 var_1441;
    wp::float32* var_1442;
    wp::float32 var_1443;
    wp::float32 var_1444;
    wp::int32 var_1445;
    wp::int32 var_1446;
    wp::int32 var_1447;
    wp::int32 var_1448;
    wp::float32* var_1449;
    wp::float32 var_1450;
    wp::float32 var_1451;
    wp::float32 var_1452;
    const wp::float32 var_1453 = 0.0;
    wp::float32 var_1454;
    wp::float32 var_1455;
    const wp::int32 var_1456 = 5;
    wp::float32 var_1457;
    const wp::int32 var_1458 = 0;
    wp::int32 var_1459;
    wp::int32 var_1460;
    wp::int32 var_1461;
    wp::float32* var_1462;
    wp::float32 var_1463;
    wp::float32 var_1464;
    wp::int32 var_1465;
    wp::int32 var_1466;
    wp::int32 var_1467;
    wp::int32 var_1468;
    wp::float32* var_1469;
    wp::float32 var_1470;
    wp::float32 var_1471;
    wp::float32 var_1472;
    const wp::float32 var_1473 = 0.0;
    wp::float32 var_1474;
    wp::float32 var_1475;
    const wp::int32 var_1476 = 1;
    wp::int32 var_1477;
    wp::int32 var_1478;
    wp::int32 var_1479;
    wp::float32* var_1480;
    wp::float32 var_1481;
    wp::float32 var_1482;
    wp::int32 var_1483;
    wp::int32 var_1484;
    wp::int32 var_1485;
    wp::int32 var_1486;
    wp::float32* var_1487;
    wp::float32 var_1488;
    wp::float32 var_1489;
    wp::float32 var_1490;
    const wp::float32 var_1491 = 0.0;
    wp::float32 var_1492;
    wp::float32 var_1493;
    const wp::int32 var_1494 = 2;
    wp::int32 var_1495;
    wp::int32 var_1496;
    wp::int32 var_1497;
    wp::float32* var_1498;
    wp::float32 var_1499;
    wp::float32 var_1500;
    wp::int32 var_1501;
    wp::int32 var_1502;
    wp::int32 var_1503;
    wp::int32 var_1504;
    wp::float32* var_1505;
    wp::float32 var_1506;
    wp::float32 var_1507;
    wp::float32 var_1508;
    const wp::float32 var_1509 = 0.0;
    wp::float32 var_1510;
    wp::float32 var_1511;
    const wp::int32 var_1512 = 3;
    wp::int32 var_1513;
    wp::int32 var_1514;
    wp::int32 var_1515;
    wp::float32* var_1516;
    wp::float32 var_1517;
    wp::float32 var_1518;
    wp::int32 var_1519;
    wp::int32 var_1520;
    wp::int32 var_1521;
    wp::int32 var_1522;
    wp::float32* var_1523;
    wp::float32 var_1524;
    wp::float32 var_1525;
    wp::float32 var_1526;
    const wp::float32 var_1527 = 0.0;
    wp::float32 var_1528;
    wp::float32 var_1529;
    const wp::int32 var_1530 = 4;
    wp::int32 var_1531;
    wp::int32 var_1532;
    wp::int32 var_1533;
    wp::float32* var_1534;
    wp::float32 var_1535;
    wp::float32 var_1536;
    wp::int32 var_1537;
    wp::int32 var_1538;
    wp::int32 var_1539;
    wp::int32 var_1540;
    wp::float32* var_1541;
    wp::float32 var_1542;
    wp::float32 var_1543;
    wp::float32 var_1544;
    const wp::float32 var_1545 = 0.0;
    wp::float32 var_1546;
    wp::float32 var_1547;
    const wp::int32 var_1548 = 5;
    wp::int32 var_1549;
    wp::int32 var_1550;
    wp::int32 var_1551;
    wp::float32* var_1552;
    wp::float32 var_1553;
    wp::float32 var_1554;
    wp::int32 var_1555;
    wp::int32 var_1556;
    wp::int32 var_1557;
    wp::int32 var_1558;
    wp::float32* var_1559;
    wp::float32 var_1560;
    wp::float32 var_1561;
    wp::float32 var_1562;
    const wp::float32 var_1563 = 0.0;
    wp::float32 var_1564;
    wp::float32 var_1565;
    const wp::int32 var_1566 = 6;
    wp::int32 var_1567;
    wp::int32 var_1568;
    wp::int32 var_1569;
    wp::float32* var_1570;
    wp::float32 var_1571;
    wp::float32 var_1572;
    wp::int32 var_1573;
    wp::int32 var_1574;
    wp::int32 var_1575;
    wp::int32 var_1576;
    wp::float32* var_1577;
    wp::float32 var_1578;
    wp::float32 var_1579;
    wp::float32 var_1580;
    const wp::float32 var_1581 = 0.0;
    wp::float32 var_1582;
    wp::float32 var_1583;
    const wp::int32 var_1584 = 7;
    wp::int32 var_1585;
    wp::int32 var_1586;
    wp::int32 var_1587;
    wp::float32* var_1588;
    wp::float32 var_1589;
    wp::float32 var_1590;
    wp::int32 var_1591;
    wp::int32 var_1592;
    wp::int32 var_1593;
    wp::int32 var_1594;
    wp::float32* var_1595;
    wp::float32 var_1596;
    wp::float32 var_1597;
    wp::float32 var_1598;
    const wp::float32 var_1599 = 0.0;
    wp::float32 var_1600;
    wp::float32 var_1601;
    const wp::int32 var_1602 = 8;
    wp::int32 var_1603;
    wp::int32 var_1604;
    wp::int32 var_1605;
    wp::float32* var_1606;
    wp::float32 var_1607;
    wp::float32 var_1608;
    wp::int32 var_1609;
    wp::int32 var_1610;
    wp::int32 var_1611;
    wp::int32 var_1612;
    wp::float32* var_1613;
    wp::float32 var_1614;
    wp::float32 var_1615;
    wp::float32 var_1616;
    const wp::float32 var_1617 = 0.0;
    wp::float32 var_1618;
    wp::float32 var_1619;
    const wp::int32 var_1620 = 9;
    wp::int32 var_1621;
    wp::int32 var_1622;
    wp::int32 var_1623;
    wp::float32* var_1624;
    wp::float32 var_1625;
    wp::float32 var_1626;
    wp::int32 var_1627;
    wp::int32 var_1628;
    wp::int32 var_1629;
    wp::int32 var_1630;
    wp::float32* var_1631;
    wp::float32 var_1632;
    wp::float32 var_1633;
    wp::float32 var_1634;
    const wp::float32 var_1635 = 0.0;
    wp::float32 var_1636;
    wp::float32 var_1637;
    const wp::int32 var_1638 = 10;
    wp::int32 var_1639;
    wp::int32 var_1640;
    wp::int32 var_1641;
    wp::float32* var_1642;
    wp::float32 var_1643;
    wp::float32 var_1644;
    wp::int32 var_1645;
    wp::int32 var_1646;
    wp::int32 var_1647;
    wp::int32 var_1648;
    wp::float32* var_1649;
    wp::float32 var_1650;
    wp::float32 var_1651;
    wp::float32 var_1652;
    const wp::float32 var_1653 = 0.0;
    wp::float32 var_1654;
    wp::float32 var_1655;
    const wp::int32 var_1656 = 11;
    wp::int32 var_1657;
    wp::int32 var_1658;
    wp::int32 var_1659;
    wp::float32* var_1660;
    wp::float32 var_1661;
    wp::float32 var_1662;
    wp::int32 var_1663;
    wp::int32 var_1664;
    wp::int32 var_1665;
    wp::int32 var_1666;
    wp::float32* var_1667;
    wp::float32 var_1668;
    wp::float32 var_1669;
    wp::float32 var_1670;
    const wp::float32 var_1671 = 0.0;
    wp::float32 var_1672;
    wp::float32 var_1673;
    const wp::int32 var_1674 = 12;
    wp::int32 var_1675;
    wp::int32 var_1676;
    wp::int32 var_1677;
    wp::float32* var_1678;
    wp::float32 var_1679;
    wp::float32 var_1680;
    wp::int32 var_1681;
    wp::int32 var_1682;
    wp::int32 var_1683;
    wp::int32 var_1684;
    wp::float32* var_1685;
    wp::float32 var_1686;
    wp::float32 var_1687;
    wp::float32 var_1688;
    const wp::float32 var_1689 = 0.0;
    wp::float32 var_1690;
    wp::float32 var_1691;
    const wp::int32 var_1692 = 13;
    wp::int32 var_1693;
    wp::int32 var_1694;
    wp::int32 var_1695;
    wp::float32* var_1696;
    wp::float32 var_1697;
    wp::float32 var_1698;
    wp::int32 var_1699;
    wp::int32 var_1700;
    wp::int32 var_1701;
    wp::int32 var_1702;
    wp::float32* var_1703;
    wp::float32 var_1704;
    wp::float32 var_1705;
    wp::float32 var_1706;
    const wp::float32 var_1707 = 0.0;
    wp::float32 var_1708;
    wp::float32 var_1709;
    const wp::int32 var_1710 = 14;
    wp::int32 var_1711;
    wp::int32 var_1712;
    wp::int32 var_1713;
    wp::float32* var_1714;
    wp::float32 var_1715;
    wp::float32 var_1716;
    wp::int32 var_1717;
    wp::int32 var_1718;
    wp::int32 var_1719;
    wp::int32 var_1720;
    wp::float32* var_1721;
    wp::float32 var_1722;
    wp::float32 var_1723;
    wp::float32 var_1724;
    const wp::float32 var_1725 = 0.0;
    wp::float32 var_1726;
    wp::float32 var_1727;
    const wp::int32 var_1728 = 15;
    wp::int32 var_1729;
    wp::int32 var_1730;
    wp::int32 var_1731;
    wp::float32* var_1732;
    wp::float32 var_1733;
    wp::float32 var_1734;
    wp::int32 var_1735;
    wp::int32 var_1736;
    wp::int32 var_1737;
    wp::int32 var_1738;
    wp::float32* var_1739;
    wp::float32 var_1740;
    wp::float32 var_1741;
    wp::float32 var_1742;
    const wp::float32 var_1743 = 0.0;
    wp::float32 var_1744;
    wp::float32 var_1745;
    //---------
    // forward
    // def measure_children(node: int, boxes: array(dtype=float32), y: axes) -> lanes:        <L 93>
    // at = node * SIDES                                                                      <L 95>
    var_1 = wp::mul(var_node, var_0);
    // sqdists = lanes(0.0)                                                                   <L 96>
    var_3 = wp::vec_t<16, wp::float32>(var_2);
    // for k in range(BOXED):                                                                 <L 97>
    // x = y[k]                                                                               <L 98>
    var_5 = wp::extract(var_y, var_4);
    // for j in range(FAN):                                                                   <L 99>
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_8 = wp::mul(var_4, var_7);
    var_9 = wp::add(var_1, var_8);
    var_10 = wp::add(var_9, var_6);
    var_11 = wp::address(var_boxes, var_10);
    var_13 = wp::load(var_11);
    var_12 = wp::sub(var_13, var_5);
    var_15 = wp::add(var_14, var_4);
    var_16 = wp::mul(var_15, var_7);
    var_17 = wp::add(var_1, var_16);
    var_18 = wp::add(var_17, var_6);
    var_19 = wp::address(var_boxes, var_18);
    var_21 = wp::load(var_19);
    var_20 = wp::sub(var_5, var_21);
    var_22 = larger_0(var_12, var_20);
    var_24 = larger_0(var_22, var_23);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_25 = wp::mul(var_24, var_24);
    wp::add_inplace(var_3, var_6, var_25);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_27 = wp::mul(var_4, var_7);
    var_28 = wp::add(var_1, var_27);
    var_29 = wp::add(var_28, var_26);
    var_30 = wp::address(var_boxes, var_29);
    var_32 = wp::load(var_30);
    var_31 = wp::sub(var_32, var_5);
    var_33 = wp::add(var_14, var_4);
    var_34 = wp::mul(var_33, var_7);
    var_35 = wp::add(var_1, var_34);
    var_36 = wp::add(var_35, var_26);
    var_37 = wp::address(var_boxes, var_36);
    var_39 = wp::load(var_37);
    var_38 = wp::sub(var_5, var_39);
    var_40 = larger_0(var_31, var_38);
    var_42 = larger_0(var_40, var_41);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_43 = wp::mul(var_42, var_42);
    wp::add_inplace(var_3, var_26, var_43);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_45 = wp::mul(var_4, var_7);
    var_46 = wp::add(var_1, var_45);
    var_47 = wp::add(var_46, var_44);
    var_48 = wp::address(var_boxes, var_47);
    var_50 = wp::load(var_48);
    var_49 = wp::sub(var_50, var_5);
    var_51 = wp::add(var_14, var_4);
    var_52 = wp::mul(var_51, var_7);
    var_53 = wp::add(var_1, var_52);
    var_54 = wp::add(var_53, var_44);
    var_55 = wp::address(var_boxes, var_54);
    var_57 = wp::load(var_55);
    var_56 = wp::sub(var_5, var_57);
    var_58 = larger_0(var_49, var_56);
    var_60 = larger_0(var_58, var_59);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_61 = wp::mul(var_60, var_60);
    wp::add_inplace(var_3, var_44, var_61);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_63 = wp::mul(var_4, var_7);
    var_64 = wp::add(var_1, var_63);
    var_65 = wp::add(var_64, var_62);
    var_66 = wp::address(var_boxes, var_65);
    var_68 = wp::load(var_66);
    var_67 = wp::sub(var_68, var_5);
    var_69 = wp::add(var_14, var_4);
    var_70 = wp::mul(var_69, var_7);
    var_71 = wp::add(var_1, var_70);
    var_72 = wp::add(var_71, var_62);
    var_73 = wp::address(var_boxes, var_72);
    var_75 = wp::load(var_73);
    var_74 = wp::sub(var_5, var_75);
    var_76 = larger_0(var_67, var_74);
    var_78 = larger_0(var_76, var_77);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_79 = wp::mul(var_78, var_78);
    wp::add_inplace(var_3, var_62, var_79);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_81 = wp::mul(var_4, var_7);
    var_82 = wp::add(var_1, var_81);
    var_83 = wp::add(var_82, var_80);
    var_84 = wp::address(var_boxes, var_83);
    var_86 = wp::load(var_84);
    var_85 = wp::sub(var_86, var_5);
    var_87 = wp::add(var_14, var_4);
    var_88 = wp::mul(var_87, var_7);
    var_89 = wp::add(var_1, var_88);
    var_90 = wp::add(var_89, var_80);
    var_91 = wp::address(var_boxes, var_90);
    var_93 = wp::load(var_91);
    var_92 = wp::sub(var_5, var_93);
    var_94 = larger_0(var_85, var_92);
    var_96 = larger_0(var_94, var_95);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_97 = wp::mul(var_96, var_96);
    wp::add_inplace(var_3, var_80, var_97);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_99 = wp::mul(var_4, var_7);
    var_100 = wp::add(var_1, var_99);
    var_101 = wp::add(var_100, var_98);
    var_102 = wp::address(var_boxes, var_101);
    var_104 = wp::load(var_102);
    var_103 = wp::sub(var_104, var_5);
    var_105 = wp::add(var_14, var_4);
    var_106 = wp::mul(var_105, var_7);
    var_107 = wp::add(var_1, var_106);
    var_108 = wp::add(var_107, var_98);
    var_109 = wp::address(var_boxes, var_108);
    var_111 = wp::load(var_109);
    var_110 = wp::sub(var_5, var_111);
    var_112 = larger_0(var_103, var_110);
    var_114 = larger_0(var_112, var_113);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_115 = wp::mul(var_114, var_114);
    wp::add_inplace(var_3, var_98, var_115);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_117 = wp::mul(var_4, var_7);
    var_118 = wp::add(var_1, var_117);
    var_119 = wp::add(var_118, var_116);
    var_120 = wp::address(var_boxes, var_119);
    var_122 = wp::load(var_120);
    var_121 = wp::sub(var_122, var_5);
    var_123 = wp::add(var_14, var_4);
    var_124 = wp::mul(var_123, var_7);
    var_125 = wp::add(var_1, var_124);
    var_126 = wp::add(var_125, var_116);
    var_127 = wp::address(var_boxes, var_126);
    var_129 = wp::load(var_127);
    var_128 = wp::sub(var_5, var_129);
    var_130 = larger_0(var_121, var_128);
    var_132 = larger_0(var_130, var_131);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_133 = wp::mul(var_132, var_132);
    wp::add_inplace(var_3, var_116, var_133);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_135 = wp::mul(var_4, var_7);
    var_136 = wp::add(var_1, var_135);
    var_137 = wp::add(var_136, var_134);
    var_138 = wp::address(var_boxes, var_137);
    var_140 = wp::load(var_138);
    var_139 = wp::sub(var_140, var_5);
    var_141 = wp::add(var_14, var_4);
    var_142 = wp::mul(var_141, var_7);
    var_143 = wp::add(var_1, var_142);
    var_144 = wp::add(var_143, var_134);
    var_145 = wp::address(var_boxes, var_144);
    var_147 = wp::load(var_145);
    var_146 = wp::sub(var_5, var_147);
    var_148 = larger_0(var_139, var_146);
    var_150 = larger_0(var_148, var_149);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_151 = wp::mul(var_150, var_150);
    wp::add_inplace(var_3, var_134, var_151);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_153 = wp::mul(var_4, var_7);
    var_154 = wp::add(var_1, var_153);
    var_155 = wp::add(var_154, var_152);
    var_156 = wp::address(var_boxes, var_155);
    var_158 = wp::load(var_156);
    var_157 = wp::sub(var_158, var_5);
    var_159 = wp::add(var_14, var_4);
    var_160 = wp::mul(var_159, var_7);
    var_161 = wp::add(var_1, var_160);
    var_162 = wp::add(var_161, var_152);
    var_163 = wp::address(var_boxes, var_162);
    var_165 = wp::load(var_163);
    var_164 = wp::sub(var_5, var_165);
    var_166 = larger_0(var_157, var_164);
    var_168 = larger_0(var_166, var_167);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_169 = wp::mul(var_168, var_168);
    wp::add_inplace(var_3, var_152, var_169);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_171 = wp::mul(var_4, var_7);
    var_172 = wp::add(var_1, var_171);
    var_173 = wp::add(var_172, var_170);
    var_174 = wp::address(var_boxes, var_173);
    var_176 = wp::load(var_174);
    var_175 = wp::sub(var_176, var_5);
    var_177 = wp::add(var_14, var_4);
    var_178 = wp::mul(var_177, var_7);
    var_179 = wp::add(var_1, var_178);
    var_180 = wp::add(var_179, var_170);
    var_181 = wp::address(var_boxes, var_180);
    var_183 = wp::load(var_181);
    var_182 = wp::sub(var_5, var_183);
    var_184 = larger_0(var_175, var_182);
    var_186 = larger_0(var_184, var_185);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_187 = wp::mul(var_186, var_186);
    wp::add_inplace(var_3, var_170, var_187);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_189 = wp::mul(var_4, var_7);
    var_190 = wp::add(var_1, var_189);
    var_191 = wp::add(var_190, var_188);
    var_192 = wp::address(var_boxes, var_191);
    var_194 = wp::load(var_192);
    var_193 = wp::sub(var_194, var_5);
    var_195 = wp::add(var_14, var_4);
    var_196 = wp::mul(var_195, var_7);
    var_197 = wp::add(var_1, var_196);
    var_198 = wp::add(var_197, var_188);
    var_199 = wp::address(var_boxes, var_198);
    var_201 = wp::load(var_199);
    var_200 = wp::sub(var_5, var_201);
    var_202 = larger_0(var_193, var_200);
    var_204 = larger_0(var_202, var_203);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_205 = wp::mul(var_204, var_204);
    wp::add_inplace(var_3, var_188, var_205);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_207 = wp::mul(var_4, var_7);
    var_208 = wp::add(var_1, var_207);
    var_209 = wp::add(var_208, var_206);
    var_210 = wp::address(var_boxes, var_209);
    var_212 = wp::load(var_210);
    var_211 = wp::sub(var_212, var_5);
    var_213 = wp::add(var_14, var_4);
    var_214 = wp::mul(var_213, var_7);
    var_215 = wp::add(var_1, var_214);
    var_216 = wp::add(var_215, var_206);
    var_217 = wp::address(var_boxes, var_216);
    var_219 = wp::load(var_217);
    var_218 = wp::sub(var_5, var_219);
    var_220 = larger_0(var_211, var_218);
    var_222 = larger_0(var_220, var_221);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_223 = wp::mul(var_222, var_222);
    wp::add_inplace(var_3, var_206, var_223);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_225 = wp::mul(var_4, var_7);
    var_226 = wp::add(var_1, var_225);
    var_227 = wp::add(var_226, var_224);
    var_228 = wp::address(var_boxes, var_227);
    var_230 = wp::load(var_228);
    var_229 = wp::sub(var_230, var_5);
    var_231 = wp::add(var_14, var_4);
    var_232 = wp::mul(var_231, var_7);
    var_233 = wp::add(var_1, var_232);
    var_234 = wp::add(var_233, var_224);
    var_235 = wp::address(var_boxes, var_234);
    var_237 = wp::load(var_235);
    var_236 = wp::sub(var_5, var_237);
    var_238 = larger_0(var_229, var_236);
    var_240 = larger_0(var_238, var_239);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_241 = wp::mul(var_240, var_240);
    wp::add_inplace(var_3, var_224, var_241);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_243 = wp::mul(var_4, var_7);
    var_244 = wp::add(var_1, var_243);
    var_245 = wp::add(var_244, var_242);
    var_246 = wp::address(var_boxes, var_245);
    var_248 = wp::load(var_246);
    var_247 = wp::sub(var_248, var_5);
    var_249 = wp::add(var_14, var_4);
    var_250 = wp::mul(var_249, var_7);
    var_251 = wp::add(var_1, var_250);
    var_252 = wp::add(var_251, var_242);
    var_253 = wp::address(var_boxes, var_252);
    var_255 = wp::load(var_253);
    var_254 = wp::sub(var_5, var_255);
    var_256 = larger_0(var_247, var_254);
    var_258 = larger_0(var_256, var_257);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_259 = wp::mul(var_258, var_258);
    wp::add_inplace(var_3, var_242, var_259);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_261 = wp::mul(var_4, var_7);
    var_262 = wp::add(var_1, var_261);
    var_263 = wp::add(var_262, var_260);
    var_264 = wp::address(var_boxes, var_263);
    var_266 = wp::load(var_264);
    var_265 = wp::sub(var_266, var_5);
    var_267 = wp::add(var_14, var_4);
    var_268 = wp::mul(var_267, var_7);
    var_269 = wp::add(var_1, var_268);
    var_270 = wp::add(var_269, var_260);
    var_271 = wp::address(var_boxes, var_270);
    var_273 = wp::load(var_271);
    var_272 = wp::sub(var_5, var_273);
    var_274 = larger_0(var_265, var_272);
    var_276 = larger_0(var_274, var_275);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_277 = wp::mul(var_276, var_276);
    wp::add_inplace(var_3, var_260, var_277);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_279 = wp::mul(var_4, var_7);
    var_280 = wp::add(var_1, var_279);
    var_281 = wp::add(var_280, var_278);
    var_282 = wp::address(var_boxes, var_281);
    var_284 = wp::load(var_282);
    var_283 = wp::sub(var_284, var_5);
    var_285 = wp::add(var_14, var_4);
    var_286 = wp::mul(var_285, var_7);
    var_287 = wp::add(var_1, var_286);
    var_288 = wp::add(var_287, var_278);
    var_289 = wp::address(var_boxes, var_288);
    var_291 = wp::load(var_289);
    var_290 = wp::sub(var_5, var_291);
    var_292 = larger_0(var_283, var_290);
    var_294 = larger_0(var_292, var_293);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_295 = wp::mul(var_294, var_294);
    wp::add_inplace(var_3, var_278, var_295);
    // x = y[k]                                                                               <L 98>
    var_297 = wp::extract(var_y, var_296);
    // for j in range(FAN):                                                                   <L 99>
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_299 = wp::mul(var_296, var_7);
    var_300 = wp::add(var_1, var_299);
    var_301 = wp::add(var_300, var_298);
    var_302 = wp::address(var_boxes, var_301);
    var_304 = wp::load(var_302);
    var_303 = wp::sub(var_304, var_297);
    var_305 = wp::add(var_14, var_296);
    var_306 = wp::mul(var_305, var_7);
    var_307 = wp::add(var_1, var_306);
    var_308 = wp::add(var_307, var_298);
    var_309 = wp::address(var_boxes, var_308);
    var_311 = wp::load(var_309);
    var_310 = wp::sub(var_297, var_311);
    var_312 = larger_0(var_303, var_310);
    var_314 = larger_0(var_312, var_313);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_315 = wp::mul(var_314, var_314);
    wp::add_inplace(var_3, var_298, var_315);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_317 = wp::mul(var_296, var_7);
    var_318 = wp::add(var_1, var_317);
    var_319 = wp::add(var_318, var_316);
    var_320 = wp::address(var_boxes, var_319);
    var_322 = wp::load(var_320);
    var_321 = wp::sub(var_322, var_297);
    var_323 = wp::add(var_14, var_296);
    var_324 = wp::mul(var_323, var_7);
    var_325 = wp::add(var_1, var_324);
    var_326 = wp::add(var_325, var_316);
    var_327 = wp::address(var_boxes, var_326);
    var_329 = wp::load(var_327);
    var_328 = wp::sub(var_297, var_329);
    var_330 = larger_0(var_321, var_328);
    var_332 = larger_0(var_330, var_331);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_333 = wp::mul(var_332, var_332);
    wp::add_inplace(var_3, var_316, var_333);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_335 = wp::mul(var_296, var_7);
    var_336 = wp::add(var_1, var_335);
    var_337 = wp::add(var_336, var_334);
    var_338 = wp::address(var_boxes, var_337);
    var_340 = wp::load(var_338);
    var_339 = wp::sub(var_340, var_297);
    var_341 = wp::add(var_14, var_296);
    var_342 = wp::mul(var_341, var_7);
    var_343 = wp::add(var_1, var_342);
    var_344 = wp::add(var_343, var_334);
    var_345 = wp::address(var_boxes, var_344);
    var_347 = wp::load(var_345);
    var_346 = wp::sub(var_297, var_347);
    var_348 = larger_0(var_339, var_346);
    var_350 = larger_0(var_348, var_349);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_351 = wp::mul(var_350, var_350);
    wp::add_inplace(var_3, var_334, var_351);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_353 = wp::mul(var_296, var_7);
    var_354 = wp::add(var_1, var_353);
    var_355 = wp::add(var_354, var_352);
    var_356 = wp::address(var_boxes, var_355);
    var_358 = wp::load(var_356);
    var_357 = wp::sub(var_358, var_297);
    var_359 = wp::add(var_14, var_296);
    var_360 = wp::mul(var_359, var_7);
    var_361 = wp::add(var_1, var_360);
    var_362 = wp::add(var_361, var_352);
    var_363 = wp::address(var_boxes, var_362);
    var_365 = wp::load(var_363);
    var_364 = wp::sub(var_297, var_365);
    var_366 = larger_0(var_357, var_364);
    var_368 = larger_0(var_366, var_367);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_369 = wp::mul(var_368, var_368);
    wp::add_inplace(var_3, var_352, var_369);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_371 = wp::mul(var_296, var_7);
    var_372 = wp::add(var_1, var_371);
    var_373 = wp::add(var_372, var_370);
    var_374 = wp::address(var_boxes, var_373);
    var_376 = wp::load(var_374);
    var_375 = wp::sub(var_376, var_297);
    var_377 = wp::add(var_14, var_296);
    var_378 = wp::mul(var_377, var_7);
    var_379 = wp::add(var_1, var_378);
    var_380 = wp::add(var_379, var_370);
    var_381 = wp::address(var_boxes, var_380);
    var_383 = wp::load(var_381);
    var_382 = wp::sub(var_297, var_383);
    var_384 = larger_0(var_375, var_382);
    var_386 = larger_0(var_384, var_385);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_387 = wp::mul(var_386, var_386);
    wp::add_inplace(var_3, var_370, var_387);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_389 = wp::mul(var_296, var_7);
    var_390 = wp::add(var_1, var_389);
    var_391 = wp::add(var_390, var_388);
    var_392 = wp::address(var_boxes, var_391);
    var_394 = wp::load(var_392);
    var_393 = wp::sub(var_394, var_297);
    var_395 = wp::add(var_14, var_296);
    var_396 = wp::mul(var_395, var_7);
    var_397 = wp::add(var_1, var_396);
    var_398 = wp::add(var_397, var_388);
    var_399 = wp::address(var_boxes, var_398);
    var_401 = wp::load(var_399);
    var_400 = wp::sub(var_297, var_401);
    var_402 = larger_0(var_393, var_400);
    var_404 = larger_0(var_402, var_403);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_405 = wp::mul(var_404, var_404);
    wp::add_inplace(var_3, var_388, var_405);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_407 = wp::mul(var_296, var_7);
    var_408 = wp::add(var_1, var_407);
    var_409 = wp::add(var_408, var_406);
    var_410 = wp::address(var_boxes, var_409);
    var_412 = wp::load(var_410);
    var_411 = wp::sub(var_412, var_297);
    var_413 = wp::add(var_14, var_296);
    var_414 = wp::mul(var_413, var_7);
    var_415 = wp::add(var_1, var_414);
    var_416 = wp::add(var_415, var_406);
    var_417 = wp::address(var_boxes, var_416);
    var_419 = wp::load(var_417);
    var_418 = wp::sub(var_297, var_419);
    var_420 = larger_0(var_411, var_418);
    var_422 = larger_0(var_420, var_421);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_423 = wp::mul(var_422, var_422);
    wp::add_inplace(var_3, var_406, var_423);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_425 = wp::mul(var_296, var_7);
    var_426 = wp::add(var_1, var_425);
    var_427 = wp::add(var_426, var_424);
    var_428 = wp::address(var_boxes, var_427);
    var_430 = wp::load(var_428);
    var_429 = wp::sub(var_430, var_297);
    var_431 = wp::add(var_14, var_296);
    var_432 = wp::mul(var_431, var_7);
    var_433 = wp::add(var_1, var_432);
    var_434 = wp::add(var_433, var_424);
    var_435 = wp::address(var_boxes, var_434);
    var_437 = wp::load(var_435);
    var_436 = wp::sub(var_297, var_437);
    var_438 = larger_0(var_429, var_436);
    var_440 = larger_0(var_438, var_439);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_441 = wp::mul(var_440, var_440);
    wp::add_inplace(var_3, var_424, var_441);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_443 = wp::mul(var_296, var_7);
    var_444 = wp::add(var_1, var_443);
    var_445 = wp::add(var_444, var_442);
    var_446 = wp::address(var_boxes, var_445);
    var_448 = wp::load(var_446);
    var_447 = wp::sub(var_448, var_297);
    var_449 = wp::add(var_14, var_296);
    var_450 = wp::mul(var_449, var_7);
    var_451 = wp::add(var_1, var_450);
    var_452 = wp::add(var_451, var_442);
    var_453 = wp::address(var_boxes, var_452);
    var_455 = wp::load(var_453);
    var_454 = wp::sub(var_297, var_455);
    var_456 = larger_0(var_447, var_454);
    var_458 = larger_0(var_456, var_457);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_459 = wp::mul(var_458, var_458);
    wp::add_inplace(var_3, var_442, var_459);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_461 = wp::mul(var_296, var_7);
    var_462 = wp::add(var_1, var_461);
    var_463 = wp::add(var_462, var_460);
    var_464 = wp::address(var_boxes, var_463);
    var_466 = wp::load(var_464);
    var_465 = wp::sub(var_466, var_297);
    var_467 = wp::add(var_14, var_296);
    var_468 = wp::mul(var_467, var_7);
    var_469 = wp::add(var_1, var_468);
    var_470 = wp::add(var_469, var_460);
    var_471 = wp::address(var_boxes, var_470);
    var_473 = wp::load(var_471);
    var_472 = wp::sub(var_297, var_473);
    var_474 = larger_0(var_465, var_472);
    var_476 = larger_0(var_474, var_475);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_477 = wp::mul(var_476, var_476);
    wp::add_inplace(var_3, var_460, var_477);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_479 = wp::mul(var_296, var_7);
    var_480 = wp::add(var_1, var_479);
    var_481 = wp::add(var_480, var_478);
    var_482 = wp::address(var_boxes, var_481);
    var_484 = wp::load(var_482);
    var_483 = wp::sub(var_484, var_297);
    var_485 = wp::add(var_14, var_296);
    var_486 = wp::mul(var_485, var_7);
    var_487 = wp::add(var_1, var_486);
    var_488 = wp::add(var_487, var_478);
    var_489 = wp::address(var_boxes, var_488);
    var_491 = wp::load(var_489);
    var_490 = wp::sub(var_297, var_491);
    var_492 = larger_0(var_483, var_490);
    var_494 = larger_0(var_492, var_493);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_495 = wp::mul(var_494, var_494);
    wp::add_inplace(var_3, var_478, var_495);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_497 = wp::mul(var_296, var_7);
    var_498 = wp::add(var_1, var_497);
    var_499 = wp::add(var_498, var_496);
    var_500 = wp::address(var_boxes, var_499);
    var_502 = wp::load(var_500);
    var_501 = wp::sub(var_502, var_297);
    var_503 = wp::add(var_14, var_296);
    var_504 = wp::mul(var_503, var_7);
    var_505 = wp::add(var_1, var_504);
    var_506 = wp::add(var_505, var_496);
    var_507 = wp::address(var_boxes, var_506);
    var_509 = wp::load(var_507);
    var_508 = wp::sub(var_297, var_509);
    var_510 = larger_0(var_501, var_508);
    var_512 = larger_0(var_510, var_511);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_513 = wp::mul(var_512, var_512);
    wp::add_inplace(var_3, var_496, var_513);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_515 = wp::mul(var_296, var_7);
    var_516 = wp::add(var_1, var_515);
    var_517 = wp::add(var_516, var_514);
    var_518 = wp::address(var_boxes, var_517);
    var_520 = wp::load(var_518);
    var_519 = wp::sub(var_520, var_297);
    var_521 = wp::add(var_14, var_296);
    var_522 = wp::mul(var_521, var_7);
    var_523 = wp::add(var_1, var_522);
    var_524 = wp::add(var_523, var_514);
    var_525 = wp::address(var_boxes, var_524);
    var_527 = wp::load(var_525);
    var_526 = wp::sub(var_297, var_527);
    var_528 = larger_0(var_519, var_526);
    var_530 = larger_0(var_528, var_529);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_531 = wp::mul(var_530, var_530);
    wp::add_inplace(var_3, var_514, var_531);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_533 = wp::mul(var_296, var_7);
    var_534 = wp::add(var_1, var_533);
    var_535 = wp::add(var_534, var_532);
    var_536 = wp::address(var_boxes, var_535);
    var_538 = wp::load(var_536);
    var_537 = wp::sub(var_538, var_297);
    var_539 = wp::add(var_14, var_296);
    var_540 = wp::mul(var_539, var_7);
    var_541 = wp::add(var_1, var_540);
    var_542 = wp::add(var_541, var_532);
    var_543 = wp::address(var_boxes, var_542);
    var_545 = wp::load(var_543);
    var_544 = wp::sub(var_297, var_545);
    var_546 = larger_0(var_537, var_544);
    var_548 = larger_0(var_546, var_547);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_549 = wp::mul(var_548, var_548);
    wp::add_inplace(var_3, var_532, var_549);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_551 = wp::mul(var_296, var_7);
    var_552 = wp::add(var_1, var_551);
    var_553 = wp::add(var_552, var_550);
    var_554 = wp::address(var_boxes, var_553);
    var_556 = wp::load(var_554);
    var_555 = wp::sub(var_556, var_297);
    var_557 = wp::add(var_14, var_296);
    var_558 = wp::mul(var_557, var_7);
    var_559 = wp::add(var_1, var_558);
    var_560 = wp::add(var_559, var_550);
    var_561 = wp::address(var_boxes, var_560);
    var_563 = wp::load(var_561);
    var_562 = wp::sub(var_297, var_563);
    var_564 = larger_0(var_555, var_562);
    var_566 = larger_0(var_564, var_565);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_567 = wp::mul(var_566, var_566);
    wp::add_inplace(var_3, var_550, var_567);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_569 = wp::mul(var_296, var_7);
    var_570 = wp::add(var_1, var_569);
    var_571 = wp::add(var_570, var_568);
    var_572 = wp::address(var_boxes, var_571);
    var_574 = wp::load(var_572);
    var_573 = wp::sub(var_574, var_297);
    var_575 = wp::add(var_14, var_296);
    var_576 = wp::mul(var_575, var_7);
    var_577 = wp::add(var_1, var_576);
    var_578 = wp::add(var_577, var_568);
    var_579 = wp::address(var_boxes, var_578);
    var_581 = wp::load(var_579);
    var_580 = wp::sub(var_297, var_581);
    var_582 = larger_0(var_573, var_580);
    var_584 = larger_0(var_582, var_583);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_585 = wp::mul(var_584, var_584);
    wp::add_inplace(var_3, var_568, var_585);
    // x = y[k]                                                                               <L 98>
    var_587 = wp::extract(var_y, var_586);
    // for j in range(FAN):                                                                   <L 99>
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_589 = wp::mul(var_586, var_7);
    var_590 = wp::add(var_1, var_589);
    var_591 = wp::add(var_590, var_588);
    var_592 = wp::address(var_boxes, var_591);
    var_594 = wp::load(var_592);
    var_593 = wp::sub(var_594, var_587);
    var_595 = wp::add(var_14, var_586);
    var_596 = wp::mul(var_595, var_7);
    var_597 = wp::add(var_1, var_596);
    var_598 = wp::add(var_597, var_588);
    var_599 = wp::address(var_boxes, var_598);
    var_601 = wp::load(var_599);
    var_600 = wp::sub(var_587, var_601);
    var_602 = larger_0(var_593, var_600);
    var_604 = larger_0(var_602, var_603);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_605 = wp::mul(var_604, var_604);
    wp::add_inplace(var_3, var_588, var_605);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_607 = wp::mul(var_586, var_7);
    var_608 = wp::add(var_1, var_607);
    var_609 = wp::add(var_608, var_606);
    var_610 = wp::address(var_boxes, var_609);
    var_612 = wp::load(var_610);
    var_611 = wp::sub(var_612, var_587);
    var_613 = wp::add(var_14, var_586);
    var_614 = wp::mul(var_613, var_7);
    var_615 = wp::add(var_1, var_614);
    var_616 = wp::add(var_615, var_606);
    var_617 = wp::address(var_boxes, var_616);
    var_619 = wp::load(var_617);
    var_618 = wp::sub(var_587, var_619);
    var_620 = larger_0(var_611, var_618);
    var_622 = larger_0(var_620, var_621);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_623 = wp::mul(var_622, var_622);
    wp::add_inplace(var_3, var_606, var_623);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_625 = wp::mul(var_586, var_7);
    var_626 = wp::add(var_1, var_625);
    var_627 = wp::add(var_626, var_624);
    var_628 = wp::address(var_boxes, var_627);
    var_630 = wp::load(var_628);
    var_629 = wp::sub(var_630, var_587);
    var_631 = wp::add(var_14, var_586);
    var_632 = wp::mul(var_631, var_7);
    var_633 = wp::add(var_1, var_632);
    var_634 = wp::add(var_633, var_624);
    var_635 = wp::address(var_boxes, var_634);
    var_637 = wp::load(var_635);
    var_636 = wp::sub(var_587, var_637);
    var_638 = larger_0(var_629, var_636);
    var_640 = larger_0(var_638, var_639);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_641 = wp::mul(var_640, var_640);
    wp::add_inplace(var_3, var_624, var_641);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_643 = wp::mul(var_586, var_7);
    var_644 = wp::add(var_1, var_643);
    var_645 = wp::add(var_644, var_642);
    var_646 = wp::address(var_boxes, var_645);
    var_648 = wp::load(var_646);
    var_647 = wp::sub(var_648, var_587);
    var_649 = wp::add(var_14, var_586);
    var_650 = wp::mul(var_649, var_7);
    var_651 = wp::add(var_1, var_650);
    var_652 = wp::add(var_651, var_642);
    var_653 = wp::address(var_boxes, var_652);
    var_655 = wp::load(var_653);
    var_654 = wp::sub(var_587, var_655);
    var_656 = larger_0(var_647, var_654);
    var_658 = larger_0(var_656, var_657);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_659 = wp::mul(var_658, var_658);
    wp::add_inplace(var_3, var_642, var_659);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_661 = wp::mul(var_586, var_7);
    var_662 = wp::add(var_1, var_661);
    var_663 = wp::add(var_662, var_660);
    var_664 = wp::address(var_boxes, var_663);
    var_666 = wp::load(var_664);
    var_665 = wp::sub(var_666, var_587);
    var_667 = wp::add(var_14, var_586);
    var_668 = wp::mul(var_667, var_7);
    var_669 = wp::add(var_1, var_668);
    var_670 = wp::add(var_669, var_660);
    var_671 = wp::address(var_boxes, var_670);
    var_673 = wp::load(var_671);
    var_672 = wp::sub(var_587, var_673);
    var_674 = larger_0(var_665, var_672);
    var_676 = larger_0(var_674, var_675);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_677 = wp::mul(var_676, var_676);
    wp::add_inplace(var_3, var_660, var_677);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_679 = wp::mul(var_586, var_7);
    var_680 = wp::add(var_1, var_679);
    var_681 = wp::add(var_680, var_678);
    var_682 = wp::address(var_boxes, var_681);
    var_684 = wp::load(var_682);
    var_683 = wp::sub(var_684, var_587);
    var_685 = wp::add(var_14, var_586);
    var_686 = wp::mul(var_685, var_7);
    var_687 = wp::add(var_1, var_686);
    var_688 = wp::add(var_687, var_678);
    var_689 = wp::address(var_boxes, var_688);
    var_691 = wp::load(var_689);
    var_690 = wp::sub(var_587, var_691);
    var_692 = larger_0(var_683, var_690);
    var_694 = larger_0(var_692, var_693);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_695 = wp::mul(var_694, var_694);
    wp::add_inplace(var_3, var_678, var_695);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_697 = wp::mul(var_586, var_7);
    var_698 = wp::add(var_1, var_697);
    var_699 = wp::add(var_698, var_696);
    var_700 = wp::address(var_boxes, var_699);
    var_702 = wp::load(var_700);
    var_701 = wp::sub(var_702, var_587);
    var_703 = wp::add(var_14, var_586);
    var_704 = wp::mul(var_703, var_7);
    var_705 = wp::add(var_1, var_704);
    var_706 = wp::add(var_705, var_696);
    var_707 = wp::address(var_boxes, var_706);
    var_709 = wp::load(var_707);
    var_708 = wp::sub(var_587, var_709);
    var_710 = larger_0(var_701, var_708);
    var_712 = larger_0(var_710, var_711);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_713 = wp::mul(var_712, var_712);
    wp::add_inplace(var_3, var_696, var_713);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_715 = wp::mul(var_586, var_7);
    var_716 = wp::add(var_1, var_715);
    var_717 = wp::add(var_716, var_714);
    var_718 = wp::address(var_boxes, var_717);
    var_720 = wp::load(var_718);
    var_719 = wp::sub(var_720, var_587);
    var_721 = wp::add(var_14, var_586);
    var_722 = wp::mul(var_721, var_7);
    var_723 = wp::add(var_1, var_722);
    var_724 = wp::add(var_723, var_714);
    var_725 = wp::address(var_boxes, var_724);
    var_727 = wp::load(var_725);
    var_726 = wp::sub(var_587, var_727);
    var_728 = larger_0(var_719, var_726);
    var_730 = larger_0(var_728, var_729);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_731 = wp::mul(var_730, var_730);
    wp::add_inplace(var_3, var_714, var_731);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_733 = wp::mul(var_586, var_7);
    var_734 = wp::add(var_1, var_733);
    var_735 = wp::add(var_734, var_732);
    var_736 = wp::address(var_boxes, var_735);
    var_738 = wp::load(var_736);
    var_737 = wp::sub(var_738, var_587);
    var_739 = wp::add(var_14, var_586);
    var_740 = wp::mul(var_739, var_7);
    var_741 = wp::add(var_1, var_740);
    var_742 = wp::add(var_741, var_732);
    var_743 = wp::address(var_boxes, var_742);
    var_745 = wp::load(var_743);
    var_744 = wp::sub(var_587, var_745);
    var_746 = larger_0(var_737, var_744);
    var_748 = larger_0(var_746, var_747);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_749 = wp::mul(var_748, var_748);
    wp::add_inplace(var_3, var_732, var_749);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_751 = wp::mul(var_586, var_7);
    var_752 = wp::add(var_1, var_751);
    var_753 = wp::add(var_752, var_750);
    var_754 = wp::address(var_boxes, var_753);
    var_756 = wp::load(var_754);
    var_755 = wp::sub(var_756, var_587);
    var_757 = wp::add(var_14, var_586);
    var_758 = wp::mul(var_757, var_7);
    var_759 = wp::add(var_1, var_758);
    var_760 = wp::add(var_759, var_750);
    var_761 = wp::address(var_boxes, var_760);
    var_763 = wp::load(var_761);
    var_762 = wp::sub(var_587, var_763);
    var_764 = larger_0(var_755, var_762);
    var_766 = larger_0(var_764, var_765);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_767 = wp::mul(var_766, var_766);
    wp::add_inplace(var_3, var_750, var_767);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_769 = wp::mul(var_586, var_7);
    var_770 = wp::add(var_1, var_769);
    var_771 = wp::add(var_770, var_768);
    var_772 = wp::address(var_boxes, var_771);
    var_774 = wp::load(var_772);
    var_773 = wp::sub(var_774, var_587);
    var_775 = wp::add(var_14, var_586);
    var_776 = wp::mul(var_775, var_7);
    var_777 = wp::add(var_1, var_776);
    var_778 = wp::add(var_777, var_768);
    var_779 = wp::address(var_boxes, var_778);
    var_781 = wp::load(var_779);
    var_780 = wp::sub(var_587, var_781);
    var_782 = larger_0(var_773, var_780);
    var_784 = larger_0(var_782, var_783);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_785 = wp::mul(var_784, var_784);
    wp::add_inplace(var_3, var_768, var_785);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_787 = wp::mul(var_586, var_7);
    var_788 = wp::add(var_1, var_787);
    var_789 = wp::add(var_788, var_786);
    var_790 = wp::address(var_boxes, var_789);
    var_792 = wp::load(var_790);
    var_791 = wp::sub(var_792, var_587);
    var_793 = wp::add(var_14, var_586);
    var_794 = wp::mul(var_793, var_7);
    var_795 = wp::add(var_1, var_794);
    var_796 = wp::add(var_795, var_786);
    var_797 = wp::address(var_boxes, var_796);
    var_799 = wp::load(var_797);
    var_798 = wp::sub(var_587, var_799);
    var_800 = larger_0(var_791, var_798);
    var_802 = larger_0(var_800, var_801);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_803 = wp::mul(var_802, var_802);
    wp::add_inplace(var_3, var_786, var_803);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_805 = wp::mul(var_586, var_7);
    var_806 = wp::add(var_1, var_805);
    var_807 = wp::add(var_806, var_804);
    var_808 = wp::address(var_boxes, var_807);
    var_810 = wp::load(var_808);
    var_809 = wp::sub(var_810, var_587);
    var_811 = wp::add(var_14, var_586);
    var_812 = wp::mul(var_811, var_7);
    var_813 = wp::add(var_1, var_812);
    var_814 = wp::add(var_813, var_804);
    var_815 = wp::address(var_boxes, var_814);
    var_817 = wp::load(var_815);
    var_816 = wp::sub(var_587, var_817);
    var_818 = larger_0(var_809, var_816);
    var_820 = larger_0(var_818, var_819);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_821 = wp::mul(var_820, var_820);
    wp::add_inplace(var_3, var_804, var_821);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_823 = wp::mul(var_586, var_7);
    var_824 = wp::add(var_1, var_823);
    var_825 = wp::add(var_824, var_822);
    var_826 = wp::address(var_boxes, var_825);
    var_828 = wp::load(var_826);
    var_827 = wp::sub(var_828, var_587);
    var_829 = wp::add(var_14, var_586);
    var_830 = wp::mul(var_829, var_7);
    var_831 = wp::add(var_1, var_830);
    var_832 = wp::add(var_831, var_822);
    var_833 = wp::address(var_boxes, var_832);
    var_835 = wp::load(var_833);
    var_834 = wp::sub(var_587, var_835);
    var_836 = larger_0(var_827, var_834);
    var_838 = larger_0(var_836, var_837);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_839 = wp::mul(var_838, var_838);
    wp::add_inplace(var_3, var_822, var_839);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_841 = wp::mul(var_586, var_7);
    var_842 = wp::add(var_1, var_841);
    var_843 = wp::add(var_842, var_840);
    var_844 = wp::address(var_boxes, var_843);
    var_846 = wp::load(var_844);
    var_845 = wp::sub(var_846, var_587);
    var_847 = wp::add(var_14, var_586);
    var_848 = wp::mul(var_847, var_7);
    var_849 = wp::add(var_1, var_848);
    var_850 = wp::add(var_849, var_840);
    var_851 = wp::address(var_boxes, var_850);
    var_853 = wp::load(var_851);
    var_852 = wp::sub(var_587, var_853);
    var_854 = larger_0(var_845, var_852);
    var_856 = larger_0(var_854, var_855);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_857 = wp::mul(var_856, var_856);
    wp::add_inplace(var_3, var_840, var_857);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_859 = wp::mul(var_586, var_7);
    var_860 = wp::add(var_1, var_859);
    var_861 = wp::add(var_860, var_858);
    var_862 = wp::address(var_boxes, var_861);
    var_864 = wp::load(var_862);
    var_863 = wp::sub(var_864, var_587);
    var_865 = wp::add(var_14, var_586);
    var_866 = wp::mul(var_865, var_7);
    var_867 = wp::add(var_1, var_866);
    var_868 = wp::add(var_867, var_858);
    var_869 = wp::address(var_boxes, var_868);
    var_871 = wp::load(var_869);
    var_870 = wp::sub(var_587, var_871);
    var_872 = larger_0(var_863, var_870);
    var_874 = larger_0(var_872, var_873);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_875 = wp::mul(var_874, var_874);
    wp::add_inplace(var_3, var_858, var_875);
    // x = y[k]                                                                               <L 98>
    var_877 = wp::extract(var_y, var_876);
    // for j in range(FAN):                                                                   <L 99>
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_879 = wp::mul(var_876, var_7);
    var_880 = wp::add(var_1, var_879);
    var_881 = wp::add(var_880, var_878);
    var_882 = wp::address(var_boxes, var_881);
    var_884 = wp::load(var_882);
    var_883 = wp::sub(var_884, var_877);
    var_885 = wp::add(var_14, var_876);
    var_886 = wp::mul(var_885, var_7);
    var_887 = wp::add(var_1, var_886);
    var_888 = wp::add(var_887, var_878);
    var_889 = wp::address(var_boxes, var_888);
    var_891 = wp::load(var_889);
    var_890 = wp::sub(var_877, var_891);
    var_892 = larger_0(var_883, var_890);
    var_894 = larger_0(var_892, var_893);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_895 = wp::mul(var_894, var_894);
    wp::add_inplace(var_3, var_878, var_895);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_897 = wp::mul(var_876, var_7);
    var_898 = wp::add(var_1, var_897);
    var_899 = wp::add(var_898, var_896);
    var_900 = wp::address(var_boxes, var_899);
    var_902 = wp::load(var_900);
    var_901 = wp::sub(var_902, var_877);
    var_903 = wp::add(var_14, var_876);
    var_904 = wp::mul(var_903, var_7);
    var_905 = wp::add(var_1, var_904);
    var_906 = wp::add(var_905, var_896);
    var_907 = wp::address(var_boxes, var_906);
    var_909 = wp::load(var_907);
    var_908 = wp::sub(var_877, var_909);
    var_910 = larger_0(var_901, var_908);
    var_912 = larger_0(var_910, var_911);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_913 = wp::mul(var_912, var_912);
    wp::add_inplace(var_3, var_896, var_913);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_915 = wp::mul(var_876, var_7);
    var_916 = wp::add(var_1, var_915);
    var_917 = wp::add(var_916, var_914);
    var_918 = wp::address(var_boxes, var_917);
    var_920 = wp::load(var_918);
    var_919 = wp::sub(var_920, var_877);
    var_921 = wp::add(var_14, var_876);
    var_922 = wp::mul(var_921, var_7);
    var_923 = wp::add(var_1, var_922);
    var_924 = wp::add(var_923, var_914);
    var_925 = wp::address(var_boxes, var_924);
    var_927 = wp::load(var_925);
    var_926 = wp::sub(var_877, var_927);
    var_928 = larger_0(var_919, var_926);
    var_930 = larger_0(var_928, var_929);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_931 = wp::mul(var_930, var_930);
    wp::add_inplace(var_3, var_914, var_931);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_933 = wp::mul(var_876, var_7);
    var_934 = wp::add(var_1, var_933);
    var_935 = wp::add(var_934, var_932);
    var_936 = wp::address(var_boxes, var_935);
    var_938 = wp::load(var_936);
    var_937 = wp::sub(var_938, var_877);
    var_939 = wp::add(var_14, var_876);
    var_940 = wp::mul(var_939, var_7);
    var_941 = wp::add(var_1, var_940);
    var_942 = wp::add(var_941, var_932);
    var_943 = wp::address(var_boxes, var_942);
    var_945 = wp::load(var_943);
    var_944 = wp::sub(var_877, var_945);
    var_946 = larger_0(var_937, var_944);
    var_948 = larger_0(var_946, var_947);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_949 = wp::mul(var_948, var_948);
    wp::add_inplace(var_3, var_932, var_949);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_951 = wp::mul(var_876, var_7);
    var_952 = wp::add(var_1, var_951);
    var_953 = wp::add(var_952, var_950);
    var_954 = wp::address(var_boxes, var_953);
    var_956 = wp::load(var_954);
    var_955 = wp::sub(var_956, var_877);
    var_957 = wp::add(var_14, var_876);
    var_958 = wp::mul(var_957, var_7);
    var_959 = wp::add(var_1, var_958);
    var_960 = wp::add(var_959, var_950);
    var_961 = wp::address(var_boxes, var_960);
    var_963 = wp::load(var_961);
    var_962 = wp::sub(var_877, var_963);
    var_964 = larger_0(var_955, var_962);
    var_966 = larger_0(var_964, var_965);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_967 = wp::mul(var_966, var_966);
    wp::add_inplace(var_3, var_950, var_967);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_969 = wp::mul(var_876, var_7);
    var_970 = wp::add(var_1, var_969);
    var_971 = wp::add(var_970, var_968);
    var_972 = wp::address(var_boxes, var_971);
    var_974 = wp::load(var_972);
    var_973 = wp::sub(var_974, var_877);
    var_975 = wp::add(var_14, var_876);
    var_976 = wp::mul(var_975, var_7);
    var_977 = wp::add(var_1, var_976);
    var_978 = wp::add(var_977, var_968);
    var_979 = wp::address(var_boxes, var_978);
    var_981 = wp::load(var_979);
    var_980 = wp::sub(var_877, var_981);
    var_982 = larger_0(var_973, var_980);
    var_984 = larger_0(var_982, var_983);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_985 = wp::mul(var_984, var_984);
    wp::add_inplace(var_3, var_968, var_985);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_987 = wp::mul(var_876, var_7);
    var_988 = wp::add(var_1, var_987);
    var_989 = wp::add(var_988, var_986);
    var_990 = wp::address(var_boxes, var_989);
    var_992 = wp::load(var_990);
    var_991 = wp::sub(var_992, var_877);
    var_993 = wp::add(var_14, var_876);
    var_994 = wp::mul(var_993, var_7);
    var_995 = wp::add(var_1, var_994);
    var_996 = wp::add(var_995, var_986);
    var_997 = wp::address(var_boxes, var_996);
    var_999 = wp::load(var_997);
    var_998 = wp::sub(var_877, var_999);
    var_1000 = larger_0(var_991, var_998);
    var_1002 = larger_0(var_1000, var_1001);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1003 = wp::mul(var_1002, var_1002);
    wp::add_inplace(var_3, var_986, var_1003);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1005 = wp::mul(var_876, var_7);
    var_1006 = wp::add(var_1, var_1005);
    var_1007 = wp::add(var_1006, var_1004);
    var_1008 = wp::address(var_boxes, var_1007);
    var_1010 = wp::load(var_1008);
    var_1009 = wp::sub(var_1010, var_877);
    var_1011 = wp::add(var_14, var_876);
    var_1012 = wp::mul(var_1011, var_7);
    var_1013 = wp::add(var_1, var_1012);
    var_1014 = wp::add(var_1013, var_1004);
    var_1015 = wp::address(var_boxes, var_1014);
    var_1017 = wp::load(var_1015);
    var_1016 = wp::sub(var_877, var_1017);
    var_1018 = larger_0(var_1009, var_1016);
    var_1020 = larger_0(var_1018, var_1019);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1021 = wp::mul(var_1020, var_1020);
    wp::add_inplace(var_3, var_1004, var_1021);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1023 = wp::mul(var_876, var_7);
    var_1024 = wp::add(var_1, var_1023);
    var_1025 = wp::add(var_1024, var_1022);
    var_1026 = wp::address(var_boxes, var_1025);
    var_1028 = wp::load(var_1026);
    var_1027 = wp::sub(var_1028, var_877);
    var_1029 = wp::add(var_14, var_876);
    var_1030 = wp::mul(var_1029, var_7);
    var_1031 = wp::add(var_1, var_1030);
    var_1032 = wp::add(var_1031, var_1022);
    var_1033 = wp::address(var_boxes, var_1032);
    var_1035 = wp::load(var_1033);
    var_1034 = wp::sub(var_877, var_1035);
    var_1036 = larger_0(var_1027, var_1034);
    var_1038 = larger_0(var_1036, var_1037);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1039 = wp::mul(var_1038, var_1038);
    wp::add_inplace(var_3, var_1022, var_1039);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1041 = wp::mul(var_876, var_7);
    var_1042 = wp::add(var_1, var_1041);
    var_1043 = wp::add(var_1042, var_1040);
    var_1044 = wp::address(var_boxes, var_1043);
    var_1046 = wp::load(var_1044);
    var_1045 = wp::sub(var_1046, var_877);
    var_1047 = wp::add(var_14, var_876);
    var_1048 = wp::mul(var_1047, var_7);
    var_1049 = wp::add(var_1, var_1048);
    var_1050 = wp::add(var_1049, var_1040);
    var_1051 = wp::address(var_boxes, var_1050);
    var_1053 = wp::load(var_1051);
    var_1052 = wp::sub(var_877, var_1053);
    var_1054 = larger_0(var_1045, var_1052);
    var_1056 = larger_0(var_1054, var_1055);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1057 = wp::mul(var_1056, var_1056);
    wp::add_inplace(var_3, var_1040, var_1057);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1059 = wp::mul(var_876, var_7);
    var_1060 = wp::add(var_1, var_1059);
    var_1061 = wp::add(var_1060, var_1058);
    var_1062 = wp::address(var_boxes, var_1061);
    var_1064 = wp::load(var_1062);
    var_1063 = wp::sub(var_1064, var_877);
    var_1065 = wp::add(var_14, var_876);
    var_1066 = wp::mul(var_1065, var_7);
    var_1067 = wp::add(var_1, var_1066);
    var_1068 = wp::add(var_1067, var_1058);
    var_1069 = wp::address(var_boxes, var_1068);
    var_1071 = wp::load(var_1069);
    var_1070 = wp::sub(var_877, var_1071);
    var_1072 = larger_0(var_1063, var_1070);
    var_1074 = larger_0(var_1072, var_1073);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1075 = wp::mul(var_1074, var_1074);
    wp::add_inplace(var_3, var_1058, var_1075);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1077 = wp::mul(var_876, var_7);
    var_1078 = wp::add(var_1, var_1077);
    var_1079 = wp::add(var_1078, var_1076);
    var_1080 = wp::address(var_boxes, var_1079);
    var_1082 = wp::load(var_1080);
    var_1081 = wp::sub(var_1082, var_877);
    var_1083 = wp::add(var_14, var_876);
    var_1084 = wp::mul(var_1083, var_7);
    var_1085 = wp::add(var_1, var_1084);
    var_1086 = wp::add(var_1085, var_1076);
    var_1087 = wp::address(var_boxes, var_1086);
    var_1089 = wp::load(var_1087);
    var_1088 = wp::sub(var_877, var_1089);
    var_1090 = larger_0(var_1081, var_1088);
    var_1092 = larger_0(var_1090, var_1091);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1093 = wp::mul(var_1092, var_1092);
    wp::add_inplace(var_3, var_1076, var_1093);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1095 = wp::mul(var_876, var_7);
    var_1096 = wp::add(var_1, var_1095);
    var_1097 = wp::add(var_1096, var_1094);
    var_1098 = wp::address(var_boxes, var_1097);
    var_1100 = wp::load(var_1098);
    var_1099 = wp::sub(var_1100, var_877);
    var_1101 = wp::add(var_14, var_876);
    var_1102 = wp::mul(var_1101, var_7);
    var_1103 = wp::add(var_1, var_1102);
    var_1104 = wp::add(var_1103, var_1094);
    var_1105 = wp::address(var_boxes, var_1104);
    var_1107 = wp::load(var_1105);
    var_1106 = wp::sub(var_877, var_1107);
    var_1108 = larger_0(var_1099, var_1106);
    var_1110 = larger_0(var_1108, var_1109);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1111 = wp::mul(var_1110, var_1110);
    wp::add_inplace(var_3, var_1094, var_1111);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1113 = wp::mul(var_876, var_7);
    var_1114 = wp::add(var_1, var_1113);
    var_1115 = wp::add(var_1114, var_1112);
    var_1116 = wp::address(var_boxes, var_1115);
    var_1118 = wp::load(var_1116);
    var_1117 = wp::sub(var_1118, var_877);
    var_1119 = wp::add(var_14, var_876);
    var_1120 = wp::mul(var_1119, var_7);
    var_1121 = wp::add(var_1, var_1120);
    var_1122 = wp::add(var_1121, var_1112);
    var_1123 = wp::address(var_boxes, var_1122);
    var_1125 = wp::load(var_1123);
    var_1124 = wp::sub(var_877, var_1125);
    var_1126 = larger_0(var_1117, var_1124);
    var_1128 = larger_0(var_1126, var_1127);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1129 = wp::mul(var_1128, var_1128);
    wp::add_inplace(var_3, var_1112, var_1129);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1131 = wp::mul(var_876, var_7);
    var_1132 = wp::add(var_1, var_1131);
    var_1133 = wp::add(var_1132, var_1130);
    var_1134 = wp::address(var_boxes, var_1133);
    var_1136 = wp::load(var_1134);
    var_1135 = wp::sub(var_1136, var_877);
    var_1137 = wp::add(var_14, var_876);
    var_1138 = wp::mul(var_1137, var_7);
    var_1139 = wp::add(var_1, var_1138);
    var_1140 = wp::add(var_1139, var_1130);
    var_1141 = wp::address(var_boxes, var_1140);
    var_1143 = wp::load(var_1141);
    var_1142 = wp::sub(var_877, var_1143);
    var_1144 = larger_0(var_1135, var_1142);
    var_1146 = larger_0(var_1144, var_1145);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1147 = wp::mul(var_1146, var_1146);
    wp::add_inplace(var_3, var_1130, var_1147);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1149 = wp::mul(var_876, var_7);
    var_1150 = wp::add(var_1, var_1149);
    var_1151 = wp::add(var_1150, var_1148);
    var_1152 = wp::address(var_boxes, var_1151);
    var_1154 = wp::load(var_1152);
    var_1153 = wp::sub(var_1154, var_877);
    var_1155 = wp::add(var_14, var_876);
    var_1156 = wp::mul(var_1155, var_7);
    var_1157 = wp::add(var_1, var_1156);
    var_1158 = wp::add(var_1157, var_1148);
    var_1159 = wp::address(var_boxes, var_1158);
    var_1161 = wp::load(var_1159);
    var_1160 = wp::sub(var_877, var_1161);
    var_1162 = larger_0(var_1153, var_1160);
    var_1164 = larger_0(var_1162, var_1163);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1165 = wp::mul(var_1164, var_1164);
    wp::add_inplace(var_3, var_1148, var_1165);
    // x = y[k]                                                                               <L 98>
    var_1167 = wp::extract(var_y, var_1166);
    // for j in range(FAN):                                                                   <L 99>
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1169 = wp::mul(var_1166, var_7);
    var_1170 = wp::add(var_1, var_1169);
    var_1171 = wp::add(var_1170, var_1168);
    var_1172 = wp::address(var_boxes, var_1171);
    var_1174 = wp::load(var_1172);
    var_1173 = wp::sub(var_1174, var_1167);
    var_1175 = wp::add(var_14, var_1166);
    var_1176 = wp::mul(var_1175, var_7);
    var_1177 = wp::add(var_1, var_1176);
    var_1178 = wp::add(var_1177, var_1168);
    var_1179 = wp::address(var_boxes, var_1178);
    var_1181 = wp::load(var_1179);
    var_1180 = wp::sub(var_1167, var_1181);
    var_1182 = larger_0(var_1173, var_1180);
    var_1184 = larger_0(var_1182, var_1183);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1185 = wp::mul(var_1184, var_1184);
    wp::add_inplace(var_3, var_1168, var_1185);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1187 = wp::mul(var_1166, var_7);
    var_1188 = wp::add(var_1, var_1187);
    var_1189 = wp::add(var_1188, var_1186);
    var_1190 = wp::address(var_boxes, var_1189);
    var_1192 = wp::load(var_1190);
    var_1191 = wp::sub(var_1192, var_1167);
    var_1193 = wp::add(var_14, var_1166);
    var_1194 = wp::mul(var_1193, var_7);
    var_1195 = wp::add(var_1, var_1194);
    var_1196 = wp::add(var_1195, var_1186);
    var_1197 = wp::address(var_boxes, var_1196);
    var_1199 = wp::load(var_1197);
    var_1198 = wp::sub(var_1167, var_1199);
    var_1200 = larger_0(var_1191, var_1198);
    var_1202 = larger_0(var_1200, var_1201);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1203 = wp::mul(var_1202, var_1202);
    wp::add_inplace(var_3, var_1186, var_1203);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1205 = wp::mul(var_1166, var_7);
    var_1206 = wp::add(var_1, var_1205);
    var_1207 = wp::add(var_1206, var_1204);
    var_1208 = wp::address(var_boxes, var_1207);
    var_1210 = wp::load(var_1208);
    var_1209 = wp::sub(var_1210, var_1167);
    var_1211 = wp::add(var_14, var_1166);
    var_1212 = wp::mul(var_1211, var_7);
    var_1213 = wp::add(var_1, var_1212);
    var_1214 = wp::add(var_1213, var_1204);
    var_1215 = wp::address(var_boxes, var_1214);
    var_1217 = wp::load(var_1215);
    var_1216 = wp::sub(var_1167, var_1217);
    var_1218 = larger_0(var_1209, var_1216);
    var_1220 = larger_0(var_1218, var_1219);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1221 = wp::mul(var_1220, var_1220);
    wp::add_inplace(var_3, var_1204, var_1221);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1223 = wp::mul(var_1166, var_7);
    var_1224 = wp::add(var_1, var_1223);
    var_1225 = wp::add(var_1224, var_1222);
    var_1226 = wp::address(var_boxes, var_1225);
    var_1228 = wp::load(var_1226);
    var_1227 = wp::sub(var_1228, var_1167);
    var_1229 = wp::add(var_14, var_1166);
    var_1230 = wp::mul(var_1229, var_7);
    var_1231 = wp::add(var_1, var_1230);
    var_1232 = wp::add(var_1231, var_1222);
    var_1233 = wp::address(var_boxes, var_1232);
    var_1235 = wp::load(var_1233);
    var_1234 = wp::sub(var_1167, var_1235);
    var_1236 = larger_0(var_1227, var_1234);
    var_1238 = larger_0(var_1236, var_1237);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1239 = wp::mul(var_1238, var_1238);
    wp::add_inplace(var_3, var_1222, var_1239);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1241 = wp::mul(var_1166, var_7);
    var_1242 = wp::add(var_1, var_1241);
    var_1243 = wp::add(var_1242, var_1240);
    var_1244 = wp::address(var_boxes, var_1243);
    var_1246 = wp::load(var_1244);
    var_1245 = wp::sub(var_1246, var_1167);
    var_1247 = wp::add(var_14, var_1166);
    var_1248 = wp::mul(var_1247, var_7);
    var_1249 = wp::add(var_1, var_1248);
    var_1250 = wp::add(var_1249, var_1240);
    var_1251 = wp::address(var_boxes, var_1250);
    var_1253 = wp::load(var_1251);
    var_1252 = wp::sub(var_1167, var_1253);
    var_1254 = larger_0(var_1245, var_1252);
    var_1256 = larger_0(var_1254, var_1255);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1257 = wp::mul(var_1256, var_1256);
    wp::add_inplace(var_3, var_1240, var_1257);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1259 = wp::mul(var_1166, var_7);
    var_1260 = wp::add(var_1, var_1259);
    var_1261 = wp::add(var_1260, var_1258);
    var_1262 = wp::address(var_boxes, var_1261);
    var_1264 = wp::load(var_1262);
    var_1263 = wp::sub(var_1264, var_1167);
    var_1265 = wp::add(var_14, var_1166);
    var_1266 = wp::mul(var_1265, var_7);
    var_1267 = wp::add(var_1, var_1266);
    var_1268 = wp::add(var_1267, var_1258);
    var_1269 = wp::address(var_boxes, var_1268);
    var_1271 = wp::load(var_1269);
    var_1270 = wp::sub(var_1167, var_1271);
    var_1272 = larger_0(var_1263, var_1270);
    var_1274 = larger_0(var_1272, var_1273);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1275 = wp::mul(var_1274, var_1274);
    wp::add_inplace(var_3, var_1258, var_1275);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1277 = wp::mul(var_1166, var_7);
    var_1278 = wp::add(var_1, var_1277);
    var_1279 = wp::add(var_1278, var_1276);
    var_1280 = wp::address(var_boxes, var_1279);
    var_1282 = wp::load(var_1280);
    var_1281 = wp::sub(var_1282, var_1167);
    var_1283 = wp::add(var_14, var_1166);
    var_1284 = wp::mul(var_1283, var_7);
    var_1285 = wp::add(var_1, var_1284);
    var_1286 = wp::add(var_1285, var_1276);
    var_1287 = wp::address(var_boxes, var_1286);
    var_1289 = wp::load(var_1287);
    var_1288 = wp::sub(var_1167, var_1289);
    var_1290 = larger_0(var_1281, var_1288);
    var_1292 = larger_0(var_1290, var_1291);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1293 = wp::mul(var_1292, var_1292);
    wp::add_inplace(var_3, var_1276, var_1293);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1295 = wp::mul(var_1166, var_7);
    var_1296 = wp::add(var_1, var_1295);
    var_1297 = wp::add(var_1296, var_1294);
    var_1298 = wp::address(var_boxes, var_1297);
    var_1300 = wp::load(var_1298);
    var_1299 = wp::sub(var_1300, var_1167);
    var_1301 = wp::add(var_14, var_1166);
    var_1302 = wp::mul(var_1301, var_7);
    var_1303 = wp::add(var_1, var_1302);
    var_1304 = wp::add(var_1303, var_1294);
    var_1305 = wp::address(var_boxes, var_1304);
    var_1307 = wp::load(var_1305);
    var_1306 = wp::sub(var_1167, var_1307);
    var_1308 = larger_0(var_1299, var_1306);
    var_1310 = larger_0(var_1308, var_1309);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1311 = wp::mul(var_1310, var_1310);
    wp::add_inplace(var_3, var_1294, var_1311);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1313 = wp::mul(var_1166, var_7);
    var_1314 = wp::add(var_1, var_1313);
    var_1315 = wp::add(var_1314, var_1312);
    var_1316 = wp::address(var_boxes, var_1315);
    var_1318 = wp::load(var_1316);
    var_1317 = wp::sub(var_1318, var_1167);
    var_1319 = wp::add(var_14, var_1166);
    var_1320 = wp::mul(var_1319, var_7);
    var_1321 = wp::add(var_1, var_1320);
    var_1322 = wp::add(var_1321, var_1312);
    var_1323 = wp::address(var_boxes, var_1322);
    var_1325 = wp::load(var_1323);
    var_1324 = wp::sub(var_1167, var_1325);
    var_1326 = larger_0(var_1317, var_1324);
    var_1328 = larger_0(var_1326, var_1327);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1329 = wp::mul(var_1328, var_1328);
    wp::add_inplace(var_3, var_1312, var_1329);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1331 = wp::mul(var_1166, var_7);
    var_1332 = wp::add(var_1, var_1331);
    var_1333 = wp::add(var_1332, var_1330);
    var_1334 = wp::address(var_boxes, var_1333);
    var_1336 = wp::load(var_1334);
    var_1335 = wp::sub(var_1336, var_1167);
    var_1337 = wp::add(var_14, var_1166);
    var_1338 = wp::mul(var_1337, var_7);
    var_1339 = wp::add(var_1, var_1338);
    var_1340 = wp::add(var_1339, var_1330);
    var_1341 = wp::address(var_boxes, var_1340);
    var_1343 = wp::load(var_1341);
    var_1342 = wp::sub(var_1167, var_1343);
    var_1344 = larger_0(var_1335, var_1342);
    var_1346 = larger_0(var_1344, var_1345);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1347 = wp::mul(var_1346, var_1346);
    wp::add_inplace(var_3, var_1330, var_1347);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1349 = wp::mul(var_1166, var_7);
    var_1350 = wp::add(var_1, var_1349);
    var_1351 = wp::add(var_1350, var_1348);
    var_1352 = wp::address(var_boxes, var_1351);
    var_1354 = wp::load(var_1352);
    var_1353 = wp::sub(var_1354, var_1167);
    var_1355 = wp::add(var_14, var_1166);
    var_1356 = wp::mul(var_1355, var_7);
    var_1357 = wp::add(var_1, var_1356);
    var_1358 = wp::add(var_1357, var_1348);
    var_1359 = wp::address(var_boxes, var_1358);
    var_1361 = wp::load(var_1359);
    var_1360 = wp::sub(var_1167, var_1361);
    var_1362 = larger_0(var_1353, var_1360);
    var_1364 = larger_0(var_1362, var_1363);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1365 = wp::mul(var_1364, var_1364);
    wp::add_inplace(var_3, var_1348, var_1365);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1367 = wp::mul(var_1166, var_7);
    var_1368 = wp::add(var_1, var_1367);
    var_1369 = wp::add(var_1368, var_1366);
    var_1370 = wp::address(var_boxes, var_1369);
    var_1372 = wp::load(var_1370);
    var_1371 = wp::sub(var_1372, var_1167);
    var_1373 = wp::add(var_14, var_1166);
    var_1374 = wp::mul(var_1373, var_7);
    var_1375 = wp::add(var_1, var_1374);
    var_1376 = wp::add(var_1375, var_1366);
    var_1377 = wp::address(var_boxes, var_1376);
    var_1379 = wp::load(var_1377);
    var_1378 = wp::sub(var_1167, var_1379);
    var_1380 = larger_0(var_1371, var_1378);
    var_1382 = larger_0(var_1380, var_1381);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1383 = wp::mul(var_1382, var_1382);
    wp::add_inplace(var_3, var_1366, var_1383);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1385 = wp::mul(var_1166, var_7);
    var_1386 = wp::add(var_1, var_1385);
    var_1387 = wp::add(var_1386, var_1384);
    var_1388 = wp::address(var_boxes, var_1387);
    var_1390 = wp::load(var_1388);
    var_1389 = wp::sub(var_1390, var_1167);
    var_1391 = wp::add(var_14, var_1166);
    var_1392 = wp::mul(var_1391, var_7);
    var_1393 = wp::add(var_1, var_1392);
    var_1394 = wp::add(var_1393, var_1384);
    var_1395 = wp::address(var_boxes, var_1394);
    var_1397 = wp::load(var_1395);
    var_1396 = wp::sub(var_1167, var_1397);
    var_1398 = larger_0(var_1389, var_1396);
    var_1400 = larger_0(var_1398, var_1399);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1401 = wp::mul(var_1400, var_1400);
    wp::add_inplace(var_3, var_1384, var_1401);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1403 = wp::mul(var_1166, var_7);
    var_1404 = wp::add(var_1, var_1403);
    var_1405 = wp::add(var_1404, var_1402);
    var_1406 = wp::address(var_boxes, var_1405);
    var_1408 = wp::load(var_1406);
    var_1407 = wp::sub(var_1408, var_1167);
    var_1409 = wp::add(var_14, var_1166);
    var_1410 = wp::mul(var_1409, var_7);
    var_1411 = wp::add(var_1, var_1410);
    var_1412 = wp::add(var_1411, var_1402);
    var_1413 = wp::address(var_boxes, var_1412);
    var_1415 = wp::load(var_1413);
    var_1414 = wp::sub(var_1167, var_1415);
    var_1416 = larger_0(var_1407, var_1414);
    var_1418 = larger_0(var_1416, var_1417);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1419 = wp::mul(var_1418, var_1418);
    wp::add_inplace(var_3, var_1402, var_1419);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1421 = wp::mul(var_1166, var_7);
    var_1422 = wp::add(var_1, var_1421);
    var_1423 = wp::add(var_1422, var_1420);
    var_1424 = wp::address(var_boxes, var_1423);
    var_1426 = wp::load(var_1424);
    var_1425 = wp::sub(var_1426, var_1167);
    var_1427 = wp::add(var_14, var_1166);
    var_1428 = wp::mul(var_1427, var_7);
    var_1429 = wp::add(var_1, var_1428);
    var_1430 = wp::add(var_1429, var_1420);
    var_1431 = wp::address(var_boxes, var_1430);
    var_1433 = wp::load(var_1431);
    var_1432 = wp::sub(var_1167, var_1433);
    var_1434 = larger_0(var_1425, var_1432);
    var_1436 = larger_0(var_1434, var_1435);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1437 = wp::mul(var_1436, var_1436);
    wp::add_inplace(var_3, var_1420, var_1437);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1439 = wp::mul(var_1166, var_7);
    var_1440 = wp::add(var_1, var_1439);
    var_1441 = wp::add(var_1440, var_1438);
    var_1442 = wp::address(var_boxes, var_1441);
    var_1444 = wp::load(var_1442);
    var_1443 = wp::sub(var_1444, var_1167);
    var_1445 = wp::add(var_14, var_1166);
    var_1446 = wp::mul(var_1445, var_7);
    var_1447 = wp::add(var_1, var_1446);
    var_1448 = wp::add(var_1447, var_1438);
    var_1449 = wp::address(var_boxes, var_1448);
    var_1451 = wp::load(var_1449);
    var_1450 = wp::sub(var_1167, var_1451);
    var_1452 = larger_0(var_1443, var_1450);
    var_1454 = larger_0(var_1452, var_1453);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1455 = wp::mul(var_1454, var_1454);
    wp::add_inplace(var_3, var_1438, var_1455);
    // x = y[k]                                                                               <L 98>
    var_1457 = wp::extract(var_y, var_1456);
    // for j in range(FAN):                                                                   <L 99>
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1459 = wp::mul(var_1456, var_7);
    var_1460 = wp::add(var_1, var_1459);
    var_1461 = wp::add(var_1460, var_1458);
    var_1462 = wp::address(var_boxes, var_1461);
    var_1464 = wp::load(var_1462);
    var_1463 = wp::sub(var_1464, var_1457);
    var_1465 = wp::add(var_14, var_1456);
    var_1466 = wp::mul(var_1465, var_7);
    var_1467 = wp::add(var_1, var_1466);
    var_1468 = wp::add(var_1467, var_1458);
    var_1469 = wp::address(var_boxes, var_1468);
    var_1471 = wp::load(var_1469);
    var_1470 = wp::sub(var_1457, var_1471);
    var_1472 = larger_0(var_1463, var_1470);
    var_1474 = larger_0(var_1472, var_1473);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1475 = wp::mul(var_1474, var_1474);
    wp::add_inplace(var_3, var_1458, var_1475);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1477 = wp::mul(var_1456, var_7);
    var_1478 = wp::add(var_1, var_1477);
    var_1479 = wp::add(var_1478, var_1476);
    var_1480 = wp::address(var_boxes, var_1479);
    var_1482 = wp::load(var_1480);
    var_1481 = wp::sub(var_1482, var_1457);
    var_1483 = wp::add(var_14, var_1456);
    var_1484 = wp::mul(var_1483, var_7);
    var_1485 = wp::add(var_1, var_1484);
    var_1486 = wp::add(var_1485, var_1476);
    var_1487 = wp::address(var_boxes, var_1486);
    var_1489 = wp::load(var_1487);
    var_1488 = wp::sub(var_1457, var_1489);
    var_1490 = larger_0(var_1481, var_1488);
    var_1492 = larger_0(var_1490, var_1491);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1493 = wp::mul(var_1492, var_1492);
    wp::add_inplace(var_3, var_1476, var_1493);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1495 = wp::mul(var_1456, var_7);
    var_1496 = wp::add(var_1, var_1495);
    var_1497 = wp::add(var_1496, var_1494);
    var_1498 = wp::address(var_boxes, var_1497);
    var_1500 = wp::load(var_1498);
    var_1499 = wp::sub(var_1500, var_1457);
    var_1501 = wp::add(var_14, var_1456);
    var_1502 = wp::mul(var_1501, var_7);
    var_1503 = wp::add(var_1, var_1502);
    var_1504 = wp::add(var_1503, var_1494);
    var_1505 = wp::address(var_boxes, var_1504);
    var_1507 = wp::load(var_1505);
    var_1506 = wp::sub(var_1457, var_1507);
    var_1508 = larger_0(var_1499, var_1506);
    var_1510 = larger_0(var_1508, var_1509);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1511 = wp::mul(var_1510, var_1510);
    wp::add_inplace(var_3, var_1494, var_1511);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1513 = wp::mul(var_1456, var_7);
    var_1514 = wp::add(var_1, var_1513);
    var_1515 = wp::add(var_1514, var_1512);
    var_1516 = wp::address(var_boxes, var_1515);
    var_1518 = wp::load(var_1516);
    var_1517 = wp::sub(var_1518, var_1457);
    var_1519 = wp::add(var_14, var_1456);
    var_1520 = wp::mul(var_1519, var_7);
    var_1521 = wp::add(var_1, var_1520);
    var_1522 = wp::add(var_1521, var_1512);
    var_1523 = wp::address(var_boxes, var_1522);
    var_1525 = wp::load(var_1523);
    var_1524 = wp::sub(var_1457, var_1525);
    var_1526 = larger_0(var_1517, var_1524);
    var_1528 = larger_0(var_1526, var_1527);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1529 = wp::mul(var_1528, var_1528);
    wp::add_inplace(var_3, var_1512, var_1529);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1531 = wp::mul(var_1456, var_7);
    var_1532 = wp::add(var_1, var_1531);
    var_1533 = wp::add(var_1532, var_1530);
    var_1534 = wp::address(var_boxes, var_1533);
    var_1536 = wp::load(var_1534);
    var_1535 = wp::sub(var_1536, var_1457);
    var_1537 = wp::add(var_14, var_1456);
    var_1538 = wp::mul(var_1537, var_7);
    var_1539 = wp::add(var_1, var_1538);
    var_1540 = wp::add(var_1539, var_1530);
    var_1541 = wp::address(var_boxes, var_1540);
    var_1543 = wp::load(var_1541);
    var_1542 = wp::sub(var_1457, var_1543);
    var_1544 = larger_0(var_1535, var_1542);
    var_1546 = larger_0(var_1544, var_1545);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1547 = wp::mul(var_1546, var_1546);
    wp::add_inplace(var_3, var_1530, var_1547);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1549 = wp::mul(var_1456, var_7);
    var_1550 = wp::add(var_1, var_1549);
    var_1551 = wp::add(var_1550, var_1548);
    var_1552 = wp::address(var_boxes, var_1551);
    var_1554 = wp::load(var_1552);
    var_1553 = wp::sub(var_1554, var_1457);
    var_1555 = wp::add(var_14, var_1456);
    var_1556 = wp::mul(var_1555, var_7);
    var_1557 = wp::add(var_1, var_1556);
    var_1558 = wp::add(var_1557, var_1548);
    var_1559 = wp::address(var_boxes, var_1558);
    var_1561 = wp::load(var_1559);
    var_1560 = wp::sub(var_1457, var_1561);
    var_1562 = larger_0(var_1553, var_1560);
    var_1564 = larger_0(var_1562, var_1563);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1565 = wp::mul(var_1564, var_1564);
    wp::add_inplace(var_3, var_1548, var_1565);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1567 = wp::mul(var_1456, var_7);
    var_1568 = wp::add(var_1, var_1567);
    var_1569 = wp::add(var_1568, var_1566);
    var_1570 = wp::address(var_boxes, var_1569);
    var_1572 = wp::load(var_1570);
    var_1571 = wp::sub(var_1572, var_1457);
    var_1573 = wp::add(var_14, var_1456);
    var_1574 = wp::mul(var_1573, var_7);
    var_1575 = wp::add(var_1, var_1574);
    var_1576 = wp::add(var_1575, var_1566);
    var_1577 = wp::address(var_boxes, var_1576);
    var_1579 = wp::load(var_1577);
    var_1578 = wp::sub(var_1457, var_1579);
    var_1580 = larger_0(var_1571, var_1578);
    var_1582 = larger_0(var_1580, var_1581);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1583 = wp::mul(var_1582, var_1582);
    wp::add_inplace(var_3, var_1566, var_1583);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1585 = wp::mul(var_1456, var_7);
    var_1586 = wp::add(var_1, var_1585);
    var_1587 = wp::add(var_1586, var_1584);
    var_1588 = wp::address(var_boxes, var_1587);
    var_1590 = wp::load(var_1588);
    var_1589 = wp::sub(var_1590, var_1457);
    var_1591 = wp::add(var_14, var_1456);
    var_1592 = wp::mul(var_1591, var_7);
    var_1593 = wp::add(var_1, var_1592);
    var_1594 = wp::add(var_1593, var_1584);
    var_1595 = wp::address(var_boxes, var_1594);
    var_1597 = wp::load(var_1595);
    var_1596 = wp::sub(var_1457, var_1597);
    var_1598 = larger_0(var_1589, var_1596);
    var_1600 = larger_0(var_1598, var_1599);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1601 = wp::mul(var_1600, var_1600);
    wp::add_inplace(var_3, var_1584, var_1601);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1603 = wp::mul(var_1456, var_7);
    var_1604 = wp::add(var_1, var_1603);
    var_1605 = wp::add(var_1604, var_1602);
    var_1606 = wp::address(var_boxes, var_1605);
    var_1608 = wp::load(var_1606);
    var_1607 = wp::sub(var_1608, var_1457);
    var_1609 = wp::add(var_14, var_1456);
    var_1610 = wp::mul(var_1609, var_7);
    var_1611 = wp::add(var_1, var_1610);
    var_1612 = wp::add(var_1611, var_1602);
    var_1613 = wp::address(var_boxes, var_1612);
    var_1615 = wp::load(var_1613);
    var_1614 = wp::sub(var_1457, var_1615);
    var_1616 = larger_0(var_1607, var_1614);
    var_1618 = larger_0(var_1616, var_1617);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1619 = wp::mul(var_1618, var_1618);
    wp::add_inplace(var_3, var_1602, var_1619);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1621 = wp::mul(var_1456, var_7);
    var_1622 = wp::add(var_1, var_1621);
    var_1623 = wp::add(var_1622, var_1620);
    var_1624 = wp::address(var_boxes, var_1623);
    var_1626 = wp::load(var_1624);
    var_1625 = wp::sub(var_1626, var_1457);
    var_1627 = wp::add(var_14, var_1456);
    var_1628 = wp::mul(var_1627, var_7);
    var_1629 = wp::add(var_1, var_1628);
    var_1630 = wp::add(var_1629, var_1620);
    var_1631 = wp::address(var_boxes, var_1630);
    var_1633 = wp::load(var_1631);
    var_1632 = wp::sub(var_1457, var_1633);
    var_1634 = larger_0(var_1625, var_1632);
    var_1636 = larger_0(var_1634, var_1635);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1637 = wp::mul(var_1636, var_1636);
    wp::add_inplace(var_3, var_1620, var_1637);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1639 = wp::mul(var_1456, var_7);
    var_1640 = wp::add(var_1, var_1639);
    var_1641 = wp::add(var_1640, var_1638);
    var_1642 = wp::address(var_boxes, var_1641);
    var_1644 = wp::load(var_1642);
    var_1643 = wp::sub(var_1644, var_1457);
    var_1645 = wp::add(var_14, var_1456);
    var_1646 = wp::mul(var_1645, var_7);
    var_1647 = wp::add(var_1, var_1646);
    var_1648 = wp::add(var_1647, var_1638);
    var_1649 = wp::address(var_boxes, var_1648);
    var_1651 = wp::load(var_1649);
    var_1650 = wp::sub(var_1457, var_1651);
    var_1652 = larger_0(var_1643, var_1650);
    var_1654 = larger_0(var_1652, var_1653);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1655 = wp::mul(var_1654, var_1654);
    wp::add_inplace(var_3, var_1638, var_1655);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1657 = wp::mul(var_1456, var_7);
    var_1658 = wp::add(var_1, var_1657);
    var_1659 = wp::add(var_1658, var_1656);
    var_1660 = wp::address(var_boxes, var_1659);
    var_1662 = wp::load(var_1660);
    var_1661 = wp::sub(var_1662, var_1457);
    var_1663 = wp::add(var_14, var_1456);
    var_1664 = wp::mul(var_1663, var_7);
    var_1665 = wp::add(var_1, var_1664);
    var_1666 = wp::add(var_1665, var_1656);
    var_1667 = wp::address(var_boxes, var_1666);
    var_1669 = wp::load(var_1667);
    var_1668 = wp::sub(var_1457, var_1669);
    var_1670 = larger_0(var_1661, var_1668);
    var_1672 = larger_0(var_1670, var_1671);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1673 = wp::mul(var_1672, var_1672);
    wp::add_inplace(var_3, var_1656, var_1673);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1675 = wp::mul(var_1456, var_7);
    var_1676 = wp::add(var_1, var_1675);
    var_1677 = wp::add(var_1676, var_1674);
    var_1678 = wp::address(var_boxes, var_1677);
    var_1680 = wp::load(var_1678);
    var_1679 = wp::sub(var_1680, var_1457);
    var_1681 = wp::add(var_14, var_1456);
    var_1682 = wp::mul(var_1681, var_7);
    var_1683 = wp::add(var_1, var_1682);
    var_1684 = wp::add(var_1683, var_1674);
    var_1685 = wp::address(var_boxes, var_1684);
    var_1687 = wp::load(var_1685);
    var_1686 = wp::sub(var_1457, var_1687);
    var_1688 = larger_0(var_1679, var_1686);
    var_1690 = larger_0(var_1688, var_1689);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1691 = wp::mul(var_1690, var_1690);
    wp::add_inplace(var_3, var_1674, var_1691);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1693 = wp::mul(var_1456, var_7);
    var_1694 = wp::add(var_1, var_1693);
    var_1695 = wp::add(var_1694, var_1692);
    var_1696 = wp::address(var_boxes, var_1695);
    var_1698 = wp::load(var_1696);
    var_1697 = wp::sub(var_1698, var_1457);
    var_1699 = wp::add(var_14, var_1456);
    var_1700 = wp::mul(var_1699, var_7);
    var_1701 = wp::add(var_1, var_1700);
    var_1702 = wp::add(var_1701, var_1692);
    var_1703 = wp::address(var_boxes, var_1702);
    var_1705 = wp::load(var_1703);
    var_1704 = wp::sub(var_1457, var_1705);
    var_1706 = larger_0(var_1697, var_1704);
    var_1708 = larger_0(var_1706, var_1707);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1709 = wp::mul(var_1708, var_1708);
    wp::add_inplace(var_3, var_1692, var_1709);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1711 = wp::mul(var_1456, var_7);
    var_1712 = wp::add(var_1, var_1711);
    var_1713 = wp::add(var_1712, var_1710);
    var_1714 = wp::address(var_boxes, var_1713);
    var_1716 = wp::load(var_1714);
    var_1715 = wp::sub(var_1716, var_1457);
    var_1717 = wp::add(var_14, var_1456);
    var_1718 = wp::mul(var_1717, var_7);
    var_1719 = wp::add(var_1, var_1718);
    var_1720 = wp::add(var_1719, var_1710);
    var_1721 = wp::address(var_boxes, var_1720);
    var_1723 = wp::load(var_1721);
    var_1722 = wp::sub(var_1457, var_1723);
    var_1724 = larger_0(var_1715, var_1722);
    var_1726 = larger_0(var_1724, var_1725);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1727 = wp::mul(var_1726, var_1726);
    wp::add_inplace(var_3, var_1710, var_1727);
    // gap = larger(larger(boxes[at + k * FAN + j] - x, x - boxes[at + (BOXED + k) * FAN + j]), 0.0)       <L 100>
    var_1729 = wp::mul(var_1456, var_7);
    var_1730 = wp::add(var_1, var_1729);
    var_1731 = wp::add(var_1730, var_1728);
    var_1732 = wp::address(var_boxes, var_1731);
    var_1734 = wp::load(var_1732);
    var_1733 = wp::sub(var_1734, var_1457);
    var_1735 = wp::add(var_14, var_1456);
    var_1736 = wp::mul(var_1735, var_7);
    var_1737 = wp::add(var_1, var_1736);
    var_1738 = wp::add(var_1737, var_1728);
    var_1739 = wp::address(var_boxes, var_1738);
    var_1741 = wp::load(var_1739);
    var_1740 = wp::sub(var_1457, var_1741);
    var_1742 = larger_0(var_1733, var_1740);
    var_1744 = larger_0(var_1742, var_1743);
    // sqdists[j] += gap * gap                                                                <L 101>
    var_1745 = wp::mul(var_1744, var_1744);
    wp::add_inplace(var_3, var_1728, var_1745);
    // return sqdists                                                                         <L 102>
    return var_3;
}


// <pointloom.kernels.features.feature_matching.smallest_lane>:1
static CUDA_CALLABLE wp::int32 smallest_lane_0(
    wp::vec_t<16, wp::float32> var_sqdists)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    const wp::int32 var_2 = 0;
    wp::float32 var_3;
    const wp::int32 var_4 = 1;
    wp::float32 var_5;
    bool var_6;
    wp::float32 var_7;
    wp::int32 var_8;
    wp::int32 var_9;
    wp::float32 var_10;
    const wp::int32 var_11 = 2;
    wp::float32 var_12;
    bool var_13;
    wp::float32 var_14;
    wp::int32 var_15;
    wp::int32 var_16;
    wp::float32 var_17;
    const wp::int32 var_18 = 3;
    wp::float32 var_19;
    bool var_20;
    wp::float32 var_21;
    wp::int32 var_22;
    wp::int32 var_23;
    wp::float32 var_24;
    const wp::int32 var_25 = 4;
    wp::float32 var_26;
    bool var_27;
    wp::float32 var_28;
    wp::int32 var_29;
    wp::int32 var_30;
    wp::float32 var_31;
    const wp::int32 var_32 = 5;
    wp::float32 var_33;
    bool var_34;
    wp::float32 var_35;
    wp::int32 var_36;
    wp::int32 var_37;
    wp::float32 var_38;
    const wp::int32 var_39 = 6;
    wp::float32 var_40;
    bool var_41;
    wp::float32 var_42;
    wp::int32 var_43;
    wp::int32 var_44;
    wp::float32 var_45;
    const wp::int32 var_46 = 7;
    wp::float32 var_47;
    bool var_48;
    wp::float32 var_49;
    wp::int32 var_50;
    wp::int32 var_51;
    wp::float32 var_52;
    const wp::int32 var_53 = 8;
    wp::float32 var_54;
    bool var_55;
    wp::float32 var_56;
    wp::int32 var_57;
    wp::int32 var_58;
    wp::float32 var_59;
    const wp::int32 var_60 = 9;
    wp::float32 var_61;
    bool var_62;
    wp::float32 var_63;
    wp::int32 var_64;
    wp::int32 var_65;
    wp::float32 var_66;
    const wp::int32 var_67 = 10;
    wp::float32 var_68;
    bool var_69;
    wp::float32 var_70;
    wp::int32 var_71;
    wp::int32 var_72;
    wp::float32 var_73;
    const wp::int32 var_74 = 11;
    wp::float32 var_75;
    bool var_76;
    wp::float32 var_77;
    wp::int32 var_78;
    wp::int32 var_79;
    wp::float32 var_80;
    const wp::int32 var_81 = 12;
    wp::float32 var_82;
    bool var_83;
    wp::float32 var_84;
    wp::int32 var_85;
    wp::int32 var_86;
    wp::float32 var_87;
    const wp::int32 var_88 = 13;
    wp::float32 var_89;
    bool var_90;
    wp::float32 var_91;
    wp::int32 var_92;
    wp::int32 var_93;
    wp::float32 var_94;
    const wp::int32 var_95 = 14;
    wp::float32 var_96;
    bool var_97;
    wp::float32 var_98;
    wp::int32 var_99;
    wp::int32 var_100;
    wp::float32 var_101;
    const wp::int32 var_102 = 15;
    wp::float32 var_103;
    bool var_104;
    wp::float32 var_105;
    wp::int32 var_106;
    wp::int32 var_107;
    wp::float32 var_108;
    //---------
    // forward
    // def smallest_lane(sqdists):                                                            <L 1>
    // lane = int(0)                                                                          <L 2>
    var_1 = wp::int(var_0);
    // smallest = sqdists[0]                                                                  <L 3>
    var_3 = wp::extract(var_sqdists, var_2);
    // for j in range(1, FAN):                                                                <L 4>
    // if sqdists[j] < smallest:                                                              <L 5>
    var_5 = wp::extract(var_sqdists, var_4);
    var_6 = (var_5 < var_3);
    if (var_6) {
        // smallest = sqdists[j]                                                              <L 6>
        var_7 = wp::extract(var_sqdists, var_4);
        // lane = j                                                                           <L 7>
        var_8 = wp::copy(var_4);
    }
    var_9 = wp::where(var_6, var_8, var_1);
    var_10 = wp::where(var_6, var_7, var_3);
    // if sqdists[j] < smallest:                                                              <L 5>
    var_12 = wp::extract(var_sqdists, var_11);
    var_13 = (var_12 < var_10);
    if (var_13) {
        // smallest = sqdists[j]                                                              <L 6>
        var_14 = wp::extract(var_sqdists, var_11);
        // lane = j                                                                           <L 7>
        var_15 = wp::copy(var_11);
    }
    var_16 = wp::where(var_13, var_15, var_9);
    var_17 = wp::where(var_13, var_14, var_10);
    // if sqdists[j] < smallest:                                                              <L 5>
    var_19 = wp::extract(var_sqdists, var_18);
    var_20 = (var_19 < var_17);
    if (var_20) {
        // smallest = sqdists[j]                                                              <L 6>
        var_21 = wp::extract(var_sqdists, var_18);
        // lane = j                                                                           <L 7>
        var_22 = wp::copy(var_18);
    }
    var_23 = wp::where(var_20, var_22, var_16);
    var_24 = wp::where(var_20, var_21, var_17);
    // if sqdists[j] < smallest:                                                              <L 5>
    var_26 = wp::extract(var_sqdists, var_25);
    var_27 = (var_26 < var_24);
    if (var_27) {
        // smallest = sqdists[j]                                                              <L 6>
        var_28 = wp::extract(var_sqdists, var_25);
        // lane = j                                                                           <L 7>
        var_29 = wp::copy(var_25);
    }
    var_30 = wp::where(var_27, var_29, var_23);
    var_31 = wp::where(var_27, var_28, var_24);
    // if sqdists[j] < smallest:                                                              <L 5>
    var_33 = wp::extract(var_sqdists, var_32);
    var_34 = (var_33 < var_31);
    if (var_34) {
        // smallest = sqdists[j]                                                              <L 6>
        var_35 = wp::extract(var_sqdists, var_32);
        // lane = j                                                                           <L 7>
        var_36 = wp::copy(var_32);
    }
    var_37 = wp::where(var_34, var_36, var_30);
    var_38 = wp::where(var_34, var_35, var_31);
    // if sqdists[j] < smallest:                                                              <L 5>
    var_40 = wp::extract(var_sqdists, var_39);
    var_41 = (var_40 < var_38);
    if (var_41) {
        // smallest = sqdists[j]                                                              <L 6>
        var_42 = wp::extract(var_sqdists, var_39);
        // lane = j                                                                           <L 7>
        var_43 = wp::copy(var_39);
    }
    var_44 = wp::where(var_41, var_43, var_37);
    var_45 = wp::where(var_41, var_42, var_38);
    // if sqdists[j] < smallest:                                                              <L 5>
    var_47 = wp::extract(var_sqdists, var_46);
    var_48 = (var_47 < var_45);
    if (var_48) {
        // smallest = sqdists[j]                                                              <L 6>
        var_49 = wp::extract(var_sqdists, var_46);
        // lane = j                                                                           <L 7>
        var_50 = wp::copy(var_46);
    }
    var_51 = wp::where(var_48, var_50, var_44);
    var_52 = wp::where(var_48, var_49, var_45);
    // if sqdists[j] < smallest:                                                              <L 5>
    var_54 = wp::extract(var_sqdists, var_53);
    var_55 = (var_54 < var_52);
    if (var_55) {
        // smallest = sqdists[j]                                                              <L 6>
        var_56 = wp::extract(var_sqdists, var_53);
        // lane = j                                                                           <L 7>
        var_57 = wp::copy(var_53);
    }
    var_58 = wp::where(var_55, var_57, var_51);
    var_59 = wp::where(var_55, var_56, var_52);
    // if sqdists[j] < smallest:                                                              <L 5>
    var_61 = wp::extract(var_sqdists, var_60);
    var_62 = (var_61 < var_59);
    if (var_62) {
        // smallest = sqdists[j]                                                              <L 6>
        var_63 = wp::extract(var_sqdists, var_60);
        // lane = j                                                                           <L 7>
        var_64 = wp::copy(var_60);
    }
    var_65 = wp::where(var_62, var_64, var_58);
    var_66 = wp::where(var_62, var_63, var_59);
    // if sqdists[j] < smallest:                                                              <L 5>
    var_68 = wp::extract(var_sqdists, var_67);
    var_69 = (var_68 < var_66);
    if (var_69) {
        // smallest = sqdists[j]                                                              <L 6>
        var_70 = wp::extract(var_sqdists, var_67);
        // lane = j                                                                           <L 7>
        var_71 = wp::copy(var_67);
    }
    var_72 = wp::where(var_69, var_71, var_65);
    var_73 = wp::where(var_69, var_70, var_66);
    // if sqdists[j] < smallest:                                                              <L 5>
    var_75 = wp::extract(var_sqdists, var_74);
    var_76 = (var_75 < var_73);
    if (var_76) {
        // smallest = sqdists[j]                                                              <L 6>
        var_77 = wp::extract(var_sqdists, var_74);
        // lane = j                                                                           <L 7>
        var_78 = wp::copy(var_74);
    }
    var_79 = wp::where(var_76, var_78, var_72);
    var_80 = wp::where(var_76, var_77, var_73);
    // if sqdists[j] < smallest:                                                              <L 5>
    var_82 = wp::extract(var_sqdists, var_81);
    var_83 = (var_82 < var_80);
    if (var_83) {
        // smallest = sqdists[j]                                                              <L 6>
        var_84 = wp::extract(var_sqdists, var_81);
        // lane = j                                                                           <L 7>
        var_85 = wp::copy(var_81);
    }
    var_86 = wp::where(var_83, var_85, var_79);
    var_87 = wp::where(var_83, var_84, var_80);
    // if sqdists[j] < smallest:                                                              <L 5>
    var_89 = wp::extract(var_sqdists, var_88);
    var_90 = (var_89 < var_87);
    if (var_90) {
        // smallest = sqdists[j]                                                              <L 6>
        var_91 = wp::extract(var_sqdists, var_88);
        // lane = j                                                                           <L 7>
        var_92 = wp::copy(var_88);
    }
    var_93 = wp::where(var_90, var_92, var_86);
    var_94 = wp::where(var_90, var_91, var_87);
    // if sqdists[j] < smallest:                                                              <L 5>
    var_96 = wp::extract(var_sqdists, var_95);
    var_97 = (var_96 < var_94);
    if (var_97) {
        // smallest = sqdists[j]                                                              <L 6>
        var_98 = wp::extract(var_sqdists, var_95);
        // lane = j                                                                           <L 7>
        var_99 = wp::copy(var_95);
    }
    var_100 = wp::where(var_97, var_99, var_93);
    var_101 = wp::where(var_97, var_98, var_94);
    // if sqdists[j] < smallest:                                                              <L 5>
    var_103 = wp::extract(var_sqdists, var_102);
    var_104 = (var_103 < var_101);
    if (var_104) {
        // smallest = sqdists[j]                                                              <L 6>
        var_105 = wp::extract(var_sqdists, var_102);
        // lane = j                                                                           <L 7>
        var_106 = wp::copy(var_102);
    }
    var_107 = wp::where(var_104, var_106, var_100);
    var_108 = wp::where(var_104, var_105, var_101);
    // return lane                                                                            <L 8>
    return var_107;
}


// <pointloom.kernels.features.feature_matching.closest_group>:1
static CUDA_CALLABLE wp::int32 closest_group_0(
    wp::vec_t<16, wp::float32> var_y,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::int32 var_tree__roots,
    wp::int32 var_tree__second,
    wp::int32 var_tree__third)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    const wp::float32 var_2 = INFINITY;
    wp::float32 var_3;
    wp::range_t var_4;
    wp::int32 var_5;
    wp::int32 var_6;
    wp::vec_t<16, wp::float32> var_7;
    wp::int32 var_8;
    wp::float32 var_9;
    bool var_10;
    wp::float32 var_11;
    const wp::int32 var_12 = 16;
    wp::int32 var_13;
    wp::int32 var_14;
    wp::int32 var_15;
    wp::float32 var_16;
    wp::int32 var_17;
    wp::int32 var_18;
    wp::vec_t<16, wp::float32> var_19;
    wp::int32 var_20;
    wp::int32 var_21;
    wp::int32 var_22;
    wp::vec_t<16, wp::float32> var_23;
    wp::int32 var_24;
    wp::int32 var_25;
    //---------
    // forward
    // def closest_group(y, tree__boxes, tree__roots, tree__second, tree__third):             <L 1>
    // node = int(0)                                                                          <L 3>
    var_1 = wp::int(var_0);
    // min_sqdist = float(INFINITY)                                                           <L 4>
    var_3 = wp::float(var_2);
    // for root in range(tree__roots):                                                        <L 5>
    var_4 = wp::range(var_tree__roots);
    start_for_0:;
        if (iter_cmp(var_4) == 0) goto end_for_0;
        var_5 = wp::iter_next(var_4);
        // sqdists = measure_children(tree__third + root, tree__boxes, y)                     <L 6>
        var_6 = wp::add(var_tree__third, var_5);
        var_7 = measure_children_0(var_6, var_tree__boxes, var_y);
        // lane = smallest_lane(sqdists)                                                      <L 7>
        var_8 = smallest_lane_0(var_7);
        // if sqdists[lane] < min_sqdist:                                                     <L 8>
        var_9 = wp::extract(var_7, var_8);
        var_10 = (var_9 < var_3);
        if (var_10) {
            // min_sqdist = sqdists[lane]                                                     <L 9>
            var_11 = wp::extract(var_7, var_8);
            // node = root * FAN + lane                                                       <L 10>
            var_13 = wp::mul(var_5, var_12);
            var_14 = wp::add(var_13, var_8);
        }
        var_15 = wp::where(var_10, var_14, var_1);
        var_16 = wp::where(var_10, var_11, var_3);
        wp::assign(var_1, var_15);
        wp::assign(var_3, var_16);
        goto start_for_0;
    end_for_0:;
    // node = node * FAN + smallest_lane(measure_children(tree__second + node, tree__boxes, y))       <L 11>
    var_17 = wp::mul(var_1, var_12);
    var_18 = wp::add(var_tree__second, var_1);
    var_19 = measure_children_0(var_18, var_tree__boxes, var_y);
    var_20 = smallest_lane_0(var_19);
    var_21 = wp::add(var_17, var_20);
    // return node * FAN + smallest_lane(measure_children(node, tree__boxes, y))              <L 12>
    var_22 = wp::mul(var_21, var_12);
    var_23 = measure_children_0(var_21, var_tree__boxes, var_y);
    var_24 = smallest_lane_0(var_23);
    var_25 = wp::add(var_22, var_24);
    return var_25;
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


// /work/main/src/pointloom/kernels/algebra/plain_min_max.py:6
static CUDA_CALLABLE wp::float32 smaller_0(
    wp::float32 var_a,
    wp::float32 var_b)
{
    //---------
    // primal vars
    bool var_0;
    wp::float32 var_1;
    //---------
    // forward
    // def smaller(a: float, b: float) -> float:                                              <L 7>
    // return a if a < b else b                                                               <L 8>
    var_0 = (var_a < var_b);
    if (var_0) {
    }
    if (!var_0) {
    }
    var_1 = wp::where(var_0, var_a, var_b);
    return var_1;
}


// /work/main/src/pointloom/kernels/features/feature_matching.py:63
static CUDA_CALLABLE wp::float32 limit_of_0(
    wp::int64 var_key,
    wp::float32 var_slack,
    wp::float32 var_margin)
{
    //---------
    // primal vars
    wp::float32 var_0;
    wp::float32 var_1;
    wp::float32 var_2;
    wp::float32 var_3;
    wp::float32 var_4;
    wp::float32 var_5;
    const wp::float32 var_6 = 1e-30;
    wp::float32 var_7;
    const wp::float32 var_8 = 3e+38;
    wp::float32 var_9;
    //---------
    // forward
    // def limit_of(key: int64, slack: float, margin: float) -> float:                        <L 64>
    // bound = sqrt(key_number(key)) * slack + margin                                         <L 69>
    var_0 = key_number_0(var_key);
    var_1 = wp::sqrt(var_0);
    var_2 = wp::mul(var_1, var_slack);
    var_3 = wp::add(var_2, var_margin);
    // return smaller(bound * bound * slack + TINY, WIDEST_LIMIT)                             <L 70>
    var_4 = wp::mul(var_3, var_3);
    var_5 = wp::mul(var_4, var_slack);
    var_7 = wp::add(var_5, var_6);
    var_9 = smaller_0(var_7, var_8);
    return var_9;
}


// <pointloom.kernels.features.feature_matching.lanes_within>:1
static CUDA_CALLABLE wp::int32 lanes_within_0(
    wp::vec_t<16, wp::float32> var_sqdists,
    wp::float32 var_limit)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    const wp::int32 var_2 = 0;
    wp::float32 var_3;
    bool var_4;
    const wp::int32 var_5 = 1;
    const wp::int32 var_6 = 0;
    wp::int32 var_7;
    wp::int32 var_8;
    wp::int32 var_9;
    const wp::int32 var_10 = 1;
    wp::float32 var_11;
    bool var_12;
    const wp::int32 var_13 = 1;
    const wp::int32 var_14 = 0;
    wp::int32 var_15;
    wp::int32 var_16;
    wp::int32 var_17;
    const wp::int32 var_18 = 2;
    wp::float32 var_19;
    bool var_20;
    const wp::int32 var_21 = 1;
    const wp::int32 var_22 = 0;
    wp::int32 var_23;
    wp::int32 var_24;
    wp::int32 var_25;
    const wp::int32 var_26 = 3;
    wp::float32 var_27;
    bool var_28;
    const wp::int32 var_29 = 1;
    const wp::int32 var_30 = 0;
    wp::int32 var_31;
    wp::int32 var_32;
    wp::int32 var_33;
    const wp::int32 var_34 = 4;
    wp::float32 var_35;
    bool var_36;
    const wp::int32 var_37 = 1;
    const wp::int32 var_38 = 0;
    wp::int32 var_39;
    wp::int32 var_40;
    wp::int32 var_41;
    const wp::int32 var_42 = 5;
    wp::float32 var_43;
    bool var_44;
    const wp::int32 var_45 = 1;
    const wp::int32 var_46 = 0;
    wp::int32 var_47;
    wp::int32 var_48;
    wp::int32 var_49;
    const wp::int32 var_50 = 6;
    wp::float32 var_51;
    bool var_52;
    const wp::int32 var_53 = 1;
    const wp::int32 var_54 = 0;
    wp::int32 var_55;
    wp::int32 var_56;
    wp::int32 var_57;
    const wp::int32 var_58 = 7;
    wp::float32 var_59;
    bool var_60;
    const wp::int32 var_61 = 1;
    const wp::int32 var_62 = 0;
    wp::int32 var_63;
    wp::int32 var_64;
    wp::int32 var_65;
    const wp::int32 var_66 = 8;
    wp::float32 var_67;
    bool var_68;
    const wp::int32 var_69 = 1;
    const wp::int32 var_70 = 0;
    wp::int32 var_71;
    wp::int32 var_72;
    wp::int32 var_73;
    const wp::int32 var_74 = 9;
    wp::float32 var_75;
    bool var_76;
    const wp::int32 var_77 = 1;
    const wp::int32 var_78 = 0;
    wp::int32 var_79;
    wp::int32 var_80;
    wp::int32 var_81;
    const wp::int32 var_82 = 10;
    wp::float32 var_83;
    bool var_84;
    const wp::int32 var_85 = 1;
    const wp::int32 var_86 = 0;
    wp::int32 var_87;
    wp::int32 var_88;
    wp::int32 var_89;
    const wp::int32 var_90 = 11;
    wp::float32 var_91;
    bool var_92;
    const wp::int32 var_93 = 1;
    const wp::int32 var_94 = 0;
    wp::int32 var_95;
    wp::int32 var_96;
    wp::int32 var_97;
    const wp::int32 var_98 = 12;
    wp::float32 var_99;
    bool var_100;
    const wp::int32 var_101 = 1;
    const wp::int32 var_102 = 0;
    wp::int32 var_103;
    wp::int32 var_104;
    wp::int32 var_105;
    const wp::int32 var_106 = 13;
    wp::float32 var_107;
    bool var_108;
    const wp::int32 var_109 = 1;
    const wp::int32 var_110 = 0;
    wp::int32 var_111;
    wp::int32 var_112;
    wp::int32 var_113;
    const wp::int32 var_114 = 14;
    wp::float32 var_115;
    bool var_116;
    const wp::int32 var_117 = 1;
    const wp::int32 var_118 = 0;
    wp::int32 var_119;
    wp::int32 var_120;
    wp::int32 var_121;
    const wp::int32 var_122 = 15;
    wp::float32 var_123;
    bool var_124;
    const wp::int32 var_125 = 1;
    const wp::int32 var_126 = 0;
    wp::int32 var_127;
    wp::int32 var_128;
    wp::int32 var_129;
    //---------
    // forward
    // def lanes_within(sqdists, limit):                                                      <L 1>
    // bits = int(0)                                                                          <L 2>
    var_1 = wp::int(var_0);
    // for j in range(FAN):                                                                   <L 3>
    // bits = bits | (1 if sqdists[j] <= limit else 0) << j                                   <L 4>
    var_3 = wp::extract(var_sqdists, var_2);
    var_4 = (var_3 <= var_limit);
    if (var_4) {
    }
    if (!var_4) {
    }
    var_7 = wp::where(var_4, var_5, var_6);
    var_8 = wp::lshift(var_7, var_2);
    var_9 = wp::bit_or(var_1, var_8);
    var_11 = wp::extract(var_sqdists, var_10);
    var_12 = (var_11 <= var_limit);
    if (var_12) {
    }
    if (!var_12) {
    }
    var_15 = wp::where(var_12, var_13, var_14);
    var_16 = wp::lshift(var_15, var_10);
    var_17 = wp::bit_or(var_9, var_16);
    var_19 = wp::extract(var_sqdists, var_18);
    var_20 = (var_19 <= var_limit);
    if (var_20) {
    }
    if (!var_20) {
    }
    var_23 = wp::where(var_20, var_21, var_22);
    var_24 = wp::lshift(var_23, var_18);
    var_25 = wp::bit_or(var_17, var_24);
    var_27 = wp::extract(var_sqdists, var_26);
    var_28 = (var_27 <= var_limit);
    if (var_28) {
    }
    if (!var_28) {
    }
    var_31 = wp::where(var_28, var_29, var_30);
    var_32 = wp::lshift(var_31, var_26);
    var_33 = wp::bit_or(var_25, var_32);
    var_35 = wp::extract(var_sqdists, var_34);
    var_36 = (var_35 <= var_limit);
    if (var_36) {
    }
    if (!var_36) {
    }
    var_39 = wp::where(var_36, var_37, var_38);
    var_40 = wp::lshift(var_39, var_34);
    var_41 = wp::bit_or(var_33, var_40);
    var_43 = wp::extract(var_sqdists, var_42);
    var_44 = (var_43 <= var_limit);
    if (var_44) {
    }
    if (!var_44) {
    }
    var_47 = wp::where(var_44, var_45, var_46);
    var_48 = wp::lshift(var_47, var_42);
    var_49 = wp::bit_or(var_41, var_48);
    var_51 = wp::extract(var_sqdists, var_50);
    var_52 = (var_51 <= var_limit);
    if (var_52) {
    }
    if (!var_52) {
    }
    var_55 = wp::where(var_52, var_53, var_54);
    var_56 = wp::lshift(var_55, var_50);
    var_57 = wp::bit_or(var_49, var_56);
    var_59 = wp::extract(var_sqdists, var_58);
    var_60 = (var_59 <= var_limit);
    if (var_60) {
    }
    if (!var_60) {
    }
    var_63 = wp::where(var_60, var_61, var_62);
    var_64 = wp::lshift(var_63, var_58);
    var_65 = wp::bit_or(var_57, var_64);
    var_67 = wp::extract(var_sqdists, var_66);
    var_68 = (var_67 <= var_limit);
    if (var_68) {
    }
    if (!var_68) {
    }
    var_71 = wp::where(var_68, var_69, var_70);
    var_72 = wp::lshift(var_71, var_66);
    var_73 = wp::bit_or(var_65, var_72);
    var_75 = wp::extract(var_sqdists, var_74);
    var_76 = (var_75 <= var_limit);
    if (var_76) {
    }
    if (!var_76) {
    }
    var_79 = wp::where(var_76, var_77, var_78);
    var_80 = wp::lshift(var_79, var_74);
    var_81 = wp::bit_or(var_73, var_80);
    var_83 = wp::extract(var_sqdists, var_82);
    var_84 = (var_83 <= var_limit);
    if (var_84) {
    }
    if (!var_84) {
    }
    var_87 = wp::where(var_84, var_85, var_86);
    var_88 = wp::lshift(var_87, var_82);
    var_89 = wp::bit_or(var_81, var_88);
    var_91 = wp::extract(var_sqdists, var_90);
    var_92 = (var_91 <= var_limit);
    if (var_92) {
    }
    if (!var_92) {
    }
    var_95 = wp::where(var_92, var_93, var_94);
    var_96 = wp::lshift(var_95, var_90);
    var_97 = wp::bit_or(var_89, var_96);
    var_99 = wp::extract(var_sqdists, var_98);
    var_100 = (var_99 <= var_limit);
    if (var_100) {
    }
    if (!var_100) {
    }
    var_103 = wp::where(var_100, var_101, var_102);
    var_104 = wp::lshift(var_103, var_98);
    var_105 = wp::bit_or(var_97, var_104);
    var_107 = wp::extract(var_sqdists, var_106);
    var_108 = (var_107 <= var_limit);
    if (var_108) {
    }
    if (!var_108) {
    }
    var_111 = wp::where(var_108, var_109, var_110);
    var_112 = wp::lshift(var_111, var_106);
    var_113 = wp::bit_or(var_105, var_112);
    var_115 = wp::extract(var_sqdists, var_114);
    var_116 = (var_115 <= var_limit);
    if (var_116) {
    }
    if (!var_116) {
    }
    var_119 = wp::where(var_116, var_117, var_118);
    var_120 = wp::lshift(var_119, var_114);
    var_121 = wp::bit_or(var_113, var_120);
    var_123 = wp::extract(var_sqdists, var_122);
    var_124 = (var_123 <= var_limit);
    if (var_124) {
    }
    if (!var_124) {
    }
    var_127 = wp::where(var_124, var_125, var_126);
    var_128 = wp::lshift(var_127, var_122);
    var_129 = wp::bit_or(var_121, var_128);
    // return bits                                                                            <L 5>
    return var_129;
}


// /work/main/src/pointloom/kernels/features/feature_matching.py:105
static CUDA_CALLABLE wp::int32 rows_within_0(
    wp::int32 var_group,
    wp::array_t<wp::float32> var_grouped,
    wp::vec_t<16, wp::float32> var_y,
    wp::float32 var_limit)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 16;
    wp::int32 var_1;
    const wp::int32 var_2 = 16;
    wp::int32 var_3;
    const wp::float32 var_4 = 0.0;
    wp::vec_t<16, wp::float32> var_5;
    const wp::int32 var_6 = 0;
    wp::float32 var_7;
    const wp::int32 var_8 = 0;
    wp::int32 var_9;
    wp::int32 var_10;
    wp::int32 var_11;
    wp::float32* var_12;
    wp::float32 var_13;
    wp::float32 var_14;
    wp::float32 var_15;
    const wp::int32 var_16 = 1;
    wp::int32 var_17;
    wp::int32 var_18;
    wp::int32 var_19;
    wp::float32* var_20;
    wp::float32 var_21;
    wp::float32 var_22;
    wp::float32 var_23;
    const wp::int32 var_24 = 2;
    wp::int32 var_25;
    wp::int32 var_26;
    wp::int32 var_27;
    wp::float32* var_28;
    wp::float32 var_29;
    wp::float32 var_30;
    wp::float32 var_31;
    const wp::int32 var_32 = 3;
    wp::int32 var_33;
    wp::int32 var_34;
    wp::int32 var_35;
    wp::float32* var_36;
    wp::float32 var_37;
    wp::float32 var_38;
    wp::float32 var_39;
    const wp::int32 var_40 = 4;
    wp::int32 var_41;
    wp::int32 var_42;
    wp::int32 var_43;
    wp::float32* var_44;
    wp::float32 var_45;
    wp::float32 var_46;
    wp::float32 var_47;
    const wp::int32 var_48 = 5;
    wp::int32 var_49;
    wp::int32 var_50;
    wp::int32 var_51;
    wp::float32* var_52;
    wp::float32 var_53;
    wp::float32 var_54;
    wp::float32 var_55;
    const wp::int32 var_56 = 6;
    wp::int32 var_57;
    wp::int32 var_58;
    wp::int32 var_59;
    wp::float32* var_60;
    wp::float32 var_61;
    wp::float32 var_62;
    wp::float32 var_63;
    const wp::int32 var_64 = 7;
    wp::int32 var_65;
    wp::int32 var_66;
    wp::int32 var_67;
    wp::float32* var_68;
    wp::float32 var_69;
    wp::float32 var_70;
    wp::float32 var_71;
    const wp::int32 var_72 = 8;
    wp::int32 var_73;
    wp::int32 var_74;
    wp::int32 var_75;
    wp::float32* var_76;
    wp::float32 var_77;
    wp::float32 var_78;
    wp::float32 var_79;
    const wp::int32 var_80 = 9;
    wp::int32 var_81;
    wp::int32 var_82;
    wp::int32 var_83;
    wp::float32* var_84;
    wp::float32 var_85;
    wp::float32 var_86;
    wp::float32 var_87;
    const wp::int32 var_88 = 10;
    wp::int32 var_89;
    wp::int32 var_90;
    wp::int32 var_91;
    wp::float32* var_92;
    wp::float32 var_93;
    wp::float32 var_94;
    wp::float32 var_95;
    const wp::int32 var_96 = 11;
    wp::int32 var_97;
    wp::int32 var_98;
    wp::int32 var_99;
    wp::float32* var_100;
    wp::float32 var_101;
    wp::float32 var_102;
    wp::float32 var_103;
    const wp::int32 var_104 = 12;
    wp::int32 var_105;
    wp::int32 var_106;
    wp::int32 var_107;
    wp::float32* var_108;
    wp::float32 var_109;
    wp::float32 var_110;
    wp::float32 var_111;
    const wp::int32 var_112 = 13;
    wp::int32 var_113;
    wp::int32 var_114;
    wp::int32 var_115;
    wp::float32* var_116;
    wp::float32 var_117;
    wp::float32 var_118;
    wp::float32 var_119;
    const wp::int32 var_120 = 14;
    wp::int32 var_121;
    wp::int32 var_122;
    wp::int32 var_123;
    wp::float32* var_124;
    wp::float32 var_125;
    wp::float32 var_126;
    wp::float32 var_127;
    const wp::int32 var_128 = 15;
    wp::int32 var_129;
    wp::int32 var_130;
    wp::int32 var_131;
    wp::float32* var_132;
    wp::float32 var_133;
    wp::float32 var_134;
    wp::float32 var_135;
    const wp::int32 var_136 = 1;
    wp::float32 var_137;
    const wp::int32 var_138 = 0;
    wp::int32 var_139;
    wp::int32 var_140;
    wp::int32 var_141;
    wp::float32* var_142;
    wp::float32 var_143;
    wp::float32 var_144;
    wp::float32 var_145;
    const wp::int32 var_146 = 1;
    wp::int32 var_147;
    wp::int32 var_148;
    wp::int32 var_149;
    wp::float32* var_150;
    wp::float32 var_151;
    wp::float32 var_152;
    wp::float32 var_153;
    const wp::int32 var_154 = 2;
    wp::int32 var_155;
    wp::int32 var_156;
    wp::int32 var_157;
    wp::float32* var_158;
    wp::float32 var_159;
    wp::float32 var_160;
    wp::float32 var_161;
    const wp::int32 var_162 = 3;
    wp::int32 var_163;
    wp::int32 var_164;
    wp::int32 var_165;
    wp::float32* var_166;
    wp::float32 var_167;
    wp::float32 var_168;
    wp::float32 var_169;
    const wp::int32 var_170 = 4;
    wp::int32 var_171;
    wp::int32 var_172;
    wp::int32 var_173;
    wp::float32* var_174;
    wp::float32 var_175;
    wp::float32 var_176;
    wp::float32 var_177;
    const wp::int32 var_178 = 5;
    wp::int32 var_179;
    wp::int32 var_180;
    wp::int32 var_181;
    wp::float32* var_182;
    wp::float32 var_183;
    wp::float32 var_184;
    wp::float32 var_185;
    const wp::int32 var_186 = 6;
    wp::int32 var_187;
    wp::int32 var_188;
    wp::int32 var_189;
    wp::float32* var_190;
    wp::float32 var_191;
    wp::float32 var_192;
    wp::float32 var_193;
    const wp::int32 var_194 = 7;
    wp::int32 var_195;
    wp::int32 var_196;
    wp::int32 var_197;
    wp::float32* var_198;
    wp::float32 var_199;
    wp::float32 var_200;
    wp::float32 var_201;
    const wp::int32 var_202 = 8;
    wp::int32 var_203;
    wp::int32 var_204;
    wp::int32 var_205;
    wp::float32* var_206;
    wp::float32 var_207;
    wp::float32 var_208;
    wp::float32 var_209;
    const wp::int32 var_210 = 9;
    wp::int32 var_211;
    wp::int32 var_212;
    wp::int32 var_213;
    wp::float32* var_214;
    wp::float32 var_215;
    wp::float32 var_216;
    wp::float32 var_217;
    const wp::int32 var_218 = 10;
    wp::int32 var_219;
    wp::int32 var_220;
    wp::int32 var_221;
    wp::float32* var_222;
    wp::float32 var_223;
    wp::float32 var_224;
    wp::float32 var_225;
    const wp::int32 var_226 = 11;
    wp::int32 var_227;
    wp::int32 var_228;
    wp::int32 var_229;
    wp::float32* var_230;
    wp::float32 var_231;
    wp::float32 var_232;
    wp::float32 var_233;
    const wp::int32 var_234 = 12;
    wp::int32 var_235;
    wp::int32 var_236;
    wp::int32 var_237;
    wp::float32* var_238;
    wp::float32 var_239;
    wp::float32 var_240;
    wp::float32 var_241;
    const wp::int32 var_242 = 13;
    wp::int32 var_243;
    wp::int32 var_244;
    wp::int32 var_245;
    wp::float32* var_246;
    wp::float32 var_247;
    wp::float32 var_248;
    wp::float32 var_249;
    const wp::int32 var_250 = 14;
    wp::int32 var_251;
    wp::int32 var_252;
    wp::int32 var_253;
    wp::float32* var_254;
    wp::float32 var_255;
    wp::float32 var_256;
    wp::float32 var_257;
    const wp::int32 var_258 = 15;
    wp::int32 var_259;
    wp::int32 var_260;
    wp::int32 var_261;
    wp::float32* var_262;
    wp::float32 var_263;
    wp::float32 var_264;
    wp::float32 var_265;
    const wp::int32 var_266 = 2;
    wp::float32 var_267;
    const wp::int32 var_268 = 0;
    wp::int32 var_269;
    wp::int32 var_270;
    wp::int32 var_271;
    wp::float32* var_272;
    wp::float32 var_273;
    wp::float32 var_274;
    wp::float32 var_275;
    const wp::int32 var_276 = 1;
    wp::int32 var_277;
    wp::int32 var_278;
    wp::int32 var_279;
    wp::float32* var_280;
    wp::float32 var_281;
    wp::float32 var_282;
    wp::float32 var_283;
    const wp::int32 var_284 = 2;
    wp::int32 var_285;
    wp::int32 var_286;
    wp::int32 var_287;
    wp::float32* var_288;
    wp::float32 var_289;
    wp::float32 var_290;
    wp::float32 var_291;
    const wp::int32 var_292 = 3;
    wp::int32 var_293;
    wp::int32 var_294;
    wp::int32 var_295;
    wp::float32* var_296;
    wp::float32 var_297;
    wp::float32 var_298;
    wp::float32 var_299;
    const wp::int32 var_300 = 4;
    wp::int32 var_301;
    wp::int32 var_302;
    wp::int32 var_303;
    wp::float32* var_304;
    wp::float32 var_305;
    wp::float32 var_306;
    wp::float32 var_307;
    const wp::int32 var_308 = 5;
    wp::int32 var_309;
    wp::int32 var_310;
    wp::int32 var_311;
    wp::float32* var_312;
    wp::float32 var_313;
    wp::float32 var_314;
    wp::float32 var_315;
    const wp::int32 var_316 = 6;
    wp::int32 var_317;
    wp::int32 var_318;
    wp::int32 var_319;
    wp::float32* var_320;
    wp::float32 var_321;
    wp::float32 var_322;
    wp::float32 var_323;
    const wp::int32 var_324 = 7;
    wp::int32 var_325;
    wp::int32 var_326;
    wp::int32 var_327;
    wp::float32* var_328;
    wp::float32 var_329;
    wp::float32 var_330;
    wp::float32 var_331;
    const wp::int32 var_332 = 8;
    wp::int32 var_333;
    wp::int32 var_334;
    wp::int32 var_335;
    wp::float32* var_336;
    wp::float32 var_337;
    wp::float32 var_338;
    wp::float32 var_339;
    const wp::int32 var_340 = 9;
    wp::int32 var_341;
    wp::int32 var_342;
    wp::int32 var_343;
    wp::float32* var_344;
    wp::float32 var_345;
    wp::float32 var_346;
    wp::float32 var_347;
    const wp::int32 var_348 = 10;
    wp::int32 var_349;
    wp::int32 var_350;
    wp::int32 var_351;
    wp::float32* var_352;
    wp::float32 var_353;
    wp::float32 var_354;
    wp::float32 var_355;
    const wp::int32 var_356 = 11;
    wp::int32 var_357;
    wp::int32 var_358;
    wp::int32 var_359;
    wp::float32* var_360;
    wp::float32 var_361;
    wp::float32 var_362;
    wp::float32 var_363;
    const wp::int32 var_364 = 12;
    wp::int32 var_365;
    wp::int32 var_366;
    wp::int32 var_367;
    wp::float32* var_368;
    wp::float32 var_369;
    wp::float32 var_370;
    wp::float32 var_371;
    const wp::int32 var_372 = 13;
    wp::int32 var_373;
    wp::int32 var_374;
    wp::int32 var_375;
    wp::float32* var_376;
    wp::float32 var_377;
    wp::float32 var_378;
    wp::float32 var_379;
    const wp::int32 var_380 = 14;
    wp::int32 var_381;
    wp::int32 var_382;
    wp::int32 var_383;
    wp::float32* var_384;
    wp::float32 var_385;
    wp::float32 var_386;
    wp::float32 var_387;
    const wp::int32 var_388 = 15;
    wp::int32 var_389;
    wp::int32 var_390;
    wp::int32 var_391;
    wp::float32* var_392;
    wp::float32 var_393;
    wp::float32 var_394;
    wp::float32 var_395;
    const wp::int32 var_396 = 3;
    wp::float32 var_397;
    const wp::int32 var_398 = 0;
    wp::int32 var_399;
    wp::int32 var_400;
    wp::int32 var_401;
    wp::float32* var_402;
    wp::float32 var_403;
    wp::float32 var_404;
    wp::float32 var_405;
    const wp::int32 var_406 = 1;
    wp::int32 var_407;
    wp::int32 var_408;
    wp::int32 var_409;
    wp::float32* var_410;
    wp::float32 var_411;
    wp::float32 var_412;
    wp::float32 var_413;
    const wp::int32 var_414 = 2;
    wp::int32 var_415;
    wp::int32 var_416;
    wp::int32 var_417;
    wp::float32* var_418;
    wp::float32 var_419;
    wp::float32 var_420;
    wp::float32 var_421;
    const wp::int32 var_422 = 3;
    wp::int32 var_423;
    wp::int32 var_424;
    wp::int32 var_425;
    wp::float32* var_426;
    wp::float32 var_427;
    wp::float32 var_428;
    wp::float32 var_429;
    const wp::int32 var_430 = 4;
    wp::int32 var_431;
    wp::int32 var_432;
    wp::int32 var_433;
    wp::float32* var_434;
    wp::float32 var_435;
    wp::float32 var_436;
    wp::float32 var_437;
    const wp::int32 var_438 = 5;
    wp::int32 var_439;
    wp::int32 var_440;
    wp::int32 var_441;
    wp::float32* var_442;
    wp::float32 var_443;
    wp::float32 var_444;
    wp::float32 var_445;
    const wp::int32 var_446 = 6;
    wp::int32 var_447;
    wp::int32 var_448;
    wp::int32 var_449;
    wp::float32* var_450;
    wp::float32 var_451;
    wp::float32 var_452;
    wp::float32 var_453;
    const wp::int32 var_454 = 7;
    wp::int32 var_455;
    wp::int32 var_456;
    wp::int32 var_457;
    wp::float32* var_458;
    wp::float32 var_459;
    wp::float32 var_460;
    wp::float32 var_461;
    const wp::int32 var_462 = 8;
    wp::int32 var_463;
    wp::int32 var_464;
    wp::int32 var_465;
    wp::float32* var_466;
    wp::float32 var_467;
    wp::float32 var_468;
    wp::float32 var_469;
    const wp::int32 var_470 = 9;
    wp::int32 var_471;
    wp::int32 var_472;
    wp::int32 var_473;
    wp::float32* var_474;
    wp::float32 var_475;
    wp::float32 var_476;
    wp::float32 var_477;
    const wp::int32 var_478 = 10;
    wp::int32 var_479;
    wp::int32 var_480;
    wp::int32 var_481;
    wp::float32* var_482;
    wp::float32 var_483;
    wp::float32 var_484;
    wp::float32 var_485;
    const wp::int32 var_486 = 11;
    wp::int32 var_487;
    wp::int32 var_488;
    wp::int32 var_489;
    wp::float32* var_490;
    wp::float32 var_491;
    wp::float32 var_492;
    wp::float32 var_493;
    const wp::int32 var_494 = 12;
    wp::int32 var_495;
    wp::int32 var_496;
    wp::int32 var_497;
    wp::float32* var_498;
    wp::float32 var_499;
    wp::float32 var_500;
    wp::float32 var_501;
    const wp::int32 var_502 = 13;
    wp::int32 var_503;
    wp::int32 var_504;
    wp::int32 var_505;
    wp::float32* var_506;
    wp::float32 var_507;
    wp::float32 var_508;
    wp::float32 var_509;
    const wp::int32 var_510 = 14;
    wp::int32 var_511;
    wp::int32 var_512;
    wp::int32 var_513;
    wp::float32* var_514;
    wp::float32 var_515;
    wp::float32 var_516;
    wp::float32 var_517;
    const wp::int32 var_518 = 15;
    wp::int32 var_519;
    wp::int32 var_520;
    wp::int32 var_521;
    wp::float32* var_522;
    wp::float32 var_523;
    wp::float32 var_524;
    wp::float32 var_525;
    const wp::int32 var_526 = 4;
    wp::float32 var_527;
    const wp::int32 var_528 = 0;
    wp::int32 var_529;
    wp::int32 var_530;
    wp::int32 var_531;
    wp::float32* var_532;
    wp::float32 var_533;
    wp::float32 var_534;
    wp::float32 var_535;
    const wp::int32 var_536 = 1;
    wp::int32 var_537;
    wp::int32 var_538;
    wp::int32 var_539;
    wp::float32* var_540;
    wp::float32 var_541;
    wp::float32 var_542;
    wp::float32 var_543;
    const wp::int32 var_544 = 2;
    wp::int32 var_545;
    wp::int32 var_546;
    wp::int32 var_547;
    wp::float32* var_548;
    wp::float32 var_549;
    wp::float32 var_550;
    wp::float32 var_551;
    const wp::int32 var_552 = 3;
    wp::int32 var_553;
    wp::int32 var_554;
    wp::int32 var_555;
    wp::float32* var_556;
    wp::float32 var_557;
    wp::float32 var_558;
    wp::float32 var_559;
    const wp::int32 var_560 = 4;
    wp::int32 var_561;
    wp::int32 var_562;
    wp::int32 var_563;
    wp::float32* var_564;
    wp::float32 var_565;
    wp::float32 var_566;
    wp::float32 var_567;
    const wp::int32 var_568 = 5;
    wp::int32 var_569;
    wp::int32 var_570;
    wp::int32 var_571;
    wp::float32* var_572;
    wp::float32 var_573;
    wp::float32 var_574;
    wp::float32 var_575;
    const wp::int32 var_576 = 6;
    wp::int32 var_577;
    wp::int32 var_578;
    wp::int32 var_579;
    wp::float32* var_580;
    wp::float32 var_581;
    wp::float32 var_582;
    wp::float32 var_583;
    const wp::int32 var_584 = 7;
    wp::int32 var_585;
    wp::int32 var_586;
    wp::int32 var_587;
    wp::float32* var_588;
    wp::float32 var_589;
    wp::float32 var_590;
    wp::float32 var_591;
    const wp::int32 var_592 = 8;
    wp::int32 var_593;
    wp::int32 var_594;
    wp::int32 var_595;
    wp::float32* var_596;
    wp::float32 var_597;
    wp::float32 var_598;
    wp::float32 var_599;
    const wp::int32 var_600 = 9;
    wp::int32 var_601;
    wp::int32 var_602;
    wp::int32 var_603;
    wp::float32* var_604;
    wp::float32 var_605;
    wp::float32 var_606;
    wp::float32 var_607;
    const wp::int32 var_608 = 10;
    wp::int32 var_609;
    wp::int32 var_610;
    wp::int32 var_611;
    wp::float32* var_612;
    wp::float32 var_613;
    wp::float32 var_614;
    wp::float32 var_615;
    const wp::int32 var_616 = 11;
    wp::int32 var_617;
    wp::int32 var_618;
    wp::int32 var_619;
    wp::float32* var_620;
    wp::float32 var_621;
    wp::float32 var_622;
    wp::float32 var_623;
    const wp::int32 var_624 = 12;
    wp::int32 var_625;
    wp::int32 var_626;
    wp::int32 var_627;
    wp::float32* var_628;
    wp::float32 var_629;
    wp::float32 var_630;
    wp::float32 var_631;
    const wp::int32 var_632 = 13;
    wp::int32 var_633;
    wp::int32 var_634;
    wp::int32 var_635;
    wp::float32* var_636;
    wp::float32 var_637;
    wp::float32 var_638;
    wp::float32 var_639;
    const wp::int32 var_640 = 14;
    wp::int32 var_641;
    wp::int32 var_642;
    wp::int32 var_643;
    wp::float32* var_644;
    wp::float32 var_645;
    wp::float32 var_646;
    wp::float32 var_647;
    const wp::int32 var_648 = 15;
    wp::int32 var_649;
    wp::int32 var_650;
    wp::int32 var_651;
    wp::float32* var_652;
    wp::float32 var_653;
    wp::float32 var_654;
    wp::float32 var_655;
    const wp::int32 var_656 = 5;
    wp::float32 var_657;
    const wp::int32 var_658 = 0;
    wp::int32 var_659;
    wp::int32 var_660;
    wp::int32 var_661;
    wp::float32* var_662;
    wp::float32 var_663;
    wp::float32 var_664;
    wp::float32 var_665;
    const wp::int32 var_666 = 1;
    wp::int32 var_667;
    wp::int32 var_668;
    wp::int32 var_669;
    wp::float32* var_670;
    wp::float32 var_671;
    wp::float32 var_672;
    wp::float32 var_673;
    const wp::int32 var_674 = 2;
    wp::int32 var_675;
    wp::int32 var_676;
    wp::int32 var_677;
    wp::float32* var_678;
    wp::float32 var_679;
    wp::float32 var_680;
    wp::float32 var_681;
    const wp::int32 var_682 = 3;
    wp::int32 var_683;
    wp::int32 var_684;
    wp::int32 var_685;
    wp::float32* var_686;
    wp::float32 var_687;
    wp::float32 var_688;
    wp::float32 var_689;
    const wp::int32 var_690 = 4;
    wp::int32 var_691;
    wp::int32 var_692;
    wp::int32 var_693;
    wp::float32* var_694;
    wp::float32 var_695;
    wp::float32 var_696;
    wp::float32 var_697;
    const wp::int32 var_698 = 5;
    wp::int32 var_699;
    wp::int32 var_700;
    wp::int32 var_701;
    wp::float32* var_702;
    wp::float32 var_703;
    wp::float32 var_704;
    wp::float32 var_705;
    const wp::int32 var_706 = 6;
    wp::int32 var_707;
    wp::int32 var_708;
    wp::int32 var_709;
    wp::float32* var_710;
    wp::float32 var_711;
    wp::float32 var_712;
    wp::float32 var_713;
    const wp::int32 var_714 = 7;
    wp::int32 var_715;
    wp::int32 var_716;
    wp::int32 var_717;
    wp::float32* var_718;
    wp::float32 var_719;
    wp::float32 var_720;
    wp::float32 var_721;
    const wp::int32 var_722 = 8;
    wp::int32 var_723;
    wp::int32 var_724;
    wp::int32 var_725;
    wp::float32* var_726;
    wp::float32 var_727;
    wp::float32 var_728;
    wp::float32 var_729;
    const wp::int32 var_730 = 9;
    wp::int32 var_731;
    wp::int32 var_732;
    wp::int32 var_733;
    wp::float32* var_734;
    wp::float32 var_735;
    wp::float32 var_736;
    wp::float32 var_737;
    const wp::int32 var_738 = 10;
    wp::int32 var_739;
    wp::int32 var_740;
    wp::int32 var_741;
    wp::float32* var_742;
    wp::float32 var_743;
    wp::float32 var_744;
    wp::float32 var_745;
    const wp::int32 var_746 = 11;
    wp::int32 var_747;
    wp::int32 var_748;
    wp::int32 var_749;
    wp::float32* var_750;
    wp::float32 var_751;
    wp::float32 var_752;
    wp::float32 var_753;
    const wp::int32 var_754 = 12;
    wp::int32 var_755;
    wp::int32 var_756;
    wp::int32 var_757;
    wp::float32* var_758;
    wp::float32 var_759;
    wp::float32 var_760;
    wp::float32 var_761;
    const wp::int32 var_762 = 13;
    wp::int32 var_763;
    wp::int32 var_764;
    wp::int32 var_765;
    wp::float32* var_766;
    wp::float32 var_767;
    wp::float32 var_768;
    wp::float32 var_769;
    const wp::int32 var_770 = 14;
    wp::int32 var_771;
    wp::int32 var_772;
    wp::int32 var_773;
    wp::float32* var_774;
    wp::float32 var_775;
    wp::float32 var_776;
    wp::float32 var_777;
    const wp::int32 var_778 = 15;
    wp::int32 var_779;
    wp::int32 var_780;
    wp::int32 var_781;
    wp::float32* var_782;
    wp::float32 var_783;
    wp::float32 var_784;
    wp::float32 var_785;
    wp::int32 var_786;
    const wp::int32 var_787 = 0;
    bool var_788;
    const wp::int32 var_789 = 6;
    wp::float32 var_790;
    const wp::int32 var_791 = 0;
    wp::int32 var_792;
    wp::int32 var_793;
    wp::int32 var_794;
    wp::float32* var_795;
    wp::float32 var_796;
    wp::float32 var_797;
    wp::float32 var_798;
    const wp::int32 var_799 = 1;
    wp::int32 var_800;
    wp::int32 var_801;
    wp::int32 var_802;
    wp::float32* var_803;
    wp::float32 var_804;
    wp::float32 var_805;
    wp::float32 var_806;
    const wp::int32 var_807 = 2;
    wp::int32 var_808;
    wp::int32 var_809;
    wp::int32 var_810;
    wp::float32* var_811;
    wp::float32 var_812;
    wp::float32 var_813;
    wp::float32 var_814;
    const wp::int32 var_815 = 3;
    wp::int32 var_816;
    wp::int32 var_817;
    wp::int32 var_818;
    wp::float32* var_819;
    wp::float32 var_820;
    wp::float32 var_821;
    wp::float32 var_822;
    const wp::int32 var_823 = 4;
    wp::int32 var_824;
    wp::int32 var_825;
    wp::int32 var_826;
    wp::float32* var_827;
    wp::float32 var_828;
    wp::float32 var_829;
    wp::float32 var_830;
    const wp::int32 var_831 = 5;
    wp::int32 var_832;
    wp::int32 var_833;
    wp::int32 var_834;
    wp::float32* var_835;
    wp::float32 var_836;
    wp::float32 var_837;
    wp::float32 var_838;
    const wp::int32 var_839 = 6;
    wp::int32 var_840;
    wp::int32 var_841;
    wp::int32 var_842;
    wp::float32* var_843;
    wp::float32 var_844;
    wp::float32 var_845;
    wp::float32 var_846;
    const wp::int32 var_847 = 7;
    wp::int32 var_848;
    wp::int32 var_849;
    wp::int32 var_850;
    wp::float32* var_851;
    wp::float32 var_852;
    wp::float32 var_853;
    wp::float32 var_854;
    const wp::int32 var_855 = 8;
    wp::int32 var_856;
    wp::int32 var_857;
    wp::int32 var_858;
    wp::float32* var_859;
    wp::float32 var_860;
    wp::float32 var_861;
    wp::float32 var_862;
    const wp::int32 var_863 = 9;
    wp::int32 var_864;
    wp::int32 var_865;
    wp::int32 var_866;
    wp::float32* var_867;
    wp::float32 var_868;
    wp::float32 var_869;
    wp::float32 var_870;
    const wp::int32 var_871 = 10;
    wp::int32 var_872;
    wp::int32 var_873;
    wp::int32 var_874;
    wp::float32* var_875;
    wp::float32 var_876;
    wp::float32 var_877;
    wp::float32 var_878;
    const wp::int32 var_879 = 11;
    wp::int32 var_880;
    wp::int32 var_881;
    wp::int32 var_882;
    wp::float32* var_883;
    wp::float32 var_884;
    wp::float32 var_885;
    wp::float32 var_886;
    const wp::int32 var_887 = 12;
    wp::int32 var_888;
    wp::int32 var_889;
    wp::int32 var_890;
    wp::float32* var_891;
    wp::float32 var_892;
    wp::float32 var_893;
    wp::float32 var_894;
    const wp::int32 var_895 = 13;
    wp::int32 var_896;
    wp::int32 var_897;
    wp::int32 var_898;
    wp::float32* var_899;
    wp::float32 var_900;
    wp::float32 var_901;
    wp::float32 var_902;
    const wp::int32 var_903 = 14;
    wp::int32 var_904;
    wp::int32 var_905;
    wp::int32 var_906;
    wp::float32* var_907;
    wp::float32 var_908;
    wp::float32 var_909;
    wp::float32 var_910;
    const wp::int32 var_911 = 15;
    wp::int32 var_912;
    wp::int32 var_913;
    wp::int32 var_914;
    wp::float32* var_915;
    wp::float32 var_916;
    wp::float32 var_917;
    wp::float32 var_918;
    const wp::int32 var_919 = 7;
    wp::float32 var_920;
    const wp::int32 var_921 = 0;
    wp::int32 var_922;
    wp::int32 var_923;
    wp::int32 var_924;
    wp::float32* var_925;
    wp::float32 var_926;
    wp::float32 var_927;
    wp::float32 var_928;
    const wp::int32 var_929 = 1;
    wp::int32 var_930;
    wp::int32 var_931;
    wp::int32 var_932;
    wp::float32* var_933;
    wp::float32 var_934;
    wp::float32 var_935;
    wp::float32 var_936;
    const wp::int32 var_937 = 2;
    wp::int32 var_938;
    wp::int32 var_939;
    wp::int32 var_940;
    wp::float32* var_941;
    wp::float32 var_942;
    wp::float32 var_943;
    wp::float32 var_944;
    const wp::int32 var_945 = 3;
    wp::int32 var_946;
    wp::int32 var_947;
    wp::int32 var_948;
    wp::float32* var_949;
    wp::float32 var_950;
    wp::float32 var_951;
    wp::float32 var_952;
    const wp::int32 var_953 = 4;
    wp::int32 var_954;
    wp::int32 var_955;
    wp::int32 var_956;
    wp::float32* var_957;
    wp::float32 var_958;
    wp::float32 var_959;
    wp::float32 var_960;
    const wp::int32 var_961 = 5;
    wp::int32 var_962;
    wp::int32 var_963;
    wp::int32 var_964;
    wp::float32* var_965;
    wp::float32 var_966;
    wp::float32 var_967;
    wp::float32 var_968;
    const wp::int32 var_969 = 6;
    wp::int32 var_970;
    wp::int32 var_971;
    wp::int32 var_972;
    wp::float32* var_973;
    wp::float32 var_974;
    wp::float32 var_975;
    wp::float32 var_976;
    const wp::int32 var_977 = 7;
    wp::int32 var_978;
    wp::int32 var_979;
    wp::int32 var_980;
    wp::float32* var_981;
    wp::float32 var_982;
    wp::float32 var_983;
    wp::float32 var_984;
    const wp::int32 var_985 = 8;
    wp::int32 var_986;
    wp::int32 var_987;
    wp::int32 var_988;
    wp::float32* var_989;
    wp::float32 var_990;
    wp::float32 var_991;
    wp::float32 var_992;
    const wp::int32 var_993 = 9;
    wp::int32 var_994;
    wp::int32 var_995;
    wp::int32 var_996;
    wp::float32* var_997;
    wp::float32 var_998;
    wp::float32 var_999;
    wp::float32 var_1000;
    const wp::int32 var_1001 = 10;
    wp::int32 var_1002;
    wp::int32 var_1003;
    wp::int32 var_1004;
    wp::float32* var_1005;
    wp::float32 var_1006;
    wp::float32 var_1007;
    wp::float32 var_1008;
    const wp::int32 var_1009 = 11;
    wp::int32 var_1010;
    wp::int32 var_1011;
    wp::int32 var_1012;
    wp::float32* var_1013;
    wp::float32 var_1014;
    wp::float32 var_1015;
    wp::float32 var_1016;
    const wp::int32 var_1017 = 12;
    wp::int32 var_1018;
    wp::int32 var_1019;
    wp::int32 var_1020;
    wp::float32* var_1021;
    wp::float32 var_1022;
    wp::float32 var_1023;
    wp::float32 var_1024;
    const wp::int32 var_1025 = 13;
    wp::int32 var_1026;
    wp::int32 var_1027;
    wp::int32 var_1028;
    wp::float32* var_1029;
    wp::float32 var_1030;
    wp::float32 var_1031;
    wp::float32 var_1032;
    const wp::int32 var_1033 = 14;
    wp::int32 var_1034;
    wp::int32 var_1035;
    wp::int32 var_1036;
    wp::float32* var_1037;
    wp::float32 var_1038;
    wp::float32 var_1039;
    wp::float32 var_1040;
    const wp::int32 var_1041 = 15;
    wp::int32 var_1042;
    wp::int32 var_1043;
    wp::int32 var_1044;
    wp::float32* var_1045;
    wp::float32 var_1046;
    wp::float32 var_1047;
    wp::float32 var_1048;
    const wp::int32 var_1049 = 8;
    wp::float32 var_1050;
    const wp::int32 var_1051 = 0;
    wp::int32 var_1052;
    wp::int32 var_1053;
    wp::int32 var_1054;
    wp::float32* var_1055;
    wp::float32 var_1056;
    wp::float32 var_1057;
    wp::float32 var_1058;
    const wp::int32 var_1059 = 1;
    wp::int32 var_1060;
    wp::int32 var_1061;
    wp::int32 var_1062;
    wp::float32* var_1063;
    wp::float32 var_1064;
    wp::float32 var_1065;
    wp::float32 var_1066;
    const wp::int32 var_1067 = 2;
    wp::int32 var_1068;
    wp::int32 var_1069;
    wp::int32 var_1070;
    wp::float32* var_1071;
    wp::float32 var_1072;
    wp::float32 var_1073;
    wp::float32 var_1074;
    const wp::int32 var_1075 = 3;
    wp::int32 var_1076;
    wp::int32 var_1077;
    wp::int32 var_1078;
    wp::float32* var_1079;
    wp::float32 var_1080;
    wp::float32 var_1081;
    wp::float32 var_1082;
    const wp::int32 var_1083 = 4;
    wp::int32 var_1084;
    wp::int32 var_1085;
    wp::int32 var_1086;
    wp::float32* var_1087;
    wp::float32 var_1088;
    wp::float32 var_1089;
    wp::float32 var_1090;
    const wp::int32 var_1091 = 5;
    wp::int32 var_1092;
    wp::int32 var_1093;
    wp::int32 var_1094;
    wp::float32* var_1095;
    wp::float32 var_1096;
    wp::float32 var_1097;
    wp::float32 var_1098;
    const wp::int32 var_1099 = 6;
    wp::int32 var_1100;
    wp::int32 var_1101;
    wp::int32 var_1102;
    wp::float32* var_1103;
    wp::float32 var_1104;
    wp::float32 var_1105;
    wp::float32 var_1106;
    const wp::int32 var_1107 = 7;
    wp::int32 var_1108;
    wp::int32 var_1109;
    wp::int32 var_1110;
    wp::float32* var_1111;
    wp::float32 var_1112;
    wp::float32 var_1113;
    wp::float32 var_1114;
    const wp::int32 var_1115 = 8;
    wp::int32 var_1116;
    wp::int32 var_1117;
    wp::int32 var_1118;
    wp::float32* var_1119;
    wp::float32 var_1120;
    wp::float32 var_1121;
    wp::float32 var_1122;
    const wp::int32 var_1123 = 9;
    wp::int32 var_1124;
    wp::int32 var_1125;
    wp::int32 var_1126;
    wp::float32* var_1127;
    wp::float32 var_1128;
    wp::float32 var_1129;
    wp::float32 var_1130;
    const wp::int32 var_1131 = 10;
    wp::int32 var_1132;
    wp::int32 var_1133;
    wp::int32 var_1134;
    wp::float32* var_1135;
    wp::float32 var_1136;
    wp::float32 var_1137;
    wp::float32 var_1138;
    const wp::int32 var_1139 = 11;
    wp::int32 var_1140;
    wp::int32 var_1141;
    wp::int32 var_1142;
    wp::float32* var_1143;
    wp::float32 var_1144;
    wp::float32 var_1145;
    wp::float32 var_1146;
    const wp::int32 var_1147 = 12;
    wp::int32 var_1148;
    wp::int32 var_1149;
    wp::int32 var_1150;
    wp::float32* var_1151;
    wp::float32 var_1152;
    wp::float32 var_1153;
    wp::float32 var_1154;
    const wp::int32 var_1155 = 13;
    wp::int32 var_1156;
    wp::int32 var_1157;
    wp::int32 var_1158;
    wp::float32* var_1159;
    wp::float32 var_1160;
    wp::float32 var_1161;
    wp::float32 var_1162;
    const wp::int32 var_1163 = 14;
    wp::int32 var_1164;
    wp::int32 var_1165;
    wp::int32 var_1166;
    wp::float32* var_1167;
    wp::float32 var_1168;
    wp::float32 var_1169;
    wp::float32 var_1170;
    const wp::int32 var_1171 = 15;
    wp::int32 var_1172;
    wp::int32 var_1173;
    wp::int32 var_1174;
    wp::float32* var_1175;
    wp::float32 var_1176;
    wp::float32 var_1177;
    wp::float32 var_1178;
    const wp::int32 var_1179 = 9;
    wp::float32 var_1180;
    const wp::int32 var_1181 = 0;
    wp::int32 var_1182;
    wp::int32 var_1183;
    wp::int32 var_1184;
    wp::float32* var_1185;
    wp::float32 var_1186;
    wp::float32 var_1187;
    wp::float32 var_1188;
    const wp::int32 var_1189 = 1;
    wp::int32 var_1190;
    wp::int32 var_1191;
    wp::int32 var_1192;
    wp::float32* var_1193;
    wp::float32 var_1194;
    wp::float32 var_1195;
    wp::float32 var_1196;
    const wp::int32 var_1197 = 2;
    wp::int32 var_1198;
    wp::int32 var_1199;
    wp::int32 var_1200;
    wp::float32* var_1201;
    wp::float32 var_1202;
    wp::float32 var_1203;
    wp::float32 var_1204;
    const wp::int32 var_1205 = 3;
    wp::int32 var_1206;
    wp::int32 var_1207;
    wp::int32 var_1208;
    wp::float32* var_1209;
    wp::float32 var_1210;
    wp::float32 var_1211;
    wp::float32 var_1212;
    const wp::int32 var_1213 = 4;
    wp::int32 var_1214;
    wp::int32 var_1215;
    wp::int32 var_1216;
    wp::float32* var_1217;
    wp::float32 var_1218;
    wp::float32 var_1219;
    wp::float32 var_1220;
    const wp::int32 var_1221 = 5;
    wp::int32 var_1222;
    wp::int32 var_1223;
    wp::int32 var_1224;
    wp::float32* var_1225;
    wp::float32 var_1226;
    wp::float32 var_1227;
    wp::float32 var_1228;
    const wp::int32 var_1229 = 6;
    wp::int32 var_1230;
    wp::int32 var_1231;
    wp::int32 var_1232;
    wp::float32* var_1233;
    wp::float32 var_1234;
    wp::float32 var_1235;
    wp::float32 var_1236;
    const wp::int32 var_1237 = 7;
    wp::int32 var_1238;
    wp::int32 var_1239;
    wp::int32 var_1240;
    wp::float32* var_1241;
    wp::float32 var_1242;
    wp::float32 var_1243;
    wp::float32 var_1244;
    const wp::int32 var_1245 = 8;
    wp::int32 var_1246;
    wp::int32 var_1247;
    wp::int32 var_1248;
    wp::float32* var_1249;
    wp::float32 var_1250;
    wp::float32 var_1251;
    wp::float32 var_1252;
    const wp::int32 var_1253 = 9;
    wp::int32 var_1254;
    wp::int32 var_1255;
    wp::int32 var_1256;
    wp::float32* var_1257;
    wp::float32 var_1258;
    wp::float32 var_1259;
    wp::float32 var_1260;
    const wp::int32 var_1261 = 10;
    wp::int32 var_1262;
    wp::int32 var_1263;
    wp::int32 var_1264;
    wp::float32* var_1265;
    wp::float32 var_1266;
    wp::float32 var_1267;
    wp::float32 var_1268;
    const wp::int32 var_1269 = 11;
    wp::int32 var_1270;
    wp::int32 var_1271;
    wp::int32 var_1272;
    wp::float32* var_1273;
    wp::float32 var_1274;
    wp::float32 var_1275;
    wp::float32 var_1276;
    const wp::int32 var_1277 = 12;
    wp::int32 var_1278;
    wp::int32 var_1279;
    wp::int32 var_1280;
    wp::float32* var_1281;
    wp::float32 var_1282;
    wp::float32 var_1283;
    wp::float32 var_1284;
    const wp::int32 var_1285 = 13;
    wp::int32 var_1286;
    wp::int32 var_1287;
    wp::int32 var_1288;
    wp::float32* var_1289;
    wp::float32 var_1290;
    wp::float32 var_1291;
    wp::float32 var_1292;
    const wp::int32 var_1293 = 14;
    wp::int32 var_1294;
    wp::int32 var_1295;
    wp::int32 var_1296;
    wp::float32* var_1297;
    wp::float32 var_1298;
    wp::float32 var_1299;
    wp::float32 var_1300;
    const wp::int32 var_1301 = 15;
    wp::int32 var_1302;
    wp::int32 var_1303;
    wp::int32 var_1304;
    wp::float32* var_1305;
    wp::float32 var_1306;
    wp::float32 var_1307;
    wp::float32 var_1308;
    const wp::int32 var_1309 = 10;
    wp::float32 var_1310;
    const wp::int32 var_1311 = 0;
    wp::int32 var_1312;
    wp::int32 var_1313;
    wp::int32 var_1314;
    wp::float32* var_1315;
    wp::float32 var_1316;
    wp::float32 var_1317;
    wp::float32 var_1318;
    const wp::int32 var_1319 = 1;
    wp::int32 var_1320;
    wp::int32 var_1321;
    wp::int32 var_1322;
    wp::float32* var_1323;
    wp::float32 var_1324;
    wp::float32 var_1325;
    wp::float32 var_1326;
    const wp::int32 var_1327 = 2;
    wp::int32 var_1328;
    wp::int32 var_1329;
    wp::int32 var_1330;
    wp::float32* var_1331;
    wp::float32 var_1332;
    wp::float32 var_1333;
    wp::float32 var_1334;
    const wp::int32 var_1335 = 3;
    wp::int32 var_1336;
    wp::int32 var_1337;
    wp::int32 var_1338;
    wp::float32* var_1339;
    wp::float32 var_1340;
    wp::float32 var_1341;
    wp::float32 var_1342;
    const wp::int32 var_1343 = 4;
    wp::int32 var_1344;
    wp::int32 var_1345;
    wp::int32 var_1346;
    wp::float32* var_1347;
    wp::float32 var_1348;
    wp::float32 var_1349;
    wp::float32 var_1350;
    const wp::int32 var_1351 = 5;
    wp::int32 var_1352;
    wp::int32 var_1353;
    wp::int32 var_1354;
    wp::float32* var_1355;
    wp::float32 var_1356;
    wp::float32 var_1357;
    wp::float32 var_1358;
    const wp::int32 var_1359 = 6;
    wp::int32 var_1360;
    wp::int32 var_1361;
    wp::int32 var_1362;
    wp::float32* var_1363;
    wp::float32 var_1364;
    wp::float32 var_1365;
    wp::float32 var_1366;
    const wp::int32 var_1367 = 7;
    wp::int32 var_1368;
    wp::int32 var_1369;
    wp::int32 var_1370;
    wp::float32* var_1371;
    wp::float32 var_1372;
    wp::float32 var_1373;
    wp::float32 var_1374;
    const wp::int32 var_1375 = 8;
    wp::int32 var_1376;
    wp::int32 var_1377;
    wp::int32 var_1378;
    wp::float32* var_1379;
    wp::float32 var_1380;
    wp::float32 var_1381;
    wp::float32 var_1382;
    const wp::int32 var_1383 = 9;
    wp::int32 var_1384;
    wp::int32 var_1385;
    wp::int32 var_1386;
    wp::float32* var_1387;
    wp::float32 var_1388;
    wp::float32 var_1389;
    wp::float32 var_1390;
    const wp::int32 var_1391 = 10;
    wp::int32 var_1392;
    wp::int32 var_1393;
    wp::int32 var_1394;
    wp::float32* var_1395;
    wp::float32 var_1396;
    wp::float32 var_1397;
    wp::float32 var_1398;
    const wp::int32 var_1399 = 11;
    wp::int32 var_1400;
    wp::int32 var_1401;
    wp::int32 var_1402;
    wp::float32* var_1403;
    wp::float32 var_1404;
    wp::float32 var_1405;
    wp::float32 var_1406;
    const wp::int32 var_1407 = 12;
    wp::int32 var_1408;
    wp::int32 var_1409;
    wp::int32 var_1410;
    wp::float32* var_1411;
    wp::float32 var_1412;
    wp::float32 var_1413;
    wp::float32 var_1414;
    const wp::int32 var_1415 = 13;
    wp::int32 var_1416;
    wp::int32 var_1417;
    wp::int32 var_1418;
    wp::float32* var_1419;
    wp::float32 var_1420;
    wp::float32 var_1421;
    wp::float32 var_1422;
    const wp::int32 var_1423 = 14;
    wp::int32 var_1424;
    wp::int32 var_1425;
    wp::int32 var_1426;
    wp::float32* var_1427;
    wp::float32 var_1428;
    wp::float32 var_1429;
    wp::float32 var_1430;
    const wp::int32 var_1431 = 15;
    wp::int32 var_1432;
    wp::int32 var_1433;
    wp::int32 var_1434;
    wp::float32* var_1435;
    wp::float32 var_1436;
    wp::float32 var_1437;
    wp::float32 var_1438;
    const wp::int32 var_1439 = 11;
    wp::float32 var_1440;
    const wp::int32 var_1441 = 0;
    wp::int32 var_1442;
    wp::int32 var_1443;
    wp::int32 var_1444;
    wp::float32* var_1445;
    wp::float32 var_1446;
    wp::float32 var_1447;
    wp::float32 var_1448;
    const wp::int32 var_1449 = 1;
    wp::int32 var_1450;
    wp::int32 var_1451;
    wp::int32 var_1452;
    wp::float32* var_1453;
    wp::float32 var_1454;
    wp::float32 var_1455;
    wp::float32 var_1456;
    const wp::int32 var_1457 = 2;
    wp::int32 var_1458;
    wp::int32 var_1459;
    wp::int32 var_1460;
    wp::float32* var_1461;
    wp::float32 var_1462;
    wp::float32 var_1463;
    wp::float32 var_1464;
    const wp::int32 var_1465 = 3;
    wp::int32 var_1466;
    wp::int32 var_1467;
    wp::int32 var_1468;
    wp::float32* var_1469;
    wp::float32 var_1470;
    wp::float32 var_1471;
    wp::float32 var_1472;
    const wp::int32 var_1473 = 4;
    wp::int32 var_1474;
    wp::int32 var_1475;
    wp::int32 var_1476;
    wp::float32* var_1477;
    wp::float32 var_1478;
    wp::float32 var_1479;
    wp::float32 var_1480;
    const wp::int32 var_1481 = 5;
    wp::int32 var_1482;
    wp::int32 var_1483;
    wp::int32 var_1484;
    wp::float32* var_1485;
    wp::float32 var_1486;
    wp::float32 var_1487;
    wp::float32 var_1488;
    const wp::int32 var_1489 = 6;
    wp::int32 var_1490;
    wp::int32 var_1491;
    wp::int32 var_1492;
    wp::float32* var_1493;
    wp::float32 var_1494;
    wp::float32 var_1495;
    wp::float32 var_1496;
    const wp::int32 var_1497 = 7;
    wp::int32 var_1498;
    wp::int32 var_1499;
    wp::int32 var_1500;
    wp::float32* var_1501;
    wp::float32 var_1502;
    wp::float32 var_1503;
    wp::float32 var_1504;
    const wp::int32 var_1505 = 8;
    wp::int32 var_1506;
    wp::int32 var_1507;
    wp::int32 var_1508;
    wp::float32* var_1509;
    wp::float32 var_1510;
    wp::float32 var_1511;
    wp::float32 var_1512;
    const wp::int32 var_1513 = 9;
    wp::int32 var_1514;
    wp::int32 var_1515;
    wp::int32 var_1516;
    wp::float32* var_1517;
    wp::float32 var_1518;
    wp::float32 var_1519;
    wp::float32 var_1520;
    const wp::int32 var_1521 = 10;
    wp::int32 var_1522;
    wp::int32 var_1523;
    wp::int32 var_1524;
    wp::float32* var_1525;
    wp::float32 var_1526;
    wp::float32 var_1527;
    wp::float32 var_1528;
    const wp::int32 var_1529 = 11;
    wp::int32 var_1530;
    wp::int32 var_1531;
    wp::int32 var_1532;
    wp::float32* var_1533;
    wp::float32 var_1534;
    wp::float32 var_1535;
    wp::float32 var_1536;
    const wp::int32 var_1537 = 12;
    wp::int32 var_1538;
    wp::int32 var_1539;
    wp::int32 var_1540;
    wp::float32* var_1541;
    wp::float32 var_1542;
    wp::float32 var_1543;
    wp::float32 var_1544;
    const wp::int32 var_1545 = 13;
    wp::int32 var_1546;
    wp::int32 var_1547;
    wp::int32 var_1548;
    wp::float32* var_1549;
    wp::float32 var_1550;
    wp::float32 var_1551;
    wp::float32 var_1552;
    const wp::int32 var_1553 = 14;
    wp::int32 var_1554;
    wp::int32 var_1555;
    wp::int32 var_1556;
    wp::float32* var_1557;
    wp::float32 var_1558;
    wp::float32 var_1559;
    wp::float32 var_1560;
    const wp::int32 var_1561 = 15;
    wp::int32 var_1562;
    wp::int32 var_1563;
    wp::int32 var_1564;
    wp::float32* var_1565;
    wp::float32 var_1566;
    wp::float32 var_1567;
    wp::float32 var_1568;
    const wp::int32 var_1569 = 12;
    wp::float32 var_1570;
    const wp::int32 var_1571 = 0;
    wp::int32 var_1572;
    wp::int32 var_1573;
    wp::int32 var_1574;
    wp::float32* var_1575;
    wp::float32 var_1576;
    wp::float32 var_1577;
    wp::float32 var_1578;
    const wp::int32 var_1579 = 1;
    wp::int32 var_1580;
    wp::int32 var_1581;
    wp::int32 var_1582;
    wp::float32* var_1583;
    wp::float32 var_1584;
    wp::float32 var_1585;
    wp::float32 var_1586;
    const wp::int32 var_1587 = 2;
    wp::int32 var_1588;
    wp::int32 var_1589;
    wp::int32 var_1590;
    wp::float32* var_1591;
    wp::float32 var_1592;
    wp::float32 var_1593;
    wp::float32 var_1594;
    const wp::int32 var_1595 = 3;
    wp::int32 var_1596;
    wp::int32 var_1597;
    wp::int32 var_1598;
    wp::float32* var_1599;
    wp::float32 var_1600;
    wp::float32 var_1601;
    wp::float32 var_1602;
    const wp::int32 var_1603 = 4;
    wp::int32 var_1604;
    wp::int32 var_1605;
    wp::int32 var_1606;
    wp::float32* var_1607;
    wp::float32 var_1608;
    wp::float32 var_1609;
    wp::float32 var_1610;
    const wp::int32 var_1611 = 5;
    wp::int32 var_1612;
    wp::int32 var_1613;
    wp::int32 var_1614;
    wp::float32* var_1615;
    wp::float32 var_1616;
    wp::float32 var_1617;
    wp::float32 var_1618;
    const wp::int32 var_1619 = 6;
    wp::int32 var_1620;
    wp::int32 var_1621;
    wp::int32 var_1622;
    wp::float32* var_1623;
    wp::float32 var_1624;
    wp::float32 var_1625;
    wp::float32 var_1626;
    const wp::int32 var_1627 = 7;
    wp::int32 var_1628;
    wp::int32 var_1629;
    wp::int32 var_1630;
    wp::float32* var_1631;
    wp::float32 var_1632;
    wp::float32 var_1633;
    wp::float32 var_1634;
    const wp::int32 var_1635 = 8;
    wp::int32 var_1636;
    wp::int32 var_1637;
    wp::int32 var_1638;
    wp::float32* var_1639;
    wp::float32 var_1640;
    wp::float32 var_1641;
    wp::float32 var_1642;
    const wp::int32 var_1643 = 9;
    wp::int32 var_1644;
    wp::int32 var_1645;
    wp::int32 var_1646;
    wp::float32* var_1647;
    wp::float32 var_1648;
    wp::float32 var_1649;
    wp::float32 var_1650;
    const wp::int32 var_1651 = 10;
    wp::int32 var_1652;
    wp::int32 var_1653;
    wp::int32 var_1654;
    wp::float32* var_1655;
    wp::float32 var_1656;
    wp::float32 var_1657;
    wp::float32 var_1658;
    const wp::int32 var_1659 = 11;
    wp::int32 var_1660;
    wp::int32 var_1661;
    wp::int32 var_1662;
    wp::float32* var_1663;
    wp::float32 var_1664;
    wp::float32 var_1665;
    wp::float32 var_1666;
    const wp::int32 var_1667 = 12;
    wp::int32 var_1668;
    wp::int32 var_1669;
    wp::int32 var_1670;
    wp::float32* var_1671;
    wp::float32 var_1672;
    wp::float32 var_1673;
    wp::float32 var_1674;
    const wp::int32 var_1675 = 13;
    wp::int32 var_1676;
    wp::int32 var_1677;
    wp::int32 var_1678;
    wp::float32* var_1679;
    wp::float32 var_1680;
    wp::float32 var_1681;
    wp::float32 var_1682;
    const wp::int32 var_1683 = 14;
    wp::int32 var_1684;
    wp::int32 var_1685;
    wp::int32 var_1686;
    wp::float32* var_1687;
    wp::float32 var_1688;
    wp::float32 var_1689;
    wp::float32 var_1690;
    const wp::int32 var_1691 = 15;
    wp::int32 var_1692;
    wp::int32 var_1693;
    wp::int32 var_1694;
    wp::float32* var_1695;
    wp::float32 var_1696;
    wp::float32 var_1697;
    wp::float32 var_1698;
    const wp::int32 var_1699 = 13;
    wp::float32 var_1700;
    const wp::int32 var_1701 = 0;
    wp::int32 var_1702;
    wp::int32 var_1703;
    wp::int32 var_1704;
    wp::float32* var_1705;
    wp::float32 var_1706;
    wp::float32 var_1707;
    wp::float32 var_1708;
    const wp::int32 var_1709 = 1;
    wp::int32 var_1710;
    wp::int32 var_1711;
    wp::int32 var_1712;
    wp::float32* var_1713;
    wp::float32 var_1714;
    wp::float32 var_1715;
    wp::float32 var_1716;
    const wp::int32 var_1717 = 2;
    wp::int32 var_1718;
    wp::int32 var_1719;
    wp::int32 var_1720;
    wp::float32* var_1721;
    wp::float32 var_1722;
    wp::float32 var_1723;
    wp::float32 var_1724;
    const wp::int32 var_1725 = 3;
    wp::int32 var_1726;
    wp::int32 var_1727;
    wp::int32 var_1728;
    wp::float32* var_1729;
    wp::float32 var_1730;
    wp::float32 var_1731;
    wp::float32 var_1732;
    const wp::int32 var_1733 = 4;
    wp::int32 var_1734;
    wp::int32 var_1735;
    wp::int32 var_1736;
    wp::float32* var_1737;
    wp::float32 var_1738;
    wp::float32 var_1739;
    wp::float32 var_1740;
    const wp::int32 var_1741 = 5;
    wp::int32 var_1742;
    wp::int32 var_1743;
    wp::int32 var_1744;
    wp::float32* var_1745;
    wp::float32 var_1746;
    wp::float32 var_1747;
    wp::float32 var_1748;
    const wp::int32 var_1749 = 6;
    wp::int32 var_1750;
    wp::int32 var_1751;
    wp::int32 var_1752;
    wp::float32* var_1753;
    wp::float32 var_1754;
    wp::float32 var_1755;
    wp::float32 var_1756;
    const wp::int32 var_1757 = 7;
    wp::int32 var_1758;
    wp::int32 var_1759;
    wp::int32 var_1760;
    wp::float32* var_1761;
    wp::float32 var_1762;
    wp::float32 var_1763;
    wp::float32 var_1764;
    const wp::int32 var_1765 = 8;
    wp::int32 var_1766;
    wp::int32 var_1767;
    wp::int32 var_1768;
    wp::float32* var_1769;
    wp::float32 var_1770;
    wp::float32 var_1771;
    wp::float32 var_1772;
    const wp::int32 var_1773 = 9;
    wp::int32 var_1774;
    wp::int32 var_1775;
    wp::int32 var_1776;
    wp::float32* var_1777;
    wp::float32 var_1778;
    wp::float32 var_1779;
    wp::float32 var_1780;
    const wp::int32 var_1781 = 10;
    wp::int32 var_1782;
    wp::int32 var_1783;
    wp::int32 var_1784;
    wp::float32* var_1785;
    wp::float32 var_1786;
    wp::float32 var_1787;
    wp::float32 var_1788;
    const wp::int32 var_1789 = 11;
    wp::int32 var_1790;
    wp::int32 var_1791;
    wp::int32 var_1792;
    wp::float32* var_1793;
    wp::float32 var_1794;
    wp::float32 var_1795;
    wp::float32 var_1796;
    const wp::int32 var_1797 = 12;
    wp::int32 var_1798;
    wp::int32 var_1799;
    wp::int32 var_1800;
    wp::float32* var_1801;
    wp::float32 var_1802;
    wp::float32 var_1803;
    wp::float32 var_1804;
    const wp::int32 var_1805 = 13;
    wp::int32 var_1806;
    wp::int32 var_1807;
    wp::int32 var_1808;
    wp::float32* var_1809;
    wp::float32 var_1810;
    wp::float32 var_1811;
    wp::float32 var_1812;
    const wp::int32 var_1813 = 14;
    wp::int32 var_1814;
    wp::int32 var_1815;
    wp::int32 var_1816;
    wp::float32* var_1817;
    wp::float32 var_1818;
    wp::float32 var_1819;
    wp::float32 var_1820;
    const wp::int32 var_1821 = 15;
    wp::int32 var_1822;
    wp::int32 var_1823;
    wp::int32 var_1824;
    wp::float32* var_1825;
    wp::float32 var_1826;
    wp::float32 var_1827;
    wp::float32 var_1828;
    const wp::int32 var_1829 = 14;
    wp::float32 var_1830;
    const wp::int32 var_1831 = 0;
    wp::int32 var_1832;
    wp::int32 var_1833;
    wp::int32 var_1834;
    wp::float32* var_1835;
    wp::float32 var_1836;
    wp::float32 var_1837;
    wp::float32 var_1838;
    const wp::int32 var_1839 = 1;
    wp::int32 var_1840;
    wp::int32 var_1841;
    wp::int32 var_1842;
    wp::float32* var_1843;
    wp::float32 var_1844;
    wp::float32 var_1845;
    wp::float32 var_1846;
    const wp::int32 var_1847 = 2;
    wp::int32 var_1848;
    wp::int32 var_1849;
    wp::int32 var_1850;
    wp::float32* var_1851;
    wp::float32 var_1852;
    wp::float32 var_1853;
    wp::float32 var_1854;
    const wp::int32 var_1855 = 3;
    wp::int32 var_1856;
    wp::int32 var_1857;
    wp::int32 var_1858;
    wp::float32* var_1859;
    wp::float32 var_1860;
    wp::float32 var_1861;
    wp::float32 var_1862;
    const wp::int32 var_1863 = 4;
    wp::int32 var_1864;
    wp::int32 var_1865;
    wp::int32 var_1866;
    wp::float32* var_1867;
    wp::float32 var_1868;
    wp::float32 var_1869;
    wp::float32 var_1870;
    const wp::int32 var_1871 = 5;
    wp::int32 var_1872;
    wp::int32 var_1873;
    wp::int32 var_1874;
    wp::float32* var_1875;
    wp::float32 var_1876;
    wp::float32 var_1877;
    wp::float32 var_1878;
    const wp::int32 var_1879 = 6;
    wp::int32 var_1880;
    wp::int32 var_1881;
    wp::int32 var_1882;
    wp::float32* var_1883;
    wp::float32 var_1884;
    wp::float32 var_1885;
    wp::float32 var_1886;
    const wp::int32 var_1887 = 7;
    wp::int32 var_1888;
    wp::int32 var_1889;
    wp::int32 var_1890;
    wp::float32* var_1891;
    wp::float32 var_1892;
    wp::float32 var_1893;
    wp::float32 var_1894;
    const wp::int32 var_1895 = 8;
    wp::int32 var_1896;
    wp::int32 var_1897;
    wp::int32 var_1898;
    wp::float32* var_1899;
    wp::float32 var_1900;
    wp::float32 var_1901;
    wp::float32 var_1902;
    const wp::int32 var_1903 = 9;
    wp::int32 var_1904;
    wp::int32 var_1905;
    wp::int32 var_1906;
    wp::float32* var_1907;
    wp::float32 var_1908;
    wp::float32 var_1909;
    wp::float32 var_1910;
    const wp::int32 var_1911 = 10;
    wp::int32 var_1912;
    wp::int32 var_1913;
    wp::int32 var_1914;
    wp::float32* var_1915;
    wp::float32 var_1916;
    wp::float32 var_1917;
    wp::float32 var_1918;
    const wp::int32 var_1919 = 11;
    wp::int32 var_1920;
    wp::int32 var_1921;
    wp::int32 var_1922;
    wp::float32* var_1923;
    wp::float32 var_1924;
    wp::float32 var_1925;
    wp::float32 var_1926;
    const wp::int32 var_1927 = 12;
    wp::int32 var_1928;
    wp::int32 var_1929;
    wp::int32 var_1930;
    wp::float32* var_1931;
    wp::float32 var_1932;
    wp::float32 var_1933;
    wp::float32 var_1934;
    const wp::int32 var_1935 = 13;
    wp::int32 var_1936;
    wp::int32 var_1937;
    wp::int32 var_1938;
    wp::float32* var_1939;
    wp::float32 var_1940;
    wp::float32 var_1941;
    wp::float32 var_1942;
    const wp::int32 var_1943 = 14;
    wp::int32 var_1944;
    wp::int32 var_1945;
    wp::int32 var_1946;
    wp::float32* var_1947;
    wp::float32 var_1948;
    wp::float32 var_1949;
    wp::float32 var_1950;
    const wp::int32 var_1951 = 15;
    wp::int32 var_1952;
    wp::int32 var_1953;
    wp::int32 var_1954;
    wp::float32* var_1955;
    wp::float32 var_1956;
    wp::float32 var_1957;
    wp::float32 var_1958;
    const wp::int32 var_1959 = 15;
    wp::float32 var_1960;
    const wp::int32 var_1961 = 0;
    wp::int32 var_1962;
    wp::int32 var_1963;
    wp::int32 var_1964;
    wp::float32* var_1965;
    wp::float32 var_1966;
    wp::float32 var_1967;
    wp::float32 var_1968;
    const wp::int32 var_1969 = 1;
    wp::int32 var_1970;
    wp::int32 var_1971;
    wp::int32 var_1972;
    wp::float32* var_1973;
    wp::float32 var_1974;
    wp::float32 var_1975;
    wp::float32 var_1976;
    const wp::int32 var_1977 = 2;
    wp::int32 var_1978;
    wp::int32 var_1979;
    wp::int32 var_1980;
    wp::float32* var_1981;
    wp::float32 var_1982;
    wp::float32 var_1983;
    wp::float32 var_1984;
    const wp::int32 var_1985 = 3;
    wp::int32 var_1986;
    wp::int32 var_1987;
    wp::int32 var_1988;
    wp::float32* var_1989;
    wp::float32 var_1990;
    wp::float32 var_1991;
    wp::float32 var_1992;
    const wp::int32 var_1993 = 4;
    wp::int32 var_1994;
    wp::int32 var_1995;
    wp::int32 var_1996;
    wp::float32* var_1997;
    wp::float32 var_1998;
    wp::float32 var_1999;
    wp::float32 var_2000;
    const wp::int32 var_2001 = 5;
    wp::int32 var_2002;
    wp::int32 var_2003;
    wp::int32 var_2004;
    wp::float32* var_2005;
    wp::float32 var_2006;
    wp::float32 var_2007;
    wp::float32 var_2008;
    const wp::int32 var_2009 = 6;
    wp::int32 var_2010;
    wp::int32 var_2011;
    wp::int32 var_2012;
    wp::float32* var_2013;
    wp::float32 var_2014;
    wp::float32 var_2015;
    wp::float32 var_2016;
    const wp::int32 var_2017 = 7;
    wp::int32 var_2018;
    wp::int32 var_2019;
    wp::int32 var_2020;
    wp::float32* var_2021;
    wp::float32 var_2022;
    wp::float32 var_2023;
    wp::float32 var_2024;
    const wp::int32 var_2025 = 8;
    wp::int32 var_2026;
    wp::int32 var_2027;
    wp::int32 var_2028;
    wp::float32* var_2029;
    wp::float32 var_2030;
    wp::float32 var_2031;
    wp::float32 var_2032;
    const wp::int32 var_2033 = 9;
    wp::int32 var_2034;
    wp::int32 var_2035;
    wp::int32 var_2036;
    wp::float32* var_2037;
    wp::float32 var_2038;
    wp::float32 var_2039;
    wp::float32 var_2040;
    const wp::int32 var_2041 = 10;
    wp::int32 var_2042;
    wp::int32 var_2043;
    wp::int32 var_2044;
    wp::float32* var_2045;
    wp::float32 var_2046;
    wp::float32 var_2047;
    wp::float32 var_2048;
    const wp::int32 var_2049 = 11;
    wp::int32 var_2050;
    wp::int32 var_2051;
    wp::int32 var_2052;
    wp::float32* var_2053;
    wp::float32 var_2054;
    wp::float32 var_2055;
    wp::float32 var_2056;
    const wp::int32 var_2057 = 12;
    wp::int32 var_2058;
    wp::int32 var_2059;
    wp::int32 var_2060;
    wp::float32* var_2061;
    wp::float32 var_2062;
    wp::float32 var_2063;
    wp::float32 var_2064;
    const wp::int32 var_2065 = 13;
    wp::int32 var_2066;
    wp::int32 var_2067;
    wp::int32 var_2068;
    wp::float32* var_2069;
    wp::float32 var_2070;
    wp::float32 var_2071;
    wp::float32 var_2072;
    const wp::int32 var_2073 = 14;
    wp::int32 var_2074;
    wp::int32 var_2075;
    wp::int32 var_2076;
    wp::float32* var_2077;
    wp::float32 var_2078;
    wp::float32 var_2079;
    wp::float32 var_2080;
    const wp::int32 var_2081 = 15;
    wp::int32 var_2082;
    wp::int32 var_2083;
    wp::int32 var_2084;
    wp::float32* var_2085;
    wp::float32 var_2086;
    wp::float32 var_2087;
    wp::float32 var_2088;
    wp::int32 var_2089;
    wp::int32 var_2090;
    wp::float32 var_2091;
    wp::int32 var_2092;
    wp::float32 var_2093;
    wp::int32 var_2094;
    //---------
    // forward
    // def rows_within(group: int, grouped: array(dtype=float32), y: axes, limit: float) -> int:       <L 106>
    // at = group * AXES * GROUP                                                              <L 108>
    var_1 = wp::mul(var_group, var_0);
    var_3 = wp::mul(var_1, var_2);
    // sqdists = lanes(0.0)                                                                   <L 109>
    var_5 = wp::vec_t<16, wp::float32>(var_4);
    // for k in range(BOXED):                                                                 <L 110>
    // x = y[k]                                                                               <L 111>
    var_7 = wp::extract(var_y, var_6);
    // for j in range(GROUP):                                                                 <L 112>
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_9 = wp::mul(var_6, var_2);
    var_10 = wp::add(var_3, var_9);
    var_11 = wp::add(var_10, var_8);
    var_12 = wp::address(var_grouped, var_11);
    var_14 = wp::load(var_12);
    var_13 = wp::sub(var_14, var_7);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_15 = wp::mul(var_13, var_13);
    wp::add_inplace(var_5, var_8, var_15);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_17 = wp::mul(var_6, var_2);
    var_18 = wp::add(var_3, var_17);
    var_19 = wp::add(var_18, var_16);
    var_20 = wp::address(var_grouped, var_19);
    var_22 = wp::load(var_20);
    var_21 = wp::sub(var_22, var_7);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_23 = wp::mul(var_21, var_21);
    wp::add_inplace(var_5, var_16, var_23);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_25 = wp::mul(var_6, var_2);
    var_26 = wp::add(var_3, var_25);
    var_27 = wp::add(var_26, var_24);
    var_28 = wp::address(var_grouped, var_27);
    var_30 = wp::load(var_28);
    var_29 = wp::sub(var_30, var_7);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_31 = wp::mul(var_29, var_29);
    wp::add_inplace(var_5, var_24, var_31);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_33 = wp::mul(var_6, var_2);
    var_34 = wp::add(var_3, var_33);
    var_35 = wp::add(var_34, var_32);
    var_36 = wp::address(var_grouped, var_35);
    var_38 = wp::load(var_36);
    var_37 = wp::sub(var_38, var_7);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_39 = wp::mul(var_37, var_37);
    wp::add_inplace(var_5, var_32, var_39);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_41 = wp::mul(var_6, var_2);
    var_42 = wp::add(var_3, var_41);
    var_43 = wp::add(var_42, var_40);
    var_44 = wp::address(var_grouped, var_43);
    var_46 = wp::load(var_44);
    var_45 = wp::sub(var_46, var_7);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_47 = wp::mul(var_45, var_45);
    wp::add_inplace(var_5, var_40, var_47);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_49 = wp::mul(var_6, var_2);
    var_50 = wp::add(var_3, var_49);
    var_51 = wp::add(var_50, var_48);
    var_52 = wp::address(var_grouped, var_51);
    var_54 = wp::load(var_52);
    var_53 = wp::sub(var_54, var_7);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_55 = wp::mul(var_53, var_53);
    wp::add_inplace(var_5, var_48, var_55);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_57 = wp::mul(var_6, var_2);
    var_58 = wp::add(var_3, var_57);
    var_59 = wp::add(var_58, var_56);
    var_60 = wp::address(var_grouped, var_59);
    var_62 = wp::load(var_60);
    var_61 = wp::sub(var_62, var_7);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_63 = wp::mul(var_61, var_61);
    wp::add_inplace(var_5, var_56, var_63);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_65 = wp::mul(var_6, var_2);
    var_66 = wp::add(var_3, var_65);
    var_67 = wp::add(var_66, var_64);
    var_68 = wp::address(var_grouped, var_67);
    var_70 = wp::load(var_68);
    var_69 = wp::sub(var_70, var_7);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_71 = wp::mul(var_69, var_69);
    wp::add_inplace(var_5, var_64, var_71);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_73 = wp::mul(var_6, var_2);
    var_74 = wp::add(var_3, var_73);
    var_75 = wp::add(var_74, var_72);
    var_76 = wp::address(var_grouped, var_75);
    var_78 = wp::load(var_76);
    var_77 = wp::sub(var_78, var_7);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_79 = wp::mul(var_77, var_77);
    wp::add_inplace(var_5, var_72, var_79);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_81 = wp::mul(var_6, var_2);
    var_82 = wp::add(var_3, var_81);
    var_83 = wp::add(var_82, var_80);
    var_84 = wp::address(var_grouped, var_83);
    var_86 = wp::load(var_84);
    var_85 = wp::sub(var_86, var_7);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_87 = wp::mul(var_85, var_85);
    wp::add_inplace(var_5, var_80, var_87);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_89 = wp::mul(var_6, var_2);
    var_90 = wp::add(var_3, var_89);
    var_91 = wp::add(var_90, var_88);
    var_92 = wp::address(var_grouped, var_91);
    var_94 = wp::load(var_92);
    var_93 = wp::sub(var_94, var_7);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_95 = wp::mul(var_93, var_93);
    wp::add_inplace(var_5, var_88, var_95);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_97 = wp::mul(var_6, var_2);
    var_98 = wp::add(var_3, var_97);
    var_99 = wp::add(var_98, var_96);
    var_100 = wp::address(var_grouped, var_99);
    var_102 = wp::load(var_100);
    var_101 = wp::sub(var_102, var_7);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_103 = wp::mul(var_101, var_101);
    wp::add_inplace(var_5, var_96, var_103);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_105 = wp::mul(var_6, var_2);
    var_106 = wp::add(var_3, var_105);
    var_107 = wp::add(var_106, var_104);
    var_108 = wp::address(var_grouped, var_107);
    var_110 = wp::load(var_108);
    var_109 = wp::sub(var_110, var_7);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_111 = wp::mul(var_109, var_109);
    wp::add_inplace(var_5, var_104, var_111);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_113 = wp::mul(var_6, var_2);
    var_114 = wp::add(var_3, var_113);
    var_115 = wp::add(var_114, var_112);
    var_116 = wp::address(var_grouped, var_115);
    var_118 = wp::load(var_116);
    var_117 = wp::sub(var_118, var_7);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_119 = wp::mul(var_117, var_117);
    wp::add_inplace(var_5, var_112, var_119);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_121 = wp::mul(var_6, var_2);
    var_122 = wp::add(var_3, var_121);
    var_123 = wp::add(var_122, var_120);
    var_124 = wp::address(var_grouped, var_123);
    var_126 = wp::load(var_124);
    var_125 = wp::sub(var_126, var_7);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_127 = wp::mul(var_125, var_125);
    wp::add_inplace(var_5, var_120, var_127);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_129 = wp::mul(var_6, var_2);
    var_130 = wp::add(var_3, var_129);
    var_131 = wp::add(var_130, var_128);
    var_132 = wp::address(var_grouped, var_131);
    var_134 = wp::load(var_132);
    var_133 = wp::sub(var_134, var_7);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_135 = wp::mul(var_133, var_133);
    wp::add_inplace(var_5, var_128, var_135);
    // x = y[k]                                                                               <L 111>
    var_137 = wp::extract(var_y, var_136);
    // for j in range(GROUP):                                                                 <L 112>
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_139 = wp::mul(var_136, var_2);
    var_140 = wp::add(var_3, var_139);
    var_141 = wp::add(var_140, var_138);
    var_142 = wp::address(var_grouped, var_141);
    var_144 = wp::load(var_142);
    var_143 = wp::sub(var_144, var_137);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_145 = wp::mul(var_143, var_143);
    wp::add_inplace(var_5, var_138, var_145);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_147 = wp::mul(var_136, var_2);
    var_148 = wp::add(var_3, var_147);
    var_149 = wp::add(var_148, var_146);
    var_150 = wp::address(var_grouped, var_149);
    var_152 = wp::load(var_150);
    var_151 = wp::sub(var_152, var_137);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_153 = wp::mul(var_151, var_151);
    wp::add_inplace(var_5, var_146, var_153);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_155 = wp::mul(var_136, var_2);
    var_156 = wp::add(var_3, var_155);
    var_157 = wp::add(var_156, var_154);
    var_158 = wp::address(var_grouped, var_157);
    var_160 = wp::load(var_158);
    var_159 = wp::sub(var_160, var_137);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_161 = wp::mul(var_159, var_159);
    wp::add_inplace(var_5, var_154, var_161);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_163 = wp::mul(var_136, var_2);
    var_164 = wp::add(var_3, var_163);
    var_165 = wp::add(var_164, var_162);
    var_166 = wp::address(var_grouped, var_165);
    var_168 = wp::load(var_166);
    var_167 = wp::sub(var_168, var_137);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_169 = wp::mul(var_167, var_167);
    wp::add_inplace(var_5, var_162, var_169);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_171 = wp::mul(var_136, var_2);
    var_172 = wp::add(var_3, var_171);
    var_173 = wp::add(var_172, var_170);
    var_174 = wp::address(var_grouped, var_173);
    var_176 = wp::load(var_174);
    var_175 = wp::sub(var_176, var_137);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_177 = wp::mul(var_175, var_175);
    wp::add_inplace(var_5, var_170, var_177);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_179 = wp::mul(var_136, var_2);
    var_180 = wp::add(var_3, var_179);
    var_181 = wp::add(var_180, var_178);
    var_182 = wp::address(var_grouped, var_181);
    var_184 = wp::load(var_182);
    var_183 = wp::sub(var_184, var_137);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_185 = wp::mul(var_183, var_183);
    wp::add_inplace(var_5, var_178, var_185);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_187 = wp::mul(var_136, var_2);
    var_188 = wp::add(var_3, var_187);
    var_189 = wp::add(var_188, var_186);
    var_190 = wp::address(var_grouped, var_189);
    var_192 = wp::load(var_190);
    var_191 = wp::sub(var_192, var_137);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_193 = wp::mul(var_191, var_191);
    wp::add_inplace(var_5, var_186, var_193);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_195 = wp::mul(var_136, var_2);
    var_196 = wp::add(var_3, var_195);
    var_197 = wp::add(var_196, var_194);
    var_198 = wp::address(var_grouped, var_197);
    var_200 = wp::load(var_198);
    var_199 = wp::sub(var_200, var_137);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_201 = wp::mul(var_199, var_199);
    wp::add_inplace(var_5, var_194, var_201);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_203 = wp::mul(var_136, var_2);
    var_204 = wp::add(var_3, var_203);
    var_205 = wp::add(var_204, var_202);
    var_206 = wp::address(var_grouped, var_205);
    var_208 = wp::load(var_206);
    var_207 = wp::sub(var_208, var_137);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_209 = wp::mul(var_207, var_207);
    wp::add_inplace(var_5, var_202, var_209);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_211 = wp::mul(var_136, var_2);
    var_212 = wp::add(var_3, var_211);
    var_213 = wp::add(var_212, var_210);
    var_214 = wp::address(var_grouped, var_213);
    var_216 = wp::load(var_214);
    var_215 = wp::sub(var_216, var_137);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_217 = wp::mul(var_215, var_215);
    wp::add_inplace(var_5, var_210, var_217);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_219 = wp::mul(var_136, var_2);
    var_220 = wp::add(var_3, var_219);
    var_221 = wp::add(var_220, var_218);
    var_222 = wp::address(var_grouped, var_221);
    var_224 = wp::load(var_222);
    var_223 = wp::sub(var_224, var_137);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_225 = wp::mul(var_223, var_223);
    wp::add_inplace(var_5, var_218, var_225);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_227 = wp::mul(var_136, var_2);
    var_228 = wp::add(var_3, var_227);
    var_229 = wp::add(var_228, var_226);
    var_230 = wp::address(var_grouped, var_229);
    var_232 = wp::load(var_230);
    var_231 = wp::sub(var_232, var_137);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_233 = wp::mul(var_231, var_231);
    wp::add_inplace(var_5, var_226, var_233);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_235 = wp::mul(var_136, var_2);
    var_236 = wp::add(var_3, var_235);
    var_237 = wp::add(var_236, var_234);
    var_238 = wp::address(var_grouped, var_237);
    var_240 = wp::load(var_238);
    var_239 = wp::sub(var_240, var_137);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_241 = wp::mul(var_239, var_239);
    wp::add_inplace(var_5, var_234, var_241);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_243 = wp::mul(var_136, var_2);
    var_244 = wp::add(var_3, var_243);
    var_245 = wp::add(var_244, var_242);
    var_246 = wp::address(var_grouped, var_245);
    var_248 = wp::load(var_246);
    var_247 = wp::sub(var_248, var_137);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_249 = wp::mul(var_247, var_247);
    wp::add_inplace(var_5, var_242, var_249);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_251 = wp::mul(var_136, var_2);
    var_252 = wp::add(var_3, var_251);
    var_253 = wp::add(var_252, var_250);
    var_254 = wp::address(var_grouped, var_253);
    var_256 = wp::load(var_254);
    var_255 = wp::sub(var_256, var_137);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_257 = wp::mul(var_255, var_255);
    wp::add_inplace(var_5, var_250, var_257);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_259 = wp::mul(var_136, var_2);
    var_260 = wp::add(var_3, var_259);
    var_261 = wp::add(var_260, var_258);
    var_262 = wp::address(var_grouped, var_261);
    var_264 = wp::load(var_262);
    var_263 = wp::sub(var_264, var_137);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_265 = wp::mul(var_263, var_263);
    wp::add_inplace(var_5, var_258, var_265);
    // x = y[k]                                                                               <L 111>
    var_267 = wp::extract(var_y, var_266);
    // for j in range(GROUP):                                                                 <L 112>
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_269 = wp::mul(var_266, var_2);
    var_270 = wp::add(var_3, var_269);
    var_271 = wp::add(var_270, var_268);
    var_272 = wp::address(var_grouped, var_271);
    var_274 = wp::load(var_272);
    var_273 = wp::sub(var_274, var_267);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_275 = wp::mul(var_273, var_273);
    wp::add_inplace(var_5, var_268, var_275);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_277 = wp::mul(var_266, var_2);
    var_278 = wp::add(var_3, var_277);
    var_279 = wp::add(var_278, var_276);
    var_280 = wp::address(var_grouped, var_279);
    var_282 = wp::load(var_280);
    var_281 = wp::sub(var_282, var_267);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_283 = wp::mul(var_281, var_281);
    wp::add_inplace(var_5, var_276, var_283);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_285 = wp::mul(var_266, var_2);
    var_286 = wp::add(var_3, var_285);
    var_287 = wp::add(var_286, var_284);
    var_288 = wp::address(var_grouped, var_287);
    var_290 = wp::load(var_288);
    var_289 = wp::sub(var_290, var_267);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_291 = wp::mul(var_289, var_289);
    wp::add_inplace(var_5, var_284, var_291);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_293 = wp::mul(var_266, var_2);
    var_294 = wp::add(var_3, var_293);
    var_295 = wp::add(var_294, var_292);
    var_296 = wp::address(var_grouped, var_295);
    var_298 = wp::load(var_296);
    var_297 = wp::sub(var_298, var_267);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_299 = wp::mul(var_297, var_297);
    wp::add_inplace(var_5, var_292, var_299);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_301 = wp::mul(var_266, var_2);
    var_302 = wp::add(var_3, var_301);
    var_303 = wp::add(var_302, var_300);
    var_304 = wp::address(var_grouped, var_303);
    var_306 = wp::load(var_304);
    var_305 = wp::sub(var_306, var_267);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_307 = wp::mul(var_305, var_305);
    wp::add_inplace(var_5, var_300, var_307);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_309 = wp::mul(var_266, var_2);
    var_310 = wp::add(var_3, var_309);
    var_311 = wp::add(var_310, var_308);
    var_312 = wp::address(var_grouped, var_311);
    var_314 = wp::load(var_312);
    var_313 = wp::sub(var_314, var_267);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_315 = wp::mul(var_313, var_313);
    wp::add_inplace(var_5, var_308, var_315);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_317 = wp::mul(var_266, var_2);
    var_318 = wp::add(var_3, var_317);
    var_319 = wp::add(var_318, var_316);
    var_320 = wp::address(var_grouped, var_319);
    var_322 = wp::load(var_320);
    var_321 = wp::sub(var_322, var_267);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_323 = wp::mul(var_321, var_321);
    wp::add_inplace(var_5, var_316, var_323);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_325 = wp::mul(var_266, var_2);
    var_326 = wp::add(var_3, var_325);
    var_327 = wp::add(var_326, var_324);
    var_328 = wp::address(var_grouped, var_327);
    var_330 = wp::load(var_328);
    var_329 = wp::sub(var_330, var_267);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_331 = wp::mul(var_329, var_329);
    wp::add_inplace(var_5, var_324, var_331);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_333 = wp::mul(var_266, var_2);
    var_334 = wp::add(var_3, var_333);
    var_335 = wp::add(var_334, var_332);
    var_336 = wp::address(var_grouped, var_335);
    var_338 = wp::load(var_336);
    var_337 = wp::sub(var_338, var_267);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_339 = wp::mul(var_337, var_337);
    wp::add_inplace(var_5, var_332, var_339);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_341 = wp::mul(var_266, var_2);
    var_342 = wp::add(var_3, var_341);
    var_343 = wp::add(var_342, var_340);
    var_344 = wp::address(var_grouped, var_343);
    var_346 = wp::load(var_344);
    var_345 = wp::sub(var_346, var_267);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_347 = wp::mul(var_345, var_345);
    wp::add_inplace(var_5, var_340, var_347);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_349 = wp::mul(var_266, var_2);
    var_350 = wp::add(var_3, var_349);
    var_351 = wp::add(var_350, var_348);
    var_352 = wp::address(var_grouped, var_351);
    var_354 = wp::load(var_352);
    var_353 = wp::sub(var_354, var_267);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_355 = wp::mul(var_353, var_353);
    wp::add_inplace(var_5, var_348, var_355);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_357 = wp::mul(var_266, var_2);
    var_358 = wp::add(var_3, var_357);
    var_359 = wp::add(var_358, var_356);
    var_360 = wp::address(var_grouped, var_359);
    var_362 = wp::load(var_360);
    var_361 = wp::sub(var_362, var_267);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_363 = wp::mul(var_361, var_361);
    wp::add_inplace(var_5, var_356, var_363);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_365 = wp::mul(var_266, var_2);
    var_366 = wp::add(var_3, var_365);
    var_367 = wp::add(var_366, var_364);
    var_368 = wp::address(var_grouped, var_367);
    var_370 = wp::load(var_368);
    var_369 = wp::sub(var_370, var_267);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_371 = wp::mul(var_369, var_369);
    wp::add_inplace(var_5, var_364, var_371);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_373 = wp::mul(var_266, var_2);
    var_374 = wp::add(var_3, var_373);
    var_375 = wp::add(var_374, var_372);
    var_376 = wp::address(var_grouped, var_375);
    var_378 = wp::load(var_376);
    var_377 = wp::sub(var_378, var_267);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_379 = wp::mul(var_377, var_377);
    wp::add_inplace(var_5, var_372, var_379);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_381 = wp::mul(var_266, var_2);
    var_382 = wp::add(var_3, var_381);
    var_383 = wp::add(var_382, var_380);
    var_384 = wp::address(var_grouped, var_383);
    var_386 = wp::load(var_384);
    var_385 = wp::sub(var_386, var_267);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_387 = wp::mul(var_385, var_385);
    wp::add_inplace(var_5, var_380, var_387);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_389 = wp::mul(var_266, var_2);
    var_390 = wp::add(var_3, var_389);
    var_391 = wp::add(var_390, var_388);
    var_392 = wp::address(var_grouped, var_391);
    var_394 = wp::load(var_392);
    var_393 = wp::sub(var_394, var_267);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_395 = wp::mul(var_393, var_393);
    wp::add_inplace(var_5, var_388, var_395);
    // x = y[k]                                                                               <L 111>
    var_397 = wp::extract(var_y, var_396);
    // for j in range(GROUP):                                                                 <L 112>
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_399 = wp::mul(var_396, var_2);
    var_400 = wp::add(var_3, var_399);
    var_401 = wp::add(var_400, var_398);
    var_402 = wp::address(var_grouped, var_401);
    var_404 = wp::load(var_402);
    var_403 = wp::sub(var_404, var_397);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_405 = wp::mul(var_403, var_403);
    wp::add_inplace(var_5, var_398, var_405);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_407 = wp::mul(var_396, var_2);
    var_408 = wp::add(var_3, var_407);
    var_409 = wp::add(var_408, var_406);
    var_410 = wp::address(var_grouped, var_409);
    var_412 = wp::load(var_410);
    var_411 = wp::sub(var_412, var_397);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_413 = wp::mul(var_411, var_411);
    wp::add_inplace(var_5, var_406, var_413);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_415 = wp::mul(var_396, var_2);
    var_416 = wp::add(var_3, var_415);
    var_417 = wp::add(var_416, var_414);
    var_418 = wp::address(var_grouped, var_417);
    var_420 = wp::load(var_418);
    var_419 = wp::sub(var_420, var_397);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_421 = wp::mul(var_419, var_419);
    wp::add_inplace(var_5, var_414, var_421);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_423 = wp::mul(var_396, var_2);
    var_424 = wp::add(var_3, var_423);
    var_425 = wp::add(var_424, var_422);
    var_426 = wp::address(var_grouped, var_425);
    var_428 = wp::load(var_426);
    var_427 = wp::sub(var_428, var_397);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_429 = wp::mul(var_427, var_427);
    wp::add_inplace(var_5, var_422, var_429);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_431 = wp::mul(var_396, var_2);
    var_432 = wp::add(var_3, var_431);
    var_433 = wp::add(var_432, var_430);
    var_434 = wp::address(var_grouped, var_433);
    var_436 = wp::load(var_434);
    var_435 = wp::sub(var_436, var_397);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_437 = wp::mul(var_435, var_435);
    wp::add_inplace(var_5, var_430, var_437);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_439 = wp::mul(var_396, var_2);
    var_440 = wp::add(var_3, var_439);
    var_441 = wp::add(var_440, var_438);
    var_442 = wp::address(var_grouped, var_441);
    var_444 = wp::load(var_442);
    var_443 = wp::sub(var_444, var_397);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_445 = wp::mul(var_443, var_443);
    wp::add_inplace(var_5, var_438, var_445);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_447 = wp::mul(var_396, var_2);
    var_448 = wp::add(var_3, var_447);
    var_449 = wp::add(var_448, var_446);
    var_450 = wp::address(var_grouped, var_449);
    var_452 = wp::load(var_450);
    var_451 = wp::sub(var_452, var_397);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_453 = wp::mul(var_451, var_451);
    wp::add_inplace(var_5, var_446, var_453);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_455 = wp::mul(var_396, var_2);
    var_456 = wp::add(var_3, var_455);
    var_457 = wp::add(var_456, var_454);
    var_458 = wp::address(var_grouped, var_457);
    var_460 = wp::load(var_458);
    var_459 = wp::sub(var_460, var_397);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_461 = wp::mul(var_459, var_459);
    wp::add_inplace(var_5, var_454, var_461);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_463 = wp::mul(var_396, var_2);
    var_464 = wp::add(var_3, var_463);
    var_465 = wp::add(var_464, var_462);
    var_466 = wp::address(var_grouped, var_465);
    var_468 = wp::load(var_466);
    var_467 = wp::sub(var_468, var_397);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_469 = wp::mul(var_467, var_467);
    wp::add_inplace(var_5, var_462, var_469);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_471 = wp::mul(var_396, var_2);
    var_472 = wp::add(var_3, var_471);
    var_473 = wp::add(var_472, var_470);
    var_474 = wp::address(var_grouped, var_473);
    var_476 = wp::load(var_474);
    var_475 = wp::sub(var_476, var_397);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_477 = wp::mul(var_475, var_475);
    wp::add_inplace(var_5, var_470, var_477);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_479 = wp::mul(var_396, var_2);
    var_480 = wp::add(var_3, var_479);
    var_481 = wp::add(var_480, var_478);
    var_482 = wp::address(var_grouped, var_481);
    var_484 = wp::load(var_482);
    var_483 = wp::sub(var_484, var_397);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_485 = wp::mul(var_483, var_483);
    wp::add_inplace(var_5, var_478, var_485);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_487 = wp::mul(var_396, var_2);
    var_488 = wp::add(var_3, var_487);
    var_489 = wp::add(var_488, var_486);
    var_490 = wp::address(var_grouped, var_489);
    var_492 = wp::load(var_490);
    var_491 = wp::sub(var_492, var_397);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_493 = wp::mul(var_491, var_491);
    wp::add_inplace(var_5, var_486, var_493);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_495 = wp::mul(var_396, var_2);
    var_496 = wp::add(var_3, var_495);
    var_497 = wp::add(var_496, var_494);
    var_498 = wp::address(var_grouped, var_497);
    var_500 = wp::load(var_498);
    var_499 = wp::sub(var_500, var_397);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_501 = wp::mul(var_499, var_499);
    wp::add_inplace(var_5, var_494, var_501);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_503 = wp::mul(var_396, var_2);
    var_504 = wp::add(var_3, var_503);
    var_505 = wp::add(var_504, var_502);
    var_506 = wp::address(var_grouped, var_505);
    var_508 = wp::load(var_506);
    var_507 = wp::sub(var_508, var_397);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_509 = wp::mul(var_507, var_507);
    wp::add_inplace(var_5, var_502, var_509);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_511 = wp::mul(var_396, var_2);
    var_512 = wp::add(var_3, var_511);
    var_513 = wp::add(var_512, var_510);
    var_514 = wp::address(var_grouped, var_513);
    var_516 = wp::load(var_514);
    var_515 = wp::sub(var_516, var_397);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_517 = wp::mul(var_515, var_515);
    wp::add_inplace(var_5, var_510, var_517);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_519 = wp::mul(var_396, var_2);
    var_520 = wp::add(var_3, var_519);
    var_521 = wp::add(var_520, var_518);
    var_522 = wp::address(var_grouped, var_521);
    var_524 = wp::load(var_522);
    var_523 = wp::sub(var_524, var_397);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_525 = wp::mul(var_523, var_523);
    wp::add_inplace(var_5, var_518, var_525);
    // x = y[k]                                                                               <L 111>
    var_527 = wp::extract(var_y, var_526);
    // for j in range(GROUP):                                                                 <L 112>
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_529 = wp::mul(var_526, var_2);
    var_530 = wp::add(var_3, var_529);
    var_531 = wp::add(var_530, var_528);
    var_532 = wp::address(var_grouped, var_531);
    var_534 = wp::load(var_532);
    var_533 = wp::sub(var_534, var_527);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_535 = wp::mul(var_533, var_533);
    wp::add_inplace(var_5, var_528, var_535);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_537 = wp::mul(var_526, var_2);
    var_538 = wp::add(var_3, var_537);
    var_539 = wp::add(var_538, var_536);
    var_540 = wp::address(var_grouped, var_539);
    var_542 = wp::load(var_540);
    var_541 = wp::sub(var_542, var_527);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_543 = wp::mul(var_541, var_541);
    wp::add_inplace(var_5, var_536, var_543);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_545 = wp::mul(var_526, var_2);
    var_546 = wp::add(var_3, var_545);
    var_547 = wp::add(var_546, var_544);
    var_548 = wp::address(var_grouped, var_547);
    var_550 = wp::load(var_548);
    var_549 = wp::sub(var_550, var_527);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_551 = wp::mul(var_549, var_549);
    wp::add_inplace(var_5, var_544, var_551);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_553 = wp::mul(var_526, var_2);
    var_554 = wp::add(var_3, var_553);
    var_555 = wp::add(var_554, var_552);
    var_556 = wp::address(var_grouped, var_555);
    var_558 = wp::load(var_556);
    var_557 = wp::sub(var_558, var_527);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_559 = wp::mul(var_557, var_557);
    wp::add_inplace(var_5, var_552, var_559);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_561 = wp::mul(var_526, var_2);
    var_562 = wp::add(var_3, var_561);
    var_563 = wp::add(var_562, var_560);
    var_564 = wp::address(var_grouped, var_563);
    var_566 = wp::load(var_564);
    var_565 = wp::sub(var_566, var_527);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_567 = wp::mul(var_565, var_565);
    wp::add_inplace(var_5, var_560, var_567);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_569 = wp::mul(var_526, var_2);
    var_570 = wp::add(var_3, var_569);
    var_571 = wp::add(var_570, var_568);
    var_572 = wp::address(var_grouped, var_571);
    var_574 = wp::load(var_572);
    var_573 = wp::sub(var_574, var_527);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_575 = wp::mul(var_573, var_573);
    wp::add_inplace(var_5, var_568, var_575);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_577 = wp::mul(var_526, var_2);
    var_578 = wp::add(var_3, var_577);
    var_579 = wp::add(var_578, var_576);
    var_580 = wp::address(var_grouped, var_579);
    var_582 = wp::load(var_580);
    var_581 = wp::sub(var_582, var_527);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_583 = wp::mul(var_581, var_581);
    wp::add_inplace(var_5, var_576, var_583);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_585 = wp::mul(var_526, var_2);
    var_586 = wp::add(var_3, var_585);
    var_587 = wp::add(var_586, var_584);
    var_588 = wp::address(var_grouped, var_587);
    var_590 = wp::load(var_588);
    var_589 = wp::sub(var_590, var_527);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_591 = wp::mul(var_589, var_589);
    wp::add_inplace(var_5, var_584, var_591);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_593 = wp::mul(var_526, var_2);
    var_594 = wp::add(var_3, var_593);
    var_595 = wp::add(var_594, var_592);
    var_596 = wp::address(var_grouped, var_595);
    var_598 = wp::load(var_596);
    var_597 = wp::sub(var_598, var_527);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_599 = wp::mul(var_597, var_597);
    wp::add_inplace(var_5, var_592, var_599);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_601 = wp::mul(var_526, var_2);
    var_602 = wp::add(var_3, var_601);
    var_603 = wp::add(var_602, var_600);
    var_604 = wp::address(var_grouped, var_603);
    var_606 = wp::load(var_604);
    var_605 = wp::sub(var_606, var_527);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_607 = wp::mul(var_605, var_605);
    wp::add_inplace(var_5, var_600, var_607);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_609 = wp::mul(var_526, var_2);
    var_610 = wp::add(var_3, var_609);
    var_611 = wp::add(var_610, var_608);
    var_612 = wp::address(var_grouped, var_611);
    var_614 = wp::load(var_612);
    var_613 = wp::sub(var_614, var_527);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_615 = wp::mul(var_613, var_613);
    wp::add_inplace(var_5, var_608, var_615);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_617 = wp::mul(var_526, var_2);
    var_618 = wp::add(var_3, var_617);
    var_619 = wp::add(var_618, var_616);
    var_620 = wp::address(var_grouped, var_619);
    var_622 = wp::load(var_620);
    var_621 = wp::sub(var_622, var_527);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_623 = wp::mul(var_621, var_621);
    wp::add_inplace(var_5, var_616, var_623);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_625 = wp::mul(var_526, var_2);
    var_626 = wp::add(var_3, var_625);
    var_627 = wp::add(var_626, var_624);
    var_628 = wp::address(var_grouped, var_627);
    var_630 = wp::load(var_628);
    var_629 = wp::sub(var_630, var_527);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_631 = wp::mul(var_629, var_629);
    wp::add_inplace(var_5, var_624, var_631);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_633 = wp::mul(var_526, var_2);
    var_634 = wp::add(var_3, var_633);
    var_635 = wp::add(var_634, var_632);
    var_636 = wp::address(var_grouped, var_635);
    var_638 = wp::load(var_636);
    var_637 = wp::sub(var_638, var_527);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_639 = wp::mul(var_637, var_637);
    wp::add_inplace(var_5, var_632, var_639);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_641 = wp::mul(var_526, var_2);
    var_642 = wp::add(var_3, var_641);
    var_643 = wp::add(var_642, var_640);
    var_644 = wp::address(var_grouped, var_643);
    var_646 = wp::load(var_644);
    var_645 = wp::sub(var_646, var_527);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_647 = wp::mul(var_645, var_645);
    wp::add_inplace(var_5, var_640, var_647);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_649 = wp::mul(var_526, var_2);
    var_650 = wp::add(var_3, var_649);
    var_651 = wp::add(var_650, var_648);
    var_652 = wp::address(var_grouped, var_651);
    var_654 = wp::load(var_652);
    var_653 = wp::sub(var_654, var_527);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_655 = wp::mul(var_653, var_653);
    wp::add_inplace(var_5, var_648, var_655);
    // x = y[k]                                                                               <L 111>
    var_657 = wp::extract(var_y, var_656);
    // for j in range(GROUP):                                                                 <L 112>
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_659 = wp::mul(var_656, var_2);
    var_660 = wp::add(var_3, var_659);
    var_661 = wp::add(var_660, var_658);
    var_662 = wp::address(var_grouped, var_661);
    var_664 = wp::load(var_662);
    var_663 = wp::sub(var_664, var_657);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_665 = wp::mul(var_663, var_663);
    wp::add_inplace(var_5, var_658, var_665);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_667 = wp::mul(var_656, var_2);
    var_668 = wp::add(var_3, var_667);
    var_669 = wp::add(var_668, var_666);
    var_670 = wp::address(var_grouped, var_669);
    var_672 = wp::load(var_670);
    var_671 = wp::sub(var_672, var_657);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_673 = wp::mul(var_671, var_671);
    wp::add_inplace(var_5, var_666, var_673);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_675 = wp::mul(var_656, var_2);
    var_676 = wp::add(var_3, var_675);
    var_677 = wp::add(var_676, var_674);
    var_678 = wp::address(var_grouped, var_677);
    var_680 = wp::load(var_678);
    var_679 = wp::sub(var_680, var_657);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_681 = wp::mul(var_679, var_679);
    wp::add_inplace(var_5, var_674, var_681);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_683 = wp::mul(var_656, var_2);
    var_684 = wp::add(var_3, var_683);
    var_685 = wp::add(var_684, var_682);
    var_686 = wp::address(var_grouped, var_685);
    var_688 = wp::load(var_686);
    var_687 = wp::sub(var_688, var_657);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_689 = wp::mul(var_687, var_687);
    wp::add_inplace(var_5, var_682, var_689);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_691 = wp::mul(var_656, var_2);
    var_692 = wp::add(var_3, var_691);
    var_693 = wp::add(var_692, var_690);
    var_694 = wp::address(var_grouped, var_693);
    var_696 = wp::load(var_694);
    var_695 = wp::sub(var_696, var_657);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_697 = wp::mul(var_695, var_695);
    wp::add_inplace(var_5, var_690, var_697);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_699 = wp::mul(var_656, var_2);
    var_700 = wp::add(var_3, var_699);
    var_701 = wp::add(var_700, var_698);
    var_702 = wp::address(var_grouped, var_701);
    var_704 = wp::load(var_702);
    var_703 = wp::sub(var_704, var_657);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_705 = wp::mul(var_703, var_703);
    wp::add_inplace(var_5, var_698, var_705);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_707 = wp::mul(var_656, var_2);
    var_708 = wp::add(var_3, var_707);
    var_709 = wp::add(var_708, var_706);
    var_710 = wp::address(var_grouped, var_709);
    var_712 = wp::load(var_710);
    var_711 = wp::sub(var_712, var_657);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_713 = wp::mul(var_711, var_711);
    wp::add_inplace(var_5, var_706, var_713);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_715 = wp::mul(var_656, var_2);
    var_716 = wp::add(var_3, var_715);
    var_717 = wp::add(var_716, var_714);
    var_718 = wp::address(var_grouped, var_717);
    var_720 = wp::load(var_718);
    var_719 = wp::sub(var_720, var_657);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_721 = wp::mul(var_719, var_719);
    wp::add_inplace(var_5, var_714, var_721);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_723 = wp::mul(var_656, var_2);
    var_724 = wp::add(var_3, var_723);
    var_725 = wp::add(var_724, var_722);
    var_726 = wp::address(var_grouped, var_725);
    var_728 = wp::load(var_726);
    var_727 = wp::sub(var_728, var_657);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_729 = wp::mul(var_727, var_727);
    wp::add_inplace(var_5, var_722, var_729);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_731 = wp::mul(var_656, var_2);
    var_732 = wp::add(var_3, var_731);
    var_733 = wp::add(var_732, var_730);
    var_734 = wp::address(var_grouped, var_733);
    var_736 = wp::load(var_734);
    var_735 = wp::sub(var_736, var_657);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_737 = wp::mul(var_735, var_735);
    wp::add_inplace(var_5, var_730, var_737);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_739 = wp::mul(var_656, var_2);
    var_740 = wp::add(var_3, var_739);
    var_741 = wp::add(var_740, var_738);
    var_742 = wp::address(var_grouped, var_741);
    var_744 = wp::load(var_742);
    var_743 = wp::sub(var_744, var_657);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_745 = wp::mul(var_743, var_743);
    wp::add_inplace(var_5, var_738, var_745);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_747 = wp::mul(var_656, var_2);
    var_748 = wp::add(var_3, var_747);
    var_749 = wp::add(var_748, var_746);
    var_750 = wp::address(var_grouped, var_749);
    var_752 = wp::load(var_750);
    var_751 = wp::sub(var_752, var_657);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_753 = wp::mul(var_751, var_751);
    wp::add_inplace(var_5, var_746, var_753);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_755 = wp::mul(var_656, var_2);
    var_756 = wp::add(var_3, var_755);
    var_757 = wp::add(var_756, var_754);
    var_758 = wp::address(var_grouped, var_757);
    var_760 = wp::load(var_758);
    var_759 = wp::sub(var_760, var_657);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_761 = wp::mul(var_759, var_759);
    wp::add_inplace(var_5, var_754, var_761);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_763 = wp::mul(var_656, var_2);
    var_764 = wp::add(var_3, var_763);
    var_765 = wp::add(var_764, var_762);
    var_766 = wp::address(var_grouped, var_765);
    var_768 = wp::load(var_766);
    var_767 = wp::sub(var_768, var_657);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_769 = wp::mul(var_767, var_767);
    wp::add_inplace(var_5, var_762, var_769);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_771 = wp::mul(var_656, var_2);
    var_772 = wp::add(var_3, var_771);
    var_773 = wp::add(var_772, var_770);
    var_774 = wp::address(var_grouped, var_773);
    var_776 = wp::load(var_774);
    var_775 = wp::sub(var_776, var_657);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_777 = wp::mul(var_775, var_775);
    wp::add_inplace(var_5, var_770, var_777);
    // gap = grouped[at + k * GROUP + j] - x                                                  <L 113>
    var_779 = wp::mul(var_656, var_2);
    var_780 = wp::add(var_3, var_779);
    var_781 = wp::add(var_780, var_778);
    var_782 = wp::address(var_grouped, var_781);
    var_784 = wp::load(var_782);
    var_783 = wp::sub(var_784, var_657);
    // sqdists[j] += gap * gap                                                                <L 114>
    var_785 = wp::mul(var_783, var_783);
    wp::add_inplace(var_5, var_778, var_785);
    // bits = lanes_within(sqdists, limit)                                                    <L 115>
    var_786 = lanes_within_0(var_5, var_limit);
    // if bits != 0:                                                                          <L 116>
    var_788 = (var_786 != var_787);
    if (var_788) {
        // for k in range(BOXED, AXES):                                                       <L 117>
        // x = y[k]                                                                           <L 118>
        var_790 = wp::extract(var_y, var_789);
        // for j in range(GROUP):                                                             <L 119>
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_792 = wp::mul(var_789, var_2);
        var_793 = wp::add(var_3, var_792);
        var_794 = wp::add(var_793, var_791);
        var_795 = wp::address(var_grouped, var_794);
        var_797 = wp::load(var_795);
        var_796 = wp::sub(var_797, var_790);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_798 = wp::mul(var_796, var_796);
        wp::add_inplace(var_5, var_791, var_798);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_800 = wp::mul(var_789, var_2);
        var_801 = wp::add(var_3, var_800);
        var_802 = wp::add(var_801, var_799);
        var_803 = wp::address(var_grouped, var_802);
        var_805 = wp::load(var_803);
        var_804 = wp::sub(var_805, var_790);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_806 = wp::mul(var_804, var_804);
        wp::add_inplace(var_5, var_799, var_806);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_808 = wp::mul(var_789, var_2);
        var_809 = wp::add(var_3, var_808);
        var_810 = wp::add(var_809, var_807);
        var_811 = wp::address(var_grouped, var_810);
        var_813 = wp::load(var_811);
        var_812 = wp::sub(var_813, var_790);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_814 = wp::mul(var_812, var_812);
        wp::add_inplace(var_5, var_807, var_814);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_816 = wp::mul(var_789, var_2);
        var_817 = wp::add(var_3, var_816);
        var_818 = wp::add(var_817, var_815);
        var_819 = wp::address(var_grouped, var_818);
        var_821 = wp::load(var_819);
        var_820 = wp::sub(var_821, var_790);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_822 = wp::mul(var_820, var_820);
        wp::add_inplace(var_5, var_815, var_822);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_824 = wp::mul(var_789, var_2);
        var_825 = wp::add(var_3, var_824);
        var_826 = wp::add(var_825, var_823);
        var_827 = wp::address(var_grouped, var_826);
        var_829 = wp::load(var_827);
        var_828 = wp::sub(var_829, var_790);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_830 = wp::mul(var_828, var_828);
        wp::add_inplace(var_5, var_823, var_830);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_832 = wp::mul(var_789, var_2);
        var_833 = wp::add(var_3, var_832);
        var_834 = wp::add(var_833, var_831);
        var_835 = wp::address(var_grouped, var_834);
        var_837 = wp::load(var_835);
        var_836 = wp::sub(var_837, var_790);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_838 = wp::mul(var_836, var_836);
        wp::add_inplace(var_5, var_831, var_838);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_840 = wp::mul(var_789, var_2);
        var_841 = wp::add(var_3, var_840);
        var_842 = wp::add(var_841, var_839);
        var_843 = wp::address(var_grouped, var_842);
        var_845 = wp::load(var_843);
        var_844 = wp::sub(var_845, var_790);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_846 = wp::mul(var_844, var_844);
        wp::add_inplace(var_5, var_839, var_846);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_848 = wp::mul(var_789, var_2);
        var_849 = wp::add(var_3, var_848);
        var_850 = wp::add(var_849, var_847);
        var_851 = wp::address(var_grouped, var_850);
        var_853 = wp::load(var_851);
        var_852 = wp::sub(var_853, var_790);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_854 = wp::mul(var_852, var_852);
        wp::add_inplace(var_5, var_847, var_854);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_856 = wp::mul(var_789, var_2);
        var_857 = wp::add(var_3, var_856);
        var_858 = wp::add(var_857, var_855);
        var_859 = wp::address(var_grouped, var_858);
        var_861 = wp::load(var_859);
        var_860 = wp::sub(var_861, var_790);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_862 = wp::mul(var_860, var_860);
        wp::add_inplace(var_5, var_855, var_862);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_864 = wp::mul(var_789, var_2);
        var_865 = wp::add(var_3, var_864);
        var_866 = wp::add(var_865, var_863);
        var_867 = wp::address(var_grouped, var_866);
        var_869 = wp::load(var_867);
        var_868 = wp::sub(var_869, var_790);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_870 = wp::mul(var_868, var_868);
        wp::add_inplace(var_5, var_863, var_870);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_872 = wp::mul(var_789, var_2);
        var_873 = wp::add(var_3, var_872);
        var_874 = wp::add(var_873, var_871);
        var_875 = wp::address(var_grouped, var_874);
        var_877 = wp::load(var_875);
        var_876 = wp::sub(var_877, var_790);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_878 = wp::mul(var_876, var_876);
        wp::add_inplace(var_5, var_871, var_878);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_880 = wp::mul(var_789, var_2);
        var_881 = wp::add(var_3, var_880);
        var_882 = wp::add(var_881, var_879);
        var_883 = wp::address(var_grouped, var_882);
        var_885 = wp::load(var_883);
        var_884 = wp::sub(var_885, var_790);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_886 = wp::mul(var_884, var_884);
        wp::add_inplace(var_5, var_879, var_886);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_888 = wp::mul(var_789, var_2);
        var_889 = wp::add(var_3, var_888);
        var_890 = wp::add(var_889, var_887);
        var_891 = wp::address(var_grouped, var_890);
        var_893 = wp::load(var_891);
        var_892 = wp::sub(var_893, var_790);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_894 = wp::mul(var_892, var_892);
        wp::add_inplace(var_5, var_887, var_894);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_896 = wp::mul(var_789, var_2);
        var_897 = wp::add(var_3, var_896);
        var_898 = wp::add(var_897, var_895);
        var_899 = wp::address(var_grouped, var_898);
        var_901 = wp::load(var_899);
        var_900 = wp::sub(var_901, var_790);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_902 = wp::mul(var_900, var_900);
        wp::add_inplace(var_5, var_895, var_902);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_904 = wp::mul(var_789, var_2);
        var_905 = wp::add(var_3, var_904);
        var_906 = wp::add(var_905, var_903);
        var_907 = wp::address(var_grouped, var_906);
        var_909 = wp::load(var_907);
        var_908 = wp::sub(var_909, var_790);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_910 = wp::mul(var_908, var_908);
        wp::add_inplace(var_5, var_903, var_910);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_912 = wp::mul(var_789, var_2);
        var_913 = wp::add(var_3, var_912);
        var_914 = wp::add(var_913, var_911);
        var_915 = wp::address(var_grouped, var_914);
        var_917 = wp::load(var_915);
        var_916 = wp::sub(var_917, var_790);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_918 = wp::mul(var_916, var_916);
        wp::add_inplace(var_5, var_911, var_918);
        // x = y[k]                                                                           <L 118>
        var_920 = wp::extract(var_y, var_919);
        // for j in range(GROUP):                                                             <L 119>
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_922 = wp::mul(var_919, var_2);
        var_923 = wp::add(var_3, var_922);
        var_924 = wp::add(var_923, var_921);
        var_925 = wp::address(var_grouped, var_924);
        var_927 = wp::load(var_925);
        var_926 = wp::sub(var_927, var_920);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_928 = wp::mul(var_926, var_926);
        wp::add_inplace(var_5, var_921, var_928);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_930 = wp::mul(var_919, var_2);
        var_931 = wp::add(var_3, var_930);
        var_932 = wp::add(var_931, var_929);
        var_933 = wp::address(var_grouped, var_932);
        var_935 = wp::load(var_933);
        var_934 = wp::sub(var_935, var_920);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_936 = wp::mul(var_934, var_934);
        wp::add_inplace(var_5, var_929, var_936);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_938 = wp::mul(var_919, var_2);
        var_939 = wp::add(var_3, var_938);
        var_940 = wp::add(var_939, var_937);
        var_941 = wp::address(var_grouped, var_940);
        var_943 = wp::load(var_941);
        var_942 = wp::sub(var_943, var_920);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_944 = wp::mul(var_942, var_942);
        wp::add_inplace(var_5, var_937, var_944);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_946 = wp::mul(var_919, var_2);
        var_947 = wp::add(var_3, var_946);
        var_948 = wp::add(var_947, var_945);
        var_949 = wp::address(var_grouped, var_948);
        var_951 = wp::load(var_949);
        var_950 = wp::sub(var_951, var_920);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_952 = wp::mul(var_950, var_950);
        wp::add_inplace(var_5, var_945, var_952);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_954 = wp::mul(var_919, var_2);
        var_955 = wp::add(var_3, var_954);
        var_956 = wp::add(var_955, var_953);
        var_957 = wp::address(var_grouped, var_956);
        var_959 = wp::load(var_957);
        var_958 = wp::sub(var_959, var_920);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_960 = wp::mul(var_958, var_958);
        wp::add_inplace(var_5, var_953, var_960);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_962 = wp::mul(var_919, var_2);
        var_963 = wp::add(var_3, var_962);
        var_964 = wp::add(var_963, var_961);
        var_965 = wp::address(var_grouped, var_964);
        var_967 = wp::load(var_965);
        var_966 = wp::sub(var_967, var_920);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_968 = wp::mul(var_966, var_966);
        wp::add_inplace(var_5, var_961, var_968);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_970 = wp::mul(var_919, var_2);
        var_971 = wp::add(var_3, var_970);
        var_972 = wp::add(var_971, var_969);
        var_973 = wp::address(var_grouped, var_972);
        var_975 = wp::load(var_973);
        var_974 = wp::sub(var_975, var_920);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_976 = wp::mul(var_974, var_974);
        wp::add_inplace(var_5, var_969, var_976);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_978 = wp::mul(var_919, var_2);
        var_979 = wp::add(var_3, var_978);
        var_980 = wp::add(var_979, var_977);
        var_981 = wp::address(var_grouped, var_980);
        var_983 = wp::load(var_981);
        var_982 = wp::sub(var_983, var_920);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_984 = wp::mul(var_982, var_982);
        wp::add_inplace(var_5, var_977, var_984);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_986 = wp::mul(var_919, var_2);
        var_987 = wp::add(var_3, var_986);
        var_988 = wp::add(var_987, var_985);
        var_989 = wp::address(var_grouped, var_988);
        var_991 = wp::load(var_989);
        var_990 = wp::sub(var_991, var_920);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_992 = wp::mul(var_990, var_990);
        wp::add_inplace(var_5, var_985, var_992);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_994 = wp::mul(var_919, var_2);
        var_995 = wp::add(var_3, var_994);
        var_996 = wp::add(var_995, var_993);
        var_997 = wp::address(var_grouped, var_996);
        var_999 = wp::load(var_997);
        var_998 = wp::sub(var_999, var_920);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1000 = wp::mul(var_998, var_998);
        wp::add_inplace(var_5, var_993, var_1000);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1002 = wp::mul(var_919, var_2);
        var_1003 = wp::add(var_3, var_1002);
        var_1004 = wp::add(var_1003, var_1001);
        var_1005 = wp::address(var_grouped, var_1004);
        var_1007 = wp::load(var_1005);
        var_1006 = wp::sub(var_1007, var_920);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1008 = wp::mul(var_1006, var_1006);
        wp::add_inplace(var_5, var_1001, var_1008);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1010 = wp::mul(var_919, var_2);
        var_1011 = wp::add(var_3, var_1010);
        var_1012 = wp::add(var_1011, var_1009);
        var_1013 = wp::address(var_grouped, var_1012);
        var_1015 = wp::load(var_1013);
        var_1014 = wp::sub(var_1015, var_920);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1016 = wp::mul(var_1014, var_1014);
        wp::add_inplace(var_5, var_1009, var_1016);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1018 = wp::mul(var_919, var_2);
        var_1019 = wp::add(var_3, var_1018);
        var_1020 = wp::add(var_1019, var_1017);
        var_1021 = wp::address(var_grouped, var_1020);
        var_1023 = wp::load(var_1021);
        var_1022 = wp::sub(var_1023, var_920);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1024 = wp::mul(var_1022, var_1022);
        wp::add_inplace(var_5, var_1017, var_1024);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1026 = wp::mul(var_919, var_2);
        var_1027 = wp::add(var_3, var_1026);
        var_1028 = wp::add(var_1027, var_1025);
        var_1029 = wp::address(var_grouped, var_1028);
        var_1031 = wp::load(var_1029);
        var_1030 = wp::sub(var_1031, var_920);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1032 = wp::mul(var_1030, var_1030);
        wp::add_inplace(var_5, var_1025, var_1032);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1034 = wp::mul(var_919, var_2);
        var_1035 = wp::add(var_3, var_1034);
        var_1036 = wp::add(var_1035, var_1033);
        var_1037 = wp::address(var_grouped, var_1036);
        var_1039 = wp::load(var_1037);
        var_1038 = wp::sub(var_1039, var_920);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1040 = wp::mul(var_1038, var_1038);
        wp::add_inplace(var_5, var_1033, var_1040);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1042 = wp::mul(var_919, var_2);
        var_1043 = wp::add(var_3, var_1042);
        var_1044 = wp::add(var_1043, var_1041);
        var_1045 = wp::address(var_grouped, var_1044);
        var_1047 = wp::load(var_1045);
        var_1046 = wp::sub(var_1047, var_920);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1048 = wp::mul(var_1046, var_1046);
        wp::add_inplace(var_5, var_1041, var_1048);
        // x = y[k]                                                                           <L 118>
        var_1050 = wp::extract(var_y, var_1049);
        // for j in range(GROUP):                                                             <L 119>
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1052 = wp::mul(var_1049, var_2);
        var_1053 = wp::add(var_3, var_1052);
        var_1054 = wp::add(var_1053, var_1051);
        var_1055 = wp::address(var_grouped, var_1054);
        var_1057 = wp::load(var_1055);
        var_1056 = wp::sub(var_1057, var_1050);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1058 = wp::mul(var_1056, var_1056);
        wp::add_inplace(var_5, var_1051, var_1058);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1060 = wp::mul(var_1049, var_2);
        var_1061 = wp::add(var_3, var_1060);
        var_1062 = wp::add(var_1061, var_1059);
        var_1063 = wp::address(var_grouped, var_1062);
        var_1065 = wp::load(var_1063);
        var_1064 = wp::sub(var_1065, var_1050);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1066 = wp::mul(var_1064, var_1064);
        wp::add_inplace(var_5, var_1059, var_1066);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1068 = wp::mul(var_1049, var_2);
        var_1069 = wp::add(var_3, var_1068);
        var_1070 = wp::add(var_1069, var_1067);
        var_1071 = wp::address(var_grouped, var_1070);
        var_1073 = wp::load(var_1071);
        var_1072 = wp::sub(var_1073, var_1050);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1074 = wp::mul(var_1072, var_1072);
        wp::add_inplace(var_5, var_1067, var_1074);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1076 = wp::mul(var_1049, var_2);
        var_1077 = wp::add(var_3, var_1076);
        var_1078 = wp::add(var_1077, var_1075);
        var_1079 = wp::address(var_grouped, var_1078);
        var_1081 = wp::load(var_1079);
        var_1080 = wp::sub(var_1081, var_1050);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1082 = wp::mul(var_1080, var_1080);
        wp::add_inplace(var_5, var_1075, var_1082);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1084 = wp::mul(var_1049, var_2);
        var_1085 = wp::add(var_3, var_1084);
        var_1086 = wp::add(var_1085, var_1083);
        var_1087 = wp::address(var_grouped, var_1086);
        var_1089 = wp::load(var_1087);
        var_1088 = wp::sub(var_1089, var_1050);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1090 = wp::mul(var_1088, var_1088);
        wp::add_inplace(var_5, var_1083, var_1090);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1092 = wp::mul(var_1049, var_2);
        var_1093 = wp::add(var_3, var_1092);
        var_1094 = wp::add(var_1093, var_1091);
        var_1095 = wp::address(var_grouped, var_1094);
        var_1097 = wp::load(var_1095);
        var_1096 = wp::sub(var_1097, var_1050);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1098 = wp::mul(var_1096, var_1096);
        wp::add_inplace(var_5, var_1091, var_1098);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1100 = wp::mul(var_1049, var_2);
        var_1101 = wp::add(var_3, var_1100);
        var_1102 = wp::add(var_1101, var_1099);
        var_1103 = wp::address(var_grouped, var_1102);
        var_1105 = wp::load(var_1103);
        var_1104 = wp::sub(var_1105, var_1050);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1106 = wp::mul(var_1104, var_1104);
        wp::add_inplace(var_5, var_1099, var_1106);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1108 = wp::mul(var_1049, var_2);
        var_1109 = wp::add(var_3, var_1108);
        var_1110 = wp::add(var_1109, var_1107);
        var_1111 = wp::address(var_grouped, var_1110);
        var_1113 = wp::load(var_1111);
        var_1112 = wp::sub(var_1113, var_1050);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1114 = wp::mul(var_1112, var_1112);
        wp::add_inplace(var_5, var_1107, var_1114);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1116 = wp::mul(var_1049, var_2);
        var_1117 = wp::add(var_3, var_1116);
        var_1118 = wp::add(var_1117, var_1115);
        var_1119 = wp::address(var_grouped, var_1118);
        var_1121 = wp::load(var_1119);
        var_1120 = wp::sub(var_1121, var_1050);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1122 = wp::mul(var_1120, var_1120);
        wp::add_inplace(var_5, var_1115, var_1122);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1124 = wp::mul(var_1049, var_2);
        var_1125 = wp::add(var_3, var_1124);
        var_1126 = wp::add(var_1125, var_1123);
        var_1127 = wp::address(var_grouped, var_1126);
        var_1129 = wp::load(var_1127);
        var_1128 = wp::sub(var_1129, var_1050);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1130 = wp::mul(var_1128, var_1128);
        wp::add_inplace(var_5, var_1123, var_1130);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1132 = wp::mul(var_1049, var_2);
        var_1133 = wp::add(var_3, var_1132);
        var_1134 = wp::add(var_1133, var_1131);
        var_1135 = wp::address(var_grouped, var_1134);
        var_1137 = wp::load(var_1135);
        var_1136 = wp::sub(var_1137, var_1050);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1138 = wp::mul(var_1136, var_1136);
        wp::add_inplace(var_5, var_1131, var_1138);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1140 = wp::mul(var_1049, var_2);
        var_1141 = wp::add(var_3, var_1140);
        var_1142 = wp::add(var_1141, var_1139);
        var_1143 = wp::address(var_grouped, var_1142);
        var_1145 = wp::load(var_1143);
        var_1144 = wp::sub(var_1145, var_1050);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1146 = wp::mul(var_1144, var_1144);
        wp::add_inplace(var_5, var_1139, var_1146);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1148 = wp::mul(var_1049, var_2);
        var_1149 = wp::add(var_3, var_1148);
        var_1150 = wp::add(var_1149, var_1147);
        var_1151 = wp::address(var_grouped, var_1150);
        var_1153 = wp::load(var_1151);
        var_1152 = wp::sub(var_1153, var_1050);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1154 = wp::mul(var_1152, var_1152);
        wp::add_inplace(var_5, var_1147, var_1154);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1156 = wp::mul(var_1049, var_2);
        var_1157 = wp::add(var_3, var_1156);
        var_1158 = wp::add(var_1157, var_1155);
        var_1159 = wp::address(var_grouped, var_1158);
        var_1161 = wp::load(var_1159);
        var_1160 = wp::sub(var_1161, var_1050);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1162 = wp::mul(var_1160, var_1160);
        wp::add_inplace(var_5, var_1155, var_1162);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1164 = wp::mul(var_1049, var_2);
        var_1165 = wp::add(var_3, var_1164);
        var_1166 = wp::add(var_1165, var_1163);
        var_1167 = wp::address(var_grouped, var_1166);
        var_1169 = wp::load(var_1167);
        var_1168 = wp::sub(var_1169, var_1050);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1170 = wp::mul(var_1168, var_1168);
        wp::add_inplace(var_5, var_1163, var_1170);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1172 = wp::mul(var_1049, var_2);
        var_1173 = wp::add(var_3, var_1172);
        var_1174 = wp::add(var_1173, var_1171);
        var_1175 = wp::address(var_grouped, var_1174);
        var_1177 = wp::load(var_1175);
        var_1176 = wp::sub(var_1177, var_1050);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1178 = wp::mul(var_1176, var_1176);
        wp::add_inplace(var_5, var_1171, var_1178);
        // x = y[k]                                                                           <L 118>
        var_1180 = wp::extract(var_y, var_1179);
        // for j in range(GROUP):                                                             <L 119>
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1182 = wp::mul(var_1179, var_2);
        var_1183 = wp::add(var_3, var_1182);
        var_1184 = wp::add(var_1183, var_1181);
        var_1185 = wp::address(var_grouped, var_1184);
        var_1187 = wp::load(var_1185);
        var_1186 = wp::sub(var_1187, var_1180);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1188 = wp::mul(var_1186, var_1186);
        wp::add_inplace(var_5, var_1181, var_1188);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1190 = wp::mul(var_1179, var_2);
        var_1191 = wp::add(var_3, var_1190);
        var_1192 = wp::add(var_1191, var_1189);
        var_1193 = wp::address(var_grouped, var_1192);
        var_1195 = wp::load(var_1193);
        var_1194 = wp::sub(var_1195, var_1180);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1196 = wp::mul(var_1194, var_1194);
        wp::add_inplace(var_5, var_1189, var_1196);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1198 = wp::mul(var_1179, var_2);
        var_1199 = wp::add(var_3, var_1198);
        var_1200 = wp::add(var_1199, var_1197);
        var_1201 = wp::address(var_grouped, var_1200);
        var_1203 = wp::load(var_1201);
        var_1202 = wp::sub(var_1203, var_1180);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1204 = wp::mul(var_1202, var_1202);
        wp::add_inplace(var_5, var_1197, var_1204);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1206 = wp::mul(var_1179, var_2);
        var_1207 = wp::add(var_3, var_1206);
        var_1208 = wp::add(var_1207, var_1205);
        var_1209 = wp::address(var_grouped, var_1208);
        var_1211 = wp::load(var_1209);
        var_1210 = wp::sub(var_1211, var_1180);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1212 = wp::mul(var_1210, var_1210);
        wp::add_inplace(var_5, var_1205, var_1212);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1214 = wp::mul(var_1179, var_2);
        var_1215 = wp::add(var_3, var_1214);
        var_1216 = wp::add(var_1215, var_1213);
        var_1217 = wp::address(var_grouped, var_1216);
        var_1219 = wp::load(var_1217);
        var_1218 = wp::sub(var_1219, var_1180);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1220 = wp::mul(var_1218, var_1218);
        wp::add_inplace(var_5, var_1213, var_1220);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1222 = wp::mul(var_1179, var_2);
        var_1223 = wp::add(var_3, var_1222);
        var_1224 = wp::add(var_1223, var_1221);
        var_1225 = wp::address(var_grouped, var_1224);
        var_1227 = wp::load(var_1225);
        var_1226 = wp::sub(var_1227, var_1180);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1228 = wp::mul(var_1226, var_1226);
        wp::add_inplace(var_5, var_1221, var_1228);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1230 = wp::mul(var_1179, var_2);
        var_1231 = wp::add(var_3, var_1230);
        var_1232 = wp::add(var_1231, var_1229);
        var_1233 = wp::address(var_grouped, var_1232);
        var_1235 = wp::load(var_1233);
        var_1234 = wp::sub(var_1235, var_1180);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1236 = wp::mul(var_1234, var_1234);
        wp::add_inplace(var_5, var_1229, var_1236);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1238 = wp::mul(var_1179, var_2);
        var_1239 = wp::add(var_3, var_1238);
        var_1240 = wp::add(var_1239, var_1237);
        var_1241 = wp::address(var_grouped, var_1240);
        var_1243 = wp::load(var_1241);
        var_1242 = wp::sub(var_1243, var_1180);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1244 = wp::mul(var_1242, var_1242);
        wp::add_inplace(var_5, var_1237, var_1244);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1246 = wp::mul(var_1179, var_2);
        var_1247 = wp::add(var_3, var_1246);
        var_1248 = wp::add(var_1247, var_1245);
        var_1249 = wp::address(var_grouped, var_1248);
        var_1251 = wp::load(var_1249);
        var_1250 = wp::sub(var_1251, var_1180);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1252 = wp::mul(var_1250, var_1250);
        wp::add_inplace(var_5, var_1245, var_1252);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1254 = wp::mul(var_1179, var_2);
        var_1255 = wp::add(var_3, var_1254);
        var_1256 = wp::add(var_1255, var_1253);
        var_1257 = wp::address(var_grouped, var_1256);
        var_1259 = wp::load(var_1257);
        var_1258 = wp::sub(var_1259, var_1180);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1260 = wp::mul(var_1258, var_1258);
        wp::add_inplace(var_5, var_1253, var_1260);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1262 = wp::mul(var_1179, var_2);
        var_1263 = wp::add(var_3, var_1262);
        var_1264 = wp::add(var_1263, var_1261);
        var_1265 = wp::address(var_grouped, var_1264);
        var_1267 = wp::load(var_1265);
        var_1266 = wp::sub(var_1267, var_1180);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1268 = wp::mul(var_1266, var_1266);
        wp::add_inplace(var_5, var_1261, var_1268);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1270 = wp::mul(var_1179, var_2);
        var_1271 = wp::add(var_3, var_1270);
        var_1272 = wp::add(var_1271, var_1269);
        var_1273 = wp::address(var_grouped, var_1272);
        var_1275 = wp::load(var_1273);
        var_1274 = wp::sub(var_1275, var_1180);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1276 = wp::mul(var_1274, var_1274);
        wp::add_inplace(var_5, var_1269, var_1276);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1278 = wp::mul(var_1179, var_2);
        var_1279 = wp::add(var_3, var_1278);
        var_1280 = wp::add(var_1279, var_1277);
        var_1281 = wp::address(var_grouped, var_1280);
        var_1283 = wp::load(var_1281);
        var_1282 = wp::sub(var_1283, var_1180);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1284 = wp::mul(var_1282, var_1282);
        wp::add_inplace(var_5, var_1277, var_1284);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1286 = wp::mul(var_1179, var_2);
        var_1287 = wp::add(var_3, var_1286);
        var_1288 = wp::add(var_1287, var_1285);
        var_1289 = wp::address(var_grouped, var_1288);
        var_1291 = wp::load(var_1289);
        var_1290 = wp::sub(var_1291, var_1180);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1292 = wp::mul(var_1290, var_1290);
        wp::add_inplace(var_5, var_1285, var_1292);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1294 = wp::mul(var_1179, var_2);
        var_1295 = wp::add(var_3, var_1294);
        var_1296 = wp::add(var_1295, var_1293);
        var_1297 = wp::address(var_grouped, var_1296);
        var_1299 = wp::load(var_1297);
        var_1298 = wp::sub(var_1299, var_1180);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1300 = wp::mul(var_1298, var_1298);
        wp::add_inplace(var_5, var_1293, var_1300);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1302 = wp::mul(var_1179, var_2);
        var_1303 = wp::add(var_3, var_1302);
        var_1304 = wp::add(var_1303, var_1301);
        var_1305 = wp::address(var_grouped, var_1304);
        var_1307 = wp::load(var_1305);
        var_1306 = wp::sub(var_1307, var_1180);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1308 = wp::mul(var_1306, var_1306);
        wp::add_inplace(var_5, var_1301, var_1308);
        // x = y[k]                                                                           <L 118>
        var_1310 = wp::extract(var_y, var_1309);
        // for j in range(GROUP):                                                             <L 119>
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1312 = wp::mul(var_1309, var_2);
        var_1313 = wp::add(var_3, var_1312);
        var_1314 = wp::add(var_1313, var_1311);
        var_1315 = wp::address(var_grouped, var_1314);
        var_1317 = wp::load(var_1315);
        var_1316 = wp::sub(var_1317, var_1310);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1318 = wp::mul(var_1316, var_1316);
        wp::add_inplace(var_5, var_1311, var_1318);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1320 = wp::mul(var_1309, var_2);
        var_1321 = wp::add(var_3, var_1320);
        var_1322 = wp::add(var_1321, var_1319);
        var_1323 = wp::address(var_grouped, var_1322);
        var_1325 = wp::load(var_1323);
        var_1324 = wp::sub(var_1325, var_1310);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1326 = wp::mul(var_1324, var_1324);
        wp::add_inplace(var_5, var_1319, var_1326);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1328 = wp::mul(var_1309, var_2);
        var_1329 = wp::add(var_3, var_1328);
        var_1330 = wp::add(var_1329, var_1327);
        var_1331 = wp::address(var_grouped, var_1330);
        var_1333 = wp::load(var_1331);
        var_1332 = wp::sub(var_1333, var_1310);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1334 = wp::mul(var_1332, var_1332);
        wp::add_inplace(var_5, var_1327, var_1334);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1336 = wp::mul(var_1309, var_2);
        var_1337 = wp::add(var_3, var_1336);
        var_1338 = wp::add(var_1337, var_1335);
        var_1339 = wp::address(var_grouped, var_1338);
        var_1341 = wp::load(var_1339);
        var_1340 = wp::sub(var_1341, var_1310);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1342 = wp::mul(var_1340, var_1340);
        wp::add_inplace(var_5, var_1335, var_1342);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1344 = wp::mul(var_1309, var_2);
        var_1345 = wp::add(var_3, var_1344);
        var_1346 = wp::add(var_1345, var_1343);
        var_1347 = wp::address(var_grouped, var_1346);
        var_1349 = wp::load(var_1347);
        var_1348 = wp::sub(var_1349, var_1310);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1350 = wp::mul(var_1348, var_1348);
        wp::add_inplace(var_5, var_1343, var_1350);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1352 = wp::mul(var_1309, var_2);
        var_1353 = wp::add(var_3, var_1352);
        var_1354 = wp::add(var_1353, var_1351);
        var_1355 = wp::address(var_grouped, var_1354);
        var_1357 = wp::load(var_1355);
        var_1356 = wp::sub(var_1357, var_1310);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1358 = wp::mul(var_1356, var_1356);
        wp::add_inplace(var_5, var_1351, var_1358);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1360 = wp::mul(var_1309, var_2);
        var_1361 = wp::add(var_3, var_1360);
        var_1362 = wp::add(var_1361, var_1359);
        var_1363 = wp::address(var_grouped, var_1362);
        var_1365 = wp::load(var_1363);
        var_1364 = wp::sub(var_1365, var_1310);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1366 = wp::mul(var_1364, var_1364);
        wp::add_inplace(var_5, var_1359, var_1366);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1368 = wp::mul(var_1309, var_2);
        var_1369 = wp::add(var_3, var_1368);
        var_1370 = wp::add(var_1369, var_1367);
        var_1371 = wp::address(var_grouped, var_1370);
        var_1373 = wp::load(var_1371);
        var_1372 = wp::sub(var_1373, var_1310);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1374 = wp::mul(var_1372, var_1372);
        wp::add_inplace(var_5, var_1367, var_1374);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1376 = wp::mul(var_1309, var_2);
        var_1377 = wp::add(var_3, var_1376);
        var_1378 = wp::add(var_1377, var_1375);
        var_1379 = wp::address(var_grouped, var_1378);
        var_1381 = wp::load(var_1379);
        var_1380 = wp::sub(var_1381, var_1310);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1382 = wp::mul(var_1380, var_1380);
        wp::add_inplace(var_5, var_1375, var_1382);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1384 = wp::mul(var_1309, var_2);
        var_1385 = wp::add(var_3, var_1384);
        var_1386 = wp::add(var_1385, var_1383);
        var_1387 = wp::address(var_grouped, var_1386);
        var_1389 = wp::load(var_1387);
        var_1388 = wp::sub(var_1389, var_1310);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1390 = wp::mul(var_1388, var_1388);
        wp::add_inplace(var_5, var_1383, var_1390);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1392 = wp::mul(var_1309, var_2);
        var_1393 = wp::add(var_3, var_1392);
        var_1394 = wp::add(var_1393, var_1391);
        var_1395 = wp::address(var_grouped, var_1394);
        var_1397 = wp::load(var_1395);
        var_1396 = wp::sub(var_1397, var_1310);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1398 = wp::mul(var_1396, var_1396);
        wp::add_inplace(var_5, var_1391, var_1398);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1400 = wp::mul(var_1309, var_2);
        var_1401 = wp::add(var_3, var_1400);
        var_1402 = wp::add(var_1401, var_1399);
        var_1403 = wp::address(var_grouped, var_1402);
        var_1405 = wp::load(var_1403);
        var_1404 = wp::sub(var_1405, var_1310);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1406 = wp::mul(var_1404, var_1404);
        wp::add_inplace(var_5, var_1399, var_1406);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1408 = wp::mul(var_1309, var_2);
        var_1409 = wp::add(var_3, var_1408);
        var_1410 = wp::add(var_1409, var_1407);
        var_1411 = wp::address(var_grouped, var_1410);
        var_1413 = wp::load(var_1411);
        var_1412 = wp::sub(var_1413, var_1310);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1414 = wp::mul(var_1412, var_1412);
        wp::add_inplace(var_5, var_1407, var_1414);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1416 = wp::mul(var_1309, var_2);
        var_1417 = wp::add(var_3, var_1416);
        var_1418 = wp::add(var_1417, var_1415);
        var_1419 = wp::address(var_grouped, var_1418);
        var_1421 = wp::load(var_1419);
        var_1420 = wp::sub(var_1421, var_1310);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1422 = wp::mul(var_1420, var_1420);
        wp::add_inplace(var_5, var_1415, var_1422);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1424 = wp::mul(var_1309, var_2);
        var_1425 = wp::add(var_3, var_1424);
        var_1426 = wp::add(var_1425, var_1423);
        var_1427 = wp::address(var_grouped, var_1426);
        var_1429 = wp::load(var_1427);
        var_1428 = wp::sub(var_1429, var_1310);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1430 = wp::mul(var_1428, var_1428);
        wp::add_inplace(var_5, var_1423, var_1430);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1432 = wp::mul(var_1309, var_2);
        var_1433 = wp::add(var_3, var_1432);
        var_1434 = wp::add(var_1433, var_1431);
        var_1435 = wp::address(var_grouped, var_1434);
        var_1437 = wp::load(var_1435);
        var_1436 = wp::sub(var_1437, var_1310);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1438 = wp::mul(var_1436, var_1436);
        wp::add_inplace(var_5, var_1431, var_1438);
        // x = y[k]                                                                           <L 118>
        var_1440 = wp::extract(var_y, var_1439);
        // for j in range(GROUP):                                                             <L 119>
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1442 = wp::mul(var_1439, var_2);
        var_1443 = wp::add(var_3, var_1442);
        var_1444 = wp::add(var_1443, var_1441);
        var_1445 = wp::address(var_grouped, var_1444);
        var_1447 = wp::load(var_1445);
        var_1446 = wp::sub(var_1447, var_1440);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1448 = wp::mul(var_1446, var_1446);
        wp::add_inplace(var_5, var_1441, var_1448);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1450 = wp::mul(var_1439, var_2);
        var_1451 = wp::add(var_3, var_1450);
        var_1452 = wp::add(var_1451, var_1449);
        var_1453 = wp::address(var_grouped, var_1452);
        var_1455 = wp::load(var_1453);
        var_1454 = wp::sub(var_1455, var_1440);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1456 = wp::mul(var_1454, var_1454);
        wp::add_inplace(var_5, var_1449, var_1456);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1458 = wp::mul(var_1439, var_2);
        var_1459 = wp::add(var_3, var_1458);
        var_1460 = wp::add(var_1459, var_1457);
        var_1461 = wp::address(var_grouped, var_1460);
        var_1463 = wp::load(var_1461);
        var_1462 = wp::sub(var_1463, var_1440);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1464 = wp::mul(var_1462, var_1462);
        wp::add_inplace(var_5, var_1457, var_1464);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1466 = wp::mul(var_1439, var_2);
        var_1467 = wp::add(var_3, var_1466);
        var_1468 = wp::add(var_1467, var_1465);
        var_1469 = wp::address(var_grouped, var_1468);
        var_1471 = wp::load(var_1469);
        var_1470 = wp::sub(var_1471, var_1440);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1472 = wp::mul(var_1470, var_1470);
        wp::add_inplace(var_5, var_1465, var_1472);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1474 = wp::mul(var_1439, var_2);
        var_1475 = wp::add(var_3, var_1474);
        var_1476 = wp::add(var_1475, var_1473);
        var_1477 = wp::address(var_grouped, var_1476);
        var_1479 = wp::load(var_1477);
        var_1478 = wp::sub(var_1479, var_1440);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1480 = wp::mul(var_1478, var_1478);
        wp::add_inplace(var_5, var_1473, var_1480);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1482 = wp::mul(var_1439, var_2);
        var_1483 = wp::add(var_3, var_1482);
        var_1484 = wp::add(var_1483, var_1481);
        var_1485 = wp::address(var_grouped, var_1484);
        var_1487 = wp::load(var_1485);
        var_1486 = wp::sub(var_1487, var_1440);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1488 = wp::mul(var_1486, var_1486);
        wp::add_inplace(var_5, var_1481, var_1488);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1490 = wp::mul(var_1439, var_2);
        var_1491 = wp::add(var_3, var_1490);
        var_1492 = wp::add(var_1491, var_1489);
        var_1493 = wp::address(var_grouped, var_1492);
        var_1495 = wp::load(var_1493);
        var_1494 = wp::sub(var_1495, var_1440);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1496 = wp::mul(var_1494, var_1494);
        wp::add_inplace(var_5, var_1489, var_1496);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1498 = wp::mul(var_1439, var_2);
        var_1499 = wp::add(var_3, var_1498);
        var_1500 = wp::add(var_1499, var_1497);
        var_1501 = wp::address(var_grouped, var_1500);
        var_1503 = wp::load(var_1501);
        var_1502 = wp::sub(var_1503, var_1440);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1504 = wp::mul(var_1502, var_1502);
        wp::add_inplace(var_5, var_1497, var_1504);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1506 = wp::mul(var_1439, var_2);
        var_1507 = wp::add(var_3, var_1506);
        var_1508 = wp::add(var_1507, var_1505);
        var_1509 = wp::address(var_grouped, var_1508);
        var_1511 = wp::load(var_1509);
        var_1510 = wp::sub(var_1511, var_1440);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1512 = wp::mul(var_1510, var_1510);
        wp::add_inplace(var_5, var_1505, var_1512);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1514 = wp::mul(var_1439, var_2);
        var_1515 = wp::add(var_3, var_1514);
        var_1516 = wp::add(var_1515, var_1513);
        var_1517 = wp::address(var_grouped, var_1516);
        var_1519 = wp::load(var_1517);
        var_1518 = wp::sub(var_1519, var_1440);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1520 = wp::mul(var_1518, var_1518);
        wp::add_inplace(var_5, var_1513, var_1520);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1522 = wp::mul(var_1439, var_2);
        var_1523 = wp::add(var_3, var_1522);
        var_1524 = wp::add(var_1523, var_1521);
        var_1525 = wp::address(var_grouped, var_1524);
        var_1527 = wp::load(var_1525);
        var_1526 = wp::sub(var_1527, var_1440);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1528 = wp::mul(var_1526, var_1526);
        wp::add_inplace(var_5, var_1521, var_1528);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1530 = wp::mul(var_1439, var_2);
        var_1531 = wp::add(var_3, var_1530);
        var_1532 = wp::add(var_1531, var_1529);
        var_1533 = wp::address(var_grouped, var_1532);
        var_1535 = wp::load(var_1533);
        var_1534 = wp::sub(var_1535, var_1440);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1536 = wp::mul(var_1534, var_1534);
        wp::add_inplace(var_5, var_1529, var_1536);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1538 = wp::mul(var_1439, var_2);
        var_1539 = wp::add(var_3, var_1538);
        var_1540 = wp::add(var_1539, var_1537);
        var_1541 = wp::address(var_grouped, var_1540);
        var_1543 = wp::load(var_1541);
        var_1542 = wp::sub(var_1543, var_1440);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1544 = wp::mul(var_1542, var_1542);
        wp::add_inplace(var_5, var_1537, var_1544);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1546 = wp::mul(var_1439, var_2);
        var_1547 = wp::add(var_3, var_1546);
        var_1548 = wp::add(var_1547, var_1545);
        var_1549 = wp::address(var_grouped, var_1548);
        var_1551 = wp::load(var_1549);
        var_1550 = wp::sub(var_1551, var_1440);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1552 = wp::mul(var_1550, var_1550);
        wp::add_inplace(var_5, var_1545, var_1552);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1554 = wp::mul(var_1439, var_2);
        var_1555 = wp::add(var_3, var_1554);
        var_1556 = wp::add(var_1555, var_1553);
        var_1557 = wp::address(var_grouped, var_1556);
        var_1559 = wp::load(var_1557);
        var_1558 = wp::sub(var_1559, var_1440);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1560 = wp::mul(var_1558, var_1558);
        wp::add_inplace(var_5, var_1553, var_1560);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1562 = wp::mul(var_1439, var_2);
        var_1563 = wp::add(var_3, var_1562);
        var_1564 = wp::add(var_1563, var_1561);
        var_1565 = wp::address(var_grouped, var_1564);
        var_1567 = wp::load(var_1565);
        var_1566 = wp::sub(var_1567, var_1440);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1568 = wp::mul(var_1566, var_1566);
        wp::add_inplace(var_5, var_1561, var_1568);
        // x = y[k]                                                                           <L 118>
        var_1570 = wp::extract(var_y, var_1569);
        // for j in range(GROUP):                                                             <L 119>
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1572 = wp::mul(var_1569, var_2);
        var_1573 = wp::add(var_3, var_1572);
        var_1574 = wp::add(var_1573, var_1571);
        var_1575 = wp::address(var_grouped, var_1574);
        var_1577 = wp::load(var_1575);
        var_1576 = wp::sub(var_1577, var_1570);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1578 = wp::mul(var_1576, var_1576);
        wp::add_inplace(var_5, var_1571, var_1578);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1580 = wp::mul(var_1569, var_2);
        var_1581 = wp::add(var_3, var_1580);
        var_1582 = wp::add(var_1581, var_1579);
        var_1583 = wp::address(var_grouped, var_1582);
        var_1585 = wp::load(var_1583);
        var_1584 = wp::sub(var_1585, var_1570);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1586 = wp::mul(var_1584, var_1584);
        wp::add_inplace(var_5, var_1579, var_1586);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1588 = wp::mul(var_1569, var_2);
        var_1589 = wp::add(var_3, var_1588);
        var_1590 = wp::add(var_1589, var_1587);
        var_1591 = wp::address(var_grouped, var_1590);
        var_1593 = wp::load(var_1591);
        var_1592 = wp::sub(var_1593, var_1570);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1594 = wp::mul(var_1592, var_1592);
        wp::add_inplace(var_5, var_1587, var_1594);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1596 = wp::mul(var_1569, var_2);
        var_1597 = wp::add(var_3, var_1596);
        var_1598 = wp::add(var_1597, var_1595);
        var_1599 = wp::address(var_grouped, var_1598);
        var_1601 = wp::load(var_1599);
        var_1600 = wp::sub(var_1601, var_1570);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1602 = wp::mul(var_1600, var_1600);
        wp::add_inplace(var_5, var_1595, var_1602);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1604 = wp::mul(var_1569, var_2);
        var_1605 = wp::add(var_3, var_1604);
        var_1606 = wp::add(var_1605, var_1603);
        var_1607 = wp::address(var_grouped, var_1606);
        var_1609 = wp::load(var_1607);
        var_1608 = wp::sub(var_1609, var_1570);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1610 = wp::mul(var_1608, var_1608);
        wp::add_inplace(var_5, var_1603, var_1610);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1612 = wp::mul(var_1569, var_2);
        var_1613 = wp::add(var_3, var_1612);
        var_1614 = wp::add(var_1613, var_1611);
        var_1615 = wp::address(var_grouped, var_1614);
        var_1617 = wp::load(var_1615);
        var_1616 = wp::sub(var_1617, var_1570);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1618 = wp::mul(var_1616, var_1616);
        wp::add_inplace(var_5, var_1611, var_1618);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1620 = wp::mul(var_1569, var_2);
        var_1621 = wp::add(var_3, var_1620);
        var_1622 = wp::add(var_1621, var_1619);
        var_1623 = wp::address(var_grouped, var_1622);
        var_1625 = wp::load(var_1623);
        var_1624 = wp::sub(var_1625, var_1570);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1626 = wp::mul(var_1624, var_1624);
        wp::add_inplace(var_5, var_1619, var_1626);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1628 = wp::mul(var_1569, var_2);
        var_1629 = wp::add(var_3, var_1628);
        var_1630 = wp::add(var_1629, var_1627);
        var_1631 = wp::address(var_grouped, var_1630);
        var_1633 = wp::load(var_1631);
        var_1632 = wp::sub(var_1633, var_1570);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1634 = wp::mul(var_1632, var_1632);
        wp::add_inplace(var_5, var_1627, var_1634);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1636 = wp::mul(var_1569, var_2);
        var_1637 = wp::add(var_3, var_1636);
        var_1638 = wp::add(var_1637, var_1635);
        var_1639 = wp::address(var_grouped, var_1638);
        var_1641 = wp::load(var_1639);
        var_1640 = wp::sub(var_1641, var_1570);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1642 = wp::mul(var_1640, var_1640);
        wp::add_inplace(var_5, var_1635, var_1642);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1644 = wp::mul(var_1569, var_2);
        var_1645 = wp::add(var_3, var_1644);
        var_1646 = wp::add(var_1645, var_1643);
        var_1647 = wp::address(var_grouped, var_1646);
        var_1649 = wp::load(var_1647);
        var_1648 = wp::sub(var_1649, var_1570);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1650 = wp::mul(var_1648, var_1648);
        wp::add_inplace(var_5, var_1643, var_1650);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1652 = wp::mul(var_1569, var_2);
        var_1653 = wp::add(var_3, var_1652);
        var_1654 = wp::add(var_1653, var_1651);
        var_1655 = wp::address(var_grouped, var_1654);
        var_1657 = wp::load(var_1655);
        var_1656 = wp::sub(var_1657, var_1570);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1658 = wp::mul(var_1656, var_1656);
        wp::add_inplace(var_5, var_1651, var_1658);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1660 = wp::mul(var_1569, var_2);
        var_1661 = wp::add(var_3, var_1660);
        var_1662 = wp::add(var_1661, var_1659);
        var_1663 = wp::address(var_grouped, var_1662);
        var_1665 = wp::load(var_1663);
        var_1664 = wp::sub(var_1665, var_1570);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1666 = wp::mul(var_1664, var_1664);
        wp::add_inplace(var_5, var_1659, var_1666);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1668 = wp::mul(var_1569, var_2);
        var_1669 = wp::add(var_3, var_1668);
        var_1670 = wp::add(var_1669, var_1667);
        var_1671 = wp::address(var_grouped, var_1670);
        var_1673 = wp::load(var_1671);
        var_1672 = wp::sub(var_1673, var_1570);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1674 = wp::mul(var_1672, var_1672);
        wp::add_inplace(var_5, var_1667, var_1674);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1676 = wp::mul(var_1569, var_2);
        var_1677 = wp::add(var_3, var_1676);
        var_1678 = wp::add(var_1677, var_1675);
        var_1679 = wp::address(var_grouped, var_1678);
        var_1681 = wp::load(var_1679);
        var_1680 = wp::sub(var_1681, var_1570);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1682 = wp::mul(var_1680, var_1680);
        wp::add_inplace(var_5, var_1675, var_1682);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1684 = wp::mul(var_1569, var_2);
        var_1685 = wp::add(var_3, var_1684);
        var_1686 = wp::add(var_1685, var_1683);
        var_1687 = wp::address(var_grouped, var_1686);
        var_1689 = wp::load(var_1687);
        var_1688 = wp::sub(var_1689, var_1570);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1690 = wp::mul(var_1688, var_1688);
        wp::add_inplace(var_5, var_1683, var_1690);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1692 = wp::mul(var_1569, var_2);
        var_1693 = wp::add(var_3, var_1692);
        var_1694 = wp::add(var_1693, var_1691);
        var_1695 = wp::address(var_grouped, var_1694);
        var_1697 = wp::load(var_1695);
        var_1696 = wp::sub(var_1697, var_1570);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1698 = wp::mul(var_1696, var_1696);
        wp::add_inplace(var_5, var_1691, var_1698);
        // x = y[k]                                                                           <L 118>
        var_1700 = wp::extract(var_y, var_1699);
        // for j in range(GROUP):                                                             <L 119>
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1702 = wp::mul(var_1699, var_2);
        var_1703 = wp::add(var_3, var_1702);
        var_1704 = wp::add(var_1703, var_1701);
        var_1705 = wp::address(var_grouped, var_1704);
        var_1707 = wp::load(var_1705);
        var_1706 = wp::sub(var_1707, var_1700);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1708 = wp::mul(var_1706, var_1706);
        wp::add_inplace(var_5, var_1701, var_1708);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1710 = wp::mul(var_1699, var_2);
        var_1711 = wp::add(var_3, var_1710);
        var_1712 = wp::add(var_1711, var_1709);
        var_1713 = wp::address(var_grouped, var_1712);
        var_1715 = wp::load(var_1713);
        var_1714 = wp::sub(var_1715, var_1700);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1716 = wp::mul(var_1714, var_1714);
        wp::add_inplace(var_5, var_1709, var_1716);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1718 = wp::mul(var_1699, var_2);
        var_1719 = wp::add(var_3, var_1718);
        var_1720 = wp::add(var_1719, var_1717);
        var_1721 = wp::address(var_grouped, var_1720);
        var_1723 = wp::load(var_1721);
        var_1722 = wp::sub(var_1723, var_1700);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1724 = wp::mul(var_1722, var_1722);
        wp::add_inplace(var_5, var_1717, var_1724);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1726 = wp::mul(var_1699, var_2);
        var_1727 = wp::add(var_3, var_1726);
        var_1728 = wp::add(var_1727, var_1725);
        var_1729 = wp::address(var_grouped, var_1728);
        var_1731 = wp::load(var_1729);
        var_1730 = wp::sub(var_1731, var_1700);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1732 = wp::mul(var_1730, var_1730);
        wp::add_inplace(var_5, var_1725, var_1732);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1734 = wp::mul(var_1699, var_2);
        var_1735 = wp::add(var_3, var_1734);
        var_1736 = wp::add(var_1735, var_1733);
        var_1737 = wp::address(var_grouped, var_1736);
        var_1739 = wp::load(var_1737);
        var_1738 = wp::sub(var_1739, var_1700);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1740 = wp::mul(var_1738, var_1738);
        wp::add_inplace(var_5, var_1733, var_1740);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1742 = wp::mul(var_1699, var_2);
        var_1743 = wp::add(var_3, var_1742);
        var_1744 = wp::add(var_1743, var_1741);
        var_1745 = wp::address(var_grouped, var_1744);
        var_1747 = wp::load(var_1745);
        var_1746 = wp::sub(var_1747, var_1700);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1748 = wp::mul(var_1746, var_1746);
        wp::add_inplace(var_5, var_1741, var_1748);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1750 = wp::mul(var_1699, var_2);
        var_1751 = wp::add(var_3, var_1750);
        var_1752 = wp::add(var_1751, var_1749);
        var_1753 = wp::address(var_grouped, var_1752);
        var_1755 = wp::load(var_1753);
        var_1754 = wp::sub(var_1755, var_1700);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1756 = wp::mul(var_1754, var_1754);
        wp::add_inplace(var_5, var_1749, var_1756);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1758 = wp::mul(var_1699, var_2);
        var_1759 = wp::add(var_3, var_1758);
        var_1760 = wp::add(var_1759, var_1757);
        var_1761 = wp::address(var_grouped, var_1760);
        var_1763 = wp::load(var_1761);
        var_1762 = wp::sub(var_1763, var_1700);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1764 = wp::mul(var_1762, var_1762);
        wp::add_inplace(var_5, var_1757, var_1764);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1766 = wp::mul(var_1699, var_2);
        var_1767 = wp::add(var_3, var_1766);
        var_1768 = wp::add(var_1767, var_1765);
        var_1769 = wp::address(var_grouped, var_1768);
        var_1771 = wp::load(var_1769);
        var_1770 = wp::sub(var_1771, var_1700);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1772 = wp::mul(var_1770, var_1770);
        wp::add_inplace(var_5, var_1765, var_1772);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1774 = wp::mul(var_1699, var_2);
        var_1775 = wp::add(var_3, var_1774);
        var_1776 = wp::add(var_1775, var_1773);
        var_1777 = wp::address(var_grouped, var_1776);
        var_1779 = wp::load(var_1777);
        var_1778 = wp::sub(var_1779, var_1700);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1780 = wp::mul(var_1778, var_1778);
        wp::add_inplace(var_5, var_1773, var_1780);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1782 = wp::mul(var_1699, var_2);
        var_1783 = wp::add(var_3, var_1782);
        var_1784 = wp::add(var_1783, var_1781);
        var_1785 = wp::address(var_grouped, var_1784);
        var_1787 = wp::load(var_1785);
        var_1786 = wp::sub(var_1787, var_1700);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1788 = wp::mul(var_1786, var_1786);
        wp::add_inplace(var_5, var_1781, var_1788);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1790 = wp::mul(var_1699, var_2);
        var_1791 = wp::add(var_3, var_1790);
        var_1792 = wp::add(var_1791, var_1789);
        var_1793 = wp::address(var_grouped, var_1792);
        var_1795 = wp::load(var_1793);
        var_1794 = wp::sub(var_1795, var_1700);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1796 = wp::mul(var_1794, var_1794);
        wp::add_inplace(var_5, var_1789, var_1796);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1798 = wp::mul(var_1699, var_2);
        var_1799 = wp::add(var_3, var_1798);
        var_1800 = wp::add(var_1799, var_1797);
        var_1801 = wp::address(var_grouped, var_1800);
        var_1803 = wp::load(var_1801);
        var_1802 = wp::sub(var_1803, var_1700);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1804 = wp::mul(var_1802, var_1802);
        wp::add_inplace(var_5, var_1797, var_1804);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1806 = wp::mul(var_1699, var_2);
        var_1807 = wp::add(var_3, var_1806);
        var_1808 = wp::add(var_1807, var_1805);
        var_1809 = wp::address(var_grouped, var_1808);
        var_1811 = wp::load(var_1809);
        var_1810 = wp::sub(var_1811, var_1700);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1812 = wp::mul(var_1810, var_1810);
        wp::add_inplace(var_5, var_1805, var_1812);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1814 = wp::mul(var_1699, var_2);
        var_1815 = wp::add(var_3, var_1814);
        var_1816 = wp::add(var_1815, var_1813);
        var_1817 = wp::address(var_grouped, var_1816);
        var_1819 = wp::load(var_1817);
        var_1818 = wp::sub(var_1819, var_1700);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1820 = wp::mul(var_1818, var_1818);
        wp::add_inplace(var_5, var_1813, var_1820);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1822 = wp::mul(var_1699, var_2);
        var_1823 = wp::add(var_3, var_1822);
        var_1824 = wp::add(var_1823, var_1821);
        var_1825 = wp::address(var_grouped, var_1824);
        var_1827 = wp::load(var_1825);
        var_1826 = wp::sub(var_1827, var_1700);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1828 = wp::mul(var_1826, var_1826);
        wp::add_inplace(var_5, var_1821, var_1828);
        // x = y[k]                                                                           <L 118>
        var_1830 = wp::extract(var_y, var_1829);
        // for j in range(GROUP):                                                             <L 119>
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1832 = wp::mul(var_1829, var_2);
        var_1833 = wp::add(var_3, var_1832);
        var_1834 = wp::add(var_1833, var_1831);
        var_1835 = wp::address(var_grouped, var_1834);
        var_1837 = wp::load(var_1835);
        var_1836 = wp::sub(var_1837, var_1830);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1838 = wp::mul(var_1836, var_1836);
        wp::add_inplace(var_5, var_1831, var_1838);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1840 = wp::mul(var_1829, var_2);
        var_1841 = wp::add(var_3, var_1840);
        var_1842 = wp::add(var_1841, var_1839);
        var_1843 = wp::address(var_grouped, var_1842);
        var_1845 = wp::load(var_1843);
        var_1844 = wp::sub(var_1845, var_1830);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1846 = wp::mul(var_1844, var_1844);
        wp::add_inplace(var_5, var_1839, var_1846);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1848 = wp::mul(var_1829, var_2);
        var_1849 = wp::add(var_3, var_1848);
        var_1850 = wp::add(var_1849, var_1847);
        var_1851 = wp::address(var_grouped, var_1850);
        var_1853 = wp::load(var_1851);
        var_1852 = wp::sub(var_1853, var_1830);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1854 = wp::mul(var_1852, var_1852);
        wp::add_inplace(var_5, var_1847, var_1854);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1856 = wp::mul(var_1829, var_2);
        var_1857 = wp::add(var_3, var_1856);
        var_1858 = wp::add(var_1857, var_1855);
        var_1859 = wp::address(var_grouped, var_1858);
        var_1861 = wp::load(var_1859);
        var_1860 = wp::sub(var_1861, var_1830);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1862 = wp::mul(var_1860, var_1860);
        wp::add_inplace(var_5, var_1855, var_1862);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1864 = wp::mul(var_1829, var_2);
        var_1865 = wp::add(var_3, var_1864);
        var_1866 = wp::add(var_1865, var_1863);
        var_1867 = wp::address(var_grouped, var_1866);
        var_1869 = wp::load(var_1867);
        var_1868 = wp::sub(var_1869, var_1830);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1870 = wp::mul(var_1868, var_1868);
        wp::add_inplace(var_5, var_1863, var_1870);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1872 = wp::mul(var_1829, var_2);
        var_1873 = wp::add(var_3, var_1872);
        var_1874 = wp::add(var_1873, var_1871);
        var_1875 = wp::address(var_grouped, var_1874);
        var_1877 = wp::load(var_1875);
        var_1876 = wp::sub(var_1877, var_1830);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1878 = wp::mul(var_1876, var_1876);
        wp::add_inplace(var_5, var_1871, var_1878);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1880 = wp::mul(var_1829, var_2);
        var_1881 = wp::add(var_3, var_1880);
        var_1882 = wp::add(var_1881, var_1879);
        var_1883 = wp::address(var_grouped, var_1882);
        var_1885 = wp::load(var_1883);
        var_1884 = wp::sub(var_1885, var_1830);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1886 = wp::mul(var_1884, var_1884);
        wp::add_inplace(var_5, var_1879, var_1886);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1888 = wp::mul(var_1829, var_2);
        var_1889 = wp::add(var_3, var_1888);
        var_1890 = wp::add(var_1889, var_1887);
        var_1891 = wp::address(var_grouped, var_1890);
        var_1893 = wp::load(var_1891);
        var_1892 = wp::sub(var_1893, var_1830);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1894 = wp::mul(var_1892, var_1892);
        wp::add_inplace(var_5, var_1887, var_1894);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1896 = wp::mul(var_1829, var_2);
        var_1897 = wp::add(var_3, var_1896);
        var_1898 = wp::add(var_1897, var_1895);
        var_1899 = wp::address(var_grouped, var_1898);
        var_1901 = wp::load(var_1899);
        var_1900 = wp::sub(var_1901, var_1830);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1902 = wp::mul(var_1900, var_1900);
        wp::add_inplace(var_5, var_1895, var_1902);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1904 = wp::mul(var_1829, var_2);
        var_1905 = wp::add(var_3, var_1904);
        var_1906 = wp::add(var_1905, var_1903);
        var_1907 = wp::address(var_grouped, var_1906);
        var_1909 = wp::load(var_1907);
        var_1908 = wp::sub(var_1909, var_1830);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1910 = wp::mul(var_1908, var_1908);
        wp::add_inplace(var_5, var_1903, var_1910);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1912 = wp::mul(var_1829, var_2);
        var_1913 = wp::add(var_3, var_1912);
        var_1914 = wp::add(var_1913, var_1911);
        var_1915 = wp::address(var_grouped, var_1914);
        var_1917 = wp::load(var_1915);
        var_1916 = wp::sub(var_1917, var_1830);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1918 = wp::mul(var_1916, var_1916);
        wp::add_inplace(var_5, var_1911, var_1918);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1920 = wp::mul(var_1829, var_2);
        var_1921 = wp::add(var_3, var_1920);
        var_1922 = wp::add(var_1921, var_1919);
        var_1923 = wp::address(var_grouped, var_1922);
        var_1925 = wp::load(var_1923);
        var_1924 = wp::sub(var_1925, var_1830);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1926 = wp::mul(var_1924, var_1924);
        wp::add_inplace(var_5, var_1919, var_1926);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1928 = wp::mul(var_1829, var_2);
        var_1929 = wp::add(var_3, var_1928);
        var_1930 = wp::add(var_1929, var_1927);
        var_1931 = wp::address(var_grouped, var_1930);
        var_1933 = wp::load(var_1931);
        var_1932 = wp::sub(var_1933, var_1830);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1934 = wp::mul(var_1932, var_1932);
        wp::add_inplace(var_5, var_1927, var_1934);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1936 = wp::mul(var_1829, var_2);
        var_1937 = wp::add(var_3, var_1936);
        var_1938 = wp::add(var_1937, var_1935);
        var_1939 = wp::address(var_grouped, var_1938);
        var_1941 = wp::load(var_1939);
        var_1940 = wp::sub(var_1941, var_1830);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1942 = wp::mul(var_1940, var_1940);
        wp::add_inplace(var_5, var_1935, var_1942);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1944 = wp::mul(var_1829, var_2);
        var_1945 = wp::add(var_3, var_1944);
        var_1946 = wp::add(var_1945, var_1943);
        var_1947 = wp::address(var_grouped, var_1946);
        var_1949 = wp::load(var_1947);
        var_1948 = wp::sub(var_1949, var_1830);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1950 = wp::mul(var_1948, var_1948);
        wp::add_inplace(var_5, var_1943, var_1950);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1952 = wp::mul(var_1829, var_2);
        var_1953 = wp::add(var_3, var_1952);
        var_1954 = wp::add(var_1953, var_1951);
        var_1955 = wp::address(var_grouped, var_1954);
        var_1957 = wp::load(var_1955);
        var_1956 = wp::sub(var_1957, var_1830);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1958 = wp::mul(var_1956, var_1956);
        wp::add_inplace(var_5, var_1951, var_1958);
        // x = y[k]                                                                           <L 118>
        var_1960 = wp::extract(var_y, var_1959);
        // for j in range(GROUP):                                                             <L 119>
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1962 = wp::mul(var_1959, var_2);
        var_1963 = wp::add(var_3, var_1962);
        var_1964 = wp::add(var_1963, var_1961);
        var_1965 = wp::address(var_grouped, var_1964);
        var_1967 = wp::load(var_1965);
        var_1966 = wp::sub(var_1967, var_1960);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1968 = wp::mul(var_1966, var_1966);
        wp::add_inplace(var_5, var_1961, var_1968);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1970 = wp::mul(var_1959, var_2);
        var_1971 = wp::add(var_3, var_1970);
        var_1972 = wp::add(var_1971, var_1969);
        var_1973 = wp::address(var_grouped, var_1972);
        var_1975 = wp::load(var_1973);
        var_1974 = wp::sub(var_1975, var_1960);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1976 = wp::mul(var_1974, var_1974);
        wp::add_inplace(var_5, var_1969, var_1976);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1978 = wp::mul(var_1959, var_2);
        var_1979 = wp::add(var_3, var_1978);
        var_1980 = wp::add(var_1979, var_1977);
        var_1981 = wp::address(var_grouped, var_1980);
        var_1983 = wp::load(var_1981);
        var_1982 = wp::sub(var_1983, var_1960);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1984 = wp::mul(var_1982, var_1982);
        wp::add_inplace(var_5, var_1977, var_1984);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1986 = wp::mul(var_1959, var_2);
        var_1987 = wp::add(var_3, var_1986);
        var_1988 = wp::add(var_1987, var_1985);
        var_1989 = wp::address(var_grouped, var_1988);
        var_1991 = wp::load(var_1989);
        var_1990 = wp::sub(var_1991, var_1960);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_1992 = wp::mul(var_1990, var_1990);
        wp::add_inplace(var_5, var_1985, var_1992);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_1994 = wp::mul(var_1959, var_2);
        var_1995 = wp::add(var_3, var_1994);
        var_1996 = wp::add(var_1995, var_1993);
        var_1997 = wp::address(var_grouped, var_1996);
        var_1999 = wp::load(var_1997);
        var_1998 = wp::sub(var_1999, var_1960);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_2000 = wp::mul(var_1998, var_1998);
        wp::add_inplace(var_5, var_1993, var_2000);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_2002 = wp::mul(var_1959, var_2);
        var_2003 = wp::add(var_3, var_2002);
        var_2004 = wp::add(var_2003, var_2001);
        var_2005 = wp::address(var_grouped, var_2004);
        var_2007 = wp::load(var_2005);
        var_2006 = wp::sub(var_2007, var_1960);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_2008 = wp::mul(var_2006, var_2006);
        wp::add_inplace(var_5, var_2001, var_2008);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_2010 = wp::mul(var_1959, var_2);
        var_2011 = wp::add(var_3, var_2010);
        var_2012 = wp::add(var_2011, var_2009);
        var_2013 = wp::address(var_grouped, var_2012);
        var_2015 = wp::load(var_2013);
        var_2014 = wp::sub(var_2015, var_1960);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_2016 = wp::mul(var_2014, var_2014);
        wp::add_inplace(var_5, var_2009, var_2016);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_2018 = wp::mul(var_1959, var_2);
        var_2019 = wp::add(var_3, var_2018);
        var_2020 = wp::add(var_2019, var_2017);
        var_2021 = wp::address(var_grouped, var_2020);
        var_2023 = wp::load(var_2021);
        var_2022 = wp::sub(var_2023, var_1960);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_2024 = wp::mul(var_2022, var_2022);
        wp::add_inplace(var_5, var_2017, var_2024);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_2026 = wp::mul(var_1959, var_2);
        var_2027 = wp::add(var_3, var_2026);
        var_2028 = wp::add(var_2027, var_2025);
        var_2029 = wp::address(var_grouped, var_2028);
        var_2031 = wp::load(var_2029);
        var_2030 = wp::sub(var_2031, var_1960);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_2032 = wp::mul(var_2030, var_2030);
        wp::add_inplace(var_5, var_2025, var_2032);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_2034 = wp::mul(var_1959, var_2);
        var_2035 = wp::add(var_3, var_2034);
        var_2036 = wp::add(var_2035, var_2033);
        var_2037 = wp::address(var_grouped, var_2036);
        var_2039 = wp::load(var_2037);
        var_2038 = wp::sub(var_2039, var_1960);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_2040 = wp::mul(var_2038, var_2038);
        wp::add_inplace(var_5, var_2033, var_2040);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_2042 = wp::mul(var_1959, var_2);
        var_2043 = wp::add(var_3, var_2042);
        var_2044 = wp::add(var_2043, var_2041);
        var_2045 = wp::address(var_grouped, var_2044);
        var_2047 = wp::load(var_2045);
        var_2046 = wp::sub(var_2047, var_1960);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_2048 = wp::mul(var_2046, var_2046);
        wp::add_inplace(var_5, var_2041, var_2048);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_2050 = wp::mul(var_1959, var_2);
        var_2051 = wp::add(var_3, var_2050);
        var_2052 = wp::add(var_2051, var_2049);
        var_2053 = wp::address(var_grouped, var_2052);
        var_2055 = wp::load(var_2053);
        var_2054 = wp::sub(var_2055, var_1960);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_2056 = wp::mul(var_2054, var_2054);
        wp::add_inplace(var_5, var_2049, var_2056);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_2058 = wp::mul(var_1959, var_2);
        var_2059 = wp::add(var_3, var_2058);
        var_2060 = wp::add(var_2059, var_2057);
        var_2061 = wp::address(var_grouped, var_2060);
        var_2063 = wp::load(var_2061);
        var_2062 = wp::sub(var_2063, var_1960);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_2064 = wp::mul(var_2062, var_2062);
        wp::add_inplace(var_5, var_2057, var_2064);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_2066 = wp::mul(var_1959, var_2);
        var_2067 = wp::add(var_3, var_2066);
        var_2068 = wp::add(var_2067, var_2065);
        var_2069 = wp::address(var_grouped, var_2068);
        var_2071 = wp::load(var_2069);
        var_2070 = wp::sub(var_2071, var_1960);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_2072 = wp::mul(var_2070, var_2070);
        wp::add_inplace(var_5, var_2065, var_2072);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_2074 = wp::mul(var_1959, var_2);
        var_2075 = wp::add(var_3, var_2074);
        var_2076 = wp::add(var_2075, var_2073);
        var_2077 = wp::address(var_grouped, var_2076);
        var_2079 = wp::load(var_2077);
        var_2078 = wp::sub(var_2079, var_1960);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_2080 = wp::mul(var_2078, var_2078);
        wp::add_inplace(var_5, var_2073, var_2080);
        // gap = grouped[at + k * GROUP + j] - x                                              <L 120>
        var_2082 = wp::mul(var_1959, var_2);
        var_2083 = wp::add(var_3, var_2082);
        var_2084 = wp::add(var_2083, var_2081);
        var_2085 = wp::address(var_grouped, var_2084);
        var_2087 = wp::load(var_2085);
        var_2086 = wp::sub(var_2087, var_1960);
        // sqdists[j] += gap * gap                                                            <L 121>
        var_2088 = wp::mul(var_2086, var_2086);
        wp::add_inplace(var_5, var_2081, var_2088);
        // bits = lanes_within(sqdists, limit)                                                <L 122>
        var_2089 = lanes_within_0(var_5, var_limit);
    }
    var_2090 = wp::where(var_788, var_1959, var_656);
    var_2091 = wp::where(var_788, var_1960, var_657);
    var_2092 = wp::where(var_788, var_2081, var_778);
    var_2093 = wp::where(var_788, var_2086, var_783);
    var_2094 = wp::where(var_788, var_2089, var_786);
    // return bits                                                                            <L 123>
    return var_2094;
}


// /work/main/src/pointloom/kernels/features/feature_matching.py:52
static CUDA_CALLABLE wp::float32 square_distance_1(
    wp::int32 var_a,
    wp::array_t<wp::float32> var_some,
    wp::int32 var_b,
    wp::array_t<wp::float32> var_others,
    wp::int32 var_width)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 0.0;
    wp::vec_t<8, wp::float32> var_1;
    const wp::int32 var_2 = 8;
    wp::int32 var_3;
    wp::range_t var_4;
    wp::int32 var_5;
    const wp::int32 var_6 = 0;
    wp::int32 var_7;
    wp::int32 var_8;
    wp::int32 var_9;
    wp::float32* var_10;
    wp::int32 var_11;
    wp::int32 var_12;
    wp::int32 var_13;
    wp::float32* var_14;
    wp::float32 var_15;
    wp::float32 var_16;
    wp::float32 var_17;
    wp::float32 var_18;
    const wp::int32 var_19 = 1;
    wp::int32 var_20;
    wp::int32 var_21;
    wp::int32 var_22;
    wp::float32* var_23;
    wp::int32 var_24;
    wp::int32 var_25;
    wp::int32 var_26;
    wp::float32* var_27;
    wp::float32 var_28;
    wp::float32 var_29;
    wp::float32 var_30;
    wp::float32 var_31;
    const wp::int32 var_32 = 2;
    wp::int32 var_33;
    wp::int32 var_34;
    wp::int32 var_35;
    wp::float32* var_36;
    wp::int32 var_37;
    wp::int32 var_38;
    wp::int32 var_39;
    wp::float32* var_40;
    wp::float32 var_41;
    wp::float32 var_42;
    wp::float32 var_43;
    wp::float32 var_44;
    const wp::int32 var_45 = 3;
    wp::int32 var_46;
    wp::int32 var_47;
    wp::int32 var_48;
    wp::float32* var_49;
    wp::int32 var_50;
    wp::int32 var_51;
    wp::int32 var_52;
    wp::float32* var_53;
    wp::float32 var_54;
    wp::float32 var_55;
    wp::float32 var_56;
    wp::float32 var_57;
    const wp::int32 var_58 = 4;
    wp::int32 var_59;
    wp::int32 var_60;
    wp::int32 var_61;
    wp::float32* var_62;
    wp::int32 var_63;
    wp::int32 var_64;
    wp::int32 var_65;
    wp::float32* var_66;
    wp::float32 var_67;
    wp::float32 var_68;
    wp::float32 var_69;
    wp::float32 var_70;
    const wp::int32 var_71 = 5;
    wp::int32 var_72;
    wp::int32 var_73;
    wp::int32 var_74;
    wp::float32* var_75;
    wp::int32 var_76;
    wp::int32 var_77;
    wp::int32 var_78;
    wp::float32* var_79;
    wp::float32 var_80;
    wp::float32 var_81;
    wp::float32 var_82;
    wp::float32 var_83;
    const wp::int32 var_84 = 6;
    wp::int32 var_85;
    wp::int32 var_86;
    wp::int32 var_87;
    wp::float32* var_88;
    wp::int32 var_89;
    wp::int32 var_90;
    wp::int32 var_91;
    wp::float32* var_92;
    wp::float32 var_93;
    wp::float32 var_94;
    wp::float32 var_95;
    wp::float32 var_96;
    const wp::int32 var_97 = 7;
    wp::int32 var_98;
    wp::int32 var_99;
    wp::int32 var_100;
    wp::float32* var_101;
    wp::int32 var_102;
    wp::int32 var_103;
    wp::int32 var_104;
    wp::float32* var_105;
    wp::float32 var_106;
    wp::float32 var_107;
    wp::float32 var_108;
    wp::float32 var_109;
    const wp::int32 var_110 = 0;
    wp::float32 var_111;
    const wp::int32 var_112 = 4;
    wp::float32 var_113;
    wp::float32 var_114;
    const wp::int32 var_115 = 2;
    wp::float32 var_116;
    const wp::int32 var_117 = 6;
    wp::float32 var_118;
    wp::float32 var_119;
    wp::float32 var_120;
    const wp::int32 var_121 = 1;
    wp::float32 var_122;
    const wp::int32 var_123 = 5;
    wp::float32 var_124;
    wp::float32 var_125;
    const wp::int32 var_126 = 3;
    wp::float32 var_127;
    const wp::int32 var_128 = 7;
    wp::float32 var_129;
    wp::float32 var_130;
    wp::float32 var_131;
    wp::float32 var_132;
    //---------
    // forward
    // def square_distance(a: int, some: array(dtype=float32), b: int, others: array(dtype=float32), width: int) -> float:       <L 53>
    // sums = eight(0.0)                                                                      <L 55>
    var_1 = wp::vec_t<8, wp::float32>(var_0);
    // for c in range(width // STEP):                                                         <L 56>
    var_3 = wp::floordiv(var_width, var_2);
    var_4 = wp::range(var_3);
    start_for_0:;
        if (iter_cmp(var_4) == 0) goto end_for_0;
        var_5 = wp::iter_next(var_4);
        // for j in range(STEP):                                                              <L 57>
        // gap = some[a + c * STEP + j] - others[b + c * STEP + j]                            <L 58>
        var_7 = wp::mul(var_5, var_2);
        var_8 = wp::add(var_a, var_7);
        var_9 = wp::add(var_8, var_6);
        var_10 = wp::address(var_some, var_9);
        var_11 = wp::mul(var_5, var_2);
        var_12 = wp::add(var_b, var_11);
        var_13 = wp::add(var_12, var_6);
        var_14 = wp::address(var_others, var_13);
        var_16 = wp::load(var_10);
        var_17 = wp::load(var_14);
        var_15 = wp::sub(var_16, var_17);
        // sums[j] += gap * gap                                                               <L 59>
        var_18 = wp::mul(var_15, var_15);
        wp::add_inplace(var_1, var_6, var_18);
        // gap = some[a + c * STEP + j] - others[b + c * STEP + j]                            <L 58>
        var_20 = wp::mul(var_5, var_2);
        var_21 = wp::add(var_a, var_20);
        var_22 = wp::add(var_21, var_19);
        var_23 = wp::address(var_some, var_22);
        var_24 = wp::mul(var_5, var_2);
        var_25 = wp::add(var_b, var_24);
        var_26 = wp::add(var_25, var_19);
        var_27 = wp::address(var_others, var_26);
        var_29 = wp::load(var_23);
        var_30 = wp::load(var_27);
        var_28 = wp::sub(var_29, var_30);
        // sums[j] += gap * gap                                                               <L 59>
        var_31 = wp::mul(var_28, var_28);
        wp::add_inplace(var_1, var_19, var_31);
        // gap = some[a + c * STEP + j] - others[b + c * STEP + j]                            <L 58>
        var_33 = wp::mul(var_5, var_2);
        var_34 = wp::add(var_a, var_33);
        var_35 = wp::add(var_34, var_32);
        var_36 = wp::address(var_some, var_35);
        var_37 = wp::mul(var_5, var_2);
        var_38 = wp::add(var_b, var_37);
        var_39 = wp::add(var_38, var_32);
        var_40 = wp::address(var_others, var_39);
        var_42 = wp::load(var_36);
        var_43 = wp::load(var_40);
        var_41 = wp::sub(var_42, var_43);
        // sums[j] += gap * gap                                                               <L 59>
        var_44 = wp::mul(var_41, var_41);
        wp::add_inplace(var_1, var_32, var_44);
        // gap = some[a + c * STEP + j] - others[b + c * STEP + j]                            <L 58>
        var_46 = wp::mul(var_5, var_2);
        var_47 = wp::add(var_a, var_46);
        var_48 = wp::add(var_47, var_45);
        var_49 = wp::address(var_some, var_48);
        var_50 = wp::mul(var_5, var_2);
        var_51 = wp::add(var_b, var_50);
        var_52 = wp::add(var_51, var_45);
        var_53 = wp::address(var_others, var_52);
        var_55 = wp::load(var_49);
        var_56 = wp::load(var_53);
        var_54 = wp::sub(var_55, var_56);
        // sums[j] += gap * gap                                                               <L 59>
        var_57 = wp::mul(var_54, var_54);
        wp::add_inplace(var_1, var_45, var_57);
        // gap = some[a + c * STEP + j] - others[b + c * STEP + j]                            <L 58>
        var_59 = wp::mul(var_5, var_2);
        var_60 = wp::add(var_a, var_59);
        var_61 = wp::add(var_60, var_58);
        var_62 = wp::address(var_some, var_61);
        var_63 = wp::mul(var_5, var_2);
        var_64 = wp::add(var_b, var_63);
        var_65 = wp::add(var_64, var_58);
        var_66 = wp::address(var_others, var_65);
        var_68 = wp::load(var_62);
        var_69 = wp::load(var_66);
        var_67 = wp::sub(var_68, var_69);
        // sums[j] += gap * gap                                                               <L 59>
        var_70 = wp::mul(var_67, var_67);
        wp::add_inplace(var_1, var_58, var_70);
        // gap = some[a + c * STEP + j] - others[b + c * STEP + j]                            <L 58>
        var_72 = wp::mul(var_5, var_2);
        var_73 = wp::add(var_a, var_72);
        var_74 = wp::add(var_73, var_71);
        var_75 = wp::address(var_some, var_74);
        var_76 = wp::mul(var_5, var_2);
        var_77 = wp::add(var_b, var_76);
        var_78 = wp::add(var_77, var_71);
        var_79 = wp::address(var_others, var_78);
        var_81 = wp::load(var_75);
        var_82 = wp::load(var_79);
        var_80 = wp::sub(var_81, var_82);
        // sums[j] += gap * gap                                                               <L 59>
        var_83 = wp::mul(var_80, var_80);
        wp::add_inplace(var_1, var_71, var_83);
        // gap = some[a + c * STEP + j] - others[b + c * STEP + j]                            <L 58>
        var_85 = wp::mul(var_5, var_2);
        var_86 = wp::add(var_a, var_85);
        var_87 = wp::add(var_86, var_84);
        var_88 = wp::address(var_some, var_87);
        var_89 = wp::mul(var_5, var_2);
        var_90 = wp::add(var_b, var_89);
        var_91 = wp::add(var_90, var_84);
        var_92 = wp::address(var_others, var_91);
        var_94 = wp::load(var_88);
        var_95 = wp::load(var_92);
        var_93 = wp::sub(var_94, var_95);
        // sums[j] += gap * gap                                                               <L 59>
        var_96 = wp::mul(var_93, var_93);
        wp::add_inplace(var_1, var_84, var_96);
        // gap = some[a + c * STEP + j] - others[b + c * STEP + j]                            <L 58>
        var_98 = wp::mul(var_5, var_2);
        var_99 = wp::add(var_a, var_98);
        var_100 = wp::add(var_99, var_97);
        var_101 = wp::address(var_some, var_100);
        var_102 = wp::mul(var_5, var_2);
        var_103 = wp::add(var_b, var_102);
        var_104 = wp::add(var_103, var_97);
        var_105 = wp::address(var_others, var_104);
        var_107 = wp::load(var_101);
        var_108 = wp::load(var_105);
        var_106 = wp::sub(var_107, var_108);
        // sums[j] += gap * gap                                                               <L 59>
        var_109 = wp::mul(var_106, var_106);
        wp::add_inplace(var_1, var_97, var_109);
        goto start_for_0;
    end_for_0:;
    // return ((sums[0] + sums[4]) + (sums[2] + sums[6])) + ((sums[1] + sums[5]) + (sums[3] + sums[7]))       <L 60>
    var_111 = wp::extract(var_1, var_110);
    var_113 = wp::extract(var_1, var_112);
    var_114 = wp::add(var_111, var_113);
    var_116 = wp::extract(var_1, var_115);
    var_118 = wp::extract(var_1, var_117);
    var_119 = wp::add(var_116, var_118);
    var_120 = wp::add(var_114, var_119);
    var_122 = wp::extract(var_1, var_121);
    var_124 = wp::extract(var_1, var_123);
    var_125 = wp::add(var_122, var_124);
    var_127 = wp::extract(var_1, var_126);
    var_129 = wp::extract(var_1, var_128);
    var_130 = wp::add(var_127, var_129);
    var_131 = wp::add(var_125, var_130);
    var_132 = wp::add(var_120, var_131);
    return var_132;
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


// <pointloom.kernels.arrays.packed_keys.pack_bits>:1
static CUDA_CALLABLE wp::int64 pack_bits_0(
    wp::int32 var_bits,
    wp::int32 var_index)
{
    //---------
    // primal vars
    wp::int64 var_0;
    wp::int64 var_1;
    wp::int64 var_2;
    wp::int64 var_3;
    wp::int64 var_4;
    //---------
    // forward
    // def pack_bits(bits, index):                                                            <L 1>
    // return int64(bits) << int64(32) | int64(index)                                         <L 3>
    var_0 = wp::int64(var_bits);
    var_1 = 32ll;
    var_2 = wp::lshift(var_0, var_1);
    var_3 = wp::int64(var_index);
    var_4 = wp::bit_or(var_2, var_3);
    return var_4;
}


// /work/main/src/pointloom/kernels/arrays/packed_keys.py:18
static CUDA_CALLABLE wp::int64 pack_key_0(
    wp::float32 var_number,
    wp::int32 var_index)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int64 var_1;
    //---------
    // forward
    // def pack_key(number: float, index: int) -> int64:                                      <L 19>
    // return pack_bits(float_bits(number), index)                                            <L 20>
    var_0 = _float_bits_0(var_number);
    var_1 = pack_bits_0(var_0, var_index);
    return var_1;
}


// <pointloom.kernels.features.feature_matching.offer_group>:1
static CUDA_CALLABLE wp::vec_t<2, wp::int64> offer_group_0(
    wp::int32 var_group,
    wp::vec_t<16, wp::float32> var_y,
    wp::float32 var_limit,
    wp::int32 var_position,
    wp::array_t<wp::float32> var_queries__packed,
    wp::int32 var_tree__width,
    wp::array_t<wp::int32> var_tree__labels,
    wp::array_t<wp::float32> var_tree__packed,
    wp::array_t<wp::float32> var_tree__grouped,
    wp::array_t<wp::int32> var_tree__alike,
    wp::vec_t<2, wp::int64> var_keys)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int64 var_1;
    const wp::int32 var_2 = 1;
    wp::int64 var_3;
    const wp::int32 var_4 = 0;
    wp::int32 var_5;
    wp::int32* var_6;
    const wp::int32 var_7 = 2;
    bool var_8;
    wp::int32 var_9;
    wp::int32 var_10;
    wp::int32* var_11;
    const wp::int32 var_12 = 1;
    bool var_13;
    wp::int32 var_14;
    const wp::int32 var_15 = 3;
    wp::int32 var_16;
    wp::int32 var_17;
    wp::int32 var_18;
    const wp::int32 var_19 = 0;
    bool var_20;
    wp::int32 var_21;
    wp::int32 var_22;
    wp::int32 var_23;
    const wp::int32 var_24 = 16;
    wp::int32 var_25;
    const wp::int32 var_26 = 1;
    wp::int32 var_27;
    wp::int32 var_28;
    wp::int32 var_29;
    wp::int32 var_30;
    wp::int32 var_31;
    wp::float32 var_32;
    wp::int32* var_33;
    wp::int64 var_34;
    wp::int32 var_35;
    bool var_36;
    wp::int64 var_37;
    wp::int64 var_38;
    bool var_39;
    wp::int64 var_40;
    wp::int64 var_41;
    wp::int64 var_42;
    wp::int64 var_43;
    wp::vec_t<2, wp::int64> var_44;
    //---------
    // forward
    // def offer_group(group, y, limit, position, queries__packed, tree__width, tree__labels, tree__packed, tree__grouped, tree__alike, keys):       <L 1>
    // best = keys[0]                                                                         <L 3>
    var_1 = wp::extract(var_keys, var_0);
    // next_best = keys[1]                                                                    <L 4>
    var_3 = wp::extract(var_keys, var_2);
    // left = int(0)                                                                          <L 5>
    var_5 = wp::int(var_4);
    // if tree__alike[group] != REPEATED:                                                     <L 6>
    var_6 = wp::address(var_tree__alike, var_group);
    var_9 = wp::load(var_6);
    var_8 = (var_9 != var_7);
    if (var_8) {
        // left = rows_within(group, tree__grouped, y, limit)                                 <L 7>
        var_10 = rows_within_0(var_group, var_tree__grouped, var_y, var_limit);
        // if tree__alike[group] == EQUAL:                                                    <L 8>
        var_11 = wp::address(var_tree__alike, var_group);
        var_14 = wp::load(var_11);
        var_13 = (var_14 == var_12);
        if (var_13) {
            // left = left & FIRST_TWO                                                        <L 9>
            var_16 = wp::bit_and(var_10, var_15);
        }
        var_17 = wp::where(var_13, var_16, var_10);
    }
    var_18 = wp::where(var_8, var_17, var_5);
    // while left != 0:                                                                       <L 10>
    start_while_0:;
    var_20 = (var_18 != var_19);
    if ((var_20) == false) goto end_while_0;
        // lowest = left & -left                                                              <L 11>
        var_21 = wp::neg(var_18);
        var_22 = wp::bit_and(var_18, var_21);
        // left = left ^ lowest                                                               <L 12>
        var_23 = wp::bit_xor(var_18, var_22);
        // row = group * GROUP + bit_count(lowest - 1)                                        <L 13>
        var_25 = wp::mul(var_group, var_24);
        var_27 = wp::sub(var_22, var_26);
        var_28 = wp::bit_count(var_27);
        var_29 = wp::add(var_25, var_28);
        // sqdist = square_distance(position * tree__width, queries__packed, row * tree__width, tree__packed, tree__width)       <L 14>
        var_30 = wp::mul(var_position, var_tree__width);
        var_31 = wp::mul(var_29, var_tree__width);
        var_32 = square_distance_1(var_30, var_queries__packed, var_31, var_tree__packed, var_tree__width);
        // key = pack_key(sqdist, tree__labels[row])                                          <L 15>
        var_33 = wp::address(var_tree__labels, var_29);
        var_35 = wp::load(var_33);
        var_34 = pack_key_0(var_32, var_35);
        // if key < best:                                                                     <L 16>
        var_36 = (var_34 < var_1);
        if (var_36) {
            // next_best = best                                                               <L 17>
            var_37 = wp::copy(var_1);
            // best = key                                                                     <L 18>
            var_38 = wp::copy(var_34);
        }
        if (!var_36) {
            // elif key < next_best:                                                          <L 19>
            var_39 = (var_34 < var_3);
            if (var_39) {
                // next_best = key                                                            <L 20>
                var_40 = wp::copy(var_34);
            }
            var_41 = wp::where(var_39, var_40, var_3);
        }
        var_42 = wp::where(var_36, var_38, var_1);
        var_43 = wp::where(var_36, var_37, var_41);
        wp::assign(var_1, var_42);
        wp::assign(var_3, var_43);
        wp::assign(var_18, var_23);
    goto start_while_0;
    end_while_0:;
    // return closest(best, next_best)                                                        <L 21>
    var_44 = wp::vec_t<2, wp::int64>(var_1, var_3);
    return var_44;
}


// <pointloom.kernels.features.feature_matching.search_rows>:1
static CUDA_CALLABLE wp::vec_t<2, wp::int64> search_rows_0(
    wp::vec_t<16, wp::float32> var_y,
    wp::int32 var_position,
    wp::array_t<wp::float32> var_queries__packed,
    wp::int32 var_tree__width,
    wp::array_t<wp::int32> var_tree__labels,
    wp::array_t<wp::float32> var_tree__packed,
    wp::array_t<wp::float32> var_tree__grouped,
    wp::array_t<wp::int32> var_tree__alike,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::int32 var_tree__roots,
    wp::int32 var_tree__second,
    wp::int32 var_tree__third,
    wp::vec_t<2, wp::int64> var_keys,
    wp::int32 var_searched,
    wp::int32 var_counted,
    wp::int32 var_stop,
    wp::float32 var_slack,
    wp::float32 var_margin)
{
    //---------
    // primal vars
    wp::vec_t<2, wp::int64> var_0;
    wp::int64 var_1;
    wp::float32 var_2;
    const wp::int32 var_3 = 1;
    wp::int32 var_4;
    wp::range_t var_5;
    wp::int32 var_6;
    wp::int32 var_7;
    const wp::int32 var_8 = 3;
    wp::int32 var_9;
    wp::int32 var_10;
    wp::vec_t<16, wp::float32> var_11;
    wp::int32 var_12;
    wp::int64 var_13;
    wp::int64 var_14;
    wp::int64 var_15;
    bool var_16;
    wp::int64 var_17;
    bool var_18;
    const wp::int32 var_19 = 1;
    bool var_20;
    const wp::int32 var_21 = 16;
    const wp::int32 var_22 = 1;
    wp::int32 var_23;
    wp::int32 var_24;
    wp::int64 var_25;
    wp::int64 var_26;
    wp::int32 var_27;
    const wp::int32 var_28 = 65535;
    wp::int32 var_29;
    const wp::int32 var_30 = 0;
    bool var_31;
    wp::int32 var_32;
    const wp::int32 var_33 = 1;
    wp::int32 var_34;
    wp::int32 var_35;
    wp::int32 var_36;
    wp::int64 var_37;
    wp::int64 var_38;
    wp::int64 var_39;
    wp::int32 var_40;
    const wp::int32 var_41 = 1;
    wp::int32 var_42;
    wp::int32 var_43;
    wp::int32 var_44;
    const wp::int32 var_45 = 1;
    bool var_46;
    wp::int32 var_47;
    const wp::int32 var_48 = 1;
    wp::int32 var_49;
    const wp::int32 var_50 = 1;
    bool var_51;
    const wp::int32 var_52 = 0;
    wp::int32 var_53;
    wp::int32 var_54;
    wp::vec_t<16, wp::float32> var_55;
    wp::int32 var_56;
    wp::int64 var_57;
    const wp::int32 var_58 = 1;
    wp::int32 var_59;
    wp::int32 var_60;
    wp::int64 var_61;
    wp::int64 var_62;
    wp::int64 var_63;
    bool var_64;
    wp::vec_t<2, wp::int64> var_65;
    wp::int64 var_66;
    wp::int64 var_67;
    bool var_68;
    wp::int64 var_69;
    wp::float32 var_70;
    wp::vec_t<16, wp::float32> var_71;
    wp::int32 var_72;
    wp::int64 var_73;
    wp::int64 var_74;
    wp::int64 var_75;
    wp::int64 var_76;
    const wp::int32 var_77 = 1;
    wp::int32 var_78;
    wp::float32 var_79;
    wp::int32 var_80;
    wp::int64 var_81;
    wp::vec_t<2, wp::int64> var_82;
    wp::vec_t<2, wp::int64> var_83;
    wp::float32 var_84;
    wp::int32 var_85;
    wp::int64 var_86;
    wp::vec_t<2, wp::int64> var_87;
    wp::float32 var_88;
    wp::int32 var_89;
    wp::int32 var_90;
    wp::int32 var_91;
    wp::int64 var_92;
    wp::int32 var_93;
    wp::vec_t<2, wp::int64> var_94;
    wp::float32 var_95;
    wp::int32 var_96;
    wp::int32 var_97;
    wp::int32 var_98;
    wp::int64 var_99;
    //---------
    // forward
    // def search_rows(y, position, queries__packed, tree__width, tree__labels, tree__packed, tree__grouped, tree__alike, tree__boxes, tree__roots, tree__second, tree__third, keys, searched, counted, stop, slack, margin):       <L 1>
    // updated = keys                                                                         <L 3>
    var_0 = wp::copy(var_keys);
    // limit = limit_of(updated[counted], slack, margin)                                      <L 4>
    var_1 = wp::extract(var_0, var_counted);
    var_2 = limit_of_0(var_1, var_slack, var_margin);
    // searching = int(1)                                                                     <L 5>
    var_4 = wp::int(var_3);
    // for root in range(tree__roots):                                                        <L 6>
    var_5 = wp::range(var_tree__roots);
    start_for_0:;
        if (iter_cmp(var_5) == 0) goto end_for_0;
        var_6 = wp::iter_next(var_5);
        // node = root                                                                        <L 7>
        var_7 = wp::copy(var_6);
        // level = int(3)                                                                     <L 8>
        var_9 = wp::int(var_8);
        // left = int64(lanes_within(measure_children(tree__third + root, tree__boxes, y), limit)) << int64(32)       <L 9>
        var_10 = wp::add(var_tree__third, var_6);
        var_11 = measure_children_0(var_10, var_tree__boxes, var_y);
        var_12 = lanes_within_0(var_11, var_2);
        var_13 = wp::int64(var_12);
        var_14 = 32ll;
        var_15 = wp::lshift(var_13, var_14);
        // while left != int64(0) and searching == 1:                                         <L 10>
    start_while_2:;
        var_17 = 0ll;
        var_18 = (var_15 != var_17);
        var_16 = var_18;
        if (var_16) {
            var_20 = (var_4 == var_19);
            var_16 = var_16 && var_20;
        }
    if ((var_16) == false) goto end_while_2;
            // shift = int64(FAN * (level - 1))                                               <L 11>
            var_23 = wp::sub(var_9, var_22);
            var_24 = wp::mul(var_21, var_23);
            var_25 = wp::int64(var_24);
            // bits = int(left >> shift) & BITS                                               <L 12>
            var_26 = wp::rshift(var_15, var_25);
            var_27 = wp::int(var_26);
            var_29 = wp::bit_and(var_27, var_28);
            // if bits == 0:                                                                  <L 13>
            var_31 = (var_29 == var_30);
            if (var_31) {
                // node = node // FAN                                                         <L 14>
                var_32 = wp::floordiv(var_7, var_21);
                // level += 1                                                                 <L 15>
                var_34 = wp::add(var_9, var_33);
            }
            if (!var_31) {
                // lowest = bits & -bits                                                      <L 17>
                var_35 = wp::neg(var_29);
                var_36 = wp::bit_and(var_29, var_35);
                // left = left ^ int64(lowest) << shift                                       <L 18>
                var_37 = wp::int64(var_36);
                var_38 = wp::lshift(var_37, var_25);
                var_39 = wp::bit_xor(var_15, var_38);
                // child = node * FAN + bit_count(lowest - 1)                                 <L 19>
                var_40 = wp::mul(var_7, var_21);
                var_42 = wp::sub(var_36, var_41);
                var_43 = wp::bit_count(var_42);
                var_44 = wp::add(var_40, var_43);
                // if level > 1:                                                              <L 20>
                var_46 = (var_9 > var_45);
                if (var_46) {
                    // node = child                                                           <L 21>
                    var_47 = wp::copy(var_44);
                    // level -= 1                                                             <L 22>
                    var_49 = wp::sub(var_9, var_48);
                    // first = 0 if level == 1 else tree__second                              <L 23>
                    var_51 = (var_49 == var_50);
                    if (var_51) {
                    }
                    if (!var_51) {
                    }
                    var_53 = wp::where(var_51, var_52, var_tree__second);
                    // inside = lanes_within(measure_children(first + node, tree__boxes, y), limit)       <L 24>
                    var_54 = wp::add(var_53, var_47);
                    var_55 = measure_children_0(var_54, var_tree__boxes, var_y);
                    var_56 = lanes_within_0(var_55, var_2);
                    // left = left | int64(inside) << int64(FAN * (level - 1))                <L 25>
                    var_57 = wp::int64(var_56);
                    var_59 = wp::sub(var_49, var_58);
                    var_60 = wp::mul(var_21, var_59);
                    var_61 = wp::int64(var_60);
                    var_62 = wp::lshift(var_57, var_61);
                    var_63 = wp::bit_or(var_39, var_62);
                }
                if (!var_46) {
                    // elif child != searched:                                                <L 26>
                    var_64 = (var_44 != var_searched);
                    if (var_64) {
                        // now = offer_group(child, y, limit, position, queries__packed, tree__width, tree__labels, tree__packed, tree__grouped, tree__alike, updated)       <L 27>
                        var_65 = offer_group_0(var_44, var_y, var_2, var_position, var_queries__packed, var_tree__width, var_tree__labels, var_tree__packed, var_tree__grouped, var_tree__alike, var_0);
                        // if now[counted] < updated[counted]:                                <L 28>
                        var_66 = wp::extract(var_65, var_counted);
                        var_67 = wp::extract(var_0, var_counted);
                        var_68 = (var_66 < var_67);
                        if (var_68) {
                            // limit = limit_of(now[counted], slack, margin)                  <L 29>
                            var_69 = wp::extract(var_65, var_counted);
                            var_70 = limit_of_0(var_69, var_slack, var_margin);
                            // inside = lanes_within(measure_children(node, tree__boxes, y), limit)       <L 30>
                            var_71 = measure_children_0(var_7, var_tree__boxes, var_y);
                            var_72 = lanes_within_0(var_71, var_70);
                            // left = left & (int64(inside) | int64(ABOVE))                   <L 31>
                            var_73 = wp::int64(var_72);
                            var_74 = 281474976645120ll;
                            var_75 = wp::bit_or(var_73, var_74);
                            var_76 = wp::bit_and(var_39, var_75);
                            // searching = 1 - stop                                           <L 32>
                            var_78 = wp::sub(var_77, var_stop);
                        }
                        var_79 = wp::where(var_68, var_70, var_2);
                        var_80 = wp::where(var_68, var_78, var_4);
                        var_81 = wp::where(var_68, var_76, var_39);
                        // updated = now                                                      <L 33>
                        var_82 = wp::copy(var_65);
                    }
                    var_83 = wp::where(var_64, var_82, var_0);
                    var_84 = wp::where(var_64, var_79, var_2);
                    var_85 = wp::where(var_64, var_80, var_4);
                    var_86 = wp::where(var_64, var_81, var_39);
                }
                var_87 = wp::where(var_46, var_0, var_83);
                var_88 = wp::where(var_46, var_2, var_84);
                var_89 = wp::where(var_46, var_4, var_85);
                var_90 = wp::where(var_46, var_47, var_7);
                var_91 = wp::where(var_46, var_49, var_9);
                var_92 = wp::where(var_46, var_63, var_86);
                var_93 = wp::where(var_46, var_56, var_72);
            }
            var_94 = wp::where(var_31, var_0, var_87);
            var_95 = wp::where(var_31, var_2, var_88);
            var_96 = wp::where(var_31, var_4, var_89);
            var_97 = wp::where(var_31, var_32, var_90);
            var_98 = wp::where(var_31, var_34, var_91);
            var_99 = wp::where(var_31, var_15, var_92);
            wp::assign(var_0, var_94);
            wp::assign(var_2, var_95);
            wp::assign(var_4, var_96);
            wp::assign(var_7, var_97);
            wp::assign(var_9, var_98);
            wp::assign(var_15, var_99);
    goto start_while_2;
    end_while_2:;
        goto start_for_0;
    end_for_0:;
    // return updated                                                                         <L 34>
    return var_0;
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


// <pointloom.kernels.features.feature_matching.margin_of>:1
static CUDA_CALLABLE void adj_margin_of_0(
    wp::array_t<wp::float32> var_queries__extent,
    wp::array_t<wp::float32> var_tree__extent,
    wp::float32 var_rounding,
    wp::array_t<wp::float32> & adj_queries__extent,
    wp::array_t<wp::float32> & adj_tree__extent,
    wp::float32 & adj_rounding,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.features.feature_matching.coordinates_of>:1
static CUDA_CALLABLE void adj_coordinates_of_0(
    wp::int32 var_position,
    wp::array_t<wp::float32> var_tree__grouped,
    wp::int32 & adj_position,
    wp::array_t<wp::float32> & adj_tree__grouped,
    wp::vec_t<16, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/algebra/plain_min_max.py:11
static CUDA_CALLABLE void adj_larger_0(
    wp::float32 var_a,
    wp::float32 var_b,
    wp::float32 & adj_a,
    wp::float32 & adj_b,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/features/feature_matching.py:92
static CUDA_CALLABLE void adj_measure_children_0(
    wp::int32 var_node,
    wp::array_t<wp::float32> var_boxes,
    wp::vec_t<16, wp::float32> var_y,
    wp::int32 & adj_node,
    wp::array_t<wp::float32> & adj_boxes,
    wp::vec_t<16, wp::float32> & adj_y,
    wp::vec_t<16, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.features.feature_matching.smallest_lane>:1
static CUDA_CALLABLE void adj_smallest_lane_0(
    wp::vec_t<16, wp::float32> var_sqdists,
    wp::vec_t<16, wp::float32> & adj_sqdists,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.features.feature_matching.closest_group>:1
static CUDA_CALLABLE void adj_closest_group_0(
    wp::vec_t<16, wp::float32> var_y,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::int32 var_tree__roots,
    wp::int32 var_tree__second,
    wp::int32 var_tree__third,
    wp::vec_t<16, wp::float32> & adj_y,
    wp::array_t<wp::float32> & adj_tree__boxes,
    wp::int32 & adj_tree__roots,
    wp::int32 & adj_tree__second,
    wp::int32 & adj_tree__third,
    wp::int32 & adj_ret)
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


// /work/main/src/pointloom/kernels/algebra/plain_min_max.py:6
static CUDA_CALLABLE void adj_smaller_0(
    wp::float32 var_a,
    wp::float32 var_b,
    wp::float32 & adj_a,
    wp::float32 & adj_b,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/features/feature_matching.py:63
static CUDA_CALLABLE void adj_limit_of_0(
    wp::int64 var_key,
    wp::float32 var_slack,
    wp::float32 var_margin,
    wp::int64 & adj_key,
    wp::float32 & adj_slack,
    wp::float32 & adj_margin,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.features.feature_matching.lanes_within>:1
static CUDA_CALLABLE void adj_lanes_within_0(
    wp::vec_t<16, wp::float32> var_sqdists,
    wp::float32 var_limit,
    wp::vec_t<16, wp::float32> & adj_sqdists,
    wp::float32 & adj_limit,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/features/feature_matching.py:105
static CUDA_CALLABLE void adj_rows_within_0(
    wp::int32 var_group,
    wp::array_t<wp::float32> var_grouped,
    wp::vec_t<16, wp::float32> var_y,
    wp::float32 var_limit,
    wp::int32 & adj_group,
    wp::array_t<wp::float32> & adj_grouped,
    wp::vec_t<16, wp::float32> & adj_y,
    wp::float32 & adj_limit,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/features/feature_matching.py:52
static CUDA_CALLABLE void adj_square_distance_1(
    wp::int32 var_a,
    wp::array_t<wp::float32> var_some,
    wp::int32 var_b,
    wp::array_t<wp::float32> var_others,
    wp::int32 var_width,
    wp::int32 & adj_a,
    wp::array_t<wp::float32> & adj_some,
    wp::int32 & adj_b,
    wp::array_t<wp::float32> & adj_others,
    wp::int32 & adj_width,
    wp::float32 & adj_ret)
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


// <pointloom.kernels.arrays.packed_keys.pack_bits>:1
static CUDA_CALLABLE void adj_pack_bits_0(
    wp::int32 var_bits,
    wp::int32 var_index,
    wp::int32 & adj_bits,
    wp::int32 & adj_index,
    wp::int64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/arrays/packed_keys.py:18
static CUDA_CALLABLE void adj_pack_key_0(
    wp::float32 var_number,
    wp::int32 var_index,
    wp::float32 & adj_number,
    wp::int32 & adj_index,
    wp::int64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.features.feature_matching.offer_group>:1
static CUDA_CALLABLE void adj_offer_group_0(
    wp::int32 var_group,
    wp::vec_t<16, wp::float32> var_y,
    wp::float32 var_limit,
    wp::int32 var_position,
    wp::array_t<wp::float32> var_queries__packed,
    wp::int32 var_tree__width,
    wp::array_t<wp::int32> var_tree__labels,
    wp::array_t<wp::float32> var_tree__packed,
    wp::array_t<wp::float32> var_tree__grouped,
    wp::array_t<wp::int32> var_tree__alike,
    wp::vec_t<2, wp::int64> var_keys,
    wp::int32 & adj_group,
    wp::vec_t<16, wp::float32> & adj_y,
    wp::float32 & adj_limit,
    wp::int32 & adj_position,
    wp::array_t<wp::float32> & adj_queries__packed,
    wp::int32 & adj_tree__width,
    wp::array_t<wp::int32> & adj_tree__labels,
    wp::array_t<wp::float32> & adj_tree__packed,
    wp::array_t<wp::float32> & adj_tree__grouped,
    wp::array_t<wp::int32> & adj_tree__alike,
    wp::vec_t<2, wp::int64> & adj_keys,
    wp::vec_t<2, wp::int64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.features.feature_matching.search_rows>:1
static CUDA_CALLABLE void adj_search_rows_0(
    wp::vec_t<16, wp::float32> var_y,
    wp::int32 var_position,
    wp::array_t<wp::float32> var_queries__packed,
    wp::int32 var_tree__width,
    wp::array_t<wp::int32> var_tree__labels,
    wp::array_t<wp::float32> var_tree__packed,
    wp::array_t<wp::float32> var_tree__grouped,
    wp::array_t<wp::int32> var_tree__alike,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::int32 var_tree__roots,
    wp::int32 var_tree__second,
    wp::int32 var_tree__third,
    wp::vec_t<2, wp::int64> var_keys,
    wp::int32 var_searched,
    wp::int32 var_counted,
    wp::int32 var_stop,
    wp::float32 var_slack,
    wp::float32 var_margin,
    wp::vec_t<16, wp::float32> & adj_y,
    wp::int32 & adj_position,
    wp::array_t<wp::float32> & adj_queries__packed,
    wp::int32 & adj_tree__width,
    wp::array_t<wp::int32> & adj_tree__labels,
    wp::array_t<wp::float32> & adj_tree__packed,
    wp::array_t<wp::float32> & adj_tree__grouped,
    wp::array_t<wp::int32> & adj_tree__alike,
    wp::array_t<wp::float32> & adj_tree__boxes,
    wp::int32 & adj_tree__roots,
    wp::int32 & adj_tree__second,
    wp::int32 & adj_tree__third,
    wp::vec_t<2, wp::int64> & adj_keys,
    wp::int32 & adj_searched,
    wp::int32 & adj_counted,
    wp::int32 & adj_stop,
    wp::float32 & adj_slack,
    wp::float32 & adj_margin,
    wp::vec_t<2, wp::int64> & adj_ret)
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



extern "C" __global__ void find_nearest_rows_kernel_0a7b8e9d_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::int32 var_run,
    wp::int32 var_counted,
    wp::array_t<wp::int32> var_queries__labels,
    wp::array_t<wp::float32> var_queries__packed,
    wp::array_t<wp::float32> var_queries__grouped,
    wp::array_t<wp::float32> var_queries__extent,
    wp::int32 var_tree__width,
    wp::array_t<wp::int32> var_tree__labels,
    wp::array_t<wp::float32> var_tree__packed,
    wp::array_t<wp::float32> var_tree__grouped,
    wp::array_t<wp::int32> var_tree__alike,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::int32 var_tree__roots,
    wp::int32 var_tree__second,
    wp::int32 var_tree__third,
    wp::array_t<wp::float32> var_tree__extent,
    wp::array_t<wp::int32> var_match__nearest,
    wp::array_t<wp::float32> var_match__sqdists,
    wp::array_t<wp::float32> var_match__second_sqdists,
    wp::float32 var_match__slack,
    wp::float32 var_match__rounding)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::float32 var_1;
        wp::int32 var_2;
        const wp::int32 var_3 = 1;
        wp::int32 var_4;
        wp::int32 var_5;
        wp::shape_t* var_6;
        const wp::int32 var_7 = 0;
        wp::int32 var_8;
        wp::shape_t var_9;
        wp::int32 var_10;
        wp::range_t var_11;
        wp::int32 var_12;
        wp::vec_t<16, wp::float32> var_13;
        wp::int64 var_14;
        wp::int64 var_15;
        wp::vec_t<2, wp::int64> var_16;
        wp::int32 var_17;
        const wp::int32 var_18 = 0;
        wp::int64 var_19;
        wp::float32 var_20;
        wp::vec_t<2, wp::int64> var_21;
        const wp::int32 var_22 = 0;
        wp::vec_t<2, wp::int64> var_23;
        wp::int32* var_24;
        wp::int32 var_25;
        wp::int32 var_26;
        const wp::int32 var_27 = 0;
        wp::int64 var_28;
        wp::int64 var_29;
        bool var_30;
        const wp::int32 var_31 = 0;
        wp::int64 var_32;
        wp::int32 var_33;
        const wp::int32 var_34 = 0;
        wp::int64 var_35;
        wp::float32 var_36;
        const wp::int32 var_37 = 1;
        wp::int64 var_38;
        wp::float32 var_39;
        //---------
        // forward
        // def find_nearest_rows_kernel(run, counted, queries__labels, queries__packed, queries__grouped, queries__extent, tree__width, tree__labels, tree__packed, tree__grouped, tree__alike, tree__boxes, tree__roots, tree__second, tree__third, tree__extent, match__nearest, match__sqdists, match__second_sqdists, match__slack, match__rounding):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // margin = margin_of(queries__extent, tree__extent, match__rounding)                     <L 4>
        var_1 = margin_of_0(var_queries__extent, var_tree__extent, var_match__rounding);
        // for position in range(i * run, min((i + 1) * run, queries__labels.shape[0])):          <L 5>
        var_2 = wp::mul(var_0, var_run);
        var_4 = wp::add(var_0, var_3);
        var_5 = wp::mul(var_4, var_run);
        var_6 = &(var_queries__labels.shape);
        var_9 = wp::load(var_6);
        var_8 = wp::extract(var_9, var_7);
        var_10 = wp::min(var_5, var_8);
        var_11 = wp::range(var_2, var_10);
        start_for_0:;
            if (iter_cmp(var_11) == 0) goto end_for_0;
            var_12 = wp::iter_next(var_11);
            // y = coordinates_of(position, queries__grouped)                                     <L 6>
            var_13 = coordinates_of_0(var_12, var_queries__grouped);
            // keys = closest(int64(NO_ROW_KEY), int64(NO_ROW_KEY))                               <L 7>
            var_14 = 9187343244130779135ll;
            var_15 = wp::int64(var_14);
            var_16 = wp::vec_t<2, wp::int64>(var_14, var_15);
            // searched = closest_group(y, tree__boxes, tree__roots, tree__second, tree__third)       <L 8>
            var_17 = closest_group_0(var_13, var_tree__boxes, var_tree__roots, var_tree__second, var_tree__third);
            // limit = limit_of(keys[0], match__slack, margin)                                    <L 9>
            var_19 = wp::extract(var_16, var_18);
            var_20 = limit_of_0(var_19, var_match__slack, var_1);
            // keys = offer_group(searched, y, limit, position, queries__packed, tree__width, tree__labels, tree__packed, tree__grouped, tree__alike, keys)       <L 10>
            var_21 = offer_group_0(var_17, var_13, var_20, var_12, var_queries__packed, var_tree__width, var_tree__labels, var_tree__packed, var_tree__grouped, var_tree__alike, var_16);
            // keys = search_rows(y, position, queries__packed, tree__width, tree__labels, tree__packed, tree__grouped, tree__alike, tree__boxes, tree__roots, tree__second, tree__third, keys, searched, counted, 0, match__slack, margin)       <L 11>
            var_23 = search_rows_0(var_13, var_12, var_queries__packed, var_tree__width, var_tree__labels, var_tree__packed, var_tree__grouped, var_tree__alike, var_tree__boxes, var_tree__roots, var_tree__second, var_tree__third, var_21, var_17, var_counted, var_22, var_match__slack, var_1);
            // row = queries__labels[position]                                                    <L 12>
            var_24 = wp::address(var_queries__labels, var_12);
            var_26 = wp::load(var_24);
            var_25 = wp::copy(var_26);
            // if keys[0] < int64(NO_ROW_KEY):                                                    <L 13>
            var_28 = wp::extract(var_23, var_27);
            var_29 = wp::int64(var_14);
            var_30 = (var_28 < var_29);
            if (var_30) {
                // match__nearest[row] = key_index(keys[0])                                       <L 14>
                var_32 = wp::extract(var_23, var_31);
                var_33 = key_index_0(var_32);
                wp::array_store(var_match__nearest, var_25, var_33);
                // match__sqdists[row] = key_number(keys[0])                                      <L 15>
                var_35 = wp::extract(var_23, var_34);
                var_36 = key_number_0(var_35);
                wp::array_store(var_match__sqdists, var_25, var_36);
                // match__second_sqdists[row] = key_number(keys[1])                               <L 16>
                var_38 = wp::extract(var_23, var_37);
                var_39 = key_number_0(var_38);
                wp::array_store(var_match__second_sqdists, var_25, var_39);
            }
            goto start_for_0;
        end_for_0:;
}



extern "C" __global__ void keep_matched_kernel_304e1c56_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_nearest,
    wp::array_t<wp::uint8> var_mask)
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
        const wp::int32 var_2 = -1;
        bool var_3;
        wp::int32 var_4;
        const wp::int32 var_5 = 1;
        const wp::int32 var_6 = 0;
        wp::int32 var_7;
        wp::uint8 var_8;
        //---------
        // forward
        // def keep_matched_kernel(nearest: array(dtype=int32), mask: array(dtype=uint8)):        <L 334>
        // i = tid()                                                                              <L 335>
        var_0 = builtin_tid1d();
        // mask[i] = uint8(1 if nearest[i] != NO_ROW else 0)                                      <L 336>
        var_1 = wp::address(var_nearest, var_0);
        var_4 = wp::load(var_1);
        var_3 = (var_4 != var_2);
        if (var_3) {
        }
        if (!var_3) {
        }
        var_7 = wp::where(var_3, var_5, var_6);
        var_8 = wp::uint8(var_7);
        wp::array_store(var_mask, var_0, var_8);
}



extern "C" __global__ void claim_rows_kernel_4397fd57_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_nearest,
    wp::array_t<wp::float32> var_sqdists,
    wp::array_t<wp::int64> var_claims)
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
        const wp::int32 var_2 = -1;
        bool var_3;
        wp::int32 var_4;
        wp::int32* var_5;
        wp::float32* var_6;
        wp::int64 var_7;
        wp::float32 var_8;
        wp::int64 var_9;
        wp::int32 var_10;
        //---------
        // forward
        // def claim_rows_kernel(nearest: array(dtype=int32), sqdists: array(dtype=float32), claims: array(dtype=int64)):       <L 304>
        // i = tid()                                                                              <L 306>
        var_0 = builtin_tid1d();
        // if nearest[i] != NO_ROW:                                                               <L 307>
        var_1 = wp::address(var_nearest, var_0);
        var_4 = wp::load(var_1);
        var_3 = (var_4 != var_2);
        if (var_3) {
            // atomic_min(claims, nearest[i], pack_key(sqdists[i], i))                            <L 308>
            var_5 = wp::address(var_nearest, var_0);
            var_6 = wp::address(var_sqdists, var_0);
            var_8 = wp::load(var_6);
            var_7 = pack_key_0(var_8, var_0);
            var_10 = wp::load(var_5);
            var_9 = wp::atomic_min(var_claims, var_10, var_7);
        }
}



extern "C" __global__ void drop_ambiguous_kernel_8f4f51b0_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_sqdists,
    wp::array_t<wp::float32> var_second_sqdists,
    wp::float64 var_square_ratio,
    wp::array_t<wp::uint8> var_mask)
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
        wp::float64 var_2;
        wp::float32 var_3;
        wp::float32* var_4;
        wp::float64 var_5;
        wp::float32 var_6;
        wp::float64 var_7;
        bool var_8;
        bool var_9;
        const wp::int32 var_10 = 0;
        wp::uint8 var_11;
        //---------
        // forward
        // def drop_ambiguous_kernel(sqdists, second_sqdists, square_ratio, mask):                <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // if not float64(sqdists[i]) < square_ratio * float64(second_sqdists[i]):                <L 4>
        var_1 = wp::address(var_sqdists, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::float64(var_3);
        var_4 = wp::address(var_second_sqdists, var_0);
        var_6 = wp::load(var_4);
        var_5 = wp::float64(var_6);
        var_7 = wp::mul(var_square_ratio, var_5);
        var_8 = (var_2 < var_7);
        var_9 = wp::unot(var_8);
        if (var_9) {
            // mask[i] = uint8(0)                                                                 <L 5>
            var_11 = wp::uint8(var_10);
            wp::array_store(var_mask, var_0, var_11);
        }
}



extern "C" __global__ void keep_mutual_kernel_9e946c79_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::int32 var_run,
    wp::array_t<wp::int32> var_queries__labels,
    wp::array_t<wp::float32> var_queries__packed,
    wp::array_t<wp::float32> var_queries__grouped,
    wp::array_t<wp::float32> var_queries__extent,
    wp::int32 var_tree__width,
    wp::array_t<wp::int32> var_tree__labels,
    wp::array_t<wp::float32> var_tree__packed,
    wp::array_t<wp::float32> var_tree__grouped,
    wp::array_t<wp::int32> var_tree__alike,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::int32 var_tree__roots,
    wp::int32 var_tree__second,
    wp::int32 var_tree__third,
    wp::array_t<wp::float32> var_tree__extent,
    wp::float32 var_match__slack,
    wp::float32 var_match__rounding,
    wp::array_t<wp::int64> var_claims,
    wp::array_t<wp::uint8> var_mask)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::float32 var_1;
        wp::int32 var_2;
        const wp::int32 var_3 = 1;
        wp::int32 var_4;
        wp::int32 var_5;
        wp::shape_t* var_6;
        const wp::int32 var_7 = 0;
        wp::int32 var_8;
        wp::shape_t var_9;
        wp::int32 var_10;
        wp::range_t var_11;
        wp::int32 var_12;
        wp::int32* var_13;
        wp::int32 var_14;
        wp::int64* var_15;
        wp::int64 var_16;
        wp::int64 var_17;
        wp::int64 var_18;
        bool var_19;
        wp::vec_t<16, wp::float32> var_20;
        wp::int64 var_21;
        wp::vec_t<2, wp::int64> var_22;
        const wp::int32 var_23 = -1;
        const wp::int32 var_24 = 0;
        const wp::int32 var_25 = 1;
        wp::vec_t<2, wp::int64> var_26;
        const wp::int32 var_27 = 0;
        wp::int64 var_28;
        bool var_29;
        const wp::int32 var_30 = 1;
        wp::uint8 var_31;
        wp::int32 var_32;
        //---------
        // forward
        // def keep_mutual_kernel(run, queries__labels, queries__packed, queries__grouped, queries__extent, tree__width, tree__labels, tree__packed, tree__grouped, tree__alike, tree__boxes, tree__roots, tree__second, tree__third, tree__extent, match__slack, match__rounding, claims, mask):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // margin = margin_of(queries__extent, tree__extent, match__rounding)                     <L 4>
        var_1 = margin_of_0(var_queries__extent, var_tree__extent, var_match__rounding);
        // for position in range(i * run, min((i + 1) * run, queries__labels.shape[0])):          <L 5>
        var_2 = wp::mul(var_0, var_run);
        var_4 = wp::add(var_0, var_3);
        var_5 = wp::mul(var_4, var_run);
        var_6 = &(var_queries__labels.shape);
        var_9 = wp::load(var_6);
        var_8 = wp::extract(var_9, var_7);
        var_10 = wp::min(var_5, var_8);
        var_11 = wp::range(var_2, var_10);
        start_for_0:;
            if (iter_cmp(var_11) == 0) goto end_for_0;
            var_12 = wp::iter_next(var_11);
            // claim = claims[queries__labels[position]]                                          <L 6>
            var_13 = wp::address(var_queries__labels, var_12);
            var_14 = wp::load(var_13);
            var_15 = wp::address(var_claims, var_14);
            var_17 = wp::load(var_15);
            var_16 = wp::copy(var_17);
            // if claim < int64(NO_ROW_KEY):                                                      <L 7>
            var_18 = 9187343244130779135ll;
            var_19 = (var_16 < var_18);
            if (var_19) {
                // y = coordinates_of(position, queries__grouped)                                 <L 8>
                var_20 = coordinates_of_0(var_12, var_queries__grouped);
                // keys = closest(claim, int64(NO_ROW_KEY))                                       <L 9>
                var_21 = wp::int64(var_18);
                var_22 = wp::vec_t<2, wp::int64>(var_16, var_21);
                // keys = search_rows(y, position, queries__packed, tree__width, tree__labels, tree__packed, tree__grouped, tree__alike, tree__boxes, tree__roots, tree__second, tree__third, keys, -1, 0, 1, match__slack, margin)       <L 10>
                var_26 = search_rows_0(var_20, var_12, var_queries__packed, var_tree__width, var_tree__labels, var_tree__packed, var_tree__grouped, var_tree__alike, var_tree__boxes, var_tree__roots, var_tree__second, var_tree__third, var_22, var_23, var_24, var_25, var_match__slack, var_1);
                // if keys[0] == claim:                                                           <L 11>
                var_28 = wp::extract(var_26, var_27);
                var_29 = (var_28 == var_16);
                if (var_29) {
                    // mask[key_index(claim)] = uint8(1)                                          <L 12>
                    var_31 = wp::uint8(var_30);
                    var_32 = key_index_0(var_16);
                    wp::array_store(var_mask, var_32, var_31);
                }
            }
            goto start_for_0;
        end_for_0:;
}



extern "C" __global__ void write_pairs_kernel_bf7c3c5a_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_rows,
    wp::array_t<wp::int32> var_nearest,
    wp::array_t<wp::int32> var_pairs)
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
        wp::int32* var_5;
        wp::int32 var_6;
        wp::int32* var_7;
        wp::int32 var_8;
        wp::int32 var_9;
        const wp::int32 var_10 = 1;
        //---------
        // forward
        // def write_pairs_kernel(rows: array(dtype=int32), nearest: array(dtype=int32), pairs: array(dtype=int32, ndim=2)):       <L 350>
        // i = tid()                                                                              <L 351>
        var_0 = builtin_tid1d();
        // pairs[i, 0] = rows[i]                                                                  <L 352>
        var_1 = wp::address(var_rows, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        wp::array_store(var_pairs, var_0, var_4, var_2);
        // pairs[i, 1] = nearest[rows[i]]                                                         <L 353>
        var_5 = wp::address(var_rows, var_0);
        var_6 = wp::load(var_5);
        var_7 = wp::address(var_nearest, var_6);
        var_9 = wp::load(var_7);
        var_8 = wp::copy(var_9);
        wp::array_store(var_pairs, var_0, var_10, var_8);
}


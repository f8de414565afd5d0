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


// <pointloom.kernels.arrays.random.philox>:1
static CUDA_CALLABLE wp::vec_t<4, wp::uint32> philox_0(
    wp::uint64 var_x0,
    wp::uint64 var_x1,
    wp::uint64 var_x2,
    wp::uint64 var_x3,
    wp::uint64 var_k0,
    wp::uint64 var_k1)
{
    //---------
    // primal vars
    wp::uint64 var_0;
    wp::uint64 var_1;
    wp::uint64 var_2;
    wp::uint64 var_3;
    wp::uint64 var_4;
    wp::uint64 var_5;
    const wp::int32 var_6 = 0;
    wp::uint64 var_7;
    wp::uint64 var_8;
    wp::uint64 var_9;
    wp::uint64 var_10;
    wp::uint64 var_11;
    wp::uint64 var_12;
    wp::uint64 var_13;
    wp::uint64 var_14;
    wp::uint64 var_15;
    wp::uint64 var_16;
    wp::uint64 var_17;
    wp::uint64 var_18;
    wp::uint64 var_19;
    wp::uint64 var_20;
    wp::uint64 var_21;
    wp::uint64 var_22;
    wp::uint64 var_23;
    wp::uint64 var_24;
    wp::uint64 var_25;
    wp::uint64 var_26;
    wp::uint64 var_27;
    wp::uint64 var_28;
    wp::uint64 var_29;
    wp::uint64 var_30;
    const wp::int32 var_31 = 1;
    wp::uint64 var_32;
    wp::uint64 var_33;
    wp::uint64 var_34;
    wp::uint64 var_35;
    wp::uint64 var_36;
    wp::uint64 var_37;
    wp::uint64 var_38;
    wp::uint64 var_39;
    wp::uint64 var_40;
    wp::uint64 var_41;
    wp::uint64 var_42;
    wp::uint64 var_43;
    wp::uint64 var_44;
    wp::uint64 var_45;
    wp::uint64 var_46;
    wp::uint64 var_47;
    wp::uint64 var_48;
    wp::uint64 var_49;
    wp::uint64 var_50;
    wp::uint64 var_51;
    wp::uint64 var_52;
    wp::uint64 var_53;
    wp::uint64 var_54;
    wp::uint64 var_55;
    const wp::int32 var_56 = 2;
    wp::uint64 var_57;
    wp::uint64 var_58;
    wp::uint64 var_59;
    wp::uint64 var_60;
    wp::uint64 var_61;
    wp::uint64 var_62;
    wp::uint64 var_63;
    wp::uint64 var_64;
    wp::uint64 var_65;
    wp::uint64 var_66;
    wp::uint64 var_67;
    wp::uint64 var_68;
    wp::uint64 var_69;
    wp::uint64 var_70;
    wp::uint64 var_71;
    wp::uint64 var_72;
    wp::uint64 var_73;
    wp::uint64 var_74;
    wp::uint64 var_75;
    wp::uint64 var_76;
    wp::uint64 var_77;
    wp::uint64 var_78;
    wp::uint64 var_79;
    wp::uint64 var_80;
    const wp::int32 var_81 = 3;
    wp::uint64 var_82;
    wp::uint64 var_83;
    wp::uint64 var_84;
    wp::uint64 var_85;
    wp::uint64 var_86;
    wp::uint64 var_87;
    wp::uint64 var_88;
    wp::uint64 var_89;
    wp::uint64 var_90;
    wp::uint64 var_91;
    wp::uint64 var_92;
    wp::uint64 var_93;
    wp::uint64 var_94;
    wp::uint64 var_95;
    wp::uint64 var_96;
    wp::uint64 var_97;
    wp::uint64 var_98;
    wp::uint64 var_99;
    wp::uint64 var_100;
    wp::uint64 var_101;
    wp::uint64 var_102;
    wp::uint64 var_103;
    wp::uint64 var_104;
    wp::uint64 var_105;
    const wp::int32 var_106 = 4;
    wp::uint64 var_107;
    wp::uint64 var_108;
    wp::uint64 var_109;
    wp::uint64 var_110;
    wp::uint64 var_111;
    wp::uint64 var_112;
    wp::uint64 var_113;
    wp::uint64 var_114;
    wp::uint64 var_115;
    wp::uint64 var_116;
    wp::uint64 var_117;
    wp::uint64 var_118;
    wp::uint64 var_119;
    wp::uint64 var_120;
    wp::uint64 var_121;
    wp::uint64 var_122;
    wp::uint64 var_123;
    wp::uint64 var_124;
    wp::uint64 var_125;
    wp::uint64 var_126;
    wp::uint64 var_127;
    wp::uint64 var_128;
    wp::uint64 var_129;
    wp::uint64 var_130;
    const wp::int32 var_131 = 5;
    wp::uint64 var_132;
    wp::uint64 var_133;
    wp::uint64 var_134;
    wp::uint64 var_135;
    wp::uint64 var_136;
    wp::uint64 var_137;
    wp::uint64 var_138;
    wp::uint64 var_139;
    wp::uint64 var_140;
    wp::uint64 var_141;
    wp::uint64 var_142;
    wp::uint64 var_143;
    wp::uint64 var_144;
    wp::uint64 var_145;
    wp::uint64 var_146;
    wp::uint64 var_147;
    wp::uint64 var_148;
    wp::uint64 var_149;
    wp::uint64 var_150;
    wp::uint64 var_151;
    wp::uint64 var_152;
    wp::uint64 var_153;
    wp::uint64 var_154;
    wp::uint64 var_155;
    const wp::int32 var_156 = 6;
    wp::uint64 var_157;
    wp::uint64 var_158;
    wp::uint64 var_159;
    wp::uint64 var_160;
    wp::uint64 var_161;
    wp::uint64 var_162;
    wp::uint64 var_163;
    wp::uint64 var_164;
    wp::uint64 var_165;
    wp::uint64 var_166;
    wp::uint64 var_167;
    wp::uint64 var_168;
    wp::uint64 var_169;
    wp::uint64 var_170;
    wp::uint64 var_171;
    wp::uint64 var_172;
    wp::uint64 var_173;
    wp::uint64 var_174;
    wp::uint64 var_175;
    wp::uint64 var_176;
    wp::uint64 var_177;
    wp::uint64 var_178;
    wp::uint64 var_179;
    wp::uint64 var_180;
    const wp::int32 var_181 = 7;
    wp::uint64 var_182;
    wp::uint64 var_183;
    wp::uint64 var_184;
    wp::uint64 var_185;
    wp::uint64 var_186;
    wp::uint64 var_187;
    wp::uint64 var_188;
    wp::uint64 var_189;
    wp::uint64 var_190;
    wp::uint64 var_191;
    wp::uint64 var_192;
    wp::uint64 var_193;
    wp::uint64 var_194;
    wp::uint64 var_195;
    wp::uint64 var_196;
    wp::uint64 var_197;
    wp::uint64 var_198;
    wp::uint64 var_199;
    wp::uint64 var_200;
    wp::uint64 var_201;
    wp::uint64 var_202;
    wp::uint64 var_203;
    wp::uint64 var_204;
    wp::uint64 var_205;
    const wp::int32 var_206 = 8;
    wp::uint64 var_207;
    wp::uint64 var_208;
    wp::uint64 var_209;
    wp::uint64 var_210;
    wp::uint64 var_211;
    wp::uint64 var_212;
    wp::uint64 var_213;
    wp::uint64 var_214;
    wp::uint64 var_215;
    wp::uint64 var_216;
    wp::uint64 var_217;
    wp::uint64 var_218;
    wp::uint64 var_219;
    wp::uint64 var_220;
    wp::uint64 var_221;
    wp::uint64 var_222;
    wp::uint64 var_223;
    wp::uint64 var_224;
    wp::uint64 var_225;
    wp::uint64 var_226;
    wp::uint64 var_227;
    wp::uint64 var_228;
    wp::uint64 var_229;
    wp::uint64 var_230;
    const wp::int32 var_231 = 9;
    wp::uint64 var_232;
    wp::uint64 var_233;
    wp::uint64 var_234;
    wp::uint64 var_235;
    wp::uint64 var_236;
    wp::uint64 var_237;
    wp::uint64 var_238;
    wp::uint64 var_239;
    wp::uint64 var_240;
    wp::uint64 var_241;
    wp::uint64 var_242;
    wp::uint64 var_243;
    wp::uint64 var_244;
    wp::uint64 var_245;
    wp::uint64 var_246;
    wp::uint64 var_247;
    wp::uint64 var_248;
    wp::uint64 var_249;
    wp::uint64 var_250;
    wp::uint64 var_251;
    wp::uint64 var_252;
    wp::uint64 var_253;
    wp::uint64 var_254;
    wp::uint64 var_255;
    wp::uint32 var_256;
    wp::uint32 var_257;
    wp::uint32 var_258;
    wp::uint32 var_259;
    wp::vec_t<4, wp::uint32> var_260;
    //---------
    // forward
    // def philox(x0, x1, x2, x3, k0, k1):                                                    <L 1>
    // c0 = x0                                                                                <L 3>
    var_0 = wp::copy(var_x0);
    // c1 = x1                                                                                <L 4>
    var_1 = wp::copy(var_x1);
    // c2 = x2                                                                                <L 5>
    var_2 = wp::copy(var_x2);
    // c3 = x3                                                                                <L 6>
    var_3 = wp::copy(var_x3);
    // key0 = k0                                                                              <L 7>
    var_4 = wp::copy(var_k0);
    // key1 = k1                                                                              <L 8>
    var_5 = wp::copy(var_k1);
    // for _ in range(ROUNDS):                                                                <L 9>
    // p0 = uint64(MULTIPLIER_0) * c0                                                         <L 10>
    var_7 = 3528531795ull;
    var_8 = wp::mul(var_7, var_0);
    // p1 = uint64(MULTIPLIER_1) * c2                                                         <L 11>
    var_9 = 3449720151ull;
    var_10 = wp::mul(var_9, var_2);
    // c0 = p1 >> uint64(32) ^ c1 ^ key0                                                      <L 12>
    var_11 = 32ull;
    var_12 = wp::rshift(var_10, var_11);
    var_13 = wp::bit_xor(var_12, var_1);
    var_14 = wp::bit_xor(var_13, var_4);
    // c1 = p1 & uint64(LOW_WORD)                                                             <L 13>
    var_15 = 4294967295ull;
    var_16 = wp::bit_and(var_10, var_15);
    // c2 = p0 >> uint64(32) ^ c3 ^ key1                                                      <L 14>
    var_17 = 32ull;
    var_18 = wp::rshift(var_8, var_17);
    var_19 = wp::bit_xor(var_18, var_3);
    var_20 = wp::bit_xor(var_19, var_5);
    // c3 = p0 & uint64(LOW_WORD)                                                             <L 15>
    var_21 = wp::uint64(var_15);
    var_22 = wp::bit_and(var_8, var_21);
    // key0 = key0 + uint64(WEYL_0) & uint64(LOW_WORD)                                        <L 16>
    var_23 = 2654435769ull;
    var_24 = wp::add(var_4, var_23);
    var_25 = wp::uint64(var_15);
    var_26 = wp::bit_and(var_24, var_25);
    // key1 = key1 + uint64(WEYL_1) & uint64(LOW_WORD)                                        <L 17>
    var_27 = 3144134277ull;
    var_28 = wp::add(var_5, var_27);
    var_29 = wp::uint64(var_15);
    var_30 = wp::bit_and(var_28, var_29);
    // p0 = uint64(MULTIPLIER_0) * c0                                                         <L 10>
    var_32 = wp::uint64(var_7);
    var_33 = wp::mul(var_32, var_14);
    // p1 = uint64(MULTIPLIER_1) * c2                                                         <L 11>
    var_34 = wp::uint64(var_9);
    var_35 = wp::mul(var_34, var_20);
    // c0 = p1 >> uint64(32) ^ c1 ^ key0                                                      <L 12>
    var_36 = 32ull;
    var_37 = wp::rshift(var_35, var_36);
    var_38 = wp::bit_xor(var_37, var_16);
    var_39 = wp::bit_xor(var_38, var_26);
    // c1 = p1 & uint64(LOW_WORD)                                                             <L 13>
    var_40 = wp::uint64(var_15);
    var_41 = wp::bit_and(var_35, var_40);
    // c2 = p0 >> uint64(32) ^ c3 ^ key1                                                      <L 14>
    var_42 = 32ull;
    var_43 = wp::rshift(var_33, var_42);
    var_44 = wp::bit_xor(var_43, var_22);
    var_45 = wp::bit_xor(var_44, var_30);
    // c3 = p0 & uint64(LOW_WORD)                                                             <L 15>
    var_46 = wp::uint64(var_15);
    var_47 = wp::bit_and(var_33, var_46);
    // key0 = key0 + uint64(WEYL_0) & uint64(LOW_WORD)                                        <L 16>
    var_48 = wp::uint64(var_23);
    var_49 = wp::add(var_26, var_48);
    var_50 = wp::uint64(var_15);
    var_51 = wp::bit_and(var_49, var_50);
    // key1 = key1 + uint64(WEYL_1) & uint64(LOW_WORD)                                        <L 17>
    var_52 = wp::uint64(var_27);
    var_53 = wp::add(var_30, var_52);
    var_54 = wp::uint64(var_15);
    var_55 = wp::bit_and(var_53, var_54);
    // p0 = uint64(MULTIPLIER_0) * c0                                                         <L 10>
    var_57 = wp::uint64(var_7);
    var_58 = wp::mul(var_57, var_39);
    // p1 = uint64(MULTIPLIER_1) * c2                                                         <L 11>
    var_59 = wp::uint64(var_9);
    var_60 = wp::mul(var_59, var_45);
    // c0 = p1 >> uint64(32) ^ c1 ^ key0                                                      <L 12>
    var_61 = 32ull;
    var_62 = wp::rshift(var_60, var_61);
    var_63 = wp::bit_xor(var_62, var_41);
    var_64 = wp::bit_xor(var_63, var_51);
    // c1 = p1 & uint64(LOW_WORD)                                                             <L 13>
    var_65 = wp::uint64(var_15);
    var_66 = wp::bit_and(var_60, var_65);
    // c2 = p0 >> uint64(32) ^ c3 ^ key1                                                      <L 14>
    var_67 = 32ull;
    var_68 = wp::rshift(var_58, var_67);
    var_69 = wp::bit_xor(var_68, var_47);
    var_70 = wp::bit_xor(var_69, var_55);
    // c3 = p0 & uint64(LOW_WORD)                                                             <L 15>
    var_71 = wp::uint64(var_15);
    var_72 = wp::bit_and(var_58, var_71);
    // key0 = key0 + uint64(WEYL_0) & uint64(LOW_WORD)                                        <L 16>
    var_73 = wp::uint64(var_23);
    var_74 = wp::add(var_51, var_73);
    var_75 = wp::uint64(var_15);
    var_76 = wp::bit_and(var_74, var_75);
    // key1 = key1 + uint64(WEYL_1) & uint64(LOW_WORD)                                        <L 17>
    var_77 = wp::uint64(var_27);
    var_78 = wp::add(var_55, var_77);
    var_79 = wp::uint64(var_15);
    var_80 = wp::bit_and(var_78, var_79);
    // p0 = uint64(MULTIPLIER_0) * c0                                                         <L 10>
    var_82 = wp::uint64(var_7);
    var_83 = wp::mul(var_82, var_64);
    // p1 = uint64(MULTIPLIER_1) * c2                                                         <L 11>
    var_84 = wp::uint64(var_9);
    var_85 = wp::mul(var_84, var_70);
    // c0 = p1 >> uint64(32) ^ c1 ^ key0                                                      <L 12>
    var_86 = 32ull;
    var_87 = wp::rshift(var_85, var_86);
    var_88 = wp::bit_xor(var_87, var_66);
    var_89 = wp::bit_xor(var_88, var_76);
    // c1 = p1 & uint64(LOW_WORD)                                                             <L 13>
    var_90 = wp::uint64(var_15);
    var_91 = wp::bit_and(var_85, var_90);
    // c2 = p0 >> uint64(32) ^ c3 ^ key1                                                      <L 14>
    var_92 = 32ull;
    var_93 = wp::rshift(var_83, var_92);
    var_94 = wp::bit_xor(var_93, var_72);
    var_95 = wp::bit_xor(var_94, var_80);
    // c3 = p0 & uint64(LOW_WORD)                                                             <L 15>
    var_96 = wp::uint64(var_15);
    var_97 = wp::bit_and(var_83, var_96);
    // key0 = key0 + uint64(WEYL_0) & uint64(LOW_WORD)                                        <L 16>
    var_98 = wp::uint64(var_23);
    var_99 = wp::add(var_76, var_98);
    var_100 = wp::uint64(var_15);
    var_101 = wp::bit_and(var_99, var_100);
    // key1 = key1 + uint64(WEYL_1) & uint64(LOW_WORD)                                        <L 17>
    var_102 = wp::uint64(var_27);
    var_103 = wp::add(var_80, var_102);
    var_104 = wp::uint64(var_15);
    var_105 = wp::bit_and(var_103, var_104);
    // p0 = uint64(MULTIPLIER_0) * c0                                                         <L 10>
    var_107 = wp::uint64(var_7);
    var_108 = wp::mul(var_107, var_89);
    // p1 = uint64(MULTIPLIER_1) * c2                                                         <L 11>
    var_109 = wp::uint64(var_9);
    var_110 = wp::mul(var_109, var_95);
    // c0 = p1 >> uint64(32) ^ c1 ^ key0                                                      <L 12>
    var_111 = 32ull;
    var_112 = wp::rshift(var_110, var_111);
    var_113 = wp::bit_xor(var_112, var_91);
    var_114 = wp::bit_xor(var_113, var_101);
    // c1 = p1 & uint64(LOW_WORD)                                                             <L 13>
    var_115 = wp::uint64(var_15);
    var_116 = wp::bit_and(var_110, var_115);
    // c2 = p0 >> uint64(32) ^ c3 ^ key1                                                      <L 14>
    var_117 = 32ull;
    var_118 = wp::rshift(var_108, var_117);
    var_119 = wp::bit_xor(var_118, var_97);
    var_120 = wp::bit_xor(var_119, var_105);
    // c3 = p0 & uint64(LOW_WORD)                                                             <L 15>
    var_121 = wp::uint64(var_15);
    var_122 = wp::bit_and(var_108, var_121);
    // key0 = key0 + uint64(WEYL_0) & uint64(LOW_WORD)                                        <L 16>
    var_123 = wp::uint64(var_23);
    var_124 = wp::add(var_101, var_123);
    var_125 = wp::uint64(var_15);
    var_126 = wp::bit_and(var_124, var_125);
    // key1 = key1 + uint64(WEYL_1) & uint64(LOW_WORD)                                        <L 17>
    var_127 = wp::uint64(var_27);
    var_128 = wp::add(var_105, var_127);
    var_129 = wp::uint64(var_15);
    var_130 = wp::bit_and(var_128, var_129);
    // p0 = uint64(MULTIPLIER_0) * c0                                                         <L 10>
    var_132 = wp::uint64(var_7);
    var_133 = wp::mul(var_132, var_114);
    // p1 = uint64(MULTIPLIER_1) * c2                                                         <L 11>
    var_134 = wp::uint64(var_9);
    var_135 = wp::mul(var_134, var_120);
    // c0 = p1 >> uint64(32) ^ c1 ^ key0                                                      <L 12>
    var_136 = 32ull;
    var_137 = wp::rshift(var_135, var_136);
    var_138 = wp::bit_xor(var_137, var_116);
    var_139 = wp::bit_xor(var_138, var_126);
    // c1 = p1 & uint64(LOW_WORD)                                                             <L 13>
    var_140 = wp::uint64(var_15);
    var_141 = wp::bit_and(var_135, var_140);
    // c2 = p0 >> uint64(32) ^ c3 ^ key1                                                      <L 14>
    var_142 = 32ull;
    var_143 = wp::rshift(var_133, var_142);
    var_144 = wp::bit_xor(var_143, var_122);
    var_145 = wp::bit_xor(var_144, var_130);
    // c3 = p0 & uint64(LOW_WORD)                                                             <L 15>
    var_146 = wp::uint64(var_15);
    var_147 = wp::bit_and(var_133, var_146);
    // key0 = key0 + uint64(WEYL_0) & uint64(LOW_WORD)                                        <L 16>
    var_148 = wp::uint64(var_23);
    var_149 = wp::add(var_126, var_148);
    var_150 = wp::uint64(var_15);
    var_151 = wp::bit_and(var_149, var_150);
    // key1 = key1 + uint64(WEYL_1) & uint64(LOW_WORD)                                        <L 17>
    var_152 = wp::uint64(var_27);
    var_153 = wp::add(var_130, var_152);
    var_154 = wp::uint64(var_15);
    var_155 = wp::bit_and(var_153, var_154);
    // p0 = uint64(MULTIPLIER_0) * c0                                                         <L 10>
    var_157 = wp::uint64(var_7);
    var_158 = wp::mul(var_157, var_139);
    // p1 = uint64(MULTIPLIER_1) * c2                                                         <L 11>
    var_159 = wp::uint64(var_9);
    var_160 = wp::mul(var_159, var_145);
    // c0 = p1 >> uint64(32) ^ c1 ^ key0                                                      <L 12>
    var_161 = 32ull;
    var_162 = wp::rshift(var_160, var_161);
    var_163 = wp::bit_xor(var_162, var_141);
    var_164 = wp::bit_xor(var_163, var_151);
    // c1 = p1 & uint64(LOW_WORD)                                                             <L 13>
    var_165 = wp::uint64(var_15);
    var_166 = wp::bit_and(var_160, var_165);
    // c2 = p0 >> uint64(32) ^ c3 ^ key1                                                      <L 14>
    var_167 = 32ull;
    var_168 = wp::rshift(var_158, var_167);
    var_169 = wp::bit_xor(var_168, var_147);
    var_170 = wp::bit_xor(var_169, var_155);
    // c3 = p0 & uint64(LOW_WORD)                                                             <L 15>
    var_171 = wp::uint64(var_15);
    var_172 = wp::bit_and(var_158, var_171);
    // key0 = key0 + uint64(WEYL_0) & uint64(LOW_WORD)                                        <L 16>
    var_173 = wp::uint64(var_23);
    var_174 = wp::add(var_151, var_173);
    var_175 = wp::uint64(var_15);
    var_176 = wp::bit_and(var_174, var_175);
    // key1 = key1 + uint64(WEYL_1) & uint64(LOW_WORD)                                        <L 17>
    var_177 = wp::uint64(var_27);
    var_178 = wp::add(var_155, var_177);
    var_179 = wp::uint64(var_15);
    var_180 = wp::bit_and(var_178, var_179);
    // p0 = uint64(MULTIPLIER_0) * c0                                                         <L 10>
    var_182 = wp::uint64(var_7);
    var_183 = wp::mul(var_182, var_164);
    // p1 = uint64(MULTIPLIER_1) * c2                                                         <L 11>
    var_184 = wp::uint64(var_9);
    var_185 = wp::mul(var_184, var_170);
    // c0 = p1 >> uint64(32) ^ c1 ^ key0                                                      <L 12>
    var_186 = 32ull;
    var_187 = wp::rshift(var_185, var_186);
    var_188 = wp::bit_xor(var_187, var_166);
    var_189 = wp::bit_xor(var_188, var_176);
    // c1 = p1 & uint64(LOW_WORD)                                                             <L 13>
    var_190 = wp::uint64(var_15);
    var_191 = wp::bit_and(var_185, var_190);
    // c2 = p0 >> uint64(32) ^ c3 ^ key1                                                      <L 14>
    var_192 = 32ull;
    var_193 = wp::rshift(var_183, var_192);
    var_194 = wp::bit_xor(var_193, var_172);
    var_195 = wp::bit_xor(var_194, var_180);
    // c3 = p0 & uint64(LOW_WORD)                                                             <L 15>
    var_196 = wp::uint64(var_15);
    var_197 = wp::bit_and(var_183, var_196);
    // key0 = key0 + uint64(WEYL_0) & uint64(LOW_WORD)                                        <L 16>
    var_198 = wp::uint64(var_23);
    var_199 = wp::add(var_176, var_198);
    var_200 = wp::uint64(var_15);
    var_201 = wp::bit_and(var_199, var_200);
    // key1 = key1 + uint64(WEYL_1) & uint64(LOW_WORD)                                        <L 17>
    var_202 = wp::uint64(var_27);
    var_203 = wp::add(var_180, var_202);
    var_204 = wp::uint64(var_15);
    var_205 = wp::bit_and(var_203, var_204);
    // p0 = uint64(MULTIPLIER_0) * c0                                                         <L 10>
    var_207 = wp::uint64(var_7);
    var_208 = wp::mul(var_207, var_189);
    // p1 = uint64(MULTIPLIER_1) * c2                                                         <L 11>
    var_209 = wp::uint64(var_9);
    var_210 = wp::mul(var_209, var_195);
    // c0 = p1 >> uint64(32) ^ c1 ^ key0                                                      <L 12>
    var_211 = 32ull;
    var_212 = wp::rshift(var_210, var_211);
    var_213 = wp::bit_xor(var_212, var_191);
    var_214 = wp::bit_xor(var_213, var_201);
    // c1 = p1 & uint64(LOW_WORD)                                                             <L 13>
    var_215 = wp::uint64(var_15);
    var_216 = wp::bit_and(var_210, var_215);
    // c2 = p0 >> uint64(32) ^ c3 ^ key1                                                      <L 14>
    var_217 = 32ull;
    var_218 = wp::rshift(var_208, var_217);
    var_219 = wp::bit_xor(var_218, var_197);
    var_220 = wp::bit_xor(var_219, var_205);
    // c3 = p0 & uint64(LOW_WORD)                                                             <L 15>
    var_221 = wp::uint64(var_15);
    var_222 = wp::bit_and(var_208, var_221);
    // key0 = key0 + uint64(WEYL_0) & uint64(LOW_WORD)                                        <L 16>
    var_223 = wp::uint64(var_23);
    var_224 = wp::add(var_201, var_223);
    var_225 = wp::uint64(var_15);
    var_226 = wp::bit_and(var_224, var_225);
    // key1 = key1 + uint64(WEYL_1) & uint64(LOW_WORD)                                        <L 17>
    var_227 = wp::uint64(var_27);
    var_228 = wp::add(var_205, var_227);
    var_229 = wp::uint64(var_15);
    var_230 = wp::bit_and(var_228, var_229);
    // p0 = uint64(MULTIPLIER_0) * c0                                                         <L 10>
    var_232 = wp::uint64(var_7);
    var_233 = wp::mul(var_232, var_214);
    // p1 = uint64(MULTIPLIER_1) * c2                                                         <L 11>
    var_234 = wp::uint64(var_9);
    var_235 = wp::mul(var_234, var_220);
    // c0 = p1 >> uint64(32) ^ c1 ^ key0                                                      <L 12>
    var_236 = 32ull;
    var_237 = wp::rshift(var_235, var_236);
    var_238 = wp::bit_xor(var_237, var_216);
    var_239 = wp::bit_xor(var_238, var_226);
    // c1 = p1 & uint64(LOW_WORD)                                                             <L 13>
    var_240 = wp::uint64(var_15);
    var_241 = wp::bit_and(var_235, var_240);
    // c2 = p0 >> uint64(32) ^ c3 ^ key1                                                      <L 14>
    var_242 = 32ull;
    var_243 = wp::rshift(var_233, var_242);
    var_244 = wp::bit_xor(var_243, var_222);
    var_245 = wp::bit_xor(var_244, var_230);
    // c3 = p0 & uint64(LOW_WORD)                                                             <L 15>
    var_246 = wp::uint64(var_15);
    var_247 = wp::bit_and(var_233, var_246);
    // key0 = key0 + uint64(WEYL_0) & uint64(LOW_WORD)                                        <L 16>
    var_248 = wp::uint64(var_23);
    var_249 = wp::add(var_226, var_248);
    var_250 = wp::uint64(var_15);
    var_251 = wp::bit_and(var_249, var_250);
    // key1 = key1 + uint64(WEYL_1) & uint64(LOW_WORD)                                        <L 17>
    var_252 = wp::uint64(var_27);
    var_253 = wp::add(var_230, var_252);
    var_254 = wp::uint64(var_15);
    var_255 = wp::bit_and(var_253, var_254);
    // return vec4u(uint32(c0), uint32(c1), uint32(c2), uint32(c3))                           <L 18>
    var_256 = wp::uint32(var_239);
    var_257 = wp::uint32(var_241);
    var_258 = wp::uint32(var_245);
    var_259 = wp::uint32(var_247);
    var_260 = wp::vec_t<4, wp::uint32>(var_256, var_257, var_258, var_259);
    return var_260;
}


// <pointloom.kernels.arrays.random.random_bits>:1
static CUDA_CALLABLE wp::vec_t<4, wp::uint32> random_bits_0(
    wp::int32 var_seed,
    wp::int32 var_counter,
    wp::int32 var_stream)
{
    //---------
    // primal vars
    wp::int64 var_0;
    wp::int64 var_1;
    wp::int64 var_2;
    wp::uint64 var_3;
    wp::int64 var_4;
    wp::int64 var_5;
    wp::int64 var_6;
    wp::uint64 var_7;
    wp::int64 var_8;
    wp::int64 var_9;
    wp::int64 var_10;
    wp::uint64 var_11;
    wp::uint64 var_12;
    wp::uint64 var_13;
    wp::uint64 var_14;
    wp::vec_t<4, wp::uint32> var_15;
    //---------
    // forward
    // def random_bits(seed, counter, stream):                                                <L 1>
    // key = uint64(int64(seed) & int64(LOW_WORD))                                            <L 3>
    var_0 = wp::int64(var_seed);
    var_1 = 4294967295ll;
    var_2 = wp::bit_and(var_0, var_1);
    var_3 = wp::uint64(var_2);
    // lane = uint64(int64(stream) & int64(LOW_WORD))                                         <L 4>
    var_4 = wp::int64(var_stream);
    var_5 = wp::int64(var_1);
    var_6 = wp::bit_and(var_4, var_5);
    var_7 = wp::uint64(var_6);
    // return philox(uint64(int64(counter) & int64(LOW_WORD)), uint64(0), lane, uint64(0), key, uint64(0))       <L 5>
    var_8 = wp::int64(var_counter);
    var_9 = wp::int64(var_1);
    var_10 = wp::bit_and(var_8, var_9);
    var_11 = wp::uint64(var_10);
    var_12 = 0ull;
    var_13 = 0ull;
    var_14 = 0ull;
    var_15 = philox_0(var_11, var_12, var_7, var_13, var_3, var_14);
    return var_15;
}


// <pointloom.kernels.arrays.random.unit_float>:1
static CUDA_CALLABLE wp::float32 unit_float_0(
    wp::uint32 var_word)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 8;
    wp::uint32 var_1;
    wp::uint32 var_2;
    wp::float32 var_3;
    const wp::float32 var_4 = 5.960464477539063e-08;
    wp::float32 var_5;
    //---------
    // forward
    // def unit_float(word):                                                                  <L 1>
    // return float32(word >> uint32(8)) * UNIT                                               <L 3>
    var_1 = wp::uint32(var_0);
    var_2 = wp::rshift(var_word, var_1);
    var_3 = wp::float32(var_2);
    var_5 = wp::mul(var_3, var_4);
    return var_5;
}


// /work/main/src/pointloom/kernels/arrays/random.py:66
static CUDA_CALLABLE wp::vec_t<4, wp::float32> random_uniform_0(
    wp::int32 var_seed,
    wp::int32 var_counter,
    wp::int32 var_stream)
{
    //---------
    // primal vars
    wp::vec_t<4, wp::uint32> var_0;
    const wp::int32 var_1 = 0;
    wp::uint32 var_2;
    wp::float32 var_3;
    const wp::int32 var_4 = 1;
    wp::uint32 var_5;
    wp::float32 var_6;
    const wp::int32 var_7 = 2;
    wp::uint32 var_8;
    wp::float32 var_9;
    const wp::int32 var_10 = 3;
    wp::uint32 var_11;
    wp::float32 var_12;
    wp::vec_t<4, wp::float32> var_13;
    //---------
    // forward
    // def random_uniform(seed: int, counter: int, stream: int) -> vec4:                      <L 67>
    // words = random_bits(seed, counter, stream)                                             <L 68>
    var_0 = random_bits_0(var_seed, var_counter, var_stream);
    // return vec4(unit_float(words[0]), unit_float(words[1]), unit_float(words[2]), unit_float(words[3]))       <L 69>
    var_2 = wp::extract(var_0, var_1);
    var_3 = unit_float_0(var_2);
    var_5 = wp::extract(var_0, var_4);
    var_6 = unit_float_0(var_5);
    var_8 = wp::extract(var_0, var_7);
    var_9 = unit_float_0(var_8);
    var_11 = wp::extract(var_0, var_10);
    var_12 = unit_float_0(var_11);
    var_13 = wp::vec_t<4, wp::float32>(var_3, var_6, var_9, var_12);
    return var_13;
}


// /work/main/src/pointloom/kernels/rgbd/keyframe_codes.py:18
static CUDA_CALLABLE wp::int32 fern_pixel_0(
    wp::float32 var_share,
    wp::int32 var_fern,
    wp::int32 var_stream,
    wp::int32 var_seed,
    wp::int32 var_width,
    wp::int32 var_height)
{
    //---------
    // primal vars
    wp::vec_t<4, wp::float32> var_0;
    const wp::int32 var_1 = 3;
    wp::float32 var_2;
    wp::float32 var_3;
    wp::float32 var_4;
    wp::int32 var_5;
    const wp::int32 var_6 = 1;
    wp::int32 var_7;
    wp::int32 var_8;
    wp::float32 var_9;
    wp::float32 var_10;
    wp::int32 var_11;
    const wp::int32 var_12 = 1;
    wp::int32 var_13;
    wp::int32 var_14;
    wp::int32 var_15;
    wp::int32 var_16;
    //---------
    // forward
    // def fern_pixel(share: float, fern: int, stream: int, seed: int, width: int, height: int) -> int:       <L 19>
    // column = min(int(random_uniform(seed, fern, stream)[3] * float(width)), width - 1)       <L 21>
    var_0 = random_uniform_0(var_seed, var_fern, var_stream);
    var_2 = wp::extract(var_0, var_1);
    var_3 = wp::float(var_width);
    var_4 = wp::mul(var_2, var_3);
    var_5 = wp::int(var_4);
    var_7 = wp::sub(var_width, var_6);
    var_8 = wp::min(var_5, var_7);
    // return min(int(share * float(height)), height - 1) * width + column                    <L 22>
    var_9 = wp::float(var_height);
    var_10 = wp::mul(var_share, var_9);
    var_11 = wp::int(var_10);
    var_13 = wp::sub(var_height, var_12);
    var_14 = wp::min(var_11, var_13);
    var_15 = wp::mul(var_14, var_width);
    var_16 = wp::add(var_15, var_8);
    return var_16;
}


// <pointloom.kernels.rgbd.keyframe_codes.comparison_bits>:1
static CUDA_CALLABLE wp::int32 comparison_bits_0(
    wp::int32 var_bit,
    wp::float32 var_a,
    wp::float32 var_b,
    wp::float32 var_ratio)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    bool var_2;
    const wp::float32 var_3 = 0.0;
    bool var_4;
    const wp::float32 var_5 = 0.0;
    bool var_6;
    const wp::int32 var_7 = 1;
    const wp::int32 var_8 = 4;
    wp::int32 var_9;
    wp::int32 var_10;
    wp::float32 var_11;
    bool var_12;
    const wp::int32 var_13 = 1;
    wp::int32 var_14;
    wp::int32 var_15;
    wp::int32 var_16;
    wp::int32 var_17;
    //---------
    // forward
    // def comparison_bits(bit, a, b, ratio):                                                 <L 1>
    // bits = int(0)                                                                          <L 3>
    var_1 = wp::int(var_0);
    // if a > 0.0 and b > 0.0:                                                                <L 4>
    var_4 = (var_a > var_3);
    var_2 = var_4;
    if (var_2) {
        var_6 = (var_b > var_5);
        var_2 = var_2 && var_6;
    }
    if (var_2) {
        // bits = 1 << bit + VALID_SHIFT                                                      <L 5>
        var_9 = wp::add(var_bit, var_8);
        var_10 = wp::lshift(var_7, var_9);
        // if a > b * ratio:                                                                  <L 6>
        var_11 = wp::mul(var_b, var_ratio);
        var_12 = (var_a > var_11);
        if (var_12) {
            // bits = bits | 1 << bit                                                         <L 7>
            var_14 = wp::lshift(var_13, var_bit);
            var_15 = wp::bit_or(var_10, var_14);
        }
        var_16 = wp::where(var_12, var_15, var_10);
    }
    var_17 = wp::where(var_2, var_16, var_1);
    // return bits                                                                            <L 8>
    return var_17;
}


// /work/main/src/pointloom/kernels/rgbd/keyframe_codes.py:62
static CUDA_CALLABLE wp::int32 count_bits_0(
    wp::int32 var_value)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 1;
    wp::int32 var_1;
    const wp::int32 var_2 = 1;
    wp::int32 var_3;
    const wp::int32 var_4 = 1;
    wp::int32 var_5;
    wp::int32 var_6;
    const wp::int32 var_7 = 2;
    wp::int32 var_8;
    const wp::int32 var_9 = 1;
    wp::int32 var_10;
    wp::int32 var_11;
    const wp::int32 var_12 = 3;
    wp::int32 var_13;
    const wp::int32 var_14 = 1;
    wp::int32 var_15;
    wp::int32 var_16;
    //---------
    // forward
    // def count_bits(value: int) -> int:                                                     <L 63>
    // return (value & 1) + (value >> 1 & 1) + (value >> 2 & 1) + (value >> 3 & 1)            <L 64>
    var_1 = wp::bit_and(var_value, var_0);
    var_3 = wp::rshift(var_value, var_2);
    var_5 = wp::bit_and(var_3, var_4);
    var_6 = wp::add(var_1, var_5);
    var_8 = wp::rshift(var_value, var_7);
    var_10 = wp::bit_and(var_8, var_9);
    var_11 = wp::add(var_6, var_10);
    var_13 = wp::rshift(var_value, var_12);
    var_15 = wp::bit_and(var_13, var_14);
    var_16 = wp::add(var_11, var_15);
    return var_16;
}


// <pointloom.kernels.arrays.random.philox>:1
static CUDA_CALLABLE void adj_philox_0(
    wp::uint64 var_x0,
    wp::uint64 var_x1,
    wp::uint64 var_x2,
    wp::uint64 var_x3,
    wp::uint64 var_k0,
    wp::uint64 var_k1,
    wp::uint64 & adj_x0,
    wp::uint64 & adj_x1,
    wp::uint64 & adj_x2,
    wp::uint64 & adj_x3,
    wp::uint64 & adj_k0,
    wp::uint64 & adj_k1,
    wp::vec_t<4, wp::uint32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.arrays.random.random_bits>:1
static CUDA_CALLABLE void adj_random_bits_0(
    wp::int32 var_seed,
    wp::int32 var_counter,
    wp::int32 var_stream,
    wp::int32 & adj_seed,
    wp::int32 & adj_counter,
    wp::int32 & adj_stream,
    wp::vec_t<4, wp::uint32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.arrays.random.unit_float>:1
static CUDA_CALLABLE void adj_unit_float_0(
    wp::uint32 var_word,
    wp::uint32 & adj_word,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/arrays/random.py:66
static CUDA_CALLABLE void adj_random_uniform_0(
    wp::int32 var_seed,
    wp::int32 var_counter,
    wp::int32 var_stream,
    wp::int32 & adj_seed,
    wp::int32 & adj_counter,
    wp::int32 & adj_stream,
    wp::vec_t<4, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/rgbd/keyframe_codes.py:18
static CUDA_CALLABLE void adj_fern_pixel_0(
    wp::float32 var_share,
    wp::int32 var_fern,
    wp::int32 var_stream,
    wp::int32 var_seed,
    wp::int32 var_width,
    wp::int32 var_height,
    wp::float32 & adj_share,
    wp::int32 & adj_fern,
    wp::int32 & adj_stream,
    wp::int32 & adj_seed,
    wp::int32 & adj_width,
    wp::int32 & adj_height,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.rgbd.keyframe_codes.comparison_bits>:1
static CUDA_CALLABLE void adj_comparison_bits_0(
    wp::int32 var_bit,
    wp::float32 var_a,
    wp::float32 var_b,
    wp::float32 var_ratio,
    wp::int32 & adj_bit,
    wp::float32 & adj_a,
    wp::float32 & adj_b,
    wp::float32 & adj_ratio,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/rgbd/keyframe_codes.py:62
static CUDA_CALLABLE void adj_count_bits_0(
    wp::int32 var_value,
    wp::int32 & adj_value,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void encode_ferns_kernel_795acca2_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_depth,
    wp::array_t<wp::float32> var_brightness,
    wp::int32 var_first,
    wp::int32 var_width,
    wp::int32 var_height,
    wp::int32 var_seed,
    wp::int32 var_offset,
    wp::array_t<wp::uint8> var_codes)
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
        wp::vec_t<4, wp::float32> var_2;
        const wp::int32 var_3 = 1;
        wp::vec_t<4, wp::float32> var_4;
        const wp::int32 var_5 = 0;
        wp::float32 var_6;
        const wp::int32 var_7 = 2;
        wp::int32 var_8;
        wp::int32 var_9;
        const wp::int32 var_10 = 1;
        wp::float32 var_11;
        const wp::int32 var_12 = 3;
        wp::int32 var_13;
        wp::int32 var_14;
        const wp::int32 var_15 = 2;
        wp::float32 var_16;
        const wp::int32 var_17 = 4;
        wp::int32 var_18;
        wp::int32 var_19;
        const wp::int32 var_20 = 0;
        wp::float32 var_21;
        const wp::int32 var_22 = 1;
        wp::float32 var_23;
        const wp::int32 var_24 = 2;
        wp::float32 var_25;
        const wp::int32 var_26 = 3;
        wp::float32 var_27;
        wp::vec_t<4, wp::float32> var_28;
        const wp::float32 var_29 = 0.9;
        wp::vec_t<4, wp::float32> var_30;
        const wp::float32 var_31 = 0.6;
        wp::vec_t<4, wp::float32> var_32;
        wp::vec_t<4, wp::float32> var_33;
        const wp::int32 var_34 = 0;
        wp::float32* var_35;
        const wp::float32 var_36 = 0.4;
        const wp::int32 var_37 = 0;
        wp::float32 var_38;
        const wp::float32 var_39 = 4.0;
        wp::float32 var_40;
        wp::float32 var_41;
        const wp::float32 var_42 = 1.0;
        wp::int32 var_43;
        wp::float32 var_44;
        const wp::int32 var_45 = 1;
        wp::float32* var_46;
        wp::float32* var_47;
        const wp::int32 var_48 = 1;
        wp::float32 var_49;
        wp::int32 var_50;
        wp::float32 var_51;
        wp::float32 var_52;
        wp::int32 var_53;
        const wp::int32 var_54 = 2;
        wp::float32* var_55;
        wp::float32* var_56;
        const wp::int32 var_57 = 2;
        wp::float32 var_58;
        wp::int32 var_59;
        wp::float32 var_60;
        wp::float32 var_61;
        wp::int32 var_62;
        const wp::int32 var_63 = 3;
        wp::float32* var_64;
        wp::float32* var_65;
        const wp::int32 var_66 = 3;
        wp::float32 var_67;
        wp::int32 var_68;
        wp::float32 var_69;
        wp::float32 var_70;
        wp::int32 var_71;
        wp::uint8 var_72;
        wp::int32 var_73;
        //---------
        // forward
        // def encode_ferns_kernel(                                                               <L 37>
        // i = tid()                                                                              <L 48>
        var_0 = builtin_tid1d();
        // u = random_uniform(seed, i, PIXEL_STREAM)                                              <L 49>
        var_2 = random_uniform_0(var_seed, var_0, var_1);
        // w = random_uniform(seed, i, RATIO_STREAM)                                              <L 50>
        var_4 = random_uniform_0(var_seed, var_0, var_3);
        // a = first + fern_pixel(u[0], i, 2, seed, width, height)                                <L 51>
        var_6 = wp::extract(var_2, var_5);
        var_8 = fern_pixel_0(var_6, var_0, var_7, var_seed, var_width, var_height);
        var_9 = wp::add(var_first, var_8);
        // b = first + fern_pixel(u[1], i, 3, seed, width, height)                                <L 52>
        var_11 = wp::extract(var_2, var_10);
        var_13 = fern_pixel_0(var_11, var_0, var_12, var_seed, var_width, var_height);
        var_14 = wp::add(var_first, var_13);
        // c = first + fern_pixel(u[2], i, 4, seed, width, height)                                <L 53>
        var_16 = wp::extract(var_2, var_15);
        var_18 = fern_pixel_0(var_16, var_0, var_17, var_seed, var_width, var_height);
        var_19 = wp::add(var_first, var_18);
        // ratios = vec4(w[0], w[1], w[2], w[3]) * RATIOS + vec4(MIN_RATIO, MIN_RATIO, MIN_RATIO, MIN_RATIO)       <L 54>
        var_21 = wp::extract(var_4, var_20);
        var_23 = wp::extract(var_4, var_22);
        var_25 = wp::extract(var_4, var_24);
        var_27 = wp::extract(var_4, var_26);
        var_28 = wp::vec_t<4, wp::float32>(var_21, var_23, var_25, var_27);
        var_30 = wp::mul(var_28, var_29);
        var_32 = wp::vec_t<4, wp::float32>(var_31, var_31, var_31, var_31);
        var_33 = wp::add(var_30, var_32);
        // code = comparison_bits(0, depth[a], SHALLOWEST + w[0] * RANGE, 1.0)                    <L 55>
        var_35 = wp::address(var_depth, var_9);
        var_38 = wp::extract(var_4, var_37);
        var_40 = wp::mul(var_38, var_39);
        var_41 = wp::add(var_36, var_40);
        var_44 = wp::load(var_35);
        var_43 = comparison_bits_0(var_34, var_44, var_41, var_42);
        // code = code | comparison_bits(1, depth[a], depth[b], ratios[1])                        <L 56>
        var_46 = wp::address(var_depth, var_9);
        var_47 = wp::address(var_depth, var_14);
        var_49 = wp::extract(var_33, var_48);
        var_51 = wp::load(var_46);
        var_52 = wp::load(var_47);
        var_50 = comparison_bits_0(var_45, var_51, var_52, var_49);
        var_53 = wp::bit_or(var_43, var_50);
        // code = code | comparison_bits(2, brightness[a], brightness[b], ratios[2])              <L 57>
        var_55 = wp::address(var_brightness, var_9);
        var_56 = wp::address(var_brightness, var_14);
        var_58 = wp::extract(var_33, var_57);
        var_60 = wp::load(var_55);
        var_61 = wp::load(var_56);
        var_59 = comparison_bits_0(var_54, var_60, var_61, var_58);
        var_62 = wp::bit_or(var_53, var_59);
        // code = code | comparison_bits(3, brightness[b], brightness[c], ratios[3])              <L 58>
        var_64 = wp::address(var_brightness, var_14);
        var_65 = wp::address(var_brightness, var_19);
        var_67 = wp::extract(var_33, var_66);
        var_69 = wp::load(var_64);
        var_70 = wp::load(var_65);
        var_68 = comparison_bits_0(var_63, var_69, var_70, var_67);
        var_71 = wp::bit_or(var_62, var_68);
        // codes[offset + i] = uint8(code)                                                        <L 59>
        var_72 = wp::uint8(var_71);
        var_73 = wp::add(var_offset, var_0);
        wp::array_store(var_codes, var_73, var_72);
}



extern "C" __global__ void compare_codes_kernel_8b0c1b7b_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::uint8> var_code,
    wp::array_t<wp::uint8> var_codes,
    wp::array_t<wp::int32> var_counts)
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
        const wp::int32 var_3 = 0;
        wp::int32 var_4;
        wp::shape_t* var_5;
        const wp::int32 var_6 = 0;
        wp::int32 var_7;
        wp::shape_t var_8;
        wp::range_t var_9;
        wp::int32 var_10;
        wp::uint8* var_11;
        wp::int32 var_12;
        wp::uint8 var_13;
        const wp::int32 var_14 = 512;
        wp::int32 var_15;
        wp::int32 var_16;
        wp::uint8* var_17;
        wp::int32 var_18;
        wp::uint8 var_19;
        wp::int32 var_20;
        const wp::int32 var_21 = 4;
        wp::int32 var_22;
        wp::int32 var_23;
        wp::int32 var_24;
        wp::int32 var_25;
        wp::int32 var_26;
        wp::int32 var_27;
        wp::int32 var_28;
        const wp::int32 var_29 = 0;
        const wp::int32 var_30 = 1;
        //---------
        // forward
        // def compare_codes_kernel(code, codes, counts):                                         <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // common = int(0)                                                                        <L 4>
        var_2 = wp::int(var_1);
        // different = int(0)                                                                     <L 5>
        var_4 = wp::int(var_3);
        // for j in range(code.shape[0]):                                                         <L 6>
        var_5 = &(var_code.shape);
        var_8 = wp::load(var_5);
        var_7 = wp::extract(var_8, var_6);
        var_9 = wp::range(var_7);
        start_for_0:;
            if (iter_cmp(var_9) == 0) goto end_for_0;
            var_10 = wp::iter_next(var_9);
            // x = int(code[j])                                                                   <L 7>
            var_11 = wp::address(var_code, var_10);
            var_13 = wp::load(var_11);
            var_12 = wp::int(var_13);
            // y = int(codes[i * FERNS + j])                                                      <L 8>
            var_15 = wp::mul(var_0, var_14);
            var_16 = wp::add(var_15, var_10);
            var_17 = wp::address(var_codes, var_16);
            var_19 = wp::load(var_17);
            var_18 = wp::int(var_19);
            // both = (x & y) >> VALID_SHIFT                                                      <L 9>
            var_20 = wp::bit_and(var_12, var_18);
            var_22 = wp::rshift(var_20, var_21);
            // common += count_bits(both)                                                         <L 10>
            var_23 = count_bits_0(var_22);
            var_24 = wp::add(var_2, var_23);
            // different += count_bits((x ^ y) & both)                                            <L 11>
            var_25 = wp::bit_xor(var_12, var_18);
            var_26 = wp::bit_and(var_25, var_22);
            var_27 = count_bits_0(var_26);
            var_28 = wp::add(var_4, var_27);
            wp::assign(var_2, var_24);
            wp::assign(var_4, var_28);
            goto start_for_0;
        end_for_0:;
        // counts[i, 0] = common                                                                  <L 12>
        wp::array_store(var_counts, var_0, var_29, var_2);
        // counts[i, 1] = different                                                               <L 13>
        wp::array_store(var_counts, var_0, var_30, var_4);
}


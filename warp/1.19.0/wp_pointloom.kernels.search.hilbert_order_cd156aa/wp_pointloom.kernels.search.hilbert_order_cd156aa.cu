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


// <pointloom.kernels.search.hilbert_order.scale_of_box>:1
static CUDA_CALLABLE wp::float32 scale_of_box_0(
    wp::vec_t<3, wp::float32> var_low,
    wp::vec_t<3, wp::float32> var_high,
    wp::int32 var_levels)
{
    //---------
    // primal vars
    wp::float64 var_0;
    const wp::int32 var_1 = 0;
    wp::float32 var_2;
    wp::float64 var_3;
    wp::float32 var_4;
    wp::float64 var_5;
    wp::float64 var_6;
    wp::float64 var_7;
    const wp::int32 var_8 = 1;
    wp::float32 var_9;
    wp::float64 var_10;
    wp::float32 var_11;
    wp::float64 var_12;
    wp::float64 var_13;
    wp::float64 var_14;
    const wp::int32 var_15 = 2;
    wp::float32 var_16;
    wp::float64 var_17;
    wp::float32 var_18;
    wp::float64 var_19;
    wp::float64 var_20;
    wp::float64 var_21;
    const wp::float32 var_22 = 0.0;
    wp::float32 var_23;
    wp::float64 var_24;
    bool var_25;
    const wp::int32 var_26 = 1;
    wp::int32 var_27;
    const wp::int32 var_28 = 1;
    wp::int32 var_29;
    wp::float64 var_30;
    wp::float64 var_31;
    wp::float32 var_32;
    wp::float32 var_33;
    //---------
    // forward
    // def scale_of_box(low, high, levels):                                                   <L 1>
    // extent = float64(0.0)                                                                  <L 3>
    var_0 = 0.0;
    // for axis in range(3):                                                                  <L 4>
    // extent = max(extent, float64(high[axis]) - float64(low[axis]))                         <L 5>
    var_2 = wp::extract(var_high, var_1);
    var_3 = wp::float64(var_2);
    var_4 = wp::extract(var_low, var_1);
    var_5 = wp::float64(var_4);
    var_6 = wp::sub(var_3, var_5);
    var_7 = wp::max(var_0, var_6);
    var_9 = wp::extract(var_high, var_8);
    var_10 = wp::float64(var_9);
    var_11 = wp::extract(var_low, var_8);
    var_12 = wp::float64(var_11);
    var_13 = wp::sub(var_10, var_12);
    var_14 = wp::max(var_7, var_13);
    var_16 = wp::extract(var_high, var_15);
    var_17 = wp::float64(var_16);
    var_18 = wp::extract(var_low, var_15);
    var_19 = wp::float64(var_18);
    var_20 = wp::sub(var_17, var_19);
    var_21 = wp::max(var_14, var_20);
    // scale = float(0.0)                                                                     <L 6>
    var_23 = wp::float(var_22);
    // if extent > float64(SMALLEST_EXTENT):                                                  <L 7>
    var_24 = 1e-33;
    var_25 = (var_21 > var_24);
    if (var_25) {
        // scale = float(float64((1 << levels) - 1) / extent)                                 <L 8>
        var_27 = wp::lshift(var_26, var_levels);
        var_29 = wp::sub(var_27, var_28);
        var_30 = wp::float64(var_29);
        var_31 = wp::div(var_30, var_21);
        var_32 = wp::float(var_31);
    }
    var_33 = wp::where(var_25, var_32, var_23);
    // return scale                                                                           <L 9>
    return var_33;
}


// /work/main/src/pointloom/kernels/search/hilbert_order.py:102
static CUDA_CALLABLE wp::int32 cell_on_axis_0(
    wp::float32 var_coordinate,
    wp::float32 var_low,
    wp::float32 var_scale,
    wp::int32 var_levels)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 1;
    wp::int32 var_1;
    const wp::int32 var_2 = 1;
    wp::int32 var_3;
    wp::float32 var_4;
    wp::float32 var_5;
    wp::float32 var_6;
    const wp::float32 var_7 = 0.0;
    wp::float32 var_8;
    wp::float32 var_9;
    wp::int32 var_10;
    //---------
    // forward
    // def cell_on_axis(coordinate: float, low: float, scale: float, levels: int) -> int:       <L 103>
    // top = float((1 << levels) - 1)                                                         <L 104>
    var_1 = wp::lshift(var_0, var_levels);
    var_3 = wp::sub(var_1, var_2);
    var_4 = wp::float(var_3);
    // return int(min(max((coordinate - low) * scale, 0.0), top))                             <L 105>
    var_5 = wp::sub(var_coordinate, var_low);
    var_6 = wp::mul(var_5, var_scale);
    var_8 = wp::max(var_6, var_7);
    var_9 = wp::min(var_8, var_4);
    var_10 = wp::int(var_9);
    return var_10;
}


// <pointloom.kernels.search.hilbert_order.spread_bits>:1
static CUDA_CALLABLE wp::int64 spread_bits_0(
    wp::int32 var_v)
{
    //---------
    // primal vars
    wp::int64 var_0;
    wp::int64 var_1;
    wp::int64 var_2;
    wp::int64 var_3;
    wp::int64 var_4;
    wp::int64 var_5;
    wp::int64 var_6;
    wp::int64 var_7;
    wp::int64 var_8;
    wp::int64 var_9;
    wp::int64 var_10;
    wp::int64 var_11;
    wp::int64 var_12;
    wp::int64 var_13;
    wp::int64 var_14;
    wp::int64 var_15;
    wp::int64 var_16;
    wp::int64 var_17;
    wp::int64 var_18;
    wp::int64 var_19;
    wp::int64 var_20;
    wp::int64 var_21;
    wp::int64 var_22;
    wp::int64 var_23;
    wp::int64 var_24;
    wp::int64 var_25;
    //---------
    // forward
    // def spread_bits(v):                                                                    <L 1>
    // x = int64(v)                                                                           <L 3>
    var_0 = wp::int64(var_v);
    // x = (x | x << int64(32)) & int64(8725724278095871)                                     <L 4>
    var_1 = 32ll;
    var_2 = wp::lshift(var_0, var_1);
    var_3 = wp::bit_or(var_0, var_2);
    var_4 = 8725724278095871ll;
    var_5 = wp::bit_and(var_3, var_4);
    // x = (x | x << int64(16)) & int64(8725728556220671)                                     <L 5>
    var_6 = 16ll;
    var_7 = wp::lshift(var_5, var_6);
    var_8 = wp::bit_or(var_5, var_7);
    var_9 = 8725728556220671ll;
    var_10 = wp::bit_and(var_8, var_9);
    // x = (x | x << int64(8)) & int64(1157144660301377551)                                   <L 6>
    var_11 = 8ll;
    var_12 = wp::lshift(var_10, var_11);
    var_13 = wp::bit_or(var_10, var_12);
    var_14 = 1157144660301377551ll;
    var_15 = wp::bit_and(var_13, var_14);
    // x = (x | x << int64(4)) & int64(1207822528635744451)                                   <L 7>
    var_16 = 4ll;
    var_17 = wp::lshift(var_15, var_16);
    var_18 = wp::bit_or(var_15, var_17);
    var_19 = 1207822528635744451ll;
    var_20 = wp::bit_and(var_18, var_19);
    // return (x | x << int64(2)) & int64(1317624576693539401)                                <L 8>
    var_21 = 2ll;
    var_22 = wp::lshift(var_20, var_21);
    var_23 = wp::bit_or(var_20, var_22);
    var_24 = 1317624576693539401ll;
    var_25 = wp::bit_and(var_23, var_24);
    return var_25;
}


// <pointloom.kernels.search.hilbert_order.hilbert_codes>:1
static CUDA_CALLABLE wp::vec_t<8, wp::int64> hilbert_codes_0(
    wp::vec_t<8, wp::int32> var_cx,
    wp::vec_t<8, wp::int32> var_cy,
    wp::vec_t<8, wp::int32> var_cz,
    wp::int32 var_levels)
{
    //---------
    // primal vars
    wp::vec_t<8, wp::int32> var_0;
    wp::vec_t<8, wp::int32> var_1;
    wp::vec_t<8, wp::int32> var_2;
    const wp::int32 var_3 = 1;
    wp::range_t var_4;
    wp::int32 var_5;
    wp::int32 var_6;
    const wp::int32 var_7 = 1;
    wp::int32 var_8;
    const wp::int32 var_9 = 1;
    wp::int32 var_10;
    const wp::int32 var_11 = 0;
    wp::int32 var_12;
    wp::int32 var_13;
    wp::int32 var_14;
    const wp::int32 var_15 = 1;
    wp::int32 var_16;
    wp::int32 var_17;
    wp::int32 var_18;
    wp::int32 var_19;
    wp::int32 var_20;
    wp::int32 var_21;
    const wp::int32 var_22 = 1;
    wp::int32 var_23;
    wp::int32 var_24;
    wp::int32 var_25;
    wp::int32 var_26;
    wp::int32 var_27;
    wp::int32 var_28;
    wp::int32 var_29;
    wp::int32 var_30;
    wp::int32 var_31;
    wp::int32 var_32;
    wp::int32 var_33;
    wp::int32 var_34;
    wp::int32 var_35;
    wp::int32 var_36;
    wp::int32 var_37;
    wp::int32 var_38;
    const wp::int32 var_39 = 1;
    wp::int32 var_40;
    wp::int32 var_41;
    wp::int32 var_42;
    wp::int32 var_43;
    wp::int32 var_44;
    wp::int32 var_45;
    wp::int32 var_46;
    wp::int32 var_47;
    wp::int32 var_48;
    wp::int32 var_49;
    wp::int32 var_50;
    wp::int32 var_51;
    wp::int32 var_52;
    wp::int32 var_53;
    const wp::int32 var_54 = 1;
    wp::int32 var_55;
    wp::int32 var_56;
    wp::int32 var_57;
    const wp::int32 var_58 = 1;
    wp::int32 var_59;
    wp::int32 var_60;
    wp::int32 var_61;
    wp::int32 var_62;
    wp::int32 var_63;
    wp::int32 var_64;
    const wp::int32 var_65 = 1;
    wp::int32 var_66;
    wp::int32 var_67;
    wp::int32 var_68;
    wp::int32 var_69;
    wp::int32 var_70;
    wp::int32 var_71;
    wp::int32 var_72;
    wp::int32 var_73;
    wp::int32 var_74;
    wp::int32 var_75;
    wp::int32 var_76;
    wp::int32 var_77;
    wp::int32 var_78;
    wp::int32 var_79;
    wp::int32 var_80;
    wp::int32 var_81;
    const wp::int32 var_82 = 1;
    wp::int32 var_83;
    wp::int32 var_84;
    wp::int32 var_85;
    wp::int32 var_86;
    wp::int32 var_87;
    wp::int32 var_88;
    wp::int32 var_89;
    wp::int32 var_90;
    wp::int32 var_91;
    wp::int32 var_92;
    wp::int32 var_93;
    wp::int32 var_94;
    wp::int32 var_95;
    wp::int32 var_96;
    const wp::int32 var_97 = 2;
    wp::int32 var_98;
    wp::int32 var_99;
    wp::int32 var_100;
    const wp::int32 var_101 = 1;
    wp::int32 var_102;
    wp::int32 var_103;
    wp::int32 var_104;
    wp::int32 var_105;
    wp::int32 var_106;
    wp::int32 var_107;
    const wp::int32 var_108 = 1;
    wp::int32 var_109;
    wp::int32 var_110;
    wp::int32 var_111;
    wp::int32 var_112;
    wp::int32 var_113;
    wp::int32 var_114;
    wp::int32 var_115;
    wp::int32 var_116;
    wp::int32 var_117;
    wp::int32 var_118;
    wp::int32 var_119;
    wp::int32 var_120;
    wp::int32 var_121;
    wp::int32 var_122;
    wp::int32 var_123;
    wp::int32 var_124;
    const wp::int32 var_125 = 1;
    wp::int32 var_126;
    wp::int32 var_127;
    wp::int32 var_128;
    wp::int32 var_129;
    wp::int32 var_130;
    wp::int32 var_131;
    wp::int32 var_132;
    wp::int32 var_133;
    wp::int32 var_134;
    wp::int32 var_135;
    wp::int32 var_136;
    wp::int32 var_137;
    wp::int32 var_138;
    wp::int32 var_139;
    const wp::int32 var_140 = 3;
    wp::int32 var_141;
    wp::int32 var_142;
    wp::int32 var_143;
    const wp::int32 var_144 = 1;
    wp::int32 var_145;
    wp::int32 var_146;
    wp::int32 var_147;
    wp::int32 var_148;
    wp::int32 var_149;
    wp::int32 var_150;
    const wp::int32 var_151 = 1;
    wp::int32 var_152;
    wp::int32 var_153;
    wp::int32 var_154;
    wp::int32 var_155;
    wp::int32 var_156;
    wp::int32 var_157;
    wp::int32 var_158;
    wp::int32 var_159;
    wp::int32 var_160;
    wp::int32 var_161;
    wp::int32 var_162;
    wp::int32 var_163;
    wp::int32 var_164;
    wp::int32 var_165;
    wp::int32 var_166;
    wp::int32 var_167;
    const wp::int32 var_168 = 1;
    wp::int32 var_169;
    wp::int32 var_170;
    wp::int32 var_171;
    wp::int32 var_172;
    wp::int32 var_173;
    wp::int32 var_174;
    wp::int32 var_175;
    wp::int32 var_176;
    wp::int32 var_177;
    wp::int32 var_178;
    wp::int32 var_179;
    wp::int32 var_180;
    wp::int32 var_181;
    wp::int32 var_182;
    const wp::int32 var_183 = 4;
    wp::int32 var_184;
    wp::int32 var_185;
    wp::int32 var_186;
    const wp::int32 var_187 = 1;
    wp::int32 var_188;
    wp::int32 var_189;
    wp::int32 var_190;
    wp::int32 var_191;
    wp::int32 var_192;
    wp::int32 var_193;
    const wp::int32 var_194 = 1;
    wp::int32 var_195;
    wp::int32 var_196;
    wp::int32 var_197;
    wp::int32 var_198;
    wp::int32 var_199;
    wp::int32 var_200;
    wp::int32 var_201;
    wp::int32 var_202;
    wp::int32 var_203;
    wp::int32 var_204;
    wp::int32 var_205;
    wp::int32 var_206;
    wp::int32 var_207;
    wp::int32 var_208;
    wp::int32 var_209;
    wp::int32 var_210;
    const wp::int32 var_211 = 1;
    wp::int32 var_212;
    wp::int32 var_213;
    wp::int32 var_214;
    wp::int32 var_215;
    wp::int32 var_216;
    wp::int32 var_217;
    wp::int32 var_218;
    wp::int32 var_219;
    wp::int32 var_220;
    wp::int32 var_221;
    wp::int32 var_222;
    wp::int32 var_223;
    wp::int32 var_224;
    wp::int32 var_225;
    const wp::int32 var_226 = 5;
    wp::int32 var_227;
    wp::int32 var_228;
    wp::int32 var_229;
    const wp::int32 var_230 = 1;
    wp::int32 var_231;
    wp::int32 var_232;
    wp::int32 var_233;
    wp::int32 var_234;
    wp::int32 var_235;
    wp::int32 var_236;
    const wp::int32 var_237 = 1;
    wp::int32 var_238;
    wp::int32 var_239;
    wp::int32 var_240;
    wp::int32 var_241;
    wp::int32 var_242;
    wp::int32 var_243;
    wp::int32 var_244;
    wp::int32 var_245;
    wp::int32 var_246;
    wp::int32 var_247;
    wp::int32 var_248;
    wp::int32 var_249;
    wp::int32 var_250;
    wp::int32 var_251;
    wp::int32 var_252;
    wp::int32 var_253;
    const wp::int32 var_254 = 1;
    wp::int32 var_255;
    wp::int32 var_256;
    wp::int32 var_257;
    wp::int32 var_258;
    wp::int32 var_259;
    wp::int32 var_260;
    wp::int32 var_261;
    wp::int32 var_262;
    wp::int32 var_263;
    wp::int32 var_264;
    wp::int32 var_265;
    wp::int32 var_266;
    wp::int32 var_267;
    wp::int32 var_268;
    const wp::int32 var_269 = 6;
    wp::int32 var_270;
    wp::int32 var_271;
    wp::int32 var_272;
    const wp::int32 var_273 = 1;
    wp::int32 var_274;
    wp::int32 var_275;
    wp::int32 var_276;
    wp::int32 var_277;
    wp::int32 var_278;
    wp::int32 var_279;
    const wp::int32 var_280 = 1;
    wp::int32 var_281;
    wp::int32 var_282;
    wp::int32 var_283;
    wp::int32 var_284;
    wp::int32 var_285;
    wp::int32 var_286;
    wp::int32 var_287;
    wp::int32 var_288;
    wp::int32 var_289;
    wp::int32 var_290;
    wp::int32 var_291;
    wp::int32 var_292;
    wp::int32 var_293;
    wp::int32 var_294;
    wp::int32 var_295;
    wp::int32 var_296;
    const wp::int32 var_297 = 1;
    wp::int32 var_298;
    wp::int32 var_299;
    wp::int32 var_300;
    wp::int32 var_301;
    wp::int32 var_302;
    wp::int32 var_303;
    wp::int32 var_304;
    wp::int32 var_305;
    wp::int32 var_306;
    wp::int32 var_307;
    wp::int32 var_308;
    wp::int32 var_309;
    wp::int32 var_310;
    wp::int32 var_311;
    const wp::int32 var_312 = 7;
    wp::int32 var_313;
    wp::int32 var_314;
    wp::int32 var_315;
    const wp::int32 var_316 = 1;
    wp::int32 var_317;
    wp::int32 var_318;
    wp::int32 var_319;
    wp::int32 var_320;
    wp::int32 var_321;
    wp::int32 var_322;
    const wp::int32 var_323 = 1;
    wp::int32 var_324;
    wp::int32 var_325;
    wp::int32 var_326;
    wp::int32 var_327;
    wp::int32 var_328;
    wp::int32 var_329;
    wp::int32 var_330;
    wp::int32 var_331;
    wp::int32 var_332;
    wp::int32 var_333;
    wp::int32 var_334;
    wp::int32 var_335;
    wp::int32 var_336;
    wp::int32 var_337;
    wp::int32 var_338;
    wp::int32 var_339;
    const wp::int32 var_340 = 1;
    wp::int32 var_341;
    wp::int32 var_342;
    wp::int32 var_343;
    wp::int32 var_344;
    wp::int32 var_345;
    wp::int32 var_346;
    wp::int32 var_347;
    wp::int32 var_348;
    wp::int32 var_349;
    wp::int32 var_350;
    wp::int32 var_351;
    wp::int32 var_352;
    wp::int32 var_353;
    wp::int32 var_354;
    wp::int64 var_355;
    wp::vec_t<8, wp::int64> var_356;
    const wp::int32 var_357 = 0;
    wp::int32 var_358;
    wp::int32 var_359;
    wp::int32 var_360;
    wp::int32 var_361;
    wp::int32 var_362;
    wp::int32 var_363;
    wp::int32 var_364;
    wp::int32 var_365;
    const wp::int32 var_366 = 1;
    wp::int32 var_367;
    wp::int32 var_368;
    const wp::int32 var_369 = 2;
    wp::int32 var_370;
    wp::int32 var_371;
    const wp::int32 var_372 = 4;
    wp::int32 var_373;
    wp::int32 var_374;
    const wp::int32 var_375 = 8;
    wp::int32 var_376;
    wp::int32 var_377;
    const wp::int32 var_378 = 1;
    wp::int32 var_379;
    wp::int32 var_380;
    wp::int32 var_381;
    wp::int32 var_382;
    wp::int32 var_383;
    wp::int32 var_384;
    wp::int32 var_385;
    wp::int32 var_386;
    wp::int64 var_387;
    wp::int64 var_388;
    wp::int64 var_389;
    wp::int32 var_390;
    wp::int64 var_391;
    wp::int64 var_392;
    wp::int64 var_393;
    wp::int64 var_394;
    wp::int32 var_395;
    wp::int64 var_396;
    wp::int64 var_397;
    const wp::int32 var_398 = 1;
    wp::int32 var_399;
    wp::int32 var_400;
    wp::int32 var_401;
    wp::int32 var_402;
    wp::int32 var_403;
    wp::int32 var_404;
    wp::int32 var_405;
    wp::int32 var_406;
    const wp::int32 var_407 = 1;
    wp::int32 var_408;
    wp::int32 var_409;
    const wp::int32 var_410 = 2;
    wp::int32 var_411;
    wp::int32 var_412;
    const wp::int32 var_413 = 4;
    wp::int32 var_414;
    wp::int32 var_415;
    const wp::int32 var_416 = 8;
    wp::int32 var_417;
    wp::int32 var_418;
    const wp::int32 var_419 = 1;
    wp::int32 var_420;
    wp::int32 var_421;
    wp::int32 var_422;
    wp::int32 var_423;
    wp::int32 var_424;
    wp::int32 var_425;
    wp::int32 var_426;
    wp::int32 var_427;
    wp::int64 var_428;
    wp::int64 var_429;
    wp::int64 var_430;
    wp::int32 var_431;
    wp::int64 var_432;
    wp::int64 var_433;
    wp::int64 var_434;
    wp::int64 var_435;
    wp::int32 var_436;
    wp::int64 var_437;
    wp::int64 var_438;
    const wp::int32 var_439 = 2;
    wp::int32 var_440;
    wp::int32 var_441;
    wp::int32 var_442;
    wp::int32 var_443;
    wp::int32 var_444;
    wp::int32 var_445;
    wp::int32 var_446;
    wp::int32 var_447;
    const wp::int32 var_448 = 1;
    wp::int32 var_449;
    wp::int32 var_450;
    const wp::int32 var_451 = 2;
    wp::int32 var_452;
    wp::int32 var_453;
    const wp::int32 var_454 = 4;
    wp::int32 var_455;
    wp::int32 var_456;
    const wp::int32 var_457 = 8;
    wp::int32 var_458;
    wp::int32 var_459;
    const wp::int32 var_460 = 1;
    wp::int32 var_461;
    wp::int32 var_462;
    wp::int32 var_463;
    wp::int32 var_464;
    wp::int32 var_465;
    wp::int32 var_466;
    wp::int32 var_467;
    wp::int32 var_468;
    wp::int64 var_469;
    wp::int64 var_470;
    wp::int64 var_471;
    wp::int32 var_472;
    wp::int64 var_473;
    wp::int64 var_474;
    wp::int64 var_475;
    wp::int64 var_476;
    wp::int32 var_477;
    wp::int64 var_478;
    wp::int64 var_479;
    const wp::int32 var_480 = 3;
    wp::int32 var_481;
    wp::int32 var_482;
    wp::int32 var_483;
    wp::int32 var_484;
    wp::int32 var_485;
    wp::int32 var_486;
    wp::int32 var_487;
    wp::int32 var_488;
    const wp::int32 var_489 = 1;
    wp::int32 var_490;
    wp::int32 var_491;
    const wp::int32 var_492 = 2;
    wp::int32 var_493;
    wp::int32 var_494;
    const wp::int32 var_495 = 4;
    wp::int32 var_496;
    wp::int32 var_497;
    const wp::int32 var_498 = 8;
    wp::int32 var_499;
    wp::int32 var_500;
    const wp::int32 var_501 = 1;
    wp::int32 var_502;
    wp::int32 var_503;
    wp::int32 var_504;
    wp::int32 var_505;
    wp::int32 var_506;
    wp::int32 var_507;
    wp::int32 var_508;
    wp::int32 var_509;
    wp::int64 var_510;
    wp::int64 var_511;
    wp::int64 var_512;
    wp::int32 var_513;
    wp::int64 var_514;
    wp::int64 var_515;
    wp::int64 var_516;
    wp::int64 var_517;
    wp::int32 var_518;
    wp::int64 var_519;
    wp::int64 var_520;
    const wp::int32 var_521 = 4;
    wp::int32 var_522;
    wp::int32 var_523;
    wp::int32 var_524;
    wp::int32 var_525;
    wp::int32 var_526;
    wp::int32 var_527;
    wp::int32 var_528;
    wp::int32 var_529;
    const wp::int32 var_530 = 1;
    wp::int32 var_531;
    wp::int32 var_532;
    const wp::int32 var_533 = 2;
    wp::int32 var_534;
    wp::int32 var_535;
    const wp::int32 var_536 = 4;
    wp::int32 var_537;
    wp::int32 var_538;
    const wp::int32 var_539 = 8;
    wp::int32 var_540;
    wp::int32 var_541;
    const wp::int32 var_542 = 1;
    wp::int32 var_543;
    wp::int32 var_544;
    wp::int32 var_545;
    wp::int32 var_546;
    wp::int32 var_547;
    wp::int32 var_548;
    wp::int32 var_549;
    wp::int32 var_550;
    wp::int64 var_551;
    wp::int64 var_552;
    wp::int64 var_553;
    wp::int32 var_554;
    wp::int64 var_555;
    wp::int64 var_556;
    wp::int64 var_557;
    wp::int64 var_558;
    wp::int32 var_559;
    wp::int64 var_560;
    wp::int64 var_561;
    const wp::int32 var_562 = 5;
    wp::int32 var_563;
    wp::int32 var_564;
    wp::int32 var_565;
    wp::int32 var_566;
    wp::int32 var_567;
    wp::int32 var_568;
    wp::int32 var_569;
    wp::int32 var_570;
    const wp::int32 var_571 = 1;
    wp::int32 var_572;
    wp::int32 var_573;
    const wp::int32 var_574 = 2;
    wp::int32 var_575;
    wp::int32 var_576;
    const wp::int32 var_577 = 4;
    wp::int32 var_578;
    wp::int32 var_579;
    const wp::int32 var_580 = 8;
    wp::int32 var_581;
    wp::int32 var_582;
    const wp::int32 var_583 = 1;
    wp::int32 var_584;
    wp::int32 var_585;
    wp::int32 var_586;
    wp::int32 var_587;
    wp::int32 var_588;
    wp::int32 var_589;
    wp::int32 var_590;
    wp::int32 var_591;
    wp::int64 var_592;
    wp::int64 var_593;
    wp::int64 var_594;
    wp::int32 var_595;
    wp::int64 var_596;
    wp::int64 var_597;
    wp::int64 var_598;
    wp::int64 var_599;
    wp::int32 var_600;
    wp::int64 var_601;
    wp::int64 var_602;
    const wp::int32 var_603 = 6;
    wp::int32 var_604;
    wp::int32 var_605;
    wp::int32 var_606;
    wp::int32 var_607;
    wp::int32 var_608;
    wp::int32 var_609;
    wp::int32 var_610;
    wp::int32 var_611;
    const wp::int32 var_612 = 1;
    wp::int32 var_613;
    wp::int32 var_614;
    const wp::int32 var_615 = 2;
    wp::int32 var_616;
    wp::int32 var_617;
    const wp::int32 var_618 = 4;
    wp::int32 var_619;
    wp::int32 var_620;
    const wp::int32 var_621 = 8;
    wp::int32 var_622;
    wp::int32 var_623;
    const wp::int32 var_624 = 1;
    wp::int32 var_625;
    wp::int32 var_626;
    wp::int32 var_627;
    wp::int32 var_628;
    wp::int32 var_629;
    wp::int32 var_630;
    wp::int32 var_631;
    wp::int32 var_632;
    wp::int64 var_633;
    wp::int64 var_634;
    wp::int64 var_635;
    wp::int32 var_636;
    wp::int64 var_637;
    wp::int64 var_638;
    wp::int64 var_639;
    wp::int64 var_640;
    wp::int32 var_641;
    wp::int64 var_642;
    wp::int64 var_643;
    const wp::int32 var_644 = 7;
    wp::int32 var_645;
    wp::int32 var_646;
    wp::int32 var_647;
    wp::int32 var_648;
    wp::int32 var_649;
    wp::int32 var_650;
    wp::int32 var_651;
    wp::int32 var_652;
    const wp::int32 var_653 = 1;
    wp::int32 var_654;
    wp::int32 var_655;
    const wp::int32 var_656 = 2;
    wp::int32 var_657;
    wp::int32 var_658;
    const wp::int32 var_659 = 4;
    wp::int32 var_660;
    wp::int32 var_661;
    const wp::int32 var_662 = 8;
    wp::int32 var_663;
    wp::int32 var_664;
    const wp::int32 var_665 = 1;
    wp::int32 var_666;
    wp::int32 var_667;
    wp::int32 var_668;
    wp::int32 var_669;
    wp::int32 var_670;
    wp::int32 var_671;
    wp::int32 var_672;
    wp::int32 var_673;
    wp::int64 var_674;
    wp::int64 var_675;
    wp::int64 var_676;
    wp::int32 var_677;
    wp::int64 var_678;
    wp::int64 var_679;
    wp::int64 var_680;
    wp::int64 var_681;
    wp::int32 var_682;
    wp::int64 var_683;
    wp::int64 var_684;
    //---------
    // forward
    // def hilbert_codes(cx, cy, cz, levels):                                                 <L 1>
    // x = cx                                                                                 <L 3>
    var_0 = wp::copy(var_cx);
    // y = cy                                                                                 <L 4>
    var_1 = wp::copy(var_cy);
    // z = cz                                                                                 <L 5>
    var_2 = wp::copy(var_cz);
    // for level in range(1, levels):                                                         <L 6>
    var_4 = wp::range(var_3, var_levels);
    start_for_0:;
        if (iter_cmp(var_4) == 0) goto end_for_0;
        var_5 = wp::iter_next(var_4);
        // shift = levels - level                                                             <L 7>
        var_6 = wp::sub(var_levels, var_5);
        // low = (1 << shift) - 1                                                             <L 8>
        var_8 = wp::lshift(var_7, var_6);
        var_10 = wp::sub(var_8, var_9);
        // for j in range(LANES):                                                             <L 9>
        // x[j] = x[j] ^ low & -(x[j] >> shift & 1)                                           <L 10>
        var_12 = wp::extract(var_0, var_11);
        var_13 = wp::extract(var_0, var_11);
        var_14 = wp::rshift(var_13, var_6);
        var_16 = wp::bit_and(var_14, var_15);
        var_17 = wp::neg(var_16);
        var_18 = wp::bit_and(var_10, var_17);
        var_19 = wp::bit_xor(var_12, var_18);
        wp::assign_inplace(var_0, var_11, var_19);
        // set_y = -(y[j] >> shift & 1)                                                       <L 11>
        var_20 = wp::extract(var_1, var_11);
        var_21 = wp::rshift(var_20, var_6);
        var_23 = wp::bit_and(var_21, var_22);
        var_24 = wp::neg(var_23);
        // swapped = (x[j] ^ y[j]) & low & ~set_y                                             <L 12>
        var_25 = wp::extract(var_0, var_11);
        var_26 = wp::extract(var_1, var_11);
        var_27 = wp::bit_xor(var_25, var_26);
        var_28 = wp::bit_and(var_27, var_10);
        var_29 = wp::invert(var_24);
        var_30 = wp::bit_and(var_28, var_29);
        // x[j] = x[j] ^ (low & set_y | swapped)                                              <L 13>
        var_31 = wp::extract(var_0, var_11);
        var_32 = wp::bit_and(var_10, var_24);
        var_33 = wp::bit_or(var_32, var_30);
        var_34 = wp::bit_xor(var_31, var_33);
        wp::assign_inplace(var_0, var_11, var_34);
        // y[j] = y[j] ^ swapped                                                              <L 14>
        var_35 = wp::extract(var_1, var_11);
        var_36 = wp::bit_xor(var_35, var_30);
        wp::assign_inplace(var_1, var_11, var_36);
        // set_z = -(z[j] >> shift & 1)                                                       <L 15>
        var_37 = wp::extract(var_2, var_11);
        var_38 = wp::rshift(var_37, var_6);
        var_40 = wp::bit_and(var_38, var_39);
        var_41 = wp::neg(var_40);
        // exchanged = (x[j] ^ z[j]) & low & ~set_z                                           <L 16>
        var_42 = wp::extract(var_0, var_11);
        var_43 = wp::extract(var_2, var_11);
        var_44 = wp::bit_xor(var_42, var_43);
        var_45 = wp::bit_and(var_44, var_10);
        var_46 = wp::invert(var_41);
        var_47 = wp::bit_and(var_45, var_46);
        // x[j] = x[j] ^ (low & set_z | exchanged)                                            <L 17>
        var_48 = wp::extract(var_0, var_11);
        var_49 = wp::bit_and(var_10, var_41);
        var_50 = wp::bit_or(var_49, var_47);
        var_51 = wp::bit_xor(var_48, var_50);
        wp::assign_inplace(var_0, var_11, var_51);
        // z[j] = z[j] ^ exchanged                                                            <L 18>
        var_52 = wp::extract(var_2, var_11);
        var_53 = wp::bit_xor(var_52, var_47);
        wp::assign_inplace(var_2, var_11, var_53);
        // x[j] = x[j] ^ low & -(x[j] >> shift & 1)                                           <L 10>
        var_55 = wp::extract(var_0, var_54);
        var_56 = wp::extract(var_0, var_54);
        var_57 = wp::rshift(var_56, var_6);
        var_59 = wp::bit_and(var_57, var_58);
        var_60 = wp::neg(var_59);
        var_61 = wp::bit_and(var_10, var_60);
        var_62 = wp::bit_xor(var_55, var_61);
        wp::assign_inplace(var_0, var_54, var_62);
        // set_y = -(y[j] >> shift & 1)                                                       <L 11>
        var_63 = wp::extract(var_1, var_54);
        var_64 = wp::rshift(var_63, var_6);
        var_66 = wp::bit_and(var_64, var_65);
        var_67 = wp::neg(var_66);
        // swapped = (x[j] ^ y[j]) & low & ~set_y                                             <L 12>
        var_68 = wp::extract(var_0, var_54);
        var_69 = wp::extract(var_1, var_54);
        var_70 = wp::bit_xor(var_68, var_69);
        var_71 = wp::bit_and(var_70, var_10);
        var_72 = wp::invert(var_67);
        var_73 = wp::bit_and(var_71, var_72);
        // x[j] = x[j] ^ (low & set_y | swapped)                                              <L 13>
        var_74 = wp::extract(var_0, var_54);
        var_75 = wp::bit_and(var_10, var_67);
        var_76 = wp::bit_or(var_75, var_73);
        var_77 = wp::bit_xor(var_74, var_76);
        wp::assign_inplace(var_0, var_54, var_77);
        // y[j] = y[j] ^ swapped                                                              <L 14>
        var_78 = wp::extract(var_1, var_54);
        var_79 = wp::bit_xor(var_78, var_73);
        wp::assign_inplace(var_1, var_54, var_79);
        // set_z = -(z[j] >> shift & 1)                                                       <L 15>
        var_80 = wp::extract(var_2, var_54);
        var_81 = wp::rshift(var_80, var_6);
        var_83 = wp::bit_and(var_81, var_82);
        var_84 = wp::neg(var_83);
        // exchanged = (x[j] ^ z[j]) & low & ~set_z                                           <L 16>
        var_85 = wp::extract(var_0, var_54);
        var_86 = wp::extract(var_2, var_54);
        var_87 = wp::bit_xor(var_85, var_86);
        var_88 = wp::bit_and(var_87, var_10);
        var_89 = wp::invert(var_84);
        var_90 = wp::bit_and(var_88, var_89);
        // x[j] = x[j] ^ (low & set_z | exchanged)                                            <L 17>
        var_91 = wp::extract(var_0, var_54);
        var_92 = wp::bit_and(var_10, var_84);
        var_93 = wp::bit_or(var_92, var_90);
        var_94 = wp::bit_xor(var_91, var_93);
        wp::assign_inplace(var_0, var_54, var_94);
        // z[j] = z[j] ^ exchanged                                                            <L 18>
        var_95 = wp::extract(var_2, var_54);
        var_96 = wp::bit_xor(var_95, var_90);
        wp::assign_inplace(var_2, var_54, var_96);
        // x[j] = x[j] ^ low & -(x[j] >> shift & 1)                                           <L 10>
        var_98 = wp::extract(var_0, var_97);
        var_99 = wp::extract(var_0, var_97);
        var_100 = wp::rshift(var_99, var_6);
        var_102 = wp::bit_and(var_100, var_101);
        var_103 = wp::neg(var_102);
        var_104 = wp::bit_and(var_10, var_103);
        var_105 = wp::bit_xor(var_98, var_104);
        wp::assign_inplace(var_0, var_97, var_105);
        // set_y = -(y[j] >> shift & 1)                                                       <L 11>
        var_106 = wp::extract(var_1, var_97);
        var_107 = wp::rshift(var_106, var_6);
        var_109 = wp::bit_and(var_107, var_108);
        var_110 = wp::neg(var_109);
        // swapped = (x[j] ^ y[j]) & low & ~set_y                                             <L 12>
        var_111 = wp::extract(var_0, var_97);
        var_112 = wp::extract(var_1, var_97);
        var_113 = wp::bit_xor(var_111, var_112);
        var_114 = wp::bit_and(var_113, var_10);
        var_115 = wp::invert(var_110);
        var_116 = wp::bit_and(var_114, var_115);
        // x[j] = x[j] ^ (low & set_y | swapped)                                              <L 13>
        var_117 = wp::extract(var_0, var_97);
        var_118 = wp::bit_and(var_10, var_110);
        var_119 = wp::bit_or(var_118, var_116);
        var_120 = wp::bit_xor(var_117, var_119);
        wp::assign_inplace(var_0, var_97, var_120);
        // y[j] = y[j] ^ swapped                                                              <L 14>
        var_121 = wp::extract(var_1, var_97);
        var_122 = wp::bit_xor(var_121, var_116);
        wp::assign_inplace(var_1, var_97, var_122);
        // set_z = -(z[j] >> shift & 1)                                                       <L 15>
        var_123 = wp::extract(var_2, var_97);
        var_124 = wp::rshift(var_123, var_6);
        var_126 = wp::bit_and(var_124, var_125);
        var_127 = wp::neg(var_126);
        // exchanged = (x[j] ^ z[j]) & low & ~set_z                                           <L 16>
        var_128 = wp::extract(var_0, var_97);
        var_129 = wp::extract(var_2, var_97);
        var_130 = wp::bit_xor(var_128, var_129);
        var_131 = wp::bit_and(var_130, var_10);
        var_132 = wp::invert(var_127);
        var_133 = wp::bit_and(var_131, var_132);
        // x[j] = x[j] ^ (low & set_z | exchanged)                                            <L 17>
        var_134 = wp::extract(var_0, var_97);
        var_135 = wp::bit_and(var_10, var_127);
        var_136 = wp::bit_or(var_135, var_133);
        var_137 = wp::bit_xor(var_134, var_136);
        wp::assign_inplace(var_0, var_97, var_137);
        // z[j] = z[j] ^ exchanged                                                            <L 18>
        var_138 = wp::extract(var_2, var_97);
        var_139 = wp::bit_xor(var_138, var_133);
        wp::assign_inplace(var_2, var_97, var_139);
        // x[j] = x[j] ^ low & -(x[j] >> shift & 1)                                           <L 10>
        var_141 = wp::extract(var_0, var_140);
        var_142 = wp::extract(var_0, var_140);
        var_143 = wp::rshift(var_142, var_6);
        var_145 = wp::bit_and(var_143, var_144);
        var_146 = wp::neg(var_145);
        var_147 = wp::bit_and(var_10, var_146);
        var_148 = wp::bit_xor(var_141, var_147);
        wp::assign_inplace(var_0, var_140, var_148);
        // set_y = -(y[j] >> shift & 1)                                                       <L 11>
        var_149 = wp::extract(var_1, var_140);
        var_150 = wp::rshift(var_149, var_6);
        var_152 = wp::bit_and(var_150, var_151);
        var_153 = wp::neg(var_152);
        // swapped = (x[j] ^ y[j]) & low & ~set_y                                             <L 12>
        var_154 = wp::extract(var_0, var_140);
        var_155 = wp::extract(var_1, var_140);
        var_156 = wp::bit_xor(var_154, var_155);
        var_157 = wp::bit_and(var_156, var_10);
        var_158 = wp::invert(var_153);
        var_159 = wp::bit_and(var_157, var_158);
        // x[j] = x[j] ^ (low & set_y | swapped)                                              <L 13>
        var_160 = wp::extract(var_0, var_140);
        var_161 = wp::bit_and(var_10, var_153);
        var_162 = wp::bit_or(var_161, var_159);
        var_163 = wp::bit_xor(var_160, var_162);
        wp::assign_inplace(var_0, var_140, var_163);
        // y[j] = y[j] ^ swapped                                                              <L 14>
        var_164 = wp::extract(var_1, var_140);
        var_165 = wp::bit_xor(var_164, var_159);
        wp::assign_inplace(var_1, var_140, var_165);
        // set_z = -(z[j] >> shift & 1)                                                       <L 15>
        var_166 = wp::extract(var_2, var_140);
        var_167 = wp::rshift(var_166, var_6);
        var_169 = wp::bit_and(var_167, var_168);
        var_170 = wp::neg(var_169);
        // exchanged = (x[j] ^ z[j]) & low & ~set_z                                           <L 16>
        var_171 = wp::extract(var_0, var_140);
        var_172 = wp::extract(var_2, var_140);
        var_173 = wp::bit_xor(var_171, var_172);
        var_174 = wp::bit_and(var_173, var_10);
        var_175 = wp::invert(var_170);
        var_176 = wp::bit_and(var_174, var_175);
        // x[j] = x[j] ^ (low & set_z | exchanged)                                            <L 17>
        var_177 = wp::extract(var_0, var_140);
        var_178 = wp::bit_and(var_10, var_170);
        var_179 = wp::bit_or(var_178, var_176);
        var_180 = wp::bit_xor(var_177, var_179);
        wp::assign_inplace(var_0, var_140, var_180);
        // z[j] = z[j] ^ exchanged                                                            <L 18>
        var_181 = wp::extract(var_2, var_140);
        var_182 = wp::bit_xor(var_181, var_176);
        wp::assign_inplace(var_2, var_140, var_182);
        // x[j] = x[j] ^ low & -(x[j] >> shift & 1)                                           <L 10>
        var_184 = wp::extract(var_0, var_183);
        var_185 = wp::extract(var_0, var_183);
        var_186 = wp::rshift(var_185, var_6);
        var_188 = wp::bit_and(var_186, var_187);
        var_189 = wp::neg(var_188);
        var_190 = wp::bit_and(var_10, var_189);
        var_191 = wp::bit_xor(var_184, var_190);
        wp::assign_inplace(var_0, var_183, var_191);
        // set_y = -(y[j] >> shift & 1)                                                       <L 11>
        var_192 = wp::extract(var_1, var_183);
        var_193 = wp::rshift(var_192, var_6);
        var_195 = wp::bit_and(var_193, var_194);
        var_196 = wp::neg(var_195);
        // swapped = (x[j] ^ y[j]) & low & ~set_y                                             <L 12>
        var_197 = wp::extract(var_0, var_183);
        var_198 = wp::extract(var_1, var_183);
        var_199 = wp::bit_xor(var_197, var_198);
        var_200 = wp::bit_and(var_199, var_10);
        var_201 = wp::invert(var_196);
        var_202 = wp::bit_and(var_200, var_201);
        // x[j] = x[j] ^ (low & set_y | swapped)                                              <L 13>
        var_203 = wp::extract(var_0, var_183);
        var_204 = wp::bit_and(var_10, var_196);
        var_205 = wp::bit_or(var_204, var_202);
        var_206 = wp::bit_xor(var_203, var_205);
        wp::assign_inplace(var_0, var_183, var_206);
        // y[j] = y[j] ^ swapped                                                              <L 14>
        var_207 = wp::extract(var_1, var_183);
        var_208 = wp::bit_xor(var_207, var_202);
        wp::assign_inplace(var_1, var_183, var_208);
        // set_z = -(z[j] >> shift & 1)                                                       <L 15>
        var_209 = wp::extract(var_2, var_183);
        var_210 = wp::rshift(var_209, var_6);
        var_212 = wp::bit_and(var_210, var_211);
        var_213 = wp::neg(var_212);
        // exchanged = (x[j] ^ z[j]) & low & ~set_z                                           <L 16>
        var_214 = wp::extract(var_0, var_183);
        var_215 = wp::extract(var_2, var_183);
        var_216 = wp::bit_xor(var_214, var_215);
        var_217 = wp::bit_and(var_216, var_10);
        var_218 = wp::invert(var_213);
        var_219 = wp::bit_and(var_217, var_218);
        // x[j] = x[j] ^ (low & set_z | exchanged)                                            <L 17>
        var_220 = wp::extract(var_0, var_183);
        var_221 = wp::bit_and(var_10, var_213);
        var_222 = wp::bit_or(var_221, var_219);
        var_223 = wp::bit_xor(var_220, var_222);
        wp::assign_inplace(var_0, var_183, var_223);
        // z[j] = z[j] ^ exchanged                                                            <L 18>
        var_224 = wp::extract(var_2, var_183);
        var_225 = wp::bit_xor(var_224, var_219);
        wp::assign_inplace(var_2, var_183, var_225);
        // x[j] = x[j] ^ low & -(x[j] >> shift & 1)                                           <L 10>
        var_227 = wp::extract(var_0, var_226);
        var_228 = wp::extract(var_0, var_226);
        var_229 = wp::rshift(var_228, var_6);
        var_231 = wp::bit_and(var_229, var_230);
        var_232 = wp::neg(var_231);
        var_233 = wp::bit_and(var_10, var_232);
        var_234 = wp::bit_xor(var_227, var_233);
        wp::assign_inplace(var_0, var_226, var_234);
        // set_y = -(y[j] >> shift & 1)                                                       <L 11>
        var_235 = wp::extract(var_1, var_226);
        var_236 = wp::rshift(var_235, var_6);
        var_238 = wp::bit_and(var_236, var_237);
        var_239 = wp::neg(var_238);
        // swapped = (x[j] ^ y[j]) & low & ~set_y                                             <L 12>
        var_240 = wp::extract(var_0, var_226);
        var_241 = wp::extract(var_1, var_226);
        var_242 = wp::bit_xor(var_240, var_241);
        var_243 = wp::bit_and(var_242, var_10);
        var_244 = wp::invert(var_239);
        var_245 = wp::bit_and(var_243, var_244);
        // x[j] = x[j] ^ (low & set_y | swapped)                                              <L 13>
        var_246 = wp::extract(var_0, var_226);
        var_247 = wp::bit_and(var_10, var_239);
        var_248 = wp::bit_or(var_247, var_245);
        var_249 = wp::bit_xor(var_246, var_248);
        wp::assign_inplace(var_0, var_226, var_249);
        // y[j] = y[j] ^ swapped                                                              <L 14>
        var_250 = wp::extract(var_1, var_226);
        var_251 = wp::bit_xor(var_250, var_245);
        wp::assign_inplace(var_1, var_226, var_251);
        // set_z = -(z[j] >> shift & 1)                                                       <L 15>
        var_252 = wp::extract(var_2, var_226);
        var_253 = wp::rshift(var_252, var_6);
        var_255 = wp::bit_and(var_253, var_254);
        var_256 = wp::neg(var_255);
        // exchanged = (x[j] ^ z[j]) & low & ~set_z                                           <L 16>
        var_257 = wp::extract(var_0, var_226);
        var_258 = wp::extract(var_2, var_226);
        var_259 = wp::bit_xor(var_257, var_258);
        var_260 = wp::bit_and(var_259, var_10);
        var_261 = wp::invert(var_256);
        var_262 = wp::bit_and(var_260, var_261);
        // x[j] = x[j] ^ (low & set_z | exchanged)                                            <L 17>
        var_263 = wp::extract(var_0, var_226);
        var_264 = wp::bit_and(var_10, var_256);
        var_265 = wp::bit_or(var_264, var_262);
        var_266 = wp::bit_xor(var_263, var_265);
        wp::assign_inplace(var_0, var_226, var_266);
        // z[j] = z[j] ^ exchanged                                                            <L 18>
        var_267 = wp::extract(var_2, var_226);
        var_268 = wp::bit_xor(var_267, var_262);
        wp::assign_inplace(var_2, var_226, var_268);
        // x[j] = x[j] ^ low & -(x[j] >> shift & 1)                                           <L 10>
        var_270 = wp::extract(var_0, var_269);
        var_271 = wp::extract(var_0, var_269);
        var_272 = wp::rshift(var_271, var_6);
        var_274 = wp::bit_and(var_272, var_273);
        var_275 = wp::neg(var_274);
        var_276 = wp::bit_and(var_10, var_275);
        var_277 = wp::bit_xor(var_270, var_276);
        wp::assign_inplace(var_0, var_269, var_277);
        // set_y = -(y[j] >> shift & 1)                                                       <L 11>
        var_278 = wp::extract(var_1, var_269);
        var_279 = wp::rshift(var_278, var_6);
        var_281 = wp::bit_and(var_279, var_280);
        var_282 = wp::neg(var_281);
        // swapped = (x[j] ^ y[j]) & low & ~set_y                                             <L 12>
        var_283 = wp::extract(var_0, var_269);
        var_284 = wp::extract(var_1, var_269);
        var_285 = wp::bit_xor(var_283, var_284);
        var_286 = wp::bit_and(var_285, var_10);
        var_287 = wp::invert(var_282);
        var_288 = wp::bit_and(var_286, var_287);
        // x[j] = x[j] ^ (low & set_y | swapped)                                              <L 13>
        var_289 = wp::extract(var_0, var_269);
        var_290 = wp::bit_and(var_10, var_282);
        var_291 = wp::bit_or(var_290, var_288);
        var_292 = wp::bit_xor(var_289, var_291);
        wp::assign_inplace(var_0, var_269, var_292);
        // y[j] = y[j] ^ swapped                                                              <L 14>
        var_293 = wp::extract(var_1, var_269);
        var_294 = wp::bit_xor(var_293, var_288);
        wp::assign_inplace(var_1, var_269, var_294);
        // set_z = -(z[j] >> shift & 1)                                                       <L 15>
        var_295 = wp::extract(var_2, var_269);
        var_296 = wp::rshift(var_295, var_6);
        var_298 = wp::bit_and(var_296, var_297);
        var_299 = wp::neg(var_298);
        // exchanged = (x[j] ^ z[j]) & low & ~set_z                                           <L 16>
        var_300 = wp::extract(var_0, var_269);
        var_301 = wp::extract(var_2, var_269);
        var_302 = wp::bit_xor(var_300, var_301);
        var_303 = wp::bit_and(var_302, var_10);
        var_304 = wp::invert(var_299);
        var_305 = wp::bit_and(var_303, var_304);
        // x[j] = x[j] ^ (low & set_z | exchanged)                                            <L 17>
        var_306 = wp::extract(var_0, var_269);
        var_307 = wp::bit_and(var_10, var_299);
        var_308 = wp::bit_or(var_307, var_305);
        var_309 = wp::bit_xor(var_306, var_308);
        wp::assign_inplace(var_0, var_269, var_309);
        // z[j] = z[j] ^ exchanged                                                            <L 18>
        var_310 = wp::extract(var_2, var_269);
        var_311 = wp::bit_xor(var_310, var_305);
        wp::assign_inplace(var_2, var_269, var_311);
        // x[j] = x[j] ^ low & -(x[j] >> shift & 1)                                           <L 10>
        var_313 = wp::extract(var_0, var_312);
        var_314 = wp::extract(var_0, var_312);
        var_315 = wp::rshift(var_314, var_6);
        var_317 = wp::bit_and(var_315, var_316);
        var_318 = wp::neg(var_317);
        var_319 = wp::bit_and(var_10, var_318);
        var_320 = wp::bit_xor(var_313, var_319);
        wp::assign_inplace(var_0, var_312, var_320);
        // set_y = -(y[j] >> shift & 1)                                                       <L 11>
        var_321 = wp::extract(var_1, var_312);
        var_322 = wp::rshift(var_321, var_6);
        var_324 = wp::bit_and(var_322, var_323);
        var_325 = wp::neg(var_324);
        // swapped = (x[j] ^ y[j]) & low & ~set_y                                             <L 12>
        var_326 = wp::extract(var_0, var_312);
        var_327 = wp::extract(var_1, var_312);
        var_328 = wp::bit_xor(var_326, var_327);
        var_329 = wp::bit_and(var_328, var_10);
        var_330 = wp::invert(var_325);
        var_331 = wp::bit_and(var_329, var_330);
        // x[j] = x[j] ^ (low & set_y | swapped)                                              <L 13>
        var_332 = wp::extract(var_0, var_312);
        var_333 = wp::bit_and(var_10, var_325);
        var_334 = wp::bit_or(var_333, var_331);
        var_335 = wp::bit_xor(var_332, var_334);
        wp::assign_inplace(var_0, var_312, var_335);
        // y[j] = y[j] ^ swapped                                                              <L 14>
        var_336 = wp::extract(var_1, var_312);
        var_337 = wp::bit_xor(var_336, var_331);
        wp::assign_inplace(var_1, var_312, var_337);
        // set_z = -(z[j] >> shift & 1)                                                       <L 15>
        var_338 = wp::extract(var_2, var_312);
        var_339 = wp::rshift(var_338, var_6);
        var_341 = wp::bit_and(var_339, var_340);
        var_342 = wp::neg(var_341);
        // exchanged = (x[j] ^ z[j]) & low & ~set_z                                           <L 16>
        var_343 = wp::extract(var_0, var_312);
        var_344 = wp::extract(var_2, var_312);
        var_345 = wp::bit_xor(var_343, var_344);
        var_346 = wp::bit_and(var_345, var_10);
        var_347 = wp::invert(var_342);
        var_348 = wp::bit_and(var_346, var_347);
        // x[j] = x[j] ^ (low & set_z | exchanged)                                            <L 17>
        var_349 = wp::extract(var_0, var_312);
        var_350 = wp::bit_and(var_10, var_342);
        var_351 = wp::bit_or(var_350, var_348);
        var_352 = wp::bit_xor(var_349, var_351);
        wp::assign_inplace(var_0, var_312, var_352);
        // z[j] = z[j] ^ exchanged                                                            <L 18>
        var_353 = wp::extract(var_2, var_312);
        var_354 = wp::bit_xor(var_353, var_348);
        wp::assign_inplace(var_2, var_312, var_354);
        goto start_for_0;
    end_for_0:;
    // codes = lane_codes(int64(0))                                                           <L 19>
    var_355 = 0ll;
    var_356 = wp::vec_t<8, wp::int64>(var_355);
    // for j in range(LANES):                                                                 <L 20>
    // y[j] = y[j] ^ x[j]                                                                     <L 21>
    var_358 = wp::extract(var_1, var_357);
    var_359 = wp::extract(var_0, var_357);
    var_360 = wp::bit_xor(var_358, var_359);
    wp::assign_inplace(var_1, var_357, var_360);
    // z[j] = z[j] ^ y[j]                                                                     <L 22>
    var_361 = wp::extract(var_2, var_357);
    var_362 = wp::extract(var_1, var_357);
    var_363 = wp::bit_xor(var_361, var_362);
    wp::assign_inplace(var_2, var_357, var_363);
    // flip = z[j] ^ z[j] >> 1                                                                <L 23>
    var_364 = wp::extract(var_2, var_357);
    var_365 = wp::extract(var_2, var_357);
    var_367 = wp::rshift(var_365, var_366);
    var_368 = wp::bit_xor(var_364, var_367);
    // flip = flip ^ flip >> 2                                                                <L 24>
    var_370 = wp::rshift(var_368, var_369);
    var_371 = wp::bit_xor(var_368, var_370);
    // flip = flip ^ flip >> 4                                                                <L 25>
    var_373 = wp::rshift(var_371, var_372);
    var_374 = wp::bit_xor(var_371, var_373);
    // flip = (flip ^ flip >> 8) >> 1                                                         <L 26>
    var_376 = wp::rshift(var_374, var_375);
    var_377 = wp::bit_xor(var_374, var_376);
    var_379 = wp::rshift(var_377, var_378);
    // x[j] = x[j] ^ flip                                                                     <L 27>
    var_380 = wp::extract(var_0, var_357);
    var_381 = wp::bit_xor(var_380, var_379);
    wp::assign_inplace(var_0, var_357, var_381);
    // y[j] = y[j] ^ flip                                                                     <L 28>
    var_382 = wp::extract(var_1, var_357);
    var_383 = wp::bit_xor(var_382, var_379);
    wp::assign_inplace(var_1, var_357, var_383);
    // z[j] = z[j] ^ flip                                                                     <L 29>
    var_384 = wp::extract(var_2, var_357);
    var_385 = wp::bit_xor(var_384, var_379);
    wp::assign_inplace(var_2, var_357, var_385);
    // codes[j] = spread_bits(x[j]) << int64(2) | spread_bits(y[j]) << int64(1) | spread_bits(z[j])       <L 30>
    var_386 = wp::extract(var_0, var_357);
    var_387 = spread_bits_0(var_386);
    var_388 = 2ll;
    var_389 = wp::lshift(var_387, var_388);
    var_390 = wp::extract(var_1, var_357);
    var_391 = spread_bits_0(var_390);
    var_392 = 1ll;
    var_393 = wp::lshift(var_391, var_392);
    var_394 = wp::bit_or(var_389, var_393);
    var_395 = wp::extract(var_2, var_357);
    var_396 = spread_bits_0(var_395);
    var_397 = wp::bit_or(var_394, var_396);
    wp::assign_inplace(var_356, var_357, var_397);
    // y[j] = y[j] ^ x[j]                                                                     <L 21>
    var_399 = wp::extract(var_1, var_398);
    var_400 = wp::extract(var_0, var_398);
    var_401 = wp::bit_xor(var_399, var_400);
    wp::assign_inplace(var_1, var_398, var_401);
    // z[j] = z[j] ^ y[j]                                                                     <L 22>
    var_402 = wp::extract(var_2, var_398);
    var_403 = wp::extract(var_1, var_398);
    var_404 = wp::bit_xor(var_402, var_403);
    wp::assign_inplace(var_2, var_398, var_404);
    // flip = z[j] ^ z[j] >> 1                                                                <L 23>
    var_405 = wp::extract(var_2, var_398);
    var_406 = wp::extract(var_2, var_398);
    var_408 = wp::rshift(var_406, var_407);
    var_409 = wp::bit_xor(var_405, var_408);
    // flip = flip ^ flip >> 2                                                                <L 24>
    var_411 = wp::rshift(var_409, var_410);
    var_412 = wp::bit_xor(var_409, var_411);
    // flip = flip ^ flip >> 4                                                                <L 25>
    var_414 = wp::rshift(var_412, var_413);
    var_415 = wp::bit_xor(var_412, var_414);
    // flip = (flip ^ flip >> 8) >> 1                                                         <L 26>
    var_417 = wp::rshift(var_415, var_416);
    var_418 = wp::bit_xor(var_415, var_417);
    var_420 = wp::rshift(var_418, var_419);
    // x[j] = x[j] ^ flip                                                                     <L 27>
    var_421 = wp::extract(var_0, var_398);
    var_422 = wp::bit_xor(var_421, var_420);
    wp::assign_inplace(var_0, var_398, var_422);
    // y[j] = y[j] ^ flip                                                                     <L 28>
    var_423 = wp::extract(var_1, var_398);
    var_424 = wp::bit_xor(var_423, var_420);
    wp::assign_inplace(var_1, var_398, var_424);
    // z[j] = z[j] ^ flip                                                                     <L 29>
    var_425 = wp::extract(var_2, var_398);
    var_426 = wp::bit_xor(var_425, var_420);
    wp::assign_inplace(var_2, var_398, var_426);
    // codes[j] = spread_bits(x[j]) << int64(2) | spread_bits(y[j]) << int64(1) | spread_bits(z[j])       <L 30>
    var_427 = wp::extract(var_0, var_398);
    var_428 = spread_bits_0(var_427);
    var_429 = 2ll;
    var_430 = wp::lshift(var_428, var_429);
    var_431 = wp::extract(var_1, var_398);
    var_432 = spread_bits_0(var_431);
    var_433 = 1ll;
    var_434 = wp::lshift(var_432, var_433);
    var_435 = wp::bit_or(var_430, var_434);
    var_436 = wp::extract(var_2, var_398);
    var_437 = spread_bits_0(var_436);
    var_438 = wp::bit_or(var_435, var_437);
    wp::assign_inplace(var_356, var_398, var_438);
    // y[j] = y[j] ^ x[j]                                                                     <L 21>
    var_440 = wp::extract(var_1, var_439);
    var_441 = wp::extract(var_0, var_439);
    var_442 = wp::bit_xor(var_440, var_441);
    wp::assign_inplace(var_1, var_439, var_442);
    // z[j] = z[j] ^ y[j]                                                                     <L 22>
    var_443 = wp::extract(var_2, var_439);
    var_444 = wp::extract(var_1, var_439);
    var_445 = wp::bit_xor(var_443, var_444);
    wp::assign_inplace(var_2, var_439, var_445);
    // flip = z[j] ^ z[j] >> 1                                                                <L 23>
    var_446 = wp::extract(var_2, var_439);
    var_447 = wp::extract(var_2, var_439);
    var_449 = wp::rshift(var_447, var_448);
    var_450 = wp::bit_xor(var_446, var_449);
    // flip = flip ^ flip >> 2                                                                <L 24>
    var_452 = wp::rshift(var_450, var_451);
    var_453 = wp::bit_xor(var_450, var_452);
    // flip = flip ^ flip >> 4                                                                <L 25>
    var_455 = wp::rshift(var_453, var_454);
    var_456 = wp::bit_xor(var_453, var_455);
    // flip = (flip ^ flip >> 8) >> 1                                                         <L 26>
    var_458 = wp::rshift(var_456, var_457);
    var_459 = wp::bit_xor(var_456, var_458);
    var_461 = wp::rshift(var_459, var_460);
    // x[j] = x[j] ^ flip                                                                     <L 27>
    var_462 = wp::extract(var_0, var_439);
    var_463 = wp::bit_xor(var_462, var_461);
    wp::assign_inplace(var_0, var_439, var_463);
    // y[j] = y[j] ^ flip                                                                     <L 28>
    var_464 = wp::extract(var_1, var_439);
    var_465 = wp::bit_xor(var_464, var_461);
    wp::assign_inplace(var_1, var_439, var_465);
    // z[j] = z[j] ^ flip                                                                     <L 29>
    var_466 = wp::extract(var_2, var_439);
    var_467 = wp::bit_xor(var_466, var_461);
    wp::assign_inplace(var_2, var_439, var_467);
    // codes[j] = spread_bits(x[j]) << int64(2) | spread_bits(y[j]) << int64(1) | spread_bits(z[j])       <L 30>
    var_468 = wp::extract(var_0, var_439);
    var_469 = spread_bits_0(var_468);
    var_470 = 2ll;
    var_471 = wp::lshift(var_469, var_470);
    var_472 = wp::extract(var_1, var_439);
    var_473 = spread_bits_0(var_472);
    var_474 = 1ll;
    var_475 = wp::lshift(var_473, var_474);
    var_476 = wp::bit_or(var_471, var_475);
    var_477 = wp::extract(var_2, var_439);
    var_478 = spread_bits_0(var_477);
    var_479 = wp::bit_or(var_476, var_478);
    wp::assign_inplace(var_356, var_439, var_479);
    // y[j] = y[j] ^ x[j]                                                                     <L 21>
    var_481 = wp::extract(var_1, var_480);
    var_482 = wp::extract(var_0, var_480);
    var_483 = wp::bit_xor(var_481, var_482);
    wp::assign_inplace(var_1, var_480, var_483);
    // z[j] = z[j] ^ y[j]                                                                     <L 22>
    var_484 = wp::extract(var_2, var_480);
    var_485 = wp::extract(var_1, var_480);
    var_486 = wp::bit_xor(var_484, var_485);
    wp::assign_inplace(var_2, var_480, var_486);
    // flip = z[j] ^ z[j] >> 1                                                                <L 23>
    var_487 = wp::extract(var_2, var_480);
    var_488 = wp::extract(var_2, var_480);
    var_490 = wp::rshift(var_488, var_489);
    var_491 = wp::bit_xor(var_487, var_490);
    // flip = flip ^ flip >> 2                                                                <L 24>
    var_493 = wp::rshift(var_491, var_492);
    var_494 = wp::bit_xor(var_491, var_493);
    // flip = flip ^ flip >> 4                                                                <L 25>
    var_496 = wp::rshift(var_494, var_495);
    var_497 = wp::bit_xor(var_494, var_496);
    // flip = (flip ^ flip >> 8) >> 1                                                         <L 26>
    var_499 = wp::rshift(var_497, var_498);
    var_500 = wp::bit_xor(var_497, var_499);
    var_502 = wp::rshift(var_500, var_501);
    // x[j] = x[j] ^ flip                                                                     <L 27>
    var_503 = wp::extract(var_0, var_480);
    var_504 = wp::bit_xor(var_503, var_502);
    wp::assign_inplace(var_0, var_480, var_504);
    // y[j] = y[j] ^ flip                                                                     <L 28>
    var_505 = wp::extract(var_1, var_480);
    var_506 = wp::bit_xor(var_505, var_502);
    wp::assign_inplace(var_1, var_480, var_506);
    // z[j] = z[j] ^ flip                                                                     <L 29>
    var_507 = wp::extract(var_2, var_480);
    var_508 = wp::bit_xor(var_507, var_502);
    wp::assign_inplace(var_2, var_480, var_508);
    // codes[j] = spread_bits(x[j]) << int64(2) | spread_bits(y[j]) << int64(1) | spread_bits(z[j])       <L 30>
    var_509 = wp::extract(var_0, var_480);
    var_510 = spread_bits_0(var_509);
    var_511 = 2ll;
    var_512 = wp::lshift(var_510, var_511);
    var_513 = wp::extract(var_1, var_480);
    var_514 = spread_bits_0(var_513);
    var_515 = 1ll;
    var_516 = wp::lshift(var_514, var_515);
    var_517 = wp::bit_or(var_512, var_516);
    var_518 = wp::extract(var_2, var_480);
    var_519 = spread_bits_0(var_518);
    var_520 = wp::bit_or(var_517, var_519);
    wp::assign_inplace(var_356, var_480, var_520);
    // y[j] = y[j] ^ x[j]                                                                     <L 21>
    var_522 = wp::extract(var_1, var_521);
    var_523 = wp::extract(var_0, var_521);
    var_524 = wp::bit_xor(var_522, var_523);
    wp::assign_inplace(var_1, var_521, var_524);
    // z[j] = z[j] ^ y[j]                                                                     <L 22>
    var_525 = wp::extract(var_2, var_521);
    var_526 = wp::extract(var_1, var_521);
    var_527 = wp::bit_xor(var_525, var_526);
    wp::assign_inplace(var_2, var_521, var_527);
    // flip = z[j] ^ z[j] >> 1                                                                <L 23>
    var_528 = wp::extract(var_2, var_521);
    var_529 = wp::extract(var_2, var_521);
    var_531 = wp::rshift(var_529, var_530);
    var_532 = wp::bit_xor(var_528, var_531);
    // flip = flip ^ flip >> 2                                                                <L 24>
    var_534 = wp::rshift(var_532, var_533);
    var_535 = wp::bit_xor(var_532, var_534);
    // flip = flip ^ flip >> 4                                                                <L 25>
    var_537 = wp::rshift(var_535, var_536);
    var_538 = wp::bit_xor(var_535, var_537);
    // flip = (flip ^ flip >> 8) >> 1                                                         <L 26>
    var_540 = wp::rshift(var_538, var_539);
    var_541 = wp::bit_xor(var_538, var_540);
    var_543 = wp::rshift(var_541, var_542);
    // x[j] = x[j] ^ flip                                                                     <L 27>
    var_544 = wp::extract(var_0, var_521);
    var_545 = wp::bit_xor(var_544, var_543);
    wp::assign_inplace(var_0, var_521, var_545);
    // y[j] = y[j] ^ flip                                                                     <L 28>
    var_546 = wp::extract(var_1, var_521);
    var_547 = wp::bit_xor(var_546, var_543);
    wp::assign_inplace(var_1, var_521, var_547);
    // z[j] = z[j] ^ flip                                                                     <L 29>
    var_548 = wp::extract(var_2, var_521);
    var_549 = wp::bit_xor(var_548, var_543);
    wp::assign_inplace(var_2, var_521, var_549);
    // codes[j] = spread_bits(x[j]) << int64(2) | spread_bits(y[j]) << int64(1) | spread_bits(z[j])       <L 30>
    var_550 = wp::extract(var_0, var_521);
    var_551 = spread_bits_0(var_550);
    var_552 = 2ll;
    var_553 = wp::lshift(var_551, var_552);
    var_554 = wp::extract(var_1, var_521);
    var_555 = spread_bits_0(var_554);
    var_556 = 1ll;
    var_557 = wp::lshift(var_555, var_556);
    var_558 = wp::bit_or(var_553, var_557);
    var_559 = wp::extract(var_2, var_521);
    var_560 = spread_bits_0(var_559);
    var_561 = wp::bit_or(var_558, var_560);
    wp::assign_inplace(var_356, var_521, var_561);
    // y[j] = y[j] ^ x[j]                                                                     <L 21>
    var_563 = wp::extract(var_1, var_562);
    var_564 = wp::extract(var_0, var_562);
    var_565 = wp::bit_xor(var_563, var_564);
    wp::assign_inplace(var_1, var_562, var_565);
    // z[j] = z[j] ^ y[j]                                                                     <L 22>
    var_566 = wp::extract(var_2, var_562);
    var_567 = wp::extract(var_1, var_562);
    var_568 = wp::bit_xor(var_566, var_567);
    wp::assign_inplace(var_2, var_562, var_568);
    // flip = z[j] ^ z[j] >> 1                                                                <L 23>
    var_569 = wp::extract(var_2, var_562);
    var_570 = wp::extract(var_2, var_562);
    var_572 = wp::rshift(var_570, var_571);
    var_573 = wp::bit_xor(var_569, var_572);
    // flip = flip ^ flip >> 2                                                                <L 24>
    var_575 = wp::rshift(var_573, var_574);
    var_576 = wp::bit_xor(var_573, var_575);
    // flip = flip ^ flip >> 4                                                                <L 25>
    var_578 = wp::rshift(var_576, var_577);
    var_579 = wp::bit_xor(var_576, var_578);
    // flip = (flip ^ flip >> 8) >> 1                                                         <L 26>
    var_581 = wp::rshift(var_579, var_580);
    var_582 = wp::bit_xor(var_579, var_581);
    var_584 = wp::rshift(var_582, var_583);
    // x[j] = x[j] ^ flip                                                                     <L 27>
    var_585 = wp::extract(var_0, var_562);
    var_586 = wp::bit_xor(var_585, var_584);
    wp::assign_inplace(var_0, var_562, var_586);
    // y[j] = y[j] ^ flip                                                                     <L 28>
    var_587 = wp::extract(var_1, var_562);
    var_588 = wp::bit_xor(var_587, var_584);
    wp::assign_inplace(var_1, var_562, var_588);
    // z[j] = z[j] ^ flip                                                                     <L 29>
    var_589 = wp::extract(var_2, var_562);
    var_590 = wp::bit_xor(var_589, var_584);
    wp::assign_inplace(var_2, var_562, var_590);
    // codes[j] = spread_bits(x[j]) << int64(2) | spread_bits(y[j]) << int64(1) | spread_bits(z[j])       <L 30>
    var_591 = wp::extract(var_0, var_562);
    var_592 = spread_bits_0(var_591);
    var_593 = 2ll;
    var_594 = wp::lshift(var_592, var_593);
    var_595 = wp::extract(var_1, var_562);
    var_596 = spread_bits_0(var_595);
    var_597 = 1ll;
    var_598 = wp::lshift(var_596, var_597);
    var_599 = wp::bit_or(var_594, var_598);
    var_600 = wp::extract(var_2, var_562);
    var_601 = spread_bits_0(var_600);
    var_602 = wp::bit_or(var_599, var_601);
    wp::assign_inplace(var_356, var_562, var_602);
    // y[j] = y[j] ^ x[j]                                                                     <L 21>
    var_604 = wp::extract(var_1, var_603);
    var_605 = wp::extract(var_0, var_603);
    var_606 = wp::bit_xor(var_604, var_605);
    wp::assign_inplace(var_1, var_603, var_606);
    // z[j] = z[j] ^ y[j]                                                                     <L 22>
    var_607 = wp::extract(var_2, var_603);
    var_608 = wp::extract(var_1, var_603);
    var_609 = wp::bit_xor(var_607, var_608);
    wp::assign_inplace(var_2, var_603, var_609);
    // flip = z[j] ^ z[j] >> 1                                                                <L 23>
    var_610 = wp::extract(var_2, var_603);
    var_611 = wp::extract(var_2, var_603);
    var_613 = wp::rshift(var_611, var_612);
    var_614 = wp::bit_xor(var_610, var_613);
    // flip = flip ^ flip >> 2                                                                <L 24>
    var_616 = wp::rshift(var_614, var_615);
    var_617 = wp::bit_xor(var_614, var_616);
    // flip = flip ^ flip >> 4                                                                <L 25>
    var_619 = wp::rshift(var_617, var_618);
    var_620 = wp::bit_xor(var_617, var_619);
    // flip = (flip ^ flip >> 8) >> 1                                                         <L 26>
    var_622 = wp::rshift(var_620, var_621);
    var_623 = wp::bit_xor(var_620, var_622);
    var_625 = wp::rshift(var_623, var_624);
    // x[j] = x[j] ^ flip                                                                     <L 27>
    var_626 = wp::extract(var_0, var_603);
    var_627 = wp::bit_xor(var_626, var_625);
    wp::assign_inplace(var_0, var_603, var_627);
    // y[j] = y[j] ^ flip                                                                     <L 28>
    var_628 = wp::extract(var_1, var_603);
    var_629 = wp::bit_xor(var_628, var_625);
    wp::assign_inplace(var_1, var_603, var_629);
    // z[j] = z[j] ^ flip                                                                     <L 29>
    var_630 = wp::extract(var_2, var_603);
    var_631 = wp::bit_xor(var_630, var_625);
    wp::assign_inplace(var_2, var_603, var_631);
    // codes[j] = spread_bits(x[j]) << int64(2) | spread_bits(y[j]) << int64(1) | spread_bits(z[j])       <L 30>
    var_632 = wp::extract(var_0, var_603);
    var_633 = spread_bits_0(var_632);
    var_634 = 2ll;
    var_635 = wp::lshift(var_633, var_634);
    var_636 = wp::extract(var_1, var_603);
    var_637 = spread_bits_0(var_636);
    var_638 = 1ll;
    var_639 = wp::lshift(var_637, var_638);
    var_640 = wp::bit_or(var_635, var_639);
    var_641 = wp::extract(var_2, var_603);
    var_642 = spread_bits_0(var_641);
    var_643 = wp::bit_or(var_640, var_642);
    wp::assign_inplace(var_356, var_603, var_643);
    // y[j] = y[j] ^ x[j]                                                                     <L 21>
    var_645 = wp::extract(var_1, var_644);
    var_646 = wp::extract(var_0, var_644);
    var_647 = wp::bit_xor(var_645, var_646);
    wp::assign_inplace(var_1, var_644, var_647);
    // z[j] = z[j] ^ y[j]                                                                     <L 22>
    var_648 = wp::extract(var_2, var_644);
    var_649 = wp::extract(var_1, var_644);
    var_650 = wp::bit_xor(var_648, var_649);
    wp::assign_inplace(var_2, var_644, var_650);
    // flip = z[j] ^ z[j] >> 1                                                                <L 23>
    var_651 = wp::extract(var_2, var_644);
    var_652 = wp::extract(var_2, var_644);
    var_654 = wp::rshift(var_652, var_653);
    var_655 = wp::bit_xor(var_651, var_654);
    // flip = flip ^ flip >> 2                                                                <L 24>
    var_657 = wp::rshift(var_655, var_656);
    var_658 = wp::bit_xor(var_655, var_657);
    // flip = flip ^ flip >> 4                                                                <L 25>
    var_660 = wp::rshift(var_658, var_659);
    var_661 = wp::bit_xor(var_658, var_660);
    // flip = (flip ^ flip >> 8) >> 1                                                         <L 26>
    var_663 = wp::rshift(var_661, var_662);
    var_664 = wp::bit_xor(var_661, var_663);
    var_666 = wp::rshift(var_664, var_665);
    // x[j] = x[j] ^ flip                                                                     <L 27>
    var_667 = wp::extract(var_0, var_644);
    var_668 = wp::bit_xor(var_667, var_666);
    wp::assign_inplace(var_0, var_644, var_668);
    // y[j] = y[j] ^ flip                                                                     <L 28>
    var_669 = wp::extract(var_1, var_644);
    var_670 = wp::bit_xor(var_669, var_666);
    wp::assign_inplace(var_1, var_644, var_670);
    // z[j] = z[j] ^ flip                                                                     <L 29>
    var_671 = wp::extract(var_2, var_644);
    var_672 = wp::bit_xor(var_671, var_666);
    wp::assign_inplace(var_2, var_644, var_672);
    // codes[j] = spread_bits(x[j]) << int64(2) | spread_bits(y[j]) << int64(1) | spread_bits(z[j])       <L 30>
    var_673 = wp::extract(var_0, var_644);
    var_674 = spread_bits_0(var_673);
    var_675 = 2ll;
    var_676 = wp::lshift(var_674, var_675);
    var_677 = wp::extract(var_1, var_644);
    var_678 = spread_bits_0(var_677);
    var_679 = 1ll;
    var_680 = wp::lshift(var_678, var_679);
    var_681 = wp::bit_or(var_676, var_680);
    var_682 = wp::extract(var_2, var_644);
    var_683 = spread_bits_0(var_682);
    var_684 = wp::bit_or(var_681, var_683);
    wp::assign_inplace(var_356, var_644, var_684);
    // return codes                                                                           <L 31>
    return var_356;
}


// <pointloom.kernels.arrays.sort.put_key>:1
static CUDA_CALLABLE void put_key_0(
    wp::int32 var_i,
    wp::int64 var_key,
    wp::array_t<wp::int64> var_into__keys,
    wp::array_t<wp::int32> var_into__positions)
{
    //---------
    // primal vars
    wp::shape_t* var_0;
    const wp::int32 var_1 = 0;
    wp::int32 var_2;
    wp::shape_t var_3;
    bool var_4;
    //---------
    // forward
    // def put_key(i, key, into__keys, into__positions):                                      <L 1>
    // into__keys[i] = key                                                                    <L 2>
    wp::array_store(var_into__keys, var_i, var_key);
    // if i < into__positions.shape[0]:                                                       <L 3>
    var_0 = &(var_into__positions.shape);
    var_3 = wp::load(var_0);
    var_2 = wp::extract(var_3, var_1);
    var_4 = (var_i < var_2);
    if (var_4) {
        // into__positions[i] = i                                                             <L 4>
        wp::array_store(var_into__positions, var_i, var_i);
    }
}


// <pointloom.kernels.search.hilbert_order.put_eight>:1
static CUDA_CALLABLE void put_eight_0(
    wp::int32 var_head,
    wp::int32 var_step,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::vec_t<3, wp::float32> var_low,
    wp::float32 var_scale,
    wp::int32 var_levels,
    wp::array_t<wp::int64> var_codes__keys,
    wp::array_t<wp::int32> var_codes__positions)
{
    //---------
    // primal vars
    wp::shape_t* var_0;
    const wp::int32 var_1 = 0;
    wp::int32 var_2;
    wp::shape_t var_3;
    const wp::int32 var_4 = 1;
    wp::int32 var_5;
    const wp::int32 var_6 = 0;
    wp::vec_t<8, wp::int32> var_7;
    const wp::int32 var_8 = 0;
    wp::vec_t<8, wp::int32> var_9;
    const wp::int32 var_10 = 0;
    wp::vec_t<8, wp::int32> var_11;
    const wp::int32 var_12 = 0;
    wp::int32 var_13;
    wp::int32 var_14;
    wp::int32 var_15;
    wp::vec_t<3, wp::float32>* var_16;
    wp::vec_t<3, wp::float32> var_17;
    wp::vec_t<3, wp::float32> var_18;
    const wp::int32 var_19 = 0;
    wp::float32 var_20;
    const wp::int32 var_21 = 0;
    wp::float32 var_22;
    wp::int32 var_23;
    const wp::int32 var_24 = 1;
    wp::float32 var_25;
    const wp::int32 var_26 = 1;
    wp::float32 var_27;
    wp::int32 var_28;
    const wp::int32 var_29 = 2;
    wp::float32 var_30;
    const wp::int32 var_31 = 2;
    wp::float32 var_32;
    wp::int32 var_33;
    const wp::int32 var_34 = 1;
    wp::int32 var_35;
    wp::int32 var_36;
    wp::int32 var_37;
    wp::vec_t<3, wp::float32>* var_38;
    wp::vec_t<3, wp::float32> var_39;
    wp::vec_t<3, wp::float32> var_40;
    const wp::int32 var_41 = 0;
    wp::float32 var_42;
    const wp::int32 var_43 = 0;
    wp::float32 var_44;
    wp::int32 var_45;
    const wp::int32 var_46 = 1;
    wp::float32 var_47;
    const wp::int32 var_48 = 1;
    wp::float32 var_49;
    wp::int32 var_50;
    const wp::int32 var_51 = 2;
    wp::float32 var_52;
    const wp::int32 var_53 = 2;
    wp::float32 var_54;
    wp::int32 var_55;
    const wp::int32 var_56 = 2;
    wp::int32 var_57;
    wp::int32 var_58;
    wp::int32 var_59;
    wp::vec_t<3, wp::float32>* var_60;
    wp::vec_t<3, wp::float32> var_61;
    wp::vec_t<3, wp::float32> var_62;
    const wp::int32 var_63 = 0;
    wp::float32 var_64;
    const wp::int32 var_65 = 0;
    wp::float32 var_66;
    wp::int32 var_67;
    const wp::int32 var_68 = 1;
    wp::float32 var_69;
    const wp::int32 var_70 = 1;
    wp::float32 var_71;
    wp::int32 var_72;
    const wp::int32 var_73 = 2;
    wp::float32 var_74;
    const wp::int32 var_75 = 2;
    wp::float32 var_76;
    wp::int32 var_77;
    const wp::int32 var_78 = 3;
    wp::int32 var_79;
    wp::int32 var_80;
    wp::int32 var_81;
    wp::vec_t<3, wp::float32>* var_82;
    wp::vec_t<3, wp::float32> var_83;
    wp::vec_t<3, wp::float32> var_84;
    const wp::int32 var_85 = 0;
    wp::float32 var_86;
    const wp::int32 var_87 = 0;
    wp::float32 var_88;
    wp::int32 var_89;
    const wp::int32 var_90 = 1;
    wp::float32 var_91;
    const wp::int32 var_92 = 1;
    wp::float32 var_93;
    wp::int32 var_94;
    const wp::int32 var_95 = 2;
    wp::float32 var_96;
    const wp::int32 var_97 = 2;
    wp::float32 var_98;
    wp::int32 var_99;
    const wp::int32 var_100 = 4;
    wp::int32 var_101;
    wp::int32 var_102;
    wp::int32 var_103;
    wp::vec_t<3, wp::float32>* var_104;
    wp::vec_t<3, wp::float32> var_105;
    wp::vec_t<3, wp::float32> var_106;
    const wp::int32 var_107 = 0;
    wp::float32 var_108;
    const wp::int32 var_109 = 0;
    wp::float32 var_110;
    wp::int32 var_111;
    const wp::int32 var_112 = 1;
    wp::float32 var_113;
    const wp::int32 var_114 = 1;
    wp::float32 var_115;
    wp::int32 var_116;
    const wp::int32 var_117 = 2;
    wp::float32 var_118;
    const wp::int32 var_119 = 2;
    wp::float32 var_120;
    wp::int32 var_121;
    const wp::int32 var_122 = 5;
    wp::int32 var_123;
    wp::int32 var_124;
    wp::int32 var_125;
    wp::vec_t<3, wp::float32>* var_126;
    wp::vec_t<3, wp::float32> var_127;
    wp::vec_t<3, wp::float32> var_128;
    const wp::int32 var_129 = 0;
    wp::float32 var_130;
    const wp::int32 var_131 = 0;
    wp::float32 var_132;
    wp::int32 var_133;
    const wp::int32 var_134 = 1;
    wp::float32 var_135;
    const wp::int32 var_136 = 1;
    wp::float32 var_137;
    wp::int32 var_138;
    const wp::int32 var_139 = 2;
    wp::float32 var_140;
    const wp::int32 var_141 = 2;
    wp::float32 var_142;
    wp::int32 var_143;
    const wp::int32 var_144 = 6;
    wp::int32 var_145;
    wp::int32 var_146;
    wp::int32 var_147;
    wp::vec_t<3, wp::float32>* var_148;
    wp::vec_t<3, wp::float32> var_149;
    wp::vec_t<3, wp::float32> var_150;
    const wp::int32 var_151 = 0;
    wp::float32 var_152;
    const wp::int32 var_153 = 0;
    wp::float32 var_154;
    wp::int32 var_155;
    const wp::int32 var_156 = 1;
    wp::float32 var_157;
    const wp::int32 var_158 = 1;
    wp::float32 var_159;
    wp::int32 var_160;
    const wp::int32 var_161 = 2;
    wp::float32 var_162;
    const wp::int32 var_163 = 2;
    wp::float32 var_164;
    wp::int32 var_165;
    const wp::int32 var_166 = 7;
    wp::int32 var_167;
    wp::int32 var_168;
    wp::int32 var_169;
    wp::vec_t<3, wp::float32>* var_170;
    wp::vec_t<3, wp::float32> var_171;
    wp::vec_t<3, wp::float32> var_172;
    const wp::int32 var_173 = 0;
    wp::float32 var_174;
    const wp::int32 var_175 = 0;
    wp::float32 var_176;
    wp::int32 var_177;
    const wp::int32 var_178 = 1;
    wp::float32 var_179;
    const wp::int32 var_180 = 1;
    wp::float32 var_181;
    wp::int32 var_182;
    const wp::int32 var_183 = 2;
    wp::float32 var_184;
    const wp::int32 var_185 = 2;
    wp::float32 var_186;
    wp::int32 var_187;
    wp::vec_t<8, wp::int64> var_188;
    const wp::int32 var_189 = 0;
    wp::int32 var_190;
    wp::int32 var_191;
    bool var_192;
    wp::vec_t<3, wp::float32>* var_193;
    wp::vec_t<3, wp::float32> var_194;
    wp::vec_t<3, wp::float32> var_195;
    wp::int64 var_196;
    const wp::int32 var_197 = 3;
    wp::int32 var_198;
    wp::int64 var_199;
    wp::int64 var_200;
    bool var_201;
    wp::int64 var_202;
    wp::int64 var_203;
    wp::vec_t<3, wp::float32> var_204;
    const wp::int32 var_205 = 1;
    wp::int32 var_206;
    wp::int32 var_207;
    bool var_208;
    wp::vec_t<3, wp::float32>* var_209;
    wp::vec_t<3, wp::float32> var_210;
    wp::vec_t<3, wp::float32> var_211;
    wp::int64 var_212;
    const wp::int32 var_213 = 3;
    wp::int32 var_214;
    wp::int64 var_215;
    wp::int64 var_216;
    bool var_217;
    wp::int64 var_218;
    wp::int64 var_219;
    wp::vec_t<3, wp::float32> var_220;
    wp::int64 var_221;
    const wp::int32 var_222 = 2;
    wp::int32 var_223;
    wp::int32 var_224;
    bool var_225;
    wp::vec_t<3, wp::float32>* var_226;
    wp::vec_t<3, wp::float32> var_227;
    wp::vec_t<3, wp::float32> var_228;
    wp::int64 var_229;
    const wp::int32 var_230 = 3;
    wp::int32 var_231;
    wp::int64 var_232;
    wp::int64 var_233;
    bool var_234;
    wp::int64 var_235;
    wp::int64 var_236;
    wp::vec_t<3, wp::float32> var_237;
    wp::int64 var_238;
    const wp::int32 var_239 = 3;
    wp::int32 var_240;
    wp::int32 var_241;
    bool var_242;
    wp::vec_t<3, wp::float32>* var_243;
    wp::vec_t<3, wp::float32> var_244;
    wp::vec_t<3, wp::float32> var_245;
    wp::int64 var_246;
    const wp::int32 var_247 = 3;
    wp::int32 var_248;
    wp::int64 var_249;
    wp::int64 var_250;
    bool var_251;
    wp::int64 var_252;
    wp::int64 var_253;
    wp::vec_t<3, wp::float32> var_254;
    wp::int64 var_255;
    const wp::int32 var_256 = 4;
    wp::int32 var_257;
    wp::int32 var_258;
    bool var_259;
    wp::vec_t<3, wp::float32>* var_260;
    wp::vec_t<3, wp::float32> var_261;
    wp::vec_t<3, wp::float32> var_262;
    wp::int64 var_263;
    const wp::int32 var_264 = 3;
    wp::int32 var_265;
    wp::int64 var_266;
    wp::int64 var_267;
    bool var_268;
    wp::int64 var_269;
    wp::int64 var_270;
    wp::vec_t<3, wp::float32> var_271;
    wp::int64 var_272;
    const wp::int32 var_273 = 5;
    wp::int32 var_274;
    wp::int32 var_275;
    bool var_276;
    wp::vec_t<3, wp::float32>* var_277;
    wp::vec_t<3, wp::float32> var_278;
    wp::vec_t<3, wp::float32> var_279;
    wp::int64 var_280;
    const wp::int32 var_281 = 3;
    wp::int32 var_282;
    wp::int64 var_283;
    wp::int64 var_284;
    bool var_285;
    wp::int64 var_286;
    wp::int64 var_287;
    wp::vec_t<3, wp::float32> var_288;
    wp::int64 var_289;
    const wp::int32 var_290 = 6;
    wp::int32 var_291;
    wp::int32 var_292;
    bool var_293;
    wp::vec_t<3, wp::float32>* var_294;
    wp::vec_t<3, wp::float32> var_295;
    wp::vec_t<3, wp::float32> var_296;
    wp::int64 var_297;
    const wp::int32 var_298 = 3;
    wp::int32 var_299;
    wp::int64 var_300;
    wp::int64 var_301;
    bool var_302;
    wp::int64 var_303;
    wp::int64 var_304;
    wp::vec_t<3, wp::float32> var_305;
    wp::int64 var_306;
    const wp::int32 var_307 = 7;
    wp::int32 var_308;
    wp::int32 var_309;
    bool var_310;
    wp::vec_t<3, wp::float32>* var_311;
    wp::vec_t<3, wp::float32> var_312;
    wp::vec_t<3, wp::float32> var_313;
    wp::int64 var_314;
    const wp::int32 var_315 = 3;
    wp::int32 var_316;
    wp::int64 var_317;
    wp::int64 var_318;
    bool var_319;
    wp::int64 var_320;
    wp::int64 var_321;
    wp::vec_t<3, wp::float32> var_322;
    wp::int64 var_323;
    //---------
    // forward
    // def put_eight(head, step, points, low, scale, levels, codes__keys, codes__positions):       <L 1>
    // last = points.shape[0] - 1                                                             <L 3>
    var_0 = &(var_points.shape);
    var_3 = wp::load(var_0);
    var_2 = wp::extract(var_3, var_1);
    var_5 = wp::sub(var_2, var_4);
    // x = lanes(0)                                                                           <L 4>
    var_7 = wp::vec_t<8, wp::int32>(var_6);
    // y = lanes(0)                                                                           <L 5>
    var_9 = wp::vec_t<8, wp::int32>(var_8);
    // z = lanes(0)                                                                           <L 6>
    var_11 = wp::vec_t<8, wp::int32>(var_10);
    // for j in range(LANES):                                                                 <L 7>
    // p = points[min(head + j * step, last)]                                                 <L 8>
    var_13 = wp::mul(var_12, var_step);
    var_14 = wp::add(var_head, var_13);
    var_15 = wp::min(var_14, var_5);
    var_16 = wp::address(var_points, var_15);
    var_18 = wp::load(var_16);
    var_17 = wp::copy(var_18);
    // x[j] = cell_on_axis(p[0], low[0], scale, levels)                                       <L 9>
    var_20 = wp::extract(var_17, var_19);
    var_22 = wp::extract(var_low, var_21);
    var_23 = cell_on_axis_0(var_20, var_22, var_scale, var_levels);
    wp::assign_inplace(var_7, var_12, var_23);
    // y[j] = cell_on_axis(p[1], low[1], scale, levels)                                       <L 10>
    var_25 = wp::extract(var_17, var_24);
    var_27 = wp::extract(var_low, var_26);
    var_28 = cell_on_axis_0(var_25, var_27, var_scale, var_levels);
    wp::assign_inplace(var_9, var_12, var_28);
    // z[j] = cell_on_axis(p[2], low[2], scale, levels)                                       <L 11>
    var_30 = wp::extract(var_17, var_29);
    var_32 = wp::extract(var_low, var_31);
    var_33 = cell_on_axis_0(var_30, var_32, var_scale, var_levels);
    wp::assign_inplace(var_11, var_12, var_33);
    // p = points[min(head + j * step, last)]                                                 <L 8>
    var_35 = wp::mul(var_34, var_step);
    var_36 = wp::add(var_head, var_35);
    var_37 = wp::min(var_36, var_5);
    var_38 = wp::address(var_points, var_37);
    var_40 = wp::load(var_38);
    var_39 = wp::copy(var_40);
    // x[j] = cell_on_axis(p[0], low[0], scale, levels)                                       <L 9>
    var_42 = wp::extract(var_39, var_41);
    var_44 = wp::extract(var_low, var_43);
    var_45 = cell_on_axis_0(var_42, var_44, var_scale, var_levels);
    wp::assign_inplace(var_7, var_34, var_45);
    // y[j] = cell_on_axis(p[1], low[1], scale, levels)                                       <L 10>
    var_47 = wp::extract(var_39, var_46);
    var_49 = wp::extract(var_low, var_48);
    var_50 = cell_on_axis_0(var_47, var_49, var_scale, var_levels);
    wp::assign_inplace(var_9, var_34, var_50);
    // z[j] = cell_on_axis(p[2], low[2], scale, levels)                                       <L 11>
    var_52 = wp::extract(var_39, var_51);
    var_54 = wp::extract(var_low, var_53);
    var_55 = cell_on_axis_0(var_52, var_54, var_scale, var_levels);
    wp::assign_inplace(var_11, var_34, var_55);
    // p = points[min(head + j * step, last)]                                                 <L 8>
    var_57 = wp::mul(var_56, var_step);
    var_58 = wp::add(var_head, var_57);
    var_59 = wp::min(var_58, var_5);
    var_60 = wp::address(var_points, var_59);
    var_62 = wp::load(var_60);
    var_61 = wp::copy(var_62);
    // x[j] = cell_on_axis(p[0], low[0], scale, levels)                                       <L 9>
    var_64 = wp::extract(var_61, var_63);
    var_66 = wp::extract(var_low, var_65);
    var_67 = cell_on_axis_0(var_64, var_66, var_scale, var_levels);
    wp::assign_inplace(var_7, var_56, var_67);
    // y[j] = cell_on_axis(p[1], low[1], scale, levels)                                       <L 10>
    var_69 = wp::extract(var_61, var_68);
    var_71 = wp::extract(var_low, var_70);
    var_72 = cell_on_axis_0(var_69, var_71, var_scale, var_levels);
    wp::assign_inplace(var_9, var_56, var_72);
    // z[j] = cell_on_axis(p[2], low[2], scale, levels)                                       <L 11>
    var_74 = wp::extract(var_61, var_73);
    var_76 = wp::extract(var_low, var_75);
    var_77 = cell_on_axis_0(var_74, var_76, var_scale, var_levels);
    wp::assign_inplace(var_11, var_56, var_77);
    // p = points[min(head + j * step, last)]                                                 <L 8>
    var_79 = wp::mul(var_78, var_step);
    var_80 = wp::add(var_head, var_79);
    var_81 = wp::min(var_80, var_5);
    var_82 = wp::address(var_points, var_81);
    var_84 = wp::load(var_82);
    var_83 = wp::copy(var_84);
    // x[j] = cell_on_axis(p[0], low[0], scale, levels)                                       <L 9>
    var_86 = wp::extract(var_83, var_85);
    var_88 = wp::extract(var_low, var_87);
    var_89 = cell_on_axis_0(var_86, var_88, var_scale, var_levels);
    wp::assign_inplace(var_7, var_78, var_89);
    // y[j] = cell_on_axis(p[1], low[1], scale, levels)                                       <L 10>
    var_91 = wp::extract(var_83, var_90);
    var_93 = wp::extract(var_low, var_92);
    var_94 = cell_on_axis_0(var_91, var_93, var_scale, var_levels);
    wp::assign_inplace(var_9, var_78, var_94);
    // z[j] = cell_on_axis(p[2], low[2], scale, levels)                                       <L 11>
    var_96 = wp::extract(var_83, var_95);
    var_98 = wp::extract(var_low, var_97);
    var_99 = cell_on_axis_0(var_96, var_98, var_scale, var_levels);
    wp::assign_inplace(var_11, var_78, var_99);
    // p = points[min(head + j * step, last)]                                                 <L 8>
    var_101 = wp::mul(var_100, var_step);
    var_102 = wp::add(var_head, var_101);
    var_103 = wp::min(var_102, var_5);
    var_104 = wp::address(var_points, var_103);
    var_106 = wp::load(var_104);
    var_105 = wp::copy(var_106);
    // x[j] = cell_on_axis(p[0], low[0], scale, levels)                                       <L 9>
    var_108 = wp::extract(var_105, var_107);
    var_110 = wp::extract(var_low, var_109);
    var_111 = cell_on_axis_0(var_108, var_110, var_scale, var_levels);
    wp::assign_inplace(var_7, var_100, var_111);
    // y[j] = cell_on_axis(p[1], low[1], scale, levels)                                       <L 10>
    var_113 = wp::extract(var_105, var_112);
    var_115 = wp::extract(var_low, var_114);
    var_116 = cell_on_axis_0(var_113, var_115, var_scale, var_levels);
    wp::assign_inplace(var_9, var_100, var_116);
    // z[j] = cell_on_axis(p[2], low[2], scale, levels)                                       <L 11>
    var_118 = wp::extract(var_105, var_117);
    var_120 = wp::extract(var_low, var_119);
    var_121 = cell_on_axis_0(var_118, var_120, var_scale, var_levels);
    wp::assign_inplace(var_11, var_100, var_121);
    // p = points[min(head + j * step, last)]                                                 <L 8>
    var_123 = wp::mul(var_122, var_step);
    var_124 = wp::add(var_head, var_123);
    var_125 = wp::min(var_124, var_5);
    var_126 = wp::address(var_points, var_125);
    var_128 = wp::load(var_126);
    var_127 = wp::copy(var_128);
    // x[j] = cell_on_axis(p[0], low[0], scale, levels)                                       <L 9>
    var_130 = wp::extract(var_127, var_129);
    var_132 = wp::extract(var_low, var_131);
    var_133 = cell_on_axis_0(var_130, var_132, var_scale, var_levels);
    wp::assign_inplace(var_7, var_122, var_133);
    // y[j] = cell_on_axis(p[1], low[1], scale, levels)                                       <L 10>
    var_135 = wp::extract(var_127, var_134);
    var_137 = wp::extract(var_low, var_136);
    var_138 = cell_on_axis_0(var_135, var_137, var_scale, var_levels);
    wp::assign_inplace(var_9, var_122, var_138);
    // z[j] = cell_on_axis(p[2], low[2], scale, levels)                                       <L 11>
    var_140 = wp::extract(var_127, var_139);
    var_142 = wp::extract(var_low, var_141);
    var_143 = cell_on_axis_0(var_140, var_142, var_scale, var_levels);
    wp::assign_inplace(var_11, var_122, var_143);
    // p = points[min(head + j * step, last)]                                                 <L 8>
    var_145 = wp::mul(var_144, var_step);
    var_146 = wp::add(var_head, var_145);
    var_147 = wp::min(var_146, var_5);
    var_148 = wp::address(var_points, var_147);
    var_150 = wp::load(var_148);
    var_149 = wp::copy(var_150);
    // x[j] = cell_on_axis(p[0], low[0], scale, levels)                                       <L 9>
    var_152 = wp::extract(var_149, var_151);
    var_154 = wp::extract(var_low, var_153);
    var_155 = cell_on_axis_0(var_152, var_154, var_scale, var_levels);
    wp::assign_inplace(var_7, var_144, var_155);
    // y[j] = cell_on_axis(p[1], low[1], scale, levels)                                       <L 10>
    var_157 = wp::extract(var_149, var_156);
    var_159 = wp::extract(var_low, var_158);
    var_160 = cell_on_axis_0(var_157, var_159, var_scale, var_levels);
    wp::assign_inplace(var_9, var_144, var_160);
    // z[j] = cell_on_axis(p[2], low[2], scale, levels)                                       <L 11>
    var_162 = wp::extract(var_149, var_161);
    var_164 = wp::extract(var_low, var_163);
    var_165 = cell_on_axis_0(var_162, var_164, var_scale, var_levels);
    wp::assign_inplace(var_11, var_144, var_165);
    // p = points[min(head + j * step, last)]                                                 <L 8>
    var_167 = wp::mul(var_166, var_step);
    var_168 = wp::add(var_head, var_167);
    var_169 = wp::min(var_168, var_5);
    var_170 = wp::address(var_points, var_169);
    var_172 = wp::load(var_170);
    var_171 = wp::copy(var_172);
    // x[j] = cell_on_axis(p[0], low[0], scale, levels)                                       <L 9>
    var_174 = wp::extract(var_171, var_173);
    var_176 = wp::extract(var_low, var_175);
    var_177 = cell_on_axis_0(var_174, var_176, var_scale, var_levels);
    wp::assign_inplace(var_7, var_166, var_177);
    // y[j] = cell_on_axis(p[1], low[1], scale, levels)                                       <L 10>
    var_179 = wp::extract(var_171, var_178);
    var_181 = wp::extract(var_low, var_180);
    var_182 = cell_on_axis_0(var_179, var_181, var_scale, var_levels);
    wp::assign_inplace(var_9, var_166, var_182);
    // z[j] = cell_on_axis(p[2], low[2], scale, levels)                                       <L 11>
    var_184 = wp::extract(var_171, var_183);
    var_186 = wp::extract(var_low, var_185);
    var_187 = cell_on_axis_0(var_184, var_186, var_scale, var_levels);
    wp::assign_inplace(var_11, var_166, var_187);
    // indices = hilbert_codes(x, y, z, levels)                                               <L 12>
    var_188 = hilbert_codes_0(var_7, var_9, var_11, var_levels);
    // for j in range(LANES):                                                                 <L 13>
    // position = head + j * step                                                             <L 14>
    var_190 = wp::mul(var_189, var_step);
    var_191 = wp::add(var_head, var_190);
    // if position <= last:                                                                   <L 15>
    var_192 = (var_191 <= var_5);
    if (var_192) {
        // p = points[position]                                                               <L 16>
        var_193 = wp::address(var_points, var_191);
        var_195 = wp::load(var_193);
        var_194 = wp::copy(var_195);
        // code = int64(1) << int64(3 * levels)                                               <L 17>
        var_196 = 1ll;
        var_198 = wp::mul(var_197, var_levels);
        var_199 = wp::int64(var_198);
        var_200 = wp::lshift(var_196, var_199);
        // if isfinite(p):                                                                    <L 18>
        var_201 = wp::isfinite(var_194);
        if (var_201) {
            // code = indices[j]                                                              <L 19>
            var_202 = wp::extract(var_188, var_189);
        }
        var_203 = wp::where(var_201, var_202, var_200);
        // put_key(position, code, codes__keys, codes__positions)                             <L 20>
        put_key_0(var_191, var_203, var_codes__keys, var_codes__positions);
    }
    var_204 = wp::where(var_192, var_194, var_171);
    // position = head + j * step                                                             <L 14>
    var_206 = wp::mul(var_205, var_step);
    var_207 = wp::add(var_head, var_206);
    // if position <= last:                                                                   <L 15>
    var_208 = (var_207 <= var_5);
    if (var_208) {
        // p = points[position]                                                               <L 16>
        var_209 = wp::address(var_points, var_207);
        var_211 = wp::load(var_209);
        var_210 = wp::copy(var_211);
        // code = int64(1) << int64(3 * levels)                                               <L 17>
        var_212 = 1ll;
        var_214 = wp::mul(var_213, var_levels);
        var_215 = wp::int64(var_214);
        var_216 = wp::lshift(var_212, var_215);
        // if isfinite(p):                                                                    <L 18>
        var_217 = wp::isfinite(var_210);
        if (var_217) {
            // code = indices[j]                                                              <L 19>
            var_218 = wp::extract(var_188, var_205);
        }
        var_219 = wp::where(var_217, var_218, var_216);
        // put_key(position, code, codes__keys, codes__positions)                             <L 20>
        put_key_0(var_207, var_219, var_codes__keys, var_codes__positions);
    }
    var_220 = wp::where(var_208, var_210, var_204);
    var_221 = wp::where(var_208, var_219, var_203);
    // position = head + j * step                                                             <L 14>
    var_223 = wp::mul(var_222, var_step);
    var_224 = wp::add(var_head, var_223);
    // if position <= last:                                                                   <L 15>
    var_225 = (var_224 <= var_5);
    if (var_225) {
        // p = points[position]                                                               <L 16>
        var_226 = wp::address(var_points, var_224);
        var_228 = wp::load(var_226);
        var_227 = wp::copy(var_228);
        // code = int64(1) << int64(3 * levels)                                               <L 17>
        var_229 = 1ll;
        var_231 = wp::mul(var_230, var_levels);
        var_232 = wp::int64(var_231);
        var_233 = wp::lshift(var_229, var_232);
        // if isfinite(p):                                                                    <L 18>
        var_234 = wp::isfinite(var_227);
        if (var_234) {
            // code = indices[j]                                                              <L 19>
            var_235 = wp::extract(var_188, var_222);
        }
        var_236 = wp::where(var_234, var_235, var_233);
        // put_key(position, code, codes__keys, codes__positions)                             <L 20>
        put_key_0(var_224, var_236, var_codes__keys, var_codes__positions);
    }
    var_237 = wp::where(var_225, var_227, var_220);
    var_238 = wp::where(var_225, var_236, var_221);
    // position = head + j * step                                                             <L 14>
    var_240 = wp::mul(var_239, var_step);
    var_241 = wp::add(var_head, var_240);
    // if position <= last:                                                                   <L 15>
    var_242 = (var_241 <= var_5);
    if (var_242) {
        // p = points[position]                                                               <L 16>
        var_243 = wp::address(var_points, var_241);
        var_245 = wp::load(var_243);
        var_244 = wp::copy(var_245);
        // code = int64(1) << int64(3 * levels)                                               <L 17>
        var_246 = 1ll;
        var_248 = wp::mul(var_247, var_levels);
        var_249 = wp::int64(var_248);
        var_250 = wp::lshift(var_246, var_249);
        // if isfinite(p):                                                                    <L 18>
        var_251 = wp::isfinite(var_244);
        if (var_251) {
            // code = indices[j]                                                              <L 19>
            var_252 = wp::extract(var_188, var_239);
        }
        var_253 = wp::where(var_251, var_252, var_250);
        // put_key(position, code, codes__keys, codes__positions)                             <L 20>
        put_key_0(var_241, var_253, var_codes__keys, var_codes__positions);
    }
    var_254 = wp::where(var_242, var_244, var_237);
    var_255 = wp::where(var_242, var_253, var_238);
    // position = head + j * step                                                             <L 14>
    var_257 = wp::mul(var_256, var_step);
    var_258 = wp::add(var_head, var_257);
    // if position <= last:                                                                   <L 15>
    var_259 = (var_258 <= var_5);
    if (var_259) {
        // p = points[position]                                                               <L 16>
        var_260 = wp::address(var_points, var_258);
        var_262 = wp::load(var_260);
        var_261 = wp::copy(var_262);
        // code = int64(1) << int64(3 * levels)                                               <L 17>
        var_263 = 1ll;
        var_265 = wp::mul(var_264, var_levels);
        var_266 = wp::int64(var_265);
        var_267 = wp::lshift(var_263, var_266);
        // if isfinite(p):                                                                    <L 18>
        var_268 = wp::isfinite(var_261);
        if (var_268) {
            // code = indices[j]                                                              <L 19>
            var_269 = wp::extract(var_188, var_256);
        }
        var_270 = wp::where(var_268, var_269, var_267);
        // put_key(position, code, codes__keys, codes__positions)                             <L 20>
        put_key_0(var_258, var_270, var_codes__keys, var_codes__positions);
    }
    var_271 = wp::where(var_259, var_261, var_254);
    var_272 = wp::where(var_259, var_270, var_255);
    // position = head + j * step                                                             <L 14>
    var_274 = wp::mul(var_273, var_step);
    var_275 = wp::add(var_head, var_274);
    // if position <= last:                                                                   <L 15>
    var_276 = (var_275 <= var_5);
    if (var_276) {
        // p = points[position]                                                               <L 16>
        var_277 = wp::address(var_points, var_275);
        var_279 = wp::load(var_277);
        var_278 = wp::copy(var_279);
        // code = int64(1) << int64(3 * levels)                                               <L 17>
        var_280 = 1ll;
        var_282 = wp::mul(var_281, var_levels);
        var_283 = wp::int64(var_282);
        var_284 = wp::lshift(var_280, var_283);
        // if isfinite(p):                                                                    <L 18>
        var_285 = wp::isfinite(var_278);
        if (var_285) {
            // code = indices[j]                                                              <L 19>
            var_286 = wp::extract(var_188, var_273);
        }
        var_287 = wp::where(var_285, var_286, var_284);
        // put_key(position, code, codes__keys, codes__positions)                             <L 20>
        put_key_0(var_275, var_287, var_codes__keys, var_codes__positions);
    }
    var_288 = wp::where(var_276, var_278, var_271);
    var_289 = wp::where(var_276, var_287, var_272);
    // position = head + j * step                                                             <L 14>
    var_291 = wp::mul(var_290, var_step);
    var_292 = wp::add(var_head, var_291);
    // if position <= last:                                                                   <L 15>
    var_293 = (var_292 <= var_5);
    if (var_293) {
        // p = points[position]                                                               <L 16>
        var_294 = wp::address(var_points, var_292);
        var_296 = wp::load(var_294);
        var_295 = wp::copy(var_296);
        // code = int64(1) << int64(3 * levels)                                               <L 17>
        var_297 = 1ll;
        var_299 = wp::mul(var_298, var_levels);
        var_300 = wp::int64(var_299);
        var_301 = wp::lshift(var_297, var_300);
        // if isfinite(p):                                                                    <L 18>
        var_302 = wp::isfinite(var_295);
        if (var_302) {
            // code = indices[j]                                                              <L 19>
            var_303 = wp::extract(var_188, var_290);
        }
        var_304 = wp::where(var_302, var_303, var_301);
        // put_key(position, code, codes__keys, codes__positions)                             <L 20>
        put_key_0(var_292, var_304, var_codes__keys, var_codes__positions);
    }
    var_305 = wp::where(var_293, var_295, var_288);
    var_306 = wp::where(var_293, var_304, var_289);
    // position = head + j * step                                                             <L 14>
    var_308 = wp::mul(var_307, var_step);
    var_309 = wp::add(var_head, var_308);
    // if position <= last:                                                                   <L 15>
    var_310 = (var_309 <= var_5);
    if (var_310) {
        // p = points[position]                                                               <L 16>
        var_311 = wp::address(var_points, var_309);
        var_313 = wp::load(var_311);
        var_312 = wp::copy(var_313);
        // code = int64(1) << int64(3 * levels)                                               <L 17>
        var_314 = 1ll;
        var_316 = wp::mul(var_315, var_levels);
        var_317 = wp::int64(var_316);
        var_318 = wp::lshift(var_314, var_317);
        // if isfinite(p):                                                                    <L 18>
        var_319 = wp::isfinite(var_312);
        if (var_319) {
            // code = indices[j]                                                              <L 19>
            var_320 = wp::extract(var_188, var_307);
        }
        var_321 = wp::where(var_319, var_320, var_318);
        // put_key(position, code, codes__keys, codes__positions)                             <L 20>
        put_key_0(var_309, var_321, var_codes__keys, var_codes__positions);
    }
    var_322 = wp::where(var_310, var_312, var_305);
    var_323 = wp::where(var_310, var_321, var_306);
}


// <pointloom.kernels.search.hilbert_order.scale_of_box>:1
static CUDA_CALLABLE void adj_scale_of_box_0(
    wp::vec_t<3, wp::float32> var_low,
    wp::vec_t<3, wp::float32> var_high,
    wp::int32 var_levels,
    wp::vec_t<3, wp::float32> & adj_low,
    wp::vec_t<3, wp::float32> & adj_high,
    wp::int32 & adj_levels,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/search/hilbert_order.py:102
static CUDA_CALLABLE void adj_cell_on_axis_0(
    wp::float32 var_coordinate,
    wp::float32 var_low,
    wp::float32 var_scale,
    wp::int32 var_levels,
    wp::float32 & adj_coordinate,
    wp::float32 & adj_low,
    wp::float32 & adj_scale,
    wp::int32 & adj_levels,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.hilbert_order.spread_bits>:1
static CUDA_CALLABLE void adj_spread_bits_0(
    wp::int32 var_v,
    wp::int32 & adj_v,
    wp::int64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.hilbert_order.hilbert_codes>:1
static CUDA_CALLABLE void adj_hilbert_codes_0(
    wp::vec_t<8, wp::int32> var_cx,
    wp::vec_t<8, wp::int32> var_cy,
    wp::vec_t<8, wp::int32> var_cz,
    wp::int32 var_levels,
    wp::vec_t<8, wp::int32> & adj_cx,
    wp::vec_t<8, wp::int32> & adj_cy,
    wp::vec_t<8, wp::int32> & adj_cz,
    wp::int32 & adj_levels,
    wp::vec_t<8, wp::int64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.arrays.sort.put_key>:1
static CUDA_CALLABLE void adj_put_key_0(
    wp::int32 var_i,
    wp::int64 var_key,
    wp::array_t<wp::int64> var_into__keys,
    wp::array_t<wp::int32> var_into__positions,
    wp::int32 & adj_i,
    wp::int64 & adj_key,
    wp::array_t<wp::int64> & adj_into__keys,
    wp::array_t<wp::int32> & adj_into__positions)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.hilbert_order.put_eight>:1
static CUDA_CALLABLE void adj_put_eight_0(
    wp::int32 var_head,
    wp::int32 var_step,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::vec_t<3, wp::float32> var_low,
    wp::float32 var_scale,
    wp::int32 var_levels,
    wp::array_t<wp::int64> var_codes__keys,
    wp::array_t<wp::int32> var_codes__positions,
    wp::int32 & adj_head,
    wp::int32 & adj_step,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_points,
    wp::vec_t<3, wp::float32> & adj_low,
    wp::float32 & adj_scale,
    wp::int32 & adj_levels,
    wp::array_t<wp::int64> & adj_codes__keys,
    wp::array_t<wp::int32> & adj_codes__positions)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void encode_in_box_kernel_48623679_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::array_t<wp::float32> var_box,
    wp::int32 var_levels,
    wp::int32 var_apart,
    wp::int32 var_step,
    wp::array_t<wp::int64> var_codes__keys,
    wp::array_t<wp::int32> var_codes__positions)
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
        wp::float32* var_2;
        const wp::int32 var_3 = 1;
        wp::float32* var_4;
        const wp::int32 var_5 = 2;
        wp::float32* var_6;
        wp::vec_t<3, wp::float32> var_7;
        wp::float32 var_8;
        wp::float32 var_9;
        wp::float32 var_10;
        const wp::int32 var_11 = 3;
        wp::float32* var_12;
        const wp::int32 var_13 = 4;
        wp::float32* var_14;
        const wp::int32 var_15 = 5;
        wp::float32* var_16;
        wp::vec_t<3, wp::float32> var_17;
        wp::float32 var_18;
        wp::float32 var_19;
        wp::float32 var_20;
        wp::float32 var_21;
        wp::int32 var_22;
        //---------
        // forward
        // def encode_in_box_kernel(points, box, levels, apart, step, codes__keys, codes__positions):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // low = vec3(box[0], box[1], box[2])                                                     <L 4>
        var_2 = wp::address(var_box, var_1);
        var_4 = wp::address(var_box, var_3);
        var_6 = wp::address(var_box, var_5);
        var_8 = wp::load(var_2);
        var_9 = wp::load(var_4);
        var_10 = wp::load(var_6);
        var_7 = wp::vec_t<3, wp::float32>(var_8, var_9, var_10);
        // scale = scale_of_box(low, vec3(box[3], box[4], box[5]), levels)                        <L 5>
        var_12 = wp::address(var_box, var_11);
        var_14 = wp::address(var_box, var_13);
        var_16 = wp::address(var_box, var_15);
        var_18 = wp::load(var_12);
        var_19 = wp::load(var_14);
        var_20 = wp::load(var_16);
        var_17 = wp::vec_t<3, wp::float32>(var_18, var_19, var_20);
        var_21 = scale_of_box_0(var_7, var_17, var_levels);
        // put_eight(i * apart, step, points, low, scale, levels, codes__keys, codes__positions)       <L 6>
        var_22 = wp::mul(var_0, var_apart);
        put_eight_0(var_22, var_step, var_points, var_7, var_21, var_levels, var_codes__keys, var_codes__positions);
}



extern "C" __global__ void encode_points_kernel_d1a7da1f_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::vec_t<3, wp::float32> var_curve__low,
    wp::float32 var_curve__scale,
    wp::int32 var_curve__levels,
    wp::int32 var_apart,
    wp::int32 var_step,
    wp::array_t<wp::int64> var_codes__keys,
    wp::array_t<wp::int32> var_codes__positions)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::int32 var_1;
        //---------
        // forward
        // def encode_points_kernel(points, curve__low, curve__scale, curve__levels, apart, step, codes__keys, codes__positions):       <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // put_eight(i * apart, step, points, curve__low, curve__scale, curve__levels, codes__keys, codes__positions)       <L 3>
        var_1 = wp::mul(var_0, var_apart);
        put_eight_0(var_1, var_step, var_points, var_curve__low, var_curve__scale, var_curve__levels, var_codes__keys, var_codes__positions);
}


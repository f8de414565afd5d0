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


// <pointloom.kernels.search.hilbert_order.locate_on_curve>:1
static CUDA_CALLABLE wp::int64 locate_on_curve_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> var_curve__low,
    wp::float32 var_curve__scale,
    wp::int32 var_curve__levels)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    const wp::int32 var_2 = 0;
    wp::float32 var_3;
    wp::int32 var_4;
    wp::vec_t<8, wp::int32> var_5;
    const wp::int32 var_6 = 1;
    wp::float32 var_7;
    const wp::int32 var_8 = 1;
    wp::float32 var_9;
    wp::int32 var_10;
    wp::vec_t<8, wp::int32> var_11;
    const wp::int32 var_12 = 2;
    wp::float32 var_13;
    const wp::int32 var_14 = 2;
    wp::float32 var_15;
    wp::int32 var_16;
    wp::vec_t<8, wp::int32> var_17;
    wp::vec_t<8, wp::int64> var_18;
    const wp::int32 var_19 = 0;
    wp::int64 var_20;
    //---------
    // forward
    // def locate_on_curve(p, curve__low, curve__scale, curve__levels):                       <L 1>
    // x = lanes(cell_on_axis(p[0], curve__low[0], curve__scale, curve__levels))              <L 3>
    var_1 = wp::extract(var_p, var_0);
    var_3 = wp::extract(var_curve__low, var_2);
    var_4 = cell_on_axis_0(var_1, var_3, var_curve__scale, var_curve__levels);
    var_5 = wp::vec_t<8, wp::int32>(var_4);
    // y = lanes(cell_on_axis(p[1], curve__low[1], curve__scale, curve__levels))              <L 4>
    var_7 = wp::extract(var_p, var_6);
    var_9 = wp::extract(var_curve__low, var_8);
    var_10 = cell_on_axis_0(var_7, var_9, var_curve__scale, var_curve__levels);
    var_11 = wp::vec_t<8, wp::int32>(var_10);
    // z = lanes(cell_on_axis(p[2], curve__low[2], curve__scale, curve__levels))              <L 5>
    var_13 = wp::extract(var_p, var_12);
    var_15 = wp::extract(var_curve__low, var_14);
    var_16 = cell_on_axis_0(var_13, var_15, var_curve__scale, var_curve__levels);
    var_17 = wp::vec_t<8, wp::int32>(var_16);
    // codes = hilbert_codes(x, y, z, curve__levels)                                          <L 6>
    var_18 = hilbert_codes_0(var_5, var_11, var_17, var_curve__levels);
    // return codes[0]                                                                        <L 7>
    var_20 = wp::extract(var_18, var_19);
    return var_20;
}


// <pointloom.kernels.search.point_tree.find_run>:1
static CUDA_CALLABLE wp::int32 find_run_0(
    wp::array_t<wp::int64> var_codes,
    wp::int32 var_first,
    wp::int32 var_count,
    wp::int64 var_code)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    wp::int32 var_2;
    wp::int32 var_3;
    const wp::int32 var_4 = 1;
    bool var_5;
    wp::int32 var_6;
    const wp::int32 var_7 = 2;
    wp::int32 var_8;
    wp::int32 var_9;
    wp::int64* var_10;
    bool var_11;
    wp::int64 var_12;
    wp::int32 var_13;
    wp::int32 var_14;
    wp::int32 var_15;
    wp::int32 var_16;
    //---------
    // forward
    // def find_run(codes, first, count, code):                                               <L 1>
    // a = int(0)                                                                             <L 3>
    var_1 = wp::int(var_0);
    // b = count                                                                              <L 4>
    var_2 = wp::copy(var_count);
    // while b - a > 1:                                                                       <L 5>
    start_while_0:;
    var_3 = wp::sub(var_2, var_1);
    var_5 = (var_3 > var_4);
    if ((var_5) == false) goto end_while_0;
        // middle = (a + b) // 2                                                              <L 6>
        var_6 = wp::add(var_1, var_2);
        var_8 = wp::floordiv(var_6, var_7);
        // if codes[first + middle] <= code:                                                  <L 7>
        var_9 = wp::add(var_first, var_8);
        var_10 = wp::address(var_codes, var_9);
        var_12 = wp::load(var_10);
        var_11 = (var_12 <= var_code);
        if (var_11) {
            // a = middle                                                                     <L 8>
            var_13 = wp::copy(var_8);
        }
        if (!var_11) {
            // b = middle                                                                     <L 10>
            var_14 = wp::copy(var_8);
        }
        var_15 = wp::where(var_11, var_13, var_1);
        var_16 = wp::where(var_11, var_2, var_14);
        wp::assign(var_1, var_15);
        wp::assign(var_2, var_16);
    goto start_while_0;
    end_while_0:;
    // return a                                                                               <L 11>
    return var_1;
}


// <pointloom.kernels.search.point_tree.find_bucket>:1
static CUDA_CALLABLE wp::int32 find_bucket_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::int32 var_tree__count,
    wp::array_t<wp::int64> var_tree__codes,
    wp::vec_t<3, wp::float32> var_tree__curve__low,
    wp::float32 var_tree__curve__scale,
    wp::int32 var_tree__curve__levels)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    const wp::int32 var_1 = 64;
    wp::int32 var_2;
    const wp::int32 var_3 = 1;
    wp::int32 var_4;
    wp::int32 var_5;
    wp::int64 var_6;
    wp::int32 var_7;
    //---------
    // forward
    // def find_bucket(p, tree__count, tree__codes, tree__curve__low, tree__curve__scale, tree__curve__levels):       <L 1>
    // return find_run(tree__codes, 0, (tree__count + BUCKET - 1) // BUCKET, locate_on_curve(p, tree__curve__low, tree__curve__scale, tree__curve__levels))       <L 2>
    var_2 = wp::add(var_tree__count, var_1);
    var_4 = wp::sub(var_2, var_3);
    var_5 = wp::floordiv(var_4, var_1);
    var_6 = locate_on_curve_0(var_p, var_tree__curve__low, var_tree__curve__scale, var_tree__curve__levels);
    var_7 = find_run_0(var_tree__codes, var_0, var_5, var_6);
    return var_7;
}


// <pointloom.kernels.search.bucket_walk.start_traversal>:1
static CUDA_CALLABLE wp::vec_t<4, wp::int64> start_traversal_0(
    wp::int32 var_bucket)
{
    //---------
    // primal vars
    wp::int64 var_0;
    wp::int64 var_1;
    wp::int64 var_2;
    wp::int64 var_3;
    wp::vec_t<4, wp::int64> var_4;
    //---------
    // forward
    // def start_traversal(bucket):                                                           <L 1>
    // return traversal(int64(0), int64(0), int64(bucket), int64(0))                          <L 2>
    var_0 = 0ll;
    var_1 = 0ll;
    var_2 = wp::int64(var_bucket);
    var_3 = 0ll;
    var_4 = wp::vec_t<4, wp::int64>(var_0, var_1, var_2, var_3);
    return var_4;
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


// /work/main/src/pointloom/kernels/search/point_tree.py:388
static CUDA_CALLABLE wp::vec_t<8, wp::float32> measure_boxes_0(
    wp::array_t<wp::float32> var_boxes,
    wp::int32 var_node,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 48;
    wp::int32 var_1;
    const wp::float32 var_2 = 0.0;
    wp::vec_t<8, wp::float32> var_3;
    const wp::int32 var_4 = 0;
    wp::int32 var_5;
    wp::float32* var_6;
    const wp::int32 var_7 = 0;
    wp::float32 var_8;
    wp::float32 var_9;
    wp::float32 var_10;
    const wp::int32 var_11 = 0;
    wp::float32 var_12;
    wp::int32 var_13;
    const wp::int32 var_14 = 3;
    const wp::int32 var_15 = 8;
    wp::int32 var_16;
    wp::int32 var_17;
    wp::float32* var_18;
    wp::float32 var_19;
    wp::float32 var_20;
    wp::float32 var_21;
    const wp::float32 var_22 = 0.0;
    wp::float32 var_23;
    wp::int32 var_24;
    wp::int32 var_25;
    wp::float32* var_26;
    const wp::int32 var_27 = 1;
    wp::float32 var_28;
    wp::float32 var_29;
    wp::float32 var_30;
    const wp::int32 var_31 = 1;
    wp::float32 var_32;
    wp::int32 var_33;
    const wp::int32 var_34 = 4;
    wp::int32 var_35;
    wp::int32 var_36;
    wp::float32* var_37;
    wp::float32 var_38;
    wp::float32 var_39;
    wp::float32 var_40;
    const wp::float32 var_41 = 0.0;
    wp::float32 var_42;
    wp::int32 var_43;
    const wp::int32 var_44 = 2;
    wp::int32 var_45;
    wp::int32 var_46;
    wp::float32* var_47;
    const wp::int32 var_48 = 2;
    wp::float32 var_49;
    wp::float32 var_50;
    wp::float32 var_51;
    const wp::int32 var_52 = 2;
    wp::float32 var_53;
    wp::int32 var_54;
    const wp::int32 var_55 = 5;
    wp::int32 var_56;
    wp::int32 var_57;
    wp::float32* var_58;
    wp::float32 var_59;
    wp::float32 var_60;
    wp::float32 var_61;
    const wp::float32 var_62 = 0.0;
    wp::float32 var_63;
    wp::float32 var_64;
    wp::float32 var_65;
    wp::float32 var_66;
    wp::float32 var_67;
    wp::float32 var_68;
    const wp::int32 var_69 = 1;
    wp::int32 var_70;
    wp::float32* var_71;
    const wp::int32 var_72 = 0;
    wp::float32 var_73;
    wp::float32 var_74;
    wp::float32 var_75;
    const wp::int32 var_76 = 0;
    wp::float32 var_77;
    wp::int32 var_78;
    const wp::int32 var_79 = 3;
    wp::int32 var_80;
    wp::int32 var_81;
    wp::float32* var_82;
    wp::float32 var_83;
    wp::float32 var_84;
    wp::float32 var_85;
    const wp::float32 var_86 = 0.0;
    wp::float32 var_87;
    wp::int32 var_88;
    wp::int32 var_89;
    wp::float32* var_90;
    const wp::int32 var_91 = 1;
    wp::float32 var_92;
    wp::float32 var_93;
    wp::float32 var_94;
    const wp::int32 var_95 = 1;
    wp::float32 var_96;
    wp::int32 var_97;
    const wp::int32 var_98 = 4;
    wp::int32 var_99;
    wp::int32 var_100;
    wp::float32* var_101;
    wp::float32 var_102;
    wp::float32 var_103;
    wp::float32 var_104;
    const wp::float32 var_105 = 0.0;
    wp::float32 var_106;
    wp::int32 var_107;
    const wp::int32 var_108 = 2;
    wp::int32 var_109;
    wp::int32 var_110;
    wp::float32* var_111;
    const wp::int32 var_112 = 2;
    wp::float32 var_113;
    wp::float32 var_114;
    wp::float32 var_115;
    const wp::int32 var_116 = 2;
    wp::float32 var_117;
    wp::int32 var_118;
    const wp::int32 var_119 = 5;
    wp::int32 var_120;
    wp::int32 var_121;
    wp::float32* var_122;
    wp::float32 var_123;
    wp::float32 var_124;
    wp::float32 var_125;
    const wp::float32 var_126 = 0.0;
    wp::float32 var_127;
    wp::float32 var_128;
    wp::float32 var_129;
    wp::float32 var_130;
    wp::float32 var_131;
    wp::float32 var_132;
    const wp::int32 var_133 = 2;
    wp::int32 var_134;
    wp::float32* var_135;
    const wp::int32 var_136 = 0;
    wp::float32 var_137;
    wp::float32 var_138;
    wp::float32 var_139;
    const wp::int32 var_140 = 0;
    wp::float32 var_141;
    wp::int32 var_142;
    const wp::int32 var_143 = 3;
    wp::int32 var_144;
    wp::int32 var_145;
    wp::float32* var_146;
    wp::float32 var_147;
    wp::float32 var_148;
    wp::float32 var_149;
    const wp::float32 var_150 = 0.0;
    wp::float32 var_151;
    wp::int32 var_152;
    wp::int32 var_153;
    wp::float32* var_154;
    const wp::int32 var_155 = 1;
    wp::float32 var_156;
    wp::float32 var_157;
    wp::float32 var_158;
    const wp::int32 var_159 = 1;
    wp::float32 var_160;
    wp::int32 var_161;
    const wp::int32 var_162 = 4;
    wp::int32 var_163;
    wp::int32 var_164;
    wp::float32* var_165;
    wp::float32 var_166;
    wp::float32 var_167;
    wp::float32 var_168;
    const wp::float32 var_169 = 0.0;
    wp::float32 var_170;
    wp::int32 var_171;
    const wp::int32 var_172 = 2;
    wp::int32 var_173;
    wp::int32 var_174;
    wp::float32* var_175;
    const wp::int32 var_176 = 2;
    wp::float32 var_177;
    wp::float32 var_178;
    wp::float32 var_179;
    const wp::int32 var_180 = 2;
    wp::float32 var_181;
    wp::int32 var_182;
    const wp::int32 var_183 = 5;
    wp::int32 var_184;
    wp::int32 var_185;
    wp::float32* var_186;
    wp::float32 var_187;
    wp::float32 var_188;
    wp::float32 var_189;
    const wp::float32 var_190 = 0.0;
    wp::float32 var_191;
    wp::float32 var_192;
    wp::float32 var_193;
    wp::float32 var_194;
    wp::float32 var_195;
    wp::float32 var_196;
    const wp::int32 var_197 = 3;
    wp::int32 var_198;
    wp::float32* var_199;
    const wp::int32 var_200 = 0;
    wp::float32 var_201;
    wp::float32 var_202;
    wp::float32 var_203;
    const wp::int32 var_204 = 0;
    wp::float32 var_205;
    wp::int32 var_206;
    const wp::int32 var_207 = 3;
    wp::int32 var_208;
    wp::int32 var_209;
    wp::float32* var_210;
    wp::float32 var_211;
    wp::float32 var_212;
    wp::float32 var_213;
    const wp::float32 var_214 = 0.0;
    wp::float32 var_215;
    wp::int32 var_216;
    wp::int32 var_217;
    wp::float32* var_218;
    const wp::int32 var_219 = 1;
    wp::float32 var_220;
    wp::float32 var_221;
    wp::float32 var_222;
    const wp::int32 var_223 = 1;
    wp::float32 var_224;
    wp::int32 var_225;
    const wp::int32 var_226 = 4;
    wp::int32 var_227;
    wp::int32 var_228;
    wp::float32* var_229;
    wp::float32 var_230;
    wp::float32 var_231;
    wp::float32 var_232;
    const wp::float32 var_233 = 0.0;
    wp::float32 var_234;
    wp::int32 var_235;
    const wp::int32 var_236 = 2;
    wp::int32 var_237;
    wp::int32 var_238;
    wp::float32* var_239;
    const wp::int32 var_240 = 2;
    wp::float32 var_241;
    wp::float32 var_242;
    wp::float32 var_243;
    const wp::int32 var_244 = 2;
    wp::float32 var_245;
    wp::int32 var_246;
    const wp::int32 var_247 = 5;
    wp::int32 var_248;
    wp::int32 var_249;
    wp::float32* var_250;
    wp::float32 var_251;
    wp::float32 var_252;
    wp::float32 var_253;
    const wp::float32 var_254 = 0.0;
    wp::float32 var_255;
    wp::float32 var_256;
    wp::float32 var_257;
    wp::float32 var_258;
    wp::float32 var_259;
    wp::float32 var_260;
    const wp::int32 var_261 = 4;
    wp::int32 var_262;
    wp::float32* var_263;
    const wp::int32 var_264 = 0;
    wp::float32 var_265;
    wp::float32 var_266;
    wp::float32 var_267;
    const wp::int32 var_268 = 0;
    wp::float32 var_269;
    wp::int32 var_270;
    const wp::int32 var_271 = 3;
    wp::int32 var_272;
    wp::int32 var_273;
    wp::float32* var_274;
    wp::float32 var_275;
    wp::float32 var_276;
    wp::float32 var_277;
    const wp::float32 var_278 = 0.0;
    wp::float32 var_279;
    wp::int32 var_280;
    wp::int32 var_281;
    wp::float32* var_282;
    const wp::int32 var_283 = 1;
    wp::float32 var_284;
    wp::float32 var_285;
    wp::float32 var_286;
    const wp::int32 var_287 = 1;
    wp::float32 var_288;
    wp::int32 var_289;
    const wp::int32 var_290 = 4;
    wp::int32 var_291;
    wp::int32 var_292;
    wp::float32* var_293;
    wp::float32 var_294;
    wp::float32 var_295;
    wp::float32 var_296;
    const wp::float32 var_297 = 0.0;
    wp::float32 var_298;
    wp::int32 var_299;
    const wp::int32 var_300 = 2;
    wp::int32 var_301;
    wp::int32 var_302;
    wp::float32* var_303;
    const wp::int32 var_304 = 2;
    wp::float32 var_305;
    wp::float32 var_306;
    wp::float32 var_307;
    const wp::int32 var_308 = 2;
    wp::float32 var_309;
    wp::int32 var_310;
    const wp::int32 var_311 = 5;
    wp::int32 var_312;
    wp::int32 var_313;
    wp::float32* var_314;
    wp::float32 var_315;
    wp::float32 var_316;
    wp::float32 var_317;
    const wp::float32 var_318 = 0.0;
    wp::float32 var_319;
    wp::float32 var_320;
    wp::float32 var_321;
    wp::float32 var_322;
    wp::float32 var_323;
    wp::float32 var_324;
    const wp::int32 var_325 = 5;
    wp::int32 var_326;
    wp::float32* var_327;
    const wp::int32 var_328 = 0;
    wp::float32 var_329;
    wp::float32 var_330;
    wp::float32 var_331;
    const wp::int32 var_332 = 0;
    wp::float32 var_333;
    wp::int32 var_334;
    const wp::int32 var_335 = 3;
    wp::int32 var_336;
    wp::int32 var_337;
    wp::float32* var_338;
    wp::float32 var_339;
    wp::float32 var_340;
    wp::float32 var_341;
    const wp::float32 var_342 = 0.0;
    wp::float32 var_343;
    wp::int32 var_344;
    wp::int32 var_345;
    wp::float32* var_346;
    const wp::int32 var_347 = 1;
    wp::float32 var_348;
    wp::float32 var_349;
    wp::float32 var_350;
    const wp::int32 var_351 = 1;
    wp::float32 var_352;
    wp::int32 var_353;
    const wp::int32 var_354 = 4;
    wp::int32 var_355;
    wp::int32 var_356;
    wp::float32* var_357;
    wp::float32 var_358;
    wp::float32 var_359;
    wp::float32 var_360;
    const wp::float32 var_361 = 0.0;
    wp::float32 var_362;
    wp::int32 var_363;
    const wp::int32 var_364 = 2;
    wp::int32 var_365;
    wp::int32 var_366;
    wp::float32* var_367;
    const wp::int32 var_368 = 2;
    wp::float32 var_369;
    wp::float32 var_370;
    wp::float32 var_371;
    const wp::int32 var_372 = 2;
    wp::float32 var_373;
    wp::int32 var_374;
    const wp::int32 var_375 = 5;
    wp::int32 var_376;
    wp::int32 var_377;
    wp::float32* var_378;
    wp::float32 var_379;
    wp::float32 var_380;
    wp::float32 var_381;
    const wp::float32 var_382 = 0.0;
    wp::float32 var_383;
    wp::float32 var_384;
    wp::float32 var_385;
    wp::float32 var_386;
    wp::float32 var_387;
    wp::float32 var_388;
    const wp::int32 var_389 = 6;
    wp::int32 var_390;
    wp::float32* var_391;
    const wp::int32 var_392 = 0;
    wp::float32 var_393;
    wp::float32 var_394;
    wp::float32 var_395;
    const wp::int32 var_396 = 0;
    wp::float32 var_397;
    wp::int32 var_398;
    const wp::int32 var_399 = 3;
    wp::int32 var_400;
    wp::int32 var_401;
    wp::float32* var_402;
    wp::float32 var_403;
    wp::float32 var_404;
    wp::float32 var_405;
    const wp::float32 var_406 = 0.0;
    wp::float32 var_407;
    wp::int32 var_408;
    wp::int32 var_409;
    wp::float32* var_410;
    const wp::int32 var_411 = 1;
    wp::float32 var_412;
    wp::float32 var_413;
    wp::float32 var_414;
    const wp::int32 var_415 = 1;
    wp::float32 var_416;
    wp::int32 var_417;
    const wp::int32 var_418 = 4;
    wp::int32 var_419;
    wp::int32 var_420;
    wp::float32* var_421;
    wp::float32 var_422;
    wp::float32 var_423;
    wp::float32 var_424;
    const wp::float32 var_425 = 0.0;
    wp::float32 var_426;
    wp::int32 var_427;
    const wp::int32 var_428 = 2;
    wp::int32 var_429;
    wp::int32 var_430;
    wp::float32* var_431;
    const wp::int32 var_432 = 2;
    wp::float32 var_433;
    wp::float32 var_434;
    wp::float32 var_435;
    const wp::int32 var_436 = 2;
    wp::float32 var_437;
    wp::int32 var_438;
    const wp::int32 var_439 = 5;
    wp::int32 var_440;
    wp::int32 var_441;
    wp::float32* var_442;
    wp::float32 var_443;
    wp::float32 var_444;
    wp::float32 var_445;
    const wp::float32 var_446 = 0.0;
    wp::float32 var_447;
    wp::float32 var_448;
    wp::float32 var_449;
    wp::float32 var_450;
    wp::float32 var_451;
    wp::float32 var_452;
    const wp::int32 var_453 = 7;
    wp::int32 var_454;
    wp::float32* var_455;
    const wp::int32 var_456 = 0;
    wp::float32 var_457;
    wp::float32 var_458;
    wp::float32 var_459;
    const wp::int32 var_460 = 0;
    wp::float32 var_461;
    wp::int32 var_462;
    const wp::int32 var_463 = 3;
    wp::int32 var_464;
    wp::int32 var_465;
    wp::float32* var_466;
    wp::float32 var_467;
    wp::float32 var_468;
    wp::float32 var_469;
    const wp::float32 var_470 = 0.0;
    wp::float32 var_471;
    wp::int32 var_472;
    wp::int32 var_473;
    wp::float32* var_474;
    const wp::int32 var_475 = 1;
    wp::float32 var_476;
    wp::float32 var_477;
    wp::float32 var_478;
    const wp::int32 var_479 = 1;
    wp::float32 var_480;
    wp::int32 var_481;
    const wp::int32 var_482 = 4;
    wp::int32 var_483;
    wp::int32 var_484;
    wp::float32* var_485;
    wp::float32 var_486;
    wp::float32 var_487;
    wp::float32 var_488;
    const wp::float32 var_489 = 0.0;
    wp::float32 var_490;
    wp::int32 var_491;
    const wp::int32 var_492 = 2;
    wp::int32 var_493;
    wp::int32 var_494;
    wp::float32* var_495;
    const wp::int32 var_496 = 2;
    wp::float32 var_497;
    wp::float32 var_498;
    wp::float32 var_499;
    const wp::int32 var_500 = 2;
    wp::float32 var_501;
    wp::int32 var_502;
    const wp::int32 var_503 = 5;
    wp::int32 var_504;
    wp::int32 var_505;
    wp::float32* var_506;
    wp::float32 var_507;
    wp::float32 var_508;
    wp::float32 var_509;
    const wp::float32 var_510 = 0.0;
    wp::float32 var_511;
    wp::float32 var_512;
    wp::float32 var_513;
    wp::float32 var_514;
    wp::float32 var_515;
    wp::float32 var_516;
    //---------
    // forward
    // def measure_boxes(boxes: array(dtype=float32), node: int, a: vec3, b: vec3) -> box_distances:       <L 389>
    // at = node * SIDES                                                                      <L 391>
    var_1 = wp::mul(var_node, var_0);
    // distances = box_distances(0.0)                                                         <L 392>
    var_3 = wp::vec_t<8, wp::float32>(var_2);
    // for j in range(FAN):                                                                   <L 393>
    // x = larger(larger(boxes[at + j] - b[0], a[0] - boxes[at + j + 3 * FAN]), 0.0)          <L 394>
    var_5 = wp::add(var_1, var_4);
    var_6 = wp::address(var_boxes, var_5);
    var_8 = wp::extract(var_b, var_7);
    var_10 = wp::load(var_6);
    var_9 = wp::sub(var_10, var_8);
    var_12 = wp::extract(var_a, var_11);
    var_13 = wp::add(var_1, var_4);
    var_16 = wp::mul(var_14, var_15);
    var_17 = wp::add(var_13, var_16);
    var_18 = wp::address(var_boxes, var_17);
    var_20 = wp::load(var_18);
    var_19 = wp::sub(var_12, var_20);
    var_21 = larger_0(var_9, var_19);
    var_23 = larger_0(var_21, var_22);
    // y = larger(larger(boxes[at + j + FAN] - b[1], a[1] - boxes[at + j + 4 * FAN]), 0.0)       <L 395>
    var_24 = wp::add(var_1, var_4);
    var_25 = wp::add(var_24, var_15);
    var_26 = wp::address(var_boxes, var_25);
    var_28 = wp::extract(var_b, var_27);
    var_30 = wp::load(var_26);
    var_29 = wp::sub(var_30, var_28);
    var_32 = wp::extract(var_a, var_31);
    var_33 = wp::add(var_1, var_4);
    var_35 = wp::mul(var_34, var_15);
    var_36 = wp::add(var_33, var_35);
    var_37 = wp::address(var_boxes, var_36);
    var_39 = wp::load(var_37);
    var_38 = wp::sub(var_32, var_39);
    var_40 = larger_0(var_29, var_38);
    var_42 = larger_0(var_40, var_41);
    // z = larger(larger(boxes[at + j + 2 * FAN] - b[2], a[2] - boxes[at + j + 5 * FAN]), 0.0)       <L 396>
    var_43 = wp::add(var_1, var_4);
    var_45 = wp::mul(var_44, var_15);
    var_46 = wp::add(var_43, var_45);
    var_47 = wp::address(var_boxes, var_46);
    var_49 = wp::extract(var_b, var_48);
    var_51 = wp::load(var_47);
    var_50 = wp::sub(var_51, var_49);
    var_53 = wp::extract(var_a, var_52);
    var_54 = wp::add(var_1, var_4);
    var_56 = wp::mul(var_55, var_15);
    var_57 = wp::add(var_54, var_56);
    var_58 = wp::address(var_boxes, var_57);
    var_60 = wp::load(var_58);
    var_59 = wp::sub(var_53, var_60);
    var_61 = larger_0(var_50, var_59);
    var_63 = larger_0(var_61, var_62);
    // distances[j] = x * x + y * y + z * z                                                   <L 397>
    var_64 = wp::mul(var_23, var_23);
    var_65 = wp::mul(var_42, var_42);
    var_66 = wp::add(var_64, var_65);
    var_67 = wp::mul(var_63, var_63);
    var_68 = wp::add(var_66, var_67);
    wp::assign_inplace(var_3, var_4, var_68);
    // x = larger(larger(boxes[at + j] - b[0], a[0] - boxes[at + j + 3 * FAN]), 0.0)          <L 394>
    var_70 = wp::add(var_1, var_69);
    var_71 = wp::address(var_boxes, var_70);
    var_73 = wp::extract(var_b, var_72);
    var_75 = wp::load(var_71);
    var_74 = wp::sub(var_75, var_73);
    var_77 = wp::extract(var_a, var_76);
    var_78 = wp::add(var_1, var_69);
    var_80 = wp::mul(var_79, var_15);
    var_81 = wp::add(var_78, var_80);
    var_82 = wp::address(var_boxes, var_81);
    var_84 = wp::load(var_82);
    var_83 = wp::sub(var_77, var_84);
    var_85 = larger_0(var_74, var_83);
    var_87 = larger_0(var_85, var_86);
    // y = larger(larger(boxes[at + j + FAN] - b[1], a[1] - boxes[at + j + 4 * FAN]), 0.0)       <L 395>
    var_88 = wp::add(var_1, var_69);
    var_89 = wp::add(var_88, var_15);
    var_90 = wp::address(var_boxes, var_89);
    var_92 = wp::extract(var_b, var_91);
    var_94 = wp::load(var_90);
    var_93 = wp::sub(var_94, var_92);
    var_96 = wp::extract(var_a, var_95);
    var_97 = wp::add(var_1, var_69);
    var_99 = wp::mul(var_98, var_15);
    var_100 = wp::add(var_97, var_99);
    var_101 = wp::address(var_boxes, var_100);
    var_103 = wp::load(var_101);
    var_102 = wp::sub(var_96, var_103);
    var_104 = larger_0(var_93, var_102);
    var_106 = larger_0(var_104, var_105);
    // z = larger(larger(boxes[at + j + 2 * FAN] - b[2], a[2] - boxes[at + j + 5 * FAN]), 0.0)       <L 396>
    var_107 = wp::add(var_1, var_69);
    var_109 = wp::mul(var_108, var_15);
    var_110 = wp::add(var_107, var_109);
    var_111 = wp::address(var_boxes, var_110);
    var_113 = wp::extract(var_b, var_112);
    var_115 = wp::load(var_111);
    var_114 = wp::sub(var_115, var_113);
    var_117 = wp::extract(var_a, var_116);
    var_118 = wp::add(var_1, var_69);
    var_120 = wp::mul(var_119, var_15);
    var_121 = wp::add(var_118, var_120);
    var_122 = wp::address(var_boxes, var_121);
    var_124 = wp::load(var_122);
    var_123 = wp::sub(var_117, var_124);
    var_125 = larger_0(var_114, var_123);
    var_127 = larger_0(var_125, var_126);
    // distances[j] = x * x + y * y + z * z                                                   <L 397>
    var_128 = wp::mul(var_87, var_87);
    var_129 = wp::mul(var_106, var_106);
    var_130 = wp::add(var_128, var_129);
    var_131 = wp::mul(var_127, var_127);
    var_132 = wp::add(var_130, var_131);
    wp::assign_inplace(var_3, var_69, var_132);
    // x = larger(larger(boxes[at + j] - b[0], a[0] - boxes[at + j + 3 * FAN]), 0.0)          <L 394>
    var_134 = wp::add(var_1, var_133);
    var_135 = wp::address(var_boxes, var_134);
    var_137 = wp::extract(var_b, var_136);
    var_139 = wp::load(var_135);
    var_138 = wp::sub(var_139, var_137);
    var_141 = wp::extract(var_a, var_140);
    var_142 = wp::add(var_1, var_133);
    var_144 = wp::mul(var_143, var_15);
    var_145 = wp::add(var_142, var_144);
    var_146 = wp::address(var_boxes, var_145);
    var_148 = wp::load(var_146);
    var_147 = wp::sub(var_141, var_148);
    var_149 = larger_0(var_138, var_147);
    var_151 = larger_0(var_149, var_150);
    // y = larger(larger(boxes[at + j + FAN] - b[1], a[1] - boxes[at + j + 4 * FAN]), 0.0)       <L 395>
    var_152 = wp::add(var_1, var_133);
    var_153 = wp::add(var_152, var_15);
    var_154 = wp::address(var_boxes, var_153);
    var_156 = wp::extract(var_b, var_155);
    var_158 = wp::load(var_154);
    var_157 = wp::sub(var_158, var_156);
    var_160 = wp::extract(var_a, var_159);
    var_161 = wp::add(var_1, var_133);
    var_163 = wp::mul(var_162, var_15);
    var_164 = wp::add(var_161, var_163);
    var_165 = wp::address(var_boxes, var_164);
    var_167 = wp::load(var_165);
    var_166 = wp::sub(var_160, var_167);
    var_168 = larger_0(var_157, var_166);
    var_170 = larger_0(var_168, var_169);
    // z = larger(larger(boxes[at + j + 2 * FAN] - b[2], a[2] - boxes[at + j + 5 * FAN]), 0.0)       <L 396>
    var_171 = wp::add(var_1, var_133);
    var_173 = wp::mul(var_172, var_15);
    var_174 = wp::add(var_171, var_173);
    var_175 = wp::address(var_boxes, var_174);
    var_177 = wp::extract(var_b, var_176);
    var_179 = wp::load(var_175);
    var_178 = wp::sub(var_179, var_177);
    var_181 = wp::extract(var_a, var_180);
    var_182 = wp::add(var_1, var_133);
    var_184 = wp::mul(var_183, var_15);
    var_185 = wp::add(var_182, var_184);
    var_186 = wp::address(var_boxes, var_185);
    var_188 = wp::load(var_186);
    var_187 = wp::sub(var_181, var_188);
    var_189 = larger_0(var_178, var_187);
    var_191 = larger_0(var_189, var_190);
    // distances[j] = x * x + y * y + z * z                                                   <L 397>
    var_192 = wp::mul(var_151, var_151);
    var_193 = wp::mul(var_170, var_170);
    var_194 = wp::add(var_192, var_193);
    var_195 = wp::mul(var_191, var_191);
    var_196 = wp::add(var_194, var_195);
    wp::assign_inplace(var_3, var_133, var_196);
    // x = larger(larger(boxes[at + j] - b[0], a[0] - boxes[at + j + 3 * FAN]), 0.0)          <L 394>
    var_198 = wp::add(var_1, var_197);
    var_199 = wp::address(var_boxes, var_198);
    var_201 = wp::extract(var_b, var_200);
    var_203 = wp::load(var_199);
    var_202 = wp::sub(var_203, var_201);
    var_205 = wp::extract(var_a, var_204);
    var_206 = wp::add(var_1, var_197);
    var_208 = wp::mul(var_207, var_15);
    var_209 = wp::add(var_206, var_208);
    var_210 = wp::address(var_boxes, var_209);
    var_212 = wp::load(var_210);
    var_211 = wp::sub(var_205, var_212);
    var_213 = larger_0(var_202, var_211);
    var_215 = larger_0(var_213, var_214);
    // y = larger(larger(boxes[at + j + FAN] - b[1], a[1] - boxes[at + j + 4 * FAN]), 0.0)       <L 395>
    var_216 = wp::add(var_1, var_197);
    var_217 = wp::add(var_216, var_15);
    var_218 = wp::address(var_boxes, var_217);
    var_220 = wp::extract(var_b, var_219);
    var_222 = wp::load(var_218);
    var_221 = wp::sub(var_222, var_220);
    var_224 = wp::extract(var_a, var_223);
    var_225 = wp::add(var_1, var_197);
    var_227 = wp::mul(var_226, var_15);
    var_228 = wp::add(var_225, var_227);
    var_229 = wp::address(var_boxes, var_228);
    var_231 = wp::load(var_229);
    var_230 = wp::sub(var_224, var_231);
    var_232 = larger_0(var_221, var_230);
    var_234 = larger_0(var_232, var_233);
    // z = larger(larger(boxes[at + j + 2 * FAN] - b[2], a[2] - boxes[at + j + 5 * FAN]), 0.0)       <L 396>
    var_235 = wp::add(var_1, var_197);
    var_237 = wp::mul(var_236, var_15);
    var_238 = wp::add(var_235, var_237);
    var_239 = wp::address(var_boxes, var_238);
    var_241 = wp::extract(var_b, var_240);
    var_243 = wp::load(var_239);
    var_242 = wp::sub(var_243, var_241);
    var_245 = wp::extract(var_a, var_244);
    var_246 = wp::add(var_1, var_197);
    var_248 = wp::mul(var_247, var_15);
    var_249 = wp::add(var_246, var_248);
    var_250 = wp::address(var_boxes, var_249);
    var_252 = wp::load(var_250);
    var_251 = wp::sub(var_245, var_252);
    var_253 = larger_0(var_242, var_251);
    var_255 = larger_0(var_253, var_254);
    // distances[j] = x * x + y * y + z * z                                                   <L 397>
    var_256 = wp::mul(var_215, var_215);
    var_257 = wp::mul(var_234, var_234);
    var_258 = wp::add(var_256, var_257);
    var_259 = wp::mul(var_255, var_255);
    var_260 = wp::add(var_258, var_259);
    wp::assign_inplace(var_3, var_197, var_260);
    // x = larger(larger(boxes[at + j] - b[0], a[0] - boxes[at + j + 3 * FAN]), 0.0)          <L 394>
    var_262 = wp::add(var_1, var_261);
    var_263 = wp::address(var_boxes, var_262);
    var_265 = wp::extract(var_b, var_264);
    var_267 = wp::load(var_263);
    var_266 = wp::sub(var_267, var_265);
    var_269 = wp::extract(var_a, var_268);
    var_270 = wp::add(var_1, var_261);
    var_272 = wp::mul(var_271, var_15);
    var_273 = wp::add(var_270, var_272);
    var_274 = wp::address(var_boxes, var_273);
    var_276 = wp::load(var_274);
    var_275 = wp::sub(var_269, var_276);
    var_277 = larger_0(var_266, var_275);
    var_279 = larger_0(var_277, var_278);
    // y = larger(larger(boxes[at + j + FAN] - b[1], a[1] - boxes[at + j + 4 * FAN]), 0.0)       <L 395>
    var_280 = wp::add(var_1, var_261);
    var_281 = wp::add(var_280, var_15);
    var_282 = wp::address(var_boxes, var_281);
    var_284 = wp::extract(var_b, var_283);
    var_286 = wp::load(var_282);
    var_285 = wp::sub(var_286, var_284);
    var_288 = wp::extract(var_a, var_287);
    var_289 = wp::add(var_1, var_261);
    var_291 = wp::mul(var_290, var_15);
    var_292 = wp::add(var_289, var_291);
    var_293 = wp::address(var_boxes, var_292);
    var_295 = wp::load(var_293);
    var_294 = wp::sub(var_288, var_295);
    var_296 = larger_0(var_285, var_294);
    var_298 = larger_0(var_296, var_297);
    // z = larger(larger(boxes[at + j + 2 * FAN] - b[2], a[2] - boxes[at + j + 5 * FAN]), 0.0)       <L 396>
    var_299 = wp::add(var_1, var_261);
    var_301 = wp::mul(var_300, var_15);
    var_302 = wp::add(var_299, var_301);
    var_303 = wp::address(var_boxes, var_302);
    var_305 = wp::extract(var_b, var_304);
    var_307 = wp::load(var_303);
    var_306 = wp::sub(var_307, var_305);
    var_309 = wp::extract(var_a, var_308);
    var_310 = wp::add(var_1, var_261);
    var_312 = wp::mul(var_311, var_15);
    var_313 = wp::add(var_310, var_312);
    var_314 = wp::address(var_boxes, var_313);
    var_316 = wp::load(var_314);
    var_315 = wp::sub(var_309, var_316);
    var_317 = larger_0(var_306, var_315);
    var_319 = larger_0(var_317, var_318);
    // distances[j] = x * x + y * y + z * z                                                   <L 397>
    var_320 = wp::mul(var_279, var_279);
    var_321 = wp::mul(var_298, var_298);
    var_322 = wp::add(var_320, var_321);
    var_323 = wp::mul(var_319, var_319);
    var_324 = wp::add(var_322, var_323);
    wp::assign_inplace(var_3, var_261, var_324);
    // x = larger(larger(boxes[at + j] - b[0], a[0] - boxes[at + j + 3 * FAN]), 0.0)          <L 394>
    var_326 = wp::add(var_1, var_325);
    var_327 = wp::address(var_boxes, var_326);
    var_329 = wp::extract(var_b, var_328);
    var_331 = wp::load(var_327);
    var_330 = wp::sub(var_331, var_329);
    var_333 = wp::extract(var_a, var_332);
    var_334 = wp::add(var_1, var_325);
    var_336 = wp::mul(var_335, var_15);
    var_337 = wp::add(var_334, var_336);
    var_338 = wp::address(var_boxes, var_337);
    var_340 = wp::load(var_338);
    var_339 = wp::sub(var_333, var_340);
    var_341 = larger_0(var_330, var_339);
    var_343 = larger_0(var_341, var_342);
    // y = larger(larger(boxes[at + j + FAN] - b[1], a[1] - boxes[at + j + 4 * FAN]), 0.0)       <L 395>
    var_344 = wp::add(var_1, var_325);
    var_345 = wp::add(var_344, var_15);
    var_346 = wp::address(var_boxes, var_345);
    var_348 = wp::extract(var_b, var_347);
    var_350 = wp::load(var_346);
    var_349 = wp::sub(var_350, var_348);
    var_352 = wp::extract(var_a, var_351);
    var_353 = wp::add(var_1, var_325);
    var_355 = wp::mul(var_354, var_15);
    var_356 = wp::add(var_353, var_355);
    var_357 = wp::address(var_boxes, var_356);
    var_359 = wp::load(var_357);
    var_358 = wp::sub(var_352, var_359);
    var_360 = larger_0(var_349, var_358);
    var_362 = larger_0(var_360, var_361);
    // z = larger(larger(boxes[at + j + 2 * FAN] - b[2], a[2] - boxes[at + j + 5 * FAN]), 0.0)       <L 396>
    var_363 = wp::add(var_1, var_325);
    var_365 = wp::mul(var_364, var_15);
    var_366 = wp::add(var_363, var_365);
    var_367 = wp::address(var_boxes, var_366);
    var_369 = wp::extract(var_b, var_368);
    var_371 = wp::load(var_367);
    var_370 = wp::sub(var_371, var_369);
    var_373 = wp::extract(var_a, var_372);
    var_374 = wp::add(var_1, var_325);
    var_376 = wp::mul(var_375, var_15);
    var_377 = wp::add(var_374, var_376);
    var_378 = wp::address(var_boxes, var_377);
    var_380 = wp::load(var_378);
    var_379 = wp::sub(var_373, var_380);
    var_381 = larger_0(var_370, var_379);
    var_383 = larger_0(var_381, var_382);
    // distances[j] = x * x + y * y + z * z                                                   <L 397>
    var_384 = wp::mul(var_343, var_343);
    var_385 = wp::mul(var_362, var_362);
    var_386 = wp::add(var_384, var_385);
    var_387 = wp::mul(var_383, var_383);
    var_388 = wp::add(var_386, var_387);
    wp::assign_inplace(var_3, var_325, var_388);
    // x = larger(larger(boxes[at + j] - b[0], a[0] - boxes[at + j + 3 * FAN]), 0.0)          <L 394>
    var_390 = wp::add(var_1, var_389);
    var_391 = wp::address(var_boxes, var_390);
    var_393 = wp::extract(var_b, var_392);
    var_395 = wp::load(var_391);
    var_394 = wp::sub(var_395, var_393);
    var_397 = wp::extract(var_a, var_396);
    var_398 = wp::add(var_1, var_389);
    var_400 = wp::mul(var_399, var_15);
    var_401 = wp::add(var_398, var_400);
    var_402 = wp::address(var_boxes, var_401);
    var_404 = wp::load(var_402);
    var_403 = wp::sub(var_397, var_404);
    var_405 = larger_0(var_394, var_403);
    var_407 = larger_0(var_405, var_406);
    // y = larger(larger(boxes[at + j + FAN] - b[1], a[1] - boxes[at + j + 4 * FAN]), 0.0)       <L 395>
    var_408 = wp::add(var_1, var_389);
    var_409 = wp::add(var_408, var_15);
    var_410 = wp::address(var_boxes, var_409);
    var_412 = wp::extract(var_b, var_411);
    var_414 = wp::load(var_410);
    var_413 = wp::sub(var_414, var_412);
    var_416 = wp::extract(var_a, var_415);
    var_417 = wp::add(var_1, var_389);
    var_419 = wp::mul(var_418, var_15);
    var_420 = wp::add(var_417, var_419);
    var_421 = wp::address(var_boxes, var_420);
    var_423 = wp::load(var_421);
    var_422 = wp::sub(var_416, var_423);
    var_424 = larger_0(var_413, var_422);
    var_426 = larger_0(var_424, var_425);
    // z = larger(larger(boxes[at + j + 2 * FAN] - b[2], a[2] - boxes[at + j + 5 * FAN]), 0.0)       <L 396>
    var_427 = wp::add(var_1, var_389);
    var_429 = wp::mul(var_428, var_15);
    var_430 = wp::add(var_427, var_429);
    var_431 = wp::address(var_boxes, var_430);
    var_433 = wp::extract(var_b, var_432);
    var_435 = wp::load(var_431);
    var_434 = wp::sub(var_435, var_433);
    var_437 = wp::extract(var_a, var_436);
    var_438 = wp::add(var_1, var_389);
    var_440 = wp::mul(var_439, var_15);
    var_441 = wp::add(var_438, var_440);
    var_442 = wp::address(var_boxes, var_441);
    var_444 = wp::load(var_442);
    var_443 = wp::sub(var_437, var_444);
    var_445 = larger_0(var_434, var_443);
    var_447 = larger_0(var_445, var_446);
    // distances[j] = x * x + y * y + z * z                                                   <L 397>
    var_448 = wp::mul(var_407, var_407);
    var_449 = wp::mul(var_426, var_426);
    var_450 = wp::add(var_448, var_449);
    var_451 = wp::mul(var_447, var_447);
    var_452 = wp::add(var_450, var_451);
    wp::assign_inplace(var_3, var_389, var_452);
    // x = larger(larger(boxes[at + j] - b[0], a[0] - boxes[at + j + 3 * FAN]), 0.0)          <L 394>
    var_454 = wp::add(var_1, var_453);
    var_455 = wp::address(var_boxes, var_454);
    var_457 = wp::extract(var_b, var_456);
    var_459 = wp::load(var_455);
    var_458 = wp::sub(var_459, var_457);
    var_461 = wp::extract(var_a, var_460);
    var_462 = wp::add(var_1, var_453);
    var_464 = wp::mul(var_463, var_15);
    var_465 = wp::add(var_462, var_464);
    var_466 = wp::address(var_boxes, var_465);
    var_468 = wp::load(var_466);
    var_467 = wp::sub(var_461, var_468);
    var_469 = larger_0(var_458, var_467);
    var_471 = larger_0(var_469, var_470);
    // y = larger(larger(boxes[at + j + FAN] - b[1], a[1] - boxes[at + j + 4 * FAN]), 0.0)       <L 395>
    var_472 = wp::add(var_1, var_453);
    var_473 = wp::add(var_472, var_15);
    var_474 = wp::address(var_boxes, var_473);
    var_476 = wp::extract(var_b, var_475);
    var_478 = wp::load(var_474);
    var_477 = wp::sub(var_478, var_476);
    var_480 = wp::extract(var_a, var_479);
    var_481 = wp::add(var_1, var_453);
    var_483 = wp::mul(var_482, var_15);
    var_484 = wp::add(var_481, var_483);
    var_485 = wp::address(var_boxes, var_484);
    var_487 = wp::load(var_485);
    var_486 = wp::sub(var_480, var_487);
    var_488 = larger_0(var_477, var_486);
    var_490 = larger_0(var_488, var_489);
    // z = larger(larger(boxes[at + j + 2 * FAN] - b[2], a[2] - boxes[at + j + 5 * FAN]), 0.0)       <L 396>
    var_491 = wp::add(var_1, var_453);
    var_493 = wp::mul(var_492, var_15);
    var_494 = wp::add(var_491, var_493);
    var_495 = wp::address(var_boxes, var_494);
    var_497 = wp::extract(var_b, var_496);
    var_499 = wp::load(var_495);
    var_498 = wp::sub(var_499, var_497);
    var_501 = wp::extract(var_a, var_500);
    var_502 = wp::add(var_1, var_453);
    var_504 = wp::mul(var_503, var_15);
    var_505 = wp::add(var_502, var_504);
    var_506 = wp::address(var_boxes, var_505);
    var_508 = wp::load(var_506);
    var_507 = wp::sub(var_501, var_508);
    var_509 = larger_0(var_498, var_507);
    var_511 = larger_0(var_509, var_510);
    // distances[j] = x * x + y * y + z * z                                                   <L 397>
    var_512 = wp::mul(var_471, var_471);
    var_513 = wp::mul(var_490, var_490);
    var_514 = wp::add(var_512, var_513);
    var_515 = wp::mul(var_511, var_511);
    var_516 = wp::add(var_514, var_515);
    wp::assign_inplace(var_3, var_453, var_516);
    // return distances                                                                       <L 398>
    return var_3;
}


// /work/main/src/pointloom/kernels/search/point_tree.py:401
static CUDA_CALLABLE wp::float32 measure_box_0(
    wp::array_t<wp::float32> var_boxes,
    wp::int32 var_node,
    wp::int32 var_child,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 48;
    wp::int32 var_1;
    wp::int32 var_2;
    wp::float32* var_3;
    const wp::int32 var_4 = 0;
    wp::float32 var_5;
    wp::float32 var_6;
    wp::float32 var_7;
    const wp::int32 var_8 = 0;
    wp::float32 var_9;
    const wp::int32 var_10 = 3;
    const wp::int32 var_11 = 8;
    wp::int32 var_12;
    wp::int32 var_13;
    wp::float32* var_14;
    wp::float32 var_15;
    wp::float32 var_16;
    wp::float32 var_17;
    const wp::float32 var_18 = 0.0;
    wp::float32 var_19;
    wp::int32 var_20;
    wp::float32* var_21;
    const wp::int32 var_22 = 1;
    wp::float32 var_23;
    wp::float32 var_24;
    wp::float32 var_25;
    const wp::int32 var_26 = 1;
    wp::float32 var_27;
    const wp::int32 var_28 = 4;
    wp::int32 var_29;
    wp::int32 var_30;
    wp::float32* var_31;
    wp::float32 var_32;
    wp::float32 var_33;
    wp::float32 var_34;
    const wp::float32 var_35 = 0.0;
    wp::float32 var_36;
    const wp::int32 var_37 = 2;
    wp::int32 var_38;
    wp::int32 var_39;
    wp::float32* var_40;
    const wp::int32 var_41 = 2;
    wp::float32 var_42;
    wp::float32 var_43;
    wp::float32 var_44;
    const wp::int32 var_45 = 2;
    wp::float32 var_46;
    const wp::int32 var_47 = 5;
    wp::int32 var_48;
    wp::int32 var_49;
    wp::float32* var_50;
    wp::float32 var_51;
    wp::float32 var_52;
    wp::float32 var_53;
    const wp::float32 var_54 = 0.0;
    wp::float32 var_55;
    wp::float32 var_56;
    wp::float32 var_57;
    wp::float32 var_58;
    wp::float32 var_59;
    wp::float32 var_60;
    //---------
    // forward
    // def measure_box(boxes: array(dtype=float32), node: int, child: int, a: vec3, b: vec3) -> float:       <L 402>
    // at = node * SIDES + child                                                              <L 403>
    var_1 = wp::mul(var_node, var_0);
    var_2 = wp::add(var_1, var_child);
    // x = larger(larger(boxes[at] - b[0], a[0] - boxes[at + 3 * FAN]), 0.0)                  <L 404>
    var_3 = wp::address(var_boxes, var_2);
    var_5 = wp::extract(var_b, var_4);
    var_7 = wp::load(var_3);
    var_6 = wp::sub(var_7, var_5);
    var_9 = wp::extract(var_a, var_8);
    var_12 = wp::mul(var_10, var_11);
    var_13 = wp::add(var_2, var_12);
    var_14 = wp::address(var_boxes, var_13);
    var_16 = wp::load(var_14);
    var_15 = wp::sub(var_9, var_16);
    var_17 = larger_0(var_6, var_15);
    var_19 = larger_0(var_17, var_18);
    // y = larger(larger(boxes[at + FAN] - b[1], a[1] - boxes[at + 4 * FAN]), 0.0)            <L 405>
    var_20 = wp::add(var_2, var_11);
    var_21 = wp::address(var_boxes, var_20);
    var_23 = wp::extract(var_b, var_22);
    var_25 = wp::load(var_21);
    var_24 = wp::sub(var_25, var_23);
    var_27 = wp::extract(var_a, var_26);
    var_29 = wp::mul(var_28, var_11);
    var_30 = wp::add(var_2, var_29);
    var_31 = wp::address(var_boxes, var_30);
    var_33 = wp::load(var_31);
    var_32 = wp::sub(var_27, var_33);
    var_34 = larger_0(var_24, var_32);
    var_36 = larger_0(var_34, var_35);
    // z = larger(larger(boxes[at + 2 * FAN] - b[2], a[2] - boxes[at + 5 * FAN]), 0.0)        <L 406>
    var_38 = wp::mul(var_37, var_11);
    var_39 = wp::add(var_2, var_38);
    var_40 = wp::address(var_boxes, var_39);
    var_42 = wp::extract(var_b, var_41);
    var_44 = wp::load(var_40);
    var_43 = wp::sub(var_44, var_42);
    var_46 = wp::extract(var_a, var_45);
    var_48 = wp::mul(var_47, var_11);
    var_49 = wp::add(var_2, var_48);
    var_50 = wp::address(var_boxes, var_49);
    var_52 = wp::load(var_50);
    var_51 = wp::sub(var_46, var_52);
    var_53 = larger_0(var_43, var_51);
    var_55 = larger_0(var_53, var_54);
    // return x * x + y * y + z * z                                                           <L 407>
    var_56 = wp::mul(var_19, var_19);
    var_57 = wp::mul(var_36, var_36);
    var_58 = wp::add(var_56, var_57);
    var_59 = wp::mul(var_55, var_55);
    var_60 = wp::add(var_58, var_59);
    return var_60;
}


// <pointloom.kernels.search.point_tree.is_one_point>:1
static CUDA_CALLABLE wp::int32 is_one_point_0(
    wp::array_t<wp::float32> var_boxes,
    wp::int32 var_node,
    wp::int32 var_child)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 48;
    wp::int32 var_1;
    wp::int32 var_2;
    const wp::int32 var_3 = 1;
    wp::int32 var_4;
    const wp::int32 var_5 = 0;
    const wp::int32 var_6 = 8;
    wp::int32 var_7;
    wp::int32 var_8;
    wp::float32* var_9;
    const wp::int32 var_10 = 3;
    wp::int32 var_11;
    wp::int32 var_12;
    wp::int32 var_13;
    wp::float32* var_14;
    bool var_15;
    wp::float32 var_16;
    wp::float32 var_17;
    const wp::int32 var_18 = 0;
    wp::int32 var_19;
    const wp::int32 var_20 = 1;
    wp::int32 var_21;
    wp::int32 var_22;
    wp::float32* var_23;
    const wp::int32 var_24 = 3;
    wp::int32 var_25;
    wp::int32 var_26;
    wp::int32 var_27;
    wp::float32* var_28;
    bool var_29;
    wp::float32 var_30;
    wp::float32 var_31;
    const wp::int32 var_32 = 0;
    wp::int32 var_33;
    const wp::int32 var_34 = 2;
    wp::int32 var_35;
    wp::int32 var_36;
    wp::float32* var_37;
    const wp::int32 var_38 = 3;
    wp::int32 var_39;
    wp::int32 var_40;
    wp::int32 var_41;
    wp::float32* var_42;
    bool var_43;
    wp::float32 var_44;
    wp::float32 var_45;
    const wp::int32 var_46 = 0;
    wp::int32 var_47;
    //---------
    // forward
    // def is_one_point(boxes, node, child):                                                  <L 1>
    // at = node * SIDES + child                                                              <L 2>
    var_1 = wp::mul(var_node, var_0);
    var_2 = wp::add(var_1, var_child);
    // equal = int(1)                                                                         <L 3>
    var_4 = wp::int(var_3);
    // for axis in range(3):                                                                  <L 4>
    // if boxes[at + axis * FAN] != boxes[at + (axis + 3) * FAN]:                             <L 5>
    var_7 = wp::mul(var_5, var_6);
    var_8 = wp::add(var_2, var_7);
    var_9 = wp::address(var_boxes, var_8);
    var_11 = wp::add(var_5, var_10);
    var_12 = wp::mul(var_11, var_6);
    var_13 = wp::add(var_2, var_12);
    var_14 = wp::address(var_boxes, var_13);
    var_16 = wp::load(var_9);
    var_17 = wp::load(var_14);
    var_15 = (var_16 != var_17);
    if (var_15) {
        // equal = 0                                                                          <L 6>
    }
    var_19 = wp::where(var_15, var_18, var_4);
    // if boxes[at + axis * FAN] != boxes[at + (axis + 3) * FAN]:                             <L 5>
    var_21 = wp::mul(var_20, var_6);
    var_22 = wp::add(var_2, var_21);
    var_23 = wp::address(var_boxes, var_22);
    var_25 = wp::add(var_20, var_24);
    var_26 = wp::mul(var_25, var_6);
    var_27 = wp::add(var_2, var_26);
    var_28 = wp::address(var_boxes, var_27);
    var_30 = wp::load(var_23);
    var_31 = wp::load(var_28);
    var_29 = (var_30 != var_31);
    if (var_29) {
        // equal = 0                                                                          <L 6>
    }
    var_33 = wp::where(var_29, var_32, var_19);
    // if boxes[at + axis * FAN] != boxes[at + (axis + 3) * FAN]:                             <L 5>
    var_35 = wp::mul(var_34, var_6);
    var_36 = wp::add(var_2, var_35);
    var_37 = wp::address(var_boxes, var_36);
    var_39 = wp::add(var_34, var_38);
    var_40 = wp::mul(var_39, var_6);
    var_41 = wp::add(var_2, var_40);
    var_42 = wp::address(var_boxes, var_41);
    var_44 = wp::load(var_37);
    var_45 = wp::load(var_42);
    var_43 = (var_44 != var_45);
    if (var_43) {
        // equal = 0                                                                          <L 6>
    }
    var_47 = wp::where(var_43, var_46, var_33);
    // return equal                                                                           <L 7>
    return var_47;
}


// /work/main/src/pointloom/kernels/search/point_tree.py:379
static CUDA_CALLABLE wp::float32 square_distance_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> var_q)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    const wp::int32 var_2 = 0;
    wp::float32 var_3;
    wp::float32 var_4;
    const wp::int32 var_5 = 1;
    wp::float32 var_6;
    const wp::int32 var_7 = 1;
    wp::float32 var_8;
    wp::float32 var_9;
    const wp::int32 var_10 = 2;
    wp::float32 var_11;
    const wp::int32 var_12 = 2;
    wp::float32 var_13;
    wp::float32 var_14;
    wp::float32 var_15;
    wp::float32 var_16;
    wp::float32 var_17;
    wp::float32 var_18;
    wp::float32 var_19;
    //---------
    // forward
    // def square_distance(p: vec3, q: vec3) -> float:                                        <L 380>
    // x = q[0] - p[0]                                                                        <L 382>
    var_1 = wp::extract(var_q, var_0);
    var_3 = wp::extract(var_p, var_2);
    var_4 = wp::sub(var_1, var_3);
    // y = q[1] - p[1]                                                                        <L 383>
    var_6 = wp::extract(var_q, var_5);
    var_8 = wp::extract(var_p, var_7);
    var_9 = wp::sub(var_6, var_8);
    // z = q[2] - p[2]                                                                        <L 384>
    var_11 = wp::extract(var_q, var_10);
    var_13 = wp::extract(var_p, var_12);
    var_14 = wp::sub(var_11, var_13);
    // return x * x + y * y + z * z                                                           <L 385>
    var_15 = wp::mul(var_4, var_4);
    var_16 = wp::mul(var_9, var_9);
    var_17 = wp::add(var_15, var_16);
    var_18 = wp::mul(var_14, var_14);
    var_19 = wp::add(var_17, var_18);
    return var_19;
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


// /work/main/src/pointloom/kernels/search/bucket_walk.py:35
static CUDA_CALLABLE wp::int64 byte_shift_0(
    wp::int32 var_level)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 8;
    const wp::int32 var_1 = 1;
    wp::int32 var_2;
    const wp::int32 var_3 = 0;
    wp::int32 var_4;
    wp::int32 var_5;
    wp::int64 var_6;
    //---------
    // forward
    // def byte_shift(level: int) -> int64:                                                   <L 36>
    // return int64(FAN * max(level - 1, 0))                                                  <L 38>
    var_2 = wp::sub(var_level, var_1);
    var_4 = wp::max(var_2, var_3);
    var_5 = wp::mul(var_0, var_4);
    var_6 = wp::int64(var_5);
    return var_6;
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


// <pointloom.kernels.search.bucket_walk.pass_over_equal_one_by_one>:1
static CUDA_CALLABLE wp::vec_t<4, wp::int64> pass_over_equal_one_by_one_on_cuda_0(
    wp::vec_t<4, wp::int64> var_step,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::int64 var_limit,
    wp::array_t<wp::int32> var_tree__levels,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::array_t<wp::int32> var_labels)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 3;
    wp::int64 var_1;
    const wp::int32 var_2 = 2;
    wp::int64 var_3;
    wp::int32 var_4;
    const wp::int32 var_5 = 1;
    wp::int32 var_6;
    const wp::int32 var_7 = 8;
    wp::int32 var_8;
    const wp::int32 var_9 = 0;
    wp::int64 var_10;
    wp::int32 var_11;
    wp::range_t var_12;
    wp::int32 var_13;
    wp::int32 var_14;
    const wp::int32 var_15 = 1;
    wp::int32 var_16;
    wp::int64 var_17;
    wp::int64 var_18;
    wp::int32 var_19;
    const wp::int32 var_20 = 255;
    wp::int32 var_21;
    const wp::int32 var_22 = 1;
    wp::int32 var_23;
    wp::int32* var_24;
    wp::int32 var_25;
    wp::int32 var_26;
    wp::range_t var_27;
    wp::int32 var_28;
    wp::int32 var_29;
    const wp::int32 var_30 = 1;
    wp::int32 var_31;
    const wp::int32 var_32 = 1;
    bool var_33;
    wp::int32 var_34;
    wp::int32 var_35;
    wp::int32 var_36;
    const wp::int32 var_37 = 64;
    wp::int32 var_38;
    bool var_39;
    wp::int32 var_40;
    const wp::int32 var_41 = 1;
    bool var_42;
    wp::shape_t* var_43;
    const wp::int32 var_44 = 0;
    wp::int32 var_45;
    wp::shape_t var_46;
    bool var_47;
    wp::float32 var_48;
    wp::int32* var_49;
    wp::int64 var_50;
    wp::int32 var_51;
    bool var_52;
    const wp::int32 var_53 = 1;
    wp::int32 var_54;
    wp::int64 var_55;
    const wp::int32 var_56 = 1;
    wp::int32 var_57;
    wp::int64 var_58;
    wp::int64 var_59;
    wp::int64 var_60;
    wp::int64 var_61;
    wp::int64 var_62;
    wp::int64 var_63;
    wp::int32 var_64;
    const wp::int32 var_65 = 0;
    wp::int64 var_66;
    const wp::int32 var_67 = 1;
    wp::int64 var_68;
    const wp::int32 var_69 = 2;
    wp::int64 var_70;
    wp::vec_t<4, wp::int64> var_71;
    //---------
    // forward
    // def pass_over_equal_one_by_one(step, a, b, limit, tree__levels, tree__boxes, labels):       <L 1>
    // pending = step[3]                                                                      <L 2>
    var_1 = wp::extract(var_step, var_0);
    // node = int(step[2])                                                                    <L 3>
    var_3 = wp::extract(var_step, var_2);
    var_4 = wp::int(var_3);
    // buckets = int(1)                                                                       <L 4>
    var_6 = wp::int(var_5);
    // children = int(FAN)                                                                    <L 5>
    var_8 = wp::int(var_7);
    // for above in range(int(step[0])):                                                      <L 6>
    var_10 = wp::extract(var_step, var_9);
    var_11 = wp::int(var_10);
    var_12 = wp::range(var_11);
    start_for_0:;
        if (iter_cmp(var_12) == 0) goto end_for_0;
        var_13 = wp::iter_next(var_12);
        // node = node // FAN                                                                 <L 7>
        var_14 = wp::floordiv(var_4, var_7);
        // left = int(pending >> byte_shift(above + 1)) & BYTE                                <L 8>
        var_16 = wp::add(var_13, var_15);
        var_17 = byte_shift_0(var_16);
        var_18 = wp::rshift(var_1, var_17);
        var_19 = wp::int(var_18);
        var_21 = wp::bit_and(var_19, var_20);
        // record = tree__levels[above + 1] + node                                            <L 9>
        var_23 = wp::add(var_13, var_22);
        var_24 = wp::address(var_tree__levels, var_23);
        var_26 = wp::load(var_24);
        var_25 = wp::add(var_26, var_14);
        // for j in range(children):                                                          <L 10>
        var_27 = wp::range(var_8);
        start_for_2:;
            if (iter_cmp(var_27) == 0) goto end_for_2;
            var_28 = wp::iter_next(var_27);
            // if left >> j & 1 == 1:                                                         <L 11>
            var_29 = wp::rshift(var_21, var_28);
            var_31 = wp::bit_and(var_29, var_30);
            var_33 = (var_31 == var_32);
            if (var_33) {
                // first = (node * FAN + j) * buckets * BUCKET                                <L 12>
                var_34 = wp::mul(var_14, var_7);
                var_35 = wp::add(var_34, var_28);
                var_36 = wp::mul(var_35, var_6);
                var_38 = wp::mul(var_36, var_37);
                // if is_one_point(tree__boxes, record, j) == 1 and first < labels.shape[0]:       <L 13>
                var_40 = is_one_point_0(var_tree__boxes, var_25, var_28);
                var_42 = (var_40 == var_41);
                var_39 = var_42;
                if (var_39) {
                    var_43 = &(var_labels.shape);
                    var_46 = wp::load(var_43);
                    var_45 = wp::extract(var_46, var_44);
                    var_47 = (var_38 < var_45);
                    var_39 = var_39 && var_47;
                }
                if (var_39) {
                    // if pack_key(measure_box(tree__boxes, record, j, a, b), labels[first]) > limit:       <L 14>
                    var_48 = measure_box_0(var_tree__boxes, var_25, var_28, var_a, var_b);
                    var_49 = wp::address(var_labels, var_38);
                    var_51 = wp::load(var_49);
                    var_50 = pack_key_0(var_48, var_51);
                    var_52 = (var_50 > var_limit);
                    if (var_52) {
                        // pending = pending ^ int64(1 << j) << byte_shift(above + 1)         <L 15>
                        var_54 = wp::lshift(var_53, var_28);
                        var_55 = wp::int64(var_54);
                        var_57 = wp::add(var_13, var_56);
                        var_58 = byte_shift_0(var_57);
                        var_59 = wp::lshift(var_55, var_58);
                        var_60 = wp::bit_xor(var_1, var_59);
                    }
                    var_61 = wp::where(var_52, var_60, var_1);
                }
                var_62 = wp::where(var_39, var_61, var_1);
            }
            var_63 = wp::where(var_33, var_62, var_1);
            wp::assign(var_1, var_63);
            goto start_for_2;
        end_for_2:;
        // buckets = buckets * FAN                                                            <L 16>
        var_64 = wp::mul(var_6, var_7);
        wp::assign(var_4, var_14);
        wp::assign(var_6, var_64);
        goto start_for_0;
    end_for_0:;
    // return traversal(step[0], step[1], step[2], pending)                                   <L 17>
    var_66 = wp::extract(var_step, var_65);
    var_68 = wp::extract(var_step, var_67);
    var_70 = wp::extract(var_step, var_69);
    var_71 = wp::vec_t<4, wp::int64>(var_66, var_68, var_70, var_1);
    return var_71;
}


// <pointloom.kernels.search.bucket_walk.children_within>:1
static CUDA_CALLABLE wp::int32 children_within_0(
    wp::array_t<wp::float32> var_boxes,
    wp::int32 var_node,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::float32 var_bound)
{
    //---------
    // primal vars
    wp::vec_t<8, wp::float32> var_0;
    const wp::int32 var_1 = 0;
    wp::int32 var_2;
    const wp::int32 var_3 = 0;
    wp::float32 var_4;
    bool var_5;
    const wp::int32 var_6 = 1;
    wp::int32 var_7;
    wp::int32 var_8;
    wp::int32 var_9;
    const wp::int32 var_10 = 1;
    wp::float32 var_11;
    bool var_12;
    const wp::int32 var_13 = 1;
    wp::int32 var_14;
    wp::int32 var_15;
    wp::int32 var_16;
    const wp::int32 var_17 = 2;
    wp::float32 var_18;
    bool var_19;
    const wp::int32 var_20 = 1;
    wp::int32 var_21;
    wp::int32 var_22;
    wp::int32 var_23;
    const wp::int32 var_24 = 3;
    wp::float32 var_25;
    bool var_26;
    const wp::int32 var_27 = 1;
    wp::int32 var_28;
    wp::int32 var_29;
    wp::int32 var_30;
    const wp::int32 var_31 = 4;
    wp::float32 var_32;
    bool var_33;
    const wp::int32 var_34 = 1;
    wp::int32 var_35;
    wp::int32 var_36;
    wp::int32 var_37;
    const wp::int32 var_38 = 5;
    wp::float32 var_39;
    bool var_40;
    const wp::int32 var_41 = 1;
    wp::int32 var_42;
    wp::int32 var_43;
    wp::int32 var_44;
    const wp::int32 var_45 = 6;
    wp::float32 var_46;
    bool var_47;
    const wp::int32 var_48 = 1;
    wp::int32 var_49;
    wp::int32 var_50;
    wp::int32 var_51;
    const wp::int32 var_52 = 7;
    wp::float32 var_53;
    bool var_54;
    const wp::int32 var_55 = 1;
    wp::int32 var_56;
    wp::int32 var_57;
    wp::int32 var_58;
    //---------
    // forward
    // def children_within(boxes, node, a, b, bound):                                         <L 1>
    // distances = measure_boxes(boxes, node, a, b)                                           <L 3>
    var_0 = measure_boxes_0(var_boxes, var_node, var_a, var_b);
    // bits = int(0)                                                                          <L 4>
    var_2 = wp::int(var_1);
    // for j in range(FAN):                                                                   <L 5>
    // if distances[j] <= bound:                                                              <L 6>
    var_4 = wp::extract(var_0, var_3);
    var_5 = (var_4 <= var_bound);
    if (var_5) {
        // bits = bits | 1 << j                                                               <L 7>
        var_7 = wp::lshift(var_6, var_3);
        var_8 = wp::bit_or(var_2, var_7);
    }
    var_9 = wp::where(var_5, var_8, var_2);
    // if distances[j] <= bound:                                                              <L 6>
    var_11 = wp::extract(var_0, var_10);
    var_12 = (var_11 <= var_bound);
    if (var_12) {
        // bits = bits | 1 << j                                                               <L 7>
        var_14 = wp::lshift(var_13, var_10);
        var_15 = wp::bit_or(var_9, var_14);
    }
    var_16 = wp::where(var_12, var_15, var_9);
    // if distances[j] <= bound:                                                              <L 6>
    var_18 = wp::extract(var_0, var_17);
    var_19 = (var_18 <= var_bound);
    if (var_19) {
        // bits = bits | 1 << j                                                               <L 7>
        var_21 = wp::lshift(var_20, var_17);
        var_22 = wp::bit_or(var_16, var_21);
    }
    var_23 = wp::where(var_19, var_22, var_16);
    // if distances[j] <= bound:                                                              <L 6>
    var_25 = wp::extract(var_0, var_24);
    var_26 = (var_25 <= var_bound);
    if (var_26) {
        // bits = bits | 1 << j                                                               <L 7>
        var_28 = wp::lshift(var_27, var_24);
        var_29 = wp::bit_or(var_23, var_28);
    }
    var_30 = wp::where(var_26, var_29, var_23);
    // if distances[j] <= bound:                                                              <L 6>
    var_32 = wp::extract(var_0, var_31);
    var_33 = (var_32 <= var_bound);
    if (var_33) {
        // bits = bits | 1 << j                                                               <L 7>
        var_35 = wp::lshift(var_34, var_31);
        var_36 = wp::bit_or(var_30, var_35);
    }
    var_37 = wp::where(var_33, var_36, var_30);
    // if distances[j] <= bound:                                                              <L 6>
    var_39 = wp::extract(var_0, var_38);
    var_40 = (var_39 <= var_bound);
    if (var_40) {
        // bits = bits | 1 << j                                                               <L 7>
        var_42 = wp::lshift(var_41, var_38);
        var_43 = wp::bit_or(var_37, var_42);
    }
    var_44 = wp::where(var_40, var_43, var_37);
    // if distances[j] <= bound:                                                              <L 6>
    var_46 = wp::extract(var_0, var_45);
    var_47 = (var_46 <= var_bound);
    if (var_47) {
        // bits = bits | 1 << j                                                               <L 7>
        var_49 = wp::lshift(var_48, var_45);
        var_50 = wp::bit_or(var_44, var_49);
    }
    var_51 = wp::where(var_47, var_50, var_44);
    // if distances[j] <= bound:                                                              <L 6>
    var_53 = wp::extract(var_0, var_52);
    var_54 = (var_53 <= var_bound);
    if (var_54) {
        // bits = bits | 1 << j                                                               <L 7>
        var_56 = wp::lshift(var_55, var_52);
        var_57 = wp::bit_or(var_51, var_56);
    }
    var_58 = wp::where(var_54, var_57, var_51);
    // return bits                                                                            <L 8>
    return var_58;
}


// /work/main/src/pointloom/kernels/search/bucket_walk.py:86
static CUDA_CALLABLE wp::int32 level_children_within_0(
    wp::array_t<wp::int32> var_levels,
    wp::int32 var_first,
    wp::array_t<wp::float32> var_boxes,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::float32 var_bound,
    wp::int32 var_level,
    wp::int32 var_node)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32* var_1;
    wp::int32 var_2;
    wp::int32 var_3;
    wp::int32 var_4;
    //---------
    // forward
    // def level_children_within(                                                             <L 87>
    // return children_within(boxes, levels[first + level] + node, a, b, bound)               <L 98>
    var_0 = wp::add(var_first, var_level);
    var_1 = wp::address(var_levels, var_0);
    var_3 = wp::load(var_1);
    var_2 = wp::add(var_3, var_node);
    var_4 = children_within_0(var_boxes, var_2, var_a, var_b, var_bound);
    return var_4;
}


// <pointloom.kernels.search.bucket_walk.next_step__level_children_within>:1
static CUDA_CALLABLE wp::vec_t<4, wp::int64> next_step__level_children_within_0(
    wp::vec_t<4, wp::int64> var_step,
    wp::int32 var_root,
    wp::array_t<wp::int32> var_children__levels,
    wp::int32 var_children__first,
    wp::array_t<wp::float32> var_children__boxes,
    wp::vec_t<3, wp::float32> var_children__a,
    wp::vec_t<3, wp::float32> var_children__b,
    wp::float32 var_children__bound)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int64 var_1;
    wp::int32 var_2;
    const wp::int32 var_3 = 1;
    wp::int64 var_4;
    wp::int32 var_5;
    const wp::int32 var_6 = 2;
    wp::int64 var_7;
    wp::int32 var_8;
    const wp::int32 var_9 = 3;
    wp::int64 var_10;
    bool var_11;
    const wp::int32 var_12 = 0;
    bool var_13;
    const wp::int32 var_14 = 0;
    bool var_15;
    const wp::int32 var_16 = 1;
    const wp::int32 var_17 = 8;
    wp::int32 var_18;
    wp::int32 var_19;
    wp::int32 var_20;
    const wp::int32 var_21 = 1;
    wp::int32 var_22;
    const wp::int32 var_23 = 1;
    bool var_24;
    wp::int64 var_25;
    wp::int64 var_26;
    wp::int32 var_27;
    const wp::int32 var_28 = 255;
    wp::int32 var_29;
    const wp::int32 var_30 = 0;
    bool var_31;
    wp::int32 var_32;
    wp::int32 var_33;
    wp::int64 var_34;
    wp::int64 var_35;
    wp::int64 var_36;
    wp::int64 var_37;
    wp::int32 var_38;
    const wp::int32 var_39 = 1;
    wp::int32 var_40;
    wp::int32 var_41;
    wp::int32 var_42;
    const wp::int32 var_43 = 1;
    wp::int32 var_44;
    const wp::int32 var_45 = 0;
    bool var_46;
    const wp::int32 var_47 = 0;
    wp::int32 var_48;
    wp::int64 var_49;
    wp::int64 var_50;
    wp::int64 var_51;
    wp::int64 var_52;
    wp::int64 var_53;
    wp::int32 var_54;
    bool var_55;
    const wp::int32 var_56 = 1;
    wp::int32 var_57;
    bool var_58;
    const wp::int32 var_59 = 0;
    const wp::int32 var_60 = 1;
    wp::int32 var_61;
    wp::int32 var_62;
    wp::int32 var_63;
    const wp::int32 var_64 = 1;
    wp::int32 var_65;
    wp::int32 var_66;
    wp::int32 var_67;
    wp::int32 var_68;
    wp::int64 var_69;
    wp::int64 var_70;
    wp::int64 var_71;
    wp::int64 var_72;
    wp::int32 var_73;
    wp::int32 var_74;
    wp::int64 var_75;
    wp::int32 var_76;
    wp::int32 var_77;
    const wp::int32 var_78 = 1;
    wp::int32 var_79;
    wp::int32 var_80;
    wp::int32 var_81;
    wp::int32 var_82;
    wp::int64 var_83;
    wp::int32 var_84;
    wp::int32 var_85;
    wp::int32 var_86;
    wp::int32 var_87;
    wp::int64 var_88;
    wp::int32 var_89;
    wp::int64 var_90;
    wp::int64 var_91;
    wp::int64 var_92;
    wp::vec_t<4, wp::int64> var_93;
    //---------
    // forward
    // def next_step__level_children_within(step, root, children__levels, children__first, children__boxes, children__a, children__b, children__bound):       <L 1>
    // height = int(step[0])                                                                  <L 3>
    var_1 = wp::extract(var_step, var_0);
    var_2 = wp::int(var_1);
    // level = int(step[1])                                                                   <L 4>
    var_4 = wp::extract(var_step, var_3);
    var_5 = wp::int(var_4);
    // node = int(step[2])                                                                    <L 5>
    var_7 = wp::extract(var_step, var_6);
    var_8 = wp::int(var_7);
    // pending = step[3]                                                                      <L 6>
    var_10 = wp::extract(var_step, var_9);
    // if level == 0 and height > 0:                                                          <L 7>
    var_13 = (var_5 == var_12);
    var_11 = var_13;
    if (var_11) {
        var_15 = (var_2 > var_14);
        var_11 = var_11 && var_15;
    }
    if (var_11) {
        // level = 1                                                                          <L 8>
        // node = node // FAN                                                                 <L 9>
        var_18 = wp::floordiv(var_8, var_17);
    }
    var_19 = wp::where(var_11, var_16, var_5);
    var_20 = wp::where(var_11, var_18, var_8);
    // searching = int(1)                                                                     <L 10>
    var_22 = wp::int(var_21);
    // while searching == 1:                                                                  <L 11>
    start_while_0:;
    var_24 = (var_22 == var_23);
    if ((var_24) == false) goto end_while_0;
        // left = int(pending >> byte_shift(level)) & BYTE                                    <L 12>
        var_25 = byte_shift_0(var_19);
        var_26 = wp::rshift(var_10, var_25);
        var_27 = wp::int(var_26);
        var_29 = wp::bit_and(var_27, var_28);
        // if left != 0:                                                                      <L 13>
        var_31 = (var_29 != var_30);
        if (var_31) {
            // lowest = left & -left                                                          <L 14>
            var_32 = wp::neg(var_29);
            var_33 = wp::bit_and(var_29, var_32);
            // pending = pending ^ int64(lowest) << byte_shift(level)                         <L 15>
            var_34 = wp::int64(var_33);
            var_35 = byte_shift_0(var_19);
            var_36 = wp::lshift(var_34, var_35);
            var_37 = wp::bit_xor(var_10, var_36);
            // node = node * FAN + bit_count(lowest - 1)                                      <L 16>
            var_38 = wp::mul(var_20, var_17);
            var_40 = wp::sub(var_33, var_39);
            var_41 = wp::bit_count(var_40);
            var_42 = wp::add(var_38, var_41);
            // level = level - 1                                                              <L 17>
            var_44 = wp::sub(var_19, var_43);
            // if level == 0:                                                                 <L 18>
            var_46 = (var_44 == var_45);
            if (var_46) {
                // searching = 0                                                              <L 19>
            }
            if (!var_46) {
                // inside = children__call(children__levels, children__first, children__boxes, children__a, children__b, children__bound, level, node)       <L 21>
                var_48 = level_children_within_0(var_children__levels, var_children__first, var_children__boxes, var_children__a, var_children__b, var_children__bound, var_44, var_42);
                // pending = pending | int64(inside) << byte_shift(level)                     <L 22>
                var_49 = wp::int64(var_48);
                var_50 = byte_shift_0(var_44);
                var_51 = wp::lshift(var_49, var_50);
                var_52 = wp::bit_or(var_37, var_51);
            }
            var_53 = wp::where(var_46, var_37, var_52);
            var_54 = wp::where(var_46, var_47, var_22);
        }
        if (!var_31) {
            // elif level == height:                                                          <L 23>
            var_55 = (var_19 == var_2);
            if (var_55) {
                // height = height + 1                                                        <L 24>
                var_57 = wp::add(var_2, var_56);
                // if height > root:                                                          <L 25>
                var_58 = (var_57 > var_root);
                if (var_58) {
                    // searching = 0                                                          <L 26>
                }
                if (!var_58) {
                    // own = 1 << node % FAN                                                  <L 28>
                    var_61 = wp::mod(var_20, var_17);
                    var_62 = wp::lshift(var_60, var_61);
                    // node = node // FAN                                                     <L 29>
                    var_63 = wp::floordiv(var_20, var_17);
                    // level = level + 1                                                      <L 30>
                    var_65 = wp::add(var_19, var_64);
                    // others = children__call(children__levels, children__first, children__boxes, children__a, children__b, children__bound, level, node) & BYTE - own       <L 31>
                    var_66 = level_children_within_0(var_children__levels, var_children__first, var_children__boxes, var_children__a, var_children__b, var_children__bound, var_65, var_63);
                    var_67 = wp::sub(var_28, var_62);
                    var_68 = wp::bit_and(var_66, var_67);
                    // pending = pending | int64(others) << byte_shift(level)                 <L 32>
                    var_69 = wp::int64(var_68);
                    var_70 = byte_shift_0(var_65);
                    var_71 = wp::lshift(var_69, var_70);
                    var_72 = wp::bit_or(var_10, var_71);
                }
                var_73 = wp::where(var_58, var_19, var_65);
                var_74 = wp::where(var_58, var_20, var_63);
                var_75 = wp::where(var_58, var_10, var_72);
                var_76 = wp::where(var_58, var_59, var_22);
            }
            if (!var_55) {
                // node = node // FAN                                                         <L 34>
                var_77 = wp::floordiv(var_20, var_17);
                // level = level + 1                                                          <L 35>
                var_79 = wp::add(var_19, var_78);
            }
            var_80 = wp::where(var_55, var_57, var_2);
            var_81 = wp::where(var_55, var_73, var_79);
            var_82 = wp::where(var_55, var_74, var_77);
            var_83 = wp::where(var_55, var_75, var_10);
            var_84 = wp::where(var_55, var_76, var_22);
        }
        var_85 = wp::where(var_31, var_2, var_80);
        var_86 = wp::where(var_31, var_44, var_81);
        var_87 = wp::where(var_31, var_42, var_82);
        var_88 = wp::where(var_31, var_53, var_83);
        var_89 = wp::where(var_31, var_54, var_84);
        wp::assign(var_2, var_85);
        wp::assign(var_19, var_86);
        wp::assign(var_20, var_87);
        wp::assign(var_10, var_88);
        wp::assign(var_22, var_89);
    goto start_while_0;
    end_while_0:;
    // return traversal(int64(height), int64(level), int64(node), pending)                    <L 36>
    var_90 = wp::int64(var_2);
    var_91 = wp::int64(var_19);
    var_92 = wp::int64(var_20);
    var_93 = wp::vec_t<4, wp::int64>(var_90, var_91, var_92, var_10);
    return var_93;
}


// <pointloom.kernels.search.bucket_walk.next_bucket>:1
static CUDA_CALLABLE wp::vec_t<4, wp::int64> next_bucket_0(
    wp::vec_t<4, wp::int64> var_step,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::float32 var_bound,
    wp::int32 var_tree__root,
    wp::array_t<wp::int32> var_tree__levels,
    wp::array_t<wp::float32> var_tree__boxes)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::vec_t<4, wp::int64> var_1;
    //---------
    // forward
    // def next_bucket(step, a, b, bound, tree__root, tree__levels, tree__boxes):             <L 1>
    // return next_step__level_children_within(step, tree__root, tree__levels, 0, tree__boxes, a, b, bound)       <L 3>
    var_1 = next_step__level_children_within_0(var_step, var_tree__root, var_tree__levels, var_0, var_tree__boxes, var_a, var_b, var_bound);
    return var_1;
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:143
static CUDA_CALLABLE void adj__float_bits_0(
    wp::float32 var_x,
    wp::float32 & adj_x,
    wp::int32 & adj_ret)
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


// <pointloom.kernels.search.hilbert_order.locate_on_curve>:1
static CUDA_CALLABLE void adj_locate_on_curve_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> var_curve__low,
    wp::float32 var_curve__scale,
    wp::int32 var_curve__levels,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float32> & adj_curve__low,
    wp::float32 & adj_curve__scale,
    wp::int32 & adj_curve__levels,
    wp::int64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.point_tree.find_run>:1
static CUDA_CALLABLE void adj_find_run_0(
    wp::array_t<wp::int64> var_codes,
    wp::int32 var_first,
    wp::int32 var_count,
    wp::int64 var_code,
    wp::array_t<wp::int64> & adj_codes,
    wp::int32 & adj_first,
    wp::int32 & adj_count,
    wp::int64 & adj_code,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.point_tree.find_bucket>:1
static CUDA_CALLABLE void adj_find_bucket_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::int32 var_tree__count,
    wp::array_t<wp::int64> var_tree__codes,
    wp::vec_t<3, wp::float32> var_tree__curve__low,
    wp::float32 var_tree__curve__scale,
    wp::int32 var_tree__curve__levels,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::int32 & adj_tree__count,
    wp::array_t<wp::int64> & adj_tree__codes,
    wp::vec_t<3, wp::float32> & adj_tree__curve__low,
    wp::float32 & adj_tree__curve__scale,
    wp::int32 & adj_tree__curve__levels,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.bucket_walk.start_traversal>:1
static CUDA_CALLABLE void adj_start_traversal_0(
    wp::int32 var_bucket,
    wp::int32 & adj_bucket,
    wp::vec_t<4, wp::int64> & adj_ret)
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


// /work/main/src/pointloom/kernels/search/point_tree.py:388
static CUDA_CALLABLE void adj_measure_boxes_0(
    wp::array_t<wp::float32> var_boxes,
    wp::int32 var_node,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::array_t<wp::float32> & adj_boxes,
    wp::int32 & adj_node,
    wp::vec_t<3, wp::float32> & adj_a,
    wp::vec_t<3, wp::float32> & adj_b,
    wp::vec_t<8, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/search/point_tree.py:401
static CUDA_CALLABLE void adj_measure_box_0(
    wp::array_t<wp::float32> var_boxes,
    wp::int32 var_node,
    wp::int32 var_child,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::array_t<wp::float32> & adj_boxes,
    wp::int32 & adj_node,
    wp::int32 & adj_child,
    wp::vec_t<3, wp::float32> & adj_a,
    wp::vec_t<3, wp::float32> & adj_b,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.point_tree.is_one_point>:1
static CUDA_CALLABLE void adj_is_one_point_0(
    wp::array_t<wp::float32> var_boxes,
    wp::int32 var_node,
    wp::int32 var_child,
    wp::array_t<wp::float32> & adj_boxes,
    wp::int32 & adj_node,
    wp::int32 & adj_child,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/search/point_tree.py:379
static CUDA_CALLABLE void adj_square_distance_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> var_q,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float32> & adj_q,
    wp::float32 & adj_ret)
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


// /work/main/src/pointloom/kernels/search/bucket_walk.py:35
static CUDA_CALLABLE void adj_byte_shift_0(
    wp::int32 var_level,
    wp::int32 & adj_level,
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


// <pointloom.kernels.search.bucket_walk.pass_over_equal_one_by_one>:1
static CUDA_CALLABLE void adj_pass_over_equal_one_by_one_on_cuda_0(
    wp::vec_t<4, wp::int64> var_step,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::int64 var_limit,
    wp::array_t<wp::int32> var_tree__levels,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::array_t<wp::int32> var_labels,
    wp::vec_t<4, wp::int64> & adj_step,
    wp::vec_t<3, wp::float32> & adj_a,
    wp::vec_t<3, wp::float32> & adj_b,
    wp::int64 & adj_limit,
    wp::array_t<wp::int32> & adj_tree__levels,
    wp::array_t<wp::float32> & adj_tree__boxes,
    wp::array_t<wp::int32> & adj_labels,
    wp::vec_t<4, wp::int64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.bucket_walk.children_within>:1
static CUDA_CALLABLE void adj_children_within_0(
    wp::array_t<wp::float32> var_boxes,
    wp::int32 var_node,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::float32 var_bound,
    wp::array_t<wp::float32> & adj_boxes,
    wp::int32 & adj_node,
    wp::vec_t<3, wp::float32> & adj_a,
    wp::vec_t<3, wp::float32> & adj_b,
    wp::float32 & adj_bound,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/search/bucket_walk.py:86
static CUDA_CALLABLE void adj_level_children_within_0(
    wp::array_t<wp::int32> var_levels,
    wp::int32 var_first,
    wp::array_t<wp::float32> var_boxes,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::float32 var_bound,
    wp::int32 var_level,
    wp::int32 var_node,
    wp::array_t<wp::int32> & adj_levels,
    wp::int32 & adj_first,
    wp::array_t<wp::float32> & adj_boxes,
    wp::vec_t<3, wp::float32> & adj_a,
    wp::vec_t<3, wp::float32> & adj_b,
    wp::float32 & adj_bound,
    wp::int32 & adj_level,
    wp::int32 & adj_node,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.bucket_walk.next_step__level_children_within>:1
static CUDA_CALLABLE void adj_next_step__level_children_within_0(
    wp::vec_t<4, wp::int64> var_step,
    wp::int32 var_root,
    wp::array_t<wp::int32> var_children__levels,
    wp::int32 var_children__first,
    wp::array_t<wp::float32> var_children__boxes,
    wp::vec_t<3, wp::float32> var_children__a,
    wp::vec_t<3, wp::float32> var_children__b,
    wp::float32 var_children__bound,
    wp::vec_t<4, wp::int64> & adj_step,
    wp::int32 & adj_root,
    wp::array_t<wp::int32> & adj_children__levels,
    wp::int32 & adj_children__first,
    wp::array_t<wp::float32> & adj_children__boxes,
    wp::vec_t<3, wp::float32> & adj_children__a,
    wp::vec_t<3, wp::float32> & adj_children__b,
    wp::float32 & adj_children__bound,
    wp::vec_t<4, wp::int64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.bucket_walk.next_bucket>:1
static CUDA_CALLABLE void adj_next_bucket_0(
    wp::vec_t<4, wp::int64> var_step,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::float32 var_bound,
    wp::int32 var_tree__root,
    wp::array_t<wp::int32> var_tree__levels,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::vec_t<4, wp::int64> & adj_step,
    wp::vec_t<3, wp::float32> & adj_a,
    wp::vec_t<3, wp::float32> & adj_b,
    wp::float32 & adj_bound,
    wp::int32 & adj_tree__root,
    wp::array_t<wp::int32> & adj_tree__levels,
    wp::array_t<wp::float32> & adj_tree__boxes,
    wp::vec_t<4, wp::int64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void WP_MAXNREG(128) find_separately_kernel_fe0e6258_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_queries,
    wp::array_t<wp::int32> var_query_order,
    wp::int32 var_others,
    wp::int32 var_tree__count,
    wp::int32 var_tree__root,
    wp::array_t<wp::int32> var_tree__levels,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> var_tree__points,
    wp::array_t<wp::int32> var_tree__order,
    wp::array_t<wp::int64> var_tree__codes,
    wp::vec_t<3, wp::float32> var_tree__curve__low,
    wp::float32 var_tree__curve__scale,
    wp::int32 var_tree__curve__levels,
    wp::float32 var_max_sqdist,
    wp::array_t<wp::int64> var_nearest)
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
        wp::vec_t<3, wp::float32>* var_4;
        wp::vec_t<3, wp::float32> var_5;
        wp::vec_t<3, wp::float32> var_6;
        wp::int32 var_7;
        const wp::int32 var_8 = 1;
        wp::int32 var_9;
        wp::int32 var_10;
        wp::int32 var_11;
        bool var_12;
        const wp::int32 var_13 = 0;
        bool var_14;
        bool var_15;
        const wp::int32 var_16 = 1;
        bool var_17;
        const wp::int32 var_18 = -1;
        wp::int32 var_19;
        wp::int32 var_20;
        wp::vec_t<4, wp::int64> var_21;
        wp::float32 var_22;
        wp::float32 var_23;
        const wp::int32 var_24 = 0;
        wp::int64 var_25;
        wp::int32 var_26;
        bool var_27;
        const wp::int32 var_28 = 2;
        wp::int64 var_29;
        wp::int32 var_30;
        wp::vec_t<8, wp::float32> var_31;
        const wp::int32 var_32 = 0;
        wp::int32 var_33;
        const wp::int32 var_34 = 0;
        wp::float32 var_35;
        bool var_36;
        const wp::int32 var_37 = 1;
        const wp::int32 var_38 = 0;
        wp::int32 var_39;
        wp::int32 var_40;
        wp::int32 var_41;
        const wp::int32 var_42 = 1;
        wp::float32 var_43;
        bool var_44;
        const wp::int32 var_45 = 1;
        const wp::int32 var_46 = 0;
        wp::int32 var_47;
        wp::int32 var_48;
        wp::int32 var_49;
        const wp::int32 var_50 = 2;
        wp::float32 var_51;
        bool var_52;
        const wp::int32 var_53 = 1;
        const wp::int32 var_54 = 0;
        wp::int32 var_55;
        wp::int32 var_56;
        wp::int32 var_57;
        const wp::int32 var_58 = 3;
        wp::float32 var_59;
        bool var_60;
        const wp::int32 var_61 = 1;
        const wp::int32 var_62 = 0;
        wp::int32 var_63;
        wp::int32 var_64;
        wp::int32 var_65;
        const wp::int32 var_66 = 4;
        wp::float32 var_67;
        bool var_68;
        const wp::int32 var_69 = 1;
        const wp::int32 var_70 = 0;
        wp::int32 var_71;
        wp::int32 var_72;
        wp::int32 var_73;
        const wp::int32 var_74 = 5;
        wp::float32 var_75;
        bool var_76;
        const wp::int32 var_77 = 1;
        const wp::int32 var_78 = 0;
        wp::int32 var_79;
        wp::int32 var_80;
        wp::int32 var_81;
        const wp::int32 var_82 = 6;
        wp::float32 var_83;
        bool var_84;
        const wp::int32 var_85 = 1;
        const wp::int32 var_86 = 0;
        wp::int32 var_87;
        wp::int32 var_88;
        wp::int32 var_89;
        const wp::int32 var_90 = 7;
        wp::float32 var_91;
        bool var_92;
        const wp::int32 var_93 = 1;
        const wp::int32 var_94 = 0;
        wp::int32 var_95;
        wp::int32 var_96;
        wp::int32 var_97;
        const wp::int32 var_98 = 0;
        wp::int32 var_99;
        wp::int32 var_100;
        const wp::int32 var_101 = 0;
        bool var_102;
        wp::int32 var_103;
        wp::int32 var_104;
        wp::int32 var_105;
        const wp::int32 var_106 = 1;
        wp::int32 var_107;
        wp::int32 var_108;
        const wp::int32 var_109 = 64;
        wp::int32 var_110;
        const wp::int32 var_111 = 8;
        wp::int32 var_112;
        wp::int32 var_113;
        wp::float32 var_114;
        wp::int32 var_115;
        wp::int32 var_116;
        bool var_117;
        const wp::int32 var_118 = 1;
        const wp::int32 var_119 = 0;
        wp::int32 var_120;
        bool var_121;
        const wp::int32 var_122 = 1;
        bool var_123;
        bool var_124;
        bool var_125;
        wp::int32 var_126;
        const wp::int32 var_127 = 1;
        bool var_128;
        wp::int32* var_129;
        bool var_130;
        wp::int32 var_131;
        const wp::int32 var_132 = 0;
        wp::int32 var_133;
        wp::int32 var_134;
        const wp::int32 var_135 = 1;
        bool var_136;
        wp::int32 var_137;
        wp::int32 var_138;
        wp::range_t var_139;
        wp::int32 var_140;
        wp::vec_t<3, wp::float32>* var_141;
        wp::float32 var_142;
        wp::vec_t<3, wp::float32> var_143;
        wp::int32 var_144;
        bool var_145;
        wp::int32* var_146;
        wp::int32 var_147;
        wp::int32 var_148;
        bool var_149;
        bool var_150;
        bool var_151;
        bool var_152;
        bool var_153;
        wp::int32 var_154;
        wp::int32 var_155;
        wp::int32 var_156;
        wp::int32 var_157;
        wp::int32 var_158;
        wp::int32 var_159;
        wp::float32 var_160;
        wp::float32 var_161;
        const wp::int32 var_162 = 1;
        wp::float32 var_163;
        wp::int32 var_164;
        const wp::int32 var_165 = 0;
        bool var_166;
        const wp::int32 var_167 = 0;
        wp::int32 var_168;
        const wp::int32 var_169 = 1;
        bool var_170;
        wp::int64 var_171;
        wp::vec_t<4, wp::int64> var_172;
        wp::vec_t<4, wp::int64> var_173;
        wp::vec_t<4, wp::int64> var_174;
        wp::vec_t<4, wp::int64> var_175;
        wp::int64 var_176;
        bool var_177;
        wp::int64 var_178;
        wp::int64 var_179;
        //---------
        // forward
        // def find_separately_kernel(queries, query_order, others, tree__count, tree__root, tree__levels, tree__boxes, tree__points, tree__order, tree__codes, tree__curve__low, tree__curve__scale, tree__curve__levels, max_sqdist, nearest):       <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // row = query_order[i]                                                                   <L 3>
        var_1 = wp::address(var_query_order, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // q = queries[row]                                                                       <L 4>
        var_4 = wp::address(var_queries, var_2);
        var_6 = wp::load(var_4);
        var_5 = wp::copy(var_6);
        // none = float_bits(max_sqdist) + 1                                                      <L 5>
        var_7 = _float_bits_0(var_max_sqdist);
        var_9 = wp::add(var_7, var_8);
        // best = none                                                                            <L 6>
        var_10 = wp::copy(var_9);
        // label = none                                                                           <L 7>
        var_11 = wp::copy(var_9);
        // if tree__count > 0 and isfinite(q):                                                    <L 8>
        var_14 = (var_tree__count > var_13);
        var_12 = var_14;
        if (var_12) {
            var_15 = wp::isfinite(var_5);
            var_12 = var_12 && var_15;
        }
        if (var_12) {
            // own = row if others == 1 else NO_LABEL                                             <L 9>
            var_17 = (var_others == var_16);
            if (var_17) {
            }
            if (!var_17) {
            }
            var_19 = wp::where(var_17, var_2, var_18);
            // step = start_traversal(find_bucket(q, tree__count, tree__codes, tree__curve__low, tree__curve__scale, tree__curve__levels))       <L 10>
            var_20 = find_bucket_0(var_5, var_tree__count, var_tree__codes, var_tree__curve__low, var_tree__curve__scale, var_tree__curve__levels);
            var_21 = start_traversal_0(var_20);
            // bound = min(max_sqdist, bits_float(best))                                          <L 11>
            var_22 = _bits_float_0(var_10);
            var_23 = wp::min(var_max_sqdist, var_22);
            // while int(step[0]) <= tree__root:                                                  <L 12>
        start_while_0:;
            var_25 = wp::extract(var_21, var_24);
            var_26 = wp::int(var_25);
            var_27 = (var_26 <= var_tree__root);
        if ((var_27) == false) goto end_while_0;
                // bucket = int(step[2])                                                          <L 13>
                var_29 = wp::extract(var_21, var_28);
                var_30 = wp::int(var_29);
                // distances = measure_boxes(tree__boxes, bucket, q, q)                           <L 14>
                var_31 = measure_boxes_0(var_tree__boxes, var_30, var_5, var_5);
                // within = int(0)                                                                <L 15>
                var_33 = wp::int(var_32);
                // for leaf in range(FAN):                                                        <L 16>
                // within = within | (1 if distances[leaf] <= bound else 0) << leaf               <L 17>
                var_35 = wp::extract(var_31, var_34);
                var_36 = (var_35 <= var_23);
                if (var_36) {
                }
                if (!var_36) {
                }
                var_39 = wp::where(var_36, var_37, var_38);
                var_40 = wp::lshift(var_39, var_34);
                var_41 = wp::bit_or(var_33, var_40);
                var_43 = wp::extract(var_31, var_42);
                var_44 = (var_43 <= var_23);
                if (var_44) {
                }
                if (!var_44) {
                }
                var_47 = wp::where(var_44, var_45, var_46);
                var_48 = wp::lshift(var_47, var_42);
                var_49 = wp::bit_or(var_41, var_48);
                var_51 = wp::extract(var_31, var_50);
                var_52 = (var_51 <= var_23);
                if (var_52) {
                }
                if (!var_52) {
                }
                var_55 = wp::where(var_52, var_53, var_54);
                var_56 = wp::lshift(var_55, var_50);
                var_57 = wp::bit_or(var_49, var_56);
                var_59 = wp::extract(var_31, var_58);
                var_60 = (var_59 <= var_23);
                if (var_60) {
                }
                if (!var_60) {
                }
                var_63 = wp::where(var_60, var_61, var_62);
                var_64 = wp::lshift(var_63, var_58);
                var_65 = wp::bit_or(var_57, var_64);
                var_67 = wp::extract(var_31, var_66);
                var_68 = (var_67 <= var_23);
                if (var_68) {
                }
                if (!var_68) {
                }
                var_71 = wp::where(var_68, var_69, var_70);
                var_72 = wp::lshift(var_71, var_66);
                var_73 = wp::bit_or(var_65, var_72);
                var_75 = wp::extract(var_31, var_74);
                var_76 = (var_75 <= var_23);
                if (var_76) {
                }
                if (!var_76) {
                }
                var_79 = wp::where(var_76, var_77, var_78);
                var_80 = wp::lshift(var_79, var_74);
                var_81 = wp::bit_or(var_73, var_80);
                var_83 = wp::extract(var_31, var_82);
                var_84 = (var_83 <= var_23);
                if (var_84) {
                }
                if (!var_84) {
                }
                var_87 = wp::where(var_84, var_85, var_86);
                var_88 = wp::lshift(var_87, var_82);
                var_89 = wp::bit_or(var_81, var_88);
                var_91 = wp::extract(var_31, var_90);
                var_92 = (var_91 <= var_23);
                if (var_92) {
                }
                if (!var_92) {
                }
                var_95 = wp::where(var_92, var_93, var_94);
                var_96 = wp::lshift(var_95, var_90);
                var_97 = wp::bit_or(var_89, var_96);
                // is_measured = int(0)                                                           <L 18>
                var_99 = wp::int(var_98);
                // while within != 0:                                                             <L 19>
                var_100 = wp::copy(var_90);
        start_while_2:;
                var_102 = (var_97 != var_101);
        if ((var_102) == false) goto end_while_2;
                    // lowest = within & -within                                                  <L 20>
                    var_103 = wp::neg(var_97);
                    var_104 = wp::bit_and(var_97, var_103);
                    // within = within ^ lowest                                                   <L 21>
                    var_105 = wp::bit_xor(var_97, var_104);
                    // leaf = bit_count(lowest - 1)                                               <L 22>
                    var_107 = wp::sub(var_104, var_106);
                    var_108 = wp::bit_count(var_107);
                    // first = bucket * BUCKET + leaf * LEAF                                      <L 23>
                    var_110 = wp::mul(var_30, var_109);
                    var_112 = wp::mul(var_108, var_111);
                    var_113 = wp::add(var_110, var_112);
                    // distance = float_bits(measure_box(tree__boxes, bucket, leaf, q, q))        <L 24>
                    var_114 = measure_box_0(var_tree__boxes, var_30, var_108, var_5, var_5);
                    var_115 = _float_bits_0(var_114);
                    // wanted = 1 if distance <= float_bits(bound) else 0                         <L 25>
                    var_116 = _float_bits_0(var_23);
                    var_117 = (var_115 <= var_116);
                    if (var_117) {
                    }
                    if (!var_117) {
                    }
                    var_120 = wp::where(var_117, var_118, var_119);
                    // if wanted == 1 and distance == best:                                       <L 26>
                    var_123 = (var_120 == var_122);
                    var_121 = var_123;
                    if (var_121) {
                        var_124 = (var_115 == var_10);
                        var_121 = var_121 && var_124;
                    }
                    if (var_121) {
                        // if is_one_point(tree__boxes, bucket, leaf) == 1 and tree__order[first] > label:       <L 27>
                        var_126 = is_one_point_0(var_tree__boxes, var_30, var_108);
                        var_128 = (var_126 == var_127);
                        var_125 = var_128;
                        if (var_125) {
                            var_129 = wp::address(var_tree__order, var_113);
                            var_131 = wp::load(var_129);
                            var_130 = (var_131 > var_11);
                            var_125 = var_125 && var_130;
                        }
                        if (var_125) {
                            // wanted = 0                                                         <L 28>
                        }
                        var_133 = wp::where(var_125, var_132, var_120);
                    }
                    var_134 = wp::where(var_121, var_133, var_120);
                    // if wanted == 1:                                                            <L 29>
                    var_136 = (var_134 == var_135);
                    if (var_136) {
                        // for j in range(first, min(first + LEAF, tree__count)):                 <L 30>
                        var_137 = wp::add(var_113, var_111);
                        var_138 = wp::min(var_137, var_tree__count);
                        var_139 = wp::range(var_113, var_138);
                        start_for_4:;
                            if (iter_cmp(var_139) == 0) goto end_for_4;
                            var_140 = wp::iter_next(var_139);
                            // bits = float_bits(square_distance(q, tree__points[j]))             <L 31>
                            var_141 = wp::address(var_tree__points, var_140);
                            var_143 = wp::load(var_141);
                            var_142 = square_distance_0(var_5, var_143);
                            var_144 = _float_bits_0(var_142);
                            // if bits <= best:                                                   <L 32>
                            var_145 = (var_144 <= var_10);
                            if (var_145) {
                                // other = tree__order[j]                                         <L 33>
                                var_146 = wp::address(var_tree__order, var_140);
                                var_148 = wp::load(var_146);
                                var_147 = wp::copy(var_148);
                                // if (bits < best or other < label) and other != own:            <L 34>
                                var_151 = (var_144 < var_10);
                                var_150 = var_151;
                                if (!var_150) {
                                    var_152 = (var_147 < var_11);
                                    var_150 = var_150 || var_152;
                                }
                                var_149 = var_150;
                                if (var_149) {
                                    var_153 = (var_147 != var_19);
                                    var_149 = var_149 && var_153;
                                }
                                if (var_149) {
                                    // best = bits                                                <L 35>
                                    var_154 = wp::copy(var_144);
                                    // label = other                                              <L 36>
                                    var_155 = wp::copy(var_147);
                                }
                                var_156 = wp::where(var_149, var_154, var_10);
                                var_157 = wp::where(var_149, var_155, var_11);
                            }
                            var_158 = wp::where(var_145, var_156, var_10);
                            var_159 = wp::where(var_145, var_157, var_11);
                            wp::assign(var_10, var_158);
                            wp::assign(var_11, var_159);
                            goto start_for_4;
                        end_for_4:;
                        // bound = min(max_sqdist, bits_float(best))                              <L 37>
                        var_160 = _bits_float_0(var_10);
                        var_161 = wp::min(var_max_sqdist, var_160);
                        // is_measured = 1                                                        <L 38>
                    }
                    var_163 = wp::where(var_136, var_161, var_23);
                    var_164 = wp::where(var_136, var_162, var_99);
                    wp::assign(var_23, var_163);
                    wp::assign(var_97, var_105);
                    wp::assign(var_100, var_108);
                    wp::assign(var_99, var_164);
        goto start_while_2;
        end_while_2:;
                // if is_measured == 0:                                                           <L 39>
                var_166 = (var_99 == var_165);
                if (var_166) {
                    // if is_one_point(tree__boxes, bucket, 0) == 1:                              <L 40>
                    var_168 = is_one_point_0(var_tree__boxes, var_30, var_167);
                    var_170 = (var_168 == var_169);
                    if (var_170) {
                        // step = pass_over_equal(step, q, q, pack_bits(best, label), tree__levels, tree__boxes, tree__order)       <L 41>
                        var_171 = pack_bits_0(var_10, var_11);
                        var_172 = pass_over_equal_one_by_one_on_cuda_0(var_21, var_5, var_5, var_171, var_tree__levels, var_tree__boxes, var_tree__order);
                    }
                    var_173 = wp::where(var_170, var_172, var_21);
                }
                var_174 = wp::where(var_166, var_173, var_21);
                // step = next_bucket(step, q, q, bound, tree__root, tree__levels, tree__boxes)       <L 42>
                var_175 = next_bucket_0(var_174, var_5, var_5, var_23, var_tree__root, var_tree__levels, var_tree__boxes);
                wp::assign(var_21, var_175);
        goto start_while_0;
        end_while_0:;
        }
        // key = int64(NO_POINT)                                                                  <L 43>
        var_176 = -1ll;
        // if best < none:                                                                        <L 44>
        var_177 = (var_10 < var_9);
        if (var_177) {
            // key = pack_bits(best, label)                                                       <L 45>
            var_178 = pack_bits_0(var_10, var_11);
        }
        var_179 = wp::where(var_177, var_178, var_176);
        // nearest[row] = key                                                                     <L 46>
        wp::array_store(var_nearest, var_2, var_179);
}


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


// <pointloom.kernels.algebra.moments.add_rounded_difference>:1
static CUDA_CALLABLE wp::vec_t<10, wp::float64> add_rounded_difference_0(
    wp::vec_t<10, wp::float64> var_total,
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
    wp::float64 var_5;
    const wp::int32 var_6 = 1;
    wp::float32 var_7;
    const wp::int32 var_8 = 1;
    wp::float32 var_9;
    wp::float32 var_10;
    wp::float64 var_11;
    const wp::int32 var_12 = 2;
    wp::float32 var_13;
    const wp::int32 var_14 = 2;
    wp::float32 var_15;
    wp::float32 var_16;
    wp::float64 var_17;
    wp::float64 var_18;
    wp::float64 var_19;
    wp::float64 var_20;
    wp::float64 var_21;
    wp::float64 var_22;
    wp::float64 var_23;
    wp::float64 var_24;
    wp::vec_t<10, wp::float64> var_25;
    wp::vec_t<10, wp::float64> var_26;
    //---------
    // forward
    // def add_rounded_difference(total, p, q):                                               <L 1>
    // x = float64(q[0] - p[0])                                                               <L 3>
    var_1 = wp::extract(var_q, var_0);
    var_3 = wp::extract(var_p, var_2);
    var_4 = wp::sub(var_1, var_3);
    var_5 = wp::float64(var_4);
    // y = float64(q[1] - p[1])                                                               <L 4>
    var_7 = wp::extract(var_q, var_6);
    var_9 = wp::extract(var_p, var_8);
    var_10 = wp::sub(var_7, var_9);
    var_11 = wp::float64(var_10);
    // z = float64(q[2] - p[2])                                                               <L 5>
    var_13 = wp::extract(var_q, var_12);
    var_15 = wp::extract(var_p, var_14);
    var_16 = wp::sub(var_13, var_15);
    var_17 = wp::float64(var_16);
    // return total + moments(float64(1.0), x, y, z, x * x, x * y, x * z, y * y, y * z, z * z)       <L 6>
    var_18 = 1.0;
    var_19 = wp::mul(var_5, var_5);
    var_20 = wp::mul(var_5, var_11);
    var_21 = wp::mul(var_5, var_17);
    var_22 = wp::mul(var_11, var_11);
    var_23 = wp::mul(var_11, var_17);
    var_24 = wp::mul(var_17, var_17);
    var_25 = wp::vec_t<10, wp::float64>({var_18, var_5, var_11, var_17, var_19, var_20, var_21, var_22, var_23, var_24});
    var_26 = wp::add(var_total, var_25);
    return var_26;
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


// <pointloom.kernels.algebra.moments.covariance_of>:1
static CUDA_CALLABLE wp::mat_t<3, 3, wp::float64> covariance_of_0(
    wp::vec_t<10, wp::float64> var_m)
{
    //---------
    // primal vars
    wp::float64 var_0;
    const wp::int32 var_1 = 0;
    wp::float64 var_2;
    wp::float64 var_3;
    wp::float64 var_4;
    wp::float64 var_5;
    const wp::int32 var_6 = 1;
    wp::float64 var_7;
    wp::float64 var_8;
    const wp::int32 var_9 = 2;
    wp::float64 var_10;
    wp::float64 var_11;
    const wp::int32 var_12 = 3;
    wp::float64 var_13;
    wp::float64 var_14;
    const wp::int32 var_15 = 5;
    wp::float64 var_16;
    wp::float64 var_17;
    wp::float64 var_18;
    wp::float64 var_19;
    const wp::int32 var_20 = 6;
    wp::float64 var_21;
    wp::float64 var_22;
    wp::float64 var_23;
    wp::float64 var_24;
    const wp::int32 var_25 = 8;
    wp::float64 var_26;
    wp::float64 var_27;
    wp::float64 var_28;
    wp::float64 var_29;
    const wp::int32 var_30 = 4;
    wp::float64 var_31;
    wp::float64 var_32;
    wp::float64 var_33;
    wp::float64 var_34;
    const wp::int32 var_35 = 7;
    wp::float64 var_36;
    wp::float64 var_37;
    wp::float64 var_38;
    wp::float64 var_39;
    const wp::int32 var_40 = 9;
    wp::float64 var_41;
    wp::float64 var_42;
    wp::float64 var_43;
    wp::float64 var_44;
    wp::mat_t<3, 3, wp::float64> var_45;
    //---------
    // forward
    // def covariance_of(m):                                                                  <L 1>
    // s = float64(1.0) / max(m[0], float64(1.0))                                             <L 3>
    var_0 = 1.0;
    var_2 = wp::extract(var_m, var_1);
    var_3 = 1.0;
    var_4 = wp::max(var_2, var_3);
    var_5 = wp::div(var_0, var_4);
    // x = m[1] * s                                                                           <L 4>
    var_7 = wp::extract(var_m, var_6);
    var_8 = wp::mul(var_7, var_5);
    // y = m[2] * s                                                                           <L 5>
    var_10 = wp::extract(var_m, var_9);
    var_11 = wp::mul(var_10, var_5);
    // z = m[3] * s                                                                           <L 6>
    var_13 = wp::extract(var_m, var_12);
    var_14 = wp::mul(var_13, var_5);
    // xy = m[5] * s - x * y                                                                  <L 7>
    var_16 = wp::extract(var_m, var_15);
    var_17 = wp::mul(var_16, var_5);
    var_18 = wp::mul(var_8, var_11);
    var_19 = wp::sub(var_17, var_18);
    // xz = m[6] * s - x * z                                                                  <L 8>
    var_21 = wp::extract(var_m, var_20);
    var_22 = wp::mul(var_21, var_5);
    var_23 = wp::mul(var_8, var_14);
    var_24 = wp::sub(var_22, var_23);
    // yz = m[8] * s - y * z                                                                  <L 9>
    var_26 = wp::extract(var_m, var_25);
    var_27 = wp::mul(var_26, var_5);
    var_28 = wp::mul(var_11, var_14);
    var_29 = wp::sub(var_27, var_28);
    // return mat33d(m[4] * s - x * x, xy, xz, xy, m[7] * s - y * y, yz, xz, yz, m[9] * s - z * z)       <L 10>
    var_31 = wp::extract(var_m, var_30);
    var_32 = wp::mul(var_31, var_5);
    var_33 = wp::mul(var_8, var_8);
    var_34 = wp::sub(var_32, var_33);
    var_36 = wp::extract(var_m, var_35);
    var_37 = wp::mul(var_36, var_5);
    var_38 = wp::mul(var_11, var_11);
    var_39 = wp::sub(var_37, var_38);
    var_41 = wp::extract(var_m, var_40);
    var_42 = wp::mul(var_41, var_5);
    var_43 = wp::mul(var_14, var_14);
    var_44 = wp::sub(var_42, var_43);
    var_45 = wp::mat_t<3, 3, wp::float64>(var_34, var_19, var_24, var_19, var_39, var_29, var_24, var_29, var_44);
    return var_45;
}


// /work/main/src/pointloom/kernels/algebra/eigen.py:14
static CUDA_CALLABLE wp::float64 largest_entry_0(
    wp::mat_t<3, 3, wp::float64> var_a)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    const wp::int32 var_1 = 0;
    wp::float64 var_2;
    wp::float64 var_3;
    const wp::int32 var_4 = 1;
    const wp::int32 var_5 = 1;
    wp::float64 var_6;
    wp::float64 var_7;
    wp::float64 var_8;
    const wp::int32 var_9 = 2;
    const wp::int32 var_10 = 2;
    wp::float64 var_11;
    wp::float64 var_12;
    wp::float64 var_13;
    const wp::int32 var_14 = 0;
    const wp::int32 var_15 = 1;
    wp::float64 var_16;
    wp::float64 var_17;
    const wp::int32 var_18 = 0;
    const wp::int32 var_19 = 2;
    wp::float64 var_20;
    wp::float64 var_21;
    wp::float64 var_22;
    const wp::int32 var_23 = 1;
    const wp::int32 var_24 = 2;
    wp::float64 var_25;
    wp::float64 var_26;
    wp::float64 var_27;
    wp::float64 var_28;
    //---------
    // forward
    // def largest_entry(a: mat33d) -> float64:                                               <L 15>
    // diagonal = max(max(abs(a[0, 0]), abs(a[1, 1])), abs(a[2, 2]))                          <L 16>
    var_2 = wp::extract(var_a, var_0, var_1);
    var_3 = wp::abs(var_2);
    var_6 = wp::extract(var_a, var_4, var_5);
    var_7 = wp::abs(var_6);
    var_8 = wp::max(var_3, var_7);
    var_11 = wp::extract(var_a, var_9, var_10);
    var_12 = wp::abs(var_11);
    var_13 = wp::max(var_8, var_12);
    // return max(diagonal, max(max(abs(a[0, 1]), abs(a[0, 2])), abs(a[1, 2])))               <L 17>
    var_16 = wp::extract(var_a, var_14, var_15);
    var_17 = wp::abs(var_16);
    var_20 = wp::extract(var_a, var_18, var_19);
    var_21 = wp::abs(var_20);
    var_22 = wp::max(var_17, var_21);
    var_25 = wp::extract(var_a, var_23, var_24);
    var_26 = wp::abs(var_25);
    var_27 = wp::max(var_22, var_26);
    var_28 = wp::max(var_13, var_27);
    return var_28;
}


// /work/main/src/pointloom/kernels/algebra/eigen.py:20
static CUDA_CALLABLE wp::float64 off_diagonal_0(
    wp::mat_t<3, 3, wp::float64> var_a)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    const wp::int32 var_1 = 1;
    wp::float64 var_2;
    const wp::int32 var_3 = 0;
    const wp::int32 var_4 = 1;
    wp::float64 var_5;
    wp::float64 var_6;
    const wp::int32 var_7 = 0;
    const wp::int32 var_8 = 2;
    wp::float64 var_9;
    const wp::int32 var_10 = 0;
    const wp::int32 var_11 = 2;
    wp::float64 var_12;
    wp::float64 var_13;
    wp::float64 var_14;
    const wp::int32 var_15 = 1;
    const wp::int32 var_16 = 2;
    wp::float64 var_17;
    const wp::int32 var_18 = 1;
    const wp::int32 var_19 = 2;
    wp::float64 var_20;
    wp::float64 var_21;
    wp::float64 var_22;
    //---------
    // forward
    // def off_diagonal(a: mat33d) -> float64:                                                <L 21>
    // return a[0, 1] * a[0, 1] + a[0, 2] * a[0, 2] + a[1, 2] * a[1, 2]                       <L 23>
    var_2 = wp::extract(var_a, var_0, var_1);
    var_5 = wp::extract(var_a, var_3, var_4);
    var_6 = wp::mul(var_2, var_5);
    var_9 = wp::extract(var_a, var_7, var_8);
    var_12 = wp::extract(var_a, var_10, var_11);
    var_13 = wp::mul(var_9, var_12);
    var_14 = wp::add(var_6, var_13);
    var_17 = wp::extract(var_a, var_15, var_16);
    var_20 = wp::extract(var_a, var_18, var_19);
    var_21 = wp::mul(var_17, var_20);
    var_22 = wp::add(var_14, var_21);
    return var_22;
}


// <pointloom.kernels.algebra.eigen.sorted_eigenvalues>:1
static CUDA_CALLABLE wp::vec_t<3, wp::float64> sorted_eigenvalues_0(
    wp::mat_t<3, 3, wp::float64> var_a)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    const wp::int32 var_1 = 0;
    wp::float64 var_2;
    const wp::int32 var_3 = 1;
    const wp::int32 var_4 = 1;
    wp::float64 var_5;
    wp::float64 var_6;
    const wp::int32 var_7 = 2;
    const wp::int32 var_8 = 2;
    wp::float64 var_9;
    wp::float64 var_10;
    wp::float64 var_11;
    wp::float64 var_12;
    const wp::int32 var_13 = 0;
    const wp::int32 var_14 = 0;
    wp::float64 var_15;
    wp::float64 var_16;
    const wp::int32 var_17 = 1;
    const wp::int32 var_18 = 1;
    wp::float64 var_19;
    wp::float64 var_20;
    const wp::int32 var_21 = 2;
    const wp::int32 var_22 = 2;
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
    wp::vec_t<3, wp::float64> var_37;
    wp::float64 var_38;
    bool var_39;
    wp::float64 var_40;
    wp::float64 var_41;
    wp::float64 var_42;
    wp::float64 var_43;
    wp::float64 var_44;
    const wp::int32 var_45 = 1;
    const wp::int32 var_46 = 2;
    wp::float64 var_47;
    wp::float64 var_48;
    const wp::int32 var_49 = 1;
    const wp::int32 var_50 = 2;
    wp::float64 var_51;
    wp::float64 var_52;
    wp::float64 var_53;
    wp::float64 var_54;
    const wp::int32 var_55 = 0;
    const wp::int32 var_56 = 1;
    wp::float64 var_57;
    wp::float64 var_58;
    wp::float64 var_59;
    wp::float64 var_60;
    const wp::int32 var_61 = 1;
    const wp::int32 var_62 = 2;
    wp::float64 var_63;
    wp::float64 var_64;
    const wp::int32 var_65 = 0;
    const wp::int32 var_66 = 2;
    wp::float64 var_67;
    wp::float64 var_68;
    wp::float64 var_69;
    wp::float64 var_70;
    const wp::int32 var_71 = 0;
    const wp::int32 var_72 = 1;
    wp::float64 var_73;
    wp::float64 var_74;
    const wp::int32 var_75 = 1;
    const wp::int32 var_76 = 2;
    wp::float64 var_77;
    wp::float64 var_78;
    wp::float64 var_79;
    wp::float64 var_80;
    const wp::int32 var_81 = 0;
    const wp::int32 var_82 = 2;
    wp::float64 var_83;
    wp::float64 var_84;
    wp::float64 var_85;
    wp::float64 var_86;
    wp::float64 var_87;
    wp::float64 var_88;
    const wp::int32 var_89 = 0;
    const wp::int32 var_90 = 1;
    wp::float64 var_91;
    wp::float64 var_92;
    wp::float64 var_93;
    wp::float64 var_94;
    const wp::int32 var_95 = 0;
    const wp::int32 var_96 = 2;
    wp::float64 var_97;
    wp::float64 var_98;
    wp::float64 var_99;
    wp::float64 var_100;
    wp::float64 var_101;
    wp::float64 var_102;
    wp::float64 var_103;
    wp::float64 var_104;
    wp::float64 var_105;
    wp::float64 var_106;
    wp::float64 var_107;
    wp::float64 var_108;
    wp::float64 var_109;
    wp::float64 var_110;
    wp::float64 var_111;
    wp::float64 var_112;
    wp::float64 var_113;
    wp::float64 var_114;
    wp::float64 var_115;
    wp::float64 var_116;
    wp::float64 var_117;
    wp::float64 var_118;
    wp::float64 var_119;
    wp::float64 var_120;
    wp::float64 var_121;
    wp::float64 var_122;
    wp::float64 var_123;
    wp::float64 var_124;
    wp::vec_t<3, wp::float64> var_125;
    wp::vec_t<3, wp::float64> var_126;
    //---------
    // forward
    // def sorted_eigenvalues(a):                                                             <L 1>
    // q = (a[0, 0] + a[1, 1] + a[2, 2]) / float64(3.0)                                       <L 3>
    var_2 = wp::extract(var_a, var_0, var_1);
    var_5 = wp::extract(var_a, var_3, var_4);
    var_6 = wp::add(var_2, var_5);
    var_9 = wp::extract(var_a, var_7, var_8);
    var_10 = wp::add(var_6, var_9);
    var_11 = 3.0;
    var_12 = wp::div(var_10, var_11);
    // b00 = a[0, 0] - q                                                                      <L 4>
    var_15 = wp::extract(var_a, var_13, var_14);
    var_16 = wp::sub(var_15, var_12);
    // b11 = a[1, 1] - q                                                                      <L 5>
    var_19 = wp::extract(var_a, var_17, var_18);
    var_20 = wp::sub(var_19, var_12);
    // b22 = a[2, 2] - q                                                                      <L 6>
    var_23 = wp::extract(var_a, var_21, var_22);
    var_24 = wp::sub(var_23, var_12);
    // p = sqrt((b00 * b00 + b11 * b11 + b22 * b22 + float64(2.0) * off_diagonal(a)) / float64(6.0))       <L 7>
    var_25 = wp::mul(var_16, var_16);
    var_26 = wp::mul(var_20, var_20);
    var_27 = wp::add(var_25, var_26);
    var_28 = wp::mul(var_24, var_24);
    var_29 = wp::add(var_27, var_28);
    var_30 = 2.0;
    var_31 = off_diagonal_0(var_a);
    var_32 = wp::mul(var_30, var_31);
    var_33 = wp::add(var_29, var_32);
    var_34 = 6.0;
    var_35 = wp::div(var_33, var_34);
    var_36 = wp::sqrt(var_35);
    // values = vec3d(q, q, q)                                                                <L 8>
    var_37 = wp::vec_t<3, wp::float64>(var_12, var_12, var_12);
    // if p > float64(0.0):                                                                   <L 9>
    var_38 = 0.0;
    var_39 = (var_36 > var_38);
    if (var_39) {
        // s = float64(1.0) / p                                                               <L 10>
        var_40 = 1.0;
        var_41 = wp::div(var_40, var_36);
        // c00 = b11 * s * (b22 * s) - a[1, 2] * s * (a[1, 2] * s)                            <L 11>
        var_42 = wp::mul(var_20, var_41);
        var_43 = wp::mul(var_24, var_41);
        var_44 = wp::mul(var_42, var_43);
        var_47 = wp::extract(var_a, var_45, var_46);
        var_48 = wp::mul(var_47, var_41);
        var_51 = wp::extract(var_a, var_49, var_50);
        var_52 = wp::mul(var_51, var_41);
        var_53 = wp::mul(var_48, var_52);
        var_54 = wp::sub(var_44, var_53);
        // c01 = a[0, 1] * s * (b22 * s) - a[1, 2] * s * (a[0, 2] * s)                        <L 12>
        var_57 = wp::extract(var_a, var_55, var_56);
        var_58 = wp::mul(var_57, var_41);
        var_59 = wp::mul(var_24, var_41);
        var_60 = wp::mul(var_58, var_59);
        var_63 = wp::extract(var_a, var_61, var_62);
        var_64 = wp::mul(var_63, var_41);
        var_67 = wp::extract(var_a, var_65, var_66);
        var_68 = wp::mul(var_67, var_41);
        var_69 = wp::mul(var_64, var_68);
        var_70 = wp::sub(var_60, var_69);
        // c02 = a[0, 1] * s * (a[1, 2] * s) - b11 * s * (a[0, 2] * s)                        <L 13>
        var_73 = wp::extract(var_a, var_71, var_72);
        var_74 = wp::mul(var_73, var_41);
        var_77 = wp::extract(var_a, var_75, var_76);
        var_78 = wp::mul(var_77, var_41);
        var_79 = wp::mul(var_74, var_78);
        var_80 = wp::mul(var_20, var_41);
        var_83 = wp::extract(var_a, var_81, var_82);
        var_84 = wp::mul(var_83, var_41);
        var_85 = wp::mul(var_80, var_84);
        var_86 = wp::sub(var_79, var_85);
        // det = b00 * s * c00 - a[0, 1] * s * c01 + a[0, 2] * s * c02                        <L 14>
        var_87 = wp::mul(var_16, var_41);
        var_88 = wp::mul(var_87, var_54);
        var_91 = wp::extract(var_a, var_89, var_90);
        var_92 = wp::mul(var_91, var_41);
        var_93 = wp::mul(var_92, var_70);
        var_94 = wp::sub(var_88, var_93);
        var_97 = wp::extract(var_a, var_95, var_96);
        var_98 = wp::mul(var_97, var_41);
        var_99 = wp::mul(var_98, var_86);
        var_100 = wp::add(var_94, var_99);
        // half = min(max(det * float64(0.5), float64(-1.0)), float64(1.0))                   <L 15>
        var_101 = 0.5;
        var_102 = wp::mul(var_100, var_101);
        var_103 = -1.0;
        var_104 = wp::max(var_102, var_103);
        var_105 = 1.0;
        var_106 = wp::min(var_104, var_105);
        // angle = acos(half) / float64(3.0)                                                  <L 16>
        var_107 = wp::acos(var_106);
        var_108 = 3.0;
        var_109 = wp::div(var_107, var_108);
        // high = float64(2.0) * cos(angle)                                                   <L 17>
        var_110 = 2.0;
        var_111 = wp::cos(var_109);
        var_112 = wp::mul(var_110, var_111);
        // low = float64(2.0) * cos(angle + float64(TWO_THIRDS_PI))                           <L 18>
        var_113 = 2.0;
        var_114 = 2.0943951023931953;
        var_115 = wp::add(var_109, var_114);
        var_116 = wp::cos(var_115);
        var_117 = wp::mul(var_113, var_116);
        // values = vec3d(q + p * low, q - p * (low + high), q + p * high)                    <L 19>
        var_118 = wp::mul(var_36, var_117);
        var_119 = wp::add(var_12, var_118);
        var_120 = wp::add(var_117, var_112);
        var_121 = wp::mul(var_36, var_120);
        var_122 = wp::sub(var_12, var_121);
        var_123 = wp::mul(var_36, var_112);
        var_124 = wp::add(var_12, var_123);
        var_125 = wp::vec_t<3, wp::float64>(var_119, var_122, var_124);
    }
    var_126 = wp::where(var_39, var_125, var_37);
    // return values                                                                          <L 20>
    return var_126;
}


// <pointloom.kernels.algebra.eigen.separated_eigenvector>:1
static CUDA_CALLABLE wp::vec_t<3, wp::float64> separated_eigenvector_0(
    wp::mat_t<3, 3, wp::float64> var_a,
    wp::float64 var_value)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    const wp::int32 var_1 = 0;
    wp::float64 var_2;
    wp::float64 var_3;
    const wp::int32 var_4 = 0;
    const wp::int32 var_5 = 1;
    wp::float64 var_6;
    const wp::int32 var_7 = 0;
    const wp::int32 var_8 = 2;
    wp::float64 var_9;
    wp::vec_t<3, wp::float64> var_10;
    const wp::int32 var_11 = 0;
    const wp::int32 var_12 = 1;
    wp::float64 var_13;
    const wp::int32 var_14 = 1;
    const wp::int32 var_15 = 1;
    wp::float64 var_16;
    wp::float64 var_17;
    const wp::int32 var_18 = 1;
    const wp::int32 var_19 = 2;
    wp::float64 var_20;
    wp::vec_t<3, wp::float64> var_21;
    const wp::int32 var_22 = 0;
    const wp::int32 var_23 = 2;
    wp::float64 var_24;
    const wp::int32 var_25 = 1;
    const wp::int32 var_26 = 2;
    wp::float64 var_27;
    const wp::int32 var_28 = 2;
    const wp::int32 var_29 = 2;
    wp::float64 var_30;
    wp::float64 var_31;
    wp::vec_t<3, wp::float64> var_32;
    wp::vec_t<3, wp::float64> var_33;
    wp::float64 var_34;
    wp::vec_t<3, wp::float64> var_35;
    wp::float64 var_36;
    bool var_37;
    wp::vec_t<3, wp::float64> var_38;
    wp::float64 var_39;
    wp::vec_t<3, wp::float64> var_40;
    wp::float64 var_41;
    wp::vec_t<3, wp::float64> var_42;
    wp::float64 var_43;
    bool var_44;
    wp::vec_t<3, wp::float64> var_45;
    wp::float64 var_46;
    wp::vec_t<3, wp::float64> var_47;
    wp::float64 var_48;
    wp::float64 var_49;
    wp::float64 var_50;
    wp::float64 var_51;
    wp::vec_t<3, wp::float64> var_52;
    wp::float64 var_53;
    bool var_54;
    wp::float64 var_55;
    wp::vec_t<3, wp::float64> var_56;
    wp::vec_t<3, wp::float64> var_57;
    //---------
    // forward
    // def separated_eigenvector(a, value):                                                   <L 1>
    // r0 = vec3d(a[0, 0] - value, a[0, 1], a[0, 2])                                          <L 3>
    var_2 = wp::extract(var_a, var_0, var_1);
    var_3 = wp::sub(var_2, var_value);
    var_6 = wp::extract(var_a, var_4, var_5);
    var_9 = wp::extract(var_a, var_7, var_8);
    var_10 = wp::vec_t<3, wp::float64>(var_3, var_6, var_9);
    // r1 = vec3d(a[0, 1], a[1, 1] - value, a[1, 2])                                          <L 4>
    var_13 = wp::extract(var_a, var_11, var_12);
    var_16 = wp::extract(var_a, var_14, var_15);
    var_17 = wp::sub(var_16, var_value);
    var_20 = wp::extract(var_a, var_18, var_19);
    var_21 = wp::vec_t<3, wp::float64>(var_13, var_17, var_20);
    // r2 = vec3d(a[0, 2], a[1, 2], a[2, 2] - value)                                          <L 5>
    var_24 = wp::extract(var_a, var_22, var_23);
    var_27 = wp::extract(var_a, var_25, var_26);
    var_30 = wp::extract(var_a, var_28, var_29);
    var_31 = wp::sub(var_30, var_value);
    var_32 = wp::vec_t<3, wp::float64>(var_24, var_27, var_31);
    // best = cross(r0, r1)                                                                   <L 6>
    var_33 = wp::cross(var_10, var_21);
    // size = dot(best, best)                                                                 <L 7>
    var_34 = wp::dot(var_33, var_33);
    // other = cross(r0, r2)                                                                  <L 8>
    var_35 = wp::cross(var_10, var_32);
    // if dot(other, other) > size:                                                           <L 9>
    var_36 = wp::dot(var_35, var_35);
    var_37 = (var_36 > var_34);
    if (var_37) {
        // best = other                                                                       <L 10>
        var_38 = wp::copy(var_35);
        // size = dot(other, other)                                                           <L 11>
        var_39 = wp::dot(var_35, var_35);
    }
    var_40 = wp::where(var_37, var_38, var_33);
    var_41 = wp::where(var_37, var_39, var_34);
    // other = cross(r1, r2)                                                                  <L 12>
    var_42 = wp::cross(var_21, var_32);
    // if dot(other, other) > size:                                                           <L 13>
    var_43 = wp::dot(var_42, var_42);
    var_44 = (var_43 > var_41);
    if (var_44) {
        // best = other                                                                       <L 14>
        var_45 = wp::copy(var_42);
        // size = dot(other, other)                                                           <L 15>
        var_46 = wp::dot(var_42, var_42);
    }
    var_47 = wp::where(var_44, var_45, var_40);
    var_48 = wp::where(var_44, var_46, var_41);
    // unit = vec3d(float64(0.0), float64(0.0), float64(1.0))                                 <L 16>
    var_49 = 0.0;
    var_50 = 0.0;
    var_51 = 1.0;
    var_52 = wp::vec_t<3, wp::float64>(var_49, var_50, var_51);
    // if size > float64(0.0):                                                                <L 17>
    var_53 = 0.0;
    var_54 = (var_48 > var_53);
    if (var_54) {
        // unit = best / sqrt(size)                                                           <L 18>
        var_55 = wp::sqrt(var_48);
        var_56 = wp::div(var_47, var_55);
    }
    var_57 = wp::where(var_54, var_56, var_52);
    // return unit                                                                            <L 19>
    return var_57;
}


// <pointloom.kernels.algebra.eigen.orthogonal_direction>:1
static CUDA_CALLABLE wp::vec_t<3, wp::float64> orthogonal_direction_0(
    wp::vec_t<3, wp::float64> var_w)
{
    //---------
    // primal vars
    wp::float64 var_0;
    const wp::int32 var_1 = 2;
    wp::float64 var_2;
    const wp::int32 var_3 = 1;
    wp::float64 var_4;
    wp::float64 var_5;
    wp::vec_t<3, wp::float64> var_6;
    const wp::int32 var_7 = 0;
    wp::float64 var_8;
    wp::float64 var_9;
    const wp::int32 var_10 = 1;
    wp::float64 var_11;
    wp::float64 var_12;
    bool var_13;
    const wp::int32 var_14 = 2;
    wp::float64 var_15;
    wp::float64 var_16;
    wp::float64 var_17;
    const wp::int32 var_18 = 0;
    wp::float64 var_19;
    wp::vec_t<3, wp::float64> var_20;
    wp::vec_t<3, wp::float64> var_21;
    wp::float64 var_22;
    wp::float64 var_23;
    wp::vec_t<3, wp::float64> var_24;
    //---------
    // forward
    // def orthogonal_direction(w):                                                           <L 1>
    // u = vec3d(float64(0.0), w[2], -w[1])                                                   <L 2>
    var_0 = 0.0;
    var_2 = wp::extract(var_w, var_1);
    var_4 = wp::extract(var_w, var_3);
    var_5 = wp::neg(var_4);
    var_6 = wp::vec_t<3, wp::float64>(var_0, var_2, var_5);
    // if abs(w[0]) > abs(w[1]):                                                              <L 3>
    var_8 = wp::extract(var_w, var_7);
    var_9 = wp::abs(var_8);
    var_11 = wp::extract(var_w, var_10);
    var_12 = wp::abs(var_11);
    var_13 = (var_9 > var_12);
    if (var_13) {
        // u = vec3d(-w[2], float64(0.0), w[0])                                               <L 4>
        var_15 = wp::extract(var_w, var_14);
        var_16 = wp::neg(var_15);
        var_17 = 0.0;
        var_19 = wp::extract(var_w, var_18);
        var_20 = wp::vec_t<3, wp::float64>(var_16, var_17, var_19);
    }
    var_21 = wp::where(var_13, var_20, var_6);
    // return u / sqrt(dot(u, u))                                                             <L 5>
    var_22 = wp::dot(var_21, var_21);
    var_23 = wp::sqrt(var_22);
    var_24 = wp::div(var_21, var_23);
    return var_24;
}


// <pointloom.kernels.algebra.eigen.smallest_in_plane>:1
static CUDA_CALLABLE wp::vec_t<3, wp::float64> smallest_in_plane_0(
    wp::mat_t<3, 3, wp::float64> var_a,
    wp::vec_t<3, wp::float64> var_w)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float64> var_0;
    wp::vec_t<3, wp::float64> var_1;
    wp::vec_t<3, wp::float64> var_2;
    wp::vec_t<3, wp::float64> var_3;
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
    bool var_16;
    wp::float64 var_17;
    wp::float64 var_18;
    wp::float64 var_19;
    wp::float64 var_20;
    wp::float64 var_21;
    wp::float64 var_22;
    wp::float64 var_23;
    wp::float64 var_24;
    wp::float64 var_25;
    bool var_26;
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
    wp::vec_t<3, wp::float64> var_43;
    wp::vec_t<3, wp::float64> var_44;
    wp::vec_t<3, wp::float64> var_45;
    //---------
    // forward
    // def smallest_in_plane(a, w):                                                           <L 1>
    // u = orthogonal_direction(w)                                                            <L 3>
    var_0 = orthogonal_direction_0(var_w);
    // v = cross(w, u)                                                                        <L 4>
    var_1 = wp::cross(var_w, var_0);
    // au = a @ u                                                                             <L 5>
    var_2 = wp::mul(var_a, var_0);
    // av = a @ v                                                                             <L 6>
    var_3 = wp::mul(var_a, var_1);
    // half = (dot(u, au) - dot(v, av)) * float64(0.5)                                        <L 7>
    var_4 = wp::dot(var_0, var_2);
    var_5 = wp::dot(var_1, var_3);
    var_6 = wp::sub(var_4, var_5);
    var_7 = 0.5;
    var_8 = wp::mul(var_6, var_7);
    // mixed = dot(u, av)                                                                     <L 8>
    var_9 = wp::dot(var_0, var_3);
    // size = max(abs(half), abs(mixed))                                                      <L 9>
    var_10 = wp::abs(var_8);
    var_11 = wp::abs(var_9);
    var_12 = wp::max(var_10, var_11);
    // x = float64(0.0)                                                                       <L 10>
    var_13 = 0.0;
    // y = float64(-1.0)                                                                      <L 11>
    var_14 = -1.0;
    // if size > float64(0.0):                                                                <L 12>
    var_15 = 0.0;
    var_16 = (var_12 > var_15);
    if (var_16) {
        // half = half / size                                                                 <L 13>
        var_17 = wp::div(var_8, var_12);
        // mixed = mixed / size                                                               <L 14>
        var_18 = wp::div(var_9, var_12);
        // larger = abs(half) + sqrt(half * half + mixed * mixed)                             <L 15>
        var_19 = wp::abs(var_17);
        var_20 = wp::mul(var_17, var_17);
        var_21 = wp::mul(var_18, var_18);
        var_22 = wp::add(var_20, var_21);
        var_23 = wp::sqrt(var_22);
        var_24 = wp::add(var_19, var_23);
        // if half > float64(0.0):                                                            <L 16>
        var_25 = 0.0;
        var_26 = (var_17 > var_25);
        if (var_26) {
            // x = mixed                                                                      <L 17>
            var_27 = wp::copy(var_18);
            // y = -larger                                                                    <L 18>
            var_28 = wp::neg(var_24);
        }
        if (!var_26) {
            // x = -larger                                                                    <L 20>
            var_29 = wp::neg(var_24);
            // y = mixed                                                                      <L 21>
            var_30 = wp::copy(var_18);
        }
        var_31 = wp::where(var_26, var_27, var_29);
        var_32 = wp::where(var_26, var_28, var_30);
        // length = sqrt(x * x + y * y)                                                       <L 22>
        var_33 = wp::mul(var_31, var_31);
        var_34 = wp::mul(var_32, var_32);
        var_35 = wp::add(var_33, var_34);
        var_36 = wp::sqrt(var_35);
        // x = x / length                                                                     <L 23>
        var_37 = wp::div(var_31, var_36);
        // y = y / length                                                                     <L 24>
        var_38 = wp::div(var_32, var_36);
    }
    var_39 = wp::where(var_16, var_17, var_8);
    var_40 = wp::where(var_16, var_18, var_9);
    var_41 = wp::where(var_16, var_37, var_13);
    var_42 = wp::where(var_16, var_38, var_14);
    // return u * x + v * y                                                                   <L 25>
    var_43 = wp::mul(var_0, var_41);
    var_44 = wp::mul(var_1, var_42);
    var_45 = wp::add(var_43, var_44);
    return var_45;
}


// <pointloom.kernels.algebra.eigen.smallest_eigenvector>:1
static CUDA_CALLABLE wp::vec_t<3, wp::float64> smallest_eigenvector_0(
    wp::mat_t<3, 3, wp::float64> var_covariance)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::float64 var_1;
    wp::float64 var_2;
    wp::vec_t<3, wp::float64> var_3;
    wp::float64 var_4;
    wp::float64 var_5;
    bool var_6;
    wp::float64 var_7;
    wp::float64 var_8;
    wp::mat_t<3, 3, wp::float64> var_9;
    wp::float64 var_10;
    wp::float64 var_11;
    bool var_12;
    wp::vec_t<3, wp::float64> var_13;
    const wp::int32 var_14 = 1;
    wp::float64 var_15;
    const wp::int32 var_16 = 0;
    wp::float64 var_17;
    wp::float64 var_18;
    const wp::int32 var_19 = 2;
    wp::float64 var_20;
    const wp::int32 var_21 = 1;
    wp::float64 var_22;
    wp::float64 var_23;
    bool var_24;
    const wp::int32 var_25 = 0;
    wp::float64 var_26;
    wp::vec_t<3, wp::float64> var_27;
    const wp::int32 var_28 = 2;
    wp::float64 var_29;
    wp::vec_t<3, wp::float64> var_30;
    wp::vec_t<3, wp::float64> var_31;
    wp::vec_t<3, wp::float64> var_32;
    bool var_33;
    const wp::int32 var_34 = 0;
    const wp::int32 var_35 = 0;
    wp::float64 var_36;
    const wp::int32 var_37 = 2;
    const wp::int32 var_38 = 2;
    wp::float64 var_39;
    bool var_40;
    const wp::int32 var_41 = 0;
    const wp::int32 var_42 = 0;
    wp::float64 var_43;
    const wp::int32 var_44 = 1;
    const wp::int32 var_45 = 1;
    wp::float64 var_46;
    bool var_47;
    wp::float64 var_48;
    wp::float64 var_49;
    wp::float64 var_50;
    wp::vec_t<3, wp::float64> var_51;
    wp::vec_t<3, wp::float64> var_52;
    bool var_53;
    const wp::int32 var_54 = 1;
    const wp::int32 var_55 = 1;
    wp::float64 var_56;
    const wp::int32 var_57 = 2;
    const wp::int32 var_58 = 2;
    wp::float64 var_59;
    bool var_60;
    const wp::int32 var_61 = 1;
    const wp::int32 var_62 = 1;
    wp::float64 var_63;
    const wp::int32 var_64 = 0;
    const wp::int32 var_65 = 0;
    wp::float64 var_66;
    bool var_67;
    wp::float64 var_68;
    wp::float64 var_69;
    wp::float64 var_70;
    wp::vec_t<3, wp::float64> var_71;
    wp::vec_t<3, wp::float64> var_72;
    wp::vec_t<3, wp::float64> var_73;
    wp::vec_t<3, wp::float64> var_74;
    //---------
    // forward
    // def smallest_eigenvector(covariance):                                                  <L 1>
    // result = vec3d(float64(0.0), float64(0.0), float64(1.0))                               <L 3>
    var_0 = 0.0;
    var_1 = 0.0;
    var_2 = 1.0;
    var_3 = wp::vec_t<3, wp::float64>(var_0, var_1, var_2);
    // size = largest_entry(covariance)                                                       <L 4>
    var_4 = largest_entry_0(var_covariance);
    // if size > float64(0.0):                                                                <L 5>
    var_5 = 0.0;
    var_6 = (var_4 > var_5);
    if (var_6) {
        // a = covariance * (float64(1.0) / size)                                             <L 6>
        var_7 = 1.0;
        var_8 = wp::div(var_7, var_4);
        var_9 = wp::mul(var_covariance, var_8);
        // if off_diagonal(a) > float64(0.0):                                                 <L 7>
        var_10 = off_diagonal_0(var_9);
        var_11 = 0.0;
        var_12 = (var_10 > var_11);
        if (var_12) {
            // values = sorted_eigenvalues(a)                                                 <L 8>
            var_13 = sorted_eigenvalues_0(var_9);
            // if values[1] - values[0] >= values[2] - values[1]:                             <L 9>
            var_15 = wp::extract(var_13, var_14);
            var_17 = wp::extract(var_13, var_16);
            var_18 = wp::sub(var_15, var_17);
            var_20 = wp::extract(var_13, var_19);
            var_22 = wp::extract(var_13, var_21);
            var_23 = wp::sub(var_20, var_22);
            var_24 = (var_18 >= var_23);
            if (var_24) {
                // result = separated_eigenvector(a, values[0])                               <L 10>
                var_26 = wp::extract(var_13, var_25);
                var_27 = separated_eigenvector_0(var_9, var_26);
            }
            if (!var_24) {
                // result = smallest_in_plane(a, separated_eigenvector(a, values[2]))         <L 12>
                var_29 = wp::extract(var_13, var_28);
                var_30 = separated_eigenvector_0(var_9, var_29);
                var_31 = smallest_in_plane_0(var_9, var_30);
            }
            var_32 = wp::where(var_24, var_27, var_31);
        }
        if (!var_12) {
            // if a[0, 0] < a[2, 2] and a[0, 0] <= a[1, 1]:                                   <L 14>
            var_36 = wp::extract(var_9, var_34, var_35);
            var_39 = wp::extract(var_9, var_37, var_38);
            var_40 = (var_36 < var_39);
            var_33 = var_40;
            if (var_33) {
                var_43 = wp::extract(var_9, var_41, var_42);
                var_46 = wp::extract(var_9, var_44, var_45);
                var_47 = (var_43 <= var_46);
                var_33 = var_33 && var_47;
            }
            if (var_33) {
                // result = vec3d(float64(1.0), float64(0.0), float64(0.0))                   <L 15>
                var_48 = 1.0;
                var_49 = 0.0;
                var_50 = 0.0;
                var_51 = wp::vec_t<3, wp::float64>(var_48, var_49, var_50);
            }
            var_52 = wp::where(var_33, var_51, var_3);
            // if a[1, 1] < a[2, 2] and a[1, 1] < a[0, 0]:                                    <L 16>
            var_56 = wp::extract(var_9, var_54, var_55);
            var_59 = wp::extract(var_9, var_57, var_58);
            var_60 = (var_56 < var_59);
            var_53 = var_60;
            if (var_53) {
                var_63 = wp::extract(var_9, var_61, var_62);
                var_66 = wp::extract(var_9, var_64, var_65);
                var_67 = (var_63 < var_66);
                var_53 = var_53 && var_67;
            }
            if (var_53) {
                // result = vec3d(float64(0.0), float64(1.0), float64(0.0))                   <L 17>
                var_68 = 0.0;
                var_69 = 1.0;
                var_70 = 0.0;
                var_71 = wp::vec_t<3, wp::float64>(var_68, var_69, var_70);
            }
            var_72 = wp::where(var_53, var_71, var_52);
        }
        var_73 = wp::where(var_12, var_32, var_72);
    }
    var_74 = wp::where(var_6, var_73, var_3);
    // return result                                                                          <L 18>
    return var_74;
}


// <pointloom.kernels.search.bucket_walk.start_traversal>:1
static CUDA_CALLABLE void adj_start_traversal_0(
    wp::int32 var_bucket,
    wp::int32 & adj_bucket,
    wp::vec_t<4, wp::int64> & adj_ret)
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


// <pointloom.kernels.algebra.moments.add_rounded_difference>:1
static CUDA_CALLABLE void adj_add_rounded_difference_0(
    wp::vec_t<10, wp::float64> var_total,
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> var_q,
    wp::vec_t<10, wp::float64> & adj_total,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float32> & adj_q,
    wp::vec_t<10, wp::float64> & adj_ret)
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


// <pointloom.kernels.algebra.moments.covariance_of>:1
static CUDA_CALLABLE void adj_covariance_of_0(
    wp::vec_t<10, wp::float64> var_m,
    wp::vec_t<10, wp::float64> & adj_m,
    wp::mat_t<3, 3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/algebra/eigen.py:14
static CUDA_CALLABLE void adj_largest_entry_0(
    wp::mat_t<3, 3, wp::float64> var_a,
    wp::mat_t<3, 3, wp::float64> & adj_a,
    wp::float64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/algebra/eigen.py:20
static CUDA_CALLABLE void adj_off_diagonal_0(
    wp::mat_t<3, 3, wp::float64> var_a,
    wp::mat_t<3, 3, wp::float64> & adj_a,
    wp::float64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.algebra.eigen.sorted_eigenvalues>:1
static CUDA_CALLABLE void adj_sorted_eigenvalues_0(
    wp::mat_t<3, 3, wp::float64> var_a,
    wp::mat_t<3, 3, wp::float64> & adj_a,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.algebra.eigen.separated_eigenvector>:1
static CUDA_CALLABLE void adj_separated_eigenvector_0(
    wp::mat_t<3, 3, wp::float64> var_a,
    wp::float64 var_value,
    wp::mat_t<3, 3, wp::float64> & adj_a,
    wp::float64 & adj_value,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.algebra.eigen.orthogonal_direction>:1
static CUDA_CALLABLE void adj_orthogonal_direction_0(
    wp::vec_t<3, wp::float64> var_w,
    wp::vec_t<3, wp::float64> & adj_w,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.algebra.eigen.smallest_in_plane>:1
static CUDA_CALLABLE void adj_smallest_in_plane_0(
    wp::mat_t<3, 3, wp::float64> var_a,
    wp::vec_t<3, wp::float64> var_w,
    wp::mat_t<3, 3, wp::float64> & adj_a,
    wp::vec_t<3, wp::float64> & adj_w,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.algebra.eigen.smallest_eigenvector>:1
static CUDA_CALLABLE void adj_smallest_eigenvector_0(
    wp::mat_t<3, 3, wp::float64> var_covariance,
    wp::mat_t<3, 3, wp::float64> & adj_covariance,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void WP_MAXNREG(128) find_sides_kernel_fcd450ae_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::int32 var_tree__count,
    wp::int32 var_tree__root,
    wp::array_t<wp::int32> var_tree__levels,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> var_tree__points,
    wp::array_t<wp::int32> var_tree__order,
    wp::float32 var_narrow,
    wp::float32 var_wide,
    wp::array_t<wp::vec_t<3, wp::float32>> var_normals)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::vec_t<3, wp::float32>* var_1;
        wp::vec_t<3, wp::float32> var_2;
        wp::vec_t<3, wp::float32> var_3;
        wp::float64 var_4;
        wp::vec_t<10, wp::float64> var_5;
        wp::float64 var_6;
        wp::float64 var_7;
        wp::float64 var_8;
        wp::vec_t<3, wp::float64> var_9;
        const wp::int32 var_10 = 64;
        wp::int32 var_11;
        wp::vec_t<4, wp::int64> var_12;
        const wp::int32 var_13 = 0;
        wp::int64 var_14;
        wp::int32 var_15;
        bool var_16;
        const wp::int32 var_17 = 2;
        wp::int64 var_18;
        wp::int32 var_19;
        wp::vec_t<8, wp::float32> var_20;
        const wp::int32 var_21 = 0;
        wp::float32 var_22;
        bool var_23;
        const wp::int32 var_24 = 64;
        wp::int32 var_25;
        const wp::int32 var_26 = 8;
        wp::int32 var_27;
        wp::int32 var_28;
        const wp::int32 var_29 = 8;
        wp::int32 var_30;
        wp::int32 var_31;
        wp::range_t var_32;
        wp::int32 var_33;
        wp::vec_t<3, wp::float32>* var_34;
        wp::float32 var_35;
        wp::vec_t<3, wp::float32> var_36;
        bool var_37;
        wp::vec_t<3, wp::float32>* var_38;
        wp::vec_t<3, wp::float32> var_39;
        wp::vec_t<3, wp::float32> var_40;
        const wp::int32 var_41 = 0;
        wp::float32 var_42;
        const wp::int32 var_43 = 0;
        wp::float32 var_44;
        wp::float32 var_45;
        wp::float64 var_46;
        const wp::int32 var_47 = 1;
        wp::float32 var_48;
        const wp::int32 var_49 = 1;
        wp::float32 var_50;
        wp::float32 var_51;
        wp::float64 var_52;
        const wp::int32 var_53 = 2;
        wp::float32 var_54;
        const wp::int32 var_55 = 2;
        wp::float32 var_56;
        wp::float32 var_57;
        wp::float64 var_58;
        wp::vec_t<3, wp::float64> var_59;
        wp::vec_t<3, wp::float64> var_60;
        bool var_61;
        wp::vec_t<10, wp::float64> var_62;
        wp::vec_t<10, wp::float64> var_63;
        wp::vec_t<10, wp::float64> var_64;
        wp::vec_t<3, wp::float64> var_65;
        const wp::int32 var_66 = 1;
        wp::float32 var_67;
        bool var_68;
        wp::int32 var_69;
        wp::int32 var_70;
        wp::int32 var_71;
        wp::int32 var_72;
        wp::int32 var_73;
        wp::range_t var_74;
        wp::int32 var_75;
        wp::vec_t<3, wp::float32>* var_76;
        wp::float32 var_77;
        wp::vec_t<3, wp::float32> var_78;
        bool var_79;
        wp::vec_t<3, wp::float32>* var_80;
        wp::vec_t<3, wp::float32> var_81;
        wp::vec_t<3, wp::float32> var_82;
        const wp::int32 var_83 = 0;
        wp::float32 var_84;
        const wp::int32 var_85 = 0;
        wp::float32 var_86;
        wp::float32 var_87;
        wp::float64 var_88;
        const wp::int32 var_89 = 1;
        wp::float32 var_90;
        const wp::int32 var_91 = 1;
        wp::float32 var_92;
        wp::float32 var_93;
        wp::float64 var_94;
        const wp::int32 var_95 = 2;
        wp::float32 var_96;
        const wp::int32 var_97 = 2;
        wp::float32 var_98;
        wp::float32 var_99;
        wp::float64 var_100;
        wp::vec_t<3, wp::float64> var_101;
        wp::vec_t<3, wp::float64> var_102;
        bool var_103;
        wp::vec_t<10, wp::float64> var_104;
        wp::vec_t<10, wp::float64> var_105;
        wp::vec_t<10, wp::float64> var_106;
        wp::vec_t<3, wp::float64> var_107;
        wp::vec_t<3, wp::float32> var_108;
        wp::int32 var_109;
        wp::int32 var_110;
        const wp::int32 var_111 = 2;
        wp::float32 var_112;
        bool var_113;
        wp::int32 var_114;
        wp::int32 var_115;
        wp::int32 var_116;
        wp::int32 var_117;
        wp::int32 var_118;
        wp::range_t var_119;
        wp::int32 var_120;
        wp::vec_t<3, wp::float32>* var_121;
        wp::float32 var_122;
        wp::vec_t<3, wp::float32> var_123;
        bool var_124;
        wp::vec_t<3, wp::float32>* var_125;
        wp::vec_t<3, wp::float32> var_126;
        wp::vec_t<3, wp::float32> var_127;
        const wp::int32 var_128 = 0;
        wp::float32 var_129;
        const wp::int32 var_130 = 0;
        wp::float32 var_131;
        wp::float32 var_132;
        wp::float64 var_133;
        const wp::int32 var_134 = 1;
        wp::float32 var_135;
        const wp::int32 var_136 = 1;
        wp::float32 var_137;
        wp::float32 var_138;
        wp::float64 var_139;
        const wp::int32 var_140 = 2;
        wp::float32 var_141;
        const wp::int32 var_142 = 2;
        wp::float32 var_143;
        wp::float32 var_144;
        wp::float64 var_145;
        wp::vec_t<3, wp::float64> var_146;
        wp::vec_t<3, wp::float64> var_147;
        bool var_148;
        wp::vec_t<10, wp::float64> var_149;
        wp::vec_t<10, wp::float64> var_150;
        wp::vec_t<10, wp::float64> var_151;
        wp::vec_t<3, wp::float64> var_152;
        wp::vec_t<3, wp::float32> var_153;
        wp::int32 var_154;
        wp::int32 var_155;
        const wp::int32 var_156 = 3;
        wp::float32 var_157;
        bool var_158;
        wp::int32 var_159;
        wp::int32 var_160;
        wp::int32 var_161;
        wp::int32 var_162;
        wp::int32 var_163;
        wp::range_t var_164;
        wp::int32 var_165;
        wp::vec_t<3, wp::float32>* var_166;
        wp::float32 var_167;
        wp::vec_t<3, wp::float32> var_168;
        bool var_169;
        wp::vec_t<3, wp::float32>* var_170;
        wp::vec_t<3, wp::float32> var_171;
        wp::vec_t<3, wp::float32> var_172;
        const wp::int32 var_173 = 0;
        wp::float32 var_174;
        const wp::int32 var_175 = 0;
        wp::float32 var_176;
        wp::float32 var_177;
        wp::float64 var_178;
        const wp::int32 var_179 = 1;
        wp::float32 var_180;
        const wp::int32 var_181 = 1;
        wp::float32 var_182;
        wp::float32 var_183;
        wp::float64 var_184;
        const wp::int32 var_185 = 2;
        wp::float32 var_186;
        const wp::int32 var_187 = 2;
        wp::float32 var_188;
        wp::float32 var_189;
        wp::float64 var_190;
        wp::vec_t<3, wp::float64> var_191;
        wp::vec_t<3, wp::float64> var_192;
        bool var_193;
        wp::vec_t<10, wp::float64> var_194;
        wp::vec_t<10, wp::float64> var_195;
        wp::vec_t<10, wp::float64> var_196;
        wp::vec_t<3, wp::float64> var_197;
        wp::vec_t<3, wp::float32> var_198;
        wp::int32 var_199;
        wp::int32 var_200;
        const wp::int32 var_201 = 4;
        wp::float32 var_202;
        bool var_203;
        wp::int32 var_204;
        wp::int32 var_205;
        wp::int32 var_206;
        wp::int32 var_207;
        wp::int32 var_208;
        wp::range_t var_209;
        wp::int32 var_210;
        wp::vec_t<3, wp::float32>* var_211;
        wp::float32 var_212;
        wp::vec_t<3, wp::float32> var_213;
        bool var_214;
        wp::vec_t<3, wp::float32>* var_215;
        wp::vec_t<3, wp::float32> var_216;
        wp::vec_t<3, wp::float32> var_217;
        const wp::int32 var_218 = 0;
        wp::float32 var_219;
        const wp::int32 var_220 = 0;
        wp::float32 var_221;
        wp::float32 var_222;
        wp::float64 var_223;
        const wp::int32 var_224 = 1;
        wp::float32 var_225;
        const wp::int32 var_226 = 1;
        wp::float32 var_227;
        wp::float32 var_228;
        wp::float64 var_229;
        const wp::int32 var_230 = 2;
        wp::float32 var_231;
        const wp::int32 var_232 = 2;
        wp::float32 var_233;
        wp::float32 var_234;
        wp::float64 var_235;
        wp::vec_t<3, wp::float64> var_236;
        wp::vec_t<3, wp::float64> var_237;
        bool var_238;
        wp::vec_t<10, wp::float64> var_239;
        wp::vec_t<10, wp::float64> var_240;
        wp::vec_t<10, wp::float64> var_241;
        wp::vec_t<3, wp::float64> var_242;
        wp::vec_t<3, wp::float32> var_243;
        wp::int32 var_244;
        wp::int32 var_245;
        const wp::int32 var_246 = 5;
        wp::float32 var_247;
        bool var_248;
        wp::int32 var_249;
        wp::int32 var_250;
        wp::int32 var_251;
        wp::int32 var_252;
        wp::int32 var_253;
        wp::range_t var_254;
        wp::int32 var_255;
        wp::vec_t<3, wp::float32>* var_256;
        wp::float32 var_257;
        wp::vec_t<3, wp::float32> var_258;
        bool var_259;
        wp::vec_t<3, wp::float32>* var_260;
        wp::vec_t<3, wp::float32> var_261;
        wp::vec_t<3, wp::float32> var_262;
        const wp::int32 var_263 = 0;
        wp::float32 var_264;
        const wp::int32 var_265 = 0;
        wp::float32 var_266;
        wp::float32 var_267;
        wp::float64 var_268;
        const wp::int32 var_269 = 1;
        wp::float32 var_270;
        const wp::int32 var_271 = 1;
        wp::float32 var_272;
        wp::float32 var_273;
        wp::float64 var_274;
        const wp::int32 var_275 = 2;
        wp::float32 var_276;
        const wp::int32 var_277 = 2;
        wp::float32 var_278;
        wp::float32 var_279;
        wp::float64 var_280;
        wp::vec_t<3, wp::float64> var_281;
        wp::vec_t<3, wp::float64> var_282;
        bool var_283;
        wp::vec_t<10, wp::float64> var_284;
        wp::vec_t<10, wp::float64> var_285;
        wp::vec_t<10, wp::float64> var_286;
        wp::vec_t<3, wp::float64> var_287;
        wp::vec_t<3, wp::float32> var_288;
        wp::int32 var_289;
        wp::int32 var_290;
        const wp::int32 var_291 = 6;
        wp::float32 var_292;
        bool var_293;
        wp::int32 var_294;
        wp::int32 var_295;
        wp::int32 var_296;
        wp::int32 var_297;
        wp::int32 var_298;
        wp::range_t var_299;
        wp::int32 var_300;
        wp::vec_t<3, wp::float32>* var_301;
        wp::float32 var_302;
        wp::vec_t<3, wp::float32> var_303;
        bool var_304;
        wp::vec_t<3, wp::float32>* var_305;
        wp::vec_t<3, wp::float32> var_306;
        wp::vec_t<3, wp::float32> var_307;
        const wp::int32 var_308 = 0;
        wp::float32 var_309;
        const wp::int32 var_310 = 0;
        wp::float32 var_311;
        wp::float32 var_312;
        wp::float64 var_313;
        const wp::int32 var_314 = 1;
        wp::float32 var_315;
        const wp::int32 var_316 = 1;
        wp::float32 var_317;
        wp::float32 var_318;
        wp::float64 var_319;
        const wp::int32 var_320 = 2;
        wp::float32 var_321;
        const wp::int32 var_322 = 2;
        wp::float32 var_323;
        wp::float32 var_324;
        wp::float64 var_325;
        wp::vec_t<3, wp::float64> var_326;
        wp::vec_t<3, wp::float64> var_327;
        bool var_328;
        wp::vec_t<10, wp::float64> var_329;
        wp::vec_t<10, wp::float64> var_330;
        wp::vec_t<10, wp::float64> var_331;
        wp::vec_t<3, wp::float64> var_332;
        wp::vec_t<3, wp::float32> var_333;
        wp::int32 var_334;
        wp::int32 var_335;
        const wp::int32 var_336 = 7;
        wp::float32 var_337;
        bool var_338;
        wp::int32 var_339;
        wp::int32 var_340;
        wp::int32 var_341;
        wp::int32 var_342;
        wp::int32 var_343;
        wp::range_t var_344;
        wp::int32 var_345;
        wp::vec_t<3, wp::float32>* var_346;
        wp::float32 var_347;
        wp::vec_t<3, wp::float32> var_348;
        bool var_349;
        wp::vec_t<3, wp::float32>* var_350;
        wp::vec_t<3, wp::float32> var_351;
        wp::vec_t<3, wp::float32> var_352;
        const wp::int32 var_353 = 0;
        wp::float32 var_354;
        const wp::int32 var_355 = 0;
        wp::float32 var_356;
        wp::float32 var_357;
        wp::float64 var_358;
        const wp::int32 var_359 = 1;
        wp::float32 var_360;
        const wp::int32 var_361 = 1;
        wp::float32 var_362;
        wp::float32 var_363;
        wp::float64 var_364;
        const wp::int32 var_365 = 2;
        wp::float32 var_366;
        const wp::int32 var_367 = 2;
        wp::float32 var_368;
        wp::float32 var_369;
        wp::float64 var_370;
        wp::vec_t<3, wp::float64> var_371;
        wp::vec_t<3, wp::float64> var_372;
        bool var_373;
        wp::vec_t<10, wp::float64> var_374;
        wp::vec_t<10, wp::float64> var_375;
        wp::vec_t<10, wp::float64> var_376;
        wp::vec_t<3, wp::float64> var_377;
        wp::vec_t<3, wp::float32> var_378;
        wp::int32 var_379;
        wp::int32 var_380;
        wp::vec_t<4, wp::int64> var_381;
        const wp::float32 var_382 = NAN;
        wp::vec_t<3, wp::float32> var_383;
        const wp::int32 var_384 = 0;
        wp::float64 var_385;
        wp::float64 var_386;
        bool var_387;
        wp::mat_t<3, 3, wp::float64> var_388;
        wp::float64 var_389;
        wp::float64 var_390;
        bool var_391;
        wp::float64 var_392;
        wp::float64 var_393;
        wp::mat_t<3, 3, wp::float64> var_394;
        wp::vec_t<3, wp::float64> var_395;
        const wp::int32 var_396 = 1;
        wp::float64 var_397;
        wp::float64 var_398;
        const wp::int32 var_399 = 2;
        wp::float64 var_400;
        wp::float64 var_401;
        bool var_402;
        wp::vec_t<3, wp::float64> var_403;
        const wp::int32 var_404 = 0;
        wp::float64 var_405;
        const wp::int32 var_406 = 0;
        wp::float64 var_407;
        wp::float64 var_408;
        const wp::int32 var_409 = 1;
        wp::float64 var_410;
        const wp::int32 var_411 = 1;
        wp::float64 var_412;
        wp::float64 var_413;
        wp::float64 var_414;
        const wp::int32 var_415 = 2;
        wp::float64 var_416;
        const wp::int32 var_417 = 2;
        wp::float64 var_418;
        wp::float64 var_419;
        wp::float64 var_420;
        wp::float64 var_421;
        bool var_422;
        wp::vec_t<3, wp::float64> var_423;
        wp::vec_t<3, wp::float64> var_424;
        const wp::int32 var_425 = 0;
        wp::float64 var_426;
        wp::float32 var_427;
        const wp::int32 var_428 = 1;
        wp::float64 var_429;
        wp::float32 var_430;
        const wp::int32 var_431 = 2;
        wp::float64 var_432;
        wp::float32 var_433;
        wp::vec_t<3, wp::float32> var_434;
        wp::vec_t<3, wp::float32> var_435;
        wp::vec_t<3, wp::float32> var_436;
        wp::vec_t<3, wp::float32> var_437;
        wp::int32* var_438;
        wp::int32 var_439;
        //---------
        // forward
        // def find_sides_kernel(tree__count, tree__root, tree__levels, tree__boxes, tree__points, tree__order, narrow, wide, normals):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // p = tree__points[i]                                                                    <L 4>
        var_1 = wp::address(var_tree__points, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // total = moments(float64(0.0))                                                          <L 5>
        var_4 = 0.0;
        var_5 = wp::vec_t<10, wp::float64>(var_4);
        // middle = vec3d(float64(0.0), float64(0.0), float64(0.0))                               <L 6>
        var_6 = 0.0;
        var_7 = 0.0;
        var_8 = 0.0;
        var_9 = wp::vec_t<3, wp::float64>(var_6, var_7, var_8);
        // start__points_within__1 = i // BUCKET                                                  <L 7>
        var_11 = wp::floordiv(var_0, var_10);
        // step__leaves_within__2 = start_traversal__leaves_within(start__points_within__1)       <L 8>
        var_12 = start_traversal_0(var_11);
        // while int(step__leaves_within__2[0]) <= tree__root:                                    <L 9>
        start_while_0:;
        var_14 = wp::extract(var_12, var_13);
        var_15 = wp::int(var_14);
        var_16 = (var_15 <= var_tree__root);
        if ((var_16) == false) goto end_while_0;
            // bucket__leaves_within__2 = int(step__leaves_within__2[2])                          <L 10>
            var_18 = wp::extract(var_12, var_17);
            var_19 = wp::int(var_18);
            // distances__leaves_within__2 = measure_boxes__leaves_within(tree__boxes, bucket__leaves_within__2, p, p)       <L 11>
            var_20 = measure_boxes_0(var_tree__boxes, var_19, var_2, var_2);
            // for leaf__leaves_within__2 in range(FAN__leaves_within):                           <L 12>
            // if distances__leaves_within__2[leaf__leaves_within__2] <= wide:                    <L 13>
            var_22 = wp::extract(var_20, var_21);
            var_23 = (var_22 <= var_wide);
            if (var_23) {
                // first__points_within__1 = bucket__leaves_within__2 * BUCKET__leaves_within + leaf__leaves_within__2 * LEAF__leaves_within       <L 14>
                var_25 = wp::mul(var_19, var_24);
                var_27 = wp::mul(var_21, var_26);
                var_28 = wp::add(var_25, var_27);
                // for j in range(first__points_within__1, min(first__points_within__1 + LEAF__points_within, tree__count)):       <L 15>
                var_30 = wp::add(var_28, var_29);
                var_31 = wp::min(var_30, var_tree__count);
                var_32 = wp::range(var_28, var_31);
                start_for_2:;
                    if (iter_cmp(var_32) == 0) goto end_for_2;
                    var_33 = wp::iter_next(var_32);
                    // sqdist = square_distance__points_within(p, tree__points[j])                <L 16>
                    var_34 = wp::address(var_tree__points, var_33);
                    var_36 = wp::load(var_34);
                    var_35 = square_distance_0(var_2, var_36);
                    // if sqdist <= wide:                                                         <L 17>
                    var_37 = (var_35 <= var_wide);
                    if (var_37) {
                        // q = tree__points[j]                                                    <L 18>
                        var_38 = wp::address(var_tree__points, var_33);
                        var_40 = wp::load(var_38);
                        var_39 = wp::copy(var_40);
                        // middle += vec3d(float64(q[0] - p[0]), float64(q[1] - p[1]), float64(q[2] - p[2]))       <L 19>
                        var_42 = wp::extract(var_39, var_41);
                        var_44 = wp::extract(var_2, var_43);
                        var_45 = wp::sub(var_42, var_44);
                        var_46 = wp::float64(var_45);
                        var_48 = wp::extract(var_39, var_47);
                        var_50 = wp::extract(var_2, var_49);
                        var_51 = wp::sub(var_48, var_50);
                        var_52 = wp::float64(var_51);
                        var_54 = wp::extract(var_39, var_53);
                        var_56 = wp::extract(var_2, var_55);
                        var_57 = wp::sub(var_54, var_56);
                        var_58 = wp::float64(var_57);
                        var_59 = wp::vec_t<3, wp::float64>(var_46, var_52, var_58);
                        var_60 = wp::add(var_9, var_59);
                        // if sqdist <= narrow:                                                   <L 20>
                        var_61 = (var_35 <= var_narrow);
                        if (var_61) {
                            // total = add_rounded_difference(total, p, q)                        <L 21>
                            var_62 = add_rounded_difference_0(var_5, var_2, var_39);
                        }
                        var_63 = wp::where(var_61, var_62, var_5);
                    }
                    var_64 = wp::where(var_37, var_63, var_5);
                    var_65 = wp::where(var_37, var_60, var_9);
                    wp::assign(var_5, var_64);
                    wp::assign(var_9, var_65);
                    goto start_for_2;
                end_for_2:;
            }
            // if distances__leaves_within__2[leaf__leaves_within__2] <= wide:                    <L 13>
            var_67 = wp::extract(var_20, var_66);
            var_68 = (var_67 <= var_wide);
            if (var_68) {
                // first__points_within__1 = bucket__leaves_within__2 * BUCKET__leaves_within + leaf__leaves_within__2 * LEAF__leaves_within       <L 14>
                var_69 = wp::mul(var_19, var_24);
                var_70 = wp::mul(var_66, var_26);
                var_71 = wp::add(var_69, var_70);
                // for j in range(first__points_within__1, min(first__points_within__1 + LEAF__points_within, tree__count)):       <L 15>
                var_72 = wp::add(var_71, var_29);
                var_73 = wp::min(var_72, var_tree__count);
                var_74 = wp::range(var_71, var_73);
                start_for_4:;
                    if (iter_cmp(var_74) == 0) goto end_for_4;
                    var_75 = wp::iter_next(var_74);
                    // sqdist = square_distance__points_within(p, tree__points[j])                <L 16>
                    var_76 = wp::address(var_tree__points, var_75);
                    var_78 = wp::load(var_76);
                    var_77 = square_distance_0(var_2, var_78);
                    // if sqdist <= wide:                                                         <L 17>
                    var_79 = (var_77 <= var_wide);
                    if (var_79) {
                        // q = tree__points[j]                                                    <L 18>
                        var_80 = wp::address(var_tree__points, var_75);
                        var_82 = wp::load(var_80);
                        var_81 = wp::copy(var_82);
                        // middle += vec3d(float64(q[0] - p[0]), float64(q[1] - p[1]), float64(q[2] - p[2]))       <L 19>
                        var_84 = wp::extract(var_81, var_83);
                        var_86 = wp::extract(var_2, var_85);
                        var_87 = wp::sub(var_84, var_86);
                        var_88 = wp::float64(var_87);
                        var_90 = wp::extract(var_81, var_89);
                        var_92 = wp::extract(var_2, var_91);
                        var_93 = wp::sub(var_90, var_92);
                        var_94 = wp::float64(var_93);
                        var_96 = wp::extract(var_81, var_95);
                        var_98 = wp::extract(var_2, var_97);
                        var_99 = wp::sub(var_96, var_98);
                        var_100 = wp::float64(var_99);
                        var_101 = wp::vec_t<3, wp::float64>(var_88, var_94, var_100);
                        var_102 = wp::add(var_9, var_101);
                        // if sqdist <= narrow:                                                   <L 20>
                        var_103 = (var_77 <= var_narrow);
                        if (var_103) {
                            // total = add_rounded_difference(total, p, q)                        <L 21>
                            var_104 = add_rounded_difference_0(var_5, var_2, var_81);
                        }
                        var_105 = wp::where(var_103, var_104, var_5);
                    }
                    var_106 = wp::where(var_79, var_105, var_5);
                    var_107 = wp::where(var_79, var_102, var_9);
                    var_108 = wp::where(var_79, var_81, var_39);
                    wp::assign(var_5, var_106);
                    wp::assign(var_9, var_107);
                    wp::assign(var_35, var_77);
                    wp::assign(var_39, var_108);
                    goto start_for_4;
                end_for_4:;
            }
            var_109 = wp::where(var_68, var_71, var_28);
            var_110 = wp::where(var_68, var_75, var_33);
            // if distances__leaves_within__2[leaf__leaves_within__2] <= wide:                    <L 13>
            var_112 = wp::extract(var_20, var_111);
            var_113 = (var_112 <= var_wide);
            if (var_113) {
                // first__points_within__1 = bucket__leaves_within__2 * BUCKET__leaves_within + leaf__leaves_within__2 * LEAF__leaves_within       <L 14>
                var_114 = wp::mul(var_19, var_24);
                var_115 = wp::mul(var_111, var_26);
                var_116 = wp::add(var_114, var_115);
                // for j in range(first__points_within__1, min(first__points_within__1 + LEAF__points_within, tree__count)):       <L 15>
                var_117 = wp::add(var_116, var_29);
                var_118 = wp::min(var_117, var_tree__count);
                var_119 = wp::range(var_116, var_118);
                start_for_6:;
                    if (iter_cmp(var_119) == 0) goto end_for_6;
                    var_120 = wp::iter_next(var_119);
                    // sqdist = square_distance__points_within(p, tree__points[j])                <L 16>
                    var_121 = wp::address(var_tree__points, var_120);
                    var_123 = wp::load(var_121);
                    var_122 = square_distance_0(var_2, var_123);
                    // if sqdist <= wide:                                                         <L 17>
                    var_124 = (var_122 <= var_wide);
                    if (var_124) {
                        // q = tree__points[j]                                                    <L 18>
                        var_125 = wp::address(var_tree__points, var_120);
                        var_127 = wp::load(var_125);
                        var_126 = wp::copy(var_127);
                        // middle += vec3d(float64(q[0] - p[0]), float64(q[1] - p[1]), float64(q[2] - p[2]))       <L 19>
                        var_129 = wp::extract(var_126, var_128);
                        var_131 = wp::extract(var_2, var_130);
                        var_132 = wp::sub(var_129, var_131);
                        var_133 = wp::float64(var_132);
                        var_135 = wp::extract(var_126, var_134);
                        var_137 = wp::extract(var_2, var_136);
                        var_138 = wp::sub(var_135, var_137);
                        var_139 = wp::float64(var_138);
                        var_141 = wp::extract(var_126, var_140);
                        var_143 = wp::extract(var_2, var_142);
                        var_144 = wp::sub(var_141, var_143);
                        var_145 = wp::float64(var_144);
                        var_146 = wp::vec_t<3, wp::float64>(var_133, var_139, var_145);
                        var_147 = wp::add(var_9, var_146);
                        // if sqdist <= narrow:                                                   <L 20>
                        var_148 = (var_122 <= var_narrow);
                        if (var_148) {
                            // total = add_rounded_difference(total, p, q)                        <L 21>
                            var_149 = add_rounded_difference_0(var_5, var_2, var_126);
                        }
                        var_150 = wp::where(var_148, var_149, var_5);
                    }
                    var_151 = wp::where(var_124, var_150, var_5);
                    var_152 = wp::where(var_124, var_147, var_9);
                    var_153 = wp::where(var_124, var_126, var_39);
                    wp::assign(var_5, var_151);
                    wp::assign(var_9, var_152);
                    wp::assign(var_35, var_122);
                    wp::assign(var_39, var_153);
                    goto start_for_6;
                end_for_6:;
            }
            var_154 = wp::where(var_113, var_116, var_109);
            var_155 = wp::where(var_113, var_120, var_110);
            // if distances__leaves_within__2[leaf__leaves_within__2] <= wide:                    <L 13>
            var_157 = wp::extract(var_20, var_156);
            var_158 = (var_157 <= var_wide);
            if (var_158) {
                // first__points_within__1 = bucket__leaves_within__2 * BUCKET__leaves_within + leaf__leaves_within__2 * LEAF__leaves_within       <L 14>
                var_159 = wp::mul(var_19, var_24);
                var_160 = wp::mul(var_156, var_26);
                var_161 = wp::add(var_159, var_160);
                // for j in range(first__points_within__1, min(first__points_within__1 + LEAF__points_within, tree__count)):       <L 15>
                var_162 = wp::add(var_161, var_29);
                var_163 = wp::min(var_162, var_tree__count);
                var_164 = wp::range(var_161, var_163);
                start_for_8:;
                    if (iter_cmp(var_164) == 0) goto end_for_8;
                    var_165 = wp::iter_next(var_164);
                    // sqdist = square_distance__points_within(p, tree__points[j])                <L 16>
                    var_166 = wp::address(var_tree__points, var_165);
                    var_168 = wp::load(var_166);
                    var_167 = square_distance_0(var_2, var_168);
                    // if sqdist <= wide:                                                         <L 17>
                    var_169 = (var_167 <= var_wide);
                    if (var_169) {
                        // q = tree__points[j]                                                    <L 18>
                        var_170 = wp::address(var_tree__points, var_165);
                        var_172 = wp::load(var_170);
                        var_171 = wp::copy(var_172);
                        // middle += vec3d(float64(q[0] - p[0]), float64(q[1] - p[1]), float64(q[2] - p[2]))       <L 19>
                        var_174 = wp::extract(var_171, var_173);
                        var_176 = wp::extract(var_2, var_175);
                        var_177 = wp::sub(var_174, var_176);
                        var_178 = wp::float64(var_177);
                        var_180 = wp::extract(var_171, var_179);
                        var_182 = wp::extract(var_2, var_181);
                        var_183 = wp::sub(var_180, var_182);
                        var_184 = wp::float64(var_183);
                        var_186 = wp::extract(var_171, var_185);
                        var_188 = wp::extract(var_2, var_187);
                        var_189 = wp::sub(var_186, var_188);
                        var_190 = wp::float64(var_189);
                        var_191 = wp::vec_t<3, wp::float64>(var_178, var_184, var_190);
                        var_192 = wp::add(var_9, var_191);
                        // if sqdist <= narrow:                                                   <L 20>
                        var_193 = (var_167 <= var_narrow);
                        if (var_193) {
                            // total = add_rounded_difference(total, p, q)                        <L 21>
                            var_194 = add_rounded_difference_0(var_5, var_2, var_171);
                        }
                        var_195 = wp::where(var_193, var_194, var_5);
                    }
                    var_196 = wp::where(var_169, var_195, var_5);
                    var_197 = wp::where(var_169, var_192, var_9);
                    var_198 = wp::where(var_169, var_171, var_39);
                    wp::assign(var_5, var_196);
                    wp::assign(var_9, var_197);
                    wp::assign(var_35, var_167);
                    wp::assign(var_39, var_198);
                    goto start_for_8;
                end_for_8:;
            }
            var_199 = wp::where(var_158, var_161, var_154);
            var_200 = wp::where(var_158, var_165, var_155);
            // if distances__leaves_within__2[leaf__leaves_within__2] <= wide:                    <L 13>
            var_202 = wp::extract(var_20, var_201);
            var_203 = (var_202 <= var_wide);
            if (var_203) {
                // first__points_within__1 = bucket__leaves_within__2 * BUCKET__leaves_within + leaf__leaves_within__2 * LEAF__leaves_within       <L 14>
                var_204 = wp::mul(var_19, var_24);
                var_205 = wp::mul(var_201, var_26);
                var_206 = wp::add(var_204, var_205);
                // for j in range(first__points_within__1, min(first__points_within__1 + LEAF__points_within, tree__count)):       <L 15>
                var_207 = wp::add(var_206, var_29);
                var_208 = wp::min(var_207, var_tree__count);
                var_209 = wp::range(var_206, var_208);
                start_for_10:;
                    if (iter_cmp(var_209) == 0) goto end_for_10;
                    var_210 = wp::iter_next(var_209);
                    // sqdist = square_distance__points_within(p, tree__points[j])                <L 16>
                    var_211 = wp::address(var_tree__points, var_210);
                    var_213 = wp::load(var_211);
                    var_212 = square_distance_0(var_2, var_213);
                    // if sqdist <= wide:                                                         <L 17>
                    var_214 = (var_212 <= var_wide);
                    if (var_214) {
                        // q = tree__points[j]                                                    <L 18>
                        var_215 = wp::address(var_tree__points, var_210);
                        var_217 = wp::load(var_215);
                        var_216 = wp::copy(var_217);
                        // middle += vec3d(float64(q[0] - p[0]), float64(q[1] - p[1]), float64(q[2] - p[2]))       <L 19>
                        var_219 = wp::extract(var_216, var_218);
                        var_221 = wp::extract(var_2, var_220);
                        var_222 = wp::sub(var_219, var_221);
                        var_223 = wp::float64(var_222);
                        var_225 = wp::extract(var_216, var_224);
                        var_227 = wp::extract(var_2, var_226);
                        var_228 = wp::sub(var_225, var_227);
                        var_229 = wp::float64(var_228);
                        var_231 = wp::extract(var_216, var_230);
                        var_233 = wp::extract(var_2, var_232);
                        var_234 = wp::sub(var_231, var_233);
                        var_235 = wp::float64(var_234);
                        var_236 = wp::vec_t<3, wp::float64>(var_223, var_229, var_235);
                        var_237 = wp::add(var_9, var_236);
                        // if sqdist <= narrow:                                                   <L 20>
                        var_238 = (var_212 <= var_narrow);
                        if (var_238) {
                            // total = add_rounded_difference(total, p, q)                        <L 21>
                            var_239 = add_rounded_difference_0(var_5, var_2, var_216);
                        }
                        var_240 = wp::where(var_238, var_239, var_5);
                    }
                    var_241 = wp::where(var_214, var_240, var_5);
                    var_242 = wp::where(var_214, var_237, var_9);
                    var_243 = wp::where(var_214, var_216, var_39);
                    wp::assign(var_5, var_241);
                    wp::assign(var_9, var_242);
                    wp::assign(var_35, var_212);
                    wp::assign(var_39, var_243);
                    goto start_for_10;
                end_for_10:;
            }
            var_244 = wp::where(var_203, var_206, var_199);
            var_245 = wp::where(var_203, var_210, var_200);
            // if distances__leaves_within__2[leaf__leaves_within__2] <= wide:                    <L 13>
            var_247 = wp::extract(var_20, var_246);
            var_248 = (var_247 <= var_wide);
            if (var_248) {
                // first__points_within__1 = bucket__leaves_within__2 * BUCKET__leaves_within + leaf__leaves_within__2 * LEAF__leaves_within       <L 14>
                var_249 = wp::mul(var_19, var_24);
                var_250 = wp::mul(var_246, var_26);
                var_251 = wp::add(var_249, var_250);
                // for j in range(first__points_within__1, min(first__points_within__1 + LEAF__points_within, tree__count)):       <L 15>
                var_252 = wp::add(var_251, var_29);
                var_253 = wp::min(var_252, var_tree__count);
                var_254 = wp::range(var_251, var_253);
                start_for_12:;
                    if (iter_cmp(var_254) == 0) goto end_for_12;
                    var_255 = wp::iter_next(var_254);
                    // sqdist = square_distance__points_within(p, tree__points[j])                <L 16>
                    var_256 = wp::address(var_tree__points, var_255);
                    var_258 = wp::load(var_256);
                    var_257 = square_distance_0(var_2, var_258);
                    // if sqdist <= wide:                                                         <L 17>
                    var_259 = (var_257 <= var_wide);
                    if (var_259) {
                        // q = tree__points[j]                                                    <L 18>
                        var_260 = wp::address(var_tree__points, var_255);
                        var_262 = wp::load(var_260);
                        var_261 = wp::copy(var_262);
                        // middle += vec3d(float64(q[0] - p[0]), float64(q[1] - p[1]), float64(q[2] - p[2]))       <L 19>
                        var_264 = wp::extract(var_261, var_263);
                        var_266 = wp::extract(var_2, var_265);
                        var_267 = wp::sub(var_264, var_266);
                        var_268 = wp::float64(var_267);
                        var_270 = wp::extract(var_261, var_269);
                        var_272 = wp::extract(var_2, var_271);
                        var_273 = wp::sub(var_270, var_272);
                        var_274 = wp::float64(var_273);
                        var_276 = wp::extract(var_261, var_275);
                        var_278 = wp::extract(var_2, var_277);
                        var_279 = wp::sub(var_276, var_278);
                        var_280 = wp::float64(var_279);
                        var_281 = wp::vec_t<3, wp::float64>(var_268, var_274, var_280);
                        var_282 = wp::add(var_9, var_281);
                        // if sqdist <= narrow:                                                   <L 20>
                        var_283 = (var_257 <= var_narrow);
                        if (var_283) {
                            // total = add_rounded_difference(total, p, q)                        <L 21>
                            var_284 = add_rounded_difference_0(var_5, var_2, var_261);
                        }
                        var_285 = wp::where(var_283, var_284, var_5);
                    }
                    var_286 = wp::where(var_259, var_285, var_5);
                    var_287 = wp::where(var_259, var_282, var_9);
                    var_288 = wp::where(var_259, var_261, var_39);
                    wp::assign(var_5, var_286);
                    wp::assign(var_9, var_287);
                    wp::assign(var_35, var_257);
                    wp::assign(var_39, var_288);
                    goto start_for_12;
                end_for_12:;
            }
            var_289 = wp::where(var_248, var_251, var_244);
            var_290 = wp::where(var_248, var_255, var_245);
            // if distances__leaves_within__2[leaf__leaves_within__2] <= wide:                    <L 13>
            var_292 = wp::extract(var_20, var_291);
            var_293 = (var_292 <= var_wide);
            if (var_293) {
                // first__points_within__1 = bucket__leaves_within__2 * BUCKET__leaves_within + leaf__leaves_within__2 * LEAF__leaves_within       <L 14>
                var_294 = wp::mul(var_19, var_24);
                var_295 = wp::mul(var_291, var_26);
                var_296 = wp::add(var_294, var_295);
                // for j in range(first__points_within__1, min(first__points_within__1 + LEAF__points_within, tree__count)):       <L 15>
                var_297 = wp::add(var_296, var_29);
                var_298 = wp::min(var_297, var_tree__count);
                var_299 = wp::range(var_296, var_298);
                start_for_14:;
                    if (iter_cmp(var_299) == 0) goto end_for_14;
                    var_300 = wp::iter_next(var_299);
                    // sqdist = square_distance__points_within(p, tree__points[j])                <L 16>
                    var_301 = wp::address(var_tree__points, var_300);
                    var_303 = wp::load(var_301);
                    var_302 = square_distance_0(var_2, var_303);
                    // if sqdist <= wide:                                                         <L 17>
                    var_304 = (var_302 <= var_wide);
                    if (var_304) {
                        // q = tree__points[j]                                                    <L 18>
                        var_305 = wp::address(var_tree__points, var_300);
                        var_307 = wp::load(var_305);
                        var_306 = wp::copy(var_307);
                        // middle += vec3d(float64(q[0] - p[0]), float64(q[1] - p[1]), float64(q[2] - p[2]))       <L 19>
                        var_309 = wp::extract(var_306, var_308);
                        var_311 = wp::extract(var_2, var_310);
                        var_312 = wp::sub(var_309, var_311);
                        var_313 = wp::float64(var_312);
                        var_315 = wp::extract(var_306, var_314);
                        var_317 = wp::extract(var_2, var_316);
                        var_318 = wp::sub(var_315, var_317);
                        var_319 = wp::float64(var_318);
                        var_321 = wp::extract(var_306, var_320);
                        var_323 = wp::extract(var_2, var_322);
                        var_324 = wp::sub(var_321, var_323);
                        var_325 = wp::float64(var_324);
                        var_326 = wp::vec_t<3, wp::float64>(var_313, var_319, var_325);
                        var_327 = wp::add(var_9, var_326);
                        // if sqdist <= narrow:                                                   <L 20>
                        var_328 = (var_302 <= var_narrow);
                        if (var_328) {
                            // total = add_rounded_difference(total, p, q)                        <L 21>
                            var_329 = add_rounded_difference_0(var_5, var_2, var_306);
                        }
                        var_330 = wp::where(var_328, var_329, var_5);
                    }
                    var_331 = wp::where(var_304, var_330, var_5);
                    var_332 = wp::where(var_304, var_327, var_9);
                    var_333 = wp::where(var_304, var_306, var_39);
                    wp::assign(var_5, var_331);
                    wp::assign(var_9, var_332);
                    wp::assign(var_35, var_302);
                    wp::assign(var_39, var_333);
                    goto start_for_14;
                end_for_14:;
            }
            var_334 = wp::where(var_293, var_296, var_289);
            var_335 = wp::where(var_293, var_300, var_290);
            // if distances__leaves_within__2[leaf__leaves_within__2] <= wide:                    <L 13>
            var_337 = wp::extract(var_20, var_336);
            var_338 = (var_337 <= var_wide);
            if (var_338) {
                // first__points_within__1 = bucket__leaves_within__2 * BUCKET__leaves_within + leaf__leaves_within__2 * LEAF__leaves_within       <L 14>
                var_339 = wp::mul(var_19, var_24);
                var_340 = wp::mul(var_336, var_26);
                var_341 = wp::add(var_339, var_340);
                // for j in range(first__points_within__1, min(first__points_within__1 + LEAF__points_within, tree__count)):       <L 15>
                var_342 = wp::add(var_341, var_29);
                var_343 = wp::min(var_342, var_tree__count);
                var_344 = wp::range(var_341, var_343);
                start_for_16:;
                    if (iter_cmp(var_344) == 0) goto end_for_16;
                    var_345 = wp::iter_next(var_344);
                    // sqdist = square_distance__points_within(p, tree__points[j])                <L 16>
                    var_346 = wp::address(var_tree__points, var_345);
                    var_348 = wp::load(var_346);
                    var_347 = square_distance_0(var_2, var_348);
                    // if sqdist <= wide:                                                         <L 17>
                    var_349 = (var_347 <= var_wide);
                    if (var_349) {
                        // q = tree__points[j]                                                    <L 18>
                        var_350 = wp::address(var_tree__points, var_345);
                        var_352 = wp::load(var_350);
                        var_351 = wp::copy(var_352);
                        // middle += vec3d(float64(q[0] - p[0]), float64(q[1] - p[1]), float64(q[2] - p[2]))       <L 19>
                        var_354 = wp::extract(var_351, var_353);
                        var_356 = wp::extract(var_2, var_355);
                        var_357 = wp::sub(var_354, var_356);
                        var_358 = wp::float64(var_357);
                        var_360 = wp::extract(var_351, var_359);
                        var_362 = wp::extract(var_2, var_361);
                        var_363 = wp::sub(var_360, var_362);
                        var_364 = wp::float64(var_363);
                        var_366 = wp::extract(var_351, var_365);
                        var_368 = wp::extract(var_2, var_367);
                        var_369 = wp::sub(var_366, var_368);
                        var_370 = wp::float64(var_369);
                        var_371 = wp::vec_t<3, wp::float64>(var_358, var_364, var_370);
                        var_372 = wp::add(var_9, var_371);
                        // if sqdist <= narrow:                                                   <L 20>
                        var_373 = (var_347 <= var_narrow);
                        if (var_373) {
                            // total = add_rounded_difference(total, p, q)                        <L 21>
                            var_374 = add_rounded_difference_0(var_5, var_2, var_351);
                        }
                        var_375 = wp::where(var_373, var_374, var_5);
                    }
                    var_376 = wp::where(var_349, var_375, var_5);
                    var_377 = wp::where(var_349, var_372, var_9);
                    var_378 = wp::where(var_349, var_351, var_39);
                    wp::assign(var_5, var_376);
                    wp::assign(var_9, var_377);
                    wp::assign(var_35, var_347);
                    wp::assign(var_39, var_378);
                    goto start_for_16;
                end_for_16:;
            }
            var_379 = wp::where(var_338, var_341, var_334);
            var_380 = wp::where(var_338, var_345, var_335);
            // step__leaves_within__2 = next_bucket__leaves_within(step__leaves_within__2, p, p, wide, tree__root, tree__levels, tree__boxes)       <L 22>
            var_381 = next_bucket_0(var_12, var_2, var_2, var_wide, var_tree__root, var_tree__levels, var_tree__boxes);
            wp::assign(var_12, var_381);
        goto start_while_0;
        end_while_0:;
        // n = vec3(NAN, NAN, NAN)                                                                <L 23>
        var_383 = wp::vec_t<3, wp::float32>(var_382, var_382, var_382);
        // if total[0] >= float64(MIN_NEIGHBORS):                                                 <L 24>
        var_385 = wp::extract(var_5, var_384);
        var_386 = 5.0;
        var_387 = (var_385 >= var_386);
        if (var_387) {
            // covariance = covariance_of(total)                                                  <L 25>
            var_388 = covariance_of_0(var_5);
            // size = largest_entry(covariance)                                                   <L 26>
            var_389 = largest_entry_0(var_388);
            // if size > float64(0.0):                                                            <L 27>
            var_390 = 0.0;
            var_391 = (var_389 > var_390);
            if (var_391) {
                // values = sorted_eigenvalues(covariance * (float64(1.0) / size))                <L 28>
                var_392 = 1.0;
                var_393 = wp::div(var_392, var_389);
                var_394 = wp::mul(var_388, var_393);
                var_395 = sorted_eigenvalues_0(var_394);
                // if values[1] > float64(STRAIGHT) * values[2]:                                  <L 29>
                var_397 = wp::extract(var_395, var_396);
                var_398 = 0.001;
                var_400 = wp::extract(var_395, var_399);
                var_401 = wp::mul(var_398, var_400);
                var_402 = (var_397 > var_401);
                if (var_402) {
                    // v = smallest_eigenvector(covariance)                                       <L 30>
                    var_403 = smallest_eigenvector_0(var_388);
                    // if v[0] * middle[0] + v[1] * middle[1] + v[2] * middle[2] < float64(0.0):       <L 31>
                    var_405 = wp::extract(var_403, var_404);
                    var_407 = wp::extract(var_9, var_406);
                    var_408 = wp::mul(var_405, var_407);
                    var_410 = wp::extract(var_403, var_409);
                    var_412 = wp::extract(var_9, var_411);
                    var_413 = wp::mul(var_410, var_412);
                    var_414 = wp::add(var_408, var_413);
                    var_416 = wp::extract(var_403, var_415);
                    var_418 = wp::extract(var_9, var_417);
                    var_419 = wp::mul(var_416, var_418);
                    var_420 = wp::add(var_414, var_419);
                    var_421 = 0.0;
                    var_422 = (var_420 < var_421);
                    if (var_422) {
                        // v = -v                                                                 <L 32>
                        var_423 = wp::neg(var_403);
                    }
                    var_424 = wp::where(var_422, var_423, var_403);
                    // n = vec3(float(v[0]), float(v[1]), float(v[2]))                            <L 33>
                    var_426 = wp::extract(var_424, var_425);
                    var_427 = wp::float(var_426);
                    var_429 = wp::extract(var_424, var_428);
                    var_430 = wp::float(var_429);
                    var_432 = wp::extract(var_424, var_431);
                    var_433 = wp::float(var_432);
                    var_434 = wp::vec_t<3, wp::float32>(var_427, var_430, var_433);
                }
                var_435 = wp::where(var_402, var_434, var_383);
            }
            var_436 = wp::where(var_391, var_435, var_383);
        }
        var_437 = wp::where(var_387, var_436, var_383);
        // normals[tree__order[i]] = n                                                            <L 34>
        var_438 = wp::address(var_tree__order, var_0);
        var_439 = wp::load(var_438);
        wp::array_store(var_normals, var_439, var_437);
}


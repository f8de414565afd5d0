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


// /work/main/src/pointloom/kernels/algebra/moments.py:11
static CUDA_CALLABLE wp::float32 steps_for_0(
    wp::float32 var_sqdist,
    wp::int32 var_count)
{
    //---------
    // primal vars
    wp::int32 var_0;
    const wp::int32 var_1 = 23;
    wp::int32 var_2;
    const wp::int32 var_3 = 125;
    wp::int32 var_4;
    const wp::int32 var_5 = 1;
    wp::int32 var_6;
    const wp::int32 var_7 = 150;
    wp::int32 var_8;
    const wp::int32 var_9 = 23;
    wp::int32 var_10;
    wp::float32 var_11;
    const wp::int32 var_12 = 131072;
    bool var_13;
    const wp::float32 var_14 = 0.00390625;
    wp::float32 var_15;
    wp::float32 var_16;
    //---------
    // forward
    // def steps_for(sqdist: float, count: int) -> float:                                     <L 12>
    // power = ((float_bits(sqdist) >> 23) - 125) >> 1  # sqdist < 4^power                    <L 14>
    var_0 = _float_bits_0(var_sqdist);
    var_2 = wp::rshift(var_0, var_1);
    var_4 = wp::sub(var_2, var_3);
    var_6 = wp::rshift(var_4, var_5);
    // steps = bits_float((150 - power) << 23)                                                <L 15>
    var_8 = wp::sub(var_7, var_6);
    var_10 = wp::lshift(var_8, var_9);
    var_11 = _bits_float_0(var_10);
    // if count > MAX_EXACT_POINTS:                                                           <L 16>
    var_13 = (var_count > var_12);
    if (var_13) {
        // steps = steps * COARSER                                                            <L 17>
        var_15 = wp::mul(var_11, var_14);
    }
    var_16 = wp::where(var_13, var_15, var_11);
    // return steps                                                                           <L 18>
    return var_16;
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


// /work/main/src/pointloom/kernels/algebra/moments.py:21
static CUDA_CALLABLE wp::int64 integer_steps_0(
    wp::float32 var_length,
    wp::float32 var_steps)
{
    //---------
    // primal vars
    wp::float32 var_0;
    const wp::float32 var_1 = 0.5;
    wp::float32 var_2;
    wp::float32 var_3;
    wp::int32 var_4;
    wp::int64 var_5;
    //---------
    // forward
    // def integer_steps(length: float, steps: float) -> int64:                               <L 22>
    // return int64(int(floor(length * steps + 0.5)))                                         <L 24>
    var_0 = wp::mul(var_length, var_steps);
    var_2 = wp::add(var_0, var_1);
    var_3 = wp::floor(var_2);
    var_4 = wp::int(var_3);
    var_5 = wp::int64(var_4);
    return var_5;
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


// <pointloom.kernels.surface.neighbor_moments.integer_moments_within>:1
static CUDA_CALLABLE wp::vec_t<10, wp::int64> integer_moments_within_0(
    wp::int32 var_start,
    wp::vec_t<3, wp::float32> var_p,
    wp::float32 var_max_sqdist,
    wp::float32 var_steps,
    wp::int32 var_tree__root,
    wp::array_t<wp::int32> var_tree__levels,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> var_tree__points)
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
    const wp::float32 var_10 = 0.0;
    wp::vec_t<8, wp::float32> var_11;
    const wp::float32 var_12 = 0.0;
    wp::vec_t<8, wp::float32> var_13;
    const wp::float32 var_14 = 0.0;
    wp::vec_t<8, wp::float32> var_15;
    wp::vec_t<4, wp::int64> var_16;
    const wp::int32 var_17 = 0;
    wp::int64 var_18;
    wp::int32 var_19;
    bool var_20;
    const wp::int32 var_21 = 2;
    wp::int64 var_22;
    wp::int32 var_23;
    wp::vec_t<8, wp::float32> var_24;
    const wp::int32 var_25 = 0;
    wp::float32 var_26;
    bool var_27;
    const wp::int32 var_28 = 64;
    wp::int32 var_29;
    const wp::int32 var_30 = 8;
    wp::int32 var_31;
    wp::int32 var_32;
    const wp::int32 var_33 = 0;
    wp::int32 var_34;
    wp::vec_t<3, wp::float32>* var_35;
    wp::vec_t<3, wp::float32> var_36;
    wp::vec_t<3, wp::float32> var_37;
    const wp::int32 var_38 = 0;
    wp::float32 var_39;
    const wp::int32 var_40 = 0;
    wp::float32 var_41;
    wp::float32 var_42;
    const wp::int32 var_43 = 1;
    wp::float32 var_44;
    const wp::int32 var_45 = 1;
    wp::float32 var_46;
    wp::float32 var_47;
    const wp::int32 var_48 = 2;
    wp::float32 var_49;
    const wp::int32 var_50 = 2;
    wp::float32 var_51;
    wp::float32 var_52;
    const wp::int32 var_53 = 1;
    wp::int32 var_54;
    wp::vec_t<3, wp::float32>* var_55;
    wp::vec_t<3, wp::float32> var_56;
    wp::vec_t<3, wp::float32> var_57;
    const wp::int32 var_58 = 0;
    wp::float32 var_59;
    const wp::int32 var_60 = 0;
    wp::float32 var_61;
    wp::float32 var_62;
    const wp::int32 var_63 = 1;
    wp::float32 var_64;
    const wp::int32 var_65 = 1;
    wp::float32 var_66;
    wp::float32 var_67;
    const wp::int32 var_68 = 2;
    wp::float32 var_69;
    const wp::int32 var_70 = 2;
    wp::float32 var_71;
    wp::float32 var_72;
    const wp::int32 var_73 = 2;
    wp::int32 var_74;
    wp::vec_t<3, wp::float32>* var_75;
    wp::vec_t<3, wp::float32> var_76;
    wp::vec_t<3, wp::float32> var_77;
    const wp::int32 var_78 = 0;
    wp::float32 var_79;
    const wp::int32 var_80 = 0;
    wp::float32 var_81;
    wp::float32 var_82;
    const wp::int32 var_83 = 1;
    wp::float32 var_84;
    const wp::int32 var_85 = 1;
    wp::float32 var_86;
    wp::float32 var_87;
    const wp::int32 var_88 = 2;
    wp::float32 var_89;
    const wp::int32 var_90 = 2;
    wp::float32 var_91;
    wp::float32 var_92;
    const wp::int32 var_93 = 3;
    wp::int32 var_94;
    wp::vec_t<3, wp::float32>* var_95;
    wp::vec_t<3, wp::float32> var_96;
    wp::vec_t<3, wp::float32> var_97;
    const wp::int32 var_98 = 0;
    wp::float32 var_99;
    const wp::int32 var_100 = 0;
    wp::float32 var_101;
    wp::float32 var_102;
    const wp::int32 var_103 = 1;
    wp::float32 var_104;
    const wp::int32 var_105 = 1;
    wp::float32 var_106;
    wp::float32 var_107;
    const wp::int32 var_108 = 2;
    wp::float32 var_109;
    const wp::int32 var_110 = 2;
    wp::float32 var_111;
    wp::float32 var_112;
    const wp::int32 var_113 = 4;
    wp::int32 var_114;
    wp::vec_t<3, wp::float32>* var_115;
    wp::vec_t<3, wp::float32> var_116;
    wp::vec_t<3, wp::float32> var_117;
    const wp::int32 var_118 = 0;
    wp::float32 var_119;
    const wp::int32 var_120 = 0;
    wp::float32 var_121;
    wp::float32 var_122;
    const wp::int32 var_123 = 1;
    wp::float32 var_124;
    const wp::int32 var_125 = 1;
    wp::float32 var_126;
    wp::float32 var_127;
    const wp::int32 var_128 = 2;
    wp::float32 var_129;
    const wp::int32 var_130 = 2;
    wp::float32 var_131;
    wp::float32 var_132;
    const wp::int32 var_133 = 5;
    wp::int32 var_134;
    wp::vec_t<3, wp::float32>* var_135;
    wp::vec_t<3, wp::float32> var_136;
    wp::vec_t<3, wp::float32> var_137;
    const wp::int32 var_138 = 0;
    wp::float32 var_139;
    const wp::int32 var_140 = 0;
    wp::float32 var_141;
    wp::float32 var_142;
    const wp::int32 var_143 = 1;
    wp::float32 var_144;
    const wp::int32 var_145 = 1;
    wp::float32 var_146;
    wp::float32 var_147;
    const wp::int32 var_148 = 2;
    wp::float32 var_149;
    const wp::int32 var_150 = 2;
    wp::float32 var_151;
    wp::float32 var_152;
    const wp::int32 var_153 = 6;
    wp::int32 var_154;
    wp::vec_t<3, wp::float32>* var_155;
    wp::vec_t<3, wp::float32> var_156;
    wp::vec_t<3, wp::float32> var_157;
    const wp::int32 var_158 = 0;
    wp::float32 var_159;
    const wp::int32 var_160 = 0;
    wp::float32 var_161;
    wp::float32 var_162;
    const wp::int32 var_163 = 1;
    wp::float32 var_164;
    const wp::int32 var_165 = 1;
    wp::float32 var_166;
    wp::float32 var_167;
    const wp::int32 var_168 = 2;
    wp::float32 var_169;
    const wp::int32 var_170 = 2;
    wp::float32 var_171;
    wp::float32 var_172;
    const wp::int32 var_173 = 7;
    wp::int32 var_174;
    wp::vec_t<3, wp::float32>* var_175;
    wp::vec_t<3, wp::float32> var_176;
    wp::vec_t<3, wp::float32> var_177;
    const wp::int32 var_178 = 0;
    wp::float32 var_179;
    const wp::int32 var_180 = 0;
    wp::float32 var_181;
    wp::float32 var_182;
    const wp::int32 var_183 = 1;
    wp::float32 var_184;
    const wp::int32 var_185 = 1;
    wp::float32 var_186;
    wp::float32 var_187;
    const wp::int32 var_188 = 2;
    wp::float32 var_189;
    const wp::int32 var_190 = 2;
    wp::float32 var_191;
    wp::float32 var_192;
    const wp::int32 var_193 = 0;
    wp::float32 var_194;
    wp::float32 var_195;
    wp::float32 var_196;
    wp::float32 var_197;
    wp::float32 var_198;
    wp::float32 var_199;
    wp::float32 var_200;
    wp::float32 var_201;
    wp::float32 var_202;
    wp::float32 var_203;
    wp::float32 var_204;
    bool var_205;
    wp::float32 var_206;
    const wp::float32 var_207 = 0.0;
    wp::float32 var_208;
    wp::int64 var_209;
    wp::float32 var_210;
    const wp::float32 var_211 = 0.0;
    wp::float32 var_212;
    wp::int64 var_213;
    wp::float32 var_214;
    const wp::float32 var_215 = 0.0;
    wp::float32 var_216;
    wp::int64 var_217;
    const wp::int32 var_218 = 1;
    const wp::int32 var_219 = 0;
    wp::int32 var_220;
    wp::int64 var_221;
    wp::int64 var_222;
    wp::int64 var_223;
    wp::int64 var_224;
    wp::int64 var_225;
    wp::int64 var_226;
    wp::int64 var_227;
    wp::int64 var_228;
    wp::int64 var_229;
    wp::int64 var_230;
    wp::int64 var_231;
    wp::int64 var_232;
    wp::int64 var_233;
    wp::int64 var_234;
    wp::int64 var_235;
    wp::int64 var_236;
    wp::int64 var_237;
    const wp::int32 var_238 = 1;
    wp::float32 var_239;
    wp::float32 var_240;
    wp::float32 var_241;
    wp::float32 var_242;
    wp::float32 var_243;
    wp::float32 var_244;
    wp::float32 var_245;
    wp::float32 var_246;
    wp::float32 var_247;
    wp::float32 var_248;
    wp::float32 var_249;
    bool var_250;
    wp::float32 var_251;
    const wp::float32 var_252 = 0.0;
    wp::float32 var_253;
    wp::int64 var_254;
    wp::float32 var_255;
    const wp::float32 var_256 = 0.0;
    wp::float32 var_257;
    wp::int64 var_258;
    wp::float32 var_259;
    const wp::float32 var_260 = 0.0;
    wp::float32 var_261;
    wp::int64 var_262;
    const wp::int32 var_263 = 1;
    const wp::int32 var_264 = 0;
    wp::int32 var_265;
    wp::int64 var_266;
    wp::int64 var_267;
    wp::int64 var_268;
    wp::int64 var_269;
    wp::int64 var_270;
    wp::int64 var_271;
    wp::int64 var_272;
    wp::int64 var_273;
    wp::int64 var_274;
    wp::int64 var_275;
    wp::int64 var_276;
    wp::int64 var_277;
    wp::int64 var_278;
    wp::int64 var_279;
    wp::int64 var_280;
    wp::int64 var_281;
    wp::int64 var_282;
    const wp::int32 var_283 = 2;
    wp::float32 var_284;
    wp::float32 var_285;
    wp::float32 var_286;
    wp::float32 var_287;
    wp::float32 var_288;
    wp::float32 var_289;
    wp::float32 var_290;
    wp::float32 var_291;
    wp::float32 var_292;
    wp::float32 var_293;
    wp::float32 var_294;
    bool var_295;
    wp::float32 var_296;
    const wp::float32 var_297 = 0.0;
    wp::float32 var_298;
    wp::int64 var_299;
    wp::float32 var_300;
    const wp::float32 var_301 = 0.0;
    wp::float32 var_302;
    wp::int64 var_303;
    wp::float32 var_304;
    const wp::float32 var_305 = 0.0;
    wp::float32 var_306;
    wp::int64 var_307;
    const wp::int32 var_308 = 1;
    const wp::int32 var_309 = 0;
    wp::int32 var_310;
    wp::int64 var_311;
    wp::int64 var_312;
    wp::int64 var_313;
    wp::int64 var_314;
    wp::int64 var_315;
    wp::int64 var_316;
    wp::int64 var_317;
    wp::int64 var_318;
    wp::int64 var_319;
    wp::int64 var_320;
    wp::int64 var_321;
    wp::int64 var_322;
    wp::int64 var_323;
    wp::int64 var_324;
    wp::int64 var_325;
    wp::int64 var_326;
    wp::int64 var_327;
    const wp::int32 var_328 = 3;
    wp::float32 var_329;
    wp::float32 var_330;
    wp::float32 var_331;
    wp::float32 var_332;
    wp::float32 var_333;
    wp::float32 var_334;
    wp::float32 var_335;
    wp::float32 var_336;
    wp::float32 var_337;
    wp::float32 var_338;
    wp::float32 var_339;
    bool var_340;
    wp::float32 var_341;
    const wp::float32 var_342 = 0.0;
    wp::float32 var_343;
    wp::int64 var_344;
    wp::float32 var_345;
    const wp::float32 var_346 = 0.0;
    wp::float32 var_347;
    wp::int64 var_348;
    wp::float32 var_349;
    const wp::float32 var_350 = 0.0;
    wp::float32 var_351;
    wp::int64 var_352;
    const wp::int32 var_353 = 1;
    const wp::int32 var_354 = 0;
    wp::int32 var_355;
    wp::int64 var_356;
    wp::int64 var_357;
    wp::int64 var_358;
    wp::int64 var_359;
    wp::int64 var_360;
    wp::int64 var_361;
    wp::int64 var_362;
    wp::int64 var_363;
    wp::int64 var_364;
    wp::int64 var_365;
    wp::int64 var_366;
    wp::int64 var_367;
    wp::int64 var_368;
    wp::int64 var_369;
    wp::int64 var_370;
    wp::int64 var_371;
    wp::int64 var_372;
    const wp::int32 var_373 = 4;
    wp::float32 var_374;
    wp::float32 var_375;
    wp::float32 var_376;
    wp::float32 var_377;
    wp::float32 var_378;
    wp::float32 var_379;
    wp::float32 var_380;
    wp::float32 var_381;
    wp::float32 var_382;
    wp::float32 var_383;
    wp::float32 var_384;
    bool var_385;
    wp::float32 var_386;
    const wp::float32 var_387 = 0.0;
    wp::float32 var_388;
    wp::int64 var_389;
    wp::float32 var_390;
    const wp::float32 var_391 = 0.0;
    wp::float32 var_392;
    wp::int64 var_393;
    wp::float32 var_394;
    const wp::float32 var_395 = 0.0;
    wp::float32 var_396;
    wp::int64 var_397;
    const wp::int32 var_398 = 1;
    const wp::int32 var_399 = 0;
    wp::int32 var_400;
    wp::int64 var_401;
    wp::int64 var_402;
    wp::int64 var_403;
    wp::int64 var_404;
    wp::int64 var_405;
    wp::int64 var_406;
    wp::int64 var_407;
    wp::int64 var_408;
    wp::int64 var_409;
    wp::int64 var_410;
    wp::int64 var_411;
    wp::int64 var_412;
    wp::int64 var_413;
    wp::int64 var_414;
    wp::int64 var_415;
    wp::int64 var_416;
    wp::int64 var_417;
    const wp::int32 var_418 = 5;
    wp::float32 var_419;
    wp::float32 var_420;
    wp::float32 var_421;
    wp::float32 var_422;
    wp::float32 var_423;
    wp::float32 var_424;
    wp::float32 var_425;
    wp::float32 var_426;
    wp::float32 var_427;
    wp::float32 var_428;
    wp::float32 var_429;
    bool var_430;
    wp::float32 var_431;
    const wp::float32 var_432 = 0.0;
    wp::float32 var_433;
    wp::int64 var_434;
    wp::float32 var_435;
    const wp::float32 var_436 = 0.0;
    wp::float32 var_437;
    wp::int64 var_438;
    wp::float32 var_439;
    const wp::float32 var_440 = 0.0;
    wp::float32 var_441;
    wp::int64 var_442;
    const wp::int32 var_443 = 1;
    const wp::int32 var_444 = 0;
    wp::int32 var_445;
    wp::int64 var_446;
    wp::int64 var_447;
    wp::int64 var_448;
    wp::int64 var_449;
    wp::int64 var_450;
    wp::int64 var_451;
    wp::int64 var_452;
    wp::int64 var_453;
    wp::int64 var_454;
    wp::int64 var_455;
    wp::int64 var_456;
    wp::int64 var_457;
    wp::int64 var_458;
    wp::int64 var_459;
    wp::int64 var_460;
    wp::int64 var_461;
    wp::int64 var_462;
    const wp::int32 var_463 = 6;
    wp::float32 var_464;
    wp::float32 var_465;
    wp::float32 var_466;
    wp::float32 var_467;
    wp::float32 var_468;
    wp::float32 var_469;
    wp::float32 var_470;
    wp::float32 var_471;
    wp::float32 var_472;
    wp::float32 var_473;
    wp::float32 var_474;
    bool var_475;
    wp::float32 var_476;
    const wp::float32 var_477 = 0.0;
    wp::float32 var_478;
    wp::int64 var_479;
    wp::float32 var_480;
    const wp::float32 var_481 = 0.0;
    wp::float32 var_482;
    wp::int64 var_483;
    wp::float32 var_484;
    const wp::float32 var_485 = 0.0;
    wp::float32 var_486;
    wp::int64 var_487;
    const wp::int32 var_488 = 1;
    const wp::int32 var_489 = 0;
    wp::int32 var_490;
    wp::int64 var_491;
    wp::int64 var_492;
    wp::int64 var_493;
    wp::int64 var_494;
    wp::int64 var_495;
    wp::int64 var_496;
    wp::int64 var_497;
    wp::int64 var_498;
    wp::int64 var_499;
    wp::int64 var_500;
    wp::int64 var_501;
    wp::int64 var_502;
    wp::int64 var_503;
    wp::int64 var_504;
    wp::int64 var_505;
    wp::int64 var_506;
    wp::int64 var_507;
    const wp::int32 var_508 = 7;
    wp::float32 var_509;
    wp::float32 var_510;
    wp::float32 var_511;
    wp::float32 var_512;
    wp::float32 var_513;
    wp::float32 var_514;
    wp::float32 var_515;
    wp::float32 var_516;
    wp::float32 var_517;
    wp::float32 var_518;
    wp::float32 var_519;
    bool var_520;
    wp::float32 var_521;
    const wp::float32 var_522 = 0.0;
    wp::float32 var_523;
    wp::int64 var_524;
    wp::float32 var_525;
    const wp::float32 var_526 = 0.0;
    wp::float32 var_527;
    wp::int64 var_528;
    wp::float32 var_529;
    const wp::float32 var_530 = 0.0;
    wp::float32 var_531;
    wp::int64 var_532;
    const wp::int32 var_533 = 1;
    const wp::int32 var_534 = 0;
    wp::int32 var_535;
    wp::int64 var_536;
    wp::int64 var_537;
    wp::int64 var_538;
    wp::int64 var_539;
    wp::int64 var_540;
    wp::int64 var_541;
    wp::int64 var_542;
    wp::int64 var_543;
    wp::int64 var_544;
    wp::int64 var_545;
    wp::int64 var_546;
    wp::int64 var_547;
    wp::int64 var_548;
    wp::int64 var_549;
    wp::int64 var_550;
    wp::int64 var_551;
    wp::int64 var_552;
    wp::int64 var_553;
    wp::int64 var_554;
    wp::int64 var_555;
    wp::int64 var_556;
    wp::int64 var_557;
    wp::int64 var_558;
    wp::int64 var_559;
    wp::int64 var_560;
    wp::int64 var_561;
    wp::int64 var_562;
    const wp::int32 var_563 = 1;
    wp::float32 var_564;
    bool var_565;
    wp::int32 var_566;
    wp::int32 var_567;
    wp::int32 var_568;
    const wp::int32 var_569 = 0;
    wp::int32 var_570;
    wp::vec_t<3, wp::float32>* var_571;
    wp::vec_t<3, wp::float32> var_572;
    wp::vec_t<3, wp::float32> var_573;
    const wp::int32 var_574 = 0;
    wp::float32 var_575;
    const wp::int32 var_576 = 0;
    wp::float32 var_577;
    wp::float32 var_578;
    const wp::int32 var_579 = 1;
    wp::float32 var_580;
    const wp::int32 var_581 = 1;
    wp::float32 var_582;
    wp::float32 var_583;
    const wp::int32 var_584 = 2;
    wp::float32 var_585;
    const wp::int32 var_586 = 2;
    wp::float32 var_587;
    wp::float32 var_588;
    const wp::int32 var_589 = 1;
    wp::int32 var_590;
    wp::vec_t<3, wp::float32>* var_591;
    wp::vec_t<3, wp::float32> var_592;
    wp::vec_t<3, wp::float32> var_593;
    const wp::int32 var_594 = 0;
    wp::float32 var_595;
    const wp::int32 var_596 = 0;
    wp::float32 var_597;
    wp::float32 var_598;
    const wp::int32 var_599 = 1;
    wp::float32 var_600;
    const wp::int32 var_601 = 1;
    wp::float32 var_602;
    wp::float32 var_603;
    const wp::int32 var_604 = 2;
    wp::float32 var_605;
    const wp::int32 var_606 = 2;
    wp::float32 var_607;
    wp::float32 var_608;
    const wp::int32 var_609 = 2;
    wp::int32 var_610;
    wp::vec_t<3, wp::float32>* var_611;
    wp::vec_t<3, wp::float32> var_612;
    wp::vec_t<3, wp::float32> var_613;
    const wp::int32 var_614 = 0;
    wp::float32 var_615;
    const wp::int32 var_616 = 0;
    wp::float32 var_617;
    wp::float32 var_618;
    const wp::int32 var_619 = 1;
    wp::float32 var_620;
    const wp::int32 var_621 = 1;
    wp::float32 var_622;
    wp::float32 var_623;
    const wp::int32 var_624 = 2;
    wp::float32 var_625;
    const wp::int32 var_626 = 2;
    wp::float32 var_627;
    wp::float32 var_628;
    const wp::int32 var_629 = 3;
    wp::int32 var_630;
    wp::vec_t<3, wp::float32>* var_631;
    wp::vec_t<3, wp::float32> var_632;
    wp::vec_t<3, wp::float32> var_633;
    const wp::int32 var_634 = 0;
    wp::float32 var_635;
    const wp::int32 var_636 = 0;
    wp::float32 var_637;
    wp::float32 var_638;
    const wp::int32 var_639 = 1;
    wp::float32 var_640;
    const wp::int32 var_641 = 1;
    wp::float32 var_642;
    wp::float32 var_643;
    const wp::int32 var_644 = 2;
    wp::float32 var_645;
    const wp::int32 var_646 = 2;
    wp::float32 var_647;
    wp::float32 var_648;
    const wp::int32 var_649 = 4;
    wp::int32 var_650;
    wp::vec_t<3, wp::float32>* var_651;
    wp::vec_t<3, wp::float32> var_652;
    wp::vec_t<3, wp::float32> var_653;
    const wp::int32 var_654 = 0;
    wp::float32 var_655;
    const wp::int32 var_656 = 0;
    wp::float32 var_657;
    wp::float32 var_658;
    const wp::int32 var_659 = 1;
    wp::float32 var_660;
    const wp::int32 var_661 = 1;
    wp::float32 var_662;
    wp::float32 var_663;
    const wp::int32 var_664 = 2;
    wp::float32 var_665;
    const wp::int32 var_666 = 2;
    wp::float32 var_667;
    wp::float32 var_668;
    const wp::int32 var_669 = 5;
    wp::int32 var_670;
    wp::vec_t<3, wp::float32>* var_671;
    wp::vec_t<3, wp::float32> var_672;
    wp::vec_t<3, wp::float32> var_673;
    const wp::int32 var_674 = 0;
    wp::float32 var_675;
    const wp::int32 var_676 = 0;
    wp::float32 var_677;
    wp::float32 var_678;
    const wp::int32 var_679 = 1;
    wp::float32 var_680;
    const wp::int32 var_681 = 1;
    wp::float32 var_682;
    wp::float32 var_683;
    const wp::int32 var_684 = 2;
    wp::float32 var_685;
    const wp::int32 var_686 = 2;
    wp::float32 var_687;
    wp::float32 var_688;
    const wp::int32 var_689 = 6;
    wp::int32 var_690;
    wp::vec_t<3, wp::float32>* var_691;
    wp::vec_t<3, wp::float32> var_692;
    wp::vec_t<3, wp::float32> var_693;
    const wp::int32 var_694 = 0;
    wp::float32 var_695;
    const wp::int32 var_696 = 0;
    wp::float32 var_697;
    wp::float32 var_698;
    const wp::int32 var_699 = 1;
    wp::float32 var_700;
    const wp::int32 var_701 = 1;
    wp::float32 var_702;
    wp::float32 var_703;
    const wp::int32 var_704 = 2;
    wp::float32 var_705;
    const wp::int32 var_706 = 2;
    wp::float32 var_707;
    wp::float32 var_708;
    const wp::int32 var_709 = 7;
    wp::int32 var_710;
    wp::vec_t<3, wp::float32>* var_711;
    wp::vec_t<3, wp::float32> var_712;
    wp::vec_t<3, wp::float32> var_713;
    const wp::int32 var_714 = 0;
    wp::float32 var_715;
    const wp::int32 var_716 = 0;
    wp::float32 var_717;
    wp::float32 var_718;
    const wp::int32 var_719 = 1;
    wp::float32 var_720;
    const wp::int32 var_721 = 1;
    wp::float32 var_722;
    wp::float32 var_723;
    const wp::int32 var_724 = 2;
    wp::float32 var_725;
    const wp::int32 var_726 = 2;
    wp::float32 var_727;
    wp::float32 var_728;
    const wp::int32 var_729 = 0;
    wp::float32 var_730;
    wp::float32 var_731;
    wp::float32 var_732;
    wp::float32 var_733;
    wp::float32 var_734;
    wp::float32 var_735;
    wp::float32 var_736;
    wp::float32 var_737;
    wp::float32 var_738;
    wp::float32 var_739;
    wp::float32 var_740;
    bool var_741;
    wp::float32 var_742;
    const wp::float32 var_743 = 0.0;
    wp::float32 var_744;
    wp::int64 var_745;
    wp::float32 var_746;
    const wp::float32 var_747 = 0.0;
    wp::float32 var_748;
    wp::int64 var_749;
    wp::float32 var_750;
    const wp::float32 var_751 = 0.0;
    wp::float32 var_752;
    wp::int64 var_753;
    const wp::int32 var_754 = 1;
    const wp::int32 var_755 = 0;
    wp::int32 var_756;
    wp::int64 var_757;
    wp::int64 var_758;
    wp::int64 var_759;
    wp::int64 var_760;
    wp::int64 var_761;
    wp::int64 var_762;
    wp::int64 var_763;
    wp::int64 var_764;
    wp::int64 var_765;
    wp::int64 var_766;
    wp::int64 var_767;
    wp::int64 var_768;
    wp::int64 var_769;
    wp::int64 var_770;
    wp::int64 var_771;
    wp::int64 var_772;
    wp::int64 var_773;
    const wp::int32 var_774 = 1;
    wp::float32 var_775;
    wp::float32 var_776;
    wp::float32 var_777;
    wp::float32 var_778;
    wp::float32 var_779;
    wp::float32 var_780;
    wp::float32 var_781;
    wp::float32 var_782;
    wp::float32 var_783;
    wp::float32 var_784;
    wp::float32 var_785;
    bool var_786;
    wp::float32 var_787;
    const wp::float32 var_788 = 0.0;
    wp::float32 var_789;
    wp::int64 var_790;
    wp::float32 var_791;
    const wp::float32 var_792 = 0.0;
    wp::float32 var_793;
    wp::int64 var_794;
    wp::float32 var_795;
    const wp::float32 var_796 = 0.0;
    wp::float32 var_797;
    wp::int64 var_798;
    const wp::int32 var_799 = 1;
    const wp::int32 var_800 = 0;
    wp::int32 var_801;
    wp::int64 var_802;
    wp::int64 var_803;
    wp::int64 var_804;
    wp::int64 var_805;
    wp::int64 var_806;
    wp::int64 var_807;
    wp::int64 var_808;
    wp::int64 var_809;
    wp::int64 var_810;
    wp::int64 var_811;
    wp::int64 var_812;
    wp::int64 var_813;
    wp::int64 var_814;
    wp::int64 var_815;
    wp::int64 var_816;
    wp::int64 var_817;
    wp::int64 var_818;
    const wp::int32 var_819 = 2;
    wp::float32 var_820;
    wp::float32 var_821;
    wp::float32 var_822;
    wp::float32 var_823;
    wp::float32 var_824;
    wp::float32 var_825;
    wp::float32 var_826;
    wp::float32 var_827;
    wp::float32 var_828;
    wp::float32 var_829;
    wp::float32 var_830;
    bool var_831;
    wp::float32 var_832;
    const wp::float32 var_833 = 0.0;
    wp::float32 var_834;
    wp::int64 var_835;
    wp::float32 var_836;
    const wp::float32 var_837 = 0.0;
    wp::float32 var_838;
    wp::int64 var_839;
    wp::float32 var_840;
    const wp::float32 var_841 = 0.0;
    wp::float32 var_842;
    wp::int64 var_843;
    const wp::int32 var_844 = 1;
    const wp::int32 var_845 = 0;
    wp::int32 var_846;
    wp::int64 var_847;
    wp::int64 var_848;
    wp::int64 var_849;
    wp::int64 var_850;
    wp::int64 var_851;
    wp::int64 var_852;
    wp::int64 var_853;
    wp::int64 var_854;
    wp::int64 var_855;
    wp::int64 var_856;
    wp::int64 var_857;
    wp::int64 var_858;
    wp::int64 var_859;
    wp::int64 var_860;
    wp::int64 var_861;
    wp::int64 var_862;
    wp::int64 var_863;
    const wp::int32 var_864 = 3;
    wp::float32 var_865;
    wp::float32 var_866;
    wp::float32 var_867;
    wp::float32 var_868;
    wp::float32 var_869;
    wp::float32 var_870;
    wp::float32 var_871;
    wp::float32 var_872;
    wp::float32 var_873;
    wp::float32 var_874;
    wp::float32 var_875;
    bool var_876;
    wp::float32 var_877;
    const wp::float32 var_878 = 0.0;
    wp::float32 var_879;
    wp::int64 var_880;
    wp::float32 var_881;
    const wp::float32 var_882 = 0.0;
    wp::float32 var_883;
    wp::int64 var_884;
    wp::float32 var_885;
    const wp::float32 var_886 = 0.0;
    wp::float32 var_887;
    wp::int64 var_888;
    const wp::int32 var_889 = 1;
    const wp::int32 var_890 = 0;
    wp::int32 var_891;
    wp::int64 var_892;
    wp::int64 var_893;
    wp::int64 var_894;
    wp::int64 var_895;
    wp::int64 var_896;
    wp::int64 var_897;
    wp::int64 var_898;
    wp::int64 var_899;
    wp::int64 var_900;
    wp::int64 var_901;
    wp::int64 var_902;
    wp::int64 var_903;
    wp::int64 var_904;
    wp::int64 var_905;
    wp::int64 var_906;
    wp::int64 var_907;
    wp::int64 var_908;
    const wp::int32 var_909 = 4;
    wp::float32 var_910;
    wp::float32 var_911;
    wp::float32 var_912;
    wp::float32 var_913;
    wp::float32 var_914;
    wp::float32 var_915;
    wp::float32 var_916;
    wp::float32 var_917;
    wp::float32 var_918;
    wp::float32 var_919;
    wp::float32 var_920;
    bool var_921;
    wp::float32 var_922;
    const wp::float32 var_923 = 0.0;
    wp::float32 var_924;
    wp::int64 var_925;
    wp::float32 var_926;
    const wp::float32 var_927 = 0.0;
    wp::float32 var_928;
    wp::int64 var_929;
    wp::float32 var_930;
    const wp::float32 var_931 = 0.0;
    wp::float32 var_932;
    wp::int64 var_933;
    const wp::int32 var_934 = 1;
    const wp::int32 var_935 = 0;
    wp::int32 var_936;
    wp::int64 var_937;
    wp::int64 var_938;
    wp::int64 var_939;
    wp::int64 var_940;
    wp::int64 var_941;
    wp::int64 var_942;
    wp::int64 var_943;
    wp::int64 var_944;
    wp::int64 var_945;
    wp::int64 var_946;
    wp::int64 var_947;
    wp::int64 var_948;
    wp::int64 var_949;
    wp::int64 var_950;
    wp::int64 var_951;
    wp::int64 var_952;
    wp::int64 var_953;
    const wp::int32 var_954 = 5;
    wp::float32 var_955;
    wp::float32 var_956;
    wp::float32 var_957;
    wp::float32 var_958;
    wp::float32 var_959;
    wp::float32 var_960;
    wp::float32 var_961;
    wp::float32 var_962;
    wp::float32 var_963;
    wp::float32 var_964;
    wp::float32 var_965;
    bool var_966;
    wp::float32 var_967;
    const wp::float32 var_968 = 0.0;
    wp::float32 var_969;
    wp::int64 var_970;
    wp::float32 var_971;
    const wp::float32 var_972 = 0.0;
    wp::float32 var_973;
    wp::int64 var_974;
    wp::float32 var_975;
    const wp::float32 var_976 = 0.0;
    wp::float32 var_977;
    wp::int64 var_978;
    const wp::int32 var_979 = 1;
    const wp::int32 var_980 = 0;
    wp::int32 var_981;
    wp::int64 var_982;
    wp::int64 var_983;
    wp::int64 var_984;
    wp::int64 var_985;
    wp::int64 var_986;
    wp::int64 var_987;
    wp::int64 var_988;
    wp::int64 var_989;
    wp::int64 var_990;
    wp::int64 var_991;
    wp::int64 var_992;
    wp::int64 var_993;
    wp::int64 var_994;
    wp::int64 var_995;
    wp::int64 var_996;
    wp::int64 var_997;
    wp::int64 var_998;
    const wp::int32 var_999 = 6;
    wp::float32 var_1000;
    wp::float32 var_1001;
    wp::float32 var_1002;
    wp::float32 var_1003;
    wp::float32 var_1004;
    wp::float32 var_1005;
    wp::float32 var_1006;
    wp::float32 var_1007;
    wp::float32 var_1008;
    wp::float32 var_1009;
    wp::float32 var_1010;
    bool var_1011;
    wp::float32 var_1012;
    const wp::float32 var_1013 = 0.0;
    wp::float32 var_1014;
    wp::int64 var_1015;
    wp::float32 var_1016;
    const wp::float32 var_1017 = 0.0;
    wp::float32 var_1018;
    wp::int64 var_1019;
    wp::float32 var_1020;
    const wp::float32 var_1021 = 0.0;
    wp::float32 var_1022;
    wp::int64 var_1023;
    const wp::int32 var_1024 = 1;
    const wp::int32 var_1025 = 0;
    wp::int32 var_1026;
    wp::int64 var_1027;
    wp::int64 var_1028;
    wp::int64 var_1029;
    wp::int64 var_1030;
    wp::int64 var_1031;
    wp::int64 var_1032;
    wp::int64 var_1033;
    wp::int64 var_1034;
    wp::int64 var_1035;
    wp::int64 var_1036;
    wp::int64 var_1037;
    wp::int64 var_1038;
    wp::int64 var_1039;
    wp::int64 var_1040;
    wp::int64 var_1041;
    wp::int64 var_1042;
    wp::int64 var_1043;
    const wp::int32 var_1044 = 7;
    wp::float32 var_1045;
    wp::float32 var_1046;
    wp::float32 var_1047;
    wp::float32 var_1048;
    wp::float32 var_1049;
    wp::float32 var_1050;
    wp::float32 var_1051;
    wp::float32 var_1052;
    wp::float32 var_1053;
    wp::float32 var_1054;
    wp::float32 var_1055;
    bool var_1056;
    wp::float32 var_1057;
    const wp::float32 var_1058 = 0.0;
    wp::float32 var_1059;
    wp::int64 var_1060;
    wp::float32 var_1061;
    const wp::float32 var_1062 = 0.0;
    wp::float32 var_1063;
    wp::int64 var_1064;
    wp::float32 var_1065;
    const wp::float32 var_1066 = 0.0;
    wp::float32 var_1067;
    wp::int64 var_1068;
    const wp::int32 var_1069 = 1;
    const wp::int32 var_1070 = 0;
    wp::int32 var_1071;
    wp::int64 var_1072;
    wp::int64 var_1073;
    wp::int64 var_1074;
    wp::int64 var_1075;
    wp::int64 var_1076;
    wp::int64 var_1077;
    wp::int64 var_1078;
    wp::int64 var_1079;
    wp::int64 var_1080;
    wp::int64 var_1081;
    wp::int64 var_1082;
    wp::int64 var_1083;
    wp::int64 var_1084;
    wp::int64 var_1085;
    wp::int64 var_1086;
    wp::int64 var_1087;
    wp::int64 var_1088;
    wp::int64 var_1089;
    wp::int64 var_1090;
    wp::int64 var_1091;
    wp::int64 var_1092;
    wp::int64 var_1093;
    wp::int64 var_1094;
    wp::int64 var_1095;
    wp::int64 var_1096;
    wp::int64 var_1097;
    wp::int64 var_1098;
    wp::int32 var_1099;
    wp::int32 var_1100;
    wp::vec_t<3, wp::float32> var_1101;
    bool var_1102;
    wp::int64 var_1103;
    wp::int64 var_1104;
    wp::int64 var_1105;
    const wp::int32 var_1106 = 2;
    wp::float32 var_1107;
    bool var_1108;
    wp::int32 var_1109;
    wp::int32 var_1110;
    wp::int32 var_1111;
    const wp::int32 var_1112 = 0;
    wp::int32 var_1113;
    wp::vec_t<3, wp::float32>* var_1114;
    wp::vec_t<3, wp::float32> var_1115;
    wp::vec_t<3, wp::float32> var_1116;
    const wp::int32 var_1117 = 0;
    wp::float32 var_1118;
    const wp::int32 var_1119 = 0;
    wp::float32 var_1120;
    wp::float32 var_1121;
    const wp::int32 var_1122 = 1;
    wp::float32 var_1123;
    const wp::int32 var_1124 = 1;
    wp::float32 var_1125;
    wp::float32 var_1126;
    const wp::int32 var_1127 = 2;
    wp::float32 var_1128;
    const wp::int32 var_1129 = 2;
    wp::float32 var_1130;
    wp::float32 var_1131;
    const wp::int32 var_1132 = 1;
    wp::int32 var_1133;
    wp::vec_t<3, wp::float32>* var_1134;
    wp::vec_t<3, wp::float32> var_1135;
    wp::vec_t<3, wp::float32> var_1136;
    const wp::int32 var_1137 = 0;
    wp::float32 var_1138;
    const wp::int32 var_1139 = 0;
    wp::float32 var_1140;
    wp::float32 var_1141;
    const wp::int32 var_1142 = 1;
    wp::float32 var_1143;
    const wp::int32 var_1144 = 1;
    wp::float32 var_1145;
    wp::float32 var_1146;
    const wp::int32 var_1147 = 2;
    wp::float32 var_1148;
    const wp::int32 var_1149 = 2;
    wp::float32 var_1150;
    wp::float32 var_1151;
    const wp::int32 var_1152 = 2;
    wp::int32 var_1153;
    wp::vec_t<3, wp::float32>* var_1154;
    wp::vec_t<3, wp::float32> var_1155;
    wp::vec_t<3, wp::float32> var_1156;
    const wp::int32 var_1157 = 0;
    wp::float32 var_1158;
    const wp::int32 var_1159 = 0;
    wp::float32 var_1160;
    wp::float32 var_1161;
    const wp::int32 var_1162 = 1;
    wp::float32 var_1163;
    const wp::int32 var_1164 = 1;
    wp::float32 var_1165;
    wp::float32 var_1166;
    const wp::int32 var_1167 = 2;
    wp::float32 var_1168;
    const wp::int32 var_1169 = 2;
    wp::float32 var_1170;
    wp::float32 var_1171;
    const wp::int32 var_1172 = 3;
    wp::int32 var_1173;
    wp::vec_t<3, wp::float32>* var_1174;
    wp::vec_t<3, wp::float32> var_1175;
    wp::vec_t<3, wp::float32> var_1176;
    const wp::int32 var_1177 = 0;
    wp::float32 var_1178;
    const wp::int32 var_1179 = 0;
    wp::float32 var_1180;
    wp::float32 var_1181;
    const wp::int32 var_1182 = 1;
    wp::float32 var_1183;
    const wp::int32 var_1184 = 1;
    wp::float32 var_1185;
    wp::float32 var_1186;
    const wp::int32 var_1187 = 2;
    wp::float32 var_1188;
    const wp::int32 var_1189 = 2;
    wp::float32 var_1190;
    wp::float32 var_1191;
    const wp::int32 var_1192 = 4;
    wp::int32 var_1193;
    wp::vec_t<3, wp::float32>* var_1194;
    wp::vec_t<3, wp::float32> var_1195;
    wp::vec_t<3, wp::float32> var_1196;
    const wp::int32 var_1197 = 0;
    wp::float32 var_1198;
    const wp::int32 var_1199 = 0;
    wp::float32 var_1200;
    wp::float32 var_1201;
    const wp::int32 var_1202 = 1;
    wp::float32 var_1203;
    const wp::int32 var_1204 = 1;
    wp::float32 var_1205;
    wp::float32 var_1206;
    const wp::int32 var_1207 = 2;
    wp::float32 var_1208;
    const wp::int32 var_1209 = 2;
    wp::float32 var_1210;
    wp::float32 var_1211;
    const wp::int32 var_1212 = 5;
    wp::int32 var_1213;
    wp::vec_t<3, wp::float32>* var_1214;
    wp::vec_t<3, wp::float32> var_1215;
    wp::vec_t<3, wp::float32> var_1216;
    const wp::int32 var_1217 = 0;
    wp::float32 var_1218;
    const wp::int32 var_1219 = 0;
    wp::float32 var_1220;
    wp::float32 var_1221;
    const wp::int32 var_1222 = 1;
    wp::float32 var_1223;
    const wp::int32 var_1224 = 1;
    wp::float32 var_1225;
    wp::float32 var_1226;
    const wp::int32 var_1227 = 2;
    wp::float32 var_1228;
    const wp::int32 var_1229 = 2;
    wp::float32 var_1230;
    wp::float32 var_1231;
    const wp::int32 var_1232 = 6;
    wp::int32 var_1233;
    wp::vec_t<3, wp::float32>* var_1234;
    wp::vec_t<3, wp::float32> var_1235;
    wp::vec_t<3, wp::float32> var_1236;
    const wp::int32 var_1237 = 0;
    wp::float32 var_1238;
    const wp::int32 var_1239 = 0;
    wp::float32 var_1240;
    wp::float32 var_1241;
    const wp::int32 var_1242 = 1;
    wp::float32 var_1243;
    const wp::int32 var_1244 = 1;
    wp::float32 var_1245;
    wp::float32 var_1246;
    const wp::int32 var_1247 = 2;
    wp::float32 var_1248;
    const wp::int32 var_1249 = 2;
    wp::float32 var_1250;
    wp::float32 var_1251;
    const wp::int32 var_1252 = 7;
    wp::int32 var_1253;
    wp::vec_t<3, wp::float32>* var_1254;
    wp::vec_t<3, wp::float32> var_1255;
    wp::vec_t<3, wp::float32> var_1256;
    const wp::int32 var_1257 = 0;
    wp::float32 var_1258;
    const wp::int32 var_1259 = 0;
    wp::float32 var_1260;
    wp::float32 var_1261;
    const wp::int32 var_1262 = 1;
    wp::float32 var_1263;
    const wp::int32 var_1264 = 1;
    wp::float32 var_1265;
    wp::float32 var_1266;
    const wp::int32 var_1267 = 2;
    wp::float32 var_1268;
    const wp::int32 var_1269 = 2;
    wp::float32 var_1270;
    wp::float32 var_1271;
    const wp::int32 var_1272 = 0;
    wp::float32 var_1273;
    wp::float32 var_1274;
    wp::float32 var_1275;
    wp::float32 var_1276;
    wp::float32 var_1277;
    wp::float32 var_1278;
    wp::float32 var_1279;
    wp::float32 var_1280;
    wp::float32 var_1281;
    wp::float32 var_1282;
    wp::float32 var_1283;
    bool var_1284;
    wp::float32 var_1285;
    const wp::float32 var_1286 = 0.0;
    wp::float32 var_1287;
    wp::int64 var_1288;
    wp::float32 var_1289;
    const wp::float32 var_1290 = 0.0;
    wp::float32 var_1291;
    wp::int64 var_1292;
    wp::float32 var_1293;
    const wp::float32 var_1294 = 0.0;
    wp::float32 var_1295;
    wp::int64 var_1296;
    const wp::int32 var_1297 = 1;
    const wp::int32 var_1298 = 0;
    wp::int32 var_1299;
    wp::int64 var_1300;
    wp::int64 var_1301;
    wp::int64 var_1302;
    wp::int64 var_1303;
    wp::int64 var_1304;
    wp::int64 var_1305;
    wp::int64 var_1306;
    wp::int64 var_1307;
    wp::int64 var_1308;
    wp::int64 var_1309;
    wp::int64 var_1310;
    wp::int64 var_1311;
    wp::int64 var_1312;
    wp::int64 var_1313;
    wp::int64 var_1314;
    wp::int64 var_1315;
    wp::int64 var_1316;
    const wp::int32 var_1317 = 1;
    wp::float32 var_1318;
    wp::float32 var_1319;
    wp::float32 var_1320;
    wp::float32 var_1321;
    wp::float32 var_1322;
    wp::float32 var_1323;
    wp::float32 var_1324;
    wp::float32 var_1325;
    wp::float32 var_1326;
    wp::float32 var_1327;
    wp::float32 var_1328;
    bool var_1329;
    wp::float32 var_1330;
    const wp::float32 var_1331 = 0.0;
    wp::float32 var_1332;
    wp::int64 var_1333;
    wp::float32 var_1334;
    const wp::float32 var_1335 = 0.0;
    wp::float32 var_1336;
    wp::int64 var_1337;
    wp::float32 var_1338;
    const wp::float32 var_1339 = 0.0;
    wp::float32 var_1340;
    wp::int64 var_1341;
    const wp::int32 var_1342 = 1;
    const wp::int32 var_1343 = 0;
    wp::int32 var_1344;
    wp::int64 var_1345;
    wp::int64 var_1346;
    wp::int64 var_1347;
    wp::int64 var_1348;
    wp::int64 var_1349;
    wp::int64 var_1350;
    wp::int64 var_1351;
    wp::int64 var_1352;
    wp::int64 var_1353;
    wp::int64 var_1354;
    wp::int64 var_1355;
    wp::int64 var_1356;
    wp::int64 var_1357;
    wp::int64 var_1358;
    wp::int64 var_1359;
    wp::int64 var_1360;
    wp::int64 var_1361;
    const wp::int32 var_1362 = 2;
    wp::float32 var_1363;
    wp::float32 var_1364;
    wp::float32 var_1365;
    wp::float32 var_1366;
    wp::float32 var_1367;
    wp::float32 var_1368;
    wp::float32 var_1369;
    wp::float32 var_1370;
    wp::float32 var_1371;
    wp::float32 var_1372;
    wp::float32 var_1373;
    bool var_1374;
    wp::float32 var_1375;
    const wp::float32 var_1376 = 0.0;
    wp::float32 var_1377;
    wp::int64 var_1378;
    wp::float32 var_1379;
    const wp::float32 var_1380 = 0.0;
    wp::float32 var_1381;
    wp::int64 var_1382;
    wp::float32 var_1383;
    const wp::float32 var_1384 = 0.0;
    wp::float32 var_1385;
    wp::int64 var_1386;
    const wp::int32 var_1387 = 1;
    const wp::int32 var_1388 = 0;
    wp::int32 var_1389;
    wp::int64 var_1390;
    wp::int64 var_1391;
    wp::int64 var_1392;
    wp::int64 var_1393;
    wp::int64 var_1394;
    wp::int64 var_1395;
    wp::int64 var_1396;
    wp::int64 var_1397;
    wp::int64 var_1398;
    wp::int64 var_1399;
    wp::int64 var_1400;
    wp::int64 var_1401;
    wp::int64 var_1402;
    wp::int64 var_1403;
    wp::int64 var_1404;
    wp::int64 var_1405;
    wp::int64 var_1406;
    const wp::int32 var_1407 = 3;
    wp::float32 var_1408;
    wp::float32 var_1409;
    wp::float32 var_1410;
    wp::float32 var_1411;
    wp::float32 var_1412;
    wp::float32 var_1413;
    wp::float32 var_1414;
    wp::float32 var_1415;
    wp::float32 var_1416;
    wp::float32 var_1417;
    wp::float32 var_1418;
    bool var_1419;
    wp::float32 var_1420;
    const wp::float32 var_1421 = 0.0;
    wp::float32 var_1422;
    wp::int64 var_1423;
    wp::float32 var_1424;
    const wp::float32 var_1425 = 0.0;
    wp::float32 var_1426;
    wp::int64 var_1427;
    wp::float32 var_1428;
    const wp::float32 var_1429 = 0.0;
    wp::float32 var_1430;
    wp::int64 var_1431;
    const wp::int32 var_1432 = 1;
    const wp::int32 var_1433 = 0;
    wp::int32 var_1434;
    wp::int64 var_1435;
    wp::int64 var_1436;
    wp::int64 var_1437;
    wp::int64 var_1438;
    wp::int64 var_1439;
    wp::int64 var_1440;
    wp::int64 var_1441;
    wp::int64 var_1442;
    wp::int64 var_1443;
    wp::int64 var_1444;
    wp::int64 var_1445;
    wp::int64 var_1446;
    wp::int64 var_1447;
    wp::int64 var_1448;
    wp::int64 var_1449;
    wp::int64 var_1450;
    wp::int64 var_1451;
    const wp::int32 var_1452 = 4;
    wp::float32 var_1453;
    wp::float32 var_1454;
    wp::float32 var_1455;
    wp::float32 var_1456;
    wp::float32 var_1457;
    wp::float32 var_1458;
    wp::float32 var_1459;
    wp::float32 var_1460;
    wp::float32 var_1461;
    wp::float32 var_1462;
    wp::float32 var_1463;
    bool var_1464;
    wp::float32 var_1465;
    const wp::float32 var_1466 = 0.0;
    wp::float32 var_1467;
    wp::int64 var_1468;
    wp::float32 var_1469;
    const wp::float32 var_1470 = 0.0;
    wp::float32 var_1471;
    wp::int64 var_1472;
    wp::float32 var_1473;
    const wp::float32 var_1474 = 0.0;
    wp::float32 var_1475;
    wp::int64 var_1476;
    const wp::int32 var_1477 = 1;
    const wp::int32 var_1478 = 0;
    wp::int32 var_1479;
    wp::int64 var_1480;
    wp::int64 var_1481;
    wp::int64 var_1482;
    wp::int64 var_1483;
    wp::int64 var_1484;
    wp::int64 var_1485;
    wp::int64 var_1486;
    wp::int64 var_1487;
    wp::int64 var_1488;
    wp::int64 var_1489;
    wp::int64 var_1490;
    wp::int64 var_1491;
    wp::int64 var_1492;
    wp::int64 var_1493;
    wp::int64 var_1494;
    wp::int64 var_1495;
    wp::int64 var_1496;
    const wp::int32 var_1497 = 5;
    wp::float32 var_1498;
    wp::float32 var_1499;
    wp::float32 var_1500;
    wp::float32 var_1501;
    wp::float32 var_1502;
    wp::float32 var_1503;
    wp::float32 var_1504;
    wp::float32 var_1505;
    wp::float32 var_1506;
    wp::float32 var_1507;
    wp::float32 var_1508;
    bool var_1509;
    wp::float32 var_1510;
    const wp::float32 var_1511 = 0.0;
    wp::float32 var_1512;
    wp::int64 var_1513;
    wp::float32 var_1514;
    const wp::float32 var_1515 = 0.0;
    wp::float32 var_1516;
    wp::int64 var_1517;
    wp::float32 var_1518;
    const wp::float32 var_1519 = 0.0;
    wp::float32 var_1520;
    wp::int64 var_1521;
    const wp::int32 var_1522 = 1;
    const wp::int32 var_1523 = 0;
    wp::int32 var_1524;
    wp::int64 var_1525;
    wp::int64 var_1526;
    wp::int64 var_1527;
    wp::int64 var_1528;
    wp::int64 var_1529;
    wp::int64 var_1530;
    wp::int64 var_1531;
    wp::int64 var_1532;
    wp::int64 var_1533;
    wp::int64 var_1534;
    wp::int64 var_1535;
    wp::int64 var_1536;
    wp::int64 var_1537;
    wp::int64 var_1538;
    wp::int64 var_1539;
    wp::int64 var_1540;
    wp::int64 var_1541;
    const wp::int32 var_1542 = 6;
    wp::float32 var_1543;
    wp::float32 var_1544;
    wp::float32 var_1545;
    wp::float32 var_1546;
    wp::float32 var_1547;
    wp::float32 var_1548;
    wp::float32 var_1549;
    wp::float32 var_1550;
    wp::float32 var_1551;
    wp::float32 var_1552;
    wp::float32 var_1553;
    bool var_1554;
    wp::float32 var_1555;
    const wp::float32 var_1556 = 0.0;
    wp::float32 var_1557;
    wp::int64 var_1558;
    wp::float32 var_1559;
    const wp::float32 var_1560 = 0.0;
    wp::float32 var_1561;
    wp::int64 var_1562;
    wp::float32 var_1563;
    const wp::float32 var_1564 = 0.0;
    wp::float32 var_1565;
    wp::int64 var_1566;
    const wp::int32 var_1567 = 1;
    const wp::int32 var_1568 = 0;
    wp::int32 var_1569;
    wp::int64 var_1570;
    wp::int64 var_1571;
    wp::int64 var_1572;
    wp::int64 var_1573;
    wp::int64 var_1574;
    wp::int64 var_1575;
    wp::int64 var_1576;
    wp::int64 var_1577;
    wp::int64 var_1578;
    wp::int64 var_1579;
    wp::int64 var_1580;
    wp::int64 var_1581;
    wp::int64 var_1582;
    wp::int64 var_1583;
    wp::int64 var_1584;
    wp::int64 var_1585;
    wp::int64 var_1586;
    const wp::int32 var_1587 = 7;
    wp::float32 var_1588;
    wp::float32 var_1589;
    wp::float32 var_1590;
    wp::float32 var_1591;
    wp::float32 var_1592;
    wp::float32 var_1593;
    wp::float32 var_1594;
    wp::float32 var_1595;
    wp::float32 var_1596;
    wp::float32 var_1597;
    wp::float32 var_1598;
    bool var_1599;
    wp::float32 var_1600;
    const wp::float32 var_1601 = 0.0;
    wp::float32 var_1602;
    wp::int64 var_1603;
    wp::float32 var_1604;
    const wp::float32 var_1605 = 0.0;
    wp::float32 var_1606;
    wp::int64 var_1607;
    wp::float32 var_1608;
    const wp::float32 var_1609 = 0.0;
    wp::float32 var_1610;
    wp::int64 var_1611;
    const wp::int32 var_1612 = 1;
    const wp::int32 var_1613 = 0;
    wp::int32 var_1614;
    wp::int64 var_1615;
    wp::int64 var_1616;
    wp::int64 var_1617;
    wp::int64 var_1618;
    wp::int64 var_1619;
    wp::int64 var_1620;
    wp::int64 var_1621;
    wp::int64 var_1622;
    wp::int64 var_1623;
    wp::int64 var_1624;
    wp::int64 var_1625;
    wp::int64 var_1626;
    wp::int64 var_1627;
    wp::int64 var_1628;
    wp::int64 var_1629;
    wp::int64 var_1630;
    wp::int64 var_1631;
    wp::int64 var_1632;
    wp::int64 var_1633;
    wp::int64 var_1634;
    wp::int64 var_1635;
    wp::int64 var_1636;
    wp::int64 var_1637;
    wp::int64 var_1638;
    wp::int64 var_1639;
    wp::int64 var_1640;
    wp::int64 var_1641;
    wp::int32 var_1642;
    wp::int32 var_1643;
    wp::vec_t<3, wp::float32> var_1644;
    bool var_1645;
    wp::int64 var_1646;
    wp::int64 var_1647;
    wp::int64 var_1648;
    const wp::int32 var_1649 = 3;
    wp::float32 var_1650;
    bool var_1651;
    wp::int32 var_1652;
    wp::int32 var_1653;
    wp::int32 var_1654;
    const wp::int32 var_1655 = 0;
    wp::int32 var_1656;
    wp::vec_t<3, wp::float32>* var_1657;
    wp::vec_t<3, wp::float32> var_1658;
    wp::vec_t<3, wp::float32> var_1659;
    const wp::int32 var_1660 = 0;
    wp::float32 var_1661;
    const wp::int32 var_1662 = 0;
    wp::float32 var_1663;
    wp::float32 var_1664;
    const wp::int32 var_1665 = 1;
    wp::float32 var_1666;
    const wp::int32 var_1667 = 1;
    wp::float32 var_1668;
    wp::float32 var_1669;
    const wp::int32 var_1670 = 2;
    wp::float32 var_1671;
    const wp::int32 var_1672 = 2;
    wp::float32 var_1673;
    wp::float32 var_1674;
    const wp::int32 var_1675 = 1;
    wp::int32 var_1676;
    wp::vec_t<3, wp::float32>* var_1677;
    wp::vec_t<3, wp::float32> var_1678;
    wp::vec_t<3, wp::float32> var_1679;
    const wp::int32 var_1680 = 0;
    wp::float32 var_1681;
    const wp::int32 var_1682 = 0;
    wp::float32 var_1683;
    wp::float32 var_1684;
    const wp::int32 var_1685 = 1;
    wp::float32 var_1686;
    const wp::int32 var_1687 = 1;
    wp::float32 var_1688;
    wp::float32 var_1689;
    const wp::int32 var_1690 = 2;
    wp::float32 var_1691;
    const wp::int32 var_1692 = 2;
    wp::float32 var_1693;
    wp::float32 var_1694;
    const wp::int32 var_1695 = 2;
    wp::int32 var_1696;
    wp::vec_t<3, wp::float32>* var_1697;
    wp::vec_t<3, wp::float32> var_1698;
    wp::vec_t<3, wp::float32> var_1699;
    const wp::int32 var_1700 = 0;
    wp::float32 var_1701;
    const wp::int32 var_1702 = 0;
    wp::float32 var_1703;
    wp::float32 var_1704;
    const wp::int32 var_1705 = 1;
    wp::float32 var_1706;
    const wp::int32 var_1707 = 1;
    wp::float32 var_1708;
    wp::float32 var_1709;
    const wp::int32 var_1710 = 2;
    wp::float32 var_1711;
    const wp::int32 var_1712 = 2;
    wp::float32 var_1713;
    wp::float32 var_1714;
    const wp::int32 var_1715 = 3;
    wp::int32 var_1716;
    wp::vec_t<3, wp::float32>* var_1717;
    wp::vec_t<3, wp::float32> var_1718;
    wp::vec_t<3, wp::float32> var_1719;
    const wp::int32 var_1720 = 0;
    wp::float32 var_1721;
    const wp::int32 var_1722 = 0;
    wp::float32 var_1723;
    wp::float32 var_1724;
    const wp::int32 var_1725 = 1;
    wp::float32 var_1726;
    const wp::int32 var_1727 = 1;
    wp::float32 var_1728;
    wp::float32 var_1729;
    const wp::int32 var_1730 = 2;
    wp::float32 var_1731;
    const wp::int32 var_1732 = 2;
    wp::float32 var_1733;
    wp::float32 var_1734;
    const wp::int32 var_1735 = 4;
    wp::int32 var_1736;
    wp::vec_t<3, wp::float32>* var_1737;
    wp::vec_t<3, wp::float32> var_1738;
    wp::vec_t<3, wp::float32> var_1739;
    const wp::int32 var_1740 = 0;
    wp::float32 var_1741;
    const wp::int32 var_1742 = 0;
    wp::float32 var_1743;
    wp::float32 var_1744;
    const wp::int32 var_1745 = 1;
    wp::float32 var_1746;
    const wp::int32 var_1747 = 1;
    wp::float32 var_1748;
    wp::float32 var_1749;
    const wp::int32 var_1750 = 2;
    wp::float32 var_1751;
    const wp::int32 var_1752 = 2;
    wp::float32 var_1753;
    wp::float32 var_1754;
    const wp::int32 var_1755 = 5;
    wp::int32 var_1756;
    wp::vec_t<3, wp::float32>* var_1757;
    wp::vec_t<3, wp::float32> var_1758;
    wp::vec_t<3, wp::float32> var_1759;
    const wp::int32 var_1760 = 0;
    wp::float32 var_1761;
    const wp::int32 var_1762 = 0;
    wp::float32 var_1763;
    wp::float32 var_1764;
    const wp::int32 var_1765 = 1;
    wp::float32 var_1766;
    const wp::int32 var_1767 = 1;
    wp::float32 var_1768;
    wp::float32 var_1769;
    const wp::int32 var_1770 = 2;
    wp::float32 var_1771;
    const wp::int32 var_1772 = 2;
    wp::float32 var_1773;
    wp::float32 var_1774;
    const wp::int32 var_1775 = 6;
    wp::int32 var_1776;
    wp::vec_t<3, wp::float32>* var_1777;
    wp::vec_t<3, wp::float32> var_1778;
    wp::vec_t<3, wp::float32> var_1779;
    const wp::int32 var_1780 = 0;
    wp::float32 var_1781;
    const wp::int32 var_1782 = 0;
    wp::float32 var_1783;
    wp::float32 var_1784;
    const wp::int32 var_1785 = 1;
    wp::float32 var_1786;
    const wp::int32 var_1787 = 1;
    wp::float32 var_1788;
    wp::float32 var_1789;
    const wp::int32 var_1790 = 2;
    wp::float32 var_1791;
    const wp::int32 var_1792 = 2;
    wp::float32 var_1793;
    wp::float32 var_1794;
    const wp::int32 var_1795 = 7;
    wp::int32 var_1796;
    wp::vec_t<3, wp::float32>* var_1797;
    wp::vec_t<3, wp::float32> var_1798;
    wp::vec_t<3, wp::float32> var_1799;
    const wp::int32 var_1800 = 0;
    wp::float32 var_1801;
    const wp::int32 var_1802 = 0;
    wp::float32 var_1803;
    wp::float32 var_1804;
    const wp::int32 var_1805 = 1;
    wp::float32 var_1806;
    const wp::int32 var_1807 = 1;
    wp::float32 var_1808;
    wp::float32 var_1809;
    const wp::int32 var_1810 = 2;
    wp::float32 var_1811;
    const wp::int32 var_1812 = 2;
    wp::float32 var_1813;
    wp::float32 var_1814;
    const wp::int32 var_1815 = 0;
    wp::float32 var_1816;
    wp::float32 var_1817;
    wp::float32 var_1818;
    wp::float32 var_1819;
    wp::float32 var_1820;
    wp::float32 var_1821;
    wp::float32 var_1822;
    wp::float32 var_1823;
    wp::float32 var_1824;
    wp::float32 var_1825;
    wp::float32 var_1826;
    bool var_1827;
    wp::float32 var_1828;
    const wp::float32 var_1829 = 0.0;
    wp::float32 var_1830;
    wp::int64 var_1831;
    wp::float32 var_1832;
    const wp::float32 var_1833 = 0.0;
    wp::float32 var_1834;
    wp::int64 var_1835;
    wp::float32 var_1836;
    const wp::float32 var_1837 = 0.0;
    wp::float32 var_1838;
    wp::int64 var_1839;
    const wp::int32 var_1840 = 1;
    const wp::int32 var_1841 = 0;
    wp::int32 var_1842;
    wp::int64 var_1843;
    wp::int64 var_1844;
    wp::int64 var_1845;
    wp::int64 var_1846;
    wp::int64 var_1847;
    wp::int64 var_1848;
    wp::int64 var_1849;
    wp::int64 var_1850;
    wp::int64 var_1851;
    wp::int64 var_1852;
    wp::int64 var_1853;
    wp::int64 var_1854;
    wp::int64 var_1855;
    wp::int64 var_1856;
    wp::int64 var_1857;
    wp::int64 var_1858;
    wp::int64 var_1859;
    const wp::int32 var_1860 = 1;
    wp::float32 var_1861;
    wp::float32 var_1862;
    wp::float32 var_1863;
    wp::float32 var_1864;
    wp::float32 var_1865;
    wp::float32 var_1866;
    wp::float32 var_1867;
    wp::float32 var_1868;
    wp::float32 var_1869;
    wp::float32 var_1870;
    wp::float32 var_1871;
    bool var_1872;
    wp::float32 var_1873;
    const wp::float32 var_1874 = 0.0;
    wp::float32 var_1875;
    wp::int64 var_1876;
    wp::float32 var_1877;
    const wp::float32 var_1878 = 0.0;
    wp::float32 var_1879;
    wp::int64 var_1880;
    wp::float32 var_1881;
    const wp::float32 var_1882 = 0.0;
    wp::float32 var_1883;
    wp::int64 var_1884;
    const wp::int32 var_1885 = 1;
    const wp::int32 var_1886 = 0;
    wp::int32 var_1887;
    wp::int64 var_1888;
    wp::int64 var_1889;
    wp::int64 var_1890;
    wp::int64 var_1891;
    wp::int64 var_1892;
    wp::int64 var_1893;
    wp::int64 var_1894;
    wp::int64 var_1895;
    wp::int64 var_1896;
    wp::int64 var_1897;
    wp::int64 var_1898;
    wp::int64 var_1899;
    wp::int64 var_1900;
    wp::int64 var_1901;
    wp::int64 var_1902;
    wp::int64 var_1903;
    wp::int64 var_1904;
    const wp::int32 var_1905 = 2;
    wp::float32 var_1906;
    wp::float32 var_1907;
    wp::float32 var_1908;
    wp::float32 var_1909;
    wp::float32 var_1910;
    wp::float32 var_1911;
    wp::float32 var_1912;
    wp::float32 var_1913;
    wp::float32 var_1914;
    wp::float32 var_1915;
    wp::float32 var_1916;
    bool var_1917;
    wp::float32 var_1918;
    const wp::float32 var_1919 = 0.0;
    wp::float32 var_1920;
    wp::int64 var_1921;
    wp::float32 var_1922;
    const wp::float32 var_1923 = 0.0;
    wp::float32 var_1924;
    wp::int64 var_1925;
    wp::float32 var_1926;
    const wp::float32 var_1927 = 0.0;
    wp::float32 var_1928;
    wp::int64 var_1929;
    const wp::int32 var_1930 = 1;
    const wp::int32 var_1931 = 0;
    wp::int32 var_1932;
    wp::int64 var_1933;
    wp::int64 var_1934;
    wp::int64 var_1935;
    wp::int64 var_1936;
    wp::int64 var_1937;
    wp::int64 var_1938;
    wp::int64 var_1939;
    wp::int64 var_1940;
    wp::int64 var_1941;
    wp::int64 var_1942;
    wp::int64 var_1943;
    wp::int64 var_1944;
    wp::int64 var_1945;
    wp::int64 var_1946;
    wp::int64 var_1947;
    wp::int64 var_1948;
    wp::int64 var_1949;
    const wp::int32 var_1950 = 3;
    wp::float32 var_1951;
    wp::float32 var_1952;
    wp::float32 var_1953;
    wp::float32 var_1954;
    wp::float32 var_1955;
    wp::float32 var_1956;
    wp::float32 var_1957;
    wp::float32 var_1958;
    wp::float32 var_1959;
    wp::float32 var_1960;
    wp::float32 var_1961;
    bool var_1962;
    wp::float32 var_1963;
    const wp::float32 var_1964 = 0.0;
    wp::float32 var_1965;
    wp::int64 var_1966;
    wp::float32 var_1967;
    const wp::float32 var_1968 = 0.0;
    wp::float32 var_1969;
    wp::int64 var_1970;
    wp::float32 var_1971;
    const wp::float32 var_1972 = 0.0;
    wp::float32 var_1973;
    wp::int64 var_1974;
    const wp::int32 var_1975 = 1;
    const wp::int32 var_1976 = 0;
    wp::int32 var_1977;
    wp::int64 var_1978;
    wp::int64 var_1979;
    wp::int64 var_1980;
    wp::int64 var_1981;
    wp::int64 var_1982;
    wp::int64 var_1983;
    wp::int64 var_1984;
    wp::int64 var_1985;
    wp::int64 var_1986;
    wp::int64 var_1987;
    wp::int64 var_1988;
    wp::int64 var_1989;
    wp::int64 var_1990;
    wp::int64 var_1991;
    wp::int64 var_1992;
    wp::int64 var_1993;
    wp::int64 var_1994;
    const wp::int32 var_1995 = 4;
    wp::float32 var_1996;
    wp::float32 var_1997;
    wp::float32 var_1998;
    wp::float32 var_1999;
    wp::float32 var_2000;
    wp::float32 var_2001;
    wp::float32 var_2002;
    wp::float32 var_2003;
    wp::float32 var_2004;
    wp::float32 var_2005;
    wp::float32 var_2006;
    bool var_2007;
    wp::float32 var_2008;
    const wp::float32 var_2009 = 0.0;
    wp::float32 var_2010;
    wp::int64 var_2011;
    wp::float32 var_2012;
    const wp::float32 var_2013 = 0.0;
    wp::float32 var_2014;
    wp::int64 var_2015;
    wp::float32 var_2016;
    const wp::float32 var_2017 = 0.0;
    wp::float32 var_2018;
    wp::int64 var_2019;
    const wp::int32 var_2020 = 1;
    const wp::int32 var_2021 = 0;
    wp::int32 var_2022;
    wp::int64 var_2023;
    wp::int64 var_2024;
    wp::int64 var_2025;
    wp::int64 var_2026;
    wp::int64 var_2027;
    wp::int64 var_2028;
    wp::int64 var_2029;
    wp::int64 var_2030;
    wp::int64 var_2031;
    wp::int64 var_2032;
    wp::int64 var_2033;
    wp::int64 var_2034;
    wp::int64 var_2035;
    wp::int64 var_2036;
    wp::int64 var_2037;
    wp::int64 var_2038;
    wp::int64 var_2039;
    const wp::int32 var_2040 = 5;
    wp::float32 var_2041;
    wp::float32 var_2042;
    wp::float32 var_2043;
    wp::float32 var_2044;
    wp::float32 var_2045;
    wp::float32 var_2046;
    wp::float32 var_2047;
    wp::float32 var_2048;
    wp::float32 var_2049;
    wp::float32 var_2050;
    wp::float32 var_2051;
    bool var_2052;
    wp::float32 var_2053;
    const wp::float32 var_2054 = 0.0;
    wp::float32 var_2055;
    wp::int64 var_2056;
    wp::float32 var_2057;
    const wp::float32 var_2058 = 0.0;
    wp::float32 var_2059;
    wp::int64 var_2060;
    wp::float32 var_2061;
    const wp::float32 var_2062 = 0.0;
    wp::float32 var_2063;
    wp::int64 var_2064;
    const wp::int32 var_2065 = 1;
    const wp::int32 var_2066 = 0;
    wp::int32 var_2067;
    wp::int64 var_2068;
    wp::int64 var_2069;
    wp::int64 var_2070;
    wp::int64 var_2071;
    wp::int64 var_2072;
    wp::int64 var_2073;
    wp::int64 var_2074;
    wp::int64 var_2075;
    wp::int64 var_2076;
    wp::int64 var_2077;
    wp::int64 var_2078;
    wp::int64 var_2079;
    wp::int64 var_2080;
    wp::int64 var_2081;
    wp::int64 var_2082;
    wp::int64 var_2083;
    wp::int64 var_2084;
    const wp::int32 var_2085 = 6;
    wp::float32 var_2086;
    wp::float32 var_2087;
    wp::float32 var_2088;
    wp::float32 var_2089;
    wp::float32 var_2090;
    wp::float32 var_2091;
    wp::float32 var_2092;
    wp::float32 var_2093;
    wp::float32 var_2094;
    wp::float32 var_2095;
    wp::float32 var_2096;
    bool var_2097;
    wp::float32 var_2098;
    const wp::float32 var_2099 = 0.0;
    wp::float32 var_2100;
    wp::int64 var_2101;
    wp::float32 var_2102;
    const wp::float32 var_2103 = 0.0;
    wp::float32 var_2104;
    wp::int64 var_2105;
    wp::float32 var_2106;
    const wp::float32 var_2107 = 0.0;
    wp::float32 var_2108;
    wp::int64 var_2109;
    const wp::int32 var_2110 = 1;
    const wp::int32 var_2111 = 0;
    wp::int32 var_2112;
    wp::int64 var_2113;
    wp::int64 var_2114;
    wp::int64 var_2115;
    wp::int64 var_2116;
    wp::int64 var_2117;
    wp::int64 var_2118;
    wp::int64 var_2119;
    wp::int64 var_2120;
    wp::int64 var_2121;
    wp::int64 var_2122;
    wp::int64 var_2123;
    wp::int64 var_2124;
    wp::int64 var_2125;
    wp::int64 var_2126;
    wp::int64 var_2127;
    wp::int64 var_2128;
    wp::int64 var_2129;
    const wp::int32 var_2130 = 7;
    wp::float32 var_2131;
    wp::float32 var_2132;
    wp::float32 var_2133;
    wp::float32 var_2134;
    wp::float32 var_2135;
    wp::float32 var_2136;
    wp::float32 var_2137;
    wp::float32 var_2138;
    wp::float32 var_2139;
    wp::float32 var_2140;
    wp::float32 var_2141;
    bool var_2142;
    wp::float32 var_2143;
    const wp::float32 var_2144 = 0.0;
    wp::float32 var_2145;
    wp::int64 var_2146;
    wp::float32 var_2147;
    const wp::float32 var_2148 = 0.0;
    wp::float32 var_2149;
    wp::int64 var_2150;
    wp::float32 var_2151;
    const wp::float32 var_2152 = 0.0;
    wp::float32 var_2153;
    wp::int64 var_2154;
    const wp::int32 var_2155 = 1;
    const wp::int32 var_2156 = 0;
    wp::int32 var_2157;
    wp::int64 var_2158;
    wp::int64 var_2159;
    wp::int64 var_2160;
    wp::int64 var_2161;
    wp::int64 var_2162;
    wp::int64 var_2163;
    wp::int64 var_2164;
    wp::int64 var_2165;
    wp::int64 var_2166;
    wp::int64 var_2167;
    wp::int64 var_2168;
    wp::int64 var_2169;
    wp::int64 var_2170;
    wp::int64 var_2171;
    wp::int64 var_2172;
    wp::int64 var_2173;
    wp::int64 var_2174;
    wp::int64 var_2175;
    wp::int64 var_2176;
    wp::int64 var_2177;
    wp::int64 var_2178;
    wp::int64 var_2179;
    wp::int64 var_2180;
    wp::int64 var_2181;
    wp::int64 var_2182;
    wp::int64 var_2183;
    wp::int64 var_2184;
    wp::int32 var_2185;
    wp::int32 var_2186;
    wp::vec_t<3, wp::float32> var_2187;
    bool var_2188;
    wp::int64 var_2189;
    wp::int64 var_2190;
    wp::int64 var_2191;
    const wp::int32 var_2192 = 4;
    wp::float32 var_2193;
    bool var_2194;
    wp::int32 var_2195;
    wp::int32 var_2196;
    wp::int32 var_2197;
    const wp::int32 var_2198 = 0;
    wp::int32 var_2199;
    wp::vec_t<3, wp::float32>* var_2200;
    wp::vec_t<3, wp::float32> var_2201;
    wp::vec_t<3, wp::float32> var_2202;
    const wp::int32 var_2203 = 0;
    wp::float32 var_2204;
    const wp::int32 var_2205 = 0;
    wp::float32 var_2206;
    wp::float32 var_2207;
    const wp::int32 var_2208 = 1;
    wp::float32 var_2209;
    const wp::int32 var_2210 = 1;
    wp::float32 var_2211;
    wp::float32 var_2212;
    const wp::int32 var_2213 = 2;
    wp::float32 var_2214;
    const wp::int32 var_2215 = 2;
    wp::float32 var_2216;
    wp::float32 var_2217;
    const wp::int32 var_2218 = 1;
    wp::int32 var_2219;
    wp::vec_t<3, wp::float32>* var_2220;
    wp::vec_t<3, wp::float32> var_2221;
    wp::vec_t<3, wp::float32> var_2222;
    const wp::int32 var_2223 = 0;
    wp::float32 var_2224;
    const wp::int32 var_2225 = 0;
    wp::float32 var_2226;
    wp::float32 var_2227;
    const wp::int32 var_2228 = 1;
    wp::float32 var_2229;
    const wp::int32 var_2230 = 1;
    wp::float32 var_2231;
    wp::float32 var_2232;
    const wp::int32 var_2233 = 2;
    wp::float32 var_2234;
    const wp::int32 var_2235 = 2;
    wp::float32 var_2236;
    wp::float32 var_2237;
    const wp::int32 var_2238 = 2;
    wp::int32 var_2239;
    wp::vec_t<3, wp::float32>* var_2240;
    wp::vec_t<3, wp::float32> var_2241;
    wp::vec_t<3, wp::float32> var_2242;
    const wp::int32 var_2243 = 0;
    wp::float32 var_2244;
    const wp::int32 var_2245 = 0;
    wp::float32 var_2246;
    wp::float32 var_2247;
    const wp::int32 var_2248 = 1;
    wp::float32 var_2249;
    const wp::int32 var_2250 = 1;
    wp::float32 var_2251;
    wp::float32 var_2252;
    const wp::int32 var_2253 = 2;
    wp::float32 var_2254;
    const wp::int32 var_2255 = 2;
    wp::float32 var_2256;
    wp::float32 var_2257;
    const wp::int32 var_2258 = 3;
    wp::int32 var_2259;
    wp::vec_t<3, wp::float32>* var_2260;
    wp::vec_t<3, wp::float32> var_2261;
    wp::vec_t<3, wp::float32> var_2262;
    const wp::int32 var_2263 = 0;
    wp::float32 var_2264;
    const wp::int32 var_2265 = 0;
    wp::float32 var_2266;
    wp::float32 var_2267;
    const wp::int32 var_2268 = 1;
    wp::float32 var_2269;
    const wp::int32 var_2270 = 1;
    wp::float32 var_2271;
    wp::float32 var_2272;
    const wp::int32 var_2273 = 2;
    wp::float32 var_2274;
    const wp::int32 var_2275 = 2;
    wp::float32 var_2276;
    wp::float32 var_2277;
    const wp::int32 var_2278 = 4;
    wp::int32 var_2279;
    wp::vec_t<3, wp::float32>* var_2280;
    wp::vec_t<3, wp::float32> var_2281;
    wp::vec_t<3, wp::float32> var_2282;
    const wp::int32 var_2283 = 0;
    wp::float32 var_2284;
    const wp::int32 var_2285 = 0;
    wp::float32 var_2286;
    wp::float32 var_2287;
    const wp::int32 var_2288 = 1;
    wp::float32 var_2289;
    const wp::int32 var_2290 = 1;
    wp::float32 var_2291;
    wp::float32 var_2292;
    const wp::int32 var_2293 = 2;
    wp::float32 var_2294;
    const wp::int32 var_2295 = 2;
    wp::float32 var_2296;
    wp::float32 var_2297;
    const wp::int32 var_2298 = 5;
    wp::int32 var_2299;
    wp::vec_t<3, wp::float32>* var_2300;
    wp::vec_t<3, wp::float32> var_2301;
    wp::vec_t<3, wp::float32> var_2302;
    const wp::int32 var_2303 = 0;
    wp::float32 var_2304;
    const wp::int32 var_2305 = 0;
    wp::float32 var_2306;
    wp::float32 var_2307;
    const wp::int32 var_2308 = 1;
    wp::float32 var_2309;
    const wp::int32 var_2310 = 1;
    wp::float32 var_2311;
    wp::float32 var_2312;
    const wp::int32 var_2313 = 2;
    wp::float32 var_2314;
    const wp::int32 var_2315 = 2;
    wp::float32 var_2316;
    wp::float32 var_2317;
    const wp::int32 var_2318 = 6;
    wp::int32 var_2319;
    wp::vec_t<3, wp::float32>* var_2320;
    wp::vec_t<3, wp::float32> var_2321;
    wp::vec_t<3, wp::float32> var_2322;
    const wp::int32 var_2323 = 0;
    wp::float32 var_2324;
    const wp::int32 var_2325 = 0;
    wp::float32 var_2326;
    wp::float32 var_2327;
    const wp::int32 var_2328 = 1;
    wp::float32 var_2329;
    const wp::int32 var_2330 = 1;
    wp::float32 var_2331;
    wp::float32 var_2332;
    const wp::int32 var_2333 = 2;
    wp::float32 var_2334;
    const wp::int32 var_2335 = 2;
    wp::float32 var_2336;
    wp::float32 var_2337;
    const wp::int32 var_2338 = 7;
    wp::int32 var_2339;
    wp::vec_t<3, wp::float32>* var_2340;
    wp::vec_t<3, wp::float32> var_2341;
    wp::vec_t<3, wp::float32> var_2342;
    const wp::int32 var_2343 = 0;
    wp::float32 var_2344;
    const wp::int32 var_2345 = 0;
    wp::float32 var_2346;
    wp::float32 var_2347;
    const wp::int32 var_2348 = 1;
    wp::float32 var_2349;
    const wp::int32 var_2350 = 1;
    wp::float32 var_2351;
    wp::float32 var_2352;
    const wp::int32 var_2353 = 2;
    wp::float32 var_2354;
    const wp::int32 var_2355 = 2;
    wp::float32 var_2356;
    wp::float32 var_2357;
    const wp::int32 var_2358 = 0;
    wp::float32 var_2359;
    wp::float32 var_2360;
    wp::float32 var_2361;
    wp::float32 var_2362;
    wp::float32 var_2363;
    wp::float32 var_2364;
    wp::float32 var_2365;
    wp::float32 var_2366;
    wp::float32 var_2367;
    wp::float32 var_2368;
    wp::float32 var_2369;
    bool var_2370;
    wp::float32 var_2371;
    const wp::float32 var_2372 = 0.0;
    wp::float32 var_2373;
    wp::int64 var_2374;
    wp::float32 var_2375;
    const wp::float32 var_2376 = 0.0;
    wp::float32 var_2377;
    wp::int64 var_2378;
    wp::float32 var_2379;
    const wp::float32 var_2380 = 0.0;
    wp::float32 var_2381;
    wp::int64 var_2382;
    const wp::int32 var_2383 = 1;
    const wp::int32 var_2384 = 0;
    wp::int32 var_2385;
    wp::int64 var_2386;
    wp::int64 var_2387;
    wp::int64 var_2388;
    wp::int64 var_2389;
    wp::int64 var_2390;
    wp::int64 var_2391;
    wp::int64 var_2392;
    wp::int64 var_2393;
    wp::int64 var_2394;
    wp::int64 var_2395;
    wp::int64 var_2396;
    wp::int64 var_2397;
    wp::int64 var_2398;
    wp::int64 var_2399;
    wp::int64 var_2400;
    wp::int64 var_2401;
    wp::int64 var_2402;
    const wp::int32 var_2403 = 1;
    wp::float32 var_2404;
    wp::float32 var_2405;
    wp::float32 var_2406;
    wp::float32 var_2407;
    wp::float32 var_2408;
    wp::float32 var_2409;
    wp::float32 var_2410;
    wp::float32 var_2411;
    wp::float32 var_2412;
    wp::float32 var_2413;
    wp::float32 var_2414;
    bool var_2415;
    wp::float32 var_2416;
    const wp::float32 var_2417 = 0.0;
    wp::float32 var_2418;
    wp::int64 var_2419;
    wp::float32 var_2420;
    const wp::float32 var_2421 = 0.0;
    wp::float32 var_2422;
    wp::int64 var_2423;
    wp::float32 var_2424;
    const wp::float32 var_2425 = 0.0;
    wp::float32 var_2426;
    wp::int64 var_2427;
    const wp::int32 var_2428 = 1;
    const wp::int32 var_2429 = 0;
    wp::int32 var_2430;
    wp::int64 var_2431;
    wp::int64 var_2432;
    wp::int64 var_2433;
    wp::int64 var_2434;
    wp::int64 var_2435;
    wp::int64 var_2436;
    wp::int64 var_2437;
    wp::int64 var_2438;
    wp::int64 var_2439;
    wp::int64 var_2440;
    wp::int64 var_2441;
    wp::int64 var_2442;
    wp::int64 var_2443;
    wp::int64 var_2444;
    wp::int64 var_2445;
    wp::int64 var_2446;
    wp::int64 var_2447;
    const wp::int32 var_2448 = 2;
    wp::float32 var_2449;
    wp::float32 var_2450;
    wp::float32 var_2451;
    wp::float32 var_2452;
    wp::float32 var_2453;
    wp::float32 var_2454;
    wp::float32 var_2455;
    wp::float32 var_2456;
    wp::float32 var_2457;
    wp::float32 var_2458;
    wp::float32 var_2459;
    bool var_2460;
    wp::float32 var_2461;
    const wp::float32 var_2462 = 0.0;
    wp::float32 var_2463;
    wp::int64 var_2464;
    wp::float32 var_2465;
    const wp::float32 var_2466 = 0.0;
    wp::float32 var_2467;
    wp::int64 var_2468;
    wp::float32 var_2469;
    const wp::float32 var_2470 = 0.0;
    wp::float32 var_2471;
    wp::int64 var_2472;
    const wp::int32 var_2473 = 1;
    const wp::int32 var_2474 = 0;
    wp::int32 var_2475;
    wp::int64 var_2476;
    wp::int64 var_2477;
    wp::int64 var_2478;
    wp::int64 var_2479;
    wp::int64 var_2480;
    wp::int64 var_2481;
    wp::int64 var_2482;
    wp::int64 var_2483;
    wp::int64 var_2484;
    wp::int64 var_2485;
    wp::int64 var_2486;
    wp::int64 var_2487;
    wp::int64 var_2488;
    wp::int64 var_2489;
    wp::int64 var_2490;
    wp::int64 var_2491;
    wp::int64 var_2492;
    const wp::int32 var_2493 = 3;
    wp::float32 var_2494;
    wp::float32 var_2495;
    wp::float32 var_2496;
    wp::float32 var_2497;
    wp::float32 var_2498;
    wp::float32 var_2499;
    wp::float32 var_2500;
    wp::float32 var_2501;
    wp::float32 var_2502;
    wp::float32 var_2503;
    wp::float32 var_2504;
    bool var_2505;
    wp::float32 var_2506;
    const wp::float32 var_2507 = 0.0;
    wp::float32 var_2508;
    wp::int64 var_2509;
    wp::float32 var_2510;
    const wp::float32 var_2511 = 0.0;
    wp::float32 var_2512;
    wp::int64 var_2513;
    wp::float32 var_2514;
    const wp::float32 var_2515 = 0.0;
    wp::float32 var_2516;
    wp::int64 var_2517;
    const wp::int32 var_2518 = 1;
    const wp::int32 var_2519 = 0;
    wp::int32 var_2520;
    wp::int64 var_2521;
    wp::int64 var_2522;
    wp::int64 var_2523;
    wp::int64 var_2524;
    wp::int64 var_2525;
    wp::int64 var_2526;
    wp::int64 var_2527;
    wp::int64 var_2528;
    wp::int64 var_2529;
    wp::int64 var_2530;
    wp::int64 var_2531;
    wp::int64 var_2532;
    wp::int64 var_2533;
    wp::int64 var_2534;
    wp::int64 var_2535;
    wp::int64 var_2536;
    wp::int64 var_2537;
    const wp::int32 var_2538 = 4;
    wp::float32 var_2539;
    wp::float32 var_2540;
    wp::float32 var_2541;
    wp::float32 var_2542;
    wp::float32 var_2543;
    wp::float32 var_2544;
    wp::float32 var_2545;
    wp::float32 var_2546;
    wp::float32 var_2547;
    wp::float32 var_2548;
    wp::float32 var_2549;
    bool var_2550;
    wp::float32 var_2551;
    const wp::float32 var_2552 = 0.0;
    wp::float32 var_2553;
    wp::int64 var_2554;
    wp::float32 var_2555;
    const wp::float32 var_2556 = 0.0;
    wp::float32 var_2557;
    wp::int64 var_2558;
    wp::float32 var_2559;
    const wp::float32 var_2560 = 0.0;
    wp::float32 var_2561;
    wp::int64 var_2562;
    const wp::int32 var_2563 = 1;
    const wp::int32 var_2564 = 0;
    wp::int32 var_2565;
    wp::int64 var_2566;
    wp::int64 var_2567;
    wp::int64 var_2568;
    wp::int64 var_2569;
    wp::int64 var_2570;
    wp::int64 var_2571;
    wp::int64 var_2572;
    wp::int64 var_2573;
    wp::int64 var_2574;
    wp::int64 var_2575;
    wp::int64 var_2576;
    wp::int64 var_2577;
    wp::int64 var_2578;
    wp::int64 var_2579;
    wp::int64 var_2580;
    wp::int64 var_2581;
    wp::int64 var_2582;
    const wp::int32 var_2583 = 5;
    wp::float32 var_2584;
    wp::float32 var_2585;
    wp::float32 var_2586;
    wp::float32 var_2587;
    wp::float32 var_2588;
    wp::float32 var_2589;
    wp::float32 var_2590;
    wp::float32 var_2591;
    wp::float32 var_2592;
    wp::float32 var_2593;
    wp::float32 var_2594;
    bool var_2595;
    wp::float32 var_2596;
    const wp::float32 var_2597 = 0.0;
    wp::float32 var_2598;
    wp::int64 var_2599;
    wp::float32 var_2600;
    const wp::float32 var_2601 = 0.0;
    wp::float32 var_2602;
    wp::int64 var_2603;
    wp::float32 var_2604;
    const wp::float32 var_2605 = 0.0;
    wp::float32 var_2606;
    wp::int64 var_2607;
    const wp::int32 var_2608 = 1;
    const wp::int32 var_2609 = 0;
    wp::int32 var_2610;
    wp::int64 var_2611;
    wp::int64 var_2612;
    wp::int64 var_2613;
    wp::int64 var_2614;
    wp::int64 var_2615;
    wp::int64 var_2616;
    wp::int64 var_2617;
    wp::int64 var_2618;
    wp::int64 var_2619;
    wp::int64 var_2620;
    wp::int64 var_2621;
    wp::int64 var_2622;
    wp::int64 var_2623;
    wp::int64 var_2624;
    wp::int64 var_2625;
    wp::int64 var_2626;
    wp::int64 var_2627;
    const wp::int32 var_2628 = 6;
    wp::float32 var_2629;
    wp::float32 var_2630;
    wp::float32 var_2631;
    wp::float32 var_2632;
    wp::float32 var_2633;
    wp::float32 var_2634;
    wp::float32 var_2635;
    wp::float32 var_2636;
    wp::float32 var_2637;
    wp::float32 var_2638;
    wp::float32 var_2639;
    bool var_2640;
    wp::float32 var_2641;
    const wp::float32 var_2642 = 0.0;
    wp::float32 var_2643;
    wp::int64 var_2644;
    wp::float32 var_2645;
    const wp::float32 var_2646 = 0.0;
    wp::float32 var_2647;
    wp::int64 var_2648;
    wp::float32 var_2649;
    const wp::float32 var_2650 = 0.0;
    wp::float32 var_2651;
    wp::int64 var_2652;
    const wp::int32 var_2653 = 1;
    const wp::int32 var_2654 = 0;
    wp::int32 var_2655;
    wp::int64 var_2656;
    wp::int64 var_2657;
    wp::int64 var_2658;
    wp::int64 var_2659;
    wp::int64 var_2660;
    wp::int64 var_2661;
    wp::int64 var_2662;
    wp::int64 var_2663;
    wp::int64 var_2664;
    wp::int64 var_2665;
    wp::int64 var_2666;
    wp::int64 var_2667;
    wp::int64 var_2668;
    wp::int64 var_2669;
    wp::int64 var_2670;
    wp::int64 var_2671;
    wp::int64 var_2672;
    const wp::int32 var_2673 = 7;
    wp::float32 var_2674;
    wp::float32 var_2675;
    wp::float32 var_2676;
    wp::float32 var_2677;
    wp::float32 var_2678;
    wp::float32 var_2679;
    wp::float32 var_2680;
    wp::float32 var_2681;
    wp::float32 var_2682;
    wp::float32 var_2683;
    wp::float32 var_2684;
    bool var_2685;
    wp::float32 var_2686;
    const wp::float32 var_2687 = 0.0;
    wp::float32 var_2688;
    wp::int64 var_2689;
    wp::float32 var_2690;
    const wp::float32 var_2691 = 0.0;
    wp::float32 var_2692;
    wp::int64 var_2693;
    wp::float32 var_2694;
    const wp::float32 var_2695 = 0.0;
    wp::float32 var_2696;
    wp::int64 var_2697;
    const wp::int32 var_2698 = 1;
    const wp::int32 var_2699 = 0;
    wp::int32 var_2700;
    wp::int64 var_2701;
    wp::int64 var_2702;
    wp::int64 var_2703;
    wp::int64 var_2704;
    wp::int64 var_2705;
    wp::int64 var_2706;
    wp::int64 var_2707;
    wp::int64 var_2708;
    wp::int64 var_2709;
    wp::int64 var_2710;
    wp::int64 var_2711;
    wp::int64 var_2712;
    wp::int64 var_2713;
    wp::int64 var_2714;
    wp::int64 var_2715;
    wp::int64 var_2716;
    wp::int64 var_2717;
    wp::int64 var_2718;
    wp::int64 var_2719;
    wp::int64 var_2720;
    wp::int64 var_2721;
    wp::int64 var_2722;
    wp::int64 var_2723;
    wp::int64 var_2724;
    wp::int64 var_2725;
    wp::int64 var_2726;
    wp::int64 var_2727;
    wp::int32 var_2728;
    wp::int32 var_2729;
    wp::vec_t<3, wp::float32> var_2730;
    bool var_2731;
    wp::int64 var_2732;
    wp::int64 var_2733;
    wp::int64 var_2734;
    const wp::int32 var_2735 = 5;
    wp::float32 var_2736;
    bool var_2737;
    wp::int32 var_2738;
    wp::int32 var_2739;
    wp::int32 var_2740;
    const wp::int32 var_2741 = 0;
    wp::int32 var_2742;
    wp::vec_t<3, wp::float32>* var_2743;
    wp::vec_t<3, wp::float32> var_2744;
    wp::vec_t<3, wp::float32> var_2745;
    const wp::int32 var_2746 = 0;
    wp::float32 var_2747;
    const wp::int32 var_2748 = 0;
    wp::float32 var_2749;
    wp::float32 var_2750;
    const wp::int32 var_2751 = 1;
    wp::float32 var_2752;
    const wp::int32 var_2753 = 1;
    wp::float32 var_2754;
    wp::float32 var_2755;
    const wp::int32 var_2756 = 2;
    wp::float32 var_2757;
    const wp::int32 var_2758 = 2;
    wp::float32 var_2759;
    wp::float32 var_2760;
    const wp::int32 var_2761 = 1;
    wp::int32 var_2762;
    wp::vec_t<3, wp::float32>* var_2763;
    wp::vec_t<3, wp::float32> var_2764;
    wp::vec_t<3, wp::float32> var_2765;
    const wp::int32 var_2766 = 0;
    wp::float32 var_2767;
    const wp::int32 var_2768 = 0;
    wp::float32 var_2769;
    wp::float32 var_2770;
    const wp::int32 var_2771 = 1;
    wp::float32 var_2772;
    const wp::int32 var_2773 = 1;
    wp::float32 var_2774;
    wp::float32 var_2775;
    const wp::int32 var_2776 = 2;
    wp::float32 var_2777;
    const wp::int32 var_2778 = 2;
    wp::float32 var_2779;
    wp::float32 var_2780;
    const wp::int32 var_2781 = 2;
    wp::int32 var_2782;
    wp::vec_t<3, wp::float32>* var_2783;
    wp::vec_t<3, wp::float32> var_2784;
    wp::vec_t<3, wp::float32> var_2785;
    const wp::int32 var_2786 = 0;
    wp::float32 var_2787;
    const wp::int32 var_2788 = 0;
    wp::float32 var_2789;
    wp::float32 var_2790;
    const wp::int32 var_2791 = 1;
    wp::float32 var_2792;
    const wp::int32 var_2793 = 1;
    wp::float32 var_2794;
    wp::float32 var_2795;
    const wp::int32 var_2796 = 2;
    wp::float32 var_2797;
    const wp::int32 var_2798 = 2;
    wp::float32 var_2799;
    wp::float32 var_2800;
    const wp::int32 var_2801 = 3;
    wp::int32 var_2802;
    wp::vec_t<3, wp::float32>* var_2803;
    wp::vec_t<3, wp::float32> var_2804;
    wp::vec_t<3, wp::float32> var_2805;
    const wp::int32 var_2806 = 0;
    wp::float32 var_2807;
    const wp::int32 var_2808 = 0;
    wp::float32 var_2809;
    wp::float32 var_2810;
    const wp::int32 var_2811 = 1;
    wp::float32 var_2812;
    const wp::int32 var_2813 = 1;
    wp::float32 var_2814;
    wp::float32 var_2815;
    const wp::int32 var_2816 = 2;
    wp::float32 var_2817;
    const wp::int32 var_2818 = 2;
    wp::float32 var_2819;
    wp::float32 var_2820;
    const wp::int32 var_2821 = 4;
    wp::int32 var_2822;
    wp::vec_t<3, wp::float32>* var_2823;
    wp::vec_t<3, wp::float32> var_2824;
    wp::vec_t<3, wp::float32> var_2825;
    const wp::int32 var_2826 = 0;
    wp::float32 var_2827;
    const wp::int32 var_2828 = 0;
    wp::float32 var_2829;
    wp::float32 var_2830;
    const wp::int32 var_2831 = 1;
    wp::float32 var_2832;
    const wp::int32 var_2833 = 1;
    wp::float32 var_2834;
    wp::float32 var_2835;
    const wp::int32 var_2836 = 2;
    wp::float32 var_2837;
    const wp::int32 var_2838 = 2;
    wp::float32 var_2839;
    wp::float32 var_2840;
    const wp::int32 var_2841 = 5;
    wp::int32 var_2842;
    wp::vec_t<3, wp::float32>* var_2843;
    wp::vec_t<3, wp::float32> var_2844;
    wp::vec_t<3, wp::float32> var_2845;
    const wp::int32 var_2846 = 0;
    wp::float32 var_2847;
    const wp::int32 var_2848 = 0;
    wp::float32 var_2849;
    wp::float32 var_2850;
    const wp::int32 var_2851 = 1;
    wp::float32 var_2852;
    const wp::int32 var_2853 = 1;
    wp::float32 var_2854;
    wp::float32 var_2855;
    const wp::int32 var_2856 = 2;
    wp::float32 var_2857;
    const wp::int32 var_2858 = 2;
    wp::float32 var_2859;
    wp::float32 var_2860;
    const wp::int32 var_2861 = 6;
    wp::int32 var_2862;
    wp::vec_t<3, wp::float32>* var_2863;
    wp::vec_t<3, wp::float32> var_2864;
    wp::vec_t<3, wp::float32> var_2865;
    const wp::int32 var_2866 = 0;
    wp::float32 var_2867;
    const wp::int32 var_2868 = 0;
    wp::float32 var_2869;
    wp::float32 var_2870;
    const wp::int32 var_2871 = 1;
    wp::float32 var_2872;
    const wp::int32 var_2873 = 1;
    wp::float32 var_2874;
    wp::float32 var_2875;
    const wp::int32 var_2876 = 2;
    wp::float32 var_2877;
    const wp::int32 var_2878 = 2;
    wp::float32 var_2879;
    wp::float32 var_2880;
    const wp::int32 var_2881 = 7;
    wp::int32 var_2882;
    wp::vec_t<3, wp::float32>* var_2883;
    wp::vec_t<3, wp::float32> var_2884;
    wp::vec_t<3, wp::float32> var_2885;
    const wp::int32 var_2886 = 0;
    wp::float32 var_2887;
    const wp::int32 var_2888 = 0;
    wp::float32 var_2889;
    wp::float32 var_2890;
    const wp::int32 var_2891 = 1;
    wp::float32 var_2892;
    const wp::int32 var_2893 = 1;
    wp::float32 var_2894;
    wp::float32 var_2895;
    const wp::int32 var_2896 = 2;
    wp::float32 var_2897;
    const wp::int32 var_2898 = 2;
    wp::float32 var_2899;
    wp::float32 var_2900;
    const wp::int32 var_2901 = 0;
    wp::float32 var_2902;
    wp::float32 var_2903;
    wp::float32 var_2904;
    wp::float32 var_2905;
    wp::float32 var_2906;
    wp::float32 var_2907;
    wp::float32 var_2908;
    wp::float32 var_2909;
    wp::float32 var_2910;
    wp::float32 var_2911;
    wp::float32 var_2912;
    bool var_2913;
    wp::float32 var_2914;
    const wp::float32 var_2915 = 0.0;
    wp::float32 var_2916;
    wp::int64 var_2917;
    wp::float32 var_2918;
    const wp::float32 var_2919 = 0.0;
    wp::float32 var_2920;
    wp::int64 var_2921;
    wp::float32 var_2922;
    const wp::float32 var_2923 = 0.0;
    wp::float32 var_2924;
    wp::int64 var_2925;
    const wp::int32 var_2926 = 1;
    const wp::int32 var_2927 = 0;
    wp::int32 var_2928;
    wp::int64 var_2929;
    wp::int64 var_2930;
    wp::int64 var_2931;
    wp::int64 var_2932;
    wp::int64 var_2933;
    wp::int64 var_2934;
    wp::int64 var_2935;
    wp::int64 var_2936;
    wp::int64 var_2937;
    wp::int64 var_2938;
    wp::int64 var_2939;
    wp::int64 var_2940;
    wp::int64 var_2941;
    wp::int64 var_2942;
    wp::int64 var_2943;
    wp::int64 var_2944;
    wp::int64 var_2945;
    const wp::int32 var_2946 = 1;
    wp::float32 var_2947;
    wp::float32 var_2948;
    wp::float32 var_2949;
    wp::float32 var_2950;
    wp::float32 var_2951;
    wp::float32 var_2952;
    wp::float32 var_2953;
    wp::float32 var_2954;
    wp::float32 var_2955;
    wp::float32 var_2956;
    wp::float32 var_2957;
    bool var_2958;
    wp::float32 var_2959;
    const wp::float32 var_2960 = 0.0;
    wp::float32 var_2961;
    wp::int64 var_2962;
    wp::float32 var_2963;
    const wp::float32 var_2964 = 0.0;
    wp::float32 var_2965;
    wp::int64 var_2966;
    wp::float32 var_2967;
    const wp::float32 var_2968 = 0.0;
    wp::float32 var_2969;
    wp::int64 var_2970;
    const wp::int32 var_2971 = 1;
    const wp::int32 var_2972 = 0;
    wp::int32 var_2973;
    wp::int64 var_2974;
    wp::int64 var_2975;
    wp::int64 var_2976;
    wp::int64 var_2977;
    wp::int64 var_2978;
    wp::int64 var_2979;
    wp::int64 var_2980;
    wp::int64 var_2981;
    wp::int64 var_2982;
    wp::int64 var_2983;
    wp::int64 var_2984;
    wp::int64 var_2985;
    wp::int64 var_2986;
    wp::int64 var_2987;
    wp::int64 var_2988;
    wp::int64 var_2989;
    wp::int64 var_2990;
    const wp::int32 var_2991 = 2;
    wp::float32 var_2992;
    wp::float32 var_2993;
    wp::float32 var_2994;
    wp::float32 var_2995;
    wp::float32 var_2996;
    wp::float32 var_2997;
    wp::float32 var_2998;
    wp::float32 var_2999;
    wp::float32 var_3000;
    wp::float32 var_3001;
    wp::float32 var_3002;
    bool var_3003;
    wp::float32 var_3004;
    const wp::float32 var_3005 = 0.0;
    wp::float32 var_3006;
    wp::int64 var_3007;
    wp::float32 var_3008;
    const wp::float32 var_3009 = 0.0;
    wp::float32 var_3010;
    wp::int64 var_3011;
    wp::float32 var_3012;
    const wp::float32 var_3013 = 0.0;
    wp::float32 var_3014;
    wp::int64 var_3015;
    const wp::int32 var_3016 = 1;
    const wp::int32 var_3017 = 0;
    wp::int32 var_3018;
    wp::int64 var_3019;
    wp::int64 var_3020;
    wp::int64 var_3021;
    wp::int64 var_3022;
    wp::int64 var_3023;
    wp::int64 var_3024;
    wp::int64 var_3025;
    wp::int64 var_3026;
    wp::int64 var_3027;
    wp::int64 var_3028;
    wp::int64 var_3029;
    wp::int64 var_3030;
    wp::int64 var_3031;
    wp::int64 var_3032;
    wp::int64 var_3033;
    wp::int64 var_3034;
    wp::int64 var_3035;
    const wp::int32 var_3036 = 3;
    wp::float32 var_3037;
    wp::float32 var_3038;
    wp::float32 var_3039;
    wp::float32 var_3040;
    wp::float32 var_3041;
    wp::float32 var_3042;
    wp::float32 var_3043;
    wp::float32 var_3044;
    wp::float32 var_3045;
    wp::float32 var_3046;
    wp::float32 var_3047;
    bool var_3048;
    wp::float32 var_3049;
    const wp::float32 var_3050 = 0.0;
    wp::float32 var_3051;
    wp::int64 var_3052;
    wp::float32 var_3053;
    const wp::float32 var_3054 = 0.0;
    wp::float32 var_3055;
    wp::int64 var_3056;
    wp::float32 var_3057;
    const wp::float32 var_3058 = 0.0;
    wp::float32 var_3059;
    wp::int64 var_3060;
    const wp::int32 var_3061 = 1;
    const wp::int32 var_3062 = 0;
    wp::int32 var_3063;
    wp::int64 var_3064;
    wp::int64 var_3065;
    wp::int64 var_3066;
    wp::int64 var_3067;
    wp::int64 var_3068;
    wp::int64 var_3069;
    wp::int64 var_3070;
    wp::int64 var_3071;
    wp::int64 var_3072;
    wp::int64 var_3073;
    wp::int64 var_3074;
    wp::int64 var_3075;
    wp::int64 var_3076;
    wp::int64 var_3077;
    wp::int64 var_3078;
    wp::int64 var_3079;
    wp::int64 var_3080;
    const wp::int32 var_3081 = 4;
    wp::float32 var_3082;
    wp::float32 var_3083;
    wp::float32 var_3084;
    wp::float32 var_3085;
    wp::float32 var_3086;
    wp::float32 var_3087;
    wp::float32 var_3088;
    wp::float32 var_3089;
    wp::float32 var_3090;
    wp::float32 var_3091;
    wp::float32 var_3092;
    bool var_3093;
    wp::float32 var_3094;
    const wp::float32 var_3095 = 0.0;
    wp::float32 var_3096;
    wp::int64 var_3097;
    wp::float32 var_3098;
    const wp::float32 var_3099 = 0.0;
    wp::float32 var_3100;
    wp::int64 var_3101;
    wp::float32 var_3102;
    const wp::float32 var_3103 = 0.0;
    wp::float32 var_3104;
    wp::int64 var_3105;
    const wp::int32 var_3106 = 1;
    const wp::int32 var_3107 = 0;
    wp::int32 var_3108;
    wp::int64 var_3109;
    wp::int64 var_3110;
    wp::int64 var_3111;
    wp::int64 var_3112;
    wp::int64 var_3113;
    wp::int64 var_3114;
    wp::int64 var_3115;
    wp::int64 var_3116;
    wp::int64 var_3117;
    wp::int64 var_3118;
    wp::int64 var_3119;
    wp::int64 var_3120;
    wp::int64 var_3121;
    wp::int64 var_3122;
    wp::int64 var_3123;
    wp::int64 var_3124;
    wp::int64 var_3125;
    const wp::int32 var_3126 = 5;
    wp::float32 var_3127;
    wp::float32 var_3128;
    wp::float32 var_3129;
    wp::float32 var_3130;
    wp::float32 var_3131;
    wp::float32 var_3132;
    wp::float32 var_3133;
    wp::float32 var_3134;
    wp::float32 var_3135;
    wp::float32 var_3136;
    wp::float32 var_3137;
    bool var_3138;
    wp::float32 var_3139;
    const wp::float32 var_3140 = 0.0;
    wp::float32 var_3141;
    wp::int64 var_3142;
    wp::float32 var_3143;
    const wp::float32 var_3144 = 0.0;
    wp::float32 var_3145;
    wp::int64 var_3146;
    wp::float32 var_3147;
    const wp::float32 var_3148 = 0.0;
    wp::float32 var_3149;
    wp::int64 var_3150;
    const wp::int32 var_3151 = 1;
    const wp::int32 var_3152 = 0;
    wp::int32 var_3153;
    wp::int64 var_3154;
    wp::int64 var_3155;
    wp::int64 var_3156;
    wp::int64 var_3157;
    wp::int64 var_3158;
    wp::int64 var_3159;
    wp::int64 var_3160;
    wp::int64 var_3161;
    wp::int64 var_3162;
    wp::int64 var_3163;
    wp::int64 var_3164;
    wp::int64 var_3165;
    wp::int64 var_3166;
    wp::int64 var_3167;
    wp::int64 var_3168;
    wp::int64 var_3169;
    wp::int64 var_3170;
    const wp::int32 var_3171 = 6;
    wp::float32 var_3172;
    wp::float32 var_3173;
    wp::float32 var_3174;
    wp::float32 var_3175;
    wp::float32 var_3176;
    wp::float32 var_3177;
    wp::float32 var_3178;
    wp::float32 var_3179;
    wp::float32 var_3180;
    wp::float32 var_3181;
    wp::float32 var_3182;
    bool var_3183;
    wp::float32 var_3184;
    const wp::float32 var_3185 = 0.0;
    wp::float32 var_3186;
    wp::int64 var_3187;
    wp::float32 var_3188;
    const wp::float32 var_3189 = 0.0;
    wp::float32 var_3190;
    wp::int64 var_3191;
    wp::float32 var_3192;
    const wp::float32 var_3193 = 0.0;
    wp::float32 var_3194;
    wp::int64 var_3195;
    const wp::int32 var_3196 = 1;
    const wp::int32 var_3197 = 0;
    wp::int32 var_3198;
    wp::int64 var_3199;
    wp::int64 var_3200;
    wp::int64 var_3201;
    wp::int64 var_3202;
    wp::int64 var_3203;
    wp::int64 var_3204;
    wp::int64 var_3205;
    wp::int64 var_3206;
    wp::int64 var_3207;
    wp::int64 var_3208;
    wp::int64 var_3209;
    wp::int64 var_3210;
    wp::int64 var_3211;
    wp::int64 var_3212;
    wp::int64 var_3213;
    wp::int64 var_3214;
    wp::int64 var_3215;
    const wp::int32 var_3216 = 7;
    wp::float32 var_3217;
    wp::float32 var_3218;
    wp::float32 var_3219;
    wp::float32 var_3220;
    wp::float32 var_3221;
    wp::float32 var_3222;
    wp::float32 var_3223;
    wp::float32 var_3224;
    wp::float32 var_3225;
    wp::float32 var_3226;
    wp::float32 var_3227;
    bool var_3228;
    wp::float32 var_3229;
    const wp::float32 var_3230 = 0.0;
    wp::float32 var_3231;
    wp::int64 var_3232;
    wp::float32 var_3233;
    const wp::float32 var_3234 = 0.0;
    wp::float32 var_3235;
    wp::int64 var_3236;
    wp::float32 var_3237;
    const wp::float32 var_3238 = 0.0;
    wp::float32 var_3239;
    wp::int64 var_3240;
    const wp::int32 var_3241 = 1;
    const wp::int32 var_3242 = 0;
    wp::int32 var_3243;
    wp::int64 var_3244;
    wp::int64 var_3245;
    wp::int64 var_3246;
    wp::int64 var_3247;
    wp::int64 var_3248;
    wp::int64 var_3249;
    wp::int64 var_3250;
    wp::int64 var_3251;
    wp::int64 var_3252;
    wp::int64 var_3253;
    wp::int64 var_3254;
    wp::int64 var_3255;
    wp::int64 var_3256;
    wp::int64 var_3257;
    wp::int64 var_3258;
    wp::int64 var_3259;
    wp::int64 var_3260;
    wp::int64 var_3261;
    wp::int64 var_3262;
    wp::int64 var_3263;
    wp::int64 var_3264;
    wp::int64 var_3265;
    wp::int64 var_3266;
    wp::int64 var_3267;
    wp::int64 var_3268;
    wp::int64 var_3269;
    wp::int64 var_3270;
    wp::int32 var_3271;
    wp::int32 var_3272;
    wp::vec_t<3, wp::float32> var_3273;
    bool var_3274;
    wp::int64 var_3275;
    wp::int64 var_3276;
    wp::int64 var_3277;
    const wp::int32 var_3278 = 6;
    wp::float32 var_3279;
    bool var_3280;
    wp::int32 var_3281;
    wp::int32 var_3282;
    wp::int32 var_3283;
    const wp::int32 var_3284 = 0;
    wp::int32 var_3285;
    wp::vec_t<3, wp::float32>* var_3286;
    wp::vec_t<3, wp::float32> var_3287;
    wp::vec_t<3, wp::float32> var_3288;
    const wp::int32 var_3289 = 0;
    wp::float32 var_3290;
    const wp::int32 var_3291 = 0;
    wp::float32 var_3292;
    wp::float32 var_3293;
    const wp::int32 var_3294 = 1;
    wp::float32 var_3295;
    const wp::int32 var_3296 = 1;
    wp::float32 var_3297;
    wp::float32 var_3298;
    const wp::int32 var_3299 = 2;
    wp::float32 var_3300;
    const wp::int32 var_3301 = 2;
    wp::float32 var_3302;
    wp::float32 var_3303;
    const wp::int32 var_3304 = 1;
    wp::int32 var_3305;
    wp::vec_t<3, wp::float32>* var_3306;
    wp::vec_t<3, wp::float32> var_3307;
    wp::vec_t<3, wp::float32> var_3308;
    const wp::int32 var_3309 = 0;
    wp::float32 var_3310;
    const wp::int32 var_3311 = 0;
    wp::float32 var_3312;
    wp::float32 var_3313;
    const wp::int32 var_3314 = 1;
    wp::float32 var_3315;
    const wp::int32 var_3316 = 1;
    wp::float32 var_3317;
    wp::float32 var_3318;
    const wp::int32 var_3319 = 2;
    wp::float32 var_3320;
    const wp::int32 var_3321 = 2;
    wp::float32 var_3322;
    wp::float32 var_3323;
    const wp::int32 var_3324 = 2;
    wp::int32 var_3325;
    wp::vec_t<3, wp::float32>* var_3326;
    wp::vec_t<3, wp::float32> var_3327;
    wp::vec_t<3, wp::float32> var_3328;
    const wp::int32 var_3329 = 0;
    wp::float32 var_3330;
    const wp::int32 var_3331 = 0;
    wp::float32 var_3332;
    wp::float32 var_3333;
    const wp::int32 var_3334 = 1;
    wp::float32 var_3335;
    const wp::int32 var_3336 = 1;
    wp::float32 var_3337;
    wp::float32 var_3338;
    const wp::int32 var_3339 = 2;
    wp::float32 var_3340;
    const wp::int32 var_3341 = 2;
    wp::float32 var_3342;
    wp::float32 var_3343;
    const wp::int32 var_3344 = 3;
    wp::int32 var_3345;
    wp::vec_t<3, wp::float32>* var_3346;
    wp::vec_t<3, wp::float32> var_3347;
    wp::vec_t<3, wp::float32> var_3348;
    const wp::int32 var_3349 = 0;
    wp::float32 var_3350;
    const wp::int32 var_3351 = 0;
    wp::float32 var_3352;
    wp::float32 var_3353;
    const wp::int32 var_3354 = 1;
    wp::float32 var_3355;
    const wp::int32 var_3356 = 1;
    wp::float32 var_3357;
    wp::float32 var_3358;
    const wp::int32 var_3359 = 2;
    wp::float32 var_3360;
    const wp::int32 var_3361 = 2;
    wp::float32 var_3362;
    wp::float32 var_3363;
    const wp::int32 var_3364 = 4;
    wp::int32 var_3365;
    wp::vec_t<3, wp::float32>* var_3366;
    wp::vec_t<3, wp::float32> var_3367;
    wp::vec_t<3, wp::float32> var_3368;
    const wp::int32 var_3369 = 0;
    wp::float32 var_3370;
    const wp::int32 var_3371 = 0;
    wp::float32 var_3372;
    wp::float32 var_3373;
    const wp::int32 var_3374 = 1;
    wp::float32 var_3375;
    const wp::int32 var_3376 = 1;
    wp::float32 var_3377;
    wp::float32 var_3378;
    const wp::int32 var_3379 = 2;
    wp::float32 var_3380;
    const wp::int32 var_3381 = 2;
    wp::float32 var_3382;
    wp::float32 var_3383;
    const wp::int32 var_3384 = 5;
    wp::int32 var_3385;
    wp::vec_t<3, wp::float32>* var_3386;
    wp::vec_t<3, wp::float32> var_3387;
    wp::vec_t<3, wp::float32> var_3388;
    const wp::int32 var_3389 = 0;
    wp::float32 var_3390;
    const wp::int32 var_3391 = 0;
    wp::float32 var_3392;
    wp::float32 var_3393;
    const wp::int32 var_3394 = 1;
    wp::float32 var_3395;
    const wp::int32 var_3396 = 1;
    wp::float32 var_3397;
    wp::float32 var_3398;
    const wp::int32 var_3399 = 2;
    wp::float32 var_3400;
    const wp::int32 var_3401 = 2;
    wp::float32 var_3402;
    wp::float32 var_3403;
    const wp::int32 var_3404 = 6;
    wp::int32 var_3405;
    wp::vec_t<3, wp::float32>* var_3406;
    wp::vec_t<3, wp::float32> var_3407;
    wp::vec_t<3, wp::float32> var_3408;
    const wp::int32 var_3409 = 0;
    wp::float32 var_3410;
    const wp::int32 var_3411 = 0;
    wp::float32 var_3412;
    wp::float32 var_3413;
    const wp::int32 var_3414 = 1;
    wp::float32 var_3415;
    const wp::int32 var_3416 = 1;
    wp::float32 var_3417;
    wp::float32 var_3418;
    const wp::int32 var_3419 = 2;
    wp::float32 var_3420;
    const wp::int32 var_3421 = 2;
    wp::float32 var_3422;
    wp::float32 var_3423;
    const wp::int32 var_3424 = 7;
    wp::int32 var_3425;
    wp::vec_t<3, wp::float32>* var_3426;
    wp::vec_t<3, wp::float32> var_3427;
    wp::vec_t<3, wp::float32> var_3428;
    const wp::int32 var_3429 = 0;
    wp::float32 var_3430;
    const wp::int32 var_3431 = 0;
    wp::float32 var_3432;
    wp::float32 var_3433;
    const wp::int32 var_3434 = 1;
    wp::float32 var_3435;
    const wp::int32 var_3436 = 1;
    wp::float32 var_3437;
    wp::float32 var_3438;
    const wp::int32 var_3439 = 2;
    wp::float32 var_3440;
    const wp::int32 var_3441 = 2;
    wp::float32 var_3442;
    wp::float32 var_3443;
    const wp::int32 var_3444 = 0;
    wp::float32 var_3445;
    wp::float32 var_3446;
    wp::float32 var_3447;
    wp::float32 var_3448;
    wp::float32 var_3449;
    wp::float32 var_3450;
    wp::float32 var_3451;
    wp::float32 var_3452;
    wp::float32 var_3453;
    wp::float32 var_3454;
    wp::float32 var_3455;
    bool var_3456;
    wp::float32 var_3457;
    const wp::float32 var_3458 = 0.0;
    wp::float32 var_3459;
    wp::int64 var_3460;
    wp::float32 var_3461;
    const wp::float32 var_3462 = 0.0;
    wp::float32 var_3463;
    wp::int64 var_3464;
    wp::float32 var_3465;
    const wp::float32 var_3466 = 0.0;
    wp::float32 var_3467;
    wp::int64 var_3468;
    const wp::int32 var_3469 = 1;
    const wp::int32 var_3470 = 0;
    wp::int32 var_3471;
    wp::int64 var_3472;
    wp::int64 var_3473;
    wp::int64 var_3474;
    wp::int64 var_3475;
    wp::int64 var_3476;
    wp::int64 var_3477;
    wp::int64 var_3478;
    wp::int64 var_3479;
    wp::int64 var_3480;
    wp::int64 var_3481;
    wp::int64 var_3482;
    wp::int64 var_3483;
    wp::int64 var_3484;
    wp::int64 var_3485;
    wp::int64 var_3486;
    wp::int64 var_3487;
    wp::int64 var_3488;
    const wp::int32 var_3489 = 1;
    wp::float32 var_3490;
    wp::float32 var_3491;
    wp::float32 var_3492;
    wp::float32 var_3493;
    wp::float32 var_3494;
    wp::float32 var_3495;
    wp::float32 var_3496;
    wp::float32 var_3497;
    wp::float32 var_3498;
    wp::float32 var_3499;
    wp::float32 var_3500;
    bool var_3501;
    wp::float32 var_3502;
    const wp::float32 var_3503 = 0.0;
    wp::float32 var_3504;
    wp::int64 var_3505;
    wp::float32 var_3506;
    const wp::float32 var_3507 = 0.0;
    wp::float32 var_3508;
    wp::int64 var_3509;
    wp::float32 var_3510;
    const wp::float32 var_3511 = 0.0;
    wp::float32 var_3512;
    wp::int64 var_3513;
    const wp::int32 var_3514 = 1;
    const wp::int32 var_3515 = 0;
    wp::int32 var_3516;
    wp::int64 var_3517;
    wp::int64 var_3518;
    wp::int64 var_3519;
    wp::int64 var_3520;
    wp::int64 var_3521;
    wp::int64 var_3522;
    wp::int64 var_3523;
    wp::int64 var_3524;
    wp::int64 var_3525;
    wp::int64 var_3526;
    wp::int64 var_3527;
    wp::int64 var_3528;
    wp::int64 var_3529;
    wp::int64 var_3530;
    wp::int64 var_3531;
    wp::int64 var_3532;
    wp::int64 var_3533;
    const wp::int32 var_3534 = 2;
    wp::float32 var_3535;
    wp::float32 var_3536;
    wp::float32 var_3537;
    wp::float32 var_3538;
    wp::float32 var_3539;
    wp::float32 var_3540;
    wp::float32 var_3541;
    wp::float32 var_3542;
    wp::float32 var_3543;
    wp::float32 var_3544;
    wp::float32 var_3545;
    bool var_3546;
    wp::float32 var_3547;
    const wp::float32 var_3548 = 0.0;
    wp::float32 var_3549;
    wp::int64 var_3550;
    wp::float32 var_3551;
    const wp::float32 var_3552 = 0.0;
    wp::float32 var_3553;
    wp::int64 var_3554;
    wp::float32 var_3555;
    const wp::float32 var_3556 = 0.0;
    wp::float32 var_3557;
    wp::int64 var_3558;
    const wp::int32 var_3559 = 1;
    const wp::int32 var_3560 = 0;
    wp::int32 var_3561;
    wp::int64 var_3562;
    wp::int64 var_3563;
    wp::int64 var_3564;
    wp::int64 var_3565;
    wp::int64 var_3566;
    wp::int64 var_3567;
    wp::int64 var_3568;
    wp::int64 var_3569;
    wp::int64 var_3570;
    wp::int64 var_3571;
    wp::int64 var_3572;
    wp::int64 var_3573;
    wp::int64 var_3574;
    wp::int64 var_3575;
    wp::int64 var_3576;
    wp::int64 var_3577;
    wp::int64 var_3578;
    const wp::int32 var_3579 = 3;
    wp::float32 var_3580;
    wp::float32 var_3581;
    wp::float32 var_3582;
    wp::float32 var_3583;
    wp::float32 var_3584;
    wp::float32 var_3585;
    wp::float32 var_3586;
    wp::float32 var_3587;
    wp::float32 var_3588;
    wp::float32 var_3589;
    wp::float32 var_3590;
    bool var_3591;
    wp::float32 var_3592;
    const wp::float32 var_3593 = 0.0;
    wp::float32 var_3594;
    wp::int64 var_3595;
    wp::float32 var_3596;
    const wp::float32 var_3597 = 0.0;
    wp::float32 var_3598;
    wp::int64 var_3599;
    wp::float32 var_3600;
    const wp::float32 var_3601 = 0.0;
    wp::float32 var_3602;
    wp::int64 var_3603;
    const wp::int32 var_3604 = 1;
    const wp::int32 var_3605 = 0;
    wp::int32 var_3606;
    wp::int64 var_3607;
    wp::int64 var_3608;
    wp::int64 var_3609;
    wp::int64 var_3610;
    wp::int64 var_3611;
    wp::int64 var_3612;
    wp::int64 var_3613;
    wp::int64 var_3614;
    wp::int64 var_3615;
    wp::int64 var_3616;
    wp::int64 var_3617;
    wp::int64 var_3618;
    wp::int64 var_3619;
    wp::int64 var_3620;
    wp::int64 var_3621;
    wp::int64 var_3622;
    wp::int64 var_3623;
    const wp::int32 var_3624 = 4;
    wp::float32 var_3625;
    wp::float32 var_3626;
    wp::float32 var_3627;
    wp::float32 var_3628;
    wp::float32 var_3629;
    wp::float32 var_3630;
    wp::float32 var_3631;
    wp::float32 var_3632;
    wp::float32 var_3633;
    wp::float32 var_3634;
    wp::float32 var_3635;
    bool var_3636;
    wp::float32 var_3637;
    const wp::float32 var_3638 = 0.0;
    wp::float32 var_3639;
    wp::int64 var_3640;
    wp::float32 var_3641;
    const wp::float32 var_3642 = 0.0;
    wp::float32 var_3643;
    wp::int64 var_3644;
    wp::float32 var_3645;
    const wp::float32 var_3646 = 0.0;
    wp::float32 var_3647;
    wp::int64 var_3648;
    const wp::int32 var_3649 = 1;
    const wp::int32 var_3650 = 0;
    wp::int32 var_3651;
    wp::int64 var_3652;
    wp::int64 var_3653;
    wp::int64 var_3654;
    wp::int64 var_3655;
    wp::int64 var_3656;
    wp::int64 var_3657;
    wp::int64 var_3658;
    wp::int64 var_3659;
    wp::int64 var_3660;
    wp::int64 var_3661;
    wp::int64 var_3662;
    wp::int64 var_3663;
    wp::int64 var_3664;
    wp::int64 var_3665;
    wp::int64 var_3666;
    wp::int64 var_3667;
    wp::int64 var_3668;
    const wp::int32 var_3669 = 5;
    wp::float32 var_3670;
    wp::float32 var_3671;
    wp::float32 var_3672;
    wp::float32 var_3673;
    wp::float32 var_3674;
    wp::float32 var_3675;
    wp::float32 var_3676;
    wp::float32 var_3677;
    wp::float32 var_3678;
    wp::float32 var_3679;
    wp::float32 var_3680;
    bool var_3681;
    wp::float32 var_3682;
    const wp::float32 var_3683 = 0.0;
    wp::float32 var_3684;
    wp::int64 var_3685;
    wp::float32 var_3686;
    const wp::float32 var_3687 = 0.0;
    wp::float32 var_3688;
    wp::int64 var_3689;
    wp::float32 var_3690;
    const wp::float32 var_3691 = 0.0;
    wp::float32 var_3692;
    wp::int64 var_3693;
    const wp::int32 var_3694 = 1;
    const wp::int32 var_3695 = 0;
    wp::int32 var_3696;
    wp::int64 var_3697;
    wp::int64 var_3698;
    wp::int64 var_3699;
    wp::int64 var_3700;
    wp::int64 var_3701;
    wp::int64 var_3702;
    wp::int64 var_3703;
    wp::int64 var_3704;
    wp::int64 var_3705;
    wp::int64 var_3706;
    wp::int64 var_3707;
    wp::int64 var_3708;
    wp::int64 var_3709;
    wp::int64 var_3710;
    wp::int64 var_3711;
    wp::int64 var_3712;
    wp::int64 var_3713;
    const wp::int32 var_3714 = 6;
    wp::float32 var_3715;
    wp::float32 var_3716;
    wp::float32 var_3717;
    wp::float32 var_3718;
    wp::float32 var_3719;
    wp::float32 var_3720;
    wp::float32 var_3721;
    wp::float32 var_3722;
    wp::float32 var_3723;
    wp::float32 var_3724;
    wp::float32 var_3725;
    bool var_3726;
    wp::float32 var_3727;
    const wp::float32 var_3728 = 0.0;
    wp::float32 var_3729;
    wp::int64 var_3730;
    wp::float32 var_3731;
    const wp::float32 var_3732 = 0.0;
    wp::float32 var_3733;
    wp::int64 var_3734;
    wp::float32 var_3735;
    const wp::float32 var_3736 = 0.0;
    wp::float32 var_3737;
    wp::int64 var_3738;
    const wp::int32 var_3739 = 1;
    const wp::int32 var_3740 = 0;
    wp::int32 var_3741;
    wp::int64 var_3742;
    wp::int64 var_3743;
    wp::int64 var_3744;
    wp::int64 var_3745;
    wp::int64 var_3746;
    wp::int64 var_3747;
    wp::int64 var_3748;
    wp::int64 var_3749;
    wp::int64 var_3750;
    wp::int64 var_3751;
    wp::int64 var_3752;
    wp::int64 var_3753;
    wp::int64 var_3754;
    wp::int64 var_3755;
    wp::int64 var_3756;
    wp::int64 var_3757;
    wp::int64 var_3758;
    const wp::int32 var_3759 = 7;
    wp::float32 var_3760;
    wp::float32 var_3761;
    wp::float32 var_3762;
    wp::float32 var_3763;
    wp::float32 var_3764;
    wp::float32 var_3765;
    wp::float32 var_3766;
    wp::float32 var_3767;
    wp::float32 var_3768;
    wp::float32 var_3769;
    wp::float32 var_3770;
    bool var_3771;
    wp::float32 var_3772;
    const wp::float32 var_3773 = 0.0;
    wp::float32 var_3774;
    wp::int64 var_3775;
    wp::float32 var_3776;
    const wp::float32 var_3777 = 0.0;
    wp::float32 var_3778;
    wp::int64 var_3779;
    wp::float32 var_3780;
    const wp::float32 var_3781 = 0.0;
    wp::float32 var_3782;
    wp::int64 var_3783;
    const wp::int32 var_3784 = 1;
    const wp::int32 var_3785 = 0;
    wp::int32 var_3786;
    wp::int64 var_3787;
    wp::int64 var_3788;
    wp::int64 var_3789;
    wp::int64 var_3790;
    wp::int64 var_3791;
    wp::int64 var_3792;
    wp::int64 var_3793;
    wp::int64 var_3794;
    wp::int64 var_3795;
    wp::int64 var_3796;
    wp::int64 var_3797;
    wp::int64 var_3798;
    wp::int64 var_3799;
    wp::int64 var_3800;
    wp::int64 var_3801;
    wp::int64 var_3802;
    wp::int64 var_3803;
    wp::int64 var_3804;
    wp::int64 var_3805;
    wp::int64 var_3806;
    wp::int64 var_3807;
    wp::int64 var_3808;
    wp::int64 var_3809;
    wp::int64 var_3810;
    wp::int64 var_3811;
    wp::int64 var_3812;
    wp::int64 var_3813;
    wp::int32 var_3814;
    wp::int32 var_3815;
    wp::vec_t<3, wp::float32> var_3816;
    bool var_3817;
    wp::int64 var_3818;
    wp::int64 var_3819;
    wp::int64 var_3820;
    const wp::int32 var_3821 = 7;
    wp::float32 var_3822;
    bool var_3823;
    wp::int32 var_3824;
    wp::int32 var_3825;
    wp::int32 var_3826;
    const wp::int32 var_3827 = 0;
    wp::int32 var_3828;
    wp::vec_t<3, wp::float32>* var_3829;
    wp::vec_t<3, wp::float32> var_3830;
    wp::vec_t<3, wp::float32> var_3831;
    const wp::int32 var_3832 = 0;
    wp::float32 var_3833;
    const wp::int32 var_3834 = 0;
    wp::float32 var_3835;
    wp::float32 var_3836;
    const wp::int32 var_3837 = 1;
    wp::float32 var_3838;
    const wp::int32 var_3839 = 1;
    wp::float32 var_3840;
    wp::float32 var_3841;
    const wp::int32 var_3842 = 2;
    wp::float32 var_3843;
    const wp::int32 var_3844 = 2;
    wp::float32 var_3845;
    wp::float32 var_3846;
    const wp::int32 var_3847 = 1;
    wp::int32 var_3848;
    wp::vec_t<3, wp::float32>* var_3849;
    wp::vec_t<3, wp::float32> var_3850;
    wp::vec_t<3, wp::float32> var_3851;
    const wp::int32 var_3852 = 0;
    wp::float32 var_3853;
    const wp::int32 var_3854 = 0;
    wp::float32 var_3855;
    wp::float32 var_3856;
    const wp::int32 var_3857 = 1;
    wp::float32 var_3858;
    const wp::int32 var_3859 = 1;
    wp::float32 var_3860;
    wp::float32 var_3861;
    const wp::int32 var_3862 = 2;
    wp::float32 var_3863;
    const wp::int32 var_3864 = 2;
    wp::float32 var_3865;
    wp::float32 var_3866;
    const wp::int32 var_3867 = 2;
    wp::int32 var_3868;
    wp::vec_t<3, wp::float32>* var_3869;
    wp::vec_t<3, wp::float32> var_3870;
    wp::vec_t<3, wp::float32> var_3871;
    const wp::int32 var_3872 = 0;
    wp::float32 var_3873;
    const wp::int32 var_3874 = 0;
    wp::float32 var_3875;
    wp::float32 var_3876;
    const wp::int32 var_3877 = 1;
    wp::float32 var_3878;
    const wp::int32 var_3879 = 1;
    wp::float32 var_3880;
    wp::float32 var_3881;
    const wp::int32 var_3882 = 2;
    wp::float32 var_3883;
    const wp::int32 var_3884 = 2;
    wp::float32 var_3885;
    wp::float32 var_3886;
    const wp::int32 var_3887 = 3;
    wp::int32 var_3888;
    wp::vec_t<3, wp::float32>* var_3889;
    wp::vec_t<3, wp::float32> var_3890;
    wp::vec_t<3, wp::float32> var_3891;
    const wp::int32 var_3892 = 0;
    wp::float32 var_3893;
    const wp::int32 var_3894 = 0;
    wp::float32 var_3895;
    wp::float32 var_3896;
    const wp::int32 var_3897 = 1;
    wp::float32 var_3898;
    const wp::int32 var_3899 = 1;
    wp::float32 var_3900;
    wp::float32 var_3901;
    const wp::int32 var_3902 = 2;
    wp::float32 var_3903;
    const wp::int32 var_3904 = 2;
    wp::float32 var_3905;
    wp::float32 var_3906;
    const wp::int32 var_3907 = 4;
    wp::int32 var_3908;
    wp::vec_t<3, wp::float32>* var_3909;
    wp::vec_t<3, wp::float32> var_3910;
    wp::vec_t<3, wp::float32> var_3911;
    const wp::int32 var_3912 = 0;
    wp::float32 var_3913;
    const wp::int32 var_3914 = 0;
    wp::float32 var_3915;
    wp::float32 var_3916;
    const wp::int32 var_3917 = 1;
    wp::float32 var_3918;
    const wp::int32 var_3919 = 1;
    wp::float32 var_3920;
    wp::float32 var_3921;
    const wp::int32 var_3922 = 2;
    wp::float32 var_3923;
    const wp::int32 var_3924 = 2;
    wp::float32 var_3925;
    wp::float32 var_3926;
    const wp::int32 var_3927 = 5;
    wp::int32 var_3928;
    wp::vec_t<3, wp::float32>* var_3929;
    wp::vec_t<3, wp::float32> var_3930;
    wp::vec_t<3, wp::float32> var_3931;
    const wp::int32 var_3932 = 0;
    wp::float32 var_3933;
    const wp::int32 var_3934 = 0;
    wp::float32 var_3935;
    wp::float32 var_3936;
    const wp::int32 var_3937 = 1;
    wp::float32 var_3938;
    const wp::int32 var_3939 = 1;
    wp::float32 var_3940;
    wp::float32 var_3941;
    const wp::int32 var_3942 = 2;
    wp::float32 var_3943;
    const wp::int32 var_3944 = 2;
    wp::float32 var_3945;
    wp::float32 var_3946;
    const wp::int32 var_3947 = 6;
    wp::int32 var_3948;
    wp::vec_t<3, wp::float32>* var_3949;
    wp::vec_t<3, wp::float32> var_3950;
    wp::vec_t<3, wp::float32> var_3951;
    const wp::int32 var_3952 = 0;
    wp::float32 var_3953;
    const wp::int32 var_3954 = 0;
    wp::float32 var_3955;
    wp::float32 var_3956;
    const wp::int32 var_3957 = 1;
    wp::float32 var_3958;
    const wp::int32 var_3959 = 1;
    wp::float32 var_3960;
    wp::float32 var_3961;
    const wp::int32 var_3962 = 2;
    wp::float32 var_3963;
    const wp::int32 var_3964 = 2;
    wp::float32 var_3965;
    wp::float32 var_3966;
    const wp::int32 var_3967 = 7;
    wp::int32 var_3968;
    wp::vec_t<3, wp::float32>* var_3969;
    wp::vec_t<3, wp::float32> var_3970;
    wp::vec_t<3, wp::float32> var_3971;
    const wp::int32 var_3972 = 0;
    wp::float32 var_3973;
    const wp::int32 var_3974 = 0;
    wp::float32 var_3975;
    wp::float32 var_3976;
    const wp::int32 var_3977 = 1;
    wp::float32 var_3978;
    const wp::int32 var_3979 = 1;
    wp::float32 var_3980;
    wp::float32 var_3981;
    const wp::int32 var_3982 = 2;
    wp::float32 var_3983;
    const wp::int32 var_3984 = 2;
    wp::float32 var_3985;
    wp::float32 var_3986;
    const wp::int32 var_3987 = 0;
    wp::float32 var_3988;
    wp::float32 var_3989;
    wp::float32 var_3990;
    wp::float32 var_3991;
    wp::float32 var_3992;
    wp::float32 var_3993;
    wp::float32 var_3994;
    wp::float32 var_3995;
    wp::float32 var_3996;
    wp::float32 var_3997;
    wp::float32 var_3998;
    bool var_3999;
    wp::float32 var_4000;
    const wp::float32 var_4001 = 0.0;
    wp::float32 var_4002;
    wp::int64 var_4003;
    wp::float32 var_4004;
    const wp::float32 var_4005 = 0.0;
    wp::float32 var_4006;
    wp::int64 var_4007;
    wp::float32 var_4008;
    const wp::float32 var_4009 = 0.0;
    wp::float32 var_4010;
    wp::int64 var_4011;
    const wp::int32 var_4012 = 1;
    const wp::int32 var_4013 = 0;
    wp::int32 var_4014;
    wp::int64 var_4015;
    wp::int64 var_4016;
    wp::int64 var_4017;
    wp::int64 var_4018;
    wp::int64 var_4019;
    wp::int64 var_4020;
    wp::int64 var_4021;
    wp::int64 var_4022;
    wp::int64 var_4023;
    wp::int64 var_4024;
    wp::int64 var_4025;
    wp::int64 var_4026;
    wp::int64 var_4027;
    wp::int64 var_4028;
    wp::int64 var_4029;
    wp::int64 var_4030;
    wp::int64 var_4031;
    const wp::int32 var_4032 = 1;
    wp::float32 var_4033;
    wp::float32 var_4034;
    wp::float32 var_4035;
    wp::float32 var_4036;
    wp::float32 var_4037;
    wp::float32 var_4038;
    wp::float32 var_4039;
    wp::float32 var_4040;
    wp::float32 var_4041;
    wp::float32 var_4042;
    wp::float32 var_4043;
    bool var_4044;
    wp::float32 var_4045;
    const wp::float32 var_4046 = 0.0;
    wp::float32 var_4047;
    wp::int64 var_4048;
    wp::float32 var_4049;
    const wp::float32 var_4050 = 0.0;
    wp::float32 var_4051;
    wp::int64 var_4052;
    wp::float32 var_4053;
    const wp::float32 var_4054 = 0.0;
    wp::float32 var_4055;
    wp::int64 var_4056;
    const wp::int32 var_4057 = 1;
    const wp::int32 var_4058 = 0;
    wp::int32 var_4059;
    wp::int64 var_4060;
    wp::int64 var_4061;
    wp::int64 var_4062;
    wp::int64 var_4063;
    wp::int64 var_4064;
    wp::int64 var_4065;
    wp::int64 var_4066;
    wp::int64 var_4067;
    wp::int64 var_4068;
    wp::int64 var_4069;
    wp::int64 var_4070;
    wp::int64 var_4071;
    wp::int64 var_4072;
    wp::int64 var_4073;
    wp::int64 var_4074;
    wp::int64 var_4075;
    wp::int64 var_4076;
    const wp::int32 var_4077 = 2;
    wp::float32 var_4078;
    wp::float32 var_4079;
    wp::float32 var_4080;
    wp::float32 var_4081;
    wp::float32 var_4082;
    wp::float32 var_4083;
    wp::float32 var_4084;
    wp::float32 var_4085;
    wp::float32 var_4086;
    wp::float32 var_4087;
    wp::float32 var_4088;
    bool var_4089;
    wp::float32 var_4090;
    const wp::float32 var_4091 = 0.0;
    wp::float32 var_4092;
    wp::int64 var_4093;
    wp::float32 var_4094;
    const wp::float32 var_4095 = 0.0;
    wp::float32 var_4096;
    wp::int64 var_4097;
    wp::float32 var_4098;
    const wp::float32 var_4099 = 0.0;
    wp::float32 var_4100;
    wp::int64 var_4101;
    const wp::int32 var_4102 = 1;
    const wp::int32 var_4103 = 0;
    wp::int32 var_4104;
    wp::int64 var_4105;
    wp::int64 var_4106;
    wp::int64 var_4107;
    wp::int64 var_4108;
    wp::int64 var_4109;
    wp::int64 var_4110;
    wp::int64 var_4111;
    wp::int64 var_4112;
    wp::int64 var_4113;
    wp::int64 var_4114;
    wp::int64 var_4115;
    wp::int64 var_4116;
    wp::int64 var_4117;
    wp::int64 var_4118;
    wp::int64 var_4119;
    wp::int64 var_4120;
    wp::int64 var_4121;
    const wp::int32 var_4122 = 3;
    wp::float32 var_4123;
    wp::float32 var_4124;
    wp::float32 var_4125;
    wp::float32 var_4126;
    wp::float32 var_4127;
    wp::float32 var_4128;
    wp::float32 var_4129;
    wp::float32 var_4130;
    wp::float32 var_4131;
    wp::float32 var_4132;
    wp::float32 var_4133;
    bool var_4134;
    wp::float32 var_4135;
    const wp::float32 var_4136 = 0.0;
    wp::float32 var_4137;
    wp::int64 var_4138;
    wp::float32 var_4139;
    const wp::float32 var_4140 = 0.0;
    wp::float32 var_4141;
    wp::int64 var_4142;
    wp::float32 var_4143;
    const wp::float32 var_4144 = 0.0;
    wp::float32 var_4145;
    wp::int64 var_4146;
    const wp::int32 var_4147 = 1;
    const wp::int32 var_4148 = 0;
    wp::int32 var_4149;
    wp::int64 var_4150;
    wp::int64 var_4151;
    wp::int64 var_4152;
    wp::int64 var_4153;
    wp::int64 var_4154;
    wp::int64 var_4155;
    wp::int64 var_4156;
    wp::int64 var_4157;
    wp::int64 var_4158;
    wp::int64 var_4159;
    wp::int64 var_4160;
    wp::int64 var_4161;
    wp::int64 var_4162;
    wp::int64 var_4163;
    wp::int64 var_4164;
    wp::int64 var_4165;
    wp::int64 var_4166;
    const wp::int32 var_4167 = 4;
    wp::float32 var_4168;
    wp::float32 var_4169;
    wp::float32 var_4170;
    wp::float32 var_4171;
    wp::float32 var_4172;
    wp::float32 var_4173;
    wp::float32 var_4174;
    wp::float32 var_4175;
    wp::float32 var_4176;
    wp::float32 var_4177;
    wp::float32 var_4178;
    bool var_4179;
    wp::float32 var_4180;
    const wp::float32 var_4181 = 0.0;
    wp::float32 var_4182;
    wp::int64 var_4183;
    wp::float32 var_4184;
    const wp::float32 var_4185 = 0.0;
    wp::float32 var_4186;
    wp::int64 var_4187;
    wp::float32 var_4188;
    const wp::float32 var_4189 = 0.0;
    wp::float32 var_4190;
    wp::int64 var_4191;
    const wp::int32 var_4192 = 1;
    const wp::int32 var_4193 = 0;
    wp::int32 var_4194;
    wp::int64 var_4195;
    wp::int64 var_4196;
    wp::int64 var_4197;
    wp::int64 var_4198;
    wp::int64 var_4199;
    wp::int64 var_4200;
    wp::int64 var_4201;
    wp::int64 var_4202;
    wp::int64 var_4203;
    wp::int64 var_4204;
    wp::int64 var_4205;
    wp::int64 var_4206;
    wp::int64 var_4207;
    wp::int64 var_4208;
    wp::int64 var_4209;
    wp::int64 var_4210;
    wp::int64 var_4211;
    const wp::int32 var_4212 = 5;
    wp::float32 var_4213;
    wp::float32 var_4214;
    wp::float32 var_4215;
    wp::float32 var_4216;
    wp::float32 var_4217;
    wp::float32 var_4218;
    wp::float32 var_4219;
    wp::float32 var_4220;
    wp::float32 var_4221;
    wp::float32 var_4222;
    wp::float32 var_4223;
    bool var_4224;
    wp::float32 var_4225;
    const wp::float32 var_4226 = 0.0;
    wp::float32 var_4227;
    wp::int64 var_4228;
    wp::float32 var_4229;
    const wp::float32 var_4230 = 0.0;
    wp::float32 var_4231;
    wp::int64 var_4232;
    wp::float32 var_4233;
    const wp::float32 var_4234 = 0.0;
    wp::float32 var_4235;
    wp::int64 var_4236;
    const wp::int32 var_4237 = 1;
    const wp::int32 var_4238 = 0;
    wp::int32 var_4239;
    wp::int64 var_4240;
    wp::int64 var_4241;
    wp::int64 var_4242;
    wp::int64 var_4243;
    wp::int64 var_4244;
    wp::int64 var_4245;
    wp::int64 var_4246;
    wp::int64 var_4247;
    wp::int64 var_4248;
    wp::int64 var_4249;
    wp::int64 var_4250;
    wp::int64 var_4251;
    wp::int64 var_4252;
    wp::int64 var_4253;
    wp::int64 var_4254;
    wp::int64 var_4255;
    wp::int64 var_4256;
    const wp::int32 var_4257 = 6;
    wp::float32 var_4258;
    wp::float32 var_4259;
    wp::float32 var_4260;
    wp::float32 var_4261;
    wp::float32 var_4262;
    wp::float32 var_4263;
    wp::float32 var_4264;
    wp::float32 var_4265;
    wp::float32 var_4266;
    wp::float32 var_4267;
    wp::float32 var_4268;
    bool var_4269;
    wp::float32 var_4270;
    const wp::float32 var_4271 = 0.0;
    wp::float32 var_4272;
    wp::int64 var_4273;
    wp::float32 var_4274;
    const wp::float32 var_4275 = 0.0;
    wp::float32 var_4276;
    wp::int64 var_4277;
    wp::float32 var_4278;
    const wp::float32 var_4279 = 0.0;
    wp::float32 var_4280;
    wp::int64 var_4281;
    const wp::int32 var_4282 = 1;
    const wp::int32 var_4283 = 0;
    wp::int32 var_4284;
    wp::int64 var_4285;
    wp::int64 var_4286;
    wp::int64 var_4287;
    wp::int64 var_4288;
    wp::int64 var_4289;
    wp::int64 var_4290;
    wp::int64 var_4291;
    wp::int64 var_4292;
    wp::int64 var_4293;
    wp::int64 var_4294;
    wp::int64 var_4295;
    wp::int64 var_4296;
    wp::int64 var_4297;
    wp::int64 var_4298;
    wp::int64 var_4299;
    wp::int64 var_4300;
    wp::int64 var_4301;
    const wp::int32 var_4302 = 7;
    wp::float32 var_4303;
    wp::float32 var_4304;
    wp::float32 var_4305;
    wp::float32 var_4306;
    wp::float32 var_4307;
    wp::float32 var_4308;
    wp::float32 var_4309;
    wp::float32 var_4310;
    wp::float32 var_4311;
    wp::float32 var_4312;
    wp::float32 var_4313;
    bool var_4314;
    wp::float32 var_4315;
    const wp::float32 var_4316 = 0.0;
    wp::float32 var_4317;
    wp::int64 var_4318;
    wp::float32 var_4319;
    const wp::float32 var_4320 = 0.0;
    wp::float32 var_4321;
    wp::int64 var_4322;
    wp::float32 var_4323;
    const wp::float32 var_4324 = 0.0;
    wp::float32 var_4325;
    wp::int64 var_4326;
    const wp::int32 var_4327 = 1;
    const wp::int32 var_4328 = 0;
    wp::int32 var_4329;
    wp::int64 var_4330;
    wp::int64 var_4331;
    wp::int64 var_4332;
    wp::int64 var_4333;
    wp::int64 var_4334;
    wp::int64 var_4335;
    wp::int64 var_4336;
    wp::int64 var_4337;
    wp::int64 var_4338;
    wp::int64 var_4339;
    wp::int64 var_4340;
    wp::int64 var_4341;
    wp::int64 var_4342;
    wp::int64 var_4343;
    wp::int64 var_4344;
    wp::int64 var_4345;
    wp::int64 var_4346;
    wp::int64 var_4347;
    wp::int64 var_4348;
    wp::int64 var_4349;
    wp::int64 var_4350;
    wp::int64 var_4351;
    wp::int64 var_4352;
    wp::int64 var_4353;
    wp::int64 var_4354;
    wp::int64 var_4355;
    wp::int64 var_4356;
    wp::int32 var_4357;
    wp::int32 var_4358;
    wp::vec_t<3, wp::float32> var_4359;
    bool var_4360;
    wp::int64 var_4361;
    wp::int64 var_4362;
    wp::int64 var_4363;
    wp::vec_t<4, wp::int64> var_4364;
    wp::vec_t<10, wp::int64> var_4365;
    //---------
    // forward
    // def integer_moments_within(start, p, max_sqdist, steps, tree__root, tree__levels, tree__boxes, tree__points):       <L 1>
    // n = int64(0)                                                                           <L 5>
    var_0 = 0ll;
    // sx = int64(0)                                                                          <L 6>
    var_1 = 0ll;
    // sy = int64(0)                                                                          <L 7>
    var_2 = 0ll;
    // sz = int64(0)                                                                          <L 8>
    var_3 = 0ll;
    // xx = int64(0)                                                                          <L 9>
    var_4 = 0ll;
    // xy = int64(0)                                                                          <L 10>
    var_5 = 0ll;
    // xz = int64(0)                                                                          <L 11>
    var_6 = 0ll;
    // yy = int64(0)                                                                          <L 12>
    var_7 = 0ll;
    // yz = int64(0)                                                                          <L 13>
    var_8 = 0ll;
    // zz = int64(0)                                                                          <L 14>
    var_9 = 0ll;
    // xs = lane_numbers(0.0)                                                                 <L 15>
    var_11 = wp::vec_t<8, wp::float32>(var_10);
    // ys = lane_numbers(0.0)                                                                 <L 16>
    var_13 = wp::vec_t<8, wp::float32>(var_12);
    // zs = lane_numbers(0.0)                                                                 <L 17>
    var_15 = wp::vec_t<8, wp::float32>(var_14);
    // step__leaves_within__1 = start_traversal__leaves_within(start)                         <L 18>
    var_16 = start_traversal_0(var_start);
    // while int(step__leaves_within__1[0]) <= tree__root:                                    <L 19>
    start_while_0:;
    var_18 = wp::extract(var_16, var_17);
    var_19 = wp::int(var_18);
    var_20 = (var_19 <= var_tree__root);
    if ((var_20) == false) goto end_while_0;
        // bucket__leaves_within__1 = int(step__leaves_within__1[2])                          <L 20>
        var_22 = wp::extract(var_16, var_21);
        var_23 = wp::int(var_22);
        // distances__leaves_within__1 = measure_boxes__leaves_within(tree__boxes, bucket__leaves_within__1, p, p)       <L 21>
        var_24 = measure_boxes_0(var_tree__boxes, var_23, var_p, var_p);
        // for leaf__leaves_within__1 in range(FAN__leaves_within):                           <L 22>
        // if distances__leaves_within__1[leaf__leaves_within__1] <= max_sqdist:              <L 23>
        var_26 = wp::extract(var_24, var_25);
        var_27 = (var_26 <= var_max_sqdist);
        if (var_27) {
            // first = bucket__leaves_within__1 * BUCKET__leaves_within + leaf__leaves_within__1 * LEAF__leaves_within       <L 24>
            var_29 = wp::mul(var_23, var_28);
            var_31 = wp::mul(var_25, var_30);
            var_32 = wp::add(var_29, var_31);
            // for j in range(LEAF):                                                          <L 25>
            // q = tree__points[first + j]                                                    <L 26>
            var_34 = wp::add(var_32, var_33);
            var_35 = wp::address(var_tree__points, var_34);
            var_37 = wp::load(var_35);
            var_36 = wp::copy(var_37);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_39 = wp::extract(var_36, var_38);
            var_41 = wp::extract(var_p, var_40);
            var_42 = wp::sub(var_39, var_41);
            wp::assign_inplace(var_11, var_33, var_42);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_44 = wp::extract(var_36, var_43);
            var_46 = wp::extract(var_p, var_45);
            var_47 = wp::sub(var_44, var_46);
            wp::assign_inplace(var_13, var_33, var_47);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_49 = wp::extract(var_36, var_48);
            var_51 = wp::extract(var_p, var_50);
            var_52 = wp::sub(var_49, var_51);
            wp::assign_inplace(var_15, var_33, var_52);
            // q = tree__points[first + j]                                                    <L 26>
            var_54 = wp::add(var_32, var_53);
            var_55 = wp::address(var_tree__points, var_54);
            var_57 = wp::load(var_55);
            var_56 = wp::copy(var_57);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_59 = wp::extract(var_56, var_58);
            var_61 = wp::extract(var_p, var_60);
            var_62 = wp::sub(var_59, var_61);
            wp::assign_inplace(var_11, var_53, var_62);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_64 = wp::extract(var_56, var_63);
            var_66 = wp::extract(var_p, var_65);
            var_67 = wp::sub(var_64, var_66);
            wp::assign_inplace(var_13, var_53, var_67);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_69 = wp::extract(var_56, var_68);
            var_71 = wp::extract(var_p, var_70);
            var_72 = wp::sub(var_69, var_71);
            wp::assign_inplace(var_15, var_53, var_72);
            // q = tree__points[first + j]                                                    <L 26>
            var_74 = wp::add(var_32, var_73);
            var_75 = wp::address(var_tree__points, var_74);
            var_77 = wp::load(var_75);
            var_76 = wp::copy(var_77);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_79 = wp::extract(var_76, var_78);
            var_81 = wp::extract(var_p, var_80);
            var_82 = wp::sub(var_79, var_81);
            wp::assign_inplace(var_11, var_73, var_82);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_84 = wp::extract(var_76, var_83);
            var_86 = wp::extract(var_p, var_85);
            var_87 = wp::sub(var_84, var_86);
            wp::assign_inplace(var_13, var_73, var_87);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_89 = wp::extract(var_76, var_88);
            var_91 = wp::extract(var_p, var_90);
            var_92 = wp::sub(var_89, var_91);
            wp::assign_inplace(var_15, var_73, var_92);
            // q = tree__points[first + j]                                                    <L 26>
            var_94 = wp::add(var_32, var_93);
            var_95 = wp::address(var_tree__points, var_94);
            var_97 = wp::load(var_95);
            var_96 = wp::copy(var_97);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_99 = wp::extract(var_96, var_98);
            var_101 = wp::extract(var_p, var_100);
            var_102 = wp::sub(var_99, var_101);
            wp::assign_inplace(var_11, var_93, var_102);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_104 = wp::extract(var_96, var_103);
            var_106 = wp::extract(var_p, var_105);
            var_107 = wp::sub(var_104, var_106);
            wp::assign_inplace(var_13, var_93, var_107);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_109 = wp::extract(var_96, var_108);
            var_111 = wp::extract(var_p, var_110);
            var_112 = wp::sub(var_109, var_111);
            wp::assign_inplace(var_15, var_93, var_112);
            // q = tree__points[first + j]                                                    <L 26>
            var_114 = wp::add(var_32, var_113);
            var_115 = wp::address(var_tree__points, var_114);
            var_117 = wp::load(var_115);
            var_116 = wp::copy(var_117);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_119 = wp::extract(var_116, var_118);
            var_121 = wp::extract(var_p, var_120);
            var_122 = wp::sub(var_119, var_121);
            wp::assign_inplace(var_11, var_113, var_122);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_124 = wp::extract(var_116, var_123);
            var_126 = wp::extract(var_p, var_125);
            var_127 = wp::sub(var_124, var_126);
            wp::assign_inplace(var_13, var_113, var_127);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_129 = wp::extract(var_116, var_128);
            var_131 = wp::extract(var_p, var_130);
            var_132 = wp::sub(var_129, var_131);
            wp::assign_inplace(var_15, var_113, var_132);
            // q = tree__points[first + j]                                                    <L 26>
            var_134 = wp::add(var_32, var_133);
            var_135 = wp::address(var_tree__points, var_134);
            var_137 = wp::load(var_135);
            var_136 = wp::copy(var_137);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_139 = wp::extract(var_136, var_138);
            var_141 = wp::extract(var_p, var_140);
            var_142 = wp::sub(var_139, var_141);
            wp::assign_inplace(var_11, var_133, var_142);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_144 = wp::extract(var_136, var_143);
            var_146 = wp::extract(var_p, var_145);
            var_147 = wp::sub(var_144, var_146);
            wp::assign_inplace(var_13, var_133, var_147);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_149 = wp::extract(var_136, var_148);
            var_151 = wp::extract(var_p, var_150);
            var_152 = wp::sub(var_149, var_151);
            wp::assign_inplace(var_15, var_133, var_152);
            // q = tree__points[first + j]                                                    <L 26>
            var_154 = wp::add(var_32, var_153);
            var_155 = wp::address(var_tree__points, var_154);
            var_157 = wp::load(var_155);
            var_156 = wp::copy(var_157);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_159 = wp::extract(var_156, var_158);
            var_161 = wp::extract(var_p, var_160);
            var_162 = wp::sub(var_159, var_161);
            wp::assign_inplace(var_11, var_153, var_162);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_164 = wp::extract(var_156, var_163);
            var_166 = wp::extract(var_p, var_165);
            var_167 = wp::sub(var_164, var_166);
            wp::assign_inplace(var_13, var_153, var_167);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_169 = wp::extract(var_156, var_168);
            var_171 = wp::extract(var_p, var_170);
            var_172 = wp::sub(var_169, var_171);
            wp::assign_inplace(var_15, var_153, var_172);
            // q = tree__points[first + j]                                                    <L 26>
            var_174 = wp::add(var_32, var_173);
            var_175 = wp::address(var_tree__points, var_174);
            var_177 = wp::load(var_175);
            var_176 = wp::copy(var_177);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_179 = wp::extract(var_176, var_178);
            var_181 = wp::extract(var_p, var_180);
            var_182 = wp::sub(var_179, var_181);
            wp::assign_inplace(var_11, var_173, var_182);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_184 = wp::extract(var_176, var_183);
            var_186 = wp::extract(var_p, var_185);
            var_187 = wp::sub(var_184, var_186);
            wp::assign_inplace(var_13, var_173, var_187);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_189 = wp::extract(var_176, var_188);
            var_191 = wp::extract(var_p, var_190);
            var_192 = wp::sub(var_189, var_191);
            wp::assign_inplace(var_15, var_173, var_192);
            // for j in range(LEAF):                                                          <L 30>
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_194 = wp::extract(var_11, var_193);
            var_195 = wp::extract(var_11, var_193);
            var_196 = wp::mul(var_194, var_195);
            var_197 = wp::extract(var_13, var_193);
            var_198 = wp::extract(var_13, var_193);
            var_199 = wp::mul(var_197, var_198);
            var_200 = wp::add(var_196, var_199);
            var_201 = wp::extract(var_15, var_193);
            var_202 = wp::extract(var_15, var_193);
            var_203 = wp::mul(var_201, var_202);
            var_204 = wp::add(var_200, var_203);
            var_205 = (var_204 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_205) {
                var_206 = wp::extract(var_11, var_193);
            }
            if (!var_205) {
            }
            var_208 = wp::where(var_205, var_206, var_207);
            var_209 = integer_steps_0(var_208, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_205) {
                var_210 = wp::extract(var_13, var_193);
            }
            if (!var_205) {
            }
            var_212 = wp::where(var_205, var_210, var_211);
            var_213 = integer_steps_0(var_212, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_205) {
                var_214 = wp::extract(var_15, var_193);
            }
            if (!var_205) {
            }
            var_216 = wp::where(var_205, var_214, var_215);
            var_217 = integer_steps_0(var_216, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_205) {
            }
            if (!var_205) {
            }
            var_220 = wp::where(var_205, var_218, var_219);
            var_221 = wp::int64(var_220);
            var_222 = wp::add(var_0, var_221);
            // sx += x                                                                        <L 36>
            var_223 = wp::add(var_1, var_209);
            // sy += y                                                                        <L 37>
            var_224 = wp::add(var_2, var_213);
            // sz += z                                                                        <L 38>
            var_225 = wp::add(var_3, var_217);
            // xx += x * x                                                                    <L 39>
            var_226 = wp::mul(var_209, var_209);
            var_227 = wp::add(var_4, var_226);
            // xy += x * y                                                                    <L 40>
            var_228 = wp::mul(var_209, var_213);
            var_229 = wp::add(var_5, var_228);
            // xz += x * z                                                                    <L 41>
            var_230 = wp::mul(var_209, var_217);
            var_231 = wp::add(var_6, var_230);
            // yy += y * y                                                                    <L 42>
            var_232 = wp::mul(var_213, var_213);
            var_233 = wp::add(var_7, var_232);
            // yz += y * z                                                                    <L 43>
            var_234 = wp::mul(var_213, var_217);
            var_235 = wp::add(var_8, var_234);
            // zz += z * z                                                                    <L 44>
            var_236 = wp::mul(var_217, var_217);
            var_237 = wp::add(var_9, var_236);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_239 = wp::extract(var_11, var_238);
            var_240 = wp::extract(var_11, var_238);
            var_241 = wp::mul(var_239, var_240);
            var_242 = wp::extract(var_13, var_238);
            var_243 = wp::extract(var_13, var_238);
            var_244 = wp::mul(var_242, var_243);
            var_245 = wp::add(var_241, var_244);
            var_246 = wp::extract(var_15, var_238);
            var_247 = wp::extract(var_15, var_238);
            var_248 = wp::mul(var_246, var_247);
            var_249 = wp::add(var_245, var_248);
            var_250 = (var_249 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_250) {
                var_251 = wp::extract(var_11, var_238);
            }
            if (!var_250) {
            }
            var_253 = wp::where(var_250, var_251, var_252);
            var_254 = integer_steps_0(var_253, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_250) {
                var_255 = wp::extract(var_13, var_238);
            }
            if (!var_250) {
            }
            var_257 = wp::where(var_250, var_255, var_256);
            var_258 = integer_steps_0(var_257, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_250) {
                var_259 = wp::extract(var_15, var_238);
            }
            if (!var_250) {
            }
            var_261 = wp::where(var_250, var_259, var_260);
            var_262 = integer_steps_0(var_261, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_250) {
            }
            if (!var_250) {
            }
            var_265 = wp::where(var_250, var_263, var_264);
            var_266 = wp::int64(var_265);
            var_267 = wp::add(var_222, var_266);
            // sx += x                                                                        <L 36>
            var_268 = wp::add(var_223, var_254);
            // sy += y                                                                        <L 37>
            var_269 = wp::add(var_224, var_258);
            // sz += z                                                                        <L 38>
            var_270 = wp::add(var_225, var_262);
            // xx += x * x                                                                    <L 39>
            var_271 = wp::mul(var_254, var_254);
            var_272 = wp::add(var_227, var_271);
            // xy += x * y                                                                    <L 40>
            var_273 = wp::mul(var_254, var_258);
            var_274 = wp::add(var_229, var_273);
            // xz += x * z                                                                    <L 41>
            var_275 = wp::mul(var_254, var_262);
            var_276 = wp::add(var_231, var_275);
            // yy += y * y                                                                    <L 42>
            var_277 = wp::mul(var_258, var_258);
            var_278 = wp::add(var_233, var_277);
            // yz += y * z                                                                    <L 43>
            var_279 = wp::mul(var_258, var_262);
            var_280 = wp::add(var_235, var_279);
            // zz += z * z                                                                    <L 44>
            var_281 = wp::mul(var_262, var_262);
            var_282 = wp::add(var_237, var_281);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_284 = wp::extract(var_11, var_283);
            var_285 = wp::extract(var_11, var_283);
            var_286 = wp::mul(var_284, var_285);
            var_287 = wp::extract(var_13, var_283);
            var_288 = wp::extract(var_13, var_283);
            var_289 = wp::mul(var_287, var_288);
            var_290 = wp::add(var_286, var_289);
            var_291 = wp::extract(var_15, var_283);
            var_292 = wp::extract(var_15, var_283);
            var_293 = wp::mul(var_291, var_292);
            var_294 = wp::add(var_290, var_293);
            var_295 = (var_294 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_295) {
                var_296 = wp::extract(var_11, var_283);
            }
            if (!var_295) {
            }
            var_298 = wp::where(var_295, var_296, var_297);
            var_299 = integer_steps_0(var_298, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_295) {
                var_300 = wp::extract(var_13, var_283);
            }
            if (!var_295) {
            }
            var_302 = wp::where(var_295, var_300, var_301);
            var_303 = integer_steps_0(var_302, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_295) {
                var_304 = wp::extract(var_15, var_283);
            }
            if (!var_295) {
            }
            var_306 = wp::where(var_295, var_304, var_305);
            var_307 = integer_steps_0(var_306, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_295) {
            }
            if (!var_295) {
            }
            var_310 = wp::where(var_295, var_308, var_309);
            var_311 = wp::int64(var_310);
            var_312 = wp::add(var_267, var_311);
            // sx += x                                                                        <L 36>
            var_313 = wp::add(var_268, var_299);
            // sy += y                                                                        <L 37>
            var_314 = wp::add(var_269, var_303);
            // sz += z                                                                        <L 38>
            var_315 = wp::add(var_270, var_307);
            // xx += x * x                                                                    <L 39>
            var_316 = wp::mul(var_299, var_299);
            var_317 = wp::add(var_272, var_316);
            // xy += x * y                                                                    <L 40>
            var_318 = wp::mul(var_299, var_303);
            var_319 = wp::add(var_274, var_318);
            // xz += x * z                                                                    <L 41>
            var_320 = wp::mul(var_299, var_307);
            var_321 = wp::add(var_276, var_320);
            // yy += y * y                                                                    <L 42>
            var_322 = wp::mul(var_303, var_303);
            var_323 = wp::add(var_278, var_322);
            // yz += y * z                                                                    <L 43>
            var_324 = wp::mul(var_303, var_307);
            var_325 = wp::add(var_280, var_324);
            // zz += z * z                                                                    <L 44>
            var_326 = wp::mul(var_307, var_307);
            var_327 = wp::add(var_282, var_326);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_329 = wp::extract(var_11, var_328);
            var_330 = wp::extract(var_11, var_328);
            var_331 = wp::mul(var_329, var_330);
            var_332 = wp::extract(var_13, var_328);
            var_333 = wp::extract(var_13, var_328);
            var_334 = wp::mul(var_332, var_333);
            var_335 = wp::add(var_331, var_334);
            var_336 = wp::extract(var_15, var_328);
            var_337 = wp::extract(var_15, var_328);
            var_338 = wp::mul(var_336, var_337);
            var_339 = wp::add(var_335, var_338);
            var_340 = (var_339 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_340) {
                var_341 = wp::extract(var_11, var_328);
            }
            if (!var_340) {
            }
            var_343 = wp::where(var_340, var_341, var_342);
            var_344 = integer_steps_0(var_343, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_340) {
                var_345 = wp::extract(var_13, var_328);
            }
            if (!var_340) {
            }
            var_347 = wp::where(var_340, var_345, var_346);
            var_348 = integer_steps_0(var_347, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_340) {
                var_349 = wp::extract(var_15, var_328);
            }
            if (!var_340) {
            }
            var_351 = wp::where(var_340, var_349, var_350);
            var_352 = integer_steps_0(var_351, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_340) {
            }
            if (!var_340) {
            }
            var_355 = wp::where(var_340, var_353, var_354);
            var_356 = wp::int64(var_355);
            var_357 = wp::add(var_312, var_356);
            // sx += x                                                                        <L 36>
            var_358 = wp::add(var_313, var_344);
            // sy += y                                                                        <L 37>
            var_359 = wp::add(var_314, var_348);
            // sz += z                                                                        <L 38>
            var_360 = wp::add(var_315, var_352);
            // xx += x * x                                                                    <L 39>
            var_361 = wp::mul(var_344, var_344);
            var_362 = wp::add(var_317, var_361);
            // xy += x * y                                                                    <L 40>
            var_363 = wp::mul(var_344, var_348);
            var_364 = wp::add(var_319, var_363);
            // xz += x * z                                                                    <L 41>
            var_365 = wp::mul(var_344, var_352);
            var_366 = wp::add(var_321, var_365);
            // yy += y * y                                                                    <L 42>
            var_367 = wp::mul(var_348, var_348);
            var_368 = wp::add(var_323, var_367);
            // yz += y * z                                                                    <L 43>
            var_369 = wp::mul(var_348, var_352);
            var_370 = wp::add(var_325, var_369);
            // zz += z * z                                                                    <L 44>
            var_371 = wp::mul(var_352, var_352);
            var_372 = wp::add(var_327, var_371);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_374 = wp::extract(var_11, var_373);
            var_375 = wp::extract(var_11, var_373);
            var_376 = wp::mul(var_374, var_375);
            var_377 = wp::extract(var_13, var_373);
            var_378 = wp::extract(var_13, var_373);
            var_379 = wp::mul(var_377, var_378);
            var_380 = wp::add(var_376, var_379);
            var_381 = wp::extract(var_15, var_373);
            var_382 = wp::extract(var_15, var_373);
            var_383 = wp::mul(var_381, var_382);
            var_384 = wp::add(var_380, var_383);
            var_385 = (var_384 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_385) {
                var_386 = wp::extract(var_11, var_373);
            }
            if (!var_385) {
            }
            var_388 = wp::where(var_385, var_386, var_387);
            var_389 = integer_steps_0(var_388, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_385) {
                var_390 = wp::extract(var_13, var_373);
            }
            if (!var_385) {
            }
            var_392 = wp::where(var_385, var_390, var_391);
            var_393 = integer_steps_0(var_392, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_385) {
                var_394 = wp::extract(var_15, var_373);
            }
            if (!var_385) {
            }
            var_396 = wp::where(var_385, var_394, var_395);
            var_397 = integer_steps_0(var_396, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_385) {
            }
            if (!var_385) {
            }
            var_400 = wp::where(var_385, var_398, var_399);
            var_401 = wp::int64(var_400);
            var_402 = wp::add(var_357, var_401);
            // sx += x                                                                        <L 36>
            var_403 = wp::add(var_358, var_389);
            // sy += y                                                                        <L 37>
            var_404 = wp::add(var_359, var_393);
            // sz += z                                                                        <L 38>
            var_405 = wp::add(var_360, var_397);
            // xx += x * x                                                                    <L 39>
            var_406 = wp::mul(var_389, var_389);
            var_407 = wp::add(var_362, var_406);
            // xy += x * y                                                                    <L 40>
            var_408 = wp::mul(var_389, var_393);
            var_409 = wp::add(var_364, var_408);
            // xz += x * z                                                                    <L 41>
            var_410 = wp::mul(var_389, var_397);
            var_411 = wp::add(var_366, var_410);
            // yy += y * y                                                                    <L 42>
            var_412 = wp::mul(var_393, var_393);
            var_413 = wp::add(var_368, var_412);
            // yz += y * z                                                                    <L 43>
            var_414 = wp::mul(var_393, var_397);
            var_415 = wp::add(var_370, var_414);
            // zz += z * z                                                                    <L 44>
            var_416 = wp::mul(var_397, var_397);
            var_417 = wp::add(var_372, var_416);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_419 = wp::extract(var_11, var_418);
            var_420 = wp::extract(var_11, var_418);
            var_421 = wp::mul(var_419, var_420);
            var_422 = wp::extract(var_13, var_418);
            var_423 = wp::extract(var_13, var_418);
            var_424 = wp::mul(var_422, var_423);
            var_425 = wp::add(var_421, var_424);
            var_426 = wp::extract(var_15, var_418);
            var_427 = wp::extract(var_15, var_418);
            var_428 = wp::mul(var_426, var_427);
            var_429 = wp::add(var_425, var_428);
            var_430 = (var_429 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_430) {
                var_431 = wp::extract(var_11, var_418);
            }
            if (!var_430) {
            }
            var_433 = wp::where(var_430, var_431, var_432);
            var_434 = integer_steps_0(var_433, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_430) {
                var_435 = wp::extract(var_13, var_418);
            }
            if (!var_430) {
            }
            var_437 = wp::where(var_430, var_435, var_436);
            var_438 = integer_steps_0(var_437, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_430) {
                var_439 = wp::extract(var_15, var_418);
            }
            if (!var_430) {
            }
            var_441 = wp::where(var_430, var_439, var_440);
            var_442 = integer_steps_0(var_441, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_430) {
            }
            if (!var_430) {
            }
            var_445 = wp::where(var_430, var_443, var_444);
            var_446 = wp::int64(var_445);
            var_447 = wp::add(var_402, var_446);
            // sx += x                                                                        <L 36>
            var_448 = wp::add(var_403, var_434);
            // sy += y                                                                        <L 37>
            var_449 = wp::add(var_404, var_438);
            // sz += z                                                                        <L 38>
            var_450 = wp::add(var_405, var_442);
            // xx += x * x                                                                    <L 39>
            var_451 = wp::mul(var_434, var_434);
            var_452 = wp::add(var_407, var_451);
            // xy += x * y                                                                    <L 40>
            var_453 = wp::mul(var_434, var_438);
            var_454 = wp::add(var_409, var_453);
            // xz += x * z                                                                    <L 41>
            var_455 = wp::mul(var_434, var_442);
            var_456 = wp::add(var_411, var_455);
            // yy += y * y                                                                    <L 42>
            var_457 = wp::mul(var_438, var_438);
            var_458 = wp::add(var_413, var_457);
            // yz += y * z                                                                    <L 43>
            var_459 = wp::mul(var_438, var_442);
            var_460 = wp::add(var_415, var_459);
            // zz += z * z                                                                    <L 44>
            var_461 = wp::mul(var_442, var_442);
            var_462 = wp::add(var_417, var_461);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_464 = wp::extract(var_11, var_463);
            var_465 = wp::extract(var_11, var_463);
            var_466 = wp::mul(var_464, var_465);
            var_467 = wp::extract(var_13, var_463);
            var_468 = wp::extract(var_13, var_463);
            var_469 = wp::mul(var_467, var_468);
            var_470 = wp::add(var_466, var_469);
            var_471 = wp::extract(var_15, var_463);
            var_472 = wp::extract(var_15, var_463);
            var_473 = wp::mul(var_471, var_472);
            var_474 = wp::add(var_470, var_473);
            var_475 = (var_474 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_475) {
                var_476 = wp::extract(var_11, var_463);
            }
            if (!var_475) {
            }
            var_478 = wp::where(var_475, var_476, var_477);
            var_479 = integer_steps_0(var_478, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_475) {
                var_480 = wp::extract(var_13, var_463);
            }
            if (!var_475) {
            }
            var_482 = wp::where(var_475, var_480, var_481);
            var_483 = integer_steps_0(var_482, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_475) {
                var_484 = wp::extract(var_15, var_463);
            }
            if (!var_475) {
            }
            var_486 = wp::where(var_475, var_484, var_485);
            var_487 = integer_steps_0(var_486, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_475) {
            }
            if (!var_475) {
            }
            var_490 = wp::where(var_475, var_488, var_489);
            var_491 = wp::int64(var_490);
            var_492 = wp::add(var_447, var_491);
            // sx += x                                                                        <L 36>
            var_493 = wp::add(var_448, var_479);
            // sy += y                                                                        <L 37>
            var_494 = wp::add(var_449, var_483);
            // sz += z                                                                        <L 38>
            var_495 = wp::add(var_450, var_487);
            // xx += x * x                                                                    <L 39>
            var_496 = wp::mul(var_479, var_479);
            var_497 = wp::add(var_452, var_496);
            // xy += x * y                                                                    <L 40>
            var_498 = wp::mul(var_479, var_483);
            var_499 = wp::add(var_454, var_498);
            // xz += x * z                                                                    <L 41>
            var_500 = wp::mul(var_479, var_487);
            var_501 = wp::add(var_456, var_500);
            // yy += y * y                                                                    <L 42>
            var_502 = wp::mul(var_483, var_483);
            var_503 = wp::add(var_458, var_502);
            // yz += y * z                                                                    <L 43>
            var_504 = wp::mul(var_483, var_487);
            var_505 = wp::add(var_460, var_504);
            // zz += z * z                                                                    <L 44>
            var_506 = wp::mul(var_487, var_487);
            var_507 = wp::add(var_462, var_506);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_509 = wp::extract(var_11, var_508);
            var_510 = wp::extract(var_11, var_508);
            var_511 = wp::mul(var_509, var_510);
            var_512 = wp::extract(var_13, var_508);
            var_513 = wp::extract(var_13, var_508);
            var_514 = wp::mul(var_512, var_513);
            var_515 = wp::add(var_511, var_514);
            var_516 = wp::extract(var_15, var_508);
            var_517 = wp::extract(var_15, var_508);
            var_518 = wp::mul(var_516, var_517);
            var_519 = wp::add(var_515, var_518);
            var_520 = (var_519 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_520) {
                var_521 = wp::extract(var_11, var_508);
            }
            if (!var_520) {
            }
            var_523 = wp::where(var_520, var_521, var_522);
            var_524 = integer_steps_0(var_523, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_520) {
                var_525 = wp::extract(var_13, var_508);
            }
            if (!var_520) {
            }
            var_527 = wp::where(var_520, var_525, var_526);
            var_528 = integer_steps_0(var_527, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_520) {
                var_529 = wp::extract(var_15, var_508);
            }
            if (!var_520) {
            }
            var_531 = wp::where(var_520, var_529, var_530);
            var_532 = integer_steps_0(var_531, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_520) {
            }
            if (!var_520) {
            }
            var_535 = wp::where(var_520, var_533, var_534);
            var_536 = wp::int64(var_535);
            var_537 = wp::add(var_492, var_536);
            // sx += x                                                                        <L 36>
            var_538 = wp::add(var_493, var_524);
            // sy += y                                                                        <L 37>
            var_539 = wp::add(var_494, var_528);
            // sz += z                                                                        <L 38>
            var_540 = wp::add(var_495, var_532);
            // xx += x * x                                                                    <L 39>
            var_541 = wp::mul(var_524, var_524);
            var_542 = wp::add(var_497, var_541);
            // xy += x * y                                                                    <L 40>
            var_543 = wp::mul(var_524, var_528);
            var_544 = wp::add(var_499, var_543);
            // xz += x * z                                                                    <L 41>
            var_545 = wp::mul(var_524, var_532);
            var_546 = wp::add(var_501, var_545);
            // yy += y * y                                                                    <L 42>
            var_547 = wp::mul(var_528, var_528);
            var_548 = wp::add(var_503, var_547);
            // yz += y * z                                                                    <L 43>
            var_549 = wp::mul(var_528, var_532);
            var_550 = wp::add(var_505, var_549);
            // zz += z * z                                                                    <L 44>
            var_551 = wp::mul(var_532, var_532);
            var_552 = wp::add(var_507, var_551);
        }
        var_553 = wp::where(var_27, var_537, var_0);
        var_554 = wp::where(var_27, var_538, var_1);
        var_555 = wp::where(var_27, var_539, var_2);
        var_556 = wp::where(var_27, var_540, var_3);
        var_557 = wp::where(var_27, var_542, var_4);
        var_558 = wp::where(var_27, var_544, var_5);
        var_559 = wp::where(var_27, var_546, var_6);
        var_560 = wp::where(var_27, var_548, var_7);
        var_561 = wp::where(var_27, var_550, var_8);
        var_562 = wp::where(var_27, var_552, var_9);
        // if distances__leaves_within__1[leaf__leaves_within__1] <= max_sqdist:              <L 23>
        var_564 = wp::extract(var_24, var_563);
        var_565 = (var_564 <= var_max_sqdist);
        if (var_565) {
            // first = bucket__leaves_within__1 * BUCKET__leaves_within + leaf__leaves_within__1 * LEAF__leaves_within       <L 24>
            var_566 = wp::mul(var_23, var_28);
            var_567 = wp::mul(var_563, var_30);
            var_568 = wp::add(var_566, var_567);
            // for j in range(LEAF):                                                          <L 25>
            // q = tree__points[first + j]                                                    <L 26>
            var_570 = wp::add(var_568, var_569);
            var_571 = wp::address(var_tree__points, var_570);
            var_573 = wp::load(var_571);
            var_572 = wp::copy(var_573);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_575 = wp::extract(var_572, var_574);
            var_577 = wp::extract(var_p, var_576);
            var_578 = wp::sub(var_575, var_577);
            wp::assign_inplace(var_11, var_569, var_578);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_580 = wp::extract(var_572, var_579);
            var_582 = wp::extract(var_p, var_581);
            var_583 = wp::sub(var_580, var_582);
            wp::assign_inplace(var_13, var_569, var_583);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_585 = wp::extract(var_572, var_584);
            var_587 = wp::extract(var_p, var_586);
            var_588 = wp::sub(var_585, var_587);
            wp::assign_inplace(var_15, var_569, var_588);
            // q = tree__points[first + j]                                                    <L 26>
            var_590 = wp::add(var_568, var_589);
            var_591 = wp::address(var_tree__points, var_590);
            var_593 = wp::load(var_591);
            var_592 = wp::copy(var_593);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_595 = wp::extract(var_592, var_594);
            var_597 = wp::extract(var_p, var_596);
            var_598 = wp::sub(var_595, var_597);
            wp::assign_inplace(var_11, var_589, var_598);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_600 = wp::extract(var_592, var_599);
            var_602 = wp::extract(var_p, var_601);
            var_603 = wp::sub(var_600, var_602);
            wp::assign_inplace(var_13, var_589, var_603);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_605 = wp::extract(var_592, var_604);
            var_607 = wp::extract(var_p, var_606);
            var_608 = wp::sub(var_605, var_607);
            wp::assign_inplace(var_15, var_589, var_608);
            // q = tree__points[first + j]                                                    <L 26>
            var_610 = wp::add(var_568, var_609);
            var_611 = wp::address(var_tree__points, var_610);
            var_613 = wp::load(var_611);
            var_612 = wp::copy(var_613);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_615 = wp::extract(var_612, var_614);
            var_617 = wp::extract(var_p, var_616);
            var_618 = wp::sub(var_615, var_617);
            wp::assign_inplace(var_11, var_609, var_618);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_620 = wp::extract(var_612, var_619);
            var_622 = wp::extract(var_p, var_621);
            var_623 = wp::sub(var_620, var_622);
            wp::assign_inplace(var_13, var_609, var_623);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_625 = wp::extract(var_612, var_624);
            var_627 = wp::extract(var_p, var_626);
            var_628 = wp::sub(var_625, var_627);
            wp::assign_inplace(var_15, var_609, var_628);
            // q = tree__points[first + j]                                                    <L 26>
            var_630 = wp::add(var_568, var_629);
            var_631 = wp::address(var_tree__points, var_630);
            var_633 = wp::load(var_631);
            var_632 = wp::copy(var_633);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_635 = wp::extract(var_632, var_634);
            var_637 = wp::extract(var_p, var_636);
            var_638 = wp::sub(var_635, var_637);
            wp::assign_inplace(var_11, var_629, var_638);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_640 = wp::extract(var_632, var_639);
            var_642 = wp::extract(var_p, var_641);
            var_643 = wp::sub(var_640, var_642);
            wp::assign_inplace(var_13, var_629, var_643);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_645 = wp::extract(var_632, var_644);
            var_647 = wp::extract(var_p, var_646);
            var_648 = wp::sub(var_645, var_647);
            wp::assign_inplace(var_15, var_629, var_648);
            // q = tree__points[first + j]                                                    <L 26>
            var_650 = wp::add(var_568, var_649);
            var_651 = wp::address(var_tree__points, var_650);
            var_653 = wp::load(var_651);
            var_652 = wp::copy(var_653);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_655 = wp::extract(var_652, var_654);
            var_657 = wp::extract(var_p, var_656);
            var_658 = wp::sub(var_655, var_657);
            wp::assign_inplace(var_11, var_649, var_658);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_660 = wp::extract(var_652, var_659);
            var_662 = wp::extract(var_p, var_661);
            var_663 = wp::sub(var_660, var_662);
            wp::assign_inplace(var_13, var_649, var_663);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_665 = wp::extract(var_652, var_664);
            var_667 = wp::extract(var_p, var_666);
            var_668 = wp::sub(var_665, var_667);
            wp::assign_inplace(var_15, var_649, var_668);
            // q = tree__points[first + j]                                                    <L 26>
            var_670 = wp::add(var_568, var_669);
            var_671 = wp::address(var_tree__points, var_670);
            var_673 = wp::load(var_671);
            var_672 = wp::copy(var_673);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_675 = wp::extract(var_672, var_674);
            var_677 = wp::extract(var_p, var_676);
            var_678 = wp::sub(var_675, var_677);
            wp::assign_inplace(var_11, var_669, var_678);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_680 = wp::extract(var_672, var_679);
            var_682 = wp::extract(var_p, var_681);
            var_683 = wp::sub(var_680, var_682);
            wp::assign_inplace(var_13, var_669, var_683);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_685 = wp::extract(var_672, var_684);
            var_687 = wp::extract(var_p, var_686);
            var_688 = wp::sub(var_685, var_687);
            wp::assign_inplace(var_15, var_669, var_688);
            // q = tree__points[first + j]                                                    <L 26>
            var_690 = wp::add(var_568, var_689);
            var_691 = wp::address(var_tree__points, var_690);
            var_693 = wp::load(var_691);
            var_692 = wp::copy(var_693);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_695 = wp::extract(var_692, var_694);
            var_697 = wp::extract(var_p, var_696);
            var_698 = wp::sub(var_695, var_697);
            wp::assign_inplace(var_11, var_689, var_698);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_700 = wp::extract(var_692, var_699);
            var_702 = wp::extract(var_p, var_701);
            var_703 = wp::sub(var_700, var_702);
            wp::assign_inplace(var_13, var_689, var_703);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_705 = wp::extract(var_692, var_704);
            var_707 = wp::extract(var_p, var_706);
            var_708 = wp::sub(var_705, var_707);
            wp::assign_inplace(var_15, var_689, var_708);
            // q = tree__points[first + j]                                                    <L 26>
            var_710 = wp::add(var_568, var_709);
            var_711 = wp::address(var_tree__points, var_710);
            var_713 = wp::load(var_711);
            var_712 = wp::copy(var_713);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_715 = wp::extract(var_712, var_714);
            var_717 = wp::extract(var_p, var_716);
            var_718 = wp::sub(var_715, var_717);
            wp::assign_inplace(var_11, var_709, var_718);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_720 = wp::extract(var_712, var_719);
            var_722 = wp::extract(var_p, var_721);
            var_723 = wp::sub(var_720, var_722);
            wp::assign_inplace(var_13, var_709, var_723);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_725 = wp::extract(var_712, var_724);
            var_727 = wp::extract(var_p, var_726);
            var_728 = wp::sub(var_725, var_727);
            wp::assign_inplace(var_15, var_709, var_728);
            // for j in range(LEAF):                                                          <L 30>
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_730 = wp::extract(var_11, var_729);
            var_731 = wp::extract(var_11, var_729);
            var_732 = wp::mul(var_730, var_731);
            var_733 = wp::extract(var_13, var_729);
            var_734 = wp::extract(var_13, var_729);
            var_735 = wp::mul(var_733, var_734);
            var_736 = wp::add(var_732, var_735);
            var_737 = wp::extract(var_15, var_729);
            var_738 = wp::extract(var_15, var_729);
            var_739 = wp::mul(var_737, var_738);
            var_740 = wp::add(var_736, var_739);
            var_741 = (var_740 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_741) {
                var_742 = wp::extract(var_11, var_729);
            }
            if (!var_741) {
            }
            var_744 = wp::where(var_741, var_742, var_743);
            var_745 = integer_steps_0(var_744, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_741) {
                var_746 = wp::extract(var_13, var_729);
            }
            if (!var_741) {
            }
            var_748 = wp::where(var_741, var_746, var_747);
            var_749 = integer_steps_0(var_748, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_741) {
                var_750 = wp::extract(var_15, var_729);
            }
            if (!var_741) {
            }
            var_752 = wp::where(var_741, var_750, var_751);
            var_753 = integer_steps_0(var_752, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_741) {
            }
            if (!var_741) {
            }
            var_756 = wp::where(var_741, var_754, var_755);
            var_757 = wp::int64(var_756);
            var_758 = wp::add(var_553, var_757);
            // sx += x                                                                        <L 36>
            var_759 = wp::add(var_554, var_745);
            // sy += y                                                                        <L 37>
            var_760 = wp::add(var_555, var_749);
            // sz += z                                                                        <L 38>
            var_761 = wp::add(var_556, var_753);
            // xx += x * x                                                                    <L 39>
            var_762 = wp::mul(var_745, var_745);
            var_763 = wp::add(var_557, var_762);
            // xy += x * y                                                                    <L 40>
            var_764 = wp::mul(var_745, var_749);
            var_765 = wp::add(var_558, var_764);
            // xz += x * z                                                                    <L 41>
            var_766 = wp::mul(var_745, var_753);
            var_767 = wp::add(var_559, var_766);
            // yy += y * y                                                                    <L 42>
            var_768 = wp::mul(var_749, var_749);
            var_769 = wp::add(var_560, var_768);
            // yz += y * z                                                                    <L 43>
            var_770 = wp::mul(var_749, var_753);
            var_771 = wp::add(var_561, var_770);
            // zz += z * z                                                                    <L 44>
            var_772 = wp::mul(var_753, var_753);
            var_773 = wp::add(var_562, var_772);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_775 = wp::extract(var_11, var_774);
            var_776 = wp::extract(var_11, var_774);
            var_777 = wp::mul(var_775, var_776);
            var_778 = wp::extract(var_13, var_774);
            var_779 = wp::extract(var_13, var_774);
            var_780 = wp::mul(var_778, var_779);
            var_781 = wp::add(var_777, var_780);
            var_782 = wp::extract(var_15, var_774);
            var_783 = wp::extract(var_15, var_774);
            var_784 = wp::mul(var_782, var_783);
            var_785 = wp::add(var_781, var_784);
            var_786 = (var_785 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_786) {
                var_787 = wp::extract(var_11, var_774);
            }
            if (!var_786) {
            }
            var_789 = wp::where(var_786, var_787, var_788);
            var_790 = integer_steps_0(var_789, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_786) {
                var_791 = wp::extract(var_13, var_774);
            }
            if (!var_786) {
            }
            var_793 = wp::where(var_786, var_791, var_792);
            var_794 = integer_steps_0(var_793, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_786) {
                var_795 = wp::extract(var_15, var_774);
            }
            if (!var_786) {
            }
            var_797 = wp::where(var_786, var_795, var_796);
            var_798 = integer_steps_0(var_797, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_786) {
            }
            if (!var_786) {
            }
            var_801 = wp::where(var_786, var_799, var_800);
            var_802 = wp::int64(var_801);
            var_803 = wp::add(var_758, var_802);
            // sx += x                                                                        <L 36>
            var_804 = wp::add(var_759, var_790);
            // sy += y                                                                        <L 37>
            var_805 = wp::add(var_760, var_794);
            // sz += z                                                                        <L 38>
            var_806 = wp::add(var_761, var_798);
            // xx += x * x                                                                    <L 39>
            var_807 = wp::mul(var_790, var_790);
            var_808 = wp::add(var_763, var_807);
            // xy += x * y                                                                    <L 40>
            var_809 = wp::mul(var_790, var_794);
            var_810 = wp::add(var_765, var_809);
            // xz += x * z                                                                    <L 41>
            var_811 = wp::mul(var_790, var_798);
            var_812 = wp::add(var_767, var_811);
            // yy += y * y                                                                    <L 42>
            var_813 = wp::mul(var_794, var_794);
            var_814 = wp::add(var_769, var_813);
            // yz += y * z                                                                    <L 43>
            var_815 = wp::mul(var_794, var_798);
            var_816 = wp::add(var_771, var_815);
            // zz += z * z                                                                    <L 44>
            var_817 = wp::mul(var_798, var_798);
            var_818 = wp::add(var_773, var_817);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_820 = wp::extract(var_11, var_819);
            var_821 = wp::extract(var_11, var_819);
            var_822 = wp::mul(var_820, var_821);
            var_823 = wp::extract(var_13, var_819);
            var_824 = wp::extract(var_13, var_819);
            var_825 = wp::mul(var_823, var_824);
            var_826 = wp::add(var_822, var_825);
            var_827 = wp::extract(var_15, var_819);
            var_828 = wp::extract(var_15, var_819);
            var_829 = wp::mul(var_827, var_828);
            var_830 = wp::add(var_826, var_829);
            var_831 = (var_830 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_831) {
                var_832 = wp::extract(var_11, var_819);
            }
            if (!var_831) {
            }
            var_834 = wp::where(var_831, var_832, var_833);
            var_835 = integer_steps_0(var_834, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_831) {
                var_836 = wp::extract(var_13, var_819);
            }
            if (!var_831) {
            }
            var_838 = wp::where(var_831, var_836, var_837);
            var_839 = integer_steps_0(var_838, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_831) {
                var_840 = wp::extract(var_15, var_819);
            }
            if (!var_831) {
            }
            var_842 = wp::where(var_831, var_840, var_841);
            var_843 = integer_steps_0(var_842, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_831) {
            }
            if (!var_831) {
            }
            var_846 = wp::where(var_831, var_844, var_845);
            var_847 = wp::int64(var_846);
            var_848 = wp::add(var_803, var_847);
            // sx += x                                                                        <L 36>
            var_849 = wp::add(var_804, var_835);
            // sy += y                                                                        <L 37>
            var_850 = wp::add(var_805, var_839);
            // sz += z                                                                        <L 38>
            var_851 = wp::add(var_806, var_843);
            // xx += x * x                                                                    <L 39>
            var_852 = wp::mul(var_835, var_835);
            var_853 = wp::add(var_808, var_852);
            // xy += x * y                                                                    <L 40>
            var_854 = wp::mul(var_835, var_839);
            var_855 = wp::add(var_810, var_854);
            // xz += x * z                                                                    <L 41>
            var_856 = wp::mul(var_835, var_843);
            var_857 = wp::add(var_812, var_856);
            // yy += y * y                                                                    <L 42>
            var_858 = wp::mul(var_839, var_839);
            var_859 = wp::add(var_814, var_858);
            // yz += y * z                                                                    <L 43>
            var_860 = wp::mul(var_839, var_843);
            var_861 = wp::add(var_816, var_860);
            // zz += z * z                                                                    <L 44>
            var_862 = wp::mul(var_843, var_843);
            var_863 = wp::add(var_818, var_862);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_865 = wp::extract(var_11, var_864);
            var_866 = wp::extract(var_11, var_864);
            var_867 = wp::mul(var_865, var_866);
            var_868 = wp::extract(var_13, var_864);
            var_869 = wp::extract(var_13, var_864);
            var_870 = wp::mul(var_868, var_869);
            var_871 = wp::add(var_867, var_870);
            var_872 = wp::extract(var_15, var_864);
            var_873 = wp::extract(var_15, var_864);
            var_874 = wp::mul(var_872, var_873);
            var_875 = wp::add(var_871, var_874);
            var_876 = (var_875 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_876) {
                var_877 = wp::extract(var_11, var_864);
            }
            if (!var_876) {
            }
            var_879 = wp::where(var_876, var_877, var_878);
            var_880 = integer_steps_0(var_879, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_876) {
                var_881 = wp::extract(var_13, var_864);
            }
            if (!var_876) {
            }
            var_883 = wp::where(var_876, var_881, var_882);
            var_884 = integer_steps_0(var_883, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_876) {
                var_885 = wp::extract(var_15, var_864);
            }
            if (!var_876) {
            }
            var_887 = wp::where(var_876, var_885, var_886);
            var_888 = integer_steps_0(var_887, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_876) {
            }
            if (!var_876) {
            }
            var_891 = wp::where(var_876, var_889, var_890);
            var_892 = wp::int64(var_891);
            var_893 = wp::add(var_848, var_892);
            // sx += x                                                                        <L 36>
            var_894 = wp::add(var_849, var_880);
            // sy += y                                                                        <L 37>
            var_895 = wp::add(var_850, var_884);
            // sz += z                                                                        <L 38>
            var_896 = wp::add(var_851, var_888);
            // xx += x * x                                                                    <L 39>
            var_897 = wp::mul(var_880, var_880);
            var_898 = wp::add(var_853, var_897);
            // xy += x * y                                                                    <L 40>
            var_899 = wp::mul(var_880, var_884);
            var_900 = wp::add(var_855, var_899);
            // xz += x * z                                                                    <L 41>
            var_901 = wp::mul(var_880, var_888);
            var_902 = wp::add(var_857, var_901);
            // yy += y * y                                                                    <L 42>
            var_903 = wp::mul(var_884, var_884);
            var_904 = wp::add(var_859, var_903);
            // yz += y * z                                                                    <L 43>
            var_905 = wp::mul(var_884, var_888);
            var_906 = wp::add(var_861, var_905);
            // zz += z * z                                                                    <L 44>
            var_907 = wp::mul(var_888, var_888);
            var_908 = wp::add(var_863, var_907);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_910 = wp::extract(var_11, var_909);
            var_911 = wp::extract(var_11, var_909);
            var_912 = wp::mul(var_910, var_911);
            var_913 = wp::extract(var_13, var_909);
            var_914 = wp::extract(var_13, var_909);
            var_915 = wp::mul(var_913, var_914);
            var_916 = wp::add(var_912, var_915);
            var_917 = wp::extract(var_15, var_909);
            var_918 = wp::extract(var_15, var_909);
            var_919 = wp::mul(var_917, var_918);
            var_920 = wp::add(var_916, var_919);
            var_921 = (var_920 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_921) {
                var_922 = wp::extract(var_11, var_909);
            }
            if (!var_921) {
            }
            var_924 = wp::where(var_921, var_922, var_923);
            var_925 = integer_steps_0(var_924, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_921) {
                var_926 = wp::extract(var_13, var_909);
            }
            if (!var_921) {
            }
            var_928 = wp::where(var_921, var_926, var_927);
            var_929 = integer_steps_0(var_928, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_921) {
                var_930 = wp::extract(var_15, var_909);
            }
            if (!var_921) {
            }
            var_932 = wp::where(var_921, var_930, var_931);
            var_933 = integer_steps_0(var_932, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_921) {
            }
            if (!var_921) {
            }
            var_936 = wp::where(var_921, var_934, var_935);
            var_937 = wp::int64(var_936);
            var_938 = wp::add(var_893, var_937);
            // sx += x                                                                        <L 36>
            var_939 = wp::add(var_894, var_925);
            // sy += y                                                                        <L 37>
            var_940 = wp::add(var_895, var_929);
            // sz += z                                                                        <L 38>
            var_941 = wp::add(var_896, var_933);
            // xx += x * x                                                                    <L 39>
            var_942 = wp::mul(var_925, var_925);
            var_943 = wp::add(var_898, var_942);
            // xy += x * y                                                                    <L 40>
            var_944 = wp::mul(var_925, var_929);
            var_945 = wp::add(var_900, var_944);
            // xz += x * z                                                                    <L 41>
            var_946 = wp::mul(var_925, var_933);
            var_947 = wp::add(var_902, var_946);
            // yy += y * y                                                                    <L 42>
            var_948 = wp::mul(var_929, var_929);
            var_949 = wp::add(var_904, var_948);
            // yz += y * z                                                                    <L 43>
            var_950 = wp::mul(var_929, var_933);
            var_951 = wp::add(var_906, var_950);
            // zz += z * z                                                                    <L 44>
            var_952 = wp::mul(var_933, var_933);
            var_953 = wp::add(var_908, var_952);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_955 = wp::extract(var_11, var_954);
            var_956 = wp::extract(var_11, var_954);
            var_957 = wp::mul(var_955, var_956);
            var_958 = wp::extract(var_13, var_954);
            var_959 = wp::extract(var_13, var_954);
            var_960 = wp::mul(var_958, var_959);
            var_961 = wp::add(var_957, var_960);
            var_962 = wp::extract(var_15, var_954);
            var_963 = wp::extract(var_15, var_954);
            var_964 = wp::mul(var_962, var_963);
            var_965 = wp::add(var_961, var_964);
            var_966 = (var_965 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_966) {
                var_967 = wp::extract(var_11, var_954);
            }
            if (!var_966) {
            }
            var_969 = wp::where(var_966, var_967, var_968);
            var_970 = integer_steps_0(var_969, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_966) {
                var_971 = wp::extract(var_13, var_954);
            }
            if (!var_966) {
            }
            var_973 = wp::where(var_966, var_971, var_972);
            var_974 = integer_steps_0(var_973, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_966) {
                var_975 = wp::extract(var_15, var_954);
            }
            if (!var_966) {
            }
            var_977 = wp::where(var_966, var_975, var_976);
            var_978 = integer_steps_0(var_977, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_966) {
            }
            if (!var_966) {
            }
            var_981 = wp::where(var_966, var_979, var_980);
            var_982 = wp::int64(var_981);
            var_983 = wp::add(var_938, var_982);
            // sx += x                                                                        <L 36>
            var_984 = wp::add(var_939, var_970);
            // sy += y                                                                        <L 37>
            var_985 = wp::add(var_940, var_974);
            // sz += z                                                                        <L 38>
            var_986 = wp::add(var_941, var_978);
            // xx += x * x                                                                    <L 39>
            var_987 = wp::mul(var_970, var_970);
            var_988 = wp::add(var_943, var_987);
            // xy += x * y                                                                    <L 40>
            var_989 = wp::mul(var_970, var_974);
            var_990 = wp::add(var_945, var_989);
            // xz += x * z                                                                    <L 41>
            var_991 = wp::mul(var_970, var_978);
            var_992 = wp::add(var_947, var_991);
            // yy += y * y                                                                    <L 42>
            var_993 = wp::mul(var_974, var_974);
            var_994 = wp::add(var_949, var_993);
            // yz += y * z                                                                    <L 43>
            var_995 = wp::mul(var_974, var_978);
            var_996 = wp::add(var_951, var_995);
            // zz += z * z                                                                    <L 44>
            var_997 = wp::mul(var_978, var_978);
            var_998 = wp::add(var_953, var_997);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_1000 = wp::extract(var_11, var_999);
            var_1001 = wp::extract(var_11, var_999);
            var_1002 = wp::mul(var_1000, var_1001);
            var_1003 = wp::extract(var_13, var_999);
            var_1004 = wp::extract(var_13, var_999);
            var_1005 = wp::mul(var_1003, var_1004);
            var_1006 = wp::add(var_1002, var_1005);
            var_1007 = wp::extract(var_15, var_999);
            var_1008 = wp::extract(var_15, var_999);
            var_1009 = wp::mul(var_1007, var_1008);
            var_1010 = wp::add(var_1006, var_1009);
            var_1011 = (var_1010 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_1011) {
                var_1012 = wp::extract(var_11, var_999);
            }
            if (!var_1011) {
            }
            var_1014 = wp::where(var_1011, var_1012, var_1013);
            var_1015 = integer_steps_0(var_1014, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_1011) {
                var_1016 = wp::extract(var_13, var_999);
            }
            if (!var_1011) {
            }
            var_1018 = wp::where(var_1011, var_1016, var_1017);
            var_1019 = integer_steps_0(var_1018, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_1011) {
                var_1020 = wp::extract(var_15, var_999);
            }
            if (!var_1011) {
            }
            var_1022 = wp::where(var_1011, var_1020, var_1021);
            var_1023 = integer_steps_0(var_1022, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_1011) {
            }
            if (!var_1011) {
            }
            var_1026 = wp::where(var_1011, var_1024, var_1025);
            var_1027 = wp::int64(var_1026);
            var_1028 = wp::add(var_983, var_1027);
            // sx += x                                                                        <L 36>
            var_1029 = wp::add(var_984, var_1015);
            // sy += y                                                                        <L 37>
            var_1030 = wp::add(var_985, var_1019);
            // sz += z                                                                        <L 38>
            var_1031 = wp::add(var_986, var_1023);
            // xx += x * x                                                                    <L 39>
            var_1032 = wp::mul(var_1015, var_1015);
            var_1033 = wp::add(var_988, var_1032);
            // xy += x * y                                                                    <L 40>
            var_1034 = wp::mul(var_1015, var_1019);
            var_1035 = wp::add(var_990, var_1034);
            // xz += x * z                                                                    <L 41>
            var_1036 = wp::mul(var_1015, var_1023);
            var_1037 = wp::add(var_992, var_1036);
            // yy += y * y                                                                    <L 42>
            var_1038 = wp::mul(var_1019, var_1019);
            var_1039 = wp::add(var_994, var_1038);
            // yz += y * z                                                                    <L 43>
            var_1040 = wp::mul(var_1019, var_1023);
            var_1041 = wp::add(var_996, var_1040);
            // zz += z * z                                                                    <L 44>
            var_1042 = wp::mul(var_1023, var_1023);
            var_1043 = wp::add(var_998, var_1042);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_1045 = wp::extract(var_11, var_1044);
            var_1046 = wp::extract(var_11, var_1044);
            var_1047 = wp::mul(var_1045, var_1046);
            var_1048 = wp::extract(var_13, var_1044);
            var_1049 = wp::extract(var_13, var_1044);
            var_1050 = wp::mul(var_1048, var_1049);
            var_1051 = wp::add(var_1047, var_1050);
            var_1052 = wp::extract(var_15, var_1044);
            var_1053 = wp::extract(var_15, var_1044);
            var_1054 = wp::mul(var_1052, var_1053);
            var_1055 = wp::add(var_1051, var_1054);
            var_1056 = (var_1055 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_1056) {
                var_1057 = wp::extract(var_11, var_1044);
            }
            if (!var_1056) {
            }
            var_1059 = wp::where(var_1056, var_1057, var_1058);
            var_1060 = integer_steps_0(var_1059, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_1056) {
                var_1061 = wp::extract(var_13, var_1044);
            }
            if (!var_1056) {
            }
            var_1063 = wp::where(var_1056, var_1061, var_1062);
            var_1064 = integer_steps_0(var_1063, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_1056) {
                var_1065 = wp::extract(var_15, var_1044);
            }
            if (!var_1056) {
            }
            var_1067 = wp::where(var_1056, var_1065, var_1066);
            var_1068 = integer_steps_0(var_1067, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_1056) {
            }
            if (!var_1056) {
            }
            var_1071 = wp::where(var_1056, var_1069, var_1070);
            var_1072 = wp::int64(var_1071);
            var_1073 = wp::add(var_1028, var_1072);
            // sx += x                                                                        <L 36>
            var_1074 = wp::add(var_1029, var_1060);
            // sy += y                                                                        <L 37>
            var_1075 = wp::add(var_1030, var_1064);
            // sz += z                                                                        <L 38>
            var_1076 = wp::add(var_1031, var_1068);
            // xx += x * x                                                                    <L 39>
            var_1077 = wp::mul(var_1060, var_1060);
            var_1078 = wp::add(var_1033, var_1077);
            // xy += x * y                                                                    <L 40>
            var_1079 = wp::mul(var_1060, var_1064);
            var_1080 = wp::add(var_1035, var_1079);
            // xz += x * z                                                                    <L 41>
            var_1081 = wp::mul(var_1060, var_1068);
            var_1082 = wp::add(var_1037, var_1081);
            // yy += y * y                                                                    <L 42>
            var_1083 = wp::mul(var_1064, var_1064);
            var_1084 = wp::add(var_1039, var_1083);
            // yz += y * z                                                                    <L 43>
            var_1085 = wp::mul(var_1064, var_1068);
            var_1086 = wp::add(var_1041, var_1085);
            // zz += z * z                                                                    <L 44>
            var_1087 = wp::mul(var_1068, var_1068);
            var_1088 = wp::add(var_1043, var_1087);
        }
        var_1089 = wp::where(var_565, var_1073, var_553);
        var_1090 = wp::where(var_565, var_1074, var_554);
        var_1091 = wp::where(var_565, var_1075, var_555);
        var_1092 = wp::where(var_565, var_1076, var_556);
        var_1093 = wp::where(var_565, var_1078, var_557);
        var_1094 = wp::where(var_565, var_1080, var_558);
        var_1095 = wp::where(var_565, var_1082, var_559);
        var_1096 = wp::where(var_565, var_1084, var_560);
        var_1097 = wp::where(var_565, var_1086, var_561);
        var_1098 = wp::where(var_565, var_1088, var_562);
        var_1099 = wp::where(var_565, var_568, var_32);
        var_1100 = wp::where(var_565, var_1044, var_508);
        var_1101 = wp::where(var_565, var_712, var_176);
        var_1102 = wp::where(var_565, var_1056, var_520);
        var_1103 = wp::where(var_565, var_1060, var_524);
        var_1104 = wp::where(var_565, var_1064, var_528);
        var_1105 = wp::where(var_565, var_1068, var_532);
        // if distances__leaves_within__1[leaf__leaves_within__1] <= max_sqdist:              <L 23>
        var_1107 = wp::extract(var_24, var_1106);
        var_1108 = (var_1107 <= var_max_sqdist);
        if (var_1108) {
            // first = bucket__leaves_within__1 * BUCKET__leaves_within + leaf__leaves_within__1 * LEAF__leaves_within       <L 24>
            var_1109 = wp::mul(var_23, var_28);
            var_1110 = wp::mul(var_1106, var_30);
            var_1111 = wp::add(var_1109, var_1110);
            // for j in range(LEAF):                                                          <L 25>
            // q = tree__points[first + j]                                                    <L 26>
            var_1113 = wp::add(var_1111, var_1112);
            var_1114 = wp::address(var_tree__points, var_1113);
            var_1116 = wp::load(var_1114);
            var_1115 = wp::copy(var_1116);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_1118 = wp::extract(var_1115, var_1117);
            var_1120 = wp::extract(var_p, var_1119);
            var_1121 = wp::sub(var_1118, var_1120);
            wp::assign_inplace(var_11, var_1112, var_1121);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_1123 = wp::extract(var_1115, var_1122);
            var_1125 = wp::extract(var_p, var_1124);
            var_1126 = wp::sub(var_1123, var_1125);
            wp::assign_inplace(var_13, var_1112, var_1126);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_1128 = wp::extract(var_1115, var_1127);
            var_1130 = wp::extract(var_p, var_1129);
            var_1131 = wp::sub(var_1128, var_1130);
            wp::assign_inplace(var_15, var_1112, var_1131);
            // q = tree__points[first + j]                                                    <L 26>
            var_1133 = wp::add(var_1111, var_1132);
            var_1134 = wp::address(var_tree__points, var_1133);
            var_1136 = wp::load(var_1134);
            var_1135 = wp::copy(var_1136);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_1138 = wp::extract(var_1135, var_1137);
            var_1140 = wp::extract(var_p, var_1139);
            var_1141 = wp::sub(var_1138, var_1140);
            wp::assign_inplace(var_11, var_1132, var_1141);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_1143 = wp::extract(var_1135, var_1142);
            var_1145 = wp::extract(var_p, var_1144);
            var_1146 = wp::sub(var_1143, var_1145);
            wp::assign_inplace(var_13, var_1132, var_1146);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_1148 = wp::extract(var_1135, var_1147);
            var_1150 = wp::extract(var_p, var_1149);
            var_1151 = wp::sub(var_1148, var_1150);
            wp::assign_inplace(var_15, var_1132, var_1151);
            // q = tree__points[first + j]                                                    <L 26>
            var_1153 = wp::add(var_1111, var_1152);
            var_1154 = wp::address(var_tree__points, var_1153);
            var_1156 = wp::load(var_1154);
            var_1155 = wp::copy(var_1156);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_1158 = wp::extract(var_1155, var_1157);
            var_1160 = wp::extract(var_p, var_1159);
            var_1161 = wp::sub(var_1158, var_1160);
            wp::assign_inplace(var_11, var_1152, var_1161);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_1163 = wp::extract(var_1155, var_1162);
            var_1165 = wp::extract(var_p, var_1164);
            var_1166 = wp::sub(var_1163, var_1165);
            wp::assign_inplace(var_13, var_1152, var_1166);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_1168 = wp::extract(var_1155, var_1167);
            var_1170 = wp::extract(var_p, var_1169);
            var_1171 = wp::sub(var_1168, var_1170);
            wp::assign_inplace(var_15, var_1152, var_1171);
            // q = tree__points[first + j]                                                    <L 26>
            var_1173 = wp::add(var_1111, var_1172);
            var_1174 = wp::address(var_tree__points, var_1173);
            var_1176 = wp::load(var_1174);
            var_1175 = wp::copy(var_1176);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_1178 = wp::extract(var_1175, var_1177);
            var_1180 = wp::extract(var_p, var_1179);
            var_1181 = wp::sub(var_1178, var_1180);
            wp::assign_inplace(var_11, var_1172, var_1181);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_1183 = wp::extract(var_1175, var_1182);
            var_1185 = wp::extract(var_p, var_1184);
            var_1186 = wp::sub(var_1183, var_1185);
            wp::assign_inplace(var_13, var_1172, var_1186);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_1188 = wp::extract(var_1175, var_1187);
            var_1190 = wp::extract(var_p, var_1189);
            var_1191 = wp::sub(var_1188, var_1190);
            wp::assign_inplace(var_15, var_1172, var_1191);
            // q = tree__points[first + j]                                                    <L 26>
            var_1193 = wp::add(var_1111, var_1192);
            var_1194 = wp::address(var_tree__points, var_1193);
            var_1196 = wp::load(var_1194);
            var_1195 = wp::copy(var_1196);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_1198 = wp::extract(var_1195, var_1197);
            var_1200 = wp::extract(var_p, var_1199);
            var_1201 = wp::sub(var_1198, var_1200);
            wp::assign_inplace(var_11, var_1192, var_1201);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_1203 = wp::extract(var_1195, var_1202);
            var_1205 = wp::extract(var_p, var_1204);
            var_1206 = wp::sub(var_1203, var_1205);
            wp::assign_inplace(var_13, var_1192, var_1206);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_1208 = wp::extract(var_1195, var_1207);
            var_1210 = wp::extract(var_p, var_1209);
            var_1211 = wp::sub(var_1208, var_1210);
            wp::assign_inplace(var_15, var_1192, var_1211);
            // q = tree__points[first + j]                                                    <L 26>
            var_1213 = wp::add(var_1111, var_1212);
            var_1214 = wp::address(var_tree__points, var_1213);
            var_1216 = wp::load(var_1214);
            var_1215 = wp::copy(var_1216);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_1218 = wp::extract(var_1215, var_1217);
            var_1220 = wp::extract(var_p, var_1219);
            var_1221 = wp::sub(var_1218, var_1220);
            wp::assign_inplace(var_11, var_1212, var_1221);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_1223 = wp::extract(var_1215, var_1222);
            var_1225 = wp::extract(var_p, var_1224);
            var_1226 = wp::sub(var_1223, var_1225);
            wp::assign_inplace(var_13, var_1212, var_1226);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_1228 = wp::extract(var_1215, var_1227);
            var_1230 = wp::extract(var_p, var_1229);
            var_1231 = wp::sub(var_1228, var_1230);
            wp::assign_inplace(var_15, var_1212, var_1231);
            // q = tree__points[first + j]                                                    <L 26>
            var_1233 = wp::add(var_1111, var_1232);
            var_1234 = wp::address(var_tree__points, var_1233);
            var_1236 = wp::load(var_1234);
            var_1235 = wp::copy(var_1236);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_1238 = wp::extract(var_1235, var_1237);
            var_1240 = wp::extract(var_p, var_1239);
            var_1241 = wp::sub(var_1238, var_1240);
            wp::assign_inplace(var_11, var_1232, var_1241);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_1243 = wp::extract(var_1235, var_1242);
            var_1245 = wp::extract(var_p, var_1244);
            var_1246 = wp::sub(var_1243, var_1245);
            wp::assign_inplace(var_13, var_1232, var_1246);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_1248 = wp::extract(var_1235, var_1247);
            var_1250 = wp::extract(var_p, var_1249);
            var_1251 = wp::sub(var_1248, var_1250);
            wp::assign_inplace(var_15, var_1232, var_1251);
            // q = tree__points[first + j]                                                    <L 26>
            var_1253 = wp::add(var_1111, var_1252);
            var_1254 = wp::address(var_tree__points, var_1253);
            var_1256 = wp::load(var_1254);
            var_1255 = wp::copy(var_1256);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_1258 = wp::extract(var_1255, var_1257);
            var_1260 = wp::extract(var_p, var_1259);
            var_1261 = wp::sub(var_1258, var_1260);
            wp::assign_inplace(var_11, var_1252, var_1261);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_1263 = wp::extract(var_1255, var_1262);
            var_1265 = wp::extract(var_p, var_1264);
            var_1266 = wp::sub(var_1263, var_1265);
            wp::assign_inplace(var_13, var_1252, var_1266);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_1268 = wp::extract(var_1255, var_1267);
            var_1270 = wp::extract(var_p, var_1269);
            var_1271 = wp::sub(var_1268, var_1270);
            wp::assign_inplace(var_15, var_1252, var_1271);
            // for j in range(LEAF):                                                          <L 30>
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_1273 = wp::extract(var_11, var_1272);
            var_1274 = wp::extract(var_11, var_1272);
            var_1275 = wp::mul(var_1273, var_1274);
            var_1276 = wp::extract(var_13, var_1272);
            var_1277 = wp::extract(var_13, var_1272);
            var_1278 = wp::mul(var_1276, var_1277);
            var_1279 = wp::add(var_1275, var_1278);
            var_1280 = wp::extract(var_15, var_1272);
            var_1281 = wp::extract(var_15, var_1272);
            var_1282 = wp::mul(var_1280, var_1281);
            var_1283 = wp::add(var_1279, var_1282);
            var_1284 = (var_1283 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_1284) {
                var_1285 = wp::extract(var_11, var_1272);
            }
            if (!var_1284) {
            }
            var_1287 = wp::where(var_1284, var_1285, var_1286);
            var_1288 = integer_steps_0(var_1287, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_1284) {
                var_1289 = wp::extract(var_13, var_1272);
            }
            if (!var_1284) {
            }
            var_1291 = wp::where(var_1284, var_1289, var_1290);
            var_1292 = integer_steps_0(var_1291, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_1284) {
                var_1293 = wp::extract(var_15, var_1272);
            }
            if (!var_1284) {
            }
            var_1295 = wp::where(var_1284, var_1293, var_1294);
            var_1296 = integer_steps_0(var_1295, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_1284) {
            }
            if (!var_1284) {
            }
            var_1299 = wp::where(var_1284, var_1297, var_1298);
            var_1300 = wp::int64(var_1299);
            var_1301 = wp::add(var_1089, var_1300);
            // sx += x                                                                        <L 36>
            var_1302 = wp::add(var_1090, var_1288);
            // sy += y                                                                        <L 37>
            var_1303 = wp::add(var_1091, var_1292);
            // sz += z                                                                        <L 38>
            var_1304 = wp::add(var_1092, var_1296);
            // xx += x * x                                                                    <L 39>
            var_1305 = wp::mul(var_1288, var_1288);
            var_1306 = wp::add(var_1093, var_1305);
            // xy += x * y                                                                    <L 40>
            var_1307 = wp::mul(var_1288, var_1292);
            var_1308 = wp::add(var_1094, var_1307);
            // xz += x * z                                                                    <L 41>
            var_1309 = wp::mul(var_1288, var_1296);
            var_1310 = wp::add(var_1095, var_1309);
            // yy += y * y                                                                    <L 42>
            var_1311 = wp::mul(var_1292, var_1292);
            var_1312 = wp::add(var_1096, var_1311);
            // yz += y * z                                                                    <L 43>
            var_1313 = wp::mul(var_1292, var_1296);
            var_1314 = wp::add(var_1097, var_1313);
            // zz += z * z                                                                    <L 44>
            var_1315 = wp::mul(var_1296, var_1296);
            var_1316 = wp::add(var_1098, var_1315);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_1318 = wp::extract(var_11, var_1317);
            var_1319 = wp::extract(var_11, var_1317);
            var_1320 = wp::mul(var_1318, var_1319);
            var_1321 = wp::extract(var_13, var_1317);
            var_1322 = wp::extract(var_13, var_1317);
            var_1323 = wp::mul(var_1321, var_1322);
            var_1324 = wp::add(var_1320, var_1323);
            var_1325 = wp::extract(var_15, var_1317);
            var_1326 = wp::extract(var_15, var_1317);
            var_1327 = wp::mul(var_1325, var_1326);
            var_1328 = wp::add(var_1324, var_1327);
            var_1329 = (var_1328 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_1329) {
                var_1330 = wp::extract(var_11, var_1317);
            }
            if (!var_1329) {
            }
            var_1332 = wp::where(var_1329, var_1330, var_1331);
            var_1333 = integer_steps_0(var_1332, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_1329) {
                var_1334 = wp::extract(var_13, var_1317);
            }
            if (!var_1329) {
            }
            var_1336 = wp::where(var_1329, var_1334, var_1335);
            var_1337 = integer_steps_0(var_1336, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_1329) {
                var_1338 = wp::extract(var_15, var_1317);
            }
            if (!var_1329) {
            }
            var_1340 = wp::where(var_1329, var_1338, var_1339);
            var_1341 = integer_steps_0(var_1340, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_1329) {
            }
            if (!var_1329) {
            }
            var_1344 = wp::where(var_1329, var_1342, var_1343);
            var_1345 = wp::int64(var_1344);
            var_1346 = wp::add(var_1301, var_1345);
            // sx += x                                                                        <L 36>
            var_1347 = wp::add(var_1302, var_1333);
            // sy += y                                                                        <L 37>
            var_1348 = wp::add(var_1303, var_1337);
            // sz += z                                                                        <L 38>
            var_1349 = wp::add(var_1304, var_1341);
            // xx += x * x                                                                    <L 39>
            var_1350 = wp::mul(var_1333, var_1333);
            var_1351 = wp::add(var_1306, var_1350);
            // xy += x * y                                                                    <L 40>
            var_1352 = wp::mul(var_1333, var_1337);
            var_1353 = wp::add(var_1308, var_1352);
            // xz += x * z                                                                    <L 41>
            var_1354 = wp::mul(var_1333, var_1341);
            var_1355 = wp::add(var_1310, var_1354);
            // yy += y * y                                                                    <L 42>
            var_1356 = wp::mul(var_1337, var_1337);
            var_1357 = wp::add(var_1312, var_1356);
            // yz += y * z                                                                    <L 43>
            var_1358 = wp::mul(var_1337, var_1341);
            var_1359 = wp::add(var_1314, var_1358);
            // zz += z * z                                                                    <L 44>
            var_1360 = wp::mul(var_1341, var_1341);
            var_1361 = wp::add(var_1316, var_1360);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_1363 = wp::extract(var_11, var_1362);
            var_1364 = wp::extract(var_11, var_1362);
            var_1365 = wp::mul(var_1363, var_1364);
            var_1366 = wp::extract(var_13, var_1362);
            var_1367 = wp::extract(var_13, var_1362);
            var_1368 = wp::mul(var_1366, var_1367);
            var_1369 = wp::add(var_1365, var_1368);
            var_1370 = wp::extract(var_15, var_1362);
            var_1371 = wp::extract(var_15, var_1362);
            var_1372 = wp::mul(var_1370, var_1371);
            var_1373 = wp::add(var_1369, var_1372);
            var_1374 = (var_1373 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_1374) {
                var_1375 = wp::extract(var_11, var_1362);
            }
            if (!var_1374) {
            }
            var_1377 = wp::where(var_1374, var_1375, var_1376);
            var_1378 = integer_steps_0(var_1377, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_1374) {
                var_1379 = wp::extract(var_13, var_1362);
            }
            if (!var_1374) {
            }
            var_1381 = wp::where(var_1374, var_1379, var_1380);
            var_1382 = integer_steps_0(var_1381, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_1374) {
                var_1383 = wp::extract(var_15, var_1362);
            }
            if (!var_1374) {
            }
            var_1385 = wp::where(var_1374, var_1383, var_1384);
            var_1386 = integer_steps_0(var_1385, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_1374) {
            }
            if (!var_1374) {
            }
            var_1389 = wp::where(var_1374, var_1387, var_1388);
            var_1390 = wp::int64(var_1389);
            var_1391 = wp::add(var_1346, var_1390);
            // sx += x                                                                        <L 36>
            var_1392 = wp::add(var_1347, var_1378);
            // sy += y                                                                        <L 37>
            var_1393 = wp::add(var_1348, var_1382);
            // sz += z                                                                        <L 38>
            var_1394 = wp::add(var_1349, var_1386);
            // xx += x * x                                                                    <L 39>
            var_1395 = wp::mul(var_1378, var_1378);
            var_1396 = wp::add(var_1351, var_1395);
            // xy += x * y                                                                    <L 40>
            var_1397 = wp::mul(var_1378, var_1382);
            var_1398 = wp::add(var_1353, var_1397);
            // xz += x * z                                                                    <L 41>
            var_1399 = wp::mul(var_1378, var_1386);
            var_1400 = wp::add(var_1355, var_1399);
            // yy += y * y                                                                    <L 42>
            var_1401 = wp::mul(var_1382, var_1382);
            var_1402 = wp::add(var_1357, var_1401);
            // yz += y * z                                                                    <L 43>
            var_1403 = wp::mul(var_1382, var_1386);
            var_1404 = wp::add(var_1359, var_1403);
            // zz += z * z                                                                    <L 44>
            var_1405 = wp::mul(var_1386, var_1386);
            var_1406 = wp::add(var_1361, var_1405);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_1408 = wp::extract(var_11, var_1407);
            var_1409 = wp::extract(var_11, var_1407);
            var_1410 = wp::mul(var_1408, var_1409);
            var_1411 = wp::extract(var_13, var_1407);
            var_1412 = wp::extract(var_13, var_1407);
            var_1413 = wp::mul(var_1411, var_1412);
            var_1414 = wp::add(var_1410, var_1413);
            var_1415 = wp::extract(var_15, var_1407);
            var_1416 = wp::extract(var_15, var_1407);
            var_1417 = wp::mul(var_1415, var_1416);
            var_1418 = wp::add(var_1414, var_1417);
            var_1419 = (var_1418 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_1419) {
                var_1420 = wp::extract(var_11, var_1407);
            }
            if (!var_1419) {
            }
            var_1422 = wp::where(var_1419, var_1420, var_1421);
            var_1423 = integer_steps_0(var_1422, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_1419) {
                var_1424 = wp::extract(var_13, var_1407);
            }
            if (!var_1419) {
            }
            var_1426 = wp::where(var_1419, var_1424, var_1425);
            var_1427 = integer_steps_0(var_1426, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_1419) {
                var_1428 = wp::extract(var_15, var_1407);
            }
            if (!var_1419) {
            }
            var_1430 = wp::where(var_1419, var_1428, var_1429);
            var_1431 = integer_steps_0(var_1430, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_1419) {
            }
            if (!var_1419) {
            }
            var_1434 = wp::where(var_1419, var_1432, var_1433);
            var_1435 = wp::int64(var_1434);
            var_1436 = wp::add(var_1391, var_1435);
            // sx += x                                                                        <L 36>
            var_1437 = wp::add(var_1392, var_1423);
            // sy += y                                                                        <L 37>
            var_1438 = wp::add(var_1393, var_1427);
            // sz += z                                                                        <L 38>
            var_1439 = wp::add(var_1394, var_1431);
            // xx += x * x                                                                    <L 39>
            var_1440 = wp::mul(var_1423, var_1423);
            var_1441 = wp::add(var_1396, var_1440);
            // xy += x * y                                                                    <L 40>
            var_1442 = wp::mul(var_1423, var_1427);
            var_1443 = wp::add(var_1398, var_1442);
            // xz += x * z                                                                    <L 41>
            var_1444 = wp::mul(var_1423, var_1431);
            var_1445 = wp::add(var_1400, var_1444);
            // yy += y * y                                                                    <L 42>
            var_1446 = wp::mul(var_1427, var_1427);
            var_1447 = wp::add(var_1402, var_1446);
            // yz += y * z                                                                    <L 43>
            var_1448 = wp::mul(var_1427, var_1431);
            var_1449 = wp::add(var_1404, var_1448);
            // zz += z * z                                                                    <L 44>
            var_1450 = wp::mul(var_1431, var_1431);
            var_1451 = wp::add(var_1406, var_1450);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_1453 = wp::extract(var_11, var_1452);
            var_1454 = wp::extract(var_11, var_1452);
            var_1455 = wp::mul(var_1453, var_1454);
            var_1456 = wp::extract(var_13, var_1452);
            var_1457 = wp::extract(var_13, var_1452);
            var_1458 = wp::mul(var_1456, var_1457);
            var_1459 = wp::add(var_1455, var_1458);
            var_1460 = wp::extract(var_15, var_1452);
            var_1461 = wp::extract(var_15, var_1452);
            var_1462 = wp::mul(var_1460, var_1461);
            var_1463 = wp::add(var_1459, var_1462);
            var_1464 = (var_1463 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_1464) {
                var_1465 = wp::extract(var_11, var_1452);
            }
            if (!var_1464) {
            }
            var_1467 = wp::where(var_1464, var_1465, var_1466);
            var_1468 = integer_steps_0(var_1467, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_1464) {
                var_1469 = wp::extract(var_13, var_1452);
            }
            if (!var_1464) {
            }
            var_1471 = wp::where(var_1464, var_1469, var_1470);
            var_1472 = integer_steps_0(var_1471, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_1464) {
                var_1473 = wp::extract(var_15, var_1452);
            }
            if (!var_1464) {
            }
            var_1475 = wp::where(var_1464, var_1473, var_1474);
            var_1476 = integer_steps_0(var_1475, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_1464) {
            }
            if (!var_1464) {
            }
            var_1479 = wp::where(var_1464, var_1477, var_1478);
            var_1480 = wp::int64(var_1479);
            var_1481 = wp::add(var_1436, var_1480);
            // sx += x                                                                        <L 36>
            var_1482 = wp::add(var_1437, var_1468);
            // sy += y                                                                        <L 37>
            var_1483 = wp::add(var_1438, var_1472);
            // sz += z                                                                        <L 38>
            var_1484 = wp::add(var_1439, var_1476);
            // xx += x * x                                                                    <L 39>
            var_1485 = wp::mul(var_1468, var_1468);
            var_1486 = wp::add(var_1441, var_1485);
            // xy += x * y                                                                    <L 40>
            var_1487 = wp::mul(var_1468, var_1472);
            var_1488 = wp::add(var_1443, var_1487);
            // xz += x * z                                                                    <L 41>
            var_1489 = wp::mul(var_1468, var_1476);
            var_1490 = wp::add(var_1445, var_1489);
            // yy += y * y                                                                    <L 42>
            var_1491 = wp::mul(var_1472, var_1472);
            var_1492 = wp::add(var_1447, var_1491);
            // yz += y * z                                                                    <L 43>
            var_1493 = wp::mul(var_1472, var_1476);
            var_1494 = wp::add(var_1449, var_1493);
            // zz += z * z                                                                    <L 44>
            var_1495 = wp::mul(var_1476, var_1476);
            var_1496 = wp::add(var_1451, var_1495);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_1498 = wp::extract(var_11, var_1497);
            var_1499 = wp::extract(var_11, var_1497);
            var_1500 = wp::mul(var_1498, var_1499);
            var_1501 = wp::extract(var_13, var_1497);
            var_1502 = wp::extract(var_13, var_1497);
            var_1503 = wp::mul(var_1501, var_1502);
            var_1504 = wp::add(var_1500, var_1503);
            var_1505 = wp::extract(var_15, var_1497);
            var_1506 = wp::extract(var_15, var_1497);
            var_1507 = wp::mul(var_1505, var_1506);
            var_1508 = wp::add(var_1504, var_1507);
            var_1509 = (var_1508 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_1509) {
                var_1510 = wp::extract(var_11, var_1497);
            }
            if (!var_1509) {
            }
            var_1512 = wp::where(var_1509, var_1510, var_1511);
            var_1513 = integer_steps_0(var_1512, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_1509) {
                var_1514 = wp::extract(var_13, var_1497);
            }
            if (!var_1509) {
            }
            var_1516 = wp::where(var_1509, var_1514, var_1515);
            var_1517 = integer_steps_0(var_1516, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_1509) {
                var_1518 = wp::extract(var_15, var_1497);
            }
            if (!var_1509) {
            }
            var_1520 = wp::where(var_1509, var_1518, var_1519);
            var_1521 = integer_steps_0(var_1520, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_1509) {
            }
            if (!var_1509) {
            }
            var_1524 = wp::where(var_1509, var_1522, var_1523);
            var_1525 = wp::int64(var_1524);
            var_1526 = wp::add(var_1481, var_1525);
            // sx += x                                                                        <L 36>
            var_1527 = wp::add(var_1482, var_1513);
            // sy += y                                                                        <L 37>
            var_1528 = wp::add(var_1483, var_1517);
            // sz += z                                                                        <L 38>
            var_1529 = wp::add(var_1484, var_1521);
            // xx += x * x                                                                    <L 39>
            var_1530 = wp::mul(var_1513, var_1513);
            var_1531 = wp::add(var_1486, var_1530);
            // xy += x * y                                                                    <L 40>
            var_1532 = wp::mul(var_1513, var_1517);
            var_1533 = wp::add(var_1488, var_1532);
            // xz += x * z                                                                    <L 41>
            var_1534 = wp::mul(var_1513, var_1521);
            var_1535 = wp::add(var_1490, var_1534);
            // yy += y * y                                                                    <L 42>
            var_1536 = wp::mul(var_1517, var_1517);
            var_1537 = wp::add(var_1492, var_1536);
            // yz += y * z                                                                    <L 43>
            var_1538 = wp::mul(var_1517, var_1521);
            var_1539 = wp::add(var_1494, var_1538);
            // zz += z * z                                                                    <L 44>
            var_1540 = wp::mul(var_1521, var_1521);
            var_1541 = wp::add(var_1496, var_1540);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_1543 = wp::extract(var_11, var_1542);
            var_1544 = wp::extract(var_11, var_1542);
            var_1545 = wp::mul(var_1543, var_1544);
            var_1546 = wp::extract(var_13, var_1542);
            var_1547 = wp::extract(var_13, var_1542);
            var_1548 = wp::mul(var_1546, var_1547);
            var_1549 = wp::add(var_1545, var_1548);
            var_1550 = wp::extract(var_15, var_1542);
            var_1551 = wp::extract(var_15, var_1542);
            var_1552 = wp::mul(var_1550, var_1551);
            var_1553 = wp::add(var_1549, var_1552);
            var_1554 = (var_1553 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_1554) {
                var_1555 = wp::extract(var_11, var_1542);
            }
            if (!var_1554) {
            }
            var_1557 = wp::where(var_1554, var_1555, var_1556);
            var_1558 = integer_steps_0(var_1557, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_1554) {
                var_1559 = wp::extract(var_13, var_1542);
            }
            if (!var_1554) {
            }
            var_1561 = wp::where(var_1554, var_1559, var_1560);
            var_1562 = integer_steps_0(var_1561, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_1554) {
                var_1563 = wp::extract(var_15, var_1542);
            }
            if (!var_1554) {
            }
            var_1565 = wp::where(var_1554, var_1563, var_1564);
            var_1566 = integer_steps_0(var_1565, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_1554) {
            }
            if (!var_1554) {
            }
            var_1569 = wp::where(var_1554, var_1567, var_1568);
            var_1570 = wp::int64(var_1569);
            var_1571 = wp::add(var_1526, var_1570);
            // sx += x                                                                        <L 36>
            var_1572 = wp::add(var_1527, var_1558);
            // sy += y                                                                        <L 37>
            var_1573 = wp::add(var_1528, var_1562);
            // sz += z                                                                        <L 38>
            var_1574 = wp::add(var_1529, var_1566);
            // xx += x * x                                                                    <L 39>
            var_1575 = wp::mul(var_1558, var_1558);
            var_1576 = wp::add(var_1531, var_1575);
            // xy += x * y                                                                    <L 40>
            var_1577 = wp::mul(var_1558, var_1562);
            var_1578 = wp::add(var_1533, var_1577);
            // xz += x * z                                                                    <L 41>
            var_1579 = wp::mul(var_1558, var_1566);
            var_1580 = wp::add(var_1535, var_1579);
            // yy += y * y                                                                    <L 42>
            var_1581 = wp::mul(var_1562, var_1562);
            var_1582 = wp::add(var_1537, var_1581);
            // yz += y * z                                                                    <L 43>
            var_1583 = wp::mul(var_1562, var_1566);
            var_1584 = wp::add(var_1539, var_1583);
            // zz += z * z                                                                    <L 44>
            var_1585 = wp::mul(var_1566, var_1566);
            var_1586 = wp::add(var_1541, var_1585);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_1588 = wp::extract(var_11, var_1587);
            var_1589 = wp::extract(var_11, var_1587);
            var_1590 = wp::mul(var_1588, var_1589);
            var_1591 = wp::extract(var_13, var_1587);
            var_1592 = wp::extract(var_13, var_1587);
            var_1593 = wp::mul(var_1591, var_1592);
            var_1594 = wp::add(var_1590, var_1593);
            var_1595 = wp::extract(var_15, var_1587);
            var_1596 = wp::extract(var_15, var_1587);
            var_1597 = wp::mul(var_1595, var_1596);
            var_1598 = wp::add(var_1594, var_1597);
            var_1599 = (var_1598 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_1599) {
                var_1600 = wp::extract(var_11, var_1587);
            }
            if (!var_1599) {
            }
            var_1602 = wp::where(var_1599, var_1600, var_1601);
            var_1603 = integer_steps_0(var_1602, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_1599) {
                var_1604 = wp::extract(var_13, var_1587);
            }
            if (!var_1599) {
            }
            var_1606 = wp::where(var_1599, var_1604, var_1605);
            var_1607 = integer_steps_0(var_1606, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_1599) {
                var_1608 = wp::extract(var_15, var_1587);
            }
            if (!var_1599) {
            }
            var_1610 = wp::where(var_1599, var_1608, var_1609);
            var_1611 = integer_steps_0(var_1610, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_1599) {
            }
            if (!var_1599) {
            }
            var_1614 = wp::where(var_1599, var_1612, var_1613);
            var_1615 = wp::int64(var_1614);
            var_1616 = wp::add(var_1571, var_1615);
            // sx += x                                                                        <L 36>
            var_1617 = wp::add(var_1572, var_1603);
            // sy += y                                                                        <L 37>
            var_1618 = wp::add(var_1573, var_1607);
            // sz += z                                                                        <L 38>
            var_1619 = wp::add(var_1574, var_1611);
            // xx += x * x                                                                    <L 39>
            var_1620 = wp::mul(var_1603, var_1603);
            var_1621 = wp::add(var_1576, var_1620);
            // xy += x * y                                                                    <L 40>
            var_1622 = wp::mul(var_1603, var_1607);
            var_1623 = wp::add(var_1578, var_1622);
            // xz += x * z                                                                    <L 41>
            var_1624 = wp::mul(var_1603, var_1611);
            var_1625 = wp::add(var_1580, var_1624);
            // yy += y * y                                                                    <L 42>
            var_1626 = wp::mul(var_1607, var_1607);
            var_1627 = wp::add(var_1582, var_1626);
            // yz += y * z                                                                    <L 43>
            var_1628 = wp::mul(var_1607, var_1611);
            var_1629 = wp::add(var_1584, var_1628);
            // zz += z * z                                                                    <L 44>
            var_1630 = wp::mul(var_1611, var_1611);
            var_1631 = wp::add(var_1586, var_1630);
        }
        var_1632 = wp::where(var_1108, var_1616, var_1089);
        var_1633 = wp::where(var_1108, var_1617, var_1090);
        var_1634 = wp::where(var_1108, var_1618, var_1091);
        var_1635 = wp::where(var_1108, var_1619, var_1092);
        var_1636 = wp::where(var_1108, var_1621, var_1093);
        var_1637 = wp::where(var_1108, var_1623, var_1094);
        var_1638 = wp::where(var_1108, var_1625, var_1095);
        var_1639 = wp::where(var_1108, var_1627, var_1096);
        var_1640 = wp::where(var_1108, var_1629, var_1097);
        var_1641 = wp::where(var_1108, var_1631, var_1098);
        var_1642 = wp::where(var_1108, var_1111, var_1099);
        var_1643 = wp::where(var_1108, var_1587, var_1100);
        var_1644 = wp::where(var_1108, var_1255, var_1101);
        var_1645 = wp::where(var_1108, var_1599, var_1102);
        var_1646 = wp::where(var_1108, var_1603, var_1103);
        var_1647 = wp::where(var_1108, var_1607, var_1104);
        var_1648 = wp::where(var_1108, var_1611, var_1105);
        // if distances__leaves_within__1[leaf__leaves_within__1] <= max_sqdist:              <L 23>
        var_1650 = wp::extract(var_24, var_1649);
        var_1651 = (var_1650 <= var_max_sqdist);
        if (var_1651) {
            // first = bucket__leaves_within__1 * BUCKET__leaves_within + leaf__leaves_within__1 * LEAF__leaves_within       <L 24>
            var_1652 = wp::mul(var_23, var_28);
            var_1653 = wp::mul(var_1649, var_30);
            var_1654 = wp::add(var_1652, var_1653);
            // for j in range(LEAF):                                                          <L 25>
            // q = tree__points[first + j]                                                    <L 26>
            var_1656 = wp::add(var_1654, var_1655);
            var_1657 = wp::address(var_tree__points, var_1656);
            var_1659 = wp::load(var_1657);
            var_1658 = wp::copy(var_1659);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_1661 = wp::extract(var_1658, var_1660);
            var_1663 = wp::extract(var_p, var_1662);
            var_1664 = wp::sub(var_1661, var_1663);
            wp::assign_inplace(var_11, var_1655, var_1664);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_1666 = wp::extract(var_1658, var_1665);
            var_1668 = wp::extract(var_p, var_1667);
            var_1669 = wp::sub(var_1666, var_1668);
            wp::assign_inplace(var_13, var_1655, var_1669);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_1671 = wp::extract(var_1658, var_1670);
            var_1673 = wp::extract(var_p, var_1672);
            var_1674 = wp::sub(var_1671, var_1673);
            wp::assign_inplace(var_15, var_1655, var_1674);
            // q = tree__points[first + j]                                                    <L 26>
            var_1676 = wp::add(var_1654, var_1675);
            var_1677 = wp::address(var_tree__points, var_1676);
            var_1679 = wp::load(var_1677);
            var_1678 = wp::copy(var_1679);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_1681 = wp::extract(var_1678, var_1680);
            var_1683 = wp::extract(var_p, var_1682);
            var_1684 = wp::sub(var_1681, var_1683);
            wp::assign_inplace(var_11, var_1675, var_1684);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_1686 = wp::extract(var_1678, var_1685);
            var_1688 = wp::extract(var_p, var_1687);
            var_1689 = wp::sub(var_1686, var_1688);
            wp::assign_inplace(var_13, var_1675, var_1689);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_1691 = wp::extract(var_1678, var_1690);
            var_1693 = wp::extract(var_p, var_1692);
            var_1694 = wp::sub(var_1691, var_1693);
            wp::assign_inplace(var_15, var_1675, var_1694);
            // q = tree__points[first + j]                                                    <L 26>
            var_1696 = wp::add(var_1654, var_1695);
            var_1697 = wp::address(var_tree__points, var_1696);
            var_1699 = wp::load(var_1697);
            var_1698 = wp::copy(var_1699);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_1701 = wp::extract(var_1698, var_1700);
            var_1703 = wp::extract(var_p, var_1702);
            var_1704 = wp::sub(var_1701, var_1703);
            wp::assign_inplace(var_11, var_1695, var_1704);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_1706 = wp::extract(var_1698, var_1705);
            var_1708 = wp::extract(var_p, var_1707);
            var_1709 = wp::sub(var_1706, var_1708);
            wp::assign_inplace(var_13, var_1695, var_1709);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_1711 = wp::extract(var_1698, var_1710);
            var_1713 = wp::extract(var_p, var_1712);
            var_1714 = wp::sub(var_1711, var_1713);
            wp::assign_inplace(var_15, var_1695, var_1714);
            // q = tree__points[first + j]                                                    <L 26>
            var_1716 = wp::add(var_1654, var_1715);
            var_1717 = wp::address(var_tree__points, var_1716);
            var_1719 = wp::load(var_1717);
            var_1718 = wp::copy(var_1719);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_1721 = wp::extract(var_1718, var_1720);
            var_1723 = wp::extract(var_p, var_1722);
            var_1724 = wp::sub(var_1721, var_1723);
            wp::assign_inplace(var_11, var_1715, var_1724);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_1726 = wp::extract(var_1718, var_1725);
            var_1728 = wp::extract(var_p, var_1727);
            var_1729 = wp::sub(var_1726, var_1728);
            wp::assign_inplace(var_13, var_1715, var_1729);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_1731 = wp::extract(var_1718, var_1730);
            var_1733 = wp::extract(var_p, var_1732);
            var_1734 = wp::sub(var_1731, var_1733);
            wp::assign_inplace(var_15, var_1715, var_1734);
            // q = tree__points[first + j]                                                    <L 26>
            var_1736 = wp::add(var_1654, var_1735);
            var_1737 = wp::address(var_tree__points, var_1736);
            var_1739 = wp::load(var_1737);
            var_1738 = wp::copy(var_1739);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_1741 = wp::extract(var_1738, var_1740);
            var_1743 = wp::extract(var_p, var_1742);
            var_1744 = wp::sub(var_1741, var_1743);
            wp::assign_inplace(var_11, var_1735, var_1744);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_1746 = wp::extract(var_1738, var_1745);
            var_1748 = wp::extract(var_p, var_1747);
            var_1749 = wp::sub(var_1746, var_1748);
            wp::assign_inplace(var_13, var_1735, var_1749);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_1751 = wp::extract(var_1738, var_1750);
            var_1753 = wp::extract(var_p, var_1752);
            var_1754 = wp::sub(var_1751, var_1753);
            wp::assign_inplace(var_15, var_1735, var_1754);
            // q = tree__points[first + j]                                                    <L 26>
            var_1756 = wp::add(var_1654, var_1755);
            var_1757 = wp::address(var_tree__points, var_1756);
            var_1759 = wp::load(var_1757);
            var_1758 = wp::copy(var_1759);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_1761 = wp::extract(var_1758, var_1760);
            var_1763 = wp::extract(var_p, var_1762);
            var_1764 = wp::sub(var_1761, var_1763);
            wp::assign_inplace(var_11, var_1755, var_1764);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_1766 = wp::extract(var_1758, var_1765);
            var_1768 = wp::extract(var_p, var_1767);
            var_1769 = wp::sub(var_1766, var_1768);
            wp::assign_inplace(var_13, var_1755, var_1769);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_1771 = wp::extract(var_1758, var_1770);
            var_1773 = wp::extract(var_p, var_1772);
            var_1774 = wp::sub(var_1771, var_1773);
            wp::assign_inplace(var_15, var_1755, var_1774);
            // q = tree__points[first + j]                                                    <L 26>
            var_1776 = wp::add(var_1654, var_1775);
            var_1777 = wp::address(var_tree__points, var_1776);
            var_1779 = wp::load(var_1777);
            var_1778 = wp::copy(var_1779);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_1781 = wp::extract(var_1778, var_1780);
            var_1783 = wp::extract(var_p, var_1782);
            var_1784 = wp::sub(var_1781, var_1783);
            wp::assign_inplace(var_11, var_1775, var_1784);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_1786 = wp::extract(var_1778, var_1785);
            var_1788 = wp::extract(var_p, var_1787);
            var_1789 = wp::sub(var_1786, var_1788);
            wp::assign_inplace(var_13, var_1775, var_1789);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_1791 = wp::extract(var_1778, var_1790);
            var_1793 = wp::extract(var_p, var_1792);
            var_1794 = wp::sub(var_1791, var_1793);
            wp::assign_inplace(var_15, var_1775, var_1794);
            // q = tree__points[first + j]                                                    <L 26>
            var_1796 = wp::add(var_1654, var_1795);
            var_1797 = wp::address(var_tree__points, var_1796);
            var_1799 = wp::load(var_1797);
            var_1798 = wp::copy(var_1799);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_1801 = wp::extract(var_1798, var_1800);
            var_1803 = wp::extract(var_p, var_1802);
            var_1804 = wp::sub(var_1801, var_1803);
            wp::assign_inplace(var_11, var_1795, var_1804);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_1806 = wp::extract(var_1798, var_1805);
            var_1808 = wp::extract(var_p, var_1807);
            var_1809 = wp::sub(var_1806, var_1808);
            wp::assign_inplace(var_13, var_1795, var_1809);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_1811 = wp::extract(var_1798, var_1810);
            var_1813 = wp::extract(var_p, var_1812);
            var_1814 = wp::sub(var_1811, var_1813);
            wp::assign_inplace(var_15, var_1795, var_1814);
            // for j in range(LEAF):                                                          <L 30>
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_1816 = wp::extract(var_11, var_1815);
            var_1817 = wp::extract(var_11, var_1815);
            var_1818 = wp::mul(var_1816, var_1817);
            var_1819 = wp::extract(var_13, var_1815);
            var_1820 = wp::extract(var_13, var_1815);
            var_1821 = wp::mul(var_1819, var_1820);
            var_1822 = wp::add(var_1818, var_1821);
            var_1823 = wp::extract(var_15, var_1815);
            var_1824 = wp::extract(var_15, var_1815);
            var_1825 = wp::mul(var_1823, var_1824);
            var_1826 = wp::add(var_1822, var_1825);
            var_1827 = (var_1826 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_1827) {
                var_1828 = wp::extract(var_11, var_1815);
            }
            if (!var_1827) {
            }
            var_1830 = wp::where(var_1827, var_1828, var_1829);
            var_1831 = integer_steps_0(var_1830, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_1827) {
                var_1832 = wp::extract(var_13, var_1815);
            }
            if (!var_1827) {
            }
            var_1834 = wp::where(var_1827, var_1832, var_1833);
            var_1835 = integer_steps_0(var_1834, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_1827) {
                var_1836 = wp::extract(var_15, var_1815);
            }
            if (!var_1827) {
            }
            var_1838 = wp::where(var_1827, var_1836, var_1837);
            var_1839 = integer_steps_0(var_1838, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_1827) {
            }
            if (!var_1827) {
            }
            var_1842 = wp::where(var_1827, var_1840, var_1841);
            var_1843 = wp::int64(var_1842);
            var_1844 = wp::add(var_1632, var_1843);
            // sx += x                                                                        <L 36>
            var_1845 = wp::add(var_1633, var_1831);
            // sy += y                                                                        <L 37>
            var_1846 = wp::add(var_1634, var_1835);
            // sz += z                                                                        <L 38>
            var_1847 = wp::add(var_1635, var_1839);
            // xx += x * x                                                                    <L 39>
            var_1848 = wp::mul(var_1831, var_1831);
            var_1849 = wp::add(var_1636, var_1848);
            // xy += x * y                                                                    <L 40>
            var_1850 = wp::mul(var_1831, var_1835);
            var_1851 = wp::add(var_1637, var_1850);
            // xz += x * z                                                                    <L 41>
            var_1852 = wp::mul(var_1831, var_1839);
            var_1853 = wp::add(var_1638, var_1852);
            // yy += y * y                                                                    <L 42>
            var_1854 = wp::mul(var_1835, var_1835);
            var_1855 = wp::add(var_1639, var_1854);
            // yz += y * z                                                                    <L 43>
            var_1856 = wp::mul(var_1835, var_1839);
            var_1857 = wp::add(var_1640, var_1856);
            // zz += z * z                                                                    <L 44>
            var_1858 = wp::mul(var_1839, var_1839);
            var_1859 = wp::add(var_1641, var_1858);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_1861 = wp::extract(var_11, var_1860);
            var_1862 = wp::extract(var_11, var_1860);
            var_1863 = wp::mul(var_1861, var_1862);
            var_1864 = wp::extract(var_13, var_1860);
            var_1865 = wp::extract(var_13, var_1860);
            var_1866 = wp::mul(var_1864, var_1865);
            var_1867 = wp::add(var_1863, var_1866);
            var_1868 = wp::extract(var_15, var_1860);
            var_1869 = wp::extract(var_15, var_1860);
            var_1870 = wp::mul(var_1868, var_1869);
            var_1871 = wp::add(var_1867, var_1870);
            var_1872 = (var_1871 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_1872) {
                var_1873 = wp::extract(var_11, var_1860);
            }
            if (!var_1872) {
            }
            var_1875 = wp::where(var_1872, var_1873, var_1874);
            var_1876 = integer_steps_0(var_1875, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_1872) {
                var_1877 = wp::extract(var_13, var_1860);
            }
            if (!var_1872) {
            }
            var_1879 = wp::where(var_1872, var_1877, var_1878);
            var_1880 = integer_steps_0(var_1879, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_1872) {
                var_1881 = wp::extract(var_15, var_1860);
            }
            if (!var_1872) {
            }
            var_1883 = wp::where(var_1872, var_1881, var_1882);
            var_1884 = integer_steps_0(var_1883, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_1872) {
            }
            if (!var_1872) {
            }
            var_1887 = wp::where(var_1872, var_1885, var_1886);
            var_1888 = wp::int64(var_1887);
            var_1889 = wp::add(var_1844, var_1888);
            // sx += x                                                                        <L 36>
            var_1890 = wp::add(var_1845, var_1876);
            // sy += y                                                                        <L 37>
            var_1891 = wp::add(var_1846, var_1880);
            // sz += z                                                                        <L 38>
            var_1892 = wp::add(var_1847, var_1884);
            // xx += x * x                                                                    <L 39>
            var_1893 = wp::mul(var_1876, var_1876);
            var_1894 = wp::add(var_1849, var_1893);
            // xy += x * y                                                                    <L 40>
            var_1895 = wp::mul(var_1876, var_1880);
            var_1896 = wp::add(var_1851, var_1895);
            // xz += x * z                                                                    <L 41>
            var_1897 = wp::mul(var_1876, var_1884);
            var_1898 = wp::add(var_1853, var_1897);
            // yy += y * y                                                                    <L 42>
            var_1899 = wp::mul(var_1880, var_1880);
            var_1900 = wp::add(var_1855, var_1899);
            // yz += y * z                                                                    <L 43>
            var_1901 = wp::mul(var_1880, var_1884);
            var_1902 = wp::add(var_1857, var_1901);
            // zz += z * z                                                                    <L 44>
            var_1903 = wp::mul(var_1884, var_1884);
            var_1904 = wp::add(var_1859, var_1903);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_1906 = wp::extract(var_11, var_1905);
            var_1907 = wp::extract(var_11, var_1905);
            var_1908 = wp::mul(var_1906, var_1907);
            var_1909 = wp::extract(var_13, var_1905);
            var_1910 = wp::extract(var_13, var_1905);
            var_1911 = wp::mul(var_1909, var_1910);
            var_1912 = wp::add(var_1908, var_1911);
            var_1913 = wp::extract(var_15, var_1905);
            var_1914 = wp::extract(var_15, var_1905);
            var_1915 = wp::mul(var_1913, var_1914);
            var_1916 = wp::add(var_1912, var_1915);
            var_1917 = (var_1916 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_1917) {
                var_1918 = wp::extract(var_11, var_1905);
            }
            if (!var_1917) {
            }
            var_1920 = wp::where(var_1917, var_1918, var_1919);
            var_1921 = integer_steps_0(var_1920, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_1917) {
                var_1922 = wp::extract(var_13, var_1905);
            }
            if (!var_1917) {
            }
            var_1924 = wp::where(var_1917, var_1922, var_1923);
            var_1925 = integer_steps_0(var_1924, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_1917) {
                var_1926 = wp::extract(var_15, var_1905);
            }
            if (!var_1917) {
            }
            var_1928 = wp::where(var_1917, var_1926, var_1927);
            var_1929 = integer_steps_0(var_1928, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_1917) {
            }
            if (!var_1917) {
            }
            var_1932 = wp::where(var_1917, var_1930, var_1931);
            var_1933 = wp::int64(var_1932);
            var_1934 = wp::add(var_1889, var_1933);
            // sx += x                                                                        <L 36>
            var_1935 = wp::add(var_1890, var_1921);
            // sy += y                                                                        <L 37>
            var_1936 = wp::add(var_1891, var_1925);
            // sz += z                                                                        <L 38>
            var_1937 = wp::add(var_1892, var_1929);
            // xx += x * x                                                                    <L 39>
            var_1938 = wp::mul(var_1921, var_1921);
            var_1939 = wp::add(var_1894, var_1938);
            // xy += x * y                                                                    <L 40>
            var_1940 = wp::mul(var_1921, var_1925);
            var_1941 = wp::add(var_1896, var_1940);
            // xz += x * z                                                                    <L 41>
            var_1942 = wp::mul(var_1921, var_1929);
            var_1943 = wp::add(var_1898, var_1942);
            // yy += y * y                                                                    <L 42>
            var_1944 = wp::mul(var_1925, var_1925);
            var_1945 = wp::add(var_1900, var_1944);
            // yz += y * z                                                                    <L 43>
            var_1946 = wp::mul(var_1925, var_1929);
            var_1947 = wp::add(var_1902, var_1946);
            // zz += z * z                                                                    <L 44>
            var_1948 = wp::mul(var_1929, var_1929);
            var_1949 = wp::add(var_1904, var_1948);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_1951 = wp::extract(var_11, var_1950);
            var_1952 = wp::extract(var_11, var_1950);
            var_1953 = wp::mul(var_1951, var_1952);
            var_1954 = wp::extract(var_13, var_1950);
            var_1955 = wp::extract(var_13, var_1950);
            var_1956 = wp::mul(var_1954, var_1955);
            var_1957 = wp::add(var_1953, var_1956);
            var_1958 = wp::extract(var_15, var_1950);
            var_1959 = wp::extract(var_15, var_1950);
            var_1960 = wp::mul(var_1958, var_1959);
            var_1961 = wp::add(var_1957, var_1960);
            var_1962 = (var_1961 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_1962) {
                var_1963 = wp::extract(var_11, var_1950);
            }
            if (!var_1962) {
            }
            var_1965 = wp::where(var_1962, var_1963, var_1964);
            var_1966 = integer_steps_0(var_1965, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_1962) {
                var_1967 = wp::extract(var_13, var_1950);
            }
            if (!var_1962) {
            }
            var_1969 = wp::where(var_1962, var_1967, var_1968);
            var_1970 = integer_steps_0(var_1969, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_1962) {
                var_1971 = wp::extract(var_15, var_1950);
            }
            if (!var_1962) {
            }
            var_1973 = wp::where(var_1962, var_1971, var_1972);
            var_1974 = integer_steps_0(var_1973, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_1962) {
            }
            if (!var_1962) {
            }
            var_1977 = wp::where(var_1962, var_1975, var_1976);
            var_1978 = wp::int64(var_1977);
            var_1979 = wp::add(var_1934, var_1978);
            // sx += x                                                                        <L 36>
            var_1980 = wp::add(var_1935, var_1966);
            // sy += y                                                                        <L 37>
            var_1981 = wp::add(var_1936, var_1970);
            // sz += z                                                                        <L 38>
            var_1982 = wp::add(var_1937, var_1974);
            // xx += x * x                                                                    <L 39>
            var_1983 = wp::mul(var_1966, var_1966);
            var_1984 = wp::add(var_1939, var_1983);
            // xy += x * y                                                                    <L 40>
            var_1985 = wp::mul(var_1966, var_1970);
            var_1986 = wp::add(var_1941, var_1985);
            // xz += x * z                                                                    <L 41>
            var_1987 = wp::mul(var_1966, var_1974);
            var_1988 = wp::add(var_1943, var_1987);
            // yy += y * y                                                                    <L 42>
            var_1989 = wp::mul(var_1970, var_1970);
            var_1990 = wp::add(var_1945, var_1989);
            // yz += y * z                                                                    <L 43>
            var_1991 = wp::mul(var_1970, var_1974);
            var_1992 = wp::add(var_1947, var_1991);
            // zz += z * z                                                                    <L 44>
            var_1993 = wp::mul(var_1974, var_1974);
            var_1994 = wp::add(var_1949, var_1993);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_1996 = wp::extract(var_11, var_1995);
            var_1997 = wp::extract(var_11, var_1995);
            var_1998 = wp::mul(var_1996, var_1997);
            var_1999 = wp::extract(var_13, var_1995);
            var_2000 = wp::extract(var_13, var_1995);
            var_2001 = wp::mul(var_1999, var_2000);
            var_2002 = wp::add(var_1998, var_2001);
            var_2003 = wp::extract(var_15, var_1995);
            var_2004 = wp::extract(var_15, var_1995);
            var_2005 = wp::mul(var_2003, var_2004);
            var_2006 = wp::add(var_2002, var_2005);
            var_2007 = (var_2006 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_2007) {
                var_2008 = wp::extract(var_11, var_1995);
            }
            if (!var_2007) {
            }
            var_2010 = wp::where(var_2007, var_2008, var_2009);
            var_2011 = integer_steps_0(var_2010, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_2007) {
                var_2012 = wp::extract(var_13, var_1995);
            }
            if (!var_2007) {
            }
            var_2014 = wp::where(var_2007, var_2012, var_2013);
            var_2015 = integer_steps_0(var_2014, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_2007) {
                var_2016 = wp::extract(var_15, var_1995);
            }
            if (!var_2007) {
            }
            var_2018 = wp::where(var_2007, var_2016, var_2017);
            var_2019 = integer_steps_0(var_2018, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_2007) {
            }
            if (!var_2007) {
            }
            var_2022 = wp::where(var_2007, var_2020, var_2021);
            var_2023 = wp::int64(var_2022);
            var_2024 = wp::add(var_1979, var_2023);
            // sx += x                                                                        <L 36>
            var_2025 = wp::add(var_1980, var_2011);
            // sy += y                                                                        <L 37>
            var_2026 = wp::add(var_1981, var_2015);
            // sz += z                                                                        <L 38>
            var_2027 = wp::add(var_1982, var_2019);
            // xx += x * x                                                                    <L 39>
            var_2028 = wp::mul(var_2011, var_2011);
            var_2029 = wp::add(var_1984, var_2028);
            // xy += x * y                                                                    <L 40>
            var_2030 = wp::mul(var_2011, var_2015);
            var_2031 = wp::add(var_1986, var_2030);
            // xz += x * z                                                                    <L 41>
            var_2032 = wp::mul(var_2011, var_2019);
            var_2033 = wp::add(var_1988, var_2032);
            // yy += y * y                                                                    <L 42>
            var_2034 = wp::mul(var_2015, var_2015);
            var_2035 = wp::add(var_1990, var_2034);
            // yz += y * z                                                                    <L 43>
            var_2036 = wp::mul(var_2015, var_2019);
            var_2037 = wp::add(var_1992, var_2036);
            // zz += z * z                                                                    <L 44>
            var_2038 = wp::mul(var_2019, var_2019);
            var_2039 = wp::add(var_1994, var_2038);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_2041 = wp::extract(var_11, var_2040);
            var_2042 = wp::extract(var_11, var_2040);
            var_2043 = wp::mul(var_2041, var_2042);
            var_2044 = wp::extract(var_13, var_2040);
            var_2045 = wp::extract(var_13, var_2040);
            var_2046 = wp::mul(var_2044, var_2045);
            var_2047 = wp::add(var_2043, var_2046);
            var_2048 = wp::extract(var_15, var_2040);
            var_2049 = wp::extract(var_15, var_2040);
            var_2050 = wp::mul(var_2048, var_2049);
            var_2051 = wp::add(var_2047, var_2050);
            var_2052 = (var_2051 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_2052) {
                var_2053 = wp::extract(var_11, var_2040);
            }
            if (!var_2052) {
            }
            var_2055 = wp::where(var_2052, var_2053, var_2054);
            var_2056 = integer_steps_0(var_2055, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_2052) {
                var_2057 = wp::extract(var_13, var_2040);
            }
            if (!var_2052) {
            }
            var_2059 = wp::where(var_2052, var_2057, var_2058);
            var_2060 = integer_steps_0(var_2059, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_2052) {
                var_2061 = wp::extract(var_15, var_2040);
            }
            if (!var_2052) {
            }
            var_2063 = wp::where(var_2052, var_2061, var_2062);
            var_2064 = integer_steps_0(var_2063, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_2052) {
            }
            if (!var_2052) {
            }
            var_2067 = wp::where(var_2052, var_2065, var_2066);
            var_2068 = wp::int64(var_2067);
            var_2069 = wp::add(var_2024, var_2068);
            // sx += x                                                                        <L 36>
            var_2070 = wp::add(var_2025, var_2056);
            // sy += y                                                                        <L 37>
            var_2071 = wp::add(var_2026, var_2060);
            // sz += z                                                                        <L 38>
            var_2072 = wp::add(var_2027, var_2064);
            // xx += x * x                                                                    <L 39>
            var_2073 = wp::mul(var_2056, var_2056);
            var_2074 = wp::add(var_2029, var_2073);
            // xy += x * y                                                                    <L 40>
            var_2075 = wp::mul(var_2056, var_2060);
            var_2076 = wp::add(var_2031, var_2075);
            // xz += x * z                                                                    <L 41>
            var_2077 = wp::mul(var_2056, var_2064);
            var_2078 = wp::add(var_2033, var_2077);
            // yy += y * y                                                                    <L 42>
            var_2079 = wp::mul(var_2060, var_2060);
            var_2080 = wp::add(var_2035, var_2079);
            // yz += y * z                                                                    <L 43>
            var_2081 = wp::mul(var_2060, var_2064);
            var_2082 = wp::add(var_2037, var_2081);
            // zz += z * z                                                                    <L 44>
            var_2083 = wp::mul(var_2064, var_2064);
            var_2084 = wp::add(var_2039, var_2083);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_2086 = wp::extract(var_11, var_2085);
            var_2087 = wp::extract(var_11, var_2085);
            var_2088 = wp::mul(var_2086, var_2087);
            var_2089 = wp::extract(var_13, var_2085);
            var_2090 = wp::extract(var_13, var_2085);
            var_2091 = wp::mul(var_2089, var_2090);
            var_2092 = wp::add(var_2088, var_2091);
            var_2093 = wp::extract(var_15, var_2085);
            var_2094 = wp::extract(var_15, var_2085);
            var_2095 = wp::mul(var_2093, var_2094);
            var_2096 = wp::add(var_2092, var_2095);
            var_2097 = (var_2096 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_2097) {
                var_2098 = wp::extract(var_11, var_2085);
            }
            if (!var_2097) {
            }
            var_2100 = wp::where(var_2097, var_2098, var_2099);
            var_2101 = integer_steps_0(var_2100, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_2097) {
                var_2102 = wp::extract(var_13, var_2085);
            }
            if (!var_2097) {
            }
            var_2104 = wp::where(var_2097, var_2102, var_2103);
            var_2105 = integer_steps_0(var_2104, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_2097) {
                var_2106 = wp::extract(var_15, var_2085);
            }
            if (!var_2097) {
            }
            var_2108 = wp::where(var_2097, var_2106, var_2107);
            var_2109 = integer_steps_0(var_2108, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_2097) {
            }
            if (!var_2097) {
            }
            var_2112 = wp::where(var_2097, var_2110, var_2111);
            var_2113 = wp::int64(var_2112);
            var_2114 = wp::add(var_2069, var_2113);
            // sx += x                                                                        <L 36>
            var_2115 = wp::add(var_2070, var_2101);
            // sy += y                                                                        <L 37>
            var_2116 = wp::add(var_2071, var_2105);
            // sz += z                                                                        <L 38>
            var_2117 = wp::add(var_2072, var_2109);
            // xx += x * x                                                                    <L 39>
            var_2118 = wp::mul(var_2101, var_2101);
            var_2119 = wp::add(var_2074, var_2118);
            // xy += x * y                                                                    <L 40>
            var_2120 = wp::mul(var_2101, var_2105);
            var_2121 = wp::add(var_2076, var_2120);
            // xz += x * z                                                                    <L 41>
            var_2122 = wp::mul(var_2101, var_2109);
            var_2123 = wp::add(var_2078, var_2122);
            // yy += y * y                                                                    <L 42>
            var_2124 = wp::mul(var_2105, var_2105);
            var_2125 = wp::add(var_2080, var_2124);
            // yz += y * z                                                                    <L 43>
            var_2126 = wp::mul(var_2105, var_2109);
            var_2127 = wp::add(var_2082, var_2126);
            // zz += z * z                                                                    <L 44>
            var_2128 = wp::mul(var_2109, var_2109);
            var_2129 = wp::add(var_2084, var_2128);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_2131 = wp::extract(var_11, var_2130);
            var_2132 = wp::extract(var_11, var_2130);
            var_2133 = wp::mul(var_2131, var_2132);
            var_2134 = wp::extract(var_13, var_2130);
            var_2135 = wp::extract(var_13, var_2130);
            var_2136 = wp::mul(var_2134, var_2135);
            var_2137 = wp::add(var_2133, var_2136);
            var_2138 = wp::extract(var_15, var_2130);
            var_2139 = wp::extract(var_15, var_2130);
            var_2140 = wp::mul(var_2138, var_2139);
            var_2141 = wp::add(var_2137, var_2140);
            var_2142 = (var_2141 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_2142) {
                var_2143 = wp::extract(var_11, var_2130);
            }
            if (!var_2142) {
            }
            var_2145 = wp::where(var_2142, var_2143, var_2144);
            var_2146 = integer_steps_0(var_2145, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_2142) {
                var_2147 = wp::extract(var_13, var_2130);
            }
            if (!var_2142) {
            }
            var_2149 = wp::where(var_2142, var_2147, var_2148);
            var_2150 = integer_steps_0(var_2149, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_2142) {
                var_2151 = wp::extract(var_15, var_2130);
            }
            if (!var_2142) {
            }
            var_2153 = wp::where(var_2142, var_2151, var_2152);
            var_2154 = integer_steps_0(var_2153, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_2142) {
            }
            if (!var_2142) {
            }
            var_2157 = wp::where(var_2142, var_2155, var_2156);
            var_2158 = wp::int64(var_2157);
            var_2159 = wp::add(var_2114, var_2158);
            // sx += x                                                                        <L 36>
            var_2160 = wp::add(var_2115, var_2146);
            // sy += y                                                                        <L 37>
            var_2161 = wp::add(var_2116, var_2150);
            // sz += z                                                                        <L 38>
            var_2162 = wp::add(var_2117, var_2154);
            // xx += x * x                                                                    <L 39>
            var_2163 = wp::mul(var_2146, var_2146);
            var_2164 = wp::add(var_2119, var_2163);
            // xy += x * y                                                                    <L 40>
            var_2165 = wp::mul(var_2146, var_2150);
            var_2166 = wp::add(var_2121, var_2165);
            // xz += x * z                                                                    <L 41>
            var_2167 = wp::mul(var_2146, var_2154);
            var_2168 = wp::add(var_2123, var_2167);
            // yy += y * y                                                                    <L 42>
            var_2169 = wp::mul(var_2150, var_2150);
            var_2170 = wp::add(var_2125, var_2169);
            // yz += y * z                                                                    <L 43>
            var_2171 = wp::mul(var_2150, var_2154);
            var_2172 = wp::add(var_2127, var_2171);
            // zz += z * z                                                                    <L 44>
            var_2173 = wp::mul(var_2154, var_2154);
            var_2174 = wp::add(var_2129, var_2173);
        }
        var_2175 = wp::where(var_1651, var_2159, var_1632);
        var_2176 = wp::where(var_1651, var_2160, var_1633);
        var_2177 = wp::where(var_1651, var_2161, var_1634);
        var_2178 = wp::where(var_1651, var_2162, var_1635);
        var_2179 = wp::where(var_1651, var_2164, var_1636);
        var_2180 = wp::where(var_1651, var_2166, var_1637);
        var_2181 = wp::where(var_1651, var_2168, var_1638);
        var_2182 = wp::where(var_1651, var_2170, var_1639);
        var_2183 = wp::where(var_1651, var_2172, var_1640);
        var_2184 = wp::where(var_1651, var_2174, var_1641);
        var_2185 = wp::where(var_1651, var_1654, var_1642);
        var_2186 = wp::where(var_1651, var_2130, var_1643);
        var_2187 = wp::where(var_1651, var_1798, var_1644);
        var_2188 = wp::where(var_1651, var_2142, var_1645);
        var_2189 = wp::where(var_1651, var_2146, var_1646);
        var_2190 = wp::where(var_1651, var_2150, var_1647);
        var_2191 = wp::where(var_1651, var_2154, var_1648);
        // if distances__leaves_within__1[leaf__leaves_within__1] <= max_sqdist:              <L 23>
        var_2193 = wp::extract(var_24, var_2192);
        var_2194 = (var_2193 <= var_max_sqdist);
        if (var_2194) {
            // first = bucket__leaves_within__1 * BUCKET__leaves_within + leaf__leaves_within__1 * LEAF__leaves_within       <L 24>
            var_2195 = wp::mul(var_23, var_28);
            var_2196 = wp::mul(var_2192, var_30);
            var_2197 = wp::add(var_2195, var_2196);
            // for j in range(LEAF):                                                          <L 25>
            // q = tree__points[first + j]                                                    <L 26>
            var_2199 = wp::add(var_2197, var_2198);
            var_2200 = wp::address(var_tree__points, var_2199);
            var_2202 = wp::load(var_2200);
            var_2201 = wp::copy(var_2202);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_2204 = wp::extract(var_2201, var_2203);
            var_2206 = wp::extract(var_p, var_2205);
            var_2207 = wp::sub(var_2204, var_2206);
            wp::assign_inplace(var_11, var_2198, var_2207);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_2209 = wp::extract(var_2201, var_2208);
            var_2211 = wp::extract(var_p, var_2210);
            var_2212 = wp::sub(var_2209, var_2211);
            wp::assign_inplace(var_13, var_2198, var_2212);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_2214 = wp::extract(var_2201, var_2213);
            var_2216 = wp::extract(var_p, var_2215);
            var_2217 = wp::sub(var_2214, var_2216);
            wp::assign_inplace(var_15, var_2198, var_2217);
            // q = tree__points[first + j]                                                    <L 26>
            var_2219 = wp::add(var_2197, var_2218);
            var_2220 = wp::address(var_tree__points, var_2219);
            var_2222 = wp::load(var_2220);
            var_2221 = wp::copy(var_2222);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_2224 = wp::extract(var_2221, var_2223);
            var_2226 = wp::extract(var_p, var_2225);
            var_2227 = wp::sub(var_2224, var_2226);
            wp::assign_inplace(var_11, var_2218, var_2227);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_2229 = wp::extract(var_2221, var_2228);
            var_2231 = wp::extract(var_p, var_2230);
            var_2232 = wp::sub(var_2229, var_2231);
            wp::assign_inplace(var_13, var_2218, var_2232);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_2234 = wp::extract(var_2221, var_2233);
            var_2236 = wp::extract(var_p, var_2235);
            var_2237 = wp::sub(var_2234, var_2236);
            wp::assign_inplace(var_15, var_2218, var_2237);
            // q = tree__points[first + j]                                                    <L 26>
            var_2239 = wp::add(var_2197, var_2238);
            var_2240 = wp::address(var_tree__points, var_2239);
            var_2242 = wp::load(var_2240);
            var_2241 = wp::copy(var_2242);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_2244 = wp::extract(var_2241, var_2243);
            var_2246 = wp::extract(var_p, var_2245);
            var_2247 = wp::sub(var_2244, var_2246);
            wp::assign_inplace(var_11, var_2238, var_2247);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_2249 = wp::extract(var_2241, var_2248);
            var_2251 = wp::extract(var_p, var_2250);
            var_2252 = wp::sub(var_2249, var_2251);
            wp::assign_inplace(var_13, var_2238, var_2252);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_2254 = wp::extract(var_2241, var_2253);
            var_2256 = wp::extract(var_p, var_2255);
            var_2257 = wp::sub(var_2254, var_2256);
            wp::assign_inplace(var_15, var_2238, var_2257);
            // q = tree__points[first + j]                                                    <L 26>
            var_2259 = wp::add(var_2197, var_2258);
            var_2260 = wp::address(var_tree__points, var_2259);
            var_2262 = wp::load(var_2260);
            var_2261 = wp::copy(var_2262);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_2264 = wp::extract(var_2261, var_2263);
            var_2266 = wp::extract(var_p, var_2265);
            var_2267 = wp::sub(var_2264, var_2266);
            wp::assign_inplace(var_11, var_2258, var_2267);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_2269 = wp::extract(var_2261, var_2268);
            var_2271 = wp::extract(var_p, var_2270);
            var_2272 = wp::sub(var_2269, var_2271);
            wp::assign_inplace(var_13, var_2258, var_2272);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_2274 = wp::extract(var_2261, var_2273);
            var_2276 = wp::extract(var_p, var_2275);
            var_2277 = wp::sub(var_2274, var_2276);
            wp::assign_inplace(var_15, var_2258, var_2277);
            // q = tree__points[first + j]                                                    <L 26>
            var_2279 = wp::add(var_2197, var_2278);
            var_2280 = wp::address(var_tree__points, var_2279);
            var_2282 = wp::load(var_2280);
            var_2281 = wp::copy(var_2282);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_2284 = wp::extract(var_2281, var_2283);
            var_2286 = wp::extract(var_p, var_2285);
            var_2287 = wp::sub(var_2284, var_2286);
            wp::assign_inplace(var_11, var_2278, var_2287);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_2289 = wp::extract(var_2281, var_2288);
            var_2291 = wp::extract(var_p, var_2290);
            var_2292 = wp::sub(var_2289, var_2291);
            wp::assign_inplace(var_13, var_2278, var_2292);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_2294 = wp::extract(var_2281, var_2293);
            var_2296 = wp::extract(var_p, var_2295);
            var_2297 = wp::sub(var_2294, var_2296);
            wp::assign_inplace(var_15, var_2278, var_2297);
            // q = tree__points[first + j]                                                    <L 26>
            var_2299 = wp::add(var_2197, var_2298);
            var_2300 = wp::address(var_tree__points, var_2299);
            var_2302 = wp::load(var_2300);
            var_2301 = wp::copy(var_2302);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_2304 = wp::extract(var_2301, var_2303);
            var_2306 = wp::extract(var_p, var_2305);
            var_2307 = wp::sub(var_2304, var_2306);
            wp::assign_inplace(var_11, var_2298, var_2307);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_2309 = wp::extract(var_2301, var_2308);
            var_2311 = wp::extract(var_p, var_2310);
            var_2312 = wp::sub(var_2309, var_2311);
            wp::assign_inplace(var_13, var_2298, var_2312);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_2314 = wp::extract(var_2301, var_2313);
            var_2316 = wp::extract(var_p, var_2315);
            var_2317 = wp::sub(var_2314, var_2316);
            wp::assign_inplace(var_15, var_2298, var_2317);
            // q = tree__points[first + j]                                                    <L 26>
            var_2319 = wp::add(var_2197, var_2318);
            var_2320 = wp::address(var_tree__points, var_2319);
            var_2322 = wp::load(var_2320);
            var_2321 = wp::copy(var_2322);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_2324 = wp::extract(var_2321, var_2323);
            var_2326 = wp::extract(var_p, var_2325);
            var_2327 = wp::sub(var_2324, var_2326);
            wp::assign_inplace(var_11, var_2318, var_2327);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_2329 = wp::extract(var_2321, var_2328);
            var_2331 = wp::extract(var_p, var_2330);
            var_2332 = wp::sub(var_2329, var_2331);
            wp::assign_inplace(var_13, var_2318, var_2332);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_2334 = wp::extract(var_2321, var_2333);
            var_2336 = wp::extract(var_p, var_2335);
            var_2337 = wp::sub(var_2334, var_2336);
            wp::assign_inplace(var_15, var_2318, var_2337);
            // q = tree__points[first + j]                                                    <L 26>
            var_2339 = wp::add(var_2197, var_2338);
            var_2340 = wp::address(var_tree__points, var_2339);
            var_2342 = wp::load(var_2340);
            var_2341 = wp::copy(var_2342);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_2344 = wp::extract(var_2341, var_2343);
            var_2346 = wp::extract(var_p, var_2345);
            var_2347 = wp::sub(var_2344, var_2346);
            wp::assign_inplace(var_11, var_2338, var_2347);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_2349 = wp::extract(var_2341, var_2348);
            var_2351 = wp::extract(var_p, var_2350);
            var_2352 = wp::sub(var_2349, var_2351);
            wp::assign_inplace(var_13, var_2338, var_2352);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_2354 = wp::extract(var_2341, var_2353);
            var_2356 = wp::extract(var_p, var_2355);
            var_2357 = wp::sub(var_2354, var_2356);
            wp::assign_inplace(var_15, var_2338, var_2357);
            // for j in range(LEAF):                                                          <L 30>
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_2359 = wp::extract(var_11, var_2358);
            var_2360 = wp::extract(var_11, var_2358);
            var_2361 = wp::mul(var_2359, var_2360);
            var_2362 = wp::extract(var_13, var_2358);
            var_2363 = wp::extract(var_13, var_2358);
            var_2364 = wp::mul(var_2362, var_2363);
            var_2365 = wp::add(var_2361, var_2364);
            var_2366 = wp::extract(var_15, var_2358);
            var_2367 = wp::extract(var_15, var_2358);
            var_2368 = wp::mul(var_2366, var_2367);
            var_2369 = wp::add(var_2365, var_2368);
            var_2370 = (var_2369 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_2370) {
                var_2371 = wp::extract(var_11, var_2358);
            }
            if (!var_2370) {
            }
            var_2373 = wp::where(var_2370, var_2371, var_2372);
            var_2374 = integer_steps_0(var_2373, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_2370) {
                var_2375 = wp::extract(var_13, var_2358);
            }
            if (!var_2370) {
            }
            var_2377 = wp::where(var_2370, var_2375, var_2376);
            var_2378 = integer_steps_0(var_2377, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_2370) {
                var_2379 = wp::extract(var_15, var_2358);
            }
            if (!var_2370) {
            }
            var_2381 = wp::where(var_2370, var_2379, var_2380);
            var_2382 = integer_steps_0(var_2381, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_2370) {
            }
            if (!var_2370) {
            }
            var_2385 = wp::where(var_2370, var_2383, var_2384);
            var_2386 = wp::int64(var_2385);
            var_2387 = wp::add(var_2175, var_2386);
            // sx += x                                                                        <L 36>
            var_2388 = wp::add(var_2176, var_2374);
            // sy += y                                                                        <L 37>
            var_2389 = wp::add(var_2177, var_2378);
            // sz += z                                                                        <L 38>
            var_2390 = wp::add(var_2178, var_2382);
            // xx += x * x                                                                    <L 39>
            var_2391 = wp::mul(var_2374, var_2374);
            var_2392 = wp::add(var_2179, var_2391);
            // xy += x * y                                                                    <L 40>
            var_2393 = wp::mul(var_2374, var_2378);
            var_2394 = wp::add(var_2180, var_2393);
            // xz += x * z                                                                    <L 41>
            var_2395 = wp::mul(var_2374, var_2382);
            var_2396 = wp::add(var_2181, var_2395);
            // yy += y * y                                                                    <L 42>
            var_2397 = wp::mul(var_2378, var_2378);
            var_2398 = wp::add(var_2182, var_2397);
            // yz += y * z                                                                    <L 43>
            var_2399 = wp::mul(var_2378, var_2382);
            var_2400 = wp::add(var_2183, var_2399);
            // zz += z * z                                                                    <L 44>
            var_2401 = wp::mul(var_2382, var_2382);
            var_2402 = wp::add(var_2184, var_2401);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_2404 = wp::extract(var_11, var_2403);
            var_2405 = wp::extract(var_11, var_2403);
            var_2406 = wp::mul(var_2404, var_2405);
            var_2407 = wp::extract(var_13, var_2403);
            var_2408 = wp::extract(var_13, var_2403);
            var_2409 = wp::mul(var_2407, var_2408);
            var_2410 = wp::add(var_2406, var_2409);
            var_2411 = wp::extract(var_15, var_2403);
            var_2412 = wp::extract(var_15, var_2403);
            var_2413 = wp::mul(var_2411, var_2412);
            var_2414 = wp::add(var_2410, var_2413);
            var_2415 = (var_2414 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_2415) {
                var_2416 = wp::extract(var_11, var_2403);
            }
            if (!var_2415) {
            }
            var_2418 = wp::where(var_2415, var_2416, var_2417);
            var_2419 = integer_steps_0(var_2418, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_2415) {
                var_2420 = wp::extract(var_13, var_2403);
            }
            if (!var_2415) {
            }
            var_2422 = wp::where(var_2415, var_2420, var_2421);
            var_2423 = integer_steps_0(var_2422, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_2415) {
                var_2424 = wp::extract(var_15, var_2403);
            }
            if (!var_2415) {
            }
            var_2426 = wp::where(var_2415, var_2424, var_2425);
            var_2427 = integer_steps_0(var_2426, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_2415) {
            }
            if (!var_2415) {
            }
            var_2430 = wp::where(var_2415, var_2428, var_2429);
            var_2431 = wp::int64(var_2430);
            var_2432 = wp::add(var_2387, var_2431);
            // sx += x                                                                        <L 36>
            var_2433 = wp::add(var_2388, var_2419);
            // sy += y                                                                        <L 37>
            var_2434 = wp::add(var_2389, var_2423);
            // sz += z                                                                        <L 38>
            var_2435 = wp::add(var_2390, var_2427);
            // xx += x * x                                                                    <L 39>
            var_2436 = wp::mul(var_2419, var_2419);
            var_2437 = wp::add(var_2392, var_2436);
            // xy += x * y                                                                    <L 40>
            var_2438 = wp::mul(var_2419, var_2423);
            var_2439 = wp::add(var_2394, var_2438);
            // xz += x * z                                                                    <L 41>
            var_2440 = wp::mul(var_2419, var_2427);
            var_2441 = wp::add(var_2396, var_2440);
            // yy += y * y                                                                    <L 42>
            var_2442 = wp::mul(var_2423, var_2423);
            var_2443 = wp::add(var_2398, var_2442);
            // yz += y * z                                                                    <L 43>
            var_2444 = wp::mul(var_2423, var_2427);
            var_2445 = wp::add(var_2400, var_2444);
            // zz += z * z                                                                    <L 44>
            var_2446 = wp::mul(var_2427, var_2427);
            var_2447 = wp::add(var_2402, var_2446);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_2449 = wp::extract(var_11, var_2448);
            var_2450 = wp::extract(var_11, var_2448);
            var_2451 = wp::mul(var_2449, var_2450);
            var_2452 = wp::extract(var_13, var_2448);
            var_2453 = wp::extract(var_13, var_2448);
            var_2454 = wp::mul(var_2452, var_2453);
            var_2455 = wp::add(var_2451, var_2454);
            var_2456 = wp::extract(var_15, var_2448);
            var_2457 = wp::extract(var_15, var_2448);
            var_2458 = wp::mul(var_2456, var_2457);
            var_2459 = wp::add(var_2455, var_2458);
            var_2460 = (var_2459 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_2460) {
                var_2461 = wp::extract(var_11, var_2448);
            }
            if (!var_2460) {
            }
            var_2463 = wp::where(var_2460, var_2461, var_2462);
            var_2464 = integer_steps_0(var_2463, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_2460) {
                var_2465 = wp::extract(var_13, var_2448);
            }
            if (!var_2460) {
            }
            var_2467 = wp::where(var_2460, var_2465, var_2466);
            var_2468 = integer_steps_0(var_2467, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_2460) {
                var_2469 = wp::extract(var_15, var_2448);
            }
            if (!var_2460) {
            }
            var_2471 = wp::where(var_2460, var_2469, var_2470);
            var_2472 = integer_steps_0(var_2471, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_2460) {
            }
            if (!var_2460) {
            }
            var_2475 = wp::where(var_2460, var_2473, var_2474);
            var_2476 = wp::int64(var_2475);
            var_2477 = wp::add(var_2432, var_2476);
            // sx += x                                                                        <L 36>
            var_2478 = wp::add(var_2433, var_2464);
            // sy += y                                                                        <L 37>
            var_2479 = wp::add(var_2434, var_2468);
            // sz += z                                                                        <L 38>
            var_2480 = wp::add(var_2435, var_2472);
            // xx += x * x                                                                    <L 39>
            var_2481 = wp::mul(var_2464, var_2464);
            var_2482 = wp::add(var_2437, var_2481);
            // xy += x * y                                                                    <L 40>
            var_2483 = wp::mul(var_2464, var_2468);
            var_2484 = wp::add(var_2439, var_2483);
            // xz += x * z                                                                    <L 41>
            var_2485 = wp::mul(var_2464, var_2472);
            var_2486 = wp::add(var_2441, var_2485);
            // yy += y * y                                                                    <L 42>
            var_2487 = wp::mul(var_2468, var_2468);
            var_2488 = wp::add(var_2443, var_2487);
            // yz += y * z                                                                    <L 43>
            var_2489 = wp::mul(var_2468, var_2472);
            var_2490 = wp::add(var_2445, var_2489);
            // zz += z * z                                                                    <L 44>
            var_2491 = wp::mul(var_2472, var_2472);
            var_2492 = wp::add(var_2447, var_2491);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_2494 = wp::extract(var_11, var_2493);
            var_2495 = wp::extract(var_11, var_2493);
            var_2496 = wp::mul(var_2494, var_2495);
            var_2497 = wp::extract(var_13, var_2493);
            var_2498 = wp::extract(var_13, var_2493);
            var_2499 = wp::mul(var_2497, var_2498);
            var_2500 = wp::add(var_2496, var_2499);
            var_2501 = wp::extract(var_15, var_2493);
            var_2502 = wp::extract(var_15, var_2493);
            var_2503 = wp::mul(var_2501, var_2502);
            var_2504 = wp::add(var_2500, var_2503);
            var_2505 = (var_2504 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_2505) {
                var_2506 = wp::extract(var_11, var_2493);
            }
            if (!var_2505) {
            }
            var_2508 = wp::where(var_2505, var_2506, var_2507);
            var_2509 = integer_steps_0(var_2508, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_2505) {
                var_2510 = wp::extract(var_13, var_2493);
            }
            if (!var_2505) {
            }
            var_2512 = wp::where(var_2505, var_2510, var_2511);
            var_2513 = integer_steps_0(var_2512, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_2505) {
                var_2514 = wp::extract(var_15, var_2493);
            }
            if (!var_2505) {
            }
            var_2516 = wp::where(var_2505, var_2514, var_2515);
            var_2517 = integer_steps_0(var_2516, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_2505) {
            }
            if (!var_2505) {
            }
            var_2520 = wp::where(var_2505, var_2518, var_2519);
            var_2521 = wp::int64(var_2520);
            var_2522 = wp::add(var_2477, var_2521);
            // sx += x                                                                        <L 36>
            var_2523 = wp::add(var_2478, var_2509);
            // sy += y                                                                        <L 37>
            var_2524 = wp::add(var_2479, var_2513);
            // sz += z                                                                        <L 38>
            var_2525 = wp::add(var_2480, var_2517);
            // xx += x * x                                                                    <L 39>
            var_2526 = wp::mul(var_2509, var_2509);
            var_2527 = wp::add(var_2482, var_2526);
            // xy += x * y                                                                    <L 40>
            var_2528 = wp::mul(var_2509, var_2513);
            var_2529 = wp::add(var_2484, var_2528);
            // xz += x * z                                                                    <L 41>
            var_2530 = wp::mul(var_2509, var_2517);
            var_2531 = wp::add(var_2486, var_2530);
            // yy += y * y                                                                    <L 42>
            var_2532 = wp::mul(var_2513, var_2513);
            var_2533 = wp::add(var_2488, var_2532);
            // yz += y * z                                                                    <L 43>
            var_2534 = wp::mul(var_2513, var_2517);
            var_2535 = wp::add(var_2490, var_2534);
            // zz += z * z                                                                    <L 44>
            var_2536 = wp::mul(var_2517, var_2517);
            var_2537 = wp::add(var_2492, var_2536);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_2539 = wp::extract(var_11, var_2538);
            var_2540 = wp::extract(var_11, var_2538);
            var_2541 = wp::mul(var_2539, var_2540);
            var_2542 = wp::extract(var_13, var_2538);
            var_2543 = wp::extract(var_13, var_2538);
            var_2544 = wp::mul(var_2542, var_2543);
            var_2545 = wp::add(var_2541, var_2544);
            var_2546 = wp::extract(var_15, var_2538);
            var_2547 = wp::extract(var_15, var_2538);
            var_2548 = wp::mul(var_2546, var_2547);
            var_2549 = wp::add(var_2545, var_2548);
            var_2550 = (var_2549 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_2550) {
                var_2551 = wp::extract(var_11, var_2538);
            }
            if (!var_2550) {
            }
            var_2553 = wp::where(var_2550, var_2551, var_2552);
            var_2554 = integer_steps_0(var_2553, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_2550) {
                var_2555 = wp::extract(var_13, var_2538);
            }
            if (!var_2550) {
            }
            var_2557 = wp::where(var_2550, var_2555, var_2556);
            var_2558 = integer_steps_0(var_2557, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_2550) {
                var_2559 = wp::extract(var_15, var_2538);
            }
            if (!var_2550) {
            }
            var_2561 = wp::where(var_2550, var_2559, var_2560);
            var_2562 = integer_steps_0(var_2561, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_2550) {
            }
            if (!var_2550) {
            }
            var_2565 = wp::where(var_2550, var_2563, var_2564);
            var_2566 = wp::int64(var_2565);
            var_2567 = wp::add(var_2522, var_2566);
            // sx += x                                                                        <L 36>
            var_2568 = wp::add(var_2523, var_2554);
            // sy += y                                                                        <L 37>
            var_2569 = wp::add(var_2524, var_2558);
            // sz += z                                                                        <L 38>
            var_2570 = wp::add(var_2525, var_2562);
            // xx += x * x                                                                    <L 39>
            var_2571 = wp::mul(var_2554, var_2554);
            var_2572 = wp::add(var_2527, var_2571);
            // xy += x * y                                                                    <L 40>
            var_2573 = wp::mul(var_2554, var_2558);
            var_2574 = wp::add(var_2529, var_2573);
            // xz += x * z                                                                    <L 41>
            var_2575 = wp::mul(var_2554, var_2562);
            var_2576 = wp::add(var_2531, var_2575);
            // yy += y * y                                                                    <L 42>
            var_2577 = wp::mul(var_2558, var_2558);
            var_2578 = wp::add(var_2533, var_2577);
            // yz += y * z                                                                    <L 43>
            var_2579 = wp::mul(var_2558, var_2562);
            var_2580 = wp::add(var_2535, var_2579);
            // zz += z * z                                                                    <L 44>
            var_2581 = wp::mul(var_2562, var_2562);
            var_2582 = wp::add(var_2537, var_2581);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_2584 = wp::extract(var_11, var_2583);
            var_2585 = wp::extract(var_11, var_2583);
            var_2586 = wp::mul(var_2584, var_2585);
            var_2587 = wp::extract(var_13, var_2583);
            var_2588 = wp::extract(var_13, var_2583);
            var_2589 = wp::mul(var_2587, var_2588);
            var_2590 = wp::add(var_2586, var_2589);
            var_2591 = wp::extract(var_15, var_2583);
            var_2592 = wp::extract(var_15, var_2583);
            var_2593 = wp::mul(var_2591, var_2592);
            var_2594 = wp::add(var_2590, var_2593);
            var_2595 = (var_2594 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_2595) {
                var_2596 = wp::extract(var_11, var_2583);
            }
            if (!var_2595) {
            }
            var_2598 = wp::where(var_2595, var_2596, var_2597);
            var_2599 = integer_steps_0(var_2598, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_2595) {
                var_2600 = wp::extract(var_13, var_2583);
            }
            if (!var_2595) {
            }
            var_2602 = wp::where(var_2595, var_2600, var_2601);
            var_2603 = integer_steps_0(var_2602, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_2595) {
                var_2604 = wp::extract(var_15, var_2583);
            }
            if (!var_2595) {
            }
            var_2606 = wp::where(var_2595, var_2604, var_2605);
            var_2607 = integer_steps_0(var_2606, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_2595) {
            }
            if (!var_2595) {
            }
            var_2610 = wp::where(var_2595, var_2608, var_2609);
            var_2611 = wp::int64(var_2610);
            var_2612 = wp::add(var_2567, var_2611);
            // sx += x                                                                        <L 36>
            var_2613 = wp::add(var_2568, var_2599);
            // sy += y                                                                        <L 37>
            var_2614 = wp::add(var_2569, var_2603);
            // sz += z                                                                        <L 38>
            var_2615 = wp::add(var_2570, var_2607);
            // xx += x * x                                                                    <L 39>
            var_2616 = wp::mul(var_2599, var_2599);
            var_2617 = wp::add(var_2572, var_2616);
            // xy += x * y                                                                    <L 40>
            var_2618 = wp::mul(var_2599, var_2603);
            var_2619 = wp::add(var_2574, var_2618);
            // xz += x * z                                                                    <L 41>
            var_2620 = wp::mul(var_2599, var_2607);
            var_2621 = wp::add(var_2576, var_2620);
            // yy += y * y                                                                    <L 42>
            var_2622 = wp::mul(var_2603, var_2603);
            var_2623 = wp::add(var_2578, var_2622);
            // yz += y * z                                                                    <L 43>
            var_2624 = wp::mul(var_2603, var_2607);
            var_2625 = wp::add(var_2580, var_2624);
            // zz += z * z                                                                    <L 44>
            var_2626 = wp::mul(var_2607, var_2607);
            var_2627 = wp::add(var_2582, var_2626);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_2629 = wp::extract(var_11, var_2628);
            var_2630 = wp::extract(var_11, var_2628);
            var_2631 = wp::mul(var_2629, var_2630);
            var_2632 = wp::extract(var_13, var_2628);
            var_2633 = wp::extract(var_13, var_2628);
            var_2634 = wp::mul(var_2632, var_2633);
            var_2635 = wp::add(var_2631, var_2634);
            var_2636 = wp::extract(var_15, var_2628);
            var_2637 = wp::extract(var_15, var_2628);
            var_2638 = wp::mul(var_2636, var_2637);
            var_2639 = wp::add(var_2635, var_2638);
            var_2640 = (var_2639 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_2640) {
                var_2641 = wp::extract(var_11, var_2628);
            }
            if (!var_2640) {
            }
            var_2643 = wp::where(var_2640, var_2641, var_2642);
            var_2644 = integer_steps_0(var_2643, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_2640) {
                var_2645 = wp::extract(var_13, var_2628);
            }
            if (!var_2640) {
            }
            var_2647 = wp::where(var_2640, var_2645, var_2646);
            var_2648 = integer_steps_0(var_2647, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_2640) {
                var_2649 = wp::extract(var_15, var_2628);
            }
            if (!var_2640) {
            }
            var_2651 = wp::where(var_2640, var_2649, var_2650);
            var_2652 = integer_steps_0(var_2651, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_2640) {
            }
            if (!var_2640) {
            }
            var_2655 = wp::where(var_2640, var_2653, var_2654);
            var_2656 = wp::int64(var_2655);
            var_2657 = wp::add(var_2612, var_2656);
            // sx += x                                                                        <L 36>
            var_2658 = wp::add(var_2613, var_2644);
            // sy += y                                                                        <L 37>
            var_2659 = wp::add(var_2614, var_2648);
            // sz += z                                                                        <L 38>
            var_2660 = wp::add(var_2615, var_2652);
            // xx += x * x                                                                    <L 39>
            var_2661 = wp::mul(var_2644, var_2644);
            var_2662 = wp::add(var_2617, var_2661);
            // xy += x * y                                                                    <L 40>
            var_2663 = wp::mul(var_2644, var_2648);
            var_2664 = wp::add(var_2619, var_2663);
            // xz += x * z                                                                    <L 41>
            var_2665 = wp::mul(var_2644, var_2652);
            var_2666 = wp::add(var_2621, var_2665);
            // yy += y * y                                                                    <L 42>
            var_2667 = wp::mul(var_2648, var_2648);
            var_2668 = wp::add(var_2623, var_2667);
            // yz += y * z                                                                    <L 43>
            var_2669 = wp::mul(var_2648, var_2652);
            var_2670 = wp::add(var_2625, var_2669);
            // zz += z * z                                                                    <L 44>
            var_2671 = wp::mul(var_2652, var_2652);
            var_2672 = wp::add(var_2627, var_2671);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_2674 = wp::extract(var_11, var_2673);
            var_2675 = wp::extract(var_11, var_2673);
            var_2676 = wp::mul(var_2674, var_2675);
            var_2677 = wp::extract(var_13, var_2673);
            var_2678 = wp::extract(var_13, var_2673);
            var_2679 = wp::mul(var_2677, var_2678);
            var_2680 = wp::add(var_2676, var_2679);
            var_2681 = wp::extract(var_15, var_2673);
            var_2682 = wp::extract(var_15, var_2673);
            var_2683 = wp::mul(var_2681, var_2682);
            var_2684 = wp::add(var_2680, var_2683);
            var_2685 = (var_2684 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_2685) {
                var_2686 = wp::extract(var_11, var_2673);
            }
            if (!var_2685) {
            }
            var_2688 = wp::where(var_2685, var_2686, var_2687);
            var_2689 = integer_steps_0(var_2688, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_2685) {
                var_2690 = wp::extract(var_13, var_2673);
            }
            if (!var_2685) {
            }
            var_2692 = wp::where(var_2685, var_2690, var_2691);
            var_2693 = integer_steps_0(var_2692, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_2685) {
                var_2694 = wp::extract(var_15, var_2673);
            }
            if (!var_2685) {
            }
            var_2696 = wp::where(var_2685, var_2694, var_2695);
            var_2697 = integer_steps_0(var_2696, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_2685) {
            }
            if (!var_2685) {
            }
            var_2700 = wp::where(var_2685, var_2698, var_2699);
            var_2701 = wp::int64(var_2700);
            var_2702 = wp::add(var_2657, var_2701);
            // sx += x                                                                        <L 36>
            var_2703 = wp::add(var_2658, var_2689);
            // sy += y                                                                        <L 37>
            var_2704 = wp::add(var_2659, var_2693);
            // sz += z                                                                        <L 38>
            var_2705 = wp::add(var_2660, var_2697);
            // xx += x * x                                                                    <L 39>
            var_2706 = wp::mul(var_2689, var_2689);
            var_2707 = wp::add(var_2662, var_2706);
            // xy += x * y                                                                    <L 40>
            var_2708 = wp::mul(var_2689, var_2693);
            var_2709 = wp::add(var_2664, var_2708);
            // xz += x * z                                                                    <L 41>
            var_2710 = wp::mul(var_2689, var_2697);
            var_2711 = wp::add(var_2666, var_2710);
            // yy += y * y                                                                    <L 42>
            var_2712 = wp::mul(var_2693, var_2693);
            var_2713 = wp::add(var_2668, var_2712);
            // yz += y * z                                                                    <L 43>
            var_2714 = wp::mul(var_2693, var_2697);
            var_2715 = wp::add(var_2670, var_2714);
            // zz += z * z                                                                    <L 44>
            var_2716 = wp::mul(var_2697, var_2697);
            var_2717 = wp::add(var_2672, var_2716);
        }
        var_2718 = wp::where(var_2194, var_2702, var_2175);
        var_2719 = wp::where(var_2194, var_2703, var_2176);
        var_2720 = wp::where(var_2194, var_2704, var_2177);
        var_2721 = wp::where(var_2194, var_2705, var_2178);
        var_2722 = wp::where(var_2194, var_2707, var_2179);
        var_2723 = wp::where(var_2194, var_2709, var_2180);
        var_2724 = wp::where(var_2194, var_2711, var_2181);
        var_2725 = wp::where(var_2194, var_2713, var_2182);
        var_2726 = wp::where(var_2194, var_2715, var_2183);
        var_2727 = wp::where(var_2194, var_2717, var_2184);
        var_2728 = wp::where(var_2194, var_2197, var_2185);
        var_2729 = wp::where(var_2194, var_2673, var_2186);
        var_2730 = wp::where(var_2194, var_2341, var_2187);
        var_2731 = wp::where(var_2194, var_2685, var_2188);
        var_2732 = wp::where(var_2194, var_2689, var_2189);
        var_2733 = wp::where(var_2194, var_2693, var_2190);
        var_2734 = wp::where(var_2194, var_2697, var_2191);
        // if distances__leaves_within__1[leaf__leaves_within__1] <= max_sqdist:              <L 23>
        var_2736 = wp::extract(var_24, var_2735);
        var_2737 = (var_2736 <= var_max_sqdist);
        if (var_2737) {
            // first = bucket__leaves_within__1 * BUCKET__leaves_within + leaf__leaves_within__1 * LEAF__leaves_within       <L 24>
            var_2738 = wp::mul(var_23, var_28);
            var_2739 = wp::mul(var_2735, var_30);
            var_2740 = wp::add(var_2738, var_2739);
            // for j in range(LEAF):                                                          <L 25>
            // q = tree__points[first + j]                                                    <L 26>
            var_2742 = wp::add(var_2740, var_2741);
            var_2743 = wp::address(var_tree__points, var_2742);
            var_2745 = wp::load(var_2743);
            var_2744 = wp::copy(var_2745);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_2747 = wp::extract(var_2744, var_2746);
            var_2749 = wp::extract(var_p, var_2748);
            var_2750 = wp::sub(var_2747, var_2749);
            wp::assign_inplace(var_11, var_2741, var_2750);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_2752 = wp::extract(var_2744, var_2751);
            var_2754 = wp::extract(var_p, var_2753);
            var_2755 = wp::sub(var_2752, var_2754);
            wp::assign_inplace(var_13, var_2741, var_2755);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_2757 = wp::extract(var_2744, var_2756);
            var_2759 = wp::extract(var_p, var_2758);
            var_2760 = wp::sub(var_2757, var_2759);
            wp::assign_inplace(var_15, var_2741, var_2760);
            // q = tree__points[first + j]                                                    <L 26>
            var_2762 = wp::add(var_2740, var_2761);
            var_2763 = wp::address(var_tree__points, var_2762);
            var_2765 = wp::load(var_2763);
            var_2764 = wp::copy(var_2765);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_2767 = wp::extract(var_2764, var_2766);
            var_2769 = wp::extract(var_p, var_2768);
            var_2770 = wp::sub(var_2767, var_2769);
            wp::assign_inplace(var_11, var_2761, var_2770);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_2772 = wp::extract(var_2764, var_2771);
            var_2774 = wp::extract(var_p, var_2773);
            var_2775 = wp::sub(var_2772, var_2774);
            wp::assign_inplace(var_13, var_2761, var_2775);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_2777 = wp::extract(var_2764, var_2776);
            var_2779 = wp::extract(var_p, var_2778);
            var_2780 = wp::sub(var_2777, var_2779);
            wp::assign_inplace(var_15, var_2761, var_2780);
            // q = tree__points[first + j]                                                    <L 26>
            var_2782 = wp::add(var_2740, var_2781);
            var_2783 = wp::address(var_tree__points, var_2782);
            var_2785 = wp::load(var_2783);
            var_2784 = wp::copy(var_2785);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_2787 = wp::extract(var_2784, var_2786);
            var_2789 = wp::extract(var_p, var_2788);
            var_2790 = wp::sub(var_2787, var_2789);
            wp::assign_inplace(var_11, var_2781, var_2790);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_2792 = wp::extract(var_2784, var_2791);
            var_2794 = wp::extract(var_p, var_2793);
            var_2795 = wp::sub(var_2792, var_2794);
            wp::assign_inplace(var_13, var_2781, var_2795);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_2797 = wp::extract(var_2784, var_2796);
            var_2799 = wp::extract(var_p, var_2798);
            var_2800 = wp::sub(var_2797, var_2799);
            wp::assign_inplace(var_15, var_2781, var_2800);
            // q = tree__points[first + j]                                                    <L 26>
            var_2802 = wp::add(var_2740, var_2801);
            var_2803 = wp::address(var_tree__points, var_2802);
            var_2805 = wp::load(var_2803);
            var_2804 = wp::copy(var_2805);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_2807 = wp::extract(var_2804, var_2806);
            var_2809 = wp::extract(var_p, var_2808);
            var_2810 = wp::sub(var_2807, var_2809);
            wp::assign_inplace(var_11, var_2801, var_2810);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_2812 = wp::extract(var_2804, var_2811);
            var_2814 = wp::extract(var_p, var_2813);
            var_2815 = wp::sub(var_2812, var_2814);
            wp::assign_inplace(var_13, var_2801, var_2815);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_2817 = wp::extract(var_2804, var_2816);
            var_2819 = wp::extract(var_p, var_2818);
            var_2820 = wp::sub(var_2817, var_2819);
            wp::assign_inplace(var_15, var_2801, var_2820);
            // q = tree__points[first + j]                                                    <L 26>
            var_2822 = wp::add(var_2740, var_2821);
            var_2823 = wp::address(var_tree__points, var_2822);
            var_2825 = wp::load(var_2823);
            var_2824 = wp::copy(var_2825);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_2827 = wp::extract(var_2824, var_2826);
            var_2829 = wp::extract(var_p, var_2828);
            var_2830 = wp::sub(var_2827, var_2829);
            wp::assign_inplace(var_11, var_2821, var_2830);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_2832 = wp::extract(var_2824, var_2831);
            var_2834 = wp::extract(var_p, var_2833);
            var_2835 = wp::sub(var_2832, var_2834);
            wp::assign_inplace(var_13, var_2821, var_2835);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_2837 = wp::extract(var_2824, var_2836);
            var_2839 = wp::extract(var_p, var_2838);
            var_2840 = wp::sub(var_2837, var_2839);
            wp::assign_inplace(var_15, var_2821, var_2840);
            // q = tree__points[first + j]                                                    <L 26>
            var_2842 = wp::add(var_2740, var_2841);
            var_2843 = wp::address(var_tree__points, var_2842);
            var_2845 = wp::load(var_2843);
            var_2844 = wp::copy(var_2845);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_2847 = wp::extract(var_2844, var_2846);
            var_2849 = wp::extract(var_p, var_2848);
            var_2850 = wp::sub(var_2847, var_2849);
            wp::assign_inplace(var_11, var_2841, var_2850);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_2852 = wp::extract(var_2844, var_2851);
            var_2854 = wp::extract(var_p, var_2853);
            var_2855 = wp::sub(var_2852, var_2854);
            wp::assign_inplace(var_13, var_2841, var_2855);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_2857 = wp::extract(var_2844, var_2856);
            var_2859 = wp::extract(var_p, var_2858);
            var_2860 = wp::sub(var_2857, var_2859);
            wp::assign_inplace(var_15, var_2841, var_2860);
            // q = tree__points[first + j]                                                    <L 26>
            var_2862 = wp::add(var_2740, var_2861);
            var_2863 = wp::address(var_tree__points, var_2862);
            var_2865 = wp::load(var_2863);
            var_2864 = wp::copy(var_2865);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_2867 = wp::extract(var_2864, var_2866);
            var_2869 = wp::extract(var_p, var_2868);
            var_2870 = wp::sub(var_2867, var_2869);
            wp::assign_inplace(var_11, var_2861, var_2870);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_2872 = wp::extract(var_2864, var_2871);
            var_2874 = wp::extract(var_p, var_2873);
            var_2875 = wp::sub(var_2872, var_2874);
            wp::assign_inplace(var_13, var_2861, var_2875);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_2877 = wp::extract(var_2864, var_2876);
            var_2879 = wp::extract(var_p, var_2878);
            var_2880 = wp::sub(var_2877, var_2879);
            wp::assign_inplace(var_15, var_2861, var_2880);
            // q = tree__points[first + j]                                                    <L 26>
            var_2882 = wp::add(var_2740, var_2881);
            var_2883 = wp::address(var_tree__points, var_2882);
            var_2885 = wp::load(var_2883);
            var_2884 = wp::copy(var_2885);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_2887 = wp::extract(var_2884, var_2886);
            var_2889 = wp::extract(var_p, var_2888);
            var_2890 = wp::sub(var_2887, var_2889);
            wp::assign_inplace(var_11, var_2881, var_2890);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_2892 = wp::extract(var_2884, var_2891);
            var_2894 = wp::extract(var_p, var_2893);
            var_2895 = wp::sub(var_2892, var_2894);
            wp::assign_inplace(var_13, var_2881, var_2895);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_2897 = wp::extract(var_2884, var_2896);
            var_2899 = wp::extract(var_p, var_2898);
            var_2900 = wp::sub(var_2897, var_2899);
            wp::assign_inplace(var_15, var_2881, var_2900);
            // for j in range(LEAF):                                                          <L 30>
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_2902 = wp::extract(var_11, var_2901);
            var_2903 = wp::extract(var_11, var_2901);
            var_2904 = wp::mul(var_2902, var_2903);
            var_2905 = wp::extract(var_13, var_2901);
            var_2906 = wp::extract(var_13, var_2901);
            var_2907 = wp::mul(var_2905, var_2906);
            var_2908 = wp::add(var_2904, var_2907);
            var_2909 = wp::extract(var_15, var_2901);
            var_2910 = wp::extract(var_15, var_2901);
            var_2911 = wp::mul(var_2909, var_2910);
            var_2912 = wp::add(var_2908, var_2911);
            var_2913 = (var_2912 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_2913) {
                var_2914 = wp::extract(var_11, var_2901);
            }
            if (!var_2913) {
            }
            var_2916 = wp::where(var_2913, var_2914, var_2915);
            var_2917 = integer_steps_0(var_2916, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_2913) {
                var_2918 = wp::extract(var_13, var_2901);
            }
            if (!var_2913) {
            }
            var_2920 = wp::where(var_2913, var_2918, var_2919);
            var_2921 = integer_steps_0(var_2920, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_2913) {
                var_2922 = wp::extract(var_15, var_2901);
            }
            if (!var_2913) {
            }
            var_2924 = wp::where(var_2913, var_2922, var_2923);
            var_2925 = integer_steps_0(var_2924, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_2913) {
            }
            if (!var_2913) {
            }
            var_2928 = wp::where(var_2913, var_2926, var_2927);
            var_2929 = wp::int64(var_2928);
            var_2930 = wp::add(var_2718, var_2929);
            // sx += x                                                                        <L 36>
            var_2931 = wp::add(var_2719, var_2917);
            // sy += y                                                                        <L 37>
            var_2932 = wp::add(var_2720, var_2921);
            // sz += z                                                                        <L 38>
            var_2933 = wp::add(var_2721, var_2925);
            // xx += x * x                                                                    <L 39>
            var_2934 = wp::mul(var_2917, var_2917);
            var_2935 = wp::add(var_2722, var_2934);
            // xy += x * y                                                                    <L 40>
            var_2936 = wp::mul(var_2917, var_2921);
            var_2937 = wp::add(var_2723, var_2936);
            // xz += x * z                                                                    <L 41>
            var_2938 = wp::mul(var_2917, var_2925);
            var_2939 = wp::add(var_2724, var_2938);
            // yy += y * y                                                                    <L 42>
            var_2940 = wp::mul(var_2921, var_2921);
            var_2941 = wp::add(var_2725, var_2940);
            // yz += y * z                                                                    <L 43>
            var_2942 = wp::mul(var_2921, var_2925);
            var_2943 = wp::add(var_2726, var_2942);
            // zz += z * z                                                                    <L 44>
            var_2944 = wp::mul(var_2925, var_2925);
            var_2945 = wp::add(var_2727, var_2944);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_2947 = wp::extract(var_11, var_2946);
            var_2948 = wp::extract(var_11, var_2946);
            var_2949 = wp::mul(var_2947, var_2948);
            var_2950 = wp::extract(var_13, var_2946);
            var_2951 = wp::extract(var_13, var_2946);
            var_2952 = wp::mul(var_2950, var_2951);
            var_2953 = wp::add(var_2949, var_2952);
            var_2954 = wp::extract(var_15, var_2946);
            var_2955 = wp::extract(var_15, var_2946);
            var_2956 = wp::mul(var_2954, var_2955);
            var_2957 = wp::add(var_2953, var_2956);
            var_2958 = (var_2957 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_2958) {
                var_2959 = wp::extract(var_11, var_2946);
            }
            if (!var_2958) {
            }
            var_2961 = wp::where(var_2958, var_2959, var_2960);
            var_2962 = integer_steps_0(var_2961, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_2958) {
                var_2963 = wp::extract(var_13, var_2946);
            }
            if (!var_2958) {
            }
            var_2965 = wp::where(var_2958, var_2963, var_2964);
            var_2966 = integer_steps_0(var_2965, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_2958) {
                var_2967 = wp::extract(var_15, var_2946);
            }
            if (!var_2958) {
            }
            var_2969 = wp::where(var_2958, var_2967, var_2968);
            var_2970 = integer_steps_0(var_2969, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_2958) {
            }
            if (!var_2958) {
            }
            var_2973 = wp::where(var_2958, var_2971, var_2972);
            var_2974 = wp::int64(var_2973);
            var_2975 = wp::add(var_2930, var_2974);
            // sx += x                                                                        <L 36>
            var_2976 = wp::add(var_2931, var_2962);
            // sy += y                                                                        <L 37>
            var_2977 = wp::add(var_2932, var_2966);
            // sz += z                                                                        <L 38>
            var_2978 = wp::add(var_2933, var_2970);
            // xx += x * x                                                                    <L 39>
            var_2979 = wp::mul(var_2962, var_2962);
            var_2980 = wp::add(var_2935, var_2979);
            // xy += x * y                                                                    <L 40>
            var_2981 = wp::mul(var_2962, var_2966);
            var_2982 = wp::add(var_2937, var_2981);
            // xz += x * z                                                                    <L 41>
            var_2983 = wp::mul(var_2962, var_2970);
            var_2984 = wp::add(var_2939, var_2983);
            // yy += y * y                                                                    <L 42>
            var_2985 = wp::mul(var_2966, var_2966);
            var_2986 = wp::add(var_2941, var_2985);
            // yz += y * z                                                                    <L 43>
            var_2987 = wp::mul(var_2966, var_2970);
            var_2988 = wp::add(var_2943, var_2987);
            // zz += z * z                                                                    <L 44>
            var_2989 = wp::mul(var_2970, var_2970);
            var_2990 = wp::add(var_2945, var_2989);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_2992 = wp::extract(var_11, var_2991);
            var_2993 = wp::extract(var_11, var_2991);
            var_2994 = wp::mul(var_2992, var_2993);
            var_2995 = wp::extract(var_13, var_2991);
            var_2996 = wp::extract(var_13, var_2991);
            var_2997 = wp::mul(var_2995, var_2996);
            var_2998 = wp::add(var_2994, var_2997);
            var_2999 = wp::extract(var_15, var_2991);
            var_3000 = wp::extract(var_15, var_2991);
            var_3001 = wp::mul(var_2999, var_3000);
            var_3002 = wp::add(var_2998, var_3001);
            var_3003 = (var_3002 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_3003) {
                var_3004 = wp::extract(var_11, var_2991);
            }
            if (!var_3003) {
            }
            var_3006 = wp::where(var_3003, var_3004, var_3005);
            var_3007 = integer_steps_0(var_3006, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_3003) {
                var_3008 = wp::extract(var_13, var_2991);
            }
            if (!var_3003) {
            }
            var_3010 = wp::where(var_3003, var_3008, var_3009);
            var_3011 = integer_steps_0(var_3010, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_3003) {
                var_3012 = wp::extract(var_15, var_2991);
            }
            if (!var_3003) {
            }
            var_3014 = wp::where(var_3003, var_3012, var_3013);
            var_3015 = integer_steps_0(var_3014, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_3003) {
            }
            if (!var_3003) {
            }
            var_3018 = wp::where(var_3003, var_3016, var_3017);
            var_3019 = wp::int64(var_3018);
            var_3020 = wp::add(var_2975, var_3019);
            // sx += x                                                                        <L 36>
            var_3021 = wp::add(var_2976, var_3007);
            // sy += y                                                                        <L 37>
            var_3022 = wp::add(var_2977, var_3011);
            // sz += z                                                                        <L 38>
            var_3023 = wp::add(var_2978, var_3015);
            // xx += x * x                                                                    <L 39>
            var_3024 = wp::mul(var_3007, var_3007);
            var_3025 = wp::add(var_2980, var_3024);
            // xy += x * y                                                                    <L 40>
            var_3026 = wp::mul(var_3007, var_3011);
            var_3027 = wp::add(var_2982, var_3026);
            // xz += x * z                                                                    <L 41>
            var_3028 = wp::mul(var_3007, var_3015);
            var_3029 = wp::add(var_2984, var_3028);
            // yy += y * y                                                                    <L 42>
            var_3030 = wp::mul(var_3011, var_3011);
            var_3031 = wp::add(var_2986, var_3030);
            // yz += y * z                                                                    <L 43>
            var_3032 = wp::mul(var_3011, var_3015);
            var_3033 = wp::add(var_2988, var_3032);
            // zz += z * z                                                                    <L 44>
            var_3034 = wp::mul(var_3015, var_3015);
            var_3035 = wp::add(var_2990, var_3034);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_3037 = wp::extract(var_11, var_3036);
            var_3038 = wp::extract(var_11, var_3036);
            var_3039 = wp::mul(var_3037, var_3038);
            var_3040 = wp::extract(var_13, var_3036);
            var_3041 = wp::extract(var_13, var_3036);
            var_3042 = wp::mul(var_3040, var_3041);
            var_3043 = wp::add(var_3039, var_3042);
            var_3044 = wp::extract(var_15, var_3036);
            var_3045 = wp::extract(var_15, var_3036);
            var_3046 = wp::mul(var_3044, var_3045);
            var_3047 = wp::add(var_3043, var_3046);
            var_3048 = (var_3047 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_3048) {
                var_3049 = wp::extract(var_11, var_3036);
            }
            if (!var_3048) {
            }
            var_3051 = wp::where(var_3048, var_3049, var_3050);
            var_3052 = integer_steps_0(var_3051, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_3048) {
                var_3053 = wp::extract(var_13, var_3036);
            }
            if (!var_3048) {
            }
            var_3055 = wp::where(var_3048, var_3053, var_3054);
            var_3056 = integer_steps_0(var_3055, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_3048) {
                var_3057 = wp::extract(var_15, var_3036);
            }
            if (!var_3048) {
            }
            var_3059 = wp::where(var_3048, var_3057, var_3058);
            var_3060 = integer_steps_0(var_3059, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_3048) {
            }
            if (!var_3048) {
            }
            var_3063 = wp::where(var_3048, var_3061, var_3062);
            var_3064 = wp::int64(var_3063);
            var_3065 = wp::add(var_3020, var_3064);
            // sx += x                                                                        <L 36>
            var_3066 = wp::add(var_3021, var_3052);
            // sy += y                                                                        <L 37>
            var_3067 = wp::add(var_3022, var_3056);
            // sz += z                                                                        <L 38>
            var_3068 = wp::add(var_3023, var_3060);
            // xx += x * x                                                                    <L 39>
            var_3069 = wp::mul(var_3052, var_3052);
            var_3070 = wp::add(var_3025, var_3069);
            // xy += x * y                                                                    <L 40>
            var_3071 = wp::mul(var_3052, var_3056);
            var_3072 = wp::add(var_3027, var_3071);
            // xz += x * z                                                                    <L 41>
            var_3073 = wp::mul(var_3052, var_3060);
            var_3074 = wp::add(var_3029, var_3073);
            // yy += y * y                                                                    <L 42>
            var_3075 = wp::mul(var_3056, var_3056);
            var_3076 = wp::add(var_3031, var_3075);
            // yz += y * z                                                                    <L 43>
            var_3077 = wp::mul(var_3056, var_3060);
            var_3078 = wp::add(var_3033, var_3077);
            // zz += z * z                                                                    <L 44>
            var_3079 = wp::mul(var_3060, var_3060);
            var_3080 = wp::add(var_3035, var_3079);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_3082 = wp::extract(var_11, var_3081);
            var_3083 = wp::extract(var_11, var_3081);
            var_3084 = wp::mul(var_3082, var_3083);
            var_3085 = wp::extract(var_13, var_3081);
            var_3086 = wp::extract(var_13, var_3081);
            var_3087 = wp::mul(var_3085, var_3086);
            var_3088 = wp::add(var_3084, var_3087);
            var_3089 = wp::extract(var_15, var_3081);
            var_3090 = wp::extract(var_15, var_3081);
            var_3091 = wp::mul(var_3089, var_3090);
            var_3092 = wp::add(var_3088, var_3091);
            var_3093 = (var_3092 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_3093) {
                var_3094 = wp::extract(var_11, var_3081);
            }
            if (!var_3093) {
            }
            var_3096 = wp::where(var_3093, var_3094, var_3095);
            var_3097 = integer_steps_0(var_3096, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_3093) {
                var_3098 = wp::extract(var_13, var_3081);
            }
            if (!var_3093) {
            }
            var_3100 = wp::where(var_3093, var_3098, var_3099);
            var_3101 = integer_steps_0(var_3100, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_3093) {
                var_3102 = wp::extract(var_15, var_3081);
            }
            if (!var_3093) {
            }
            var_3104 = wp::where(var_3093, var_3102, var_3103);
            var_3105 = integer_steps_0(var_3104, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_3093) {
            }
            if (!var_3093) {
            }
            var_3108 = wp::where(var_3093, var_3106, var_3107);
            var_3109 = wp::int64(var_3108);
            var_3110 = wp::add(var_3065, var_3109);
            // sx += x                                                                        <L 36>
            var_3111 = wp::add(var_3066, var_3097);
            // sy += y                                                                        <L 37>
            var_3112 = wp::add(var_3067, var_3101);
            // sz += z                                                                        <L 38>
            var_3113 = wp::add(var_3068, var_3105);
            // xx += x * x                                                                    <L 39>
            var_3114 = wp::mul(var_3097, var_3097);
            var_3115 = wp::add(var_3070, var_3114);
            // xy += x * y                                                                    <L 40>
            var_3116 = wp::mul(var_3097, var_3101);
            var_3117 = wp::add(var_3072, var_3116);
            // xz += x * z                                                                    <L 41>
            var_3118 = wp::mul(var_3097, var_3105);
            var_3119 = wp::add(var_3074, var_3118);
            // yy += y * y                                                                    <L 42>
            var_3120 = wp::mul(var_3101, var_3101);
            var_3121 = wp::add(var_3076, var_3120);
            // yz += y * z                                                                    <L 43>
            var_3122 = wp::mul(var_3101, var_3105);
            var_3123 = wp::add(var_3078, var_3122);
            // zz += z * z                                                                    <L 44>
            var_3124 = wp::mul(var_3105, var_3105);
            var_3125 = wp::add(var_3080, var_3124);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_3127 = wp::extract(var_11, var_3126);
            var_3128 = wp::extract(var_11, var_3126);
            var_3129 = wp::mul(var_3127, var_3128);
            var_3130 = wp::extract(var_13, var_3126);
            var_3131 = wp::extract(var_13, var_3126);
            var_3132 = wp::mul(var_3130, var_3131);
            var_3133 = wp::add(var_3129, var_3132);
            var_3134 = wp::extract(var_15, var_3126);
            var_3135 = wp::extract(var_15, var_3126);
            var_3136 = wp::mul(var_3134, var_3135);
            var_3137 = wp::add(var_3133, var_3136);
            var_3138 = (var_3137 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_3138) {
                var_3139 = wp::extract(var_11, var_3126);
            }
            if (!var_3138) {
            }
            var_3141 = wp::where(var_3138, var_3139, var_3140);
            var_3142 = integer_steps_0(var_3141, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_3138) {
                var_3143 = wp::extract(var_13, var_3126);
            }
            if (!var_3138) {
            }
            var_3145 = wp::where(var_3138, var_3143, var_3144);
            var_3146 = integer_steps_0(var_3145, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_3138) {
                var_3147 = wp::extract(var_15, var_3126);
            }
            if (!var_3138) {
            }
            var_3149 = wp::where(var_3138, var_3147, var_3148);
            var_3150 = integer_steps_0(var_3149, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_3138) {
            }
            if (!var_3138) {
            }
            var_3153 = wp::where(var_3138, var_3151, var_3152);
            var_3154 = wp::int64(var_3153);
            var_3155 = wp::add(var_3110, var_3154);
            // sx += x                                                                        <L 36>
            var_3156 = wp::add(var_3111, var_3142);
            // sy += y                                                                        <L 37>
            var_3157 = wp::add(var_3112, var_3146);
            // sz += z                                                                        <L 38>
            var_3158 = wp::add(var_3113, var_3150);
            // xx += x * x                                                                    <L 39>
            var_3159 = wp::mul(var_3142, var_3142);
            var_3160 = wp::add(var_3115, var_3159);
            // xy += x * y                                                                    <L 40>
            var_3161 = wp::mul(var_3142, var_3146);
            var_3162 = wp::add(var_3117, var_3161);
            // xz += x * z                                                                    <L 41>
            var_3163 = wp::mul(var_3142, var_3150);
            var_3164 = wp::add(var_3119, var_3163);
            // yy += y * y                                                                    <L 42>
            var_3165 = wp::mul(var_3146, var_3146);
            var_3166 = wp::add(var_3121, var_3165);
            // yz += y * z                                                                    <L 43>
            var_3167 = wp::mul(var_3146, var_3150);
            var_3168 = wp::add(var_3123, var_3167);
            // zz += z * z                                                                    <L 44>
            var_3169 = wp::mul(var_3150, var_3150);
            var_3170 = wp::add(var_3125, var_3169);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_3172 = wp::extract(var_11, var_3171);
            var_3173 = wp::extract(var_11, var_3171);
            var_3174 = wp::mul(var_3172, var_3173);
            var_3175 = wp::extract(var_13, var_3171);
            var_3176 = wp::extract(var_13, var_3171);
            var_3177 = wp::mul(var_3175, var_3176);
            var_3178 = wp::add(var_3174, var_3177);
            var_3179 = wp::extract(var_15, var_3171);
            var_3180 = wp::extract(var_15, var_3171);
            var_3181 = wp::mul(var_3179, var_3180);
            var_3182 = wp::add(var_3178, var_3181);
            var_3183 = (var_3182 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_3183) {
                var_3184 = wp::extract(var_11, var_3171);
            }
            if (!var_3183) {
            }
            var_3186 = wp::where(var_3183, var_3184, var_3185);
            var_3187 = integer_steps_0(var_3186, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_3183) {
                var_3188 = wp::extract(var_13, var_3171);
            }
            if (!var_3183) {
            }
            var_3190 = wp::where(var_3183, var_3188, var_3189);
            var_3191 = integer_steps_0(var_3190, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_3183) {
                var_3192 = wp::extract(var_15, var_3171);
            }
            if (!var_3183) {
            }
            var_3194 = wp::where(var_3183, var_3192, var_3193);
            var_3195 = integer_steps_0(var_3194, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_3183) {
            }
            if (!var_3183) {
            }
            var_3198 = wp::where(var_3183, var_3196, var_3197);
            var_3199 = wp::int64(var_3198);
            var_3200 = wp::add(var_3155, var_3199);
            // sx += x                                                                        <L 36>
            var_3201 = wp::add(var_3156, var_3187);
            // sy += y                                                                        <L 37>
            var_3202 = wp::add(var_3157, var_3191);
            // sz += z                                                                        <L 38>
            var_3203 = wp::add(var_3158, var_3195);
            // xx += x * x                                                                    <L 39>
            var_3204 = wp::mul(var_3187, var_3187);
            var_3205 = wp::add(var_3160, var_3204);
            // xy += x * y                                                                    <L 40>
            var_3206 = wp::mul(var_3187, var_3191);
            var_3207 = wp::add(var_3162, var_3206);
            // xz += x * z                                                                    <L 41>
            var_3208 = wp::mul(var_3187, var_3195);
            var_3209 = wp::add(var_3164, var_3208);
            // yy += y * y                                                                    <L 42>
            var_3210 = wp::mul(var_3191, var_3191);
            var_3211 = wp::add(var_3166, var_3210);
            // yz += y * z                                                                    <L 43>
            var_3212 = wp::mul(var_3191, var_3195);
            var_3213 = wp::add(var_3168, var_3212);
            // zz += z * z                                                                    <L 44>
            var_3214 = wp::mul(var_3195, var_3195);
            var_3215 = wp::add(var_3170, var_3214);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_3217 = wp::extract(var_11, var_3216);
            var_3218 = wp::extract(var_11, var_3216);
            var_3219 = wp::mul(var_3217, var_3218);
            var_3220 = wp::extract(var_13, var_3216);
            var_3221 = wp::extract(var_13, var_3216);
            var_3222 = wp::mul(var_3220, var_3221);
            var_3223 = wp::add(var_3219, var_3222);
            var_3224 = wp::extract(var_15, var_3216);
            var_3225 = wp::extract(var_15, var_3216);
            var_3226 = wp::mul(var_3224, var_3225);
            var_3227 = wp::add(var_3223, var_3226);
            var_3228 = (var_3227 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_3228) {
                var_3229 = wp::extract(var_11, var_3216);
            }
            if (!var_3228) {
            }
            var_3231 = wp::where(var_3228, var_3229, var_3230);
            var_3232 = integer_steps_0(var_3231, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_3228) {
                var_3233 = wp::extract(var_13, var_3216);
            }
            if (!var_3228) {
            }
            var_3235 = wp::where(var_3228, var_3233, var_3234);
            var_3236 = integer_steps_0(var_3235, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_3228) {
                var_3237 = wp::extract(var_15, var_3216);
            }
            if (!var_3228) {
            }
            var_3239 = wp::where(var_3228, var_3237, var_3238);
            var_3240 = integer_steps_0(var_3239, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_3228) {
            }
            if (!var_3228) {
            }
            var_3243 = wp::where(var_3228, var_3241, var_3242);
            var_3244 = wp::int64(var_3243);
            var_3245 = wp::add(var_3200, var_3244);
            // sx += x                                                                        <L 36>
            var_3246 = wp::add(var_3201, var_3232);
            // sy += y                                                                        <L 37>
            var_3247 = wp::add(var_3202, var_3236);
            // sz += z                                                                        <L 38>
            var_3248 = wp::add(var_3203, var_3240);
            // xx += x * x                                                                    <L 39>
            var_3249 = wp::mul(var_3232, var_3232);
            var_3250 = wp::add(var_3205, var_3249);
            // xy += x * y                                                                    <L 40>
            var_3251 = wp::mul(var_3232, var_3236);
            var_3252 = wp::add(var_3207, var_3251);
            // xz += x * z                                                                    <L 41>
            var_3253 = wp::mul(var_3232, var_3240);
            var_3254 = wp::add(var_3209, var_3253);
            // yy += y * y                                                                    <L 42>
            var_3255 = wp::mul(var_3236, var_3236);
            var_3256 = wp::add(var_3211, var_3255);
            // yz += y * z                                                                    <L 43>
            var_3257 = wp::mul(var_3236, var_3240);
            var_3258 = wp::add(var_3213, var_3257);
            // zz += z * z                                                                    <L 44>
            var_3259 = wp::mul(var_3240, var_3240);
            var_3260 = wp::add(var_3215, var_3259);
        }
        var_3261 = wp::where(var_2737, var_3245, var_2718);
        var_3262 = wp::where(var_2737, var_3246, var_2719);
        var_3263 = wp::where(var_2737, var_3247, var_2720);
        var_3264 = wp::where(var_2737, var_3248, var_2721);
        var_3265 = wp::where(var_2737, var_3250, var_2722);
        var_3266 = wp::where(var_2737, var_3252, var_2723);
        var_3267 = wp::where(var_2737, var_3254, var_2724);
        var_3268 = wp::where(var_2737, var_3256, var_2725);
        var_3269 = wp::where(var_2737, var_3258, var_2726);
        var_3270 = wp::where(var_2737, var_3260, var_2727);
        var_3271 = wp::where(var_2737, var_2740, var_2728);
        var_3272 = wp::where(var_2737, var_3216, var_2729);
        var_3273 = wp::where(var_2737, var_2884, var_2730);
        var_3274 = wp::where(var_2737, var_3228, var_2731);
        var_3275 = wp::where(var_2737, var_3232, var_2732);
        var_3276 = wp::where(var_2737, var_3236, var_2733);
        var_3277 = wp::where(var_2737, var_3240, var_2734);
        // if distances__leaves_within__1[leaf__leaves_within__1] <= max_sqdist:              <L 23>
        var_3279 = wp::extract(var_24, var_3278);
        var_3280 = (var_3279 <= var_max_sqdist);
        if (var_3280) {
            // first = bucket__leaves_within__1 * BUCKET__leaves_within + leaf__leaves_within__1 * LEAF__leaves_within       <L 24>
            var_3281 = wp::mul(var_23, var_28);
            var_3282 = wp::mul(var_3278, var_30);
            var_3283 = wp::add(var_3281, var_3282);
            // for j in range(LEAF):                                                          <L 25>
            // q = tree__points[first + j]                                                    <L 26>
            var_3285 = wp::add(var_3283, var_3284);
            var_3286 = wp::address(var_tree__points, var_3285);
            var_3288 = wp::load(var_3286);
            var_3287 = wp::copy(var_3288);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_3290 = wp::extract(var_3287, var_3289);
            var_3292 = wp::extract(var_p, var_3291);
            var_3293 = wp::sub(var_3290, var_3292);
            wp::assign_inplace(var_11, var_3284, var_3293);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_3295 = wp::extract(var_3287, var_3294);
            var_3297 = wp::extract(var_p, var_3296);
            var_3298 = wp::sub(var_3295, var_3297);
            wp::assign_inplace(var_13, var_3284, var_3298);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_3300 = wp::extract(var_3287, var_3299);
            var_3302 = wp::extract(var_p, var_3301);
            var_3303 = wp::sub(var_3300, var_3302);
            wp::assign_inplace(var_15, var_3284, var_3303);
            // q = tree__points[first + j]                                                    <L 26>
            var_3305 = wp::add(var_3283, var_3304);
            var_3306 = wp::address(var_tree__points, var_3305);
            var_3308 = wp::load(var_3306);
            var_3307 = wp::copy(var_3308);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_3310 = wp::extract(var_3307, var_3309);
            var_3312 = wp::extract(var_p, var_3311);
            var_3313 = wp::sub(var_3310, var_3312);
            wp::assign_inplace(var_11, var_3304, var_3313);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_3315 = wp::extract(var_3307, var_3314);
            var_3317 = wp::extract(var_p, var_3316);
            var_3318 = wp::sub(var_3315, var_3317);
            wp::assign_inplace(var_13, var_3304, var_3318);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_3320 = wp::extract(var_3307, var_3319);
            var_3322 = wp::extract(var_p, var_3321);
            var_3323 = wp::sub(var_3320, var_3322);
            wp::assign_inplace(var_15, var_3304, var_3323);
            // q = tree__points[first + j]                                                    <L 26>
            var_3325 = wp::add(var_3283, var_3324);
            var_3326 = wp::address(var_tree__points, var_3325);
            var_3328 = wp::load(var_3326);
            var_3327 = wp::copy(var_3328);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_3330 = wp::extract(var_3327, var_3329);
            var_3332 = wp::extract(var_p, var_3331);
            var_3333 = wp::sub(var_3330, var_3332);
            wp::assign_inplace(var_11, var_3324, var_3333);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_3335 = wp::extract(var_3327, var_3334);
            var_3337 = wp::extract(var_p, var_3336);
            var_3338 = wp::sub(var_3335, var_3337);
            wp::assign_inplace(var_13, var_3324, var_3338);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_3340 = wp::extract(var_3327, var_3339);
            var_3342 = wp::extract(var_p, var_3341);
            var_3343 = wp::sub(var_3340, var_3342);
            wp::assign_inplace(var_15, var_3324, var_3343);
            // q = tree__points[first + j]                                                    <L 26>
            var_3345 = wp::add(var_3283, var_3344);
            var_3346 = wp::address(var_tree__points, var_3345);
            var_3348 = wp::load(var_3346);
            var_3347 = wp::copy(var_3348);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_3350 = wp::extract(var_3347, var_3349);
            var_3352 = wp::extract(var_p, var_3351);
            var_3353 = wp::sub(var_3350, var_3352);
            wp::assign_inplace(var_11, var_3344, var_3353);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_3355 = wp::extract(var_3347, var_3354);
            var_3357 = wp::extract(var_p, var_3356);
            var_3358 = wp::sub(var_3355, var_3357);
            wp::assign_inplace(var_13, var_3344, var_3358);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_3360 = wp::extract(var_3347, var_3359);
            var_3362 = wp::extract(var_p, var_3361);
            var_3363 = wp::sub(var_3360, var_3362);
            wp::assign_inplace(var_15, var_3344, var_3363);
            // q = tree__points[first + j]                                                    <L 26>
            var_3365 = wp::add(var_3283, var_3364);
            var_3366 = wp::address(var_tree__points, var_3365);
            var_3368 = wp::load(var_3366);
            var_3367 = wp::copy(var_3368);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_3370 = wp::extract(var_3367, var_3369);
            var_3372 = wp::extract(var_p, var_3371);
            var_3373 = wp::sub(var_3370, var_3372);
            wp::assign_inplace(var_11, var_3364, var_3373);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_3375 = wp::extract(var_3367, var_3374);
            var_3377 = wp::extract(var_p, var_3376);
            var_3378 = wp::sub(var_3375, var_3377);
            wp::assign_inplace(var_13, var_3364, var_3378);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_3380 = wp::extract(var_3367, var_3379);
            var_3382 = wp::extract(var_p, var_3381);
            var_3383 = wp::sub(var_3380, var_3382);
            wp::assign_inplace(var_15, var_3364, var_3383);
            // q = tree__points[first + j]                                                    <L 26>
            var_3385 = wp::add(var_3283, var_3384);
            var_3386 = wp::address(var_tree__points, var_3385);
            var_3388 = wp::load(var_3386);
            var_3387 = wp::copy(var_3388);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_3390 = wp::extract(var_3387, var_3389);
            var_3392 = wp::extract(var_p, var_3391);
            var_3393 = wp::sub(var_3390, var_3392);
            wp::assign_inplace(var_11, var_3384, var_3393);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_3395 = wp::extract(var_3387, var_3394);
            var_3397 = wp::extract(var_p, var_3396);
            var_3398 = wp::sub(var_3395, var_3397);
            wp::assign_inplace(var_13, var_3384, var_3398);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_3400 = wp::extract(var_3387, var_3399);
            var_3402 = wp::extract(var_p, var_3401);
            var_3403 = wp::sub(var_3400, var_3402);
            wp::assign_inplace(var_15, var_3384, var_3403);
            // q = tree__points[first + j]                                                    <L 26>
            var_3405 = wp::add(var_3283, var_3404);
            var_3406 = wp::address(var_tree__points, var_3405);
            var_3408 = wp::load(var_3406);
            var_3407 = wp::copy(var_3408);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_3410 = wp::extract(var_3407, var_3409);
            var_3412 = wp::extract(var_p, var_3411);
            var_3413 = wp::sub(var_3410, var_3412);
            wp::assign_inplace(var_11, var_3404, var_3413);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_3415 = wp::extract(var_3407, var_3414);
            var_3417 = wp::extract(var_p, var_3416);
            var_3418 = wp::sub(var_3415, var_3417);
            wp::assign_inplace(var_13, var_3404, var_3418);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_3420 = wp::extract(var_3407, var_3419);
            var_3422 = wp::extract(var_p, var_3421);
            var_3423 = wp::sub(var_3420, var_3422);
            wp::assign_inplace(var_15, var_3404, var_3423);
            // q = tree__points[first + j]                                                    <L 26>
            var_3425 = wp::add(var_3283, var_3424);
            var_3426 = wp::address(var_tree__points, var_3425);
            var_3428 = wp::load(var_3426);
            var_3427 = wp::copy(var_3428);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_3430 = wp::extract(var_3427, var_3429);
            var_3432 = wp::extract(var_p, var_3431);
            var_3433 = wp::sub(var_3430, var_3432);
            wp::assign_inplace(var_11, var_3424, var_3433);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_3435 = wp::extract(var_3427, var_3434);
            var_3437 = wp::extract(var_p, var_3436);
            var_3438 = wp::sub(var_3435, var_3437);
            wp::assign_inplace(var_13, var_3424, var_3438);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_3440 = wp::extract(var_3427, var_3439);
            var_3442 = wp::extract(var_p, var_3441);
            var_3443 = wp::sub(var_3440, var_3442);
            wp::assign_inplace(var_15, var_3424, var_3443);
            // for j in range(LEAF):                                                          <L 30>
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_3445 = wp::extract(var_11, var_3444);
            var_3446 = wp::extract(var_11, var_3444);
            var_3447 = wp::mul(var_3445, var_3446);
            var_3448 = wp::extract(var_13, var_3444);
            var_3449 = wp::extract(var_13, var_3444);
            var_3450 = wp::mul(var_3448, var_3449);
            var_3451 = wp::add(var_3447, var_3450);
            var_3452 = wp::extract(var_15, var_3444);
            var_3453 = wp::extract(var_15, var_3444);
            var_3454 = wp::mul(var_3452, var_3453);
            var_3455 = wp::add(var_3451, var_3454);
            var_3456 = (var_3455 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_3456) {
                var_3457 = wp::extract(var_11, var_3444);
            }
            if (!var_3456) {
            }
            var_3459 = wp::where(var_3456, var_3457, var_3458);
            var_3460 = integer_steps_0(var_3459, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_3456) {
                var_3461 = wp::extract(var_13, var_3444);
            }
            if (!var_3456) {
            }
            var_3463 = wp::where(var_3456, var_3461, var_3462);
            var_3464 = integer_steps_0(var_3463, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_3456) {
                var_3465 = wp::extract(var_15, var_3444);
            }
            if (!var_3456) {
            }
            var_3467 = wp::where(var_3456, var_3465, var_3466);
            var_3468 = integer_steps_0(var_3467, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_3456) {
            }
            if (!var_3456) {
            }
            var_3471 = wp::where(var_3456, var_3469, var_3470);
            var_3472 = wp::int64(var_3471);
            var_3473 = wp::add(var_3261, var_3472);
            // sx += x                                                                        <L 36>
            var_3474 = wp::add(var_3262, var_3460);
            // sy += y                                                                        <L 37>
            var_3475 = wp::add(var_3263, var_3464);
            // sz += z                                                                        <L 38>
            var_3476 = wp::add(var_3264, var_3468);
            // xx += x * x                                                                    <L 39>
            var_3477 = wp::mul(var_3460, var_3460);
            var_3478 = wp::add(var_3265, var_3477);
            // xy += x * y                                                                    <L 40>
            var_3479 = wp::mul(var_3460, var_3464);
            var_3480 = wp::add(var_3266, var_3479);
            // xz += x * z                                                                    <L 41>
            var_3481 = wp::mul(var_3460, var_3468);
            var_3482 = wp::add(var_3267, var_3481);
            // yy += y * y                                                                    <L 42>
            var_3483 = wp::mul(var_3464, var_3464);
            var_3484 = wp::add(var_3268, var_3483);
            // yz += y * z                                                                    <L 43>
            var_3485 = wp::mul(var_3464, var_3468);
            var_3486 = wp::add(var_3269, var_3485);
            // zz += z * z                                                                    <L 44>
            var_3487 = wp::mul(var_3468, var_3468);
            var_3488 = wp::add(var_3270, var_3487);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_3490 = wp::extract(var_11, var_3489);
            var_3491 = wp::extract(var_11, var_3489);
            var_3492 = wp::mul(var_3490, var_3491);
            var_3493 = wp::extract(var_13, var_3489);
            var_3494 = wp::extract(var_13, var_3489);
            var_3495 = wp::mul(var_3493, var_3494);
            var_3496 = wp::add(var_3492, var_3495);
            var_3497 = wp::extract(var_15, var_3489);
            var_3498 = wp::extract(var_15, var_3489);
            var_3499 = wp::mul(var_3497, var_3498);
            var_3500 = wp::add(var_3496, var_3499);
            var_3501 = (var_3500 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_3501) {
                var_3502 = wp::extract(var_11, var_3489);
            }
            if (!var_3501) {
            }
            var_3504 = wp::where(var_3501, var_3502, var_3503);
            var_3505 = integer_steps_0(var_3504, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_3501) {
                var_3506 = wp::extract(var_13, var_3489);
            }
            if (!var_3501) {
            }
            var_3508 = wp::where(var_3501, var_3506, var_3507);
            var_3509 = integer_steps_0(var_3508, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_3501) {
                var_3510 = wp::extract(var_15, var_3489);
            }
            if (!var_3501) {
            }
            var_3512 = wp::where(var_3501, var_3510, var_3511);
            var_3513 = integer_steps_0(var_3512, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_3501) {
            }
            if (!var_3501) {
            }
            var_3516 = wp::where(var_3501, var_3514, var_3515);
            var_3517 = wp::int64(var_3516);
            var_3518 = wp::add(var_3473, var_3517);
            // sx += x                                                                        <L 36>
            var_3519 = wp::add(var_3474, var_3505);
            // sy += y                                                                        <L 37>
            var_3520 = wp::add(var_3475, var_3509);
            // sz += z                                                                        <L 38>
            var_3521 = wp::add(var_3476, var_3513);
            // xx += x * x                                                                    <L 39>
            var_3522 = wp::mul(var_3505, var_3505);
            var_3523 = wp::add(var_3478, var_3522);
            // xy += x * y                                                                    <L 40>
            var_3524 = wp::mul(var_3505, var_3509);
            var_3525 = wp::add(var_3480, var_3524);
            // xz += x * z                                                                    <L 41>
            var_3526 = wp::mul(var_3505, var_3513);
            var_3527 = wp::add(var_3482, var_3526);
            // yy += y * y                                                                    <L 42>
            var_3528 = wp::mul(var_3509, var_3509);
            var_3529 = wp::add(var_3484, var_3528);
            // yz += y * z                                                                    <L 43>
            var_3530 = wp::mul(var_3509, var_3513);
            var_3531 = wp::add(var_3486, var_3530);
            // zz += z * z                                                                    <L 44>
            var_3532 = wp::mul(var_3513, var_3513);
            var_3533 = wp::add(var_3488, var_3532);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_3535 = wp::extract(var_11, var_3534);
            var_3536 = wp::extract(var_11, var_3534);
            var_3537 = wp::mul(var_3535, var_3536);
            var_3538 = wp::extract(var_13, var_3534);
            var_3539 = wp::extract(var_13, var_3534);
            var_3540 = wp::mul(var_3538, var_3539);
            var_3541 = wp::add(var_3537, var_3540);
            var_3542 = wp::extract(var_15, var_3534);
            var_3543 = wp::extract(var_15, var_3534);
            var_3544 = wp::mul(var_3542, var_3543);
            var_3545 = wp::add(var_3541, var_3544);
            var_3546 = (var_3545 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_3546) {
                var_3547 = wp::extract(var_11, var_3534);
            }
            if (!var_3546) {
            }
            var_3549 = wp::where(var_3546, var_3547, var_3548);
            var_3550 = integer_steps_0(var_3549, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_3546) {
                var_3551 = wp::extract(var_13, var_3534);
            }
            if (!var_3546) {
            }
            var_3553 = wp::where(var_3546, var_3551, var_3552);
            var_3554 = integer_steps_0(var_3553, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_3546) {
                var_3555 = wp::extract(var_15, var_3534);
            }
            if (!var_3546) {
            }
            var_3557 = wp::where(var_3546, var_3555, var_3556);
            var_3558 = integer_steps_0(var_3557, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_3546) {
            }
            if (!var_3546) {
            }
            var_3561 = wp::where(var_3546, var_3559, var_3560);
            var_3562 = wp::int64(var_3561);
            var_3563 = wp::add(var_3518, var_3562);
            // sx += x                                                                        <L 36>
            var_3564 = wp::add(var_3519, var_3550);
            // sy += y                                                                        <L 37>
            var_3565 = wp::add(var_3520, var_3554);
            // sz += z                                                                        <L 38>
            var_3566 = wp::add(var_3521, var_3558);
            // xx += x * x                                                                    <L 39>
            var_3567 = wp::mul(var_3550, var_3550);
            var_3568 = wp::add(var_3523, var_3567);
            // xy += x * y                                                                    <L 40>
            var_3569 = wp::mul(var_3550, var_3554);
            var_3570 = wp::add(var_3525, var_3569);
            // xz += x * z                                                                    <L 41>
            var_3571 = wp::mul(var_3550, var_3558);
            var_3572 = wp::add(var_3527, var_3571);
            // yy += y * y                                                                    <L 42>
            var_3573 = wp::mul(var_3554, var_3554);
            var_3574 = wp::add(var_3529, var_3573);
            // yz += y * z                                                                    <L 43>
            var_3575 = wp::mul(var_3554, var_3558);
            var_3576 = wp::add(var_3531, var_3575);
            // zz += z * z                                                                    <L 44>
            var_3577 = wp::mul(var_3558, var_3558);
            var_3578 = wp::add(var_3533, var_3577);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_3580 = wp::extract(var_11, var_3579);
            var_3581 = wp::extract(var_11, var_3579);
            var_3582 = wp::mul(var_3580, var_3581);
            var_3583 = wp::extract(var_13, var_3579);
            var_3584 = wp::extract(var_13, var_3579);
            var_3585 = wp::mul(var_3583, var_3584);
            var_3586 = wp::add(var_3582, var_3585);
            var_3587 = wp::extract(var_15, var_3579);
            var_3588 = wp::extract(var_15, var_3579);
            var_3589 = wp::mul(var_3587, var_3588);
            var_3590 = wp::add(var_3586, var_3589);
            var_3591 = (var_3590 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_3591) {
                var_3592 = wp::extract(var_11, var_3579);
            }
            if (!var_3591) {
            }
            var_3594 = wp::where(var_3591, var_3592, var_3593);
            var_3595 = integer_steps_0(var_3594, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_3591) {
                var_3596 = wp::extract(var_13, var_3579);
            }
            if (!var_3591) {
            }
            var_3598 = wp::where(var_3591, var_3596, var_3597);
            var_3599 = integer_steps_0(var_3598, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_3591) {
                var_3600 = wp::extract(var_15, var_3579);
            }
            if (!var_3591) {
            }
            var_3602 = wp::where(var_3591, var_3600, var_3601);
            var_3603 = integer_steps_0(var_3602, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_3591) {
            }
            if (!var_3591) {
            }
            var_3606 = wp::where(var_3591, var_3604, var_3605);
            var_3607 = wp::int64(var_3606);
            var_3608 = wp::add(var_3563, var_3607);
            // sx += x                                                                        <L 36>
            var_3609 = wp::add(var_3564, var_3595);
            // sy += y                                                                        <L 37>
            var_3610 = wp::add(var_3565, var_3599);
            // sz += z                                                                        <L 38>
            var_3611 = wp::add(var_3566, var_3603);
            // xx += x * x                                                                    <L 39>
            var_3612 = wp::mul(var_3595, var_3595);
            var_3613 = wp::add(var_3568, var_3612);
            // xy += x * y                                                                    <L 40>
            var_3614 = wp::mul(var_3595, var_3599);
            var_3615 = wp::add(var_3570, var_3614);
            // xz += x * z                                                                    <L 41>
            var_3616 = wp::mul(var_3595, var_3603);
            var_3617 = wp::add(var_3572, var_3616);
            // yy += y * y                                                                    <L 42>
            var_3618 = wp::mul(var_3599, var_3599);
            var_3619 = wp::add(var_3574, var_3618);
            // yz += y * z                                                                    <L 43>
            var_3620 = wp::mul(var_3599, var_3603);
            var_3621 = wp::add(var_3576, var_3620);
            // zz += z * z                                                                    <L 44>
            var_3622 = wp::mul(var_3603, var_3603);
            var_3623 = wp::add(var_3578, var_3622);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_3625 = wp::extract(var_11, var_3624);
            var_3626 = wp::extract(var_11, var_3624);
            var_3627 = wp::mul(var_3625, var_3626);
            var_3628 = wp::extract(var_13, var_3624);
            var_3629 = wp::extract(var_13, var_3624);
            var_3630 = wp::mul(var_3628, var_3629);
            var_3631 = wp::add(var_3627, var_3630);
            var_3632 = wp::extract(var_15, var_3624);
            var_3633 = wp::extract(var_15, var_3624);
            var_3634 = wp::mul(var_3632, var_3633);
            var_3635 = wp::add(var_3631, var_3634);
            var_3636 = (var_3635 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_3636) {
                var_3637 = wp::extract(var_11, var_3624);
            }
            if (!var_3636) {
            }
            var_3639 = wp::where(var_3636, var_3637, var_3638);
            var_3640 = integer_steps_0(var_3639, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_3636) {
                var_3641 = wp::extract(var_13, var_3624);
            }
            if (!var_3636) {
            }
            var_3643 = wp::where(var_3636, var_3641, var_3642);
            var_3644 = integer_steps_0(var_3643, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_3636) {
                var_3645 = wp::extract(var_15, var_3624);
            }
            if (!var_3636) {
            }
            var_3647 = wp::where(var_3636, var_3645, var_3646);
            var_3648 = integer_steps_0(var_3647, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_3636) {
            }
            if (!var_3636) {
            }
            var_3651 = wp::where(var_3636, var_3649, var_3650);
            var_3652 = wp::int64(var_3651);
            var_3653 = wp::add(var_3608, var_3652);
            // sx += x                                                                        <L 36>
            var_3654 = wp::add(var_3609, var_3640);
            // sy += y                                                                        <L 37>
            var_3655 = wp::add(var_3610, var_3644);
            // sz += z                                                                        <L 38>
            var_3656 = wp::add(var_3611, var_3648);
            // xx += x * x                                                                    <L 39>
            var_3657 = wp::mul(var_3640, var_3640);
            var_3658 = wp::add(var_3613, var_3657);
            // xy += x * y                                                                    <L 40>
            var_3659 = wp::mul(var_3640, var_3644);
            var_3660 = wp::add(var_3615, var_3659);
            // xz += x * z                                                                    <L 41>
            var_3661 = wp::mul(var_3640, var_3648);
            var_3662 = wp::add(var_3617, var_3661);
            // yy += y * y                                                                    <L 42>
            var_3663 = wp::mul(var_3644, var_3644);
            var_3664 = wp::add(var_3619, var_3663);
            // yz += y * z                                                                    <L 43>
            var_3665 = wp::mul(var_3644, var_3648);
            var_3666 = wp::add(var_3621, var_3665);
            // zz += z * z                                                                    <L 44>
            var_3667 = wp::mul(var_3648, var_3648);
            var_3668 = wp::add(var_3623, var_3667);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_3670 = wp::extract(var_11, var_3669);
            var_3671 = wp::extract(var_11, var_3669);
            var_3672 = wp::mul(var_3670, var_3671);
            var_3673 = wp::extract(var_13, var_3669);
            var_3674 = wp::extract(var_13, var_3669);
            var_3675 = wp::mul(var_3673, var_3674);
            var_3676 = wp::add(var_3672, var_3675);
            var_3677 = wp::extract(var_15, var_3669);
            var_3678 = wp::extract(var_15, var_3669);
            var_3679 = wp::mul(var_3677, var_3678);
            var_3680 = wp::add(var_3676, var_3679);
            var_3681 = (var_3680 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_3681) {
                var_3682 = wp::extract(var_11, var_3669);
            }
            if (!var_3681) {
            }
            var_3684 = wp::where(var_3681, var_3682, var_3683);
            var_3685 = integer_steps_0(var_3684, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_3681) {
                var_3686 = wp::extract(var_13, var_3669);
            }
            if (!var_3681) {
            }
            var_3688 = wp::where(var_3681, var_3686, var_3687);
            var_3689 = integer_steps_0(var_3688, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_3681) {
                var_3690 = wp::extract(var_15, var_3669);
            }
            if (!var_3681) {
            }
            var_3692 = wp::where(var_3681, var_3690, var_3691);
            var_3693 = integer_steps_0(var_3692, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_3681) {
            }
            if (!var_3681) {
            }
            var_3696 = wp::where(var_3681, var_3694, var_3695);
            var_3697 = wp::int64(var_3696);
            var_3698 = wp::add(var_3653, var_3697);
            // sx += x                                                                        <L 36>
            var_3699 = wp::add(var_3654, var_3685);
            // sy += y                                                                        <L 37>
            var_3700 = wp::add(var_3655, var_3689);
            // sz += z                                                                        <L 38>
            var_3701 = wp::add(var_3656, var_3693);
            // xx += x * x                                                                    <L 39>
            var_3702 = wp::mul(var_3685, var_3685);
            var_3703 = wp::add(var_3658, var_3702);
            // xy += x * y                                                                    <L 40>
            var_3704 = wp::mul(var_3685, var_3689);
            var_3705 = wp::add(var_3660, var_3704);
            // xz += x * z                                                                    <L 41>
            var_3706 = wp::mul(var_3685, var_3693);
            var_3707 = wp::add(var_3662, var_3706);
            // yy += y * y                                                                    <L 42>
            var_3708 = wp::mul(var_3689, var_3689);
            var_3709 = wp::add(var_3664, var_3708);
            // yz += y * z                                                                    <L 43>
            var_3710 = wp::mul(var_3689, var_3693);
            var_3711 = wp::add(var_3666, var_3710);
            // zz += z * z                                                                    <L 44>
            var_3712 = wp::mul(var_3693, var_3693);
            var_3713 = wp::add(var_3668, var_3712);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_3715 = wp::extract(var_11, var_3714);
            var_3716 = wp::extract(var_11, var_3714);
            var_3717 = wp::mul(var_3715, var_3716);
            var_3718 = wp::extract(var_13, var_3714);
            var_3719 = wp::extract(var_13, var_3714);
            var_3720 = wp::mul(var_3718, var_3719);
            var_3721 = wp::add(var_3717, var_3720);
            var_3722 = wp::extract(var_15, var_3714);
            var_3723 = wp::extract(var_15, var_3714);
            var_3724 = wp::mul(var_3722, var_3723);
            var_3725 = wp::add(var_3721, var_3724);
            var_3726 = (var_3725 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_3726) {
                var_3727 = wp::extract(var_11, var_3714);
            }
            if (!var_3726) {
            }
            var_3729 = wp::where(var_3726, var_3727, var_3728);
            var_3730 = integer_steps_0(var_3729, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_3726) {
                var_3731 = wp::extract(var_13, var_3714);
            }
            if (!var_3726) {
            }
            var_3733 = wp::where(var_3726, var_3731, var_3732);
            var_3734 = integer_steps_0(var_3733, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_3726) {
                var_3735 = wp::extract(var_15, var_3714);
            }
            if (!var_3726) {
            }
            var_3737 = wp::where(var_3726, var_3735, var_3736);
            var_3738 = integer_steps_0(var_3737, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_3726) {
            }
            if (!var_3726) {
            }
            var_3741 = wp::where(var_3726, var_3739, var_3740);
            var_3742 = wp::int64(var_3741);
            var_3743 = wp::add(var_3698, var_3742);
            // sx += x                                                                        <L 36>
            var_3744 = wp::add(var_3699, var_3730);
            // sy += y                                                                        <L 37>
            var_3745 = wp::add(var_3700, var_3734);
            // sz += z                                                                        <L 38>
            var_3746 = wp::add(var_3701, var_3738);
            // xx += x * x                                                                    <L 39>
            var_3747 = wp::mul(var_3730, var_3730);
            var_3748 = wp::add(var_3703, var_3747);
            // xy += x * y                                                                    <L 40>
            var_3749 = wp::mul(var_3730, var_3734);
            var_3750 = wp::add(var_3705, var_3749);
            // xz += x * z                                                                    <L 41>
            var_3751 = wp::mul(var_3730, var_3738);
            var_3752 = wp::add(var_3707, var_3751);
            // yy += y * y                                                                    <L 42>
            var_3753 = wp::mul(var_3734, var_3734);
            var_3754 = wp::add(var_3709, var_3753);
            // yz += y * z                                                                    <L 43>
            var_3755 = wp::mul(var_3734, var_3738);
            var_3756 = wp::add(var_3711, var_3755);
            // zz += z * z                                                                    <L 44>
            var_3757 = wp::mul(var_3738, var_3738);
            var_3758 = wp::add(var_3713, var_3757);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_3760 = wp::extract(var_11, var_3759);
            var_3761 = wp::extract(var_11, var_3759);
            var_3762 = wp::mul(var_3760, var_3761);
            var_3763 = wp::extract(var_13, var_3759);
            var_3764 = wp::extract(var_13, var_3759);
            var_3765 = wp::mul(var_3763, var_3764);
            var_3766 = wp::add(var_3762, var_3765);
            var_3767 = wp::extract(var_15, var_3759);
            var_3768 = wp::extract(var_15, var_3759);
            var_3769 = wp::mul(var_3767, var_3768);
            var_3770 = wp::add(var_3766, var_3769);
            var_3771 = (var_3770 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_3771) {
                var_3772 = wp::extract(var_11, var_3759);
            }
            if (!var_3771) {
            }
            var_3774 = wp::where(var_3771, var_3772, var_3773);
            var_3775 = integer_steps_0(var_3774, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_3771) {
                var_3776 = wp::extract(var_13, var_3759);
            }
            if (!var_3771) {
            }
            var_3778 = wp::where(var_3771, var_3776, var_3777);
            var_3779 = integer_steps_0(var_3778, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_3771) {
                var_3780 = wp::extract(var_15, var_3759);
            }
            if (!var_3771) {
            }
            var_3782 = wp::where(var_3771, var_3780, var_3781);
            var_3783 = integer_steps_0(var_3782, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_3771) {
            }
            if (!var_3771) {
            }
            var_3786 = wp::where(var_3771, var_3784, var_3785);
            var_3787 = wp::int64(var_3786);
            var_3788 = wp::add(var_3743, var_3787);
            // sx += x                                                                        <L 36>
            var_3789 = wp::add(var_3744, var_3775);
            // sy += y                                                                        <L 37>
            var_3790 = wp::add(var_3745, var_3779);
            // sz += z                                                                        <L 38>
            var_3791 = wp::add(var_3746, var_3783);
            // xx += x * x                                                                    <L 39>
            var_3792 = wp::mul(var_3775, var_3775);
            var_3793 = wp::add(var_3748, var_3792);
            // xy += x * y                                                                    <L 40>
            var_3794 = wp::mul(var_3775, var_3779);
            var_3795 = wp::add(var_3750, var_3794);
            // xz += x * z                                                                    <L 41>
            var_3796 = wp::mul(var_3775, var_3783);
            var_3797 = wp::add(var_3752, var_3796);
            // yy += y * y                                                                    <L 42>
            var_3798 = wp::mul(var_3779, var_3779);
            var_3799 = wp::add(var_3754, var_3798);
            // yz += y * z                                                                    <L 43>
            var_3800 = wp::mul(var_3779, var_3783);
            var_3801 = wp::add(var_3756, var_3800);
            // zz += z * z                                                                    <L 44>
            var_3802 = wp::mul(var_3783, var_3783);
            var_3803 = wp::add(var_3758, var_3802);
        }
        var_3804 = wp::where(var_3280, var_3788, var_3261);
        var_3805 = wp::where(var_3280, var_3789, var_3262);
        var_3806 = wp::where(var_3280, var_3790, var_3263);
        var_3807 = wp::where(var_3280, var_3791, var_3264);
        var_3808 = wp::where(var_3280, var_3793, var_3265);
        var_3809 = wp::where(var_3280, var_3795, var_3266);
        var_3810 = wp::where(var_3280, var_3797, var_3267);
        var_3811 = wp::where(var_3280, var_3799, var_3268);
        var_3812 = wp::where(var_3280, var_3801, var_3269);
        var_3813 = wp::where(var_3280, var_3803, var_3270);
        var_3814 = wp::where(var_3280, var_3283, var_3271);
        var_3815 = wp::where(var_3280, var_3759, var_3272);
        var_3816 = wp::where(var_3280, var_3427, var_3273);
        var_3817 = wp::where(var_3280, var_3771, var_3274);
        var_3818 = wp::where(var_3280, var_3775, var_3275);
        var_3819 = wp::where(var_3280, var_3779, var_3276);
        var_3820 = wp::where(var_3280, var_3783, var_3277);
        // if distances__leaves_within__1[leaf__leaves_within__1] <= max_sqdist:              <L 23>
        var_3822 = wp::extract(var_24, var_3821);
        var_3823 = (var_3822 <= var_max_sqdist);
        if (var_3823) {
            // first = bucket__leaves_within__1 * BUCKET__leaves_within + leaf__leaves_within__1 * LEAF__leaves_within       <L 24>
            var_3824 = wp::mul(var_23, var_28);
            var_3825 = wp::mul(var_3821, var_30);
            var_3826 = wp::add(var_3824, var_3825);
            // for j in range(LEAF):                                                          <L 25>
            // q = tree__points[first + j]                                                    <L 26>
            var_3828 = wp::add(var_3826, var_3827);
            var_3829 = wp::address(var_tree__points, var_3828);
            var_3831 = wp::load(var_3829);
            var_3830 = wp::copy(var_3831);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_3833 = wp::extract(var_3830, var_3832);
            var_3835 = wp::extract(var_p, var_3834);
            var_3836 = wp::sub(var_3833, var_3835);
            wp::assign_inplace(var_11, var_3827, var_3836);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_3838 = wp::extract(var_3830, var_3837);
            var_3840 = wp::extract(var_p, var_3839);
            var_3841 = wp::sub(var_3838, var_3840);
            wp::assign_inplace(var_13, var_3827, var_3841);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_3843 = wp::extract(var_3830, var_3842);
            var_3845 = wp::extract(var_p, var_3844);
            var_3846 = wp::sub(var_3843, var_3845);
            wp::assign_inplace(var_15, var_3827, var_3846);
            // q = tree__points[first + j]                                                    <L 26>
            var_3848 = wp::add(var_3826, var_3847);
            var_3849 = wp::address(var_tree__points, var_3848);
            var_3851 = wp::load(var_3849);
            var_3850 = wp::copy(var_3851);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_3853 = wp::extract(var_3850, var_3852);
            var_3855 = wp::extract(var_p, var_3854);
            var_3856 = wp::sub(var_3853, var_3855);
            wp::assign_inplace(var_11, var_3847, var_3856);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_3858 = wp::extract(var_3850, var_3857);
            var_3860 = wp::extract(var_p, var_3859);
            var_3861 = wp::sub(var_3858, var_3860);
            wp::assign_inplace(var_13, var_3847, var_3861);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_3863 = wp::extract(var_3850, var_3862);
            var_3865 = wp::extract(var_p, var_3864);
            var_3866 = wp::sub(var_3863, var_3865);
            wp::assign_inplace(var_15, var_3847, var_3866);
            // q = tree__points[first + j]                                                    <L 26>
            var_3868 = wp::add(var_3826, var_3867);
            var_3869 = wp::address(var_tree__points, var_3868);
            var_3871 = wp::load(var_3869);
            var_3870 = wp::copy(var_3871);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_3873 = wp::extract(var_3870, var_3872);
            var_3875 = wp::extract(var_p, var_3874);
            var_3876 = wp::sub(var_3873, var_3875);
            wp::assign_inplace(var_11, var_3867, var_3876);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_3878 = wp::extract(var_3870, var_3877);
            var_3880 = wp::extract(var_p, var_3879);
            var_3881 = wp::sub(var_3878, var_3880);
            wp::assign_inplace(var_13, var_3867, var_3881);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_3883 = wp::extract(var_3870, var_3882);
            var_3885 = wp::extract(var_p, var_3884);
            var_3886 = wp::sub(var_3883, var_3885);
            wp::assign_inplace(var_15, var_3867, var_3886);
            // q = tree__points[first + j]                                                    <L 26>
            var_3888 = wp::add(var_3826, var_3887);
            var_3889 = wp::address(var_tree__points, var_3888);
            var_3891 = wp::load(var_3889);
            var_3890 = wp::copy(var_3891);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_3893 = wp::extract(var_3890, var_3892);
            var_3895 = wp::extract(var_p, var_3894);
            var_3896 = wp::sub(var_3893, var_3895);
            wp::assign_inplace(var_11, var_3887, var_3896);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_3898 = wp::extract(var_3890, var_3897);
            var_3900 = wp::extract(var_p, var_3899);
            var_3901 = wp::sub(var_3898, var_3900);
            wp::assign_inplace(var_13, var_3887, var_3901);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_3903 = wp::extract(var_3890, var_3902);
            var_3905 = wp::extract(var_p, var_3904);
            var_3906 = wp::sub(var_3903, var_3905);
            wp::assign_inplace(var_15, var_3887, var_3906);
            // q = tree__points[first + j]                                                    <L 26>
            var_3908 = wp::add(var_3826, var_3907);
            var_3909 = wp::address(var_tree__points, var_3908);
            var_3911 = wp::load(var_3909);
            var_3910 = wp::copy(var_3911);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_3913 = wp::extract(var_3910, var_3912);
            var_3915 = wp::extract(var_p, var_3914);
            var_3916 = wp::sub(var_3913, var_3915);
            wp::assign_inplace(var_11, var_3907, var_3916);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_3918 = wp::extract(var_3910, var_3917);
            var_3920 = wp::extract(var_p, var_3919);
            var_3921 = wp::sub(var_3918, var_3920);
            wp::assign_inplace(var_13, var_3907, var_3921);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_3923 = wp::extract(var_3910, var_3922);
            var_3925 = wp::extract(var_p, var_3924);
            var_3926 = wp::sub(var_3923, var_3925);
            wp::assign_inplace(var_15, var_3907, var_3926);
            // q = tree__points[first + j]                                                    <L 26>
            var_3928 = wp::add(var_3826, var_3927);
            var_3929 = wp::address(var_tree__points, var_3928);
            var_3931 = wp::load(var_3929);
            var_3930 = wp::copy(var_3931);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_3933 = wp::extract(var_3930, var_3932);
            var_3935 = wp::extract(var_p, var_3934);
            var_3936 = wp::sub(var_3933, var_3935);
            wp::assign_inplace(var_11, var_3927, var_3936);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_3938 = wp::extract(var_3930, var_3937);
            var_3940 = wp::extract(var_p, var_3939);
            var_3941 = wp::sub(var_3938, var_3940);
            wp::assign_inplace(var_13, var_3927, var_3941);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_3943 = wp::extract(var_3930, var_3942);
            var_3945 = wp::extract(var_p, var_3944);
            var_3946 = wp::sub(var_3943, var_3945);
            wp::assign_inplace(var_15, var_3927, var_3946);
            // q = tree__points[first + j]                                                    <L 26>
            var_3948 = wp::add(var_3826, var_3947);
            var_3949 = wp::address(var_tree__points, var_3948);
            var_3951 = wp::load(var_3949);
            var_3950 = wp::copy(var_3951);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_3953 = wp::extract(var_3950, var_3952);
            var_3955 = wp::extract(var_p, var_3954);
            var_3956 = wp::sub(var_3953, var_3955);
            wp::assign_inplace(var_11, var_3947, var_3956);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_3958 = wp::extract(var_3950, var_3957);
            var_3960 = wp::extract(var_p, var_3959);
            var_3961 = wp::sub(var_3958, var_3960);
            wp::assign_inplace(var_13, var_3947, var_3961);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_3963 = wp::extract(var_3950, var_3962);
            var_3965 = wp::extract(var_p, var_3964);
            var_3966 = wp::sub(var_3963, var_3965);
            wp::assign_inplace(var_15, var_3947, var_3966);
            // q = tree__points[first + j]                                                    <L 26>
            var_3968 = wp::add(var_3826, var_3967);
            var_3969 = wp::address(var_tree__points, var_3968);
            var_3971 = wp::load(var_3969);
            var_3970 = wp::copy(var_3971);
            // xs[j] = q[0] - p[0]                                                            <L 27>
            var_3973 = wp::extract(var_3970, var_3972);
            var_3975 = wp::extract(var_p, var_3974);
            var_3976 = wp::sub(var_3973, var_3975);
            wp::assign_inplace(var_11, var_3967, var_3976);
            // ys[j] = q[1] - p[1]                                                            <L 28>
            var_3978 = wp::extract(var_3970, var_3977);
            var_3980 = wp::extract(var_p, var_3979);
            var_3981 = wp::sub(var_3978, var_3980);
            wp::assign_inplace(var_13, var_3967, var_3981);
            // zs[j] = q[2] - p[2]                                                            <L 29>
            var_3983 = wp::extract(var_3970, var_3982);
            var_3985 = wp::extract(var_p, var_3984);
            var_3986 = wp::sub(var_3983, var_3985);
            wp::assign_inplace(var_15, var_3967, var_3986);
            // for j in range(LEAF):                                                          <L 30>
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_3988 = wp::extract(var_11, var_3987);
            var_3989 = wp::extract(var_11, var_3987);
            var_3990 = wp::mul(var_3988, var_3989);
            var_3991 = wp::extract(var_13, var_3987);
            var_3992 = wp::extract(var_13, var_3987);
            var_3993 = wp::mul(var_3991, var_3992);
            var_3994 = wp::add(var_3990, var_3993);
            var_3995 = wp::extract(var_15, var_3987);
            var_3996 = wp::extract(var_15, var_3987);
            var_3997 = wp::mul(var_3995, var_3996);
            var_3998 = wp::add(var_3994, var_3997);
            var_3999 = (var_3998 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_3999) {
                var_4000 = wp::extract(var_11, var_3987);
            }
            if (!var_3999) {
            }
            var_4002 = wp::where(var_3999, var_4000, var_4001);
            var_4003 = integer_steps_0(var_4002, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_3999) {
                var_4004 = wp::extract(var_13, var_3987);
            }
            if (!var_3999) {
            }
            var_4006 = wp::where(var_3999, var_4004, var_4005);
            var_4007 = integer_steps_0(var_4006, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_3999) {
                var_4008 = wp::extract(var_15, var_3987);
            }
            if (!var_3999) {
            }
            var_4010 = wp::where(var_3999, var_4008, var_4009);
            var_4011 = integer_steps_0(var_4010, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_3999) {
            }
            if (!var_3999) {
            }
            var_4014 = wp::where(var_3999, var_4012, var_4013);
            var_4015 = wp::int64(var_4014);
            var_4016 = wp::add(var_3804, var_4015);
            // sx += x                                                                        <L 36>
            var_4017 = wp::add(var_3805, var_4003);
            // sy += y                                                                        <L 37>
            var_4018 = wp::add(var_3806, var_4007);
            // sz += z                                                                        <L 38>
            var_4019 = wp::add(var_3807, var_4011);
            // xx += x * x                                                                    <L 39>
            var_4020 = wp::mul(var_4003, var_4003);
            var_4021 = wp::add(var_3808, var_4020);
            // xy += x * y                                                                    <L 40>
            var_4022 = wp::mul(var_4003, var_4007);
            var_4023 = wp::add(var_3809, var_4022);
            // xz += x * z                                                                    <L 41>
            var_4024 = wp::mul(var_4003, var_4011);
            var_4025 = wp::add(var_3810, var_4024);
            // yy += y * y                                                                    <L 42>
            var_4026 = wp::mul(var_4007, var_4007);
            var_4027 = wp::add(var_3811, var_4026);
            // yz += y * z                                                                    <L 43>
            var_4028 = wp::mul(var_4007, var_4011);
            var_4029 = wp::add(var_3812, var_4028);
            // zz += z * z                                                                    <L 44>
            var_4030 = wp::mul(var_4011, var_4011);
            var_4031 = wp::add(var_3813, var_4030);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_4033 = wp::extract(var_11, var_4032);
            var_4034 = wp::extract(var_11, var_4032);
            var_4035 = wp::mul(var_4033, var_4034);
            var_4036 = wp::extract(var_13, var_4032);
            var_4037 = wp::extract(var_13, var_4032);
            var_4038 = wp::mul(var_4036, var_4037);
            var_4039 = wp::add(var_4035, var_4038);
            var_4040 = wp::extract(var_15, var_4032);
            var_4041 = wp::extract(var_15, var_4032);
            var_4042 = wp::mul(var_4040, var_4041);
            var_4043 = wp::add(var_4039, var_4042);
            var_4044 = (var_4043 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_4044) {
                var_4045 = wp::extract(var_11, var_4032);
            }
            if (!var_4044) {
            }
            var_4047 = wp::where(var_4044, var_4045, var_4046);
            var_4048 = integer_steps_0(var_4047, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_4044) {
                var_4049 = wp::extract(var_13, var_4032);
            }
            if (!var_4044) {
            }
            var_4051 = wp::where(var_4044, var_4049, var_4050);
            var_4052 = integer_steps_0(var_4051, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_4044) {
                var_4053 = wp::extract(var_15, var_4032);
            }
            if (!var_4044) {
            }
            var_4055 = wp::where(var_4044, var_4053, var_4054);
            var_4056 = integer_steps_0(var_4055, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_4044) {
            }
            if (!var_4044) {
            }
            var_4059 = wp::where(var_4044, var_4057, var_4058);
            var_4060 = wp::int64(var_4059);
            var_4061 = wp::add(var_4016, var_4060);
            // sx += x                                                                        <L 36>
            var_4062 = wp::add(var_4017, var_4048);
            // sy += y                                                                        <L 37>
            var_4063 = wp::add(var_4018, var_4052);
            // sz += z                                                                        <L 38>
            var_4064 = wp::add(var_4019, var_4056);
            // xx += x * x                                                                    <L 39>
            var_4065 = wp::mul(var_4048, var_4048);
            var_4066 = wp::add(var_4021, var_4065);
            // xy += x * y                                                                    <L 40>
            var_4067 = wp::mul(var_4048, var_4052);
            var_4068 = wp::add(var_4023, var_4067);
            // xz += x * z                                                                    <L 41>
            var_4069 = wp::mul(var_4048, var_4056);
            var_4070 = wp::add(var_4025, var_4069);
            // yy += y * y                                                                    <L 42>
            var_4071 = wp::mul(var_4052, var_4052);
            var_4072 = wp::add(var_4027, var_4071);
            // yz += y * z                                                                    <L 43>
            var_4073 = wp::mul(var_4052, var_4056);
            var_4074 = wp::add(var_4029, var_4073);
            // zz += z * z                                                                    <L 44>
            var_4075 = wp::mul(var_4056, var_4056);
            var_4076 = wp::add(var_4031, var_4075);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_4078 = wp::extract(var_11, var_4077);
            var_4079 = wp::extract(var_11, var_4077);
            var_4080 = wp::mul(var_4078, var_4079);
            var_4081 = wp::extract(var_13, var_4077);
            var_4082 = wp::extract(var_13, var_4077);
            var_4083 = wp::mul(var_4081, var_4082);
            var_4084 = wp::add(var_4080, var_4083);
            var_4085 = wp::extract(var_15, var_4077);
            var_4086 = wp::extract(var_15, var_4077);
            var_4087 = wp::mul(var_4085, var_4086);
            var_4088 = wp::add(var_4084, var_4087);
            var_4089 = (var_4088 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_4089) {
                var_4090 = wp::extract(var_11, var_4077);
            }
            if (!var_4089) {
            }
            var_4092 = wp::where(var_4089, var_4090, var_4091);
            var_4093 = integer_steps_0(var_4092, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_4089) {
                var_4094 = wp::extract(var_13, var_4077);
            }
            if (!var_4089) {
            }
            var_4096 = wp::where(var_4089, var_4094, var_4095);
            var_4097 = integer_steps_0(var_4096, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_4089) {
                var_4098 = wp::extract(var_15, var_4077);
            }
            if (!var_4089) {
            }
            var_4100 = wp::where(var_4089, var_4098, var_4099);
            var_4101 = integer_steps_0(var_4100, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_4089) {
            }
            if (!var_4089) {
            }
            var_4104 = wp::where(var_4089, var_4102, var_4103);
            var_4105 = wp::int64(var_4104);
            var_4106 = wp::add(var_4061, var_4105);
            // sx += x                                                                        <L 36>
            var_4107 = wp::add(var_4062, var_4093);
            // sy += y                                                                        <L 37>
            var_4108 = wp::add(var_4063, var_4097);
            // sz += z                                                                        <L 38>
            var_4109 = wp::add(var_4064, var_4101);
            // xx += x * x                                                                    <L 39>
            var_4110 = wp::mul(var_4093, var_4093);
            var_4111 = wp::add(var_4066, var_4110);
            // xy += x * y                                                                    <L 40>
            var_4112 = wp::mul(var_4093, var_4097);
            var_4113 = wp::add(var_4068, var_4112);
            // xz += x * z                                                                    <L 41>
            var_4114 = wp::mul(var_4093, var_4101);
            var_4115 = wp::add(var_4070, var_4114);
            // yy += y * y                                                                    <L 42>
            var_4116 = wp::mul(var_4097, var_4097);
            var_4117 = wp::add(var_4072, var_4116);
            // yz += y * z                                                                    <L 43>
            var_4118 = wp::mul(var_4097, var_4101);
            var_4119 = wp::add(var_4074, var_4118);
            // zz += z * z                                                                    <L 44>
            var_4120 = wp::mul(var_4101, var_4101);
            var_4121 = wp::add(var_4076, var_4120);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_4123 = wp::extract(var_11, var_4122);
            var_4124 = wp::extract(var_11, var_4122);
            var_4125 = wp::mul(var_4123, var_4124);
            var_4126 = wp::extract(var_13, var_4122);
            var_4127 = wp::extract(var_13, var_4122);
            var_4128 = wp::mul(var_4126, var_4127);
            var_4129 = wp::add(var_4125, var_4128);
            var_4130 = wp::extract(var_15, var_4122);
            var_4131 = wp::extract(var_15, var_4122);
            var_4132 = wp::mul(var_4130, var_4131);
            var_4133 = wp::add(var_4129, var_4132);
            var_4134 = (var_4133 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_4134) {
                var_4135 = wp::extract(var_11, var_4122);
            }
            if (!var_4134) {
            }
            var_4137 = wp::where(var_4134, var_4135, var_4136);
            var_4138 = integer_steps_0(var_4137, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_4134) {
                var_4139 = wp::extract(var_13, var_4122);
            }
            if (!var_4134) {
            }
            var_4141 = wp::where(var_4134, var_4139, var_4140);
            var_4142 = integer_steps_0(var_4141, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_4134) {
                var_4143 = wp::extract(var_15, var_4122);
            }
            if (!var_4134) {
            }
            var_4145 = wp::where(var_4134, var_4143, var_4144);
            var_4146 = integer_steps_0(var_4145, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_4134) {
            }
            if (!var_4134) {
            }
            var_4149 = wp::where(var_4134, var_4147, var_4148);
            var_4150 = wp::int64(var_4149);
            var_4151 = wp::add(var_4106, var_4150);
            // sx += x                                                                        <L 36>
            var_4152 = wp::add(var_4107, var_4138);
            // sy += y                                                                        <L 37>
            var_4153 = wp::add(var_4108, var_4142);
            // sz += z                                                                        <L 38>
            var_4154 = wp::add(var_4109, var_4146);
            // xx += x * x                                                                    <L 39>
            var_4155 = wp::mul(var_4138, var_4138);
            var_4156 = wp::add(var_4111, var_4155);
            // xy += x * y                                                                    <L 40>
            var_4157 = wp::mul(var_4138, var_4142);
            var_4158 = wp::add(var_4113, var_4157);
            // xz += x * z                                                                    <L 41>
            var_4159 = wp::mul(var_4138, var_4146);
            var_4160 = wp::add(var_4115, var_4159);
            // yy += y * y                                                                    <L 42>
            var_4161 = wp::mul(var_4142, var_4142);
            var_4162 = wp::add(var_4117, var_4161);
            // yz += y * z                                                                    <L 43>
            var_4163 = wp::mul(var_4142, var_4146);
            var_4164 = wp::add(var_4119, var_4163);
            // zz += z * z                                                                    <L 44>
            var_4165 = wp::mul(var_4146, var_4146);
            var_4166 = wp::add(var_4121, var_4165);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_4168 = wp::extract(var_11, var_4167);
            var_4169 = wp::extract(var_11, var_4167);
            var_4170 = wp::mul(var_4168, var_4169);
            var_4171 = wp::extract(var_13, var_4167);
            var_4172 = wp::extract(var_13, var_4167);
            var_4173 = wp::mul(var_4171, var_4172);
            var_4174 = wp::add(var_4170, var_4173);
            var_4175 = wp::extract(var_15, var_4167);
            var_4176 = wp::extract(var_15, var_4167);
            var_4177 = wp::mul(var_4175, var_4176);
            var_4178 = wp::add(var_4174, var_4177);
            var_4179 = (var_4178 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_4179) {
                var_4180 = wp::extract(var_11, var_4167);
            }
            if (!var_4179) {
            }
            var_4182 = wp::where(var_4179, var_4180, var_4181);
            var_4183 = integer_steps_0(var_4182, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_4179) {
                var_4184 = wp::extract(var_13, var_4167);
            }
            if (!var_4179) {
            }
            var_4186 = wp::where(var_4179, var_4184, var_4185);
            var_4187 = integer_steps_0(var_4186, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_4179) {
                var_4188 = wp::extract(var_15, var_4167);
            }
            if (!var_4179) {
            }
            var_4190 = wp::where(var_4179, var_4188, var_4189);
            var_4191 = integer_steps_0(var_4190, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_4179) {
            }
            if (!var_4179) {
            }
            var_4194 = wp::where(var_4179, var_4192, var_4193);
            var_4195 = wp::int64(var_4194);
            var_4196 = wp::add(var_4151, var_4195);
            // sx += x                                                                        <L 36>
            var_4197 = wp::add(var_4152, var_4183);
            // sy += y                                                                        <L 37>
            var_4198 = wp::add(var_4153, var_4187);
            // sz += z                                                                        <L 38>
            var_4199 = wp::add(var_4154, var_4191);
            // xx += x * x                                                                    <L 39>
            var_4200 = wp::mul(var_4183, var_4183);
            var_4201 = wp::add(var_4156, var_4200);
            // xy += x * y                                                                    <L 40>
            var_4202 = wp::mul(var_4183, var_4187);
            var_4203 = wp::add(var_4158, var_4202);
            // xz += x * z                                                                    <L 41>
            var_4204 = wp::mul(var_4183, var_4191);
            var_4205 = wp::add(var_4160, var_4204);
            // yy += y * y                                                                    <L 42>
            var_4206 = wp::mul(var_4187, var_4187);
            var_4207 = wp::add(var_4162, var_4206);
            // yz += y * z                                                                    <L 43>
            var_4208 = wp::mul(var_4187, var_4191);
            var_4209 = wp::add(var_4164, var_4208);
            // zz += z * z                                                                    <L 44>
            var_4210 = wp::mul(var_4191, var_4191);
            var_4211 = wp::add(var_4166, var_4210);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_4213 = wp::extract(var_11, var_4212);
            var_4214 = wp::extract(var_11, var_4212);
            var_4215 = wp::mul(var_4213, var_4214);
            var_4216 = wp::extract(var_13, var_4212);
            var_4217 = wp::extract(var_13, var_4212);
            var_4218 = wp::mul(var_4216, var_4217);
            var_4219 = wp::add(var_4215, var_4218);
            var_4220 = wp::extract(var_15, var_4212);
            var_4221 = wp::extract(var_15, var_4212);
            var_4222 = wp::mul(var_4220, var_4221);
            var_4223 = wp::add(var_4219, var_4222);
            var_4224 = (var_4223 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_4224) {
                var_4225 = wp::extract(var_11, var_4212);
            }
            if (!var_4224) {
            }
            var_4227 = wp::where(var_4224, var_4225, var_4226);
            var_4228 = integer_steps_0(var_4227, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_4224) {
                var_4229 = wp::extract(var_13, var_4212);
            }
            if (!var_4224) {
            }
            var_4231 = wp::where(var_4224, var_4229, var_4230);
            var_4232 = integer_steps_0(var_4231, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_4224) {
                var_4233 = wp::extract(var_15, var_4212);
            }
            if (!var_4224) {
            }
            var_4235 = wp::where(var_4224, var_4233, var_4234);
            var_4236 = integer_steps_0(var_4235, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_4224) {
            }
            if (!var_4224) {
            }
            var_4239 = wp::where(var_4224, var_4237, var_4238);
            var_4240 = wp::int64(var_4239);
            var_4241 = wp::add(var_4196, var_4240);
            // sx += x                                                                        <L 36>
            var_4242 = wp::add(var_4197, var_4228);
            // sy += y                                                                        <L 37>
            var_4243 = wp::add(var_4198, var_4232);
            // sz += z                                                                        <L 38>
            var_4244 = wp::add(var_4199, var_4236);
            // xx += x * x                                                                    <L 39>
            var_4245 = wp::mul(var_4228, var_4228);
            var_4246 = wp::add(var_4201, var_4245);
            // xy += x * y                                                                    <L 40>
            var_4247 = wp::mul(var_4228, var_4232);
            var_4248 = wp::add(var_4203, var_4247);
            // xz += x * z                                                                    <L 41>
            var_4249 = wp::mul(var_4228, var_4236);
            var_4250 = wp::add(var_4205, var_4249);
            // yy += y * y                                                                    <L 42>
            var_4251 = wp::mul(var_4232, var_4232);
            var_4252 = wp::add(var_4207, var_4251);
            // yz += y * z                                                                    <L 43>
            var_4253 = wp::mul(var_4232, var_4236);
            var_4254 = wp::add(var_4209, var_4253);
            // zz += z * z                                                                    <L 44>
            var_4255 = wp::mul(var_4236, var_4236);
            var_4256 = wp::add(var_4211, var_4255);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_4258 = wp::extract(var_11, var_4257);
            var_4259 = wp::extract(var_11, var_4257);
            var_4260 = wp::mul(var_4258, var_4259);
            var_4261 = wp::extract(var_13, var_4257);
            var_4262 = wp::extract(var_13, var_4257);
            var_4263 = wp::mul(var_4261, var_4262);
            var_4264 = wp::add(var_4260, var_4263);
            var_4265 = wp::extract(var_15, var_4257);
            var_4266 = wp::extract(var_15, var_4257);
            var_4267 = wp::mul(var_4265, var_4266);
            var_4268 = wp::add(var_4264, var_4267);
            var_4269 = (var_4268 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_4269) {
                var_4270 = wp::extract(var_11, var_4257);
            }
            if (!var_4269) {
            }
            var_4272 = wp::where(var_4269, var_4270, var_4271);
            var_4273 = integer_steps_0(var_4272, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_4269) {
                var_4274 = wp::extract(var_13, var_4257);
            }
            if (!var_4269) {
            }
            var_4276 = wp::where(var_4269, var_4274, var_4275);
            var_4277 = integer_steps_0(var_4276, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_4269) {
                var_4278 = wp::extract(var_15, var_4257);
            }
            if (!var_4269) {
            }
            var_4280 = wp::where(var_4269, var_4278, var_4279);
            var_4281 = integer_steps_0(var_4280, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_4269) {
            }
            if (!var_4269) {
            }
            var_4284 = wp::where(var_4269, var_4282, var_4283);
            var_4285 = wp::int64(var_4284);
            var_4286 = wp::add(var_4241, var_4285);
            // sx += x                                                                        <L 36>
            var_4287 = wp::add(var_4242, var_4273);
            // sy += y                                                                        <L 37>
            var_4288 = wp::add(var_4243, var_4277);
            // sz += z                                                                        <L 38>
            var_4289 = wp::add(var_4244, var_4281);
            // xx += x * x                                                                    <L 39>
            var_4290 = wp::mul(var_4273, var_4273);
            var_4291 = wp::add(var_4246, var_4290);
            // xy += x * y                                                                    <L 40>
            var_4292 = wp::mul(var_4273, var_4277);
            var_4293 = wp::add(var_4248, var_4292);
            // xz += x * z                                                                    <L 41>
            var_4294 = wp::mul(var_4273, var_4281);
            var_4295 = wp::add(var_4250, var_4294);
            // yy += y * y                                                                    <L 42>
            var_4296 = wp::mul(var_4277, var_4277);
            var_4297 = wp::add(var_4252, var_4296);
            // yz += y * z                                                                    <L 43>
            var_4298 = wp::mul(var_4277, var_4281);
            var_4299 = wp::add(var_4254, var_4298);
            // zz += z * z                                                                    <L 44>
            var_4300 = wp::mul(var_4281, var_4281);
            var_4301 = wp::add(var_4256, var_4300);
            // inside = xs[j] * xs[j] + ys[j] * ys[j] + zs[j] * zs[j] <= max_sqdist           <L 31>
            var_4303 = wp::extract(var_11, var_4302);
            var_4304 = wp::extract(var_11, var_4302);
            var_4305 = wp::mul(var_4303, var_4304);
            var_4306 = wp::extract(var_13, var_4302);
            var_4307 = wp::extract(var_13, var_4302);
            var_4308 = wp::mul(var_4306, var_4307);
            var_4309 = wp::add(var_4305, var_4308);
            var_4310 = wp::extract(var_15, var_4302);
            var_4311 = wp::extract(var_15, var_4302);
            var_4312 = wp::mul(var_4310, var_4311);
            var_4313 = wp::add(var_4309, var_4312);
            var_4314 = (var_4313 <= var_max_sqdist);
            // x = integer_steps(xs[j] if inside else 0.0, steps)                             <L 32>
            if (var_4314) {
                var_4315 = wp::extract(var_11, var_4302);
            }
            if (!var_4314) {
            }
            var_4317 = wp::where(var_4314, var_4315, var_4316);
            var_4318 = integer_steps_0(var_4317, var_steps);
            // y = integer_steps(ys[j] if inside else 0.0, steps)                             <L 33>
            if (var_4314) {
                var_4319 = wp::extract(var_13, var_4302);
            }
            if (!var_4314) {
            }
            var_4321 = wp::where(var_4314, var_4319, var_4320);
            var_4322 = integer_steps_0(var_4321, var_steps);
            // z = integer_steps(zs[j] if inside else 0.0, steps)                             <L 34>
            if (var_4314) {
                var_4323 = wp::extract(var_15, var_4302);
            }
            if (!var_4314) {
            }
            var_4325 = wp::where(var_4314, var_4323, var_4324);
            var_4326 = integer_steps_0(var_4325, var_steps);
            // n += int64(1 if inside else 0)                                                 <L 35>
            if (var_4314) {
            }
            if (!var_4314) {
            }
            var_4329 = wp::where(var_4314, var_4327, var_4328);
            var_4330 = wp::int64(var_4329);
            var_4331 = wp::add(var_4286, var_4330);
            // sx += x                                                                        <L 36>
            var_4332 = wp::add(var_4287, var_4318);
            // sy += y                                                                        <L 37>
            var_4333 = wp::add(var_4288, var_4322);
            // sz += z                                                                        <L 38>
            var_4334 = wp::add(var_4289, var_4326);
            // xx += x * x                                                                    <L 39>
            var_4335 = wp::mul(var_4318, var_4318);
            var_4336 = wp::add(var_4291, var_4335);
            // xy += x * y                                                                    <L 40>
            var_4337 = wp::mul(var_4318, var_4322);
            var_4338 = wp::add(var_4293, var_4337);
            // xz += x * z                                                                    <L 41>
            var_4339 = wp::mul(var_4318, var_4326);
            var_4340 = wp::add(var_4295, var_4339);
            // yy += y * y                                                                    <L 42>
            var_4341 = wp::mul(var_4322, var_4322);
            var_4342 = wp::add(var_4297, var_4341);
            // yz += y * z                                                                    <L 43>
            var_4343 = wp::mul(var_4322, var_4326);
            var_4344 = wp::add(var_4299, var_4343);
            // zz += z * z                                                                    <L 44>
            var_4345 = wp::mul(var_4326, var_4326);
            var_4346 = wp::add(var_4301, var_4345);
        }
        var_4347 = wp::where(var_3823, var_4331, var_3804);
        var_4348 = wp::where(var_3823, var_4332, var_3805);
        var_4349 = wp::where(var_3823, var_4333, var_3806);
        var_4350 = wp::where(var_3823, var_4334, var_3807);
        var_4351 = wp::where(var_3823, var_4336, var_3808);
        var_4352 = wp::where(var_3823, var_4338, var_3809);
        var_4353 = wp::where(var_3823, var_4340, var_3810);
        var_4354 = wp::where(var_3823, var_4342, var_3811);
        var_4355 = wp::where(var_3823, var_4344, var_3812);
        var_4356 = wp::where(var_3823, var_4346, var_3813);
        var_4357 = wp::where(var_3823, var_3826, var_3814);
        var_4358 = wp::where(var_3823, var_4302, var_3815);
        var_4359 = wp::where(var_3823, var_3970, var_3816);
        var_4360 = wp::where(var_3823, var_4314, var_3817);
        var_4361 = wp::where(var_3823, var_4318, var_3818);
        var_4362 = wp::where(var_3823, var_4322, var_3819);
        var_4363 = wp::where(var_3823, var_4326, var_3820);
        // step__leaves_within__1 = next_bucket__leaves_within(step__leaves_within__1, p, p, max_sqdist, tree__root, tree__levels, tree__boxes)       <L 45>
        var_4364 = next_bucket_0(var_16, var_p, var_p, var_max_sqdist, var_tree__root, var_tree__levels, var_tree__boxes);
        wp::assign(var_0, var_4347);
        wp::assign(var_1, var_4348);
        wp::assign(var_2, var_4349);
        wp::assign(var_3, var_4350);
        wp::assign(var_4, var_4351);
        wp::assign(var_5, var_4352);
        wp::assign(var_6, var_4353);
        wp::assign(var_7, var_4354);
        wp::assign(var_8, var_4355);
        wp::assign(var_9, var_4356);
        wp::assign(var_16, var_4364);
    goto start_while_0;
    end_while_0:;
    // return integer_moments(n, sx, sy, sz, xx, xy, xz, yy, yz, zz)                          <L 46>
    var_4365 = wp::vec_t<10, wp::int64>({var_0, var_1, var_2, var_3, var_4, var_5, var_6, var_7, var_8, var_9});
    return var_4365;
}


// <pointloom.kernels.algebra.moments.in_meters>:1
static CUDA_CALLABLE wp::vec_t<10, wp::float64> in_meters_0(
    wp::vec_t<10, wp::int64> var_m,
    wp::float32 var_steps)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::float64 var_1;
    wp::float64 var_2;
    wp::float64 var_3;
    const wp::int32 var_4 = 0;
    wp::int64 var_5;
    wp::float64 var_6;
    const wp::int32 var_7 = 1;
    wp::int64 var_8;
    wp::float64 var_9;
    wp::float64 var_10;
    const wp::int32 var_11 = 2;
    wp::int64 var_12;
    wp::float64 var_13;
    wp::float64 var_14;
    const wp::int32 var_15 = 3;
    wp::int64 var_16;
    wp::float64 var_17;
    wp::float64 var_18;
    const wp::int32 var_19 = 4;
    wp::int64 var_20;
    wp::float64 var_21;
    wp::float64 var_22;
    const wp::int32 var_23 = 5;
    wp::int64 var_24;
    wp::float64 var_25;
    wp::float64 var_26;
    const wp::int32 var_27 = 6;
    wp::int64 var_28;
    wp::float64 var_29;
    wp::float64 var_30;
    const wp::int32 var_31 = 7;
    wp::int64 var_32;
    wp::float64 var_33;
    wp::float64 var_34;
    const wp::int32 var_35 = 8;
    wp::int64 var_36;
    wp::float64 var_37;
    wp::float64 var_38;
    const wp::int32 var_39 = 9;
    wp::int64 var_40;
    wp::float64 var_41;
    wp::float64 var_42;
    wp::vec_t<10, wp::float64> var_43;
    //---------
    // forward
    // def in_meters(m, steps):                                                               <L 1>
    // s = float64(1.0) / float64(steps)                                                      <L 3>
    var_0 = 1.0;
    var_1 = wp::float64(var_steps);
    var_2 = wp::div(var_0, var_1);
    // t = s * s                                                                              <L 4>
    var_3 = wp::mul(var_2, var_2);
    // return moments(float64(m[0]), float64(m[1]) * s, float64(m[2]) * s, float64(m[3]) * s, float64(m[4]) * t, float64(m[5]) * t, float64(m[6]) * t, float64(m[7]) * t, float64(m[8]) * t, float64(m[9]) * t)       <L 5>
    var_5 = wp::extract(var_m, var_4);
    var_6 = wp::float64(var_5);
    var_8 = wp::extract(var_m, var_7);
    var_9 = wp::float64(var_8);
    var_10 = wp::mul(var_9, var_2);
    var_12 = wp::extract(var_m, var_11);
    var_13 = wp::float64(var_12);
    var_14 = wp::mul(var_13, var_2);
    var_16 = wp::extract(var_m, var_15);
    var_17 = wp::float64(var_16);
    var_18 = wp::mul(var_17, var_2);
    var_20 = wp::extract(var_m, var_19);
    var_21 = wp::float64(var_20);
    var_22 = wp::mul(var_21, var_3);
    var_24 = wp::extract(var_m, var_23);
    var_25 = wp::float64(var_24);
    var_26 = wp::mul(var_25, var_3);
    var_28 = wp::extract(var_m, var_27);
    var_29 = wp::float64(var_28);
    var_30 = wp::mul(var_29, var_3);
    var_32 = wp::extract(var_m, var_31);
    var_33 = wp::float64(var_32);
    var_34 = wp::mul(var_33, var_3);
    var_36 = wp::extract(var_m, var_35);
    var_37 = wp::float64(var_36);
    var_38 = wp::mul(var_37, var_3);
    var_40 = wp::extract(var_m, var_39);
    var_41 = wp::float64(var_40);
    var_42 = wp::mul(var_41, var_3);
    var_43 = wp::vec_t<10, wp::float64>({var_6, var_10, var_14, var_18, var_22, var_26, var_30, var_34, var_38, var_42});
    return var_43;
}


// <pointloom.kernels.surface.neighbor_moments.moments_within>:1
static CUDA_CALLABLE wp::vec_t<10, wp::float64> moments_within_0(
    wp::int32 var_start,
    wp::vec_t<3, wp::float32> var_p,
    wp::float32 var_max_sqdist,
    wp::float32 var_widest,
    wp::int32 var_tree__root,
    wp::array_t<wp::int32> var_tree__levels,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> var_tree__points)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    wp::vec_t<10, wp::int64> var_2;
    const wp::int32 var_3 = 0;
    wp::int64 var_4;
    wp::int64 var_5;
    bool var_6;
    const wp::int32 var_7 = 0;
    wp::int64 var_8;
    wp::int32 var_9;
    wp::float32 var_10;
    wp::vec_t<10, wp::int64> var_11;
    wp::float32 var_12;
    wp::vec_t<10, wp::int64> var_13;
    wp::vec_t<10, wp::float64> var_14;
    //---------
    // forward
    // def moments_within(start, p, max_sqdist, widest, tree__root, tree__levels, tree__boxes, tree__points):       <L 1>
    // steps = steps_for(widest, 0)                                                           <L 3>
    var_1 = steps_for_0(var_widest, var_0);
    // total = integer_moments_within(start, p, max_sqdist, steps, tree__root, tree__levels, tree__boxes, tree__points)       <L 4>
    var_2 = integer_moments_within_0(var_start, var_p, var_max_sqdist, var_1, var_tree__root, var_tree__levels, var_tree__boxes, var_tree__points);
    // if total[0] > int64(MAX_EXACT_POINTS):                                                 <L 5>
    var_4 = wp::extract(var_2, var_3);
    var_5 = 131072ll;
    var_6 = (var_4 > var_5);
    if (var_6) {
        // steps = steps_for(widest, int(total[0]))                                           <L 6>
        var_8 = wp::extract(var_2, var_7);
        var_9 = wp::int(var_8);
        var_10 = steps_for_0(var_widest, var_9);
        // total = integer_moments_within(start, p, max_sqdist, steps, tree__root, tree__levels, tree__boxes, tree__points)       <L 7>
        var_11 = integer_moments_within_0(var_start, var_p, var_max_sqdist, var_10, var_tree__root, var_tree__levels, var_tree__boxes, var_tree__points);
    }
    var_12 = wp::where(var_6, var_10, var_1);
    var_13 = wp::where(var_6, var_11, var_2);
    // return in_meters(total, steps)                                                         <L 8>
    var_14 = in_meters_0(var_13, var_12);
    return var_14;
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


// /work/main/src/pointloom/kernels/surface/normals.py:27
static CUDA_CALLABLE wp::vec_t<3, wp::float32> normal_of_0(
    wp::vec_t<10, wp::float64> var_m)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 0.0;
    const wp::float32 var_1 = 0.0;
    const wp::float32 var_2 = 1.0;
    wp::vec_t<3, wp::float32> var_3;
    const wp::int32 var_4 = 0;
    wp::float64 var_5;
    wp::float64 var_6;
    bool var_7;
    wp::mat_t<3, 3, wp::float64> var_8;
    wp::vec_t<3, wp::float64> var_9;
    const wp::int32 var_10 = 0;
    wp::float64 var_11;
    wp::float32 var_12;
    const wp::int32 var_13 = 1;
    wp::float64 var_14;
    wp::float32 var_15;
    const wp::int32 var_16 = 2;
    wp::float64 var_17;
    wp::float32 var_18;
    wp::vec_t<3, wp::float32> var_19;
    wp::vec_t<3, wp::float32> var_20;
    //---------
    // forward
    // def normal_of(m: moments) -> vec3:                                                     <L 28>
    // n = vec3(0.0, 0.0, 1.0)                                                                <L 30>
    var_3 = wp::vec_t<3, wp::float32>(var_0, var_1, var_2);
    // if m[0] >= float64(MIN_NEIGHBORS):                                                     <L 31>
    var_5 = wp::extract(var_m, var_4);
    var_6 = 3.0;
    var_7 = (var_5 >= var_6);
    if (var_7) {
        // v = smallest_eigenvector(covariance_of(m))                                         <L 32>
        var_8 = covariance_of_0(var_m);
        var_9 = smallest_eigenvector_0(var_8);
        // n = vec3(float(v[0]), float(v[1]), float(v[2]))                                    <L 33>
        var_11 = wp::extract(var_9, var_10);
        var_12 = wp::float(var_11);
        var_14 = wp::extract(var_9, var_13);
        var_15 = wp::float(var_14);
        var_17 = wp::extract(var_9, var_16);
        var_18 = wp::float(var_17);
        var_19 = wp::vec_t<3, wp::float32>(var_12, var_15, var_18);
    }
    var_20 = wp::where(var_7, var_19, var_3);
    // return n                                                                               <L 34>
    return var_20;
}


// /work/main/src/pointloom/kernels/language/warp_compiler.py:143
static CUDA_CALLABLE void adj__float_bits_0(
    wp::float32 var_x,
    wp::float32 & adj_x,
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


// /work/main/src/pointloom/kernels/algebra/moments.py:11
static CUDA_CALLABLE void adj_steps_for_0(
    wp::float32 var_sqdist,
    wp::int32 var_count,
    wp::float32 & adj_sqdist,
    wp::int32 & adj_count,
    wp::float32 & adj_ret)
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


// /work/main/src/pointloom/kernels/algebra/moments.py:21
static CUDA_CALLABLE void adj_integer_steps_0(
    wp::float32 var_length,
    wp::float32 var_steps,
    wp::float32 & adj_length,
    wp::float32 & adj_steps,
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


// <pointloom.kernels.surface.neighbor_moments.integer_moments_within>:1
static CUDA_CALLABLE void adj_integer_moments_within_0(
    wp::int32 var_start,
    wp::vec_t<3, wp::float32> var_p,
    wp::float32 var_max_sqdist,
    wp::float32 var_steps,
    wp::int32 var_tree__root,
    wp::array_t<wp::int32> var_tree__levels,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> var_tree__points,
    wp::int32 & adj_start,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::float32 & adj_max_sqdist,
    wp::float32 & adj_steps,
    wp::int32 & adj_tree__root,
    wp::array_t<wp::int32> & adj_tree__levels,
    wp::array_t<wp::float32> & adj_tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_tree__points,
    wp::vec_t<10, wp::int64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.algebra.moments.in_meters>:1
static CUDA_CALLABLE void adj_in_meters_0(
    wp::vec_t<10, wp::int64> var_m,
    wp::float32 var_steps,
    wp::vec_t<10, wp::int64> & adj_m,
    wp::float32 & adj_steps,
    wp::vec_t<10, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.surface.neighbor_moments.moments_within>:1
static CUDA_CALLABLE void adj_moments_within_0(
    wp::int32 var_start,
    wp::vec_t<3, wp::float32> var_p,
    wp::float32 var_max_sqdist,
    wp::float32 var_widest,
    wp::int32 var_tree__root,
    wp::array_t<wp::int32> var_tree__levels,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> var_tree__points,
    wp::int32 & adj_start,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::float32 & adj_max_sqdist,
    wp::float32 & adj_widest,
    wp::int32 & adj_tree__root,
    wp::array_t<wp::int32> & adj_tree__levels,
    wp::array_t<wp::float32> & adj_tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_tree__points,
    wp::vec_t<10, wp::float64> & adj_ret)
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


// /work/main/src/pointloom/kernels/surface/normals.py:27
static CUDA_CALLABLE void adj_normal_of_0(
    wp::vec_t<10, wp::float64> var_m,
    wp::vec_t<10, wp::float64> & adj_m,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void fill_missing_normals_kernel_3897eb0d_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
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
        bool var_4;
        bool var_5;
        const wp::float32 var_6 = NAN;
        wp::vec_t<3, wp::float32> var_7;
        //---------
        // forward
        // def fill_missing_normals_kernel(points: array(dtype=vec3), normals: array(dtype=vec3)):       <L 94>
        // i = tid()                                                                              <L 96>
        var_0 = builtin_tid1d();
        // p = points[i]                                                                          <L 97>
        var_1 = wp::address(var_points, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // if not isfinite(p):                                                                    <L 98>
        var_4 = wp::isfinite(var_2);
        var_5 = wp::unot(var_4);
        if (var_5) {
            // normals[i] = vec3(NAN, NAN, NAN)                                                   <L 99>
            var_7 = wp::vec_t<3, wp::float32>(var_6, var_6, var_6);
            wp::array_store(var_normals, var_0, var_7);
        }
}



extern "C" __global__ void align_normals_kernel_56ec62d1_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_references,
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
        wp::vec_t<3, wp::float32>* var_2;
        wp::float32 var_3;
        wp::vec_t<3, wp::float32> var_4;
        wp::vec_t<3, wp::float32> var_5;
        const wp::float32 var_6 = 0.0;
        bool var_7;
        wp::vec_t<3, wp::float32>* var_8;
        wp::vec_t<3, wp::float32> var_9;
        wp::vec_t<3, wp::float32> var_10;
        //---------
        // forward
        // def align_normals_kernel(references: array(dtype=vec3), normals: array(dtype=vec3)):       <L 64>
        // i = tid()                                                                              <L 66>
        var_0 = builtin_tid1d();
        // if dot(normals[i], references[i]) < 0.0:                                               <L 67>
        var_1 = wp::address(var_normals, var_0);
        var_2 = wp::address(var_references, var_0);
        var_4 = wp::load(var_1);
        var_5 = wp::load(var_2);
        var_3 = wp::dot(var_4, var_5);
        var_7 = (var_3 < var_6);
        if (var_7) {
            // normals[i] = -normals[i]                                                           <L 68>
            var_8 = wp::address(var_normals, var_0);
            var_10 = wp::load(var_8);
            var_9 = wp::neg(var_10);
            wp::array_store(var_normals, var_0, var_9);
        }
}



extern "C" __global__ void orient_normals_kernel_a8d51cbe_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_normals,
    wp::int32 var_to_point,
    wp::vec_t<3, wp::float32> var_reference,
    wp::array_t<wp::vec_t<3, wp::float32>> var_oriented)
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
        const wp::float32 var_4 = 0.0;
        const wp::float32 var_5 = 0.0;
        const wp::float32 var_6 = 0.0;
        wp::vec_t<3, wp::float32> var_7;
        wp::vec_t<3, wp::float32> var_8;
        const wp::int32 var_9 = 1;
        bool var_10;
        wp::vec_t<3, wp::float32>* var_11;
        wp::vec_t<3, wp::float32> var_12;
        wp::vec_t<3, wp::float32> var_13;
        wp::vec_t<3, wp::float32> var_14;
        wp::float32 var_15;
        const wp::float32 var_16 = 0.0;
        bool var_17;
        wp::float32 var_18;
        wp::float32 var_19;
        const wp::float32 var_20 = 0.0;
        bool var_21;
        wp::vec_t<3, wp::float32> var_22;
        const wp::float32 var_23 = 0.0;
        const wp::float32 var_24 = 0.0;
        const wp::float32 var_25 = 1.0;
        wp::vec_t<3, wp::float32> var_26;
        wp::vec_t<3, wp::float32> var_27;
        wp::float32 var_28;
        const wp::float32 var_29 = 0.0;
        bool var_30;
        wp::vec_t<3, wp::float32> var_31;
        wp::vec_t<3, wp::float32> var_32;
        wp::vec_t<3, wp::float32> var_33;
        //---------
        // forward
        // def orient_normals_kernel(                                                             <L 72>
        // i = tid()                                                                              <L 76>
        var_0 = builtin_tid1d();
        // n = normals[i]                                                                         <L 77>
        var_1 = wp::address(var_normals, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // toward = reference + vec3(0.0, 0.0, 0.0)                                               <L 78>
        var_7 = wp::vec_t<3, wp::float32>(var_4, var_5, var_6);
        var_8 = wp::add(var_reference, var_7);
        // if to_point == 1:                                                                      <L 79>
        var_10 = (var_to_point == var_9);
        if (var_10) {
            // toward = reference - points[i]                                                     <L 80>
            var_11 = wp::address(var_points, var_0);
            var_13 = wp::load(var_11);
            var_12 = wp::sub(var_reference, var_13);
        }
        var_14 = wp::where(var_10, var_12, var_8);
        // if dot(n, n) == 0.0:                                                                   <L 81>
        var_15 = wp::dot(var_2, var_2);
        var_17 = (var_15 == var_16);
        if (var_17) {
            // size = sqrt(dot(toward, toward))                                                   <L 82>
            var_18 = wp::dot(var_14, var_14);
            var_19 = wp::sqrt(var_18);
            // if size > 0.0:                                                                     <L 83>
            var_21 = (var_19 > var_20);
            if (var_21) {
                // n = toward / size                                                              <L 84>
                var_22 = wp::div(var_14, var_19);
            }
            if (!var_21) {
                // n = vec3(0.0, 0.0, 1.0)                                                        <L 86>
                var_26 = wp::vec_t<3, wp::float32>(var_23, var_24, var_25);
            }
            var_27 = wp::where(var_21, var_22, var_26);
        }
        if (!var_17) {
            // if dot(n, toward) < 0.0:                                                           <L 88>
            var_28 = wp::dot(var_2, var_14);
            var_30 = (var_28 < var_29);
            if (var_30) {
                // n = -n                                                                         <L 89>
                var_31 = wp::neg(var_2);
            }
            var_32 = wp::where(var_30, var_31, var_2);
        }
        var_33 = wp::where(var_17, var_27, var_32);
        // oriented[i] = n                                                                        <L 90>
        wp::array_store(var_oriented, var_0, var_33);
}



extern "C" __global__ void WP_MAXNREG(128) fit_normals_within_kernel_b85c485d_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::int32 var_tree__root,
    wp::array_t<wp::int32> var_tree__levels,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> var_tree__points,
    wp::array_t<wp::int32> var_tree__order,
    wp::float32 var_max_sqdist,
    wp::float32 var_widest,
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
        const wp::int32 var_1 = 64;
        wp::int32 var_2;
        wp::vec_t<3, wp::float32>* var_3;
        wp::vec_t<10, wp::float64> var_4;
        wp::vec_t<3, wp::float32> var_5;
        wp::vec_t<3, wp::float32> var_6;
        wp::int32* var_7;
        wp::int32 var_8;
        //---------
        // forward
        // def fit_normals_within_kernel(tree__root, tree__levels, tree__boxes, tree__points, tree__order, max_sqdist, widest, normals):       <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // normals[tree__order[i]] = normal_of(moments_within(i // BUCKET, tree__points[i], max_sqdist, widest, tree__root, tree__levels, tree__boxes, tree__points))       <L 3>
        var_2 = wp::floordiv(var_0, var_1);
        var_3 = wp::address(var_tree__points, var_0);
        var_5 = wp::load(var_3);
        var_4 = moments_within_0(var_2, var_5, var_max_sqdist, var_widest, var_tree__root, var_tree__levels, var_tree__boxes, var_tree__points);
        var_6 = normal_of_0(var_4);
        var_7 = wp::address(var_tree__order, var_0);
        var_8 = wp::load(var_7);
        wp::array_store(var_normals, var_8, var_6);
}


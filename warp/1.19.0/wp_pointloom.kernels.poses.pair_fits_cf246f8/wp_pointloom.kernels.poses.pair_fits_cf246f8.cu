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


// <pointloom.kernels.poses.pair_fits.fold_blocks>:1
static CUDA_CALLABLE wp::vec_t<19, wp::float64> fold_blocks_0(
    wp::array_t<wp::float64> var_partials,
    wp::int32 var_first,
    wp::int32 var_blocks)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::vec_t<19, wp::float64> var_1;
    wp::int32 var_2;
    wp::range_t var_3;
    wp::int32 var_4;
    wp::int32 var_5;
    wp::int32 var_6;
    wp::float64 var_7;
    wp::float64* var_8;
    wp::float64 var_9;
    wp::float64 var_10;
    //---------
    // forward
    // def fold_blocks(partials, first, blocks):                                              <L 1>
    // total = all_sums(float64(0.0))                                                         <L 2>
    var_0 = 0.0;
    var_1 = wp::vec_t<19, wp::float64>(var_0);
    // for block in range(first, first + blocks):                                             <L 3>
    var_2 = wp::add(var_first, var_blocks);
    var_3 = wp::range(var_first, var_2);
    start_for_0:;
        if (iter_cmp(var_3) == 0) goto end_for_0;
        var_4 = wp::iter_next(var_3);
        // for k in range(COLUMNS):                                                           <L 4>
        var_5 = 0;
        start_for_2:;
            if (var_5 >= 19) goto end_for_2;
            var_6 = var_5;
            var_5 += 1;
            // total[k] = total[k] + partials[block, k]                                       <L 5>
            var_7 = wp::extract(var_1, var_6);
            var_8 = wp::address(var_partials, var_4, var_6);
            var_10 = wp::load(var_8);
            var_9 = wp::add(var_7, var_10);
            wp::assign_inplace(var_1, var_6, var_9);
            goto start_for_2;
        end_for_2:;
        goto start_for_0;
    end_for_0:;
    // return total                                                                           <L 6>
    return var_1;
}


// <pointloom.kernels.algebra.rigid_solve.jacobi_rotation>:1
static CUDA_CALLABLE wp::vec_t<2, wp::float64> jacobi_rotation_0(
    wp::float64 var_app,
    wp::float64 var_aqq,
    wp::float64 var_apq)
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
    bool var_13;
    wp::float64 var_14;
    wp::float64 var_15;
    wp::float64 var_16;
    wp::float64 var_17;
    wp::float64 var_18;
    wp::float64 var_19;
    wp::float64 var_20;
    wp::float64 var_21;
    wp::float64 var_22;
    wp::vec_t<2, wp::float64> var_23;
    //---------
    // forward
    // def jacobi_rotation(app, aqq, apq):                                                    <L 1>
    // theta = (aqq - app) / (float64(2.0) * apq)                                             <L 3>
    var_0 = wp::sub(var_aqq, var_app);
    var_1 = 2.0;
    var_2 = wp::mul(var_1, var_apq);
    var_3 = wp::div(var_0, var_2);
    // t = float64(1.0) / (abs(theta) + sqrt(theta * theta + float64(1.0)))                   <L 4>
    var_4 = 1.0;
    var_5 = wp::abs(var_3);
    var_6 = wp::mul(var_3, var_3);
    var_7 = 1.0;
    var_8 = wp::add(var_6, var_7);
    var_9 = wp::sqrt(var_8);
    var_10 = wp::add(var_5, var_9);
    var_11 = wp::div(var_4, var_10);
    // if theta < float64(0.0):                                                               <L 5>
    var_12 = 0.0;
    var_13 = (var_3 < var_12);
    if (var_13) {
        // t = -t                                                                             <L 6>
        var_14 = wp::neg(var_11);
    }
    var_15 = wp::where(var_13, var_14, var_11);
    // c = float64(1.0) / sqrt(t * t + float64(1.0))                                          <L 7>
    var_16 = 1.0;
    var_17 = wp::mul(var_15, var_15);
    var_18 = 1.0;
    var_19 = wp::add(var_17, var_18);
    var_20 = wp::sqrt(var_19);
    var_21 = wp::div(var_16, var_20);
    // return vec2d(c, t * c)                                                                 <L 8>
    var_22 = wp::mul(var_15, var_21);
    var_23 = wp::vec_t<2, wp::float64>(var_21, var_22);
    return var_23;
}


// <pointloom.kernels.algebra.rigid_solve.diagonalize_four>:1
static CUDA_CALLABLE wp::vec_t<20, wp::float64> diagonalize_four_0(
    wp::vec_t<16, wp::float64> var_matrix)
{
    //---------
    // primal vars
    wp::vec_t<16, wp::float64> var_0;
    wp::float64 var_1;
    wp::vec_t<16, wp::float64> var_2;
    const wp::int32 var_3 = 0;
    wp::float64 var_4;
    const wp::int32 var_5 = 5;
    wp::int32 var_6;
    const wp::int32 var_7 = 1;
    wp::float64 var_8;
    const wp::int32 var_9 = 5;
    wp::int32 var_10;
    const wp::int32 var_11 = 2;
    wp::float64 var_12;
    const wp::int32 var_13 = 5;
    wp::int32 var_14;
    const wp::int32 var_15 = 3;
    wp::float64 var_16;
    const wp::int32 var_17 = 5;
    wp::int32 var_18;
    const wp::int32 var_19 = 1;
    wp::int32 var_20;
    const wp::int32 var_21 = 0;
    wp::int32 var_22;
    bool var_23;
    const wp::int32 var_24 = 1;
    bool var_25;
    const wp::int32 var_26 = 10;
    bool var_27;
    const wp::int32 var_28 = 0;
    wp::int32 var_29;
    const wp::int32 var_30 = 1;
    wp::int32 var_31;
    const wp::int32 var_32 = 0;
    const wp::int32 var_33 = 3;
    bool var_34;
    const wp::int32 var_35 = 0;
    const wp::int32 var_36 = 5;
    bool var_37;
    const wp::int32 var_38 = 1;
    const wp::int32 var_39 = 2;
    wp::int32 var_40;
    wp::int32 var_41;
    const wp::int32 var_42 = 1;
    wp::int32 var_43;
    const wp::int32 var_44 = 3;
    bool var_45;
    const wp::int32 var_46 = 0;
    const wp::int32 var_47 = 5;
    bool var_48;
    const wp::int32 var_49 = 2;
    const wp::int32 var_50 = 3;
    wp::int32 var_51;
    wp::int32 var_52;
    wp::int32 var_53;
    const wp::int32 var_54 = 4;
    wp::int32 var_55;
    wp::int32 var_56;
    wp::float64 var_57;
    const wp::int32 var_58 = 4;
    wp::int32 var_59;
    wp::int32 var_60;
    wp::float64 var_61;
    const wp::int32 var_62 = 4;
    wp::int32 var_63;
    wp::int32 var_64;
    wp::float64 var_65;
    bool var_66;
    wp::float64 var_67;
    wp::float64 var_68;
    bool var_69;
    wp::float64 var_70;
    wp::float64 var_71;
    wp::float64 var_72;
    wp::float64 var_73;
    wp::float64 var_74;
    wp::float64 var_75;
    bool var_76;
    const wp::int32 var_77 = 1;
    wp::vec_t<2, wp::float64> var_78;
    const wp::int32 var_79 = 0;
    const wp::int32 var_80 = 4;
    wp::int32 var_81;
    wp::int32 var_82;
    wp::float64 var_83;
    const wp::int32 var_84 = 4;
    wp::int32 var_85;
    wp::int32 var_86;
    wp::float64 var_87;
    const wp::int32 var_88 = 0;
    wp::float64 var_89;
    wp::float64 var_90;
    const wp::int32 var_91 = 1;
    wp::float64 var_92;
    wp::float64 var_93;
    wp::float64 var_94;
    const wp::int32 var_95 = 4;
    wp::int32 var_96;
    wp::int32 var_97;
    const wp::int32 var_98 = 1;
    wp::float64 var_99;
    wp::float64 var_100;
    const wp::int32 var_101 = 0;
    wp::float64 var_102;
    wp::float64 var_103;
    wp::float64 var_104;
    const wp::int32 var_105 = 4;
    wp::int32 var_106;
    wp::int32 var_107;
    const wp::int32 var_108 = 1;
    const wp::int32 var_109 = 4;
    wp::int32 var_110;
    wp::int32 var_111;
    wp::float64 var_112;
    const wp::int32 var_113 = 4;
    wp::int32 var_114;
    wp::int32 var_115;
    wp::float64 var_116;
    const wp::int32 var_117 = 0;
    wp::float64 var_118;
    wp::float64 var_119;
    const wp::int32 var_120 = 1;
    wp::float64 var_121;
    wp::float64 var_122;
    wp::float64 var_123;
    const wp::int32 var_124 = 4;
    wp::int32 var_125;
    wp::int32 var_126;
    const wp::int32 var_127 = 1;
    wp::float64 var_128;
    wp::float64 var_129;
    const wp::int32 var_130 = 0;
    wp::float64 var_131;
    wp::float64 var_132;
    wp::float64 var_133;
    const wp::int32 var_134 = 4;
    wp::int32 var_135;
    wp::int32 var_136;
    const wp::int32 var_137 = 2;
    const wp::int32 var_138 = 4;
    wp::int32 var_139;
    wp::int32 var_140;
    wp::float64 var_141;
    const wp::int32 var_142 = 4;
    wp::int32 var_143;
    wp::int32 var_144;
    wp::float64 var_145;
    const wp::int32 var_146 = 0;
    wp::float64 var_147;
    wp::float64 var_148;
    const wp::int32 var_149 = 1;
    wp::float64 var_150;
    wp::float64 var_151;
    wp::float64 var_152;
    const wp::int32 var_153 = 4;
    wp::int32 var_154;
    wp::int32 var_155;
    const wp::int32 var_156 = 1;
    wp::float64 var_157;
    wp::float64 var_158;
    const wp::int32 var_159 = 0;
    wp::float64 var_160;
    wp::float64 var_161;
    wp::float64 var_162;
    const wp::int32 var_163 = 4;
    wp::int32 var_164;
    wp::int32 var_165;
    const wp::int32 var_166 = 3;
    const wp::int32 var_167 = 4;
    wp::int32 var_168;
    wp::int32 var_169;
    wp::float64 var_170;
    const wp::int32 var_171 = 4;
    wp::int32 var_172;
    wp::int32 var_173;
    wp::float64 var_174;
    const wp::int32 var_175 = 0;
    wp::float64 var_176;
    wp::float64 var_177;
    const wp::int32 var_178 = 1;
    wp::float64 var_179;
    wp::float64 var_180;
    wp::float64 var_181;
    const wp::int32 var_182 = 4;
    wp::int32 var_183;
    wp::int32 var_184;
    const wp::int32 var_185 = 1;
    wp::float64 var_186;
    wp::float64 var_187;
    const wp::int32 var_188 = 0;
    wp::float64 var_189;
    wp::float64 var_190;
    wp::float64 var_191;
    const wp::int32 var_192 = 4;
    wp::int32 var_193;
    wp::int32 var_194;
    const wp::int32 var_195 = 0;
    const wp::int32 var_196 = 4;
    wp::int32 var_197;
    wp::int32 var_198;
    wp::float64 var_199;
    const wp::int32 var_200 = 4;
    wp::int32 var_201;
    wp::int32 var_202;
    wp::float64 var_203;
    const wp::int32 var_204 = 0;
    wp::float64 var_205;
    wp::float64 var_206;
    const wp::int32 var_207 = 1;
    wp::float64 var_208;
    wp::float64 var_209;
    wp::float64 var_210;
    const wp::int32 var_211 = 4;
    wp::int32 var_212;
    wp::int32 var_213;
    const wp::int32 var_214 = 1;
    wp::float64 var_215;
    wp::float64 var_216;
    const wp::int32 var_217 = 0;
    wp::float64 var_218;
    wp::float64 var_219;
    wp::float64 var_220;
    const wp::int32 var_221 = 4;
    wp::int32 var_222;
    wp::int32 var_223;
    const wp::int32 var_224 = 1;
    const wp::int32 var_225 = 4;
    wp::int32 var_226;
    wp::int32 var_227;
    wp::float64 var_228;
    const wp::int32 var_229 = 4;
    wp::int32 var_230;
    wp::int32 var_231;
    wp::float64 var_232;
    const wp::int32 var_233 = 0;
    wp::float64 var_234;
    wp::float64 var_235;
    const wp::int32 var_236 = 1;
    wp::float64 var_237;
    wp::float64 var_238;
    wp::float64 var_239;
    const wp::int32 var_240 = 4;
    wp::int32 var_241;
    wp::int32 var_242;
    const wp::int32 var_243 = 1;
    wp::float64 var_244;
    wp::float64 var_245;
    const wp::int32 var_246 = 0;
    wp::float64 var_247;
    wp::float64 var_248;
    wp::float64 var_249;
    const wp::int32 var_250 = 4;
    wp::int32 var_251;
    wp::int32 var_252;
    const wp::int32 var_253 = 2;
    const wp::int32 var_254 = 4;
    wp::int32 var_255;
    wp::int32 var_256;
    wp::float64 var_257;
    const wp::int32 var_258 = 4;
    wp::int32 var_259;
    wp::int32 var_260;
    wp::float64 var_261;
    const wp::int32 var_262 = 0;
    wp::float64 var_263;
    wp::float64 var_264;
    const wp::int32 var_265 = 1;
    wp::float64 var_266;
    wp::float64 var_267;
    wp::float64 var_268;
    const wp::int32 var_269 = 4;
    wp::int32 var_270;
    wp::int32 var_271;
    const wp::int32 var_272 = 1;
    wp::float64 var_273;
    wp::float64 var_274;
    const wp::int32 var_275 = 0;
    wp::float64 var_276;
    wp::float64 var_277;
    wp::float64 var_278;
    const wp::int32 var_279 = 4;
    wp::int32 var_280;
    wp::int32 var_281;
    const wp::int32 var_282 = 3;
    const wp::int32 var_283 = 4;
    wp::int32 var_284;
    wp::int32 var_285;
    wp::float64 var_286;
    const wp::int32 var_287 = 4;
    wp::int32 var_288;
    wp::int32 var_289;
    wp::float64 var_290;
    const wp::int32 var_291 = 0;
    wp::float64 var_292;
    wp::float64 var_293;
    const wp::int32 var_294 = 1;
    wp::float64 var_295;
    wp::float64 var_296;
    wp::float64 var_297;
    const wp::int32 var_298 = 4;
    wp::int32 var_299;
    wp::int32 var_300;
    const wp::int32 var_301 = 1;
    wp::float64 var_302;
    wp::float64 var_303;
    const wp::int32 var_304 = 0;
    wp::float64 var_305;
    wp::float64 var_306;
    wp::float64 var_307;
    const wp::int32 var_308 = 4;
    wp::int32 var_309;
    wp::int32 var_310;
    const wp::int32 var_311 = 0;
    const wp::int32 var_312 = 4;
    wp::int32 var_313;
    wp::int32 var_314;
    wp::float64 var_315;
    const wp::int32 var_316 = 4;
    wp::int32 var_317;
    wp::int32 var_318;
    wp::float64 var_319;
    const wp::int32 var_320 = 0;
    wp::float64 var_321;
    wp::float64 var_322;
    const wp::int32 var_323 = 1;
    wp::float64 var_324;
    wp::float64 var_325;
    wp::float64 var_326;
    const wp::int32 var_327 = 4;
    wp::int32 var_328;
    wp::int32 var_329;
    const wp::int32 var_330 = 1;
    wp::float64 var_331;
    wp::float64 var_332;
    const wp::int32 var_333 = 0;
    wp::float64 var_334;
    wp::float64 var_335;
    wp::float64 var_336;
    const wp::int32 var_337 = 4;
    wp::int32 var_338;
    wp::int32 var_339;
    const wp::int32 var_340 = 1;
    const wp::int32 var_341 = 4;
    wp::int32 var_342;
    wp::int32 var_343;
    wp::float64 var_344;
    const wp::int32 var_345 = 4;
    wp::int32 var_346;
    wp::int32 var_347;
    wp::float64 var_348;
    const wp::int32 var_349 = 0;
    wp::float64 var_350;
    wp::float64 var_351;
    const wp::int32 var_352 = 1;
    wp::float64 var_353;
    wp::float64 var_354;
    wp::float64 var_355;
    const wp::int32 var_356 = 4;
    wp::int32 var_357;
    wp::int32 var_358;
    const wp::int32 var_359 = 1;
    wp::float64 var_360;
    wp::float64 var_361;
    const wp::int32 var_362 = 0;
    wp::float64 var_363;
    wp::float64 var_364;
    wp::float64 var_365;
    const wp::int32 var_366 = 4;
    wp::int32 var_367;
    wp::int32 var_368;
    const wp::int32 var_369 = 2;
    const wp::int32 var_370 = 4;
    wp::int32 var_371;
    wp::int32 var_372;
    wp::float64 var_373;
    const wp::int32 var_374 = 4;
    wp::int32 var_375;
    wp::int32 var_376;
    wp::float64 var_377;
    const wp::int32 var_378 = 0;
    wp::float64 var_379;
    wp::float64 var_380;
    const wp::int32 var_381 = 1;
    wp::float64 var_382;
    wp::float64 var_383;
    wp::float64 var_384;
    const wp::int32 var_385 = 4;
    wp::int32 var_386;
    wp::int32 var_387;
    const wp::int32 var_388 = 1;
    wp::float64 var_389;
    wp::float64 var_390;
    const wp::int32 var_391 = 0;
    wp::float64 var_392;
    wp::float64 var_393;
    wp::float64 var_394;
    const wp::int32 var_395 = 4;
    wp::int32 var_396;
    wp::int32 var_397;
    const wp::int32 var_398 = 3;
    const wp::int32 var_399 = 4;
    wp::int32 var_400;
    wp::int32 var_401;
    wp::float64 var_402;
    const wp::int32 var_403 = 4;
    wp::int32 var_404;
    wp::int32 var_405;
    wp::float64 var_406;
    const wp::int32 var_407 = 0;
    wp::float64 var_408;
    wp::float64 var_409;
    const wp::int32 var_410 = 1;
    wp::float64 var_411;
    wp::float64 var_412;
    wp::float64 var_413;
    const wp::int32 var_414 = 4;
    wp::int32 var_415;
    wp::int32 var_416;
    const wp::int32 var_417 = 1;
    wp::float64 var_418;
    wp::float64 var_419;
    const wp::int32 var_420 = 0;
    wp::float64 var_421;
    wp::float64 var_422;
    wp::float64 var_423;
    const wp::int32 var_424 = 4;
    wp::int32 var_425;
    wp::int32 var_426;
    wp::int32 var_427;
    const wp::int32 var_428 = 1;
    const wp::int32 var_429 = 3;
    bool var_430;
    const wp::int32 var_431 = 0;
    const wp::int32 var_432 = 5;
    bool var_433;
    const wp::int32 var_434 = 1;
    const wp::int32 var_435 = 2;
    wp::int32 var_436;
    wp::int32 var_437;
    const wp::int32 var_438 = 1;
    wp::int32 var_439;
    const wp::int32 var_440 = 3;
    bool var_441;
    const wp::int32 var_442 = 0;
    const wp::int32 var_443 = 5;
    bool var_444;
    const wp::int32 var_445 = 2;
    const wp::int32 var_446 = 3;
    wp::int32 var_447;
    wp::int32 var_448;
    wp::int32 var_449;
    const wp::int32 var_450 = 4;
    wp::int32 var_451;
    wp::int32 var_452;
    wp::float64 var_453;
    const wp::int32 var_454 = 4;
    wp::int32 var_455;
    wp::int32 var_456;
    wp::float64 var_457;
    const wp::int32 var_458 = 4;
    wp::int32 var_459;
    wp::int32 var_460;
    wp::float64 var_461;
    bool var_462;
    wp::float64 var_463;
    wp::float64 var_464;
    bool var_465;
    wp::float64 var_466;
    wp::float64 var_467;
    wp::float64 var_468;
    wp::float64 var_469;
    wp::float64 var_470;
    wp::float64 var_471;
    bool var_472;
    const wp::int32 var_473 = 1;
    wp::vec_t<2, wp::float64> var_474;
    const wp::int32 var_475 = 0;
    const wp::int32 var_476 = 4;
    wp::int32 var_477;
    wp::int32 var_478;
    wp::float64 var_479;
    const wp::int32 var_480 = 4;
    wp::int32 var_481;
    wp::int32 var_482;
    wp::float64 var_483;
    const wp::int32 var_484 = 0;
    wp::float64 var_485;
    wp::float64 var_486;
    const wp::int32 var_487 = 1;
    wp::float64 var_488;
    wp::float64 var_489;
    wp::float64 var_490;
    const wp::int32 var_491 = 4;
    wp::int32 var_492;
    wp::int32 var_493;
    const wp::int32 var_494 = 1;
    wp::float64 var_495;
    wp::float64 var_496;
    const wp::int32 var_497 = 0;
    wp::float64 var_498;
    wp::float64 var_499;
    wp::float64 var_500;
    const wp::int32 var_501 = 4;
    wp::int32 var_502;
    wp::int32 var_503;
    const wp::int32 var_504 = 1;
    const wp::int32 var_505 = 4;
    wp::int32 var_506;
    wp::int32 var_507;
    wp::float64 var_508;
    const wp::int32 var_509 = 4;
    wp::int32 var_510;
    wp::int32 var_511;
    wp::float64 var_512;
    const wp::int32 var_513 = 0;
    wp::float64 var_514;
    wp::float64 var_515;
    const wp::int32 var_516 = 1;
    wp::float64 var_517;
    wp::float64 var_518;
    wp::float64 var_519;
    const wp::int32 var_520 = 4;
    wp::int32 var_521;
    wp::int32 var_522;
    const wp::int32 var_523 = 1;
    wp::float64 var_524;
    wp::float64 var_525;
    const wp::int32 var_526 = 0;
    wp::float64 var_527;
    wp::float64 var_528;
    wp::float64 var_529;
    const wp::int32 var_530 = 4;
    wp::int32 var_531;
    wp::int32 var_532;
    const wp::int32 var_533 = 2;
    const wp::int32 var_534 = 4;
    wp::int32 var_535;
    wp::int32 var_536;
    wp::float64 var_537;
    const wp::int32 var_538 = 4;
    wp::int32 var_539;
    wp::int32 var_540;
    wp::float64 var_541;
    const wp::int32 var_542 = 0;
    wp::float64 var_543;
    wp::float64 var_544;
    const wp::int32 var_545 = 1;
    wp::float64 var_546;
    wp::float64 var_547;
    wp::float64 var_548;
    const wp::int32 var_549 = 4;
    wp::int32 var_550;
    wp::int32 var_551;
    const wp::int32 var_552 = 1;
    wp::float64 var_553;
    wp::float64 var_554;
    const wp::int32 var_555 = 0;
    wp::float64 var_556;
    wp::float64 var_557;
    wp::float64 var_558;
    const wp::int32 var_559 = 4;
    wp::int32 var_560;
    wp::int32 var_561;
    const wp::int32 var_562 = 3;
    const wp::int32 var_563 = 4;
    wp::int32 var_564;
    wp::int32 var_565;
    wp::float64 var_566;
    const wp::int32 var_567 = 4;
    wp::int32 var_568;
    wp::int32 var_569;
    wp::float64 var_570;
    const wp::int32 var_571 = 0;
    wp::float64 var_572;
    wp::float64 var_573;
    const wp::int32 var_574 = 1;
    wp::float64 var_575;
    wp::float64 var_576;
    wp::float64 var_577;
    const wp::int32 var_578 = 4;
    wp::int32 var_579;
    wp::int32 var_580;
    const wp::int32 var_581 = 1;
    wp::float64 var_582;
    wp::float64 var_583;
    const wp::int32 var_584 = 0;
    wp::float64 var_585;
    wp::float64 var_586;
    wp::float64 var_587;
    const wp::int32 var_588 = 4;
    wp::int32 var_589;
    wp::int32 var_590;
    const wp::int32 var_591 = 0;
    const wp::int32 var_592 = 4;
    wp::int32 var_593;
    wp::int32 var_594;
    wp::float64 var_595;
    const wp::int32 var_596 = 4;
    wp::int32 var_597;
    wp::int32 var_598;
    wp::float64 var_599;
    const wp::int32 var_600 = 0;
    wp::float64 var_601;
    wp::float64 var_602;
    const wp::int32 var_603 = 1;
    wp::float64 var_604;
    wp::float64 var_605;
    wp::float64 var_606;
    const wp::int32 var_607 = 4;
    wp::int32 var_608;
    wp::int32 var_609;
    const wp::int32 var_610 = 1;
    wp::float64 var_611;
    wp::float64 var_612;
    const wp::int32 var_613 = 0;
    wp::float64 var_614;
    wp::float64 var_615;
    wp::float64 var_616;
    const wp::int32 var_617 = 4;
    wp::int32 var_618;
    wp::int32 var_619;
    const wp::int32 var_620 = 1;
    const wp::int32 var_621 = 4;
    wp::int32 var_622;
    wp::int32 var_623;
    wp::float64 var_624;
    const wp::int32 var_625 = 4;
    wp::int32 var_626;
    wp::int32 var_627;
    wp::float64 var_628;
    const wp::int32 var_629 = 0;
    wp::float64 var_630;
    wp::float64 var_631;
    const wp::int32 var_632 = 1;
    wp::float64 var_633;
    wp::float64 var_634;
    wp::float64 var_635;
    const wp::int32 var_636 = 4;
    wp::int32 var_637;
    wp::int32 var_638;
    const wp::int32 var_639 = 1;
    wp::float64 var_640;
    wp::float64 var_641;
    const wp::int32 var_642 = 0;
    wp::float64 var_643;
    wp::float64 var_644;
    wp::float64 var_645;
    const wp::int32 var_646 = 4;
    wp::int32 var_647;
    wp::int32 var_648;
    const wp::int32 var_649 = 2;
    const wp::int32 var_650 = 4;
    wp::int32 var_651;
    wp::int32 var_652;
    wp::float64 var_653;
    const wp::int32 var_654 = 4;
    wp::int32 var_655;
    wp::int32 var_656;
    wp::float64 var_657;
    const wp::int32 var_658 = 0;
    wp::float64 var_659;
    wp::float64 var_660;
    const wp::int32 var_661 = 1;
    wp::float64 var_662;
    wp::float64 var_663;
    wp::float64 var_664;
    const wp::int32 var_665 = 4;
    wp::int32 var_666;
    wp::int32 var_667;
    const wp::int32 var_668 = 1;
    wp::float64 var_669;
    wp::float64 var_670;
    const wp::int32 var_671 = 0;
    wp::float64 var_672;
    wp::float64 var_673;
    wp::float64 var_674;
    const wp::int32 var_675 = 4;
    wp::int32 var_676;
    wp::int32 var_677;
    const wp::int32 var_678 = 3;
    const wp::int32 var_679 = 4;
    wp::int32 var_680;
    wp::int32 var_681;
    wp::float64 var_682;
    const wp::int32 var_683 = 4;
    wp::int32 var_684;
    wp::int32 var_685;
    wp::float64 var_686;
    const wp::int32 var_687 = 0;
    wp::float64 var_688;
    wp::float64 var_689;
    const wp::int32 var_690 = 1;
    wp::float64 var_691;
    wp::float64 var_692;
    wp::float64 var_693;
    const wp::int32 var_694 = 4;
    wp::int32 var_695;
    wp::int32 var_696;
    const wp::int32 var_697 = 1;
    wp::float64 var_698;
    wp::float64 var_699;
    const wp::int32 var_700 = 0;
    wp::float64 var_701;
    wp::float64 var_702;
    wp::float64 var_703;
    const wp::int32 var_704 = 4;
    wp::int32 var_705;
    wp::int32 var_706;
    const wp::int32 var_707 = 0;
    const wp::int32 var_708 = 4;
    wp::int32 var_709;
    wp::int32 var_710;
    wp::float64 var_711;
    const wp::int32 var_712 = 4;
    wp::int32 var_713;
    wp::int32 var_714;
    wp::float64 var_715;
    const wp::int32 var_716 = 0;
    wp::float64 var_717;
    wp::float64 var_718;
    const wp::int32 var_719 = 1;
    wp::float64 var_720;
    wp::float64 var_721;
    wp::float64 var_722;
    const wp::int32 var_723 = 4;
    wp::int32 var_724;
    wp::int32 var_725;
    const wp::int32 var_726 = 1;
    wp::float64 var_727;
    wp::float64 var_728;
    const wp::int32 var_729 = 0;
    wp::float64 var_730;
    wp::float64 var_731;
    wp::float64 var_732;
    const wp::int32 var_733 = 4;
    wp::int32 var_734;
    wp::int32 var_735;
    const wp::int32 var_736 = 1;
    const wp::int32 var_737 = 4;
    wp::int32 var_738;
    wp::int32 var_739;
    wp::float64 var_740;
    const wp::int32 var_741 = 4;
    wp::int32 var_742;
    wp::int32 var_743;
    wp::float64 var_744;
    const wp::int32 var_745 = 0;
    wp::float64 var_746;
    wp::float64 var_747;
    const wp::int32 var_748 = 1;
    wp::float64 var_749;
    wp::float64 var_750;
    wp::float64 var_751;
    const wp::int32 var_752 = 4;
    wp::int32 var_753;
    wp::int32 var_754;
    const wp::int32 var_755 = 1;
    wp::float64 var_756;
    wp::float64 var_757;
    const wp::int32 var_758 = 0;
    wp::float64 var_759;
    wp::float64 var_760;
    wp::float64 var_761;
    const wp::int32 var_762 = 4;
    wp::int32 var_763;
    wp::int32 var_764;
    const wp::int32 var_765 = 2;
    const wp::int32 var_766 = 4;
    wp::int32 var_767;
    wp::int32 var_768;
    wp::float64 var_769;
    const wp::int32 var_770 = 4;
    wp::int32 var_771;
    wp::int32 var_772;
    wp::float64 var_773;
    const wp::int32 var_774 = 0;
    wp::float64 var_775;
    wp::float64 var_776;
    const wp::int32 var_777 = 1;
    wp::float64 var_778;
    wp::float64 var_779;
    wp::float64 var_780;
    const wp::int32 var_781 = 4;
    wp::int32 var_782;
    wp::int32 var_783;
    const wp::int32 var_784 = 1;
    wp::float64 var_785;
    wp::float64 var_786;
    const wp::int32 var_787 = 0;
    wp::float64 var_788;
    wp::float64 var_789;
    wp::float64 var_790;
    const wp::int32 var_791 = 4;
    wp::int32 var_792;
    wp::int32 var_793;
    const wp::int32 var_794 = 3;
    const wp::int32 var_795 = 4;
    wp::int32 var_796;
    wp::int32 var_797;
    wp::float64 var_798;
    const wp::int32 var_799 = 4;
    wp::int32 var_800;
    wp::int32 var_801;
    wp::float64 var_802;
    const wp::int32 var_803 = 0;
    wp::float64 var_804;
    wp::float64 var_805;
    const wp::int32 var_806 = 1;
    wp::float64 var_807;
    wp::float64 var_808;
    wp::float64 var_809;
    const wp::int32 var_810 = 4;
    wp::int32 var_811;
    wp::int32 var_812;
    const wp::int32 var_813 = 1;
    wp::float64 var_814;
    wp::float64 var_815;
    const wp::int32 var_816 = 0;
    wp::float64 var_817;
    wp::float64 var_818;
    wp::float64 var_819;
    const wp::int32 var_820 = 4;
    wp::int32 var_821;
    wp::int32 var_822;
    wp::int32 var_823;
    wp::vec_t<2, wp::float64> var_824;
    wp::int32 var_825;
    wp::float64 var_826;
    wp::float64 var_827;
    wp::float64 var_828;
    wp::float64 var_829;
    wp::float64 var_830;
    wp::float64 var_831;
    const wp::int32 var_832 = 2;
    const wp::int32 var_833 = 3;
    bool var_834;
    const wp::int32 var_835 = 0;
    const wp::int32 var_836 = 5;
    bool var_837;
    const wp::int32 var_838 = 1;
    const wp::int32 var_839 = 2;
    wp::int32 var_840;
    wp::int32 var_841;
    const wp::int32 var_842 = 1;
    wp::int32 var_843;
    const wp::int32 var_844 = 3;
    bool var_845;
    const wp::int32 var_846 = 0;
    const wp::int32 var_847 = 5;
    bool var_848;
    const wp::int32 var_849 = 2;
    const wp::int32 var_850 = 3;
    wp::int32 var_851;
    wp::int32 var_852;
    wp::int32 var_853;
    const wp::int32 var_854 = 4;
    wp::int32 var_855;
    wp::int32 var_856;
    wp::float64 var_857;
    const wp::int32 var_858 = 4;
    wp::int32 var_859;
    wp::int32 var_860;
    wp::float64 var_861;
    const wp::int32 var_862 = 4;
    wp::int32 var_863;
    wp::int32 var_864;
    wp::float64 var_865;
    bool var_866;
    wp::float64 var_867;
    wp::float64 var_868;
    bool var_869;
    wp::float64 var_870;
    wp::float64 var_871;
    wp::float64 var_872;
    wp::float64 var_873;
    wp::float64 var_874;
    wp::float64 var_875;
    bool var_876;
    const wp::int32 var_877 = 1;
    wp::vec_t<2, wp::float64> var_878;
    const wp::int32 var_879 = 0;
    const wp::int32 var_880 = 4;
    wp::int32 var_881;
    wp::int32 var_882;
    wp::float64 var_883;
    const wp::int32 var_884 = 4;
    wp::int32 var_885;
    wp::int32 var_886;
    wp::float64 var_887;
    const wp::int32 var_888 = 0;
    wp::float64 var_889;
    wp::float64 var_890;
    const wp::int32 var_891 = 1;
    wp::float64 var_892;
    wp::float64 var_893;
    wp::float64 var_894;
    const wp::int32 var_895 = 4;
    wp::int32 var_896;
    wp::int32 var_897;
    const wp::int32 var_898 = 1;
    wp::float64 var_899;
    wp::float64 var_900;
    const wp::int32 var_901 = 0;
    wp::float64 var_902;
    wp::float64 var_903;
    wp::float64 var_904;
    const wp::int32 var_905 = 4;
    wp::int32 var_906;
    wp::int32 var_907;
    const wp::int32 var_908 = 1;
    const wp::int32 var_909 = 4;
    wp::int32 var_910;
    wp::int32 var_911;
    wp::float64 var_912;
    const wp::int32 var_913 = 4;
    wp::int32 var_914;
    wp::int32 var_915;
    wp::float64 var_916;
    const wp::int32 var_917 = 0;
    wp::float64 var_918;
    wp::float64 var_919;
    const wp::int32 var_920 = 1;
    wp::float64 var_921;
    wp::float64 var_922;
    wp::float64 var_923;
    const wp::int32 var_924 = 4;
    wp::int32 var_925;
    wp::int32 var_926;
    const wp::int32 var_927 = 1;
    wp::float64 var_928;
    wp::float64 var_929;
    const wp::int32 var_930 = 0;
    wp::float64 var_931;
    wp::float64 var_932;
    wp::float64 var_933;
    const wp::int32 var_934 = 4;
    wp::int32 var_935;
    wp::int32 var_936;
    const wp::int32 var_937 = 2;
    const wp::int32 var_938 = 4;
    wp::int32 var_939;
    wp::int32 var_940;
    wp::float64 var_941;
    const wp::int32 var_942 = 4;
    wp::int32 var_943;
    wp::int32 var_944;
    wp::float64 var_945;
    const wp::int32 var_946 = 0;
    wp::float64 var_947;
    wp::float64 var_948;
    const wp::int32 var_949 = 1;
    wp::float64 var_950;
    wp::float64 var_951;
    wp::float64 var_952;
    const wp::int32 var_953 = 4;
    wp::int32 var_954;
    wp::int32 var_955;
    const wp::int32 var_956 = 1;
    wp::float64 var_957;
    wp::float64 var_958;
    const wp::int32 var_959 = 0;
    wp::float64 var_960;
    wp::float64 var_961;
    wp::float64 var_962;
    const wp::int32 var_963 = 4;
    wp::int32 var_964;
    wp::int32 var_965;
    const wp::int32 var_966 = 3;
    const wp::int32 var_967 = 4;
    wp::int32 var_968;
    wp::int32 var_969;
    wp::float64 var_970;
    const wp::int32 var_971 = 4;
    wp::int32 var_972;
    wp::int32 var_973;
    wp::float64 var_974;
    const wp::int32 var_975 = 0;
    wp::float64 var_976;
    wp::float64 var_977;
    const wp::int32 var_978 = 1;
    wp::float64 var_979;
    wp::float64 var_980;
    wp::float64 var_981;
    const wp::int32 var_982 = 4;
    wp::int32 var_983;
    wp::int32 var_984;
    const wp::int32 var_985 = 1;
    wp::float64 var_986;
    wp::float64 var_987;
    const wp::int32 var_988 = 0;
    wp::float64 var_989;
    wp::float64 var_990;
    wp::float64 var_991;
    const wp::int32 var_992 = 4;
    wp::int32 var_993;
    wp::int32 var_994;
    const wp::int32 var_995 = 0;
    const wp::int32 var_996 = 4;
    wp::int32 var_997;
    wp::int32 var_998;
    wp::float64 var_999;
    const wp::int32 var_1000 = 4;
    wp::int32 var_1001;
    wp::int32 var_1002;
    wp::float64 var_1003;
    const wp::int32 var_1004 = 0;
    wp::float64 var_1005;
    wp::float64 var_1006;
    const wp::int32 var_1007 = 1;
    wp::float64 var_1008;
    wp::float64 var_1009;
    wp::float64 var_1010;
    const wp::int32 var_1011 = 4;
    wp::int32 var_1012;
    wp::int32 var_1013;
    const wp::int32 var_1014 = 1;
    wp::float64 var_1015;
    wp::float64 var_1016;
    const wp::int32 var_1017 = 0;
    wp::float64 var_1018;
    wp::float64 var_1019;
    wp::float64 var_1020;
    const wp::int32 var_1021 = 4;
    wp::int32 var_1022;
    wp::int32 var_1023;
    const wp::int32 var_1024 = 1;
    const wp::int32 var_1025 = 4;
    wp::int32 var_1026;
    wp::int32 var_1027;
    wp::float64 var_1028;
    const wp::int32 var_1029 = 4;
    wp::int32 var_1030;
    wp::int32 var_1031;
    wp::float64 var_1032;
    const wp::int32 var_1033 = 0;
    wp::float64 var_1034;
    wp::float64 var_1035;
    const wp::int32 var_1036 = 1;
    wp::float64 var_1037;
    wp::float64 var_1038;
    wp::float64 var_1039;
    const wp::int32 var_1040 = 4;
    wp::int32 var_1041;
    wp::int32 var_1042;
    const wp::int32 var_1043 = 1;
    wp::float64 var_1044;
    wp::float64 var_1045;
    const wp::int32 var_1046 = 0;
    wp::float64 var_1047;
    wp::float64 var_1048;
    wp::float64 var_1049;
    const wp::int32 var_1050 = 4;
    wp::int32 var_1051;
    wp::int32 var_1052;
    const wp::int32 var_1053 = 2;
    const wp::int32 var_1054 = 4;
    wp::int32 var_1055;
    wp::int32 var_1056;
    wp::float64 var_1057;
    const wp::int32 var_1058 = 4;
    wp::int32 var_1059;
    wp::int32 var_1060;
    wp::float64 var_1061;
    const wp::int32 var_1062 = 0;
    wp::float64 var_1063;
    wp::float64 var_1064;
    const wp::int32 var_1065 = 1;
    wp::float64 var_1066;
    wp::float64 var_1067;
    wp::float64 var_1068;
    const wp::int32 var_1069 = 4;
    wp::int32 var_1070;
    wp::int32 var_1071;
    const wp::int32 var_1072 = 1;
    wp::float64 var_1073;
    wp::float64 var_1074;
    const wp::int32 var_1075 = 0;
    wp::float64 var_1076;
    wp::float64 var_1077;
    wp::float64 var_1078;
    const wp::int32 var_1079 = 4;
    wp::int32 var_1080;
    wp::int32 var_1081;
    const wp::int32 var_1082 = 3;
    const wp::int32 var_1083 = 4;
    wp::int32 var_1084;
    wp::int32 var_1085;
    wp::float64 var_1086;
    const wp::int32 var_1087 = 4;
    wp::int32 var_1088;
    wp::int32 var_1089;
    wp::float64 var_1090;
    const wp::int32 var_1091 = 0;
    wp::float64 var_1092;
    wp::float64 var_1093;
    const wp::int32 var_1094 = 1;
    wp::float64 var_1095;
    wp::float64 var_1096;
    wp::float64 var_1097;
    const wp::int32 var_1098 = 4;
    wp::int32 var_1099;
    wp::int32 var_1100;
    const wp::int32 var_1101 = 1;
    wp::float64 var_1102;
    wp::float64 var_1103;
    const wp::int32 var_1104 = 0;
    wp::float64 var_1105;
    wp::float64 var_1106;
    wp::float64 var_1107;
    const wp::int32 var_1108 = 4;
    wp::int32 var_1109;
    wp::int32 var_1110;
    const wp::int32 var_1111 = 0;
    const wp::int32 var_1112 = 4;
    wp::int32 var_1113;
    wp::int32 var_1114;
    wp::float64 var_1115;
    const wp::int32 var_1116 = 4;
    wp::int32 var_1117;
    wp::int32 var_1118;
    wp::float64 var_1119;
    const wp::int32 var_1120 = 0;
    wp::float64 var_1121;
    wp::float64 var_1122;
    const wp::int32 var_1123 = 1;
    wp::float64 var_1124;
    wp::float64 var_1125;
    wp::float64 var_1126;
    const wp::int32 var_1127 = 4;
    wp::int32 var_1128;
    wp::int32 var_1129;
    const wp::int32 var_1130 = 1;
    wp::float64 var_1131;
    wp::float64 var_1132;
    const wp::int32 var_1133 = 0;
    wp::float64 var_1134;
    wp::float64 var_1135;
    wp::float64 var_1136;
    const wp::int32 var_1137 = 4;
    wp::int32 var_1138;
    wp::int32 var_1139;
    const wp::int32 var_1140 = 1;
    const wp::int32 var_1141 = 4;
    wp::int32 var_1142;
    wp::int32 var_1143;
    wp::float64 var_1144;
    const wp::int32 var_1145 = 4;
    wp::int32 var_1146;
    wp::int32 var_1147;
    wp::float64 var_1148;
    const wp::int32 var_1149 = 0;
    wp::float64 var_1150;
    wp::float64 var_1151;
    const wp::int32 var_1152 = 1;
    wp::float64 var_1153;
    wp::float64 var_1154;
    wp::float64 var_1155;
    const wp::int32 var_1156 = 4;
    wp::int32 var_1157;
    wp::int32 var_1158;
    const wp::int32 var_1159 = 1;
    wp::float64 var_1160;
    wp::float64 var_1161;
    const wp::int32 var_1162 = 0;
    wp::float64 var_1163;
    wp::float64 var_1164;
    wp::float64 var_1165;
    const wp::int32 var_1166 = 4;
    wp::int32 var_1167;
    wp::int32 var_1168;
    const wp::int32 var_1169 = 2;
    const wp::int32 var_1170 = 4;
    wp::int32 var_1171;
    wp::int32 var_1172;
    wp::float64 var_1173;
    const wp::int32 var_1174 = 4;
    wp::int32 var_1175;
    wp::int32 var_1176;
    wp::float64 var_1177;
    const wp::int32 var_1178 = 0;
    wp::float64 var_1179;
    wp::float64 var_1180;
    const wp::int32 var_1181 = 1;
    wp::float64 var_1182;
    wp::float64 var_1183;
    wp::float64 var_1184;
    const wp::int32 var_1185 = 4;
    wp::int32 var_1186;
    wp::int32 var_1187;
    const wp::int32 var_1188 = 1;
    wp::float64 var_1189;
    wp::float64 var_1190;
    const wp::int32 var_1191 = 0;
    wp::float64 var_1192;
    wp::float64 var_1193;
    wp::float64 var_1194;
    const wp::int32 var_1195 = 4;
    wp::int32 var_1196;
    wp::int32 var_1197;
    const wp::int32 var_1198 = 3;
    const wp::int32 var_1199 = 4;
    wp::int32 var_1200;
    wp::int32 var_1201;
    wp::float64 var_1202;
    const wp::int32 var_1203 = 4;
    wp::int32 var_1204;
    wp::int32 var_1205;
    wp::float64 var_1206;
    const wp::int32 var_1207 = 0;
    wp::float64 var_1208;
    wp::float64 var_1209;
    const wp::int32 var_1210 = 1;
    wp::float64 var_1211;
    wp::float64 var_1212;
    wp::float64 var_1213;
    const wp::int32 var_1214 = 4;
    wp::int32 var_1215;
    wp::int32 var_1216;
    const wp::int32 var_1217 = 1;
    wp::float64 var_1218;
    wp::float64 var_1219;
    const wp::int32 var_1220 = 0;
    wp::float64 var_1221;
    wp::float64 var_1222;
    wp::float64 var_1223;
    const wp::int32 var_1224 = 4;
    wp::int32 var_1225;
    wp::int32 var_1226;
    wp::int32 var_1227;
    wp::vec_t<2, wp::float64> var_1228;
    wp::int32 var_1229;
    wp::float64 var_1230;
    wp::float64 var_1231;
    wp::float64 var_1232;
    wp::float64 var_1233;
    wp::float64 var_1234;
    wp::float64 var_1235;
    const wp::int32 var_1236 = 3;
    const wp::int32 var_1237 = 3;
    bool var_1238;
    const wp::int32 var_1239 = 0;
    const wp::int32 var_1240 = 5;
    bool var_1241;
    const wp::int32 var_1242 = 1;
    const wp::int32 var_1243 = 2;
    wp::int32 var_1244;
    wp::int32 var_1245;
    const wp::int32 var_1246 = 1;
    wp::int32 var_1247;
    const wp::int32 var_1248 = 3;
    bool var_1249;
    const wp::int32 var_1250 = 0;
    const wp::int32 var_1251 = 5;
    bool var_1252;
    const wp::int32 var_1253 = 2;
    const wp::int32 var_1254 = 3;
    wp::int32 var_1255;
    wp::int32 var_1256;
    wp::int32 var_1257;
    const wp::int32 var_1258 = 4;
    wp::int32 var_1259;
    wp::int32 var_1260;
    wp::float64 var_1261;
    const wp::int32 var_1262 = 4;
    wp::int32 var_1263;
    wp::int32 var_1264;
    wp::float64 var_1265;
    const wp::int32 var_1266 = 4;
    wp::int32 var_1267;
    wp::int32 var_1268;
    wp::float64 var_1269;
    bool var_1270;
    wp::float64 var_1271;
    wp::float64 var_1272;
    bool var_1273;
    wp::float64 var_1274;
    wp::float64 var_1275;
    wp::float64 var_1276;
    wp::float64 var_1277;
    wp::float64 var_1278;
    wp::float64 var_1279;
    bool var_1280;
    const wp::int32 var_1281 = 1;
    wp::vec_t<2, wp::float64> var_1282;
    const wp::int32 var_1283 = 0;
    const wp::int32 var_1284 = 4;
    wp::int32 var_1285;
    wp::int32 var_1286;
    wp::float64 var_1287;
    const wp::int32 var_1288 = 4;
    wp::int32 var_1289;
    wp::int32 var_1290;
    wp::float64 var_1291;
    const wp::int32 var_1292 = 0;
    wp::float64 var_1293;
    wp::float64 var_1294;
    const wp::int32 var_1295 = 1;
    wp::float64 var_1296;
    wp::float64 var_1297;
    wp::float64 var_1298;
    const wp::int32 var_1299 = 4;
    wp::int32 var_1300;
    wp::int32 var_1301;
    const wp::int32 var_1302 = 1;
    wp::float64 var_1303;
    wp::float64 var_1304;
    const wp::int32 var_1305 = 0;
    wp::float64 var_1306;
    wp::float64 var_1307;
    wp::float64 var_1308;
    const wp::int32 var_1309 = 4;
    wp::int32 var_1310;
    wp::int32 var_1311;
    const wp::int32 var_1312 = 1;
    const wp::int32 var_1313 = 4;
    wp::int32 var_1314;
    wp::int32 var_1315;
    wp::float64 var_1316;
    const wp::int32 var_1317 = 4;
    wp::int32 var_1318;
    wp::int32 var_1319;
    wp::float64 var_1320;
    const wp::int32 var_1321 = 0;
    wp::float64 var_1322;
    wp::float64 var_1323;
    const wp::int32 var_1324 = 1;
    wp::float64 var_1325;
    wp::float64 var_1326;
    wp::float64 var_1327;
    const wp::int32 var_1328 = 4;
    wp::int32 var_1329;
    wp::int32 var_1330;
    const wp::int32 var_1331 = 1;
    wp::float64 var_1332;
    wp::float64 var_1333;
    const wp::int32 var_1334 = 0;
    wp::float64 var_1335;
    wp::float64 var_1336;
    wp::float64 var_1337;
    const wp::int32 var_1338 = 4;
    wp::int32 var_1339;
    wp::int32 var_1340;
    const wp::int32 var_1341 = 2;
    const wp::int32 var_1342 = 4;
    wp::int32 var_1343;
    wp::int32 var_1344;
    wp::float64 var_1345;
    const wp::int32 var_1346 = 4;
    wp::int32 var_1347;
    wp::int32 var_1348;
    wp::float64 var_1349;
    const wp::int32 var_1350 = 0;
    wp::float64 var_1351;
    wp::float64 var_1352;
    const wp::int32 var_1353 = 1;
    wp::float64 var_1354;
    wp::float64 var_1355;
    wp::float64 var_1356;
    const wp::int32 var_1357 = 4;
    wp::int32 var_1358;
    wp::int32 var_1359;
    const wp::int32 var_1360 = 1;
    wp::float64 var_1361;
    wp::float64 var_1362;
    const wp::int32 var_1363 = 0;
    wp::float64 var_1364;
    wp::float64 var_1365;
    wp::float64 var_1366;
    const wp::int32 var_1367 = 4;
    wp::int32 var_1368;
    wp::int32 var_1369;
    const wp::int32 var_1370 = 3;
    const wp::int32 var_1371 = 4;
    wp::int32 var_1372;
    wp::int32 var_1373;
    wp::float64 var_1374;
    const wp::int32 var_1375 = 4;
    wp::int32 var_1376;
    wp::int32 var_1377;
    wp::float64 var_1378;
    const wp::int32 var_1379 = 0;
    wp::float64 var_1380;
    wp::float64 var_1381;
    const wp::int32 var_1382 = 1;
    wp::float64 var_1383;
    wp::float64 var_1384;
    wp::float64 var_1385;
    const wp::int32 var_1386 = 4;
    wp::int32 var_1387;
    wp::int32 var_1388;
    const wp::int32 var_1389 = 1;
    wp::float64 var_1390;
    wp::float64 var_1391;
    const wp::int32 var_1392 = 0;
    wp::float64 var_1393;
    wp::float64 var_1394;
    wp::float64 var_1395;
    const wp::int32 var_1396 = 4;
    wp::int32 var_1397;
    wp::int32 var_1398;
    const wp::int32 var_1399 = 0;
    const wp::int32 var_1400 = 4;
    wp::int32 var_1401;
    wp::int32 var_1402;
    wp::float64 var_1403;
    const wp::int32 var_1404 = 4;
    wp::int32 var_1405;
    wp::int32 var_1406;
    wp::float64 var_1407;
    const wp::int32 var_1408 = 0;
    wp::float64 var_1409;
    wp::float64 var_1410;
    const wp::int32 var_1411 = 1;
    wp::float64 var_1412;
    wp::float64 var_1413;
    wp::float64 var_1414;
    const wp::int32 var_1415 = 4;
    wp::int32 var_1416;
    wp::int32 var_1417;
    const wp::int32 var_1418 = 1;
    wp::float64 var_1419;
    wp::float64 var_1420;
    const wp::int32 var_1421 = 0;
    wp::float64 var_1422;
    wp::float64 var_1423;
    wp::float64 var_1424;
    const wp::int32 var_1425 = 4;
    wp::int32 var_1426;
    wp::int32 var_1427;
    const wp::int32 var_1428 = 1;
    const wp::int32 var_1429 = 4;
    wp::int32 var_1430;
    wp::int32 var_1431;
    wp::float64 var_1432;
    const wp::int32 var_1433 = 4;
    wp::int32 var_1434;
    wp::int32 var_1435;
    wp::float64 var_1436;
    const wp::int32 var_1437 = 0;
    wp::float64 var_1438;
    wp::float64 var_1439;
    const wp::int32 var_1440 = 1;
    wp::float64 var_1441;
    wp::float64 var_1442;
    wp::float64 var_1443;
    const wp::int32 var_1444 = 4;
    wp::int32 var_1445;
    wp::int32 var_1446;
    const wp::int32 var_1447 = 1;
    wp::float64 var_1448;
    wp::float64 var_1449;
    const wp::int32 var_1450 = 0;
    wp::float64 var_1451;
    wp::float64 var_1452;
    wp::float64 var_1453;
    const wp::int32 var_1454 = 4;
    wp::int32 var_1455;
    wp::int32 var_1456;
    const wp::int32 var_1457 = 2;
    const wp::int32 var_1458 = 4;
    wp::int32 var_1459;
    wp::int32 var_1460;
    wp::float64 var_1461;
    const wp::int32 var_1462 = 4;
    wp::int32 var_1463;
    wp::int32 var_1464;
    wp::float64 var_1465;
    const wp::int32 var_1466 = 0;
    wp::float64 var_1467;
    wp::float64 var_1468;
    const wp::int32 var_1469 = 1;
    wp::float64 var_1470;
    wp::float64 var_1471;
    wp::float64 var_1472;
    const wp::int32 var_1473 = 4;
    wp::int32 var_1474;
    wp::int32 var_1475;
    const wp::int32 var_1476 = 1;
    wp::float64 var_1477;
    wp::float64 var_1478;
    const wp::int32 var_1479 = 0;
    wp::float64 var_1480;
    wp::float64 var_1481;
    wp::float64 var_1482;
    const wp::int32 var_1483 = 4;
    wp::int32 var_1484;
    wp::int32 var_1485;
    const wp::int32 var_1486 = 3;
    const wp::int32 var_1487 = 4;
    wp::int32 var_1488;
    wp::int32 var_1489;
    wp::float64 var_1490;
    const wp::int32 var_1491 = 4;
    wp::int32 var_1492;
    wp::int32 var_1493;
    wp::float64 var_1494;
    const wp::int32 var_1495 = 0;
    wp::float64 var_1496;
    wp::float64 var_1497;
    const wp::int32 var_1498 = 1;
    wp::float64 var_1499;
    wp::float64 var_1500;
    wp::float64 var_1501;
    const wp::int32 var_1502 = 4;
    wp::int32 var_1503;
    wp::int32 var_1504;
    const wp::int32 var_1505 = 1;
    wp::float64 var_1506;
    wp::float64 var_1507;
    const wp::int32 var_1508 = 0;
    wp::float64 var_1509;
    wp::float64 var_1510;
    wp::float64 var_1511;
    const wp::int32 var_1512 = 4;
    wp::int32 var_1513;
    wp::int32 var_1514;
    const wp::int32 var_1515 = 0;
    const wp::int32 var_1516 = 4;
    wp::int32 var_1517;
    wp::int32 var_1518;
    wp::float64 var_1519;
    const wp::int32 var_1520 = 4;
    wp::int32 var_1521;
    wp::int32 var_1522;
    wp::float64 var_1523;
    const wp::int32 var_1524 = 0;
    wp::float64 var_1525;
    wp::float64 var_1526;
    const wp::int32 var_1527 = 1;
    wp::float64 var_1528;
    wp::float64 var_1529;
    wp::float64 var_1530;
    const wp::int32 var_1531 = 4;
    wp::int32 var_1532;
    wp::int32 var_1533;
    const wp::int32 var_1534 = 1;
    wp::float64 var_1535;
    wp::float64 var_1536;
    const wp::int32 var_1537 = 0;
    wp::float64 var_1538;
    wp::float64 var_1539;
    wp::float64 var_1540;
    const wp::int32 var_1541 = 4;
    wp::int32 var_1542;
    wp::int32 var_1543;
    const wp::int32 var_1544 = 1;
    const wp::int32 var_1545 = 4;
    wp::int32 var_1546;
    wp::int32 var_1547;
    wp::float64 var_1548;
    const wp::int32 var_1549 = 4;
    wp::int32 var_1550;
    wp::int32 var_1551;
    wp::float64 var_1552;
    const wp::int32 var_1553 = 0;
    wp::float64 var_1554;
    wp::float64 var_1555;
    const wp::int32 var_1556 = 1;
    wp::float64 var_1557;
    wp::float64 var_1558;
    wp::float64 var_1559;
    const wp::int32 var_1560 = 4;
    wp::int32 var_1561;
    wp::int32 var_1562;
    const wp::int32 var_1563 = 1;
    wp::float64 var_1564;
    wp::float64 var_1565;
    const wp::int32 var_1566 = 0;
    wp::float64 var_1567;
    wp::float64 var_1568;
    wp::float64 var_1569;
    const wp::int32 var_1570 = 4;
    wp::int32 var_1571;
    wp::int32 var_1572;
    const wp::int32 var_1573 = 2;
    const wp::int32 var_1574 = 4;
    wp::int32 var_1575;
    wp::int32 var_1576;
    wp::float64 var_1577;
    const wp::int32 var_1578 = 4;
    wp::int32 var_1579;
    wp::int32 var_1580;
    wp::float64 var_1581;
    const wp::int32 var_1582 = 0;
    wp::float64 var_1583;
    wp::float64 var_1584;
    const wp::int32 var_1585 = 1;
    wp::float64 var_1586;
    wp::float64 var_1587;
    wp::float64 var_1588;
    const wp::int32 var_1589 = 4;
    wp::int32 var_1590;
    wp::int32 var_1591;
    const wp::int32 var_1592 = 1;
    wp::float64 var_1593;
    wp::float64 var_1594;
    const wp::int32 var_1595 = 0;
    wp::float64 var_1596;
    wp::float64 var_1597;
    wp::float64 var_1598;
    const wp::int32 var_1599 = 4;
    wp::int32 var_1600;
    wp::int32 var_1601;
    const wp::int32 var_1602 = 3;
    const wp::int32 var_1603 = 4;
    wp::int32 var_1604;
    wp::int32 var_1605;
    wp::float64 var_1606;
    const wp::int32 var_1607 = 4;
    wp::int32 var_1608;
    wp::int32 var_1609;
    wp::float64 var_1610;
    const wp::int32 var_1611 = 0;
    wp::float64 var_1612;
    wp::float64 var_1613;
    const wp::int32 var_1614 = 1;
    wp::float64 var_1615;
    wp::float64 var_1616;
    wp::float64 var_1617;
    const wp::int32 var_1618 = 4;
    wp::int32 var_1619;
    wp::int32 var_1620;
    const wp::int32 var_1621 = 1;
    wp::float64 var_1622;
    wp::float64 var_1623;
    const wp::int32 var_1624 = 0;
    wp::float64 var_1625;
    wp::float64 var_1626;
    wp::float64 var_1627;
    const wp::int32 var_1628 = 4;
    wp::int32 var_1629;
    wp::int32 var_1630;
    wp::int32 var_1631;
    wp::vec_t<2, wp::float64> var_1632;
    wp::int32 var_1633;
    wp::float64 var_1634;
    wp::float64 var_1635;
    wp::float64 var_1636;
    wp::float64 var_1637;
    wp::float64 var_1638;
    wp::float64 var_1639;
    const wp::int32 var_1640 = 4;
    const wp::int32 var_1641 = 3;
    bool var_1642;
    const wp::int32 var_1643 = 0;
    const wp::int32 var_1644 = 5;
    bool var_1645;
    const wp::int32 var_1646 = 1;
    const wp::int32 var_1647 = 2;
    wp::int32 var_1648;
    wp::int32 var_1649;
    const wp::int32 var_1650 = 1;
    wp::int32 var_1651;
    const wp::int32 var_1652 = 3;
    bool var_1653;
    const wp::int32 var_1654 = 0;
    const wp::int32 var_1655 = 5;
    bool var_1656;
    const wp::int32 var_1657 = 2;
    const wp::int32 var_1658 = 3;
    wp::int32 var_1659;
    wp::int32 var_1660;
    wp::int32 var_1661;
    const wp::int32 var_1662 = 4;
    wp::int32 var_1663;
    wp::int32 var_1664;
    wp::float64 var_1665;
    const wp::int32 var_1666 = 4;
    wp::int32 var_1667;
    wp::int32 var_1668;
    wp::float64 var_1669;
    const wp::int32 var_1670 = 4;
    wp::int32 var_1671;
    wp::int32 var_1672;
    wp::float64 var_1673;
    bool var_1674;
    wp::float64 var_1675;
    wp::float64 var_1676;
    bool var_1677;
    wp::float64 var_1678;
    wp::float64 var_1679;
    wp::float64 var_1680;
    wp::float64 var_1681;
    wp::float64 var_1682;
    wp::float64 var_1683;
    bool var_1684;
    const wp::int32 var_1685 = 1;
    wp::vec_t<2, wp::float64> var_1686;
    const wp::int32 var_1687 = 0;
    const wp::int32 var_1688 = 4;
    wp::int32 var_1689;
    wp::int32 var_1690;
    wp::float64 var_1691;
    const wp::int32 var_1692 = 4;
    wp::int32 var_1693;
    wp::int32 var_1694;
    wp::float64 var_1695;
    const wp::int32 var_1696 = 0;
    wp::float64 var_1697;
    wp::float64 var_1698;
    const wp::int32 var_1699 = 1;
    wp::float64 var_1700;
    wp::float64 var_1701;
    wp::float64 var_1702;
    const wp::int32 var_1703 = 4;
    wp::int32 var_1704;
    wp::int32 var_1705;
    const wp::int32 var_1706 = 1;
    wp::float64 var_1707;
    wp::float64 var_1708;
    const wp::int32 var_1709 = 0;
    wp::float64 var_1710;
    wp::float64 var_1711;
    wp::float64 var_1712;
    const wp::int32 var_1713 = 4;
    wp::int32 var_1714;
    wp::int32 var_1715;
    const wp::int32 var_1716 = 1;
    const wp::int32 var_1717 = 4;
    wp::int32 var_1718;
    wp::int32 var_1719;
    wp::float64 var_1720;
    const wp::int32 var_1721 = 4;
    wp::int32 var_1722;
    wp::int32 var_1723;
    wp::float64 var_1724;
    const wp::int32 var_1725 = 0;
    wp::float64 var_1726;
    wp::float64 var_1727;
    const wp::int32 var_1728 = 1;
    wp::float64 var_1729;
    wp::float64 var_1730;
    wp::float64 var_1731;
    const wp::int32 var_1732 = 4;
    wp::int32 var_1733;
    wp::int32 var_1734;
    const wp::int32 var_1735 = 1;
    wp::float64 var_1736;
    wp::float64 var_1737;
    const wp::int32 var_1738 = 0;
    wp::float64 var_1739;
    wp::float64 var_1740;
    wp::float64 var_1741;
    const wp::int32 var_1742 = 4;
    wp::int32 var_1743;
    wp::int32 var_1744;
    const wp::int32 var_1745 = 2;
    const wp::int32 var_1746 = 4;
    wp::int32 var_1747;
    wp::int32 var_1748;
    wp::float64 var_1749;
    const wp::int32 var_1750 = 4;
    wp::int32 var_1751;
    wp::int32 var_1752;
    wp::float64 var_1753;
    const wp::int32 var_1754 = 0;
    wp::float64 var_1755;
    wp::float64 var_1756;
    const wp::int32 var_1757 = 1;
    wp::float64 var_1758;
    wp::float64 var_1759;
    wp::float64 var_1760;
    const wp::int32 var_1761 = 4;
    wp::int32 var_1762;
    wp::int32 var_1763;
    const wp::int32 var_1764 = 1;
    wp::float64 var_1765;
    wp::float64 var_1766;
    const wp::int32 var_1767 = 0;
    wp::float64 var_1768;
    wp::float64 var_1769;
    wp::float64 var_1770;
    const wp::int32 var_1771 = 4;
    wp::int32 var_1772;
    wp::int32 var_1773;
    const wp::int32 var_1774 = 3;
    const wp::int32 var_1775 = 4;
    wp::int32 var_1776;
    wp::int32 var_1777;
    wp::float64 var_1778;
    const wp::int32 var_1779 = 4;
    wp::int32 var_1780;
    wp::int32 var_1781;
    wp::float64 var_1782;
    const wp::int32 var_1783 = 0;
    wp::float64 var_1784;
    wp::float64 var_1785;
    const wp::int32 var_1786 = 1;
    wp::float64 var_1787;
    wp::float64 var_1788;
    wp::float64 var_1789;
    const wp::int32 var_1790 = 4;
    wp::int32 var_1791;
    wp::int32 var_1792;
    const wp::int32 var_1793 = 1;
    wp::float64 var_1794;
    wp::float64 var_1795;
    const wp::int32 var_1796 = 0;
    wp::float64 var_1797;
    wp::float64 var_1798;
    wp::float64 var_1799;
    const wp::int32 var_1800 = 4;
    wp::int32 var_1801;
    wp::int32 var_1802;
    const wp::int32 var_1803 = 0;
    const wp::int32 var_1804 = 4;
    wp::int32 var_1805;
    wp::int32 var_1806;
    wp::float64 var_1807;
    const wp::int32 var_1808 = 4;
    wp::int32 var_1809;
    wp::int32 var_1810;
    wp::float64 var_1811;
    const wp::int32 var_1812 = 0;
    wp::float64 var_1813;
    wp::float64 var_1814;
    const wp::int32 var_1815 = 1;
    wp::float64 var_1816;
    wp::float64 var_1817;
    wp::float64 var_1818;
    const wp::int32 var_1819 = 4;
    wp::int32 var_1820;
    wp::int32 var_1821;
    const wp::int32 var_1822 = 1;
    wp::float64 var_1823;
    wp::float64 var_1824;
    const wp::int32 var_1825 = 0;
    wp::float64 var_1826;
    wp::float64 var_1827;
    wp::float64 var_1828;
    const wp::int32 var_1829 = 4;
    wp::int32 var_1830;
    wp::int32 var_1831;
    const wp::int32 var_1832 = 1;
    const wp::int32 var_1833 = 4;
    wp::int32 var_1834;
    wp::int32 var_1835;
    wp::float64 var_1836;
    const wp::int32 var_1837 = 4;
    wp::int32 var_1838;
    wp::int32 var_1839;
    wp::float64 var_1840;
    const wp::int32 var_1841 = 0;
    wp::float64 var_1842;
    wp::float64 var_1843;
    const wp::int32 var_1844 = 1;
    wp::float64 var_1845;
    wp::float64 var_1846;
    wp::float64 var_1847;
    const wp::int32 var_1848 = 4;
    wp::int32 var_1849;
    wp::int32 var_1850;
    const wp::int32 var_1851 = 1;
    wp::float64 var_1852;
    wp::float64 var_1853;
    const wp::int32 var_1854 = 0;
    wp::float64 var_1855;
    wp::float64 var_1856;
    wp::float64 var_1857;
    const wp::int32 var_1858 = 4;
    wp::int32 var_1859;
    wp::int32 var_1860;
    const wp::int32 var_1861 = 2;
    const wp::int32 var_1862 = 4;
    wp::int32 var_1863;
    wp::int32 var_1864;
    wp::float64 var_1865;
    const wp::int32 var_1866 = 4;
    wp::int32 var_1867;
    wp::int32 var_1868;
    wp::float64 var_1869;
    const wp::int32 var_1870 = 0;
    wp::float64 var_1871;
    wp::float64 var_1872;
    const wp::int32 var_1873 = 1;
    wp::float64 var_1874;
    wp::float64 var_1875;
    wp::float64 var_1876;
    const wp::int32 var_1877 = 4;
    wp::int32 var_1878;
    wp::int32 var_1879;
    const wp::int32 var_1880 = 1;
    wp::float64 var_1881;
    wp::float64 var_1882;
    const wp::int32 var_1883 = 0;
    wp::float64 var_1884;
    wp::float64 var_1885;
    wp::float64 var_1886;
    const wp::int32 var_1887 = 4;
    wp::int32 var_1888;
    wp::int32 var_1889;
    const wp::int32 var_1890 = 3;
    const wp::int32 var_1891 = 4;
    wp::int32 var_1892;
    wp::int32 var_1893;
    wp::float64 var_1894;
    const wp::int32 var_1895 = 4;
    wp::int32 var_1896;
    wp::int32 var_1897;
    wp::float64 var_1898;
    const wp::int32 var_1899 = 0;
    wp::float64 var_1900;
    wp::float64 var_1901;
    const wp::int32 var_1902 = 1;
    wp::float64 var_1903;
    wp::float64 var_1904;
    wp::float64 var_1905;
    const wp::int32 var_1906 = 4;
    wp::int32 var_1907;
    wp::int32 var_1908;
    const wp::int32 var_1909 = 1;
    wp::float64 var_1910;
    wp::float64 var_1911;
    const wp::int32 var_1912 = 0;
    wp::float64 var_1913;
    wp::float64 var_1914;
    wp::float64 var_1915;
    const wp::int32 var_1916 = 4;
    wp::int32 var_1917;
    wp::int32 var_1918;
    const wp::int32 var_1919 = 0;
    const wp::int32 var_1920 = 4;
    wp::int32 var_1921;
    wp::int32 var_1922;
    wp::float64 var_1923;
    const wp::int32 var_1924 = 4;
    wp::int32 var_1925;
    wp::int32 var_1926;
    wp::float64 var_1927;
    const wp::int32 var_1928 = 0;
    wp::float64 var_1929;
    wp::float64 var_1930;
    const wp::int32 var_1931 = 1;
    wp::float64 var_1932;
    wp::float64 var_1933;
    wp::float64 var_1934;
    const wp::int32 var_1935 = 4;
    wp::int32 var_1936;
    wp::int32 var_1937;
    const wp::int32 var_1938 = 1;
    wp::float64 var_1939;
    wp::float64 var_1940;
    const wp::int32 var_1941 = 0;
    wp::float64 var_1942;
    wp::float64 var_1943;
    wp::float64 var_1944;
    const wp::int32 var_1945 = 4;
    wp::int32 var_1946;
    wp::int32 var_1947;
    const wp::int32 var_1948 = 1;
    const wp::int32 var_1949 = 4;
    wp::int32 var_1950;
    wp::int32 var_1951;
    wp::float64 var_1952;
    const wp::int32 var_1953 = 4;
    wp::int32 var_1954;
    wp::int32 var_1955;
    wp::float64 var_1956;
    const wp::int32 var_1957 = 0;
    wp::float64 var_1958;
    wp::float64 var_1959;
    const wp::int32 var_1960 = 1;
    wp::float64 var_1961;
    wp::float64 var_1962;
    wp::float64 var_1963;
    const wp::int32 var_1964 = 4;
    wp::int32 var_1965;
    wp::int32 var_1966;
    const wp::int32 var_1967 = 1;
    wp::float64 var_1968;
    wp::float64 var_1969;
    const wp::int32 var_1970 = 0;
    wp::float64 var_1971;
    wp::float64 var_1972;
    wp::float64 var_1973;
    const wp::int32 var_1974 = 4;
    wp::int32 var_1975;
    wp::int32 var_1976;
    const wp::int32 var_1977 = 2;
    const wp::int32 var_1978 = 4;
    wp::int32 var_1979;
    wp::int32 var_1980;
    wp::float64 var_1981;
    const wp::int32 var_1982 = 4;
    wp::int32 var_1983;
    wp::int32 var_1984;
    wp::float64 var_1985;
    const wp::int32 var_1986 = 0;
    wp::float64 var_1987;
    wp::float64 var_1988;
    const wp::int32 var_1989 = 1;
    wp::float64 var_1990;
    wp::float64 var_1991;
    wp::float64 var_1992;
    const wp::int32 var_1993 = 4;
    wp::int32 var_1994;
    wp::int32 var_1995;
    const wp::int32 var_1996 = 1;
    wp::float64 var_1997;
    wp::float64 var_1998;
    const wp::int32 var_1999 = 0;
    wp::float64 var_2000;
    wp::float64 var_2001;
    wp::float64 var_2002;
    const wp::int32 var_2003 = 4;
    wp::int32 var_2004;
    wp::int32 var_2005;
    const wp::int32 var_2006 = 3;
    const wp::int32 var_2007 = 4;
    wp::int32 var_2008;
    wp::int32 var_2009;
    wp::float64 var_2010;
    const wp::int32 var_2011 = 4;
    wp::int32 var_2012;
    wp::int32 var_2013;
    wp::float64 var_2014;
    const wp::int32 var_2015 = 0;
    wp::float64 var_2016;
    wp::float64 var_2017;
    const wp::int32 var_2018 = 1;
    wp::float64 var_2019;
    wp::float64 var_2020;
    wp::float64 var_2021;
    const wp::int32 var_2022 = 4;
    wp::int32 var_2023;
    wp::int32 var_2024;
    const wp::int32 var_2025 = 1;
    wp::float64 var_2026;
    wp::float64 var_2027;
    const wp::int32 var_2028 = 0;
    wp::float64 var_2029;
    wp::float64 var_2030;
    wp::float64 var_2031;
    const wp::int32 var_2032 = 4;
    wp::int32 var_2033;
    wp::int32 var_2034;
    wp::int32 var_2035;
    wp::vec_t<2, wp::float64> var_2036;
    wp::int32 var_2037;
    wp::float64 var_2038;
    wp::float64 var_2039;
    wp::float64 var_2040;
    wp::float64 var_2041;
    wp::float64 var_2042;
    wp::float64 var_2043;
    const wp::int32 var_2044 = 5;
    const wp::int32 var_2045 = 3;
    bool var_2046;
    const wp::int32 var_2047 = 0;
    const wp::int32 var_2048 = 5;
    bool var_2049;
    const wp::int32 var_2050 = 1;
    const wp::int32 var_2051 = 2;
    wp::int32 var_2052;
    wp::int32 var_2053;
    const wp::int32 var_2054 = 1;
    wp::int32 var_2055;
    const wp::int32 var_2056 = 3;
    bool var_2057;
    const wp::int32 var_2058 = 0;
    const wp::int32 var_2059 = 5;
    bool var_2060;
    const wp::int32 var_2061 = 2;
    const wp::int32 var_2062 = 3;
    wp::int32 var_2063;
    wp::int32 var_2064;
    wp::int32 var_2065;
    const wp::int32 var_2066 = 4;
    wp::int32 var_2067;
    wp::int32 var_2068;
    wp::float64 var_2069;
    const wp::int32 var_2070 = 4;
    wp::int32 var_2071;
    wp::int32 var_2072;
    wp::float64 var_2073;
    const wp::int32 var_2074 = 4;
    wp::int32 var_2075;
    wp::int32 var_2076;
    wp::float64 var_2077;
    bool var_2078;
    wp::float64 var_2079;
    wp::float64 var_2080;
    bool var_2081;
    wp::float64 var_2082;
    wp::float64 var_2083;
    wp::float64 var_2084;
    wp::float64 var_2085;
    wp::float64 var_2086;
    wp::float64 var_2087;
    bool var_2088;
    const wp::int32 var_2089 = 1;
    wp::vec_t<2, wp::float64> var_2090;
    const wp::int32 var_2091 = 0;
    const wp::int32 var_2092 = 4;
    wp::int32 var_2093;
    wp::int32 var_2094;
    wp::float64 var_2095;
    const wp::int32 var_2096 = 4;
    wp::int32 var_2097;
    wp::int32 var_2098;
    wp::float64 var_2099;
    const wp::int32 var_2100 = 0;
    wp::float64 var_2101;
    wp::float64 var_2102;
    const wp::int32 var_2103 = 1;
    wp::float64 var_2104;
    wp::float64 var_2105;
    wp::float64 var_2106;
    const wp::int32 var_2107 = 4;
    wp::int32 var_2108;
    wp::int32 var_2109;
    const wp::int32 var_2110 = 1;
    wp::float64 var_2111;
    wp::float64 var_2112;
    const wp::int32 var_2113 = 0;
    wp::float64 var_2114;
    wp::float64 var_2115;
    wp::float64 var_2116;
    const wp::int32 var_2117 = 4;
    wp::int32 var_2118;
    wp::int32 var_2119;
    const wp::int32 var_2120 = 1;
    const wp::int32 var_2121 = 4;
    wp::int32 var_2122;
    wp::int32 var_2123;
    wp::float64 var_2124;
    const wp::int32 var_2125 = 4;
    wp::int32 var_2126;
    wp::int32 var_2127;
    wp::float64 var_2128;
    const wp::int32 var_2129 = 0;
    wp::float64 var_2130;
    wp::float64 var_2131;
    const wp::int32 var_2132 = 1;
    wp::float64 var_2133;
    wp::float64 var_2134;
    wp::float64 var_2135;
    const wp::int32 var_2136 = 4;
    wp::int32 var_2137;
    wp::int32 var_2138;
    const wp::int32 var_2139 = 1;
    wp::float64 var_2140;
    wp::float64 var_2141;
    const wp::int32 var_2142 = 0;
    wp::float64 var_2143;
    wp::float64 var_2144;
    wp::float64 var_2145;
    const wp::int32 var_2146 = 4;
    wp::int32 var_2147;
    wp::int32 var_2148;
    const wp::int32 var_2149 = 2;
    const wp::int32 var_2150 = 4;
    wp::int32 var_2151;
    wp::int32 var_2152;
    wp::float64 var_2153;
    const wp::int32 var_2154 = 4;
    wp::int32 var_2155;
    wp::int32 var_2156;
    wp::float64 var_2157;
    const wp::int32 var_2158 = 0;
    wp::float64 var_2159;
    wp::float64 var_2160;
    const wp::int32 var_2161 = 1;
    wp::float64 var_2162;
    wp::float64 var_2163;
    wp::float64 var_2164;
    const wp::int32 var_2165 = 4;
    wp::int32 var_2166;
    wp::int32 var_2167;
    const wp::int32 var_2168 = 1;
    wp::float64 var_2169;
    wp::float64 var_2170;
    const wp::int32 var_2171 = 0;
    wp::float64 var_2172;
    wp::float64 var_2173;
    wp::float64 var_2174;
    const wp::int32 var_2175 = 4;
    wp::int32 var_2176;
    wp::int32 var_2177;
    const wp::int32 var_2178 = 3;
    const wp::int32 var_2179 = 4;
    wp::int32 var_2180;
    wp::int32 var_2181;
    wp::float64 var_2182;
    const wp::int32 var_2183 = 4;
    wp::int32 var_2184;
    wp::int32 var_2185;
    wp::float64 var_2186;
    const wp::int32 var_2187 = 0;
    wp::float64 var_2188;
    wp::float64 var_2189;
    const wp::int32 var_2190 = 1;
    wp::float64 var_2191;
    wp::float64 var_2192;
    wp::float64 var_2193;
    const wp::int32 var_2194 = 4;
    wp::int32 var_2195;
    wp::int32 var_2196;
    const wp::int32 var_2197 = 1;
    wp::float64 var_2198;
    wp::float64 var_2199;
    const wp::int32 var_2200 = 0;
    wp::float64 var_2201;
    wp::float64 var_2202;
    wp::float64 var_2203;
    const wp::int32 var_2204 = 4;
    wp::int32 var_2205;
    wp::int32 var_2206;
    const wp::int32 var_2207 = 0;
    const wp::int32 var_2208 = 4;
    wp::int32 var_2209;
    wp::int32 var_2210;
    wp::float64 var_2211;
    const wp::int32 var_2212 = 4;
    wp::int32 var_2213;
    wp::int32 var_2214;
    wp::float64 var_2215;
    const wp::int32 var_2216 = 0;
    wp::float64 var_2217;
    wp::float64 var_2218;
    const wp::int32 var_2219 = 1;
    wp::float64 var_2220;
    wp::float64 var_2221;
    wp::float64 var_2222;
    const wp::int32 var_2223 = 4;
    wp::int32 var_2224;
    wp::int32 var_2225;
    const wp::int32 var_2226 = 1;
    wp::float64 var_2227;
    wp::float64 var_2228;
    const wp::int32 var_2229 = 0;
    wp::float64 var_2230;
    wp::float64 var_2231;
    wp::float64 var_2232;
    const wp::int32 var_2233 = 4;
    wp::int32 var_2234;
    wp::int32 var_2235;
    const wp::int32 var_2236 = 1;
    const wp::int32 var_2237 = 4;
    wp::int32 var_2238;
    wp::int32 var_2239;
    wp::float64 var_2240;
    const wp::int32 var_2241 = 4;
    wp::int32 var_2242;
    wp::int32 var_2243;
    wp::float64 var_2244;
    const wp::int32 var_2245 = 0;
    wp::float64 var_2246;
    wp::float64 var_2247;
    const wp::int32 var_2248 = 1;
    wp::float64 var_2249;
    wp::float64 var_2250;
    wp::float64 var_2251;
    const wp::int32 var_2252 = 4;
    wp::int32 var_2253;
    wp::int32 var_2254;
    const wp::int32 var_2255 = 1;
    wp::float64 var_2256;
    wp::float64 var_2257;
    const wp::int32 var_2258 = 0;
    wp::float64 var_2259;
    wp::float64 var_2260;
    wp::float64 var_2261;
    const wp::int32 var_2262 = 4;
    wp::int32 var_2263;
    wp::int32 var_2264;
    const wp::int32 var_2265 = 2;
    const wp::int32 var_2266 = 4;
    wp::int32 var_2267;
    wp::int32 var_2268;
    wp::float64 var_2269;
    const wp::int32 var_2270 = 4;
    wp::int32 var_2271;
    wp::int32 var_2272;
    wp::float64 var_2273;
    const wp::int32 var_2274 = 0;
    wp::float64 var_2275;
    wp::float64 var_2276;
    const wp::int32 var_2277 = 1;
    wp::float64 var_2278;
    wp::float64 var_2279;
    wp::float64 var_2280;
    const wp::int32 var_2281 = 4;
    wp::int32 var_2282;
    wp::int32 var_2283;
    const wp::int32 var_2284 = 1;
    wp::float64 var_2285;
    wp::float64 var_2286;
    const wp::int32 var_2287 = 0;
    wp::float64 var_2288;
    wp::float64 var_2289;
    wp::float64 var_2290;
    const wp::int32 var_2291 = 4;
    wp::int32 var_2292;
    wp::int32 var_2293;
    const wp::int32 var_2294 = 3;
    const wp::int32 var_2295 = 4;
    wp::int32 var_2296;
    wp::int32 var_2297;
    wp::float64 var_2298;
    const wp::int32 var_2299 = 4;
    wp::int32 var_2300;
    wp::int32 var_2301;
    wp::float64 var_2302;
    const wp::int32 var_2303 = 0;
    wp::float64 var_2304;
    wp::float64 var_2305;
    const wp::int32 var_2306 = 1;
    wp::float64 var_2307;
    wp::float64 var_2308;
    wp::float64 var_2309;
    const wp::int32 var_2310 = 4;
    wp::int32 var_2311;
    wp::int32 var_2312;
    const wp::int32 var_2313 = 1;
    wp::float64 var_2314;
    wp::float64 var_2315;
    const wp::int32 var_2316 = 0;
    wp::float64 var_2317;
    wp::float64 var_2318;
    wp::float64 var_2319;
    const wp::int32 var_2320 = 4;
    wp::int32 var_2321;
    wp::int32 var_2322;
    const wp::int32 var_2323 = 0;
    const wp::int32 var_2324 = 4;
    wp::int32 var_2325;
    wp::int32 var_2326;
    wp::float64 var_2327;
    const wp::int32 var_2328 = 4;
    wp::int32 var_2329;
    wp::int32 var_2330;
    wp::float64 var_2331;
    const wp::int32 var_2332 = 0;
    wp::float64 var_2333;
    wp::float64 var_2334;
    const wp::int32 var_2335 = 1;
    wp::float64 var_2336;
    wp::float64 var_2337;
    wp::float64 var_2338;
    const wp::int32 var_2339 = 4;
    wp::int32 var_2340;
    wp::int32 var_2341;
    const wp::int32 var_2342 = 1;
    wp::float64 var_2343;
    wp::float64 var_2344;
    const wp::int32 var_2345 = 0;
    wp::float64 var_2346;
    wp::float64 var_2347;
    wp::float64 var_2348;
    const wp::int32 var_2349 = 4;
    wp::int32 var_2350;
    wp::int32 var_2351;
    const wp::int32 var_2352 = 1;
    const wp::int32 var_2353 = 4;
    wp::int32 var_2354;
    wp::int32 var_2355;
    wp::float64 var_2356;
    const wp::int32 var_2357 = 4;
    wp::int32 var_2358;
    wp::int32 var_2359;
    wp::float64 var_2360;
    const wp::int32 var_2361 = 0;
    wp::float64 var_2362;
    wp::float64 var_2363;
    const wp::int32 var_2364 = 1;
    wp::float64 var_2365;
    wp::float64 var_2366;
    wp::float64 var_2367;
    const wp::int32 var_2368 = 4;
    wp::int32 var_2369;
    wp::int32 var_2370;
    const wp::int32 var_2371 = 1;
    wp::float64 var_2372;
    wp::float64 var_2373;
    const wp::int32 var_2374 = 0;
    wp::float64 var_2375;
    wp::float64 var_2376;
    wp::float64 var_2377;
    const wp::int32 var_2378 = 4;
    wp::int32 var_2379;
    wp::int32 var_2380;
    const wp::int32 var_2381 = 2;
    const wp::int32 var_2382 = 4;
    wp::int32 var_2383;
    wp::int32 var_2384;
    wp::float64 var_2385;
    const wp::int32 var_2386 = 4;
    wp::int32 var_2387;
    wp::int32 var_2388;
    wp::float64 var_2389;
    const wp::int32 var_2390 = 0;
    wp::float64 var_2391;
    wp::float64 var_2392;
    const wp::int32 var_2393 = 1;
    wp::float64 var_2394;
    wp::float64 var_2395;
    wp::float64 var_2396;
    const wp::int32 var_2397 = 4;
    wp::int32 var_2398;
    wp::int32 var_2399;
    const wp::int32 var_2400 = 1;
    wp::float64 var_2401;
    wp::float64 var_2402;
    const wp::int32 var_2403 = 0;
    wp::float64 var_2404;
    wp::float64 var_2405;
    wp::float64 var_2406;
    const wp::int32 var_2407 = 4;
    wp::int32 var_2408;
    wp::int32 var_2409;
    const wp::int32 var_2410 = 3;
    const wp::int32 var_2411 = 4;
    wp::int32 var_2412;
    wp::int32 var_2413;
    wp::float64 var_2414;
    const wp::int32 var_2415 = 4;
    wp::int32 var_2416;
    wp::int32 var_2417;
    wp::float64 var_2418;
    const wp::int32 var_2419 = 0;
    wp::float64 var_2420;
    wp::float64 var_2421;
    const wp::int32 var_2422 = 1;
    wp::float64 var_2423;
    wp::float64 var_2424;
    wp::float64 var_2425;
    const wp::int32 var_2426 = 4;
    wp::int32 var_2427;
    wp::int32 var_2428;
    const wp::int32 var_2429 = 1;
    wp::float64 var_2430;
    wp::float64 var_2431;
    const wp::int32 var_2432 = 0;
    wp::float64 var_2433;
    wp::float64 var_2434;
    wp::float64 var_2435;
    const wp::int32 var_2436 = 4;
    wp::int32 var_2437;
    wp::int32 var_2438;
    wp::int32 var_2439;
    wp::vec_t<2, wp::float64> var_2440;
    wp::int32 var_2441;
    wp::float64 var_2442;
    wp::float64 var_2443;
    wp::float64 var_2444;
    wp::float64 var_2445;
    wp::float64 var_2446;
    wp::float64 var_2447;
    wp::float64 var_2448;
    wp::vec_t<20, wp::float64> var_2449;
    const wp::int32 var_2450 = 0;
    wp::float64 var_2451;
    const wp::int32 var_2452 = 1;
    wp::float64 var_2453;
    const wp::int32 var_2454 = 2;
    wp::float64 var_2455;
    const wp::int32 var_2456 = 3;
    wp::float64 var_2457;
    const wp::int32 var_2458 = 4;
    wp::float64 var_2459;
    const wp::int32 var_2460 = 5;
    wp::float64 var_2461;
    const wp::int32 var_2462 = 6;
    wp::float64 var_2463;
    const wp::int32 var_2464 = 7;
    wp::float64 var_2465;
    const wp::int32 var_2466 = 8;
    wp::float64 var_2467;
    const wp::int32 var_2468 = 9;
    wp::float64 var_2469;
    const wp::int32 var_2470 = 10;
    wp::float64 var_2471;
    const wp::int32 var_2472 = 11;
    wp::float64 var_2473;
    const wp::int32 var_2474 = 12;
    wp::float64 var_2475;
    const wp::int32 var_2476 = 13;
    wp::float64 var_2477;
    const wp::int32 var_2478 = 14;
    wp::float64 var_2479;
    const wp::int32 var_2480 = 15;
    wp::float64 var_2481;
    const wp::int32 var_2482 = 0;
    const wp::int32 var_2483 = 5;
    wp::int32 var_2484;
    wp::float64 var_2485;
    const wp::int32 var_2486 = 16;
    wp::int32 var_2487;
    const wp::int32 var_2488 = 1;
    const wp::int32 var_2489 = 5;
    wp::int32 var_2490;
    wp::float64 var_2491;
    const wp::int32 var_2492 = 16;
    wp::int32 var_2493;
    const wp::int32 var_2494 = 2;
    const wp::int32 var_2495 = 5;
    wp::int32 var_2496;
    wp::float64 var_2497;
    const wp::int32 var_2498 = 16;
    wp::int32 var_2499;
    const wp::int32 var_2500 = 3;
    const wp::int32 var_2501 = 5;
    wp::int32 var_2502;
    wp::float64 var_2503;
    const wp::int32 var_2504 = 16;
    wp::int32 var_2505;
    //---------
    // forward
    // def diagonalize_four(matrix):                                                          <L 1>
    // a = matrix                                                                             <L 3>
    var_0 = wp::copy(var_matrix);
    // v = four_square(float64(0.0))                                                          <L 4>
    var_1 = 0.0;
    var_2 = wp::vec_t<16, wp::float64>(var_1);
    // for i in range(4):                                                                     <L 5>
    // v[i * 5] = float64(1.0)                                                                <L 6>
    var_4 = 1.0;
    var_6 = wp::mul(var_3, var_5);
    wp::assign_inplace(var_2, var_6, var_4);
    var_8 = 1.0;
    var_10 = wp::mul(var_7, var_9);
    wp::assign_inplace(var_2, var_10, var_8);
    var_12 = 1.0;
    var_14 = wp::mul(var_11, var_13);
    wp::assign_inplace(var_2, var_14, var_12);
    var_16 = 1.0;
    var_18 = wp::mul(var_15, var_17);
    wp::assign_inplace(var_2, var_18, var_16);
    // rotated = int(1)                                                                       <L 7>
    var_20 = wp::int(var_19);
    // sweep = int(0)                                                                         <L 8>
    var_22 = wp::int(var_21);
    // while rotated == 1 and sweep < SWEEPS:                                                 <L 9>
    start_while_0:;
    var_25 = (var_20 == var_24);
    var_23 = var_25;
    if (var_23) {
        var_27 = (var_22 < var_26);
        var_23 = var_23 && var_27;
    }
    if ((var_23) == false) goto end_while_0;
        // rotated = int(0)                                                                   <L 10>
        var_29 = wp::int(var_28);
        // sweep += 1                                                                         <L 11>
        var_31 = wp::add(var_22, var_30);
        // for pair in range(6):                                                              <L 12>
        // p = 0 if pair < 3 else 1 if pair < 5 else 2                                        <L 13>
        var_34 = (var_32 < var_33);
        if (var_34) {
        }
        if (!var_34) {
            var_37 = (var_32 < var_36);
            if (var_37) {
            }
            if (!var_37) {
            }
            var_40 = wp::where(var_37, var_38, var_39);
        }
        var_41 = wp::where(var_34, var_35, var_40);
        // q = pair + 1 - (0 if pair < 3 else 2 if pair < 5 else 3)                           <L 14>
        var_43 = wp::add(var_32, var_42);
        var_45 = (var_32 < var_44);
        if (var_45) {
        }
        if (!var_45) {
            var_48 = (var_32 < var_47);
            if (var_48) {
            }
            if (!var_48) {
            }
            var_51 = wp::where(var_48, var_49, var_50);
        }
        var_52 = wp::where(var_45, var_46, var_51);
        var_53 = wp::sub(var_43, var_52);
        // apq = a[p * 4 + q]                                                                 <L 15>
        var_55 = wp::mul(var_41, var_54);
        var_56 = wp::add(var_55, var_53);
        var_57 = wp::extract(var_0, var_56);
        // app = a[p * 4 + p]                                                                 <L 16>
        var_59 = wp::mul(var_41, var_58);
        var_60 = wp::add(var_59, var_41);
        var_61 = wp::extract(var_0, var_60);
        // aqq = a[q * 4 + q]                                                                 <L 17>
        var_63 = wp::mul(var_53, var_62);
        var_64 = wp::add(var_63, var_53);
        var_65 = wp::extract(var_0, var_64);
        // if abs(apq) > float64(1e-300) and abs(apq) > float64(1e-18) * sqrt(abs(app * aqq)):       <L 18>
        var_67 = wp::abs(var_57);
        var_68 = 1e-300;
        var_69 = (var_67 > var_68);
        var_66 = var_69;
        if (var_66) {
            var_70 = wp::abs(var_57);
            var_71 = 1e-18;
            var_72 = wp::mul(var_61, var_65);
            var_73 = wp::abs(var_72);
            var_74 = wp::sqrt(var_73);
            var_75 = wp::mul(var_71, var_74);
            var_76 = (var_70 > var_75);
            var_66 = var_66 && var_76;
        }
        if (var_66) {
            // rotated = 1                                                                    <L 19>
            // cs = jacobi_rotation(app, aqq, apq)                                            <L 20>
            var_78 = jacobi_rotation_0(var_61, var_65, var_57);
            // for k in range(4):                                                             <L 21>
            // akp = a[k * 4 + p]                                                             <L 22>
            var_81 = wp::mul(var_79, var_80);
            var_82 = wp::add(var_81, var_41);
            var_83 = wp::extract(var_0, var_82);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_85 = wp::mul(var_79, var_84);
            var_86 = wp::add(var_85, var_53);
            var_87 = wp::extract(var_0, var_86);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_89 = wp::extract(var_78, var_88);
            var_90 = wp::mul(var_89, var_83);
            var_92 = wp::extract(var_78, var_91);
            var_93 = wp::mul(var_92, var_87);
            var_94 = wp::sub(var_90, var_93);
            var_96 = wp::mul(var_79, var_95);
            var_97 = wp::add(var_96, var_41);
            wp::assign_inplace(var_0, var_97, var_94);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_99 = wp::extract(var_78, var_98);
            var_100 = wp::mul(var_99, var_83);
            var_102 = wp::extract(var_78, var_101);
            var_103 = wp::mul(var_102, var_87);
            var_104 = wp::add(var_100, var_103);
            var_106 = wp::mul(var_79, var_105);
            var_107 = wp::add(var_106, var_53);
            wp::assign_inplace(var_0, var_107, var_104);
            // akp = a[k * 4 + p]                                                             <L 22>
            var_110 = wp::mul(var_108, var_109);
            var_111 = wp::add(var_110, var_41);
            var_112 = wp::extract(var_0, var_111);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_114 = wp::mul(var_108, var_113);
            var_115 = wp::add(var_114, var_53);
            var_116 = wp::extract(var_0, var_115);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_118 = wp::extract(var_78, var_117);
            var_119 = wp::mul(var_118, var_112);
            var_121 = wp::extract(var_78, var_120);
            var_122 = wp::mul(var_121, var_116);
            var_123 = wp::sub(var_119, var_122);
            var_125 = wp::mul(var_108, var_124);
            var_126 = wp::add(var_125, var_41);
            wp::assign_inplace(var_0, var_126, var_123);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_128 = wp::extract(var_78, var_127);
            var_129 = wp::mul(var_128, var_112);
            var_131 = wp::extract(var_78, var_130);
            var_132 = wp::mul(var_131, var_116);
            var_133 = wp::add(var_129, var_132);
            var_135 = wp::mul(var_108, var_134);
            var_136 = wp::add(var_135, var_53);
            wp::assign_inplace(var_0, var_136, var_133);
            // akp = a[k * 4 + p]                                                             <L 22>
            var_139 = wp::mul(var_137, var_138);
            var_140 = wp::add(var_139, var_41);
            var_141 = wp::extract(var_0, var_140);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_143 = wp::mul(var_137, var_142);
            var_144 = wp::add(var_143, var_53);
            var_145 = wp::extract(var_0, var_144);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_147 = wp::extract(var_78, var_146);
            var_148 = wp::mul(var_147, var_141);
            var_150 = wp::extract(var_78, var_149);
            var_151 = wp::mul(var_150, var_145);
            var_152 = wp::sub(var_148, var_151);
            var_154 = wp::mul(var_137, var_153);
            var_155 = wp::add(var_154, var_41);
            wp::assign_inplace(var_0, var_155, var_152);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_157 = wp::extract(var_78, var_156);
            var_158 = wp::mul(var_157, var_141);
            var_160 = wp::extract(var_78, var_159);
            var_161 = wp::mul(var_160, var_145);
            var_162 = wp::add(var_158, var_161);
            var_164 = wp::mul(var_137, var_163);
            var_165 = wp::add(var_164, var_53);
            wp::assign_inplace(var_0, var_165, var_162);
            // akp = a[k * 4 + p]                                                             <L 22>
            var_168 = wp::mul(var_166, var_167);
            var_169 = wp::add(var_168, var_41);
            var_170 = wp::extract(var_0, var_169);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_172 = wp::mul(var_166, var_171);
            var_173 = wp::add(var_172, var_53);
            var_174 = wp::extract(var_0, var_173);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_176 = wp::extract(var_78, var_175);
            var_177 = wp::mul(var_176, var_170);
            var_179 = wp::extract(var_78, var_178);
            var_180 = wp::mul(var_179, var_174);
            var_181 = wp::sub(var_177, var_180);
            var_183 = wp::mul(var_166, var_182);
            var_184 = wp::add(var_183, var_41);
            wp::assign_inplace(var_0, var_184, var_181);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_186 = wp::extract(var_78, var_185);
            var_187 = wp::mul(var_186, var_170);
            var_189 = wp::extract(var_78, var_188);
            var_190 = wp::mul(var_189, var_174);
            var_191 = wp::add(var_187, var_190);
            var_193 = wp::mul(var_166, var_192);
            var_194 = wp::add(var_193, var_53);
            wp::assign_inplace(var_0, var_194, var_191);
            // for k in range(4):                                                             <L 26>
            // apk = a[p * 4 + k]                                                             <L 27>
            var_197 = wp::mul(var_41, var_196);
            var_198 = wp::add(var_197, var_195);
            var_199 = wp::extract(var_0, var_198);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_201 = wp::mul(var_53, var_200);
            var_202 = wp::add(var_201, var_195);
            var_203 = wp::extract(var_0, var_202);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_205 = wp::extract(var_78, var_204);
            var_206 = wp::mul(var_205, var_199);
            var_208 = wp::extract(var_78, var_207);
            var_209 = wp::mul(var_208, var_203);
            var_210 = wp::sub(var_206, var_209);
            var_212 = wp::mul(var_41, var_211);
            var_213 = wp::add(var_212, var_195);
            wp::assign_inplace(var_0, var_213, var_210);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_215 = wp::extract(var_78, var_214);
            var_216 = wp::mul(var_215, var_199);
            var_218 = wp::extract(var_78, var_217);
            var_219 = wp::mul(var_218, var_203);
            var_220 = wp::add(var_216, var_219);
            var_222 = wp::mul(var_53, var_221);
            var_223 = wp::add(var_222, var_195);
            wp::assign_inplace(var_0, var_223, var_220);
            // apk = a[p * 4 + k]                                                             <L 27>
            var_226 = wp::mul(var_41, var_225);
            var_227 = wp::add(var_226, var_224);
            var_228 = wp::extract(var_0, var_227);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_230 = wp::mul(var_53, var_229);
            var_231 = wp::add(var_230, var_224);
            var_232 = wp::extract(var_0, var_231);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_234 = wp::extract(var_78, var_233);
            var_235 = wp::mul(var_234, var_228);
            var_237 = wp::extract(var_78, var_236);
            var_238 = wp::mul(var_237, var_232);
            var_239 = wp::sub(var_235, var_238);
            var_241 = wp::mul(var_41, var_240);
            var_242 = wp::add(var_241, var_224);
            wp::assign_inplace(var_0, var_242, var_239);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_244 = wp::extract(var_78, var_243);
            var_245 = wp::mul(var_244, var_228);
            var_247 = wp::extract(var_78, var_246);
            var_248 = wp::mul(var_247, var_232);
            var_249 = wp::add(var_245, var_248);
            var_251 = wp::mul(var_53, var_250);
            var_252 = wp::add(var_251, var_224);
            wp::assign_inplace(var_0, var_252, var_249);
            // apk = a[p * 4 + k]                                                             <L 27>
            var_255 = wp::mul(var_41, var_254);
            var_256 = wp::add(var_255, var_253);
            var_257 = wp::extract(var_0, var_256);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_259 = wp::mul(var_53, var_258);
            var_260 = wp::add(var_259, var_253);
            var_261 = wp::extract(var_0, var_260);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_263 = wp::extract(var_78, var_262);
            var_264 = wp::mul(var_263, var_257);
            var_266 = wp::extract(var_78, var_265);
            var_267 = wp::mul(var_266, var_261);
            var_268 = wp::sub(var_264, var_267);
            var_270 = wp::mul(var_41, var_269);
            var_271 = wp::add(var_270, var_253);
            wp::assign_inplace(var_0, var_271, var_268);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_273 = wp::extract(var_78, var_272);
            var_274 = wp::mul(var_273, var_257);
            var_276 = wp::extract(var_78, var_275);
            var_277 = wp::mul(var_276, var_261);
            var_278 = wp::add(var_274, var_277);
            var_280 = wp::mul(var_53, var_279);
            var_281 = wp::add(var_280, var_253);
            wp::assign_inplace(var_0, var_281, var_278);
            // apk = a[p * 4 + k]                                                             <L 27>
            var_284 = wp::mul(var_41, var_283);
            var_285 = wp::add(var_284, var_282);
            var_286 = wp::extract(var_0, var_285);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_288 = wp::mul(var_53, var_287);
            var_289 = wp::add(var_288, var_282);
            var_290 = wp::extract(var_0, var_289);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_292 = wp::extract(var_78, var_291);
            var_293 = wp::mul(var_292, var_286);
            var_295 = wp::extract(var_78, var_294);
            var_296 = wp::mul(var_295, var_290);
            var_297 = wp::sub(var_293, var_296);
            var_299 = wp::mul(var_41, var_298);
            var_300 = wp::add(var_299, var_282);
            wp::assign_inplace(var_0, var_300, var_297);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_302 = wp::extract(var_78, var_301);
            var_303 = wp::mul(var_302, var_286);
            var_305 = wp::extract(var_78, var_304);
            var_306 = wp::mul(var_305, var_290);
            var_307 = wp::add(var_303, var_306);
            var_309 = wp::mul(var_53, var_308);
            var_310 = wp::add(var_309, var_282);
            wp::assign_inplace(var_0, var_310, var_307);
            // for k in range(4):                                                             <L 31>
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_313 = wp::mul(var_311, var_312);
            var_314 = wp::add(var_313, var_41);
            var_315 = wp::extract(var_2, var_314);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_317 = wp::mul(var_311, var_316);
            var_318 = wp::add(var_317, var_53);
            var_319 = wp::extract(var_2, var_318);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_321 = wp::extract(var_78, var_320);
            var_322 = wp::mul(var_321, var_315);
            var_324 = wp::extract(var_78, var_323);
            var_325 = wp::mul(var_324, var_319);
            var_326 = wp::sub(var_322, var_325);
            var_328 = wp::mul(var_311, var_327);
            var_329 = wp::add(var_328, var_41);
            wp::assign_inplace(var_2, var_329, var_326);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_331 = wp::extract(var_78, var_330);
            var_332 = wp::mul(var_331, var_315);
            var_334 = wp::extract(var_78, var_333);
            var_335 = wp::mul(var_334, var_319);
            var_336 = wp::add(var_332, var_335);
            var_338 = wp::mul(var_311, var_337);
            var_339 = wp::add(var_338, var_53);
            wp::assign_inplace(var_2, var_339, var_336);
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_342 = wp::mul(var_340, var_341);
            var_343 = wp::add(var_342, var_41);
            var_344 = wp::extract(var_2, var_343);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_346 = wp::mul(var_340, var_345);
            var_347 = wp::add(var_346, var_53);
            var_348 = wp::extract(var_2, var_347);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_350 = wp::extract(var_78, var_349);
            var_351 = wp::mul(var_350, var_344);
            var_353 = wp::extract(var_78, var_352);
            var_354 = wp::mul(var_353, var_348);
            var_355 = wp::sub(var_351, var_354);
            var_357 = wp::mul(var_340, var_356);
            var_358 = wp::add(var_357, var_41);
            wp::assign_inplace(var_2, var_358, var_355);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_360 = wp::extract(var_78, var_359);
            var_361 = wp::mul(var_360, var_344);
            var_363 = wp::extract(var_78, var_362);
            var_364 = wp::mul(var_363, var_348);
            var_365 = wp::add(var_361, var_364);
            var_367 = wp::mul(var_340, var_366);
            var_368 = wp::add(var_367, var_53);
            wp::assign_inplace(var_2, var_368, var_365);
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_371 = wp::mul(var_369, var_370);
            var_372 = wp::add(var_371, var_41);
            var_373 = wp::extract(var_2, var_372);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_375 = wp::mul(var_369, var_374);
            var_376 = wp::add(var_375, var_53);
            var_377 = wp::extract(var_2, var_376);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_379 = wp::extract(var_78, var_378);
            var_380 = wp::mul(var_379, var_373);
            var_382 = wp::extract(var_78, var_381);
            var_383 = wp::mul(var_382, var_377);
            var_384 = wp::sub(var_380, var_383);
            var_386 = wp::mul(var_369, var_385);
            var_387 = wp::add(var_386, var_41);
            wp::assign_inplace(var_2, var_387, var_384);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_389 = wp::extract(var_78, var_388);
            var_390 = wp::mul(var_389, var_373);
            var_392 = wp::extract(var_78, var_391);
            var_393 = wp::mul(var_392, var_377);
            var_394 = wp::add(var_390, var_393);
            var_396 = wp::mul(var_369, var_395);
            var_397 = wp::add(var_396, var_53);
            wp::assign_inplace(var_2, var_397, var_394);
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_400 = wp::mul(var_398, var_399);
            var_401 = wp::add(var_400, var_41);
            var_402 = wp::extract(var_2, var_401);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_404 = wp::mul(var_398, var_403);
            var_405 = wp::add(var_404, var_53);
            var_406 = wp::extract(var_2, var_405);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_408 = wp::extract(var_78, var_407);
            var_409 = wp::mul(var_408, var_402);
            var_411 = wp::extract(var_78, var_410);
            var_412 = wp::mul(var_411, var_406);
            var_413 = wp::sub(var_409, var_412);
            var_415 = wp::mul(var_398, var_414);
            var_416 = wp::add(var_415, var_41);
            wp::assign_inplace(var_2, var_416, var_413);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_418 = wp::extract(var_78, var_417);
            var_419 = wp::mul(var_418, var_402);
            var_421 = wp::extract(var_78, var_420);
            var_422 = wp::mul(var_421, var_406);
            var_423 = wp::add(var_419, var_422);
            var_425 = wp::mul(var_398, var_424);
            var_426 = wp::add(var_425, var_53);
            wp::assign_inplace(var_2, var_426, var_423);
        }
        var_427 = wp::where(var_66, var_77, var_29);
        // p = 0 if pair < 3 else 1 if pair < 5 else 2                                        <L 13>
        var_430 = (var_428 < var_429);
        if (var_430) {
        }
        if (!var_430) {
            var_433 = (var_428 < var_432);
            if (var_433) {
            }
            if (!var_433) {
            }
            var_436 = wp::where(var_433, var_434, var_435);
        }
        var_437 = wp::where(var_430, var_431, var_436);
        // q = pair + 1 - (0 if pair < 3 else 2 if pair < 5 else 3)                           <L 14>
        var_439 = wp::add(var_428, var_438);
        var_441 = (var_428 < var_440);
        if (var_441) {
        }
        if (!var_441) {
            var_444 = (var_428 < var_443);
            if (var_444) {
            }
            if (!var_444) {
            }
            var_447 = wp::where(var_444, var_445, var_446);
        }
        var_448 = wp::where(var_441, var_442, var_447);
        var_449 = wp::sub(var_439, var_448);
        // apq = a[p * 4 + q]                                                                 <L 15>
        var_451 = wp::mul(var_437, var_450);
        var_452 = wp::add(var_451, var_449);
        var_453 = wp::extract(var_0, var_452);
        // app = a[p * 4 + p]                                                                 <L 16>
        var_455 = wp::mul(var_437, var_454);
        var_456 = wp::add(var_455, var_437);
        var_457 = wp::extract(var_0, var_456);
        // aqq = a[q * 4 + q]                                                                 <L 17>
        var_459 = wp::mul(var_449, var_458);
        var_460 = wp::add(var_459, var_449);
        var_461 = wp::extract(var_0, var_460);
        // if abs(apq) > float64(1e-300) and abs(apq) > float64(1e-18) * sqrt(abs(app * aqq)):       <L 18>
        var_463 = wp::abs(var_453);
        var_464 = 1e-300;
        var_465 = (var_463 > var_464);
        var_462 = var_465;
        if (var_462) {
            var_466 = wp::abs(var_453);
            var_467 = 1e-18;
            var_468 = wp::mul(var_457, var_461);
            var_469 = wp::abs(var_468);
            var_470 = wp::sqrt(var_469);
            var_471 = wp::mul(var_467, var_470);
            var_472 = (var_466 > var_471);
            var_462 = var_462 && var_472;
        }
        if (var_462) {
            // rotated = 1                                                                    <L 19>
            // cs = jacobi_rotation(app, aqq, apq)                                            <L 20>
            var_474 = jacobi_rotation_0(var_457, var_461, var_453);
            // for k in range(4):                                                             <L 21>
            // akp = a[k * 4 + p]                                                             <L 22>
            var_477 = wp::mul(var_475, var_476);
            var_478 = wp::add(var_477, var_437);
            var_479 = wp::extract(var_0, var_478);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_481 = wp::mul(var_475, var_480);
            var_482 = wp::add(var_481, var_449);
            var_483 = wp::extract(var_0, var_482);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_485 = wp::extract(var_474, var_484);
            var_486 = wp::mul(var_485, var_479);
            var_488 = wp::extract(var_474, var_487);
            var_489 = wp::mul(var_488, var_483);
            var_490 = wp::sub(var_486, var_489);
            var_492 = wp::mul(var_475, var_491);
            var_493 = wp::add(var_492, var_437);
            wp::assign_inplace(var_0, var_493, var_490);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_495 = wp::extract(var_474, var_494);
            var_496 = wp::mul(var_495, var_479);
            var_498 = wp::extract(var_474, var_497);
            var_499 = wp::mul(var_498, var_483);
            var_500 = wp::add(var_496, var_499);
            var_502 = wp::mul(var_475, var_501);
            var_503 = wp::add(var_502, var_449);
            wp::assign_inplace(var_0, var_503, var_500);
            // akp = a[k * 4 + p]                                                             <L 22>
            var_506 = wp::mul(var_504, var_505);
            var_507 = wp::add(var_506, var_437);
            var_508 = wp::extract(var_0, var_507);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_510 = wp::mul(var_504, var_509);
            var_511 = wp::add(var_510, var_449);
            var_512 = wp::extract(var_0, var_511);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_514 = wp::extract(var_474, var_513);
            var_515 = wp::mul(var_514, var_508);
            var_517 = wp::extract(var_474, var_516);
            var_518 = wp::mul(var_517, var_512);
            var_519 = wp::sub(var_515, var_518);
            var_521 = wp::mul(var_504, var_520);
            var_522 = wp::add(var_521, var_437);
            wp::assign_inplace(var_0, var_522, var_519);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_524 = wp::extract(var_474, var_523);
            var_525 = wp::mul(var_524, var_508);
            var_527 = wp::extract(var_474, var_526);
            var_528 = wp::mul(var_527, var_512);
            var_529 = wp::add(var_525, var_528);
            var_531 = wp::mul(var_504, var_530);
            var_532 = wp::add(var_531, var_449);
            wp::assign_inplace(var_0, var_532, var_529);
            // akp = a[k * 4 + p]                                                             <L 22>
            var_535 = wp::mul(var_533, var_534);
            var_536 = wp::add(var_535, var_437);
            var_537 = wp::extract(var_0, var_536);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_539 = wp::mul(var_533, var_538);
            var_540 = wp::add(var_539, var_449);
            var_541 = wp::extract(var_0, var_540);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_543 = wp::extract(var_474, var_542);
            var_544 = wp::mul(var_543, var_537);
            var_546 = wp::extract(var_474, var_545);
            var_547 = wp::mul(var_546, var_541);
            var_548 = wp::sub(var_544, var_547);
            var_550 = wp::mul(var_533, var_549);
            var_551 = wp::add(var_550, var_437);
            wp::assign_inplace(var_0, var_551, var_548);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_553 = wp::extract(var_474, var_552);
            var_554 = wp::mul(var_553, var_537);
            var_556 = wp::extract(var_474, var_555);
            var_557 = wp::mul(var_556, var_541);
            var_558 = wp::add(var_554, var_557);
            var_560 = wp::mul(var_533, var_559);
            var_561 = wp::add(var_560, var_449);
            wp::assign_inplace(var_0, var_561, var_558);
            // akp = a[k * 4 + p]                                                             <L 22>
            var_564 = wp::mul(var_562, var_563);
            var_565 = wp::add(var_564, var_437);
            var_566 = wp::extract(var_0, var_565);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_568 = wp::mul(var_562, var_567);
            var_569 = wp::add(var_568, var_449);
            var_570 = wp::extract(var_0, var_569);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_572 = wp::extract(var_474, var_571);
            var_573 = wp::mul(var_572, var_566);
            var_575 = wp::extract(var_474, var_574);
            var_576 = wp::mul(var_575, var_570);
            var_577 = wp::sub(var_573, var_576);
            var_579 = wp::mul(var_562, var_578);
            var_580 = wp::add(var_579, var_437);
            wp::assign_inplace(var_0, var_580, var_577);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_582 = wp::extract(var_474, var_581);
            var_583 = wp::mul(var_582, var_566);
            var_585 = wp::extract(var_474, var_584);
            var_586 = wp::mul(var_585, var_570);
            var_587 = wp::add(var_583, var_586);
            var_589 = wp::mul(var_562, var_588);
            var_590 = wp::add(var_589, var_449);
            wp::assign_inplace(var_0, var_590, var_587);
            // for k in range(4):                                                             <L 26>
            // apk = a[p * 4 + k]                                                             <L 27>
            var_593 = wp::mul(var_437, var_592);
            var_594 = wp::add(var_593, var_591);
            var_595 = wp::extract(var_0, var_594);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_597 = wp::mul(var_449, var_596);
            var_598 = wp::add(var_597, var_591);
            var_599 = wp::extract(var_0, var_598);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_601 = wp::extract(var_474, var_600);
            var_602 = wp::mul(var_601, var_595);
            var_604 = wp::extract(var_474, var_603);
            var_605 = wp::mul(var_604, var_599);
            var_606 = wp::sub(var_602, var_605);
            var_608 = wp::mul(var_437, var_607);
            var_609 = wp::add(var_608, var_591);
            wp::assign_inplace(var_0, var_609, var_606);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_611 = wp::extract(var_474, var_610);
            var_612 = wp::mul(var_611, var_595);
            var_614 = wp::extract(var_474, var_613);
            var_615 = wp::mul(var_614, var_599);
            var_616 = wp::add(var_612, var_615);
            var_618 = wp::mul(var_449, var_617);
            var_619 = wp::add(var_618, var_591);
            wp::assign_inplace(var_0, var_619, var_616);
            // apk = a[p * 4 + k]                                                             <L 27>
            var_622 = wp::mul(var_437, var_621);
            var_623 = wp::add(var_622, var_620);
            var_624 = wp::extract(var_0, var_623);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_626 = wp::mul(var_449, var_625);
            var_627 = wp::add(var_626, var_620);
            var_628 = wp::extract(var_0, var_627);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_630 = wp::extract(var_474, var_629);
            var_631 = wp::mul(var_630, var_624);
            var_633 = wp::extract(var_474, var_632);
            var_634 = wp::mul(var_633, var_628);
            var_635 = wp::sub(var_631, var_634);
            var_637 = wp::mul(var_437, var_636);
            var_638 = wp::add(var_637, var_620);
            wp::assign_inplace(var_0, var_638, var_635);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_640 = wp::extract(var_474, var_639);
            var_641 = wp::mul(var_640, var_624);
            var_643 = wp::extract(var_474, var_642);
            var_644 = wp::mul(var_643, var_628);
            var_645 = wp::add(var_641, var_644);
            var_647 = wp::mul(var_449, var_646);
            var_648 = wp::add(var_647, var_620);
            wp::assign_inplace(var_0, var_648, var_645);
            // apk = a[p * 4 + k]                                                             <L 27>
            var_651 = wp::mul(var_437, var_650);
            var_652 = wp::add(var_651, var_649);
            var_653 = wp::extract(var_0, var_652);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_655 = wp::mul(var_449, var_654);
            var_656 = wp::add(var_655, var_649);
            var_657 = wp::extract(var_0, var_656);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_659 = wp::extract(var_474, var_658);
            var_660 = wp::mul(var_659, var_653);
            var_662 = wp::extract(var_474, var_661);
            var_663 = wp::mul(var_662, var_657);
            var_664 = wp::sub(var_660, var_663);
            var_666 = wp::mul(var_437, var_665);
            var_667 = wp::add(var_666, var_649);
            wp::assign_inplace(var_0, var_667, var_664);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_669 = wp::extract(var_474, var_668);
            var_670 = wp::mul(var_669, var_653);
            var_672 = wp::extract(var_474, var_671);
            var_673 = wp::mul(var_672, var_657);
            var_674 = wp::add(var_670, var_673);
            var_676 = wp::mul(var_449, var_675);
            var_677 = wp::add(var_676, var_649);
            wp::assign_inplace(var_0, var_677, var_674);
            // apk = a[p * 4 + k]                                                             <L 27>
            var_680 = wp::mul(var_437, var_679);
            var_681 = wp::add(var_680, var_678);
            var_682 = wp::extract(var_0, var_681);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_684 = wp::mul(var_449, var_683);
            var_685 = wp::add(var_684, var_678);
            var_686 = wp::extract(var_0, var_685);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_688 = wp::extract(var_474, var_687);
            var_689 = wp::mul(var_688, var_682);
            var_691 = wp::extract(var_474, var_690);
            var_692 = wp::mul(var_691, var_686);
            var_693 = wp::sub(var_689, var_692);
            var_695 = wp::mul(var_437, var_694);
            var_696 = wp::add(var_695, var_678);
            wp::assign_inplace(var_0, var_696, var_693);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_698 = wp::extract(var_474, var_697);
            var_699 = wp::mul(var_698, var_682);
            var_701 = wp::extract(var_474, var_700);
            var_702 = wp::mul(var_701, var_686);
            var_703 = wp::add(var_699, var_702);
            var_705 = wp::mul(var_449, var_704);
            var_706 = wp::add(var_705, var_678);
            wp::assign_inplace(var_0, var_706, var_703);
            // for k in range(4):                                                             <L 31>
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_709 = wp::mul(var_707, var_708);
            var_710 = wp::add(var_709, var_437);
            var_711 = wp::extract(var_2, var_710);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_713 = wp::mul(var_707, var_712);
            var_714 = wp::add(var_713, var_449);
            var_715 = wp::extract(var_2, var_714);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_717 = wp::extract(var_474, var_716);
            var_718 = wp::mul(var_717, var_711);
            var_720 = wp::extract(var_474, var_719);
            var_721 = wp::mul(var_720, var_715);
            var_722 = wp::sub(var_718, var_721);
            var_724 = wp::mul(var_707, var_723);
            var_725 = wp::add(var_724, var_437);
            wp::assign_inplace(var_2, var_725, var_722);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_727 = wp::extract(var_474, var_726);
            var_728 = wp::mul(var_727, var_711);
            var_730 = wp::extract(var_474, var_729);
            var_731 = wp::mul(var_730, var_715);
            var_732 = wp::add(var_728, var_731);
            var_734 = wp::mul(var_707, var_733);
            var_735 = wp::add(var_734, var_449);
            wp::assign_inplace(var_2, var_735, var_732);
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_738 = wp::mul(var_736, var_737);
            var_739 = wp::add(var_738, var_437);
            var_740 = wp::extract(var_2, var_739);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_742 = wp::mul(var_736, var_741);
            var_743 = wp::add(var_742, var_449);
            var_744 = wp::extract(var_2, var_743);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_746 = wp::extract(var_474, var_745);
            var_747 = wp::mul(var_746, var_740);
            var_749 = wp::extract(var_474, var_748);
            var_750 = wp::mul(var_749, var_744);
            var_751 = wp::sub(var_747, var_750);
            var_753 = wp::mul(var_736, var_752);
            var_754 = wp::add(var_753, var_437);
            wp::assign_inplace(var_2, var_754, var_751);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_756 = wp::extract(var_474, var_755);
            var_757 = wp::mul(var_756, var_740);
            var_759 = wp::extract(var_474, var_758);
            var_760 = wp::mul(var_759, var_744);
            var_761 = wp::add(var_757, var_760);
            var_763 = wp::mul(var_736, var_762);
            var_764 = wp::add(var_763, var_449);
            wp::assign_inplace(var_2, var_764, var_761);
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_767 = wp::mul(var_765, var_766);
            var_768 = wp::add(var_767, var_437);
            var_769 = wp::extract(var_2, var_768);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_771 = wp::mul(var_765, var_770);
            var_772 = wp::add(var_771, var_449);
            var_773 = wp::extract(var_2, var_772);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_775 = wp::extract(var_474, var_774);
            var_776 = wp::mul(var_775, var_769);
            var_778 = wp::extract(var_474, var_777);
            var_779 = wp::mul(var_778, var_773);
            var_780 = wp::sub(var_776, var_779);
            var_782 = wp::mul(var_765, var_781);
            var_783 = wp::add(var_782, var_437);
            wp::assign_inplace(var_2, var_783, var_780);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_785 = wp::extract(var_474, var_784);
            var_786 = wp::mul(var_785, var_769);
            var_788 = wp::extract(var_474, var_787);
            var_789 = wp::mul(var_788, var_773);
            var_790 = wp::add(var_786, var_789);
            var_792 = wp::mul(var_765, var_791);
            var_793 = wp::add(var_792, var_449);
            wp::assign_inplace(var_2, var_793, var_790);
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_796 = wp::mul(var_794, var_795);
            var_797 = wp::add(var_796, var_437);
            var_798 = wp::extract(var_2, var_797);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_800 = wp::mul(var_794, var_799);
            var_801 = wp::add(var_800, var_449);
            var_802 = wp::extract(var_2, var_801);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_804 = wp::extract(var_474, var_803);
            var_805 = wp::mul(var_804, var_798);
            var_807 = wp::extract(var_474, var_806);
            var_808 = wp::mul(var_807, var_802);
            var_809 = wp::sub(var_805, var_808);
            var_811 = wp::mul(var_794, var_810);
            var_812 = wp::add(var_811, var_437);
            wp::assign_inplace(var_2, var_812, var_809);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_814 = wp::extract(var_474, var_813);
            var_815 = wp::mul(var_814, var_798);
            var_817 = wp::extract(var_474, var_816);
            var_818 = wp::mul(var_817, var_802);
            var_819 = wp::add(var_815, var_818);
            var_821 = wp::mul(var_794, var_820);
            var_822 = wp::add(var_821, var_449);
            wp::assign_inplace(var_2, var_822, var_819);
        }
        var_823 = wp::where(var_462, var_473, var_427);
        var_824 = wp::where(var_462, var_474, var_78);
        var_825 = wp::where(var_462, var_794, var_398);
        var_826 = wp::where(var_462, var_566, var_170);
        var_827 = wp::where(var_462, var_570, var_174);
        var_828 = wp::where(var_462, var_682, var_286);
        var_829 = wp::where(var_462, var_686, var_290);
        var_830 = wp::where(var_462, var_798, var_402);
        var_831 = wp::where(var_462, var_802, var_406);
        // p = 0 if pair < 3 else 1 if pair < 5 else 2                                        <L 13>
        var_834 = (var_832 < var_833);
        if (var_834) {
        }
        if (!var_834) {
            var_837 = (var_832 < var_836);
            if (var_837) {
            }
            if (!var_837) {
            }
            var_840 = wp::where(var_837, var_838, var_839);
        }
        var_841 = wp::where(var_834, var_835, var_840);
        // q = pair + 1 - (0 if pair < 3 else 2 if pair < 5 else 3)                           <L 14>
        var_843 = wp::add(var_832, var_842);
        var_845 = (var_832 < var_844);
        if (var_845) {
        }
        if (!var_845) {
            var_848 = (var_832 < var_847);
            if (var_848) {
            }
            if (!var_848) {
            }
            var_851 = wp::where(var_848, var_849, var_850);
        }
        var_852 = wp::where(var_845, var_846, var_851);
        var_853 = wp::sub(var_843, var_852);
        // apq = a[p * 4 + q]                                                                 <L 15>
        var_855 = wp::mul(var_841, var_854);
        var_856 = wp::add(var_855, var_853);
        var_857 = wp::extract(var_0, var_856);
        // app = a[p * 4 + p]                                                                 <L 16>
        var_859 = wp::mul(var_841, var_858);
        var_860 = wp::add(var_859, var_841);
        var_861 = wp::extract(var_0, var_860);
        // aqq = a[q * 4 + q]                                                                 <L 17>
        var_863 = wp::mul(var_853, var_862);
        var_864 = wp::add(var_863, var_853);
        var_865 = wp::extract(var_0, var_864);
        // if abs(apq) > float64(1e-300) and abs(apq) > float64(1e-18) * sqrt(abs(app * aqq)):       <L 18>
        var_867 = wp::abs(var_857);
        var_868 = 1e-300;
        var_869 = (var_867 > var_868);
        var_866 = var_869;
        if (var_866) {
            var_870 = wp::abs(var_857);
            var_871 = 1e-18;
            var_872 = wp::mul(var_861, var_865);
            var_873 = wp::abs(var_872);
            var_874 = wp::sqrt(var_873);
            var_875 = wp::mul(var_871, var_874);
            var_876 = (var_870 > var_875);
            var_866 = var_866 && var_876;
        }
        if (var_866) {
            // rotated = 1                                                                    <L 19>
            // cs = jacobi_rotation(app, aqq, apq)                                            <L 20>
            var_878 = jacobi_rotation_0(var_861, var_865, var_857);
            // for k in range(4):                                                             <L 21>
            // akp = a[k * 4 + p]                                                             <L 22>
            var_881 = wp::mul(var_879, var_880);
            var_882 = wp::add(var_881, var_841);
            var_883 = wp::extract(var_0, var_882);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_885 = wp::mul(var_879, var_884);
            var_886 = wp::add(var_885, var_853);
            var_887 = wp::extract(var_0, var_886);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_889 = wp::extract(var_878, var_888);
            var_890 = wp::mul(var_889, var_883);
            var_892 = wp::extract(var_878, var_891);
            var_893 = wp::mul(var_892, var_887);
            var_894 = wp::sub(var_890, var_893);
            var_896 = wp::mul(var_879, var_895);
            var_897 = wp::add(var_896, var_841);
            wp::assign_inplace(var_0, var_897, var_894);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_899 = wp::extract(var_878, var_898);
            var_900 = wp::mul(var_899, var_883);
            var_902 = wp::extract(var_878, var_901);
            var_903 = wp::mul(var_902, var_887);
            var_904 = wp::add(var_900, var_903);
            var_906 = wp::mul(var_879, var_905);
            var_907 = wp::add(var_906, var_853);
            wp::assign_inplace(var_0, var_907, var_904);
            // akp = a[k * 4 + p]                                                             <L 22>
            var_910 = wp::mul(var_908, var_909);
            var_911 = wp::add(var_910, var_841);
            var_912 = wp::extract(var_0, var_911);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_914 = wp::mul(var_908, var_913);
            var_915 = wp::add(var_914, var_853);
            var_916 = wp::extract(var_0, var_915);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_918 = wp::extract(var_878, var_917);
            var_919 = wp::mul(var_918, var_912);
            var_921 = wp::extract(var_878, var_920);
            var_922 = wp::mul(var_921, var_916);
            var_923 = wp::sub(var_919, var_922);
            var_925 = wp::mul(var_908, var_924);
            var_926 = wp::add(var_925, var_841);
            wp::assign_inplace(var_0, var_926, var_923);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_928 = wp::extract(var_878, var_927);
            var_929 = wp::mul(var_928, var_912);
            var_931 = wp::extract(var_878, var_930);
            var_932 = wp::mul(var_931, var_916);
            var_933 = wp::add(var_929, var_932);
            var_935 = wp::mul(var_908, var_934);
            var_936 = wp::add(var_935, var_853);
            wp::assign_inplace(var_0, var_936, var_933);
            // akp = a[k * 4 + p]                                                             <L 22>
            var_939 = wp::mul(var_937, var_938);
            var_940 = wp::add(var_939, var_841);
            var_941 = wp::extract(var_0, var_940);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_943 = wp::mul(var_937, var_942);
            var_944 = wp::add(var_943, var_853);
            var_945 = wp::extract(var_0, var_944);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_947 = wp::extract(var_878, var_946);
            var_948 = wp::mul(var_947, var_941);
            var_950 = wp::extract(var_878, var_949);
            var_951 = wp::mul(var_950, var_945);
            var_952 = wp::sub(var_948, var_951);
            var_954 = wp::mul(var_937, var_953);
            var_955 = wp::add(var_954, var_841);
            wp::assign_inplace(var_0, var_955, var_952);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_957 = wp::extract(var_878, var_956);
            var_958 = wp::mul(var_957, var_941);
            var_960 = wp::extract(var_878, var_959);
            var_961 = wp::mul(var_960, var_945);
            var_962 = wp::add(var_958, var_961);
            var_964 = wp::mul(var_937, var_963);
            var_965 = wp::add(var_964, var_853);
            wp::assign_inplace(var_0, var_965, var_962);
            // akp = a[k * 4 + p]                                                             <L 22>
            var_968 = wp::mul(var_966, var_967);
            var_969 = wp::add(var_968, var_841);
            var_970 = wp::extract(var_0, var_969);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_972 = wp::mul(var_966, var_971);
            var_973 = wp::add(var_972, var_853);
            var_974 = wp::extract(var_0, var_973);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_976 = wp::extract(var_878, var_975);
            var_977 = wp::mul(var_976, var_970);
            var_979 = wp::extract(var_878, var_978);
            var_980 = wp::mul(var_979, var_974);
            var_981 = wp::sub(var_977, var_980);
            var_983 = wp::mul(var_966, var_982);
            var_984 = wp::add(var_983, var_841);
            wp::assign_inplace(var_0, var_984, var_981);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_986 = wp::extract(var_878, var_985);
            var_987 = wp::mul(var_986, var_970);
            var_989 = wp::extract(var_878, var_988);
            var_990 = wp::mul(var_989, var_974);
            var_991 = wp::add(var_987, var_990);
            var_993 = wp::mul(var_966, var_992);
            var_994 = wp::add(var_993, var_853);
            wp::assign_inplace(var_0, var_994, var_991);
            // for k in range(4):                                                             <L 26>
            // apk = a[p * 4 + k]                                                             <L 27>
            var_997 = wp::mul(var_841, var_996);
            var_998 = wp::add(var_997, var_995);
            var_999 = wp::extract(var_0, var_998);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_1001 = wp::mul(var_853, var_1000);
            var_1002 = wp::add(var_1001, var_995);
            var_1003 = wp::extract(var_0, var_1002);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_1005 = wp::extract(var_878, var_1004);
            var_1006 = wp::mul(var_1005, var_999);
            var_1008 = wp::extract(var_878, var_1007);
            var_1009 = wp::mul(var_1008, var_1003);
            var_1010 = wp::sub(var_1006, var_1009);
            var_1012 = wp::mul(var_841, var_1011);
            var_1013 = wp::add(var_1012, var_995);
            wp::assign_inplace(var_0, var_1013, var_1010);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_1015 = wp::extract(var_878, var_1014);
            var_1016 = wp::mul(var_1015, var_999);
            var_1018 = wp::extract(var_878, var_1017);
            var_1019 = wp::mul(var_1018, var_1003);
            var_1020 = wp::add(var_1016, var_1019);
            var_1022 = wp::mul(var_853, var_1021);
            var_1023 = wp::add(var_1022, var_995);
            wp::assign_inplace(var_0, var_1023, var_1020);
            // apk = a[p * 4 + k]                                                             <L 27>
            var_1026 = wp::mul(var_841, var_1025);
            var_1027 = wp::add(var_1026, var_1024);
            var_1028 = wp::extract(var_0, var_1027);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_1030 = wp::mul(var_853, var_1029);
            var_1031 = wp::add(var_1030, var_1024);
            var_1032 = wp::extract(var_0, var_1031);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_1034 = wp::extract(var_878, var_1033);
            var_1035 = wp::mul(var_1034, var_1028);
            var_1037 = wp::extract(var_878, var_1036);
            var_1038 = wp::mul(var_1037, var_1032);
            var_1039 = wp::sub(var_1035, var_1038);
            var_1041 = wp::mul(var_841, var_1040);
            var_1042 = wp::add(var_1041, var_1024);
            wp::assign_inplace(var_0, var_1042, var_1039);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_1044 = wp::extract(var_878, var_1043);
            var_1045 = wp::mul(var_1044, var_1028);
            var_1047 = wp::extract(var_878, var_1046);
            var_1048 = wp::mul(var_1047, var_1032);
            var_1049 = wp::add(var_1045, var_1048);
            var_1051 = wp::mul(var_853, var_1050);
            var_1052 = wp::add(var_1051, var_1024);
            wp::assign_inplace(var_0, var_1052, var_1049);
            // apk = a[p * 4 + k]                                                             <L 27>
            var_1055 = wp::mul(var_841, var_1054);
            var_1056 = wp::add(var_1055, var_1053);
            var_1057 = wp::extract(var_0, var_1056);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_1059 = wp::mul(var_853, var_1058);
            var_1060 = wp::add(var_1059, var_1053);
            var_1061 = wp::extract(var_0, var_1060);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_1063 = wp::extract(var_878, var_1062);
            var_1064 = wp::mul(var_1063, var_1057);
            var_1066 = wp::extract(var_878, var_1065);
            var_1067 = wp::mul(var_1066, var_1061);
            var_1068 = wp::sub(var_1064, var_1067);
            var_1070 = wp::mul(var_841, var_1069);
            var_1071 = wp::add(var_1070, var_1053);
            wp::assign_inplace(var_0, var_1071, var_1068);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_1073 = wp::extract(var_878, var_1072);
            var_1074 = wp::mul(var_1073, var_1057);
            var_1076 = wp::extract(var_878, var_1075);
            var_1077 = wp::mul(var_1076, var_1061);
            var_1078 = wp::add(var_1074, var_1077);
            var_1080 = wp::mul(var_853, var_1079);
            var_1081 = wp::add(var_1080, var_1053);
            wp::assign_inplace(var_0, var_1081, var_1078);
            // apk = a[p * 4 + k]                                                             <L 27>
            var_1084 = wp::mul(var_841, var_1083);
            var_1085 = wp::add(var_1084, var_1082);
            var_1086 = wp::extract(var_0, var_1085);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_1088 = wp::mul(var_853, var_1087);
            var_1089 = wp::add(var_1088, var_1082);
            var_1090 = wp::extract(var_0, var_1089);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_1092 = wp::extract(var_878, var_1091);
            var_1093 = wp::mul(var_1092, var_1086);
            var_1095 = wp::extract(var_878, var_1094);
            var_1096 = wp::mul(var_1095, var_1090);
            var_1097 = wp::sub(var_1093, var_1096);
            var_1099 = wp::mul(var_841, var_1098);
            var_1100 = wp::add(var_1099, var_1082);
            wp::assign_inplace(var_0, var_1100, var_1097);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_1102 = wp::extract(var_878, var_1101);
            var_1103 = wp::mul(var_1102, var_1086);
            var_1105 = wp::extract(var_878, var_1104);
            var_1106 = wp::mul(var_1105, var_1090);
            var_1107 = wp::add(var_1103, var_1106);
            var_1109 = wp::mul(var_853, var_1108);
            var_1110 = wp::add(var_1109, var_1082);
            wp::assign_inplace(var_0, var_1110, var_1107);
            // for k in range(4):                                                             <L 31>
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_1113 = wp::mul(var_1111, var_1112);
            var_1114 = wp::add(var_1113, var_841);
            var_1115 = wp::extract(var_2, var_1114);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_1117 = wp::mul(var_1111, var_1116);
            var_1118 = wp::add(var_1117, var_853);
            var_1119 = wp::extract(var_2, var_1118);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_1121 = wp::extract(var_878, var_1120);
            var_1122 = wp::mul(var_1121, var_1115);
            var_1124 = wp::extract(var_878, var_1123);
            var_1125 = wp::mul(var_1124, var_1119);
            var_1126 = wp::sub(var_1122, var_1125);
            var_1128 = wp::mul(var_1111, var_1127);
            var_1129 = wp::add(var_1128, var_841);
            wp::assign_inplace(var_2, var_1129, var_1126);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_1131 = wp::extract(var_878, var_1130);
            var_1132 = wp::mul(var_1131, var_1115);
            var_1134 = wp::extract(var_878, var_1133);
            var_1135 = wp::mul(var_1134, var_1119);
            var_1136 = wp::add(var_1132, var_1135);
            var_1138 = wp::mul(var_1111, var_1137);
            var_1139 = wp::add(var_1138, var_853);
            wp::assign_inplace(var_2, var_1139, var_1136);
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_1142 = wp::mul(var_1140, var_1141);
            var_1143 = wp::add(var_1142, var_841);
            var_1144 = wp::extract(var_2, var_1143);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_1146 = wp::mul(var_1140, var_1145);
            var_1147 = wp::add(var_1146, var_853);
            var_1148 = wp::extract(var_2, var_1147);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_1150 = wp::extract(var_878, var_1149);
            var_1151 = wp::mul(var_1150, var_1144);
            var_1153 = wp::extract(var_878, var_1152);
            var_1154 = wp::mul(var_1153, var_1148);
            var_1155 = wp::sub(var_1151, var_1154);
            var_1157 = wp::mul(var_1140, var_1156);
            var_1158 = wp::add(var_1157, var_841);
            wp::assign_inplace(var_2, var_1158, var_1155);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_1160 = wp::extract(var_878, var_1159);
            var_1161 = wp::mul(var_1160, var_1144);
            var_1163 = wp::extract(var_878, var_1162);
            var_1164 = wp::mul(var_1163, var_1148);
            var_1165 = wp::add(var_1161, var_1164);
            var_1167 = wp::mul(var_1140, var_1166);
            var_1168 = wp::add(var_1167, var_853);
            wp::assign_inplace(var_2, var_1168, var_1165);
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_1171 = wp::mul(var_1169, var_1170);
            var_1172 = wp::add(var_1171, var_841);
            var_1173 = wp::extract(var_2, var_1172);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_1175 = wp::mul(var_1169, var_1174);
            var_1176 = wp::add(var_1175, var_853);
            var_1177 = wp::extract(var_2, var_1176);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_1179 = wp::extract(var_878, var_1178);
            var_1180 = wp::mul(var_1179, var_1173);
            var_1182 = wp::extract(var_878, var_1181);
            var_1183 = wp::mul(var_1182, var_1177);
            var_1184 = wp::sub(var_1180, var_1183);
            var_1186 = wp::mul(var_1169, var_1185);
            var_1187 = wp::add(var_1186, var_841);
            wp::assign_inplace(var_2, var_1187, var_1184);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_1189 = wp::extract(var_878, var_1188);
            var_1190 = wp::mul(var_1189, var_1173);
            var_1192 = wp::extract(var_878, var_1191);
            var_1193 = wp::mul(var_1192, var_1177);
            var_1194 = wp::add(var_1190, var_1193);
            var_1196 = wp::mul(var_1169, var_1195);
            var_1197 = wp::add(var_1196, var_853);
            wp::assign_inplace(var_2, var_1197, var_1194);
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_1200 = wp::mul(var_1198, var_1199);
            var_1201 = wp::add(var_1200, var_841);
            var_1202 = wp::extract(var_2, var_1201);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_1204 = wp::mul(var_1198, var_1203);
            var_1205 = wp::add(var_1204, var_853);
            var_1206 = wp::extract(var_2, var_1205);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_1208 = wp::extract(var_878, var_1207);
            var_1209 = wp::mul(var_1208, var_1202);
            var_1211 = wp::extract(var_878, var_1210);
            var_1212 = wp::mul(var_1211, var_1206);
            var_1213 = wp::sub(var_1209, var_1212);
            var_1215 = wp::mul(var_1198, var_1214);
            var_1216 = wp::add(var_1215, var_841);
            wp::assign_inplace(var_2, var_1216, var_1213);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_1218 = wp::extract(var_878, var_1217);
            var_1219 = wp::mul(var_1218, var_1202);
            var_1221 = wp::extract(var_878, var_1220);
            var_1222 = wp::mul(var_1221, var_1206);
            var_1223 = wp::add(var_1219, var_1222);
            var_1225 = wp::mul(var_1198, var_1224);
            var_1226 = wp::add(var_1225, var_853);
            wp::assign_inplace(var_2, var_1226, var_1223);
        }
        var_1227 = wp::where(var_866, var_877, var_823);
        var_1228 = wp::where(var_866, var_878, var_824);
        var_1229 = wp::where(var_866, var_1198, var_825);
        var_1230 = wp::where(var_866, var_970, var_826);
        var_1231 = wp::where(var_866, var_974, var_827);
        var_1232 = wp::where(var_866, var_1086, var_828);
        var_1233 = wp::where(var_866, var_1090, var_829);
        var_1234 = wp::where(var_866, var_1202, var_830);
        var_1235 = wp::where(var_866, var_1206, var_831);
        // p = 0 if pair < 3 else 1 if pair < 5 else 2                                        <L 13>
        var_1238 = (var_1236 < var_1237);
        if (var_1238) {
        }
        if (!var_1238) {
            var_1241 = (var_1236 < var_1240);
            if (var_1241) {
            }
            if (!var_1241) {
            }
            var_1244 = wp::where(var_1241, var_1242, var_1243);
        }
        var_1245 = wp::where(var_1238, var_1239, var_1244);
        // q = pair + 1 - (0 if pair < 3 else 2 if pair < 5 else 3)                           <L 14>
        var_1247 = wp::add(var_1236, var_1246);
        var_1249 = (var_1236 < var_1248);
        if (var_1249) {
        }
        if (!var_1249) {
            var_1252 = (var_1236 < var_1251);
            if (var_1252) {
            }
            if (!var_1252) {
            }
            var_1255 = wp::where(var_1252, var_1253, var_1254);
        }
        var_1256 = wp::where(var_1249, var_1250, var_1255);
        var_1257 = wp::sub(var_1247, var_1256);
        // apq = a[p * 4 + q]                                                                 <L 15>
        var_1259 = wp::mul(var_1245, var_1258);
        var_1260 = wp::add(var_1259, var_1257);
        var_1261 = wp::extract(var_0, var_1260);
        // app = a[p * 4 + p]                                                                 <L 16>
        var_1263 = wp::mul(var_1245, var_1262);
        var_1264 = wp::add(var_1263, var_1245);
        var_1265 = wp::extract(var_0, var_1264);
        // aqq = a[q * 4 + q]                                                                 <L 17>
        var_1267 = wp::mul(var_1257, var_1266);
        var_1268 = wp::add(var_1267, var_1257);
        var_1269 = wp::extract(var_0, var_1268);
        // if abs(apq) > float64(1e-300) and abs(apq) > float64(1e-18) * sqrt(abs(app * aqq)):       <L 18>
        var_1271 = wp::abs(var_1261);
        var_1272 = 1e-300;
        var_1273 = (var_1271 > var_1272);
        var_1270 = var_1273;
        if (var_1270) {
            var_1274 = wp::abs(var_1261);
            var_1275 = 1e-18;
            var_1276 = wp::mul(var_1265, var_1269);
            var_1277 = wp::abs(var_1276);
            var_1278 = wp::sqrt(var_1277);
            var_1279 = wp::mul(var_1275, var_1278);
            var_1280 = (var_1274 > var_1279);
            var_1270 = var_1270 && var_1280;
        }
        if (var_1270) {
            // rotated = 1                                                                    <L 19>
            // cs = jacobi_rotation(app, aqq, apq)                                            <L 20>
            var_1282 = jacobi_rotation_0(var_1265, var_1269, var_1261);
            // for k in range(4):                                                             <L 21>
            // akp = a[k * 4 + p]                                                             <L 22>
            var_1285 = wp::mul(var_1283, var_1284);
            var_1286 = wp::add(var_1285, var_1245);
            var_1287 = wp::extract(var_0, var_1286);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_1289 = wp::mul(var_1283, var_1288);
            var_1290 = wp::add(var_1289, var_1257);
            var_1291 = wp::extract(var_0, var_1290);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_1293 = wp::extract(var_1282, var_1292);
            var_1294 = wp::mul(var_1293, var_1287);
            var_1296 = wp::extract(var_1282, var_1295);
            var_1297 = wp::mul(var_1296, var_1291);
            var_1298 = wp::sub(var_1294, var_1297);
            var_1300 = wp::mul(var_1283, var_1299);
            var_1301 = wp::add(var_1300, var_1245);
            wp::assign_inplace(var_0, var_1301, var_1298);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_1303 = wp::extract(var_1282, var_1302);
            var_1304 = wp::mul(var_1303, var_1287);
            var_1306 = wp::extract(var_1282, var_1305);
            var_1307 = wp::mul(var_1306, var_1291);
            var_1308 = wp::add(var_1304, var_1307);
            var_1310 = wp::mul(var_1283, var_1309);
            var_1311 = wp::add(var_1310, var_1257);
            wp::assign_inplace(var_0, var_1311, var_1308);
            // akp = a[k * 4 + p]                                                             <L 22>
            var_1314 = wp::mul(var_1312, var_1313);
            var_1315 = wp::add(var_1314, var_1245);
            var_1316 = wp::extract(var_0, var_1315);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_1318 = wp::mul(var_1312, var_1317);
            var_1319 = wp::add(var_1318, var_1257);
            var_1320 = wp::extract(var_0, var_1319);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_1322 = wp::extract(var_1282, var_1321);
            var_1323 = wp::mul(var_1322, var_1316);
            var_1325 = wp::extract(var_1282, var_1324);
            var_1326 = wp::mul(var_1325, var_1320);
            var_1327 = wp::sub(var_1323, var_1326);
            var_1329 = wp::mul(var_1312, var_1328);
            var_1330 = wp::add(var_1329, var_1245);
            wp::assign_inplace(var_0, var_1330, var_1327);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_1332 = wp::extract(var_1282, var_1331);
            var_1333 = wp::mul(var_1332, var_1316);
            var_1335 = wp::extract(var_1282, var_1334);
            var_1336 = wp::mul(var_1335, var_1320);
            var_1337 = wp::add(var_1333, var_1336);
            var_1339 = wp::mul(var_1312, var_1338);
            var_1340 = wp::add(var_1339, var_1257);
            wp::assign_inplace(var_0, var_1340, var_1337);
            // akp = a[k * 4 + p]                                                             <L 22>
            var_1343 = wp::mul(var_1341, var_1342);
            var_1344 = wp::add(var_1343, var_1245);
            var_1345 = wp::extract(var_0, var_1344);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_1347 = wp::mul(var_1341, var_1346);
            var_1348 = wp::add(var_1347, var_1257);
            var_1349 = wp::extract(var_0, var_1348);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_1351 = wp::extract(var_1282, var_1350);
            var_1352 = wp::mul(var_1351, var_1345);
            var_1354 = wp::extract(var_1282, var_1353);
            var_1355 = wp::mul(var_1354, var_1349);
            var_1356 = wp::sub(var_1352, var_1355);
            var_1358 = wp::mul(var_1341, var_1357);
            var_1359 = wp::add(var_1358, var_1245);
            wp::assign_inplace(var_0, var_1359, var_1356);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_1361 = wp::extract(var_1282, var_1360);
            var_1362 = wp::mul(var_1361, var_1345);
            var_1364 = wp::extract(var_1282, var_1363);
            var_1365 = wp::mul(var_1364, var_1349);
            var_1366 = wp::add(var_1362, var_1365);
            var_1368 = wp::mul(var_1341, var_1367);
            var_1369 = wp::add(var_1368, var_1257);
            wp::assign_inplace(var_0, var_1369, var_1366);
            // akp = a[k * 4 + p]                                                             <L 22>
            var_1372 = wp::mul(var_1370, var_1371);
            var_1373 = wp::add(var_1372, var_1245);
            var_1374 = wp::extract(var_0, var_1373);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_1376 = wp::mul(var_1370, var_1375);
            var_1377 = wp::add(var_1376, var_1257);
            var_1378 = wp::extract(var_0, var_1377);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_1380 = wp::extract(var_1282, var_1379);
            var_1381 = wp::mul(var_1380, var_1374);
            var_1383 = wp::extract(var_1282, var_1382);
            var_1384 = wp::mul(var_1383, var_1378);
            var_1385 = wp::sub(var_1381, var_1384);
            var_1387 = wp::mul(var_1370, var_1386);
            var_1388 = wp::add(var_1387, var_1245);
            wp::assign_inplace(var_0, var_1388, var_1385);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_1390 = wp::extract(var_1282, var_1389);
            var_1391 = wp::mul(var_1390, var_1374);
            var_1393 = wp::extract(var_1282, var_1392);
            var_1394 = wp::mul(var_1393, var_1378);
            var_1395 = wp::add(var_1391, var_1394);
            var_1397 = wp::mul(var_1370, var_1396);
            var_1398 = wp::add(var_1397, var_1257);
            wp::assign_inplace(var_0, var_1398, var_1395);
            // for k in range(4):                                                             <L 26>
            // apk = a[p * 4 + k]                                                             <L 27>
            var_1401 = wp::mul(var_1245, var_1400);
            var_1402 = wp::add(var_1401, var_1399);
            var_1403 = wp::extract(var_0, var_1402);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_1405 = wp::mul(var_1257, var_1404);
            var_1406 = wp::add(var_1405, var_1399);
            var_1407 = wp::extract(var_0, var_1406);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_1409 = wp::extract(var_1282, var_1408);
            var_1410 = wp::mul(var_1409, var_1403);
            var_1412 = wp::extract(var_1282, var_1411);
            var_1413 = wp::mul(var_1412, var_1407);
            var_1414 = wp::sub(var_1410, var_1413);
            var_1416 = wp::mul(var_1245, var_1415);
            var_1417 = wp::add(var_1416, var_1399);
            wp::assign_inplace(var_0, var_1417, var_1414);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_1419 = wp::extract(var_1282, var_1418);
            var_1420 = wp::mul(var_1419, var_1403);
            var_1422 = wp::extract(var_1282, var_1421);
            var_1423 = wp::mul(var_1422, var_1407);
            var_1424 = wp::add(var_1420, var_1423);
            var_1426 = wp::mul(var_1257, var_1425);
            var_1427 = wp::add(var_1426, var_1399);
            wp::assign_inplace(var_0, var_1427, var_1424);
            // apk = a[p * 4 + k]                                                             <L 27>
            var_1430 = wp::mul(var_1245, var_1429);
            var_1431 = wp::add(var_1430, var_1428);
            var_1432 = wp::extract(var_0, var_1431);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_1434 = wp::mul(var_1257, var_1433);
            var_1435 = wp::add(var_1434, var_1428);
            var_1436 = wp::extract(var_0, var_1435);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_1438 = wp::extract(var_1282, var_1437);
            var_1439 = wp::mul(var_1438, var_1432);
            var_1441 = wp::extract(var_1282, var_1440);
            var_1442 = wp::mul(var_1441, var_1436);
            var_1443 = wp::sub(var_1439, var_1442);
            var_1445 = wp::mul(var_1245, var_1444);
            var_1446 = wp::add(var_1445, var_1428);
            wp::assign_inplace(var_0, var_1446, var_1443);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_1448 = wp::extract(var_1282, var_1447);
            var_1449 = wp::mul(var_1448, var_1432);
            var_1451 = wp::extract(var_1282, var_1450);
            var_1452 = wp::mul(var_1451, var_1436);
            var_1453 = wp::add(var_1449, var_1452);
            var_1455 = wp::mul(var_1257, var_1454);
            var_1456 = wp::add(var_1455, var_1428);
            wp::assign_inplace(var_0, var_1456, var_1453);
            // apk = a[p * 4 + k]                                                             <L 27>
            var_1459 = wp::mul(var_1245, var_1458);
            var_1460 = wp::add(var_1459, var_1457);
            var_1461 = wp::extract(var_0, var_1460);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_1463 = wp::mul(var_1257, var_1462);
            var_1464 = wp::add(var_1463, var_1457);
            var_1465 = wp::extract(var_0, var_1464);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_1467 = wp::extract(var_1282, var_1466);
            var_1468 = wp::mul(var_1467, var_1461);
            var_1470 = wp::extract(var_1282, var_1469);
            var_1471 = wp::mul(var_1470, var_1465);
            var_1472 = wp::sub(var_1468, var_1471);
            var_1474 = wp::mul(var_1245, var_1473);
            var_1475 = wp::add(var_1474, var_1457);
            wp::assign_inplace(var_0, var_1475, var_1472);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_1477 = wp::extract(var_1282, var_1476);
            var_1478 = wp::mul(var_1477, var_1461);
            var_1480 = wp::extract(var_1282, var_1479);
            var_1481 = wp::mul(var_1480, var_1465);
            var_1482 = wp::add(var_1478, var_1481);
            var_1484 = wp::mul(var_1257, var_1483);
            var_1485 = wp::add(var_1484, var_1457);
            wp::assign_inplace(var_0, var_1485, var_1482);
            // apk = a[p * 4 + k]                                                             <L 27>
            var_1488 = wp::mul(var_1245, var_1487);
            var_1489 = wp::add(var_1488, var_1486);
            var_1490 = wp::extract(var_0, var_1489);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_1492 = wp::mul(var_1257, var_1491);
            var_1493 = wp::add(var_1492, var_1486);
            var_1494 = wp::extract(var_0, var_1493);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_1496 = wp::extract(var_1282, var_1495);
            var_1497 = wp::mul(var_1496, var_1490);
            var_1499 = wp::extract(var_1282, var_1498);
            var_1500 = wp::mul(var_1499, var_1494);
            var_1501 = wp::sub(var_1497, var_1500);
            var_1503 = wp::mul(var_1245, var_1502);
            var_1504 = wp::add(var_1503, var_1486);
            wp::assign_inplace(var_0, var_1504, var_1501);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_1506 = wp::extract(var_1282, var_1505);
            var_1507 = wp::mul(var_1506, var_1490);
            var_1509 = wp::extract(var_1282, var_1508);
            var_1510 = wp::mul(var_1509, var_1494);
            var_1511 = wp::add(var_1507, var_1510);
            var_1513 = wp::mul(var_1257, var_1512);
            var_1514 = wp::add(var_1513, var_1486);
            wp::assign_inplace(var_0, var_1514, var_1511);
            // for k in range(4):                                                             <L 31>
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_1517 = wp::mul(var_1515, var_1516);
            var_1518 = wp::add(var_1517, var_1245);
            var_1519 = wp::extract(var_2, var_1518);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_1521 = wp::mul(var_1515, var_1520);
            var_1522 = wp::add(var_1521, var_1257);
            var_1523 = wp::extract(var_2, var_1522);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_1525 = wp::extract(var_1282, var_1524);
            var_1526 = wp::mul(var_1525, var_1519);
            var_1528 = wp::extract(var_1282, var_1527);
            var_1529 = wp::mul(var_1528, var_1523);
            var_1530 = wp::sub(var_1526, var_1529);
            var_1532 = wp::mul(var_1515, var_1531);
            var_1533 = wp::add(var_1532, var_1245);
            wp::assign_inplace(var_2, var_1533, var_1530);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_1535 = wp::extract(var_1282, var_1534);
            var_1536 = wp::mul(var_1535, var_1519);
            var_1538 = wp::extract(var_1282, var_1537);
            var_1539 = wp::mul(var_1538, var_1523);
            var_1540 = wp::add(var_1536, var_1539);
            var_1542 = wp::mul(var_1515, var_1541);
            var_1543 = wp::add(var_1542, var_1257);
            wp::assign_inplace(var_2, var_1543, var_1540);
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_1546 = wp::mul(var_1544, var_1545);
            var_1547 = wp::add(var_1546, var_1245);
            var_1548 = wp::extract(var_2, var_1547);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_1550 = wp::mul(var_1544, var_1549);
            var_1551 = wp::add(var_1550, var_1257);
            var_1552 = wp::extract(var_2, var_1551);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_1554 = wp::extract(var_1282, var_1553);
            var_1555 = wp::mul(var_1554, var_1548);
            var_1557 = wp::extract(var_1282, var_1556);
            var_1558 = wp::mul(var_1557, var_1552);
            var_1559 = wp::sub(var_1555, var_1558);
            var_1561 = wp::mul(var_1544, var_1560);
            var_1562 = wp::add(var_1561, var_1245);
            wp::assign_inplace(var_2, var_1562, var_1559);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_1564 = wp::extract(var_1282, var_1563);
            var_1565 = wp::mul(var_1564, var_1548);
            var_1567 = wp::extract(var_1282, var_1566);
            var_1568 = wp::mul(var_1567, var_1552);
            var_1569 = wp::add(var_1565, var_1568);
            var_1571 = wp::mul(var_1544, var_1570);
            var_1572 = wp::add(var_1571, var_1257);
            wp::assign_inplace(var_2, var_1572, var_1569);
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_1575 = wp::mul(var_1573, var_1574);
            var_1576 = wp::add(var_1575, var_1245);
            var_1577 = wp::extract(var_2, var_1576);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_1579 = wp::mul(var_1573, var_1578);
            var_1580 = wp::add(var_1579, var_1257);
            var_1581 = wp::extract(var_2, var_1580);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_1583 = wp::extract(var_1282, var_1582);
            var_1584 = wp::mul(var_1583, var_1577);
            var_1586 = wp::extract(var_1282, var_1585);
            var_1587 = wp::mul(var_1586, var_1581);
            var_1588 = wp::sub(var_1584, var_1587);
            var_1590 = wp::mul(var_1573, var_1589);
            var_1591 = wp::add(var_1590, var_1245);
            wp::assign_inplace(var_2, var_1591, var_1588);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_1593 = wp::extract(var_1282, var_1592);
            var_1594 = wp::mul(var_1593, var_1577);
            var_1596 = wp::extract(var_1282, var_1595);
            var_1597 = wp::mul(var_1596, var_1581);
            var_1598 = wp::add(var_1594, var_1597);
            var_1600 = wp::mul(var_1573, var_1599);
            var_1601 = wp::add(var_1600, var_1257);
            wp::assign_inplace(var_2, var_1601, var_1598);
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_1604 = wp::mul(var_1602, var_1603);
            var_1605 = wp::add(var_1604, var_1245);
            var_1606 = wp::extract(var_2, var_1605);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_1608 = wp::mul(var_1602, var_1607);
            var_1609 = wp::add(var_1608, var_1257);
            var_1610 = wp::extract(var_2, var_1609);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_1612 = wp::extract(var_1282, var_1611);
            var_1613 = wp::mul(var_1612, var_1606);
            var_1615 = wp::extract(var_1282, var_1614);
            var_1616 = wp::mul(var_1615, var_1610);
            var_1617 = wp::sub(var_1613, var_1616);
            var_1619 = wp::mul(var_1602, var_1618);
            var_1620 = wp::add(var_1619, var_1245);
            wp::assign_inplace(var_2, var_1620, var_1617);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_1622 = wp::extract(var_1282, var_1621);
            var_1623 = wp::mul(var_1622, var_1606);
            var_1625 = wp::extract(var_1282, var_1624);
            var_1626 = wp::mul(var_1625, var_1610);
            var_1627 = wp::add(var_1623, var_1626);
            var_1629 = wp::mul(var_1602, var_1628);
            var_1630 = wp::add(var_1629, var_1257);
            wp::assign_inplace(var_2, var_1630, var_1627);
        }
        var_1631 = wp::where(var_1270, var_1281, var_1227);
        var_1632 = wp::where(var_1270, var_1282, var_1228);
        var_1633 = wp::where(var_1270, var_1602, var_1229);
        var_1634 = wp::where(var_1270, var_1374, var_1230);
        var_1635 = wp::where(var_1270, var_1378, var_1231);
        var_1636 = wp::where(var_1270, var_1490, var_1232);
        var_1637 = wp::where(var_1270, var_1494, var_1233);
        var_1638 = wp::where(var_1270, var_1606, var_1234);
        var_1639 = wp::where(var_1270, var_1610, var_1235);
        // p = 0 if pair < 3 else 1 if pair < 5 else 2                                        <L 13>
        var_1642 = (var_1640 < var_1641);
        if (var_1642) {
        }
        if (!var_1642) {
            var_1645 = (var_1640 < var_1644);
            if (var_1645) {
            }
            if (!var_1645) {
            }
            var_1648 = wp::where(var_1645, var_1646, var_1647);
        }
        var_1649 = wp::where(var_1642, var_1643, var_1648);
        // q = pair + 1 - (0 if pair < 3 else 2 if pair < 5 else 3)                           <L 14>
        var_1651 = wp::add(var_1640, var_1650);
        var_1653 = (var_1640 < var_1652);
        if (var_1653) {
        }
        if (!var_1653) {
            var_1656 = (var_1640 < var_1655);
            if (var_1656) {
            }
            if (!var_1656) {
            }
            var_1659 = wp::where(var_1656, var_1657, var_1658);
        }
        var_1660 = wp::where(var_1653, var_1654, var_1659);
        var_1661 = wp::sub(var_1651, var_1660);
        // apq = a[p * 4 + q]                                                                 <L 15>
        var_1663 = wp::mul(var_1649, var_1662);
        var_1664 = wp::add(var_1663, var_1661);
        var_1665 = wp::extract(var_0, var_1664);
        // app = a[p * 4 + p]                                                                 <L 16>
        var_1667 = wp::mul(var_1649, var_1666);
        var_1668 = wp::add(var_1667, var_1649);
        var_1669 = wp::extract(var_0, var_1668);
        // aqq = a[q * 4 + q]                                                                 <L 17>
        var_1671 = wp::mul(var_1661, var_1670);
        var_1672 = wp::add(var_1671, var_1661);
        var_1673 = wp::extract(var_0, var_1672);
        // if abs(apq) > float64(1e-300) and abs(apq) > float64(1e-18) * sqrt(abs(app * aqq)):       <L 18>
        var_1675 = wp::abs(var_1665);
        var_1676 = 1e-300;
        var_1677 = (var_1675 > var_1676);
        var_1674 = var_1677;
        if (var_1674) {
            var_1678 = wp::abs(var_1665);
            var_1679 = 1e-18;
            var_1680 = wp::mul(var_1669, var_1673);
            var_1681 = wp::abs(var_1680);
            var_1682 = wp::sqrt(var_1681);
            var_1683 = wp::mul(var_1679, var_1682);
            var_1684 = (var_1678 > var_1683);
            var_1674 = var_1674 && var_1684;
        }
        if (var_1674) {
            // rotated = 1                                                                    <L 19>
            // cs = jacobi_rotation(app, aqq, apq)                                            <L 20>
            var_1686 = jacobi_rotation_0(var_1669, var_1673, var_1665);
            // for k in range(4):                                                             <L 21>
            // akp = a[k * 4 + p]                                                             <L 22>
            var_1689 = wp::mul(var_1687, var_1688);
            var_1690 = wp::add(var_1689, var_1649);
            var_1691 = wp::extract(var_0, var_1690);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_1693 = wp::mul(var_1687, var_1692);
            var_1694 = wp::add(var_1693, var_1661);
            var_1695 = wp::extract(var_0, var_1694);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_1697 = wp::extract(var_1686, var_1696);
            var_1698 = wp::mul(var_1697, var_1691);
            var_1700 = wp::extract(var_1686, var_1699);
            var_1701 = wp::mul(var_1700, var_1695);
            var_1702 = wp::sub(var_1698, var_1701);
            var_1704 = wp::mul(var_1687, var_1703);
            var_1705 = wp::add(var_1704, var_1649);
            wp::assign_inplace(var_0, var_1705, var_1702);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_1707 = wp::extract(var_1686, var_1706);
            var_1708 = wp::mul(var_1707, var_1691);
            var_1710 = wp::extract(var_1686, var_1709);
            var_1711 = wp::mul(var_1710, var_1695);
            var_1712 = wp::add(var_1708, var_1711);
            var_1714 = wp::mul(var_1687, var_1713);
            var_1715 = wp::add(var_1714, var_1661);
            wp::assign_inplace(var_0, var_1715, var_1712);
            // akp = a[k * 4 + p]                                                             <L 22>
            var_1718 = wp::mul(var_1716, var_1717);
            var_1719 = wp::add(var_1718, var_1649);
            var_1720 = wp::extract(var_0, var_1719);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_1722 = wp::mul(var_1716, var_1721);
            var_1723 = wp::add(var_1722, var_1661);
            var_1724 = wp::extract(var_0, var_1723);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_1726 = wp::extract(var_1686, var_1725);
            var_1727 = wp::mul(var_1726, var_1720);
            var_1729 = wp::extract(var_1686, var_1728);
            var_1730 = wp::mul(var_1729, var_1724);
            var_1731 = wp::sub(var_1727, var_1730);
            var_1733 = wp::mul(var_1716, var_1732);
            var_1734 = wp::add(var_1733, var_1649);
            wp::assign_inplace(var_0, var_1734, var_1731);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_1736 = wp::extract(var_1686, var_1735);
            var_1737 = wp::mul(var_1736, var_1720);
            var_1739 = wp::extract(var_1686, var_1738);
            var_1740 = wp::mul(var_1739, var_1724);
            var_1741 = wp::add(var_1737, var_1740);
            var_1743 = wp::mul(var_1716, var_1742);
            var_1744 = wp::add(var_1743, var_1661);
            wp::assign_inplace(var_0, var_1744, var_1741);
            // akp = a[k * 4 + p]                                                             <L 22>
            var_1747 = wp::mul(var_1745, var_1746);
            var_1748 = wp::add(var_1747, var_1649);
            var_1749 = wp::extract(var_0, var_1748);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_1751 = wp::mul(var_1745, var_1750);
            var_1752 = wp::add(var_1751, var_1661);
            var_1753 = wp::extract(var_0, var_1752);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_1755 = wp::extract(var_1686, var_1754);
            var_1756 = wp::mul(var_1755, var_1749);
            var_1758 = wp::extract(var_1686, var_1757);
            var_1759 = wp::mul(var_1758, var_1753);
            var_1760 = wp::sub(var_1756, var_1759);
            var_1762 = wp::mul(var_1745, var_1761);
            var_1763 = wp::add(var_1762, var_1649);
            wp::assign_inplace(var_0, var_1763, var_1760);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_1765 = wp::extract(var_1686, var_1764);
            var_1766 = wp::mul(var_1765, var_1749);
            var_1768 = wp::extract(var_1686, var_1767);
            var_1769 = wp::mul(var_1768, var_1753);
            var_1770 = wp::add(var_1766, var_1769);
            var_1772 = wp::mul(var_1745, var_1771);
            var_1773 = wp::add(var_1772, var_1661);
            wp::assign_inplace(var_0, var_1773, var_1770);
            // akp = a[k * 4 + p]                                                             <L 22>
            var_1776 = wp::mul(var_1774, var_1775);
            var_1777 = wp::add(var_1776, var_1649);
            var_1778 = wp::extract(var_0, var_1777);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_1780 = wp::mul(var_1774, var_1779);
            var_1781 = wp::add(var_1780, var_1661);
            var_1782 = wp::extract(var_0, var_1781);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_1784 = wp::extract(var_1686, var_1783);
            var_1785 = wp::mul(var_1784, var_1778);
            var_1787 = wp::extract(var_1686, var_1786);
            var_1788 = wp::mul(var_1787, var_1782);
            var_1789 = wp::sub(var_1785, var_1788);
            var_1791 = wp::mul(var_1774, var_1790);
            var_1792 = wp::add(var_1791, var_1649);
            wp::assign_inplace(var_0, var_1792, var_1789);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_1794 = wp::extract(var_1686, var_1793);
            var_1795 = wp::mul(var_1794, var_1778);
            var_1797 = wp::extract(var_1686, var_1796);
            var_1798 = wp::mul(var_1797, var_1782);
            var_1799 = wp::add(var_1795, var_1798);
            var_1801 = wp::mul(var_1774, var_1800);
            var_1802 = wp::add(var_1801, var_1661);
            wp::assign_inplace(var_0, var_1802, var_1799);
            // for k in range(4):                                                             <L 26>
            // apk = a[p * 4 + k]                                                             <L 27>
            var_1805 = wp::mul(var_1649, var_1804);
            var_1806 = wp::add(var_1805, var_1803);
            var_1807 = wp::extract(var_0, var_1806);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_1809 = wp::mul(var_1661, var_1808);
            var_1810 = wp::add(var_1809, var_1803);
            var_1811 = wp::extract(var_0, var_1810);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_1813 = wp::extract(var_1686, var_1812);
            var_1814 = wp::mul(var_1813, var_1807);
            var_1816 = wp::extract(var_1686, var_1815);
            var_1817 = wp::mul(var_1816, var_1811);
            var_1818 = wp::sub(var_1814, var_1817);
            var_1820 = wp::mul(var_1649, var_1819);
            var_1821 = wp::add(var_1820, var_1803);
            wp::assign_inplace(var_0, var_1821, var_1818);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_1823 = wp::extract(var_1686, var_1822);
            var_1824 = wp::mul(var_1823, var_1807);
            var_1826 = wp::extract(var_1686, var_1825);
            var_1827 = wp::mul(var_1826, var_1811);
            var_1828 = wp::add(var_1824, var_1827);
            var_1830 = wp::mul(var_1661, var_1829);
            var_1831 = wp::add(var_1830, var_1803);
            wp::assign_inplace(var_0, var_1831, var_1828);
            // apk = a[p * 4 + k]                                                             <L 27>
            var_1834 = wp::mul(var_1649, var_1833);
            var_1835 = wp::add(var_1834, var_1832);
            var_1836 = wp::extract(var_0, var_1835);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_1838 = wp::mul(var_1661, var_1837);
            var_1839 = wp::add(var_1838, var_1832);
            var_1840 = wp::extract(var_0, var_1839);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_1842 = wp::extract(var_1686, var_1841);
            var_1843 = wp::mul(var_1842, var_1836);
            var_1845 = wp::extract(var_1686, var_1844);
            var_1846 = wp::mul(var_1845, var_1840);
            var_1847 = wp::sub(var_1843, var_1846);
            var_1849 = wp::mul(var_1649, var_1848);
            var_1850 = wp::add(var_1849, var_1832);
            wp::assign_inplace(var_0, var_1850, var_1847);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_1852 = wp::extract(var_1686, var_1851);
            var_1853 = wp::mul(var_1852, var_1836);
            var_1855 = wp::extract(var_1686, var_1854);
            var_1856 = wp::mul(var_1855, var_1840);
            var_1857 = wp::add(var_1853, var_1856);
            var_1859 = wp::mul(var_1661, var_1858);
            var_1860 = wp::add(var_1859, var_1832);
            wp::assign_inplace(var_0, var_1860, var_1857);
            // apk = a[p * 4 + k]                                                             <L 27>
            var_1863 = wp::mul(var_1649, var_1862);
            var_1864 = wp::add(var_1863, var_1861);
            var_1865 = wp::extract(var_0, var_1864);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_1867 = wp::mul(var_1661, var_1866);
            var_1868 = wp::add(var_1867, var_1861);
            var_1869 = wp::extract(var_0, var_1868);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_1871 = wp::extract(var_1686, var_1870);
            var_1872 = wp::mul(var_1871, var_1865);
            var_1874 = wp::extract(var_1686, var_1873);
            var_1875 = wp::mul(var_1874, var_1869);
            var_1876 = wp::sub(var_1872, var_1875);
            var_1878 = wp::mul(var_1649, var_1877);
            var_1879 = wp::add(var_1878, var_1861);
            wp::assign_inplace(var_0, var_1879, var_1876);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_1881 = wp::extract(var_1686, var_1880);
            var_1882 = wp::mul(var_1881, var_1865);
            var_1884 = wp::extract(var_1686, var_1883);
            var_1885 = wp::mul(var_1884, var_1869);
            var_1886 = wp::add(var_1882, var_1885);
            var_1888 = wp::mul(var_1661, var_1887);
            var_1889 = wp::add(var_1888, var_1861);
            wp::assign_inplace(var_0, var_1889, var_1886);
            // apk = a[p * 4 + k]                                                             <L 27>
            var_1892 = wp::mul(var_1649, var_1891);
            var_1893 = wp::add(var_1892, var_1890);
            var_1894 = wp::extract(var_0, var_1893);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_1896 = wp::mul(var_1661, var_1895);
            var_1897 = wp::add(var_1896, var_1890);
            var_1898 = wp::extract(var_0, var_1897);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_1900 = wp::extract(var_1686, var_1899);
            var_1901 = wp::mul(var_1900, var_1894);
            var_1903 = wp::extract(var_1686, var_1902);
            var_1904 = wp::mul(var_1903, var_1898);
            var_1905 = wp::sub(var_1901, var_1904);
            var_1907 = wp::mul(var_1649, var_1906);
            var_1908 = wp::add(var_1907, var_1890);
            wp::assign_inplace(var_0, var_1908, var_1905);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_1910 = wp::extract(var_1686, var_1909);
            var_1911 = wp::mul(var_1910, var_1894);
            var_1913 = wp::extract(var_1686, var_1912);
            var_1914 = wp::mul(var_1913, var_1898);
            var_1915 = wp::add(var_1911, var_1914);
            var_1917 = wp::mul(var_1661, var_1916);
            var_1918 = wp::add(var_1917, var_1890);
            wp::assign_inplace(var_0, var_1918, var_1915);
            // for k in range(4):                                                             <L 31>
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_1921 = wp::mul(var_1919, var_1920);
            var_1922 = wp::add(var_1921, var_1649);
            var_1923 = wp::extract(var_2, var_1922);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_1925 = wp::mul(var_1919, var_1924);
            var_1926 = wp::add(var_1925, var_1661);
            var_1927 = wp::extract(var_2, var_1926);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_1929 = wp::extract(var_1686, var_1928);
            var_1930 = wp::mul(var_1929, var_1923);
            var_1932 = wp::extract(var_1686, var_1931);
            var_1933 = wp::mul(var_1932, var_1927);
            var_1934 = wp::sub(var_1930, var_1933);
            var_1936 = wp::mul(var_1919, var_1935);
            var_1937 = wp::add(var_1936, var_1649);
            wp::assign_inplace(var_2, var_1937, var_1934);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_1939 = wp::extract(var_1686, var_1938);
            var_1940 = wp::mul(var_1939, var_1923);
            var_1942 = wp::extract(var_1686, var_1941);
            var_1943 = wp::mul(var_1942, var_1927);
            var_1944 = wp::add(var_1940, var_1943);
            var_1946 = wp::mul(var_1919, var_1945);
            var_1947 = wp::add(var_1946, var_1661);
            wp::assign_inplace(var_2, var_1947, var_1944);
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_1950 = wp::mul(var_1948, var_1949);
            var_1951 = wp::add(var_1950, var_1649);
            var_1952 = wp::extract(var_2, var_1951);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_1954 = wp::mul(var_1948, var_1953);
            var_1955 = wp::add(var_1954, var_1661);
            var_1956 = wp::extract(var_2, var_1955);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_1958 = wp::extract(var_1686, var_1957);
            var_1959 = wp::mul(var_1958, var_1952);
            var_1961 = wp::extract(var_1686, var_1960);
            var_1962 = wp::mul(var_1961, var_1956);
            var_1963 = wp::sub(var_1959, var_1962);
            var_1965 = wp::mul(var_1948, var_1964);
            var_1966 = wp::add(var_1965, var_1649);
            wp::assign_inplace(var_2, var_1966, var_1963);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_1968 = wp::extract(var_1686, var_1967);
            var_1969 = wp::mul(var_1968, var_1952);
            var_1971 = wp::extract(var_1686, var_1970);
            var_1972 = wp::mul(var_1971, var_1956);
            var_1973 = wp::add(var_1969, var_1972);
            var_1975 = wp::mul(var_1948, var_1974);
            var_1976 = wp::add(var_1975, var_1661);
            wp::assign_inplace(var_2, var_1976, var_1973);
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_1979 = wp::mul(var_1977, var_1978);
            var_1980 = wp::add(var_1979, var_1649);
            var_1981 = wp::extract(var_2, var_1980);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_1983 = wp::mul(var_1977, var_1982);
            var_1984 = wp::add(var_1983, var_1661);
            var_1985 = wp::extract(var_2, var_1984);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_1987 = wp::extract(var_1686, var_1986);
            var_1988 = wp::mul(var_1987, var_1981);
            var_1990 = wp::extract(var_1686, var_1989);
            var_1991 = wp::mul(var_1990, var_1985);
            var_1992 = wp::sub(var_1988, var_1991);
            var_1994 = wp::mul(var_1977, var_1993);
            var_1995 = wp::add(var_1994, var_1649);
            wp::assign_inplace(var_2, var_1995, var_1992);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_1997 = wp::extract(var_1686, var_1996);
            var_1998 = wp::mul(var_1997, var_1981);
            var_2000 = wp::extract(var_1686, var_1999);
            var_2001 = wp::mul(var_2000, var_1985);
            var_2002 = wp::add(var_1998, var_2001);
            var_2004 = wp::mul(var_1977, var_2003);
            var_2005 = wp::add(var_2004, var_1661);
            wp::assign_inplace(var_2, var_2005, var_2002);
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_2008 = wp::mul(var_2006, var_2007);
            var_2009 = wp::add(var_2008, var_1649);
            var_2010 = wp::extract(var_2, var_2009);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_2012 = wp::mul(var_2006, var_2011);
            var_2013 = wp::add(var_2012, var_1661);
            var_2014 = wp::extract(var_2, var_2013);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_2016 = wp::extract(var_1686, var_2015);
            var_2017 = wp::mul(var_2016, var_2010);
            var_2019 = wp::extract(var_1686, var_2018);
            var_2020 = wp::mul(var_2019, var_2014);
            var_2021 = wp::sub(var_2017, var_2020);
            var_2023 = wp::mul(var_2006, var_2022);
            var_2024 = wp::add(var_2023, var_1649);
            wp::assign_inplace(var_2, var_2024, var_2021);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_2026 = wp::extract(var_1686, var_2025);
            var_2027 = wp::mul(var_2026, var_2010);
            var_2029 = wp::extract(var_1686, var_2028);
            var_2030 = wp::mul(var_2029, var_2014);
            var_2031 = wp::add(var_2027, var_2030);
            var_2033 = wp::mul(var_2006, var_2032);
            var_2034 = wp::add(var_2033, var_1661);
            wp::assign_inplace(var_2, var_2034, var_2031);
        }
        var_2035 = wp::where(var_1674, var_1685, var_1631);
        var_2036 = wp::where(var_1674, var_1686, var_1632);
        var_2037 = wp::where(var_1674, var_2006, var_1633);
        var_2038 = wp::where(var_1674, var_1778, var_1634);
        var_2039 = wp::where(var_1674, var_1782, var_1635);
        var_2040 = wp::where(var_1674, var_1894, var_1636);
        var_2041 = wp::where(var_1674, var_1898, var_1637);
        var_2042 = wp::where(var_1674, var_2010, var_1638);
        var_2043 = wp::where(var_1674, var_2014, var_1639);
        // p = 0 if pair < 3 else 1 if pair < 5 else 2                                        <L 13>
        var_2046 = (var_2044 < var_2045);
        if (var_2046) {
        }
        if (!var_2046) {
            var_2049 = (var_2044 < var_2048);
            if (var_2049) {
            }
            if (!var_2049) {
            }
            var_2052 = wp::where(var_2049, var_2050, var_2051);
        }
        var_2053 = wp::where(var_2046, var_2047, var_2052);
        // q = pair + 1 - (0 if pair < 3 else 2 if pair < 5 else 3)                           <L 14>
        var_2055 = wp::add(var_2044, var_2054);
        var_2057 = (var_2044 < var_2056);
        if (var_2057) {
        }
        if (!var_2057) {
            var_2060 = (var_2044 < var_2059);
            if (var_2060) {
            }
            if (!var_2060) {
            }
            var_2063 = wp::where(var_2060, var_2061, var_2062);
        }
        var_2064 = wp::where(var_2057, var_2058, var_2063);
        var_2065 = wp::sub(var_2055, var_2064);
        // apq = a[p * 4 + q]                                                                 <L 15>
        var_2067 = wp::mul(var_2053, var_2066);
        var_2068 = wp::add(var_2067, var_2065);
        var_2069 = wp::extract(var_0, var_2068);
        // app = a[p * 4 + p]                                                                 <L 16>
        var_2071 = wp::mul(var_2053, var_2070);
        var_2072 = wp::add(var_2071, var_2053);
        var_2073 = wp::extract(var_0, var_2072);
        // aqq = a[q * 4 + q]                                                                 <L 17>
        var_2075 = wp::mul(var_2065, var_2074);
        var_2076 = wp::add(var_2075, var_2065);
        var_2077 = wp::extract(var_0, var_2076);
        // if abs(apq) > float64(1e-300) and abs(apq) > float64(1e-18) * sqrt(abs(app * aqq)):       <L 18>
        var_2079 = wp::abs(var_2069);
        var_2080 = 1e-300;
        var_2081 = (var_2079 > var_2080);
        var_2078 = var_2081;
        if (var_2078) {
            var_2082 = wp::abs(var_2069);
            var_2083 = 1e-18;
            var_2084 = wp::mul(var_2073, var_2077);
            var_2085 = wp::abs(var_2084);
            var_2086 = wp::sqrt(var_2085);
            var_2087 = wp::mul(var_2083, var_2086);
            var_2088 = (var_2082 > var_2087);
            var_2078 = var_2078 && var_2088;
        }
        if (var_2078) {
            // rotated = 1                                                                    <L 19>
            // cs = jacobi_rotation(app, aqq, apq)                                            <L 20>
            var_2090 = jacobi_rotation_0(var_2073, var_2077, var_2069);
            // for k in range(4):                                                             <L 21>
            // akp = a[k * 4 + p]                                                             <L 22>
            var_2093 = wp::mul(var_2091, var_2092);
            var_2094 = wp::add(var_2093, var_2053);
            var_2095 = wp::extract(var_0, var_2094);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_2097 = wp::mul(var_2091, var_2096);
            var_2098 = wp::add(var_2097, var_2065);
            var_2099 = wp::extract(var_0, var_2098);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_2101 = wp::extract(var_2090, var_2100);
            var_2102 = wp::mul(var_2101, var_2095);
            var_2104 = wp::extract(var_2090, var_2103);
            var_2105 = wp::mul(var_2104, var_2099);
            var_2106 = wp::sub(var_2102, var_2105);
            var_2108 = wp::mul(var_2091, var_2107);
            var_2109 = wp::add(var_2108, var_2053);
            wp::assign_inplace(var_0, var_2109, var_2106);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_2111 = wp::extract(var_2090, var_2110);
            var_2112 = wp::mul(var_2111, var_2095);
            var_2114 = wp::extract(var_2090, var_2113);
            var_2115 = wp::mul(var_2114, var_2099);
            var_2116 = wp::add(var_2112, var_2115);
            var_2118 = wp::mul(var_2091, var_2117);
            var_2119 = wp::add(var_2118, var_2065);
            wp::assign_inplace(var_0, var_2119, var_2116);
            // akp = a[k * 4 + p]                                                             <L 22>
            var_2122 = wp::mul(var_2120, var_2121);
            var_2123 = wp::add(var_2122, var_2053);
            var_2124 = wp::extract(var_0, var_2123);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_2126 = wp::mul(var_2120, var_2125);
            var_2127 = wp::add(var_2126, var_2065);
            var_2128 = wp::extract(var_0, var_2127);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_2130 = wp::extract(var_2090, var_2129);
            var_2131 = wp::mul(var_2130, var_2124);
            var_2133 = wp::extract(var_2090, var_2132);
            var_2134 = wp::mul(var_2133, var_2128);
            var_2135 = wp::sub(var_2131, var_2134);
            var_2137 = wp::mul(var_2120, var_2136);
            var_2138 = wp::add(var_2137, var_2053);
            wp::assign_inplace(var_0, var_2138, var_2135);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_2140 = wp::extract(var_2090, var_2139);
            var_2141 = wp::mul(var_2140, var_2124);
            var_2143 = wp::extract(var_2090, var_2142);
            var_2144 = wp::mul(var_2143, var_2128);
            var_2145 = wp::add(var_2141, var_2144);
            var_2147 = wp::mul(var_2120, var_2146);
            var_2148 = wp::add(var_2147, var_2065);
            wp::assign_inplace(var_0, var_2148, var_2145);
            // akp = a[k * 4 + p]                                                             <L 22>
            var_2151 = wp::mul(var_2149, var_2150);
            var_2152 = wp::add(var_2151, var_2053);
            var_2153 = wp::extract(var_0, var_2152);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_2155 = wp::mul(var_2149, var_2154);
            var_2156 = wp::add(var_2155, var_2065);
            var_2157 = wp::extract(var_0, var_2156);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_2159 = wp::extract(var_2090, var_2158);
            var_2160 = wp::mul(var_2159, var_2153);
            var_2162 = wp::extract(var_2090, var_2161);
            var_2163 = wp::mul(var_2162, var_2157);
            var_2164 = wp::sub(var_2160, var_2163);
            var_2166 = wp::mul(var_2149, var_2165);
            var_2167 = wp::add(var_2166, var_2053);
            wp::assign_inplace(var_0, var_2167, var_2164);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_2169 = wp::extract(var_2090, var_2168);
            var_2170 = wp::mul(var_2169, var_2153);
            var_2172 = wp::extract(var_2090, var_2171);
            var_2173 = wp::mul(var_2172, var_2157);
            var_2174 = wp::add(var_2170, var_2173);
            var_2176 = wp::mul(var_2149, var_2175);
            var_2177 = wp::add(var_2176, var_2065);
            wp::assign_inplace(var_0, var_2177, var_2174);
            // akp = a[k * 4 + p]                                                             <L 22>
            var_2180 = wp::mul(var_2178, var_2179);
            var_2181 = wp::add(var_2180, var_2053);
            var_2182 = wp::extract(var_0, var_2181);
            // akq = a[k * 4 + q]                                                             <L 23>
            var_2184 = wp::mul(var_2178, var_2183);
            var_2185 = wp::add(var_2184, var_2065);
            var_2186 = wp::extract(var_0, var_2185);
            // a[k * 4 + p] = cs[0] * akp - cs[1] * akq                                       <L 24>
            var_2188 = wp::extract(var_2090, var_2187);
            var_2189 = wp::mul(var_2188, var_2182);
            var_2191 = wp::extract(var_2090, var_2190);
            var_2192 = wp::mul(var_2191, var_2186);
            var_2193 = wp::sub(var_2189, var_2192);
            var_2195 = wp::mul(var_2178, var_2194);
            var_2196 = wp::add(var_2195, var_2053);
            wp::assign_inplace(var_0, var_2196, var_2193);
            // a[k * 4 + q] = cs[1] * akp + cs[0] * akq                                       <L 25>
            var_2198 = wp::extract(var_2090, var_2197);
            var_2199 = wp::mul(var_2198, var_2182);
            var_2201 = wp::extract(var_2090, var_2200);
            var_2202 = wp::mul(var_2201, var_2186);
            var_2203 = wp::add(var_2199, var_2202);
            var_2205 = wp::mul(var_2178, var_2204);
            var_2206 = wp::add(var_2205, var_2065);
            wp::assign_inplace(var_0, var_2206, var_2203);
            // for k in range(4):                                                             <L 26>
            // apk = a[p * 4 + k]                                                             <L 27>
            var_2209 = wp::mul(var_2053, var_2208);
            var_2210 = wp::add(var_2209, var_2207);
            var_2211 = wp::extract(var_0, var_2210);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_2213 = wp::mul(var_2065, var_2212);
            var_2214 = wp::add(var_2213, var_2207);
            var_2215 = wp::extract(var_0, var_2214);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_2217 = wp::extract(var_2090, var_2216);
            var_2218 = wp::mul(var_2217, var_2211);
            var_2220 = wp::extract(var_2090, var_2219);
            var_2221 = wp::mul(var_2220, var_2215);
            var_2222 = wp::sub(var_2218, var_2221);
            var_2224 = wp::mul(var_2053, var_2223);
            var_2225 = wp::add(var_2224, var_2207);
            wp::assign_inplace(var_0, var_2225, var_2222);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_2227 = wp::extract(var_2090, var_2226);
            var_2228 = wp::mul(var_2227, var_2211);
            var_2230 = wp::extract(var_2090, var_2229);
            var_2231 = wp::mul(var_2230, var_2215);
            var_2232 = wp::add(var_2228, var_2231);
            var_2234 = wp::mul(var_2065, var_2233);
            var_2235 = wp::add(var_2234, var_2207);
            wp::assign_inplace(var_0, var_2235, var_2232);
            // apk = a[p * 4 + k]                                                             <L 27>
            var_2238 = wp::mul(var_2053, var_2237);
            var_2239 = wp::add(var_2238, var_2236);
            var_2240 = wp::extract(var_0, var_2239);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_2242 = wp::mul(var_2065, var_2241);
            var_2243 = wp::add(var_2242, var_2236);
            var_2244 = wp::extract(var_0, var_2243);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_2246 = wp::extract(var_2090, var_2245);
            var_2247 = wp::mul(var_2246, var_2240);
            var_2249 = wp::extract(var_2090, var_2248);
            var_2250 = wp::mul(var_2249, var_2244);
            var_2251 = wp::sub(var_2247, var_2250);
            var_2253 = wp::mul(var_2053, var_2252);
            var_2254 = wp::add(var_2253, var_2236);
            wp::assign_inplace(var_0, var_2254, var_2251);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_2256 = wp::extract(var_2090, var_2255);
            var_2257 = wp::mul(var_2256, var_2240);
            var_2259 = wp::extract(var_2090, var_2258);
            var_2260 = wp::mul(var_2259, var_2244);
            var_2261 = wp::add(var_2257, var_2260);
            var_2263 = wp::mul(var_2065, var_2262);
            var_2264 = wp::add(var_2263, var_2236);
            wp::assign_inplace(var_0, var_2264, var_2261);
            // apk = a[p * 4 + k]                                                             <L 27>
            var_2267 = wp::mul(var_2053, var_2266);
            var_2268 = wp::add(var_2267, var_2265);
            var_2269 = wp::extract(var_0, var_2268);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_2271 = wp::mul(var_2065, var_2270);
            var_2272 = wp::add(var_2271, var_2265);
            var_2273 = wp::extract(var_0, var_2272);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_2275 = wp::extract(var_2090, var_2274);
            var_2276 = wp::mul(var_2275, var_2269);
            var_2278 = wp::extract(var_2090, var_2277);
            var_2279 = wp::mul(var_2278, var_2273);
            var_2280 = wp::sub(var_2276, var_2279);
            var_2282 = wp::mul(var_2053, var_2281);
            var_2283 = wp::add(var_2282, var_2265);
            wp::assign_inplace(var_0, var_2283, var_2280);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_2285 = wp::extract(var_2090, var_2284);
            var_2286 = wp::mul(var_2285, var_2269);
            var_2288 = wp::extract(var_2090, var_2287);
            var_2289 = wp::mul(var_2288, var_2273);
            var_2290 = wp::add(var_2286, var_2289);
            var_2292 = wp::mul(var_2065, var_2291);
            var_2293 = wp::add(var_2292, var_2265);
            wp::assign_inplace(var_0, var_2293, var_2290);
            // apk = a[p * 4 + k]                                                             <L 27>
            var_2296 = wp::mul(var_2053, var_2295);
            var_2297 = wp::add(var_2296, var_2294);
            var_2298 = wp::extract(var_0, var_2297);
            // aqk = a[q * 4 + k]                                                             <L 28>
            var_2300 = wp::mul(var_2065, var_2299);
            var_2301 = wp::add(var_2300, var_2294);
            var_2302 = wp::extract(var_0, var_2301);
            // a[p * 4 + k] = cs[0] * apk - cs[1] * aqk                                       <L 29>
            var_2304 = wp::extract(var_2090, var_2303);
            var_2305 = wp::mul(var_2304, var_2298);
            var_2307 = wp::extract(var_2090, var_2306);
            var_2308 = wp::mul(var_2307, var_2302);
            var_2309 = wp::sub(var_2305, var_2308);
            var_2311 = wp::mul(var_2053, var_2310);
            var_2312 = wp::add(var_2311, var_2294);
            wp::assign_inplace(var_0, var_2312, var_2309);
            // a[q * 4 + k] = cs[1] * apk + cs[0] * aqk                                       <L 30>
            var_2314 = wp::extract(var_2090, var_2313);
            var_2315 = wp::mul(var_2314, var_2298);
            var_2317 = wp::extract(var_2090, var_2316);
            var_2318 = wp::mul(var_2317, var_2302);
            var_2319 = wp::add(var_2315, var_2318);
            var_2321 = wp::mul(var_2065, var_2320);
            var_2322 = wp::add(var_2321, var_2294);
            wp::assign_inplace(var_0, var_2322, var_2319);
            // for k in range(4):                                                             <L 31>
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_2325 = wp::mul(var_2323, var_2324);
            var_2326 = wp::add(var_2325, var_2053);
            var_2327 = wp::extract(var_2, var_2326);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_2329 = wp::mul(var_2323, var_2328);
            var_2330 = wp::add(var_2329, var_2065);
            var_2331 = wp::extract(var_2, var_2330);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_2333 = wp::extract(var_2090, var_2332);
            var_2334 = wp::mul(var_2333, var_2327);
            var_2336 = wp::extract(var_2090, var_2335);
            var_2337 = wp::mul(var_2336, var_2331);
            var_2338 = wp::sub(var_2334, var_2337);
            var_2340 = wp::mul(var_2323, var_2339);
            var_2341 = wp::add(var_2340, var_2053);
            wp::assign_inplace(var_2, var_2341, var_2338);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_2343 = wp::extract(var_2090, var_2342);
            var_2344 = wp::mul(var_2343, var_2327);
            var_2346 = wp::extract(var_2090, var_2345);
            var_2347 = wp::mul(var_2346, var_2331);
            var_2348 = wp::add(var_2344, var_2347);
            var_2350 = wp::mul(var_2323, var_2349);
            var_2351 = wp::add(var_2350, var_2065);
            wp::assign_inplace(var_2, var_2351, var_2348);
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_2354 = wp::mul(var_2352, var_2353);
            var_2355 = wp::add(var_2354, var_2053);
            var_2356 = wp::extract(var_2, var_2355);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_2358 = wp::mul(var_2352, var_2357);
            var_2359 = wp::add(var_2358, var_2065);
            var_2360 = wp::extract(var_2, var_2359);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_2362 = wp::extract(var_2090, var_2361);
            var_2363 = wp::mul(var_2362, var_2356);
            var_2365 = wp::extract(var_2090, var_2364);
            var_2366 = wp::mul(var_2365, var_2360);
            var_2367 = wp::sub(var_2363, var_2366);
            var_2369 = wp::mul(var_2352, var_2368);
            var_2370 = wp::add(var_2369, var_2053);
            wp::assign_inplace(var_2, var_2370, var_2367);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_2372 = wp::extract(var_2090, var_2371);
            var_2373 = wp::mul(var_2372, var_2356);
            var_2375 = wp::extract(var_2090, var_2374);
            var_2376 = wp::mul(var_2375, var_2360);
            var_2377 = wp::add(var_2373, var_2376);
            var_2379 = wp::mul(var_2352, var_2378);
            var_2380 = wp::add(var_2379, var_2065);
            wp::assign_inplace(var_2, var_2380, var_2377);
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_2383 = wp::mul(var_2381, var_2382);
            var_2384 = wp::add(var_2383, var_2053);
            var_2385 = wp::extract(var_2, var_2384);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_2387 = wp::mul(var_2381, var_2386);
            var_2388 = wp::add(var_2387, var_2065);
            var_2389 = wp::extract(var_2, var_2388);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_2391 = wp::extract(var_2090, var_2390);
            var_2392 = wp::mul(var_2391, var_2385);
            var_2394 = wp::extract(var_2090, var_2393);
            var_2395 = wp::mul(var_2394, var_2389);
            var_2396 = wp::sub(var_2392, var_2395);
            var_2398 = wp::mul(var_2381, var_2397);
            var_2399 = wp::add(var_2398, var_2053);
            wp::assign_inplace(var_2, var_2399, var_2396);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_2401 = wp::extract(var_2090, var_2400);
            var_2402 = wp::mul(var_2401, var_2385);
            var_2404 = wp::extract(var_2090, var_2403);
            var_2405 = wp::mul(var_2404, var_2389);
            var_2406 = wp::add(var_2402, var_2405);
            var_2408 = wp::mul(var_2381, var_2407);
            var_2409 = wp::add(var_2408, var_2065);
            wp::assign_inplace(var_2, var_2409, var_2406);
            // vkp = v[k * 4 + p]                                                             <L 32>
            var_2412 = wp::mul(var_2410, var_2411);
            var_2413 = wp::add(var_2412, var_2053);
            var_2414 = wp::extract(var_2, var_2413);
            // vkq = v[k * 4 + q]                                                             <L 33>
            var_2416 = wp::mul(var_2410, var_2415);
            var_2417 = wp::add(var_2416, var_2065);
            var_2418 = wp::extract(var_2, var_2417);
            // v[k * 4 + p] = cs[0] * vkp - cs[1] * vkq                                       <L 34>
            var_2420 = wp::extract(var_2090, var_2419);
            var_2421 = wp::mul(var_2420, var_2414);
            var_2423 = wp::extract(var_2090, var_2422);
            var_2424 = wp::mul(var_2423, var_2418);
            var_2425 = wp::sub(var_2421, var_2424);
            var_2427 = wp::mul(var_2410, var_2426);
            var_2428 = wp::add(var_2427, var_2053);
            wp::assign_inplace(var_2, var_2428, var_2425);
            // v[k * 4 + q] = cs[1] * vkp + cs[0] * vkq                                       <L 35>
            var_2430 = wp::extract(var_2090, var_2429);
            var_2431 = wp::mul(var_2430, var_2414);
            var_2433 = wp::extract(var_2090, var_2432);
            var_2434 = wp::mul(var_2433, var_2418);
            var_2435 = wp::add(var_2431, var_2434);
            var_2437 = wp::mul(var_2410, var_2436);
            var_2438 = wp::add(var_2437, var_2065);
            wp::assign_inplace(var_2, var_2438, var_2435);
        }
        var_2439 = wp::where(var_2078, var_2089, var_2035);
        var_2440 = wp::where(var_2078, var_2090, var_2036);
        var_2441 = wp::where(var_2078, var_2410, var_2037);
        var_2442 = wp::where(var_2078, var_2182, var_2038);
        var_2443 = wp::where(var_2078, var_2186, var_2039);
        var_2444 = wp::where(var_2078, var_2298, var_2040);
        var_2445 = wp::where(var_2078, var_2302, var_2041);
        var_2446 = wp::where(var_2078, var_2414, var_2042);
        var_2447 = wp::where(var_2078, var_2418, var_2043);
        wp::assign(var_20, var_2439);
        wp::assign(var_22, var_31);
    goto start_while_0;
    end_while_0:;
    // system = four_system(float64(0.0))                                                     <L 36>
    var_2448 = 0.0;
    var_2449 = wp::vec_t<20, wp::float64>(var_2448);
    // for i in range(16):                                                                    <L 37>
    // system[i] = v[i]                                                                       <L 38>
    var_2451 = wp::extract(var_2, var_2450);
    wp::assign_inplace(var_2449, var_2450, var_2451);
    var_2453 = wp::extract(var_2, var_2452);
    wp::assign_inplace(var_2449, var_2452, var_2453);
    var_2455 = wp::extract(var_2, var_2454);
    wp::assign_inplace(var_2449, var_2454, var_2455);
    var_2457 = wp::extract(var_2, var_2456);
    wp::assign_inplace(var_2449, var_2456, var_2457);
    var_2459 = wp::extract(var_2, var_2458);
    wp::assign_inplace(var_2449, var_2458, var_2459);
    var_2461 = wp::extract(var_2, var_2460);
    wp::assign_inplace(var_2449, var_2460, var_2461);
    var_2463 = wp::extract(var_2, var_2462);
    wp::assign_inplace(var_2449, var_2462, var_2463);
    var_2465 = wp::extract(var_2, var_2464);
    wp::assign_inplace(var_2449, var_2464, var_2465);
    var_2467 = wp::extract(var_2, var_2466);
    wp::assign_inplace(var_2449, var_2466, var_2467);
    var_2469 = wp::extract(var_2, var_2468);
    wp::assign_inplace(var_2449, var_2468, var_2469);
    var_2471 = wp::extract(var_2, var_2470);
    wp::assign_inplace(var_2449, var_2470, var_2471);
    var_2473 = wp::extract(var_2, var_2472);
    wp::assign_inplace(var_2449, var_2472, var_2473);
    var_2475 = wp::extract(var_2, var_2474);
    wp::assign_inplace(var_2449, var_2474, var_2475);
    var_2477 = wp::extract(var_2, var_2476);
    wp::assign_inplace(var_2449, var_2476, var_2477);
    var_2479 = wp::extract(var_2, var_2478);
    wp::assign_inplace(var_2449, var_2478, var_2479);
    var_2481 = wp::extract(var_2, var_2480);
    wp::assign_inplace(var_2449, var_2480, var_2481);
    // for i in range(4):                                                                     <L 39>
    // system[16 + i] = a[i * 5]                                                              <L 40>
    var_2484 = wp::mul(var_2482, var_2483);
    var_2485 = wp::extract(var_0, var_2484);
    var_2487 = wp::add(var_2486, var_2482);
    wp::assign_inplace(var_2449, var_2487, var_2485);
    var_2490 = wp::mul(var_2488, var_2489);
    var_2491 = wp::extract(var_0, var_2490);
    var_2493 = wp::add(var_2492, var_2488);
    wp::assign_inplace(var_2449, var_2493, var_2491);
    var_2496 = wp::mul(var_2494, var_2495);
    var_2497 = wp::extract(var_0, var_2496);
    var_2499 = wp::add(var_2498, var_2494);
    wp::assign_inplace(var_2449, var_2499, var_2497);
    var_2502 = wp::mul(var_2500, var_2501);
    var_2503 = wp::extract(var_0, var_2502);
    var_2505 = wp::add(var_2504, var_2500);
    wp::assign_inplace(var_2449, var_2505, var_2503);
    // return system                                                                          <L 41>
    return var_2449;
}


// /work/main/src/pointloom/kernels/algebra/rigid_solve.py:134
static CUDA_CALLABLE wp::vec_t<4, wp::float64> largest_of_four_0(
    wp::vec_t<20, wp::float64> var_system)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 16;
    wp::float64 var_1;
    const wp::int32 var_2 = 0;
    wp::float64 var_3;
    const wp::int32 var_4 = 4;
    wp::float64 var_5;
    const wp::int32 var_6 = 8;
    wp::float64 var_7;
    const wp::int32 var_8 = 12;
    wp::float64 var_9;
    wp::vec_t<4, wp::float64> var_10;
    const wp::int32 var_11 = 1;
    const wp::int32 var_12 = 16;
    wp::int32 var_13;
    wp::float64 var_14;
    bool var_15;
    const wp::int32 var_16 = 16;
    wp::int32 var_17;
    wp::float64 var_18;
    wp::float64 var_19;
    const wp::int32 var_20 = 4;
    wp::int32 var_21;
    wp::float64 var_22;
    const wp::int32 var_23 = 8;
    wp::int32 var_24;
    wp::float64 var_25;
    const wp::int32 var_26 = 12;
    wp::int32 var_27;
    wp::float64 var_28;
    wp::vec_t<4, wp::float64> var_29;
    wp::float64 var_30;
    wp::vec_t<4, wp::float64> var_31;
    const wp::int32 var_32 = 2;
    const wp::int32 var_33 = 16;
    wp::int32 var_34;
    wp::float64 var_35;
    bool var_36;
    const wp::int32 var_37 = 16;
    wp::int32 var_38;
    wp::float64 var_39;
    wp::float64 var_40;
    const wp::int32 var_41 = 4;
    wp::int32 var_42;
    wp::float64 var_43;
    const wp::int32 var_44 = 8;
    wp::int32 var_45;
    wp::float64 var_46;
    const wp::int32 var_47 = 12;
    wp::int32 var_48;
    wp::float64 var_49;
    wp::vec_t<4, wp::float64> var_50;
    wp::float64 var_51;
    wp::vec_t<4, wp::float64> var_52;
    const wp::int32 var_53 = 3;
    const wp::int32 var_54 = 16;
    wp::int32 var_55;
    wp::float64 var_56;
    bool var_57;
    const wp::int32 var_58 = 16;
    wp::int32 var_59;
    wp::float64 var_60;
    wp::float64 var_61;
    const wp::int32 var_62 = 4;
    wp::int32 var_63;
    wp::float64 var_64;
    const wp::int32 var_65 = 8;
    wp::int32 var_66;
    wp::float64 var_67;
    const wp::int32 var_68 = 12;
    wp::int32 var_69;
    wp::float64 var_70;
    wp::vec_t<4, wp::float64> var_71;
    wp::float64 var_72;
    wp::vec_t<4, wp::float64> var_73;
    //---------
    // forward
    // def largest_of_four(system: four_system) -> vec4d:                                     <L 135>
    // largest = system[16]                                                                   <L 137>
    var_1 = wp::extract(var_system, var_0);
    // eigenvector = vec4d(system[0], system[4], system[8], system[12])                       <L 138>
    var_3 = wp::extract(var_system, var_2);
    var_5 = wp::extract(var_system, var_4);
    var_7 = wp::extract(var_system, var_6);
    var_9 = wp::extract(var_system, var_8);
    var_10 = wp::vec_t<4, wp::float64>(var_3, var_5, var_7, var_9);
    // for k in range(1, 4):                                                                  <L 139>
    // if system[16 + k] > largest:                                                           <L 140>
    var_13 = wp::add(var_12, var_11);
    var_14 = wp::extract(var_system, var_13);
    var_15 = (var_14 > var_1);
    if (var_15) {
        // largest = system[16 + k]                                                           <L 141>
        var_17 = wp::add(var_16, var_11);
        var_18 = wp::extract(var_system, var_17);
        // eigenvector = vec4d(system[k], system[4 + k], system[8 + k], system[12 + k])       <L 142>
        var_19 = wp::extract(var_system, var_11);
        var_21 = wp::add(var_20, var_11);
        var_22 = wp::extract(var_system, var_21);
        var_24 = wp::add(var_23, var_11);
        var_25 = wp::extract(var_system, var_24);
        var_27 = wp::add(var_26, var_11);
        var_28 = wp::extract(var_system, var_27);
        var_29 = wp::vec_t<4, wp::float64>(var_19, var_22, var_25, var_28);
    }
    var_30 = wp::where(var_15, var_18, var_1);
    var_31 = wp::where(var_15, var_29, var_10);
    // if system[16 + k] > largest:                                                           <L 140>
    var_34 = wp::add(var_33, var_32);
    var_35 = wp::extract(var_system, var_34);
    var_36 = (var_35 > var_30);
    if (var_36) {
        // largest = system[16 + k]                                                           <L 141>
        var_38 = wp::add(var_37, var_32);
        var_39 = wp::extract(var_system, var_38);
        // eigenvector = vec4d(system[k], system[4 + k], system[8 + k], system[12 + k])       <L 142>
        var_40 = wp::extract(var_system, var_32);
        var_42 = wp::add(var_41, var_32);
        var_43 = wp::extract(var_system, var_42);
        var_45 = wp::add(var_44, var_32);
        var_46 = wp::extract(var_system, var_45);
        var_48 = wp::add(var_47, var_32);
        var_49 = wp::extract(var_system, var_48);
        var_50 = wp::vec_t<4, wp::float64>(var_40, var_43, var_46, var_49);
    }
    var_51 = wp::where(var_36, var_39, var_30);
    var_52 = wp::where(var_36, var_50, var_31);
    // if system[16 + k] > largest:                                                           <L 140>
    var_55 = wp::add(var_54, var_53);
    var_56 = wp::extract(var_system, var_55);
    var_57 = (var_56 > var_51);
    if (var_57) {
        // largest = system[16 + k]                                                           <L 141>
        var_59 = wp::add(var_58, var_53);
        var_60 = wp::extract(var_system, var_59);
        // eigenvector = vec4d(system[k], system[4 + k], system[8 + k], system[12 + k])       <L 142>
        var_61 = wp::extract(var_system, var_53);
        var_63 = wp::add(var_62, var_53);
        var_64 = wp::extract(var_system, var_63);
        var_66 = wp::add(var_65, var_53);
        var_67 = wp::extract(var_system, var_66);
        var_69 = wp::add(var_68, var_53);
        var_70 = wp::extract(var_system, var_69);
        var_71 = wp::vec_t<4, wp::float64>(var_61, var_64, var_67, var_70);
    }
    var_72 = wp::where(var_57, var_60, var_51);
    var_73 = wp::where(var_57, var_71, var_52);
    // return eigenvector                                                                     <L 143>
    return var_73;
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


// <pointloom.kernels.algebra.rigid_solve.fit_pose>:1
static CUDA_CALLABLE wp::mat_t<4, 4, wp::float64> fit_pose_0(
    wp::vec_t<18, wp::float64> var_sums,
    wp::int32 var_with_scaling)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
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
    wp::mat_t<4, 4, wp::float64> var_18;
    wp::float64 var_19;
    bool var_20;
    const wp::int32 var_21 = 1;
    wp::float64 var_22;
    wp::float64 var_23;
    const wp::int32 var_24 = 2;
    wp::float64 var_25;
    wp::float64 var_26;
    const wp::int32 var_27 = 3;
    wp::float64 var_28;
    wp::float64 var_29;
    const wp::int32 var_30 = 4;
    wp::float64 var_31;
    wp::float64 var_32;
    const wp::int32 var_33 = 5;
    wp::float64 var_34;
    wp::float64 var_35;
    const wp::int32 var_36 = 6;
    wp::float64 var_37;
    wp::float64 var_38;
    const wp::int32 var_39 = 7;
    wp::float64 var_40;
    wp::float64 var_41;
    wp::float64 var_42;
    wp::float64 var_43;
    const wp::int32 var_44 = 8;
    wp::float64 var_45;
    wp::float64 var_46;
    wp::float64 var_47;
    wp::float64 var_48;
    const wp::int32 var_49 = 9;
    wp::float64 var_50;
    wp::float64 var_51;
    wp::float64 var_52;
    wp::float64 var_53;
    const wp::int32 var_54 = 10;
    wp::float64 var_55;
    wp::float64 var_56;
    wp::float64 var_57;
    wp::float64 var_58;
    const wp::int32 var_59 = 11;
    wp::float64 var_60;
    wp::float64 var_61;
    wp::float64 var_62;
    wp::float64 var_63;
    const wp::int32 var_64 = 12;
    wp::float64 var_65;
    wp::float64 var_66;
    wp::float64 var_67;
    wp::float64 var_68;
    const wp::int32 var_69 = 13;
    wp::float64 var_70;
    wp::float64 var_71;
    wp::float64 var_72;
    wp::float64 var_73;
    const wp::int32 var_74 = 14;
    wp::float64 var_75;
    wp::float64 var_76;
    wp::float64 var_77;
    wp::float64 var_78;
    const wp::int32 var_79 = 15;
    wp::float64 var_80;
    wp::float64 var_81;
    wp::float64 var_82;
    wp::float64 var_83;
    const wp::int32 var_84 = 16;
    wp::float64 var_85;
    wp::float64 var_86;
    wp::float64 var_87;
    wp::float64 var_88;
    wp::float64 var_89;
    wp::float64 var_90;
    wp::float64 var_91;
    wp::float64 var_92;
    const wp::int32 var_93 = 17;
    wp::float64 var_94;
    wp::float64 var_95;
    wp::float64 var_96;
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
    wp::float64 var_125;
    wp::float64 var_126;
    wp::float64 var_127;
    wp::vec_t<16, wp::float64> var_128;
    wp::vec_t<20, wp::float64> var_129;
    wp::vec_t<4, wp::float64> var_130;
    const wp::int32 var_131 = 1;
    wp::float64 var_132;
    const wp::int32 var_133 = 2;
    wp::float64 var_134;
    const wp::int32 var_135 = 3;
    wp::float64 var_136;
    const wp::int32 var_137 = 0;
    wp::float64 var_138;
    wp::mat_t<4, 4, wp::float64> var_139;
    wp::float64 var_140;
    bool var_141;
    const wp::int32 var_142 = 1;
    bool var_143;
    wp::float64 var_144;
    bool var_145;
    const wp::int32 var_146 = 0;
    const wp::int32 var_147 = 0;
    wp::float64 var_148;
    wp::float64 var_149;
    const wp::int32 var_150 = 0;
    const wp::int32 var_151 = 1;
    wp::float64 var_152;
    wp::float64 var_153;
    wp::float64 var_154;
    const wp::int32 var_155 = 0;
    const wp::int32 var_156 = 2;
    wp::float64 var_157;
    wp::float64 var_158;
    wp::float64 var_159;
    const wp::int32 var_160 = 1;
    const wp::int32 var_161 = 0;
    wp::float64 var_162;
    wp::float64 var_163;
    const wp::int32 var_164 = 1;
    const wp::int32 var_165 = 1;
    wp::float64 var_166;
    wp::float64 var_167;
    wp::float64 var_168;
    const wp::int32 var_169 = 1;
    const wp::int32 var_170 = 2;
    wp::float64 var_171;
    wp::float64 var_172;
    wp::float64 var_173;
    wp::float64 var_174;
    const wp::int32 var_175 = 2;
    const wp::int32 var_176 = 0;
    wp::float64 var_177;
    wp::float64 var_178;
    const wp::int32 var_179 = 2;
    const wp::int32 var_180 = 1;
    wp::float64 var_181;
    wp::float64 var_182;
    wp::float64 var_183;
    const wp::int32 var_184 = 2;
    const wp::int32 var_185 = 2;
    wp::float64 var_186;
    wp::float64 var_187;
    wp::float64 var_188;
    wp::float64 var_189;
    wp::float64 var_190;
    bool var_191;
    wp::float64 var_192;
    wp::float64 var_193;
    wp::float64 var_194;
    const wp::int32 var_195 = 0;
    const wp::int32 var_196 = 0;
    wp::float64 var_197;
    wp::float64 var_198;
    const wp::int32 var_199 = 1;
    wp::float64 var_200;
    wp::float64 var_201;
    const wp::int32 var_202 = 2;
    wp::float64 var_203;
    wp::float64 var_204;
    const wp::int32 var_205 = 0;
    wp::float64 var_206;
    wp::float64 var_207;
    const wp::int32 var_208 = 1;
    wp::float64 var_209;
    wp::float64 var_210;
    wp::float64 var_211;
    const wp::int32 var_212 = 2;
    wp::float64 var_213;
    wp::float64 var_214;
    wp::float64 var_215;
    wp::float64 var_216;
    const wp::int32 var_217 = 3;
    const wp::int32 var_218 = 1;
    const wp::int32 var_219 = 0;
    wp::float64 var_220;
    wp::float64 var_221;
    const wp::int32 var_222 = 1;
    wp::float64 var_223;
    wp::float64 var_224;
    const wp::int32 var_225 = 2;
    wp::float64 var_226;
    wp::float64 var_227;
    const wp::int32 var_228 = 0;
    wp::float64 var_229;
    wp::float64 var_230;
    const wp::int32 var_231 = 1;
    wp::float64 var_232;
    wp::float64 var_233;
    wp::float64 var_234;
    const wp::int32 var_235 = 2;
    wp::float64 var_236;
    wp::float64 var_237;
    wp::float64 var_238;
    wp::float64 var_239;
    const wp::int32 var_240 = 3;
    const wp::int32 var_241 = 2;
    const wp::int32 var_242 = 0;
    wp::float64 var_243;
    wp::float64 var_244;
    const wp::int32 var_245 = 1;
    wp::float64 var_246;
    wp::float64 var_247;
    const wp::int32 var_248 = 2;
    wp::float64 var_249;
    wp::float64 var_250;
    const wp::int32 var_251 = 0;
    wp::float64 var_252;
    wp::float64 var_253;
    const wp::int32 var_254 = 1;
    wp::float64 var_255;
    wp::float64 var_256;
    wp::float64 var_257;
    const wp::int32 var_258 = 2;
    wp::float64 var_259;
    wp::float64 var_260;
    wp::float64 var_261;
    wp::float64 var_262;
    const wp::int32 var_263 = 3;
    const wp::int32 var_264 = 0;
    const wp::int32 var_265 = 3;
    wp::float64 var_266;
    wp::float64 var_267;
    const wp::int32 var_268 = 0;
    const wp::int32 var_269 = 3;
    const wp::int32 var_270 = 1;
    const wp::int32 var_271 = 3;
    wp::float64 var_272;
    wp::float64 var_273;
    const wp::int32 var_274 = 1;
    const wp::int32 var_275 = 3;
    const wp::int32 var_276 = 2;
    const wp::int32 var_277 = 3;
    wp::float64 var_278;
    wp::float64 var_279;
    const wp::int32 var_280 = 2;
    const wp::int32 var_281 = 3;
    wp::mat_t<4, 4, wp::float64> var_282;
    //---------
    // forward
    // def fit_pose(sums, with_scaling):                                                      <L 1>
    // w = sums[0]                                                                            <L 3>
    var_1 = wp::extract(var_sums, var_0);
    // pose = mat44d(float64(1.0), float64(0.0), float64(0.0), float64(0.0), float64(0.0), float64(1.0), float64(0.0), float64(0.0), float64(0.0), float64(0.0), float64(1.0), float64(0.0), float64(0.0), float64(0.0), float64(0.0), float64(1.0))       <L 4>
    var_2 = 1.0;
    var_3 = 0.0;
    var_4 = 0.0;
    var_5 = 0.0;
    var_6 = 0.0;
    var_7 = 1.0;
    var_8 = 0.0;
    var_9 = 0.0;
    var_10 = 0.0;
    var_11 = 0.0;
    var_12 = 1.0;
    var_13 = 0.0;
    var_14 = 0.0;
    var_15 = 0.0;
    var_16 = 0.0;
    var_17 = 1.0;
    var_18 = wp::mat_t<4, 4, wp::float64>(var_2, var_3, var_4, var_5, var_6, var_7, var_8, var_9, var_10, var_11, var_12, var_13, var_14, var_15, var_16, var_17);
    // if w > float64(0.0):                                                                   <L 5>
    var_19 = 0.0;
    var_20 = (var_1 > var_19);
    if (var_20) {
        // px = sums[1] / w                                                                   <L 6>
        var_22 = wp::extract(var_sums, var_21);
        var_23 = wp::div(var_22, var_1);
        // py = sums[2] / w                                                                   <L 7>
        var_25 = wp::extract(var_sums, var_24);
        var_26 = wp::div(var_25, var_1);
        // pz = sums[3] / w                                                                   <L 8>
        var_28 = wp::extract(var_sums, var_27);
        var_29 = wp::div(var_28, var_1);
        // qx = sums[4] / w                                                                   <L 9>
        var_31 = wp::extract(var_sums, var_30);
        var_32 = wp::div(var_31, var_1);
        // qy = sums[5] / w                                                                   <L 10>
        var_34 = wp::extract(var_sums, var_33);
        var_35 = wp::div(var_34, var_1);
        // qz = sums[6] / w                                                                   <L 11>
        var_37 = wp::extract(var_sums, var_36);
        var_38 = wp::div(var_37, var_1);
        // xx = sums[7] - w * px * qx                                                         <L 12>
        var_40 = wp::extract(var_sums, var_39);
        var_41 = wp::mul(var_1, var_23);
        var_42 = wp::mul(var_41, var_32);
        var_43 = wp::sub(var_40, var_42);
        // xy = sums[8] - w * px * qy                                                         <L 13>
        var_45 = wp::extract(var_sums, var_44);
        var_46 = wp::mul(var_1, var_23);
        var_47 = wp::mul(var_46, var_35);
        var_48 = wp::sub(var_45, var_47);
        // xz = sums[9] - w * px * qz                                                         <L 14>
        var_50 = wp::extract(var_sums, var_49);
        var_51 = wp::mul(var_1, var_23);
        var_52 = wp::mul(var_51, var_38);
        var_53 = wp::sub(var_50, var_52);
        // yx = sums[10] - w * py * qx                                                        <L 15>
        var_55 = wp::extract(var_sums, var_54);
        var_56 = wp::mul(var_1, var_26);
        var_57 = wp::mul(var_56, var_32);
        var_58 = wp::sub(var_55, var_57);
        // yy = sums[11] - w * py * qy                                                        <L 16>
        var_60 = wp::extract(var_sums, var_59);
        var_61 = wp::mul(var_1, var_26);
        var_62 = wp::mul(var_61, var_35);
        var_63 = wp::sub(var_60, var_62);
        // yz = sums[12] - w * py * qz                                                        <L 17>
        var_65 = wp::extract(var_sums, var_64);
        var_66 = wp::mul(var_1, var_26);
        var_67 = wp::mul(var_66, var_38);
        var_68 = wp::sub(var_65, var_67);
        // zx = sums[13] - w * pz * qx                                                        <L 18>
        var_70 = wp::extract(var_sums, var_69);
        var_71 = wp::mul(var_1, var_29);
        var_72 = wp::mul(var_71, var_32);
        var_73 = wp::sub(var_70, var_72);
        // zy = sums[14] - w * pz * qy                                                        <L 19>
        var_75 = wp::extract(var_sums, var_74);
        var_76 = wp::mul(var_1, var_29);
        var_77 = wp::mul(var_76, var_35);
        var_78 = wp::sub(var_75, var_77);
        // zz = sums[15] - w * pz * qz                                                        <L 20>
        var_80 = wp::extract(var_sums, var_79);
        var_81 = wp::mul(var_1, var_29);
        var_82 = wp::mul(var_81, var_38);
        var_83 = wp::sub(var_80, var_82);
        // spread = sums[16] - w * (px * px + py * py + pz * pz)                              <L 21>
        var_85 = wp::extract(var_sums, var_84);
        var_86 = wp::mul(var_23, var_23);
        var_87 = wp::mul(var_26, var_26);
        var_88 = wp::add(var_86, var_87);
        var_89 = wp::mul(var_29, var_29);
        var_90 = wp::add(var_88, var_89);
        var_91 = wp::mul(var_1, var_90);
        var_92 = wp::sub(var_85, var_91);
        // spread_q = sums[17] - w * (qx * qx + qy * qy + qz * qz)                            <L 22>
        var_94 = wp::extract(var_sums, var_93);
        var_95 = wp::mul(var_32, var_32);
        var_96 = wp::mul(var_35, var_35);
        var_97 = wp::add(var_95, var_96);
        var_98 = wp::mul(var_38, var_38);
        var_99 = wp::add(var_97, var_98);
        var_100 = wp::mul(var_1, var_99);
        var_101 = wp::sub(var_94, var_100);
        // still = xx + yy + zz + float64(1e-12) * max(spread + spread_q, float64(0.0))       <L 23>
        var_102 = wp::add(var_43, var_63);
        var_103 = wp::add(var_102, var_83);
        var_104 = 1e-12;
        var_105 = wp::add(var_92, var_101);
        var_106 = 0.0;
        var_107 = wp::max(var_105, var_106);
        var_108 = wp::mul(var_104, var_107);
        var_109 = wp::add(var_103, var_108);
        // a = four_square(still, yz - zy, zx - xz, xy - yx, yz - zy, xx - yy - zz, xy + yx, zx + xz, zx - xz, xy + yx, yy - xx - zz, yz + zy, xy - yx, zx + xz, yz + zy, zz - xx - yy)       <L 24>
        var_110 = wp::sub(var_68, var_78);
        var_111 = wp::sub(var_73, var_53);
        var_112 = wp::sub(var_48, var_58);
        var_113 = wp::sub(var_68, var_78);
        var_114 = wp::sub(var_43, var_63);
        var_115 = wp::sub(var_114, var_83);
        var_116 = wp::add(var_48, var_58);
        var_117 = wp::add(var_73, var_53);
        var_118 = wp::sub(var_73, var_53);
        var_119 = wp::add(var_48, var_58);
        var_120 = wp::sub(var_63, var_43);
        var_121 = wp::sub(var_120, var_83);
        var_122 = wp::add(var_68, var_78);
        var_123 = wp::sub(var_48, var_58);
        var_124 = wp::add(var_73, var_53);
        var_125 = wp::add(var_68, var_78);
        var_126 = wp::sub(var_83, var_43);
        var_127 = wp::sub(var_126, var_63);
        var_128 = wp::vec_t<16, wp::float64>({var_109, var_110, var_111, var_112, var_113, var_115, var_116, var_117, var_118, var_119, var_121, var_122, var_123, var_124, var_125, var_127});
        // best = largest_of_four(diagonalize_four(a))                                        <L 25>
        var_129 = diagonalize_four_0(var_128);
        var_130 = largest_of_four_0(var_129);
        // pose = rotation_about(best[1], best[2], best[3], best[0])                          <L 26>
        var_132 = wp::extract(var_130, var_131);
        var_134 = wp::extract(var_130, var_133);
        var_136 = wp::extract(var_130, var_135);
        var_138 = wp::extract(var_130, var_137);
        var_139 = rotation_about_0(var_132, var_134, var_136, var_138);
        // scale = float64(1.0)                                                               <L 27>
        var_140 = 1.0;
        // if with_scaling == 1 and spread > float64(0.0):                                    <L 28>
        var_143 = (var_with_scaling == var_142);
        var_141 = var_143;
        if (var_141) {
            var_144 = 0.0;
            var_145 = (var_92 > var_144);
            var_141 = var_141 && var_145;
        }
        if (var_141) {
            // aligned = pose[0, 0] * xx + pose[0, 1] * yx + pose[0, 2] * zx                  <L 29>
            var_148 = wp::extract(var_139, var_146, var_147);
            var_149 = wp::mul(var_148, var_43);
            var_152 = wp::extract(var_139, var_150, var_151);
            var_153 = wp::mul(var_152, var_58);
            var_154 = wp::add(var_149, var_153);
            var_157 = wp::extract(var_139, var_155, var_156);
            var_158 = wp::mul(var_157, var_73);
            var_159 = wp::add(var_154, var_158);
            // aligned += pose[1, 0] * xy + pose[1, 1] * yy + pose[1, 2] * zy                 <L 30>
            var_162 = wp::extract(var_139, var_160, var_161);
            var_163 = wp::mul(var_162, var_48);
            var_166 = wp::extract(var_139, var_164, var_165);
            var_167 = wp::mul(var_166, var_63);
            var_168 = wp::add(var_163, var_167);
            var_171 = wp::extract(var_139, var_169, var_170);
            var_172 = wp::mul(var_171, var_78);
            var_173 = wp::add(var_168, var_172);
            var_174 = wp::add(var_159, var_173);
            // aligned += pose[2, 0] * xz + pose[2, 1] * yz + pose[2, 2] * zz                 <L 31>
            var_177 = wp::extract(var_139, var_175, var_176);
            var_178 = wp::mul(var_177, var_53);
            var_181 = wp::extract(var_139, var_179, var_180);
            var_182 = wp::mul(var_181, var_68);
            var_183 = wp::add(var_178, var_182);
            var_186 = wp::extract(var_139, var_184, var_185);
            var_187 = wp::mul(var_186, var_83);
            var_188 = wp::add(var_183, var_187);
            var_189 = wp::add(var_174, var_188);
            // if aligned > float64(0.0):                                                     <L 32>
            var_190 = 0.0;
            var_191 = (var_189 > var_190);
            if (var_191) {
                // scale = aligned / spread                                                   <L 33>
                var_192 = wp::div(var_189, var_92);
            }
            var_193 = wp::where(var_191, var_192, var_140);
        }
        var_194 = wp::where(var_141, var_193, var_140);
        // for i in range(3):                                                                 <L 34>
        // for j in range(3):                                                                 <L 35>
        // pose[i, j] = pose[i, j] * scale                                                    <L 36>
        var_197 = wp::extract(var_139, var_195, var_196);
        var_198 = wp::mul(var_197, var_194);
        wp::assign_inplace(var_139, var_195, var_196, var_198);
        var_200 = wp::extract(var_139, var_195, var_199);
        var_201 = wp::mul(var_200, var_194);
        wp::assign_inplace(var_139, var_195, var_199, var_201);
        var_203 = wp::extract(var_139, var_195, var_202);
        var_204 = wp::mul(var_203, var_194);
        wp::assign_inplace(var_139, var_195, var_202, var_204);
        // pose[i, 3] = -(pose[i, 0] * px + pose[i, 1] * py + pose[i, 2] * pz)                <L 37>
        var_206 = wp::extract(var_139, var_195, var_205);
        var_207 = wp::mul(var_206, var_23);
        var_209 = wp::extract(var_139, var_195, var_208);
        var_210 = wp::mul(var_209, var_26);
        var_211 = wp::add(var_207, var_210);
        var_213 = wp::extract(var_139, var_195, var_212);
        var_214 = wp::mul(var_213, var_29);
        var_215 = wp::add(var_211, var_214);
        var_216 = wp::neg(var_215);
        wp::assign_inplace(var_139, var_195, var_217, var_216);
        // for j in range(3):                                                                 <L 35>
        // pose[i, j] = pose[i, j] * scale                                                    <L 36>
        var_220 = wp::extract(var_139, var_218, var_219);
        var_221 = wp::mul(var_220, var_194);
        wp::assign_inplace(var_139, var_218, var_219, var_221);
        var_223 = wp::extract(var_139, var_218, var_222);
        var_224 = wp::mul(var_223, var_194);
        wp::assign_inplace(var_139, var_218, var_222, var_224);
        var_226 = wp::extract(var_139, var_218, var_225);
        var_227 = wp::mul(var_226, var_194);
        wp::assign_inplace(var_139, var_218, var_225, var_227);
        // pose[i, 3] = -(pose[i, 0] * px + pose[i, 1] * py + pose[i, 2] * pz)                <L 37>
        var_229 = wp::extract(var_139, var_218, var_228);
        var_230 = wp::mul(var_229, var_23);
        var_232 = wp::extract(var_139, var_218, var_231);
        var_233 = wp::mul(var_232, var_26);
        var_234 = wp::add(var_230, var_233);
        var_236 = wp::extract(var_139, var_218, var_235);
        var_237 = wp::mul(var_236, var_29);
        var_238 = wp::add(var_234, var_237);
        var_239 = wp::neg(var_238);
        wp::assign_inplace(var_139, var_218, var_240, var_239);
        // for j in range(3):                                                                 <L 35>
        // pose[i, j] = pose[i, j] * scale                                                    <L 36>
        var_243 = wp::extract(var_139, var_241, var_242);
        var_244 = wp::mul(var_243, var_194);
        wp::assign_inplace(var_139, var_241, var_242, var_244);
        var_246 = wp::extract(var_139, var_241, var_245);
        var_247 = wp::mul(var_246, var_194);
        wp::assign_inplace(var_139, var_241, var_245, var_247);
        var_249 = wp::extract(var_139, var_241, var_248);
        var_250 = wp::mul(var_249, var_194);
        wp::assign_inplace(var_139, var_241, var_248, var_250);
        // pose[i, 3] = -(pose[i, 0] * px + pose[i, 1] * py + pose[i, 2] * pz)                <L 37>
        var_252 = wp::extract(var_139, var_241, var_251);
        var_253 = wp::mul(var_252, var_23);
        var_255 = wp::extract(var_139, var_241, var_254);
        var_256 = wp::mul(var_255, var_26);
        var_257 = wp::add(var_253, var_256);
        var_259 = wp::extract(var_139, var_241, var_258);
        var_260 = wp::mul(var_259, var_29);
        var_261 = wp::add(var_257, var_260);
        var_262 = wp::neg(var_261);
        wp::assign_inplace(var_139, var_241, var_263, var_262);
        // pose[0, 3] = pose[0, 3] + qx                                                       <L 38>
        var_266 = wp::extract(var_139, var_264, var_265);
        var_267 = wp::add(var_266, var_32);
        wp::assign_inplace(var_139, var_268, var_269, var_267);
        // pose[1, 3] = pose[1, 3] + qy                                                       <L 39>
        var_272 = wp::extract(var_139, var_270, var_271);
        var_273 = wp::add(var_272, var_35);
        wp::assign_inplace(var_139, var_274, var_275, var_273);
        // pose[2, 3] = pose[2, 3] + qz                                                       <L 40>
        var_278 = wp::extract(var_139, var_276, var_277);
        var_279 = wp::add(var_278, var_38);
        wp::assign_inplace(var_139, var_280, var_281, var_279);
    }
    var_282 = wp::where(var_20, var_139, var_18);
    // return pose                                                                            <L 41>
    return var_282;
}


// <pointloom.kernels.poses.pair_fits.fit_of>:1
static CUDA_CALLABLE wp::mat_t<4, 4, wp::float64> fit_of_0(
    wp::vec_t<19, wp::float64> var_total,
    wp::mat_t<4, 4, wp::float64> var_pose,
    wp::int32 var_with_scaling)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::vec_t<18, wp::float64> var_1;
    wp::int32 var_2;
    wp::int32 var_3;
    wp::float64 var_4;
    wp::float64 var_5;
    wp::mat_t<4, 4, wp::float64> var_6;
    const wp::int32 var_7 = 0;
    wp::float64 var_8;
    wp::float64 var_9;
    bool var_10;
    wp::mat_t<4, 4, wp::float64> var_11;
    wp::mat_t<4, 4, wp::float64> var_12;
    //---------
    // forward
    // def fit_of(total, pose, with_scaling):                                                 <L 1>
    // s = pair_sums(float64(0.0))                                                            <L 3>
    var_0 = 0.0;
    var_1 = wp::vec_t<18, wp::float64>(var_0);
    // for k in range(SUMS):                                                                  <L 4>
    var_2 = 0;
    start_for_0:;
        if (var_2 >= 18) goto end_for_0;
        var_3 = var_2;
        var_2 += 1;
        // s[k] = total[k]                                                                    <L 5>
        var_4 = wp::extract(var_total, var_3);
        wp::assign_inplace(var_1, var_3, var_4);
        goto start_for_0;
    end_for_0:;
    // fitted = pose * float64(1.0)                                                           <L 6>
    var_5 = 1.0;
    var_6 = wp::mul(var_pose, var_5);
    // if total[0] > float64(0.0):                                                            <L 7>
    var_8 = wp::extract(var_total, var_7);
    var_9 = 0.0;
    var_10 = (var_8 > var_9);
    if (var_10) {
        // fitted = fit_pose(s, with_scaling)                                                 <L 8>
        var_11 = fit_pose_0(var_1, var_with_scaling);
    }
    var_12 = wp::where(var_10, var_11, var_6);
    // return fitted                                                                          <L 9>
    return var_12;
}


// <pointloom.kernels.poses.pair_fits.fold_blocks>:1
static CUDA_CALLABLE void adj_fold_blocks_0(
    wp::array_t<wp::float64> var_partials,
    wp::int32 var_first,
    wp::int32 var_blocks,
    wp::array_t<wp::float64> & adj_partials,
    wp::int32 & adj_first,
    wp::int32 & adj_blocks,
    wp::vec_t<19, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.algebra.rigid_solve.jacobi_rotation>:1
static CUDA_CALLABLE void adj_jacobi_rotation_0(
    wp::float64 var_app,
    wp::float64 var_aqq,
    wp::float64 var_apq,
    wp::float64 & adj_app,
    wp::float64 & adj_aqq,
    wp::float64 & adj_apq,
    wp::vec_t<2, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.algebra.rigid_solve.diagonalize_four>:1
static CUDA_CALLABLE void adj_diagonalize_four_0(
    wp::vec_t<16, wp::float64> var_matrix,
    wp::vec_t<16, wp::float64> & adj_matrix,
    wp::vec_t<20, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/algebra/rigid_solve.py:134
static CUDA_CALLABLE void adj_largest_of_four_0(
    wp::vec_t<20, wp::float64> var_system,
    wp::vec_t<20, wp::float64> & adj_system,
    wp::vec_t<4, wp::float64> & adj_ret)
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


// <pointloom.kernels.algebra.rigid_solve.fit_pose>:1
static CUDA_CALLABLE void adj_fit_pose_0(
    wp::vec_t<18, wp::float64> var_sums,
    wp::int32 var_with_scaling,
    wp::vec_t<18, wp::float64> & adj_sums,
    wp::int32 & adj_with_scaling,
    wp::mat_t<4, 4, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.poses.pair_fits.fit_of>:1
static CUDA_CALLABLE void adj_fit_of_0(
    wp::vec_t<19, wp::float64> var_total,
    wp::mat_t<4, 4, wp::float64> var_pose,
    wp::int32 var_with_scaling,
    wp::vec_t<19, wp::float64> & adj_total,
    wp::mat_t<4, 4, wp::float64> & adj_pose,
    wp::int32 & adj_with_scaling,
    wp::mat_t<4, 4, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void anneal_poses_kernel_4856e866_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float64> var_partials,
    wp::int32 var_blocks,
    wp::float64 var_divisor,
    wp::float64 var_min_scale,
    wp::int32 var_every,
    wp::int32 var_steps,
    wp::array_t<wp::int32> var_left,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_poses,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_previous,
    wp::array_t<wp::float64> var_limits)
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
        wp::mat_t<4, 4, wp::float64> var_3;
        wp::int32 var_4;
        wp::vec_t<19, wp::float64> var_5;
        wp::mat_t<4, 4, wp::float64>* var_6;
        const wp::int32 var_7 = 0;
        wp::mat_t<4, 4, wp::float64> var_8;
        wp::mat_t<4, 4, wp::float64> var_9;
        bool var_10;
        wp::float64* var_11;
        bool var_12;
        wp::float64 var_13;
        wp::int32* var_14;
        wp::int32 var_15;
        wp::int32 var_16;
        wp::int32 var_17;
        const wp::int32 var_18 = 0;
        bool var_19;
        wp::float64* var_20;
        wp::float64 var_21;
        wp::float64 var_22;
        wp::int32* var_23;
        const wp::int32 var_24 = 1;
        wp::int32 var_25;
        wp::int32 var_26;
        //---------
        // forward
        // def anneal_poses_kernel(                                                               <L 314>
        // i = tid()                                                                              <L 327>
        var_0 = builtin_tid1d();
        // previous[i] = poses[i]                                                                 <L 328>
        var_1 = wp::address(var_poses, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        wp::array_store(var_previous, var_0, var_2);
        // poses[i] = fit_of(fold_blocks(partials, i * blocks, blocks), poses[i], 0)              <L 329>
        var_4 = wp::mul(var_0, var_blocks);
        var_5 = fold_blocks_0(var_partials, var_4, var_blocks);
        var_6 = wp::address(var_poses, var_0);
        var_9 = wp::load(var_6);
        var_8 = fit_of_0(var_5, var_9, var_7);
        wp::array_store(var_poses, var_0, var_8);
        // if limits[i] > min_scale and (steps - left[i]) % every == 0:                           <L 330>
        var_11 = wp::address(var_limits, var_0);
        var_13 = wp::load(var_11);
        var_12 = (var_13 > var_min_scale);
        var_10 = var_12;
        if (var_10) {
            var_14 = wp::address(var_left, var_0);
            var_16 = wp::load(var_14);
            var_15 = wp::sub(var_steps, var_16);
            var_17 = wp::mod(var_15, var_every);
            var_19 = (var_17 == var_18);
            var_10 = var_10 && var_19;
        }
        if (var_10) {
            // limits[i] = limits[i] / divisor                                                    <L 331>
            var_20 = wp::address(var_limits, var_0);
            var_22 = wp::load(var_20);
            var_21 = wp::div(var_22, var_divisor);
            wp::array_store(var_limits, var_0, var_21);
        }
        // left[i] = left[i] - 1                                                                  <L 332>
        var_23 = wp::address(var_left, var_0);
        var_26 = wp::load(var_23);
        var_25 = wp::sub(var_26, var_24);
        wp::array_store(var_left, var_0, var_25);
}



extern "C" __global__ void select_coordinates_kernel_6652078b_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_pairs__coordinates,
    wp::int32 var_pairs__count,
    wp::array_t<wp::int32> var_rows,
    wp::array_t<wp::float32> var_out)
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
        wp::int32* var_3;
        wp::int32 var_4;
        wp::int32 var_5;
        wp::float32* var_6;
        wp::float32 var_7;
        wp::float32 var_8;
        wp::shape_t* var_9;
        const wp::int32 var_10 = 0;
        wp::int32 var_11;
        wp::shape_t var_12;
        wp::int32 var_13;
        wp::int32 var_14;
        const wp::int32 var_15 = 1;
        wp::int32 var_16;
        wp::int32* var_17;
        wp::int32 var_18;
        wp::int32 var_19;
        wp::float32* var_20;
        wp::float32 var_21;
        wp::float32 var_22;
        wp::shape_t* var_23;
        const wp::int32 var_24 = 0;
        wp::int32 var_25;
        wp::shape_t var_26;
        wp::int32 var_27;
        wp::int32 var_28;
        const wp::int32 var_29 = 2;
        wp::int32 var_30;
        wp::int32* var_31;
        wp::int32 var_32;
        wp::int32 var_33;
        wp::float32* var_34;
        wp::float32 var_35;
        wp::float32 var_36;
        wp::shape_t* var_37;
        const wp::int32 var_38 = 0;
        wp::int32 var_39;
        wp::shape_t var_40;
        wp::int32 var_41;
        wp::int32 var_42;
        const wp::int32 var_43 = 3;
        wp::int32 var_44;
        wp::int32* var_45;
        wp::int32 var_46;
        wp::int32 var_47;
        wp::float32* var_48;
        wp::float32 var_49;
        wp::float32 var_50;
        wp::shape_t* var_51;
        const wp::int32 var_52 = 0;
        wp::int32 var_53;
        wp::shape_t var_54;
        wp::int32 var_55;
        wp::int32 var_56;
        const wp::int32 var_57 = 4;
        wp::int32 var_58;
        wp::int32* var_59;
        wp::int32 var_60;
        wp::int32 var_61;
        wp::float32* var_62;
        wp::float32 var_63;
        wp::float32 var_64;
        wp::shape_t* var_65;
        const wp::int32 var_66 = 0;
        wp::int32 var_67;
        wp::shape_t var_68;
        wp::int32 var_69;
        wp::int32 var_70;
        const wp::int32 var_71 = 5;
        wp::int32 var_72;
        wp::int32* var_73;
        wp::int32 var_74;
        wp::int32 var_75;
        wp::float32* var_76;
        wp::float32 var_77;
        wp::float32 var_78;
        wp::shape_t* var_79;
        const wp::int32 var_80 = 0;
        wp::int32 var_81;
        wp::shape_t var_82;
        wp::int32 var_83;
        wp::int32 var_84;
        //---------
        // forward
        // def select_coordinates_kernel(pairs__coordinates, pairs__count, rows, out):            <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // for axis in range(6):                                                                  <L 3>
        // out[axis * rows.shape[0] + i] = pairs__coordinates[axis * pairs__count + rows[i]]       <L 4>
        var_2 = wp::mul(var_1, var_pairs__count);
        var_3 = wp::address(var_rows, var_0);
        var_5 = wp::load(var_3);
        var_4 = wp::add(var_2, var_5);
        var_6 = wp::address(var_pairs__coordinates, var_4);
        var_8 = wp::load(var_6);
        var_7 = wp::copy(var_8);
        var_9 = &(var_rows.shape);
        var_12 = wp::load(var_9);
        var_11 = wp::extract(var_12, var_10);
        var_13 = wp::mul(var_1, var_11);
        var_14 = wp::add(var_13, var_0);
        wp::array_store(var_out, var_14, var_7);
        var_16 = wp::mul(var_15, var_pairs__count);
        var_17 = wp::address(var_rows, var_0);
        var_19 = wp::load(var_17);
        var_18 = wp::add(var_16, var_19);
        var_20 = wp::address(var_pairs__coordinates, var_18);
        var_22 = wp::load(var_20);
        var_21 = wp::copy(var_22);
        var_23 = &(var_rows.shape);
        var_26 = wp::load(var_23);
        var_25 = wp::extract(var_26, var_24);
        var_27 = wp::mul(var_15, var_25);
        var_28 = wp::add(var_27, var_0);
        wp::array_store(var_out, var_28, var_21);
        var_30 = wp::mul(var_29, var_pairs__count);
        var_31 = wp::address(var_rows, var_0);
        var_33 = wp::load(var_31);
        var_32 = wp::add(var_30, var_33);
        var_34 = wp::address(var_pairs__coordinates, var_32);
        var_36 = wp::load(var_34);
        var_35 = wp::copy(var_36);
        var_37 = &(var_rows.shape);
        var_40 = wp::load(var_37);
        var_39 = wp::extract(var_40, var_38);
        var_41 = wp::mul(var_29, var_39);
        var_42 = wp::add(var_41, var_0);
        wp::array_store(var_out, var_42, var_35);
        var_44 = wp::mul(var_43, var_pairs__count);
        var_45 = wp::address(var_rows, var_0);
        var_47 = wp::load(var_45);
        var_46 = wp::add(var_44, var_47);
        var_48 = wp::address(var_pairs__coordinates, var_46);
        var_50 = wp::load(var_48);
        var_49 = wp::copy(var_50);
        var_51 = &(var_rows.shape);
        var_54 = wp::load(var_51);
        var_53 = wp::extract(var_54, var_52);
        var_55 = wp::mul(var_43, var_53);
        var_56 = wp::add(var_55, var_0);
        wp::array_store(var_out, var_56, var_49);
        var_58 = wp::mul(var_57, var_pairs__count);
        var_59 = wp::address(var_rows, var_0);
        var_61 = wp::load(var_59);
        var_60 = wp::add(var_58, var_61);
        var_62 = wp::address(var_pairs__coordinates, var_60);
        var_64 = wp::load(var_62);
        var_63 = wp::copy(var_64);
        var_65 = &(var_rows.shape);
        var_68 = wp::load(var_65);
        var_67 = wp::extract(var_68, var_66);
        var_69 = wp::mul(var_57, var_67);
        var_70 = wp::add(var_69, var_0);
        wp::array_store(var_out, var_70, var_63);
        var_72 = wp::mul(var_71, var_pairs__count);
        var_73 = wp::address(var_rows, var_0);
        var_75 = wp::load(var_73);
        var_74 = wp::add(var_72, var_75);
        var_76 = wp::address(var_pairs__coordinates, var_74);
        var_78 = wp::load(var_76);
        var_77 = wp::copy(var_78);
        var_79 = &(var_rows.shape);
        var_82 = wp::load(var_79);
        var_81 = wp::extract(var_82, var_80);
        var_83 = wp::mul(var_71, var_81);
        var_84 = wp::add(var_83, var_0);
        wp::array_store(var_out, var_84, var_77);
}



extern "C" __global__ void gather_pairs_kernel_780814df_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_pairs,
    wp::array_t<wp::int32> var_rows,
    wp::array_t<wp::int32> var_out)
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
        const wp::int32 var_2 = 0;
        wp::int32 var_3;
        wp::int32* var_4;
        wp::int32 var_5;
        wp::int32 var_6;
        const wp::int32 var_7 = 0;
        wp::int32* var_8;
        const wp::int32 var_9 = 1;
        wp::int32 var_10;
        wp::int32* var_11;
        wp::int32 var_12;
        wp::int32 var_13;
        const wp::int32 var_14 = 1;
        //---------
        // forward
        // def gather_pairs_kernel(pairs: array(dtype=int32, ndim=2), rows: array(dtype=int32), out: array(dtype=int32, ndim=2)):       <L 155>
        // i = tid()                                                                              <L 156>
        var_0 = builtin_tid1d();
        // out[i, 0] = pairs[rows[i], 0]                                                          <L 157>
        var_1 = wp::address(var_rows, var_0);
        var_3 = wp::load(var_1);
        var_4 = wp::address(var_pairs, var_3, var_2);
        var_6 = wp::load(var_4);
        var_5 = wp::copy(var_6);
        wp::array_store(var_out, var_0, var_7, var_5);
        // out[i, 1] = pairs[rows[i], 1]                                                          <L 158>
        var_8 = wp::address(var_rows, var_0);
        var_10 = wp::load(var_8);
        var_11 = wp::address(var_pairs, var_10, var_9);
        var_13 = wp::load(var_11);
        var_12 = wp::copy(var_13);
        wp::array_store(var_out, var_0, var_14, var_12);
}



extern "C" __global__ void refit_poses_kernel_a2e273e0_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float64> var_partials,
    wp::int32 var_blocks,
    wp::int32 var_with_scaling,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_poses,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_best_poses,
    wp::array_t<wp::float64> var_scores)
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
        wp::vec_t<19, wp::float64> var_2;
        const wp::int32 var_3 = 0;
        wp::int32 var_4;
        const wp::int32 var_5 = 0;
        wp::float64 var_6;
        const wp::int32 var_7 = 0;
        wp::float64* var_8;
        bool var_9;
        wp::float64 var_10;
        const wp::int32 var_11 = 1;
        wp::int32 var_12;
        bool var_13;
        const wp::int32 var_14 = 0;
        wp::float64 var_15;
        const wp::int32 var_16 = 0;
        wp::float64* var_17;
        bool var_18;
        wp::float64 var_19;
        const wp::int32 var_20 = 18;
        wp::float64 var_21;
        const wp::int32 var_22 = 1;
        wp::float64* var_23;
        bool var_24;
        wp::float64 var_25;
        const wp::int32 var_26 = 1;
        wp::int32 var_27;
        const wp::int32 var_28 = 1;
        bool var_29;
        wp::mat_t<4, 4, wp::float64>* var_30;
        wp::mat_t<4, 4, wp::float64> var_31;
        wp::mat_t<4, 4, wp::float64> var_32;
        const wp::int32 var_33 = 0;
        wp::float64 var_34;
        const wp::int32 var_35 = 0;
        wp::float64 var_36;
        const wp::int32 var_37 = 1;
        const wp::int32 var_38 = 0;
        wp::float64 var_39;
        wp::float64 var_40;
        bool var_41;
        wp::mat_t<4, 4, wp::float64>* var_42;
        wp::mat_t<4, 4, wp::float64> var_43;
        wp::mat_t<4, 4, wp::float64> var_44;
        //---------
        // forward
        // def refit_poses_kernel(partials, blocks, with_scaling, poses, best_poses, scores):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // total = fold_blocks(partials, i * blocks, blocks)                                      <L 4>
        var_1 = wp::mul(var_0, var_blocks);
        var_2 = fold_blocks_0(var_partials, var_1, var_blocks);
        // better = int(0)                                                                        <L 5>
        var_4 = wp::int(var_3);
        // if total[0] > scores[i, 0]:                                                            <L 6>
        var_6 = wp::extract(var_2, var_5);
        var_8 = wp::address(var_scores, var_0, var_7);
        var_10 = wp::load(var_8);
        var_9 = (var_6 > var_10);
        if (var_9) {
            // better = 1                                                                         <L 7>
        }
        var_12 = wp::where(var_9, var_11, var_4);
        // if total[0] == scores[i, 0] and total[SUMS] < scores[i, 1]:                            <L 8>
        var_15 = wp::extract(var_2, var_14);
        var_17 = wp::address(var_scores, var_0, var_16);
        var_19 = wp::load(var_17);
        var_18 = (var_15 == var_19);
        var_13 = var_18;
        if (var_13) {
            var_21 = wp::extract(var_2, var_20);
            var_23 = wp::address(var_scores, var_0, var_22);
            var_25 = wp::load(var_23);
            var_24 = (var_21 < var_25);
            var_13 = var_13 && var_24;
        }
        if (var_13) {
            // better = 1                                                                         <L 9>
        }
        var_27 = wp::where(var_13, var_26, var_12);
        // if better == 1:                                                                        <L 10>
        var_29 = (var_27 == var_28);
        if (var_29) {
            // best_poses[i] = poses[i]                                                           <L 11>
            var_30 = wp::address(var_poses, var_0);
            var_32 = wp::load(var_30);
            var_31 = wp::copy(var_32);
            wp::array_store(var_best_poses, var_0, var_31);
            // scores[i, 0] = total[0]                                                            <L 12>
            var_34 = wp::extract(var_2, var_33);
            wp::array_store(var_scores, var_0, var_35, var_34);
            // scores[i, 1] = total[SUMS]                                                         <L 13>
            var_36 = wp::extract(var_2, var_20);
            wp::array_store(var_scores, var_0, var_37, var_36);
        }
        // if total[0] >= float64(MIN_PAIRS):                                                     <L 14>
        var_39 = wp::extract(var_2, var_38);
        var_40 = 3;
        var_41 = (var_39 >= var_40);
        if (var_41) {
            // poses[i] = fit_of(total, poses[i], with_scaling)                                   <L 15>
            var_42 = wp::address(var_poses, var_0);
            var_44 = wp::load(var_42);
            var_43 = fit_of_0(var_2, var_44, var_with_scaling);
            wp::array_store(var_poses, var_0, var_43);
        }
}



extern "C" __global__ void mask_finite_pairs_kernel_df26ffef_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_source,
    wp::array_t<wp::vec_t<3, wp::float32>> var_target,
    wp::array_t<wp::int32> var_pairs,
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
        const wp::int32 var_1 = 0;
        wp::int32 var_2;
        bool var_3;
        const wp::int32 var_4 = 0;
        wp::int32* var_5;
        wp::int32 var_6;
        wp::vec_t<3, wp::float32>* var_7;
        bool var_8;
        wp::vec_t<3, wp::float32> var_9;
        const wp::int32 var_10 = 1;
        wp::int32* var_11;
        wp::int32 var_12;
        wp::vec_t<3, wp::float32>* var_13;
        bool var_14;
        wp::vec_t<3, wp::float32> var_15;
        const wp::int32 var_16 = 1;
        wp::int32 var_17;
        wp::uint8 var_18;
        //---------
        // forward
        // def mask_finite_pairs_kernel(source, target, pairs, mask):                             <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // both = int(0)                                                                          <L 3>
        var_2 = wp::int(var_1);
        // if isfinite(source[pairs[i, 0]]) and isfinite(target[pairs[i, 1]]):                    <L 4>
        var_5 = wp::address(var_pairs, var_0, var_4);
        var_6 = wp::load(var_5);
        var_7 = wp::address(var_source, var_6);
        var_9 = wp::load(var_7);
        var_8 = wp::isfinite(var_9);
        var_3 = var_8;
        if (var_3) {
            var_11 = wp::address(var_pairs, var_0, var_10);
            var_12 = wp::load(var_11);
            var_13 = wp::address(var_target, var_12);
            var_15 = wp::load(var_13);
            var_14 = wp::isfinite(var_15);
            var_3 = var_3 && var_14;
        }
        if (var_3) {
            // both = 1                                                                           <L 5>
        }
        var_17 = wp::where(var_3, var_16, var_2);
        // mask[i] = uint8(both)                                                                  <L 6>
        var_18 = wp::uint8(var_17);
        wp::array_store(var_mask, var_0, var_18);
}



extern "C" __global__ void split_pairs_kernel_e2d2778b_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_source,
    wp::array_t<wp::vec_t<3, wp::float32>> var_target,
    wp::vec_t<3, wp::float32> var_source_middle,
    wp::vec_t<3, wp::float32> var_target_middle,
    wp::array_t<wp::int32> var_pairs__rows,
    wp::array_t<wp::float32> var_pairs__coordinates,
    wp::int32 var_pairs__count)
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
        wp::int32* var_2;
        wp::int32 var_3;
        wp::vec_t<3, wp::float32>* var_4;
        wp::vec_t<3, wp::float32> var_5;
        wp::vec_t<3, wp::float32> var_6;
        const wp::int32 var_7 = 1;
        wp::int32* var_8;
        wp::int32 var_9;
        wp::vec_t<3, wp::float32>* var_10;
        wp::vec_t<3, wp::float32> var_11;
        wp::vec_t<3, wp::float32> var_12;
        const wp::int32 var_13 = 0;
        wp::float32 var_14;
        wp::int32 var_15;
        wp::int32 var_16;
        wp::float32 var_17;
        const wp::int32 var_18 = 3;
        wp::int32 var_19;
        wp::int32 var_20;
        wp::int32 var_21;
        const wp::int32 var_22 = 1;
        wp::float32 var_23;
        wp::int32 var_24;
        wp::int32 var_25;
        wp::float32 var_26;
        const wp::int32 var_27 = 3;
        wp::int32 var_28;
        wp::int32 var_29;
        wp::int32 var_30;
        const wp::int32 var_31 = 2;
        wp::float32 var_32;
        wp::int32 var_33;
        wp::int32 var_34;
        wp::float32 var_35;
        const wp::int32 var_36 = 3;
        wp::int32 var_37;
        wp::int32 var_38;
        wp::int32 var_39;
        //---------
        // forward
        // def split_pairs_kernel(source, target, source_middle, target_middle, pairs__rows, pairs__coordinates, pairs__count):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // p = source[pairs__rows[i, 0]] - source_middle                                          <L 4>
        var_2 = wp::address(var_pairs__rows, var_0, var_1);
        var_3 = wp::load(var_2);
        var_4 = wp::address(var_source, var_3);
        var_6 = wp::load(var_4);
        var_5 = wp::sub(var_6, var_source_middle);
        // q = target[pairs__rows[i, 1]] - target_middle                                          <L 5>
        var_8 = wp::address(var_pairs__rows, var_0, var_7);
        var_9 = wp::load(var_8);
        var_10 = wp::address(var_target, var_9);
        var_12 = wp::load(var_10);
        var_11 = wp::sub(var_12, var_target_middle);
        // for axis in range(3):                                                                  <L 6>
        // pairs__coordinates[axis * pairs__count + i] = p[axis]                                  <L 7>
        var_14 = wp::extract(var_5, var_13);
        var_15 = wp::mul(var_13, var_pairs__count);
        var_16 = wp::add(var_15, var_0);
        wp::array_store(var_pairs__coordinates, var_16, var_14);
        // pairs__coordinates[(3 + axis) * pairs__count + i] = q[axis]                            <L 8>
        var_17 = wp::extract(var_11, var_13);
        var_19 = wp::add(var_18, var_13);
        var_20 = wp::mul(var_19, var_pairs__count);
        var_21 = wp::add(var_20, var_0);
        wp::array_store(var_pairs__coordinates, var_21, var_17);
        // pairs__coordinates[axis * pairs__count + i] = p[axis]                                  <L 7>
        var_23 = wp::extract(var_5, var_22);
        var_24 = wp::mul(var_22, var_pairs__count);
        var_25 = wp::add(var_24, var_0);
        wp::array_store(var_pairs__coordinates, var_25, var_23);
        // pairs__coordinates[(3 + axis) * pairs__count + i] = q[axis]                            <L 8>
        var_26 = wp::extract(var_11, var_22);
        var_28 = wp::add(var_27, var_22);
        var_29 = wp::mul(var_28, var_pairs__count);
        var_30 = wp::add(var_29, var_0);
        wp::array_store(var_pairs__coordinates, var_30, var_26);
        // pairs__coordinates[axis * pairs__count + i] = p[axis]                                  <L 7>
        var_32 = wp::extract(var_5, var_31);
        var_33 = wp::mul(var_31, var_pairs__count);
        var_34 = wp::add(var_33, var_0);
        wp::array_store(var_pairs__coordinates, var_34, var_32);
        // pairs__coordinates[(3 + axis) * pairs__count + i] = q[axis]                            <L 8>
        var_35 = wp::extract(var_11, var_31);
        var_37 = wp::add(var_36, var_31);
        var_38 = wp::mul(var_37, var_pairs__count);
        var_39 = wp::add(var_38, var_0);
        wp::array_store(var_pairs__coordinates, var_39, var_35);
}


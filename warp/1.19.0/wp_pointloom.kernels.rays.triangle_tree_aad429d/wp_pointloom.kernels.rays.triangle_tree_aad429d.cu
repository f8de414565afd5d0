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


// /work/main/src/pointloom/kernels/algebra/transform.py:32
static CUDA_CALLABLE wp::vec_t<3, wp::float32> narrow_0(
    wp::vec_t<3, wp::float64> var_p)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float64 var_1;
    wp::float32 var_2;
    const wp::int32 var_3 = 1;
    wp::float64 var_4;
    wp::float32 var_5;
    const wp::int32 var_6 = 2;
    wp::float64 var_7;
    wp::float32 var_8;
    wp::vec_t<3, wp::float32> var_9;
    //---------
    // forward
    // def narrow(p: vec3d) -> vec3:                                                          <L 33>
    // return vec3(float(p[0]), float(p[1]), float(p[2]))                                     <L 34>
    var_1 = wp::extract(var_p, var_0);
    var_2 = wp::float(var_1);
    var_4 = wp::extract(var_p, var_3);
    var_5 = wp::float(var_4);
    var_7 = wp::extract(var_p, var_6);
    var_8 = wp::float(var_7);
    var_9 = wp::vec_t<3, wp::float32>(var_2, var_5, var_8);
    return var_9;
}


// <pointloom.kernels.rays.triangle_tree.middle_of>:1
static CUDA_CALLABLE wp::vec_t<3, wp::float32> middle_of_0(
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::vec_t<3, wp::float32> var_c)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float64> var_0;
    wp::vec_t<3, wp::float64> var_1;
    wp::vec_t<3, wp::float64> var_2;
    wp::vec_t<3, wp::float64> var_3;
    wp::vec_t<3, wp::float64> var_4;
    wp::float64 var_5;
    wp::vec_t<3, wp::float64> var_6;
    wp::vec_t<3, wp::float32> var_7;
    //---------
    // forward
    // def middle_of(a, b, c):                                                                <L 1>
    // return narrow((widen(a) + widen(b) + widen(c)) / float64(3.0))                         <L 2>
    var_0 = widen_0(var_a);
    var_1 = widen_0(var_b);
    var_2 = wp::add(var_0, var_1);
    var_3 = widen_0(var_c);
    var_4 = wp::add(var_2, var_3);
    var_5 = 3.0;
    var_6 = wp::div(var_4, var_5);
    var_7 = narrow_0(var_6);
    return var_7;
}


// /work/main/src/pointloom/kernels/algebra/transform.py:27
static CUDA_CALLABLE void adj_widen_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/algebra/transform.py:32
static CUDA_CALLABLE void adj_narrow_0(
    wp::vec_t<3, wp::float64> var_p,
    wp::vec_t<3, wp::float64> & adj_p,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.rays.triangle_tree.middle_of>:1
static CUDA_CALLABLE void adj_middle_of_0(
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::vec_t<3, wp::float32> var_c,
    wp::vec_t<3, wp::float32> & adj_a,
    wp::vec_t<3, wp::float32> & adj_b,
    wp::vec_t<3, wp::float32> & adj_c,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void bound_leaves_kernel_13df316c_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_corners,
    wp::array_t<wp::float32> var_boxes)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        const wp::int32 var_1 = 8;
        wp::int32 var_2;
        const wp::int32 var_3 = 48;
        wp::int32 var_4;
        wp::int32 var_5;
        wp::int32 var_6;
        const wp::int32 var_7 = 0;
        const wp::float32 var_8 = INFINITY;
        wp::float32 var_9;
        wp::float32 var_10;
        wp::float32 var_11;
        wp::shape_t* var_12;
        const wp::int32 var_13 = 0;
        wp::int32 var_14;
        wp::shape_t var_15;
        const wp::int32 var_16 = 72;
        wp::int32 var_17;
        bool var_18;
        const wp::int32 var_19 = 0;
        wp::int32 var_20;
        const wp::int32 var_21 = 3;
        wp::int32 var_22;
        wp::int32 var_23;
        const wp::int32 var_24 = 8;
        wp::int32 var_25;
        wp::int32 var_26;
        const wp::int32 var_27 = 0;
        wp::int32 var_28;
        wp::float32* var_29;
        wp::float32 var_30;
        wp::float32 var_31;
        wp::int32 var_32;
        wp::float32* var_33;
        wp::float32 var_34;
        wp::float32 var_35;
        const wp::int32 var_36 = 1;
        wp::int32 var_37;
        wp::float32* var_38;
        wp::float32 var_39;
        wp::float32 var_40;
        wp::int32 var_41;
        wp::float32* var_42;
        wp::float32 var_43;
        wp::float32 var_44;
        const wp::int32 var_45 = 2;
        wp::int32 var_46;
        wp::float32* var_47;
        wp::float32 var_48;
        wp::float32 var_49;
        wp::int32 var_50;
        wp::float32* var_51;
        wp::float32 var_52;
        wp::float32 var_53;
        const wp::int32 var_54 = 3;
        wp::int32 var_55;
        wp::float32* var_56;
        wp::float32 var_57;
        wp::float32 var_58;
        wp::int32 var_59;
        wp::float32* var_60;
        wp::float32 var_61;
        wp::float32 var_62;
        const wp::int32 var_63 = 4;
        wp::int32 var_64;
        wp::float32* var_65;
        wp::float32 var_66;
        wp::float32 var_67;
        wp::int32 var_68;
        wp::float32* var_69;
        wp::float32 var_70;
        wp::float32 var_71;
        const wp::int32 var_72 = 5;
        wp::int32 var_73;
        wp::float32* var_74;
        wp::float32 var_75;
        wp::float32 var_76;
        wp::int32 var_77;
        wp::float32* var_78;
        wp::float32 var_79;
        wp::float32 var_80;
        const wp::int32 var_81 = 6;
        wp::int32 var_82;
        wp::float32* var_83;
        wp::float32 var_84;
        wp::float32 var_85;
        wp::int32 var_86;
        wp::float32* var_87;
        wp::float32 var_88;
        wp::float32 var_89;
        const wp::int32 var_90 = 7;
        wp::int32 var_91;
        wp::float32* var_92;
        wp::float32 var_93;
        wp::float32 var_94;
        wp::int32 var_95;
        wp::float32* var_96;
        wp::float32 var_97;
        wp::float32 var_98;
        const wp::int32 var_99 = 1;
        wp::int32 var_100;
        const wp::int32 var_101 = 3;
        wp::int32 var_102;
        wp::int32 var_103;
        wp::int32 var_104;
        wp::int32 var_105;
        const wp::int32 var_106 = 0;
        wp::int32 var_107;
        wp::float32* var_108;
        wp::float32 var_109;
        wp::float32 var_110;
        wp::int32 var_111;
        wp::float32* var_112;
        wp::float32 var_113;
        wp::float32 var_114;
        const wp::int32 var_115 = 1;
        wp::int32 var_116;
        wp::float32* var_117;
        wp::float32 var_118;
        wp::float32 var_119;
        wp::int32 var_120;
        wp::float32* var_121;
        wp::float32 var_122;
        wp::float32 var_123;
        const wp::int32 var_124 = 2;
        wp::int32 var_125;
        wp::float32* var_126;
        wp::float32 var_127;
        wp::float32 var_128;
        wp::int32 var_129;
        wp::float32* var_130;
        wp::float32 var_131;
        wp::float32 var_132;
        const wp::int32 var_133 = 3;
        wp::int32 var_134;
        wp::float32* var_135;
        wp::float32 var_136;
        wp::float32 var_137;
        wp::int32 var_138;
        wp::float32* var_139;
        wp::float32 var_140;
        wp::float32 var_141;
        const wp::int32 var_142 = 4;
        wp::int32 var_143;
        wp::float32* var_144;
        wp::float32 var_145;
        wp::float32 var_146;
        wp::int32 var_147;
        wp::float32* var_148;
        wp::float32 var_149;
        wp::float32 var_150;
        const wp::int32 var_151 = 5;
        wp::int32 var_152;
        wp::float32* var_153;
        wp::float32 var_154;
        wp::float32 var_155;
        wp::int32 var_156;
        wp::float32* var_157;
        wp::float32 var_158;
        wp::float32 var_159;
        const wp::int32 var_160 = 6;
        wp::int32 var_161;
        wp::float32* var_162;
        wp::float32 var_163;
        wp::float32 var_164;
        wp::int32 var_165;
        wp::float32* var_166;
        wp::float32 var_167;
        wp::float32 var_168;
        const wp::int32 var_169 = 7;
        wp::int32 var_170;
        wp::float32* var_171;
        wp::float32 var_172;
        wp::float32 var_173;
        wp::int32 var_174;
        wp::float32* var_175;
        wp::float32 var_176;
        wp::float32 var_177;
        const wp::int32 var_178 = 2;
        wp::int32 var_179;
        const wp::int32 var_180 = 3;
        wp::int32 var_181;
        wp::int32 var_182;
        wp::int32 var_183;
        wp::int32 var_184;
        const wp::int32 var_185 = 0;
        wp::int32 var_186;
        wp::float32* var_187;
        wp::float32 var_188;
        wp::float32 var_189;
        wp::int32 var_190;
        wp::float32* var_191;
        wp::float32 var_192;
        wp::float32 var_193;
        const wp::int32 var_194 = 1;
        wp::int32 var_195;
        wp::float32* var_196;
        wp::float32 var_197;
        wp::float32 var_198;
        wp::int32 var_199;
        wp::float32* var_200;
        wp::float32 var_201;
        wp::float32 var_202;
        const wp::int32 var_203 = 2;
        wp::int32 var_204;
        wp::float32* var_205;
        wp::float32 var_206;
        wp::float32 var_207;
        wp::int32 var_208;
        wp::float32* var_209;
        wp::float32 var_210;
        wp::float32 var_211;
        const wp::int32 var_212 = 3;
        wp::int32 var_213;
        wp::float32* var_214;
        wp::float32 var_215;
        wp::float32 var_216;
        wp::int32 var_217;
        wp::float32* var_218;
        wp::float32 var_219;
        wp::float32 var_220;
        const wp::int32 var_221 = 4;
        wp::int32 var_222;
        wp::float32* var_223;
        wp::float32 var_224;
        wp::float32 var_225;
        wp::int32 var_226;
        wp::float32* var_227;
        wp::float32 var_228;
        wp::float32 var_229;
        const wp::int32 var_230 = 5;
        wp::int32 var_231;
        wp::float32* var_232;
        wp::float32 var_233;
        wp::float32 var_234;
        wp::int32 var_235;
        wp::float32* var_236;
        wp::float32 var_237;
        wp::float32 var_238;
        const wp::int32 var_239 = 6;
        wp::int32 var_240;
        wp::float32* var_241;
        wp::float32 var_242;
        wp::float32 var_243;
        wp::int32 var_244;
        wp::float32* var_245;
        wp::float32 var_246;
        wp::float32 var_247;
        const wp::int32 var_248 = 7;
        wp::int32 var_249;
        wp::float32* var_250;
        wp::float32 var_251;
        wp::float32 var_252;
        wp::int32 var_253;
        wp::float32* var_254;
        wp::float32 var_255;
        wp::float32 var_256;
        wp::float32 var_257;
        wp::float32 var_258;
        wp::int32 var_259;
        wp::int32 var_260;
        const wp::int32 var_261 = 3;
        wp::int32 var_262;
        wp::int32 var_263;
        wp::int32 var_264;
        const wp::int32 var_265 = 1;
        wp::float32 var_266;
        wp::float32 var_267;
        wp::float32 var_268;
        wp::shape_t* var_269;
        const wp::int32 var_270 = 0;
        wp::int32 var_271;
        wp::shape_t var_272;
        wp::int32 var_273;
        bool var_274;
        const wp::int32 var_275 = 0;
        wp::int32 var_276;
        const wp::int32 var_277 = 3;
        wp::int32 var_278;
        wp::int32 var_279;
        wp::int32 var_280;
        wp::int32 var_281;
        const wp::int32 var_282 = 0;
        wp::int32 var_283;
        wp::float32* var_284;
        wp::float32 var_285;
        wp::float32 var_286;
        wp::int32 var_287;
        wp::float32* var_288;
        wp::float32 var_289;
        wp::float32 var_290;
        const wp::int32 var_291 = 1;
        wp::int32 var_292;
        wp::float32* var_293;
        wp::float32 var_294;
        wp::float32 var_295;
        wp::int32 var_296;
        wp::float32* var_297;
        wp::float32 var_298;
        wp::float32 var_299;
        const wp::int32 var_300 = 2;
        wp::int32 var_301;
        wp::float32* var_302;
        wp::float32 var_303;
        wp::float32 var_304;
        wp::int32 var_305;
        wp::float32* var_306;
        wp::float32 var_307;
        wp::float32 var_308;
        const wp::int32 var_309 = 3;
        wp::int32 var_310;
        wp::float32* var_311;
        wp::float32 var_312;
        wp::float32 var_313;
        wp::int32 var_314;
        wp::float32* var_315;
        wp::float32 var_316;
        wp::float32 var_317;
        const wp::int32 var_318 = 4;
        wp::int32 var_319;
        wp::float32* var_320;
        wp::float32 var_321;
        wp::float32 var_322;
        wp::int32 var_323;
        wp::float32* var_324;
        wp::float32 var_325;
        wp::float32 var_326;
        const wp::int32 var_327 = 5;
        wp::int32 var_328;
        wp::float32* var_329;
        wp::float32 var_330;
        wp::float32 var_331;
        wp::int32 var_332;
        wp::float32* var_333;
        wp::float32 var_334;
        wp::float32 var_335;
        const wp::int32 var_336 = 6;
        wp::int32 var_337;
        wp::float32* var_338;
        wp::float32 var_339;
        wp::float32 var_340;
        wp::int32 var_341;
        wp::float32* var_342;
        wp::float32 var_343;
        wp::float32 var_344;
        const wp::int32 var_345 = 7;
        wp::int32 var_346;
        wp::float32* var_347;
        wp::float32 var_348;
        wp::float32 var_349;
        wp::int32 var_350;
        wp::float32* var_351;
        wp::float32 var_352;
        wp::float32 var_353;
        const wp::int32 var_354 = 1;
        wp::int32 var_355;
        const wp::int32 var_356 = 3;
        wp::int32 var_357;
        wp::int32 var_358;
        wp::int32 var_359;
        wp::int32 var_360;
        const wp::int32 var_361 = 0;
        wp::int32 var_362;
        wp::float32* var_363;
        wp::float32 var_364;
        wp::float32 var_365;
        wp::int32 var_366;
        wp::float32* var_367;
        wp::float32 var_368;
        wp::float32 var_369;
        const wp::int32 var_370 = 1;
        wp::int32 var_371;
        wp::float32* var_372;
        wp::float32 var_373;
        wp::float32 var_374;
        wp::int32 var_375;
        wp::float32* var_376;
        wp::float32 var_377;
        wp::float32 var_378;
        const wp::int32 var_379 = 2;
        wp::int32 var_380;
        wp::float32* var_381;
        wp::float32 var_382;
        wp::float32 var_383;
        wp::int32 var_384;
        wp::float32* var_385;
        wp::float32 var_386;
        wp::float32 var_387;
        const wp::int32 var_388 = 3;
        wp::int32 var_389;
        wp::float32* var_390;
        wp::float32 var_391;
        wp::float32 var_392;
        wp::int32 var_393;
        wp::float32* var_394;
        wp::float32 var_395;
        wp::float32 var_396;
        const wp::int32 var_397 = 4;
        wp::int32 var_398;
        wp::float32* var_399;
        wp::float32 var_400;
        wp::float32 var_401;
        wp::int32 var_402;
        wp::float32* var_403;
        wp::float32 var_404;
        wp::float32 var_405;
        const wp::int32 var_406 = 5;
        wp::int32 var_407;
        wp::float32* var_408;
        wp::float32 var_409;
        wp::float32 var_410;
        wp::int32 var_411;
        wp::float32* var_412;
        wp::float32 var_413;
        wp::float32 var_414;
        const wp::int32 var_415 = 6;
        wp::int32 var_416;
        wp::float32* var_417;
        wp::float32 var_418;
        wp::float32 var_419;
        wp::int32 var_420;
        wp::float32* var_421;
        wp::float32 var_422;
        wp::float32 var_423;
        const wp::int32 var_424 = 7;
        wp::int32 var_425;
        wp::float32* var_426;
        wp::float32 var_427;
        wp::float32 var_428;
        wp::int32 var_429;
        wp::float32* var_430;
        wp::float32 var_431;
        wp::float32 var_432;
        const wp::int32 var_433 = 2;
        wp::int32 var_434;
        const wp::int32 var_435 = 3;
        wp::int32 var_436;
        wp::int32 var_437;
        wp::int32 var_438;
        wp::int32 var_439;
        const wp::int32 var_440 = 0;
        wp::int32 var_441;
        wp::float32* var_442;
        wp::float32 var_443;
        wp::float32 var_444;
        wp::int32 var_445;
        wp::float32* var_446;
        wp::float32 var_447;
        wp::float32 var_448;
        const wp::int32 var_449 = 1;
        wp::int32 var_450;
        wp::float32* var_451;
        wp::float32 var_452;
        wp::float32 var_453;
        wp::int32 var_454;
        wp::float32* var_455;
        wp::float32 var_456;
        wp::float32 var_457;
        const wp::int32 var_458 = 2;
        wp::int32 var_459;
        wp::float32* var_460;
        wp::float32 var_461;
        wp::float32 var_462;
        wp::int32 var_463;
        wp::float32* var_464;
        wp::float32 var_465;
        wp::float32 var_466;
        const wp::int32 var_467 = 3;
        wp::int32 var_468;
        wp::float32* var_469;
        wp::float32 var_470;
        wp::float32 var_471;
        wp::int32 var_472;
        wp::float32* var_473;
        wp::float32 var_474;
        wp::float32 var_475;
        const wp::int32 var_476 = 4;
        wp::int32 var_477;
        wp::float32* var_478;
        wp::float32 var_479;
        wp::float32 var_480;
        wp::int32 var_481;
        wp::float32* var_482;
        wp::float32 var_483;
        wp::float32 var_484;
        const wp::int32 var_485 = 5;
        wp::int32 var_486;
        wp::float32* var_487;
        wp::float32 var_488;
        wp::float32 var_489;
        wp::int32 var_490;
        wp::float32* var_491;
        wp::float32 var_492;
        wp::float32 var_493;
        const wp::int32 var_494 = 6;
        wp::int32 var_495;
        wp::float32* var_496;
        wp::float32 var_497;
        wp::float32 var_498;
        wp::int32 var_499;
        wp::float32* var_500;
        wp::float32 var_501;
        wp::float32 var_502;
        const wp::int32 var_503 = 7;
        wp::int32 var_504;
        wp::float32* var_505;
        wp::float32 var_506;
        wp::float32 var_507;
        wp::int32 var_508;
        wp::float32* var_509;
        wp::float32 var_510;
        wp::float32 var_511;
        wp::float32 var_512;
        wp::float32 var_513;
        wp::int32 var_514;
        wp::int32 var_515;
        wp::int32 var_516;
        wp::int32 var_517;
        wp::int32 var_518;
        const wp::int32 var_519 = 3;
        wp::int32 var_520;
        wp::int32 var_521;
        wp::int32 var_522;
        const wp::int32 var_523 = 2;
        wp::float32 var_524;
        wp::float32 var_525;
        wp::float32 var_526;
        wp::shape_t* var_527;
        const wp::int32 var_528 = 0;
        wp::int32 var_529;
        wp::shape_t var_530;
        wp::int32 var_531;
        bool var_532;
        const wp::int32 var_533 = 0;
        wp::int32 var_534;
        const wp::int32 var_535 = 3;
        wp::int32 var_536;
        wp::int32 var_537;
        wp::int32 var_538;
        wp::int32 var_539;
        const wp::int32 var_540 = 0;
        wp::int32 var_541;
        wp::float32* var_542;
        wp::float32 var_543;
        wp::float32 var_544;
        wp::int32 var_545;
        wp::float32* var_546;
        wp::float32 var_547;
        wp::float32 var_548;
        const wp::int32 var_549 = 1;
        wp::int32 var_550;
        wp::float32* var_551;
        wp::float32 var_552;
        wp::float32 var_553;
        wp::int32 var_554;
        wp::float32* var_555;
        wp::float32 var_556;
        wp::float32 var_557;
        const wp::int32 var_558 = 2;
        wp::int32 var_559;
        wp::float32* var_560;
        wp::float32 var_561;
        wp::float32 var_562;
        wp::int32 var_563;
        wp::float32* var_564;
        wp::float32 var_565;
        wp::float32 var_566;
        const wp::int32 var_567 = 3;
        wp::int32 var_568;
        wp::float32* var_569;
        wp::float32 var_570;
        wp::float32 var_571;
        wp::int32 var_572;
        wp::float32* var_573;
        wp::float32 var_574;
        wp::float32 var_575;
        const wp::int32 var_576 = 4;
        wp::int32 var_577;
        wp::float32* var_578;
        wp::float32 var_579;
        wp::float32 var_580;
        wp::int32 var_581;
        wp::float32* var_582;
        wp::float32 var_583;
        wp::float32 var_584;
        const wp::int32 var_585 = 5;
        wp::int32 var_586;
        wp::float32* var_587;
        wp::float32 var_588;
        wp::float32 var_589;
        wp::int32 var_590;
        wp::float32* var_591;
        wp::float32 var_592;
        wp::float32 var_593;
        const wp::int32 var_594 = 6;
        wp::int32 var_595;
        wp::float32* var_596;
        wp::float32 var_597;
        wp::float32 var_598;
        wp::int32 var_599;
        wp::float32* var_600;
        wp::float32 var_601;
        wp::float32 var_602;
        const wp::int32 var_603 = 7;
        wp::int32 var_604;
        wp::float32* var_605;
        wp::float32 var_606;
        wp::float32 var_607;
        wp::int32 var_608;
        wp::float32* var_609;
        wp::float32 var_610;
        wp::float32 var_611;
        const wp::int32 var_612 = 1;
        wp::int32 var_613;
        const wp::int32 var_614 = 3;
        wp::int32 var_615;
        wp::int32 var_616;
        wp::int32 var_617;
        wp::int32 var_618;
        const wp::int32 var_619 = 0;
        wp::int32 var_620;
        wp::float32* var_621;
        wp::float32 var_622;
        wp::float32 var_623;
        wp::int32 var_624;
        wp::float32* var_625;
        wp::float32 var_626;
        wp::float32 var_627;
        const wp::int32 var_628 = 1;
        wp::int32 var_629;
        wp::float32* var_630;
        wp::float32 var_631;
        wp::float32 var_632;
        wp::int32 var_633;
        wp::float32* var_634;
        wp::float32 var_635;
        wp::float32 var_636;
        const wp::int32 var_637 = 2;
        wp::int32 var_638;
        wp::float32* var_639;
        wp::float32 var_640;
        wp::float32 var_641;
        wp::int32 var_642;
        wp::float32* var_643;
        wp::float32 var_644;
        wp::float32 var_645;
        const wp::int32 var_646 = 3;
        wp::int32 var_647;
        wp::float32* var_648;
        wp::float32 var_649;
        wp::float32 var_650;
        wp::int32 var_651;
        wp::float32* var_652;
        wp::float32 var_653;
        wp::float32 var_654;
        const wp::int32 var_655 = 4;
        wp::int32 var_656;
        wp::float32* var_657;
        wp::float32 var_658;
        wp::float32 var_659;
        wp::int32 var_660;
        wp::float32* var_661;
        wp::float32 var_662;
        wp::float32 var_663;
        const wp::int32 var_664 = 5;
        wp::int32 var_665;
        wp::float32* var_666;
        wp::float32 var_667;
        wp::float32 var_668;
        wp::int32 var_669;
        wp::float32* var_670;
        wp::float32 var_671;
        wp::float32 var_672;
        const wp::int32 var_673 = 6;
        wp::int32 var_674;
        wp::float32* var_675;
        wp::float32 var_676;
        wp::float32 var_677;
        wp::int32 var_678;
        wp::float32* var_679;
        wp::float32 var_680;
        wp::float32 var_681;
        const wp::int32 var_682 = 7;
        wp::int32 var_683;
        wp::float32* var_684;
        wp::float32 var_685;
        wp::float32 var_686;
        wp::int32 var_687;
        wp::float32* var_688;
        wp::float32 var_689;
        wp::float32 var_690;
        const wp::int32 var_691 = 2;
        wp::int32 var_692;
        const wp::int32 var_693 = 3;
        wp::int32 var_694;
        wp::int32 var_695;
        wp::int32 var_696;
        wp::int32 var_697;
        const wp::int32 var_698 = 0;
        wp::int32 var_699;
        wp::float32* var_700;
        wp::float32 var_701;
        wp::float32 var_702;
        wp::int32 var_703;
        wp::float32* var_704;
        wp::float32 var_705;
        wp::float32 var_706;
        const wp::int32 var_707 = 1;
        wp::int32 var_708;
        wp::float32* var_709;
        wp::float32 var_710;
        wp::float32 var_711;
        wp::int32 var_712;
        wp::float32* var_713;
        wp::float32 var_714;
        wp::float32 var_715;
        const wp::int32 var_716 = 2;
        wp::int32 var_717;
        wp::float32* var_718;
        wp::float32 var_719;
        wp::float32 var_720;
        wp::int32 var_721;
        wp::float32* var_722;
        wp::float32 var_723;
        wp::float32 var_724;
        const wp::int32 var_725 = 3;
        wp::int32 var_726;
        wp::float32* var_727;
        wp::float32 var_728;
        wp::float32 var_729;
        wp::int32 var_730;
        wp::float32* var_731;
        wp::float32 var_732;
        wp::float32 var_733;
        const wp::int32 var_734 = 4;
        wp::int32 var_735;
        wp::float32* var_736;
        wp::float32 var_737;
        wp::float32 var_738;
        wp::int32 var_739;
        wp::float32* var_740;
        wp::float32 var_741;
        wp::float32 var_742;
        const wp::int32 var_743 = 5;
        wp::int32 var_744;
        wp::float32* var_745;
        wp::float32 var_746;
        wp::float32 var_747;
        wp::int32 var_748;
        wp::float32* var_749;
        wp::float32 var_750;
        wp::float32 var_751;
        const wp::int32 var_752 = 6;
        wp::int32 var_753;
        wp::float32* var_754;
        wp::float32 var_755;
        wp::float32 var_756;
        wp::int32 var_757;
        wp::float32* var_758;
        wp::float32 var_759;
        wp::float32 var_760;
        const wp::int32 var_761 = 7;
        wp::int32 var_762;
        wp::float32* var_763;
        wp::float32 var_764;
        wp::float32 var_765;
        wp::int32 var_766;
        wp::float32* var_767;
        wp::float32 var_768;
        wp::float32 var_769;
        wp::float32 var_770;
        wp::float32 var_771;
        wp::int32 var_772;
        wp::int32 var_773;
        wp::int32 var_774;
        wp::int32 var_775;
        wp::int32 var_776;
        const wp::int32 var_777 = 3;
        wp::int32 var_778;
        wp::int32 var_779;
        wp::int32 var_780;
        //---------
        // forward
        // def bound_leaves_kernel(corners: array(dtype=float32), boxes: array(dtype=float32)):       <L 199>
        // i = tid()                                                                              <L 200>
        var_0 = builtin_tid1d();
        // at = (i // FAN) * SIDES + i % FAN                                                      <L 201>
        var_2 = wp::floordiv(var_0, var_1);
        var_4 = wp::mul(var_2, var_3);
        var_5 = wp::mod(var_0, var_1);
        var_6 = wp::add(var_4, var_5);
        // for axis in range(3):                                                                  <L 202>
        // low = float(INFINITY)                                                                  <L 203>
        var_9 = wp::float(var_8);
        // high = -float(INFINITY)                                                                <L 204>
        var_10 = wp::float(var_8);
        var_11 = wp::neg(var_10);
        // if i < corners.shape[0] // LEAF_NUMBERS:                                               <L 205>
        var_12 = &(var_corners.shape);
        var_15 = wp::load(var_12);
        var_14 = wp::extract(var_15, var_13);
        var_17 = wp::floordiv(var_14, var_16);
        var_18 = (var_0 < var_17);
        if (var_18) {
            // for corner in range(3):                                                            <L 206>
            // first = i * LEAF_NUMBERS + (3 * corner + axis) * LEAF                              <L 207>
            var_20 = wp::mul(var_0, var_16);
            var_22 = wp::mul(var_21, var_19);
            var_23 = wp::add(var_22, var_7);
            var_25 = wp::mul(var_23, var_24);
            var_26 = wp::add(var_20, var_25);
            // for lane in range(LEAF):                                                           <L 208>
            // low = min(low, corners[first + lane])                                              <L 209>
            var_28 = wp::add(var_26, var_27);
            var_29 = wp::address(var_corners, var_28);
            var_31 = wp::load(var_29);
            var_30 = wp::min(var_9, var_31);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_32 = wp::add(var_26, var_27);
            var_33 = wp::address(var_corners, var_32);
            var_35 = wp::load(var_33);
            var_34 = wp::max(var_11, var_35);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_37 = wp::add(var_26, var_36);
            var_38 = wp::address(var_corners, var_37);
            var_40 = wp::load(var_38);
            var_39 = wp::min(var_30, var_40);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_41 = wp::add(var_26, var_36);
            var_42 = wp::address(var_corners, var_41);
            var_44 = wp::load(var_42);
            var_43 = wp::max(var_34, var_44);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_46 = wp::add(var_26, var_45);
            var_47 = wp::address(var_corners, var_46);
            var_49 = wp::load(var_47);
            var_48 = wp::min(var_39, var_49);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_50 = wp::add(var_26, var_45);
            var_51 = wp::address(var_corners, var_50);
            var_53 = wp::load(var_51);
            var_52 = wp::max(var_43, var_53);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_55 = wp::add(var_26, var_54);
            var_56 = wp::address(var_corners, var_55);
            var_58 = wp::load(var_56);
            var_57 = wp::min(var_48, var_58);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_59 = wp::add(var_26, var_54);
            var_60 = wp::address(var_corners, var_59);
            var_62 = wp::load(var_60);
            var_61 = wp::max(var_52, var_62);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_64 = wp::add(var_26, var_63);
            var_65 = wp::address(var_corners, var_64);
            var_67 = wp::load(var_65);
            var_66 = wp::min(var_57, var_67);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_68 = wp::add(var_26, var_63);
            var_69 = wp::address(var_corners, var_68);
            var_71 = wp::load(var_69);
            var_70 = wp::max(var_61, var_71);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_73 = wp::add(var_26, var_72);
            var_74 = wp::address(var_corners, var_73);
            var_76 = wp::load(var_74);
            var_75 = wp::min(var_66, var_76);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_77 = wp::add(var_26, var_72);
            var_78 = wp::address(var_corners, var_77);
            var_80 = wp::load(var_78);
            var_79 = wp::max(var_70, var_80);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_82 = wp::add(var_26, var_81);
            var_83 = wp::address(var_corners, var_82);
            var_85 = wp::load(var_83);
            var_84 = wp::min(var_75, var_85);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_86 = wp::add(var_26, var_81);
            var_87 = wp::address(var_corners, var_86);
            var_89 = wp::load(var_87);
            var_88 = wp::max(var_79, var_89);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_91 = wp::add(var_26, var_90);
            var_92 = wp::address(var_corners, var_91);
            var_94 = wp::load(var_92);
            var_93 = wp::min(var_84, var_94);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_95 = wp::add(var_26, var_90);
            var_96 = wp::address(var_corners, var_95);
            var_98 = wp::load(var_96);
            var_97 = wp::max(var_88, var_98);
            // first = i * LEAF_NUMBERS + (3 * corner + axis) * LEAF                              <L 207>
            var_100 = wp::mul(var_0, var_16);
            var_102 = wp::mul(var_101, var_99);
            var_103 = wp::add(var_102, var_7);
            var_104 = wp::mul(var_103, var_24);
            var_105 = wp::add(var_100, var_104);
            // for lane in range(LEAF):                                                           <L 208>
            // low = min(low, corners[first + lane])                                              <L 209>
            var_107 = wp::add(var_105, var_106);
            var_108 = wp::address(var_corners, var_107);
            var_110 = wp::load(var_108);
            var_109 = wp::min(var_93, var_110);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_111 = wp::add(var_105, var_106);
            var_112 = wp::address(var_corners, var_111);
            var_114 = wp::load(var_112);
            var_113 = wp::max(var_97, var_114);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_116 = wp::add(var_105, var_115);
            var_117 = wp::address(var_corners, var_116);
            var_119 = wp::load(var_117);
            var_118 = wp::min(var_109, var_119);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_120 = wp::add(var_105, var_115);
            var_121 = wp::address(var_corners, var_120);
            var_123 = wp::load(var_121);
            var_122 = wp::max(var_113, var_123);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_125 = wp::add(var_105, var_124);
            var_126 = wp::address(var_corners, var_125);
            var_128 = wp::load(var_126);
            var_127 = wp::min(var_118, var_128);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_129 = wp::add(var_105, var_124);
            var_130 = wp::address(var_corners, var_129);
            var_132 = wp::load(var_130);
            var_131 = wp::max(var_122, var_132);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_134 = wp::add(var_105, var_133);
            var_135 = wp::address(var_corners, var_134);
            var_137 = wp::load(var_135);
            var_136 = wp::min(var_127, var_137);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_138 = wp::add(var_105, var_133);
            var_139 = wp::address(var_corners, var_138);
            var_141 = wp::load(var_139);
            var_140 = wp::max(var_131, var_141);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_143 = wp::add(var_105, var_142);
            var_144 = wp::address(var_corners, var_143);
            var_146 = wp::load(var_144);
            var_145 = wp::min(var_136, var_146);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_147 = wp::add(var_105, var_142);
            var_148 = wp::address(var_corners, var_147);
            var_150 = wp::load(var_148);
            var_149 = wp::max(var_140, var_150);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_152 = wp::add(var_105, var_151);
            var_153 = wp::address(var_corners, var_152);
            var_155 = wp::load(var_153);
            var_154 = wp::min(var_145, var_155);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_156 = wp::add(var_105, var_151);
            var_157 = wp::address(var_corners, var_156);
            var_159 = wp::load(var_157);
            var_158 = wp::max(var_149, var_159);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_161 = wp::add(var_105, var_160);
            var_162 = wp::address(var_corners, var_161);
            var_164 = wp::load(var_162);
            var_163 = wp::min(var_154, var_164);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_165 = wp::add(var_105, var_160);
            var_166 = wp::address(var_corners, var_165);
            var_168 = wp::load(var_166);
            var_167 = wp::max(var_158, var_168);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_170 = wp::add(var_105, var_169);
            var_171 = wp::address(var_corners, var_170);
            var_173 = wp::load(var_171);
            var_172 = wp::min(var_163, var_173);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_174 = wp::add(var_105, var_169);
            var_175 = wp::address(var_corners, var_174);
            var_177 = wp::load(var_175);
            var_176 = wp::max(var_167, var_177);
            // first = i * LEAF_NUMBERS + (3 * corner + axis) * LEAF                              <L 207>
            var_179 = wp::mul(var_0, var_16);
            var_181 = wp::mul(var_180, var_178);
            var_182 = wp::add(var_181, var_7);
            var_183 = wp::mul(var_182, var_24);
            var_184 = wp::add(var_179, var_183);
            // for lane in range(LEAF):                                                           <L 208>
            // low = min(low, corners[first + lane])                                              <L 209>
            var_186 = wp::add(var_184, var_185);
            var_187 = wp::address(var_corners, var_186);
            var_189 = wp::load(var_187);
            var_188 = wp::min(var_172, var_189);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_190 = wp::add(var_184, var_185);
            var_191 = wp::address(var_corners, var_190);
            var_193 = wp::load(var_191);
            var_192 = wp::max(var_176, var_193);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_195 = wp::add(var_184, var_194);
            var_196 = wp::address(var_corners, var_195);
            var_198 = wp::load(var_196);
            var_197 = wp::min(var_188, var_198);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_199 = wp::add(var_184, var_194);
            var_200 = wp::address(var_corners, var_199);
            var_202 = wp::load(var_200);
            var_201 = wp::max(var_192, var_202);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_204 = wp::add(var_184, var_203);
            var_205 = wp::address(var_corners, var_204);
            var_207 = wp::load(var_205);
            var_206 = wp::min(var_197, var_207);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_208 = wp::add(var_184, var_203);
            var_209 = wp::address(var_corners, var_208);
            var_211 = wp::load(var_209);
            var_210 = wp::max(var_201, var_211);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_213 = wp::add(var_184, var_212);
            var_214 = wp::address(var_corners, var_213);
            var_216 = wp::load(var_214);
            var_215 = wp::min(var_206, var_216);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_217 = wp::add(var_184, var_212);
            var_218 = wp::address(var_corners, var_217);
            var_220 = wp::load(var_218);
            var_219 = wp::max(var_210, var_220);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_222 = wp::add(var_184, var_221);
            var_223 = wp::address(var_corners, var_222);
            var_225 = wp::load(var_223);
            var_224 = wp::min(var_215, var_225);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_226 = wp::add(var_184, var_221);
            var_227 = wp::address(var_corners, var_226);
            var_229 = wp::load(var_227);
            var_228 = wp::max(var_219, var_229);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_231 = wp::add(var_184, var_230);
            var_232 = wp::address(var_corners, var_231);
            var_234 = wp::load(var_232);
            var_233 = wp::min(var_224, var_234);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_235 = wp::add(var_184, var_230);
            var_236 = wp::address(var_corners, var_235);
            var_238 = wp::load(var_236);
            var_237 = wp::max(var_228, var_238);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_240 = wp::add(var_184, var_239);
            var_241 = wp::address(var_corners, var_240);
            var_243 = wp::load(var_241);
            var_242 = wp::min(var_233, var_243);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_244 = wp::add(var_184, var_239);
            var_245 = wp::address(var_corners, var_244);
            var_247 = wp::load(var_245);
            var_246 = wp::max(var_237, var_247);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_249 = wp::add(var_184, var_248);
            var_250 = wp::address(var_corners, var_249);
            var_252 = wp::load(var_250);
            var_251 = wp::min(var_242, var_252);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_253 = wp::add(var_184, var_248);
            var_254 = wp::address(var_corners, var_253);
            var_256 = wp::load(var_254);
            var_255 = wp::max(var_246, var_256);
        }
        var_257 = wp::where(var_18, var_251, var_9);
        var_258 = wp::where(var_18, var_255, var_11);
        // boxes[at + axis * FAN] = low                                                           <L 211>
        var_259 = wp::mul(var_7, var_1);
        var_260 = wp::add(var_6, var_259);
        wp::array_store(var_boxes, var_260, var_257);
        // boxes[at + (axis + 3) * FAN] = high                                                    <L 212>
        var_262 = wp::add(var_7, var_261);
        var_263 = wp::mul(var_262, var_1);
        var_264 = wp::add(var_6, var_263);
        wp::array_store(var_boxes, var_264, var_258);
        // low = float(INFINITY)                                                                  <L 203>
        var_266 = wp::float(var_8);
        // high = -float(INFINITY)                                                                <L 204>
        var_267 = wp::float(var_8);
        var_268 = wp::neg(var_267);
        // if i < corners.shape[0] // LEAF_NUMBERS:                                               <L 205>
        var_269 = &(var_corners.shape);
        var_272 = wp::load(var_269);
        var_271 = wp::extract(var_272, var_270);
        var_273 = wp::floordiv(var_271, var_16);
        var_274 = (var_0 < var_273);
        if (var_274) {
            // for corner in range(3):                                                            <L 206>
            // first = i * LEAF_NUMBERS + (3 * corner + axis) * LEAF                              <L 207>
            var_276 = wp::mul(var_0, var_16);
            var_278 = wp::mul(var_277, var_275);
            var_279 = wp::add(var_278, var_265);
            var_280 = wp::mul(var_279, var_24);
            var_281 = wp::add(var_276, var_280);
            // for lane in range(LEAF):                                                           <L 208>
            // low = min(low, corners[first + lane])                                              <L 209>
            var_283 = wp::add(var_281, var_282);
            var_284 = wp::address(var_corners, var_283);
            var_286 = wp::load(var_284);
            var_285 = wp::min(var_266, var_286);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_287 = wp::add(var_281, var_282);
            var_288 = wp::address(var_corners, var_287);
            var_290 = wp::load(var_288);
            var_289 = wp::max(var_268, var_290);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_292 = wp::add(var_281, var_291);
            var_293 = wp::address(var_corners, var_292);
            var_295 = wp::load(var_293);
            var_294 = wp::min(var_285, var_295);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_296 = wp::add(var_281, var_291);
            var_297 = wp::address(var_corners, var_296);
            var_299 = wp::load(var_297);
            var_298 = wp::max(var_289, var_299);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_301 = wp::add(var_281, var_300);
            var_302 = wp::address(var_corners, var_301);
            var_304 = wp::load(var_302);
            var_303 = wp::min(var_294, var_304);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_305 = wp::add(var_281, var_300);
            var_306 = wp::address(var_corners, var_305);
            var_308 = wp::load(var_306);
            var_307 = wp::max(var_298, var_308);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_310 = wp::add(var_281, var_309);
            var_311 = wp::address(var_corners, var_310);
            var_313 = wp::load(var_311);
            var_312 = wp::min(var_303, var_313);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_314 = wp::add(var_281, var_309);
            var_315 = wp::address(var_corners, var_314);
            var_317 = wp::load(var_315);
            var_316 = wp::max(var_307, var_317);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_319 = wp::add(var_281, var_318);
            var_320 = wp::address(var_corners, var_319);
            var_322 = wp::load(var_320);
            var_321 = wp::min(var_312, var_322);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_323 = wp::add(var_281, var_318);
            var_324 = wp::address(var_corners, var_323);
            var_326 = wp::load(var_324);
            var_325 = wp::max(var_316, var_326);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_328 = wp::add(var_281, var_327);
            var_329 = wp::address(var_corners, var_328);
            var_331 = wp::load(var_329);
            var_330 = wp::min(var_321, var_331);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_332 = wp::add(var_281, var_327);
            var_333 = wp::address(var_corners, var_332);
            var_335 = wp::load(var_333);
            var_334 = wp::max(var_325, var_335);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_337 = wp::add(var_281, var_336);
            var_338 = wp::address(var_corners, var_337);
            var_340 = wp::load(var_338);
            var_339 = wp::min(var_330, var_340);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_341 = wp::add(var_281, var_336);
            var_342 = wp::address(var_corners, var_341);
            var_344 = wp::load(var_342);
            var_343 = wp::max(var_334, var_344);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_346 = wp::add(var_281, var_345);
            var_347 = wp::address(var_corners, var_346);
            var_349 = wp::load(var_347);
            var_348 = wp::min(var_339, var_349);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_350 = wp::add(var_281, var_345);
            var_351 = wp::address(var_corners, var_350);
            var_353 = wp::load(var_351);
            var_352 = wp::max(var_343, var_353);
            // first = i * LEAF_NUMBERS + (3 * corner + axis) * LEAF                              <L 207>
            var_355 = wp::mul(var_0, var_16);
            var_357 = wp::mul(var_356, var_354);
            var_358 = wp::add(var_357, var_265);
            var_359 = wp::mul(var_358, var_24);
            var_360 = wp::add(var_355, var_359);
            // for lane in range(LEAF):                                                           <L 208>
            // low = min(low, corners[first + lane])                                              <L 209>
            var_362 = wp::add(var_360, var_361);
            var_363 = wp::address(var_corners, var_362);
            var_365 = wp::load(var_363);
            var_364 = wp::min(var_348, var_365);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_366 = wp::add(var_360, var_361);
            var_367 = wp::address(var_corners, var_366);
            var_369 = wp::load(var_367);
            var_368 = wp::max(var_352, var_369);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_371 = wp::add(var_360, var_370);
            var_372 = wp::address(var_corners, var_371);
            var_374 = wp::load(var_372);
            var_373 = wp::min(var_364, var_374);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_375 = wp::add(var_360, var_370);
            var_376 = wp::address(var_corners, var_375);
            var_378 = wp::load(var_376);
            var_377 = wp::max(var_368, var_378);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_380 = wp::add(var_360, var_379);
            var_381 = wp::address(var_corners, var_380);
            var_383 = wp::load(var_381);
            var_382 = wp::min(var_373, var_383);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_384 = wp::add(var_360, var_379);
            var_385 = wp::address(var_corners, var_384);
            var_387 = wp::load(var_385);
            var_386 = wp::max(var_377, var_387);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_389 = wp::add(var_360, var_388);
            var_390 = wp::address(var_corners, var_389);
            var_392 = wp::load(var_390);
            var_391 = wp::min(var_382, var_392);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_393 = wp::add(var_360, var_388);
            var_394 = wp::address(var_corners, var_393);
            var_396 = wp::load(var_394);
            var_395 = wp::max(var_386, var_396);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_398 = wp::add(var_360, var_397);
            var_399 = wp::address(var_corners, var_398);
            var_401 = wp::load(var_399);
            var_400 = wp::min(var_391, var_401);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_402 = wp::add(var_360, var_397);
            var_403 = wp::address(var_corners, var_402);
            var_405 = wp::load(var_403);
            var_404 = wp::max(var_395, var_405);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_407 = wp::add(var_360, var_406);
            var_408 = wp::address(var_corners, var_407);
            var_410 = wp::load(var_408);
            var_409 = wp::min(var_400, var_410);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_411 = wp::add(var_360, var_406);
            var_412 = wp::address(var_corners, var_411);
            var_414 = wp::load(var_412);
            var_413 = wp::max(var_404, var_414);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_416 = wp::add(var_360, var_415);
            var_417 = wp::address(var_corners, var_416);
            var_419 = wp::load(var_417);
            var_418 = wp::min(var_409, var_419);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_420 = wp::add(var_360, var_415);
            var_421 = wp::address(var_corners, var_420);
            var_423 = wp::load(var_421);
            var_422 = wp::max(var_413, var_423);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_425 = wp::add(var_360, var_424);
            var_426 = wp::address(var_corners, var_425);
            var_428 = wp::load(var_426);
            var_427 = wp::min(var_418, var_428);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_429 = wp::add(var_360, var_424);
            var_430 = wp::address(var_corners, var_429);
            var_432 = wp::load(var_430);
            var_431 = wp::max(var_422, var_432);
            // first = i * LEAF_NUMBERS + (3 * corner + axis) * LEAF                              <L 207>
            var_434 = wp::mul(var_0, var_16);
            var_436 = wp::mul(var_435, var_433);
            var_437 = wp::add(var_436, var_265);
            var_438 = wp::mul(var_437, var_24);
            var_439 = wp::add(var_434, var_438);
            // for lane in range(LEAF):                                                           <L 208>
            // low = min(low, corners[first + lane])                                              <L 209>
            var_441 = wp::add(var_439, var_440);
            var_442 = wp::address(var_corners, var_441);
            var_444 = wp::load(var_442);
            var_443 = wp::min(var_427, var_444);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_445 = wp::add(var_439, var_440);
            var_446 = wp::address(var_corners, var_445);
            var_448 = wp::load(var_446);
            var_447 = wp::max(var_431, var_448);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_450 = wp::add(var_439, var_449);
            var_451 = wp::address(var_corners, var_450);
            var_453 = wp::load(var_451);
            var_452 = wp::min(var_443, var_453);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_454 = wp::add(var_439, var_449);
            var_455 = wp::address(var_corners, var_454);
            var_457 = wp::load(var_455);
            var_456 = wp::max(var_447, var_457);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_459 = wp::add(var_439, var_458);
            var_460 = wp::address(var_corners, var_459);
            var_462 = wp::load(var_460);
            var_461 = wp::min(var_452, var_462);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_463 = wp::add(var_439, var_458);
            var_464 = wp::address(var_corners, var_463);
            var_466 = wp::load(var_464);
            var_465 = wp::max(var_456, var_466);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_468 = wp::add(var_439, var_467);
            var_469 = wp::address(var_corners, var_468);
            var_471 = wp::load(var_469);
            var_470 = wp::min(var_461, var_471);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_472 = wp::add(var_439, var_467);
            var_473 = wp::address(var_corners, var_472);
            var_475 = wp::load(var_473);
            var_474 = wp::max(var_465, var_475);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_477 = wp::add(var_439, var_476);
            var_478 = wp::address(var_corners, var_477);
            var_480 = wp::load(var_478);
            var_479 = wp::min(var_470, var_480);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_481 = wp::add(var_439, var_476);
            var_482 = wp::address(var_corners, var_481);
            var_484 = wp::load(var_482);
            var_483 = wp::max(var_474, var_484);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_486 = wp::add(var_439, var_485);
            var_487 = wp::address(var_corners, var_486);
            var_489 = wp::load(var_487);
            var_488 = wp::min(var_479, var_489);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_490 = wp::add(var_439, var_485);
            var_491 = wp::address(var_corners, var_490);
            var_493 = wp::load(var_491);
            var_492 = wp::max(var_483, var_493);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_495 = wp::add(var_439, var_494);
            var_496 = wp::address(var_corners, var_495);
            var_498 = wp::load(var_496);
            var_497 = wp::min(var_488, var_498);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_499 = wp::add(var_439, var_494);
            var_500 = wp::address(var_corners, var_499);
            var_502 = wp::load(var_500);
            var_501 = wp::max(var_492, var_502);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_504 = wp::add(var_439, var_503);
            var_505 = wp::address(var_corners, var_504);
            var_507 = wp::load(var_505);
            var_506 = wp::min(var_497, var_507);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_508 = wp::add(var_439, var_503);
            var_509 = wp::address(var_corners, var_508);
            var_511 = wp::load(var_509);
            var_510 = wp::max(var_501, var_511);
        }
        var_512 = wp::where(var_274, var_506, var_266);
        var_513 = wp::where(var_274, var_510, var_268);
        var_514 = wp::where(var_274, var_433, var_178);
        var_515 = wp::where(var_274, var_439, var_184);
        var_516 = wp::where(var_274, var_503, var_248);
        // boxes[at + axis * FAN] = low                                                           <L 211>
        var_517 = wp::mul(var_265, var_1);
        var_518 = wp::add(var_6, var_517);
        wp::array_store(var_boxes, var_518, var_512);
        // boxes[at + (axis + 3) * FAN] = high                                                    <L 212>
        var_520 = wp::add(var_265, var_519);
        var_521 = wp::mul(var_520, var_1);
        var_522 = wp::add(var_6, var_521);
        wp::array_store(var_boxes, var_522, var_513);
        // low = float(INFINITY)                                                                  <L 203>
        var_524 = wp::float(var_8);
        // high = -float(INFINITY)                                                                <L 204>
        var_525 = wp::float(var_8);
        var_526 = wp::neg(var_525);
        // if i < corners.shape[0] // LEAF_NUMBERS:                                               <L 205>
        var_527 = &(var_corners.shape);
        var_530 = wp::load(var_527);
        var_529 = wp::extract(var_530, var_528);
        var_531 = wp::floordiv(var_529, var_16);
        var_532 = (var_0 < var_531);
        if (var_532) {
            // for corner in range(3):                                                            <L 206>
            // first = i * LEAF_NUMBERS + (3 * corner + axis) * LEAF                              <L 207>
            var_534 = wp::mul(var_0, var_16);
            var_536 = wp::mul(var_535, var_533);
            var_537 = wp::add(var_536, var_523);
            var_538 = wp::mul(var_537, var_24);
            var_539 = wp::add(var_534, var_538);
            // for lane in range(LEAF):                                                           <L 208>
            // low = min(low, corners[first + lane])                                              <L 209>
            var_541 = wp::add(var_539, var_540);
            var_542 = wp::address(var_corners, var_541);
            var_544 = wp::load(var_542);
            var_543 = wp::min(var_524, var_544);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_545 = wp::add(var_539, var_540);
            var_546 = wp::address(var_corners, var_545);
            var_548 = wp::load(var_546);
            var_547 = wp::max(var_526, var_548);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_550 = wp::add(var_539, var_549);
            var_551 = wp::address(var_corners, var_550);
            var_553 = wp::load(var_551);
            var_552 = wp::min(var_543, var_553);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_554 = wp::add(var_539, var_549);
            var_555 = wp::address(var_corners, var_554);
            var_557 = wp::load(var_555);
            var_556 = wp::max(var_547, var_557);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_559 = wp::add(var_539, var_558);
            var_560 = wp::address(var_corners, var_559);
            var_562 = wp::load(var_560);
            var_561 = wp::min(var_552, var_562);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_563 = wp::add(var_539, var_558);
            var_564 = wp::address(var_corners, var_563);
            var_566 = wp::load(var_564);
            var_565 = wp::max(var_556, var_566);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_568 = wp::add(var_539, var_567);
            var_569 = wp::address(var_corners, var_568);
            var_571 = wp::load(var_569);
            var_570 = wp::min(var_561, var_571);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_572 = wp::add(var_539, var_567);
            var_573 = wp::address(var_corners, var_572);
            var_575 = wp::load(var_573);
            var_574 = wp::max(var_565, var_575);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_577 = wp::add(var_539, var_576);
            var_578 = wp::address(var_corners, var_577);
            var_580 = wp::load(var_578);
            var_579 = wp::min(var_570, var_580);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_581 = wp::add(var_539, var_576);
            var_582 = wp::address(var_corners, var_581);
            var_584 = wp::load(var_582);
            var_583 = wp::max(var_574, var_584);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_586 = wp::add(var_539, var_585);
            var_587 = wp::address(var_corners, var_586);
            var_589 = wp::load(var_587);
            var_588 = wp::min(var_579, var_589);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_590 = wp::add(var_539, var_585);
            var_591 = wp::address(var_corners, var_590);
            var_593 = wp::load(var_591);
            var_592 = wp::max(var_583, var_593);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_595 = wp::add(var_539, var_594);
            var_596 = wp::address(var_corners, var_595);
            var_598 = wp::load(var_596);
            var_597 = wp::min(var_588, var_598);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_599 = wp::add(var_539, var_594);
            var_600 = wp::address(var_corners, var_599);
            var_602 = wp::load(var_600);
            var_601 = wp::max(var_592, var_602);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_604 = wp::add(var_539, var_603);
            var_605 = wp::address(var_corners, var_604);
            var_607 = wp::load(var_605);
            var_606 = wp::min(var_597, var_607);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_608 = wp::add(var_539, var_603);
            var_609 = wp::address(var_corners, var_608);
            var_611 = wp::load(var_609);
            var_610 = wp::max(var_601, var_611);
            // first = i * LEAF_NUMBERS + (3 * corner + axis) * LEAF                              <L 207>
            var_613 = wp::mul(var_0, var_16);
            var_615 = wp::mul(var_614, var_612);
            var_616 = wp::add(var_615, var_523);
            var_617 = wp::mul(var_616, var_24);
            var_618 = wp::add(var_613, var_617);
            // for lane in range(LEAF):                                                           <L 208>
            // low = min(low, corners[first + lane])                                              <L 209>
            var_620 = wp::add(var_618, var_619);
            var_621 = wp::address(var_corners, var_620);
            var_623 = wp::load(var_621);
            var_622 = wp::min(var_606, var_623);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_624 = wp::add(var_618, var_619);
            var_625 = wp::address(var_corners, var_624);
            var_627 = wp::load(var_625);
            var_626 = wp::max(var_610, var_627);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_629 = wp::add(var_618, var_628);
            var_630 = wp::address(var_corners, var_629);
            var_632 = wp::load(var_630);
            var_631 = wp::min(var_622, var_632);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_633 = wp::add(var_618, var_628);
            var_634 = wp::address(var_corners, var_633);
            var_636 = wp::load(var_634);
            var_635 = wp::max(var_626, var_636);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_638 = wp::add(var_618, var_637);
            var_639 = wp::address(var_corners, var_638);
            var_641 = wp::load(var_639);
            var_640 = wp::min(var_631, var_641);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_642 = wp::add(var_618, var_637);
            var_643 = wp::address(var_corners, var_642);
            var_645 = wp::load(var_643);
            var_644 = wp::max(var_635, var_645);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_647 = wp::add(var_618, var_646);
            var_648 = wp::address(var_corners, var_647);
            var_650 = wp::load(var_648);
            var_649 = wp::min(var_640, var_650);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_651 = wp::add(var_618, var_646);
            var_652 = wp::address(var_corners, var_651);
            var_654 = wp::load(var_652);
            var_653 = wp::max(var_644, var_654);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_656 = wp::add(var_618, var_655);
            var_657 = wp::address(var_corners, var_656);
            var_659 = wp::load(var_657);
            var_658 = wp::min(var_649, var_659);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_660 = wp::add(var_618, var_655);
            var_661 = wp::address(var_corners, var_660);
            var_663 = wp::load(var_661);
            var_662 = wp::max(var_653, var_663);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_665 = wp::add(var_618, var_664);
            var_666 = wp::address(var_corners, var_665);
            var_668 = wp::load(var_666);
            var_667 = wp::min(var_658, var_668);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_669 = wp::add(var_618, var_664);
            var_670 = wp::address(var_corners, var_669);
            var_672 = wp::load(var_670);
            var_671 = wp::max(var_662, var_672);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_674 = wp::add(var_618, var_673);
            var_675 = wp::address(var_corners, var_674);
            var_677 = wp::load(var_675);
            var_676 = wp::min(var_667, var_677);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_678 = wp::add(var_618, var_673);
            var_679 = wp::address(var_corners, var_678);
            var_681 = wp::load(var_679);
            var_680 = wp::max(var_671, var_681);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_683 = wp::add(var_618, var_682);
            var_684 = wp::address(var_corners, var_683);
            var_686 = wp::load(var_684);
            var_685 = wp::min(var_676, var_686);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_687 = wp::add(var_618, var_682);
            var_688 = wp::address(var_corners, var_687);
            var_690 = wp::load(var_688);
            var_689 = wp::max(var_680, var_690);
            // first = i * LEAF_NUMBERS + (3 * corner + axis) * LEAF                              <L 207>
            var_692 = wp::mul(var_0, var_16);
            var_694 = wp::mul(var_693, var_691);
            var_695 = wp::add(var_694, var_523);
            var_696 = wp::mul(var_695, var_24);
            var_697 = wp::add(var_692, var_696);
            // for lane in range(LEAF):                                                           <L 208>
            // low = min(low, corners[first + lane])                                              <L 209>
            var_699 = wp::add(var_697, var_698);
            var_700 = wp::address(var_corners, var_699);
            var_702 = wp::load(var_700);
            var_701 = wp::min(var_685, var_702);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_703 = wp::add(var_697, var_698);
            var_704 = wp::address(var_corners, var_703);
            var_706 = wp::load(var_704);
            var_705 = wp::max(var_689, var_706);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_708 = wp::add(var_697, var_707);
            var_709 = wp::address(var_corners, var_708);
            var_711 = wp::load(var_709);
            var_710 = wp::min(var_701, var_711);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_712 = wp::add(var_697, var_707);
            var_713 = wp::address(var_corners, var_712);
            var_715 = wp::load(var_713);
            var_714 = wp::max(var_705, var_715);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_717 = wp::add(var_697, var_716);
            var_718 = wp::address(var_corners, var_717);
            var_720 = wp::load(var_718);
            var_719 = wp::min(var_710, var_720);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_721 = wp::add(var_697, var_716);
            var_722 = wp::address(var_corners, var_721);
            var_724 = wp::load(var_722);
            var_723 = wp::max(var_714, var_724);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_726 = wp::add(var_697, var_725);
            var_727 = wp::address(var_corners, var_726);
            var_729 = wp::load(var_727);
            var_728 = wp::min(var_719, var_729);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_730 = wp::add(var_697, var_725);
            var_731 = wp::address(var_corners, var_730);
            var_733 = wp::load(var_731);
            var_732 = wp::max(var_723, var_733);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_735 = wp::add(var_697, var_734);
            var_736 = wp::address(var_corners, var_735);
            var_738 = wp::load(var_736);
            var_737 = wp::min(var_728, var_738);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_739 = wp::add(var_697, var_734);
            var_740 = wp::address(var_corners, var_739);
            var_742 = wp::load(var_740);
            var_741 = wp::max(var_732, var_742);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_744 = wp::add(var_697, var_743);
            var_745 = wp::address(var_corners, var_744);
            var_747 = wp::load(var_745);
            var_746 = wp::min(var_737, var_747);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_748 = wp::add(var_697, var_743);
            var_749 = wp::address(var_corners, var_748);
            var_751 = wp::load(var_749);
            var_750 = wp::max(var_741, var_751);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_753 = wp::add(var_697, var_752);
            var_754 = wp::address(var_corners, var_753);
            var_756 = wp::load(var_754);
            var_755 = wp::min(var_746, var_756);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_757 = wp::add(var_697, var_752);
            var_758 = wp::address(var_corners, var_757);
            var_760 = wp::load(var_758);
            var_759 = wp::max(var_750, var_760);
            // low = min(low, corners[first + lane])                                              <L 209>
            var_762 = wp::add(var_697, var_761);
            var_763 = wp::address(var_corners, var_762);
            var_765 = wp::load(var_763);
            var_764 = wp::min(var_755, var_765);
            // high = max(high, corners[first + lane])                                            <L 210>
            var_766 = wp::add(var_697, var_761);
            var_767 = wp::address(var_corners, var_766);
            var_769 = wp::load(var_767);
            var_768 = wp::max(var_759, var_769);
        }
        var_770 = wp::where(var_532, var_764, var_524);
        var_771 = wp::where(var_532, var_768, var_526);
        var_772 = wp::where(var_532, var_691, var_514);
        var_773 = wp::where(var_532, var_697, var_515);
        var_774 = wp::where(var_532, var_761, var_516);
        // boxes[at + axis * FAN] = low                                                           <L 211>
        var_775 = wp::mul(var_523, var_1);
        var_776 = wp::add(var_6, var_775);
        wp::array_store(var_boxes, var_776, var_770);
        // boxes[at + (axis + 3) * FAN] = high                                                    <L 212>
        var_778 = wp::add(var_523, var_777);
        var_779 = wp::mul(var_778, var_1);
        var_780 = wp::add(var_6, var_779);
        wp::array_store(var_boxes, var_780, var_771);
}



extern "C" __global__ void find_middles_kernel_48cdb7f3_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_vertices,
    wp::array_t<wp::vec_t<3, wp::int32>> var_triangles,
    wp::array_t<wp::vec_t<3, wp::float32>> var_middles)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::vec_t<3, wp::int32>* var_1;
        wp::vec_t<3, wp::int32> var_2;
        wp::vec_t<3, wp::int32> var_3;
        const wp::int32 var_4 = 0;
        wp::int32 var_5;
        wp::vec_t<3, wp::float32>* var_6;
        wp::vec_t<3, wp::float32> var_7;
        wp::vec_t<3, wp::float32> var_8;
        const wp::int32 var_9 = 1;
        wp::int32 var_10;
        wp::vec_t<3, wp::float32>* var_11;
        wp::vec_t<3, wp::float32> var_12;
        wp::vec_t<3, wp::float32> var_13;
        const wp::int32 var_14 = 2;
        wp::int32 var_15;
        wp::vec_t<3, wp::float32>* var_16;
        wp::vec_t<3, wp::float32> var_17;
        wp::vec_t<3, wp::float32> var_18;
        const wp::float32 var_19 = NAN;
        wp::vec_t<3, wp::float32> var_20;
        bool var_21;
        bool var_22;
        bool var_23;
        bool var_24;
        wp::vec_t<3, wp::float32> var_25;
        wp::vec_t<3, wp::float32> var_26;
        //---------
        // forward
        // def find_middles_kernel(vertices: array(dtype=vec3), triangles: array(dtype=vec3i), middles: array(dtype=vec3)):       <L 136>
        // i = tid()                                                                              <L 138>
        var_0 = builtin_tid1d();
        // t = triangles[i]                                                                       <L 139>
        var_1 = wp::address(var_triangles, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // a = vertices[t[0]]                                                                     <L 140>
        var_5 = wp::extract(var_2, var_4);
        var_6 = wp::address(var_vertices, var_5);
        var_8 = wp::load(var_6);
        var_7 = wp::copy(var_8);
        // b = vertices[t[1]]                                                                     <L 141>
        var_10 = wp::extract(var_2, var_9);
        var_11 = wp::address(var_vertices, var_10);
        var_13 = wp::load(var_11);
        var_12 = wp::copy(var_13);
        // c = vertices[t[2]]                                                                     <L 142>
        var_15 = wp::extract(var_2, var_14);
        var_16 = wp::address(var_vertices, var_15);
        var_18 = wp::load(var_16);
        var_17 = wp::copy(var_18);
        // middle = vec3(NAN, NAN, NAN)                                                           <L 143>
        var_20 = wp::vec_t<3, wp::float32>(var_19, var_19, var_19);
        // if isfinite(a) and isfinite(b) and isfinite(c):                                        <L 144>
        var_22 = wp::isfinite(var_7);
        var_21 = var_22;
        if (var_21) {
            var_23 = wp::isfinite(var_12);
            var_21 = var_21 && var_23;
        }
        if (var_21) {
            var_24 = wp::isfinite(var_17);
            var_21 = var_21 && var_24;
        }
        if (var_21) {
            // middle = middle_of(a, b, c)                                                        <L 145>
            var_25 = middle_of_0(var_7, var_12, var_17);
        }
        var_26 = wp::where(var_21, var_25, var_20);
        // middles[i] = middle                                                                    <L 146>
        wp::array_store(var_middles, var_0, var_26);
}



extern "C" __global__ void order_triangles_kernel_d92efdbb_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_vertices,
    wp::array_t<wp::vec_t<3, wp::int32>> var_triangles,
    wp::array_t<wp::int32> var_sorted_rows,
    wp::int32 var_tree__count,
    wp::array_t<wp::float32> var_tree__corners,
    wp::array_t<wp::int32> var_tree__order)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        const wp::int32 var_1 = 1;
        wp::int32 var_2;
        wp::int32 var_3;
        wp::int32* var_4;
        wp::int32 var_5;
        wp::int32 var_6;
        wp::vec_t<3, wp::int32>* var_7;
        wp::vec_t<3, wp::int32> var_8;
        wp::vec_t<3, wp::int32> var_9;
        const wp::int32 var_10 = 0;
        wp::int32 var_11;
        wp::vec_t<3, wp::float32>* var_12;
        wp::vec_t<3, wp::float32> var_13;
        wp::vec_t<3, wp::float32> var_14;
        const wp::int32 var_15 = 8;
        wp::int32 var_16;
        const wp::int32 var_17 = 72;
        wp::int32 var_18;
        const wp::int32 var_19 = 3;
        wp::int32 var_20;
        wp::int32 var_21;
        wp::int32 var_22;
        wp::int32 var_23;
        wp::int32 var_24;
        const wp::int32 var_25 = 0;
        wp::float32 var_26;
        const wp::int32 var_27 = 1;
        wp::float32 var_28;
        wp::int32 var_29;
        const wp::int32 var_30 = 2;
        wp::float32 var_31;
        const wp::int32 var_32 = 2;
        wp::int32 var_33;
        wp::int32 var_34;
        const wp::int32 var_35 = 1;
        wp::int32 var_36;
        wp::vec_t<3, wp::float32>* var_37;
        wp::vec_t<3, wp::float32> var_38;
        wp::vec_t<3, wp::float32> var_39;
        wp::int32 var_40;
        wp::int32 var_41;
        const wp::int32 var_42 = 3;
        wp::int32 var_43;
        wp::int32 var_44;
        wp::int32 var_45;
        wp::int32 var_46;
        wp::int32 var_47;
        const wp::int32 var_48 = 0;
        wp::float32 var_49;
        const wp::int32 var_50 = 1;
        wp::float32 var_51;
        wp::int32 var_52;
        const wp::int32 var_53 = 2;
        wp::float32 var_54;
        const wp::int32 var_55 = 2;
        wp::int32 var_56;
        wp::int32 var_57;
        const wp::int32 var_58 = 2;
        wp::int32 var_59;
        wp::vec_t<3, wp::float32>* var_60;
        wp::vec_t<3, wp::float32> var_61;
        wp::vec_t<3, wp::float32> var_62;
        wp::int32 var_63;
        wp::int32 var_64;
        const wp::int32 var_65 = 3;
        wp::int32 var_66;
        wp::int32 var_67;
        wp::int32 var_68;
        wp::int32 var_69;
        wp::int32 var_70;
        const wp::int32 var_71 = 0;
        wp::float32 var_72;
        const wp::int32 var_73 = 1;
        wp::float32 var_74;
        wp::int32 var_75;
        const wp::int32 var_76 = 2;
        wp::float32 var_77;
        const wp::int32 var_78 = 2;
        wp::int32 var_79;
        wp::int32 var_80;
        //---------
        // forward
        // def order_triangles_kernel(vertices, triangles, sorted_rows, tree__count, tree__corners, tree__order):       <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // row = sorted_rows[min(i, tree__count - 1)]                                             <L 3>
        var_2 = wp::sub(var_tree__count, var_1);
        var_3 = wp::min(var_0, var_2);
        var_4 = wp::address(var_sorted_rows, var_3);
        var_6 = wp::load(var_4);
        var_5 = wp::copy(var_6);
        // tree__order[i] = row                                                                   <L 4>
        wp::array_store(var_tree__order, var_0, var_5);
        // t = triangles[row]                                                                     <L 5>
        var_7 = wp::address(var_triangles, var_5);
        var_9 = wp::load(var_7);
        var_8 = wp::copy(var_9);
        // for corner in range(3):                                                                <L 6>
        // p = vertices[t[corner]]                                                                <L 7>
        var_11 = wp::extract(var_8, var_10);
        var_12 = wp::address(var_vertices, var_11);
        var_14 = wp::load(var_12);
        var_13 = wp::copy(var_14);
        // at = i // LEAF * LEAF_NUMBERS + 3 * corner * LEAF + i % LEAF                           <L 8>
        var_16 = wp::floordiv(var_0, var_15);
        var_18 = wp::mul(var_16, var_17);
        var_20 = wp::mul(var_19, var_10);
        var_21 = wp::mul(var_20, var_15);
        var_22 = wp::add(var_18, var_21);
        var_23 = wp::mod(var_0, var_15);
        var_24 = wp::add(var_22, var_23);
        // tree__corners[at] = p[0]                                                               <L 9>
        var_26 = wp::extract(var_13, var_25);
        wp::array_store(var_tree__corners, var_24, var_26);
        // tree__corners[at + LEAF] = p[1]                                                        <L 10>
        var_28 = wp::extract(var_13, var_27);
        var_29 = wp::add(var_24, var_15);
        wp::array_store(var_tree__corners, var_29, var_28);
        // tree__corners[at + 2 * LEAF] = p[2]                                                    <L 11>
        var_31 = wp::extract(var_13, var_30);
        var_33 = wp::mul(var_32, var_15);
        var_34 = wp::add(var_24, var_33);
        wp::array_store(var_tree__corners, var_34, var_31);
        // p = vertices[t[corner]]                                                                <L 7>
        var_36 = wp::extract(var_8, var_35);
        var_37 = wp::address(var_vertices, var_36);
        var_39 = wp::load(var_37);
        var_38 = wp::copy(var_39);
        // at = i // LEAF * LEAF_NUMBERS + 3 * corner * LEAF + i % LEAF                           <L 8>
        var_40 = wp::floordiv(var_0, var_15);
        var_41 = wp::mul(var_40, var_17);
        var_43 = wp::mul(var_42, var_35);
        var_44 = wp::mul(var_43, var_15);
        var_45 = wp::add(var_41, var_44);
        var_46 = wp::mod(var_0, var_15);
        var_47 = wp::add(var_45, var_46);
        // tree__corners[at] = p[0]                                                               <L 9>
        var_49 = wp::extract(var_38, var_48);
        wp::array_store(var_tree__corners, var_47, var_49);
        // tree__corners[at + LEAF] = p[1]                                                        <L 10>
        var_51 = wp::extract(var_38, var_50);
        var_52 = wp::add(var_47, var_15);
        wp::array_store(var_tree__corners, var_52, var_51);
        // tree__corners[at + 2 * LEAF] = p[2]                                                    <L 11>
        var_54 = wp::extract(var_38, var_53);
        var_56 = wp::mul(var_55, var_15);
        var_57 = wp::add(var_47, var_56);
        wp::array_store(var_tree__corners, var_57, var_54);
        // p = vertices[t[corner]]                                                                <L 7>
        var_59 = wp::extract(var_8, var_58);
        var_60 = wp::address(var_vertices, var_59);
        var_62 = wp::load(var_60);
        var_61 = wp::copy(var_62);
        // at = i // LEAF * LEAF_NUMBERS + 3 * corner * LEAF + i % LEAF                           <L 8>
        var_63 = wp::floordiv(var_0, var_15);
        var_64 = wp::mul(var_63, var_17);
        var_66 = wp::mul(var_65, var_58);
        var_67 = wp::mul(var_66, var_15);
        var_68 = wp::add(var_64, var_67);
        var_69 = wp::mod(var_0, var_15);
        var_70 = wp::add(var_68, var_69);
        // tree__corners[at] = p[0]                                                               <L 9>
        var_72 = wp::extract(var_61, var_71);
        wp::array_store(var_tree__corners, var_70, var_72);
        // tree__corners[at + LEAF] = p[1]                                                        <L 10>
        var_74 = wp::extract(var_61, var_73);
        var_75 = wp::add(var_70, var_15);
        wp::array_store(var_tree__corners, var_75, var_74);
        // tree__corners[at + 2 * LEAF] = p[2]                                                    <L 11>
        var_77 = wp::extract(var_61, var_76);
        var_79 = wp::mul(var_78, var_15);
        var_80 = wp::add(var_70, var_79);
        wp::array_store(var_tree__corners, var_80, var_77);
}


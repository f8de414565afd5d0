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


// <pointloom.kernels.odometry.map_course.leg_number>:1
static CUDA_CALLABLE wp::int32 leg_number_0(
    wp::int32 var_leg,
    wp::int32 var_column,
    wp::array_t<wp::float64> var_course__orders)
{
    //---------
    // primal vars
    wp::float64* var_0;
    wp::int32 var_1;
    wp::float64 var_2;
    //---------
    // forward
    // def leg_number(leg, column, course__orders):                                           <L 1>
    // return int(course__orders[leg, column])                                                <L 2>
    var_0 = wp::address(var_course__orders, var_leg, var_column);
    var_2 = wp::load(var_0);
    var_1 = wp::int(var_2);
    return var_1;
}


// /work/main/src/pointloom/kernels/algebra/rigid_solve.py:21
static CUDA_CALLABLE wp::int32 triangle_index_0(
    wp::int32 var_row,
    wp::int32 var_column)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 6;
    wp::int32 var_1;
    const wp::int32 var_2 = 1;
    wp::int32 var_3;
    wp::int32 var_4;
    const wp::int32 var_5 = 2;
    wp::int32 var_6;
    wp::int32 var_7;
    wp::int32 var_8;
    wp::int32 var_9;
    //---------
    // forward
    // def triangle_index(row: int, column: int) -> int:                                      <L 22>
    // return row * UNKNOWNS - (row * (row - 1)) // 2 + column - row                          <L 24>
    var_1 = wp::mul(var_row, var_0);
    var_3 = wp::sub(var_row, var_2);
    var_4 = wp::mul(var_row, var_3);
    var_6 = wp::floordiv(var_4, var_5);
    var_7 = wp::sub(var_1, var_6);
    var_8 = wp::add(var_7, var_column);
    var_9 = wp::sub(var_8, var_row);
    return var_9;
}


// <pointloom.kernels.algebra.rigid_solve.full_matrix>:1
static CUDA_CALLABLE wp::vec_t<36, wp::float64> full_matrix_0(
    wp::vec_t<21, wp::float64> var_h)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::vec_t<36, wp::float64> var_1;
    const wp::int32 var_2 = 0;
    const wp::int32 var_3 = 0;
    bool var_4;
    wp::int32 var_5;
    wp::float64 var_6;
    const wp::int32 var_7 = 6;
    wp::int32 var_8;
    wp::int32 var_9;
    wp::int32 var_10;
    wp::float64 var_11;
    wp::int32 var_12;
    wp::int32 var_13;
    const wp::int32 var_14 = 1;
    bool var_15;
    wp::int32 var_16;
    wp::float64 var_17;
    wp::int32 var_18;
    wp::int32 var_19;
    wp::int32 var_20;
    wp::float64 var_21;
    wp::int32 var_22;
    wp::int32 var_23;
    const wp::int32 var_24 = 2;
    bool var_25;
    wp::int32 var_26;
    wp::float64 var_27;
    wp::int32 var_28;
    wp::int32 var_29;
    wp::int32 var_30;
    wp::float64 var_31;
    wp::int32 var_32;
    wp::int32 var_33;
    const wp::int32 var_34 = 3;
    bool var_35;
    wp::int32 var_36;
    wp::float64 var_37;
    wp::int32 var_38;
    wp::int32 var_39;
    wp::int32 var_40;
    wp::float64 var_41;
    wp::int32 var_42;
    wp::int32 var_43;
    const wp::int32 var_44 = 4;
    bool var_45;
    wp::int32 var_46;
    wp::float64 var_47;
    wp::int32 var_48;
    wp::int32 var_49;
    wp::int32 var_50;
    wp::float64 var_51;
    wp::int32 var_52;
    wp::int32 var_53;
    const wp::int32 var_54 = 5;
    bool var_55;
    wp::int32 var_56;
    wp::float64 var_57;
    wp::int32 var_58;
    wp::int32 var_59;
    wp::int32 var_60;
    wp::float64 var_61;
    wp::int32 var_62;
    wp::int32 var_63;
    const wp::int32 var_64 = 1;
    const wp::int32 var_65 = 0;
    bool var_66;
    wp::int32 var_67;
    wp::float64 var_68;
    wp::int32 var_69;
    wp::int32 var_70;
    wp::int32 var_71;
    wp::float64 var_72;
    wp::int32 var_73;
    wp::int32 var_74;
    const wp::int32 var_75 = 1;
    bool var_76;
    wp::int32 var_77;
    wp::float64 var_78;
    wp::int32 var_79;
    wp::int32 var_80;
    wp::int32 var_81;
    wp::float64 var_82;
    wp::int32 var_83;
    wp::int32 var_84;
    const wp::int32 var_85 = 2;
    bool var_86;
    wp::int32 var_87;
    wp::float64 var_88;
    wp::int32 var_89;
    wp::int32 var_90;
    wp::int32 var_91;
    wp::float64 var_92;
    wp::int32 var_93;
    wp::int32 var_94;
    const wp::int32 var_95 = 3;
    bool var_96;
    wp::int32 var_97;
    wp::float64 var_98;
    wp::int32 var_99;
    wp::int32 var_100;
    wp::int32 var_101;
    wp::float64 var_102;
    wp::int32 var_103;
    wp::int32 var_104;
    const wp::int32 var_105 = 4;
    bool var_106;
    wp::int32 var_107;
    wp::float64 var_108;
    wp::int32 var_109;
    wp::int32 var_110;
    wp::int32 var_111;
    wp::float64 var_112;
    wp::int32 var_113;
    wp::int32 var_114;
    const wp::int32 var_115 = 5;
    bool var_116;
    wp::int32 var_117;
    wp::float64 var_118;
    wp::int32 var_119;
    wp::int32 var_120;
    wp::int32 var_121;
    wp::float64 var_122;
    wp::int32 var_123;
    wp::int32 var_124;
    const wp::int32 var_125 = 2;
    const wp::int32 var_126 = 0;
    bool var_127;
    wp::int32 var_128;
    wp::float64 var_129;
    wp::int32 var_130;
    wp::int32 var_131;
    wp::int32 var_132;
    wp::float64 var_133;
    wp::int32 var_134;
    wp::int32 var_135;
    const wp::int32 var_136 = 1;
    bool var_137;
    wp::int32 var_138;
    wp::float64 var_139;
    wp::int32 var_140;
    wp::int32 var_141;
    wp::int32 var_142;
    wp::float64 var_143;
    wp::int32 var_144;
    wp::int32 var_145;
    const wp::int32 var_146 = 2;
    bool var_147;
    wp::int32 var_148;
    wp::float64 var_149;
    wp::int32 var_150;
    wp::int32 var_151;
    wp::int32 var_152;
    wp::float64 var_153;
    wp::int32 var_154;
    wp::int32 var_155;
    const wp::int32 var_156 = 3;
    bool var_157;
    wp::int32 var_158;
    wp::float64 var_159;
    wp::int32 var_160;
    wp::int32 var_161;
    wp::int32 var_162;
    wp::float64 var_163;
    wp::int32 var_164;
    wp::int32 var_165;
    const wp::int32 var_166 = 4;
    bool var_167;
    wp::int32 var_168;
    wp::float64 var_169;
    wp::int32 var_170;
    wp::int32 var_171;
    wp::int32 var_172;
    wp::float64 var_173;
    wp::int32 var_174;
    wp::int32 var_175;
    const wp::int32 var_176 = 5;
    bool var_177;
    wp::int32 var_178;
    wp::float64 var_179;
    wp::int32 var_180;
    wp::int32 var_181;
    wp::int32 var_182;
    wp::float64 var_183;
    wp::int32 var_184;
    wp::int32 var_185;
    const wp::int32 var_186 = 3;
    const wp::int32 var_187 = 0;
    bool var_188;
    wp::int32 var_189;
    wp::float64 var_190;
    wp::int32 var_191;
    wp::int32 var_192;
    wp::int32 var_193;
    wp::float64 var_194;
    wp::int32 var_195;
    wp::int32 var_196;
    const wp::int32 var_197 = 1;
    bool var_198;
    wp::int32 var_199;
    wp::float64 var_200;
    wp::int32 var_201;
    wp::int32 var_202;
    wp::int32 var_203;
    wp::float64 var_204;
    wp::int32 var_205;
    wp::int32 var_206;
    const wp::int32 var_207 = 2;
    bool var_208;
    wp::int32 var_209;
    wp::float64 var_210;
    wp::int32 var_211;
    wp::int32 var_212;
    wp::int32 var_213;
    wp::float64 var_214;
    wp::int32 var_215;
    wp::int32 var_216;
    const wp::int32 var_217 = 3;
    bool var_218;
    wp::int32 var_219;
    wp::float64 var_220;
    wp::int32 var_221;
    wp::int32 var_222;
    wp::int32 var_223;
    wp::float64 var_224;
    wp::int32 var_225;
    wp::int32 var_226;
    const wp::int32 var_227 = 4;
    bool var_228;
    wp::int32 var_229;
    wp::float64 var_230;
    wp::int32 var_231;
    wp::int32 var_232;
    wp::int32 var_233;
    wp::float64 var_234;
    wp::int32 var_235;
    wp::int32 var_236;
    const wp::int32 var_237 = 5;
    bool var_238;
    wp::int32 var_239;
    wp::float64 var_240;
    wp::int32 var_241;
    wp::int32 var_242;
    wp::int32 var_243;
    wp::float64 var_244;
    wp::int32 var_245;
    wp::int32 var_246;
    const wp::int32 var_247 = 4;
    const wp::int32 var_248 = 0;
    bool var_249;
    wp::int32 var_250;
    wp::float64 var_251;
    wp::int32 var_252;
    wp::int32 var_253;
    wp::int32 var_254;
    wp::float64 var_255;
    wp::int32 var_256;
    wp::int32 var_257;
    const wp::int32 var_258 = 1;
    bool var_259;
    wp::int32 var_260;
    wp::float64 var_261;
    wp::int32 var_262;
    wp::int32 var_263;
    wp::int32 var_264;
    wp::float64 var_265;
    wp::int32 var_266;
    wp::int32 var_267;
    const wp::int32 var_268 = 2;
    bool var_269;
    wp::int32 var_270;
    wp::float64 var_271;
    wp::int32 var_272;
    wp::int32 var_273;
    wp::int32 var_274;
    wp::float64 var_275;
    wp::int32 var_276;
    wp::int32 var_277;
    const wp::int32 var_278 = 3;
    bool var_279;
    wp::int32 var_280;
    wp::float64 var_281;
    wp::int32 var_282;
    wp::int32 var_283;
    wp::int32 var_284;
    wp::float64 var_285;
    wp::int32 var_286;
    wp::int32 var_287;
    const wp::int32 var_288 = 4;
    bool var_289;
    wp::int32 var_290;
    wp::float64 var_291;
    wp::int32 var_292;
    wp::int32 var_293;
    wp::int32 var_294;
    wp::float64 var_295;
    wp::int32 var_296;
    wp::int32 var_297;
    const wp::int32 var_298 = 5;
    bool var_299;
    wp::int32 var_300;
    wp::float64 var_301;
    wp::int32 var_302;
    wp::int32 var_303;
    wp::int32 var_304;
    wp::float64 var_305;
    wp::int32 var_306;
    wp::int32 var_307;
    const wp::int32 var_308 = 5;
    const wp::int32 var_309 = 0;
    bool var_310;
    wp::int32 var_311;
    wp::float64 var_312;
    wp::int32 var_313;
    wp::int32 var_314;
    wp::int32 var_315;
    wp::float64 var_316;
    wp::int32 var_317;
    wp::int32 var_318;
    const wp::int32 var_319 = 1;
    bool var_320;
    wp::int32 var_321;
    wp::float64 var_322;
    wp::int32 var_323;
    wp::int32 var_324;
    wp::int32 var_325;
    wp::float64 var_326;
    wp::int32 var_327;
    wp::int32 var_328;
    const wp::int32 var_329 = 2;
    bool var_330;
    wp::int32 var_331;
    wp::float64 var_332;
    wp::int32 var_333;
    wp::int32 var_334;
    wp::int32 var_335;
    wp::float64 var_336;
    wp::int32 var_337;
    wp::int32 var_338;
    const wp::int32 var_339 = 3;
    bool var_340;
    wp::int32 var_341;
    wp::float64 var_342;
    wp::int32 var_343;
    wp::int32 var_344;
    wp::int32 var_345;
    wp::float64 var_346;
    wp::int32 var_347;
    wp::int32 var_348;
    const wp::int32 var_349 = 4;
    bool var_350;
    wp::int32 var_351;
    wp::float64 var_352;
    wp::int32 var_353;
    wp::int32 var_354;
    wp::int32 var_355;
    wp::float64 var_356;
    wp::int32 var_357;
    wp::int32 var_358;
    const wp::int32 var_359 = 5;
    bool var_360;
    wp::int32 var_361;
    wp::float64 var_362;
    wp::int32 var_363;
    wp::int32 var_364;
    wp::int32 var_365;
    wp::float64 var_366;
    wp::int32 var_367;
    wp::int32 var_368;
    //---------
    // forward
    // def full_matrix(h):                                                                    <L 1>
    // a = square(float64(0.0))                                                               <L 2>
    var_0 = 0.0;
    var_1 = wp::vec_t<36, wp::float64>(var_0);
    // for i in range(6):                                                                     <L 3>
    // for j in range(6):                                                                     <L 4>
    // if j >= i:                                                                             <L 5>
    var_4 = (var_3 >= var_2);
    if (var_4) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_5 = triangle_index_0(var_2, var_3);
        var_6 = wp::extract(var_h, var_5);
        var_8 = wp::mul(var_2, var_7);
        var_9 = wp::add(var_8, var_3);
        wp::assign_inplace(var_1, var_9, var_6);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_10 = triangle_index_0(var_2, var_3);
        var_11 = wp::extract(var_h, var_10);
        var_12 = wp::mul(var_3, var_7);
        var_13 = wp::add(var_12, var_2);
        wp::assign_inplace(var_1, var_13, var_11);
    }
    // if j >= i:                                                                             <L 5>
    var_15 = (var_14 >= var_2);
    if (var_15) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_16 = triangle_index_0(var_2, var_14);
        var_17 = wp::extract(var_h, var_16);
        var_18 = wp::mul(var_2, var_7);
        var_19 = wp::add(var_18, var_14);
        wp::assign_inplace(var_1, var_19, var_17);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_20 = triangle_index_0(var_2, var_14);
        var_21 = wp::extract(var_h, var_20);
        var_22 = wp::mul(var_14, var_7);
        var_23 = wp::add(var_22, var_2);
        wp::assign_inplace(var_1, var_23, var_21);
    }
    // if j >= i:                                                                             <L 5>
    var_25 = (var_24 >= var_2);
    if (var_25) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_26 = triangle_index_0(var_2, var_24);
        var_27 = wp::extract(var_h, var_26);
        var_28 = wp::mul(var_2, var_7);
        var_29 = wp::add(var_28, var_24);
        wp::assign_inplace(var_1, var_29, var_27);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_30 = triangle_index_0(var_2, var_24);
        var_31 = wp::extract(var_h, var_30);
        var_32 = wp::mul(var_24, var_7);
        var_33 = wp::add(var_32, var_2);
        wp::assign_inplace(var_1, var_33, var_31);
    }
    // if j >= i:                                                                             <L 5>
    var_35 = (var_34 >= var_2);
    if (var_35) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_36 = triangle_index_0(var_2, var_34);
        var_37 = wp::extract(var_h, var_36);
        var_38 = wp::mul(var_2, var_7);
        var_39 = wp::add(var_38, var_34);
        wp::assign_inplace(var_1, var_39, var_37);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_40 = triangle_index_0(var_2, var_34);
        var_41 = wp::extract(var_h, var_40);
        var_42 = wp::mul(var_34, var_7);
        var_43 = wp::add(var_42, var_2);
        wp::assign_inplace(var_1, var_43, var_41);
    }
    // if j >= i:                                                                             <L 5>
    var_45 = (var_44 >= var_2);
    if (var_45) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_46 = triangle_index_0(var_2, var_44);
        var_47 = wp::extract(var_h, var_46);
        var_48 = wp::mul(var_2, var_7);
        var_49 = wp::add(var_48, var_44);
        wp::assign_inplace(var_1, var_49, var_47);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_50 = triangle_index_0(var_2, var_44);
        var_51 = wp::extract(var_h, var_50);
        var_52 = wp::mul(var_44, var_7);
        var_53 = wp::add(var_52, var_2);
        wp::assign_inplace(var_1, var_53, var_51);
    }
    // if j >= i:                                                                             <L 5>
    var_55 = (var_54 >= var_2);
    if (var_55) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_56 = triangle_index_0(var_2, var_54);
        var_57 = wp::extract(var_h, var_56);
        var_58 = wp::mul(var_2, var_7);
        var_59 = wp::add(var_58, var_54);
        wp::assign_inplace(var_1, var_59, var_57);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_60 = triangle_index_0(var_2, var_54);
        var_61 = wp::extract(var_h, var_60);
        var_62 = wp::mul(var_54, var_7);
        var_63 = wp::add(var_62, var_2);
        wp::assign_inplace(var_1, var_63, var_61);
    }
    // for j in range(6):                                                                     <L 4>
    // if j >= i:                                                                             <L 5>
    var_66 = (var_65 >= var_64);
    if (var_66) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_67 = triangle_index_0(var_64, var_65);
        var_68 = wp::extract(var_h, var_67);
        var_69 = wp::mul(var_64, var_7);
        var_70 = wp::add(var_69, var_65);
        wp::assign_inplace(var_1, var_70, var_68);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_71 = triangle_index_0(var_64, var_65);
        var_72 = wp::extract(var_h, var_71);
        var_73 = wp::mul(var_65, var_7);
        var_74 = wp::add(var_73, var_64);
        wp::assign_inplace(var_1, var_74, var_72);
    }
    // if j >= i:                                                                             <L 5>
    var_76 = (var_75 >= var_64);
    if (var_76) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_77 = triangle_index_0(var_64, var_75);
        var_78 = wp::extract(var_h, var_77);
        var_79 = wp::mul(var_64, var_7);
        var_80 = wp::add(var_79, var_75);
        wp::assign_inplace(var_1, var_80, var_78);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_81 = triangle_index_0(var_64, var_75);
        var_82 = wp::extract(var_h, var_81);
        var_83 = wp::mul(var_75, var_7);
        var_84 = wp::add(var_83, var_64);
        wp::assign_inplace(var_1, var_84, var_82);
    }
    // if j >= i:                                                                             <L 5>
    var_86 = (var_85 >= var_64);
    if (var_86) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_87 = triangle_index_0(var_64, var_85);
        var_88 = wp::extract(var_h, var_87);
        var_89 = wp::mul(var_64, var_7);
        var_90 = wp::add(var_89, var_85);
        wp::assign_inplace(var_1, var_90, var_88);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_91 = triangle_index_0(var_64, var_85);
        var_92 = wp::extract(var_h, var_91);
        var_93 = wp::mul(var_85, var_7);
        var_94 = wp::add(var_93, var_64);
        wp::assign_inplace(var_1, var_94, var_92);
    }
    // if j >= i:                                                                             <L 5>
    var_96 = (var_95 >= var_64);
    if (var_96) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_97 = triangle_index_0(var_64, var_95);
        var_98 = wp::extract(var_h, var_97);
        var_99 = wp::mul(var_64, var_7);
        var_100 = wp::add(var_99, var_95);
        wp::assign_inplace(var_1, var_100, var_98);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_101 = triangle_index_0(var_64, var_95);
        var_102 = wp::extract(var_h, var_101);
        var_103 = wp::mul(var_95, var_7);
        var_104 = wp::add(var_103, var_64);
        wp::assign_inplace(var_1, var_104, var_102);
    }
    // if j >= i:                                                                             <L 5>
    var_106 = (var_105 >= var_64);
    if (var_106) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_107 = triangle_index_0(var_64, var_105);
        var_108 = wp::extract(var_h, var_107);
        var_109 = wp::mul(var_64, var_7);
        var_110 = wp::add(var_109, var_105);
        wp::assign_inplace(var_1, var_110, var_108);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_111 = triangle_index_0(var_64, var_105);
        var_112 = wp::extract(var_h, var_111);
        var_113 = wp::mul(var_105, var_7);
        var_114 = wp::add(var_113, var_64);
        wp::assign_inplace(var_1, var_114, var_112);
    }
    // if j >= i:                                                                             <L 5>
    var_116 = (var_115 >= var_64);
    if (var_116) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_117 = triangle_index_0(var_64, var_115);
        var_118 = wp::extract(var_h, var_117);
        var_119 = wp::mul(var_64, var_7);
        var_120 = wp::add(var_119, var_115);
        wp::assign_inplace(var_1, var_120, var_118);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_121 = triangle_index_0(var_64, var_115);
        var_122 = wp::extract(var_h, var_121);
        var_123 = wp::mul(var_115, var_7);
        var_124 = wp::add(var_123, var_64);
        wp::assign_inplace(var_1, var_124, var_122);
    }
    // for j in range(6):                                                                     <L 4>
    // if j >= i:                                                                             <L 5>
    var_127 = (var_126 >= var_125);
    if (var_127) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_128 = triangle_index_0(var_125, var_126);
        var_129 = wp::extract(var_h, var_128);
        var_130 = wp::mul(var_125, var_7);
        var_131 = wp::add(var_130, var_126);
        wp::assign_inplace(var_1, var_131, var_129);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_132 = triangle_index_0(var_125, var_126);
        var_133 = wp::extract(var_h, var_132);
        var_134 = wp::mul(var_126, var_7);
        var_135 = wp::add(var_134, var_125);
        wp::assign_inplace(var_1, var_135, var_133);
    }
    // if j >= i:                                                                             <L 5>
    var_137 = (var_136 >= var_125);
    if (var_137) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_138 = triangle_index_0(var_125, var_136);
        var_139 = wp::extract(var_h, var_138);
        var_140 = wp::mul(var_125, var_7);
        var_141 = wp::add(var_140, var_136);
        wp::assign_inplace(var_1, var_141, var_139);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_142 = triangle_index_0(var_125, var_136);
        var_143 = wp::extract(var_h, var_142);
        var_144 = wp::mul(var_136, var_7);
        var_145 = wp::add(var_144, var_125);
        wp::assign_inplace(var_1, var_145, var_143);
    }
    // if j >= i:                                                                             <L 5>
    var_147 = (var_146 >= var_125);
    if (var_147) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_148 = triangle_index_0(var_125, var_146);
        var_149 = wp::extract(var_h, var_148);
        var_150 = wp::mul(var_125, var_7);
        var_151 = wp::add(var_150, var_146);
        wp::assign_inplace(var_1, var_151, var_149);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_152 = triangle_index_0(var_125, var_146);
        var_153 = wp::extract(var_h, var_152);
        var_154 = wp::mul(var_146, var_7);
        var_155 = wp::add(var_154, var_125);
        wp::assign_inplace(var_1, var_155, var_153);
    }
    // if j >= i:                                                                             <L 5>
    var_157 = (var_156 >= var_125);
    if (var_157) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_158 = triangle_index_0(var_125, var_156);
        var_159 = wp::extract(var_h, var_158);
        var_160 = wp::mul(var_125, var_7);
        var_161 = wp::add(var_160, var_156);
        wp::assign_inplace(var_1, var_161, var_159);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_162 = triangle_index_0(var_125, var_156);
        var_163 = wp::extract(var_h, var_162);
        var_164 = wp::mul(var_156, var_7);
        var_165 = wp::add(var_164, var_125);
        wp::assign_inplace(var_1, var_165, var_163);
    }
    // if j >= i:                                                                             <L 5>
    var_167 = (var_166 >= var_125);
    if (var_167) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_168 = triangle_index_0(var_125, var_166);
        var_169 = wp::extract(var_h, var_168);
        var_170 = wp::mul(var_125, var_7);
        var_171 = wp::add(var_170, var_166);
        wp::assign_inplace(var_1, var_171, var_169);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_172 = triangle_index_0(var_125, var_166);
        var_173 = wp::extract(var_h, var_172);
        var_174 = wp::mul(var_166, var_7);
        var_175 = wp::add(var_174, var_125);
        wp::assign_inplace(var_1, var_175, var_173);
    }
    // if j >= i:                                                                             <L 5>
    var_177 = (var_176 >= var_125);
    if (var_177) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_178 = triangle_index_0(var_125, var_176);
        var_179 = wp::extract(var_h, var_178);
        var_180 = wp::mul(var_125, var_7);
        var_181 = wp::add(var_180, var_176);
        wp::assign_inplace(var_1, var_181, var_179);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_182 = triangle_index_0(var_125, var_176);
        var_183 = wp::extract(var_h, var_182);
        var_184 = wp::mul(var_176, var_7);
        var_185 = wp::add(var_184, var_125);
        wp::assign_inplace(var_1, var_185, var_183);
    }
    // for j in range(6):                                                                     <L 4>
    // if j >= i:                                                                             <L 5>
    var_188 = (var_187 >= var_186);
    if (var_188) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_189 = triangle_index_0(var_186, var_187);
        var_190 = wp::extract(var_h, var_189);
        var_191 = wp::mul(var_186, var_7);
        var_192 = wp::add(var_191, var_187);
        wp::assign_inplace(var_1, var_192, var_190);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_193 = triangle_index_0(var_186, var_187);
        var_194 = wp::extract(var_h, var_193);
        var_195 = wp::mul(var_187, var_7);
        var_196 = wp::add(var_195, var_186);
        wp::assign_inplace(var_1, var_196, var_194);
    }
    // if j >= i:                                                                             <L 5>
    var_198 = (var_197 >= var_186);
    if (var_198) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_199 = triangle_index_0(var_186, var_197);
        var_200 = wp::extract(var_h, var_199);
        var_201 = wp::mul(var_186, var_7);
        var_202 = wp::add(var_201, var_197);
        wp::assign_inplace(var_1, var_202, var_200);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_203 = triangle_index_0(var_186, var_197);
        var_204 = wp::extract(var_h, var_203);
        var_205 = wp::mul(var_197, var_7);
        var_206 = wp::add(var_205, var_186);
        wp::assign_inplace(var_1, var_206, var_204);
    }
    // if j >= i:                                                                             <L 5>
    var_208 = (var_207 >= var_186);
    if (var_208) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_209 = triangle_index_0(var_186, var_207);
        var_210 = wp::extract(var_h, var_209);
        var_211 = wp::mul(var_186, var_7);
        var_212 = wp::add(var_211, var_207);
        wp::assign_inplace(var_1, var_212, var_210);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_213 = triangle_index_0(var_186, var_207);
        var_214 = wp::extract(var_h, var_213);
        var_215 = wp::mul(var_207, var_7);
        var_216 = wp::add(var_215, var_186);
        wp::assign_inplace(var_1, var_216, var_214);
    }
    // if j >= i:                                                                             <L 5>
    var_218 = (var_217 >= var_186);
    if (var_218) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_219 = triangle_index_0(var_186, var_217);
        var_220 = wp::extract(var_h, var_219);
        var_221 = wp::mul(var_186, var_7);
        var_222 = wp::add(var_221, var_217);
        wp::assign_inplace(var_1, var_222, var_220);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_223 = triangle_index_0(var_186, var_217);
        var_224 = wp::extract(var_h, var_223);
        var_225 = wp::mul(var_217, var_7);
        var_226 = wp::add(var_225, var_186);
        wp::assign_inplace(var_1, var_226, var_224);
    }
    // if j >= i:                                                                             <L 5>
    var_228 = (var_227 >= var_186);
    if (var_228) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_229 = triangle_index_0(var_186, var_227);
        var_230 = wp::extract(var_h, var_229);
        var_231 = wp::mul(var_186, var_7);
        var_232 = wp::add(var_231, var_227);
        wp::assign_inplace(var_1, var_232, var_230);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_233 = triangle_index_0(var_186, var_227);
        var_234 = wp::extract(var_h, var_233);
        var_235 = wp::mul(var_227, var_7);
        var_236 = wp::add(var_235, var_186);
        wp::assign_inplace(var_1, var_236, var_234);
    }
    // if j >= i:                                                                             <L 5>
    var_238 = (var_237 >= var_186);
    if (var_238) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_239 = triangle_index_0(var_186, var_237);
        var_240 = wp::extract(var_h, var_239);
        var_241 = wp::mul(var_186, var_7);
        var_242 = wp::add(var_241, var_237);
        wp::assign_inplace(var_1, var_242, var_240);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_243 = triangle_index_0(var_186, var_237);
        var_244 = wp::extract(var_h, var_243);
        var_245 = wp::mul(var_237, var_7);
        var_246 = wp::add(var_245, var_186);
        wp::assign_inplace(var_1, var_246, var_244);
    }
    // for j in range(6):                                                                     <L 4>
    // if j >= i:                                                                             <L 5>
    var_249 = (var_248 >= var_247);
    if (var_249) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_250 = triangle_index_0(var_247, var_248);
        var_251 = wp::extract(var_h, var_250);
        var_252 = wp::mul(var_247, var_7);
        var_253 = wp::add(var_252, var_248);
        wp::assign_inplace(var_1, var_253, var_251);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_254 = triangle_index_0(var_247, var_248);
        var_255 = wp::extract(var_h, var_254);
        var_256 = wp::mul(var_248, var_7);
        var_257 = wp::add(var_256, var_247);
        wp::assign_inplace(var_1, var_257, var_255);
    }
    // if j >= i:                                                                             <L 5>
    var_259 = (var_258 >= var_247);
    if (var_259) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_260 = triangle_index_0(var_247, var_258);
        var_261 = wp::extract(var_h, var_260);
        var_262 = wp::mul(var_247, var_7);
        var_263 = wp::add(var_262, var_258);
        wp::assign_inplace(var_1, var_263, var_261);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_264 = triangle_index_0(var_247, var_258);
        var_265 = wp::extract(var_h, var_264);
        var_266 = wp::mul(var_258, var_7);
        var_267 = wp::add(var_266, var_247);
        wp::assign_inplace(var_1, var_267, var_265);
    }
    // if j >= i:                                                                             <L 5>
    var_269 = (var_268 >= var_247);
    if (var_269) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_270 = triangle_index_0(var_247, var_268);
        var_271 = wp::extract(var_h, var_270);
        var_272 = wp::mul(var_247, var_7);
        var_273 = wp::add(var_272, var_268);
        wp::assign_inplace(var_1, var_273, var_271);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_274 = triangle_index_0(var_247, var_268);
        var_275 = wp::extract(var_h, var_274);
        var_276 = wp::mul(var_268, var_7);
        var_277 = wp::add(var_276, var_247);
        wp::assign_inplace(var_1, var_277, var_275);
    }
    // if j >= i:                                                                             <L 5>
    var_279 = (var_278 >= var_247);
    if (var_279) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_280 = triangle_index_0(var_247, var_278);
        var_281 = wp::extract(var_h, var_280);
        var_282 = wp::mul(var_247, var_7);
        var_283 = wp::add(var_282, var_278);
        wp::assign_inplace(var_1, var_283, var_281);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_284 = triangle_index_0(var_247, var_278);
        var_285 = wp::extract(var_h, var_284);
        var_286 = wp::mul(var_278, var_7);
        var_287 = wp::add(var_286, var_247);
        wp::assign_inplace(var_1, var_287, var_285);
    }
    // if j >= i:                                                                             <L 5>
    var_289 = (var_288 >= var_247);
    if (var_289) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_290 = triangle_index_0(var_247, var_288);
        var_291 = wp::extract(var_h, var_290);
        var_292 = wp::mul(var_247, var_7);
        var_293 = wp::add(var_292, var_288);
        wp::assign_inplace(var_1, var_293, var_291);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_294 = triangle_index_0(var_247, var_288);
        var_295 = wp::extract(var_h, var_294);
        var_296 = wp::mul(var_288, var_7);
        var_297 = wp::add(var_296, var_247);
        wp::assign_inplace(var_1, var_297, var_295);
    }
    // if j >= i:                                                                             <L 5>
    var_299 = (var_298 >= var_247);
    if (var_299) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_300 = triangle_index_0(var_247, var_298);
        var_301 = wp::extract(var_h, var_300);
        var_302 = wp::mul(var_247, var_7);
        var_303 = wp::add(var_302, var_298);
        wp::assign_inplace(var_1, var_303, var_301);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_304 = triangle_index_0(var_247, var_298);
        var_305 = wp::extract(var_h, var_304);
        var_306 = wp::mul(var_298, var_7);
        var_307 = wp::add(var_306, var_247);
        wp::assign_inplace(var_1, var_307, var_305);
    }
    // for j in range(6):                                                                     <L 4>
    // if j >= i:                                                                             <L 5>
    var_310 = (var_309 >= var_308);
    if (var_310) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_311 = triangle_index_0(var_308, var_309);
        var_312 = wp::extract(var_h, var_311);
        var_313 = wp::mul(var_308, var_7);
        var_314 = wp::add(var_313, var_309);
        wp::assign_inplace(var_1, var_314, var_312);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_315 = triangle_index_0(var_308, var_309);
        var_316 = wp::extract(var_h, var_315);
        var_317 = wp::mul(var_309, var_7);
        var_318 = wp::add(var_317, var_308);
        wp::assign_inplace(var_1, var_318, var_316);
    }
    // if j >= i:                                                                             <L 5>
    var_320 = (var_319 >= var_308);
    if (var_320) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_321 = triangle_index_0(var_308, var_319);
        var_322 = wp::extract(var_h, var_321);
        var_323 = wp::mul(var_308, var_7);
        var_324 = wp::add(var_323, var_319);
        wp::assign_inplace(var_1, var_324, var_322);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_325 = triangle_index_0(var_308, var_319);
        var_326 = wp::extract(var_h, var_325);
        var_327 = wp::mul(var_319, var_7);
        var_328 = wp::add(var_327, var_308);
        wp::assign_inplace(var_1, var_328, var_326);
    }
    // if j >= i:                                                                             <L 5>
    var_330 = (var_329 >= var_308);
    if (var_330) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_331 = triangle_index_0(var_308, var_329);
        var_332 = wp::extract(var_h, var_331);
        var_333 = wp::mul(var_308, var_7);
        var_334 = wp::add(var_333, var_329);
        wp::assign_inplace(var_1, var_334, var_332);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_335 = triangle_index_0(var_308, var_329);
        var_336 = wp::extract(var_h, var_335);
        var_337 = wp::mul(var_329, var_7);
        var_338 = wp::add(var_337, var_308);
        wp::assign_inplace(var_1, var_338, var_336);
    }
    // if j >= i:                                                                             <L 5>
    var_340 = (var_339 >= var_308);
    if (var_340) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_341 = triangle_index_0(var_308, var_339);
        var_342 = wp::extract(var_h, var_341);
        var_343 = wp::mul(var_308, var_7);
        var_344 = wp::add(var_343, var_339);
        wp::assign_inplace(var_1, var_344, var_342);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_345 = triangle_index_0(var_308, var_339);
        var_346 = wp::extract(var_h, var_345);
        var_347 = wp::mul(var_339, var_7);
        var_348 = wp::add(var_347, var_308);
        wp::assign_inplace(var_1, var_348, var_346);
    }
    // if j >= i:                                                                             <L 5>
    var_350 = (var_349 >= var_308);
    if (var_350) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_351 = triangle_index_0(var_308, var_349);
        var_352 = wp::extract(var_h, var_351);
        var_353 = wp::mul(var_308, var_7);
        var_354 = wp::add(var_353, var_349);
        wp::assign_inplace(var_1, var_354, var_352);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_355 = triangle_index_0(var_308, var_349);
        var_356 = wp::extract(var_h, var_355);
        var_357 = wp::mul(var_349, var_7);
        var_358 = wp::add(var_357, var_308);
        wp::assign_inplace(var_1, var_358, var_356);
    }
    // if j >= i:                                                                             <L 5>
    var_360 = (var_359 >= var_308);
    if (var_360) {
        // a[i * UNKNOWNS + j] = h[triangle_index(i, j)]                                      <L 6>
        var_361 = triangle_index_0(var_308, var_359);
        var_362 = wp::extract(var_h, var_361);
        var_363 = wp::mul(var_308, var_7);
        var_364 = wp::add(var_363, var_359);
        wp::assign_inplace(var_1, var_364, var_362);
        // a[j * UNKNOWNS + i] = h[triangle_index(i, j)]                                      <L 7>
        var_365 = triangle_index_0(var_308, var_359);
        var_366 = wp::extract(var_h, var_365);
        var_367 = wp::mul(var_359, var_7);
        var_368 = wp::add(var_367, var_308);
        wp::assign_inplace(var_1, var_368, var_366);
    }
    // return a                                                                               <L 8>
    return var_1;
}


// <pointloom.kernels.algebra.rigid_solve.factor_system>:1
static CUDA_CALLABLE wp::vec_t<36, wp::float64> factor_system_0(
    wp::vec_t<21, wp::float64> var_h)
{
    //---------
    // primal vars
    wp::vec_t<36, wp::float64> var_0;
    wp::float64 var_1;
    const wp::int32 var_2 = 0;
    const wp::int32 var_3 = 6;
    wp::int32 var_4;
    wp::int32 var_5;
    wp::float64 var_6;
    wp::float64 var_7;
    wp::float64 var_8;
    const wp::int32 var_9 = 1;
    wp::int32 var_10;
    wp::int32 var_11;
    wp::float64 var_12;
    wp::float64 var_13;
    wp::float64 var_14;
    const wp::int32 var_15 = 2;
    wp::int32 var_16;
    wp::int32 var_17;
    wp::float64 var_18;
    wp::float64 var_19;
    wp::float64 var_20;
    const wp::int32 var_21 = 3;
    wp::int32 var_22;
    wp::int32 var_23;
    wp::float64 var_24;
    wp::float64 var_25;
    wp::float64 var_26;
    const wp::int32 var_27 = 4;
    wp::int32 var_28;
    wp::int32 var_29;
    wp::float64 var_30;
    wp::float64 var_31;
    wp::float64 var_32;
    const wp::int32 var_33 = 5;
    wp::int32 var_34;
    wp::int32 var_35;
    wp::float64 var_36;
    wp::float64 var_37;
    wp::float64 var_38;
    const wp::int32 var_39 = 0;
    wp::int32 var_40;
    wp::int32 var_41;
    wp::float64 var_42;
    wp::float64 var_43;
    wp::float64 var_44;
    wp::float64 var_45;
    bool var_46;
    wp::float64 var_47;
    wp::float64 var_48;
    wp::float64 var_49;
    wp::float64 var_50;
    bool var_51;
    wp::float64 var_52;
    wp::float64 var_53;
    wp::float64 var_54;
    wp::float64 var_55;
    wp::float64 var_56;
    wp::float64 var_57;
    wp::int32 var_58;
    wp::int32 var_59;
    const wp::int32 var_60 = 0;
    bool var_61;
    wp::int32 var_62;
    wp::int32 var_63;
    wp::float64 var_64;
    wp::float64 var_65;
    wp::int32 var_66;
    wp::int32 var_67;
    const wp::int32 var_68 = 1;
    bool var_69;
    wp::int32 var_70;
    wp::int32 var_71;
    wp::float64 var_72;
    wp::float64 var_73;
    wp::int32 var_74;
    wp::int32 var_75;
    wp::float64 var_76;
    const wp::int32 var_77 = 2;
    bool var_78;
    wp::int32 var_79;
    wp::int32 var_80;
    wp::float64 var_81;
    wp::float64 var_82;
    wp::int32 var_83;
    wp::int32 var_84;
    wp::float64 var_85;
    const wp::int32 var_86 = 3;
    bool var_87;
    wp::int32 var_88;
    wp::int32 var_89;
    wp::float64 var_90;
    wp::float64 var_91;
    wp::int32 var_92;
    wp::int32 var_93;
    wp::float64 var_94;
    const wp::int32 var_95 = 4;
    bool var_96;
    wp::int32 var_97;
    wp::int32 var_98;
    wp::float64 var_99;
    wp::float64 var_100;
    wp::int32 var_101;
    wp::int32 var_102;
    wp::float64 var_103;
    const wp::int32 var_104 = 5;
    bool var_105;
    wp::int32 var_106;
    wp::int32 var_107;
    wp::float64 var_108;
    wp::float64 var_109;
    wp::int32 var_110;
    wp::int32 var_111;
    wp::float64 var_112;
    const wp::int32 var_113 = 1;
    wp::int32 var_114;
    wp::int32 var_115;
    wp::float64 var_116;
    const wp::int32 var_117 = 0;
    wp::int32 var_118;
    wp::int32 var_119;
    wp::float64 var_120;
    wp::int32 var_121;
    wp::int32 var_122;
    wp::float64 var_123;
    wp::float64 var_124;
    wp::int32 var_125;
    wp::int32 var_126;
    wp::float64 var_127;
    wp::float64 var_128;
    wp::float64 var_129;
    wp::float64 var_130;
    wp::float64 var_131;
    wp::float64 var_132;
    bool var_133;
    wp::float64 var_134;
    wp::float64 var_135;
    wp::float64 var_136;
    wp::float64 var_137;
    bool var_138;
    wp::float64 var_139;
    wp::float64 var_140;
    wp::float64 var_141;
    wp::float64 var_142;
    wp::float64 var_143;
    wp::float64 var_144;
    wp::int32 var_145;
    wp::int32 var_146;
    const wp::int32 var_147 = 0;
    bool var_148;
    wp::int32 var_149;
    wp::int32 var_150;
    wp::float64 var_151;
    const wp::int32 var_152 = 0;
    wp::int32 var_153;
    wp::int32 var_154;
    wp::float64 var_155;
    wp::int32 var_156;
    wp::int32 var_157;
    wp::float64 var_158;
    wp::float64 var_159;
    wp::int32 var_160;
    wp::int32 var_161;
    wp::float64 var_162;
    wp::float64 var_163;
    wp::float64 var_164;
    wp::float64 var_165;
    wp::int32 var_166;
    wp::int32 var_167;
    wp::float64 var_168;
    wp::int32 var_169;
    const wp::int32 var_170 = 1;
    bool var_171;
    wp::int32 var_172;
    wp::int32 var_173;
    wp::float64 var_174;
    const wp::int32 var_175 = 0;
    wp::int32 var_176;
    wp::int32 var_177;
    wp::float64 var_178;
    wp::int32 var_179;
    wp::int32 var_180;
    wp::float64 var_181;
    wp::float64 var_182;
    wp::int32 var_183;
    wp::int32 var_184;
    wp::float64 var_185;
    wp::float64 var_186;
    wp::float64 var_187;
    wp::float64 var_188;
    wp::int32 var_189;
    wp::int32 var_190;
    wp::float64 var_191;
    wp::int32 var_192;
    const wp::int32 var_193 = 2;
    bool var_194;
    wp::int32 var_195;
    wp::int32 var_196;
    wp::float64 var_197;
    const wp::int32 var_198 = 0;
    wp::int32 var_199;
    wp::int32 var_200;
    wp::float64 var_201;
    wp::int32 var_202;
    wp::int32 var_203;
    wp::float64 var_204;
    wp::float64 var_205;
    wp::int32 var_206;
    wp::int32 var_207;
    wp::float64 var_208;
    wp::float64 var_209;
    wp::float64 var_210;
    wp::float64 var_211;
    wp::int32 var_212;
    wp::int32 var_213;
    wp::float64 var_214;
    wp::int32 var_215;
    const wp::int32 var_216 = 3;
    bool var_217;
    wp::int32 var_218;
    wp::int32 var_219;
    wp::float64 var_220;
    const wp::int32 var_221 = 0;
    wp::int32 var_222;
    wp::int32 var_223;
    wp::float64 var_224;
    wp::int32 var_225;
    wp::int32 var_226;
    wp::float64 var_227;
    wp::float64 var_228;
    wp::int32 var_229;
    wp::int32 var_230;
    wp::float64 var_231;
    wp::float64 var_232;
    wp::float64 var_233;
    wp::float64 var_234;
    wp::int32 var_235;
    wp::int32 var_236;
    wp::float64 var_237;
    wp::int32 var_238;
    const wp::int32 var_239 = 4;
    bool var_240;
    wp::int32 var_241;
    wp::int32 var_242;
    wp::float64 var_243;
    const wp::int32 var_244 = 0;
    wp::int32 var_245;
    wp::int32 var_246;
    wp::float64 var_247;
    wp::int32 var_248;
    wp::int32 var_249;
    wp::float64 var_250;
    wp::float64 var_251;
    wp::int32 var_252;
    wp::int32 var_253;
    wp::float64 var_254;
    wp::float64 var_255;
    wp::float64 var_256;
    wp::float64 var_257;
    wp::int32 var_258;
    wp::int32 var_259;
    wp::float64 var_260;
    wp::int32 var_261;
    const wp::int32 var_262 = 5;
    bool var_263;
    wp::int32 var_264;
    wp::int32 var_265;
    wp::float64 var_266;
    const wp::int32 var_267 = 0;
    wp::int32 var_268;
    wp::int32 var_269;
    wp::float64 var_270;
    wp::int32 var_271;
    wp::int32 var_272;
    wp::float64 var_273;
    wp::float64 var_274;
    wp::int32 var_275;
    wp::int32 var_276;
    wp::float64 var_277;
    wp::float64 var_278;
    wp::float64 var_279;
    wp::float64 var_280;
    wp::int32 var_281;
    wp::int32 var_282;
    wp::float64 var_283;
    wp::int32 var_284;
    const wp::int32 var_285 = 2;
    wp::int32 var_286;
    wp::int32 var_287;
    wp::float64 var_288;
    const wp::int32 var_289 = 0;
    wp::int32 var_290;
    wp::int32 var_291;
    wp::float64 var_292;
    wp::int32 var_293;
    wp::int32 var_294;
    wp::float64 var_295;
    wp::float64 var_296;
    wp::int32 var_297;
    wp::int32 var_298;
    wp::float64 var_299;
    wp::float64 var_300;
    wp::float64 var_301;
    const wp::int32 var_302 = 1;
    wp::int32 var_303;
    wp::int32 var_304;
    wp::float64 var_305;
    wp::int32 var_306;
    wp::int32 var_307;
    wp::float64 var_308;
    wp::float64 var_309;
    wp::int32 var_310;
    wp::int32 var_311;
    wp::float64 var_312;
    wp::float64 var_313;
    wp::float64 var_314;
    wp::float64 var_315;
    wp::float64 var_316;
    wp::float64 var_317;
    bool var_318;
    wp::float64 var_319;
    wp::float64 var_320;
    wp::float64 var_321;
    wp::float64 var_322;
    bool var_323;
    wp::float64 var_324;
    wp::float64 var_325;
    wp::float64 var_326;
    wp::float64 var_327;
    wp::float64 var_328;
    wp::float64 var_329;
    wp::int32 var_330;
    wp::int32 var_331;
    const wp::int32 var_332 = 0;
    bool var_333;
    wp::int32 var_334;
    wp::int32 var_335;
    wp::float64 var_336;
    const wp::int32 var_337 = 0;
    wp::int32 var_338;
    wp::int32 var_339;
    wp::float64 var_340;
    wp::int32 var_341;
    wp::int32 var_342;
    wp::float64 var_343;
    wp::float64 var_344;
    wp::int32 var_345;
    wp::int32 var_346;
    wp::float64 var_347;
    wp::float64 var_348;
    wp::float64 var_349;
    const wp::int32 var_350 = 1;
    wp::int32 var_351;
    wp::int32 var_352;
    wp::float64 var_353;
    wp::int32 var_354;
    wp::int32 var_355;
    wp::float64 var_356;
    wp::float64 var_357;
    wp::int32 var_358;
    wp::int32 var_359;
    wp::float64 var_360;
    wp::float64 var_361;
    wp::float64 var_362;
    wp::float64 var_363;
    wp::int32 var_364;
    wp::int32 var_365;
    wp::float64 var_366;
    wp::int32 var_367;
    const wp::int32 var_368 = 1;
    bool var_369;
    wp::int32 var_370;
    wp::int32 var_371;
    wp::float64 var_372;
    const wp::int32 var_373 = 0;
    wp::int32 var_374;
    wp::int32 var_375;
    wp::float64 var_376;
    wp::int32 var_377;
    wp::int32 var_378;
    wp::float64 var_379;
    wp::float64 var_380;
    wp::int32 var_381;
    wp::int32 var_382;
    wp::float64 var_383;
    wp::float64 var_384;
    wp::float64 var_385;
    const wp::int32 var_386 = 1;
    wp::int32 var_387;
    wp::int32 var_388;
    wp::float64 var_389;
    wp::int32 var_390;
    wp::int32 var_391;
    wp::float64 var_392;
    wp::float64 var_393;
    wp::int32 var_394;
    wp::int32 var_395;
    wp::float64 var_396;
    wp::float64 var_397;
    wp::float64 var_398;
    wp::float64 var_399;
    wp::int32 var_400;
    wp::int32 var_401;
    wp::float64 var_402;
    wp::int32 var_403;
    const wp::int32 var_404 = 2;
    bool var_405;
    wp::int32 var_406;
    wp::int32 var_407;
    wp::float64 var_408;
    const wp::int32 var_409 = 0;
    wp::int32 var_410;
    wp::int32 var_411;
    wp::float64 var_412;
    wp::int32 var_413;
    wp::int32 var_414;
    wp::float64 var_415;
    wp::float64 var_416;
    wp::int32 var_417;
    wp::int32 var_418;
    wp::float64 var_419;
    wp::float64 var_420;
    wp::float64 var_421;
    const wp::int32 var_422 = 1;
    wp::int32 var_423;
    wp::int32 var_424;
    wp::float64 var_425;
    wp::int32 var_426;
    wp::int32 var_427;
    wp::float64 var_428;
    wp::float64 var_429;
    wp::int32 var_430;
    wp::int32 var_431;
    wp::float64 var_432;
    wp::float64 var_433;
    wp::float64 var_434;
    wp::float64 var_435;
    wp::int32 var_436;
    wp::int32 var_437;
    wp::float64 var_438;
    wp::int32 var_439;
    const wp::int32 var_440 = 3;
    bool var_441;
    wp::int32 var_442;
    wp::int32 var_443;
    wp::float64 var_444;
    const wp::int32 var_445 = 0;
    wp::int32 var_446;
    wp::int32 var_447;
    wp::float64 var_448;
    wp::int32 var_449;
    wp::int32 var_450;
    wp::float64 var_451;
    wp::float64 var_452;
    wp::int32 var_453;
    wp::int32 var_454;
    wp::float64 var_455;
    wp::float64 var_456;
    wp::float64 var_457;
    const wp::int32 var_458 = 1;
    wp::int32 var_459;
    wp::int32 var_460;
    wp::float64 var_461;
    wp::int32 var_462;
    wp::int32 var_463;
    wp::float64 var_464;
    wp::float64 var_465;
    wp::int32 var_466;
    wp::int32 var_467;
    wp::float64 var_468;
    wp::float64 var_469;
    wp::float64 var_470;
    wp::float64 var_471;
    wp::int32 var_472;
    wp::int32 var_473;
    wp::float64 var_474;
    wp::int32 var_475;
    const wp::int32 var_476 = 4;
    bool var_477;
    wp::int32 var_478;
    wp::int32 var_479;
    wp::float64 var_480;
    const wp::int32 var_481 = 0;
    wp::int32 var_482;
    wp::int32 var_483;
    wp::float64 var_484;
    wp::int32 var_485;
    wp::int32 var_486;
    wp::float64 var_487;
    wp::float64 var_488;
    wp::int32 var_489;
    wp::int32 var_490;
    wp::float64 var_491;
    wp::float64 var_492;
    wp::float64 var_493;
    const wp::int32 var_494 = 1;
    wp::int32 var_495;
    wp::int32 var_496;
    wp::float64 var_497;
    wp::int32 var_498;
    wp::int32 var_499;
    wp::float64 var_500;
    wp::float64 var_501;
    wp::int32 var_502;
    wp::int32 var_503;
    wp::float64 var_504;
    wp::float64 var_505;
    wp::float64 var_506;
    wp::float64 var_507;
    wp::int32 var_508;
    wp::int32 var_509;
    wp::float64 var_510;
    wp::int32 var_511;
    const wp::int32 var_512 = 5;
    bool var_513;
    wp::int32 var_514;
    wp::int32 var_515;
    wp::float64 var_516;
    const wp::int32 var_517 = 0;
    wp::int32 var_518;
    wp::int32 var_519;
    wp::float64 var_520;
    wp::int32 var_521;
    wp::int32 var_522;
    wp::float64 var_523;
    wp::float64 var_524;
    wp::int32 var_525;
    wp::int32 var_526;
    wp::float64 var_527;
    wp::float64 var_528;
    wp::float64 var_529;
    const wp::int32 var_530 = 1;
    wp::int32 var_531;
    wp::int32 var_532;
    wp::float64 var_533;
    wp::int32 var_534;
    wp::int32 var_535;
    wp::float64 var_536;
    wp::float64 var_537;
    wp::int32 var_538;
    wp::int32 var_539;
    wp::float64 var_540;
    wp::float64 var_541;
    wp::float64 var_542;
    wp::float64 var_543;
    wp::int32 var_544;
    wp::int32 var_545;
    wp::float64 var_546;
    wp::int32 var_547;
    const wp::int32 var_548 = 3;
    wp::int32 var_549;
    wp::int32 var_550;
    wp::float64 var_551;
    const wp::int32 var_552 = 0;
    wp::int32 var_553;
    wp::int32 var_554;
    wp::float64 var_555;
    wp::int32 var_556;
    wp::int32 var_557;
    wp::float64 var_558;
    wp::float64 var_559;
    wp::int32 var_560;
    wp::int32 var_561;
    wp::float64 var_562;
    wp::float64 var_563;
    wp::float64 var_564;
    const wp::int32 var_565 = 1;
    wp::int32 var_566;
    wp::int32 var_567;
    wp::float64 var_568;
    wp::int32 var_569;
    wp::int32 var_570;
    wp::float64 var_571;
    wp::float64 var_572;
    wp::int32 var_573;
    wp::int32 var_574;
    wp::float64 var_575;
    wp::float64 var_576;
    wp::float64 var_577;
    const wp::int32 var_578 = 2;
    wp::int32 var_579;
    wp::int32 var_580;
    wp::float64 var_581;
    wp::int32 var_582;
    wp::int32 var_583;
    wp::float64 var_584;
    wp::float64 var_585;
    wp::int32 var_586;
    wp::int32 var_587;
    wp::float64 var_588;
    wp::float64 var_589;
    wp::float64 var_590;
    wp::float64 var_591;
    wp::float64 var_592;
    wp::float64 var_593;
    bool var_594;
    wp::float64 var_595;
    wp::float64 var_596;
    wp::float64 var_597;
    wp::float64 var_598;
    bool var_599;
    wp::float64 var_600;
    wp::float64 var_601;
    wp::float64 var_602;
    wp::float64 var_603;
    wp::float64 var_604;
    wp::float64 var_605;
    wp::int32 var_606;
    wp::int32 var_607;
    const wp::int32 var_608 = 0;
    bool var_609;
    wp::int32 var_610;
    wp::int32 var_611;
    wp::float64 var_612;
    const wp::int32 var_613 = 0;
    wp::int32 var_614;
    wp::int32 var_615;
    wp::float64 var_616;
    wp::int32 var_617;
    wp::int32 var_618;
    wp::float64 var_619;
    wp::float64 var_620;
    wp::int32 var_621;
    wp::int32 var_622;
    wp::float64 var_623;
    wp::float64 var_624;
    wp::float64 var_625;
    const wp::int32 var_626 = 1;
    wp::int32 var_627;
    wp::int32 var_628;
    wp::float64 var_629;
    wp::int32 var_630;
    wp::int32 var_631;
    wp::float64 var_632;
    wp::float64 var_633;
    wp::int32 var_634;
    wp::int32 var_635;
    wp::float64 var_636;
    wp::float64 var_637;
    wp::float64 var_638;
    const wp::int32 var_639 = 2;
    wp::int32 var_640;
    wp::int32 var_641;
    wp::float64 var_642;
    wp::int32 var_643;
    wp::int32 var_644;
    wp::float64 var_645;
    wp::float64 var_646;
    wp::int32 var_647;
    wp::int32 var_648;
    wp::float64 var_649;
    wp::float64 var_650;
    wp::float64 var_651;
    wp::float64 var_652;
    wp::int32 var_653;
    wp::int32 var_654;
    wp::float64 var_655;
    wp::int32 var_656;
    const wp::int32 var_657 = 1;
    bool var_658;
    wp::int32 var_659;
    wp::int32 var_660;
    wp::float64 var_661;
    const wp::int32 var_662 = 0;
    wp::int32 var_663;
    wp::int32 var_664;
    wp::float64 var_665;
    wp::int32 var_666;
    wp::int32 var_667;
    wp::float64 var_668;
    wp::float64 var_669;
    wp::int32 var_670;
    wp::int32 var_671;
    wp::float64 var_672;
    wp::float64 var_673;
    wp::float64 var_674;
    const wp::int32 var_675 = 1;
    wp::int32 var_676;
    wp::int32 var_677;
    wp::float64 var_678;
    wp::int32 var_679;
    wp::int32 var_680;
    wp::float64 var_681;
    wp::float64 var_682;
    wp::int32 var_683;
    wp::int32 var_684;
    wp::float64 var_685;
    wp::float64 var_686;
    wp::float64 var_687;
    const wp::int32 var_688 = 2;
    wp::int32 var_689;
    wp::int32 var_690;
    wp::float64 var_691;
    wp::int32 var_692;
    wp::int32 var_693;
    wp::float64 var_694;
    wp::float64 var_695;
    wp::int32 var_696;
    wp::int32 var_697;
    wp::float64 var_698;
    wp::float64 var_699;
    wp::float64 var_700;
    wp::float64 var_701;
    wp::int32 var_702;
    wp::int32 var_703;
    wp::float64 var_704;
    wp::int32 var_705;
    const wp::int32 var_706 = 2;
    bool var_707;
    wp::int32 var_708;
    wp::int32 var_709;
    wp::float64 var_710;
    const wp::int32 var_711 = 0;
    wp::int32 var_712;
    wp::int32 var_713;
    wp::float64 var_714;
    wp::int32 var_715;
    wp::int32 var_716;
    wp::float64 var_717;
    wp::float64 var_718;
    wp::int32 var_719;
    wp::int32 var_720;
    wp::float64 var_721;
    wp::float64 var_722;
    wp::float64 var_723;
    const wp::int32 var_724 = 1;
    wp::int32 var_725;
    wp::int32 var_726;
    wp::float64 var_727;
    wp::int32 var_728;
    wp::int32 var_729;
    wp::float64 var_730;
    wp::float64 var_731;
    wp::int32 var_732;
    wp::int32 var_733;
    wp::float64 var_734;
    wp::float64 var_735;
    wp::float64 var_736;
    const wp::int32 var_737 = 2;
    wp::int32 var_738;
    wp::int32 var_739;
    wp::float64 var_740;
    wp::int32 var_741;
    wp::int32 var_742;
    wp::float64 var_743;
    wp::float64 var_744;
    wp::int32 var_745;
    wp::int32 var_746;
    wp::float64 var_747;
    wp::float64 var_748;
    wp::float64 var_749;
    wp::float64 var_750;
    wp::int32 var_751;
    wp::int32 var_752;
    wp::float64 var_753;
    wp::int32 var_754;
    const wp::int32 var_755 = 3;
    bool var_756;
    wp::int32 var_757;
    wp::int32 var_758;
    wp::float64 var_759;
    const wp::int32 var_760 = 0;
    wp::int32 var_761;
    wp::int32 var_762;
    wp::float64 var_763;
    wp::int32 var_764;
    wp::int32 var_765;
    wp::float64 var_766;
    wp::float64 var_767;
    wp::int32 var_768;
    wp::int32 var_769;
    wp::float64 var_770;
    wp::float64 var_771;
    wp::float64 var_772;
    const wp::int32 var_773 = 1;
    wp::int32 var_774;
    wp::int32 var_775;
    wp::float64 var_776;
    wp::int32 var_777;
    wp::int32 var_778;
    wp::float64 var_779;
    wp::float64 var_780;
    wp::int32 var_781;
    wp::int32 var_782;
    wp::float64 var_783;
    wp::float64 var_784;
    wp::float64 var_785;
    const wp::int32 var_786 = 2;
    wp::int32 var_787;
    wp::int32 var_788;
    wp::float64 var_789;
    wp::int32 var_790;
    wp::int32 var_791;
    wp::float64 var_792;
    wp::float64 var_793;
    wp::int32 var_794;
    wp::int32 var_795;
    wp::float64 var_796;
    wp::float64 var_797;
    wp::float64 var_798;
    wp::float64 var_799;
    wp::int32 var_800;
    wp::int32 var_801;
    wp::float64 var_802;
    wp::int32 var_803;
    const wp::int32 var_804 = 4;
    bool var_805;
    wp::int32 var_806;
    wp::int32 var_807;
    wp::float64 var_808;
    const wp::int32 var_809 = 0;
    wp::int32 var_810;
    wp::int32 var_811;
    wp::float64 var_812;
    wp::int32 var_813;
    wp::int32 var_814;
    wp::float64 var_815;
    wp::float64 var_816;
    wp::int32 var_817;
    wp::int32 var_818;
    wp::float64 var_819;
    wp::float64 var_820;
    wp::float64 var_821;
    const wp::int32 var_822 = 1;
    wp::int32 var_823;
    wp::int32 var_824;
    wp::float64 var_825;
    wp::int32 var_826;
    wp::int32 var_827;
    wp::float64 var_828;
    wp::float64 var_829;
    wp::int32 var_830;
    wp::int32 var_831;
    wp::float64 var_832;
    wp::float64 var_833;
    wp::float64 var_834;
    const wp::int32 var_835 = 2;
    wp::int32 var_836;
    wp::int32 var_837;
    wp::float64 var_838;
    wp::int32 var_839;
    wp::int32 var_840;
    wp::float64 var_841;
    wp::float64 var_842;
    wp::int32 var_843;
    wp::int32 var_844;
    wp::float64 var_845;
    wp::float64 var_846;
    wp::float64 var_847;
    wp::float64 var_848;
    wp::int32 var_849;
    wp::int32 var_850;
    wp::float64 var_851;
    wp::int32 var_852;
    const wp::int32 var_853 = 5;
    bool var_854;
    wp::int32 var_855;
    wp::int32 var_856;
    wp::float64 var_857;
    const wp::int32 var_858 = 0;
    wp::int32 var_859;
    wp::int32 var_860;
    wp::float64 var_861;
    wp::int32 var_862;
    wp::int32 var_863;
    wp::float64 var_864;
    wp::float64 var_865;
    wp::int32 var_866;
    wp::int32 var_867;
    wp::float64 var_868;
    wp::float64 var_869;
    wp::float64 var_870;
    const wp::int32 var_871 = 1;
    wp::int32 var_872;
    wp::int32 var_873;
    wp::float64 var_874;
    wp::int32 var_875;
    wp::int32 var_876;
    wp::float64 var_877;
    wp::float64 var_878;
    wp::int32 var_879;
    wp::int32 var_880;
    wp::float64 var_881;
    wp::float64 var_882;
    wp::float64 var_883;
    const wp::int32 var_884 = 2;
    wp::int32 var_885;
    wp::int32 var_886;
    wp::float64 var_887;
    wp::int32 var_888;
    wp::int32 var_889;
    wp::float64 var_890;
    wp::float64 var_891;
    wp::int32 var_892;
    wp::int32 var_893;
    wp::float64 var_894;
    wp::float64 var_895;
    wp::float64 var_896;
    wp::float64 var_897;
    wp::int32 var_898;
    wp::int32 var_899;
    wp::float64 var_900;
    wp::int32 var_901;
    const wp::int32 var_902 = 4;
    wp::int32 var_903;
    wp::int32 var_904;
    wp::float64 var_905;
    const wp::int32 var_906 = 0;
    wp::int32 var_907;
    wp::int32 var_908;
    wp::float64 var_909;
    wp::int32 var_910;
    wp::int32 var_911;
    wp::float64 var_912;
    wp::float64 var_913;
    wp::int32 var_914;
    wp::int32 var_915;
    wp::float64 var_916;
    wp::float64 var_917;
    wp::float64 var_918;
    const wp::int32 var_919 = 1;
    wp::int32 var_920;
    wp::int32 var_921;
    wp::float64 var_922;
    wp::int32 var_923;
    wp::int32 var_924;
    wp::float64 var_925;
    wp::float64 var_926;
    wp::int32 var_927;
    wp::int32 var_928;
    wp::float64 var_929;
    wp::float64 var_930;
    wp::float64 var_931;
    const wp::int32 var_932 = 2;
    wp::int32 var_933;
    wp::int32 var_934;
    wp::float64 var_935;
    wp::int32 var_936;
    wp::int32 var_937;
    wp::float64 var_938;
    wp::float64 var_939;
    wp::int32 var_940;
    wp::int32 var_941;
    wp::float64 var_942;
    wp::float64 var_943;
    wp::float64 var_944;
    const wp::int32 var_945 = 3;
    wp::int32 var_946;
    wp::int32 var_947;
    wp::float64 var_948;
    wp::int32 var_949;
    wp::int32 var_950;
    wp::float64 var_951;
    wp::float64 var_952;
    wp::int32 var_953;
    wp::int32 var_954;
    wp::float64 var_955;
    wp::float64 var_956;
    wp::float64 var_957;
    wp::float64 var_958;
    wp::float64 var_959;
    wp::float64 var_960;
    bool var_961;
    wp::float64 var_962;
    wp::float64 var_963;
    wp::float64 var_964;
    wp::float64 var_965;
    bool var_966;
    wp::float64 var_967;
    wp::float64 var_968;
    wp::float64 var_969;
    wp::float64 var_970;
    wp::float64 var_971;
    wp::float64 var_972;
    wp::int32 var_973;
    wp::int32 var_974;
    const wp::int32 var_975 = 0;
    bool var_976;
    wp::int32 var_977;
    wp::int32 var_978;
    wp::float64 var_979;
    const wp::int32 var_980 = 0;
    wp::int32 var_981;
    wp::int32 var_982;
    wp::float64 var_983;
    wp::int32 var_984;
    wp::int32 var_985;
    wp::float64 var_986;
    wp::float64 var_987;
    wp::int32 var_988;
    wp::int32 var_989;
    wp::float64 var_990;
    wp::float64 var_991;
    wp::float64 var_992;
    const wp::int32 var_993 = 1;
    wp::int32 var_994;
    wp::int32 var_995;
    wp::float64 var_996;
    wp::int32 var_997;
    wp::int32 var_998;
    wp::float64 var_999;
    wp::float64 var_1000;
    wp::int32 var_1001;
    wp::int32 var_1002;
    wp::float64 var_1003;
    wp::float64 var_1004;
    wp::float64 var_1005;
    const wp::int32 var_1006 = 2;
    wp::int32 var_1007;
    wp::int32 var_1008;
    wp::float64 var_1009;
    wp::int32 var_1010;
    wp::int32 var_1011;
    wp::float64 var_1012;
    wp::float64 var_1013;
    wp::int32 var_1014;
    wp::int32 var_1015;
    wp::float64 var_1016;
    wp::float64 var_1017;
    wp::float64 var_1018;
    const wp::int32 var_1019 = 3;
    wp::int32 var_1020;
    wp::int32 var_1021;
    wp::float64 var_1022;
    wp::int32 var_1023;
    wp::int32 var_1024;
    wp::float64 var_1025;
    wp::float64 var_1026;
    wp::int32 var_1027;
    wp::int32 var_1028;
    wp::float64 var_1029;
    wp::float64 var_1030;
    wp::float64 var_1031;
    wp::float64 var_1032;
    wp::int32 var_1033;
    wp::int32 var_1034;
    wp::float64 var_1035;
    wp::int32 var_1036;
    const wp::int32 var_1037 = 1;
    bool var_1038;
    wp::int32 var_1039;
    wp::int32 var_1040;
    wp::float64 var_1041;
    const wp::int32 var_1042 = 0;
    wp::int32 var_1043;
    wp::int32 var_1044;
    wp::float64 var_1045;
    wp::int32 var_1046;
    wp::int32 var_1047;
    wp::float64 var_1048;
    wp::float64 var_1049;
    wp::int32 var_1050;
    wp::int32 var_1051;
    wp::float64 var_1052;
    wp::float64 var_1053;
    wp::float64 var_1054;
    const wp::int32 var_1055 = 1;
    wp::int32 var_1056;
    wp::int32 var_1057;
    wp::float64 var_1058;
    wp::int32 var_1059;
    wp::int32 var_1060;
    wp::float64 var_1061;
    wp::float64 var_1062;
    wp::int32 var_1063;
    wp::int32 var_1064;
    wp::float64 var_1065;
    wp::float64 var_1066;
    wp::float64 var_1067;
    const wp::int32 var_1068 = 2;
    wp::int32 var_1069;
    wp::int32 var_1070;
    wp::float64 var_1071;
    wp::int32 var_1072;
    wp::int32 var_1073;
    wp::float64 var_1074;
    wp::float64 var_1075;
    wp::int32 var_1076;
    wp::int32 var_1077;
    wp::float64 var_1078;
    wp::float64 var_1079;
    wp::float64 var_1080;
    const wp::int32 var_1081 = 3;
    wp::int32 var_1082;
    wp::int32 var_1083;
    wp::float64 var_1084;
    wp::int32 var_1085;
    wp::int32 var_1086;
    wp::float64 var_1087;
    wp::float64 var_1088;
    wp::int32 var_1089;
    wp::int32 var_1090;
    wp::float64 var_1091;
    wp::float64 var_1092;
    wp::float64 var_1093;
    wp::float64 var_1094;
    wp::int32 var_1095;
    wp::int32 var_1096;
    wp::float64 var_1097;
    wp::int32 var_1098;
    const wp::int32 var_1099 = 2;
    bool var_1100;
    wp::int32 var_1101;
    wp::int32 var_1102;
    wp::float64 var_1103;
    const wp::int32 var_1104 = 0;
    wp::int32 var_1105;
    wp::int32 var_1106;
    wp::float64 var_1107;
    wp::int32 var_1108;
    wp::int32 var_1109;
    wp::float64 var_1110;
    wp::float64 var_1111;
    wp::int32 var_1112;
    wp::int32 var_1113;
    wp::float64 var_1114;
    wp::float64 var_1115;
    wp::float64 var_1116;
    const wp::int32 var_1117 = 1;
    wp::int32 var_1118;
    wp::int32 var_1119;
    wp::float64 var_1120;
    wp::int32 var_1121;
    wp::int32 var_1122;
    wp::float64 var_1123;
    wp::float64 var_1124;
    wp::int32 var_1125;
    wp::int32 var_1126;
    wp::float64 var_1127;
    wp::float64 var_1128;
    wp::float64 var_1129;
    const wp::int32 var_1130 = 2;
    wp::int32 var_1131;
    wp::int32 var_1132;
    wp::float64 var_1133;
    wp::int32 var_1134;
    wp::int32 var_1135;
    wp::float64 var_1136;
    wp::float64 var_1137;
    wp::int32 var_1138;
    wp::int32 var_1139;
    wp::float64 var_1140;
    wp::float64 var_1141;
    wp::float64 var_1142;
    const wp::int32 var_1143 = 3;
    wp::int32 var_1144;
    wp::int32 var_1145;
    wp::float64 var_1146;
    wp::int32 var_1147;
    wp::int32 var_1148;
    wp::float64 var_1149;
    wp::float64 var_1150;
    wp::int32 var_1151;
    wp::int32 var_1152;
    wp::float64 var_1153;
    wp::float64 var_1154;
    wp::float64 var_1155;
    wp::float64 var_1156;
    wp::int32 var_1157;
    wp::int32 var_1158;
    wp::float64 var_1159;
    wp::int32 var_1160;
    const wp::int32 var_1161 = 3;
    bool var_1162;
    wp::int32 var_1163;
    wp::int32 var_1164;
    wp::float64 var_1165;
    const wp::int32 var_1166 = 0;
    wp::int32 var_1167;
    wp::int32 var_1168;
    wp::float64 var_1169;
    wp::int32 var_1170;
    wp::int32 var_1171;
    wp::float64 var_1172;
    wp::float64 var_1173;
    wp::int32 var_1174;
    wp::int32 var_1175;
    wp::float64 var_1176;
    wp::float64 var_1177;
    wp::float64 var_1178;
    const wp::int32 var_1179 = 1;
    wp::int32 var_1180;
    wp::int32 var_1181;
    wp::float64 var_1182;
    wp::int32 var_1183;
    wp::int32 var_1184;
    wp::float64 var_1185;
    wp::float64 var_1186;
    wp::int32 var_1187;
    wp::int32 var_1188;
    wp::float64 var_1189;
    wp::float64 var_1190;
    wp::float64 var_1191;
    const wp::int32 var_1192 = 2;
    wp::int32 var_1193;
    wp::int32 var_1194;
    wp::float64 var_1195;
    wp::int32 var_1196;
    wp::int32 var_1197;
    wp::float64 var_1198;
    wp::float64 var_1199;
    wp::int32 var_1200;
    wp::int32 var_1201;
    wp::float64 var_1202;
    wp::float64 var_1203;
    wp::float64 var_1204;
    const wp::int32 var_1205 = 3;
    wp::int32 var_1206;
    wp::int32 var_1207;
    wp::float64 var_1208;
    wp::int32 var_1209;
    wp::int32 var_1210;
    wp::float64 var_1211;
    wp::float64 var_1212;
    wp::int32 var_1213;
    wp::int32 var_1214;
    wp::float64 var_1215;
    wp::float64 var_1216;
    wp::float64 var_1217;
    wp::float64 var_1218;
    wp::int32 var_1219;
    wp::int32 var_1220;
    wp::float64 var_1221;
    wp::int32 var_1222;
    const wp::int32 var_1223 = 4;
    bool var_1224;
    wp::int32 var_1225;
    wp::int32 var_1226;
    wp::float64 var_1227;
    const wp::int32 var_1228 = 0;
    wp::int32 var_1229;
    wp::int32 var_1230;
    wp::float64 var_1231;
    wp::int32 var_1232;
    wp::int32 var_1233;
    wp::float64 var_1234;
    wp::float64 var_1235;
    wp::int32 var_1236;
    wp::int32 var_1237;
    wp::float64 var_1238;
    wp::float64 var_1239;
    wp::float64 var_1240;
    const wp::int32 var_1241 = 1;
    wp::int32 var_1242;
    wp::int32 var_1243;
    wp::float64 var_1244;
    wp::int32 var_1245;
    wp::int32 var_1246;
    wp::float64 var_1247;
    wp::float64 var_1248;
    wp::int32 var_1249;
    wp::int32 var_1250;
    wp::float64 var_1251;
    wp::float64 var_1252;
    wp::float64 var_1253;
    const wp::int32 var_1254 = 2;
    wp::int32 var_1255;
    wp::int32 var_1256;
    wp::float64 var_1257;
    wp::int32 var_1258;
    wp::int32 var_1259;
    wp::float64 var_1260;
    wp::float64 var_1261;
    wp::int32 var_1262;
    wp::int32 var_1263;
    wp::float64 var_1264;
    wp::float64 var_1265;
    wp::float64 var_1266;
    const wp::int32 var_1267 = 3;
    wp::int32 var_1268;
    wp::int32 var_1269;
    wp::float64 var_1270;
    wp::int32 var_1271;
    wp::int32 var_1272;
    wp::float64 var_1273;
    wp::float64 var_1274;
    wp::int32 var_1275;
    wp::int32 var_1276;
    wp::float64 var_1277;
    wp::float64 var_1278;
    wp::float64 var_1279;
    wp::float64 var_1280;
    wp::int32 var_1281;
    wp::int32 var_1282;
    wp::float64 var_1283;
    wp::int32 var_1284;
    const wp::int32 var_1285 = 5;
    bool var_1286;
    wp::int32 var_1287;
    wp::int32 var_1288;
    wp::float64 var_1289;
    const wp::int32 var_1290 = 0;
    wp::int32 var_1291;
    wp::int32 var_1292;
    wp::float64 var_1293;
    wp::int32 var_1294;
    wp::int32 var_1295;
    wp::float64 var_1296;
    wp::float64 var_1297;
    wp::int32 var_1298;
    wp::int32 var_1299;
    wp::float64 var_1300;
    wp::float64 var_1301;
    wp::float64 var_1302;
    const wp::int32 var_1303 = 1;
    wp::int32 var_1304;
    wp::int32 var_1305;
    wp::float64 var_1306;
    wp::int32 var_1307;
    wp::int32 var_1308;
    wp::float64 var_1309;
    wp::float64 var_1310;
    wp::int32 var_1311;
    wp::int32 var_1312;
    wp::float64 var_1313;
    wp::float64 var_1314;
    wp::float64 var_1315;
    const wp::int32 var_1316 = 2;
    wp::int32 var_1317;
    wp::int32 var_1318;
    wp::float64 var_1319;
    wp::int32 var_1320;
    wp::int32 var_1321;
    wp::float64 var_1322;
    wp::float64 var_1323;
    wp::int32 var_1324;
    wp::int32 var_1325;
    wp::float64 var_1326;
    wp::float64 var_1327;
    wp::float64 var_1328;
    const wp::int32 var_1329 = 3;
    wp::int32 var_1330;
    wp::int32 var_1331;
    wp::float64 var_1332;
    wp::int32 var_1333;
    wp::int32 var_1334;
    wp::float64 var_1335;
    wp::float64 var_1336;
    wp::int32 var_1337;
    wp::int32 var_1338;
    wp::float64 var_1339;
    wp::float64 var_1340;
    wp::float64 var_1341;
    wp::float64 var_1342;
    wp::int32 var_1343;
    wp::int32 var_1344;
    wp::float64 var_1345;
    wp::int32 var_1346;
    const wp::int32 var_1347 = 5;
    wp::int32 var_1348;
    wp::int32 var_1349;
    wp::float64 var_1350;
    const wp::int32 var_1351 = 0;
    wp::int32 var_1352;
    wp::int32 var_1353;
    wp::float64 var_1354;
    wp::int32 var_1355;
    wp::int32 var_1356;
    wp::float64 var_1357;
    wp::float64 var_1358;
    wp::int32 var_1359;
    wp::int32 var_1360;
    wp::float64 var_1361;
    wp::float64 var_1362;
    wp::float64 var_1363;
    const wp::int32 var_1364 = 1;
    wp::int32 var_1365;
    wp::int32 var_1366;
    wp::float64 var_1367;
    wp::int32 var_1368;
    wp::int32 var_1369;
    wp::float64 var_1370;
    wp::float64 var_1371;
    wp::int32 var_1372;
    wp::int32 var_1373;
    wp::float64 var_1374;
    wp::float64 var_1375;
    wp::float64 var_1376;
    const wp::int32 var_1377 = 2;
    wp::int32 var_1378;
    wp::int32 var_1379;
    wp::float64 var_1380;
    wp::int32 var_1381;
    wp::int32 var_1382;
    wp::float64 var_1383;
    wp::float64 var_1384;
    wp::int32 var_1385;
    wp::int32 var_1386;
    wp::float64 var_1387;
    wp::float64 var_1388;
    wp::float64 var_1389;
    const wp::int32 var_1390 = 3;
    wp::int32 var_1391;
    wp::int32 var_1392;
    wp::float64 var_1393;
    wp::int32 var_1394;
    wp::int32 var_1395;
    wp::float64 var_1396;
    wp::float64 var_1397;
    wp::int32 var_1398;
    wp::int32 var_1399;
    wp::float64 var_1400;
    wp::float64 var_1401;
    wp::float64 var_1402;
    const wp::int32 var_1403 = 4;
    wp::int32 var_1404;
    wp::int32 var_1405;
    wp::float64 var_1406;
    wp::int32 var_1407;
    wp::int32 var_1408;
    wp::float64 var_1409;
    wp::float64 var_1410;
    wp::int32 var_1411;
    wp::int32 var_1412;
    wp::float64 var_1413;
    wp::float64 var_1414;
    wp::float64 var_1415;
    wp::float64 var_1416;
    wp::float64 var_1417;
    wp::float64 var_1418;
    bool var_1419;
    wp::float64 var_1420;
    wp::float64 var_1421;
    wp::float64 var_1422;
    wp::float64 var_1423;
    bool var_1424;
    wp::float64 var_1425;
    wp::float64 var_1426;
    wp::float64 var_1427;
    wp::float64 var_1428;
    wp::float64 var_1429;
    wp::float64 var_1430;
    wp::int32 var_1431;
    wp::int32 var_1432;
    const wp::int32 var_1433 = 0;
    bool var_1434;
    wp::int32 var_1435;
    wp::int32 var_1436;
    wp::float64 var_1437;
    const wp::int32 var_1438 = 0;
    wp::int32 var_1439;
    wp::int32 var_1440;
    wp::float64 var_1441;
    wp::int32 var_1442;
    wp::int32 var_1443;
    wp::float64 var_1444;
    wp::float64 var_1445;
    wp::int32 var_1446;
    wp::int32 var_1447;
    wp::float64 var_1448;
    wp::float64 var_1449;
    wp::float64 var_1450;
    const wp::int32 var_1451 = 1;
    wp::int32 var_1452;
    wp::int32 var_1453;
    wp::float64 var_1454;
    wp::int32 var_1455;
    wp::int32 var_1456;
    wp::float64 var_1457;
    wp::float64 var_1458;
    wp::int32 var_1459;
    wp::int32 var_1460;
    wp::float64 var_1461;
    wp::float64 var_1462;
    wp::float64 var_1463;
    const wp::int32 var_1464 = 2;
    wp::int32 var_1465;
    wp::int32 var_1466;
    wp::float64 var_1467;
    wp::int32 var_1468;
    wp::int32 var_1469;
    wp::float64 var_1470;
    wp::float64 var_1471;
    wp::int32 var_1472;
    wp::int32 var_1473;
    wp::float64 var_1474;
    wp::float64 var_1475;
    wp::float64 var_1476;
    const wp::int32 var_1477 = 3;
    wp::int32 var_1478;
    wp::int32 var_1479;
    wp::float64 var_1480;
    wp::int32 var_1481;
    wp::int32 var_1482;
    wp::float64 var_1483;
    wp::float64 var_1484;
    wp::int32 var_1485;
    wp::int32 var_1486;
    wp::float64 var_1487;
    wp::float64 var_1488;
    wp::float64 var_1489;
    const wp::int32 var_1490 = 4;
    wp::int32 var_1491;
    wp::int32 var_1492;
    wp::float64 var_1493;
    wp::int32 var_1494;
    wp::int32 var_1495;
    wp::float64 var_1496;
    wp::float64 var_1497;
    wp::int32 var_1498;
    wp::int32 var_1499;
    wp::float64 var_1500;
    wp::float64 var_1501;
    wp::float64 var_1502;
    wp::float64 var_1503;
    wp::int32 var_1504;
    wp::int32 var_1505;
    wp::float64 var_1506;
    wp::int32 var_1507;
    const wp::int32 var_1508 = 1;
    bool var_1509;
    wp::int32 var_1510;
    wp::int32 var_1511;
    wp::float64 var_1512;
    const wp::int32 var_1513 = 0;
    wp::int32 var_1514;
    wp::int32 var_1515;
    wp::float64 var_1516;
    wp::int32 var_1517;
    wp::int32 var_1518;
    wp::float64 var_1519;
    wp::float64 var_1520;
    wp::int32 var_1521;
    wp::int32 var_1522;
    wp::float64 var_1523;
    wp::float64 var_1524;
    wp::float64 var_1525;
    const wp::int32 var_1526 = 1;
    wp::int32 var_1527;
    wp::int32 var_1528;
    wp::float64 var_1529;
    wp::int32 var_1530;
    wp::int32 var_1531;
    wp::float64 var_1532;
    wp::float64 var_1533;
    wp::int32 var_1534;
    wp::int32 var_1535;
    wp::float64 var_1536;
    wp::float64 var_1537;
    wp::float64 var_1538;
    const wp::int32 var_1539 = 2;
    wp::int32 var_1540;
    wp::int32 var_1541;
    wp::float64 var_1542;
    wp::int32 var_1543;
    wp::int32 var_1544;
    wp::float64 var_1545;
    wp::float64 var_1546;
    wp::int32 var_1547;
    wp::int32 var_1548;
    wp::float64 var_1549;
    wp::float64 var_1550;
    wp::float64 var_1551;
    const wp::int32 var_1552 = 3;
    wp::int32 var_1553;
    wp::int32 var_1554;
    wp::float64 var_1555;
    wp::int32 var_1556;
    wp::int32 var_1557;
    wp::float64 var_1558;
    wp::float64 var_1559;
    wp::int32 var_1560;
    wp::int32 var_1561;
    wp::float64 var_1562;
    wp::float64 var_1563;
    wp::float64 var_1564;
    const wp::int32 var_1565 = 4;
    wp::int32 var_1566;
    wp::int32 var_1567;
    wp::float64 var_1568;
    wp::int32 var_1569;
    wp::int32 var_1570;
    wp::float64 var_1571;
    wp::float64 var_1572;
    wp::int32 var_1573;
    wp::int32 var_1574;
    wp::float64 var_1575;
    wp::float64 var_1576;
    wp::float64 var_1577;
    wp::float64 var_1578;
    wp::int32 var_1579;
    wp::int32 var_1580;
    wp::float64 var_1581;
    wp::int32 var_1582;
    const wp::int32 var_1583 = 2;
    bool var_1584;
    wp::int32 var_1585;
    wp::int32 var_1586;
    wp::float64 var_1587;
    const wp::int32 var_1588 = 0;
    wp::int32 var_1589;
    wp::int32 var_1590;
    wp::float64 var_1591;
    wp::int32 var_1592;
    wp::int32 var_1593;
    wp::float64 var_1594;
    wp::float64 var_1595;
    wp::int32 var_1596;
    wp::int32 var_1597;
    wp::float64 var_1598;
    wp::float64 var_1599;
    wp::float64 var_1600;
    const wp::int32 var_1601 = 1;
    wp::int32 var_1602;
    wp::int32 var_1603;
    wp::float64 var_1604;
    wp::int32 var_1605;
    wp::int32 var_1606;
    wp::float64 var_1607;
    wp::float64 var_1608;
    wp::int32 var_1609;
    wp::int32 var_1610;
    wp::float64 var_1611;
    wp::float64 var_1612;
    wp::float64 var_1613;
    const wp::int32 var_1614 = 2;
    wp::int32 var_1615;
    wp::int32 var_1616;
    wp::float64 var_1617;
    wp::int32 var_1618;
    wp::int32 var_1619;
    wp::float64 var_1620;
    wp::float64 var_1621;
    wp::int32 var_1622;
    wp::int32 var_1623;
    wp::float64 var_1624;
    wp::float64 var_1625;
    wp::float64 var_1626;
    const wp::int32 var_1627 = 3;
    wp::int32 var_1628;
    wp::int32 var_1629;
    wp::float64 var_1630;
    wp::int32 var_1631;
    wp::int32 var_1632;
    wp::float64 var_1633;
    wp::float64 var_1634;
    wp::int32 var_1635;
    wp::int32 var_1636;
    wp::float64 var_1637;
    wp::float64 var_1638;
    wp::float64 var_1639;
    const wp::int32 var_1640 = 4;
    wp::int32 var_1641;
    wp::int32 var_1642;
    wp::float64 var_1643;
    wp::int32 var_1644;
    wp::int32 var_1645;
    wp::float64 var_1646;
    wp::float64 var_1647;
    wp::int32 var_1648;
    wp::int32 var_1649;
    wp::float64 var_1650;
    wp::float64 var_1651;
    wp::float64 var_1652;
    wp::float64 var_1653;
    wp::int32 var_1654;
    wp::int32 var_1655;
    wp::float64 var_1656;
    wp::int32 var_1657;
    const wp::int32 var_1658 = 3;
    bool var_1659;
    wp::int32 var_1660;
    wp::int32 var_1661;
    wp::float64 var_1662;
    const wp::int32 var_1663 = 0;
    wp::int32 var_1664;
    wp::int32 var_1665;
    wp::float64 var_1666;
    wp::int32 var_1667;
    wp::int32 var_1668;
    wp::float64 var_1669;
    wp::float64 var_1670;
    wp::int32 var_1671;
    wp::int32 var_1672;
    wp::float64 var_1673;
    wp::float64 var_1674;
    wp::float64 var_1675;
    const wp::int32 var_1676 = 1;
    wp::int32 var_1677;
    wp::int32 var_1678;
    wp::float64 var_1679;
    wp::int32 var_1680;
    wp::int32 var_1681;
    wp::float64 var_1682;
    wp::float64 var_1683;
    wp::int32 var_1684;
    wp::int32 var_1685;
    wp::float64 var_1686;
    wp::float64 var_1687;
    wp::float64 var_1688;
    const wp::int32 var_1689 = 2;
    wp::int32 var_1690;
    wp::int32 var_1691;
    wp::float64 var_1692;
    wp::int32 var_1693;
    wp::int32 var_1694;
    wp::float64 var_1695;
    wp::float64 var_1696;
    wp::int32 var_1697;
    wp::int32 var_1698;
    wp::float64 var_1699;
    wp::float64 var_1700;
    wp::float64 var_1701;
    const wp::int32 var_1702 = 3;
    wp::int32 var_1703;
    wp::int32 var_1704;
    wp::float64 var_1705;
    wp::int32 var_1706;
    wp::int32 var_1707;
    wp::float64 var_1708;
    wp::float64 var_1709;
    wp::int32 var_1710;
    wp::int32 var_1711;
    wp::float64 var_1712;
    wp::float64 var_1713;
    wp::float64 var_1714;
    const wp::int32 var_1715 = 4;
    wp::int32 var_1716;
    wp::int32 var_1717;
    wp::float64 var_1718;
    wp::int32 var_1719;
    wp::int32 var_1720;
    wp::float64 var_1721;
    wp::float64 var_1722;
    wp::int32 var_1723;
    wp::int32 var_1724;
    wp::float64 var_1725;
    wp::float64 var_1726;
    wp::float64 var_1727;
    wp::float64 var_1728;
    wp::int32 var_1729;
    wp::int32 var_1730;
    wp::float64 var_1731;
    wp::int32 var_1732;
    const wp::int32 var_1733 = 4;
    bool var_1734;
    wp::int32 var_1735;
    wp::int32 var_1736;
    wp::float64 var_1737;
    const wp::int32 var_1738 = 0;
    wp::int32 var_1739;
    wp::int32 var_1740;
    wp::float64 var_1741;
    wp::int32 var_1742;
    wp::int32 var_1743;
    wp::float64 var_1744;
    wp::float64 var_1745;
    wp::int32 var_1746;
    wp::int32 var_1747;
    wp::float64 var_1748;
    wp::float64 var_1749;
    wp::float64 var_1750;
    const wp::int32 var_1751 = 1;
    wp::int32 var_1752;
    wp::int32 var_1753;
    wp::float64 var_1754;
    wp::int32 var_1755;
    wp::int32 var_1756;
    wp::float64 var_1757;
    wp::float64 var_1758;
    wp::int32 var_1759;
    wp::int32 var_1760;
    wp::float64 var_1761;
    wp::float64 var_1762;
    wp::float64 var_1763;
    const wp::int32 var_1764 = 2;
    wp::int32 var_1765;
    wp::int32 var_1766;
    wp::float64 var_1767;
    wp::int32 var_1768;
    wp::int32 var_1769;
    wp::float64 var_1770;
    wp::float64 var_1771;
    wp::int32 var_1772;
    wp::int32 var_1773;
    wp::float64 var_1774;
    wp::float64 var_1775;
    wp::float64 var_1776;
    const wp::int32 var_1777 = 3;
    wp::int32 var_1778;
    wp::int32 var_1779;
    wp::float64 var_1780;
    wp::int32 var_1781;
    wp::int32 var_1782;
    wp::float64 var_1783;
    wp::float64 var_1784;
    wp::int32 var_1785;
    wp::int32 var_1786;
    wp::float64 var_1787;
    wp::float64 var_1788;
    wp::float64 var_1789;
    const wp::int32 var_1790 = 4;
    wp::int32 var_1791;
    wp::int32 var_1792;
    wp::float64 var_1793;
    wp::int32 var_1794;
    wp::int32 var_1795;
    wp::float64 var_1796;
    wp::float64 var_1797;
    wp::int32 var_1798;
    wp::int32 var_1799;
    wp::float64 var_1800;
    wp::float64 var_1801;
    wp::float64 var_1802;
    wp::float64 var_1803;
    wp::int32 var_1804;
    wp::int32 var_1805;
    wp::float64 var_1806;
    wp::int32 var_1807;
    const wp::int32 var_1808 = 5;
    bool var_1809;
    wp::int32 var_1810;
    wp::int32 var_1811;
    wp::float64 var_1812;
    const wp::int32 var_1813 = 0;
    wp::int32 var_1814;
    wp::int32 var_1815;
    wp::float64 var_1816;
    wp::int32 var_1817;
    wp::int32 var_1818;
    wp::float64 var_1819;
    wp::float64 var_1820;
    wp::int32 var_1821;
    wp::int32 var_1822;
    wp::float64 var_1823;
    wp::float64 var_1824;
    wp::float64 var_1825;
    const wp::int32 var_1826 = 1;
    wp::int32 var_1827;
    wp::int32 var_1828;
    wp::float64 var_1829;
    wp::int32 var_1830;
    wp::int32 var_1831;
    wp::float64 var_1832;
    wp::float64 var_1833;
    wp::int32 var_1834;
    wp::int32 var_1835;
    wp::float64 var_1836;
    wp::float64 var_1837;
    wp::float64 var_1838;
    const wp::int32 var_1839 = 2;
    wp::int32 var_1840;
    wp::int32 var_1841;
    wp::float64 var_1842;
    wp::int32 var_1843;
    wp::int32 var_1844;
    wp::float64 var_1845;
    wp::float64 var_1846;
    wp::int32 var_1847;
    wp::int32 var_1848;
    wp::float64 var_1849;
    wp::float64 var_1850;
    wp::float64 var_1851;
    const wp::int32 var_1852 = 3;
    wp::int32 var_1853;
    wp::int32 var_1854;
    wp::float64 var_1855;
    wp::int32 var_1856;
    wp::int32 var_1857;
    wp::float64 var_1858;
    wp::float64 var_1859;
    wp::int32 var_1860;
    wp::int32 var_1861;
    wp::float64 var_1862;
    wp::float64 var_1863;
    wp::float64 var_1864;
    const wp::int32 var_1865 = 4;
    wp::int32 var_1866;
    wp::int32 var_1867;
    wp::float64 var_1868;
    wp::int32 var_1869;
    wp::int32 var_1870;
    wp::float64 var_1871;
    wp::float64 var_1872;
    wp::int32 var_1873;
    wp::int32 var_1874;
    wp::float64 var_1875;
    wp::float64 var_1876;
    wp::float64 var_1877;
    wp::float64 var_1878;
    wp::int32 var_1879;
    wp::int32 var_1880;
    wp::float64 var_1881;
    wp::int32 var_1882;
    //---------
    // forward
    // def factor_system(h):                                                                  <L 1>
    // a = full_matrix(h)                                                                     <L 3>
    var_0 = full_matrix_0(var_h);
    // largest = float64(0.0)                                                                 <L 4>
    var_1 = 0.0;
    // for j in range(6):                                                                     <L 5>
    // largest = max(largest, abs(a[j * UNKNOWNS + j]))                                       <L 6>
    var_4 = wp::mul(var_2, var_3);
    var_5 = wp::add(var_4, var_2);
    var_6 = wp::extract(var_0, var_5);
    var_7 = wp::abs(var_6);
    var_8 = wp::max(var_1, var_7);
    var_10 = wp::mul(var_9, var_3);
    var_11 = wp::add(var_10, var_9);
    var_12 = wp::extract(var_0, var_11);
    var_13 = wp::abs(var_12);
    var_14 = wp::max(var_8, var_13);
    var_16 = wp::mul(var_15, var_3);
    var_17 = wp::add(var_16, var_15);
    var_18 = wp::extract(var_0, var_17);
    var_19 = wp::abs(var_18);
    var_20 = wp::max(var_14, var_19);
    var_22 = wp::mul(var_21, var_3);
    var_23 = wp::add(var_22, var_21);
    var_24 = wp::extract(var_0, var_23);
    var_25 = wp::abs(var_24);
    var_26 = wp::max(var_20, var_25);
    var_28 = wp::mul(var_27, var_3);
    var_29 = wp::add(var_28, var_27);
    var_30 = wp::extract(var_0, var_29);
    var_31 = wp::abs(var_30);
    var_32 = wp::max(var_26, var_31);
    var_34 = wp::mul(var_33, var_3);
    var_35 = wp::add(var_34, var_33);
    var_36 = wp::extract(var_0, var_35);
    var_37 = wp::abs(var_36);
    var_38 = wp::max(var_32, var_37);
    // for j in range(6):                                                                     <L 7>
    // d = a[j * UNKNOWNS + j]                                                                <L 8>
    var_40 = wp::mul(var_39, var_3);
    var_41 = wp::add(var_40, var_39);
    var_42 = wp::extract(var_0, var_41);
    // for k in range(j):                                                                     <L 9>
    // inverse = float64(0.0)                                                                 <L 11>
    var_43 = 0.0;
    // if d > float64(1e-15) * largest:                                                       <L 12>
    var_44 = 1e-15;
    var_45 = wp::mul(var_44, var_38);
    var_46 = (var_42 > var_45);
    if (var_46) {
        // inverse = float64(1.0) / d                                                         <L 13>
        var_47 = 1.0;
        var_48 = wp::div(var_47, var_42);
    }
    if (!var_46) {
        // elif d - d == float64(0.0):                                                        <L 14>
        var_49 = wp::sub(var_42, var_42);
        var_50 = 0.0;
        var_51 = (var_49 == var_50);
        if (var_51) {
            // d = float64(0.0)                                                               <L 15>
            var_52 = 0.0;
        }
        if (!var_51) {
            // inverse = d                                                                    <L 17>
            var_53 = wp::copy(var_42);
        }
        var_54 = wp::where(var_51, var_52, var_42);
        var_55 = wp::where(var_51, var_43, var_53);
    }
    var_56 = wp::where(var_46, var_42, var_54);
    var_57 = wp::where(var_46, var_48, var_55);
    // a[j * UNKNOWNS + j] = d                                                                <L 18>
    var_58 = wp::mul(var_39, var_3);
    var_59 = wp::add(var_58, var_39);
    wp::assign_inplace(var_0, var_59, var_56);
    // for i in range(6):                                                                     <L 19>
    // if i > j:                                                                              <L 20>
    var_61 = (var_60 > var_39);
    if (var_61) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_62 = wp::mul(var_60, var_3);
        var_63 = wp::add(var_62, var_39);
        var_64 = wp::extract(var_0, var_63);
        // for k in range(j):                                                                 <L 22>
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_65 = wp::mul(var_64, var_57);
        var_66 = wp::mul(var_60, var_3);
        var_67 = wp::add(var_66, var_39);
        wp::assign_inplace(var_0, var_67, var_65);
    }
    // if i > j:                                                                              <L 20>
    var_69 = (var_68 > var_39);
    if (var_69) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_70 = wp::mul(var_68, var_3);
        var_71 = wp::add(var_70, var_39);
        var_72 = wp::extract(var_0, var_71);
        // for k in range(j):                                                                 <L 22>
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_73 = wp::mul(var_72, var_57);
        var_74 = wp::mul(var_68, var_3);
        var_75 = wp::add(var_74, var_39);
        wp::assign_inplace(var_0, var_75, var_73);
    }
    var_76 = wp::where(var_69, var_72, var_64);
    // if i > j:                                                                              <L 20>
    var_78 = (var_77 > var_39);
    if (var_78) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_79 = wp::mul(var_77, var_3);
        var_80 = wp::add(var_79, var_39);
        var_81 = wp::extract(var_0, var_80);
        // for k in range(j):                                                                 <L 22>
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_82 = wp::mul(var_81, var_57);
        var_83 = wp::mul(var_77, var_3);
        var_84 = wp::add(var_83, var_39);
        wp::assign_inplace(var_0, var_84, var_82);
    }
    var_85 = wp::where(var_78, var_81, var_76);
    // if i > j:                                                                              <L 20>
    var_87 = (var_86 > var_39);
    if (var_87) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_88 = wp::mul(var_86, var_3);
        var_89 = wp::add(var_88, var_39);
        var_90 = wp::extract(var_0, var_89);
        // for k in range(j):                                                                 <L 22>
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_91 = wp::mul(var_90, var_57);
        var_92 = wp::mul(var_86, var_3);
        var_93 = wp::add(var_92, var_39);
        wp::assign_inplace(var_0, var_93, var_91);
    }
    var_94 = wp::where(var_87, var_90, var_85);
    // if i > j:                                                                              <L 20>
    var_96 = (var_95 > var_39);
    if (var_96) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_97 = wp::mul(var_95, var_3);
        var_98 = wp::add(var_97, var_39);
        var_99 = wp::extract(var_0, var_98);
        // for k in range(j):                                                                 <L 22>
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_100 = wp::mul(var_99, var_57);
        var_101 = wp::mul(var_95, var_3);
        var_102 = wp::add(var_101, var_39);
        wp::assign_inplace(var_0, var_102, var_100);
    }
    var_103 = wp::where(var_96, var_99, var_94);
    // if i > j:                                                                              <L 20>
    var_105 = (var_104 > var_39);
    if (var_105) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_106 = wp::mul(var_104, var_3);
        var_107 = wp::add(var_106, var_39);
        var_108 = wp::extract(var_0, var_107);
        // for k in range(j):                                                                 <L 22>
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_109 = wp::mul(var_108, var_57);
        var_110 = wp::mul(var_104, var_3);
        var_111 = wp::add(var_110, var_39);
        wp::assign_inplace(var_0, var_111, var_109);
    }
    var_112 = wp::where(var_105, var_108, var_103);
    // d = a[j * UNKNOWNS + j]                                                                <L 8>
    var_114 = wp::mul(var_113, var_3);
    var_115 = wp::add(var_114, var_113);
    var_116 = wp::extract(var_0, var_115);
    // for k in range(j):                                                                     <L 9>
    // d -= a[j * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]                   <L 10>
    var_118 = wp::mul(var_113, var_3);
    var_119 = wp::add(var_118, var_117);
    var_120 = wp::extract(var_0, var_119);
    var_121 = wp::mul(var_113, var_3);
    var_122 = wp::add(var_121, var_117);
    var_123 = wp::extract(var_0, var_122);
    var_124 = wp::mul(var_120, var_123);
    var_125 = wp::mul(var_117, var_3);
    var_126 = wp::add(var_125, var_117);
    var_127 = wp::extract(var_0, var_126);
    var_128 = wp::mul(var_124, var_127);
    var_129 = wp::sub(var_116, var_128);
    // inverse = float64(0.0)                                                                 <L 11>
    var_130 = 0.0;
    // if d > float64(1e-15) * largest:                                                       <L 12>
    var_131 = 1e-15;
    var_132 = wp::mul(var_131, var_38);
    var_133 = (var_129 > var_132);
    if (var_133) {
        // inverse = float64(1.0) / d                                                         <L 13>
        var_134 = 1.0;
        var_135 = wp::div(var_134, var_129);
    }
    if (!var_133) {
        // elif d - d == float64(0.0):                                                        <L 14>
        var_136 = wp::sub(var_129, var_129);
        var_137 = 0.0;
        var_138 = (var_136 == var_137);
        if (var_138) {
            // d = float64(0.0)                                                               <L 15>
            var_139 = 0.0;
        }
        if (!var_138) {
            // inverse = d                                                                    <L 17>
            var_140 = wp::copy(var_129);
        }
        var_141 = wp::where(var_138, var_139, var_129);
        var_142 = wp::where(var_138, var_130, var_140);
    }
    var_143 = wp::where(var_133, var_129, var_141);
    var_144 = wp::where(var_133, var_135, var_142);
    // a[j * UNKNOWNS + j] = d                                                                <L 18>
    var_145 = wp::mul(var_113, var_3);
    var_146 = wp::add(var_145, var_113);
    wp::assign_inplace(var_0, var_146, var_143);
    // for i in range(6):                                                                     <L 19>
    // if i > j:                                                                              <L 20>
    var_148 = (var_147 > var_113);
    if (var_148) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_149 = wp::mul(var_147, var_3);
        var_150 = wp::add(var_149, var_113);
        var_151 = wp::extract(var_0, var_150);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_153 = wp::mul(var_147, var_3);
        var_154 = wp::add(var_153, var_152);
        var_155 = wp::extract(var_0, var_154);
        var_156 = wp::mul(var_113, var_3);
        var_157 = wp::add(var_156, var_152);
        var_158 = wp::extract(var_0, var_157);
        var_159 = wp::mul(var_155, var_158);
        var_160 = wp::mul(var_152, var_3);
        var_161 = wp::add(var_160, var_152);
        var_162 = wp::extract(var_0, var_161);
        var_163 = wp::mul(var_159, var_162);
        var_164 = wp::sub(var_151, var_163);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_165 = wp::mul(var_164, var_144);
        var_166 = wp::mul(var_147, var_3);
        var_167 = wp::add(var_166, var_113);
        wp::assign_inplace(var_0, var_167, var_165);
    }
    var_168 = wp::where(var_148, var_164, var_112);
    var_169 = wp::where(var_148, var_152, var_117);
    // if i > j:                                                                              <L 20>
    var_171 = (var_170 > var_113);
    if (var_171) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_172 = wp::mul(var_170, var_3);
        var_173 = wp::add(var_172, var_113);
        var_174 = wp::extract(var_0, var_173);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_176 = wp::mul(var_170, var_3);
        var_177 = wp::add(var_176, var_175);
        var_178 = wp::extract(var_0, var_177);
        var_179 = wp::mul(var_113, var_3);
        var_180 = wp::add(var_179, var_175);
        var_181 = wp::extract(var_0, var_180);
        var_182 = wp::mul(var_178, var_181);
        var_183 = wp::mul(var_175, var_3);
        var_184 = wp::add(var_183, var_175);
        var_185 = wp::extract(var_0, var_184);
        var_186 = wp::mul(var_182, var_185);
        var_187 = wp::sub(var_174, var_186);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_188 = wp::mul(var_187, var_144);
        var_189 = wp::mul(var_170, var_3);
        var_190 = wp::add(var_189, var_113);
        wp::assign_inplace(var_0, var_190, var_188);
    }
    var_191 = wp::where(var_171, var_187, var_168);
    var_192 = wp::where(var_171, var_175, var_169);
    // if i > j:                                                                              <L 20>
    var_194 = (var_193 > var_113);
    if (var_194) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_195 = wp::mul(var_193, var_3);
        var_196 = wp::add(var_195, var_113);
        var_197 = wp::extract(var_0, var_196);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_199 = wp::mul(var_193, var_3);
        var_200 = wp::add(var_199, var_198);
        var_201 = wp::extract(var_0, var_200);
        var_202 = wp::mul(var_113, var_3);
        var_203 = wp::add(var_202, var_198);
        var_204 = wp::extract(var_0, var_203);
        var_205 = wp::mul(var_201, var_204);
        var_206 = wp::mul(var_198, var_3);
        var_207 = wp::add(var_206, var_198);
        var_208 = wp::extract(var_0, var_207);
        var_209 = wp::mul(var_205, var_208);
        var_210 = wp::sub(var_197, var_209);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_211 = wp::mul(var_210, var_144);
        var_212 = wp::mul(var_193, var_3);
        var_213 = wp::add(var_212, var_113);
        wp::assign_inplace(var_0, var_213, var_211);
    }
    var_214 = wp::where(var_194, var_210, var_191);
    var_215 = wp::where(var_194, var_198, var_192);
    // if i > j:                                                                              <L 20>
    var_217 = (var_216 > var_113);
    if (var_217) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_218 = wp::mul(var_216, var_3);
        var_219 = wp::add(var_218, var_113);
        var_220 = wp::extract(var_0, var_219);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_222 = wp::mul(var_216, var_3);
        var_223 = wp::add(var_222, var_221);
        var_224 = wp::extract(var_0, var_223);
        var_225 = wp::mul(var_113, var_3);
        var_226 = wp::add(var_225, var_221);
        var_227 = wp::extract(var_0, var_226);
        var_228 = wp::mul(var_224, var_227);
        var_229 = wp::mul(var_221, var_3);
        var_230 = wp::add(var_229, var_221);
        var_231 = wp::extract(var_0, var_230);
        var_232 = wp::mul(var_228, var_231);
        var_233 = wp::sub(var_220, var_232);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_234 = wp::mul(var_233, var_144);
        var_235 = wp::mul(var_216, var_3);
        var_236 = wp::add(var_235, var_113);
        wp::assign_inplace(var_0, var_236, var_234);
    }
    var_237 = wp::where(var_217, var_233, var_214);
    var_238 = wp::where(var_217, var_221, var_215);
    // if i > j:                                                                              <L 20>
    var_240 = (var_239 > var_113);
    if (var_240) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_241 = wp::mul(var_239, var_3);
        var_242 = wp::add(var_241, var_113);
        var_243 = wp::extract(var_0, var_242);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_245 = wp::mul(var_239, var_3);
        var_246 = wp::add(var_245, var_244);
        var_247 = wp::extract(var_0, var_246);
        var_248 = wp::mul(var_113, var_3);
        var_249 = wp::add(var_248, var_244);
        var_250 = wp::extract(var_0, var_249);
        var_251 = wp::mul(var_247, var_250);
        var_252 = wp::mul(var_244, var_3);
        var_253 = wp::add(var_252, var_244);
        var_254 = wp::extract(var_0, var_253);
        var_255 = wp::mul(var_251, var_254);
        var_256 = wp::sub(var_243, var_255);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_257 = wp::mul(var_256, var_144);
        var_258 = wp::mul(var_239, var_3);
        var_259 = wp::add(var_258, var_113);
        wp::assign_inplace(var_0, var_259, var_257);
    }
    var_260 = wp::where(var_240, var_256, var_237);
    var_261 = wp::where(var_240, var_244, var_238);
    // if i > j:                                                                              <L 20>
    var_263 = (var_262 > var_113);
    if (var_263) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_264 = wp::mul(var_262, var_3);
        var_265 = wp::add(var_264, var_113);
        var_266 = wp::extract(var_0, var_265);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_268 = wp::mul(var_262, var_3);
        var_269 = wp::add(var_268, var_267);
        var_270 = wp::extract(var_0, var_269);
        var_271 = wp::mul(var_113, var_3);
        var_272 = wp::add(var_271, var_267);
        var_273 = wp::extract(var_0, var_272);
        var_274 = wp::mul(var_270, var_273);
        var_275 = wp::mul(var_267, var_3);
        var_276 = wp::add(var_275, var_267);
        var_277 = wp::extract(var_0, var_276);
        var_278 = wp::mul(var_274, var_277);
        var_279 = wp::sub(var_266, var_278);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_280 = wp::mul(var_279, var_144);
        var_281 = wp::mul(var_262, var_3);
        var_282 = wp::add(var_281, var_113);
        wp::assign_inplace(var_0, var_282, var_280);
    }
    var_283 = wp::where(var_263, var_279, var_260);
    var_284 = wp::where(var_263, var_267, var_261);
    // d = a[j * UNKNOWNS + j]                                                                <L 8>
    var_286 = wp::mul(var_285, var_3);
    var_287 = wp::add(var_286, var_285);
    var_288 = wp::extract(var_0, var_287);
    // for k in range(j):                                                                     <L 9>
    // d -= a[j * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]                   <L 10>
    var_290 = wp::mul(var_285, var_3);
    var_291 = wp::add(var_290, var_289);
    var_292 = wp::extract(var_0, var_291);
    var_293 = wp::mul(var_285, var_3);
    var_294 = wp::add(var_293, var_289);
    var_295 = wp::extract(var_0, var_294);
    var_296 = wp::mul(var_292, var_295);
    var_297 = wp::mul(var_289, var_3);
    var_298 = wp::add(var_297, var_289);
    var_299 = wp::extract(var_0, var_298);
    var_300 = wp::mul(var_296, var_299);
    var_301 = wp::sub(var_288, var_300);
    var_303 = wp::mul(var_285, var_3);
    var_304 = wp::add(var_303, var_302);
    var_305 = wp::extract(var_0, var_304);
    var_306 = wp::mul(var_285, var_3);
    var_307 = wp::add(var_306, var_302);
    var_308 = wp::extract(var_0, var_307);
    var_309 = wp::mul(var_305, var_308);
    var_310 = wp::mul(var_302, var_3);
    var_311 = wp::add(var_310, var_302);
    var_312 = wp::extract(var_0, var_311);
    var_313 = wp::mul(var_309, var_312);
    var_314 = wp::sub(var_301, var_313);
    // inverse = float64(0.0)                                                                 <L 11>
    var_315 = 0.0;
    // if d > float64(1e-15) * largest:                                                       <L 12>
    var_316 = 1e-15;
    var_317 = wp::mul(var_316, var_38);
    var_318 = (var_314 > var_317);
    if (var_318) {
        // inverse = float64(1.0) / d                                                         <L 13>
        var_319 = 1.0;
        var_320 = wp::div(var_319, var_314);
    }
    if (!var_318) {
        // elif d - d == float64(0.0):                                                        <L 14>
        var_321 = wp::sub(var_314, var_314);
        var_322 = 0.0;
        var_323 = (var_321 == var_322);
        if (var_323) {
            // d = float64(0.0)                                                               <L 15>
            var_324 = 0.0;
        }
        if (!var_323) {
            // inverse = d                                                                    <L 17>
            var_325 = wp::copy(var_314);
        }
        var_326 = wp::where(var_323, var_324, var_314);
        var_327 = wp::where(var_323, var_315, var_325);
    }
    var_328 = wp::where(var_318, var_314, var_326);
    var_329 = wp::where(var_318, var_320, var_327);
    // a[j * UNKNOWNS + j] = d                                                                <L 18>
    var_330 = wp::mul(var_285, var_3);
    var_331 = wp::add(var_330, var_285);
    wp::assign_inplace(var_0, var_331, var_328);
    // for i in range(6):                                                                     <L 19>
    // if i > j:                                                                              <L 20>
    var_333 = (var_332 > var_285);
    if (var_333) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_334 = wp::mul(var_332, var_3);
        var_335 = wp::add(var_334, var_285);
        var_336 = wp::extract(var_0, var_335);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_338 = wp::mul(var_332, var_3);
        var_339 = wp::add(var_338, var_337);
        var_340 = wp::extract(var_0, var_339);
        var_341 = wp::mul(var_285, var_3);
        var_342 = wp::add(var_341, var_337);
        var_343 = wp::extract(var_0, var_342);
        var_344 = wp::mul(var_340, var_343);
        var_345 = wp::mul(var_337, var_3);
        var_346 = wp::add(var_345, var_337);
        var_347 = wp::extract(var_0, var_346);
        var_348 = wp::mul(var_344, var_347);
        var_349 = wp::sub(var_336, var_348);
        var_351 = wp::mul(var_332, var_3);
        var_352 = wp::add(var_351, var_350);
        var_353 = wp::extract(var_0, var_352);
        var_354 = wp::mul(var_285, var_3);
        var_355 = wp::add(var_354, var_350);
        var_356 = wp::extract(var_0, var_355);
        var_357 = wp::mul(var_353, var_356);
        var_358 = wp::mul(var_350, var_3);
        var_359 = wp::add(var_358, var_350);
        var_360 = wp::extract(var_0, var_359);
        var_361 = wp::mul(var_357, var_360);
        var_362 = wp::sub(var_349, var_361);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_363 = wp::mul(var_362, var_329);
        var_364 = wp::mul(var_332, var_3);
        var_365 = wp::add(var_364, var_285);
        wp::assign_inplace(var_0, var_365, var_363);
    }
    var_366 = wp::where(var_333, var_362, var_283);
    var_367 = wp::where(var_333, var_350, var_302);
    // if i > j:                                                                              <L 20>
    var_369 = (var_368 > var_285);
    if (var_369) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_370 = wp::mul(var_368, var_3);
        var_371 = wp::add(var_370, var_285);
        var_372 = wp::extract(var_0, var_371);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_374 = wp::mul(var_368, var_3);
        var_375 = wp::add(var_374, var_373);
        var_376 = wp::extract(var_0, var_375);
        var_377 = wp::mul(var_285, var_3);
        var_378 = wp::add(var_377, var_373);
        var_379 = wp::extract(var_0, var_378);
        var_380 = wp::mul(var_376, var_379);
        var_381 = wp::mul(var_373, var_3);
        var_382 = wp::add(var_381, var_373);
        var_383 = wp::extract(var_0, var_382);
        var_384 = wp::mul(var_380, var_383);
        var_385 = wp::sub(var_372, var_384);
        var_387 = wp::mul(var_368, var_3);
        var_388 = wp::add(var_387, var_386);
        var_389 = wp::extract(var_0, var_388);
        var_390 = wp::mul(var_285, var_3);
        var_391 = wp::add(var_390, var_386);
        var_392 = wp::extract(var_0, var_391);
        var_393 = wp::mul(var_389, var_392);
        var_394 = wp::mul(var_386, var_3);
        var_395 = wp::add(var_394, var_386);
        var_396 = wp::extract(var_0, var_395);
        var_397 = wp::mul(var_393, var_396);
        var_398 = wp::sub(var_385, var_397);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_399 = wp::mul(var_398, var_329);
        var_400 = wp::mul(var_368, var_3);
        var_401 = wp::add(var_400, var_285);
        wp::assign_inplace(var_0, var_401, var_399);
    }
    var_402 = wp::where(var_369, var_398, var_366);
    var_403 = wp::where(var_369, var_386, var_367);
    // if i > j:                                                                              <L 20>
    var_405 = (var_404 > var_285);
    if (var_405) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_406 = wp::mul(var_404, var_3);
        var_407 = wp::add(var_406, var_285);
        var_408 = wp::extract(var_0, var_407);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_410 = wp::mul(var_404, var_3);
        var_411 = wp::add(var_410, var_409);
        var_412 = wp::extract(var_0, var_411);
        var_413 = wp::mul(var_285, var_3);
        var_414 = wp::add(var_413, var_409);
        var_415 = wp::extract(var_0, var_414);
        var_416 = wp::mul(var_412, var_415);
        var_417 = wp::mul(var_409, var_3);
        var_418 = wp::add(var_417, var_409);
        var_419 = wp::extract(var_0, var_418);
        var_420 = wp::mul(var_416, var_419);
        var_421 = wp::sub(var_408, var_420);
        var_423 = wp::mul(var_404, var_3);
        var_424 = wp::add(var_423, var_422);
        var_425 = wp::extract(var_0, var_424);
        var_426 = wp::mul(var_285, var_3);
        var_427 = wp::add(var_426, var_422);
        var_428 = wp::extract(var_0, var_427);
        var_429 = wp::mul(var_425, var_428);
        var_430 = wp::mul(var_422, var_3);
        var_431 = wp::add(var_430, var_422);
        var_432 = wp::extract(var_0, var_431);
        var_433 = wp::mul(var_429, var_432);
        var_434 = wp::sub(var_421, var_433);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_435 = wp::mul(var_434, var_329);
        var_436 = wp::mul(var_404, var_3);
        var_437 = wp::add(var_436, var_285);
        wp::assign_inplace(var_0, var_437, var_435);
    }
    var_438 = wp::where(var_405, var_434, var_402);
    var_439 = wp::where(var_405, var_422, var_403);
    // if i > j:                                                                              <L 20>
    var_441 = (var_440 > var_285);
    if (var_441) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_442 = wp::mul(var_440, var_3);
        var_443 = wp::add(var_442, var_285);
        var_444 = wp::extract(var_0, var_443);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_446 = wp::mul(var_440, var_3);
        var_447 = wp::add(var_446, var_445);
        var_448 = wp::extract(var_0, var_447);
        var_449 = wp::mul(var_285, var_3);
        var_450 = wp::add(var_449, var_445);
        var_451 = wp::extract(var_0, var_450);
        var_452 = wp::mul(var_448, var_451);
        var_453 = wp::mul(var_445, var_3);
        var_454 = wp::add(var_453, var_445);
        var_455 = wp::extract(var_0, var_454);
        var_456 = wp::mul(var_452, var_455);
        var_457 = wp::sub(var_444, var_456);
        var_459 = wp::mul(var_440, var_3);
        var_460 = wp::add(var_459, var_458);
        var_461 = wp::extract(var_0, var_460);
        var_462 = wp::mul(var_285, var_3);
        var_463 = wp::add(var_462, var_458);
        var_464 = wp::extract(var_0, var_463);
        var_465 = wp::mul(var_461, var_464);
        var_466 = wp::mul(var_458, var_3);
        var_467 = wp::add(var_466, var_458);
        var_468 = wp::extract(var_0, var_467);
        var_469 = wp::mul(var_465, var_468);
        var_470 = wp::sub(var_457, var_469);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_471 = wp::mul(var_470, var_329);
        var_472 = wp::mul(var_440, var_3);
        var_473 = wp::add(var_472, var_285);
        wp::assign_inplace(var_0, var_473, var_471);
    }
    var_474 = wp::where(var_441, var_470, var_438);
    var_475 = wp::where(var_441, var_458, var_439);
    // if i > j:                                                                              <L 20>
    var_477 = (var_476 > var_285);
    if (var_477) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_478 = wp::mul(var_476, var_3);
        var_479 = wp::add(var_478, var_285);
        var_480 = wp::extract(var_0, var_479);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_482 = wp::mul(var_476, var_3);
        var_483 = wp::add(var_482, var_481);
        var_484 = wp::extract(var_0, var_483);
        var_485 = wp::mul(var_285, var_3);
        var_486 = wp::add(var_485, var_481);
        var_487 = wp::extract(var_0, var_486);
        var_488 = wp::mul(var_484, var_487);
        var_489 = wp::mul(var_481, var_3);
        var_490 = wp::add(var_489, var_481);
        var_491 = wp::extract(var_0, var_490);
        var_492 = wp::mul(var_488, var_491);
        var_493 = wp::sub(var_480, var_492);
        var_495 = wp::mul(var_476, var_3);
        var_496 = wp::add(var_495, var_494);
        var_497 = wp::extract(var_0, var_496);
        var_498 = wp::mul(var_285, var_3);
        var_499 = wp::add(var_498, var_494);
        var_500 = wp::extract(var_0, var_499);
        var_501 = wp::mul(var_497, var_500);
        var_502 = wp::mul(var_494, var_3);
        var_503 = wp::add(var_502, var_494);
        var_504 = wp::extract(var_0, var_503);
        var_505 = wp::mul(var_501, var_504);
        var_506 = wp::sub(var_493, var_505);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_507 = wp::mul(var_506, var_329);
        var_508 = wp::mul(var_476, var_3);
        var_509 = wp::add(var_508, var_285);
        wp::assign_inplace(var_0, var_509, var_507);
    }
    var_510 = wp::where(var_477, var_506, var_474);
    var_511 = wp::where(var_477, var_494, var_475);
    // if i > j:                                                                              <L 20>
    var_513 = (var_512 > var_285);
    if (var_513) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_514 = wp::mul(var_512, var_3);
        var_515 = wp::add(var_514, var_285);
        var_516 = wp::extract(var_0, var_515);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_518 = wp::mul(var_512, var_3);
        var_519 = wp::add(var_518, var_517);
        var_520 = wp::extract(var_0, var_519);
        var_521 = wp::mul(var_285, var_3);
        var_522 = wp::add(var_521, var_517);
        var_523 = wp::extract(var_0, var_522);
        var_524 = wp::mul(var_520, var_523);
        var_525 = wp::mul(var_517, var_3);
        var_526 = wp::add(var_525, var_517);
        var_527 = wp::extract(var_0, var_526);
        var_528 = wp::mul(var_524, var_527);
        var_529 = wp::sub(var_516, var_528);
        var_531 = wp::mul(var_512, var_3);
        var_532 = wp::add(var_531, var_530);
        var_533 = wp::extract(var_0, var_532);
        var_534 = wp::mul(var_285, var_3);
        var_535 = wp::add(var_534, var_530);
        var_536 = wp::extract(var_0, var_535);
        var_537 = wp::mul(var_533, var_536);
        var_538 = wp::mul(var_530, var_3);
        var_539 = wp::add(var_538, var_530);
        var_540 = wp::extract(var_0, var_539);
        var_541 = wp::mul(var_537, var_540);
        var_542 = wp::sub(var_529, var_541);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_543 = wp::mul(var_542, var_329);
        var_544 = wp::mul(var_512, var_3);
        var_545 = wp::add(var_544, var_285);
        wp::assign_inplace(var_0, var_545, var_543);
    }
    var_546 = wp::where(var_513, var_542, var_510);
    var_547 = wp::where(var_513, var_530, var_511);
    // d = a[j * UNKNOWNS + j]                                                                <L 8>
    var_549 = wp::mul(var_548, var_3);
    var_550 = wp::add(var_549, var_548);
    var_551 = wp::extract(var_0, var_550);
    // for k in range(j):                                                                     <L 9>
    // d -= a[j * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]                   <L 10>
    var_553 = wp::mul(var_548, var_3);
    var_554 = wp::add(var_553, var_552);
    var_555 = wp::extract(var_0, var_554);
    var_556 = wp::mul(var_548, var_3);
    var_557 = wp::add(var_556, var_552);
    var_558 = wp::extract(var_0, var_557);
    var_559 = wp::mul(var_555, var_558);
    var_560 = wp::mul(var_552, var_3);
    var_561 = wp::add(var_560, var_552);
    var_562 = wp::extract(var_0, var_561);
    var_563 = wp::mul(var_559, var_562);
    var_564 = wp::sub(var_551, var_563);
    var_566 = wp::mul(var_548, var_3);
    var_567 = wp::add(var_566, var_565);
    var_568 = wp::extract(var_0, var_567);
    var_569 = wp::mul(var_548, var_3);
    var_570 = wp::add(var_569, var_565);
    var_571 = wp::extract(var_0, var_570);
    var_572 = wp::mul(var_568, var_571);
    var_573 = wp::mul(var_565, var_3);
    var_574 = wp::add(var_573, var_565);
    var_575 = wp::extract(var_0, var_574);
    var_576 = wp::mul(var_572, var_575);
    var_577 = wp::sub(var_564, var_576);
    var_579 = wp::mul(var_548, var_3);
    var_580 = wp::add(var_579, var_578);
    var_581 = wp::extract(var_0, var_580);
    var_582 = wp::mul(var_548, var_3);
    var_583 = wp::add(var_582, var_578);
    var_584 = wp::extract(var_0, var_583);
    var_585 = wp::mul(var_581, var_584);
    var_586 = wp::mul(var_578, var_3);
    var_587 = wp::add(var_586, var_578);
    var_588 = wp::extract(var_0, var_587);
    var_589 = wp::mul(var_585, var_588);
    var_590 = wp::sub(var_577, var_589);
    // inverse = float64(0.0)                                                                 <L 11>
    var_591 = 0.0;
    // if d > float64(1e-15) * largest:                                                       <L 12>
    var_592 = 1e-15;
    var_593 = wp::mul(var_592, var_38);
    var_594 = (var_590 > var_593);
    if (var_594) {
        // inverse = float64(1.0) / d                                                         <L 13>
        var_595 = 1.0;
        var_596 = wp::div(var_595, var_590);
    }
    if (!var_594) {
        // elif d - d == float64(0.0):                                                        <L 14>
        var_597 = wp::sub(var_590, var_590);
        var_598 = 0.0;
        var_599 = (var_597 == var_598);
        if (var_599) {
            // d = float64(0.0)                                                               <L 15>
            var_600 = 0.0;
        }
        if (!var_599) {
            // inverse = d                                                                    <L 17>
            var_601 = wp::copy(var_590);
        }
        var_602 = wp::where(var_599, var_600, var_590);
        var_603 = wp::where(var_599, var_591, var_601);
    }
    var_604 = wp::where(var_594, var_590, var_602);
    var_605 = wp::where(var_594, var_596, var_603);
    // a[j * UNKNOWNS + j] = d                                                                <L 18>
    var_606 = wp::mul(var_548, var_3);
    var_607 = wp::add(var_606, var_548);
    wp::assign_inplace(var_0, var_607, var_604);
    // for i in range(6):                                                                     <L 19>
    // if i > j:                                                                              <L 20>
    var_609 = (var_608 > var_548);
    if (var_609) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_610 = wp::mul(var_608, var_3);
        var_611 = wp::add(var_610, var_548);
        var_612 = wp::extract(var_0, var_611);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_614 = wp::mul(var_608, var_3);
        var_615 = wp::add(var_614, var_613);
        var_616 = wp::extract(var_0, var_615);
        var_617 = wp::mul(var_548, var_3);
        var_618 = wp::add(var_617, var_613);
        var_619 = wp::extract(var_0, var_618);
        var_620 = wp::mul(var_616, var_619);
        var_621 = wp::mul(var_613, var_3);
        var_622 = wp::add(var_621, var_613);
        var_623 = wp::extract(var_0, var_622);
        var_624 = wp::mul(var_620, var_623);
        var_625 = wp::sub(var_612, var_624);
        var_627 = wp::mul(var_608, var_3);
        var_628 = wp::add(var_627, var_626);
        var_629 = wp::extract(var_0, var_628);
        var_630 = wp::mul(var_548, var_3);
        var_631 = wp::add(var_630, var_626);
        var_632 = wp::extract(var_0, var_631);
        var_633 = wp::mul(var_629, var_632);
        var_634 = wp::mul(var_626, var_3);
        var_635 = wp::add(var_634, var_626);
        var_636 = wp::extract(var_0, var_635);
        var_637 = wp::mul(var_633, var_636);
        var_638 = wp::sub(var_625, var_637);
        var_640 = wp::mul(var_608, var_3);
        var_641 = wp::add(var_640, var_639);
        var_642 = wp::extract(var_0, var_641);
        var_643 = wp::mul(var_548, var_3);
        var_644 = wp::add(var_643, var_639);
        var_645 = wp::extract(var_0, var_644);
        var_646 = wp::mul(var_642, var_645);
        var_647 = wp::mul(var_639, var_3);
        var_648 = wp::add(var_647, var_639);
        var_649 = wp::extract(var_0, var_648);
        var_650 = wp::mul(var_646, var_649);
        var_651 = wp::sub(var_638, var_650);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_652 = wp::mul(var_651, var_605);
        var_653 = wp::mul(var_608, var_3);
        var_654 = wp::add(var_653, var_548);
        wp::assign_inplace(var_0, var_654, var_652);
    }
    var_655 = wp::where(var_609, var_651, var_546);
    var_656 = wp::where(var_609, var_639, var_578);
    // if i > j:                                                                              <L 20>
    var_658 = (var_657 > var_548);
    if (var_658) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_659 = wp::mul(var_657, var_3);
        var_660 = wp::add(var_659, var_548);
        var_661 = wp::extract(var_0, var_660);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_663 = wp::mul(var_657, var_3);
        var_664 = wp::add(var_663, var_662);
        var_665 = wp::extract(var_0, var_664);
        var_666 = wp::mul(var_548, var_3);
        var_667 = wp::add(var_666, var_662);
        var_668 = wp::extract(var_0, var_667);
        var_669 = wp::mul(var_665, var_668);
        var_670 = wp::mul(var_662, var_3);
        var_671 = wp::add(var_670, var_662);
        var_672 = wp::extract(var_0, var_671);
        var_673 = wp::mul(var_669, var_672);
        var_674 = wp::sub(var_661, var_673);
        var_676 = wp::mul(var_657, var_3);
        var_677 = wp::add(var_676, var_675);
        var_678 = wp::extract(var_0, var_677);
        var_679 = wp::mul(var_548, var_3);
        var_680 = wp::add(var_679, var_675);
        var_681 = wp::extract(var_0, var_680);
        var_682 = wp::mul(var_678, var_681);
        var_683 = wp::mul(var_675, var_3);
        var_684 = wp::add(var_683, var_675);
        var_685 = wp::extract(var_0, var_684);
        var_686 = wp::mul(var_682, var_685);
        var_687 = wp::sub(var_674, var_686);
        var_689 = wp::mul(var_657, var_3);
        var_690 = wp::add(var_689, var_688);
        var_691 = wp::extract(var_0, var_690);
        var_692 = wp::mul(var_548, var_3);
        var_693 = wp::add(var_692, var_688);
        var_694 = wp::extract(var_0, var_693);
        var_695 = wp::mul(var_691, var_694);
        var_696 = wp::mul(var_688, var_3);
        var_697 = wp::add(var_696, var_688);
        var_698 = wp::extract(var_0, var_697);
        var_699 = wp::mul(var_695, var_698);
        var_700 = wp::sub(var_687, var_699);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_701 = wp::mul(var_700, var_605);
        var_702 = wp::mul(var_657, var_3);
        var_703 = wp::add(var_702, var_548);
        wp::assign_inplace(var_0, var_703, var_701);
    }
    var_704 = wp::where(var_658, var_700, var_655);
    var_705 = wp::where(var_658, var_688, var_656);
    // if i > j:                                                                              <L 20>
    var_707 = (var_706 > var_548);
    if (var_707) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_708 = wp::mul(var_706, var_3);
        var_709 = wp::add(var_708, var_548);
        var_710 = wp::extract(var_0, var_709);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_712 = wp::mul(var_706, var_3);
        var_713 = wp::add(var_712, var_711);
        var_714 = wp::extract(var_0, var_713);
        var_715 = wp::mul(var_548, var_3);
        var_716 = wp::add(var_715, var_711);
        var_717 = wp::extract(var_0, var_716);
        var_718 = wp::mul(var_714, var_717);
        var_719 = wp::mul(var_711, var_3);
        var_720 = wp::add(var_719, var_711);
        var_721 = wp::extract(var_0, var_720);
        var_722 = wp::mul(var_718, var_721);
        var_723 = wp::sub(var_710, var_722);
        var_725 = wp::mul(var_706, var_3);
        var_726 = wp::add(var_725, var_724);
        var_727 = wp::extract(var_0, var_726);
        var_728 = wp::mul(var_548, var_3);
        var_729 = wp::add(var_728, var_724);
        var_730 = wp::extract(var_0, var_729);
        var_731 = wp::mul(var_727, var_730);
        var_732 = wp::mul(var_724, var_3);
        var_733 = wp::add(var_732, var_724);
        var_734 = wp::extract(var_0, var_733);
        var_735 = wp::mul(var_731, var_734);
        var_736 = wp::sub(var_723, var_735);
        var_738 = wp::mul(var_706, var_3);
        var_739 = wp::add(var_738, var_737);
        var_740 = wp::extract(var_0, var_739);
        var_741 = wp::mul(var_548, var_3);
        var_742 = wp::add(var_741, var_737);
        var_743 = wp::extract(var_0, var_742);
        var_744 = wp::mul(var_740, var_743);
        var_745 = wp::mul(var_737, var_3);
        var_746 = wp::add(var_745, var_737);
        var_747 = wp::extract(var_0, var_746);
        var_748 = wp::mul(var_744, var_747);
        var_749 = wp::sub(var_736, var_748);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_750 = wp::mul(var_749, var_605);
        var_751 = wp::mul(var_706, var_3);
        var_752 = wp::add(var_751, var_548);
        wp::assign_inplace(var_0, var_752, var_750);
    }
    var_753 = wp::where(var_707, var_749, var_704);
    var_754 = wp::where(var_707, var_737, var_705);
    // if i > j:                                                                              <L 20>
    var_756 = (var_755 > var_548);
    if (var_756) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_757 = wp::mul(var_755, var_3);
        var_758 = wp::add(var_757, var_548);
        var_759 = wp::extract(var_0, var_758);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_761 = wp::mul(var_755, var_3);
        var_762 = wp::add(var_761, var_760);
        var_763 = wp::extract(var_0, var_762);
        var_764 = wp::mul(var_548, var_3);
        var_765 = wp::add(var_764, var_760);
        var_766 = wp::extract(var_0, var_765);
        var_767 = wp::mul(var_763, var_766);
        var_768 = wp::mul(var_760, var_3);
        var_769 = wp::add(var_768, var_760);
        var_770 = wp::extract(var_0, var_769);
        var_771 = wp::mul(var_767, var_770);
        var_772 = wp::sub(var_759, var_771);
        var_774 = wp::mul(var_755, var_3);
        var_775 = wp::add(var_774, var_773);
        var_776 = wp::extract(var_0, var_775);
        var_777 = wp::mul(var_548, var_3);
        var_778 = wp::add(var_777, var_773);
        var_779 = wp::extract(var_0, var_778);
        var_780 = wp::mul(var_776, var_779);
        var_781 = wp::mul(var_773, var_3);
        var_782 = wp::add(var_781, var_773);
        var_783 = wp::extract(var_0, var_782);
        var_784 = wp::mul(var_780, var_783);
        var_785 = wp::sub(var_772, var_784);
        var_787 = wp::mul(var_755, var_3);
        var_788 = wp::add(var_787, var_786);
        var_789 = wp::extract(var_0, var_788);
        var_790 = wp::mul(var_548, var_3);
        var_791 = wp::add(var_790, var_786);
        var_792 = wp::extract(var_0, var_791);
        var_793 = wp::mul(var_789, var_792);
        var_794 = wp::mul(var_786, var_3);
        var_795 = wp::add(var_794, var_786);
        var_796 = wp::extract(var_0, var_795);
        var_797 = wp::mul(var_793, var_796);
        var_798 = wp::sub(var_785, var_797);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_799 = wp::mul(var_798, var_605);
        var_800 = wp::mul(var_755, var_3);
        var_801 = wp::add(var_800, var_548);
        wp::assign_inplace(var_0, var_801, var_799);
    }
    var_802 = wp::where(var_756, var_798, var_753);
    var_803 = wp::where(var_756, var_786, var_754);
    // if i > j:                                                                              <L 20>
    var_805 = (var_804 > var_548);
    if (var_805) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_806 = wp::mul(var_804, var_3);
        var_807 = wp::add(var_806, var_548);
        var_808 = wp::extract(var_0, var_807);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_810 = wp::mul(var_804, var_3);
        var_811 = wp::add(var_810, var_809);
        var_812 = wp::extract(var_0, var_811);
        var_813 = wp::mul(var_548, var_3);
        var_814 = wp::add(var_813, var_809);
        var_815 = wp::extract(var_0, var_814);
        var_816 = wp::mul(var_812, var_815);
        var_817 = wp::mul(var_809, var_3);
        var_818 = wp::add(var_817, var_809);
        var_819 = wp::extract(var_0, var_818);
        var_820 = wp::mul(var_816, var_819);
        var_821 = wp::sub(var_808, var_820);
        var_823 = wp::mul(var_804, var_3);
        var_824 = wp::add(var_823, var_822);
        var_825 = wp::extract(var_0, var_824);
        var_826 = wp::mul(var_548, var_3);
        var_827 = wp::add(var_826, var_822);
        var_828 = wp::extract(var_0, var_827);
        var_829 = wp::mul(var_825, var_828);
        var_830 = wp::mul(var_822, var_3);
        var_831 = wp::add(var_830, var_822);
        var_832 = wp::extract(var_0, var_831);
        var_833 = wp::mul(var_829, var_832);
        var_834 = wp::sub(var_821, var_833);
        var_836 = wp::mul(var_804, var_3);
        var_837 = wp::add(var_836, var_835);
        var_838 = wp::extract(var_0, var_837);
        var_839 = wp::mul(var_548, var_3);
        var_840 = wp::add(var_839, var_835);
        var_841 = wp::extract(var_0, var_840);
        var_842 = wp::mul(var_838, var_841);
        var_843 = wp::mul(var_835, var_3);
        var_844 = wp::add(var_843, var_835);
        var_845 = wp::extract(var_0, var_844);
        var_846 = wp::mul(var_842, var_845);
        var_847 = wp::sub(var_834, var_846);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_848 = wp::mul(var_847, var_605);
        var_849 = wp::mul(var_804, var_3);
        var_850 = wp::add(var_849, var_548);
        wp::assign_inplace(var_0, var_850, var_848);
    }
    var_851 = wp::where(var_805, var_847, var_802);
    var_852 = wp::where(var_805, var_835, var_803);
    // if i > j:                                                                              <L 20>
    var_854 = (var_853 > var_548);
    if (var_854) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_855 = wp::mul(var_853, var_3);
        var_856 = wp::add(var_855, var_548);
        var_857 = wp::extract(var_0, var_856);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_859 = wp::mul(var_853, var_3);
        var_860 = wp::add(var_859, var_858);
        var_861 = wp::extract(var_0, var_860);
        var_862 = wp::mul(var_548, var_3);
        var_863 = wp::add(var_862, var_858);
        var_864 = wp::extract(var_0, var_863);
        var_865 = wp::mul(var_861, var_864);
        var_866 = wp::mul(var_858, var_3);
        var_867 = wp::add(var_866, var_858);
        var_868 = wp::extract(var_0, var_867);
        var_869 = wp::mul(var_865, var_868);
        var_870 = wp::sub(var_857, var_869);
        var_872 = wp::mul(var_853, var_3);
        var_873 = wp::add(var_872, var_871);
        var_874 = wp::extract(var_0, var_873);
        var_875 = wp::mul(var_548, var_3);
        var_876 = wp::add(var_875, var_871);
        var_877 = wp::extract(var_0, var_876);
        var_878 = wp::mul(var_874, var_877);
        var_879 = wp::mul(var_871, var_3);
        var_880 = wp::add(var_879, var_871);
        var_881 = wp::extract(var_0, var_880);
        var_882 = wp::mul(var_878, var_881);
        var_883 = wp::sub(var_870, var_882);
        var_885 = wp::mul(var_853, var_3);
        var_886 = wp::add(var_885, var_884);
        var_887 = wp::extract(var_0, var_886);
        var_888 = wp::mul(var_548, var_3);
        var_889 = wp::add(var_888, var_884);
        var_890 = wp::extract(var_0, var_889);
        var_891 = wp::mul(var_887, var_890);
        var_892 = wp::mul(var_884, var_3);
        var_893 = wp::add(var_892, var_884);
        var_894 = wp::extract(var_0, var_893);
        var_895 = wp::mul(var_891, var_894);
        var_896 = wp::sub(var_883, var_895);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_897 = wp::mul(var_896, var_605);
        var_898 = wp::mul(var_853, var_3);
        var_899 = wp::add(var_898, var_548);
        wp::assign_inplace(var_0, var_899, var_897);
    }
    var_900 = wp::where(var_854, var_896, var_851);
    var_901 = wp::where(var_854, var_884, var_852);
    // d = a[j * UNKNOWNS + j]                                                                <L 8>
    var_903 = wp::mul(var_902, var_3);
    var_904 = wp::add(var_903, var_902);
    var_905 = wp::extract(var_0, var_904);
    // for k in range(j):                                                                     <L 9>
    // d -= a[j * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]                   <L 10>
    var_907 = wp::mul(var_902, var_3);
    var_908 = wp::add(var_907, var_906);
    var_909 = wp::extract(var_0, var_908);
    var_910 = wp::mul(var_902, var_3);
    var_911 = wp::add(var_910, var_906);
    var_912 = wp::extract(var_0, var_911);
    var_913 = wp::mul(var_909, var_912);
    var_914 = wp::mul(var_906, var_3);
    var_915 = wp::add(var_914, var_906);
    var_916 = wp::extract(var_0, var_915);
    var_917 = wp::mul(var_913, var_916);
    var_918 = wp::sub(var_905, var_917);
    var_920 = wp::mul(var_902, var_3);
    var_921 = wp::add(var_920, var_919);
    var_922 = wp::extract(var_0, var_921);
    var_923 = wp::mul(var_902, var_3);
    var_924 = wp::add(var_923, var_919);
    var_925 = wp::extract(var_0, var_924);
    var_926 = wp::mul(var_922, var_925);
    var_927 = wp::mul(var_919, var_3);
    var_928 = wp::add(var_927, var_919);
    var_929 = wp::extract(var_0, var_928);
    var_930 = wp::mul(var_926, var_929);
    var_931 = wp::sub(var_918, var_930);
    var_933 = wp::mul(var_902, var_3);
    var_934 = wp::add(var_933, var_932);
    var_935 = wp::extract(var_0, var_934);
    var_936 = wp::mul(var_902, var_3);
    var_937 = wp::add(var_936, var_932);
    var_938 = wp::extract(var_0, var_937);
    var_939 = wp::mul(var_935, var_938);
    var_940 = wp::mul(var_932, var_3);
    var_941 = wp::add(var_940, var_932);
    var_942 = wp::extract(var_0, var_941);
    var_943 = wp::mul(var_939, var_942);
    var_944 = wp::sub(var_931, var_943);
    var_946 = wp::mul(var_902, var_3);
    var_947 = wp::add(var_946, var_945);
    var_948 = wp::extract(var_0, var_947);
    var_949 = wp::mul(var_902, var_3);
    var_950 = wp::add(var_949, var_945);
    var_951 = wp::extract(var_0, var_950);
    var_952 = wp::mul(var_948, var_951);
    var_953 = wp::mul(var_945, var_3);
    var_954 = wp::add(var_953, var_945);
    var_955 = wp::extract(var_0, var_954);
    var_956 = wp::mul(var_952, var_955);
    var_957 = wp::sub(var_944, var_956);
    // inverse = float64(0.0)                                                                 <L 11>
    var_958 = 0.0;
    // if d > float64(1e-15) * largest:                                                       <L 12>
    var_959 = 1e-15;
    var_960 = wp::mul(var_959, var_38);
    var_961 = (var_957 > var_960);
    if (var_961) {
        // inverse = float64(1.0) / d                                                         <L 13>
        var_962 = 1.0;
        var_963 = wp::div(var_962, var_957);
    }
    if (!var_961) {
        // elif d - d == float64(0.0):                                                        <L 14>
        var_964 = wp::sub(var_957, var_957);
        var_965 = 0.0;
        var_966 = (var_964 == var_965);
        if (var_966) {
            // d = float64(0.0)                                                               <L 15>
            var_967 = 0.0;
        }
        if (!var_966) {
            // inverse = d                                                                    <L 17>
            var_968 = wp::copy(var_957);
        }
        var_969 = wp::where(var_966, var_967, var_957);
        var_970 = wp::where(var_966, var_958, var_968);
    }
    var_971 = wp::where(var_961, var_957, var_969);
    var_972 = wp::where(var_961, var_963, var_970);
    // a[j * UNKNOWNS + j] = d                                                                <L 18>
    var_973 = wp::mul(var_902, var_3);
    var_974 = wp::add(var_973, var_902);
    wp::assign_inplace(var_0, var_974, var_971);
    // for i in range(6):                                                                     <L 19>
    // if i > j:                                                                              <L 20>
    var_976 = (var_975 > var_902);
    if (var_976) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_977 = wp::mul(var_975, var_3);
        var_978 = wp::add(var_977, var_902);
        var_979 = wp::extract(var_0, var_978);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_981 = wp::mul(var_975, var_3);
        var_982 = wp::add(var_981, var_980);
        var_983 = wp::extract(var_0, var_982);
        var_984 = wp::mul(var_902, var_3);
        var_985 = wp::add(var_984, var_980);
        var_986 = wp::extract(var_0, var_985);
        var_987 = wp::mul(var_983, var_986);
        var_988 = wp::mul(var_980, var_3);
        var_989 = wp::add(var_988, var_980);
        var_990 = wp::extract(var_0, var_989);
        var_991 = wp::mul(var_987, var_990);
        var_992 = wp::sub(var_979, var_991);
        var_994 = wp::mul(var_975, var_3);
        var_995 = wp::add(var_994, var_993);
        var_996 = wp::extract(var_0, var_995);
        var_997 = wp::mul(var_902, var_3);
        var_998 = wp::add(var_997, var_993);
        var_999 = wp::extract(var_0, var_998);
        var_1000 = wp::mul(var_996, var_999);
        var_1001 = wp::mul(var_993, var_3);
        var_1002 = wp::add(var_1001, var_993);
        var_1003 = wp::extract(var_0, var_1002);
        var_1004 = wp::mul(var_1000, var_1003);
        var_1005 = wp::sub(var_992, var_1004);
        var_1007 = wp::mul(var_975, var_3);
        var_1008 = wp::add(var_1007, var_1006);
        var_1009 = wp::extract(var_0, var_1008);
        var_1010 = wp::mul(var_902, var_3);
        var_1011 = wp::add(var_1010, var_1006);
        var_1012 = wp::extract(var_0, var_1011);
        var_1013 = wp::mul(var_1009, var_1012);
        var_1014 = wp::mul(var_1006, var_3);
        var_1015 = wp::add(var_1014, var_1006);
        var_1016 = wp::extract(var_0, var_1015);
        var_1017 = wp::mul(var_1013, var_1016);
        var_1018 = wp::sub(var_1005, var_1017);
        var_1020 = wp::mul(var_975, var_3);
        var_1021 = wp::add(var_1020, var_1019);
        var_1022 = wp::extract(var_0, var_1021);
        var_1023 = wp::mul(var_902, var_3);
        var_1024 = wp::add(var_1023, var_1019);
        var_1025 = wp::extract(var_0, var_1024);
        var_1026 = wp::mul(var_1022, var_1025);
        var_1027 = wp::mul(var_1019, var_3);
        var_1028 = wp::add(var_1027, var_1019);
        var_1029 = wp::extract(var_0, var_1028);
        var_1030 = wp::mul(var_1026, var_1029);
        var_1031 = wp::sub(var_1018, var_1030);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_1032 = wp::mul(var_1031, var_972);
        var_1033 = wp::mul(var_975, var_3);
        var_1034 = wp::add(var_1033, var_902);
        wp::assign_inplace(var_0, var_1034, var_1032);
    }
    var_1035 = wp::where(var_976, var_1031, var_900);
    var_1036 = wp::where(var_976, var_1019, var_945);
    // if i > j:                                                                              <L 20>
    var_1038 = (var_1037 > var_902);
    if (var_1038) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_1039 = wp::mul(var_1037, var_3);
        var_1040 = wp::add(var_1039, var_902);
        var_1041 = wp::extract(var_0, var_1040);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_1043 = wp::mul(var_1037, var_3);
        var_1044 = wp::add(var_1043, var_1042);
        var_1045 = wp::extract(var_0, var_1044);
        var_1046 = wp::mul(var_902, var_3);
        var_1047 = wp::add(var_1046, var_1042);
        var_1048 = wp::extract(var_0, var_1047);
        var_1049 = wp::mul(var_1045, var_1048);
        var_1050 = wp::mul(var_1042, var_3);
        var_1051 = wp::add(var_1050, var_1042);
        var_1052 = wp::extract(var_0, var_1051);
        var_1053 = wp::mul(var_1049, var_1052);
        var_1054 = wp::sub(var_1041, var_1053);
        var_1056 = wp::mul(var_1037, var_3);
        var_1057 = wp::add(var_1056, var_1055);
        var_1058 = wp::extract(var_0, var_1057);
        var_1059 = wp::mul(var_902, var_3);
        var_1060 = wp::add(var_1059, var_1055);
        var_1061 = wp::extract(var_0, var_1060);
        var_1062 = wp::mul(var_1058, var_1061);
        var_1063 = wp::mul(var_1055, var_3);
        var_1064 = wp::add(var_1063, var_1055);
        var_1065 = wp::extract(var_0, var_1064);
        var_1066 = wp::mul(var_1062, var_1065);
        var_1067 = wp::sub(var_1054, var_1066);
        var_1069 = wp::mul(var_1037, var_3);
        var_1070 = wp::add(var_1069, var_1068);
        var_1071 = wp::extract(var_0, var_1070);
        var_1072 = wp::mul(var_902, var_3);
        var_1073 = wp::add(var_1072, var_1068);
        var_1074 = wp::extract(var_0, var_1073);
        var_1075 = wp::mul(var_1071, var_1074);
        var_1076 = wp::mul(var_1068, var_3);
        var_1077 = wp::add(var_1076, var_1068);
        var_1078 = wp::extract(var_0, var_1077);
        var_1079 = wp::mul(var_1075, var_1078);
        var_1080 = wp::sub(var_1067, var_1079);
        var_1082 = wp::mul(var_1037, var_3);
        var_1083 = wp::add(var_1082, var_1081);
        var_1084 = wp::extract(var_0, var_1083);
        var_1085 = wp::mul(var_902, var_3);
        var_1086 = wp::add(var_1085, var_1081);
        var_1087 = wp::extract(var_0, var_1086);
        var_1088 = wp::mul(var_1084, var_1087);
        var_1089 = wp::mul(var_1081, var_3);
        var_1090 = wp::add(var_1089, var_1081);
        var_1091 = wp::extract(var_0, var_1090);
        var_1092 = wp::mul(var_1088, var_1091);
        var_1093 = wp::sub(var_1080, var_1092);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_1094 = wp::mul(var_1093, var_972);
        var_1095 = wp::mul(var_1037, var_3);
        var_1096 = wp::add(var_1095, var_902);
        wp::assign_inplace(var_0, var_1096, var_1094);
    }
    var_1097 = wp::where(var_1038, var_1093, var_1035);
    var_1098 = wp::where(var_1038, var_1081, var_1036);
    // if i > j:                                                                              <L 20>
    var_1100 = (var_1099 > var_902);
    if (var_1100) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_1101 = wp::mul(var_1099, var_3);
        var_1102 = wp::add(var_1101, var_902);
        var_1103 = wp::extract(var_0, var_1102);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_1105 = wp::mul(var_1099, var_3);
        var_1106 = wp::add(var_1105, var_1104);
        var_1107 = wp::extract(var_0, var_1106);
        var_1108 = wp::mul(var_902, var_3);
        var_1109 = wp::add(var_1108, var_1104);
        var_1110 = wp::extract(var_0, var_1109);
        var_1111 = wp::mul(var_1107, var_1110);
        var_1112 = wp::mul(var_1104, var_3);
        var_1113 = wp::add(var_1112, var_1104);
        var_1114 = wp::extract(var_0, var_1113);
        var_1115 = wp::mul(var_1111, var_1114);
        var_1116 = wp::sub(var_1103, var_1115);
        var_1118 = wp::mul(var_1099, var_3);
        var_1119 = wp::add(var_1118, var_1117);
        var_1120 = wp::extract(var_0, var_1119);
        var_1121 = wp::mul(var_902, var_3);
        var_1122 = wp::add(var_1121, var_1117);
        var_1123 = wp::extract(var_0, var_1122);
        var_1124 = wp::mul(var_1120, var_1123);
        var_1125 = wp::mul(var_1117, var_3);
        var_1126 = wp::add(var_1125, var_1117);
        var_1127 = wp::extract(var_0, var_1126);
        var_1128 = wp::mul(var_1124, var_1127);
        var_1129 = wp::sub(var_1116, var_1128);
        var_1131 = wp::mul(var_1099, var_3);
        var_1132 = wp::add(var_1131, var_1130);
        var_1133 = wp::extract(var_0, var_1132);
        var_1134 = wp::mul(var_902, var_3);
        var_1135 = wp::add(var_1134, var_1130);
        var_1136 = wp::extract(var_0, var_1135);
        var_1137 = wp::mul(var_1133, var_1136);
        var_1138 = wp::mul(var_1130, var_3);
        var_1139 = wp::add(var_1138, var_1130);
        var_1140 = wp::extract(var_0, var_1139);
        var_1141 = wp::mul(var_1137, var_1140);
        var_1142 = wp::sub(var_1129, var_1141);
        var_1144 = wp::mul(var_1099, var_3);
        var_1145 = wp::add(var_1144, var_1143);
        var_1146 = wp::extract(var_0, var_1145);
        var_1147 = wp::mul(var_902, var_3);
        var_1148 = wp::add(var_1147, var_1143);
        var_1149 = wp::extract(var_0, var_1148);
        var_1150 = wp::mul(var_1146, var_1149);
        var_1151 = wp::mul(var_1143, var_3);
        var_1152 = wp::add(var_1151, var_1143);
        var_1153 = wp::extract(var_0, var_1152);
        var_1154 = wp::mul(var_1150, var_1153);
        var_1155 = wp::sub(var_1142, var_1154);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_1156 = wp::mul(var_1155, var_972);
        var_1157 = wp::mul(var_1099, var_3);
        var_1158 = wp::add(var_1157, var_902);
        wp::assign_inplace(var_0, var_1158, var_1156);
    }
    var_1159 = wp::where(var_1100, var_1155, var_1097);
    var_1160 = wp::where(var_1100, var_1143, var_1098);
    // if i > j:                                                                              <L 20>
    var_1162 = (var_1161 > var_902);
    if (var_1162) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_1163 = wp::mul(var_1161, var_3);
        var_1164 = wp::add(var_1163, var_902);
        var_1165 = wp::extract(var_0, var_1164);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_1167 = wp::mul(var_1161, var_3);
        var_1168 = wp::add(var_1167, var_1166);
        var_1169 = wp::extract(var_0, var_1168);
        var_1170 = wp::mul(var_902, var_3);
        var_1171 = wp::add(var_1170, var_1166);
        var_1172 = wp::extract(var_0, var_1171);
        var_1173 = wp::mul(var_1169, var_1172);
        var_1174 = wp::mul(var_1166, var_3);
        var_1175 = wp::add(var_1174, var_1166);
        var_1176 = wp::extract(var_0, var_1175);
        var_1177 = wp::mul(var_1173, var_1176);
        var_1178 = wp::sub(var_1165, var_1177);
        var_1180 = wp::mul(var_1161, var_3);
        var_1181 = wp::add(var_1180, var_1179);
        var_1182 = wp::extract(var_0, var_1181);
        var_1183 = wp::mul(var_902, var_3);
        var_1184 = wp::add(var_1183, var_1179);
        var_1185 = wp::extract(var_0, var_1184);
        var_1186 = wp::mul(var_1182, var_1185);
        var_1187 = wp::mul(var_1179, var_3);
        var_1188 = wp::add(var_1187, var_1179);
        var_1189 = wp::extract(var_0, var_1188);
        var_1190 = wp::mul(var_1186, var_1189);
        var_1191 = wp::sub(var_1178, var_1190);
        var_1193 = wp::mul(var_1161, var_3);
        var_1194 = wp::add(var_1193, var_1192);
        var_1195 = wp::extract(var_0, var_1194);
        var_1196 = wp::mul(var_902, var_3);
        var_1197 = wp::add(var_1196, var_1192);
        var_1198 = wp::extract(var_0, var_1197);
        var_1199 = wp::mul(var_1195, var_1198);
        var_1200 = wp::mul(var_1192, var_3);
        var_1201 = wp::add(var_1200, var_1192);
        var_1202 = wp::extract(var_0, var_1201);
        var_1203 = wp::mul(var_1199, var_1202);
        var_1204 = wp::sub(var_1191, var_1203);
        var_1206 = wp::mul(var_1161, var_3);
        var_1207 = wp::add(var_1206, var_1205);
        var_1208 = wp::extract(var_0, var_1207);
        var_1209 = wp::mul(var_902, var_3);
        var_1210 = wp::add(var_1209, var_1205);
        var_1211 = wp::extract(var_0, var_1210);
        var_1212 = wp::mul(var_1208, var_1211);
        var_1213 = wp::mul(var_1205, var_3);
        var_1214 = wp::add(var_1213, var_1205);
        var_1215 = wp::extract(var_0, var_1214);
        var_1216 = wp::mul(var_1212, var_1215);
        var_1217 = wp::sub(var_1204, var_1216);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_1218 = wp::mul(var_1217, var_972);
        var_1219 = wp::mul(var_1161, var_3);
        var_1220 = wp::add(var_1219, var_902);
        wp::assign_inplace(var_0, var_1220, var_1218);
    }
    var_1221 = wp::where(var_1162, var_1217, var_1159);
    var_1222 = wp::where(var_1162, var_1205, var_1160);
    // if i > j:                                                                              <L 20>
    var_1224 = (var_1223 > var_902);
    if (var_1224) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_1225 = wp::mul(var_1223, var_3);
        var_1226 = wp::add(var_1225, var_902);
        var_1227 = wp::extract(var_0, var_1226);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_1229 = wp::mul(var_1223, var_3);
        var_1230 = wp::add(var_1229, var_1228);
        var_1231 = wp::extract(var_0, var_1230);
        var_1232 = wp::mul(var_902, var_3);
        var_1233 = wp::add(var_1232, var_1228);
        var_1234 = wp::extract(var_0, var_1233);
        var_1235 = wp::mul(var_1231, var_1234);
        var_1236 = wp::mul(var_1228, var_3);
        var_1237 = wp::add(var_1236, var_1228);
        var_1238 = wp::extract(var_0, var_1237);
        var_1239 = wp::mul(var_1235, var_1238);
        var_1240 = wp::sub(var_1227, var_1239);
        var_1242 = wp::mul(var_1223, var_3);
        var_1243 = wp::add(var_1242, var_1241);
        var_1244 = wp::extract(var_0, var_1243);
        var_1245 = wp::mul(var_902, var_3);
        var_1246 = wp::add(var_1245, var_1241);
        var_1247 = wp::extract(var_0, var_1246);
        var_1248 = wp::mul(var_1244, var_1247);
        var_1249 = wp::mul(var_1241, var_3);
        var_1250 = wp::add(var_1249, var_1241);
        var_1251 = wp::extract(var_0, var_1250);
        var_1252 = wp::mul(var_1248, var_1251);
        var_1253 = wp::sub(var_1240, var_1252);
        var_1255 = wp::mul(var_1223, var_3);
        var_1256 = wp::add(var_1255, var_1254);
        var_1257 = wp::extract(var_0, var_1256);
        var_1258 = wp::mul(var_902, var_3);
        var_1259 = wp::add(var_1258, var_1254);
        var_1260 = wp::extract(var_0, var_1259);
        var_1261 = wp::mul(var_1257, var_1260);
        var_1262 = wp::mul(var_1254, var_3);
        var_1263 = wp::add(var_1262, var_1254);
        var_1264 = wp::extract(var_0, var_1263);
        var_1265 = wp::mul(var_1261, var_1264);
        var_1266 = wp::sub(var_1253, var_1265);
        var_1268 = wp::mul(var_1223, var_3);
        var_1269 = wp::add(var_1268, var_1267);
        var_1270 = wp::extract(var_0, var_1269);
        var_1271 = wp::mul(var_902, var_3);
        var_1272 = wp::add(var_1271, var_1267);
        var_1273 = wp::extract(var_0, var_1272);
        var_1274 = wp::mul(var_1270, var_1273);
        var_1275 = wp::mul(var_1267, var_3);
        var_1276 = wp::add(var_1275, var_1267);
        var_1277 = wp::extract(var_0, var_1276);
        var_1278 = wp::mul(var_1274, var_1277);
        var_1279 = wp::sub(var_1266, var_1278);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_1280 = wp::mul(var_1279, var_972);
        var_1281 = wp::mul(var_1223, var_3);
        var_1282 = wp::add(var_1281, var_902);
        wp::assign_inplace(var_0, var_1282, var_1280);
    }
    var_1283 = wp::where(var_1224, var_1279, var_1221);
    var_1284 = wp::where(var_1224, var_1267, var_1222);
    // if i > j:                                                                              <L 20>
    var_1286 = (var_1285 > var_902);
    if (var_1286) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_1287 = wp::mul(var_1285, var_3);
        var_1288 = wp::add(var_1287, var_902);
        var_1289 = wp::extract(var_0, var_1288);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_1291 = wp::mul(var_1285, var_3);
        var_1292 = wp::add(var_1291, var_1290);
        var_1293 = wp::extract(var_0, var_1292);
        var_1294 = wp::mul(var_902, var_3);
        var_1295 = wp::add(var_1294, var_1290);
        var_1296 = wp::extract(var_0, var_1295);
        var_1297 = wp::mul(var_1293, var_1296);
        var_1298 = wp::mul(var_1290, var_3);
        var_1299 = wp::add(var_1298, var_1290);
        var_1300 = wp::extract(var_0, var_1299);
        var_1301 = wp::mul(var_1297, var_1300);
        var_1302 = wp::sub(var_1289, var_1301);
        var_1304 = wp::mul(var_1285, var_3);
        var_1305 = wp::add(var_1304, var_1303);
        var_1306 = wp::extract(var_0, var_1305);
        var_1307 = wp::mul(var_902, var_3);
        var_1308 = wp::add(var_1307, var_1303);
        var_1309 = wp::extract(var_0, var_1308);
        var_1310 = wp::mul(var_1306, var_1309);
        var_1311 = wp::mul(var_1303, var_3);
        var_1312 = wp::add(var_1311, var_1303);
        var_1313 = wp::extract(var_0, var_1312);
        var_1314 = wp::mul(var_1310, var_1313);
        var_1315 = wp::sub(var_1302, var_1314);
        var_1317 = wp::mul(var_1285, var_3);
        var_1318 = wp::add(var_1317, var_1316);
        var_1319 = wp::extract(var_0, var_1318);
        var_1320 = wp::mul(var_902, var_3);
        var_1321 = wp::add(var_1320, var_1316);
        var_1322 = wp::extract(var_0, var_1321);
        var_1323 = wp::mul(var_1319, var_1322);
        var_1324 = wp::mul(var_1316, var_3);
        var_1325 = wp::add(var_1324, var_1316);
        var_1326 = wp::extract(var_0, var_1325);
        var_1327 = wp::mul(var_1323, var_1326);
        var_1328 = wp::sub(var_1315, var_1327);
        var_1330 = wp::mul(var_1285, var_3);
        var_1331 = wp::add(var_1330, var_1329);
        var_1332 = wp::extract(var_0, var_1331);
        var_1333 = wp::mul(var_902, var_3);
        var_1334 = wp::add(var_1333, var_1329);
        var_1335 = wp::extract(var_0, var_1334);
        var_1336 = wp::mul(var_1332, var_1335);
        var_1337 = wp::mul(var_1329, var_3);
        var_1338 = wp::add(var_1337, var_1329);
        var_1339 = wp::extract(var_0, var_1338);
        var_1340 = wp::mul(var_1336, var_1339);
        var_1341 = wp::sub(var_1328, var_1340);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_1342 = wp::mul(var_1341, var_972);
        var_1343 = wp::mul(var_1285, var_3);
        var_1344 = wp::add(var_1343, var_902);
        wp::assign_inplace(var_0, var_1344, var_1342);
    }
    var_1345 = wp::where(var_1286, var_1341, var_1283);
    var_1346 = wp::where(var_1286, var_1329, var_1284);
    // d = a[j * UNKNOWNS + j]                                                                <L 8>
    var_1348 = wp::mul(var_1347, var_3);
    var_1349 = wp::add(var_1348, var_1347);
    var_1350 = wp::extract(var_0, var_1349);
    // for k in range(j):                                                                     <L 9>
    // d -= a[j * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]                   <L 10>
    var_1352 = wp::mul(var_1347, var_3);
    var_1353 = wp::add(var_1352, var_1351);
    var_1354 = wp::extract(var_0, var_1353);
    var_1355 = wp::mul(var_1347, var_3);
    var_1356 = wp::add(var_1355, var_1351);
    var_1357 = wp::extract(var_0, var_1356);
    var_1358 = wp::mul(var_1354, var_1357);
    var_1359 = wp::mul(var_1351, var_3);
    var_1360 = wp::add(var_1359, var_1351);
    var_1361 = wp::extract(var_0, var_1360);
    var_1362 = wp::mul(var_1358, var_1361);
    var_1363 = wp::sub(var_1350, var_1362);
    var_1365 = wp::mul(var_1347, var_3);
    var_1366 = wp::add(var_1365, var_1364);
    var_1367 = wp::extract(var_0, var_1366);
    var_1368 = wp::mul(var_1347, var_3);
    var_1369 = wp::add(var_1368, var_1364);
    var_1370 = wp::extract(var_0, var_1369);
    var_1371 = wp::mul(var_1367, var_1370);
    var_1372 = wp::mul(var_1364, var_3);
    var_1373 = wp::add(var_1372, var_1364);
    var_1374 = wp::extract(var_0, var_1373);
    var_1375 = wp::mul(var_1371, var_1374);
    var_1376 = wp::sub(var_1363, var_1375);
    var_1378 = wp::mul(var_1347, var_3);
    var_1379 = wp::add(var_1378, var_1377);
    var_1380 = wp::extract(var_0, var_1379);
    var_1381 = wp::mul(var_1347, var_3);
    var_1382 = wp::add(var_1381, var_1377);
    var_1383 = wp::extract(var_0, var_1382);
    var_1384 = wp::mul(var_1380, var_1383);
    var_1385 = wp::mul(var_1377, var_3);
    var_1386 = wp::add(var_1385, var_1377);
    var_1387 = wp::extract(var_0, var_1386);
    var_1388 = wp::mul(var_1384, var_1387);
    var_1389 = wp::sub(var_1376, var_1388);
    var_1391 = wp::mul(var_1347, var_3);
    var_1392 = wp::add(var_1391, var_1390);
    var_1393 = wp::extract(var_0, var_1392);
    var_1394 = wp::mul(var_1347, var_3);
    var_1395 = wp::add(var_1394, var_1390);
    var_1396 = wp::extract(var_0, var_1395);
    var_1397 = wp::mul(var_1393, var_1396);
    var_1398 = wp::mul(var_1390, var_3);
    var_1399 = wp::add(var_1398, var_1390);
    var_1400 = wp::extract(var_0, var_1399);
    var_1401 = wp::mul(var_1397, var_1400);
    var_1402 = wp::sub(var_1389, var_1401);
    var_1404 = wp::mul(var_1347, var_3);
    var_1405 = wp::add(var_1404, var_1403);
    var_1406 = wp::extract(var_0, var_1405);
    var_1407 = wp::mul(var_1347, var_3);
    var_1408 = wp::add(var_1407, var_1403);
    var_1409 = wp::extract(var_0, var_1408);
    var_1410 = wp::mul(var_1406, var_1409);
    var_1411 = wp::mul(var_1403, var_3);
    var_1412 = wp::add(var_1411, var_1403);
    var_1413 = wp::extract(var_0, var_1412);
    var_1414 = wp::mul(var_1410, var_1413);
    var_1415 = wp::sub(var_1402, var_1414);
    // inverse = float64(0.0)                                                                 <L 11>
    var_1416 = 0.0;
    // if d > float64(1e-15) * largest:                                                       <L 12>
    var_1417 = 1e-15;
    var_1418 = wp::mul(var_1417, var_38);
    var_1419 = (var_1415 > var_1418);
    if (var_1419) {
        // inverse = float64(1.0) / d                                                         <L 13>
        var_1420 = 1.0;
        var_1421 = wp::div(var_1420, var_1415);
    }
    if (!var_1419) {
        // elif d - d == float64(0.0):                                                        <L 14>
        var_1422 = wp::sub(var_1415, var_1415);
        var_1423 = 0.0;
        var_1424 = (var_1422 == var_1423);
        if (var_1424) {
            // d = float64(0.0)                                                               <L 15>
            var_1425 = 0.0;
        }
        if (!var_1424) {
            // inverse = d                                                                    <L 17>
            var_1426 = wp::copy(var_1415);
        }
        var_1427 = wp::where(var_1424, var_1425, var_1415);
        var_1428 = wp::where(var_1424, var_1416, var_1426);
    }
    var_1429 = wp::where(var_1419, var_1415, var_1427);
    var_1430 = wp::where(var_1419, var_1421, var_1428);
    // a[j * UNKNOWNS + j] = d                                                                <L 18>
    var_1431 = wp::mul(var_1347, var_3);
    var_1432 = wp::add(var_1431, var_1347);
    wp::assign_inplace(var_0, var_1432, var_1429);
    // for i in range(6):                                                                     <L 19>
    // if i > j:                                                                              <L 20>
    var_1434 = (var_1433 > var_1347);
    if (var_1434) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_1435 = wp::mul(var_1433, var_3);
        var_1436 = wp::add(var_1435, var_1347);
        var_1437 = wp::extract(var_0, var_1436);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_1439 = wp::mul(var_1433, var_3);
        var_1440 = wp::add(var_1439, var_1438);
        var_1441 = wp::extract(var_0, var_1440);
        var_1442 = wp::mul(var_1347, var_3);
        var_1443 = wp::add(var_1442, var_1438);
        var_1444 = wp::extract(var_0, var_1443);
        var_1445 = wp::mul(var_1441, var_1444);
        var_1446 = wp::mul(var_1438, var_3);
        var_1447 = wp::add(var_1446, var_1438);
        var_1448 = wp::extract(var_0, var_1447);
        var_1449 = wp::mul(var_1445, var_1448);
        var_1450 = wp::sub(var_1437, var_1449);
        var_1452 = wp::mul(var_1433, var_3);
        var_1453 = wp::add(var_1452, var_1451);
        var_1454 = wp::extract(var_0, var_1453);
        var_1455 = wp::mul(var_1347, var_3);
        var_1456 = wp::add(var_1455, var_1451);
        var_1457 = wp::extract(var_0, var_1456);
        var_1458 = wp::mul(var_1454, var_1457);
        var_1459 = wp::mul(var_1451, var_3);
        var_1460 = wp::add(var_1459, var_1451);
        var_1461 = wp::extract(var_0, var_1460);
        var_1462 = wp::mul(var_1458, var_1461);
        var_1463 = wp::sub(var_1450, var_1462);
        var_1465 = wp::mul(var_1433, var_3);
        var_1466 = wp::add(var_1465, var_1464);
        var_1467 = wp::extract(var_0, var_1466);
        var_1468 = wp::mul(var_1347, var_3);
        var_1469 = wp::add(var_1468, var_1464);
        var_1470 = wp::extract(var_0, var_1469);
        var_1471 = wp::mul(var_1467, var_1470);
        var_1472 = wp::mul(var_1464, var_3);
        var_1473 = wp::add(var_1472, var_1464);
        var_1474 = wp::extract(var_0, var_1473);
        var_1475 = wp::mul(var_1471, var_1474);
        var_1476 = wp::sub(var_1463, var_1475);
        var_1478 = wp::mul(var_1433, var_3);
        var_1479 = wp::add(var_1478, var_1477);
        var_1480 = wp::extract(var_0, var_1479);
        var_1481 = wp::mul(var_1347, var_3);
        var_1482 = wp::add(var_1481, var_1477);
        var_1483 = wp::extract(var_0, var_1482);
        var_1484 = wp::mul(var_1480, var_1483);
        var_1485 = wp::mul(var_1477, var_3);
        var_1486 = wp::add(var_1485, var_1477);
        var_1487 = wp::extract(var_0, var_1486);
        var_1488 = wp::mul(var_1484, var_1487);
        var_1489 = wp::sub(var_1476, var_1488);
        var_1491 = wp::mul(var_1433, var_3);
        var_1492 = wp::add(var_1491, var_1490);
        var_1493 = wp::extract(var_0, var_1492);
        var_1494 = wp::mul(var_1347, var_3);
        var_1495 = wp::add(var_1494, var_1490);
        var_1496 = wp::extract(var_0, var_1495);
        var_1497 = wp::mul(var_1493, var_1496);
        var_1498 = wp::mul(var_1490, var_3);
        var_1499 = wp::add(var_1498, var_1490);
        var_1500 = wp::extract(var_0, var_1499);
        var_1501 = wp::mul(var_1497, var_1500);
        var_1502 = wp::sub(var_1489, var_1501);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_1503 = wp::mul(var_1502, var_1430);
        var_1504 = wp::mul(var_1433, var_3);
        var_1505 = wp::add(var_1504, var_1347);
        wp::assign_inplace(var_0, var_1505, var_1503);
    }
    var_1506 = wp::where(var_1434, var_1502, var_1345);
    var_1507 = wp::where(var_1434, var_1490, var_1403);
    // if i > j:                                                                              <L 20>
    var_1509 = (var_1508 > var_1347);
    if (var_1509) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_1510 = wp::mul(var_1508, var_3);
        var_1511 = wp::add(var_1510, var_1347);
        var_1512 = wp::extract(var_0, var_1511);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_1514 = wp::mul(var_1508, var_3);
        var_1515 = wp::add(var_1514, var_1513);
        var_1516 = wp::extract(var_0, var_1515);
        var_1517 = wp::mul(var_1347, var_3);
        var_1518 = wp::add(var_1517, var_1513);
        var_1519 = wp::extract(var_0, var_1518);
        var_1520 = wp::mul(var_1516, var_1519);
        var_1521 = wp::mul(var_1513, var_3);
        var_1522 = wp::add(var_1521, var_1513);
        var_1523 = wp::extract(var_0, var_1522);
        var_1524 = wp::mul(var_1520, var_1523);
        var_1525 = wp::sub(var_1512, var_1524);
        var_1527 = wp::mul(var_1508, var_3);
        var_1528 = wp::add(var_1527, var_1526);
        var_1529 = wp::extract(var_0, var_1528);
        var_1530 = wp::mul(var_1347, var_3);
        var_1531 = wp::add(var_1530, var_1526);
        var_1532 = wp::extract(var_0, var_1531);
        var_1533 = wp::mul(var_1529, var_1532);
        var_1534 = wp::mul(var_1526, var_3);
        var_1535 = wp::add(var_1534, var_1526);
        var_1536 = wp::extract(var_0, var_1535);
        var_1537 = wp::mul(var_1533, var_1536);
        var_1538 = wp::sub(var_1525, var_1537);
        var_1540 = wp::mul(var_1508, var_3);
        var_1541 = wp::add(var_1540, var_1539);
        var_1542 = wp::extract(var_0, var_1541);
        var_1543 = wp::mul(var_1347, var_3);
        var_1544 = wp::add(var_1543, var_1539);
        var_1545 = wp::extract(var_0, var_1544);
        var_1546 = wp::mul(var_1542, var_1545);
        var_1547 = wp::mul(var_1539, var_3);
        var_1548 = wp::add(var_1547, var_1539);
        var_1549 = wp::extract(var_0, var_1548);
        var_1550 = wp::mul(var_1546, var_1549);
        var_1551 = wp::sub(var_1538, var_1550);
        var_1553 = wp::mul(var_1508, var_3);
        var_1554 = wp::add(var_1553, var_1552);
        var_1555 = wp::extract(var_0, var_1554);
        var_1556 = wp::mul(var_1347, var_3);
        var_1557 = wp::add(var_1556, var_1552);
        var_1558 = wp::extract(var_0, var_1557);
        var_1559 = wp::mul(var_1555, var_1558);
        var_1560 = wp::mul(var_1552, var_3);
        var_1561 = wp::add(var_1560, var_1552);
        var_1562 = wp::extract(var_0, var_1561);
        var_1563 = wp::mul(var_1559, var_1562);
        var_1564 = wp::sub(var_1551, var_1563);
        var_1566 = wp::mul(var_1508, var_3);
        var_1567 = wp::add(var_1566, var_1565);
        var_1568 = wp::extract(var_0, var_1567);
        var_1569 = wp::mul(var_1347, var_3);
        var_1570 = wp::add(var_1569, var_1565);
        var_1571 = wp::extract(var_0, var_1570);
        var_1572 = wp::mul(var_1568, var_1571);
        var_1573 = wp::mul(var_1565, var_3);
        var_1574 = wp::add(var_1573, var_1565);
        var_1575 = wp::extract(var_0, var_1574);
        var_1576 = wp::mul(var_1572, var_1575);
        var_1577 = wp::sub(var_1564, var_1576);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_1578 = wp::mul(var_1577, var_1430);
        var_1579 = wp::mul(var_1508, var_3);
        var_1580 = wp::add(var_1579, var_1347);
        wp::assign_inplace(var_0, var_1580, var_1578);
    }
    var_1581 = wp::where(var_1509, var_1577, var_1506);
    var_1582 = wp::where(var_1509, var_1565, var_1507);
    // if i > j:                                                                              <L 20>
    var_1584 = (var_1583 > var_1347);
    if (var_1584) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_1585 = wp::mul(var_1583, var_3);
        var_1586 = wp::add(var_1585, var_1347);
        var_1587 = wp::extract(var_0, var_1586);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_1589 = wp::mul(var_1583, var_3);
        var_1590 = wp::add(var_1589, var_1588);
        var_1591 = wp::extract(var_0, var_1590);
        var_1592 = wp::mul(var_1347, var_3);
        var_1593 = wp::add(var_1592, var_1588);
        var_1594 = wp::extract(var_0, var_1593);
        var_1595 = wp::mul(var_1591, var_1594);
        var_1596 = wp::mul(var_1588, var_3);
        var_1597 = wp::add(var_1596, var_1588);
        var_1598 = wp::extract(var_0, var_1597);
        var_1599 = wp::mul(var_1595, var_1598);
        var_1600 = wp::sub(var_1587, var_1599);
        var_1602 = wp::mul(var_1583, var_3);
        var_1603 = wp::add(var_1602, var_1601);
        var_1604 = wp::extract(var_0, var_1603);
        var_1605 = wp::mul(var_1347, var_3);
        var_1606 = wp::add(var_1605, var_1601);
        var_1607 = wp::extract(var_0, var_1606);
        var_1608 = wp::mul(var_1604, var_1607);
        var_1609 = wp::mul(var_1601, var_3);
        var_1610 = wp::add(var_1609, var_1601);
        var_1611 = wp::extract(var_0, var_1610);
        var_1612 = wp::mul(var_1608, var_1611);
        var_1613 = wp::sub(var_1600, var_1612);
        var_1615 = wp::mul(var_1583, var_3);
        var_1616 = wp::add(var_1615, var_1614);
        var_1617 = wp::extract(var_0, var_1616);
        var_1618 = wp::mul(var_1347, var_3);
        var_1619 = wp::add(var_1618, var_1614);
        var_1620 = wp::extract(var_0, var_1619);
        var_1621 = wp::mul(var_1617, var_1620);
        var_1622 = wp::mul(var_1614, var_3);
        var_1623 = wp::add(var_1622, var_1614);
        var_1624 = wp::extract(var_0, var_1623);
        var_1625 = wp::mul(var_1621, var_1624);
        var_1626 = wp::sub(var_1613, var_1625);
        var_1628 = wp::mul(var_1583, var_3);
        var_1629 = wp::add(var_1628, var_1627);
        var_1630 = wp::extract(var_0, var_1629);
        var_1631 = wp::mul(var_1347, var_3);
        var_1632 = wp::add(var_1631, var_1627);
        var_1633 = wp::extract(var_0, var_1632);
        var_1634 = wp::mul(var_1630, var_1633);
        var_1635 = wp::mul(var_1627, var_3);
        var_1636 = wp::add(var_1635, var_1627);
        var_1637 = wp::extract(var_0, var_1636);
        var_1638 = wp::mul(var_1634, var_1637);
        var_1639 = wp::sub(var_1626, var_1638);
        var_1641 = wp::mul(var_1583, var_3);
        var_1642 = wp::add(var_1641, var_1640);
        var_1643 = wp::extract(var_0, var_1642);
        var_1644 = wp::mul(var_1347, var_3);
        var_1645 = wp::add(var_1644, var_1640);
        var_1646 = wp::extract(var_0, var_1645);
        var_1647 = wp::mul(var_1643, var_1646);
        var_1648 = wp::mul(var_1640, var_3);
        var_1649 = wp::add(var_1648, var_1640);
        var_1650 = wp::extract(var_0, var_1649);
        var_1651 = wp::mul(var_1647, var_1650);
        var_1652 = wp::sub(var_1639, var_1651);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_1653 = wp::mul(var_1652, var_1430);
        var_1654 = wp::mul(var_1583, var_3);
        var_1655 = wp::add(var_1654, var_1347);
        wp::assign_inplace(var_0, var_1655, var_1653);
    }
    var_1656 = wp::where(var_1584, var_1652, var_1581);
    var_1657 = wp::where(var_1584, var_1640, var_1582);
    // if i > j:                                                                              <L 20>
    var_1659 = (var_1658 > var_1347);
    if (var_1659) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_1660 = wp::mul(var_1658, var_3);
        var_1661 = wp::add(var_1660, var_1347);
        var_1662 = wp::extract(var_0, var_1661);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_1664 = wp::mul(var_1658, var_3);
        var_1665 = wp::add(var_1664, var_1663);
        var_1666 = wp::extract(var_0, var_1665);
        var_1667 = wp::mul(var_1347, var_3);
        var_1668 = wp::add(var_1667, var_1663);
        var_1669 = wp::extract(var_0, var_1668);
        var_1670 = wp::mul(var_1666, var_1669);
        var_1671 = wp::mul(var_1663, var_3);
        var_1672 = wp::add(var_1671, var_1663);
        var_1673 = wp::extract(var_0, var_1672);
        var_1674 = wp::mul(var_1670, var_1673);
        var_1675 = wp::sub(var_1662, var_1674);
        var_1677 = wp::mul(var_1658, var_3);
        var_1678 = wp::add(var_1677, var_1676);
        var_1679 = wp::extract(var_0, var_1678);
        var_1680 = wp::mul(var_1347, var_3);
        var_1681 = wp::add(var_1680, var_1676);
        var_1682 = wp::extract(var_0, var_1681);
        var_1683 = wp::mul(var_1679, var_1682);
        var_1684 = wp::mul(var_1676, var_3);
        var_1685 = wp::add(var_1684, var_1676);
        var_1686 = wp::extract(var_0, var_1685);
        var_1687 = wp::mul(var_1683, var_1686);
        var_1688 = wp::sub(var_1675, var_1687);
        var_1690 = wp::mul(var_1658, var_3);
        var_1691 = wp::add(var_1690, var_1689);
        var_1692 = wp::extract(var_0, var_1691);
        var_1693 = wp::mul(var_1347, var_3);
        var_1694 = wp::add(var_1693, var_1689);
        var_1695 = wp::extract(var_0, var_1694);
        var_1696 = wp::mul(var_1692, var_1695);
        var_1697 = wp::mul(var_1689, var_3);
        var_1698 = wp::add(var_1697, var_1689);
        var_1699 = wp::extract(var_0, var_1698);
        var_1700 = wp::mul(var_1696, var_1699);
        var_1701 = wp::sub(var_1688, var_1700);
        var_1703 = wp::mul(var_1658, var_3);
        var_1704 = wp::add(var_1703, var_1702);
        var_1705 = wp::extract(var_0, var_1704);
        var_1706 = wp::mul(var_1347, var_3);
        var_1707 = wp::add(var_1706, var_1702);
        var_1708 = wp::extract(var_0, var_1707);
        var_1709 = wp::mul(var_1705, var_1708);
        var_1710 = wp::mul(var_1702, var_3);
        var_1711 = wp::add(var_1710, var_1702);
        var_1712 = wp::extract(var_0, var_1711);
        var_1713 = wp::mul(var_1709, var_1712);
        var_1714 = wp::sub(var_1701, var_1713);
        var_1716 = wp::mul(var_1658, var_3);
        var_1717 = wp::add(var_1716, var_1715);
        var_1718 = wp::extract(var_0, var_1717);
        var_1719 = wp::mul(var_1347, var_3);
        var_1720 = wp::add(var_1719, var_1715);
        var_1721 = wp::extract(var_0, var_1720);
        var_1722 = wp::mul(var_1718, var_1721);
        var_1723 = wp::mul(var_1715, var_3);
        var_1724 = wp::add(var_1723, var_1715);
        var_1725 = wp::extract(var_0, var_1724);
        var_1726 = wp::mul(var_1722, var_1725);
        var_1727 = wp::sub(var_1714, var_1726);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_1728 = wp::mul(var_1727, var_1430);
        var_1729 = wp::mul(var_1658, var_3);
        var_1730 = wp::add(var_1729, var_1347);
        wp::assign_inplace(var_0, var_1730, var_1728);
    }
    var_1731 = wp::where(var_1659, var_1727, var_1656);
    var_1732 = wp::where(var_1659, var_1715, var_1657);
    // if i > j:                                                                              <L 20>
    var_1734 = (var_1733 > var_1347);
    if (var_1734) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_1735 = wp::mul(var_1733, var_3);
        var_1736 = wp::add(var_1735, var_1347);
        var_1737 = wp::extract(var_0, var_1736);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_1739 = wp::mul(var_1733, var_3);
        var_1740 = wp::add(var_1739, var_1738);
        var_1741 = wp::extract(var_0, var_1740);
        var_1742 = wp::mul(var_1347, var_3);
        var_1743 = wp::add(var_1742, var_1738);
        var_1744 = wp::extract(var_0, var_1743);
        var_1745 = wp::mul(var_1741, var_1744);
        var_1746 = wp::mul(var_1738, var_3);
        var_1747 = wp::add(var_1746, var_1738);
        var_1748 = wp::extract(var_0, var_1747);
        var_1749 = wp::mul(var_1745, var_1748);
        var_1750 = wp::sub(var_1737, var_1749);
        var_1752 = wp::mul(var_1733, var_3);
        var_1753 = wp::add(var_1752, var_1751);
        var_1754 = wp::extract(var_0, var_1753);
        var_1755 = wp::mul(var_1347, var_3);
        var_1756 = wp::add(var_1755, var_1751);
        var_1757 = wp::extract(var_0, var_1756);
        var_1758 = wp::mul(var_1754, var_1757);
        var_1759 = wp::mul(var_1751, var_3);
        var_1760 = wp::add(var_1759, var_1751);
        var_1761 = wp::extract(var_0, var_1760);
        var_1762 = wp::mul(var_1758, var_1761);
        var_1763 = wp::sub(var_1750, var_1762);
        var_1765 = wp::mul(var_1733, var_3);
        var_1766 = wp::add(var_1765, var_1764);
        var_1767 = wp::extract(var_0, var_1766);
        var_1768 = wp::mul(var_1347, var_3);
        var_1769 = wp::add(var_1768, var_1764);
        var_1770 = wp::extract(var_0, var_1769);
        var_1771 = wp::mul(var_1767, var_1770);
        var_1772 = wp::mul(var_1764, var_3);
        var_1773 = wp::add(var_1772, var_1764);
        var_1774 = wp::extract(var_0, var_1773);
        var_1775 = wp::mul(var_1771, var_1774);
        var_1776 = wp::sub(var_1763, var_1775);
        var_1778 = wp::mul(var_1733, var_3);
        var_1779 = wp::add(var_1778, var_1777);
        var_1780 = wp::extract(var_0, var_1779);
        var_1781 = wp::mul(var_1347, var_3);
        var_1782 = wp::add(var_1781, var_1777);
        var_1783 = wp::extract(var_0, var_1782);
        var_1784 = wp::mul(var_1780, var_1783);
        var_1785 = wp::mul(var_1777, var_3);
        var_1786 = wp::add(var_1785, var_1777);
        var_1787 = wp::extract(var_0, var_1786);
        var_1788 = wp::mul(var_1784, var_1787);
        var_1789 = wp::sub(var_1776, var_1788);
        var_1791 = wp::mul(var_1733, var_3);
        var_1792 = wp::add(var_1791, var_1790);
        var_1793 = wp::extract(var_0, var_1792);
        var_1794 = wp::mul(var_1347, var_3);
        var_1795 = wp::add(var_1794, var_1790);
        var_1796 = wp::extract(var_0, var_1795);
        var_1797 = wp::mul(var_1793, var_1796);
        var_1798 = wp::mul(var_1790, var_3);
        var_1799 = wp::add(var_1798, var_1790);
        var_1800 = wp::extract(var_0, var_1799);
        var_1801 = wp::mul(var_1797, var_1800);
        var_1802 = wp::sub(var_1789, var_1801);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_1803 = wp::mul(var_1802, var_1430);
        var_1804 = wp::mul(var_1733, var_3);
        var_1805 = wp::add(var_1804, var_1347);
        wp::assign_inplace(var_0, var_1805, var_1803);
    }
    var_1806 = wp::where(var_1734, var_1802, var_1731);
    var_1807 = wp::where(var_1734, var_1790, var_1732);
    // if i > j:                                                                              <L 20>
    var_1809 = (var_1808 > var_1347);
    if (var_1809) {
        // v = a[i * UNKNOWNS + j]                                                            <L 21>
        var_1810 = wp::mul(var_1808, var_3);
        var_1811 = wp::add(var_1810, var_1347);
        var_1812 = wp::extract(var_0, var_1811);
        // for k in range(j):                                                                 <L 22>
        // v -= a[i * UNKNOWNS + k] * a[j * UNKNOWNS + k] * a[k * UNKNOWNS + k]               <L 23>
        var_1814 = wp::mul(var_1808, var_3);
        var_1815 = wp::add(var_1814, var_1813);
        var_1816 = wp::extract(var_0, var_1815);
        var_1817 = wp::mul(var_1347, var_3);
        var_1818 = wp::add(var_1817, var_1813);
        var_1819 = wp::extract(var_0, var_1818);
        var_1820 = wp::mul(var_1816, var_1819);
        var_1821 = wp::mul(var_1813, var_3);
        var_1822 = wp::add(var_1821, var_1813);
        var_1823 = wp::extract(var_0, var_1822);
        var_1824 = wp::mul(var_1820, var_1823);
        var_1825 = wp::sub(var_1812, var_1824);
        var_1827 = wp::mul(var_1808, var_3);
        var_1828 = wp::add(var_1827, var_1826);
        var_1829 = wp::extract(var_0, var_1828);
        var_1830 = wp::mul(var_1347, var_3);
        var_1831 = wp::add(var_1830, var_1826);
        var_1832 = wp::extract(var_0, var_1831);
        var_1833 = wp::mul(var_1829, var_1832);
        var_1834 = wp::mul(var_1826, var_3);
        var_1835 = wp::add(var_1834, var_1826);
        var_1836 = wp::extract(var_0, var_1835);
        var_1837 = wp::mul(var_1833, var_1836);
        var_1838 = wp::sub(var_1825, var_1837);
        var_1840 = wp::mul(var_1808, var_3);
        var_1841 = wp::add(var_1840, var_1839);
        var_1842 = wp::extract(var_0, var_1841);
        var_1843 = wp::mul(var_1347, var_3);
        var_1844 = wp::add(var_1843, var_1839);
        var_1845 = wp::extract(var_0, var_1844);
        var_1846 = wp::mul(var_1842, var_1845);
        var_1847 = wp::mul(var_1839, var_3);
        var_1848 = wp::add(var_1847, var_1839);
        var_1849 = wp::extract(var_0, var_1848);
        var_1850 = wp::mul(var_1846, var_1849);
        var_1851 = wp::sub(var_1838, var_1850);
        var_1853 = wp::mul(var_1808, var_3);
        var_1854 = wp::add(var_1853, var_1852);
        var_1855 = wp::extract(var_0, var_1854);
        var_1856 = wp::mul(var_1347, var_3);
        var_1857 = wp::add(var_1856, var_1852);
        var_1858 = wp::extract(var_0, var_1857);
        var_1859 = wp::mul(var_1855, var_1858);
        var_1860 = wp::mul(var_1852, var_3);
        var_1861 = wp::add(var_1860, var_1852);
        var_1862 = wp::extract(var_0, var_1861);
        var_1863 = wp::mul(var_1859, var_1862);
        var_1864 = wp::sub(var_1851, var_1863);
        var_1866 = wp::mul(var_1808, var_3);
        var_1867 = wp::add(var_1866, var_1865);
        var_1868 = wp::extract(var_0, var_1867);
        var_1869 = wp::mul(var_1347, var_3);
        var_1870 = wp::add(var_1869, var_1865);
        var_1871 = wp::extract(var_0, var_1870);
        var_1872 = wp::mul(var_1868, var_1871);
        var_1873 = wp::mul(var_1865, var_3);
        var_1874 = wp::add(var_1873, var_1865);
        var_1875 = wp::extract(var_0, var_1874);
        var_1876 = wp::mul(var_1872, var_1875);
        var_1877 = wp::sub(var_1864, var_1876);
        // a[i * UNKNOWNS + j] = v * inverse                                                  <L 24>
        var_1878 = wp::mul(var_1877, var_1430);
        var_1879 = wp::mul(var_1808, var_3);
        var_1880 = wp::add(var_1879, var_1347);
        wp::assign_inplace(var_0, var_1880, var_1878);
    }
    var_1881 = wp::where(var_1809, var_1877, var_1806);
    var_1882 = wp::where(var_1809, var_1865, var_1807);
    // return a                                                                               <L 25>
    return var_0;
}


// <pointloom.kernels.algebra.rigid_solve.solve_factored>:1
static CUDA_CALLABLE wp::vec_t<6, wp::float64> solve_factored_0(
    wp::vec_t<36, wp::float64> var_a,
    wp::vec_t<6, wp::float64> var_b)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::vec_t<6, wp::float64> var_1;
    const wp::int32 var_2 = 0;
    wp::float64 var_3;
    const wp::int32 var_4 = 1;
    wp::float64 var_5;
    const wp::int32 var_6 = 0;
    const wp::int32 var_7 = 6;
    wp::int32 var_8;
    wp::int32 var_9;
    wp::float64 var_10;
    wp::float64 var_11;
    wp::float64 var_12;
    wp::float64 var_13;
    const wp::int32 var_14 = 2;
    wp::float64 var_15;
    const wp::int32 var_16 = 0;
    wp::int32 var_17;
    wp::int32 var_18;
    wp::float64 var_19;
    wp::float64 var_20;
    wp::float64 var_21;
    wp::float64 var_22;
    const wp::int32 var_23 = 1;
    wp::int32 var_24;
    wp::int32 var_25;
    wp::float64 var_26;
    wp::float64 var_27;
    wp::float64 var_28;
    wp::float64 var_29;
    const wp::int32 var_30 = 3;
    wp::float64 var_31;
    const wp::int32 var_32 = 0;
    wp::int32 var_33;
    wp::int32 var_34;
    wp::float64 var_35;
    wp::float64 var_36;
    wp::float64 var_37;
    wp::float64 var_38;
    const wp::int32 var_39 = 1;
    wp::int32 var_40;
    wp::int32 var_41;
    wp::float64 var_42;
    wp::float64 var_43;
    wp::float64 var_44;
    wp::float64 var_45;
    const wp::int32 var_46 = 2;
    wp::int32 var_47;
    wp::int32 var_48;
    wp::float64 var_49;
    wp::float64 var_50;
    wp::float64 var_51;
    wp::float64 var_52;
    const wp::int32 var_53 = 4;
    wp::float64 var_54;
    const wp::int32 var_55 = 0;
    wp::int32 var_56;
    wp::int32 var_57;
    wp::float64 var_58;
    wp::float64 var_59;
    wp::float64 var_60;
    wp::float64 var_61;
    const wp::int32 var_62 = 1;
    wp::int32 var_63;
    wp::int32 var_64;
    wp::float64 var_65;
    wp::float64 var_66;
    wp::float64 var_67;
    wp::float64 var_68;
    const wp::int32 var_69 = 2;
    wp::int32 var_70;
    wp::int32 var_71;
    wp::float64 var_72;
    wp::float64 var_73;
    wp::float64 var_74;
    wp::float64 var_75;
    const wp::int32 var_76 = 3;
    wp::int32 var_77;
    wp::int32 var_78;
    wp::float64 var_79;
    wp::float64 var_80;
    wp::float64 var_81;
    wp::float64 var_82;
    const wp::int32 var_83 = 5;
    wp::float64 var_84;
    const wp::int32 var_85 = 0;
    wp::int32 var_86;
    wp::int32 var_87;
    wp::float64 var_88;
    wp::float64 var_89;
    wp::float64 var_90;
    wp::float64 var_91;
    const wp::int32 var_92 = 1;
    wp::int32 var_93;
    wp::int32 var_94;
    wp::float64 var_95;
    wp::float64 var_96;
    wp::float64 var_97;
    wp::float64 var_98;
    const wp::int32 var_99 = 2;
    wp::int32 var_100;
    wp::int32 var_101;
    wp::float64 var_102;
    wp::float64 var_103;
    wp::float64 var_104;
    wp::float64 var_105;
    const wp::int32 var_106 = 3;
    wp::int32 var_107;
    wp::int32 var_108;
    wp::float64 var_109;
    wp::float64 var_110;
    wp::float64 var_111;
    wp::float64 var_112;
    const wp::int32 var_113 = 4;
    wp::int32 var_114;
    wp::int32 var_115;
    wp::float64 var_116;
    wp::float64 var_117;
    wp::float64 var_118;
    wp::float64 var_119;
    const wp::int32 var_120 = 0;
    wp::int32 var_121;
    wp::int32 var_122;
    wp::float64 var_123;
    wp::float64 var_124;
    bool var_125;
    wp::float64 var_126;
    wp::float64 var_127;
    wp::float64 var_128;
    wp::float64 var_129;
    bool var_130;
    wp::float64 var_131;
    const wp::int32 var_132 = 1;
    wp::int32 var_133;
    wp::int32 var_134;
    wp::float64 var_135;
    wp::float64 var_136;
    bool var_137;
    wp::float64 var_138;
    wp::float64 var_139;
    wp::float64 var_140;
    wp::float64 var_141;
    bool var_142;
    wp::float64 var_143;
    const wp::int32 var_144 = 2;
    wp::int32 var_145;
    wp::int32 var_146;
    wp::float64 var_147;
    wp::float64 var_148;
    bool var_149;
    wp::float64 var_150;
    wp::float64 var_151;
    wp::float64 var_152;
    wp::float64 var_153;
    bool var_154;
    wp::float64 var_155;
    const wp::int32 var_156 = 3;
    wp::int32 var_157;
    wp::int32 var_158;
    wp::float64 var_159;
    wp::float64 var_160;
    bool var_161;
    wp::float64 var_162;
    wp::float64 var_163;
    wp::float64 var_164;
    wp::float64 var_165;
    bool var_166;
    wp::float64 var_167;
    const wp::int32 var_168 = 4;
    wp::int32 var_169;
    wp::int32 var_170;
    wp::float64 var_171;
    wp::float64 var_172;
    bool var_173;
    wp::float64 var_174;
    wp::float64 var_175;
    wp::float64 var_176;
    wp::float64 var_177;
    bool var_178;
    wp::float64 var_179;
    const wp::int32 var_180 = 5;
    wp::int32 var_181;
    wp::int32 var_182;
    wp::float64 var_183;
    wp::float64 var_184;
    bool var_185;
    wp::float64 var_186;
    wp::float64 var_187;
    wp::float64 var_188;
    wp::float64 var_189;
    bool var_190;
    wp::float64 var_191;
    const wp::int32 var_192 = 0;
    const wp::int32 var_193 = 1;
    wp::int32 var_194;
    wp::int32 var_195;
    wp::float64 var_196;
    const wp::int32 var_197 = 0;
    bool var_198;
    wp::int32 var_199;
    wp::int32 var_200;
    wp::float64 var_201;
    wp::float64 var_202;
    wp::float64 var_203;
    wp::float64 var_204;
    wp::float64 var_205;
    const wp::int32 var_206 = 1;
    bool var_207;
    wp::int32 var_208;
    wp::int32 var_209;
    wp::float64 var_210;
    wp::float64 var_211;
    wp::float64 var_212;
    wp::float64 var_213;
    wp::float64 var_214;
    const wp::int32 var_215 = 2;
    bool var_216;
    wp::int32 var_217;
    wp::int32 var_218;
    wp::float64 var_219;
    wp::float64 var_220;
    wp::float64 var_221;
    wp::float64 var_222;
    wp::float64 var_223;
    const wp::int32 var_224 = 3;
    bool var_225;
    wp::int32 var_226;
    wp::int32 var_227;
    wp::float64 var_228;
    wp::float64 var_229;
    wp::float64 var_230;
    wp::float64 var_231;
    wp::float64 var_232;
    const wp::int32 var_233 = 4;
    bool var_234;
    wp::int32 var_235;
    wp::int32 var_236;
    wp::float64 var_237;
    wp::float64 var_238;
    wp::float64 var_239;
    wp::float64 var_240;
    wp::float64 var_241;
    const wp::int32 var_242 = 5;
    bool var_243;
    wp::int32 var_244;
    wp::int32 var_245;
    wp::float64 var_246;
    wp::float64 var_247;
    wp::float64 var_248;
    wp::float64 var_249;
    wp::float64 var_250;
    const wp::int32 var_251 = 1;
    const wp::int32 var_252 = 1;
    wp::int32 var_253;
    wp::int32 var_254;
    wp::float64 var_255;
    const wp::int32 var_256 = 0;
    bool var_257;
    wp::int32 var_258;
    wp::int32 var_259;
    wp::float64 var_260;
    wp::float64 var_261;
    wp::float64 var_262;
    wp::float64 var_263;
    wp::float64 var_264;
    const wp::int32 var_265 = 1;
    bool var_266;
    wp::int32 var_267;
    wp::int32 var_268;
    wp::float64 var_269;
    wp::float64 var_270;
    wp::float64 var_271;
    wp::float64 var_272;
    wp::float64 var_273;
    const wp::int32 var_274 = 2;
    bool var_275;
    wp::int32 var_276;
    wp::int32 var_277;
    wp::float64 var_278;
    wp::float64 var_279;
    wp::float64 var_280;
    wp::float64 var_281;
    wp::float64 var_282;
    const wp::int32 var_283 = 3;
    bool var_284;
    wp::int32 var_285;
    wp::int32 var_286;
    wp::float64 var_287;
    wp::float64 var_288;
    wp::float64 var_289;
    wp::float64 var_290;
    wp::float64 var_291;
    const wp::int32 var_292 = 4;
    bool var_293;
    wp::int32 var_294;
    wp::int32 var_295;
    wp::float64 var_296;
    wp::float64 var_297;
    wp::float64 var_298;
    wp::float64 var_299;
    wp::float64 var_300;
    const wp::int32 var_301 = 5;
    bool var_302;
    wp::int32 var_303;
    wp::int32 var_304;
    wp::float64 var_305;
    wp::float64 var_306;
    wp::float64 var_307;
    wp::float64 var_308;
    wp::float64 var_309;
    const wp::int32 var_310 = 2;
    const wp::int32 var_311 = 1;
    wp::int32 var_312;
    wp::int32 var_313;
    wp::float64 var_314;
    const wp::int32 var_315 = 0;
    bool var_316;
    wp::int32 var_317;
    wp::int32 var_318;
    wp::float64 var_319;
    wp::float64 var_320;
    wp::float64 var_321;
    wp::float64 var_322;
    wp::float64 var_323;
    const wp::int32 var_324 = 1;
    bool var_325;
    wp::int32 var_326;
    wp::int32 var_327;
    wp::float64 var_328;
    wp::float64 var_329;
    wp::float64 var_330;
    wp::float64 var_331;
    wp::float64 var_332;
    const wp::int32 var_333 = 2;
    bool var_334;
    wp::int32 var_335;
    wp::int32 var_336;
    wp::float64 var_337;
    wp::float64 var_338;
    wp::float64 var_339;
    wp::float64 var_340;
    wp::float64 var_341;
    const wp::int32 var_342 = 3;
    bool var_343;
    wp::int32 var_344;
    wp::int32 var_345;
    wp::float64 var_346;
    wp::float64 var_347;
    wp::float64 var_348;
    wp::float64 var_349;
    wp::float64 var_350;
    const wp::int32 var_351 = 4;
    bool var_352;
    wp::int32 var_353;
    wp::int32 var_354;
    wp::float64 var_355;
    wp::float64 var_356;
    wp::float64 var_357;
    wp::float64 var_358;
    wp::float64 var_359;
    const wp::int32 var_360 = 5;
    bool var_361;
    wp::int32 var_362;
    wp::int32 var_363;
    wp::float64 var_364;
    wp::float64 var_365;
    wp::float64 var_366;
    wp::float64 var_367;
    wp::float64 var_368;
    const wp::int32 var_369 = 3;
    const wp::int32 var_370 = 1;
    wp::int32 var_371;
    wp::int32 var_372;
    wp::float64 var_373;
    const wp::int32 var_374 = 0;
    bool var_375;
    wp::int32 var_376;
    wp::int32 var_377;
    wp::float64 var_378;
    wp::float64 var_379;
    wp::float64 var_380;
    wp::float64 var_381;
    wp::float64 var_382;
    const wp::int32 var_383 = 1;
    bool var_384;
    wp::int32 var_385;
    wp::int32 var_386;
    wp::float64 var_387;
    wp::float64 var_388;
    wp::float64 var_389;
    wp::float64 var_390;
    wp::float64 var_391;
    const wp::int32 var_392 = 2;
    bool var_393;
    wp::int32 var_394;
    wp::int32 var_395;
    wp::float64 var_396;
    wp::float64 var_397;
    wp::float64 var_398;
    wp::float64 var_399;
    wp::float64 var_400;
    const wp::int32 var_401 = 3;
    bool var_402;
    wp::int32 var_403;
    wp::int32 var_404;
    wp::float64 var_405;
    wp::float64 var_406;
    wp::float64 var_407;
    wp::float64 var_408;
    wp::float64 var_409;
    const wp::int32 var_410 = 4;
    bool var_411;
    wp::int32 var_412;
    wp::int32 var_413;
    wp::float64 var_414;
    wp::float64 var_415;
    wp::float64 var_416;
    wp::float64 var_417;
    wp::float64 var_418;
    const wp::int32 var_419 = 5;
    bool var_420;
    wp::int32 var_421;
    wp::int32 var_422;
    wp::float64 var_423;
    wp::float64 var_424;
    wp::float64 var_425;
    wp::float64 var_426;
    wp::float64 var_427;
    const wp::int32 var_428 = 4;
    const wp::int32 var_429 = 1;
    wp::int32 var_430;
    wp::int32 var_431;
    wp::float64 var_432;
    const wp::int32 var_433 = 0;
    bool var_434;
    wp::int32 var_435;
    wp::int32 var_436;
    wp::float64 var_437;
    wp::float64 var_438;
    wp::float64 var_439;
    wp::float64 var_440;
    wp::float64 var_441;
    const wp::int32 var_442 = 1;
    bool var_443;
    wp::int32 var_444;
    wp::int32 var_445;
    wp::float64 var_446;
    wp::float64 var_447;
    wp::float64 var_448;
    wp::float64 var_449;
    wp::float64 var_450;
    const wp::int32 var_451 = 2;
    bool var_452;
    wp::int32 var_453;
    wp::int32 var_454;
    wp::float64 var_455;
    wp::float64 var_456;
    wp::float64 var_457;
    wp::float64 var_458;
    wp::float64 var_459;
    const wp::int32 var_460 = 3;
    bool var_461;
    wp::int32 var_462;
    wp::int32 var_463;
    wp::float64 var_464;
    wp::float64 var_465;
    wp::float64 var_466;
    wp::float64 var_467;
    wp::float64 var_468;
    const wp::int32 var_469 = 4;
    bool var_470;
    wp::int32 var_471;
    wp::int32 var_472;
    wp::float64 var_473;
    wp::float64 var_474;
    wp::float64 var_475;
    wp::float64 var_476;
    wp::float64 var_477;
    const wp::int32 var_478 = 5;
    bool var_479;
    wp::int32 var_480;
    wp::int32 var_481;
    wp::float64 var_482;
    wp::float64 var_483;
    wp::float64 var_484;
    wp::float64 var_485;
    wp::float64 var_486;
    const wp::int32 var_487 = 5;
    const wp::int32 var_488 = 1;
    wp::int32 var_489;
    wp::int32 var_490;
    wp::float64 var_491;
    const wp::int32 var_492 = 0;
    bool var_493;
    wp::int32 var_494;
    wp::int32 var_495;
    wp::float64 var_496;
    wp::float64 var_497;
    wp::float64 var_498;
    wp::float64 var_499;
    wp::float64 var_500;
    const wp::int32 var_501 = 1;
    bool var_502;
    wp::int32 var_503;
    wp::int32 var_504;
    wp::float64 var_505;
    wp::float64 var_506;
    wp::float64 var_507;
    wp::float64 var_508;
    wp::float64 var_509;
    const wp::int32 var_510 = 2;
    bool var_511;
    wp::int32 var_512;
    wp::int32 var_513;
    wp::float64 var_514;
    wp::float64 var_515;
    wp::float64 var_516;
    wp::float64 var_517;
    wp::float64 var_518;
    const wp::int32 var_519 = 3;
    bool var_520;
    wp::int32 var_521;
    wp::int32 var_522;
    wp::float64 var_523;
    wp::float64 var_524;
    wp::float64 var_525;
    wp::float64 var_526;
    wp::float64 var_527;
    const wp::int32 var_528 = 4;
    bool var_529;
    wp::int32 var_530;
    wp::int32 var_531;
    wp::float64 var_532;
    wp::float64 var_533;
    wp::float64 var_534;
    wp::float64 var_535;
    wp::float64 var_536;
    const wp::int32 var_537 = 5;
    bool var_538;
    wp::int32 var_539;
    wp::int32 var_540;
    wp::float64 var_541;
    wp::float64 var_542;
    wp::float64 var_543;
    wp::float64 var_544;
    wp::float64 var_545;
    //---------
    // forward
    // def solve_factored(a, b):                                                              <L 1>
    // x = vec6d(float64(0.0))                                                                <L 3>
    var_0 = 0.0;
    var_1 = wp::vec_t<6, wp::float64>(var_0);
    // for j in range(6):                                                                     <L 4>
    // v = b[j]                                                                               <L 5>
    var_3 = wp::extract(var_b, var_2);
    // for k in range(j):                                                                     <L 6>
    // x[j] = v                                                                               <L 8>
    wp::assign_inplace(var_1, var_2, var_3);
    // v = b[j]                                                                               <L 5>
    var_5 = wp::extract(var_b, var_4);
    // for k in range(j):                                                                     <L 6>
    // v -= a[j * UNKNOWNS + k] * x[k]                                                        <L 7>
    var_8 = wp::mul(var_4, var_7);
    var_9 = wp::add(var_8, var_6);
    var_10 = wp::extract(var_a, var_9);
    var_11 = wp::extract(var_1, var_6);
    var_12 = wp::mul(var_10, var_11);
    var_13 = wp::sub(var_5, var_12);
    // x[j] = v                                                                               <L 8>
    wp::assign_inplace(var_1, var_4, var_13);
    // v = b[j]                                                                               <L 5>
    var_15 = wp::extract(var_b, var_14);
    // for k in range(j):                                                                     <L 6>
    // v -= a[j * UNKNOWNS + k] * x[k]                                                        <L 7>
    var_17 = wp::mul(var_14, var_7);
    var_18 = wp::add(var_17, var_16);
    var_19 = wp::extract(var_a, var_18);
    var_20 = wp::extract(var_1, var_16);
    var_21 = wp::mul(var_19, var_20);
    var_22 = wp::sub(var_15, var_21);
    var_24 = wp::mul(var_14, var_7);
    var_25 = wp::add(var_24, var_23);
    var_26 = wp::extract(var_a, var_25);
    var_27 = wp::extract(var_1, var_23);
    var_28 = wp::mul(var_26, var_27);
    var_29 = wp::sub(var_22, var_28);
    // x[j] = v                                                                               <L 8>
    wp::assign_inplace(var_1, var_14, var_29);
    // v = b[j]                                                                               <L 5>
    var_31 = wp::extract(var_b, var_30);
    // for k in range(j):                                                                     <L 6>
    // v -= a[j * UNKNOWNS + k] * x[k]                                                        <L 7>
    var_33 = wp::mul(var_30, var_7);
    var_34 = wp::add(var_33, var_32);
    var_35 = wp::extract(var_a, var_34);
    var_36 = wp::extract(var_1, var_32);
    var_37 = wp::mul(var_35, var_36);
    var_38 = wp::sub(var_31, var_37);
    var_40 = wp::mul(var_30, var_7);
    var_41 = wp::add(var_40, var_39);
    var_42 = wp::extract(var_a, var_41);
    var_43 = wp::extract(var_1, var_39);
    var_44 = wp::mul(var_42, var_43);
    var_45 = wp::sub(var_38, var_44);
    var_47 = wp::mul(var_30, var_7);
    var_48 = wp::add(var_47, var_46);
    var_49 = wp::extract(var_a, var_48);
    var_50 = wp::extract(var_1, var_46);
    var_51 = wp::mul(var_49, var_50);
    var_52 = wp::sub(var_45, var_51);
    // x[j] = v                                                                               <L 8>
    wp::assign_inplace(var_1, var_30, var_52);
    // v = b[j]                                                                               <L 5>
    var_54 = wp::extract(var_b, var_53);
    // for k in range(j):                                                                     <L 6>
    // v -= a[j * UNKNOWNS + k] * x[k]                                                        <L 7>
    var_56 = wp::mul(var_53, var_7);
    var_57 = wp::add(var_56, var_55);
    var_58 = wp::extract(var_a, var_57);
    var_59 = wp::extract(var_1, var_55);
    var_60 = wp::mul(var_58, var_59);
    var_61 = wp::sub(var_54, var_60);
    var_63 = wp::mul(var_53, var_7);
    var_64 = wp::add(var_63, var_62);
    var_65 = wp::extract(var_a, var_64);
    var_66 = wp::extract(var_1, var_62);
    var_67 = wp::mul(var_65, var_66);
    var_68 = wp::sub(var_61, var_67);
    var_70 = wp::mul(var_53, var_7);
    var_71 = wp::add(var_70, var_69);
    var_72 = wp::extract(var_a, var_71);
    var_73 = wp::extract(var_1, var_69);
    var_74 = wp::mul(var_72, var_73);
    var_75 = wp::sub(var_68, var_74);
    var_77 = wp::mul(var_53, var_7);
    var_78 = wp::add(var_77, var_76);
    var_79 = wp::extract(var_a, var_78);
    var_80 = wp::extract(var_1, var_76);
    var_81 = wp::mul(var_79, var_80);
    var_82 = wp::sub(var_75, var_81);
    // x[j] = v                                                                               <L 8>
    wp::assign_inplace(var_1, var_53, var_82);
    // v = b[j]                                                                               <L 5>
    var_84 = wp::extract(var_b, var_83);
    // for k in range(j):                                                                     <L 6>
    // v -= a[j * UNKNOWNS + k] * x[k]                                                        <L 7>
    var_86 = wp::mul(var_83, var_7);
    var_87 = wp::add(var_86, var_85);
    var_88 = wp::extract(var_a, var_87);
    var_89 = wp::extract(var_1, var_85);
    var_90 = wp::mul(var_88, var_89);
    var_91 = wp::sub(var_84, var_90);
    var_93 = wp::mul(var_83, var_7);
    var_94 = wp::add(var_93, var_92);
    var_95 = wp::extract(var_a, var_94);
    var_96 = wp::extract(var_1, var_92);
    var_97 = wp::mul(var_95, var_96);
    var_98 = wp::sub(var_91, var_97);
    var_100 = wp::mul(var_83, var_7);
    var_101 = wp::add(var_100, var_99);
    var_102 = wp::extract(var_a, var_101);
    var_103 = wp::extract(var_1, var_99);
    var_104 = wp::mul(var_102, var_103);
    var_105 = wp::sub(var_98, var_104);
    var_107 = wp::mul(var_83, var_7);
    var_108 = wp::add(var_107, var_106);
    var_109 = wp::extract(var_a, var_108);
    var_110 = wp::extract(var_1, var_106);
    var_111 = wp::mul(var_109, var_110);
    var_112 = wp::sub(var_105, var_111);
    var_114 = wp::mul(var_83, var_7);
    var_115 = wp::add(var_114, var_113);
    var_116 = wp::extract(var_a, var_115);
    var_117 = wp::extract(var_1, var_113);
    var_118 = wp::mul(var_116, var_117);
    var_119 = wp::sub(var_112, var_118);
    // x[j] = v                                                                               <L 8>
    wp::assign_inplace(var_1, var_83, var_119);
    // for j in range(6):                                                                     <L 9>
    // pivot = a[j * UNKNOWNS + j]                                                            <L 10>
    var_121 = wp::mul(var_120, var_7);
    var_122 = wp::add(var_121, var_120);
    var_123 = wp::extract(var_a, var_122);
    // if pivot > float64(0.0):                                                               <L 11>
    var_124 = 0.0;
    var_125 = (var_123 > var_124);
    if (var_125) {
        // x[j] = x[j] / pivot                                                                <L 12>
        var_126 = wp::extract(var_1, var_120);
        var_127 = wp::div(var_126, var_123);
        wp::assign_inplace(var_1, var_120, var_127);
    }
    if (!var_125) {
        // elif pivot - pivot == float64(0.0):                                                <L 13>
        var_128 = wp::sub(var_123, var_123);
        var_129 = 0.0;
        var_130 = (var_128 == var_129);
        if (var_130) {
            // x[j] = float64(0.0)                                                            <L 14>
            var_131 = 0.0;
            wp::assign_inplace(var_1, var_120, var_131);
        }
        if (!var_130) {
            // x[j] = pivot                                                                   <L 16>
            wp::assign_inplace(var_1, var_120, var_123);
        }
    }
    // pivot = a[j * UNKNOWNS + j]                                                            <L 10>
    var_133 = wp::mul(var_132, var_7);
    var_134 = wp::add(var_133, var_132);
    var_135 = wp::extract(var_a, var_134);
    // if pivot > float64(0.0):                                                               <L 11>
    var_136 = 0.0;
    var_137 = (var_135 > var_136);
    if (var_137) {
        // x[j] = x[j] / pivot                                                                <L 12>
        var_138 = wp::extract(var_1, var_132);
        var_139 = wp::div(var_138, var_135);
        wp::assign_inplace(var_1, var_132, var_139);
    }
    if (!var_137) {
        // elif pivot - pivot == float64(0.0):                                                <L 13>
        var_140 = wp::sub(var_135, var_135);
        var_141 = 0.0;
        var_142 = (var_140 == var_141);
        if (var_142) {
            // x[j] = float64(0.0)                                                            <L 14>
            var_143 = 0.0;
            wp::assign_inplace(var_1, var_132, var_143);
        }
        if (!var_142) {
            // x[j] = pivot                                                                   <L 16>
            wp::assign_inplace(var_1, var_132, var_135);
        }
    }
    // pivot = a[j * UNKNOWNS + j]                                                            <L 10>
    var_145 = wp::mul(var_144, var_7);
    var_146 = wp::add(var_145, var_144);
    var_147 = wp::extract(var_a, var_146);
    // if pivot > float64(0.0):                                                               <L 11>
    var_148 = 0.0;
    var_149 = (var_147 > var_148);
    if (var_149) {
        // x[j] = x[j] / pivot                                                                <L 12>
        var_150 = wp::extract(var_1, var_144);
        var_151 = wp::div(var_150, var_147);
        wp::assign_inplace(var_1, var_144, var_151);
    }
    if (!var_149) {
        // elif pivot - pivot == float64(0.0):                                                <L 13>
        var_152 = wp::sub(var_147, var_147);
        var_153 = 0.0;
        var_154 = (var_152 == var_153);
        if (var_154) {
            // x[j] = float64(0.0)                                                            <L 14>
            var_155 = 0.0;
            wp::assign_inplace(var_1, var_144, var_155);
        }
        if (!var_154) {
            // x[j] = pivot                                                                   <L 16>
            wp::assign_inplace(var_1, var_144, var_147);
        }
    }
    // pivot = a[j * UNKNOWNS + j]                                                            <L 10>
    var_157 = wp::mul(var_156, var_7);
    var_158 = wp::add(var_157, var_156);
    var_159 = wp::extract(var_a, var_158);
    // if pivot > float64(0.0):                                                               <L 11>
    var_160 = 0.0;
    var_161 = (var_159 > var_160);
    if (var_161) {
        // x[j] = x[j] / pivot                                                                <L 12>
        var_162 = wp::extract(var_1, var_156);
        var_163 = wp::div(var_162, var_159);
        wp::assign_inplace(var_1, var_156, var_163);
    }
    if (!var_161) {
        // elif pivot - pivot == float64(0.0):                                                <L 13>
        var_164 = wp::sub(var_159, var_159);
        var_165 = 0.0;
        var_166 = (var_164 == var_165);
        if (var_166) {
            // x[j] = float64(0.0)                                                            <L 14>
            var_167 = 0.0;
            wp::assign_inplace(var_1, var_156, var_167);
        }
        if (!var_166) {
            // x[j] = pivot                                                                   <L 16>
            wp::assign_inplace(var_1, var_156, var_159);
        }
    }
    // pivot = a[j * UNKNOWNS + j]                                                            <L 10>
    var_169 = wp::mul(var_168, var_7);
    var_170 = wp::add(var_169, var_168);
    var_171 = wp::extract(var_a, var_170);
    // if pivot > float64(0.0):                                                               <L 11>
    var_172 = 0.0;
    var_173 = (var_171 > var_172);
    if (var_173) {
        // x[j] = x[j] / pivot                                                                <L 12>
        var_174 = wp::extract(var_1, var_168);
        var_175 = wp::div(var_174, var_171);
        wp::assign_inplace(var_1, var_168, var_175);
    }
    if (!var_173) {
        // elif pivot - pivot == float64(0.0):                                                <L 13>
        var_176 = wp::sub(var_171, var_171);
        var_177 = 0.0;
        var_178 = (var_176 == var_177);
        if (var_178) {
            // x[j] = float64(0.0)                                                            <L 14>
            var_179 = 0.0;
            wp::assign_inplace(var_1, var_168, var_179);
        }
        if (!var_178) {
            // x[j] = pivot                                                                   <L 16>
            wp::assign_inplace(var_1, var_168, var_171);
        }
    }
    // pivot = a[j * UNKNOWNS + j]                                                            <L 10>
    var_181 = wp::mul(var_180, var_7);
    var_182 = wp::add(var_181, var_180);
    var_183 = wp::extract(var_a, var_182);
    // if pivot > float64(0.0):                                                               <L 11>
    var_184 = 0.0;
    var_185 = (var_183 > var_184);
    if (var_185) {
        // x[j] = x[j] / pivot                                                                <L 12>
        var_186 = wp::extract(var_1, var_180);
        var_187 = wp::div(var_186, var_183);
        wp::assign_inplace(var_1, var_180, var_187);
    }
    if (!var_185) {
        // elif pivot - pivot == float64(0.0):                                                <L 13>
        var_188 = wp::sub(var_183, var_183);
        var_189 = 0.0;
        var_190 = (var_188 == var_189);
        if (var_190) {
            // x[j] = float64(0.0)                                                            <L 14>
            var_191 = 0.0;
            wp::assign_inplace(var_1, var_180, var_191);
        }
        if (!var_190) {
            // x[j] = pivot                                                                   <L 16>
            wp::assign_inplace(var_1, var_180, var_183);
        }
    }
    // for step in range(6):                                                                  <L 17>
    // j = UNKNOWNS - 1 - step                                                                <L 18>
    var_194 = wp::sub(var_7, var_193);
    var_195 = wp::sub(var_194, var_192);
    // v = x[j]                                                                               <L 19>
    var_196 = wp::extract(var_1, var_195);
    // for k in range(6):                                                                     <L 20>
    // if k > j:                                                                              <L 21>
    var_198 = (var_197 > var_195);
    if (var_198) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_199 = wp::mul(var_197, var_7);
        var_200 = wp::add(var_199, var_195);
        var_201 = wp::extract(var_a, var_200);
        var_202 = wp::extract(var_1, var_197);
        var_203 = wp::mul(var_201, var_202);
        var_204 = wp::sub(var_196, var_203);
    }
    var_205 = wp::where(var_198, var_204, var_196);
    // if k > j:                                                                              <L 21>
    var_207 = (var_206 > var_195);
    if (var_207) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_208 = wp::mul(var_206, var_7);
        var_209 = wp::add(var_208, var_195);
        var_210 = wp::extract(var_a, var_209);
        var_211 = wp::extract(var_1, var_206);
        var_212 = wp::mul(var_210, var_211);
        var_213 = wp::sub(var_205, var_212);
    }
    var_214 = wp::where(var_207, var_213, var_205);
    // if k > j:                                                                              <L 21>
    var_216 = (var_215 > var_195);
    if (var_216) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_217 = wp::mul(var_215, var_7);
        var_218 = wp::add(var_217, var_195);
        var_219 = wp::extract(var_a, var_218);
        var_220 = wp::extract(var_1, var_215);
        var_221 = wp::mul(var_219, var_220);
        var_222 = wp::sub(var_214, var_221);
    }
    var_223 = wp::where(var_216, var_222, var_214);
    // if k > j:                                                                              <L 21>
    var_225 = (var_224 > var_195);
    if (var_225) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_226 = wp::mul(var_224, var_7);
        var_227 = wp::add(var_226, var_195);
        var_228 = wp::extract(var_a, var_227);
        var_229 = wp::extract(var_1, var_224);
        var_230 = wp::mul(var_228, var_229);
        var_231 = wp::sub(var_223, var_230);
    }
    var_232 = wp::where(var_225, var_231, var_223);
    // if k > j:                                                                              <L 21>
    var_234 = (var_233 > var_195);
    if (var_234) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_235 = wp::mul(var_233, var_7);
        var_236 = wp::add(var_235, var_195);
        var_237 = wp::extract(var_a, var_236);
        var_238 = wp::extract(var_1, var_233);
        var_239 = wp::mul(var_237, var_238);
        var_240 = wp::sub(var_232, var_239);
    }
    var_241 = wp::where(var_234, var_240, var_232);
    // if k > j:                                                                              <L 21>
    var_243 = (var_242 > var_195);
    if (var_243) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_244 = wp::mul(var_242, var_7);
        var_245 = wp::add(var_244, var_195);
        var_246 = wp::extract(var_a, var_245);
        var_247 = wp::extract(var_1, var_242);
        var_248 = wp::mul(var_246, var_247);
        var_249 = wp::sub(var_241, var_248);
    }
    var_250 = wp::where(var_243, var_249, var_241);
    // x[j] = v                                                                               <L 23>
    wp::assign_inplace(var_1, var_195, var_250);
    // j = UNKNOWNS - 1 - step                                                                <L 18>
    var_253 = wp::sub(var_7, var_252);
    var_254 = wp::sub(var_253, var_251);
    // v = x[j]                                                                               <L 19>
    var_255 = wp::extract(var_1, var_254);
    // for k in range(6):                                                                     <L 20>
    // if k > j:                                                                              <L 21>
    var_257 = (var_256 > var_254);
    if (var_257) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_258 = wp::mul(var_256, var_7);
        var_259 = wp::add(var_258, var_254);
        var_260 = wp::extract(var_a, var_259);
        var_261 = wp::extract(var_1, var_256);
        var_262 = wp::mul(var_260, var_261);
        var_263 = wp::sub(var_255, var_262);
    }
    var_264 = wp::where(var_257, var_263, var_255);
    // if k > j:                                                                              <L 21>
    var_266 = (var_265 > var_254);
    if (var_266) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_267 = wp::mul(var_265, var_7);
        var_268 = wp::add(var_267, var_254);
        var_269 = wp::extract(var_a, var_268);
        var_270 = wp::extract(var_1, var_265);
        var_271 = wp::mul(var_269, var_270);
        var_272 = wp::sub(var_264, var_271);
    }
    var_273 = wp::where(var_266, var_272, var_264);
    // if k > j:                                                                              <L 21>
    var_275 = (var_274 > var_254);
    if (var_275) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_276 = wp::mul(var_274, var_7);
        var_277 = wp::add(var_276, var_254);
        var_278 = wp::extract(var_a, var_277);
        var_279 = wp::extract(var_1, var_274);
        var_280 = wp::mul(var_278, var_279);
        var_281 = wp::sub(var_273, var_280);
    }
    var_282 = wp::where(var_275, var_281, var_273);
    // if k > j:                                                                              <L 21>
    var_284 = (var_283 > var_254);
    if (var_284) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_285 = wp::mul(var_283, var_7);
        var_286 = wp::add(var_285, var_254);
        var_287 = wp::extract(var_a, var_286);
        var_288 = wp::extract(var_1, var_283);
        var_289 = wp::mul(var_287, var_288);
        var_290 = wp::sub(var_282, var_289);
    }
    var_291 = wp::where(var_284, var_290, var_282);
    // if k > j:                                                                              <L 21>
    var_293 = (var_292 > var_254);
    if (var_293) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_294 = wp::mul(var_292, var_7);
        var_295 = wp::add(var_294, var_254);
        var_296 = wp::extract(var_a, var_295);
        var_297 = wp::extract(var_1, var_292);
        var_298 = wp::mul(var_296, var_297);
        var_299 = wp::sub(var_291, var_298);
    }
    var_300 = wp::where(var_293, var_299, var_291);
    // if k > j:                                                                              <L 21>
    var_302 = (var_301 > var_254);
    if (var_302) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_303 = wp::mul(var_301, var_7);
        var_304 = wp::add(var_303, var_254);
        var_305 = wp::extract(var_a, var_304);
        var_306 = wp::extract(var_1, var_301);
        var_307 = wp::mul(var_305, var_306);
        var_308 = wp::sub(var_300, var_307);
    }
    var_309 = wp::where(var_302, var_308, var_300);
    // x[j] = v                                                                               <L 23>
    wp::assign_inplace(var_1, var_254, var_309);
    // j = UNKNOWNS - 1 - step                                                                <L 18>
    var_312 = wp::sub(var_7, var_311);
    var_313 = wp::sub(var_312, var_310);
    // v = x[j]                                                                               <L 19>
    var_314 = wp::extract(var_1, var_313);
    // for k in range(6):                                                                     <L 20>
    // if k > j:                                                                              <L 21>
    var_316 = (var_315 > var_313);
    if (var_316) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_317 = wp::mul(var_315, var_7);
        var_318 = wp::add(var_317, var_313);
        var_319 = wp::extract(var_a, var_318);
        var_320 = wp::extract(var_1, var_315);
        var_321 = wp::mul(var_319, var_320);
        var_322 = wp::sub(var_314, var_321);
    }
    var_323 = wp::where(var_316, var_322, var_314);
    // if k > j:                                                                              <L 21>
    var_325 = (var_324 > var_313);
    if (var_325) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_326 = wp::mul(var_324, var_7);
        var_327 = wp::add(var_326, var_313);
        var_328 = wp::extract(var_a, var_327);
        var_329 = wp::extract(var_1, var_324);
        var_330 = wp::mul(var_328, var_329);
        var_331 = wp::sub(var_323, var_330);
    }
    var_332 = wp::where(var_325, var_331, var_323);
    // if k > j:                                                                              <L 21>
    var_334 = (var_333 > var_313);
    if (var_334) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_335 = wp::mul(var_333, var_7);
        var_336 = wp::add(var_335, var_313);
        var_337 = wp::extract(var_a, var_336);
        var_338 = wp::extract(var_1, var_333);
        var_339 = wp::mul(var_337, var_338);
        var_340 = wp::sub(var_332, var_339);
    }
    var_341 = wp::where(var_334, var_340, var_332);
    // if k > j:                                                                              <L 21>
    var_343 = (var_342 > var_313);
    if (var_343) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_344 = wp::mul(var_342, var_7);
        var_345 = wp::add(var_344, var_313);
        var_346 = wp::extract(var_a, var_345);
        var_347 = wp::extract(var_1, var_342);
        var_348 = wp::mul(var_346, var_347);
        var_349 = wp::sub(var_341, var_348);
    }
    var_350 = wp::where(var_343, var_349, var_341);
    // if k > j:                                                                              <L 21>
    var_352 = (var_351 > var_313);
    if (var_352) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_353 = wp::mul(var_351, var_7);
        var_354 = wp::add(var_353, var_313);
        var_355 = wp::extract(var_a, var_354);
        var_356 = wp::extract(var_1, var_351);
        var_357 = wp::mul(var_355, var_356);
        var_358 = wp::sub(var_350, var_357);
    }
    var_359 = wp::where(var_352, var_358, var_350);
    // if k > j:                                                                              <L 21>
    var_361 = (var_360 > var_313);
    if (var_361) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_362 = wp::mul(var_360, var_7);
        var_363 = wp::add(var_362, var_313);
        var_364 = wp::extract(var_a, var_363);
        var_365 = wp::extract(var_1, var_360);
        var_366 = wp::mul(var_364, var_365);
        var_367 = wp::sub(var_359, var_366);
    }
    var_368 = wp::where(var_361, var_367, var_359);
    // x[j] = v                                                                               <L 23>
    wp::assign_inplace(var_1, var_313, var_368);
    // j = UNKNOWNS - 1 - step                                                                <L 18>
    var_371 = wp::sub(var_7, var_370);
    var_372 = wp::sub(var_371, var_369);
    // v = x[j]                                                                               <L 19>
    var_373 = wp::extract(var_1, var_372);
    // for k in range(6):                                                                     <L 20>
    // if k > j:                                                                              <L 21>
    var_375 = (var_374 > var_372);
    if (var_375) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_376 = wp::mul(var_374, var_7);
        var_377 = wp::add(var_376, var_372);
        var_378 = wp::extract(var_a, var_377);
        var_379 = wp::extract(var_1, var_374);
        var_380 = wp::mul(var_378, var_379);
        var_381 = wp::sub(var_373, var_380);
    }
    var_382 = wp::where(var_375, var_381, var_373);
    // if k > j:                                                                              <L 21>
    var_384 = (var_383 > var_372);
    if (var_384) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_385 = wp::mul(var_383, var_7);
        var_386 = wp::add(var_385, var_372);
        var_387 = wp::extract(var_a, var_386);
        var_388 = wp::extract(var_1, var_383);
        var_389 = wp::mul(var_387, var_388);
        var_390 = wp::sub(var_382, var_389);
    }
    var_391 = wp::where(var_384, var_390, var_382);
    // if k > j:                                                                              <L 21>
    var_393 = (var_392 > var_372);
    if (var_393) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_394 = wp::mul(var_392, var_7);
        var_395 = wp::add(var_394, var_372);
        var_396 = wp::extract(var_a, var_395);
        var_397 = wp::extract(var_1, var_392);
        var_398 = wp::mul(var_396, var_397);
        var_399 = wp::sub(var_391, var_398);
    }
    var_400 = wp::where(var_393, var_399, var_391);
    // if k > j:                                                                              <L 21>
    var_402 = (var_401 > var_372);
    if (var_402) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_403 = wp::mul(var_401, var_7);
        var_404 = wp::add(var_403, var_372);
        var_405 = wp::extract(var_a, var_404);
        var_406 = wp::extract(var_1, var_401);
        var_407 = wp::mul(var_405, var_406);
        var_408 = wp::sub(var_400, var_407);
    }
    var_409 = wp::where(var_402, var_408, var_400);
    // if k > j:                                                                              <L 21>
    var_411 = (var_410 > var_372);
    if (var_411) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_412 = wp::mul(var_410, var_7);
        var_413 = wp::add(var_412, var_372);
        var_414 = wp::extract(var_a, var_413);
        var_415 = wp::extract(var_1, var_410);
        var_416 = wp::mul(var_414, var_415);
        var_417 = wp::sub(var_409, var_416);
    }
    var_418 = wp::where(var_411, var_417, var_409);
    // if k > j:                                                                              <L 21>
    var_420 = (var_419 > var_372);
    if (var_420) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_421 = wp::mul(var_419, var_7);
        var_422 = wp::add(var_421, var_372);
        var_423 = wp::extract(var_a, var_422);
        var_424 = wp::extract(var_1, var_419);
        var_425 = wp::mul(var_423, var_424);
        var_426 = wp::sub(var_418, var_425);
    }
    var_427 = wp::where(var_420, var_426, var_418);
    // x[j] = v                                                                               <L 23>
    wp::assign_inplace(var_1, var_372, var_427);
    // j = UNKNOWNS - 1 - step                                                                <L 18>
    var_430 = wp::sub(var_7, var_429);
    var_431 = wp::sub(var_430, var_428);
    // v = x[j]                                                                               <L 19>
    var_432 = wp::extract(var_1, var_431);
    // for k in range(6):                                                                     <L 20>
    // if k > j:                                                                              <L 21>
    var_434 = (var_433 > var_431);
    if (var_434) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_435 = wp::mul(var_433, var_7);
        var_436 = wp::add(var_435, var_431);
        var_437 = wp::extract(var_a, var_436);
        var_438 = wp::extract(var_1, var_433);
        var_439 = wp::mul(var_437, var_438);
        var_440 = wp::sub(var_432, var_439);
    }
    var_441 = wp::where(var_434, var_440, var_432);
    // if k > j:                                                                              <L 21>
    var_443 = (var_442 > var_431);
    if (var_443) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_444 = wp::mul(var_442, var_7);
        var_445 = wp::add(var_444, var_431);
        var_446 = wp::extract(var_a, var_445);
        var_447 = wp::extract(var_1, var_442);
        var_448 = wp::mul(var_446, var_447);
        var_449 = wp::sub(var_441, var_448);
    }
    var_450 = wp::where(var_443, var_449, var_441);
    // if k > j:                                                                              <L 21>
    var_452 = (var_451 > var_431);
    if (var_452) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_453 = wp::mul(var_451, var_7);
        var_454 = wp::add(var_453, var_431);
        var_455 = wp::extract(var_a, var_454);
        var_456 = wp::extract(var_1, var_451);
        var_457 = wp::mul(var_455, var_456);
        var_458 = wp::sub(var_450, var_457);
    }
    var_459 = wp::where(var_452, var_458, var_450);
    // if k > j:                                                                              <L 21>
    var_461 = (var_460 > var_431);
    if (var_461) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_462 = wp::mul(var_460, var_7);
        var_463 = wp::add(var_462, var_431);
        var_464 = wp::extract(var_a, var_463);
        var_465 = wp::extract(var_1, var_460);
        var_466 = wp::mul(var_464, var_465);
        var_467 = wp::sub(var_459, var_466);
    }
    var_468 = wp::where(var_461, var_467, var_459);
    // if k > j:                                                                              <L 21>
    var_470 = (var_469 > var_431);
    if (var_470) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_471 = wp::mul(var_469, var_7);
        var_472 = wp::add(var_471, var_431);
        var_473 = wp::extract(var_a, var_472);
        var_474 = wp::extract(var_1, var_469);
        var_475 = wp::mul(var_473, var_474);
        var_476 = wp::sub(var_468, var_475);
    }
    var_477 = wp::where(var_470, var_476, var_468);
    // if k > j:                                                                              <L 21>
    var_479 = (var_478 > var_431);
    if (var_479) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_480 = wp::mul(var_478, var_7);
        var_481 = wp::add(var_480, var_431);
        var_482 = wp::extract(var_a, var_481);
        var_483 = wp::extract(var_1, var_478);
        var_484 = wp::mul(var_482, var_483);
        var_485 = wp::sub(var_477, var_484);
    }
    var_486 = wp::where(var_479, var_485, var_477);
    // x[j] = v                                                                               <L 23>
    wp::assign_inplace(var_1, var_431, var_486);
    // j = UNKNOWNS - 1 - step                                                                <L 18>
    var_489 = wp::sub(var_7, var_488);
    var_490 = wp::sub(var_489, var_487);
    // v = x[j]                                                                               <L 19>
    var_491 = wp::extract(var_1, var_490);
    // for k in range(6):                                                                     <L 20>
    // if k > j:                                                                              <L 21>
    var_493 = (var_492 > var_490);
    if (var_493) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_494 = wp::mul(var_492, var_7);
        var_495 = wp::add(var_494, var_490);
        var_496 = wp::extract(var_a, var_495);
        var_497 = wp::extract(var_1, var_492);
        var_498 = wp::mul(var_496, var_497);
        var_499 = wp::sub(var_491, var_498);
    }
    var_500 = wp::where(var_493, var_499, var_491);
    // if k > j:                                                                              <L 21>
    var_502 = (var_501 > var_490);
    if (var_502) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_503 = wp::mul(var_501, var_7);
        var_504 = wp::add(var_503, var_490);
        var_505 = wp::extract(var_a, var_504);
        var_506 = wp::extract(var_1, var_501);
        var_507 = wp::mul(var_505, var_506);
        var_508 = wp::sub(var_500, var_507);
    }
    var_509 = wp::where(var_502, var_508, var_500);
    // if k > j:                                                                              <L 21>
    var_511 = (var_510 > var_490);
    if (var_511) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_512 = wp::mul(var_510, var_7);
        var_513 = wp::add(var_512, var_490);
        var_514 = wp::extract(var_a, var_513);
        var_515 = wp::extract(var_1, var_510);
        var_516 = wp::mul(var_514, var_515);
        var_517 = wp::sub(var_509, var_516);
    }
    var_518 = wp::where(var_511, var_517, var_509);
    // if k > j:                                                                              <L 21>
    var_520 = (var_519 > var_490);
    if (var_520) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_521 = wp::mul(var_519, var_7);
        var_522 = wp::add(var_521, var_490);
        var_523 = wp::extract(var_a, var_522);
        var_524 = wp::extract(var_1, var_519);
        var_525 = wp::mul(var_523, var_524);
        var_526 = wp::sub(var_518, var_525);
    }
    var_527 = wp::where(var_520, var_526, var_518);
    // if k > j:                                                                              <L 21>
    var_529 = (var_528 > var_490);
    if (var_529) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_530 = wp::mul(var_528, var_7);
        var_531 = wp::add(var_530, var_490);
        var_532 = wp::extract(var_a, var_531);
        var_533 = wp::extract(var_1, var_528);
        var_534 = wp::mul(var_532, var_533);
        var_535 = wp::sub(var_527, var_534);
    }
    var_536 = wp::where(var_529, var_535, var_527);
    // if k > j:                                                                              <L 21>
    var_538 = (var_537 > var_490);
    if (var_538) {
        // v -= a[k * UNKNOWNS + j] * x[k]                                                    <L 22>
        var_539 = wp::mul(var_537, var_7);
        var_540 = wp::add(var_539, var_490);
        var_541 = wp::extract(var_a, var_540);
        var_542 = wp::extract(var_1, var_537);
        var_543 = wp::mul(var_541, var_542);
        var_544 = wp::sub(var_536, var_543);
    }
    var_545 = wp::where(var_538, var_544, var_536);
    // x[j] = v                                                                               <L 23>
    wp::assign_inplace(var_1, var_490, var_545);
    // return x                                                                               <L 24>
    return var_1;
}


// /work/main/src/pointloom/kernels/algebra/rigid_solve.py:244
static CUDA_CALLABLE wp::vec_t<6, wp::float64> solve_system_0(
    wp::vec_t<21, wp::float64> var_h,
    wp::vec_t<6, wp::float64> var_b)
{
    //---------
    // primal vars
    wp::vec_t<36, wp::float64> var_0;
    wp::vec_t<6, wp::float64> var_1;
    //---------
    // forward
    // def solve_system(h: triangle, b: vec6d) -> vec6d:                                      <L 245>
    // return solve_factored(factor_system(h), b)                                             <L 247>
    var_0 = factor_system_0(var_h);
    var_1 = solve_factored_0(var_0, var_b);
    return var_1;
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


// <pointloom.kernels.algebra.matrices.multiply44>:1
static CUDA_CALLABLE wp::mat_t<4, 4, wp::float64> multiply44_0(
    wp::mat_t<4, 4, wp::float64> var_a,
    wp::mat_t<4, 4, wp::float64> var_b)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::mat_t<4, 4, wp::float64> var_1;
    const wp::int32 var_2 = 0;
    const wp::int32 var_3 = 0;
    const wp::int32 var_4 = 0;
    wp::float64 var_5;
    const wp::int32 var_6 = 0;
    wp::float64 var_7;
    wp::float64 var_8;
    const wp::int32 var_9 = 1;
    wp::float64 var_10;
    const wp::int32 var_11 = 1;
    wp::float64 var_12;
    wp::float64 var_13;
    wp::float64 var_14;
    const wp::int32 var_15 = 2;
    wp::float64 var_16;
    const wp::int32 var_17 = 2;
    wp::float64 var_18;
    wp::float64 var_19;
    wp::float64 var_20;
    const wp::int32 var_21 = 3;
    wp::float64 var_22;
    const wp::int32 var_23 = 3;
    wp::float64 var_24;
    wp::float64 var_25;
    wp::float64 var_26;
    const wp::int32 var_27 = 1;
    const wp::int32 var_28 = 0;
    wp::float64 var_29;
    const wp::int32 var_30 = 0;
    wp::float64 var_31;
    wp::float64 var_32;
    const wp::int32 var_33 = 1;
    wp::float64 var_34;
    const wp::int32 var_35 = 1;
    wp::float64 var_36;
    wp::float64 var_37;
    wp::float64 var_38;
    const wp::int32 var_39 = 2;
    wp::float64 var_40;
    const wp::int32 var_41 = 2;
    wp::float64 var_42;
    wp::float64 var_43;
    wp::float64 var_44;
    const wp::int32 var_45 = 3;
    wp::float64 var_46;
    const wp::int32 var_47 = 3;
    wp::float64 var_48;
    wp::float64 var_49;
    wp::float64 var_50;
    const wp::int32 var_51 = 2;
    const wp::int32 var_52 = 0;
    wp::float64 var_53;
    const wp::int32 var_54 = 0;
    wp::float64 var_55;
    wp::float64 var_56;
    const wp::int32 var_57 = 1;
    wp::float64 var_58;
    const wp::int32 var_59 = 1;
    wp::float64 var_60;
    wp::float64 var_61;
    wp::float64 var_62;
    const wp::int32 var_63 = 2;
    wp::float64 var_64;
    const wp::int32 var_65 = 2;
    wp::float64 var_66;
    wp::float64 var_67;
    wp::float64 var_68;
    const wp::int32 var_69 = 3;
    wp::float64 var_70;
    const wp::int32 var_71 = 3;
    wp::float64 var_72;
    wp::float64 var_73;
    wp::float64 var_74;
    const wp::int32 var_75 = 3;
    const wp::int32 var_76 = 0;
    wp::float64 var_77;
    const wp::int32 var_78 = 0;
    wp::float64 var_79;
    wp::float64 var_80;
    const wp::int32 var_81 = 1;
    wp::float64 var_82;
    const wp::int32 var_83 = 1;
    wp::float64 var_84;
    wp::float64 var_85;
    wp::float64 var_86;
    const wp::int32 var_87 = 2;
    wp::float64 var_88;
    const wp::int32 var_89 = 2;
    wp::float64 var_90;
    wp::float64 var_91;
    wp::float64 var_92;
    const wp::int32 var_93 = 3;
    wp::float64 var_94;
    const wp::int32 var_95 = 3;
    wp::float64 var_96;
    wp::float64 var_97;
    wp::float64 var_98;
    const wp::int32 var_99 = 1;
    const wp::int32 var_100 = 0;
    const wp::int32 var_101 = 0;
    wp::float64 var_102;
    const wp::int32 var_103 = 0;
    wp::float64 var_104;
    wp::float64 var_105;
    const wp::int32 var_106 = 1;
    wp::float64 var_107;
    const wp::int32 var_108 = 1;
    wp::float64 var_109;
    wp::float64 var_110;
    wp::float64 var_111;
    const wp::int32 var_112 = 2;
    wp::float64 var_113;
    const wp::int32 var_114 = 2;
    wp::float64 var_115;
    wp::float64 var_116;
    wp::float64 var_117;
    const wp::int32 var_118 = 3;
    wp::float64 var_119;
    const wp::int32 var_120 = 3;
    wp::float64 var_121;
    wp::float64 var_122;
    wp::float64 var_123;
    const wp::int32 var_124 = 1;
    const wp::int32 var_125 = 0;
    wp::float64 var_126;
    const wp::int32 var_127 = 0;
    wp::float64 var_128;
    wp::float64 var_129;
    const wp::int32 var_130 = 1;
    wp::float64 var_131;
    const wp::int32 var_132 = 1;
    wp::float64 var_133;
    wp::float64 var_134;
    wp::float64 var_135;
    const wp::int32 var_136 = 2;
    wp::float64 var_137;
    const wp::int32 var_138 = 2;
    wp::float64 var_139;
    wp::float64 var_140;
    wp::float64 var_141;
    const wp::int32 var_142 = 3;
    wp::float64 var_143;
    const wp::int32 var_144 = 3;
    wp::float64 var_145;
    wp::float64 var_146;
    wp::float64 var_147;
    const wp::int32 var_148 = 2;
    const wp::int32 var_149 = 0;
    wp::float64 var_150;
    const wp::int32 var_151 = 0;
    wp::float64 var_152;
    wp::float64 var_153;
    const wp::int32 var_154 = 1;
    wp::float64 var_155;
    const wp::int32 var_156 = 1;
    wp::float64 var_157;
    wp::float64 var_158;
    wp::float64 var_159;
    const wp::int32 var_160 = 2;
    wp::float64 var_161;
    const wp::int32 var_162 = 2;
    wp::float64 var_163;
    wp::float64 var_164;
    wp::float64 var_165;
    const wp::int32 var_166 = 3;
    wp::float64 var_167;
    const wp::int32 var_168 = 3;
    wp::float64 var_169;
    wp::float64 var_170;
    wp::float64 var_171;
    const wp::int32 var_172 = 3;
    const wp::int32 var_173 = 0;
    wp::float64 var_174;
    const wp::int32 var_175 = 0;
    wp::float64 var_176;
    wp::float64 var_177;
    const wp::int32 var_178 = 1;
    wp::float64 var_179;
    const wp::int32 var_180 = 1;
    wp::float64 var_181;
    wp::float64 var_182;
    wp::float64 var_183;
    const wp::int32 var_184 = 2;
    wp::float64 var_185;
    const wp::int32 var_186 = 2;
    wp::float64 var_187;
    wp::float64 var_188;
    wp::float64 var_189;
    const wp::int32 var_190 = 3;
    wp::float64 var_191;
    const wp::int32 var_192 = 3;
    wp::float64 var_193;
    wp::float64 var_194;
    wp::float64 var_195;
    const wp::int32 var_196 = 2;
    const wp::int32 var_197 = 0;
    const wp::int32 var_198 = 0;
    wp::float64 var_199;
    const wp::int32 var_200 = 0;
    wp::float64 var_201;
    wp::float64 var_202;
    const wp::int32 var_203 = 1;
    wp::float64 var_204;
    const wp::int32 var_205 = 1;
    wp::float64 var_206;
    wp::float64 var_207;
    wp::float64 var_208;
    const wp::int32 var_209 = 2;
    wp::float64 var_210;
    const wp::int32 var_211 = 2;
    wp::float64 var_212;
    wp::float64 var_213;
    wp::float64 var_214;
    const wp::int32 var_215 = 3;
    wp::float64 var_216;
    const wp::int32 var_217 = 3;
    wp::float64 var_218;
    wp::float64 var_219;
    wp::float64 var_220;
    const wp::int32 var_221 = 1;
    const wp::int32 var_222 = 0;
    wp::float64 var_223;
    const wp::int32 var_224 = 0;
    wp::float64 var_225;
    wp::float64 var_226;
    const wp::int32 var_227 = 1;
    wp::float64 var_228;
    const wp::int32 var_229 = 1;
    wp::float64 var_230;
    wp::float64 var_231;
    wp::float64 var_232;
    const wp::int32 var_233 = 2;
    wp::float64 var_234;
    const wp::int32 var_235 = 2;
    wp::float64 var_236;
    wp::float64 var_237;
    wp::float64 var_238;
    const wp::int32 var_239 = 3;
    wp::float64 var_240;
    const wp::int32 var_241 = 3;
    wp::float64 var_242;
    wp::float64 var_243;
    wp::float64 var_244;
    const wp::int32 var_245 = 2;
    const wp::int32 var_246 = 0;
    wp::float64 var_247;
    const wp::int32 var_248 = 0;
    wp::float64 var_249;
    wp::float64 var_250;
    const wp::int32 var_251 = 1;
    wp::float64 var_252;
    const wp::int32 var_253 = 1;
    wp::float64 var_254;
    wp::float64 var_255;
    wp::float64 var_256;
    const wp::int32 var_257 = 2;
    wp::float64 var_258;
    const wp::int32 var_259 = 2;
    wp::float64 var_260;
    wp::float64 var_261;
    wp::float64 var_262;
    const wp::int32 var_263 = 3;
    wp::float64 var_264;
    const wp::int32 var_265 = 3;
    wp::float64 var_266;
    wp::float64 var_267;
    wp::float64 var_268;
    const wp::int32 var_269 = 3;
    const wp::int32 var_270 = 0;
    wp::float64 var_271;
    const wp::int32 var_272 = 0;
    wp::float64 var_273;
    wp::float64 var_274;
    const wp::int32 var_275 = 1;
    wp::float64 var_276;
    const wp::int32 var_277 = 1;
    wp::float64 var_278;
    wp::float64 var_279;
    wp::float64 var_280;
    const wp::int32 var_281 = 2;
    wp::float64 var_282;
    const wp::int32 var_283 = 2;
    wp::float64 var_284;
    wp::float64 var_285;
    wp::float64 var_286;
    const wp::int32 var_287 = 3;
    wp::float64 var_288;
    const wp::int32 var_289 = 3;
    wp::float64 var_290;
    wp::float64 var_291;
    wp::float64 var_292;
    const wp::int32 var_293 = 3;
    const wp::int32 var_294 = 0;
    const wp::int32 var_295 = 0;
    wp::float64 var_296;
    const wp::int32 var_297 = 0;
    wp::float64 var_298;
    wp::float64 var_299;
    const wp::int32 var_300 = 1;
    wp::float64 var_301;
    const wp::int32 var_302 = 1;
    wp::float64 var_303;
    wp::float64 var_304;
    wp::float64 var_305;
    const wp::int32 var_306 = 2;
    wp::float64 var_307;
    const wp::int32 var_308 = 2;
    wp::float64 var_309;
    wp::float64 var_310;
    wp::float64 var_311;
    const wp::int32 var_312 = 3;
    wp::float64 var_313;
    const wp::int32 var_314 = 3;
    wp::float64 var_315;
    wp::float64 var_316;
    wp::float64 var_317;
    const wp::int32 var_318 = 1;
    const wp::int32 var_319 = 0;
    wp::float64 var_320;
    const wp::int32 var_321 = 0;
    wp::float64 var_322;
    wp::float64 var_323;
    const wp::int32 var_324 = 1;
    wp::float64 var_325;
    const wp::int32 var_326 = 1;
    wp::float64 var_327;
    wp::float64 var_328;
    wp::float64 var_329;
    const wp::int32 var_330 = 2;
    wp::float64 var_331;
    const wp::int32 var_332 = 2;
    wp::float64 var_333;
    wp::float64 var_334;
    wp::float64 var_335;
    const wp::int32 var_336 = 3;
    wp::float64 var_337;
    const wp::int32 var_338 = 3;
    wp::float64 var_339;
    wp::float64 var_340;
    wp::float64 var_341;
    const wp::int32 var_342 = 2;
    const wp::int32 var_343 = 0;
    wp::float64 var_344;
    const wp::int32 var_345 = 0;
    wp::float64 var_346;
    wp::float64 var_347;
    const wp::int32 var_348 = 1;
    wp::float64 var_349;
    const wp::int32 var_350 = 1;
    wp::float64 var_351;
    wp::float64 var_352;
    wp::float64 var_353;
    const wp::int32 var_354 = 2;
    wp::float64 var_355;
    const wp::int32 var_356 = 2;
    wp::float64 var_357;
    wp::float64 var_358;
    wp::float64 var_359;
    const wp::int32 var_360 = 3;
    wp::float64 var_361;
    const wp::int32 var_362 = 3;
    wp::float64 var_363;
    wp::float64 var_364;
    wp::float64 var_365;
    const wp::int32 var_366 = 3;
    const wp::int32 var_367 = 0;
    wp::float64 var_368;
    const wp::int32 var_369 = 0;
    wp::float64 var_370;
    wp::float64 var_371;
    const wp::int32 var_372 = 1;
    wp::float64 var_373;
    const wp::int32 var_374 = 1;
    wp::float64 var_375;
    wp::float64 var_376;
    wp::float64 var_377;
    const wp::int32 var_378 = 2;
    wp::float64 var_379;
    const wp::int32 var_380 = 2;
    wp::float64 var_381;
    wp::float64 var_382;
    wp::float64 var_383;
    const wp::int32 var_384 = 3;
    wp::float64 var_385;
    const wp::int32 var_386 = 3;
    wp::float64 var_387;
    wp::float64 var_388;
    wp::float64 var_389;
    //---------
    // forward
    // def multiply44(a, b):                                                                  <L 1>
    // product = mat44d(float64(0.0))                                                         <L 2>
    var_0 = 0.0;
    var_1 = wp::mat_t<4, 4, wp::float64>(var_0);
    // for row in range(4):                                                                   <L 3>
    // for column in range(4):                                                                <L 4>
    // total = a[row, 0] * b[0, column] + a[row, 1] * b[1, column]                            <L 5>
    var_5 = wp::extract(var_a, var_2, var_4);
    var_7 = wp::extract(var_b, var_6, var_3);
    var_8 = wp::mul(var_5, var_7);
    var_10 = wp::extract(var_a, var_2, var_9);
    var_12 = wp::extract(var_b, var_11, var_3);
    var_13 = wp::mul(var_10, var_12);
    var_14 = wp::add(var_8, var_13);
    // product[row, column] = total + a[row, 2] * b[2, column] + a[row, 3] * b[3, column]       <L 6>
    var_16 = wp::extract(var_a, var_2, var_15);
    var_18 = wp::extract(var_b, var_17, var_3);
    var_19 = wp::mul(var_16, var_18);
    var_20 = wp::add(var_14, var_19);
    var_22 = wp::extract(var_a, var_2, var_21);
    var_24 = wp::extract(var_b, var_23, var_3);
    var_25 = wp::mul(var_22, var_24);
    var_26 = wp::add(var_20, var_25);
    wp::assign_inplace(var_1, var_2, var_3, var_26);
    // total = a[row, 0] * b[0, column] + a[row, 1] * b[1, column]                            <L 5>
    var_29 = wp::extract(var_a, var_2, var_28);
    var_31 = wp::extract(var_b, var_30, var_27);
    var_32 = wp::mul(var_29, var_31);
    var_34 = wp::extract(var_a, var_2, var_33);
    var_36 = wp::extract(var_b, var_35, var_27);
    var_37 = wp::mul(var_34, var_36);
    var_38 = wp::add(var_32, var_37);
    // product[row, column] = total + a[row, 2] * b[2, column] + a[row, 3] * b[3, column]       <L 6>
    var_40 = wp::extract(var_a, var_2, var_39);
    var_42 = wp::extract(var_b, var_41, var_27);
    var_43 = wp::mul(var_40, var_42);
    var_44 = wp::add(var_38, var_43);
    var_46 = wp::extract(var_a, var_2, var_45);
    var_48 = wp::extract(var_b, var_47, var_27);
    var_49 = wp::mul(var_46, var_48);
    var_50 = wp::add(var_44, var_49);
    wp::assign_inplace(var_1, var_2, var_27, var_50);
    // total = a[row, 0] * b[0, column] + a[row, 1] * b[1, column]                            <L 5>
    var_53 = wp::extract(var_a, var_2, var_52);
    var_55 = wp::extract(var_b, var_54, var_51);
    var_56 = wp::mul(var_53, var_55);
    var_58 = wp::extract(var_a, var_2, var_57);
    var_60 = wp::extract(var_b, var_59, var_51);
    var_61 = wp::mul(var_58, var_60);
    var_62 = wp::add(var_56, var_61);
    // product[row, column] = total + a[row, 2] * b[2, column] + a[row, 3] * b[3, column]       <L 6>
    var_64 = wp::extract(var_a, var_2, var_63);
    var_66 = wp::extract(var_b, var_65, var_51);
    var_67 = wp::mul(var_64, var_66);
    var_68 = wp::add(var_62, var_67);
    var_70 = wp::extract(var_a, var_2, var_69);
    var_72 = wp::extract(var_b, var_71, var_51);
    var_73 = wp::mul(var_70, var_72);
    var_74 = wp::add(var_68, var_73);
    wp::assign_inplace(var_1, var_2, var_51, var_74);
    // total = a[row, 0] * b[0, column] + a[row, 1] * b[1, column]                            <L 5>
    var_77 = wp::extract(var_a, var_2, var_76);
    var_79 = wp::extract(var_b, var_78, var_75);
    var_80 = wp::mul(var_77, var_79);
    var_82 = wp::extract(var_a, var_2, var_81);
    var_84 = wp::extract(var_b, var_83, var_75);
    var_85 = wp::mul(var_82, var_84);
    var_86 = wp::add(var_80, var_85);
    // product[row, column] = total + a[row, 2] * b[2, column] + a[row, 3] * b[3, column]       <L 6>
    var_88 = wp::extract(var_a, var_2, var_87);
    var_90 = wp::extract(var_b, var_89, var_75);
    var_91 = wp::mul(var_88, var_90);
    var_92 = wp::add(var_86, var_91);
    var_94 = wp::extract(var_a, var_2, var_93);
    var_96 = wp::extract(var_b, var_95, var_75);
    var_97 = wp::mul(var_94, var_96);
    var_98 = wp::add(var_92, var_97);
    wp::assign_inplace(var_1, var_2, var_75, var_98);
    // for column in range(4):                                                                <L 4>
    // total = a[row, 0] * b[0, column] + a[row, 1] * b[1, column]                            <L 5>
    var_102 = wp::extract(var_a, var_99, var_101);
    var_104 = wp::extract(var_b, var_103, var_100);
    var_105 = wp::mul(var_102, var_104);
    var_107 = wp::extract(var_a, var_99, var_106);
    var_109 = wp::extract(var_b, var_108, var_100);
    var_110 = wp::mul(var_107, var_109);
    var_111 = wp::add(var_105, var_110);
    // product[row, column] = total + a[row, 2] * b[2, column] + a[row, 3] * b[3, column]       <L 6>
    var_113 = wp::extract(var_a, var_99, var_112);
    var_115 = wp::extract(var_b, var_114, var_100);
    var_116 = wp::mul(var_113, var_115);
    var_117 = wp::add(var_111, var_116);
    var_119 = wp::extract(var_a, var_99, var_118);
    var_121 = wp::extract(var_b, var_120, var_100);
    var_122 = wp::mul(var_119, var_121);
    var_123 = wp::add(var_117, var_122);
    wp::assign_inplace(var_1, var_99, var_100, var_123);
    // total = a[row, 0] * b[0, column] + a[row, 1] * b[1, column]                            <L 5>
    var_126 = wp::extract(var_a, var_99, var_125);
    var_128 = wp::extract(var_b, var_127, var_124);
    var_129 = wp::mul(var_126, var_128);
    var_131 = wp::extract(var_a, var_99, var_130);
    var_133 = wp::extract(var_b, var_132, var_124);
    var_134 = wp::mul(var_131, var_133);
    var_135 = wp::add(var_129, var_134);
    // product[row, column] = total + a[row, 2] * b[2, column] + a[row, 3] * b[3, column]       <L 6>
    var_137 = wp::extract(var_a, var_99, var_136);
    var_139 = wp::extract(var_b, var_138, var_124);
    var_140 = wp::mul(var_137, var_139);
    var_141 = wp::add(var_135, var_140);
    var_143 = wp::extract(var_a, var_99, var_142);
    var_145 = wp::extract(var_b, var_144, var_124);
    var_146 = wp::mul(var_143, var_145);
    var_147 = wp::add(var_141, var_146);
    wp::assign_inplace(var_1, var_99, var_124, var_147);
    // total = a[row, 0] * b[0, column] + a[row, 1] * b[1, column]                            <L 5>
    var_150 = wp::extract(var_a, var_99, var_149);
    var_152 = wp::extract(var_b, var_151, var_148);
    var_153 = wp::mul(var_150, var_152);
    var_155 = wp::extract(var_a, var_99, var_154);
    var_157 = wp::extract(var_b, var_156, var_148);
    var_158 = wp::mul(var_155, var_157);
    var_159 = wp::add(var_153, var_158);
    // product[row, column] = total + a[row, 2] * b[2, column] + a[row, 3] * b[3, column]       <L 6>
    var_161 = wp::extract(var_a, var_99, var_160);
    var_163 = wp::extract(var_b, var_162, var_148);
    var_164 = wp::mul(var_161, var_163);
    var_165 = wp::add(var_159, var_164);
    var_167 = wp::extract(var_a, var_99, var_166);
    var_169 = wp::extract(var_b, var_168, var_148);
    var_170 = wp::mul(var_167, var_169);
    var_171 = wp::add(var_165, var_170);
    wp::assign_inplace(var_1, var_99, var_148, var_171);
    // total = a[row, 0] * b[0, column] + a[row, 1] * b[1, column]                            <L 5>
    var_174 = wp::extract(var_a, var_99, var_173);
    var_176 = wp::extract(var_b, var_175, var_172);
    var_177 = wp::mul(var_174, var_176);
    var_179 = wp::extract(var_a, var_99, var_178);
    var_181 = wp::extract(var_b, var_180, var_172);
    var_182 = wp::mul(var_179, var_181);
    var_183 = wp::add(var_177, var_182);
    // product[row, column] = total + a[row, 2] * b[2, column] + a[row, 3] * b[3, column]       <L 6>
    var_185 = wp::extract(var_a, var_99, var_184);
    var_187 = wp::extract(var_b, var_186, var_172);
    var_188 = wp::mul(var_185, var_187);
    var_189 = wp::add(var_183, var_188);
    var_191 = wp::extract(var_a, var_99, var_190);
    var_193 = wp::extract(var_b, var_192, var_172);
    var_194 = wp::mul(var_191, var_193);
    var_195 = wp::add(var_189, var_194);
    wp::assign_inplace(var_1, var_99, var_172, var_195);
    // for column in range(4):                                                                <L 4>
    // total = a[row, 0] * b[0, column] + a[row, 1] * b[1, column]                            <L 5>
    var_199 = wp::extract(var_a, var_196, var_198);
    var_201 = wp::extract(var_b, var_200, var_197);
    var_202 = wp::mul(var_199, var_201);
    var_204 = wp::extract(var_a, var_196, var_203);
    var_206 = wp::extract(var_b, var_205, var_197);
    var_207 = wp::mul(var_204, var_206);
    var_208 = wp::add(var_202, var_207);
    // product[row, column] = total + a[row, 2] * b[2, column] + a[row, 3] * b[3, column]       <L 6>
    var_210 = wp::extract(var_a, var_196, var_209);
    var_212 = wp::extract(var_b, var_211, var_197);
    var_213 = wp::mul(var_210, var_212);
    var_214 = wp::add(var_208, var_213);
    var_216 = wp::extract(var_a, var_196, var_215);
    var_218 = wp::extract(var_b, var_217, var_197);
    var_219 = wp::mul(var_216, var_218);
    var_220 = wp::add(var_214, var_219);
    wp::assign_inplace(var_1, var_196, var_197, var_220);
    // total = a[row, 0] * b[0, column] + a[row, 1] * b[1, column]                            <L 5>
    var_223 = wp::extract(var_a, var_196, var_222);
    var_225 = wp::extract(var_b, var_224, var_221);
    var_226 = wp::mul(var_223, var_225);
    var_228 = wp::extract(var_a, var_196, var_227);
    var_230 = wp::extract(var_b, var_229, var_221);
    var_231 = wp::mul(var_228, var_230);
    var_232 = wp::add(var_226, var_231);
    // product[row, column] = total + a[row, 2] * b[2, column] + a[row, 3] * b[3, column]       <L 6>
    var_234 = wp::extract(var_a, var_196, var_233);
    var_236 = wp::extract(var_b, var_235, var_221);
    var_237 = wp::mul(var_234, var_236);
    var_238 = wp::add(var_232, var_237);
    var_240 = wp::extract(var_a, var_196, var_239);
    var_242 = wp::extract(var_b, var_241, var_221);
    var_243 = wp::mul(var_240, var_242);
    var_244 = wp::add(var_238, var_243);
    wp::assign_inplace(var_1, var_196, var_221, var_244);
    // total = a[row, 0] * b[0, column] + a[row, 1] * b[1, column]                            <L 5>
    var_247 = wp::extract(var_a, var_196, var_246);
    var_249 = wp::extract(var_b, var_248, var_245);
    var_250 = wp::mul(var_247, var_249);
    var_252 = wp::extract(var_a, var_196, var_251);
    var_254 = wp::extract(var_b, var_253, var_245);
    var_255 = wp::mul(var_252, var_254);
    var_256 = wp::add(var_250, var_255);
    // product[row, column] = total + a[row, 2] * b[2, column] + a[row, 3] * b[3, column]       <L 6>
    var_258 = wp::extract(var_a, var_196, var_257);
    var_260 = wp::extract(var_b, var_259, var_245);
    var_261 = wp::mul(var_258, var_260);
    var_262 = wp::add(var_256, var_261);
    var_264 = wp::extract(var_a, var_196, var_263);
    var_266 = wp::extract(var_b, var_265, var_245);
    var_267 = wp::mul(var_264, var_266);
    var_268 = wp::add(var_262, var_267);
    wp::assign_inplace(var_1, var_196, var_245, var_268);
    // total = a[row, 0] * b[0, column] + a[row, 1] * b[1, column]                            <L 5>
    var_271 = wp::extract(var_a, var_196, var_270);
    var_273 = wp::extract(var_b, var_272, var_269);
    var_274 = wp::mul(var_271, var_273);
    var_276 = wp::extract(var_a, var_196, var_275);
    var_278 = wp::extract(var_b, var_277, var_269);
    var_279 = wp::mul(var_276, var_278);
    var_280 = wp::add(var_274, var_279);
    // product[row, column] = total + a[row, 2] * b[2, column] + a[row, 3] * b[3, column]       <L 6>
    var_282 = wp::extract(var_a, var_196, var_281);
    var_284 = wp::extract(var_b, var_283, var_269);
    var_285 = wp::mul(var_282, var_284);
    var_286 = wp::add(var_280, var_285);
    var_288 = wp::extract(var_a, var_196, var_287);
    var_290 = wp::extract(var_b, var_289, var_269);
    var_291 = wp::mul(var_288, var_290);
    var_292 = wp::add(var_286, var_291);
    wp::assign_inplace(var_1, var_196, var_269, var_292);
    // for column in range(4):                                                                <L 4>
    // total = a[row, 0] * b[0, column] + a[row, 1] * b[1, column]                            <L 5>
    var_296 = wp::extract(var_a, var_293, var_295);
    var_298 = wp::extract(var_b, var_297, var_294);
    var_299 = wp::mul(var_296, var_298);
    var_301 = wp::extract(var_a, var_293, var_300);
    var_303 = wp::extract(var_b, var_302, var_294);
    var_304 = wp::mul(var_301, var_303);
    var_305 = wp::add(var_299, var_304);
    // product[row, column] = total + a[row, 2] * b[2, column] + a[row, 3] * b[3, column]       <L 6>
    var_307 = wp::extract(var_a, var_293, var_306);
    var_309 = wp::extract(var_b, var_308, var_294);
    var_310 = wp::mul(var_307, var_309);
    var_311 = wp::add(var_305, var_310);
    var_313 = wp::extract(var_a, var_293, var_312);
    var_315 = wp::extract(var_b, var_314, var_294);
    var_316 = wp::mul(var_313, var_315);
    var_317 = wp::add(var_311, var_316);
    wp::assign_inplace(var_1, var_293, var_294, var_317);
    // total = a[row, 0] * b[0, column] + a[row, 1] * b[1, column]                            <L 5>
    var_320 = wp::extract(var_a, var_293, var_319);
    var_322 = wp::extract(var_b, var_321, var_318);
    var_323 = wp::mul(var_320, var_322);
    var_325 = wp::extract(var_a, var_293, var_324);
    var_327 = wp::extract(var_b, var_326, var_318);
    var_328 = wp::mul(var_325, var_327);
    var_329 = wp::add(var_323, var_328);
    // product[row, column] = total + a[row, 2] * b[2, column] + a[row, 3] * b[3, column]       <L 6>
    var_331 = wp::extract(var_a, var_293, var_330);
    var_333 = wp::extract(var_b, var_332, var_318);
    var_334 = wp::mul(var_331, var_333);
    var_335 = wp::add(var_329, var_334);
    var_337 = wp::extract(var_a, var_293, var_336);
    var_339 = wp::extract(var_b, var_338, var_318);
    var_340 = wp::mul(var_337, var_339);
    var_341 = wp::add(var_335, var_340);
    wp::assign_inplace(var_1, var_293, var_318, var_341);
    // total = a[row, 0] * b[0, column] + a[row, 1] * b[1, column]                            <L 5>
    var_344 = wp::extract(var_a, var_293, var_343);
    var_346 = wp::extract(var_b, var_345, var_342);
    var_347 = wp::mul(var_344, var_346);
    var_349 = wp::extract(var_a, var_293, var_348);
    var_351 = wp::extract(var_b, var_350, var_342);
    var_352 = wp::mul(var_349, var_351);
    var_353 = wp::add(var_347, var_352);
    // product[row, column] = total + a[row, 2] * b[2, column] + a[row, 3] * b[3, column]       <L 6>
    var_355 = wp::extract(var_a, var_293, var_354);
    var_357 = wp::extract(var_b, var_356, var_342);
    var_358 = wp::mul(var_355, var_357);
    var_359 = wp::add(var_353, var_358);
    var_361 = wp::extract(var_a, var_293, var_360);
    var_363 = wp::extract(var_b, var_362, var_342);
    var_364 = wp::mul(var_361, var_363);
    var_365 = wp::add(var_359, var_364);
    wp::assign_inplace(var_1, var_293, var_342, var_365);
    // total = a[row, 0] * b[0, column] + a[row, 1] * b[1, column]                            <L 5>
    var_368 = wp::extract(var_a, var_293, var_367);
    var_370 = wp::extract(var_b, var_369, var_366);
    var_371 = wp::mul(var_368, var_370);
    var_373 = wp::extract(var_a, var_293, var_372);
    var_375 = wp::extract(var_b, var_374, var_366);
    var_376 = wp::mul(var_373, var_375);
    var_377 = wp::add(var_371, var_376);
    // product[row, column] = total + a[row, 2] * b[2, column] + a[row, 3] * b[3, column]       <L 6>
    var_379 = wp::extract(var_a, var_293, var_378);
    var_381 = wp::extract(var_b, var_380, var_366);
    var_382 = wp::mul(var_379, var_381);
    var_383 = wp::add(var_377, var_382);
    var_385 = wp::extract(var_a, var_293, var_384);
    var_387 = wp::extract(var_b, var_386, var_366);
    var_388 = wp::mul(var_385, var_387);
    var_389 = wp::add(var_383, var_388);
    wp::assign_inplace(var_1, var_293, var_366, var_389);
    // return product                                                                         <L 7>
    return var_1;
}


// <pointloom.kernels.odometry.map_course.moved_by>:1
static CUDA_CALLABLE wp::mat_t<4, 4, wp::float64> moved_by_0(
    wp::vec_t<6, wp::float64> var_x,
    wp::mat_t<4, 4, wp::float64> var_pose)
{
    //---------
    // primal vars
    wp::float64 var_0;
    const wp::int32 var_1 = 0;
    wp::float64 var_2;
    wp::float64 var_3;
    const wp::int32 var_4 = 1;
    wp::float64 var_5;
    wp::float64 var_6;
    const wp::int32 var_7 = 2;
    wp::float64 var_8;
    wp::float64 var_9;
    wp::float64 var_10;
    wp::mat_t<4, 4, wp::float64> var_11;
    wp::mat_t<4, 4, wp::float64> var_12;
    const wp::int32 var_13 = 0;
    const wp::int32 var_14 = 3;
    wp::float64 var_15;
    const wp::int32 var_16 = 3;
    wp::int32 var_17;
    wp::float64 var_18;
    wp::float64 var_19;
    const wp::int32 var_20 = 3;
    const wp::int32 var_21 = 1;
    const wp::int32 var_22 = 3;
    wp::float64 var_23;
    const wp::int32 var_24 = 3;
    wp::int32 var_25;
    wp::float64 var_26;
    wp::float64 var_27;
    const wp::int32 var_28 = 3;
    const wp::int32 var_29 = 2;
    const wp::int32 var_30 = 3;
    wp::float64 var_31;
    const wp::int32 var_32 = 3;
    wp::int32 var_33;
    wp::float64 var_34;
    wp::float64 var_35;
    const wp::int32 var_36 = 3;
    //---------
    // forward
    // def moved_by(x, pose):                                                                 <L 1>
    // half = float64(0.5)                                                                    <L 2>
    var_0 = 0.5;
    // moved = multiply44(rotation_about(x[0] * half, x[1] * half, x[2] * half, float64(1.0)), pose)       <L 3>
    var_2 = wp::extract(var_x, var_1);
    var_3 = wp::mul(var_2, var_0);
    var_5 = wp::extract(var_x, var_4);
    var_6 = wp::mul(var_5, var_0);
    var_8 = wp::extract(var_x, var_7);
    var_9 = wp::mul(var_8, var_0);
    var_10 = 1.0;
    var_11 = rotation_about_0(var_3, var_6, var_9, var_10);
    var_12 = multiply44_0(var_11, var_pose);
    // for axis in range(3):                                                                  <L 4>
    // moved[axis, 3] = pose[axis, 3] + x[3 + axis]                                           <L 5>
    var_15 = wp::extract(var_pose, var_13, var_14);
    var_17 = wp::add(var_16, var_13);
    var_18 = wp::extract(var_x, var_17);
    var_19 = wp::add(var_15, var_18);
    wp::assign_inplace(var_12, var_13, var_20, var_19);
    var_23 = wp::extract(var_pose, var_21, var_22);
    var_25 = wp::add(var_24, var_21);
    var_26 = wp::extract(var_x, var_25);
    var_27 = wp::add(var_23, var_26);
    wp::assign_inplace(var_12, var_21, var_28, var_27);
    var_31 = wp::extract(var_pose, var_29, var_30);
    var_33 = wp::add(var_32, var_29);
    var_34 = wp::extract(var_x, var_33);
    var_35 = wp::add(var_31, var_34);
    wp::assign_inplace(var_12, var_29, var_36, var_35);
    // return moved                                                                           <L 6>
    return var_12;
}


// <pointloom.kernels.odometry.map_course.pose_in>:1
static CUDA_CALLABLE wp::mat_t<4, 4, wp::float64> pose_in_0(
    wp::array_t<wp::float64> var_rows,
    wp::int32 var_row)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::mat_t<4, 4, wp::float64> var_1;
    const wp::int32 var_2 = 0;
    const wp::int32 var_3 = 0;
    const wp::int32 var_4 = 4;
    wp::int32 var_5;
    wp::int32 var_6;
    wp::float64* var_7;
    wp::float64 var_8;
    wp::float64 var_9;
    const wp::int32 var_10 = 1;
    const wp::int32 var_11 = 4;
    wp::int32 var_12;
    wp::int32 var_13;
    wp::float64* var_14;
    wp::float64 var_15;
    wp::float64 var_16;
    const wp::int32 var_17 = 2;
    const wp::int32 var_18 = 4;
    wp::int32 var_19;
    wp::int32 var_20;
    wp::float64* var_21;
    wp::float64 var_22;
    wp::float64 var_23;
    const wp::int32 var_24 = 3;
    const wp::int32 var_25 = 4;
    wp::int32 var_26;
    wp::int32 var_27;
    wp::float64* var_28;
    wp::float64 var_29;
    wp::float64 var_30;
    const wp::int32 var_31 = 1;
    const wp::int32 var_32 = 0;
    const wp::int32 var_33 = 4;
    wp::int32 var_34;
    wp::int32 var_35;
    wp::float64* var_36;
    wp::float64 var_37;
    wp::float64 var_38;
    const wp::int32 var_39 = 1;
    const wp::int32 var_40 = 4;
    wp::int32 var_41;
    wp::int32 var_42;
    wp::float64* var_43;
    wp::float64 var_44;
    wp::float64 var_45;
    const wp::int32 var_46 = 2;
    const wp::int32 var_47 = 4;
    wp::int32 var_48;
    wp::int32 var_49;
    wp::float64* var_50;
    wp::float64 var_51;
    wp::float64 var_52;
    const wp::int32 var_53 = 3;
    const wp::int32 var_54 = 4;
    wp::int32 var_55;
    wp::int32 var_56;
    wp::float64* var_57;
    wp::float64 var_58;
    wp::float64 var_59;
    const wp::int32 var_60 = 2;
    const wp::int32 var_61 = 0;
    const wp::int32 var_62 = 4;
    wp::int32 var_63;
    wp::int32 var_64;
    wp::float64* var_65;
    wp::float64 var_66;
    wp::float64 var_67;
    const wp::int32 var_68 = 1;
    const wp::int32 var_69 = 4;
    wp::int32 var_70;
    wp::int32 var_71;
    wp::float64* var_72;
    wp::float64 var_73;
    wp::float64 var_74;
    const wp::int32 var_75 = 2;
    const wp::int32 var_76 = 4;
    wp::int32 var_77;
    wp::int32 var_78;
    wp::float64* var_79;
    wp::float64 var_80;
    wp::float64 var_81;
    const wp::int32 var_82 = 3;
    const wp::int32 var_83 = 4;
    wp::int32 var_84;
    wp::int32 var_85;
    wp::float64* var_86;
    wp::float64 var_87;
    wp::float64 var_88;
    const wp::int32 var_89 = 3;
    const wp::int32 var_90 = 0;
    const wp::int32 var_91 = 4;
    wp::int32 var_92;
    wp::int32 var_93;
    wp::float64* var_94;
    wp::float64 var_95;
    wp::float64 var_96;
    const wp::int32 var_97 = 1;
    const wp::int32 var_98 = 4;
    wp::int32 var_99;
    wp::int32 var_100;
    wp::float64* var_101;
    wp::float64 var_102;
    wp::float64 var_103;
    const wp::int32 var_104 = 2;
    const wp::int32 var_105 = 4;
    wp::int32 var_106;
    wp::int32 var_107;
    wp::float64* var_108;
    wp::float64 var_109;
    wp::float64 var_110;
    const wp::int32 var_111 = 3;
    const wp::int32 var_112 = 4;
    wp::int32 var_113;
    wp::int32 var_114;
    wp::float64* var_115;
    wp::float64 var_116;
    wp::float64 var_117;
    //---------
    // forward
    // def pose_in(rows, row):                                                                <L 1>
    // pose = mat44d(float64(0.0))                                                            <L 2>
    var_0 = 0.0;
    var_1 = wp::mat_t<4, 4, wp::float64>(var_0);
    // for i in range(4):                                                                     <L 3>
    // for j in range(4):                                                                     <L 4>
    // pose[i, j] = rows[row, 4 * i + j]                                                      <L 5>
    var_5 = wp::mul(var_4, var_2);
    var_6 = wp::add(var_5, var_3);
    var_7 = wp::address(var_rows, var_row, var_6);
    var_9 = wp::load(var_7);
    var_8 = wp::copy(var_9);
    wp::assign_inplace(var_1, var_2, var_3, var_8);
    var_12 = wp::mul(var_11, var_2);
    var_13 = wp::add(var_12, var_10);
    var_14 = wp::address(var_rows, var_row, var_13);
    var_16 = wp::load(var_14);
    var_15 = wp::copy(var_16);
    wp::assign_inplace(var_1, var_2, var_10, var_15);
    var_19 = wp::mul(var_18, var_2);
    var_20 = wp::add(var_19, var_17);
    var_21 = wp::address(var_rows, var_row, var_20);
    var_23 = wp::load(var_21);
    var_22 = wp::copy(var_23);
    wp::assign_inplace(var_1, var_2, var_17, var_22);
    var_26 = wp::mul(var_25, var_2);
    var_27 = wp::add(var_26, var_24);
    var_28 = wp::address(var_rows, var_row, var_27);
    var_30 = wp::load(var_28);
    var_29 = wp::copy(var_30);
    wp::assign_inplace(var_1, var_2, var_24, var_29);
    // for j in range(4):                                                                     <L 4>
    // pose[i, j] = rows[row, 4 * i + j]                                                      <L 5>
    var_34 = wp::mul(var_33, var_31);
    var_35 = wp::add(var_34, var_32);
    var_36 = wp::address(var_rows, var_row, var_35);
    var_38 = wp::load(var_36);
    var_37 = wp::copy(var_38);
    wp::assign_inplace(var_1, var_31, var_32, var_37);
    var_41 = wp::mul(var_40, var_31);
    var_42 = wp::add(var_41, var_39);
    var_43 = wp::address(var_rows, var_row, var_42);
    var_45 = wp::load(var_43);
    var_44 = wp::copy(var_45);
    wp::assign_inplace(var_1, var_31, var_39, var_44);
    var_48 = wp::mul(var_47, var_31);
    var_49 = wp::add(var_48, var_46);
    var_50 = wp::address(var_rows, var_row, var_49);
    var_52 = wp::load(var_50);
    var_51 = wp::copy(var_52);
    wp::assign_inplace(var_1, var_31, var_46, var_51);
    var_55 = wp::mul(var_54, var_31);
    var_56 = wp::add(var_55, var_53);
    var_57 = wp::address(var_rows, var_row, var_56);
    var_59 = wp::load(var_57);
    var_58 = wp::copy(var_59);
    wp::assign_inplace(var_1, var_31, var_53, var_58);
    // for j in range(4):                                                                     <L 4>
    // pose[i, j] = rows[row, 4 * i + j]                                                      <L 5>
    var_63 = wp::mul(var_62, var_60);
    var_64 = wp::add(var_63, var_61);
    var_65 = wp::address(var_rows, var_row, var_64);
    var_67 = wp::load(var_65);
    var_66 = wp::copy(var_67);
    wp::assign_inplace(var_1, var_60, var_61, var_66);
    var_70 = wp::mul(var_69, var_60);
    var_71 = wp::add(var_70, var_68);
    var_72 = wp::address(var_rows, var_row, var_71);
    var_74 = wp::load(var_72);
    var_73 = wp::copy(var_74);
    wp::assign_inplace(var_1, var_60, var_68, var_73);
    var_77 = wp::mul(var_76, var_60);
    var_78 = wp::add(var_77, var_75);
    var_79 = wp::address(var_rows, var_row, var_78);
    var_81 = wp::load(var_79);
    var_80 = wp::copy(var_81);
    wp::assign_inplace(var_1, var_60, var_75, var_80);
    var_84 = wp::mul(var_83, var_60);
    var_85 = wp::add(var_84, var_82);
    var_86 = wp::address(var_rows, var_row, var_85);
    var_88 = wp::load(var_86);
    var_87 = wp::copy(var_88);
    wp::assign_inplace(var_1, var_60, var_82, var_87);
    // for j in range(4):                                                                     <L 4>
    // pose[i, j] = rows[row, 4 * i + j]                                                      <L 5>
    var_92 = wp::mul(var_91, var_89);
    var_93 = wp::add(var_92, var_90);
    var_94 = wp::address(var_rows, var_row, var_93);
    var_96 = wp::load(var_94);
    var_95 = wp::copy(var_96);
    wp::assign_inplace(var_1, var_89, var_90, var_95);
    var_99 = wp::mul(var_98, var_89);
    var_100 = wp::add(var_99, var_97);
    var_101 = wp::address(var_rows, var_row, var_100);
    var_103 = wp::load(var_101);
    var_102 = wp::copy(var_103);
    wp::assign_inplace(var_1, var_89, var_97, var_102);
    var_106 = wp::mul(var_105, var_89);
    var_107 = wp::add(var_106, var_104);
    var_108 = wp::address(var_rows, var_row, var_107);
    var_110 = wp::load(var_108);
    var_109 = wp::copy(var_110);
    wp::assign_inplace(var_1, var_89, var_104, var_109);
    var_113 = wp::mul(var_112, var_89);
    var_114 = wp::add(var_113, var_111);
    var_115 = wp::address(var_rows, var_row, var_114);
    var_117 = wp::load(var_115);
    var_116 = wp::copy(var_117);
    wp::assign_inplace(var_1, var_89, var_111, var_116);
    // return pose                                                                            <L 6>
    return var_1;
}


// <pointloom.kernels.odometry.map_course.cost_of>:1
static CUDA_CALLABLE wp::float64 cost_of_0(
    wp::int32 var_leg,
    wp::array_t<wp::float64> var_course__orders,
    wp::array_t<wp::float64> var_course__results)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 23;
    wp::float64* var_1;
    const wp::int32 var_2 = 19;
    wp::float64* var_3;
    wp::float64 var_4;
    wp::float64 var_5;
    wp::float64 var_6;
    const wp::int32 var_7 = 2;
    wp::int32 var_8;
    wp::float64* var_9;
    wp::float64 var_10;
    wp::float64 var_11;
    wp::float64 var_12;
    wp::float64 var_13;
    wp::float64 var_14;
    bool var_15;
    const wp::int32 var_16 = 1;
    wp::int32 var_17;
    wp::float64* var_18;
    wp::float64 var_19;
    wp::float64 var_20;
    wp::float64 var_21;
    wp::float64 var_22;
    wp::float64 var_23;
    //---------
    // forward
    // def cost_of(leg, course__orders, course__results):                                     <L 1>
    // unpaired = course__orders[leg, COUNT] - course__results[leg, PAIRED]                   <L 2>
    var_1 = wp::address(var_course__orders, var_leg, var_0);
    var_3 = wp::address(var_course__results, var_leg, var_2);
    var_5 = wp::load(var_1);
    var_6 = wp::load(var_3);
    var_4 = wp::sub(var_5, var_6);
    // informative = course__results[leg, PAIRED + 2]                                         <L 3>
    var_8 = wp::add(var_2, var_7);
    var_9 = wp::address(var_course__results, var_leg, var_8);
    var_11 = wp::load(var_9);
    var_10 = wp::copy(var_11);
    // cost = float64(1.0)                                                                    <L 4>
    var_12 = 1.0;
    // if informative + unpaired > float64(0.0):                                              <L 5>
    var_13 = wp::add(var_10, var_4);
    var_14 = 0.0;
    var_15 = (var_13 > var_14);
    if (var_15) {
        // cost = (course__results[leg, PAIRED + 1] + unpaired) / (informative + unpaired)       <L 6>
        var_17 = wp::add(var_2, var_16);
        var_18 = wp::address(var_course__results, var_leg, var_17);
        var_20 = wp::load(var_18);
        var_19 = wp::add(var_20, var_4);
        var_21 = wp::add(var_10, var_4);
        var_22 = wp::div(var_19, var_21);
    }
    var_23 = wp::where(var_15, var_22, var_12);
    // return cost                                                                            <L 7>
    return var_23;
}


// <pointloom.kernels.odometry.map_course.start_of>:1
static CUDA_CALLABLE wp::mat_t<4, 4, wp::float64> start_of_0(
    wp::int32 var_leg,
    wp::array_t<wp::float64> var_course__orders,
    wp::array_t<wp::float64> var_course__results)
{
    //---------
    // primal vars
    wp::mat_t<4, 4, wp::float64> var_0;
    const wp::int32 var_1 = 25;
    wp::int32 var_2;
    const wp::int32 var_3 = 0;
    bool var_4;
    const wp::int32 var_5 = 0;
    wp::int32 var_6;
    const wp::int32 var_7 = 2;
    bool var_8;
    wp::float64 var_9;
    wp::float64 var_10;
    wp::float64 var_11;
    const wp::int32 var_12 = 1;
    wp::range_t var_13;
    wp::int32 var_14;
    const wp::int32 var_15 = 16;
    wp::float64* var_16;
    wp::float64 var_17;
    bool var_18;
    wp::float64 var_19;
    wp::float64 var_20;
    bool var_21;
    wp::float64 var_22;
    wp::int32 var_23;
    wp::int32 var_24;
    wp::float64 var_25;
    wp::int32 var_26;
    wp::float64 var_27;
    wp::mat_t<4, 4, wp::float64> var_28;
    wp::mat_t<4, 4, wp::float64> var_29;
    //---------
    // forward
    // def start_of(leg, course__orders, course__results):                                    <L 1>
    // pose = pose_in(course__orders, leg)                                                    <L 2>
    var_0 = pose_in_0(var_course__orders, var_leg);
    // start = leg_number(leg, START, course__orders)                                         <L 3>
    var_2 = leg_number_0(var_leg, var_1, var_course__orders);
    // if start != GIVEN:                                                                     <L 4>
    var_4 = (var_2 != var_3);
    if (var_4) {
        // chosen = int(0)                                                                    <L 5>
        var_6 = wp::int(var_5);
        // if start == CHEAPEST:                                                              <L 6>
        var_8 = (var_2 == var_7);
        if (var_8) {
            // min_cost = float64(INFINITY) + float64(0.0)                                    <L 7>
            var_9 = INFINITY;
            var_10 = 0.0;
            var_11 = wp::add(var_9, var_10);
            // for k in range(1, leg):                                                        <L 8>
            var_13 = wp::range(var_12, var_leg);
            start_for_0:;
                if (iter_cmp(var_13) == 0) goto end_for_0;
                var_14 = wp::iter_next(var_13);
                // if course__results[k, STATE] != float64(LOST):                             <L 9>
                var_16 = wp::address(var_course__results, var_14, var_15);
                var_17 = 3;
                var_19 = wp::load(var_16);
                var_18 = (var_19 != var_17);
                if (var_18) {
                    // cost = cost_of(k, course__orders, course__results)                     <L 10>
                    var_20 = cost_of_0(var_14, var_course__orders, var_course__results);
                    // if cost < min_cost:                                                    <L 11>
                    var_21 = (var_20 < var_11);
                    if (var_21) {
                        // min_cost = cost                                                    <L 12>
                        var_22 = wp::copy(var_20);
                        // chosen = k                                                         <L 13>
                        var_23 = wp::copy(var_14);
                    }
                    var_24 = wp::where(var_21, var_23, var_6);
                    var_25 = wp::where(var_21, var_22, var_11);
                }
                var_26 = wp::where(var_18, var_24, var_6);
                var_27 = wp::where(var_18, var_25, var_11);
                wp::assign(var_6, var_26);
                wp::assign(var_11, var_27);
                goto start_for_0;
            end_for_0:;
        }
        // pose = pose_in(course__results, chosen)                                            <L 14>
        var_28 = pose_in_0(var_course__results, var_6);
    }
    var_29 = wp::where(var_4, var_28, var_0);
    // return pose                                                                            <L 15>
    return var_29;
}


// <pointloom.kernels.odometry.map_course.end_leg>:1
static CUDA_CALLABLE void end_leg_0(
    wp::int32 var_leg,
    wp::int32 var_state,
    wp::vec_t<31, wp::float64> var_total,
    wp::array_t<wp::float64> var_course__orders,
    wp::array_t<wp::float64> var_course__results,
    wp::array_t<wp::int32> var_course__states,
    wp::array_t<wp::int32> var_course__running,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_course__poses)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::mat_t<4, 4, wp::float64>* var_1;
    wp::mat_t<4, 4, wp::float64> var_2;
    wp::mat_t<4, 4, wp::float64> var_3;
    const wp::int32 var_4 = 0;
    const wp::int32 var_5 = 0;
    wp::float64 var_6;
    const wp::int32 var_7 = 4;
    wp::int32 var_8;
    wp::int32 var_9;
    const wp::int32 var_10 = 1;
    wp::float64 var_11;
    const wp::int32 var_12 = 4;
    wp::int32 var_13;
    wp::int32 var_14;
    const wp::int32 var_15 = 2;
    wp::float64 var_16;
    const wp::int32 var_17 = 4;
    wp::int32 var_18;
    wp::int32 var_19;
    const wp::int32 var_20 = 3;
    wp::float64 var_21;
    const wp::int32 var_22 = 4;
    wp::int32 var_23;
    wp::int32 var_24;
    const wp::int32 var_25 = 27;
    wp::int32 var_26;
    wp::float64 var_27;
    const wp::int32 var_28 = 18;
    wp::int32 var_29;
    const wp::int32 var_30 = 1;
    const wp::int32 var_31 = 0;
    wp::float64 var_32;
    const wp::int32 var_33 = 4;
    wp::int32 var_34;
    wp::int32 var_35;
    const wp::int32 var_36 = 1;
    wp::float64 var_37;
    const wp::int32 var_38 = 4;
    wp::int32 var_39;
    wp::int32 var_40;
    const wp::int32 var_41 = 2;
    wp::float64 var_42;
    const wp::int32 var_43 = 4;
    wp::int32 var_44;
    wp::int32 var_45;
    const wp::int32 var_46 = 3;
    wp::float64 var_47;
    const wp::int32 var_48 = 4;
    wp::int32 var_49;
    wp::int32 var_50;
    wp::int32 var_51;
    wp::float64 var_52;
    wp::int32 var_53;
    const wp::int32 var_54 = 2;
    const wp::int32 var_55 = 0;
    wp::float64 var_56;
    const wp::int32 var_57 = 4;
    wp::int32 var_58;
    wp::int32 var_59;
    const wp::int32 var_60 = 1;
    wp::float64 var_61;
    const wp::int32 var_62 = 4;
    wp::int32 var_63;
    wp::int32 var_64;
    const wp::int32 var_65 = 2;
    wp::float64 var_66;
    const wp::int32 var_67 = 4;
    wp::int32 var_68;
    wp::int32 var_69;
    const wp::int32 var_70 = 3;
    wp::float64 var_71;
    const wp::int32 var_72 = 4;
    wp::int32 var_73;
    wp::int32 var_74;
    wp::int32 var_75;
    wp::float64 var_76;
    wp::int32 var_77;
    const wp::int32 var_78 = 3;
    const wp::int32 var_79 = 0;
    wp::float64 var_80;
    const wp::int32 var_81 = 4;
    wp::int32 var_82;
    wp::int32 var_83;
    const wp::int32 var_84 = 1;
    wp::float64 var_85;
    const wp::int32 var_86 = 4;
    wp::int32 var_87;
    wp::int32 var_88;
    const wp::int32 var_89 = 2;
    wp::float64 var_90;
    const wp::int32 var_91 = 4;
    wp::int32 var_92;
    wp::int32 var_93;
    const wp::int32 var_94 = 3;
    wp::float64 var_95;
    const wp::int32 var_96 = 4;
    wp::int32 var_97;
    wp::int32 var_98;
    wp::int32 var_99;
    wp::float64 var_100;
    wp::int32 var_101;
    wp::float64 var_102;
    const wp::int32 var_103 = 16;
    const wp::int32 var_104 = 1;
    wp::int32* var_105;
    wp::float64 var_106;
    wp::int32 var_107;
    const wp::int32 var_108 = 17;
    const wp::int32 var_109 = 1;
    wp::int32 var_110;
    const wp::int32 var_111 = 64;
    const wp::int32 var_112 = 21;
    wp::int32 var_113;
    bool var_114;
    const wp::int32 var_115 = 3;
    bool var_116;
    const wp::int32 var_117 = 26;
    wp::float64* var_118;
    wp::float64 var_119;
    bool var_120;
    wp::float64 var_121;
    wp::int32 var_122;
    wp::int32 var_123;
    bool var_124;
    const wp::int32 var_125 = 0;
    const wp::int32 var_126 = 0;
    wp::mat_t<4, 4, wp::float64> var_127;
    const wp::int32 var_128 = 0;
    const wp::int32 var_129 = 0;
    const wp::int32 var_130 = 0;
    const wp::int32 var_131 = 1;
    //---------
    // forward
    // def end_leg(leg, state, total, course__orders, course__results, course__states, course__running, course__poses):       <L 1>
    // pose = course__poses[0]                                                                <L 3>
    var_1 = wp::address(var_course__poses, var_0);
    var_3 = wp::load(var_1);
    var_2 = wp::copy(var_3);
    // for i in range(4):                                                                     <L 4>
    // for j in range(4):                                                                     <L 5>
    // course__results[leg, 4 * i + j] = pose[i, j]                                           <L 6>
    var_6 = wp::extract(var_2, var_4, var_5);
    var_8 = wp::mul(var_7, var_4);
    var_9 = wp::add(var_8, var_5);
    wp::array_store(var_course__results, var_leg, var_9, var_6);
    var_11 = wp::extract(var_2, var_4, var_10);
    var_13 = wp::mul(var_12, var_4);
    var_14 = wp::add(var_13, var_10);
    wp::array_store(var_course__results, var_leg, var_14, var_11);
    var_16 = wp::extract(var_2, var_4, var_15);
    var_18 = wp::mul(var_17, var_4);
    var_19 = wp::add(var_18, var_15);
    wp::array_store(var_course__results, var_leg, var_19, var_16);
    var_21 = wp::extract(var_2, var_4, var_20);
    var_23 = wp::mul(var_22, var_4);
    var_24 = wp::add(var_23, var_20);
    wp::array_store(var_course__results, var_leg, var_24, var_21);
    // course__results[leg, SQSUM + i] = total[SQUARES + i]                                   <L 7>
    var_26 = wp::add(var_25, var_4);
    var_27 = wp::extract(var_total, var_26);
    var_29 = wp::add(var_28, var_4);
    wp::array_store(var_course__results, var_leg, var_29, var_27);
    // for j in range(4):                                                                     <L 5>
    // course__results[leg, 4 * i + j] = pose[i, j]                                           <L 6>
    var_32 = wp::extract(var_2, var_30, var_31);
    var_34 = wp::mul(var_33, var_30);
    var_35 = wp::add(var_34, var_31);
    wp::array_store(var_course__results, var_leg, var_35, var_32);
    var_37 = wp::extract(var_2, var_30, var_36);
    var_39 = wp::mul(var_38, var_30);
    var_40 = wp::add(var_39, var_36);
    wp::array_store(var_course__results, var_leg, var_40, var_37);
    var_42 = wp::extract(var_2, var_30, var_41);
    var_44 = wp::mul(var_43, var_30);
    var_45 = wp::add(var_44, var_41);
    wp::array_store(var_course__results, var_leg, var_45, var_42);
    var_47 = wp::extract(var_2, var_30, var_46);
    var_49 = wp::mul(var_48, var_30);
    var_50 = wp::add(var_49, var_46);
    wp::array_store(var_course__results, var_leg, var_50, var_47);
    // course__results[leg, SQSUM + i] = total[SQUARES + i]                                   <L 7>
    var_51 = wp::add(var_25, var_30);
    var_52 = wp::extract(var_total, var_51);
    var_53 = wp::add(var_28, var_30);
    wp::array_store(var_course__results, var_leg, var_53, var_52);
    // for j in range(4):                                                                     <L 5>
    // course__results[leg, 4 * i + j] = pose[i, j]                                           <L 6>
    var_56 = wp::extract(var_2, var_54, var_55);
    var_58 = wp::mul(var_57, var_54);
    var_59 = wp::add(var_58, var_55);
    wp::array_store(var_course__results, var_leg, var_59, var_56);
    var_61 = wp::extract(var_2, var_54, var_60);
    var_63 = wp::mul(var_62, var_54);
    var_64 = wp::add(var_63, var_60);
    wp::array_store(var_course__results, var_leg, var_64, var_61);
    var_66 = wp::extract(var_2, var_54, var_65);
    var_68 = wp::mul(var_67, var_54);
    var_69 = wp::add(var_68, var_65);
    wp::array_store(var_course__results, var_leg, var_69, var_66);
    var_71 = wp::extract(var_2, var_54, var_70);
    var_73 = wp::mul(var_72, var_54);
    var_74 = wp::add(var_73, var_70);
    wp::array_store(var_course__results, var_leg, var_74, var_71);
    // course__results[leg, SQSUM + i] = total[SQUARES + i]                                   <L 7>
    var_75 = wp::add(var_25, var_54);
    var_76 = wp::extract(var_total, var_75);
    var_77 = wp::add(var_28, var_54);
    wp::array_store(var_course__results, var_leg, var_77, var_76);
    // for j in range(4):                                                                     <L 5>
    // course__results[leg, 4 * i + j] = pose[i, j]                                           <L 6>
    var_80 = wp::extract(var_2, var_78, var_79);
    var_82 = wp::mul(var_81, var_78);
    var_83 = wp::add(var_82, var_79);
    wp::array_store(var_course__results, var_leg, var_83, var_80);
    var_85 = wp::extract(var_2, var_78, var_84);
    var_87 = wp::mul(var_86, var_78);
    var_88 = wp::add(var_87, var_84);
    wp::array_store(var_course__results, var_leg, var_88, var_85);
    var_90 = wp::extract(var_2, var_78, var_89);
    var_92 = wp::mul(var_91, var_78);
    var_93 = wp::add(var_92, var_89);
    wp::array_store(var_course__results, var_leg, var_93, var_90);
    var_95 = wp::extract(var_2, var_78, var_94);
    var_97 = wp::mul(var_96, var_78);
    var_98 = wp::add(var_97, var_94);
    wp::array_store(var_course__results, var_leg, var_98, var_95);
    // course__results[leg, SQSUM + i] = total[SQUARES + i]                                   <L 7>
    var_99 = wp::add(var_25, var_78);
    var_100 = wp::extract(var_total, var_99);
    var_101 = wp::add(var_28, var_78);
    wp::array_store(var_course__results, var_leg, var_101, var_100);
    // course__results[leg, STATE] = float64(state)                                           <L 8>
    var_102 = wp::float64(var_state);
    wp::array_store(var_course__results, var_leg, var_103, var_102);
    // course__results[leg, ITERATIONS] = float64(course__states[1])                          <L 9>
    var_105 = wp::address(var_course__states, var_104);
    var_107 = wp::load(var_105);
    var_106 = wp::float64(var_107);
    wp::array_store(var_course__results, var_leg, var_108, var_106);
    // following = leg + 1                                                                    <L 10>
    var_110 = wp::add(var_leg, var_109);
    // count = leg_number(MAX_LEGS, LEGS, course__orders)                                     <L 11>
    var_113 = leg_number_0(var_111, var_112, var_course__orders);
    // if state == LOST and course__orders[leg, NEEDED] == float64(1.0):                      <L 12>
    var_116 = (var_state == var_115);
    var_114 = var_116;
    if (var_114) {
        var_118 = wp::address(var_course__orders, var_leg, var_117);
        var_119 = 1.0;
        var_121 = wp::load(var_118);
        var_120 = (var_121 == var_119);
        var_114 = var_114 && var_120;
    }
    if (var_114) {
        // count = following                                                                  <L 13>
        var_122 = wp::copy(var_110);
    }
    var_123 = wp::where(var_114, var_122, var_113);
    // if following == count:                                                                 <L 14>
    var_124 = (var_110 == var_123);
    if (var_124) {
        // course__running[0] = 0                                                             <L 15>
        wp::array_store(var_course__running, var_126, var_125);
    }
    if (!var_124) {
        // course__poses[0] = start_of(following, course__orders, course__results)            <L 17>
        var_127 = start_of_0(var_110, var_course__orders, var_course__results);
        wp::array_store(var_course__poses, var_128, var_127);
        // course__states[0] = following                                                      <L 18>
        wp::array_store(var_course__states, var_129, var_110);
        // course__states[1] = 0                                                              <L 19>
        wp::array_store(var_course__states, var_131, var_130);
    }
}


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


// /work/main/src/pointloom/kernels/algebra/rigid_solve.py:310
static CUDA_CALLABLE wp::vec_t<3, wp::float64> rotate_1(
    wp::mat_t<4, 4, wp::float64> var_pose,
    wp::vec_t<3, wp::float64> var_v)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    const wp::int32 var_1 = 0;
    wp::float64 var_2;
    const wp::int32 var_3 = 0;
    wp::float64 var_4;
    wp::float64 var_5;
    const wp::int32 var_6 = 0;
    const wp::int32 var_7 = 1;
    wp::float64 var_8;
    const wp::int32 var_9 = 1;
    wp::float64 var_10;
    wp::float64 var_11;
    wp::float64 var_12;
    const wp::int32 var_13 = 0;
    const wp::int32 var_14 = 2;
    wp::float64 var_15;
    const wp::int32 var_16 = 2;
    wp::float64 var_17;
    wp::float64 var_18;
    wp::float64 var_19;
    const wp::int32 var_20 = 1;
    const wp::int32 var_21 = 0;
    wp::float64 var_22;
    const wp::int32 var_23 = 0;
    wp::float64 var_24;
    wp::float64 var_25;
    const wp::int32 var_26 = 1;
    const wp::int32 var_27 = 1;
    wp::float64 var_28;
    const wp::int32 var_29 = 1;
    wp::float64 var_30;
    wp::float64 var_31;
    wp::float64 var_32;
    const wp::int32 var_33 = 1;
    const wp::int32 var_34 = 2;
    wp::float64 var_35;
    const wp::int32 var_36 = 2;
    wp::float64 var_37;
    wp::float64 var_38;
    wp::float64 var_39;
    const wp::int32 var_40 = 2;
    const wp::int32 var_41 = 0;
    wp::float64 var_42;
    const wp::int32 var_43 = 0;
    wp::float64 var_44;
    wp::float64 var_45;
    const wp::int32 var_46 = 2;
    const wp::int32 var_47 = 1;
    wp::float64 var_48;
    const wp::int32 var_49 = 1;
    wp::float64 var_50;
    wp::float64 var_51;
    wp::float64 var_52;
    const wp::int32 var_53 = 2;
    const wp::int32 var_54 = 2;
    wp::float64 var_55;
    const wp::int32 var_56 = 2;
    wp::float64 var_57;
    wp::float64 var_58;
    wp::float64 var_59;
    wp::vec_t<3, wp::float64> var_60;
    //---------
    // forward
    // def rotate(pose: mat44d, v: vec3d) -> vec3d:                                           <L 311>
    // return vec3d(                                                                          <L 312>
    // pose[0, 0] * v[0] + pose[0, 1] * v[1] + pose[0, 2] * v[2],                             <L 313>
    var_2 = wp::extract(var_pose, var_0, var_1);
    var_4 = wp::extract(var_v, var_3);
    var_5 = wp::mul(var_2, var_4);
    var_8 = wp::extract(var_pose, var_6, var_7);
    var_10 = wp::extract(var_v, var_9);
    var_11 = wp::mul(var_8, var_10);
    var_12 = wp::add(var_5, var_11);
    var_15 = wp::extract(var_pose, var_13, var_14);
    var_17 = wp::extract(var_v, var_16);
    var_18 = wp::mul(var_15, var_17);
    var_19 = wp::add(var_12, var_18);
    // pose[1, 0] * v[0] + pose[1, 1] * v[1] + pose[1, 2] * v[2],                             <L 314>
    var_22 = wp::extract(var_pose, var_20, var_21);
    var_24 = wp::extract(var_v, var_23);
    var_25 = wp::mul(var_22, var_24);
    var_28 = wp::extract(var_pose, var_26, var_27);
    var_30 = wp::extract(var_v, var_29);
    var_31 = wp::mul(var_28, var_30);
    var_32 = wp::add(var_25, var_31);
    var_35 = wp::extract(var_pose, var_33, var_34);
    var_37 = wp::extract(var_v, var_36);
    var_38 = wp::mul(var_35, var_37);
    var_39 = wp::add(var_32, var_38);
    // pose[2, 0] * v[0] + pose[2, 1] * v[1] + pose[2, 2] * v[2],                             <L 315>
    var_42 = wp::extract(var_pose, var_40, var_41);
    var_44 = wp::extract(var_v, var_43);
    var_45 = wp::mul(var_42, var_44);
    var_48 = wp::extract(var_pose, var_46, var_47);
    var_50 = wp::extract(var_v, var_49);
    var_51 = wp::mul(var_48, var_50);
    var_52 = wp::add(var_45, var_51);
    var_55 = wp::extract(var_pose, var_53, var_54);
    var_57 = wp::extract(var_v, var_56);
    var_58 = wp::mul(var_55, var_57);
    var_59 = wp::add(var_52, var_58);
    var_60 = wp::vec_t<3, wp::float64>(var_19, var_39, var_59);
    return var_60;
}


// /work/main/src/pointloom/kernels/odometry/local_cells.py:9
static CUDA_CALLABLE wp::vec_t<3, wp::int32> cell_holding_0(
    wp::vec_t<3, wp::float64> var_x,
    wp::float64 var_size)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float64 var_1;
    wp::float64 var_2;
    wp::float64 var_3;
    wp::int32 var_4;
    const wp::int32 var_5 = 1;
    wp::float64 var_6;
    wp::float64 var_7;
    wp::float64 var_8;
    wp::int32 var_9;
    const wp::int32 var_10 = 2;
    wp::float64 var_11;
    wp::float64 var_12;
    wp::float64 var_13;
    wp::int32 var_14;
    wp::vec_t<3, wp::int32> var_15;
    //---------
    // forward
    // def cell_holding(x: vec3d, size: float64) -> vec3i:                                    <L 10>
    // return vec3i(int(floor(x[0] / size)), int(floor(x[1] / size)), int(floor(x[2] / size)))       <L 11>
    var_1 = wp::extract(var_x, var_0);
    var_2 = wp::div(var_1, var_size);
    var_3 = wp::floor(var_2);
    var_4 = wp::int(var_3);
    var_6 = wp::extract(var_x, var_5);
    var_7 = wp::div(var_6, var_size);
    var_8 = wp::floor(var_7);
    var_9 = wp::int(var_8);
    var_11 = wp::extract(var_x, var_10);
    var_12 = wp::div(var_11, var_size);
    var_13 = wp::floor(var_12);
    var_14 = wp::int(var_13);
    var_15 = wp::vec_t<3, wp::int32>(var_4, var_9, var_14);
    return var_15;
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


// /work/main/src/pointloom/kernels/odometry/local_cells.py:14
static CUDA_CALLABLE wp::vec_t<3, wp::float32> offset_in_cell_0(
    wp::vec_t<3, wp::float64> var_x,
    wp::vec_t<3, wp::int32> var_cell,
    wp::float64 var_size)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    wp::float64 var_2;
    const wp::int32 var_3 = 1;
    wp::int32 var_4;
    wp::float64 var_5;
    const wp::int32 var_6 = 2;
    wp::int32 var_7;
    wp::float64 var_8;
    wp::vec_t<3, wp::float64> var_9;
    wp::vec_t<3, wp::float64> var_10;
    wp::vec_t<3, wp::float64> var_11;
    wp::vec_t<3, wp::float32> var_12;
    //---------
    // forward
    // def offset_in_cell(x: vec3d, cell: vec3i, size: float64) -> vec3:                      <L 15>
    // y = vec3d(float64(cell[0]), float64(cell[1]), float64(cell[2])) * size                 <L 17>
    var_1 = wp::extract(var_cell, var_0);
    var_2 = wp::float64(var_1);
    var_4 = wp::extract(var_cell, var_3);
    var_5 = wp::float64(var_4);
    var_7 = wp::extract(var_cell, var_6);
    var_8 = wp::float64(var_7);
    var_9 = wp::vec_t<3, wp::float64>(var_2, var_5, var_8);
    var_10 = wp::mul(var_9, var_size);
    // return narrow(x - y)                                                                   <L 18>
    var_11 = wp::sub(var_x, var_10);
    var_12 = narrow_0(var_11);
    return var_12;
}


// /work/main/src/pointloom/kernels/odometry/voxel_map_search.py:43
static CUDA_CALLABLE wp::int32 nearer_side_0(
    wp::float32 var_offset,
    wp::float32 var_size)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 0.5;
    wp::float32 var_1;
    bool var_2;
    const wp::int32 var_3 = 1;
    const wp::int32 var_4 = -1;
    wp::int32 var_5;
    //---------
    // forward
    // def nearer_side(offset: float, size: float) -> int:                                    <L 44>
    // return 1 if offset > 0.5 * size else -1                                                <L 46>
    var_1 = wp::mul(var_0, var_size);
    var_2 = (var_offset > var_1);
    if (var_2) {
    }
    if (!var_2) {
    }
    var_5 = wp::where(var_2, var_3, var_4);
    return var_5;
}


// <pointloom.kernels.odometry.voxel_map_search.side_of>:1
static CUDA_CALLABLE wp::int32 side_of_0(
    wp::int32 var_digit,
    wp::int32 var_near)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    const wp::int32 var_2 = 1;
    bool var_3;
    wp::int32 var_4;
    wp::int32 var_5;
    const wp::int32 var_6 = 2;
    bool var_7;
    wp::int32 var_8;
    wp::int32 var_9;
    //---------
    // forward
    // def side_of(digit, near):                                                              <L 1>
    // side = int(0)                                                                          <L 3>
    var_1 = wp::int(var_0);
    // if digit == 1:                                                                         <L 4>
    var_3 = (var_digit == var_2);
    if (var_3) {
        // side = near                                                                        <L 5>
        var_4 = wp::copy(var_near);
    }
    var_5 = wp::where(var_3, var_4, var_1);
    // if digit == 2:                                                                         <L 6>
    var_7 = (var_digit == var_6);
    if (var_7) {
        // side = -near                                                                       <L 7>
        var_8 = wp::neg(var_near);
    }
    var_9 = wp::where(var_7, var_8, var_5);
    // return side                                                                            <L 8>
    return var_9;
}


// <pointloom.kernels.odometry.voxel_map_search.gap_to>:1
static CUDA_CALLABLE wp::float32 gap_to_0(
    wp::float32 var_offset,
    wp::int32 var_side,
    wp::float32 var_size)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 0.0;
    wp::float32 var_1;
    const wp::int32 var_2 = 0;
    bool var_3;
    const wp::int32 var_4 = 1;
    wp::int32 var_5;
    wp::float32 var_6;
    wp::float32 var_7;
    wp::float32 var_8;
    wp::float32 var_9;
    const wp::int32 var_10 = 0;
    bool var_11;
    wp::float32 var_12;
    wp::float32 var_13;
    wp::float32 var_14;
    wp::float32 var_15;
    //---------
    // forward
    // def gap_to(offset, side, size):                                                        <L 1>
    // gap = float(0.0)                                                                       <L 3>
    var_1 = wp::float(var_0);
    // if side < 0:                                                                           <L 4>
    var_3 = (var_side < var_2);
    if (var_3) {
        // gap = offset - float(side + 1) * size                                              <L 5>
        var_5 = wp::add(var_side, var_4);
        var_6 = wp::float(var_5);
        var_7 = wp::mul(var_6, var_size);
        var_8 = wp::sub(var_offset, var_7);
    }
    var_9 = wp::where(var_3, var_8, var_1);
    // if side > 0:                                                                           <L 6>
    var_11 = (var_side > var_10);
    if (var_11) {
        // gap = float(side) * size - offset                                                  <L 7>
        var_12 = wp::float(var_side);
        var_13 = wp::mul(var_12, var_size);
        var_14 = wp::sub(var_13, var_offset);
    }
    var_15 = wp::where(var_11, var_14, var_9);
    // return gap                                                                             <L 8>
    return var_15;
}


// /work/main/src/pointloom/kernels/arrays/block_keys.py:10
static CUDA_CALLABLE wp::int64 block_key_0(
    wp::int32 var_x,
    wp::int32 var_y,
    wp::int32 var_z)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 1048576;
    wp::int32 var_1;
    wp::int64 var_2;
    wp::int64 var_3;
    wp::int64 var_4;
    wp::int32 var_5;
    wp::int64 var_6;
    wp::int64 var_7;
    wp::int64 var_8;
    wp::int64 var_9;
    wp::int32 var_10;
    wp::int64 var_11;
    wp::int64 var_12;
    //---------
    // forward
    // def block_key(x: int, y: int, z: int) -> int64:                                        <L 11>
    // high = (int64(x + BIAS) << int64(AXIS_BITS)) | int64(y + BIAS)                         <L 12>
    var_1 = wp::add(var_x, var_0);
    var_2 = wp::int64(var_1);
    var_3 = 21ll;
    var_4 = wp::lshift(var_2, var_3);
    var_5 = wp::add(var_y, var_0);
    var_6 = wp::int64(var_5);
    var_7 = wp::bit_or(var_4, var_6);
    // return (high << int64(AXIS_BITS)) | int64(z + BIAS)                                    <L 13>
    var_8 = wp::int64(var_3);
    var_9 = wp::lshift(var_7, var_8);
    var_10 = wp::add(var_z, var_0);
    var_11 = wp::int64(var_10);
    var_12 = wp::bit_or(var_9, var_11);
    return var_12;
}


// <pointloom.kernels.arrays.hash_table.mix_bits>:1
static CUDA_CALLABLE wp::int64 mix_bits_0(
    wp::int64 var_key)
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
    //---------
    // forward
    // def mix_bits(key):                                                                     <L 1>
    // h = key ^ key >> int64(33) & int64(2147483647)                                         <L 3>
    var_0 = 33ll;
    var_1 = wp::rshift(var_key, var_0);
    var_2 = 2147483647ll;
    var_3 = wp::bit_and(var_1, var_2);
    var_4 = wp::bit_xor(var_key, var_3);
    // h = h * int64(-49064778989728563)                                                      <L 4>
    var_5 = -49064778989728563ll;
    var_6 = wp::mul(var_4, var_5);
    // return h ^ h >> int64(29) & int64(34359738367)                                         <L 5>
    var_7 = 29ll;
    var_8 = wp::rshift(var_6, var_7);
    var_9 = 34359738367ll;
    var_10 = wp::bit_and(var_8, var_9);
    var_11 = wp::bit_xor(var_6, var_10);
    return var_11;
}


// <pointloom.kernels.arrays.hash_table.find_slot>:1
static CUDA_CALLABLE wp::int32 find_slot_0(
    wp::int64 var_key,
    wp::array_t<wp::int64> var_table__keys,
    wp::int64 var_table__mask)
{
    //---------
    // primal vars
    wp::int64 var_0;
    wp::int64 var_1;
    wp::int32 var_2;
    wp::int64* var_3;
    bool var_4;
    wp::int64 var_5;
    wp::int64 var_6;
    wp::int64 var_7;
    wp::int64 var_8;
    wp::int32 var_9;
    //---------
    // forward
    // def find_slot(key, table__keys, table__mask):                                          <L 1>
    // slot = mix_bits(key) & table__mask                                                     <L 3>
    var_0 = mix_bits_0(var_key);
    var_1 = wp::bit_and(var_0, var_table__mask);
    // while table__keys[int(slot)] < key:                                                    <L 4>
    start_while_0:;
    var_2 = wp::int(var_1);
    var_3 = wp::address(var_table__keys, var_2);
    var_5 = wp::load(var_3);
    var_4 = (var_5 < var_key);
    if ((var_4) == false) goto end_while_0;
        // slot = slot + int64(1) & table__mask                                               <L 5>
        var_6 = 1ll;
        var_7 = wp::add(var_1, var_6);
        var_8 = wp::bit_and(var_7, var_table__mask);
        wp::assign(var_1, var_8);
    goto start_while_0;
    end_while_0:;
    // return int(slot)                                                                       <L 6>
    var_9 = wp::int(var_1);
    return var_9;
}


// <pointloom.kernels.arrays.hash_table.find_position>:1
static CUDA_CALLABLE wp::int32 find_position_0(
    wp::int64 var_key,
    wp::array_t<wp::int64> var_table__keys,
    wp::array_t<wp::int32> var_table__positions,
    wp::int64 var_table__mask)
{
    //---------
    // primal vars
    wp::int32 var_0;
    const wp::int32 var_1 = -1;
    wp::int32 var_2;
    wp::int64* var_3;
    bool var_4;
    wp::int64 var_5;
    wp::int32* var_6;
    wp::int32 var_7;
    wp::int32 var_8;
    wp::int32 var_9;
    //---------
    // forward
    // def find_position(key, table__keys, table__positions, table__mask):                    <L 1>
    // slot = find_slot(key, table__keys, table__mask)                                        <L 2>
    var_0 = find_slot_0(var_key, var_table__keys, var_table__mask);
    // position = int(-1)                                                                     <L 3>
    var_2 = wp::int(var_1);
    // if table__keys[slot] == key:                                                           <L 4>
    var_3 = wp::address(var_table__keys, var_0);
    var_5 = wp::load(var_3);
    var_4 = (var_5 == var_key);
    if (var_4) {
        // position = table__positions[slot]                                                  <L 5>
        var_6 = wp::address(var_table__positions, var_0);
        var_8 = wp::load(var_6);
        var_7 = wp::copy(var_8);
    }
    var_9 = wp::where(var_4, var_7, var_2);
    // return position                                                                        <L 6>
    return var_9;
}


// <pointloom.kernels.odometry.voxel_map_search.find_nearest_in_map>:1
static CUDA_CALLABLE wp::vec_t<5, wp::float64> find_nearest_in_map_0(
    wp::vec_t<3, wp::float64> var_x,
    wp::float32 var_limit,
    wp::float64 var_voxel_map__voxel_size,
    wp::int32 var_voxel_map__room,
    wp::array_t<wp::int64> var_voxel_map__table__keys,
    wp::array_t<wp::int32> var_voxel_map__table__positions,
    wp::int64 var_voxel_map__table__mask,
    wp::array_t<wp::int32> var_voxel_map__counts,
    wp::array_t<wp::vec_t<3, wp::float32>> var_voxel_map__offsets)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::int32> var_0;
    wp::vec_t<3, wp::float32> var_1;
    wp::float32 var_2;
    const wp::int32 var_3 = 0;
    wp::float32 var_4;
    wp::int32 var_5;
    const wp::int32 var_6 = 1;
    wp::float32 var_7;
    wp::int32 var_8;
    const wp::int32 var_9 = 2;
    wp::float32 var_10;
    wp::int32 var_11;
    wp::vec_t<3, wp::int32> var_12;
    const wp::float32 var_13 = 0.0;
    const wp::float32 var_14 = 0.0;
    const wp::float32 var_15 = 0.0;
    wp::vec_t<3, wp::float32> var_16;
    wp::float32 var_17;
    const wp::int32 var_18 = -1;
    wp::int32 var_19;
    wp::float32 var_20;
    const wp::int32 var_21 = 0;
    const wp::int32 var_22 = 2;
    wp::int32 var_23;
    wp::int32 var_24;
    const wp::int32 var_25 = 2;
    wp::float32 var_26;
    wp::float32 var_27;
    wp::float32 var_28;
    bool var_29;
    const wp::int32 var_30 = 0;
    const wp::int32 var_31 = 1;
    wp::int32 var_32;
    wp::int32 var_33;
    const wp::int32 var_34 = 1;
    wp::float32 var_35;
    wp::float32 var_36;
    wp::float32 var_37;
    wp::float32 var_38;
    wp::float32 var_39;
    bool var_40;
    const wp::int32 var_41 = 0;
    const wp::int32 var_42 = 0;
    wp::int32 var_43;
    wp::int32 var_44;
    const wp::int32 var_45 = 0;
    wp::float32 var_46;
    wp::float32 var_47;
    wp::float32 var_48;
    wp::float32 var_49;
    wp::float32 var_50;
    wp::float32 var_51;
    wp::float32 var_52;
    bool var_53;
    const wp::int32 var_54 = 0;
    wp::int32 var_55;
    wp::int32 var_56;
    const wp::int32 var_57 = 1;
    wp::int32 var_58;
    wp::int32 var_59;
    const wp::int32 var_60 = 2;
    wp::int32 var_61;
    wp::int32 var_62;
    wp::int64 var_63;
    wp::int32 var_64;
    const wp::int32 var_65 = 0;
    bool var_66;
    wp::float32 var_67;
    wp::float32 var_68;
    wp::float32 var_69;
    wp::float32 var_70;
    wp::float32 var_71;
    wp::float32 var_72;
    wp::vec_t<3, wp::float32> var_73;
    wp::vec_t<3, wp::float32> var_74;
    wp::int32 var_75;
    wp::int32* var_76;
    wp::int32 var_77;
    wp::int32 var_78;
    wp::range_t var_79;
    wp::int32 var_80;
    wp::vec_t<3, wp::float32>* var_81;
    wp::vec_t<3, wp::float32> var_82;
    wp::vec_t<3, wp::float32> var_83;
    const wp::int32 var_84 = 0;
    wp::float32 var_85;
    const wp::int32 var_86 = 0;
    wp::float32 var_87;
    wp::float32 var_88;
    const wp::int32 var_89 = 1;
    wp::float32 var_90;
    const wp::int32 var_91 = 1;
    wp::float32 var_92;
    wp::float32 var_93;
    wp::float32 var_94;
    const wp::int32 var_95 = 2;
    wp::float32 var_96;
    const wp::int32 var_97 = 2;
    wp::float32 var_98;
    wp::float32 var_99;
    wp::float32 var_100;
    bool var_101;
    wp::vec_t<3, wp::float32> var_102;
    wp::float32 var_103;
    wp::int32 var_104;
    wp::vec_t<3, wp::float32> var_105;
    wp::float32 var_106;
    wp::int32 var_107;
    const wp::int32 var_108 = 1;
    const wp::int32 var_109 = 0;
    wp::int32 var_110;
    wp::int32 var_111;
    const wp::int32 var_112 = 0;
    wp::float32 var_113;
    wp::float32 var_114;
    wp::float32 var_115;
    wp::float32 var_116;
    wp::float32 var_117;
    wp::float32 var_118;
    wp::float32 var_119;
    bool var_120;
    const wp::int32 var_121 = 0;
    wp::int32 var_122;
    wp::int32 var_123;
    const wp::int32 var_124 = 1;
    wp::int32 var_125;
    wp::int32 var_126;
    const wp::int32 var_127 = 2;
    wp::int32 var_128;
    wp::int32 var_129;
    wp::int64 var_130;
    wp::int32 var_131;
    const wp::int32 var_132 = 0;
    bool var_133;
    wp::float32 var_134;
    wp::float32 var_135;
    wp::float32 var_136;
    wp::float32 var_137;
    wp::float32 var_138;
    wp::float32 var_139;
    wp::vec_t<3, wp::float32> var_140;
    wp::vec_t<3, wp::float32> var_141;
    wp::int32 var_142;
    wp::int32* var_143;
    wp::int32 var_144;
    wp::int32 var_145;
    wp::range_t var_146;
    wp::int32 var_147;
    wp::vec_t<3, wp::float32>* var_148;
    wp::vec_t<3, wp::float32> var_149;
    wp::vec_t<3, wp::float32> var_150;
    const wp::int32 var_151 = 0;
    wp::float32 var_152;
    const wp::int32 var_153 = 0;
    wp::float32 var_154;
    wp::float32 var_155;
    const wp::int32 var_156 = 1;
    wp::float32 var_157;
    const wp::int32 var_158 = 1;
    wp::float32 var_159;
    wp::float32 var_160;
    wp::float32 var_161;
    const wp::int32 var_162 = 2;
    wp::float32 var_163;
    const wp::int32 var_164 = 2;
    wp::float32 var_165;
    wp::float32 var_166;
    wp::float32 var_167;
    bool var_168;
    wp::vec_t<3, wp::float32> var_169;
    wp::float32 var_170;
    wp::int32 var_171;
    wp::vec_t<3, wp::float32> var_172;
    wp::float32 var_173;
    wp::int32 var_174;
    wp::vec_t<3, wp::float32> var_175;
    wp::vec_t<3, wp::float32> var_176;
    wp::int32 var_177;
    wp::int32 var_178;
    wp::int32 var_179;
    wp::vec_t<3, wp::float32> var_180;
    wp::vec_t<3, wp::float32> var_181;
    wp::int32 var_182;
    wp::int32 var_183;
    const wp::int32 var_184 = 2;
    const wp::int32 var_185 = 0;
    wp::int32 var_186;
    wp::int32 var_187;
    const wp::int32 var_188 = 0;
    wp::float32 var_189;
    wp::float32 var_190;
    wp::float32 var_191;
    wp::float32 var_192;
    wp::float32 var_193;
    wp::float32 var_194;
    wp::float32 var_195;
    bool var_196;
    const wp::int32 var_197 = 0;
    wp::int32 var_198;
    wp::int32 var_199;
    const wp::int32 var_200 = 1;
    wp::int32 var_201;
    wp::int32 var_202;
    const wp::int32 var_203 = 2;
    wp::int32 var_204;
    wp::int32 var_205;
    wp::int64 var_206;
    wp::int32 var_207;
    const wp::int32 var_208 = 0;
    bool var_209;
    wp::float32 var_210;
    wp::float32 var_211;
    wp::float32 var_212;
    wp::float32 var_213;
    wp::float32 var_214;
    wp::float32 var_215;
    wp::vec_t<3, wp::float32> var_216;
    wp::vec_t<3, wp::float32> var_217;
    wp::int32 var_218;
    wp::int32* var_219;
    wp::int32 var_220;
    wp::int32 var_221;
    wp::range_t var_222;
    wp::int32 var_223;
    wp::vec_t<3, wp::float32>* var_224;
    wp::vec_t<3, wp::float32> var_225;
    wp::vec_t<3, wp::float32> var_226;
    const wp::int32 var_227 = 0;
    wp::float32 var_228;
    const wp::int32 var_229 = 0;
    wp::float32 var_230;
    wp::float32 var_231;
    const wp::int32 var_232 = 1;
    wp::float32 var_233;
    const wp::int32 var_234 = 1;
    wp::float32 var_235;
    wp::float32 var_236;
    wp::float32 var_237;
    const wp::int32 var_238 = 2;
    wp::float32 var_239;
    const wp::int32 var_240 = 2;
    wp::float32 var_241;
    wp::float32 var_242;
    wp::float32 var_243;
    bool var_244;
    wp::vec_t<3, wp::float32> var_245;
    wp::float32 var_246;
    wp::int32 var_247;
    wp::vec_t<3, wp::float32> var_248;
    wp::float32 var_249;
    wp::int32 var_250;
    wp::vec_t<3, wp::float32> var_251;
    wp::vec_t<3, wp::float32> var_252;
    wp::int32 var_253;
    wp::int32 var_254;
    wp::int32 var_255;
    wp::vec_t<3, wp::float32> var_256;
    wp::vec_t<3, wp::float32> var_257;
    wp::int32 var_258;
    wp::int32 var_259;
    const wp::int32 var_260 = 1;
    const wp::int32 var_261 = 1;
    wp::int32 var_262;
    wp::int32 var_263;
    const wp::int32 var_264 = 1;
    wp::float32 var_265;
    wp::float32 var_266;
    wp::float32 var_267;
    wp::float32 var_268;
    wp::float32 var_269;
    bool var_270;
    const wp::int32 var_271 = 0;
    const wp::int32 var_272 = 0;
    wp::int32 var_273;
    wp::int32 var_274;
    const wp::int32 var_275 = 0;
    wp::float32 var_276;
    wp::float32 var_277;
    wp::float32 var_278;
    wp::float32 var_279;
    wp::float32 var_280;
    wp::float32 var_281;
    wp::float32 var_282;
    bool var_283;
    const wp::int32 var_284 = 0;
    wp::int32 var_285;
    wp::int32 var_286;
    const wp::int32 var_287 = 1;
    wp::int32 var_288;
    wp::int32 var_289;
    const wp::int32 var_290 = 2;
    wp::int32 var_291;
    wp::int32 var_292;
    wp::int64 var_293;
    wp::int32 var_294;
    const wp::int32 var_295 = 0;
    bool var_296;
    wp::float32 var_297;
    wp::float32 var_298;
    wp::float32 var_299;
    wp::float32 var_300;
    wp::float32 var_301;
    wp::float32 var_302;
    wp::vec_t<3, wp::float32> var_303;
    wp::vec_t<3, wp::float32> var_304;
    wp::int32 var_305;
    wp::int32* var_306;
    wp::int32 var_307;
    wp::int32 var_308;
    wp::range_t var_309;
    wp::int32 var_310;
    wp::vec_t<3, wp::float32>* var_311;
    wp::vec_t<3, wp::float32> var_312;
    wp::vec_t<3, wp::float32> var_313;
    const wp::int32 var_314 = 0;
    wp::float32 var_315;
    const wp::int32 var_316 = 0;
    wp::float32 var_317;
    wp::float32 var_318;
    const wp::int32 var_319 = 1;
    wp::float32 var_320;
    const wp::int32 var_321 = 1;
    wp::float32 var_322;
    wp::float32 var_323;
    wp::float32 var_324;
    const wp::int32 var_325 = 2;
    wp::float32 var_326;
    const wp::int32 var_327 = 2;
    wp::float32 var_328;
    wp::float32 var_329;
    wp::float32 var_330;
    bool var_331;
    wp::vec_t<3, wp::float32> var_332;
    wp::float32 var_333;
    wp::int32 var_334;
    wp::vec_t<3, wp::float32> var_335;
    wp::float32 var_336;
    wp::int32 var_337;
    wp::vec_t<3, wp::float32> var_338;
    wp::vec_t<3, wp::float32> var_339;
    wp::int32 var_340;
    wp::int32 var_341;
    wp::int32 var_342;
    wp::vec_t<3, wp::float32> var_343;
    wp::vec_t<3, wp::float32> var_344;
    wp::int32 var_345;
    wp::int32 var_346;
    const wp::int32 var_347 = 1;
    const wp::int32 var_348 = 0;
    wp::int32 var_349;
    wp::int32 var_350;
    const wp::int32 var_351 = 0;
    wp::float32 var_352;
    wp::float32 var_353;
    wp::float32 var_354;
    wp::float32 var_355;
    wp::float32 var_356;
    wp::float32 var_357;
    wp::float32 var_358;
    bool var_359;
    const wp::int32 var_360 = 0;
    wp::int32 var_361;
    wp::int32 var_362;
    const wp::int32 var_363 = 1;
    wp::int32 var_364;
    wp::int32 var_365;
    const wp::int32 var_366 = 2;
    wp::int32 var_367;
    wp::int32 var_368;
    wp::int64 var_369;
    wp::int32 var_370;
    const wp::int32 var_371 = 0;
    bool var_372;
    wp::float32 var_373;
    wp::float32 var_374;
    wp::float32 var_375;
    wp::float32 var_376;
    wp::float32 var_377;
    wp::float32 var_378;
    wp::vec_t<3, wp::float32> var_379;
    wp::vec_t<3, wp::float32> var_380;
    wp::int32 var_381;
    wp::int32* var_382;
    wp::int32 var_383;
    wp::int32 var_384;
    wp::range_t var_385;
    wp::int32 var_386;
    wp::vec_t<3, wp::float32>* var_387;
    wp::vec_t<3, wp::float32> var_388;
    wp::vec_t<3, wp::float32> var_389;
    const wp::int32 var_390 = 0;
    wp::float32 var_391;
    const wp::int32 var_392 = 0;
    wp::float32 var_393;
    wp::float32 var_394;
    const wp::int32 var_395 = 1;
    wp::float32 var_396;
    const wp::int32 var_397 = 1;
    wp::float32 var_398;
    wp::float32 var_399;
    wp::float32 var_400;
    const wp::int32 var_401 = 2;
    wp::float32 var_402;
    const wp::int32 var_403 = 2;
    wp::float32 var_404;
    wp::float32 var_405;
    wp::float32 var_406;
    bool var_407;
    wp::vec_t<3, wp::float32> var_408;
    wp::float32 var_409;
    wp::int32 var_410;
    wp::vec_t<3, wp::float32> var_411;
    wp::float32 var_412;
    wp::int32 var_413;
    wp::vec_t<3, wp::float32> var_414;
    wp::vec_t<3, wp::float32> var_415;
    wp::int32 var_416;
    wp::int32 var_417;
    wp::int32 var_418;
    wp::vec_t<3, wp::float32> var_419;
    wp::vec_t<3, wp::float32> var_420;
    wp::int32 var_421;
    wp::int32 var_422;
    const wp::int32 var_423 = 2;
    const wp::int32 var_424 = 0;
    wp::int32 var_425;
    wp::int32 var_426;
    const wp::int32 var_427 = 0;
    wp::float32 var_428;
    wp::float32 var_429;
    wp::float32 var_430;
    wp::float32 var_431;
    wp::float32 var_432;
    wp::float32 var_433;
    wp::float32 var_434;
    bool var_435;
    const wp::int32 var_436 = 0;
    wp::int32 var_437;
    wp::int32 var_438;
    const wp::int32 var_439 = 1;
    wp::int32 var_440;
    wp::int32 var_441;
    const wp::int32 var_442 = 2;
    wp::int32 var_443;
    wp::int32 var_444;
    wp::int64 var_445;
    wp::int32 var_446;
    const wp::int32 var_447 = 0;
    bool var_448;
    wp::float32 var_449;
    wp::float32 var_450;
    wp::float32 var_451;
    wp::float32 var_452;
    wp::float32 var_453;
    wp::float32 var_454;
    wp::vec_t<3, wp::float32> var_455;
    wp::vec_t<3, wp::float32> var_456;
    wp::int32 var_457;
    wp::int32* var_458;
    wp::int32 var_459;
    wp::int32 var_460;
    wp::range_t var_461;
    wp::int32 var_462;
    wp::vec_t<3, wp::float32>* var_463;
    wp::vec_t<3, wp::float32> var_464;
    wp::vec_t<3, wp::float32> var_465;
    const wp::int32 var_466 = 0;
    wp::float32 var_467;
    const wp::int32 var_468 = 0;
    wp::float32 var_469;
    wp::float32 var_470;
    const wp::int32 var_471 = 1;
    wp::float32 var_472;
    const wp::int32 var_473 = 1;
    wp::float32 var_474;
    wp::float32 var_475;
    wp::float32 var_476;
    const wp::int32 var_477 = 2;
    wp::float32 var_478;
    const wp::int32 var_479 = 2;
    wp::float32 var_480;
    wp::float32 var_481;
    wp::float32 var_482;
    bool var_483;
    wp::vec_t<3, wp::float32> var_484;
    wp::float32 var_485;
    wp::int32 var_486;
    wp::vec_t<3, wp::float32> var_487;
    wp::float32 var_488;
    wp::int32 var_489;
    wp::vec_t<3, wp::float32> var_490;
    wp::vec_t<3, wp::float32> var_491;
    wp::int32 var_492;
    wp::int32 var_493;
    wp::int32 var_494;
    wp::vec_t<3, wp::float32> var_495;
    wp::vec_t<3, wp::float32> var_496;
    wp::int32 var_497;
    wp::int32 var_498;
    wp::int32 var_499;
    wp::int32 var_500;
    wp::float32 var_501;
    wp::int32 var_502;
    wp::vec_t<3, wp::float32> var_503;
    wp::vec_t<3, wp::float32> var_504;
    wp::int32 var_505;
    wp::int32 var_506;
    const wp::int32 var_507 = 2;
    const wp::int32 var_508 = 1;
    wp::int32 var_509;
    wp::int32 var_510;
    const wp::int32 var_511 = 1;
    wp::float32 var_512;
    wp::float32 var_513;
    wp::float32 var_514;
    wp::float32 var_515;
    wp::float32 var_516;
    bool var_517;
    const wp::int32 var_518 = 0;
    const wp::int32 var_519 = 0;
    wp::int32 var_520;
    wp::int32 var_521;
    const wp::int32 var_522 = 0;
    wp::float32 var_523;
    wp::float32 var_524;
    wp::float32 var_525;
    wp::float32 var_526;
    wp::float32 var_527;
    wp::float32 var_528;
    wp::float32 var_529;
    bool var_530;
    const wp::int32 var_531 = 0;
    wp::int32 var_532;
    wp::int32 var_533;
    const wp::int32 var_534 = 1;
    wp::int32 var_535;
    wp::int32 var_536;
    const wp::int32 var_537 = 2;
    wp::int32 var_538;
    wp::int32 var_539;
    wp::int64 var_540;
    wp::int32 var_541;
    const wp::int32 var_542 = 0;
    bool var_543;
    wp::float32 var_544;
    wp::float32 var_545;
    wp::float32 var_546;
    wp::float32 var_547;
    wp::float32 var_548;
    wp::float32 var_549;
    wp::vec_t<3, wp::float32> var_550;
    wp::vec_t<3, wp::float32> var_551;
    wp::int32 var_552;
    wp::int32* var_553;
    wp::int32 var_554;
    wp::int32 var_555;
    wp::range_t var_556;
    wp::int32 var_557;
    wp::vec_t<3, wp::float32>* var_558;
    wp::vec_t<3, wp::float32> var_559;
    wp::vec_t<3, wp::float32> var_560;
    const wp::int32 var_561 = 0;
    wp::float32 var_562;
    const wp::int32 var_563 = 0;
    wp::float32 var_564;
    wp::float32 var_565;
    const wp::int32 var_566 = 1;
    wp::float32 var_567;
    const wp::int32 var_568 = 1;
    wp::float32 var_569;
    wp::float32 var_570;
    wp::float32 var_571;
    const wp::int32 var_572 = 2;
    wp::float32 var_573;
    const wp::int32 var_574 = 2;
    wp::float32 var_575;
    wp::float32 var_576;
    wp::float32 var_577;
    bool var_578;
    wp::vec_t<3, wp::float32> var_579;
    wp::float32 var_580;
    wp::int32 var_581;
    wp::vec_t<3, wp::float32> var_582;
    wp::float32 var_583;
    wp::int32 var_584;
    wp::vec_t<3, wp::float32> var_585;
    wp::vec_t<3, wp::float32> var_586;
    wp::int32 var_587;
    wp::int32 var_588;
    wp::int32 var_589;
    wp::vec_t<3, wp::float32> var_590;
    wp::vec_t<3, wp::float32> var_591;
    wp::int32 var_592;
    wp::int32 var_593;
    const wp::int32 var_594 = 1;
    const wp::int32 var_595 = 0;
    wp::int32 var_596;
    wp::int32 var_597;
    const wp::int32 var_598 = 0;
    wp::float32 var_599;
    wp::float32 var_600;
    wp::float32 var_601;
    wp::float32 var_602;
    wp::float32 var_603;
    wp::float32 var_604;
    wp::float32 var_605;
    bool var_606;
    const wp::int32 var_607 = 0;
    wp::int32 var_608;
    wp::int32 var_609;
    const wp::int32 var_610 = 1;
    wp::int32 var_611;
    wp::int32 var_612;
    const wp::int32 var_613 = 2;
    wp::int32 var_614;
    wp::int32 var_615;
    wp::int64 var_616;
    wp::int32 var_617;
    const wp::int32 var_618 = 0;
    bool var_619;
    wp::float32 var_620;
    wp::float32 var_621;
    wp::float32 var_622;
    wp::float32 var_623;
    wp::float32 var_624;
    wp::float32 var_625;
    wp::vec_t<3, wp::float32> var_626;
    wp::vec_t<3, wp::float32> var_627;
    wp::int32 var_628;
    wp::int32* var_629;
    wp::int32 var_630;
    wp::int32 var_631;
    wp::range_t var_632;
    wp::int32 var_633;
    wp::vec_t<3, wp::float32>* var_634;
    wp::vec_t<3, wp::float32> var_635;
    wp::vec_t<3, wp::float32> var_636;
    const wp::int32 var_637 = 0;
    wp::float32 var_638;
    const wp::int32 var_639 = 0;
    wp::float32 var_640;
    wp::float32 var_641;
    const wp::int32 var_642 = 1;
    wp::float32 var_643;
    const wp::int32 var_644 = 1;
    wp::float32 var_645;
    wp::float32 var_646;
    wp::float32 var_647;
    const wp::int32 var_648 = 2;
    wp::float32 var_649;
    const wp::int32 var_650 = 2;
    wp::float32 var_651;
    wp::float32 var_652;
    wp::float32 var_653;
    bool var_654;
    wp::vec_t<3, wp::float32> var_655;
    wp::float32 var_656;
    wp::int32 var_657;
    wp::vec_t<3, wp::float32> var_658;
    wp::float32 var_659;
    wp::int32 var_660;
    wp::vec_t<3, wp::float32> var_661;
    wp::vec_t<3, wp::float32> var_662;
    wp::int32 var_663;
    wp::int32 var_664;
    wp::int32 var_665;
    wp::vec_t<3, wp::float32> var_666;
    wp::vec_t<3, wp::float32> var_667;
    wp::int32 var_668;
    wp::int32 var_669;
    const wp::int32 var_670 = 2;
    const wp::int32 var_671 = 0;
    wp::int32 var_672;
    wp::int32 var_673;
    const wp::int32 var_674 = 0;
    wp::float32 var_675;
    wp::float32 var_676;
    wp::float32 var_677;
    wp::float32 var_678;
    wp::float32 var_679;
    wp::float32 var_680;
    wp::float32 var_681;
    bool var_682;
    const wp::int32 var_683 = 0;
    wp::int32 var_684;
    wp::int32 var_685;
    const wp::int32 var_686 = 1;
    wp::int32 var_687;
    wp::int32 var_688;
    const wp::int32 var_689 = 2;
    wp::int32 var_690;
    wp::int32 var_691;
    wp::int64 var_692;
    wp::int32 var_693;
    const wp::int32 var_694 = 0;
    bool var_695;
    wp::float32 var_696;
    wp::float32 var_697;
    wp::float32 var_698;
    wp::float32 var_699;
    wp::float32 var_700;
    wp::float32 var_701;
    wp::vec_t<3, wp::float32> var_702;
    wp::vec_t<3, wp::float32> var_703;
    wp::int32 var_704;
    wp::int32* var_705;
    wp::int32 var_706;
    wp::int32 var_707;
    wp::range_t var_708;
    wp::int32 var_709;
    wp::vec_t<3, wp::float32>* var_710;
    wp::vec_t<3, wp::float32> var_711;
    wp::vec_t<3, wp::float32> var_712;
    const wp::int32 var_713 = 0;
    wp::float32 var_714;
    const wp::int32 var_715 = 0;
    wp::float32 var_716;
    wp::float32 var_717;
    const wp::int32 var_718 = 1;
    wp::float32 var_719;
    const wp::int32 var_720 = 1;
    wp::float32 var_721;
    wp::float32 var_722;
    wp::float32 var_723;
    const wp::int32 var_724 = 2;
    wp::float32 var_725;
    const wp::int32 var_726 = 2;
    wp::float32 var_727;
    wp::float32 var_728;
    wp::float32 var_729;
    bool var_730;
    wp::vec_t<3, wp::float32> var_731;
    wp::float32 var_732;
    wp::int32 var_733;
    wp::vec_t<3, wp::float32> var_734;
    wp::float32 var_735;
    wp::int32 var_736;
    wp::vec_t<3, wp::float32> var_737;
    wp::vec_t<3, wp::float32> var_738;
    wp::int32 var_739;
    wp::int32 var_740;
    wp::int32 var_741;
    wp::vec_t<3, wp::float32> var_742;
    wp::vec_t<3, wp::float32> var_743;
    wp::int32 var_744;
    wp::int32 var_745;
    wp::int32 var_746;
    wp::int32 var_747;
    wp::float32 var_748;
    wp::int32 var_749;
    wp::vec_t<3, wp::float32> var_750;
    wp::vec_t<3, wp::float32> var_751;
    wp::int32 var_752;
    wp::int32 var_753;
    const wp::int32 var_754 = 1;
    const wp::int32 var_755 = 2;
    wp::int32 var_756;
    wp::int32 var_757;
    const wp::int32 var_758 = 2;
    wp::float32 var_759;
    wp::float32 var_760;
    wp::float32 var_761;
    bool var_762;
    const wp::int32 var_763 = 0;
    const wp::int32 var_764 = 1;
    wp::int32 var_765;
    wp::int32 var_766;
    const wp::int32 var_767 = 1;
    wp::float32 var_768;
    wp::float32 var_769;
    wp::float32 var_770;
    wp::float32 var_771;
    wp::float32 var_772;
    bool var_773;
    const wp::int32 var_774 = 0;
    const wp::int32 var_775 = 0;
    wp::int32 var_776;
    wp::int32 var_777;
    const wp::int32 var_778 = 0;
    wp::float32 var_779;
    wp::float32 var_780;
    wp::float32 var_781;
    wp::float32 var_782;
    wp::float32 var_783;
    wp::float32 var_784;
    wp::float32 var_785;
    bool var_786;
    const wp::int32 var_787 = 0;
    wp::int32 var_788;
    wp::int32 var_789;
    const wp::int32 var_790 = 1;
    wp::int32 var_791;
    wp::int32 var_792;
    const wp::int32 var_793 = 2;
    wp::int32 var_794;
    wp::int32 var_795;
    wp::int64 var_796;
    wp::int32 var_797;
    const wp::int32 var_798 = 0;
    bool var_799;
    wp::float32 var_800;
    wp::float32 var_801;
    wp::float32 var_802;
    wp::float32 var_803;
    wp::float32 var_804;
    wp::float32 var_805;
    wp::vec_t<3, wp::float32> var_806;
    wp::vec_t<3, wp::float32> var_807;
    wp::int32 var_808;
    wp::int32* var_809;
    wp::int32 var_810;
    wp::int32 var_811;
    wp::range_t var_812;
    wp::int32 var_813;
    wp::vec_t<3, wp::float32>* var_814;
    wp::vec_t<3, wp::float32> var_815;
    wp::vec_t<3, wp::float32> var_816;
    const wp::int32 var_817 = 0;
    wp::float32 var_818;
    const wp::int32 var_819 = 0;
    wp::float32 var_820;
    wp::float32 var_821;
    const wp::int32 var_822 = 1;
    wp::float32 var_823;
    const wp::int32 var_824 = 1;
    wp::float32 var_825;
    wp::float32 var_826;
    wp::float32 var_827;
    const wp::int32 var_828 = 2;
    wp::float32 var_829;
    const wp::int32 var_830 = 2;
    wp::float32 var_831;
    wp::float32 var_832;
    wp::float32 var_833;
    bool var_834;
    wp::vec_t<3, wp::float32> var_835;
    wp::float32 var_836;
    wp::int32 var_837;
    wp::vec_t<3, wp::float32> var_838;
    wp::float32 var_839;
    wp::int32 var_840;
    wp::vec_t<3, wp::float32> var_841;
    wp::vec_t<3, wp::float32> var_842;
    wp::int32 var_843;
    wp::int32 var_844;
    wp::int32 var_845;
    wp::vec_t<3, wp::float32> var_846;
    wp::vec_t<3, wp::float32> var_847;
    wp::int32 var_848;
    wp::int32 var_849;
    const wp::int32 var_850 = 1;
    const wp::int32 var_851 = 0;
    wp::int32 var_852;
    wp::int32 var_853;
    const wp::int32 var_854 = 0;
    wp::float32 var_855;
    wp::float32 var_856;
    wp::float32 var_857;
    wp::float32 var_858;
    wp::float32 var_859;
    wp::float32 var_860;
    wp::float32 var_861;
    bool var_862;
    const wp::int32 var_863 = 0;
    wp::int32 var_864;
    wp::int32 var_865;
    const wp::int32 var_866 = 1;
    wp::int32 var_867;
    wp::int32 var_868;
    const wp::int32 var_869 = 2;
    wp::int32 var_870;
    wp::int32 var_871;
    wp::int64 var_872;
    wp::int32 var_873;
    const wp::int32 var_874 = 0;
    bool var_875;
    wp::float32 var_876;
    wp::float32 var_877;
    wp::float32 var_878;
    wp::float32 var_879;
    wp::float32 var_880;
    wp::float32 var_881;
    wp::vec_t<3, wp::float32> var_882;
    wp::vec_t<3, wp::float32> var_883;
    wp::int32 var_884;
    wp::int32* var_885;
    wp::int32 var_886;
    wp::int32 var_887;
    wp::range_t var_888;
    wp::int32 var_889;
    wp::vec_t<3, wp::float32>* var_890;
    wp::vec_t<3, wp::float32> var_891;
    wp::vec_t<3, wp::float32> var_892;
    const wp::int32 var_893 = 0;
    wp::float32 var_894;
    const wp::int32 var_895 = 0;
    wp::float32 var_896;
    wp::float32 var_897;
    const wp::int32 var_898 = 1;
    wp::float32 var_899;
    const wp::int32 var_900 = 1;
    wp::float32 var_901;
    wp::float32 var_902;
    wp::float32 var_903;
    const wp::int32 var_904 = 2;
    wp::float32 var_905;
    const wp::int32 var_906 = 2;
    wp::float32 var_907;
    wp::float32 var_908;
    wp::float32 var_909;
    bool var_910;
    wp::vec_t<3, wp::float32> var_911;
    wp::float32 var_912;
    wp::int32 var_913;
    wp::vec_t<3, wp::float32> var_914;
    wp::float32 var_915;
    wp::int32 var_916;
    wp::vec_t<3, wp::float32> var_917;
    wp::vec_t<3, wp::float32> var_918;
    wp::int32 var_919;
    wp::int32 var_920;
    wp::int32 var_921;
    wp::vec_t<3, wp::float32> var_922;
    wp::vec_t<3, wp::float32> var_923;
    wp::int32 var_924;
    wp::int32 var_925;
    const wp::int32 var_926 = 2;
    const wp::int32 var_927 = 0;
    wp::int32 var_928;
    wp::int32 var_929;
    const wp::int32 var_930 = 0;
    wp::float32 var_931;
    wp::float32 var_932;
    wp::float32 var_933;
    wp::float32 var_934;
    wp::float32 var_935;
    wp::float32 var_936;
    wp::float32 var_937;
    bool var_938;
    const wp::int32 var_939 = 0;
    wp::int32 var_940;
    wp::int32 var_941;
    const wp::int32 var_942 = 1;
    wp::int32 var_943;
    wp::int32 var_944;
    const wp::int32 var_945 = 2;
    wp::int32 var_946;
    wp::int32 var_947;
    wp::int64 var_948;
    wp::int32 var_949;
    const wp::int32 var_950 = 0;
    bool var_951;
    wp::float32 var_952;
    wp::float32 var_953;
    wp::float32 var_954;
    wp::float32 var_955;
    wp::float32 var_956;
    wp::float32 var_957;
    wp::vec_t<3, wp::float32> var_958;
    wp::vec_t<3, wp::float32> var_959;
    wp::int32 var_960;
    wp::int32* var_961;
    wp::int32 var_962;
    wp::int32 var_963;
    wp::range_t var_964;
    wp::int32 var_965;
    wp::vec_t<3, wp::float32>* var_966;
    wp::vec_t<3, wp::float32> var_967;
    wp::vec_t<3, wp::float32> var_968;
    const wp::int32 var_969 = 0;
    wp::float32 var_970;
    const wp::int32 var_971 = 0;
    wp::float32 var_972;
    wp::float32 var_973;
    const wp::int32 var_974 = 1;
    wp::float32 var_975;
    const wp::int32 var_976 = 1;
    wp::float32 var_977;
    wp::float32 var_978;
    wp::float32 var_979;
    const wp::int32 var_980 = 2;
    wp::float32 var_981;
    const wp::int32 var_982 = 2;
    wp::float32 var_983;
    wp::float32 var_984;
    wp::float32 var_985;
    bool var_986;
    wp::vec_t<3, wp::float32> var_987;
    wp::float32 var_988;
    wp::int32 var_989;
    wp::vec_t<3, wp::float32> var_990;
    wp::float32 var_991;
    wp::int32 var_992;
    wp::vec_t<3, wp::float32> var_993;
    wp::vec_t<3, wp::float32> var_994;
    wp::int32 var_995;
    wp::int32 var_996;
    wp::int32 var_997;
    wp::vec_t<3, wp::float32> var_998;
    wp::vec_t<3, wp::float32> var_999;
    wp::int32 var_1000;
    wp::int32 var_1001;
    wp::int32 var_1002;
    wp::int32 var_1003;
    wp::float32 var_1004;
    wp::int32 var_1005;
    wp::vec_t<3, wp::float32> var_1006;
    wp::vec_t<3, wp::float32> var_1007;
    wp::int32 var_1008;
    wp::int32 var_1009;
    const wp::int32 var_1010 = 1;
    const wp::int32 var_1011 = 1;
    wp::int32 var_1012;
    wp::int32 var_1013;
    const wp::int32 var_1014 = 1;
    wp::float32 var_1015;
    wp::float32 var_1016;
    wp::float32 var_1017;
    wp::float32 var_1018;
    wp::float32 var_1019;
    bool var_1020;
    const wp::int32 var_1021 = 0;
    const wp::int32 var_1022 = 0;
    wp::int32 var_1023;
    wp::int32 var_1024;
    const wp::int32 var_1025 = 0;
    wp::float32 var_1026;
    wp::float32 var_1027;
    wp::float32 var_1028;
    wp::float32 var_1029;
    wp::float32 var_1030;
    wp::float32 var_1031;
    wp::float32 var_1032;
    bool var_1033;
    const wp::int32 var_1034 = 0;
    wp::int32 var_1035;
    wp::int32 var_1036;
    const wp::int32 var_1037 = 1;
    wp::int32 var_1038;
    wp::int32 var_1039;
    const wp::int32 var_1040 = 2;
    wp::int32 var_1041;
    wp::int32 var_1042;
    wp::int64 var_1043;
    wp::int32 var_1044;
    const wp::int32 var_1045 = 0;
    bool var_1046;
    wp::float32 var_1047;
    wp::float32 var_1048;
    wp::float32 var_1049;
    wp::float32 var_1050;
    wp::float32 var_1051;
    wp::float32 var_1052;
    wp::vec_t<3, wp::float32> var_1053;
    wp::vec_t<3, wp::float32> var_1054;
    wp::int32 var_1055;
    wp::int32* var_1056;
    wp::int32 var_1057;
    wp::int32 var_1058;
    wp::range_t var_1059;
    wp::int32 var_1060;
    wp::vec_t<3, wp::float32>* var_1061;
    wp::vec_t<3, wp::float32> var_1062;
    wp::vec_t<3, wp::float32> var_1063;
    const wp::int32 var_1064 = 0;
    wp::float32 var_1065;
    const wp::int32 var_1066 = 0;
    wp::float32 var_1067;
    wp::float32 var_1068;
    const wp::int32 var_1069 = 1;
    wp::float32 var_1070;
    const wp::int32 var_1071 = 1;
    wp::float32 var_1072;
    wp::float32 var_1073;
    wp::float32 var_1074;
    const wp::int32 var_1075 = 2;
    wp::float32 var_1076;
    const wp::int32 var_1077 = 2;
    wp::float32 var_1078;
    wp::float32 var_1079;
    wp::float32 var_1080;
    bool var_1081;
    wp::vec_t<3, wp::float32> var_1082;
    wp::float32 var_1083;
    wp::int32 var_1084;
    wp::vec_t<3, wp::float32> var_1085;
    wp::float32 var_1086;
    wp::int32 var_1087;
    wp::vec_t<3, wp::float32> var_1088;
    wp::vec_t<3, wp::float32> var_1089;
    wp::int32 var_1090;
    wp::int32 var_1091;
    wp::int32 var_1092;
    wp::vec_t<3, wp::float32> var_1093;
    wp::vec_t<3, wp::float32> var_1094;
    wp::int32 var_1095;
    wp::int32 var_1096;
    const wp::int32 var_1097 = 1;
    const wp::int32 var_1098 = 0;
    wp::int32 var_1099;
    wp::int32 var_1100;
    const wp::int32 var_1101 = 0;
    wp::float32 var_1102;
    wp::float32 var_1103;
    wp::float32 var_1104;
    wp::float32 var_1105;
    wp::float32 var_1106;
    wp::float32 var_1107;
    wp::float32 var_1108;
    bool var_1109;
    const wp::int32 var_1110 = 0;
    wp::int32 var_1111;
    wp::int32 var_1112;
    const wp::int32 var_1113 = 1;
    wp::int32 var_1114;
    wp::int32 var_1115;
    const wp::int32 var_1116 = 2;
    wp::int32 var_1117;
    wp::int32 var_1118;
    wp::int64 var_1119;
    wp::int32 var_1120;
    const wp::int32 var_1121 = 0;
    bool var_1122;
    wp::float32 var_1123;
    wp::float32 var_1124;
    wp::float32 var_1125;
    wp::float32 var_1126;
    wp::float32 var_1127;
    wp::float32 var_1128;
    wp::vec_t<3, wp::float32> var_1129;
    wp::vec_t<3, wp::float32> var_1130;
    wp::int32 var_1131;
    wp::int32* var_1132;
    wp::int32 var_1133;
    wp::int32 var_1134;
    wp::range_t var_1135;
    wp::int32 var_1136;
    wp::vec_t<3, wp::float32>* var_1137;
    wp::vec_t<3, wp::float32> var_1138;
    wp::vec_t<3, wp::float32> var_1139;
    const wp::int32 var_1140 = 0;
    wp::float32 var_1141;
    const wp::int32 var_1142 = 0;
    wp::float32 var_1143;
    wp::float32 var_1144;
    const wp::int32 var_1145 = 1;
    wp::float32 var_1146;
    const wp::int32 var_1147 = 1;
    wp::float32 var_1148;
    wp::float32 var_1149;
    wp::float32 var_1150;
    const wp::int32 var_1151 = 2;
    wp::float32 var_1152;
    const wp::int32 var_1153 = 2;
    wp::float32 var_1154;
    wp::float32 var_1155;
    wp::float32 var_1156;
    bool var_1157;
    wp::vec_t<3, wp::float32> var_1158;
    wp::float32 var_1159;
    wp::int32 var_1160;
    wp::vec_t<3, wp::float32> var_1161;
    wp::float32 var_1162;
    wp::int32 var_1163;
    wp::vec_t<3, wp::float32> var_1164;
    wp::vec_t<3, wp::float32> var_1165;
    wp::int32 var_1166;
    wp::int32 var_1167;
    wp::int32 var_1168;
    wp::vec_t<3, wp::float32> var_1169;
    wp::vec_t<3, wp::float32> var_1170;
    wp::int32 var_1171;
    wp::int32 var_1172;
    const wp::int32 var_1173 = 2;
    const wp::int32 var_1174 = 0;
    wp::int32 var_1175;
    wp::int32 var_1176;
    const wp::int32 var_1177 = 0;
    wp::float32 var_1178;
    wp::float32 var_1179;
    wp::float32 var_1180;
    wp::float32 var_1181;
    wp::float32 var_1182;
    wp::float32 var_1183;
    wp::float32 var_1184;
    bool var_1185;
    const wp::int32 var_1186 = 0;
    wp::int32 var_1187;
    wp::int32 var_1188;
    const wp::int32 var_1189 = 1;
    wp::int32 var_1190;
    wp::int32 var_1191;
    const wp::int32 var_1192 = 2;
    wp::int32 var_1193;
    wp::int32 var_1194;
    wp::int64 var_1195;
    wp::int32 var_1196;
    const wp::int32 var_1197 = 0;
    bool var_1198;
    wp::float32 var_1199;
    wp::float32 var_1200;
    wp::float32 var_1201;
    wp::float32 var_1202;
    wp::float32 var_1203;
    wp::float32 var_1204;
    wp::vec_t<3, wp::float32> var_1205;
    wp::vec_t<3, wp::float32> var_1206;
    wp::int32 var_1207;
    wp::int32* var_1208;
    wp::int32 var_1209;
    wp::int32 var_1210;
    wp::range_t var_1211;
    wp::int32 var_1212;
    wp::vec_t<3, wp::float32>* var_1213;
    wp::vec_t<3, wp::float32> var_1214;
    wp::vec_t<3, wp::float32> var_1215;
    const wp::int32 var_1216 = 0;
    wp::float32 var_1217;
    const wp::int32 var_1218 = 0;
    wp::float32 var_1219;
    wp::float32 var_1220;
    const wp::int32 var_1221 = 1;
    wp::float32 var_1222;
    const wp::int32 var_1223 = 1;
    wp::float32 var_1224;
    wp::float32 var_1225;
    wp::float32 var_1226;
    const wp::int32 var_1227 = 2;
    wp::float32 var_1228;
    const wp::int32 var_1229 = 2;
    wp::float32 var_1230;
    wp::float32 var_1231;
    wp::float32 var_1232;
    bool var_1233;
    wp::vec_t<3, wp::float32> var_1234;
    wp::float32 var_1235;
    wp::int32 var_1236;
    wp::vec_t<3, wp::float32> var_1237;
    wp::float32 var_1238;
    wp::int32 var_1239;
    wp::vec_t<3, wp::float32> var_1240;
    wp::vec_t<3, wp::float32> var_1241;
    wp::int32 var_1242;
    wp::int32 var_1243;
    wp::int32 var_1244;
    wp::vec_t<3, wp::float32> var_1245;
    wp::vec_t<3, wp::float32> var_1246;
    wp::int32 var_1247;
    wp::int32 var_1248;
    wp::int32 var_1249;
    wp::int32 var_1250;
    wp::float32 var_1251;
    wp::int32 var_1252;
    wp::vec_t<3, wp::float32> var_1253;
    wp::vec_t<3, wp::float32> var_1254;
    wp::int32 var_1255;
    wp::int32 var_1256;
    const wp::int32 var_1257 = 2;
    const wp::int32 var_1258 = 1;
    wp::int32 var_1259;
    wp::int32 var_1260;
    const wp::int32 var_1261 = 1;
    wp::float32 var_1262;
    wp::float32 var_1263;
    wp::float32 var_1264;
    wp::float32 var_1265;
    wp::float32 var_1266;
    bool var_1267;
    const wp::int32 var_1268 = 0;
    const wp::int32 var_1269 = 0;
    wp::int32 var_1270;
    wp::int32 var_1271;
    const wp::int32 var_1272 = 0;
    wp::float32 var_1273;
    wp::float32 var_1274;
    wp::float32 var_1275;
    wp::float32 var_1276;
    wp::float32 var_1277;
    wp::float32 var_1278;
    wp::float32 var_1279;
    bool var_1280;
    const wp::int32 var_1281 = 0;
    wp::int32 var_1282;
    wp::int32 var_1283;
    const wp::int32 var_1284 = 1;
    wp::int32 var_1285;
    wp::int32 var_1286;
    const wp::int32 var_1287 = 2;
    wp::int32 var_1288;
    wp::int32 var_1289;
    wp::int64 var_1290;
    wp::int32 var_1291;
    const wp::int32 var_1292 = 0;
    bool var_1293;
    wp::float32 var_1294;
    wp::float32 var_1295;
    wp::float32 var_1296;
    wp::float32 var_1297;
    wp::float32 var_1298;
    wp::float32 var_1299;
    wp::vec_t<3, wp::float32> var_1300;
    wp::vec_t<3, wp::float32> var_1301;
    wp::int32 var_1302;
    wp::int32* var_1303;
    wp::int32 var_1304;
    wp::int32 var_1305;
    wp::range_t var_1306;
    wp::int32 var_1307;
    wp::vec_t<3, wp::float32>* var_1308;
    wp::vec_t<3, wp::float32> var_1309;
    wp::vec_t<3, wp::float32> var_1310;
    const wp::int32 var_1311 = 0;
    wp::float32 var_1312;
    const wp::int32 var_1313 = 0;
    wp::float32 var_1314;
    wp::float32 var_1315;
    const wp::int32 var_1316 = 1;
    wp::float32 var_1317;
    const wp::int32 var_1318 = 1;
    wp::float32 var_1319;
    wp::float32 var_1320;
    wp::float32 var_1321;
    const wp::int32 var_1322 = 2;
    wp::float32 var_1323;
    const wp::int32 var_1324 = 2;
    wp::float32 var_1325;
    wp::float32 var_1326;
    wp::float32 var_1327;
    bool var_1328;
    wp::vec_t<3, wp::float32> var_1329;
    wp::float32 var_1330;
    wp::int32 var_1331;
    wp::vec_t<3, wp::float32> var_1332;
    wp::float32 var_1333;
    wp::int32 var_1334;
    wp::vec_t<3, wp::float32> var_1335;
    wp::vec_t<3, wp::float32> var_1336;
    wp::int32 var_1337;
    wp::int32 var_1338;
    wp::int32 var_1339;
    wp::vec_t<3, wp::float32> var_1340;
    wp::vec_t<3, wp::float32> var_1341;
    wp::int32 var_1342;
    wp::int32 var_1343;
    const wp::int32 var_1344 = 1;
    const wp::int32 var_1345 = 0;
    wp::int32 var_1346;
    wp::int32 var_1347;
    const wp::int32 var_1348 = 0;
    wp::float32 var_1349;
    wp::float32 var_1350;
    wp::float32 var_1351;
    wp::float32 var_1352;
    wp::float32 var_1353;
    wp::float32 var_1354;
    wp::float32 var_1355;
    bool var_1356;
    const wp::int32 var_1357 = 0;
    wp::int32 var_1358;
    wp::int32 var_1359;
    const wp::int32 var_1360 = 1;
    wp::int32 var_1361;
    wp::int32 var_1362;
    const wp::int32 var_1363 = 2;
    wp::int32 var_1364;
    wp::int32 var_1365;
    wp::int64 var_1366;
    wp::int32 var_1367;
    const wp::int32 var_1368 = 0;
    bool var_1369;
    wp::float32 var_1370;
    wp::float32 var_1371;
    wp::float32 var_1372;
    wp::float32 var_1373;
    wp::float32 var_1374;
    wp::float32 var_1375;
    wp::vec_t<3, wp::float32> var_1376;
    wp::vec_t<3, wp::float32> var_1377;
    wp::int32 var_1378;
    wp::int32* var_1379;
    wp::int32 var_1380;
    wp::int32 var_1381;
    wp::range_t var_1382;
    wp::int32 var_1383;
    wp::vec_t<3, wp::float32>* var_1384;
    wp::vec_t<3, wp::float32> var_1385;
    wp::vec_t<3, wp::float32> var_1386;
    const wp::int32 var_1387 = 0;
    wp::float32 var_1388;
    const wp::int32 var_1389 = 0;
    wp::float32 var_1390;
    wp::float32 var_1391;
    const wp::int32 var_1392 = 1;
    wp::float32 var_1393;
    const wp::int32 var_1394 = 1;
    wp::float32 var_1395;
    wp::float32 var_1396;
    wp::float32 var_1397;
    const wp::int32 var_1398 = 2;
    wp::float32 var_1399;
    const wp::int32 var_1400 = 2;
    wp::float32 var_1401;
    wp::float32 var_1402;
    wp::float32 var_1403;
    bool var_1404;
    wp::vec_t<3, wp::float32> var_1405;
    wp::float32 var_1406;
    wp::int32 var_1407;
    wp::vec_t<3, wp::float32> var_1408;
    wp::float32 var_1409;
    wp::int32 var_1410;
    wp::vec_t<3, wp::float32> var_1411;
    wp::vec_t<3, wp::float32> var_1412;
    wp::int32 var_1413;
    wp::int32 var_1414;
    wp::int32 var_1415;
    wp::vec_t<3, wp::float32> var_1416;
    wp::vec_t<3, wp::float32> var_1417;
    wp::int32 var_1418;
    wp::int32 var_1419;
    const wp::int32 var_1420 = 2;
    const wp::int32 var_1421 = 0;
    wp::int32 var_1422;
    wp::int32 var_1423;
    const wp::int32 var_1424 = 0;
    wp::float32 var_1425;
    wp::float32 var_1426;
    wp::float32 var_1427;
    wp::float32 var_1428;
    wp::float32 var_1429;
    wp::float32 var_1430;
    wp::float32 var_1431;
    bool var_1432;
    const wp::int32 var_1433 = 0;
    wp::int32 var_1434;
    wp::int32 var_1435;
    const wp::int32 var_1436 = 1;
    wp::int32 var_1437;
    wp::int32 var_1438;
    const wp::int32 var_1439 = 2;
    wp::int32 var_1440;
    wp::int32 var_1441;
    wp::int64 var_1442;
    wp::int32 var_1443;
    const wp::int32 var_1444 = 0;
    bool var_1445;
    wp::float32 var_1446;
    wp::float32 var_1447;
    wp::float32 var_1448;
    wp::float32 var_1449;
    wp::float32 var_1450;
    wp::float32 var_1451;
    wp::vec_t<3, wp::float32> var_1452;
    wp::vec_t<3, wp::float32> var_1453;
    wp::int32 var_1454;
    wp::int32* var_1455;
    wp::int32 var_1456;
    wp::int32 var_1457;
    wp::range_t var_1458;
    wp::int32 var_1459;
    wp::vec_t<3, wp::float32>* var_1460;
    wp::vec_t<3, wp::float32> var_1461;
    wp::vec_t<3, wp::float32> var_1462;
    const wp::int32 var_1463 = 0;
    wp::float32 var_1464;
    const wp::int32 var_1465 = 0;
    wp::float32 var_1466;
    wp::float32 var_1467;
    const wp::int32 var_1468 = 1;
    wp::float32 var_1469;
    const wp::int32 var_1470 = 1;
    wp::float32 var_1471;
    wp::float32 var_1472;
    wp::float32 var_1473;
    const wp::int32 var_1474 = 2;
    wp::float32 var_1475;
    const wp::int32 var_1476 = 2;
    wp::float32 var_1477;
    wp::float32 var_1478;
    wp::float32 var_1479;
    bool var_1480;
    wp::vec_t<3, wp::float32> var_1481;
    wp::float32 var_1482;
    wp::int32 var_1483;
    wp::vec_t<3, wp::float32> var_1484;
    wp::float32 var_1485;
    wp::int32 var_1486;
    wp::vec_t<3, wp::float32> var_1487;
    wp::vec_t<3, wp::float32> var_1488;
    wp::int32 var_1489;
    wp::int32 var_1490;
    wp::int32 var_1491;
    wp::vec_t<3, wp::float32> var_1492;
    wp::vec_t<3, wp::float32> var_1493;
    wp::int32 var_1494;
    wp::int32 var_1495;
    wp::int32 var_1496;
    wp::int32 var_1497;
    wp::float32 var_1498;
    wp::int32 var_1499;
    wp::vec_t<3, wp::float32> var_1500;
    wp::vec_t<3, wp::float32> var_1501;
    wp::int32 var_1502;
    wp::int32 var_1503;
    wp::int32 var_1504;
    wp::int32 var_1505;
    wp::float32 var_1506;
    wp::int32 var_1507;
    wp::int32 var_1508;
    wp::float32 var_1509;
    wp::int32 var_1510;
    wp::vec_t<3, wp::float32> var_1511;
    wp::vec_t<3, wp::float32> var_1512;
    wp::int32 var_1513;
    wp::int32 var_1514;
    const wp::int32 var_1515 = 2;
    const wp::int32 var_1516 = 2;
    wp::int32 var_1517;
    wp::int32 var_1518;
    const wp::int32 var_1519 = 2;
    wp::float32 var_1520;
    wp::float32 var_1521;
    wp::float32 var_1522;
    bool var_1523;
    const wp::int32 var_1524 = 0;
    const wp::int32 var_1525 = 1;
    wp::int32 var_1526;
    wp::int32 var_1527;
    const wp::int32 var_1528 = 1;
    wp::float32 var_1529;
    wp::float32 var_1530;
    wp::float32 var_1531;
    wp::float32 var_1532;
    wp::float32 var_1533;
    bool var_1534;
    const wp::int32 var_1535 = 0;
    const wp::int32 var_1536 = 0;
    wp::int32 var_1537;
    wp::int32 var_1538;
    const wp::int32 var_1539 = 0;
    wp::float32 var_1540;
    wp::float32 var_1541;
    wp::float32 var_1542;
    wp::float32 var_1543;
    wp::float32 var_1544;
    wp::float32 var_1545;
    wp::float32 var_1546;
    bool var_1547;
    const wp::int32 var_1548 = 0;
    wp::int32 var_1549;
    wp::int32 var_1550;
    const wp::int32 var_1551 = 1;
    wp::int32 var_1552;
    wp::int32 var_1553;
    const wp::int32 var_1554 = 2;
    wp::int32 var_1555;
    wp::int32 var_1556;
    wp::int64 var_1557;
    wp::int32 var_1558;
    const wp::int32 var_1559 = 0;
    bool var_1560;
    wp::float32 var_1561;
    wp::float32 var_1562;
    wp::float32 var_1563;
    wp::float32 var_1564;
    wp::float32 var_1565;
    wp::float32 var_1566;
    wp::vec_t<3, wp::float32> var_1567;
    wp::vec_t<3, wp::float32> var_1568;
    wp::int32 var_1569;
    wp::int32* var_1570;
    wp::int32 var_1571;
    wp::int32 var_1572;
    wp::range_t var_1573;
    wp::int32 var_1574;
    wp::vec_t<3, wp::float32>* var_1575;
    wp::vec_t<3, wp::float32> var_1576;
    wp::vec_t<3, wp::float32> var_1577;
    const wp::int32 var_1578 = 0;
    wp::float32 var_1579;
    const wp::int32 var_1580 = 0;
    wp::float32 var_1581;
    wp::float32 var_1582;
    const wp::int32 var_1583 = 1;
    wp::float32 var_1584;
    const wp::int32 var_1585 = 1;
    wp::float32 var_1586;
    wp::float32 var_1587;
    wp::float32 var_1588;
    const wp::int32 var_1589 = 2;
    wp::float32 var_1590;
    const wp::int32 var_1591 = 2;
    wp::float32 var_1592;
    wp::float32 var_1593;
    wp::float32 var_1594;
    bool var_1595;
    wp::vec_t<3, wp::float32> var_1596;
    wp::float32 var_1597;
    wp::int32 var_1598;
    wp::vec_t<3, wp::float32> var_1599;
    wp::float32 var_1600;
    wp::int32 var_1601;
    wp::vec_t<3, wp::float32> var_1602;
    wp::vec_t<3, wp::float32> var_1603;
    wp::int32 var_1604;
    wp::int32 var_1605;
    wp::int32 var_1606;
    wp::vec_t<3, wp::float32> var_1607;
    wp::vec_t<3, wp::float32> var_1608;
    wp::int32 var_1609;
    wp::int32 var_1610;
    const wp::int32 var_1611 = 1;
    const wp::int32 var_1612 = 0;
    wp::int32 var_1613;
    wp::int32 var_1614;
    const wp::int32 var_1615 = 0;
    wp::float32 var_1616;
    wp::float32 var_1617;
    wp::float32 var_1618;
    wp::float32 var_1619;
    wp::float32 var_1620;
    wp::float32 var_1621;
    wp::float32 var_1622;
    bool var_1623;
    const wp::int32 var_1624 = 0;
    wp::int32 var_1625;
    wp::int32 var_1626;
    const wp::int32 var_1627 = 1;
    wp::int32 var_1628;
    wp::int32 var_1629;
    const wp::int32 var_1630 = 2;
    wp::int32 var_1631;
    wp::int32 var_1632;
    wp::int64 var_1633;
    wp::int32 var_1634;
    const wp::int32 var_1635 = 0;
    bool var_1636;
    wp::float32 var_1637;
    wp::float32 var_1638;
    wp::float32 var_1639;
    wp::float32 var_1640;
    wp::float32 var_1641;
    wp::float32 var_1642;
    wp::vec_t<3, wp::float32> var_1643;
    wp::vec_t<3, wp::float32> var_1644;
    wp::int32 var_1645;
    wp::int32* var_1646;
    wp::int32 var_1647;
    wp::int32 var_1648;
    wp::range_t var_1649;
    wp::int32 var_1650;
    wp::vec_t<3, wp::float32>* var_1651;
    wp::vec_t<3, wp::float32> var_1652;
    wp::vec_t<3, wp::float32> var_1653;
    const wp::int32 var_1654 = 0;
    wp::float32 var_1655;
    const wp::int32 var_1656 = 0;
    wp::float32 var_1657;
    wp::float32 var_1658;
    const wp::int32 var_1659 = 1;
    wp::float32 var_1660;
    const wp::int32 var_1661 = 1;
    wp::float32 var_1662;
    wp::float32 var_1663;
    wp::float32 var_1664;
    const wp::int32 var_1665 = 2;
    wp::float32 var_1666;
    const wp::int32 var_1667 = 2;
    wp::float32 var_1668;
    wp::float32 var_1669;
    wp::float32 var_1670;
    bool var_1671;
    wp::vec_t<3, wp::float32> var_1672;
    wp::float32 var_1673;
    wp::int32 var_1674;
    wp::vec_t<3, wp::float32> var_1675;
    wp::float32 var_1676;
    wp::int32 var_1677;
    wp::vec_t<3, wp::float32> var_1678;
    wp::vec_t<3, wp::float32> var_1679;
    wp::int32 var_1680;
    wp::int32 var_1681;
    wp::int32 var_1682;
    wp::vec_t<3, wp::float32> var_1683;
    wp::vec_t<3, wp::float32> var_1684;
    wp::int32 var_1685;
    wp::int32 var_1686;
    const wp::int32 var_1687 = 2;
    const wp::int32 var_1688 = 0;
    wp::int32 var_1689;
    wp::int32 var_1690;
    const wp::int32 var_1691 = 0;
    wp::float32 var_1692;
    wp::float32 var_1693;
    wp::float32 var_1694;
    wp::float32 var_1695;
    wp::float32 var_1696;
    wp::float32 var_1697;
    wp::float32 var_1698;
    bool var_1699;
    const wp::int32 var_1700 = 0;
    wp::int32 var_1701;
    wp::int32 var_1702;
    const wp::int32 var_1703 = 1;
    wp::int32 var_1704;
    wp::int32 var_1705;
    const wp::int32 var_1706 = 2;
    wp::int32 var_1707;
    wp::int32 var_1708;
    wp::int64 var_1709;
    wp::int32 var_1710;
    const wp::int32 var_1711 = 0;
    bool var_1712;
    wp::float32 var_1713;
    wp::float32 var_1714;
    wp::float32 var_1715;
    wp::float32 var_1716;
    wp::float32 var_1717;
    wp::float32 var_1718;
    wp::vec_t<3, wp::float32> var_1719;
    wp::vec_t<3, wp::float32> var_1720;
    wp::int32 var_1721;
    wp::int32* var_1722;
    wp::int32 var_1723;
    wp::int32 var_1724;
    wp::range_t var_1725;
    wp::int32 var_1726;
    wp::vec_t<3, wp::float32>* var_1727;
    wp::vec_t<3, wp::float32> var_1728;
    wp::vec_t<3, wp::float32> var_1729;
    const wp::int32 var_1730 = 0;
    wp::float32 var_1731;
    const wp::int32 var_1732 = 0;
    wp::float32 var_1733;
    wp::float32 var_1734;
    const wp::int32 var_1735 = 1;
    wp::float32 var_1736;
    const wp::int32 var_1737 = 1;
    wp::float32 var_1738;
    wp::float32 var_1739;
    wp::float32 var_1740;
    const wp::int32 var_1741 = 2;
    wp::float32 var_1742;
    const wp::int32 var_1743 = 2;
    wp::float32 var_1744;
    wp::float32 var_1745;
    wp::float32 var_1746;
    bool var_1747;
    wp::vec_t<3, wp::float32> var_1748;
    wp::float32 var_1749;
    wp::int32 var_1750;
    wp::vec_t<3, wp::float32> var_1751;
    wp::float32 var_1752;
    wp::int32 var_1753;
    wp::vec_t<3, wp::float32> var_1754;
    wp::vec_t<3, wp::float32> var_1755;
    wp::int32 var_1756;
    wp::int32 var_1757;
    wp::int32 var_1758;
    wp::vec_t<3, wp::float32> var_1759;
    wp::vec_t<3, wp::float32> var_1760;
    wp::int32 var_1761;
    wp::int32 var_1762;
    wp::int32 var_1763;
    wp::int32 var_1764;
    wp::float32 var_1765;
    wp::int32 var_1766;
    wp::vec_t<3, wp::float32> var_1767;
    wp::vec_t<3, wp::float32> var_1768;
    wp::int32 var_1769;
    wp::int32 var_1770;
    const wp::int32 var_1771 = 1;
    const wp::int32 var_1772 = 1;
    wp::int32 var_1773;
    wp::int32 var_1774;
    const wp::int32 var_1775 = 1;
    wp::float32 var_1776;
    wp::float32 var_1777;
    wp::float32 var_1778;
    wp::float32 var_1779;
    wp::float32 var_1780;
    bool var_1781;
    const wp::int32 var_1782 = 0;
    const wp::int32 var_1783 = 0;
    wp::int32 var_1784;
    wp::int32 var_1785;
    const wp::int32 var_1786 = 0;
    wp::float32 var_1787;
    wp::float32 var_1788;
    wp::float32 var_1789;
    wp::float32 var_1790;
    wp::float32 var_1791;
    wp::float32 var_1792;
    wp::float32 var_1793;
    bool var_1794;
    const wp::int32 var_1795 = 0;
    wp::int32 var_1796;
    wp::int32 var_1797;
    const wp::int32 var_1798 = 1;
    wp::int32 var_1799;
    wp::int32 var_1800;
    const wp::int32 var_1801 = 2;
    wp::int32 var_1802;
    wp::int32 var_1803;
    wp::int64 var_1804;
    wp::int32 var_1805;
    const wp::int32 var_1806 = 0;
    bool var_1807;
    wp::float32 var_1808;
    wp::float32 var_1809;
    wp::float32 var_1810;
    wp::float32 var_1811;
    wp::float32 var_1812;
    wp::float32 var_1813;
    wp::vec_t<3, wp::float32> var_1814;
    wp::vec_t<3, wp::float32> var_1815;
    wp::int32 var_1816;
    wp::int32* var_1817;
    wp::int32 var_1818;
    wp::int32 var_1819;
    wp::range_t var_1820;
    wp::int32 var_1821;
    wp::vec_t<3, wp::float32>* var_1822;
    wp::vec_t<3, wp::float32> var_1823;
    wp::vec_t<3, wp::float32> var_1824;
    const wp::int32 var_1825 = 0;
    wp::float32 var_1826;
    const wp::int32 var_1827 = 0;
    wp::float32 var_1828;
    wp::float32 var_1829;
    const wp::int32 var_1830 = 1;
    wp::float32 var_1831;
    const wp::int32 var_1832 = 1;
    wp::float32 var_1833;
    wp::float32 var_1834;
    wp::float32 var_1835;
    const wp::int32 var_1836 = 2;
    wp::float32 var_1837;
    const wp::int32 var_1838 = 2;
    wp::float32 var_1839;
    wp::float32 var_1840;
    wp::float32 var_1841;
    bool var_1842;
    wp::vec_t<3, wp::float32> var_1843;
    wp::float32 var_1844;
    wp::int32 var_1845;
    wp::vec_t<3, wp::float32> var_1846;
    wp::float32 var_1847;
    wp::int32 var_1848;
    wp::vec_t<3, wp::float32> var_1849;
    wp::vec_t<3, wp::float32> var_1850;
    wp::int32 var_1851;
    wp::int32 var_1852;
    wp::int32 var_1853;
    wp::vec_t<3, wp::float32> var_1854;
    wp::vec_t<3, wp::float32> var_1855;
    wp::int32 var_1856;
    wp::int32 var_1857;
    const wp::int32 var_1858 = 1;
    const wp::int32 var_1859 = 0;
    wp::int32 var_1860;
    wp::int32 var_1861;
    const wp::int32 var_1862 = 0;
    wp::float32 var_1863;
    wp::float32 var_1864;
    wp::float32 var_1865;
    wp::float32 var_1866;
    wp::float32 var_1867;
    wp::float32 var_1868;
    wp::float32 var_1869;
    bool var_1870;
    const wp::int32 var_1871 = 0;
    wp::int32 var_1872;
    wp::int32 var_1873;
    const wp::int32 var_1874 = 1;
    wp::int32 var_1875;
    wp::int32 var_1876;
    const wp::int32 var_1877 = 2;
    wp::int32 var_1878;
    wp::int32 var_1879;
    wp::int64 var_1880;
    wp::int32 var_1881;
    const wp::int32 var_1882 = 0;
    bool var_1883;
    wp::float32 var_1884;
    wp::float32 var_1885;
    wp::float32 var_1886;
    wp::float32 var_1887;
    wp::float32 var_1888;
    wp::float32 var_1889;
    wp::vec_t<3, wp::float32> var_1890;
    wp::vec_t<3, wp::float32> var_1891;
    wp::int32 var_1892;
    wp::int32* var_1893;
    wp::int32 var_1894;
    wp::int32 var_1895;
    wp::range_t var_1896;
    wp::int32 var_1897;
    wp::vec_t<3, wp::float32>* var_1898;
    wp::vec_t<3, wp::float32> var_1899;
    wp::vec_t<3, wp::float32> var_1900;
    const wp::int32 var_1901 = 0;
    wp::float32 var_1902;
    const wp::int32 var_1903 = 0;
    wp::float32 var_1904;
    wp::float32 var_1905;
    const wp::int32 var_1906 = 1;
    wp::float32 var_1907;
    const wp::int32 var_1908 = 1;
    wp::float32 var_1909;
    wp::float32 var_1910;
    wp::float32 var_1911;
    const wp::int32 var_1912 = 2;
    wp::float32 var_1913;
    const wp::int32 var_1914 = 2;
    wp::float32 var_1915;
    wp::float32 var_1916;
    wp::float32 var_1917;
    bool var_1918;
    wp::vec_t<3, wp::float32> var_1919;
    wp::float32 var_1920;
    wp::int32 var_1921;
    wp::vec_t<3, wp::float32> var_1922;
    wp::float32 var_1923;
    wp::int32 var_1924;
    wp::vec_t<3, wp::float32> var_1925;
    wp::vec_t<3, wp::float32> var_1926;
    wp::int32 var_1927;
    wp::int32 var_1928;
    wp::int32 var_1929;
    wp::vec_t<3, wp::float32> var_1930;
    wp::vec_t<3, wp::float32> var_1931;
    wp::int32 var_1932;
    wp::int32 var_1933;
    const wp::int32 var_1934 = 2;
    const wp::int32 var_1935 = 0;
    wp::int32 var_1936;
    wp::int32 var_1937;
    const wp::int32 var_1938 = 0;
    wp::float32 var_1939;
    wp::float32 var_1940;
    wp::float32 var_1941;
    wp::float32 var_1942;
    wp::float32 var_1943;
    wp::float32 var_1944;
    wp::float32 var_1945;
    bool var_1946;
    const wp::int32 var_1947 = 0;
    wp::int32 var_1948;
    wp::int32 var_1949;
    const wp::int32 var_1950 = 1;
    wp::int32 var_1951;
    wp::int32 var_1952;
    const wp::int32 var_1953 = 2;
    wp::int32 var_1954;
    wp::int32 var_1955;
    wp::int64 var_1956;
    wp::int32 var_1957;
    const wp::int32 var_1958 = 0;
    bool var_1959;
    wp::float32 var_1960;
    wp::float32 var_1961;
    wp::float32 var_1962;
    wp::float32 var_1963;
    wp::float32 var_1964;
    wp::float32 var_1965;
    wp::vec_t<3, wp::float32> var_1966;
    wp::vec_t<3, wp::float32> var_1967;
    wp::int32 var_1968;
    wp::int32* var_1969;
    wp::int32 var_1970;
    wp::int32 var_1971;
    wp::range_t var_1972;
    wp::int32 var_1973;
    wp::vec_t<3, wp::float32>* var_1974;
    wp::vec_t<3, wp::float32> var_1975;
    wp::vec_t<3, wp::float32> var_1976;
    const wp::int32 var_1977 = 0;
    wp::float32 var_1978;
    const wp::int32 var_1979 = 0;
    wp::float32 var_1980;
    wp::float32 var_1981;
    const wp::int32 var_1982 = 1;
    wp::float32 var_1983;
    const wp::int32 var_1984 = 1;
    wp::float32 var_1985;
    wp::float32 var_1986;
    wp::float32 var_1987;
    const wp::int32 var_1988 = 2;
    wp::float32 var_1989;
    const wp::int32 var_1990 = 2;
    wp::float32 var_1991;
    wp::float32 var_1992;
    wp::float32 var_1993;
    bool var_1994;
    wp::vec_t<3, wp::float32> var_1995;
    wp::float32 var_1996;
    wp::int32 var_1997;
    wp::vec_t<3, wp::float32> var_1998;
    wp::float32 var_1999;
    wp::int32 var_2000;
    wp::vec_t<3, wp::float32> var_2001;
    wp::vec_t<3, wp::float32> var_2002;
    wp::int32 var_2003;
    wp::int32 var_2004;
    wp::int32 var_2005;
    wp::vec_t<3, wp::float32> var_2006;
    wp::vec_t<3, wp::float32> var_2007;
    wp::int32 var_2008;
    wp::int32 var_2009;
    wp::int32 var_2010;
    wp::int32 var_2011;
    wp::float32 var_2012;
    wp::int32 var_2013;
    wp::vec_t<3, wp::float32> var_2014;
    wp::vec_t<3, wp::float32> var_2015;
    wp::int32 var_2016;
    wp::int32 var_2017;
    const wp::int32 var_2018 = 2;
    const wp::int32 var_2019 = 1;
    wp::int32 var_2020;
    wp::int32 var_2021;
    const wp::int32 var_2022 = 1;
    wp::float32 var_2023;
    wp::float32 var_2024;
    wp::float32 var_2025;
    wp::float32 var_2026;
    wp::float32 var_2027;
    bool var_2028;
    const wp::int32 var_2029 = 0;
    const wp::int32 var_2030 = 0;
    wp::int32 var_2031;
    wp::int32 var_2032;
    const wp::int32 var_2033 = 0;
    wp::float32 var_2034;
    wp::float32 var_2035;
    wp::float32 var_2036;
    wp::float32 var_2037;
    wp::float32 var_2038;
    wp::float32 var_2039;
    wp::float32 var_2040;
    bool var_2041;
    const wp::int32 var_2042 = 0;
    wp::int32 var_2043;
    wp::int32 var_2044;
    const wp::int32 var_2045 = 1;
    wp::int32 var_2046;
    wp::int32 var_2047;
    const wp::int32 var_2048 = 2;
    wp::int32 var_2049;
    wp::int32 var_2050;
    wp::int64 var_2051;
    wp::int32 var_2052;
    const wp::int32 var_2053 = 0;
    bool var_2054;
    wp::float32 var_2055;
    wp::float32 var_2056;
    wp::float32 var_2057;
    wp::float32 var_2058;
    wp::float32 var_2059;
    wp::float32 var_2060;
    wp::vec_t<3, wp::float32> var_2061;
    wp::vec_t<3, wp::float32> var_2062;
    wp::int32 var_2063;
    wp::int32* var_2064;
    wp::int32 var_2065;
    wp::int32 var_2066;
    wp::range_t var_2067;
    wp::int32 var_2068;
    wp::vec_t<3, wp::float32>* var_2069;
    wp::vec_t<3, wp::float32> var_2070;
    wp::vec_t<3, wp::float32> var_2071;
    const wp::int32 var_2072 = 0;
    wp::float32 var_2073;
    const wp::int32 var_2074 = 0;
    wp::float32 var_2075;
    wp::float32 var_2076;
    const wp::int32 var_2077 = 1;
    wp::float32 var_2078;
    const wp::int32 var_2079 = 1;
    wp::float32 var_2080;
    wp::float32 var_2081;
    wp::float32 var_2082;
    const wp::int32 var_2083 = 2;
    wp::float32 var_2084;
    const wp::int32 var_2085 = 2;
    wp::float32 var_2086;
    wp::float32 var_2087;
    wp::float32 var_2088;
    bool var_2089;
    wp::vec_t<3, wp::float32> var_2090;
    wp::float32 var_2091;
    wp::int32 var_2092;
    wp::vec_t<3, wp::float32> var_2093;
    wp::float32 var_2094;
    wp::int32 var_2095;
    wp::vec_t<3, wp::float32> var_2096;
    wp::vec_t<3, wp::float32> var_2097;
    wp::int32 var_2098;
    wp::int32 var_2099;
    wp::int32 var_2100;
    wp::vec_t<3, wp::float32> var_2101;
    wp::vec_t<3, wp::float32> var_2102;
    wp::int32 var_2103;
    wp::int32 var_2104;
    const wp::int32 var_2105 = 1;
    const wp::int32 var_2106 = 0;
    wp::int32 var_2107;
    wp::int32 var_2108;
    const wp::int32 var_2109 = 0;
    wp::float32 var_2110;
    wp::float32 var_2111;
    wp::float32 var_2112;
    wp::float32 var_2113;
    wp::float32 var_2114;
    wp::float32 var_2115;
    wp::float32 var_2116;
    bool var_2117;
    const wp::int32 var_2118 = 0;
    wp::int32 var_2119;
    wp::int32 var_2120;
    const wp::int32 var_2121 = 1;
    wp::int32 var_2122;
    wp::int32 var_2123;
    const wp::int32 var_2124 = 2;
    wp::int32 var_2125;
    wp::int32 var_2126;
    wp::int64 var_2127;
    wp::int32 var_2128;
    const wp::int32 var_2129 = 0;
    bool var_2130;
    wp::float32 var_2131;
    wp::float32 var_2132;
    wp::float32 var_2133;
    wp::float32 var_2134;
    wp::float32 var_2135;
    wp::float32 var_2136;
    wp::vec_t<3, wp::float32> var_2137;
    wp::vec_t<3, wp::float32> var_2138;
    wp::int32 var_2139;
    wp::int32* var_2140;
    wp::int32 var_2141;
    wp::int32 var_2142;
    wp::range_t var_2143;
    wp::int32 var_2144;
    wp::vec_t<3, wp::float32>* var_2145;
    wp::vec_t<3, wp::float32> var_2146;
    wp::vec_t<3, wp::float32> var_2147;
    const wp::int32 var_2148 = 0;
    wp::float32 var_2149;
    const wp::int32 var_2150 = 0;
    wp::float32 var_2151;
    wp::float32 var_2152;
    const wp::int32 var_2153 = 1;
    wp::float32 var_2154;
    const wp::int32 var_2155 = 1;
    wp::float32 var_2156;
    wp::float32 var_2157;
    wp::float32 var_2158;
    const wp::int32 var_2159 = 2;
    wp::float32 var_2160;
    const wp::int32 var_2161 = 2;
    wp::float32 var_2162;
    wp::float32 var_2163;
    wp::float32 var_2164;
    bool var_2165;
    wp::vec_t<3, wp::float32> var_2166;
    wp::float32 var_2167;
    wp::int32 var_2168;
    wp::vec_t<3, wp::float32> var_2169;
    wp::float32 var_2170;
    wp::int32 var_2171;
    wp::vec_t<3, wp::float32> var_2172;
    wp::vec_t<3, wp::float32> var_2173;
    wp::int32 var_2174;
    wp::int32 var_2175;
    wp::int32 var_2176;
    wp::vec_t<3, wp::float32> var_2177;
    wp::vec_t<3, wp::float32> var_2178;
    wp::int32 var_2179;
    wp::int32 var_2180;
    const wp::int32 var_2181 = 2;
    const wp::int32 var_2182 = 0;
    wp::int32 var_2183;
    wp::int32 var_2184;
    const wp::int32 var_2185 = 0;
    wp::float32 var_2186;
    wp::float32 var_2187;
    wp::float32 var_2188;
    wp::float32 var_2189;
    wp::float32 var_2190;
    wp::float32 var_2191;
    wp::float32 var_2192;
    bool var_2193;
    const wp::int32 var_2194 = 0;
    wp::int32 var_2195;
    wp::int32 var_2196;
    const wp::int32 var_2197 = 1;
    wp::int32 var_2198;
    wp::int32 var_2199;
    const wp::int32 var_2200 = 2;
    wp::int32 var_2201;
    wp::int32 var_2202;
    wp::int64 var_2203;
    wp::int32 var_2204;
    const wp::int32 var_2205 = 0;
    bool var_2206;
    wp::float32 var_2207;
    wp::float32 var_2208;
    wp::float32 var_2209;
    wp::float32 var_2210;
    wp::float32 var_2211;
    wp::float32 var_2212;
    wp::vec_t<3, wp::float32> var_2213;
    wp::vec_t<3, wp::float32> var_2214;
    wp::int32 var_2215;
    wp::int32* var_2216;
    wp::int32 var_2217;
    wp::int32 var_2218;
    wp::range_t var_2219;
    wp::int32 var_2220;
    wp::vec_t<3, wp::float32>* var_2221;
    wp::vec_t<3, wp::float32> var_2222;
    wp::vec_t<3, wp::float32> var_2223;
    const wp::int32 var_2224 = 0;
    wp::float32 var_2225;
    const wp::int32 var_2226 = 0;
    wp::float32 var_2227;
    wp::float32 var_2228;
    const wp::int32 var_2229 = 1;
    wp::float32 var_2230;
    const wp::int32 var_2231 = 1;
    wp::float32 var_2232;
    wp::float32 var_2233;
    wp::float32 var_2234;
    const wp::int32 var_2235 = 2;
    wp::float32 var_2236;
    const wp::int32 var_2237 = 2;
    wp::float32 var_2238;
    wp::float32 var_2239;
    wp::float32 var_2240;
    bool var_2241;
    wp::vec_t<3, wp::float32> var_2242;
    wp::float32 var_2243;
    wp::int32 var_2244;
    wp::vec_t<3, wp::float32> var_2245;
    wp::float32 var_2246;
    wp::int32 var_2247;
    wp::vec_t<3, wp::float32> var_2248;
    wp::vec_t<3, wp::float32> var_2249;
    wp::int32 var_2250;
    wp::int32 var_2251;
    wp::int32 var_2252;
    wp::vec_t<3, wp::float32> var_2253;
    wp::vec_t<3, wp::float32> var_2254;
    wp::int32 var_2255;
    wp::int32 var_2256;
    wp::int32 var_2257;
    wp::int32 var_2258;
    wp::float32 var_2259;
    wp::int32 var_2260;
    wp::vec_t<3, wp::float32> var_2261;
    wp::vec_t<3, wp::float32> var_2262;
    wp::int32 var_2263;
    wp::int32 var_2264;
    wp::int32 var_2265;
    wp::int32 var_2266;
    wp::float32 var_2267;
    wp::int32 var_2268;
    wp::int32 var_2269;
    wp::float32 var_2270;
    wp::int32 var_2271;
    wp::vec_t<3, wp::float32> var_2272;
    wp::vec_t<3, wp::float32> var_2273;
    wp::int32 var_2274;
    wp::int32 var_2275;
    const wp::int32 var_2276 = 0;
    wp::float32 var_2277;
    wp::float64 var_2278;
    const wp::int32 var_2279 = 1;
    wp::float32 var_2280;
    wp::float64 var_2281;
    const wp::int32 var_2282 = 2;
    wp::float32 var_2283;
    wp::float64 var_2284;
    wp::float64 var_2285;
    wp::float64 var_2286;
    wp::vec_t<5, wp::float64> var_2287;
    //---------
    // forward
    // def find_nearest_in_map(x, limit, voxel_map__voxel_size, voxel_map__room, voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask, voxel_map__counts, voxel_map__offsets):       <L 1>
    // cell = cell_holding(x, voxel_map__voxel_size)                                          <L 3>
    var_0 = cell_holding_0(var_x, var_voxel_map__voxel_size);
    // position = offset_in_cell(x, cell, voxel_map__voxel_size)                              <L 4>
    var_1 = offset_in_cell_0(var_x, var_0, var_voxel_map__voxel_size);
    // edge = float(voxel_map__voxel_size)                                                    <L 5>
    var_2 = wp::float(var_voxel_map__voxel_size);
    // near = vec3i(nearer_side(position[0], edge), nearer_side(position[1], edge), nearer_side(position[2], edge))       <L 6>
    var_4 = wp::extract(var_1, var_3);
    var_5 = nearer_side_0(var_4, var_2);
    var_7 = wp::extract(var_1, var_6);
    var_8 = nearer_side_0(var_7, var_2);
    var_10 = wp::extract(var_1, var_9);
    var_11 = nearer_side_0(var_10, var_2);
    var_12 = wp::vec_t<3, wp::int32>(var_5, var_8, var_11);
    // best = vec3(0.0, 0.0, 0.0)                                                             <L 7>
    var_16 = wp::vec_t<3, wp::float32>(var_13, var_14, var_15);
    // min_sqdist = limit                                                                     <L 8>
    var_17 = wp::copy(var_limit);
    // nearest = int(-1)                                                                      <L 9>
    var_19 = wp::int(var_18);
    // edge__voxels_around__1 = float(voxel_map__voxel_size)                                  <L 10>
    var_20 = wp::float(var_voxel_map__voxel_size);
    // for z__voxels_around__1 in range(3):                                                   <L 11>
    // sz__voxels_around__1 = side_of(z__voxels_around__1, near[2])                           <L 12>
    var_23 = wp::extract(var_12, var_22);
    var_24 = side_of_0(var_21, var_23);
    // gz__voxels_around__1 = gap_to(position[2], sz__voxels_around__1, edge__voxels_around__1)       <L 13>
    var_26 = wp::extract(var_1, var_25);
    var_27 = gap_to_0(var_26, var_24, var_20);
    // if gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:                           <L 14>
    var_28 = wp::mul(var_27, var_27);
    var_29 = (var_28 < var_17);
    if (var_29) {
        // for y__voxels_around__1 in range(3):                                               <L 15>
        // sy__voxels_around__1 = side_of(y__voxels_around__1, near[1])                       <L 16>
        var_32 = wp::extract(var_12, var_31);
        var_33 = side_of_0(var_30, var_32);
        // gy__voxels_around__1 = gap_to(position[1], sy__voxels_around__1, edge__voxels_around__1)       <L 17>
        var_35 = wp::extract(var_1, var_34);
        var_36 = gap_to_0(var_35, var_33, var_20);
        // if gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:       <L 18>
        var_37 = wp::mul(var_36, var_36);
        var_38 = wp::mul(var_27, var_27);
        var_39 = wp::add(var_37, var_38);
        var_40 = (var_39 < var_17);
        if (var_40) {
            // for x__voxels_around__1 in range(3):                                           <L 19>
            // sx__voxels_around__1 = side_of(x__voxels_around__1, near[0])                   <L 20>
            var_43 = wp::extract(var_12, var_42);
            var_44 = side_of_0(var_41, var_43);
            // gx__voxels_around__1 = gap_to(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 21>
            var_46 = wp::extract(var_1, var_45);
            var_47 = gap_to_0(var_46, var_44, var_20);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:       <L 22>
            var_48 = wp::mul(var_47, var_47);
            var_49 = wp::mul(var_36, var_36);
            var_50 = wp::add(var_48, var_49);
            var_51 = wp::mul(var_27, var_27);
            var_52 = wp::add(var_50, var_51);
            var_53 = (var_52 < var_17);
            if (var_53) {
                // voxel = find_position(block_key(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 23>
                var_55 = wp::extract(var_0, var_54);
                var_56 = wp::add(var_55, var_44);
                var_58 = wp::extract(var_0, var_57);
                var_59 = wp::add(var_58, var_33);
                var_61 = wp::extract(var_0, var_60);
                var_62 = wp::add(var_61, var_24);
                var_63 = block_key_0(var_56, var_59, var_62);
                var_64 = find_position_0(var_63, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 24>
                var_66 = (var_64 >= var_65);
                if (var_66) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 25>
                    var_67 = wp::float(var_44);
                    var_68 = wp::mul(var_67, var_20);
                    var_69 = wp::float(var_33);
                    var_70 = wp::mul(var_69, var_20);
                    var_71 = wp::float(var_24);
                    var_72 = wp::mul(var_71, var_20);
                    var_73 = wp::vec_t<3, wp::float32>(var_68, var_70, var_72);
                    // q = position - shift                                                   <L 26>
                    var_74 = wp::sub(var_1, var_73);
                    // first = voxel * voxel_map__room                                        <L 27>
                    var_75 = wp::mul(var_64, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 28>
                    var_76 = wp::address(var_voxel_map__counts, var_64);
                    var_78 = wp::load(var_76);
                    var_77 = wp::add(var_75, var_78);
                    var_79 = wp::range(var_75, var_77);
                    start_for_0:;
                        if (iter_cmp(var_79) == 0) goto end_for_0;
                        var_80 = wp::iter_next(var_79);
                        // d = q - voxel_map__offsets[slot]                                   <L 29>
                        var_81 = wp::address(var_voxel_map__offsets, var_80);
                        var_83 = wp::load(var_81);
                        var_82 = wp::sub(var_74, var_83);
                        // sqdist = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]                   <L 30>
                        var_85 = wp::extract(var_82, var_84);
                        var_87 = wp::extract(var_82, var_86);
                        var_88 = wp::mul(var_85, var_87);
                        var_90 = wp::extract(var_82, var_89);
                        var_92 = wp::extract(var_82, var_91);
                        var_93 = wp::mul(var_90, var_92);
                        var_94 = wp::add(var_88, var_93);
                        var_96 = wp::extract(var_82, var_95);
                        var_98 = wp::extract(var_82, var_97);
                        var_99 = wp::mul(var_96, var_98);
                        var_100 = wp::add(var_94, var_99);
                        // if sqdist < min_sqdist:                                            <L 31>
                        var_101 = (var_100 < var_17);
                        if (var_101) {
                            // best = d                                                       <L 32>
                            var_102 = wp::copy(var_82);
                            // min_sqdist = sqdist                                            <L 33>
                            var_103 = wp::copy(var_100);
                            // nearest = slot                                                 <L 34>
                            var_104 = wp::copy(var_80);
                        }
                        var_105 = wp::where(var_101, var_102, var_16);
                        var_106 = wp::where(var_101, var_103, var_17);
                        var_107 = wp::where(var_101, var_104, var_19);
                        wp::assign(var_16, var_105);
                        wp::assign(var_17, var_106);
                        wp::assign(var_19, var_107);
                        goto start_for_0;
                    end_for_0:;
                }
            }
            // sx__voxels_around__1 = side_of(x__voxels_around__1, near[0])                   <L 20>
            var_110 = wp::extract(var_12, var_109);
            var_111 = side_of_0(var_108, var_110);
            // gx__voxels_around__1 = gap_to(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 21>
            var_113 = wp::extract(var_1, var_112);
            var_114 = gap_to_0(var_113, var_111, var_20);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:       <L 22>
            var_115 = wp::mul(var_114, var_114);
            var_116 = wp::mul(var_36, var_36);
            var_117 = wp::add(var_115, var_116);
            var_118 = wp::mul(var_27, var_27);
            var_119 = wp::add(var_117, var_118);
            var_120 = (var_119 < var_17);
            if (var_120) {
                // voxel = find_position(block_key(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 23>
                var_122 = wp::extract(var_0, var_121);
                var_123 = wp::add(var_122, var_111);
                var_125 = wp::extract(var_0, var_124);
                var_126 = wp::add(var_125, var_33);
                var_128 = wp::extract(var_0, var_127);
                var_129 = wp::add(var_128, var_24);
                var_130 = block_key_0(var_123, var_126, var_129);
                var_131 = find_position_0(var_130, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 24>
                var_133 = (var_131 >= var_132);
                if (var_133) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 25>
                    var_134 = wp::float(var_111);
                    var_135 = wp::mul(var_134, var_20);
                    var_136 = wp::float(var_33);
                    var_137 = wp::mul(var_136, var_20);
                    var_138 = wp::float(var_24);
                    var_139 = wp::mul(var_138, var_20);
                    var_140 = wp::vec_t<3, wp::float32>(var_135, var_137, var_139);
                    // q = position - shift                                                   <L 26>
                    var_141 = wp::sub(var_1, var_140);
                    // first = voxel * voxel_map__room                                        <L 27>
                    var_142 = wp::mul(var_131, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 28>
                    var_143 = wp::address(var_voxel_map__counts, var_131);
                    var_145 = wp::load(var_143);
                    var_144 = wp::add(var_142, var_145);
                    var_146 = wp::range(var_142, var_144);
                    start_for_2:;
                        if (iter_cmp(var_146) == 0) goto end_for_2;
                        var_147 = wp::iter_next(var_146);
                        // d = q - voxel_map__offsets[slot]                                   <L 29>
                        var_148 = wp::address(var_voxel_map__offsets, var_147);
                        var_150 = wp::load(var_148);
                        var_149 = wp::sub(var_141, var_150);
                        // sqdist = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]                   <L 30>
                        var_152 = wp::extract(var_149, var_151);
                        var_154 = wp::extract(var_149, var_153);
                        var_155 = wp::mul(var_152, var_154);
                        var_157 = wp::extract(var_149, var_156);
                        var_159 = wp::extract(var_149, var_158);
                        var_160 = wp::mul(var_157, var_159);
                        var_161 = wp::add(var_155, var_160);
                        var_163 = wp::extract(var_149, var_162);
                        var_165 = wp::extract(var_149, var_164);
                        var_166 = wp::mul(var_163, var_165);
                        var_167 = wp::add(var_161, var_166);
                        // if sqdist < min_sqdist:                                            <L 31>
                        var_168 = (var_167 < var_17);
                        if (var_168) {
                            // best = d                                                       <L 32>
                            var_169 = wp::copy(var_149);
                            // min_sqdist = sqdist                                            <L 33>
                            var_170 = wp::copy(var_167);
                            // nearest = slot                                                 <L 34>
                            var_171 = wp::copy(var_147);
                        }
                        var_172 = wp::where(var_168, var_169, var_16);
                        var_173 = wp::where(var_168, var_170, var_17);
                        var_174 = wp::where(var_168, var_171, var_19);
                        wp::assign(var_16, var_172);
                        wp::assign(var_17, var_173);
                        wp::assign(var_19, var_174);
                        wp::assign(var_82, var_149);
                        wp::assign(var_100, var_167);
                        goto start_for_2;
                    end_for_2:;
                }
                var_175 = wp::where(var_133, var_140, var_73);
                var_176 = wp::where(var_133, var_141, var_74);
                var_177 = wp::where(var_133, var_142, var_75);
                var_178 = wp::where(var_133, var_147, var_80);
            }
            var_179 = wp::where(var_120, var_131, var_64);
            var_180 = wp::where(var_120, var_175, var_73);
            var_181 = wp::where(var_120, var_176, var_74);
            var_182 = wp::where(var_120, var_177, var_75);
            var_183 = wp::where(var_120, var_178, var_80);
            // sx__voxels_around__1 = side_of(x__voxels_around__1, near[0])                   <L 20>
            var_186 = wp::extract(var_12, var_185);
            var_187 = side_of_0(var_184, var_186);
            // gx__voxels_around__1 = gap_to(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 21>
            var_189 = wp::extract(var_1, var_188);
            var_190 = gap_to_0(var_189, var_187, var_20);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:       <L 22>
            var_191 = wp::mul(var_190, var_190);
            var_192 = wp::mul(var_36, var_36);
            var_193 = wp::add(var_191, var_192);
            var_194 = wp::mul(var_27, var_27);
            var_195 = wp::add(var_193, var_194);
            var_196 = (var_195 < var_17);
            if (var_196) {
                // voxel = find_position(block_key(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 23>
                var_198 = wp::extract(var_0, var_197);
                var_199 = wp::add(var_198, var_187);
                var_201 = wp::extract(var_0, var_200);
                var_202 = wp::add(var_201, var_33);
                var_204 = wp::extract(var_0, var_203);
                var_205 = wp::add(var_204, var_24);
                var_206 = block_key_0(var_199, var_202, var_205);
                var_207 = find_position_0(var_206, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 24>
                var_209 = (var_207 >= var_208);
                if (var_209) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 25>
                    var_210 = wp::float(var_187);
                    var_211 = wp::mul(var_210, var_20);
                    var_212 = wp::float(var_33);
                    var_213 = wp::mul(var_212, var_20);
                    var_214 = wp::float(var_24);
                    var_215 = wp::mul(var_214, var_20);
                    var_216 = wp::vec_t<3, wp::float32>(var_211, var_213, var_215);
                    // q = position - shift                                                   <L 26>
                    var_217 = wp::sub(var_1, var_216);
                    // first = voxel * voxel_map__room                                        <L 27>
                    var_218 = wp::mul(var_207, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 28>
                    var_219 = wp::address(var_voxel_map__counts, var_207);
                    var_221 = wp::load(var_219);
                    var_220 = wp::add(var_218, var_221);
                    var_222 = wp::range(var_218, var_220);
                    start_for_4:;
                        if (iter_cmp(var_222) == 0) goto end_for_4;
                        var_223 = wp::iter_next(var_222);
                        // d = q - voxel_map__offsets[slot]                                   <L 29>
                        var_224 = wp::address(var_voxel_map__offsets, var_223);
                        var_226 = wp::load(var_224);
                        var_225 = wp::sub(var_217, var_226);
                        // sqdist = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]                   <L 30>
                        var_228 = wp::extract(var_225, var_227);
                        var_230 = wp::extract(var_225, var_229);
                        var_231 = wp::mul(var_228, var_230);
                        var_233 = wp::extract(var_225, var_232);
                        var_235 = wp::extract(var_225, var_234);
                        var_236 = wp::mul(var_233, var_235);
                        var_237 = wp::add(var_231, var_236);
                        var_239 = wp::extract(var_225, var_238);
                        var_241 = wp::extract(var_225, var_240);
                        var_242 = wp::mul(var_239, var_241);
                        var_243 = wp::add(var_237, var_242);
                        // if sqdist < min_sqdist:                                            <L 31>
                        var_244 = (var_243 < var_17);
                        if (var_244) {
                            // best = d                                                       <L 32>
                            var_245 = wp::copy(var_225);
                            // min_sqdist = sqdist                                            <L 33>
                            var_246 = wp::copy(var_243);
                            // nearest = slot                                                 <L 34>
                            var_247 = wp::copy(var_223);
                        }
                        var_248 = wp::where(var_244, var_245, var_16);
                        var_249 = wp::where(var_244, var_246, var_17);
                        var_250 = wp::where(var_244, var_247, var_19);
                        wp::assign(var_16, var_248);
                        wp::assign(var_17, var_249);
                        wp::assign(var_19, var_250);
                        wp::assign(var_82, var_225);
                        wp::assign(var_100, var_243);
                        goto start_for_4;
                    end_for_4:;
                }
                var_251 = wp::where(var_209, var_216, var_180);
                var_252 = wp::where(var_209, var_217, var_181);
                var_253 = wp::where(var_209, var_218, var_182);
                var_254 = wp::where(var_209, var_223, var_183);
            }
            var_255 = wp::where(var_196, var_207, var_179);
            var_256 = wp::where(var_196, var_251, var_180);
            var_257 = wp::where(var_196, var_252, var_181);
            var_258 = wp::where(var_196, var_253, var_182);
            var_259 = wp::where(var_196, var_254, var_183);
        }
        // sy__voxels_around__1 = side_of(y__voxels_around__1, near[1])                       <L 16>
        var_262 = wp::extract(var_12, var_261);
        var_263 = side_of_0(var_260, var_262);
        // gy__voxels_around__1 = gap_to(position[1], sy__voxels_around__1, edge__voxels_around__1)       <L 17>
        var_265 = wp::extract(var_1, var_264);
        var_266 = gap_to_0(var_265, var_263, var_20);
        // if gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:       <L 18>
        var_267 = wp::mul(var_266, var_266);
        var_268 = wp::mul(var_27, var_27);
        var_269 = wp::add(var_267, var_268);
        var_270 = (var_269 < var_17);
        if (var_270) {
            // for x__voxels_around__1 in range(3):                                           <L 19>
            // sx__voxels_around__1 = side_of(x__voxels_around__1, near[0])                   <L 20>
            var_273 = wp::extract(var_12, var_272);
            var_274 = side_of_0(var_271, var_273);
            // gx__voxels_around__1 = gap_to(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 21>
            var_276 = wp::extract(var_1, var_275);
            var_277 = gap_to_0(var_276, var_274, var_20);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:       <L 22>
            var_278 = wp::mul(var_277, var_277);
            var_279 = wp::mul(var_266, var_266);
            var_280 = wp::add(var_278, var_279);
            var_281 = wp::mul(var_27, var_27);
            var_282 = wp::add(var_280, var_281);
            var_283 = (var_282 < var_17);
            if (var_283) {
                // voxel = find_position(block_key(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 23>
                var_285 = wp::extract(var_0, var_284);
                var_286 = wp::add(var_285, var_274);
                var_288 = wp::extract(var_0, var_287);
                var_289 = wp::add(var_288, var_263);
                var_291 = wp::extract(var_0, var_290);
                var_292 = wp::add(var_291, var_24);
                var_293 = block_key_0(var_286, var_289, var_292);
                var_294 = find_position_0(var_293, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 24>
                var_296 = (var_294 >= var_295);
                if (var_296) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 25>
                    var_297 = wp::float(var_274);
                    var_298 = wp::mul(var_297, var_20);
                    var_299 = wp::float(var_263);
                    var_300 = wp::mul(var_299, var_20);
                    var_301 = wp::float(var_24);
                    var_302 = wp::mul(var_301, var_20);
                    var_303 = wp::vec_t<3, wp::float32>(var_298, var_300, var_302);
                    // q = position - shift                                                   <L 26>
                    var_304 = wp::sub(var_1, var_303);
                    // first = voxel * voxel_map__room                                        <L 27>
                    var_305 = wp::mul(var_294, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 28>
                    var_306 = wp::address(var_voxel_map__counts, var_294);
                    var_308 = wp::load(var_306);
                    var_307 = wp::add(var_305, var_308);
                    var_309 = wp::range(var_305, var_307);
                    start_for_6:;
                        if (iter_cmp(var_309) == 0) goto end_for_6;
                        var_310 = wp::iter_next(var_309);
                        // d = q - voxel_map__offsets[slot]                                   <L 29>
                        var_311 = wp::address(var_voxel_map__offsets, var_310);
                        var_313 = wp::load(var_311);
                        var_312 = wp::sub(var_304, var_313);
                        // sqdist = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]                   <L 30>
                        var_315 = wp::extract(var_312, var_314);
                        var_317 = wp::extract(var_312, var_316);
                        var_318 = wp::mul(var_315, var_317);
                        var_320 = wp::extract(var_312, var_319);
                        var_322 = wp::extract(var_312, var_321);
                        var_323 = wp::mul(var_320, var_322);
                        var_324 = wp::add(var_318, var_323);
                        var_326 = wp::extract(var_312, var_325);
                        var_328 = wp::extract(var_312, var_327);
                        var_329 = wp::mul(var_326, var_328);
                        var_330 = wp::add(var_324, var_329);
                        // if sqdist < min_sqdist:                                            <L 31>
                        var_331 = (var_330 < var_17);
                        if (var_331) {
                            // best = d                                                       <L 32>
                            var_332 = wp::copy(var_312);
                            // min_sqdist = sqdist                                            <L 33>
                            var_333 = wp::copy(var_330);
                            // nearest = slot                                                 <L 34>
                            var_334 = wp::copy(var_310);
                        }
                        var_335 = wp::where(var_331, var_332, var_16);
                        var_336 = wp::where(var_331, var_333, var_17);
                        var_337 = wp::where(var_331, var_334, var_19);
                        wp::assign(var_16, var_335);
                        wp::assign(var_17, var_336);
                        wp::assign(var_19, var_337);
                        wp::assign(var_82, var_312);
                        wp::assign(var_100, var_330);
                        goto start_for_6;
                    end_for_6:;
                }
                var_338 = wp::where(var_296, var_303, var_256);
                var_339 = wp::where(var_296, var_304, var_257);
                var_340 = wp::where(var_296, var_305, var_258);
                var_341 = wp::where(var_296, var_310, var_259);
            }
            var_342 = wp::where(var_283, var_294, var_255);
            var_343 = wp::where(var_283, var_338, var_256);
            var_344 = wp::where(var_283, var_339, var_257);
            var_345 = wp::where(var_283, var_340, var_258);
            var_346 = wp::where(var_283, var_341, var_259);
            // sx__voxels_around__1 = side_of(x__voxels_around__1, near[0])                   <L 20>
            var_349 = wp::extract(var_12, var_348);
            var_350 = side_of_0(var_347, var_349);
            // gx__voxels_around__1 = gap_to(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 21>
            var_352 = wp::extract(var_1, var_351);
            var_353 = gap_to_0(var_352, var_350, var_20);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:       <L 22>
            var_354 = wp::mul(var_353, var_353);
            var_355 = wp::mul(var_266, var_266);
            var_356 = wp::add(var_354, var_355);
            var_357 = wp::mul(var_27, var_27);
            var_358 = wp::add(var_356, var_357);
            var_359 = (var_358 < var_17);
            if (var_359) {
                // voxel = find_position(block_key(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 23>
                var_361 = wp::extract(var_0, var_360);
                var_362 = wp::add(var_361, var_350);
                var_364 = wp::extract(var_0, var_363);
                var_365 = wp::add(var_364, var_263);
                var_367 = wp::extract(var_0, var_366);
                var_368 = wp::add(var_367, var_24);
                var_369 = block_key_0(var_362, var_365, var_368);
                var_370 = find_position_0(var_369, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 24>
                var_372 = (var_370 >= var_371);
                if (var_372) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 25>
                    var_373 = wp::float(var_350);
                    var_374 = wp::mul(var_373, var_20);
                    var_375 = wp::float(var_263);
                    var_376 = wp::mul(var_375, var_20);
                    var_377 = wp::float(var_24);
                    var_378 = wp::mul(var_377, var_20);
                    var_379 = wp::vec_t<3, wp::float32>(var_374, var_376, var_378);
                    // q = position - shift                                                   <L 26>
                    var_380 = wp::sub(var_1, var_379);
                    // first = voxel * voxel_map__room                                        <L 27>
                    var_381 = wp::mul(var_370, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 28>
                    var_382 = wp::address(var_voxel_map__counts, var_370);
                    var_384 = wp::load(var_382);
                    var_383 = wp::add(var_381, var_384);
                    var_385 = wp::range(var_381, var_383);
                    start_for_8:;
                        if (iter_cmp(var_385) == 0) goto end_for_8;
                        var_386 = wp::iter_next(var_385);
                        // d = q - voxel_map__offsets[slot]                                   <L 29>
                        var_387 = wp::address(var_voxel_map__offsets, var_386);
                        var_389 = wp::load(var_387);
                        var_388 = wp::sub(var_380, var_389);
                        // sqdist = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]                   <L 30>
                        var_391 = wp::extract(var_388, var_390);
                        var_393 = wp::extract(var_388, var_392);
                        var_394 = wp::mul(var_391, var_393);
                        var_396 = wp::extract(var_388, var_395);
                        var_398 = wp::extract(var_388, var_397);
                        var_399 = wp::mul(var_396, var_398);
                        var_400 = wp::add(var_394, var_399);
                        var_402 = wp::extract(var_388, var_401);
                        var_404 = wp::extract(var_388, var_403);
                        var_405 = wp::mul(var_402, var_404);
                        var_406 = wp::add(var_400, var_405);
                        // if sqdist < min_sqdist:                                            <L 31>
                        var_407 = (var_406 < var_17);
                        if (var_407) {
                            // best = d                                                       <L 32>
                            var_408 = wp::copy(var_388);
                            // min_sqdist = sqdist                                            <L 33>
                            var_409 = wp::copy(var_406);
                            // nearest = slot                                                 <L 34>
                            var_410 = wp::copy(var_386);
                        }
                        var_411 = wp::where(var_407, var_408, var_16);
                        var_412 = wp::where(var_407, var_409, var_17);
                        var_413 = wp::where(var_407, var_410, var_19);
                        wp::assign(var_16, var_411);
                        wp::assign(var_17, var_412);
                        wp::assign(var_19, var_413);
                        wp::assign(var_82, var_388);
                        wp::assign(var_100, var_406);
                        goto start_for_8;
                    end_for_8:;
                }
                var_414 = wp::where(var_372, var_379, var_343);
                var_415 = wp::where(var_372, var_380, var_344);
                var_416 = wp::where(var_372, var_381, var_345);
                var_417 = wp::where(var_372, var_386, var_346);
            }
            var_418 = wp::where(var_359, var_370, var_342);
            var_419 = wp::where(var_359, var_414, var_343);
            var_420 = wp::where(var_359, var_415, var_344);
            var_421 = wp::where(var_359, var_416, var_345);
            var_422 = wp::where(var_359, var_417, var_346);
            // sx__voxels_around__1 = side_of(x__voxels_around__1, near[0])                   <L 20>
            var_425 = wp::extract(var_12, var_424);
            var_426 = side_of_0(var_423, var_425);
            // gx__voxels_around__1 = gap_to(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 21>
            var_428 = wp::extract(var_1, var_427);
            var_429 = gap_to_0(var_428, var_426, var_20);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:       <L 22>
            var_430 = wp::mul(var_429, var_429);
            var_431 = wp::mul(var_266, var_266);
            var_432 = wp::add(var_430, var_431);
            var_433 = wp::mul(var_27, var_27);
            var_434 = wp::add(var_432, var_433);
            var_435 = (var_434 < var_17);
            if (var_435) {
                // voxel = find_position(block_key(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 23>
                var_437 = wp::extract(var_0, var_436);
                var_438 = wp::add(var_437, var_426);
                var_440 = wp::extract(var_0, var_439);
                var_441 = wp::add(var_440, var_263);
                var_443 = wp::extract(var_0, var_442);
                var_444 = wp::add(var_443, var_24);
                var_445 = block_key_0(var_438, var_441, var_444);
                var_446 = find_position_0(var_445, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 24>
                var_448 = (var_446 >= var_447);
                if (var_448) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 25>
                    var_449 = wp::float(var_426);
                    var_450 = wp::mul(var_449, var_20);
                    var_451 = wp::float(var_263);
                    var_452 = wp::mul(var_451, var_20);
                    var_453 = wp::float(var_24);
                    var_454 = wp::mul(var_453, var_20);
                    var_455 = wp::vec_t<3, wp::float32>(var_450, var_452, var_454);
                    // q = position - shift                                                   <L 26>
                    var_456 = wp::sub(var_1, var_455);
                    // first = voxel * voxel_map__room                                        <L 27>
                    var_457 = wp::mul(var_446, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 28>
                    var_458 = wp::address(var_voxel_map__counts, var_446);
                    var_460 = wp::load(var_458);
                    var_459 = wp::add(var_457, var_460);
                    var_461 = wp::range(var_457, var_459);
                    start_for_10:;
                        if (iter_cmp(var_461) == 0) goto end_for_10;
                        var_462 = wp::iter_next(var_461);
                        // d = q - voxel_map__offsets[slot]                                   <L 29>
                        var_463 = wp::address(var_voxel_map__offsets, var_462);
                        var_465 = wp::load(var_463);
                        var_464 = wp::sub(var_456, var_465);
                        // sqdist = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]                   <L 30>
                        var_467 = wp::extract(var_464, var_466);
                        var_469 = wp::extract(var_464, var_468);
                        var_470 = wp::mul(var_467, var_469);
                        var_472 = wp::extract(var_464, var_471);
                        var_474 = wp::extract(var_464, var_473);
                        var_475 = wp::mul(var_472, var_474);
                        var_476 = wp::add(var_470, var_475);
                        var_478 = wp::extract(var_464, var_477);
                        var_480 = wp::extract(var_464, var_479);
                        var_481 = wp::mul(var_478, var_480);
                        var_482 = wp::add(var_476, var_481);
                        // if sqdist < min_sqdist:                                            <L 31>
                        var_483 = (var_482 < var_17);
                        if (var_483) {
                            // best = d                                                       <L 32>
                            var_484 = wp::copy(var_464);
                            // min_sqdist = sqdist                                            <L 33>
                            var_485 = wp::copy(var_482);
                            // nearest = slot                                                 <L 34>
                            var_486 = wp::copy(var_462);
                        }
                        var_487 = wp::where(var_483, var_484, var_16);
                        var_488 = wp::where(var_483, var_485, var_17);
                        var_489 = wp::where(var_483, var_486, var_19);
                        wp::assign(var_16, var_487);
                        wp::assign(var_17, var_488);
                        wp::assign(var_19, var_489);
                        wp::assign(var_82, var_464);
                        wp::assign(var_100, var_482);
                        goto start_for_10;
                    end_for_10:;
                }
                var_490 = wp::where(var_448, var_455, var_419);
                var_491 = wp::where(var_448, var_456, var_420);
                var_492 = wp::where(var_448, var_457, var_421);
                var_493 = wp::where(var_448, var_462, var_422);
            }
            var_494 = wp::where(var_435, var_446, var_418);
            var_495 = wp::where(var_435, var_490, var_419);
            var_496 = wp::where(var_435, var_491, var_420);
            var_497 = wp::where(var_435, var_492, var_421);
            var_498 = wp::where(var_435, var_493, var_422);
        }
        var_499 = wp::where(var_270, var_423, var_184);
        var_500 = wp::where(var_270, var_426, var_187);
        var_501 = wp::where(var_270, var_429, var_190);
        var_502 = wp::where(var_270, var_494, var_255);
        var_503 = wp::where(var_270, var_495, var_256);
        var_504 = wp::where(var_270, var_496, var_257);
        var_505 = wp::where(var_270, var_497, var_258);
        var_506 = wp::where(var_270, var_498, var_259);
        // sy__voxels_around__1 = side_of(y__voxels_around__1, near[1])                       <L 16>
        var_509 = wp::extract(var_12, var_508);
        var_510 = side_of_0(var_507, var_509);
        // gy__voxels_around__1 = gap_to(position[1], sy__voxels_around__1, edge__voxels_around__1)       <L 17>
        var_512 = wp::extract(var_1, var_511);
        var_513 = gap_to_0(var_512, var_510, var_20);
        // if gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:       <L 18>
        var_514 = wp::mul(var_513, var_513);
        var_515 = wp::mul(var_27, var_27);
        var_516 = wp::add(var_514, var_515);
        var_517 = (var_516 < var_17);
        if (var_517) {
            // for x__voxels_around__1 in range(3):                                           <L 19>
            // sx__voxels_around__1 = side_of(x__voxels_around__1, near[0])                   <L 20>
            var_520 = wp::extract(var_12, var_519);
            var_521 = side_of_0(var_518, var_520);
            // gx__voxels_around__1 = gap_to(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 21>
            var_523 = wp::extract(var_1, var_522);
            var_524 = gap_to_0(var_523, var_521, var_20);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:       <L 22>
            var_525 = wp::mul(var_524, var_524);
            var_526 = wp::mul(var_513, var_513);
            var_527 = wp::add(var_525, var_526);
            var_528 = wp::mul(var_27, var_27);
            var_529 = wp::add(var_527, var_528);
            var_530 = (var_529 < var_17);
            if (var_530) {
                // voxel = find_position(block_key(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 23>
                var_532 = wp::extract(var_0, var_531);
                var_533 = wp::add(var_532, var_521);
                var_535 = wp::extract(var_0, var_534);
                var_536 = wp::add(var_535, var_510);
                var_538 = wp::extract(var_0, var_537);
                var_539 = wp::add(var_538, var_24);
                var_540 = block_key_0(var_533, var_536, var_539);
                var_541 = find_position_0(var_540, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 24>
                var_543 = (var_541 >= var_542);
                if (var_543) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 25>
                    var_544 = wp::float(var_521);
                    var_545 = wp::mul(var_544, var_20);
                    var_546 = wp::float(var_510);
                    var_547 = wp::mul(var_546, var_20);
                    var_548 = wp::float(var_24);
                    var_549 = wp::mul(var_548, var_20);
                    var_550 = wp::vec_t<3, wp::float32>(var_545, var_547, var_549);
                    // q = position - shift                                                   <L 26>
                    var_551 = wp::sub(var_1, var_550);
                    // first = voxel * voxel_map__room                                        <L 27>
                    var_552 = wp::mul(var_541, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 28>
                    var_553 = wp::address(var_voxel_map__counts, var_541);
                    var_555 = wp::load(var_553);
                    var_554 = wp::add(var_552, var_555);
                    var_556 = wp::range(var_552, var_554);
                    start_for_12:;
                        if (iter_cmp(var_556) == 0) goto end_for_12;
                        var_557 = wp::iter_next(var_556);
                        // d = q - voxel_map__offsets[slot]                                   <L 29>
                        var_558 = wp::address(var_voxel_map__offsets, var_557);
                        var_560 = wp::load(var_558);
                        var_559 = wp::sub(var_551, var_560);
                        // sqdist = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]                   <L 30>
                        var_562 = wp::extract(var_559, var_561);
                        var_564 = wp::extract(var_559, var_563);
                        var_565 = wp::mul(var_562, var_564);
                        var_567 = wp::extract(var_559, var_566);
                        var_569 = wp::extract(var_559, var_568);
                        var_570 = wp::mul(var_567, var_569);
                        var_571 = wp::add(var_565, var_570);
                        var_573 = wp::extract(var_559, var_572);
                        var_575 = wp::extract(var_559, var_574);
                        var_576 = wp::mul(var_573, var_575);
                        var_577 = wp::add(var_571, var_576);
                        // if sqdist < min_sqdist:                                            <L 31>
                        var_578 = (var_577 < var_17);
                        if (var_578) {
                            // best = d                                                       <L 32>
                            var_579 = wp::copy(var_559);
                            // min_sqdist = sqdist                                            <L 33>
                            var_580 = wp::copy(var_577);
                            // nearest = slot                                                 <L 34>
                            var_581 = wp::copy(var_557);
                        }
                        var_582 = wp::where(var_578, var_579, var_16);
                        var_583 = wp::where(var_578, var_580, var_17);
                        var_584 = wp::where(var_578, var_581, var_19);
                        wp::assign(var_16, var_582);
                        wp::assign(var_17, var_583);
                        wp::assign(var_19, var_584);
                        wp::assign(var_82, var_559);
                        wp::assign(var_100, var_577);
                        goto start_for_12;
                    end_for_12:;
                }
                var_585 = wp::where(var_543, var_550, var_503);
                var_586 = wp::where(var_543, var_551, var_504);
                var_587 = wp::where(var_543, var_552, var_505);
                var_588 = wp::where(var_543, var_557, var_506);
            }
            var_589 = wp::where(var_530, var_541, var_502);
            var_590 = wp::where(var_530, var_585, var_503);
            var_591 = wp::where(var_530, var_586, var_504);
            var_592 = wp::where(var_530, var_587, var_505);
            var_593 = wp::where(var_530, var_588, var_506);
            // sx__voxels_around__1 = side_of(x__voxels_around__1, near[0])                   <L 20>
            var_596 = wp::extract(var_12, var_595);
            var_597 = side_of_0(var_594, var_596);
            // gx__voxels_around__1 = gap_to(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 21>
            var_599 = wp::extract(var_1, var_598);
            var_600 = gap_to_0(var_599, var_597, var_20);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:       <L 22>
            var_601 = wp::mul(var_600, var_600);
            var_602 = wp::mul(var_513, var_513);
            var_603 = wp::add(var_601, var_602);
            var_604 = wp::mul(var_27, var_27);
            var_605 = wp::add(var_603, var_604);
            var_606 = (var_605 < var_17);
            if (var_606) {
                // voxel = find_position(block_key(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 23>
                var_608 = wp::extract(var_0, var_607);
                var_609 = wp::add(var_608, var_597);
                var_611 = wp::extract(var_0, var_610);
                var_612 = wp::add(var_611, var_510);
                var_614 = wp::extract(var_0, var_613);
                var_615 = wp::add(var_614, var_24);
                var_616 = block_key_0(var_609, var_612, var_615);
                var_617 = find_position_0(var_616, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 24>
                var_619 = (var_617 >= var_618);
                if (var_619) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 25>
                    var_620 = wp::float(var_597);
                    var_621 = wp::mul(var_620, var_20);
                    var_622 = wp::float(var_510);
                    var_623 = wp::mul(var_622, var_20);
                    var_624 = wp::float(var_24);
                    var_625 = wp::mul(var_624, var_20);
                    var_626 = wp::vec_t<3, wp::float32>(var_621, var_623, var_625);
                    // q = position - shift                                                   <L 26>
                    var_627 = wp::sub(var_1, var_626);
                    // first = voxel * voxel_map__room                                        <L 27>
                    var_628 = wp::mul(var_617, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 28>
                    var_629 = wp::address(var_voxel_map__counts, var_617);
                    var_631 = wp::load(var_629);
                    var_630 = wp::add(var_628, var_631);
                    var_632 = wp::range(var_628, var_630);
                    start_for_14:;
                        if (iter_cmp(var_632) == 0) goto end_for_14;
                        var_633 = wp::iter_next(var_632);
                        // d = q - voxel_map__offsets[slot]                                   <L 29>
                        var_634 = wp::address(var_voxel_map__offsets, var_633);
                        var_636 = wp::load(var_634);
                        var_635 = wp::sub(var_627, var_636);
                        // sqdist = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]                   <L 30>
                        var_638 = wp::extract(var_635, var_637);
                        var_640 = wp::extract(var_635, var_639);
                        var_641 = wp::mul(var_638, var_640);
                        var_643 = wp::extract(var_635, var_642);
                        var_645 = wp::extract(var_635, var_644);
                        var_646 = wp::mul(var_643, var_645);
                        var_647 = wp::add(var_641, var_646);
                        var_649 = wp::extract(var_635, var_648);
                        var_651 = wp::extract(var_635, var_650);
                        var_652 = wp::mul(var_649, var_651);
                        var_653 = wp::add(var_647, var_652);
                        // if sqdist < min_sqdist:                                            <L 31>
                        var_654 = (var_653 < var_17);
                        if (var_654) {
                            // best = d                                                       <L 32>
                            var_655 = wp::copy(var_635);
                            // min_sqdist = sqdist                                            <L 33>
                            var_656 = wp::copy(var_653);
                            // nearest = slot                                                 <L 34>
                            var_657 = wp::copy(var_633);
                        }
                        var_658 = wp::where(var_654, var_655, var_16);
                        var_659 = wp::where(var_654, var_656, var_17);
                        var_660 = wp::where(var_654, var_657, var_19);
                        wp::assign(var_16, var_658);
                        wp::assign(var_17, var_659);
                        wp::assign(var_19, var_660);
                        wp::assign(var_82, var_635);
                        wp::assign(var_100, var_653);
                        goto start_for_14;
                    end_for_14:;
                }
                var_661 = wp::where(var_619, var_626, var_590);
                var_662 = wp::where(var_619, var_627, var_591);
                var_663 = wp::where(var_619, var_628, var_592);
                var_664 = wp::where(var_619, var_633, var_593);
            }
            var_665 = wp::where(var_606, var_617, var_589);
            var_666 = wp::where(var_606, var_661, var_590);
            var_667 = wp::where(var_606, var_662, var_591);
            var_668 = wp::where(var_606, var_663, var_592);
            var_669 = wp::where(var_606, var_664, var_593);
            // sx__voxels_around__1 = side_of(x__voxels_around__1, near[0])                   <L 20>
            var_672 = wp::extract(var_12, var_671);
            var_673 = side_of_0(var_670, var_672);
            // gx__voxels_around__1 = gap_to(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 21>
            var_675 = wp::extract(var_1, var_674);
            var_676 = gap_to_0(var_675, var_673, var_20);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:       <L 22>
            var_677 = wp::mul(var_676, var_676);
            var_678 = wp::mul(var_513, var_513);
            var_679 = wp::add(var_677, var_678);
            var_680 = wp::mul(var_27, var_27);
            var_681 = wp::add(var_679, var_680);
            var_682 = (var_681 < var_17);
            if (var_682) {
                // voxel = find_position(block_key(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 23>
                var_684 = wp::extract(var_0, var_683);
                var_685 = wp::add(var_684, var_673);
                var_687 = wp::extract(var_0, var_686);
                var_688 = wp::add(var_687, var_510);
                var_690 = wp::extract(var_0, var_689);
                var_691 = wp::add(var_690, var_24);
                var_692 = block_key_0(var_685, var_688, var_691);
                var_693 = find_position_0(var_692, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 24>
                var_695 = (var_693 >= var_694);
                if (var_695) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 25>
                    var_696 = wp::float(var_673);
                    var_697 = wp::mul(var_696, var_20);
                    var_698 = wp::float(var_510);
                    var_699 = wp::mul(var_698, var_20);
                    var_700 = wp::float(var_24);
                    var_701 = wp::mul(var_700, var_20);
                    var_702 = wp::vec_t<3, wp::float32>(var_697, var_699, var_701);
                    // q = position - shift                                                   <L 26>
                    var_703 = wp::sub(var_1, var_702);
                    // first = voxel * voxel_map__room                                        <L 27>
                    var_704 = wp::mul(var_693, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 28>
                    var_705 = wp::address(var_voxel_map__counts, var_693);
                    var_707 = wp::load(var_705);
                    var_706 = wp::add(var_704, var_707);
                    var_708 = wp::range(var_704, var_706);
                    start_for_16:;
                        if (iter_cmp(var_708) == 0) goto end_for_16;
                        var_709 = wp::iter_next(var_708);
                        // d = q - voxel_map__offsets[slot]                                   <L 29>
                        var_710 = wp::address(var_voxel_map__offsets, var_709);
                        var_712 = wp::load(var_710);
                        var_711 = wp::sub(var_703, var_712);
                        // sqdist = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]                   <L 30>
                        var_714 = wp::extract(var_711, var_713);
                        var_716 = wp::extract(var_711, var_715);
                        var_717 = wp::mul(var_714, var_716);
                        var_719 = wp::extract(var_711, var_718);
                        var_721 = wp::extract(var_711, var_720);
                        var_722 = wp::mul(var_719, var_721);
                        var_723 = wp::add(var_717, var_722);
                        var_725 = wp::extract(var_711, var_724);
                        var_727 = wp::extract(var_711, var_726);
                        var_728 = wp::mul(var_725, var_727);
                        var_729 = wp::add(var_723, var_728);
                        // if sqdist < min_sqdist:                                            <L 31>
                        var_730 = (var_729 < var_17);
                        if (var_730) {
                            // best = d                                                       <L 32>
                            var_731 = wp::copy(var_711);
                            // min_sqdist = sqdist                                            <L 33>
                            var_732 = wp::copy(var_729);
                            // nearest = slot                                                 <L 34>
                            var_733 = wp::copy(var_709);
                        }
                        var_734 = wp::where(var_730, var_731, var_16);
                        var_735 = wp::where(var_730, var_732, var_17);
                        var_736 = wp::where(var_730, var_733, var_19);
                        wp::assign(var_16, var_734);
                        wp::assign(var_17, var_735);
                        wp::assign(var_19, var_736);
                        wp::assign(var_82, var_711);
                        wp::assign(var_100, var_729);
                        goto start_for_16;
                    end_for_16:;
                }
                var_737 = wp::where(var_695, var_702, var_666);
                var_738 = wp::where(var_695, var_703, var_667);
                var_739 = wp::where(var_695, var_704, var_668);
                var_740 = wp::where(var_695, var_709, var_669);
            }
            var_741 = wp::where(var_682, var_693, var_665);
            var_742 = wp::where(var_682, var_737, var_666);
            var_743 = wp::where(var_682, var_738, var_667);
            var_744 = wp::where(var_682, var_739, var_668);
            var_745 = wp::where(var_682, var_740, var_669);
        }
        var_746 = wp::where(var_517, var_670, var_499);
        var_747 = wp::where(var_517, var_673, var_500);
        var_748 = wp::where(var_517, var_676, var_501);
        var_749 = wp::where(var_517, var_741, var_502);
        var_750 = wp::where(var_517, var_742, var_503);
        var_751 = wp::where(var_517, var_743, var_504);
        var_752 = wp::where(var_517, var_744, var_505);
        var_753 = wp::where(var_517, var_745, var_506);
    }
    // sz__voxels_around__1 = side_of(z__voxels_around__1, near[2])                           <L 12>
    var_756 = wp::extract(var_12, var_755);
    var_757 = side_of_0(var_754, var_756);
    // gz__voxels_around__1 = gap_to(position[2], sz__voxels_around__1, edge__voxels_around__1)       <L 13>
    var_759 = wp::extract(var_1, var_758);
    var_760 = gap_to_0(var_759, var_757, var_20);
    // if gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:                           <L 14>
    var_761 = wp::mul(var_760, var_760);
    var_762 = (var_761 < var_17);
    if (var_762) {
        // for y__voxels_around__1 in range(3):                                               <L 15>
        // sy__voxels_around__1 = side_of(y__voxels_around__1, near[1])                       <L 16>
        var_765 = wp::extract(var_12, var_764);
        var_766 = side_of_0(var_763, var_765);
        // gy__voxels_around__1 = gap_to(position[1], sy__voxels_around__1, edge__voxels_around__1)       <L 17>
        var_768 = wp::extract(var_1, var_767);
        var_769 = gap_to_0(var_768, var_766, var_20);
        // if gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:       <L 18>
        var_770 = wp::mul(var_769, var_769);
        var_771 = wp::mul(var_760, var_760);
        var_772 = wp::add(var_770, var_771);
        var_773 = (var_772 < var_17);
        if (var_773) {
            // for x__voxels_around__1 in range(3):                                           <L 19>
            // sx__voxels_around__1 = side_of(x__voxels_around__1, near[0])                   <L 20>
            var_776 = wp::extract(var_12, var_775);
            var_777 = side_of_0(var_774, var_776);
            // gx__voxels_around__1 = gap_to(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 21>
            var_779 = wp::extract(var_1, var_778);
            var_780 = gap_to_0(var_779, var_777, var_20);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:       <L 22>
            var_781 = wp::mul(var_780, var_780);
            var_782 = wp::mul(var_769, var_769);
            var_783 = wp::add(var_781, var_782);
            var_784 = wp::mul(var_760, var_760);
            var_785 = wp::add(var_783, var_784);
            var_786 = (var_785 < var_17);
            if (var_786) {
                // voxel = find_position(block_key(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 23>
                var_788 = wp::extract(var_0, var_787);
                var_789 = wp::add(var_788, var_777);
                var_791 = wp::extract(var_0, var_790);
                var_792 = wp::add(var_791, var_766);
                var_794 = wp::extract(var_0, var_793);
                var_795 = wp::add(var_794, var_757);
                var_796 = block_key_0(var_789, var_792, var_795);
                var_797 = find_position_0(var_796, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 24>
                var_799 = (var_797 >= var_798);
                if (var_799) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 25>
                    var_800 = wp::float(var_777);
                    var_801 = wp::mul(var_800, var_20);
                    var_802 = wp::float(var_766);
                    var_803 = wp::mul(var_802, var_20);
                    var_804 = wp::float(var_757);
                    var_805 = wp::mul(var_804, var_20);
                    var_806 = wp::vec_t<3, wp::float32>(var_801, var_803, var_805);
                    // q = position - shift                                                   <L 26>
                    var_807 = wp::sub(var_1, var_806);
                    // first = voxel * voxel_map__room                                        <L 27>
                    var_808 = wp::mul(var_797, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 28>
                    var_809 = wp::address(var_voxel_map__counts, var_797);
                    var_811 = wp::load(var_809);
                    var_810 = wp::add(var_808, var_811);
                    var_812 = wp::range(var_808, var_810);
                    start_for_18:;
                        if (iter_cmp(var_812) == 0) goto end_for_18;
                        var_813 = wp::iter_next(var_812);
                        // d = q - voxel_map__offsets[slot]                                   <L 29>
                        var_814 = wp::address(var_voxel_map__offsets, var_813);
                        var_816 = wp::load(var_814);
                        var_815 = wp::sub(var_807, var_816);
                        // sqdist = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]                   <L 30>
                        var_818 = wp::extract(var_815, var_817);
                        var_820 = wp::extract(var_815, var_819);
                        var_821 = wp::mul(var_818, var_820);
                        var_823 = wp::extract(var_815, var_822);
                        var_825 = wp::extract(var_815, var_824);
                        var_826 = wp::mul(var_823, var_825);
                        var_827 = wp::add(var_821, var_826);
                        var_829 = wp::extract(var_815, var_828);
                        var_831 = wp::extract(var_815, var_830);
                        var_832 = wp::mul(var_829, var_831);
                        var_833 = wp::add(var_827, var_832);
                        // if sqdist < min_sqdist:                                            <L 31>
                        var_834 = (var_833 < var_17);
                        if (var_834) {
                            // best = d                                                       <L 32>
                            var_835 = wp::copy(var_815);
                            // min_sqdist = sqdist                                            <L 33>
                            var_836 = wp::copy(var_833);
                            // nearest = slot                                                 <L 34>
                            var_837 = wp::copy(var_813);
                        }
                        var_838 = wp::where(var_834, var_835, var_16);
                        var_839 = wp::where(var_834, var_836, var_17);
                        var_840 = wp::where(var_834, var_837, var_19);
                        wp::assign(var_16, var_838);
                        wp::assign(var_17, var_839);
                        wp::assign(var_19, var_840);
                        wp::assign(var_82, var_815);
                        wp::assign(var_100, var_833);
                        goto start_for_18;
                    end_for_18:;
                }
                var_841 = wp::where(var_799, var_806, var_750);
                var_842 = wp::where(var_799, var_807, var_751);
                var_843 = wp::where(var_799, var_808, var_752);
                var_844 = wp::where(var_799, var_813, var_753);
            }
            var_845 = wp::where(var_786, var_797, var_749);
            var_846 = wp::where(var_786, var_841, var_750);
            var_847 = wp::where(var_786, var_842, var_751);
            var_848 = wp::where(var_786, var_843, var_752);
            var_849 = wp::where(var_786, var_844, var_753);
            // sx__voxels_around__1 = side_of(x__voxels_around__1, near[0])                   <L 20>
            var_852 = wp::extract(var_12, var_851);
            var_853 = side_of_0(var_850, var_852);
            // gx__voxels_around__1 = gap_to(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 21>
            var_855 = wp::extract(var_1, var_854);
            var_856 = gap_to_0(var_855, var_853, var_20);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:       <L 22>
            var_857 = wp::mul(var_856, var_856);
            var_858 = wp::mul(var_769, var_769);
            var_859 = wp::add(var_857, var_858);
            var_860 = wp::mul(var_760, var_760);
            var_861 = wp::add(var_859, var_860);
            var_862 = (var_861 < var_17);
            if (var_862) {
                // voxel = find_position(block_key(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 23>
                var_864 = wp::extract(var_0, var_863);
                var_865 = wp::add(var_864, var_853);
                var_867 = wp::extract(var_0, var_866);
                var_868 = wp::add(var_867, var_766);
                var_870 = wp::extract(var_0, var_869);
                var_871 = wp::add(var_870, var_757);
                var_872 = block_key_0(var_865, var_868, var_871);
                var_873 = find_position_0(var_872, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 24>
                var_875 = (var_873 >= var_874);
                if (var_875) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 25>
                    var_876 = wp::float(var_853);
                    var_877 = wp::mul(var_876, var_20);
                    var_878 = wp::float(var_766);
                    var_879 = wp::mul(var_878, var_20);
                    var_880 = wp::float(var_757);
                    var_881 = wp::mul(var_880, var_20);
                    var_882 = wp::vec_t<3, wp::float32>(var_877, var_879, var_881);
                    // q = position - shift                                                   <L 26>
                    var_883 = wp::sub(var_1, var_882);
                    // first = voxel * voxel_map__room                                        <L 27>
                    var_884 = wp::mul(var_873, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 28>
                    var_885 = wp::address(var_voxel_map__counts, var_873);
                    var_887 = wp::load(var_885);
                    var_886 = wp::add(var_884, var_887);
                    var_888 = wp::range(var_884, var_886);
                    start_for_20:;
                        if (iter_cmp(var_888) == 0) goto end_for_20;
                        var_889 = wp::iter_next(var_888);
                        // d = q - voxel_map__offsets[slot]                                   <L 29>
                        var_890 = wp::address(var_voxel_map__offsets, var_889);
                        var_892 = wp::load(var_890);
                        var_891 = wp::sub(var_883, var_892);
                        // sqdist = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]                   <L 30>
                        var_894 = wp::extract(var_891, var_893);
                        var_896 = wp::extract(var_891, var_895);
                        var_897 = wp::mul(var_894, var_896);
                        var_899 = wp::extract(var_891, var_898);
                        var_901 = wp::extract(var_891, var_900);
                        var_902 = wp::mul(var_899, var_901);
                        var_903 = wp::add(var_897, var_902);
                        var_905 = wp::extract(var_891, var_904);
                        var_907 = wp::extract(var_891, var_906);
                        var_908 = wp::mul(var_905, var_907);
                        var_909 = wp::add(var_903, var_908);
                        // if sqdist < min_sqdist:                                            <L 31>
                        var_910 = (var_909 < var_17);
                        if (var_910) {
                            // best = d                                                       <L 32>
                            var_911 = wp::copy(var_891);
                            // min_sqdist = sqdist                                            <L 33>
                            var_912 = wp::copy(var_909);
                            // nearest = slot                                                 <L 34>
                            var_913 = wp::copy(var_889);
                        }
                        var_914 = wp::where(var_910, var_911, var_16);
                        var_915 = wp::where(var_910, var_912, var_17);
                        var_916 = wp::where(var_910, var_913, var_19);
                        wp::assign(var_16, var_914);
                        wp::assign(var_17, var_915);
                        wp::assign(var_19, var_916);
                        wp::assign(var_82, var_891);
                        wp::assign(var_100, var_909);
                        goto start_for_20;
                    end_for_20:;
                }
                var_917 = wp::where(var_875, var_882, var_846);
                var_918 = wp::where(var_875, var_883, var_847);
                var_919 = wp::where(var_875, var_884, var_848);
                var_920 = wp::where(var_875, var_889, var_849);
            }
            var_921 = wp::where(var_862, var_873, var_845);
            var_922 = wp::where(var_862, var_917, var_846);
            var_923 = wp::where(var_862, var_918, var_847);
            var_924 = wp::where(var_862, var_919, var_848);
            var_925 = wp::where(var_862, var_920, var_849);
            // sx__voxels_around__1 = side_of(x__voxels_around__1, near[0])                   <L 20>
            var_928 = wp::extract(var_12, var_927);
            var_929 = side_of_0(var_926, var_928);
            // gx__voxels_around__1 = gap_to(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 21>
            var_931 = wp::extract(var_1, var_930);
            var_932 = gap_to_0(var_931, var_929, var_20);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:       <L 22>
            var_933 = wp::mul(var_932, var_932);
            var_934 = wp::mul(var_769, var_769);
            var_935 = wp::add(var_933, var_934);
            var_936 = wp::mul(var_760, var_760);
            var_937 = wp::add(var_935, var_936);
            var_938 = (var_937 < var_17);
            if (var_938) {
                // voxel = find_position(block_key(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 23>
                var_940 = wp::extract(var_0, var_939);
                var_941 = wp::add(var_940, var_929);
                var_943 = wp::extract(var_0, var_942);
                var_944 = wp::add(var_943, var_766);
                var_946 = wp::extract(var_0, var_945);
                var_947 = wp::add(var_946, var_757);
                var_948 = block_key_0(var_941, var_944, var_947);
                var_949 = find_position_0(var_948, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 24>
                var_951 = (var_949 >= var_950);
                if (var_951) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 25>
                    var_952 = wp::float(var_929);
                    var_953 = wp::mul(var_952, var_20);
                    var_954 = wp::float(var_766);
                    var_955 = wp::mul(var_954, var_20);
                    var_956 = wp::float(var_757);
                    var_957 = wp::mul(var_956, var_20);
                    var_958 = wp::vec_t<3, wp::float32>(var_953, var_955, var_957);
                    // q = position - shift                                                   <L 26>
                    var_959 = wp::sub(var_1, var_958);
                    // first = voxel * voxel_map__room                                        <L 27>
                    var_960 = wp::mul(var_949, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 28>
                    var_961 = wp::address(var_voxel_map__counts, var_949);
                    var_963 = wp::load(var_961);
                    var_962 = wp::add(var_960, var_963);
                    var_964 = wp::range(var_960, var_962);
                    start_for_22:;
                        if (iter_cmp(var_964) == 0) goto end_for_22;
                        var_965 = wp::iter_next(var_964);
                        // d = q - voxel_map__offsets[slot]                                   <L 29>
                        var_966 = wp::address(var_voxel_map__offsets, var_965);
                        var_968 = wp::load(var_966);
                        var_967 = wp::sub(var_959, var_968);
                        // sqdist = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]                   <L 30>
                        var_970 = wp::extract(var_967, var_969);
                        var_972 = wp::extract(var_967, var_971);
                        var_973 = wp::mul(var_970, var_972);
                        var_975 = wp::extract(var_967, var_974);
                        var_977 = wp::extract(var_967, var_976);
                        var_978 = wp::mul(var_975, var_977);
                        var_979 = wp::add(var_973, var_978);
                        var_981 = wp::extract(var_967, var_980);
                        var_983 = wp::extract(var_967, var_982);
                        var_984 = wp::mul(var_981, var_983);
                        var_985 = wp::add(var_979, var_984);
                        // if sqdist < min_sqdist:                                            <L 31>
                        var_986 = (var_985 < var_17);
                        if (var_986) {
                            // best = d                                                       <L 32>
                            var_987 = wp::copy(var_967);
                            // min_sqdist = sqdist                                            <L 33>
                            var_988 = wp::copy(var_985);
                            // nearest = slot                                                 <L 34>
                            var_989 = wp::copy(var_965);
                        }
                        var_990 = wp::where(var_986, var_987, var_16);
                        var_991 = wp::where(var_986, var_988, var_17);
                        var_992 = wp::where(var_986, var_989, var_19);
                        wp::assign(var_16, var_990);
                        wp::assign(var_17, var_991);
                        wp::assign(var_19, var_992);
                        wp::assign(var_82, var_967);
                        wp::assign(var_100, var_985);
                        goto start_for_22;
                    end_for_22:;
                }
                var_993 = wp::where(var_951, var_958, var_922);
                var_994 = wp::where(var_951, var_959, var_923);
                var_995 = wp::where(var_951, var_960, var_924);
                var_996 = wp::where(var_951, var_965, var_925);
            }
            var_997 = wp::where(var_938, var_949, var_921);
            var_998 = wp::where(var_938, var_993, var_922);
            var_999 = wp::where(var_938, var_994, var_923);
            var_1000 = wp::where(var_938, var_995, var_924);
            var_1001 = wp::where(var_938, var_996, var_925);
        }
        var_1002 = wp::where(var_773, var_926, var_746);
        var_1003 = wp::where(var_773, var_929, var_747);
        var_1004 = wp::where(var_773, var_932, var_748);
        var_1005 = wp::where(var_773, var_997, var_749);
        var_1006 = wp::where(var_773, var_998, var_750);
        var_1007 = wp::where(var_773, var_999, var_751);
        var_1008 = wp::where(var_773, var_1000, var_752);
        var_1009 = wp::where(var_773, var_1001, var_753);
        // sy__voxels_around__1 = side_of(y__voxels_around__1, near[1])                       <L 16>
        var_1012 = wp::extract(var_12, var_1011);
        var_1013 = side_of_0(var_1010, var_1012);
        // gy__voxels_around__1 = gap_to(position[1], sy__voxels_around__1, edge__voxels_around__1)       <L 17>
        var_1015 = wp::extract(var_1, var_1014);
        var_1016 = gap_to_0(var_1015, var_1013, var_20);
        // if gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:       <L 18>
        var_1017 = wp::mul(var_1016, var_1016);
        var_1018 = wp::mul(var_760, var_760);
        var_1019 = wp::add(var_1017, var_1018);
        var_1020 = (var_1019 < var_17);
        if (var_1020) {
            // for x__voxels_around__1 in range(3):                                           <L 19>
            // sx__voxels_around__1 = side_of(x__voxels_around__1, near[0])                   <L 20>
            var_1023 = wp::extract(var_12, var_1022);
            var_1024 = side_of_0(var_1021, var_1023);
            // gx__voxels_around__1 = gap_to(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 21>
            var_1026 = wp::extract(var_1, var_1025);
            var_1027 = gap_to_0(var_1026, var_1024, var_20);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:       <L 22>
            var_1028 = wp::mul(var_1027, var_1027);
            var_1029 = wp::mul(var_1016, var_1016);
            var_1030 = wp::add(var_1028, var_1029);
            var_1031 = wp::mul(var_760, var_760);
            var_1032 = wp::add(var_1030, var_1031);
            var_1033 = (var_1032 < var_17);
            if (var_1033) {
                // voxel = find_position(block_key(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 23>
                var_1035 = wp::extract(var_0, var_1034);
                var_1036 = wp::add(var_1035, var_1024);
                var_1038 = wp::extract(var_0, var_1037);
                var_1039 = wp::add(var_1038, var_1013);
                var_1041 = wp::extract(var_0, var_1040);
                var_1042 = wp::add(var_1041, var_757);
                var_1043 = block_key_0(var_1036, var_1039, var_1042);
                var_1044 = find_position_0(var_1043, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 24>
                var_1046 = (var_1044 >= var_1045);
                if (var_1046) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 25>
                    var_1047 = wp::float(var_1024);
                    var_1048 = wp::mul(var_1047, var_20);
                    var_1049 = wp::float(var_1013);
                    var_1050 = wp::mul(var_1049, var_20);
                    var_1051 = wp::float(var_757);
                    var_1052 = wp::mul(var_1051, var_20);
                    var_1053 = wp::vec_t<3, wp::float32>(var_1048, var_1050, var_1052);
                    // q = position - shift                                                   <L 26>
                    var_1054 = wp::sub(var_1, var_1053);
                    // first = voxel * voxel_map__room                                        <L 27>
                    var_1055 = wp::mul(var_1044, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 28>
                    var_1056 = wp::address(var_voxel_map__counts, var_1044);
                    var_1058 = wp::load(var_1056);
                    var_1057 = wp::add(var_1055, var_1058);
                    var_1059 = wp::range(var_1055, var_1057);
                    start_for_24:;
                        if (iter_cmp(var_1059) == 0) goto end_for_24;
                        var_1060 = wp::iter_next(var_1059);
                        // d = q - voxel_map__offsets[slot]                                   <L 29>
                        var_1061 = wp::address(var_voxel_map__offsets, var_1060);
                        var_1063 = wp::load(var_1061);
                        var_1062 = wp::sub(var_1054, var_1063);
                        // sqdist = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]                   <L 30>
                        var_1065 = wp::extract(var_1062, var_1064);
                        var_1067 = wp::extract(var_1062, var_1066);
                        var_1068 = wp::mul(var_1065, var_1067);
                        var_1070 = wp::extract(var_1062, var_1069);
                        var_1072 = wp::extract(var_1062, var_1071);
                        var_1073 = wp::mul(var_1070, var_1072);
                        var_1074 = wp::add(var_1068, var_1073);
                        var_1076 = wp::extract(var_1062, var_1075);
                        var_1078 = wp::extract(var_1062, var_1077);
                        var_1079 = wp::mul(var_1076, var_1078);
                        var_1080 = wp::add(var_1074, var_1079);
                        // if sqdist < min_sqdist:                                            <L 31>
                        var_1081 = (var_1080 < var_17);
                        if (var_1081) {
                            // best = d                                                       <L 32>
                            var_1082 = wp::copy(var_1062);
                            // min_sqdist = sqdist                                            <L 33>
                            var_1083 = wp::copy(var_1080);
                            // nearest = slot                                                 <L 34>
                            var_1084 = wp::copy(var_1060);
                        }
                        var_1085 = wp::where(var_1081, var_1082, var_16);
                        var_1086 = wp::where(var_1081, var_1083, var_17);
                        var_1087 = wp::where(var_1081, var_1084, var_19);
                        wp::assign(var_16, var_1085);
                        wp::assign(var_17, var_1086);
                        wp::assign(var_19, var_1087);
                        wp::assign(var_82, var_1062);
                        wp::assign(var_100, var_1080);
                        goto start_for_24;
                    end_for_24:;
                }
                var_1088 = wp::where(var_1046, var_1053, var_1006);
                var_1089 = wp::where(var_1046, var_1054, var_1007);
                var_1090 = wp::where(var_1046, var_1055, var_1008);
                var_1091 = wp::where(var_1046, var_1060, var_1009);
            }
            var_1092 = wp::where(var_1033, var_1044, var_1005);
            var_1093 = wp::where(var_1033, var_1088, var_1006);
            var_1094 = wp::where(var_1033, var_1089, var_1007);
            var_1095 = wp::where(var_1033, var_1090, var_1008);
            var_1096 = wp::where(var_1033, var_1091, var_1009);
            // sx__voxels_around__1 = side_of(x__voxels_around__1, near[0])                   <L 20>
            var_1099 = wp::extract(var_12, var_1098);
            var_1100 = side_of_0(var_1097, var_1099);
            // gx__voxels_around__1 = gap_to(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 21>
            var_1102 = wp::extract(var_1, var_1101);
            var_1103 = gap_to_0(var_1102, var_1100, var_20);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:       <L 22>
            var_1104 = wp::mul(var_1103, var_1103);
            var_1105 = wp::mul(var_1016, var_1016);
            var_1106 = wp::add(var_1104, var_1105);
            var_1107 = wp::mul(var_760, var_760);
            var_1108 = wp::add(var_1106, var_1107);
            var_1109 = (var_1108 < var_17);
            if (var_1109) {
                // voxel = find_position(block_key(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 23>
                var_1111 = wp::extract(var_0, var_1110);
                var_1112 = wp::add(var_1111, var_1100);
                var_1114 = wp::extract(var_0, var_1113);
                var_1115 = wp::add(var_1114, var_1013);
                var_1117 = wp::extract(var_0, var_1116);
                var_1118 = wp::add(var_1117, var_757);
                var_1119 = block_key_0(var_1112, var_1115, var_1118);
                var_1120 = find_position_0(var_1119, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 24>
                var_1122 = (var_1120 >= var_1121);
                if (var_1122) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 25>
                    var_1123 = wp::float(var_1100);
                    var_1124 = wp::mul(var_1123, var_20);
                    var_1125 = wp::float(var_1013);
                    var_1126 = wp::mul(var_1125, var_20);
                    var_1127 = wp::float(var_757);
                    var_1128 = wp::mul(var_1127, var_20);
                    var_1129 = wp::vec_t<3, wp::float32>(var_1124, var_1126, var_1128);
                    // q = position - shift                                                   <L 26>
                    var_1130 = wp::sub(var_1, var_1129);
                    // first = voxel * voxel_map__room                                        <L 27>
                    var_1131 = wp::mul(var_1120, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 28>
                    var_1132 = wp::address(var_voxel_map__counts, var_1120);
                    var_1134 = wp::load(var_1132);
                    var_1133 = wp::add(var_1131, var_1134);
                    var_1135 = wp::range(var_1131, var_1133);
                    start_for_26:;
                        if (iter_cmp(var_1135) == 0) goto end_for_26;
                        var_1136 = wp::iter_next(var_1135);
                        // d = q - voxel_map__offsets[slot]                                   <L 29>
                        var_1137 = wp::address(var_voxel_map__offsets, var_1136);
                        var_1139 = wp::load(var_1137);
                        var_1138 = wp::sub(var_1130, var_1139);
                        // sqdist = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]                   <L 30>
                        var_1141 = wp::extract(var_1138, var_1140);
                        var_1143 = wp::extract(var_1138, var_1142);
                        var_1144 = wp::mul(var_1141, var_1143);
                        var_1146 = wp::extract(var_1138, var_1145);
                        var_1148 = wp::extract(var_1138, var_1147);
                        var_1149 = wp::mul(var_1146, var_1148);
                        var_1150 = wp::add(var_1144, var_1149);
                        var_1152 = wp::extract(var_1138, var_1151);
                        var_1154 = wp::extract(var_1138, var_1153);
                        var_1155 = wp::mul(var_1152, var_1154);
                        var_1156 = wp::add(var_1150, var_1155);
                        // if sqdist < min_sqdist:                                            <L 31>
                        var_1157 = (var_1156 < var_17);
                        if (var_1157) {
                            // best = d                                                       <L 32>
                            var_1158 = wp::copy(var_1138);
                            // min_sqdist = sqdist                                            <L 33>
                            var_1159 = wp::copy(var_1156);
                            // nearest = slot                                                 <L 34>
                            var_1160 = wp::copy(var_1136);
                        }
                        var_1161 = wp::where(var_1157, var_1158, var_16);
                        var_1162 = wp::where(var_1157, var_1159, var_17);
                        var_1163 = wp::where(var_1157, var_1160, var_19);
                        wp::assign(var_16, var_1161);
                        wp::assign(var_17, var_1162);
                        wp::assign(var_19, var_1163);
                        wp::assign(var_82, var_1138);
                        wp::assign(var_100, var_1156);
                        goto start_for_26;
                    end_for_26:;
                }
                var_1164 = wp::where(var_1122, var_1129, var_1093);
                var_1165 = wp::where(var_1122, var_1130, var_1094);
                var_1166 = wp::where(var_1122, var_1131, var_1095);
                var_1167 = wp::where(var_1122, var_1136, var_1096);
            }
            var_1168 = wp::where(var_1109, var_1120, var_1092);
            var_1169 = wp::where(var_1109, var_1164, var_1093);
            var_1170 = wp::where(var_1109, var_1165, var_1094);
            var_1171 = wp::where(var_1109, var_1166, var_1095);
            var_1172 = wp::where(var_1109, var_1167, var_1096);
            // sx__voxels_around__1 = side_of(x__voxels_around__1, near[0])                   <L 20>
            var_1175 = wp::extract(var_12, var_1174);
            var_1176 = side_of_0(var_1173, var_1175);
            // gx__voxels_around__1 = gap_to(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 21>
            var_1178 = wp::extract(var_1, var_1177);
            var_1179 = gap_to_0(var_1178, var_1176, var_20);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:       <L 22>
            var_1180 = wp::mul(var_1179, var_1179);
            var_1181 = wp::mul(var_1016, var_1016);
            var_1182 = wp::add(var_1180, var_1181);
            var_1183 = wp::mul(var_760, var_760);
            var_1184 = wp::add(var_1182, var_1183);
            var_1185 = (var_1184 < var_17);
            if (var_1185) {
                // voxel = find_position(block_key(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 23>
                var_1187 = wp::extract(var_0, var_1186);
                var_1188 = wp::add(var_1187, var_1176);
                var_1190 = wp::extract(var_0, var_1189);
                var_1191 = wp::add(var_1190, var_1013);
                var_1193 = wp::extract(var_0, var_1192);
                var_1194 = wp::add(var_1193, var_757);
                var_1195 = block_key_0(var_1188, var_1191, var_1194);
                var_1196 = find_position_0(var_1195, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 24>
                var_1198 = (var_1196 >= var_1197);
                if (var_1198) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 25>
                    var_1199 = wp::float(var_1176);
                    var_1200 = wp::mul(var_1199, var_20);
                    var_1201 = wp::float(var_1013);
                    var_1202 = wp::mul(var_1201, var_20);
                    var_1203 = wp::float(var_757);
                    var_1204 = wp::mul(var_1203, var_20);
                    var_1205 = wp::vec_t<3, wp::float32>(var_1200, var_1202, var_1204);
                    // q = position - shift                                                   <L 26>
                    var_1206 = wp::sub(var_1, var_1205);
                    // first = voxel * voxel_map__room                                        <L 27>
                    var_1207 = wp::mul(var_1196, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 28>
                    var_1208 = wp::address(var_voxel_map__counts, var_1196);
                    var_1210 = wp::load(var_1208);
                    var_1209 = wp::add(var_1207, var_1210);
                    var_1211 = wp::range(var_1207, var_1209);
                    start_for_28:;
                        if (iter_cmp(var_1211) == 0) goto end_for_28;
                        var_1212 = wp::iter_next(var_1211);
                        // d = q - voxel_map__offsets[slot]                                   <L 29>
                        var_1213 = wp::address(var_voxel_map__offsets, var_1212);
                        var_1215 = wp::load(var_1213);
                        var_1214 = wp::sub(var_1206, var_1215);
                        // sqdist = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]                   <L 30>
                        var_1217 = wp::extract(var_1214, var_1216);
                        var_1219 = wp::extract(var_1214, var_1218);
                        var_1220 = wp::mul(var_1217, var_1219);
                        var_1222 = wp::extract(var_1214, var_1221);
                        var_1224 = wp::extract(var_1214, var_1223);
                        var_1225 = wp::mul(var_1222, var_1224);
                        var_1226 = wp::add(var_1220, var_1225);
                        var_1228 = wp::extract(var_1214, var_1227);
                        var_1230 = wp::extract(var_1214, var_1229);
                        var_1231 = wp::mul(var_1228, var_1230);
                        var_1232 = wp::add(var_1226, var_1231);
                        // if sqdist < min_sqdist:                                            <L 31>
                        var_1233 = (var_1232 < var_17);
                        if (var_1233) {
                            // best = d                                                       <L 32>
                            var_1234 = wp::copy(var_1214);
                            // min_sqdist = sqdist                                            <L 33>
                            var_1235 = wp::copy(var_1232);
                            // nearest = slot                                                 <L 34>
                            var_1236 = wp::copy(var_1212);
                        }
                        var_1237 = wp::where(var_1233, var_1234, var_16);
                        var_1238 = wp::where(var_1233, var_1235, var_17);
                        var_1239 = wp::where(var_1233, var_1236, var_19);
                        wp::assign(var_16, var_1237);
                        wp::assign(var_17, var_1238);
                        wp::assign(var_19, var_1239);
                        wp::assign(var_82, var_1214);
                        wp::assign(var_100, var_1232);
                        goto start_for_28;
                    end_for_28:;
                }
                var_1240 = wp::where(var_1198, var_1205, var_1169);
                var_1241 = wp::where(var_1198, var_1206, var_1170);
                var_1242 = wp::where(var_1198, var_1207, var_1171);
                var_1243 = wp::where(var_1198, var_1212, var_1172);
            }
            var_1244 = wp::where(var_1185, var_1196, var_1168);
            var_1245 = wp::where(var_1185, var_1240, var_1169);
            var_1246 = wp::where(var_1185, var_1241, var_1170);
            var_1247 = wp::where(var_1185, var_1242, var_1171);
            var_1248 = wp::where(var_1185, var_1243, var_1172);
        }
        var_1249 = wp::where(var_1020, var_1173, var_1002);
        var_1250 = wp::where(var_1020, var_1176, var_1003);
        var_1251 = wp::where(var_1020, var_1179, var_1004);
        var_1252 = wp::where(var_1020, var_1244, var_1005);
        var_1253 = wp::where(var_1020, var_1245, var_1006);
        var_1254 = wp::where(var_1020, var_1246, var_1007);
        var_1255 = wp::where(var_1020, var_1247, var_1008);
        var_1256 = wp::where(var_1020, var_1248, var_1009);
        // sy__voxels_around__1 = side_of(y__voxels_around__1, near[1])                       <L 16>
        var_1259 = wp::extract(var_12, var_1258);
        var_1260 = side_of_0(var_1257, var_1259);
        // gy__voxels_around__1 = gap_to(position[1], sy__voxels_around__1, edge__voxels_around__1)       <L 17>
        var_1262 = wp::extract(var_1, var_1261);
        var_1263 = gap_to_0(var_1262, var_1260, var_20);
        // if gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:       <L 18>
        var_1264 = wp::mul(var_1263, var_1263);
        var_1265 = wp::mul(var_760, var_760);
        var_1266 = wp::add(var_1264, var_1265);
        var_1267 = (var_1266 < var_17);
        if (var_1267) {
            // for x__voxels_around__1 in range(3):                                           <L 19>
            // sx__voxels_around__1 = side_of(x__voxels_around__1, near[0])                   <L 20>
            var_1270 = wp::extract(var_12, var_1269);
            var_1271 = side_of_0(var_1268, var_1270);
            // gx__voxels_around__1 = gap_to(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 21>
            var_1273 = wp::extract(var_1, var_1272);
            var_1274 = gap_to_0(var_1273, var_1271, var_20);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:       <L 22>
            var_1275 = wp::mul(var_1274, var_1274);
            var_1276 = wp::mul(var_1263, var_1263);
            var_1277 = wp::add(var_1275, var_1276);
            var_1278 = wp::mul(var_760, var_760);
            var_1279 = wp::add(var_1277, var_1278);
            var_1280 = (var_1279 < var_17);
            if (var_1280) {
                // voxel = find_position(block_key(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 23>
                var_1282 = wp::extract(var_0, var_1281);
                var_1283 = wp::add(var_1282, var_1271);
                var_1285 = wp::extract(var_0, var_1284);
                var_1286 = wp::add(var_1285, var_1260);
                var_1288 = wp::extract(var_0, var_1287);
                var_1289 = wp::add(var_1288, var_757);
                var_1290 = block_key_0(var_1283, var_1286, var_1289);
                var_1291 = find_position_0(var_1290, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 24>
                var_1293 = (var_1291 >= var_1292);
                if (var_1293) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 25>
                    var_1294 = wp::float(var_1271);
                    var_1295 = wp::mul(var_1294, var_20);
                    var_1296 = wp::float(var_1260);
                    var_1297 = wp::mul(var_1296, var_20);
                    var_1298 = wp::float(var_757);
                    var_1299 = wp::mul(var_1298, var_20);
                    var_1300 = wp::vec_t<3, wp::float32>(var_1295, var_1297, var_1299);
                    // q = position - shift                                                   <L 26>
                    var_1301 = wp::sub(var_1, var_1300);
                    // first = voxel * voxel_map__room                                        <L 27>
                    var_1302 = wp::mul(var_1291, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 28>
                    var_1303 = wp::address(var_voxel_map__counts, var_1291);
                    var_1305 = wp::load(var_1303);
                    var_1304 = wp::add(var_1302, var_1305);
                    var_1306 = wp::range(var_1302, var_1304);
                    start_for_30:;
                        if (iter_cmp(var_1306) == 0) goto end_for_30;
                        var_1307 = wp::iter_next(var_1306);
                        // d = q - voxel_map__offsets[slot]                                   <L 29>
                        var_1308 = wp::address(var_voxel_map__offsets, var_1307);
                        var_1310 = wp::load(var_1308);
                        var_1309 = wp::sub(var_1301, var_1310);
                        // sqdist = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]                   <L 30>
                        var_1312 = wp::extract(var_1309, var_1311);
                        var_1314 = wp::extract(var_1309, var_1313);
                        var_1315 = wp::mul(var_1312, var_1314);
                        var_1317 = wp::extract(var_1309, var_1316);
                        var_1319 = wp::extract(var_1309, var_1318);
                        var_1320 = wp::mul(var_1317, var_1319);
                        var_1321 = wp::add(var_1315, var_1320);
                        var_1323 = wp::extract(var_1309, var_1322);
                        var_1325 = wp::extract(var_1309, var_1324);
                        var_1326 = wp::mul(var_1323, var_1325);
                        var_1327 = wp::add(var_1321, var_1326);
                        // if sqdist < min_sqdist:                                            <L 31>
                        var_1328 = (var_1327 < var_17);
                        if (var_1328) {
                            // best = d                                                       <L 32>
                            var_1329 = wp::copy(var_1309);
                            // min_sqdist = sqdist                                            <L 33>
                            var_1330 = wp::copy(var_1327);
                            // nearest = slot                                                 <L 34>
                            var_1331 = wp::copy(var_1307);
                        }
                        var_1332 = wp::where(var_1328, var_1329, var_16);
                        var_1333 = wp::where(var_1328, var_1330, var_17);
                        var_1334 = wp::where(var_1328, var_1331, var_19);
                        wp::assign(var_16, var_1332);
                        wp::assign(var_17, var_1333);
                        wp::assign(var_19, var_1334);
                        wp::assign(var_82, var_1309);
                        wp::assign(var_100, var_1327);
                        goto start_for_30;
                    end_for_30:;
                }
                var_1335 = wp::where(var_1293, var_1300, var_1253);
                var_1336 = wp::where(var_1293, var_1301, var_1254);
                var_1337 = wp::where(var_1293, var_1302, var_1255);
                var_1338 = wp::where(var_1293, var_1307, var_1256);
            }
            var_1339 = wp::where(var_1280, var_1291, var_1252);
            var_1340 = wp::where(var_1280, var_1335, var_1253);
            var_1341 = wp::where(var_1280, var_1336, var_1254);
            var_1342 = wp::where(var_1280, var_1337, var_1255);
            var_1343 = wp::where(var_1280, var_1338, var_1256);
            // sx__voxels_around__1 = side_of(x__voxels_around__1, near[0])                   <L 20>
            var_1346 = wp::extract(var_12, var_1345);
            var_1347 = side_of_0(var_1344, var_1346);
            // gx__voxels_around__1 = gap_to(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 21>
            var_1349 = wp::extract(var_1, var_1348);
            var_1350 = gap_to_0(var_1349, var_1347, var_20);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:       <L 22>
            var_1351 = wp::mul(var_1350, var_1350);
            var_1352 = wp::mul(var_1263, var_1263);
            var_1353 = wp::add(var_1351, var_1352);
            var_1354 = wp::mul(var_760, var_760);
            var_1355 = wp::add(var_1353, var_1354);
            var_1356 = (var_1355 < var_17);
            if (var_1356) {
                // voxel = find_position(block_key(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 23>
                var_1358 = wp::extract(var_0, var_1357);
                var_1359 = wp::add(var_1358, var_1347);
                var_1361 = wp::extract(var_0, var_1360);
                var_1362 = wp::add(var_1361, var_1260);
                var_1364 = wp::extract(var_0, var_1363);
                var_1365 = wp::add(var_1364, var_757);
                var_1366 = block_key_0(var_1359, var_1362, var_1365);
                var_1367 = find_position_0(var_1366, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 24>
                var_1369 = (var_1367 >= var_1368);
                if (var_1369) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 25>
                    var_1370 = wp::float(var_1347);
                    var_1371 = wp::mul(var_1370, var_20);
                    var_1372 = wp::float(var_1260);
                    var_1373 = wp::mul(var_1372, var_20);
                    var_1374 = wp::float(var_757);
                    var_1375 = wp::mul(var_1374, var_20);
                    var_1376 = wp::vec_t<3, wp::float32>(var_1371, var_1373, var_1375);
                    // q = position - shift                                                   <L 26>
                    var_1377 = wp::sub(var_1, var_1376);
                    // first = voxel * voxel_map__room                                        <L 27>
                    var_1378 = wp::mul(var_1367, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 28>
                    var_1379 = wp::address(var_voxel_map__counts, var_1367);
                    var_1381 = wp::load(var_1379);
                    var_1380 = wp::add(var_1378, var_1381);
                    var_1382 = wp::range(var_1378, var_1380);
                    start_for_32:;
                        if (iter_cmp(var_1382) == 0) goto end_for_32;
                        var_1383 = wp::iter_next(var_1382);
                        // d = q - voxel_map__offsets[slot]                                   <L 29>
                        var_1384 = wp::address(var_voxel_map__offsets, var_1383);
                        var_1386 = wp::load(var_1384);
                        var_1385 = wp::sub(var_1377, var_1386);
                        // sqdist = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]                   <L 30>
                        var_1388 = wp::extract(var_1385, var_1387);
                        var_1390 = wp::extract(var_1385, var_1389);
                        var_1391 = wp::mul(var_1388, var_1390);
                        var_1393 = wp::extract(var_1385, var_1392);
                        var_1395 = wp::extract(var_1385, var_1394);
                        var_1396 = wp::mul(var_1393, var_1395);
                        var_1397 = wp::add(var_1391, var_1396);
                        var_1399 = wp::extract(var_1385, var_1398);
                        var_1401 = wp::extract(var_1385, var_1400);
                        var_1402 = wp::mul(var_1399, var_1401);
                        var_1403 = wp::add(var_1397, var_1402);
                        // if sqdist < min_sqdist:                                            <L 31>
                        var_1404 = (var_1403 < var_17);
                        if (var_1404) {
                            // best = d                                                       <L 32>
                            var_1405 = wp::copy(var_1385);
                            // min_sqdist = sqdist                                            <L 33>
                            var_1406 = wp::copy(var_1403);
                            // nearest = slot                                                 <L 34>
                            var_1407 = wp::copy(var_1383);
                        }
                        var_1408 = wp::where(var_1404, var_1405, var_16);
                        var_1409 = wp::where(var_1404, var_1406, var_17);
                        var_1410 = wp::where(var_1404, var_1407, var_19);
                        wp::assign(var_16, var_1408);
                        wp::assign(var_17, var_1409);
                        wp::assign(var_19, var_1410);
                        wp::assign(var_82, var_1385);
                        wp::assign(var_100, var_1403);
                        goto start_for_32;
                    end_for_32:;
                }
                var_1411 = wp::where(var_1369, var_1376, var_1340);
                var_1412 = wp::where(var_1369, var_1377, var_1341);
                var_1413 = wp::where(var_1369, var_1378, var_1342);
                var_1414 = wp::where(var_1369, var_1383, var_1343);
            }
            var_1415 = wp::where(var_1356, var_1367, var_1339);
            var_1416 = wp::where(var_1356, var_1411, var_1340);
            var_1417 = wp::where(var_1356, var_1412, var_1341);
            var_1418 = wp::where(var_1356, var_1413, var_1342);
            var_1419 = wp::where(var_1356, var_1414, var_1343);
            // sx__voxels_around__1 = side_of(x__voxels_around__1, near[0])                   <L 20>
            var_1422 = wp::extract(var_12, var_1421);
            var_1423 = side_of_0(var_1420, var_1422);
            // gx__voxels_around__1 = gap_to(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 21>
            var_1425 = wp::extract(var_1, var_1424);
            var_1426 = gap_to_0(var_1425, var_1423, var_20);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:       <L 22>
            var_1427 = wp::mul(var_1426, var_1426);
            var_1428 = wp::mul(var_1263, var_1263);
            var_1429 = wp::add(var_1427, var_1428);
            var_1430 = wp::mul(var_760, var_760);
            var_1431 = wp::add(var_1429, var_1430);
            var_1432 = (var_1431 < var_17);
            if (var_1432) {
                // voxel = find_position(block_key(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 23>
                var_1434 = wp::extract(var_0, var_1433);
                var_1435 = wp::add(var_1434, var_1423);
                var_1437 = wp::extract(var_0, var_1436);
                var_1438 = wp::add(var_1437, var_1260);
                var_1440 = wp::extract(var_0, var_1439);
                var_1441 = wp::add(var_1440, var_757);
                var_1442 = block_key_0(var_1435, var_1438, var_1441);
                var_1443 = find_position_0(var_1442, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 24>
                var_1445 = (var_1443 >= var_1444);
                if (var_1445) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 25>
                    var_1446 = wp::float(var_1423);
                    var_1447 = wp::mul(var_1446, var_20);
                    var_1448 = wp::float(var_1260);
                    var_1449 = wp::mul(var_1448, var_20);
                    var_1450 = wp::float(var_757);
                    var_1451 = wp::mul(var_1450, var_20);
                    var_1452 = wp::vec_t<3, wp::float32>(var_1447, var_1449, var_1451);
                    // q = position - shift                                                   <L 26>
                    var_1453 = wp::sub(var_1, var_1452);
                    // first = voxel * voxel_map__room                                        <L 27>
                    var_1454 = wp::mul(var_1443, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 28>
                    var_1455 = wp::address(var_voxel_map__counts, var_1443);
                    var_1457 = wp::load(var_1455);
                    var_1456 = wp::add(var_1454, var_1457);
                    var_1458 = wp::range(var_1454, var_1456);
                    start_for_34:;
                        if (iter_cmp(var_1458) == 0) goto end_for_34;
                        var_1459 = wp::iter_next(var_1458);
                        // d = q - voxel_map__offsets[slot]                                   <L 29>
                        var_1460 = wp::address(var_voxel_map__offsets, var_1459);
                        var_1462 = wp::load(var_1460);
                        var_1461 = wp::sub(var_1453, var_1462);
                        // sqdist = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]                   <L 30>
                        var_1464 = wp::extract(var_1461, var_1463);
                        var_1466 = wp::extract(var_1461, var_1465);
                        var_1467 = wp::mul(var_1464, var_1466);
                        var_1469 = wp::extract(var_1461, var_1468);
                        var_1471 = wp::extract(var_1461, var_1470);
                        var_1472 = wp::mul(var_1469, var_1471);
                        var_1473 = wp::add(var_1467, var_1472);
                        var_1475 = wp::extract(var_1461, var_1474);
                        var_1477 = wp::extract(var_1461, var_1476);
                        var_1478 = wp::mul(var_1475, var_1477);
                        var_1479 = wp::add(var_1473, var_1478);
                        // if sqdist < min_sqdist:                                            <L 31>
                        var_1480 = (var_1479 < var_17);
                        if (var_1480) {
                            // best = d                                                       <L 32>
                            var_1481 = wp::copy(var_1461);
                            // min_sqdist = sqdist                                            <L 33>
                            var_1482 = wp::copy(var_1479);
                            // nearest = slot                                                 <L 34>
                            var_1483 = wp::copy(var_1459);
                        }
                        var_1484 = wp::where(var_1480, var_1481, var_16);
                        var_1485 = wp::where(var_1480, var_1482, var_17);
                        var_1486 = wp::where(var_1480, var_1483, var_19);
                        wp::assign(var_16, var_1484);
                        wp::assign(var_17, var_1485);
                        wp::assign(var_19, var_1486);
                        wp::assign(var_82, var_1461);
                        wp::assign(var_100, var_1479);
                        goto start_for_34;
                    end_for_34:;
                }
                var_1487 = wp::where(var_1445, var_1452, var_1416);
                var_1488 = wp::where(var_1445, var_1453, var_1417);
                var_1489 = wp::where(var_1445, var_1454, var_1418);
                var_1490 = wp::where(var_1445, var_1459, var_1419);
            }
            var_1491 = wp::where(var_1432, var_1443, var_1415);
            var_1492 = wp::where(var_1432, var_1487, var_1416);
            var_1493 = wp::where(var_1432, var_1488, var_1417);
            var_1494 = wp::where(var_1432, var_1489, var_1418);
            var_1495 = wp::where(var_1432, var_1490, var_1419);
        }
        var_1496 = wp::where(var_1267, var_1420, var_1249);
        var_1497 = wp::where(var_1267, var_1423, var_1250);
        var_1498 = wp::where(var_1267, var_1426, var_1251);
        var_1499 = wp::where(var_1267, var_1491, var_1252);
        var_1500 = wp::where(var_1267, var_1492, var_1253);
        var_1501 = wp::where(var_1267, var_1493, var_1254);
        var_1502 = wp::where(var_1267, var_1494, var_1255);
        var_1503 = wp::where(var_1267, var_1495, var_1256);
    }
    var_1504 = wp::where(var_762, var_1257, var_507);
    var_1505 = wp::where(var_762, var_1260, var_510);
    var_1506 = wp::where(var_762, var_1263, var_513);
    var_1507 = wp::where(var_762, var_1496, var_746);
    var_1508 = wp::where(var_762, var_1497, var_747);
    var_1509 = wp::where(var_762, var_1498, var_748);
    var_1510 = wp::where(var_762, var_1499, var_749);
    var_1511 = wp::where(var_762, var_1500, var_750);
    var_1512 = wp::where(var_762, var_1501, var_751);
    var_1513 = wp::where(var_762, var_1502, var_752);
    var_1514 = wp::where(var_762, var_1503, var_753);
    // sz__voxels_around__1 = side_of(z__voxels_around__1, near[2])                           <L 12>
    var_1517 = wp::extract(var_12, var_1516);
    var_1518 = side_of_0(var_1515, var_1517);
    // gz__voxels_around__1 = gap_to(position[2], sz__voxels_around__1, edge__voxels_around__1)       <L 13>
    var_1520 = wp::extract(var_1, var_1519);
    var_1521 = gap_to_0(var_1520, var_1518, var_20);
    // if gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:                           <L 14>
    var_1522 = wp::mul(var_1521, var_1521);
    var_1523 = (var_1522 < var_17);
    if (var_1523) {
        // for y__voxels_around__1 in range(3):                                               <L 15>
        // sy__voxels_around__1 = side_of(y__voxels_around__1, near[1])                       <L 16>
        var_1526 = wp::extract(var_12, var_1525);
        var_1527 = side_of_0(var_1524, var_1526);
        // gy__voxels_around__1 = gap_to(position[1], sy__voxels_around__1, edge__voxels_around__1)       <L 17>
        var_1529 = wp::extract(var_1, var_1528);
        var_1530 = gap_to_0(var_1529, var_1527, var_20);
        // if gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:       <L 18>
        var_1531 = wp::mul(var_1530, var_1530);
        var_1532 = wp::mul(var_1521, var_1521);
        var_1533 = wp::add(var_1531, var_1532);
        var_1534 = (var_1533 < var_17);
        if (var_1534) {
            // for x__voxels_around__1 in range(3):                                           <L 19>
            // sx__voxels_around__1 = side_of(x__voxels_around__1, near[0])                   <L 20>
            var_1537 = wp::extract(var_12, var_1536);
            var_1538 = side_of_0(var_1535, var_1537);
            // gx__voxels_around__1 = gap_to(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 21>
            var_1540 = wp::extract(var_1, var_1539);
            var_1541 = gap_to_0(var_1540, var_1538, var_20);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:       <L 22>
            var_1542 = wp::mul(var_1541, var_1541);
            var_1543 = wp::mul(var_1530, var_1530);
            var_1544 = wp::add(var_1542, var_1543);
            var_1545 = wp::mul(var_1521, var_1521);
            var_1546 = wp::add(var_1544, var_1545);
            var_1547 = (var_1546 < var_17);
            if (var_1547) {
                // voxel = find_position(block_key(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 23>
                var_1549 = wp::extract(var_0, var_1548);
                var_1550 = wp::add(var_1549, var_1538);
                var_1552 = wp::extract(var_0, var_1551);
                var_1553 = wp::add(var_1552, var_1527);
                var_1555 = wp::extract(var_0, var_1554);
                var_1556 = wp::add(var_1555, var_1518);
                var_1557 = block_key_0(var_1550, var_1553, var_1556);
                var_1558 = find_position_0(var_1557, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 24>
                var_1560 = (var_1558 >= var_1559);
                if (var_1560) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 25>
                    var_1561 = wp::float(var_1538);
                    var_1562 = wp::mul(var_1561, var_20);
                    var_1563 = wp::float(var_1527);
                    var_1564 = wp::mul(var_1563, var_20);
                    var_1565 = wp::float(var_1518);
                    var_1566 = wp::mul(var_1565, var_20);
                    var_1567 = wp::vec_t<3, wp::float32>(var_1562, var_1564, var_1566);
                    // q = position - shift                                                   <L 26>
                    var_1568 = wp::sub(var_1, var_1567);
                    // first = voxel * voxel_map__room                                        <L 27>
                    var_1569 = wp::mul(var_1558, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 28>
                    var_1570 = wp::address(var_voxel_map__counts, var_1558);
                    var_1572 = wp::load(var_1570);
                    var_1571 = wp::add(var_1569, var_1572);
                    var_1573 = wp::range(var_1569, var_1571);
                    start_for_36:;
                        if (iter_cmp(var_1573) == 0) goto end_for_36;
                        var_1574 = wp::iter_next(var_1573);
                        // d = q - voxel_map__offsets[slot]                                   <L 29>
                        var_1575 = wp::address(var_voxel_map__offsets, var_1574);
                        var_1577 = wp::load(var_1575);
                        var_1576 = wp::sub(var_1568, var_1577);
                        // sqdist = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]                   <L 30>
                        var_1579 = wp::extract(var_1576, var_1578);
                        var_1581 = wp::extract(var_1576, var_1580);
                        var_1582 = wp::mul(var_1579, var_1581);
                        var_1584 = wp::extract(var_1576, var_1583);
                        var_1586 = wp::extract(var_1576, var_1585);
                        var_1587 = wp::mul(var_1584, var_1586);
                        var_1588 = wp::add(var_1582, var_1587);
                        var_1590 = wp::extract(var_1576, var_1589);
                        var_1592 = wp::extract(var_1576, var_1591);
                        var_1593 = wp::mul(var_1590, var_1592);
                        var_1594 = wp::add(var_1588, var_1593);
                        // if sqdist < min_sqdist:                                            <L 31>
                        var_1595 = (var_1594 < var_17);
                        if (var_1595) {
                            // best = d                                                       <L 32>
                            var_1596 = wp::copy(var_1576);
                            // min_sqdist = sqdist                                            <L 33>
                            var_1597 = wp::copy(var_1594);
                            // nearest = slot                                                 <L 34>
                            var_1598 = wp::copy(var_1574);
                        }
                        var_1599 = wp::where(var_1595, var_1596, var_16);
                        var_1600 = wp::where(var_1595, var_1597, var_17);
                        var_1601 = wp::where(var_1595, var_1598, var_19);
                        wp::assign(var_16, var_1599);
                        wp::assign(var_17, var_1600);
                        wp::assign(var_19, var_1601);
                        wp::assign(var_82, var_1576);
                        wp::assign(var_100, var_1594);
                        goto start_for_36;
                    end_for_36:;
                }
                var_1602 = wp::where(var_1560, var_1567, var_1511);
                var_1603 = wp::where(var_1560, var_1568, var_1512);
                var_1604 = wp::where(var_1560, var_1569, var_1513);
                var_1605 = wp::where(var_1560, var_1574, var_1514);
            }
            var_1606 = wp::where(var_1547, var_1558, var_1510);
            var_1607 = wp::where(var_1547, var_1602, var_1511);
            var_1608 = wp::where(var_1547, var_1603, var_1512);
            var_1609 = wp::where(var_1547, var_1604, var_1513);
            var_1610 = wp::where(var_1547, var_1605, var_1514);
            // sx__voxels_around__1 = side_of(x__voxels_around__1, near[0])                   <L 20>
            var_1613 = wp::extract(var_12, var_1612);
            var_1614 = side_of_0(var_1611, var_1613);
            // gx__voxels_around__1 = gap_to(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 21>
            var_1616 = wp::extract(var_1, var_1615);
            var_1617 = gap_to_0(var_1616, var_1614, var_20);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:       <L 22>
            var_1618 = wp::mul(var_1617, var_1617);
            var_1619 = wp::mul(var_1530, var_1530);
            var_1620 = wp::add(var_1618, var_1619);
            var_1621 = wp::mul(var_1521, var_1521);
            var_1622 = wp::add(var_1620, var_1621);
            var_1623 = (var_1622 < var_17);
            if (var_1623) {
                // voxel = find_position(block_key(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 23>
                var_1625 = wp::extract(var_0, var_1624);
                var_1626 = wp::add(var_1625, var_1614);
                var_1628 = wp::extract(var_0, var_1627);
                var_1629 = wp::add(var_1628, var_1527);
                var_1631 = wp::extract(var_0, var_1630);
                var_1632 = wp::add(var_1631, var_1518);
                var_1633 = block_key_0(var_1626, var_1629, var_1632);
                var_1634 = find_position_0(var_1633, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 24>
                var_1636 = (var_1634 >= var_1635);
                if (var_1636) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 25>
                    var_1637 = wp::float(var_1614);
                    var_1638 = wp::mul(var_1637, var_20);
                    var_1639 = wp::float(var_1527);
                    var_1640 = wp::mul(var_1639, var_20);
                    var_1641 = wp::float(var_1518);
                    var_1642 = wp::mul(var_1641, var_20);
                    var_1643 = wp::vec_t<3, wp::float32>(var_1638, var_1640, var_1642);
                    // q = position - shift                                                   <L 26>
                    var_1644 = wp::sub(var_1, var_1643);
                    // first = voxel * voxel_map__room                                        <L 27>
                    var_1645 = wp::mul(var_1634, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 28>
                    var_1646 = wp::address(var_voxel_map__counts, var_1634);
                    var_1648 = wp::load(var_1646);
                    var_1647 = wp::add(var_1645, var_1648);
                    var_1649 = wp::range(var_1645, var_1647);
                    start_for_38:;
                        if (iter_cmp(var_1649) == 0) goto end_for_38;
                        var_1650 = wp::iter_next(var_1649);
                        // d = q - voxel_map__offsets[slot]                                   <L 29>
                        var_1651 = wp::address(var_voxel_map__offsets, var_1650);
                        var_1653 = wp::load(var_1651);
                        var_1652 = wp::sub(var_1644, var_1653);
                        // sqdist = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]                   <L 30>
                        var_1655 = wp::extract(var_1652, var_1654);
                        var_1657 = wp::extract(var_1652, var_1656);
                        var_1658 = wp::mul(var_1655, var_1657);
                        var_1660 = wp::extract(var_1652, var_1659);
                        var_1662 = wp::extract(var_1652, var_1661);
                        var_1663 = wp::mul(var_1660, var_1662);
                        var_1664 = wp::add(var_1658, var_1663);
                        var_1666 = wp::extract(var_1652, var_1665);
                        var_1668 = wp::extract(var_1652, var_1667);
                        var_1669 = wp::mul(var_1666, var_1668);
                        var_1670 = wp::add(var_1664, var_1669);
                        // if sqdist < min_sqdist:                                            <L 31>
                        var_1671 = (var_1670 < var_17);
                        if (var_1671) {
                            // best = d                                                       <L 32>
                            var_1672 = wp::copy(var_1652);
                            // min_sqdist = sqdist                                            <L 33>
                            var_1673 = wp::copy(var_1670);
                            // nearest = slot                                                 <L 34>
                            var_1674 = wp::copy(var_1650);
                        }
                        var_1675 = wp::where(var_1671, var_1672, var_16);
                        var_1676 = wp::where(var_1671, var_1673, var_17);
                        var_1677 = wp::where(var_1671, var_1674, var_19);
                        wp::assign(var_16, var_1675);
                        wp::assign(var_17, var_1676);
                        wp::assign(var_19, var_1677);
                        wp::assign(var_82, var_1652);
                        wp::assign(var_100, var_1670);
                        goto start_for_38;
                    end_for_38:;
                }
                var_1678 = wp::where(var_1636, var_1643, var_1607);
                var_1679 = wp::where(var_1636, var_1644, var_1608);
                var_1680 = wp::where(var_1636, var_1645, var_1609);
                var_1681 = wp::where(var_1636, var_1650, var_1610);
            }
            var_1682 = wp::where(var_1623, var_1634, var_1606);
            var_1683 = wp::where(var_1623, var_1678, var_1607);
            var_1684 = wp::where(var_1623, var_1679, var_1608);
            var_1685 = wp::where(var_1623, var_1680, var_1609);
            var_1686 = wp::where(var_1623, var_1681, var_1610);
            // sx__voxels_around__1 = side_of(x__voxels_around__1, near[0])                   <L 20>
            var_1689 = wp::extract(var_12, var_1688);
            var_1690 = side_of_0(var_1687, var_1689);
            // gx__voxels_around__1 = gap_to(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 21>
            var_1692 = wp::extract(var_1, var_1691);
            var_1693 = gap_to_0(var_1692, var_1690, var_20);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:       <L 22>
            var_1694 = wp::mul(var_1693, var_1693);
            var_1695 = wp::mul(var_1530, var_1530);
            var_1696 = wp::add(var_1694, var_1695);
            var_1697 = wp::mul(var_1521, var_1521);
            var_1698 = wp::add(var_1696, var_1697);
            var_1699 = (var_1698 < var_17);
            if (var_1699) {
                // voxel = find_position(block_key(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 23>
                var_1701 = wp::extract(var_0, var_1700);
                var_1702 = wp::add(var_1701, var_1690);
                var_1704 = wp::extract(var_0, var_1703);
                var_1705 = wp::add(var_1704, var_1527);
                var_1707 = wp::extract(var_0, var_1706);
                var_1708 = wp::add(var_1707, var_1518);
                var_1709 = block_key_0(var_1702, var_1705, var_1708);
                var_1710 = find_position_0(var_1709, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 24>
                var_1712 = (var_1710 >= var_1711);
                if (var_1712) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 25>
                    var_1713 = wp::float(var_1690);
                    var_1714 = wp::mul(var_1713, var_20);
                    var_1715 = wp::float(var_1527);
                    var_1716 = wp::mul(var_1715, var_20);
                    var_1717 = wp::float(var_1518);
                    var_1718 = wp::mul(var_1717, var_20);
                    var_1719 = wp::vec_t<3, wp::float32>(var_1714, var_1716, var_1718);
                    // q = position - shift                                                   <L 26>
                    var_1720 = wp::sub(var_1, var_1719);
                    // first = voxel * voxel_map__room                                        <L 27>
                    var_1721 = wp::mul(var_1710, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 28>
                    var_1722 = wp::address(var_voxel_map__counts, var_1710);
                    var_1724 = wp::load(var_1722);
                    var_1723 = wp::add(var_1721, var_1724);
                    var_1725 = wp::range(var_1721, var_1723);
                    start_for_40:;
                        if (iter_cmp(var_1725) == 0) goto end_for_40;
                        var_1726 = wp::iter_next(var_1725);
                        // d = q - voxel_map__offsets[slot]                                   <L 29>
                        var_1727 = wp::address(var_voxel_map__offsets, var_1726);
                        var_1729 = wp::load(var_1727);
                        var_1728 = wp::sub(var_1720, var_1729);
                        // sqdist = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]                   <L 30>
                        var_1731 = wp::extract(var_1728, var_1730);
                        var_1733 = wp::extract(var_1728, var_1732);
                        var_1734 = wp::mul(var_1731, var_1733);
                        var_1736 = wp::extract(var_1728, var_1735);
                        var_1738 = wp::extract(var_1728, var_1737);
                        var_1739 = wp::mul(var_1736, var_1738);
                        var_1740 = wp::add(var_1734, var_1739);
                        var_1742 = wp::extract(var_1728, var_1741);
                        var_1744 = wp::extract(var_1728, var_1743);
                        var_1745 = wp::mul(var_1742, var_1744);
                        var_1746 = wp::add(var_1740, var_1745);
                        // if sqdist < min_sqdist:                                            <L 31>
                        var_1747 = (var_1746 < var_17);
                        if (var_1747) {
                            // best = d                                                       <L 32>
                            var_1748 = wp::copy(var_1728);
                            // min_sqdist = sqdist                                            <L 33>
                            var_1749 = wp::copy(var_1746);
                            // nearest = slot                                                 <L 34>
                            var_1750 = wp::copy(var_1726);
                        }
                        var_1751 = wp::where(var_1747, var_1748, var_16);
                        var_1752 = wp::where(var_1747, var_1749, var_17);
                        var_1753 = wp::where(var_1747, var_1750, var_19);
                        wp::assign(var_16, var_1751);
                        wp::assign(var_17, var_1752);
                        wp::assign(var_19, var_1753);
                        wp::assign(var_82, var_1728);
                        wp::assign(var_100, var_1746);
                        goto start_for_40;
                    end_for_40:;
                }
                var_1754 = wp::where(var_1712, var_1719, var_1683);
                var_1755 = wp::where(var_1712, var_1720, var_1684);
                var_1756 = wp::where(var_1712, var_1721, var_1685);
                var_1757 = wp::where(var_1712, var_1726, var_1686);
            }
            var_1758 = wp::where(var_1699, var_1710, var_1682);
            var_1759 = wp::where(var_1699, var_1754, var_1683);
            var_1760 = wp::where(var_1699, var_1755, var_1684);
            var_1761 = wp::where(var_1699, var_1756, var_1685);
            var_1762 = wp::where(var_1699, var_1757, var_1686);
        }
        var_1763 = wp::where(var_1534, var_1687, var_1507);
        var_1764 = wp::where(var_1534, var_1690, var_1508);
        var_1765 = wp::where(var_1534, var_1693, var_1509);
        var_1766 = wp::where(var_1534, var_1758, var_1510);
        var_1767 = wp::where(var_1534, var_1759, var_1511);
        var_1768 = wp::where(var_1534, var_1760, var_1512);
        var_1769 = wp::where(var_1534, var_1761, var_1513);
        var_1770 = wp::where(var_1534, var_1762, var_1514);
        // sy__voxels_around__1 = side_of(y__voxels_around__1, near[1])                       <L 16>
        var_1773 = wp::extract(var_12, var_1772);
        var_1774 = side_of_0(var_1771, var_1773);
        // gy__voxels_around__1 = gap_to(position[1], sy__voxels_around__1, edge__voxels_around__1)       <L 17>
        var_1776 = wp::extract(var_1, var_1775);
        var_1777 = gap_to_0(var_1776, var_1774, var_20);
        // if gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:       <L 18>
        var_1778 = wp::mul(var_1777, var_1777);
        var_1779 = wp::mul(var_1521, var_1521);
        var_1780 = wp::add(var_1778, var_1779);
        var_1781 = (var_1780 < var_17);
        if (var_1781) {
            // for x__voxels_around__1 in range(3):                                           <L 19>
            // sx__voxels_around__1 = side_of(x__voxels_around__1, near[0])                   <L 20>
            var_1784 = wp::extract(var_12, var_1783);
            var_1785 = side_of_0(var_1782, var_1784);
            // gx__voxels_around__1 = gap_to(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 21>
            var_1787 = wp::extract(var_1, var_1786);
            var_1788 = gap_to_0(var_1787, var_1785, var_20);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:       <L 22>
            var_1789 = wp::mul(var_1788, var_1788);
            var_1790 = wp::mul(var_1777, var_1777);
            var_1791 = wp::add(var_1789, var_1790);
            var_1792 = wp::mul(var_1521, var_1521);
            var_1793 = wp::add(var_1791, var_1792);
            var_1794 = (var_1793 < var_17);
            if (var_1794) {
                // voxel = find_position(block_key(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 23>
                var_1796 = wp::extract(var_0, var_1795);
                var_1797 = wp::add(var_1796, var_1785);
                var_1799 = wp::extract(var_0, var_1798);
                var_1800 = wp::add(var_1799, var_1774);
                var_1802 = wp::extract(var_0, var_1801);
                var_1803 = wp::add(var_1802, var_1518);
                var_1804 = block_key_0(var_1797, var_1800, var_1803);
                var_1805 = find_position_0(var_1804, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 24>
                var_1807 = (var_1805 >= var_1806);
                if (var_1807) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 25>
                    var_1808 = wp::float(var_1785);
                    var_1809 = wp::mul(var_1808, var_20);
                    var_1810 = wp::float(var_1774);
                    var_1811 = wp::mul(var_1810, var_20);
                    var_1812 = wp::float(var_1518);
                    var_1813 = wp::mul(var_1812, var_20);
                    var_1814 = wp::vec_t<3, wp::float32>(var_1809, var_1811, var_1813);
                    // q = position - shift                                                   <L 26>
                    var_1815 = wp::sub(var_1, var_1814);
                    // first = voxel * voxel_map__room                                        <L 27>
                    var_1816 = wp::mul(var_1805, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 28>
                    var_1817 = wp::address(var_voxel_map__counts, var_1805);
                    var_1819 = wp::load(var_1817);
                    var_1818 = wp::add(var_1816, var_1819);
                    var_1820 = wp::range(var_1816, var_1818);
                    start_for_42:;
                        if (iter_cmp(var_1820) == 0) goto end_for_42;
                        var_1821 = wp::iter_next(var_1820);
                        // d = q - voxel_map__offsets[slot]                                   <L 29>
                        var_1822 = wp::address(var_voxel_map__offsets, var_1821);
                        var_1824 = wp::load(var_1822);
                        var_1823 = wp::sub(var_1815, var_1824);
                        // sqdist = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]                   <L 30>
                        var_1826 = wp::extract(var_1823, var_1825);
                        var_1828 = wp::extract(var_1823, var_1827);
                        var_1829 = wp::mul(var_1826, var_1828);
                        var_1831 = wp::extract(var_1823, var_1830);
                        var_1833 = wp::extract(var_1823, var_1832);
                        var_1834 = wp::mul(var_1831, var_1833);
                        var_1835 = wp::add(var_1829, var_1834);
                        var_1837 = wp::extract(var_1823, var_1836);
                        var_1839 = wp::extract(var_1823, var_1838);
                        var_1840 = wp::mul(var_1837, var_1839);
                        var_1841 = wp::add(var_1835, var_1840);
                        // if sqdist < min_sqdist:                                            <L 31>
                        var_1842 = (var_1841 < var_17);
                        if (var_1842) {
                            // best = d                                                       <L 32>
                            var_1843 = wp::copy(var_1823);
                            // min_sqdist = sqdist                                            <L 33>
                            var_1844 = wp::copy(var_1841);
                            // nearest = slot                                                 <L 34>
                            var_1845 = wp::copy(var_1821);
                        }
                        var_1846 = wp::where(var_1842, var_1843, var_16);
                        var_1847 = wp::where(var_1842, var_1844, var_17);
                        var_1848 = wp::where(var_1842, var_1845, var_19);
                        wp::assign(var_16, var_1846);
                        wp::assign(var_17, var_1847);
                        wp::assign(var_19, var_1848);
                        wp::assign(var_82, var_1823);
                        wp::assign(var_100, var_1841);
                        goto start_for_42;
                    end_for_42:;
                }
                var_1849 = wp::where(var_1807, var_1814, var_1767);
                var_1850 = wp::where(var_1807, var_1815, var_1768);
                var_1851 = wp::where(var_1807, var_1816, var_1769);
                var_1852 = wp::where(var_1807, var_1821, var_1770);
            }
            var_1853 = wp::where(var_1794, var_1805, var_1766);
            var_1854 = wp::where(var_1794, var_1849, var_1767);
            var_1855 = wp::where(var_1794, var_1850, var_1768);
            var_1856 = wp::where(var_1794, var_1851, var_1769);
            var_1857 = wp::where(var_1794, var_1852, var_1770);
            // sx__voxels_around__1 = side_of(x__voxels_around__1, near[0])                   <L 20>
            var_1860 = wp::extract(var_12, var_1859);
            var_1861 = side_of_0(var_1858, var_1860);
            // gx__voxels_around__1 = gap_to(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 21>
            var_1863 = wp::extract(var_1, var_1862);
            var_1864 = gap_to_0(var_1863, var_1861, var_20);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:       <L 22>
            var_1865 = wp::mul(var_1864, var_1864);
            var_1866 = wp::mul(var_1777, var_1777);
            var_1867 = wp::add(var_1865, var_1866);
            var_1868 = wp::mul(var_1521, var_1521);
            var_1869 = wp::add(var_1867, var_1868);
            var_1870 = (var_1869 < var_17);
            if (var_1870) {
                // voxel = find_position(block_key(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 23>
                var_1872 = wp::extract(var_0, var_1871);
                var_1873 = wp::add(var_1872, var_1861);
                var_1875 = wp::extract(var_0, var_1874);
                var_1876 = wp::add(var_1875, var_1774);
                var_1878 = wp::extract(var_0, var_1877);
                var_1879 = wp::add(var_1878, var_1518);
                var_1880 = block_key_0(var_1873, var_1876, var_1879);
                var_1881 = find_position_0(var_1880, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 24>
                var_1883 = (var_1881 >= var_1882);
                if (var_1883) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 25>
                    var_1884 = wp::float(var_1861);
                    var_1885 = wp::mul(var_1884, var_20);
                    var_1886 = wp::float(var_1774);
                    var_1887 = wp::mul(var_1886, var_20);
                    var_1888 = wp::float(var_1518);
                    var_1889 = wp::mul(var_1888, var_20);
                    var_1890 = wp::vec_t<3, wp::float32>(var_1885, var_1887, var_1889);
                    // q = position - shift                                                   <L 26>
                    var_1891 = wp::sub(var_1, var_1890);
                    // first = voxel * voxel_map__room                                        <L 27>
                    var_1892 = wp::mul(var_1881, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 28>
                    var_1893 = wp::address(var_voxel_map__counts, var_1881);
                    var_1895 = wp::load(var_1893);
                    var_1894 = wp::add(var_1892, var_1895);
                    var_1896 = wp::range(var_1892, var_1894);
                    start_for_44:;
                        if (iter_cmp(var_1896) == 0) goto end_for_44;
                        var_1897 = wp::iter_next(var_1896);
                        // d = q - voxel_map__offsets[slot]                                   <L 29>
                        var_1898 = wp::address(var_voxel_map__offsets, var_1897);
                        var_1900 = wp::load(var_1898);
                        var_1899 = wp::sub(var_1891, var_1900);
                        // sqdist = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]                   <L 30>
                        var_1902 = wp::extract(var_1899, var_1901);
                        var_1904 = wp::extract(var_1899, var_1903);
                        var_1905 = wp::mul(var_1902, var_1904);
                        var_1907 = wp::extract(var_1899, var_1906);
                        var_1909 = wp::extract(var_1899, var_1908);
                        var_1910 = wp::mul(var_1907, var_1909);
                        var_1911 = wp::add(var_1905, var_1910);
                        var_1913 = wp::extract(var_1899, var_1912);
                        var_1915 = wp::extract(var_1899, var_1914);
                        var_1916 = wp::mul(var_1913, var_1915);
                        var_1917 = wp::add(var_1911, var_1916);
                        // if sqdist < min_sqdist:                                            <L 31>
                        var_1918 = (var_1917 < var_17);
                        if (var_1918) {
                            // best = d                                                       <L 32>
                            var_1919 = wp::copy(var_1899);
                            // min_sqdist = sqdist                                            <L 33>
                            var_1920 = wp::copy(var_1917);
                            // nearest = slot                                                 <L 34>
                            var_1921 = wp::copy(var_1897);
                        }
                        var_1922 = wp::where(var_1918, var_1919, var_16);
                        var_1923 = wp::where(var_1918, var_1920, var_17);
                        var_1924 = wp::where(var_1918, var_1921, var_19);
                        wp::assign(var_16, var_1922);
                        wp::assign(var_17, var_1923);
                        wp::assign(var_19, var_1924);
                        wp::assign(var_82, var_1899);
                        wp::assign(var_100, var_1917);
                        goto start_for_44;
                    end_for_44:;
                }
                var_1925 = wp::where(var_1883, var_1890, var_1854);
                var_1926 = wp::where(var_1883, var_1891, var_1855);
                var_1927 = wp::where(var_1883, var_1892, var_1856);
                var_1928 = wp::where(var_1883, var_1897, var_1857);
            }
            var_1929 = wp::where(var_1870, var_1881, var_1853);
            var_1930 = wp::where(var_1870, var_1925, var_1854);
            var_1931 = wp::where(var_1870, var_1926, var_1855);
            var_1932 = wp::where(var_1870, var_1927, var_1856);
            var_1933 = wp::where(var_1870, var_1928, var_1857);
            // sx__voxels_around__1 = side_of(x__voxels_around__1, near[0])                   <L 20>
            var_1936 = wp::extract(var_12, var_1935);
            var_1937 = side_of_0(var_1934, var_1936);
            // gx__voxels_around__1 = gap_to(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 21>
            var_1939 = wp::extract(var_1, var_1938);
            var_1940 = gap_to_0(var_1939, var_1937, var_20);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:       <L 22>
            var_1941 = wp::mul(var_1940, var_1940);
            var_1942 = wp::mul(var_1777, var_1777);
            var_1943 = wp::add(var_1941, var_1942);
            var_1944 = wp::mul(var_1521, var_1521);
            var_1945 = wp::add(var_1943, var_1944);
            var_1946 = (var_1945 < var_17);
            if (var_1946) {
                // voxel = find_position(block_key(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 23>
                var_1948 = wp::extract(var_0, var_1947);
                var_1949 = wp::add(var_1948, var_1937);
                var_1951 = wp::extract(var_0, var_1950);
                var_1952 = wp::add(var_1951, var_1774);
                var_1954 = wp::extract(var_0, var_1953);
                var_1955 = wp::add(var_1954, var_1518);
                var_1956 = block_key_0(var_1949, var_1952, var_1955);
                var_1957 = find_position_0(var_1956, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 24>
                var_1959 = (var_1957 >= var_1958);
                if (var_1959) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 25>
                    var_1960 = wp::float(var_1937);
                    var_1961 = wp::mul(var_1960, var_20);
                    var_1962 = wp::float(var_1774);
                    var_1963 = wp::mul(var_1962, var_20);
                    var_1964 = wp::float(var_1518);
                    var_1965 = wp::mul(var_1964, var_20);
                    var_1966 = wp::vec_t<3, wp::float32>(var_1961, var_1963, var_1965);
                    // q = position - shift                                                   <L 26>
                    var_1967 = wp::sub(var_1, var_1966);
                    // first = voxel * voxel_map__room                                        <L 27>
                    var_1968 = wp::mul(var_1957, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 28>
                    var_1969 = wp::address(var_voxel_map__counts, var_1957);
                    var_1971 = wp::load(var_1969);
                    var_1970 = wp::add(var_1968, var_1971);
                    var_1972 = wp::range(var_1968, var_1970);
                    start_for_46:;
                        if (iter_cmp(var_1972) == 0) goto end_for_46;
                        var_1973 = wp::iter_next(var_1972);
                        // d = q - voxel_map__offsets[slot]                                   <L 29>
                        var_1974 = wp::address(var_voxel_map__offsets, var_1973);
                        var_1976 = wp::load(var_1974);
                        var_1975 = wp::sub(var_1967, var_1976);
                        // sqdist = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]                   <L 30>
                        var_1978 = wp::extract(var_1975, var_1977);
                        var_1980 = wp::extract(var_1975, var_1979);
                        var_1981 = wp::mul(var_1978, var_1980);
                        var_1983 = wp::extract(var_1975, var_1982);
                        var_1985 = wp::extract(var_1975, var_1984);
                        var_1986 = wp::mul(var_1983, var_1985);
                        var_1987 = wp::add(var_1981, var_1986);
                        var_1989 = wp::extract(var_1975, var_1988);
                        var_1991 = wp::extract(var_1975, var_1990);
                        var_1992 = wp::mul(var_1989, var_1991);
                        var_1993 = wp::add(var_1987, var_1992);
                        // if sqdist < min_sqdist:                                            <L 31>
                        var_1994 = (var_1993 < var_17);
                        if (var_1994) {
                            // best = d                                                       <L 32>
                            var_1995 = wp::copy(var_1975);
                            // min_sqdist = sqdist                                            <L 33>
                            var_1996 = wp::copy(var_1993);
                            // nearest = slot                                                 <L 34>
                            var_1997 = wp::copy(var_1973);
                        }
                        var_1998 = wp::where(var_1994, var_1995, var_16);
                        var_1999 = wp::where(var_1994, var_1996, var_17);
                        var_2000 = wp::where(var_1994, var_1997, var_19);
                        wp::assign(var_16, var_1998);
                        wp::assign(var_17, var_1999);
                        wp::assign(var_19, var_2000);
                        wp::assign(var_82, var_1975);
                        wp::assign(var_100, var_1993);
                        goto start_for_46;
                    end_for_46:;
                }
                var_2001 = wp::where(var_1959, var_1966, var_1930);
                var_2002 = wp::where(var_1959, var_1967, var_1931);
                var_2003 = wp::where(var_1959, var_1968, var_1932);
                var_2004 = wp::where(var_1959, var_1973, var_1933);
            }
            var_2005 = wp::where(var_1946, var_1957, var_1929);
            var_2006 = wp::where(var_1946, var_2001, var_1930);
            var_2007 = wp::where(var_1946, var_2002, var_1931);
            var_2008 = wp::where(var_1946, var_2003, var_1932);
            var_2009 = wp::where(var_1946, var_2004, var_1933);
        }
        var_2010 = wp::where(var_1781, var_1934, var_1763);
        var_2011 = wp::where(var_1781, var_1937, var_1764);
        var_2012 = wp::where(var_1781, var_1940, var_1765);
        var_2013 = wp::where(var_1781, var_2005, var_1766);
        var_2014 = wp::where(var_1781, var_2006, var_1767);
        var_2015 = wp::where(var_1781, var_2007, var_1768);
        var_2016 = wp::where(var_1781, var_2008, var_1769);
        var_2017 = wp::where(var_1781, var_2009, var_1770);
        // sy__voxels_around__1 = side_of(y__voxels_around__1, near[1])                       <L 16>
        var_2020 = wp::extract(var_12, var_2019);
        var_2021 = side_of_0(var_2018, var_2020);
        // gy__voxels_around__1 = gap_to(position[1], sy__voxels_around__1, edge__voxels_around__1)       <L 17>
        var_2023 = wp::extract(var_1, var_2022);
        var_2024 = gap_to_0(var_2023, var_2021, var_20);
        // if gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:       <L 18>
        var_2025 = wp::mul(var_2024, var_2024);
        var_2026 = wp::mul(var_1521, var_1521);
        var_2027 = wp::add(var_2025, var_2026);
        var_2028 = (var_2027 < var_17);
        if (var_2028) {
            // for x__voxels_around__1 in range(3):                                           <L 19>
            // sx__voxels_around__1 = side_of(x__voxels_around__1, near[0])                   <L 20>
            var_2031 = wp::extract(var_12, var_2030);
            var_2032 = side_of_0(var_2029, var_2031);
            // gx__voxels_around__1 = gap_to(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 21>
            var_2034 = wp::extract(var_1, var_2033);
            var_2035 = gap_to_0(var_2034, var_2032, var_20);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:       <L 22>
            var_2036 = wp::mul(var_2035, var_2035);
            var_2037 = wp::mul(var_2024, var_2024);
            var_2038 = wp::add(var_2036, var_2037);
            var_2039 = wp::mul(var_1521, var_1521);
            var_2040 = wp::add(var_2038, var_2039);
            var_2041 = (var_2040 < var_17);
            if (var_2041) {
                // voxel = find_position(block_key(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 23>
                var_2043 = wp::extract(var_0, var_2042);
                var_2044 = wp::add(var_2043, var_2032);
                var_2046 = wp::extract(var_0, var_2045);
                var_2047 = wp::add(var_2046, var_2021);
                var_2049 = wp::extract(var_0, var_2048);
                var_2050 = wp::add(var_2049, var_1518);
                var_2051 = block_key_0(var_2044, var_2047, var_2050);
                var_2052 = find_position_0(var_2051, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 24>
                var_2054 = (var_2052 >= var_2053);
                if (var_2054) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 25>
                    var_2055 = wp::float(var_2032);
                    var_2056 = wp::mul(var_2055, var_20);
                    var_2057 = wp::float(var_2021);
                    var_2058 = wp::mul(var_2057, var_20);
                    var_2059 = wp::float(var_1518);
                    var_2060 = wp::mul(var_2059, var_20);
                    var_2061 = wp::vec_t<3, wp::float32>(var_2056, var_2058, var_2060);
                    // q = position - shift                                                   <L 26>
                    var_2062 = wp::sub(var_1, var_2061);
                    // first = voxel * voxel_map__room                                        <L 27>
                    var_2063 = wp::mul(var_2052, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 28>
                    var_2064 = wp::address(var_voxel_map__counts, var_2052);
                    var_2066 = wp::load(var_2064);
                    var_2065 = wp::add(var_2063, var_2066);
                    var_2067 = wp::range(var_2063, var_2065);
                    start_for_48:;
                        if (iter_cmp(var_2067) == 0) goto end_for_48;
                        var_2068 = wp::iter_next(var_2067);
                        // d = q - voxel_map__offsets[slot]                                   <L 29>
                        var_2069 = wp::address(var_voxel_map__offsets, var_2068);
                        var_2071 = wp::load(var_2069);
                        var_2070 = wp::sub(var_2062, var_2071);
                        // sqdist = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]                   <L 30>
                        var_2073 = wp::extract(var_2070, var_2072);
                        var_2075 = wp::extract(var_2070, var_2074);
                        var_2076 = wp::mul(var_2073, var_2075);
                        var_2078 = wp::extract(var_2070, var_2077);
                        var_2080 = wp::extract(var_2070, var_2079);
                        var_2081 = wp::mul(var_2078, var_2080);
                        var_2082 = wp::add(var_2076, var_2081);
                        var_2084 = wp::extract(var_2070, var_2083);
                        var_2086 = wp::extract(var_2070, var_2085);
                        var_2087 = wp::mul(var_2084, var_2086);
                        var_2088 = wp::add(var_2082, var_2087);
                        // if sqdist < min_sqdist:                                            <L 31>
                        var_2089 = (var_2088 < var_17);
                        if (var_2089) {
                            // best = d                                                       <L 32>
                            var_2090 = wp::copy(var_2070);
                            // min_sqdist = sqdist                                            <L 33>
                            var_2091 = wp::copy(var_2088);
                            // nearest = slot                                                 <L 34>
                            var_2092 = wp::copy(var_2068);
                        }
                        var_2093 = wp::where(var_2089, var_2090, var_16);
                        var_2094 = wp::where(var_2089, var_2091, var_17);
                        var_2095 = wp::where(var_2089, var_2092, var_19);
                        wp::assign(var_16, var_2093);
                        wp::assign(var_17, var_2094);
                        wp::assign(var_19, var_2095);
                        wp::assign(var_82, var_2070);
                        wp::assign(var_100, var_2088);
                        goto start_for_48;
                    end_for_48:;
                }
                var_2096 = wp::where(var_2054, var_2061, var_2014);
                var_2097 = wp::where(var_2054, var_2062, var_2015);
                var_2098 = wp::where(var_2054, var_2063, var_2016);
                var_2099 = wp::where(var_2054, var_2068, var_2017);
            }
            var_2100 = wp::where(var_2041, var_2052, var_2013);
            var_2101 = wp::where(var_2041, var_2096, var_2014);
            var_2102 = wp::where(var_2041, var_2097, var_2015);
            var_2103 = wp::where(var_2041, var_2098, var_2016);
            var_2104 = wp::where(var_2041, var_2099, var_2017);
            // sx__voxels_around__1 = side_of(x__voxels_around__1, near[0])                   <L 20>
            var_2107 = wp::extract(var_12, var_2106);
            var_2108 = side_of_0(var_2105, var_2107);
            // gx__voxels_around__1 = gap_to(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 21>
            var_2110 = wp::extract(var_1, var_2109);
            var_2111 = gap_to_0(var_2110, var_2108, var_20);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:       <L 22>
            var_2112 = wp::mul(var_2111, var_2111);
            var_2113 = wp::mul(var_2024, var_2024);
            var_2114 = wp::add(var_2112, var_2113);
            var_2115 = wp::mul(var_1521, var_1521);
            var_2116 = wp::add(var_2114, var_2115);
            var_2117 = (var_2116 < var_17);
            if (var_2117) {
                // voxel = find_position(block_key(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 23>
                var_2119 = wp::extract(var_0, var_2118);
                var_2120 = wp::add(var_2119, var_2108);
                var_2122 = wp::extract(var_0, var_2121);
                var_2123 = wp::add(var_2122, var_2021);
                var_2125 = wp::extract(var_0, var_2124);
                var_2126 = wp::add(var_2125, var_1518);
                var_2127 = block_key_0(var_2120, var_2123, var_2126);
                var_2128 = find_position_0(var_2127, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 24>
                var_2130 = (var_2128 >= var_2129);
                if (var_2130) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 25>
                    var_2131 = wp::float(var_2108);
                    var_2132 = wp::mul(var_2131, var_20);
                    var_2133 = wp::float(var_2021);
                    var_2134 = wp::mul(var_2133, var_20);
                    var_2135 = wp::float(var_1518);
                    var_2136 = wp::mul(var_2135, var_20);
                    var_2137 = wp::vec_t<3, wp::float32>(var_2132, var_2134, var_2136);
                    // q = position - shift                                                   <L 26>
                    var_2138 = wp::sub(var_1, var_2137);
                    // first = voxel * voxel_map__room                                        <L 27>
                    var_2139 = wp::mul(var_2128, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 28>
                    var_2140 = wp::address(var_voxel_map__counts, var_2128);
                    var_2142 = wp::load(var_2140);
                    var_2141 = wp::add(var_2139, var_2142);
                    var_2143 = wp::range(var_2139, var_2141);
                    start_for_50:;
                        if (iter_cmp(var_2143) == 0) goto end_for_50;
                        var_2144 = wp::iter_next(var_2143);
                        // d = q - voxel_map__offsets[slot]                                   <L 29>
                        var_2145 = wp::address(var_voxel_map__offsets, var_2144);
                        var_2147 = wp::load(var_2145);
                        var_2146 = wp::sub(var_2138, var_2147);
                        // sqdist = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]                   <L 30>
                        var_2149 = wp::extract(var_2146, var_2148);
                        var_2151 = wp::extract(var_2146, var_2150);
                        var_2152 = wp::mul(var_2149, var_2151);
                        var_2154 = wp::extract(var_2146, var_2153);
                        var_2156 = wp::extract(var_2146, var_2155);
                        var_2157 = wp::mul(var_2154, var_2156);
                        var_2158 = wp::add(var_2152, var_2157);
                        var_2160 = wp::extract(var_2146, var_2159);
                        var_2162 = wp::extract(var_2146, var_2161);
                        var_2163 = wp::mul(var_2160, var_2162);
                        var_2164 = wp::add(var_2158, var_2163);
                        // if sqdist < min_sqdist:                                            <L 31>
                        var_2165 = (var_2164 < var_17);
                        if (var_2165) {
                            // best = d                                                       <L 32>
                            var_2166 = wp::copy(var_2146);
                            // min_sqdist = sqdist                                            <L 33>
                            var_2167 = wp::copy(var_2164);
                            // nearest = slot                                                 <L 34>
                            var_2168 = wp::copy(var_2144);
                        }
                        var_2169 = wp::where(var_2165, var_2166, var_16);
                        var_2170 = wp::where(var_2165, var_2167, var_17);
                        var_2171 = wp::where(var_2165, var_2168, var_19);
                        wp::assign(var_16, var_2169);
                        wp::assign(var_17, var_2170);
                        wp::assign(var_19, var_2171);
                        wp::assign(var_82, var_2146);
                        wp::assign(var_100, var_2164);
                        goto start_for_50;
                    end_for_50:;
                }
                var_2172 = wp::where(var_2130, var_2137, var_2101);
                var_2173 = wp::where(var_2130, var_2138, var_2102);
                var_2174 = wp::where(var_2130, var_2139, var_2103);
                var_2175 = wp::where(var_2130, var_2144, var_2104);
            }
            var_2176 = wp::where(var_2117, var_2128, var_2100);
            var_2177 = wp::where(var_2117, var_2172, var_2101);
            var_2178 = wp::where(var_2117, var_2173, var_2102);
            var_2179 = wp::where(var_2117, var_2174, var_2103);
            var_2180 = wp::where(var_2117, var_2175, var_2104);
            // sx__voxels_around__1 = side_of(x__voxels_around__1, near[0])                   <L 20>
            var_2183 = wp::extract(var_12, var_2182);
            var_2184 = side_of_0(var_2181, var_2183);
            // gx__voxels_around__1 = gap_to(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 21>
            var_2186 = wp::extract(var_1, var_2185);
            var_2187 = gap_to_0(var_2186, var_2184, var_20);
            // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < min_sqdist:       <L 22>
            var_2188 = wp::mul(var_2187, var_2187);
            var_2189 = wp::mul(var_2024, var_2024);
            var_2190 = wp::add(var_2188, var_2189);
            var_2191 = wp::mul(var_1521, var_1521);
            var_2192 = wp::add(var_2190, var_2191);
            var_2193 = (var_2192 < var_17);
            if (var_2193) {
                // voxel = find_position(block_key(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 23>
                var_2195 = wp::extract(var_0, var_2194);
                var_2196 = wp::add(var_2195, var_2184);
                var_2198 = wp::extract(var_0, var_2197);
                var_2199 = wp::add(var_2198, var_2021);
                var_2201 = wp::extract(var_0, var_2200);
                var_2202 = wp::add(var_2201, var_1518);
                var_2203 = block_key_0(var_2196, var_2199, var_2202);
                var_2204 = find_position_0(var_2203, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                // if voxel >= 0:                                                             <L 24>
                var_2206 = (var_2204 >= var_2205);
                if (var_2206) {
                    // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 25>
                    var_2207 = wp::float(var_2184);
                    var_2208 = wp::mul(var_2207, var_20);
                    var_2209 = wp::float(var_2021);
                    var_2210 = wp::mul(var_2209, var_20);
                    var_2211 = wp::float(var_1518);
                    var_2212 = wp::mul(var_2211, var_20);
                    var_2213 = wp::vec_t<3, wp::float32>(var_2208, var_2210, var_2212);
                    // q = position - shift                                                   <L 26>
                    var_2214 = wp::sub(var_1, var_2213);
                    // first = voxel * voxel_map__room                                        <L 27>
                    var_2215 = wp::mul(var_2204, var_voxel_map__room);
                    // for slot in range(first, first + voxel_map__counts[voxel]):            <L 28>
                    var_2216 = wp::address(var_voxel_map__counts, var_2204);
                    var_2218 = wp::load(var_2216);
                    var_2217 = wp::add(var_2215, var_2218);
                    var_2219 = wp::range(var_2215, var_2217);
                    start_for_52:;
                        if (iter_cmp(var_2219) == 0) goto end_for_52;
                        var_2220 = wp::iter_next(var_2219);
                        // d = q - voxel_map__offsets[slot]                                   <L 29>
                        var_2221 = wp::address(var_voxel_map__offsets, var_2220);
                        var_2223 = wp::load(var_2221);
                        var_2222 = wp::sub(var_2214, var_2223);
                        // sqdist = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]                   <L 30>
                        var_2225 = wp::extract(var_2222, var_2224);
                        var_2227 = wp::extract(var_2222, var_2226);
                        var_2228 = wp::mul(var_2225, var_2227);
                        var_2230 = wp::extract(var_2222, var_2229);
                        var_2232 = wp::extract(var_2222, var_2231);
                        var_2233 = wp::mul(var_2230, var_2232);
                        var_2234 = wp::add(var_2228, var_2233);
                        var_2236 = wp::extract(var_2222, var_2235);
                        var_2238 = wp::extract(var_2222, var_2237);
                        var_2239 = wp::mul(var_2236, var_2238);
                        var_2240 = wp::add(var_2234, var_2239);
                        // if sqdist < min_sqdist:                                            <L 31>
                        var_2241 = (var_2240 < var_17);
                        if (var_2241) {
                            // best = d                                                       <L 32>
                            var_2242 = wp::copy(var_2222);
                            // min_sqdist = sqdist                                            <L 33>
                            var_2243 = wp::copy(var_2240);
                            // nearest = slot                                                 <L 34>
                            var_2244 = wp::copy(var_2220);
                        }
                        var_2245 = wp::where(var_2241, var_2242, var_16);
                        var_2246 = wp::where(var_2241, var_2243, var_17);
                        var_2247 = wp::where(var_2241, var_2244, var_19);
                        wp::assign(var_16, var_2245);
                        wp::assign(var_17, var_2246);
                        wp::assign(var_19, var_2247);
                        wp::assign(var_82, var_2222);
                        wp::assign(var_100, var_2240);
                        goto start_for_52;
                    end_for_52:;
                }
                var_2248 = wp::where(var_2206, var_2213, var_2177);
                var_2249 = wp::where(var_2206, var_2214, var_2178);
                var_2250 = wp::where(var_2206, var_2215, var_2179);
                var_2251 = wp::where(var_2206, var_2220, var_2180);
            }
            var_2252 = wp::where(var_2193, var_2204, var_2176);
            var_2253 = wp::where(var_2193, var_2248, var_2177);
            var_2254 = wp::where(var_2193, var_2249, var_2178);
            var_2255 = wp::where(var_2193, var_2250, var_2179);
            var_2256 = wp::where(var_2193, var_2251, var_2180);
        }
        var_2257 = wp::where(var_2028, var_2181, var_2010);
        var_2258 = wp::where(var_2028, var_2184, var_2011);
        var_2259 = wp::where(var_2028, var_2187, var_2012);
        var_2260 = wp::where(var_2028, var_2252, var_2013);
        var_2261 = wp::where(var_2028, var_2253, var_2014);
        var_2262 = wp::where(var_2028, var_2254, var_2015);
        var_2263 = wp::where(var_2028, var_2255, var_2016);
        var_2264 = wp::where(var_2028, var_2256, var_2017);
    }
    var_2265 = wp::where(var_1523, var_2018, var_1504);
    var_2266 = wp::where(var_1523, var_2021, var_1505);
    var_2267 = wp::where(var_1523, var_2024, var_1506);
    var_2268 = wp::where(var_1523, var_2257, var_1507);
    var_2269 = wp::where(var_1523, var_2258, var_1508);
    var_2270 = wp::where(var_1523, var_2259, var_1509);
    var_2271 = wp::where(var_1523, var_2260, var_1510);
    var_2272 = wp::where(var_1523, var_2261, var_1511);
    var_2273 = wp::where(var_1523, var_2262, var_1512);
    var_2274 = wp::where(var_1523, var_2263, var_1513);
    var_2275 = wp::where(var_1523, var_2264, var_1514);
    // return nearest_point(float64(best[0]), float64(best[1]), float64(best[2]), float64(min_sqdist), float64(nearest))       <L 35>
    var_2277 = wp::extract(var_16, var_2276);
    var_2278 = wp::float64(var_2277);
    var_2280 = wp::extract(var_16, var_2279);
    var_2281 = wp::float64(var_2280);
    var_2283 = wp::extract(var_16, var_2282);
    var_2284 = wp::float64(var_2283);
    var_2285 = wp::float64(var_17);
    var_2286 = wp::float64(var_19);
    var_2287 = wp::vec_t<5, wp::float64>({var_2278, var_2281, var_2284, var_2285, var_2286});
    return var_2287;
}


// /work/main/src/pointloom/kernels/odometry/voxel_map_search.py:37
static CUDA_CALLABLE wp::int32 side_in_order_0(
    wp::int32 var_digit,
    wp::int32 var_reach)
{
    //---------
    // primal vars
    wp::int32 var_0;
    //---------
    // forward
    // def side_in_order(digit: int, reach: int) -> int:                                      <L 38>
    // return digit - reach                                                                   <L 40>
    var_0 = wp::sub(var_digit, var_reach);
    return var_0;
}


// <pointloom.kernels.odometry.voxel_map_search.moments_in_map>:1
static CUDA_CALLABLE wp::vec_t<10, wp::float32> moments_in_map_0(
    wp::vec_t<3, wp::float64> var_center,
    wp::float32 var_radius,
    wp::int32 var_reach,
    wp::float64 var_voxel_map__voxel_size,
    wp::int32 var_voxel_map__room,
    wp::array_t<wp::int64> var_voxel_map__table__keys,
    wp::array_t<wp::int32> var_voxel_map__table__positions,
    wp::int64 var_voxel_map__table__mask,
    wp::array_t<wp::int32> var_voxel_map__counts,
    wp::array_t<wp::vec_t<3, wp::float32>> var_voxel_map__offsets)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::int32> var_0;
    wp::vec_t<3, wp::float32> var_1;
    wp::vec_t<3, wp::int32> var_2;
    wp::float32 var_3;
    const wp::float32 var_4 = 0.0;
    wp::vec_t<10, wp::float32> var_5;
    const wp::int32 var_6 = 2;
    wp::int32 var_7;
    const wp::int32 var_8 = 1;
    wp::int32 var_9;
    wp::float32 var_10;
    wp::range_t var_11;
    wp::int32 var_12;
    const wp::int32 var_13 = 2;
    wp::int32 var_14;
    wp::int32 var_15;
    const wp::int32 var_16 = 2;
    wp::float32 var_17;
    wp::float32 var_18;
    wp::float32 var_19;
    bool var_20;
    wp::range_t var_21;
    wp::int32 var_22;
    const wp::int32 var_23 = 1;
    wp::int32 var_24;
    wp::int32 var_25;
    const wp::int32 var_26 = 1;
    wp::float32 var_27;
    wp::float32 var_28;
    wp::float32 var_29;
    wp::float32 var_30;
    wp::float32 var_31;
    bool var_32;
    wp::range_t var_33;
    wp::int32 var_34;
    const wp::int32 var_35 = 0;
    wp::int32 var_36;
    wp::int32 var_37;
    const wp::int32 var_38 = 0;
    wp::float32 var_39;
    wp::float32 var_40;
    wp::float32 var_41;
    wp::float32 var_42;
    wp::float32 var_43;
    wp::float32 var_44;
    wp::float32 var_45;
    bool var_46;
    const wp::int32 var_47 = 0;
    wp::int32 var_48;
    wp::int32 var_49;
    const wp::int32 var_50 = 1;
    wp::int32 var_51;
    wp::int32 var_52;
    const wp::int32 var_53 = 2;
    wp::int32 var_54;
    wp::int32 var_55;
    wp::int64 var_56;
    wp::int32 var_57;
    const wp::int32 var_58 = 0;
    bool var_59;
    wp::float32 var_60;
    wp::float32 var_61;
    wp::float32 var_62;
    wp::float32 var_63;
    wp::float32 var_64;
    wp::float32 var_65;
    wp::vec_t<3, wp::float32> var_66;
    wp::int32 var_67;
    wp::int32* var_68;
    wp::int32 var_69;
    wp::int32 var_70;
    wp::range_t var_71;
    wp::int32 var_72;
    wp::vec_t<3, wp::float32>* var_73;
    wp::vec_t<3, wp::float32> var_74;
    wp::vec_t<3, wp::float32> var_75;
    wp::vec_t<3, wp::float32> var_76;
    const wp::int32 var_77 = 0;
    wp::float32 var_78;
    const wp::int32 var_79 = 1;
    wp::float32 var_80;
    const wp::int32 var_81 = 2;
    wp::float32 var_82;
    wp::float32 var_83;
    wp::float32 var_84;
    wp::float32 var_85;
    wp::float32 var_86;
    wp::float32 var_87;
    bool var_88;
    const wp::float32 var_89 = 1.0;
    wp::float32 var_90;
    wp::float32 var_91;
    wp::float32 var_92;
    wp::float32 var_93;
    wp::float32 var_94;
    wp::float32 var_95;
    wp::vec_t<10, wp::float32> var_96;
    wp::vec_t<10, wp::float32> var_97;
    wp::vec_t<10, wp::float32> var_98;
    //---------
    // forward
    // def moments_in_map(center, radius, reach, voxel_map__voxel_size, voxel_map__room, voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask, voxel_map__counts, voxel_map__offsets):       <L 1>
    // cell = cell_holding(center, voxel_map__voxel_size)                                     <L 3>
    var_0 = cell_holding_0(var_center, var_voxel_map__voxel_size);
    // position = offset_in_cell(center, cell, voxel_map__voxel_size)                         <L 4>
    var_1 = offset_in_cell_0(var_center, var_0, var_voxel_map__voxel_size);
    // order = vec3i(reach, reach, reach)                                                     <L 5>
    var_2 = wp::vec_t<3, wp::int32>(var_reach, var_reach, var_reach);
    // sqradius = radius * radius                                                             <L 6>
    var_3 = wp::mul(var_radius, var_radius);
    // total = map_moments(0.0)                                                               <L 7>
    var_5 = wp::vec_t<10, wp::float32>(var_4);
    // n__voxels_around__1 = 2 * reach + 1                                                    <L 8>
    var_7 = wp::mul(var_6, var_reach);
    var_9 = wp::add(var_7, var_8);
    // edge__voxels_around__1 = float(voxel_map__voxel_size)                                  <L 9>
    var_10 = wp::float(var_voxel_map__voxel_size);
    // for z__voxels_around__1 in range(n__voxels_around__1):                                 <L 10>
    var_11 = wp::range(var_9);
    start_for_0:;
        if (iter_cmp(var_11) == 0) goto end_for_0;
        var_12 = wp::iter_next(var_11);
        // sz__voxels_around__1 = side_in_order(z__voxels_around__1, order[2])                <L 11>
        var_14 = wp::extract(var_2, var_13);
        var_15 = side_in_order_0(var_12, var_14);
        // gz__voxels_around__1 = gap_to(position[2], sz__voxels_around__1, edge__voxels_around__1)       <L 12>
        var_17 = wp::extract(var_1, var_16);
        var_18 = gap_to_0(var_17, var_15, var_10);
        // if gz__voxels_around__1 * gz__voxels_around__1 < sqradius:                         <L 13>
        var_19 = wp::mul(var_18, var_18);
        var_20 = (var_19 < var_3);
        if (var_20) {
            // for y__voxels_around__1 in range(n__voxels_around__1):                         <L 14>
            var_21 = wp::range(var_9);
            start_for_2:;
                if (iter_cmp(var_21) == 0) goto end_for_2;
                var_22 = wp::iter_next(var_21);
                // sy__voxels_around__1 = side_in_order(y__voxels_around__1, order[1])        <L 15>
                var_24 = wp::extract(var_2, var_23);
                var_25 = side_in_order_0(var_22, var_24);
                // gy__voxels_around__1 = gap_to(position[1], sy__voxels_around__1, edge__voxels_around__1)       <L 16>
                var_27 = wp::extract(var_1, var_26);
                var_28 = gap_to_0(var_27, var_25, var_10);
                // if gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 17>
                var_29 = wp::mul(var_28, var_28);
                var_30 = wp::mul(var_18, var_18);
                var_31 = wp::add(var_29, var_30);
                var_32 = (var_31 < var_3);
                if (var_32) {
                    // for x__voxels_around__1 in range(n__voxels_around__1):                 <L 18>
                    var_33 = wp::range(var_9);
                    start_for_4:;
                        if (iter_cmp(var_33) == 0) goto end_for_4;
                        var_34 = wp::iter_next(var_33);
                        // sx__voxels_around__1 = side_in_order(x__voxels_around__1, order[0])       <L 19>
                        var_36 = wp::extract(var_2, var_35);
                        var_37 = side_in_order_0(var_34, var_36);
                        // gx__voxels_around__1 = gap_to(position[0], sx__voxels_around__1, edge__voxels_around__1)       <L 20>
                        var_39 = wp::extract(var_1, var_38);
                        var_40 = gap_to_0(var_39, var_37, var_10);
                        // if gx__voxels_around__1 * gx__voxels_around__1 + gy__voxels_around__1 * gy__voxels_around__1 + gz__voxels_around__1 * gz__voxels_around__1 < sqradius:       <L 21>
                        var_41 = wp::mul(var_40, var_40);
                        var_42 = wp::mul(var_28, var_28);
                        var_43 = wp::add(var_41, var_42);
                        var_44 = wp::mul(var_18, var_18);
                        var_45 = wp::add(var_43, var_44);
                        var_46 = (var_45 < var_3);
                        if (var_46) {
                            // voxel = find_position(block_key(cell[0] + sx__voxels_around__1, cell[1] + sy__voxels_around__1, cell[2] + sz__voxels_around__1), voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask)       <L 22>
                            var_48 = wp::extract(var_0, var_47);
                            var_49 = wp::add(var_48, var_37);
                            var_51 = wp::extract(var_0, var_50);
                            var_52 = wp::add(var_51, var_25);
                            var_54 = wp::extract(var_0, var_53);
                            var_55 = wp::add(var_54, var_15);
                            var_56 = block_key_0(var_49, var_52, var_55);
                            var_57 = find_position_0(var_56, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask);
                            // if voxel >= 0:                                                 <L 23>
                            var_59 = (var_57 >= var_58);
                            if (var_59) {
                                // shift = vec3(float(sx__voxels_around__1) * edge__voxels_around__1, float(sy__voxels_around__1) * edge__voxels_around__1, float(sz__voxels_around__1) * edge__voxels_around__1)       <L 24>
                                var_60 = wp::float(var_37);
                                var_61 = wp::mul(var_60, var_10);
                                var_62 = wp::float(var_25);
                                var_63 = wp::mul(var_62, var_10);
                                var_64 = wp::float(var_15);
                                var_65 = wp::mul(var_64, var_10);
                                var_66 = wp::vec_t<3, wp::float32>(var_61, var_63, var_65);
                                // first = voxel * voxel_map__room                            <L 25>
                                var_67 = wp::mul(var_57, var_voxel_map__room);
                                // for slot in range(first, first + voxel_map__counts[voxel]):       <L 26>
                                var_68 = wp::address(var_voxel_map__counts, var_57);
                                var_70 = wp::load(var_68);
                                var_69 = wp::add(var_67, var_70);
                                var_71 = wp::range(var_67, var_69);
                                start_for_6:;
                                    if (iter_cmp(var_71) == 0) goto end_for_6;
                                    var_72 = wp::iter_next(var_71);
                                    // d = voxel_map__offsets[slot] + shift - position        <L 27>
                                    var_73 = wp::address(var_voxel_map__offsets, var_72);
                                    var_75 = wp::load(var_73);
                                    var_74 = wp::add(var_75, var_66);
                                    var_76 = wp::sub(var_74, var_1);
                                    // x = d[0]                                               <L 28>
                                    var_78 = wp::extract(var_76, var_77);
                                    // y = d[1]                                               <L 29>
                                    var_80 = wp::extract(var_76, var_79);
                                    // z = d[2]                                               <L 30>
                                    var_82 = wp::extract(var_76, var_81);
                                    // if x * x + y * y + z * z < sqradius:                   <L 31>
                                    var_83 = wp::mul(var_78, var_78);
                                    var_84 = wp::mul(var_80, var_80);
                                    var_85 = wp::add(var_83, var_84);
                                    var_86 = wp::mul(var_82, var_82);
                                    var_87 = wp::add(var_85, var_86);
                                    var_88 = (var_87 < var_3);
                                    if (var_88) {
                                        // total += map_moments(1.0, x, y, z, x * x, x * y, x * z, y * y, y * z, z * z)       <L 32>
                                        var_90 = wp::mul(var_78, var_78);
                                        var_91 = wp::mul(var_78, var_80);
                                        var_92 = wp::mul(var_78, var_82);
                                        var_93 = wp::mul(var_80, var_80);
                                        var_94 = wp::mul(var_80, var_82);
                                        var_95 = wp::mul(var_82, var_82);
                                        var_96 = wp::vec_t<10, wp::float32>({var_89, var_78, var_80, var_82, var_90, var_91, var_92, var_93, var_94, var_95});
                                        var_97 = wp::add(var_5, var_96);
                                    }
                                    var_98 = wp::where(var_88, var_97, var_5);
                                    wp::assign(var_5, var_98);
                                    goto start_for_6;
                                end_for_6:;
                            }
                        }
                        goto start_for_4;
                    end_for_4:;
                }
                goto start_for_2;
            end_for_2:;
        }
        goto start_for_0;
    end_for_0:;
    // return total                                                                           <L 33>
    return var_5;
}


// /work/main/src/pointloom/kernels/odometry/voxel_map_search.py:116
static CUDA_CALLABLE wp::vec_t<3, wp::float64> mean_of_0(
    wp::vec_t<10, wp::float32> var_m)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    wp::float64 var_2;
    const wp::int32 var_3 = 1;
    wp::float32 var_4;
    wp::float64 var_5;
    wp::float64 var_6;
    const wp::int32 var_7 = 2;
    wp::float32 var_8;
    wp::float64 var_9;
    wp::float64 var_10;
    const wp::int32 var_11 = 3;
    wp::float32 var_12;
    wp::float64 var_13;
    wp::float64 var_14;
    wp::vec_t<3, wp::float64> var_15;
    //---------
    // forward
    // def mean_of(m: map_moments) -> vec3d:                                                  <L 117>
    // n = float64(m[0])                                                                      <L 119>
    var_1 = wp::extract(var_m, var_0);
    var_2 = wp::float64(var_1);
    // return vec3d(float64(m[1]) / n, float64(m[2]) / n, float64(m[3]) / n)                  <L 120>
    var_4 = wp::extract(var_m, var_3);
    var_5 = wp::float64(var_4);
    var_6 = wp::div(var_5, var_2);
    var_8 = wp::extract(var_m, var_7);
    var_9 = wp::float64(var_8);
    var_10 = wp::div(var_9, var_2);
    var_12 = wp::extract(var_m, var_11);
    var_13 = wp::float64(var_12);
    var_14 = wp::div(var_13, var_2);
    var_15 = wp::vec_t<3, wp::float64>(var_6, var_10, var_14);
    return var_15;
}


// /work/main/src/pointloom/kernels/odometry/voxel_map_search.py:123
static CUDA_CALLABLE wp::mat_t<3, 3, wp::float64> covariance_of_1(
    wp::vec_t<10, wp::float32> var_m,
    wp::vec_t<3, wp::float64> var_mean)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    wp::float64 var_2;
    const wp::int32 var_3 = 4;
    wp::float32 var_4;
    wp::float64 var_5;
    wp::float64 var_6;
    const wp::int32 var_7 = 5;
    wp::float32 var_8;
    wp::float64 var_9;
    wp::float64 var_10;
    const wp::int32 var_11 = 6;
    wp::float32 var_12;
    wp::float64 var_13;
    wp::float64 var_14;
    const wp::int32 var_15 = 7;
    wp::float32 var_16;
    wp::float64 var_17;
    wp::float64 var_18;
    const wp::int32 var_19 = 8;
    wp::float32 var_20;
    wp::float64 var_21;
    wp::float64 var_22;
    const wp::int32 var_23 = 9;
    wp::float32 var_24;
    wp::float64 var_25;
    wp::float64 var_26;
    wp::mat_t<3, 3, wp::float64> var_27;
    wp::mat_t<3, 3, wp::float64> var_28;
    wp::mat_t<3, 3, wp::float64> var_29;
    //---------
    // forward
    // def covariance_of(m: map_moments, mean: vec3d) -> mat33d:                              <L 124>
    // n = float64(m[0])                                                                      <L 126>
    var_1 = wp::extract(var_m, var_0);
    var_2 = wp::float64(var_1);
    // xx = float64(m[4]) / n                                                                 <L 127>
    var_4 = wp::extract(var_m, var_3);
    var_5 = wp::float64(var_4);
    var_6 = wp::div(var_5, var_2);
    // xy = float64(m[5]) / n                                                                 <L 128>
    var_8 = wp::extract(var_m, var_7);
    var_9 = wp::float64(var_8);
    var_10 = wp::div(var_9, var_2);
    // xz = float64(m[6]) / n                                                                 <L 129>
    var_12 = wp::extract(var_m, var_11);
    var_13 = wp::float64(var_12);
    var_14 = wp::div(var_13, var_2);
    // yy = float64(m[7]) / n                                                                 <L 130>
    var_16 = wp::extract(var_m, var_15);
    var_17 = wp::float64(var_16);
    var_18 = wp::div(var_17, var_2);
    // yz = float64(m[8]) / n                                                                 <L 131>
    var_20 = wp::extract(var_m, var_19);
    var_21 = wp::float64(var_20);
    var_22 = wp::div(var_21, var_2);
    // zz = float64(m[9]) / n                                                                 <L 132>
    var_24 = wp::extract(var_m, var_23);
    var_25 = wp::float64(var_24);
    var_26 = wp::div(var_25, var_2);
    // return mat33d(xx, xy, xz, xy, yy, yz, xz, yz, zz) - outer(mean, mean)                  <L 133>
    var_27 = wp::mat_t<3, 3, wp::float64>(var_6, var_10, var_14, var_10, var_18, var_22, var_14, var_22, var_26);
    var_28 = wp::outer(var_mean, var_mean);
    var_29 = wp::sub(var_27, var_28);
    return var_29;
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


// <pointloom.kernels.algebra.eigen.eigenvalues_in_plane>:1
static CUDA_CALLABLE wp::vec_t<2, wp::float64> eigenvalues_in_plane_0(
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
    wp::float64 var_16;
    wp::float64 var_17;
    wp::float64 var_18;
    wp::float64 var_19;
    wp::float64 var_20;
    wp::vec_t<2, wp::float64> var_21;
    //---------
    // forward
    // def eigenvalues_in_plane(a, w):                                                        <L 1>
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
    // middle = (dot(u, au) + dot(v, av)) * float64(0.5)                                      <L 9>
    var_10 = wp::dot(var_0, var_2);
    var_11 = wp::dot(var_1, var_3);
    var_12 = wp::add(var_10, var_11);
    var_13 = 0.5;
    var_14 = wp::mul(var_12, var_13);
    // spread = sqrt(half * half + mixed * mixed)                                             <L 10>
    var_15 = wp::mul(var_8, var_8);
    var_16 = wp::mul(var_9, var_9);
    var_17 = wp::add(var_15, var_16);
    var_18 = wp::sqrt(var_17);
    // return pair(middle - spread, middle + spread)                                          <L 11>
    var_19 = wp::sub(var_14, var_18);
    var_20 = wp::add(var_14, var_18);
    var_21 = wp::vec_t<2, wp::float64>(var_19, var_20);
    return var_21;
}


// /work/main/src/pointloom/kernels/algebra/eigen.py:142
static CUDA_CALLABLE wp::vec_t<3, wp::float64> sorted_diagonal_0(
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
    const wp::int32 var_7 = 0;
    const wp::int32 var_8 = 0;
    wp::float64 var_9;
    const wp::int32 var_10 = 1;
    const wp::int32 var_11 = 1;
    wp::float64 var_12;
    wp::float64 var_13;
    const wp::int32 var_14 = 2;
    const wp::int32 var_15 = 2;
    wp::float64 var_16;
    wp::float64 var_17;
    const wp::int32 var_18 = 2;
    const wp::int32 var_19 = 2;
    wp::float64 var_20;
    wp::float64 var_21;
    wp::float64 var_22;
    const wp::int32 var_23 = 2;
    const wp::int32 var_24 = 2;
    wp::float64 var_25;
    wp::float64 var_26;
    wp::vec_t<3, wp::float64> var_27;
    //---------
    // forward
    // def sorted_diagonal(a: mat33d) -> vec3d:                                               <L 143>
    // low = min(a[0, 0], a[1, 1])                                                            <L 144>
    var_2 = wp::extract(var_a, var_0, var_1);
    var_5 = wp::extract(var_a, var_3, var_4);
    var_6 = wp::min(var_2, var_5);
    // high = max(a[0, 0], a[1, 1])                                                           <L 145>
    var_9 = wp::extract(var_a, var_7, var_8);
    var_12 = wp::extract(var_a, var_10, var_11);
    var_13 = wp::max(var_9, var_12);
    // return vec3d(min(low, a[2, 2]), max(low, min(high, a[2, 2])), max(high, a[2, 2]))       <L 146>
    var_16 = wp::extract(var_a, var_14, var_15);
    var_17 = wp::min(var_6, var_16);
    var_20 = wp::extract(var_a, var_18, var_19);
    var_21 = wp::min(var_13, var_20);
    var_22 = wp::max(var_6, var_21);
    var_25 = wp::extract(var_a, var_23, var_24);
    var_26 = wp::max(var_13, var_25);
    var_27 = wp::vec_t<3, wp::float64>(var_17, var_22, var_26);
    return var_27;
}


// <pointloom.kernels.algebra.eigen.eigenvalues>:1
static CUDA_CALLABLE wp::vec_t<3, wp::float64> eigenvalues_0(
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
    wp::vec_t<2, wp::float64> var_28;
    wp::vec_t<3, wp::float64> var_29;
    wp::float64 var_30;
    const wp::int32 var_31 = 0;
    wp::float64 var_32;
    const wp::int32 var_33 = 1;
    wp::float64 var_34;
    wp::vec_t<3, wp::float64> var_35;
    const wp::int32 var_36 = 2;
    wp::float64 var_37;
    wp::vec_t<3, wp::float64> var_38;
    wp::vec_t<2, wp::float64> var_39;
    const wp::int32 var_40 = 0;
    wp::float64 var_41;
    const wp::int32 var_42 = 1;
    wp::float64 var_43;
    wp::vec_t<3, wp::float64> var_44;
    wp::float64 var_45;
    wp::vec_t<3, wp::float64> var_46;
    wp::vec_t<3, wp::float64> var_47;
    wp::vec_t<3, wp::float64> var_48;
    wp::vec_t<2, wp::float64> var_49;
    wp::vec_t<3, wp::float64> var_50;
    wp::vec_t<3, wp::float64> var_51;
    wp::vec_t<3, wp::float64> var_52;
    wp::vec_t<3, wp::float64> var_53;
    //---------
    // forward
    // def eigenvalues(covariance):                                                           <L 1>
    // values = vec3d(float64(0.0), float64(0.0), float64(0.0))                               <L 3>
    var_0 = 0.0;
    var_1 = 0.0;
    var_2 = 0.0;
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
            // roots = sorted_eigenvalues(a)                                                  <L 8>
            var_13 = sorted_eigenvalues_0(var_9);
            // if roots[1] - roots[0] >= roots[2] - roots[1]:                                 <L 9>
            var_15 = wp::extract(var_13, var_14);
            var_17 = wp::extract(var_13, var_16);
            var_18 = wp::sub(var_15, var_17);
            var_20 = wp::extract(var_13, var_19);
            var_22 = wp::extract(var_13, var_21);
            var_23 = wp::sub(var_20, var_22);
            var_24 = (var_18 >= var_23);
            if (var_24) {
                // w = separated_eigenvector(a, roots[0])                                     <L 10>
                var_26 = wp::extract(var_13, var_25);
                var_27 = separated_eigenvector_0(var_9, var_26);
                // others = eigenvalues_in_plane(a, w)                                        <L 11>
                var_28 = eigenvalues_in_plane_0(var_9, var_27);
                // values = vec3d(dot(w, a @ w), others[0], others[1])                        <L 12>
                var_29 = wp::mul(var_9, var_27);
                var_30 = wp::dot(var_27, var_29);
                var_32 = wp::extract(var_28, var_31);
                var_34 = wp::extract(var_28, var_33);
                var_35 = wp::vec_t<3, wp::float64>(var_30, var_32, var_34);
            }
            if (!var_24) {
                // w = separated_eigenvector(a, roots[2])                                     <L 14>
                var_37 = wp::extract(var_13, var_36);
                var_38 = separated_eigenvector_0(var_9, var_37);
                // others = eigenvalues_in_plane(a, w)                                        <L 15>
                var_39 = eigenvalues_in_plane_0(var_9, var_38);
                // values = vec3d(others[0], others[1], dot(w, a @ w))                        <L 16>
                var_41 = wp::extract(var_39, var_40);
                var_43 = wp::extract(var_39, var_42);
                var_44 = wp::mul(var_9, var_38);
                var_45 = wp::dot(var_38, var_44);
                var_46 = wp::vec_t<3, wp::float64>(var_41, var_43, var_45);
            }
            var_47 = wp::where(var_24, var_35, var_46);
            var_48 = wp::where(var_24, var_27, var_38);
            var_49 = wp::where(var_24, var_28, var_39);
        }
        if (!var_12) {
            // values = sorted_diagonal(a)                                                    <L 18>
            var_50 = sorted_diagonal_0(var_9);
        }
        var_51 = wp::where(var_12, var_47, var_50);
        // values = values * size                                                             <L 19>
        var_52 = wp::mul(var_51, var_4);
    }
    var_53 = wp::where(var_6, var_52, var_3);
    // return values                                                                          <L 20>
    return var_53;
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


// /work/main/src/pointloom/kernels/odometry/map_icp.py:32
static CUDA_CALLABLE wp::vec_t<5, wp::float32> plane_of_1(
    wp::vec_t<10, wp::float32> var_m)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 0.0;
    const wp::float32 var_1 = 0.0;
    const wp::float32 var_2 = 0.0;
    const wp::float32 var_3 = 0.0;
    const wp::float32 var_4 = 0.001;
    wp::vec_t<5, wp::float32> var_5;
    const wp::int32 var_6 = 0;
    wp::float32 var_7;
    const wp::float32 var_8 = 5.0;
    bool var_9;
    wp::vec_t<3, wp::float64> var_10;
    wp::mat_t<3, 3, wp::float64> var_11;
    wp::vec_t<3, wp::float64> var_12;
    const wp::int32 var_13 = 1;
    wp::float64 var_14;
    wp::float64 var_15;
    const wp::int32 var_16 = 2;
    wp::float64 var_17;
    wp::float64 var_18;
    bool var_19;
    const wp::int32 var_20 = 0;
    wp::float64 var_21;
    wp::float64 var_22;
    const wp::int32 var_23 = 1;
    wp::float64 var_24;
    wp::float64 var_25;
    bool var_26;
    wp::vec_t<3, wp::float64> var_27;
    const wp::int32 var_28 = 0;
    wp::float64 var_29;
    wp::float32 var_30;
    const wp::int32 var_31 = 1;
    wp::float64 var_32;
    wp::float32 var_33;
    const wp::int32 var_34 = 2;
    wp::float64 var_35;
    wp::float32 var_36;
    const wp::float32 var_37 = 1.0;
    wp::vec_t<5, wp::float32> var_38;
    const wp::float32 var_39 = 0.0;
    const wp::float32 var_40 = 0.0;
    const wp::float32 var_41 = 0.0;
    const wp::float32 var_42 = 0.0;
    const wp::float32 var_43 = 0.1;
    wp::vec_t<5, wp::float32> var_44;
    wp::vec_t<5, wp::float32> var_45;
    wp::vec_t<5, wp::float32> var_46;
    wp::vec_t<5, wp::float32> var_47;
    //---------
    // forward
    // def plane_of(m: map_moments) -> plane:                                                 <L 33>
    // result = plane(0.0, 0.0, 0.0, 0.0, WEAK_WEIGHT)                                        <L 35>
    var_5 = wp::vec_t<5, wp::float32>({var_0, var_1, var_2, var_3, var_4});
    // if m[0] >= FEW:                                                                        <L 36>
    var_7 = wp::extract(var_m, var_6);
    var_9 = (var_7 >= var_8);
    if (var_9) {
        // C = covariance_of(m, mean_of(m))                                                   <L 37>
        var_10 = mean_of_0(var_m);
        var_11 = covariance_of_1(var_m, var_10);
        // spread = eigenvalues(C)                                                            <L 38>
        var_12 = eigenvalues_0(var_11);
        // if spread[1] > float64(FLAT) * spread[2]:                                          <L 39>
        var_14 = wp::extract(var_12, var_13);
        var_15 = 0.1;
        var_17 = wp::extract(var_12, var_16);
        var_18 = wp::mul(var_15, var_17);
        var_19 = (var_14 > var_18);
        if (var_19) {
            // if spread[0] < float64(FLAT) * spread[1]:                                      <L 40>
            var_21 = wp::extract(var_12, var_20);
            var_22 = wp::float64(var_15);
            var_24 = wp::extract(var_12, var_23);
            var_25 = wp::mul(var_22, var_24);
            var_26 = (var_21 < var_25);
            if (var_26) {
                // normal = smallest_eigenvector(C)                                           <L 41>
                var_27 = smallest_eigenvector_0(var_11);
                // result = plane(float(normal[0]), float(normal[1]), float(normal[2]), 1.0, WEAK_WEIGHT)       <L 42>
                var_29 = wp::extract(var_27, var_28);
                var_30 = wp::float(var_29);
                var_32 = wp::extract(var_27, var_31);
                var_33 = wp::float(var_32);
                var_35 = wp::extract(var_27, var_34);
                var_36 = wp::float(var_35);
                var_38 = wp::vec_t<5, wp::float32>({var_30, var_33, var_36, var_37, var_4});
            }
            if (!var_26) {
                // result = plane(0.0, 0.0, 0.0, 0.0, SCATTERED)                              <L 44>
                var_44 = wp::vec_t<5, wp::float32>({var_39, var_40, var_41, var_42, var_43});
            }
            var_45 = wp::where(var_26, var_38, var_44);
        }
        var_46 = wp::where(var_19, var_45, var_5);
    }
    var_47 = wp::where(var_9, var_46, var_5);
    // return result                                                                          <L 45>
    return var_47;
}


// <pointloom.kernels.odometry.map_icp.plane_around>:1
static CUDA_CALLABLE wp::vec_t<5, wp::float32> plane_around_0(
    wp::vec_t<3, wp::float64> var_center,
    wp::float32 var_radius,
    wp::float64 var_voxel_map__voxel_size,
    wp::int32 var_voxel_map__room,
    wp::array_t<wp::int64> var_voxel_map__table__keys,
    wp::array_t<wp::int32> var_voxel_map__table__positions,
    wp::int64 var_voxel_map__table__mask,
    wp::array_t<wp::int32> var_voxel_map__counts,
    wp::array_t<wp::vec_t<3, wp::float32>> var_voxel_map__offsets)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 1;
    wp::vec_t<10, wp::float32> var_1;
    wp::vec_t<5, wp::float32> var_2;
    bool var_3;
    const wp::int32 var_4 = 3;
    wp::float32 var_5;
    const wp::float32 var_6 = 0.0;
    bool var_7;
    const wp::int32 var_8 = 4;
    wp::float32 var_9;
    const wp::float32 var_10 = 2.0;
    const wp::float32 var_11 = 0.001;
    wp::float32 var_12;
    bool var_13;
    const wp::float32 var_14 = 2.0;
    wp::float32 var_15;
    const wp::int32 var_16 = 2;
    wp::vec_t<10, wp::float32> var_17;
    wp::vec_t<5, wp::float32> var_18;
    const wp::int32 var_19 = 3;
    wp::float32 var_20;
    const wp::float32 var_21 = 0.0;
    bool var_22;
    const wp::int32 var_23 = 0;
    wp::float32 var_24;
    const wp::int32 var_25 = 1;
    wp::float32 var_26;
    const wp::int32 var_27 = 2;
    wp::float32 var_28;
    const wp::float32 var_29 = 0.5;
    wp::vec_t<5, wp::float32> var_30;
    wp::vec_t<5, wp::float32> var_31;
    wp::vec_t<5, wp::float32> var_32;
    //---------
    // forward
    // def plane_around(center, radius, voxel_map__voxel_size, voxel_map__room, voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask, voxel_map__counts, voxel_map__offsets):       <L 1>
    // result = plane_of(moments_in_map(center, radius, 1, voxel_map__voxel_size, voxel_map__room, voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask, voxel_map__counts, voxel_map__offsets))       <L 3>
    var_1 = moments_in_map_0(var_center, var_radius, var_0, var_voxel_map__voxel_size, var_voxel_map__room, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask, var_voxel_map__counts, var_voxel_map__offsets);
    var_2 = plane_of_1(var_1);
    // if result[3] == 0.0 and result[4] < 2.0 * WEAK_WEIGHT:                                 <L 4>
    var_5 = wp::extract(var_2, var_4);
    var_7 = (var_5 == var_6);
    var_3 = var_7;
    if (var_3) {
        var_9 = wp::extract(var_2, var_8);
        var_12 = wp::mul(var_10, var_11);
        var_13 = (var_9 < var_12);
        var_3 = var_3 && var_13;
    }
    if (var_3) {
        // wider = plane_of(moments_in_map(center, 2.0 * radius, 2, voxel_map__voxel_size, voxel_map__room, voxel_map__table__keys, voxel_map__table__positions, voxel_map__table__mask, voxel_map__counts, voxel_map__offsets))       <L 5>
        var_15 = wp::mul(var_14, var_radius);
        var_17 = moments_in_map_0(var_center, var_15, var_16, var_voxel_map__voxel_size, var_voxel_map__room, var_voxel_map__table__keys, var_voxel_map__table__positions, var_voxel_map__table__mask, var_voxel_map__counts, var_voxel_map__offsets);
        var_18 = plane_of_1(var_17);
        // if wider[3] > 0.0:                                                                 <L 6>
        var_20 = wp::extract(var_18, var_19);
        var_22 = (var_20 > var_21);
        if (var_22) {
            // result = plane(wider[0], wider[1], wider[2], WIDE_WEIGHT, WEAK_WEIGHT)         <L 7>
            var_24 = wp::extract(var_18, var_23);
            var_26 = wp::extract(var_18, var_25);
            var_28 = wp::extract(var_18, var_27);
            var_30 = wp::vec_t<5, wp::float32>({var_24, var_26, var_28, var_29, var_11});
        }
        var_31 = wp::where(var_22, var_30, var_2);
    }
    var_32 = wp::where(var_3, var_31, var_2);
    // return result                                                                          <L 8>
    return var_32;
}


// <pointloom.kernels.algebra.matrices.multiply33>:1
static CUDA_CALLABLE wp::mat_t<3, 3, wp::float64> multiply33_0(
    wp::mat_t<3, 3, wp::float64> var_a,
    wp::mat_t<3, 3, wp::float64> var_b)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::mat_t<3, 3, wp::float64> var_1;
    const wp::int32 var_2 = 0;
    const wp::int32 var_3 = 0;
    const wp::int32 var_4 = 0;
    wp::float64 var_5;
    const wp::int32 var_6 = 0;
    wp::float64 var_7;
    wp::float64 var_8;
    const wp::int32 var_9 = 1;
    wp::float64 var_10;
    const wp::int32 var_11 = 1;
    wp::float64 var_12;
    wp::float64 var_13;
    wp::float64 var_14;
    const wp::int32 var_15 = 2;
    wp::float64 var_16;
    const wp::int32 var_17 = 2;
    wp::float64 var_18;
    wp::float64 var_19;
    wp::float64 var_20;
    const wp::int32 var_21 = 1;
    const wp::int32 var_22 = 0;
    wp::float64 var_23;
    const wp::int32 var_24 = 0;
    wp::float64 var_25;
    wp::float64 var_26;
    const wp::int32 var_27 = 1;
    wp::float64 var_28;
    const wp::int32 var_29 = 1;
    wp::float64 var_30;
    wp::float64 var_31;
    wp::float64 var_32;
    const wp::int32 var_33 = 2;
    wp::float64 var_34;
    const wp::int32 var_35 = 2;
    wp::float64 var_36;
    wp::float64 var_37;
    wp::float64 var_38;
    const wp::int32 var_39 = 2;
    const wp::int32 var_40 = 0;
    wp::float64 var_41;
    const wp::int32 var_42 = 0;
    wp::float64 var_43;
    wp::float64 var_44;
    const wp::int32 var_45 = 1;
    wp::float64 var_46;
    const wp::int32 var_47 = 1;
    wp::float64 var_48;
    wp::float64 var_49;
    wp::float64 var_50;
    const wp::int32 var_51 = 2;
    wp::float64 var_52;
    const wp::int32 var_53 = 2;
    wp::float64 var_54;
    wp::float64 var_55;
    wp::float64 var_56;
    const wp::int32 var_57 = 1;
    const wp::int32 var_58 = 0;
    const wp::int32 var_59 = 0;
    wp::float64 var_60;
    const wp::int32 var_61 = 0;
    wp::float64 var_62;
    wp::float64 var_63;
    const wp::int32 var_64 = 1;
    wp::float64 var_65;
    const wp::int32 var_66 = 1;
    wp::float64 var_67;
    wp::float64 var_68;
    wp::float64 var_69;
    const wp::int32 var_70 = 2;
    wp::float64 var_71;
    const wp::int32 var_72 = 2;
    wp::float64 var_73;
    wp::float64 var_74;
    wp::float64 var_75;
    const wp::int32 var_76 = 1;
    const wp::int32 var_77 = 0;
    wp::float64 var_78;
    const wp::int32 var_79 = 0;
    wp::float64 var_80;
    wp::float64 var_81;
    const wp::int32 var_82 = 1;
    wp::float64 var_83;
    const wp::int32 var_84 = 1;
    wp::float64 var_85;
    wp::float64 var_86;
    wp::float64 var_87;
    const wp::int32 var_88 = 2;
    wp::float64 var_89;
    const wp::int32 var_90 = 2;
    wp::float64 var_91;
    wp::float64 var_92;
    wp::float64 var_93;
    const wp::int32 var_94 = 2;
    const wp::int32 var_95 = 0;
    wp::float64 var_96;
    const wp::int32 var_97 = 0;
    wp::float64 var_98;
    wp::float64 var_99;
    const wp::int32 var_100 = 1;
    wp::float64 var_101;
    const wp::int32 var_102 = 1;
    wp::float64 var_103;
    wp::float64 var_104;
    wp::float64 var_105;
    const wp::int32 var_106 = 2;
    wp::float64 var_107;
    const wp::int32 var_108 = 2;
    wp::float64 var_109;
    wp::float64 var_110;
    wp::float64 var_111;
    const wp::int32 var_112 = 2;
    const wp::int32 var_113 = 0;
    const wp::int32 var_114 = 0;
    wp::float64 var_115;
    const wp::int32 var_116 = 0;
    wp::float64 var_117;
    wp::float64 var_118;
    const wp::int32 var_119 = 1;
    wp::float64 var_120;
    const wp::int32 var_121 = 1;
    wp::float64 var_122;
    wp::float64 var_123;
    wp::float64 var_124;
    const wp::int32 var_125 = 2;
    wp::float64 var_126;
    const wp::int32 var_127 = 2;
    wp::float64 var_128;
    wp::float64 var_129;
    wp::float64 var_130;
    const wp::int32 var_131 = 1;
    const wp::int32 var_132 = 0;
    wp::float64 var_133;
    const wp::int32 var_134 = 0;
    wp::float64 var_135;
    wp::float64 var_136;
    const wp::int32 var_137 = 1;
    wp::float64 var_138;
    const wp::int32 var_139 = 1;
    wp::float64 var_140;
    wp::float64 var_141;
    wp::float64 var_142;
    const wp::int32 var_143 = 2;
    wp::float64 var_144;
    const wp::int32 var_145 = 2;
    wp::float64 var_146;
    wp::float64 var_147;
    wp::float64 var_148;
    const wp::int32 var_149 = 2;
    const wp::int32 var_150 = 0;
    wp::float64 var_151;
    const wp::int32 var_152 = 0;
    wp::float64 var_153;
    wp::float64 var_154;
    const wp::int32 var_155 = 1;
    wp::float64 var_156;
    const wp::int32 var_157 = 1;
    wp::float64 var_158;
    wp::float64 var_159;
    wp::float64 var_160;
    const wp::int32 var_161 = 2;
    wp::float64 var_162;
    const wp::int32 var_163 = 2;
    wp::float64 var_164;
    wp::float64 var_165;
    wp::float64 var_166;
    //---------
    // forward
    // def multiply33(a, b):                                                                  <L 1>
    // product = mat33d(float64(0.0))                                                         <L 2>
    var_0 = 0.0;
    var_1 = wp::mat_t<3, 3, wp::float64>(var_0);
    // for row in range(3):                                                                   <L 3>
    // for column in range(3):                                                                <L 4>
    // product[row, column] = a[row, 0] * b[0, column] + a[row, 1] * b[1, column] + a[row, 2] * b[2, column]       <L 5>
    var_5 = wp::extract(var_a, var_2, var_4);
    var_7 = wp::extract(var_b, var_6, var_3);
    var_8 = wp::mul(var_5, var_7);
    var_10 = wp::extract(var_a, var_2, var_9);
    var_12 = wp::extract(var_b, var_11, var_3);
    var_13 = wp::mul(var_10, var_12);
    var_14 = wp::add(var_8, var_13);
    var_16 = wp::extract(var_a, var_2, var_15);
    var_18 = wp::extract(var_b, var_17, var_3);
    var_19 = wp::mul(var_16, var_18);
    var_20 = wp::add(var_14, var_19);
    wp::assign_inplace(var_1, var_2, var_3, var_20);
    var_23 = wp::extract(var_a, var_2, var_22);
    var_25 = wp::extract(var_b, var_24, var_21);
    var_26 = wp::mul(var_23, var_25);
    var_28 = wp::extract(var_a, var_2, var_27);
    var_30 = wp::extract(var_b, var_29, var_21);
    var_31 = wp::mul(var_28, var_30);
    var_32 = wp::add(var_26, var_31);
    var_34 = wp::extract(var_a, var_2, var_33);
    var_36 = wp::extract(var_b, var_35, var_21);
    var_37 = wp::mul(var_34, var_36);
    var_38 = wp::add(var_32, var_37);
    wp::assign_inplace(var_1, var_2, var_21, var_38);
    var_41 = wp::extract(var_a, var_2, var_40);
    var_43 = wp::extract(var_b, var_42, var_39);
    var_44 = wp::mul(var_41, var_43);
    var_46 = wp::extract(var_a, var_2, var_45);
    var_48 = wp::extract(var_b, var_47, var_39);
    var_49 = wp::mul(var_46, var_48);
    var_50 = wp::add(var_44, var_49);
    var_52 = wp::extract(var_a, var_2, var_51);
    var_54 = wp::extract(var_b, var_53, var_39);
    var_55 = wp::mul(var_52, var_54);
    var_56 = wp::add(var_50, var_55);
    wp::assign_inplace(var_1, var_2, var_39, var_56);
    // for column in range(3):                                                                <L 4>
    // product[row, column] = a[row, 0] * b[0, column] + a[row, 1] * b[1, column] + a[row, 2] * b[2, column]       <L 5>
    var_60 = wp::extract(var_a, var_57, var_59);
    var_62 = wp::extract(var_b, var_61, var_58);
    var_63 = wp::mul(var_60, var_62);
    var_65 = wp::extract(var_a, var_57, var_64);
    var_67 = wp::extract(var_b, var_66, var_58);
    var_68 = wp::mul(var_65, var_67);
    var_69 = wp::add(var_63, var_68);
    var_71 = wp::extract(var_a, var_57, var_70);
    var_73 = wp::extract(var_b, var_72, var_58);
    var_74 = wp::mul(var_71, var_73);
    var_75 = wp::add(var_69, var_74);
    wp::assign_inplace(var_1, var_57, var_58, var_75);
    var_78 = wp::extract(var_a, var_57, var_77);
    var_80 = wp::extract(var_b, var_79, var_76);
    var_81 = wp::mul(var_78, var_80);
    var_83 = wp::extract(var_a, var_57, var_82);
    var_85 = wp::extract(var_b, var_84, var_76);
    var_86 = wp::mul(var_83, var_85);
    var_87 = wp::add(var_81, var_86);
    var_89 = wp::extract(var_a, var_57, var_88);
    var_91 = wp::extract(var_b, var_90, var_76);
    var_92 = wp::mul(var_89, var_91);
    var_93 = wp::add(var_87, var_92);
    wp::assign_inplace(var_1, var_57, var_76, var_93);
    var_96 = wp::extract(var_a, var_57, var_95);
    var_98 = wp::extract(var_b, var_97, var_94);
    var_99 = wp::mul(var_96, var_98);
    var_101 = wp::extract(var_a, var_57, var_100);
    var_103 = wp::extract(var_b, var_102, var_94);
    var_104 = wp::mul(var_101, var_103);
    var_105 = wp::add(var_99, var_104);
    var_107 = wp::extract(var_a, var_57, var_106);
    var_109 = wp::extract(var_b, var_108, var_94);
    var_110 = wp::mul(var_107, var_109);
    var_111 = wp::add(var_105, var_110);
    wp::assign_inplace(var_1, var_57, var_94, var_111);
    // for column in range(3):                                                                <L 4>
    // product[row, column] = a[row, 0] * b[0, column] + a[row, 1] * b[1, column] + a[row, 2] * b[2, column]       <L 5>
    var_115 = wp::extract(var_a, var_112, var_114);
    var_117 = wp::extract(var_b, var_116, var_113);
    var_118 = wp::mul(var_115, var_117);
    var_120 = wp::extract(var_a, var_112, var_119);
    var_122 = wp::extract(var_b, var_121, var_113);
    var_123 = wp::mul(var_120, var_122);
    var_124 = wp::add(var_118, var_123);
    var_126 = wp::extract(var_a, var_112, var_125);
    var_128 = wp::extract(var_b, var_127, var_113);
    var_129 = wp::mul(var_126, var_128);
    var_130 = wp::add(var_124, var_129);
    wp::assign_inplace(var_1, var_112, var_113, var_130);
    var_133 = wp::extract(var_a, var_112, var_132);
    var_135 = wp::extract(var_b, var_134, var_131);
    var_136 = wp::mul(var_133, var_135);
    var_138 = wp::extract(var_a, var_112, var_137);
    var_140 = wp::extract(var_b, var_139, var_131);
    var_141 = wp::mul(var_138, var_140);
    var_142 = wp::add(var_136, var_141);
    var_144 = wp::extract(var_a, var_112, var_143);
    var_146 = wp::extract(var_b, var_145, var_131);
    var_147 = wp::mul(var_144, var_146);
    var_148 = wp::add(var_142, var_147);
    wp::assign_inplace(var_1, var_112, var_131, var_148);
    var_151 = wp::extract(var_a, var_112, var_150);
    var_153 = wp::extract(var_b, var_152, var_149);
    var_154 = wp::mul(var_151, var_153);
    var_156 = wp::extract(var_a, var_112, var_155);
    var_158 = wp::extract(var_b, var_157, var_149);
    var_159 = wp::mul(var_156, var_158);
    var_160 = wp::add(var_154, var_159);
    var_162 = wp::extract(var_a, var_112, var_161);
    var_164 = wp::extract(var_b, var_163, var_149);
    var_165 = wp::mul(var_162, var_164);
    var_166 = wp::add(var_160, var_165);
    wp::assign_inplace(var_1, var_112, var_149, var_166);
    // return product                                                                         <L 6>
    return var_1;
}


// <pointloom.kernels.odometry.map_icp.add_pair>:1
static CUDA_CALLABLE wp::vec_t<31, wp::float64> add_pair_0(
    wp::vec_t<31, wp::float64> var_total,
    wp::vec_t<3, wp::float64> var_y,
    wp::vec_t<3, wp::float64> var_r,
    wp::vec_t<5, wp::float32> var_at,
    wp::float64 var_kernel_scale)
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
    const wp::int32 var_10 = 0;
    wp::float64 var_11;
    const wp::int32 var_12 = 0;
    wp::float64 var_13;
    wp::float64 var_14;
    const wp::int32 var_15 = 1;
    wp::float64 var_16;
    const wp::int32 var_17 = 1;
    wp::float64 var_18;
    wp::float64 var_19;
    wp::float64 var_20;
    const wp::int32 var_21 = 2;
    wp::float64 var_22;
    const wp::int32 var_23 = 2;
    wp::float64 var_24;
    wp::float64 var_25;
    wp::float64 var_26;
    const wp::int32 var_27 = 0;
    wp::float64 var_28;
    const wp::int32 var_29 = 0;
    wp::float64 var_30;
    wp::float64 var_31;
    const wp::int32 var_32 = 1;
    wp::float64 var_33;
    const wp::int32 var_34 = 1;
    wp::float64 var_35;
    wp::float64 var_36;
    wp::float64 var_37;
    const wp::int32 var_38 = 2;
    wp::float64 var_39;
    const wp::int32 var_40 = 2;
    wp::float64 var_41;
    wp::float64 var_42;
    wp::float64 var_43;
    wp::float64 var_44;
    const wp::int32 var_45 = 3;
    wp::float32 var_46;
    const wp::float32 var_47 = 0.0;
    bool var_48;
    wp::float64 var_49;
    wp::float64 var_50;
    const wp::int32 var_51 = 3;
    wp::float32 var_52;
    const wp::float32 var_53 = 0.5;
    bool var_54;
    wp::float64 var_55;
    wp::float64 var_56;
    wp::float64 var_57;
    wp::float64 var_58;
    wp::float64 var_59;
    wp::float64 var_60;
    const wp::int32 var_61 = 3;
    wp::float32 var_62;
    wp::float64 var_63;
    wp::float64 var_64;
    const wp::int32 var_65 = 4;
    wp::float32 var_66;
    wp::float64 var_67;
    wp::float64 var_68;
    wp::float64 var_69;
    wp::mat_t<3, 3, wp::float64> var_70;
    wp::mat_t<3, 3, wp::float64> var_71;
    wp::mat_t<3, 3, wp::float64> var_72;
    wp::mat_t<3, 3, wp::float64> var_73;
    const wp::int32 var_74 = 2;
    wp::float64 var_75;
    wp::float64 var_76;
    const wp::int32 var_77 = 1;
    wp::float64 var_78;
    const wp::int32 var_79 = 2;
    wp::float64 var_80;
    const wp::int32 var_81 = 0;
    wp::float64 var_82;
    wp::float64 var_83;
    const wp::int32 var_84 = 1;
    wp::float64 var_85;
    wp::float64 var_86;
    const wp::int32 var_87 = 0;
    wp::float64 var_88;
    wp::mat_t<3, 3, wp::float64> var_89;
    wp::mat_t<3, 3, wp::float64> var_90;
    wp::mat_t<3, 3, wp::float64> var_91;
    wp::mat_t<3, 3, wp::float64> var_92;
    wp::vec_t<3, wp::float64> var_93;
    wp::vec_t<31, wp::float64> var_94;
    const wp::int32 var_95 = 0;
    const wp::int32 var_96 = 0;
    wp::int32 var_97;
    wp::float64 var_98;
    wp::float64 var_99;
    wp::float64 var_100;
    wp::int32 var_101;
    const wp::int32 var_102 = 3;
    wp::int32 var_103;
    const wp::int32 var_104 = 3;
    wp::int32 var_105;
    wp::int32 var_106;
    wp::float64 var_107;
    wp::float64 var_108;
    wp::float64 var_109;
    const wp::int32 var_110 = 3;
    wp::int32 var_111;
    const wp::int32 var_112 = 3;
    wp::int32 var_113;
    wp::int32 var_114;
    const wp::int32 var_115 = 1;
    wp::int32 var_116;
    wp::float64 var_117;
    wp::float64 var_118;
    wp::float64 var_119;
    wp::int32 var_120;
    const wp::int32 var_121 = 3;
    wp::int32 var_122;
    const wp::int32 var_123 = 3;
    wp::int32 var_124;
    wp::int32 var_125;
    wp::float64 var_126;
    wp::float64 var_127;
    wp::float64 var_128;
    const wp::int32 var_129 = 3;
    wp::int32 var_130;
    const wp::int32 var_131 = 3;
    wp::int32 var_132;
    wp::int32 var_133;
    const wp::int32 var_134 = 2;
    wp::int32 var_135;
    wp::float64 var_136;
    wp::float64 var_137;
    wp::float64 var_138;
    wp::int32 var_139;
    const wp::int32 var_140 = 3;
    wp::int32 var_141;
    const wp::int32 var_142 = 3;
    wp::int32 var_143;
    wp::int32 var_144;
    wp::float64 var_145;
    wp::float64 var_146;
    wp::float64 var_147;
    const wp::int32 var_148 = 3;
    wp::int32 var_149;
    const wp::int32 var_150 = 3;
    wp::int32 var_151;
    wp::int32 var_152;
    const wp::int32 var_153 = 0;
    const wp::int32 var_154 = 3;
    wp::int32 var_155;
    wp::int32 var_156;
    wp::float64 var_157;
    wp::float64 var_158;
    wp::float64 var_159;
    const wp::int32 var_160 = 3;
    wp::int32 var_161;
    wp::int32 var_162;
    const wp::int32 var_163 = 1;
    const wp::int32 var_164 = 3;
    wp::int32 var_165;
    wp::int32 var_166;
    wp::float64 var_167;
    wp::float64 var_168;
    wp::float64 var_169;
    const wp::int32 var_170 = 3;
    wp::int32 var_171;
    wp::int32 var_172;
    const wp::int32 var_173 = 2;
    const wp::int32 var_174 = 3;
    wp::int32 var_175;
    wp::int32 var_176;
    wp::float64 var_177;
    wp::float64 var_178;
    wp::float64 var_179;
    const wp::int32 var_180 = 3;
    wp::int32 var_181;
    wp::int32 var_182;
    const wp::int32 var_183 = 21;
    const wp::int32 var_184 = 3;
    wp::int32 var_185;
    wp::int32 var_186;
    wp::float64 var_187;
    wp::float64 var_188;
    wp::float64 var_189;
    const wp::int32 var_190 = 3;
    wp::int32 var_191;
    wp::int32 var_192;
    const wp::int32 var_193 = 1;
    const wp::int32 var_194 = 1;
    wp::int32 var_195;
    wp::float64 var_196;
    wp::float64 var_197;
    wp::float64 var_198;
    wp::int32 var_199;
    const wp::int32 var_200 = 3;
    wp::int32 var_201;
    const wp::int32 var_202 = 3;
    wp::int32 var_203;
    wp::int32 var_204;
    wp::float64 var_205;
    wp::float64 var_206;
    wp::float64 var_207;
    const wp::int32 var_208 = 3;
    wp::int32 var_209;
    const wp::int32 var_210 = 3;
    wp::int32 var_211;
    wp::int32 var_212;
    const wp::int32 var_213 = 2;
    wp::int32 var_214;
    wp::float64 var_215;
    wp::float64 var_216;
    wp::float64 var_217;
    wp::int32 var_218;
    const wp::int32 var_219 = 3;
    wp::int32 var_220;
    const wp::int32 var_221 = 3;
    wp::int32 var_222;
    wp::int32 var_223;
    wp::float64 var_224;
    wp::float64 var_225;
    wp::float64 var_226;
    const wp::int32 var_227 = 3;
    wp::int32 var_228;
    const wp::int32 var_229 = 3;
    wp::int32 var_230;
    wp::int32 var_231;
    const wp::int32 var_232 = 0;
    const wp::int32 var_233 = 3;
    wp::int32 var_234;
    wp::int32 var_235;
    wp::float64 var_236;
    wp::float64 var_237;
    wp::float64 var_238;
    const wp::int32 var_239 = 3;
    wp::int32 var_240;
    wp::int32 var_241;
    const wp::int32 var_242 = 1;
    const wp::int32 var_243 = 3;
    wp::int32 var_244;
    wp::int32 var_245;
    wp::float64 var_246;
    wp::float64 var_247;
    wp::float64 var_248;
    const wp::int32 var_249 = 3;
    wp::int32 var_250;
    wp::int32 var_251;
    const wp::int32 var_252 = 2;
    const wp::int32 var_253 = 3;
    wp::int32 var_254;
    wp::int32 var_255;
    wp::float64 var_256;
    wp::float64 var_257;
    wp::float64 var_258;
    const wp::int32 var_259 = 3;
    wp::int32 var_260;
    wp::int32 var_261;
    const wp::int32 var_262 = 3;
    wp::int32 var_263;
    wp::int32 var_264;
    wp::float64 var_265;
    wp::float64 var_266;
    wp::float64 var_267;
    const wp::int32 var_268 = 3;
    wp::int32 var_269;
    wp::int32 var_270;
    const wp::int32 var_271 = 2;
    const wp::int32 var_272 = 2;
    wp::int32 var_273;
    wp::float64 var_274;
    wp::float64 var_275;
    wp::float64 var_276;
    wp::int32 var_277;
    const wp::int32 var_278 = 3;
    wp::int32 var_279;
    const wp::int32 var_280 = 3;
    wp::int32 var_281;
    wp::int32 var_282;
    wp::float64 var_283;
    wp::float64 var_284;
    wp::float64 var_285;
    const wp::int32 var_286 = 3;
    wp::int32 var_287;
    const wp::int32 var_288 = 3;
    wp::int32 var_289;
    wp::int32 var_290;
    const wp::int32 var_291 = 0;
    const wp::int32 var_292 = 3;
    wp::int32 var_293;
    wp::int32 var_294;
    wp::float64 var_295;
    wp::float64 var_296;
    wp::float64 var_297;
    const wp::int32 var_298 = 3;
    wp::int32 var_299;
    wp::int32 var_300;
    const wp::int32 var_301 = 1;
    const wp::int32 var_302 = 3;
    wp::int32 var_303;
    wp::int32 var_304;
    wp::float64 var_305;
    wp::float64 var_306;
    wp::float64 var_307;
    const wp::int32 var_308 = 3;
    wp::int32 var_309;
    wp::int32 var_310;
    const wp::int32 var_311 = 2;
    const wp::int32 var_312 = 3;
    wp::int32 var_313;
    wp::int32 var_314;
    wp::float64 var_315;
    wp::float64 var_316;
    wp::float64 var_317;
    const wp::int32 var_318 = 3;
    wp::int32 var_319;
    wp::int32 var_320;
    const wp::int32 var_321 = 3;
    wp::int32 var_322;
    wp::int32 var_323;
    wp::float64 var_324;
    wp::float64 var_325;
    wp::float64 var_326;
    const wp::int32 var_327 = 3;
    wp::int32 var_328;
    wp::int32 var_329;
    wp::float64 var_330;
    const wp::int32 var_331 = 1;
    wp::float64 var_332;
    const wp::int32 var_333 = 2;
    wp::float64 var_334;
    wp::float64 var_335;
    const wp::int32 var_336 = 2;
    wp::float64 var_337;
    const wp::int32 var_338 = 1;
    wp::float64 var_339;
    wp::float64 var_340;
    wp::float64 var_341;
    wp::float64 var_342;
    const wp::int32 var_343 = 1;
    wp::int32 var_344;
    wp::float64 var_345;
    const wp::int32 var_346 = 2;
    wp::float64 var_347;
    const wp::int32 var_348 = 0;
    wp::float64 var_349;
    wp::float64 var_350;
    const wp::int32 var_351 = 0;
    wp::float64 var_352;
    const wp::int32 var_353 = 2;
    wp::float64 var_354;
    wp::float64 var_355;
    wp::float64 var_356;
    wp::float64 var_357;
    const wp::int32 var_358 = 1;
    wp::int32 var_359;
    const wp::int32 var_360 = 2;
    wp::int32 var_361;
    wp::float64 var_362;
    const wp::int32 var_363 = 0;
    wp::float64 var_364;
    const wp::int32 var_365 = 1;
    wp::float64 var_366;
    wp::float64 var_367;
    const wp::int32 var_368 = 1;
    wp::float64 var_369;
    const wp::int32 var_370 = 0;
    wp::float64 var_371;
    wp::float64 var_372;
    wp::float64 var_373;
    wp::float64 var_374;
    const wp::int32 var_375 = 2;
    wp::int32 var_376;
    const wp::int32 var_377 = 27;
    wp::float64 var_378;
    wp::float64 var_379;
    const wp::int32 var_380 = 28;
    wp::float64 var_381;
    wp::float64 var_382;
    wp::float64 var_383;
    bool var_384;
    const wp::int32 var_385 = 3;
    wp::float32 var_386;
    const wp::float32 var_387 = 1.0;
    bool var_388;
    const wp::int32 var_389 = 4;
    wp::float32 var_390;
    const wp::float32 var_391 = 2.0;
    const wp::float32 var_392 = 0.001;
    wp::float32 var_393;
    bool var_394;
    const wp::int32 var_395 = 29;
    wp::float64 var_396;
    wp::float64 var_397;
    wp::float64 var_398;
    wp::float64 var_399;
    const wp::int32 var_400 = 30;
    wp::float64 var_401;
    wp::float64 var_402;
    wp::float64 var_403;
    //---------
    // forward
    // def add_pair(total, y, r, at, kernel_scale):                                           <L 1>
    // normal = vec3d(float64(at[0]), float64(at[1]), float64(at[2]))                         <L 3>
    var_1 = wp::extract(var_at, var_0);
    var_2 = wp::float64(var_1);
    var_4 = wp::extract(var_at, var_3);
    var_5 = wp::float64(var_4);
    var_7 = wp::extract(var_at, var_6);
    var_8 = wp::float64(var_7);
    var_9 = wp::vec_t<3, wp::float64>(var_2, var_5, var_8);
    // along = normal[0] * r[0] + normal[1] * r[1] + normal[2] * r[2]                         <L 4>
    var_11 = wp::extract(var_9, var_10);
    var_13 = wp::extract(var_r, var_12);
    var_14 = wp::mul(var_11, var_13);
    var_16 = wp::extract(var_9, var_15);
    var_18 = wp::extract(var_r, var_17);
    var_19 = wp::mul(var_16, var_18);
    var_20 = wp::add(var_14, var_19);
    var_22 = wp::extract(var_9, var_21);
    var_24 = wp::extract(var_r, var_23);
    var_25 = wp::mul(var_22, var_24);
    var_26 = wp::add(var_20, var_25);
    // sqdist = r[0] * r[0] + r[1] * r[1] + r[2] * r[2]                                       <L 5>
    var_28 = wp::extract(var_r, var_27);
    var_30 = wp::extract(var_r, var_29);
    var_31 = wp::mul(var_28, var_30);
    var_33 = wp::extract(var_r, var_32);
    var_35 = wp::extract(var_r, var_34);
    var_36 = wp::mul(var_33, var_35);
    var_37 = wp::add(var_31, var_36);
    var_39 = wp::extract(var_r, var_38);
    var_41 = wp::extract(var_r, var_40);
    var_42 = wp::mul(var_39, var_41);
    var_43 = wp::add(var_37, var_42);
    // square = sqdist                                                                        <L 6>
    var_44 = wp::copy(var_43);
    // if at[3] > 0.0:                                                                        <L 7>
    var_46 = wp::extract(var_at, var_45);
    var_48 = (var_46 > var_47);
    if (var_48) {
        // square = along * along                                                             <L 8>
        var_49 = wp::mul(var_26, var_26);
    }
    var_50 = wp::where(var_48, var_49, var_44);
    // if at[3] == WIDE_WEIGHT:                                                               <L 9>
    var_52 = wp::extract(var_at, var_51);
    var_54 = (var_52 == var_53);
    if (var_54) {
        // square = square * float64(WIDE_SQUARE)                                             <L 10>
        var_55 = 16.0;
        var_56 = wp::mul(var_50, var_55);
    }
    var_57 = wp::where(var_54, var_56, var_50);
    // root = kernel_scale / (kernel_scale + square)                                          <L 11>
    var_58 = wp::add(var_kernel_scale, var_57);
    var_59 = wp::div(var_kernel_scale, var_58);
    // w = root * root                                                                        <L 12>
    var_60 = wp::mul(var_59, var_59);
    // a = w * float64(at[3])                                                                 <L 13>
    var_62 = wp::extract(var_at, var_61);
    var_63 = wp::float64(var_62);
    var_64 = wp::mul(var_60, var_63);
    // b = w * float64(at[4])                                                                 <L 14>
    var_66 = wp::extract(var_at, var_65);
    var_67 = wp::float64(var_66);
    var_68 = wp::mul(var_60, var_67);
    // zero = float64(0.0)                                                                    <L 15>
    var_69 = 0.0;
    // A = outer(normal, normal) * a + mat33d(b, zero, zero, zero, b, zero, zero, zero, b)       <L 16>
    var_70 = wp::outer(var_9, var_9);
    var_71 = wp::mul(var_70, var_64);
    var_72 = wp::mat_t<3, 3, wp::float64>(var_68, var_69, var_69, var_69, var_68, var_69, var_69, var_69, var_68);
    var_73 = wp::add(var_71, var_72);
    // K = mat33d(zero, -y[2], y[1], y[2], zero, -y[0], -y[1], y[0], zero)                    <L 17>
    var_75 = wp::extract(var_y, var_74);
    var_76 = wp::neg(var_75);
    var_78 = wp::extract(var_y, var_77);
    var_80 = wp::extract(var_y, var_79);
    var_82 = wp::extract(var_y, var_81);
    var_83 = wp::neg(var_82);
    var_85 = wp::extract(var_y, var_84);
    var_86 = wp::neg(var_85);
    var_88 = wp::extract(var_y, var_87);
    var_89 = wp::mat_t<3, 3, wp::float64>(var_69, var_76, var_78, var_80, var_69, var_83, var_86, var_88, var_69);
    // turning = multiply33(K, A)                                                             <L 18>
    var_90 = multiply33_0(var_89, var_73);
    // rotation = multiply33(turning, transpose(K))                                           <L 19>
    var_91 = wp::transpose(var_89);
    var_92 = multiply33_0(var_90, var_91);
    // f = A @ r                                                                              <L 20>
    var_93 = wp::mul(var_73, var_r);
    // result = total                                                                         <L 21>
    var_94 = wp::copy(var_total);
    // for i in range(3):                                                                     <L 22>
    // for j in range(i, 3):                                                                  <L 23>
    // result[triangle_index(i, j)] = result[triangle_index(i, j)] + rotation[i, j]           <L 24>
    var_97 = triangle_index_0(var_95, var_96);
    var_98 = wp::extract(var_94, var_97);
    var_99 = wp::extract(var_92, var_95, var_96);
    var_100 = wp::add(var_98, var_99);
    var_101 = triangle_index_0(var_95, var_96);
    wp::assign_inplace(var_94, var_101, var_100);
    // result[triangle_index(i + 3, j + 3)] = result[triangle_index(i + 3, j + 3)] + A[i, j]       <L 25>
    var_103 = wp::add(var_95, var_102);
    var_105 = wp::add(var_96, var_104);
    var_106 = triangle_index_0(var_103, var_105);
    var_107 = wp::extract(var_94, var_106);
    var_108 = wp::extract(var_73, var_95, var_96);
    var_109 = wp::add(var_107, var_108);
    var_111 = wp::add(var_95, var_110);
    var_113 = wp::add(var_96, var_112);
    var_114 = triangle_index_0(var_111, var_113);
    wp::assign_inplace(var_94, var_114, var_109);
    // result[triangle_index(i, j)] = result[triangle_index(i, j)] + rotation[i, j]           <L 24>
    var_116 = triangle_index_0(var_95, var_115);
    var_117 = wp::extract(var_94, var_116);
    var_118 = wp::extract(var_92, var_95, var_115);
    var_119 = wp::add(var_117, var_118);
    var_120 = triangle_index_0(var_95, var_115);
    wp::assign_inplace(var_94, var_120, var_119);
    // result[triangle_index(i + 3, j + 3)] = result[triangle_index(i + 3, j + 3)] + A[i, j]       <L 25>
    var_122 = wp::add(var_95, var_121);
    var_124 = wp::add(var_115, var_123);
    var_125 = triangle_index_0(var_122, var_124);
    var_126 = wp::extract(var_94, var_125);
    var_127 = wp::extract(var_73, var_95, var_115);
    var_128 = wp::add(var_126, var_127);
    var_130 = wp::add(var_95, var_129);
    var_132 = wp::add(var_115, var_131);
    var_133 = triangle_index_0(var_130, var_132);
    wp::assign_inplace(var_94, var_133, var_128);
    // result[triangle_index(i, j)] = result[triangle_index(i, j)] + rotation[i, j]           <L 24>
    var_135 = triangle_index_0(var_95, var_134);
    var_136 = wp::extract(var_94, var_135);
    var_137 = wp::extract(var_92, var_95, var_134);
    var_138 = wp::add(var_136, var_137);
    var_139 = triangle_index_0(var_95, var_134);
    wp::assign_inplace(var_94, var_139, var_138);
    // result[triangle_index(i + 3, j + 3)] = result[triangle_index(i + 3, j + 3)] + A[i, j]       <L 25>
    var_141 = wp::add(var_95, var_140);
    var_143 = wp::add(var_134, var_142);
    var_144 = triangle_index_0(var_141, var_143);
    var_145 = wp::extract(var_94, var_144);
    var_146 = wp::extract(var_73, var_95, var_134);
    var_147 = wp::add(var_145, var_146);
    var_149 = wp::add(var_95, var_148);
    var_151 = wp::add(var_134, var_150);
    var_152 = triangle_index_0(var_149, var_151);
    wp::assign_inplace(var_94, var_152, var_147);
    // for j in range(3):                                                                     <L 26>
    // result[triangle_index(i, j + 3)] = result[triangle_index(i, j + 3)] + turning[i, j]       <L 27>
    var_155 = wp::add(var_153, var_154);
    var_156 = triangle_index_0(var_95, var_155);
    var_157 = wp::extract(var_94, var_156);
    var_158 = wp::extract(var_90, var_95, var_153);
    var_159 = wp::add(var_157, var_158);
    var_161 = wp::add(var_153, var_160);
    var_162 = triangle_index_0(var_95, var_161);
    wp::assign_inplace(var_94, var_162, var_159);
    var_165 = wp::add(var_163, var_164);
    var_166 = triangle_index_0(var_95, var_165);
    var_167 = wp::extract(var_94, var_166);
    var_168 = wp::extract(var_90, var_95, var_163);
    var_169 = wp::add(var_167, var_168);
    var_171 = wp::add(var_163, var_170);
    var_172 = triangle_index_0(var_95, var_171);
    wp::assign_inplace(var_94, var_172, var_169);
    var_175 = wp::add(var_173, var_174);
    var_176 = triangle_index_0(var_95, var_175);
    var_177 = wp::extract(var_94, var_176);
    var_178 = wp::extract(var_90, var_95, var_173);
    var_179 = wp::add(var_177, var_178);
    var_181 = wp::add(var_173, var_180);
    var_182 = triangle_index_0(var_95, var_181);
    wp::assign_inplace(var_94, var_182, var_179);
    // result[TRIANGLE + 3 + i] = result[TRIANGLE + 3 + i] - f[i]                             <L 28>
    var_185 = wp::add(var_183, var_184);
    var_186 = wp::add(var_185, var_95);
    var_187 = wp::extract(var_94, var_186);
    var_188 = wp::extract(var_93, var_95);
    var_189 = wp::sub(var_187, var_188);
    var_191 = wp::add(var_183, var_190);
    var_192 = wp::add(var_191, var_95);
    wp::assign_inplace(var_94, var_192, var_189);
    // for j in range(i, 3):                                                                  <L 23>
    // result[triangle_index(i, j)] = result[triangle_index(i, j)] + rotation[i, j]           <L 24>
    var_195 = triangle_index_0(var_193, var_194);
    var_196 = wp::extract(var_94, var_195);
    var_197 = wp::extract(var_92, var_193, var_194);
    var_198 = wp::add(var_196, var_197);
    var_199 = triangle_index_0(var_193, var_194);
    wp::assign_inplace(var_94, var_199, var_198);
    // result[triangle_index(i + 3, j + 3)] = result[triangle_index(i + 3, j + 3)] + A[i, j]       <L 25>
    var_201 = wp::add(var_193, var_200);
    var_203 = wp::add(var_194, var_202);
    var_204 = triangle_index_0(var_201, var_203);
    var_205 = wp::extract(var_94, var_204);
    var_206 = wp::extract(var_73, var_193, var_194);
    var_207 = wp::add(var_205, var_206);
    var_209 = wp::add(var_193, var_208);
    var_211 = wp::add(var_194, var_210);
    var_212 = triangle_index_0(var_209, var_211);
    wp::assign_inplace(var_94, var_212, var_207);
    // result[triangle_index(i, j)] = result[triangle_index(i, j)] + rotation[i, j]           <L 24>
    var_214 = triangle_index_0(var_193, var_213);
    var_215 = wp::extract(var_94, var_214);
    var_216 = wp::extract(var_92, var_193, var_213);
    var_217 = wp::add(var_215, var_216);
    var_218 = triangle_index_0(var_193, var_213);
    wp::assign_inplace(var_94, var_218, var_217);
    // result[triangle_index(i + 3, j + 3)] = result[triangle_index(i + 3, j + 3)] + A[i, j]       <L 25>
    var_220 = wp::add(var_193, var_219);
    var_222 = wp::add(var_213, var_221);
    var_223 = triangle_index_0(var_220, var_222);
    var_224 = wp::extract(var_94, var_223);
    var_225 = wp::extract(var_73, var_193, var_213);
    var_226 = wp::add(var_224, var_225);
    var_228 = wp::add(var_193, var_227);
    var_230 = wp::add(var_213, var_229);
    var_231 = triangle_index_0(var_228, var_230);
    wp::assign_inplace(var_94, var_231, var_226);
    // for j in range(3):                                                                     <L 26>
    // result[triangle_index(i, j + 3)] = result[triangle_index(i, j + 3)] + turning[i, j]       <L 27>
    var_234 = wp::add(var_232, var_233);
    var_235 = triangle_index_0(var_193, var_234);
    var_236 = wp::extract(var_94, var_235);
    var_237 = wp::extract(var_90, var_193, var_232);
    var_238 = wp::add(var_236, var_237);
    var_240 = wp::add(var_232, var_239);
    var_241 = triangle_index_0(var_193, var_240);
    wp::assign_inplace(var_94, var_241, var_238);
    var_244 = wp::add(var_242, var_243);
    var_245 = triangle_index_0(var_193, var_244);
    var_246 = wp::extract(var_94, var_245);
    var_247 = wp::extract(var_90, var_193, var_242);
    var_248 = wp::add(var_246, var_247);
    var_250 = wp::add(var_242, var_249);
    var_251 = triangle_index_0(var_193, var_250);
    wp::assign_inplace(var_94, var_251, var_248);
    var_254 = wp::add(var_252, var_253);
    var_255 = triangle_index_0(var_193, var_254);
    var_256 = wp::extract(var_94, var_255);
    var_257 = wp::extract(var_90, var_193, var_252);
    var_258 = wp::add(var_256, var_257);
    var_260 = wp::add(var_252, var_259);
    var_261 = triangle_index_0(var_193, var_260);
    wp::assign_inplace(var_94, var_261, var_258);
    // result[TRIANGLE + 3 + i] = result[TRIANGLE + 3 + i] - f[i]                             <L 28>
    var_263 = wp::add(var_183, var_262);
    var_264 = wp::add(var_263, var_193);
    var_265 = wp::extract(var_94, var_264);
    var_266 = wp::extract(var_93, var_193);
    var_267 = wp::sub(var_265, var_266);
    var_269 = wp::add(var_183, var_268);
    var_270 = wp::add(var_269, var_193);
    wp::assign_inplace(var_94, var_270, var_267);
    // for j in range(i, 3):                                                                  <L 23>
    // result[triangle_index(i, j)] = result[triangle_index(i, j)] + rotation[i, j]           <L 24>
    var_273 = triangle_index_0(var_271, var_272);
    var_274 = wp::extract(var_94, var_273);
    var_275 = wp::extract(var_92, var_271, var_272);
    var_276 = wp::add(var_274, var_275);
    var_277 = triangle_index_0(var_271, var_272);
    wp::assign_inplace(var_94, var_277, var_276);
    // result[triangle_index(i + 3, j + 3)] = result[triangle_index(i + 3, j + 3)] + A[i, j]       <L 25>
    var_279 = wp::add(var_271, var_278);
    var_281 = wp::add(var_272, var_280);
    var_282 = triangle_index_0(var_279, var_281);
    var_283 = wp::extract(var_94, var_282);
    var_284 = wp::extract(var_73, var_271, var_272);
    var_285 = wp::add(var_283, var_284);
    var_287 = wp::add(var_271, var_286);
    var_289 = wp::add(var_272, var_288);
    var_290 = triangle_index_0(var_287, var_289);
    wp::assign_inplace(var_94, var_290, var_285);
    // for j in range(3):                                                                     <L 26>
    // result[triangle_index(i, j + 3)] = result[triangle_index(i, j + 3)] + turning[i, j]       <L 27>
    var_293 = wp::add(var_291, var_292);
    var_294 = triangle_index_0(var_271, var_293);
    var_295 = wp::extract(var_94, var_294);
    var_296 = wp::extract(var_90, var_271, var_291);
    var_297 = wp::add(var_295, var_296);
    var_299 = wp::add(var_291, var_298);
    var_300 = triangle_index_0(var_271, var_299);
    wp::assign_inplace(var_94, var_300, var_297);
    var_303 = wp::add(var_301, var_302);
    var_304 = triangle_index_0(var_271, var_303);
    var_305 = wp::extract(var_94, var_304);
    var_306 = wp::extract(var_90, var_271, var_301);
    var_307 = wp::add(var_305, var_306);
    var_309 = wp::add(var_301, var_308);
    var_310 = triangle_index_0(var_271, var_309);
    wp::assign_inplace(var_94, var_310, var_307);
    var_313 = wp::add(var_311, var_312);
    var_314 = triangle_index_0(var_271, var_313);
    var_315 = wp::extract(var_94, var_314);
    var_316 = wp::extract(var_90, var_271, var_311);
    var_317 = wp::add(var_315, var_316);
    var_319 = wp::add(var_311, var_318);
    var_320 = triangle_index_0(var_271, var_319);
    wp::assign_inplace(var_94, var_320, var_317);
    // result[TRIANGLE + 3 + i] = result[TRIANGLE + 3 + i] - f[i]                             <L 28>
    var_322 = wp::add(var_183, var_321);
    var_323 = wp::add(var_322, var_271);
    var_324 = wp::extract(var_94, var_323);
    var_325 = wp::extract(var_93, var_271);
    var_326 = wp::sub(var_324, var_325);
    var_328 = wp::add(var_183, var_327);
    var_329 = wp::add(var_328, var_271);
    wp::assign_inplace(var_94, var_329, var_326);
    // result[TRIANGLE] = result[TRIANGLE] - (y[1] * f[2] - y[2] * f[1])                      <L 29>
    var_330 = wp::extract(var_94, var_183);
    var_332 = wp::extract(var_y, var_331);
    var_334 = wp::extract(var_93, var_333);
    var_335 = wp::mul(var_332, var_334);
    var_337 = wp::extract(var_y, var_336);
    var_339 = wp::extract(var_93, var_338);
    var_340 = wp::mul(var_337, var_339);
    var_341 = wp::sub(var_335, var_340);
    var_342 = wp::sub(var_330, var_341);
    wp::assign_inplace(var_94, var_183, var_342);
    // result[TRIANGLE + 1] = result[TRIANGLE + 1] - (y[2] * f[0] - y[0] * f[2])              <L 30>
    var_344 = wp::add(var_183, var_343);
    var_345 = wp::extract(var_94, var_344);
    var_347 = wp::extract(var_y, var_346);
    var_349 = wp::extract(var_93, var_348);
    var_350 = wp::mul(var_347, var_349);
    var_352 = wp::extract(var_y, var_351);
    var_354 = wp::extract(var_93, var_353);
    var_355 = wp::mul(var_352, var_354);
    var_356 = wp::sub(var_350, var_355);
    var_357 = wp::sub(var_345, var_356);
    var_359 = wp::add(var_183, var_358);
    wp::assign_inplace(var_94, var_359, var_357);
    // result[TRIANGLE + 2] = result[TRIANGLE + 2] - (y[0] * f[1] - y[1] * f[0])              <L 31>
    var_361 = wp::add(var_183, var_360);
    var_362 = wp::extract(var_94, var_361);
    var_364 = wp::extract(var_y, var_363);
    var_366 = wp::extract(var_93, var_365);
    var_367 = wp::mul(var_364, var_366);
    var_369 = wp::extract(var_y, var_368);
    var_371 = wp::extract(var_93, var_370);
    var_372 = wp::mul(var_369, var_371);
    var_373 = wp::sub(var_367, var_372);
    var_374 = wp::sub(var_362, var_373);
    var_376 = wp::add(var_183, var_375);
    wp::assign_inplace(var_94, var_376, var_374);
    // result[SQUARES] = result[SQUARES] + sqdist                                             <L 32>
    var_378 = wp::extract(var_94, var_377);
    var_379 = wp::add(var_378, var_43);
    wp::assign_inplace(var_94, var_377, var_379);
    // result[PAIRS] = result[PAIRS] + float64(1.0)                                           <L 33>
    var_381 = wp::extract(var_94, var_380);
    var_382 = 1.0;
    var_383 = wp::add(var_381, var_382);
    wp::assign_inplace(var_94, var_380, var_383);
    // if at[3] == 1.0 or at[4] > 2.0 * WEAK_WEIGHT:                                          <L 34>
    var_386 = wp::extract(var_at, var_385);
    var_388 = (var_386 == var_387);
    var_384 = var_388;
    if (!var_384) {
        var_390 = wp::extract(var_at, var_389);
        var_393 = wp::mul(var_391, var_392);
        var_394 = (var_390 > var_393);
        var_384 = var_384 || var_394;
    }
    if (var_384) {
        // result[COST] = result[COST] + float64(1.0) - root                                  <L 35>
        var_396 = wp::extract(var_94, var_395);
        var_397 = 1.0;
        var_398 = wp::add(var_396, var_397);
        var_399 = wp::sub(var_398, var_59);
        wp::assign_inplace(var_94, var_395, var_399);
        // result[INFORMATIVE] = result[INFORMATIVE] + float64(1.0)                           <L 36>
        var_401 = wp::extract(var_94, var_400);
        var_402 = 1.0;
        var_403 = wp::add(var_401, var_402);
        wp::assign_inplace(var_94, var_400, var_403);
    }
    // return result                                                                          <L 37>
    return var_94;
}


// <pointloom.kernels.odometry.map_course.leg_number>:1
static CUDA_CALLABLE void adj_leg_number_0(
    wp::int32 var_leg,
    wp::int32 var_column,
    wp::array_t<wp::float64> var_course__orders,
    wp::int32 & adj_leg,
    wp::int32 & adj_column,
    wp::array_t<wp::float64> & adj_course__orders,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/algebra/rigid_solve.py:21
static CUDA_CALLABLE void adj_triangle_index_0(
    wp::int32 var_row,
    wp::int32 var_column,
    wp::int32 & adj_row,
    wp::int32 & adj_column,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.algebra.rigid_solve.full_matrix>:1
static CUDA_CALLABLE void adj_full_matrix_0(
    wp::vec_t<21, wp::float64> var_h,
    wp::vec_t<21, wp::float64> & adj_h,
    wp::vec_t<36, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.algebra.rigid_solve.factor_system>:1
static CUDA_CALLABLE void adj_factor_system_0(
    wp::vec_t<21, wp::float64> var_h,
    wp::vec_t<21, wp::float64> & adj_h,
    wp::vec_t<36, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.algebra.rigid_solve.solve_factored>:1
static CUDA_CALLABLE void adj_solve_factored_0(
    wp::vec_t<36, wp::float64> var_a,
    wp::vec_t<6, wp::float64> var_b,
    wp::vec_t<36, wp::float64> & adj_a,
    wp::vec_t<6, wp::float64> & adj_b,
    wp::vec_t<6, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/algebra/rigid_solve.py:244
static CUDA_CALLABLE void adj_solve_system_0(
    wp::vec_t<21, wp::float64> var_h,
    wp::vec_t<6, wp::float64> var_b,
    wp::vec_t<21, wp::float64> & adj_h,
    wp::vec_t<6, wp::float64> & adj_b,
    wp::vec_t<6, wp::float64> & adj_ret)
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


// <pointloom.kernels.algebra.matrices.multiply44>:1
static CUDA_CALLABLE void adj_multiply44_0(
    wp::mat_t<4, 4, wp::float64> var_a,
    wp::mat_t<4, 4, wp::float64> var_b,
    wp::mat_t<4, 4, wp::float64> & adj_a,
    wp::mat_t<4, 4, wp::float64> & adj_b,
    wp::mat_t<4, 4, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.odometry.map_course.moved_by>:1
static CUDA_CALLABLE void adj_moved_by_0(
    wp::vec_t<6, wp::float64> var_x,
    wp::mat_t<4, 4, wp::float64> var_pose,
    wp::vec_t<6, wp::float64> & adj_x,
    wp::mat_t<4, 4, wp::float64> & adj_pose,
    wp::mat_t<4, 4, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.odometry.map_course.pose_in>:1
static CUDA_CALLABLE void adj_pose_in_0(
    wp::array_t<wp::float64> var_rows,
    wp::int32 var_row,
    wp::array_t<wp::float64> & adj_rows,
    wp::int32 & adj_row,
    wp::mat_t<4, 4, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.odometry.map_course.cost_of>:1
static CUDA_CALLABLE void adj_cost_of_0(
    wp::int32 var_leg,
    wp::array_t<wp::float64> var_course__orders,
    wp::array_t<wp::float64> var_course__results,
    wp::int32 & adj_leg,
    wp::array_t<wp::float64> & adj_course__orders,
    wp::array_t<wp::float64> & adj_course__results,
    wp::float64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.odometry.map_course.start_of>:1
static CUDA_CALLABLE void adj_start_of_0(
    wp::int32 var_leg,
    wp::array_t<wp::float64> var_course__orders,
    wp::array_t<wp::float64> var_course__results,
    wp::int32 & adj_leg,
    wp::array_t<wp::float64> & adj_course__orders,
    wp::array_t<wp::float64> & adj_course__results,
    wp::mat_t<4, 4, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.odometry.map_course.end_leg>:1
static CUDA_CALLABLE void adj_end_leg_0(
    wp::int32 var_leg,
    wp::int32 var_state,
    wp::vec_t<31, wp::float64> var_total,
    wp::array_t<wp::float64> var_course__orders,
    wp::array_t<wp::float64> var_course__results,
    wp::array_t<wp::int32> var_course__states,
    wp::array_t<wp::int32> var_course__running,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_course__poses,
    wp::int32 & adj_leg,
    wp::int32 & adj_state,
    wp::vec_t<31, wp::float64> & adj_total,
    wp::array_t<wp::float64> & adj_course__orders,
    wp::array_t<wp::float64> & adj_course__results,
    wp::array_t<wp::int32> & adj_course__states,
    wp::array_t<wp::int32> & adj_course__running,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> & adj_course__poses)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/algebra/transform.py:27
static CUDA_CALLABLE void adj_widen_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/algebra/rigid_solve.py:310
static CUDA_CALLABLE void adj_rotate_1(
    wp::mat_t<4, 4, wp::float64> var_pose,
    wp::vec_t<3, wp::float64> var_v,
    wp::mat_t<4, 4, wp::float64> & adj_pose,
    wp::vec_t<3, wp::float64> & adj_v,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/odometry/local_cells.py:9
static CUDA_CALLABLE void adj_cell_holding_0(
    wp::vec_t<3, wp::float64> var_x,
    wp::float64 var_size,
    wp::vec_t<3, wp::float64> & adj_x,
    wp::float64 & adj_size,
    wp::vec_t<3, wp::int32> & adj_ret)
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


// /work/main/src/pointloom/kernels/odometry/local_cells.py:14
static CUDA_CALLABLE void adj_offset_in_cell_0(
    wp::vec_t<3, wp::float64> var_x,
    wp::vec_t<3, wp::int32> var_cell,
    wp::float64 var_size,
    wp::vec_t<3, wp::float64> & adj_x,
    wp::vec_t<3, wp::int32> & adj_cell,
    wp::float64 & adj_size,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/odometry/voxel_map_search.py:43
static CUDA_CALLABLE void adj_nearer_side_0(
    wp::float32 var_offset,
    wp::float32 var_size,
    wp::float32 & adj_offset,
    wp::float32 & adj_size,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.odometry.voxel_map_search.side_of>:1
static CUDA_CALLABLE void adj_side_of_0(
    wp::int32 var_digit,
    wp::int32 var_near,
    wp::int32 & adj_digit,
    wp::int32 & adj_near,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.odometry.voxel_map_search.gap_to>:1
static CUDA_CALLABLE void adj_gap_to_0(
    wp::float32 var_offset,
    wp::int32 var_side,
    wp::float32 var_size,
    wp::float32 & adj_offset,
    wp::int32 & adj_side,
    wp::float32 & adj_size,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/arrays/block_keys.py:10
static CUDA_CALLABLE void adj_block_key_0(
    wp::int32 var_x,
    wp::int32 var_y,
    wp::int32 var_z,
    wp::int32 & adj_x,
    wp::int32 & adj_y,
    wp::int32 & adj_z,
    wp::int64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.arrays.hash_table.mix_bits>:1
static CUDA_CALLABLE void adj_mix_bits_0(
    wp::int64 var_key,
    wp::int64 & adj_key,
    wp::int64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.arrays.hash_table.find_slot>:1
static CUDA_CALLABLE void adj_find_slot_0(
    wp::int64 var_key,
    wp::array_t<wp::int64> var_table__keys,
    wp::int64 var_table__mask,
    wp::int64 & adj_key,
    wp::array_t<wp::int64> & adj_table__keys,
    wp::int64 & adj_table__mask,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.arrays.hash_table.find_position>:1
static CUDA_CALLABLE void adj_find_position_0(
    wp::int64 var_key,
    wp::array_t<wp::int64> var_table__keys,
    wp::array_t<wp::int32> var_table__positions,
    wp::int64 var_table__mask,
    wp::int64 & adj_key,
    wp::array_t<wp::int64> & adj_table__keys,
    wp::array_t<wp::int32> & adj_table__positions,
    wp::int64 & adj_table__mask,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.odometry.voxel_map_search.find_nearest_in_map>:1
static CUDA_CALLABLE void adj_find_nearest_in_map_0(
    wp::vec_t<3, wp::float64> var_x,
    wp::float32 var_limit,
    wp::float64 var_voxel_map__voxel_size,
    wp::int32 var_voxel_map__room,
    wp::array_t<wp::int64> var_voxel_map__table__keys,
    wp::array_t<wp::int32> var_voxel_map__table__positions,
    wp::int64 var_voxel_map__table__mask,
    wp::array_t<wp::int32> var_voxel_map__counts,
    wp::array_t<wp::vec_t<3, wp::float32>> var_voxel_map__offsets,
    wp::vec_t<3, wp::float64> & adj_x,
    wp::float32 & adj_limit,
    wp::float64 & adj_voxel_map__voxel_size,
    wp::int32 & adj_voxel_map__room,
    wp::array_t<wp::int64> & adj_voxel_map__table__keys,
    wp::array_t<wp::int32> & adj_voxel_map__table__positions,
    wp::int64 & adj_voxel_map__table__mask,
    wp::array_t<wp::int32> & adj_voxel_map__counts,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_voxel_map__offsets,
    wp::vec_t<5, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/odometry/voxel_map_search.py:37
static CUDA_CALLABLE void adj_side_in_order_0(
    wp::int32 var_digit,
    wp::int32 var_reach,
    wp::int32 & adj_digit,
    wp::int32 & adj_reach,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.odometry.voxel_map_search.moments_in_map>:1
static CUDA_CALLABLE void adj_moments_in_map_0(
    wp::vec_t<3, wp::float64> var_center,
    wp::float32 var_radius,
    wp::int32 var_reach,
    wp::float64 var_voxel_map__voxel_size,
    wp::int32 var_voxel_map__room,
    wp::array_t<wp::int64> var_voxel_map__table__keys,
    wp::array_t<wp::int32> var_voxel_map__table__positions,
    wp::int64 var_voxel_map__table__mask,
    wp::array_t<wp::int32> var_voxel_map__counts,
    wp::array_t<wp::vec_t<3, wp::float32>> var_voxel_map__offsets,
    wp::vec_t<3, wp::float64> & adj_center,
    wp::float32 & adj_radius,
    wp::int32 & adj_reach,
    wp::float64 & adj_voxel_map__voxel_size,
    wp::int32 & adj_voxel_map__room,
    wp::array_t<wp::int64> & adj_voxel_map__table__keys,
    wp::array_t<wp::int32> & adj_voxel_map__table__positions,
    wp::int64 & adj_voxel_map__table__mask,
    wp::array_t<wp::int32> & adj_voxel_map__counts,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_voxel_map__offsets,
    wp::vec_t<10, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/odometry/voxel_map_search.py:116
static CUDA_CALLABLE void adj_mean_of_0(
    wp::vec_t<10, wp::float32> var_m,
    wp::vec_t<10, wp::float32> & adj_m,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/odometry/voxel_map_search.py:123
static CUDA_CALLABLE void adj_covariance_of_1(
    wp::vec_t<10, wp::float32> var_m,
    wp::vec_t<3, wp::float64> var_mean,
    wp::vec_t<10, wp::float32> & adj_m,
    wp::vec_t<3, wp::float64> & adj_mean,
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


// <pointloom.kernels.algebra.eigen.eigenvalues_in_plane>:1
static CUDA_CALLABLE void adj_eigenvalues_in_plane_0(
    wp::mat_t<3, 3, wp::float64> var_a,
    wp::vec_t<3, wp::float64> var_w,
    wp::mat_t<3, 3, wp::float64> & adj_a,
    wp::vec_t<3, wp::float64> & adj_w,
    wp::vec_t<2, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/algebra/eigen.py:142
static CUDA_CALLABLE void adj_sorted_diagonal_0(
    wp::mat_t<3, 3, wp::float64> var_a,
    wp::mat_t<3, 3, wp::float64> & adj_a,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.algebra.eigen.eigenvalues>:1
static CUDA_CALLABLE void adj_eigenvalues_0(
    wp::mat_t<3, 3, wp::float64> var_covariance,
    wp::mat_t<3, 3, wp::float64> & adj_covariance,
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


// /work/main/src/pointloom/kernels/odometry/map_icp.py:32
static CUDA_CALLABLE void adj_plane_of_1(
    wp::vec_t<10, wp::float32> var_m,
    wp::vec_t<10, wp::float32> & adj_m,
    wp::vec_t<5, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.odometry.map_icp.plane_around>:1
static CUDA_CALLABLE void adj_plane_around_0(
    wp::vec_t<3, wp::float64> var_center,
    wp::float32 var_radius,
    wp::float64 var_voxel_map__voxel_size,
    wp::int32 var_voxel_map__room,
    wp::array_t<wp::int64> var_voxel_map__table__keys,
    wp::array_t<wp::int32> var_voxel_map__table__positions,
    wp::int64 var_voxel_map__table__mask,
    wp::array_t<wp::int32> var_voxel_map__counts,
    wp::array_t<wp::vec_t<3, wp::float32>> var_voxel_map__offsets,
    wp::vec_t<3, wp::float64> & adj_center,
    wp::float32 & adj_radius,
    wp::float64 & adj_voxel_map__voxel_size,
    wp::int32 & adj_voxel_map__room,
    wp::array_t<wp::int64> & adj_voxel_map__table__keys,
    wp::array_t<wp::int32> & adj_voxel_map__table__positions,
    wp::int64 & adj_voxel_map__table__mask,
    wp::array_t<wp::int32> & adj_voxel_map__counts,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_voxel_map__offsets,
    wp::vec_t<5, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.algebra.matrices.multiply33>:1
static CUDA_CALLABLE void adj_multiply33_0(
    wp::mat_t<3, 3, wp::float64> var_a,
    wp::mat_t<3, 3, wp::float64> var_b,
    wp::mat_t<3, 3, wp::float64> & adj_a,
    wp::mat_t<3, 3, wp::float64> & adj_b,
    wp::mat_t<3, 3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.odometry.map_icp.add_pair>:1
static CUDA_CALLABLE void adj_add_pair_0(
    wp::vec_t<31, wp::float64> var_total,
    wp::vec_t<3, wp::float64> var_y,
    wp::vec_t<3, wp::float64> var_r,
    wp::vec_t<5, wp::float32> var_at,
    wp::float64 var_kernel_scale,
    wp::vec_t<31, wp::float64> & adj_total,
    wp::vec_t<3, wp::float64> & adj_y,
    wp::vec_t<3, wp::float64> & adj_r,
    wp::vec_t<5, wp::float32> & adj_at,
    wp::float64 & adj_kernel_scale,
    wp::vec_t<31, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void load_scan_kernel_13a88351_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_few,
    wp::array_t<wp::vec_t<3, wp::float32>> var_course__points,
    wp::array_t<wp::int32> var_course__known)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::shape_t* var_1;
        const wp::int32 var_2 = 0;
        wp::int32 var_3;
        wp::shape_t var_4;
        bool var_5;
        wp::vec_t<3, wp::float32>* var_6;
        wp::vec_t<3, wp::float32> var_7;
        wp::vec_t<3, wp::float32> var_8;
        wp::int32 var_9;
        wp::vec_t<3, wp::float32>* var_10;
        wp::vec_t<3, wp::float32> var_11;
        wp::vec_t<3, wp::float32> var_12;
        const wp::int32 var_13 = -1;
        //---------
        // forward
        // def load_scan_kernel(points, few, course__points, course__known):                      <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // count = points.shape[0]                                                                <L 4>
        var_1 = &(var_points.shape);
        var_4 = wp::load(var_1);
        var_3 = wp::extract(var_4, var_2);
        // if i < count:                                                                          <L 5>
        var_5 = (var_0 < var_3);
        if (var_5) {
            // course__points[i] = points[i]                                                      <L 6>
            var_6 = wp::address(var_points, var_0);
            var_8 = wp::load(var_6);
            var_7 = wp::copy(var_8);
            wp::array_store(var_course__points, var_0, var_7);
        }
        if (!var_5) {
            // course__points[i] = few[i - count]                                                 <L 8>
            var_9 = wp::sub(var_0, var_3);
            var_10 = wp::address(var_few, var_9);
            var_12 = wp::load(var_10);
            var_11 = wp::copy(var_12);
            wp::array_store(var_course__points, var_0, var_11);
        }
        // course__known[i] = -1                                                                  <L 9>
        wp::array_store(var_course__known, var_0, var_13);
}



extern "C" __global__ void fold_rows_kernel_477d8b2f_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::int32 var_run,
    wp::array_t<wp::float64> var_course__orders,
    wp::array_t<wp::int32> var_course__states,
    wp::array_t<wp::float64> var_rows,
    wp::array_t<wp::float64> var_folded)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        const wp::int32 var_1 = 31;
        wp::int32 var_2;
        wp::int32 var_3;
        const wp::int32 var_4 = 0;
        wp::int32* var_5;
        const wp::int32 var_6 = 23;
        wp::int32 var_7;
        wp::int32 var_8;
        wp::int32 var_9;
        const wp::int32 var_10 = 1;
        wp::int32 var_11;
        wp::int32 var_12;
        wp::float64 var_13;
        const wp::int32 var_14 = 64;
        wp::int32 var_15;
        wp::int32 var_16;
        wp::int32 var_17;
        wp::int32 var_18;
        wp::int32 var_19;
        wp::int32 var_20;
        wp::range_t var_21;
        wp::int32 var_22;
        wp::float64* var_23;
        wp::float64 var_24;
        wp::float64 var_25;
        //---------
        // forward
        // def fold_rows_kernel(run, course__orders, course__states, rows, folded):               <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // block = i // SUMS                                                                      <L 3>
        var_2 = wp::floordiv(var_0, var_1);
        // column = i % SUMS                                                                      <L 4>
        var_3 = wp::mod(var_0, var_1);
        // count = (leg_number(course__states[0], COUNT, course__orders) + run - 1) // run        <L 5>
        var_5 = wp::address(var_course__states, var_4);
        var_8 = wp::load(var_5);
        var_7 = leg_number_0(var_8, var_6, var_course__orders);
        var_9 = wp::add(var_7, var_run);
        var_11 = wp::sub(var_9, var_10);
        var_12 = wp::floordiv(var_11, var_run);
        // total = float64(0.0)                                                                   <L 6>
        var_13 = 0.0;
        // for j in range(block * FOLD, block * FOLD + min(FOLD, count - block * FOLD)):          <L 7>
        var_15 = wp::mul(var_2, var_14);
        var_16 = wp::mul(var_2, var_14);
        var_17 = wp::mul(var_2, var_14);
        var_18 = wp::sub(var_12, var_17);
        var_19 = wp::min(var_14, var_18);
        var_20 = wp::add(var_16, var_19);
        var_21 = wp::range(var_15, var_20);
        start_for_0:;
            if (iter_cmp(var_21) == 0) goto end_for_0;
            var_22 = wp::iter_next(var_21);
            // total += rows[j, column]                                                           <L 8>
            var_23 = wp::address(var_rows, var_22, var_3);
            var_25 = wp::load(var_23);
            var_24 = wp::add(var_13, var_25);
            wp::assign(var_13, var_24);
            goto start_for_0;
        end_for_0:;
        // folded[block, column] = total                                                          <L 9>
        wp::array_store(var_folded, var_2, var_3, var_13);
}



extern "C" __global__ void step_pose_kernel_5082fbc5_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::int32 var_per_row,
    wp::array_t<wp::float64> var_course__orders,
    wp::array_t<wp::float64> var_course__results,
    wp::array_t<wp::int32> var_course__states,
    wp::array_t<wp::int32> var_course__running,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_course__poses,
    wp::array_t<wp::float64> var_rows)
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
        wp::int32 var_4;
        wp::float64 var_5;
        wp::vec_t<31, wp::float64> var_6;
        const wp::int32 var_7 = 23;
        wp::int32 var_8;
        wp::int32 var_9;
        const wp::int32 var_10 = 1;
        wp::int32 var_11;
        wp::int32 var_12;
        wp::range_t var_13;
        wp::int32 var_14;
        wp::int32 var_15;
        wp::int32 var_16;
        wp::float64 var_17;
        wp::float64* var_18;
        wp::float64 var_19;
        wp::float64 var_20;
        const wp::int32 var_21 = 1;
        wp::int32* var_22;
        const wp::int32 var_23 = 1;
        wp::int32 var_24;
        wp::int32 var_25;
        const wp::int32 var_26 = 1;
        const wp::int32 var_27 = 0;
        wp::int32 var_28;
        const wp::int32 var_29 = 28;
        wp::float64 var_30;
        const wp::int32 var_31 = 19;
        wp::float64* var_32;
        bool var_33;
        wp::float64 var_34;
        const wp::int32 var_35 = 3;
        wp::int32 var_36;
        wp::float64 var_37;
        wp::vec_t<21, wp::float64> var_38;
        const wp::int32 var_39 = 3;
        const wp::int32 var_40 = 3;
        wp::int32 var_41;
        wp::float64 var_42;
        const wp::int32 var_43 = 4;
        const wp::int32 var_44 = 4;
        wp::int32 var_45;
        wp::float64 var_46;
        wp::float64 var_47;
        const wp::int32 var_48 = 5;
        const wp::int32 var_49 = 5;
        wp::int32 var_50;
        wp::float64 var_51;
        wp::float64 var_52;
        wp::int32 var_53;
        wp::int32 var_54;
        wp::float64 var_55;
        const wp::int32 var_56 = 24;
        wp::float64* var_57;
        wp::float64 var_58;
        bool var_59;
        wp::float64 var_60;
        wp::float64 var_61;
        const wp::int32 var_62 = 64;
        wp::float64* var_63;
        wp::float64 var_64;
        wp::float64 var_65;
        wp::float64 var_66;
        wp::float64 var_67;
        wp::vec_t<6, wp::float64> var_68;
        const wp::int32 var_69 = 0;
        const wp::int32 var_70 = 21;
        wp::int32 var_71;
        wp::float64 var_72;
        const wp::int32 var_73 = 1;
        wp::int32 var_74;
        wp::float64 var_75;
        const wp::int32 var_76 = 2;
        wp::int32 var_77;
        wp::float64 var_78;
        const wp::int32 var_79 = 3;
        wp::int32 var_80;
        wp::float64 var_81;
        const wp::int32 var_82 = 4;
        wp::int32 var_83;
        wp::float64 var_84;
        const wp::int32 var_85 = 5;
        wp::int32 var_86;
        wp::float64 var_87;
        wp::vec_t<6, wp::float64> var_88;
        wp::float64 var_89;
        const wp::int32 var_90 = 0;
        wp::float64 var_91;
        wp::float64 var_92;
        wp::float64 var_93;
        wp::float64 var_94;
        const wp::int32 var_95 = 1;
        wp::float64 var_96;
        wp::float64 var_97;
        wp::float64 var_98;
        wp::float64 var_99;
        const wp::int32 var_100 = 2;
        wp::float64 var_101;
        wp::float64 var_102;
        wp::float64 var_103;
        wp::float64 var_104;
        const wp::int32 var_105 = 3;
        wp::float64 var_106;
        wp::float64 var_107;
        wp::float64 var_108;
        wp::float64 var_109;
        const wp::int32 var_110 = 4;
        wp::float64 var_111;
        wp::float64 var_112;
        wp::float64 var_113;
        wp::float64 var_114;
        const wp::int32 var_115 = 5;
        wp::float64 var_116;
        wp::float64 var_117;
        wp::float64 var_118;
        wp::float64 var_119;
        wp::float64 var_120;
        wp::float64 var_121;
        bool var_122;
        wp::mat_t<4, 4, wp::float64>* var_123;
        wp::mat_t<4, 4, wp::float64> var_124;
        wp::mat_t<4, 4, wp::float64> var_125;
        wp::float64 var_126;
        const wp::int32 var_127 = 18;
        wp::float64* var_128;
        bool var_129;
        wp::float64 var_130;
        const wp::int32 var_131 = 1;
        wp::int32 var_132;
        const wp::int32 var_133 = 20;
        wp::int32 var_134;
        bool var_135;
        const wp::int32 var_136 = 2;
        wp::int32 var_137;
        wp::int32 var_138;
        wp::int32 var_139;
        const wp::int32 var_140 = 3;
        wp::int32 var_141;
        wp::int32 var_142;
        wp::int32 var_143;
        wp::int32 var_144;
        bool var_145;
        //---------
        // forward
        // def step_pose_kernel(per_row, course__orders, course__results, course__states, course__running, course__poses, rows):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // leg = course__states[0]                                                                <L 4>
        var_2 = wp::address(var_course__states, var_1);
        var_4 = wp::load(var_2);
        var_3 = wp::copy(var_4);
        // total = sums(float64(0.0))                                                             <L 5>
        var_5 = 0.0;
        var_6 = wp::vec_t<31, wp::float64>(var_5);
        // for j in range((leg_number(leg, COUNT, course__orders) + per_row - 1) // per_row):       <L 6>
        var_8 = leg_number_0(var_3, var_7, var_course__orders);
        var_9 = wp::add(var_8, var_per_row);
        var_11 = wp::sub(var_9, var_10);
        var_12 = wp::floordiv(var_11, var_per_row);
        var_13 = wp::range(var_12);
        start_for_0:;
            if (iter_cmp(var_13) == 0) goto end_for_0;
            var_14 = wp::iter_next(var_13);
            // for column in range(SUMS):                                                         <L 7>
            var_15 = 0;
            start_for_2:;
                if (var_15 >= 31) goto end_for_2;
                var_16 = var_15;
                var_15 += 1;
                // total[column] = total[column] + rows[j, column]                                <L 8>
                var_17 = wp::extract(var_6, var_16);
                var_18 = wp::address(var_rows, var_14, var_16);
                var_20 = wp::load(var_18);
                var_19 = wp::add(var_17, var_20);
                wp::assign_inplace(var_6, var_16, var_19);
                goto start_for_2;
            end_for_2:;
            goto start_for_0;
        end_for_0:;
        // iterations = course__states[1] + 1                                                     <L 9>
        var_22 = wp::address(var_course__states, var_21);
        var_25 = wp::load(var_22);
        var_24 = wp::add(var_25, var_23);
        // course__states[1] = iterations                                                         <L 10>
        wp::array_store(var_course__states, var_26, var_24);
        // state = int(RUNNING)                                                                   <L 11>
        var_28 = wp::int(var_27);
        // if total[PAIRS] < course__orders[leg, REQUIRED_PAIRS]:                                 <L 12>
        var_30 = wp::extract(var_6, var_29);
        var_32 = wp::address(var_course__orders, var_3, var_31);
        var_34 = wp::load(var_32);
        var_33 = (var_30 < var_34);
        if (var_33) {
            // state = int(LOST)                                                                  <L 13>
            var_36 = wp::int(var_35);
        }
        if (!var_33) {
            // h = triangle(float64(0.0))                                                         <L 15>
            var_37 = 0.0;
            var_38 = wp::vec_t<21, wp::float64>(var_37);
            // trace = total[triangle_index(3, 3)] + total[triangle_index(4, 4)] + total[triangle_index(5, 5)]       <L 16>
            var_41 = triangle_index_0(var_39, var_40);
            var_42 = wp::extract(var_6, var_41);
            var_45 = triangle_index_0(var_43, var_44);
            var_46 = wp::extract(var_6, var_45);
            var_47 = wp::add(var_42, var_46);
            var_50 = triangle_index_0(var_48, var_49);
            var_51 = wp::extract(var_6, var_50);
            var_52 = wp::add(var_47, var_51);
            // for k in range(TRIANGLE):                                                          <L 17>
            var_53 = 0;
            start_for_4:;
                if (var_53 >= 21) goto end_for_4;
                var_54 = var_53;
                var_53 += 1;
                // h[k] = total[k]                                                                <L 18>
                var_55 = wp::extract(var_6, var_54);
                wp::assign_inplace(var_38, var_54, var_55);
                // if course__orders[leg, REGULARIZED] == float64(1.0):                           <L 19>
                var_57 = wp::address(var_course__orders, var_3, var_56);
                var_58 = 1.0;
                var_60 = wp::load(var_57);
                var_59 = (var_60 == var_58);
                if (var_59) {
                    // h[k] = h[k] + course__orders[MAX_LEGS, k] * trace                          <L 20>
                    var_61 = wp::extract(var_38, var_54);
                    var_63 = wp::address(var_course__orders, var_62, var_54);
                    var_65 = wp::load(var_63);
                    var_64 = wp::mul(var_65, var_52);
                    var_66 = wp::add(var_61, var_64);
                    wp::assign_inplace(var_38, var_54, var_66);
                }
                goto start_for_4;
            end_for_4:;
            // b = vec6d(float64(0.0))                                                            <L 21>
            var_67 = 0.0;
            var_68 = wp::vec_t<6, wp::float64>(var_67);
            // for k in range(UNKNOWNS):                                                          <L 22>
            // b[k] = total[TRIANGLE + k]                                                         <L 23>
            var_71 = wp::add(var_70, var_69);
            var_72 = wp::extract(var_6, var_71);
            wp::assign_inplace(var_68, var_69, var_72);
            var_74 = wp::add(var_70, var_73);
            var_75 = wp::extract(var_6, var_74);
            wp::assign_inplace(var_68, var_73, var_75);
            var_77 = wp::add(var_70, var_76);
            var_78 = wp::extract(var_6, var_77);
            wp::assign_inplace(var_68, var_76, var_78);
            var_80 = wp::add(var_70, var_79);
            var_81 = wp::extract(var_6, var_80);
            wp::assign_inplace(var_68, var_79, var_81);
            var_83 = wp::add(var_70, var_82);
            var_84 = wp::extract(var_6, var_83);
            wp::assign_inplace(var_68, var_82, var_84);
            var_86 = wp::add(var_70, var_85);
            var_87 = wp::extract(var_6, var_86);
            wp::assign_inplace(var_68, var_85, var_87);
            // x = solve_system(h, b)                                                             <L 24>
            var_88 = solve_system_0(var_38, var_68);
            // size = float64(0.0)                                                                <L 25>
            var_89 = 0.0;
            // for k in range(UNKNOWNS):                                                          <L 26>
            // size += x[k] * x[k]                                                                <L 27>
            var_91 = wp::extract(var_88, var_90);
            var_92 = wp::extract(var_88, var_90);
            var_93 = wp::mul(var_91, var_92);
            var_94 = wp::add(var_89, var_93);
            var_96 = wp::extract(var_88, var_95);
            var_97 = wp::extract(var_88, var_95);
            var_98 = wp::mul(var_96, var_97);
            var_99 = wp::add(var_94, var_98);
            var_101 = wp::extract(var_88, var_100);
            var_102 = wp::extract(var_88, var_100);
            var_103 = wp::mul(var_101, var_102);
            var_104 = wp::add(var_99, var_103);
            var_106 = wp::extract(var_88, var_105);
            var_107 = wp::extract(var_88, var_105);
            var_108 = wp::mul(var_106, var_107);
            var_109 = wp::add(var_104, var_108);
            var_111 = wp::extract(var_88, var_110);
            var_112 = wp::extract(var_88, var_110);
            var_113 = wp::mul(var_111, var_112);
            var_114 = wp::add(var_109, var_113);
            var_116 = wp::extract(var_88, var_115);
            var_117 = wp::extract(var_88, var_115);
            var_118 = wp::mul(var_116, var_117);
            var_119 = wp::add(var_114, var_118);
            // if size - size == float64(0.0):                                                    <L 28>
            var_120 = wp::sub(var_119, var_119);
            var_121 = 0.0;
            var_122 = (var_120 == var_121);
            if (var_122) {
                // course__poses[i] = moved_by(x, course__poses[i])                               <L 29>
                var_123 = wp::address(var_course__poses, var_0);
                var_125 = wp::load(var_123);
                var_124 = moved_by_0(var_88, var_125);
                wp::array_store(var_course__poses, var_0, var_124);
                // if sqrt(size) < course__orders[leg, TOLERANCE]:                                <L 30>
                var_126 = wp::sqrt(var_119);
                var_128 = wp::address(var_course__orders, var_3, var_127);
                var_130 = wp::load(var_128);
                var_129 = (var_126 < var_130);
                if (var_129) {
                    // state = int(CONVERGED)                                                     <L 31>
                    var_132 = wp::int(var_131);
                }
                if (!var_129) {
                    // elif iterations >= leg_number(leg, MAX_ITERATIONS, course__orders):        <L 32>
                    var_134 = leg_number_0(var_3, var_133, var_course__orders);
                    var_135 = (var_24 >= var_134);
                    if (var_135) {
                        // state = int(EXHAUSTED)                                                 <L 33>
                        var_137 = wp::int(var_136);
                    }
                    var_138 = wp::where(var_135, var_137, var_28);
                }
                var_139 = wp::where(var_129, var_132, var_138);
            }
            if (!var_122) {
                // state = int(LOST)                                                              <L 35>
                var_141 = wp::int(var_140);
            }
            var_142 = wp::where(var_122, var_139, var_141);
        }
        var_143 = wp::where(var_33, var_36, var_142);
        var_144 = wp::where(var_33, var_35, var_140);
        // if state != RUNNING:                                                                   <L 36>
        var_145 = (var_143 != var_27);
        if (var_145) {
            // end_leg(leg, state, total, course__orders, course__results, course__states, course__running, course__poses)       <L 37>
            end_leg_0(var_3, var_143, var_6, var_course__orders, var_course__results, var_course__states, var_course__running, var_course__poses);
        }
}



extern "C" __global__ void add_planes_kernel_8d86fca0_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float64> var_rows,
    wp::array_t<wp::float64> var_course__results)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::float64 var_1;
        wp::shape_t* var_2;
        const wp::int32 var_3 = 0;
        wp::int32 var_4;
        wp::shape_t var_5;
        wp::range_t var_6;
        wp::int32 var_7;
        wp::float64* var_8;
        wp::float64 var_9;
        wp::float64 var_10;
        const wp::int32 var_11 = 64;
        //---------
        // forward
        // def add_planes_kernel(rows, course__results):                                          <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // total = float64(0.0)                                                                   <L 3>
        var_1 = 0.0;
        // for j in range(rows.shape[0]):                                                         <L 4>
        var_2 = &(var_rows.shape);
        var_5 = wp::load(var_2);
        var_4 = wp::extract(var_5, var_3);
        var_6 = wp::range(var_4);
        start_for_0:;
            if (iter_cmp(var_6) == 0) goto end_for_0;
            var_7 = wp::iter_next(var_6);
            // total += rows[j, i]                                                                <L 5>
            var_8 = wp::address(var_rows, var_7, var_0);
            var_10 = wp::load(var_8);
            var_9 = wp::add(var_1, var_10);
            wp::assign(var_1, var_9);
            goto start_for_0;
        end_for_0:;
        // course__results[MAX_LEGS, i] = total                                                   <L 6>
        wp::array_store(var_course__results, var_11, var_0, var_1);
}



extern "C" __global__ void sum_planes_kernel_b36dbe82_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_course__points,
    wp::array_t<wp::vec_t<5, wp::float32>> var_course__planes,
    wp::array_t<wp::int32> var_course__known,
    wp::array_t<wp::float64> var_course__orders,
    wp::array_t<wp::int32> var_course__states,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_course__poses,
    wp::array_t<wp::float64> var_rows)
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
        wp::int32 var_4;
        const wp::int32 var_5 = 22;
        wp::int32 var_6;
        const wp::int32 var_7 = 23;
        wp::int32 var_8;
        const wp::int32 var_9 = 0;
        wp::mat_t<4, 4, wp::float64>* var_10;
        wp::mat_t<4, 4, wp::float64> var_11;
        wp::mat_t<4, 4, wp::float64> var_12;
        wp::float64 var_13;
        wp::vec_t<21, wp::float64> var_14;
        const wp::int32 var_15 = 32;
        wp::int32 var_16;
        wp::int32 var_17;
        wp::int32 var_18;
        wp::int32 var_19;
        wp::int32 var_20;
        wp::int32 var_21;
        wp::range_t var_22;
        wp::int32 var_23;
        wp::int32 var_24;
        wp::int32* var_25;
        const wp::int32 var_26 = 0;
        bool var_27;
        wp::int32 var_28;
        wp::vec_t<5, wp::float32>* var_29;
        wp::vec_t<5, wp::float32> var_30;
        wp::vec_t<5, wp::float32> var_31;
        const wp::int32 var_32 = 3;
        wp::float32 var_33;
        const wp::float32 var_34 = 0.0;
        bool var_35;
        const wp::int32 var_36 = 0;
        wp::float32 var_37;
        wp::float64 var_38;
        const wp::int32 var_39 = 1;
        wp::float32 var_40;
        wp::float64 var_41;
        const wp::int32 var_42 = 2;
        wp::float32 var_43;
        wp::float64 var_44;
        wp::vec_t<3, wp::float64> var_45;
        wp::vec_t<3, wp::float32>* var_46;
        wp::vec_t<3, wp::float64> var_47;
        wp::vec_t<3, wp::float32> var_48;
        wp::vec_t<3, wp::float64> var_49;
        wp::vec_t<3, wp::float64> var_50;
        const wp::int32 var_51 = 0;
        wp::float64 var_52;
        const wp::int32 var_53 = 1;
        wp::float64 var_54;
        const wp::int32 var_55 = 2;
        wp::float64 var_56;
        const wp::int32 var_57 = 0;
        wp::float64 var_58;
        const wp::int32 var_59 = 1;
        wp::float64 var_60;
        const wp::int32 var_61 = 2;
        wp::float64 var_62;
        wp::vec_t<6, wp::float64> var_63;
        const wp::int32 var_64 = 0;
        const wp::int32 var_65 = 0;
        wp::int32 var_66;
        wp::float64 var_67;
        wp::float64 var_68;
        wp::float64 var_69;
        wp::float64 var_70;
        wp::float64 var_71;
        wp::int32 var_72;
        const wp::int32 var_73 = 1;
        wp::int32 var_74;
        wp::float64 var_75;
        wp::float64 var_76;
        wp::float64 var_77;
        wp::float64 var_78;
        wp::float64 var_79;
        wp::int32 var_80;
        const wp::int32 var_81 = 2;
        wp::int32 var_82;
        wp::float64 var_83;
        wp::float64 var_84;
        wp::float64 var_85;
        wp::float64 var_86;
        wp::float64 var_87;
        wp::int32 var_88;
        const wp::int32 var_89 = 3;
        wp::int32 var_90;
        wp::float64 var_91;
        wp::float64 var_92;
        wp::float64 var_93;
        wp::float64 var_94;
        wp::float64 var_95;
        wp::int32 var_96;
        const wp::int32 var_97 = 4;
        wp::int32 var_98;
        wp::float64 var_99;
        wp::float64 var_100;
        wp::float64 var_101;
        wp::float64 var_102;
        wp::float64 var_103;
        wp::int32 var_104;
        const wp::int32 var_105 = 5;
        wp::int32 var_106;
        wp::float64 var_107;
        wp::float64 var_108;
        wp::float64 var_109;
        wp::float64 var_110;
        wp::float64 var_111;
        wp::int32 var_112;
        const wp::int32 var_113 = 1;
        const wp::int32 var_114 = 1;
        wp::int32 var_115;
        wp::float64 var_116;
        wp::float64 var_117;
        wp::float64 var_118;
        wp::float64 var_119;
        wp::float64 var_120;
        wp::int32 var_121;
        const wp::int32 var_122 = 2;
        wp::int32 var_123;
        wp::float64 var_124;
        wp::float64 var_125;
        wp::float64 var_126;
        wp::float64 var_127;
        wp::float64 var_128;
        wp::int32 var_129;
        const wp::int32 var_130 = 3;
        wp::int32 var_131;
        wp::float64 var_132;
        wp::float64 var_133;
        wp::float64 var_134;
        wp::float64 var_135;
        wp::float64 var_136;
        wp::int32 var_137;
        const wp::int32 var_138 = 4;
        wp::int32 var_139;
        wp::float64 var_140;
        wp::float64 var_141;
        wp::float64 var_142;
        wp::float64 var_143;
        wp::float64 var_144;
        wp::int32 var_145;
        const wp::int32 var_146 = 5;
        wp::int32 var_147;
        wp::float64 var_148;
        wp::float64 var_149;
        wp::float64 var_150;
        wp::float64 var_151;
        wp::float64 var_152;
        wp::int32 var_153;
        const wp::int32 var_154 = 2;
        const wp::int32 var_155 = 2;
        wp::int32 var_156;
        wp::float64 var_157;
        wp::float64 var_158;
        wp::float64 var_159;
        wp::float64 var_160;
        wp::float64 var_161;
        wp::int32 var_162;
        const wp::int32 var_163 = 3;
        wp::int32 var_164;
        wp::float64 var_165;
        wp::float64 var_166;
        wp::float64 var_167;
        wp::float64 var_168;
        wp::float64 var_169;
        wp::int32 var_170;
        const wp::int32 var_171 = 4;
        wp::int32 var_172;
        wp::float64 var_173;
        wp::float64 var_174;
        wp::float64 var_175;
        wp::float64 var_176;
        wp::float64 var_177;
        wp::int32 var_178;
        const wp::int32 var_179 = 5;
        wp::int32 var_180;
        wp::float64 var_181;
        wp::float64 var_182;
        wp::float64 var_183;
        wp::float64 var_184;
        wp::float64 var_185;
        wp::int32 var_186;
        const wp::int32 var_187 = 3;
        const wp::int32 var_188 = 3;
        wp::int32 var_189;
        wp::float64 var_190;
        wp::float64 var_191;
        wp::float64 var_192;
        wp::float64 var_193;
        wp::float64 var_194;
        wp::int32 var_195;
        const wp::int32 var_196 = 4;
        wp::int32 var_197;
        wp::float64 var_198;
        wp::float64 var_199;
        wp::float64 var_200;
        wp::float64 var_201;
        wp::float64 var_202;
        wp::int32 var_203;
        const wp::int32 var_204 = 5;
        wp::int32 var_205;
        wp::float64 var_206;
        wp::float64 var_207;
        wp::float64 var_208;
        wp::float64 var_209;
        wp::float64 var_210;
        wp::int32 var_211;
        const wp::int32 var_212 = 4;
        const wp::int32 var_213 = 4;
        wp::int32 var_214;
        wp::float64 var_215;
        wp::float64 var_216;
        wp::float64 var_217;
        wp::float64 var_218;
        wp::float64 var_219;
        wp::int32 var_220;
        const wp::int32 var_221 = 5;
        wp::int32 var_222;
        wp::float64 var_223;
        wp::float64 var_224;
        wp::float64 var_225;
        wp::float64 var_226;
        wp::float64 var_227;
        wp::int32 var_228;
        const wp::int32 var_229 = 5;
        const wp::int32 var_230 = 5;
        wp::int32 var_231;
        wp::float64 var_232;
        wp::float64 var_233;
        wp::float64 var_234;
        wp::float64 var_235;
        wp::float64 var_236;
        wp::int32 var_237;
        wp::int32 var_238;
        wp::int32 var_239;
        wp::float64 var_240;
        //---------
        // forward
        // def sum_planes_kernel(course__points, course__planes, course__known, course__orders, course__states, course__poses, rows):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // leg = course__states[0]                                                                <L 4>
        var_2 = wp::address(var_course__states, var_1);
        var_4 = wp::load(var_2);
        var_3 = wp::copy(var_4);
        // begin = leg_number(leg, FIRST, course__orders)                                         <L 5>
        var_6 = leg_number_0(var_3, var_5, var_course__orders);
        // count = leg_number(leg, COUNT, course__orders)                                         <L 6>
        var_8 = leg_number_0(var_3, var_7, var_course__orders);
        // pose = course__poses[0]                                                                <L 7>
        var_10 = wp::address(var_course__poses, var_9);
        var_12 = wp::load(var_10);
        var_11 = wp::copy(var_12);
        // total = triangle(float64(0.0))                                                         <L 8>
        var_13 = 0.0;
        var_14 = wp::vec_t<21, wp::float64>(var_13);
        // for k in range(i * PLANE_RUN, i * PLANE_RUN + min(PLANE_RUN, count - i * PLANE_RUN)):       <L 9>
        var_16 = wp::mul(var_0, var_15);
        var_17 = wp::mul(var_0, var_15);
        var_18 = wp::mul(var_0, var_15);
        var_19 = wp::sub(var_8, var_18);
        var_20 = wp::min(var_15, var_19);
        var_21 = wp::add(var_17, var_20);
        var_22 = wp::range(var_16, var_21);
        start_for_0:;
            if (iter_cmp(var_22) == 0) goto end_for_0;
            var_23 = wp::iter_next(var_22);
            // j = begin + k                                                                      <L 10>
            var_24 = wp::add(var_6, var_23);
            // if course__known[j] >= 0:                                                          <L 11>
            var_25 = wp::address(var_course__known, var_24);
            var_28 = wp::load(var_25);
            var_27 = (var_28 >= var_26);
            if (var_27) {
                // at = course__planes[j]                                                         <L 12>
                var_29 = wp::address(var_course__planes, var_24);
                var_31 = wp::load(var_29);
                var_30 = wp::copy(var_31);
                // if at[3] > 0.0:                                                                <L 13>
                var_33 = wp::extract(var_30, var_32);
                var_35 = (var_33 > var_34);
                if (var_35) {
                    // n = vec3d(float64(at[0]), float64(at[1]), float64(at[2]))                  <L 14>
                    var_37 = wp::extract(var_30, var_36);
                    var_38 = wp::float64(var_37);
                    var_40 = wp::extract(var_30, var_39);
                    var_41 = wp::float64(var_40);
                    var_43 = wp::extract(var_30, var_42);
                    var_44 = wp::float64(var_43);
                    var_45 = wp::vec_t<3, wp::float64>(var_38, var_41, var_44);
                    // m = cross(rotate(pose, widen(course__points[j])), n)                       <L 15>
                    var_46 = wp::address(var_course__points, var_24);
                    var_48 = wp::load(var_46);
                    var_47 = widen_0(var_48);
                    var_49 = rotate_1(var_11, var_47);
                    var_50 = wp::cross(var_49, var_45);
                    // row = vec6d(m[0], m[1], m[2], n[0], n[1], n[2])                            <L 16>
                    var_52 = wp::extract(var_50, var_51);
                    var_54 = wp::extract(var_50, var_53);
                    var_56 = wp::extract(var_50, var_55);
                    var_58 = wp::extract(var_45, var_57);
                    var_60 = wp::extract(var_45, var_59);
                    var_62 = wp::extract(var_45, var_61);
                    var_63 = wp::vec_t<6, wp::float64>({var_52, var_54, var_56, var_58, var_60, var_62});
                    // for a in range(UNKNOWNS):                                                  <L 17>
                    // for b in range(a, UNKNOWNS):                                               <L 18>
                    // total[triangle_index(a, b)] = total[triangle_index(a, b)] + row[a] * row[b]       <L 19>
                    var_66 = triangle_index_0(var_64, var_65);
                    var_67 = wp::extract(var_14, var_66);
                    var_68 = wp::extract(var_63, var_64);
                    var_69 = wp::extract(var_63, var_65);
                    var_70 = wp::mul(var_68, var_69);
                    var_71 = wp::add(var_67, var_70);
                    var_72 = triangle_index_0(var_64, var_65);
                    wp::assign_inplace(var_14, var_72, var_71);
                    var_74 = triangle_index_0(var_64, var_73);
                    var_75 = wp::extract(var_14, var_74);
                    var_76 = wp::extract(var_63, var_64);
                    var_77 = wp::extract(var_63, var_73);
                    var_78 = wp::mul(var_76, var_77);
                    var_79 = wp::add(var_75, var_78);
                    var_80 = triangle_index_0(var_64, var_73);
                    wp::assign_inplace(var_14, var_80, var_79);
                    var_82 = triangle_index_0(var_64, var_81);
                    var_83 = wp::extract(var_14, var_82);
                    var_84 = wp::extract(var_63, var_64);
                    var_85 = wp::extract(var_63, var_81);
                    var_86 = wp::mul(var_84, var_85);
                    var_87 = wp::add(var_83, var_86);
                    var_88 = triangle_index_0(var_64, var_81);
                    wp::assign_inplace(var_14, var_88, var_87);
                    var_90 = triangle_index_0(var_64, var_89);
                    var_91 = wp::extract(var_14, var_90);
                    var_92 = wp::extract(var_63, var_64);
                    var_93 = wp::extract(var_63, var_89);
                    var_94 = wp::mul(var_92, var_93);
                    var_95 = wp::add(var_91, var_94);
                    var_96 = triangle_index_0(var_64, var_89);
                    wp::assign_inplace(var_14, var_96, var_95);
                    var_98 = triangle_index_0(var_64, var_97);
                    var_99 = wp::extract(var_14, var_98);
                    var_100 = wp::extract(var_63, var_64);
                    var_101 = wp::extract(var_63, var_97);
                    var_102 = wp::mul(var_100, var_101);
                    var_103 = wp::add(var_99, var_102);
                    var_104 = triangle_index_0(var_64, var_97);
                    wp::assign_inplace(var_14, var_104, var_103);
                    var_106 = triangle_index_0(var_64, var_105);
                    var_107 = wp::extract(var_14, var_106);
                    var_108 = wp::extract(var_63, var_64);
                    var_109 = wp::extract(var_63, var_105);
                    var_110 = wp::mul(var_108, var_109);
                    var_111 = wp::add(var_107, var_110);
                    var_112 = triangle_index_0(var_64, var_105);
                    wp::assign_inplace(var_14, var_112, var_111);
                    // for b in range(a, UNKNOWNS):                                               <L 18>
                    // total[triangle_index(a, b)] = total[triangle_index(a, b)] + row[a] * row[b]       <L 19>
                    var_115 = triangle_index_0(var_113, var_114);
                    var_116 = wp::extract(var_14, var_115);
                    var_117 = wp::extract(var_63, var_113);
                    var_118 = wp::extract(var_63, var_114);
                    var_119 = wp::mul(var_117, var_118);
                    var_120 = wp::add(var_116, var_119);
                    var_121 = triangle_index_0(var_113, var_114);
                    wp::assign_inplace(var_14, var_121, var_120);
                    var_123 = triangle_index_0(var_113, var_122);
                    var_124 = wp::extract(var_14, var_123);
                    var_125 = wp::extract(var_63, var_113);
                    var_126 = wp::extract(var_63, var_122);
                    var_127 = wp::mul(var_125, var_126);
                    var_128 = wp::add(var_124, var_127);
                    var_129 = triangle_index_0(var_113, var_122);
                    wp::assign_inplace(var_14, var_129, var_128);
                    var_131 = triangle_index_0(var_113, var_130);
                    var_132 = wp::extract(var_14, var_131);
                    var_133 = wp::extract(var_63, var_113);
                    var_134 = wp::extract(var_63, var_130);
                    var_135 = wp::mul(var_133, var_134);
                    var_136 = wp::add(var_132, var_135);
                    var_137 = triangle_index_0(var_113, var_130);
                    wp::assign_inplace(var_14, var_137, var_136);
                    var_139 = triangle_index_0(var_113, var_138);
                    var_140 = wp::extract(var_14, var_139);
                    var_141 = wp::extract(var_63, var_113);
                    var_142 = wp::extract(var_63, var_138);
                    var_143 = wp::mul(var_141, var_142);
                    var_144 = wp::add(var_140, var_143);
                    var_145 = triangle_index_0(var_113, var_138);
                    wp::assign_inplace(var_14, var_145, var_144);
                    var_147 = triangle_index_0(var_113, var_146);
                    var_148 = wp::extract(var_14, var_147);
                    var_149 = wp::extract(var_63, var_113);
                    var_150 = wp::extract(var_63, var_146);
                    var_151 = wp::mul(var_149, var_150);
                    var_152 = wp::add(var_148, var_151);
                    var_153 = triangle_index_0(var_113, var_146);
                    wp::assign_inplace(var_14, var_153, var_152);
                    // for b in range(a, UNKNOWNS):                                               <L 18>
                    // total[triangle_index(a, b)] = total[triangle_index(a, b)] + row[a] * row[b]       <L 19>
                    var_156 = triangle_index_0(var_154, var_155);
                    var_157 = wp::extract(var_14, var_156);
                    var_158 = wp::extract(var_63, var_154);
                    var_159 = wp::extract(var_63, var_155);
                    var_160 = wp::mul(var_158, var_159);
                    var_161 = wp::add(var_157, var_160);
                    var_162 = triangle_index_0(var_154, var_155);
                    wp::assign_inplace(var_14, var_162, var_161);
                    var_164 = triangle_index_0(var_154, var_163);
                    var_165 = wp::extract(var_14, var_164);
                    var_166 = wp::extract(var_63, var_154);
                    var_167 = wp::extract(var_63, var_163);
                    var_168 = wp::mul(var_166, var_167);
                    var_169 = wp::add(var_165, var_168);
                    var_170 = triangle_index_0(var_154, var_163);
                    wp::assign_inplace(var_14, var_170, var_169);
                    var_172 = triangle_index_0(var_154, var_171);
                    var_173 = wp::extract(var_14, var_172);
                    var_174 = wp::extract(var_63, var_154);
                    var_175 = wp::extract(var_63, var_171);
                    var_176 = wp::mul(var_174, var_175);
                    var_177 = wp::add(var_173, var_176);
                    var_178 = triangle_index_0(var_154, var_171);
                    wp::assign_inplace(var_14, var_178, var_177);
                    var_180 = triangle_index_0(var_154, var_179);
                    var_181 = wp::extract(var_14, var_180);
                    var_182 = wp::extract(var_63, var_154);
                    var_183 = wp::extract(var_63, var_179);
                    var_184 = wp::mul(var_182, var_183);
                    var_185 = wp::add(var_181, var_184);
                    var_186 = triangle_index_0(var_154, var_179);
                    wp::assign_inplace(var_14, var_186, var_185);
                    // for b in range(a, UNKNOWNS):                                               <L 18>
                    // total[triangle_index(a, b)] = total[triangle_index(a, b)] + row[a] * row[b]       <L 19>
                    var_189 = triangle_index_0(var_187, var_188);
                    var_190 = wp::extract(var_14, var_189);
                    var_191 = wp::extract(var_63, var_187);
                    var_192 = wp::extract(var_63, var_188);
                    var_193 = wp::mul(var_191, var_192);
                    var_194 = wp::add(var_190, var_193);
                    var_195 = triangle_index_0(var_187, var_188);
                    wp::assign_inplace(var_14, var_195, var_194);
                    var_197 = triangle_index_0(var_187, var_196);
                    var_198 = wp::extract(var_14, var_197);
                    var_199 = wp::extract(var_63, var_187);
                    var_200 = wp::extract(var_63, var_196);
                    var_201 = wp::mul(var_199, var_200);
                    var_202 = wp::add(var_198, var_201);
                    var_203 = triangle_index_0(var_187, var_196);
                    wp::assign_inplace(var_14, var_203, var_202);
                    var_205 = triangle_index_0(var_187, var_204);
                    var_206 = wp::extract(var_14, var_205);
                    var_207 = wp::extract(var_63, var_187);
                    var_208 = wp::extract(var_63, var_204);
                    var_209 = wp::mul(var_207, var_208);
                    var_210 = wp::add(var_206, var_209);
                    var_211 = triangle_index_0(var_187, var_204);
                    wp::assign_inplace(var_14, var_211, var_210);
                    // for b in range(a, UNKNOWNS):                                               <L 18>
                    // total[triangle_index(a, b)] = total[triangle_index(a, b)] + row[a] * row[b]       <L 19>
                    var_214 = triangle_index_0(var_212, var_213);
                    var_215 = wp::extract(var_14, var_214);
                    var_216 = wp::extract(var_63, var_212);
                    var_217 = wp::extract(var_63, var_213);
                    var_218 = wp::mul(var_216, var_217);
                    var_219 = wp::add(var_215, var_218);
                    var_220 = triangle_index_0(var_212, var_213);
                    wp::assign_inplace(var_14, var_220, var_219);
                    var_222 = triangle_index_0(var_212, var_221);
                    var_223 = wp::extract(var_14, var_222);
                    var_224 = wp::extract(var_63, var_212);
                    var_225 = wp::extract(var_63, var_221);
                    var_226 = wp::mul(var_224, var_225);
                    var_227 = wp::add(var_223, var_226);
                    var_228 = triangle_index_0(var_212, var_221);
                    wp::assign_inplace(var_14, var_228, var_227);
                    // for b in range(a, UNKNOWNS):                                               <L 18>
                    // total[triangle_index(a, b)] = total[triangle_index(a, b)] + row[a] * row[b]       <L 19>
                    var_231 = triangle_index_0(var_229, var_230);
                    var_232 = wp::extract(var_14, var_231);
                    var_233 = wp::extract(var_63, var_229);
                    var_234 = wp::extract(var_63, var_230);
                    var_235 = wp::mul(var_233, var_234);
                    var_236 = wp::add(var_232, var_235);
                    var_237 = triangle_index_0(var_229, var_230);
                    wp::assign_inplace(var_14, var_237, var_236);
                }
            }
            goto start_for_0;
        end_for_0:;
        // for column in range(TRIANGLE):                                                         <L 20>
        var_238 = 0;
        start_for_2:;
            if (var_238 >= 21) goto end_for_2;
            var_239 = var_238;
            var_238 += 1;
            // rows[i, column] = total[column]                                                    <L 21>
            var_240 = wp::extract(var_14, var_239);
            wp::array_store(var_rows, var_0, var_239, var_240);
            goto start_for_2;
        end_for_2:;
}



extern "C" __global__ void begin_course_kernel_dcb6aa17_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float64> var_course__orders,
    wp::array_t<wp::float64> var_course__results,
    wp::array_t<wp::int32> var_course__states,
    wp::array_t<wp::int32> var_course__running,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_course__poses)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::float64 var_1;
        const wp::int32 var_2 = 16;
        wp::float64 var_3;
        const wp::int32 var_4 = 17;
        const wp::int32 var_5 = 0;
        bool var_6;
        const wp::int32 var_7 = 0;
        wp::mat_t<4, 4, wp::float64> var_8;
        const wp::int32 var_9 = 0;
        const wp::int32 var_10 = 0;
        const wp::int32 var_11 = 0;
        const wp::int32 var_12 = 0;
        const wp::int32 var_13 = 1;
        const wp::int32 var_14 = 1;
        const wp::int32 var_15 = 0;
        //---------
        // forward
        // def begin_course_kernel(course__orders, course__results, course__states, course__running, course__poses):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // course__results[i, STATE] = float64(RUNNING)                                           <L 4>
        var_1 = 0;
        wp::array_store(var_course__results, var_0, var_2, var_1);
        // course__results[i, ITERATIONS] = float64(0.0)                                          <L 5>
        var_3 = 0.0;
        wp::array_store(var_course__results, var_0, var_4, var_3);
        // if i == 0:                                                                             <L 6>
        var_6 = (var_0 == var_5);
        if (var_6) {
            // course__poses[0] = start_of(0, course__orders, course__results)                    <L 7>
            var_8 = start_of_0(var_7, var_course__orders, var_course__results);
            wp::array_store(var_course__poses, var_9, var_8);
            // course__states[0] = 0                                                              <L 8>
            wp::array_store(var_course__states, var_11, var_10);
            // course__states[1] = 0                                                              <L 9>
            wp::array_store(var_course__states, var_13, var_12);
            // course__running[0] = 1                                                             <L 10>
            wp::array_store(var_course__running, var_15, var_14);
        }
}



extern "C" __global__ void associate_points_kernel_ee7c8418_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::int32 var_run,
    wp::array_t<wp::vec_t<3, wp::float32>> var_course__points,
    wp::array_t<wp::vec_t<5, wp::float32>> var_course__planes,
    wp::array_t<wp::int32> var_course__known,
    wp::array_t<wp::float64> var_course__orders,
    wp::array_t<wp::int32> var_course__states,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_course__poses,
    wp::float64 var_course__voxel_map__voxel_size,
    wp::int32 var_course__voxel_map__room,
    wp::array_t<wp::int64> var_course__voxel_map__table__keys,
    wp::array_t<wp::int32> var_course__voxel_map__table__positions,
    wp::int64 var_course__voxel_map__table__mask,
    wp::array_t<wp::int32> var_course__voxel_map__counts,
    wp::array_t<wp::vec_t<3, wp::float32>> var_course__voxel_map__offsets,
    wp::float32 var_course__plane_radius,
    wp::array_t<wp::float64> var_rows)
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
        wp::int32 var_4;
        const wp::int32 var_5 = 22;
        wp::int32 var_6;
        const wp::int32 var_7 = 23;
        wp::int32 var_8;
        wp::int32 var_9;
        bool var_10;
        const wp::int32 var_11 = 16;
        wp::float64* var_12;
        wp::float32 var_13;
        wp::float64 var_14;
        const wp::int32 var_15 = 17;
        wp::float64* var_16;
        wp::float64 var_17;
        wp::float64 var_18;
        const wp::int32 var_19 = 21;
        wp::int32 var_20;
        const wp::int32 var_21 = 0;
        wp::mat_t<4, 4, wp::float64>* var_22;
        wp::mat_t<4, 4, wp::float64> var_23;
        wp::mat_t<4, 4, wp::float64> var_24;
        const wp::int32 var_25 = 0;
        const wp::int32 var_26 = 3;
        wp::float64 var_27;
        const wp::int32 var_28 = 1;
        const wp::int32 var_29 = 3;
        wp::float64 var_30;
        const wp::int32 var_31 = 2;
        const wp::int32 var_32 = 3;
        wp::float64 var_33;
        wp::vec_t<3, wp::float64> var_34;
        wp::float64 var_35;
        wp::vec_t<31, wp::float64> var_36;
        wp::int32 var_37;
        wp::int32 var_38;
        wp::int32 var_39;
        wp::int32 var_40;
        wp::int32 var_41;
        wp::int32 var_42;
        wp::range_t var_43;
        wp::int32 var_44;
        wp::int32 var_45;
        wp::vec_t<3, wp::float32>* var_46;
        wp::vec_t<3, wp::float64> var_47;
        wp::vec_t<3, wp::float32> var_48;
        wp::vec_t<3, wp::float64> var_49;
        wp::vec_t<3, wp::float64> var_50;
        wp::vec_t<5, wp::float64> var_51;
        const wp::int32 var_52 = 4;
        wp::float64 var_53;
        wp::int32 var_54;
        const wp::int32 var_55 = 0;
        bool var_56;
        const wp::int32 var_57 = 0;
        wp::float64 var_58;
        const wp::int32 var_59 = 1;
        wp::float64 var_60;
        const wp::int32 var_61 = 2;
        wp::float64 var_62;
        wp::vec_t<3, wp::float64> var_63;
        const wp::float32 var_64 = 0.0;
        const wp::float32 var_65 = 0.0;
        const wp::float32 var_66 = 0.0;
        const wp::float32 var_67 = 0.0;
        const wp::float32 var_68 = 1.0;
        wp::vec_t<5, wp::float32> var_69;
        bool var_70;
        const wp::int32 var_71 = 1;
        bool var_72;
        const wp::float32 var_73 = 0.0;
        bool var_74;
        wp::int32* var_75;
        bool var_76;
        wp::int32 var_77;
        wp::vec_t<5, wp::float32>* var_78;
        wp::vec_t<5, wp::float32> var_79;
        wp::vec_t<5, wp::float32> var_80;
        wp::vec_t<3, wp::float64> var_81;
        wp::vec_t<5, wp::float32> var_82;
        wp::vec_t<5, wp::float32> var_83;
        wp::vec_t<5, wp::float32> var_84;
        wp::vec_t<31, wp::float64> var_85;
        wp::vec_t<31, wp::float64> var_86;
        wp::int32 var_87;
        wp::int32 var_88;
        wp::float64 var_89;
        //---------
        // forward
        // def associate_points_kernel(run, course__points, course__planes, course__known, course__orders, course__states, course__poses, course__voxel_map__voxel_size, course__voxel_map__room, course__voxel_map__table__keys, course__voxel_map__table__positions, course__voxel_map__table__mask, course__voxel_map__counts, course__voxel_map__offsets, course__plane_radius, rows):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // leg = course__states[0]                                                                <L 4>
        var_2 = wp::address(var_course__states, var_1);
        var_4 = wp::load(var_2);
        var_3 = wp::copy(var_4);
        // begin = leg_number(leg, FIRST, course__orders)                                         <L 5>
        var_6 = leg_number_0(var_3, var_5, var_course__orders);
        // count = leg_number(leg, COUNT, course__orders)                                         <L 6>
        var_8 = leg_number_0(var_3, var_7, var_course__orders);
        // if i * run < count:                                                                    <L 7>
        var_9 = wp::mul(var_0, var_run);
        var_10 = (var_9 < var_8);
        if (var_10) {
            // limit = float(course__orders[leg, LIMIT])                                          <L 8>
            var_12 = wp::address(var_course__orders, var_3, var_11);
            var_14 = wp::load(var_12);
            var_13 = wp::float(var_14);
            // kernel_scale = course__orders[leg, SCALE]                                          <L 9>
            var_16 = wp::address(var_course__orders, var_3, var_15);
            var_18 = wp::load(var_16);
            var_17 = wp::copy(var_18);
            // to_planes = leg_number(leg, TO_PLANES, course__orders)                             <L 10>
            var_20 = leg_number_0(var_3, var_19, var_course__orders);
            // pose = course__poses[0]                                                            <L 11>
            var_22 = wp::address(var_course__poses, var_21);
            var_24 = wp::load(var_22);
            var_23 = wp::copy(var_24);
            // t = vec3d(pose[0, 3], pose[1, 3], pose[2, 3])                                      <L 12>
            var_27 = wp::extract(var_23, var_25, var_26);
            var_30 = wp::extract(var_23, var_28, var_29);
            var_33 = wp::extract(var_23, var_31, var_32);
            var_34 = wp::vec_t<3, wp::float64>(var_27, var_30, var_33);
            // total = sums(float64(0.0))                                                         <L 13>
            var_35 = 0.0;
            var_36 = wp::vec_t<31, wp::float64>(var_35);
            // for k in range(i * run, i * run + min(run, count - i * run)):                      <L 14>
            var_37 = wp::mul(var_0, var_run);
            var_38 = wp::mul(var_0, var_run);
            var_39 = wp::mul(var_0, var_run);
            var_40 = wp::sub(var_8, var_39);
            var_41 = wp::min(var_run, var_40);
            var_42 = wp::add(var_38, var_41);
            var_43 = wp::range(var_37, var_42);
            start_for_0:;
                if (iter_cmp(var_43) == 0) goto end_for_0;
                var_44 = wp::iter_next(var_43);
                // j = begin + k                                                                  <L 15>
                var_45 = wp::add(var_6, var_44);
                // y = rotate(pose, widen(course__points[j]))                                     <L 16>
                var_46 = wp::address(var_course__points, var_45);
                var_48 = wp::load(var_46);
                var_47 = widen_0(var_48);
                var_49 = rotate_1(var_23, var_47);
                // x = y + t                                                                      <L 17>
                var_50 = wp::add(var_49, var_34);
                // nearest_point = find_nearest_in_map(x, limit, course__voxel_map__voxel_size, course__voxel_map__room, course__voxel_map__table__keys, course__voxel_map__table__positions, course__voxel_map__table__mask, course__voxel_map__counts, course__voxel_map__offsets)       <L 18>
                var_51 = find_nearest_in_map_0(var_50, var_13, var_course__voxel_map__voxel_size, var_course__voxel_map__room, var_course__voxel_map__table__keys, var_course__voxel_map__table__positions, var_course__voxel_map__table__mask, var_course__voxel_map__counts, var_course__voxel_map__offsets);
                // nearest = int(nearest_point[4])                                                <L 19>
                var_53 = wp::extract(var_51, var_52);
                var_54 = wp::int(var_53);
                // if nearest >= 0:                                                               <L 20>
                var_56 = (var_54 >= var_55);
                if (var_56) {
                    // r = vec3d(nearest_point[0], nearest_point[1], nearest_point[2])            <L 21>
                    var_58 = wp::extract(var_51, var_57);
                    var_60 = wp::extract(var_51, var_59);
                    var_62 = wp::extract(var_51, var_61);
                    var_63 = wp::vec_t<3, wp::float64>(var_58, var_60, var_62);
                    // at = plane(0.0, 0.0, 0.0, 0.0, 1.0)                                        <L 22>
                    var_69 = wp::vec_t<5, wp::float32>({var_64, var_65, var_66, var_67, var_68});
                    // if to_planes == 1 and course__plane_radius > 0.0:                          <L 23>
                    var_72 = (var_20 == var_71);
                    var_70 = var_72;
                    if (var_70) {
                        var_74 = (var_course__plane_radius > var_73);
                        var_70 = var_70 && var_74;
                    }
                    if (var_70) {
                        // if course__known[j] == nearest:                                        <L 24>
                        var_75 = wp::address(var_course__known, var_45);
                        var_77 = wp::load(var_75);
                        var_76 = (var_77 == var_54);
                        if (var_76) {
                            // at = course__planes[j]                                             <L 25>
                            var_78 = wp::address(var_course__planes, var_45);
                            var_80 = wp::load(var_78);
                            var_79 = wp::copy(var_80);
                        }
                        if (!var_76) {
                            // at = plane_around(x - r, course__plane_radius, course__voxel_map__voxel_size, course__voxel_map__room, course__voxel_map__table__keys, course__voxel_map__table__positions, course__voxel_map__table__mask, course__voxel_map__counts, course__voxel_map__offsets)       <L 27>
                            var_81 = wp::sub(var_50, var_63);
                            var_82 = plane_around_0(var_81, var_course__plane_radius, var_course__voxel_map__voxel_size, var_course__voxel_map__room, var_course__voxel_map__table__keys, var_course__voxel_map__table__positions, var_course__voxel_map__table__mask, var_course__voxel_map__counts, var_course__voxel_map__offsets);
                            // course__known[j] = nearest                                         <L 28>
                            wp::array_store(var_course__known, var_45, var_54);
                            // course__planes[j] = at                                             <L 29>
                            wp::array_store(var_course__planes, var_45, var_82);
                        }
                        var_83 = wp::where(var_76, var_79, var_82);
                    }
                    var_84 = wp::where(var_70, var_83, var_69);
                    // total = add_pair(total, y, r, at, kernel_scale)                            <L 30>
                    var_85 = add_pair_0(var_36, var_49, var_63, var_84, var_17);
                }
                var_86 = wp::where(var_56, var_85, var_36);
                wp::assign(var_36, var_86);
                goto start_for_0;
            end_for_0:;
            // for column in range(SUMS):                                                         <L 31>
            var_87 = 0;
            start_for_2:;
                if (var_87 >= 31) goto end_for_2;
                var_88 = var_87;
                var_87 += 1;
                // rows[i, column] = total[column]                                                <L 32>
                var_89 = wp::extract(var_36, var_88);
                wp::array_store(var_rows, var_0, var_88, var_89);
                goto start_for_2;
            end_for_2:;
        }
}


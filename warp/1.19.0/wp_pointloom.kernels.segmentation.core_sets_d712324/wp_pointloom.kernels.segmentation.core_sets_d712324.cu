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


// /work/main/src/pointloom/kernels/search/tree_walk.py:34
static CUDA_CALLABLE wp::int32 record_of_0(
    wp::array_t<wp::int32> var_levels,
    wp::int32 var_level,
    wp::int32 var_node)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 1;
    wp::int32 var_1;
    wp::int32* var_2;
    wp::int32 var_3;
    wp::int32 var_4;
    //---------
    // forward
    // def record_of(levels: array(dtype=int32), level: int, node: int) -> int:               <L 35>
    // return levels[level - 1] + node                                                        <L 37>
    var_1 = wp::sub(var_level, var_0);
    var_2 = wp::address(var_levels, var_1);
    var_4 = wp::load(var_2);
    var_3 = wp::add(var_4, var_node);
    return var_3;
}


// /work/main/src/pointloom/kernels/search/tree_walk.py:164
static CUDA_CALLABLE wp::vec_t<8, wp::float32> measure_diagonals_0(
    wp::array_t<wp::float32> var_boxes,
    wp::int32 var_record)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 48;
    wp::int32 var_1;
    const wp::float32 var_2 = 0.0;
    wp::vec_t<8, wp::float32> var_3;
    const wp::int32 var_4 = 0;
    wp::int32 var_5;
    const wp::int32 var_6 = 3;
    const wp::int32 var_7 = 8;
    wp::int32 var_8;
    wp::int32 var_9;
    wp::float32* var_10;
    wp::int32 var_11;
    wp::float32* var_12;
    wp::float32 var_13;
    wp::float32 var_14;
    wp::float32 var_15;
    wp::int32 var_16;
    const wp::int32 var_17 = 4;
    wp::int32 var_18;
    wp::int32 var_19;
    wp::float32* var_20;
    wp::int32 var_21;
    wp::int32 var_22;
    wp::float32* var_23;
    wp::float32 var_24;
    wp::float32 var_25;
    wp::float32 var_26;
    wp::int32 var_27;
    const wp::int32 var_28 = 5;
    wp::int32 var_29;
    wp::int32 var_30;
    wp::float32* var_31;
    wp::int32 var_32;
    const wp::int32 var_33 = 2;
    wp::int32 var_34;
    wp::int32 var_35;
    wp::float32* var_36;
    wp::float32 var_37;
    wp::float32 var_38;
    wp::float32 var_39;
    wp::float32 var_40;
    wp::float32 var_41;
    wp::float32 var_42;
    wp::float32 var_43;
    wp::float32 var_44;
    const wp::int32 var_45 = 1;
    wp::int32 var_46;
    const wp::int32 var_47 = 3;
    wp::int32 var_48;
    wp::int32 var_49;
    wp::float32* var_50;
    wp::int32 var_51;
    wp::float32* var_52;
    wp::float32 var_53;
    wp::float32 var_54;
    wp::float32 var_55;
    wp::int32 var_56;
    const wp::int32 var_57 = 4;
    wp::int32 var_58;
    wp::int32 var_59;
    wp::float32* var_60;
    wp::int32 var_61;
    wp::int32 var_62;
    wp::float32* var_63;
    wp::float32 var_64;
    wp::float32 var_65;
    wp::float32 var_66;
    wp::int32 var_67;
    const wp::int32 var_68 = 5;
    wp::int32 var_69;
    wp::int32 var_70;
    wp::float32* var_71;
    wp::int32 var_72;
    const wp::int32 var_73 = 2;
    wp::int32 var_74;
    wp::int32 var_75;
    wp::float32* var_76;
    wp::float32 var_77;
    wp::float32 var_78;
    wp::float32 var_79;
    wp::float32 var_80;
    wp::float32 var_81;
    wp::float32 var_82;
    wp::float32 var_83;
    wp::float32 var_84;
    const wp::int32 var_85 = 2;
    wp::int32 var_86;
    const wp::int32 var_87 = 3;
    wp::int32 var_88;
    wp::int32 var_89;
    wp::float32* var_90;
    wp::int32 var_91;
    wp::float32* var_92;
    wp::float32 var_93;
    wp::float32 var_94;
    wp::float32 var_95;
    wp::int32 var_96;
    const wp::int32 var_97 = 4;
    wp::int32 var_98;
    wp::int32 var_99;
    wp::float32* var_100;
    wp::int32 var_101;
    wp::int32 var_102;
    wp::float32* var_103;
    wp::float32 var_104;
    wp::float32 var_105;
    wp::float32 var_106;
    wp::int32 var_107;
    const wp::int32 var_108 = 5;
    wp::int32 var_109;
    wp::int32 var_110;
    wp::float32* var_111;
    wp::int32 var_112;
    const wp::int32 var_113 = 2;
    wp::int32 var_114;
    wp::int32 var_115;
    wp::float32* var_116;
    wp::float32 var_117;
    wp::float32 var_118;
    wp::float32 var_119;
    wp::float32 var_120;
    wp::float32 var_121;
    wp::float32 var_122;
    wp::float32 var_123;
    wp::float32 var_124;
    const wp::int32 var_125 = 3;
    wp::int32 var_126;
    const wp::int32 var_127 = 3;
    wp::int32 var_128;
    wp::int32 var_129;
    wp::float32* var_130;
    wp::int32 var_131;
    wp::float32* var_132;
    wp::float32 var_133;
    wp::float32 var_134;
    wp::float32 var_135;
    wp::int32 var_136;
    const wp::int32 var_137 = 4;
    wp::int32 var_138;
    wp::int32 var_139;
    wp::float32* var_140;
    wp::int32 var_141;
    wp::int32 var_142;
    wp::float32* var_143;
    wp::float32 var_144;
    wp::float32 var_145;
    wp::float32 var_146;
    wp::int32 var_147;
    const wp::int32 var_148 = 5;
    wp::int32 var_149;
    wp::int32 var_150;
    wp::float32* var_151;
    wp::int32 var_152;
    const wp::int32 var_153 = 2;
    wp::int32 var_154;
    wp::int32 var_155;
    wp::float32* var_156;
    wp::float32 var_157;
    wp::float32 var_158;
    wp::float32 var_159;
    wp::float32 var_160;
    wp::float32 var_161;
    wp::float32 var_162;
    wp::float32 var_163;
    wp::float32 var_164;
    const wp::int32 var_165 = 4;
    wp::int32 var_166;
    const wp::int32 var_167 = 3;
    wp::int32 var_168;
    wp::int32 var_169;
    wp::float32* var_170;
    wp::int32 var_171;
    wp::float32* var_172;
    wp::float32 var_173;
    wp::float32 var_174;
    wp::float32 var_175;
    wp::int32 var_176;
    const wp::int32 var_177 = 4;
    wp::int32 var_178;
    wp::int32 var_179;
    wp::float32* var_180;
    wp::int32 var_181;
    wp::int32 var_182;
    wp::float32* var_183;
    wp::float32 var_184;
    wp::float32 var_185;
    wp::float32 var_186;
    wp::int32 var_187;
    const wp::int32 var_188 = 5;
    wp::int32 var_189;
    wp::int32 var_190;
    wp::float32* var_191;
    wp::int32 var_192;
    const wp::int32 var_193 = 2;
    wp::int32 var_194;
    wp::int32 var_195;
    wp::float32* var_196;
    wp::float32 var_197;
    wp::float32 var_198;
    wp::float32 var_199;
    wp::float32 var_200;
    wp::float32 var_201;
    wp::float32 var_202;
    wp::float32 var_203;
    wp::float32 var_204;
    const wp::int32 var_205 = 5;
    wp::int32 var_206;
    const wp::int32 var_207 = 3;
    wp::int32 var_208;
    wp::int32 var_209;
    wp::float32* var_210;
    wp::int32 var_211;
    wp::float32* var_212;
    wp::float32 var_213;
    wp::float32 var_214;
    wp::float32 var_215;
    wp::int32 var_216;
    const wp::int32 var_217 = 4;
    wp::int32 var_218;
    wp::int32 var_219;
    wp::float32* var_220;
    wp::int32 var_221;
    wp::int32 var_222;
    wp::float32* var_223;
    wp::float32 var_224;
    wp::float32 var_225;
    wp::float32 var_226;
    wp::int32 var_227;
    const wp::int32 var_228 = 5;
    wp::int32 var_229;
    wp::int32 var_230;
    wp::float32* var_231;
    wp::int32 var_232;
    const wp::int32 var_233 = 2;
    wp::int32 var_234;
    wp::int32 var_235;
    wp::float32* var_236;
    wp::float32 var_237;
    wp::float32 var_238;
    wp::float32 var_239;
    wp::float32 var_240;
    wp::float32 var_241;
    wp::float32 var_242;
    wp::float32 var_243;
    wp::float32 var_244;
    const wp::int32 var_245 = 6;
    wp::int32 var_246;
    const wp::int32 var_247 = 3;
    wp::int32 var_248;
    wp::int32 var_249;
    wp::float32* var_250;
    wp::int32 var_251;
    wp::float32* var_252;
    wp::float32 var_253;
    wp::float32 var_254;
    wp::float32 var_255;
    wp::int32 var_256;
    const wp::int32 var_257 = 4;
    wp::int32 var_258;
    wp::int32 var_259;
    wp::float32* var_260;
    wp::int32 var_261;
    wp::int32 var_262;
    wp::float32* var_263;
    wp::float32 var_264;
    wp::float32 var_265;
    wp::float32 var_266;
    wp::int32 var_267;
    const wp::int32 var_268 = 5;
    wp::int32 var_269;
    wp::int32 var_270;
    wp::float32* var_271;
    wp::int32 var_272;
    const wp::int32 var_273 = 2;
    wp::int32 var_274;
    wp::int32 var_275;
    wp::float32* var_276;
    wp::float32 var_277;
    wp::float32 var_278;
    wp::float32 var_279;
    wp::float32 var_280;
    wp::float32 var_281;
    wp::float32 var_282;
    wp::float32 var_283;
    wp::float32 var_284;
    const wp::int32 var_285 = 7;
    wp::int32 var_286;
    const wp::int32 var_287 = 3;
    wp::int32 var_288;
    wp::int32 var_289;
    wp::float32* var_290;
    wp::int32 var_291;
    wp::float32* var_292;
    wp::float32 var_293;
    wp::float32 var_294;
    wp::float32 var_295;
    wp::int32 var_296;
    const wp::int32 var_297 = 4;
    wp::int32 var_298;
    wp::int32 var_299;
    wp::float32* var_300;
    wp::int32 var_301;
    wp::int32 var_302;
    wp::float32* var_303;
    wp::float32 var_304;
    wp::float32 var_305;
    wp::float32 var_306;
    wp::int32 var_307;
    const wp::int32 var_308 = 5;
    wp::int32 var_309;
    wp::int32 var_310;
    wp::float32* var_311;
    wp::int32 var_312;
    const wp::int32 var_313 = 2;
    wp::int32 var_314;
    wp::int32 var_315;
    wp::float32* var_316;
    wp::float32 var_317;
    wp::float32 var_318;
    wp::float32 var_319;
    wp::float32 var_320;
    wp::float32 var_321;
    wp::float32 var_322;
    wp::float32 var_323;
    wp::float32 var_324;
    //---------
    // forward
    // def measure_diagonals(boxes: array(dtype=float32), record: int) -> box_distances:       <L 165>
    // at = record * SIDES                                                                    <L 167>
    var_1 = wp::mul(var_record, var_0);
    // distances = box_distances(0.0)                                                         <L 168>
    var_3 = wp::vec_t<8, wp::float32>(var_2);
    // for j in range(FAN):                                                                   <L 169>
    // x = boxes[at + j + 3 * FAN] - boxes[at + j]                                            <L 170>
    var_5 = wp::add(var_1, var_4);
    var_8 = wp::mul(var_6, var_7);
    var_9 = wp::add(var_5, var_8);
    var_10 = wp::address(var_boxes, var_9);
    var_11 = wp::add(var_1, var_4);
    var_12 = wp::address(var_boxes, var_11);
    var_14 = wp::load(var_10);
    var_15 = wp::load(var_12);
    var_13 = wp::sub(var_14, var_15);
    // y = boxes[at + j + 4 * FAN] - boxes[at + j + FAN]                                      <L 171>
    var_16 = wp::add(var_1, var_4);
    var_18 = wp::mul(var_17, var_7);
    var_19 = wp::add(var_16, var_18);
    var_20 = wp::address(var_boxes, var_19);
    var_21 = wp::add(var_1, var_4);
    var_22 = wp::add(var_21, var_7);
    var_23 = wp::address(var_boxes, var_22);
    var_25 = wp::load(var_20);
    var_26 = wp::load(var_23);
    var_24 = wp::sub(var_25, var_26);
    // z = boxes[at + j + 5 * FAN] - boxes[at + j + 2 * FAN]                                  <L 172>
    var_27 = wp::add(var_1, var_4);
    var_29 = wp::mul(var_28, var_7);
    var_30 = wp::add(var_27, var_29);
    var_31 = wp::address(var_boxes, var_30);
    var_32 = wp::add(var_1, var_4);
    var_34 = wp::mul(var_33, var_7);
    var_35 = wp::add(var_32, var_34);
    var_36 = wp::address(var_boxes, var_35);
    var_38 = wp::load(var_31);
    var_39 = wp::load(var_36);
    var_37 = wp::sub(var_38, var_39);
    // distances[j] = x * x + y * y + z * z                                                   <L 173>
    var_40 = wp::mul(var_13, var_13);
    var_41 = wp::mul(var_24, var_24);
    var_42 = wp::add(var_40, var_41);
    var_43 = wp::mul(var_37, var_37);
    var_44 = wp::add(var_42, var_43);
    wp::assign_inplace(var_3, var_4, var_44);
    // x = boxes[at + j + 3 * FAN] - boxes[at + j]                                            <L 170>
    var_46 = wp::add(var_1, var_45);
    var_48 = wp::mul(var_47, var_7);
    var_49 = wp::add(var_46, var_48);
    var_50 = wp::address(var_boxes, var_49);
    var_51 = wp::add(var_1, var_45);
    var_52 = wp::address(var_boxes, var_51);
    var_54 = wp::load(var_50);
    var_55 = wp::load(var_52);
    var_53 = wp::sub(var_54, var_55);
    // y = boxes[at + j + 4 * FAN] - boxes[at + j + FAN]                                      <L 171>
    var_56 = wp::add(var_1, var_45);
    var_58 = wp::mul(var_57, var_7);
    var_59 = wp::add(var_56, var_58);
    var_60 = wp::address(var_boxes, var_59);
    var_61 = wp::add(var_1, var_45);
    var_62 = wp::add(var_61, var_7);
    var_63 = wp::address(var_boxes, var_62);
    var_65 = wp::load(var_60);
    var_66 = wp::load(var_63);
    var_64 = wp::sub(var_65, var_66);
    // z = boxes[at + j + 5 * FAN] - boxes[at + j + 2 * FAN]                                  <L 172>
    var_67 = wp::add(var_1, var_45);
    var_69 = wp::mul(var_68, var_7);
    var_70 = wp::add(var_67, var_69);
    var_71 = wp::address(var_boxes, var_70);
    var_72 = wp::add(var_1, var_45);
    var_74 = wp::mul(var_73, var_7);
    var_75 = wp::add(var_72, var_74);
    var_76 = wp::address(var_boxes, var_75);
    var_78 = wp::load(var_71);
    var_79 = wp::load(var_76);
    var_77 = wp::sub(var_78, var_79);
    // distances[j] = x * x + y * y + z * z                                                   <L 173>
    var_80 = wp::mul(var_53, var_53);
    var_81 = wp::mul(var_64, var_64);
    var_82 = wp::add(var_80, var_81);
    var_83 = wp::mul(var_77, var_77);
    var_84 = wp::add(var_82, var_83);
    wp::assign_inplace(var_3, var_45, var_84);
    // x = boxes[at + j + 3 * FAN] - boxes[at + j]                                            <L 170>
    var_86 = wp::add(var_1, var_85);
    var_88 = wp::mul(var_87, var_7);
    var_89 = wp::add(var_86, var_88);
    var_90 = wp::address(var_boxes, var_89);
    var_91 = wp::add(var_1, var_85);
    var_92 = wp::address(var_boxes, var_91);
    var_94 = wp::load(var_90);
    var_95 = wp::load(var_92);
    var_93 = wp::sub(var_94, var_95);
    // y = boxes[at + j + 4 * FAN] - boxes[at + j + FAN]                                      <L 171>
    var_96 = wp::add(var_1, var_85);
    var_98 = wp::mul(var_97, var_7);
    var_99 = wp::add(var_96, var_98);
    var_100 = wp::address(var_boxes, var_99);
    var_101 = wp::add(var_1, var_85);
    var_102 = wp::add(var_101, var_7);
    var_103 = wp::address(var_boxes, var_102);
    var_105 = wp::load(var_100);
    var_106 = wp::load(var_103);
    var_104 = wp::sub(var_105, var_106);
    // z = boxes[at + j + 5 * FAN] - boxes[at + j + 2 * FAN]                                  <L 172>
    var_107 = wp::add(var_1, var_85);
    var_109 = wp::mul(var_108, var_7);
    var_110 = wp::add(var_107, var_109);
    var_111 = wp::address(var_boxes, var_110);
    var_112 = wp::add(var_1, var_85);
    var_114 = wp::mul(var_113, var_7);
    var_115 = wp::add(var_112, var_114);
    var_116 = wp::address(var_boxes, var_115);
    var_118 = wp::load(var_111);
    var_119 = wp::load(var_116);
    var_117 = wp::sub(var_118, var_119);
    // distances[j] = x * x + y * y + z * z                                                   <L 173>
    var_120 = wp::mul(var_93, var_93);
    var_121 = wp::mul(var_104, var_104);
    var_122 = wp::add(var_120, var_121);
    var_123 = wp::mul(var_117, var_117);
    var_124 = wp::add(var_122, var_123);
    wp::assign_inplace(var_3, var_85, var_124);
    // x = boxes[at + j + 3 * FAN] - boxes[at + j]                                            <L 170>
    var_126 = wp::add(var_1, var_125);
    var_128 = wp::mul(var_127, var_7);
    var_129 = wp::add(var_126, var_128);
    var_130 = wp::address(var_boxes, var_129);
    var_131 = wp::add(var_1, var_125);
    var_132 = wp::address(var_boxes, var_131);
    var_134 = wp::load(var_130);
    var_135 = wp::load(var_132);
    var_133 = wp::sub(var_134, var_135);
    // y = boxes[at + j + 4 * FAN] - boxes[at + j + FAN]                                      <L 171>
    var_136 = wp::add(var_1, var_125);
    var_138 = wp::mul(var_137, var_7);
    var_139 = wp::add(var_136, var_138);
    var_140 = wp::address(var_boxes, var_139);
    var_141 = wp::add(var_1, var_125);
    var_142 = wp::add(var_141, var_7);
    var_143 = wp::address(var_boxes, var_142);
    var_145 = wp::load(var_140);
    var_146 = wp::load(var_143);
    var_144 = wp::sub(var_145, var_146);
    // z = boxes[at + j + 5 * FAN] - boxes[at + j + 2 * FAN]                                  <L 172>
    var_147 = wp::add(var_1, var_125);
    var_149 = wp::mul(var_148, var_7);
    var_150 = wp::add(var_147, var_149);
    var_151 = wp::address(var_boxes, var_150);
    var_152 = wp::add(var_1, var_125);
    var_154 = wp::mul(var_153, var_7);
    var_155 = wp::add(var_152, var_154);
    var_156 = wp::address(var_boxes, var_155);
    var_158 = wp::load(var_151);
    var_159 = wp::load(var_156);
    var_157 = wp::sub(var_158, var_159);
    // distances[j] = x * x + y * y + z * z                                                   <L 173>
    var_160 = wp::mul(var_133, var_133);
    var_161 = wp::mul(var_144, var_144);
    var_162 = wp::add(var_160, var_161);
    var_163 = wp::mul(var_157, var_157);
    var_164 = wp::add(var_162, var_163);
    wp::assign_inplace(var_3, var_125, var_164);
    // x = boxes[at + j + 3 * FAN] - boxes[at + j]                                            <L 170>
    var_166 = wp::add(var_1, var_165);
    var_168 = wp::mul(var_167, var_7);
    var_169 = wp::add(var_166, var_168);
    var_170 = wp::address(var_boxes, var_169);
    var_171 = wp::add(var_1, var_165);
    var_172 = wp::address(var_boxes, var_171);
    var_174 = wp::load(var_170);
    var_175 = wp::load(var_172);
    var_173 = wp::sub(var_174, var_175);
    // y = boxes[at + j + 4 * FAN] - boxes[at + j + FAN]                                      <L 171>
    var_176 = wp::add(var_1, var_165);
    var_178 = wp::mul(var_177, var_7);
    var_179 = wp::add(var_176, var_178);
    var_180 = wp::address(var_boxes, var_179);
    var_181 = wp::add(var_1, var_165);
    var_182 = wp::add(var_181, var_7);
    var_183 = wp::address(var_boxes, var_182);
    var_185 = wp::load(var_180);
    var_186 = wp::load(var_183);
    var_184 = wp::sub(var_185, var_186);
    // z = boxes[at + j + 5 * FAN] - boxes[at + j + 2 * FAN]                                  <L 172>
    var_187 = wp::add(var_1, var_165);
    var_189 = wp::mul(var_188, var_7);
    var_190 = wp::add(var_187, var_189);
    var_191 = wp::address(var_boxes, var_190);
    var_192 = wp::add(var_1, var_165);
    var_194 = wp::mul(var_193, var_7);
    var_195 = wp::add(var_192, var_194);
    var_196 = wp::address(var_boxes, var_195);
    var_198 = wp::load(var_191);
    var_199 = wp::load(var_196);
    var_197 = wp::sub(var_198, var_199);
    // distances[j] = x * x + y * y + z * z                                                   <L 173>
    var_200 = wp::mul(var_173, var_173);
    var_201 = wp::mul(var_184, var_184);
    var_202 = wp::add(var_200, var_201);
    var_203 = wp::mul(var_197, var_197);
    var_204 = wp::add(var_202, var_203);
    wp::assign_inplace(var_3, var_165, var_204);
    // x = boxes[at + j + 3 * FAN] - boxes[at + j]                                            <L 170>
    var_206 = wp::add(var_1, var_205);
    var_208 = wp::mul(var_207, var_7);
    var_209 = wp::add(var_206, var_208);
    var_210 = wp::address(var_boxes, var_209);
    var_211 = wp::add(var_1, var_205);
    var_212 = wp::address(var_boxes, var_211);
    var_214 = wp::load(var_210);
    var_215 = wp::load(var_212);
    var_213 = wp::sub(var_214, var_215);
    // y = boxes[at + j + 4 * FAN] - boxes[at + j + FAN]                                      <L 171>
    var_216 = wp::add(var_1, var_205);
    var_218 = wp::mul(var_217, var_7);
    var_219 = wp::add(var_216, var_218);
    var_220 = wp::address(var_boxes, var_219);
    var_221 = wp::add(var_1, var_205);
    var_222 = wp::add(var_221, var_7);
    var_223 = wp::address(var_boxes, var_222);
    var_225 = wp::load(var_220);
    var_226 = wp::load(var_223);
    var_224 = wp::sub(var_225, var_226);
    // z = boxes[at + j + 5 * FAN] - boxes[at + j + 2 * FAN]                                  <L 172>
    var_227 = wp::add(var_1, var_205);
    var_229 = wp::mul(var_228, var_7);
    var_230 = wp::add(var_227, var_229);
    var_231 = wp::address(var_boxes, var_230);
    var_232 = wp::add(var_1, var_205);
    var_234 = wp::mul(var_233, var_7);
    var_235 = wp::add(var_232, var_234);
    var_236 = wp::address(var_boxes, var_235);
    var_238 = wp::load(var_231);
    var_239 = wp::load(var_236);
    var_237 = wp::sub(var_238, var_239);
    // distances[j] = x * x + y * y + z * z                                                   <L 173>
    var_240 = wp::mul(var_213, var_213);
    var_241 = wp::mul(var_224, var_224);
    var_242 = wp::add(var_240, var_241);
    var_243 = wp::mul(var_237, var_237);
    var_244 = wp::add(var_242, var_243);
    wp::assign_inplace(var_3, var_205, var_244);
    // x = boxes[at + j + 3 * FAN] - boxes[at + j]                                            <L 170>
    var_246 = wp::add(var_1, var_245);
    var_248 = wp::mul(var_247, var_7);
    var_249 = wp::add(var_246, var_248);
    var_250 = wp::address(var_boxes, var_249);
    var_251 = wp::add(var_1, var_245);
    var_252 = wp::address(var_boxes, var_251);
    var_254 = wp::load(var_250);
    var_255 = wp::load(var_252);
    var_253 = wp::sub(var_254, var_255);
    // y = boxes[at + j + 4 * FAN] - boxes[at + j + FAN]                                      <L 171>
    var_256 = wp::add(var_1, var_245);
    var_258 = wp::mul(var_257, var_7);
    var_259 = wp::add(var_256, var_258);
    var_260 = wp::address(var_boxes, var_259);
    var_261 = wp::add(var_1, var_245);
    var_262 = wp::add(var_261, var_7);
    var_263 = wp::address(var_boxes, var_262);
    var_265 = wp::load(var_260);
    var_266 = wp::load(var_263);
    var_264 = wp::sub(var_265, var_266);
    // z = boxes[at + j + 5 * FAN] - boxes[at + j + 2 * FAN]                                  <L 172>
    var_267 = wp::add(var_1, var_245);
    var_269 = wp::mul(var_268, var_7);
    var_270 = wp::add(var_267, var_269);
    var_271 = wp::address(var_boxes, var_270);
    var_272 = wp::add(var_1, var_245);
    var_274 = wp::mul(var_273, var_7);
    var_275 = wp::add(var_272, var_274);
    var_276 = wp::address(var_boxes, var_275);
    var_278 = wp::load(var_271);
    var_279 = wp::load(var_276);
    var_277 = wp::sub(var_278, var_279);
    // distances[j] = x * x + y * y + z * z                                                   <L 173>
    var_280 = wp::mul(var_253, var_253);
    var_281 = wp::mul(var_264, var_264);
    var_282 = wp::add(var_280, var_281);
    var_283 = wp::mul(var_277, var_277);
    var_284 = wp::add(var_282, var_283);
    wp::assign_inplace(var_3, var_245, var_284);
    // x = boxes[at + j + 3 * FAN] - boxes[at + j]                                            <L 170>
    var_286 = wp::add(var_1, var_285);
    var_288 = wp::mul(var_287, var_7);
    var_289 = wp::add(var_286, var_288);
    var_290 = wp::address(var_boxes, var_289);
    var_291 = wp::add(var_1, var_285);
    var_292 = wp::address(var_boxes, var_291);
    var_294 = wp::load(var_290);
    var_295 = wp::load(var_292);
    var_293 = wp::sub(var_294, var_295);
    // y = boxes[at + j + 4 * FAN] - boxes[at + j + FAN]                                      <L 171>
    var_296 = wp::add(var_1, var_285);
    var_298 = wp::mul(var_297, var_7);
    var_299 = wp::add(var_296, var_298);
    var_300 = wp::address(var_boxes, var_299);
    var_301 = wp::add(var_1, var_285);
    var_302 = wp::add(var_301, var_7);
    var_303 = wp::address(var_boxes, var_302);
    var_305 = wp::load(var_300);
    var_306 = wp::load(var_303);
    var_304 = wp::sub(var_305, var_306);
    // z = boxes[at + j + 5 * FAN] - boxes[at + j + 2 * FAN]                                  <L 172>
    var_307 = wp::add(var_1, var_285);
    var_309 = wp::mul(var_308, var_7);
    var_310 = wp::add(var_307, var_309);
    var_311 = wp::address(var_boxes, var_310);
    var_312 = wp::add(var_1, var_285);
    var_314 = wp::mul(var_313, var_7);
    var_315 = wp::add(var_312, var_314);
    var_316 = wp::address(var_boxes, var_315);
    var_318 = wp::load(var_311);
    var_319 = wp::load(var_316);
    var_317 = wp::sub(var_318, var_319);
    // distances[j] = x * x + y * y + z * z                                                   <L 173>
    var_320 = wp::mul(var_293, var_293);
    var_321 = wp::mul(var_304, var_304);
    var_322 = wp::add(var_320, var_321);
    var_323 = wp::mul(var_317, var_317);
    var_324 = wp::add(var_322, var_323);
    wp::assign_inplace(var_3, var_285, var_324);
    // return distances                                                                       <L 174>
    return var_3;
}


// <pointloom.kernels.search.tree_walk.bits_within>:1
static CUDA_CALLABLE wp::int32 bits_within_0(
    wp::vec_t<8, wp::float32> var_distances,
    wp::float32 var_max_sqdist)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    const wp::int32 var_2 = 0;
    wp::float32 var_3;
    bool var_4;
    const wp::int32 var_5 = 1;
    wp::int32 var_6;
    const wp::int32 var_7 = 0;
    wp::int32 var_8;
    wp::int32 var_9;
    const wp::int32 var_10 = 1;
    wp::float32 var_11;
    bool var_12;
    const wp::int32 var_13 = 1;
    wp::int32 var_14;
    const wp::int32 var_15 = 0;
    wp::int32 var_16;
    wp::int32 var_17;
    const wp::int32 var_18 = 2;
    wp::float32 var_19;
    bool var_20;
    const wp::int32 var_21 = 1;
    wp::int32 var_22;
    const wp::int32 var_23 = 0;
    wp::int32 var_24;
    wp::int32 var_25;
    const wp::int32 var_26 = 3;
    wp::float32 var_27;
    bool var_28;
    const wp::int32 var_29 = 1;
    wp::int32 var_30;
    const wp::int32 var_31 = 0;
    wp::int32 var_32;
    wp::int32 var_33;
    const wp::int32 var_34 = 4;
    wp::float32 var_35;
    bool var_36;
    const wp::int32 var_37 = 1;
    wp::int32 var_38;
    const wp::int32 var_39 = 0;
    wp::int32 var_40;
    wp::int32 var_41;
    const wp::int32 var_42 = 5;
    wp::float32 var_43;
    bool var_44;
    const wp::int32 var_45 = 1;
    wp::int32 var_46;
    const wp::int32 var_47 = 0;
    wp::int32 var_48;
    wp::int32 var_49;
    const wp::int32 var_50 = 6;
    wp::float32 var_51;
    bool var_52;
    const wp::int32 var_53 = 1;
    wp::int32 var_54;
    const wp::int32 var_55 = 0;
    wp::int32 var_56;
    wp::int32 var_57;
    const wp::int32 var_58 = 7;
    wp::float32 var_59;
    bool var_60;
    const wp::int32 var_61 = 1;
    wp::int32 var_62;
    const wp::int32 var_63 = 0;
    wp::int32 var_64;
    wp::int32 var_65;
    //---------
    // forward
    // def bits_within(distances, max_sqdist):                                                <L 1>
    // bits = int(0)                                                                          <L 2>
    var_1 = wp::int(var_0);
    // for j in range(FAN):                                                                   <L 3>
    // bits = bits | (1 << j if distances[j] <= max_sqdist else 0)                            <L 4>
    var_3 = wp::extract(var_distances, var_2);
    var_4 = (var_3 <= var_max_sqdist);
    if (var_4) {
        var_6 = wp::lshift(var_5, var_2);
    }
    if (!var_4) {
    }
    var_8 = wp::where(var_4, var_6, var_7);
    var_9 = wp::bit_or(var_1, var_8);
    var_11 = wp::extract(var_distances, var_10);
    var_12 = (var_11 <= var_max_sqdist);
    if (var_12) {
        var_14 = wp::lshift(var_13, var_10);
    }
    if (!var_12) {
    }
    var_16 = wp::where(var_12, var_14, var_15);
    var_17 = wp::bit_or(var_9, var_16);
    var_19 = wp::extract(var_distances, var_18);
    var_20 = (var_19 <= var_max_sqdist);
    if (var_20) {
        var_22 = wp::lshift(var_21, var_18);
    }
    if (!var_20) {
    }
    var_24 = wp::where(var_20, var_22, var_23);
    var_25 = wp::bit_or(var_17, var_24);
    var_27 = wp::extract(var_distances, var_26);
    var_28 = (var_27 <= var_max_sqdist);
    if (var_28) {
        var_30 = wp::lshift(var_29, var_26);
    }
    if (!var_28) {
    }
    var_32 = wp::where(var_28, var_30, var_31);
    var_33 = wp::bit_or(var_25, var_32);
    var_35 = wp::extract(var_distances, var_34);
    var_36 = (var_35 <= var_max_sqdist);
    if (var_36) {
        var_38 = wp::lshift(var_37, var_34);
    }
    if (!var_36) {
    }
    var_40 = wp::where(var_36, var_38, var_39);
    var_41 = wp::bit_or(var_33, var_40);
    var_43 = wp::extract(var_distances, var_42);
    var_44 = (var_43 <= var_max_sqdist);
    if (var_44) {
        var_46 = wp::lshift(var_45, var_42);
    }
    if (!var_44) {
    }
    var_48 = wp::where(var_44, var_46, var_47);
    var_49 = wp::bit_or(var_41, var_48);
    var_51 = wp::extract(var_distances, var_50);
    var_52 = (var_51 <= var_max_sqdist);
    if (var_52) {
        var_54 = wp::lshift(var_53, var_50);
    }
    if (!var_52) {
    }
    var_56 = wp::where(var_52, var_54, var_55);
    var_57 = wp::bit_or(var_49, var_56);
    var_59 = wp::extract(var_distances, var_58);
    var_60 = (var_59 <= var_max_sqdist);
    if (var_60) {
        var_62 = wp::lshift(var_61, var_58);
    }
    if (!var_60) {
    }
    var_64 = wp::where(var_60, var_62, var_63);
    var_65 = wp::bit_or(var_57, var_64);
    // return bits                                                                            <L 5>
    return var_65;
}


// <pointloom.kernels.segmentation.core_sets.dense_ancestor>:1
static CUDA_CALLABLE wp::int32 dense_ancestor_0(
    wp::int32 var_leaf,
    wp::int32 var_cores__tree__root,
    wp::array_t<wp::int32> var_cores__tree__levels,
    wp::array_t<wp::float32> var_cores__tree__boxes,
    wp::float32 var_cores__max_sqdist)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    const wp::int32 var_2 = 1;
    wp::int32 var_3;
    bool var_4;
    const wp::int32 var_5 = 1;
    bool var_6;
    bool var_7;
    const wp::int32 var_8 = 3;
    const wp::int32 var_9 = 1;
    wp::int32 var_10;
    wp::int32 var_11;
    wp::int32 var_12;
    const wp::int32 var_13 = 2;
    wp::int32 var_14;
    wp::int32 var_15;
    wp::int32 var_16;
    wp::vec_t<8, wp::float32> var_17;
    wp::int32 var_18;
    const wp::int32 var_19 = 8;
    const wp::int32 var_20 = 1;
    wp::int32 var_21;
    wp::int32 var_22;
    wp::int32 var_23;
    const wp::int32 var_24 = 1;
    wp::int32 var_25;
    const wp::int32 var_26 = 1;
    bool var_27;
    const wp::int32 var_28 = 1;
    wp::int32 var_29;
    const wp::int32 var_30 = 0;
    wp::int32 var_31;
    wp::int32 var_32;
    //---------
    // forward
    // def dense_ancestor(leaf, cores__tree__root, cores__tree__levels, cores__tree__boxes, cores__max_sqdist):       <L 1>
    // level = int(0)                                                                         <L 3>
    var_1 = wp::int(var_0);
    // climbing = int(1)                                                                      <L 4>
    var_3 = wp::int(var_2);
    // while climbing == 1 and level < cores__tree__root:                                     <L 5>
    start_while_0:;
    var_6 = (var_3 == var_5);
    var_4 = var_6;
    if (var_4) {
        var_7 = (var_1 < var_cores__tree__root);
        var_4 = var_4 && var_7;
    }
    if ((var_4) == false) goto end_while_0;
        // node = leaf >> FAN_BITS * (level + 1)                                              <L 6>
        var_10 = wp::add(var_1, var_9);
        var_11 = wp::mul(var_8, var_10);
        var_12 = wp::rshift(var_leaf, var_11);
        // record = record_of(cores__tree__levels, level + 2, node >> FAN_BITS)               <L 7>
        var_14 = wp::add(var_1, var_13);
        var_15 = wp::rshift(var_12, var_8);
        var_16 = record_of_0(var_cores__tree__levels, var_14, var_15);
        // dense = bits_within(measure_diagonals(cores__tree__boxes, record), cores__max_sqdist)       <L 8>
        var_17 = measure_diagonals_0(var_cores__tree__boxes, var_16);
        var_18 = bits_within_0(var_17, var_cores__max_sqdist);
        // if dense >> (node & FAN - 1) & 1 == 1:                                             <L 9>
        var_21 = wp::sub(var_19, var_20);
        var_22 = wp::bit_and(var_12, var_21);
        var_23 = wp::rshift(var_18, var_22);
        var_25 = wp::bit_and(var_23, var_24);
        var_27 = (var_25 == var_26);
        if (var_27) {
            // level += 1                                                                     <L 10>
            var_29 = wp::add(var_1, var_28);
        }
        if (!var_27) {
            // climbing = 0                                                                   <L 12>
        }
        var_31 = wp::where(var_27, var_29, var_1);
        var_32 = wp::where(var_27, var_3, var_30);
        wp::assign(var_1, var_31);
        wp::assign(var_3, var_32);
    goto start_while_0;
    end_while_0:;
    // return level                                                                           <L 13>
    return var_1;
}


// /work/main/src/pointloom/kernels/arrays/union_find.py:15
static CUDA_CALLABLE wp::int32 find_root_0(
    wp::array_t<wp::int32> var_parents,
    wp::int32 var_x)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32* var_1;
    wp::int32 var_2;
    wp::int32 var_3;
    bool var_4;
    wp::int32* var_5;
    wp::int32 var_6;
    wp::int32 var_7;
    bool var_8;
    wp::int32 var_9;
    wp::int32* var_10;
    wp::int32 var_11;
    wp::int32 var_12;
    //---------
    // forward
    // def find_root(parents: array(dtype=int32), x: int) -> int:                             <L 16>
    // at = x                                                                                 <L 18>
    var_0 = wp::copy(var_x);
    // up = parents[at]                                                                       <L 19>
    var_1 = wp::address(var_parents, var_0);
    var_3 = wp::load(var_1);
    var_2 = wp::copy(var_3);
    // while up != at:                                                                        <L 20>
    start_while_0:;
    var_4 = (var_2 != var_0);
    if ((var_4) == false) goto end_while_0;
        // above = parents[up]                                                                <L 21>
        var_5 = wp::address(var_parents, var_2);
        var_7 = wp::load(var_5);
        var_6 = wp::copy(var_7);
        // if above != up:                                                                    <L 22>
        var_8 = (var_6 != var_2);
        if (var_8) {
            // parents[at] = above                                                            <L 23>
            wp::array_store(var_parents, var_0, var_6);
        }
        // at = above                                                                         <L 24>
        var_9 = wp::copy(var_6);
        // up = parents[at]                                                                   <L 25>
        var_10 = wp::address(var_parents, var_9);
        var_12 = wp::load(var_10);
        var_11 = wp::copy(var_12);
        wp::assign(var_0, var_9);
        wp::assign(var_2, var_11);
    goto start_while_0;
    end_while_0:;
    // return at                                                                              <L 26>
    return var_0;
}


// /work/main/src/pointloom/kernels/arrays/union_find.py:29
static CUDA_CALLABLE wp::int32 hook_roots_0(
    wp::array_t<wp::int32> var_parents,
    wp::int32 var_x,
    wp::int32 var_y)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32 var_1;
    bool var_2;
    wp::int32 var_3;
    wp::int32 var_4;
    wp::int32 var_5;
    wp::int32 var_6;
    wp::int32 var_7;
    bool var_8;
    wp::int32 var_9;
    wp::int32 var_10;
    wp::int32 var_11;
    wp::int32 var_12;
    //---------
    // forward
    // def hook_roots(parents: array(dtype=int32), x: int, y: int) -> int:                    <L 30>
    // a = x                                                                                  <L 32>
    var_0 = wp::copy(var_x);
    // b = y                                                                                  <L 33>
    var_1 = wp::copy(var_y);
    // while a != b:                                                                          <L 34>
    start_while_0:;
    var_2 = (var_0 != var_1);
    if ((var_2) == false) goto end_while_0;
        // high = max(a, b)                                                                   <L 35>
        var_3 = wp::max(var_0, var_1);
        // low = min(a, b)                                                                    <L 36>
        var_4 = wp::min(var_0, var_1);
        // before = atomic_min(parents, high, low)  # resolves the race: `high` is linked to the lowest candidate       <L 37>
        var_5 = wp::atomic_min(var_parents, var_3, var_4);
        // a = low                                                                            <L 38>
        var_6 = wp::copy(var_4);
        // b = low                                                                            <L 39>
        var_7 = wp::copy(var_4);
        // if before != high:  # another thread was faster: one of the two links was displaced, so they are a new pair       <L 40>
        var_8 = (var_5 != var_3);
        if (var_8) {
            // a = find_root(parents, low)                                                    <L 41>
            var_9 = find_root_0(var_parents, var_4);
            // b = find_root(parents, before)                                                 <L 42>
            var_10 = find_root_0(var_parents, var_5);
        }
        var_11 = wp::where(var_8, var_9, var_6);
        var_12 = wp::where(var_8, var_10, var_7);
        wp::assign(var_0, var_11);
        wp::assign(var_1, var_12);
    goto start_while_0;
    end_while_0:;
    // return a                                                                               <L 43>
    return var_0;
}


// /work/main/src/pointloom/kernels/arrays/union_find.py:46
static CUDA_CALLABLE wp::int32 unite_0(
    wp::array_t<wp::int32> var_parents,
    wp::int32 var_x,
    wp::int32 var_y)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32 var_1;
    wp::int32 var_2;
    //---------
    // forward
    // def unite(parents: array(dtype=int32), x: int, y: int) -> int:                         <L 47>
    // return hook_roots(parents, find_root(parents, x), find_root(parents, y))               <L 49>
    var_0 = find_root_0(var_parents, var_x);
    var_1 = find_root_0(var_parents, var_y);
    var_2 = hook_roots_0(var_parents, var_0, var_1);
    return var_2;
}


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


// <pointloom.kernels.segmentation.core_sets.set_part>:1
static CUDA_CALLABLE wp::int32 set_part_0(
    wp::int32 var_candidates,
    wp::int32 var_head,
    wp::int32 var_core,
    wp::array_t<wp::int32> var_owners)
{
    //---------
    // primal vars
    wp::int32 var_0;
    const wp::int32 var_1 = 1;
    wp::int32 var_2;
    wp::int32 var_3;
    wp::int32 var_4;
    wp::int32 var_5;
    const wp::int32 var_6 = 0;
    bool var_7;
    wp::int32 var_8;
    const wp::int32 var_9 = 1;
    wp::int32 var_10;
    wp::int32 var_11;
    wp::int32 var_12;
    wp::int32 var_13;
    bool var_14;
    const wp::int32 var_15 = 1;
    wp::int32 var_16;
    wp::int32 var_17;
    wp::int32 var_18;
    //---------
    // forward
    // def set_part(candidates, head, core, owners):                                          <L 1>
    // root = find_root(owners, core)                                                         <L 3>
    var_0 = find_root_0(var_owners, var_core);
    // part = 1 << core - head                                                                <L 4>
    var_2 = wp::sub(var_core, var_head);
    var_3 = wp::lshift(var_1, var_2);
    // byte__bits_of__1 = candidates ^ part                                                   <L 5>
    var_4 = wp::bit_xor(var_candidates, var_3);
    // left__bits_of__1 = byte__bits_of__1                                                    <L 6>
    var_5 = wp::copy(var_4);
    // while left__bits_of__1 != 0:                                                           <L 7>
    start_while_0:;
    var_7 = (var_5 != var_6);
    if ((var_7) == false) goto end_while_0;
        // j = lowest_bit(left__bits_of__1)                                                   <L 8>
        var_8 = lowest_bit_0(var_5);
        // left__bits_of__1 = left__bits_of__1 & left__bits_of__1 - 1                         <L 9>
        var_10 = wp::sub(var_5, var_9);
        var_11 = wp::bit_and(var_5, var_10);
        // if find_root(owners, head + j) == root:                                            <L 10>
        var_12 = wp::add(var_head, var_8);
        var_13 = find_root_0(var_owners, var_12);
        var_14 = (var_13 == var_0);
        if (var_14) {
            // part = part | 1 << j                                                           <L 11>
            var_16 = wp::lshift(var_15, var_8);
            var_17 = wp::bit_or(var_3, var_16);
        }
        var_18 = wp::where(var_14, var_17, var_3);
        wp::assign(var_3, var_18);
        wp::assign(var_5, var_11);
    goto start_while_0;
    end_while_0:;
    // return part                                                                            <L 12>
    return var_3;
}


// <pointloom.kernels.search.tree_walk.begin_traversal>:1
static CUDA_CALLABLE wp::vec_t<4, wp::int64> begin_traversal_0(
    wp::int32 var_level,
    wp::int32 var_node)
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
    // def begin_traversal(level, node):                                                      <L 1>
    // return traversal(int64(level), int64(level), int64(node), int64(0))                    <L 3>
    var_0 = wp::int64(var_level);
    var_1 = wp::int64(var_level);
    var_2 = wp::int64(var_node);
    var_3 = 0ll;
    var_4 = wp::vec_t<4, wp::int64>(var_0, var_1, var_2, var_3);
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


// /work/main/src/pointloom/kernels/search/tree_walk.py:40
static CUDA_CALLABLE wp::int64 pending_shift_0(
    wp::int32 var_level)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 1;
    wp::int32 var_1;
    wp::int64 var_2;
    //---------
    // forward
    // def pending_shift(level: int) -> int64:                                                <L 41>
    // return byte_shift(level - 1)                                                           <L 43>
    var_1 = wp::sub(var_level, var_0);
    var_2 = byte_shift_0(var_1);
    return var_2;
}


// <pointloom.kernels.search.tree_walk.next_node>:1
static CUDA_CALLABLE wp::vec_t<4, wp::int64> next_node_0(
    wp::vec_t<4, wp::int64> var_step,
    wp::int32 var_top)
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
    const wp::int32 var_11 = 1;
    wp::int32 var_12;
    const wp::int32 var_13 = 1;
    bool var_14;
    const wp::int32 var_15 = 0;
    wp::int32 var_16;
    const wp::int32 var_17 = 1;
    bool var_18;
    wp::int64 var_19;
    wp::int64 var_20;
    wp::int32 var_21;
    const wp::int32 var_22 = 255;
    wp::int32 var_23;
    wp::int32 var_24;
    const wp::int32 var_25 = 0;
    bool var_26;
    wp::int32 var_27;
    wp::int64 var_28;
    wp::int64 var_29;
    wp::int64 var_30;
    wp::int64 var_31;
    wp::int64 var_32;
    wp::int64 var_33;
    const wp::int32 var_34 = 8;
    wp::int32 var_35;
    wp::int32 var_36;
    const wp::int32 var_37 = 1;
    wp::int32 var_38;
    const wp::int32 var_39 = 0;
    const wp::int32 var_40 = 3;
    wp::int32 var_41;
    const wp::int32 var_42 = 1;
    wp::int32 var_43;
    bool var_44;
    const wp::int32 var_45 = 1;
    wp::int32 var_46;
    const wp::int32 var_47 = 0;
    wp::int32 var_48;
    wp::int32 var_49;
    wp::int32 var_50;
    wp::int32 var_51;
    wp::int32 var_52;
    wp::int64 var_53;
    wp::int32 var_54;
    wp::int64 var_55;
    wp::int64 var_56;
    wp::int64 var_57;
    wp::vec_t<4, wp::int64> var_58;
    //---------
    // forward
    // def next_node(step, top):                                                              <L 1>
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
    // searching = int(1)                                                                     <L 7>
    var_12 = wp::int(var_11);
    // while searching == 1:                                                                  <L 8>
    start_while_0:;
    var_14 = (var_12 == var_13);
    if ((var_14) == false) goto end_while_0;
        // left = int(0)                                                                      <L 9>
        var_16 = wp::int(var_15);
        // if level > 1:                                                                      <L 10>
        var_18 = (var_5 > var_17);
        if (var_18) {
            // left = int(pending >> pending_shift(level)) & BYTE                             <L 11>
            var_19 = pending_shift_0(var_5);
            var_20 = wp::rshift(var_10, var_19);
            var_21 = wp::int(var_20);
            var_23 = wp::bit_and(var_21, var_22);
        }
        var_24 = wp::where(var_18, var_23, var_16);
        // if left != 0:                                                                      <L 12>
        var_26 = (var_24 != var_25);
        if (var_26) {
            // child = lowest_bit(left)                                                       <L 13>
            var_27 = lowest_bit_0(var_24);
            // pending = pending ^ int64(1) << pending_shift(level) + int64(child)            <L 14>
            var_28 = 1ll;
            var_29 = pending_shift_0(var_5);
            var_30 = wp::int64(var_27);
            var_31 = wp::add(var_29, var_30);
            var_32 = wp::lshift(var_28, var_31);
            var_33 = wp::bit_xor(var_10, var_32);
            // node = node * FAN + child                                                      <L 15>
            var_35 = wp::mul(var_8, var_34);
            var_36 = wp::add(var_35, var_27);
            // level = level - 1                                                              <L 16>
            var_38 = wp::sub(var_5, var_37);
            // searching = 0                                                                  <L 17>
        }
        if (!var_26) {
            // node = node >> FAN_BITS                                                        <L 19>
            var_41 = wp::rshift(var_8, var_40);
            // level = level + 1                                                              <L 20>
            var_43 = wp::add(var_5, var_42);
            // if level > height:                                                             <L 21>
            var_44 = (var_43 > var_2);
            if (var_44) {
                // height = height + 1                                                        <L 22>
                var_46 = wp::add(var_2, var_45);
                // searching = 0                                                              <L 23>
            }
            var_48 = wp::where(var_44, var_46, var_2);
            var_49 = wp::where(var_44, var_47, var_12);
        }
        var_50 = wp::where(var_26, var_2, var_48);
        var_51 = wp::where(var_26, var_38, var_43);
        var_52 = wp::where(var_26, var_36, var_41);
        var_53 = wp::where(var_26, var_33, var_10);
        var_54 = wp::where(var_26, var_39, var_49);
        wp::assign(var_2, var_50);
        wp::assign(var_5, var_51);
        wp::assign(var_8, var_52);
        wp::assign(var_10, var_53);
        wp::assign(var_12, var_54);
    goto start_while_0;
    end_while_0:;
    // return traversal(int64(height), int64(level), int64(node), pending)                    <L 24>
    var_55 = wp::int64(var_2);
    var_56 = wp::int64(var_5);
    var_57 = wp::int64(var_8);
    var_58 = wp::vec_t<4, wp::int64>(var_55, var_56, var_57, var_10);
    return var_58;
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


// /work/main/src/pointloom/kernels/search/tree_walk.py:85
static CUDA_CALLABLE wp::int32 own_child_0(
    wp::int32 var_leaf,
    wp::int32 var_level)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 3;
    const wp::int32 var_1 = 1;
    wp::int32 var_2;
    wp::int32 var_3;
    wp::int32 var_4;
    const wp::int32 var_5 = 8;
    const wp::int32 var_6 = 1;
    wp::int32 var_7;
    wp::int32 var_8;
    //---------
    // forward
    // def own_child(leaf: int, level: int) -> int:                                           <L 86>
    // return (leaf >> (FAN_BITS * (level - 1))) & (FAN - 1)                                  <L 88>
    var_2 = wp::sub(var_level, var_1);
    var_3 = wp::mul(var_0, var_2);
    var_4 = wp::rshift(var_leaf, var_3);
    var_7 = wp::sub(var_5, var_6);
    var_8 = wp::bit_and(var_4, var_7);
    return var_8;
}


// /work/main/src/pointloom/kernels/search/tree_walk.py:100
static CUDA_CALLABLE wp::int32 following_children_0(
    wp::int32 var_leaf,
    wp::int32 var_height,
    wp::int32 var_level)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 255;
    wp::int32 var_1;
    bool var_2;
    const wp::int32 var_3 = 2;
    wp::int32 var_4;
    wp::int32 var_5;
    const wp::int32 var_6 = 1;
    wp::int32 var_7;
    wp::int32 var_8;
    wp::int32 var_9;
    //---------
    // forward
    // def following_children(leaf: int, height: int, level: int) -> int:                     <L 101>
    // children = int(BYTE)                                                                   <L 103>
    var_1 = wp::int(var_0);
    // if level == height:                                                                    <L 104>
    var_2 = (var_level == var_height);
    if (var_2) {
        // children = BYTE - ((2 << own_child(leaf, level)) - 1)                              <L 105>
        var_4 = own_child_0(var_leaf, var_level);
        var_5 = wp::lshift(var_3, var_4);
        var_7 = wp::sub(var_5, var_6);
        var_8 = wp::sub(var_0, var_7);
    }
    var_9 = wp::where(var_2, var_8, var_1);
    // return children                                                                        <L 106>
    return var_9;
}


// /work/main/src/pointloom/kernels/search/tree_walk.py:151
static CUDA_CALLABLE wp::vec_t<8, wp::float32> measure_farthest_0(
    wp::array_t<wp::float32> var_boxes,
    wp::int32 var_record,
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
    const wp::int32 var_6 = 3;
    const wp::int32 var_7 = 8;
    wp::int32 var_8;
    wp::int32 var_9;
    wp::float32* var_10;
    const wp::int32 var_11 = 0;
    wp::float32 var_12;
    wp::float32 var_13;
    wp::float32 var_14;
    const wp::int32 var_15 = 0;
    wp::float32 var_16;
    wp::int32 var_17;
    wp::float32* var_18;
    wp::float32 var_19;
    wp::float32 var_20;
    wp::float32 var_21;
    wp::int32 var_22;
    const wp::int32 var_23 = 4;
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
    wp::int32 var_34;
    wp::float32* var_35;
    wp::float32 var_36;
    wp::float32 var_37;
    wp::float32 var_38;
    wp::int32 var_39;
    const wp::int32 var_40 = 5;
    wp::int32 var_41;
    wp::int32 var_42;
    wp::float32* var_43;
    const wp::int32 var_44 = 2;
    wp::float32 var_45;
    wp::float32 var_46;
    wp::float32 var_47;
    const wp::int32 var_48 = 2;
    wp::float32 var_49;
    wp::int32 var_50;
    const wp::int32 var_51 = 2;
    wp::int32 var_52;
    wp::int32 var_53;
    wp::float32* var_54;
    wp::float32 var_55;
    wp::float32 var_56;
    wp::float32 var_57;
    wp::float32 var_58;
    wp::float32 var_59;
    wp::float32 var_60;
    wp::float32 var_61;
    wp::float32 var_62;
    const wp::int32 var_63 = 1;
    wp::int32 var_64;
    const wp::int32 var_65 = 3;
    wp::int32 var_66;
    wp::int32 var_67;
    wp::float32* var_68;
    const wp::int32 var_69 = 0;
    wp::float32 var_70;
    wp::float32 var_71;
    wp::float32 var_72;
    const wp::int32 var_73 = 0;
    wp::float32 var_74;
    wp::int32 var_75;
    wp::float32* var_76;
    wp::float32 var_77;
    wp::float32 var_78;
    wp::float32 var_79;
    wp::int32 var_80;
    const wp::int32 var_81 = 4;
    wp::int32 var_82;
    wp::int32 var_83;
    wp::float32* var_84;
    const wp::int32 var_85 = 1;
    wp::float32 var_86;
    wp::float32 var_87;
    wp::float32 var_88;
    const wp::int32 var_89 = 1;
    wp::float32 var_90;
    wp::int32 var_91;
    wp::int32 var_92;
    wp::float32* var_93;
    wp::float32 var_94;
    wp::float32 var_95;
    wp::float32 var_96;
    wp::int32 var_97;
    const wp::int32 var_98 = 5;
    wp::int32 var_99;
    wp::int32 var_100;
    wp::float32* var_101;
    const wp::int32 var_102 = 2;
    wp::float32 var_103;
    wp::float32 var_104;
    wp::float32 var_105;
    const wp::int32 var_106 = 2;
    wp::float32 var_107;
    wp::int32 var_108;
    const wp::int32 var_109 = 2;
    wp::int32 var_110;
    wp::int32 var_111;
    wp::float32* var_112;
    wp::float32 var_113;
    wp::float32 var_114;
    wp::float32 var_115;
    wp::float32 var_116;
    wp::float32 var_117;
    wp::float32 var_118;
    wp::float32 var_119;
    wp::float32 var_120;
    const wp::int32 var_121 = 2;
    wp::int32 var_122;
    const wp::int32 var_123 = 3;
    wp::int32 var_124;
    wp::int32 var_125;
    wp::float32* var_126;
    const wp::int32 var_127 = 0;
    wp::float32 var_128;
    wp::float32 var_129;
    wp::float32 var_130;
    const wp::int32 var_131 = 0;
    wp::float32 var_132;
    wp::int32 var_133;
    wp::float32* var_134;
    wp::float32 var_135;
    wp::float32 var_136;
    wp::float32 var_137;
    wp::int32 var_138;
    const wp::int32 var_139 = 4;
    wp::int32 var_140;
    wp::int32 var_141;
    wp::float32* var_142;
    const wp::int32 var_143 = 1;
    wp::float32 var_144;
    wp::float32 var_145;
    wp::float32 var_146;
    const wp::int32 var_147 = 1;
    wp::float32 var_148;
    wp::int32 var_149;
    wp::int32 var_150;
    wp::float32* var_151;
    wp::float32 var_152;
    wp::float32 var_153;
    wp::float32 var_154;
    wp::int32 var_155;
    const wp::int32 var_156 = 5;
    wp::int32 var_157;
    wp::int32 var_158;
    wp::float32* var_159;
    const wp::int32 var_160 = 2;
    wp::float32 var_161;
    wp::float32 var_162;
    wp::float32 var_163;
    const wp::int32 var_164 = 2;
    wp::float32 var_165;
    wp::int32 var_166;
    const wp::int32 var_167 = 2;
    wp::int32 var_168;
    wp::int32 var_169;
    wp::float32* var_170;
    wp::float32 var_171;
    wp::float32 var_172;
    wp::float32 var_173;
    wp::float32 var_174;
    wp::float32 var_175;
    wp::float32 var_176;
    wp::float32 var_177;
    wp::float32 var_178;
    const wp::int32 var_179 = 3;
    wp::int32 var_180;
    const wp::int32 var_181 = 3;
    wp::int32 var_182;
    wp::int32 var_183;
    wp::float32* var_184;
    const wp::int32 var_185 = 0;
    wp::float32 var_186;
    wp::float32 var_187;
    wp::float32 var_188;
    const wp::int32 var_189 = 0;
    wp::float32 var_190;
    wp::int32 var_191;
    wp::float32* var_192;
    wp::float32 var_193;
    wp::float32 var_194;
    wp::float32 var_195;
    wp::int32 var_196;
    const wp::int32 var_197 = 4;
    wp::int32 var_198;
    wp::int32 var_199;
    wp::float32* var_200;
    const wp::int32 var_201 = 1;
    wp::float32 var_202;
    wp::float32 var_203;
    wp::float32 var_204;
    const wp::int32 var_205 = 1;
    wp::float32 var_206;
    wp::int32 var_207;
    wp::int32 var_208;
    wp::float32* var_209;
    wp::float32 var_210;
    wp::float32 var_211;
    wp::float32 var_212;
    wp::int32 var_213;
    const wp::int32 var_214 = 5;
    wp::int32 var_215;
    wp::int32 var_216;
    wp::float32* var_217;
    const wp::int32 var_218 = 2;
    wp::float32 var_219;
    wp::float32 var_220;
    wp::float32 var_221;
    const wp::int32 var_222 = 2;
    wp::float32 var_223;
    wp::int32 var_224;
    const wp::int32 var_225 = 2;
    wp::int32 var_226;
    wp::int32 var_227;
    wp::float32* var_228;
    wp::float32 var_229;
    wp::float32 var_230;
    wp::float32 var_231;
    wp::float32 var_232;
    wp::float32 var_233;
    wp::float32 var_234;
    wp::float32 var_235;
    wp::float32 var_236;
    const wp::int32 var_237 = 4;
    wp::int32 var_238;
    const wp::int32 var_239 = 3;
    wp::int32 var_240;
    wp::int32 var_241;
    wp::float32* var_242;
    const wp::int32 var_243 = 0;
    wp::float32 var_244;
    wp::float32 var_245;
    wp::float32 var_246;
    const wp::int32 var_247 = 0;
    wp::float32 var_248;
    wp::int32 var_249;
    wp::float32* var_250;
    wp::float32 var_251;
    wp::float32 var_252;
    wp::float32 var_253;
    wp::int32 var_254;
    const wp::int32 var_255 = 4;
    wp::int32 var_256;
    wp::int32 var_257;
    wp::float32* var_258;
    const wp::int32 var_259 = 1;
    wp::float32 var_260;
    wp::float32 var_261;
    wp::float32 var_262;
    const wp::int32 var_263 = 1;
    wp::float32 var_264;
    wp::int32 var_265;
    wp::int32 var_266;
    wp::float32* var_267;
    wp::float32 var_268;
    wp::float32 var_269;
    wp::float32 var_270;
    wp::int32 var_271;
    const wp::int32 var_272 = 5;
    wp::int32 var_273;
    wp::int32 var_274;
    wp::float32* var_275;
    const wp::int32 var_276 = 2;
    wp::float32 var_277;
    wp::float32 var_278;
    wp::float32 var_279;
    const wp::int32 var_280 = 2;
    wp::float32 var_281;
    wp::int32 var_282;
    const wp::int32 var_283 = 2;
    wp::int32 var_284;
    wp::int32 var_285;
    wp::float32* var_286;
    wp::float32 var_287;
    wp::float32 var_288;
    wp::float32 var_289;
    wp::float32 var_290;
    wp::float32 var_291;
    wp::float32 var_292;
    wp::float32 var_293;
    wp::float32 var_294;
    const wp::int32 var_295 = 5;
    wp::int32 var_296;
    const wp::int32 var_297 = 3;
    wp::int32 var_298;
    wp::int32 var_299;
    wp::float32* var_300;
    const wp::int32 var_301 = 0;
    wp::float32 var_302;
    wp::float32 var_303;
    wp::float32 var_304;
    const wp::int32 var_305 = 0;
    wp::float32 var_306;
    wp::int32 var_307;
    wp::float32* var_308;
    wp::float32 var_309;
    wp::float32 var_310;
    wp::float32 var_311;
    wp::int32 var_312;
    const wp::int32 var_313 = 4;
    wp::int32 var_314;
    wp::int32 var_315;
    wp::float32* var_316;
    const wp::int32 var_317 = 1;
    wp::float32 var_318;
    wp::float32 var_319;
    wp::float32 var_320;
    const wp::int32 var_321 = 1;
    wp::float32 var_322;
    wp::int32 var_323;
    wp::int32 var_324;
    wp::float32* var_325;
    wp::float32 var_326;
    wp::float32 var_327;
    wp::float32 var_328;
    wp::int32 var_329;
    const wp::int32 var_330 = 5;
    wp::int32 var_331;
    wp::int32 var_332;
    wp::float32* var_333;
    const wp::int32 var_334 = 2;
    wp::float32 var_335;
    wp::float32 var_336;
    wp::float32 var_337;
    const wp::int32 var_338 = 2;
    wp::float32 var_339;
    wp::int32 var_340;
    const wp::int32 var_341 = 2;
    wp::int32 var_342;
    wp::int32 var_343;
    wp::float32* var_344;
    wp::float32 var_345;
    wp::float32 var_346;
    wp::float32 var_347;
    wp::float32 var_348;
    wp::float32 var_349;
    wp::float32 var_350;
    wp::float32 var_351;
    wp::float32 var_352;
    const wp::int32 var_353 = 6;
    wp::int32 var_354;
    const wp::int32 var_355 = 3;
    wp::int32 var_356;
    wp::int32 var_357;
    wp::float32* var_358;
    const wp::int32 var_359 = 0;
    wp::float32 var_360;
    wp::float32 var_361;
    wp::float32 var_362;
    const wp::int32 var_363 = 0;
    wp::float32 var_364;
    wp::int32 var_365;
    wp::float32* var_366;
    wp::float32 var_367;
    wp::float32 var_368;
    wp::float32 var_369;
    wp::int32 var_370;
    const wp::int32 var_371 = 4;
    wp::int32 var_372;
    wp::int32 var_373;
    wp::float32* var_374;
    const wp::int32 var_375 = 1;
    wp::float32 var_376;
    wp::float32 var_377;
    wp::float32 var_378;
    const wp::int32 var_379 = 1;
    wp::float32 var_380;
    wp::int32 var_381;
    wp::int32 var_382;
    wp::float32* var_383;
    wp::float32 var_384;
    wp::float32 var_385;
    wp::float32 var_386;
    wp::int32 var_387;
    const wp::int32 var_388 = 5;
    wp::int32 var_389;
    wp::int32 var_390;
    wp::float32* var_391;
    const wp::int32 var_392 = 2;
    wp::float32 var_393;
    wp::float32 var_394;
    wp::float32 var_395;
    const wp::int32 var_396 = 2;
    wp::float32 var_397;
    wp::int32 var_398;
    const wp::int32 var_399 = 2;
    wp::int32 var_400;
    wp::int32 var_401;
    wp::float32* var_402;
    wp::float32 var_403;
    wp::float32 var_404;
    wp::float32 var_405;
    wp::float32 var_406;
    wp::float32 var_407;
    wp::float32 var_408;
    wp::float32 var_409;
    wp::float32 var_410;
    const wp::int32 var_411 = 7;
    wp::int32 var_412;
    const wp::int32 var_413 = 3;
    wp::int32 var_414;
    wp::int32 var_415;
    wp::float32* var_416;
    const wp::int32 var_417 = 0;
    wp::float32 var_418;
    wp::float32 var_419;
    wp::float32 var_420;
    const wp::int32 var_421 = 0;
    wp::float32 var_422;
    wp::int32 var_423;
    wp::float32* var_424;
    wp::float32 var_425;
    wp::float32 var_426;
    wp::float32 var_427;
    wp::int32 var_428;
    const wp::int32 var_429 = 4;
    wp::int32 var_430;
    wp::int32 var_431;
    wp::float32* var_432;
    const wp::int32 var_433 = 1;
    wp::float32 var_434;
    wp::float32 var_435;
    wp::float32 var_436;
    const wp::int32 var_437 = 1;
    wp::float32 var_438;
    wp::int32 var_439;
    wp::int32 var_440;
    wp::float32* var_441;
    wp::float32 var_442;
    wp::float32 var_443;
    wp::float32 var_444;
    wp::int32 var_445;
    const wp::int32 var_446 = 5;
    wp::int32 var_447;
    wp::int32 var_448;
    wp::float32* var_449;
    const wp::int32 var_450 = 2;
    wp::float32 var_451;
    wp::float32 var_452;
    wp::float32 var_453;
    const wp::int32 var_454 = 2;
    wp::float32 var_455;
    wp::int32 var_456;
    const wp::int32 var_457 = 2;
    wp::int32 var_458;
    wp::int32 var_459;
    wp::float32* var_460;
    wp::float32 var_461;
    wp::float32 var_462;
    wp::float32 var_463;
    wp::float32 var_464;
    wp::float32 var_465;
    wp::float32 var_466;
    wp::float32 var_467;
    wp::float32 var_468;
    //---------
    // forward
    // def measure_farthest(boxes: array(dtype=float32), record: int, a: vec3, b: vec3) -> box_distances:       <L 152>
    // at = record * SIDES                                                                    <L 154>
    var_1 = wp::mul(var_record, var_0);
    // distances = box_distances(0.0)                                                         <L 155>
    var_3 = wp::vec_t<8, wp::float32>(var_2);
    // for j in range(FAN):                                                                   <L 156>
    // x = larger(boxes[at + j + 3 * FAN] - a[0], b[0] - boxes[at + j])                       <L 157>
    var_5 = wp::add(var_1, var_4);
    var_8 = wp::mul(var_6, var_7);
    var_9 = wp::add(var_5, var_8);
    var_10 = wp::address(var_boxes, var_9);
    var_12 = wp::extract(var_a, var_11);
    var_14 = wp::load(var_10);
    var_13 = wp::sub(var_14, var_12);
    var_16 = wp::extract(var_b, var_15);
    var_17 = wp::add(var_1, var_4);
    var_18 = wp::address(var_boxes, var_17);
    var_20 = wp::load(var_18);
    var_19 = wp::sub(var_16, var_20);
    var_21 = larger_0(var_13, var_19);
    // y = larger(boxes[at + j + 4 * FAN] - a[1], b[1] - boxes[at + j + FAN])                 <L 158>
    var_22 = wp::add(var_1, var_4);
    var_24 = wp::mul(var_23, var_7);
    var_25 = wp::add(var_22, var_24);
    var_26 = wp::address(var_boxes, var_25);
    var_28 = wp::extract(var_a, var_27);
    var_30 = wp::load(var_26);
    var_29 = wp::sub(var_30, var_28);
    var_32 = wp::extract(var_b, var_31);
    var_33 = wp::add(var_1, var_4);
    var_34 = wp::add(var_33, var_7);
    var_35 = wp::address(var_boxes, var_34);
    var_37 = wp::load(var_35);
    var_36 = wp::sub(var_32, var_37);
    var_38 = larger_0(var_29, var_36);
    // z = larger(boxes[at + j + 5 * FAN] - a[2], b[2] - boxes[at + j + 2 * FAN])             <L 159>
    var_39 = wp::add(var_1, var_4);
    var_41 = wp::mul(var_40, var_7);
    var_42 = wp::add(var_39, var_41);
    var_43 = wp::address(var_boxes, var_42);
    var_45 = wp::extract(var_a, var_44);
    var_47 = wp::load(var_43);
    var_46 = wp::sub(var_47, var_45);
    var_49 = wp::extract(var_b, var_48);
    var_50 = wp::add(var_1, var_4);
    var_52 = wp::mul(var_51, var_7);
    var_53 = wp::add(var_50, var_52);
    var_54 = wp::address(var_boxes, var_53);
    var_56 = wp::load(var_54);
    var_55 = wp::sub(var_49, var_56);
    var_57 = larger_0(var_46, var_55);
    // distances[j] = x * x + y * y + z * z                                                   <L 160>
    var_58 = wp::mul(var_21, var_21);
    var_59 = wp::mul(var_38, var_38);
    var_60 = wp::add(var_58, var_59);
    var_61 = wp::mul(var_57, var_57);
    var_62 = wp::add(var_60, var_61);
    wp::assign_inplace(var_3, var_4, var_62);
    // x = larger(boxes[at + j + 3 * FAN] - a[0], b[0] - boxes[at + j])                       <L 157>
    var_64 = wp::add(var_1, var_63);
    var_66 = wp::mul(var_65, var_7);
    var_67 = wp::add(var_64, var_66);
    var_68 = wp::address(var_boxes, var_67);
    var_70 = wp::extract(var_a, var_69);
    var_72 = wp::load(var_68);
    var_71 = wp::sub(var_72, var_70);
    var_74 = wp::extract(var_b, var_73);
    var_75 = wp::add(var_1, var_63);
    var_76 = wp::address(var_boxes, var_75);
    var_78 = wp::load(var_76);
    var_77 = wp::sub(var_74, var_78);
    var_79 = larger_0(var_71, var_77);
    // y = larger(boxes[at + j + 4 * FAN] - a[1], b[1] - boxes[at + j + FAN])                 <L 158>
    var_80 = wp::add(var_1, var_63);
    var_82 = wp::mul(var_81, var_7);
    var_83 = wp::add(var_80, var_82);
    var_84 = wp::address(var_boxes, var_83);
    var_86 = wp::extract(var_a, var_85);
    var_88 = wp::load(var_84);
    var_87 = wp::sub(var_88, var_86);
    var_90 = wp::extract(var_b, var_89);
    var_91 = wp::add(var_1, var_63);
    var_92 = wp::add(var_91, var_7);
    var_93 = wp::address(var_boxes, var_92);
    var_95 = wp::load(var_93);
    var_94 = wp::sub(var_90, var_95);
    var_96 = larger_0(var_87, var_94);
    // z = larger(boxes[at + j + 5 * FAN] - a[2], b[2] - boxes[at + j + 2 * FAN])             <L 159>
    var_97 = wp::add(var_1, var_63);
    var_99 = wp::mul(var_98, var_7);
    var_100 = wp::add(var_97, var_99);
    var_101 = wp::address(var_boxes, var_100);
    var_103 = wp::extract(var_a, var_102);
    var_105 = wp::load(var_101);
    var_104 = wp::sub(var_105, var_103);
    var_107 = wp::extract(var_b, var_106);
    var_108 = wp::add(var_1, var_63);
    var_110 = wp::mul(var_109, var_7);
    var_111 = wp::add(var_108, var_110);
    var_112 = wp::address(var_boxes, var_111);
    var_114 = wp::load(var_112);
    var_113 = wp::sub(var_107, var_114);
    var_115 = larger_0(var_104, var_113);
    // distances[j] = x * x + y * y + z * z                                                   <L 160>
    var_116 = wp::mul(var_79, var_79);
    var_117 = wp::mul(var_96, var_96);
    var_118 = wp::add(var_116, var_117);
    var_119 = wp::mul(var_115, var_115);
    var_120 = wp::add(var_118, var_119);
    wp::assign_inplace(var_3, var_63, var_120);
    // x = larger(boxes[at + j + 3 * FAN] - a[0], b[0] - boxes[at + j])                       <L 157>
    var_122 = wp::add(var_1, var_121);
    var_124 = wp::mul(var_123, var_7);
    var_125 = wp::add(var_122, var_124);
    var_126 = wp::address(var_boxes, var_125);
    var_128 = wp::extract(var_a, var_127);
    var_130 = wp::load(var_126);
    var_129 = wp::sub(var_130, var_128);
    var_132 = wp::extract(var_b, var_131);
    var_133 = wp::add(var_1, var_121);
    var_134 = wp::address(var_boxes, var_133);
    var_136 = wp::load(var_134);
    var_135 = wp::sub(var_132, var_136);
    var_137 = larger_0(var_129, var_135);
    // y = larger(boxes[at + j + 4 * FAN] - a[1], b[1] - boxes[at + j + FAN])                 <L 158>
    var_138 = wp::add(var_1, var_121);
    var_140 = wp::mul(var_139, var_7);
    var_141 = wp::add(var_138, var_140);
    var_142 = wp::address(var_boxes, var_141);
    var_144 = wp::extract(var_a, var_143);
    var_146 = wp::load(var_142);
    var_145 = wp::sub(var_146, var_144);
    var_148 = wp::extract(var_b, var_147);
    var_149 = wp::add(var_1, var_121);
    var_150 = wp::add(var_149, var_7);
    var_151 = wp::address(var_boxes, var_150);
    var_153 = wp::load(var_151);
    var_152 = wp::sub(var_148, var_153);
    var_154 = larger_0(var_145, var_152);
    // z = larger(boxes[at + j + 5 * FAN] - a[2], b[2] - boxes[at + j + 2 * FAN])             <L 159>
    var_155 = wp::add(var_1, var_121);
    var_157 = wp::mul(var_156, var_7);
    var_158 = wp::add(var_155, var_157);
    var_159 = wp::address(var_boxes, var_158);
    var_161 = wp::extract(var_a, var_160);
    var_163 = wp::load(var_159);
    var_162 = wp::sub(var_163, var_161);
    var_165 = wp::extract(var_b, var_164);
    var_166 = wp::add(var_1, var_121);
    var_168 = wp::mul(var_167, var_7);
    var_169 = wp::add(var_166, var_168);
    var_170 = wp::address(var_boxes, var_169);
    var_172 = wp::load(var_170);
    var_171 = wp::sub(var_165, var_172);
    var_173 = larger_0(var_162, var_171);
    // distances[j] = x * x + y * y + z * z                                                   <L 160>
    var_174 = wp::mul(var_137, var_137);
    var_175 = wp::mul(var_154, var_154);
    var_176 = wp::add(var_174, var_175);
    var_177 = wp::mul(var_173, var_173);
    var_178 = wp::add(var_176, var_177);
    wp::assign_inplace(var_3, var_121, var_178);
    // x = larger(boxes[at + j + 3 * FAN] - a[0], b[0] - boxes[at + j])                       <L 157>
    var_180 = wp::add(var_1, var_179);
    var_182 = wp::mul(var_181, var_7);
    var_183 = wp::add(var_180, var_182);
    var_184 = wp::address(var_boxes, var_183);
    var_186 = wp::extract(var_a, var_185);
    var_188 = wp::load(var_184);
    var_187 = wp::sub(var_188, var_186);
    var_190 = wp::extract(var_b, var_189);
    var_191 = wp::add(var_1, var_179);
    var_192 = wp::address(var_boxes, var_191);
    var_194 = wp::load(var_192);
    var_193 = wp::sub(var_190, var_194);
    var_195 = larger_0(var_187, var_193);
    // y = larger(boxes[at + j + 4 * FAN] - a[1], b[1] - boxes[at + j + FAN])                 <L 158>
    var_196 = wp::add(var_1, var_179);
    var_198 = wp::mul(var_197, var_7);
    var_199 = wp::add(var_196, var_198);
    var_200 = wp::address(var_boxes, var_199);
    var_202 = wp::extract(var_a, var_201);
    var_204 = wp::load(var_200);
    var_203 = wp::sub(var_204, var_202);
    var_206 = wp::extract(var_b, var_205);
    var_207 = wp::add(var_1, var_179);
    var_208 = wp::add(var_207, var_7);
    var_209 = wp::address(var_boxes, var_208);
    var_211 = wp::load(var_209);
    var_210 = wp::sub(var_206, var_211);
    var_212 = larger_0(var_203, var_210);
    // z = larger(boxes[at + j + 5 * FAN] - a[2], b[2] - boxes[at + j + 2 * FAN])             <L 159>
    var_213 = wp::add(var_1, var_179);
    var_215 = wp::mul(var_214, var_7);
    var_216 = wp::add(var_213, var_215);
    var_217 = wp::address(var_boxes, var_216);
    var_219 = wp::extract(var_a, var_218);
    var_221 = wp::load(var_217);
    var_220 = wp::sub(var_221, var_219);
    var_223 = wp::extract(var_b, var_222);
    var_224 = wp::add(var_1, var_179);
    var_226 = wp::mul(var_225, var_7);
    var_227 = wp::add(var_224, var_226);
    var_228 = wp::address(var_boxes, var_227);
    var_230 = wp::load(var_228);
    var_229 = wp::sub(var_223, var_230);
    var_231 = larger_0(var_220, var_229);
    // distances[j] = x * x + y * y + z * z                                                   <L 160>
    var_232 = wp::mul(var_195, var_195);
    var_233 = wp::mul(var_212, var_212);
    var_234 = wp::add(var_232, var_233);
    var_235 = wp::mul(var_231, var_231);
    var_236 = wp::add(var_234, var_235);
    wp::assign_inplace(var_3, var_179, var_236);
    // x = larger(boxes[at + j + 3 * FAN] - a[0], b[0] - boxes[at + j])                       <L 157>
    var_238 = wp::add(var_1, var_237);
    var_240 = wp::mul(var_239, var_7);
    var_241 = wp::add(var_238, var_240);
    var_242 = wp::address(var_boxes, var_241);
    var_244 = wp::extract(var_a, var_243);
    var_246 = wp::load(var_242);
    var_245 = wp::sub(var_246, var_244);
    var_248 = wp::extract(var_b, var_247);
    var_249 = wp::add(var_1, var_237);
    var_250 = wp::address(var_boxes, var_249);
    var_252 = wp::load(var_250);
    var_251 = wp::sub(var_248, var_252);
    var_253 = larger_0(var_245, var_251);
    // y = larger(boxes[at + j + 4 * FAN] - a[1], b[1] - boxes[at + j + FAN])                 <L 158>
    var_254 = wp::add(var_1, var_237);
    var_256 = wp::mul(var_255, var_7);
    var_257 = wp::add(var_254, var_256);
    var_258 = wp::address(var_boxes, var_257);
    var_260 = wp::extract(var_a, var_259);
    var_262 = wp::load(var_258);
    var_261 = wp::sub(var_262, var_260);
    var_264 = wp::extract(var_b, var_263);
    var_265 = wp::add(var_1, var_237);
    var_266 = wp::add(var_265, var_7);
    var_267 = wp::address(var_boxes, var_266);
    var_269 = wp::load(var_267);
    var_268 = wp::sub(var_264, var_269);
    var_270 = larger_0(var_261, var_268);
    // z = larger(boxes[at + j + 5 * FAN] - a[2], b[2] - boxes[at + j + 2 * FAN])             <L 159>
    var_271 = wp::add(var_1, var_237);
    var_273 = wp::mul(var_272, var_7);
    var_274 = wp::add(var_271, var_273);
    var_275 = wp::address(var_boxes, var_274);
    var_277 = wp::extract(var_a, var_276);
    var_279 = wp::load(var_275);
    var_278 = wp::sub(var_279, var_277);
    var_281 = wp::extract(var_b, var_280);
    var_282 = wp::add(var_1, var_237);
    var_284 = wp::mul(var_283, var_7);
    var_285 = wp::add(var_282, var_284);
    var_286 = wp::address(var_boxes, var_285);
    var_288 = wp::load(var_286);
    var_287 = wp::sub(var_281, var_288);
    var_289 = larger_0(var_278, var_287);
    // distances[j] = x * x + y * y + z * z                                                   <L 160>
    var_290 = wp::mul(var_253, var_253);
    var_291 = wp::mul(var_270, var_270);
    var_292 = wp::add(var_290, var_291);
    var_293 = wp::mul(var_289, var_289);
    var_294 = wp::add(var_292, var_293);
    wp::assign_inplace(var_3, var_237, var_294);
    // x = larger(boxes[at + j + 3 * FAN] - a[0], b[0] - boxes[at + j])                       <L 157>
    var_296 = wp::add(var_1, var_295);
    var_298 = wp::mul(var_297, var_7);
    var_299 = wp::add(var_296, var_298);
    var_300 = wp::address(var_boxes, var_299);
    var_302 = wp::extract(var_a, var_301);
    var_304 = wp::load(var_300);
    var_303 = wp::sub(var_304, var_302);
    var_306 = wp::extract(var_b, var_305);
    var_307 = wp::add(var_1, var_295);
    var_308 = wp::address(var_boxes, var_307);
    var_310 = wp::load(var_308);
    var_309 = wp::sub(var_306, var_310);
    var_311 = larger_0(var_303, var_309);
    // y = larger(boxes[at + j + 4 * FAN] - a[1], b[1] - boxes[at + j + FAN])                 <L 158>
    var_312 = wp::add(var_1, var_295);
    var_314 = wp::mul(var_313, var_7);
    var_315 = wp::add(var_312, var_314);
    var_316 = wp::address(var_boxes, var_315);
    var_318 = wp::extract(var_a, var_317);
    var_320 = wp::load(var_316);
    var_319 = wp::sub(var_320, var_318);
    var_322 = wp::extract(var_b, var_321);
    var_323 = wp::add(var_1, var_295);
    var_324 = wp::add(var_323, var_7);
    var_325 = wp::address(var_boxes, var_324);
    var_327 = wp::load(var_325);
    var_326 = wp::sub(var_322, var_327);
    var_328 = larger_0(var_319, var_326);
    // z = larger(boxes[at + j + 5 * FAN] - a[2], b[2] - boxes[at + j + 2 * FAN])             <L 159>
    var_329 = wp::add(var_1, var_295);
    var_331 = wp::mul(var_330, var_7);
    var_332 = wp::add(var_329, var_331);
    var_333 = wp::address(var_boxes, var_332);
    var_335 = wp::extract(var_a, var_334);
    var_337 = wp::load(var_333);
    var_336 = wp::sub(var_337, var_335);
    var_339 = wp::extract(var_b, var_338);
    var_340 = wp::add(var_1, var_295);
    var_342 = wp::mul(var_341, var_7);
    var_343 = wp::add(var_340, var_342);
    var_344 = wp::address(var_boxes, var_343);
    var_346 = wp::load(var_344);
    var_345 = wp::sub(var_339, var_346);
    var_347 = larger_0(var_336, var_345);
    // distances[j] = x * x + y * y + z * z                                                   <L 160>
    var_348 = wp::mul(var_311, var_311);
    var_349 = wp::mul(var_328, var_328);
    var_350 = wp::add(var_348, var_349);
    var_351 = wp::mul(var_347, var_347);
    var_352 = wp::add(var_350, var_351);
    wp::assign_inplace(var_3, var_295, var_352);
    // x = larger(boxes[at + j + 3 * FAN] - a[0], b[0] - boxes[at + j])                       <L 157>
    var_354 = wp::add(var_1, var_353);
    var_356 = wp::mul(var_355, var_7);
    var_357 = wp::add(var_354, var_356);
    var_358 = wp::address(var_boxes, var_357);
    var_360 = wp::extract(var_a, var_359);
    var_362 = wp::load(var_358);
    var_361 = wp::sub(var_362, var_360);
    var_364 = wp::extract(var_b, var_363);
    var_365 = wp::add(var_1, var_353);
    var_366 = wp::address(var_boxes, var_365);
    var_368 = wp::load(var_366);
    var_367 = wp::sub(var_364, var_368);
    var_369 = larger_0(var_361, var_367);
    // y = larger(boxes[at + j + 4 * FAN] - a[1], b[1] - boxes[at + j + FAN])                 <L 158>
    var_370 = wp::add(var_1, var_353);
    var_372 = wp::mul(var_371, var_7);
    var_373 = wp::add(var_370, var_372);
    var_374 = wp::address(var_boxes, var_373);
    var_376 = wp::extract(var_a, var_375);
    var_378 = wp::load(var_374);
    var_377 = wp::sub(var_378, var_376);
    var_380 = wp::extract(var_b, var_379);
    var_381 = wp::add(var_1, var_353);
    var_382 = wp::add(var_381, var_7);
    var_383 = wp::address(var_boxes, var_382);
    var_385 = wp::load(var_383);
    var_384 = wp::sub(var_380, var_385);
    var_386 = larger_0(var_377, var_384);
    // z = larger(boxes[at + j + 5 * FAN] - a[2], b[2] - boxes[at + j + 2 * FAN])             <L 159>
    var_387 = wp::add(var_1, var_353);
    var_389 = wp::mul(var_388, var_7);
    var_390 = wp::add(var_387, var_389);
    var_391 = wp::address(var_boxes, var_390);
    var_393 = wp::extract(var_a, var_392);
    var_395 = wp::load(var_391);
    var_394 = wp::sub(var_395, var_393);
    var_397 = wp::extract(var_b, var_396);
    var_398 = wp::add(var_1, var_353);
    var_400 = wp::mul(var_399, var_7);
    var_401 = wp::add(var_398, var_400);
    var_402 = wp::address(var_boxes, var_401);
    var_404 = wp::load(var_402);
    var_403 = wp::sub(var_397, var_404);
    var_405 = larger_0(var_394, var_403);
    // distances[j] = x * x + y * y + z * z                                                   <L 160>
    var_406 = wp::mul(var_369, var_369);
    var_407 = wp::mul(var_386, var_386);
    var_408 = wp::add(var_406, var_407);
    var_409 = wp::mul(var_405, var_405);
    var_410 = wp::add(var_408, var_409);
    wp::assign_inplace(var_3, var_353, var_410);
    // x = larger(boxes[at + j + 3 * FAN] - a[0], b[0] - boxes[at + j])                       <L 157>
    var_412 = wp::add(var_1, var_411);
    var_414 = wp::mul(var_413, var_7);
    var_415 = wp::add(var_412, var_414);
    var_416 = wp::address(var_boxes, var_415);
    var_418 = wp::extract(var_a, var_417);
    var_420 = wp::load(var_416);
    var_419 = wp::sub(var_420, var_418);
    var_422 = wp::extract(var_b, var_421);
    var_423 = wp::add(var_1, var_411);
    var_424 = wp::address(var_boxes, var_423);
    var_426 = wp::load(var_424);
    var_425 = wp::sub(var_422, var_426);
    var_427 = larger_0(var_419, var_425);
    // y = larger(boxes[at + j + 4 * FAN] - a[1], b[1] - boxes[at + j + FAN])                 <L 158>
    var_428 = wp::add(var_1, var_411);
    var_430 = wp::mul(var_429, var_7);
    var_431 = wp::add(var_428, var_430);
    var_432 = wp::address(var_boxes, var_431);
    var_434 = wp::extract(var_a, var_433);
    var_436 = wp::load(var_432);
    var_435 = wp::sub(var_436, var_434);
    var_438 = wp::extract(var_b, var_437);
    var_439 = wp::add(var_1, var_411);
    var_440 = wp::add(var_439, var_7);
    var_441 = wp::address(var_boxes, var_440);
    var_443 = wp::load(var_441);
    var_442 = wp::sub(var_438, var_443);
    var_444 = larger_0(var_435, var_442);
    // z = larger(boxes[at + j + 5 * FAN] - a[2], b[2] - boxes[at + j + 2 * FAN])             <L 159>
    var_445 = wp::add(var_1, var_411);
    var_447 = wp::mul(var_446, var_7);
    var_448 = wp::add(var_445, var_447);
    var_449 = wp::address(var_boxes, var_448);
    var_451 = wp::extract(var_a, var_450);
    var_453 = wp::load(var_449);
    var_452 = wp::sub(var_453, var_451);
    var_455 = wp::extract(var_b, var_454);
    var_456 = wp::add(var_1, var_411);
    var_458 = wp::mul(var_457, var_7);
    var_459 = wp::add(var_456, var_458);
    var_460 = wp::address(var_boxes, var_459);
    var_462 = wp::load(var_460);
    var_461 = wp::sub(var_455, var_462);
    var_463 = larger_0(var_452, var_461);
    // distances[j] = x * x + y * y + z * z                                                   <L 160>
    var_464 = wp::mul(var_427, var_427);
    var_465 = wp::mul(var_444, var_444);
    var_466 = wp::add(var_464, var_465);
    var_467 = wp::mul(var_463, var_463);
    var_468 = wp::add(var_466, var_467);
    wp::assign_inplace(var_3, var_411, var_468);
    // return distances                                                                       <L 161>
    return var_3;
}


// <pointloom.kernels.segmentation.core_sets.sift_dense>:1
static CUDA_CALLABLE wp::int32 sift_dense_0(
    wp::int32 var_children,
    wp::int32 var_core,
    wp::int32 var_record,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::array_t<wp::float32> var_cores__tree__boxes,
    wp::float32 var_cores__max_sqdist,
    wp::array_t<wp::int32> var_cores__owners,
    wp::array_t<wp::int32> var_cores__lowest)
{
    //---------
    // primal vars
    wp::vec_t<8, wp::float32> var_0;
    wp::int32 var_1;
    wp::vec_t<8, wp::float32> var_2;
    wp::int32 var_3;
    wp::int32 var_4;
    const wp::int32 var_5 = 0;
    wp::int32 var_6;
    wp::int32 var_7;
    const wp::int32 var_8 = 0;
    bool var_9;
    wp::int32 var_10;
    const wp::int32 var_11 = 1;
    wp::int32 var_12;
    wp::int32 var_13;
    const wp::int32 var_14 = 8;
    wp::int32 var_15;
    wp::int32 var_16;
    wp::int32* var_17;
    wp::int32 var_18;
    wp::int32 var_19;
    const wp::int32 var_20 = 2147483647;
    bool var_21;
    const wp::int32 var_22 = 1;
    wp::int32 var_23;
    wp::int32 var_24;
    const wp::int32 var_25 = 1;
    wp::int32 var_26;
    const wp::int32 var_27 = 1;
    bool var_28;
    wp::int32 var_29;
    bool var_30;
    const wp::int32 var_31 = 0;
    wp::int32 var_32;
    const wp::int32 var_33 = 1;
    wp::int32 var_34;
    const wp::int32 var_35 = 1;
    bool var_36;
    wp::int32 var_37;
    const wp::int32 var_38 = 0;
    wp::int32 var_39;
    wp::int32 var_40;
    wp::int32 var_41;
    wp::int32 var_42;
    wp::int32 var_43;
    wp::int32 var_44;
    wp::int32 var_45;
    wp::int32 var_46;
    wp::int32 var_47;
    wp::int32 var_48;
    //---------
    // forward
    // def sift_dense(children, core, record, a, b, cores__tree__boxes, cores__max_sqdist, cores__owners, cores__lowest):       <L 1>
    // dense = bits_within(measure_diagonals(cores__tree__boxes, record), cores__max_sqdist)       <L 4>
    var_0 = measure_diagonals_0(var_cores__tree__boxes, var_record);
    var_1 = bits_within_0(var_0, var_cores__max_sqdist);
    // inside = bits_within(measure_farthest(cores__tree__boxes, record, a, b), cores__max_sqdist)       <L 5>
    var_2 = measure_farthest_0(var_cores__tree__boxes, var_record, var_a, var_b);
    var_3 = bits_within_0(var_2, var_cores__max_sqdist);
    // root = find_root(cores__owners, core)                                                  <L 6>
    var_4 = find_root_0(var_cores__owners, var_core);
    // entered = int(0)                                                                       <L 7>
    var_6 = wp::int(var_5);
    // left__bits_of__1 = children                                                            <L 8>
    var_7 = wp::copy(var_children);
    // while left__bits_of__1 != 0:                                                           <L 9>
    start_while_0:;
    var_9 = (var_7 != var_8);
    if ((var_9) == false) goto end_while_0;
        // child = lowest_bit(left__bits_of__1)                                               <L 10>
        var_10 = lowest_bit_0(var_7);
        // left__bits_of__1 = left__bits_of__1 & left__bits_of__1 - 1                         <L 11>
        var_12 = wp::sub(var_7, var_11);
        var_13 = wp::bit_and(var_7, var_12);
        // first = cores__lowest[record * FAN + child]                                        <L 12>
        var_15 = wp::mul(var_record, var_14);
        var_16 = wp::add(var_15, var_10);
        var_17 = wp::address(var_cores__lowest, var_16);
        var_19 = wp::load(var_17);
        var_18 = wp::copy(var_19);
        // if first != NO_NUMBER:                                                             <L 13>
        var_21 = (var_18 != var_20);
        if (var_21) {
            // wanted = int(1)                                                                <L 14>
            var_23 = wp::int(var_22);
            // if dense >> child & 1 == 1:                                                    <L 15>
            var_24 = wp::rshift(var_1, var_10);
            var_26 = wp::bit_and(var_24, var_25);
            var_28 = (var_26 == var_27);
            if (var_28) {
                // if find_root(cores__owners, first) == root:                                <L 16>
                var_29 = find_root_0(var_cores__owners, var_18);
                var_30 = (var_29 == var_4);
                if (var_30) {
                    // wanted = 0                                                             <L 17>
                }
                if (!var_30) {
                    // elif inside >> child & 1 == 1:                                         <L 18>
                    var_32 = wp::rshift(var_3, var_10);
                    var_34 = wp::bit_and(var_32, var_33);
                    var_36 = (var_34 == var_35);
                    if (var_36) {
                        // root = unite(cores__owners, core, first)                           <L 19>
                        var_37 = unite_0(var_cores__owners, var_core, var_18);
                        // wanted = 0                                                         <L 20>
                    }
                    var_39 = wp::where(var_36, var_37, var_4);
                    var_40 = wp::where(var_36, var_38, var_23);
                }
                var_41 = wp::where(var_30, var_4, var_39);
                var_42 = wp::where(var_30, var_31, var_40);
            }
            var_43 = wp::where(var_28, var_41, var_4);
            var_44 = wp::where(var_28, var_42, var_23);
            // entered = entered | wanted << child                                            <L 21>
            var_45 = wp::lshift(var_44, var_10);
            var_46 = wp::bit_or(var_6, var_45);
        }
        var_47 = wp::where(var_21, var_43, var_4);
        var_48 = wp::where(var_21, var_46, var_6);
        wp::assign(var_4, var_47);
        wp::assign(var_6, var_48);
        wp::assign(var_7, var_13);
    goto start_while_0;
    end_while_0:;
    // return entered                                                                         <L 22>
    return var_6;
}


// <pointloom.kernels.segmentation.core_sets.unite_leaf>:1
static CUDA_CALLABLE void unite_leaf_0(
    wp::int32 var_core,
    wp::vec_t<8, wp::float32> var_xs,
    wp::vec_t<8, wp::float32> var_ys,
    wp::vec_t<8, wp::float32> var_zs,
    wp::int32 var_first,
    wp::int32 var_last,
    wp::array_t<wp::vec_t<3, wp::float32>> var_cores__tree__points,
    wp::float32 var_cores__max_sqdist,
    wp::array_t<wp::int32> var_cores__owners)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::range_t var_1;
    wp::int32 var_2;
    wp::int32* var_3;
    const wp::int32 var_4 = 0;
    bool var_5;
    wp::int32 var_6;
    wp::int32 var_7;
    bool var_8;
    wp::vec_t<3, wp::float32>* var_9;
    wp::vec_t<3, wp::float32> var_10;
    wp::vec_t<3, wp::float32> var_11;
    const wp::int32 var_12 = 0;
    wp::int32 var_13;
    const wp::int32 var_14 = 0;
    const wp::int32 var_15 = 0;
    wp::float32 var_16;
    wp::float32 var_17;
    wp::float32 var_18;
    const wp::int32 var_19 = 1;
    wp::float32 var_20;
    wp::float32 var_21;
    wp::float32 var_22;
    const wp::int32 var_23 = 2;
    wp::float32 var_24;
    wp::float32 var_25;
    wp::float32 var_26;
    wp::float32 var_27;
    wp::float32 var_28;
    wp::float32 var_29;
    wp::float32 var_30;
    wp::float32 var_31;
    bool var_32;
    const wp::int32 var_33 = 1;
    const wp::int32 var_34 = 0;
    wp::int32 var_35;
    wp::int32 var_36;
    const wp::int32 var_37 = 1;
    const wp::int32 var_38 = 0;
    wp::float32 var_39;
    wp::float32 var_40;
    wp::float32 var_41;
    const wp::int32 var_42 = 1;
    wp::float32 var_43;
    wp::float32 var_44;
    wp::float32 var_45;
    const wp::int32 var_46 = 2;
    wp::float32 var_47;
    wp::float32 var_48;
    wp::float32 var_49;
    wp::float32 var_50;
    wp::float32 var_51;
    wp::float32 var_52;
    wp::float32 var_53;
    wp::float32 var_54;
    bool var_55;
    const wp::int32 var_56 = 1;
    const wp::int32 var_57 = 0;
    wp::int32 var_58;
    wp::int32 var_59;
    const wp::int32 var_60 = 2;
    const wp::int32 var_61 = 0;
    wp::float32 var_62;
    wp::float32 var_63;
    wp::float32 var_64;
    const wp::int32 var_65 = 1;
    wp::float32 var_66;
    wp::float32 var_67;
    wp::float32 var_68;
    const wp::int32 var_69 = 2;
    wp::float32 var_70;
    wp::float32 var_71;
    wp::float32 var_72;
    wp::float32 var_73;
    wp::float32 var_74;
    wp::float32 var_75;
    wp::float32 var_76;
    wp::float32 var_77;
    bool var_78;
    const wp::int32 var_79 = 1;
    const wp::int32 var_80 = 0;
    wp::int32 var_81;
    wp::int32 var_82;
    const wp::int32 var_83 = 3;
    const wp::int32 var_84 = 0;
    wp::float32 var_85;
    wp::float32 var_86;
    wp::float32 var_87;
    const wp::int32 var_88 = 1;
    wp::float32 var_89;
    wp::float32 var_90;
    wp::float32 var_91;
    const wp::int32 var_92 = 2;
    wp::float32 var_93;
    wp::float32 var_94;
    wp::float32 var_95;
    wp::float32 var_96;
    wp::float32 var_97;
    wp::float32 var_98;
    wp::float32 var_99;
    wp::float32 var_100;
    bool var_101;
    const wp::int32 var_102 = 1;
    const wp::int32 var_103 = 0;
    wp::int32 var_104;
    wp::int32 var_105;
    const wp::int32 var_106 = 4;
    const wp::int32 var_107 = 0;
    wp::float32 var_108;
    wp::float32 var_109;
    wp::float32 var_110;
    const wp::int32 var_111 = 1;
    wp::float32 var_112;
    wp::float32 var_113;
    wp::float32 var_114;
    const wp::int32 var_115 = 2;
    wp::float32 var_116;
    wp::float32 var_117;
    wp::float32 var_118;
    wp::float32 var_119;
    wp::float32 var_120;
    wp::float32 var_121;
    wp::float32 var_122;
    wp::float32 var_123;
    bool var_124;
    const wp::int32 var_125 = 1;
    const wp::int32 var_126 = 0;
    wp::int32 var_127;
    wp::int32 var_128;
    const wp::int32 var_129 = 5;
    const wp::int32 var_130 = 0;
    wp::float32 var_131;
    wp::float32 var_132;
    wp::float32 var_133;
    const wp::int32 var_134 = 1;
    wp::float32 var_135;
    wp::float32 var_136;
    wp::float32 var_137;
    const wp::int32 var_138 = 2;
    wp::float32 var_139;
    wp::float32 var_140;
    wp::float32 var_141;
    wp::float32 var_142;
    wp::float32 var_143;
    wp::float32 var_144;
    wp::float32 var_145;
    wp::float32 var_146;
    bool var_147;
    const wp::int32 var_148 = 1;
    const wp::int32 var_149 = 0;
    wp::int32 var_150;
    wp::int32 var_151;
    const wp::int32 var_152 = 6;
    const wp::int32 var_153 = 0;
    wp::float32 var_154;
    wp::float32 var_155;
    wp::float32 var_156;
    const wp::int32 var_157 = 1;
    wp::float32 var_158;
    wp::float32 var_159;
    wp::float32 var_160;
    const wp::int32 var_161 = 2;
    wp::float32 var_162;
    wp::float32 var_163;
    wp::float32 var_164;
    wp::float32 var_165;
    wp::float32 var_166;
    wp::float32 var_167;
    wp::float32 var_168;
    wp::float32 var_169;
    bool var_170;
    const wp::int32 var_171 = 1;
    const wp::int32 var_172 = 0;
    wp::int32 var_173;
    wp::int32 var_174;
    const wp::int32 var_175 = 7;
    const wp::int32 var_176 = 0;
    wp::float32 var_177;
    wp::float32 var_178;
    wp::float32 var_179;
    const wp::int32 var_180 = 1;
    wp::float32 var_181;
    wp::float32 var_182;
    wp::float32 var_183;
    const wp::int32 var_184 = 2;
    wp::float32 var_185;
    wp::float32 var_186;
    wp::float32 var_187;
    wp::float32 var_188;
    wp::float32 var_189;
    wp::float32 var_190;
    wp::float32 var_191;
    wp::float32 var_192;
    bool var_193;
    const wp::int32 var_194 = 1;
    const wp::int32 var_195 = 0;
    wp::int32 var_196;
    wp::int32 var_197;
    const wp::int32 var_198 = 1;
    bool var_199;
    wp::int32 var_200;
    wp::int32 var_201;
    wp::int32 var_202;
    wp::int32 var_203;
    //---------
    // forward
    // def unite_leaf(core, xs, ys, zs, first, last, cores__tree__points, cores__max_sqdist, cores__owners):       <L 1>
    // root = find_root(cores__owners, core)                                                  <L 3>
    var_0 = find_root_0(var_cores__owners, var_core);
    // for r in range(first, last):                                                           <L 4>
    var_1 = wp::range(var_first, var_last);
    start_for_0:;
        if (iter_cmp(var_1) == 0) goto end_for_0;
        var_2 = wp::iter_next(var_1);
        // if cores__owners[r] >= 0:                                                          <L 5>
        var_3 = wp::address(var_cores__owners, var_2);
        var_6 = wp::load(var_3);
        var_5 = (var_6 >= var_4);
        if (var_5) {
            // if find_root(cores__owners, r) != root:                                        <L 6>
            var_7 = find_root_0(var_cores__owners, var_2);
            var_8 = (var_7 != var_0);
            if (var_8) {
                // q = cores__tree__points[r]                                                 <L 7>
                var_9 = wp::address(var_cores__tree__points, var_2);
                var_11 = wp::load(var_9);
                var_10 = wp::copy(var_11);
                // touched = int(0)                                                           <L 8>
                var_13 = wp::int(var_12);
                // for j in range(LEAF):                                                      <L 9>
                // x = q[0] - xs[j]                                                           <L 10>
                var_16 = wp::extract(var_10, var_15);
                var_17 = wp::extract(var_xs, var_14);
                var_18 = wp::sub(var_16, var_17);
                // y = q[1] - ys[j]                                                           <L 11>
                var_20 = wp::extract(var_10, var_19);
                var_21 = wp::extract(var_ys, var_14);
                var_22 = wp::sub(var_20, var_21);
                // z = q[2] - zs[j]                                                           <L 12>
                var_24 = wp::extract(var_10, var_23);
                var_25 = wp::extract(var_zs, var_14);
                var_26 = wp::sub(var_24, var_25);
                // touched = touched | (1 if x * x + y * y + z * z <= cores__max_sqdist else 0)       <L 13>
                var_27 = wp::mul(var_18, var_18);
                var_28 = wp::mul(var_22, var_22);
                var_29 = wp::add(var_27, var_28);
                var_30 = wp::mul(var_26, var_26);
                var_31 = wp::add(var_29, var_30);
                var_32 = (var_31 <= var_cores__max_sqdist);
                if (var_32) {
                }
                if (!var_32) {
                }
                var_35 = wp::where(var_32, var_33, var_34);
                var_36 = wp::bit_or(var_13, var_35);
                // x = q[0] - xs[j]                                                           <L 10>
                var_39 = wp::extract(var_10, var_38);
                var_40 = wp::extract(var_xs, var_37);
                var_41 = wp::sub(var_39, var_40);
                // y = q[1] - ys[j]                                                           <L 11>
                var_43 = wp::extract(var_10, var_42);
                var_44 = wp::extract(var_ys, var_37);
                var_45 = wp::sub(var_43, var_44);
                // z = q[2] - zs[j]                                                           <L 12>
                var_47 = wp::extract(var_10, var_46);
                var_48 = wp::extract(var_zs, var_37);
                var_49 = wp::sub(var_47, var_48);
                // touched = touched | (1 if x * x + y * y + z * z <= cores__max_sqdist else 0)       <L 13>
                var_50 = wp::mul(var_41, var_41);
                var_51 = wp::mul(var_45, var_45);
                var_52 = wp::add(var_50, var_51);
                var_53 = wp::mul(var_49, var_49);
                var_54 = wp::add(var_52, var_53);
                var_55 = (var_54 <= var_cores__max_sqdist);
                if (var_55) {
                }
                if (!var_55) {
                }
                var_58 = wp::where(var_55, var_56, var_57);
                var_59 = wp::bit_or(var_36, var_58);
                // x = q[0] - xs[j]                                                           <L 10>
                var_62 = wp::extract(var_10, var_61);
                var_63 = wp::extract(var_xs, var_60);
                var_64 = wp::sub(var_62, var_63);
                // y = q[1] - ys[j]                                                           <L 11>
                var_66 = wp::extract(var_10, var_65);
                var_67 = wp::extract(var_ys, var_60);
                var_68 = wp::sub(var_66, var_67);
                // z = q[2] - zs[j]                                                           <L 12>
                var_70 = wp::extract(var_10, var_69);
                var_71 = wp::extract(var_zs, var_60);
                var_72 = wp::sub(var_70, var_71);
                // touched = touched | (1 if x * x + y * y + z * z <= cores__max_sqdist else 0)       <L 13>
                var_73 = wp::mul(var_64, var_64);
                var_74 = wp::mul(var_68, var_68);
                var_75 = wp::add(var_73, var_74);
                var_76 = wp::mul(var_72, var_72);
                var_77 = wp::add(var_75, var_76);
                var_78 = (var_77 <= var_cores__max_sqdist);
                if (var_78) {
                }
                if (!var_78) {
                }
                var_81 = wp::where(var_78, var_79, var_80);
                var_82 = wp::bit_or(var_59, var_81);
                // x = q[0] - xs[j]                                                           <L 10>
                var_85 = wp::extract(var_10, var_84);
                var_86 = wp::extract(var_xs, var_83);
                var_87 = wp::sub(var_85, var_86);
                // y = q[1] - ys[j]                                                           <L 11>
                var_89 = wp::extract(var_10, var_88);
                var_90 = wp::extract(var_ys, var_83);
                var_91 = wp::sub(var_89, var_90);
                // z = q[2] - zs[j]                                                           <L 12>
                var_93 = wp::extract(var_10, var_92);
                var_94 = wp::extract(var_zs, var_83);
                var_95 = wp::sub(var_93, var_94);
                // touched = touched | (1 if x * x + y * y + z * z <= cores__max_sqdist else 0)       <L 13>
                var_96 = wp::mul(var_87, var_87);
                var_97 = wp::mul(var_91, var_91);
                var_98 = wp::add(var_96, var_97);
                var_99 = wp::mul(var_95, var_95);
                var_100 = wp::add(var_98, var_99);
                var_101 = (var_100 <= var_cores__max_sqdist);
                if (var_101) {
                }
                if (!var_101) {
                }
                var_104 = wp::where(var_101, var_102, var_103);
                var_105 = wp::bit_or(var_82, var_104);
                // x = q[0] - xs[j]                                                           <L 10>
                var_108 = wp::extract(var_10, var_107);
                var_109 = wp::extract(var_xs, var_106);
                var_110 = wp::sub(var_108, var_109);
                // y = q[1] - ys[j]                                                           <L 11>
                var_112 = wp::extract(var_10, var_111);
                var_113 = wp::extract(var_ys, var_106);
                var_114 = wp::sub(var_112, var_113);
                // z = q[2] - zs[j]                                                           <L 12>
                var_116 = wp::extract(var_10, var_115);
                var_117 = wp::extract(var_zs, var_106);
                var_118 = wp::sub(var_116, var_117);
                // touched = touched | (1 if x * x + y * y + z * z <= cores__max_sqdist else 0)       <L 13>
                var_119 = wp::mul(var_110, var_110);
                var_120 = wp::mul(var_114, var_114);
                var_121 = wp::add(var_119, var_120);
                var_122 = wp::mul(var_118, var_118);
                var_123 = wp::add(var_121, var_122);
                var_124 = (var_123 <= var_cores__max_sqdist);
                if (var_124) {
                }
                if (!var_124) {
                }
                var_127 = wp::where(var_124, var_125, var_126);
                var_128 = wp::bit_or(var_105, var_127);
                // x = q[0] - xs[j]                                                           <L 10>
                var_131 = wp::extract(var_10, var_130);
                var_132 = wp::extract(var_xs, var_129);
                var_133 = wp::sub(var_131, var_132);
                // y = q[1] - ys[j]                                                           <L 11>
                var_135 = wp::extract(var_10, var_134);
                var_136 = wp::extract(var_ys, var_129);
                var_137 = wp::sub(var_135, var_136);
                // z = q[2] - zs[j]                                                           <L 12>
                var_139 = wp::extract(var_10, var_138);
                var_140 = wp::extract(var_zs, var_129);
                var_141 = wp::sub(var_139, var_140);
                // touched = touched | (1 if x * x + y * y + z * z <= cores__max_sqdist else 0)       <L 13>
                var_142 = wp::mul(var_133, var_133);
                var_143 = wp::mul(var_137, var_137);
                var_144 = wp::add(var_142, var_143);
                var_145 = wp::mul(var_141, var_141);
                var_146 = wp::add(var_144, var_145);
                var_147 = (var_146 <= var_cores__max_sqdist);
                if (var_147) {
                }
                if (!var_147) {
                }
                var_150 = wp::where(var_147, var_148, var_149);
                var_151 = wp::bit_or(var_128, var_150);
                // x = q[0] - xs[j]                                                           <L 10>
                var_154 = wp::extract(var_10, var_153);
                var_155 = wp::extract(var_xs, var_152);
                var_156 = wp::sub(var_154, var_155);
                // y = q[1] - ys[j]                                                           <L 11>
                var_158 = wp::extract(var_10, var_157);
                var_159 = wp::extract(var_ys, var_152);
                var_160 = wp::sub(var_158, var_159);
                // z = q[2] - zs[j]                                                           <L 12>
                var_162 = wp::extract(var_10, var_161);
                var_163 = wp::extract(var_zs, var_152);
                var_164 = wp::sub(var_162, var_163);
                // touched = touched | (1 if x * x + y * y + z * z <= cores__max_sqdist else 0)       <L 13>
                var_165 = wp::mul(var_156, var_156);
                var_166 = wp::mul(var_160, var_160);
                var_167 = wp::add(var_165, var_166);
                var_168 = wp::mul(var_164, var_164);
                var_169 = wp::add(var_167, var_168);
                var_170 = (var_169 <= var_cores__max_sqdist);
                if (var_170) {
                }
                if (!var_170) {
                }
                var_173 = wp::where(var_170, var_171, var_172);
                var_174 = wp::bit_or(var_151, var_173);
                // x = q[0] - xs[j]                                                           <L 10>
                var_177 = wp::extract(var_10, var_176);
                var_178 = wp::extract(var_xs, var_175);
                var_179 = wp::sub(var_177, var_178);
                // y = q[1] - ys[j]                                                           <L 11>
                var_181 = wp::extract(var_10, var_180);
                var_182 = wp::extract(var_ys, var_175);
                var_183 = wp::sub(var_181, var_182);
                // z = q[2] - zs[j]                                                           <L 12>
                var_185 = wp::extract(var_10, var_184);
                var_186 = wp::extract(var_zs, var_175);
                var_187 = wp::sub(var_185, var_186);
                // touched = touched | (1 if x * x + y * y + z * z <= cores__max_sqdist else 0)       <L 13>
                var_188 = wp::mul(var_179, var_179);
                var_189 = wp::mul(var_183, var_183);
                var_190 = wp::add(var_188, var_189);
                var_191 = wp::mul(var_187, var_187);
                var_192 = wp::add(var_190, var_191);
                var_193 = (var_192 <= var_cores__max_sqdist);
                if (var_193) {
                }
                if (!var_193) {
                }
                var_196 = wp::where(var_193, var_194, var_195);
                var_197 = wp::bit_or(var_174, var_196);
                // if touched == 1:                                                           <L 14>
                var_199 = (var_197 == var_198);
                if (var_199) {
                    // root = unite(cores__owners, core, r)                                   <L 15>
                    var_200 = unite_0(var_cores__owners, var_core, var_2);
                }
                var_201 = wp::where(var_199, var_200, var_0);
            }
            var_202 = wp::where(var_8, var_201, var_0);
        }
        var_203 = wp::where(var_5, var_202, var_0);
        wp::assign(var_0, var_203);
        goto start_for_0;
    end_for_0:;
}


// /work/main/src/pointloom/kernels/search/tree_walk.py:52
static CUDA_CALLABLE wp::vec_t<4, wp::int64> put_off_0(
    wp::vec_t<4, wp::int64> var_step,
    wp::int32 var_children)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int64 var_1;
    const wp::int32 var_2 = 1;
    wp::int64 var_3;
    const wp::int32 var_4 = 2;
    wp::int64 var_5;
    const wp::int32 var_6 = 3;
    wp::int64 var_7;
    wp::int64 var_8;
    const wp::int32 var_9 = 1;
    wp::int64 var_10;
    wp::int32 var_11;
    wp::int64 var_12;
    wp::int64 var_13;
    wp::int64 var_14;
    wp::vec_t<4, wp::int64> var_15;
    //---------
    // forward
    // def put_off(step: traversal, children: int) -> traversal:                              <L 53>
    // return traversal(step[0], step[1], step[2], step[3] | (int64(children) << pending_shift(int(step[1]))))       <L 55>
    var_1 = wp::extract(var_step, var_0);
    var_3 = wp::extract(var_step, var_2);
    var_5 = wp::extract(var_step, var_4);
    var_7 = wp::extract(var_step, var_6);
    var_8 = wp::int64(var_children);
    var_10 = wp::extract(var_step, var_9);
    var_11 = wp::int(var_10);
    var_12 = pending_shift_0(var_11);
    var_13 = wp::lshift(var_8, var_12);
    var_14 = wp::bit_or(var_7, var_13);
    var_15 = wp::vec_t<4, wp::int64>(var_1, var_3, var_5, var_14);
    return var_15;
}


// <pointloom.kernels.segmentation.core_sets.unite_part>:1
static CUDA_CALLABLE void unite_part_0(
    wp::int32 var_core,
    wp::vec_t<8, wp::float32> var_xs,
    wp::vec_t<8, wp::float32> var_ys,
    wp::vec_t<8, wp::float32> var_zs,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::int32 var_leaf,
    wp::int32 var_start,
    wp::int32 var_cores__tree__count,
    wp::int32 var_cores__tree__root,
    wp::array_t<wp::int32> var_cores__tree__levels,
    wp::array_t<wp::float32> var_cores__tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> var_cores__tree__points,
    wp::float32 var_cores__max_sqdist,
    wp::array_t<wp::int32> var_cores__owners,
    wp::array_t<wp::int32> var_cores__lowest)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    const wp::int32 var_2 = 3;
    wp::int32 var_3;
    wp::int32 var_4;
    wp::vec_t<4, wp::int64> var_5;
    const wp::int32 var_6 = 1;
    wp::int32 var_7;
    wp::vec_t<4, wp::int64> var_8;
    const wp::int32 var_9 = 0;
    wp::int64 var_10;
    wp::int32 var_11;
    const wp::int32 var_12 = 1;
    wp::int32 var_13;
    bool var_14;
    const wp::int32 var_15 = 0;
    wp::int64 var_16;
    wp::int32 var_17;
    const wp::int32 var_18 = 1;
    wp::int64 var_19;
    wp::int32 var_20;
    const wp::int32 var_21 = 2;
    wp::int64 var_22;
    wp::int32 var_23;
    wp::int32 var_24;
    wp::vec_t<8, wp::float32> var_25;
    wp::int32 var_26;
    wp::int32 var_27;
    wp::int32 var_28;
    const wp::int32 var_29 = 0;
    bool var_30;
    wp::int32 var_31;
    const wp::int32 var_32 = 1;
    bool var_33;
    wp::int32 var_34;
    const wp::int32 var_35 = 0;
    bool var_36;
    wp::int32 var_37;
    const wp::int32 var_38 = 1;
    wp::int32 var_39;
    wp::int32 var_40;
    const wp::int32 var_41 = 8;
    wp::int32 var_42;
    wp::int32 var_43;
    const wp::int32 var_44 = 8;
    wp::int32 var_45;
    wp::int32 var_46;
    wp::int32 var_47;
    wp::int32 var_48;
    const wp::int32 var_49 = 1;
    bool var_50;
    wp::vec_t<4, wp::int64> var_51;
    wp::vec_t<4, wp::int64> var_52;
    const wp::int32 var_53 = 1;
    wp::int32 var_54;
    wp::vec_t<4, wp::int64> var_55;
    //---------
    // forward
    // def unite_part(core, xs, ys, zs, a, b, leaf, start, cores__tree__count, cores__tree__root, cores__tree__levels, cores__tree__boxes, cores__tree__points, cores__max_sqdist, cores__owners, cores__lowest):       <L 1>
    // near = int(0)                                                                          <L 4>
    var_1 = wp::int(var_0);
    // step__nodes_after__3 = next_node__nodes_after(begin_traversal__nodes_after(start, leaf >> FAN_BITS__nodes_after * start), cores__tree__root + 1)       <L 5>
    var_3 = wp::mul(var_2, var_start);
    var_4 = wp::rshift(var_leaf, var_3);
    var_5 = begin_traversal_0(var_start, var_4);
    var_7 = wp::add(var_cores__tree__root, var_6);
    var_8 = next_node_0(var_5, var_7);
    // while int(step__nodes_after__3[0]) <= cores__tree__root + 1:                           <L 6>
    start_while_0:;
    var_10 = wp::extract(var_8, var_9);
    var_11 = wp::int(var_10);
    var_13 = wp::add(var_cores__tree__root, var_12);
    var_14 = (var_11 <= var_13);
    if ((var_14) == false) goto end_while_0;
        // height = int(step__nodes_after__3[0])                                              <L 7>
        var_16 = wp::extract(var_8, var_15);
        var_17 = wp::int(var_16);
        // level = int(step__nodes_after__3[1])                                               <L 8>
        var_19 = wp::extract(var_8, var_18);
        var_20 = wp::int(var_19);
        // node = int(step__nodes_after__3[2])                                                <L 9>
        var_22 = wp::extract(var_8, var_21);
        var_23 = wp::int(var_22);
        // record = record_of(cores__tree__levels, level, node)                               <L 10>
        var_24 = record_of_0(var_cores__tree__levels, var_20, var_23);
        // near = bits_within(measure_boxes(cores__tree__boxes, record, a, b), cores__max_sqdist)       <L 11>
        var_25 = measure_boxes_0(var_cores__tree__boxes, var_24, var_a, var_b);
        var_26 = bits_within_0(var_25, var_cores__max_sqdist);
        // near = near & following_children(leaf, height, level)                              <L 12>
        var_27 = following_children_0(var_leaf, var_17, var_20);
        var_28 = wp::bit_and(var_26, var_27);
        // if near != 0:                                                                      <L 13>
        var_30 = (var_28 != var_29);
        if (var_30) {
            // near = sift_dense(near, core, record, a, b, cores__tree__boxes, cores__max_sqdist, cores__owners, cores__lowest)       <L 14>
            var_31 = sift_dense_0(var_28, var_core, var_24, var_a, var_b, var_cores__tree__boxes, var_cores__max_sqdist, var_cores__owners, var_cores__lowest);
            // if level == 1:                                                                 <L 15>
            var_33 = (var_20 == var_32);
            if (var_33) {
                // left__bits_of__2 = near                                                    <L 16>
                var_34 = wp::copy(var_31);
                // while left__bits_of__2 != 0:                                               <L 17>
    start_while_2:;
                var_36 = (var_34 != var_35);
    if ((var_36) == false) goto end_while_2;
                    // child__leaves_of__1 = lowest_bit(left__bits_of__2)                     <L 18>
                    var_37 = lowest_bit_0(var_34);
                    // left__bits_of__2 = left__bits_of__2 & left__bits_of__2 - 1             <L 19>
                    var_39 = wp::sub(var_34, var_38);
                    var_40 = wp::bit_and(var_34, var_39);
                    // first = (node * FAN__leaves_of + child__leaves_of__1) * LEAF__leaves_of       <L 20>
                    var_42 = wp::mul(var_23, var_41);
                    var_43 = wp::add(var_42, var_37);
                    var_45 = wp::mul(var_43, var_44);
                    // last = min(first + LEAF__leaves_of, cores__tree__count)                <L 21>
                    var_46 = wp::add(var_45, var_44);
                    var_47 = wp::min(var_46, var_cores__tree__count);
                    // unite_leaf(core, xs, ys, zs, first, last, cores__tree__points, cores__max_sqdist, cores__owners)       <L 22>
                    unite_leaf_0(var_core, var_xs, var_ys, var_zs, var_45, var_47, var_cores__tree__points, var_cores__max_sqdist, var_cores__owners);
                    wp::assign(var_34, var_40);
    goto start_while_2;
    end_while_2:;
            }
        }
        var_48 = wp::where(var_30, var_31, var_28);
        // if level > 1:                                                                      <L 23>
        var_50 = (var_20 > var_49);
        if (var_50) {
            // step__nodes_after__3 = put_off__nodes_after(step__nodes_after__3, near)        <L 24>
            var_51 = put_off_0(var_8, var_48);
        }
        var_52 = wp::where(var_50, var_51, var_8);
        // step__nodes_after__3 = next_node__nodes_after(step__nodes_after__3, cores__tree__root + 1)       <L 25>
        var_54 = wp::add(var_cores__tree__root, var_53);
        var_55 = next_node_0(var_52, var_54);
        wp::assign(var_1, var_48);
        wp::assign(var_8, var_55);
    goto start_while_0;
    end_while_0:;
}


// /work/main/src/pointloom/kernels/search/tree_walk.py:34
static CUDA_CALLABLE void adj_record_of_0(
    wp::array_t<wp::int32> var_levels,
    wp::int32 var_level,
    wp::int32 var_node,
    wp::array_t<wp::int32> & adj_levels,
    wp::int32 & adj_level,
    wp::int32 & adj_node,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/search/tree_walk.py:164
static CUDA_CALLABLE void adj_measure_diagonals_0(
    wp::array_t<wp::float32> var_boxes,
    wp::int32 var_record,
    wp::array_t<wp::float32> & adj_boxes,
    wp::int32 & adj_record,
    wp::vec_t<8, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.tree_walk.bits_within>:1
static CUDA_CALLABLE void adj_bits_within_0(
    wp::vec_t<8, wp::float32> var_distances,
    wp::float32 var_max_sqdist,
    wp::vec_t<8, wp::float32> & adj_distances,
    wp::float32 & adj_max_sqdist,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.segmentation.core_sets.dense_ancestor>:1
static CUDA_CALLABLE void adj_dense_ancestor_0(
    wp::int32 var_leaf,
    wp::int32 var_cores__tree__root,
    wp::array_t<wp::int32> var_cores__tree__levels,
    wp::array_t<wp::float32> var_cores__tree__boxes,
    wp::float32 var_cores__max_sqdist,
    wp::int32 & adj_leaf,
    wp::int32 & adj_cores__tree__root,
    wp::array_t<wp::int32> & adj_cores__tree__levels,
    wp::array_t<wp::float32> & adj_cores__tree__boxes,
    wp::float32 & adj_cores__max_sqdist,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/arrays/union_find.py:15
static CUDA_CALLABLE void adj_find_root_0(
    wp::array_t<wp::int32> var_parents,
    wp::int32 var_x,
    wp::array_t<wp::int32> & adj_parents,
    wp::int32 & adj_x,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/arrays/union_find.py:29
static CUDA_CALLABLE void adj_hook_roots_0(
    wp::array_t<wp::int32> var_parents,
    wp::int32 var_x,
    wp::int32 var_y,
    wp::array_t<wp::int32> & adj_parents,
    wp::int32 & adj_x,
    wp::int32 & adj_y,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/arrays/union_find.py:46
static CUDA_CALLABLE void adj_unite_0(
    wp::array_t<wp::int32> var_parents,
    wp::int32 var_x,
    wp::int32 var_y,
    wp::array_t<wp::int32> & adj_parents,
    wp::int32 & adj_x,
    wp::int32 & adj_y,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/search/tree_walk.py:20
static CUDA_CALLABLE void adj_lowest_bit_0(
    wp::int32 var_bits,
    wp::int32 & adj_bits,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.segmentation.core_sets.set_part>:1
static CUDA_CALLABLE void adj_set_part_0(
    wp::int32 var_candidates,
    wp::int32 var_head,
    wp::int32 var_core,
    wp::array_t<wp::int32> var_owners,
    wp::int32 & adj_candidates,
    wp::int32 & adj_head,
    wp::int32 & adj_core,
    wp::array_t<wp::int32> & adj_owners,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.tree_walk.begin_traversal>:1
static CUDA_CALLABLE void adj_begin_traversal_0(
    wp::int32 var_level,
    wp::int32 var_node,
    wp::int32 & adj_level,
    wp::int32 & adj_node,
    wp::vec_t<4, wp::int64> & adj_ret)
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


// /work/main/src/pointloom/kernels/search/tree_walk.py:40
static CUDA_CALLABLE void adj_pending_shift_0(
    wp::int32 var_level,
    wp::int32 & adj_level,
    wp::int64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.search.tree_walk.next_node>:1
static CUDA_CALLABLE void adj_next_node_0(
    wp::vec_t<4, wp::int64> var_step,
    wp::int32 var_top,
    wp::vec_t<4, wp::int64> & adj_step,
    wp::int32 & adj_top,
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


// /work/main/src/pointloom/kernels/search/tree_walk.py:85
static CUDA_CALLABLE void adj_own_child_0(
    wp::int32 var_leaf,
    wp::int32 var_level,
    wp::int32 & adj_leaf,
    wp::int32 & adj_level,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/search/tree_walk.py:100
static CUDA_CALLABLE void adj_following_children_0(
    wp::int32 var_leaf,
    wp::int32 var_height,
    wp::int32 var_level,
    wp::int32 & adj_leaf,
    wp::int32 & adj_height,
    wp::int32 & adj_level,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/search/tree_walk.py:151
static CUDA_CALLABLE void adj_measure_farthest_0(
    wp::array_t<wp::float32> var_boxes,
    wp::int32 var_record,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::array_t<wp::float32> & adj_boxes,
    wp::int32 & adj_record,
    wp::vec_t<3, wp::float32> & adj_a,
    wp::vec_t<3, wp::float32> & adj_b,
    wp::vec_t<8, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.segmentation.core_sets.sift_dense>:1
static CUDA_CALLABLE void adj_sift_dense_0(
    wp::int32 var_children,
    wp::int32 var_core,
    wp::int32 var_record,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::array_t<wp::float32> var_cores__tree__boxes,
    wp::float32 var_cores__max_sqdist,
    wp::array_t<wp::int32> var_cores__owners,
    wp::array_t<wp::int32> var_cores__lowest,
    wp::int32 & adj_children,
    wp::int32 & adj_core,
    wp::int32 & adj_record,
    wp::vec_t<3, wp::float32> & adj_a,
    wp::vec_t<3, wp::float32> & adj_b,
    wp::array_t<wp::float32> & adj_cores__tree__boxes,
    wp::float32 & adj_cores__max_sqdist,
    wp::array_t<wp::int32> & adj_cores__owners,
    wp::array_t<wp::int32> & adj_cores__lowest,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.segmentation.core_sets.unite_leaf>:1
static CUDA_CALLABLE void adj_unite_leaf_0(
    wp::int32 var_core,
    wp::vec_t<8, wp::float32> var_xs,
    wp::vec_t<8, wp::float32> var_ys,
    wp::vec_t<8, wp::float32> var_zs,
    wp::int32 var_first,
    wp::int32 var_last,
    wp::array_t<wp::vec_t<3, wp::float32>> var_cores__tree__points,
    wp::float32 var_cores__max_sqdist,
    wp::array_t<wp::int32> var_cores__owners,
    wp::int32 & adj_core,
    wp::vec_t<8, wp::float32> & adj_xs,
    wp::vec_t<8, wp::float32> & adj_ys,
    wp::vec_t<8, wp::float32> & adj_zs,
    wp::int32 & adj_first,
    wp::int32 & adj_last,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_cores__tree__points,
    wp::float32 & adj_cores__max_sqdist,
    wp::array_t<wp::int32> & adj_cores__owners)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/search/tree_walk.py:52
static CUDA_CALLABLE void adj_put_off_0(
    wp::vec_t<4, wp::int64> var_step,
    wp::int32 var_children,
    wp::vec_t<4, wp::int64> & adj_step,
    wp::int32 & adj_children,
    wp::vec_t<4, wp::int64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.segmentation.core_sets.unite_part>:1
static CUDA_CALLABLE void adj_unite_part_0(
    wp::int32 var_core,
    wp::vec_t<8, wp::float32> var_xs,
    wp::vec_t<8, wp::float32> var_ys,
    wp::vec_t<8, wp::float32> var_zs,
    wp::vec_t<3, wp::float32> var_a,
    wp::vec_t<3, wp::float32> var_b,
    wp::int32 var_leaf,
    wp::int32 var_start,
    wp::int32 var_cores__tree__count,
    wp::int32 var_cores__tree__root,
    wp::array_t<wp::int32> var_cores__tree__levels,
    wp::array_t<wp::float32> var_cores__tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> var_cores__tree__points,
    wp::float32 var_cores__max_sqdist,
    wp::array_t<wp::int32> var_cores__owners,
    wp::array_t<wp::int32> var_cores__lowest,
    wp::int32 & adj_core,
    wp::vec_t<8, wp::float32> & adj_xs,
    wp::vec_t<8, wp::float32> & adj_ys,
    wp::vec_t<8, wp::float32> & adj_zs,
    wp::vec_t<3, wp::float32> & adj_a,
    wp::vec_t<3, wp::float32> & adj_b,
    wp::int32 & adj_leaf,
    wp::int32 & adj_start,
    wp::int32 & adj_cores__tree__count,
    wp::int32 & adj_cores__tree__root,
    wp::array_t<wp::int32> & adj_cores__tree__levels,
    wp::array_t<wp::float32> & adj_cores__tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_cores__tree__points,
    wp::float32 & adj_cores__max_sqdist,
    wp::array_t<wp::int32> & adj_cores__owners,
    wp::array_t<wp::int32> & adj_cores__lowest)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void WP_MAXNREG(80) unite_cores_kernel_bc525e26_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::int32 var_cores__tree__count,
    wp::int32 var_cores__tree__root,
    wp::array_t<wp::int32> var_cores__tree__levels,
    wp::array_t<wp::float32> var_cores__tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> var_cores__tree__points,
    wp::float32 var_cores__max_sqdist,
    wp::array_t<wp::int32> var_cores__owners,
    wp::array_t<wp::int32> var_cores__lowest)
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
        const wp::int32 var_3 = 0;
        wp::int32 var_4;
        const wp::int32 var_5 = 0;
        wp::int32 var_6;
        wp::int32* var_7;
        const wp::int32 var_8 = 2147483647;
        bool var_9;
        wp::int32 var_10;
        wp::int32 var_11;
        const wp::int32 var_12 = 0;
        bool var_13;
        const wp::int32 var_14 = 3;
        wp::int32 var_15;
        wp::int32 var_16;
        wp::int32* var_17;
        wp::int32* var_18;
        const wp::int32 var_19 = 8;
        wp::int32 var_20;
        wp::int32 var_21;
        wp::int32 var_22;
        wp::int32* var_23;
        wp::int32 var_24;
        wp::int32 var_25;
        wp::int32 var_26;
        wp::int32 var_27;
        wp::int32 var_28;
        wp::range_t var_29;
        wp::int32 var_30;
        wp::int32 var_31;
        wp::int32* var_32;
        const wp::int32 var_33 = 0;
        bool var_34;
        wp::int32 var_35;
        const wp::int32 var_36 = 1;
        wp::int32 var_37;
        wp::int32 var_38;
        wp::int32 var_39;
        wp::int32 var_40;
        const wp::int32 var_41 = 0;
        bool var_42;
        wp::int32 var_43;
        wp::int32 var_44;
        wp::int32 var_45;
        wp::int32 var_46;
        const wp::float32 var_47 = INFINITY;
        wp::vec_t<8, wp::float32> var_48;
        const wp::float32 var_49 = 0.0;
        wp::vec_t<8, wp::float32> var_50;
        const wp::float32 var_51 = 0.0;
        wp::vec_t<8, wp::float32> var_52;
        wp::vec_t<3, wp::float32>* var_53;
        wp::vec_t<3, wp::float32> var_54;
        wp::vec_t<3, wp::float32> var_55;
        const wp::float32 var_56 = 0.0;
        const wp::float32 var_57 = 0.0;
        const wp::float32 var_58 = 0.0;
        wp::vec_t<3, wp::float32> var_59;
        wp::vec_t<3, wp::float32> var_60;
        const wp::int32 var_61 = 0;
        wp::int32 var_62;
        const wp::int32 var_63 = 1;
        wp::int32 var_64;
        const wp::int32 var_65 = 1;
        bool var_66;
        wp::int32 var_67;
        wp::vec_t<3, wp::float32>* var_68;
        wp::vec_t<3, wp::float32> var_69;
        wp::vec_t<3, wp::float32> var_70;
        const wp::int32 var_71 = 0;
        wp::float32 var_72;
        const wp::int32 var_73 = 1;
        wp::float32 var_74;
        const wp::int32 var_75 = 2;
        wp::float32 var_76;
        const wp::int32 var_77 = 0;
        wp::float32 var_78;
        const wp::int32 var_79 = 0;
        wp::float32 var_80;
        wp::float32 var_81;
        const wp::int32 var_82 = 1;
        wp::float32 var_83;
        const wp::int32 var_84 = 1;
        wp::float32 var_85;
        wp::float32 var_86;
        const wp::int32 var_87 = 2;
        wp::float32 var_88;
        const wp::int32 var_89 = 2;
        wp::float32 var_90;
        wp::float32 var_91;
        wp::vec_t<3, wp::float32> var_92;
        const wp::int32 var_93 = 0;
        wp::float32 var_94;
        const wp::int32 var_95 = 0;
        wp::float32 var_96;
        wp::float32 var_97;
        const wp::int32 var_98 = 1;
        wp::float32 var_99;
        const wp::int32 var_100 = 1;
        wp::float32 var_101;
        wp::float32 var_102;
        const wp::int32 var_103 = 2;
        wp::float32 var_104;
        const wp::int32 var_105 = 2;
        wp::float32 var_106;
        wp::float32 var_107;
        wp::vec_t<3, wp::float32> var_108;
        wp::vec_t<3, wp::float32> var_109;
        wp::vec_t<3, wp::float32> var_110;
        const wp::int32 var_111 = 1;
        wp::int32 var_112;
        const wp::int32 var_113 = 1;
        wp::int32 var_114;
        const wp::int32 var_115 = 1;
        bool var_116;
        wp::int32 var_117;
        wp::vec_t<3, wp::float32>* var_118;
        wp::vec_t<3, wp::float32> var_119;
        wp::vec_t<3, wp::float32> var_120;
        const wp::int32 var_121 = 0;
        wp::float32 var_122;
        const wp::int32 var_123 = 1;
        wp::float32 var_124;
        const wp::int32 var_125 = 2;
        wp::float32 var_126;
        const wp::int32 var_127 = 0;
        wp::float32 var_128;
        const wp::int32 var_129 = 0;
        wp::float32 var_130;
        wp::float32 var_131;
        const wp::int32 var_132 = 1;
        wp::float32 var_133;
        const wp::int32 var_134 = 1;
        wp::float32 var_135;
        wp::float32 var_136;
        const wp::int32 var_137 = 2;
        wp::float32 var_138;
        const wp::int32 var_139 = 2;
        wp::float32 var_140;
        wp::float32 var_141;
        wp::vec_t<3, wp::float32> var_142;
        const wp::int32 var_143 = 0;
        wp::float32 var_144;
        const wp::int32 var_145 = 0;
        wp::float32 var_146;
        wp::float32 var_147;
        const wp::int32 var_148 = 1;
        wp::float32 var_149;
        const wp::int32 var_150 = 1;
        wp::float32 var_151;
        wp::float32 var_152;
        const wp::int32 var_153 = 2;
        wp::float32 var_154;
        const wp::int32 var_155 = 2;
        wp::float32 var_156;
        wp::float32 var_157;
        wp::vec_t<3, wp::float32> var_158;
        wp::vec_t<3, wp::float32> var_159;
        wp::vec_t<3, wp::float32> var_160;
        wp::vec_t<3, wp::float32> var_161;
        const wp::int32 var_162 = 2;
        wp::int32 var_163;
        const wp::int32 var_164 = 1;
        wp::int32 var_165;
        const wp::int32 var_166 = 1;
        bool var_167;
        wp::int32 var_168;
        wp::vec_t<3, wp::float32>* var_169;
        wp::vec_t<3, wp::float32> var_170;
        wp::vec_t<3, wp::float32> var_171;
        const wp::int32 var_172 = 0;
        wp::float32 var_173;
        const wp::int32 var_174 = 1;
        wp::float32 var_175;
        const wp::int32 var_176 = 2;
        wp::float32 var_177;
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
        wp::vec_t<3, wp::float32> var_193;
        const wp::int32 var_194 = 0;
        wp::float32 var_195;
        const wp::int32 var_196 = 0;
        wp::float32 var_197;
        wp::float32 var_198;
        const wp::int32 var_199 = 1;
        wp::float32 var_200;
        const wp::int32 var_201 = 1;
        wp::float32 var_202;
        wp::float32 var_203;
        const wp::int32 var_204 = 2;
        wp::float32 var_205;
        const wp::int32 var_206 = 2;
        wp::float32 var_207;
        wp::float32 var_208;
        wp::vec_t<3, wp::float32> var_209;
        wp::vec_t<3, wp::float32> var_210;
        wp::vec_t<3, wp::float32> var_211;
        wp::vec_t<3, wp::float32> var_212;
        const wp::int32 var_213 = 3;
        wp::int32 var_214;
        const wp::int32 var_215 = 1;
        wp::int32 var_216;
        const wp::int32 var_217 = 1;
        bool var_218;
        wp::int32 var_219;
        wp::vec_t<3, wp::float32>* var_220;
        wp::vec_t<3, wp::float32> var_221;
        wp::vec_t<3, wp::float32> var_222;
        const wp::int32 var_223 = 0;
        wp::float32 var_224;
        const wp::int32 var_225 = 1;
        wp::float32 var_226;
        const wp::int32 var_227 = 2;
        wp::float32 var_228;
        const wp::int32 var_229 = 0;
        wp::float32 var_230;
        const wp::int32 var_231 = 0;
        wp::float32 var_232;
        wp::float32 var_233;
        const wp::int32 var_234 = 1;
        wp::float32 var_235;
        const wp::int32 var_236 = 1;
        wp::float32 var_237;
        wp::float32 var_238;
        const wp::int32 var_239 = 2;
        wp::float32 var_240;
        const wp::int32 var_241 = 2;
        wp::float32 var_242;
        wp::float32 var_243;
        wp::vec_t<3, wp::float32> var_244;
        const wp::int32 var_245 = 0;
        wp::float32 var_246;
        const wp::int32 var_247 = 0;
        wp::float32 var_248;
        wp::float32 var_249;
        const wp::int32 var_250 = 1;
        wp::float32 var_251;
        const wp::int32 var_252 = 1;
        wp::float32 var_253;
        wp::float32 var_254;
        const wp::int32 var_255 = 2;
        wp::float32 var_256;
        const wp::int32 var_257 = 2;
        wp::float32 var_258;
        wp::float32 var_259;
        wp::vec_t<3, wp::float32> var_260;
        wp::vec_t<3, wp::float32> var_261;
        wp::vec_t<3, wp::float32> var_262;
        wp::vec_t<3, wp::float32> var_263;
        const wp::int32 var_264 = 4;
        wp::int32 var_265;
        const wp::int32 var_266 = 1;
        wp::int32 var_267;
        const wp::int32 var_268 = 1;
        bool var_269;
        wp::int32 var_270;
        wp::vec_t<3, wp::float32>* var_271;
        wp::vec_t<3, wp::float32> var_272;
        wp::vec_t<3, wp::float32> var_273;
        const wp::int32 var_274 = 0;
        wp::float32 var_275;
        const wp::int32 var_276 = 1;
        wp::float32 var_277;
        const wp::int32 var_278 = 2;
        wp::float32 var_279;
        const wp::int32 var_280 = 0;
        wp::float32 var_281;
        const wp::int32 var_282 = 0;
        wp::float32 var_283;
        wp::float32 var_284;
        const wp::int32 var_285 = 1;
        wp::float32 var_286;
        const wp::int32 var_287 = 1;
        wp::float32 var_288;
        wp::float32 var_289;
        const wp::int32 var_290 = 2;
        wp::float32 var_291;
        const wp::int32 var_292 = 2;
        wp::float32 var_293;
        wp::float32 var_294;
        wp::vec_t<3, wp::float32> var_295;
        const wp::int32 var_296 = 0;
        wp::float32 var_297;
        const wp::int32 var_298 = 0;
        wp::float32 var_299;
        wp::float32 var_300;
        const wp::int32 var_301 = 1;
        wp::float32 var_302;
        const wp::int32 var_303 = 1;
        wp::float32 var_304;
        wp::float32 var_305;
        const wp::int32 var_306 = 2;
        wp::float32 var_307;
        const wp::int32 var_308 = 2;
        wp::float32 var_309;
        wp::float32 var_310;
        wp::vec_t<3, wp::float32> var_311;
        wp::vec_t<3, wp::float32> var_312;
        wp::vec_t<3, wp::float32> var_313;
        wp::vec_t<3, wp::float32> var_314;
        const wp::int32 var_315 = 5;
        wp::int32 var_316;
        const wp::int32 var_317 = 1;
        wp::int32 var_318;
        const wp::int32 var_319 = 1;
        bool var_320;
        wp::int32 var_321;
        wp::vec_t<3, wp::float32>* var_322;
        wp::vec_t<3, wp::float32> var_323;
        wp::vec_t<3, wp::float32> var_324;
        const wp::int32 var_325 = 0;
        wp::float32 var_326;
        const wp::int32 var_327 = 1;
        wp::float32 var_328;
        const wp::int32 var_329 = 2;
        wp::float32 var_330;
        const wp::int32 var_331 = 0;
        wp::float32 var_332;
        const wp::int32 var_333 = 0;
        wp::float32 var_334;
        wp::float32 var_335;
        const wp::int32 var_336 = 1;
        wp::float32 var_337;
        const wp::int32 var_338 = 1;
        wp::float32 var_339;
        wp::float32 var_340;
        const wp::int32 var_341 = 2;
        wp::float32 var_342;
        const wp::int32 var_343 = 2;
        wp::float32 var_344;
        wp::float32 var_345;
        wp::vec_t<3, wp::float32> var_346;
        const wp::int32 var_347 = 0;
        wp::float32 var_348;
        const wp::int32 var_349 = 0;
        wp::float32 var_350;
        wp::float32 var_351;
        const wp::int32 var_352 = 1;
        wp::float32 var_353;
        const wp::int32 var_354 = 1;
        wp::float32 var_355;
        wp::float32 var_356;
        const wp::int32 var_357 = 2;
        wp::float32 var_358;
        const wp::int32 var_359 = 2;
        wp::float32 var_360;
        wp::float32 var_361;
        wp::vec_t<3, wp::float32> var_362;
        wp::vec_t<3, wp::float32> var_363;
        wp::vec_t<3, wp::float32> var_364;
        wp::vec_t<3, wp::float32> var_365;
        const wp::int32 var_366 = 6;
        wp::int32 var_367;
        const wp::int32 var_368 = 1;
        wp::int32 var_369;
        const wp::int32 var_370 = 1;
        bool var_371;
        wp::int32 var_372;
        wp::vec_t<3, wp::float32>* var_373;
        wp::vec_t<3, wp::float32> var_374;
        wp::vec_t<3, wp::float32> var_375;
        const wp::int32 var_376 = 0;
        wp::float32 var_377;
        const wp::int32 var_378 = 1;
        wp::float32 var_379;
        const wp::int32 var_380 = 2;
        wp::float32 var_381;
        const wp::int32 var_382 = 0;
        wp::float32 var_383;
        const wp::int32 var_384 = 0;
        wp::float32 var_385;
        wp::float32 var_386;
        const wp::int32 var_387 = 1;
        wp::float32 var_388;
        const wp::int32 var_389 = 1;
        wp::float32 var_390;
        wp::float32 var_391;
        const wp::int32 var_392 = 2;
        wp::float32 var_393;
        const wp::int32 var_394 = 2;
        wp::float32 var_395;
        wp::float32 var_396;
        wp::vec_t<3, wp::float32> var_397;
        const wp::int32 var_398 = 0;
        wp::float32 var_399;
        const wp::int32 var_400 = 0;
        wp::float32 var_401;
        wp::float32 var_402;
        const wp::int32 var_403 = 1;
        wp::float32 var_404;
        const wp::int32 var_405 = 1;
        wp::float32 var_406;
        wp::float32 var_407;
        const wp::int32 var_408 = 2;
        wp::float32 var_409;
        const wp::int32 var_410 = 2;
        wp::float32 var_411;
        wp::float32 var_412;
        wp::vec_t<3, wp::float32> var_413;
        wp::vec_t<3, wp::float32> var_414;
        wp::vec_t<3, wp::float32> var_415;
        wp::vec_t<3, wp::float32> var_416;
        const wp::int32 var_417 = 7;
        wp::int32 var_418;
        const wp::int32 var_419 = 1;
        wp::int32 var_420;
        const wp::int32 var_421 = 1;
        bool var_422;
        wp::int32 var_423;
        wp::vec_t<3, wp::float32>* var_424;
        wp::vec_t<3, wp::float32> var_425;
        wp::vec_t<3, wp::float32> var_426;
        const wp::int32 var_427 = 0;
        wp::float32 var_428;
        const wp::int32 var_429 = 1;
        wp::float32 var_430;
        const wp::int32 var_431 = 2;
        wp::float32 var_432;
        const wp::int32 var_433 = 0;
        wp::float32 var_434;
        const wp::int32 var_435 = 0;
        wp::float32 var_436;
        wp::float32 var_437;
        const wp::int32 var_438 = 1;
        wp::float32 var_439;
        const wp::int32 var_440 = 1;
        wp::float32 var_441;
        wp::float32 var_442;
        const wp::int32 var_443 = 2;
        wp::float32 var_444;
        const wp::int32 var_445 = 2;
        wp::float32 var_446;
        wp::float32 var_447;
        wp::vec_t<3, wp::float32> var_448;
        const wp::int32 var_449 = 0;
        wp::float32 var_450;
        const wp::int32 var_451 = 0;
        wp::float32 var_452;
        wp::float32 var_453;
        const wp::int32 var_454 = 1;
        wp::float32 var_455;
        const wp::int32 var_456 = 1;
        wp::float32 var_457;
        wp::float32 var_458;
        const wp::int32 var_459 = 2;
        wp::float32 var_460;
        const wp::int32 var_461 = 2;
        wp::float32 var_462;
        wp::float32 var_463;
        wp::vec_t<3, wp::float32> var_464;
        wp::vec_t<3, wp::float32> var_465;
        wp::vec_t<3, wp::float32> var_466;
        wp::vec_t<3, wp::float32> var_467;
        //---------
        // forward
        // def unite_cores_kernel(cores__tree__count, cores__tree__root, cores__tree__levels, cores__tree__boxes, cores__tree__points, cores__max_sqdist, cores__owners, cores__lowest):       <L 1>
        // leaf = tid()                                                                           <L 2>
        var_0 = builtin_tid1d();
        // head = leaf * LEAF                                                                     <L 3>
        var_2 = wp::mul(var_0, var_1);
        // start = int(0)                                                                         <L 4>
        var_4 = wp::int(var_3);
        // left = int(0)                                                                          <L 5>
        var_6 = wp::int(var_5);
        // if cores__lowest[leaf] != NO_NUMBER:                                                   <L 6>
        var_7 = wp::address(var_cores__lowest, var_0);
        var_10 = wp::load(var_7);
        var_9 = (var_10 != var_8);
        if (var_9) {
            // start = dense_ancestor(leaf, cores__tree__root, cores__tree__levels, cores__tree__boxes, cores__max_sqdist)       <L 7>
            var_11 = dense_ancestor_0(var_0, var_cores__tree__root, var_cores__tree__levels, var_cores__tree__boxes, var_cores__max_sqdist);
            // if start > 0:                                                                      <L 8>
            var_13 = (var_11 > var_12);
            if (var_13) {
                // node = leaf >> FAN_BITS * start                                                <L 9>
                var_15 = wp::mul(var_14, var_11);
                var_16 = wp::rshift(var_0, var_15);
                // unite(cores__owners, cores__lowest[leaf], cores__lowest[cores__tree__levels[start] * FAN + node])       <L 10>
                var_17 = wp::address(var_cores__lowest, var_0);
                var_18 = wp::address(var_cores__tree__levels, var_11);
                var_21 = wp::load(var_18);
                var_20 = wp::mul(var_21, var_19);
                var_22 = wp::add(var_20, var_16);
                var_23 = wp::address(var_cores__lowest, var_22);
                var_25 = wp::load(var_17);
                var_26 = wp::load(var_23);
                var_24 = unite_0(var_cores__owners, var_25, var_26);
            }
            // for j in range(min(LEAF, cores__tree__count - head)):                              <L 11>
            var_27 = wp::sub(var_cores__tree__count, var_2);
            var_28 = wp::min(var_1, var_27);
            var_29 = wp::range(var_28);
            start_for_0:;
                if (iter_cmp(var_29) == 0) goto end_for_0;
                var_30 = wp::iter_next(var_29);
                // if cores__owners[head + j] >= 0:                                               <L 12>
                var_31 = wp::add(var_2, var_30);
                var_32 = wp::address(var_cores__owners, var_31);
                var_35 = wp::load(var_32);
                var_34 = (var_35 >= var_33);
                if (var_34) {
                    // left = left | 1 << j                                                       <L 13>
                    var_37 = wp::lshift(var_36, var_30);
                    var_38 = wp::bit_or(var_6, var_37);
                }
                var_39 = wp::where(var_34, var_38, var_6);
                wp::assign(var_6, var_39);
                goto start_for_0;
            end_for_0:;
        }
        var_40 = wp::where(var_9, var_11, var_4);
        // while left != 0:                                                                       <L 14>
        start_while_2:;
        var_42 = (var_6 != var_41);
        if ((var_42) == false) goto end_while_2;
            // core = head + lowest_bit(left)                                                     <L 15>
            var_43 = lowest_bit_0(var_6);
            var_44 = wp::add(var_2, var_43);
            // part = set_part(left, head, core, cores__owners)                                   <L 16>
            var_45 = set_part_0(var_6, var_2, var_44, var_cores__owners);
            // left = left ^ part                                                                 <L 17>
            var_46 = wp::bit_xor(var_6, var_45);
            // xs = lanes(INFINITY)                                                               <L 18>
            var_48 = wp::vec_t<8, wp::float32>(var_47);
            // ys = lanes(0.0)                                                                    <L 19>
            var_50 = wp::vec_t<8, wp::float32>(var_49);
            // zs = lanes(0.0)                                                                    <L 20>
            var_52 = wp::vec_t<8, wp::float32>(var_51);
            // a = cores__tree__points[core]                                                      <L 21>
            var_53 = wp::address(var_cores__tree__points, var_44);
            var_55 = wp::load(var_53);
            var_54 = wp::copy(var_55);
            // b = a + vec3(0.0, 0.0, 0.0)                                                        <L 22>
            var_59 = wp::vec_t<3, wp::float32>(var_56, var_57, var_58);
            var_60 = wp::add(var_54, var_59);
            // for j in range(LEAF):                                                              <L 23>
            // if part >> j & 1 == 1:                                                             <L 24>
            var_62 = wp::rshift(var_45, var_61);
            var_64 = wp::bit_and(var_62, var_63);
            var_66 = (var_64 == var_65);
            if (var_66) {
                // p = cores__tree__points[head + j]                                              <L 25>
                var_67 = wp::add(var_2, var_61);
                var_68 = wp::address(var_cores__tree__points, var_67);
                var_70 = wp::load(var_68);
                var_69 = wp::copy(var_70);
                // xs[j] = p[0]                                                                   <L 26>
                var_72 = wp::extract(var_69, var_71);
                wp::assign_inplace(var_48, var_61, var_72);
                // ys[j] = p[1]                                                                   <L 27>
                var_74 = wp::extract(var_69, var_73);
                wp::assign_inplace(var_50, var_61, var_74);
                // zs[j] = p[2]                                                                   <L 28>
                var_76 = wp::extract(var_69, var_75);
                wp::assign_inplace(var_52, var_61, var_76);
                // a = vec3(min(a[0], p[0]), min(a[1], p[1]), min(a[2], p[2]))                    <L 29>
                var_78 = wp::extract(var_54, var_77);
                var_80 = wp::extract(var_69, var_79);
                var_81 = wp::min(var_78, var_80);
                var_83 = wp::extract(var_54, var_82);
                var_85 = wp::extract(var_69, var_84);
                var_86 = wp::min(var_83, var_85);
                var_88 = wp::extract(var_54, var_87);
                var_90 = wp::extract(var_69, var_89);
                var_91 = wp::min(var_88, var_90);
                var_92 = wp::vec_t<3, wp::float32>(var_81, var_86, var_91);
                // b = vec3(max(b[0], p[0]), max(b[1], p[1]), max(b[2], p[2]))                    <L 30>
                var_94 = wp::extract(var_60, var_93);
                var_96 = wp::extract(var_69, var_95);
                var_97 = wp::max(var_94, var_96);
                var_99 = wp::extract(var_60, var_98);
                var_101 = wp::extract(var_69, var_100);
                var_102 = wp::max(var_99, var_101);
                var_104 = wp::extract(var_60, var_103);
                var_106 = wp::extract(var_69, var_105);
                var_107 = wp::max(var_104, var_106);
                var_108 = wp::vec_t<3, wp::float32>(var_97, var_102, var_107);
            }
            var_109 = wp::where(var_66, var_92, var_54);
            var_110 = wp::where(var_66, var_108, var_60);
            // if part >> j & 1 == 1:                                                             <L 24>
            var_112 = wp::rshift(var_45, var_111);
            var_114 = wp::bit_and(var_112, var_113);
            var_116 = (var_114 == var_115);
            if (var_116) {
                // p = cores__tree__points[head + j]                                              <L 25>
                var_117 = wp::add(var_2, var_111);
                var_118 = wp::address(var_cores__tree__points, var_117);
                var_120 = wp::load(var_118);
                var_119 = wp::copy(var_120);
                // xs[j] = p[0]                                                                   <L 26>
                var_122 = wp::extract(var_119, var_121);
                wp::assign_inplace(var_48, var_111, var_122);
                // ys[j] = p[1]                                                                   <L 27>
                var_124 = wp::extract(var_119, var_123);
                wp::assign_inplace(var_50, var_111, var_124);
                // zs[j] = p[2]                                                                   <L 28>
                var_126 = wp::extract(var_119, var_125);
                wp::assign_inplace(var_52, var_111, var_126);
                // a = vec3(min(a[0], p[0]), min(a[1], p[1]), min(a[2], p[2]))                    <L 29>
                var_128 = wp::extract(var_109, var_127);
                var_130 = wp::extract(var_119, var_129);
                var_131 = wp::min(var_128, var_130);
                var_133 = wp::extract(var_109, var_132);
                var_135 = wp::extract(var_119, var_134);
                var_136 = wp::min(var_133, var_135);
                var_138 = wp::extract(var_109, var_137);
                var_140 = wp::extract(var_119, var_139);
                var_141 = wp::min(var_138, var_140);
                var_142 = wp::vec_t<3, wp::float32>(var_131, var_136, var_141);
                // b = vec3(max(b[0], p[0]), max(b[1], p[1]), max(b[2], p[2]))                    <L 30>
                var_144 = wp::extract(var_110, var_143);
                var_146 = wp::extract(var_119, var_145);
                var_147 = wp::max(var_144, var_146);
                var_149 = wp::extract(var_110, var_148);
                var_151 = wp::extract(var_119, var_150);
                var_152 = wp::max(var_149, var_151);
                var_154 = wp::extract(var_110, var_153);
                var_156 = wp::extract(var_119, var_155);
                var_157 = wp::max(var_154, var_156);
                var_158 = wp::vec_t<3, wp::float32>(var_147, var_152, var_157);
            }
            var_159 = wp::where(var_116, var_142, var_109);
            var_160 = wp::where(var_116, var_158, var_110);
            var_161 = wp::where(var_116, var_119, var_69);
            // if part >> j & 1 == 1:                                                             <L 24>
            var_163 = wp::rshift(var_45, var_162);
            var_165 = wp::bit_and(var_163, var_164);
            var_167 = (var_165 == var_166);
            if (var_167) {
                // p = cores__tree__points[head + j]                                              <L 25>
                var_168 = wp::add(var_2, var_162);
                var_169 = wp::address(var_cores__tree__points, var_168);
                var_171 = wp::load(var_169);
                var_170 = wp::copy(var_171);
                // xs[j] = p[0]                                                                   <L 26>
                var_173 = wp::extract(var_170, var_172);
                wp::assign_inplace(var_48, var_162, var_173);
                // ys[j] = p[1]                                                                   <L 27>
                var_175 = wp::extract(var_170, var_174);
                wp::assign_inplace(var_50, var_162, var_175);
                // zs[j] = p[2]                                                                   <L 28>
                var_177 = wp::extract(var_170, var_176);
                wp::assign_inplace(var_52, var_162, var_177);
                // a = vec3(min(a[0], p[0]), min(a[1], p[1]), min(a[2], p[2]))                    <L 29>
                var_179 = wp::extract(var_159, var_178);
                var_181 = wp::extract(var_170, var_180);
                var_182 = wp::min(var_179, var_181);
                var_184 = wp::extract(var_159, var_183);
                var_186 = wp::extract(var_170, var_185);
                var_187 = wp::min(var_184, var_186);
                var_189 = wp::extract(var_159, var_188);
                var_191 = wp::extract(var_170, var_190);
                var_192 = wp::min(var_189, var_191);
                var_193 = wp::vec_t<3, wp::float32>(var_182, var_187, var_192);
                // b = vec3(max(b[0], p[0]), max(b[1], p[1]), max(b[2], p[2]))                    <L 30>
                var_195 = wp::extract(var_160, var_194);
                var_197 = wp::extract(var_170, var_196);
                var_198 = wp::max(var_195, var_197);
                var_200 = wp::extract(var_160, var_199);
                var_202 = wp::extract(var_170, var_201);
                var_203 = wp::max(var_200, var_202);
                var_205 = wp::extract(var_160, var_204);
                var_207 = wp::extract(var_170, var_206);
                var_208 = wp::max(var_205, var_207);
                var_209 = wp::vec_t<3, wp::float32>(var_198, var_203, var_208);
            }
            var_210 = wp::where(var_167, var_193, var_159);
            var_211 = wp::where(var_167, var_209, var_160);
            var_212 = wp::where(var_167, var_170, var_161);
            // if part >> j & 1 == 1:                                                             <L 24>
            var_214 = wp::rshift(var_45, var_213);
            var_216 = wp::bit_and(var_214, var_215);
            var_218 = (var_216 == var_217);
            if (var_218) {
                // p = cores__tree__points[head + j]                                              <L 25>
                var_219 = wp::add(var_2, var_213);
                var_220 = wp::address(var_cores__tree__points, var_219);
                var_222 = wp::load(var_220);
                var_221 = wp::copy(var_222);
                // xs[j] = p[0]                                                                   <L 26>
                var_224 = wp::extract(var_221, var_223);
                wp::assign_inplace(var_48, var_213, var_224);
                // ys[j] = p[1]                                                                   <L 27>
                var_226 = wp::extract(var_221, var_225);
                wp::assign_inplace(var_50, var_213, var_226);
                // zs[j] = p[2]                                                                   <L 28>
                var_228 = wp::extract(var_221, var_227);
                wp::assign_inplace(var_52, var_213, var_228);
                // a = vec3(min(a[0], p[0]), min(a[1], p[1]), min(a[2], p[2]))                    <L 29>
                var_230 = wp::extract(var_210, var_229);
                var_232 = wp::extract(var_221, var_231);
                var_233 = wp::min(var_230, var_232);
                var_235 = wp::extract(var_210, var_234);
                var_237 = wp::extract(var_221, var_236);
                var_238 = wp::min(var_235, var_237);
                var_240 = wp::extract(var_210, var_239);
                var_242 = wp::extract(var_221, var_241);
                var_243 = wp::min(var_240, var_242);
                var_244 = wp::vec_t<3, wp::float32>(var_233, var_238, var_243);
                // b = vec3(max(b[0], p[0]), max(b[1], p[1]), max(b[2], p[2]))                    <L 30>
                var_246 = wp::extract(var_211, var_245);
                var_248 = wp::extract(var_221, var_247);
                var_249 = wp::max(var_246, var_248);
                var_251 = wp::extract(var_211, var_250);
                var_253 = wp::extract(var_221, var_252);
                var_254 = wp::max(var_251, var_253);
                var_256 = wp::extract(var_211, var_255);
                var_258 = wp::extract(var_221, var_257);
                var_259 = wp::max(var_256, var_258);
                var_260 = wp::vec_t<3, wp::float32>(var_249, var_254, var_259);
            }
            var_261 = wp::where(var_218, var_244, var_210);
            var_262 = wp::where(var_218, var_260, var_211);
            var_263 = wp::where(var_218, var_221, var_212);
            // if part >> j & 1 == 1:                                                             <L 24>
            var_265 = wp::rshift(var_45, var_264);
            var_267 = wp::bit_and(var_265, var_266);
            var_269 = (var_267 == var_268);
            if (var_269) {
                // p = cores__tree__points[head + j]                                              <L 25>
                var_270 = wp::add(var_2, var_264);
                var_271 = wp::address(var_cores__tree__points, var_270);
                var_273 = wp::load(var_271);
                var_272 = wp::copy(var_273);
                // xs[j] = p[0]                                                                   <L 26>
                var_275 = wp::extract(var_272, var_274);
                wp::assign_inplace(var_48, var_264, var_275);
                // ys[j] = p[1]                                                                   <L 27>
                var_277 = wp::extract(var_272, var_276);
                wp::assign_inplace(var_50, var_264, var_277);
                // zs[j] = p[2]                                                                   <L 28>
                var_279 = wp::extract(var_272, var_278);
                wp::assign_inplace(var_52, var_264, var_279);
                // a = vec3(min(a[0], p[0]), min(a[1], p[1]), min(a[2], p[2]))                    <L 29>
                var_281 = wp::extract(var_261, var_280);
                var_283 = wp::extract(var_272, var_282);
                var_284 = wp::min(var_281, var_283);
                var_286 = wp::extract(var_261, var_285);
                var_288 = wp::extract(var_272, var_287);
                var_289 = wp::min(var_286, var_288);
                var_291 = wp::extract(var_261, var_290);
                var_293 = wp::extract(var_272, var_292);
                var_294 = wp::min(var_291, var_293);
                var_295 = wp::vec_t<3, wp::float32>(var_284, var_289, var_294);
                // b = vec3(max(b[0], p[0]), max(b[1], p[1]), max(b[2], p[2]))                    <L 30>
                var_297 = wp::extract(var_262, var_296);
                var_299 = wp::extract(var_272, var_298);
                var_300 = wp::max(var_297, var_299);
                var_302 = wp::extract(var_262, var_301);
                var_304 = wp::extract(var_272, var_303);
                var_305 = wp::max(var_302, var_304);
                var_307 = wp::extract(var_262, var_306);
                var_309 = wp::extract(var_272, var_308);
                var_310 = wp::max(var_307, var_309);
                var_311 = wp::vec_t<3, wp::float32>(var_300, var_305, var_310);
            }
            var_312 = wp::where(var_269, var_295, var_261);
            var_313 = wp::where(var_269, var_311, var_262);
            var_314 = wp::where(var_269, var_272, var_263);
            // if part >> j & 1 == 1:                                                             <L 24>
            var_316 = wp::rshift(var_45, var_315);
            var_318 = wp::bit_and(var_316, var_317);
            var_320 = (var_318 == var_319);
            if (var_320) {
                // p = cores__tree__points[head + j]                                              <L 25>
                var_321 = wp::add(var_2, var_315);
                var_322 = wp::address(var_cores__tree__points, var_321);
                var_324 = wp::load(var_322);
                var_323 = wp::copy(var_324);
                // xs[j] = p[0]                                                                   <L 26>
                var_326 = wp::extract(var_323, var_325);
                wp::assign_inplace(var_48, var_315, var_326);
                // ys[j] = p[1]                                                                   <L 27>
                var_328 = wp::extract(var_323, var_327);
                wp::assign_inplace(var_50, var_315, var_328);
                // zs[j] = p[2]                                                                   <L 28>
                var_330 = wp::extract(var_323, var_329);
                wp::assign_inplace(var_52, var_315, var_330);
                // a = vec3(min(a[0], p[0]), min(a[1], p[1]), min(a[2], p[2]))                    <L 29>
                var_332 = wp::extract(var_312, var_331);
                var_334 = wp::extract(var_323, var_333);
                var_335 = wp::min(var_332, var_334);
                var_337 = wp::extract(var_312, var_336);
                var_339 = wp::extract(var_323, var_338);
                var_340 = wp::min(var_337, var_339);
                var_342 = wp::extract(var_312, var_341);
                var_344 = wp::extract(var_323, var_343);
                var_345 = wp::min(var_342, var_344);
                var_346 = wp::vec_t<3, wp::float32>(var_335, var_340, var_345);
                // b = vec3(max(b[0], p[0]), max(b[1], p[1]), max(b[2], p[2]))                    <L 30>
                var_348 = wp::extract(var_313, var_347);
                var_350 = wp::extract(var_323, var_349);
                var_351 = wp::max(var_348, var_350);
                var_353 = wp::extract(var_313, var_352);
                var_355 = wp::extract(var_323, var_354);
                var_356 = wp::max(var_353, var_355);
                var_358 = wp::extract(var_313, var_357);
                var_360 = wp::extract(var_323, var_359);
                var_361 = wp::max(var_358, var_360);
                var_362 = wp::vec_t<3, wp::float32>(var_351, var_356, var_361);
            }
            var_363 = wp::where(var_320, var_346, var_312);
            var_364 = wp::where(var_320, var_362, var_313);
            var_365 = wp::where(var_320, var_323, var_314);
            // if part >> j & 1 == 1:                                                             <L 24>
            var_367 = wp::rshift(var_45, var_366);
            var_369 = wp::bit_and(var_367, var_368);
            var_371 = (var_369 == var_370);
            if (var_371) {
                // p = cores__tree__points[head + j]                                              <L 25>
                var_372 = wp::add(var_2, var_366);
                var_373 = wp::address(var_cores__tree__points, var_372);
                var_375 = wp::load(var_373);
                var_374 = wp::copy(var_375);
                // xs[j] = p[0]                                                                   <L 26>
                var_377 = wp::extract(var_374, var_376);
                wp::assign_inplace(var_48, var_366, var_377);
                // ys[j] = p[1]                                                                   <L 27>
                var_379 = wp::extract(var_374, var_378);
                wp::assign_inplace(var_50, var_366, var_379);
                // zs[j] = p[2]                                                                   <L 28>
                var_381 = wp::extract(var_374, var_380);
                wp::assign_inplace(var_52, var_366, var_381);
                // a = vec3(min(a[0], p[0]), min(a[1], p[1]), min(a[2], p[2]))                    <L 29>
                var_383 = wp::extract(var_363, var_382);
                var_385 = wp::extract(var_374, var_384);
                var_386 = wp::min(var_383, var_385);
                var_388 = wp::extract(var_363, var_387);
                var_390 = wp::extract(var_374, var_389);
                var_391 = wp::min(var_388, var_390);
                var_393 = wp::extract(var_363, var_392);
                var_395 = wp::extract(var_374, var_394);
                var_396 = wp::min(var_393, var_395);
                var_397 = wp::vec_t<3, wp::float32>(var_386, var_391, var_396);
                // b = vec3(max(b[0], p[0]), max(b[1], p[1]), max(b[2], p[2]))                    <L 30>
                var_399 = wp::extract(var_364, var_398);
                var_401 = wp::extract(var_374, var_400);
                var_402 = wp::max(var_399, var_401);
                var_404 = wp::extract(var_364, var_403);
                var_406 = wp::extract(var_374, var_405);
                var_407 = wp::max(var_404, var_406);
                var_409 = wp::extract(var_364, var_408);
                var_411 = wp::extract(var_374, var_410);
                var_412 = wp::max(var_409, var_411);
                var_413 = wp::vec_t<3, wp::float32>(var_402, var_407, var_412);
            }
            var_414 = wp::where(var_371, var_397, var_363);
            var_415 = wp::where(var_371, var_413, var_364);
            var_416 = wp::where(var_371, var_374, var_365);
            // if part >> j & 1 == 1:                                                             <L 24>
            var_418 = wp::rshift(var_45, var_417);
            var_420 = wp::bit_and(var_418, var_419);
            var_422 = (var_420 == var_421);
            if (var_422) {
                // p = cores__tree__points[head + j]                                              <L 25>
                var_423 = wp::add(var_2, var_417);
                var_424 = wp::address(var_cores__tree__points, var_423);
                var_426 = wp::load(var_424);
                var_425 = wp::copy(var_426);
                // xs[j] = p[0]                                                                   <L 26>
                var_428 = wp::extract(var_425, var_427);
                wp::assign_inplace(var_48, var_417, var_428);
                // ys[j] = p[1]                                                                   <L 27>
                var_430 = wp::extract(var_425, var_429);
                wp::assign_inplace(var_50, var_417, var_430);
                // zs[j] = p[2]                                                                   <L 28>
                var_432 = wp::extract(var_425, var_431);
                wp::assign_inplace(var_52, var_417, var_432);
                // a = vec3(min(a[0], p[0]), min(a[1], p[1]), min(a[2], p[2]))                    <L 29>
                var_434 = wp::extract(var_414, var_433);
                var_436 = wp::extract(var_425, var_435);
                var_437 = wp::min(var_434, var_436);
                var_439 = wp::extract(var_414, var_438);
                var_441 = wp::extract(var_425, var_440);
                var_442 = wp::min(var_439, var_441);
                var_444 = wp::extract(var_414, var_443);
                var_446 = wp::extract(var_425, var_445);
                var_447 = wp::min(var_444, var_446);
                var_448 = wp::vec_t<3, wp::float32>(var_437, var_442, var_447);
                // b = vec3(max(b[0], p[0]), max(b[1], p[1]), max(b[2], p[2]))                    <L 30>
                var_450 = wp::extract(var_415, var_449);
                var_452 = wp::extract(var_425, var_451);
                var_453 = wp::max(var_450, var_452);
                var_455 = wp::extract(var_415, var_454);
                var_457 = wp::extract(var_425, var_456);
                var_458 = wp::max(var_455, var_457);
                var_460 = wp::extract(var_415, var_459);
                var_462 = wp::extract(var_425, var_461);
                var_463 = wp::max(var_460, var_462);
                var_464 = wp::vec_t<3, wp::float32>(var_453, var_458, var_463);
            }
            var_465 = wp::where(var_422, var_448, var_414);
            var_466 = wp::where(var_422, var_464, var_415);
            var_467 = wp::where(var_422, var_425, var_416);
            // unite_part(core, xs, ys, zs, a, b, leaf, start, cores__tree__count, cores__tree__root, cores__tree__levels, cores__tree__boxes, cores__tree__points, cores__max_sqdist, cores__owners, cores__lowest)       <L 31>
            unite_part_0(var_44, var_48, var_50, var_52, var_465, var_466, var_0, var_40, var_cores__tree__count, var_cores__tree__root, var_cores__tree__levels, var_cores__tree__boxes, var_cores__tree__points, var_cores__max_sqdist, var_cores__owners, var_cores__lowest);
            wp::assign(var_6, var_46);
            wp::assign(var_30, var_417);
        goto start_while_2;
        end_while_2:;
}


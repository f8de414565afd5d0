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


// <pointloom.kernels.poses.overlap_evidence.agrees>:1
static CUDA_CALLABLE wp::int32 agrees_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__moved_normals,
    wp::array_t<wp::int64> var_overlap__nearest,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__normals,
    wp::float32 var_overlap__distance,
    wp::float32 var_overlap__cosine,
    wp::int32 var_i)
{
    //---------
    // primal vars
    wp::int64* var_0;
    wp::int64 var_1;
    wp::int64 var_2;
    const wp::int32 var_3 = 0;
    wp::int32 var_4;
    wp::float32 var_5;
    wp::float32 var_6;
    bool var_7;
    wp::vec_t<3, wp::float32>* var_8;
    wp::int32 var_9;
    wp::vec_t<3, wp::float32>* var_10;
    wp::float32 var_11;
    wp::vec_t<3, wp::float32> var_12;
    wp::vec_t<3, wp::float32> var_13;
    wp::float32 var_14;
    bool var_15;
    const wp::int32 var_16 = 1;
    wp::int32 var_17;
    wp::int32 var_18;
    //---------
    // forward
    // def agrees(overlap__moved_normals, overlap__nearest, overlap__normals, overlap__distance, overlap__cosine, i):       <L 1>
    // key = overlap__nearest[i]                                                              <L 3>
    var_0 = wp::address(var_overlap__nearest, var_i);
    var_2 = wp::load(var_0);
    var_1 = wp::copy(var_2);
    // agreeing = int(0)                                                                      <L 4>
    var_4 = wp::int(var_3);
    // if key_number(key) < overlap__distance * overlap__distance:                            <L 5>
    var_5 = key_number_0(var_1);
    var_6 = wp::mul(var_overlap__distance, var_overlap__distance);
    var_7 = (var_5 < var_6);
    if (var_7) {
        // if abs(dot(overlap__moved_normals[i], overlap__normals[key_index(key)])) > overlap__cosine:       <L 6>
        var_8 = wp::address(var_overlap__moved_normals, var_i);
        var_9 = key_index_0(var_1);
        var_10 = wp::address(var_overlap__normals, var_9);
        var_12 = wp::load(var_8);
        var_13 = wp::load(var_10);
        var_11 = wp::dot(var_12, var_13);
        var_14 = wp::abs(var_11);
        var_15 = (var_14 > var_overlap__cosine);
        if (var_15) {
            // agreeing = 1                                                                   <L 7>
        }
        var_17 = wp::where(var_15, var_16, var_4);
    }
    var_18 = wp::where(var_7, var_17, var_4);
    // return agreeing                                                                        <L 8>
    return var_18;
}


// <pointloom.kernels.poses.overlap_evidence.match_weight>:1
static CUDA_CALLABLE wp::float32 match_weight_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__moved,
    wp::array_t<wp::int64> var_overlap__nearest,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__normals,
    wp::float32 var_overlap__tight,
    wp::int32 var_i)
{
    //---------
    // primal vars
    wp::int64* var_0;
    wp::int32 var_1;
    wp::int64 var_2;
    wp::vec_t<3, wp::float32>* var_3;
    wp::vec_t<3, wp::float32>* var_4;
    wp::vec_t<3, wp::float32> var_5;
    wp::vec_t<3, wp::float32> var_6;
    wp::vec_t<3, wp::float32> var_7;
    wp::vec_t<3, wp::float32>* var_8;
    wp::float32 var_9;
    wp::vec_t<3, wp::float32> var_10;
    wp::float32 var_11;
    const wp::float32 var_12 = 1.0;
    wp::float32 var_13;
    wp::float32 var_14;
    const wp::float32 var_15 = 0.0;
    wp::float32 var_16;
    //---------
    // forward
    // def match_weight(overlap__moved, overlap__nearest, overlap__points, overlap__normals, overlap__tight, i):       <L 1>
    // row = key_index(overlap__nearest[i])                                                   <L 3>
    var_0 = wp::address(var_overlap__nearest, var_i);
    var_2 = wp::load(var_0);
    var_1 = key_index_0(var_2);
    // height = dot(overlap__moved[i] - overlap__points[row], overlap__normals[row]) / overlap__tight       <L 4>
    var_3 = wp::address(var_overlap__moved, var_i);
    var_4 = wp::address(var_overlap__points, var_1);
    var_6 = wp::load(var_3);
    var_7 = wp::load(var_4);
    var_5 = wp::sub(var_6, var_7);
    var_8 = wp::address(var_overlap__normals, var_1);
    var_10 = wp::load(var_8);
    var_9 = wp::dot(var_5, var_10);
    var_11 = wp::div(var_9, var_overlap__tight);
    // return max(1.0 - height * height, 0.0)                                                 <L 5>
    var_13 = wp::mul(var_11, var_11);
    var_14 = wp::sub(var_12, var_13);
    var_16 = wp::max(var_14, var_15);
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


// /work/main/src/pointloom/kernels/algebra/rigid_solve.py:301
static CUDA_CALLABLE wp::vec_t<3, wp::float64> move_0(
    wp::mat_t<4, 4, wp::float64> var_pose,
    wp::vec_t<3, wp::float64> var_p)
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
    const wp::int32 var_20 = 0;
    const wp::int32 var_21 = 3;
    wp::float64 var_22;
    wp::float64 var_23;
    const wp::int32 var_24 = 1;
    const wp::int32 var_25 = 0;
    wp::float64 var_26;
    const wp::int32 var_27 = 0;
    wp::float64 var_28;
    wp::float64 var_29;
    const wp::int32 var_30 = 1;
    const wp::int32 var_31 = 1;
    wp::float64 var_32;
    const wp::int32 var_33 = 1;
    wp::float64 var_34;
    wp::float64 var_35;
    wp::float64 var_36;
    const wp::int32 var_37 = 1;
    const wp::int32 var_38 = 2;
    wp::float64 var_39;
    const wp::int32 var_40 = 2;
    wp::float64 var_41;
    wp::float64 var_42;
    wp::float64 var_43;
    const wp::int32 var_44 = 1;
    const wp::int32 var_45 = 3;
    wp::float64 var_46;
    wp::float64 var_47;
    const wp::int32 var_48 = 2;
    const wp::int32 var_49 = 0;
    wp::float64 var_50;
    const wp::int32 var_51 = 0;
    wp::float64 var_52;
    wp::float64 var_53;
    const wp::int32 var_54 = 2;
    const wp::int32 var_55 = 1;
    wp::float64 var_56;
    const wp::int32 var_57 = 1;
    wp::float64 var_58;
    wp::float64 var_59;
    wp::float64 var_60;
    const wp::int32 var_61 = 2;
    const wp::int32 var_62 = 2;
    wp::float64 var_63;
    const wp::int32 var_64 = 2;
    wp::float64 var_65;
    wp::float64 var_66;
    wp::float64 var_67;
    const wp::int32 var_68 = 2;
    const wp::int32 var_69 = 3;
    wp::float64 var_70;
    wp::float64 var_71;
    wp::vec_t<3, wp::float64> var_72;
    //---------
    // forward
    // def move(pose: mat44d, p: vec3d) -> vec3d:                                             <L 302>
    // return vec3d(                                                                          <L 303>
    // pose[0, 0] * p[0] + pose[0, 1] * p[1] + pose[0, 2] * p[2] + pose[0, 3],                <L 304>
    var_2 = wp::extract(var_pose, var_0, var_1);
    var_4 = wp::extract(var_p, var_3);
    var_5 = wp::mul(var_2, var_4);
    var_8 = wp::extract(var_pose, var_6, var_7);
    var_10 = wp::extract(var_p, var_9);
    var_11 = wp::mul(var_8, var_10);
    var_12 = wp::add(var_5, var_11);
    var_15 = wp::extract(var_pose, var_13, var_14);
    var_17 = wp::extract(var_p, var_16);
    var_18 = wp::mul(var_15, var_17);
    var_19 = wp::add(var_12, var_18);
    var_22 = wp::extract(var_pose, var_20, var_21);
    var_23 = wp::add(var_19, var_22);
    // pose[1, 0] * p[0] + pose[1, 1] * p[1] + pose[1, 2] * p[2] + pose[1, 3],                <L 305>
    var_26 = wp::extract(var_pose, var_24, var_25);
    var_28 = wp::extract(var_p, var_27);
    var_29 = wp::mul(var_26, var_28);
    var_32 = wp::extract(var_pose, var_30, var_31);
    var_34 = wp::extract(var_p, var_33);
    var_35 = wp::mul(var_32, var_34);
    var_36 = wp::add(var_29, var_35);
    var_39 = wp::extract(var_pose, var_37, var_38);
    var_41 = wp::extract(var_p, var_40);
    var_42 = wp::mul(var_39, var_41);
    var_43 = wp::add(var_36, var_42);
    var_46 = wp::extract(var_pose, var_44, var_45);
    var_47 = wp::add(var_43, var_46);
    // pose[2, 0] * p[0] + pose[2, 1] * p[1] + pose[2, 2] * p[2] + pose[2, 3],                <L 306>
    var_50 = wp::extract(var_pose, var_48, var_49);
    var_52 = wp::extract(var_p, var_51);
    var_53 = wp::mul(var_50, var_52);
    var_56 = wp::extract(var_pose, var_54, var_55);
    var_58 = wp::extract(var_p, var_57);
    var_59 = wp::mul(var_56, var_58);
    var_60 = wp::add(var_53, var_59);
    var_63 = wp::extract(var_pose, var_61, var_62);
    var_65 = wp::extract(var_p, var_64);
    var_66 = wp::mul(var_63, var_65);
    var_67 = wp::add(var_60, var_66);
    var_70 = wp::extract(var_pose, var_68, var_69);
    var_71 = wp::add(var_67, var_70);
    var_72 = wp::vec_t<3, wp::float64>(var_23, var_47, var_71);
    return var_72;
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


// /work/main/src/pointloom/kernels/arrays/packed_keys.py:33
static CUDA_CALLABLE void adj_key_index_0(
    wp::int64 var_key,
    wp::int64 & adj_key,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.poses.overlap_evidence.agrees>:1
static CUDA_CALLABLE void adj_agrees_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__moved_normals,
    wp::array_t<wp::int64> var_overlap__nearest,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__normals,
    wp::float32 var_overlap__distance,
    wp::float32 var_overlap__cosine,
    wp::int32 var_i,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_overlap__moved_normals,
    wp::array_t<wp::int64> & adj_overlap__nearest,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_overlap__normals,
    wp::float32 & adj_overlap__distance,
    wp::float32 & adj_overlap__cosine,
    wp::int32 & adj_i,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.poses.overlap_evidence.match_weight>:1
static CUDA_CALLABLE void adj_match_weight_0(
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__moved,
    wp::array_t<wp::int64> var_overlap__nearest,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__normals,
    wp::float32 var_overlap__tight,
    wp::int32 var_i,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_overlap__moved,
    wp::array_t<wp::int64> & adj_overlap__nearest,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_overlap__points,
    wp::array_t<wp::vec_t<3, wp::float32>> & adj_overlap__normals,
    wp::float32 & adj_overlap__tight,
    wp::int32 & adj_i,
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


// /work/main/src/pointloom/kernels/algebra/transform.py:27
static CUDA_CALLABLE void adj_widen_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::float64> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/algebra/rigid_solve.py:301
static CUDA_CALLABLE void adj_move_0(
    wp::mat_t<4, 4, wp::float64> var_pose,
    wp::vec_t<3, wp::float64> var_p,
    wp::mat_t<4, 4, wp::float64> & adj_pose,
    wp::vec_t<3, wp::float64> & adj_p,
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



extern "C" __global__ void mask_matched_kernel_1042e029_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__moved,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__moved_normals,
    wp::array_t<wp::int64> var_overlap__nearest,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__normals,
    wp::float32 var_overlap__distance,
    wp::float32 var_overlap__cosine,
    wp::float32 var_overlap__tight,
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
        wp::int64* var_3;
        wp::int64 var_4;
        bool var_5;
        wp::int64 var_6;
        wp::int32 var_7;
        const wp::int32 var_8 = 1;
        bool var_9;
        wp::float32 var_10;
        const wp::float32 var_11 = 0.0;
        bool var_12;
        const wp::int32 var_13 = 1;
        wp::int32 var_14;
        wp::int32 var_15;
        wp::int32 var_16;
        wp::uint8 var_17;
        //---------
        // forward
        // def mask_matched_kernel(overlap__moved, overlap__moved_normals, overlap__nearest, overlap__points, overlap__normals, overlap__distance, overlap__cosine, overlap__tight, mask):       <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // matched = int(0)                                                                       <L 3>
        var_2 = wp::int(var_1);
        // if overlap__nearest[i] != int64(NO_POINT):                                             <L 4>
        var_3 = wp::address(var_overlap__nearest, var_0);
        var_4 = -1ll;
        var_6 = wp::load(var_3);
        var_5 = (var_6 != var_4);
        if (var_5) {
            // if agrees(overlap__moved_normals, overlap__nearest, overlap__normals, overlap__distance, overlap__cosine, i) == 1:       <L 5>
            var_7 = agrees_0(var_overlap__moved_normals, var_overlap__nearest, var_overlap__normals, var_overlap__distance, var_overlap__cosine, var_0);
            var_9 = (var_7 == var_8);
            if (var_9) {
                // if match_weight(overlap__moved, overlap__nearest, overlap__points, overlap__normals, overlap__tight, i) > 0.0:       <L 6>
                var_10 = match_weight_0(var_overlap__moved, var_overlap__nearest, var_overlap__points, var_overlap__normals, var_overlap__tight, var_0);
                var_12 = (var_10 > var_11);
                if (var_12) {
                    // matched = 1                                                                <L 7>
                }
                var_14 = wp::where(var_12, var_13, var_2);
            }
            var_15 = wp::where(var_9, var_14, var_2);
        }
        var_16 = wp::where(var_5, var_15, var_2);
        // mask[i] = uint8(matched)                                                               <L 8>
        var_17 = wp::uint8(var_16);
        wp::array_store(var_mask, var_0, var_17);
}



extern "C" __global__ void find_directions_kernel_3bb0a61d_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_planes__directions,
    wp::array_t<wp::int32> var_planes__count,
    wp::array_t<wp::vec_t<3, wp::float32>> var_directions,
    wp::array_t<wp::int32> var_count)
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
        wp::int32* var_4;
        wp::range_t var_5;
        wp::int32 var_6;
        wp::int32 var_7;
        wp::vec_t<3, wp::float32>* var_8;
        wp::vec_t<3, wp::float32> var_9;
        wp::vec_t<3, wp::float32> var_10;
        wp::range_t var_11;
        wp::int32 var_12;
        wp::vec_t<3, wp::float32>* var_13;
        wp::vec_t<3, wp::float32> var_14;
        wp::vec_t<3, wp::float32> var_15;
        wp::vec_t<3, wp::float32>* var_16;
        wp::vec_t<3, wp::float32> var_17;
        wp::vec_t<3, wp::float32> var_18;
        wp::float32 var_19;
        wp::float32 var_20;
        const wp::float32 var_21 = 0.17;
        bool var_22;
        wp::vec_t<3, wp::float32> var_23;
        const wp::float32 var_24 = 1.0;
        wp::float32 var_25;
        wp::float32 var_26;
        wp::vec_t<3, wp::float32> var_27;
        const wp::int32 var_28 = 1;
        wp::int32 var_29;
        wp::int32 var_30;
        //---------
        // forward
        // def find_directions_kernel(planes__directions, planes__count, directions, count):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // total = planes__count[i]                                                               <L 4>
        var_1 = wp::address(var_planes__count, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // for k in range(planes__count[i]):                                                      <L 5>
        var_4 = wp::address(var_planes__count, var_0);
        var_6 = wp::load(var_4);
        var_5 = wp::range(var_6);
        start_for_0:;
            if (iter_cmp(var_5) == 0) goto end_for_0;
            var_7 = wp::iter_next(var_5);
            // directions[k] = planes__directions[k]                                              <L 6>
            var_8 = wp::address(var_planes__directions, var_7);
            var_10 = wp::load(var_8);
            var_9 = wp::copy(var_10);
            wp::array_store(var_directions, var_7, var_9);
            // for j in range(k):                                                                 <L 7>
            var_11 = wp::range(var_7);
            start_for_2:;
                if (iter_cmp(var_11) == 0) goto end_for_2;
                var_12 = wp::iter_next(var_11);
                // a = planes__directions[k]                                                      <L 8>
                var_13 = wp::address(var_planes__directions, var_7);
                var_15 = wp::load(var_13);
                var_14 = wp::copy(var_15);
                // b = planes__directions[j]                                                      <L 9>
                var_16 = wp::address(var_planes__directions, var_12);
                var_18 = wp::load(var_16);
                var_17 = wp::copy(var_18);
                // if abs(dot(a, b)) < SQUARE:                                                    <L 10>
                var_19 = wp::dot(var_14, var_17);
                var_20 = wp::abs(var_19);
                var_22 = (var_20 < var_21);
                if (var_22) {
                    // third = cross(a, b)                                                        <L 11>
                    var_23 = wp::cross(var_14, var_17);
                    // directions[total] = third * (1.0 / length(third))                          <L 12>
                    var_25 = wp::length(var_23);
                    var_26 = wp::div(var_24, var_25);
                    var_27 = wp::mul(var_23, var_26);
                    wp::array_store(var_directions, var_2, var_27);
                    // total += 1                                                                 <L 13>
                    var_29 = wp::add(var_2, var_28);
                }
                var_30 = wp::where(var_22, var_29, var_2);
                wp::assign(var_2, var_30);
                goto start_for_2;
            end_for_2:;
            goto start_for_0;
        end_for_0:;
        // count[i] = total                                                                       <L 14>
        wp::array_store(var_count, var_0, var_2);
}



extern "C" __global__ void find_spreads_kernel_7df1ed08_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::int32 var_tree__count,
    wp::int32 var_tree__root,
    wp::array_t<wp::int32> var_tree__levels,
    wp::array_t<wp::float32> var_tree__boxes,
    wp::array_t<wp::vec_t<3, wp::float32>> var_tree__points,
    wp::array_t<wp::int32> var_tree__order,
    wp::array_t<wp::vec_t<3, wp::float32>> var_normals,
    wp::float32 var_radius,
    wp::array_t<wp::float32> var_spreads)
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
        wp::vec_t<3, wp::float32>* var_7;
        wp::vec_t<3, wp::float32> var_8;
        wp::vec_t<3, wp::float32> var_9;
        const wp::float32 var_10 = 0.0;
        wp::float32 var_11;
        const wp::float32 var_12 = 0.0;
        wp::float32 var_13;
        const wp::float32 var_14 = 0.0;
        wp::float32 var_15;
        const wp::int32 var_16 = 64;
        wp::int32 var_17;
        wp::vec_t<4, wp::int64> var_18;
        const wp::int32 var_19 = 0;
        wp::int64 var_20;
        wp::int32 var_21;
        bool var_22;
        const wp::int32 var_23 = 2;
        wp::int64 var_24;
        wp::int32 var_25;
        wp::vec_t<8, wp::float32> var_26;
        const wp::int32 var_27 = 0;
        wp::float32 var_28;
        bool var_29;
        const wp::int32 var_30 = 64;
        wp::int32 var_31;
        const wp::int32 var_32 = 8;
        wp::int32 var_33;
        wp::int32 var_34;
        const wp::int32 var_35 = 8;
        wp::int32 var_36;
        wp::int32 var_37;
        wp::range_t var_38;
        wp::int32 var_39;
        wp::vec_t<3, wp::float32>* var_40;
        wp::float32 var_41;
        wp::vec_t<3, wp::float32> var_42;
        bool var_43;
        wp::vec_t<3, wp::float32>* var_44;
        wp::vec_t<3, wp::float32> var_45;
        wp::vec_t<3, wp::float32> var_46;
        wp::float32 var_47;
        const wp::float32 var_48 = 1.0;
        wp::float32 var_49;
        wp::float32 var_50;
        wp::float32 var_51;
        wp::float32 var_52;
        wp::float32 var_53;
        wp::float32 var_54;
        wp::float32 var_55;
        const wp::int32 var_56 = 1;
        wp::float32 var_57;
        bool var_58;
        wp::int32 var_59;
        wp::int32 var_60;
        wp::int32 var_61;
        wp::int32 var_62;
        wp::int32 var_63;
        wp::range_t var_64;
        wp::int32 var_65;
        wp::vec_t<3, wp::float32>* var_66;
        wp::float32 var_67;
        wp::vec_t<3, wp::float32> var_68;
        bool var_69;
        wp::vec_t<3, wp::float32>* var_70;
        wp::vec_t<3, wp::float32> var_71;
        wp::vec_t<3, wp::float32> var_72;
        wp::float32 var_73;
        const wp::float32 var_74 = 1.0;
        wp::float32 var_75;
        wp::float32 var_76;
        wp::float32 var_77;
        wp::float32 var_78;
        wp::float32 var_79;
        wp::float32 var_80;
        wp::float32 var_81;
        wp::float32 var_82;
        wp::int32 var_83;
        wp::int32 var_84;
        const wp::int32 var_85 = 2;
        wp::float32 var_86;
        bool var_87;
        wp::int32 var_88;
        wp::int32 var_89;
        wp::int32 var_90;
        wp::int32 var_91;
        wp::int32 var_92;
        wp::range_t var_93;
        wp::int32 var_94;
        wp::vec_t<3, wp::float32>* var_95;
        wp::float32 var_96;
        wp::vec_t<3, wp::float32> var_97;
        bool var_98;
        wp::vec_t<3, wp::float32>* var_99;
        wp::vec_t<3, wp::float32> var_100;
        wp::vec_t<3, wp::float32> var_101;
        wp::float32 var_102;
        const wp::float32 var_103 = 1.0;
        wp::float32 var_104;
        wp::float32 var_105;
        wp::float32 var_106;
        wp::float32 var_107;
        wp::float32 var_108;
        wp::float32 var_109;
        wp::float32 var_110;
        wp::float32 var_111;
        wp::int32 var_112;
        wp::int32 var_113;
        const wp::int32 var_114 = 3;
        wp::float32 var_115;
        bool var_116;
        wp::int32 var_117;
        wp::int32 var_118;
        wp::int32 var_119;
        wp::int32 var_120;
        wp::int32 var_121;
        wp::range_t var_122;
        wp::int32 var_123;
        wp::vec_t<3, wp::float32>* var_124;
        wp::float32 var_125;
        wp::vec_t<3, wp::float32> var_126;
        bool var_127;
        wp::vec_t<3, wp::float32>* var_128;
        wp::vec_t<3, wp::float32> var_129;
        wp::vec_t<3, wp::float32> var_130;
        wp::float32 var_131;
        const wp::float32 var_132 = 1.0;
        wp::float32 var_133;
        wp::float32 var_134;
        wp::float32 var_135;
        wp::float32 var_136;
        wp::float32 var_137;
        wp::float32 var_138;
        wp::float32 var_139;
        wp::float32 var_140;
        wp::int32 var_141;
        wp::int32 var_142;
        const wp::int32 var_143 = 4;
        wp::float32 var_144;
        bool var_145;
        wp::int32 var_146;
        wp::int32 var_147;
        wp::int32 var_148;
        wp::int32 var_149;
        wp::int32 var_150;
        wp::range_t var_151;
        wp::int32 var_152;
        wp::vec_t<3, wp::float32>* var_153;
        wp::float32 var_154;
        wp::vec_t<3, wp::float32> var_155;
        bool var_156;
        wp::vec_t<3, wp::float32>* var_157;
        wp::vec_t<3, wp::float32> var_158;
        wp::vec_t<3, wp::float32> var_159;
        wp::float32 var_160;
        const wp::float32 var_161 = 1.0;
        wp::float32 var_162;
        wp::float32 var_163;
        wp::float32 var_164;
        wp::float32 var_165;
        wp::float32 var_166;
        wp::float32 var_167;
        wp::float32 var_168;
        wp::float32 var_169;
        wp::int32 var_170;
        wp::int32 var_171;
        const wp::int32 var_172 = 5;
        wp::float32 var_173;
        bool var_174;
        wp::int32 var_175;
        wp::int32 var_176;
        wp::int32 var_177;
        wp::int32 var_178;
        wp::int32 var_179;
        wp::range_t var_180;
        wp::int32 var_181;
        wp::vec_t<3, wp::float32>* var_182;
        wp::float32 var_183;
        wp::vec_t<3, wp::float32> var_184;
        bool var_185;
        wp::vec_t<3, wp::float32>* var_186;
        wp::vec_t<3, wp::float32> var_187;
        wp::vec_t<3, wp::float32> var_188;
        wp::float32 var_189;
        const wp::float32 var_190 = 1.0;
        wp::float32 var_191;
        wp::float32 var_192;
        wp::float32 var_193;
        wp::float32 var_194;
        wp::float32 var_195;
        wp::float32 var_196;
        wp::float32 var_197;
        wp::float32 var_198;
        wp::int32 var_199;
        wp::int32 var_200;
        const wp::int32 var_201 = 6;
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
        wp::float32 var_218;
        const wp::float32 var_219 = 1.0;
        wp::float32 var_220;
        wp::float32 var_221;
        wp::float32 var_222;
        wp::float32 var_223;
        wp::float32 var_224;
        wp::float32 var_225;
        wp::float32 var_226;
        wp::float32 var_227;
        wp::int32 var_228;
        wp::int32 var_229;
        const wp::int32 var_230 = 7;
        wp::float32 var_231;
        bool var_232;
        wp::int32 var_233;
        wp::int32 var_234;
        wp::int32 var_235;
        wp::int32 var_236;
        wp::int32 var_237;
        wp::range_t var_238;
        wp::int32 var_239;
        wp::vec_t<3, wp::float32>* var_240;
        wp::float32 var_241;
        wp::vec_t<3, wp::float32> var_242;
        bool var_243;
        wp::vec_t<3, wp::float32>* var_244;
        wp::vec_t<3, wp::float32> var_245;
        wp::vec_t<3, wp::float32> var_246;
        wp::float32 var_247;
        const wp::float32 var_248 = 1.0;
        wp::float32 var_249;
        wp::float32 var_250;
        wp::float32 var_251;
        wp::float32 var_252;
        wp::float32 var_253;
        wp::float32 var_254;
        wp::float32 var_255;
        wp::float32 var_256;
        wp::int32 var_257;
        wp::int32 var_258;
        wp::vec_t<4, wp::int64> var_259;
        wp::float32 var_260;
        wp::float32 var_261;
        wp::float32 var_262;
        wp::float32 var_263;
        const wp::float32 var_264 = 0.0;
        wp::float32 var_265;
        wp::float32 var_266;
        //---------
        // forward
        // def find_spreads_kernel(tree__count, tree__root, tree__levels, tree__boxes, tree__points, tree__order, normals, radius, spreads):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // row = tree__order[i]                                                                   <L 4>
        var_1 = wp::address(var_tree__order, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::copy(var_3);
        // p = tree__points[i]                                                                    <L 5>
        var_4 = wp::address(var_tree__points, var_0);
        var_6 = wp::load(var_4);
        var_5 = wp::copy(var_6);
        // n = normals[row]                                                                       <L 6>
        var_7 = wp::address(var_normals, var_2);
        var_9 = wp::load(var_7);
        var_8 = wp::copy(var_9);
        // count = float(0.0)                                                                     <L 7>
        var_11 = wp::float(var_10);
        // total = float(0.0)                                                                     <L 8>
        var_13 = wp::float(var_12);
        // squares = float(0.0)                                                                   <L 9>
        var_15 = wp::float(var_14);
        // start__points_within__1 = i // BUCKET                                                  <L 10>
        var_17 = wp::floordiv(var_0, var_16);
        // step__leaves_within__2 = start_traversal__leaves_within(start__points_within__1)       <L 11>
        var_18 = start_traversal_0(var_17);
        // while int(step__leaves_within__2[0]) <= tree__root:                                    <L 12>
        start_while_0:;
        var_20 = wp::extract(var_18, var_19);
        var_21 = wp::int(var_20);
        var_22 = (var_21 <= var_tree__root);
        if ((var_22) == false) goto end_while_0;
            // bucket__leaves_within__2 = int(step__leaves_within__2[2])                          <L 13>
            var_24 = wp::extract(var_18, var_23);
            var_25 = wp::int(var_24);
            // distances__leaves_within__2 = measure_boxes__leaves_within(tree__boxes, bucket__leaves_within__2, p, p)       <L 14>
            var_26 = measure_boxes_0(var_tree__boxes, var_25, var_5, var_5);
            // for leaf__leaves_within__2 in range(FAN__leaves_within):                           <L 15>
            // if distances__leaves_within__2[leaf__leaves_within__2] <= radius:                  <L 16>
            var_28 = wp::extract(var_26, var_27);
            var_29 = (var_28 <= var_radius);
            if (var_29) {
                // first__points_within__1 = bucket__leaves_within__2 * BUCKET__leaves_within + leaf__leaves_within__2 * LEAF__leaves_within       <L 17>
                var_31 = wp::mul(var_25, var_30);
                var_33 = wp::mul(var_27, var_32);
                var_34 = wp::add(var_31, var_33);
                // for j in range(first__points_within__1, min(first__points_within__1 + LEAF__points_within, tree__count)):       <L 18>
                var_36 = wp::add(var_34, var_35);
                var_37 = wp::min(var_36, var_tree__count);
                var_38 = wp::range(var_34, var_37);
                start_for_2:;
                    if (iter_cmp(var_38) == 0) goto end_for_2;
                    var_39 = wp::iter_next(var_38);
                    // _ = square_distance__points_within(p, tree__points[j])                     <L 19>
                    var_40 = wp::address(var_tree__points, var_39);
                    var_42 = wp::load(var_40);
                    var_41 = square_distance_0(var_5, var_42);
                    // if _ <= radius:                                                            <L 20>
                    var_43 = (var_41 <= var_radius);
                    if (var_43) {
                        // height = dot(n, tree__points[j] - p)                                   <L 21>
                        var_44 = wp::address(var_tree__points, var_39);
                        var_46 = wp::load(var_44);
                        var_45 = wp::sub(var_46, var_5);
                        var_47 = wp::dot(var_8, var_45);
                        // count += 1.0                                                           <L 22>
                        var_49 = wp::add(var_11, var_48);
                        // total += height                                                        <L 23>
                        var_50 = wp::add(var_13, var_47);
                        // squares += height * height                                             <L 24>
                        var_51 = wp::mul(var_47, var_47);
                        var_52 = wp::add(var_15, var_51);
                    }
                    var_53 = wp::where(var_43, var_49, var_11);
                    var_54 = wp::where(var_43, var_50, var_13);
                    var_55 = wp::where(var_43, var_52, var_15);
                    wp::assign(var_11, var_53);
                    wp::assign(var_13, var_54);
                    wp::assign(var_15, var_55);
                    goto start_for_2;
                end_for_2:;
            }
            // if distances__leaves_within__2[leaf__leaves_within__2] <= radius:                  <L 16>
            var_57 = wp::extract(var_26, var_56);
            var_58 = (var_57 <= var_radius);
            if (var_58) {
                // first__points_within__1 = bucket__leaves_within__2 * BUCKET__leaves_within + leaf__leaves_within__2 * LEAF__leaves_within       <L 17>
                var_59 = wp::mul(var_25, var_30);
                var_60 = wp::mul(var_56, var_32);
                var_61 = wp::add(var_59, var_60);
                // for j in range(first__points_within__1, min(first__points_within__1 + LEAF__points_within, tree__count)):       <L 18>
                var_62 = wp::add(var_61, var_35);
                var_63 = wp::min(var_62, var_tree__count);
                var_64 = wp::range(var_61, var_63);
                start_for_4:;
                    if (iter_cmp(var_64) == 0) goto end_for_4;
                    var_65 = wp::iter_next(var_64);
                    // _ = square_distance__points_within(p, tree__points[j])                     <L 19>
                    var_66 = wp::address(var_tree__points, var_65);
                    var_68 = wp::load(var_66);
                    var_67 = square_distance_0(var_5, var_68);
                    // if _ <= radius:                                                            <L 20>
                    var_69 = (var_67 <= var_radius);
                    if (var_69) {
                        // height = dot(n, tree__points[j] - p)                                   <L 21>
                        var_70 = wp::address(var_tree__points, var_65);
                        var_72 = wp::load(var_70);
                        var_71 = wp::sub(var_72, var_5);
                        var_73 = wp::dot(var_8, var_71);
                        // count += 1.0                                                           <L 22>
                        var_75 = wp::add(var_11, var_74);
                        // total += height                                                        <L 23>
                        var_76 = wp::add(var_13, var_73);
                        // squares += height * height                                             <L 24>
                        var_77 = wp::mul(var_73, var_73);
                        var_78 = wp::add(var_15, var_77);
                    }
                    var_79 = wp::where(var_69, var_75, var_11);
                    var_80 = wp::where(var_69, var_76, var_13);
                    var_81 = wp::where(var_69, var_78, var_15);
                    var_82 = wp::where(var_69, var_73, var_47);
                    wp::assign(var_11, var_79);
                    wp::assign(var_13, var_80);
                    wp::assign(var_15, var_81);
                    wp::assign(var_41, var_67);
                    wp::assign(var_47, var_82);
                    goto start_for_4;
                end_for_4:;
            }
            var_83 = wp::where(var_58, var_61, var_34);
            var_84 = wp::where(var_58, var_65, var_39);
            // if distances__leaves_within__2[leaf__leaves_within__2] <= radius:                  <L 16>
            var_86 = wp::extract(var_26, var_85);
            var_87 = (var_86 <= var_radius);
            if (var_87) {
                // first__points_within__1 = bucket__leaves_within__2 * BUCKET__leaves_within + leaf__leaves_within__2 * LEAF__leaves_within       <L 17>
                var_88 = wp::mul(var_25, var_30);
                var_89 = wp::mul(var_85, var_32);
                var_90 = wp::add(var_88, var_89);
                // for j in range(first__points_within__1, min(first__points_within__1 + LEAF__points_within, tree__count)):       <L 18>
                var_91 = wp::add(var_90, var_35);
                var_92 = wp::min(var_91, var_tree__count);
                var_93 = wp::range(var_90, var_92);
                start_for_6:;
                    if (iter_cmp(var_93) == 0) goto end_for_6;
                    var_94 = wp::iter_next(var_93);
                    // _ = square_distance__points_within(p, tree__points[j])                     <L 19>
                    var_95 = wp::address(var_tree__points, var_94);
                    var_97 = wp::load(var_95);
                    var_96 = square_distance_0(var_5, var_97);
                    // if _ <= radius:                                                            <L 20>
                    var_98 = (var_96 <= var_radius);
                    if (var_98) {
                        // height = dot(n, tree__points[j] - p)                                   <L 21>
                        var_99 = wp::address(var_tree__points, var_94);
                        var_101 = wp::load(var_99);
                        var_100 = wp::sub(var_101, var_5);
                        var_102 = wp::dot(var_8, var_100);
                        // count += 1.0                                                           <L 22>
                        var_104 = wp::add(var_11, var_103);
                        // total += height                                                        <L 23>
                        var_105 = wp::add(var_13, var_102);
                        // squares += height * height                                             <L 24>
                        var_106 = wp::mul(var_102, var_102);
                        var_107 = wp::add(var_15, var_106);
                    }
                    var_108 = wp::where(var_98, var_104, var_11);
                    var_109 = wp::where(var_98, var_105, var_13);
                    var_110 = wp::where(var_98, var_107, var_15);
                    var_111 = wp::where(var_98, var_102, var_47);
                    wp::assign(var_11, var_108);
                    wp::assign(var_13, var_109);
                    wp::assign(var_15, var_110);
                    wp::assign(var_41, var_96);
                    wp::assign(var_47, var_111);
                    goto start_for_6;
                end_for_6:;
            }
            var_112 = wp::where(var_87, var_90, var_83);
            var_113 = wp::where(var_87, var_94, var_84);
            // if distances__leaves_within__2[leaf__leaves_within__2] <= radius:                  <L 16>
            var_115 = wp::extract(var_26, var_114);
            var_116 = (var_115 <= var_radius);
            if (var_116) {
                // first__points_within__1 = bucket__leaves_within__2 * BUCKET__leaves_within + leaf__leaves_within__2 * LEAF__leaves_within       <L 17>
                var_117 = wp::mul(var_25, var_30);
                var_118 = wp::mul(var_114, var_32);
                var_119 = wp::add(var_117, var_118);
                // for j in range(first__points_within__1, min(first__points_within__1 + LEAF__points_within, tree__count)):       <L 18>
                var_120 = wp::add(var_119, var_35);
                var_121 = wp::min(var_120, var_tree__count);
                var_122 = wp::range(var_119, var_121);
                start_for_8:;
                    if (iter_cmp(var_122) == 0) goto end_for_8;
                    var_123 = wp::iter_next(var_122);
                    // _ = square_distance__points_within(p, tree__points[j])                     <L 19>
                    var_124 = wp::address(var_tree__points, var_123);
                    var_126 = wp::load(var_124);
                    var_125 = square_distance_0(var_5, var_126);
                    // if _ <= radius:                                                            <L 20>
                    var_127 = (var_125 <= var_radius);
                    if (var_127) {
                        // height = dot(n, tree__points[j] - p)                                   <L 21>
                        var_128 = wp::address(var_tree__points, var_123);
                        var_130 = wp::load(var_128);
                        var_129 = wp::sub(var_130, var_5);
                        var_131 = wp::dot(var_8, var_129);
                        // count += 1.0                                                           <L 22>
                        var_133 = wp::add(var_11, var_132);
                        // total += height                                                        <L 23>
                        var_134 = wp::add(var_13, var_131);
                        // squares += height * height                                             <L 24>
                        var_135 = wp::mul(var_131, var_131);
                        var_136 = wp::add(var_15, var_135);
                    }
                    var_137 = wp::where(var_127, var_133, var_11);
                    var_138 = wp::where(var_127, var_134, var_13);
                    var_139 = wp::where(var_127, var_136, var_15);
                    var_140 = wp::where(var_127, var_131, var_47);
                    wp::assign(var_11, var_137);
                    wp::assign(var_13, var_138);
                    wp::assign(var_15, var_139);
                    wp::assign(var_41, var_125);
                    wp::assign(var_47, var_140);
                    goto start_for_8;
                end_for_8:;
            }
            var_141 = wp::where(var_116, var_119, var_112);
            var_142 = wp::where(var_116, var_123, var_113);
            // if distances__leaves_within__2[leaf__leaves_within__2] <= radius:                  <L 16>
            var_144 = wp::extract(var_26, var_143);
            var_145 = (var_144 <= var_radius);
            if (var_145) {
                // first__points_within__1 = bucket__leaves_within__2 * BUCKET__leaves_within + leaf__leaves_within__2 * LEAF__leaves_within       <L 17>
                var_146 = wp::mul(var_25, var_30);
                var_147 = wp::mul(var_143, var_32);
                var_148 = wp::add(var_146, var_147);
                // for j in range(first__points_within__1, min(first__points_within__1 + LEAF__points_within, tree__count)):       <L 18>
                var_149 = wp::add(var_148, var_35);
                var_150 = wp::min(var_149, var_tree__count);
                var_151 = wp::range(var_148, var_150);
                start_for_10:;
                    if (iter_cmp(var_151) == 0) goto end_for_10;
                    var_152 = wp::iter_next(var_151);
                    // _ = square_distance__points_within(p, tree__points[j])                     <L 19>
                    var_153 = wp::address(var_tree__points, var_152);
                    var_155 = wp::load(var_153);
                    var_154 = square_distance_0(var_5, var_155);
                    // if _ <= radius:                                                            <L 20>
                    var_156 = (var_154 <= var_radius);
                    if (var_156) {
                        // height = dot(n, tree__points[j] - p)                                   <L 21>
                        var_157 = wp::address(var_tree__points, var_152);
                        var_159 = wp::load(var_157);
                        var_158 = wp::sub(var_159, var_5);
                        var_160 = wp::dot(var_8, var_158);
                        // count += 1.0                                                           <L 22>
                        var_162 = wp::add(var_11, var_161);
                        // total += height                                                        <L 23>
                        var_163 = wp::add(var_13, var_160);
                        // squares += height * height                                             <L 24>
                        var_164 = wp::mul(var_160, var_160);
                        var_165 = wp::add(var_15, var_164);
                    }
                    var_166 = wp::where(var_156, var_162, var_11);
                    var_167 = wp::where(var_156, var_163, var_13);
                    var_168 = wp::where(var_156, var_165, var_15);
                    var_169 = wp::where(var_156, var_160, var_47);
                    wp::assign(var_11, var_166);
                    wp::assign(var_13, var_167);
                    wp::assign(var_15, var_168);
                    wp::assign(var_41, var_154);
                    wp::assign(var_47, var_169);
                    goto start_for_10;
                end_for_10:;
            }
            var_170 = wp::where(var_145, var_148, var_141);
            var_171 = wp::where(var_145, var_152, var_142);
            // if distances__leaves_within__2[leaf__leaves_within__2] <= radius:                  <L 16>
            var_173 = wp::extract(var_26, var_172);
            var_174 = (var_173 <= var_radius);
            if (var_174) {
                // first__points_within__1 = bucket__leaves_within__2 * BUCKET__leaves_within + leaf__leaves_within__2 * LEAF__leaves_within       <L 17>
                var_175 = wp::mul(var_25, var_30);
                var_176 = wp::mul(var_172, var_32);
                var_177 = wp::add(var_175, var_176);
                // for j in range(first__points_within__1, min(first__points_within__1 + LEAF__points_within, tree__count)):       <L 18>
                var_178 = wp::add(var_177, var_35);
                var_179 = wp::min(var_178, var_tree__count);
                var_180 = wp::range(var_177, var_179);
                start_for_12:;
                    if (iter_cmp(var_180) == 0) goto end_for_12;
                    var_181 = wp::iter_next(var_180);
                    // _ = square_distance__points_within(p, tree__points[j])                     <L 19>
                    var_182 = wp::address(var_tree__points, var_181);
                    var_184 = wp::load(var_182);
                    var_183 = square_distance_0(var_5, var_184);
                    // if _ <= radius:                                                            <L 20>
                    var_185 = (var_183 <= var_radius);
                    if (var_185) {
                        // height = dot(n, tree__points[j] - p)                                   <L 21>
                        var_186 = wp::address(var_tree__points, var_181);
                        var_188 = wp::load(var_186);
                        var_187 = wp::sub(var_188, var_5);
                        var_189 = wp::dot(var_8, var_187);
                        // count += 1.0                                                           <L 22>
                        var_191 = wp::add(var_11, var_190);
                        // total += height                                                        <L 23>
                        var_192 = wp::add(var_13, var_189);
                        // squares += height * height                                             <L 24>
                        var_193 = wp::mul(var_189, var_189);
                        var_194 = wp::add(var_15, var_193);
                    }
                    var_195 = wp::where(var_185, var_191, var_11);
                    var_196 = wp::where(var_185, var_192, var_13);
                    var_197 = wp::where(var_185, var_194, var_15);
                    var_198 = wp::where(var_185, var_189, var_47);
                    wp::assign(var_11, var_195);
                    wp::assign(var_13, var_196);
                    wp::assign(var_15, var_197);
                    wp::assign(var_41, var_183);
                    wp::assign(var_47, var_198);
                    goto start_for_12;
                end_for_12:;
            }
            var_199 = wp::where(var_174, var_177, var_170);
            var_200 = wp::where(var_174, var_181, var_171);
            // if distances__leaves_within__2[leaf__leaves_within__2] <= radius:                  <L 16>
            var_202 = wp::extract(var_26, var_201);
            var_203 = (var_202 <= var_radius);
            if (var_203) {
                // first__points_within__1 = bucket__leaves_within__2 * BUCKET__leaves_within + leaf__leaves_within__2 * LEAF__leaves_within       <L 17>
                var_204 = wp::mul(var_25, var_30);
                var_205 = wp::mul(var_201, var_32);
                var_206 = wp::add(var_204, var_205);
                // for j in range(first__points_within__1, min(first__points_within__1 + LEAF__points_within, tree__count)):       <L 18>
                var_207 = wp::add(var_206, var_35);
                var_208 = wp::min(var_207, var_tree__count);
                var_209 = wp::range(var_206, var_208);
                start_for_14:;
                    if (iter_cmp(var_209) == 0) goto end_for_14;
                    var_210 = wp::iter_next(var_209);
                    // _ = square_distance__points_within(p, tree__points[j])                     <L 19>
                    var_211 = wp::address(var_tree__points, var_210);
                    var_213 = wp::load(var_211);
                    var_212 = square_distance_0(var_5, var_213);
                    // if _ <= radius:                                                            <L 20>
                    var_214 = (var_212 <= var_radius);
                    if (var_214) {
                        // height = dot(n, tree__points[j] - p)                                   <L 21>
                        var_215 = wp::address(var_tree__points, var_210);
                        var_217 = wp::load(var_215);
                        var_216 = wp::sub(var_217, var_5);
                        var_218 = wp::dot(var_8, var_216);
                        // count += 1.0                                                           <L 22>
                        var_220 = wp::add(var_11, var_219);
                        // total += height                                                        <L 23>
                        var_221 = wp::add(var_13, var_218);
                        // squares += height * height                                             <L 24>
                        var_222 = wp::mul(var_218, var_218);
                        var_223 = wp::add(var_15, var_222);
                    }
                    var_224 = wp::where(var_214, var_220, var_11);
                    var_225 = wp::where(var_214, var_221, var_13);
                    var_226 = wp::where(var_214, var_223, var_15);
                    var_227 = wp::where(var_214, var_218, var_47);
                    wp::assign(var_11, var_224);
                    wp::assign(var_13, var_225);
                    wp::assign(var_15, var_226);
                    wp::assign(var_41, var_212);
                    wp::assign(var_47, var_227);
                    goto start_for_14;
                end_for_14:;
            }
            var_228 = wp::where(var_203, var_206, var_199);
            var_229 = wp::where(var_203, var_210, var_200);
            // if distances__leaves_within__2[leaf__leaves_within__2] <= radius:                  <L 16>
            var_231 = wp::extract(var_26, var_230);
            var_232 = (var_231 <= var_radius);
            if (var_232) {
                // first__points_within__1 = bucket__leaves_within__2 * BUCKET__leaves_within + leaf__leaves_within__2 * LEAF__leaves_within       <L 17>
                var_233 = wp::mul(var_25, var_30);
                var_234 = wp::mul(var_230, var_32);
                var_235 = wp::add(var_233, var_234);
                // for j in range(first__points_within__1, min(first__points_within__1 + LEAF__points_within, tree__count)):       <L 18>
                var_236 = wp::add(var_235, var_35);
                var_237 = wp::min(var_236, var_tree__count);
                var_238 = wp::range(var_235, var_237);
                start_for_16:;
                    if (iter_cmp(var_238) == 0) goto end_for_16;
                    var_239 = wp::iter_next(var_238);
                    // _ = square_distance__points_within(p, tree__points[j])                     <L 19>
                    var_240 = wp::address(var_tree__points, var_239);
                    var_242 = wp::load(var_240);
                    var_241 = square_distance_0(var_5, var_242);
                    // if _ <= radius:                                                            <L 20>
                    var_243 = (var_241 <= var_radius);
                    if (var_243) {
                        // height = dot(n, tree__points[j] - p)                                   <L 21>
                        var_244 = wp::address(var_tree__points, var_239);
                        var_246 = wp::load(var_244);
                        var_245 = wp::sub(var_246, var_5);
                        var_247 = wp::dot(var_8, var_245);
                        // count += 1.0                                                           <L 22>
                        var_249 = wp::add(var_11, var_248);
                        // total += height                                                        <L 23>
                        var_250 = wp::add(var_13, var_247);
                        // squares += height * height                                             <L 24>
                        var_251 = wp::mul(var_247, var_247);
                        var_252 = wp::add(var_15, var_251);
                    }
                    var_253 = wp::where(var_243, var_249, var_11);
                    var_254 = wp::where(var_243, var_250, var_13);
                    var_255 = wp::where(var_243, var_252, var_15);
                    var_256 = wp::where(var_243, var_247, var_47);
                    wp::assign(var_11, var_253);
                    wp::assign(var_13, var_254);
                    wp::assign(var_15, var_255);
                    wp::assign(var_41, var_241);
                    wp::assign(var_47, var_256);
                    goto start_for_16;
                end_for_16:;
            }
            var_257 = wp::where(var_232, var_235, var_228);
            var_258 = wp::where(var_232, var_239, var_229);
            // step__leaves_within__2 = next_bucket__leaves_within(step__leaves_within__2, p, p, radius, tree__root, tree__levels, tree__boxes)       <L 25>
            var_259 = next_bucket_0(var_18, var_5, var_5, var_radius, var_tree__root, var_tree__levels, var_tree__boxes);
            wp::assign(var_18, var_259);
        goto start_while_0;
        end_while_0:;
        // mean = total / count                                                                   <L 26>
        var_260 = wp::div(var_13, var_11);
        // spreads[row] = sqrt(max(squares / count - mean * mean, 0.0))                           <L 27>
        var_261 = wp::div(var_15, var_11);
        var_262 = wp::mul(var_260, var_260);
        var_263 = wp::sub(var_261, var_262);
        var_265 = wp::max(var_263, var_264);
        var_266 = wp::sqrt(var_265);
        wp::array_store(var_spreads, var_2, var_266);
}



extern "C" __global__ void find_middle_kernel_8e27b83f_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<5, wp::float64>> var_total,
    wp::array_t<wp::vec_t<3, wp::float64>> var_overlap__middle,
    wp::array_t<wp::float64> var_overlap__scale)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::vec_t<5, wp::float64>* var_1;
        const wp::int32 var_2 = 0;
        wp::float64 var_3;
        wp::vec_t<5, wp::float64> var_4;
        wp::float64 var_5;
        wp::float64 var_6;
        wp::vec_t<5, wp::float64>* var_7;
        const wp::int32 var_8 = 1;
        wp::float64 var_9;
        wp::vec_t<5, wp::float64> var_10;
        wp::float64 var_11;
        wp::vec_t<5, wp::float64>* var_12;
        const wp::int32 var_13 = 2;
        wp::float64 var_14;
        wp::vec_t<5, wp::float64> var_15;
        wp::float64 var_16;
        wp::vec_t<5, wp::float64>* var_17;
        const wp::int32 var_18 = 3;
        wp::float64 var_19;
        wp::vec_t<5, wp::float64> var_20;
        wp::float64 var_21;
        wp::vec_t<3, wp::float64> var_22;
        wp::vec_t<5, wp::float64>* var_23;
        const wp::int32 var_24 = 4;
        wp::float64 var_25;
        wp::vec_t<5, wp::float64> var_26;
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
        //---------
        // forward
        // def find_middle_kernel(total, overlap__middle, overlap__scale):                        <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // points = max(total[i][0], float64(1.0))                                                <L 4>
        var_1 = wp::address(var_total, var_0);
        var_4 = wp::load(var_1);
        var_3 = wp::extract(var_4, var_2);
        var_5 = 1.0;
        var_6 = wp::max(var_3, var_5);
        // middle = vec3d(total[i][1] / points, total[i][2] / points, total[i][3] / points)       <L 5>
        var_7 = wp::address(var_total, var_0);
        var_10 = wp::load(var_7);
        var_9 = wp::extract(var_10, var_8);
        var_11 = wp::div(var_9, var_6);
        var_12 = wp::address(var_total, var_0);
        var_15 = wp::load(var_12);
        var_14 = wp::extract(var_15, var_13);
        var_16 = wp::div(var_14, var_6);
        var_17 = wp::address(var_total, var_0);
        var_20 = wp::load(var_17);
        var_19 = wp::extract(var_20, var_18);
        var_21 = wp::div(var_19, var_6);
        var_22 = wp::vec_t<3, wp::float64>(var_11, var_16, var_21);
        // radius = sqrt(max(total[i][4] / points - dot(middle, middle), float64(0.0)))           <L 6>
        var_23 = wp::address(var_total, var_0);
        var_26 = wp::load(var_23);
        var_25 = wp::extract(var_26, var_24);
        var_27 = wp::div(var_25, var_6);
        var_28 = wp::dot(var_22, var_22);
        var_29 = wp::sub(var_27, var_28);
        var_30 = 0.0;
        var_31 = wp::max(var_29, var_30);
        var_32 = wp::sqrt(var_31);
        // overlap__middle[i] = middle                                                            <L 7>
        wp::array_store(var_overlap__middle, var_0, var_22);
        // overlap__scale[i] = float64(1.0) / max(radius, float64(1e-30))                         <L 8>
        var_33 = 1.0;
        var_34 = 1e-30;
        var_35 = wp::max(var_32, var_34);
        var_36 = wp::div(var_33, var_35);
        wp::array_store(var_overlap__scale, var_0, var_36);
}



extern "C" __global__ void move_surface_kernel_af30508c_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_normals,
    wp::mat_t<4, 4, wp::float64> var_pose,
    wp::array_t<wp::vec_t<3, wp::float32>> var_moved,
    wp::array_t<wp::vec_t<3, wp::float32>> var_moved_normals)
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
        wp::vec_t<3, wp::float64> var_2;
        wp::vec_t<3, wp::float32> var_3;
        wp::vec_t<3, wp::float64> var_4;
        wp::vec_t<3, wp::float32> var_5;
        wp::vec_t<3, wp::float32>* var_6;
        wp::vec_t<3, wp::float64> var_7;
        wp::vec_t<3, wp::float32> var_8;
        wp::vec_t<3, wp::float64> var_9;
        wp::vec_t<3, wp::float32> var_10;
        //---------
        // forward
        // def move_surface_kernel(                                                               <L 65>
        // i = tid()                                                                              <L 72>
        var_0 = builtin_tid1d();
        // moved[i] = narrow(move(pose, widen(points[i])))                                        <L 73>
        var_1 = wp::address(var_points, var_0);
        var_3 = wp::load(var_1);
        var_2 = widen_0(var_3);
        var_4 = move_0(var_pose, var_2);
        var_5 = narrow_0(var_4);
        wp::array_store(var_moved, var_0, var_5);
        // moved_normals[i] = narrow(rotate(pose, widen(normals[i])))                             <L 74>
        var_6 = wp::address(var_normals, var_0);
        var_8 = wp::load(var_6);
        var_7 = widen_0(var_8);
        var_9 = rotate_1(var_pose, var_7);
        var_10 = narrow_0(var_9);
        wp::array_store(var_moved_normals, var_0, var_10);
}



extern "C" __global__ void leave_out_border_kernel_fb7da2c8_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__moved,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_overlap__normals,
    wp::float32 var_overlap__distance,
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
        wp::int64* var_1;
        wp::int64 var_2;
        bool var_3;
        wp::int64 var_4;
        wp::int64* var_5;
        wp::int32 var_6;
        wp::int64 var_7;
        wp::vec_t<3, wp::float32>* var_8;
        wp::vec_t<3, wp::float32>* var_9;
        wp::vec_t<3, wp::float32> var_10;
        wp::vec_t<3, wp::float32> var_11;
        wp::vec_t<3, wp::float32> var_12;
        wp::vec_t<3, wp::float32>* var_13;
        wp::float32 var_14;
        wp::vec_t<3, wp::float32> var_15;
        wp::float32 var_16;
        wp::float32 var_17;
        wp::float32 var_18;
        wp::float32 var_19;
        bool var_20;
        wp::int64 var_21;
        //---------
        // forward
        // def leave_out_border_kernel(overlap__moved, overlap__points, overlap__normals, overlap__distance, nearest):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // if nearest[i] != int64(NO_POINT):                                                      <L 4>
        var_1 = wp::address(var_nearest, var_0);
        var_2 = -1ll;
        var_4 = wp::load(var_1);
        var_3 = (var_4 != var_2);
        if (var_3) {
            // row = key_index(nearest[i])                                                        <L 5>
            var_5 = wp::address(var_nearest, var_0);
            var_7 = wp::load(var_5);
            var_6 = key_index_0(var_7);
            // offset = overlap__moved[i] - overlap__points[row]                                  <L 6>
            var_8 = wp::address(var_overlap__moved, var_0);
            var_9 = wp::address(var_overlap__points, var_6);
            var_11 = wp::load(var_8);
            var_12 = wp::load(var_9);
            var_10 = wp::sub(var_11, var_12);
            // height = dot(offset, overlap__normals[row])                                        <L 7>
            var_13 = wp::address(var_overlap__normals, var_6);
            var_15 = wp::load(var_13);
            var_14 = wp::dot(var_10, var_15);
            // if dot(offset, offset) - height * height > overlap__distance * overlap__distance:       <L 8>
            var_16 = wp::dot(var_10, var_10);
            var_17 = wp::mul(var_14, var_14);
            var_18 = wp::sub(var_16, var_17);
            var_19 = wp::mul(var_overlap__distance, var_overlap__distance);
            var_20 = (var_18 > var_19);
            if (var_20) {
                // nearest[i] = int64(NO_POINT)                                                   <L 9>
                var_21 = wp::int64(var_2);
                wp::array_store(var_nearest, var_0, var_21);
            }
        }
}


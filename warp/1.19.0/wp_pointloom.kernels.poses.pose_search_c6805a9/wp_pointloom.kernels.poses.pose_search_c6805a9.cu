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



extern "C" __global__ void rank_keys_kernel_334767c4_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_scores,
    wp::int32 var_max_score,
    wp::array_t<wp::int64> var_keys)
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
        wp::int64 var_4;
        //---------
        // forward
        // def rank_keys_kernel(scores: array(dtype=int32), max_score: int, keys: array(dtype=int64)):       <L 39>
        // i = tid()                                                                              <L 41>
        var_0 = builtin_tid1d();
        // keys[i] = int64(max_score - scores[i])                                                 <L 42>
        var_1 = wp::address(var_scores, var_0);
        var_3 = wp::load(var_1);
        var_2 = wp::sub(var_max_score, var_3);
        var_4 = wp::int64(var_2);
        wp::array_store(var_keys, var_0, var_4);
}



extern "C" __global__ void mark_contenders_kernel_713fe425_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::mat_t<4, 4, wp::float64>> var_poses,
    wp::array_t<wp::float64> var_scores,
    wp::array_t<wp::int32> var_distinct_count,
    wp::int32 var_best_inliers,
    wp::array_t<wp::int32> var_contends,
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
        wp::float64 var_1;
        const wp::int32 var_2 = 0;
        wp::int32* var_3;
        wp::range_t var_4;
        wp::int32 var_5;
        wp::int32 var_6;
        const wp::int32 var_7 = 0;
        wp::float64* var_8;
        wp::float64 var_9;
        wp::float64 var_10;
        bool var_11;
        const wp::int32 var_12 = 0;
        wp::int32* var_13;
        bool var_14;
        wp::int32 var_15;
        const wp::int32 var_16 = 0;
        wp::float64* var_17;
        wp::float64 var_18;
        wp::float64 var_19;
        bool var_20;
        wp::float64 var_21;
        const wp::int32 var_22 = 1;
        const wp::int32 var_23 = 0;
        wp::int32 var_24;
        wp::range_t var_25;
        wp::int32 var_26;
        const wp::int32 var_27 = 1;
        wp::int32 var_28;
        const wp::int32 var_29 = 0;
        const wp::int32 var_30 = 0;
        wp::mat_t<4, 4, wp::float64>* var_31;
        wp::float64 var_32;
        wp::mat_t<4, 4, wp::float64> var_33;
        wp::mat_t<4, 4, wp::float64>* var_34;
        wp::float64 var_35;
        wp::mat_t<4, 4, wp::float64> var_36;
        bool var_37;
        const wp::int32 var_38 = 0;
        wp::int32 var_39;
        const wp::int32 var_40 = 1;
        wp::mat_t<4, 4, wp::float64>* var_41;
        wp::float64 var_42;
        wp::mat_t<4, 4, wp::float64> var_43;
        wp::mat_t<4, 4, wp::float64>* var_44;
        wp::float64 var_45;
        wp::mat_t<4, 4, wp::float64> var_46;
        bool var_47;
        const wp::int32 var_48 = 0;
        wp::int32 var_49;
        const wp::int32 var_50 = 2;
        wp::mat_t<4, 4, wp::float64>* var_51;
        wp::float64 var_52;
        wp::mat_t<4, 4, wp::float64> var_53;
        wp::mat_t<4, 4, wp::float64>* var_54;
        wp::float64 var_55;
        wp::mat_t<4, 4, wp::float64> var_56;
        bool var_57;
        const wp::int32 var_58 = 0;
        wp::int32 var_59;
        const wp::int32 var_60 = 3;
        wp::mat_t<4, 4, wp::float64>* var_61;
        wp::float64 var_62;
        wp::mat_t<4, 4, wp::float64> var_63;
        wp::mat_t<4, 4, wp::float64>* var_64;
        wp::float64 var_65;
        wp::mat_t<4, 4, wp::float64> var_66;
        bool var_67;
        const wp::int32 var_68 = 0;
        wp::int32 var_69;
        const wp::int32 var_70 = 1;
        const wp::int32 var_71 = 0;
        wp::mat_t<4, 4, wp::float64>* var_72;
        wp::float64 var_73;
        wp::mat_t<4, 4, wp::float64> var_74;
        wp::mat_t<4, 4, wp::float64>* var_75;
        wp::float64 var_76;
        wp::mat_t<4, 4, wp::float64> var_77;
        bool var_78;
        const wp::int32 var_79 = 0;
        wp::int32 var_80;
        const wp::int32 var_81 = 1;
        wp::mat_t<4, 4, wp::float64>* var_82;
        wp::float64 var_83;
        wp::mat_t<4, 4, wp::float64> var_84;
        wp::mat_t<4, 4, wp::float64>* var_85;
        wp::float64 var_86;
        wp::mat_t<4, 4, wp::float64> var_87;
        bool var_88;
        const wp::int32 var_89 = 0;
        wp::int32 var_90;
        const wp::int32 var_91 = 2;
        wp::mat_t<4, 4, wp::float64>* var_92;
        wp::float64 var_93;
        wp::mat_t<4, 4, wp::float64> var_94;
        wp::mat_t<4, 4, wp::float64>* var_95;
        wp::float64 var_96;
        wp::mat_t<4, 4, wp::float64> var_97;
        bool var_98;
        const wp::int32 var_99 = 0;
        wp::int32 var_100;
        const wp::int32 var_101 = 3;
        wp::mat_t<4, 4, wp::float64>* var_102;
        wp::float64 var_103;
        wp::mat_t<4, 4, wp::float64> var_104;
        wp::mat_t<4, 4, wp::float64>* var_105;
        wp::float64 var_106;
        wp::mat_t<4, 4, wp::float64> var_107;
        bool var_108;
        const wp::int32 var_109 = 0;
        wp::int32 var_110;
        const wp::int32 var_111 = 2;
        const wp::int32 var_112 = 0;
        wp::mat_t<4, 4, wp::float64>* var_113;
        wp::float64 var_114;
        wp::mat_t<4, 4, wp::float64> var_115;
        wp::mat_t<4, 4, wp::float64>* var_116;
        wp::float64 var_117;
        wp::mat_t<4, 4, wp::float64> var_118;
        bool var_119;
        const wp::int32 var_120 = 0;
        wp::int32 var_121;
        const wp::int32 var_122 = 1;
        wp::mat_t<4, 4, wp::float64>* var_123;
        wp::float64 var_124;
        wp::mat_t<4, 4, wp::float64> var_125;
        wp::mat_t<4, 4, wp::float64>* var_126;
        wp::float64 var_127;
        wp::mat_t<4, 4, wp::float64> var_128;
        bool var_129;
        const wp::int32 var_130 = 0;
        wp::int32 var_131;
        const wp::int32 var_132 = 2;
        wp::mat_t<4, 4, wp::float64>* var_133;
        wp::float64 var_134;
        wp::mat_t<4, 4, wp::float64> var_135;
        wp::mat_t<4, 4, wp::float64>* var_136;
        wp::float64 var_137;
        wp::mat_t<4, 4, wp::float64> var_138;
        bool var_139;
        const wp::int32 var_140 = 0;
        wp::int32 var_141;
        const wp::int32 var_142 = 3;
        wp::mat_t<4, 4, wp::float64>* var_143;
        wp::float64 var_144;
        wp::mat_t<4, 4, wp::float64> var_145;
        wp::mat_t<4, 4, wp::float64>* var_146;
        wp::float64 var_147;
        wp::mat_t<4, 4, wp::float64> var_148;
        bool var_149;
        const wp::int32 var_150 = 0;
        wp::int32 var_151;
        const wp::int32 var_152 = 3;
        const wp::int32 var_153 = 0;
        wp::mat_t<4, 4, wp::float64>* var_154;
        wp::float64 var_155;
        wp::mat_t<4, 4, wp::float64> var_156;
        wp::mat_t<4, 4, wp::float64>* var_157;
        wp::float64 var_158;
        wp::mat_t<4, 4, wp::float64> var_159;
        bool var_160;
        const wp::int32 var_161 = 0;
        wp::int32 var_162;
        const wp::int32 var_163 = 1;
        wp::mat_t<4, 4, wp::float64>* var_164;
        wp::float64 var_165;
        wp::mat_t<4, 4, wp::float64> var_166;
        wp::mat_t<4, 4, wp::float64>* var_167;
        wp::float64 var_168;
        wp::mat_t<4, 4, wp::float64> var_169;
        bool var_170;
        const wp::int32 var_171 = 0;
        wp::int32 var_172;
        const wp::int32 var_173 = 2;
        wp::mat_t<4, 4, wp::float64>* var_174;
        wp::float64 var_175;
        wp::mat_t<4, 4, wp::float64> var_176;
        wp::mat_t<4, 4, wp::float64>* var_177;
        wp::float64 var_178;
        wp::mat_t<4, 4, wp::float64> var_179;
        bool var_180;
        const wp::int32 var_181 = 0;
        wp::int32 var_182;
        const wp::int32 var_183 = 3;
        wp::mat_t<4, 4, wp::float64>* var_184;
        wp::float64 var_185;
        wp::mat_t<4, 4, wp::float64> var_186;
        wp::mat_t<4, 4, wp::float64>* var_187;
        wp::float64 var_188;
        wp::mat_t<4, 4, wp::float64> var_189;
        bool var_190;
        const wp::int32 var_191 = 0;
        wp::int32 var_192;
        const wp::int32 var_193 = 1;
        bool var_194;
        const wp::int32 var_195 = 0;
        wp::int32 var_196;
        const wp::int32 var_197 = 0;
        //---------
        // forward
        // def mark_contenders_kernel(poses, scores, distinct_count, best_inliers, contends, counts):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // best = float64(best_inliers)                                                           <L 4>
        var_1 = wp::float64(var_best_inliers);
        // for k in range(distinct_count[0]):                                                     <L 5>
        var_3 = wp::address(var_distinct_count, var_2);
        var_5 = wp::load(var_3);
        var_4 = wp::range(var_5);
        start_for_0:;
            if (iter_cmp(var_4) == 0) goto end_for_0;
            var_6 = wp::iter_next(var_4);
            // best = max(best, scores[k, 0])                                                     <L 6>
            var_8 = wp::address(var_scores, var_6, var_7);
            var_10 = wp::load(var_8);
            var_9 = wp::max(var_1, var_10);
            wp::assign(var_1, var_9);
            goto start_for_0;
        end_for_0:;
        // contender = 1 if i < distinct_count[0] and scores[i, 0] >= float64(CONTENDER) * best else 0       <L 7>
        var_13 = wp::address(var_distinct_count, var_12);
        var_15 = wp::load(var_13);
        var_14 = (var_0 < var_15);
        var_11 = var_14;
        if (var_11) {
            var_17 = wp::address(var_scores, var_0, var_16);
            var_18 = 0.25;
            var_19 = wp::mul(var_18, var_1);
            var_21 = wp::load(var_17);
            var_20 = (var_21 >= var_19);
            var_11 = var_11 && var_20;
        }
        if (var_11) {
        }
        if (!var_11) {
        }
        var_24 = wp::where(var_11, var_22, var_23);
        // for k in range(i):                                                                     <L 8>
        var_25 = wp::range(var_0);
        start_for_2:;
            if (iter_cmp(var_25) == 0) goto end_for_2;
            var_26 = wp::iter_next(var_25);
            // alike = int(1)                                                                     <L 9>
            var_28 = wp::int(var_27);
            // for row in range(4):                                                               <L 10>
            // for column in range(4):                                                            <L 11>
            // if poses[k][row, column] != poses[i][row, column]:                                 <L 12>
            var_31 = wp::address(var_poses, var_26);
            var_33 = wp::load(var_31);
            var_32 = wp::extract(var_33, var_29, var_30);
            var_34 = wp::address(var_poses, var_0);
            var_36 = wp::load(var_34);
            var_35 = wp::extract(var_36, var_29, var_30);
            var_37 = (var_32 != var_35);
            if (var_37) {
                // alike = 0                                                                      <L 13>
            }
            var_39 = wp::where(var_37, var_38, var_28);
            // if poses[k][row, column] != poses[i][row, column]:                                 <L 12>
            var_41 = wp::address(var_poses, var_26);
            var_43 = wp::load(var_41);
            var_42 = wp::extract(var_43, var_29, var_40);
            var_44 = wp::address(var_poses, var_0);
            var_46 = wp::load(var_44);
            var_45 = wp::extract(var_46, var_29, var_40);
            var_47 = (var_42 != var_45);
            if (var_47) {
                // alike = 0                                                                      <L 13>
            }
            var_49 = wp::where(var_47, var_48, var_39);
            // if poses[k][row, column] != poses[i][row, column]:                                 <L 12>
            var_51 = wp::address(var_poses, var_26);
            var_53 = wp::load(var_51);
            var_52 = wp::extract(var_53, var_29, var_50);
            var_54 = wp::address(var_poses, var_0);
            var_56 = wp::load(var_54);
            var_55 = wp::extract(var_56, var_29, var_50);
            var_57 = (var_52 != var_55);
            if (var_57) {
                // alike = 0                                                                      <L 13>
            }
            var_59 = wp::where(var_57, var_58, var_49);
            // if poses[k][row, column] != poses[i][row, column]:                                 <L 12>
            var_61 = wp::address(var_poses, var_26);
            var_63 = wp::load(var_61);
            var_62 = wp::extract(var_63, var_29, var_60);
            var_64 = wp::address(var_poses, var_0);
            var_66 = wp::load(var_64);
            var_65 = wp::extract(var_66, var_29, var_60);
            var_67 = (var_62 != var_65);
            if (var_67) {
                // alike = 0                                                                      <L 13>
            }
            var_69 = wp::where(var_67, var_68, var_59);
            // for column in range(4):                                                            <L 11>
            // if poses[k][row, column] != poses[i][row, column]:                                 <L 12>
            var_72 = wp::address(var_poses, var_26);
            var_74 = wp::load(var_72);
            var_73 = wp::extract(var_74, var_70, var_71);
            var_75 = wp::address(var_poses, var_0);
            var_77 = wp::load(var_75);
            var_76 = wp::extract(var_77, var_70, var_71);
            var_78 = (var_73 != var_76);
            if (var_78) {
                // alike = 0                                                                      <L 13>
            }
            var_80 = wp::where(var_78, var_79, var_69);
            // if poses[k][row, column] != poses[i][row, column]:                                 <L 12>
            var_82 = wp::address(var_poses, var_26);
            var_84 = wp::load(var_82);
            var_83 = wp::extract(var_84, var_70, var_81);
            var_85 = wp::address(var_poses, var_0);
            var_87 = wp::load(var_85);
            var_86 = wp::extract(var_87, var_70, var_81);
            var_88 = (var_83 != var_86);
            if (var_88) {
                // alike = 0                                                                      <L 13>
            }
            var_90 = wp::where(var_88, var_89, var_80);
            // if poses[k][row, column] != poses[i][row, column]:                                 <L 12>
            var_92 = wp::address(var_poses, var_26);
            var_94 = wp::load(var_92);
            var_93 = wp::extract(var_94, var_70, var_91);
            var_95 = wp::address(var_poses, var_0);
            var_97 = wp::load(var_95);
            var_96 = wp::extract(var_97, var_70, var_91);
            var_98 = (var_93 != var_96);
            if (var_98) {
                // alike = 0                                                                      <L 13>
            }
            var_100 = wp::where(var_98, var_99, var_90);
            // if poses[k][row, column] != poses[i][row, column]:                                 <L 12>
            var_102 = wp::address(var_poses, var_26);
            var_104 = wp::load(var_102);
            var_103 = wp::extract(var_104, var_70, var_101);
            var_105 = wp::address(var_poses, var_0);
            var_107 = wp::load(var_105);
            var_106 = wp::extract(var_107, var_70, var_101);
            var_108 = (var_103 != var_106);
            if (var_108) {
                // alike = 0                                                                      <L 13>
            }
            var_110 = wp::where(var_108, var_109, var_100);
            // for column in range(4):                                                            <L 11>
            // if poses[k][row, column] != poses[i][row, column]:                                 <L 12>
            var_113 = wp::address(var_poses, var_26);
            var_115 = wp::load(var_113);
            var_114 = wp::extract(var_115, var_111, var_112);
            var_116 = wp::address(var_poses, var_0);
            var_118 = wp::load(var_116);
            var_117 = wp::extract(var_118, var_111, var_112);
            var_119 = (var_114 != var_117);
            if (var_119) {
                // alike = 0                                                                      <L 13>
            }
            var_121 = wp::where(var_119, var_120, var_110);
            // if poses[k][row, column] != poses[i][row, column]:                                 <L 12>
            var_123 = wp::address(var_poses, var_26);
            var_125 = wp::load(var_123);
            var_124 = wp::extract(var_125, var_111, var_122);
            var_126 = wp::address(var_poses, var_0);
            var_128 = wp::load(var_126);
            var_127 = wp::extract(var_128, var_111, var_122);
            var_129 = (var_124 != var_127);
            if (var_129) {
                // alike = 0                                                                      <L 13>
            }
            var_131 = wp::where(var_129, var_130, var_121);
            // if poses[k][row, column] != poses[i][row, column]:                                 <L 12>
            var_133 = wp::address(var_poses, var_26);
            var_135 = wp::load(var_133);
            var_134 = wp::extract(var_135, var_111, var_132);
            var_136 = wp::address(var_poses, var_0);
            var_138 = wp::load(var_136);
            var_137 = wp::extract(var_138, var_111, var_132);
            var_139 = (var_134 != var_137);
            if (var_139) {
                // alike = 0                                                                      <L 13>
            }
            var_141 = wp::where(var_139, var_140, var_131);
            // if poses[k][row, column] != poses[i][row, column]:                                 <L 12>
            var_143 = wp::address(var_poses, var_26);
            var_145 = wp::load(var_143);
            var_144 = wp::extract(var_145, var_111, var_142);
            var_146 = wp::address(var_poses, var_0);
            var_148 = wp::load(var_146);
            var_147 = wp::extract(var_148, var_111, var_142);
            var_149 = (var_144 != var_147);
            if (var_149) {
                // alike = 0                                                                      <L 13>
            }
            var_151 = wp::where(var_149, var_150, var_141);
            // for column in range(4):                                                            <L 11>
            // if poses[k][row, column] != poses[i][row, column]:                                 <L 12>
            var_154 = wp::address(var_poses, var_26);
            var_156 = wp::load(var_154);
            var_155 = wp::extract(var_156, var_152, var_153);
            var_157 = wp::address(var_poses, var_0);
            var_159 = wp::load(var_157);
            var_158 = wp::extract(var_159, var_152, var_153);
            var_160 = (var_155 != var_158);
            if (var_160) {
                // alike = 0                                                                      <L 13>
            }
            var_162 = wp::where(var_160, var_161, var_151);
            // if poses[k][row, column] != poses[i][row, column]:                                 <L 12>
            var_164 = wp::address(var_poses, var_26);
            var_166 = wp::load(var_164);
            var_165 = wp::extract(var_166, var_152, var_163);
            var_167 = wp::address(var_poses, var_0);
            var_169 = wp::load(var_167);
            var_168 = wp::extract(var_169, var_152, var_163);
            var_170 = (var_165 != var_168);
            if (var_170) {
                // alike = 0                                                                      <L 13>
            }
            var_172 = wp::where(var_170, var_171, var_162);
            // if poses[k][row, column] != poses[i][row, column]:                                 <L 12>
            var_174 = wp::address(var_poses, var_26);
            var_176 = wp::load(var_174);
            var_175 = wp::extract(var_176, var_152, var_173);
            var_177 = wp::address(var_poses, var_0);
            var_179 = wp::load(var_177);
            var_178 = wp::extract(var_179, var_152, var_173);
            var_180 = (var_175 != var_178);
            if (var_180) {
                // alike = 0                                                                      <L 13>
            }
            var_182 = wp::where(var_180, var_181, var_172);
            // if poses[k][row, column] != poses[i][row, column]:                                 <L 12>
            var_184 = wp::address(var_poses, var_26);
            var_186 = wp::load(var_184);
            var_185 = wp::extract(var_186, var_152, var_183);
            var_187 = wp::address(var_poses, var_0);
            var_189 = wp::load(var_187);
            var_188 = wp::extract(var_189, var_152, var_183);
            var_190 = (var_185 != var_188);
            if (var_190) {
                // alike = 0                                                                      <L 13>
            }
            var_192 = wp::where(var_190, var_191, var_182);
            // if alike == 1:                                                                     <L 14>
            var_194 = (var_192 == var_193);
            if (var_194) {
                // contender = 0                                                                  <L 15>
            }
            var_196 = wp::where(var_194, var_195, var_24);
            wp::assign(var_24, var_196);
            goto start_for_2;
        end_for_2:;
        // contends[i] = contender                                                                <L 16>
        wp::array_store(var_contends, var_0, var_24);
        // counts[i] = 0                                                                          <L 17>
        wp::array_store(var_counts, var_0, var_197);
}


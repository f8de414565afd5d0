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


// <pointloom.kernels.volumes.block_signs.slice_signs>:1
static CUDA_CALLABLE wp::int64 slice_signs_0(
    wp::int32 var_layer,
    wp::array_t<wp::float32> var_blocks__distances,
    wp::array_t<wp::uint16> var_blocks__weights)
{
    //---------
    // primal vars
    wp::int64 var_0;
    const wp::int32 var_1 = 8;
    wp::int32 var_2;
    wp::range_t var_3;
    wp::int32 var_4;
    const wp::int32 var_5 = 0;
    wp::int32 var_6;
    const wp::int32 var_7 = 0;
    const wp::int32 var_8 = 8;
    wp::int32 var_9;
    wp::int32 var_10;
    wp::int32 var_11;
    wp::int32 var_12;
    wp::float32* var_13;
    const wp::float32 var_14 = 0.0;
    bool var_15;
    wp::float32 var_16;
    wp::int32 var_17;
    wp::uint16* var_18;
    wp::int32 var_19;
    wp::uint16 var_20;
    const wp::int32 var_21 = 0;
    bool var_22;
    wp::int32 var_23;
    wp::int32 var_24;
    wp::int32 var_25;
    wp::int32 var_26;
    const wp::int32 var_27 = 1;
    wp::int32 var_28;
    wp::int32 var_29;
    wp::int32 var_30;
    wp::int32 var_31;
    wp::float32* var_32;
    const wp::float32 var_33 = 0.0;
    bool var_34;
    wp::float32 var_35;
    wp::int32 var_36;
    wp::uint16* var_37;
    wp::int32 var_38;
    wp::uint16 var_39;
    const wp::int32 var_40 = 0;
    bool var_41;
    wp::int32 var_42;
    wp::int32 var_43;
    wp::int32 var_44;
    wp::int32 var_45;
    const wp::int32 var_46 = 2;
    wp::int32 var_47;
    wp::int32 var_48;
    wp::int32 var_49;
    wp::int32 var_50;
    wp::float32* var_51;
    const wp::float32 var_52 = 0.0;
    bool var_53;
    wp::float32 var_54;
    wp::int32 var_55;
    wp::uint16* var_56;
    wp::int32 var_57;
    wp::uint16 var_58;
    const wp::int32 var_59 = 0;
    bool var_60;
    wp::int32 var_61;
    wp::int32 var_62;
    wp::int32 var_63;
    wp::int32 var_64;
    const wp::int32 var_65 = 3;
    wp::int32 var_66;
    wp::int32 var_67;
    wp::int32 var_68;
    wp::int32 var_69;
    wp::float32* var_70;
    const wp::float32 var_71 = 0.0;
    bool var_72;
    wp::float32 var_73;
    wp::int32 var_74;
    wp::uint16* var_75;
    wp::int32 var_76;
    wp::uint16 var_77;
    const wp::int32 var_78 = 0;
    bool var_79;
    wp::int32 var_80;
    wp::int32 var_81;
    wp::int32 var_82;
    wp::int32 var_83;
    const wp::int32 var_84 = 4;
    wp::int32 var_85;
    wp::int32 var_86;
    wp::int32 var_87;
    wp::int32 var_88;
    wp::float32* var_89;
    const wp::float32 var_90 = 0.0;
    bool var_91;
    wp::float32 var_92;
    wp::int32 var_93;
    wp::uint16* var_94;
    wp::int32 var_95;
    wp::uint16 var_96;
    const wp::int32 var_97 = 0;
    bool var_98;
    wp::int32 var_99;
    wp::int32 var_100;
    wp::int32 var_101;
    wp::int32 var_102;
    const wp::int32 var_103 = 5;
    wp::int32 var_104;
    wp::int32 var_105;
    wp::int32 var_106;
    wp::int32 var_107;
    wp::float32* var_108;
    const wp::float32 var_109 = 0.0;
    bool var_110;
    wp::float32 var_111;
    wp::int32 var_112;
    wp::uint16* var_113;
    wp::int32 var_114;
    wp::uint16 var_115;
    const wp::int32 var_116 = 0;
    bool var_117;
    wp::int32 var_118;
    wp::int32 var_119;
    wp::int32 var_120;
    wp::int32 var_121;
    const wp::int32 var_122 = 6;
    wp::int32 var_123;
    wp::int32 var_124;
    wp::int32 var_125;
    wp::int32 var_126;
    wp::float32* var_127;
    const wp::float32 var_128 = 0.0;
    bool var_129;
    wp::float32 var_130;
    wp::int32 var_131;
    wp::uint16* var_132;
    wp::int32 var_133;
    wp::uint16 var_134;
    const wp::int32 var_135 = 0;
    bool var_136;
    wp::int32 var_137;
    wp::int32 var_138;
    wp::int32 var_139;
    wp::int32 var_140;
    const wp::int32 var_141 = 7;
    wp::int32 var_142;
    wp::int32 var_143;
    wp::int32 var_144;
    wp::int32 var_145;
    wp::float32* var_146;
    const wp::float32 var_147 = 0.0;
    bool var_148;
    wp::float32 var_149;
    wp::int32 var_150;
    wp::uint16* var_151;
    wp::int32 var_152;
    wp::uint16 var_153;
    const wp::int32 var_154 = 0;
    bool var_155;
    wp::int32 var_156;
    wp::int32 var_157;
    wp::int32 var_158;
    wp::int32 var_159;
    wp::int64 var_160;
    const wp::int32 var_161 = 8;
    wp::int32 var_162;
    wp::int64 var_163;
    wp::int64 var_164;
    wp::int64 var_165;
    //---------
    // forward
    // def slice_signs(layer, blocks__distances, blocks__weights):                            <L 1>
    // word = int64(0)                                                                        <L 2>
    var_0 = 0ll;
    // n = int(8)                                                                             <L 3>
    var_2 = wp::int(var_1);
    // for y in range(n):                                                                     <L 4>
    var_3 = wp::range(var_2);
    start_for_0:;
        if (iter_cmp(var_3) == 0) goto end_for_0;
        var_4 = wp::iter_next(var_3);
        // row = int(0)                                                                       <L 5>
        var_6 = wp::int(var_5);
        // for z in range(8):                                                                 <L 6>
        // voxel = (layer * SIDE + y) * SIDE + z                                              <L 7>
        var_9 = wp::mul(var_layer, var_8);
        var_10 = wp::add(var_9, var_4);
        var_11 = wp::mul(var_10, var_8);
        var_12 = wp::add(var_11, var_7);
        // row = row | (int(blocks__distances[voxel] <= 0.0) & int(int(blocks__weights[voxel]) > 0)) << z       <L 8>
        var_13 = wp::address(var_blocks__distances, var_12);
        var_16 = wp::load(var_13);
        var_15 = (var_16 <= var_14);
        var_17 = wp::int(var_15);
        var_18 = wp::address(var_blocks__weights, var_12);
        var_20 = wp::load(var_18);
        var_19 = wp::int(var_20);
        var_22 = (var_19 > var_21);
        var_23 = wp::int(var_22);
        var_24 = wp::bit_and(var_17, var_23);
        var_25 = wp::lshift(var_24, var_7);
        var_26 = wp::bit_or(var_6, var_25);
        // voxel = (layer * SIDE + y) * SIDE + z                                              <L 7>
        var_28 = wp::mul(var_layer, var_8);
        var_29 = wp::add(var_28, var_4);
        var_30 = wp::mul(var_29, var_8);
        var_31 = wp::add(var_30, var_27);
        // row = row | (int(blocks__distances[voxel] <= 0.0) & int(int(blocks__weights[voxel]) > 0)) << z       <L 8>
        var_32 = wp::address(var_blocks__distances, var_31);
        var_35 = wp::load(var_32);
        var_34 = (var_35 <= var_33);
        var_36 = wp::int(var_34);
        var_37 = wp::address(var_blocks__weights, var_31);
        var_39 = wp::load(var_37);
        var_38 = wp::int(var_39);
        var_41 = (var_38 > var_40);
        var_42 = wp::int(var_41);
        var_43 = wp::bit_and(var_36, var_42);
        var_44 = wp::lshift(var_43, var_27);
        var_45 = wp::bit_or(var_26, var_44);
        // voxel = (layer * SIDE + y) * SIDE + z                                              <L 7>
        var_47 = wp::mul(var_layer, var_8);
        var_48 = wp::add(var_47, var_4);
        var_49 = wp::mul(var_48, var_8);
        var_50 = wp::add(var_49, var_46);
        // row = row | (int(blocks__distances[voxel] <= 0.0) & int(int(blocks__weights[voxel]) > 0)) << z       <L 8>
        var_51 = wp::address(var_blocks__distances, var_50);
        var_54 = wp::load(var_51);
        var_53 = (var_54 <= var_52);
        var_55 = wp::int(var_53);
        var_56 = wp::address(var_blocks__weights, var_50);
        var_58 = wp::load(var_56);
        var_57 = wp::int(var_58);
        var_60 = (var_57 > var_59);
        var_61 = wp::int(var_60);
        var_62 = wp::bit_and(var_55, var_61);
        var_63 = wp::lshift(var_62, var_46);
        var_64 = wp::bit_or(var_45, var_63);
        // voxel = (layer * SIDE + y) * SIDE + z                                              <L 7>
        var_66 = wp::mul(var_layer, var_8);
        var_67 = wp::add(var_66, var_4);
        var_68 = wp::mul(var_67, var_8);
        var_69 = wp::add(var_68, var_65);
        // row = row | (int(blocks__distances[voxel] <= 0.0) & int(int(blocks__weights[voxel]) > 0)) << z       <L 8>
        var_70 = wp::address(var_blocks__distances, var_69);
        var_73 = wp::load(var_70);
        var_72 = (var_73 <= var_71);
        var_74 = wp::int(var_72);
        var_75 = wp::address(var_blocks__weights, var_69);
        var_77 = wp::load(var_75);
        var_76 = wp::int(var_77);
        var_79 = (var_76 > var_78);
        var_80 = wp::int(var_79);
        var_81 = wp::bit_and(var_74, var_80);
        var_82 = wp::lshift(var_81, var_65);
        var_83 = wp::bit_or(var_64, var_82);
        // voxel = (layer * SIDE + y) * SIDE + z                                              <L 7>
        var_85 = wp::mul(var_layer, var_8);
        var_86 = wp::add(var_85, var_4);
        var_87 = wp::mul(var_86, var_8);
        var_88 = wp::add(var_87, var_84);
        // row = row | (int(blocks__distances[voxel] <= 0.0) & int(int(blocks__weights[voxel]) > 0)) << z       <L 8>
        var_89 = wp::address(var_blocks__distances, var_88);
        var_92 = wp::load(var_89);
        var_91 = (var_92 <= var_90);
        var_93 = wp::int(var_91);
        var_94 = wp::address(var_blocks__weights, var_88);
        var_96 = wp::load(var_94);
        var_95 = wp::int(var_96);
        var_98 = (var_95 > var_97);
        var_99 = wp::int(var_98);
        var_100 = wp::bit_and(var_93, var_99);
        var_101 = wp::lshift(var_100, var_84);
        var_102 = wp::bit_or(var_83, var_101);
        // voxel = (layer * SIDE + y) * SIDE + z                                              <L 7>
        var_104 = wp::mul(var_layer, var_8);
        var_105 = wp::add(var_104, var_4);
        var_106 = wp::mul(var_105, var_8);
        var_107 = wp::add(var_106, var_103);
        // row = row | (int(blocks__distances[voxel] <= 0.0) & int(int(blocks__weights[voxel]) > 0)) << z       <L 8>
        var_108 = wp::address(var_blocks__distances, var_107);
        var_111 = wp::load(var_108);
        var_110 = (var_111 <= var_109);
        var_112 = wp::int(var_110);
        var_113 = wp::address(var_blocks__weights, var_107);
        var_115 = wp::load(var_113);
        var_114 = wp::int(var_115);
        var_117 = (var_114 > var_116);
        var_118 = wp::int(var_117);
        var_119 = wp::bit_and(var_112, var_118);
        var_120 = wp::lshift(var_119, var_103);
        var_121 = wp::bit_or(var_102, var_120);
        // voxel = (layer * SIDE + y) * SIDE + z                                              <L 7>
        var_123 = wp::mul(var_layer, var_8);
        var_124 = wp::add(var_123, var_4);
        var_125 = wp::mul(var_124, var_8);
        var_126 = wp::add(var_125, var_122);
        // row = row | (int(blocks__distances[voxel] <= 0.0) & int(int(blocks__weights[voxel]) > 0)) << z       <L 8>
        var_127 = wp::address(var_blocks__distances, var_126);
        var_130 = wp::load(var_127);
        var_129 = (var_130 <= var_128);
        var_131 = wp::int(var_129);
        var_132 = wp::address(var_blocks__weights, var_126);
        var_134 = wp::load(var_132);
        var_133 = wp::int(var_134);
        var_136 = (var_133 > var_135);
        var_137 = wp::int(var_136);
        var_138 = wp::bit_and(var_131, var_137);
        var_139 = wp::lshift(var_138, var_122);
        var_140 = wp::bit_or(var_121, var_139);
        // voxel = (layer * SIDE + y) * SIDE + z                                              <L 7>
        var_142 = wp::mul(var_layer, var_8);
        var_143 = wp::add(var_142, var_4);
        var_144 = wp::mul(var_143, var_8);
        var_145 = wp::add(var_144, var_141);
        // row = row | (int(blocks__distances[voxel] <= 0.0) & int(int(blocks__weights[voxel]) > 0)) << z       <L 8>
        var_146 = wp::address(var_blocks__distances, var_145);
        var_149 = wp::load(var_146);
        var_148 = (var_149 <= var_147);
        var_150 = wp::int(var_148);
        var_151 = wp::address(var_blocks__weights, var_145);
        var_153 = wp::load(var_151);
        var_152 = wp::int(var_153);
        var_155 = (var_152 > var_154);
        var_156 = wp::int(var_155);
        var_157 = wp::bit_and(var_150, var_156);
        var_158 = wp::lshift(var_157, var_141);
        var_159 = wp::bit_or(var_140, var_158);
        // word = word | int64(row) << int64(8 * y)                                           <L 9>
        var_160 = wp::int64(var_159);
        var_162 = wp::mul(var_161, var_4);
        var_163 = wp::int64(var_162);
        var_164 = wp::lshift(var_160, var_163);
        var_165 = wp::bit_or(var_0, var_164);
        wp::assign(var_0, var_165);
        goto start_for_0;
    end_for_0:;
    // return word                                                                            <L 10>
    return var_0;
}


// /work/main/src/pointloom/kernels/volumes/block_signs.py:103
static CUDA_CALLABLE wp::int64 slice_at_0(
    wp::int32 var_block,
    wp::int32 var_x,
    wp::array_t<wp::int64> var_signs)
{
    //---------
    // primal vars
    wp::int64 var_0;
    const wp::int32 var_1 = 0;
    bool var_2;
    const wp::int32 var_3 = 8;
    wp::int32 var_4;
    wp::int32 var_5;
    wp::int64* var_6;
    wp::int64 var_7;
    wp::int64 var_8;
    wp::int64 var_9;
    //---------
    // forward
    // def slice_at(block: int, x: int, signs: array(dtype=int64)) -> int64:                  <L 104>
    // word = int64(0)                                                                        <L 105>
    var_0 = 0ll;
    // if block >= 0:                                                                         <L 106>
    var_2 = (var_block >= var_1);
    if (var_2) {
        // word = signs[block * SIDE + x]                                                     <L 107>
        var_4 = wp::mul(var_block, var_3);
        var_5 = wp::add(var_4, var_x);
        var_6 = wp::address(var_signs, var_5);
        var_8 = wp::load(var_6);
        var_7 = wp::copy(var_8);
    }
    var_9 = wp::where(var_2, var_7, var_0);
    // return word                                                                            <L 108>
    return var_9;
}


// <pointloom.kernels.volumes.block_signs.spread_slice>:1
static CUDA_CALLABLE wp::int64 spread_slice_0(
    wp::int32 var_first,
    wp::int32 var_x,
    wp::array_t<wp::int32> var_neighbors,
    wp::array_t<wp::int64> var_signs)
{
    //---------
    // primal vars
    wp::int32* var_0;
    wp::int64 var_1;
    wp::int32 var_2;
    const wp::int32 var_3 = 1;
    wp::int32 var_4;
    wp::int32* var_5;
    wp::int64 var_6;
    wp::int32 var_7;
    const wp::int32 var_8 = 3;
    wp::int32 var_9;
    wp::int32* var_10;
    wp::int64 var_11;
    wp::int32 var_12;
    const wp::int32 var_13 = 4;
    wp::int32 var_14;
    wp::int32* var_15;
    wp::int64 var_16;
    wp::int32 var_17;
    wp::int64 var_18;
    wp::int64 var_19;
    wp::int64 var_20;
    wp::int64 var_21;
    wp::int64 var_22;
    wp::int64 var_23;
    wp::int64 var_24;
    wp::int64 var_25;
    wp::int64 var_26;
    wp::int64 var_27;
    wp::int64 var_28;
    wp::int64 var_29;
    wp::int64 var_30;
    wp::int64 var_31;
    wp::int64 var_32;
    wp::int64 var_33;
    wp::int64 var_34;
    wp::int64 var_35;
    wp::int64 var_36;
    wp::int64 var_37;
    wp::int64 var_38;
    wp::int64 var_39;
    wp::int64 var_40;
    wp::int64 var_41;
    wp::int64 var_42;
    wp::int64 var_43;
    wp::int64 var_44;
    wp::int64 var_45;
    //---------
    // forward
    // def spread_slice(first, x, neighbors, signs):                                          <L 1>
    // w = slice_at(neighbors[first], x, signs)                                               <L 3>
    var_0 = wp::address(var_neighbors, var_first);
    var_2 = wp::load(var_0);
    var_1 = slice_at_0(var_2, var_x, var_signs);
    // above_z = slice_at(neighbors[first + 1], x, signs)                                     <L 4>
    var_4 = wp::add(var_first, var_3);
    var_5 = wp::address(var_neighbors, var_4);
    var_7 = wp::load(var_5);
    var_6 = slice_at_0(var_7, var_x, var_signs);
    // above_y = slice_at(neighbors[first + 3], x, signs)                                     <L 5>
    var_9 = wp::add(var_first, var_8);
    var_10 = wp::address(var_neighbors, var_9);
    var_12 = wp::load(var_10);
    var_11 = slice_at_0(var_12, var_x, var_signs);
    // above = slice_at(neighbors[first + 4], x, signs)                                       <L 6>
    var_14 = wp::add(var_first, var_13);
    var_15 = wp::address(var_neighbors, var_14);
    var_17 = wp::load(var_15);
    var_16 = slice_at_0(var_17, var_x, var_signs);
    // w = w | w >> int64(1) & int64(LOW_SEVEN) | (above_z & int64(LOWEST)) << int64(7)       <L 7>
    var_18 = 1ll;
    var_19 = wp::rshift(var_1, var_18);
    var_20 = 9187201950435737471ll;
    var_21 = wp::bit_and(var_19, var_20);
    var_22 = wp::bit_or(var_1, var_21);
    var_23 = 72340172838076673ll;
    var_24 = wp::bit_and(var_6, var_23);
    var_25 = 7ll;
    var_26 = wp::lshift(var_24, var_25);
    var_27 = wp::bit_or(var_22, var_26);
    // up = above_y | above_y >> int64(1) & int64(LOW_SEVEN) | (above & int64(LOWEST)) << int64(7)       <L 8>
    var_28 = 1ll;
    var_29 = wp::rshift(var_11, var_28);
    var_30 = wp::int64(var_20);
    var_31 = wp::bit_and(var_29, var_30);
    var_32 = wp::bit_or(var_11, var_31);
    var_33 = wp::int64(var_23);
    var_34 = wp::bit_and(var_16, var_33);
    var_35 = 7ll;
    var_36 = wp::lshift(var_34, var_35);
    var_37 = wp::bit_or(var_32, var_36);
    // return w | w >> int64(8) & int64(LOW_SEVEN_ROWS) | up << int64(56)                     <L 9>
    var_38 = 8ll;
    var_39 = wp::rshift(var_27, var_38);
    var_40 = 72057594037927935ll;
    var_41 = wp::bit_and(var_39, var_40);
    var_42 = wp::bit_or(var_27, var_41);
    var_43 = 56ll;
    var_44 = wp::lshift(var_37, var_43);
    var_45 = wp::bit_or(var_42, var_44);
    return var_45;
}


// <pointloom.kernels.volumes.block_signs.parts_of>:1
static CUDA_CALLABLE wp::int32 parts_of_0(
    wp::int64 var_word)
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
    bool var_9;
    wp::int32 var_10;
    wp::int64 var_11;
    wp::int64 var_12;
    wp::int64 var_13;
    wp::int64 var_14;
    bool var_15;
    wp::int32 var_16;
    const wp::int32 var_17 = 1;
    wp::int32 var_18;
    wp::int32 var_19;
    wp::int64 var_20;
    wp::int64 var_21;
    wp::int64 var_22;
    bool var_23;
    wp::int32 var_24;
    const wp::int32 var_25 = 2;
    wp::int32 var_26;
    wp::int32 var_27;
    wp::int64 var_28;
    wp::int64 var_29;
    wp::int64 var_30;
    wp::int64 var_31;
    bool var_32;
    wp::int32 var_33;
    const wp::int32 var_34 = 3;
    wp::int32 var_35;
    wp::int32 var_36;
    //---------
    // forward
    // def parts_of(word):                                                                    <L 1>
    // y_low = word & int64(LOW_Y)                                                            <L 2>
    var_0 = 4294967295ll;
    var_1 = wp::bit_and(var_word, var_0);
    // y_high = word >> int64(32) & int64(LOW_Y)                                              <L 3>
    var_2 = 32ll;
    var_3 = wp::rshift(var_word, var_2);
    var_4 = wp::int64(var_0);
    var_5 = wp::bit_and(var_3, var_4);
    // parts = int(y_low & int64(LOW_Z) != int64(0)) | int(y_low & ~int64(LOW_Z) != int64(0)) << 1       <L 4>
    var_6 = 1085102592571150095ll;
    var_7 = wp::bit_and(var_1, var_6);
    var_8 = 0ll;
    var_9 = (var_7 != var_8);
    var_10 = wp::int(var_9);
    var_11 = wp::int64(var_6);
    var_12 = wp::invert(var_11);
    var_13 = wp::bit_and(var_1, var_12);
    var_14 = 0ll;
    var_15 = (var_13 != var_14);
    var_16 = wp::int(var_15);
    var_18 = wp::lshift(var_16, var_17);
    var_19 = wp::bit_or(var_10, var_18);
    // return parts | int(y_high & int64(LOW_Z) != int64(0)) << 2 | int(y_high & ~int64(LOW_Z) != int64(0)) << 3       <L 5>
    var_20 = wp::int64(var_6);
    var_21 = wp::bit_and(var_5, var_20);
    var_22 = 0ll;
    var_23 = (var_21 != var_22);
    var_24 = wp::int(var_23);
    var_26 = wp::lshift(var_24, var_25);
    var_27 = wp::bit_or(var_19, var_26);
    var_28 = wp::int64(var_6);
    var_29 = wp::invert(var_28);
    var_30 = wp::bit_and(var_5, var_29);
    var_31 = 0ll;
    var_32 = (var_30 != var_31);
    var_33 = wp::int(var_32);
    var_35 = wp::lshift(var_33, var_34);
    var_36 = wp::bit_or(var_27, var_35);
    return var_36;
}


// <pointloom.kernels.volumes.block_signs.slice_signs>:1
static CUDA_CALLABLE void adj_slice_signs_0(
    wp::int32 var_layer,
    wp::array_t<wp::float32> var_blocks__distances,
    wp::array_t<wp::uint16> var_blocks__weights,
    wp::int32 & adj_layer,
    wp::array_t<wp::float32> & adj_blocks__distances,
    wp::array_t<wp::uint16> & adj_blocks__weights,
    wp::int64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/volumes/block_signs.py:103
static CUDA_CALLABLE void adj_slice_at_0(
    wp::int32 var_block,
    wp::int32 var_x,
    wp::array_t<wp::int64> var_signs,
    wp::int32 & adj_block,
    wp::int32 & adj_x,
    wp::array_t<wp::int64> & adj_signs,
    wp::int64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.block_signs.spread_slice>:1
static CUDA_CALLABLE void adj_spread_slice_0(
    wp::int32 var_first,
    wp::int32 var_x,
    wp::array_t<wp::int32> var_neighbors,
    wp::array_t<wp::int64> var_signs,
    wp::int32 & adj_first,
    wp::int32 & adj_x,
    wp::array_t<wp::int32> & adj_neighbors,
    wp::array_t<wp::int64> & adj_signs,
    wp::int64 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.block_signs.parts_of>:1
static CUDA_CALLABLE void adj_parts_of_0(
    wp::int64 var_word,
    wp::int64 & adj_word,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void find_touched_signs_kernel_64ac1c2c_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_touched,
    wp::array_t<wp::float32> var_blocks__distances,
    wp::array_t<wp::uint16> var_blocks__weights,
    wp::array_t<wp::int64> var_signs)
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
        wp::int32* var_3;
        wp::int32 var_4;
        wp::int32 var_5;
        wp::int32 var_6;
        wp::int32 var_7;
        wp::int64 var_8;
        //---------
        // forward
        // def find_touched_signs_kernel(touched, blocks__distances, blocks__weights, signs):       <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // layer = touched[i // SIDE] * SIDE + i % SIDE                                           <L 3>
        var_2 = wp::floordiv(var_0, var_1);
        var_3 = wp::address(var_touched, var_2);
        var_5 = wp::load(var_3);
        var_4 = wp::mul(var_5, var_1);
        var_6 = wp::mod(var_0, var_1);
        var_7 = wp::add(var_4, var_6);
        // signs[layer] = slice_signs(layer, blocks__distances, blocks__weights)                  <L 4>
        var_8 = slice_signs_0(var_7, var_blocks__distances, var_blocks__weights);
        wp::array_store(var_signs, var_7, var_8);
}



extern "C" __global__ void find_cells_with_signs_kernel_6e79c9b4_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::int32> var_neighbors,
    wp::array_t<wp::int64> var_signs,
    wp::array_t<wp::int64> var_cells,
    wp::array_t<wp::int32> var_parts)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        const wp::int32 var_1 = 27;
        wp::int32 var_2;
        const wp::int32 var_3 = 13;
        wp::int32 var_4;
        const wp::int32 var_5 = 0;
        wp::int64 var_6;
        wp::int64 var_7;
        wp::int64 var_8;
        const wp::int32 var_9 = 8;
        wp::int32 var_10;
        wp::range_t var_11;
        wp::int32 var_12;
        wp::int64 var_13;
        const wp::int32 var_14 = 8;
        const wp::int32 var_15 = 1;
        wp::int32 var_16;
        bool var_17;
        const wp::int32 var_18 = 1;
        wp::int32 var_19;
        wp::int64 var_20;
        const wp::int32 var_21 = 9;
        wp::int32 var_22;
        const wp::int32 var_23 = 0;
        wp::int64 var_24;
        wp::int64 var_25;
        wp::int64 var_26;
        wp::int32 var_27;
        wp::int32 var_28;
        const wp::int32 var_29 = 4;
        bool var_30;
        wp::int64 var_31;
        wp::int64 var_32;
        wp::int64 var_33;
        wp::int64 var_34;
        wp::int64 var_35;
        wp::int32 var_36;
        wp::int32 var_37;
        const wp::int32 var_38 = 4;
        wp::int32 var_39;
        wp::int32 var_40;
        //---------
        // forward
        // def find_cells_with_signs_kernel(                                                      <L 132>
        // i = tid()                                                                              <L 136>
        var_0 = builtin_tid1d();
        // first = i * AROUND + MIDDLE                                                            <L 137>
        var_2 = wp::mul(var_0, var_1);
        var_4 = wp::add(var_2, var_3);
        // word = spread_slice(first, 0, neighbors, signs)                                        <L 138>
        var_6 = spread_slice_0(var_4, var_5, var_neighbors, var_signs);
        // low = int64(0)                                                                         <L 139>
        var_7 = 0ll;
        // high = int64(0)                                                                        <L 140>
        var_8 = 0ll;
        // n = int(8)                                                                             <L 141>
        var_10 = wp::int(var_9);
        // for x in range(n):                                                                     <L 142>
        var_11 = wp::range(var_10);
        start_for_0:;
            if (iter_cmp(var_11) == 0) goto end_for_0;
            var_12 = wp::iter_next(var_11);
            // following = int64(0)                                                               <L 143>
            var_13 = 0ll;
            // if x < SIDE - 1:                                                                   <L 144>
            var_16 = wp::sub(var_14, var_15);
            var_17 = (var_12 < var_16);
            if (var_17) {
                // following = spread_slice(first, x + 1, neighbors, signs)                       <L 145>
                var_19 = wp::add(var_12, var_18);
                var_20 = spread_slice_0(var_4, var_19, var_neighbors, var_signs);
            }
            if (!var_17) {
                // following = spread_slice(first + 9, 0, neighbors, signs)                       <L 147>
                var_22 = wp::add(var_4, var_21);
                var_24 = spread_slice_0(var_22, var_23, var_neighbors, var_signs);
            }
            var_25 = wp::where(var_17, var_20, var_24);
            // word = word | following                                                            <L 148>
            var_26 = wp::bit_or(var_6, var_25);
            // cells[i * SIDE + x] = word                                                         <L 149>
            var_27 = wp::mul(var_0, var_14);
            var_28 = wp::add(var_27, var_12);
            wp::array_store(var_cells, var_28, var_26);
            // if x < HALF:                                                                       <L 150>
            var_30 = (var_12 < var_29);
            if (var_30) {
                // low = low | word                                                               <L 151>
                var_31 = wp::bit_or(var_7, var_26);
            }
            if (!var_30) {
                // high = high | word                                                             <L 153>
                var_32 = wp::bit_or(var_8, var_26);
            }
            var_33 = wp::where(var_30, var_31, var_7);
            var_34 = wp::where(var_30, var_8, var_32);
            // word = following                                                                   <L 154>
            var_35 = wp::copy(var_25);
            wp::assign(var_6, var_35);
            wp::assign(var_7, var_33);
            wp::assign(var_8, var_34);
            goto start_for_0;
        end_for_0:;
        // parts[i] = parts_of(low) | (parts_of(high) << 4)                                       <L 155>
        var_36 = parts_of_0(var_7);
        var_37 = parts_of_0(var_8);
        var_39 = wp::lshift(var_37, var_38);
        var_40 = wp::bit_or(var_36, var_39);
        wp::array_store(var_parts, var_0, var_40);
}



extern "C" __global__ void find_signs_kernel_fa7d4950_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::array_t<wp::float32> var_blocks__distances,
    wp::array_t<wp::uint16> var_blocks__weights,
    wp::array_t<wp::int64> var_signs)
{
    wp::tile_shared_storage_t tile_mem;

    const size_t _idx = static_cast<size_t>(blockIdx.z * gridDim.y + blockIdx.y) * static_cast<size_t>(gridDim.x * blockDim.x) + static_cast<size_t>(blockIdx.x * blockDim.x + threadIdx.x);
    if (_idx >= dim.size) return;
            // reset shared memory allocator
    wp::tile_shared_storage_t::init();

        //---------
        // primal vars
        wp::int32 var_0;
        wp::int64 var_1;
        //---------
        // forward
        // def find_signs_kernel(blocks__distances, blocks__weights, signs):                      <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // signs[i] = slice_signs(i, blocks__distances, blocks__weights)                          <L 3>
        var_1 = slice_signs_0(var_0, var_blocks__distances, var_blocks__weights);
        wp::array_store(var_signs, var_0, var_1);
}


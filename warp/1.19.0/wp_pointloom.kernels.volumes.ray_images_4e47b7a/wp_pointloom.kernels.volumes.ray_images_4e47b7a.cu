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


// <pointloom.kernels.volumes.camera_rays.ray_of>:1
static CUDA_CALLABLE wp::vec_t<3, wp::float32> ray_of_0(
    wp::int32 var_column,
    wp::int32 var_row,
    wp::mat_t<3, 3, wp::float64> var_rays__sight)
{
    //---------
    // primal vars
    wp::float64 var_0;
    wp::float64 var_1;
    wp::float64 var_2;
    wp::vec_t<3, wp::float64> var_3;
    wp::vec_t<3, wp::float64> var_4;
    wp::vec_t<3, wp::float32> var_5;
    //---------
    // forward
    // def ray_of(column, row, rays__sight):                                                  <L 1>
    // return narrow(rays__sight @ vec3d(float64(column), float64(row), float64(1.0)))        <L 2>
    var_0 = wp::float64(var_column);
    var_1 = wp::float64(var_row);
    var_2 = 1.0;
    var_3 = wp::vec_t<3, wp::float64>(var_0, var_1, var_2);
    var_4 = wp::mul(var_rays__sight, var_3);
    var_5 = narrow_0(var_4);
    return var_5;
}


// /work/main/src/pointloom/kernels/arrays/block_keys.py:16
static CUDA_CALLABLE wp::vec_t<3, wp::int32> key_block_0(
    wp::int64 var_key)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 1;
    const wp::int32 var_1 = 21;
    wp::int32 var_2;
    const wp::int32 var_3 = 1;
    wp::int32 var_4;
    wp::int64 var_5;
    wp::int64 var_6;
    wp::int64 var_7;
    wp::int32 var_8;
    const wp::int32 var_9 = 1048576;
    wp::int32 var_10;
    wp::int64 var_11;
    wp::int64 var_12;
    wp::int64 var_13;
    wp::int32 var_14;
    wp::int32 var_15;
    wp::int64 var_16;
    wp::int32 var_17;
    wp::int32 var_18;
    wp::vec_t<3, wp::int32> var_19;
    //---------
    // forward
    // def key_block(key: int64) -> vec3i:                                                    <L 17>
    // low = int64((1 << 21) - 1)                                                             <L 18>
    var_2 = wp::lshift(var_0, var_1);
    var_4 = wp::sub(var_2, var_3);
    var_5 = wp::int64(var_4);
    // x = int(key >> int64(TWO_AXES)) - BIAS                                                 <L 19>
    var_6 = 42ll;
    var_7 = wp::rshift(var_key, var_6);
    var_8 = wp::int(var_7);
    var_10 = wp::sub(var_8, var_9);
    // y = int((key >> int64(AXIS_BITS)) & low) - BIAS                                        <L 20>
    var_11 = 21ll;
    var_12 = wp::rshift(var_key, var_11);
    var_13 = wp::bit_and(var_12, var_5);
    var_14 = wp::int(var_13);
    var_15 = wp::sub(var_14, var_9);
    // z = int(key & low) - BIAS                                                              <L 21>
    var_16 = wp::bit_and(var_key, var_5);
    var_17 = wp::int(var_16);
    var_18 = wp::sub(var_17, var_9);
    // return vec3i(x, y, z)                                                                  <L 22>
    var_19 = wp::vec_t<3, wp::int32>(var_10, var_15, var_18);
    return var_19;
}


// /work/main/src/pointloom/kernels/volumes/voxel_samples.py:22
static CUDA_CALLABLE wp::vec_t<3, wp::float32> to_float_0(
    wp::vec_t<3, wp::int32> var_v)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    wp::float32 var_2;
    const wp::int32 var_3 = 1;
    wp::int32 var_4;
    wp::float32 var_5;
    const wp::int32 var_6 = 2;
    wp::int32 var_7;
    wp::float32 var_8;
    wp::vec_t<3, wp::float32> var_9;
    //---------
    // forward
    // def to_float(v: vec3i) -> vec3:                                                        <L 23>
    // return vec3(float(v[0]), float(v[1]), float(v[2]))                                     <L 24>
    var_1 = wp::extract(var_v, var_0);
    var_2 = wp::float(var_1);
    var_4 = wp::extract(var_v, var_3);
    var_5 = wp::float(var_4);
    var_7 = wp::extract(var_v, var_6);
    var_8 = wp::float(var_7);
    var_9 = wp::vec_t<3, wp::float32>(var_2, var_5, var_8);
    return var_9;
}


// /work/main/src/pointloom/kernels/volumes/voxel_samples.py:17
static CUDA_CALLABLE wp::vec_t<3, wp::int32> floor_cell_0(
    wp::vec_t<3, wp::float32> var_p)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    wp::float32 var_2;
    wp::int32 var_3;
    const wp::int32 var_4 = 1;
    wp::float32 var_5;
    wp::float32 var_6;
    wp::int32 var_7;
    const wp::int32 var_8 = 2;
    wp::float32 var_9;
    wp::float32 var_10;
    wp::int32 var_11;
    wp::vec_t<3, wp::int32> var_12;
    //---------
    // forward
    // def floor_cell(p: vec3) -> vec3i:                                                      <L 18>
    // return vec3i(int(floor(p[0])), int(floor(p[1])), int(floor(p[2])))                     <L 19>
    var_1 = wp::extract(var_p, var_0);
    var_2 = wp::floor(var_1);
    var_3 = wp::int(var_2);
    var_5 = wp::extract(var_p, var_4);
    var_6 = wp::floor(var_5);
    var_7 = wp::int(var_6);
    var_9 = wp::extract(var_p, var_8);
    var_10 = wp::floor(var_9);
    var_11 = wp::int(var_10);
    var_12 = wp::vec_t<3, wp::int32>(var_3, var_7, var_11);
    return var_12;
}


// <pointloom.kernels.volumes.voxel_samples.voxel_around>:1
static CUDA_CALLABLE wp::int32 voxel_around_0(
    wp::int32 var_block,
    wp::int32 var_x,
    wp::int32 var_y,
    wp::int32 var_z,
    wp::array_t<wp::int32> var_seen__neighbors)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 27;
    wp::int32 var_1;
    const wp::int32 var_2 = 13;
    wp::int32 var_3;
    const wp::int32 var_4 = 9;
    const wp::int32 var_5 = 3;
    wp::int32 var_6;
    wp::int32 var_7;
    wp::int32 var_8;
    const wp::int32 var_9 = 3;
    const wp::int32 var_10 = 3;
    wp::int32 var_11;
    wp::int32 var_12;
    wp::int32 var_13;
    const wp::int32 var_14 = 3;
    wp::int32 var_15;
    wp::int32 var_16;
    wp::int32* var_17;
    wp::int32 var_18;
    wp::int32 var_19;
    const wp::int32 var_20 = -1;
    wp::int32 var_21;
    const wp::int32 var_22 = 0;
    bool var_23;
    const wp::int32 var_24 = 512;
    wp::int32 var_25;
    const wp::int32 var_26 = 7;
    wp::int32 var_27;
    const wp::int32 var_28 = 8;
    wp::int32 var_29;
    const wp::int32 var_30 = 7;
    wp::int32 var_31;
    wp::int32 var_32;
    wp::int32 var_33;
    wp::int32 var_34;
    const wp::int32 var_35 = 7;
    wp::int32 var_36;
    wp::int32 var_37;
    wp::int32 var_38;
    //---------
    // forward
    // def voxel_around(block, x, y, z, seen__neighbors):                                     <L 1>
    // other = seen__neighbors[block * AROUND + MIDDLE + 9 * (x >> 3) + 3 * (y >> 3) + (z >> 3)]       <L 3>
    var_1 = wp::mul(var_block, var_0);
    var_3 = wp::add(var_1, var_2);
    var_6 = wp::rshift(var_x, var_5);
    var_7 = wp::mul(var_4, var_6);
    var_8 = wp::add(var_3, var_7);
    var_11 = wp::rshift(var_y, var_10);
    var_12 = wp::mul(var_9, var_11);
    var_13 = wp::add(var_8, var_12);
    var_15 = wp::rshift(var_z, var_14);
    var_16 = wp::add(var_13, var_15);
    var_17 = wp::address(var_seen__neighbors, var_16);
    var_19 = wp::load(var_17);
    var_18 = wp::copy(var_19);
    // voxel = int(-1)                                                                        <L 4>
    var_21 = wp::int(var_20);
    // if other >= 0:                                                                         <L 5>
    var_23 = (var_18 >= var_22);
    if (var_23) {
        // voxel = other * BLOCK_VOXELS + ((x & 7) * SIDE + (y & 7)) * SIDE + (z & 7)         <L 6>
        var_25 = wp::mul(var_18, var_24);
        var_27 = wp::bit_and(var_x, var_26);
        var_29 = wp::mul(var_27, var_28);
        var_31 = wp::bit_and(var_y, var_30);
        var_32 = wp::add(var_29, var_31);
        var_33 = wp::mul(var_32, var_28);
        var_34 = wp::add(var_25, var_33);
        var_36 = wp::bit_and(var_z, var_35);
        var_37 = wp::add(var_34, var_36);
    }
    var_38 = wp::where(var_23, var_37, var_21);
    // return voxel                                                                           <L 7>
    return var_38;
}


// <pointloom.kernels.volumes.voxel_samples.cell_voxels>:1
static CUDA_CALLABLE wp::vec_t<8, wp::int32> cell_voxels_0(
    wp::int32 var_block,
    wp::int32 var_x,
    wp::int32 var_y,
    wp::int32 var_z,
    wp::array_t<wp::int32> var_seen__neighbors)
{
    //---------
    // primal vars
    const wp::int32 var_0 = -1;
    wp::vec_t<8, wp::int32> var_1;
    bool var_2;
    wp::int32 var_3;
    wp::int32 var_4;
    const wp::int32 var_5 = 0;
    bool var_6;
    wp::int32 var_7;
    wp::int32 var_8;
    const wp::int32 var_9 = 8;
    const wp::int32 var_10 = 1;
    wp::int32 var_11;
    bool var_12;
    const wp::int32 var_13 = 512;
    wp::int32 var_14;
    wp::int32 var_15;
    wp::int32 var_16;
    wp::int32 var_17;
    wp::int32 var_18;
    wp::int32 var_19;
    const wp::int32 var_20 = 0;
    const wp::int32 var_21 = 2;
    wp::int32 var_22;
    wp::int32 var_23;
    const wp::int32 var_24 = 1;
    wp::int32 var_25;
    const wp::int32 var_26 = 1;
    wp::int32 var_27;
    wp::int32 var_28;
    wp::int32 var_29;
    wp::int32 var_30;
    const wp::int32 var_31 = 1;
    wp::int32 var_32;
    wp::int32 var_33;
    const wp::int32 var_34 = 1;
    const wp::int32 var_35 = 2;
    wp::int32 var_36;
    wp::int32 var_37;
    const wp::int32 var_38 = 1;
    wp::int32 var_39;
    const wp::int32 var_40 = 1;
    wp::int32 var_41;
    wp::int32 var_42;
    wp::int32 var_43;
    wp::int32 var_44;
    const wp::int32 var_45 = 1;
    wp::int32 var_46;
    wp::int32 var_47;
    const wp::int32 var_48 = 2;
    const wp::int32 var_49 = 2;
    wp::int32 var_50;
    wp::int32 var_51;
    const wp::int32 var_52 = 1;
    wp::int32 var_53;
    const wp::int32 var_54 = 1;
    wp::int32 var_55;
    wp::int32 var_56;
    wp::int32 var_57;
    wp::int32 var_58;
    const wp::int32 var_59 = 1;
    wp::int32 var_60;
    wp::int32 var_61;
    const wp::int32 var_62 = 3;
    const wp::int32 var_63 = 2;
    wp::int32 var_64;
    wp::int32 var_65;
    const wp::int32 var_66 = 1;
    wp::int32 var_67;
    const wp::int32 var_68 = 1;
    wp::int32 var_69;
    wp::int32 var_70;
    wp::int32 var_71;
    wp::int32 var_72;
    const wp::int32 var_73 = 1;
    wp::int32 var_74;
    wp::int32 var_75;
    const wp::int32 var_76 = 4;
    const wp::int32 var_77 = 2;
    wp::int32 var_78;
    wp::int32 var_79;
    const wp::int32 var_80 = 1;
    wp::int32 var_81;
    const wp::int32 var_82 = 1;
    wp::int32 var_83;
    wp::int32 var_84;
    wp::int32 var_85;
    wp::int32 var_86;
    const wp::int32 var_87 = 1;
    wp::int32 var_88;
    wp::int32 var_89;
    const wp::int32 var_90 = 5;
    const wp::int32 var_91 = 2;
    wp::int32 var_92;
    wp::int32 var_93;
    const wp::int32 var_94 = 1;
    wp::int32 var_95;
    const wp::int32 var_96 = 1;
    wp::int32 var_97;
    wp::int32 var_98;
    wp::int32 var_99;
    wp::int32 var_100;
    const wp::int32 var_101 = 1;
    wp::int32 var_102;
    wp::int32 var_103;
    const wp::int32 var_104 = 6;
    const wp::int32 var_105 = 2;
    wp::int32 var_106;
    wp::int32 var_107;
    const wp::int32 var_108 = 1;
    wp::int32 var_109;
    const wp::int32 var_110 = 1;
    wp::int32 var_111;
    wp::int32 var_112;
    wp::int32 var_113;
    wp::int32 var_114;
    const wp::int32 var_115 = 1;
    wp::int32 var_116;
    wp::int32 var_117;
    const wp::int32 var_118 = 7;
    const wp::int32 var_119 = 2;
    wp::int32 var_120;
    wp::int32 var_121;
    const wp::int32 var_122 = 1;
    wp::int32 var_123;
    const wp::int32 var_124 = 1;
    wp::int32 var_125;
    wp::int32 var_126;
    wp::int32 var_127;
    wp::int32 var_128;
    const wp::int32 var_129 = 1;
    wp::int32 var_130;
    wp::int32 var_131;
    const wp::int32 var_132 = 0;
    const wp::int32 var_133 = 2;
    wp::int32 var_134;
    wp::int32 var_135;
    const wp::int32 var_136 = 1;
    wp::int32 var_137;
    const wp::int32 var_138 = 1;
    wp::int32 var_139;
    wp::int32 var_140;
    const wp::int32 var_141 = 1;
    wp::int32 var_142;
    wp::int32 var_143;
    wp::int32 var_144;
    const wp::int32 var_145 = 1;
    const wp::int32 var_146 = 2;
    wp::int32 var_147;
    wp::int32 var_148;
    const wp::int32 var_149 = 1;
    wp::int32 var_150;
    const wp::int32 var_151 = 1;
    wp::int32 var_152;
    wp::int32 var_153;
    const wp::int32 var_154 = 1;
    wp::int32 var_155;
    wp::int32 var_156;
    wp::int32 var_157;
    const wp::int32 var_158 = 2;
    const wp::int32 var_159 = 2;
    wp::int32 var_160;
    wp::int32 var_161;
    const wp::int32 var_162 = 1;
    wp::int32 var_163;
    const wp::int32 var_164 = 1;
    wp::int32 var_165;
    wp::int32 var_166;
    const wp::int32 var_167 = 1;
    wp::int32 var_168;
    wp::int32 var_169;
    wp::int32 var_170;
    const wp::int32 var_171 = 3;
    const wp::int32 var_172 = 2;
    wp::int32 var_173;
    wp::int32 var_174;
    const wp::int32 var_175 = 1;
    wp::int32 var_176;
    const wp::int32 var_177 = 1;
    wp::int32 var_178;
    wp::int32 var_179;
    const wp::int32 var_180 = 1;
    wp::int32 var_181;
    wp::int32 var_182;
    wp::int32 var_183;
    const wp::int32 var_184 = 4;
    const wp::int32 var_185 = 2;
    wp::int32 var_186;
    wp::int32 var_187;
    const wp::int32 var_188 = 1;
    wp::int32 var_189;
    const wp::int32 var_190 = 1;
    wp::int32 var_191;
    wp::int32 var_192;
    const wp::int32 var_193 = 1;
    wp::int32 var_194;
    wp::int32 var_195;
    wp::int32 var_196;
    const wp::int32 var_197 = 5;
    const wp::int32 var_198 = 2;
    wp::int32 var_199;
    wp::int32 var_200;
    const wp::int32 var_201 = 1;
    wp::int32 var_202;
    const wp::int32 var_203 = 1;
    wp::int32 var_204;
    wp::int32 var_205;
    const wp::int32 var_206 = 1;
    wp::int32 var_207;
    wp::int32 var_208;
    wp::int32 var_209;
    const wp::int32 var_210 = 6;
    const wp::int32 var_211 = 2;
    wp::int32 var_212;
    wp::int32 var_213;
    const wp::int32 var_214 = 1;
    wp::int32 var_215;
    const wp::int32 var_216 = 1;
    wp::int32 var_217;
    wp::int32 var_218;
    const wp::int32 var_219 = 1;
    wp::int32 var_220;
    wp::int32 var_221;
    wp::int32 var_222;
    const wp::int32 var_223 = 7;
    const wp::int32 var_224 = 2;
    wp::int32 var_225;
    wp::int32 var_226;
    const wp::int32 var_227 = 1;
    wp::int32 var_228;
    const wp::int32 var_229 = 1;
    wp::int32 var_230;
    wp::int32 var_231;
    const wp::int32 var_232 = 1;
    wp::int32 var_233;
    wp::int32 var_234;
    wp::int32 var_235;
    wp::int32 var_236;
    //---------
    // forward
    // def cell_voxels(block, x, y, z, seen__neighbors):                                      <L 1>
    // voxels = cube(-1)                                                                      <L 3>
    var_1 = wp::vec_t<8, wp::int32>(var_0);
    // if min(x, min(y, z)) >= 0 and max(x, max(y, z)) < SIDE - 1:                            <L 4>
    var_3 = wp::min(var_y, var_z);
    var_4 = wp::min(var_x, var_3);
    var_6 = (var_4 >= var_5);
    var_2 = var_6;
    if (var_2) {
        var_7 = wp::max(var_y, var_z);
        var_8 = wp::max(var_x, var_7);
        var_11 = wp::sub(var_9, var_10);
        var_12 = (var_8 < var_11);
        var_2 = var_2 && var_12;
    }
    if (var_2) {
        // first = block * BLOCK_VOXELS + (x * SIDE + y) * SIDE + z                           <L 5>
        var_14 = wp::mul(var_block, var_13);
        var_15 = wp::mul(var_x, var_9);
        var_16 = wp::add(var_15, var_y);
        var_17 = wp::mul(var_16, var_9);
        var_18 = wp::add(var_14, var_17);
        var_19 = wp::add(var_18, var_z);
        // for c in range(8):                                                                 <L 6>
        // voxels[c] = first + ((c >> 2) * SIDE + (c >> 1 & 1)) * SIDE + (c & 1)              <L 7>
        var_22 = wp::rshift(var_20, var_21);
        var_23 = wp::mul(var_22, var_9);
        var_25 = wp::rshift(var_20, var_24);
        var_27 = wp::bit_and(var_25, var_26);
        var_28 = wp::add(var_23, var_27);
        var_29 = wp::mul(var_28, var_9);
        var_30 = wp::add(var_19, var_29);
        var_32 = wp::bit_and(var_20, var_31);
        var_33 = wp::add(var_30, var_32);
        wp::assign_inplace(var_1, var_20, var_33);
        var_36 = wp::rshift(var_34, var_35);
        var_37 = wp::mul(var_36, var_9);
        var_39 = wp::rshift(var_34, var_38);
        var_41 = wp::bit_and(var_39, var_40);
        var_42 = wp::add(var_37, var_41);
        var_43 = wp::mul(var_42, var_9);
        var_44 = wp::add(var_19, var_43);
        var_46 = wp::bit_and(var_34, var_45);
        var_47 = wp::add(var_44, var_46);
        wp::assign_inplace(var_1, var_34, var_47);
        var_50 = wp::rshift(var_48, var_49);
        var_51 = wp::mul(var_50, var_9);
        var_53 = wp::rshift(var_48, var_52);
        var_55 = wp::bit_and(var_53, var_54);
        var_56 = wp::add(var_51, var_55);
        var_57 = wp::mul(var_56, var_9);
        var_58 = wp::add(var_19, var_57);
        var_60 = wp::bit_and(var_48, var_59);
        var_61 = wp::add(var_58, var_60);
        wp::assign_inplace(var_1, var_48, var_61);
        var_64 = wp::rshift(var_62, var_63);
        var_65 = wp::mul(var_64, var_9);
        var_67 = wp::rshift(var_62, var_66);
        var_69 = wp::bit_and(var_67, var_68);
        var_70 = wp::add(var_65, var_69);
        var_71 = wp::mul(var_70, var_9);
        var_72 = wp::add(var_19, var_71);
        var_74 = wp::bit_and(var_62, var_73);
        var_75 = wp::add(var_72, var_74);
        wp::assign_inplace(var_1, var_62, var_75);
        var_78 = wp::rshift(var_76, var_77);
        var_79 = wp::mul(var_78, var_9);
        var_81 = wp::rshift(var_76, var_80);
        var_83 = wp::bit_and(var_81, var_82);
        var_84 = wp::add(var_79, var_83);
        var_85 = wp::mul(var_84, var_9);
        var_86 = wp::add(var_19, var_85);
        var_88 = wp::bit_and(var_76, var_87);
        var_89 = wp::add(var_86, var_88);
        wp::assign_inplace(var_1, var_76, var_89);
        var_92 = wp::rshift(var_90, var_91);
        var_93 = wp::mul(var_92, var_9);
        var_95 = wp::rshift(var_90, var_94);
        var_97 = wp::bit_and(var_95, var_96);
        var_98 = wp::add(var_93, var_97);
        var_99 = wp::mul(var_98, var_9);
        var_100 = wp::add(var_19, var_99);
        var_102 = wp::bit_and(var_90, var_101);
        var_103 = wp::add(var_100, var_102);
        wp::assign_inplace(var_1, var_90, var_103);
        var_106 = wp::rshift(var_104, var_105);
        var_107 = wp::mul(var_106, var_9);
        var_109 = wp::rshift(var_104, var_108);
        var_111 = wp::bit_and(var_109, var_110);
        var_112 = wp::add(var_107, var_111);
        var_113 = wp::mul(var_112, var_9);
        var_114 = wp::add(var_19, var_113);
        var_116 = wp::bit_and(var_104, var_115);
        var_117 = wp::add(var_114, var_116);
        wp::assign_inplace(var_1, var_104, var_117);
        var_120 = wp::rshift(var_118, var_119);
        var_121 = wp::mul(var_120, var_9);
        var_123 = wp::rshift(var_118, var_122);
        var_125 = wp::bit_and(var_123, var_124);
        var_126 = wp::add(var_121, var_125);
        var_127 = wp::mul(var_126, var_9);
        var_128 = wp::add(var_19, var_127);
        var_130 = wp::bit_and(var_118, var_129);
        var_131 = wp::add(var_128, var_130);
        wp::assign_inplace(var_1, var_118, var_131);
    }
    if (!var_2) {
        // for c in range(8):                                                                 <L 9>
        // voxels[c] = voxel_around(block, x + (c >> 2), y + (c >> 1 & 1), z + (c & 1), seen__neighbors)       <L 10>
        var_134 = wp::rshift(var_132, var_133);
        var_135 = wp::add(var_x, var_134);
        var_137 = wp::rshift(var_132, var_136);
        var_139 = wp::bit_and(var_137, var_138);
        var_140 = wp::add(var_y, var_139);
        var_142 = wp::bit_and(var_132, var_141);
        var_143 = wp::add(var_z, var_142);
        var_144 = voxel_around_0(var_block, var_135, var_140, var_143, var_seen__neighbors);
        wp::assign_inplace(var_1, var_132, var_144);
        var_147 = wp::rshift(var_145, var_146);
        var_148 = wp::add(var_x, var_147);
        var_150 = wp::rshift(var_145, var_149);
        var_152 = wp::bit_and(var_150, var_151);
        var_153 = wp::add(var_y, var_152);
        var_155 = wp::bit_and(var_145, var_154);
        var_156 = wp::add(var_z, var_155);
        var_157 = voxel_around_0(var_block, var_148, var_153, var_156, var_seen__neighbors);
        wp::assign_inplace(var_1, var_145, var_157);
        var_160 = wp::rshift(var_158, var_159);
        var_161 = wp::add(var_x, var_160);
        var_163 = wp::rshift(var_158, var_162);
        var_165 = wp::bit_and(var_163, var_164);
        var_166 = wp::add(var_y, var_165);
        var_168 = wp::bit_and(var_158, var_167);
        var_169 = wp::add(var_z, var_168);
        var_170 = voxel_around_0(var_block, var_161, var_166, var_169, var_seen__neighbors);
        wp::assign_inplace(var_1, var_158, var_170);
        var_173 = wp::rshift(var_171, var_172);
        var_174 = wp::add(var_x, var_173);
        var_176 = wp::rshift(var_171, var_175);
        var_178 = wp::bit_and(var_176, var_177);
        var_179 = wp::add(var_y, var_178);
        var_181 = wp::bit_and(var_171, var_180);
        var_182 = wp::add(var_z, var_181);
        var_183 = voxel_around_0(var_block, var_174, var_179, var_182, var_seen__neighbors);
        wp::assign_inplace(var_1, var_171, var_183);
        var_186 = wp::rshift(var_184, var_185);
        var_187 = wp::add(var_x, var_186);
        var_189 = wp::rshift(var_184, var_188);
        var_191 = wp::bit_and(var_189, var_190);
        var_192 = wp::add(var_y, var_191);
        var_194 = wp::bit_and(var_184, var_193);
        var_195 = wp::add(var_z, var_194);
        var_196 = voxel_around_0(var_block, var_187, var_192, var_195, var_seen__neighbors);
        wp::assign_inplace(var_1, var_184, var_196);
        var_199 = wp::rshift(var_197, var_198);
        var_200 = wp::add(var_x, var_199);
        var_202 = wp::rshift(var_197, var_201);
        var_204 = wp::bit_and(var_202, var_203);
        var_205 = wp::add(var_y, var_204);
        var_207 = wp::bit_and(var_197, var_206);
        var_208 = wp::add(var_z, var_207);
        var_209 = voxel_around_0(var_block, var_200, var_205, var_208, var_seen__neighbors);
        wp::assign_inplace(var_1, var_197, var_209);
        var_212 = wp::rshift(var_210, var_211);
        var_213 = wp::add(var_x, var_212);
        var_215 = wp::rshift(var_210, var_214);
        var_217 = wp::bit_and(var_215, var_216);
        var_218 = wp::add(var_y, var_217);
        var_220 = wp::bit_and(var_210, var_219);
        var_221 = wp::add(var_z, var_220);
        var_222 = voxel_around_0(var_block, var_213, var_218, var_221, var_seen__neighbors);
        wp::assign_inplace(var_1, var_210, var_222);
        var_225 = wp::rshift(var_223, var_224);
        var_226 = wp::add(var_x, var_225);
        var_228 = wp::rshift(var_223, var_227);
        var_230 = wp::bit_and(var_228, var_229);
        var_231 = wp::add(var_y, var_230);
        var_233 = wp::bit_and(var_223, var_232);
        var_234 = wp::add(var_z, var_233);
        var_235 = voxel_around_0(var_block, var_226, var_231, var_234, var_seen__neighbors);
        wp::assign_inplace(var_1, var_223, var_235);
    }
    var_236 = wp::where(var_2, var_118, var_223);
    // return voxels                                                                          <L 11>
    return var_1;
}


// <pointloom.kernels.volumes.voxel_samples.seen_distance>:1
static CUDA_CALLABLE wp::float32 seen_distance_0(
    wp::int32 var_voxel,
    wp::array_t<wp::float32> var_seen__blocks__distances,
    wp::array_t<wp::uint16> var_seen__blocks__weights,
    wp::float32 var_seen__threshold)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 2.0;
    wp::float32 var_1;
    const wp::int32 var_2 = 0;
    bool var_3;
    wp::uint16* var_4;
    wp::float32 var_5;
    wp::uint16 var_6;
    bool var_7;
    wp::float32* var_8;
    wp::float32 var_9;
    wp::float32 var_10;
    wp::float32 var_11;
    wp::float32 var_12;
    //---------
    // forward
    // def seen_distance(voxel, seen__blocks__distances, seen__blocks__weights, seen__threshold):       <L 1>
    // d = float(UNSEEN)                                                                      <L 3>
    var_1 = wp::float(var_0);
    // if voxel >= 0:                                                                         <L 4>
    var_3 = (var_voxel >= var_2);
    if (var_3) {
        // if float(seen__blocks__weights[voxel]) > seen__threshold:                          <L 5>
        var_4 = wp::address(var_seen__blocks__weights, var_voxel);
        var_6 = wp::load(var_4);
        var_5 = wp::float(var_6);
        var_7 = (var_5 > var_seen__threshold);
        if (var_7) {
            // d = seen__blocks__distances[voxel]                                             <L 6>
            var_8 = wp::address(var_seen__blocks__distances, var_voxel);
            var_10 = wp::load(var_8);
            var_9 = wp::copy(var_10);
        }
        var_11 = wp::where(var_7, var_9, var_1);
    }
    var_12 = wp::where(var_3, var_11, var_1);
    // return d                                                                               <L 7>
    return var_12;
}


// <pointloom.kernels.volumes.voxel_samples.corner_distances>:1
static CUDA_CALLABLE wp::vec_t<8, wp::float32> corner_distances_0(
    wp::vec_t<8, wp::int32> var_voxels,
    wp::array_t<wp::float32> var_seen__blocks__distances,
    wp::array_t<wp::uint16> var_seen__blocks__weights,
    wp::float32 var_seen__threshold)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 2.0;
    wp::vec_t<8, wp::float32> var_1;
    const wp::int32 var_2 = 0;
    wp::int32 var_3;
    wp::float32 var_4;
    const wp::int32 var_5 = 1;
    wp::int32 var_6;
    wp::float32 var_7;
    const wp::int32 var_8 = 2;
    wp::int32 var_9;
    wp::float32 var_10;
    const wp::int32 var_11 = 3;
    wp::int32 var_12;
    wp::float32 var_13;
    const wp::int32 var_14 = 4;
    wp::int32 var_15;
    wp::float32 var_16;
    const wp::int32 var_17 = 5;
    wp::int32 var_18;
    wp::float32 var_19;
    const wp::int32 var_20 = 6;
    wp::int32 var_21;
    wp::float32 var_22;
    const wp::int32 var_23 = 7;
    wp::int32 var_24;
    wp::float32 var_25;
    //---------
    // forward
    // def corner_distances(voxels, seen__blocks__distances, seen__blocks__weights, seen__threshold):       <L 1>
    // values = octet(UNSEEN)                                                                 <L 2>
    var_1 = wp::vec_t<8, wp::float32>(var_0);
    // for c in range(8):                                                                     <L 3>
    // values[c] = seen_distance(voxels[c], seen__blocks__distances, seen__blocks__weights, seen__threshold)       <L 4>
    var_3 = wp::extract(var_voxels, var_2);
    var_4 = seen_distance_0(var_3, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__threshold);
    wp::assign_inplace(var_1, var_2, var_4);
    var_6 = wp::extract(var_voxels, var_5);
    var_7 = seen_distance_0(var_6, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__threshold);
    wp::assign_inplace(var_1, var_5, var_7);
    var_9 = wp::extract(var_voxels, var_8);
    var_10 = seen_distance_0(var_9, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__threshold);
    wp::assign_inplace(var_1, var_8, var_10);
    var_12 = wp::extract(var_voxels, var_11);
    var_13 = seen_distance_0(var_12, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__threshold);
    wp::assign_inplace(var_1, var_11, var_13);
    var_15 = wp::extract(var_voxels, var_14);
    var_16 = seen_distance_0(var_15, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__threshold);
    wp::assign_inplace(var_1, var_14, var_16);
    var_18 = wp::extract(var_voxels, var_17);
    var_19 = seen_distance_0(var_18, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__threshold);
    wp::assign_inplace(var_1, var_17, var_19);
    var_21 = wp::extract(var_voxels, var_20);
    var_22 = seen_distance_0(var_21, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__threshold);
    wp::assign_inplace(var_1, var_20, var_22);
    var_24 = wp::extract(var_voxels, var_23);
    var_25 = seen_distance_0(var_24, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__threshold);
    wp::assign_inplace(var_1, var_23, var_25);
    // return values                                                                          <L 5>
    return var_1;
}


// /work/main/src/pointloom/kernels/volumes/voxel_samples.py:82
static CUDA_CALLABLE wp::float32 greatest_0(
    wp::vec_t<8, wp::float32> var_corners)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    const wp::int32 var_2 = 1;
    wp::float32 var_3;
    wp::float32 var_4;
    const wp::int32 var_5 = 2;
    wp::float32 var_6;
    const wp::int32 var_7 = 3;
    wp::float32 var_8;
    wp::float32 var_9;
    wp::float32 var_10;
    const wp::int32 var_11 = 4;
    wp::float32 var_12;
    const wp::int32 var_13 = 5;
    wp::float32 var_14;
    wp::float32 var_15;
    const wp::int32 var_16 = 6;
    wp::float32 var_17;
    const wp::int32 var_18 = 7;
    wp::float32 var_19;
    wp::float32 var_20;
    wp::float32 var_21;
    wp::float32 var_22;
    //---------
    // forward
    // def greatest(corners: octet) -> float:                                                 <L 83>
    // low = max(max(corners[0], corners[1]), max(corners[2], corners[3]))                    <L 84>
    var_1 = wp::extract(var_corners, var_0);
    var_3 = wp::extract(var_corners, var_2);
    var_4 = wp::max(var_1, var_3);
    var_6 = wp::extract(var_corners, var_5);
    var_8 = wp::extract(var_corners, var_7);
    var_9 = wp::max(var_6, var_8);
    var_10 = wp::max(var_4, var_9);
    // return max(low, max(max(corners[4], corners[5]), max(corners[6], corners[7])))         <L 85>
    var_12 = wp::extract(var_corners, var_11);
    var_14 = wp::extract(var_corners, var_13);
    var_15 = wp::max(var_12, var_14);
    var_17 = wp::extract(var_corners, var_16);
    var_19 = wp::extract(var_corners, var_18);
    var_20 = wp::max(var_17, var_19);
    var_21 = wp::max(var_15, var_20);
    var_22 = wp::max(var_10, var_21);
    return var_22;
}


// /work/main/src/pointloom/kernels/volumes/voxel_samples.py:88
static CUDA_CALLABLE wp::float32 between_0(
    wp::float32 var_a,
    wp::float32 var_b,
    wp::float32 var_share)
{
    //---------
    // primal vars
    wp::float32 var_0;
    wp::float32 var_1;
    wp::float32 var_2;
    //---------
    // forward
    // def between(a: float, b: float, share: float) -> float:                                <L 89>
    // return a + share * (b - a)                                                             <L 90>
    var_0 = wp::sub(var_b, var_a);
    var_1 = wp::mul(var_share, var_0);
    var_2 = wp::add(var_a, var_1);
    return var_2;
}


// <pointloom.kernels.volumes.ray_images.side_distance>:1
static CUDA_CALLABLE wp::float32 side_distance_0(
    wp::int32 var_block,
    wp::int32 var_x,
    wp::int32 var_y,
    wp::int32 var_z,
    wp::array_t<wp::float32> var_seen__blocks__distances,
    wp::array_t<wp::uint16> var_seen__blocks__weights,
    wp::array_t<wp::int32> var_seen__neighbors,
    wp::float32 var_seen__threshold)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::float32 var_1;
    //---------
    // forward
    // def side_distance(block, x, y, z, seen__blocks__distances, seen__blocks__weights, seen__neighbors, seen__threshold):       <L 1>
    // return seen_distance(voxel_around(block, x, y, z, seen__neighbors), seen__blocks__distances, seen__blocks__weights, seen__threshold)       <L 3>
    var_0 = voxel_around_0(var_block, var_x, var_y, var_z, var_seen__neighbors);
    var_1 = seen_distance_0(var_0, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__threshold);
    return var_1;
}


// /work/main/src/pointloom/kernels/volumes/ray_images.py:101
static CUDA_CALLABLE wp::float32 mean_of_four_0(
    wp::float32 var_a,
    wp::float32 var_b,
    wp::float32 var_c,
    wp::float32 var_d,
    wp::float32 var_fu,
    wp::float32 var_fv)
{
    //---------
    // primal vars
    wp::float32 var_0;
    wp::float32 var_1;
    wp::float32 var_2;
    wp::float32 var_3;
    wp::float32 var_4;
    wp::float32 var_5;
    const wp::float32 var_6 = 2.0;
    bool var_7;
    wp::float32 var_8;
    wp::float32 var_9;
    //---------
    // forward
    // def mean_of_four(a: float, b: float, c: float, d: float, fu: float, fv: float) -> float:       <L 102>
    // mean = between(between(a, b, fv), between(c, d, fv), fu)                               <L 104>
    var_0 = between_0(var_a, var_b, var_fv);
    var_1 = between_0(var_c, var_d, var_fv);
    var_2 = between_0(var_0, var_1, var_fu);
    // if max(max(a, b), max(c, d)) >= UNSEEN:                                                <L 105>
    var_3 = wp::max(var_a, var_b);
    var_4 = wp::max(var_c, var_d);
    var_5 = wp::max(var_3, var_4);
    var_7 = (var_5 >= var_6);
    if (var_7) {
        // mean = float(UNSEEN)                                                               <L 106>
        var_8 = wp::float(var_6);
    }
    var_9 = wp::where(var_7, var_8, var_2);
    // return mean                                                                            <L 107>
    return var_9;
}


// /work/main/src/pointloom/kernels/volumes/ray_images.py:83
static CUDA_CALLABLE wp::float32 slope_along_0(
    wp::float32 var_low,
    wp::float32 var_high,
    wp::float32 var_beyond,
    wp::float32 var_middle,
    wp::float32 var_share,
    wp::int32 var_is_up)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 2.0;
    wp::float32 var_1;
    const wp::int32 var_2 = 1;
    bool var_3;
    const wp::float32 var_4 = 0.5;
    wp::float32 var_5;
    wp::float32 var_6;
    const wp::float32 var_7 = 2.0;
    wp::float32 var_8;
    wp::float32 var_9;
    bool var_10;
    const wp::float32 var_11 = 0.5;
    wp::float32 var_12;
    wp::float32 var_13;
    wp::float32 var_14;
    wp::float32 var_15;
    const wp::float32 var_16 = 0.5;
    wp::float32 var_17;
    wp::float32 var_18;
    const wp::float32 var_19 = 2.0;
    wp::float32 var_20;
    wp::float32 var_21;
    bool var_22;
    const wp::float32 var_23 = 0.5;
    wp::float32 var_24;
    wp::float32 var_25;
    wp::float32 var_26;
    wp::float32 var_27;
    wp::float32 var_28;
    //---------
    // forward
    // def slope_along(low: float, high: float, beyond: float, middle: float, share: float, is_up: int) -> float:       <L 84>
    // slope = float(UNSEEN)                                                                  <L 87>
    var_1 = wp::float(var_0);
    // if is_up == 1:                                                                         <L 88>
    var_3 = (var_is_up == var_2);
    if (var_3) {
        // before = between(low, high, share - 0.5)                                           <L 89>
        var_5 = wp::sub(var_share, var_4);
        var_6 = between_0(var_low, var_high, var_5);
        // slope = 2.0 * (middle - before)                                                    <L 90>
        var_8 = wp::sub(var_middle, var_6);
        var_9 = wp::mul(var_7, var_8);
        // if beyond < UNSEEN:                                                                <L 91>
        var_10 = (var_beyond < var_0);
        if (var_10) {
            // slope = between(high, beyond, share - 0.5) - before                            <L 92>
            var_12 = wp::sub(var_share, var_11);
            var_13 = between_0(var_high, var_beyond, var_12);
            var_14 = wp::sub(var_13, var_6);
        }
        var_15 = wp::where(var_10, var_14, var_9);
    }
    if (!var_3) {
        // behind = between(low, high, share + 0.5)                                           <L 94>
        var_17 = wp::add(var_share, var_16);
        var_18 = between_0(var_low, var_high, var_17);
        // slope = 2.0 * (behind - middle)                                                    <L 95>
        var_20 = wp::sub(var_18, var_middle);
        var_21 = wp::mul(var_19, var_20);
        // if beyond < UNSEEN:                                                                <L 96>
        var_22 = (var_beyond < var_0);
        if (var_22) {
            // slope = behind - between(beyond, low, share + 0.5)                             <L 97>
            var_24 = wp::add(var_share, var_23);
            var_25 = between_0(var_beyond, var_low, var_24);
            var_26 = wp::sub(var_18, var_25);
        }
        var_27 = wp::where(var_22, var_26, var_21);
    }
    var_28 = wp::where(var_3, var_15, var_27);
    // return slope                                                                           <L 98>
    return var_28;
}


// <pointloom.kernels.volumes.ray_images.slopes_at>:1
static CUDA_CALLABLE wp::vec_t<3, wp::float32> slopes_at_0(
    wp::int32 var_block,
    wp::int32 var_x,
    wp::int32 var_y,
    wp::int32 var_z,
    wp::vec_t<3, wp::float32> var_f,
    wp::vec_t<8, wp::float32> var_c,
    wp::array_t<wp::float32> var_seen__blocks__distances,
    wp::array_t<wp::uint16> var_seen__blocks__weights,
    wp::array_t<wp::int32> var_seen__neighbors,
    wp::float32 var_seen__threshold)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    const wp::float32 var_2 = 0.5;
    bool var_3;
    wp::int32 var_4;
    const wp::int32 var_5 = 1;
    wp::float32 var_6;
    const wp::float32 var_7 = 0.5;
    bool var_8;
    wp::int32 var_9;
    const wp::int32 var_10 = 2;
    wp::float32 var_11;
    const wp::float32 var_12 = 0.5;
    bool var_13;
    wp::int32 var_14;
    const wp::int32 var_15 = 1;
    wp::int32 var_16;
    const wp::int32 var_17 = 3;
    wp::int32 var_18;
    wp::int32 var_19;
    const wp::int32 var_20 = 1;
    wp::int32 var_21;
    const wp::int32 var_22 = 3;
    wp::int32 var_23;
    wp::int32 var_24;
    const wp::int32 var_25 = 1;
    wp::int32 var_26;
    const wp::int32 var_27 = 3;
    wp::int32 var_28;
    wp::int32 var_29;
    const wp::int32 var_30 = 0;
    wp::float32 var_31;
    const wp::int32 var_32 = 1;
    wp::float32 var_33;
    const wp::int32 var_34 = 2;
    wp::float32 var_35;
    wp::float32 var_36;
    const wp::int32 var_37 = 2;
    wp::float32 var_38;
    const wp::int32 var_39 = 3;
    wp::float32 var_40;
    const wp::int32 var_41 = 2;
    wp::float32 var_42;
    wp::float32 var_43;
    const wp::int32 var_44 = 4;
    wp::float32 var_45;
    const wp::int32 var_46 = 5;
    wp::float32 var_47;
    const wp::int32 var_48 = 2;
    wp::float32 var_49;
    wp::float32 var_50;
    const wp::int32 var_51 = 6;
    wp::float32 var_52;
    const wp::int32 var_53 = 7;
    wp::float32 var_54;
    const wp::int32 var_55 = 2;
    wp::float32 var_56;
    wp::float32 var_57;
    const wp::int32 var_58 = 1;
    wp::float32 var_59;
    wp::float32 var_60;
    const wp::int32 var_61 = 1;
    wp::float32 var_62;
    wp::float32 var_63;
    const wp::int32 var_64 = 0;
    wp::float32 var_65;
    wp::float32 var_66;
    const wp::float32 var_67 = 2.0;
    wp::vec_t<8, wp::float32> var_68;
    const wp::int32 var_69 = 0;
    const wp::int32 var_70 = 1;
    wp::int32 var_71;
    wp::int32 var_72;
    const wp::int32 var_73 = 1;
    wp::int32 var_74;
    wp::int32 var_75;
    wp::float32 var_76;
    const wp::int32 var_77 = 1;
    const wp::int32 var_78 = 1;
    wp::int32 var_79;
    wp::int32 var_80;
    const wp::int32 var_81 = 1;
    wp::int32 var_82;
    wp::int32 var_83;
    wp::float32 var_84;
    const wp::int32 var_85 = 2;
    const wp::int32 var_86 = 1;
    wp::int32 var_87;
    wp::int32 var_88;
    const wp::int32 var_89 = 1;
    wp::int32 var_90;
    wp::int32 var_91;
    wp::float32 var_92;
    const wp::int32 var_93 = 3;
    const wp::int32 var_94 = 1;
    wp::int32 var_95;
    wp::int32 var_96;
    const wp::int32 var_97 = 1;
    wp::int32 var_98;
    wp::int32 var_99;
    wp::float32 var_100;
    wp::vec_t<8, wp::float32> var_101;
    const wp::int32 var_102 = 0;
    const wp::int32 var_103 = 1;
    wp::int32 var_104;
    wp::int32 var_105;
    const wp::int32 var_106 = 1;
    wp::int32 var_107;
    wp::int32 var_108;
    wp::float32 var_109;
    const wp::int32 var_110 = 1;
    const wp::int32 var_111 = 1;
    wp::int32 var_112;
    wp::int32 var_113;
    const wp::int32 var_114 = 1;
    wp::int32 var_115;
    wp::int32 var_116;
    wp::float32 var_117;
    const wp::int32 var_118 = 2;
    const wp::int32 var_119 = 1;
    wp::int32 var_120;
    wp::int32 var_121;
    const wp::int32 var_122 = 1;
    wp::int32 var_123;
    wp::int32 var_124;
    wp::float32 var_125;
    const wp::int32 var_126 = 3;
    const wp::int32 var_127 = 1;
    wp::int32 var_128;
    wp::int32 var_129;
    const wp::int32 var_130 = 1;
    wp::int32 var_131;
    wp::int32 var_132;
    wp::float32 var_133;
    wp::vec_t<8, wp::float32> var_134;
    const wp::int32 var_135 = 0;
    const wp::int32 var_136 = 1;
    wp::int32 var_137;
    wp::int32 var_138;
    const wp::int32 var_139 = 1;
    wp::int32 var_140;
    wp::int32 var_141;
    wp::float32 var_142;
    const wp::int32 var_143 = 1;
    const wp::int32 var_144 = 1;
    wp::int32 var_145;
    wp::int32 var_146;
    const wp::int32 var_147 = 1;
    wp::int32 var_148;
    wp::int32 var_149;
    wp::float32 var_150;
    const wp::int32 var_151 = 2;
    const wp::int32 var_152 = 1;
    wp::int32 var_153;
    wp::int32 var_154;
    const wp::int32 var_155 = 1;
    wp::int32 var_156;
    wp::int32 var_157;
    wp::float32 var_158;
    const wp::int32 var_159 = 3;
    const wp::int32 var_160 = 1;
    wp::int32 var_161;
    wp::int32 var_162;
    const wp::int32 var_163 = 1;
    wp::int32 var_164;
    wp::int32 var_165;
    wp::float32 var_166;
    const wp::int32 var_167 = 0;
    wp::float32 var_168;
    const wp::int32 var_169 = 1;
    wp::float32 var_170;
    const wp::int32 var_171 = 2;
    wp::float32 var_172;
    const wp::int32 var_173 = 3;
    wp::float32 var_174;
    const wp::int32 var_175 = 1;
    wp::float32 var_176;
    const wp::int32 var_177 = 2;
    wp::float32 var_178;
    wp::float32 var_179;
    const wp::int32 var_180 = 0;
    wp::float32 var_181;
    const wp::int32 var_182 = 1;
    wp::float32 var_183;
    const wp::int32 var_184 = 2;
    wp::float32 var_185;
    const wp::int32 var_186 = 3;
    wp::float32 var_187;
    const wp::int32 var_188 = 0;
    wp::float32 var_189;
    const wp::int32 var_190 = 2;
    wp::float32 var_191;
    wp::float32 var_192;
    const wp::int32 var_193 = 0;
    wp::float32 var_194;
    const wp::int32 var_195 = 1;
    wp::float32 var_196;
    const wp::int32 var_197 = 2;
    wp::float32 var_198;
    const wp::int32 var_199 = 3;
    wp::float32 var_200;
    const wp::int32 var_201 = 0;
    wp::float32 var_202;
    const wp::int32 var_203 = 1;
    wp::float32 var_204;
    wp::float32 var_205;
    const wp::int32 var_206 = 0;
    wp::float32 var_207;
    const wp::int32 var_208 = 2;
    wp::float32 var_209;
    const wp::int32 var_210 = 1;
    wp::float32 var_211;
    wp::float32 var_212;
    const wp::int32 var_213 = 4;
    wp::float32 var_214;
    const wp::int32 var_215 = 6;
    wp::float32 var_216;
    const wp::int32 var_217 = 1;
    wp::float32 var_218;
    wp::float32 var_219;
    const wp::int32 var_220 = 0;
    wp::float32 var_221;
    wp::float32 var_222;
    const wp::int32 var_223 = 1;
    wp::float32 var_224;
    const wp::int32 var_225 = 3;
    wp::float32 var_226;
    const wp::int32 var_227 = 1;
    wp::float32 var_228;
    wp::float32 var_229;
    const wp::int32 var_230 = 5;
    wp::float32 var_231;
    const wp::int32 var_232 = 7;
    wp::float32 var_233;
    const wp::int32 var_234 = 1;
    wp::float32 var_235;
    wp::float32 var_236;
    const wp::int32 var_237 = 0;
    wp::float32 var_238;
    wp::float32 var_239;
    const wp::int32 var_240 = 0;
    wp::float32 var_241;
    wp::float32 var_242;
    const wp::int32 var_243 = 0;
    wp::float32 var_244;
    wp::float32 var_245;
    const wp::int32 var_246 = 0;
    wp::float32 var_247;
    wp::float32 var_248;
    const wp::int32 var_249 = 1;
    wp::float32 var_250;
    wp::float32 var_251;
    const wp::int32 var_252 = 2;
    wp::float32 var_253;
    wp::float32 var_254;
    wp::vec_t<3, wp::float32> var_255;
    //---------
    // forward
    // def slopes_at(block, x, y, z, f, c, seen__blocks__distances, seen__blocks__weights, seen__neighbors, seen__threshold):       <L 1>
    // up_x = int(f[0] >= 0.5)                                                                <L 4>
    var_1 = wp::extract(var_f, var_0);
    var_3 = (var_1 >= var_2);
    var_4 = wp::int(var_3);
    // up_y = int(f[1] >= 0.5)                                                                <L 5>
    var_6 = wp::extract(var_f, var_5);
    var_8 = (var_6 >= var_7);
    var_9 = wp::int(var_8);
    // up_z = int(f[2] >= 0.5)                                                                <L 6>
    var_11 = wp::extract(var_f, var_10);
    var_13 = (var_11 >= var_12);
    var_14 = wp::int(var_13);
    // bx = x - 1 + 3 * up_x                                                                  <L 7>
    var_16 = wp::sub(var_x, var_15);
    var_18 = wp::mul(var_17, var_4);
    var_19 = wp::add(var_16, var_18);
    // by = y - 1 + 3 * up_y                                                                  <L 8>
    var_21 = wp::sub(var_y, var_20);
    var_23 = wp::mul(var_22, var_9);
    var_24 = wp::add(var_21, var_23);
    // bz = z - 1 + 3 * up_z                                                                  <L 9>
    var_26 = wp::sub(var_z, var_25);
    var_28 = wp::mul(var_27, var_14);
    var_29 = wp::add(var_26, var_28);
    // c00 = between(c[0], c[1], f[2])                                                        <L 10>
    var_31 = wp::extract(var_c, var_30);
    var_33 = wp::extract(var_c, var_32);
    var_35 = wp::extract(var_f, var_34);
    var_36 = between_0(var_31, var_33, var_35);
    // c01 = between(c[2], c[3], f[2])                                                        <L 11>
    var_38 = wp::extract(var_c, var_37);
    var_40 = wp::extract(var_c, var_39);
    var_42 = wp::extract(var_f, var_41);
    var_43 = between_0(var_38, var_40, var_42);
    // c10 = between(c[4], c[5], f[2])                                                        <L 12>
    var_45 = wp::extract(var_c, var_44);
    var_47 = wp::extract(var_c, var_46);
    var_49 = wp::extract(var_f, var_48);
    var_50 = between_0(var_45, var_47, var_49);
    // c11 = between(c[6], c[7], f[2])                                                        <L 13>
    var_52 = wp::extract(var_c, var_51);
    var_54 = wp::extract(var_c, var_53);
    var_56 = wp::extract(var_f, var_55);
    var_57 = between_0(var_52, var_54, var_56);
    // low_x = between(c00, c01, f[1])                                                        <L 14>
    var_59 = wp::extract(var_f, var_58);
    var_60 = between_0(var_36, var_43, var_59);
    // high_x = between(c10, c11, f[1])                                                       <L 15>
    var_62 = wp::extract(var_f, var_61);
    var_63 = between_0(var_50, var_57, var_62);
    // middle = between(low_x, high_x, f[0])                                                  <L 16>
    var_65 = wp::extract(var_f, var_64);
    var_66 = between_0(var_60, var_63, var_65);
    // far_x = octet(UNSEEN)                                                                  <L 17>
    var_68 = wp::vec_t<8, wp::float32>(var_67);
    // for k in range(4):                                                                     <L 18>
    // far_x[k] = side_distance(block, bx, y + (k >> 1), z + (k & 1), seen__blocks__distances, seen__blocks__weights, seen__neighbors, seen__threshold)       <L 19>
    var_71 = wp::rshift(var_69, var_70);
    var_72 = wp::add(var_y, var_71);
    var_74 = wp::bit_and(var_69, var_73);
    var_75 = wp::add(var_z, var_74);
    var_76 = side_distance_0(var_block, var_19, var_72, var_75, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__neighbors, var_seen__threshold);
    wp::assign_inplace(var_68, var_69, var_76);
    var_79 = wp::rshift(var_77, var_78);
    var_80 = wp::add(var_y, var_79);
    var_82 = wp::bit_and(var_77, var_81);
    var_83 = wp::add(var_z, var_82);
    var_84 = side_distance_0(var_block, var_19, var_80, var_83, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__neighbors, var_seen__threshold);
    wp::assign_inplace(var_68, var_77, var_84);
    var_87 = wp::rshift(var_85, var_86);
    var_88 = wp::add(var_y, var_87);
    var_90 = wp::bit_and(var_85, var_89);
    var_91 = wp::add(var_z, var_90);
    var_92 = side_distance_0(var_block, var_19, var_88, var_91, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__neighbors, var_seen__threshold);
    wp::assign_inplace(var_68, var_85, var_92);
    var_95 = wp::rshift(var_93, var_94);
    var_96 = wp::add(var_y, var_95);
    var_98 = wp::bit_and(var_93, var_97);
    var_99 = wp::add(var_z, var_98);
    var_100 = side_distance_0(var_block, var_19, var_96, var_99, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__neighbors, var_seen__threshold);
    wp::assign_inplace(var_68, var_93, var_100);
    // far_y = octet(UNSEEN)                                                                  <L 20>
    var_101 = wp::vec_t<8, wp::float32>(var_67);
    // for k in range(4):                                                                     <L 21>
    // far_y[k] = side_distance(block, x + (k >> 1), by, z + (k & 1), seen__blocks__distances, seen__blocks__weights, seen__neighbors, seen__threshold)       <L 22>
    var_104 = wp::rshift(var_102, var_103);
    var_105 = wp::add(var_x, var_104);
    var_107 = wp::bit_and(var_102, var_106);
    var_108 = wp::add(var_z, var_107);
    var_109 = side_distance_0(var_block, var_105, var_24, var_108, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__neighbors, var_seen__threshold);
    wp::assign_inplace(var_101, var_102, var_109);
    var_112 = wp::rshift(var_110, var_111);
    var_113 = wp::add(var_x, var_112);
    var_115 = wp::bit_and(var_110, var_114);
    var_116 = wp::add(var_z, var_115);
    var_117 = side_distance_0(var_block, var_113, var_24, var_116, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__neighbors, var_seen__threshold);
    wp::assign_inplace(var_101, var_110, var_117);
    var_120 = wp::rshift(var_118, var_119);
    var_121 = wp::add(var_x, var_120);
    var_123 = wp::bit_and(var_118, var_122);
    var_124 = wp::add(var_z, var_123);
    var_125 = side_distance_0(var_block, var_121, var_24, var_124, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__neighbors, var_seen__threshold);
    wp::assign_inplace(var_101, var_118, var_125);
    var_128 = wp::rshift(var_126, var_127);
    var_129 = wp::add(var_x, var_128);
    var_131 = wp::bit_and(var_126, var_130);
    var_132 = wp::add(var_z, var_131);
    var_133 = side_distance_0(var_block, var_129, var_24, var_132, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__neighbors, var_seen__threshold);
    wp::assign_inplace(var_101, var_126, var_133);
    // far_z = octet(UNSEEN)                                                                  <L 23>
    var_134 = wp::vec_t<8, wp::float32>(var_67);
    // for k in range(4):                                                                     <L 24>
    // far_z[k] = side_distance(block, x + (k >> 1), y + (k & 1), bz, seen__blocks__distances, seen__blocks__weights, seen__neighbors, seen__threshold)       <L 25>
    var_137 = wp::rshift(var_135, var_136);
    var_138 = wp::add(var_x, var_137);
    var_140 = wp::bit_and(var_135, var_139);
    var_141 = wp::add(var_y, var_140);
    var_142 = side_distance_0(var_block, var_138, var_141, var_29, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__neighbors, var_seen__threshold);
    wp::assign_inplace(var_134, var_135, var_142);
    var_145 = wp::rshift(var_143, var_144);
    var_146 = wp::add(var_x, var_145);
    var_148 = wp::bit_and(var_143, var_147);
    var_149 = wp::add(var_y, var_148);
    var_150 = side_distance_0(var_block, var_146, var_149, var_29, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__neighbors, var_seen__threshold);
    wp::assign_inplace(var_134, var_143, var_150);
    var_153 = wp::rshift(var_151, var_152);
    var_154 = wp::add(var_x, var_153);
    var_156 = wp::bit_and(var_151, var_155);
    var_157 = wp::add(var_y, var_156);
    var_158 = side_distance_0(var_block, var_154, var_157, var_29, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__neighbors, var_seen__threshold);
    wp::assign_inplace(var_134, var_151, var_158);
    var_161 = wp::rshift(var_159, var_160);
    var_162 = wp::add(var_x, var_161);
    var_164 = wp::bit_and(var_159, var_163);
    var_165 = wp::add(var_y, var_164);
    var_166 = side_distance_0(var_block, var_162, var_165, var_29, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__neighbors, var_seen__threshold);
    wp::assign_inplace(var_134, var_159, var_166);
    // beyond_x = mean_of_four(far_x[0], far_x[1], far_x[2], far_x[3], f[1], f[2])            <L 26>
    var_168 = wp::extract(var_68, var_167);
    var_170 = wp::extract(var_68, var_169);
    var_172 = wp::extract(var_68, var_171);
    var_174 = wp::extract(var_68, var_173);
    var_176 = wp::extract(var_f, var_175);
    var_178 = wp::extract(var_f, var_177);
    var_179 = mean_of_four_0(var_168, var_170, var_172, var_174, var_176, var_178);
    // beyond_y = mean_of_four(far_y[0], far_y[1], far_y[2], far_y[3], f[0], f[2])            <L 27>
    var_181 = wp::extract(var_101, var_180);
    var_183 = wp::extract(var_101, var_182);
    var_185 = wp::extract(var_101, var_184);
    var_187 = wp::extract(var_101, var_186);
    var_189 = wp::extract(var_f, var_188);
    var_191 = wp::extract(var_f, var_190);
    var_192 = mean_of_four_0(var_181, var_183, var_185, var_187, var_189, var_191);
    // beyond_z = mean_of_four(far_z[0], far_z[1], far_z[2], far_z[3], f[0], f[1])            <L 28>
    var_194 = wp::extract(var_134, var_193);
    var_196 = wp::extract(var_134, var_195);
    var_198 = wp::extract(var_134, var_197);
    var_200 = wp::extract(var_134, var_199);
    var_202 = wp::extract(var_f, var_201);
    var_204 = wp::extract(var_f, var_203);
    var_205 = mean_of_four_0(var_194, var_196, var_198, var_200, var_202, var_204);
    // low_z = between(between(c[0], c[2], f[1]), between(c[4], c[6], f[1]), f[0])            <L 29>
    var_207 = wp::extract(var_c, var_206);
    var_209 = wp::extract(var_c, var_208);
    var_211 = wp::extract(var_f, var_210);
    var_212 = between_0(var_207, var_209, var_211);
    var_214 = wp::extract(var_c, var_213);
    var_216 = wp::extract(var_c, var_215);
    var_218 = wp::extract(var_f, var_217);
    var_219 = between_0(var_214, var_216, var_218);
    var_221 = wp::extract(var_f, var_220);
    var_222 = between_0(var_212, var_219, var_221);
    // high_z = between(between(c[1], c[3], f[1]), between(c[5], c[7], f[1]), f[0])           <L 30>
    var_224 = wp::extract(var_c, var_223);
    var_226 = wp::extract(var_c, var_225);
    var_228 = wp::extract(var_f, var_227);
    var_229 = between_0(var_224, var_226, var_228);
    var_231 = wp::extract(var_c, var_230);
    var_233 = wp::extract(var_c, var_232);
    var_235 = wp::extract(var_f, var_234);
    var_236 = between_0(var_231, var_233, var_235);
    var_238 = wp::extract(var_f, var_237);
    var_239 = between_0(var_229, var_236, var_238);
    // return vec3(slope_along(low_x, high_x, beyond_x, middle, f[0], up_x), slope_along(between(c00, c10, f[0]), between(c01, c11, f[0]), beyond_y, middle, f[1], up_y), slope_along(low_z, high_z, beyond_z, middle, f[2], up_z))       <L 31>
    var_241 = wp::extract(var_f, var_240);
    var_242 = slope_along_0(var_60, var_63, var_179, var_66, var_241, var_4);
    var_244 = wp::extract(var_f, var_243);
    var_245 = between_0(var_36, var_50, var_244);
    var_247 = wp::extract(var_f, var_246);
    var_248 = between_0(var_43, var_57, var_247);
    var_250 = wp::extract(var_f, var_249);
    var_251 = slope_along_0(var_245, var_248, var_192, var_66, var_250, var_9);
    var_253 = wp::extract(var_f, var_252);
    var_254 = slope_along_0(var_222, var_239, var_205, var_66, var_253, var_14);
    var_255 = wp::vec_t<3, wp::float32>(var_242, var_251, var_254);
    return var_255;
}


// /work/main/src/pointloom/kernels/volumes/ray_images.py:169
static CUDA_CALLABLE wp::vec_t<3, wp::float32> rotated_back_0(
    wp::vec_t<3, wp::float32> var_v,
    wp::mat_t<3, 3, wp::float64> var_R)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    const wp::int32 var_1 = 0;
    wp::float64 var_2;
    wp::float32 var_3;
    const wp::int32 var_4 = 0;
    wp::float32 var_5;
    wp::float32 var_6;
    const wp::int32 var_7 = 1;
    const wp::int32 var_8 = 0;
    wp::float64 var_9;
    wp::float32 var_10;
    const wp::int32 var_11 = 1;
    wp::float32 var_12;
    wp::float32 var_13;
    wp::float32 var_14;
    const wp::int32 var_15 = 2;
    const wp::int32 var_16 = 0;
    wp::float64 var_17;
    wp::float32 var_18;
    const wp::int32 var_19 = 2;
    wp::float32 var_20;
    wp::float32 var_21;
    wp::float32 var_22;
    const wp::int32 var_23 = 0;
    const wp::int32 var_24 = 1;
    wp::float64 var_25;
    wp::float32 var_26;
    const wp::int32 var_27 = 0;
    wp::float32 var_28;
    wp::float32 var_29;
    const wp::int32 var_30 = 1;
    const wp::int32 var_31 = 1;
    wp::float64 var_32;
    wp::float32 var_33;
    const wp::int32 var_34 = 1;
    wp::float32 var_35;
    wp::float32 var_36;
    wp::float32 var_37;
    const wp::int32 var_38 = 2;
    const wp::int32 var_39 = 1;
    wp::float64 var_40;
    wp::float32 var_41;
    const wp::int32 var_42 = 2;
    wp::float32 var_43;
    wp::float32 var_44;
    wp::float32 var_45;
    const wp::int32 var_46 = 0;
    const wp::int32 var_47 = 2;
    wp::float64 var_48;
    wp::float32 var_49;
    const wp::int32 var_50 = 0;
    wp::float32 var_51;
    wp::float32 var_52;
    const wp::int32 var_53 = 1;
    const wp::int32 var_54 = 2;
    wp::float64 var_55;
    wp::float32 var_56;
    const wp::int32 var_57 = 1;
    wp::float32 var_58;
    wp::float32 var_59;
    wp::float32 var_60;
    const wp::int32 var_61 = 2;
    const wp::int32 var_62 = 2;
    wp::float64 var_63;
    wp::float32 var_64;
    const wp::int32 var_65 = 2;
    wp::float32 var_66;
    wp::float32 var_67;
    wp::float32 var_68;
    wp::vec_t<3, wp::float32> var_69;
    //---------
    // forward
    // def rotated_back(v: vec3, R: mat33d) -> vec3:                                          <L 170>
    // return vec3(                                                                           <L 171>
    // float(R[0, 0]) * v[0] + float(R[1, 0]) * v[1] + float(R[2, 0]) * v[2],                 <L 172>
    var_2 = wp::extract(var_R, var_0, var_1);
    var_3 = wp::float(var_2);
    var_5 = wp::extract(var_v, var_4);
    var_6 = wp::mul(var_3, var_5);
    var_9 = wp::extract(var_R, var_7, var_8);
    var_10 = wp::float(var_9);
    var_12 = wp::extract(var_v, var_11);
    var_13 = wp::mul(var_10, var_12);
    var_14 = wp::add(var_6, var_13);
    var_17 = wp::extract(var_R, var_15, var_16);
    var_18 = wp::float(var_17);
    var_20 = wp::extract(var_v, var_19);
    var_21 = wp::mul(var_18, var_20);
    var_22 = wp::add(var_14, var_21);
    // float(R[0, 1]) * v[0] + float(R[1, 1]) * v[1] + float(R[2, 1]) * v[2],                 <L 173>
    var_25 = wp::extract(var_R, var_23, var_24);
    var_26 = wp::float(var_25);
    var_28 = wp::extract(var_v, var_27);
    var_29 = wp::mul(var_26, var_28);
    var_32 = wp::extract(var_R, var_30, var_31);
    var_33 = wp::float(var_32);
    var_35 = wp::extract(var_v, var_34);
    var_36 = wp::mul(var_33, var_35);
    var_37 = wp::add(var_29, var_36);
    var_40 = wp::extract(var_R, var_38, var_39);
    var_41 = wp::float(var_40);
    var_43 = wp::extract(var_v, var_42);
    var_44 = wp::mul(var_41, var_43);
    var_45 = wp::add(var_37, var_44);
    // float(R[0, 2]) * v[0] + float(R[1, 2]) * v[1] + float(R[2, 2]) * v[2],                 <L 174>
    var_48 = wp::extract(var_R, var_46, var_47);
    var_49 = wp::float(var_48);
    var_51 = wp::extract(var_v, var_50);
    var_52 = wp::mul(var_49, var_51);
    var_55 = wp::extract(var_R, var_53, var_54);
    var_56 = wp::float(var_55);
    var_58 = wp::extract(var_v, var_57);
    var_59 = wp::mul(var_56, var_58);
    var_60 = wp::add(var_52, var_59);
    var_63 = wp::extract(var_R, var_61, var_62);
    var_64 = wp::float(var_63);
    var_66 = wp::extract(var_v, var_65);
    var_67 = wp::mul(var_64, var_66);
    var_68 = wp::add(var_60, var_67);
    var_69 = wp::vec_t<3, wp::float32>(var_22, var_45, var_68);
    return var_69;
}


// <pointloom.kernels.volumes.block_rows.offset_of>:1
static CUDA_CALLABLE wp::int32 offset_of_0(
    wp::int32 var_c)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    const wp::int32 var_2 = 0;
    bool var_3;
    const wp::int32 var_4 = -1;
    wp::int32 var_5;
    const wp::int32 var_6 = 8;
    bool var_7;
    const wp::int32 var_8 = 1;
    wp::int32 var_9;
    //---------
    // forward
    // def offset_of(c):                                                                      <L 1>
    // o = int(0)                                                                             <L 3>
    var_1 = wp::int(var_0);
    // if c < 0:                                                                              <L 4>
    var_3 = (var_c < var_2);
    if (var_3) {
        // o = -1                                                                             <L 5>
    }
    var_5 = wp::where(var_3, var_4, var_1);
    // if c >= SIDE:                                                                          <L 6>
    var_7 = (var_c >= var_6);
    if (var_7) {
        // o = 1                                                                              <L 7>
    }
    var_9 = wp::where(var_7, var_8, var_5);
    // return o                                                                               <L 8>
    return var_9;
}


// <pointloom.kernels.volumes.block_rows.row_near>:1
static CUDA_CALLABLE wp::int32 row_near_0(
    wp::int32 var_block,
    wp::int32 var_x,
    wp::int32 var_y,
    wp::int32 var_dz,
    wp::array_t<wp::int32> var_seen__neighbors)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32 var_1;
    const wp::int32 var_2 = 27;
    wp::int32 var_3;
    const wp::int32 var_4 = 13;
    wp::int32 var_5;
    const wp::int32 var_6 = 9;
    wp::int32 var_7;
    wp::int32 var_8;
    const wp::int32 var_9 = 3;
    wp::int32 var_10;
    wp::int32 var_11;
    wp::int32 var_12;
    wp::int32* var_13;
    wp::int32 var_14;
    wp::int32 var_15;
    const wp::int32 var_16 = -1;
    wp::int32 var_17;
    const wp::int32 var_18 = 0;
    bool var_19;
    const wp::int32 var_20 = 64;
    wp::int32 var_21;
    const wp::int32 var_22 = 8;
    wp::int32 var_23;
    wp::int32 var_24;
    wp::int32 var_25;
    wp::int32 var_26;
    wp::int32 var_27;
    wp::int32 var_28;
    wp::int32 var_29;
    wp::int32 var_30;
    //---------
    // forward
    // def row_near(block, x, y, dz, seen__neighbors):                                        <L 1>
    // dx = offset_of(x)                                                                      <L 3>
    var_0 = offset_of_0(var_x);
    // dy = offset_of(y)                                                                      <L 4>
    var_1 = offset_of_0(var_y);
    // other = seen__neighbors[block * AROUND + 13 + 9 * dx + 3 * dy + dz]                    <L 5>
    var_3 = wp::mul(var_block, var_2);
    var_5 = wp::add(var_3, var_4);
    var_7 = wp::mul(var_6, var_0);
    var_8 = wp::add(var_5, var_7);
    var_10 = wp::mul(var_9, var_1);
    var_11 = wp::add(var_8, var_10);
    var_12 = wp::add(var_11, var_dz);
    var_13 = wp::address(var_seen__neighbors, var_12);
    var_15 = wp::load(var_13);
    var_14 = wp::copy(var_15);
    // row = int(-1)                                                                          <L 6>
    var_17 = wp::int(var_16);
    // if other >= 0:                                                                         <L 7>
    var_19 = (var_14 >= var_18);
    if (var_19) {
        // row = other * ROWS + (x - dx * SIDE) * SIDE + (y - dy * SIDE)                      <L 8>
        var_21 = wp::mul(var_14, var_20);
        var_23 = wp::mul(var_0, var_22);
        var_24 = wp::sub(var_x, var_23);
        var_25 = wp::mul(var_24, var_22);
        var_26 = wp::add(var_21, var_25);
        var_27 = wp::mul(var_1, var_22);
        var_28 = wp::sub(var_y, var_27);
        var_29 = wp::add(var_26, var_28);
    }
    var_30 = wp::where(var_19, var_29, var_17);
    // return row                                                                             <L 9>
    return var_30;
}


// <pointloom.kernels.volumes.block_rows.voxel_near>:1
static CUDA_CALLABLE wp::int32 voxel_near_0(
    wp::int32 var_block,
    wp::int32 var_x,
    wp::int32 var_y,
    wp::int32 var_z,
    wp::array_t<wp::int32> var_seen__neighbors)
{
    //---------
    // primal vars
    wp::int32 var_0;
    wp::int32 var_1;
    const wp::int32 var_2 = -1;
    wp::int32 var_3;
    const wp::int32 var_4 = 0;
    bool var_5;
    const wp::int32 var_6 = 8;
    wp::int32 var_7;
    wp::int32 var_8;
    wp::int32 var_9;
    wp::int32 var_10;
    wp::int32 var_11;
    //---------
    // forward
    // def voxel_near(block, x, y, z, seen__neighbors):                                       <L 1>
    // dz = offset_of(z)                                                                      <L 3>
    var_0 = offset_of_0(var_z);
    // row = row_near(block, x, y, dz, seen__neighbors)                                       <L 4>
    var_1 = row_near_0(var_block, var_x, var_y, var_0, var_seen__neighbors);
    // voxel = int(-1)                                                                        <L 5>
    var_3 = wp::int(var_2);
    // if row >= 0:                                                                           <L 6>
    var_5 = (var_1 >= var_4);
    if (var_5) {
        // voxel = row * SIDE + z - dz * SIDE                                                 <L 7>
        var_7 = wp::mul(var_1, var_6);
        var_8 = wp::add(var_7, var_z);
        var_9 = wp::mul(var_0, var_6);
        var_10 = wp::sub(var_8, var_9);
    }
    var_11 = wp::where(var_5, var_10, var_3);
    // return voxel                                                                           <L 8>
    return var_11;
}


// <pointloom.kernels.volumes.voxel_samples.nearest_voxel>:1
static CUDA_CALLABLE wp::int32 nearest_voxel_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::int32 var_block,
    wp::vec_t<3, wp::int32> var_corner,
    wp::array_t<wp::int32> var_seen__neighbors)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 0.5;
    const wp::float32 var_1 = 0.5;
    const wp::float32 var_2 = 0.5;
    wp::vec_t<3, wp::float32> var_3;
    wp::vec_t<3, wp::float32> var_4;
    wp::vec_t<3, wp::int32> var_5;
    wp::vec_t<3, wp::int32> var_6;
    const wp::int32 var_7 = 0;
    wp::int32 var_8;
    const wp::int32 var_9 = 1;
    wp::int32 var_10;
    const wp::int32 var_11 = 2;
    wp::int32 var_12;
    wp::int32 var_13;
    //---------
    // forward
    // def nearest_voxel(p, block, corner, seen__neighbors):                                  <L 1>
    // cell = floor_cell(p + vec3(0.5, 0.5, 0.5)) - corner                                    <L 3>
    var_3 = wp::vec_t<3, wp::float32>(var_0, var_1, var_2);
    var_4 = wp::add(var_p, var_3);
    var_5 = floor_cell_0(var_4);
    var_6 = wp::sub(var_5, var_corner);
    // return voxel_near(block, cell[0], cell[1], cell[2], seen__neighbors)                   <L 4>
    var_8 = wp::extract(var_6, var_7);
    var_10 = wp::extract(var_6, var_9);
    var_12 = wp::extract(var_6, var_11);
    var_13 = voxel_near_0(var_block, var_8, var_10, var_12, var_seen__neighbors);
    return var_13;
}


// <pointloom.kernels.volumes.voxel_blocks.voxel_color>:1
static CUDA_CALLABLE wp::vec_t<3, wp::float32> voxel_color_0(
    wp::int32 var_voxel,
    wp::array_t<wp::uint16> var_blocks__colors)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::uint16* var_1;
    wp::float32 var_2;
    wp::uint16 var_3;
    const wp::int32 var_4 = 1;
    wp::uint16* var_5;
    wp::float32 var_6;
    wp::uint16 var_7;
    const wp::int32 var_8 = 2;
    wp::uint16* var_9;
    wp::float32 var_10;
    wp::uint16 var_11;
    wp::vec_t<3, wp::float32> var_12;
    //---------
    // forward
    // def voxel_color(voxel, blocks__colors):                                                <L 1>
    // return vec3(float(blocks__colors[voxel, 0]), float(blocks__colors[voxel, 1]), float(blocks__colors[voxel, 2]))       <L 2>
    var_1 = wp::address(var_blocks__colors, var_voxel, var_0);
    var_3 = wp::load(var_1);
    var_2 = wp::float(var_3);
    var_5 = wp::address(var_blocks__colors, var_voxel, var_4);
    var_7 = wp::load(var_5);
    var_6 = wp::float(var_7);
    var_9 = wp::address(var_blocks__colors, var_voxel, var_8);
    var_11 = wp::load(var_9);
    var_10 = wp::float(var_11);
    var_12 = wp::vec_t<3, wp::float32>(var_2, var_6, var_10);
    return var_12;
}


// <pointloom.kernels.volumes.ray_images.brightness_of>:1
static CUDA_CALLABLE wp::float32 brightness_of_0(
    wp::vec_t<8, wp::int32> var_voxels,
    wp::vec_t<3, wp::float32> var_f,
    wp::array_t<wp::uint16> var_seen__blocks__weights,
    wp::array_t<wp::uint16> var_seen__blocks__colors,
    wp::float32 var_seen__threshold,
    wp::vec_t<3, wp::float32> var_shares)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 0.0;
    wp::float32 var_1;
    const wp::float32 var_2 = 0.0;
    wp::float32 var_3;
    const wp::int32 var_4 = 8;
    wp::int32 var_5;
    wp::range_t var_6;
    wp::int32 var_7;
    wp::int32 var_8;
    const wp::int32 var_9 = 0;
    bool var_10;
    wp::uint16* var_11;
    wp::float32 var_12;
    wp::uint16 var_13;
    bool var_14;
    const wp::int32 var_15 = 1;
    const wp::int32 var_16 = 2;
    wp::int32 var_17;
    wp::int32 var_18;
    wp::float32 var_19;
    const wp::int32 var_20 = 0;
    wp::float32 var_21;
    wp::float32 var_22;
    wp::float32 var_23;
    const wp::int32 var_24 = 1;
    const wp::int32 var_25 = 1;
    wp::int32 var_26;
    const wp::int32 var_27 = 1;
    wp::int32 var_28;
    wp::int32 var_29;
    wp::float32 var_30;
    const wp::int32 var_31 = 1;
    wp::float32 var_32;
    wp::float32 var_33;
    wp::float32 var_34;
    wp::float32 var_35;
    const wp::int32 var_36 = 1;
    const wp::int32 var_37 = 1;
    wp::int32 var_38;
    wp::int32 var_39;
    wp::float32 var_40;
    const wp::int32 var_41 = 2;
    wp::float32 var_42;
    wp::float32 var_43;
    wp::float32 var_44;
    wp::float32 var_45;
    wp::vec_t<3, wp::float32> var_46;
    const wp::int32 var_47 = 0;
    wp::float32 var_48;
    const wp::int32 var_49 = 0;
    wp::float32 var_50;
    wp::float32 var_51;
    const wp::int32 var_52 = 1;
    wp::float32 var_53;
    const wp::int32 var_54 = 1;
    wp::float32 var_55;
    wp::float32 var_56;
    wp::float32 var_57;
    const wp::int32 var_58 = 2;
    wp::float32 var_59;
    const wp::int32 var_60 = 2;
    wp::float32 var_61;
    wp::float32 var_62;
    wp::float32 var_63;
    wp::float32 var_64;
    wp::float32 var_65;
    wp::float32 var_66;
    wp::float32 var_67;
    wp::float32 var_68;
    wp::float32 var_69;
    wp::float32 var_70;
    const wp::float32 var_71 = 0.0;
    wp::float32 var_72;
    const wp::float32 var_73 = 0.0;
    bool var_74;
    const wp::float32 var_75 = 255.0;
    const wp::float32 var_76 = 257.0;
    wp::float32 var_77;
    wp::float32 var_78;
    wp::float32 var_79;
    wp::float32 var_80;
    //---------
    // forward
    // def brightness_of(voxels, f, seen__blocks__weights, seen__blocks__colors, seen__threshold, shares):       <L 1>
    // total = float(0.0)                                                                     <L 2>
    var_1 = wp::float(var_0);
    // weight = float(0.0)                                                                    <L 3>
    var_3 = wp::float(var_2);
    // n = int(8)                                                                             <L 4>
    var_5 = wp::int(var_4);
    // for c in range(n):                                                                     <L 5>
    var_6 = wp::range(var_5);
    start_for_0:;
        if (iter_cmp(var_6) == 0) goto end_for_0;
        var_7 = wp::iter_next(var_6);
        // voxel = voxels[c]                                                                  <L 6>
        var_8 = wp::extract(var_voxels, var_7);
        // if voxel >= 0:                                                                     <L 7>
        var_10 = (var_8 >= var_9);
        if (var_10) {
            // if float(seen__blocks__weights[voxel]) > seen__threshold:                      <L 8>
            var_11 = wp::address(var_seen__blocks__weights, var_8);
            var_13 = wp::load(var_11);
            var_12 = wp::float(var_13);
            var_14 = (var_12 > var_seen__threshold);
            if (var_14) {
                // fx = abs(float(1 - (c >> 2)) - f[0])                                       <L 9>
                var_17 = wp::rshift(var_7, var_16);
                var_18 = wp::sub(var_15, var_17);
                var_19 = wp::float(var_18);
                var_21 = wp::extract(var_f, var_20);
                var_22 = wp::sub(var_19, var_21);
                var_23 = wp::abs(var_22);
                // fy = abs(float(1 - (c >> 1 & 1)) - f[1])                                   <L 10>
                var_26 = wp::rshift(var_7, var_25);
                var_28 = wp::bit_and(var_26, var_27);
                var_29 = wp::sub(var_24, var_28);
                var_30 = wp::float(var_29);
                var_32 = wp::extract(var_f, var_31);
                var_33 = wp::sub(var_30, var_32);
                var_34 = wp::abs(var_33);
                // share = fx * fy * abs(float(1 - (c & 1)) - f[2])                           <L 11>
                var_35 = wp::mul(var_23, var_34);
                var_38 = wp::bit_and(var_7, var_37);
                var_39 = wp::sub(var_36, var_38);
                var_40 = wp::float(var_39);
                var_42 = wp::extract(var_f, var_41);
                var_43 = wp::sub(var_40, var_42);
                var_44 = wp::abs(var_43);
                var_45 = wp::mul(var_35, var_44);
                // shade = voxel_color(voxel, seen__blocks__colors)                           <L 12>
                var_46 = voxel_color_0(var_8, var_seen__blocks__colors);
                // total += share * (shares[0] * shade[0] + shares[1] * shade[1] + shares[2] * shade[2])       <L 13>
                var_48 = wp::extract(var_shares, var_47);
                var_50 = wp::extract(var_46, var_49);
                var_51 = wp::mul(var_48, var_50);
                var_53 = wp::extract(var_shares, var_52);
                var_55 = wp::extract(var_46, var_54);
                var_56 = wp::mul(var_53, var_55);
                var_57 = wp::add(var_51, var_56);
                var_59 = wp::extract(var_shares, var_58);
                var_61 = wp::extract(var_46, var_60);
                var_62 = wp::mul(var_59, var_61);
                var_63 = wp::add(var_57, var_62);
                var_64 = wp::mul(var_45, var_63);
                var_65 = wp::add(var_1, var_64);
                // weight += share                                                            <L 14>
                var_66 = wp::add(var_3, var_45);
            }
            var_67 = wp::where(var_14, var_65, var_1);
            var_68 = wp::where(var_14, var_66, var_3);
        }
        var_69 = wp::where(var_10, var_67, var_1);
        var_70 = wp::where(var_10, var_68, var_3);
        wp::assign(var_1, var_69);
        wp::assign(var_3, var_70);
        goto start_for_0;
    end_for_0:;
    // bright = float(0.0)                                                                    <L 15>
    var_72 = wp::float(var_71);
    // if weight > 0.0:                                                                       <L 16>
    var_74 = (var_3 > var_73);
    if (var_74) {
        // bright = total / (weight * (255.0 * COLOR_SCALE))                                  <L 17>
        var_77 = wp::mul(var_75, var_76);
        var_78 = wp::mul(var_3, var_77);
        var_79 = wp::div(var_1, var_78);
    }
    var_80 = wp::where(var_74, var_79, var_72);
    // return bright                                                                          <L 18>
    return var_80;
}


// /work/main/src/pointloom/kernels/algebra/transform.py:32
static CUDA_CALLABLE void adj_narrow_0(
    wp::vec_t<3, wp::float64> var_p,
    wp::vec_t<3, wp::float64> & adj_p,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.camera_rays.ray_of>:1
static CUDA_CALLABLE void adj_ray_of_0(
    wp::int32 var_column,
    wp::int32 var_row,
    wp::mat_t<3, 3, wp::float64> var_rays__sight,
    wp::int32 & adj_column,
    wp::int32 & adj_row,
    wp::mat_t<3, 3, wp::float64> & adj_rays__sight,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/arrays/block_keys.py:16
static CUDA_CALLABLE void adj_key_block_0(
    wp::int64 var_key,
    wp::int64 & adj_key,
    wp::vec_t<3, wp::int32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/volumes/voxel_samples.py:22
static CUDA_CALLABLE void adj_to_float_0(
    wp::vec_t<3, wp::int32> var_v,
    wp::vec_t<3, wp::int32> & adj_v,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/volumes/voxel_samples.py:17
static CUDA_CALLABLE void adj_floor_cell_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::int32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.voxel_samples.voxel_around>:1
static CUDA_CALLABLE void adj_voxel_around_0(
    wp::int32 var_block,
    wp::int32 var_x,
    wp::int32 var_y,
    wp::int32 var_z,
    wp::array_t<wp::int32> var_seen__neighbors,
    wp::int32 & adj_block,
    wp::int32 & adj_x,
    wp::int32 & adj_y,
    wp::int32 & adj_z,
    wp::array_t<wp::int32> & adj_seen__neighbors,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.voxel_samples.cell_voxels>:1
static CUDA_CALLABLE void adj_cell_voxels_0(
    wp::int32 var_block,
    wp::int32 var_x,
    wp::int32 var_y,
    wp::int32 var_z,
    wp::array_t<wp::int32> var_seen__neighbors,
    wp::int32 & adj_block,
    wp::int32 & adj_x,
    wp::int32 & adj_y,
    wp::int32 & adj_z,
    wp::array_t<wp::int32> & adj_seen__neighbors,
    wp::vec_t<8, wp::int32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.voxel_samples.seen_distance>:1
static CUDA_CALLABLE void adj_seen_distance_0(
    wp::int32 var_voxel,
    wp::array_t<wp::float32> var_seen__blocks__distances,
    wp::array_t<wp::uint16> var_seen__blocks__weights,
    wp::float32 var_seen__threshold,
    wp::int32 & adj_voxel,
    wp::array_t<wp::float32> & adj_seen__blocks__distances,
    wp::array_t<wp::uint16> & adj_seen__blocks__weights,
    wp::float32 & adj_seen__threshold,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.voxel_samples.corner_distances>:1
static CUDA_CALLABLE void adj_corner_distances_0(
    wp::vec_t<8, wp::int32> var_voxels,
    wp::array_t<wp::float32> var_seen__blocks__distances,
    wp::array_t<wp::uint16> var_seen__blocks__weights,
    wp::float32 var_seen__threshold,
    wp::vec_t<8, wp::int32> & adj_voxels,
    wp::array_t<wp::float32> & adj_seen__blocks__distances,
    wp::array_t<wp::uint16> & adj_seen__blocks__weights,
    wp::float32 & adj_seen__threshold,
    wp::vec_t<8, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/volumes/voxel_samples.py:82
static CUDA_CALLABLE void adj_greatest_0(
    wp::vec_t<8, wp::float32> var_corners,
    wp::vec_t<8, wp::float32> & adj_corners,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/volumes/voxel_samples.py:88
static CUDA_CALLABLE void adj_between_0(
    wp::float32 var_a,
    wp::float32 var_b,
    wp::float32 var_share,
    wp::float32 & adj_a,
    wp::float32 & adj_b,
    wp::float32 & adj_share,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.ray_images.side_distance>:1
static CUDA_CALLABLE void adj_side_distance_0(
    wp::int32 var_block,
    wp::int32 var_x,
    wp::int32 var_y,
    wp::int32 var_z,
    wp::array_t<wp::float32> var_seen__blocks__distances,
    wp::array_t<wp::uint16> var_seen__blocks__weights,
    wp::array_t<wp::int32> var_seen__neighbors,
    wp::float32 var_seen__threshold,
    wp::int32 & adj_block,
    wp::int32 & adj_x,
    wp::int32 & adj_y,
    wp::int32 & adj_z,
    wp::array_t<wp::float32> & adj_seen__blocks__distances,
    wp::array_t<wp::uint16> & adj_seen__blocks__weights,
    wp::array_t<wp::int32> & adj_seen__neighbors,
    wp::float32 & adj_seen__threshold,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/volumes/ray_images.py:101
static CUDA_CALLABLE void adj_mean_of_four_0(
    wp::float32 var_a,
    wp::float32 var_b,
    wp::float32 var_c,
    wp::float32 var_d,
    wp::float32 var_fu,
    wp::float32 var_fv,
    wp::float32 & adj_a,
    wp::float32 & adj_b,
    wp::float32 & adj_c,
    wp::float32 & adj_d,
    wp::float32 & adj_fu,
    wp::float32 & adj_fv,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/volumes/ray_images.py:83
static CUDA_CALLABLE void adj_slope_along_0(
    wp::float32 var_low,
    wp::float32 var_high,
    wp::float32 var_beyond,
    wp::float32 var_middle,
    wp::float32 var_share,
    wp::int32 var_is_up,
    wp::float32 & adj_low,
    wp::float32 & adj_high,
    wp::float32 & adj_beyond,
    wp::float32 & adj_middle,
    wp::float32 & adj_share,
    wp::int32 & adj_is_up,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.ray_images.slopes_at>:1
static CUDA_CALLABLE void adj_slopes_at_0(
    wp::int32 var_block,
    wp::int32 var_x,
    wp::int32 var_y,
    wp::int32 var_z,
    wp::vec_t<3, wp::float32> var_f,
    wp::vec_t<8, wp::float32> var_c,
    wp::array_t<wp::float32> var_seen__blocks__distances,
    wp::array_t<wp::uint16> var_seen__blocks__weights,
    wp::array_t<wp::int32> var_seen__neighbors,
    wp::float32 var_seen__threshold,
    wp::int32 & adj_block,
    wp::int32 & adj_x,
    wp::int32 & adj_y,
    wp::int32 & adj_z,
    wp::vec_t<3, wp::float32> & adj_f,
    wp::vec_t<8, wp::float32> & adj_c,
    wp::array_t<wp::float32> & adj_seen__blocks__distances,
    wp::array_t<wp::uint16> & adj_seen__blocks__weights,
    wp::array_t<wp::int32> & adj_seen__neighbors,
    wp::float32 & adj_seen__threshold,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/volumes/ray_images.py:169
static CUDA_CALLABLE void adj_rotated_back_0(
    wp::vec_t<3, wp::float32> var_v,
    wp::mat_t<3, 3, wp::float64> var_R,
    wp::vec_t<3, wp::float32> & adj_v,
    wp::mat_t<3, 3, wp::float64> & adj_R,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.block_rows.offset_of>:1
static CUDA_CALLABLE void adj_offset_of_0(
    wp::int32 var_c,
    wp::int32 & adj_c,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.block_rows.row_near>:1
static CUDA_CALLABLE void adj_row_near_0(
    wp::int32 var_block,
    wp::int32 var_x,
    wp::int32 var_y,
    wp::int32 var_dz,
    wp::array_t<wp::int32> var_seen__neighbors,
    wp::int32 & adj_block,
    wp::int32 & adj_x,
    wp::int32 & adj_y,
    wp::int32 & adj_dz,
    wp::array_t<wp::int32> & adj_seen__neighbors,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.block_rows.voxel_near>:1
static CUDA_CALLABLE void adj_voxel_near_0(
    wp::int32 var_block,
    wp::int32 var_x,
    wp::int32 var_y,
    wp::int32 var_z,
    wp::array_t<wp::int32> var_seen__neighbors,
    wp::int32 & adj_block,
    wp::int32 & adj_x,
    wp::int32 & adj_y,
    wp::int32 & adj_z,
    wp::array_t<wp::int32> & adj_seen__neighbors,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.voxel_samples.nearest_voxel>:1
static CUDA_CALLABLE void adj_nearest_voxel_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::int32 var_block,
    wp::vec_t<3, wp::int32> var_corner,
    wp::array_t<wp::int32> var_seen__neighbors,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::int32 & adj_block,
    wp::vec_t<3, wp::int32> & adj_corner,
    wp::array_t<wp::int32> & adj_seen__neighbors,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.voxel_blocks.voxel_color>:1
static CUDA_CALLABLE void adj_voxel_color_0(
    wp::int32 var_voxel,
    wp::array_t<wp::uint16> var_blocks__colors,
    wp::int32 & adj_voxel,
    wp::array_t<wp::uint16> & adj_blocks__colors,
    wp::vec_t<3, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.ray_images.brightness_of>:1
static CUDA_CALLABLE void adj_brightness_of_0(
    wp::vec_t<8, wp::int32> var_voxels,
    wp::vec_t<3, wp::float32> var_f,
    wp::array_t<wp::uint16> var_seen__blocks__weights,
    wp::array_t<wp::uint16> var_seen__blocks__colors,
    wp::float32 var_seen__threshold,
    wp::vec_t<3, wp::float32> var_shares,
    wp::vec_t<8, wp::int32> & adj_voxels,
    wp::vec_t<3, wp::float32> & adj_f,
    wp::array_t<wp::uint16> & adj_seen__blocks__weights,
    wp::array_t<wp::uint16> & adj_seen__blocks__colors,
    wp::float32 & adj_seen__threshold,
    wp::vec_t<3, wp::float32> & adj_shares,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void WP_MAXNREG(128) shade_hits_kernel_57b0ac3f_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::int32 var_rays__camera__width,
    wp::mat_t<3, 3, wp::float64> var_rays__R,
    wp::mat_t<3, 3, wp::float64> var_rays__sight,
    wp::vec_t<3, wp::int32> var_rays__base,
    wp::vec_t<3, wp::float32> var_rays__start,
    wp::float64 var_seen__blocks__voxel_size,
    wp::array_t<wp::int64> var_seen__blocks__keys,
    wp::array_t<wp::float32> var_seen__blocks__distances,
    wp::array_t<wp::uint16> var_seen__blocks__weights,
    wp::array_t<wp::uint16> var_seen__blocks__colors,
    wp::array_t<wp::int32> var_seen__neighbors,
    wp::float32 var_seen__threshold,
    wp::array_t<wp::float32> var_images__depth,
    wp::array_t<wp::int32> var_images__met,
    wp::array_t<wp::vec_t<3, wp::float32>> var_images__points,
    wp::array_t<wp::vec_t<3, wp::float32>> var_images__normals,
    wp::array_t<wp::vec_t<3, wp::float32>> var_images__colors,
    wp::array_t<wp::float32> var_images__intensities,
    wp::vec_t<3, wp::float32> var_images__shares,
    wp::int32 var_images__has_points,
    wp::int32 var_images__has_normals,
    wp::int32 var_images__has_colors,
    wp::int32 var_images__has_intensities,
    wp::int32 var_images__in_camera)
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
        bool var_2;
        const wp::float32 var_3 = NAN;
        wp::vec_t<3, wp::float32> var_4;
        const wp::int32 var_5 = 1;
        bool var_6;
        const wp::float32 var_7 = 0.0;
        const wp::float32 var_8 = 0.0;
        const wp::float32 var_9 = 0.0;
        wp::vec_t<3, wp::float32> var_10;
        const wp::int32 var_11 = 1;
        bool var_12;
        const wp::float32 var_13 = 0.0;
        wp::vec_t<3, wp::float32> var_14;
        wp::float32* var_15;
        wp::float32 var_16;
        wp::float32 var_17;
        const wp::float32 var_18 = 0.0;
        bool var_19;
        wp::int32 var_20;
        wp::int32 var_21;
        wp::vec_t<3, wp::float32> var_22;
        wp::vec_t<3, wp::float32> var_23;
        wp::vec_t<3, wp::float32> var_24;
        wp::int32* var_25;
        wp::int32 var_26;
        wp::int32 var_27;
        wp::int64* var_28;
        wp::vec_t<3, wp::int32> var_29;
        wp::int64 var_30;
        const wp::int32 var_31 = 8;
        wp::vec_t<3, wp::int32> var_32;
        wp::vec_t<3, wp::int32> var_33;
        const wp::int32 var_34 = 1;
        bool var_35;
        wp::vec_t<3, wp::float32> var_36;
        wp::vec_t<3, wp::float32> var_37;
        wp::float32 var_38;
        wp::vec_t<3, wp::float32> var_39;
        wp::vec_t<3, wp::int32> var_40;
        wp::vec_t<3, wp::float32> var_41;
        wp::vec_t<3, wp::float32> var_42;
        const wp::int32 var_43 = 0;
        wp::int32 var_44;
        const wp::int32 var_45 = 0;
        wp::int32 var_46;
        wp::int32 var_47;
        const wp::int32 var_48 = 1;
        wp::int32 var_49;
        const wp::int32 var_50 = 1;
        wp::int32 var_51;
        wp::int32 var_52;
        const wp::int32 var_53 = 2;
        wp::int32 var_54;
        const wp::int32 var_55 = 2;
        wp::int32 var_56;
        wp::int32 var_57;
        wp::vec_t<8, wp::int32> var_58;
        const wp::float32 var_59 = 2.0;
        wp::vec_t<8, wp::float32> var_60;
        const wp::int32 var_61 = 1;
        bool var_62;
        wp::vec_t<8, wp::float32> var_63;
        wp::vec_t<8, wp::float32> var_64;
        wp::float32 var_65;
        bool var_66;
        wp::vec_t<3, wp::float32> var_67;
        const wp::int32 var_68 = 0;
        wp::float32 var_69;
        const wp::int32 var_70 = 0;
        wp::float32 var_71;
        wp::float32 var_72;
        const wp::int32 var_73 = 1;
        wp::float32 var_74;
        const wp::int32 var_75 = 1;
        wp::float32 var_76;
        wp::float32 var_77;
        wp::float32 var_78;
        const wp::int32 var_79 = 2;
        wp::float32 var_80;
        const wp::int32 var_81 = 2;
        wp::float32 var_82;
        wp::float32 var_83;
        wp::float32 var_84;
        wp::float32 var_85;
        const wp::float32 var_86 = 0.0;
        bool var_87;
        wp::vec_t<3, wp::float32> var_88;
        const wp::int32 var_89 = 1;
        bool var_90;
        wp::vec_t<3, wp::float32> var_91;
        wp::vec_t<3, wp::float32> var_92;
        wp::vec_t<3, wp::float32> var_93;
        wp::vec_t<3, wp::float32> var_94;
        const wp::int32 var_95 = 1;
        bool var_96;
        wp::int32 var_97;
        const wp::int32 var_98 = 0;
        bool var_99;
        wp::vec_t<3, wp::float32> var_100;
        const wp::float32 var_101 = 255.0;
        const wp::float32 var_102 = 257.0;
        wp::float32 var_103;
        wp::vec_t<3, wp::float32> var_104;
        const wp::int32 var_105 = 1;
        bool var_106;
        wp::float32 var_107;
        wp::vec_t<3, wp::float32> var_108;
        const wp::int32 var_109 = 1;
        bool var_110;
        //---------
        // forward
        // def shade_hits_kernel(rays__camera__width, rays__R, rays__sight, rays__base, rays__start, seen__blocks__voxel_size, seen__blocks__keys, seen__blocks__distances, seen__blocks__weights, seen__blocks__colors, seen__neighbors, seen__threshold, images__depth, images__met, images__points, images__normals, images__colors, images__intensities, images__shares, images__has_points, images__has_normals, images__has_colors, images__has_intensities, images__in_camera):       <L 1>
        // i = tid()                                                                              <L 2>
        var_0 = builtin_tid1d();
        // if images__has_points == 1:                                                            <L 3>
        var_2 = (var_images__has_points == var_1);
        if (var_2) {
            // images__points[i] = vec3(NAN, NAN, NAN)                                            <L 4>
            var_4 = wp::vec_t<3, wp::float32>(var_3, var_3, var_3);
            wp::array_store(var_images__points, var_0, var_4);
        }
        // if images__has_colors == 1:                                                            <L 5>
        var_6 = (var_images__has_colors == var_5);
        if (var_6) {
            // images__colors[i] = vec3(0.0, 0.0, 0.0)                                            <L 6>
            var_10 = wp::vec_t<3, wp::float32>(var_7, var_8, var_9);
            wp::array_store(var_images__colors, var_0, var_10);
        }
        // if images__has_intensities == 1:                                                       <L 7>
        var_12 = (var_images__has_intensities == var_11);
        if (var_12) {
            // images__intensities[i] = 0.0                                                       <L 8>
            wp::array_store(var_images__intensities, var_0, var_13);
        }
        // normal = vec3(NAN, NAN, NAN)                                                           <L 9>
        var_14 = wp::vec_t<3, wp::float32>(var_3, var_3, var_3);
        // hit = images__depth[i]                                                                 <L 10>
        var_15 = wp::address(var_images__depth, var_0);
        var_17 = wp::load(var_15);
        var_16 = wp::copy(var_17);
        // if hit > 0.0:                                                                          <L 11>
        var_19 = (var_16 > var_18);
        if (var_19) {
            // p = rays__start + ray_of(i % rays__camera__width, i // rays__camera__width, rays__sight) * hit       <L 12>
            var_20 = wp::mod(var_0, var_rays__camera__width);
            var_21 = wp::floordiv(var_0, var_rays__camera__width);
            var_22 = ray_of_0(var_20, var_21, var_rays__sight);
            var_23 = wp::mul(var_22, var_16);
            var_24 = wp::add(var_rays__start, var_23);
            // block = images__met[i]                                                             <L 13>
            var_25 = wp::address(var_images__met, var_0);
            var_27 = wp::load(var_25);
            var_26 = wp::copy(var_27);
            // corner = key_block(seen__blocks__keys[block]) * SIDE - rays__base                  <L 14>
            var_28 = wp::address(var_seen__blocks__keys, var_26);
            var_30 = wp::load(var_28);
            var_29 = key_block_0(var_30);
            var_32 = wp::mul(var_29, var_31);
            var_33 = wp::sub(var_32, var_rays__base);
            // if images__has_points == 1:                                                        <L 15>
            var_35 = (var_images__has_points == var_34);
            if (var_35) {
                // images__points[i] = (p + to_float(rays__base)) * float(seen__blocks__voxel_size)       <L 16>
                var_36 = to_float_0(var_rays__base);
                var_37 = wp::add(var_24, var_36);
                var_38 = wp::float(var_seen__blocks__voxel_size);
                var_39 = wp::mul(var_37, var_38);
                wp::array_store(var_images__points, var_0, var_39);
            }
            // cell = floor_cell(p)                                                               <L 17>
            var_40 = floor_cell_0(var_24);
            // f = p - to_float(cell)                                                             <L 18>
            var_41 = to_float_0(var_40);
            var_42 = wp::sub(var_24, var_41);
            // x = cell[0] - corner[0]                                                            <L 19>
            var_44 = wp::extract(var_40, var_43);
            var_46 = wp::extract(var_33, var_45);
            var_47 = wp::sub(var_44, var_46);
            // y = cell[1] - corner[1]                                                            <L 20>
            var_49 = wp::extract(var_40, var_48);
            var_51 = wp::extract(var_33, var_50);
            var_52 = wp::sub(var_49, var_51);
            // z = cell[2] - corner[2]                                                            <L 21>
            var_54 = wp::extract(var_40, var_53);
            var_56 = wp::extract(var_33, var_55);
            var_57 = wp::sub(var_54, var_56);
            // voxels = cell_voxels(block, x, y, z, seen__neighbors)                              <L 22>
            var_58 = cell_voxels_0(var_26, var_47, var_52, var_57, var_seen__neighbors);
            // corners = octet(UNSEEN)                                                            <L 23>
            var_60 = wp::vec_t<8, wp::float32>(var_59);
            // if images__has_normals == 1:                                                       <L 24>
            var_62 = (var_images__has_normals == var_61);
            if (var_62) {
                // corners = corner_distances(voxels, seen__blocks__distances, seen__blocks__weights, seen__threshold)       <L 25>
                var_63 = corner_distances_0(var_58, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__threshold);
            }
            var_64 = wp::where(var_62, var_63, var_60);
            // if greatest(corners) < UNSEEN:                                                     <L 26>
            var_65 = greatest_0(var_64);
            var_66 = (var_65 < var_59);
            if (var_66) {
                // g = slopes_at(block, x, y, z, f, corners, seen__blocks__distances, seen__blocks__weights, seen__neighbors, seen__threshold)       <L 27>
                var_67 = slopes_at_0(var_26, var_47, var_52, var_57, var_42, var_64, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__neighbors, var_seen__threshold);
                // size = sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2])                           <L 28>
                var_69 = wp::extract(var_67, var_68);
                var_71 = wp::extract(var_67, var_70);
                var_72 = wp::mul(var_69, var_71);
                var_74 = wp::extract(var_67, var_73);
                var_76 = wp::extract(var_67, var_75);
                var_77 = wp::mul(var_74, var_76);
                var_78 = wp::add(var_72, var_77);
                var_80 = wp::extract(var_67, var_79);
                var_82 = wp::extract(var_67, var_81);
                var_83 = wp::mul(var_80, var_82);
                var_84 = wp::add(var_78, var_83);
                var_85 = wp::sqrt(var_84);
                // if size > 0.0:                                                                 <L 29>
                var_87 = (var_85 > var_86);
                if (var_87) {
                    // normal = g / size                                                          <L 30>
                    var_88 = wp::div(var_67, var_85);
                    // if images__in_camera == 1:                                                 <L 31>
                    var_90 = (var_images__in_camera == var_89);
                    if (var_90) {
                        // normal = rotated_back(normal, rays__R)                                 <L 32>
                        var_91 = rotated_back_0(var_88, var_rays__R);
                    }
                    var_92 = wp::where(var_90, var_91, var_88);
                }
                var_93 = wp::where(var_87, var_92, var_14);
            }
            var_94 = wp::where(var_66, var_93, var_14);
            // if images__has_colors == 1:                                                        <L 33>
            var_96 = (var_images__has_colors == var_95);
            if (var_96) {
                // voxel = nearest_voxel(p, block, corner, seen__neighbors)                       <L 34>
                var_97 = nearest_voxel_0(var_24, var_26, var_33, var_seen__neighbors);
                // if voxel >= 0:                                                                 <L 35>
                var_99 = (var_97 >= var_98);
                if (var_99) {
                    // images__colors[i] = voxel_color(voxel, seen__blocks__colors) / (255.0 * COLOR_SCALE)       <L 36>
                    var_100 = voxel_color_0(var_97, var_seen__blocks__colors);
                    var_103 = wp::mul(var_101, var_102);
                    var_104 = wp::div(var_100, var_103);
                    wp::array_store(var_images__colors, var_0, var_104);
                }
            }
            // if images__has_intensities == 1:                                                   <L 37>
            var_106 = (var_images__has_intensities == var_105);
            if (var_106) {
                // images__intensities[i] = brightness_of(voxels, f, seen__blocks__weights, seen__blocks__colors, seen__threshold, images__shares)       <L 38>
                var_107 = brightness_of_0(var_58, var_42, var_seen__blocks__weights, var_seen__blocks__colors, var_seen__threshold, var_images__shares);
                wp::array_store(var_images__intensities, var_0, var_107);
            }
        }
        var_108 = wp::where(var_19, var_94, var_14);
        // if images__has_normals == 1:                                                           <L 39>
        var_110 = (var_images__has_normals == var_109);
        if (var_110) {
            // images__normals[i] = normal                                                        <L 40>
            wp::array_store(var_images__normals, var_0, var_108);
        }
}


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


// /work/main/src/pointloom/kernels/volumes/tsdf_raycast.py:42
static CUDA_CALLABLE wp::float32 inverse_of_0(
    wp::float32 var_direction)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 1e+30;
    wp::float32 var_1;
    wp::float32 var_2;
    const wp::float32 var_3 = 1e-12;
    bool var_4;
    const wp::float32 var_5 = 1.0;
    wp::float32 var_6;
    wp::float32 var_7;
    //---------
    // forward
    // def inverse_of(direction: float) -> float:                                             <L 43>
    // inverse = float(ACROSS)                                                                <L 45>
    var_1 = wp::float(var_0);
    // if abs(direction) > FLAT:                                                              <L 46>
    var_2 = wp::abs(var_direction);
    var_4 = (var_2 > var_3);
    if (var_4) {
        // inverse = 1.0 / direction                                                          <L 47>
        var_6 = wp::div(var_5, var_direction);
    }
    var_7 = wp::where(var_4, var_6, var_1);
    // return inverse                                                                         <L 48>
    return var_7;
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


// <pointloom.kernels.volumes.tsdf_raycast.block_at>:1
static CUDA_CALLABLE wp::int32 block_at_0(
    wp::vec_t<3, wp::int32> var_cell,
    wp::vec_t<3, wp::int32> var_base,
    wp::array_t<wp::int64> var_seen__blocks__table__keys,
    wp::array_t<wp::int32> var_seen__blocks__table__positions,
    wp::int64 var_seen__blocks__table__mask)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    const wp::int32 var_2 = 0;
    wp::int32 var_3;
    wp::int32 var_4;
    const wp::int32 var_5 = 3;
    wp::int32 var_6;
    const wp::int32 var_7 = 1;
    wp::int32 var_8;
    const wp::int32 var_9 = 1;
    wp::int32 var_10;
    wp::int32 var_11;
    const wp::int32 var_12 = 3;
    wp::int32 var_13;
    const wp::int32 var_14 = 2;
    wp::int32 var_15;
    const wp::int32 var_16 = 2;
    wp::int32 var_17;
    wp::int32 var_18;
    const wp::int32 var_19 = 3;
    wp::int32 var_20;
    wp::int64 var_21;
    wp::int32 var_22;
    //---------
    // forward
    // def block_at(cell, base, seen__blocks__table__keys, seen__blocks__table__positions, seen__blocks__table__mask):       <L 1>
    // return find_position(block_key(cell[0] + base[0] >> 3, cell[1] + base[1] >> 3, cell[2] + base[2] >> 3), seen__blocks__table__keys, seen__blocks__table__positions, seen__blocks__table__mask)       <L 3>
    var_1 = wp::extract(var_cell, var_0);
    var_3 = wp::extract(var_base, var_2);
    var_4 = wp::add(var_1, var_3);
    var_6 = wp::rshift(var_4, var_5);
    var_8 = wp::extract(var_cell, var_7);
    var_10 = wp::extract(var_base, var_9);
    var_11 = wp::add(var_8, var_10);
    var_13 = wp::rshift(var_11, var_12);
    var_15 = wp::extract(var_cell, var_14);
    var_17 = wp::extract(var_base, var_16);
    var_18 = wp::add(var_15, var_17);
    var_20 = wp::rshift(var_18, var_19);
    var_21 = block_key_0(var_6, var_13, var_20);
    var_22 = find_position_0(var_21, var_seen__blocks__table__keys, var_seen__blocks__table__positions, var_seen__blocks__table__mask);
    return var_22;
}


// /work/main/src/pointloom/kernels/algebra/plain_min_max.py:6
static CUDA_CALLABLE wp::float32 smaller_0(
    wp::float32 var_a,
    wp::float32 var_b)
{
    //---------
    // primal vars
    bool var_0;
    wp::float32 var_1;
    //---------
    // forward
    // def smaller(a: float, b: float) -> float:                                              <L 7>
    // return a if a < b else b                                                               <L 8>
    var_0 = (var_a < var_b);
    if (var_0) {
    }
    if (!var_0) {
    }
    var_1 = wp::where(var_0, var_a, var_b);
    return var_1;
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


// <pointloom.kernels.volumes.voxel_samples.cell_distances>:1
static CUDA_CALLABLE wp::vec_t<8, wp::float32> cell_distances_0(
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
    wp::vec_t<8, wp::int32> var_0;
    wp::vec_t<8, wp::float32> var_1;
    //---------
    // forward
    // def cell_distances(block, x, y, z, seen__blocks__distances, seen__blocks__weights, seen__neighbors, seen__threshold):       <L 1>
    // return corner_distances(cell_voxels(block, x, y, z, seen__neighbors), seen__blocks__distances, seen__blocks__weights, seen__threshold)       <L 3>
    var_0 = cell_voxels_0(var_block, var_x, var_y, var_z, var_seen__neighbors);
    var_1 = corner_distances_0(var_0, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__threshold);
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


// /work/main/src/pointloom/kernels/volumes/voxel_samples.py:93
static CUDA_CALLABLE wp::float32 interpolate_0(
    wp::vec_t<8, wp::float32> var_corners,
    wp::float32 var_fx,
    wp::float32 var_fy,
    wp::float32 var_fz)
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
    // def interpolate(corners: octet, fx: float, fy: float, fz: float) -> float:             <L 94>
    // low = between(between(corners[0], corners[1], fz), between(corners[2], corners[3], fz), fy)       <L 95>
    var_1 = wp::extract(var_corners, var_0);
    var_3 = wp::extract(var_corners, var_2);
    var_4 = between_0(var_1, var_3, var_fz);
    var_6 = wp::extract(var_corners, var_5);
    var_8 = wp::extract(var_corners, var_7);
    var_9 = between_0(var_6, var_8, var_fz);
    var_10 = between_0(var_4, var_9, var_fy);
    // high = between(between(corners[4], corners[5], fz), between(corners[6], corners[7], fz), fy)       <L 96>
    var_12 = wp::extract(var_corners, var_11);
    var_14 = wp::extract(var_corners, var_13);
    var_15 = between_0(var_12, var_14, var_fz);
    var_17 = wp::extract(var_corners, var_16);
    var_19 = wp::extract(var_corners, var_18);
    var_20 = between_0(var_17, var_19, var_fz);
    var_21 = between_0(var_15, var_20, var_fy);
    // return between(low, high, fx)                                                          <L 97>
    var_22 = between_0(var_10, var_21, var_fx);
    return var_22;
}


// <pointloom.kernels.volumes.tsdf_raycast.value_in_cell>:1
static CUDA_CALLABLE wp::float32 value_in_cell_0(
    wp::float32 var_t,
    wp::vec_t<3, wp::float32> var_cell,
    wp::vec_t<8, wp::float32> var_corners,
    wp::vec_t<3, wp::float32> var_ray,
    wp::vec_t<3, wp::float32> var_rays__start)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    const wp::int32 var_2 = 0;
    wp::float32 var_3;
    wp::float32 var_4;
    wp::float32 var_5;
    const wp::int32 var_6 = 0;
    wp::float32 var_7;
    wp::float32 var_8;
    const wp::int32 var_9 = 1;
    wp::float32 var_10;
    const wp::int32 var_11 = 1;
    wp::float32 var_12;
    wp::float32 var_13;
    wp::float32 var_14;
    const wp::int32 var_15 = 1;
    wp::float32 var_16;
    wp::float32 var_17;
    const wp::int32 var_18 = 2;
    wp::float32 var_19;
    const wp::int32 var_20 = 2;
    wp::float32 var_21;
    wp::float32 var_22;
    wp::float32 var_23;
    const wp::int32 var_24 = 2;
    wp::float32 var_25;
    wp::float32 var_26;
    wp::float32 var_27;
    //---------
    // forward
    // def value_in_cell(t, cell, corners, ray, rays__start):                                 <L 1>
    // return interpolate(corners, rays__start[0] + ray[0] * t - cell[0], rays__start[1] + ray[1] * t - cell[1], rays__start[2] + ray[2] * t - cell[2])       <L 2>
    var_1 = wp::extract(var_rays__start, var_0);
    var_3 = wp::extract(var_ray, var_2);
    var_4 = wp::mul(var_3, var_t);
    var_5 = wp::add(var_1, var_4);
    var_7 = wp::extract(var_cell, var_6);
    var_8 = wp::sub(var_5, var_7);
    var_10 = wp::extract(var_rays__start, var_9);
    var_12 = wp::extract(var_ray, var_11);
    var_13 = wp::mul(var_12, var_t);
    var_14 = wp::add(var_10, var_13);
    var_16 = wp::extract(var_cell, var_15);
    var_17 = wp::sub(var_14, var_16);
    var_19 = wp::extract(var_rays__start, var_18);
    var_21 = wp::extract(var_ray, var_20);
    var_22 = wp::mul(var_21, var_t);
    var_23 = wp::add(var_19, var_22);
    var_25 = wp::extract(var_cell, var_24);
    var_26 = wp::sub(var_23, var_25);
    var_27 = interpolate_0(var_corners, var_8, var_17, var_26);
    return var_27;
}


// /work/main/src/pointloom/kernels/volumes/tsdf_raycast.py:67
static CUDA_CALLABLE wp::float32 zero_between_0(
    wp::float32 var_before,
    wp::float32 var_before_d,
    wp::float32 var_here,
    wp::float32 var_here_d)
{
    //---------
    // primal vars
    wp::float32 var_0;
    wp::float32 var_1;
    wp::float32 var_2;
    wp::float32 var_3;
    wp::float32 var_4;
    //---------
    // forward
    // def zero_between(before: float, before_d: float, here: float, here_d: float) -> float:       <L 68>
    // return before + (here - before) * before_d / (before_d - here_d)                       <L 69>
    var_0 = wp::sub(var_here, var_before);
    var_1 = wp::mul(var_0, var_before_d);
    var_2 = wp::sub(var_before_d, var_here_d);
    var_3 = wp::div(var_1, var_2);
    var_4 = wp::add(var_before, var_3);
    return var_4;
}


// <pointloom.kernels.volumes.tsdf_raycast.zero_in_cell>:1
static CUDA_CALLABLE wp::float32 zero_in_cell_0(
    wp::vec_t<4, wp::float32> var_ends,
    wp::vec_t<3, wp::float32> var_cell,
    wp::vec_t<8, wp::float32> var_corners,
    wp::vec_t<3, wp::float32> var_ray,
    wp::vec_t<3, wp::float32> var_rays__start)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::float32 var_1;
    const wp::int32 var_2 = 1;
    wp::float32 var_3;
    const wp::int32 var_4 = 2;
    wp::float32 var_5;
    const wp::int32 var_6 = 3;
    wp::float32 var_7;
    const wp::int32 var_8 = 1;
    wp::int32 var_9;
    wp::range_t var_10;
    wp::int32 var_11;
    wp::float32 var_12;
    wp::float32 var_13;
    const wp::float32 var_14 = 0.0;
    bool var_15;
    wp::float32 var_16;
    wp::float32 var_17;
    wp::float32 var_18;
    wp::float32 var_19;
    wp::float32 var_20;
    wp::float32 var_21;
    wp::float32 var_22;
    wp::float32 var_23;
    wp::float32 var_24;
    //---------
    // forward
    // def zero_in_cell(ends, cell, corners, ray, rays__start):                               <L 1>
    // a = ends[0]                                                                            <L 3>
    var_1 = wp::extract(var_ends, var_0);
    // a_d = ends[1]                                                                          <L 4>
    var_3 = wp::extract(var_ends, var_2);
    // b = ends[2]                                                                            <L 5>
    var_5 = wp::extract(var_ends, var_4);
    // b_d = ends[3]                                                                          <L 6>
    var_7 = wp::extract(var_ends, var_6);
    // n = int(1)                                                                             <L 7>
    var_9 = wp::int(var_8);
    // for _ in range(n):                                                                     <L 8>
    var_10 = wp::range(var_9);
    start_for_0:;
        if (iter_cmp(var_10) == 0) goto end_for_0;
        var_11 = wp::iter_next(var_10);
        // middle = zero_between(a, a_d, b, b_d)                                              <L 9>
        var_12 = zero_between_0(var_1, var_3, var_5, var_7);
        // m_d = value_in_cell(middle, cell, corners, ray, rays__start)                       <L 10>
        var_13 = value_in_cell_0(var_12, var_cell, var_corners, var_ray, var_rays__start);
        // if m_d > 0.0:                                                                      <L 11>
        var_15 = (var_13 > var_14);
        if (var_15) {
            // a = middle                                                                     <L 12>
            var_16 = wp::copy(var_12);
            // a_d = m_d                                                                      <L 13>
            var_17 = wp::copy(var_13);
        }
        if (!var_15) {
            // b = middle                                                                     <L 15>
            var_18 = wp::copy(var_12);
            // b_d = m_d                                                                      <L 16>
            var_19 = wp::copy(var_13);
        }
        var_20 = wp::where(var_15, var_16, var_1);
        var_21 = wp::where(var_15, var_17, var_3);
        var_22 = wp::where(var_15, var_5, var_18);
        var_23 = wp::where(var_15, var_7, var_19);
        wp::assign(var_1, var_20);
        wp::assign(var_3, var_21);
        wp::assign(var_5, var_22);
        wp::assign(var_7, var_23);
        goto start_for_0;
    end_for_0:;
    // return zero_between(a, a_d, b, b_d)                                                    <L 17>
    var_24 = zero_between_0(var_1, var_3, var_5, var_7);
    return var_24;
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


// <pointloom.kernels.volumes.tsdf_raycast.nearest_value>:1
static CUDA_CALLABLE wp::float32 nearest_value_0(
    wp::float32 var_t,
    wp::int32 var_block,
    wp::vec_t<3, wp::int32> var_corner,
    wp::vec_t<3, wp::float32> var_ray,
    wp::vec_t<3, wp::float32> var_rays__start,
    wp::array_t<wp::float32> var_seen__blocks__distances,
    wp::array_t<wp::uint16> var_seen__blocks__weights,
    wp::array_t<wp::int32> var_seen__neighbors,
    wp::float32 var_seen__threshold)
{
    //---------
    // primal vars
    wp::vec_t<3, wp::float32> var_0;
    wp::vec_t<3, wp::float32> var_1;
    wp::int32 var_2;
    wp::float32 var_3;
    //---------
    // forward
    // def nearest_value(t, block, corner, ray, rays__start, seen__blocks__distances, seen__blocks__weights, seen__neighbors, seen__threshold):       <L 1>
    // return seen_distance(nearest_voxel(rays__start + ray * t, block, corner, seen__neighbors), seen__blocks__distances, seen__blocks__weights, seen__threshold)       <L 3>
    var_0 = wp::mul(var_ray, var_t);
    var_1 = wp::add(var_rays__start, var_0);
    var_2 = nearest_voxel_0(var_1, var_block, var_corner, var_seen__neighbors);
    var_3 = seen_distance_0(var_2, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__threshold);
    return var_3;
}


// <pointloom.kernels.volumes.tsdf_raycast.hit_unseen>:1
static CUDA_CALLABLE wp::float32 hit_unseen_0(
    wp::vec_t<4, wp::float32> var_ends,
    wp::int32 var_block,
    wp::vec_t<3, wp::int32> var_corner,
    wp::vec_t<3, wp::float32> var_ray,
    wp::vec_t<3, wp::float32> var_rays__start,
    wp::array_t<wp::float32> var_seen__blocks__distances,
    wp::array_t<wp::uint16> var_seen__blocks__weights,
    wp::array_t<wp::int32> var_seen__neighbors,
    wp::float32 var_seen__threshold)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 0.5;
    const wp::int32 var_1 = 0;
    wp::float32 var_2;
    const wp::int32 var_3 = 2;
    wp::float32 var_4;
    wp::float32 var_5;
    wp::float32 var_6;
    wp::float32 var_7;
    const wp::int32 var_8 = 0;
    wp::float32 var_9;
    const wp::int32 var_10 = 1;
    wp::float32 var_11;
    const wp::float32 var_12 = 0.0;
    wp::float32 var_13;
    bool var_14;
    const wp::float32 var_15 = 0.0;
    bool var_16;
    const wp::float32 var_17 = 0.0;
    bool var_18;
    const wp::float32 var_19 = 2.0;
    bool var_20;
    wp::float32 var_21;
    wp::float32 var_22;
    bool var_23;
    wp::float32 var_24;
    wp::float32 var_25;
    wp::float32 var_26;
    wp::float32 var_27;
    bool var_28;
    const wp::float32 var_29 = 0.0;
    bool var_30;
    const wp::int32 var_31 = 3;
    wp::float32 var_32;
    const wp::float32 var_33 = 0.0;
    bool var_34;
    const wp::float32 var_35 = 0.0;
    bool var_36;
    bool var_37;
    const wp::int32 var_38 = 2;
    wp::float32 var_39;
    const wp::int32 var_40 = 3;
    wp::float32 var_41;
    wp::float32 var_42;
    wp::float32 var_43;
    //---------
    // forward
    // def hit_unseen(ends, block, corner, ray, rays__start, seen__blocks__distances, seen__blocks__weights, seen__neighbors, seen__threshold):       <L 1>
    // middle = 0.5 * (ends[0] + ends[2])                                                     <L 3>
    var_2 = wp::extract(var_ends, var_1);
    var_4 = wp::extract(var_ends, var_3);
    var_5 = wp::add(var_2, var_4);
    var_6 = wp::mul(var_0, var_5);
    // m_d = nearest_value(middle, block, corner, ray, rays__start, seen__blocks__distances, seen__blocks__weights, seen__neighbors, seen__threshold)       <L 4>
    var_7 = nearest_value_0(var_6, var_block, var_corner, var_ray, var_rays__start, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__neighbors, var_seen__threshold);
    // a = ends[0]                                                                            <L 5>
    var_9 = wp::extract(var_ends, var_8);
    // a_d = ends[1]                                                                          <L 6>
    var_11 = wp::extract(var_ends, var_10);
    // hit = float(0.0)                                                                       <L 7>
    var_13 = wp::float(var_12);
    // if m_d <= 0.0 and a_d > 0.0 and (a_d < UNSEEN):                                        <L 8>
    var_16 = (var_7 <= var_15);
    var_14 = var_16;
    if (var_14) {
        var_18 = (var_11 > var_17);
        var_14 = var_14 && var_18;
    }
    if (var_14) {
        var_20 = (var_11 < var_19);
        var_14 = var_14 && var_20;
    }
    if (var_14) {
        // hit = zero_between(a, a_d, middle, m_d)                                            <L 9>
        var_21 = zero_between_0(var_9, var_11, var_6, var_7);
    }
    var_22 = wp::where(var_14, var_21, var_13);
    // if m_d < UNSEEN:                                                                       <L 10>
    var_23 = (var_7 < var_19);
    if (var_23) {
        // a = middle                                                                         <L 11>
        var_24 = wp::copy(var_6);
        // a_d = m_d                                                                          <L 12>
        var_25 = wp::copy(var_7);
    }
    var_26 = wp::where(var_23, var_24, var_9);
    var_27 = wp::where(var_23, var_25, var_11);
    // if hit == 0.0 and ends[3] <= 0.0 and (a_d > 0.0) and (a_d < UNSEEN):                   <L 13>
    var_30 = (var_22 == var_29);
    var_28 = var_30;
    if (var_28) {
        var_32 = wp::extract(var_ends, var_31);
        var_34 = (var_32 <= var_33);
        var_28 = var_28 && var_34;
    }
    if (var_28) {
        var_36 = (var_27 > var_35);
        var_28 = var_28 && var_36;
    }
    if (var_28) {
        var_37 = (var_27 < var_19);
        var_28 = var_28 && var_37;
    }
    if (var_28) {
        // hit = zero_between(a, a_d, ends[2], ends[3])                                       <L 14>
        var_39 = wp::extract(var_ends, var_38);
        var_41 = wp::extract(var_ends, var_40);
        var_42 = zero_between_0(var_26, var_27, var_39, var_41);
    }
    var_43 = wp::where(var_28, var_42, var_22);
    // return hit                                                                             <L 15>
    return var_43;
}


// <pointloom.kernels.volumes.tsdf_raycast.hit_in_cell>:1
static CUDA_CALLABLE wp::vec_t<2, wp::float32> hit_in_cell_0(
    wp::vec_t<3, wp::float32> var_ends,
    wp::vec_t<3, wp::int32> var_cell,
    wp::int32 var_block,
    wp::vec_t<3, wp::int32> var_corner,
    wp::vec_t<3, wp::float32> var_ray,
    wp::vec_t<3, wp::float32> var_rays__start,
    wp::array_t<wp::float32> var_seen__blocks__distances,
    wp::array_t<wp::uint16> var_seen__blocks__weights,
    wp::array_t<wp::int32> var_seen__neighbors,
    wp::float32 var_seen__threshold)
{
    //---------
    // primal vars
    const wp::float32 var_0 = 0.0;
    wp::float32 var_1;
    const wp::int32 var_2 = 1;
    wp::float32 var_3;
    const wp::float32 var_4 = 2.0;
    wp::float32 var_5;
    const wp::int32 var_6 = 0;
    wp::int32 var_7;
    const wp::int32 var_8 = 0;
    wp::int32 var_9;
    wp::int32 var_10;
    const wp::int32 var_11 = 1;
    wp::int32 var_12;
    const wp::int32 var_13 = 1;
    wp::int32 var_14;
    wp::int32 var_15;
    const wp::int32 var_16 = 2;
    wp::int32 var_17;
    const wp::int32 var_18 = 2;
    wp::int32 var_19;
    wp::int32 var_20;
    wp::vec_t<8, wp::float32> var_21;
    wp::float32 var_22;
    bool var_23;
    wp::vec_t<3, wp::float32> var_24;
    const wp::int32 var_25 = 0;
    wp::float32 var_26;
    wp::float32 var_27;
    const wp::int32 var_28 = 2;
    wp::float32 var_29;
    wp::float32 var_30;
    bool var_31;
    const wp::float32 var_32 = 0.0;
    bool var_33;
    const wp::float32 var_34 = 0.0;
    bool var_35;
    const wp::int32 var_36 = 0;
    wp::float32 var_37;
    const wp::int32 var_38 = 2;
    wp::float32 var_39;
    wp::vec_t<4, wp::float32> var_40;
    wp::float32 var_41;
    wp::float32 var_42;
    bool var_43;
    const wp::float32 var_44 = 0.0;
    bool var_45;
    const wp::float32 var_46 = 0.0;
    bool var_47;
    bool var_48;
    const wp::int32 var_49 = 0;
    wp::float32 var_50;
    wp::float32 var_51;
    bool var_52;
    const wp::int32 var_53 = 0;
    wp::float32 var_54;
    wp::float32 var_55;
    wp::float32 var_56;
    const wp::int32 var_57 = 2;
    wp::float32 var_58;
    wp::float32 var_59;
    const wp::int32 var_60 = 0;
    wp::float32 var_61;
    const wp::int32 var_62 = 2;
    wp::float32 var_63;
    wp::vec_t<4, wp::float32> var_64;
    wp::float32 var_65;
    wp::float32 var_66;
    wp::float32 var_67;
    wp::float32 var_68;
    wp::vec_t<2, wp::float32> var_69;
    //---------
    // forward
    // def hit_in_cell(ends, cell, block, corner, ray, rays__start, seen__blocks__distances, seen__blocks__weights, seen__neighbors, seen__threshold):       <L 1>
    // hit = float(0.0)                                                                       <L 3>
    var_1 = wp::float(var_0);
    // before = ends[1]                                                                       <L 4>
    var_3 = wp::extract(var_ends, var_2);
    // after = float(UNSEEN)                                                                  <L 5>
    var_5 = wp::float(var_4);
    // corners = cell_distances(block, cell[0] - corner[0], cell[1] - corner[1], cell[2] - corner[2], seen__blocks__distances, seen__blocks__weights, seen__neighbors, seen__threshold)       <L 6>
    var_7 = wp::extract(var_cell, var_6);
    var_9 = wp::extract(var_corner, var_8);
    var_10 = wp::sub(var_7, var_9);
    var_12 = wp::extract(var_cell, var_11);
    var_14 = wp::extract(var_corner, var_13);
    var_15 = wp::sub(var_12, var_14);
    var_17 = wp::extract(var_cell, var_16);
    var_19 = wp::extract(var_corner, var_18);
    var_20 = wp::sub(var_17, var_19);
    var_21 = cell_distances_0(var_block, var_10, var_15, var_20, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__neighbors, var_seen__threshold);
    // if greatest(corners) < UNSEEN:                                                         <L 7>
    var_22 = greatest_0(var_21);
    var_23 = (var_22 < var_4);
    if (var_23) {
        // cell_position = to_float(cell)                                                     <L 8>
        var_24 = to_float_0(var_cell);
        // entry_d = value_in_cell(ends[0], cell_position, corners, ray, rays__start)         <L 9>
        var_26 = wp::extract(var_ends, var_25);
        var_27 = value_in_cell_0(var_26, var_24, var_21, var_ray, var_rays__start);
        // after = value_in_cell(ends[2], cell_position, corners, ray, rays__start)           <L 10>
        var_29 = wp::extract(var_ends, var_28);
        var_30 = value_in_cell_0(var_29, var_24, var_21, var_ray, var_rays__start);
        // if entry_d > 0.0 and after <= 0.0:                                                 <L 11>
        var_33 = (var_27 > var_32);
        var_31 = var_33;
        if (var_31) {
            var_35 = (var_30 <= var_34);
            var_31 = var_31 && var_35;
        }
        if (var_31) {
            // hit = zero_in_cell(vec4(ends[0], entry_d, ends[2], after), cell_position, corners, ray, rays__start)       <L 12>
            var_37 = wp::extract(var_ends, var_36);
            var_39 = wp::extract(var_ends, var_38);
            var_40 = wp::vec_t<4, wp::float32>(var_37, var_27, var_39, var_30);
            var_41 = zero_in_cell_0(var_40, var_24, var_21, var_ray, var_rays__start);
        }
        var_42 = wp::where(var_31, var_41, var_1);
        // if entry_d <= 0.0 and before > 0.0 and (before < UNSEEN):                          <L 13>
        var_45 = (var_27 <= var_44);
        var_43 = var_45;
        if (var_43) {
            var_47 = (var_3 > var_46);
            var_43 = var_43 && var_47;
        }
        if (var_43) {
            var_48 = (var_3 < var_4);
            var_43 = var_43 && var_48;
        }
        if (var_43) {
            // hit = ends[0]                                                                  <L 14>
            var_50 = wp::extract(var_ends, var_49);
        }
        var_51 = wp::where(var_43, var_50, var_42);
    }
    if (!var_23) {
        // if before == UNSEEN:                                                               <L 16>
        var_52 = (var_3 == var_4);
        if (var_52) {
            // before = nearest_value(ends[0], block, corner, ray, rays__start, seen__blocks__distances, seen__blocks__weights, seen__neighbors, seen__threshold)       <L 17>
            var_54 = wp::extract(var_ends, var_53);
            var_55 = nearest_value_0(var_54, var_block, var_corner, var_ray, var_rays__start, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__neighbors, var_seen__threshold);
        }
        var_56 = wp::where(var_52, var_55, var_3);
        // after = nearest_value(ends[2], block, corner, ray, rays__start, seen__blocks__distances, seen__blocks__weights, seen__neighbors, seen__threshold)       <L 18>
        var_58 = wp::extract(var_ends, var_57);
        var_59 = nearest_value_0(var_58, var_block, var_corner, var_ray, var_rays__start, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__neighbors, var_seen__threshold);
        // hit = hit_unseen(vec4(ends[0], before, ends[2], after), block, corner, ray, rays__start, seen__blocks__distances, seen__blocks__weights, seen__neighbors, seen__threshold)       <L 19>
        var_61 = wp::extract(var_ends, var_60);
        var_63 = wp::extract(var_ends, var_62);
        var_64 = wp::vec_t<4, wp::float32>(var_61, var_56, var_63, var_59);
        var_65 = hit_unseen_0(var_64, var_block, var_corner, var_ray, var_rays__start, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__neighbors, var_seen__threshold);
    }
    var_66 = wp::where(var_23, var_51, var_65);
    var_67 = wp::where(var_23, var_3, var_56);
    var_68 = wp::where(var_23, var_30, var_59);
    // return vec2(hit, after)                                                                <L 20>
    var_69 = wp::vec_t<2, wp::float32>(var_66, var_68);
    return var_69;
}


// /work/main/src/pointloom/kernels/volumes/tsdf_raycast.py:118
static CUDA_CALLABLE wp::int32 clamped_0(
    wp::float32 var_t,
    wp::float32 var_start,
    wp::float32 var_direction,
    wp::int32 var_low,
    wp::int32 var_size)
{
    //---------
    // primal vars
    wp::float32 var_0;
    wp::float32 var_1;
    wp::float32 var_2;
    wp::int32 var_3;
    wp::int32 var_4;
    wp::int32 var_5;
    const wp::int32 var_6 = 1;
    wp::int32 var_7;
    wp::int32 var_8;
    //---------
    // forward
    // def clamped(t: float, start: float, direction: float, low: int, size: int) -> int:       <L 119>
    // return min(max(int(floor(start + direction * t)), low), low + size - 1)                <L 120>
    var_0 = wp::mul(var_direction, var_t);
    var_1 = wp::add(var_start, var_0);
    var_2 = wp::floor(var_1);
    var_3 = wp::int(var_2);
    var_4 = wp::max(var_3, var_low);
    var_5 = wp::add(var_low, var_size);
    var_7 = wp::sub(var_5, var_6);
    var_8 = wp::min(var_4, var_7);
    return var_8;
}


// <pointloom.kernels.volumes.tsdf_raycast.cell_beyond>:1
static CUDA_CALLABLE wp::vec_t<3, wp::int32> cell_beyond_0(
    wp::float32 var_t,
    wp::vec_t<3, wp::float32> var_exits,
    wp::vec_t<3, wp::int32> var_low,
    wp::int32 var_size,
    wp::vec_t<3, wp::int32> var_ahead,
    wp::vec_t<3, wp::float32> var_ray,
    wp::vec_t<3, wp::float32> var_rays__start)
{
    //---------
    // primal vars
    const wp::int32 var_0 = 0;
    wp::int32 var_1;
    const wp::int32 var_2 = 1;
    wp::int32 var_3;
    const wp::int32 var_4 = 2;
    wp::int32 var_5;
    const wp::int32 var_6 = 1;
    bool var_7;
    const wp::int32 var_8 = 0;
    wp::float32 var_9;
    const wp::int32 var_10 = 0;
    wp::float32 var_11;
    const wp::int32 var_12 = 0;
    wp::int32 var_13;
    wp::int32 var_14;
    const wp::int32 var_15 = 1;
    wp::float32 var_16;
    const wp::int32 var_17 = 1;
    wp::float32 var_18;
    const wp::int32 var_19 = 1;
    wp::int32 var_20;
    wp::int32 var_21;
    const wp::int32 var_22 = 2;
    wp::float32 var_23;
    const wp::int32 var_24 = 2;
    wp::float32 var_25;
    const wp::int32 var_26 = 2;
    wp::int32 var_27;
    wp::int32 var_28;
    wp::int32 var_29;
    wp::int32 var_30;
    wp::int32 var_31;
    bool var_32;
    const wp::int32 var_33 = 0;
    wp::float32 var_34;
    const wp::int32 var_35 = 1;
    wp::float32 var_36;
    bool var_37;
    const wp::int32 var_38 = 0;
    wp::float32 var_39;
    const wp::int32 var_40 = 2;
    wp::float32 var_41;
    bool var_42;
    const wp::int32 var_43 = 0;
    wp::int32 var_44;
    const wp::int32 var_45 = 1;
    wp::int32 var_46;
    const wp::int32 var_47 = 0;
    wp::int32 var_48;
    const wp::int32 var_49 = 1;
    wp::int32 var_50;
    wp::int32 var_51;
    wp::int32 var_52;
    wp::int32 var_53;
    const wp::int32 var_54 = 1;
    wp::float32 var_55;
    const wp::int32 var_56 = 2;
    wp::float32 var_57;
    bool var_58;
    const wp::int32 var_59 = 1;
    wp::int32 var_60;
    const wp::int32 var_61 = 1;
    wp::int32 var_62;
    const wp::int32 var_63 = 1;
    wp::int32 var_64;
    const wp::int32 var_65 = 1;
    wp::int32 var_66;
    wp::int32 var_67;
    wp::int32 var_68;
    wp::int32 var_69;
    const wp::int32 var_70 = 2;
    wp::int32 var_71;
    const wp::int32 var_72 = 1;
    wp::int32 var_73;
    const wp::int32 var_74 = 2;
    wp::int32 var_75;
    const wp::int32 var_76 = 1;
    wp::int32 var_77;
    wp::int32 var_78;
    wp::int32 var_79;
    wp::int32 var_80;
    wp::int32 var_81;
    wp::int32 var_82;
    wp::int32 var_83;
    wp::int32 var_84;
    wp::int32 var_85;
    wp::vec_t<3, wp::int32> var_86;
    //---------
    // forward
    // def cell_beyond(t, exits, low, size, ahead, ray, rays__start):                         <L 1>
    // x = low[0]                                                                             <L 3>
    var_1 = wp::extract(var_low, var_0);
    // y = low[1]                                                                             <L 4>
    var_3 = wp::extract(var_low, var_2);
    // z = low[2]                                                                             <L 5>
    var_5 = wp::extract(var_low, var_4);
    // if size > 1:                                                                           <L 6>
    var_7 = (var_size > var_6);
    if (var_7) {
        // x = clamped(t, rays__start[0], ray[0], low[0], size)                               <L 7>
        var_9 = wp::extract(var_rays__start, var_8);
        var_11 = wp::extract(var_ray, var_10);
        var_13 = wp::extract(var_low, var_12);
        var_14 = clamped_0(var_t, var_9, var_11, var_13, var_size);
        // y = clamped(t, rays__start[1], ray[1], low[1], size)                               <L 8>
        var_16 = wp::extract(var_rays__start, var_15);
        var_18 = wp::extract(var_ray, var_17);
        var_20 = wp::extract(var_low, var_19);
        var_21 = clamped_0(var_t, var_16, var_18, var_20, var_size);
        // z = clamped(t, rays__start[2], ray[2], low[2], size)                               <L 9>
        var_23 = wp::extract(var_rays__start, var_22);
        var_25 = wp::extract(var_ray, var_24);
        var_27 = wp::extract(var_low, var_26);
        var_28 = clamped_0(var_t, var_23, var_25, var_27, var_size);
    }
    var_29 = wp::where(var_7, var_14, var_1);
    var_30 = wp::where(var_7, var_21, var_3);
    var_31 = wp::where(var_7, var_28, var_5);
    // if exits[0] <= exits[1] and exits[0] <= exits[2]:                                      <L 10>
    var_34 = wp::extract(var_exits, var_33);
    var_36 = wp::extract(var_exits, var_35);
    var_37 = (var_34 <= var_36);
    var_32 = var_37;
    if (var_32) {
        var_39 = wp::extract(var_exits, var_38);
        var_41 = wp::extract(var_exits, var_40);
        var_42 = (var_39 <= var_41);
        var_32 = var_32 && var_42;
    }
    if (var_32) {
        // x = low[0] - 1 - (ahead[0] & -(size + 1))                                          <L 11>
        var_44 = wp::extract(var_low, var_43);
        var_46 = wp::sub(var_44, var_45);
        var_48 = wp::extract(var_ahead, var_47);
        var_50 = wp::add(var_size, var_49);
        var_51 = wp::neg(var_50);
        var_52 = wp::bit_and(var_48, var_51);
        var_53 = wp::sub(var_46, var_52);
    }
    if (!var_32) {
        // elif exits[1] <= exits[2]:                                                         <L 12>
        var_55 = wp::extract(var_exits, var_54);
        var_57 = wp::extract(var_exits, var_56);
        var_58 = (var_55 <= var_57);
        if (var_58) {
            // y = low[1] - 1 - (ahead[1] & -(size + 1))                                      <L 13>
            var_60 = wp::extract(var_low, var_59);
            var_62 = wp::sub(var_60, var_61);
            var_64 = wp::extract(var_ahead, var_63);
            var_66 = wp::add(var_size, var_65);
            var_67 = wp::neg(var_66);
            var_68 = wp::bit_and(var_64, var_67);
            var_69 = wp::sub(var_62, var_68);
        }
        if (!var_58) {
            // z = low[2] - 1 - (ahead[2] & -(size + 1))                                      <L 15>
            var_71 = wp::extract(var_low, var_70);
            var_73 = wp::sub(var_71, var_72);
            var_75 = wp::extract(var_ahead, var_74);
            var_77 = wp::add(var_size, var_76);
            var_78 = wp::neg(var_77);
            var_79 = wp::bit_and(var_75, var_78);
            var_80 = wp::sub(var_73, var_79);
        }
        var_81 = wp::where(var_58, var_69, var_30);
        var_82 = wp::where(var_58, var_31, var_80);
    }
    var_83 = wp::where(var_32, var_53, var_29);
    var_84 = wp::where(var_32, var_30, var_81);
    var_85 = wp::where(var_32, var_31, var_82);
    // return vec3i(x, y, z)                                                                  <L 16>
    var_86 = wp::vec_t<3, wp::int32>(var_83, var_84, var_85);
    return var_86;
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


// /work/main/src/pointloom/kernels/volumes/tsdf_raycast.py:42
static CUDA_CALLABLE void adj_inverse_of_0(
    wp::float32 var_direction,
    wp::float32 & adj_direction,
    wp::float32 & adj_ret)
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


// /work/main/src/pointloom/kernels/volumes/voxel_samples.py:17
static CUDA_CALLABLE void adj_floor_cell_0(
    wp::vec_t<3, wp::float32> var_p,
    wp::vec_t<3, wp::float32> & adj_p,
    wp::vec_t<3, wp::int32> & adj_ret)
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


// <pointloom.kernels.volumes.tsdf_raycast.block_at>:1
static CUDA_CALLABLE void adj_block_at_0(
    wp::vec_t<3, wp::int32> var_cell,
    wp::vec_t<3, wp::int32> var_base,
    wp::array_t<wp::int64> var_seen__blocks__table__keys,
    wp::array_t<wp::int32> var_seen__blocks__table__positions,
    wp::int64 var_seen__blocks__table__mask,
    wp::vec_t<3, wp::int32> & adj_cell,
    wp::vec_t<3, wp::int32> & adj_base,
    wp::array_t<wp::int64> & adj_seen__blocks__table__keys,
    wp::array_t<wp::int32> & adj_seen__blocks__table__positions,
    wp::int64 & adj_seen__blocks__table__mask,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/algebra/plain_min_max.py:6
static CUDA_CALLABLE void adj_smaller_0(
    wp::float32 var_a,
    wp::float32 var_b,
    wp::float32 & adj_a,
    wp::float32 & adj_b,
    wp::float32 & adj_ret)
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


// <pointloom.kernels.volumes.voxel_samples.cell_distances>:1
static CUDA_CALLABLE void adj_cell_distances_0(
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


// /work/main/src/pointloom/kernels/volumes/voxel_samples.py:22
static CUDA_CALLABLE void adj_to_float_0(
    wp::vec_t<3, wp::int32> var_v,
    wp::vec_t<3, wp::int32> & adj_v,
    wp::vec_t<3, wp::float32> & adj_ret)
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


// /work/main/src/pointloom/kernels/volumes/voxel_samples.py:93
static CUDA_CALLABLE void adj_interpolate_0(
    wp::vec_t<8, wp::float32> var_corners,
    wp::float32 var_fx,
    wp::float32 var_fy,
    wp::float32 var_fz,
    wp::vec_t<8, wp::float32> & adj_corners,
    wp::float32 & adj_fx,
    wp::float32 & adj_fy,
    wp::float32 & adj_fz,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.tsdf_raycast.value_in_cell>:1
static CUDA_CALLABLE void adj_value_in_cell_0(
    wp::float32 var_t,
    wp::vec_t<3, wp::float32> var_cell,
    wp::vec_t<8, wp::float32> var_corners,
    wp::vec_t<3, wp::float32> var_ray,
    wp::vec_t<3, wp::float32> var_rays__start,
    wp::float32 & adj_t,
    wp::vec_t<3, wp::float32> & adj_cell,
    wp::vec_t<8, wp::float32> & adj_corners,
    wp::vec_t<3, wp::float32> & adj_ray,
    wp::vec_t<3, wp::float32> & adj_rays__start,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/volumes/tsdf_raycast.py:67
static CUDA_CALLABLE void adj_zero_between_0(
    wp::float32 var_before,
    wp::float32 var_before_d,
    wp::float32 var_here,
    wp::float32 var_here_d,
    wp::float32 & adj_before,
    wp::float32 & adj_before_d,
    wp::float32 & adj_here,
    wp::float32 & adj_here_d,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.tsdf_raycast.zero_in_cell>:1
static CUDA_CALLABLE void adj_zero_in_cell_0(
    wp::vec_t<4, wp::float32> var_ends,
    wp::vec_t<3, wp::float32> var_cell,
    wp::vec_t<8, wp::float32> var_corners,
    wp::vec_t<3, wp::float32> var_ray,
    wp::vec_t<3, wp::float32> var_rays__start,
    wp::vec_t<4, wp::float32> & adj_ends,
    wp::vec_t<3, wp::float32> & adj_cell,
    wp::vec_t<8, wp::float32> & adj_corners,
    wp::vec_t<3, wp::float32> & adj_ray,
    wp::vec_t<3, wp::float32> & adj_rays__start,
    wp::float32 & adj_ret)
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


// <pointloom.kernels.volumes.tsdf_raycast.nearest_value>:1
static CUDA_CALLABLE void adj_nearest_value_0(
    wp::float32 var_t,
    wp::int32 var_block,
    wp::vec_t<3, wp::int32> var_corner,
    wp::vec_t<3, wp::float32> var_ray,
    wp::vec_t<3, wp::float32> var_rays__start,
    wp::array_t<wp::float32> var_seen__blocks__distances,
    wp::array_t<wp::uint16> var_seen__blocks__weights,
    wp::array_t<wp::int32> var_seen__neighbors,
    wp::float32 var_seen__threshold,
    wp::float32 & adj_t,
    wp::int32 & adj_block,
    wp::vec_t<3, wp::int32> & adj_corner,
    wp::vec_t<3, wp::float32> & adj_ray,
    wp::vec_t<3, wp::float32> & adj_rays__start,
    wp::array_t<wp::float32> & adj_seen__blocks__distances,
    wp::array_t<wp::uint16> & adj_seen__blocks__weights,
    wp::array_t<wp::int32> & adj_seen__neighbors,
    wp::float32 & adj_seen__threshold,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.tsdf_raycast.hit_unseen>:1
static CUDA_CALLABLE void adj_hit_unseen_0(
    wp::vec_t<4, wp::float32> var_ends,
    wp::int32 var_block,
    wp::vec_t<3, wp::int32> var_corner,
    wp::vec_t<3, wp::float32> var_ray,
    wp::vec_t<3, wp::float32> var_rays__start,
    wp::array_t<wp::float32> var_seen__blocks__distances,
    wp::array_t<wp::uint16> var_seen__blocks__weights,
    wp::array_t<wp::int32> var_seen__neighbors,
    wp::float32 var_seen__threshold,
    wp::vec_t<4, wp::float32> & adj_ends,
    wp::int32 & adj_block,
    wp::vec_t<3, wp::int32> & adj_corner,
    wp::vec_t<3, wp::float32> & adj_ray,
    wp::vec_t<3, wp::float32> & adj_rays__start,
    wp::array_t<wp::float32> & adj_seen__blocks__distances,
    wp::array_t<wp::uint16> & adj_seen__blocks__weights,
    wp::array_t<wp::int32> & adj_seen__neighbors,
    wp::float32 & adj_seen__threshold,
    wp::float32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.tsdf_raycast.hit_in_cell>:1
static CUDA_CALLABLE void adj_hit_in_cell_0(
    wp::vec_t<3, wp::float32> var_ends,
    wp::vec_t<3, wp::int32> var_cell,
    wp::int32 var_block,
    wp::vec_t<3, wp::int32> var_corner,
    wp::vec_t<3, wp::float32> var_ray,
    wp::vec_t<3, wp::float32> var_rays__start,
    wp::array_t<wp::float32> var_seen__blocks__distances,
    wp::array_t<wp::uint16> var_seen__blocks__weights,
    wp::array_t<wp::int32> var_seen__neighbors,
    wp::float32 var_seen__threshold,
    wp::vec_t<3, wp::float32> & adj_ends,
    wp::vec_t<3, wp::int32> & adj_cell,
    wp::int32 & adj_block,
    wp::vec_t<3, wp::int32> & adj_corner,
    wp::vec_t<3, wp::float32> & adj_ray,
    wp::vec_t<3, wp::float32> & adj_rays__start,
    wp::array_t<wp::float32> & adj_seen__blocks__distances,
    wp::array_t<wp::uint16> & adj_seen__blocks__weights,
    wp::array_t<wp::int32> & adj_seen__neighbors,
    wp::float32 & adj_seen__threshold,
    wp::vec_t<2, wp::float32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// /work/main/src/pointloom/kernels/volumes/tsdf_raycast.py:118
static CUDA_CALLABLE void adj_clamped_0(
    wp::float32 var_t,
    wp::float32 var_start,
    wp::float32 var_direction,
    wp::int32 var_low,
    wp::int32 var_size,
    wp::float32 & adj_t,
    wp::float32 & adj_start,
    wp::float32 & adj_direction,
    wp::int32 & adj_low,
    wp::int32 & adj_size,
    wp::int32 & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}


// <pointloom.kernels.volumes.tsdf_raycast.cell_beyond>:1
static CUDA_CALLABLE void adj_cell_beyond_0(
    wp::float32 var_t,
    wp::vec_t<3, wp::float32> var_exits,
    wp::vec_t<3, wp::int32> var_low,
    wp::int32 var_size,
    wp::vec_t<3, wp::int32> var_ahead,
    wp::vec_t<3, wp::float32> var_ray,
    wp::vec_t<3, wp::float32> var_rays__start,
    wp::float32 & adj_t,
    wp::vec_t<3, wp::float32> & adj_exits,
    wp::vec_t<3, wp::int32> & adj_low,
    wp::int32 & adj_size,
    wp::vec_t<3, wp::int32> & adj_ahead,
    wp::vec_t<3, wp::float32> & adj_ray,
    wp::vec_t<3, wp::float32> & adj_rays__start,
    wp::vec_t<3, wp::int32> & adj_ret)
{
	// reverse mode disabled (no backward-enabled kernel depends on this function)
}



extern "C" __global__ void WP_MAXNREG(128) cast_rays_kernel_c24ad9a6_cuda_kernel_forward(
    wp::launch_bounds_t<1> dim,
    wp::int32 var_rays__camera__width,
    wp::int32 var_rays__camera__height,
    wp::mat_t<3, 3, wp::float64> var_rays__sight,
    wp::vec_t<3, wp::int32> var_rays__base,
    wp::vec_t<3, wp::float32> var_rays__start,
    wp::float32 var_rays__nearest,
    wp::float32 var_rays__farthest,
    wp::int32 var_rays__columns,
    wp::array_t<wp::int32> var_rays__nears,
    wp::array_t<wp::int32> var_rays__fars,
    wp::array_t<wp::int64> var_seen__blocks__table__keys,
    wp::array_t<wp::int32> var_seen__blocks__table__positions,
    wp::int64 var_seen__blocks__table__mask,
    wp::array_t<wp::float32> var_seen__blocks__distances,
    wp::array_t<wp::uint16> var_seen__blocks__weights,
    wp::array_t<wp::int32> var_seen__neighbors,
    wp::float32 var_seen__threshold,
    wp::array_t<wp::int64> var_signs__cells,
    wp::array_t<wp::int32> var_signs__parts,
    wp::array_t<wp::float32> var_depth,
    wp::array_t<wp::int32> var_met)
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
        wp::int32 var_3;
        wp::int32 var_4;
        wp::int32 var_5;
        wp::int32 var_6;
        wp::int32 var_7;
        wp::int32 var_8;
        wp::int32 var_9;
        wp::int32 var_10;
        wp::int32 var_11;
        wp::int32 var_12;
        bool var_13;
        bool var_14;
        bool var_15;
        wp::int32 var_16;
        wp::int32 var_17;
        wp::vec_t<3, wp::float32> var_18;
        const wp::int32 var_19 = 0;
        wp::float32 var_20;
        wp::float32 var_21;
        const wp::int32 var_22 = 1;
        wp::float32 var_23;
        wp::float32 var_24;
        const wp::int32 var_25 = 2;
        wp::float32 var_26;
        wp::float32 var_27;
        wp::vec_t<3, wp::float32> var_28;
        const wp::int32 var_29 = 0;
        wp::float32 var_30;
        const wp::float32 var_31 = 0.0;
        bool var_32;
        wp::int32 var_33;
        wp::int32 var_34;
        const wp::int32 var_35 = 1;
        wp::float32 var_36;
        const wp::float32 var_37 = 0.0;
        bool var_38;
        wp::int32 var_39;
        wp::int32 var_40;
        const wp::int32 var_41 = 2;
        wp::float32 var_42;
        const wp::float32 var_43 = 0.0;
        bool var_44;
        wp::int32 var_45;
        wp::int32 var_46;
        wp::vec_t<3, wp::int32> var_47;
        wp::int32* var_48;
        wp::float32 var_49;
        wp::int32 var_50;
        const wp::float32 var_51 = 0.999999;
        wp::float32 var_52;
        wp::float32 var_53;
        wp::int32* var_54;
        wp::float32 var_55;
        wp::int32 var_56;
        wp::float32 var_57;
        const wp::float32 var_58 = 0.0;
        wp::float32 var_59;
        const wp::int32 var_60 = 0;
        wp::int32 var_61;
        bool var_62;
        wp::vec_t<3, wp::float32> var_63;
        wp::vec_t<3, wp::float32> var_64;
        wp::vec_t<3, wp::int32> var_65;
        const wp::float32 var_66 = 2.0;
        wp::float32 var_67;
        wp::int32 var_68;
        const wp::int32 var_69 = 0;
        wp::int32 var_70;
        const wp::int32 var_71 = 0;
        wp::int32 var_72;
        wp::int32 var_73;
        const wp::int32 var_74 = 8;
        const wp::int32 var_75 = -8;
        wp::int32 var_76;
        const wp::int32 var_77 = 0;
        wp::int32 var_78;
        wp::int32 var_79;
        const wp::int32 var_80 = 1;
        wp::int32 var_81;
        const wp::int32 var_82 = 1;
        wp::int32 var_83;
        wp::int32 var_84;
        const wp::int32 var_85 = -8;
        wp::int32 var_86;
        const wp::int32 var_87 = 1;
        wp::int32 var_88;
        wp::int32 var_89;
        const wp::int32 var_90 = 2;
        wp::int32 var_91;
        const wp::int32 var_92 = 2;
        wp::int32 var_93;
        wp::int32 var_94;
        const wp::int32 var_95 = -8;
        wp::int32 var_96;
        const wp::int32 var_97 = 2;
        wp::int32 var_98;
        wp::int32 var_99;
        wp::vec_t<3, wp::int32> var_100;
        const wp::int32 var_101 = 0;
        wp::int32 var_102;
        const wp::int32 var_103 = 0;
        bool var_104;
        wp::int32* var_105;
        wp::int32 var_106;
        wp::int32 var_107;
        wp::int32 var_108;
        bool var_109;
        bool var_110;
        const wp::float32 var_111 = 0.0;
        bool var_112;
        const wp::int32 var_113 = 8192;
        bool var_114;
        const wp::int32 var_115 = 1;
        wp::int32 var_116;
        const wp::int32 var_117 = 0;
        wp::int32 var_118;
        const wp::int32 var_119 = 0;
        wp::int32 var_120;
        wp::int32 var_121;
        const wp::int32 var_122 = 1;
        wp::int32 var_123;
        const wp::int32 var_124 = 1;
        wp::int32 var_125;
        wp::int32 var_126;
        const wp::int32 var_127 = 2;
        wp::int32 var_128;
        const wp::int32 var_129 = 2;
        wp::int32 var_130;
        wp::int32 var_131;
        wp::int32 var_132;
        const wp::int32 var_133 = 0;
        wp::int32 var_134;
        const wp::int32 var_135 = 0;
        bool var_136;
        const wp::int32 var_137 = 4;
        wp::int32 var_138;
        const wp::int32 var_139 = 2;
        wp::int32 var_140;
        const wp::int32 var_141 = 4;
        wp::int32 var_142;
        const wp::int32 var_143 = 2;
        wp::int32 var_144;
        const wp::int32 var_145 = 2;
        wp::int32 var_146;
        wp::int32 var_147;
        const wp::int32 var_148 = 2;
        wp::int32 var_149;
        wp::int32 var_150;
        wp::int32 var_151;
        const wp::int32 var_152 = 1;
        wp::int32 var_153;
        const wp::int32 var_154 = 1;
        bool var_155;
        const wp::int32 var_156 = 1;
        wp::int32 var_157;
        wp::int32 var_158;
        wp::int64* var_159;
        wp::int32 var_160;
        wp::int32 var_161;
        wp::int64 var_162;
        wp::int64 var_163;
        wp::int64 var_164;
        wp::int32 var_165;
        const wp::int32 var_166 = 1;
        wp::int32 var_167;
        wp::int32 var_168;
        wp::int32 var_169;
        wp::int32 var_170;
        wp::int32 var_171;
        const wp::int32 var_172 = 0;
        wp::int32 var_173;
        wp::int32 var_174;
        wp::int32 var_175;
        wp::int32 var_176;
        const wp::int32 var_177 = 1;
        wp::int32 var_178;
        wp::int32 var_179;
        wp::int32 var_180;
        wp::int32 var_181;
        const wp::int32 var_182 = 2;
        wp::int32 var_183;
        wp::int32 var_184;
        wp::int32 var_185;
        wp::int32 var_186;
        wp::vec_t<3, wp::int32> var_187;
        const wp::int32 var_188 = 0;
        wp::int32 var_189;
        const wp::int32 var_190 = 0;
        wp::int32 var_191;
        wp::int32 var_192;
        wp::int32 var_193;
        wp::float32 var_194;
        const wp::int32 var_195 = 0;
        wp::float32 var_196;
        wp::float32 var_197;
        const wp::int32 var_198 = 0;
        wp::float32 var_199;
        wp::float32 var_200;
        const wp::int32 var_201 = 1;
        wp::int32 var_202;
        const wp::int32 var_203 = 1;
        wp::int32 var_204;
        wp::int32 var_205;
        wp::int32 var_206;
        wp::float32 var_207;
        const wp::int32 var_208 = 1;
        wp::float32 var_209;
        wp::float32 var_210;
        const wp::int32 var_211 = 1;
        wp::float32 var_212;
        wp::float32 var_213;
        const wp::int32 var_214 = 2;
        wp::int32 var_215;
        const wp::int32 var_216 = 2;
        wp::int32 var_217;
        wp::int32 var_218;
        wp::int32 var_219;
        wp::float32 var_220;
        const wp::int32 var_221 = 2;
        wp::float32 var_222;
        wp::float32 var_223;
        const wp::int32 var_224 = 2;
        wp::float32 var_225;
        wp::float32 var_226;
        wp::float32 var_227;
        wp::float32 var_228;
        wp::float32 var_229;
        wp::float32 var_230;
        const wp::int32 var_231 = 1;
        bool var_232;
        wp::vec_t<3, wp::float32> var_233;
        wp::vec_t<2, wp::float32> var_234;
        const wp::int32 var_235 = 0;
        wp::float32 var_236;
        const wp::int32 var_237 = 1;
        wp::float32 var_238;
        wp::float32 var_239;
        wp::float32 var_240;
        const wp::float32 var_241 = 0.0;
        bool var_242;
        wp::float32 var_243;
        wp::float32 var_244;
        wp::vec_t<3, wp::float32> var_245;
        wp::vec_t<3, wp::int32> var_246;
        const wp::int32 var_247 = 0;
        wp::int32 var_248;
        const wp::int32 var_249 = 0;
        wp::int32 var_250;
        wp::int32 var_251;
        const wp::int32 var_252 = 3;
        wp::int32 var_253;
        const wp::int32 var_254 = 1;
        wp::int32 var_255;
        const wp::int32 var_256 = 1;
        wp::int32 var_257;
        wp::int32 var_258;
        const wp::int32 var_259 = 3;
        wp::int32 var_260;
        const wp::int32 var_261 = 2;
        wp::int32 var_262;
        const wp::int32 var_263 = 2;
        wp::int32 var_264;
        wp::int32 var_265;
        const wp::int32 var_266 = 3;
        wp::int32 var_267;
        wp::int32 var_268;
        wp::int32 var_269;
        const wp::int32 var_270 = 0;
        bool var_271;
        const wp::int32 var_272 = 0;
        bool var_273;
        const wp::int32 var_274 = 27;
        wp::int32 var_275;
        const wp::int32 var_276 = 13;
        wp::int32 var_277;
        const wp::int32 var_278 = 9;
        wp::int32 var_279;
        wp::int32 var_280;
        const wp::int32 var_281 = 3;
        wp::int32 var_282;
        wp::int32 var_283;
        wp::int32 var_284;
        wp::int32* var_285;
        wp::int32 var_286;
        wp::int32 var_287;
        wp::int32 var_288;
        wp::int32 var_289;
        const wp::int32 var_290 = 0;
        wp::int32 var_291;
        wp::int32 var_292;
        wp::int32 var_293;
        const wp::int32 var_294 = 1;
        wp::int32 var_295;
        wp::int32 var_296;
        wp::int32 var_297;
        const wp::int32 var_298 = 2;
        wp::int32 var_299;
        wp::int32 var_300;
        wp::int32 var_301;
        wp::vec_t<3, wp::int32> var_302;
        const wp::int32 var_303 = 0;
        wp::int32 var_304;
        const wp::int32 var_305 = 0;
        bool var_306;
        wp::int32* var_307;
        wp::int32 var_308;
        wp::int32 var_309;
        wp::int32 var_310;
        wp::int32 var_311;
        wp::vec_t<3, wp::int32> var_312;
        wp::int32 var_313;
        wp::float32 var_314;
        wp::vec_t<3, wp::int32> var_315;
        wp::float32 var_316;
        wp::int32 var_317;
        wp::vec_t<3, wp::int32> var_318;
        wp::int32 var_319;
        bool var_320;
        const wp::float32 var_321 = 0.0;
        wp::float32 var_322;
        //---------
        // forward
        // def cast_rays_kernel(rays__camera__width, rays__camera__height, rays__sight, rays__base, rays__start, rays__nearest, rays__farthest, rays__columns, rays__nears, rays__fars, seen__blocks__table__keys, seen__blocks__table__positions, seen__blocks__table__mask, seen__blocks__distances, seen__blocks__weights, seen__neighbors, seen__threshold, signs__cells, signs__parts, depth, met):       <L 1>
        // i = tid()                                                                              <L 3>
        var_0 = builtin_tid1d();
        // tile = i // (TILE * TILE)                                                              <L 4>
        var_2 = wp::mul(var_1, var_1);
        var_3 = wp::floordiv(var_0, var_2);
        // column = tile % rays__columns * TILE + i % TILE                                        <L 5>
        var_4 = wp::mod(var_3, var_rays__columns);
        var_5 = wp::mul(var_4, var_1);
        var_6 = wp::mod(var_0, var_1);
        var_7 = wp::add(var_5, var_6);
        // row = tile // rays__columns * TILE + i // TILE % TILE                                  <L 6>
        var_8 = wp::floordiv(var_3, var_rays__columns);
        var_9 = wp::mul(var_8, var_1);
        var_10 = wp::floordiv(var_0, var_1);
        var_11 = wp::mod(var_10, var_1);
        var_12 = wp::add(var_9, var_11);
        // if column >= rays__camera__width or row >= rays__camera__height:                       <L 7>
        var_14 = (var_7 >= var_rays__camera__width);
        var_13 = var_14;
        if (!var_13) {
            var_15 = (var_12 >= var_rays__camera__height);
            var_13 = var_13 || var_15;
        }
        if (var_13) {
            // return                                                                             <L 8>
            return;
        }
        // pixel = row * rays__camera__width + column                                             <L 9>
        var_16 = wp::mul(var_12, var_rays__camera__width);
        var_17 = wp::add(var_16, var_7);
        // ray = ray_of(column, row, rays__sight)                                                 <L 10>
        var_18 = ray_of_0(var_7, var_12, var_rays__sight);
        // inverse = vec3(inverse_of(ray[0]), inverse_of(ray[1]), inverse_of(ray[2]))             <L 11>
        var_20 = wp::extract(var_18, var_19);
        var_21 = inverse_of_0(var_20);
        var_23 = wp::extract(var_18, var_22);
        var_24 = inverse_of_0(var_23);
        var_26 = wp::extract(var_18, var_25);
        var_27 = inverse_of_0(var_26);
        var_28 = wp::vec_t<3, wp::float32>(var_21, var_24, var_27);
        // ahead = vec3i(-int(inverse[0] > 0.0), -int(inverse[1] > 0.0), -int(inverse[2] > 0.0))       <L 12>
        var_30 = wp::extract(var_28, var_29);
        var_32 = (var_30 > var_31);
        var_33 = wp::int(var_32);
        var_34 = wp::neg(var_33);
        var_36 = wp::extract(var_28, var_35);
        var_38 = (var_36 > var_37);
        var_39 = wp::int(var_38);
        var_40 = wp::neg(var_39);
        var_42 = wp::extract(var_28, var_41);
        var_44 = (var_42 > var_43);
        var_45 = wp::int(var_44);
        var_46 = wp::neg(var_45);
        var_47 = wp::vec_t<3, wp::int32>(var_34, var_40, var_46);
        // t = max(rays__nearest, bits_float(rays__nears[tile]) * EARLIER)                        <L 13>
        var_48 = wp::address(var_rays__nears, var_3);
        var_50 = wp::load(var_48);
        var_49 = _bits_float_0(var_50);
        var_52 = wp::mul(var_49, var_51);
        var_53 = wp::max(var_rays__nearest, var_52);
        // last = min(rays__farthest, bits_float(rays__fars[tile]))                               <L 14>
        var_54 = wp::address(var_rays__fars, var_3);
        var_56 = wp::load(var_54);
        var_55 = _bits_float_0(var_56);
        var_57 = wp::min(var_rays__farthest, var_55);
        // hit = float(0.0)                                                                       <L 15>
        var_59 = wp::float(var_58);
        // steps = int(0)                                                                         <L 16>
        var_61 = wp::int(var_60);
        // if t <= last:                                                                          <L 17>
        var_62 = (var_53 <= var_57);
        if (var_62) {
            // cell = floor_cell(rays__start + ray * t)                                           <L 18>
            var_63 = wp::mul(var_18, var_53);
            var_64 = wp::add(var_rays__start, var_63);
            var_65 = floor_cell_0(var_64);
            // before = float(UNSEEN)                                                             <L 19>
            var_67 = wp::float(var_66);
            // block = block_at(cell, rays__base, seen__blocks__table__keys, seen__blocks__table__positions, seen__blocks__table__mask)       <L 20>
            var_68 = block_at_0(var_65, var_rays__base, var_seen__blocks__table__keys, var_seen__blocks__table__positions, var_seen__blocks__table__mask);
            // corner = vec3i((cell[0] + rays__base[0] & -SIDE) - rays__base[0], (cell[1] + rays__base[1] & -SIDE) - rays__base[1], (cell[2] + rays__base[2] & -SIDE) - rays__base[2])       <L 21>
            var_70 = wp::extract(var_65, var_69);
            var_72 = wp::extract(var_rays__base, var_71);
            var_73 = wp::add(var_70, var_72);
            var_76 = wp::bit_and(var_73, var_75);
            var_78 = wp::extract(var_rays__base, var_77);
            var_79 = wp::sub(var_76, var_78);
            var_81 = wp::extract(var_65, var_80);
            var_83 = wp::extract(var_rays__base, var_82);
            var_84 = wp::add(var_81, var_83);
            var_86 = wp::bit_and(var_84, var_85);
            var_88 = wp::extract(var_rays__base, var_87);
            var_89 = wp::sub(var_86, var_88);
            var_91 = wp::extract(var_65, var_90);
            var_93 = wp::extract(var_rays__base, var_92);
            var_94 = wp::add(var_91, var_93);
            var_96 = wp::bit_and(var_94, var_95);
            var_98 = wp::extract(var_rays__base, var_97);
            var_99 = wp::sub(var_96, var_98);
            var_100 = wp::vec_t<3, wp::int32>(var_79, var_89, var_99);
            // parts = int(0)                                                                     <L 22>
            var_102 = wp::int(var_101);
            // if block >= 0:                                                                     <L 23>
            var_104 = (var_68 >= var_103);
            if (var_104) {
                // parts = signs__parts[block]                                                    <L 24>
                var_105 = wp::address(var_signs__parts, var_68);
                var_107 = wp::load(var_105);
                var_106 = wp::copy(var_107);
            }
            var_108 = wp::where(var_104, var_106, var_102);
            // while t <= last and hit == 0.0 and (steps < MAX_STEPS):                            <L 25>
        start_while_1:;
            var_110 = (var_53 <= var_57);
            var_109 = var_110;
            if (var_109) {
                var_112 = (var_59 == var_111);
                var_109 = var_109 && var_112;
            }
            if (var_109) {
                var_114 = (var_61 < var_113);
                var_109 = var_109 && var_114;
            }
        if ((var_109) == false) goto end_while_1;
                // steps += 1                                                                     <L 26>
                var_116 = wp::add(var_61, var_115);
                // x = cell[0] - corner[0]                                                        <L 27>
                var_118 = wp::extract(var_65, var_117);
                var_120 = wp::extract(var_100, var_119);
                var_121 = wp::sub(var_118, var_120);
                // y = cell[1] - corner[1]                                                        <L 28>
                var_123 = wp::extract(var_65, var_122);
                var_125 = wp::extract(var_100, var_124);
                var_126 = wp::sub(var_123, var_125);
                // z = cell[2] - corner[2]                                                        <L 29>
                var_128 = wp::extract(var_65, var_127);
                var_130 = wp::extract(var_100, var_129);
                var_131 = wp::sub(var_128, var_130);
                // size = int(SIDE)                                                               <L 30>
                var_132 = wp::int(var_74);
                // is_candidate = int(0)                                                          <L 31>
                var_134 = wp::int(var_133);
                // if parts != 0:                                                                 <L 32>
                var_136 = (var_108 != var_135);
                if (var_136) {
                    // size = int(HALF)                                                           <L 33>
                    var_138 = wp::int(var_137);
                    // if parts >> (x >> 2) * 4 + (y >> 2) * 2 + (z >> 2) & 1 == 1:               <L 34>
                    var_140 = wp::rshift(var_121, var_139);
                    var_142 = wp::mul(var_140, var_141);
                    var_144 = wp::rshift(var_126, var_143);
                    var_146 = wp::mul(var_144, var_145);
                    var_147 = wp::add(var_142, var_146);
                    var_149 = wp::rshift(var_131, var_148);
                    var_150 = wp::add(var_147, var_149);
                    var_151 = wp::rshift(var_108, var_150);
                    var_153 = wp::bit_and(var_151, var_152);
                    var_155 = (var_153 == var_154);
                    if (var_155) {
                        // size = 1                                                               <L 35>
                        // is_candidate = int(signs__cells[block * SIDE + x] >> int64(y * SIDE + z)) & 1       <L 36>
                        var_157 = wp::mul(var_68, var_74);
                        var_158 = wp::add(var_157, var_121);
                        var_159 = wp::address(var_signs__cells, var_158);
                        var_160 = wp::mul(var_126, var_74);
                        var_161 = wp::add(var_160, var_131);
                        var_162 = wp::int64(var_161);
                        var_164 = wp::load(var_159);
                        var_163 = wp::rshift(var_164, var_162);
                        var_165 = wp::int(var_163);
                        var_167 = wp::bit_and(var_165, var_166);
                    }
                    var_168 = wp::where(var_155, var_156, var_138);
                    var_169 = wp::where(var_155, var_167, var_134);
                }
                var_170 = wp::where(var_136, var_168, var_132);
                var_171 = wp::where(var_136, var_169, var_134);
                // low = vec3i(corner[0] + (x & -size), corner[1] + (y & -size), corner[2] + (z & -size))       <L 37>
                var_173 = wp::extract(var_100, var_172);
                var_174 = wp::neg(var_170);
                var_175 = wp::bit_and(var_121, var_174);
                var_176 = wp::add(var_173, var_175);
                var_178 = wp::extract(var_100, var_177);
                var_179 = wp::neg(var_170);
                var_180 = wp::bit_and(var_126, var_179);
                var_181 = wp::add(var_178, var_180);
                var_183 = wp::extract(var_100, var_182);
                var_184 = wp::neg(var_170);
                var_185 = wp::bit_and(var_131, var_184);
                var_186 = wp::add(var_183, var_185);
                var_187 = wp::vec_t<3, wp::int32>(var_176, var_181, var_186);
                // tx = (float(low[0] + (ahead[0] & size)) - rays__start[0]) * inverse[0]         <L 38>
                var_189 = wp::extract(var_187, var_188);
                var_191 = wp::extract(var_47, var_190);
                var_192 = wp::bit_and(var_191, var_170);
                var_193 = wp::add(var_189, var_192);
                var_194 = wp::float(var_193);
                var_196 = wp::extract(var_rays__start, var_195);
                var_197 = wp::sub(var_194, var_196);
                var_199 = wp::extract(var_28, var_198);
                var_200 = wp::mul(var_197, var_199);
                // ty = (float(low[1] + (ahead[1] & size)) - rays__start[1]) * inverse[1]         <L 39>
                var_202 = wp::extract(var_187, var_201);
                var_204 = wp::extract(var_47, var_203);
                var_205 = wp::bit_and(var_204, var_170);
                var_206 = wp::add(var_202, var_205);
                var_207 = wp::float(var_206);
                var_209 = wp::extract(var_rays__start, var_208);
                var_210 = wp::sub(var_207, var_209);
                var_212 = wp::extract(var_28, var_211);
                var_213 = wp::mul(var_210, var_212);
                // tz = (float(low[2] + (ahead[2] & size)) - rays__start[2]) * inverse[2]         <L 40>
                var_215 = wp::extract(var_187, var_214);
                var_217 = wp::extract(var_47, var_216);
                var_218 = wp::bit_and(var_217, var_170);
                var_219 = wp::add(var_215, var_218);
                var_220 = wp::float(var_219);
                var_222 = wp::extract(var_rays__start, var_221);
                var_223 = wp::sub(var_220, var_222);
                var_225 = wp::extract(var_28, var_224);
                var_226 = wp::mul(var_223, var_225);
                // leave = larger(smaller(tx, smaller(ty, tz)), t)                                <L 41>
                var_227 = smaller_0(var_213, var_226);
                var_228 = smaller_0(var_200, var_227);
                var_229 = larger_0(var_228, var_53);
                // after = float(UNSEEN)                                                          <L 42>
                var_230 = wp::float(var_66);
                // if is_candidate == 1:                                                          <L 43>
                var_232 = (var_171 == var_231);
                if (var_232) {
                    // cell_hit = hit_in_cell(vec3(t, before, leave), cell, block, corner, ray, rays__start, seen__blocks__distances, seen__blocks__weights, seen__neighbors, seen__threshold)       <L 44>
                    var_233 = wp::vec_t<3, wp::float32>(var_53, var_67, var_229);
                    var_234 = hit_in_cell_0(var_233, var_65, var_68, var_100, var_18, var_rays__start, var_seen__blocks__distances, var_seen__blocks__weights, var_seen__neighbors, var_seen__threshold);
                    // hit = cell_hit[0]                                                          <L 45>
                    var_236 = wp::extract(var_234, var_235);
                    // after = cell_hit[1]                                                        <L 46>
                    var_238 = wp::extract(var_234, var_237);
                }
                var_239 = wp::where(var_232, var_236, var_59);
                var_240 = wp::where(var_232, var_238, var_230);
                // if hit == 0.0:                                                                 <L 47>
                var_242 = (var_239 == var_241);
                if (var_242) {
                    // before = after                                                             <L 48>
                    var_243 = wp::copy(var_240);
                    // t = leave                                                                  <L 49>
                    var_244 = wp::copy(var_229);
                    // cell = cell_beyond(t, vec3(tx, ty, tz), low, size, ahead, ray, rays__start)       <L 50>
                    var_245 = wp::vec_t<3, wp::float32>(var_200, var_213, var_226);
                    var_246 = cell_beyond_0(var_244, var_245, var_187, var_170, var_47, var_18, var_rays__start);
                    // dx = cell[0] - corner[0] >> 3                                              <L 51>
                    var_248 = wp::extract(var_246, var_247);
                    var_250 = wp::extract(var_100, var_249);
                    var_251 = wp::sub(var_248, var_250);
                    var_253 = wp::rshift(var_251, var_252);
                    // dy = cell[1] - corner[1] >> 3                                              <L 52>
                    var_255 = wp::extract(var_246, var_254);
                    var_257 = wp::extract(var_100, var_256);
                    var_258 = wp::sub(var_255, var_257);
                    var_260 = wp::rshift(var_258, var_259);
                    // dz = cell[2] - corner[2] >> 3                                              <L 53>
                    var_262 = wp::extract(var_246, var_261);
                    var_264 = wp::extract(var_100, var_263);
                    var_265 = wp::sub(var_262, var_264);
                    var_267 = wp::rshift(var_265, var_266);
                    // if dx | dy | dz != 0:                                                      <L 54>
                    var_268 = wp::bit_or(var_253, var_260);
                    var_269 = wp::bit_or(var_268, var_267);
                    var_271 = (var_269 != var_270);
                    if (var_271) {
                        // if block >= 0:                                                         <L 55>
                        var_273 = (var_68 >= var_272);
                        if (var_273) {
                            // block = seen__neighbors[block * AROUND + MIDDLE + 9 * dx + 3 * dy + dz]       <L 56>
                            var_275 = wp::mul(var_68, var_274);
                            var_277 = wp::add(var_275, var_276);
                            var_279 = wp::mul(var_278, var_253);
                            var_280 = wp::add(var_277, var_279);
                            var_282 = wp::mul(var_281, var_260);
                            var_283 = wp::add(var_280, var_282);
                            var_284 = wp::add(var_283, var_267);
                            var_285 = wp::address(var_seen__neighbors, var_284);
                            var_287 = wp::load(var_285);
                            var_286 = wp::copy(var_287);
                        }
                        if (!var_273) {
                            // block = block_at(cell, rays__base, seen__blocks__table__keys, seen__blocks__table__positions, seen__blocks__table__mask)       <L 58>
                            var_288 = block_at_0(var_246, var_rays__base, var_seen__blocks__table__keys, var_seen__blocks__table__positions, var_seen__blocks__table__mask);
                        }
                        var_289 = wp::where(var_273, var_286, var_288);
                        // corner = vec3i(corner[0] + dx * SIDE, corner[1] + dy * SIDE, corner[2] + dz * SIDE)       <L 59>
                        var_291 = wp::extract(var_100, var_290);
                        var_292 = wp::mul(var_253, var_74);
                        var_293 = wp::add(var_291, var_292);
                        var_295 = wp::extract(var_100, var_294);
                        var_296 = wp::mul(var_260, var_74);
                        var_297 = wp::add(var_295, var_296);
                        var_299 = wp::extract(var_100, var_298);
                        var_300 = wp::mul(var_267, var_74);
                        var_301 = wp::add(var_299, var_300);
                        var_302 = wp::vec_t<3, wp::int32>(var_293, var_297, var_301);
                        // parts = int(0)                                                         <L 60>
                        var_304 = wp::int(var_303);
                        // if block >= 0:                                                         <L 61>
                        var_306 = (var_289 >= var_305);
                        if (var_306) {
                            // parts = signs__parts[block]                                        <L 62>
                            var_307 = wp::address(var_signs__parts, var_289);
                            var_309 = wp::load(var_307);
                            var_308 = wp::copy(var_309);
                        }
                        var_310 = wp::where(var_306, var_308, var_304);
                    }
                    var_311 = wp::where(var_271, var_289, var_68);
                    var_312 = wp::where(var_271, var_302, var_100);
                    var_313 = wp::where(var_271, var_310, var_108);
                }
                var_314 = wp::where(var_242, var_244, var_53);
                var_315 = wp::where(var_242, var_246, var_65);
                var_316 = wp::where(var_242, var_243, var_67);
                var_317 = wp::where(var_242, var_311, var_68);
                var_318 = wp::where(var_242, var_312, var_100);
                var_319 = wp::where(var_242, var_313, var_108);
                wp::assign(var_53, var_314);
                wp::assign(var_59, var_239);
                wp::assign(var_61, var_116);
                wp::assign(var_65, var_315);
                wp::assign(var_67, var_316);
                wp::assign(var_68, var_317);
                wp::assign(var_100, var_318);
                wp::assign(var_108, var_319);
        goto start_while_1;
        end_while_1:;
            // met[pixel] = block                                                                 <L 63>
            wp::array_store(var_met, var_17, var_68);
        }
        // if hit > rays__farthest:                                                               <L 64>
        var_320 = (var_59 > var_rays__farthest);
        if (var_320) {
            // hit = 0.0                                                                          <L 65>
        }
        var_322 = wp::where(var_320, var_321, var_59);
        // depth[pixel] = hit                                                                     <L 66>
        wp::array_store(var_depth, var_17, var_322);
}

